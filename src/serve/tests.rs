//! The routes without a socket.

use std::collections::BTreeSet;
use std::io::{Cursor, Read as _};
use std::sync::atomic::Ordering;

use axum::body::Body;
use axum::http::Request;
use clap::ValueEnum as _;
use serde_json::json;

use super::account::{LOCKED_FOR, MOST_FAILURES};
use super::database::State;
use super::role::Role;
use super::{api, runner};

use fixture::*;

#[path = "../../tests/cluster/mod.rs"]
pub(in crate::serve) mod cluster;
pub(super) mod fixture;

/// Each test once with each database.
macro_rules! on_both {
    ($($test:ident),*) => {
        mod sqlite {
            $(#[test]
            fn $test() {
                super::$test(crate::serve::tests::fixture::On::Sqlite);
            })*
        }
        mod postgres {
            $(#[test]
            fn $test() {
                if crate::serve::tests::cluster::shared().is_some() {
                    super::$test(crate::serve::tests::fixture::On::Postgres);
                }
            })*
        }
    };
}

on_both!(
    the_document_and_the_routes_are_one,
    roles,
    sessions_end_and_are_not_borrowed,
    wrong_tokens_lock_an_account,
    a_submission_is_judged_before_it_is_kept,
    results_are_found_by_their_names_alone,
    a_queue_has_an_end_and_jobs_their_order,
    what_was_running_is_put_back_and_given_up_after_some_times,
    what_was_published_stays_with_a_database_that_does_not_know_it,
    who_comes_from_elsewhere_gets_no_further
);

mod ceilings;
mod several;
mod webgl;

fn the_document_and_the_routes_are_one(on: On) {
    let document = serde_json::to_value(api::document()).unwrap();
    assert!(document["openapi"].as_str().unwrap().starts_with("3.1"));
    let all = operations();
    assert!(all.len() >= 20, "{all:?}");
    // What stands in the document is there: nobody is let in, and nothing is not found.
    let fixture = Fixture::new(on);
    for (method, path) in &all {
        let open = ["GET /health", "POST /api/v1/session"].contains(&format!("{method} {path}").as_str());
        let status = fixture.status(method, path, &nobody());
        let expected: &[u16] = if open { &[200, 422] } else { &[401] };
        assert!(expected.contains(&status), "{method} {path}: {status}");
    }
    let served = fixture.get("/openapi.json", &nobody());
    assert_eq!(served.json(), document);
    // What is there stands in the document: no route of the interface comes in by another way.
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/serve/api");
    let mut others = BTreeSet::new();
    for entry in crate::audit::disk::walk(&folder).unwrap() {
        let text = std::fs::read_to_string(entry.path).unwrap();
        others.extend(text.split(".route(\"").skip(1).map(|rest| rest.split('"').next().unwrap().to_owned()));
    }
    let page = ["/", "/icon.svg", "/openapi.json", "/page.css", "/page.js", "/view/{id}/", "/view/{id}/{part}"];
    assert_eq!(others.into_iter().collect::<Vec<_>>(), page);
}

