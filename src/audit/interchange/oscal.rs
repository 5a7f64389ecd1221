//! NIST OSCAL assessment results: one observation for each thing that a verification looked at. Observations only: what
//! satisfies a control is the assessor's word, so no findings are made.

use serde_json::{Value, json};

use super::named_uuid;
use crate::audit::publication::RECORD;
use crate::audit::report::{Finding, Report};
use crate::audit::statement::Statement;

/// The version of the OSCAL models that the file follows.
const OSCAL_VERSION: &str = "1.2.1";

/// Controls of NIST SP 800-53 revision 5 that a record is evidence about.
pub const CONTROLS: [&str; 11] =
    ["ac-16", "au-3", "au-3.1", "au-8", "au-9", "au-9.3", "au-10", "au-12", "mp-3", "sc-13", "si-7"];

/// The results of verifying one published folder. `collected` is the verification's time, UTC.
pub fn assessment_results(report: &Report, statement: &Statement, collected: &str) -> Value {
    let p = &statement.predicate;
    let trail_hash = p.trail_hash.clone().unwrap_or_default();
    let uuid = |what: &str| named_uuid(&format!("{trail_hash} {collected} {what}"));
    let c = report.counts;
    let mut observations = vec![
        observation(
            &uuid("signature"),
            "Signature and record",
            &format!(
                "The record's signature was verified by two implementations against key {}; its trail hash is {trail_hash}.",
                p.actor.key_fingerprint
            ),
            collected,
        ),
        observation(
            &uuid("outputs"),
            "Integrity of outputs",
            &format!("{} of {} outputs have the sealed digest.", c.outputs_verified, c.outputs_listed),
            collected,
        ),
        observation(
            &uuid("inputs"),
            "Integrity of inputs",
            &format!("{} of {} inputs were compared with their digest.", c.inputs_verified, c.inputs_listed),
            collected,
        ),
        observation(
            &uuid("marking"),
            "Marking",
            &format!(
                "The product is marked {} in the record and in every output with a place for it.",
                p.marking.banner
            ),
            collected,
        ),
        observation(&uuid("time"), "Time", &format!("Recorded {}; {}.", p.time.utc, quality(statement)), collected),
    ];
    for (n, finding) in report.findings.iter().enumerate() {
        let text = sentence(finding);
        observations.push(observation(&uuid(&format!("finding {n}")), finding.code, &text, collected));
    }
    let controls: Vec<Value> = CONTROLS.iter().map(|id| json!({"control-id": id})).collect();
    json!({"assessment-results": {
        "uuid": uuid("results"),
        "metadata": {
            "title": format!("{}: verification of an Orb record", p.marking.banner),
            "last-modified": collected,
            "version": p.tool.version,
            "oscal-version": OSCAL_VERSION,
            "props": [{"name": "marking", "value": p.marking.banner}],
            "remarks": "Evidence for an assessment. Not an assessment, and no authorisation.",
        },
        "import-ap": {"href": "#assessment-plan", "remarks": "The plan is the organisation's."},
        "results": [{
            "uuid": uuid("result"),
            "title": "Offline verification of a published folder",
            "description": report.sentence(),
            "start": collected,
            "end": collected,
            "reviewed-controls": {"control-selections": [{"include-controls": controls}]},
            "observations": observations,
        }],
    }})
}

fn observation(uuid: &str, title: &str, description: &str, collected: &str) -> Value {
    json!({
        "uuid": uuid,
        "title": title,
        "description": description,
        "methods": ["TEST"],
        "collected": collected,
        "relevant-evidence": [{"href": RECORD, "description": "The signed record beside the outputs."}],
    })
}

fn sentence(finding: &Finding) -> String {
    let mut text = format!("Severity {}, at {}.", finding.severity.name(), finding.subject);
    for (name, value) in [("Expected", &finding.expected), ("Found", &finding.actual)] {
        if !value.is_empty() {
            text.push_str(&format!(" {name}: {value}."));
        }
    }
    if !finding.hint.is_empty() {
        text.push(' ');
        text.push_str(&finding.hint);
    }
    text
}

fn quality(statement: &Statement) -> String {
    use crate::audit::time::{Source, SyncStatus};
    let time = &statement.predicate.time;
    match (time.source, time.sync_status) {
        (Source::NtpQuery, SyncStatus::Synchronised) => {
            format!("the NTP server {} was asked", time.reference.as_deref().unwrap_or("of no name"))
        }
        (_, SyncStatus::Synchronised) => "the kernel called its clock synchronised".into(),
        (_, SyncStatus::Unsynchronised) => "the kernel called its clock unsynchronised".into(),
        (_, SyncStatus::Unknown) => "nothing is known of the clock's quality".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::TrustStore;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::publication::tests::publish;
    use crate::audit::verify::{Request, read_record, verify};

    #[test]
    fn observations_and_no_claims() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let folder = dir.path().join("out");
        let mut trust = TrustStore::default();
        trust.insert(shared_key().public().clone());
        let now_ms = 1_763_700_000_000;
        let report = verify(&Request::new(&folder, &trust, now_ms)).unwrap();
        let (_, statement) = read_record(&folder).unwrap();
        let value = assessment_results(&report, &statement, "2025-11-21T04:40:00.000Z");
        let result = &value["assessment-results"]["results"][0];
        assert!(result["observations"].as_array().unwrap().len() >= 5);
        assert!(result["findings"].is_null());
        assert_eq!(result["reviewed-controls"]["control-selections"][0]["include-controls"][0]["control-id"], "ac-16");
        assert_eq!(value, assessment_results(&report, &statement, "2025-11-21T04:40:00.000Z"));
    }
}
