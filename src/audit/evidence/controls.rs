//! Which controls a report is evidence for, what it does not show, and whose duty that is. Control names: NIST SP
//! 800-53 revision 5, NIST SP 800-171 revision 2 (CMMC level 2), 45 CFR 164.312.

use super::{Block, Evidence, Section};
use crate::audit::report::Verdict;
use crate::audit::statement::Statement;
use crate::audit::time::SyncStatus;

pub(super) fn matrix(evidence: &Evidence<'_>, records: &[Statement]) -> Section {
    let report = evidence.report;
    let (n, pass) = (records.len(), report.verdict == Verdict::Pass);
    let all =
        |what: &str, yes: bool| if yes && n > 0 { what.to_owned() } else { "nothing that can be relied on".into() };
    let mut operators: Vec<&str> = records.iter().map(|s| s.predicate.actor.operator_id.as_str()).collect();
    operators.sort_unstable();
    operators.dedup();
    let synchronised = records.iter().filter(|s| s.predicate.time.sync_status == SyncStatus::Synchronised).count();
    let failures = records.iter().filter(|s| s.predicate.event.error_code.is_some()).count();
    let weights = records.iter().flat_map(|s| &s.predicate.models).filter(|m| m.weights_sha256.is_some()).count();
    let fips = records.iter().any(|s| s.predicate.crypto.fips_mode);
    let anchored =
        report.anchored_through.map_or("no record is anchored".into(), |a| format!("anchored through record {a}"));
    let c = report.counts;
    let rows = [
        (
            "AC-2 Account management",
            "nothing: the program has no accounts; records name the operating system's user or the certificate's"
                .into(),
            "that accounts are managed",
            "accounts, approvals, reviews, leavers",
        ),
        (
            "AU-2, AU-12 Event logging, audit record generation",
            all(
                &format!(
                    "{}, {} among them; `orb audit events` lists every kind",
                    count(n, "record"),
                    count(failures, "failure")
                ),
                true,
            ),
            "events of other programs",
            "choose which events matter and why; decide which components log",
        ),
        (
            "AU-3, AU-3(1) Content of audit records",
            all(
                "event, time, place, source, outcome, operator, key and the digest of every object in each record",
                true,
            ),
            "content that the organisation wants beyond that",
            "define further content",
        ),
        (
            "AU-8 Time stamps",
            all(
                &format!(
                    "UTC to the millisecond with what is known of its quality; {synchronised} of {n} synchronised"
                ),
                true,
            ),
            "that the time source was right",
            "run a time service; set granularity and tolerance",
        ),
        (
            "AU-9, AU-9(3) Protection of audit information",
            all(&format!("every record signed and chained; {anchored}"), pass),
            "records after the last checkpoint that was kept elsewhere",
            "keep checkpoints where the ledger's owner cannot change them; storage, backups, who may delete",
        ),
        (
            "AU-10 Non-repudiation",
            all(&who(records), pass),
            "that the person of that name held that key; a key in a file that several share is evidence of integrity only",
            "bind keys to persons: certificates, tokens, custody, revocation",
        ),
        (
            "AU-11 Audit record retention",
            all("nothing is ever pruned; a closed ledger moves away whole", true),
            "that copies were kept",
            "retention period and storage",
        ),
        (
            "SI-7, SI-7(1) Software, firmware and information integrity",
            all(
                &format!(
                    "{} of {} outputs and {} of {} inputs equal their digests; {} of network weights",
                    c.outputs_verified,
                    c.outputs_listed,
                    c.inputs_verified,
                    c.inputs_listed,
                    count(weights, "pin")
                ),
                pass,
            ),
            "objects that were not given to this verification",
            "when to verify, and what to do about a finding",
        ),
        (
            "SC-13 Cryptographic protection",
            all(
                if fips {
                    "the module, its version and the certificate that its maker names, where the build knows it; FIPS mode on"
                } else {
                    "the module and its version; FIPS mode off"
                },
                true,
            ),
            "that the module's validation covers this platform",
            "choose a validated module and a tested platform where required",
        ),
        (
            "MP-3, AC-16 Media marking, security attributes",
            all("one marking in and beside every output, never below its inputs'", pass),
            "that the classification decision was right",
            "the decision itself; labels of physical media",
        ),
        (
            "CMMC AU.L2-3.3.1 (SP 800-171 3.3.1)",
            all("records created and kept with defined content", true),
            "monitoring, analysis, investigation",
            "define which logs are needed and how long; review them",
        ),
        (
            "CMMC AU.L2-3.3.2 (SP 800-171 3.3.2)",
            all(
                &format!("each action traced to an operator's name and a key; {}", count(operators.len(), "name")),
                pass,
            ),
            "that no account is shared",
            "unique users",
        ),
        (
            "CMMC SC.L2-3.13.11 (SP 800-171 3.13.11)",
            "nothing: what is here protects integrity, and the requirement is about confidentiality".into(),
            "that CUI is encrypted where it must be",
            "validated cryptography for CUI in transit and at rest",
        ),
        (
            "HIPAA 45 CFR 164.312(b) Audit controls",
            all("activity on each file by digest; no picture and no metadata of it stands in a record", true),
            "whether a photo is protected health information",
            "decide that; review procedure",
        ),
    ];
    let rows = rows
        .into_iter()
        .map(|(control, found, not, duty)| vec![control.to_owned(), found, not.to_owned(), duty.to_owned()])
        .collect();
    let head = vec!["Control", "Evidence found", "Not shown", "The organisation's duty"];
    Section { title: "Controls", blocks: vec![Block::Table { head, rows }] }
}

fn count(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

/// How a signature speaks of a person: which of the cases, in how many records.
fn who(records: &[Statement]) -> String {
    let (mut certified, mut in_token) = (0, 0);
    for actor in records.iter().map(|s| &s.predicate.actor) {
        certified += usize::from(actor.auth == "pki");
        in_token += usize::from(actor.key_source == "pkcs11");
    }
    let n = records.len();
    format!(
        "the operator's name and the key that signed; of {} {certified} name the operator by an authority's certificate, \
         {} by the operating system's word; {in_token} are signed in a token, {} by a key in a file",
        count(n, "record"),
        n - certified,
        n - in_token
    )
}
