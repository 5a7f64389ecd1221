//! Country codes beyond those that Orb lists: a register of the user's own, for coalitions and for codes that are newer.
//!
//! Orb knows no members of them. Such a code stands for itself: two lists have it in common only where both name it.

use std::collections::BTreeSet;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::Marking;
use crate::audit::canonical::sha256_hex;
use crate::audit::disk;
use crate::{Error, Result};

/// Largest register that is read, bytes.
const MAX_BYTES: u64 = 1 << 20;

/// A register of the user's, or of its codes those that a record's markings use.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CountryRegister {
    /// Of the register's file.
    pub sha256: String,
    /// Three or four capital letters each, sorted.
    pub codes: Vec<String>,
}

impl CountryRegister {
    /// Reads a file with a code at the beginning of each line, and after it anything. Empty lines and those that begin with
    /// `#` say nothing.
    ///
    /// # Errors
    /// [`crate::Kind::Usage`] naming the file and the line that begins otherwise, or a file without any code;
    /// [`crate::Kind::Environment`] when it cannot be read.
    pub fn read(path: &Path) -> Result<CountryRegister> {
        let bytes = disk::read_limited(path, MAX_BYTES)?;
        let mut codes = BTreeSet::new();
        for (n, line) in String::from_utf8_lossy(&bytes).lines().enumerate() {
            let Some(word) = line.split_whitespace().next().filter(|word| !word.starts_with('#')) else { continue };
            if !is_code(word) {
                return Err(Error::usage(format!("{}, line {}", path.display(), n + 1))
                    .expected("a code of three or four capital letters, and then anything")
                    .found(format!("{:?}", line.trim().chars().take(80).collect::<String>()))
                    .advice("`#` begins a remark."));
            }
            codes.insert(word.to_owned());
        }
        if codes.is_empty() {
            return Err(Error::usage(path.display().to_string())
                .expected("at least one line that begins with a code of three or four capital letters")
                .found("none"));
        }
        Ok(CountryRegister { sha256: sha256_hex(&bytes), codes: codes.into_iter().collect() })
    }

    /// Of a register that may not be there the part that these markings need: `None` where they need none.
    ///
    /// # Errors
    /// [`crate::Kind::Policy`], `MARKING_UNSUPPORTED`, for a code that is on no list.
    pub fn used_by<'a>(
        register: Option<&CountryRegister>,
        markings: impl IntoIterator<Item = &'a Marking>,
    ) -> Result<Option<CountryRegister>> {
        let mut codes = BTreeSet::new();
        for marking in markings {
            for code in marking.unlisted_codes() {
                if !register.is_some_and(|r| r.has(code)) {
                    return Err(Error::policy("classification")
                        .expected("country codes of ISO 3166, ACGU, FVEY, TEYE, or of --country-register FILE")
                        .found(format!("MARKING_UNSUPPORTED: {marking}: country code `{code}`"))
                        .advice("Orb never strips or ignores a part of a marking. Nothing was written."));
                }
                codes.insert(code.to_owned());
            }
        }
        let Some(register) = register.filter(|_| !codes.is_empty()) else { return Ok(None) };
        Ok(Some(CountryRegister { sha256: register.sha256.clone(), codes: codes.into_iter().collect() }))
    }

    pub fn has(&self, code: &str) -> bool {
        self.codes.iter().any(|c| c == code)
    }

    /// Says why a record cannot state this.
    pub(in crate::audit) fn check(&self) -> std::result::Result<(), String> {
        match self.codes.iter().find(|code| !is_code(code)) {
            Some(code) => {
                Err(format!("marking.country_register.codes: {code:?}: expected three or four capital letters"))
            }
            None if self.codes.is_empty() => Err("marking.country_register.codes: expected at least one".into()),
            None => Ok(()),
        }
    }
}

