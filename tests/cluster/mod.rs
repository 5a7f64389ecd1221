//! A PostgreSQL server of the tests' own: in a temporary folder, on a Unix socket and a free port of the loopback, gone with the
//! process that asked for it, however that ends. Without PostgreSQL's programs there is none, with a printed reason; under
//! ORB_REQUIRE_CLIENTS=1 that fails.
#![allow(dead_code, reason = "each test that needs a server uses a part of it")]

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, Weak};

use postgres::{Client, NoTls};

/// The password of the user `sealed`; everybody else needs none.
pub const PASSWORD: &str = "not-in-any-list";

pub struct Cluster {
    programs: PathBuf,
    folder: PathBuf,
    pub port: u16,
    /// Ends the server when its input ends.
    keeper: Child,
    made: AtomicU32,
}

/// One server for all tests of a process that run at the same time.
static SHARED: Mutex<Weak<Cluster>> = Mutex::new(Weak::new());

/// The shared server; `None`, with a printed reason, where there is no PostgreSQL.
pub fn shared() -> Option<Arc<Cluster>> {
    let mut shared = SHARED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    if let Some(running) = shared.upgrade() {
        return Some(running);
    }
    let started = Arc::new(Cluster::start()?);
    *shared = Arc::downgrade(&started);
    Some(started)
}

/// The folder of `initdb`, `pg_ctl` and `postgres`: Debian does not put them on the PATH.
fn programs() -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let on_path = std::env::split_paths(&path).find(|folder| folder.join("initdb").is_file());
    let debian = || {
        let versions = std::fs::read_dir("/usr/lib/postgresql").ok()?;
        let mut folders: Vec<PathBuf> = versions.flatten().map(|v| v.path().join("bin")).collect();
        folders.sort();
        folders.into_iter().rev().find(|folder| folder.join("initdb").is_file())
    };
    on_path.or_else(debian)
}

/// As nobody: PostgreSQL does not run as root.
#[cfg(unix)]
fn unprivileged(command: &mut Command) {
    use std::os::unix::fs::MetadataExt as _;
    use std::os::unix::process::CommandExt as _;
    if std::fs::metadata("/proc/self").is_ok_and(|m| m.uid() == 0) {
        command.uid(65534).gid(65534).current_dir("/tmp");
    }
}

#[cfg(unix)]
fn give(path: &Path, mode: u32) {
    use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _};
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode)).unwrap();
    if std::fs::metadata("/proc/self").is_ok_and(|m| m.uid() == 0) {
        std::os::unix::fs::chown(path, Some(65534), Some(65534)).unwrap();
    }
}

#[cfg(not(unix))]
fn unprivileged(_: &mut Command) {}

#[cfg(not(unix))]
fn give(_: &Path, _: u32) {}

fn run(command: &mut Command) {
    unprivileged(command);
    // To a file: a server that was started would hold a pipe open.
    let out = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status();
    assert!(out.as_ref().is_ok_and(|s| s.success()), "{command:?}: {out:?}");
}

impl Cluster {
    fn start() -> Option<Cluster> {
        let Some(programs) = programs().filter(|_| cfg!(unix)) else {
            let required = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some_and(|v| v == "1");
            assert!(!required, "cannot run: PostgreSQL (initdb, pg_ctl) is not installed");
            eprintln!("skipped: PostgreSQL (initdb, pg_ctl) is not installed");
            return None;
        };
        let folder = tempfile::Builder::new().prefix("orb-pg-").tempdir().unwrap().keep();
        give(&folder, 0o755);
        let data = folder.join("data");
        let initdb = ["--auth=trust", "--username=orb", "--encoding=UTF8", "--locale=C.UTF-8", "--no-sync"];
        run(Command::new(programs.join("initdb")).args(initdb).arg("-D").arg(&data));
        let certificates = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/tls");
        for (from, to) in [("server.pem", "server.crt"), ("server.key", "server.key")] {
            std::fs::copy(certificates.join(from), data.join(to)).unwrap();
            give(&data.join(to), 0o600);
        }
        let port = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
        let settings = format!(
            "port = {port}\nlisten_addresses = '127.0.0.1'\nunix_socket_directories = '{}'\nssl = on\nfsync = off\n\
             max_connections = 200\nlog_min_messages = fatal\n",
            folder.display()
        );
        std::fs::write(data.join("postgresql.auto.conf"), settings).unwrap();
        let rules = "local all sealed scram-sha-256\nhost all sealed all scram-sha-256\nlocal all all trust\nhost all all all trust\n";
        std::fs::write(data.join("pg_hba.conf"), rules).unwrap();
        let end = "cat >/dev/null; \"$0/pg_ctl\" -D \"$1/data\" -m immediate stop; rm -rf \"$1\"";
        let mut keeper = Command::new("sh");
        unprivileged(keeper.args(["-c", end]).arg(&programs).arg(&folder));
        let keeper = keeper.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let cluster = Cluster { programs, folder, port, keeper, made: AtomicU32::new(0) };
        cluster.control(&["start"]);
        let sealed = format!("CREATE ROLE sealed LOGIN PASSWORD '{PASSWORD}'; CREATE ROLE nobody LOGIN");
        cluster.connect("postgres").batch_execute(&sealed).unwrap();
        Some(cluster)
    }

    fn control(&self, words: &[&str]) {
        let mut command = Command::new(self.programs.join("pg_ctl"));
        run(command
            .arg("-D")
            .arg(self.folder.join("data"))
            .arg("-l")
            .arg(self.folder.join("log"))
            .arg("-w")
            .args(words));
    }

    pub fn stop(&self, how: &str) {
        self.control(&["-m", how, "stop"]);
    }

    pub fn go_on(&self) {
        self.control(&["start"]);
    }

    /// The address of a database, by its socket.
    pub fn url(&self, user: &str, database: &str) -> String {
        let socket = self.folder.display().to_string().replace('/', "%2F");
        format!("postgres://{user}@{socket}:{}/{database}", self.port)
    }

    pub fn connect(&self, database: &str) -> Client {
        Client::connect(&self.url("orb", database), NoTls).unwrap()
    }

    /// A new, empty database.
    pub fn create(&self) -> String {
        let name = format!("orb_{}", self.made.fetch_add(1, Ordering::Relaxed));
        self.connect("postgres").batch_execute(&format!("CREATE DATABASE {name} TEMPLATE template0")).unwrap();
        name
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        drop(self.keeper.stdin.take());
        let _ = self.keeper.wait();
    }
}
