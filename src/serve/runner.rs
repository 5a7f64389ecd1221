//! Runs jobs: one at a time, each as a process of its own in the job's folder.
//!
//! Whoever is killed, nothing is lost and nothing is half there. A run publishes whole or not at all; a job counts as running
//! in the database before its process begins and as ended after it; a server that starts puts back what was running, or takes
//! over what it had published. A process whose server is gone sees its standard input end, and stops.

use std::ffi::OsString;
use std::io::{BufRead as _, BufReader, Read};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use super::database::{Ended, Job, Stands, State};
use super::live::Progress;
use super::place::{self, run_name};
use super::{Server, lock};
use crate::audit::statement::{Param, Statement};
use crate::audit::verify;
use crate::{Error, Result};

/// How often a process is looked at.
const LOOK: Duration = Duration::from_millis(50);
/// How often the database is asked whether another server was told to cancel its job.
const ASK: Duration = Duration::from_secs(2);
/// For a process that was asked to stop.
const GRACE: Duration = Duration::from_secs(10);
/// Lines of a process' standard error that are kept, and bytes of its result.
const LINES: usize = 20;
const RESULT: u64 = 4 << 20;
/// Longest line that is read whole.
const LINE: u64 = 64 << 10;

/// How jobs are run.
pub struct Runner {
    /// This program.
    pub program: PathBuf,
    /// What every run is told: key, device.
    pub options: Vec<OsString>,
    /// Variables of this process' environment that no run is told.
    pub secrets: Vec<String>,
}

/// What a process came to.
struct Finished {
    status: Option<ExitStatus>,
    lines: Vec<String>,
    result: Option<serde_json::Value>,
    /// Why it was ended before its end.
    broken_off: Option<BrokenOff>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BrokenOff {
    Cancelled,
    /// The server ends.
    Stopped,
    TooLong,
}

/// Puts back what was running when the server ended, takes over what was published, sweeps what is nobody's.
///
/// # Errors
/// Environment.
pub fn recover(server: &Server) -> Result<()> {
    settle_lost(server)?;
    server.place.sweep(|id| server.database.job(id).map_or(true, |job| job.is_some()))
}

/// Jobs of this server's that count as running while none runs.
fn settle_lost(server: &Server) -> Result<()> {
    for job in server.database.running()? {
        let now = server.now();
        if let Some(ended) = published(server, &job)? {
            server.database.end(&job.id, &ended, now)?;
            continue;
        }
        server.place.remove_run(&job.id, job.attempt)?;
        settle_unfinished(server, &job, "the run was killed", false)?;
    }
    Ok(())
}

/// A run that left nothing: cancelled, put back, or given up.
fn settle_unfinished(server: &Server, job: &Job, why: &str, uncounted: bool) -> Result<()> {
    let cancelled = server.database.job(&job.id)?.is_some_and(|j| j.cancel);
    let bytes = place::size(&server.place.job(&job.id));
    let end = |state, error| {
        let ended = Ended { state, exit_code: None, error, result: None, marking: None, bytes };
        server.database.end(&job.id, &ended, server.now())
    };
    match () {
        () if cancelled => end(State::Cancelled, None),
        () if !uncounted && job.attempt >= server.limits.attempts => {
            end(State::Failed, Some(format!("{why}, {} times", job.attempt)))
        }
        () => server.database.put_back(&job.id, uncounted),
    }
}

/// What a run published, as the job's end; where it stands is noted before. The record is read, not verified: that is
/// asked for.
fn published(server: &Server, job: &Job) -> Result<Option<Ended>> {
    let folder = server.place.published(&job.id, job.attempt);
    let Ok((_, statement)) = verify::read_record(&folder) else { return Ok(None) };
    let marking = statement.marking().map(|m| m.banner());
    let bytes = place::size(&server.place.job(&job.id));
    if let Some(stands) = stands(&statement) {
        server.database.set_place(&job.id, stands)?;
    }
    Ok(Some(Ended { state: State::Done, exit_code: Some(0), error: None, result: None, marking, bytes }))
}

fn stands(statement: &Statement) -> Option<Stands> {
    let number = |name: &str| match statement.predicate.params.get(name)? {
        Param::Text(text) => text.parse().ok().filter(|v: &f64| v.is_finite()),
        _ => None,
    };
    Some(Stands { latitude: number("latitude")?, longitude: number("longitude")?, heading: number("heading_deg")? })
}

impl Runner {
    /// Runs jobs until `stop` is set; then the one that runs is put back.
    pub fn work(&self, server: &Arc<Server>, stop: &AtomicBool) {
        // After an error a job may be noted as running that is not: one that was taken while the answer was lost.
        let mut unsure = false;
        while !stop.load(Ordering::Relaxed) {
            let settled = if unsure { settle_lost(server) } else { Ok(()) };
            match settled.and_then(|()| self.next(server, stop)) {
                Ok(ran) => {
                    unsure = false;
                    if !ran {
                        server.live.wait_for_work(Duration::from_millis(500));
                    }
                }
                Err(e) => {
                    eprintln!("orb: {e}");
                    unsure = true;
                    // A full disk or a database that does not answer, most likely. Jobs wait for it.
                    server.live.wait_for_work(Duration::from_secs(5));
                }
            }
        }
    }

