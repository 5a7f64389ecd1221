use super::*;
use crate::audit::by_hand::{Beside, openssl_commands};
use crate::audit::keys::tests::{other_key, shared_key};

#[test]
fn own_and_named_keys() {
    let dir = tempfile::tempdir().unwrap();
    let data = DataFolder::at(dir.path().join("data"));
    let empty = TrustStore::load(&data, &[]).unwrap();
    assert!(empty.is_empty() && !data.path().exists());

    add(&data, shared_key()).unwrap();
    add(&data, shared_key()).unwrap();
    let store = TrustStore::load(&data, &[]).unwrap();
    assert_eq!(store.get(shared_key().public().fingerprint()), Some(shared_key().public()));
    assert_eq!(store.get(other_key().public().fingerprint()), None);
    assert_ne!(store.sha256(), empty.sha256());

    let named = dir.path().join("other.pem");
    fs::write(&named, other_key().public().to_pem()).unwrap();
    let both = TrustStore::load(&data, std::slice::from_ref(&named)).unwrap();
    assert!(both.get(other_key().public().fingerprint()).is_some());

    fs::write(&named, "not a key").unwrap();
    let error = TrustStore::load(&data, &[named]).unwrap_err();
    assert!(error.found.contains("ALG_REFUSED"), "{error}");
}

const UTC: &str = "2025-06-01T00:00:00.000Z";

fn entry() -> Entry {
    Entry { schema: SCHEMA.into(), ..Entry::default() }
}

fn signed(stated: &str, proven: Option<&str>) -> Signed {
    let ms = |text: &str| crate::audit::time::parse_utc(text).unwrap();
    Signed { stated_ms: ms(stated), proven_ms: proven.map(ms) }
}

fn codes_of(objections: &[Objection]) -> Vec<&'static str> {
    objections.iter().map(|o| o.code).collect()
}

#[test]
fn what_is_said_of_a_key() {
    let (early, late) = ("2025-01-01T00:00:00.000Z", "2025-12-01T00:00:00.000Z");
    let until = Entry { not_after: Some(UTC.into()), ..entry() };
    assert_eq!(codes_of(&until.judge(signed(early, None), None)), [""; 0]);
    assert_eq!(codes_of(&until.judge(signed(late, None), None)), ["KEY_EXPIRED"]);
    let from = Entry { not_before: Some(UTC.into()), ..entry() };
    assert_eq!(codes_of(&from.judge(signed(early, None), None)), ["KEY_EXPIRED"]);
    let limited = Entry { max_marking: Some("CUI".into()), ..entry() };
    assert_eq!(codes_of(&limited.judge(signed(early, None), Some(&Marking::CUI))), [""; 0]);
    assert_eq!(codes_of(&limited.judge(signed(early, None), Some(&Marking::SECRET))), ["KEY_SCOPE"]);
    let revoked = |reason| Entry { revoked: Some(Revocation { from: UTC.into(), reason }), ..entry() };
    for reason in [Reason::Compromise, Reason::Superseded, Reason::Ceased] {
        assert_eq!(codes_of(&revoked(reason).judge(signed(late, None), None)), ["KEY_REVOKED"]);
    }
    // Revoked later: of an honest holder the date stands, of a thief only what somebody else says of it.
    assert_eq!(codes_of(&revoked(Reason::Ceased).judge(signed(early, None), None)), ["KEY_REVOKED_LATER"]);
    assert_eq!(codes_of(&revoked(Reason::Compromise).judge(signed(early, None), None)), ["KEY_REVOKED"]);
    assert_eq!(codes_of(&revoked(Reason::Compromise).judge(signed(early, Some(early)), None)), ["KEY_REVOKED_LATER"]);
    assert_eq!(codes_of(&revoked(Reason::Compromise).judge(signed(early, Some(late)), None)), ["KEY_REVOKED"]);
}

