//! What a record says of the program's making: the commit of its source, the compiler, the features, the target, how the FIPS
//! module is linked. Nothing of the day or the machine, so that the same source built in the same way stays the same program.

use std::env;
use std::path::Path;
use std::process::Command;

/// What the program is made of: a change in it, and in nothing else, makes the commit "dirty".
const SOURCES: [&str; 10] = [
    "Cargo.toml",
    "Cargo.lock",
    "build.rs",
    "src",
    "formats",
    "shaders",
    "prior/scene.onnx",
    "prior/detail.onnx",
    "prior/splat.onnx",
    "docs/record.schema.json",
];
const UNKNOWN: &str = "unknown";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    for name in ["ORB_GIT_COMMIT", "AWS_LC_FIPS_SYS_USE_SYSTEM", "AWS_LC_FIPS_SYS_STATIC"] {
        println!("cargo::rerun-if-env-changed={name}");
    }
    let (commit, dirty) = source();
    let var = |name: &str| env::var(name).unwrap_or_default();
    let rustc = said_by(Command::new(var("RUSTC")).arg("--version"));
    let built = [
        ("COMMIT", commit),
        ("DIRTY", dirty.map_or(UNKNOWN.into(), |d| d.to_string())),
        ("RUSTC", rustc.unwrap_or(UNKNOWN.into())),
        ("PROFILE", profile()),
        ("FEATURES", features()),
        ("TARGET", var("TARGET")),
        ("FIPS_MODULE", fips_module().into()),
    ];
    for (name, value) in built {
        println!("cargo::rustc-env=ORB_BUILD_{name}={value}");
    }
}

/// The commit of the source and whether the source differs from it. `ORB_GIT_COMMIT` says it where there is no repository, as
/// in a source archive. Builds for development say nothing: they would have to be made anew after every commit.
fn source() -> (String, Option<bool>) {
    if let Ok(commit) = env::var("ORB_GIT_COMMIT") {
        let is_one = matches!(commit.len(), 40 | 64) && commit.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f'));
        assert!(is_one, "ORB_GIT_COMMIT: expected 40 or 64 lower-case hexadecimal digits, found {commit:?}");
        return (commit, None);
    }
    let known = || {
        for path in SOURCES {
            println!("cargo::rerun-if-changed={path}");
        }
        let root = env::var("CARGO_MANIFEST_DIR").ok()?;
        let git =
            |args: &[&str]| said_by(Command::new("git").current_dir(&root).env("GIT_OPTIONAL_LOCKS", "0").args(args));
        // A source archive that lies inside of somebody else's repository is not of its commit.
        let top = git(&["rev-parse", "--show-toplevel"])?;
        if Path::new(&top).canonicalize().ok()? != Path::new(&root).canonicalize().ok()? {
            return None;
        }
        for name in ["HEAD", "logs/HEAD"] {
            println!("cargo::rerun-if-changed={}", git(&["rev-parse", "--git-path", name])?);
        }
        let changed = git(&[&["status", "--porcelain", "--"][..], &SOURCES].concat())?;
        Some((git(&["rev-parse", "HEAD"])?, Some(!changed.is_empty())))
    };
    if profile() == "debug" { None } else { known() }.unwrap_or((UNKNOWN.into(), None))
}

/// `debug` for development, else `release`.
fn profile() -> String {
    env::var("PROFILE").unwrap_or_default()
}

/// What a program printed; `None` where it is not there or failed.
fn said_by(command: &mut Command) -> Option<String> {
    let out = command.output().ok().filter(|out| out.status.success())?;
    Some(String::from_utf8(out.stdout).ok()?.trim().to_owned())
}

/// Of this package, sorted, commas between.
fn features() -> String {
    let mut all: Vec<String> = env::vars()
        .filter_map(|(name, _)| Some(name.strip_prefix("CARGO_FEATURE_")?.to_lowercase().replace('_', "-")))
        .filter(|name| name != "default")
        .collect();
    all.sort();
    all.join(",")
}

/// How aws-lc-fips-sys links the module (its build script's rules): one that it was not made to build from its own source may
/// be any.
fn fips_module() -> &'static str {
    let var = |name: &str| env::var(name).unwrap_or_default();
    if var("AWS_LC_FIPS_SYS_USE_SYSTEM") != "0" {
        return UNKNOWN;
    }
    let (os, arch) = (var("CARGO_CFG_TARGET_OS"), var("CARGO_CFG_TARGET_ARCH"));
    let by_default = (os == "linux" || os.ends_with("bsd")) && (arch == "x86_64" || arch == "aarch64");
    match var("AWS_LC_FIPS_SYS_STATIC").as_str() {
        "" if by_default => "static",
        "" => "dynamic",
        "1" => "static",
        "0" => "dynamic",
        _ => UNKNOWN,
    }
}
