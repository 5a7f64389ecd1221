//! Who runs shards: threads that start processes here, or a Slurm job array.

use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use super::plan::Plan;
use super::{BatchArgs, task};
use crate::{Error, Kind, Result};

const LOOK: Duration = Duration::from_millis(200);

/// Runs shards on this machine, so many at once.
///
/// # Errors
/// An interrupt; environment. Where one shard cannot be run at all, the others are.
pub fn local(plan: &Plan, numbers: &[usize], jobs: u32, stop: &AtomicBool) -> Result<()> {
    let next = AtomicUsize::new(0);
    let first_error = Mutex::new(None);
    std::thread::scope(|threads| {
        for _ in 0..numbers.len().min(jobs as usize) {
            threads.spawn(|| {
                while let Some(number) = numbers.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if stop.load(Ordering::Relaxed) {
                        break;
                    }
                    if let Err(e) = task::run(plan, *number, stop) {
                        first_error.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(e);
                    }
                }
            });
        }
    });
    if stop.load(Ordering::Relaxed) {
        return Err(interrupted());
    }
    match first_error.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some(e) => Err(e),
        None => Ok(()),
    }
}

fn interrupted() -> Error {
    Error::new(Kind::Cancelled, "stopped")
        .found("an interrupt")
        .advice("What is published stays. Run the same command again to go on.")
}

/// Submits a job array of the shards and waits for its end.
///
/// # Errors
/// Environment without sbatch, or where it refuses; an interrupt, which cancels the array.
pub fn slurm(plan: &Plan, numbers: &[usize], args: &BatchArgs, stop: &AtomicBool) -> Result<()> {
    let program = std::env::current_exe().map_err(|e| Error::environment("this program").found(e.to_string()))?;
    let script = plan.put_bytes("array.sh", script(plan, numbers, &program, args).as_bytes())?;
    let cannot = |found: String| {
        Error::environment("sbatch")
            .expected("Slurm's own program, on the path, and a cluster that takes the job")
            .found(found)
            .advice("On one machine --engine local does the same.")
    };
    let mut child = Command::new("sbatch")
        .args(["--parsable", "--wait"])
        .args(&args.sbatch)
        .arg(&script)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| cannot(e.to_string()))?;
    let mut id = String::new();
    if let Some(stdout) = child.stdout.take() {
        let _ = BufReader::new(stdout).read_line(&mut id);
    }
    // `ID` or `ID;CLUSTER`.
    let id = id.trim().split(';').next().unwrap_or_default().to_owned();
    if id.is_empty() {
        let said = child.wait_with_output().map_err(|e| cannot(e.to_string()))?;
        return Err(cannot(String::from_utf8_lossy(&said.stderr).trim().to_owned()));
    }
    eprintln!("orb: job array {id}, {} shards", numbers.len());
    // Its exit code is the highest of the tasks': what each came to stands in its outcome.
    while child.try_wait().map_err(|e| cannot(e.to_string()))?.is_none() {
        if stop.load(Ordering::Relaxed) {
            let _ = Command::new("scancel").arg(&id).status();
            let _ = child.wait();
            return Err(interrupted());
        }
        std::thread::sleep(LOOK);
    }
    Ok(())
}

/// The job array: each task runs the shard of its number.
fn script(plan: &Plan, numbers: &[usize], program: &Path, args: &BatchArgs) -> String {
    let array: Vec<String> = numbers.iter().map(usize::to_string).collect();
    let log = plan.work().join("slurm-%a.txt");
    format!(
        "#!/bin/sh\n#SBATCH --job-name=orb-batch\n#SBATCH --array={}%{}\n#SBATCH --cpus-per-task={}\n#SBATCH --output={}\n\
         exec {} batch --run-shard \"$SLURM_ARRAY_TASK_ID\" --output {}\n",
        array.join(","),
        args.jobs,
        plan.threads,
        // sbatch reads the line as a shell would.
        quoted(&log),
        quoted(program),
        quoted(&plan.output),
    )
}

/// One word of a shell's.
fn quoted(path: &Path) -> String {
    format!("'{}'", path.display().to_string().replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_one_word() {
        assert_eq!(quoted(Path::new("/a b/it's;$x")), r"'/a b/it'\''s;$x'");
        let said =
            Command::new("sh").arg("-c").arg(format!("printf %s {}", quoted(Path::new("/a b/it's;$x\\")))).output();
        if let Ok(said) = said {
            assert_eq!(String::from_utf8_lossy(&said.stdout), "/a b/it's;$x\\");
        }
    }
}
