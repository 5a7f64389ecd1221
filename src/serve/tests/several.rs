//! Several photos in one job; what stands where.

use axum::body::Body;
use axum::http::Request;
use serde_json::json;

use super::{Answered, As, Fixture, On, photo};
use crate::serve::database::Stands;

on_both!(
    several_photos_are_kept_by_their_names_and_poses_by_ours,
    what_belongs_to_no_set_is_refused,
    what_stands_where_is_told_below_a_ceiling
);

/// Parts of a form: field, file name where it is a file, contents.
type Part<'a> = (&'a str, Option<&'a str>, &'a [u8]);

fn submit(fixture: &Fixture, who: &As, parts: &[Part<'_>]) -> Answered {
    let mut body = Vec::new();
    for (field, name, bytes) in parts {
        let name = name.map(|n| format!("; filename=\"{n}\"")).unwrap_or_default();
        let head = format!("--X\r\nContent-Disposition: form-data; name=\"{field}\"{name}\r\n\r\n");
        body.extend(head.bytes().chain(bytes.iter().copied()).chain(*b"\r\n"));
    }
    body.extend(b"--X--\r\n");
    let request = Request::builder()
        .method("POST")
        .uri("/api/v1/jobs")
        .header("host", "localhost")
        .header("authorization", format!("Bearer {}", who.token.clone().unwrap()))
        .header("content-type", "multipart/form-data; boundary=X");
    fixture.send(request.body(Body::from(body)).unwrap())
}

const ORIGIN: Part<'_> = ("origin", None, b"34.5,-118.4,740");
const CAMERAS: &[u8] = b"1 SIMPLE_PINHOLE 64 64 60 32 32\n";
const IMAGES: &[u8] = b"1 1 0 0 0 0 0 5 1 a b.png\n\n2 1 0 0 0 0 0 6 1 c.png\n\n";
const POINTS: &[u8] = b"1 1 2 3 9 8 7 0.5 1 0\n";
const CONTROL: &[u8] = b"point,latitude,longitude,height,photo,x,y\np,34.5,-118.4,740,c.png,3,4\n";

fn several_photos_are_kept_by_their_names_and_poses_by_ours(on: On) {
    let fixture = Fixture::new(on);
    let jane = As::from(fixture.account("jane", "operator", "SECRET").as_str());
    let (one, two) = (photo(64, 64), photo(80, 64));
    let all: [Part<'_>; 8] = [
        ORIGIN,
        ("name", None, b"barn"),
        ("photo", Some("DCIM\\a b.png"), &one),
        ("photo", Some("../c.png"), &two),
        ("poses", Some("sparse/0/cameras.txt"), CAMERAS),
        ("poses", Some("images.txt"), IMAGES),
        ("poses", Some("points3D.txt"), POINTS),
        ("gcp", Some("whatever.xlsx"), CONTROL),
    ];
    let answer = submit(&fixture, &jane, &all);
    assert_eq!(answer.status, 201, "{}", answer.text());
    let job = answer.json();
    assert_eq!(job["request"]["photos"], json!(["a b.png", "c.png"]));
    let folder = fixture.server.place.job(job["id"].as_str().unwrap());
    let kept = |name: &str| std::fs::read(folder.join(name)).unwrap();
    assert_eq!((kept("in/set/barn/a b.png"), kept("in/set/barn/c.png")), (one.clone(), two.clone()));
    assert_eq!((kept("in/poses/images.txt"), kept("in/gcp.csv")), (IMAGES.to_vec(), CONTROL.to_vec()));
    let stored = fixture.server.database.job(job["id"].as_str().unwrap()).unwrap().unwrap();
    assert_eq!(
        stored.bytes,
        (one.len() + two.len() + CAMERAS.len() + IMAGES.len() + POINTS.len() + CONTROL.len()) as u64
    );
    assert_eq!(stored.request.input(), "in/set/barn");
    assert_eq!(stored.request.options()[1..], ["--poses=in/poses", "--gcp=in/gcp.csv"]);
    assert_eq!(stored.request.inputs().iter().filter(|i| folder.join(i).is_file()).count(), 6);
    // Two to five need no poses.
    assert_eq!(submit(&fixture, &jane, &all[..4]).status, 201);
}

fn what_belongs_to_no_set_is_refused(on: On) {
    let fixture = Fixture::with(on, |l| {
        l.photos = 6;
        l.submission = 200_000;
    });
    let jane = As::from(fixture.account("jane", "operator", "SECRET").as_str());
    let small = photo(64, 64);
    let named = |name: &'static str| ("photo", Some(name), small.as_slice());
    let six = ["1.png", "2.png", "3.png", "4.png", "5.png", "6.png"].map(named);
    fn with<'a>(rest: &[Part<'a>]) -> Vec<Part<'a>> {
        [&[ORIGIN], rest].concat()
    }
    let large = vec![0; 250_000];
    for (parts, status, words) in [
        (with(&[&six[..], &[named("7.png")]].concat()), 422, "at most 6"),
        (with(&six), 422, "poses"),
        (with(&[named("a.png"), named("A.PNG")]), 422, "twice"),
        (with(&[named("a.png"), named("b;c.png")]), 422, "letters"),
        (with(&[named("a.png"), named("..")]), 422, "letters"),
        (with(&[named("a.png"), named("b.png"), ("poses", Some("passwd"), b"x")]), 422, "transforms.json"),
        (
            with(&[named("a.png"), ("poses", Some("images.txt"), b"x"), ("poses", Some("images.txt"), b"x")]),
            422,
            "one each",
        ),
        (with(&[named("a.png"), named("b.png"), ("poses", Some("cameras.txt"), b"x")]), 422, "cameras"),
        (with(&[named("a.png"), ("poses", Some("cameras.txt"), CAMERAS)]), 422, "one photo"),
        (with(&[named("a.png"), ("gcp", Some("g.csv"), CONTROL)]), 422, "one photo"),
        (with(&[named("a.png"), ("photo", Some("b.png"), &large)]), 413, "photo"),
        (with(&[named("a.png"), ("poses", None, b"/etc/passwd")]), 422, "poses"),
        (vec![named("a.png"), named("b.png")], 422, "origin"),
    ] {
        let answer = submit(&fixture, &jane, &parts);
        let said = answer.json()["message"].as_str().unwrap().to_owned();
        assert!(answer.status == status && said.contains(words), "{words}: {} {said}", answer.status);
        let here = fixture.server.place.incoming("");
        assert!(!said.contains(here.to_str().unwrap()), "{said}");
        assert_eq!(std::fs::read_dir(here).unwrap().count(), 0, "nothing of it is left");
    }
}

