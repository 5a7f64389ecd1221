//! Who called the program, and where it runs: gathered once, at the edge. Everything else takes it as a value.

use std::fs;
use std::path::Path;

use sha2::{Digest as _, Sha256};

use super::canonical::sha256_hex;
use super::record::printable;

/// By which way something was asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interface {
    /// A command line.
    #[default]
    Cli,
    /// A request to a server of this program. What it starts for one has a command line of its own.
    Server,
}

impl Interface {
    /// As records have it.
    pub fn name(self) -> &'static str {
        match self {
            Interface::Cli => "cli",
            Interface::Server => "server",
        }
    }
}

/// One call of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Invocation {
    pub interface: Interface,
    /// The operating system's name of the user; see [`operator_from`].
    pub operator_id: String,
    /// The installation's secret name (machine-id(5)). Records hold [`host_id`] of it, never itself.
    pub machine_id: Option<String>,
    /// What runs the container that this is one of: `docker`, `podman`, … `None` where nothing says that it is in one.
    pub container: Option<String>,
    /// The working folder as seen from the user's home folder, `.` for that itself. `None` outside of it: a record holds no
    /// absolute path.
    pub cwd_rel: Option<String>,
    /// The same in every record of one call: a UUID version 8 (RFC 9562 §5.8) made from the machine's start and the process.
    pub request_id: Option<String>,
    /// The command line, without what may be secret or tell about people.
    pub argv_redacted: Option<Vec<String>>,
    /// The machine's name, only where `ORB_RECORD_HOSTNAME` is `1`.
    pub hostname: Option<String>,
    /// `ORB_OPERATOR_NAME`: the operator's name for people to read.
    pub display: Option<String>,
    /// `ORB_OPERATOR_ROLE`: what the operator acts as.
    pub role: Option<String>,
    /// `ORB_RETENTION`: how long the record is to be kept.
    pub retention_hint: Option<String>,
}

impl Invocation {
    /// Of this process, whose command line is said by `argv_redacted`: only who reads it knows what in it may be secret.
    pub fn of_this_process(argv_redacted: Option<Vec<String>>) -> Invocation {
        let var = |name: &str| std::env::var(name).ok();
        let real = |path: &Path| fs::canonicalize(path).ok();
        let stated = |name: &str| stated(name, var);
        let home = var("HOME").or_else(|| var("USERPROFILE")).and_then(|home| real(home.as_ref()));
        let cwd = std::env::current_dir().ok().and_then(|cwd| real(&cwd));
        Invocation {
            interface: Interface::Cli,
            operator_id: operator_from(var),
            machine_id: machine_id(Path::new("/")),
            container: container(Path::new("/"), var),
            cwd_rel: cwd.zip(home).and_then(|(cwd, home)| below(&cwd, &home)),
            request_id: request_id(Path::new("/proc"), std::process::id()),
            argv_redacted,
            hostname: hostname(Path::new("/proc"), var),
            display: stated("ORB_OPERATOR_NAME"),
            role: stated("ORB_OPERATOR_ROLE"),
            retention_hint: stated("ORB_RETENTION"),
        }
    }
}

/// What records call the host of `machine_id`: another name in each ledger, from which it cannot be told.
pub fn host_id(machine_id: &str, ledger_id: &str) -> String {
    sha256_hex(format!("orb.host/v1\n{ledger_id}\n{machine_id}\n").as_bytes())
}

/// The user's name as the environment gives it; `unknown` when it does not.
pub fn operator_from(var: impl Fn(&str) -> Option<String>) -> String {
    let name = ["USER", "LOGNAME", "USERNAME"].into_iter().find_map(|n| var(n).filter(|v| !v.trim().is_empty()));
    printable(name.as_deref().unwrap_or("unknown"))
}

/// What the user wants to be said in every record.
fn stated(name: &str, var: impl Fn(&str) -> Option<String>) -> Option<String> {
    var(name).map(|words| printable(words.trim())).filter(|words| !words.is_empty())
}