fn roles(on: On) {
    let fixture = Fixture::new(on);
    let accounts: Vec<(Role, As)> = Role::value_variants()
        .iter()
        .map(|role| (*role, As::from(fixture.account(&role.name(), &role.name(), "SECRET").as_str())))
        .collect();
    let id = "0".repeat(32);
    for (method, path, allowed) in [
        ("GET", "/api/v1/jobs".to_owned(), "viewer operator marking-officer auditor"),
        ("POST", "/api/v1/jobs".to_owned(), "operator"),
        ("GET", format!("/api/v1/jobs/{id}"), "viewer operator marking-officer auditor"),
        ("GET", format!("/api/v1/jobs/{id}/events"), "viewer operator marking-officer auditor"),
        ("POST", format!("/api/v1/jobs/{id}/verify"), "viewer operator marking-officer auditor"),
        ("GET", format!("/api/v1/jobs/{id}/record"), "viewer operator marking-officer auditor"),
        ("GET", format!("/api/v1/jobs/{id}/files"), "viewer operator marking-officer"),
        ("GET", format!("/api/v1/jobs/{id}/files/scene.ply"), "viewer operator marking-officer"),
        ("GET", format!("/api/v1/jobs/{id}/archive.zip"), "viewer operator marking-officer"),
        ("GET", "/api/v1/geocells".to_owned(), "viewer operator marking-officer"),
        ("GET", format!("/view/{id}/"), "viewer operator marking-officer"),
        ("GET", format!("/view/{id}/frame"), "viewer operator marking-officer"),
        ("GET", format!("/view/{id}/scene.ply"), "viewer operator marking-officer"),
        ("POST", format!("/api/v1/jobs/{id}/cancel"), "operator"),
        ("DELETE", format!("/api/v1/jobs/{id}"), "operator"),
        ("GET", "/api/v1/accounts".to_owned(), "admin"),
        ("POST", "/api/v1/accounts".to_owned(), "admin"),
        ("POST", "/api/v1/accounts/x/disable".to_owned(), "admin"),
        ("POST", "/api/v1/accounts/x/enable".to_owned(), "admin"),
        ("POST", "/api/v1/accounts/x/token".to_owned(), "admin"),
        ("POST", "/api/v1/accounts/x/certificates".to_owned(), "admin"),
        ("DELETE", format!("/api/v1/accounts/x/certificates/{id}{id}"), "admin"),
        ("GET", "/api/v1/events".to_owned(), "auditor"),
        ("GET", "/metrics".to_owned(), "monitor"),
    ] {
        let let_in: Vec<String> = accounts
            .iter()
            .filter(|(_, who)| fixture.status(method, &path, who) != 403)
            .map(|(r, _)| r.name())
            .collect();
        assert_eq!(let_in.join(" "), allowed, "{method} {path}");
    }
    assert!(fixture.ledger().iter().any(|e| e.starts_with("access.refused failure ROLE account=viewer")));
}

