//! A server with its folder, its clock and accounts, and what asks it.

use std::io::Cursor;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use axum::body::{Body, to_bytes};
use axum::http::{HeaderMap, Request, StatusCode};
use serde_json::Value;
use tokio::sync::Semaphore;
use tower::ServiceExt as _;

use super::super::administration::By;
use super::super::database::postgres::Address;
use super::super::database::{Database, Ended, State};
use super::super::viewers::Viewers;
use super::super::{Clock, Limits, Server, api, place, recorder};
use super::cluster::{self, Cluster};
use crate::audit::keys::tests::shared_key;
use crate::audit::{DataFolder, Marking, events};
use crate::cli::device::Device;

pub(super) const BEGIN: u64 = 1_790_000_000_000;

/// Where jobs and accounts are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::serve) enum On {
    Sqlite,
    /// A new database of the tests' own server, which must be there.
    Postgres,
}

/// A server with its folder, its clock, and accounts.
pub(super) struct Fixture {
    // The server's connections end before its database's server does.
    pub(super) server: Arc<Server>,
    _folder: tempfile::TempDir,
    _cluster: Option<Arc<Cluster>>,
    pub(super) clock: Arc<AtomicU64>,
    pub(super) runtime: tokio::runtime::Runtime,
}

pub(super) struct Answered {
    pub(super) status: StatusCode,
    pub(super) headers: HeaderMap,
    pub(super) body: Vec<u8>,
}

impl Answered {
    pub(super) fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|e| panic!("{e}: {}", self.text()))
    }
    pub(super) fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }
}

/// How somebody shows who he is.
#[derive(Clone, Default)]
pub(super) struct As {
    pub(super) token: Option<String>,
    pub(super) cookie: Option<String>,
    pub(super) csrf: Option<String>,
}

impl From<&str> for As {
    fn from(token: &str) -> As {
        As { token: Some(token.to_owned()), ..As::default() }
    }
}

pub(super) fn nobody() -> As {
    As::default()
}

impl Fixture {
    pub(super) fn new(on: On) -> Fixture {
        Fixture::with(on, |_| {})
    }

    pub(super) fn with(on: On, change: impl FnOnce(&mut Limits)) -> Fixture {
        let folder = tempfile::tempdir().unwrap();
        let data = DataFolder::at(folder.path().join("data"));
        let keys = data.subfolder("keys").unwrap();
        shared_key().save(&keys.join("orb-signing.pem"), None).unwrap();
        let clock = Arc::new(AtomicU64::new(BEGIN));
        let own = Arc::clone(&clock);
        let now: Clock = Arc::new(move || own.load(Ordering::Relaxed));
        let mut limits = Limits::default();
        change(&mut limits);
        let place = place::Place::open(&data).unwrap();
        let cluster = (on == On::Postgres).then(|| cluster::shared().unwrap());
        let database = match &cluster {
            None => Database::file(&place.database()).unwrap(),
            Some(cluster) => {
                let url = cluster.url("orb", &cluster.create());
                Database::at(Address::new(&url, None, None, BEGIN).unwrap(), place.name().unwrap()).unwrap()
            }
        };
        database.hold().unwrap();
        let places = |n| Arc::new(Semaphore::new(n));
        let server = Server {
            database,
            place,
            sessions: Default::default(),
            live: Default::default(),
            recorder: recorder::Recorder::new(data, "orb serve", crate::cli::argv::caller()),
            trail: Default::default(),
            viewers: Viewers::new(Device::Cpu, None),
            limits,
            ceiling: Marking::parse("SECRET").unwrap(),
            has_key: false,
            names: vec!["orb.example".into()],
            encrypted: false,
            tls: false,
            clock: now,
            counts: Default::default(),
            uploads: places(4),
            downloads: places(4),
            streams: places(4),
            checks: places(1),
        };
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        Fixture { server: Arc::new(server), _folder: folder, _cluster: cluster, clock, runtime }
    }

    pub(super) fn account(&self, name: &str, roles: &str, ceiling: &str) -> String {
        let (database, recorder) = (&self.server.database, &self.server.recorder);
        let by = By { database, recorder, actor: None, now: self.server.now() };
        by.add(name, roles.parse().unwrap(), Marking::parse(ceiling).unwrap(), 30).unwrap().to_string()
    }

    pub(super) fn send(&self, request: Request<Body>) -> Answered {
        let router = api::router(Arc::clone(&self.server));
        self.runtime.block_on(async {
            let (head, body) = router.oneshot(request).await.unwrap().into_parts();
            let body = to_bytes(body, 1 << 28).await.unwrap().to_vec();
            Answered { status: head.status, headers: head.headers, body }
        })
    }

