//! Reports of ledgers: the picture of one, the records that a control's evidence is, the days on which certificates end.

use std::collections::BTreeSet;

use super::tests::{NOW_MS, picture_of, with_report};
use super::*;
use crate::audit::DataFolder;
use crate::audit::keys::{KeySource, SigningKey};
use crate::audit::ledger::Ledger;
use crate::audit::publication::Publication;
use crate::audit::publication::tests::{destination, fill};
use crate::audit::record::tests::draft;
use crate::audit::report::Range;
use crate::audit::statement::Outcome;
use crate::audit::trust::tests::Pki;
use crate::audit::trust::{self, Entry, chains_in};
use crate::audit::verify::{Request, read_record, verify};

const HOUR_MS: u64 = 3_600_000;
const KINDS: [&str; 6] =
    ["scene.generate", "verify.run", "run.failed", "ledger.checkpoint", "key.generate", "scene.export"];

/// `n` records of a ledger, an hour between each ten of them; no one of them signed, as the picture is of a report's words.
fn records(record: &Statement, n: u64) -> Vec<Statement> {
    let one = |seq: u64| {
        let mut s = record.clone();
        let p = &mut s.predicate;
        p.chain.seq = seq;
        p.time.utc = time::format_utc(NOW_MS + HOUR_MS * (seq / 10) + seq);
        p.event.kind = KINDS[((seq + seq / 10) % 6) as usize].into();
        if p.event.kind == "run.failed" {
            (p.event.outcome, p.event.error_code) = (Outcome::Failure, Some("INPUT".into()));
        }
        if !p.event.kind.starts_with("scene.") {
            s.subject.clear();
            s.predicate.inputs.clear();
        }
        s
    };
    (0..n).map(one).collect()
}

/// The report of a ledger of `n` records, changed.
fn of_ledger(n: u64, change: impl Fn(&mut Report, &mut Vec<Statement>)) -> (String, String) {
    let mut texts = Default::default();
    with_report(
        true,
        |_| {},
        |evidence| {
            let (mut report, mut records) = (evidence.report.clone(), records(&evidence.records[0], n));
            report.findings.clear();
            report.range = Some(Range { first: 0, last: n - 1 });
            change(&mut report, &mut records);
            let evidence = Evidence { report: &report, records: &records, folder: None, ..*evidence };
            texts = (to_html(&evidence).unwrap(), to_markdown(&evidence).unwrap());
        },
    );
    texts
}

fn number(tag: &str, name: &str) -> f64 {
    let (_, rest) = tag.split_once(&format!(" {name}=\"")).unwrap();
    rest.split('"').next().unwrap().parse().unwrap()
}

#[test]
fn a_ledger_as_a_picture() {
    let (html, markdown) = of_ledger(400, |report, _| {
        report.anchored_through = Some(299);
        let mut finding = Finding::new("TIME_ROLLBACK", "time.utc");
        finding.seq = Some(17);
        report.findings.push(finding);
    });
    let (svg, words) = picture_of("lineage timeline", &html);
    for line in [
        "400 records from 2025-11-21T04:40:00.000Z to 2025-11-22T19:40:00.399Z",
        "anchored through record 299; 100 records after it not anchored",
        "run.failed: ",
        "of a failure or refusal",
        "in which an error was found",
    ] {
        assert!(words[1].contains(line), "{line} in {}", words[1]);
        assert!(markdown.contains(line), "{line} in {markdown}");
    }
    // Every record stands in one bar, in the lane of its kind, and those of the tail in hollow ones.
    let bars: Vec<u64> = words.iter().filter_map(|w| w.split_once(": record")?.0.parse().ok()).collect();
    assert_eq!(bars.iter().sum::<u64>(), 400);
    let (filled, hollow) = (svg.matches("class=\"bar\"").count(), svg.matches("class=\"tail\"").count());
    assert!(filled > 2 * hollow && hollow > 20, "{filled} {hollow}");
    assert_eq!(svg.matches(">!</text>").count(), 1);
    assert!(svg.matches(">×</text>").count() > 20 && words.iter().any(|w| w == "anchored through record 299"));
    for kind in KINDS {
        assert!(words.iter().any(|w| w == kind), "{kind}");
    }
    assert_eq!(words.iter().filter(|w| *w == "UNCLASSIFIED").count(), 2, "marked also when it is cut out of its page");
    assert!(!svg.contains("href") && !svg.contains("url(") && !svg.contains("style="));
    // Bars stand in the picture, apart from one another, and within their lane.
    let bars: Vec<[f64; 4]> = svg
        .split("<rect ")
        .skip(1)
        .map(|tag| ["x", "y", "width", "height"].map(|name| number(&format!(" {tag}"), name)))
        .collect();
    for (i, [x, y, width, height]) in bars.iter().enumerate() {
        assert!(*x >= 196.0 && x + width <= 936.1 && *y > 64.0 && *height > 0.0 && *height <= 20.1, "{x} {y} {height}");
        for [x2, y2, width2, height2] in &bars[..i] {
            let apart = x2 + width2 <= *x || x + width <= *x2 || y2 + height2 <= y + 0.11 || y + height <= y2 + 0.11;
            assert!(apart, "{:?} over {:?}", bars[i], [x2, y2]);
        }
    }
}

