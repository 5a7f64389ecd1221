//! Model descriptors (dataset 303): the metadata of one geometry level.
//!
//! Source: OGC CDB 1.x Volume 6, §6.14 "Model descriptor" (Requirement 129 of Volume 1). Only elements that the 1.0 schema
//! knows are written.

use super::material;
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

/// What a descriptor says, as far as Orb writes and checks it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Descriptor {
    pub name: String,
    pub facc: String,
    pub fsc: u16,
    pub textures: Vec<TextureEntry>,
    /// Index and base materials of each composite material.
    pub materials: Vec<(u32, Vec<String>)>,
}

/// Writes a descriptor with the one composite material 1, of `base`.
pub fn write(name: &str, facc: &str, fsc: u16, textures: &[TextureEntry], base: &str, marking: &str) -> String {
    let textures: String = textures
        .iter()
        .map(|t| {
            format!(
                "    <Texture name=\"{}\"><Dataset>301</Dataset><Kind>1</Kind><Index>1</Index><Mipmap>{} {}</Mipmap>\
                 <Resolution>{}</Resolution></Texture>\n",
                escape(&t.name),
                t.mipmap.0,
                t.mipmap.1,
                t.resolution
            )
        })
        .collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{}\n<Model_Metadata xmlns=\"{DESCRIPTOR_NAMESPACE}\">\n  \
         <Name>{}</Name>\n  <Identification><Feature_Attribute_Catalog_Code><Code>{facc}</Code><Subcode>{fsc}</Subcode>\
         </Feature_Attribute_Catalog_Code></Identification>\n  <Textures>\n{textures}  </Textures>\n  \
         <Composite_Material_Table>{}</Composite_Material_Table>\n</Model_Metadata>\n",
        comment(marking),
        escape(name),
        material::entry(1, base)
    )
}

/// Reads a descriptor.
///
/// # Errors
/// [`Error::Malformed`] for XML that is not well-formed, [`Error::Unsupported`] for one that is no descriptor.
pub fn read(text: &str) -> Result<Descriptor> {
    let refuse = |what: String| Error::Unsupported { format: "CDB model descriptor", what };
    let root = xml::parse(text)?;
    if root.local_name() != "Model_Metadata" || root.namespace() != Some(DESCRIPTOR_NAMESPACE) {
        return Err(refuse(format!("expected Model_Metadata in namespace CDB, found {}", root.name)));
    }
    let Some(code) = root.child("Identification").and_then(|i| i.child("Feature_Attribute_Catalog_Code")) else {
        return Err(refuse("Identification names no Feature_Attribute_Catalog_Code".into()));
    };
    let mut out = Descriptor {
        name: root.child_text("Name").unwrap_or_default().into(),
        facc: code.child_text("Code").unwrap_or_default().into(),
        fsc: code.child_text("Subcode").map_or(Ok(0), str::parse).map_err(|e| refuse(format!("Subcode: {e}")))?,
        ..Descriptor::default()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        let textures = [
            TextureEntry { name: "OrbVan_0".into(), mipmap: (0, 10), resolution: 123.457 },
            TextureEntry { name: "OrbVan_0_tile".into(), mipmap: (7, 7), resolution: 15.0 },
        ];
        let text = write("Van <1>", "UA005", 0, &textures, "BM_METAL-STEEL", "SECRET");
        assert!(text.contains("<!-- SECRET -->"));
        let expected = Descriptor {
            name: "Van <1>".into(),
            facc: "UA005".into(),
            fsc: 0,
            textures: textures.into(),
            materials: vec![(1, vec!["BM_METAL-STEEL".into()])],
        };
        assert_eq!(read(&text), Ok(expected));
    }

    #[test]
    fn what_is_no_descriptor_is_refused() {
        let good = write("Van", "UA005", 0, &[], "BM_METAL-STEEL", "");
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