#[test]
fn added_listed_and_revoked() {
    let dir = tempfile::tempdir().unwrap();
    let data = DataFolder::at(dir.path().join("data"));
    let file = dir.path().join("jane.pem");
    fs::write(&file, other_key().public().to_pem()).unwrap();
    let fingerprint = other_key().public().fingerprint();
    let named = Entry { name: Some("Jane".into()), ..entry() };
    assert_eq!(add_file(&data, &file, &named).unwrap(), Added::Key(fingerprint.into()));
    let load = || TrustStore::load(&data, &[]).unwrap();
    let before = load().sha256();
    assert_eq!(load().keys().next().unwrap().1.name.as_deref(), Some("Jane"));

    let revocation = |from: &str| Revocation { from: from.into(), reason: Reason::Compromise };
    assert!(revoke(&data, &"0".repeat(64), revocation(UTC)).is_err());
    assert!(revoke(&data, "../x", revocation(UTC)).is_err());
    assert!(revoke(&data, fingerprint, revocation("yesterday")).is_err());
    revoke(&data, fingerprint, revocation(UTC)).unwrap();
    assert_ne!(load().sha256(), before, "the store's digest shows it");
    assert!(revoke(&data, fingerprint, revocation("2025-07-01T00:00:00.000Z")).is_err(), "not later than it was");
    let milder = Revocation { from: "2025-01-01T00:00:00.000Z".into(), reason: Reason::Superseded };
    assert!(check_revoke(&data, fingerprint, &milder).unwrap_err().expected.contains("compromise"));
    assert!(revoke(&data, fingerprint, milder).is_err(), "a compromise stays one");
    // Adding a key again does not take its revocation back.
    add_file(&data, &file, &entry()).unwrap();
    add(&data, other_key()).unwrap();
    assert_eq!(codes_of(&load().judge(fingerprint, signed(UTC, None), None)), ["KEY_REVOKED"]);

    assert!(load().expect(Some(&load().sha256())).is_ok() && load().expect(None).is_ok());
    assert!(load().expect(Some(&before)).unwrap_err().found.contains("TRUST_STORE_CHANGED"));
    assert!(add_file(&data, &file, &Entry { not_after: Some("soon".into()), ..entry() }).is_err());
    assert!(add_file(&data, &file, &Entry { max_marking: Some("SECRETISH".into()), ..entry() }).is_err());
    fs::write(data.path().join(format!("trust/{fingerprint}.json")), "{\"schema\":\"orb.trust/v9\"}").unwrap();
    let error = TrustStore::load(&data, &[]).unwrap_err();
    assert!(error.found.contains("TRUST_STORE_DAMAGED"), "{error}");
}

/// An authority, an issuing one below it and a signer, made by OpenSSL; `None` where that is not installed.
pub(crate) struct Pki {
    pub dir: tempfile::TempDir,
}

