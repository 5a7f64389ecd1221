use std::fs;
use std::sync::OnceLock;

use aws_lc_rs::encoding::Pkcs8V1Der;

use super::file::{PRIVATE_LABEL, write_private};
use super::*;
use crate::Kind;
use crate::audit::{DataFolder, Marking};

/// One key for all tests: making one takes a third of a second.
pub(crate) fn shared_key() -> &'static SigningKey {
    static KEY: OnceLock<SigningKey> = OnceLock::new();
    KEY.get_or_init(|| SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap())
}

/// Another one, for signatures by somebody else.
pub(crate) fn other_key() -> &'static SigningKey {
    static KEY: OnceLock<SigningKey> = OnceLock::new();
    KEY.get_or_init(|| SigningKey::generate(KeySource::NamedFile, Bits::default()).unwrap())
}

fn write_key_of(bits: KeySize, path: &Path) {
    let pair = KeyPair::generate(bits).unwrap();
    let der: Pkcs8V1Der<'_> = pair.as_der().unwrap();
    write_private(path, pem::encode(PRIVATE_LABEL, der.as_ref()).as_bytes()).unwrap();
}

#[test]
fn both_implementations_verify_what_was_signed() {
    let key = shared_key();
    assert_eq!(key.public().rsa_bits(), Some(3072));
    let sig = key.sign(b"message").unwrap();
    assert_eq!(sig.len(), 384);
    assert_eq!(sig, key.sign(b"message").unwrap(), "deterministic");
    assert_eq!(key.public().verify(b"message", &sig), Ok(Some(Algorithm::Rs256)));
    assert_eq!(key.public().verify(b"massage", &sig), Ok(None));
    assert_eq!(other_key().public().verify(b"message", &sig), Ok(None));
    for i in (0..sig.len()).step_by(13) {
        let mut bad = sig.clone();
        bad[i] ^= 1;
        assert_eq!(key.public().verify(b"message", &bad), Ok(None));
    }
    for bad in [&[][..], &sig[1..], &[sig.clone(), vec![0]].concat(), &vec![0; 384], &vec![255; 384]] {
        assert_eq!(key.public().verify(b"message", bad), Ok(None));
    }
}

#[test]
fn by_sha384_too() {
    let key = SigningKey::new(Holder::Rsa(KeyPair::generate(KeySize::Rsa3072).unwrap()), KeySource::NamedFile)
        .unwrap()
        .with_algorithm(Algorithm::Rs384)
        .unwrap();
    let sig = key.sign(b"message").unwrap();
    assert_eq!(key.public().verify(b"message", &sig), Ok(Some(Algorithm::Rs384)));
    let short =
        SigningKey::new(Holder::Rsa(KeyPair::generate(KeySize::Rsa2048).unwrap()), KeySource::NamedFile).unwrap();
    assert!(short.with_algorithm(Algorithm::Rs384).unwrap_err().found.contains("ALG_REFUSED"));
}

#[test]
fn saved_and_loaded() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("unit.pem");
    shared_key().save(&path, None).unwrap();
    let loaded = SigningKey::load(&path, KeySource::NamedFile).unwrap();
    assert_eq!(loaded.public(), shared_key().public());
    let public = fs::read_to_string(dir.path().join("unit.pub.pem")).unwrap();
    assert_eq!(PublicKey::from_pem(&public).unwrap(), *shared_key().public());
    let again = shared_key().save(&path, None).unwrap_err();
    assert_eq!(again.kind, Kind::Usage);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o600);
        for mode in [0o640, 0o604, 0o660, 0o644] {
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
            let error = SigningKey::load(&path, KeySource::NamedFile).unwrap_err();
            assert_eq!(error.kind, Kind::Policy);
            assert!(error.found.contains("KEY_PERMISSIONS"));
        }
    }
}

#[test]
fn files_that_are_not_keys() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("k.pem");
    assert_eq!(SigningKey::load(&path, KeySource::NamedFile).unwrap_err().kind, Kind::Environment);
    assert_eq!(SigningKey::load(dir.path(), KeySource::NamedFile).unwrap_err().kind, Kind::Usage);
    for bytes in [&b""[..], b"\xff\xfe", shared_key().public().to_pem().as_bytes(), &[b'a'; 100_000]] {
        let _ = fs::remove_file(&path);
        write_private(&path, bytes).unwrap();
        assert_eq!(SigningKey::load(&path, KeySource::NamedFile).unwrap_err().kind, Kind::Usage);
    }
    fs::remove_file(&path).unwrap();
    write_private(&path, pem::encode(PRIVATE_LABEL, b"not DER").as_bytes()).unwrap();
    assert_eq!(SigningKey::load(&path, KeySource::NamedFile).unwrap_err().kind, Kind::Policy);
}

