//! Where a CDB store is written: new, into one that is there, or as a new version of one.

use std::path::{Path, PathBuf};

use orb_formats::{File, cdb};

use crate::audit::{Publication, StoreLock, lock_store, merge_into_store};
use crate::cli::cdb::Folder;
use crate::cli::ground::GroundFiles;
use crate::{Error, Result, export};

/// Where a CDB store is written.
#[derive(Default)]
pub enum Target {
    /// A store of its own in the published folder.
    #[default]
    New,
    /// Into a store that is there.
    Into(OpenStore),
    /// A new version of it, in the published folder.
    VersionOf(OldVersion),
}

/// A store with the versions that it continues, and how the new version names it.
pub struct OldVersion {
    /// Newest first.
    folders: Vec<Folder>,
    name: String,
}

impl OldVersion {
    /// `root` is to be that of the new version.
    ///
    /// # Errors
    /// Usage for a folder that is no store, and for a chain that is full already.
    pub fn open(old: &Path, root: &Path) -> Result<OldVersion> {
        let folders = Folder::with_previous(old)?;
        if folders.len() >= cdb::MAX_VERSIONS {
            return Err(Error::usage("--cdb-version-of")
                .expected(format!("a chain of fewer than {} versions", cdb::MAX_VERSIONS))
                .found(format!("{} versions", folders.len()))
                .advice("Join the versions into one store first."));
        }
        let root = std::path::absolute(root).map_err(|e| Error::io(root, &e))?;
        // The published folder is not there yet; the one that it comes into is, and may be a link.
        let base = root.ancestors().nth(2).unwrap_or(&root);
        let root = match (base.canonicalize(), root.strip_prefix(base)) {
            (Ok(real), Ok(rest)) => real.join(rest),
            _ => root.clone(),
        };
        Ok(OldVersion { name: relative(&root, &folders[0].root), folders })
    }
}

/// A path to `to` as seen from the folder `from`, both absolute; `/` between folders.
fn relative(from: &Path, to: &Path) -> String {
    let (from, to): (Vec<_>, Vec<_>) = (from.components().collect(), to.components().collect());
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let down = to[shared..].iter().map(|c| c.as_os_str().to_string_lossy().into_owned());
    std::iter::repeat_n("..".to_owned(), from.len() - shared).chain(down).collect::<Vec<_>>().join("/")
}

/// A store on disk, locked for this run.
pub struct OpenStore {
    lock: StoreLock,
    root: PathBuf,
}

impl OpenStore {
    /// # Errors
    /// As [`lock_store`].
    pub fn open(root: &Path) -> Result<OpenStore> {
        let lock = lock_store(root)?;
        Ok(OpenStore { lock, root: root.to_owned() })
    }

    /// Puts files into the store when the publication is sealed; errors as [`merge_into_store`].
    pub fn merge(self, files: &[File], folders: &[String], publication: &mut Publication) -> Result<()> {
        publication.merge(merge_into_store(self.lock, files, folders)?)
    }
}

impl cdb::Store for OpenStore {
    fn read(&self, path: &str) -> std::io::Result<Option<Vec<u8>>> {
        match std::fs::read(self.root.join(path)) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(e),
        }
    }

    fn exists(&self, path: &str) -> std::io::Result<bool> {
        self.root.join(path).try_exists()
    }

    fn size(&self, path: &str) -> std::io::Result<Option<u64>> {
        match std::fs::metadata(self.root.join(path)) {
            Ok(file) => Ok(Some(file.len())),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(e),
        }
    }
}

/// Into the published folder, or into the store that was named. Returns the model's name there.
pub(super) fn write_cdb(
    model: &cdb::Model,
    stem: &str,
    target: Target,
    ground: Option<GroundFiles>,
    publication: &mut Publication,
) -> Result<String> {
    let with_ground = |store: &dyn cdb::Store, added: Result<cdb::Added, orb_formats::Error>| {
        let mut added = added.map_err(export::format_error)?;
        if let Some(mut ground) = ground {
            let under = ground.under(store, model)?;
            under.notes.iter().for_each(|n| eprintln!("orb: {n}"));
            added.files.extend(under.files);
            added.files.sort_by(|a, b| a.path.cmp(&b.path));
        }
        Result::Ok(added)
    };
    let added = match target {
        Target::Into(store) => {
            let added = with_ground(&store, cdb::add_model(&store, model))?;
            store.merge(&added.files, &added.folders, publication)?;
            return Ok(added.model_name);
        }
        Target::New => with_ground(&cdb::Empty, cdb::add_model(&cdb::Empty, model))?,
        Target::VersionOf(old) => {
            let chain = cdb::Versions::new(old.folders.iter().map(|f| f as &dyn cdb::Store).collect());
            with_ground(&chain, cdb::add_version(&chain, &old.name, model))?
        }
    };
    if added.already_present {
        return Err(Error::usage("--cdb-version-of")
            .expected("a model that the store does not hold yet")
            .found(added.notes.join(" ")));
    }
    for folder in &added.folders {
        publication.add_folder(&format!("{stem}.cdb/{folder}"))?;
    }
    for file in &added.files {
        publication.add(&format!("{stem}.cdb/{}", file.path), &file.bytes, file.media_type, "cdb")?;
    }
    Ok(added.model_name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn old_versions_are_named_from_the_new_root() {
        let relative = |from: &str, to: &str| super::relative(Path::new(from), Path::new(to));
        assert_eq!(relative("/a/out/van.cdb", "/a/old/store.cdb"), "../../old/store.cdb");
        assert_eq!(relative("/a/b", "/c"), "../../c");
        assert_eq!(relative("/a/b/c", "/a"), "../..");
    }
}
