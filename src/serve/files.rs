//! What a job published: a list, single files, all of it in one archive as it is sent. Only names from the list are opened.

use std::fs::File;
use std::io::{self, Read as _, Write};
use std::path::{Path, PathBuf};
use std::pin::Pin;

use axum::body::{Body, Bytes};
use futures_util::Stream;
use futures_util::stream::unfold;
use serde::Serialize;
use tokio::sync::OwnedSemaphorePermit;
use tokio::sync::mpsc::{Receiver, Sender, channel};
use utoipa::ToSchema;
use zip::write::SimpleFileOptions;

use crate::audit::disk;
use crate::{Error, Result};

/// Bytes of a piece, and pieces that wait for the client.
const PIECE: usize = 64 << 10;
const PIECES: usize = 4;

/// A published file.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct Listed {
    /// Below the published folder, `/` between the parts.
    pub name: String,
    pub bytes: u64,
    pub media_type: &'static str,
    #[serde(skip)]
    #[schema(ignore)]
    pub path: PathBuf,
}

/// Links are left out.
///
/// # Errors
/// Environment.
pub fn list(folder: &Path) -> Result<Vec<Listed>> {
    let files = disk::walk(folder)?.into_iter().filter(|e| e.is_file);
    let listed = |e: disk::Entry| {
        let bytes = std::fs::metadata(&e.path).map_err(|error| Error::io(&e.path, &error))?.len();
        Ok(Listed { media_type: media_type(&e.name), name: e.name, bytes, path: e.path })
    };
    files.map(listed).collect()
}

fn media_type(name: &str) -> &'static str {
    match name.rsplit('.').next().unwrap_or_default() {
        "json" | "geojson" => "application/json",
        "png" => "image/png",
        "jpg" => "image/jpeg",
        "glb" => "model/gltf-binary",
        "usdz" => "model/vnd.usdz+zip",
        "kmz" => "application/vnd.google-earth.kmz",
        "kml" => "application/vnd.google-earth.kml+xml",
        "xml" => "application/xml",
        "zip" => "application/zip",
        _ => "application/octet-stream",
    }
}

/// The thread that reads ends when nobody takes what it sends.
fn body(pieces: Receiver<io::Result<Bytes>>) -> Body {
    let stream: Pin<Box<dyn Stream<Item = io::Result<Bytes>> + Send>> =
        Box::pin(unfold(pieces, |mut pieces| async move { pieces.recv().await.map(|piece| (piece, pieces)) }));
    Body::from_stream(stream)
}

/// A file, piece by piece. `place` is held until its end.
///
/// # Errors
/// Environment.
pub fn send(path: &Path, place: OwnedSemaphorePermit) -> Result<Body> {
    let mut file = File::open(path).map_err(|e| Error::io(path, &e))?;
    let (to, pieces) = channel(PIECES);
    tokio::task::spawn_blocking(move || {
        let _place = place;
        loop {
            let mut piece = vec![0; PIECE];
            let read = file.read(&mut piece);
            let (end, message) = match read {
                Ok(0) => return,
                Ok(n) => {
                    piece.truncate(n);
                    (false, Ok(Bytes::from(piece)))
                }
                Err(e) => (true, Err(e)),
            };
            if to.blocking_send(message).is_err() || end {
                return;
            }
        }
    });
    Ok(body(pieces))
}

/// All of these files in one archive, made while it is sent. `marking` stands in the archive's comment.
pub fn send_archive(files: Vec<Listed>, folder: String, marking: String, place: OwnedSemaphorePermit) -> Body {
    let (to, pieces) = channel(PIECES);
    tokio::task::spawn_blocking(move || {
        let _place = place;
        let sink = Sink { to: to.clone(), piece: Vec::with_capacity(PIECE) };
        // A client that went away needs no error.
        if let Err(e) = write_archive(sink, &files, &folder, &marking)
            && e.kind() != io::ErrorKind::BrokenPipe
        {
            let _ = to.blocking_send(Err(e));
        }
    });
    body(pieces)
}

fn write_archive(sink: Sink, files: &[Listed], folder: &str, marking: &str) -> io::Result<()> {
    let mut archive = zip::ZipWriter::new_stream(sink);
    let options =
        SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated).compression_level(Some(1));
    for file in files {
        archive.start_file(format!("{folder}/{}", file.name), options.large_file(file.bytes >= u32::MAX.into()))?;
        io::copy(&mut File::open(&file.path)?, &mut archive)?;
    }
    archive.set_comment(marking)?;
    archive.finish()?.into_inner().flush()
}

/// Sends what is written to it, in pieces.
struct Sink {
    to: Sender<io::Result<Bytes>>,
    piece: Vec<u8>,
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.piece.extend_from_slice(bytes);
        if self.piece.len() >= PIECE {
            self.flush()?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.piece.is_empty() {
            return Ok(());
        }
        let piece = Bytes::from(std::mem::replace(&mut self.piece, Vec::with_capacity(PIECE)));
        self.to.blocking_send(Ok(piece)).map_err(|_| io::ErrorKind::BrokenPipe.into())
    }
}
