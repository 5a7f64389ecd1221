//! A server of a test's own: started on a free port, asked, killed when the test is over.
#![allow(dead_code, reason = "each test that needs a server uses a part of it")]

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

/// A running server, killed when dropped.
pub struct Served {
    pub child: Child,
    /// `127.0.0.1:PORT`
    pub host: String,
    data: PathBuf,
    options: Vec<String>,
    environment: Vec<(String, String)>,
}

pub fn orb(data: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_orb"));
    command.env("ORB_DATA_DIR", data);
    command
}

pub fn account(data: &Path, name: &str, roles: &str) -> String {
    let made = orb(data)
        .args(["serve", "account", "add", name, "--role", roles, "--ceiling", "UNCLASSIFIED"])
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    String::from_utf8(made.stdout).unwrap().trim().to_owned()
}

impl Served {
    pub fn start(data: &Path, bind: &str) -> Served {
        Served::start_with(data, bind, &[])
    }

    /// With more options.
    pub fn start_with(data: &Path, bind: &str, options: &[&str]) -> Served {
        Served::start_in(data, bind, options, &[])
    }

    /// And variables.
    pub fn start_in(data: &Path, bind: &str, options: &[&str], environment: &[(&str, &str)]) -> Served {
        Served::start_saying(data, bind, options, environment, Stdio::inherit())
    }

    /// And where its standard error goes.
    pub fn start_saying(
        data: &Path,
        bind: &str,
        options: &[&str],
        environment: &[(&str, &str)],
        error: Stdio,
    ) -> Served {
        let mut child = orb(data)
            .args(["serve", "--bind", bind, "--device", "cpu", "--max-marking", "UNCLASSIFIED"])
            .args(options)
            .envs(environment.iter().copied())
            .stdout(Stdio::piped())
            .stderr(error)
            .spawn()
            .unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let mut next = || lines.next().expect("two lines").unwrap();
        assert_eq!(next(), "UNCLASSIFIED");
        let host = next().split("://").nth(1).unwrap().trim_end_matches('/').to_owned();
        let options = options.iter().map(|o| (*o).to_owned()).collect();
        let environment = environment.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
        Served { child, host, data: data.to_owned(), options, environment }
    }

    /// As a loss of power does, and begins again at the same address.
    pub fn kill_and_start(&mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
        let options: Vec<&str> = self.options.iter().map(String::as_str).collect();
        let environment: Vec<(&str, &str)> = self.environment.iter().map(|(k, v)| (k.as_str(), v.as_str())).collect();
        *self = Served::start_in(&self.data, &self.host, &options, &environment);
    }

    /// The head and the body of an answer.
    pub fn send(&self, request: &[u8]) -> (String, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let _ = stream.write_all(request);
        let mut out = Vec::new();
        let _ = stream.read_to_end(&mut out);
        let end = out.windows(4).position(|w| w == b"\r\n\r\n").map_or(out.len(), |i| i + 4);
        (String::from_utf8_lossy(&out[..end]).into_owned(), out[end..].to_vec())
    }

    /// By HTTP 1.0: bodies come as they are.
    pub fn ask(&self, method: &str, path: &str, token: &str) -> (String, Vec<u8>) {
        let host = &self.host;
        self.send(
            format!("{method} {path} HTTP/1.0\r\nHost: {host}\r\nAuthorization: Bearer {token}\r\n\r\n").as_bytes(),
        )
    }

    pub fn json(&self, method: &str, path: &str, token: &str) -> Value {
        let (head, body) = self.ask(method, path, token);
        serde_json::from_slice(&body).unwrap_or_else(|e| panic!("{e}: {head}{}", String::from_utf8_lossy(&body)))
    }

    pub fn submit(&self, token: &str, photo: &[u8]) -> (String, Vec<u8>) {
        let field = |name: &str, value: &str| {
            format!("--X\r\nContent-Disposition: form-data; name=\"{name}\"\r\n\r\n{value}\r\n")
        };
        let mut body = (field("origin", "34.5523,-118.4712,740") + &field("quality", "draft")).into_bytes();
        body.extend(b"--X\r\nContent-Disposition: form-data; name=\"photo\"; filename=\"car.jpg\"\r\n\r\n");
        body.extend(photo);
        body.extend(b"\r\n--X--\r\n");
        let head = format!(
            "POST /api/v1/jobs HTTP/1.0\r\nHost: {}\r\nAuthorization: Bearer {token}\r\n\
             Content-Type: multipart/form-data; boundary=X\r\nContent-Length: {}\r\n\r\n",
            self.host,
            body.len()
        );
        self.send(&[head.into_bytes(), body].concat())
    }

    /// MiB of memory now.
    #[cfg(target_os = "linux")]
    pub fn memory(&self) -> f64 {
        let status = std::fs::read_to_string(format!("/proc/{}/statm", self.child.id())).unwrap();
        status.split_whitespace().nth(1).unwrap().parse::<f64>().unwrap() / 256.0
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
