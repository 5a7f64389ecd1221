//! Where a user's ONNX Runtime may be, and whether what is there can be used.

use std::ffi::OsString;
use std::fmt;
use std::path::{Path, PathBuf};

/// The oldest minor version of ONNX Runtime 1 that has all the calls used here.
pub const LEAST_MINOR: u32 = 24;

/// Where to look: values, so that tests need no environment.
#[derive(Clone, Debug, Default)]
pub struct Search {
    /// `--onnxruntime`: a library or a folder with one.
    pub given: Option<PathBuf>,
    /// `ORT_DYLIB_PATH`.
    pub variable: Option<PathBuf>,
    /// The folder of the running program.
    pub program: Option<PathBuf>,
    /// Orb's data folder.
    pub data: Option<PathBuf>,
    /// A Python environment that is active: `VIRTUAL_ENV` or `CONDA_PREFIX`.
    pub python: Option<PathBuf>,
    /// The system's own search by name.
    pub system: bool,
    /// For what a provider wants to keep between runs.
    pub cache: Option<PathBuf>,
}

impl Search {
    /// The search of a real run.
    pub fn from_environment(
        given: Option<&Path>,
        data: Option<&Path>,
        var: impl Fn(&str) -> Option<OsString>,
    ) -> Search {
        let path = |name: &str| var(name).filter(|v| !v.is_empty()).map(PathBuf::from);
        Search {
            given: given.map(Path::to_owned),
            variable: path("ORT_DYLIB_PATH"),
            program: std::env::current_exe().ok().and_then(|p| p.parent().map(Path::to_owned)),
            data: data.map(Path::to_owned),
            python: path("VIRTUAL_ENV").or_else(|| path("CONDA_PREFIX")),
            system: true,
            cache: data.map(|d| d.join("cache").join("tensorrt")),
        }
    }
}

/// A place that was looked at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Candidate {
    pub path: PathBuf,
    pub origin: &'static str,
    /// The user named it: it must be good, nothing stands in for it.
    pub asked_for: bool,
    pub state: State,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Missing,
    /// The file cannot be loaded, or is no ONNX Runtime 1.
    NotARuntime,
    /// Its minor version.
    TooOld(u32),
    Good(u32),
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            State::Missing => f.write_str("nothing there"),
            State::NotARuntime => f.write_str("no ONNX Runtime 1 that this machine can load"),
            State::TooOld(minor) => write!(f, "ONNX Runtime 1.{minor}, too old: 1.{LEAST_MINOR} is the least"),
            State::Good(minor) => write!(f, "ONNX Runtime 1.{minor}"),
        }
    }
}

impl Candidate {
    pub fn is_good(&self) -> bool {
        matches!(self.state, State::Good(_))
    }
}

/// Every place in order: `--onnxruntime`, `ORT_DYLIB_PATH`, beside the program and in its `lib`, the data folder's
/// `runtime`, the system's own search, an active Python environment. Stops where the user named one.
pub fn look(search: &Search) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (path, origin) in [(&search.given, "--onnxruntime"), (&search.variable, "ORT_DYLIB_PATH")] {
        if let Some(path) = path {
            let library = if path.is_dir() { libraries(path, 4).into_iter().next() } else { Some(path.clone()) };
            let library = library.unwrap_or_else(|| path.join(FILE));
            found.push(Candidate { state: judge(&library), path: library, origin, asked_for: true });
            return found;
        }
    }
    let mut add = |paths: Vec<PathBuf>, origin| {
        found.extend(paths.into_iter().map(|path| Candidate { state: judge(&path), path, origin, asked_for: false }));
    };
    if let Some(program) = &search.program {
        add(libraries(program, 0), "beside the program");
        add(libraries(&program.join("lib"), 0), "the program's lib folder");
    }
    if let Some(data) = &search.data {
        add(libraries(&data.join("runtime"), 4), "the data folder's runtime");
    }
    if search.system {
        let path = PathBuf::from(FILE);
        let state = probe(&path);
        if state != State::NotARuntime {
            found.push(Candidate { path, origin: "the system", asked_for: false, state });
        }
    }
    if let Some(python) = &search.python {
        let paths = libraries(python, 5);
        found.extend(paths.into_iter().map(|path| Candidate {
            state: judge(&path),
            path,
            origin: "the active Python environment",
            asked_for: false,
        }));
    }
    found
}

