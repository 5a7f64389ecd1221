//! Scenes that a browser draws itself: the routes, for whom they are, and what they may make the page do.

use std::sync::Arc;

use super::fixture::{As, Fixture, On, nobody};
use crate::cli::device::Device;
use crate::serve::viewers::Viewers;
use crate::view::webgl::Script;
use crate::web::guard::CONTENT_POLICY;

/// A ball, as it is published.
fn ball() -> Vec<u8> {
    let mut splats = orb_formats::Splats::default();
    splats.positions.push([0.0, 0.0, 1.0]);
    splats.log_scales.push([-2.5; 3]);
    splats.rotations.push([1.0, 0.0, 0.0, 0.0]);
    splats.logit_opacities.push(8.0);
    splats.sh.push([[0.5; 3]; 16]);
    let frame = "frame: subject, right-handed, metres, Z up, +Y where the camera pointed, origin on the ground";
    orb_formats::ply::write(&splats, &["CLASSIFICATION: CUI".to_owned(), frame.to_owned()]).unwrap()
}

#[test]
fn a_scene_is_drawn_by_those_alone_who_may_see_it() {
    let mut fixture = Fixture::new(On::Sqlite);
    let low = As::from(fixture.account("low", "operator", "UNCLASSIFIED").as_str());
    let high = As::from(fixture.account("high", "operator", "SECRET").as_str());
    let auditor = As::from(fixture.account("auditor", "auditor", "SECRET").as_str());
    let id = fixture.submitted(&high);
    fixture.finish(&[("scene.ply", &ball())]);
    assert_eq!(fixture.server.database.change("UPDATE job SET marking = 'CUI'", &[]).unwrap(), 1);
    let at = |part: &str| format!("/view/{id}/{part}");
    let parts = ["webgl.js", "notice.txt", "scene.ply"];
    // Without the option.
    for part in parts {
        assert_eq!(fixture.status("GET", &at(part), &high), 404, "{part}");
    }
    assert_eq!(fixture.get(&at(""), &high).headers["content-security-policy"], CONTENT_POLICY);
    // With it.
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("webgl.js"), "export {};").unwrap();
    assert!(Script::load(folder.path()).is_err(), "without the licences");
    std::fs::write(folder.path().join("NOTICE.txt"), "licences").unwrap();
    let script = Arc::new(Script::load(folder.path()).unwrap());
    Arc::get_mut(&mut fixture.server).unwrap().viewers = Viewers::new(Device::Cpu, Some(script));
    for part in parts {
        assert_eq!(fixture.status("GET", &at(part), &nobody()), 401, "{part}");
        assert_eq!(fixture.status("GET", &at(part), &auditor), 403, "{part}");
        assert_eq!(fixture.status("GET", &at(part), &low), 404, "{part}: above the ceiling");
        let answer = fixture.get(&at(part), &high);
        assert_eq!(answer.status, 200, "{part}");
        assert_eq!(answer.headers["content-security-policy"], CONTENT_POLICY, "{part}");
    }
    let page = fixture.get(&at(""), &high);
    let policy = page.headers["content-security-policy"].to_str().unwrap();
    assert!(policy.contains("script-src 'self' 'wasm-unsafe-eval'; worker-src blob:;"), "{policy}");
    assert!(!policy.contains("'unsafe-eval'") && !policy.contains("unsafe-inline"), "{policy}");
    assert!(page.text().contains("Draw here (WebGL)"));
    for elsewhere in ["/", "/page.js", &at("frame?w=64&h=64"), &at("page.js")] {
        let answer = fixture.get(elsewhere, &high);
        assert_eq!(
            (answer.status.as_u16(), answer.headers["content-security-policy"].as_bytes()),
            (200, CONTENT_POLICY.as_bytes())
        );
    }
    assert_eq!(fixture.get(&at("webgl.js"), &high).text(), "export {};");
    // As it was published, with its marking in the header and in the file.
    let scene = fixture.get(&at("scene.ply"), &high);
    assert_eq!(scene.headers["x-orb-marking"], "CUI");
    let (drawn, comments) = orb_formats::ply::read(&scene.body).unwrap();
    let (published, _) = orb_formats::ply::read(&ball()).unwrap();
    assert_eq!((drawn.positions, drawn.sh), (published.positions, published.sh));
    assert_eq!(comments, ["CLASSIFICATION: CUI"]);
}
