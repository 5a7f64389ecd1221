//! `orb serve --database`: a job that outlives kills of the server and of PostgreSQL; two servers with the same accounts; a
//! password that nobody sees. Without PostgreSQL this says so and passes; under ORB_REQUIRE_CLIENTS=1 it fails.
#![cfg(all(feature = "serve", target_os = "linux"))]

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::cluster;
use crate::served::{Served, orb};
use serde_json::Value;

/// For a job, on a machine that has other work too.
const WORK: Duration = Duration::from_secs(300);

fn until<T>(what: &str, mut look: impl FnMut() -> Option<T>) -> T {
    let begun = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(begun.elapsed() < WORK, "{what}");
        std::thread::sleep(Duration::from_millis(50));
    }
}

fn status(head: &str) -> &str {
    head.split(' ').nth(1).unwrap_or_default()
}

#[test]
fn a_job_outlives_the_server_and_the_database() {
    let Some(cluster) = cluster::shared() else { return };
    let name = cluster.create();
    cluster.connect(&name).batch_execute("CREATE SCHEMA orb AUTHORIZATION sealed").unwrap();
    let url = cluster.url("sealed", &name);
    let options = ["--database", url.as_str()];
    let secret = [("ORB_DATABASE_PASSWORD", cluster::PASSWORD)];
    let folder = tempfile::tempdir().unwrap();
    let [data, other, copy] = ["data", "other", "copy"].map(|name| folder.path().join(name));
    let add = |environment: &[(&str, &str)], more: &[&str]| {
        let words = ["serve", "account", "add", "jane", "--role", "operator", "--ceiling", "UNCLASSIFIED"];
        orb(&data).args(words).args(more).envs(environment.iter().copied()).output().unwrap()
    };
    // Without the password; with it in the address; with one that others can read; as it should be, by variables alone.
    let refused = |out: std::process::Output, code: i32, words: &str| {
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert!(out.status.code() == Some(code) && said.contains(words) && !said.contains("hunter2"), "{said}");
    };
    refused(add(&[], &options), 5, "--database-password");
    let open = url.replace("sealed@", "sealed:hunter2@");
    refused(add(&[], &["--database", &open]), 2, "a password in it");
    refused(add(&[], &["--database", "postgres://orb@192.0.2.1/orb"]), 4, "--database-ca");
    refused(add(&[], &["--database-password", "env:X"]), 2, "--database");
    let file = folder.path().join("password");
    std::fs::write(&file, cluster::PASSWORD).unwrap();
    let source = format!("file:{}", file.display());
    let by_file = [&options[..], &["--database-password", source.as_str()]].concat();
    let mode = |mode: &str| assert!(Command::new("chmod").arg(mode).arg(&file).status().unwrap().success());
    mode("644");
    refused(add(&[], &by_file), 4, "0644");
    mode("600");
    let made = add(&[("ORB_DATABASE", url.as_str()), secret[0]], &[]);
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let token = String::from_utf8(made.stdout).unwrap().trim().to_owned();
    assert!(!data.join("serve/serve.sqlite").exists(), "nothing is kept in two places");

    let mut served = Served::start_in(&data, "127.0.0.1:0", &options, &secret);
    let second = Served::start_with(&other, "127.0.0.1:0", &by_file);
    let car = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/smart_car.jpg");
    let (head, body) = served.submit(&token, &std::fs::read(car).unwrap());
    assert_eq!(status(&head), "201", "{head}");
    let id = serde_json::from_slice::<Value>(&body).unwrap()["id"].as_str().unwrap().to_owned();
    let at = format!("/api/v1/jobs/{id}");
    let running = |served: &Served| {
        until("it runs", || {
            let job = served.json("GET", &at, &token);
            (job["state"] == "running" && job["progress"]["fraction"].is_number()).then_some(job)
        })
    };
    assert_eq!(running(&served)["attempt"], 1);
    // The password is in no command line, and the run does not have it at all.
    let pid = served.child.id();
    let children = std::fs::read_to_string(format!("/proc/{pid}/task/{pid}/children")).unwrap_or_default();
    let threads = std::fs::read_dir(format!("/proc/{pid}/task")).unwrap();
    let of_threads = threads.flatten().filter_map(|t| std::fs::read_to_string(t.path().join("children")).ok());
    let runs: Vec<String> =
        (children + &of_threads.collect::<String>()).split_whitespace().map(str::to_owned).collect();
    assert!(!runs.is_empty());
    let file = |pid: &str, name: &str| {
        String::from_utf8_lossy(&std::fs::read(format!("/proc/{pid}/{name}")).unwrap()).into_owned()
    };
    for (pid, name) in runs.iter().flat_map(|run| [(run.as_str(), "environ"), (run.as_str(), "cmdline")]) {
        let text = file(pid, name);
        assert!(!text.is_empty() && !text.contains(cluster::PASSWORD) && !text.contains("ORB_DATABASE="), "{name}");
    }
    assert!(!file(&pid.to_string(), "cmdline").contains(cluster::PASSWORD));

    // The server is killed: begun again.
    served.kill_and_start();
    assert_eq!(running(&served)["attempt"], 2);
    // The other one knows the account and the job, and does not touch it.
    let seen = second.json("GET", &at, &token);
    assert_eq!((&seen["id"], &seen["state"]), (&id.as_str().into(), &"running".into()));
    assert_eq!(status(&second.ask("DELETE", &at, &token).0), "409");
    // The database is killed while the job runs, and until it is over: asking fails meanwhile, the run goes on.
    cluster.stop("immediate");
    let (head, body) = served.ask("GET", &at, &token);
    let said = String::from_utf8_lossy(&body);
    assert!(status(&head) == "503" && said.contains("BUSY") && !said.contains(&name), "{head}{said}");
    assert!(served.ask("GET", "/health", "").0.contains(" 200 "));
    let published = data.join(format!("serve/jobs/{id}/run-2/out/scene.ply"));
    until("it is published", || published.exists().then_some(()));
    std::thread::sleep(Duration::from_secs(2));
    cluster.go_on();
    let done = until("it is done", || {
        let (head, body) = served.ask("GET", &at, &token);
        let job = serde_json::from_slice::<Value>(&body).ok().filter(|_| status(&head) == "200")?;
        (job["state"] != "running").then_some(job)
    });
    assert_eq!((&done["state"], &done["attempt"]), (&"done".into(), &2.into()), "{done}");
    assert!(done["result"]["georeference"].is_object(), "what the run said was kept: {done}");
    assert_eq!(status(&served.ask("GET", &format!("{at}/files/scene.ply"), &token).0), "200");
    let (head, body) = second.ask("GET", &format!("{at}/files"), &token);
    assert!(status(&head) == "409" && String::from_utf8_lossy(&body).contains("another server"), "{head}");
    assert_eq!(second.json("GET", "/api/v1/geocells", &token)["geocells"][0]["models"][0]["id"], id.as_str());
    assert_eq!(served.json("POST", &format!("{at}/verify"), &token)["verdict"], "pass");

    // A copy of the folder is no second server of its.
    std::fs::create_dir_all(copy.join("serve")).unwrap();
    std::fs::copy(data.join("serve/name"), copy.join("serve/name")).unwrap();
    let start = ["serve", "--bind", "127.0.0.1:0", "--max-marking", "UNCLASSIFIED"];
    let out = orb(&copy).args(start).args(options).envs(secret).output().unwrap();
    refused(out, 5, "no other server");
    drop(served);
    drop(second);
    let events = String::from_utf8(orb(&data).args(["audit", "events"]).output().unwrap().stdout).unwrap();
    assert_eq!(events.matches("scene.generate     success").count(), 1, "{events}");
    assert!(!events.contains(cluster::PASSWORD));
}