impl Pki {
    pub fn new() -> Option<Pki> {
        let pki = Pki { dir: tempfile::tempdir().unwrap() };
        let config = "[ca]\ndefault_ca=d\n[d]\ndatabase=index.txt\nnew_certs_dir=.\nserial=serial\ncrlnumber=crlnumber\n\
             default_md=sha256\ndefault_days=30\ndefault_crl_days=30\npolicy=p\ncopy_extensions=none\nunique_subject=no\n\
             [p]\ncommonName=supplied\n[req]\ndistinguished_name=dn\n[dn]\n\
             [root]\nbasicConstraints=critical,CA:TRUE\nkeyUsage=critical,keyCertSign,cRLSign\n\
             [leaf]\nbasicConstraints=critical,CA:FALSE\nkeyUsage=critical,digitalSignature,nonRepudiation\n\
             extendedKeyUsage=1.3.6.1.5.5.7.3.36\n\
             [server]\nbasicConstraints=critical,CA:FALSE\nkeyUsage=critical,digitalSignature\nextendedKeyUsage=serverAuth\n\
             [tsa]\nbasicConstraints=critical,CA:FALSE\nkeyUsage=critical,digitalSignature\n\
             extendedKeyUsage=critical,timeStamping\n\
             [ts]\ndefault_tsa=t\n[t]\nserial=tsserial\ncrypto_device=builtin\nsigner_cert=tsa.pem\nsigner_key=tsa.key\n\
             certs=issuing.pem\nsigner_digest=sha256\ndefault_policy=1.2.3.4\ndigests=sha256\naccuracy=secs:1\n\
             ess_cert_id_chain=no\ness_cert_id_alg=sha256\n";
        for (name, text) in
            [("ca.cnf", config), ("index.txt", ""), ("serial", "1001\n"), ("crlnumber", "01\n"), ("tsserial", "01\n")]
        {
            fs::write(pki.path(name), text).unwrap();
        }
        if std::process::Command::new("openssl").arg("version").output().is_err() {
            assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: openssl is not installed");
            eprintln!("skipped: openssl is not installed");
            return None;
        }
        for name in ["root", "issuing", "leaf", "tsa"] {
            // The signer's key is Orb's own.
            match name {
                "leaf" => shared_key().save(&pki.path("leaf.key"), None).unwrap(),
                _ => pki.openssl(&["genrsa", "-out", &format!("{name}.key"), "2048"]),
            }
            let (key, csr, subject) = (format!("{name}.key"), format!("{name}.csr"), pki.subject(name));
            pki.openssl(&["req", "-new", "-config", "ca.cnf", "-key", &key, "-subj", &subject, "-out", &csr]);
        }
        pki.sign("root", "root", "root", "20240101000000Z", "20340101000000Z");
        pki.sign("issuing", "root", "root", "20240101000000Z", "20340101000000Z");
        pki.sign("leaf", "issuing", "leaf", "20250101000000Z", "20280101000000Z");
        Some(pki)
    }

    fn subject(&self, name: &str) -> String {
        if name == "leaf" { "/CN=DOE.JANE.1234567890".into() } else { format!("/CN=Test {name}") }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.dir.path().join(name)
    }

    pub fn openssl(&self, args: &[&str]) {
        let done = std::process::Command::new("openssl").args(args).current_dir(self.dir.path()).output().unwrap();
        assert!(done.status.success(), "openssl {args:?}: {}", String::from_utf8_lossy(&done.stderr));
    }

    /// `NAME.pem`, signed by `issuer`.
    pub fn sign(&self, name: &str, issuer: &str, extensions: &str, from: &str, to: &str) {
        let (csr, pem, key, cert) =
            (format!("{name}.csr"), format!("{name}.pem"), format!("{issuer}.key"), format!("{issuer}.pem"));
        let mut args = vec!["ca", "-batch", "-notext", "-config", "ca.cnf", "-extensions", extensions];
        args.extend(["-in", &csr, "-out", &pem, "-keyfile", &key, "-startdate", from, "-enddate", to]);
        if name == issuer {
            args.push("-selfsign")
        } else {
            args.extend(["-cert", &cert])
        }
        self.openssl(&args);
    }

    /// The signer's certificate and the one between it and the authority.
    pub fn chain(&self) -> String {
        ["leaf.pem", "issuing.pem"].map(|name| fs::read_to_string(self.path(name)).unwrap()).concat()
    }

    /// A list of the issuing authority that names the signer's certificate, revoked now, or at `compromised`.
    pub fn revoke(&self, compromised: Option<&str>) -> PathBuf {
        let mut args = vec!["ca", "-config", "ca.cnf", "-keyfile", "issuing.key", "-cert", "issuing.pem"];
        args.extend(["-revoke", "leaf.pem"]);
        match compromised {
            Some(time) => args.extend(["-crl_compromise", time]),
            None => args.extend(["-crl_reason", "superseded"]),
        }
        self.openssl(&args);
        let issuing = ["-keyfile", "issuing.key", "-cert", "issuing.pem", "-out", "issuing.crl"];
        self.openssl(&[&["ca", "-config", "ca.cnf", "-gencrl"], &issuing[..]].concat());
        self.path("issuing.crl")
    }
}

