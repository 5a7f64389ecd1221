//! Checking a store against the content rules of CDB 1.0.
//!
//! Schemas are not interpreted: rule 12 asks that the XML files are well-formed, of the right namespace, and hold the
//! elements and values that the schemas demand.

mod features;
mod flt;
mod geometry;
mod ground;
mod library;
mod metadata;
mod paths;
mod report;

pub use report::{Report, RuleReport, Verdict, report};

use super::store::{ListableStore, unreadable};
use crate::Result;

/// Something in a store that breaks a rule.
///
/// Rules: 1 every feature's model and descriptor exist, and every geospecific model has its feature; 2 textures exist with their mips,
/// powers of two, SGI; 3 the feature pyramid is complete, tiles within their point limit; 4 MLOD agrees with the tile;
/// 5 significant sizes and vertex counts agree with the LOD; 6 OpenFlight structure, header, zone and bounding box; 7 origin and
/// ground; 8 feature sizes match the geometry, 0 ≤ AO1 < 360; 9 material indices resolve; 10 archives; 11 names and
/// folders; 12 XML files; 13 terrain and imagery.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Finding {
    pub rule: u8,
    /// The file, relative to the CDB root.
    pub path: String,
    /// What was expected and what was found.
    pub text: String,
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "rule {}: {}: {}", self.rule, self.path, self.text)
    }
}

/// Findings as they come.
#[derive(Default)]
struct Findings(Vec<Finding>);

impl Findings {
    fn add(&mut self, rule: u8, path: &str, text: impl Into<String>) {
        self.0.push(Finding { rule, path: path.into(), text: text.into() });
    }
}

/// Checks every file of the datasets that Orb writes, and the names of all; findings in order of path, none twice.
///
/// # Errors
/// [`crate::Error::Unsupported`] when the store itself cannot be listed or read.
pub fn check(store: &dyn ListableStore) -> Result<Vec<Finding>> {
    let mut paths = store.list().map_err(|e| unreadable("the store", &e))?;
    paths.sort();
    let mut findings = Findings::default();
    let files = paths::check(&paths, &mut findings);
    metadata::check(store, &paths, &mut findings)?;
    let models = geometry::check(store, &files, &mut findings)?;
    let library = library::check(store, &paths, &mut findings)?;
    features::check(store, &files, &models, &library, &mut findings)?;
    ground::check(store, &files, &mut findings)?;
    let mut found = findings.0;
    found.sort_by(|a, b| (&a.path, a.rule, &a.text).cmp(&(&b.path, b.rule, &b.text)));
    found.dedup();
    Ok(found)
}
