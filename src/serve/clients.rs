//! Clients' certificates: which are good now, and who is here with one.
//!
//! The authorities of `--client-ca` are read at the start, the lists of `--client-crl` also whenever their files change. What
//! is wrong with new lists is said, and those before stay in force; good ones hold for new connections, and end those of
//! certificates that are no longer good, and their sessions.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError, RwLock};

use rustls::client::danger::HandshakeSignatureValid;
use rustls::crypto::CryptoProvider;
use rustls::crypto::aws_lc_rs::default_provider;
use rustls::server::WebPkiClientVerifier;
use rustls::server::danger::{ClientCertVerified, ClientCertVerifier};
use rustls::{DigitallySignedStruct, DistinguishedName, RootCertStore, SignatureScheme};
use rustls_pki_types::{CertificateDer, UnixTime};
use tokio::sync::watch;

use super::account::Fingerprint;
use super::revocation::{Lists, Stamp, stamp};
use super::session::Sessions;
use super::{Server, lock, tls};
use crate::{Error, Result};

/// Certificates that are kept in mind before those that are gone are forgotten.
const MOST: usize = 1024;

/// What decides now.
#[derive(Clone)]
struct InForce {
    verifier: Arc<dyn ClientCertVerifier>,
    lists: Arc<Lists>,
    /// How often the lists were exchanged.
    generation: u64,
}

/// A certificate by which somebody is here.
struct Admitted {
    chain: Vec<CertificateDer<'static>>,
    /// Tells its connections, which listen, that they are over.
    over: watch::Sender<bool>,
}

/// What was seen of the files.
struct Seen {
    last: Vec<Option<Stamp>>,
    read: Vec<Option<Stamp>>,
    /// What is said once: that the ledger did not take it, that a list is out of date.
    said_unrecorded: bool,
    said_over: bool,
}

pub struct Clients {
    roots: Arc<RootCertStore>,
    hints: Vec<DistinguishedName>,
    authorities: Vec<CertificateDer<'static>>,
    files: Vec<PathBuf>,
    in_force: RwLock<InForce>,
    admitted: Mutex<BTreeMap<Fingerprint, Admitted>>,
    seen: Mutex<Seen>,
}

impl fmt::Debug for Clients {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Clients").field("files", &self.files).finish_non_exhaustive()
    }
}

fn provider() -> Arc<CryptoProvider> {
    Arc::new(default_provider())
}

fn verifier(roots: &Arc<RootCertStore>, lists: &Lists) -> Result<Arc<dyn ClientCertVerifier>> {
    let mut verifier = WebPkiClientVerifier::builder_with_provider(Arc::clone(roots), provider());
    if !lists.is_empty() {
        // A list that is out of date says nothing any more: then nobody comes in.
        verifier = verifier.with_crls(lists.ders()).enforce_revocation_expiration();
    }
    verifier.build().map_err(|e| Error::usage("--client-crl").expected("lists that TLS can use").found(e.to_string()))
}

