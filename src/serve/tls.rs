//! TLS for the port, where a certificate was named: rustls over AWS-LC, versions 1.2 (RFC 5246) and 1.3 (RFC 8446).
//!
//! With `--client-ca` a connection needs a certificate of one of these authorities, and with `--client-crl` one that none of
//! them revoked ([`super::clients`]). It admits the connection; who somebody is, a token says, or the certificate where it is bound to an account.
//! TLS sessions are not resumed, so that every connection's certificate is looked at.

use std::future::pending;
use std::path::{Path, PathBuf};
use std::pin::Pin;
use std::sync::Arc;
use std::time::Duration;

use pkcs8::der::Decode as _;
use rustls::crypto::aws_lc_rs::default_provider;
use rustls::server::NoServerSessionStorage;
use rustls::sign::{CertifiedKey, SingleCertAndKey};
use rustls::version::{TLS12, TLS13};
use rustls::{InconsistentKeys, RootCertStore, ServerConfig};
use rustls_pki_types::pem::PemObject as _;
use rustls_pki_types::{CertificateDer, PrivateKeyDer, ServerName};
use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::time::timeout;
use tokio_rustls::TlsAcceptor;
use tokio_rustls::server::TlsStream;
use webpki::EndEntityCert;
use x509_cert::Certificate;
use x509_cert::ext::pkix::{BasicConstraints, ExtendedKeyUsage};

use super::Server;
use super::account::Fingerprint;
use super::api::Peer;
use super::clients::Clients;
use crate::audit::canonical::sha256_hex;
use crate::audit::time::format_utc;
use crate::audit::{disk, keys, pem};
use crate::web::listen::{Entrance, Patient};
use crate::{Error, Result};

/// For all of a handshake.
const HANDSHAKE: Duration = Duration::from_secs(10);
/// The first byte of one: a record of the type handshake (RFC 8446 §5.1).
const RECORD: u8 = 22;
const LABEL: &str = "CERTIFICATE";
/// Most certificates of a file.
const MOST: usize = 64;
/// id-kp-serverAuth and anyExtendedKeyUsage, RFC 5280 §4.2.1.12.
const SERVES: [&str; 2] = ["1.3.6.1.5.5.7.3.1", "2.5.29.37.0"];
/// A certificate or a list that ends sooner is warned of.
pub(super) const SOON: u64 = 14 * 24 * 3600 * 1000;
const SAYS_HTTP: &str = "HTTP/1.0 400 Bad Request\r\nContent-Type: text/plain; charset=utf-8\r\nConnection: close\r\n\r\n\
                         this port speaks TLS: ask it by https\n";

/// The files that the command line names.
#[derive(Clone, Debug)]
pub struct Files {
    /// The server's own certificate, and those between it and its authority.
    pub certificate: PathBuf,
    pub key: PathBuf,
    /// Authorities of the clients' certificates.
    pub client_ca: Option<PathBuf>,
    /// What they revoked.
    pub client_crl: Vec<PathBuf>,
}

/// What a handshake needs.
pub struct Tls {
    config: Arc<ServerConfig>,
    /// Of the server's own certificate.
    pub certificate_sha256: String,
    /// Clients need a certificate, and this says which are good.
    pub clients: Option<Arc<Clients>>,
    /// What is not wrong, but will be.
    pub warnings: Vec<String>,
}

