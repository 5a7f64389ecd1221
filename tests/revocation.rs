//! Revocation lists of `orb serve --client-crl` that change while it serves: what is wrong with them is said and they are not
//! taken; what they revoke is gone, on connections and in sessions that were there before too.
#![cfg(all(feature = "serve", unix))]

use std::fs::File;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::certified::{Certificates, ask, get, stop};
use crate::served::{Served, account, orb};
use rustls::pki_types::ServerName;
use rustls::version::TLS13;
use rustls::{ClientConfig, ClientConnection, StreamOwned};

/// For a file that changed to be seen, on a machine that has other work too.
const PATIENCE: Duration = Duration::from_secs(60);

/// A connection that stays.
struct Kept(BufReader<StreamOwned<ClientConnection, TcpStream>>);

impl Kept {
    fn open(served: &Served, config: &Arc<ClientConfig>) -> Kept {
        let connection =
            ClientConnection::new(Arc::clone(config), ServerName::try_from("orb.example").unwrap()).unwrap();
        let stream = TcpStream::connect(&served.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        Kept(BufReader::new(StreamOwned::new(connection, stream)))
    }

    /// The status of one answer; `None` once the connection is over.
    fn ask(&mut self) -> Option<u16> {
        let request = "GET /api/v1/session HTTP/1.1\r\nHost: orb.example\r\nAuthorization: Certificate\r\n\r\n";
        self.0.get_mut().write_all(request.as_bytes()).ok()?;
        let (mut status, mut length) = (None, 0);
        loop {
            let mut line = String::new();
            if self.0.read_line(&mut line).ok()? == 0 {
                return None;
            }
            status = status.or_else(|| line.split(' ').nth(1)?.parse().ok());
            if let Some(value) = line.to_ascii_lowercase().strip_prefix("content-length:") {
                length = value.trim().parse().unwrap();
            }
            if line == "\r\n" {
                break;
            }
        }
        self.0.read_exact(&mut vec![0; length]).ok()?;
        status
    }
}

#[test]
fn lists_are_read_again_while_it_serves() {
    let certificates = Certificates::new();
    let data = certificates.data();
    for (name, certificate) in [("jane", "client.pem"), ("john", "client-two.pem")] {
        account(&data, name, "operator");
        let bound =
            orb(&data).args(["serve", "account", "bind", name, &certificates.text(certificate)]).status().unwrap();
        assert!(bound.success());
    }
    let list = certificates.path("list.pem");
    // As an administrator should: whole, by another name, and then in its place.
    let put = |name: &str| {
        let beside = certificates.path("list.new");
        std::fs::copy(certificates.path(name), &beside).unwrap();
        std::fs::rename(beside, &list).unwrap();
    };
    put("authority.crl.pem");
    let said = certificates.path("said");
    let options = ["--client-ca", &certificates.text("authority.pem"), "--client-crl", list.to_str().unwrap()];
    let mut served = certificates.serve_saying(&options, File::create(&said).unwrap().into());
    let hear = |words: &str, times: usize| {
        let end = Instant::now() + PATIENCE;
        loop {
            let text = std::fs::read_to_string(&said).unwrap();
            if text.matches(words).count() >= times {
                return text;
            }
            assert!(Instant::now() < end, "{words} ({times} times) in {text}");
            std::thread::sleep(Duration::from_millis(100));
        }
    };
    let jane = certificates.client("authority", Some("client"), &TLS13);
    let john = certificates.client("authority", Some("client-two"), &TLS13);
    let (mut of_jane, mut of_john) = (Kept::open(&served, &jane), Kept::open(&served, &john));
    assert_eq!((of_jane.ask(), of_john.ask()), (Some(200), Some(200)));
    let session = "POST /api/v1/session HTTP/1.0\r\nHost: orb.example\r\nContent-Type: application/json\r\nContent-Length: \
                   2\r\n\r\n{}";
    let begun = ask(&served, &jane, session).unwrap();
    let cookie =
        begun.lines().find_map(|l| l.strip_prefix("set-cookie: ")).unwrap().split(';').next().unwrap().to_owned();
    let by_cookie = get("/api/v1/session", "orb.example").replace("\r\n\r\n", &format!("\r\nCookie: {cookie}\r\n\r\n"));
    assert!(ask(&served, &jane, &by_cookie).unwrap().starts_with("HTTP/1.0 200"));
    // What is wrong is said, once, and changes nothing.
    std::fs::write(certificates.path("text.pem"), "no list\n").unwrap();
    for (times, (name, words)) in [
        ("text.pem", "no PEM block of type X509 CRL"),
        ("authority-forged.crl.pem", "another's signature under its name"),
        ("authority-over.crl.pem", "good until 2020-01-02"),
        ("other.crl.pem", "expected a list of CN=Orb test authority"),
    ]
    .into_iter()
    .enumerate()
    {
        put(name);
        hear(words, 1);
        let text = hear("those before stay in force", times + 1);
        assert_eq!(text.matches("those before stay in force").count(), times + 1, "{text}");
        assert_eq!((of_jane.ask(), of_john.ask()), (Some(200), Some(200)), "{name}");
        assert!(ask(&served, &jane, &by_cookie).unwrap().starts_with("HTTP/1.0 200"), "{name}");
    }
    // Revoked: her connection ends, though it is used, and there is no other; his goes on.
    put("authority-later.crl.pem");
    let text = hear("were read again; 1 certificates that were here are good no longer", 1);
    assert!(!text.contains("panicked"), "{text}");
    assert_eq!((of_jane.ask(), of_john.ask()), (None, Some(200)));
    assert!(ask(&served, &jane, &get("/health", "orb.example")).is_err());
    assert!(ask(&served, &john, &get("/health", "orb.example")).is_ok());
    // An older list would let her in again, and so would none.
    put("authority.crl.pem");
    hear("found one from 2020-01-01", 1);
    std::fs::remove_file(&list).unwrap();
    hear("those before stay in force", 6);
    assert!(ask(&served, &jane, &get("/health", "orb.example")).is_err());
    // Let in again, by a later list; the session that she had is over.
    put("authority-again.crl.pem");
    hear("were read again; 0 certificates", 1);
    let mut of_jane = Kept::open(&served, &jane);
    assert_eq!((of_jane.ask(), of_john.ask()), (Some(200), Some(200)));
    assert!(ask(&served, &jane, &by_cookie).unwrap().starts_with("HTTP/1.0 401"));
    let events = stop(&mut served, &certificates);
    // The list of events begins with what their names mean.
    let is_one = |l: &&str| l.contains("serve.revocation   success") || l.contains("serve.revocation   failure");
    let revocations: Vec<&str> = events.lines().filter(is_one).collect();
    assert_eq!(revocations.len(), 8, "{events}");
    assert_eq!(revocations.iter().filter(|l| l.contains("failure") && l.contains("REVOCATION_LIST")).count(), 6);
    assert!(revocations.iter().any(|l| l.contains("success") && l.contains("certificates_ended=1")), "{events}");
    assert!(!events.contains("list.pem"), "a path tells of people: {events}");
}
