//! The routes, as a function from requests to answers, and the guard before all of them.
//!
//! Every address begins with the token. No part of a request is a path on the disk: what is served was read before.

use std::sync::Arc;

use aws_lc_rs::constant_time::verify_slices_are_equal;
use axum::Router;
use axum::body::{Body, HttpBody as _};
use axum::extract::rejection::QueryRejection;
use axum::extract::{Query as Asked, Request, State};
use axum::http::{HeaderValue, StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use serde_json::json;

use super::query::{FIELD, Query, Show};
use super::subject::Subject;
use super::webgl::Webgl;
use super::worker::{Refusal, Worker};
use super::{draw, ground, webgl};
use crate::export::{EXPECTED_ERROR, PROVENANCE};
use crate::preview::LARGEST_ERROR;
use crate::web::guard::{MOST_ADDRESS, SCRIPT, STYLE, escaped, harden, is_own_name, part, refuse};
use crate::{Error, Result};

/// What the routes know.
pub struct Site {
    pub subject: Arc<Subject>,
    pub worker: Worker,
    /// What the page draws with itself, where it may.
    pub webgl: Option<Webgl>,
}

/// 128 random bits, as hexadecimal digits.
///
/// # Errors
/// Environment, without random numbers.
pub fn token() -> Result<String> {
    let mut bytes = [0u8; 16];
    getrandom::fill(&mut bytes).map_err(|e| Error::environment("random numbers").found(e.to_string()))?;
    Ok(hex::encode(bytes))
}

/// What the page of one scene asks for, below `prefix`; the guard is the caller's.
pub fn scene_routes(prefix: &str) -> Router<Arc<Site>> {
    let at = |name: &str| format!("{prefix}/{name}");
    Router::new()
        .route(&at(""), get(page))
        .route(&at("page.css"), get(async || part(STYLE, include_str!("page/page.css"))))
        .route(&at("page.js"), get(async || part(SCRIPT, include_str!("page/page.js"))))
        .route(&at("camera.js"), get(async || part(SCRIPT, include_str!("page/camera.js"))))
        .route(&at("icon.svg"), get(async || part("image/svg+xml", include_str!("page/icon.svg"))))
        .route(&at("scene.json"), get(scene))
        .route(&at("frame"), get(frame))
        .route(&at("point"), get(point))
        .route(&at("photo"), get(photo))
        .route(&at("webgl.js"), get(async |State(site): State<Arc<Site>>| webgl::script(site.webgl.as_ref())))
        .route(&at("notice.txt"), get(async |State(site): State<Arc<Site>>| webgl::notice(site.webgl.as_ref())))
        .route(&at("scene.ply"), get(scene_itself))
}

/// One scene below a token, with the guard before it.
pub fn router(site: Arc<Site>, token: String) -> Router {
    scene_routes("/{token}")
        .fallback(async || refuse(StatusCode::NOT_FOUND, "not found"))
        .layer(middleware::from_fn_with_state(Arc::<str>::from(token), guard))
        .with_state(site)
}

/// Lets through who knows the token and asks this server by its own name; the rest learns nothing.
async fn guard(State(token): State<Arc<str>>, request: Request<Body>, next: Next) -> Response {
    let mut answer = match check(&token, &request) {
        Some(refused) => refused,
        None => next.run(request).await,
    };
    harden(answer.headers_mut());
    answer
}

fn check(token: &str, request: &Request<Body>) -> Option<Response> {
    if !is_own_name(request.headers(), &[]) {
        // A name of someone else's that leads here: DNS rebinding.
        return Some(refuse(StatusCode::MISDIRECTED_REQUEST, "this server answers to localhost and to addresses only"));
    }
    if request.uri().path_and_query().map_or(0, |p| p.as_str().len()) > MOST_ADDRESS {
        return Some(refuse(StatusCode::URI_TOO_LONG, "the address is too long"));
    }
    let given = request.uri().path().split('/').nth(1).unwrap_or_default();
    if verify_slices_are_equal(given.as_bytes(), token.as_bytes()).is_err() {
        return Some(refuse(StatusCode::NOT_FOUND, "not found"));
    }
    if !request.body().is_end_stream() {
        return Some(refuse(StatusCode::PAYLOAD_TOO_LARGE, "no request to this server has a body"));
    }
    None
}

async fn page(State(site): State<Arc<Site>>) -> Response {
    let subject = &site.subject;
    let html = webgl::onto_page(site.webgl.as_ref(), include_str!("page/index.html"))
        .replace("{{banner}}", &escaped(&subject.banner()))
        .replace("{{colour}}", subject.colour())
        // Last: a name may hold anything.
        .replace("{{name}}", &escaped(&subject.name));
    let mut answer = ([(header::CONTENT_TYPE, "text/html; charset=utf-8")], html).into_response();
    webgl::loosen(site.webgl.as_ref(), &mut answer);
    answer
}

async fn scene_itself(State(site): State<Arc<Site>>) -> Response {
    let made = tokio::task::spawn_blocking(move || webgl::scene(site.webgl.as_ref(), &site.subject)).await;
    made.unwrap_or_else(|_| refuse(StatusCode::INTERNAL_SERVER_ERROR, "the scene could not be written"))
}

async fn scene(State(site): State<Arc<Site>>) -> Response {
    let subject = &site.subject;
    let levels =
        subject.levels.iter().map(|l| json!({"vertices": l.mesh.positions.len(), "triangles": l.mesh.triangles.len()}));
    let place = subject.place.map(|p| {
        let known = subject.heading_known.as_ref();
        json!({
            "latitude": p.origin.latitude, "longitude": p.origin.longitude, "height": p.origin.height,
            "heading": p.heading, "heading_source": known.map(|k| &k.0), "heading_sigma": known.map(|k| &k.1),
        })
    });
    let object = json!({
        "name": subject.name, "banner": subject.banner(), "metric": subject.metric,
        "scale": subject.scale_known, "centre": subject.centre.to_array(), "radius": subject.radius, "field": FIELD,
        "gaussians": subject.gaussians.as_ref().map_or(0, |g| g.len()), "levels": levels.collect::<Vec<_>>(),
        "provenance": subject.provenance.is_some(), "error": subject.expected_error.is_some(), "largest_error": LARGEST_ERROR, "assumed": subject.assumed, "photo": subject.photo.is_some(), "photo_elevation": subject.photo_elevation,
        "place": place, "grid_step": ground::step(subject.radius), "notes": subject.notes,
    });
    ([(header::CONTENT_TYPE, "application/json")], object.to_string()).into_response()
}

type AskedFor = Result<Asked<Query>, QueryRejection>;

async fn frame(State(site): State<Arc<Site>>, asked: AskedFor) -> Result<Response, Response> {
    let (query, camera) = understood(&site, asked).map_err(|e| refuse(StatusCode::BAD_REQUEST, &e))?;
    let (jpeg, took) = site.worker.picture(query, camera).await.map_err(no_answer)?;
    let timing = format!("draw;dur={:.1}", took.as_secs_f64() * 1e3);
    let headers =
        [(header::CONTENT_TYPE, "image/jpeg".to_owned()), (header::HeaderName::from_static("server-timing"), timing)];
    Ok((headers, jpeg).into_response())
}

async fn point(State(site): State<Arc<Site>>, asked: AskedFor) -> Result<Response, Response> {
    let (query, camera) = understood(&site, asked).map_err(|e| refuse(StatusCode::BAD_REQUEST, &e))?;
    let point = site.worker.point(query, camera).await.map_err(no_answer)?;
    let place = |p: &draw::Point| {
        let on_earth = site.subject.place?.to_geodetic(p.at.map(f64::from));
        Some(json!({"latitude": on_earth.latitude, "longitude": on_earth.longitude, "height": on_earth.height}))
    };
    let object = json!({ "point": point, "place": point.as_ref().and_then(place) });
    Ok(([(header::CONTENT_TYPE, "application/json")], object.to_string()).into_response())
}

async fn photo(State(site): State<Arc<Site>>) -> Response {
    match &site.subject.photo {
        Some(jpeg) => ([(header::CONTENT_TYPE, "image/jpeg")], jpeg.clone()).into_response(),
        None => refuse(StatusCode::NOT_FOUND, "not found"),
    }
}

fn understood(site: &Site, asked: AskedFor) -> Result<(Query, crate::splat::Camera), String> {
    let Asked(query) = asked.map_err(|e| e.body_text())?;
    if query.show == Show::Provenance && site.subject.provenance.is_none() {
        return Err(format!("show: expected a folder with a model and its {PROVENANCE}, found none"));
    }
    if query.show == Show::Error && site.subject.expected_error.is_none() {
        return Err(format!("show: expected a folder with a model and its {EXPECTED_ERROR}, found none"));
    }
    let camera = query.camera(site.subject.centre, site.subject.radius)?;
    Ok((query, camera))
}

fn no_answer(refusal: Refusal) -> Response {
    match refusal {
        Refusal::Busy => {
            let mut answer = refuse(StatusCode::SERVICE_UNAVAILABLE, "too many pictures are asked for at once");
            answer.headers_mut().insert(header::RETRY_AFTER, HeaderValue::from_static("1"));
            answer
        }
        Refusal::Gone => refuse(StatusCode::INTERNAL_SERVER_ERROR, "the renderer has ended: start orb view again"),
        Refusal::Failed(e) => refuse(StatusCode::INTERNAL_SERVER_ERROR, &e.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use axum::http::HeaderMap;
    use tower::ServiceExt as _;

    use super::*;
    use crate::splat::Gaussians;
    use crate::view::draw::{Draw, Splats};
    use crate::web::guard::CONTENT_POLICY;

    /// One red ball of 8 cm, a metre above the origin, 34.5° north, the camera having looked east.
    fn subject() -> Subject {
        let red = std::array::from_fn(|k| if k == 0 { [1.7, -1.7, -1.7] } else { [0.0; 3] });
        let place = crate::geo::Placement {
            origin: crate::geo::Geodetic { latitude: 34.5, longitude: -118.5, height: 740.0 },
            heading: 90.0,
            heading_source: crate::geo::HeadingSource::Given,
        };
        Subject {
            name: "<ball> \"1\"".into(),
            marking: None,
            gaussians: Some(Gaussians {
                positions: vec![glam::Vec3::Z],
                log_scales: vec![glam::Vec3::splat(-2.5)],
                rotations: vec![[1.0, 0.0, 0.0, 0.0]],
                logit_opacities: vec![8.0],
                sh: vec![red],
            }),
            levels: Vec::new(),
            provenance: None,
            expected_error: None,
            assumed: false,
            place: Some(place),
            metric: true,
            centre: glam::Vec3::Z,
            radius: 0.5,
            photo: None,
            photo_elevation: None,
            heading_known: None,
            scale_known: None,
            notes: Vec::new(),
        }
    }

    fn ask(method: &str, path: &str, host: &str, body: &'static str) -> (StatusCode, HeaderMap, Vec<u8>) {
        let subject = Arc::new(subject());
        let (worker, thread) = Worker::start(Arc::clone(&subject), || Ok(None)).unwrap();
        let router = router(Arc::new(Site { subject, worker, webgl: None }), "0123".repeat(8));
        let request = Request::builder().method(method).uri(path).header("host", host).body(Body::from(body)).unwrap();
        let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
        let answer = runtime.block_on(async {
            let answer = router.oneshot(request).await.unwrap();
            let (head, body) = answer.into_parts();
            (head.status, head.headers, axum::body::to_bytes(body, 1 << 24).await.unwrap().to_vec())
        });
        thread.join().unwrap();
        answer
    }

    #[test]
    fn names_of_others_and_wrong_tokens_learn_nothing() {
        let own = format!("/{}/scene.json", "0123".repeat(8));
        for (method, path, host, body, expected) in [
            ("GET", own.as_str(), "localhost", "", 200),
            ("GET", &own, "LOCALHOST:1", "", 200),
            ("GET", &own, "127.0.0.1:8080", "", 200),
            ("GET", &own, "[::1]", "", 200),
            ("GET", &own, "orb.example", "", 421),
            ("GET", &own, "localhost.example:80", "", 421),
            ("GET", &own, "127.0.0.1:x", "", 421),
            ("GET", &own, "[::1", "", 421),
            ("GET", "/", "localhost", "", 404),
            ("GET", "/0123/scene.json", "localhost", "", 404),
            ("GET", &own.replacen('0', "1", 1), "localhost", "", 404),
            ("GET", &own.replace("scene.json", "photo"), "localhost", "", 404),
            ("GET", &own.replace("scene.json", "..%2f..%2fscene.ply"), "localhost", "", 404),
            ("POST", &own, "localhost", "", 405),
            ("PUT", &own, "localhost", "x", 413),
            ("GET", &own.replace("scene.json", "frame?show=x-ray"), "localhost", "", 400),
            ("GET", &own.replace("scene.json", "frame?show=provenance"), "localhost", "", 400),
            ("GET", &own.replace("scene.json", "frame?show=error"), "localhost", "", 400),
            ("GET", &own.replace("scene.json", "frame?w=-1"), "localhost", "", 400),
            ("GET", &own.replace("scene.json", "frame?el=91"), "localhost", "", 400),
            ("GET", &format!("{own}?{}", "x".repeat(MOST_ADDRESS)), "localhost", "", 414),
        ] {
            let (status, headers, text) = ask(method, path, host, body);
            assert_eq!(status.as_u16(), expected, "{method} {path} {host}");
            assert_eq!(headers["content-security-policy"], CONTENT_POLICY);
            assert_eq!(headers["referrer-policy"], "no-referrer");
            assert!(expected == 200 || !String::from_utf8_lossy(&text).contains("ball"), "{method} {path} {host}");
        }
    }

    #[test]
    fn the_page_holds_the_banner_and_no_name_breaks_out_of_it() {
        let (_, _, html) = ask("GET", &format!("/{}/", "0123".repeat(8)), "localhost", "");
        let html = String::from_utf8(html).unwrap();
        assert_eq!(html.matches("</span>UNMARKED</p>").count(), 2);
        assert!(
            html.contains("<h1>&lt;ball&gt; &quot;1&quot;</h1>") && !html.contains("<ball>") && !html.contains("{{")
        );
        assert!(!html.contains("http:") && !html.contains("https:"), "nothing from elsewhere");
    }

    #[test]
    fn a_point_is_where_the_ball_is_and_beside_it_the_ground() {
        let own = format!("/{}/", "0123".repeat(8));
        let point = |rest: &str| {
            let (_, _, json) = ask("GET", &format!("{own}point?w=400&h=300&az=30&el=40&{rest}"), "localhost", "");
            serde_json::from_slice::<serde_json::Value>(&json).unwrap()
        };
        let ball = point("x=200&y=150");
        let at: Vec<f64> = ball["point"]["at"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
        assert!(at[0].abs() < 0.01 && at[1].abs() < 0.01 && (at[2] - 1.0).abs() < 0.01, "{ball}");
        assert!((ball["place"]["height"].as_f64().unwrap() - 741.0).abs() < 0.01, "{ball}");
        let ground = point("x=200&y=290");
        assert!(
            ground["point"]["ground"].as_bool().unwrap() && ground["point"]["at"][2].as_f64().unwrap().abs() < 1e-4
        );
        assert!(point("x=200&y=290&grid=false")["point"].is_null());
    }

    #[test]
    fn pictures_show_what_is_asked_for() {
        let subject = subject();
        let mut draw = Draw::new(&subject, Some(Splats::new(subject.gaussians.as_ref().unwrap(), None).unwrap()));
        let mut middle = |show, dark| {
            let query = Query { w: 64, h: 48, el: 0.0, grid: false, show, dark, ..Query::default() };
            let jpeg = draw.picture(&query, &query.camera(subject.centre, subject.radius).unwrap()).unwrap();
            let image = image::load_from_memory(&jpeg).unwrap().into_rgb8();
            assert_eq!(image.dimensions(), (64, 48));
            (image.get_pixel(32, 24).0, image.get_pixel(2, 2).0)
        };
        let close = |a: [u8; 3], b: [u8; 3]| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) < 24);
        let (ball, paper) = middle(Show::Colour, false);
        assert!(close(ball, [249, 5, 5]) && close(paper, [247; 3]), "{ball:?} {paper:?}");
        assert!(close(middle(Show::Colour, true).1, [23; 3]));
        // Half way between nearest and farthest.
        let (ball, _) = middle(Show::Depth, false);
        assert!(close(ball, [33, 145, 140]), "{ball:?}");
    }

    #[test]
    fn where_the_texture_comes_from_is_shown_on_the_finest_level() {
        let corner = |x: f32, z: f32| glam::Vec3::new(x, 0.0, 1.0 + z);
        let mesh = crate::mesh::Mesh {
            positions: vec![corner(-0.4, -0.4), corner(0.4, -0.4), corner(0.0, 0.4)],
            normals: vec![glam::Vec3::NEG_Y; 3],
            uvs: vec![glam::Vec2::splat(0.5); 3],
            triangles: vec![[0, 1, 2]],
        };
        let texture = image::RgbImage::from_pixel(2, 2, image::Rgb(crate::mesh::provenance::SEEN));
        let level = crate::view::subject::Level { mesh, texture };
        let subject = Subject { provenance: Some(level), ..subject() };
        let mut draw = Draw::new(&subject, Some(Splats::new(subject.gaussians.as_ref().unwrap(), None).unwrap()));
        let query = Query { w: 64, h: 48, az: 0.0, el: 0.0, grid: false, show: Show::Provenance, ..Query::default() };
        let jpeg = draw.picture(&query, &query.camera(subject.centre, subject.radius).unwrap()).unwrap();
        let [r, g, b] = image::load_from_memory(&jpeg).unwrap().into_rgb8().get_pixel(32, 24).0;
        assert!(r < 24 && g.abs_diff(158) < 24 && b.abs_diff(115) < 24, "{r} {g} {b}");
    }
}
