//! Rule 11: names and folders.

use std::collections::BTreeMap;

use super::Findings;
use crate::cdb::names::{self, DATASETS, TileFile};

const ROOT_FOLDERS: [&str; 6] = ["Metadata", "GTModel", "MModel", "Tiles", "Navigation", "ExtMetadata"];

/// Checks all paths and returns those of the datasets that the other rules look into.
pub fn check(paths: &[String], findings: &mut Findings) -> Vec<(String, TileFile)> {
    let mut by_lower: BTreeMap<String, &str> = BTreeMap::new();
    let mut files = Vec::new();
    for path in paths {
        if let Some(long) = path.split('/').find(|c| c.len() > 255) {
            findings.add(11, path, format!("a name of {} bytes, at most 255 are allowed", long.len()));
        }
        // Folders too must not differ by case only.
        let ends = path.match_indices('/').map(|(i, _)| i).chain([path.len()]);
        for part in ends.map(|end| &path[..end]) {
            let other = *by_lower.entry(part.to_lowercase()).or_insert(part);
            if other != part {
                findings.add(11, path, format!("{part} differs from {other} by the case of letters only"));
            }
        }
        let top = path.split('/').next().unwrap_or_default();
        if !ROOT_FOLDERS.contains(&top) || top == path {
            findings.add(11, path, "the root of a CDB holds only Metadata, GTModel, MModel, Tiles and Navigation");
        }
        match names::parse(path) {
            Some(file) => files.push((path.clone(), file)),
            None if of_checked_dataset(path) => {
                findings.add(11, path, "the name does not follow from geocell, dataset, level of detail and tile");
            }
            None => {}
        }
    }
    files
}

fn of_checked_dataset(path: &str) -> bool {
    let mut parts = path.split('/');
    parts.next() == Some("Tiles") && parts.nth(2).is_some_and(|d| DATASETS.iter().any(|known| known.name == d))
}