fn sessions_end_and_are_not_borrowed(on: On) {
    let fixture = Fixture::new(on);
    let token = fixture.account("jane", "operator", "SECRET");
    let sign_in = |token: &str| fixture.ask("POST", "/api/v1/session", &nobody(), Some(json!({"token": token})));
    let answer = sign_in(&token);
    assert_eq!(answer.status, 200, "{}", answer.text());
    let cookie = answer.headers["set-cookie"].to_str().unwrap().to_owned();
    assert!(cookie.contains("; HttpOnly; SameSite=Strict;") && !cookie.contains(&token));
    let id = cookie.split(['=', ';']).nth(1).unwrap().to_owned();
    let csrf = answer.json()["csrf"].as_str().unwrap().to_owned();
    let with = |csrf: Option<&str>| As { token: None, cookie: Some(id.clone()), csrf: csrf.map(str::to_owned) };
    assert_eq!(fixture.get("/api/v1/session", &with(None)).json()["account"], "jane");
    // A change wants the secret that a page of another server's cannot read.
    assert_eq!(fixture.status("POST", "/api/v1/jobs/x/cancel", &with(None)), 403);
    assert_eq!(fixture.status("POST", "/api/v1/jobs/x/cancel", &with(Some("0".repeat(64).as_str()))), 403);
    assert_eq!(fixture.status("POST", "/api/v1/jobs/x/cancel", &with(Some(&csrf))), 404);
    assert_eq!(fixture.status("DELETE", "/api/v1/session", &with(Some(&csrf))), 204);
    assert_eq!(fixture.status("GET", "/api/v1/session", &with(None)), 401, "a cookie of a session that is over");
    // Time.
    let id = sign_in(&token).headers["set-cookie"].to_str().unwrap().split(['=', ';']).nth(1).unwrap().to_owned();
    let with = As { cookie: Some(id), ..As::default() };
    fixture.clock.fetch_add(super::session::IDLE, Ordering::Relaxed);
    assert_eq!(fixture.status("GET", "/api/v1/session", &with), 401, "idle for too long");
    // Another token.
    let id = sign_in(&token).headers["set-cookie"].to_str().unwrap().split(['=', ';']).nth(1).unwrap().to_owned();
    let with = As { cookie: Some(id), ..As::default() };
    let admin = As::from(fixture.account("root", "admin", "UNCLASSIFIED").as_str());
    let renewed = fixture.ask("POST", "/api/v1/accounts/jane/token", &admin, None);
    assert_eq!(renewed.status, 201);
    assert_eq!(fixture.status("GET", "/api/v1/session", &with), 401, "a session of the token before");
    assert_eq!(sign_in(&token).status, 401, "the token before");
    let token = renewed.json()["token"].as_str().unwrap().to_owned();
    assert_eq!(sign_in(&token).status, 200);
    // Disabled, enabled.
    assert_eq!(fixture.status("POST", "/api/v1/accounts/jane/disable", &admin), 204);
    assert_eq!(fixture.status("GET", "/api/v1/jobs", &token.as_str().into()), 401);
    assert_eq!(fixture.status("POST", "/api/v1/accounts/jane/enable", &admin), 204);
    assert_eq!(fixture.status("GET", "/api/v1/jobs", &token.as_str().into()), 200);
    assert_eq!(fixture.status("POST", "/api/v1/accounts/root/disable", &admin), 409);
    // Expired.
    fixture.clock.fetch_add(366 * 24 * 3600 * 1000, Ordering::Relaxed);
    assert_eq!(fixture.status("GET", "/api/v1/jobs", &token.as_str().into()), 401);
    let ledger = fixture.ledger();
    for event in [
        "account.add success account=jane",
        "account.change success account=jane by=root change=token",
        "account.change success account=jane by=root change=disabled",
        "session.begin success account=jane",
        "session.end success account=jane",
        "access.refused failure CSRF account=jane times=2",
        "access.refused failure TOKEN_EXPIRED account=jane",
        "access.refused failure ACCOUNT_DISABLED account=jane",
    ] {
        assert!(ledger.iter().any(|e| e.starts_with(event)), "{event} in {ledger:#?}");
    }
    assert!(!ledger.join("").contains(&token[9..30]));
}

fn wrong_tokens_lock_an_account(on: On) {
    let fixture = Fixture::new(on);
    let token = fixture.account("jane", "viewer", "SECRET");
    let who = As::from(token.as_str());
    let other = if token.as_bytes()[12] == b'A' { 'B' } else { 'A' };
    let wrong: As = format!("{}{other}{}", &token[..12], &token[13..]).as_str().into();
    for _ in 1..MOST_FAILURES {
        assert_eq!(fixture.status("GET", "/api/v1/jobs", &wrong), 401);
    }
    assert_eq!(fixture.status("GET", "/api/v1/jobs", &who), 200, "a good one begins the count again");
    for _ in 0..MOST_FAILURES {
        assert_eq!(fixture.status("GET", "/api/v1/jobs", &wrong), 401);
    }
    assert_eq!(fixture.status("GET", "/api/v1/jobs", &who), 401, "locked");
    fixture.clock.fetch_add(LOCKED_FOR, Ordering::Relaxed);
    assert_eq!(fixture.status("GET", "/api/v1/jobs", &who), 200, "no longer");
    // The same words whatever is wrong.
    let words = |token: &str| fixture.get("/api/v1/jobs", &token.into()).text();
    let unknown = words(&token.replace("jane", "john"));
    for other in [words("orb_x"), words(""), words("orb_jane_!"), words(&token[..20])] {
        assert_eq!(other, unknown);
    }
    let ledger = fixture.ledger();
    assert!(ledger.contains(&"account.lock success account=jane".to_owned()), "{ledger:#?}");
    assert!(ledger.contains(&"access.refused failure ACCOUNT_UNKNOWN account= times=1".to_owned()), "{ledger:#?}");
}