    pub(super) fn ask(&self, method: &str, path: &str, who: &As, body: Option<Value>) -> Answered {
        let mut request = Request::builder().method(method).uri(path).header("host", "localhost:8080");
        if let Some(token) = &who.token {
            request = request.header("authorization", format!("Bearer {token}"));
        }
        if let Some(cookie) = &who.cookie {
            request = request.header("cookie", format!("other=1; orb_session={cookie}"));
        }
        if let Some(csrf) = &who.csrf {
            request = request.header("x-orb-csrf", csrf);
        }
        let body = match body {
            Some(value) => {
                request = request.header("content-type", "application/json");
                Body::from(value.to_string())
            }
            None => Body::empty(),
        };
        self.send(request.body(body).unwrap())
    }

    pub(super) fn get(&self, path: &str, who: &As) -> Answered {
        self.ask("GET", path, who, None)
    }

    pub(super) fn status(&self, method: &str, path: &str, who: &As) -> u16 {
        self.ask(method, path, who, None).status.as_u16()
    }

    pub(super) fn submit(&self, who: &As, fields: &[(&str, &str)], files: &[(&str, &[u8])]) -> Answered {
        let mut body = Vec::new();
        for (name, value) in fields {
            body.extend(format!("--X\r\nContent-Disposition: form-data; name=\"{name}\"\r\n\r\n{value}\r\n").bytes());
        }
        for (name, bytes) in files {
            let head = format!("--X\r\nContent-Disposition: form-data; name=\"photo\"; filename=\"{name}\"\r\n\r\n");
            body.extend(head.bytes().chain(bytes.iter().copied()).chain(*b"\r\n"));
        }
        body.extend(b"--X--\r\n");
        let request = Request::builder()
            .method("POST")
            .uri("/api/v1/jobs")
            .header("host", "localhost")
            .header("authorization", format!("Bearer {}", who.token.clone().unwrap_or_default()))
            .header("content-type", "multipart/form-data; boundary=X");
        self.send(request.body(Body::from(body)).unwrap())
    }

    pub(super) fn submitted(&self, who: &As) -> String {
        let answer = self.submit(who, &[("origin", "34.5,-118.4,740")], &[("van.png", &photo(64, 64))]);
        assert_eq!(answer.status, 201, "{}", answer.text());
        answer.json()["id"].as_str().unwrap().to_owned()
    }

    /// As if the runner had run the job that has waited longest.
    pub(super) fn finish(&self, files: &[(&str, &[u8])]) -> String {
        let job = self.server.database.take(self.server.now()).unwrap().unwrap();
        let out = self.server.place.published(&job.id, job.attempt);
        for (name, bytes) in files {
            let path = out.join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, bytes).unwrap();
        }
        let ended =
            Ended { state: State::Done, exit_code: Some(0), error: None, result: None, marking: None, bytes: 10 };
        self.server.database.end(&job.id, &ended, self.server.now()).unwrap();
        job.id
    }

    /// The kinds and codes of the ledger's events.
    pub(super) fn ledger(&self) -> Vec<String> {
        self.server.recorder.flush(self.server.now(), true);
        let path = self.server.recorder.data().path().join("ledger/orb-ledger.jsonl");
        let text = events::list(&path).unwrap();
        text.lines().map(|l| l.split_whitespace().skip(2).collect::<Vec<_>>().join(" ")).collect()
    }
}

pub(super) fn photo(width: u32, height: u32) -> Vec<u8> {
    let mut png = Cursor::new(Vec::new());
    let pixels = image::RgbImage::from_fn(width, height, |x, y| image::Rgb([x as u8, y as u8, 128]));
    pixels.write_to(&mut png, image::ImageFormat::Png).unwrap();
    png.into_inner()
}

/// Every operation of the document, `{…}` filled in with what is a name and names nothing.
pub(super) fn operations() -> Vec<(String, String)> {
    let document = serde_json::to_value(api::document()).unwrap();
    let mut out = Vec::new();
    for (path, item) in document["paths"].as_object().unwrap() {
        let path = path.replace("{id}", &"0".repeat(32)).replace("{*name}", "preview.png").replace("{name}", "nobody");
        let path = path.replace("{sha256}", &"0".repeat(64));
        for method in item.as_object().unwrap().keys().filter(|m| *m != "parameters") {
            out.push((method.to_uppercase(), path.clone()));
        }
    }
    out
}