fn is_good(verifier: &dyn ClientCertVerifier, chain: &[CertificateDer<'_>]) -> bool {
    let Some((own, between)) = chain.split_first() else { return false };
    verifier.verify_client_cert(own, between, UnixTime::now()).is_ok()
}

impl Clients {
    /// Reads the files. `now` in milliseconds since 1970. With what is not wrong, but will be.
    ///
    /// # Errors
    /// As [`tls::authorities`] and [`Lists::read`].
    pub fn new(authorities: &Path, files: &[PathBuf], now: u64) -> Result<(Clients, Vec<String>)> {
        let seen: Vec<_> = files.iter().map(stamp).collect();
        let (roots, authorities) = tls::authorities(authorities, now)?;
        let roots = Arc::new(roots);
        let (lists, warnings) = Lists::read(files, &authorities, now)?;
        let in_force = InForce { verifier: verifier(&roots, &lists)?, lists: Arc::new(lists), generation: 0 };
        let clients = Clients {
            hints: roots.subjects(),
            roots,
            authorities,
            files: files.to_owned(),
            in_force: RwLock::new(in_force),
            admitted: Mutex::default(),
            seen: Mutex::new(Seen { last: seen.clone(), read: seen, said_unrecorded: false, said_over: false }),
        };
        Ok((clients, warnings))
    }

    fn in_force(&self) -> InForce {
        self.in_force.read().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// For [`Clients::admit`]: from before the handshake.
    pub fn generation(&self) -> u64 {
        self.in_force().generation
    }

    /// Takes in who has shown this chain, in a handshake that began at this generation. What is returned becomes true when
    /// the certificate is good no longer; `None` if that is so already.
    pub fn admit(
        &self,
        chain: &[CertificateDer<'_>],
        generation: u64,
        sessions: &Sessions,
    ) -> Option<watch::Receiver<bool>> {
        let over = {
            let mut admitted = lock(&self.admitted);
            if admitted.len() >= MOST {
                forget(&mut admitted, sessions);
            }
            let entry = admitted.entry(Fingerprint::of(chain.first()?)).or_insert_with(|| Admitted {
                chain: chain.iter().map(|c| c.clone().into_owned()).collect(),
                over: watch::channel(false).0,
            });
            entry.over.subscribe()
        };
        // Lists that were exchanged since have looked at who was here before.
        let now = self.in_force();
        (now.generation == generation || is_good(now.verifier.as_ref(), chain)).then_some(over)
    }

    /// Reads the lists again where their files have changed, and rest: one that is being written is waited for. To be called
    /// every second or so.
    pub fn look(&self, server: &Server) {
        let now = server.now();
        let mut seen = lock(&self.seen);
        let before = self.in_force();
        if before.lists.until().is_some_and(|until| until <= now) && !seen.said_over {
            seen.said_over = true;
            eprintln!("orb: warning: a revocation list is out of date: no client comes in until there is a new one");
        }
        let stamps: Vec<_> = self.files.iter().map(stamp).collect();
        let rest = seen.last == stamps;
        seen.last = stamps;
        if !rest || seen.read == seen.last {
            return;
        }
        let read = Lists::read(&self.files, &self.authorities, now).and_then(|(lists, warnings)| {
            lists.follow(&before.lists)?;
            Ok((verifier(&self.roots, &lists)?, lists, warnings))
        });
        match read {
            Ok((_, lists, _)) if lists.sha256() == before.lists.sha256() => {}
            Ok((verifier, lists, warnings)) => {
                let gone = lock(&self.admitted).values().filter(|a| !is_good(verifier.as_ref(), &a.chain)).count();
                let about = [
                    ("lists", lists.len().to_string()),
                    ("lists_sha256", lists.sha256()),
                    ("certificates_ended", gone.to_string()),
                ];
                let about = about.each_ref().map(|(name, value)| (*name, value.as_str()));
                if let Err(e) = server.recorder.act("serve.revocation", &about) {
                    if !seen.said_unrecorded {
                        eprintln!("orb: warning: new revocation lists wait until the ledger takes it: {e}");
                    }
                    seen.said_unrecorded = true;
                    return;
                }
                let in_force = InForce { verifier, lists: Arc::new(lists), generation: before.generation + 1 };
                *self.in_force.write().unwrap_or_else(PoisonError::into_inner) = in_force.clone();
                self.end(in_force.verifier.as_ref(), &server.sessions);
                eprintln!(
                    "orb: revocation lists were read again; {gone} certificates that were here are good no longer"
                );
                warnings.iter().for_each(|w| eprintln!("orb: warning: {w}"));
                seen.said_over = false;
            }
            Err(e) => {
                eprintln!("orb: warning: new revocation lists are not taken, those before stay in force: {e}");
                let failed = server.recorder.failed("serve.revocation", "REVOCATION_LIST", &[("found", &e.found)]);
                if let Err(e) = failed {
                    eprintln!("orb: warning: that was not recorded: {e}");
                }
            }
        }
        seen.said_unrecorded = false;
        seen.read = seen.last.clone();
    }

    /// Ends the connections and sessions of certificates that are good no longer.
    fn end(&self, verifier: &dyn ClientCertVerifier, sessions: &Sessions) {
        let mut admitted = lock(&self.admitted);
        forget(&mut admitted, sessions);
        admitted.retain(|fingerprint, a| {
            let good = is_good(verifier, &a.chain);
            if !good {
                a.over.send_replace(true);
                sessions.end_all_by(fingerprint);
            }
            good
        });
    }
}

/// Forgets those who have no connection and no session.
fn forget(admitted: &mut BTreeMap<Fingerprint, Admitted>, sessions: &Sessions) {
    admitted.retain(|fingerprint, a| a.over.receiver_count() > 0 || sessions.are_by(fingerprint));
}

/// As what is in force decides; how handshakes are signed does not depend on it.
impl ClientCertVerifier for Clients {
    fn root_hint_subjects(&self) -> &[DistinguishedName] {
        &self.hints
    }

    fn verify_client_cert(
        &self,
        end_entity: &CertificateDer<'_>,
        intermediates: &[CertificateDer<'_>],
        now: UnixTime,
    ) -> Result<ClientCertVerified, rustls::Error> {
        self.in_force().verifier.verify_client_cert(end_entity, intermediates, now)
    }

    fn verify_tls12_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signature: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        self.in_force().verifier.verify_tls12_signature(message, certificate, signature)
    }

    fn verify_tls13_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signature: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, rustls::Error> {
        self.in_force().verifier.verify_tls13_signature(message, certificate, signature)
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        self.in_force().verifier.supported_verify_schemes()
    }
}
