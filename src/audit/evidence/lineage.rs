//! What was made of what: the files that went into a record, what worked on them, the files that came out, and the seal
//! around them. Drawn by [`super::picture`], said in words in Markdown and for who does not see the picture.
//!
//! A record names the files of a run and what ran, not which network read which file: neither does this.

use std::collections::BTreeMap;

use super::{Block, Evidence, Section, fingerprints, table};
use crate::audit::publication::STORE_PREFIX;
use crate::audit::report::{Finding, Report};
use crate::audit::statement::{Input, Model, Outcome, Statement, Subject};

/// More files of one side than this are gathered by their roles: the tables list each.
const MOST_BOXES: usize = 14;

/// One record as a picture's content.
#[derive(Debug)]
pub(super) struct Lineage {
    /// Of the picture too, which may be cut out of its page.
    pub banner: String,
    pub inputs: Vec<Item>,
    pub run: Item,
    pub models: Vec<Item>,
    /// Networks that the record says it did without.
    pub not_used: Vec<String>,
    pub outputs: Vec<Item>,
    /// What seals all of it.
    pub seal: Vec<String>,
}

/// A file, some files, a network or the run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Item {
    pub name: String,
    pub lines: Vec<String>,
    /// How many files it stands for.
    pub files: usize,
    /// The verification found something wrong with one of them.
    pub flawed: bool,
}

impl Lineage {
    /// All of it in words, a line for each thing: what it is, its name, what is known of it.
    pub fn words(&self) -> Vec<(&'static str, Vec<String>)> {
        let said = |items: &[Item]| {
            let none = items.is_empty().then(|| "none".to_owned());
            items.iter().map(Item::sentence).chain(none).collect::<Vec<_>>()
        };
        let mut models = said(&self.models);
        if !self.not_used.is_empty() {
            models.push(format!("not used: {}", self.not_used.join(", ")));
        }
        vec![
            ("Inputs", said(&self.inputs)),
            ("Run", vec![self.run.sentence()]),
            ("Models", models),
            ("Outputs", said(&self.outputs)),
            ("Sealed", self.seal.clone()),
        ]
    }
}

impl Item {
    fn sentence(&self) -> String {
        std::iter::once(self.name.as_str()).chain(self.lines.iter().map(String::as_str)).collect::<Vec<_>>().join("; ")
    }
}

/// Of one record a picture; of several, which of them took what another had made.
pub(super) fn section(evidence: &Evidence<'_>, records: &[Statement]) -> Section {
    match records {
        [record] if !(record.predicate.inputs.is_empty() && record.subject.is_empty()) => {
            Section { title: "Lineage", blocks: vec![Block::Lineage(Box::new(of_record(record, evidence.report)))] }
        }
        [_] | [] => Section { title: "Lineage", blocks: Vec::new() },
        _ => between(records),
    }
}

fn of_record(record: &Statement, report: &Report) -> Lineage {
    let (p, findings) = (&record.predicate, report.findings.as_slice());
    let outcome = match p.event.outcome {
        Outcome::Success => "success",
        Outcome::Failure => "failure",
    };
    let run = Item {
        name: p.source.command.clone(),
        lines: vec![
            format!("{}, {outcome}", p.event.kind),
            p.time.utc.clone(),
            format!("{} {}, commit {}", p.tool.name, p.tool.version, short(p.tool.git_commit.as_deref())),
            format!("record {} of ledger {}", p.chain.seq, p.chain.ledger_id),
        ],
        files: 0,
        flawed: false,
    };
    let (not_used, ran): (Vec<&Model>, Vec<&Model>) =
        p.models.iter().partition(|m| m.status.as_deref() == Some("not-used"));
    let algorithms = super::algorithms(&p.actor);
    Lineage {
        banner: report.marking.clone().unwrap_or_else(|| p.marking.banner.clone()),
        inputs: gathered(p.inputs.iter().map(|i| of_input(i, report)).collect()),
        run,
        models: ran.into_iter().map(of_model).collect(),
        not_used: not_used.into_iter().map(|m| m.id.clone()).collect(),
        outputs: gathered(record.subject.iter().map(|s| of_output(s, findings)).collect()),
        seal: vec![
            format!("trail hash {}", p.trail_hash.as_deref().unwrap_or_default()),
            format!("signed {algorithms} by key {}", fingerprints(&p.actor)),
            format!("operator {} ({})", p.actor.operator_id, p.actor.auth),
        ],
    }
}

