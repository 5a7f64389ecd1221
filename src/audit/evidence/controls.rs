//! Which controls a report is evidence for, what it does not show, and whose duty that is. Control names: NIST SP
//! 800-53 revision 5, NIST SP 800-171 revision 2 (CMMC level 2), 45 CFR 164.312.

use super::{Block, Cell, Evidence, Section, spans};
use crate::audit::report::Verdict;
use crate::audit::statement::{Outcome, Predicate, Statement};
use crate::audit::time::SyncStatus;

pub(super) fn matrix(evidence: &Evidence<'_>, records: &[Statement]) -> Section {
    let report = evidence.report;
    let (n, pass) = (records.len(), report.verdict == Verdict::Pass);
    // The words, and the records that are the evidence.
    let of = |what: &str, yes: bool, which: &dyn Fn(&Statement) -> bool| {
        if !yes || n == 0 {
            return "nothing that can be relied on".into();
        }
        Cell::about(what, spans(records.iter().filter(|s| which(s)).map(|s| s.predicate.chain.seq)))
    };
    let all = |what: &str, yes: bool| of(what, yes, &|_| true);
    let mut operators: Vec<&str> = records.iter().map(|s| s.predicate.actor.operator_id.as_str()).collect();
    operators.sort_unstable();
    operators.dedup();
    let is_synchronised = |s: &Statement| s.predicate.time.sync_status == SyncStatus::Synchronised;
    let synchronised = records.iter().filter(|s| is_synchronised(s)).count();
    let accounts = records.iter().filter(|s| is_of_accounts(&s.predicate)).count();
    let failures = records.iter().filter(|s| s.predicate.event.error_code.is_some()).count();
    let weights = records.iter().flat_map(|s| &s.predicate.models).filter(|m| m.weights_sha256.is_some()).count();
    let fips = records.iter().any(|s| s.predicate.crypto.fips_mode);
    let anchored =
        report.anchored_through.map_or("no record is anchored".into(), |a| format!("anchored through record {a}"));
    let c = report.counts;
    let rows = [
        (
            "AC-2 Account management",
            match accounts {
                0 => "nothing: the command line has no accounts; records name the operating system's user or the certificate's"
                    .into(),
                n => of(&format!("{} of accounts and sessions of orb serve", count(n, "record")), true, &|s| {
                    is_of_accounts(&s.predicate)
                }),
            },
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
            of(
                &format!(
                    "UTC to the millisecond with what is known of its quality; {synchronised} of {n} synchronised"
                ),
                true,
                &is_synchronised,
            ),
            "that the time source was right",
            "run a time service; set granularity and tolerance",
        ),
        (
            "AU-9, AU-9(3) Protection of audit information",
            of(&format!("every record signed and chained; {anchored}"), pass, &|s| {
                report.anchored_through.is_none_or(|a| s.predicate.chain.seq <= a)
            }),
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
            of(
                &format!(
                    "{} of {} outputs and {} of {} inputs equal their digests; {} of network weights",
                    c.outputs_verified,
                    c.outputs_listed,
                    c.inputs_verified,
                    c.inputs_listed,
                    count(weights, "pin")
                ),
                pass,
                &|s| is_of_files(s) || s.predicate.event.kind == "verify.run",
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
            of("one marking in and beside every output, never below its inputs'", pass, &|s| {
                !s.subject.is_empty() || s.predicate.event.kind == "marking.refused"
            }),
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
            of("activity on each file by digest; no picture and no metadata of it stands in a record", true, &is_of_files),
            "whether a photo is protected health information",
            "decide that; review procedure",
        ),
    ];
    let rows = rows
        .into_iter()
        .map(|(control, found, not, duty)| vec![control.into(), found, not.into(), duty.into()])
        .collect();
    let head = vec!["Control", "Evidence found", "Not shown", "The organisation's duty"];
    Section { title: "Controls", blocks: vec![Block::Table { head, rows }] }
}

/// Something was read or written.
fn is_of_files(s: &Statement) -> bool {
    let made = !s.subject.is_empty() && s.predicate.event.outcome == Outcome::Success;
    made || !s.predicate.inputs.is_empty()
}

/// Of accounts, sessions and refusals of `orb serve`.
fn is_of_accounts(p: &Predicate) -> bool {
    ["account.", "session.", "access."].iter().any(|kind| p.event.kind.starts_with(kind))
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
