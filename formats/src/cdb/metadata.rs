//! The Metadata folder of a new CDB: `Version.xml` and the schemas that a store carries.
//!
//! Source: OGC CDB 1.x Volume 1, §5.1 "Version metadata" (Requirement 74). The schemas are Orb's own: real for the files
//! that Orb writes, an empty declaration of the namespace for the others.

use super::store::{self, Store};
use super::xml::{self, comment, escape};
use crate::{Error, File, Result};

pub const VERSION_XML: &str = "Metadata/Version.xml";
pub const CONFIGURATION_XML: &str = "Metadata/Configuration.xml";
/// Most versions in a chain for run time (Volume 1, Requirement 38).
pub const MAX_VERSIONS: usize = 8;
pub const VERSION_NAMESPACE: &str = "http://www.opengis.net/cdb/1.0/Version";
pub const MATERIAL_NAMESPACE: &str = "http://www.opengis.net/cdb/1.0/Composite_Material_Table";
/// The namespace of model descriptors, literally so in the 1.0 schema.
pub const DESCRIPTOR_NAMESPACE: &str = "CDB";

/// Folders of a new store that hold no file yet.
pub const EMPTY_FOLDERS: [&str; 4] = ["GTModel", "MModel", "Navigation", "Metadata/Stylesheet"];

/// The fourteen schemas that a store is expected to carry, and the namespace of each.
pub const SCHEMAS: [(&str, &str); 14] = [
    ("Base_Material_Table", "http://www.opengis.net/cdb/1.0/Base_Material_Table"),
    ("Composite_Material_Table", MATERIAL_NAMESPACE),
    ("Configuration", "http://www.opengis.net/cdb/1.0/Configuration"),
    ("DIS_Country_Codes", "http://www.opengis.net/cdb/1.0/DIS_Country_Codes"),
    ("Defaults", "http://www.opengis.net/cdb/1.0/Defaults"),
    ("Feature_Data_Dictionary", "http://www.opengis.net/cdb/1.0/Feature_Data_Dictionary"),
    ("Lights", "http://www.opengis.net/cdb/1.0/Lights"),
    ("Lights_Tuning", "http://www.opengis.net/cdb/1.0/Lights_Tuning"),
    ("Model_Components", DESCRIPTOR_NAMESPACE),
    ("Model_Metadata", DESCRIPTOR_NAMESPACE),
    ("Moving_Model_Codes", "http://www.opengis.net/cdb/1.0/Moving_Model_Codes"),
    ("OpenFlight_Model_Extensions", DESCRIPTOR_NAMESPACE),
    ("Vector_Attributes", "http://www.opengis.net/cdb/1.0/Vector_Attributes"),
    ("Version", VERSION_NAMESPACE),
];

/// `Version.xml` of a store that claims CDB 1.0; the marking leads its comment. `previous`: the root of the version that
/// it continues, seen from its own.
pub fn version_xml(marking: &str, text: &str, previous: Option<&str>) -> String {
    let previous =
        previous.map(|p| format!("  <PreviousIncrementalRootDirectory name=\"{}\"/>\n", escape(p))).unwrap_or_default();
    let words = [marking, text].into_iter().filter(|t| !t.is_empty()).collect::<Vec<_>>().join(". ");
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Version xmlns=\"{VERSION_NAMESPACE}\">\n{previous}  <Comment>{}</Comment>\n  \
         <Specification version=\"1.0\" authority=\"OGC\"/>\n</Version>\n",
        escape(&words)
    )
}

/// The root of the version that a store continues, as its `Version.xml` names it, relative to its own root or absolute.
///
/// # Errors
/// [`Error::Unsupported`](crate::Error::Unsupported) for a `Version.xml` that cannot be read, and for a store whose
/// `Configuration.xml` joins versions in another way.
pub fn previous_version(store: &dyn Store) -> Result<Option<String>> {
    if store::exists(store, CONFIGURATION_XML)? {
        return Err(Error::Unsupported {
            format: "CDB store",
            what: format!("{CONFIGURATION_XML} joins several versions, which is not followed"),
        });
    }
    let Some(text) = store::read_text(store, VERSION_XML)? else { return Ok(None) };
    let version = xml::parse(&text).map_err(|e| store::unreadable(VERSION_XML, &e))?;
    let previous = version.child("PreviousIncrementalRootDirectory").and_then(|p| p.attribute("name"));
    Ok(previous.map(str::trim).filter(|p| !p.is_empty()).map(String::from))
}