    /// Runs the job that has waited longest; false where none waits.
    ///
    /// # Errors
    /// Environment: the job is put back, or found running at the next start.
    pub fn next(&self, server: &Arc<Server>, stop: &AtomicBool) -> Result<bool> {
        let Some(job) = server.database.take(server.now())? else { return Ok(false) };
        server.live.begin(&job.id);
        let outcome = self.run(server, &job, stop).and_then(|finished| keep(server, &job, &finished, stop));
        if let Err(e) = &outcome {
            eprintln!("orb: job {}: {e}", job.id);
            let _ = settle_unfinished(server, &job, "the run could not be started or kept", false);
        }
        server.live.end();
        outcome.map(|()| true)
    }

    fn run(&self, server: &Arc<Server>, job: &Job, stop: &AtomicBool) -> Result<Finished> {
        server.place.begin_run(&job.id, job.attempt)?;
        let account = server.database.account(&job.account)?;
        let mut child = self.start(server, job, &account.map(|a| a.roles.text()).unwrap_or_default())?;
        let (lines, errors) = read_errors(&mut child, server, &job.id);
        let result = read_result(&mut child);
        // Ends with this process, however that ends.
        let input = child.stdin.take();
        let (status, broken_off) = wait(&mut child, input, server, &job.id, stop);
        let result = result.and_then(|r| r.join().ok().flatten());
        let _ = errors.map(JoinHandle::join);
        let lines = std::mem::take(&mut *lock(&lines));
        Ok(Finished { status, lines, result, broken_off })
    }

