//! Revocation lists (RFC 5280 §5) of the authorities whose clients are let in.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use pkcs8::der::asn1::{AnyRef, BitStringRef};
use pkcs8::der::{Decode as _, Encode as _};
use rustls::crypto::aws_lc_rs::default_provider;
use rustls_pki_types::{CertificateDer, CertificateRevocationListDer};
use webpki::EndEntityCert;
use x509_cert::Certificate;
use x509_cert::crl::CertificateList;
use x509_cert::name::Name;

use super::tls::SOON;
use crate::audit::canonical::sha256_hex;
use crate::audit::time::format_utc;
use crate::audit::{disk, pem};
use crate::{Error, Result};

/// Largest file, bytes.
const MOST_BYTES: u64 = 16 << 20;
const LABEL: &str = "X509 CRL";

/// One list.
struct List {
    der: Vec<u8>,
    issuer: Name,
    /// Milliseconds since 1970.
    from: u64,
    until: u64,
}

/// All that were read together.
pub struct Lists(Vec<List>);

impl Lists {
    /// Reads files of lists, PEM, each good at `now` (milliseconds since 1970). One of an authority among `authorities` has to be
    /// signed by it; of the others, which stand between these and a client, the handshake decides. With what is not wrong, but
    /// will be.
    ///
    /// # Errors
    /// Environment for a file that cannot be read; usage for what is no list, is out of date, or is signed by somebody else.
    pub fn read(paths: &[PathBuf], authorities: &[CertificateDer<'static>], now: u64) -> Result<(Lists, Vec<String>)> {
        let (mut all, mut warnings) = (Vec::new(), Vec::new());
        for path in paths {
            let bytes = disk::read_limited(path, MOST_BYTES)?;
            let text = std::str::from_utf8(&bytes).map_err(|_| no_list(path, "bytes that are not text"))?;
            for der in pem::decode_all(LABEL, text).map_err(|e| no_list(path, e))? {
                let list = List::parse(path, der, now)?;
                let known: Vec<_> =
                    authorities.iter().filter(|a| subject(a).is_some_and(|s| s == list.issuer)).collect();
                if known.is_empty() {
                    warnings.push(format!(
                        "{}: a list of {}, whom --client-ca does not name",
                        path.display(),
                        list.issuer
                    ));
                } else if !known.iter().any(|authority| list.is_signed_by(authority)) {
                    return Err(Error::usage(path.display().to_string())
                        .expected(format!("a list signed by {}, as --client-ca knows it", list.issuer))
                        .found("another's signature under its name")
                        .advice("Ask the authority for its list; nobody else's word counts."));
                }
                if list.until < now + SOON {
                    let until = format_utc(list.until);
                    warnings.push(format!("{}: good until {until} only; then nobody comes in", path.display()));
                }
                all.push(list);
            }
        }
        Ok((Lists(all), warnings))
    }

    /// Whether these may take the place of those `before`: every authority that had a list has one that is no older.
    ///
    /// # Errors
    /// Usage, naming the authority.
    pub fn follow(&self, before: &Lists) -> Result<()> {
        for old in &before.0 {
            let newest = self.0.iter().filter(|l| l.issuer == old.issuer).map(|l| l.from).max();
            let expected = format!("a list of {} from {} or later", old.issuer, format_utc(old.from));
            let wrong = |found: String| {
                Err(Error::usage("--client-crl")
                    .expected(expected.clone())
                    .found(found)
                    .advice("If it is meant, start the server again: then the files count as they are."))
            };
            match newest {
                None => return wrong("none".into()),
                Some(from) if from < old.from => return wrong(format!("one from {}", format_utc(from))),
                Some(_) => {}
            }
        }
        Ok(())
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub fn sha256(&self) -> String {
        sha256_hex(&self.0.iter().flat_map(|l| l.der.iter().copied()).collect::<Vec<u8>>())
    }

    /// Until when all are good; `None` without any.
    pub fn until(&self) -> Option<u64> {
        self.0.iter().map(|l| l.until).min()
    }

    pub fn ders(&self) -> Vec<CertificateRevocationListDer<'static>> {
        self.0.iter().map(|l| l.der.clone().into()).collect()
    }
}

fn no_list(path: &Path, found: impl Into<String>) -> Error {
    Error::usage(path.display().to_string())
        .expected("revocation lists (X509 CRL) in PEM form, one after the other")
        .found(found)
        .advice("`openssl crl -inform DER -in OLD -out NEW.pem` converts one.")
}

impl List {
    fn parse(path: &Path, der: Vec<u8>, now: u64) -> Result<List> {
        let list = CertificateList::from_der(&der).map_err(|e| no_list(path, format!("a damaged one ({e})")))?;
        let ms = |t: x509_cert::time::Time| u64::try_from(t.to_unix_duration().as_millis()).unwrap_or(u64::MAX);
        let next = list.tbs_cert_list.next_update.map(ms);
        let until = next.ok_or_else(|| no_list(path, "one that does not say until when it is good (nextUpdate)"))?;
        if until <= now {
            return Err(Error::usage(path.display().to_string())
                .expected(format!("a list that is good now, {}", format_utc(now)))
                .found(format!("one that was good until {}", format_utc(until)))
                .advice("Ask its authority for the next one."));
        }
        Ok(List { der, issuer: list.tbs_cert_list.issuer, from: ms(list.tbs_cert_list.this_update), until })
    }

    /// RFC 5280 §5.1.1.3: the signature is over the first part as it stands in the file.
    fn is_signed_by(&self, authority: &CertificateDer<'_>) -> bool {
        let Ok(parts) = Vec::<AnyRef<'_>>::from_der(&self.der) else { return false };
        let [tbs, algorithm, signature] = parts[..] else { return false };
        let (Ok(message), Ok(signature)) = (tbs.to_der(), signature.decode_as::<BitStringRef<'_>>()) else {
            return false;
        };
        let (Some(signature), Ok(authority)) = (signature.as_bytes(), EndEntityCert::try_from(authority)) else {
            return false;
        };
        default_provider()
            .signature_verification_algorithms
            .all
            .iter()
            .filter(|a| a.signature_alg_id().as_ref() == algorithm.value())
            .any(|a| authority.verify_signature(*a, &message, signature).is_ok())
    }
}

fn subject(certificate: &CertificateDer<'_>) -> Option<Name> {
    Certificate::from_der(certificate).ok().map(|c| c.tbs_certificate.subject)
}

/// What tells that a file is another: when it was changed, how long it is, and which it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    changed: Option<SystemTime>,
    bytes: u64,
    inode: [i64; 3],
}

/// `None` for a file that is not there.
pub fn stamp(path: &PathBuf) -> Option<Stamp> {
    let about = std::fs::metadata(path).ok()?;
    #[cfg(unix)]
    let inode = {
        use std::os::unix::fs::MetadataExt as _;
        [about.ino().cast_signed(), about.ctime(), about.ctime_nsec()]
    };
    #[cfg(not(unix))]
    let inode = [0; 3];
    Some(Stamp { changed: about.modified().ok(), bytes: about.len(), inode })
}
