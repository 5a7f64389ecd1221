//! What a record says of its time and its signers, as a user runs the program; the time server is on this machine.

use std::net::UdpSocket;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::time::{SystemTime, UNIX_EPOCH};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use orb_formats::{Splats, ply};
use serde_json::Value;

fn orb(data: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_orb")).args(args).env("ORB_DATA_DIR", data).output().unwrap()
}

fn said(out: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr))
}

/// A few splats in a file, to be exported.
fn scene(folder: &Path) -> String {
    let points = |i: usize| [i as f32 % 4.0, (i / 4) as f32 % 4.0, (i / 16) as f32];
    let splats = Splats {
        positions: (0..64).map(points).collect(),
        log_scales: vec![[-1.0; 3]; 64],
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; 64],
        logit_opacities: vec![6.0; 64],
        sh: vec![[[0.5; 3]; 16]; 64],
    };
    let path = folder.join("scene-in.ply");
    std::fs::write(&path, ply::write(&splats, &["made by hand".into()]).unwrap()).unwrap();
    path.to_str().unwrap().into()
}

/// An hour ahead; answers one question (RFC 5905 §7.3), with `spoil` done to the answer.
fn time_server(spoil: fn(&mut [u8; 48])) -> String {
    let socket = UdpSocket::bind(("127.0.0.1", 0)).unwrap();
    let at = socket.local_addr().unwrap();
    std::thread::spawn(move || {
        let mut request = [0; 48];
        let (_, client) = socket.recv_from(&mut request).unwrap();
        let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap();
        let seconds = now.as_secs() + 2_208_988_800 + 3600;
        let fraction = (u64::from(now.subsec_nanos()) << 32) / 1_000_000_000;
        let time = (seconds << 32 | fraction).to_be_bytes();
        let mut answer = [0; 48];
        (answer[0], answer[1]) = (4 << 3 | 4, 1);
        answer[12..15].copy_from_slice(b"GPS");
        answer[24..32].copy_from_slice(&request[40..48]);
        answer[32..40].copy_from_slice(&time);
        answer[40..48].copy_from_slice(&time);
        spoil(&mut answer);
        socket.send_to(&answer, client).unwrap();
    });
    at.to_string()
}

fn json(out: &Output) -> Value {
    serde_json::from_slice(&out.stdout).unwrap_or_else(|e| panic!("{e}: {}", said(out)))
}

/// Publishes with a time server or without; the record's time, or what the program said.
fn published(dir: &Path, server: Option<&str>) -> Result<Value, String> {
    let (data, out) = (dir.join("data"), dir.join("out"));
    let scene = scene(dir);
    let mut args =
        vec!["export", &scene, "--origin", "34.5,-118.4,740", "--format", "ply", "-o", out.to_str().unwrap()];
    args.extend(server.iter().flat_map(|s| ["--ntp-server", s]));
    let done = orb(&data, &args);
    if !done.status.success() {
        assert_eq!(done.status.code(), Some(5), "{}", said(&done));
        assert!(!out.exists(), "published after all");
        return Err(said(&done));
    }
    let shown = orb(&data, &["audit", "show", out.to_str().unwrap(), "--json"]);
    Ok(json(&shown)["predicate"].clone())
}

#[test]
fn a_record_dated_by_a_server() {
    let dir = tempfile::tempdir().unwrap();
    let server = time_server(|_| {});
    let record = published(dir.path(), Some(&server)).unwrap();
    let time = &record["time"];
    assert_eq!((time["source"].as_str(), time["sync_status"].as_str()), (Some("ntp-query"), Some("synchronised")));
    assert_eq!((time["stratum"].as_u64(), time["reference"].as_str()), (Some(1), Some(&*format!("{server} (GPS)"))));
    let off = time["offset_us"].as_i64().unwrap() - 3_600_000_000;
    assert!(off.abs() < 2_000_000, "{off} µs besides the hour");
    assert_eq!(record["schema_minor"], 6);
    assert!(!record.to_string().contains(dir.path().to_str().unwrap()), "an absolute path in {record}");
}

