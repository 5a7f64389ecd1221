use super::*;
use crate::Kind;
use crate::audit::keys::tests::shared_key;
use crate::audit::record::{self, tests::draft};
use crate::audit::statement::Outcome;

fn append(ledger: &mut Ledger) -> Result<Recorded> {
    let seal = |place| record::seal(&draft(), Vec::new(), Outcome::Success, None, place, shared_key());
    ledger.append(shared_key(), seal, |_, _| Ok(()))
}

/// Some record that stands in some ledger.
pub(crate) fn recorded() -> &'static Recorded {
    static RECORDED: std::sync::OnceLock<Recorded> = std::sync::OnceLock::new();
    RECORDED.get_or_init(|| {
        let dir = tempfile::tempdir().unwrap();
        append(&mut Ledger::open(&DataFolder::at(dir.path())).unwrap()).unwrap()
    })
}

#[test]
fn each_record_names_the_one_before() {
    let dir = tempfile::tempdir().unwrap();
    let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
    let made: Vec<Recorded> = (0..3).map(|_| append(&mut ledger).unwrap()).collect();
    for (i, pair) in made.windows(2).enumerate() {
        let chain = &pair[1].statement.predicate.chain;
        assert_eq!(chain.seq, i as u64 + 1);
        assert_eq!(chain.prev, pair[0].trail_hash);
        assert_eq!(chain.ledger_id, pair[0].statement.predicate.chain.ledger_id);
    }
    assert_eq!(ledger.read_chain().unwrap().len(), 3);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        assert_eq!(std::fs::metadata(ledger.path()).unwrap().permissions().mode() & 0o777, 0o600);
    }
}

#[test]
fn two_runs_at_once_share_one_chain() {
    let dir = tempfile::tempdir().unwrap();
    let data = DataFolder::at(dir.path());
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                let mut ledger = Ledger::open(&data).unwrap();
                for _ in 0..4 {
                    append(&mut ledger).unwrap();
                }
            });
        }
    });
    assert_eq!(Ledger::open(&data).unwrap().read_chain().unwrap().len(), 16);
}

#[test]
fn a_half_written_line_is_set_aside() {
    let dir = tempfile::tempdir().unwrap();
    let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
    append(&mut ledger).unwrap();
    let whole = std::fs::read(ledger.path()).unwrap();
    for cut in [whole.len() - 1, whole.len() / 2, 1] {
        for before in [&whole[..], &[]] {
            std::fs::write(ledger.path(), [before, &whole[..cut]].concat()).unwrap();
            // Of the records that are gone from the file now.
            std::fs::remove_file(ledger.path().with_file_name("head.json")).unwrap();
            append(&mut ledger).unwrap();
            let records = ledger.read_chain().unwrap();
            assert_eq!(records.len(), usize::from(!before.is_empty()) + 1);
        }
    }
    let aside = std::fs::read(ledger.path().with_extension("incomplete")).unwrap();
    assert_eq!(aside.iter().filter(|b| **b == b'\n').count(), 6);
}

#[test]
fn nothing_is_appended_to_a_changed_ledger() {
    let dir = tempfile::tempdir().unwrap();
    let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
    append(&mut ledger).unwrap();
    append(&mut ledger).unwrap();
    let good = std::fs::read_to_string(ledger.path()).unwrap();
    let lines: Vec<&str> = good.lines().collect();
    // The payload's base64 is changed inside the last line.
    let mut bad = good.clone().into_bytes();
    let at = lines[0].len() + 1 + 400;
    bad[at] = if bad[at] == b'A' { b'B' } else { b'A' };
    std::fs::write(ledger.path(), &bad).unwrap();
    assert_eq!(append(&mut ledger).unwrap_err().kind, Kind::Integrity);
    assert_eq!(std::fs::read(ledger.path()).unwrap(), bad, "left as it was");
    // The first record deleted, and the order turned round.
    for text in [format!("{}\n", lines[1]), format!("{}\n{}\n", lines[1], lines[0])] {
        std::fs::write(ledger.path(), text).unwrap();
        assert_eq!(ledger.read_chain().unwrap_err().kind, Kind::Integrity);
    }
}

/// A kill at every step of an append, then a run that goes on: no record is lost that was acknowledged, none
/// stands there in half, and the head is right again.
#[test]
fn a_kill_at_every_step() {
    use crate::audit::disk::fault::Plan;
    for crash_at in 0.. {
        let dir = tempfile::tempdir().unwrap();
        let data = DataFolder::at(dir.path());
        let mut ledger = Ledger::open(&data).unwrap();
        append(&mut ledger).unwrap();
        append(&mut ledger).unwrap();
        let plan = Plan::new(crash_at, true, std::io::ErrorKind::Other);
        let mut failing = ledger.clone().with_disk(Disk { fault: Some(plan.clone()) });
        let acknowledged = append(&mut failing).is_ok();
        append(&mut ledger).unwrap();
        let records = ledger.read_chain().unwrap();
        let last = records.last().unwrap().predicate.chain.seq;
        assert_eq!(last + 1, records.len() as u64);
        assert!(records.len() >= 3 + usize::from(acknowledged), "crash at {crash_at}");
        let checkpoint = ledger.checkpoint().unwrap().unwrap();
        assert_eq!(checkpoint.size, records.len() as u64);
        let mut tree = Frontier::default();
        for record in &records {
            tree.push(checkpoint::record_leaf(record.predicate.trail_hash.as_ref().unwrap()).unwrap());
        }
        assert_eq!(checkpoint.root, hex::encode(tree.root()));
        if !plan.was_hit() {
            assert!(crash_at > 4, "the append has several steps");
            break;
        }
    }
}

#[test]
fn an_append_reads_the_head_and_not_the_file() {
    let dir = tempfile::tempdir().unwrap();
    let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
    for _ in 0..4 {
        append(&mut ledger).unwrap();
    }
    // Whatever the first lines hold, only verification looks at them again.
    let mut bytes = std::fs::read(ledger.path()).unwrap();
    bytes[..100].fill(b'x');
    std::fs::write(ledger.path(), &bytes).unwrap();
    assert_eq!(append(&mut ledger).unwrap().statement.predicate.chain.seq, 4);
    // Without its head the whole file is read, and is found to be changed.
    std::fs::remove_file(ledger.path().with_file_name("head.json")).unwrap();
    assert_eq!(append(&mut ledger).unwrap_err().kind, Kind::Integrity);
}

#[test]
fn a_cut_or_exchanged_end_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let mut ledger = Ledger::open(&DataFolder::at(dir.path())).unwrap();
    for _ in 0..3 {
        append(&mut ledger).unwrap();
    }
    let good = std::fs::read(ledger.path()).unwrap();
    let first = good.iter().position(|b| *b == b'\n').unwrap() + 1;
    std::fs::write(ledger.path(), &good[..first]).unwrap();
    let error = append(&mut ledger).unwrap_err();
    assert!(error.kind == Kind::Integrity && error.found.contains("TRUNCATED"), "{error}");
    assert_eq!(std::fs::read(ledger.path()).unwrap(), good[..first], "left as it was");
    std::fs::write(ledger.path(), &good).unwrap();
    append(&mut ledger).unwrap();
    let head = ledger.path().with_file_name("head.json");
    let text = std::fs::read_to_string(&head).unwrap();
    std::fs::write(&head, text.replacen("\"peaks\":[\"", "\"peaks\":[\"0", 1)).unwrap();
    assert_eq!(append(&mut ledger).unwrap_err().kind, Kind::Integrity);
}