pub(crate) fn store_with(pki: &Pki, crls: &[&Path]) -> TrustStore {
    let data = DataFolder::at(pki.path("data"));
    add_file(&data, &pki.path("root.pem"), &entry()).unwrap();
    for crl in crls {
        assert!(matches!(add_file(&data, crl, &entry()).unwrap(), Added::Crl(_)));
    }
    TrustStore::load(&data, &[]).unwrap()
}

#[test]
fn a_chain_at_the_time_of_signing() {
    let Some(pki) = Pki::new() else { return };
    let mut store = store_with(&pki, &[]);
    let fingerprint = shared_key().public().fingerprint();
    assert!(store.get(fingerprint).is_none());
    let chain = CertChain::from_pem(&pki.chain()).unwrap();
    assert_eq!((chain.operator(), chain.sha256().len()), ("DOE.JANE.1234567890", 2));
    store.present(chain.clone()).unwrap();
    assert_eq!(store.get(fingerprint), Some(shared_key().public()));
    let judge = |store: &TrustStore, at: &str| codes_of(&store.judge(fingerprint, signed(at, None), None));
    assert_eq!(judge(&store, UTC), [""; 0]);
    assert_eq!(judge(&store, "2024-06-01T00:00:00.000Z"), ["CERT_EXPIRED"]);
    assert_eq!(judge(&store, "2029-06-01T00:00:00.000Z"), ["CERT_EXPIRED"]);

    // Without the certificate between, or the authority, nobody answers for the key.
    let alone = CertChain::from_pem(&fs::read_to_string(pki.path("leaf.pem")).unwrap()).unwrap();
    assert!(store_with(&pki, &[]).present(alone).unwrap_err().contains("UnknownIssuer"));
    assert!(TrustStore::default().present(chain.clone()).is_err());
    // An authority's certificate is no signer's, and the other way round.
    assert!(CertChain::from_pem(&fs::read_to_string(pki.path("issuing.pem")).unwrap()).is_err());
    let data = DataFolder::at(pki.path("data"));
    assert!(add_file(&data, &pki.path("leaf.pem"), &entry()).is_err());
    // A certificate for another use.
    pki.sign("leaf", "issuing", "server", "20250101000000Z", "20280101000000Z");
    let server = CertChain::from_pem(&pki.chain()).unwrap();
    assert!(store_with(&pki, &[]).present(server.clone()).unwrap_err().contains("extended key usage"));
    let allowing = Entry { eku: Some("1.3.6.1.5.5.7.3.1".into()), ..entry() };
    add_file(&data, &pki.path("root.pem"), &allowing).unwrap();
    TrustStore::load(&data, &[]).unwrap().present(server).unwrap();
}

#[test]
fn a_certificate_that_was_taken_back() {
    let Some(pki) = Pki::new() else { return };
    let chain = CertChain::from_pem(&pki.chain()).unwrap();
    let fingerprint = shared_key().public().fingerprint();
    let before = signed(UTC, None);
    let list = pki.revoke(None);
    let mut later = store_with(&pki, &[&list]);
    later.present(chain.clone()).unwrap();
    // OpenSSL dates the revocation now.
    assert_eq!(codes_of(&later.judge(fingerprint, before, None)), ["CERT_REVOKED_LATER"]);
    assert_eq!(codes_of(&later.judge(fingerprint, signed("2027-12-01T00:00:00.000Z", None), None)), ["CERT_REVOKED"]);

    let Some(pki) = Pki::new() else { return };
    let chain = CertChain::from_pem(&pki.chain()).unwrap();
    let list = pki.revoke(Some("20250901000000Z"));
    let mut stolen = store_with(&pki, &[&list]);
    stolen.present(chain).unwrap();
    assert_eq!(codes_of(&stolen.judge(fingerprint, before, None)), ["CERT_REVOKED"], "by its own word only");
    let proven = signed(UTC, Some("2025-06-02T00:00:00.000Z"));
    assert_eq!(codes_of(&stolen.judge(fingerprint, proven, None)), ["CERT_REVOKED_LATER"]);
}