impl Files {
    /// Reads them. `names` are those that the server is called by, `now` in milliseconds since 1970.
    ///
    /// # Errors
    /// Environment for a file that cannot be read; usage for one that does not hold what it should, a certificate that is
    /// not good now or not for a server, a key that is another's; policy for a key that others can read.
    pub fn load(&self, names: &[String], now: u64) -> Result<Tls> {
        let subject = self.certificate.display().to_string();
        let chain = certificates(&self.certificate)?;
        let leaf = parse(&self.certificate, &chain[0])?;
        let until = good_now(&self.certificate, &leaf, now)?;
        if let Some(found) = serves_not(&leaf) {
            return Err(Error::usage(subject).expected("a server's certificate first").found(found));
        }
        let mut warnings = Vec::new();
        if until < now + SOON {
            warnings.push(format!("{subject}: the certificate is good until {} only", format_utc(until)));
        }
        let end = EndEntityCert::try_from(&chain[0])
            .map_err(|e| Error::usage(&subject).expected("a server's certificate first").found(e.to_string()))?;
        for name in names {
            let known = ServerName::try_from(name.as_str()).ok();
            if known.is_none_or(|n| end.verify_is_valid_for_subject_name(&n).is_err()) {
                warnings.push(format!(
                    "{subject}: the certificate is not for {name}, which --name says: clients refuse it"
                ));
            }
        }
        let provider = Arc::new(default_provider());
        let key = private_key(&self.key)?;
        let certificate_sha256 = sha256_hex(&chain[0]);
        let own = CertifiedKey::from_der(chain, key, &provider).map_err(|e| match e {
            rustls::Error::InconsistentKeys(InconsistentKeys::KeyMismatch) => {
                Error::usage(self.key.display().to_string())
                    .expected(format!("the key of the first certificate in {subject}"))
                    .found("another certificate's key")
            }
            other => Error::usage(self.key.display().to_string())
                .expected("an RSA, ECDSA or Ed25519 key for TLS")
                .found(other.to_string()),
        })?;
        let failed = |e: &dyn std::fmt::Display| Error::environment("TLS").found(e.to_string());
        let versions = ServerConfig::builder_with_provider(Arc::clone(&provider))
            .with_protocol_versions(&[&TLS13, &TLS12])
            .map_err(|e| failed(&e))?;
        let clients = self.client_ca.as_ref().map(|path| Clients::new(path, &self.client_crl, now)).transpose()?;
        let (verified, clients) = match clients {
            None => (versions.with_no_client_auth(), None),
            Some((clients, more)) => {
                warnings.extend(more);
                let clients = Arc::new(clients);
                (versions.with_client_cert_verifier(clients.clone()), Some(clients))
            }
        };
        let mut config = verified.with_cert_resolver(Arc::new(SingleCertAndKey::from(own)));
        config.alpn_protocols = vec![b"http/1.1".to_vec()];
        config.session_storage = Arc::new(NoServerSessionStorage {});
        config.send_tls13_tickets = 0;
        Ok(Tls { config: Arc::new(config), certificate_sha256, clients, warnings })
    }
}

/// The SHA-256 of the first certificate in a file, PEM: what an account is bound to.
///
/// # Errors
/// Environment for a file that cannot be read; usage for one without a certificate.
pub fn fingerprint(path: &Path) -> Result<Fingerprint> {
    let first = certificates(path)?.swap_remove(0);
    parse(path, &first).map(|_| Fingerprint::of(&first))
}

/// One or more, the first being what the file is for.
fn certificates(path: &Path) -> Result<Vec<CertificateDer<'static>>> {
    let wrong = |found: String| {
        Error::usage(path.display().to_string())
            .expected("certificates in PEM form, one after the other")
            .found(found)
            .advice("`openssl x509 -in OLD -out NEW.pem` converts one; an encrypted bundle: `openssl pkcs12 -nokeys`.")
    };
    let bytes = disk::read_limited(path, MOST as u64 * pem::MAX_BYTES)?;
    let text = std::str::from_utf8(&bytes).map_err(|_| wrong("bytes that are not text".into()))?;
    let all = pem::decode_all(LABEL, text).map_err(wrong)?;
    if all.len() > MOST {
        return Err(wrong(format!("{} of them; {MOST} at most are read", all.len())));
    }
    Ok(all.into_iter().map(CertificateDer::from).collect())
}

fn parse(path: &Path, der: &CertificateDer<'_>) -> Result<Certificate> {
    let wrong = |e: pkcs8::der::Error| {
        Error::usage(path.display().to_string()).expected("an X.509 certificate").found(format!("a damaged one ({e})"))
    };
    Certificate::from_der(der).map_err(wrong)
}

/// Until when, milliseconds since 1970.
fn good_now(path: &Path, certificate: &Certificate, now: u64) -> Result<u64> {
    let validity = &certificate.tbs_certificate.validity;
    let ms = |t: x509_cert::time::Time| u64::try_from(t.to_unix_duration().as_millis()).unwrap_or(u64::MAX);
    let (from, until) = (ms(validity.not_before), ms(validity.not_after));
    if (from..=until).contains(&now) {
        return Ok(until);
    }
    Err(Error::usage(path.display().to_string())
        .expected(format!("a certificate that is good now, {}", format_utc(now)))
        .found(format!("one from {} to {}", format_utc(from), format_utc(until)))
        .advice("Ask its authority for another; if this machine's clock is wrong, set it."))
}

/// Why a certificate is no server's.
fn serves_not(leaf: &Certificate) -> Option<String> {
    match leaf.tbs_certificate.get::<ExtendedKeyUsage>() {
        Err(e) => Some(format!("one that cannot be read ({e})")),
        // RFC 5280 §4.2.1.12: without the extension every usage is allowed.
        Ok(None) => None,
        Ok(Some((_, usage))) if usage.0.iter().any(|oid| SERVES.contains(&oid.to_string().as_str())) => None,
        Ok(Some(_)) => Some("one whose extended key usage leaves out serverAuth".into()),
    }
}