/// Every other answer, and none: nothing is published, and no record claims an answer.
#[test]
fn servers_that_date_nothing() {
    let silent = UdpSocket::bind(("127.0.0.1", 0)).unwrap();
    let cases: [(&str, String, &str); 4] = [
        ("kiss of death", time_server(|a| (a[1], a[12], a[13], a[14], a[15]) = (0, b'D', b'E', b'N', b'Y')), "denied"),
        ("another question's answer", time_server(|a| a[24] ^= 1), "originate"),
        ("a server that does not know", time_server(|a| a[0] |= 3 << 6), "synchronized"),
        ("silence", silent.local_addr().unwrap().to_string(), "no answer within 5000 ms"),
    ];
    for (what, server, words) in cases {
        let dir = tempfile::tempdir().unwrap();
        let error = published(dir.path(), Some(&server)).unwrap_err();
        assert!(error.contains("--ntp-server") && error.to_lowercase().contains(words), "{what}: {error}");
        let events = said(&orb(&dir.path().join("data"), &["audit", "events"]));
        assert!(events.contains("run.failed"), "{what}: {events}");
        let records = records(dir.path());
        assert!(
            records.len() >= 2 && records.iter().all(|r| r["predicate"]["time"]["source"] != "ntp-query"),
            "{what}"
        );
    }
}

/// Without a server the record says what the kernel says, and never a word of NTP. All records of one call say that they are.
#[test]
fn a_record_dated_by_this_machine() {
    let dir = tempfile::tempdir().unwrap();
    let record = published(dir.path(), None).unwrap();
    let time = &record["time"];
    assert!(["kernel", "none"].contains(&time["source"].as_str().unwrap()) && time["reference"].is_null(), "{time}");
    let requests: Vec<Value> =
        records(dir.path()).iter().map(|r| r["predicate"]["source"]["request_id"].clone()).collect();
    // The key was made, and the scene with it.
    assert!(requests.len() == 2 && requests[0] == requests[1], "{requests:?}");
    assert!(requests[0].is_string() || !cfg!(target_os = "linux"));
    if cfg!(target_os = "linux") {
        assert!(time["boot_id"].is_string() && time["monotonic_ms"].is_u64(), "{time}");
    }
    let verified = orb(&dir.path().join("data"), &["audit", "ledger", "verify", "--json"]);
    let codes: Vec<String> =
        json(&verified)["findings"].as_array().unwrap().iter().map(|f| f["code"].to_string()).collect();
    assert!(verified.status.success() && !codes.iter().any(|c| c.contains("TIME_")), "{codes:?}");
}

