//! Taking a submission in: its photos to the disk, its fields judged as `orb geo` would judge them.

use std::collections::BTreeMap;
use std::io::Cursor;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use axum::Json;
use axum::extract::multipart::{Field, MultipartRejection};
use axum::extract::{Multipart, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use image::{ImageFormat, ImageReader};
use tokio::io::AsyncWriteExt as _;
use tokio::time::timeout;
use utoipa::openapi::RefOr;
use utoipa::openapi::schema::{KnownFormat, ObjectBuilder, Schema, SchemaFormat, SchemaType, Type};
use utoipa::{PartialSchema, ToSchema};

use super::jobs::{InFull, told};
use super::{Answer, Caller, Refused, blocking};
use crate::audit::Marking;
use crate::audit::time::format_utc;
use crate::cli::{self, geo};
use crate::serve::database::New;
use crate::serve::refusal::Refusal;
use crate::serve::role::Right;
use crate::serve::submission::Submission;
use crate::serve::{Server, random};
use crate::{Error, Result};

pub const PATH: &str = "/api/v1/jobs";
/// Until the next piece has come, and all of it.
const PIECE_WITHIN: Duration = Duration::from_secs(10);
const ALL_WITHIN: Duration = Duration::from_secs(600);
/// Longest text of a field, bytes, and fields altogether.
const LONGEST: usize = 4 << 10;
const MOST_FIELDS: usize = 64;

/// As a form sends it: a photo, and the fields of [`Submission`] beside it.
pub struct Form;

impl PartialSchema for Form {
    fn schema() -> RefOr<Schema> {
        let mut schema = Submission::schema();
        if let RefOr::T(Schema::Object(object)) = &mut schema {
            let file = SchemaFormat::KnownFormat(KnownFormat::Binary);
            let file = ObjectBuilder::new().schema_type(Type::String).format(Some(file));
            let photo = file.description(Some("JPEG, PNG, WebP or TIFF.")).build();
            object.properties.remove("photos");
            // A form leaves out what it does not say: there is no null in it.
            object.properties.values_mut().for_each(without_null);
            object.properties.insert("photo".into(), photo.into());
            object.required.push("photo".into());
        }
        schema
    }
}

fn without_null(schema: &mut RefOr<Schema>) {
    match schema {
        RefOr::T(Schema::Object(object)) => {
            if let SchemaType::Array(types) = &mut object.schema_type {
                types.retain(|t| *t != Type::Null);
            }
        }
        RefOr::T(Schema::OneOf(one)) => {
            let is_null =
                |s: &RefOr<Schema>| matches!(s, RefOr::T(Schema::Object(o)) if o.schema_type == Type::Null.into());
            one.items.retain(|item| !is_null(item));
        }
        _ => {}
    }
}

impl ToSchema for Form {
    fn schemas(schemas: &mut Vec<(String, RefOr<Schema>)>) {
        Submission::schemas(schemas);
    }
}

/// Submit a photo
#[utoipa::path(post, path = PATH, tag = "jobs", security(("token" = []), ("session" = [])),
    request_body(content = Form, content_type = "multipart/form-data"),
    responses((status = 201, body = InFull, headers(("location" = String, description = "The job's address"))),
        (status = 507, body = Refusal), Refused))]
pub async fn submit(
    State(server): State<Arc<Server>>,
    caller: Caller,
    form: std::result::Result<Multipart, MultipartRejection>,
) -> Answer<Response> {
    caller.need(&server, Right::Submit)?;
    let busy = || Refusal::busy("too many submissions are being taken in");
    let place = timeout(PIECE_WITHIN, Arc::clone(&server.uploads).acquire_owned()).await;
    let _place = place.map_err(|_| busy())?.map_err(|_| busy())?;
    let form = form.map_err(|e| Refusal::unusable(e.body_text()))?;
    let name = caller.name.clone();
    // Before anything is taken in that could not be kept.
    blocking(&server, move |server| has_room(server, &name)).await?;
    let incoming = Incoming::begin(&server).await?;
    let taken = timeout(ALL_WITHIN, take(&server, form, &incoming)).await.map_err(|_| too_slow())??;
    let job = blocking(&server, move |server| accept(server, &caller, taken, incoming)).await?;
    server.live.call();
    server.live.ring();
    let address = format!("{PATH}/{}", job.job.id);
    Ok((StatusCode::CREATED, [(header::LOCATION, address)], Json(job)).into_response())
}

fn too_slow() -> Refusal {
    Refusal::new(StatusCode::REQUEST_TIMEOUT, "TOO_SLOW", "the submission did not come in time")
}

fn full(words: String) -> Refusal {
    Refusal::new(StatusCode::INSUFFICIENT_STORAGE, "FULL", words)
}