/// `openssl genrsa 1024 | openssl rsa -pubout`, and the same with `-3 2048`.
#[test]
fn weak_public_keys_are_refused() {
    let short = "-----BEGIN PUBLIC KEY-----
MIGfMA0GCSqGSIb3DQEBAQUAA4GNADCBiQKBgQCfa0TkGlexAS+CS3/dYr5OWmOY
l2eJGyGyvo15cpIQL64gxIEnPEiaDmrJ5pMH9fc3ScUdSddost1I0nIC7z1rIJNa
lAachNcyaBY0lZTex87MFGgB1UkasHMU953tHIHxOOAAYky3YBHADuZQPJ76cfcM
zJZONemD3G/X2ViQ0wIDAQAB
-----END PUBLIC KEY-----";
    let exponent_3 = "-----BEGIN PUBLIC KEY-----
MIIBIDANBgkqhkiG9w0BAQEFAAOCAQ0AMIIBCAKCAQEA228wjqG+fll9H5IPnSs2
D4E0zQWqd3v9TiZuwa6OGbRP/PhTNZA/1jgzrtPfflK8yM8t2rcZR8u1tKJzLCmY
DaY0mxx4HNQH6lYPQjhoJq0ahNqsoPsQkUSAVXoV/iZJBqikoHwVOrJF0Gau2W6W
BMkC7mu5Wxq99L1IJ1qxfgoSKcyyvcZa8gERpDKwVMzPjKs1wGZ+QGgNg6A3eAu9
Lw53jkeyd+7WRRvR/FuXcM84Ga2fEGOew/61+wytYVFdeVjiE0E8kLuGjXiqhodm
Sd0++fuyUxgbDF/ezLcH9SXA9h2lSRcCsgc21YFMJQ1ajPNRgDRzb/QMVDZiobZH
ZQIBAw==
-----END PUBLIC KEY-----";
    assert!(PublicKey::from_pem(short).unwrap_err().contains("1024 bits"));
    assert!(PublicKey::from_pem(exponent_3).unwrap_err().contains("exponent 3"));
}

#[test]
fn a_short_key_is_warned_about() {
    let dir = tempfile::tempdir().unwrap();
    let data = DataFolder::at(dir.path().join("data"));
    let path = dir.path().join("k.pem");
    write_key_of(KeySize::Rsa2048, &path);
    let run = for_marking(&data, &Marking::SECRET, Some(path.as_path().into())).unwrap();
    assert!(run.warning.unwrap().contains("2048 bits"));
    assert!(!run.created);
}

#[test]
fn above_unclassified_a_key_must_be_named() {
    let dir = tempfile::tempdir().unwrap();
    let data = DataFolder::at(dir.path().join("data"));
    for marking in [Marking::CUI, Marking::SECRET, Marking::TOP_SECRET] {
        let error = for_marking(&data, &marking, None).unwrap_err();
        assert_eq!(error.kind, Kind::Policy);
        assert!(error.found.contains("KEY_REQUIRED"));
    }
    assert!(!data.path().exists(), "a refusal leaves nothing behind");
}

#[test]
fn first_runs_at_once_make_one_key() {
    let dir = tempfile::tempdir().unwrap();
    let data = DataFolder::at(dir.path().join("data"));
    let runs: Vec<KeyForRun> = std::thread::scope(|scope| {
        let threads: Vec<_> =
            (0..4).map(|_| scope.spawn(|| for_marking(&data, &Marking::UNCLASSIFIED, None).unwrap())).collect();
        threads.into_iter().map(|t| t.join().unwrap()).collect()
    });
    assert_eq!(runs.iter().filter(|r| r.created).count(), 1);
    assert!(runs.iter().all(|r| r.key.public() == runs[0].key.public()));
    let trusted = crate::audit::trust::TrustStore::load(&data, &[]).unwrap();
    assert!(trusted.get(runs[0].key.public().fingerprint()).is_some());
}

