//! From what the user named to copies in a staging folder: ONNX files, their external data, prompts; nothing else.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use crate::audit::disk::{check_name, walk, write_error};
use crate::models::onnx::{self, Description};
use crate::{Error, Result};

/// Beyond these no network of a known family is.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// All files together.
    pub total_bytes: u64,
    /// An ONNX file: a protocol buffer ends at 2 GiB.
    pub graph_bytes: u64,
    pub files: usize,
    /// Unpacked to packed, for archive entries of more than 1 MiB: weights hardly shrink.
    pub ratio: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits { total_bytes: 24 << 30, graph_bytes: 2 << 30, files: 64, ratio: 100 }
    }
}

fn wanted(name: &str) -> bool {
    name.ends_with(".onnx") || name.ends_with(".safetensors")
}

/// Copies; gives the paths below `staging`, with `/`, sorted.
pub fn gather(sources: &[PathBuf], staging: &Path, limits: &Limits) -> Result<Vec<String>> {
    let mut copier = Copier { staging, limits, total: 0, done: BTreeSet::new() };
    for source in sources {
        let metadata = fs::metadata(source).map_err(|e| Error::io(source, &e).advice("Check the path."))?;
        let name = source.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        if metadata.is_dir() {
            let files = walk(source)?;
            for entry in files.iter().filter(|e| !e.is_dir && wanted(&e.name)) {
                copier.with_external(&entry.name, &Folder(source))?;
            }
        } else if name.to_ascii_lowercase().ends_with(".zip") {
            let file = fs::File::open(source).map_err(|e| Error::io(source, &e))?;
            let archive = zip::ZipArchive::new(io::BufReader::new(file)).map_err(|e| {
                Error::usage(source.display().to_string()).expected("a ZIP archive").found(e.to_string())
            })?;
            let archive = Archive(std::cell::RefCell::new(archive));
            let names: Vec<String> = archive.0.borrow().file_names().flatten().map(|n| n.into_owned()).collect();
            for name in names.iter().filter(|n| wanted(n)) {
                copier.with_external(name, &archive)?;
            }
        } else if wanted(&name) {
            let folder = source.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
            copier.with_external(&name, &Folder(folder))?;
        } else {
            return Err(Error::usage(source.display().to_string())
                .expected("an .onnx file, a .safetensors prompt, a folder or a .zip archive")
                .found("a file of another name"));
        }
    }
    Ok(copier.done.into_iter().collect())
}

/// Where a graph's external data lies, relative to the network's folder.
///
/// # Errors
/// A usage error for a path that leads, or may lead on some system, out of the graph's own folder.
pub fn external_paths(graph: &str, description: &Description) -> Result<Vec<String>> {
    let folder = graph.rsplit_once('/').map_or("", |(f, _)| f);
    let mut paths: Vec<String> = Vec::new();
    for external in &description.external {
        check_name(&external.location).map_err(|why| {
            Error::usage(graph)
                .expected("external data in files beside the graph")
                .found(format!("`{}` for tensor {}: {why}", external.location, external.tensor))
                .advice("This file would read from somewhere else on this machine. Nothing was imported.")
        })?;
        let path =
            if folder.is_empty() { external.location.clone() } else { format!("{folder}/{}", external.location) };
        if !paths.contains(&path) {
            paths.push(path);
        }
    }
    Ok(paths)
}

/// Gets bytes and, from an archive, their packed size; gives how many bytes there were.
type Take<'a> = &'a mut dyn FnMut(&mut dyn Read, Option<u64>) -> Result<u64>;

/// A place to copy from.
trait Source {
    fn open(&self, name: &str, take: Take) -> Result<u64>;
}

struct Folder<'a>(&'a Path);

impl Source for Folder<'_> {
    fn open(&self, name: &str, take: Take) -> Result<u64> {
        let path = self.0.join(name);
        let real = fs::canonicalize(&path)
            .map_err(|e| Error::io(&path, &e).advice("The network's files must lie together."))?;
        if !fs::canonicalize(self.0).is_ok_and(|root| real.starts_with(root)) {
            return Err(Error::usage(path.display().to_string())
                .expected("a file inside the folder")
                .found(format!("a link to {}", real.display()))
                .advice("Copy the files themselves together (`cp -L`) and import that."));
        }
        let mut file = fs::File::open(&real).map_err(|e| Error::io(&real, &e))?;
        if !file.metadata().is_ok_and(|m| m.is_file()) {
            return Err(Error::usage(path.display().to_string()).expected("a regular file"));
        }
        take(&mut file, None)
    }
}

