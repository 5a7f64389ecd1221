//! `orb doctor`: what this machine has and lacks, a line each with what to do about it. Changes nothing.

use std::fmt::Write as _;
use std::path::Path;

use clap::Args;
use serde::Serialize;

use super::audit::Outcome;
use super::device::kernels_in;
use super::networks::{EngineArgs, registry};
use crate::audit::keys::{KeySource, SigningKey};
use crate::audit::time::{SyncStatus, now};
use crate::audit::{DataFolder, TrustStore};
use crate::geo::proj_version;
use crate::models::engine::{Engine as _, Rten, discovery};
use crate::models::registry::catalogue::Catalogue;
use crate::models::registry::{Registry, Stage};
use crate::splat::render::gpu::{Gpu, adapters};
use crate::{Error, Kind, Result};

/// Below this a run may not find room for what it publishes.
const LITTLE_DISK: u64 = 2 << 30;

#[derive(Args, Clone, Debug)]
pub struct DoctorArgs {
    /// One JSON object on standard output
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub engine: EngineArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum State {
    Good,
    /// Something could be better; every run works without it.
    Note,
    /// A run that needs it fails.
    Problem,
}

/// A line.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    pub topic: &'static str,
    pub state: State,
    pub found: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    pub advice: String,
}

/// # Errors
/// None but a broken serialiser; what is wrong with the machine stands in the lines, and exit code 5 says that something is.
pub fn run(args: &DoctorArgs, data: &DataFolder) -> Result<Outcome> {
    let mut findings = vec![version()];
    findings.extend(gpu(data));
    findings.extend(engines(&args.engine, data));
    findings.extend(networks(&registry(data)));
    findings.push(proj());
    findings.extend([disk("data folder", data.path()), disk("current folder", Path::new("."))]);
    findings.extend([clock(), key(data), trust(data)]);
    let exit_code = match findings.iter().any(|f| f.state == State::Problem) {
        true => Kind::Environment.exit_code(),
        false => 0,
    };
    let text = if args.json {
        let object = serde_json::json!({ "findings": findings });
        serde_json::to_string(&object).map_err(|e| Error::environment("--json").found(e.to_string()))? + "\n"
    } else {
        lines(&findings)
    };
    Ok(Outcome { text, exit_code })
}

fn lines(findings: &[Finding]) -> String {
    let mut out = String::new();
    for f in findings {
        let state = match f.state {
            State::Good => "ok",
            State::Note => "note",
            State::Problem => "PROBLEM",
        };
        let advice = if f.advice.is_empty() { String::new() } else { format!(": {}", f.advice) };
        let _ = writeln!(out, "{state:<8} {:<16} {}{advice}", f.topic, f.found);
    }
    out
}

fn finding(topic: &'static str, state: State, found: impl Into<String>, advice: impl Into<String>) -> Finding {
    Finding { topic, state, found: found.into(), advice: advice.into() }
}

fn version() -> Finding {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let (os, arch, version) = (std::env::consts::OS, std::env::consts::ARCH, env!("CARGO_PKG_VERSION"));
    finding(
        "orb",
        State::Good,
        format!("{version}, commit {}, on {arch}-{os}, {threads} threads", env!("ORB_BUILD_COMMIT")),
        "",
    )
}

fn gpu(data: &DataFolder) -> Vec<Finding> {
    match Gpu::open(false, Some(&kernels_in(data))) {
        Ok(gpu) => {
            let (a, b) = (&gpu.adapter, &gpu.abilities);
            let words = format!(
                "{} ({}, {}), bindings to {} MiB, buffers to {} MiB, subgroups of {}, workgroup memory {} KiB",
                a.name,
                a.backend,
                a.driver,
                a.largest_binding >> 20,
                a.largest_buffer >> 20,
                b.lanes,
                a.workgroup_memory >> 10
            );
            let mut all = vec![finding("gpu", State::Good, words, "")];
            all.extend(gpu.notes.iter().map(|n| finding("gpu", State::Note, n.clone(), "")));
            all
        }
        Err(e) => {
            let others: Vec<String> = adapters().into_iter().map(|a| a.name).collect();
            let found = match others.is_empty() {
                true => "none; the CPU does everything".to_owned(),
                false => format!("none that is used ({}): {}", others.join(", "), e.found),
            };
            vec![finding(
                "gpu",
                State::Note,
                found,
                "a Vulkan, Metal or DirectX 12 driver lets `orb render` draw on a GPU",
            )]
        }
    }
}

fn engines(args: &EngineArgs, data: &DataFolder) -> Vec<Finding> {
    let mut all = vec![finding("engine", State::Good, format!("{} (built in, CPU)", Rten.name()), "")];
    let candidates = discovery::look(&args.search(data));
    for c in &candidates {
        let state = match (c.is_good(), c.asked_for) {
            (true, _) => State::Good,
            (false, true) => State::Problem,
            (false, false) => State::Note,
        };
        let advice = if c.asked_for && !c.is_good() { "name another, or none" } else { "" };
        all.push(finding("onnx runtime", state, format!("{} ({}): {}", c.path.display(), c.origin, c.state), advice));
    }
    match candidates.iter().find(|c| c.is_good()) {
        Some(best) => all.extend(providers(best)),
        None => all.push(finding(
            "onnx runtime",
            State::Note,
            "none is found",
            "imported networks run faster with one; --onnxruntime, ORT_DYLIB_PATH, or the data folder's `runtime`",
        )),
    }
    all
}

