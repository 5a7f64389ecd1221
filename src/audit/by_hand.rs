//! Verification without Orb: the commands for openssl and sha256sum.

use std::path::Path;

use super::disk;
use super::publication::{RECORD, RECORD_CHAIN, RECORD_KEY, RECORD_PAE, RECORD_SIG, RECORD_STAMP, STORE_PREFIX};
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
    let digest = statement.predicate.actor.algorithm.replace("RS", "sha");
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
         # The signer's key: compare with the fingerprint that the signer told you.\n\
         openssl pkey -pubin -in {RECORD_KEY} -outform DER | sha256sum\n\
         # The signature over the record's bytes.\n\
         openssl dgst -{digest} -verify {RECORD_KEY} -signature {RECORD_SIG} {RECORD_PAE}\n\
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
