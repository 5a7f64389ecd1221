//! Model descriptors (datasets 303, 503, 603): the metadata of a model.
//!
//! Source: OGC CDB 1.x Volume 6, §6.14 "Model descriptor" (Requirement 129 of Volume 1). Only elements that the 1.0 schema
//! knows are written.

use super::dis::EntityType;
use super::material::{self, Material};
use super::metadata::DESCRIPTOR_NAMESPACE;
use super::xml::{self, comment, escape};
use crate::{Error, Result};

/// A texture as the descriptor tells of it.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureEntry {
    /// TNAM.
    pub name: String,
    /// Mip levels that exist, by the power of two of their larger side: (0, 10) is the whole chain of 1024.
    pub mipmap: (u32, u32),
    /// Texels a metre.
    pub resolution: f64,
}

/// What kind of thing the model shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Identification {
    Feature { facc: String, fsc: u16 },
    Entity(EntityType),
}

/// What a descriptor says, as far as Orb writes and checks it.
#[derive(Clone, Debug, PartialEq)]
pub struct Descriptor {
    pub name: String,
    pub identification: Identification,
    pub textures: Vec<TextureEntry>,
    /// Index and base materials of each composite material.
    pub materials: Vec<(u32, Vec<String>)>,
}

/// Writes a descriptor with the one composite material 1; the textures are of `dataset`.
pub fn write(
    name: &str,
    identification: &Identification,
    (dataset, textures): (u16, &[TextureEntry]),
    material: &Material,
    marking: &str,
) -> String {
    let textures: String = textures
        .iter()
        .map(|t| {
            format!(
                "    <Texture name=\"{}\"><Dataset>{dataset}</Dataset><Kind>1</Kind><Index>1</Index><Mipmap>{} {}</Mipmap>\
                 <Resolution>{}</Resolution></Texture>\n",
                escape(&t.name),
                t.mipmap.0,
                t.mipmap.1,
                t.resolution
            )
        })
        .collect();
    let identification = match identification {
        Identification::Feature { facc, fsc } => format!(
            "<Feature_Attribute_Catalog_Code><Code>{facc}</Code><Subcode>{fsc}</Subcode></Feature_Attribute_Catalog_Code>"
        ),
        Identification::Entity(e) => {
            let numbers = e.numbers().into_iter().zip(ENTITY_FIELDS);
            let fields: String = numbers.map(|(n, name)| format!("<{name}>{n}</{name}>")).collect();
            format!("<DIS_Entity_Type>{fields}</DIS_Entity_Type>")
        }
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{}\n<Model_Metadata xmlns=\"{DESCRIPTOR_NAMESPACE}\">\n  \
         <Name>{}</Name>\n  <Identification>{identification}</Identification>\n  <Textures>\n{textures}  </Textures>\n  \
         <Composite_Material_Table>{}</Composite_Material_Table>\n</Model_Metadata>\n",
        comment(marking),
        escape(name),
        material.element(1)
    )
}

const ENTITY_FIELDS: [&str; 7] = ["Kind", "Domain", "Country", "Category", "Subcategory", "Specific", "Extra"];

/// Reads a descriptor.
///
/// # Errors
/// [`Error::Malformed`] for XML that is not well-formed, [`Error::Unsupported`] for one that is no descriptor.
pub fn read(text: &str) -> Result<Descriptor> {
    let root = xml::parse(text)?;
    if root.local_name() != "Model_Metadata" || root.namespace() != Some(DESCRIPTOR_NAMESPACE) {
        return Err(refuse(format!("expected Model_Metadata in namespace CDB, found {}", root.name)));
    }
    let mut out = Descriptor {
        name: root.child_text("Name").unwrap_or_default().into(),
        identification: identification(&root)?,
        textures: Vec::new(),
        materials: Vec::new(),
    };
    for texture in root.child("Textures").iter().flat_map(|t| t.children_named("Texture")) {
        let name = texture.attribute("name").unwrap_or_default().to_string();
        let mips: Vec<u32> = texture
            .child_text("Mipmap")
            .unwrap_or_default()
            .split_whitespace()
            .filter_map(|n| n.parse().ok())
            .collect();
        let resolution = texture.child_text("Resolution").and_then(|r| r.parse().ok());
        let (&[low, high], Some(resolution)) = (&mips[..], resolution) else {
            return Err(refuse(format!("texture {name} needs Mipmap (two integers) and Resolution (a number)")));
        };
        out.textures.push(TextureEntry { name, mipmap: (low, high), resolution });
    }
    for material in root.child("Composite_Material_Table").iter().flat_map(|t| t.children_named("Composite_Material")) {
        let index = material.attribute("index").and_then(|i| i.parse().ok());
        let index = index.ok_or_else(|| refuse("a Composite_Material has no index".into()))?;
        out.materials.push((index, material::base_names(material).map(String::from).collect()));
    }
    Ok(out)
}

