//! What both databases promise, and what PostgreSQL alone can be asked: several servers, broken connections, passwords, TLS.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::{Arc, Mutex};

use super::postgres::{Address, TABLES};
use super::sql::values;
use super::*;
use crate::audit::Marking;
use crate::serve::Limits;
use crate::serve::account::{Account, Fingerprint, LOCKED_FOR, MOST_FAILURES};
use crate::serve::submission::Submission;
use crate::serve::tests::cluster::{self, Cluster};

const NOW: u64 = 1_790_000_000_000;

/// A database that several servers open.
enum Shared {
    File(tempfile::TempDir),
    Server(Arc<Cluster>, String),
}

impl Shared {
    /// One of each kind that is there.
    fn all() -> Vec<Shared> {
        let file = Shared::File(tempfile::tempdir().unwrap());
        let server = cluster::shared().map(|cluster| {
            let name = cluster.create();
            Shared::Server(cluster, name)
        });
        [file].into_iter().chain(server).collect()
    }

    fn open(&self, folder: &str) -> Database {
        match self {
            // A file knows one folder alone.
            Shared::File(file) => Database::file(&file.path().join("serve.sqlite")).unwrap(),
            Shared::Server(cluster, name) => at(&cluster.url("orb", name), folder).unwrap(),
        }
    }
}

fn at(url: &str, folder: &str) -> Result<Database> {
    Database::at(Address::new(url, None, None, NOW).unwrap(), folder.into())
}

fn add(database: &Database, id: &str, limits: &Limits) -> bool {
    let request = Submission { name: Some("van".into()), ..Submission::default() };
    let job = New { id, account: "jane", marking: "CUI", request: &request, submitted: NOW, bytes: 10 };
    database.add_job(&job, limits).unwrap()
}

fn account(name: &str) -> Account {
    Account {
        name: name.into(),
        roles: "viewer".parse().unwrap(),
        ceiling: Marking::parse("CUI").unwrap(),
        token_sha256: vec![0, 1, 255],
        token_expires: NOW + 1,
        made: NOW,
        disabled: false,
        failures: 0,
        locked_until: 0,
        last_used: None,
    }
}

/// Servers at work at the same time, in threads.
fn at_once<T: Send>(servers: &[Database], work: impl Fn(usize, &Database) -> T + Sync) -> Vec<T> {
    std::thread::scope(|threads| {
        let work = &work;
        let all: Vec<_> = servers.iter().enumerate().map(|(i, s)| threads.spawn(move || work(i, s))).collect();
        all.into_iter().map(|t| t.join().unwrap()).collect()
    })
}

#[test]
fn a_limit_holds_and_no_job_is_taken_twice() {
    for shared in Shared::all() {
        let servers: Vec<Database> = (0..6).map(|_| shared.open("f")).collect();
        let limits = Limits { queue: 100, queue_each: 100, ..Limits::default() };
        let added =
            at_once(&servers, |s, database| (0..40).filter(|i| add(database, &format!("{s}-{i}"), &limits)).count());
        assert_eq!(added.iter().sum::<usize>(), 100, "{added:?}");
        let taken = at_once(&servers, |_, database| {
            std::iter::from_fn(|| database.take(NOW).unwrap()).map(|job| job.id).collect::<Vec<_>>()
        });
        let each: BTreeSet<&String> = taken.iter().flatten().collect();
        assert_eq!((taken.iter().flatten().count(), each.len()), (100, 100), "every job once");
        assert_eq!(servers[0].running().unwrap().len(), 100);
    }
}

#[test]
fn wrong_tokens_are_counted_together() {
    for shared in Shared::all() {
        let servers: Vec<Database> = (0..2).map(|_| shared.open("f")).collect();
        servers[0].add_account(&account("jane")).unwrap();
        assert!(servers[1].add_account(&account("jane")).is_err(), "taken");
        let locked = at_once(&servers, |_, database| {
            let tries = (0..MOST_FAILURES / 2).map(|_| database.check_token("jane", b"wrong", NOW).unwrap());
            tries.filter(|found| matches!(found, Checked::NowLocked)).count()
        });
        assert_eq!(locked.iter().sum::<usize>(), 1);
        assert!(matches!(servers[0].check_token("jane", &[0, 1, 255], NOW).unwrap(), Checked::Locked));
        let later = NOW + LOCKED_FOR;
        assert!(matches!(servers[0].check_token("jane", &[0, 1, 255], later).unwrap(), Checked::Expired));
    }
}

