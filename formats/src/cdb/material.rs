//! Composite materials: the table of a geocell (dataset 200) and the one inside a model descriptor.
//!
//! Source: OGC CDB 1.x Volume 1, "Material data" (Requirements 22–26, 128).

use super::metadata::MATERIAL_NAMESPACE;
use super::xml::{self, Element, comment};
use crate::{Error, Result};

const FORMAT: &str = "CDB composite material table";
const END_TAG: &str = "</Composite_Material_Table>";

/// The base material that a feature code suggests. Nothing measures what a photographed object is made of: assumed.
pub fn assumed(facc: &str) -> &'static str {
    match facc.get(..2) {
        Some("AL" | "AK" | "AM" | "AT") => "BM_CONCRETE",
        Some("EC") => "BM_FOLIAGE",
        _ => "BM_METAL-STEEL",
    }
}

/// One composite material made of a single base material.
pub fn entry(index: u32, base: &str) -> String {
    format!(
        "<Composite_Material index=\"{index}\"><Name>Assumed</Name><Primary_Substrate><Material><Name>{base}</Name>\
         <Weight>100</Weight></Material></Primary_Substrate></Composite_Material>"
    )
}

/// A geocell's table that holds `base`, and the index (≥ 1) of that material: an equal one that is there, or a new one
/// behind the others. `None` as text when nothing has to be written.
///
/// # Errors
/// [`Error::Malformed`] or [`Error::Unsupported`] for an existing table that cannot be extended.
pub fn table_with(existing: Option<&str>, base: &str, marking: &str) -> Result<(Option<String>, u32)> {
    let Some(text) = existing else {
        let table = format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{}\n<Composite_Material_Table xmlns=\"{MATERIAL_NAMESPACE}\" \
             version=\"1.0\">\n  {}\n{END_TAG}\n",
            comment(marking),
            entry(1, base)
        );
        return Ok((Some(table), 1));
    };
    let refuse = |what: String| Err(Error::Unsupported { format: FORMAT, what });
    let root = xml::parse(text)?;
    if root.local_name() != "Composite_Material_Table" {
        return refuse(format!("expected the root Composite_Material_Table, found {}", root.name));
    }
    let materials = || root.children_named("Composite_Material");
    let index = |m: &Element| m.attribute("index").and_then(|i| i.trim().parse::<u32>().ok());
    // Index 0 is reserved for tools.
    if let Some(i) = materials().filter(|m| is_single(m, base)).filter_map(index).find(|&i| i > 0) {
        return Ok((None, i));
    }
    let next = materials().filter_map(index).max().unwrap_or(0) + 1;
    // CMIX is a column of six digits.
    if next > 999_999 {
        return refuse(format!("index {next} does not fit CMIX; renumber the materials"));
    }
    let Some(at) = text.rfind(END_TAG) else {
        return refuse(format!("the table of {} does not end in {END_TAG}; write it without a prefix", root.name));
    };
    Ok((Some(format!("{}  {}\n{}", &text[..at], entry(next, base), &text[at..])), next))
}

/// The base materials that a composite material names.
pub fn base_names(material: &Element) -> impl Iterator<Item = &str> {
    let substrates = material.children.iter().filter(|c| c.local_name().ends_with("_Substrate"));
    substrates.flat_map(|s| s.children_named("Material")).filter_map(|m| m.child_text("Name"))
}

fn is_single(material: &Element, base: &str) -> bool {
    let plain = material.children.iter().all(|c| matches!(c.local_name(), "Name" | "Primary_Substrate"));
    let thick = material.child("Primary_Substrate").is_some_and(|s| s.child("Thickness").is_some());
    plain && !thick && base_names(material).eq([base])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_table_starts_at_one() {
        let (text, index) = table_with(None, "BM_CONCRETE", "CUI").unwrap();
        let text = text.unwrap();
        assert_eq!(index, 1);
        assert!(text.contains("<!-- CUI -->"));
        let root = xml::parse(&text).unwrap();
        assert_eq!(root.namespace(), Some(MATERIAL_NAMESPACE));
        let first = root.child("Composite_Material").unwrap();
        assert_eq!((first.attribute("index"), base_names(first).collect::<Vec<_>>()), (Some("1"), vec!["BM_CONCRETE"]));
    }

    #[test]
    fn an_equal_material_is_used_again_and_another_is_appended() {
        let (text, _) = table_with(None, "BM_CONCRETE", "CUI").unwrap();
        let text = text.unwrap();
        assert_eq!(table_with(Some(&text), "BM_CONCRETE", "SECRET").unwrap(), (None, 1));
        let (two, index) = table_with(Some(&text), "BM_METAL-STEEL", "SECRET").unwrap();
        let two = two.unwrap();
        assert_eq!(index, 2);
        assert!(two.starts_with(text.strip_suffix("</Composite_Material_Table>\n").unwrap()));
        assert_eq!(table_with(Some(&two), "BM_METAL-STEEL", "").unwrap(), (None, 2));
    }

    #[test]
    fn foreign_tables_keep_their_materials() {
        let layered = "<Composite_Material_Table version=\"1.0\"><Composite_Material index=\"7\"><Surface_Substrate>\
                       <Material><Name>BM_SNOW</Name></Material></Surface_Substrate><Primary_Substrate><Material><Name>\
                       BM_CONCRETE</Name></Material></Primary_Substrate></Composite_Material></Composite_Material_Table>";
        let (text, index) = table_with(Some(layered), "BM_CONCRETE", "").unwrap();
        assert_eq!(index, 8, "a layered material is another material");
        assert_eq!(xml::parse(&text.unwrap()).unwrap().children.len(), 2);
        for wrong in ["<a/>", "<x:Composite_Material_Table/>", "<Composite_Material_Table>"] {
            assert!(table_with(Some(wrong), "BM_CONCRETE", "").is_err(), "{wrong}");
        }
    }
}
