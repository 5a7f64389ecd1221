//! Rule 12 for the Metadata folder.

use super::Findings;
use crate::Result;
use crate::cdb::metadata::{SCHEMAS, VERSION_NAMESPACE, VERSION_XML, schema_path};
use crate::cdb::store::{ListableStore, read_text};
use crate::cdb::xml;

pub fn check(store: &dyn ListableStore, paths: &[String], findings: &mut Findings) -> Result<()> {
    let has = |path: &str| paths.binary_search_by(|p| p.as_str().cmp(path)).is_ok();
    if !has(VERSION_XML) {
        findings.add(12, VERSION_XML, "the file is missing; it is the one that every CDB has");
    }
    for (name, _) in SCHEMAS {
        if !has(&schema_path(name)) {
            findings.add(12, &schema_path(name), "the schema is missing");
        }
    }
    for path in paths.iter().filter(|p| p.starts_with("Metadata/")) {
        if !path.ends_with(".xml") && !path.ends_with(".xsd") {
            continue;
        }
        let root = match read_text(store, path).map(|t| xml::parse(&t.unwrap_or_default())) {
            Ok(Ok(root)) => root,
            Ok(Err(e)) | Err(e) => {
                findings.add(12, path, e.to_string());
                continue;
            }
        };
        if path == VERSION_XML {
            check_version(&root, findings);
        }
        if let Some((_, namespace)) = SCHEMAS.iter().find(|(n, _)| schema_path(n) == *path)
            && (root.local_name() != "schema" || root.attribute("targetNamespace").is_none())
        {
            findings.add(
                12,
                path,
                format!("expected an XML schema of target namespace {namespace}, found {}", root.name),
            );
        }
    }
    Ok(())
}

fn check_version(root: &xml::Element, findings: &mut Findings) {
    let mut add = |text: String| findings.add(12, VERSION_XML, text);
    if root.local_name() != "Version" || root.namespace() != Some(VERSION_NAMESPACE) {
        add(format!(
            "expected Version in namespace {VERSION_NAMESPACE}, found {} in {:?}",
            root.name,
            root.namespace()
        ));
    }
    let order = ["PreviousIncrementalRootDirectory", "Comment", "Specification", "Metadata", "Extension"];
    let places: Vec<Option<usize>> =
        root.children.iter().map(|c| order.iter().position(|o| *o == c.local_name())).collect();
    if places.contains(&None) || !places.is_sorted_by(|a, b| a < b) {
        add(format!("expected at most one each of {}, in this order", order.join(", ")));
    }
    if let Some(specification) = root.child("Specification") {
        let version = specification.attribute("version").unwrap_or_default();
        if !["1.0", "1.1", "1.2", "1.3", "3.0", "3.1", "3.2"].contains(&version) {
            add(format!("the specification's version {version:?} is none of CDB"));
        }
    }
}
