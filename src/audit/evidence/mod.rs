//! The report for a compliance officer: what was verified, what was found, which controls it is evidence for, what it
//! does not show, and whose duty that is. The same records, trust and `as_of` give the same bytes.

mod cell;
mod checks;
mod controls;
mod html;
mod lineage;
mod markdown;
mod picture;
mod records;
mod signers;
mod timeline;
mod timeline_picture;
mod times;

use std::collections::BTreeSet;
use std::path::Path;

use super::by_hand;
use super::report::{Finding, Report, Severity, Verdict};
use super::statement::Statement;
use super::time;
use super::trust::{CertChain, TrustStore};
use crate::{Kind, Result};
use cell::{Cell, spans};
pub use checks::{to_junit, to_sarif};
use signers::{algorithms, fingerprints};

/// What a report is about.
#[derive(Debug)]
pub struct Evidence<'a> {
    pub report: &'a Report,
    /// The records that were verified, in order; facts are taken from them only when the verdict lets them be believed.
    pub records: &'a [Statement],
    /// The folder, when the report is about one.
    pub folder: Option<&'a Path>,
    /// Whom the verification trusted.
    pub trust: &'a TrustStore,
    /// The certificates that stood beside the records.
    pub chains: &'a [CertChain],
    /// SHA-256 of the only weights that may have been used, where a list was given.
    pub allowed: Option<&'a [String]>,
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
    Table { head: Vec<&'static str>, rows: Vec<Vec<Cell>> },
    Commands(String),
    Lineage(Box<lineage::Lineage>),
    Timeline(Box<timeline::Timeline>),
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
        records::blocks(records),
        scope(evidence),
        findings(&report.findings, records),
        timeline::section(evidence, records),
        records::scenes(records),
        lineage::section(evidence, records),
        records::stated(records),
        records::command_line(records),
        records::inputs(records),
        records::outputs(records),
        records::models(records, evidence.allowed),
        signers::signers(records),
        signers::endings(evidence, records),
        times::clock(records),
        records::places(records),
        records::programs(records),
        controls::matrix(evidence, records),
    ];
    if let Some(folder) = evidence.folder.filter(|_| !records.is_empty()) {
        let block = match by_hand::openssl_commands(folder, by_hand::Beside::default()) {
            // The findings say what is wrong; the report of it is written all the same.
            Err(e) if e.kind == Kind::Integrity => Block::Text(format!("No commands are given: {}.", e.found)),
            commands => Block::Commands(commands?),
        };
        sections.push(Section { title: "Verify again, without Orb", blocks: vec![block] });
    }
    sections.push(records::hashes(records));
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
    let mut row = |name: &str, value: String| rows.push([name.to_owned(), value].map(Cell::from).to_vec());
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

fn findings(found: &[Finding], records: &[Statement]) -> Section {
    if found.is_empty() {
        return Section { title: "Findings", blocks: vec![Block::Text("None.".into())] };
    }
    // Only what stands below can be linked to.
    let shown: BTreeSet<u64> = records.iter().map(|s| s.predicate.chain.seq).collect();
    let mut rows: Vec<(Severity, Vec<Cell>)> = found
        .iter()
        .map(|f| {
            let detail = [("expected", &f.expected), ("found", &f.actual)]
                .into_iter()
                .filter(|(_, text)| !text.is_empty())
                .map(|(name, text)| format!("{name} {text}"));
            let record = match f.seq {
                Some(n) if shown.contains(&n) => Cell::about("", vec![[n, n]]),
                Some(n) => n.to_string().into(),
                None => Cell::default(),
            };
            let what = detail.collect::<Vec<_>>().join("; ");
            let row = vec![
                f.severity.name().into(),
                f.code.into(),
                record,
                f.subject.clone().into(),
                what.into(),
                f.hint.clone().into(),
            ];
            (f.severity, row)
        })
        .collect();
    rows.sort_by_key(|(severity, _)| *severity);
    let head = vec!["Severity", "Code", "Record", "Where", "What", "Meaning, what to do"];
    table("Findings", head, rows.into_iter().map(|(_, row)| row).collect())
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
fn table<C: Into<Cell>>(title: &'static str, head: Vec<&'static str>, rows: Vec<Vec<C>>) -> Section {
    let rows: Vec<Vec<Cell>> = rows.into_iter().map(|row| row.into_iter().map(Into::into).collect()).collect();
    let blocks = if rows.is_empty() { Vec::new() } else { vec![Block::Table { head, rows }] };
    Section { title, blocks }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_of_ledgers;