#[cfg(target_os = "windows")]
const FILE: &str = "onnxruntime.dll";
#[cfg(target_os = "macos")]
const FILE: &str = "libonnxruntime.dylib";
#[cfg(not(any(target_os = "windows", target_os = "macos")))]
const FILE: &str = "libonnxruntime.so";

fn is_library(name: &str) -> bool {
    match FILE.rsplit_once('.') {
        // libonnxruntime.1.31.1.dylib
        Some((stem, "dylib")) => name.starts_with(stem) && name.ends_with(".dylib") && !name.contains("providers"),
        Some((_, "dll")) => name.eq_ignore_ascii_case(FILE),
        // libonnxruntime.so.1.31.1
        _ => name == FILE || name.strip_prefix(FILE).is_some_and(|rest| rest.starts_with('.')),
    }
}

/// Libraries below a folder, `depth` folders down, in the order of their names; only where names allow a runtime.
fn libraries(folder: &Path, depth: usize) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut entries: Vec<_> = entries.flatten().collect();
    entries.sort_by_key(std::fs::DirEntry::file_name);
    let mut found = Vec::new();
    for entry in &entries {
        let name = entry.file_name().to_string_lossy().into_owned();
        if is_library(&name) && entry.path().is_file() {
            found.push(entry.path());
        }
    }
    // A Python environment is large: only the way to the runtime is walked.
    let way = |name: &str| {
        name.starts_with("python")
            || name.starts_with("onnxruntime")
            || matches!(name, "lib" | "lib64" | "Lib" | "site-packages" | "capi")
            || name.starts_with(|c: char| c.is_ascii_digit())
    };
    if depth > 0 {
        for entry in &entries {
            if way(&entry.file_name().to_string_lossy()) && entry.path().is_dir() {
                found.extend(libraries(&entry.path(), depth - 1));
            }
        }
    }
    found
}

fn judge(path: &Path) -> State {
    if !path.is_file() {
        return State::Missing;
    }
    // The loader takes a relative path as relative to the program; a user means the current folder.
    probe(&std::path::absolute(path).unwrap_or_else(|_| path.to_owned()))
}

#[cfg(feature = "ort")]
fn probe(path: &Path) -> State {
    match super::ort::probe(path) {
        None => State::NotARuntime,
        Some(minor) if minor < LEAST_MINOR => State::TooOld(minor),
        Some(minor) => State::Good(minor),
    }
}

#[cfg(not(feature = "ort"))]
fn probe(_: &Path) -> State {
    State::NotARuntime
}

#[cfg(test)]
mod tests {
    use super::*;

    fn touch(path: &Path) {
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, b"not a library").unwrap();
    }

    #[test]
    fn places_come_in_their_order() {
        let dir = tempfile::tempdir().unwrap();
        let at = |name: &str| dir.path().join(name);
        let python = format!("venv/lib/python3.11/site-packages/onnxruntime/capi/{FILE}");
        for name in [format!("bin/{FILE}"), format!("bin/lib/{FILE}"), format!("data/runtime/onnxruntime/1.31/{FILE}")]
        {
            touch(&at(&name));
        }
        touch(&at(&python));
        touch(&at("venv/lib/python3.11/site-packages/other/libonnxruntime.so"));
        let mut search =
            Search { program: Some(at("bin")), data: Some(at("data")), python: Some(at("venv")), ..Default::default() };
        let origins: Vec<_> = look(&search).iter().map(|c| c.origin).collect();
        assert_eq!(
            origins,
            [
                "beside the program",
                "the program's lib folder",
                "the data folder's runtime",
                "the active Python environment"
            ]
        );
        assert!(look(&search).iter().all(|c| c.state == State::NotARuntime));
        search.variable = Some(at("nowhere.so"));
        let named = look(&search);
        assert_eq!((named.len(), named[0].origin, named[0].state), (1, "ORT_DYLIB_PATH", State::Missing));
        search.given = Some(at("bin"));
        let named = look(&search);
        assert_eq!((named.len(), named[0].origin), (1, "--onnxruntime"));
        assert_eq!(named[0].path, at("bin").join(FILE));
    }

    #[test]
    fn only_a_runtimes_own_names_are_loaded() {
        assert!(is_library(FILE));
        for name in ["libonnxruntime_providers_shared.so", "libonnxruntime_providers_cuda.so", "libm.so", ""] {
            assert!(!is_library(name), "{name}");
        }
    }
}
