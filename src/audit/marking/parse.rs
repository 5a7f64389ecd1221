//! The grammar of banners: what is read, and what is refused with which words.

use std::collections::BTreeSet;

use super::register::is_code;
use super::release::{Audience, Release, is_group};
use super::{Control, Level, Marking};
use crate::{Error, Result};

/// Limited dissemination controls of CUI that are one word or two (NARA's CUI registry), but for NOFORN.
const CUI_LIMITS: [&str; 7] = ["AC", "AWP", "DELIB", "DL ONLY", "FED ONLY", "FEDCON", "NOCON"];

/// Category marks of NARA's CUI registry that Orb knows, as of November 2026; others are taken with a warning.
const CUI_CATEGORIES: [&str; 36] = [
    "AG",
    "ASYL",
    "BUDG",
    "CEII",
    "CHRI",
    "CTI",
    "CVI",
    "DCNI",
    "DCRIT",
    "EMGT",
    "EXPT",
    "EXPTR",
    "FNC",
    "GENETIC",
    "GEO",
    "HLTH",
    "INTEL",
    "INV",
    "ISVI",
    "LEI",
    "MIL",
    "NNPI",
    "NUC",
    "OPSEC",
    "PCII",
    "PERS",
    "PHYS",
    "PRIVILEGE",
    "PROCURE",
    "PROPIN",
    "PRVCY",
    "SSEL",
    "SSI",
    "STAT",
    "TAX",
    "UCNI",
];

/// ISO 3166-1 alpha-3, but for USA.
const TRIGRAPHS: &str = "ABW AFG AGO AIA ALA ALB AND ARE ARG ARM ASM ATA ATF ATG AUS AUT AZE BDI BEL BEN BES BFA BGD BGR \
    BHR BHS BIH BLM BLR BLZ BMU BOL BRA BRB BRN BTN BVT BWA CAF CAN CCK CHE CHL CHN CIV CMR COD COG COK COL COM CPV CRI CUB \
    CUW CXR CYM CYP CZE DEU DJI DMA DNK DOM DZA ECU EGY ERI ESH ESP EST ETH FIN FJI FLK FRA FRO FSM GAB GBR GEO GGY GHA GIB \
    GIN GLP GMB GNB GNQ GRC GRD GRL GTM GUF GUM GUY HKG HMD HND HRV HTI HUN IDN IMN IND IOT IRL IRN IRQ ISL ISR ITA JAM JEY \
    JOR JPN KAZ KEN KGZ KHM KIR KNA KOR KWT LAO LBN LBR LBY LCA LIE LKA LSO LTU LUX LVA MAC MAF MAR MCO MDA MDG MDV MEX MHL \
    MKD MLI MLT MMR MNE MNG MNP MOZ MRT MSR MTQ MUS MWI MYS MYT NAM NCL NER NFK NGA NIC NIU NLD NOR NPL NRU NZL OMN PAK PAN \
    PCN PER PHL PLW PNG POL PRI PRK PRT PRY PSE PYF QAT REU ROU RUS RWA SAU SDN SEN SGP SGS SHN SJM SLB SLE SLV SMR SOM SPM \
    SRB SSD STP SUR SVK SVN SWE SWZ SXM SYC SYR TCA TCD TGO THA TJK TKL TKM TLS TON TTO TUN TUR TUV TWN TZA UGA UKR UMI URY \
    UZB VAT VCT VEN VGB VIR VNM VUT WLF WSM YEM ZAF ZMB ZWE";

pub(super) fn knows_category(mark: &str) -> bool {
    CUI_CATEGORIES.contains(&mark)
}

/// Which country codes are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Codes {
    /// Those that Orb lists.
    Listed,
    /// Whatever has the shape of one.
    Any,
}

/// True for a trigraph of ISO 3166 and for the groups that Orb knows.
pub(super) fn is_listed(code: &str) -> bool {
    code == "USA" || is_group(code) || TRIGRAPHS.split_ascii_whitespace().any(|t| t == code)
}

/// Reads a whole banner.
pub(super) fn banner(text: &str, codes: Codes) -> Result<Marking> {
    let marking = read(text).map_err(|why| refused(text, &why))?;
    match marking.unlisted_codes().first() {
        Some(code) if codes == Codes::Listed => Err(refused(text, &no_code(code))),
        _ => Ok(marking),
    }
}

