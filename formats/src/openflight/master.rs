//! Master files: levels of detail that stand in files of their own.

use super::header::{Header, next};
use super::palette;
use super::record::{Writer, opcode};
use super::tree::Tree;
use super::write::{MAX_STRING, check_range, refuse, relative, text, write_lod_record, write_zone};
use super::{FORMAT, header};
use crate::{Error, Result};

/// A root group whose levels refer to other files: a geotypical model's entry in a CDB.
///
/// Text and lengths as in [`Model`](super::Model).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Master {
    pub name: String,
    pub date: String,
    pub header_comment: Option<String>,
    pub zone_comment: Option<String>,
    /// The smallest box around all levels: lowest and highest corner.
    pub bounds: ([f64; 3], [f64; 3]),
    /// Coarsest first.
    pub levels: Vec<Reference>,
}

/// A level of detail in another file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reference {
    pub name: String,
    pub switch_in: f64,
    pub switch_out: f64,
    pub transition: f64,
    pub significant_size: f64,
    pub center: [f64; 3],
    /// Relative to the master file, `/` between folders, at most 199 characters.
    pub path: String,
}

impl Reference {
    fn range(&self) -> [f64; 4] {
        [self.switch_in, self.switch_out, self.transition, self.significant_size]
    }
}

/// Writes a master file: each level a LOD record with one external reference, which keeps its own palettes.
///
/// # Errors
/// [`Error::Unsupported`] for text that is not ASCII or too long, paths that are not relative, no level, numbers that are
/// not finite, a far limit that is not beyond the near one.
pub fn write_master(master: &Master) -> Result<Vec<u8>> {
    text("the root group's name", &master.name, MAX_STRING)?;
    text("the date", &master.date, 31)?;
    for comment in [&master.header_comment, &master.zone_comment].into_iter().flatten() {
        text("a comment", comment, MAX_STRING)?;
    }
    if master.levels.is_empty() {
        return refuse("a master file needs at least one level of detail".into());
    }
    for level in &master.levels {
        text("a level's name", &level.name, MAX_STRING)?;
        relative("an external reference", &level.path)?;
        check_range(&format!("level {:?}", level.name), level.range(), &level.center)?;
    }
    let (lo, hi) = master.bounds;
    let farthest = (0..3).map(|a| lo[a].abs().max(hi[a].abs()).powi(2)).sum::<f64>().sqrt();
    if !lo.iter().chain(&hi).all(|x| x.is_finite()) {
        return refuse(format!("the box {:?} is not finite", master.bounds));
    }
    let levels = next(master.levels.len());
    let head = Header { next_ids: [2, levels, 1, 1], radius: farthest, ..Header::around(&master.date, None, (lo, hi)) };
    let mut out = Writer::with_capacity(6000 + 400 * master.levels.len());
    head.write(&mut out);
    if let Some(comment) = &master.header_comment {
        out.string_record(opcode::COMMENT, comment);
    }
    palette::write_colors(&mut out);
    out.control(opcode::PUSH);
    write_zone(&mut out, &master.name, master.zone_comment.as_deref(), master.bounds);
    out.control(opcode::PUSH);
    for (index, level) in master.levels.iter().enumerate() {
        write_lod_record(&mut out, &level.name, index + 1, level.range(), &level.center);
        out.control(opcode::PUSH);
        out.begin(opcode::EXTERNAL_REFERENCE);
        out.text(&level.path, 200);
        out.zeros(4);
        out.u32(0xff00_0000); // the file keeps its palettes
        out.zeros(4);
        out.end();
        out.control(opcode::POP);
    }
    out.control(opcode::POP);
    out.control(opcode::POP);
    Ok(out.bytes)
}

