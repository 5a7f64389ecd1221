//! A shard: one `orb geo --manifest` over its rows, into a store of its own.

use std::fs::File;
use std::io::Read as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use super::plan::{Failed, Outcome, Plan};
use crate::audit::disk::{self, Disk};
use crate::audit::file_lock::FileLock;
use crate::audit::report::Verdict;
use crate::audit::{DataFolder, TrustStore, time, verify};
use crate::cli::geo::manifest::{self, Line};
use crate::{Error, Kind, Result};

const LOOK: Duration = Duration::from_millis(50);
/// Bytes of a log that are looked through for what went wrong.
const LOG: u64 = 16 << 20;

/// Runs a shard and keeps how it ended.
///
/// # Errors
/// Usage for a number that is none; environment; an interrupt. Rows that fail are in the outcome.
pub fn run(plan: &Plan, number: usize, stop: &AtomicBool) -> Result<Outcome> {
    let shard = plan.shards.get(number).ok_or_else(|| {
        Error::usage("--run-shard").expected(format!("a number below {}", plan.shards.len())).found(number.to_string())
    })?;
    let folder = plan.shard(number);
    let disk = Disk::default();
    disk.create_dir_all(&folder)?;
    // Two of them, of two job arrays, would wait for each other's store and both fail.
    let lock =
        File::options().create(true).append(true).open(folder.join("lock")).map_err(|e| Error::io(&folder, &e))?;
    let _only = FileLock::try_take(lock).map_err(|e| {
        Error::environment(folder.display().to_string()).expected("one run of a shard at a time").found(e.to_string())
    })?;
    let (_, all) = manifest::read(&plan.manifest)?;
    let of_shard: Vec<&Line> = all.iter().filter(|l| shard.lines.contains(&l.number)).collect();
    let (sound, mut outcome) = look_over(plan, &of_shard)?;
    let name = plan.manifest.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let base = plan.manifest.parent().unwrap_or(Path::new(""));
    let rows = plan.put_bytes(&format!("{number:04}/{name}"), manifest::write(&sound, base).as_bytes())?;
    let (result, words) = start(plan, number, &rows, stop)?;
    let failed_lines: Vec<usize> = result["failed"]
        .as_array()
        .map(|all| all.iter().filter_map(|n| n.as_str()?.parse().ok()).collect())
        .unwrap_or_else(|| sound.iter().map(|l| l.number).collect());
    let count = |name: &str| result[name].as_u64().and_then(|n| usize::try_from(n).ok()).unwrap_or(0);
    outcome.published = count("published");
    outcome.already = count("already");
    outcome.failed.extend(failed_lines.into_iter().map(|line| Failed { line, words: said_of(&words, line) }));
    outcome.failed.sort_by_key(|f| f.line);
    plan.put(&format!("{number:04}/outcome.json"), &outcome)?;
    Ok(outcome)
}

/// Rows to run. What an earlier run published is held against its record first: a file that is not what the record says is
/// nobody's to mend here.
fn look_over<'a>(plan: &Plan, lines: &[&'a Line]) -> Result<(Vec<&'a Line>, Outcome)> {
    let data = DataFolder::at(&plan.data);
    let trust = TrustStore::load(&data, &[])?;
    let now = time::now()?.unix_ms;
    let (mut sound, mut outcome) = (Vec::new(), Outcome::default());
    for line in lines {
        let folder = line.name().map(|name| plan.output.join(name)).filter(|f| f.is_dir());
        let wrong = match &folder {
            None => None,
            Some(folder) => {
                let report = verify::verify(&verify::Request::new(folder, &trust, now))?;
                // Files of the store are changed by later rows: they are not this folder's.
                report
                    .findings
                    .into_iter()
                    .find(|f| f.verdict == Verdict::Fail && !f.subject.starts_with("store:"))
                    .map(|f| {
                        format!(
                            "{}: {} {}: remove the folder to run the row again",
                            folder.display(),
                            f.code,
                            f.subject
                        )
                    })
            }
        };
        match wrong {
            None => sound.push(*line),
            Some(words) => outcome.failed.push(Failed { line: line.number, words }),
        }
    }
    Ok((sound, outcome))
}

/// The object that the run printed, and its log.
fn start(plan: &Plan, number: usize, rows: &Path, stop: &AtomicBool) -> Result<(serde_json::Value, String)> {
    let folder = plan.shard(number);
    let log_path = folder.join("log.txt");
    let log = File::create(&log_path).map_err(|e| Error::io(&log_path, &e))?;
    let program = std::env::current_exe().map_err(|e| Error::environment("this program").found(e.to_string()))?;
    let mut command = Command::new(&program);
    command.arg("geo").arg("--manifest").arg(rows).args(&plan.options);
    command.arg("--output").arg(&plan.output).arg(format!("--iterations={}", plan.iterations));
    command.arg(format!("--as-of={}", plan.as_of)).args(["--json", "--quiet", "--stop-with-stdin"]);
    if plan.store {
        command.arg("--cdb").arg(folder.join("store.cdb"));
    }
    command
        .env("ORB_DATA_DIR", &plan.data)
        .env("RAYON_NUM_THREADS", plan.threads.to_string())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(log);
    let mut child = command.spawn().map_err(|e| Error::io(&program, &e))?;
    // It ends with this process, and when it is told to.
    let mut input = child.stdin.take();
    let stdout = child.stdout.take();
    let reader = std::thread::spawn(move || {
        let mut text = String::new();
        if let Some(mut stdout) = stdout {
            let _ = stdout.read_to_string(&mut text);
        }
        text
    });
    while child.try_wait().map_err(|e| Error::io(&program, &e))?.is_none() {
        if stop.load(Ordering::Relaxed) {
            drop(input.take());
        }
        std::thread::sleep(LOOK);
    }
    let text = reader.join().unwrap_or_default();
    if stop.load(Ordering::Relaxed) {
        return Err(Error::new(Kind::Cancelled, "stopped")
            .found("an interrupt")
            .advice("What is published stays. Run the same command again to go on."));
    }
    let words =
        disk::read_limited(&log_path, LOG).map(|b| String::from_utf8_lossy(&b).into_owned()).unwrap_or_default();
    Ok((serde_json::from_str(&text).unwrap_or_default(), words))
}

/// What the log has of a line: `orb: FILE:LINE: NAME: WORDS`; else its last words.
fn said_of(log: &str, line: usize) -> String {
    let mark = format!(":{line}: ");
    let own =
        log.lines().rev().find_map(|l| l.strip_prefix("orb: ")?.split_once(&mark).map(|(_, words)| words.to_owned()));
    own.or_else(|| log.lines().next_back().map(str::to_owned)).unwrap_or_else(|| "it ended without a word".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_log_says_what_went_wrong() {
        let log = "orb: a/m.csv:3: van: photo: expected a file\nCheck it.\norb: a/m.csv:13: car: heading: expected a number\n";
        assert_eq!(said_of(log, 3), "van: photo: expected a file");
        assert_eq!(said_of(log, 13), "car: heading: expected a number");
        assert_eq!(said_of("killed\n", 3), "killed");
        assert_eq!(said_of("", 3), "it ended without a word");
    }
}