struct Archive(std::cell::RefCell<zip::ZipArchive<io::BufReader<fs::File>>>);

impl Source for Archive {
    fn open(&self, name: &str, take: Take) -> Result<u64> {
        let mut archive = self.0.borrow_mut();
        let mut entry = archive
            .by_name(name)
            .map_err(|e| Error::usage(name).expected("an entry of the archive").found(e.to_string()))?;
        if !entry.is_file() {
            return Err(Error::usage(name).expected("a regular file in the archive").found("a folder or a link"));
        }
        let packed = entry.compressed_size();
        take(&mut entry, Some(packed))
    }
}

struct Copier<'a> {
    staging: &'a Path,
    limits: &'a Limits,
    total: u64,
    done: BTreeSet<String>,
}

impl Copier<'_> {
    /// A file and, for a graph, the external data that it names.
    fn with_external(&mut self, name: &str, source: &dyn Source) -> Result<()> {
        self.copy(name, source, wanted(name).then_some(self.limits.graph_bytes))?;
        if !name.ends_with(".onnx") {
            return Ok(());
        }
        let path = self.staging.join(name);
        let file = fs::File::open(&path).map_err(|e| Error::io(&path, &e))?;
        // What is wrong with a graph is said when it is judged, with the others.
        let Ok(description) = onnx::describe(&mut io::BufReader::new(file)) else { return Ok(()) };
        for external in external_paths(name, &description)? {
            if !self.done.contains(&external) {
                self.copy(&external, source, None)?;
            }
            let size = fs::metadata(self.staging.join(&external)).map_or(0, |m| m.len());
            let folder = name.rsplit_once('/').map_or(String::new(), |(f, _)| format!("{f}/"));
            for piece in description.external.iter().filter(|e| format!("{folder}{}", e.location) == external) {
                let end = piece.offset.checked_add(piece.length.unwrap_or(0));
                if end.is_none_or(|end| end > size) {
                    return Err(Error::usage(external.clone())
                        .expected(format!(
                            "{} bytes from {} for tensor {}",
                            piece.length.unwrap_or(0),
                            piece.offset,
                            piece.tensor
                        ))
                        .found(format!("a file of {size} bytes"))
                        .advice("The download is not whole. Nothing was imported."));
                }
            }
        }
        Ok(())
    }

    fn copy(&mut self, name: &str, source: &dyn Source, limit: Option<u64>) -> Result<()> {
        check_name(name).map_err(|why| {
            Error::usage(name).expected("a plain relative path").found(why).advice("Nothing was imported.")
        })?;
        if self.done.len() >= self.limits.files {
            return Err(Error::usage("models import")
                .expected(format!("at most {} files", self.limits.files))
                .found("more")
                .advice("Name the network's own files, in place of the folder."));
        }
        if !self.done.insert(name.to_owned()) {
            return Err(Error::usage(name)
                .expected("files of different names")
                .found("two of this one")
                .advice("Put them into one folder and import that."));
        }
        let to = self.staging.join(name);
        if let Some(folder) = to.parent() {
            fs::create_dir_all(folder).map_err(|e| Error::io(folder, &e))?;
        }
        let room = (self.limits.total_bytes - self.total).min(limit.unwrap_or(u64::MAX));
        let ratio = self.limits.ratio;
        self.total += source.open(name, &mut |from, packed| {
            let room = packed.map_or(room, |p| room.min(p.saturating_mul(ratio).max(1 << 20)));
            copy_at_most(from, &to, room, name)
        })?;
        Ok(())
    }
}

fn copy_at_most(from: &mut dyn Read, to: &Path, most: u64, name: &str) -> Result<u64> {
    let mut file = fs::File::create_new(to).map_err(|e| Error::io(to, &e))?;
    let (mut buffer, mut total) = (vec![0; 1 << 20], 0u64);
    loop {
        let n = from
            .read(&mut buffer)
            .map_err(|e| Error::usage(name).expected("a file that can be read").found(e.to_string()))?;
        if n == 0 {
            break;
        }
        total += n as u64;
        if total > most {
            return Err(Error::usage(name)
                .expected(format!("at most {most} bytes"))
                .found("more")
                .advice("No known network is this large, or packed this small. Nothing was imported."));
        }
        file.write_all(&buffer[..n]).map_err(|e| write_error(to, n, &e))?;
    }
    file.sync_all().map_err(|e| write_error(to, 0, &e))?;
    Ok(total)
}