fn what_stands_where_is_told_below_a_ceiling(on: On) {
    let fixture = Fixture::new(on);
    let high = As::from(fixture.account("high", "operator", "SECRET").as_str());
    let low = As::from(fixture.account("low", "viewer", "UNCLASSIFIED").as_str());
    let empty = fixture.get("/api/v1/geocells", &low);
    assert_eq!(empty.json(), json!({"geocells": [], "before": null}), "{}", empty.text());
    for (latitude, longitude) in [(34.5, -118.25), (-0.5, 10.5), (34.25, -118.75), (75.5, 1.0)] {
        let id = fixture.submitted(&high);
        assert_eq!(fixture.finish(&[("scene.ply", b"ply")]), id);
        fixture.server.database.set_place(&id, Stands { latitude, longitude, heading: 90.0 }).unwrap();
    }
    // One that is still waiting stands nowhere.
    fixture.submitted(&high);
    let secret = "UPDATE job SET marking = 'SECRET' WHERE number = 3";
    assert_eq!(fixture.server.database.change(secret, &[]).unwrap(), 1);
    let cells = |who: &As, query: &str| {
        let all = fixture.get(&format!("/api/v1/geocells{query}"), who).json();
        let told = |c: &serde_json::Value| {
            let numbers: Vec<i64> =
                c["models"].as_array().unwrap().iter().map(|m| m["number"].as_i64().unwrap()).collect();
            (c["name"].as_str().unwrap().to_owned(), c["width"].as_i64().unwrap(), numbers)
        };
        (all["geocells"].as_array().unwrap().iter().map(told).collect::<Vec<_>>(), all["before"].as_i64())
    };
    let of = |name: &str, width, numbers: &[i64]| (name.to_owned(), width, numbers.to_vec());
    let (south, north) = (of("S01E010", 1, &[2]), of("N75W000", 4, &[4]));
    let (found, before) = cells(&high, "");
    assert_eq!(before, None);
    assert_eq!((&found[0], &found[1], found.len()), (&south, &of("N34W119", 1, &[3, 1]), 3));
    assert_eq!(found[2].1, north.1, "wider towards the pole");
    assert_eq!(cells(&low, "").0[1], of("N34W119", 1, &[1]), "what is above a ceiling stands nowhere");
    assert_eq!(cells(&high, "?limit=2").1, Some(3));
    assert_eq!(cells(&high, "?limit=2&before=3"), (vec![south, of("N34W119", 1, &[1])], Some(1)));
    assert_eq!(fixture.status("GET", "/api/v1/geocells?limit=0", &high), 422);
}