/// A machine's name often tells whose it is: records have it only where the user asks for it.
fn hostname(proc: &Path, var: impl Fn(&str) -> Option<String>) -> Option<String> {
    stated("ORB_RECORD_HOSTNAME", &var).filter(|v| v == "1")?;
    let kernel = fs::read_to_string(proc.join("sys/kernel/hostname")).ok();
    stated("kernel", |_| kernel.clone()).or_else(|| stated("COMPUTERNAME", &var)).or_else(|| stated("HOSTNAME", &var))
}

/// Linux: 32 hexadecimal digits. Images of containers and machines not yet set up have an empty file, or a word in it.
fn machine_id(root: &Path) -> Option<String> {
    ["etc/machine-id", "var/lib/dbus/machine-id"].iter().find_map(|name| {
        let text = fs::read_to_string(root.join(name)).ok()?;
        let id = text.trim();
        let is_one = id.len() == 32 && id.bytes().all(|b| b.is_ascii_hexdigit()) && id.bytes().any(|b| b != b'0');
        is_one.then(|| id.to_ascii_lowercase())
    })
}

/// What container managers leave behind: systemd's container interface, podman's and Docker's files, Kubernetes' variable.
fn container(root: &Path, var: impl Fn(&str) -> Option<String>) -> Option<String> {
    let named = |text: String| Some(printable(text.trim())).filter(|name| !name.is_empty() && name.len() <= 64);
    var("container")
        .and_then(named)
        .or_else(|| fs::read_to_string(root.join("run/systemd/container")).ok().and_then(named))
        .or_else(|| root.join("run/.containerenv").exists().then(|| "podman".into()))
        .or_else(|| var("KUBERNETES_SERVICE_HOST").map(|_| "kubernetes".into()))
        .or_else(|| root.join(".dockerenv").exists().then(|| "docker".into()))
}

/// `path` as seen from `home`, `/` between its parts; `None` for what is not below.
fn below(path: &Path, home: &Path) -> Option<String> {
    // Of who has no home folder of their own everything would be below.
    home.parent()?;
    let parts: Vec<String> =
        path.strip_prefix(home).ok()?.components().map(|c| printable(&c.as_os_str().to_string_lossy())).collect();
    Some(if parts.is_empty() { ".".into() } else { parts.join("/") })
}