fn a_submission_is_judged_before_it_is_kept(on: On) {
    let fixture = Fixture::with(on, |l| {
        l.pixels = 10_000;
        l.upload = 100_000;
        l.photos = 1;
    });
    let operator = As::from(fixture.account("jane", "operator", "CUI").as_str());
    let small = photo(64, 64);
    let origin = ("origin", "34.5,-118.4,740");
    let long = "1".repeat(5000);
    for (fields, files, status, words) in [
        (vec![origin], vec![], 422, "photo"),
        (vec![origin], vec![("a.png", &b""[..])], 422, "photo"),
        (vec![origin], vec![("a.png", &b"#!/bin/sh"[..])], 422, "JPEG"),
        (vec![origin], vec![("a.png", &photo(200, 100)[..])], 422, "200 × 100"),
        (vec![origin], vec![("a.png", &[0; 150_000][..])], 413, ""),
        (vec![origin], vec![("a.png", &small[..]), ("b.png", &small[..])], 422, "at most 1"),
        (vec![], vec![("a.png", &small[..])], 422, "origin"),
        (vec![("origin", "91,0,0")], vec![("a.png", &small[..])], 422, "latitude"),
        (vec![("origin", "34.5,-118.4")], vec![("a.png", &small[..])], 422, "height"),
        (vec![origin, origin], vec![("a.png", &small[..])], 422, "once"),
        (vec![("origin", long.as_str())], vec![("a.png", &small[..])], 413, "field"),
        (vec![origin, ("output", "/tmp/x")], vec![("a.png", &small[..])], 422, "output"),
        (vec![origin, ("photos", "x")], vec![("a.png", &small[..])], 422, "photo"),
        (vec![origin, ("length", "-1")], vec![("a.png", &small[..])], 422, "length"),
        (vec![origin, ("classification", "CUI")], vec![("a.png", &small[..])], 403, "roles"),
    ] {
        let answer = fixture.submit(&operator, &fields, &files);
        assert_eq!(answer.status, status, "{fields:?}: {}", answer.text());
        assert!(answer.json()["message"].as_str().unwrap().contains(words), "{}", answer.text());
    }
    let incoming = fixture.server.place.incoming("");
    assert_eq!(std::fs::read_dir(incoming).unwrap().count(), 0, "nothing of them is left");
    assert_eq!(fixture.get("/api/v1/jobs", &operator).json()["jobs"], json!([]));
    // A name from outside is no path.
    let answer = fixture.submit(
        &operator,
        &[origin, ("format", "glb"), ("format", "cdb")],
        &[("../../../etc/cron d.png", &small)],
    );
    assert_eq!(answer.status, 201, "{}", answer.text());
    let job = answer.json();
    assert_eq!(
        (&job["name"], &job["marking"], &job["state"]),
        (&json!("cron_d"), &json!("UNCLASSIFIED"), &json!("queued"))
    );
    assert_eq!(job["request"]["format"], json!(["glb", "cdb"]));
    let kept = fixture.server.place.job(job["id"].as_str().unwrap()).join("in/cron_d.png");
    assert_eq!(std::fs::read(kept).unwrap(), small);
    // Half a form.
    let cut = Request::builder()
        .method("POST")
        .uri("/api/v1/jobs")
        .header("host", "localhost")
        .header("authorization", format!("Bearer {}", operator.token.clone().unwrap()))
        .header("content-type", "multipart/form-data; boundary=X");
    let answer =
        fixture.send(cut.body(Body::from("--X\r\nContent-Disposition: form-data; name=\"photo\"\r\n\r\nabc")).unwrap());
    assert_eq!(answer.status, 422);
}

