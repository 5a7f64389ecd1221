//! The file's structure: palettes, then nodes with their ancillary records, parents before children.

use super::FORMAT;
use super::record::{Record, opcode, records};
use crate::Error;

pub struct Tree<'a> {
    pub header: Option<Record<'a>>,
    /// Ancillary records of the header and palettes, without the vertex palette.
    pub palettes: Vec<Record<'a>>,
    pub vertex_palette: Option<Record<'a>>,
    pub vertices: Vec<Record<'a>>,
    pub nodes: Vec<Node<'a>>,
    /// Bytes up to the last pop of the root level.
    pub end: usize,
    /// What breaks the structure, in file order.
    pub faults: Vec<Error>,
}

pub struct Node<'a> {
    pub record: Record<'a>,
    /// Index of its parent, which comes before it.
    pub parent: Option<usize>,
    pub ancillaries: Vec<Record<'a>>,
}

impl Node<'_> {
    pub fn ancillary(&self, opcode: u16) -> Option<&Record<'_>> {
        self.ancillaries.iter().find(|r| r.opcode == opcode)
    }

    /// The long ID, or the seven characters of the primary record.
    pub fn name(&self) -> String {
        self.ancillary(opcode::LONG_ID).map_or_else(|| self.record.text(4, 8), |long| long.string(4))
    }
}

impl<'a> Tree<'a> {
    /// Sorts the records; faults do not stop it where the rest can still be understood.
    pub fn of(bytes: &'a [u8]) -> Self {
        let mut tree = Tree {
            header: None,
            palettes: Vec::new(),
            vertex_palette: None,
            vertices: Vec::new(),
            nodes: Vec::new(),
            end: bytes.len(),
            faults: Vec::new(),
        };
        // The parents of the open levels; `last` is the node that a push would open.
        let mut open: Vec<Option<usize>> = Vec::new();
        let mut last: Option<usize> = None;
        let mut in_palette = false; // vertex records must follow the vertex palette without a gap
        for record in records(bytes) {
            let record = match record {
                Ok(record) => record,
                Err(fault) => {
                    tree.faults.push(fault);
                    break;
                }
            };
            let code = record.opcode;
            if record.offset == 0 && code != opcode::HEADER {
                tree.fault(0, "a header record (opcode 1)", format!("opcode {code}"));
                break;
            }
            match code {
                opcode::HEADER if record.offset == 0 => tree.header = Some(record),
                opcode::PUSH | opcode::PUSH_SUBFACE => open.push(last),
                opcode::POP | opcode::POP_SUBFACE => match open.pop() {
                    None => {
                        tree.fault(record.offset, "a push before this pop", "none open".into());
                        tree.end = record.offset + record.bytes.len();
                        break;
                    }
                    Some(parent) => {
                        last = parent;
                        if open.is_empty() {
                            tree.end = record.offset + record.bytes.len();
                            break;
                        }
                    }
                },
                opcode::VERTEX_PALETTE if tree.vertex_palette.is_none() => {
                    tree.vertex_palette = Some(record);
                    in_palette = true;
                    continue;
                }
                opcode::VERTEX_PALETTE => tree.fault(record.offset, "one vertex palette", "another one".into()),
                opcode::VERTEX_C..=opcode::VERTEX_CUV if in_palette => {
                    tree.vertices.push(record);
                    continue;
                }
                opcode::VERTEX_C..=opcode::VERTEX_CUV => {
                    tree.fault(record.offset, "vertex records right after the palette", "one apart".into());
                }
                _ if opcode::is_node(code) && !open.is_empty() => {
                    last = Some(tree.nodes.len());
                    let parent = *open.last().unwrap_or(&None);
                    tree.nodes.push(Node { record, parent, ancillaries: Vec::new() });
                }
                _ if opcode::is_node(code) => {
                    tree.fault(record.offset, "a push before the first node", format!("node record {code}"));
                }
                _ => match last {
                    Some(node) if !open.is_empty() => tree.nodes[node].ancillaries.push(record),
                    _ => tree.palettes.push(record),
                },
            }
            in_palette = false;
        }
        if tree.header.is_none() && tree.faults.is_empty() {
            tree.fault(0, "a header record (opcode 1)", "an empty file".into());
        }
        if !open.is_empty() && tree.faults.is_empty() {
            let found = format!("the end of the file with {} levels open", open.len());
            tree.fault(bytes.len(), "a pop for every push", found);
        }
        tree
    }

    fn fault(&mut self, offset: usize, expected: &str, found: String) {
        let offset = offset as u64;
        self.faults.push(Error::Malformed { format: FORMAT, offset, expected: expected.into(), found });
    }
}