/// One record, all at once, ten thousand, kinds without an end, no anchor and every record anchored: always a picture.
#[test]
fn a_picture_of_any_ledger() {
    for (n, anchored, words) in [
        (1, None, "no record is anchored"),
        (1, Some(0), "0 records after it not anchored"),
        (3000, Some(2999), "0 records after it not anchored"),
    ] {
        let (html, _) = of_ledger(n, |report, _| report.anchored_through = anchored);
        let (svg, said) = picture_of("lineage timeline", &html);
        assert!(said[1].contains(words), "{n}: {}", said[1]);
        assert_eq!(svg.contains("class=\"tail\""), anchored.is_none(), "{n}");
        assert!(svg.len() < 400_000, "{n}: {}", svg.len());
    }
    let (html, _) = of_ledger(50, |_, records| {
        for (i, s) in records.iter_mut().enumerate() {
            s.predicate.event.kind = format!("<kind> {} {i}", "x".repeat(i * 9));
            s.predicate.time.utc = time::format_utc(NOW_MS);
        }
    });
    let (svg, said) = picture_of("lineage timeline", &html);
    assert!(!svg.contains("<kind>") && said.iter().any(|w| w == "others"), "{said:?}");
    // A folder has its lineage.
    with_report(
        true,
        |_| {},
        |evidence| assert!(!to_html(evidence).unwrap().contains("<figure class=\"lineage timeline\"")),
    );
}

/// What a control's evidence is stands in the page, and is what the words say.
#[test]
fn links_from_controls_to_records() {
    let (html, markdown) = of_ledger(60, |report, _| report.anchored_through = Some(49));
    let ids: BTreeSet<&str> = html.split(" id=\"record-").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert_eq!(ids.len(), 60);
    let links: Vec<&str> =
        html.split("<a href=\"#record-").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert!(links.len() > 20 && links.iter().all(|n| ids.contains(n)), "{links:?}");
    let row = |control: &str| markdown.lines().find(|l| l.starts_with(&format!("| {control}"))).unwrap();
    for (control, records) in [
        ("AU-2", "[0](#record-0) to [59](#record-59)"),
        ("AU-9", "anchored through record 49: records [0](#record-0) to [49](#record-49)"),
        ("AC-2", "nothing: the command line has no accounts"),
        ("CMMC SC.L2-3.13.11", "nothing: what is here"),
    ] {
        assert!(row(control).contains(records), "{control}: {}", row(control));
    }
    // Files: only records that read or wrote some, or verified them.
    assert!(!row("HIPAA").contains("[2](") && !row("MP-3").contains("[1]("), "{} {}", row("HIPAA"), row("MP-3"));
    assert!(markdown.contains("| <a id=\"record-7\"></a>7 | "), "{markdown}");
    // A server's accounts are evidence for AC-2.
    let (_, markdown) = of_ledger(60, |_, records| records[5].predicate.event.kind = "account.add".into());
    assert!(markdown.contains("1 record of accounts and sessions of orb serve: record [5](#record-5)"), "{markdown}");
    // What nobody trusted signed is not there to be linked to.
    with_report(false, |_| {}, |evidence| assert!(!to_html(evidence).unwrap().contains("#record-")));
}

