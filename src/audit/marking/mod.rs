//! What a product is marked: level, controls, release, and the high-water mark of everything that went into it.
//!
//! Grammar and roll-up: the Intelligence Community Markings System Register and Manual (2016), sections D and H.8; levels
//! and their spelling also DoDM 5200.01 Volume 2, the banner of CUI DoDI 5200.48 and 32 CFR 2002. Orb marks what it is told
//! to mark: it is not a classifier.

pub mod authority;
pub mod handling;
mod parse;
pub mod register;
mod release;

use std::collections::BTreeSet;
use std::fmt;

use serde::{Deserialize, Serialize};

use crate::{Error, Result};
use release::Release;

/// The text before the banner wherever a marking stands inside a file.
pub const LINE_PREFIX: &str = "CLASSIFICATION: ";
/// The longest banner that every carrier holds, bytes.
pub const MAX_BANNER: usize = 240;

/// The levels, lowest first: the order of handling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    #[default]
    Unclassified,
    Cui,
    Confidential,
    Secret,
    TopSecret,
}

impl Level {
    pub const ALL: [Level; 5] = [Level::Unclassified, Level::Cui, Level::Confidential, Level::Secret, Level::TopSecret];

    /// As a banner spells it.
    pub fn name(self) -> &'static str {
        match self {
            Level::Unclassified => "UNCLASSIFIED",
            Level::Cui => "CUI",
            Level::Confidential => "CONFIDENTIAL",
            Level::Secret => "SECRET",
            Level::TopSecret => "TOP SECRET",
        }
    }

    /// As a portion mark spells it.
    fn portion(self) -> &'static str {
        match self {
            Level::Unclassified => "U",
            Level::Cui => "CUI",
            Level::Confidential => "C",
            Level::Secret => "S",
            Level::TopSecret => "TS",
        }
    }

    pub fn is_classified(self) -> bool {
        self >= Level::Confidential
    }
}

/// Which rules the banner of CUI follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Profile {
    /// DoDI 5200.48: the banner is `CUI` alone, the rest stands in the designation indicator block.
    #[default]
    Dod,
    /// 32 CFR 2002: categories and limited dissemination in the banner, `CUI//SP-CTI//NOFORN`.
    Isoo,
}

impl Profile {
    pub fn name(self) -> &'static str {
        match self {
            Profile::Dod => "dod",
            Profile::Isoo => "isoo",
        }
    }
}

/// Dissemination controls that do not speak of release, in the Register's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Control {
    Orcon,
    Imcon,
    Propin,
    Fisa,
}

impl Control {
    const ALL: [Control; 4] = [Control::Orcon, Control::Imcon, Control::Propin, Control::Fisa];

    fn name(self) -> &'static str {
        match self {
            Control::Orcon => "ORCON",
            Control::Imcon => "IMCON",
            Control::Propin => "PROPIN",
            Control::Fisa => "FISA",
        }
    }

    fn portion(self) -> &'static str {
        match self {
            Control::Orcon => "OC",
            Control::Imcon => "IMC",
            Control::Propin => "PR",
            Control::Fisa => "FISA",
        }
    }
}

/// A parsed banner. [`Marking::join`] makes a semilattice of them.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Marking {
    level: Level,
    controls: BTreeSet<Control>,
    release: Release,
    /// LIMDIS, the one control of outside the intelligence community that is supported: it is geospatial.
    limdis: bool,
    /// Categories of CUI, `SP-` marks first; below classified levels only.
    cui_specified: BTreeSet<String>,
    cui_basic: BTreeSet<String>,
    /// Limited dissemination of CUI, but for the release markings.
    cui_limits: BTreeSet<&'static str>,
}

impl Marking {
    pub const UNCLASSIFIED: Marking = Marking::of(Level::Unclassified);
    pub const CUI: Marking = Marking::of(Level::Cui);
    pub const CONFIDENTIAL: Marking = Marking::of(Level::Confidential);
    pub const SECRET: Marking = Marking::of(Level::Secret);
    pub const TOP_SECRET: Marking = Marking::of(Level::TopSecret);

