//! Levels of detail among their siblings.

use super::{Findings, near};
use crate::openflight::record::opcode;
use crate::openflight::tree::Tree;
use std::collections::BTreeMap;

/// One level of detail as stored.
struct Lod {
    offset: usize,
    switch_in: f64,
    switch_out: f64,
    center: [f64; 3],
    significant_size: f64,
}

pub fn check(tree: &Tree, findings: &mut Findings) {
    let mut siblings: BTreeMap<Option<usize>, Vec<Lod>> = BTreeMap::new();
    for node in tree.nodes.iter().filter(|n| n.record.opcode == opcode::LOD) {
        let record = &node.record;
        let (Ok(switch_in), Ok(switch_out), Ok(center), Ok(significant_size)) =
            (record.f64(16), record.f64(24), record.vec3(40), record.f64(72))
        else {
            findings.at(record.offset, format!("the LOD record has {} bytes instead of 80", record.bytes.len()));
            continue;
        };
        // Also true of NaN.
        if !(switch_in > switch_out && switch_out >= 0.0 && switch_in.is_finite()) {
            let what = format!("switch-in {switch_in} and switch-out {switch_out} leave no distance to be drawn at");
            findings.at(record.offset + 16, what);
        }
        if !significant_size.is_finite() || significant_size < 0.0 {
            findings.at(record.offset + 72, format!("the significant size is {significant_size}"));
        }
        let lod = Lod { offset: record.offset, switch_in, switch_out, center, significant_size };
        siblings.entry(node.parent).or_default().push(lod);
    }
    for pair in siblings.values().flat_map(|s| s.windows(2)) {
        let (coarse, fine) = (&pair[0], &pair[1]);
        if coarse.center != fine.center {
            let what = format!("the centre {:?} differs from the sibling's {:?}", fine.center, coarse.center);
            findings.at(fine.offset + 40, what);
        }
        if fine.significant_size >= coarse.significant_size {
            let (fine_size, size) = (fine.significant_size, coarse.significant_size);
            let what = format!("the significant size {fine_size} is not below the coarser sibling's {size}");
            findings.at(fine.offset + 72, what);
        }
        if !near(fine.switch_in, coarse.switch_out, 1e-9 * coarse.switch_out.abs()) {
            let what = "does not meet the coarser sibling's switch-out";
            findings.at(fine.offset + 16, format!("switch-in {} {what} {}", fine.switch_in, coarse.switch_out));
        }
    }
}
