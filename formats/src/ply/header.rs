//! The PLY header: encoding, comments, elements and their properties.

use super::{REST, malformed};
use crate::Result;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Kind {
    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes in a binary file.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    pub name: String,
    pub kind: Kind,
    /// The type of the count before the values, of a list.
    pub list: Option<Kind>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<Property>,
    /// Where its header line begins.
    pub offset: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Header {
    pub encoding: Encoding,
    pub comments: Vec<String>,
    pub elements: Vec<Element>,
    /// Where the data begin.
    pub end: usize,
}

impl Header {
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        let mut at = 0;
        let (first, next) = line(bytes, at)?;
        if first != "ply" {
            return malformed(0, "the first line to be ply".into(), format!("{:?}", shorten(&first)));
        }
        at = next;
        let mut encoding = None;
        let mut comments = Vec::new();
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let (text, next) = line(bytes, at)?;
            let words: Vec<&str> = text.split_ascii_whitespace().collect();
            let wrong = |expected: &str| malformed(at, expected.into(), format!("{:?}", shorten(&text)));
            match words[..] {
                ["comment", ..] => {
                    let rest = &text[text.find("comment").unwrap_or(0) + "comment".len()..];
                    comments.push(rest.strip_prefix(' ').unwrap_or(rest).to_owned());
                }
                ["obj_info", ..] | [] => {}
                ["format", name, _version] => {
                    encoding = Some(match name {
                        "ascii" => Encoding::Ascii,
                        "binary_little_endian" => Encoding::LittleEndian,
                        "binary_big_endian" => Encoding::BigEndian,
                        _ => return wrong("format ascii, binary_little_endian or binary_big_endian"),
                    });
                }
                ["element", name, count] => {
                    let Ok(count) = count.parse() else { return wrong("the number of elements") };
                    elements.push(Element { name: name.into(), count, properties: Vec::new(), offset: at });
                }
                ["property", "list", count, kind, name] => {
                    let (Some(list), Some(kind)) = (Kind::of(count), Kind::of(kind)) else {
                        return wrong("the types of a list property");
                    };
                    let Some(element) = elements.last_mut() else { return wrong("an element before this property") };
                    element.properties.push(Property { name: name.into(), kind, list: Some(list) });
                }
                ["property", kind, name] => {
                    let Some(kind) = Kind::of(kind) else { return wrong("the type of a property") };
                    let Some(element) = elements.last_mut() else { return wrong("an element before this property") };
                    element.properties.push(Property { name: name.into(), kind, list: None });
                }
                ["end_header"] => {
                    let Some(encoding) = encoding else { return wrong("a format line before the end of the header") };
                    return Ok(Self { encoding, comments, elements, end: next });
                }
                _ => return wrong("format, comment, element, property or end_header"),
            }
            at = next;
        }
    }
}

/// The line that begins at `at`, without its end (LF or CR LF), and where the next one begins.
fn line(bytes: &[u8], at: usize) -> Result<(String, usize)> {
    let Some(length) = bytes[at..].iter().position(|&b| b == b'\n') else {
        return malformed(bytes.len(), "a header line".into(), "the end of the file".into());
    };
    let text = bytes[at..at + length].strip_suffix(b"\r").unwrap_or(&bytes[at..at + length]);
    Ok((String::from_utf8_lossy(text).into_owned(), at + length + 1))
}

fn shorten(text: &str) -> String {
    text.chars().take(80).collect()
}

/// The header of splats as written.
pub fn of_splats(count: usize, comments: &[String]) -> String {
    let mut head = String::from("ply\nformat binary_little_endian 1.0\n");
    for comment in comments {
        head += &format!("comment {comment}\n");
    }
    head += &format!("element vertex {count}\n");
    let mut property = |name: &str| head += &format!("property float {name}\n");
    ["x", "y", "z", "nx", "ny", "nz"].into_iter().for_each(&mut property);
    (0..3).for_each(|i| property(&format!("f_dc_{i}")));
    (0..REST).for_each(|i| property(&format!("f_rest_{i}")));
    property("opacity");
    (0..3).for_each(|i| property(&format!("scale_{i}")));
    (0..4).for_each(|i| property(&format!("rot_{i}")));
    head + "end_header\n"
}
