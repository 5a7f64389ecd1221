//! Who may send, see and be given what marking.

use axum::body::Body;
use axum::http::Request;
use serde_json::{Value, json};

use super::fixture::*;
use crate::audit::Marking;

on_both!(markings_and_ceilings, a_marking_inside_a_photo);

/// What stands in a photo counts as if it were said, whatever the file is called; nothing of it is kept.
fn a_marking_inside_a_photo(on: On) {
    let mut jpeg = Vec::new();
    image::codecs::jpeg::JpegEncoder::new(&mut jpeg).encode_image(&image::RgbImage::new(64, 64)).unwrap();
    let words = b"CLASSIFICATION: CUI";
    jpeg.splice(2..2, [&[0xff, 0xfe, 0, words.len() as u8 + 2][..], words].concat());
    for (ceiling, code) in [("UNCLASSIFIED", "ABOVE_SERVER_CEILING"), ("SECRET", "ABOVE_CEILING")] {
        let mut fixture = Fixture::new(on);
        std::sync::Arc::get_mut(&mut fixture.server).unwrap().ceiling = Marking::parse(ceiling).unwrap();
        let low = As::from(fixture.account("low", "operator", "UNCLASSIFIED").as_str());
        let send = |name: &str, bytes: &[u8]| fixture.submit(&low, &[("origin", "34.5,-118.4,740")], &[(name, bytes)]);
        for name in ["van.jpg", "van.jfif", "van.png", "van"] {
            let answer = send(name, &jpeg);
            assert_eq!((answer.status.as_u16(), &answer.json()["code"]), (403, &json!(code)), "{name}");
        }
        assert_eq!(fixture.get("/api/v1/jobs", &low).json()["jobs"], json!([]));
        assert_eq!(fixture.server.database.unfinished("low").unwrap().0, 0);
        // A photo without such words is taken.
        assert_eq!(send("van.jpg", &photo(64, 64)).status, 201);
    }
}