fn has_room(server: &Server, account: &str) -> Answer<()> {
    let (all, own) = server.database.unfinished(account)?;
    let (limits, stored) = (&server.limits, server.database.stored()?);
    if all >= limits.queue || own >= limits.queue_each {
        return Err(Refusal::busy(format!("{all} jobs wait or run, {own} of them this account's: no more are taken")));
    }
    if stored >= limits.stored {
        return Err(full(format!("{stored} bytes are stored, {} at most: delete jobs", limits.stored)));
    }
    Ok(())
}

/// The folder of a submission that is being taken in; what does not become a job is gone when this is.
struct Incoming {
    server: Arc<Server>,
    id: String,
}

impl Incoming {
    async fn begin(server: &Arc<Server>) -> Answer<Incoming> {
        let incoming = Incoming { server: Arc::clone(server), id: hex::encode(random::<16>()?) };
        let id = incoming.id.clone();
        blocking(server, move |server| {
            let folder = server.place.begin_incoming(&id)?;
            Ok(crate::audit::disk::Disk::default().create_dir(&folder.join("in"))?)
        })
        .await?;
        Ok(incoming)
    }

    /// Of a photo, before it is known what it is.
    fn part(&self) -> std::path::PathBuf {
        self.server.place.incoming(&self.id).join("in/photo.part")
    }
}

impl Drop for Incoming {
    fn drop(&mut self) {
        if let Err(e) = self.server.place.remove_incoming(&self.id) {
            eprintln!("orb: warning: {e}");
        }
    }
}

/// What a form held.
struct Taken {
    fields: BTreeMap<String, String>,
    /// As the client called it, and its size.
    photo: Option<(String, u64)>,
}

async fn take(server: &Server, mut form: Multipart, incoming: &Incoming) -> Answer<Taken> {
    let mut taken = Taken { fields: BTreeMap::new(), photo: None };
    loop {
        let next = timeout(PIECE_WITHIN, form.next_field()).await.map_err(|_| too_slow())?;
        let Some(field) = next.map_err(unreadable)? else { return Ok(taken) };
        let name = field.name().unwrap_or_default().to_owned();
        if name == "photo" {
            if taken.photo.is_some() {
                return Err(Refusal::unusable("photo: expected one, found more"));
            }
            let called = field.file_name().unwrap_or_default().to_owned();
            let bytes = keep(field, &incoming.part(), server.limits.upload).await?;
            taken.photo = Some((called, bytes));
            continue;
        }
        let text = text(field).await?;
        if taken.fields.len() >= MOST_FIELDS {
            return Err(Refusal::unusable(format!("expected at most {MOST_FIELDS} fields")));
        }
        match taken.fields.get_mut(&name) {
            // A list may come one by one.
            Some(list) if name == "format" => *list = format!("{list},{text}"),
            Some(_) => return Err(Refusal::unusable(format!("{name}: expected once, found more"))),
            None => drop(taken.fields.insert(name, text)),
        }
    }
}

fn unreadable(error: axum::extract::multipart::MultipartError) -> Refusal {
    match error.status() {
        StatusCode::PAYLOAD_TOO_LARGE => Refusal::too_large(error.body_text()),
        _ => Refusal::unusable(error.body_text()),
    }
}

async fn piece(field: &mut Field<'_>) -> Answer<Option<axum::body::Bytes>> {
    timeout(PIECE_WITHIN, field.chunk()).await.map_err(|_| too_slow())?.map_err(unreadable)
}

async fn text(mut field: Field<'_>) -> Answer<String> {
    let mut bytes = Vec::new();
    while let Some(piece) = piece(&mut field).await? {
        bytes.extend_from_slice(&piece);
        if bytes.len() > LONGEST {
            return Err(Refusal::too_large(format!("a field of more than {LONGEST} bytes")));
        }
    }
    String::from_utf8(bytes).map_err(|_| Refusal::unusable("a field that is no UTF-8"))
}

async fn keep(mut field: Field<'_>, path: &Path, limit: u64) -> Answer<u64> {
    let io = |e: std::io::Error| Refusal::from(Error::io(path, &e));
    let mut options = tokio::fs::OpenOptions::new();
    let mut file = options.write(true).create_new(true).open(path).await.map_err(io)?;
    let mut bytes = 0;
    while let Some(piece) = piece(&mut field).await? {
        bytes += piece.len() as u64;
        if bytes > limit {
            return Err(Refusal::too_large(format!("photo: expected at most {limit} bytes")));
        }
        file.write_all(&piece).await.map_err(io)?;
    }
    file.sync_all().await.map_err(io)?;
    Ok(bytes)
}

