//! ML-DSA-87 and hybrid signers; in a FIPS build, their refusal.

use std::fs;
use std::path::{Path, PathBuf};

use super::*;
use crate::Kind;

fn vector(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/vectors/ml-dsa").join(name)
}

#[cfg(feature = "fips")]
#[test]
fn a_fips_build_says_why_not() {
    for suite in [Suite::Cnsa2, Suite::Hybrid] {
        let error = SigningKey::generate_for(suite, KeySource::NamedFile, Bits::default()).unwrap_err();
        assert!(error.kind == Kind::Policy && error.found.contains("FIPS module"), "{error}");
    }
    let public = fs::read_to_string(vector("leaf.pub.pem")).unwrap();
    assert!(PublicKey::from_pem(&public).unwrap_err().contains("FIPS module"));
}

#[cfg(not(feature = "fips"))]
mod ml_dsa {
    use std::sync::OnceLock;

    use super::*;
    use crate::audit::keys::file::{PRIVATE_LABEL, write_private};
    use crate::audit::keys::tests::{other_key, shared_key};

    fn key(suite: Suite) -> SigningKey {
        SigningKey::generate_for(suite, KeySource::NamedFile, Bits::default()).unwrap()
    }

    /// One hybrid signer for all tests.
    pub(crate) fn pair() -> &'static SigningKey {
        static KEY: OnceLock<SigningKey> = OnceLock::new();
        KEY.get_or_init(|| key(Suite::Hybrid))
    }

    #[test]
    fn both_implementations_verify_what_was_signed() {
        let key = key(Suite::Cnsa2);
        assert_eq!((key.public().kind().as_str(), key.algorithm().name()), ("ML-DSA-87", "ML-DSA-87"));
        let sig = key.sign(b"message").unwrap();
        // FIPS 204, table 2.
        assert_eq!(sig.len(), 4627);
        assert_eq!(key.public().verify(b"message", &sig), Ok(Some(Algorithm::MlDsa87)));
        assert_eq!(key.public().verify(b"massage", &sig), Ok(None));
        assert_eq!(pair().partner().unwrap().public().verify(b"message", &sig), Ok(None));
        for i in (0..sig.len()).step_by(97) {
            let mut bad = sig.clone();
            bad[i] ^= 1;
            assert_eq!(key.public().verify(b"message", &bad), Ok(None), "byte {i}");
        }
        for bad in [&[][..], &sig[1..], &[sig.clone(), vec![0]].concat(), &vec![0; 4627], &vec![255; 4627]] {
            assert_eq!(key.public().verify(b"message", bad), Ok(None));
        }
        // Neither key's signature is the other's.
        assert_eq!(key.public().verify_by(Algorithm::Rs256, b"message", &sig), Ok(false));
        assert_eq!(shared_key().public().verify_by(Algorithm::MlDsa87, b"message", &sig), Ok(false));
        assert!(key.with_algorithm(Algorithm::Rs384).unwrap_err().found.contains("ALG_REFUSED"));
    }

    /// Keys and signatures of OpenSSL's making.
    #[test]
    fn from_openssl() {
        let public = PublicKey::from_pem(&fs::read_to_string(vector("leaf.pub.pem")).unwrap()).unwrap();
        let sig = |name: &str| fs::read(vector(name)).unwrap();
        assert_eq!(public.verify(b"message", &sig("message.sig")), Ok(Some(Algorithm::MlDsa87)));
        assert_eq!(public.verify(b"message", &sig("message-with-context.sig")), Ok(None));
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("leaf.key");
        write_private(&path, &fs::read(vector("leaf.key")).unwrap()).unwrap();
        let key = SigningKey::load(&path, KeySource::NamedFile).unwrap();
        assert_eq!(*key.public(), public);
        assert_eq!(public.verify(b"m", &key.sign(b"m").unwrap()), Ok(Some(Algorithm::MlDsa87)));
        // Written as OpenSSL writes it: the seed alone.
        let again = dir.path().join("again.pem");
        key.save(&again, None).unwrap();
        assert_eq!(fs::read(again).unwrap(), fs::read(vector("leaf.key")).unwrap());
        // Parameters, and another length.
        let der = pem::decode("PUBLIC KEY", &public.to_pem()).unwrap();
        assert!(PublicKey::from_spki(&der[..der.len() - 1]).is_err());
        assert!(PublicKey::from_spki(&[der, vec![0]].concat()).is_err());
    }

    /// Google's Project Wycheproof, without and with a context: those of the latter must not be taken.
    #[test]
    fn wycheproof_vectors() {
        use pkcs8::der::Encode as _;
        use pkcs8::der::asn1::BitStringRef;
        use pkcs8::spki::{AlgorithmIdentifierRef, SubjectPublicKeyInfoRef};
        use wycheproof::TestResult;
        use wycheproof::mldsa_verify::{TestName, TestSet};
        let (mut taken, mut refused) = (0, 0);
        for group in &TestSet::load(TestName::MlDsa87Verify).unwrap().test_groups {
            let algorithm = AlgorithmIdentifierRef { oid: public::ML_DSA_87, parameters: None };
            let subject_public_key = BitStringRef::from_bytes(&group.pubkey).unwrap();
            let key =
                PublicKey::from_spki(&SubjectPublicKeyInfoRef { algorithm, subject_public_key }.to_der().unwrap());
            for test in &group.tests {
                let verified = key.as_ref().map(|k| k.verify(&test.msg, &test.sig));
                let without_context = test.ctx.as_ref().is_none_or(|ctx| ctx.is_empty());
                if test.result == TestResult::Valid && without_context {
                    assert_eq!(verified, Ok(Ok(Some(Algorithm::MlDsa87))), "{}: {}", test.tc_id, test.comment);
                    taken += 1;
                } else {
                    assert!(matches!(verified, Err(_) | Ok(Ok(None))), "{}: {}", test.tc_id, test.comment);
                    refused += 1;
                }
            }
        }
        assert!(taken >= 10 && refused >= 20, "{taken} {refused}");
    }

    #[test]
    fn two_keys_in_one_file() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("unit.pem");
        struct Words;
        impl Passphrase for Words {
            fn read(&self) -> Result<Zeroizing<String>> {
                Ok(Zeroizing::new("correct horse".into()))
            }
        }
        pair().save(&path, Some("correct horse")).unwrap();
        let named = Named { passphrase: Some(&Words), ..Named::from(&path) };
        let loaded = SigningKey::load(named, KeySource::NamedFile).unwrap();
        let names = |key: &SigningKey| key.all().map(|k| k.algorithm().name()).collect::<Vec<_>>();
        assert_eq!(names(&loaded), ["RS384", "ML-DSA-87"]);
        let signatures = loaded.signatures(b"message").unwrap();
        for (key, signature) in loaded.all().zip(&signatures) {
            assert_eq!(signature.keyid, key.public().fingerprint());
            assert_eq!(key.public().verify(b"message", &signature.sig), Ok(Some(key.algorithm())));
        }
        let public = fs::read_to_string(dir.path().join("unit.pub.pem")).unwrap();
        let both: Vec<PublicKey> = pair().all().map(|k| k.public().clone()).collect();
        assert_eq!(PublicKey::all_from_pem(&public).unwrap(), both);
        assert!(PublicKey::all_from_pem(&both[0].to_pem().repeat(2)).is_err());
        // Two of one kind, the wrong order, and three.
        let block = |key: &SigningKey| {
            let path = dir.path().join("one.pem");
            let _ = fs::remove_file(&path);
            let _ = fs::remove_file(dir.path().join("one.pub.pem"));
            SigningKey { partner: None, ..clone_of(key) }.save(&path, None).unwrap();
            let text = fs::read_to_string(&path).unwrap();
            assert!(text.contains(PRIVATE_LABEL));
            text
        };
        let (rsa, other, ml_dsa) = (block(shared_key()), block(other_key()), block(pair().partner().unwrap()));
        for (i, text) in
            [[&rsa[..], &other].concat(), [&ml_dsa[..], &rsa].concat(), [&rsa[..], &ml_dsa, &other].concat()]
                .iter()
                .enumerate()
        {
            let path = dir.path().join(format!("{i}.pem"));
            write_private(&path, text.as_bytes()).unwrap();
            let error = SigningKey::load(&path, KeySource::NamedFile).unwrap_err();
            assert!(error.kind == Kind::Usage && error.found.contains("several keys"), "{error}");
        }
    }

    /// The same key from its own bytes.
    fn clone_of(key: &SigningKey) -> SigningKey {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("k.pem");
        key.save(&path, None).unwrap();
        SigningKey::load(&path, KeySource::NamedFile).unwrap()
    }

    /// A certificate by an ML-DSA authority: the key signs, the authority's certificate is enough to verify.
    #[test]
    fn under_a_certificate() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("leaf.key");
        write_private(&path, &fs::read(vector("leaf.key")).unwrap()).unwrap();
        let named = Named { chain: Some(&vector("leaf.pem")), ..Named::from(&path) };
        let key = SigningKey::load(named, KeySource::NamedFile).unwrap();
        let data = crate::audit::DataFolder::at(dir.path().join("data"));
        let entry = crate::audit::trust::Entry { schema: crate::audit::trust::SCHEMA.into(), ..Default::default() };
        crate::audit::trust::add_file(&data, &vector("root.pem"), &entry).unwrap();
        let mut store = crate::audit::TrustStore::load(&data, &[]).unwrap();
        let chain = key.chain().unwrap().clone();
        assert_eq!(chain.operator(), "DOE.JANE.1234567890");
        store.present(chain).unwrap();
        assert_eq!(store.get(key.public().fingerprint()), Some(key.public()));
        let other = crate::audit::TrustStore::default();
        assert!(other.clone().present(key.chain().unwrap().clone()).is_err());
    }
}

#[cfg(not(feature = "fips"))]
pub(crate) use ml_dsa::pair;