fn no_code(code: &str) -> String {
    format!("country code `{code}`: an ISO 3166 trigraph, ACGU, FVEY or TEYE")
}

fn read(text: &str) -> std::result::Result<Marking, String> {
    if text.starts_with("//") {
        return Err("non-US and joint markings are not supported".into());
    }
    let mut categories = text.split("//");
    let first = categories.next().unwrap_or_default();
    let rest: Vec<Vec<&str>> = categories.map(|c| c.split('/').collect()).collect();
    if first == "CUI" || first == "CONTROLLED" {
        return cui(&rest);
    }
    let level = Level::ALL.into_iter().find(|l| l.name() == first).ok_or_else(|| no_level(first))?;
    let mut marking = Marking::of(level);
    let mut entries = Entries::default();
    for (i, category) in rest.iter().enumerate() {
        match category[..] {
            ["LIMDIS"] if !marking.limdis => marking.limdis = true,
            _ if i == 0 => {
                for entry in category {
                    if let Some(control) = Control::ALL.into_iter().find(|c| c.name() == *entry) {
                        if !marking.controls.insert(control) {
                            return Err(format!("{entry} twice"));
                        }
                    } else if !entries.take(entry)? {
                        return Err(unknown(entry));
                    }
                }
            }
            _ => return Err(unknown(category.first().copied().unwrap_or_default())),
        }
    }
    let release_is_stated = entries.any();
    marking.release = entries.release()?;
    if release_is_stated && !level.is_classified() {
        return Err("release markings are of classified levels, and of CUI".into());
    }
    let has = |control| marking.controls.contains(&control);
    if has(Control::Orcon) && !level.is_classified() {
        return Err("ORCON is of classified levels".into());
    }
    if has(Control::Imcon) && (level < Level::Secret || !release_is_stated) {
        return Err("IMCON is of SECRET and above, beside a release marking".into());
    }
    Ok(marking)
}

/// `CUI`, then categories, then limited dissemination.
fn cui(rest: &[Vec<&str>]) -> std::result::Result<Marking, String> {
    let mut marking = Marking::CUI;
    let mut entries = Entries::default();
    let is_limit = |e: &&str| CUI_LIMITS.contains(e) || Entries::is_one(e);
    let (categories, limits) = match rest {
        [] => (&[][..], &[][..]),
        [one] if one.iter().all(is_limit) => (&[][..], &one[..]),
        [one] => (&one[..], &[][..]),
        [one, two] => (&one[..], &two[..]),
        _ => return Err("more than categories and limited dissemination after CUI".into()),
    };
    for mark in categories {
        let bare = mark.strip_prefix("SP-").unwrap_or(mark);
        let sound =
            (2..=16).contains(&bare.len()) && bare.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit());
        if !sound || is_limit(mark) {
            return Err(format!("`{mark}` is no category mark of CUI"));
        }
        let set = if bare == *mark { &mut marking.cui_basic } else { &mut marking.cui_specified };
        if !set.insert((*mark).to_owned()) {
            return Err(format!("{mark} twice"));
        }
    }
    for entry in limits {
        if let Some(limit) = CUI_LIMITS.iter().find(|l| *l == entry) {
            if !marking.cui_limits.insert(limit) {
                return Err(format!("{entry} twice"));
            }
        } else if *entry == "RELIDO" || !entries.take(entry)? {
            return Err(format!("`{entry}` is no limited dissemination control of CUI"));
        }
    }
    marking.release = entries.release()?;
    Ok(marking)
}

/// Release markings as they are met.
#[derive(Default)]
struct Entries {
    noforn: bool,
    audience: Audience,
}

impl Entries {
    fn is_one(entry: &str) -> bool {
        matches!(entry, "NOFORN" | "RELIDO") || entry.starts_with("REL TO ") || entry.starts_with("DISPLAY ONLY ")
    }