#[test]
fn a_certificate_is_one_accounts() {
    for shared in Shared::all() {
        let database = shared.open("f");
        ["jane", "john"].iter().for_each(|name| database.add_account(&account(name)).unwrap());
        let (one, two) = (Fingerprint::of(b"one"), Fingerprint::of(b"two"));
        assert!(database.bind(&one, "jane", NOW).unwrap() && database.bind(&two, "jane", NOW + 1).unwrap());
        assert!(!database.bind(&one, "john", NOW).unwrap(), "it is jane's");
        assert_eq!(database.bound_to(&one).unwrap().unwrap().name, "jane");
        assert_eq!(database.certificates().unwrap()["jane"], [one, two]);
        assert!(!database.unbind(&one, "john").unwrap() && database.unbind(&one, "jane").unwrap());
        assert!(database.check_certificate(&one, NOW).unwrap().is_none());
        // Its token's end is nothing to a certificate; a lock and a disabled account are.
        let found = |now| database.check_certificate(&two, now).unwrap().unwrap().1;
        assert!(matches!(found(NOW + 100), Checked::Good(_)));
        for _ in 0..MOST_FAILURES {
            database.check_token("jane", b"wrong", NOW).unwrap();
        }
        assert!(matches!(found(NOW), Checked::Locked));
        database.set_disabled("jane", true).unwrap();
        assert!(matches!(found(NOW), Checked::Disabled));
    }
}

#[test]
fn texts_are_kept_and_sorted_byte_by_byte() {
    for shared in Shared::all() {
        let database = shared.open("f");
        let names = ["b", "a-z", "ab", "a0"];
        names.iter().for_each(|name| database.add_account(&account(name)).unwrap());
        let listed: Vec<String> = database.accounts().unwrap().into_iter().map(|a| a.name).collect();
        assert_eq!(listed, ["a-z", "a0", "ab", "b"]);
        assert!(add(&database, "x", &Limits::default()));
        let job = database.take(NOW).unwrap().unwrap();
        assert!(job.here && job.request.name.as_deref() == Some("van"));
        let error = Some("zwölf 💥 '; DROP TABLE job; -- \\".to_owned());
        let result = Some(serde_json::json!({"georeference": {"latitude": 1.5}, "n": null}));
        let ended = Ended {
            state: State::Failed,
            exit_code: Some(-1),
            error: error.clone(),
            result: result.clone(),
            marking: None,
            bytes: 1 << 33,
        };
        database.end("x", &ended, NOW + 1).unwrap();
        let kept = database.job("x").unwrap().unwrap();
        assert_eq!((kept.error, kept.result, kept.exit_code, kept.bytes), (error, result, Some(-1), 1 << 33));
        assert_eq!((kept.marking.as_str(), kept.ended, kept.stage), ("CUI", Some(NOW + 1), None));
        assert_eq!(database.markings().unwrap(), ["CUI"]);
        assert_eq!(database.jobs(&Selection { at_most: 5, ..Selection::default() }, &[]).unwrap().len(), 0);
        // What PostgreSQL cannot keep is kept without it.
        assert!(add(&database, "y", &Limits::default()));
        database.take(NOW).unwrap().unwrap();
        database.set_stage("y", "a\0b").unwrap();
        let stage = database.job("y").unwrap().unwrap().stage.unwrap();
        assert!(stage == "a\0b" || stage == "a\u{fffd}b", "{stage:?}");
    }
}

/// Both have the same columns: what is said to one can be said to the other.
#[test]
fn the_tables_are_the_same() {
    let Some(Shared::Server(cluster, name)) = Shared::all().pop() else { return };
    let (folder, _) = (tempfile::tempdir().unwrap(), at(&cluster.url("orb", &name), "f").unwrap());
    let path = folder.path().join("x.sqlite");
    drop(Database::file(&path).unwrap());
    let file = rusqlite::Connection::open(path).unwrap();
    let mut server = cluster.connect(&name);
    for (table, least) in [("account", 10), ("job", 20), ("certificate", 3)] {
        let sql =
            "SELECT name, \"notnull\" OR pk, CASE type WHEN 'INTEGER' THEN 'bigint' WHEN 'REAL' THEN 'double precision'
                   WHEN 'BLOB' THEN 'bytea' ELSE lower(type) END FROM pragma_table_info(?1)";
        let mut statement = file.prepare(sql).unwrap();
        let rows = statement.query_map([table], |r| Ok((r.get(0)?, r.get(1)?, r.get(2)?))).unwrap();
        let here: BTreeSet<(String, bool, String)> = rows.map(|r| r.unwrap()).collect();
        let sql = "SELECT column_name::text, is_nullable = 'NO', data_type::text FROM information_schema.columns
                   WHERE table_schema = 'orb' AND table_name = $1";
        let rows = server.query(sql, &[&table]).unwrap();
        let there: BTreeSet<(String, bool, String)> = rows.iter().map(|r| (r.get(0), r.get(1), r.get(2))).collect();
        assert!(here.len() >= least, "{here:?}");
        assert_eq!(here, there, "{table}");
    }
}

