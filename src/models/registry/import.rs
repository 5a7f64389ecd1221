//! `orb models import`: files in, a checked network out, or nothing at all.
//!
//! Order: copy into a folder of its own while hashing; look at the copies without an engine (truncation, sizes, external
//! data, contracts); ask pins and licence; load each graph once; write the manifest; rename. Whatever fails, the folder
//! goes.

mod gather;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::catalogue::{Catalogue, DepthKind, Entry};
use super::family::{Family, Role, control_name, recognise};
use super::{File, MANIFEST, Manifest, Part, Registry, check_id};
use crate::audit::disk::{Disk, hash_file};
use crate::models::Engine;
use crate::models::onnx::{self, Description};
use crate::{Error, Result};
pub use gather::Limits;

/// What the user asked for.
#[derive(Clone, Debug, Default)]
pub struct Import {
    /// An ONNX file, a folder or a ZIP archive; several are taken as one network.
    pub sources: Vec<PathBuf>,
    /// The catalogue's name for it, where neither pin nor size tells.
    pub known_as: Option<String>,
    /// Its folder's name, in place of the catalogue's.
    pub id: Option<String>,
    pub allow_unpinned: bool,
    pub accept_licence: bool,
    pub depth_kind: Option<DepthKind>,
    /// Takes the place of a network of the same name.
    pub replace: bool,
    pub limits: Limits,
}

/// The newest operator set that the engines were tried with is 21; later ones keep the old operators.
const OPSETS: std::ops::RangeInclusive<u64> = 7..=26;

/// A copied file that is a graph.
struct Graph {
    /// Below the staging folder, with `/`.
    path: String,
    description: Description,
}

/// Imports a network. `say` gets a line for what was left out.
///
/// # Errors
/// Usage for files that are no network Orb can run (with a diff of their tensors), policy for an unknown hash or a
/// licence not accepted, integrity for a file that differs from its catalogue entry, environment for the disk.
pub fn import(
    registry: &Registry,
    request: &Import,
    engine: &dyn Engine,
    say: &mut dyn FnMut(&str),
) -> Result<Manifest> {
    if let Some(id) = &request.id {
        check_id(id)?;
    }
    let catalogue = Catalogue::load(registry.root())?;
    let staging = Staging::new(registry.root())?;
    let copied = gather::gather(&request.sources, &staging.path, &request.limits)?;

    let mut graphs = Vec::new();
    let mut prompt = None;
    for path in &copied {
        if path.ends_with(".safetensors") {
            super::super::zero123::Prompt::read(&staging.path.join(path))?;
            prompt = Some(path.clone());
        } else if path.ends_with(".onnx") {
            graphs.push(Graph { path: path.clone(), description: described(&staging.path.join(path), path)? });
        }
    }
    let (family, mut parts) = classified(&graphs, say)?;
    if let (Family::Zero123pp, Some(path)) = (family, prompt) {
        parts.insert(Role::Prompt, path);
    }
    let missing: Vec<&str> = family.roles().iter().filter(|r| !parts.contains_key(r)).map(|r| r.name()).collect();
    if !missing.is_empty() {
        return Err(Error::usage(format!("a network of the family {}", family.name()))
            .expected(format!("also its {}", missing.join(", ")))
            .found(parts.iter().map(|(r, p)| format!("{}: {p}", r.name())).collect::<Vec<_>>().join(", "))
            .advice("Give all its files at once: a folder, an archive, or one file after the other."));
    }

    if parts.contains_key(&Role::ControlNet) {
        let read = graphs.iter().find(|g| parts.get(&Role::UnetRead) == Some(&g.path));
        if !read.is_some_and(|g| g.description.inputs.iter().any(|p| p.name == control_name(0))) {
            return Err(Error::usage(format!("a network of the family {}", family.name()))
                .expected(format!("a {} that takes what the {} gives", Role::UnetRead.name(), Role::ControlNet.name()))
                .found(format!("one without the inputs {} and its like", control_name(0)))
                .advice("Export it with the thirteen inputs, or leave the ControlNet out."));
        }
    }

    let used = files_of(&staging.path, &parts, &graphs)?;
    let weights: BTreeMap<Role, u64> = parts
        .iter()
        .filter_map(|(r, p)| Some((*r, graphs.iter().find(|g| g.path == *p)?.description.parameters)))
        .collect();
    let (entry, pinned) = identified(&catalogue, request, family, &used, &weights)?;
    check_licence(request, entry)?;
    for (role, path) in &parts {
        if *role != Role::Prompt {
            // Dropped at once: what loads today loads in the run.
            drop(engine.load_file(&staging.path.join(path)).map_err(|e| Error { subject: path.clone(), ..e })?);
        }
    }

    let depth_kind = (family == Family::DepthAnything)
        .then(|| request.depth_kind.or(entry.and_then(|e| e.kind)).unwrap_or(DepthKind::Disparity));
    let id = request.id.clone().or_else(|| entry.map(|e| e.id.clone())).unwrap_or_else(|| family.name().to_owned());
    let manifest = Manifest {
        schema: 1,
        id,
        version: entry.map_or("unknown", |e| &e.version).to_owned(),
        family,
        licence: entry.map_or("unknown", |e| &e.licence).to_owned(),
        commercial: entry.is_some_and(|e| e.commercial),
        pinned,
        depth_kind,
        parts: parts.into_iter().map(|(role, path)| Part { role, path }).collect(),
        files: used,
    };
    staging.publish(registry.root(), &manifest, request.replace)?;
    Ok(manifest)
}