    /// The level alone.
    pub const fn of(level: Level) -> Marking {
        Marking {
            level,
            controls: BTreeSet::new(),
            release: Release::Unstated,
            limdis: false,
            cui_specified: BTreeSet::new(),
            cui_basic: BTreeSet::new(),
            cui_limits: BTreeSet::new(),
        }
    }

    /// Reads a banner whose country codes Orb lists. Entries of one category may stand in another order than the Register's; [`Marking::banner`] gives
    /// them in order.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `MARKING_UNSUPPORTED`: nothing is stripped, completed or guessed.
    pub fn parse(text: &str) -> Result<Marking> {
        parse::banner(text, parse::Codes::Listed)
    }

    /// As [`Marking::parse`], with any three or four capital letters for a country code: [`Marking::unlisted_codes`] are the
    /// caller's to check, against a register of the user's or against what a record says of one.
    ///
    /// # Errors
    /// As [`Marking::parse`].
    pub fn read(text: &str) -> Result<Marking> {
        parse::banner(text, parse::Codes::Any)
    }

    /// Reads the operator's banner, which must be one that `profile` can write.
    ///
    /// # Errors
    /// As [`Marking::read`] and [`Marking::check_expressible`].
    pub fn read_for_output(text: &str, profile: Profile) -> Result<Marking> {
        let marking = Marking::read(text)?;
        marking.check_expressible(profile)?;
        Ok(marking)
    }

    pub fn level(&self) -> Level {
        self.level
    }

    /// Refuses what no banner of the profile says.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `MARKING_UNSUPPORTED`.
    pub fn check_expressible(&self, profile: Profile) -> Result<()> {
        let refuse = |why: &str, advice: &str| {
            Err(Error::policy("classification")
                .expected(format!("a marking that the profile {} can write", profile.name()))
                .found(format!("MARKING_UNSUPPORTED: {self}: {why}"))
                .advice(advice))
        };
        if self.banner().len() > MAX_BANNER {
            return refuse("longer than files can carry", "Nothing was written.");
        }
        if self.level != Level::Cui {
            return Ok(());
        }
        if self.limdis || !self.controls.is_empty() {
            return refuse(
                "controls that are not CUI's joined with CUI",
                "Only the owners of the inputs can say how their mixture is marked.",
            );
        }
        if profile == Profile::Dod && *self != Marking::CUI {
            return refuse(
                "categories and limits in the banner",
                "DoD's banner is CUI alone, the rest belongs in the designation indicator block (--cui-category, \
                 --cui-dissemination, …); --marking-profile isoo writes them in the banner.",
            );
        }
        Ok(())
    }

    /// Entries in the order of the Register, `//` between categories, `/` within one.
    pub fn banner(&self) -> String {
        self.written(self.level.name(), Control::name, "NOFORN", "LIMDIS")
    }

    /// The mark before a portion: `(S//NF)`.
    pub fn portion(&self) -> String {
        format!("({})", self.written(self.level.portion(), Control::portion, "NF", "DS"))
    }

    fn written(&self, level: &str, control: fn(Control) -> &'static str, noforn: &str, limdis: &str) -> String {
        let mut out = level.to_owned();
        let mut category = |entries: Vec<String>| {
            if !entries.is_empty() {
                out.push_str("//");
                out.push_str(&entries.join("/"));
            }
        };
        category(self.cui_specified.iter().chain(&self.cui_basic).cloned().collect());
        let has = |c: &Control| self.controls.contains(c);
        let [rel_to, relido, display] = self.release.entries();
        if self.level == Level::Cui {
            let mut limits: Vec<String> = self.cui_limits.iter().map(|l| (*l).to_owned()).collect();
            limits.extend(self.release.is_noforn().then(|| noforn.to_owned()));
            limits.extend([rel_to, relido, display].into_iter().flatten());
            limits.extend(self.controls.iter().map(|c| control(*c).to_owned()));
            limits.sort();
            category(limits);
        } else {
            let mut entries: Vec<String> = Vec::new();
            entries.extend([Control::Orcon, Control::Imcon].iter().filter(|c| has(c)).map(|c| control(*c).to_owned()));
            entries.extend(self.release.is_noforn().then(|| noforn.to_owned()));
            entries.extend(has(&Control::Propin).then(|| control(Control::Propin).to_owned()));
            entries.extend([rel_to, relido].into_iter().flatten());
            entries.extend(has(&Control::Fisa).then(|| control(Control::Fisa).to_owned()));
            entries.extend(display);
            category(entries);
        }
        category(self.limdis.then(|| limdis.to_owned()).into_iter().collect());
        out
    }

