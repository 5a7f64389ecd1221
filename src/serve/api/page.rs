//! The page: parts of the program, the same for everyone. What is on it, it asks the interface for.

use std::sync::Arc;

use axum::Router;
use axum::extract::State;
use axum::http::header;
use axum::response::{IntoResponse as _, Response};
use axum::routing::get;

use crate::audit::marking::Level;
use crate::serve::Server;
use crate::web::guard::{SCRIPT, STYLE, escaped, part};

pub fn routes() -> Router<Arc<Server>> {
    Router::new()
        .route("/", get(page))
        .route("/page.css", get(async || part(STYLE, include_str!("../page/page.css"))))
        .route("/page.js", get(async || part(SCRIPT, include_str!("../page/page.js"))))
        .route("/icon.svg", get(async || part("image/svg+xml", include_str!("../../view/page/icon.svg"))))
}

/// The banner says what the server may hold at most, so that it is never below what is shown.
async fn page(State(server): State<Arc<Server>>) -> Response {
    let html = include_str!("../page/index.html")
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
