//! What the records say of their runs, as tables.

use super::{Block, Cell, Section, table};
use crate::audit::statement::{Input, Model, Outcome, Statement, Tool};

pub(super) fn scenes(records: &[Statement]) -> Section {
    let rows: Vec<Vec<Cell>> = records
        .iter()
        .map(|s| {
            let p = &s.predicate;
            let outcome = match (&p.event.outcome, &p.event.error_code) {
                (Outcome::Success, _) => "success".to_owned(),
                (_, code) => format!("failure {}", code.as_deref().unwrap_or_default()),
            };
            let words = [
                p.time.utc.clone(),
                format!("{}, {outcome}", p.event.kind),
                p.marking.banner.clone(),
                p.inputs.iter().map(|i| i.name.as_str()).collect::<Vec<_>>().join(", "),
                s.subject.len().to_string(),
                format!("{} ({})", p.actor.operator_id, p.actor.auth),
            ];
            std::iter::once(Cell::place(p.chain.seq)).chain(words.map(Cell::from)).collect()
        })
        .collect();
    table("Events", vec!["Record", "UTC", "Event", "Marking", "Inputs", "Outputs", "Operator"], rows)
}

/// Why each product is marked as it is: classification authority, designation of CUI, raising.
pub(super) fn blocks(records: &[Statement]) -> Section {
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

pub(super) fn inputs(records: &[Statement]) -> Section {
    let row = |i: &Input| {
        vec![
            i.name.clone(),
            i.role.clone(),
            i.size.to_string(),
            i.marking.clone().unwrap_or("none".into()),
            i.sha256.clone(),
        ]
    };
    let rows: Vec<Vec<String>> = records.iter().flat_map(|s| s.predicate.inputs.iter().map(row)).collect();
    table("Inputs", vec!["Name", "Role", "Bytes", "Marking inside", "SHA-256"], rows)
}

pub(super) fn outputs(records: &[Statement]) -> Section {
    // Of one folder every output; of a ledger they would be its greater part, and each record lists its own.
    let [record] = records else { return Section { title: "Outputs", blocks: Vec::new() } };
    let rows: Vec<Vec<String>> = record
        .subject
        .iter()
        .map(|s| vec![s.name.clone(), s.annotations.role.clone(), s.annotations.size.clone(), s.digest.sha256.clone()])
        .collect();
    table("Outputs", vec!["Name", "Role", "Bytes", "SHA-256"], rows)
}

/// `allowed`: SHA-256 of the only weights that may have been used.
pub(super) fn models(records: &[Statement], allowed: Option<&[String]>) -> Section {
    let listed = |m: &Model| match (allowed, &m.weights_sha256) {
        (_, None) => "",
        (None, _) => "no list given",
        (Some(list), Some(sha256)) if list.contains(sha256) => "yes",
        _ => "no",
    };
    let row = |m: &Model| {
        let text = |t: &Option<String>| t.clone().unwrap_or_default();
        let status = m.status.clone().unwrap_or("ran".into());
        let pin = [&m.version, &m.runtime, &m.pin_source, &m.weights_sha256].map(text);
        [m.id.clone(), status, listed(m).to_owned()].into_iter().chain(pin).collect()
    };
    let mut rows: Vec<Vec<String>> = records.iter().flat_map(|s| s.predicate.models.iter().map(row)).collect();
    rows.sort();
    rows.dedup();
    table(
        "Model pins",
        vec!["Model", "Status", "On the list", "Version", "Runtime", "Pin from", "Weights' SHA-256"],
        rows,
    )
}

/// Where the program ran, each machine under the name that it has in this ledger.
pub(super) fn places(records: &[Statement]) -> Section {
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
pub(super) fn programs(records: &[Statement]) -> Section {
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
pub(super) fn stated(records: &[Statement]) -> Section {
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
pub(super) fn command_line(records: &[Statement]) -> Section {
    let [record] = records else { return Section { title: "Command line", blocks: Vec::new() } };
    let blocks = record.predicate.source.argv_redacted.iter().map(|words| Block::Commands(words.join(" "))).collect();
    Section { title: "Command line", blocks }
}

pub(super) fn hashes(records: &[Statement]) -> Section {
    let rows: Vec<Vec<String>> = records
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
