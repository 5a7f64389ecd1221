//! Findings in the words of build systems: SARIF 2.1.0 for those that collect findings, JUnit XML for those that count tests.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::html::escaped;
use crate::audit::report::{Finding, Report, Severity, Verdict};

/// OASIS SARIF 2.1.0: a result for each finding, the verdict and the marking among the run's properties.
pub fn to_sarif(report: &Report) -> String {
    let mut codes: Vec<&Finding> = report.findings.iter().collect();
    codes.sort_by_key(|f| f.code);
    codes.dedup_by_key(|f| f.code);
    let rules: Vec<Value> = codes
        .iter()
        .map(|f| json!({"id": f.code, "shortDescription": {"text": meaning(f)}, "properties": {"tags": f.controls}}))
        .collect();
    let results: Vec<Value> = report
        .findings
        .iter()
        .map(|f| {
            json!({
                "ruleId": f.code,
                "level": f.severity.name(),
                "message": {"text": sentence(f)},
                "locations": [{"physicalLocation": {"artifactLocation": {"uri": uri(&f.subject)}}}],
            })
        })
        .collect();
    let value = json!({
        "version": "2.1.0",
        "runs": [{
            "tool": {"driver": {"name": "orb", "semanticVersion": env!("CARGO_PKG_VERSION"), "rules": rules}},
            "results": results,
            "properties": {
                "marking": report.marking,
                "verdict": report.verdict,
                "exitCode": report.exit_code,
                "trailHash": report.trail_hash,
                "trustStoreSha256": report.trust_store_sha256,
            },
        }],
    });
    format!("{value}\n")
}

/// A suite of one test for the verdict, which fails unless it is a pass, and one for each finding: errors fail, the others pass
/// and say what they have to say.
pub fn to_junit(report: &Report) -> String {
    let failed = usize::from(report.verdict != Verdict::Pass) as u64 + report.counts.errors;
    let counts = format!("tests=\"{}\" failures=\"{failed}\"", report.findings.len() + 1);
    let marking = escaped(report.marking.as_deref().unwrap_or("MARKING NOT VERIFIED"));
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {counts}>\n<testsuite name=\"orb audit\" {counts}>\n\
         <properties><property name=\"marking\" value=\"{marking}\"/></properties>\n"
    );
    let verdict = (report.verdict != Verdict::Pass).then_some("VERDICT");
    test(&mut out, "verdict", verdict, &report.sentence());
    for finding in &report.findings {
        let code = (finding.severity == Severity::Error).then_some(finding.code);
        let name = match finding.seq {
            Some(seq) => format!("{} {} (record {seq})", finding.code, finding.subject),
            None => format!("{} {}", finding.code, finding.subject),
        };
        test(&mut out, &name, code, &sentence(finding));
    }
    out.push_str("</testsuite>\n</testsuites>\n");
    out
}

fn test(out: &mut String, name: &str, failure: Option<&str>, words: &str) {
    let (name, words) = (escaped(name), escaped(words));
    let inside = match failure {
        Some(code) => format!("<failure type=\"{code}\" message=\"{words}\"/>"),
        None => format!("<system-out>{words}</system-out>"),
    };
    let _ = writeln!(out, "<testcase classname=\"orb.audit\" name=\"{name}\">{inside}</testcase>");
}

fn meaning(finding: &Finding) -> &str {
    if finding.hint.is_empty() { finding.code } else { &finding.hint }
}

fn sentence(finding: &Finding) -> String {
    let mut words = vec![format!("{}: {}", finding.code, finding.subject)];
    for (name, value) in [("expected", &finding.expected), ("found", &finding.actual)] {
        if !value.is_empty() {
            words.push(format!("{name} {value}"));
        }
    }
    if !finding.hint.is_empty() {
        words.push(finding.hint.clone());
    }
    words.join("; ")
}

/// A relative reference (RFC 3986 §4.2): everything but unreserved characters and `/` as octets.
fn uri(subject: &str) -> String {
    let mut out = String::new();
    for byte in subject.bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => out.push(char::from(byte)),
            _ => {
                let _ = write!(out, "%{byte:02X}");
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use quick_xml::Reader;
    use quick_xml::events::Event;

    use super::super::tests::with_report;
    use super::*;

    #[test]
    fn findings_for_build_systems() {
        let spoil = |folder: &std::path::Path| {
            std::fs::write(folder.join("scene.ply"), "changed").unwrap();
            std::fs::write(folder.join("50% <new> & more.txt"), "x").unwrap();
        };
        with_report(true, spoil, |evidence| {
            let report = evidence.report;
            let sarif: Value = serde_json::from_str(&to_sarif(report)).unwrap();
            let run = &sarif["runs"][0];
            let results = run["results"].as_array().unwrap();
            assert_eq!((results.len(), &run["properties"]["verdict"]), (report.findings.len(), &json!("fail")));
            let of = |code: &str| results.iter().find(|r| r["ruleId"] == code).unwrap();
            assert_eq!(of("OUTPUT_DIGEST")["level"], "error");
            let place = &of("OUTPUT_EXTRA")["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
            assert_eq!(place, "50%25%20%3Cnew%3E%20%26%20more.txt");
            let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
            for result in results {
                assert_eq!(rules.iter().filter(|r| r["id"] == result["ruleId"]).count(), 1);
            }

            let (mut tests, mut failures, mut reader_failures) = (0, 0, String::new());
            let xml = to_junit(report);
            let mut reader = Reader::from_str(&xml);
            loop {
                match reader.read_event().unwrap() {
                    Event::Eof => break,
                    Event::Start(tag) | Event::Empty(tag) => {
                        assert!(tag.attributes().all(|a| a.is_ok()));
                        tests += usize::from(tag.name().as_ref() == "testcase");
                        if tag.name().as_ref() == "failure" {
                            failures += 1;
                            reader_failures.push_str(&tag);
                        }
                    }
                    _ => {}
                }
            }
            assert_eq!(tests, report.findings.len() + 1);
            assert!(xml.contains(&format!("tests=\"{tests}\" failures=\"{failures}\"")), "{xml}");
            assert!(
                reader_failures.contains("OUTPUT_DIGEST") && reader_failures.contains("FAIL: 2 things are not"),
                "{xml}"
            );
            assert!(xml.contains("50% &lt;new&gt; &amp; more.txt"), "{xml}");
        });
        with_report(
            true,
            |_| {},
            |evidence| {
                let xml = to_junit(evidence.report);
                assert!(
                    xml.contains("failures=\"0\"")
                        && !xml.contains("<failure")
                        && xml.contains("value=\"UNCLASSIFIED\""),
                    "{xml}"
                );
            },
        );
    }
}
