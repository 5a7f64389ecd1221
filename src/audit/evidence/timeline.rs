//! A whole ledger at a glance: its records by kind along the time that they state, which of them a checkpoint covers that was
//! kept elsewhere, what failed, and where checkpoints were signed. Drawn by [`super::timeline_picture`].

use std::collections::BTreeMap;

use super::{Block, Evidence, Section};
use crate::audit::report::Severity;
use crate::audit::statement::{Outcome, Statement};
use crate::audit::time;

/// More kinds than this, which Orb does not have, are gathered.
const MOST_LANES: usize = 40;
const CHECKPOINT: &str = "ledger.checkpoint";

/// The records of a ledger as a picture's content.
#[derive(Debug)]
pub(super) struct Timeline {
    pub banner: String,
    /// Kinds of records, by name, and their records, by number.
    pub lanes: Vec<(String, Vec<Mark>)>,
    /// The earliest and the latest time that a record states, milliseconds since 1970.
    pub from_ms: u64,
    pub to_ms: u64,
    /// The last record that a checkpoint covers that was kept elsewhere, and the latest time of it and those before it.
    pub anchored: Option<(u64, u64)>,
    /// When checkpoints were signed.
    pub checkpoints: Vec<u64>,
}

/// One record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Mark {
    pub seq: u64,
    pub ms: u64,
    /// No checkpoint that was kept elsewhere covers it.
    pub tail: bool,
    pub failed: bool,
    /// The verification found an error in it.
    pub flawed: bool,
}

/// The picture of a ledger; of a folder, whose one record has its lineage, none.
pub(super) fn section(evidence: &Evidence<'_>, records: &[Statement]) -> Section {
    let blocks = match (evidence.folder, Timeline::of(evidence, records)) {
        (None, Some(timeline)) => vec![Block::Timeline(Box::new(timeline))],
        _ => Vec::new(),
    };
    Section { title: "The ledger", blocks }
}

impl Timeline {
    /// `None` of no records.
    fn of(evidence: &Evidence<'_>, records: &[Statement]) -> Option<Timeline> {
        let through = evidence.report.anchored_through;
        let mut flawed: Vec<u64> = Vec::new();
        flawed.extend(evidence.report.findings.iter().filter(|f| f.severity == Severity::Error).filter_map(|f| f.seq));
        flawed.sort_unstable();
        let mut lanes: BTreeMap<&str, Vec<Mark>> = BTreeMap::new();
        for Statement { predicate: p, .. } in records {
            let mark = Mark {
                seq: p.chain.seq,
                ms: time::parse_utc(&p.time.utc).unwrap_or_default(),
                tail: through.is_none_or(|a| p.chain.seq > a),
                failed: p.event.outcome == Outcome::Failure,
                flawed: flawed.binary_search(&p.chain.seq).is_ok(),
            };
            let lane = if lanes.len() < MOST_LANES || lanes.contains_key(p.event.kind.as_str()) {
                p.event.kind.as_str()
            } else {
                "others"
            };
            lanes.entry(lane).or_default().push(mark);
        }
        let all = || lanes.values().flatten();
        let (from_ms, to_ms) = (all().map(|m| m.ms).min()?, all().map(|m| m.ms).max()?);
        let anchored = through.zip(all().filter(|m| !m.tail).map(|m| m.ms).max());
        let signed = |m: &&Mark| !m.failed;
        let checkpoints = lanes.get(CHECKPOINT).into_iter().flatten().filter(signed).map(|m| m.ms).collect();
        let lanes = lanes.into_iter().map(|(kind, marks)| (kind.to_owned(), marks)).collect();
        let banner = evidence.report.marking.clone().unwrap_or_default();
        Some(Timeline { banner, lanes, from_ms, to_ms, anchored, checkpoints })
    }

    /// All of it in words, a line for each thing.
    pub fn words(&self) -> Vec<String> {
        let all: Vec<&Mark> = self.lanes.iter().flat_map(|(_, marks)| marks).collect();
        let tail = all.iter().filter(|m| m.tail).count();
        let mut lines = vec![format!(
            "{} from {} to {}",
            counted(all.len(), "record"),
            time::format_utc(self.from_ms),
            time::format_utc(self.to_ms)
        )];
        lines.push(match self.anchored {
            None => "no record is anchored: no checkpoint that was kept elsewhere covers any".into(),
            Some((seq, _)) => {
                format!("anchored through record {seq}; {} after it not anchored", counted(tail, "record"))
            }
        });
        lines.push(format!("{} signed", counted(self.checkpoints.len(), "checkpoint")));
        for (kind, marks) in &self.lanes {
            let failed = marks.iter().filter(|m| m.failed).count();
            let flawed = marks.iter().filter(|m| m.flawed).count();
            let and = |n: usize, what: &str| if n == 0 { String::new() } else { format!(", {n} {what}") };
            lines.push(format!(
                "{kind}: {}{}{}",
                counted(marks.len(), "record"),
                and(failed, "of a failure or refusal"),
                and(flawed, "in which an error was found")
            ));
        }
        lines
    }
}

pub(super) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}