/// What is said of an authority holds for each key that it answers for, as it would if it were said of the key.
#[test]
fn limits_of_an_authority() {
    let Some(pki) = Pki::new() else { return };
    let data = DataFolder::at(pki.path("data"));
    let fingerprint = shared_key().public().fingerprint();
    let judge = |entry: &Entry, marking: &Marking| {
        add_file(&data, &pki.path("root.pem"), entry).unwrap();
        let mut store = TrustStore::load(&data, &[]).unwrap();
        store.present(CertChain::from_pem(&pki.chain()).unwrap()).unwrap();
        codes_of(&store.judge(fingerprint, signed(UTC, None), Some(marking)))
    };
    let unclassified = Marking::UNCLASSIFIED;
    let limited = Entry { max_marking: Some("UNCLASSIFIED".into()), ..entry() };
    assert_eq!(judge(&entry(), &Marking::SECRET), [""; 0]);
    assert_eq!(judge(&limited, &unclassified), [""; 0]);
    assert_eq!(judge(&limited, &Marking::SECRET), ["KEY_SCOPE"]);
    let until = |utc: &str| Entry { not_after: Some(utc.into()), ..entry() };
    assert_eq!(judge(&until("2025-05-01T00:00:00.000Z"), &unclassified), ["KEY_EXPIRED"]);
    assert_eq!(judge(&until("2025-07-01T00:00:00.000Z"), &unclassified), [""; 0]);
    let from = Entry { not_before: Some("2025-07-01T00:00:00.000Z".into()), ..entry() };
    assert_eq!(judge(&from, &unclassified), ["KEY_EXPIRED"]);
    // A second authority over the same key lifts nothing that was said of the first.
    assert!(matches!(add_file(&data, &pki.path("issuing.pem"), &entry()).unwrap(), Added::Authority(_)));
    assert_eq!(judge(&limited, &Marking::SECRET), ["KEY_SCOPE"]);
    // Nor does a revocation that came later.
    add_file(&data, &pki.revoke(None), &entry()).unwrap();
    assert_eq!(judge(&limited, &Marking::SECRET), ["CERT_REVOKED_LATER", "KEY_SCOPE"]);
}

