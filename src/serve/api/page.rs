//! The page: parts of the program, the same for everyone but for the button that signs in by a certificate, which only who
//! came with one gets. What is on it, it asks the interface for.

use std::sync::Arc;

use axum::Router;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse as _, Response};
use axum::routing::get;

use super::Peer;
use crate::audit::marking::Level;
use crate::serve::Server;
use crate::web::guard::{SCRIPT, STYLE, escaped, part};

/// Tells nobody but who has one that there are certificates, and him nothing of whose it is.
const BY_CERTIFICATE: &str = "
    <p><button id=\"by-certificate\" type=\"button\">Sign in by certificate</button>
    <span class=\"soft\">the one that this browser came with</span></p>";

pub fn routes() -> Router<Arc<Server>> {
    Router::new()
        .route("/", get(page))
        .route("/page.css", get(async || part(STYLE, include_str!("../page/page.css"))))
        .route("/page.js", get(async || part(SCRIPT, include_str!("../page/page.js"))))
        .route("/icon.svg", get(async || part("image/svg+xml", include_str!("../../view/page/icon.svg"))))
}

/// The banner says what the server may hold at most, so that it is never below what is shown.
async fn page(State(server): State<Arc<Server>>, Peer(certificate): Peer) -> Response {
    let html = include_str!("../page/index.html")
        .replace("{{by-certificate}}", if certificate.is_some() { BY_CERTIFICATE } else { "" })
        .replace("{{colour}}", colour(server.ceiling.level()))
        .replace("{{banner}}", &escaped(&server.ceiling.banner()));
    ([(header::CONTENT_TYPE, "text/html; charset=utf-8")], html).into_response()
}

fn colour(level: Level) -> &'static str {
    match level {
        Level::Unclassified => "unclassified",
        Level::Cui => "cui",
        Level::Confidential => "confidential",
        Level::Secret => "secret",
        Level::TopSecret => "top-secret",
    }
}