fn described(path: &Path, name: &str) -> Result<Description> {
    let unusable = |found: String| {
        Error::usage(name).expected("an ONNX model that is whole").found(found).advice("Nothing was imported.")
    };
    let file = fs::File::open(path).map_err(|e| Error::io(path, &e))?;
    let description = onnx::describe(&mut std::io::BufReader::new(file)).map_err(unusable)?;
    match description.opset {
        Some(v) if OPSETS.contains(&v) => Ok(description),
        other => Err(unusable(format!("operator set {other:?}, where {OPSETS:?} can be read"))),
    }
}

/// The one family that the graphs make, with a file a role.
fn classified(graphs: &[Graph], say: &mut dyn FnMut(&str)) -> Result<(Family, BTreeMap<Role, String>)> {
    let mut found: BTreeMap<Family, BTreeMap<Role, Vec<String>>> = BTreeMap::new();
    let mut strangers = Vec::new();
    for graph in graphs {
        match recognise(&graph.description) {
            Ok((family, role)) => {
                found.entry(family).or_default().entry(role).or_default().push(graph.path.clone());
            }
            Err((nearest, lines)) => strangers.push((graph.path.as_str(), nearest, lines)),
        }
    }
    let Some((family, roles)) = found.pop_first() else {
        let Some((path, nearest, lines)) = strangers.first() else {
            return Err(Error::usage("models import").expected("at least one .onnx file").found("none"));
        };
        return Err(Error::usage(*path)
            .expected(format!("a graph that Orb can run; the nearest is {nearest}, its tensors marked -"))
            .found(format!("these differences:\n{}", lines.join("\n")))
            .advice("Export the network again with the names and shapes marked -. Nothing was imported."));
    };
    if let Some((other, _)) = found.first_key_value() {
        return Err(Error::usage("models import")
            .expected("the files of one network")
            .found(format!("some of {} and some of {}", family.name(), other.name()))
            .advice("Import one network after the other."));
    }
    strangers.iter().for_each(|(path, ..)| say(&format!("{path} is left out: no part of this network")));
    let mut parts = BTreeMap::new();
    for (role, mut paths) in roles {
        if paths.len() > 1 {
            return Err(Error::usage("models import")
                .expected(format!("one {}", role.name()))
                .found(paths.join(", "))
                .advice("Name the files that you want, in place of the folder."));
        }
        parts.insert(role, paths.remove(0));
    }
    Ok((family, parts))
}

/// The graphs in use and their external data, hashed; what else was copied is removed.
fn files_of(staging: &Path, parts: &BTreeMap<Role, String>, graphs: &[Graph]) -> Result<Vec<File>> {
    let mut paths: Vec<String> = parts.values().cloned().collect();
    for graph in graphs.iter().filter(|g| parts.values().any(|p| *p == g.path)) {
        paths.extend(gather::external_paths(&graph.path, &graph.description)?);
    }
    paths.sort();
    paths.dedup();
    for entry in crate::audit::disk::walk(staging)? {
        if entry.is_file && !paths.contains(&entry.name) {
            fs::remove_file(&entry.path).map_err(|e| Error::io(&entry.path, &e))?;
        }
    }
    paths
        .into_iter()
        .map(|path| {
            let at = staging.join(&path);
            let (bytes, sha256) = hash_file(&at).map_err(|e| Error::io(&at, &e))?;
            Ok(File { path, bytes, sha256 })
        })
        .collect()
}