#[test]
fn tables_are_made_once_and_those_of_a_later_version_left_alone() {
    let Some(Shared::Server(cluster, name)) = Shared::all().pop() else { return };
    let url = cluster.url("orb", &name);
    std::thread::scope(|threads| (0..8).for_each(|_| drop(threads.spawn(|| drop(at(&url, "f").unwrap())))));
    let mut by_hand = cluster.connect(&name);
    let versions = by_hand.query("SELECT number FROM orb.version", &[]).unwrap();
    assert_eq!(versions.iter().map(|r| r.get::<_, i64>(0)).collect::<Vec<_>>(), [VERSION]);
    at(&url, "f").unwrap().add_account(&account("jane")).unwrap();
    by_hand.batch_execute("UPDATE orb.version SET number = 1000").unwrap();
    let words = at(&url, "f").err().unwrap().to_string();
    assert!(words.contains("found version 1000") && words.contains("A later Orb"), "{words}");
    by_hand.batch_execute(&format!("UPDATE orb.version SET number = {VERSION}")).unwrap();
    assert_eq!(at(&url, "f").unwrap().accounts().unwrap().len(), 1);
    assert_eq!(TABLES.len(), 1 + usize::try_from(VERSION - 3).unwrap());
}

#[test]
fn what_is_wrong_is_said() {
    let Some(cluster) = cluster::shared() else { return };
    let name = cluster.create();
    // A user that may make no schema, until an administrator makes it.
    let url = cluster.url("nobody", &name);
    let words = at(&url, "f").err().unwrap().to_string();
    assert!(words.contains("permission denied") && words.contains("CREATE SCHEMA orb AUTHORIZATION"), "{words}");
    cluster.connect(&name).batch_execute("CREATE SCHEMA orb AUTHORIZATION nobody").unwrap();
    assert!(at(&url, "f").is_ok());
    for (url, expected) in [
        (cluster.url("orb", "no_such"), "createdb"),
        (cluster.url("stranger", &name), "role \"stranger\" does not exist"),
        ("postgres://orb@127.0.0.1:1/orb".to_owned(), "Is the server running there"),
        ("postgres://orb@%2Fno%2Fsuch/orb".to_owned(), "No such file"),
        (cluster.url("sealed", &name), "--database-password"),
    ] {
        let error = at(&url, "f").err().unwrap_or_else(|| panic!("{url}"));
        assert_eq!(error.kind, crate::Kind::Environment);
        assert!(error.to_string().contains(expected), "{expected}: {error}");
    }
    let mut by_hand = cluster.connect("postgres");
    let latin = format!("CREATE DATABASE {name}_latin TEMPLATE template0 ENCODING 'SQL_ASCII' LOCALE 'C'");
    by_hand.batch_execute(&latin).unwrap();
    let words = at(&cluster.url("orb", &format!("{name}_latin")), "f").err().unwrap().to_string();
    assert!(words.contains("SQL_ASCII") && words.contains("createdb --encoding UTF8"), "{words}");
}

#[test]
fn passwords_and_certificates() {
    let Some(cluster) = cluster::shared() else { return };
    let name = cluster.create();
    cluster.connect(&name).batch_execute("CREATE SCHEMA orb AUTHORIZATION sealed").unwrap();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/tls");
    let open = |url: &str, password: &str, authority: Option<&str>| {
        let path = authority.map(|name| data.join(name));
        let address = Address::new(url, Some(password), path.as_deref(), NOW)?;
        Database::at(address, "f".into())?.accounts().map(|all| all.len())
    };
    let socket = cluster.url("sealed", &name);
    let on = |host: &str, more: &str| format!("postgres://sealed@{host}:{}/{name}{more}", cluster.port);
    let good = cluster::PASSWORD;
    assert_eq!(open(&socket, good, None), Ok(0));
    assert_eq!(open(&on("127.0.0.1", ""), good, None), Ok(0));
    // Under TLS, the password bound to this very server's certificate.
    let named = on("orb.example", "?hostaddr=127.0.0.1&channel_binding=require");
    assert_eq!(open(&named, good, Some("authority.pem")), Ok(0));
    let encrypted = on("localhost", "");
    assert_eq!(open(&encrypted, good, Some("authority.pem")), Ok(0));
    let other_name = on("db.example", "?hostaddr=127.0.0.1");
    for (url, password, authority, expected) in [
        (&socket, "hunter2", None, "password authentication failed"),
        (&named, "hunter2", Some("authority.pem"), "password authentication failed"),
        (&encrypted, good, Some("other.pem"), "UnknownIssuer"),
        (&other_name, good, Some("authority.pem"), "certificate not valid for name"),
    ] {
        let words = open(url, password, authority).unwrap_err().to_string();
        assert!(words.contains(expected) && !words.contains(password), "{expected}: {words}");
    }
}

