//! The classification authority block of derivatively classified work, and the designation indicator block of CUI.
//!
//! 32 CFR 2001.22 and IC Markings Manual (2016), section E; DoDI 5200.48. Original classification is no tool's business.

use serde::{Deserialize, Serialize};

use crate::audit::time;
use crate::{Error, Result};

/// Who answers for a classified product, from what, and until when.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Authority {
    /// Name and position, or a personal identifier; with agency and office where they are not evident.
    pub classified_by: String,
    /// Title, agency and date of the source or guide; `Multiple Sources`.
    pub derived_from: String,
    pub declassify_on: String,
    /// `YYYYMMDD`.
    pub date_of_origin: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sources: Vec<String>,
}

/// Who controls CUI and how it may spread.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Designation {
    pub controlled_by: String,
    pub office: String,
    pub category: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dissemination: Option<String>,
    pub poc: String,
}

const MULTIPLE: &str = "Multiple Sources";
/// Longest line of a block, bytes.
const MAX_LINE: usize = 300;

impl Authority {
    /// Checks every line.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `AUTHORITY_INVALID`, naming the line.
    pub fn check(&self) -> Result<()> {
        line("--classified-by", &self.classified_by)?;
        line("--derived-from", &self.derived_from)?;
        self.sources.iter().try_for_each(|s| line("--source", s))?;
        declassification(&self.declassify_on, &self.date_of_origin)
            .map_err(|why| invalid("--declassify-on", &self.declassify_on, &why))?;
        match (self.derived_from == MULTIPLE, self.sources.len()) {
            (true, 0 | 1) => Err(invalid("--source", MULTIPLE, "Multiple Sources are listed, two or more")),
            (false, 1..) => {
                Err(invalid("--derived-from", &self.derived_from, "a list of sources is of Multiple Sources"))
            }
            _ => Ok(()),
        }
    }
}

impl Designation {
    /// # Errors
    /// As [`Authority::check`].
    pub fn check(&self) -> Result<()> {
        line("--cui-controlled-by", &self.controlled_by)?;
        line("--cui-office", &self.office)?;
        line("--cui-category", &self.category)?;
        line("--cui-poc", &self.poc)?;
        self.dissemination.iter().try_for_each(|d| line("--cui-dissemination", d))
    }
}

fn line(option: &str, text: &str) -> Result<()> {
    match text {
        _ if text.trim().is_empty() => Err(invalid(option, text, "a line of text")),
        _ if text.len() > MAX_LINE => Err(invalid(option, text, &format!("at most {MAX_LINE} bytes"))),
        _ if text.chars().any(char::is_control) => Err(invalid(option, text, "one line without control characters")),
        _ => Ok(()),
    }
}

fn invalid(option: &str, text: &str, why: &str) -> Error {
    Error::policy(option)
        .expected(why)
        .found(format!("AUTHORITY_INVALID: {text:?}"))
        .advice("Nothing was written. The source or guide that the product is derived from says it.")
}

/// Values of ISOO's grammar that may stand on the line; `origin` is the date of the product, `YYYYMMDD`.
fn declassification(text: &str, origin: &str) -> std::result::Result<(), String> {
    let upper = text.trim().to_ascii_uppercase();
    let retired =
        ["OADR", "MR", "MANUAL REVIEW", "DNI ONLY", "DCI ONLY", "X1", "X2", "X3", "X4", "X5", "X6", "X7", "X8"];
    if retired.contains(&upper.as_str())
        || upper.starts_with("SOURCE MARKED")
        || upper.contains("SUBJECT TO TREATY")
        || upper.replace(' ', "") == "25X1-HUMAN"
        || upper.starts_with("ORIGINATING AGENCY")
    {
        return Err("a value that is not retired".into());
    }
    if let [a, b, b'X', rest @ ..] = upper.as_bytes()
        && a.is_ascii_digit()
        && b.is_ascii_digit()
    {
        return exemption([*a, *b], rest);
    }
    if upper.starts_with("N/A TO ") {
        let sound = upper.ends_with(" PORTIONS. SEE SOURCE LIST FOR NSI PORTIONS.");
        return if sound { Ok(()) } else { Err("N/A to … portions. See source list for NSI portions.".into()) };
    }
    if upper.bytes().all(|b| b.is_ascii_digit()) {
        let (until, from) = (date(&upper).ok_or("a date YYYYMMDD")?, date(origin).ok_or("a date of origin YYYYMMDD")?);
        return match (until > from, until <= from + 25_0000) {
            (false, _) => Err("a date after the product's own".into()),
            (_, false) => Err("a date within 25 years, or an exemption".into()),
            _ => Ok(()),
        };
    }
    line("", text).map_err(|_| "a date, an event or an exemption".into())
}