fn private_key(path: &Path) -> Result<PrivateKeyDer<'static>> {
    let wrong = |found: String| {
        Error::usage(path.display().to_string())
            .expected("a private key in PEM form, without a passphrase")
            .found(found)
    };
    let bytes = keys::private_file(path)?;
    // PKCS#8's own form of it, and OpenSSL's older one.
    let is_sealed = |words: &str| bytes.windows(words.len()).any(|w| w == words.as_bytes());
    if is_sealed("ENCRYPTED PRIVATE KEY") || is_sealed("Proc-Type: 4,ENCRYPTED") {
        return Err(wrong("one under a passphrase".into()).advice(
            "`openssl pkey -in OLD.pem -out NEW.pem` takes it off; only this user may read the new file (mode 0600).",
        ));
    }
    PrivateKeyDer::from_pem_slice(&bytes).map_err(|e| match e {
        rustls_pki_types::pem::Error::NoItemsFound => wrong("none".into()),
        other => wrong(other.to_string()),
    })
}

/// Authorities, good now: for verifying with, and as they stand in the file.
///
/// # Errors
/// Environment for a file that cannot be read; usage for what is no authority's certificate.
pub(super) fn authorities(path: &Path, now: u64) -> Result<(RootCertStore, Vec<CertificateDer<'static>>)> {
    let mut roots = RootCertStore::empty();
    let all = certificates(path)?;
    for der in &all {
        let certificate = parse(path, der)?;
        let name = certificate.tbs_certificate.subject.to_string();
        let no_authority = |found: String| {
            Error::usage(path.display().to_string()).expected("certificates of authorities").found(found)
        };
        let constraints =
            certificate.tbs_certificate.get::<BasicConstraints>().map_err(|e| no_authority(e.to_string()))?;
        if !constraints.is_some_and(|(_, c)| c.ca) {
            return Err(no_authority(format!("{name}, which is none (basicConstraints)")));
        }
        good_now(path, &certificate, now)?;
        roots.add(der.clone()).map_err(|e| no_authority(format!("{name}: {e}")))?;
    }
    Ok((roots, all))
}

/// The port's entrance under TLS.
#[derive(Clone)]
pub struct Door {
    acceptor: TlsAcceptor,
    clients: Option<Arc<Clients>>,
    server: Arc<Server>,
}

impl Door {
    pub fn new(tls: &Tls, server: Arc<Server>) -> Door {
        Door { acceptor: TlsAcceptor::from(Arc::clone(&tls.config)), clients: tls.clients.clone(), server }
    }

    async fn shake(&self, mut stream: Patient) -> Option<TlsStream<Patient>> {
        let mut first = [0];
        if stream.peek(&mut first).await.ok()? == 0 {
            return None;
        }
        if first[0] != RECORD {
            // Read, or closing would throw the answer away with what was not.
            let _ = stream.read(&mut [0; 4096]).await;
            let _ = stream.write_all(SAYS_HTTP.as_bytes()).await;
            let _ = stream.shutdown().await;
            return None;
        }
        let refused = match self.acceptor.accept(stream).await {
            Ok(stream) => return Some(stream),
            Err(e) => e,
        };
        let why = refused.get_ref().and_then(|e| e.downcast_ref::<rustls::Error>());
        if let Some(rustls::Error::NoCertificatesPresented | rustls::Error::InvalidCertificate(_)) = why {
            self.server.recorder.refused("", "CLIENT_CERTIFICATE", self.server.now());
        }
        None
    }
}

impl Entrance for Door {
    type Stream = TlsStream<Patient>;
    type Peer = Peer;
    type Over = Pin<Box<dyn Future<Output = ()> + Send>>;

    async fn enter(&self, stream: Patient) -> Option<(TlsStream<Patient>, Peer, Self::Over)> {
        let generation = self.clients.as_ref().map_or(0, |clients| clients.generation());
        let stream = timeout(HANDSHAKE, self.shake(stream)).await.ok().flatten()?;
        let chain = stream.get_ref().1.peer_certificates().unwrap_or_default();
        let peer = Peer(chain.first().map(|der| Fingerprint::of(der)));
        let over: Self::Over = match &self.clients {
            None => Box::pin(pending()),
            Some(clients) => {
                let mut over = clients.admit(chain, generation, &self.server.sessions)?;
                Box::pin(async move {
                    // Who would say it says it before he is gone.
                    if over.wait_for(|over| *over).await.is_err() {
                        pending().await
                    }
                })
            }
        };
        Some((stream, peer, over))
    }
}
