//! `orb view --webgl` from outside: that it changes nothing where it is not given, and in a headless Chromium whose WebGL is
//! the processor's that the page draws what the server draws. Without Chromium, or without `npm ci && npm run build` in
//! viewer/, that says so and passes; under ORB_REQUIRE_CLIENTS=1 it fails.
#![cfg(feature = "view")]

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::browser::Browser;
use crate::viewed::{Viewer, status};
use image::RgbImage;

/// Peak signal to noise ratio in dB that the two pictures of a camera have at least. Found: 43.1 and more; of the same
/// picture mirrored or upside down 21.5 and less.
const ALIKE: f64 = 36.0;
const NOT_ALIKE: f64 = 26.0;

/// Where the script is, if it was built.
fn built() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("viewer/dist");
    if folder.join("webgl.js").is_file() {
        return Some(folder);
    }
    let words = "viewer/dist/webgl.js is not there: `npm ci && npm run build` in viewer/ builds it";
    assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none_or(|v| v != "1"), "{words}");
    eprintln!("skipped: {words}");
    None
}

/// Four hundred Gaussians of all shapes and colours that look different from every side, the way up and mirrored.
fn scene(folder: &Path) -> PathBuf {
    let mut state = 1u64;
    // Numerical Recipes' generator: its upper bits, 0 to 1.
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    };
    let mut splats = orb_formats::Splats::default();
    for i in 0..400 {
        // A bar along x, a post at its end, and a foot that sticks out towards +y.
        let [a, b, c] = [(); 3].map(|()| random());
        let at = match i % 4 {
            0 | 1 => [2.4 * a - 1.2, 0.3 * b, 0.3 + 0.3 * c],
            2 => [0.9 + 0.3 * a, 0.3 * b, 0.3 + 1.5 * c],
            _ => [-1.2 + 0.3 * a, 1.2 * b, 0.2 * c],
        };
        splats.positions.push(at);
        splats.log_scales.push([(); 3].map(|()| (0.02 + 0.1 * random()).ln()));
        splats.rotations.push([(); 4].map(|()| 2.0 * random() - 1.0));
        splats.logit_opacities.push(4.0 * random());
        let colour = [at[0] / 1.2, at[1], at[2] - 0.7];
        splats.sh.push(std::array::from_fn(|k| match k {
            0 => colour.map(|c| 1.5 * c),
            _ => [(); 3].map(|()| 0.3 * random() - 0.15),
        }));
    }
    let comments = [
        "CLASSIFICATION: CUI",
        "frame: subject, right-handed, metres, Z up, +Y where the camera pointed, origin on the ground",
        "origin WGS84 latitude 34.5 longitude -118.5 ellipsoidal height 740 m",
        "heading of +Y 30 degrees clockwise from true north (given)",
    ];
    let path = folder.join("scene.ply");
    std::fs::write(&path, orb_formats::ply::write(&splats, &comments.map(str::to_owned)).unwrap()).unwrap();
    path
}

#[test]
fn without_the_option_nothing_of_it_is_there() {
    let folder = tempfile::tempdir().unwrap();
    let viewer = Viewer::start(&scene(folder.path()));
    let page = viewer.get(&viewer.path(""), viewer.host());
    let policy = "\r\ncontent-security-policy: default-src 'self'; img-src 'self' blob:; base-uri 'none'; form-action 'none'; \
                  frame-ancestors 'none'; object-src 'none'\r\n";
    assert!(page.contains(policy), "{page}");
    assert_eq!(page.matches("<script").count(), 1, "{page}");
    assert!(!page.to_lowercase().contains("webgl") && !page.contains("{{"), "{page}");
    for part in ["webgl.js", "notice.txt", "scene.ply"] {
        assert_eq!(status(&viewer.get(&viewer.path(part), viewer.host())), "404", "{part}");
    }
}

#[test]
fn a_folder_in_which_nothing_was_built_is_refused_with_the_command_that_builds() {
    let folder = tempfile::tempdir().unwrap();
    let path = scene(folder.path());
    let mut view = Command::new(env!("CARGO_BIN_EXE_orb"));
    view.arg("view").arg(&path).arg("--no-open").arg("--webgl").arg(folder.path());
    let mut commands = vec![view];
    if cfg!(feature = "serve") {
        let mut serve = Command::new(env!("CARGO_BIN_EXE_orb"));
        serve.args(["serve", "--bind", "127.0.0.1:0", "--max-marking", "CUI", "--webgl"]).arg(folder.path());
        serve.env("ORB_DATA_DIR", folder.path().join("data"));
        commands.push(serve);
    }
    for mut command in commands {
        let out = command.output().unwrap();
        let said = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{said}");
        assert!(said.contains("npm ci && npm run build") && said.contains("webgl.js"), "{said}");
    }
}