struct Words(&'static str);

impl Passphrase for Words {
    fn read(&self) -> Result<Zeroizing<String>> {
        Ok(Zeroizing::new(self.0.to_owned()))
    }
}

#[test]
fn keys_under_a_passphrase() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("sealed.pem");
    shared_key().save(&path, Some("correct horse")).unwrap();
    assert!(fs::read_to_string(&path).unwrap().starts_with("-----BEGIN ENCRYPTED PRIVATE KEY-----"));
    let load = |words: Option<&'static str>| {
        let words = words.map(Words);
        let passphrase = words.as_ref().map(|w| w as &dyn Passphrase);
        SigningKey::load(Named { passphrase, ..Named::from(&path) }, KeySource::NamedFile)
    };
    assert_eq!(load(Some("correct horse")).unwrap().public(), shared_key().public());
    assert!(load(None).unwrap_err().found.contains("PASSPHRASE_REQUIRED"));
    for wrong in ["", "correct horses"] {
        let error = load(Some(wrong)).unwrap_err();
        assert!(error.kind == Kind::Policy && error.found.contains("PASSPHRASE_REFUSED"), "{error}");
    }
    // OpenSSL reads it, and Orb reads OpenSSL's, with scrypt too.
    let openssl = |args: &[&str]| {
        let done = std::process::Command::new("openssl").args(args).current_dir(dir.path()).output();
        match done {
            Ok(done) => {
                assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
                true
            }
            Err(_) => {
                assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: openssl is not installed");
                eprintln!("skipped: openssl is not installed");
                false
            }
        }
    };
    let words = "pass:correct horse";
    if !openssl(&["pkcs8", "-in", "sealed.pem", "-passin", words, "-out", "open.pem"]) {
        return;
    }
    for (name, how) in [("pbkdf2.pem", &["-v2", "aes-256-cbc"][..]), ("scrypt.pem", &["-scrypt"])] {
        let args = ["pkcs8", "-topk8", "-in", "open.pem", "-passout", words, "-out", name];
        openssl(&[&args[..], how].concat());
        let path = dir.path().join(name);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
        }
        let named = Named { passphrase: Some(&Words("correct horse")), ..Named::from(&path) };
        assert_eq!(SigningKey::load(named, KeySource::NamedFile).unwrap().public(), shared_key().public(), "{name}");
    }
}

#[test]
fn a_passphrase_stands_on_the_first_line_of_a_private_file() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("words");
    write_private(&path, b"correct horse\nbattery\n").unwrap();
    assert_eq!(passphrase_file(&path).unwrap().as_str(), "correct horse");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        fs::set_permissions(&path, fs::Permissions::from_mode(0o644)).unwrap();
        assert!(passphrase_file(&path).unwrap_err().found.contains("KEY_PERMISSIONS"));
    }
}

/// Google's Project Wycheproof, RSASSA-PKCS1-v1_5 with SHA-256 and SHA-384: every valid signature under an acceptable key is taken, no
/// invalid one is, and those that leave a parameter out are taken by neither rule nor accident.
#[test]
fn wycheproof_vectors() {
    use wycheproof::TestResult;
    use wycheproof::rsa_pkcs1_verify::{TestName, TestSet};
    let (mut taken, mut refused) = (0, 0);
    let sets = [
        (TestName::Rsa2048Sha256, Algorithm::Rs256),
        (TestName::Rsa3072Sha256, Algorithm::Rs256),
        (TestName::Rsa4096Sha256, Algorithm::Rs256),
        (TestName::Rsa2048Sha384, Algorithm::Rs384),
        (TestName::Rsa3072Sha384, Algorithm::Rs384),
        (TestName::Rsa4096Sha384, Algorithm::Rs384),
    ];
    for (name, algorithm) in sets {
        for group in &TestSet::load(name).unwrap().test_groups {
            let key = PublicKey::from_spki(&group.der);
            for test in &group.tests {
                let verified = key.as_ref().map(|k| k.verify_by(algorithm, &test.msg, &test.sig));
                match (test.result, verified) {
                    (TestResult::Valid, Ok(verified)) => {
                        assert_eq!(verified, Ok(true), "{name:?} {}", test.tc_id)
                    }
                    (TestResult::Valid, Err(why)) => {
                        assert!(why.contains("exponent"), "{name:?} {}: {why}", test.tc_id)
                    }
                    (TestResult::Invalid | TestResult::Acceptable, Ok(verified)) => {
                        // By both implementations: an `Err` says that they disagree.
                        assert_eq!(verified, Ok(false), "{name:?} {}: {}", test.tc_id, test.comment);
                        refused += 1;
                    }
                    (TestResult::Invalid | TestResult::Acceptable, Err(_)) => refused += 1,
                }
                taken += usize::from(test.result == TestResult::Valid && key.is_ok());
            }
        }
    }
    assert!(taken > 40 && refused > 1200, "{taken} {refused}");
}