/// Process numbers come again, but not with the same time of start on the same start of the machine.
fn request_id(proc: &Path, pid: u32) -> Option<String> {
    let boot = fs::read_to_string(proc.join("sys/kernel/random/boot_id")).ok()?;
    let stat = fs::read_to_string(proc.join(pid.to_string()).join("stat")).ok()?;
    // proc_pid_stat(5): the second field is a name in brackets that may hold anything, the 22nd the time of start.
    let (_, fields) = stat.rsplit_once(')')?;
    let started: u64 = fields.split_whitespace().nth(19)?.parse().ok()?;
    let digest = Sha256::digest(format!("orb.request/v1\n{}\n{pid}\n{started}\n", boot.trim()));
    let mut bytes = [0; 16];
    bytes.copy_from_slice(&digest[..16]);
    Some(super::record::uuid(bytes, 8))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write(root: &Path, name: &str, text: &str) {
        let path = root.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    #[test]
    fn who_ran_it() {
        assert_eq!(operator_from(|n| (n == "LOGNAME").then(|| "jane".into())), "jane");
        assert_eq!(operator_from(|_| None), "unknown");
    }

    #[test]
    fn what_names_people_and_machines_is_said_only_when_asked() {
        let dir = tempfile::tempdir().unwrap();
        let proc = dir.path();
        write(proc, "sys/kernel/hostname", "janes-laptop\n");
        let host = |value: &'static str| hostname(proc, move |n| (n == "ORB_RECORD_HOSTNAME").then(|| value.into()));
        assert_eq!([host(""), host("0"), host("yes")], [None, None, None]);
        assert_eq!(host("1").as_deref(), Some("janes-laptop"));
        assert_eq!(hostname(proc, |_| None), None);
        let of = |value: &'static str| stated("ORB_OPERATOR_NAME", move |_| Some(value.into()));
        assert_eq!([of(""), of(" \n")], [None, None]);
        assert_eq!(of(" Jane\tDoe ").as_deref(), Some("Jane\u{fffd}Doe"));
    }

    #[test]
    fn a_host_has_another_name_in_each_ledger() {
        let id = "3d1219c7c4c5404aaa1f6d2a48adfda4";
        let names = [host_id(id, "0123456789abcdef"), host_id(id, "fedcba9876543210")];
        assert!(names[0] != names[1] && names.iter().all(|n| n.len() == 64 && !n.contains(id)));
        // printf 'orb.host/v1\n0123456789abcdef\n3d1219c7c4c5404aaa1f6d2a48adfda4\n' | sha256sum
        assert_eq!(names[0], "269bb895e8305766c4b891e2da0b1a3f56a1dbf36e5109f815fe14f0029d8cb9");
    }

    #[test]
    fn names_of_machines() {
        let dir = tempfile::tempdir().unwrap();
        let root = dir.path();
        assert_eq!(machine_id(root), None);
        for none in ["", "uninitialized\n", "00000000000000000000000000000000\n", "3d1219c7c4c5404aaa1f6d2a48adfda\n"] {
            write(root, "etc/machine-id", none);
            assert_eq!(machine_id(root), None, "{none:?}");
        }
        write(root, "var/lib/dbus/machine-id", "3D1219C7c4c5404aaa1f6d2a48adfda4\n");
        assert_eq!(machine_id(root).as_deref(), Some("3d1219c7c4c5404aaa1f6d2a48adfda4"));
    }

    #[test]
    fn containers() {
        let dir = tempfile::tempdir().unwrap();
        let root = dir.path();
        let of = |name: &'static str| container(root, move |n| (n == name).then(|| "lxc\n".into()));
        assert_eq!(of(""), None);
        write(root, ".dockerenv", "");
        assert_eq!(of("").as_deref(), Some("docker"));
        assert_eq!(of("KUBERNETES_SERVICE_HOST").as_deref(), Some("kubernetes"));
        write(root, "run/.containerenv", "");
        assert_eq!(of("").as_deref(), Some("podman"));
        write(root, "run/systemd/container", "systemd-nspawn\n");
        assert_eq!(of("").as_deref(), Some("systemd-nspawn"));
        assert_eq!(of("container").as_deref(), Some("lxc"));
    }

    #[test]
    fn folders_below_home() {
        let of = |cwd: &str, home: &str| below(Path::new(cwd), Path::new(home));
        assert_eq!(of("/home/jane/vans/one", "/home/jane").as_deref(), Some("vans/one"));
        assert_eq!(of("/home/jane", "/home/jane").as_deref(), Some("."));
        assert_eq!(of("/home/jane/a\nb", "/home/jane").as_deref(), Some("a\u{fffd}b"));
        for outside in ["/home/janet", "/home", "/srv/data", "/"] {
            assert_eq!(of(outside, "/home/jane"), None, "{outside}");
        }
        assert_eq!(of("/srv/data", "/"), None);
    }

    #[test]
    fn one_name_for_each_call() {
        let dir = tempfile::tempdir().unwrap();
        let proc = dir.path();
        let stat = |name: &str, started: u64| format!("42 ({name}) R 1 {}{started} 9 9\n", "0 ".repeat(17));
        write(proc, "sys/kernel/random/boot_id", "bfbaf76d-3eb4-472a-b7e1-82de74e141d9\n");
        assert_eq!(request_id(proc, 42), None);
        let mut names = Vec::new();
        for (name, started) in [("orb", 100), ("a) b (c", 100), ("orb", 101)] {
            write(proc, "42/stat", &stat(name, started));
            names.push(request_id(proc, 42).unwrap());
        }
        assert!(names[0] == names[1] && names[0] != names[2], "{names:?}");
        assert!(names[0].len() == 36 && &names[0][14..15] == "8", "{names:?}");
        write(proc, "42/stat", "42 (orb) R 1\n");
        assert_eq!(request_id(proc, 42), None);
    }

    #[test]
    fn this_process() {
        let (first, second) = (Invocation::of_this_process(None), Invocation::of_this_process(None));
        assert_eq!(first, second);
        assert!(first.request_id.is_some() || !cfg!(target_os = "linux"));
        assert!(first.cwd_rel.is_none_or(|path| !path.starts_with('/')));
    }
}
