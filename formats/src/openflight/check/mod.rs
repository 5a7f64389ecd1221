//! Looks a file over for what readers stumble on.

mod levels;
mod palettes;
mod surfaces;

use super::header::{self, REVISION};
use super::record::{Record, opcode};
use super::tree::Tree;
use crate::Error;
use std::collections::BTreeSet;

/// More findings than this are only counted.
const MOST: usize = 200;

/// Checks a file against the structural rules of OpenFlight 16.0 and the habits of its readers; each finding is a
/// sentence with the byte offset. Empty for a sound file.
///
/// Checked: record lengths, push and pop balance, header settings, palette indices, vertex offsets, degenerate
/// polygons, pool sizes and indices, names and text fields, texture paths, levels of detail (one centre, ranges that
/// meet, decreasing significant sizes), bounding boxes, unit normals, finite numbers, winding against the normals.
/// Whether the texture files exist is for the caller, who knows the folder.
pub fn check(bytes: &[u8]) -> Vec<String> {
    let tree = Tree::of(bytes);
    let mut findings = Findings::default();
    for fault in &tree.faults {
        findings.error(fault);
    }
    if tree.faults.is_empty() && tree.end < bytes.len() {
        let rest = bytes.len() - tree.end;
        findings.at(tree.end, format!("{rest} bytes follow the last pop, and readers will not see them"));
    }
    if let Some(record) = &tree.header {
        check_header(record, &mut findings);
    }
    check_lengths(&tree, &mut findings);
    let palettes = palettes::check(&tree, &mut findings);
    let vertices = palettes::check_vertices(&tree, &mut findings);
    let boxes = surfaces::check(&tree, &palettes, &vertices, &mut findings);
    check_names(&tree, &mut findings);
    surfaces::check_boxes(&tree, boxes, &mut findings);
    levels::check(&tree, &mut findings);
    findings.finish()
}

#[derive(Default)]
struct Findings {
    sentences: Vec<String>,
    more: usize,
}

impl Findings {
    fn at(&mut self, offset: usize, what: String) {
        if self.sentences.len() < MOST {
            self.sentences.push(format!("At byte {offset}: {what}."));
        } else {
            self.more += 1;
        }
    }

    fn error(&mut self, error: &Error) {
        match error {
            Error::Malformed { offset, expected, found, .. } => {
                self.at(*offset as usize, format!("expected {expected}, found {found}"));
            }
            other => self.at(0, other.to_string()),
        }
    }

    fn finish(mut self) -> Vec<String> {
        if self.more > 0 {
            self.sentences.push(format!("There are {} more findings.", self.more));
        }
        self.sentences
    }
}

fn check_header(record: &Record, findings: &mut Findings) {
    if record.bytes.len() != header::LENGTH {
        findings.at(record.offset, format!("the header has {} bytes instead of 324", record.bytes.len()));
        return;
    }
    let mut expect = |at: usize, what: &str, wanted: i32, found: i32| {
        if wanted != found {
            findings.at(record.offset + at, format!("the {what} is {found} instead of {wanted}"));
        }
    };
    let int = |at: usize| record.i32(at).unwrap_or_default();
    expect(12, "format revision", REVISION, int(12));
    expect(60, "unit multiplier", 1, i32::from(record.i16(60).unwrap_or_default()));
    expect(62, "coordinate unit", 0, i32::from(record.bytes[62]));
    expect(92, "projection", 0, int(92));
    expect(268, "ellipsoid", 0, int(268));
    check_text(record, 4, 8, "header ID", findings);
    check_text(record, 20, 32, "date", findings);
    for at in [132, 140, 148, 156, 188, 196, 204, 212, 220, 228, 236, 244, 284, 292, 308, 316] {
        if !record.f64(at).is_ok_and(f64::is_finite) {
            findings.at(record.offset + at, "a header number is not finite".into());
        }
    }
}

/// A text field of the given size: ASCII with a NUL inside.
fn check_text(record: &Record, at: usize, size: usize, what: &str, findings: &mut Findings) {
    let (text, terminated) = record.text_bytes(at, size);
    if !terminated {
        findings.at(record.offset + at, format!("the {what} has no NUL inside its field"));
    }
    if !text.is_ascii() {
        findings.at(record.offset + at, format!("the {what} is not ASCII"));
    }
}

fn check_lengths(tree: &Tree, findings: &mut Findings) {
    let ancillaries = tree.nodes.iter().flat_map(|n| std::iter::once(&n.record).chain(&n.ancillaries));
    let palettes = tree.header.iter().chain(&tree.palettes).chain(&tree.vertex_palette).chain(&tree.vertices);
    for record in palettes.chain(ancillaries) {
        // A joined record's length says nothing about its pieces, which are multiples of 4 when the sum is.
        if record.bytes.len() % 4 != 0 {
            let (code, length) = (record.opcode, record.bytes.len());
            findings.at(record.offset, format!("record {code} has {length} bytes, which is no multiple of 4"));
        }
        if matches!(record.opcode, opcode::COMMENT | opcode::LONG_ID) {
            check_text(record, 4, usize::MAX, "text", findings);
        }
    }
}

fn check_names(tree: &Tree, findings: &mut Findings) {
    let mut seen = BTreeSet::new();
    for node in &tree.nodes {
        let named = matches!(
            node.record.opcode,
            opcode::GROUP | opcode::OBJECT | opcode::FACE | opcode::LOD | opcode::MESH | 14 | 63 | 96
        );
        if !named || node.record.opcode == 63 {
            continue; // an external reference has a path instead
        }
        if matches!(node.record.opcode, opcode::GROUP | opcode::OBJECT | opcode::LOD) {
            check_text(&node.record, 4, 8, "ID", findings);
        }
        let name = node.name();
        if name.is_empty() {
            findings.at(node.record.offset, "a node has no ID".into());
        } else if !seen.insert(name) {
            findings.at(node.record.offset, format!("the ID {:?} is used twice", node.name()));
        }
    }
}

/// False for NaN.
fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance
}