/// The files and the empty folders of a new store that holds nothing yet.
pub fn new_store(marking: &str, text: &str) -> (Vec<File>, Vec<String>) {
    let version = version_xml(marking, text, None);
    let mut files = vec![File { path: VERSION_XML.into(), bytes: version.into_bytes(), media_type: "application/xml" }];
    files.extend(schemas(marking));
    (files, EMPTY_FOLDERS.map(String::from).to_vec())
}

/// The path of a schema.
pub fn schema_path(name: &str) -> String {
    format!("Metadata/Schema/{name}.xsd")
}

/// The schema files, each with the marking as a comment.
pub fn schemas(marking: &str) -> Vec<File> {
    let schema = |(name, namespace): (&str, &str)| {
        let body = match name {
            "Version" => VERSION_XSD,
            "Composite_Material_Table" => MATERIAL_XSD,
            "Model_Metadata" => MODEL_METADATA_XSD,
            _ => "",
        };
        let text = format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{}\n<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" \
             xmlns=\"{namespace}\" targetNamespace=\"{namespace}\" elementFormDefault=\"qualified\">\n{body}</xs:schema>\n",
            comment(marking)
        );
        File { path: schema_path(name), bytes: text.into_bytes(), media_type: "application/xml" }
    };
    SCHEMAS.into_iter().map(schema).collect()
}

const VERSION_XSD: &str = r#"  <xs:element name="Version">
    <xs:complexType>
      <xs:sequence>
        <xs:element name="PreviousIncrementalRootDirectory" minOccurs="0">
          <xs:complexType><xs:attribute name="name" type="xs:string" use="required"/></xs:complexType>
        </xs:element>
        <xs:element name="Comment" type="xs:string" minOccurs="0"/>
        <xs:element name="Specification" minOccurs="0">
          <xs:complexType>
            <xs:attribute name="version" use="required">
              <xs:simpleType>
                <xs:restriction base="xs:string">
                  <xs:enumeration value="1.0"/>
                  <xs:enumeration value="3.0"/>
                  <xs:enumeration value="3.1"/>
                  <xs:enumeration value="3.2"/>
                </xs:restriction>
              </xs:simpleType>
            </xs:attribute>
            <xs:attribute name="authority" type="xs:string"/>
          </xs:complexType>
        </xs:element>
        <xs:element name="Extension" minOccurs="0">
          <xs:complexType>
            <xs:attribute name="name" type="xs:string" use="required"/>
            <xs:attribute name="version" type="xs:string" use="required"/>
          </xs:complexType>
        </xs:element>
      </xs:sequence>
    </xs:complexType>
  </xs:element>
"#;

/// `Composite_Material` and its parts, shared by the table of a geocell and by model descriptors.
macro_rules! composite_material {
    () => {
        r#"  <xs:complexType name="Substrate">
    <xs:sequence>
      <xs:element name="Material" maxOccurs="unbounded">
        <xs:complexType>
          <xs:all>
            <xs:element name="Name">
              <xs:simpleType>
                <xs:restriction base="xs:string"><xs:pattern value="BM_[A-Za-z0-9_\-]{1,29}"/></xs:restriction>
              </xs:simpleType>
            </xs:element>
            <xs:element name="Weight" minOccurs="0">
              <xs:simpleType>
                <xs:restriction base="xs:integer"><xs:minInclusive value="1"/><xs:maxInclusive value="100"/></xs:restriction>
              </xs:simpleType>
            </xs:element>
          </xs:all>
        </xs:complexType>
      </xs:element>
      <xs:element name="Thickness" type="xs:double" minOccurs="0"/>
    </xs:sequence>
  </xs:complexType>
  <xs:complexType name="CompositeMaterials">
    <xs:sequence>
      <xs:element name="Composite_Material" minOccurs="0" maxOccurs="unbounded">
        <xs:complexType>
          <xs:sequence>
            <xs:element name="Name" type="xs:string" minOccurs="0"/>
            <xs:element name="Surface_Substrate" type="Substrate" minOccurs="0"/>
            <xs:element name="Primary_Substrate" type="Substrate"/>
            <xs:element name="Secondary_Substrate" type="Substrate" minOccurs="0" maxOccurs="unbounded"/>
          </xs:sequence>
          <xs:attribute name="index" type="xs:nonNegativeInteger" use="required"/>
        </xs:complexType>
      </xs:element>
    </xs:sequence>
    <xs:attribute name="version" type="xs:string"/>
  </xs:complexType>
"#
    };
}

const MATERIAL_XSD: &str =
    concat!(composite_material!(), "  <xs:element name=\"Composite_Material_Table\" type=\"CompositeMaterials\"/>\n");

