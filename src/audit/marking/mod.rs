//! Handling levels and their order: the high-water mark of everything that went into a product.
//!
//! Levels and their spelling: DoDM 5200.01 Volume 2 (classification banners) and DoDI 5200.48 (the banner of CUI is
//! the three letters alone). Orb marks what it is told to mark: it is not a classifier.

use std::fmt;

use crate::{Error, Result};

/// A handling level, lowest first, so that `max` is the high-water mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Marking {
    #[default]
    Unclassified,
    Cui,
    Confidential,
    Secret,
    TopSecret,
}

/// The text before the banner wherever a marking stands inside a file.
pub const LINE_PREFIX: &str = "CLASSIFICATION: ";

impl Marking {
    pub const ALL: [Marking; 5] =
        [Marking::Unclassified, Marking::Cui, Marking::Confidential, Marking::Secret, Marking::TopSecret];

    /// Reads a banner as records and files carry it: the exact upper-case spelling of one of the five levels.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `MARKING_UNSUPPORTED`: nothing is stripped, completed or guessed.
    pub fn parse(text: &str) -> Result<Marking> {
        Marking::ALL.into_iter().find(|level| level.banner() == text).ok_or_else(|| unsupported(text))
    }

    /// Reads the operator's `--classification`. CONFIDENTIAL has its place in the order, for inputs that carry it,
    /// but no product is marked with it yet.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `MARKING_UNSUPPORTED`.
    pub fn parse_for_output(text: &str) -> Result<Marking> {
        match Marking::parse(text)? {
            Marking::Confidential => Err(unsupported(text)),
            level => Ok(level),
        }
    }

    /// The banner line's text.
    pub fn banner(self) -> &'static str {
        match self {
            Marking::Unclassified => "UNCLASSIFIED",
            Marking::Cui => "CUI",
            Marking::Confidential => "CONFIDENTIAL",
            Marking::Secret => "SECRET",
            Marking::TopSecret => "TOP SECRET",
        }
    }

    /// The abbreviation in parentheses before a portion.
    pub fn portion(self) -> &'static str {
        match self {
            Marking::Unclassified => "(U)",
            Marking::Cui => "(CUI)",
            Marking::Confidential => "(C)",
            Marking::Secret => "(S)",
            Marking::TopSecret => "(TS)",
        }
    }

    /// The `classification` attribute of the IC-ISM vocabulary. CUI is unclassified there; other attributes name it.
    pub fn ism_classification(self) -> &'static str {
        match self {
            Marking::Unclassified | Marking::Cui => "U",
            Marking::Confidential => "C",
            Marking::Secret => "S",
            Marking::TopSecret => "TS",
        }
    }

    /// The line that stands inside files: `CLASSIFICATION: UNCLASSIFIED`.
    pub fn line(self) -> String {
        format!("{LINE_PREFIX}{}", self.banner())
    }

    /// The least level that covers both.
    #[must_use]
    pub fn join(self, other: Marking) -> Marking {
        self.max(other)
    }

    /// The least level that covers all; UNCLASSIFIED when there are none.
    pub fn join_all(levels: impl IntoIterator<Item = Marking>) -> Marking {
        levels.into_iter().fold(Marking::Unclassified, Marking::join)
    }

    /// True where a key made silently on a first run is not good enough.
    pub fn needs_named_key(self) -> bool {
        self > Marking::Unclassified
    }
}

impl fmt::Display for Marking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.banner())
    }
}

fn unsupported(text: &str) -> Error {
    let advice = match text {
        "CONFIDENTIAL" => "Orb orders CONFIDENTIAL between CUI and SECRET but does not mark a product with it yet.",
        "FOUO" | "UNCLASSIFIED//FOUO" | "UNCLASSIFIED//FOR OFFICIAL USE ONLY" => {
            "FOUO is a retired marking: its owner must re-mark it. Orb never turns it into CUI."
        }
        _ if text.contains("//") => {
            "Control markings after // are not supported in this version, and Orb never strips or ignores a part of a \
             marking. Nothing was written."
        }
        _ if Marking::ALL.iter().any(|l| l.banner().eq_ignore_ascii_case(text.trim())) => {
            "Write the banner in upper case and without spaces around it."
        }
        _ if Marking::ALL.iter().any(|l| l.portion().trim_matches(['(', ')']) == text) => {
            "A banner is spelled out; abbreviations are for portions."
        }
        _ => "Orb refuses a marking that it does not know. Nothing was written.",
    };
    Error::policy("classification")
        .expected("UNCLASSIFIED, CUI, SECRET or TOP SECRET")
        .found(format!("MARKING_UNSUPPORTED: {text:?}"))
        .advice(advice)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Kind;

    fn level() -> impl Strategy<Value = Marking> {
        (0..Marking::ALL.len()).prop_map(|i| Marking::ALL[i])
    }

    proptest! {
        #[test]
        fn join_is_a_semilattice(a in level(), b in level(), c in level()) {
            prop_assert_eq!(a.join(a), a);
            prop_assert_eq!(a.join(b), b.join(a));
            prop_assert_eq!(a.join(b).join(c), a.join(b.join(c)));
            prop_assert!(a.join(b) >= a && a.join(b) >= b);
            // The least upper bound: whatever covers both covers the join.
            if c >= a && c >= b {
                prop_assert!(c >= a.join(b));
            }
        }

        #[test]
        fn only_the_five_banners_are_read(text in "[A-Z/ ]{0,16}") {
            match Marking::parse(&text) {
                Ok(level) => prop_assert_eq!(level.banner(), text),
                Err(error) => prop_assert_eq!(error.kind, Kind::Policy),
            }
        }
    }

    #[test]
    fn the_order_is_the_handling_order() {
        for pair in Marking::ALL.windows(2) {
            assert!(pair[0] < pair[1]);
            assert_eq!(pair[0].join(pair[1]), pair[1]);
        }
        assert_eq!(Marking::join_all([]), Marking::Unclassified);
        assert_eq!(Marking::join_all([Marking::Cui, Marking::Secret, Marking::Unclassified]), Marking::Secret);
    }

    #[test]
    fn reading_a_written_banner_gives_the_level_back() {
        for level in Marking::ALL {
            assert_eq!(Marking::parse(level.banner()), Ok(level));
        }
    }

    #[test]
    fn what_the_operator_cannot_ask_for() {
        for text in [
            "",
            "secret",
            " SECRET",
            "S",
            "TS",
            "FOUO",
            "UNCLASSIFIED//FOUO",
            "SECRET//NOFORN",
            "TOP SECRET//SI",
            "CONFIDENTIAL",
            "NATO SECRET",
            "RESTRICTED",
            "CUI//SP-CTI",
        ] {
            let error = Marking::parse_for_output(text).expect_err(text);
            assert_eq!(error.kind, Kind::Policy, "{text}");
            assert!(error.found.contains("MARKING_UNSUPPORTED"), "{text}");
            assert!(!error.advice.is_empty());
        }
        for text in ["UNCLASSIFIED", "CUI", "SECRET", "TOP SECRET"] {
            assert!(Marking::parse_for_output(text).is_ok());
        }
    }
}