/// A folder signed under certificates of OpenSSL's making, looked at before and after they end.
#[test]
fn the_days_on_which_certificates_end() {
    let Some(pki) = Pki::new() else { return };
    pki.sign("leaf", "issuing", "leaf", "20250101000000Z", "20280101000000Z");
    std::fs::write(pki.path("chain.pem"), pki.chain()).unwrap();
    let key = SigningKey::load(&pki.path("leaf.key"), KeySource::NamedFile).unwrap();
    let key = key.with_chain(&pki.path("chain.pem")).unwrap();
    let mut publication = Publication::begin(&destination(&pki.path("out"))).unwrap();
    fill(&mut publication).unwrap();
    publication.seal(&draft(), &key, &mut Ledger::at(pki.path("orb-ledger.jsonl"))).unwrap();
    let data = DataFolder::at(pki.path("data"));
    let entry = Entry { schema: trust::SCHEMA.into(), ..Entry::default() };
    trust::add_file(&data, &pki.path("root.pem"), &entry).unwrap();
    let folder = pki.path("out");
    let said = |as_of: &str, trust: &TrustStore| {
        let as_of_ms = time::parse_utc(as_of).unwrap();
        let report = verify(&Request::new(&folder, trust, as_of_ms)).unwrap();
        let (records, chains) = ([read_record(&folder).unwrap().1], chains_in(&folder).unwrap());
        let folder = Some(folder.as_path());
        let evidence =
            Evidence { report: &report, records: &records, folder, trust, chains: &chains, allowed: None, as_of_ms };
        (report.exit_code, to_markdown(&evidence).unwrap())
    };
    let line = |text: &str, what: &str| text.lines().find(|l| l.starts_with(&format!("| {what}"))).unwrap().to_owned();
    let authority = TrustStore::load(&data, &[]).unwrap();
    let (exit_code, before) = said("2027-12-30T12:00:00.000Z", &authority);
    assert_eq!(exit_code, 0, "{before}");
    let leaf = line(&before, "signer's certificate");
    assert!(
        leaf.contains("| 2025-01-01T00:00:00.000Z | 2028-01-01T00:00:00.000Z | 1 day left | [0](#record-0) |"),
        "{leaf}"
    );
    assert!(leaf.contains("CN=DOE.JANE.1234567890") || leaf.contains("DOE"), "{leaf}");
    assert!(line(&before, "certificate above it").contains("[0](#record-0)"));
    assert!(line(&before, "authority, trusted here").contains(" left |"));
    // It ended meanwhile; what it signed is as good as it was.
    let (exit_code, after) = said("2028-01-11T00:00:00.000Z", &authority);
    assert!(exit_code == 0 && line(&after, "signer's certificate").contains("| ended 10 days before |"), "{after}");

    // The key trusted by itself, until a day and without one.
    let public = pki.path("leaf.pub.pem");
    std::fs::write(&public, key.public().to_pem()).unwrap();
    let named = TrustStore::load(&DataFolder::at(pki.path("none")), std::slice::from_ref(&public)).unwrap();
    let (_, text) = said("2026-01-01T00:00:00.000Z", &named);
    assert!(line(&text, "trust in a key").contains("| not stated | no end is stated | [0](#record-0) |"), "{text}");
    let other = DataFolder::at(pki.path("other"));
    let until = Entry { not_after: Some("2026-06-01T00:00:00.000Z".into()), name: Some("Jane".into()), ..entry };
    trust::add_file(&other, &public, &until).unwrap();
    let (_, text) = said("2026-01-01T00:00:00.000Z", &TrustStore::load(&other, &[]).unwrap());
    assert!(line(&text, "trust in a key | Jane").contains("2026-06-01T00:00:00.000Z | 151 days left"), "{text}");
}
