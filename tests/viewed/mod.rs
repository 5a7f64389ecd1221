//! A viewer of a test's own: started on a free port, asked, killed when the test is over.
#![allow(dead_code, reason = "each test that needs a viewer uses a part of it")]

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A running viewer, ended when dropped.
pub struct Viewer {
    pub child: Child,
    pub banner: String,
    /// `http://127.0.0.1:PORT/TOKEN/`
    pub address: String,
}

impl Viewer {
    pub fn start(scene: &Path) -> Viewer {
        Viewer::start_with(scene, &[])
    }

    /// With more options.
    pub fn start_with(scene: &Path, options: &[&str]) -> Viewer {
        let mut child = Command::new(env!("CARGO_BIN_EXE_orb"))
            .arg("view")
            .arg(scene)
            .args(["--no-open", "--device", "cpu", "--quiet"])
            .args(options)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let mut next = || lines.next().expect("two lines").unwrap();
        let (banner, address) = (next(), next());
        Viewer { child, banner, address }
    }

    pub fn host(&self) -> &str {
        self.address.trim_start_matches("http://").split('/').next().unwrap()
    }

    pub fn path(&self, rest: &str) -> String {
        format!("/{}/{rest}", self.address.split('/').nth(3).unwrap())
    }

    /// Sends these bytes and reads until the server closes.
    pub fn send(&self, bytes: &str) -> String {
        let mut stream = TcpStream::connect(self.host()).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        // The server may close before all of it was sent.
        let _ = stream.write_all(bytes.as_bytes());
        let mut out = Vec::new();
        let _ = stream.read_to_end(&mut out);
        String::from_utf8_lossy(&out).into_owned()
    }

    pub fn get(&self, path: &str, host: &str) -> String {
        self.send(&format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"))
    }

    /// Seconds of processor time so far, and MiB of memory now.
    #[cfg(target_os = "linux")]
    pub fn used(&self) -> (f64, f64) {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.child.id())).unwrap();
        let fields: Vec<&str> = stat.rsplit_once(')').unwrap().1.split_whitespace().collect();
        let ticks = |i: usize| fields[i].parse::<f64>().unwrap();
        // utime and stime in hundredths of a second, rss in pages of 4 KiB.
        ((ticks(11) + ticks(12)) / 100.0, ticks(21) / 256.0)
    }
}

impl Drop for Viewer {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Of an answer.
pub fn status(answer: &str) -> &str {
    answer.split(' ').nth(1).unwrap_or("none")
}