fn results_are_found_by_their_names_alone(on: On) {
    let fixture = Fixture::new(on);
    let jane = As::from(fixture.account("jane", "operator", "SECRET").as_str());
    let john = As::from(fixture.account("john", "operator", "SECRET").as_str());
    let id = fixture.submitted(&jane);
    let at = format!("/api/v1/jobs/{id}");
    assert_eq!(fixture.status("GET", &format!("{at}/files"), &jane), 409, "nothing yet");
    let big: Vec<u8> = (0..300_000u32).map(|i| (i.wrapping_mul(i) >> 7) as u8).collect();
    let files: [(&str, &[u8]); 3] = [("scene.ply", &big), ("van.cdb/Tiles/N34/x.zip", b"zip"), ("preview.png", b"png")];
    assert_eq!(fixture.finish(&files), id);
    #[cfg(unix)]
    std::os::unix::fs::symlink("/etc/passwd", fixture.server.place.published(&id, 1).join("link")).unwrap();
    let listed = fixture.get(&format!("{at}/files"), &john).json();
    let names: Vec<&str> = listed["files"].as_array().unwrap().iter().map(|f| f["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["preview.png", "scene.ply", "van.cdb/Tiles/N34/x.zip"]);
    for (name, bytes) in files {
        let answer = fixture.get(&format!("{at}/files/{name}"), &john);
        assert_eq!((answer.status.as_u16(), answer.body.as_slice()), (200, bytes), "{name}");
        assert_eq!(answer.headers["x-orb-marking"], "UNCLASSIFIED");
        assert_eq!(answer.headers["x-content-type-options"], "nosniff");
    }
    for name in [
        "link",
        "../../in/van.png",
        "..%2f..%2fin%2fvan.png",
        "%2e%2e/%2e%2e/in/van.png",
        "/etc/passwd",
        "%2fetc%2fpasswd",
        "scene.ply/",
        "./scene.ply",
        "scene.ply%00",
        "van.cdb",
        "SCENE.PLY",
        "..\\in\\van.png",
    ] {
        assert_eq!(fixture.status("GET", &format!("{at}/files/{name}"), &jane), 404, "{name}");
    }
    for id in ["..", "%2e%2e%2f", "x", &id.to_uppercase(), &format!("{id}0")] {
        assert_eq!(fixture.status("GET", &format!("/api/v1/jobs/{id}"), &jane), 404, "{id}");
        assert_eq!(fixture.status("DELETE", &format!("/api/v1/jobs/{id}"), &jane), 404, "{id}");
    }
    let archive = fixture.get(&format!("{at}/archive.zip"), &john);
    let mut archive = zip::ZipArchive::new(Cursor::new(archive.body)).unwrap();
    assert_eq!((archive.len(), archive.comment()), (3, &b"UNCLASSIFIED"[..]));
    let mut bytes = Vec::new();
    archive.by_name("van/scene.ply").unwrap().read_to_end(&mut bytes).unwrap();
    assert_eq!(bytes, big);
    // What others submitted is not anyone's to end.
    assert_eq!(fixture.status("DELETE", &at, &john), 403);
    assert_eq!(fixture.status("POST", &format!("{at}/cancel"), &john), 403);
    assert_eq!(fixture.status("POST", &format!("{at}/cancel"), &jane), 409, "over");
    assert_eq!(fixture.status("DELETE", &at, &jane), 204);
    assert_eq!(fixture.status("GET", &at, &jane), 404);
    assert!(!fixture.server.place.job(&id).exists());
    let ledger = fixture.ledger();
    assert!(ledger.iter().any(|e| e.starts_with("job.delete success account=jane job=")), "{ledger:#?}");
}

fn a_queue_has_an_end_and_jobs_their_order(on: On) {
    let fixture = Fixture::with(on, |l| {
        l.queue = 3;
        l.queue_each = 2;
    });
    let jane = As::from(fixture.account("jane", "operator", "SECRET").as_str());
    let john = As::from(fixture.account("john", "operator", "SECRET").as_str());
    let small = photo(64, 64);
    let submit =
        |who: &As, photo: &[u8]| fixture.submit(who, &[("origin", "1,2,3")], &[("a.png", photo)]).status.as_u16();
    let ids = [fixture.submitted(&jane), fixture.submitted(&jane)];
    assert_eq!(submit(&jane, &small), 503, "of her own");
    let third = fixture.submitted(&john);
    assert_eq!(submit(&john, &small), 503, "of all");
    assert_eq!(fixture.get(&format!("/api/v1/jobs/{third}"), &john).json()["waiting_before"], 2);
    // A job that waits is cancelled at once, one that runs is told to stop.
    let running = fixture.server.database.take(BEGIN).unwrap().unwrap();
    assert_eq!((&running.id, running.attempt), (&ids[0], 1));
    for (id, state, cancelling) in [(&ids[1], "cancelled", false), (&ids[0], "running", true)] {
        let answer = fixture.ask("POST", &format!("/api/v1/jobs/{id}/cancel"), &jane, None);
        assert_eq!(answer.status, 202);
        assert_eq!((&answer.json()["state"], &answer.json()["cancelling"]), (&json!(state), &json!(cancelling)));
    }
    assert_eq!(fixture.status("DELETE", &format!("/api/v1/jobs/{}", ids[0]), &jane), 409, "it runs");
    // Pages of a list.
    let page = |query: &str| -> Vec<i64> {
        let answer = fixture.get(&format!("/api/v1/jobs?{query}"), &jane).json();
        answer["jobs"].as_array().unwrap().iter().map(|j| j["number"].as_i64().unwrap()).collect()
    };
    assert_eq!((page("limit=2"), page("before=2"), page("state=queued")), (vec![3, 2], vec![1], vec![3]));
    for wrong in ["limit=0", "limit=201", "limit=x", "state=lost", "colour=red"] {
        assert_eq!(fixture.status("GET", &format!("/api/v1/jobs?{wrong}"), &jane), 422, "{wrong}");
    }
    // Bytes.
    let fixture = Fixture::with(on, |l| l.stored = 3 * photo(64, 64).len() as u64 - 1);
    let jane = As::from(fixture.account("jane", "operator", "SECRET").as_str());
    let submit = || fixture.submit(&jane, &[("origin", "1,2,3")], &[("a.png", &small)]).status.as_u16();
    assert_eq!([submit(), submit(), submit()], [201, 201, 507]);
    assert_eq!(std::fs::read_dir(fixture.server.place.job("")).unwrap().count(), 2);
}

fn what_was_running_is_put_back_and_given_up_after_some_times(on: On) {
    let fixture = Fixture::new(on);
    let jane = As::from(fixture.account("jane", "operator", "SECRET").as_str());
    let (first, second) = (fixture.submitted(&jane), fixture.submitted(&jane));
    let server = &fixture.server;
    // What no job is known of: half a submission, half a deletion, and what is not the server's.
    let stray = "a".repeat(32);
    std::fs::create_dir_all(server.place.job(&stray).join("in")).unwrap();
    std::fs::create_dir_all(server.place.incoming(&stray)).unwrap();
    std::fs::create_dir_all(server.place.job("notes")).unwrap();
    for attempt in 1..=3 {
        let job = server.database.take(BEGIN).unwrap().unwrap();
        assert_eq!((&job.id, job.attempt), (&first, attempt), "at its old place");
        // Half a result.
        let half = server.place.begin_run(&first, attempt).unwrap().join(".out.staging");
        std::fs::create_dir(&half).unwrap();
        runner::recover(server).unwrap();
        assert!(!server.place.run(&first, attempt).exists());
    }
    let job = server.database.job(&first).unwrap().unwrap();
    assert_eq!((job.state, job.error.as_deref()), (State::Failed, Some("the run was killed, 3 times")));
    assert!(!server.place.job(&stray).exists() && !server.place.incoming(&stray).exists());
    assert!(server.place.job("notes").exists() && server.place.job(&second).join("in").exists());
    // Cancelled, and then killed.
    assert_eq!(server.database.take(BEGIN).unwrap().unwrap().id, second);
    fixture.ask("POST", &format!("/api/v1/jobs/{second}/cancel"), &jane, None);
    runner::recover(server).unwrap();
    assert_eq!(server.database.job(&second).unwrap().unwrap().state, State::Cancelled);
}

fn what_was_published_stays_with_a_database_that_does_not_know_it(on: On) {
    let fixture = Fixture::new(on);
    let jane = As::from(fixture.account("jane", "operator", "SECRET").as_str());
    let published = fixture.submitted(&jane);
    assert_eq!(fixture.finish(&[("scene.ply", b"ply")]), published);
    let place = &fixture.server.place;
    let [half, stray] = ["a", "b"].map(|c| c.repeat(32));
    // A run that was killed, and half a removal, published nothing that anyone has to keep.
    std::fs::create_dir_all(place.run(&half, 1).join(".out.staging")).unwrap();
    std::fs::create_dir_all(place.incoming(&stray).join("run-1/out")).unwrap();
    let mut other = Fixture::new(on);
    std::sync::Arc::get_mut(&mut other.server).unwrap().place = place.clone();
    runner::recover(&other.server).unwrap();
    assert_eq!(std::fs::read(place.published(&published, 1).join("scene.ply")).unwrap(), b"ply");
    assert!(place.job(&published).join("in").exists());
    assert!(!place.job(&half).exists() && !place.incoming(&stray).exists());
}

fn who_comes_from_elsewhere_gets_no_further(on: On) {
    let fixture = Fixture::new(on);
    let token = fixture.account("jane", "operator", "SECRET");
    let ask = |method: &str, path: &str, headers: &[(&str, &str)], body: &str| {
        let mut request =
            Request::builder().method(method).uri(path).header("authorization", format!("Bearer {token}"));
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        fixture.send(request.body(Body::from(body.to_owned())).unwrap())
    };
    let own = ("host", "localhost");
    let large = "x".repeat(20_000);
    let address = format!("/api/v1/jobs?{}", "x".repeat(2000));
    for (method, path, headers, body, expected) in [
        ("GET", "/api/v1/jobs", vec![own], "", 200),
        ("GET", "/api/v1/jobs", vec![("host", "ORB.example:443")], "", 200),
        ("GET", "/api/v1/jobs", vec![("host", "evil.example")], "", 421),
        ("GET", "/health", vec![("host", "evil.example")], "", 421),
        ("GET", "/api/v1/jobs", vec![], "", 421),
        ("GET", "/api/v1/jobs", vec![own, own], "", 421),
        ("POST", "/api/v1/session", vec![own, ("sec-fetch-site", "cross-site")], "", 403),
        ("POST", "/api/v1/session", vec![own, ("sec-fetch-site", "same-site")], "", 403),
        ("POST", "/api/v1/session", vec![own, ("content-type", "text/plain")], "{\"token\":\"x\"}", 422),
        ("POST", "/api/v1/session", vec![own, ("content-type", "application/json")], large.as_str(), 413),
        ("GET", address.as_str(), vec![own], "", 414),
        ("PUT", "/api/v1/jobs", vec![own], "", 405),
        ("GET", "/api/v1/../../etc/passwd", vec![own], "", 404),
        ("GET", "/.git/config", vec![own], "", 404),
    ] {
        let answer = ask(method, path, &headers, body);
        assert_eq!(answer.status, expected, "{method} {path} {headers:?}: {}", answer.text());
        let policy = answer.headers["content-security-policy"].to_str().unwrap();
        assert!(policy.contains("default-src 'self'") && policy.contains("frame-ancestors 'none'"));
        assert_eq!(answer.headers["cache-control"], "no-store");
        assert!(!answer.headers.contains_key("access-control-allow-origin"));
    }
    assert_eq!(fixture.get("/health", &nobody()).text(), "ok\n");
    let page = fixture.get("/", &nobody()).text();
    assert_eq!(page.matches("</span>SECRET</p>").count(), 2, "a banner above and below");
    assert!(!page.contains("{{") && !page.contains("http:") && !page.contains("https:"), "nothing from elsewhere");
    let monitor = As::from(fixture.account("prometheus", "monitor", "UNCLASSIFIED").as_str());
    let metrics = fixture.get("/metrics", &monitor).text();
    assert!(metrics.contains("orb_jobs{state=\"queued\"} 0\n") && metrics.contains("class=\"4xx\"} 1"), "{metrics}");
}