/// Peak signal to noise ratio, dB.
fn psnr(a: &RgbImage, b: &RgbImage) -> f64 {
    assert_eq!(a.dimensions(), b.dimensions());
    let squares: f64 = a.as_raw().iter().zip(b.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum();
    10.0 * (255.0f64.powi(2) * a.as_raw().len() as f64 / squares.max(1e-9)).log10()
}

/// Waits until the camera rests and who is to draw has drawn.
fn drawn_by(browser: &mut Browser, who: &str) {
    browser.until(&format!("document.getElementById('stage').dataset.settled === '{who}'"));
}

/// What the stage shows, by whom it is to be drawn, without the marks over it.
fn stage(browser: &mut Browser, who: &str) -> RgbImage {
    drawn_by(browser, who);
    browser.value("(document.getElementById('marks').style.visibility = 'hidden', '')");
    let pixels = browser.pixels("#stage");
    browser.value("(document.getElementById('marks').style.visibility = '', '')");
    pixels
}

#[test]
fn the_browser_draws_what_the_server_draws() {
    let (folder, Some(built)) = (tempfile::tempdir().unwrap(), built()) else { return };
    let Some(mut browser) = Browser::with_webgl(folder.path()) else { return };
    let viewer = Viewer::start_with(&scene(folder.path()), &["--webgl", built.to_str().unwrap()]);
    browser.size(960, 720, 1.0, false);
    browser.open(&viewer.address);
    drawn_by(&mut browser, "server");
    let is_here = "String(Boolean(document.getElementById('here')))";
    assert_eq!(browser.value(is_here), "false");
    browser.value("(document.getElementById('stage').focus(), '')");
    // From a side, from the photo's, from above, from below, close by and off the middle; with the grid and without.
    for (name, keys) in [
        ("begin", &[][..]),
        ("front", &["p"]),
        ("north-up", &["n"]),
        ("without-grid", &["f", "g", "ArrowUp", "ArrowUp"]),
        ("close", &["p", "ArrowRight", "ArrowRight", "ArrowRight", "+", "+", "+", "+", "+", "+", "+"]),
        ("below", &["p", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown"]),
    ] {
        for key in keys {
            browser.key(key);
        }
        let by_server = stage(&mut browser, "server");
        browser.key("w");
        let by_browser = stage(&mut browser, "browser");
        assert_eq!(browser.value(is_here), "true");
        browser.picture(&format!("webgl-{name}"));
        let alike = psnr(&by_browser, &by_server);
        let mirrored = psnr(&image::imageops::flip_horizontal(&by_browser), &by_server);
        let turned = psnr(&image::imageops::flip_vertical(&by_browser), &by_server);
        println!("{name}: {alike:.1} dB; mirrored {mirrored:.1}, upside down {turned:.1}");
        let coloured =
            by_browser.pixels().filter(|p| p.0.iter().max().unwrap() - p.0.iter().min().unwrap() > 40).count();
        assert!(coloured > 2000, "{name}: {coloured} coloured pixels");
        assert!(alike > ALIKE, "{name}: {alike} dB");
        assert!(mirrored < NOT_ALIKE && turned < NOT_ALIKE, "{name}: mirrored {mirrored}, upside down {turned} dB");
        browser.key("w");
        drawn_by(&mut browser, "server");
        assert_eq!(browser.value(is_here), "false");
    }
    // Steered while it draws: the server's picture of the same camera is the same.
    let middle = browser.value(
        "(r => `${r.x + r.width / 2} ${r.y + r.height / 2}`)(document.getElementById('stage').getBoundingClientRect())",
    );
    let (x, y) = middle.split_once(' ').map(|(x, y)| (x.parse::<f64>().unwrap(), y.parse::<f64>().unwrap())).unwrap();
    let steered = |browser: &mut Browser, name: &str, steer: &dyn Fn(&mut Browser)| {
        browser.key("p");
        browser.key("w");
        let before = stage(browser, "browser");
        steer(browser);
        let after = stage(browser, "browser");
        assert!(psnr(&before, &after) < NOT_ALIKE, "{name} changes nothing");
        browser.key("w");
        let by_server = stage(browser, "server");
        let alike = psnr(&after, &by_server);
        println!("{name}: {alike:.1} dB");
        assert!(alike > ALIKE, "{name}: {alike} dB");
    };
    steered(&mut browser, "dragged", &|b| b.drag(&[[x, y], [x + 60.0, y], [x + 120.0, y + 30.0]]));
    steered(&mut browser, "wheeled", &|b| b.wheel(x, y, -400.0));
    browser.size(960, 720, 1.0, true);
    steered(&mut browser, "touched", &|b| b.touch(&[&[[x, y]], &[[x + 40.0, y]], &[[x + 120.0, y + 40.0]]]));
    let apart = |d: f64| [[x - d, y], [x + d, y]];
    steered(&mut browser, "pinched", &|b| b.touch(&[&apart(30.0), &apart(40.0), &apart(60.0)]));
    // What it does not draw the server draws; the banners are in view, above and below, whoever draws.
    let banners = "[...document.querySelectorAll('.banner')].map(b => [b.textContent.replace('Marking: ', ''), \
                   b.getBoundingClientRect().top >= 0 && b.getBoundingClientRect().bottom <= innerHeight].join()).join(' ')";
    browser.key("w");
    drawn_by(&mut browser, "browser");
    assert_eq!(browser.value(banners), "CUI,true CUI,true");
    browser.key("2");
    drawn_by(&mut browser, "server");
    browser.until("document.getElementById('state').textContent.includes('depth of Gaussians')");
    assert_eq!(browser.value("document.getElementById('webgl').ariaPressed"), "false");
    // A phone.
    browser.size(390, 844, 2.0, true);
    browser.value("(document.getElementById('webgl').click(), '')");
    drawn_by(&mut browser, "browser");
    assert_eq!(browser.value(banners), "CUI,true CUI,true");
    assert_eq!(browser.value("String(document.documentElement.scrollWidth <= innerWidth)"), "true");
    browser.picture("webgl-phone");
    // Nothing came from elsewhere, and nothing that the page did was against its policy.
    assert_eq!(
        browser.value("String(performance.getEntriesByType('resource').every(r => r.name.startsWith(location.origin) || r.name.startsWith('blob:')))"),
        "true"
    );
    assert_eq!(browser.complaints(), Vec::<String>::new());
    let page = viewer.get(&viewer.path(""), viewer.host());
    let policy = "\r\ncontent-security-policy: default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; img-src \
                  'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'\r\n";
    assert!(page.contains(policy), "{page}");
    let notice = viewer.get(&viewer.path("notice.txt"), viewer.host());
    for package in ["@sparkjsdev/spark", "three", "fflate", "MIT"] {
        assert!(notice.contains(package), "{package}: {notice}");
    }
}

#[test]
fn a_browser_without_webgl_gets_the_servers_pictures() {
    let (folder, Some(built)) = (tempfile::tempdir().unwrap(), built()) else { return };
    let Some(mut browser) = Browser::start(folder.path()) else { return };
    let viewer = Viewer::start_with(&scene(folder.path()), &["--webgl", built.to_str().unwrap()]);
    browser.size(960, 720, 1.0, false);
    browser.open(&viewer.address);
    drawn_by(&mut browser, "server");
    browser.value("(document.getElementById('webgl').click(), '')");
    browser.until(
        "document.getElementById('state').textContent.startsWith('This browser has no WebGL2: the server draws.')",
    );
    drawn_by(&mut browser, "server");
    assert_eq!(browser.value("document.getElementById('webgl').ariaPressed"), "false");
    browser.picture("webgl-without");
    browser.value("(document.getElementById('stage').focus(), '')");
    browser.key("ArrowLeft");
    drawn_by(&mut browser, "server");
    assert_eq!(browser.complaints(), Vec::<String>::new());
}

/// Of the scene that ORB_WEBGL_SCENE names: how long until the first picture, how many a second of the turntable, how much
/// memory. `cargo test --release --test all webgl:: -- --ignored --nocapture`
#[cfg(target_os = "linux")]
#[test]
#[ignore = "a measurement, of a scene that ORB_WEBGL_SCENE names"]
fn how_fast_it_is() {
    let (folder, built) = (tempfile::tempdir().unwrap(), built().unwrap());
    let mut browser = Browser::with_webgl(folder.path()).unwrap();
    let scene = PathBuf::from(std::env::var_os("ORB_WEBGL_SCENE").expect("ORB_WEBGL_SCENE names a scene"));
    let viewer = Viewer::start_with(&scene, &["--webgl", built.to_str().unwrap()]);
    browser.open(&viewer.address);
    for (width, height) in [(480, 270), (960, 540), (1920, 1080)] {
        // The stage is as large as asked for, whatever stands around it.
        browser.size(width, height + 300, 1.0, false);
        browser.until("document.getElementById('stage')?.dataset.settled === 'server'");
        browser.value(&format!(
            "(e => {{ e.style.cssText = 'flex:none;width:{width}px;height:{height}px'; }})(document.getElementById('stage'))"
        ));
        browser.until(&format!("document.getElementById('stage').dataset.rested === '{width}x{height}'"));
        let before = (browser.memory(), viewer.used().1);
        browser.value("(window.begun = performance.now(), document.getElementById('webgl').click(), '')");
        browser.until("document.getElementById('stage').dataset.settled === 'browser'");
        let first = browser.value("(performance.now() - window.begun - 180).toFixed(0)");
        let turned = "(async () => { const s = document.getElementById('stage'), b = Number(s.dataset.pictures); \
                      document.getElementById('turn').click(); await new Promise(r => setTimeout(r, 10000)); \
                      document.getElementById('turn').click(); return ((Number(s.dataset.pictures) - b) / 10).toFixed(1); })()";
        let pictures = browser.value(turned);
        let after = (browser.memory(), viewer.used().1);
        println!(
            "{width} × {height}: first picture after {first} ms, {pictures} pictures a second; memory of the browser {:.0} → \
             {:.0} MiB, of the server {:.0} → {:.0} MiB",
            before.0, after.0, before.1, after.1
        );
        browser.value("(document.getElementById('webgl').click(), '')");
        browser.until("document.getElementById('stage').dataset.settled === 'server'");
    }
    println!("{} bytes of script", std::fs::metadata(built.join("webgl.js")).unwrap().len());
}