/// Reads the levels of a master file: every external reference with the LOD record above it.
///
/// # Errors
/// [`Error::Malformed`] with the byte offset where the file breaks the format.
pub fn read_master(bytes: &[u8]) -> Result<Master> {
    let mut tree = Tree::of(bytes);
    if !tree.faults.is_empty() {
        return Err(tree.faults.swap_remove(0));
    }
    let Some(head) = &tree.header else {
        return Err(Error::malformed(FORMAT, 0, "a header record", "none"));
    };
    let head = header::read(head)?;
    let root = tree.nodes.iter().find(|n| n.parent.is_none() && n.record.opcode == opcode::GROUP);
    let text = |record: Option<&super::record::Record>| record.map(|r| r.string(4));
    let mut master = Master {
        name: root.map(|n| n.name()).unwrap_or_default(),
        date: head.date,
        header_comment: text(tree.palettes.iter().find(|r| r.opcode == opcode::COMMENT)),
        zone_comment: text(root.and_then(|n| n.ancillary(opcode::COMMENT))),
        ..Master::default()
    };
    if let Some(stored) = root.and_then(|n| n.ancillary(opcode::BOUNDING_BOX)) {
        master.bounds = (stored.vec3(8)?, stored.vec3(32)?);
    }
    // Parents come first: one pass, however deep the groups are nested.
    let mut lods_above: Vec<Option<usize>> = Vec::with_capacity(tree.nodes.len());
    for node in &tree.nodes {
        let lod = node.parent.and_then(|p| match tree.nodes[p].record.opcode {
            opcode::LOD => Some(p),
            _ => lods_above[p],
        });
        lods_above.push(lod);
        if node.record.opcode != opcode::EXTERNAL_REFERENCE {
            continue;
        }
        let mut level = Reference { path: node.record.text(4, 200), ..Reference::default() };
        if let Some(above) = lod.map(|i| &tree.nodes[i]) {
            level.name = above.name();
            level.switch_in = above.record.f64(16)?;
            level.switch_out = above.record.f64(24)?;
            level.center = above.record.vec3(40)?;
            level.transition = above.record.f64(64).unwrap_or(0.0);
            level.significant_size = above.record.f64(72).unwrap_or(0.0);
        }
        master.levels.push(level);
    }
    Ok(master)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn master() -> Master {
        let level = |name: &str, switch_in, switch_out, significant_size| Reference {
            name: name.into(),
            switch_in,
            switch_out,
            transition: (switch_in - switch_out) / 10.0,
            significant_size,
            center: [0.0, 0.0, 1.0],
            path: format!("./L04/{name}.flt"),
        };
        Master {
            name: "House".into(),
            date: "Mon Jan  1 00:00:00 2024".into(),
            header_comment: Some("UNCLASSIFIED".into()),
            zone_comment: Some("<CDB:Zone name=\"House\"/>".into()),
            bounds: ([-1.0, -2.0, 0.0], [1.0, 2.0, 3.0]),
            levels: vec![level("coarse", 20_000.0, 300.0, 5.0), level("fine", 300.0, 0.0, 0.3)],
        }
    }

    #[test]
    fn what_is_written_reads_back_and_is_sound() {
        let bytes = write_master(&master()).unwrap();
        assert_eq!(read_master(&bytes), Ok(master()));
        assert_eq!(super::super::check(&bytes), Vec::<String>::new());
        assert_eq!(super::super::read(&bytes).unwrap().levels, [], "it draws nothing itself");
        for end in 0..bytes.len() - 4 {
            assert!(read_master(&bytes[..end]).map_or(true, |m| m.levels.is_empty()), "{end}");
        }
    }

    #[test]
    fn references_below_many_groups_are_read_in_one_pass() {
        const DEEP: usize = 50_000;
        let mut out = Writer::with_capacity(0);
        Header::around("", None, ([0.0; 3], [1.0; 3])).write(&mut out);
        out.control(opcode::PUSH);
        write_lod_record(&mut out, "outer", 1, [100.0, 0.0, 0.0, 1.0], &[0.0; 3]);
        out.control(opcode::PUSH);
        for _ in 0..DEEP {
            out.begin(opcode::GROUP);
            out.text("g", 8);
            out.zeros(32);
            out.end();
            out.control(opcode::PUSH);
        }
        for _ in 0..DEEP {
            out.begin(opcode::EXTERNAL_REFERENCE);
            out.text("a.flt", 200);
            out.zeros(12);
            out.end();
        }
        (0..DEEP + 2).for_each(|_| out.control(opcode::POP));
        let began = std::time::Instant::now();
        let levels = read_master(&out.bytes).unwrap().levels;
        assert!(began.elapsed().as_secs_f64() < 2.0, "{:?}", began.elapsed());
        assert!(levels.len() == DEEP && levels.iter().all(|l| l.switch_in == 100.0 && l.significant_size == 1.0));
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let refused = |change: fn(&mut Master)| {
            let mut m = master();
            change(&mut m);
            write_master(&m).unwrap_err().to_string()
        };
        assert!(refused(|m| m.levels.clear()).contains("at least one level"));
        assert!(refused(|m| m.levels[0].path = "/etc/x.flt".into()).contains("relative"));
        assert!(refused(|m| m.levels[0].path = "x".repeat(200)).contains("199"));
        assert!(refused(|m| m.levels[1].switch_in = 0.0).contains("never drawn"));
        assert!(refused(|m| m.bounds.1[0] = f64::NAN).contains("finite"));
        assert!(refused(|m| m.name = "Maß".into()).contains("ASCII"));
    }
}