/// What the files are, and whether their hashes prove it.
fn identified<'a>(
    catalogue: &'a Catalogue,
    request: &Import,
    family: Family,
    files: &[File],
    weights: &BTreeMap<Role, u64>,
) -> Result<(Option<&'a Entry>, bool)> {
    let hashes: Vec<&str> = files.iter().map(|f| f.sha256.as_str()).collect();
    let proven = catalogue.pinned(family, &hashes);
    let named = match &request.known_as {
        None => None,
        Some(id) => Some(catalogue.get(id).filter(|e| e.families.contains(&family)).ok_or_else(|| {
            let ids: Vec<&str> =
                catalogue.entries.iter().filter(|e| e.families.contains(&family)).map(|e| e.id.as_str()).collect();
            Error::usage("--as").expected(format!("one of {}", ids.join(", "))).found(format!("`{id}`"))
        })?),
    };
    if let Some(entry) = proven.filter(|p| named.is_none_or(|n| n.id == p.id)) {
        return Ok((Some(entry), true));
    }
    // A catalogue that knows the files of this network knows that these are others.
    if let Some(entry) = named.filter(|e| !e.pins.is_empty()) {
        return Err(Error::integrity(format!("network {}", entry.id))
            .expected("files whose SHA-256 the catalogue holds")
            .found(files.iter().map(|f| format!("{} {}", f.sha256, f.path)).collect::<Vec<_>>().join(", "))
            .advice("These are other weights, or damaged ones. Nothing was imported."));
    }
    if !request.allow_unpinned {
        let listed: Vec<String> = files.iter().map(|f| format!("\n  {}  {}", f.sha256, f.path)).collect();
        return Err(Error::policy("models import")
            .expected("weights whose SHA-256 Orb knows")
            .found(format!("unknown ones of the family {}:{}", family.name(), listed.join("")))
            .advice("If you trust where they come from: --allow-unpinned. Records will call them unverified."));
    }
    Ok((named.or_else(|| catalogue.likely(family, weights)), false))
}

fn check_licence(request: &Import, entry: Option<&Entry>) -> Result<()> {
    if request.accept_licence || entry.is_some_and(|e| e.commercial) {
        return Ok(());
    }
    let terms = match entry {
        Some(e) => format!("{}, published under {} ({}): no commercial use", e.id, e.licence, e.upstream),
        None => "a network that Orb does not know, so nor its licence".into(),
    };
    Err(Error::policy("models import")
        .expected("weights under a licence that allows every use, or --accept-licence")
        .found(terms)
        .advice("Read the licence where the weights come from. If it allows your use: --accept-licence. Nothing was imported."))
}

/// A folder beside the networks that is gone when the import does not end well.
struct Staging {
    path: PathBuf,
}

impl Staging {
    fn new(root: &Path) -> Result<Staging> {
        let disk = Disk::default();
        disk.create_dir_all(root)?;
        // What a killed import left is nobody's: there is one importer at a time.
        let path = root.join(".importing");
        disk.remove_dir_all(&path)?;
        disk.create_dir(&path)?;
        Ok(Staging { path })
    }

    fn publish(&self, root: &Path, manifest: &Manifest, replace: bool) -> Result<()> {
        let disk = Disk::default();
        let to = root.join(&manifest.id);
        if to.exists() {
            if !replace {
                return Err(Error::usage(format!("network {}", manifest.id))
                    .expected("a name that is free")
                    .found(format!("{} is there", to.display()))
                    .advice("Choose another with --id, or --replace it. Nothing was imported."));
            }
            disk.remove_dir_all(&to)?;
        }
        let text =
            serde_json::to_string_pretty(manifest).map_err(|e| Error::environment("manifest").found(e.to_string()))?;
        disk.write_new(&self.path.join(MANIFEST), text.as_bytes())?;
        disk.sync_dir(&self.path)?;
        disk.rename(&self.path, &to)?;
        disk.sync_dir(root)
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // Published: nothing of this name is left. Otherwise there is no one left to tell.
        let _ = fs::remove_dir_all(&self.path);
    }
}
