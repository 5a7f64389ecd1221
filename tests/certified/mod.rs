//! Certificates of a test's own, servers that have them, and what asks these under TLS.
#![allow(dead_code, reason = "each test that needs certificates uses a part of it")]

use std::io::{self, Read as _, Write as _};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
#[cfg(unix)]
use std::process::Command;
use std::process::Stdio;
use std::sync::Arc;
use std::time::Duration;

use rustls::pki_types::pem::PemObject as _;
use rustls::pki_types::{CertificateDer, PrivateKeyDer, ServerName};
use rustls::{ClientConfig, ClientConnection, RootCertStore, StreamOwned, SupportedProtocolVersion};

use crate::served::Served;
#[cfg(unix)]
use crate::served::orb;

/// Of `tests/data/tls`, in a folder where keys have the mode that they must have.
pub struct Certificates(tempfile::TempDir);

impl Certificates {
    pub fn new() -> Certificates {
        let folder = tempfile::tempdir().unwrap();
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/tls");
        for entry in std::fs::read_dir(from).unwrap() {
            let path = entry.unwrap().path();
            let to = folder.path().join(path.file_name().unwrap());
            std::fs::copy(&path, &to).unwrap();
            set_mode(&to, 0o600);
        }
        Certificates(folder)
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn text(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }

    pub fn data(&self) -> PathBuf {
        self.path("data")
    }

    pub fn serve(&self, options: &[&str]) -> Served {
        self.serve_saying(options, Stdio::inherit())
    }

    /// With its standard error somewhere.
    pub fn serve_saying(&self, options: &[&str], error: Stdio) -> Served {
        let (certificate, key) = (self.text("server.pem"), self.text("server.key"));
        let all = [&["--tls-cert", &certificate, "--tls-key", &key, "--name", "orb.example"], options].concat();
        Served::start_saying(&self.data(), "127.0.0.1:0", &all, &[], error)
    }

    pub fn client(
        &self,
        authority: &str,
        own: Option<&str>,
        version: &'static SupportedProtocolVersion,
    ) -> Arc<ClientConfig> {
        let mut roots = RootCertStore::empty();
        roots.add(CertificateDer::from_pem_file(self.path(&format!("{authority}.pem"))).unwrap()).unwrap();
        let config = ClientConfig::builder_with_provider(Arc::new(rustls::crypto::aws_lc_rs::default_provider()))
            .with_protocol_versions(&[version])
            .unwrap()
            .with_root_certificates(roots);
        Arc::new(match own {
            None => config.with_no_client_auth(),
            Some(own) => {
                let chain = vec![CertificateDer::from_pem_file(self.path(&format!("{own}.pem"))).unwrap()];
                let key = PrivateKeyDer::from_pem_file(self.path(&format!("{own}.key"))).unwrap();
                config.with_client_auth_cert(chain, key).unwrap()
            }
        })
    }
}

#[cfg(unix)]
pub fn set_mode(path: &Path, mode: u32) {
    use std::os::unix::fs::PermissionsExt as _;
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode)).unwrap();
}

#[cfg(not(unix))]
pub fn set_mode(_: &Path, _: u32) {}

/// One request by HTTP 1.0 under TLS; the whole answer.
pub fn ask(served: &Served, config: &Arc<ClientConfig>, request: &str) -> io::Result<String> {
    let name = ServerName::try_from("orb.example").unwrap();
    let connection = ClientConnection::new(Arc::clone(config), name).unwrap();
    let stream = TcpStream::connect(&served.host)?;
    stream.set_read_timeout(Some(Duration::from_secs(30)))?;
    let mut stream = StreamOwned::new(connection, stream);
    stream.write_all(request.as_bytes())?;
    let mut answer = Vec::new();
    match stream.read_to_end(&mut answer) {
        Err(e) if answer.is_empty() || e.kind() != io::ErrorKind::UnexpectedEof => Err(e),
        _ => Ok(String::from_utf8_lossy(&answer).into_owned()),
    }
}

pub fn get(path: &str, host: &str) -> String {
    format!("GET {path} HTTP/1.0\r\nHost: {host}\r\n\r\n")
}

/// Ends a server in order; its ledger.
#[cfg(unix)]
pub fn stop(served: &mut Served, certificates: &Certificates) -> String {
    assert!(Command::new("kill").args(["-INT", &served.child.id().to_string()]).status().unwrap().success());
    assert!(served.child.wait().unwrap().success());
    let events = orb(&certificates.data()).args(["audit", "events"]).output().unwrap();
    String::from_utf8(events.stdout).unwrap()
}
