//! The little XML that metadata needs: text escaped on the way out, a tree on the way in.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use crate::{Error, Result};

const FORMAT: &str = "XML";
/// Deeper nesting is refused: no file that Orb reads comes near.
const MAX_DEPTH: usize = 64;

/// An element: name as written (with its prefix), attributes, children, and the text directly inside.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Element {
    pub name: String,
    pub attributes: Vec<(String, String)>,
    pub children: Vec<Element>,
    pub text: String,
}

impl Element {
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(n, _)| n == name).map(|(_, v)| v.as_str())
    }

    /// The name without its prefix.
    pub fn local_name(&self) -> &str {
        self.name.rsplit(':').next().unwrap_or_default()
    }

    /// The first child of this local name.
    pub fn child(&self, name: &str) -> Option<&Element> {
        self.children.iter().find(|c| c.local_name() == name)
    }

    pub fn children_named<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Element> {
        self.children.iter().filter(move |c| c.local_name() == name)
    }

    /// The trimmed text of the first child of this name.
    pub fn child_text(&self, name: &str) -> Option<&str> {
        self.child(name).map(|c| c.text.trim())
    }

    /// The namespace that this element itself declares for its name.
    pub fn namespace(&self) -> Option<&str> {
        match self.name.split_once(':') {
            Some((prefix, _)) => self.attribute(&format!("xmlns:{prefix}")),
            None => self.attribute("xmlns"),
        }
    }
}

/// Escapes text for element content and attribute values; characters that XML 1.0 cannot hold become a space.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\u{0}'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// A comment; `--` cannot stand in one and is spaced out.
pub fn comment(text: &str) -> String {
    let text = escape(text).replace("--", "- -").replace("--", "- -");
    format!("<!-- {} -->", text.trim_end_matches('-'))
}

/// Reads a document.
///
/// # Errors
/// [`Error::Malformed`] at the first place that is not well-formed. Entities other than XML's own five are refused.
pub fn parse(text: &str) -> Result<Element> {
    let mut reader = Reader::from_str(text.trim_start_matches('\u{feff}'));
    let mut open: Vec<Element> = Vec::new();
    let mut root = None;
    loop {
        let at = reader.buffer_position();
        let fault = |found: String| malformed(at, "well-formed XML", found);
        match reader.read_event().map_err(|e| fault(e.to_string()))? {
            Event::Start(tag) if open.len() < MAX_DEPTH => open.push(element(&tag).map_err(fault)?),
            Event::Start(_) => return Err(fault(format!("more than {MAX_DEPTH} nested elements"))),
            Event::Empty(tag) => close(element(&tag).map_err(fault)?, &mut open, &mut root, at)?,
            Event::End(_) => match open.pop() {
                Some(done) => close(done, &mut open, &mut root, at)?,
                None => return Err(fault("an end tag without its start".into())),
            },
            Event::Text(t) => push_text(&t.xml10_content(), &mut open).map_err(fault)?,
            Event::CData(t) => push_text(&t.xml10_content(), &mut open).map_err(fault)?,
            Event::GeneralRef(r) => {
                let named = || quick_xml::escape::resolve_predefined_entity(&r).map(str::to_string);
                let char_ref = r.resolve_char_ref().map_err(|e| fault(e.to_string()))?;
                let value = char_ref.map(String::from).or_else(named);
                push_text(&value.ok_or_else(|| fault(format!("the entity &{};", &*r)))?, &mut open).map_err(fault)?;
            }
            Event::Eof => break,
            Event::Comment(_) | Event::Decl(_) | Event::PI(_) | Event::DocType(_) => {}
        }
    }
    match (root, open.pop()) {
        (Some(root), None) => Ok(root),
        (_, Some(e)) => Err(malformed(text.len() as u64, &format!("the end of <{}>", e.name), "the end".into())),
        (None, None) => Err(malformed(0, "an element", "none".into())),
    }
}

fn element(tag: &BytesStart) -> Result<Element, String> {
    let name = tag.name().as_ref().to_string();
    let mut attributes = Vec::new();
    for attribute in tag.attributes() {
        let attribute = attribute.map_err(|e| e.to_string())?;
        let value = attribute.normalized_value(quick_xml::XmlVersion::Implicit1_0).map_err(|e| e.to_string())?;
        attributes.push((attribute.key.as_ref().to_string(), value.into_owned()));
    }
    Ok(Element { name, attributes, ..Element::default() })
}

fn close(done: Element, open: &mut [Element], root: &mut Option<Element>, at: u64) -> Result<()> {
    match (open.last_mut(), &root) {
        (Some(parent), _) => parent.children.push(done),
        (None, None) => *root = Some(done),
        (None, Some(_)) => return Err(malformed(at, "one root element", format!("a second one, <{}>", done.name))),
    }
    Ok(())
}

fn push_text(text: &str, open: &mut [Element]) -> Result<(), String> {
    match open.last_mut() {
        Some(element) => element.text.push_str(text),
        None if text.trim().is_empty() => {}
        None => return Err("text outside the root element".into()),
    }
    Ok(())
}

fn malformed(at: u64, expected: &str, found: String) -> Error {
    Error::Malformed { format: FORMAT, offset: at, expected: expected.into(), found }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_document_becomes_a_tree() {
        let text =
            "<?xml version=\"1.0\"?><!-- c --><a xmlns='urn:x' k='1 &lt; 2'><p:b> x &amp; &#65; </p:b><c/></a>\n";
        let a = parse(text).unwrap();
        assert_eq!((a.namespace(), a.attribute("k")), (Some("urn:x"), Some("1 < 2")));
        assert_eq!((a.child_text("b"), a.child("c").is_some()), (Some("x & A"), true));
    }

    #[test]
    fn what_is_not_well_formed_is_refused() {
        for text in
            ["", "x", "<a>", "<a></b>", "<a/><b/>", "</a>", "<a>&bomb;</a>", "<a k=1/>", "<a/>x", "<a k='1' k='2'/>"]
        {
            assert!(matches!(parse(text), Err(Error::Malformed { .. })), "{text}");
        }
        assert!(parse(&"<a>".repeat(1000)).is_err());
    }

    proptest! {
        #[test]
        fn any_text_survives_escaping(text in "\\PC{0,40}") {
            let back = parse(&format!("{}<a k=\"{}\">{}</a>", comment(&text), escape(&text), escape(&text))).unwrap();
            prop_assert_eq!(&back.text, &text);
            prop_assert_eq!(back.attribute("k"), Some(text.as_str()));
        }
    }

    #[test]
    fn comments_stay_comments() {
        for text in ["a--b", "---", "-", "a-->b", "----", "\u{1}"] {
            assert!(parse(&format!("{}<a/>", comment(text))).is_ok(), "{text}");
        }
    }
}
