//! The rules one by one: what each asks, where it stands, and whether a store keeps it.

use super::{Finding, check};
use crate::Result;
use crate::cdb::store::{ListableStore, unreadable};

/// A rule's outcome.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Something in the store is spoken of, and all of it keeps the rule.
    Pass,
    Fail(Vec<Finding>),
    /// Nothing in the store is spoken of.
    NotApplicable(&'static str),
}

/// A rule with its outcome.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleReport {
    pub number: u8,
    pub title: &'static str,
    /// Volumes and requirements of OGC CDB 1.x.
    pub source: &'static str,
    /// Tests of the abstract test suite (OGC 15-113, Annex A, one for each requirement) that it answers in full or in
    /// part; none where the standard has none.
    pub abstract_tests: &'static str,
    pub verdict: Verdict,
}

/// All rules of a store.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    pub files: usize,
    pub rules: Vec<RuleReport>,
}

struct Rule {
    number: u8,
    title: &'static str,
    source: &'static str,
    abstract_tests: &'static str,
    /// What a path must have for the rule to speak of it, and what is said when no path has.
    about: (fn(&str) -> bool, &'static str),
}

const FEATURES: (fn(&str) -> bool, &str) =
    (|p| p.contains("/100_GSFeature/") || p.contains("/101_GTFeature/"), "no GSFeature and no GTFeature tiles");
const MODELS: (fn(&str) -> bool, &str) = (
    |p| ["/300_GSModelGeometry/", "/500_GTModelGeometry/", "/600_MModelGeometry/"].iter().any(|d| p.contains(d)),
    "no geometry of models",
);
const EITHER: (fn(&str) -> bool, &str) = (|p| FEATURES.0(p) || MODELS.0(p), "no models");
const ZIPS: (fn(&str) -> bool, &str) = (|p| p.ends_with(".zip"), "no archives");
const GROUND: (fn(&str) -> bool, &str) = (super::ground::is_ground, "no elevation and no imagery");
const ALL: (fn(&str) -> bool, &str) = (|_| true, "no files");

const RULES: [Rule; 13] = [
    Rule {
        number: 1,
        title: "every feature has its model and descriptor, every geospecific model its feature",
        source: "Vol. 1 Req 45-56, 68, 129; Vol. 1 §5.8.1",
        abstract_tests: "129",
        about: EITHER,
    },
    Rule {
        number: 2,
        title: "textures that models name exist, with all mip levels, as SGI images of powers of two",
        source: "Vol. 6 §6.13; Vol. 1 Req 42",
        abstract_tests: "41",
        about: MODELS,
    },
    Rule {
        number: 3,
        title: "the feature pyramid is complete to LC10 and no tile has more points than its level allows",
        source: "Vol. 1 Req 14-16, 64; Vol. 7 rules 7, 8",
        abstract_tests: "14-16, 64",
        about: FEATURES,
    },
    Rule { number: 4, title: "MLOD agrees with the tile", source: "Vol. 1 §5.7", abstract_tests: "", about: FEATURES },
    Rule {
        number: 5,
        title: "significant sizes and vertex counts agree with the level of the tile",
        source: "Vol. 1 Req 41, Table 3-1; Vol. 6 Req 26",
        abstract_tests: "41",
        about: MODELS,
    },
    Rule {
        number: 6,
        title: "models are sound OpenFlight with header, zone and bounding box as CDB wants them",
        source: "Vol. 6 §6.3-6.6, Annex B",
        abstract_tests: "",
        about: MODELS,
    },
    Rule {
        number: 7,
        title: "the origin lies at the centre of the footprint, on the ground",
        source: "Vol. 6 Req 8",
        abstract_tests: "",
        about: MODELS,
    },
    Rule {
        number: 8,
        title: "sizes of features agree with the geometry, 0 <= AO1 < 360",
        source: "Vol. 1 §5.7.1",
        abstract_tests: "",
        about: FEATURES,
    },
    Rule {
        number: 9,
        title: "materials resolve from table to table",
        source: "Vol. 1 Req 23; Vol. 1 §2.5",
        abstract_tests: "22, 23, 128",
        about: EITHER,
    },
    Rule {
        number: 10,
        title: "archives are stored, at most 32,000,000 bytes, without folders, their entries named after them",
        source: "Vol. 1 Req 68-72, §3.6.3",
        abstract_tests: "68-70, 72",
        about: ZIPS,
    },
    Rule {
        number: 11,
        title: "names and folders follow the standard, none differ in letter case only",
        source: "Vol. 1 Req 5, 65-67, §3",
        abstract_tests: "5, 29, 40, 46-49, 58-60, 65-67",
        about: ALL,
    },
    Rule {
        number: 12,
        title: "XML files are well-formed, of their namespace, with what their schemas ask",
        source: "Vol. 1 Req 33, 74, §5.1",
        abstract_tests: "33, 74",
        about: ALL,
    },
    Rule {
        number: 13,
        title: "elevation, its lowest and highest values and imagery have the samples and the registration of their level, in \
                pyramids complete to LC10",
        source: "Vol. 1 Req 14-16, 85-87, 94, §3.6.1",
        abstract_tests: "13-16, 85-89, 94, 101",
        about: GROUND,
    },
];

/// Checks a store and gives every rule its verdict.
///
/// # Errors
/// As [`check`].
pub fn report(store: &dyn ListableStore) -> Result<Report> {
    let paths = store.list().map_err(|e| unreadable("the store", &e))?;
    let findings = check(store)?;
    let rules = RULES.iter().map(|rule| {
        let own: Vec<Finding> = findings.iter().filter(|f| f.rule == rule.number).cloned().collect();
        let (speaks_of, nothing) = rule.about;
        let verdict = if !own.is_empty() {
            Verdict::Fail(own)
        } else if paths.iter().any(|p| speaks_of(p)) {
            Verdict::Pass
        } else {
            Verdict::NotApplicable(nothing)
        };
        RuleReport {
            number: rule.number,
            title: rule.title,
            source: rule.source,
            abstract_tests: rule.abstract_tests,
            verdict,
        }
    });
    Ok(Report { files: paths.len(), rules: rules.collect() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cdb::Memory;

    #[test]
    fn a_store_without_models_has_rules_that_do_not_apply() {
        let mut store = Memory::default();
        let version = "<?xml version=\"1.0\"?><Version xmlns=\"http://www.opengis.net/cdb/1.0/Version\">\
                       <Specification version=\"1.0\" authority=\"OGC\"/></Version>";
        store.files.insert("Metadata/Version.xml".into(), version.into());
        let report = report(&store).unwrap();
        assert_eq!(report.rules.iter().map(|r| r.number).collect::<Vec<_>>(), (1..=13).collect::<Vec<u8>>());
        for rule in &report.rules {
            match rule.number {
                1..=10 | 13 => assert!(matches!(rule.verdict, Verdict::NotApplicable(_)), "{rule:?}"),
                _ => assert!(!matches!(rule.verdict, Verdict::NotApplicable(_)), "{rule:?}"),
            }
        }
        store.files.insert("stray.exe".into(), vec![1]);
        let names = &super::report(&store).unwrap().rules[10];
        assert!(matches!(&names.verdict, Verdict::Fail(f) if f[0].path.contains("stray")), "{names:?}");
    }
}
