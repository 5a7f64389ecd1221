//! A submission's form, read piece by piece: its files to the disk under names that the server makes, its fields into memory.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use axum::extract::Multipart;
use axum::extract::multipart::Field;
use axum::http::StatusCode;
use tokio::io::AsyncWriteExt as _;
use tokio::time::timeout;

use super::{Answer, blocking};
use crate::Error;
use crate::serve::refusal::Refusal;
use crate::serve::submission::REGISTER;
use crate::serve::{Server, random};

/// Until the next piece has come.
pub const PIECE_WITHIN: Duration = Duration::from_secs(10);
/// Longest text of a field, bytes, and fields altogether.
const LONGEST: usize = 4 << 10;
const MOST_FIELDS: usize = 64;
/// What says where cameras stood: COLMAP's files, or a list. These are the names that they get.
const POSES: [&str; 7] =
    ["cameras.bin", "cameras.txt", "images.bin", "images.txt", "points3D.bin", "points3D.txt", "transforms.json"];
/// Bytes of control points.
const CONTROL: u64 = 1 << 20;

/// The folder of a submission that is being taken in; what does not become a job is gone when this is.
pub struct Incoming {
    server: Arc<Server>,
    pub id: String,
}

impl Incoming {
    pub async fn begin(server: &Arc<Server>) -> Answer<Incoming> {
        let incoming = Incoming { server: Arc::clone(server), id: hex::encode(random::<16>()?) };
        let id = incoming.id.clone();
        blocking(server, move |server| {
            let folder = server.place.begin_incoming(&id)?;
            Ok(crate::audit::disk::Disk::default().create_dir(&folder.join("in"))?)
        })
        .await?;
        Ok(incoming)
    }

    pub fn folder(&self) -> PathBuf {
        self.server.place.incoming(&self.id)
    }

    /// Of a photo, before it is known what it is.
    pub fn part(&self, number: usize) -> PathBuf {
        self.folder().join(format!("in/photo-{number}.part"))
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
#[derive(Default)]
pub struct Taken {
    pub fields: BTreeMap<String, String>,
    /// As the client called them.
    pub photos: Vec<String>,
    /// Of [`POSES`].
    pub poses: Vec<&'static str>,
    pub control: bool,
    pub register: bool,
    /// Of all files.
    pub bytes: u64,
}

/// Reads all of a form.
///
/// # Errors
/// 408, 413, 422; the words of the disk's troubles stay here.
pub async fn take(server: &Server, mut form: Multipart, incoming: &Incoming) -> Answer<Taken> {
    let mut taken = Taken::default();
    loop {
        let next = timeout(PIECE_WITHIN, form.next_field()).await.map_err(|_| too_slow())?;
        let Some(field) = next.map_err(unreadable)? else { return Ok(taken) };
        let name = field.name().unwrap_or_default().to_owned();
        if !["photo", "poses", "gcp", "country_register"].contains(&name.as_str()) {
            take_text(&mut taken, name, field).await?;
            continue;
        }
        let called = field.file_name().unwrap_or_default().to_owned();
        let (path, most) = match name.as_str() {
            "photo" if taken.photos.len() >= server.limits.photos => {
                return Err(Refusal::unusable(format!("photo: expected at most {}, found more", server.limits.photos)));
            }
            "photo" => (incoming.part(taken.photos.len()), server.limits.upload),
            "poses" => {
                let known = last_part(&called);
                let known = POSES.into_iter().find(|p| *p == known && !taken.poses.contains(p));
                let known = known.ok_or_else(|| {
                    Refusal::unusable(format!("poses: expected one each of {}, by these names", POSES.join(", ")))
                })?;
                taken.poses.push(known);
                (incoming.folder().join("in/poses").join(known), server.limits.upload)
            }
            "country_register" if taken.register => {
                return Err(Refusal::unusable("country_register: expected one file, found more"));
            }
            "country_register" => {
                taken.register = true;
                (incoming.folder().join(REGISTER), CONTROL)
            }
            _ if taken.control => return Err(Refusal::unusable("gcp: expected one file, found more")),
            _ => {
                taken.control = true;
                (incoming.folder().join("in/gcp.csv"), CONTROL)
            }
        };
        let most = most.min(server.limits.submission.saturating_sub(taken.bytes));
        let bytes = keep(&name, field, &path, most).await?;
        taken.bytes += bytes;
        match name.as_str() {
            "photo" if bytes == 0 => return Err(Refusal::unusable("photo: expected a file, found an empty one")),
            "photo" => taken.photos.push(called),
            _ => {}
        }
    }
}

/// Without the folders that some browsers send along.
pub fn last_part(called: &str) -> &str {
    called.rsplit(['/', '\\']).next().unwrap_or_default()
}

async fn take_text(taken: &mut Taken, name: String, field: Field<'_>) -> Answer<()> {
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
    Ok(())
}

pub fn too_slow() -> Refusal {
    Refusal::new(StatusCode::REQUEST_TIMEOUT, "TOO_SLOW", "the submission did not come in time")
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

async fn keep(name: &str, mut field: Field<'_>, path: &Path, limit: u64) -> Answer<u64> {
    let io = |e: std::io::Error| Refusal::from(Error::io(path, &e));
    if let Some(folder) = path.parent() {
        tokio::fs::create_dir_all(folder).await.map_err(io)?;
    }
    let mut options = tokio::fs::OpenOptions::new();
    let mut file = options.write(true).create_new(true).open(path).await.map_err(io)?;
    let mut bytes = 0;
    while let Some(piece) = piece(&mut field).await? {
        bytes += piece.len() as u64;
        if bytes > limit {
            return Err(Refusal::too_large(format!("{name}: expected at most {limit} bytes")));
        }
        file.write_all(&piece).await.map_err(io)?;
    }
    file.sync_all().await.map_err(io)?;
    Ok(bytes)
}
