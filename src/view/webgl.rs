//! What a page needs to draw the scene itself: a script built from `viewer/`, read at the start where `--webgl` names it,
//! and the Gaussians as PLY. Without it none of this is there.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use axum::body::Bytes;
use axum::http::header::{CONTENT_SECURITY_POLICY, CONTENT_TYPE};
use axum::http::{HeaderName, HeaderValue, StatusCode};
use axum::response::{IntoResponse as _, Response};

use super::subject::Subject;
use crate::audit::canonical::sha256_hex;
use crate::audit::{Marking, disk};
use crate::export;
use crate::web::guard::{SCRIPT, refuse};
use crate::{Error, Result};

/// What `npm run build` makes in `viewer/dist`.
const NAME: &str = "webgl.js";
const NOTICE: &str = "NOTICE.txt";
/// Largest files, bytes.
const SCRIPT_BYTES: u64 = 16 << 20;
const NOTICE_BYTES: u64 = 1 << 20;
/// [`crate::web::guard::CONTENT_POLICY`], and the two things that Spark needs beyond it: it compiles WebAssembly and runs it in
/// workers that it makes of its own text. Scripts still come from this server alone, and `eval` stays forbidden.
const POLICY: HeaderValue = HeaderValue::from_static(
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; img-src 'self' blob:; base-uri 'none'; \
     form-action 'none'; frame-ancestors 'none'; object-src 'none'",
);
const MARKING: HeaderName = HeaderName::from_static("x-orb-marking");
/// Parts of the page.
const SWITCH: &str = "
    <button id=\"webgl\" type=\"button\" aria-pressed=\"false\" aria-keyshortcuts=\"w\">Draw here (WebGL)</button>";
const ABOUT: &str = "
    <p>W draws the Gaussians' colour in this browser instead of on the server, and back: \
     <a href=\"notice.txt\">licences of what draws here</a>.</p>";

/// The script.
#[derive(Clone, Debug)]
pub struct Script {
    text: Bytes,
    /// Licences of what is in it.
    notice: Bytes,
}

impl Script {
    /// Reads it from the folder that it was built in.
    ///
    /// # Errors
    /// Usage for a folder in which it was not built, and for files that are too large to be it.
    pub fn load(folder: &Path) -> Result<Script> {
        let read = |name: &str, limit| {
            let path = folder.join(name);
            if !path.is_file() {
                return Err(Error::usage("--webgl")
                    .expected(format!("a folder in which the WebGL viewer was built, with {name}"))
                    .found(format!("no file {}", path.display()))
                    .advice(
                        "`npm ci && npm run build` in Orb's viewer/ builds it in viewer/dist: --webgl viewer/dist",
                    ));
            }
            disk::read_limited(&path, limit).map(Bytes::from)
        };
        Ok(Script { text: read(NAME, SCRIPT_BYTES)?, notice: read(NOTICE, NOTICE_BYTES)? })
    }

    pub fn sha256(&self) -> String {
        sha256_hex(&self.text)
    }
}

/// The script and the scene that it draws.
pub struct Webgl {
    script: Arc<Script>,
    /// Made when it is first asked for: who looks at streamed pictures needs none.
    ply: OnceLock<Bytes>,
}

impl Webgl {
    /// `None` for a scene without Gaussians: there is nothing for it to draw.
    pub fn new(script: Option<&Arc<Script>>, subject: &Subject) -> Option<Webgl> {
        let script = script.filter(|_| subject.gaussians.is_some())?;
        Some(Webgl { script: Arc::clone(script), ply: OnceLock::new() })
    }

    /// The Gaussians as they stand in the subject frame, whatever file they came from.
    fn scene(&self, subject: &Subject) -> Result<Bytes> {
        if let Some(ply) = self.ply.get() {
            return Ok(ply.clone());
        }
        let Some(gaussians) = &subject.gaussians else { return Ok(Bytes::new()) };
        let made = Bytes::from(export::subject_ply(gaussians, subject.marking.as_ref())?);
        Ok(self.ply.get_or_init(|| made).clone())
    }
}

/// The page with what changes over to drawing in the browser, where that is there.
pub fn onto_page(webgl: Option<&Webgl>, html: &str) -> String {
    let (switch, about) = if webgl.is_some() { (SWITCH, ABOUT) } else { ("", "") };
    html.replace("{{webgl-switch}}", switch).replace("{{webgl-about}}", about)
}

/// Lets the page do what drawing in the browser needs.
pub fn loosen(webgl: Option<&Webgl>, page: &mut Response) {
    if webgl.is_some() {
        page.headers_mut().insert(CONTENT_SECURITY_POLICY, POLICY);
    }
}

pub fn script(webgl: Option<&Webgl>) -> Response {
    of(webgl, |w| ([(CONTENT_TYPE, SCRIPT)], w.script.text.clone()).into_response())
}

pub fn notice(webgl: Option<&Webgl>) -> Response {
    of(webgl, |w| ([(CONTENT_TYPE, "text/plain; charset=utf-8")], w.script.notice.clone()).into_response())
}

/// The Gaussians. The first time that takes a moment, and so is no work for the thread that answers.
pub fn scene(webgl: Option<&Webgl>, subject: &Subject) -> Response {
    of(webgl, |w| match w.scene(subject) {
        Ok(ply) => {
            let mut answer = ([(CONTENT_TYPE, "application/ply")], ply).into_response();
            let banner = subject.marking.as_ref().map(Marking::banner);
            if let Some(Ok(banner)) = banner.map(|b| HeaderValue::from_str(&b)) {
                answer.headers_mut().insert(MARKING, banner);
            }
            answer
        }
        Err(e) => refuse(StatusCode::INTERNAL_SERVER_ERROR, &e.to_string()),
    })
}

fn of(webgl: Option<&Webgl>, answer: impl FnOnce(&Webgl) -> Response) -> Response {
    webgl.map_or_else(|| refuse(StatusCode::NOT_FOUND, "not found"), answer)
}
