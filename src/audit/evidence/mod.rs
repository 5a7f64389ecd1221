//! The report for a compliance officer: what was verified, what was found, which controls it is evidence for, what it
//! does not show, and whose duty that is. The same records, trust and `as_of` give the same bytes.

mod checks;
mod controls;
mod html;
mod lineage;
mod markdown;
mod picture;

use std::path::Path;

use super::by_hand;
use super::report::{Finding, Report, Severity, Verdict};
use super::statement::{Actor, Input, Model, Statement, Tool};
use super::time::{self, Source, SyncStatus};
use crate::Result;
pub use checks::{to_junit, to_sarif};

/// What a report is about.
#[derive(Debug)]
pub struct Evidence<'a> {
    pub report: &'a Report,
    /// The records that were verified, in order; facts are taken from them only when the verdict lets them be believed.
    pub records: &'a [Statement],
    /// The folder, when the report is about one.
    pub folder: Option<&'a Path>,
    /// The report's own time, milliseconds since 1970.
    pub as_of_ms: u64,
}

/// A document without a form yet.
#[derive(Debug)]
struct Document {
    banner: String,
    title: String,
    sections: Vec<Section>,
}

#[derive(Debug)]
struct Section {
    title: &'static str,
    blocks: Vec<Block>,
}

#[derive(Debug)]
enum Block {
    Text(String),
    Table { head: Vec<&'static str>, rows: Vec<Vec<String>> },
    Commands(String),
    Lineage(Box<lineage::Lineage>),
}

/// One self-contained HTML page: no script, nothing fetched, banner at its top and bottom and on every printed page.
///
/// # Errors
/// As [`by_hand::openssl_commands`].
pub fn to_html(evidence: &Evidence<'_>) -> Result<String> {
    Ok(html::render(&document(evidence)?))
}

/// The same as Markdown.
///
/// # Errors
/// As [`to_html`].
pub fn to_markdown(evidence: &Evidence<'_>) -> Result<String> {
    Ok(markdown::render(&document(evidence)?))
}

fn document(evidence: &Evidence<'_>) -> Result<Document> {
    let report = evidence.report;
    // Words of a record that nobody trusted has signed are not repeated as facts.
    let records = if report.marking.is_some() { evidence.records } else { &[] };
    let mut sections = vec![
        verdict(evidence),
        // On the first page, as the rules for classified documents ask.
        blocks(records),
        scope(evidence),
        findings(&report.findings),
        scenes(records),
        lineage::section(evidence, records),
        stated(records),
        command_line(records),
        inputs(records),
        outputs(records),
        models(records),
        signers(records),
        clock(records),
        places(records),
        programs(records),
        controls::matrix(evidence, records),
    ];
    if let Some(folder) = evidence.folder.filter(|_| !records.is_empty()) {
        sections.push(Section {
            title: "Verify again, without Orb",
            blocks: vec![Block::Commands(by_hand::openssl_commands(folder, by_hand::Beside::default())?)],
        });
    }
    sections.push(hashes(records));
    Ok(Document {
        banner: report.marking.clone().unwrap_or_else(|| "MARKING NOT VERIFIED".into()),
        title: "Audit evidence".into(),
        sections: sections.into_iter().filter(|s| !s.blocks.is_empty()).collect(),
    })
}

fn verdict(evidence: &Evidence<'_>) -> Section {
    let sentence = evidence.report.sentence();
    let limit = match evidence.report.verdict {
        Verdict::Pass => {
            "What follows is evidence for an assessment. It is not an authorisation and certifies nothing."
        }
        _ => "What follows must not be relied on before the findings are cleared.",
    };
    Section { title: "Verdict", blocks: vec![Block::Text(format!("{sentence}.")), Block::Text(limit.into())] }
}

fn scope(evidence: &Evidence<'_>) -> Section {
    let report = evidence.report;
    let mut rows = Vec::new();
    let mut row = |name: &str, value: String| rows.push(vec![name.to_owned(), value]);
    row("Report made", time::format_utc(evidence.as_of_ms));
    row("Tool", format!("orb {}", env!("CARGO_PKG_VERSION")));
    row("Trust store", report.trust_store_sha256.clone());
    if let Some(ledger) = &report.ledger_id {
        row("Ledger", ledger.clone());
    }
    if let Some(range) = report.range {
        row("Records", format!("{} to {}", range.first, range.last));
        row("Anchored through", report.anchored_through.map_or("no record".into(), |n| format!("record {n}")));
    }
    let c = report.counts;
    row("Outputs verified", format!("{} of {}", c.outputs_verified, c.outputs_listed));
    row("Inputs verified", format!("{} of {}", c.inputs_verified, c.inputs_listed));
    Section { title: "Scope", blocks: vec![Block::Table { head: vec!["What", "Value"], rows }] }
}

fn findings(found: &[Finding]) -> Section {
    if found.is_empty() {
        return Section { title: "Findings", blocks: vec![Block::Text("None.".into())] };
    }
    let mut rows: Vec<(Severity, Vec<String>)> = found
        .iter()
        .map(|f| {
            let detail = [("expected", &f.expected), ("found", &f.actual)]
                .into_iter()
                .filter(|(_, text)| !text.is_empty())
                .map(|(name, text)| format!("{name} {text}"));
            let seq = f.seq.map(|n| n.to_string()).unwrap_or_default();
            let words = [f.severity.name().into(), f.code.into(), seq, f.subject.clone()];
            let more = [detail.collect::<Vec<_>>().join("; "), f.hint.clone()];
            (f.severity, words.into_iter().chain(more).collect())
        })
        .collect();
    rows.sort_by_key(|(severity, _)| *severity);
    let head = vec!["Severity", "Code", "Record", "Where", "What", "Meaning, what to do"];
    table("Findings", head, rows.into_iter().map(|(_, row)| row).collect())
}

fn scenes(records: &[Statement]) -> Section {
    let rows = records
        .iter()
        .map(|s| {
            let p = &s.predicate;
            let outcome = match (&p.event.outcome, &p.event.error_code) {
                (super::statement::Outcome::Success, _) => "success".to_owned(),
                (_, code) => format!("failure {}", code.as_deref().unwrap_or_default()),
            };
            vec![
                p.chain.seq.to_string(),
                p.time.utc.clone(),
                format!("{}, {outcome}", p.event.kind),
                p.marking.banner.clone(),
                p.inputs.iter().map(|i| i.name.as_str()).collect::<Vec<_>>().join(", "),
                s.subject.len().to_string(),
                format!("{} ({})", p.actor.operator_id, p.actor.auth),
            ]
        })
        .collect();
    table("Events", vec!["Record", "UTC", "Event", "Marking", "Inputs", "Outputs", "Operator"], rows)
}

/// Why each product is marked as it is: classification authority, designation of CUI, raising.
fn blocks(records: &[Statement]) -> Section {
    let mut rows = Vec::new();
    for Statement { predicate: p, .. } in records {
        let mut row = |name: &str, value: &str| rows.push(vec![p.chain.seq.to_string(), name.into(), value.into()]);
        if let Some(a) = &p.marking.authority {
            row("Classified by", &a.classified_by);
            row("Derived from", &a.derived_from);
            a.sources.iter().for_each(|source| row("Source", source));
            row("Declassify on", &a.declassify_on);
            row("Date of origin", &a.date_of_origin);
        }
        if let Some(d) = &p.marking.cui_block {
            row("Controlled by", &d.controlled_by);
            row("Controlled by (office)", &d.office);
            row("CUI category", &d.category);
            row("Distribution, dissemination", d.dissemination.as_deref().unwrap_or("not stated"));
            row("POC", &d.poc);
        }
        if let Some(reason) = &p.marking.raised_reason {
            row("Raised because", reason);
        }
    }
    table("Marking blocks", vec!["Record", "Line", "Value"], rows)
}

fn inputs(records: &[Statement]) -> Section {
    let row = |i: &Input| {
        vec![
            i.name.clone(),
            i.role.clone(),
            i.size.to_string(),
            i.marking.clone().unwrap_or("none".into()),
            i.sha256.clone(),
        ]
    };
    let rows = records.iter().flat_map(|s| s.predicate.inputs.iter().map(row)).collect();
    table("Inputs", vec!["Name", "Role", "Bytes", "Marking inside", "SHA-256"], rows)
}

fn outputs(records: &[Statement]) -> Section {
    // Of one folder every output; of a ledger they would be its greater part, and each record lists its own.
    let [record] = records else { return Section { title: "Outputs", blocks: Vec::new() } };
    let rows = record
        .subject
        .iter()
        .map(|s| vec![s.name.clone(), s.annotations.role.clone(), s.annotations.size.clone(), s.digest.sha256.clone()])
        .collect();
    table("Outputs", vec!["Name", "Role", "Bytes", "SHA-256"], rows)
}

fn models(records: &[Statement]) -> Section {
    let row = |m: &Model| {
        let text = |t: &Option<String>| t.clone().unwrap_or_default();
        let status = m.status.clone().unwrap_or("ran".into());
        vec![m.id.clone(), status, text(&m.version), text(&m.runtime), text(&m.pin_source), text(&m.weights_sha256)]
    };
    let mut rows: Vec<Vec<String>> = records.iter().flat_map(|s| s.predicate.models.iter().map(row)).collect();
    rows.sort();
    rows.dedup();
    table("Model pins", vec!["Model", "Status", "Version", "Runtime", "Pin from", "Weights' SHA-256"], rows)
}

fn signers(records: &[Statement]) -> Section {
    let mut rows: Vec<Vec<String>> = records
        .iter()
        .map(|s| {
            let (a, c) = (&s.predicate.actor, &s.predicate.crypto);
            let fips = if c.fips_mode { "on" } else { "off" };
            vec![
                fingerprints(a),
                algorithms(a),
                a.key_source.clone(),
                format!("{} {}", c.provider, c.provider_version),
                fips.into(),
                c.module_certificate_claim.clone().unwrap_or("none".into()),
            ]
        })
        .collect();
    rows.sort();
    rows.dedup();
    let head = vec!["Key (SPKI SHA-256)", "Algorithm", "From", "Module", "FIPS mode", "Certificate claimed"];
    let mut section = table("Keys and cryptography", head, rows);
    if !section.blocks.is_empty() {
        section.blocks.push(Block::Text(
            "A key in a file gives integrity. It binds a person only as far as the organisation's custody of that file \
             does; shared, it is no evidence of who signed."
                .into(),
        ));
    }
    section
}

/// Of all who signed.
fn fingerprints(actor: &Actor) -> String {
    let others = actor.co_signers.iter().flatten().map(|other| other.key_fingerprint.as_str());
    std::iter::once(actor.key_fingerprint.as_str()).chain(others).collect::<Vec<_>>().join(" ")
}

fn algorithms(actor: &Actor) -> String {
    let others = actor.co_signers.iter().flatten().map(|other| other.algorithm.as_str());
    std::iter::once(actor.algorithm.as_str()).chain(others).collect::<Vec<_>>().join(" and ")
}

fn clock(records: &[Statement]) -> Section {
    if records.is_empty() {
        return Section { title: "Time", blocks: Vec::new() };
    }
    let asked = |s: &&Statement| s.predicate.time.source == Source::NtpQuery;
    let by_kernel: Vec<&Statement> = records.iter().filter(|s| !asked(s)).collect();
    let count = |status: SyncStatus| by_kernel.iter().filter(|s| s.predicate.time.sync_status == status).count();
    let worst = by_kernel.iter().filter_map(|s| s.predicate.time.max_error_us).max();
    let worst =
        worst.map_or(String::new(), |us| format!(" The largest error bound that a kernel stated is {} ms.", us / 1000));
    let mut blocks = vec![Block::Text(format!(
        "Clock called synchronised by its kernel: {}; unsynchronised: {}; nothing known: {}.{worst} A kernel says that a daemon \
         keeps its clock, not that the daemon is right.",
        count(SyncStatus::Synchronised),
        count(SyncStatus::Unsynchronised),
        count(SyncStatus::Unknown)
    ))];
    let rows: Vec<Vec<String>> = records.iter().filter(asked).map(server).collect();
    if !rows.is_empty() {
        blocks.push(Block::Text("Dated by a time server that was asked once, without proof of who answered:".into()));
        let head = vec!["Record", "Server", "Stratum", "Local clock off by, ms", "The way hides, ms"];
        blocks.push(Block::Table { head, rows });
    }
    Section { title: "Time", blocks }
}

fn server(record: &Statement) -> Vec<String> {
    let (p, time) = (&record.predicate, &record.predicate.time);
    let ms = |us: Option<i64>| us.map_or(String::new(), |us| us.div_euclid(1000).to_string());
    vec![
        p.chain.seq.to_string(),
        time.reference.clone().unwrap_or_default(),
        time.stratum.map_or(String::new(), |n| n.to_string()),
        ms(time.offset_us),
        ms(time.max_error_us),
    ]
}

/// Where the program ran, each machine under the name that it has in this ledger.
fn places(records: &[Statement]) -> Section {
    let mut rows: Vec<Vec<String>> = records
        .iter()
        .map(|s| {
            let place = &s.predicate.place;
            let text = |t: &Option<String>, absent: &str| t.clone().unwrap_or(absent.into());
            let system = format!("{}, {}", place.os, place.arch);
            let name = text(&place.hostname, "not recorded");
            vec![text(&place.host_id, "not recorded"), name, system, text(&place.container, "none known")]
        })
        .collect();
    rows.sort();
    rows.dedup();
    table("Machines", vec!["Machine (hash)", "Name", "System", "Container"], rows)
}

/// What made the records.
fn programs(records: &[Statement]) -> Section {
    let mut tools: Vec<&Tool> = Vec::new();
    for Statement { predicate: p, .. } in records {
        if !tools.contains(&&p.tool) {
            tools.push(&p.tool);
        }
    }
    let mut rows = Vec::new();
    for t in tools {
        let changed = if t.dirty == Some(true) { ", changed since" } else { "" };
        let lines = [
            ("Source's commit", t.git_commit.as_ref().map(|c| format!("{c}{changed}"))),
            ("Compiler", t.rustc.clone()),
            ("Target", t.target.clone()),
            ("Features", t.features.as_ref().map(|f| f.join(", "))),
            ("SHA-256 of the program", t.binary_sha256.clone()),
            ("SHA-256 of its SBOM", t.sbom_sha256.clone()),
        ];
        let program = format!("{} {}", t.name, t.version);
        rows.extend(
            lines.map(|(name, value)| vec![program.clone(), name.into(), value.unwrap_or("not recorded".into())]),
        );
    }
    table("Programs", vec!["Program", "Line", "Value"], rows)
}

/// What the operator or the organisation said of a record, and nobody vouches for.
fn stated(records: &[Statement]) -> Section {
    let mut rows = Vec::new();
    for Statement { predicate: p, .. } in records {
        let lines = [
            ("Operator", p.actor.display.as_deref()),
            ("Role", p.actor.role.as_deref()),
            ("To be kept", p.retention_hint.as_deref()),
        ];
        rows.extend(
            lines
                .iter()
                .filter_map(|(name, value)| Some(vec![p.chain.seq.to_string(), (*name).into(), (*value)?.into()])),
        );
    }
    table("As stated by the operator", vec!["Record", "Line", "Value"], rows)
}

/// The command line of a folder's record; of a ledger they would be its greater part.
fn command_line(records: &[Statement]) -> Section {
    let [record] = records else { return Section { title: "Command line", blocks: Vec::new() } };
    let blocks = record.predicate.source.argv_redacted.iter().map(|words| Block::Commands(words.join(" "))).collect();
    Section { title: "Command line", blocks }
}

fn hashes(records: &[Statement]) -> Section {
    let rows = records
        .iter()
        .map(|s| {
            let p = &s.predicate;
            vec![
                p.chain.seq.to_string(),
                p.event.id.clone(),
                p.trail_hash.clone().unwrap_or_default(),
                p.chain.prev.clone(),
            ]
        })
        .collect();
    table("Trail hashes", vec!["Record", "Event", "Trail hash", "Before it"], rows)
}

/// Characters that a page would obey and not show stand as their numbers: they can make a name read as another one.
fn visible(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' => out.push(c),
            // Directions (UAX 9), what has no width, tags, and what XML cannot hold.
            '\u{61c}'
            | '\u{200b}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}'
            | '\u{feff}'
            | '\u{fff0}'..='\u{fffb}'
            | '\u{fffe}'
            | '\u{ffff}'
            | '\u{e0000}'..='\u{e007f}' => {
                out.push_str(&format!("[U+{:04X}]", c as u32));
            }
            _ if c.is_control() => out.push(char::REPLACEMENT_CHARACTER),
            _ => out.push(c),
        }
    }
    out
}

/// A section of one table; of nothing when it would be empty.
fn table(title: &'static str, head: Vec<&'static str>, rows: Vec<Vec<String>>) -> Section {
    let blocks = if rows.is_empty() { Vec::new() } else { vec![Block::Table { head, rows }] };
    Section { title, blocks }
}

#[cfg(test)]
mod tests;