/// `25X1, DATE OR EVENT`; `50X1-HUM` and `50X2-WMD` stand alone.
fn exemption(years: [u8; 2], rest: &[u8]) -> std::result::Result<(), String> {
    let wrong = || Err("25X1 to 25X9, 50X1 to 50X9 or 75X1 to 75X9, a comma and a date or an event".to_owned());
    match (&years, rest) {
        (b"50", b"1-HUM" | b"2-WMD") => Ok(()),
        (b"25" | b"50" | b"75", [b'1'..=b'9', b',', b' ', event @ ..]) => {
            let text = String::from_utf8_lossy(event);
            let dated = text.bytes().all(|b| b.is_ascii_digit());
            if text.trim().is_empty() || (dated && date(&text).is_none()) { wrong() } else { Ok(()) }
        }
        _ => wrong(),
    }
}

/// `YYYYMMDD` as one number; none where there is no such day.
fn date(text: &str) -> Option<u32> {
    let (y, m, d) = (text.get(..4)?, text.get(4..6)?, text.get(6..8)?);
    (text.len() == 8 && time::parse_utc(&format!("{y}-{m}-{d}T00:00:00.000Z")).is_some()).then(|| text.parse().ok())?
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(declassify_on: &str) -> Authority {
        Authority {
            classified_by: "J. Doe, geospatial analyst, 1st Example Squadron".into(),
            derived_from: "Example Guide, Example Agency, 20240105".into(),
            declassify_on: declassify_on.into(),
            date_of_origin: "20261121".into(),
            sources: vec![],
        }
    }

    #[test]
    fn declassification_instructions() {
        for sound in [
            "20511121",
            "20261122",
            "Completion of exercise EXAMPLE",
            "25X1, 20760101",
            "25X1, EO 12951",
            "50X9, withdrawal of the system",
            "75X3, 21010101",
            "50X1-HUM",
            "50X2-WMD",
            "N/A to RD portions. See source list for NSI portions.",
        ] {
            assert_eq!(block(sound).check(), Ok(()), "{sound}");
        }
        for wrong in [
            "",
            "20511122",
            "20261121",
            "20300230",
            "2030",
            "OADR",
            "X1",
            "MR",
            "DNI Only",
            "25X1",
            "25X1-human",
            "25X0, 20400101",
            "25X1, 20401301",
            "30X1, 20400101",
            "50X3-HUM",
            "Subject to treaty or international agreement",
            "Source marked OADR",
            "N/A to RD portions",
            "two\nlines",
        ] {
            let error = block(wrong).check().expect_err(wrong);
            assert!(
                error.found.contains("AUTHORITY_INVALID") && error.subject == "--declassify-on",
                "{wrong}: {error}"
            );
        }
    }

    #[test]
    fn several_sources_are_listed() {
        let mut many = Authority { derived_from: MULTIPLE.into(), ..block("20400101") };
        assert!(many.check().is_err());
        many.sources = vec!["Guide A, Agency, 20240105".into(), "Report B, Agency, 20250203".into()];
        assert_eq!(many.check(), Ok(()));
        many.derived_from = "Guide A".into();
        assert!(many.check().is_err());
        let nobody = Authority { classified_by: " ".into(), ..block("20400101") };
        assert_eq!(nobody.check().unwrap_err().subject, "--classified-by");
    }
}
