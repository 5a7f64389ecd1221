//! `orb serve --tls-cert`: handshakes by rustls and by OpenSSL, with and without certificates of clients; what is wrong with
//! the files; who dawdles. Without openssl on the PATH that part says so and passes; under ORB_REQUIRE_CLIENTS=1 it fails.
#![cfg(feature = "serve")]

use std::io::{self, Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

#[cfg(unix)]
use crate::certified::stop;
use crate::certified::{Certificates, ask, get, set_mode};
use crate::served::{Served, account, orb};
use rustls::pki_types::CertificateDer;
use rustls::pki_types::pem::PemObject as _;
use rustls::version::{TLS12, TLS13};

#[test]
fn what_is_asked_under_tls_is_answered_under_tls() {
    let certificates = Certificates::new();
    let token = account(&certificates.data(), "jane", "operator");
    let mut served = certificates.serve(&[]);
    for version in [&TLS12, &TLS13] {
        let client = certificates.client("authority", None, version);
        let answer = ask(&served, &client, &get("/health", "orb.example")).unwrap();
        assert!(answer.starts_with("HTTP/1.0 200") && answer.ends_with("\r\n\r\nok\n"), "{answer}");
        assert!(answer.contains("\r\nstrict-transport-security: max-age=31536000\r\n"), "{answer}");
        // Somebody else's authority: the client goes no further.
        let stranger = certificates.client("other", None, version);
        let refused = ask(&served, &stranger, &get("/health", "orb.example")).unwrap_err();
        assert!(refused.to_string().contains("UnknownIssuer"), "{refused}");
    }
    let client = certificates.client("authority", None, &TLS13);
    let of_this_machine = ask(&served, &client, &get("/health", "localhost:1")).unwrap();
    assert!(of_this_machine.contains(" 200 ") && !of_this_machine.contains("strict-transport"), "{of_this_machine}");
    let body = format!("{{\"token\":\"{token}\"}}");
    let signed_in = ask(
        &served,
        &client,
        &format!(
            "POST /api/v1/session HTTP/1.0\r\nHost: orb.example\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        ),
    )
    .unwrap();
    let cookie = signed_in.lines().find(|l| l.starts_with("set-cookie: ")).unwrap();
    assert!(cookie.starts_with("set-cookie: __Host-orb_session=") && cookie.ends_with("; Secure"), "{cookie}");
    // Who does not speak TLS is told so, and nothing else.
    let (head, body) = served.send(get("/health", "localhost").as_bytes());
    assert!(head.starts_with("HTTP/1.0 400 ") && body.starts_with(b"this port speaks TLS"), "{head}");
    let events = stop(&mut served, &certificates);
    let sha256 = hex::encode(<sha2::Sha256 as sha2::Digest>::digest(
        CertificateDer::from_pem_file(certificates.path("server.pem")).unwrap(),
    ));
    let start = events.lines().find(|l| l.contains("serve.start") && l.contains(" success ")).unwrap();
    // The list shows the beginning of long values.
    for part in ["tls=on", &format!("certificate_sha256={}", &sha256[..16]), "client_certificates=not asked for"] {
        assert!(start.contains(part), "{part} in {start}");
    }
}

#[cfg(unix)]
#[test]
fn who_has_no_certificate_of_the_authority_gets_nowhere() {
    let certificates = Certificates::new();
    let token = account(&certificates.data(), "jane", "operator");
    let authority = certificates.text("authority.pem");
    let mut served = certificates.serve(&["--client-ca", &authority]);
    let list = |token: &str| {
        get("/api/v1/jobs", "orb.example").replace("\r\n\r\n", &format!("\r\nAuthorization: Bearer {token}\r\n\r\n"))
    };
    for version in [&TLS12, &TLS13] {
        let client = |own| certificates.client("authority", own, version);
        let answer = ask(&served, &client(Some("client")), &list(&token)).unwrap();
        assert!(answer.starts_with("HTTP/1.0 200"), "{answer}");
        // It admits, and is nobody's name.
        let answer = ask(&served, &client(Some("client")), &list("orb_jane_x")).unwrap();
        assert!(answer.starts_with("HTTP/1.0 401"), "{answer}");
        for own in [None, Some("client-over"), Some("client-of-other"), Some("server")] {
            let answer = ask(&served, &client(own), &list(&token));
            assert!(answer.is_err(), "{own:?}: {answer:?}");
        }
    }
    let events = stop(&mut served, &certificates);
    let refused = events.lines().find(|l| l.contains("CLIENT_CERTIFICATE")).unwrap();
    assert!(refused.contains("access.refused") && refused.contains("times=8"), "{refused}");
    assert!(
        events.lines().any(|l| l.contains("serve.start") && l.contains("client_certificates=required")),
        "{events}"
    );
}

/// With `Authorization: Certificate`, or by a session that was begun with it.
#[cfg(unix)]
#[test]
fn a_certificate_is_the_account_that_it_is_bound_to() {
    let certificates = Certificates::new();
    let data = certificates.data();
    let token = account(&data, "jane", "operator");
    let admin = account(&data, "root", "admin");
    let by_hand = |verb: &str, name: &str, certificate: &str| {
        let out = orb(&data).args(["serve", "account", verb, name, certificate]).output().unwrap();
        (out.status.code(), String::from_utf8_lossy(&out.stderr).into_owned())
    };
    let own = certificates.text("client.pem");
    assert_eq!(by_hand("bind", "jane", &own).0, Some(0));
    for (verb, name, certificate, words) in [
        ("bind", "root", own.as_str(), "bound to nobody"),
        ("bind", "nobody", &certificates.text("client-two.pem"), "name of an account"),
        ("unbind", "root", &own, "bound to root"),
        ("bind", "jane", &certificates.text("client.key"), "CERTIFICATE"),
    ] {
        let found = by_hand(verb, name, certificate);
        assert!(found.0 == Some(2) && found.1.contains(words), "{verb} {name}: {found:?}");
    }
    // What was revoked later was bound before.
    assert_eq!(by_hand("bind", "jane", &certificates.text("client-revoked.pem")).0, Some(0));
    let (authority, list) = (certificates.text("authority.pem"), certificates.text("authority.crl.pem"));
    let mut served = certificates.serve(&["--client-ca", &authority, "--client-crl", &list]);
    let to = |own: &str, method: &str, path: &str, headers: &str, body: &str| {
        let client = certificates.client("authority", Some(own), &TLS13);
        let length = body.len();
        let head =
            format!("{method} {path} HTTP/1.0\r\nHost: orb.example\r\nContent-Length: {length}\r\n{headers}\r\n{body}");
        ask(&served, &client, &head)
    };
    let status = |own: &str, method: &str, path: &str, headers: &str, body: &str| {
        let answer = to(own, method, path, headers, body).unwrap();
        answer.split(' ').nth(1).unwrap().parse::<u16>().unwrap()
    };
    let by_certificate = "Authorization: Certificate\r\n";
    let who = to("client", "GET", "/api/v1/session", by_certificate, "").unwrap();
    assert!(who.contains("\"account\":\"jane\"") && who.contains("\"csrf\":null"), "{who}");
    // It has to be said: a connection alone is nobody.
    assert_eq!(status("client", "GET", "/api/v1/session", "", ""), 401);
    // Of the right authority, and nobody's.
    assert_eq!(status("client-two", "GET", "/api/v1/session", by_certificate, ""), 401);
    let json = "Content-Type: application/json\r\n";
    assert_eq!(status("client-two", "POST", "/api/v1/session", json, "{}"), 401);
    // Revoked, out of date, of another authority: not even the handshake, whatever they are bound to.
    for own in ["client-revoked", "client-over", "client-of-other"] {
        let answer = to(own, "GET", "/api/v1/session", by_certificate, "");
        assert!(answer.is_err(), "{own}: {answer:?}");
    }
    // A session is its certificate's alone.
    let begun = to("client", "POST", "/api/v1/session", json, "{}").unwrap();
    let cookie = begun.lines().find_map(|l| l.strip_prefix("set-cookie: ")).unwrap();
    let cookie = format!("Cookie: {}\r\n", cookie.split(';').next().unwrap());
    assert_eq!(status("client", "GET", "/api/v1/jobs", &cookie, ""), 200);
    assert_eq!(status("client-two", "GET", "/api/v1/jobs", &cookie, ""), 401, "carried off");
    assert_eq!(status("client", "GET", "/api/v1/jobs", &cookie, ""), 200, "and goes on where it belongs");
    let elsewhere = format!("{json}Sec-Fetch-Site: cross-site\r\n");
    assert_eq!(status("client", "POST", "/api/v1/session", &elsewhere, "{}"), 403);
    assert_eq!(status("client", "POST", "/api/v1/jobs/x/cancel", &cookie, ""), 403, "without the session's secret");
    // A token's session is a token's, by any certificate.
    let bearer = format!("Authorization: Bearer {token}\r\n");
    assert_eq!(status("client-two", "GET", "/api/v1/jobs", &bearer, ""), 200);
    // What administrators do to it.
    let root = format!("Authorization: Bearer {admin}\r\n{json}");
    let sha256 = hex::encode(<sha2::Sha256 as sha2::Digest>::digest(
        CertificateDer::from_pem_file(certificates.path("client.pem")).unwrap(),
    ));
    let listed = to("client", "GET", "/api/v1/accounts", &root, "").unwrap();
    assert!(listed.contains(&sha256), "{listed}");
    let at = "/api/v1/accounts/jane/certificates";
    assert_eq!(status("client", "POST", "/api/v1/accounts/jane/disable", &root, ""), 204);
    assert_eq!(status("client", "GET", "/api/v1/session", by_certificate, ""), 401, "disabled");
    assert_eq!(status("client", "POST", "/api/v1/accounts/jane/enable", &root, ""), 204);
    let begun = to("client", "POST", "/api/v1/session", json, "{}").unwrap();
    let cookie = begun.lines().find_map(|l| l.strip_prefix("set-cookie: ")).unwrap();
    let cookie = format!("Cookie: {}\r\n", cookie.split(';').next().unwrap());
    assert_eq!(status("client", "DELETE", &format!("{at}/{sha256}"), &bearer, ""), 403, "not an administrator");
    assert_eq!(status("client", "DELETE", &format!("{at}/{}", "0".repeat(64)), &root, ""), 404);
    assert_eq!(status("client", "DELETE", &format!("{at}/{sha256}"), &root, ""), 204);
    assert_eq!(status("client", "GET", "/api/v1/jobs", &cookie, ""), 401, "its session is over");
    assert_eq!(status("client", "GET", "/api/v1/session", by_certificate, ""), 401);
    let colons: Vec<String> =
        sha256.to_uppercase().as_bytes().chunks(2).map(|c| String::from_utf8_lossy(c).into()).collect();
    let body = format!("{{\"sha256\":\"{}\"}}", colons.join(":"));
    assert_eq!(status("client", "POST", at, &bearer, &body), 403, "not an administrator");
    assert_eq!(status("client", "POST", at, &root, "{\"sha256\":\"00\"}"), 422);
    assert_eq!(status("client", "POST", at, &root, &body), 204);
    assert_eq!(status("client", "POST", at, &root, &body), 409, "bound");
    assert_eq!(status("client", "GET", "/api/v1/session", by_certificate, ""), 200);
    let events = stop(&mut served, &certificates);
    for (kind, about) in [
        ("account.change", "change=bound"),
        ("account.change", "change=unbound"),
        ("account.change", &format!("certificate_sha256={}", &sha256[..16])),
        ("access.refused", "CERTIFICATE_UNKNOWN"),
        ("access.refused", "CERTIFICATE_OTHER"),
        ("access.refused", "CLIENT_CERTIFICATE"),
        ("access.refused", "ACCOUNT_DISABLED"),
        ("session.begin", "account=jane"),
        ("serve.start", "revocation_lists=read"),
    ] {
        assert!(events.lines().any(|l| l.contains(kind) && l.contains(about)), "{kind} {about} in {events}");
    }
    // A list of another authority's says nothing of these: nobody comes in.
    let other = certificates.text("other.crl.pem");
    let served = certificates.serve(&["--client-ca", &authority, "--client-crl", &other]);
    let client = certificates.client("authority", Some("client"), &TLS13);
    assert!(ask(&served, &client, &get("/health", "orb.example")).is_err());
}

#[test]
fn what_is_wrong_with_a_revocation_list_is_said() {
    let certificates = Certificates::new();
    std::fs::write(certificates.path("damaged.crl.pem"), "-----BEGIN X509 CRL-----\nMAA=\n-----END X509 CRL-----\n")
        .unwrap();
    for (authority, list, words) in [
        (true, "authority-over.crl.pem", "good until 2020-01-02"),
        (true, "authority.pem", "no PEM block of type X509 CRL"),
        (true, "damaged.crl.pem", "damaged"),
        (true, "authority-forged.crl.pem", "another's signature under its name"),
        (false, "authority.crl.pem", "--client-ca"),
    ] {
        let mut command = orb(&certificates.data());
        command.args(["serve", "--bind", "127.0.0.1:0", "--max-marking", "UNCLASSIFIED"]);
        command.arg("--tls-cert").arg(certificates.path("server.pem"));
        command.arg("--tls-key").arg(certificates.path("server.key"));
        if authority {
            command.arg("--client-ca").arg(certificates.path("authority.pem"));
        }
        let out = command.arg("--client-crl").arg(certificates.path(list)).output().unwrap();
        let said = String::from_utf8_lossy(&out.stderr);
        assert!(out.status.code() == Some(2) && said.contains(words), "{list}: {said}");
    }
}

#[test]
fn openssl_shakes_hands() {
    let required = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some_and(|v| v == "1");
    if Command::new("openssl").arg("version").output().is_err() {
        assert!(!required, "openssl is not on the PATH");
        eprintln!("skipped: openssl is not on the PATH");
        return;
    }
    let certificates = Certificates::new();
    account(&certificates.data(), "jane", "operator");
    let authority = certificates.text("authority.pem");
    let served = certificates.serve(&["--client-ca", &authority]);
    let shake = |options: &[&str]| {
        let mut child = Command::new("openssl")
            .args(["s_client", "-quiet", "-connect", &served.host, "-CAfile", &authority])
            .args(["-verify_return_error", "-verify_hostname", "orb.example", "-servername", "orb.example"])
            .args(options)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut input = child.stdin.take().unwrap();
        let _ = input.write_all(get("/health", "orb.example").as_bytes());
        let done = child.wait_with_output().unwrap();
        drop(input);
        (String::from_utf8_lossy(&done.stdout).into_owned(), String::from_utf8_lossy(&done.stderr).into_owned())
    };
    let (own, key) = (certificates.text("client.pem"), certificates.text("client.key"));
    let own = ["-cert", own.as_str(), "-key", key.as_str()];
    for version in ["-tls1_2", "-tls1_3"] {
        let (answer, words) = shake(&[&own[..], &[version]].concat());
        assert!(answer.starts_with("HTTP/1.0 200"), "{version}: {answer}{words}");
        let (answer, words) = shake(&[version]);
        assert!(answer.is_empty() && words.contains("alert"), "{version} without a certificate: {answer}{words}");
    }
    // The security level is OpenSSL's own bar, which is to be out of the way of ours.
    let (answer, words) = shake(&[&own[..], &["-tls1_1", "-cipher", "DEFAULT@SECLEVEL=0"]].concat());
    assert!(answer.is_empty() && words.contains("alert"), "{answer}{words}");
}

#[test]
fn what_is_wrong_with_the_files_is_said() {
    let certificates = Certificates::new();
    std::fs::write(
        certificates.path("sealed.key"),
        "-----BEGIN ENCRYPTED PRIVATE KEY-----\nMA==\n-----END ENCRYPTED PRIVATE KEY-----\n",
    )
    .unwrap();
    std::fs::write(certificates.path("text.pem"), "no certificate\n").unwrap();
    std::fs::write(certificates.path("damaged.pem"), "-----BEGIN CERTIFICATE-----\nMAA=\n-----END CERTIFICATE-----\n")
        .unwrap();
    set_mode(&certificates.path("sealed.key"), 0o600);
    std::fs::copy(certificates.path("server.key"), certificates.path("open.key")).unwrap();
    set_mode(&certificates.path("open.key"), 0o644);
    let start = |certificate: &str, key: &str, authority: Option<&str>| {
        let mut command = orb(&certificates.data());
        command.args(["serve", "--bind", "127.0.0.1:0", "--max-marking", "UNCLASSIFIED"]);
        command.arg("--tls-cert").arg(certificates.path(certificate)).arg("--tls-key").arg(certificates.path(key));
        if let Some(authority) = authority {
            command.arg("--client-ca").arg(certificates.path(authority));
        }
        let out = command.output().unwrap();
        (out.status.code(), String::from_utf8_lossy(&out.stderr).into_owned())
    };
    for (certificate, key, authority, code, words) in [
        ("server-over.pem", "server-over.key", None, 2, "2020-01-02"),
        ("server.pem", "client.key", None, 2, "another certificate's key"),
        ("client.pem", "client.key", None, 2, "serverAuth"),
        ("server.pem", "sealed.key", None, 2, "passphrase"),
        ("server.pem", "server.pem", None, 2, "private key"),
        ("server.pem", "open.key", None, 4, "KEY_PERMISSIONS: mode 0644"),
        ("server.pem", "absent.key", None, 5, "absent.key"),
        ("absent.pem", "server.key", None, 5, "absent.pem"),
        ("server.key", "server.key", None, 2, "no PEM block of type CERTIFICATE"),
        ("text.pem", "server.key", None, 2, "no PEM block of type CERTIFICATE"),
        ("damaged.pem", "server.key", None, 2, "damaged"),
        ("server.pem", "server.key", Some("client.pem"), 2, "basicConstraints"),
        ("server.pem", "server.key", Some("text.pem"), 2, "no PEM block of type CERTIFICATE"),
    ] {
        if code == 4 && cfg!(not(unix)) {
            continue;
        }
        let found = start(certificate, key, authority);
        assert!(found.0 == Some(code) && found.1.contains(words), "{certificate} {key} {authority:?}: {found:?}");
    }
    let alone = orb(&certificates.data())
        .args(["serve", "--max-marking", "UNCLASSIFIED", "--tls-cert"])
        .arg(certificates.path("server.pem"))
        .output()
        .unwrap();
    assert_eq!(alone.status.code(), Some(2), "--tls-key is missing");
    // Beyond this machine, under TLS, without another word.
    let (certificate, key) = (certificates.text("server.pem"), certificates.text("server.key"));
    let served =
        Served::start_with(&certificates.data(), "0.0.0.0:0", &["--tls-cert", &certificate, "--tls-key", &key]);
    drop(served);
}

/// Half a handshake, none at all, nonsense: they end, and while all places are theirs others wait no longer than that.
#[test]
fn slow_handshakes_end() {
    let certificates = Certificates::new();
    account(&certificates.data(), "jane", "operator");
    let served = certificates.serve(&[]);
    let client = certificates.client("authority", None, &TLS13);
    let half = |bytes: &[u8]| {
        let mut stream = TcpStream::connect(&served.host).unwrap();
        stream.write_all(bytes).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(40))).unwrap();
        stream
    };
    let begin = Instant::now();
    let mut slow = vec![half(b""), half(b"\x16"), half(b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03")];
    assert!(ask(&served, &client, &get("/health", "orb.example")).unwrap().contains(" 200 "));
    assert!(begin.elapsed() < Duration::from_secs(5), "nobody is held up: {:?}", begin.elapsed());
    // As many as there are places.
    slow.extend((slow.len()..512).map(|_| half(b"\x16\x03\x01")));
    assert!(ask(&served, &client, &get("/health", "orb.example")).unwrap().contains(" 200 "));
    let waited = begin.elapsed();
    assert!(waited > Duration::from_secs(8) && waited < Duration::from_secs(30), "until a place was free: {waited:?}");
    for mut stream in slow {
        let ended = stream.read_to_end(&mut Vec::new());
        assert!(ended.is_ok() || ended.is_err_and(|e| e.kind() == io::ErrorKind::ConnectionReset), "it is let go");
    }
    let mut nonsense = half(&[0x16, 3, 1, 0, 4, 255, 255, 255, 255]);
    let began = Instant::now();
    let _ = nonsense.read_to_end(&mut Vec::new());
    assert!(began.elapsed() < Duration::from_secs(5), "nonsense is no handshake");
}