/// A trigraph or a tetragraph by its shape.
pub(super) fn is_code(word: &str) -> bool {
    (3..=4).contains(&word.len()) && word.bytes().all(|b| b.is_ascii_uppercase())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;
    use crate::audit::marking::authority::Authority;
    use crate::audit::marking::handling::{Handling, Request};

    fn register(text: &str) -> Result<CountryRegister> {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("codes.txt");
        std::fs::write(&path, text).unwrap();
        CountryRegister::read(&path)
    }

    #[test]
    fn registers_that_are_good_and_registers_that_are_not() {
        let good = register("# of the unit\nZZTF  a task force, invented\n\nQQQ\tinvented\r\nZZTF again\n").unwrap();
        assert_eq!(good.codes, ["QQQ", "ZZTF"]);
        assert!(good.has("QQQ") && !good.has("QQ") && good.sha256.len() == 64);
        for (text, line, found) in [
            ("ZZTF\nzztf x\n", 2, "\"zztf x\""),
            ("QQ", 1, "\"QQ\""),
            ("\n\nABCDE", 3, "\"ABCDE\""),
            ("A1B", 1, "\"A1B\""),
        ] {
            let error = register(text).unwrap_err();
            assert_eq!((error.kind, error.found.as_str()), (Kind::Usage, found));
            assert!(error.subject.ends_with(&format!("codes.txt, line {line}")), "{error}");
        }
        assert_eq!(register("# none\n").unwrap_err().found, "none");
        assert_eq!(CountryRegister::read(Path::new("/nowhere/codes.txt")).unwrap_err().kind, Kind::Environment);
    }

    #[test]
    fn codes_of_a_register_join_only_with_themselves() {
        let read = |text: &str| Marking::read(text).unwrap();
        let (ours, wider) = (read("SECRET//REL TO USA, QQQ, ZZTF"), read("SECRET//REL TO USA, GBR, ZZTF"));
        assert_eq!(ours.banner(), "SECRET//REL TO USA, QQQ, ZZTF");
        assert_eq!(ours.unlisted_codes(), ["QQQ", "ZZTF"]);
        assert_eq!(ours.join(&wider).banner(), "SECRET//REL TO USA, ZZTF");
        assert_eq!(ours.join(&read("SECRET//REL TO USA, FVEY")).banner(), "SECRET//NOFORN");
        assert!(ours.join(&wider).covers(&ours) && !ours.covers(&wider));
        assert!(read("SECRET//REL TO USA, FVEY/DISPLAY ONLY FRA").unlisted_codes().is_empty());
        assert_eq!(read("CUI//REL TO USA, QQQ").unlisted_codes(), ["QQQ"]);
        assert!(Marking::parse("SECRET//REL TO USA, QQQ").unwrap_err().found.contains("country code `QQQ`"));
        for text in ["SECRET//REL TO USA, qqq", "SECRET//REL TO USA, QQ", "SECRET//REL TO USA, QQQQQ", "SECRET//QQQ"] {
            assert!(Marking::read(text).is_err(), "{text}");
        }
    }

    /// Without a register, or with one that lacks the code, nothing is marked with it, and nothing is made of what is.
    #[test]
    fn only_what_a_register_holds() {
        let all = register("QQQ\nZZTF\n").unwrap();
        let marked = Marking::read("SECRET//REL TO USA, QQQ").unwrap();
        let decide = |banner: Option<&str>, register: Option<&CountryRegister>, input: Option<&Marking>| {
            let authority = Some(Authority {
                classified_by: "J. Doe, analyst".into(),
                derived_from: "Guide, Agency, 20240105".into(),
                declassify_on: "20400101".into(),
                date_of_origin: "20261121".into(),
                sources: vec![],
            });
            let (banner, register) = (banner.map(str::to_owned), register.cloned());
            Request { banner, authority, register, ..Request::default() }.decide([input])
        };
        let used = |result: Result<Handling>| result.unwrap().register.map(|r| (r.sha256, r.codes));
        let listed = Some((all.sha256.clone(), vec!["QQQ".to_owned()]));
        assert_eq!(used(decide(Some("SECRET//REL TO USA, QQQ"), Some(&all), None)), listed);
        assert_eq!(used(decide(None, Some(&all), Some(&marked))), listed);
        assert_eq!(used(decide(Some("SECRET//REL TO USA, GBR"), Some(&all), None)), None);
        let other = register("ZZTF\n").unwrap();
        for result in [
            decide(Some("SECRET//REL TO USA, QQQ"), None, None),
            decide(Some("SECRET//REL TO USA, QQQ"), Some(&other), None),
            decide(None, None, Some(&marked)),
            decide(None, Some(&other), Some(&marked)),
        ] {
            let error = result.unwrap_err();
            assert!(error.kind == Kind::Policy && error.found.starts_with("MARKING_UNSUPPORTED"), "{error}");
            assert!(error.found.contains("`QQQ`") && error.expected.contains("--country-register"), "{error}");
        }
    }

    /// A verifier needs no register: the record says which codes its operator's had, and no other is taken.
    #[test]
    fn a_record_says_what_its_register_had() {
        use serde_json::json;

        use crate::audit::TrustStore;
        use crate::audit::keys::tests::shared_key;
        use crate::audit::publication::tests::publish;
        use crate::audit::verify::tests::forge;
        use crate::audit::verify::{Request, verify};
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let out = dir.path().join("out");
        let mut trust = TrustStore::default();
        trust.insert(shared_key().public().clone());
        let found = |code: &str| {
            let report = verify(&Request::new(&out, &trust, 1_763_700_000_000)).unwrap();
            report.findings.iter().filter(|f| f.code == code).map(|f| f.actual.clone()).collect::<Vec<_>>()
        };
        let banner = "SECRET//REL TO USA, QQQ";
        let ism = serde_json::to_value(Marking::read(banner).unwrap().ism()).unwrap();
        let mark = |codes: Option<&[&str]>| {
            forge(&out, shared_key(), |v| {
                v["predicate"]["inputs"][0]["marking"] = json!(banner);
                v["predicate"]["marking"] = json!({"profile": "dod", "banner": banner, "ism": ism});
                if let Some(codes) = codes {
                    v["predicate"]["marking"]["country_register"] = json!({"sha256": "ab".repeat(32), "codes": codes});
                }
            });
        };
        mark(Some(&["QQQ", "ZZTF"]));
        assert_eq!((found("MARKING_UNSUPPORTED"), found("SCHEMA_INVALID")), (vec![], vec![]));
        for codes in [None, Some(&["ZZTF"][..])] {
            mark(codes);
            assert_eq!(found("MARKING_UNSUPPORTED"), [banner], "{codes:?}");
        }
        for codes in [&[][..], &["qqq"], &["QQQQQ"]] {
            mark(Some(codes));
            assert_eq!(found("SCHEMA_INVALID").len(), 1, "{codes:?}");
        }
    }
}
