//! Composite materials: what a model is made of, the table of a geocell (dataset 200) and the one inside a descriptor.
//!
//! Source: OGC CDB 1.x Volume 1, "Material data" (Requirements 22–26, 128).

use super::metadata::MATERIAL_NAMESPACE;
use super::xml::{self, Element, comment};
use crate::{Error, Result};

const FORMAT: &str = "CDB composite material table";
const END_TAG: &str = "</Composite_Material_Table>";

/// A composite material: layers of weighted base materials.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Material {
    /// What its name in the tables says of where it comes from.
    pub name: String,
    /// From the surface inwards; one layer is the primary substrate, of more the first is the surface.
    pub layers: Vec<Vec<Base>>,
}

/// A base material's share of a layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Base {
    /// `BM_…`.
    pub name: String,
    /// Percent.
    pub weight: u8,
}

impl Material {
    /// What a feature code suggests. Nothing measures what a photographed object is made of: assumed.
    pub fn assumed(facc: &str) -> Material {
        let base = match facc.get(..2) {
            Some("AL" | "AK" | "AM" | "AT") => "BM_CONCRETE",
            Some("EC") => "BM_FOLIAGE",
            _ => "BM_METAL-STEEL",
        };
        Material { name: "Assumed".into(), layers: vec![vec![Base { name: base.into(), weight: 100 }]] }
    }

    /// `metal-steel`, `brick:70+glass:30`, `paint/metal-steel`: base materials joined by `+` with their percentages, layers
    /// separated by `/` from the surface inwards. `BM_` and capitals may be left out.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for names outside the standard's alphabet, percentages that do not sum to 100, and more than
    /// eight layers.
    pub fn parse(text: &str) -> Result<Material> {
        let refuse = |what: String| Error::Unsupported {
            format: "CDB material",
            what: format!("{what} in {text:?}; write metal-steel, brick:70+glass:30 or paint/metal-steel"),
        };
        let mut layers = Vec::new();
        for layer in text.split('/') {
            let parts: Vec<&str> = layer.split('+').collect();
            let mut bases = Vec::new();
            for part in &parts {
                let (name, weight) = match part.split_once(':') {
                    Some((name, weight)) => (name, weight.trim().parse().ok()),
                    None => (*part, (parts.len() == 1).then_some(100)),
                };
                let name = name.trim().to_ascii_uppercase();
                let name = if name.starts_with("BM_") { name } else { format!("BM_{name}") };
                if !is_base_name(&name) {
                    return Err(refuse(format!("{name} is no name of a base material")));
                }
                let weight = weight.filter(|w| (1..=100).contains(w));
                let weight = weight.ok_or_else(|| refuse(format!("{name} needs a percentage from 1 to 100")))?;
                bases.push(Base { name, weight });
            }
            let sum: u32 = bases.iter().map(|b| u32::from(b.weight)).sum();
            if sum != 100 {
                return Err(refuse(format!("the percentages of {layer} sum to {sum}, expected 100")));
            }
            // Weights stand in descending order.
            bases.sort_by(|a, b| b.weight.cmp(&a.weight).then_with(|| a.name.cmp(&b.name)));
            layers.push(bases);
        }
        if layers.len() > 8 {
            return Err(refuse(format!("{} layers, at most 8 are taken", layers.len())));
        }
        Ok(Material { name: "Given".into(), layers })
    }

    /// The base materials, from the surface inwards, as one text.
    pub fn summary(&self) -> String {
        let layer = |bases: &Vec<Base>| match &bases[..] {
            [one] => one.name.clone(),
            more => more.iter().map(|b| format!("{}:{}", b.name, b.weight)).collect::<Vec<_>>().join("+"),
        };
        self.layers.iter().map(layer).collect::<Vec<_>>().join("/")
    }

    /// Its element under an index.
    pub fn element(&self, index: u32) -> String {
        let mut out = format!("<Composite_Material index=\"{index}\"><Name>{}</Name>", xml::escape(&self.name));
        let surfaced = self.layers.len() > 1;
        for (i, layer) in self.layers.iter().enumerate() {
            let role = match (i, surfaced) {
                (0, true) => "Surface_Substrate",
                (0, false) | (1, true) => "Primary_Substrate",
                _ => "Secondary_Substrate",
            };
            let bases = layer
                .iter()
                .map(|b| format!("<Material><Name>{}</Name><Weight>{}</Weight></Material>", b.name, b.weight));
            out += &format!("<{role}>{}</{role}>", bases.collect::<String>());
        }
        out + "</Composite_Material>"
    }

    /// The layers of an element of any table; `None` where it tells more, or less, than is kept here.
    fn read(element: &Element) -> Option<Vec<Vec<Base>>> {
        let substrates = element.children.iter().filter(|c| c.local_name() != "Name");
        let order = ["Surface_Substrate", "Primary_Substrate", "Secondary_Substrate"];
        let mut last = 0;
        let layers = substrates.map(|s| {
            let role = order.iter().position(|o| *o == s.local_name()).filter(|r| *r >= last)?;
            last = role;
            let base = |m: &Element| {
                let weight = m.child_text("Weight").map_or(Some(100), |w| w.parse().ok())?;
                (m.local_name() == "Material").then_some(Base { name: m.child_text("Name")?.into(), weight })
            };
            s.children.iter().map(base).collect::<Option<Vec<_>>>()
        });
        let layers: Vec<_> = layers.collect::<Option<_>>()?;
        let surfaced = element.child("Surface_Substrate").is_some();
        (surfaced == (layers.len() > 1)).then_some(layers)
    }
}

