//! Verification without Orb: the commands for openssl and sha256sum.

use std::path::Path;

use super::disk;
use super::publication::{RECORD, RECORD_KEY, RECORD_PAE, RECORD_SIG, STORE_PREFIX};
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
         openssl dgst -sha256 -verify {RECORD_KEY} -signature {RECORD_SIG} {RECORD_PAE}\n\
         # Those bytes are the record's: two equal lines.\n\
         sed 's/.*\"payload\":\"\\([^\"]*\\)\".*/\\1/' {RECORD} | base64 -d | sha256sum\n\
         tail -c +{first} {RECORD_PAE} | sha256sum\n\
         # The trail hash: {trail_hash}\n\
         tail -c +{first} {RECORD_PAE} | sed 's/,\"trail_hash\":\"[0-9a-f]*\"//' | tr -d '\\n' | sha256sum\n\
         # Every output.\n\
         sha256sum -c <<'END'\n{sums}END\n"
    ))
}
