//! Networks that Orb knows: what they are called, under which licence they come, which files are theirs.
//!
//! A pin is the SHA-256 of a file. A file without a pin may still be recognised by its number of weights, which says
//! what it is likely to be and proves nothing.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::family::{Family, Role};
use crate::{Error, Result};

/// What a depth network's numbers mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum DepthKind {
    /// Larger is nearer, up to a scale and a shift.
    Disparity,
    /// Larger is farther.
    Depth,
    /// Metres along the optical axis: gives a scale as well.
    Metric,
}

/// A known network.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    pub id: String,
    pub version: String,
    pub families: Vec<Family>,
    /// SPDX where there is such a name.
    pub licence: String,
    /// Its licence allows commercial use.
    pub commercial: bool,
    /// Where its makers publish it.
    pub upstream: String,
    #[serde(default)]
    pub kind: Option<DepthKind>,
    /// Least and most numbers that a graph's initialisers hold; exporters fold constants differently.
    #[serde(default)]
    pub weights: BTreeMap<Role, [u64; 2]>,
    /// SHA-256, lower case, of every file: graphs and external data.
    #[serde(default)]
    pub pins: Vec<String>,
}

/// The entries of the program, then those of the user's own `catalogue.json` in the folder of models.
#[derive(Clone, Debug)]
pub struct Catalogue {
    pub entries: Vec<Entry>,
}

impl Catalogue {
    /// # Errors
    /// A usage error when the user's file is not what it should be.
    pub fn load(models: &Path) -> Result<Catalogue> {
        let parse = |text: &str, name: &str| -> Result<Vec<Entry>> {
            serde_json::from_str(text).map_err(|e| {
                Error::usage(name)
                    .expected("a list of networks with id, version, families, licence, …")
                    .found(e.to_string())
            })
        };
        let mut entries = parse(include_str!("catalogue.json"), "the built-in catalogue")?;
        let own = models.join("catalogue.json");
        match std::fs::read_to_string(&own) {
            Ok(text) => {
                let more = parse(&text, &own.display().to_string())?;
                entries.retain(|e| more.iter().all(|m| m.id != e.id));
                entries.extend(more);
            }
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => {}
            Err(e) => return Err(Error::io(&own, &e)),
        }
        Ok(Catalogue { entries })
    }

    pub fn get(&self, id: &str) -> Option<&Entry> {
        self.entries.iter().find(|e| e.id == id)
    }

    /// The network whose pins hold every one of these files.
    pub fn pinned(&self, family: Family, sha256: &[&str]) -> Option<&Entry> {
        self.of(family).find(|e| !sha256.is_empty() && sha256.iter().all(|s| e.pins.iter().any(|p| p == s)))
    }

    /// The network that has such numbers of weights.
    pub fn likely(&self, family: Family, weights: &BTreeMap<Role, u64>) -> Option<&Entry> {
        let fits =
            |(role, [least, most]): (&Role, &[u64; 2])| weights.get(role).is_some_and(|n| (least..=most).contains(&n));
        self.of(family).find(|e| !e.weights.is_empty() && e.weights.iter().all(fits))
    }

    fn of(&self, family: Family) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(move |e| e.families.contains(&family))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_catalogue_is_sound() {
        let dir = tempfile::tempdir().unwrap();
        let catalogue = Catalogue::load(dir.path()).unwrap();
        for (i, e) in catalogue.entries.iter().enumerate() {
            assert!(catalogue.entries[..i].iter().all(|o| o.id != e.id), "{} twice", e.id);
            for role in e.weights.keys() {
                assert!(e.families.iter().all(|f| f.roles().contains(role)), "{}", e.id);
            }
            assert_eq!(e.kind.is_some(), e.families == [Family::DepthAnything], "{}", e.id);
            assert!(e.pins.iter().all(|p| p.len() == 64), "{}", e.id);
        }
        for family in Family::ALL {
            assert!(catalogue.of(family).next().is_some(), "{}", family.name());
        }
    }

    #[test]
    fn numbers_of_weights_tell_sizes_apart() {
        let dir = tempfile::tempdir().unwrap();
        let catalogue = Catalogue::load(dir.path()).unwrap();
        let likely = |n: u64| {
            let weights = BTreeMap::from([(Role::Depth, n)]);
            catalogue.likely(Family::DepthAnything, &weights).map(|e| e.id.as_str())
        };
        assert_eq!(likely(24_700_000), Some("depth-anything-v2-small"));
        assert_eq!(likely(97_000_000), Some("depth-anything-v2-base"));
        assert_eq!(likely(50_000_000), None);
    }

    #[test]
    fn a_users_own_catalogue_adds_and_replaces() {
        let dir = tempfile::tempdir().unwrap();
        let own = r#"[{"id": "depth-anything-v2-small", "version": "2", "families": ["depth-anything"],
            "licence": "Apache-2.0", "commercial": true, "upstream": "here", "kind": "disparity", "pins": ["aa"]}]"#;
        std::fs::write(dir.path().join("catalogue.json"), own).unwrap();
        let catalogue = Catalogue::load(dir.path()).unwrap();
        assert_eq!(catalogue.get("depth-anything-v2-small").unwrap().upstream, "here");
        assert!(catalogue.pinned(Family::DepthAnything, &["aa"]).is_some());
        assert!(catalogue.pinned(Family::DepthAnything, &["aa", "bb"]).is_none());
        assert!(catalogue.pinned(Family::DepthAnything, &[]).is_none());
        std::fs::write(dir.path().join("catalogue.json"), "[{}]").unwrap();
        assert_eq!(Catalogue::load(dir.path()).unwrap_err().kind, crate::Kind::Usage);
    }
}