    fn start(&self, server: &Server, job: &Job, roles: &str) -> Result<Child> {
        let mut command = Command::new(&self.program);
        command
            .arg("geo")
            .arg(job.request.input())
            .args(job.request.options())
            .arg(format!("--output={}/out", run_name(job.attempt)))
            .args(["--json", "--progress=json", "--stop-with-stdin"])
            .args(&self.options)
            .current_dir(server.place.job(&job.id))
            .env("ORB_DATA_DIR", server.recorder.data().path())
            .env("ORB_OPERATOR_NAME", &job.account)
            .env("ORB_OPERATOR_ROLE", roles)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        for name in &self.secrets {
            command.env_remove(name);
        }
        #[cfg(unix)]
        {
            use std::os::unix::process::CommandExt as _;
            // Ctrl-C in the server's terminal ends the server, which ends its runs.
            command.process_group(0);
        }
        command.spawn().map_err(|e| Error::io(&self.program, &e))
    }
}

/// Until the process ends, or has to.
fn wait(
    child: &mut Child,
    mut input: Option<std::process::ChildStdin>,
    server: &Server,
    id: &str,
    stop: &AtomicBool,
) -> (Option<ExitStatus>, Option<BrokenOff>) {
    let begun = Instant::now();
    let mut asked = begun;
    let mut broken_off: Option<(BrokenOff, Instant)> = None;
    loop {
        match child.try_wait() {
            Ok(None) => {}
            Ok(Some(status)) => return (Some(status), broken_off.map(|b| b.0)),
            Err(_) => return (None, broken_off.map(|b| b.0)),
        }
        match broken_off {
            Some((_, since)) if since.elapsed() > GRACE => drop(child.kill()),
            Some(_) => {}
            None => {
                if asked.elapsed() >= ASK {
                    asked = Instant::now();
                    // A database that does not answer is asked again.
                    if server.database.is_cancelled(id).unwrap_or(false) {
                        server.live.cancel(id);
                    }
                }
                let why = if server.live.is_cancelled() {
                    Some(BrokenOff::Cancelled)
                } else if stop.load(Ordering::Relaxed) {
                    Some(BrokenOff::Stopped)
                } else {
                    (begun.elapsed().as_secs() >= server.limits.seconds).then_some(BrokenOff::TooLong)
                };
                if let Some(why) = why {
                    broken_off = Some((why, Instant::now()));
                    input = None;
                }
            }
        }
        let _ = &input;
        std::thread::sleep(LOOK);
    }
}

/// Progress goes to whoever watches; of the rest the last lines are kept.
fn read_errors(child: &mut Child, server: &Arc<Server>, id: &str) -> (Arc<Mutex<Vec<String>>>, Option<JoinHandle<()>>) {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let reader = child.stderr.take().map(|stderr| {
        let (lines, server, id) = (Arc::clone(&lines), Arc::clone(server), id.to_owned());
        std::thread::spawn(move || {
            let mut stderr = BufReader::new(stderr);
            let mut stage = String::new();
            loop {
                let mut line = Vec::new();
                match stderr.by_ref().take(LINE).read_until(b'\n', &mut line) {
                    Ok(1..) => {}
                    Ok(0) | Err(_) => break,
                }
                let line = String::from_utf8_lossy(&line).trim_end().to_owned();
                match progress(&line) {
                    Some(progress) => {
                        if progress.stage != stage {
                            stage.clone_from(&progress.stage);
                            // Only told from the disk until the next one: not worth an end.
                            let _ = server.database.set_stage(&id, &stage);
                        }
                        server.live.progress(progress);
                    }
                    None => {
                        let mut kept = lock(&lines);
                        if kept.len() == LINES {
                            kept.remove(0);
                        }
                        kept.push(line);
                    }
                }
            }
        })
    });
    (lines, reader)
}

fn progress(line: &str) -> Option<Progress> {
    #[derive(serde::Deserialize)]
    struct Line {
        progress: Progress,
    }
    line.starts_with("{\"progress\"").then(|| serde_json::from_str::<Line>(line).ok()).flatten().map(|l| l.progress)
}

fn read_result(child: &mut Child) -> Option<JoinHandle<Option<serde_json::Value>>> {
    let stdout = child.stdout.take()?;
    Some(std::thread::spawn(move || {
        let mut text = Vec::new();
        let mut stdout = stdout;
        let read = stdout.by_ref().take(RESULT).read_to_end(&mut text);
        // What does not fit is read nevertheless, so that nobody waits for it to be.
        let _ = std::io::copy(&mut stdout, &mut std::io::sink());
        read.ok()?;
        serde_json::from_slice(&text).ok()
    }))
}

/// How a run ended stands in the database, once that answers again.
fn keep(server: &Server, job: &Job, finished: &Finished, stop: &AtomicBool) -> Result<()> {
    loop {
        match settle(server, job, finished) {
            Err(e) if !stop.load(Ordering::Relaxed) && !server.database.answers() => {
                eprintln!("orb: job {}: {e}", job.id);
                std::thread::sleep(Duration::from_secs(1));
            }
            kept => return kept,
        }
    }
}

fn settle(server: &Server, job: &Job, finished: &Finished) -> Result<()> {
    let Finished { status, lines, result, broken_off } = finished;
    // However it ended: what stands there was recorded and published.
    if let Some(mut ended) = published(server, job)? {
        // Where on this machine is nobody's business.
        let mut result = result.clone();
        if let Some(object) = result.as_mut().and_then(|r| r.as_object_mut()) {
            object.remove("folder");
        }
        ended.result = result;
        return server.database.end(&job.id, &ended, server.now());
    }
    server.place.remove_run(&job.id, job.attempt)?;
    let code = status.and_then(|s| s.code());
    let words = || {
        let folder = server.place.job(&job.id).display().to_string();
        let said: Vec<&str> = lines.iter().map(|l| l.strip_prefix("orb: ").unwrap_or(l)).collect();
        said.join("\n").replace(&folder, "")
    };
    let bytes = place::size(&server.place.job(&job.id));
    let end = |state, error: Option<String>| {
        let ended = Ended { state, exit_code: code, error, result: None, marking: None, bytes };
        server.database.end(&job.id, &ended, server.now())
    };
    match (broken_off, code) {
        (Some(BrokenOff::Cancelled), _) => end(State::Cancelled, None),
        (Some(BrokenOff::Stopped), _) => settle_unfinished(server, job, "the server was ended", true),
        (Some(BrokenOff::TooLong), _) => {
            end(State::Failed, Some(format!("it ran for more than {} seconds", server.limits.seconds)))
        }
        (None, Some(4)) => end(State::Refused, Some(words())),
        (None, Some(_)) => end(State::Failed, Some(words())),
        // By a signal: memory, most likely.
        (None, None) => settle_unfinished(server, job, "the run was killed", false),
    }
}