#[cfg(feature = "ort")]
fn providers(best: &discovery::Candidate) -> Vec<Finding> {
    use crate::models::engine::{Ort, Provider};
    let tried = Ort::open(best, Provider::Cpu, None, &mut |_| {}).map(|ort| ort.providers());
    match tried {
        Err(e) => vec![finding("provider", State::Problem, e.found, "another ONNX Runtime may load")],
        Ok(all) => all
            .into_iter()
            .map(|(name, failed)| match failed {
                None => finding("provider", State::Good, name, ""),
                Some(why) => finding("provider", State::Note, format!("{name} does not work: {why}"), ""),
            })
            .collect(),
    }
}

#[cfg(not(feature = "ort"))]
fn providers(_: &discovery::Candidate) -> Vec<Finding> {
    vec![finding("provider", State::Note, "this program was built without the feature `ort`", "")]
}

/// What is here; for a stage without any, what one would improve and where it comes from.
fn networks(registry: &Registry) -> Vec<Finding> {
    let here = match registry.list() {
        Ok(here) => here,
        Err(e) => return vec![finding("networks", State::Problem, e.found, e.advice)],
    };
    let known = match Catalogue::load(registry.root()) {
        Ok(catalogue) => catalogue.entries,
        Err(e) => return vec![finding("networks", State::Problem, e.found, "mend or remove catalogue.json")],
    };
    let mut all: Vec<Finding> = here
        .iter()
        .map(|m| {
            let pin = if m.pinned { "pinned" } else { "unverified" };
            let words = format!("{} {} for the {}, {}, {pin}", m.id, m.version, m.family.stage().name(), m.licence);
            finding("network", State::Good, words, "")
        })
        .collect();
    for (stage, better) in [
        (Stage::Mask, "masks of subjects that the built-in network never saw, and clicks on them"),
        (Stage::Depth, "a truer front surface"),
        (Stage::Views, "sides that the photo does not show, drawn by a large model (a GPU stage)"),
    ] {
        if here.iter().all(|m| m.family.stage() != stage) {
            let names: Vec<&str> =
                known.iter().filter(|e| e.families.iter().any(|f| f.stage() == stage)).map(|e| e.id.as_str()).collect();
            let advice = format!("would bring {better}; `orb models import` takes {}", names.join(", "));
            all.push(finding("network", State::Note, format!("none imported for the {}", stage.name()), advice));
        }
    }
    all
}

fn proj() -> Finding {
    match proj_version() {
        Some([major, minor, patch]) => {
            finding("proj", State::Good, format!("PROJ {major}.{minor}.{patch}: every EPSG code is read"), "")
        }
        None => finding(
            "proj",
            State::Note,
            "none is found: EPSG codes of WGS84 alone are read",
            "its library lets --origin take every EPSG code (Debian: libproj25 and proj-data)",
        ),
    }
}

fn disk(topic: &'static str, path: &Path) -> Finding {
    // The folder may not be made yet: the nearest above it.
    let there = std::path::absolute(path).ok().and_then(|p| p.ancestors().find(|a| a.exists()).map(Path::to_owned));
    match there.as_deref().and_then(free_space) {
        None => finding(topic, State::Note, format!("{}: free space unknown", path.display()), ""),
        Some(free) if free < LITTLE_DISK => {
            finding(topic, State::Note, format!("{}: {} MiB free", path.display(), free >> 20), "make room")
        }
        Some(free) => finding(topic, State::Good, format!("{}: {} GiB free", path.display(), free >> 30), ""),
    }
}

#[cfg(unix)]
fn free_space(path: &Path) -> Option<u64> {
    use std::os::unix::ffi::OsStrExt as _;
    let name = std::ffi::CString::new(path.as_os_str().as_bytes()).ok()?;
    let mut space = std::mem::MaybeUninit::<libc::statvfs>::zeroed();
    // SAFETY: `name` ends in a zero byte and lives through the call; `space` has room for the result, and is read only when
    // the call says that it was written.
    let space = unsafe {
        if libc::statvfs(name.as_ptr(), space.as_mut_ptr()) != 0 {
            return None;
        }
        space.assume_init()
    };
    #[allow(clippy::unnecessary_cast)] // The fields' types differ between systems.
    Some(space.f_bavail as u64 * space.f_frsize as u64)
}

#[cfg(not(unix))]
fn free_space(_: &Path) -> Option<u64> {
    None
}

fn clock() -> Finding {
    match now() {
        Ok(reading) if reading.sync_status == SyncStatus::Synchronised => {
            finding("clock", State::Good, reading.describe(), "")
        }
        Ok(reading) => finding("clock", State::Note, reading.describe(), "records carry this; a time daemon mends it"),
        Err(e) => finding("clock", State::Problem, e.found, "set the clock"),
    }
}

fn key(data: &DataFolder) -> Finding {
    let path = data.path().join("keys").join("orb-signing.pem");
    if !path.exists() {
        return finding("signing key", State::Note, "none yet", "the first run makes one in the data folder");
    }
    match SigningKey::load(&path, KeySource::UserData) {
        Ok(key) => {
            let public = key.public();
            finding("signing key", State::Good, format!("{}, {}", public.kind(), public.fingerprint()), "")
        }
        Err(e) => finding("signing key", State::Problem, e.to_string(), ""),
    }
}

fn trust(data: &DataFolder) -> Finding {
    match TrustStore::load(data, &[]) {
        Ok(store) if store.is_empty() => {
            finding("trusted keys", State::Note, "none", "the first run trusts its own key")
        }
        Ok(_) => finding("trusted keys", State::Good, format!("in {}", data.path().join("trust").display()), ""),
        Err(e) => finding("trusted keys", State::Problem, e.to_string(), ""),
    }
}