/// What a record says of the program and of its call, what it says only when asked, and what it never says.
#[test]
fn the_program_and_its_call() {
    let dir = tempfile::tempdir().unwrap();
    let record = published(dir.path(), None).unwrap();
    let out = dir.path().join("out");
    let argv: Vec<&str> =
        record["source"]["argv_redacted"].as_array().unwrap().iter().map(|w| w.as_str().unwrap()).collect();
    assert_eq!(
        argv,
        ["orb", "export", "[...]", "--origin", "[...]", "--format", "ply", "--output", "[...]"],
        "{argv:?}"
    );
    let program = env!("CARGO_BIN_EXE_orb");
    let sum = Command::new("sha256sum").arg(program).output().unwrap();
    let sha256 = said(&sum).split_whitespace().next().unwrap().to_owned();
    let tool = &record["tool"];
    assert_eq!(tool["binary_sha256"], sha256.as_str());
    assert!(tool["rustc"].as_str().unwrap().starts_with("rustc ") && tool["git_commit"].is_string(), "{tool}");
    assert!(record["where"]["hostname"].is_null() && record["actor"]["display"].is_null(), "{record}");
    assert!(record["crypto"]["module_certificate_claim"].is_null() || cfg!(feature = "fips"));
    let verify = |program: &str| {
        orb(&dir.path().join("data"), &["audit", "verify", out.to_str().unwrap(), "--program", program])
    };
    assert_eq!(verify(program).status.code(), Some(0), "{}", said(&verify(program)));
    let other = verify(&scene(dir.path()));
    assert!(other.status.code() == Some(1) && said(&other).contains("PROGRAM_DIGEST"), "{}", said(&other));

    // What the user states is in every record of the call, also of what only happened.
    let data = dir.path().join("data");
    let key = dir.path().join("unit.pem");
    let stated = Command::new(program)
        .args(["audit", "keygen", "-o", key.to_str().unwrap()])
        .env("ORB_DATA_DIR", &data)
        .env("ORB_OPERATOR_NAME", "Jane Doe")
        .env("ORB_OPERATOR_ROLE", "key custodian")
        .env("ORB_RETENTION", "P6Y")
        .env("ORB_RECORD_HOSTNAME", "1")
        .output()
        .unwrap();
    assert!(stated.status.success(), "{}", said(&stated));
    let last = records(dir.path()).pop().unwrap()["predicate"].clone();
    assert_eq!((&last["actor"]["display"], &last["actor"]["role"]), (&"Jane Doe".into(), &"key custodian".into()));
    assert_eq!(last["retention_hint"], "P6Y");
    assert!(last["where"]["hostname"].is_string() || !cfg!(target_os = "linux"), "{}", last["where"]);
    assert!(!last.to_string().contains("unit.pem"), "{last}");
}

/// The records of a ledger.
fn records(dir: &Path) -> Vec<Value> {
    let ledger = std::fs::read_to_string(dir.join("data/ledger/orb-ledger.jsonl")).unwrap();
    let read = |line: &str| -> Value {
        let envelope: Value = serde_json::from_str(line).unwrap();
        serde_json::from_slice(&STANDARD.decode(envelope["payload"].as_str().unwrap()).unwrap()).unwrap()
    };
    ledger.lines().map(read).collect()
}

/// A data folder with `pair.pem` in it: two keys that sign together, where the program has both. Runs that tests of other files
/// look at are signed by them.
pub fn pair() -> &'static Path {
    static DATA: OnceLock<tempfile::TempDir> = OnceLock::new();
    let made = || {
        let data = tempfile::tempdir().unwrap();
        let key = data.path().join("pair.pem");
        let profile: &[&str] = if cfg!(feature = "fips") { &[] } else { &["--profile", "hybrid"] };
        let made = orb(data.path(), &[&["audit", "keygen", "-o", key.to_str().unwrap()], profile].concat());
        assert!(made.status.success(), "{}", said(&made));
        data
    };
    DATA.get_or_init(made).path()
}

/// Two keys that sign together are both named, to a person and to a program.
#[cfg(not(feature = "fips"))]
#[test]
fn both_signers_are_named() {
    let (for_programs, out) = crate::place::told_everything();
    let record = &for_programs["record"];
    let (first, others) = (record["signed_by"].as_str().unwrap(), record["also_signed_by"].as_array().unwrap());
    assert!(others.len() == 1 && others[0] != first, "{record}");
    let text = said(&crate::models::by_a_mask().0);
    let line = |name: &str| text.lines().find_map(|l| l.strip_prefix(name)).map(|l| l.trim().to_owned());
    assert_eq!((line("signed by").as_deref(), line("and by").as_deref()), (Some(first), others[0].as_str()), "{text}");
    let verified = json(&orb(pair(), &["audit", "verify", out.to_str().unwrap(), "--json"]));
    assert_eq!(
        (&verified["signed_by"], &verified["also_signed_by"]),
        (&record["signed_by"], &record["also_signed_by"])
    );
}
