//! Verification without Orb: the commands for openssl and sha256sum.

use std::path::Path;

use super::disk;
use super::publication::{
    RECORD, RECORD_CHAIN, RECORD_KEY, RECORD_KEY_2, RECORD_PAE, RECORD_SIG, RECORD_SIG_2, RECORD_STAMP, STORE_PREFIX,
};
use super::time;
use super::verify::read_record;
use crate::Result;

/// Commands that repeat the main checks with openssl and sha256sum, without Orb.
///
/// # Errors
/// As [`read_record`].
pub fn openssl_commands(folder: &Path) -> Result<String> {
    let (envelope, statement) = read_record(folder)?;
    let quoted = format!("'{}'", folder.display().to_string().replace('\'', r"'\''"));
    let first = envelope.pae().len() - envelope.payload.len() + 1;
    let trail_hash = statement.predicate.trail_hash.as_deref().unwrap_or_default();
    let actor = &statement.predicate.actor;
    let mut signatures = signature(&actor.algorithm, RECORD_KEY, RECORD_SIG);
    if let Some(other) = actor.co_signers.iter().flatten().next() {
        signatures.push_str(&signature(&other.algorithm, RECORD_KEY_2, RECORD_SIG_2));
    }
    let mut others = String::new();
    if folder.join(RECORD_CHAIN).is_file() {
        let at = time::parse_utc(&statement.predicate.time.utc).unwrap_or_default() / 1000;
        others.push_str(&format!(
            "# The signer's certificate at the time of signing; get AUTHORITY.pem from the authority. Then the same key twice.\n\
             openssl verify -attime {at} -CAfile AUTHORITY.pem -untrusted {RECORD_CHAIN} -purpose any {RECORD_CHAIN}\n\
             openssl x509 -in {RECORD_CHAIN} -noout -pubkey | openssl pkey -pubin -outform DER | sha256sum\n"
        ));
    }
    if folder.join(RECORD_STAMP).is_file() {
        others.push_str(&format!(
            "# The time stamp; get TSA-AUTHORITY.pem from the authority.\n\
             openssl ts -verify -data {RECORD} -in {RECORD_STAMP} -CAfile TSA-AUTHORITY.pem\n"
        ));
    }
    let mut sums = String::new();
    for subject in statement.subject.iter().filter(|s| !s.name.starts_with(STORE_PREFIX)) {
        // A name that a shell or sha256sum could read in another way is left to Orb's own verification.
        if disk::check_name(&subject.name).is_ok() {
            sums.push_str(&format!("{}  {}\n", subject.digest.sha256, subject.name));
        }
    }
    Ok(format!(
        "cd {quoted}\n\
         {signatures}\
         # Those bytes are the record's: two equal lines.\n\
         sed 's/.*\"payload\":\"\\([^\"]*\\)\".*/\\1/' {RECORD} | base64 -d | sha256sum\n\
         tail -c +{first} {RECORD_PAE} | sha256sum\n\
         # The trail hash: {trail_hash}\n\
         tail -c +{first} {RECORD_PAE} | sed 's/,\"trail_hash\":\"[0-9a-f]*\"//' | tr -d '\\n' | sha256sum\n\
         {others}\
         # Every output.\n\
         sha256sum -c <<'END'\n{sums}END\n"
    ))
}

/// The commands for one signature over the record's bytes and its key.
fn signature(algorithm: &str, key: &str, sig: &str) -> String {
    let verify = match algorithm.strip_prefix("RS") {
        Some(bits) => format!("openssl dgst -sha{bits} -verify {key} -signature {sig} {RECORD_PAE}"),
        None => format!("openssl pkeyutl -verify -pubin -inkey {key} -rawin -in {RECORD_PAE} -sigfile {sig}"),
    };
    let needs = if algorithm.starts_with("RS") { String::new() } else { format!(" {algorithm} needs OpenSSL 3.5.") };
    format!(
        "# The signer's key: compare with the fingerprint that the signer told you.{needs}\n\
         openssl pkey -pubin -in {key} -outform DER | sha256sum\n\
         # The signature over the record's bytes.\n\
         {verify}\n"
    )
}
