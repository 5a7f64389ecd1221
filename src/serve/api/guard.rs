//! Before every route: who is called by another name, comes from elsewhere, sends too much or too slowly gets no further.

use std::sync::Arc;
use std::time::Duration;

use axum::body::{Body, HttpBody as _, to_bytes};
use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse as _, Response};
use tokio::time::timeout;

use crate::serve::Server;
use crate::serve::refusal::Refusal;
use crate::web::guard::{MOST_ADDRESS, harden, is_own_name};

/// Bytes of a request that is no submission, and until they have come.
const BODY: usize = 16 << 10;
const BODY_WITHIN: Duration = Duration::from_secs(10);

/// A year of TLS alone, for the name that was asked by.
const TLS_ALONE: HeaderValue = HeaderValue::from_static("max-age=31536000");

pub async fn guard(State(server): State<Arc<Server>>, request: Request, next: Next) -> Response {
    let host = request.headers().get(header::HOST).and_then(|h| h.to_str().ok()).unwrap_or_default();
    // Of `localhost` a browser would believe it for every other program's port too; of addresses it does not (RFC 6797 §8.1.1).
    let says_tls = server.tls && !host.split(':').next().is_some_and(|name| name.eq_ignore_ascii_case("localhost"));
    let mut answer = match check(&server, &request) {
        Err(refusal) => refusal.into_response(),
        Ok(()) => match whole(request).await {
            Err(refusal) => refusal.into_response(),
            Ok(request) => next.run(request).await,
        },
    };
    server.counts.answered(answer.status());
    harden(answer.headers_mut());
    if says_tls {
        answer.headers_mut().insert(header::STRICT_TRANSPORT_SECURITY, TLS_ALONE);
    }
    answer
}

fn check(server: &Server, request: &Request) -> Result<(), Refusal> {
    if !is_own_name(request.headers(), &server.names) {
        let words = "this server answers to its own names only: see --name";
        return Err(Refusal::new(StatusCode::MISDIRECTED_REQUEST, "NOT_MY_NAME", words));
    }
    if request.uri().path_and_query().map_or(0, |p| p.as_str().len()) > MOST_ADDRESS {
        return Err(Refusal::new(StatusCode::URI_TOO_LONG, "ADDRESS_TOO_LONG", "the address is too long"));
    }
    if changes(request.method()) && is_from_elsewhere(request.headers()) {
        return Err(Refusal::forbidden("a page of another server's asked for this"));
    }
    Ok(())
}

/// What a request with this method may change something.
pub fn changes(method: &Method) -> bool {
    !matches!(*method, Method::GET | Method::HEAD | Method::OPTIONS)
}

/// What browsers say of where a request comes from (Fetch Metadata). Programs say nothing.
fn is_from_elsewhere(headers: &HeaderMap) -> bool {
    let site = headers.get("sec-fetch-site").map(|v| v.to_str().unwrap_or("unreadable"));
    site.is_some_and(|site| site != "same-origin" && site != "none")
}

/// A small body is taken in before anyone works on it; a submission is read by its own route, piece by piece.
async fn whole(request: Request) -> Result<Request, Refusal> {
    let is_submission = request.method() == Method::POST && request.uri().path() == super::submit::PATH;
    if is_submission || request.body().is_end_stream() {
        return Ok(request);
    }
    let (head, body) = request.into_parts();
    let body = timeout(BODY_WITHIN, to_bytes(body, BODY)).await;
    let late = |_| Refusal::new(StatusCode::REQUEST_TIMEOUT, "TOO_SLOW", "the request did not come in time");
    let bytes = body.map_err(late)?.map_err(|_| Refusal::too_large(format!("at most {BODY} bytes")))?;
    Ok(Request::from_parts(head, Body::from(bytes)))
}