#[test]
fn a_folder_and_a_ledger_signed_under_an_authority() {
    use crate::audit::Policy;
    use crate::audit::keys::{KeySource, SigningKey};
    use crate::audit::ledger_check::{LedgerRequest, verify_ledger};
    use crate::audit::publication::tests::{destination, fill, ledger};
    use crate::audit::publication::{Publication, RECORD_CHAIN};
    use crate::audit::record::tests::draft;
    use crate::audit::verify::{Request, verify};
    let Some(pki) = Pki::new() else { return };
    fs::write(pki.path("chain.pem"), pki.chain()).unwrap();
    let key = SigningKey::load(&pki.path("leaf.key"), KeySource::NamedFile).unwrap();
    let error =
        SigningKey::generate(KeySource::NamedFile, Default::default()).unwrap().with_chain(&pki.path("chain.pem"));
    assert!(error.unwrap_err().found.contains("CERT_REFUSED"), "another key's certificate");
    let key = key.with_chain(&pki.path("chain.pem")).unwrap();
    let out = pki.path("out");
    let mut publication = Publication::begin(&destination(&out)).unwrap();
    fill(&mut publication).unwrap();
    publication.seal(&draft(), &key, &mut ledger(pki.dir.path())).unwrap();

    let now_ms = 1_763_700_000_000;
    let check = |trust: &TrustStore| {
        let request = Request { strict: true, ..Request::new(&out, trust, now_ms) };
        verify(&request).unwrap()
    };
    let trust = store_with(&pki, &[]);
    let report = check(&trust);
    assert_eq!(report.exit_code, 0, "{}", report.to_text());
    let path = pki.path("data/ledger/orb-ledger.jsonl");
    let request = LedgerRequest {
        ledger: &path,
        trust: &trust,
        checkpoints: &[],
        require_anchor: false,
        now_ms,
        strict: true,
        policy: Policy::default(),
    };
    let report = verify_ledger(&request).unwrap();
    assert_eq!((report.exit_code, report.counts.records), (0, 1), "{}", report.to_text());

    pki.openssl(&[
        "req",
        "-new",
        "-config",
        "ca.cnf",
        "-key",
        "tsa.key",
        "-subj",
        "/CN=Another",
        "-out",
        "other-root.csr",
    ]);
    std::fs::copy(pki.path("tsa.key"), pki.path("other-root.key")).unwrap();
    pki.sign("other-root", "other-root", "root", "20240101000000Z", "20340101000000Z");
    // Who trusts nobody, or another authority, learns nothing from the chain.
    assert_eq!(check(&TrustStore::default()).exit_code, 3);
    let codes = |report: &crate::audit::report::Report| report.findings.iter().map(|f| f.code).collect::<Vec<_>>();
    let mut others = TrustStore::default();
    others.insert(other_key().public().clone());
    let found = codes(&check(&others));
    assert!(found.contains(&"KEY_UNTRUSTED") && !found.contains(&"CERT_UNTRUSTED"), "{found:?}");
    let elsewhere = DataFolder::at(pki.path("elsewhere"));
    add_file(&elsewhere, &pki.path("other-root.pem"), &entry()).unwrap();
    let found = codes(&check(&TrustStore::load(&elsewhere, &[]).unwrap()));
    assert!(found.contains(&"KEY_UNTRUSTED") && found.contains(&"CERT_UNTRUSTED"), "{found:?}");
    // The chain is part of what was signed.
    let chain = fs::read_to_string(out.join(RECORD_CHAIN)).unwrap();
    fs::write(out.join(RECORD_CHAIN), [&chain, &fs::read_to_string(pki.path("root.pem")).unwrap()[..]].concat())
        .unwrap();
    assert!(codes(&check(&trust)).contains(&"SIGNER_MISMATCH"));
    // Also where the key is trusted itself, and nobody asks whose it is.
    let mut direct = TrustStore::default();
    direct.insert(shared_key().public().clone());
    let plain = || verify(&Request::new(&out, &direct, now_ms)).unwrap();
    let garbled = chain.replacen("-----BEGIN", "-----BEGUN", 1);
    for other in [garbled, fs::read_to_string(pki.path("leaf.pem")).unwrap(), format!("{chain}\n"), String::new()] {
        fs::write(out.join(RECORD_CHAIN), other).unwrap();
        let report = plain();
        assert!(report.exit_code == 1 && codes(&report).contains(&"SEAL_FILE_MISMATCH"), "{}", report.to_text());
    }
    fs::remove_file(out.join(RECORD_CHAIN)).unwrap();
    let report = plain();
    assert!(report.exit_code == 3 && codes(&report).contains(&"SEAL_FILE_MISSING"), "{}", report.to_text());
    assert!(codes(&check(&trust)).contains(&"KEY_UNTRUSTED"));
    // OpenSSL agrees about the path, by the commands that Orb prints.
    fs::write(out.join(RECORD_CHAIN), &chain).unwrap();
    assert_eq!(plain().exit_code, 0, "{}", plain().to_text());
    let commands = openssl_commands(&out, Beside::default()).unwrap();
    let commands = commands.replace("AUTHORITY.pem", "../root.pem");
    let done = std::process::Command::new("sh").args(["-e", "-c", &commands]).output().unwrap();
    let text = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(
        done.status.success() && text.contains("Verified OK") && text.contains("orb-record.chain.pem: OK"),
        "{text}"
    );
}