#[test]
fn each_server_takes_the_jobs_of_its_own_folder() {
    let Some(Shared::Server(cluster, name)) = Shared::all().pop() else { return };
    let url = cluster.url("orb", &name);
    let (one, two) = (at(&url, "one").unwrap(), at(&url, "two").unwrap());
    one.hold().unwrap();
    two.hold().unwrap();
    let limits = Limits { queue: 1, ..Limits::default() };
    assert!(add(&one, "a", &limits) && add(&two, "b", &limits), "each has a queue of its own");
    assert!(!add(&one, "c", &limits));
    let number = |id: &str| one.job(id).unwrap().unwrap().number;
    assert_eq!((one.waiting_before(number("b")).unwrap(), one.unfinished("jane").unwrap()), (0, (1, 1)));
    assert_eq!(two.take(NOW).unwrap().unwrap().id, "b");
    assert!(two.take(NOW).unwrap().is_none());
    assert_eq!((one.running().unwrap().len(), two.running().unwrap().len()), (0, 1));
    assert_eq!((one.stored().unwrap(), one.job("b").unwrap().unwrap().here), (10, false));
    // Cancelled by the one, seen by the other.
    assert!(!two.is_cancelled("b").unwrap());
    assert_eq!(one.cancel("b", NOW).unwrap(), Some(State::Running));
    assert!(two.is_cancelled("b").unwrap());
    // A copy of a folder is no second server of its.
    let copy = at(&url, "one").unwrap();
    let words = copy.hold().unwrap_err().to_string();
    assert!(words.contains("no other server") && words.contains("serve/name"), "{words}");
    drop(one);
    copy.hold().unwrap();
}

#[test]
fn a_broken_connection_is_made_anew() {
    let Some(Shared::Server(cluster, name)) = Shared::all().pop() else { return };
    let database = at(&cluster.url("orb", &name), "f").unwrap();
    database.hold().unwrap();
    let mut by_hand = cluster.connect("postgres");
    let mut cut = || {
        let sql = "SELECT count(pg_terminate_backend(pid, 5000)) FROM pg_stat_activity
                   WHERE datname = $1 AND application_name = 'orb serve'";
        assert_eq!(by_hand.query_one(sql, &[&name]).unwrap().get::<_, i64>(0), 1);
    };
    assert!(add(&database, "a", &Limits::default()));
    cut();
    assert_eq!(database.job("a").unwrap().unwrap().id, "a", "read again");
    cut();
    assert_eq!(database.take(NOW).unwrap().unwrap().attempt, 1, "changed once");
    cut();
    assert!(add(&database, "b", &Limits::default()));
    // It holds its folder's lock again.
    assert!(at(&cluster.url("orb", &name), "f").unwrap().hold().is_err());
    // Tables that changed under prepared statements.
    assert_eq!(database.job("a").unwrap().unwrap().account, "jane");
    cluster.connect(&name).batch_execute("ALTER TABLE orb.job ALTER COLUMN account TYPE VARCHAR").unwrap();
    assert_eq!(database.job("a").unwrap().unwrap().account, "jane");
}

/// The connection breaks in the middle of a change: nobody claims to know what came of it, and nothing is done twice.
#[test]
fn a_change_whose_answer_was_lost_is_not_repeated() {
    let Some(Shared::Server(cluster, name)) = Shared::all().pop() else { return };
    let database = at(&cluster.url("orb", &name), "f").unwrap();
    assert!(add(&database, "a", &Limits::default()));
    let mut holder = cluster.connect(&name);
    let mut held = holder.transaction().unwrap();
    held.execute("LOCK TABLE orb.job IN EXCLUSIVE MODE", &[]).unwrap();
    let words = Mutex::new(String::new());
    std::thread::scope(|threads| {
        threads.spawn(|| *words.lock().unwrap() = database.take(NOW).unwrap_err().to_string());
        let mut by_hand = cluster.connect("postgres");
        let sql = "SELECT count(pg_terminate_backend(pid, 5000)) FROM pg_stat_activity
                   WHERE datname = $1 AND application_name = 'orb serve' AND wait_event_type = 'Lock'";
        while by_hand.query_one(sql, &[&name]).unwrap().get::<_, i64>(0) == 0 {
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
    });
    held.rollback().unwrap();
    let words = words.into_inner().unwrap();
    assert!(words.contains("whether this was still written is not known"), "{words}");
    assert_eq!(database.take(NOW).unwrap().unwrap().attempt, 1);
    assert_eq!(database.change("DELETE FROM job WHERE id = $1", &values!["a"]).unwrap(), 1);
}