    /// False where the entry is no release marking.
    fn take(&mut self, entry: &str) -> std::result::Result<bool, String> {
        let twice = || format!("{entry} twice");
        if !Entries::is_one(entry) {
            return Ok(false);
        }
        if let Some(list) = entry.strip_prefix("REL TO ") {
            let mut codes = codes(list)?;
            if !codes.remove("USA") || codes.is_empty() {
                return Err("REL TO lists USA and at least one more".into());
            }
            if !self.audience.rel_to.is_empty() {
                return Err("REL TO twice".into());
            }
            self.audience.rel_to = codes;
        } else if let Some(list) = entry.strip_prefix("DISPLAY ONLY ") {
            let codes = codes(list)?;
            if codes.contains("USA") || !self.audience.display.is_empty() {
                return Err("DISPLAY ONLY lists countries beside USA, once".into());
            }
            self.audience.display = codes;
        } else {
            let flag = if entry == "NOFORN" { &mut self.noforn } else { &mut self.audience.relido };
            if std::mem::replace(flag, true) {
                return Err(twice());
            }
        }
        Ok(true)
    }

    fn any(&self) -> bool {
        self.noforn || self.audience != Audience::default()
    }

    fn release(self) -> std::result::Result<Release, String> {
        let released = self.audience != Audience::default();
        let Audience { rel_to, display, relido } = &self.audience;
        match self.noforn {
            true if released => Err("NOFORN beside a release marking".into()),
            true => Ok(Release::Noforn),
            false if !released => Ok(Release::Unstated),
            false if *relido && !display.is_empty() => Err("RELIDO beside DISPLAY ONLY".into()),
            false if !rel_to.is_disjoint(display) => Err("DISPLAY ONLY lists whom REL TO lists".into()),
            false => Ok(Release::To(self.audience)),
        }
    }
}

fn codes(list: &str) -> std::result::Result<BTreeSet<String>, String> {
    let mut all = BTreeSet::new();
    for code in list.split(", ") {
        if !is_code(code) {
            return Err(no_code(code));
        }
        if !all.insert(code.to_owned()) {
            return Err(format!("country code {code} twice"));
        }
    }
    Ok(all)
}

fn no_level(first: &str) -> String {
    let upper = first.trim().to_ascii_uppercase();
    if Level::ALL.iter().any(|l| l.name() == upper) && upper != first {
        return "write the banner in upper case and without spaces around it".into();
    }
    match first {
        "U" | "C" | "S" | "TS" | "R" => "a banner is spelled out; abbreviations are for portions".into(),
        "FOUO" | "FOR OFFICIAL USE ONLY" => fouo(),
        _ if first.contains("NATO") || first.contains("COSMIC") => "NATO markings are not supported".into(),
        _ => format!("no level `{first}`"),
    }
}

fn fouo() -> String {
    "FOUO is a retired marking: its owner must re-mark it; Orb never turns it into CUI".into()
}

fn unknown(entry: &str) -> String {
    let head = entry.split([' ', '-']).next().unwrap_or_default();
    match head {
        "" => "an empty entry".into(),
        "FOUO" | "FOR" => fouo(),
        "SI" | "TK" | "HCS" | "KDK" | "RSV" | "BUR" | "KLM" => {
            format!("`{entry}`: SCI control systems are not supported")
        }
        "SAR" | "SPECIAL" | "HVSACO" => format!("`{entry}`: special access programs are not supported"),
        "RD" | "FRD" | "TFNI" | "CNWDI" | "DOD" | "DOE" => {
            format!("`{entry}`: Atomic Energy Act markings are not supported")
        }
        "FGI" | "NATO" | "JOINT" | "ATOMAL" => format!("`{entry}`: foreign and joint markings are not supported"),
        "LIMDIS" => "LIMDIS once, in a category of its own behind the dissemination controls".into(),
        "CUI" => "CUI does not stand in a classified banner".into(),
        _ => format!("`{entry}` is no control that Orb supports"),
    }
}

fn refused(text: &str, why: &str) -> Error {
    Error::policy("classification")
        .expected("UNCLASSIFIED, CUI, CONFIDENTIAL, SECRET or TOP SECRET, with the controls that docs/audit.md lists")
        .found(format!("MARKING_UNSUPPORTED: {text:?}: {why}"))
        .advice("Orb never strips or ignores a part of a marking. Nothing was written.")
}
