//! Answers that are not what was asked for.

use axum::Json;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use utoipa::ToSchema;

use super::database::SUBJECT;
use crate::{Error, Kind};

/// Why a request is refused.
#[derive(Clone, Debug, Serialize, ToSchema)]
#[schema(as = Error)]
pub struct Refusal {
    #[serde(skip)]
    #[schema(ignore)]
    pub status: StatusCode,
    /// For programs: capitals and underscores.
    pub code: &'static str,
    /// For people.
    pub message: String,
}

impl Refusal {
    pub fn new(status: StatusCode, code: &'static str, message: impl Into<String>) -> Refusal {
        Refusal { status, code, message: message.into() }
    }

    /// Who asks is not known, or no longer.
    pub fn unknown() -> Refusal {
        Refusal::new(StatusCode::UNAUTHORIZED, "NOT_SIGNED_IN", "sign in with the token of an account")
    }

    pub fn forbidden(message: impl Into<String>) -> Refusal {
        Refusal::new(StatusCode::FORBIDDEN, "FORBIDDEN", message)
    }

    /// Also for what exists and is above the caller's ceiling: that it exists is not told either.
    pub fn not_found() -> Refusal {
        Refusal::new(StatusCode::NOT_FOUND, "NOT_FOUND", "there is nothing here")
    }

    pub fn conflict(message: impl Into<String>) -> Refusal {
        Refusal::new(StatusCode::CONFLICT, "CONFLICT", message)
    }

    pub fn unusable(message: impl Into<String>) -> Refusal {
        Refusal::new(StatusCode::UNPROCESSABLE_ENTITY, "UNUSABLE", message)
    }

    pub fn too_large(message: impl Into<String>) -> Refusal {
        Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, "TOO_LARGE", message)
    }

    /// Later it may work.
    pub fn busy(message: impl Into<String>) -> Refusal {
        Refusal::new(StatusCode::SERVICE_UNAVAILABLE, "BUSY", message)
    }

    /// The words go to the server's own log; a caller learns nothing of the machine.
    pub fn internal(error: &Error) -> Refusal {
        eprintln!("orb: {error}");
        Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, "INTERNAL", "the server could not do it; its log says why")
    }
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Refusal {
        match error.kind {
            Kind::Usage => Refusal::unusable(error.to_string()),
            Kind::Environment if error.subject.starts_with(SUBJECT) => {
                eprintln!("orb: {error}");
                Refusal::busy("jobs and accounts cannot be read or kept now; the server's log says why")
            }
            Kind::Policy => Refusal::new(StatusCode::FORBIDDEN, "REFUSED_BY_POLICY", error.to_string()),
            _ => Refusal::internal(&error),
        }
    }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let status = self.status;
        let mut answer = (status, Json(self)).into_response();
        let mut say = |name, value| {
            answer.headers_mut().insert(name, HeaderValue::from_static(value));
        };
        match status {
            StatusCode::UNAUTHORIZED => say(header::WWW_AUTHENTICATE, "Bearer realm=\"orb\""),
            StatusCode::SERVICE_UNAVAILABLE | StatusCode::TOO_MANY_REQUESTS => say(header::RETRY_AFTER, "2"),
            _ => {}
        }
        answer
    }
}
