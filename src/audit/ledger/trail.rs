//! A ledger as a program that stays reads it: each record once, and again only where it is asked for.

use std::fs::File;
use std::io::{BufReader, Read as _, Seek as _, SeekFrom};

use super::{Ledger, is_still_at, read_line_limited};
use crate::audit::checkpoint;
use crate::audit::dsse::MAX_ENVELOPE_BYTES;
use crate::audit::statement::Statement;
use crate::{Error, Result};

/// Where a record's line is, and what it was: about 48 bytes a record.
#[derive(Clone, Copy, Debug)]
struct Entry {
    at: u64,
    bytes: u32,
    /// Which of [`Trail::markings`].
    marking: u32,
    trail_hash: [u8; 32],
}

/// What was read of a ledger, from its first record on: enough to read on from there, and to find each record again.
///
/// Every line's hash and place in the chain are checked when it is first read. A line that is read again must be the same;
/// one that nobody asks for is not looked at again, which `orb audit ledger verify` does.
#[derive(Default)]
pub struct Trail {
    /// Open, so that its number is nobody else's.
    file: Option<File>,
    /// Bytes that were read.
    end: u64,
    last: Option<Statement>,
    entries: Vec<Entry>,
    markings: Vec<String>,
}

impl Trail {
    /// The records from number `from` on whose marking is `shown`, oldest first, `at_most` so many. A line that is being
    /// written is none yet.
    ///
    /// # Errors
    /// Environment where the ledger cannot be read; [`crate::Kind::Integrity`] at the first line that does not follow from the
    /// one before, or is no longer what it was.
    pub fn read(
        &mut self,
        ledger: &Ledger,
        from: u64,
        at_most: usize,
        shown: impl Fn(&str) -> bool,
    ) -> Result<Vec<Statement>> {
        self.catch_up(ledger)?;
        let shown: Vec<bool> = self.markings.iter().map(|m| shown(m)).collect();
        let from = usize::try_from(from).unwrap_or(usize::MAX).min(self.entries.len());
        // Its number is its place: a chain begins at 0 and leaves none out.
        let wanted = self.entries[from..].iter().filter(|e| shown.get(e.marking as usize) == Some(&true));
        let Some(file) = &self.file else { return Ok(Vec::new()) };
        let mut reader = BufReader::new(file);
        let mut out = Vec::new();
        let mut at = None;
        let mut line = Vec::new();
        for entry in wanted.take(at_most) {
            let io = |e: std::io::Error| Error::io(&ledger.path, &e);
            if at != Some(entry.at) {
                reader.seek(SeekFrom::Start(entry.at)).map_err(io)?;
            }
            line.resize(entry.bytes as usize, 0);
            reader.read_exact(&mut line).map_err(io)?;
            at = Some(entry.at + u64::from(entry.bytes));
            let statement = ledger.read_line(&line)?;
            if trail_hash(&statement) != Some(entry.trail_hash) {
                let seq = statement.predicate.chain.seq;
                return Err(ledger.broken(format!("CHAIN_BROKEN: another record {seq} than before")));
            }
            out.push(statement);
        }
        Ok(out)
    }

    /// Reads what was appended since; from the beginning, where the file is another one or shorter.
    fn catch_up(&mut self, ledger: &Ledger) -> Result<()> {
        let io = |e: std::io::Error| Error::io(&ledger.path, &e);
        let still = |file: &File| {
            Ok::<_, std::io::Error>(is_still_at(file, &ledger.path) && file.metadata()?.len() >= self.end)
        };
        let goes_on = self.file.as_ref().is_some_and(|file| still(file).unwrap_or(false));
        if !goes_on {
            *self = Trail { file: Some(File::open(&ledger.path).map_err(io)?), ..Trail::default() };
        }
        let Some(file) = &self.file else { return Ok(()) };
        let mut file = file.try_clone().map_err(io)?;
        file.seek(SeekFrom::Start(self.end)).map_err(io)?;
        let mut reader = BufReader::new(file);
        let mut line = Vec::new();
        while read_line_limited(&mut reader, &mut line).map_err(io)? {
            // Not written to its end yet.
            if line.last() != Some(&b'\n') && line.len() <= MAX_ENVELOPE_BYTES {
                break;
            }
            let statement = ledger.read_line(&line)?;
            ledger.check_follows(self.last.as_ref(), &statement)?;
            let hash = trail_hash(&statement).ok_or_else(|| ledger.broken("a record without a trail hash".into()))?;
            let marking = self.marking(&statement.predicate.marking.banner);
            // Shorter than the limit of a line.
            let bytes = line.len() as u32;
            self.entries.push(Entry { at: self.end, bytes, marking, trail_hash: hash });
            self.end += line.len() as u64;
            self.last = Some(statement);
        }
        Ok(())
    }

