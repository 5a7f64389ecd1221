//! Signing in by a client certificate on the page of `orb serve --client-ca`, in a headless Chromium. Without Chromium that
//! part says so and passes; under ORB_REQUIRE_CLIENTS=1 it fails.
//!
//! The browser has no certificate itself: a bridge before the server has, which speaks TLS to either side.
#![cfg(all(feature = "serve", unix))]

use std::sync::Arc;

use crate::browser::Browser;
use crate::certified::{Certificates, ask, get, stop};
use crate::served::{Served, account, orb};
use rustls::ServerConfig;
use rustls::crypto::aws_lc_rs::default_provider;
use rustls::pki_types::pem::PemObject as _;
use rustls::pki_types::{CertificateDer, PrivateKeyDer, ServerName};
use rustls::version::TLS13;
use tokio::io::{AsyncWriteExt as _, copy_bidirectional};
use tokio::net::{TcpListener, TcpStream};
use tokio_rustls::{TlsAcceptor, TlsConnector};

const BUTTON: &str = "Sign in by certificate";

#[test]
fn who_comes_without_a_certificate_sees_nothing_of_it() {
    let certificates = Certificates::new();
    account(&certificates.data(), "jane", "operator");
    let (authority, own) =
        (certificates.text("authority.pem"), certificates.client("authority", Some("client"), &TLS13));
    // TLS, and no certificate asked for: also of a browser that would have one.
    let served = certificates.serve(&[]);
    let page = ask(&served, &own, &get("/", "orb.example")).unwrap();
    assert!(page.contains("Sign in") && !page.contains(BUTTON) && !page.contains("{{"), "{page}");
    drop(served);
    let served = Served::start(&certificates.data(), "127.0.0.1:0");
    let (_, page) = served.ask("GET", "/", "");
    let page = String::from_utf8(page).unwrap();
    assert!(page.contains("Sign in") && !page.contains(BUTTON) && !page.contains("{{"), "{page}");
    drop(served);
    // With one: whoever's it is.
    let served = certificates.serve(&["--client-ca", &authority]);
    for name in ["client", "client-two"] {
        let page =
            ask(&served, &certificates.client("authority", Some(name), &TLS13), &get("/", "orb.example")).unwrap();
        assert!(page.contains(BUTTON) && !page.contains("{{"), "{page}");
    }
}

/// Where a browser reaches the server as who has this certificate.
fn bridge(certificates: &Certificates, served: &Served, own: &str) -> String {
    let connector = TlsConnector::from(certificates.client("authority", Some(own), &TLS13));
    let chain = vec![CertificateDer::from_pem_file(certificates.path("server.pem")).unwrap()];
    let key = PrivateKeyDer::from_pem_file(certificates.path("server.key")).unwrap();
    let config = ServerConfig::builder_with_provider(Arc::new(default_provider()))
        .with_protocol_versions(&[&TLS13])
        .unwrap()
        .with_no_client_auth()
        .with_single_cert(chain, key)
        .unwrap();
    let (acceptor, host) = (TlsAcceptor::from(Arc::new(config)), served.host.clone());
    let (send, bound) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        runtime.block_on(async {
            let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
            send.send(listener.local_addr().unwrap()).unwrap();
            loop {
                let (stream, _) = listener.accept().await.unwrap();
                let (acceptor, connector, host) = (acceptor.clone(), connector.clone(), host.clone());
                tokio::spawn(async move {
                    let Ok(mut browser) = acceptor.accept(stream).await else { return };
                    let name = ServerName::try_from("orb.example").unwrap();
                    let stream = TcpStream::connect(host).await.unwrap();
                    let mut server = connector.connect(name, stream).await.unwrap();
                    let _ = copy_bidirectional(&mut browser, &mut server).await;
                    let _ = browser.shutdown().await;
                });
            }
        });
    });
    format!("https://{}/", bound.recv().unwrap())
}

#[test]
fn a_button_signs_in_who_comes_with_a_certificate() {
    let certificates = Certificates::new();
    let data = certificates.data();
    account(&data, "jane", "operator");
    let bound =
        orb(&data).args(["serve", "account", "bind", "jane", &certificates.text("client.pem")]).status().unwrap();
    assert!(bound.success());
    let mut served = certificates.serve(&["--client-ca", &certificates.text("authority.pem")]);
    let folder = tempfile::tempdir().unwrap();
    let options = ["--disable-gpu", "--ignore-certificate-errors"];
    let Some(mut browser) = Browser::start_with(folder.path(), &options) else { return };
    browser.size(1280, 900, 1.0, false);
    browser.open(&bridge(&certificates, &served, "client"));
    browser.until(
        "!document.getElementById('signin').hidden && document.getElementById('by-certificate').checkVisibility()",
    );
    browser.picture("serve-certificate");
    // By keys: it is after the token's own button.
    browser.until("document.activeElement.id === 'token'");
    browser.key("Tab");
    browser.key("Tab");
    browser.until("document.activeElement.id === 'by-certificate'");
    browser.key("Enter");
    browser.until("!document.getElementById('submit').hidden");
    let who = browser.value("document.getElementById('who').firstElementChild.textContent");
    assert!(who.starts_with("jane (operator)"), "{who}");
    // The session is kept, and ended.
    browser.value("(window.before = true, '')");
    browser.reload();
    browser.until(
        "!window.before && !document.getElementById('submit').hidden && document.getElementById('signin').hidden",
    );
    browser.value("(document.getElementById('out').click(), '')");
    browser.until(
        "!document.getElementById('signin').hidden && document.getElementById('by-certificate').checkVisibility()",
    );
    // Of the right authority, and bound to nobody.
    browser.value("(window.before = true, '')");
    browser.open(&bridge(&certificates, &served, "client-two"));
    browser.until("!window.before && document.getElementById('by-certificate').checkVisibility()");
    browser.value("(document.getElementById('by-certificate').click(), '')");
    browser.until("document.getElementById('state').textContent.startsWith('This certificate signs nobody in')");
    browser.picture("serve-certificate-unknown");
    assert_eq!(browser.value("String(document.getElementById('submit').hidden)"), "true");
    let complaints: Vec<String> = browser.complaints().into_iter().filter(|c| !c.contains("401")).collect();
    assert!(complaints.is_empty(), "{complaints:#?}");
    drop(browser);
    let events = stop(&mut served, &certificates);
    for (kind, about) in
        [("session.begin", "account=jane"), ("session.end", "account=jane"), ("access.refused", "CERTIFICATE_UNKNOWN")]
    {
        assert!(events.lines().any(|l| l.contains(kind) && l.contains(about)), "{kind} {about} in {events}");
    }
}