    /// The line that stands inside files: `CLASSIFICATION: UNCLASSIFIED`.
    pub fn line(&self) -> String {
        format!("{LINE_PREFIX}{}", self.banner())
    }

    /// The marking as attributes of the IC-ISM vocabulary, in portion form. CUI is unclassified there.
    pub fn ism(&self) -> Ism {
        let classification = if self.level.is_classified() { self.level.portion() } else { "U" };
        let mut controls: Vec<String> = self.controls.iter().map(|c| c.portion().to_owned()).collect();
        controls.extend(self.cui_limits.iter().map(|l| (*l).to_owned()));
        controls.extend(self.release.ism_controls().map(str::to_owned));
        let (releasable_to, display_only_to) = self.release.lists();
        Ism {
            classification: classification.into(),
            dissemination_controls: controls,
            releasable_to,
            display_only_to,
            non_ic_markings: if self.limdis { vec!["DS".into()] } else { Vec::new() },
            cui_specified: self.cui_specified.iter().cloned().collect(),
            cui_basic: self.cui_basic.iter().cloned().collect(),
        }
    }

    /// The least marking that covers both: the highest level, every control, and the release that Table 3 of the manual
    /// (section D.2) rolls up to. It is stricter than DoDM 5200.01, which drops REL TO where a classified portion has none:
    /// here the result is NOFORN.
    #[must_use]
    pub fn join(&self, other: &Marking) -> Marking {
        let level = self.level.max(other.level);
        let union = |a: &BTreeSet<String>, b: &BTreeSet<String>| match level.is_classified() {
            // A classified banner does not carry CUI.
            true => BTreeSet::new(),
            false => a | b,
        };
        let release = self.release.join(self.level, &other.release, other.level);
        Marking {
            level,
            controls: &self.controls | &other.controls,
            release,
            limdis: self.limdis || other.limdis,
            cui_specified: union(&self.cui_specified, &other.cui_specified),
            cui_basic: union(&self.cui_basic, &other.cui_basic),
            cui_limits: if level.is_classified() { BTreeSet::new() } else { &self.cui_limits | &other.cui_limits },
        }
    }

    /// The least marking that covers all; UNCLASSIFIED when there are none.
    pub fn join_all<'a>(markings: impl IntoIterator<Item = &'a Marking>) -> Marking {
        markings.into_iter().fold(Marking::UNCLASSIFIED, |a, b| a.join(b))
    }

    /// Nothing in `other` asks for more than this marking gives.
    pub fn covers(&self, other: &Marking) -> bool {
        self.join(other) == *self
    }

    /// True where a key made silently on a first run is not good enough.
    pub fn needs_named_key(&self) -> bool {
        *self != Marking::UNCLASSIFIED
    }

    /// Country codes that Orb does not list, sorted.
    pub fn unlisted_codes(&self) -> Vec<&str> {
        let codes: BTreeSet<&str> = self.release.codes().filter(|code| !parse::is_listed(code)).collect();
        codes.into_iter().collect()
    }

    /// Categories of CUI that Orb's list of marks does not hold.
    pub fn unknown_categories(&self) -> Vec<&str> {
        let bare = |mark: &'_ String| !parse::knows_category(mark.strip_prefix("SP-").unwrap_or(mark));
        self.cui_specified.iter().chain(&self.cui_basic).filter(|m| bare(m)).map(String::as_str).collect()
    }
}

impl fmt::Display for Marking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.banner())
    }
}

/// Attribute names of the IC-ISM vocabulary; not a conformant ISM.XML document.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct Ism {
    pub classification: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dissemination_controls: Vec<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub releasable_to: Vec<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub display_only_to: Vec<String>,
    #[serde(rename = "nonICmarkings", default, skip_serializing_if = "Vec::is_empty")]
    pub non_ic_markings: Vec<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cui_specified: Vec<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cui_basic: Vec<String>,
}

#[cfg(test)]
mod tests;
