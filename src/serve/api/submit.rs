//! Taking a submission in: its photos to the disk, its fields judged as `orb geo` would judge them.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use axum::Json;
use axum::extract::multipart::MultipartRejection;
use axum::extract::{Multipart, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse as _, Response};
use tokio::time::timeout;
use utoipa::openapi::RefOr;
use utoipa::openapi::schema::{ArrayBuilder, KnownFormat, ObjectBuilder, Schema, SchemaFormat, SchemaType, Type};
use utoipa::{PartialSchema, ToSchema};

use super::form::{Incoming, PIECE_WITHIN, Taken, last_part, take, too_slow};
use super::jobs::{InFull, told};
use super::{Answer, Caller, Refused, blocking};
use crate::audit::Marking;
use crate::audit::disk::Disk;
use crate::audit::time::format_utc;
use crate::cli::{self, geo};
use crate::photo::{self, Limits};
use crate::serve::Server;
use crate::serve::database::New;
use crate::serve::refusal::Refusal;
use crate::serve::role::Right;
use crate::serve::submission::Submission;
use crate::{Error, Result};

pub const PATH: &str = "/api/v1/jobs";
/// Until all of it has come.
const ALL_WITHIN: Duration = Duration::from_secs(600);
/// Longest name of one of several photos, bytes.
const LONGEST_NAME: usize = 100;

/// As a form sends it: photos, what belongs to them, and the fields of [`Submission`] beside them.
pub struct Form;

impl PartialSchema for Form {
    fn schema() -> RefOr<Schema> {
        let mut schema = Submission::schema();
        if let RefOr::T(Schema::Object(object)) = &mut schema {
            let file = || {
                let format = SchemaFormat::KnownFormat(KnownFormat::Binary);
                ObjectBuilder::new().schema_type(Type::String).format(Some(format))
            };
            let files = |words: &str| ArrayBuilder::new().items(file()).min_items(Some(1)).description(Some(words));
            for made_here in ["photos", "poses", "control", "register"] {
                object.properties.remove(made_here);
            }
            // A form leaves out what it does not say: there is no null in it.
            object.properties.values_mut().for_each(without_null);
            let photos = files("JPEG, HEIC, PNG, WebP or TIFF; several of one subject, each by its own name.");
            object.properties.insert("photo".into(), photos.build().into());
            let poses = files(
                "Of several photos: cameras, images and points3D of a COLMAP model (.bin or .txt), or transforms.json.",
            );
            object.properties.insert("poses".into(), poses.max_items(Some(3)).build().into());
            let control = file().description(Some("Of several photos: ground control points, CSV."));
            object.properties.insert("gcp".into(), control.build().into());
            let register = file().description(Some(
                "For marking officers: country codes beyond those that Orb lists, one at the beginning of each line.",
            ));
            object.properties.insert("country_register".into(), register.build().into());
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
            let null = SchemaType::from(Type::Null);
            one.items.retain(|item| !matches!(item, RefOr::T(Schema::Object(o)) if o.schema_type == null));
        }
        _ => {}
    }
}

impl ToSchema for Form {
    fn schemas(schemas: &mut Vec<(String, RefOr<Schema>)>) {
        Submission::schemas(schemas);
    }
}

/// Submit a photo, or several of one subject
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

