//! `orb view` from outside: over a socket as a client sees it, and in a headless Chromium as a user does. Without
//! Chromium that test says so and passes; under ORB_REQUIRE_CLIENTS=1 it fails.
#![cfg(feature = "view")]

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use crate::browser::Browser;
use crate::viewed::{Viewer, status};

/// Two red balls, 2 m apart along x, 1 m above the ground, in a scene of Orb's with a place and a marking.
fn balls(folder: &Path, marking: &str) -> PathBuf {
    let mut splats = orb_formats::Splats::default();
    for x in [-1.0f32, 1.0] {
        splats.positions.push([x, 0.0, 1.0]);
        splats.log_scales.push([-2.5; 3]);
        splats.rotations.push([1.0, 0.0, 0.0, 0.0]);
        splats.logit_opacities.push(8.0);
        splats.sh.push(std::array::from_fn(|k| if k == 0 { [1.7, -1.7, -1.7] } else { [0.0; 3] }));
    }
    let mut comments = vec![
        "frame: subject, right-handed, metres, Z up, +Y where the camera pointed, origin on the ground".to_owned(),
        "origin WGS84 latitude 34.5 longitude -118.5 ellipsoidal height 740 m".to_owned(),
        "heading of +Y 90 degrees clockwise from true north (given)".to_owned(),
    ];
    if !marking.is_empty() {
        comments.push(format!("CLASSIFICATION: {marking}"));
    }
    let path = folder.join("scene.ply");
    std::fs::write(&path, orb_formats::ply::write(&splats, &comments).unwrap()).unwrap();
    path
}

#[test]
fn answers_who_knows_the_token_and_nobody_else() {
    let folder = tempfile::tempdir().unwrap();
    let viewer = Viewer::start(&balls(folder.path(), "SECRET//NOFORN"));
    assert_eq!(viewer.banner, "SECRET//NOFORN");
    let own = viewer.host().to_owned();
    let page = viewer.get(&viewer.path(""), &own);
    assert_eq!(status(&page), "200", "{page}");
    assert_eq!(page.matches("</span>SECRET//NOFORN</p>").count(), 2, "a banner above and below");
    for header in ["default-src 'self'", "nosniff", "no-referrer", "frame-ancestors 'none'", "no-store"] {
        assert!(page.contains(header), "{header}: {page}");
    }
    let token = viewer.path("").trim_matches('/').to_owned();
    let almost = token[..31].to_owned() + if token.ends_with('0') { "1" } else { "0" };
    let port = own.rsplit(':').next().unwrap();
    for (path, host, expected) in [
        ("/".to_owned(), own.clone(), "404"),
        (format!("/{almost}/"), own.clone(), "404"),
        (format!("/{}/scene.json", &token[..31]), own.clone(), "404"),
        (viewer.path("../../../../etc/passwd"), own.clone(), "404"),
        (viewer.path("%2e%2e%2fscene.ply"), own.clone(), "404"),
        (viewer.path("scene.ply"), own.clone(), "404"),
        (viewer.path(""), format!("evil.example:{port}"), "421"),
        (viewer.path(""), format!("127.0.0.1.evil.example:{port}"), "421"),
        (viewer.path(""), String::new(), "421"),
        (viewer.path(""), format!("localhost:{port}"), "200"),
        (viewer.path(""), "[::1]:8080".to_owned(), "200"),
        (viewer.path(&format!("frame?az={}", "1".repeat(2000))), own.clone(), "414"),
        (viewer.path("frame?w=100000"), own.clone(), "400"),
        (viewer.path("frame?file=/etc/passwd"), own.clone(), "400"),
        (viewer.path("frame?w=64&h=64"), own.clone(), "200"),
        (viewer.path("photo"), own.clone(), "404"),
    ] {
        let answer = viewer.get(&path, &host);
        assert_eq!(status(&answer), expected, "{path} {host}: {answer}");
        assert!(!answer.contains("root:") && answer.contains("nosniff"), "{answer}");
    }
    for request in [
        format!("POST {} HTTP/1.1\r\nHost: {own}\r\nConnection: close\r\n\r\n", viewer.path("frame")),
        format!("DELETE {} HTTP/1.1\r\nHost: {own}\r\nConnection: close\r\n\r\n", viewer.path("scene.json")),
    ] {
        assert_eq!(status(&viewer.send(&request)), "405", "{request}");
    }
    let path = viewer.path("frame");
    let body = format!("GET {path} HTTP/1.1\r\nHost: {own}\r\nContent-Length: 5\r\nConnection: close\r\n\r\nhello");
    assert_eq!(status(&viewer.send(&body)), "413");
    let twice = format!("GET {path} HTTP/1.1\r\nHost: {own}\r\nHost: evil.example\r\nConnection: close\r\n\r\n");
    assert_eq!(status(&viewer.send(&twice)), "421");
    let long = format!("GET {path} HTTP/1.1\r\nHost: {own}\r\nX: {}\r\n\r\n", "x".repeat(100_000));
    assert!(["431", "none"].contains(&status(&viewer.send(&long))), "a head larger than the buffer");
    assert_eq!(status(&viewer.get(&viewer.path("scene.json"), &own)), "200", "and it still answers");
}