    fn marking(&mut self, banner: &str) -> u32 {
        let known = self.markings.iter().position(|m| m == banner).unwrap_or_else(|| {
            self.markings.push(banner.to_owned());
            self.markings.len() - 1
        });
        known as u32
    }
}

fn trail_hash(statement: &Statement) -> Option<[u8; 32]> {
    statement.predicate.trail_hash.as_deref().and_then(checkpoint::hash)
}

#[cfg(test)]
mod tests {
    use std::io::Write as _;
    use std::time::Instant;

    use super::*;
    use crate::Kind;
    use crate::audit::DataFolder;
    use crate::audit::dsse::Envelope;
    use crate::audit::ledger::tests::recorded;

    /// A chain of `count` records with signatures that nobody checks, every tenth marked CUI.
    fn write(ledger: &Ledger, count: u64) {
        let first = recorded();
        let mut statement = first.statement.clone();
        let mut file = std::io::BufWriter::new(std::fs::File::create(ledger.path()).unwrap());
        for seq in 0..count {
            let p = &mut statement.predicate;
            if seq > 0 {
                p.chain.prev = p.trail_hash.clone().unwrap();
            }
            p.chain.seq = seq;
            p.marking.banner = if seq % 10 == 9 { "CUI".into() } else { "UNCLASSIFIED".into() };
            statement.predicate.trail_hash = Some(statement.trail_hash().unwrap());
            let envelope = Envelope { payload: statement.to_payload().unwrap(), ..first.envelope.clone() };
            file.write_all(&envelope.to_line()).unwrap();
        }
    }

    fn ledger(folder: &tempfile::TempDir) -> Ledger {
        Ledger::open(&DataFolder::at(folder.path())).unwrap()
    }

    /// What reading all of it gives.
    fn whole(ledger: &Ledger, from: u64, at_most: usize, shown: impl Fn(&str) -> bool) -> Vec<Statement> {
        let all = ledger.read_chain().unwrap().into_iter();
        let wanted = all.filter(|s| s.predicate.chain.seq >= from && shown(&s.predicate.marking.banner));
        wanted.take(at_most).collect()
    }

    #[test]
    fn the_same_answers_as_reading_all_of_it() {
        let folder = tempfile::tempdir().unwrap();
        let ledger = ledger(&folder);
        let mut trail = Trail::default();
        assert_eq!(trail.read(&ledger, 0, 5, |_| true).unwrap_err().kind, Kind::Environment, "none yet");
        write(&ledger, 25);
        let lines = std::fs::read(ledger.path()).unwrap();
        let ends: Vec<usize> = (0..lines.len()).filter(|i| lines[*i] == b'\n').map(|i| i + 1).collect();
        // As it grows, half a line at the end every time.
        for count in [1, 2, 9, 10, 25] {
            let half = if count < 25 { (ends[count - 1] + ends[count]) / 2 } else { ends[24] };
            std::fs::write(ledger.path(), &lines[..ends[count - 1]]).unwrap();
            let expected: Vec<_> = [(0, 1000), (0, 3), (8, 4), (24, 5), (25, 5), (u64::MAX, 5)]
                .map(|(from, most)| {
                    let shown: fn(&str) -> bool = if most == 4 { |m| m == "CUI" } else { |_| true };
                    (from, most, shown, whole(&ledger, from, most, shown))
                })
                .into();
            std::fs::write(ledger.path(), &lines[..half]).unwrap();
            for (from, most, shown, expected) in expected {
                assert_eq!(trail.read(&ledger, from, most, shown).unwrap(), expected, "{count}: {from}, {most}");
            }
        }
        assert_eq!(trail.read(&ledger, 0, 1000, |m| m == "CUI").unwrap().len(), 2);
        // Another file in its place: an archived ledger, and the one that begins after it.
        std::fs::rename(ledger.path(), folder.path().join("old")).unwrap();
        std::fs::write(ledger.path(), &lines[..ends[0]]).unwrap();
        assert_eq!(trail.read(&ledger, 0, 1000, |_| true).unwrap().len(), 1);
    }