/// `BM_` and letters, digits, `_`, `-`; 32 characters at most (Requirement 23).
pub fn is_base_name(name: &str) -> bool {
    let rest = name.strip_prefix("BM_").unwrap_or_default();
    (1..=29).contains(&rest.len()) && rest.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-')
}

/// A geocell's table that holds a material, and the index (≥ 1) of that material: an equal one that is there, or a new one
/// behind the others. `None` as text when nothing has to be written.
///
/// # Errors
/// [`Error::Malformed`] or [`Error::Unsupported`] for an existing table that cannot be extended.
pub fn table_with(existing: Option<&str>, material: &Material, marking: &str) -> Result<(Option<String>, u32)> {
    let Some(text) = existing else {
        let table = format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{}\n<Composite_Material_Table xmlns=\"{MATERIAL_NAMESPACE}\" \
             version=\"1.0\">\n  {}\n{END_TAG}\n",
            comment(marking),
            material.element(1)
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
    let same = |m: &&Element| Material::read(m).is_some_and(|layers| layers == material.layers);
    // Index 0 is reserved for tools.
    if let Some(i) = materials().filter(same).filter_map(index).find(|&i| i > 0) {
        return Ok((None, i));
    }
    let next = materials().filter_map(index).max().unwrap_or(0).saturating_add(1);
    // CMIX is a column of six digits.
    if next > 999_999 {
        return refuse(format!("index {next} does not fit CMIX; renumber the materials"));
    }
    let Some(at) = text.rfind(END_TAG) else {
        return refuse(format!("the table of {} does not end in {END_TAG}; write it without a prefix", root.name));
    };
    Ok((Some(format!("{}  {}\n{}", &text[..at], material.element(next), &text[at..])), next))
}

/// The base materials that a composite material names.
pub fn base_names(material: &Element) -> impl Iterator<Item = &str> {
    let substrates = material.children.iter().filter(|c| c.local_name().ends_with("_Substrate"));
    substrates.flat_map(|s| s.children_named("Material")).filter_map(|m| m.child_text("Name"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn given(text: &str) -> Material {
        Material::parse(text).unwrap()
    }

    #[test]
    fn materials_are_read_from_a_line() {
        assert_eq!(given("metal-steel").layers, Material::assumed("UA005").layers);
        assert_eq!(given("bm_glass:30 + BRICK:70").summary(), "BM_BRICK:70+BM_GLASS:30");
        let painted = given("paint/metal-steel");
        let element = xml::parse(&painted.element(3)).unwrap();
        let roles: Vec<&str> = element.children.iter().map(Element::local_name).collect();
        assert_eq!(roles, ["Name", "Surface_Substrate", "Primary_Substrate"]);
        assert_eq!(Material::read(&element), Some(painted.layers));
        let walls = given("paint/brick/drywall");
        assert_eq!(Material::read(&xml::parse(&walls.element(1)).unwrap()), Some(walls.layers.clone()));
        assert!(walls.element(1).contains("<Secondary_Substrate><Material><Name>BM_DRYWALL"));
        for wrong in
            ["", "me tal", "brick:70", "brick+glass", "brick:0+glass:100", "a/b/c/d/e/f/g/h/i", "<x>", "brick:x"]
        {
            assert!(Material::parse(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_new_table_starts_at_one() {
        let (text, index) = table_with(None, &given("concrete"), "CUI").unwrap();
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
        let (text, _) = table_with(None, &given("concrete"), "CUI").unwrap();
        let text = text.unwrap();
        assert_eq!(table_with(Some(&text), &given("concrete"), "SECRET").unwrap(), (None, 1));
        let (two, index) = table_with(Some(&text), &given("paint/metal-steel"), "SECRET").unwrap();
        let two = two.unwrap();
        assert_eq!(index, 2);
        assert!(two.starts_with(text.strip_suffix("</Composite_Material_Table>\n").unwrap()));
        assert_eq!(table_with(Some(&two), &given("paint/metal-steel"), "").unwrap(), (None, 2));
        assert_eq!(table_with(Some(&two), &given("metal-steel"), "").unwrap().1, 3);
    }

    #[test]
    fn foreign_tables_keep_their_materials() {
        let layered = "<Composite_Material_Table version=\"1.0\"><Composite_Material index=\"7\"><Surface_Substrate>\
                       <Material><Name>BM_SNOW</Name></Material></Surface_Substrate><Primary_Substrate><Material><Name>\
                       BM_CONCRETE</Name></Material></Primary_Substrate></Composite_Material></Composite_Material_Table>";
        let (text, index) = table_with(Some(layered), &given("concrete"), "").unwrap();
        assert_eq!(index, 8, "a layered material is another material");
        assert_eq!(xml::parse(&text.unwrap()).unwrap().children.len(), 2);
        assert_eq!(table_with(Some(layered), &given("snow/concrete"), "").unwrap(), (None, 7));
        let full = layered.replace("index=\"7\"", "index=\"4294967295\"");
        assert!(table_with(Some(&full), &given("concrete"), "").is_err(), "no index is left");
        let thick = layered.replace("</Material></Primary", "</Material><Thickness>2</Thickness></Primary");
        assert_eq!(table_with(Some(&thick), &given("snow/concrete"), "").unwrap().1, 8);
        for wrong in ["<a/>", "<x:Composite_Material_Table/>", "<Composite_Material_Table>"] {
            assert!(table_with(Some(wrong), &given("concrete"), "").is_err(), "{wrong}");
        }
    }
}