/// A file before it is gathered with others.
struct File {
    name: String,
    role: String,
    bytes: u64,
    lines: Vec<String>,
    flawed: bool,
}

fn of_input(input: &Input, report: &Report) -> File {
    let mut lines = vec![format!("SHA-256 {}", short(Some(&input.sha256)))];
    lines.extend(input.marking.as_ref().map(|m| format!("marked {m} inside")));
    // A verification that ended before the inputs, and that of a ledger, say nothing of any.
    let missing = report.findings.iter().any(|f| f.code == "INPUT_MISSING" && f.subject == input.name);
    let compared = report.counts.inputs_verified > 0 && !missing;
    lines.push(if compared { "compared: the same" } else { "not compared here" }.into());
    File { name: input.name.clone(), role: input.role.clone(), bytes: input.size, lines, flawed: false }
}

fn of_output(subject: &Subject, findings: &[Finding]) -> File {
    let mut lines = vec![format!("SHA-256 {}", short(Some(&subject.digest.sha256)))];
    let wrong: Vec<&str> = findings
        .iter()
        .filter(|f| f.subject == subject.name && ["OUTPUT_", "PATH_", "MARKING_"].iter().any(|c| f.code.starts_with(c)))
        .map(|f| f.code)
        .collect();
    lines.extend(wrong.iter().map(|code| format!("found: {code}")));
    File {
        name: subject.name.clone(),
        role: subject.annotations.role.clone(),
        bytes: subject.annotations.size.parse().unwrap_or_default(),
        lines,
        flawed: !wrong.is_empty(),
    }
}

fn of_model(model: &Model) -> Item {
    let version = model.version.as_ref().map(|v| format!(" {v}")).unwrap_or_default();
    let mut lines = vec![match &model.weights_sha256 {
        Some(sha256) => format!("weights {}", short(Some(sha256))),
        None => "a program, without weights".into(),
    }];
    lines.extend(model.runtime.as_ref().map(|r| format!("ran on {r}")));
    Item { name: format!("{}{version}", model.id), lines, files: 0, flawed: false }
}

/// Files of a folder become one item, those of a store another; of what is left, when it is still many, those of one role.
fn gathered(files: Vec<File>) -> Vec<Item> {
    let folder = |file: &File| match file.name.strip_prefix(STORE_PREFIX) {
        Some(_) => Some("the store it was merged into".to_owned()),
        None => file.name.split_once('/').map(|(folder, _)| format!("{folder}/")),
    };
    let mut items = by(files, folder);
    let singles = items.iter().filter(|(_, files)| files.len() == 1).count();
    if singles > MOST_BOXES {
        let (some, alone): (Vec<_>, Vec<_>) = items.into_iter().partition(|(_, files)| files.len() > 1);
        let alone = alone.into_iter().flat_map(|(_, files)| files).collect();
        items = some;
        items.extend(by(alone, |file| Some(format!("{}: ", file.role))));
    }
    let rest: Vec<File> =
        items.split_off(items.len().min(2 * MOST_BOXES)).into_iter().flat_map(|(_, files)| files).collect();
    if !rest.is_empty() {
        items.push(("others: ".into(), rest));
    }
    items.into_iter().map(|(name, files)| item(name, files)).collect()
}

/// Files of one name of `what` together, where the first of them stood.
fn by(files: Vec<File>, what: impl Fn(&File) -> Option<String>) -> Vec<(String, Vec<File>)> {
    let mut groups: Vec<(String, Vec<File>)> = Vec::new();
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    for file in files {
        let group = what(&file);
        let name = group.clone().unwrap_or_else(|| file.name.clone());
        match group.and_then(|g| places.get(&g)).and_then(|at| groups.get_mut(*at)) {
            Some((_, members)) => members.push(file),
            None => {
                places.insert(name.clone(), groups.len());
                groups.push((name, vec![file]));
            }
        }
    }
    groups
}

