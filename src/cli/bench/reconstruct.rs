//! Orb's own results for the benchmark: `orb geo` in a process of its own, without a network, timed.

use std::path::Path;
use std::process::{Child, Command, Stdio};

use serde_json::Value;

use crate::{Error, Kind, Result};

/// What a run of `orb geo` took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    pub seconds: Option<f64>,
    pub peak_memory_bytes: Option<f64>,
    /// Some(true): it ran in a network namespace of its own that held nothing but an unused loopback. None: this system
    /// gave it no such namespace.
    pub offline: Option<bool>,
}

/// Everything a deployment takes along.
const FORMATS: &str = "cdb,flt,glb,usdz,spz";

/// Reconstructs a photo into `output`. `data` is where keys and ledger of these runs lie: results of a benchmark are no
/// products, and the user's ledger stays as it is.
///
/// # Errors
/// What the run said, with its kind; environment where it cannot be started.
pub fn run(photo: &Path, output: &Path, data: &Path, models: &Path, options: &[String]) -> Result<Cost> {
    let program = std::env::current_exe().map_err(|e| Error::environment("orb").found(e.to_string()))?;
    let command = |isolated: bool| {
        let mut c = Command::new(&program);
        c.arg("geo")
            .arg(photo)
            .args(["--origin", "0,0,0", "--json", "--quiet", "--format", FORMATS])
            .arg("-o")
            .arg(output);
        c.args(options).env("ORB_DATA_DIR", data).env("ORB_MODELS_DIR", models);
        c.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        if isolated {
            namespace::leave_network(&mut c);
        }
        c.spawn()
    };
    // A system that refuses the namespace refuses the start.
    let (child, isolated) = match command(true) {
        Ok(child) => (child, namespace::AVAILABLE),
        Err(_) => (command(false).map_err(|e| Error::io(&program, &e))?, false),
    };
    let offline = if isolated { namespace::is_without_network(&child) } else { None };
    let done = child.wait_with_output().map_err(|e| Error::io(&program, &e))?;
    if !done.status.success() {
        let said = String::from_utf8_lossy(&done.stderr).trim().trim_start_matches("orb: ").to_owned();
        let kind = match done.status.code() {
            Some(2) => Kind::Usage,
            Some(4) => Kind::Policy,
            None | Some(130) => Kind::Cancelled,
            _ => Kind::Environment,
        };
        return Err(Error::new(kind, photo.display().to_string()).expected("a reconstruction").found(said));
    }
    let told: Value = serde_json::from_slice(&done.stdout)
        .map_err(|e| Error::environment("orb geo --json").expected("JSON").found(e.to_string()))?;
    Ok(Cost { seconds: told["seconds"].as_f64(), peak_memory_bytes: told["peak_memory_bytes"].as_f64(), offline })
}

#[cfg(target_os = "linux")]
mod namespace {
    use std::io;
    use std::os::unix::process::CommandExt;

    use super::{Child, Command};

    pub const AVAILABLE: bool = true;

    /// The program will begin in a new network namespace: no interface but a loopback that is down (network_namespaces(7)).
    pub fn leave_network(command: &mut Command) {
        // SAFETY: between fork and exec only async-signal-safe calls are allowed; unshare is a bare system call, touches no
        // memory, takes no lock.
        unsafe {
            command.pre_exec(|| {
                // The owner of the system may; others may inside a user namespace of their own.
                let alone = |flags| libc::unshare(flags) == 0;
                if alone(libc::CLONE_NEWNET) || alone(libc::CLONE_NEWUSER | libc::CLONE_NEWNET) {
                    Ok(())
                } else {
                    Err(io::Error::last_os_error())
                }
            });
        }
    }

    /// Whether the running child has another network than this process, and in it nothing but an unused loopback.
    pub fn is_without_network(child: &Child) -> Option<bool> {
        let of = |who: &str| std::fs::read_link(format!("/proc/{who}/ns/net")).ok();
        let another = of(&child.id().to_string())? != of("self")?;
        let table = std::fs::read_to_string(format!("/proc/{}/net/dev", child.id())).ok()?;
        Some(another && only_an_unused_loopback(&table))
    }

    /// Two lines of headings, then `name: bytes packets …`.
    pub fn only_an_unused_loopback(table: &str) -> bool {
        table.lines().skip(2).all(|l| {
            l.split_once(':')
                .is_some_and(|(name, numbers)| name.trim() == "lo" && numbers.split_whitespace().all(|n| n == "0"))
        })
    }
}

#[cfg(not(target_os = "linux"))]
mod namespace {
    use super::{Child, Command};

    pub const AVAILABLE: bool = false;
    pub fn leave_network(_: &mut Command) {}
    pub fn is_without_network(_: &Child) -> Option<bool> {
        None
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn a_child_of_its_own_network_is_told_from_one_of_ours() {
        let sleep = |isolated: bool| {
            let mut c = Command::new("sleep");
            c.arg("5");
            if isolated {
                namespace::leave_network(&mut c);
            }
            c.spawn()
        };
        let mut ours = sleep(false).unwrap();
        assert_eq!(namespace::is_without_network(&ours), Some(false));
        ours.kill().unwrap();
        ours.wait().unwrap();
        match sleep(true) {
            Ok(mut alone) => {
                assert_eq!(namespace::is_without_network(&alone), Some(true));
                alone.kill().unwrap();
                alone.wait().unwrap();
            }
            Err(e) => eprintln!("skipped: this system gives no network namespace: {e}"),
        }
        let head = "Inter-|\n face |\n";
        assert!(namespace::only_an_unused_loopback(&format!("{head}    lo: 0 0 0\n")));
        assert!(!namespace::only_an_unused_loopback(&format!("{head}    lo: 9 1 0\n")));
        assert!(!namespace::only_an_unused_loopback(&format!("{head}    lo: 0 0\n  eth0: 0 0\n")));
    }
}