    #[test]
    fn what_was_changed_is_found_where_it_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let ledger = ledger(&folder);
        write(&ledger, 12);
        let lines = std::fs::read(ledger.path()).unwrap();
        let mut trail = Trail::default();
        assert_eq!(trail.read(&ledger, 0, 100, |_| true).unwrap().len(), 12);
        let second = lines.iter().position(|b| *b == b'\n').unwrap() + 1;
        let mut changed = lines.clone();
        changed[second + 40] ^= 1;
        std::fs::write(ledger.path(), &changed).unwrap();
        assert_eq!(trail.read(&ledger, 1, 1, |_| true).unwrap_err().kind, Kind::Integrity);
        assert_eq!(trail.read(&ledger, 2, 100, |_| true).unwrap().len(), 10, "these are as they were");
        assert_eq!(Trail::default().read(&ledger, 2, 100, |_| true).unwrap_err().kind, Kind::Integrity);
        // A record that is sound by itself, of the same length, in another's place.
        let third = second + lines[second..].iter().position(|b| *b == b'\n').unwrap() + 1;
        let mut swapped = lines.clone();
        swapped[second..third].copy_from_slice(&lines[third..2 * third - second]);
        std::fs::write(ledger.path(), &swapped).unwrap();
        let words = trail.read(&ledger, 1, 1, |_| true).unwrap_err().to_string();
        assert!(words.contains("CHAIN_BROKEN"), "{words}");
        // What is appended and does not follow.
        std::fs::write(ledger.path(), [&lines[..], &lines[..second]].concat()).unwrap();
        assert_eq!(trail.read(&ledger, 0, 1, |_| true).unwrap_err().kind, Kind::Integrity);
        // Cut short: no longer the same chain, read anew.
        std::fs::write(ledger.path(), &lines[..third]).unwrap();
        assert_eq!(trail.read(&ledger, 0, 100, |_| true).unwrap().len(), 2);
    }

    /// `cargo test --release --lib -- --ignored --nocapture a_hundred_thousand_records`
    #[test]
    #[ignore = "measures"]
    fn a_hundred_thousand_records() {
        let folder = tempfile::tempdir().unwrap();
        let ledger = ledger(&folder);
        write(&ledger, 100_000);
        let bytes = std::fs::metadata(ledger.path()).unwrap().len();
        println!("{:.1} MB", bytes as f64 / 1e6);
        let time = |what: &str, work: &mut dyn FnMut() -> usize| {
            let begin = Instant::now();
            let records = work();
            println!("{what}: {records} records, {:.1} ms", begin.elapsed().as_secs_f64() * 1e3);
        };
        time("all of it, the last 100", &mut || whole(&ledger, 99_900, 1000, |_| true).len());
        let mut trail = Trail::default();
        time("the first time, the last 100", &mut || trail.read(&ledger, 99_900, 1000, |_| true).unwrap().len());
        time("again, the last 100", &mut || trail.read(&ledger, 99_900, 1000, |_| true).unwrap().len());
        time("1000 from the middle", &mut || trail.read(&ledger, 50_000, 1000, |_| true).unwrap().len());
        time("1000 marked CUI", &mut || trail.read(&ledger, 0, 1000, |m| m == "CUI").unwrap().len());
        time("none", &mut || trail.read(&ledger, 100_000, 1000, |_| true).unwrap().len());
    }
}