/// Judges a submission and puts it into the queue.
fn accept(server: &Arc<Server>, caller: &Caller, taken: Taken, incoming: Incoming) -> Answer<InFull> {
    let Some((called, bytes)) = taken.photo.filter(|(_, bytes)| *bytes > 0) else {
        return Err(Refusal::unusable("photo: expected a file, found none"));
    };
    let mut request = Submission::of_fields(taken.fields)?;
    if request.marks() {
        caller.need(server, Right::Mark)?;
    }
    let stem = cli::safe_stem(Path::new(request.name.as_deref().unwrap_or(&called)));
    let photo = std::fs::read(incoming.part()).map_err(|e| Error::io(&incoming.part(), &e))?;
    request.photos = vec![format!("{stem}.{}", ending(&photo, server.limits.pixels)?)];
    request.name = Some(stem);
    let marking = judge(&request, &photo, server.now()).inspect_err(|e| {
        if e.kind == crate::Kind::Policy {
            server.recorder.refused(&caller.name, "MARKING", server.now());
        }
    })?;
    drop(photo);
    check_marking(server, caller, &marking)?;
    let to = server.place.incoming(&incoming.id).join(request.input());
    crate::audit::disk::Disk::default().rename(&incoming.part(), &to)?;
    server.place.accept(&incoming.id)?;
    let id = &incoming.id;
    let (submitted, marking) = (server.now(), marking.banner());
    let job = New { id, account: &caller.name, marking: &marking, request: &request, submitted, bytes };
    if !server.database.add_job(&job, &server.limits)? {
        server.place.remove_job(id)?;
        has_room(server, &caller.name)?;
        return Err(full(format!("{} bytes at most are stored: delete jobs", server.limits.stored)));
    }
    let job = server.database.job(id)?.ok_or_else(Refusal::not_found)?;
    let waiting_before = Some(server.database.waiting_before(job.number)?);
    Ok(InFull { job: told(server, job), waiting_before, result: None })
}

/// By what stands in the file, whatever it is called.
fn ending(photo: &[u8], pixels: u64) -> Result<&'static str> {
    let no_photo = |found: String| Error::usage("photo").expected("JPEG, PNG, WebP or TIFF").found(found);
    let ending = match image::guess_format(photo) {
        Ok(ImageFormat::Jpeg) => "jpg",
        Ok(ImageFormat::Png) => "png",
        Ok(ImageFormat::WebP) => "webp",
        Ok(ImageFormat::Tiff) => "tif",
        _ => return Err(no_photo("something else".into())),
    };
    let reader = ImageReader::new(Cursor::new(photo)).with_guessed_format().map_err(|e| no_photo(e.to_string()))?;
    let (width, height) = reader.into_dimensions().map_err(|e| no_photo(e.to_string()))?;
    if u64::from(width) * u64::from(height) > pixels {
        return Err(Error::usage("photo")
            .expected(format!("at most {pixels} pixels"))
            .found(format!("{width} × {height}")));
    }
    Ok(ending)
}

/// What the run would refuse at its beginning is refused now.
fn judge(request: &Submission, photo: &[u8], now: u64) -> Result<Marking> {
    let args = cli::geo_args(&request.input(), &request.options())?;
    geo::judge(&args, photo, &format_utc(now))
}

fn check_marking(server: &Server, caller: &Caller, marking: &Marking) -> Answer<()> {
    let refuse = |code: &'static str, words: String| {
        server.recorder.refused(&caller.name, code, server.now());
        Err(Refusal::new(StatusCode::FORBIDDEN, code, words))
    };
    if !server.ceiling.covers(marking) {
        return refuse(
            "ABOVE_SERVER_CEILING",
            format!("{marking} is above what this server takes: {}", server.ceiling),
        );
    }
    if !caller.ceiling.covers(marking) {
        return refuse("ABOVE_CEILING", format!("{marking} is above the account's ceiling: {}", caller.ceiling));
    }
    if marking.needs_named_key() && !server.has_key {
        return refuse("KEY_REQUIRED", format!("{marking} needs a key of its own: start the server with --key"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_photo_is_what_stands_in_it() {
        let mut png = Cursor::new(Vec::new());
        image::RgbImage::new(30, 20).write_to(&mut png, ImageFormat::Png).unwrap();
        assert_eq!(ending(png.get_ref(), 600).unwrap(), "png");
        assert!(ending(png.get_ref(), 599).unwrap_err().to_string().contains("30 × 20"));
        for wrong in [&b"#!/bin/sh\n"[..], b"GIF89a", b"", b"\x89PNG\r\n\x1a\n"] {
            assert!(ending(wrong, 600).is_err());
        }
        assert!(crate::serve::place::is_id(&hex::encode(random::<16>().unwrap())));
    }
}