fn identification(root: &xml::Element) -> Result<Identification> {
    let Some(element) = root.child("Identification") else { return Err(refuse("there is no Identification".into())) };
    if let Some(code) = element.child("Feature_Attribute_Catalog_Code") {
        let fsc = code.child_text("Subcode").map_or(Ok(0), str::parse).map_err(|e| refuse(format!("Subcode: {e}")))?;
        return Ok(Identification::Feature { facc: code.child_text("Code").unwrap_or_default().into(), fsc });
    }
    let Some(entity) = element.child("DIS_Entity_Type") else {
        return Err(refuse("Identification names no Feature_Attribute_Catalog_Code and no DIS_Entity_Type".into()));
    };
    // Up to seven numbers in one list, or an element each.
    let numbers = match entity.child_text("List") {
        Some(list) => list.split_whitespace().collect::<Vec<_>>().join("."),
        None => ENTITY_FIELDS.map(|f| entity.child_text(f).unwrap_or("0")).join("."),
    };
    EntityType::parse(&numbers).map(Identification::Entity)
}

fn refuse(what: String) -> Error {
    Error::Unsupported { format: "CDB model descriptor", what }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn feature() -> Identification {
        Identification::Feature { facc: "UA005".into(), fsc: 0 }
    }

    fn steel() -> Material {
        Material::assumed("UA005")
    }

    #[test]
    fn what_is_written_reads_back() {
        let textures = [
            TextureEntry { name: "OrbVan_0".into(), mipmap: (0, 10), resolution: 123.457 },
            TextureEntry { name: "OrbVan_0_tile".into(), mipmap: (7, 7), resolution: 15.0 },
        ];
        for identification in [feature(), Identification::Entity(EntityType::parse("1.1.225.1.1.8.3").unwrap())] {
            let text = write("Van <1>", &identification, (301, &textures), &steel(), "SECRET");
            assert!(text.contains("<!-- SECRET -->"));
            let expected = Descriptor {
                name: "Van <1>".into(),
                identification,
                textures: textures.to_vec(),
                materials: vec![(1, vec!["BM_METAL-STEEL".into()])],
            };
            assert_eq!(read(&text), Ok(expected));
        }
    }

    #[test]
    fn entity_types_are_read_as_lists_too() {
        let text = "<Model_Metadata xmlns=\"CDB\"><Identification><DIS_Entity_Type><List>1 1 225 1</List></DIS_Entity_Type>\
                    </Identification></Model_Metadata>";
        let expected = Identification::Entity(EntityType::parse("1.1.225.1").unwrap());
        assert_eq!(read(text).unwrap().identification, expected);
        assert!(read(&text.replace("225 1", "many")).is_err());
    }

    #[test]
    fn what_is_no_descriptor_is_refused() {
        let good = write("Van", &feature(), (301, &[]), &steel(), "");
        for (from, to) in [
            ("<Code>UA005</Code><Subcode>0", "<Code>UA005</Code><Subcode>x"),
            ("Identification>", "Identity>"),
            ("xmlns=\"CDB\"", "xmlns=\"cdb\""),
            ("index=\"1\"", "index=\"one\""),
            ("</Textures>", "<Texture name=\"a\"><Mipmap>1</Mipmap></Texture></Textures>"),
        ] {
            assert!(read(&good.replace(from, to)).is_err(), "{to}");
        }
    }
}