fn markings_and_ceilings(on: On) {
    let fixture = Fixture::new(on);
    let low = As::from(fixture.account("low", "operator,marking-officer", "UNCLASSIFIED").as_str());
    let high = As::from(fixture.account("high", "operator,marking-officer", "SECRET").as_str());
    let top = As::from(fixture.account("top", "operator,marking-officer", "TOP SECRET").as_str());
    let with = |who: &As, marking: &str| {
        let fields = [
            ("origin", "34.5,-118.4,740"),
            ("classification", marking),
            ("classified_by", "J. Doe, Analyst"),
            ("derived_from", "Guide, Agency, 20260101"),
            ("declassify_on", "20500101"),
        ];
        fixture.submit(who, if marking == "CUI" { &fields[..2] } else { &fields }, &[("van.png", &photo(64, 64))])
    };
    for (who, marking, code) in [
        (&low, "SECRET", "ABOVE_CEILING"),
        (&high, "SECRET//NOFORN", "ABOVE_SERVER_CEILING"),
        (&top, "TOP SECRET", "ABOVE_SERVER_CEILING"),
        (&high, "SECRET", "KEY_REQUIRED"),
        (&high, "COSMIC TOP SECRET", "REFUSED_BY_POLICY"),
    ] {
        let answer = with(who, marking);
        assert_eq!(
            (answer.status.as_u16(), &answer.json()["code"]),
            (403, &json!(code)),
            "{marking}: {}",
            answer.text()
        );
    }
    // A coalition that Orb knows nothing of, by a register that only who marks may send.
    let with_codes = |who: &As, codes: &str| {
        let form = [
            ("name=\"origin\"", "34.5,-118.4,740"),
            ("name=\"classification\"", "SECRET//REL TO USA, ZZTF"),
            ("name=\"classified_by\"", "J. Doe, Analyst"),
            ("name=\"derived_from\"", "Guide, Agency, 20260101"),
            ("name=\"declassify_on\"", "20500101"),
            ("name=\"country_register\"; filename=\"../codes.txt\"", codes),
            ("name=\"photo\"; filename=\"a.png\"", "PHOTO"),
        ];
        let mut body = Vec::new();
        for (head, value) in form {
            let bytes = if value == "PHOTO" { photo(64, 64) } else { value.as_bytes().to_vec() };
            let head = format!("--X\r\nContent-Disposition: form-data; {head}\r\n\r\n");
            body.extend([head.as_bytes(), &bytes, b"\r\n"].concat());
        }
        body.extend(b"--X--\r\n");
        let request = Request::builder().method("POST").uri("/api/v1/jobs").header("host", "localhost");
        let request = request.header("authorization", format!("Bearer {}", who.token.clone().unwrap()));
        let request = request.header("content-type", "multipart/form-data; boundary=X");
        fixture.send(request.body(Body::from(body)).unwrap())
    };
    let unmarked = As::from(fixture.account("plain", "operator", "SECRET").as_str());
    assert_eq!(with_codes(&unmarked, "ZZTF").status, 403);
    let unknown = with_codes(&high, "ZZTE of another");
    assert_eq!(unknown.json()["code"], "REFUSED_BY_POLICY", "{}", unknown.text());
    assert!(unknown.text().contains("country code `ZZTF`"), "{}", unknown.text());
    let refused = with_codes(&high, "zz");
    assert!(refused.status == 422 && refused.text().contains("line 1"), "{}", refused.text());
    let known = with_codes(&high, "# of a test\nZZTF a task force\n");
    let said = known.json();
    assert_eq!(said["code"], "ABOVE_SERVER_CEILING", "it is a marking now, above SECRET as all with a limit: {said}");
    // A job that is marked is not there for who is below it.
    let id = fixture.submitted(&high);
    fixture.finish(&[("scene.ply", b"ply")]);
    let lift = "UPDATE job SET marking = 'CUI'";
    assert_eq!(fixture.server.database.change(lift, &[]).unwrap(), 1);
    for path in [
        format!("/api/v1/jobs/{id}"),
        format!("/api/v1/jobs/{id}/files/scene.ply"),
        format!("/view/{id}/"),
        format!("/api/v1/jobs/{id}/archive.zip"),
        format!("/api/v1/jobs/{id}/events"),
        format!("/api/v1/jobs/{id}/record"),
    ] {
        let (hidden, absent) = (fixture.get(&path, &low), fixture.get(&path.replace(&id, &"0".repeat(32)), &low));
        assert_eq!((hidden.status.as_u16(), hidden.body), (404, absent.body), "{path}");
    }
    let seen = |who: &As| fixture.get("/api/v1/jobs", who).json()["jobs"].as_array().unwrap().len();
    assert_eq!((seen(&low), seen(&high)), (0, 1));
    let file = fixture.get(&format!("/api/v1/jobs/{id}/files/scene.ply"), &high);
    assert_eq!((file.status.as_u16(), &file.headers["x-orb-marking"]), (200, &"CUI".parse().unwrap()));
    assert!(fixture.ledger().iter().any(|e| e.starts_with("access.refused failure ABOVE_CEILING account=low")));
    // An administrator gives nobody more than the server takes.
    let admin = As::from(fixture.account("root", "admin", "UNCLASSIFIED").as_str());
    let add = |ceiling: &str, roles: Value| {
        let new = json!({"name": "new", "roles": roles, "ceiling": ceiling});
        fixture.ask("POST", "/api/v1/accounts", &admin, Some(new)).status.as_u16()
    };
    assert_eq!(add("TOP SECRET", json!(["viewer"])), 403);
    assert_eq!(add("", json!(["viewer"])), 403);
    assert_eq!(add("CUI", json!(["viewer", "admin"])), 422);
    assert_eq!(add("CUI", json!(["root"])), 422);
    assert_eq!(add("CUI", json!([])), 422);
    assert_eq!(add("CUI", json!(["viewer"])), 201);
    assert_eq!(add("CUI", json!(["viewer"])), 409, "taken");
    let all = fixture.get("/api/v1/accounts", &admin);
    assert!(all.json()["accounts"].as_array().unwrap().len() == 6 && !all.text().contains("sha256"));
}