fn item(name: String, mut files: Vec<File>) -> Item {
    if files.len() == 1
        && let Some(file) = files.pop()
    {
        let lines = std::iter::once(format!("{}, {}", file.role, bytes(file.bytes))).chain(file.lines).collect();
        return Item { name: file.name, lines, files: 1, flawed: file.flawed };
    }
    let mut roles: Vec<&str> = files.iter().map(|f| f.role.as_str()).collect();
    roles.sort_unstable();
    roles.dedup();
    let sum = files.iter().fold(0u64, |sum, f| sum.saturating_add(f.bytes));
    let mut lines = vec![format!("{}, {}", roles.join(", "), bytes(sum))];
    let flawed = files.iter().filter(|f| f.flawed).count();
    if flawed > 0 {
        lines.push(format!("found: {flawed} of them not as sealed"));
    }
    lines.push("each in the table below".into());
    let space = if name.ends_with(": ") { "" } else { ", " };
    Item { name: format!("{name}{space}{} files", files.len()), lines, files: files.len(), flawed: flawed > 0 }
}

/// Twelve digits are enough to find a digest in the tables.
fn short(digest: Option<&str>) -> String {
    match digest.and_then(|d| d.get(..12)) {
        Some(head) => format!("{head}…"),
        None => digest.unwrap_or("unknown").to_owned(),
    }
}

fn bytes(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    format!("{out} byte{}", if n == 1 { "" } else { "s" })
}

/// Which record took what another one had made, by digest.
fn between(records: &[Statement]) -> Section {
    let mut made: BTreeMap<&str, (u64, &str)> = BTreeMap::new();
    for s in records {
        for subject in &s.subject {
            made.entry(&subject.digest.sha256).or_insert((s.predicate.chain.seq, &subject.name));
        }
    }
    let mut rows = Vec::new();
    for Statement { predicate: p, .. } in records {
        for input in &p.inputs {
            if let Some((seq, name)) = made.get(input.sha256.as_str()).filter(|(seq, _)| *seq < p.chain.seq) {
                let of = format!("{} ({})", p.chain.seq, p.event.kind);
                rows.push(vec![of, input.name.clone(), seq.to_string(), (*name).to_owned(), input.sha256.clone()]);
            }
        }
    }
    if rows.is_empty() {
        let text =
            "No record here took what another one of them had made. The report of a folder draws its own lineage.";
        return Section { title: "Lineage", blocks: vec![Block::Text(text.into())] };
    }
    table("Lineage", vec!["Record", "Took", "Made by record", "As", "SHA-256"], rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(name: &str, role: &str) -> File {
        File { name: name.into(), role: role.into(), bytes: 1000, lines: vec!["SHA-256 ab…".into()], flawed: false }
    }

    #[test]
    fn files_are_gathered_and_none_is_lost() {
        let few =
            gathered(vec![file("a.jpg", "photo"), file("x/1", "cdb"), file("b.jpg", "photo"), file("x/2", "cdb")]);
        let names: Vec<&str> = few.iter().map(|i| i.name.as_str()).collect();
        assert_eq!(names, ["a.jpg", "x/, 2 files", "b.jpg"]);
        assert_eq!(few[1].lines, ["cdb, 2,000 bytes", "each in the table below"]);
        assert_eq!(few[0].lines, ["photo, 1,000 bytes", "SHA-256 ab…"]);

        let photos = (0..200).map(|i| file(&format!("{i}.jpg"), "photo"));
        let many =
            gathered(photos.chain([file("s.csv", "poses"), file("store:q", "cdb"), file("store:r", "cdb")]).collect());
        let names: Vec<&str> = many.iter().map(|i| i.name.as_str()).collect();
        assert_eq!(names, ["the store it was merged into, 2 files", "photo: 200 files", "s.csv"]);

        // However many folders and roles: a picture of some height, and the numbers add up.
        let folders = (0..500).flat_map(|i| [file(&format!("{i}/a"), "x"), file(&format!("{i}/b"), "x")]);
        let items = gathered(folders.chain((0..500).map(|i| file(&format!("{i}.x"), &format!("role {i}")))).collect());
        assert!(items.len() <= 2 * MOST_BOXES + 1, "{}", items.len());
        assert_eq!(items.iter().map(|i| i.files).sum::<usize>(), 1500);
        assert!(items.last().unwrap().name.starts_with("others: "));
    }

    #[test]
    fn numbers_in_words() {
        assert_eq!(
            [0, 1, 999, 1000, 1_234_567].map(bytes).join("; "),
            "0 bytes; 1 byte; 999 bytes; 1,000 bytes; 1,234,567 bytes"
        );
        assert_eq!(
            (short(Some("abcdefabcdefabcdef")), short(Some("ab")), short(None)),
            ("abcdefabcdef…".into(), "ab".into(), "unknown".into())
        );
    }
}