#[test]
fn a_file_without_a_marking_is_shown_as_unmarked() {
    let folder = tempfile::tempdir().unwrap();
    let viewer = Viewer::start(&balls(folder.path(), ""));
    assert_eq!(viewer.banner, "UNMARKED");
    let page = viewer.get(&viewer.path(""), viewer.host());
    assert_eq!(page.matches("</span>UNMARKED</p>").count(), 2);
}

/// Whoever takes nothing of what he asked for holds no one else up, and does not stay.
#[test]
fn a_slow_client_holds_nobody_up() {
    let folder = tempfile::tempdir().unwrap();
    let viewer = Viewer::start(&balls(folder.path(), ""));
    // Many large pictures asked for in one go, and never read; the network's buffers hold a few.
    let one = format!("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", viewer.path("frame?w=1920&h=1080&az=1"), viewer.host());
    let mut slow: Vec<TcpStream> = Vec::new();
    for _ in 0..3 {
        let mut stream = TcpStream::connect(viewer.host()).unwrap();
        stream.write_all(one.repeat(200).as_bytes()).unwrap();
        slow.push(stream);
    }
    // Half a request, and then nothing.
    let mut half = TcpStream::connect(viewer.host()).unwrap();
    half.write_all(b"GET / HTTP/1.1\r\nHo").unwrap();
    let begin = Instant::now();
    assert_eq!(status(&viewer.get(&viewer.path("frame?w=64&h=64"), viewer.host())), "200");
    assert!(begin.elapsed() < Duration::from_secs(10), "{:?}", begin.elapsed());
    let end = Instant::now() + Duration::from_secs(60);
    half.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    let mut rest = Vec::new();
    let _ = half.read_to_end(&mut rest);
    assert!(Instant::now() < end, "half a request is let go");
}

#[cfg(target_os = "linux")]
#[test]
fn memory_stays_flat_rest_costs_nothing_and_an_interrupt_ends_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut viewer = Viewer::start(&balls(folder.path(), ""));
    let mut stream = BufReader::new(TcpStream::connect(viewer.host()).unwrap());
    let mut picture = |az: usize| {
        let path = viewer.path(&format!("frame?w=160&h=90&rest=false&az={az}"));
        // In one piece: pieces would each wait for the one before to be acknowledged.
        let request = format!("GET {path} HTTP/1.1\r\nHost: {}\r\n\r\n", viewer.host());
        stream.get_mut().write_all(request.as_bytes()).unwrap();
        let (mut line, mut length) = (String::new(), 0);
        while line != "\r\n" {
            line.clear();
            stream.read_line(&mut line).unwrap();
            if let Some(value) = line.strip_prefix("content-length: ") {
                length = value.trim().parse().unwrap();
            }
        }
        let mut body = vec![0; length];
        stream.read_exact(&mut body).unwrap();
        assert!(body.starts_with(&[0xff, 0xd8]) && body.ends_with(&[0xff, 0xd9]), "a JPEG");
    };
    (0..200).for_each(&mut picture);
    let (_, before) = viewer.used();
    (200..2200).for_each(&mut picture);
    let (busy, after) = viewer.used();
    assert!(after < before + 8.0, "{before} → {after} MiB over 2,000 pictures");
    std::thread::sleep(Duration::from_secs(2));
    let idle = viewer.used().0 - busy;
    assert!(idle <= 0.05, "{idle} s of processor time in 2 s of rest");
    assert!(Command::new("kill").args(["-INT", &viewer.child.id().to_string()]).status().unwrap().success());
    let end = Instant::now() + Duration::from_secs(10);
    let ended = loop {
        match viewer.child.try_wait().unwrap() {
            Some(status) => break Some(status),
            None if Instant::now() > end => break None,
            None => std::thread::sleep(Duration::from_millis(20)),
        }
    };
    assert_eq!(ended.and_then(|s| s.code()), Some(0));
}

