use super::*;
use crate::audit::TrustStore;
use crate::audit::keys::tests::shared_key;
use crate::audit::publication::tests::publish;
use crate::audit::verify::{Request, read_record, verify};

const NOW_MS: u64 = 1_763_700_000_000;

fn with_report(trusted: bool, spoil: impl FnOnce(&Path), look: impl FnOnce(&Evidence<'_>)) {
    let dir = tempfile::tempdir().unwrap();
    publish(dir.path());
    let folder = dir.path().join("out");
    spoil(&folder);
    let mut trust = TrustStore::default();
    if trusted {
        trust.insert(shared_key().public().clone());
    }
    let report = verify(&Request::new(&folder, &trust, NOW_MS)).unwrap();
    let records = [read_record(&folder).unwrap().1];
    look(&Evidence { report: &report, records: &records, folder: Some(&folder), as_of_ms: NOW_MS });
}

#[test]
fn a_page_with_everything_and_nothing_from_elsewhere() {
    with_report(
        true,
        |_| {},
        |evidence| {
            let html = to_html(evidence).unwrap();
            assert_eq!(html.matches("UNCLASSIFIED</div>").count(), 2);
            for word in [
                "PASS",
                "Controls",
                "AU-10",
                "van.jpg",
                "scene.ply",
                "openssl dgst -sha256 -verify",
                "RS256",
                "Programs",
                "Jane Doe",
                "P6Y",
            ] {
                assert!(html.contains(word), "{word}");
            }
            let trail_hash = evidence.report.trail_hash.as_ref().unwrap();
            assert!(html.contains(trail_hash));
            assert!(!html.contains("<script") && !html.contains("http://") && !html.contains("src="));
            assert_eq!(html, to_html(evidence).unwrap());
            for claim in ["certified", "compliant", "authorised by"] {
                assert!(!html.contains(claim), "{claim}");
            }
            let markdown = to_markdown(evidence).unwrap();
            assert!(markdown.starts_with("**UNCLASSIFIED**") && markdown.ends_with("**UNCLASSIFIED**\n"));
        },
    );
}

#[test]
fn an_unverified_record_is_not_quoted() {
    with_report(
        false,
        |_| {},
        |evidence| {
            let html = to_html(evidence).unwrap();
            assert!(html.contains("INCOMPLETE") && html.contains("MARKING NOT VERIFIED"));
            // A finding may name what it is about; nothing else of the record is repeated.
            assert!(!html.contains("jane") && !html.contains("<h2>Inputs</h2>") && !html.contains("<h2>Events</h2>"));
            assert!(html.contains("nothing that can be relied on"));
        },
    );
}

#[test]
fn hostile_words_stay_words() {
    let document = Document {
        banner: "A<B".into(),
        title: "x".into(),
        sections: vec![Section {
            title: "t",
            blocks: vec![
                Block::Text("<script>alert(1)</script> & \"q\"".into()),
                Block::Table { head: vec!["h"], rows: vec![vec!["a|b <i>".into()]] },
            ],
        }],
    };
    let html = html::render(&document);
    assert!(!html.contains("<script>") && !html.contains("<i>") && html.contains("A&lt;B"));
    let markdown = markdown::render(&document);
    assert!(!markdown.contains("<script>") && markdown.contains("a\\|b &lt;i>"), "{markdown}");
}

#[test]
fn a_finding_stands_first() {
    with_report(
        true,
        |folder| std::fs::write(folder.join("scene.ply"), "changed").unwrap(),
        |evidence| {
            let html = to_html(evidence).unwrap();
            let (finding, note) = (html.find("OUTPUT_DIGEST").unwrap(), html.find("TAIL_UNANCHORED").unwrap());
            assert!(finding < note && html.contains("FAIL") && html.contains("must not be relied on"));
        },
    );
}

/// What a record says of its time, its place and its marking stands in the report in the words of its case.
#[test]
fn words_for_each_case() {
    use crate::audit::marking::authority::Authority;
    let of = |change: fn(&mut Statement)| {
        let mut text = String::new();
        with_report(
            true,
            |_| {},
            |evidence| {
                let mut records = evidence.records.to_vec();
                records.iter_mut().for_each(change);
                text = to_markdown(&Evidence { records: &records, ..*evidence }).unwrap();
            },
        );
        text
    };
    let plain = of(|_| {});
    for words in ["by its kernel: 1;", "podman", "0 name the operator by an authority's certificate", "AC-2", "3.13.11"]
    {
        assert!(plain.contains(words), "{words} in {plain}");
    }
    assert!(!plain.contains("time server") && !plain.contains("Marking blocks") && !plain.contains("NTP"), "{plain}");

    let asked = of(|s| {
        let time = &mut s.predicate.time;
        time.source = Source::NtpQuery;
        (time.stratum, time.reference) = (Some(1), Some("10.0.0.1 (GPS)".into()));
    });
    assert!(asked.contains("by its kernel: 0;") && asked.contains("| 0 | 10.0.0.1 (GPS) | 1 | -1 | 1 |"), "{asked}");

    let classified = of(|s| {
        s.predicate.actor.auth = "pki".into();
        s.predicate.actor.key_source = "pkcs11".into();
        s.predicate.marking.raised_reason = Some("compilation".into());
        s.predicate.marking.authority = Some(Authority {
            classified_by: "J. Doe, analyst".into(),
            derived_from: "Multiple Sources".into(),
            declassify_on: "20400101".into(),
            date_of_origin: "20261121".into(),
            sources: vec!["Guide A".into()],
        });
    });
    for words in
        ["J. Doe, analyst", "Guide A", "20400101", "compilation", "1 name the operator by", "1 are signed in a token"]
    {
        assert!(classified.contains(words), "{words} in {classified}");
    }
}