/// Judges a submission and puts it into the queue.
fn accept(server: &Arc<Server>, caller: &Caller, taken: Taken, incoming: Incoming) -> Answer<InFull> {
    let Some(first) = taken.photos.first() else {
        return Err(Refusal::unusable("photo: expected a file, found none"));
    };
    let mut request = Submission::of_fields(taken.fields)?;
    request.register = taken.register;
    if request.marks() {
        caller.need(server, Right::Mark)?;
    }
    let stem = cli::safe_stem(Path::new(request.name.as_deref().unwrap_or(first)));
    request.name = Some(stem.clone());
    request.poses = taken.poses.iter().map(|p| (*p).to_owned()).collect();
    request.control = taken.control;
    request.photos = name_photos(&stem, &taken.photos, &incoming, server.limits.pixels)?;
    let folder = incoming.folder();
    let disk = Disk::default();
    disk.create_dir_all(folder.join(request.photo(0)).parent().unwrap_or(&folder))?;
    for number in 0..request.photos.len() {
        disk.rename(&incoming.part(number), &folder.join(request.photo(number)))?;
    }
    let marking = judge(&request, &folder, server.now()).inspect_err(|e| {
        if e.kind == crate::Kind::Policy {
            server.recorder.refused(&caller.name, "MARKING", server.now());
        }
    })?;
    check_marking(server, caller, &marking)?;
    server.place.accept(&incoming.id)?;
    let id = &incoming.id;
    let (submitted, marking, bytes) = (server.now(), marking.banner(), taken.bytes);
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

/// One photo gets the model's name. Several keep their own, since poses and control points name them; a name that could be
/// more than a name is refused.
fn name_photos(stem: &str, called: &[String], incoming: &Incoming, pixels: u64) -> Result<Vec<String>> {
    let mut taken = BTreeSet::new();
    let mut name = |(number, called_so): (usize, &String)| {
        let path = incoming.part(number);
        let photo = std::fs::read(&path).map_err(|e| Error::io(&path, &e))?;
        let endings = endings(&photo, pixels)?;
        if called.len() == 1 {
            return Ok(format!("{stem}.{}", endings[0]));
        }
        let name = own_name(last_part(called_so), endings)?;
        // Two of a name would be one file where case does not count.
        match taken.insert(name.to_lowercase()) {
            true => Ok(name),
            false => Err(Error::usage("photo").expected("a name of its own for each").found(format!("{name} twice"))),
        }
    };
    called.iter().enumerate().map(&mut name).collect()
}

/// A photo's own name, if that is nothing but a name; with an ending that its contents have.
fn own_name(called: &str, endings: &[&str]) -> Result<String> {
    let plain = |c: char| c.is_ascii_alphanumeric() || "._- ()".contains(c);
    if called.len() > LONGEST_NAME || called.starts_with(['.', ' ', '-']) || !called.chars().all(plain) {
        return Err(Error::usage("photo")
            .expected(format!("a file name of at most {LONGEST_NAME} letters, digits and . _ - ( )"))
            .found(format!("{called:?}")));
    }
    let (stem, ending) = called.rsplit_once('.').unwrap_or((called, ""));
    match endings.contains(&ending.to_ascii_lowercase().as_str()) {
        true => Ok(called.to_owned()),
        false => Ok(format!("{stem}.{}", endings[0])),
    }
}

/// By what stands in the file, whatever it is called: the ending that it gets, and those that it may have.
fn endings(bytes: &[u8], pixels: u64) -> Result<&'static [&'static str]> {
    let limits = Limits { pixels, ..Limits::default() };
    let (_, media_type) = photo::metadata("photo", bytes, &limits)?;
    Ok(match media_type {
        "image/jpeg" => &["jpg", "jpeg"],
        "image/heic" => &["heic", "heif"],
        "image/png" => &["png"],
        "image/webp" => &["webp"],
        _ => &["tif", "tiff"],
    })
}

/// What the run would refuse at its beginning is refused now. `folder` is the job's, which no word of an error names.
fn judge(request: &Submission, folder: &Path, now: u64) -> Result<Marking> {
    let mut args = cli::geo_args(&request.input(), &request.options())?;
    let below = |path: &mut Option<std::path::PathBuf>| {
        if let Some(path) = path {
            *path = folder.join(&*path);
        }
    };
    below(&mut args.photo);
    below(&mut args.photos.poses);
    below(&mut args.photos.gcp);
    below(&mut args.publish.marking.country_register);
    geo::judge(&args, &format_utc(now)).map_err(|mut e| {
        let here = format!("{}/", folder.display());
        for words in [&mut e.subject, &mut e.expected, &mut e.found, &mut e.advice] {
            *words = words.replace(&here, "");
        }
        e
    })
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
        let mut png = std::io::Cursor::new(Vec::new());
        image::RgbImage::new(96, 64).write_to(&mut png, image::ImageFormat::Png).unwrap();
        assert_eq!(endings(png.get_ref(), 6144).unwrap(), ["png"]);
        assert!(endings(png.get_ref(), 6143).unwrap_err().to_string().contains("96 × 64"));
        let phone = include_bytes!("../../../tests/data/phone.heic");
        assert_eq!(endings(phone, 48_000).unwrap(), ["heic", "heif"]);
        assert!(endings(phone, 47_999).unwrap_err().to_string().contains("200 × 240"));
        for wrong in [&b"#!/bin/sh\n"[..], b"GIF89a", b"", b"\x89PNG\r\n\x1a\n"] {
            assert!(endings(wrong, 6144).is_err());
        }
    }

    #[test]
    fn a_name_is_a_name() {
        for (called, name) in [
            ("IMG_1 (2).JPG", Some("IMG_1 (2).JPG")),
            ("a.jpeg", Some("a.jpeg")),
            ("a.png", Some("a.jpg")),
            ("a", Some("a.jpg")),
            (".jpg", None),
            ("..", None),
            ("-o.jpg", None),
            ("a\u{0}.jpg", None),
            ("ü.jpg", None),
            (&"x".repeat(101), None),
        ] {
            assert_eq!(own_name(called, &["jpg", "jpeg"]).ok().as_deref(), name, "{called}");
        }
        assert_eq!(last_part("C:\\photos\\../a.jpg"), "a.jpg");
        assert!(crate::serve::place::is_id(&hex::encode(crate::serve::random::<16>().unwrap())));
    }
}
