use std::sync::OnceLock;

use super::*;

/// One key for all tests: making one takes a third of a second.
pub(crate) fn shared_key() -> &'static SigningKey {
    static KEY: OnceLock<SigningKey> = OnceLock::new();
    KEY.get_or_init(|| SigningKey::generate(KeySource::NamedFile).unwrap())
}

/// Another one, for signatures by somebody else.
pub(crate) fn other_key() -> &'static SigningKey {
    static KEY: OnceLock<SigningKey> = OnceLock::new();
    KEY.get_or_init(|| SigningKey::generate(KeySource::NamedFile).unwrap())
}

fn write_key_of(bits: KeySize, path: &Path) {
    let pair = KeyPair::generate(bits).unwrap();
    let der: Pkcs8V1Der<'_> = pair.as_der().unwrap();
    write_private(path, pem::encode(PRIVATE_LABEL, der.as_ref()).as_bytes()).unwrap();
}

#[test]
fn both_implementations_verify_what_was_signed() {
    let key = shared_key();
    assert_eq!(key.public().bits(), 3072);
    let sig = key.sign(b"message").unwrap();
    assert_eq!(sig.len(), 384);
    assert_eq!(sig, key.sign(b"message").unwrap(), "deterministic");
    assert_eq!(key.public().verify(b"message", &sig), Ok(true));
    assert_eq!(key.public().verify(b"massage", &sig), Ok(false));
    assert_eq!(other_key().public().verify(b"message", &sig), Ok(false));
    for i in (0..sig.len()).step_by(13) {
        let mut bad = sig.clone();
        bad[i] ^= 1;
        assert_eq!(key.public().verify(b"message", &bad), Ok(false));
    }
    for bad in [&[][..], &sig[1..], &[sig.clone(), vec![0]].concat(), &vec![0; 384], &vec![255; 384]] {
        assert_eq!(key.public().verify(b"message", bad), Ok(false));
    }
}

#[test]
fn saved_and_loaded() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("unit.pem");
    shared_key().save(&path).unwrap();
    let loaded = SigningKey::load(&path, KeySource::NamedFile).unwrap();
    assert_eq!(loaded.public(), shared_key().public());
    let public = fs::read_to_string(dir.path().join("unit.pub.pem")).unwrap();
    assert_eq!(PublicKey::from_pem(&public).unwrap(), *shared_key().public());
    let again = shared_key().save(&path).unwrap_err();
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
    let run = for_marking(&data, &Marking::SECRET, Some(&path)).unwrap();
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