const MODEL_METADATA_XSD: &str = concat!(
    composite_material!(),
    r#"  <xs:simpleType name="Range"><xs:list itemType="xs:double"/></xs:simpleType>
  <xs:element name="Model_Metadata">
    <xs:complexType>
      <xs:all>
        <xs:element name="Name" type="xs:string"/>
        <xs:element name="Identification">
          <xs:complexType>
            <xs:choice>
              <xs:element name="Feature_Attribute_Catalog_Code">
                <xs:complexType>
                  <xs:all>
                    <xs:element name="Code">
                      <xs:simpleType>
                        <xs:restriction base="xs:string"><xs:pattern value="[A-Z]{2}[0-9]{3}"/></xs:restriction>
                      </xs:simpleType>
                    </xs:element>
                    <xs:element name="Subcode" minOccurs="0">
                      <xs:simpleType>
                        <xs:restriction base="xs:integer"><xs:minInclusive value="0"/><xs:maxInclusive value="999"/></xs:restriction>
                      </xs:simpleType>
                    </xs:element>
                  </xs:all>
                </xs:complexType>
              </xs:element>
              <xs:element name="DIS_Entity_Type">
                <xs:complexType>
                  <xs:all>
                    <xs:element name="Kind" type="xs:unsignedByte"/>
                    <xs:element name="Domain" type="xs:unsignedByte"/>
                    <xs:element name="Country" type="xs:unsignedShort"/>
                    <xs:element name="Category" type="xs:unsignedByte"/>
                    <xs:element name="Subcategory" type="xs:unsignedByte"/>
                    <xs:element name="Specific" type="xs:unsignedByte"/>
                    <xs:element name="Extra" type="xs:unsignedByte"/>
                  </xs:all>
                </xs:complexType>
              </xs:element>
            </xs:choice>
          </xs:complexType>
        </xs:element>
        <xs:element name="Textures" minOccurs="0">
          <xs:complexType>
            <xs:sequence>
              <xs:element name="Texture" maxOccurs="unbounded">
                <xs:complexType>
                  <xs:all>
                    <xs:element name="Dataset" type="xs:integer" minOccurs="0"/>
                    <xs:element name="Kind" type="xs:integer"/>
                    <xs:element name="Index" type="xs:integer"/>
                    <xs:element name="Mipmap" type="Range"/>
                    <xs:element name="Resolution" type="xs:double"/>
                    <xs:element name="Coverage" minOccurs="0">
                      <xs:complexType>
                        <xs:all><xs:element name="U" type="Range"/><xs:element name="V" type="Range"/></xs:all>
                      </xs:complexType>
                    </xs:element>
                  </xs:all>
                  <xs:attribute name="name" type="xs:string" use="required"/>
                </xs:complexType>
              </xs:element>
            </xs:sequence>
          </xs:complexType>
        </xs:element>
        <xs:element name="Composite_Material_Table" type="CompositeMaterials" minOccurs="0"/>
      </xs:all>
    </xs:complexType>
  </xs:element>
"#
);

#[cfg(test)]
mod tests {
    use super::super::xml::parse;
    use super::*;

    #[test]
    fn the_version_claims_1_0_and_carries_the_marking() {
        let root = parse(&version_xml("CUI // <b> & -- c", "Made by Orb", Some("../old & gold"))).unwrap();
        assert_eq!((root.name.as_str(), root.namespace()), ("Version", Some(VERSION_NAMESPACE)));
        assert_eq!(root.child_text("Comment"), Some("CUI // <b> & -- c. Made by Orb"));
        let previous = root.child("PreviousIncrementalRootDirectory").unwrap();
        assert_eq!(previous.attribute("name"), Some("../old & gold"));
        assert_eq!(root.child("Specification").and_then(|s| s.attribute("version")), Some("1.0"));
    }

    #[test]
    fn every_schema_is_well_formed_and_names_its_namespace() {
        let files = schemas("TOP SECRET--x");
        assert_eq!(files.len(), 14);
        for (file, (name, namespace)) in files.iter().zip(SCHEMAS) {
            let text = std::str::from_utf8(&file.bytes).unwrap();
            assert!(text.contains("TOP SECRET"), "{}", file.path);
            assert_eq!(file.path, format!("Metadata/Schema/{name}.xsd"));
            let root = parse(text).unwrap();
            assert_eq!((root.local_name(), root.attribute("targetNamespace")), ("schema", Some(namespace)));
        }
    }
}
