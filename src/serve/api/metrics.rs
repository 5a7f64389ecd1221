//! Numbers for Prometheus: how much there is of what, and nothing of whom or what.

use std::fmt::Write as _;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};

use super::{Answer, Caller, Refused, blocking};
use crate::serve::Server;
use crate::serve::role::Right;

/// The text format, version 0.0.4.
const TEXT: &str = "text/plain; version=0.0.4; charset=utf-8";

/// Answers by their status' first digit.
#[derive(Default)]
pub struct Counts([AtomicU64; 6]);

impl Counts {
    pub fn answered(&self, status: StatusCode) {
        if let Some(count) = self.0.get(usize::from(status.as_u16() / 100)) {
            count.fetch_add(1, Ordering::Relaxed);
        }
    }
}

/// Metrics for Prometheus
#[utoipa::path(get, path = "/metrics", tag = "server", security(("token" = []), ("session" = [])),
    responses((status = 200, body = String, content_type = "text/plain"), Refused))]
pub async fn show(State(server): State<Arc<Server>>, caller: Caller) -> Answer<Response> {
    blocking(&server, move |server| {
        caller.need(server, Right::Metrics)?;
        let mut out = String::new();
        // Writing to a string cannot fail.
        let mut family = |name: &str, kind: &str, help: &str, values: &[(String, u64)]| {
            let _ = writeln!(out, "# HELP {name} {help}\n# TYPE {name} {kind}");
            for (labels, value) in values {
                let _ = writeln!(out, "{name}{labels} {value}");
            }
        };
        let jobs = server.database.count_by_state()?;
        let jobs: Vec<_> = jobs.into_iter().map(|(s, n)| (format!("{{state=\"{}\"}}", s.name()), n)).collect();
        family("orb_jobs", "gauge", "Jobs by state.", &jobs);
        let stored = server.database.stored()?;
        family("orb_stored_bytes", "gauge", "Bytes of all jobs on the disk.", &[(String::new(), stored)]);
        let answers: Vec<_> = server.counts.0.iter().enumerate().skip(1).collect();
        let answers: Vec<_> =
            answers.iter().map(|(i, n)| (format!("{{class=\"{i}xx\"}}"), n.load(Ordering::Relaxed))).collect();
        family("orb_http_answers_total", "counter", "Answers by the first digit of their status.", &answers);
        Ok(([(header::CONTENT_TYPE, TEXT)], out).into_response())
    })
    .await
}
