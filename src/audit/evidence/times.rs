//! What is known of the clocks.

use super::{Block, Cell, Section};
use crate::audit::statement::Statement;
use crate::audit::time::{Source, SyncStatus};

pub(super) fn clock(records: &[Statement]) -> Section {
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
    let rows: Vec<Vec<Cell>> = records.iter().filter(asked).map(server).collect();
    if !rows.is_empty() {
        blocks.push(Block::Text("Dated by a time server that was asked once, without proof of who answered:".into()));
        let head = vec!["Record", "Server", "Stratum", "Local clock off by, ms", "The way hides, ms"];
        blocks.push(Block::Table { head, rows });
    }
    Section { title: "Time", blocks }
}

fn server(record: &Statement) -> Vec<Cell> {
    let (p, time) = (&record.predicate, &record.predicate.time);
    let ms = |us: Option<i64>| us.map_or(String::new(), |us| us.div_euclid(1000).to_string());
    let words = [
        p.chain.seq.to_string(),
        time.reference.clone().unwrap_or_default(),
        time.stratum.map_or(String::new(), |n| n.to_string()),
        ms(time.offset_us),
        ms(time.max_error_us),
    ];
    words.map(Cell::from).to_vec()
}