#[test]
fn a_user_turns_measures_and_sees_the_marking() {
    let folder = tempfile::tempdir().unwrap();
    let Some(mut browser) = Browser::start(folder.path()) else { return };
    let viewer = Viewer::start(&balls(folder.path(), "CUI"));
    browser.size(1280, 800, 1.0, false);
    browser.open(&viewer.address);
    browser.until("document.getElementById('stage').dataset.pictures > 0");
    browser.until("document.getElementById('state').textContent.startsWith('Looking 60°')");
    let banners = "[...document.querySelectorAll('.banner')].map(b => [b.textContent.replace('Marking: ', ''), \
                   b.getBoundingClientRect().top >= 0 && b.getBoundingClientRect().bottom <= innerHeight].join()).join(' ')";
    assert_eq!(browser.value(banners), "CUI,true CUI,true");
    // By keys: turned, and described for who cannot see it.
    browser.value("document.getElementById('stage').focus()");
    for _ in 0..6 {
        browser.key("ArrowLeft");
    }
    browser.until("document.getElementById('state').textContent.startsWith('Looking 90°')");
    for (key, words) in [("2", "depth of Gaussians"), ("3", "normals of Gaussians"), ("1", "colour of Gaussians")] {
        browser.key(key);
        browser.until(&format!("document.getElementById('state').textContent.includes('{words}')"));
    }
    // By mouse: from one ball to the other, 2 m. Looking along +Y both are at the same depth.
    browser.key("p");
    browser.until("document.getElementById('state').textContent.includes('10° from above')");
    browser.key("m");
    for x in [-1, 1] {
        let at = format!(
            "(async () => {{ const c = await import('./camera.js'); const s = await (await fetch('scene.json')).json(); \
             const e = document.getElementById('stage'), b = e.getBoundingClientRect(); \
             const cam = {{az: 0, el: 10, tx: 0, ty: 0, tz: 0, dist: c.fitting(s, e.clientWidth, e.clientHeight)}}; \
             const p = c.project([{x}, 0, 1], cam, s, e.clientWidth, e.clientHeight); \
             return (p[0] + b.left) + ' ' + (p[1] + b.top); }})()"
        );
        let place = browser.value(&at);
        let (x, y) = place.split_once(' ').unwrap();
        browser.click(x.parse().unwrap(), y.parse().unwrap());
        browser.until("!/click the first/.test(document.getElementById('state').textContent)");
    }
    browser.until("document.getElementById('state').textContent.startsWith('Distance')");
    let said = browser.value("document.getElementById('state').textContent");
    let metres: f64 = said.split(' ').nth(1).unwrap().parse().unwrap();
    assert!((metres - 2.0).abs() < 0.02, "{said}");
    browser.picture("desktop");
    // A phone, and the same page at 200 %: nothing sticks out sideways, the banners are in view.
    for (name, width, height, factor, touch) in [("phone", 390, 844, 3.0, true), ("zoomed", 640, 400, 2.0, false)] {
        browser.size(width, height, factor, touch);
        let e = "document.getElementById('stage')";
        browser.until(&format!("{e}.clientWidth <= innerWidth"));
        browser.until(&format!("{e}.dataset.rested === {e}.clientWidth + 'x' + {e}.clientHeight"));
        assert_eq!(browser.value("String(document.documentElement.scrollWidth <= innerWidth)"), "true", "{name}");
        assert_eq!(browser.value(banners), "CUI,true CUI,true", "{name}");
        browser.picture(name);
    }
    assert_eq!(browser.value("String(performance.getEntriesByType('resource').every(r => r.name.startsWith(location.origin) || r.name.startsWith('blob:')))"), "true");
    assert_eq!(browser.complaints(), Vec::<String>::new());
}
