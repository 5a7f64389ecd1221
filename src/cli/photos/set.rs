//! A folder of posed photos as scenes are trained on: every file read once for the record.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use glam::DVec3;
use image::GrayImage;
use sha2::{Digest, Sha256};

use super::{COLMAP, Folder, PhotosArgs, Sfm, name_of, options};
use crate::audit::statement::{Input, Param};
use crate::audit::{Marking, record};
use crate::cli::marking;
use crate::photo::Photo;
use crate::photos::register::Fix;
use crate::photos::{Posed, Poses, dataset, poses, sfm};
use crate::progress::Progress;
use crate::{Error, Result};

/// A set of photos for a scene.
pub struct Set {
    folder: Folder,
    /// The layout's own test photos.
    split: Option<Vec<bool>>,
    /// By the photos' names.
    masks: BTreeMap<String, PathBuf>,
}

impl Set {
    /// Reads every photo and mask, and the poses where somebody gave them. `masks`: their folder, where the user names it.
    ///
    /// # Errors
    /// As [`dataset::find`] and [`dataset::masks`]; usage where there are no poses and none are to be computed; a file or
    /// marking that cannot be read.
    pub fn open(folder: &Path, args: &PhotosArgs, masks: Option<&Path>) -> Result<Set> {
        if !folder.is_dir() {
            return Err(Error::usage(folder.display().to_string()).expected("a folder of photos").found("no folder"));
        }
        let (found, files) = match args.sfm {
            Some(Sfm::Colmap) => {
                sfm::version(Path::new(COLMAP))?;
                (None, poses::photos_in(folder)?.into_iter().map(|f| (name_of(&f), f)).collect())
            }
            None => {
                let found = dataset::find(folder, args.poses.as_deref())?.ok_or_else(|| no_poses(folder))?;
                let files = found.poses.photos.iter().map(|p| (p.name.clone(), p.file.clone())).collect();
                (Some(found), files)
            }
        };
        let files: Vec<(String, PathBuf)> = files;
        let names: Vec<String> = files.iter().map(|f| f.0.clone()).collect();
        let found_masks = dataset::masks(folder, masks, &names)?;
        let (poses, split) = found.map_or((None, None), |f| (Some(f.poses), f.held_out));
        let mut set = Set { folder: Folder::read(files, poses, args)?, split, masks: BTreeMap::new() };
        for (name, file) in names.into_iter().zip(found_masks).filter_map(|(n, f)| Some((n, f?))) {
            let bytes = std::fs::read(&file).map_err(|e| Error::io(&file, &e))?;
            let own = name_of(&file);
            let marked = marking::carried(&own, &bytes)?;
            set.folder.inputs.push(record::input(&own, &bytes, "image/png", "mask", marked.clone()));
            set.folder.carried.push(marked);
            set.masks.insert(name, file);
        }
        Ok(set)
    }

    /// Finds poses where nobody gave them.
    ///
    /// # Errors
    /// As [`sfm::run`].
    pub fn pose(&mut self, progress: &dyn Progress) -> Result<()> {
        match self.folder.poses {
            Some(_) => Ok(()),
            None => self.folder.run_colmap(progress),
        }
    }

    /// # Errors
    /// Environment where nobody has found any yet.
    pub fn poses(&self) -> Result<&Poses> {
        self.folder.posed()
    }

    /// Which photos are held out: those of the layout's own test set, else every so-manieth.
    ///
    /// # Errors
    /// As [`Set::poses`].
    pub fn held_out(&self, every: usize) -> Result<Vec<bool>> {
        Ok(dataset::split(self.split.as_deref(), self.poses()?.photos.len(), every))
    }

    /// `the layout's own`, or every so-manieth.
    pub fn split_words(&self, every: usize) -> String {
        match (&self.split, every) {
            (Some(_), _) => "the layout's own test photos".into(),
            (None, 0 | 1) => "none".into(),
            (None, n) => format!("every {n}th photo by name"),
        }
    }

    pub fn inputs(&self) -> &[Input] {
        &self.folder.inputs
    }

    pub fn carried(&self) -> &[Option<Marking>] {
        &self.folder.carried
    }

    pub fn mask_count(&self) -> usize {
        self.masks.len()
    }

    /// The mask of a photo, 0 where it is not to be looked at.
    ///
    /// # Errors
    /// Usage for a file that is no picture.
    pub fn mask(&self, posed: &Posed) -> Result<Option<GrayImage>> {
        let Some(file) = self.masks.get(&posed.name) else { return Ok(None) };
        let read = image::open(file)
            .map_err(|e| Error::usage(file.display().to_string()).expected("a mask").found(e.to_string()))?;
        Ok(Some(read.into_luma8()))
    }

    /// The photo of a pose, its rows as the file has them.
    ///
    /// # Errors
    /// As [`Folder::recorded`].
    pub fn photo(&self, posed: &Posed) -> Result<Photo> {
        self.folder.recorded(&posed.file)
    }

    /// Pixels of all photos together at most `longest` a side; what a look at the cameras says.
    ///
    /// # Errors
    /// As [`Set::poses`].
    pub fn pixels(&self, longest: u32) -> Result<u64> {
        let one = |p: &Posed| {
            let (w, h) = (f64::from(p.camera.width), f64::from(p.camera.height));
            let shrink = (f64::from(longest) / w.max(h)).min(1.0);
            (w * shrink).round() as u64 * (h * shrink).round() as u64
        };
        Ok(self.poses()?.photos.iter().map(one).sum())
    }

    /// What is known of the photos' places.
    ///
    /// # Errors
    /// As [`Folder::fixes`].
    pub fn fixes(&self) -> Result<Vec<Fix>> {
        self.folder.fixes(None)
    }

    /// Up in the cameras' world by their places on the Earth, where it is known well enough.
    pub fn up(fixes: &[Fix], seed: u64) -> Option<DVec3> {
        options(&PhotosArgs::default(), fixes, seed).up
    }

    /// The version of COLMAP, where it ran.
    pub fn colmap(&self) -> Option<&str> {
        self.folder.ran.as_ref().map(|r| r.version.as_str())
    }

    /// For the record. The poses' digest is that of one line a photo: its name, rotation (x, y, z, w) and translation
    /// world→camera, and its camera; whatever file they came from.
    pub fn params(&self) -> Vec<(String, Param)> {
        let mut all = Vec::new();
        if let Some(p) = &self.folder.poses {
            all.push(("poses".into(), Param::Text(record::printable(&p.source))));
            let mut digest = Sha256::new();
            p.photos.iter().for_each(|p| digest.update(line_of(p)));
            all.push(("poses_sha256".into(), Param::Text(hex::encode(digest.finalize()))));
        }
        all.extend(self.folder.ran_params());
        all
    }
}

/// A pose as digests have it.
pub fn line_of(p: &Posed) -> String {
    let (q, t) = (p.rotation.to_array(), p.translation.to_array());
    format!("{} {q:?} {t:?} {:?}\n", p.name, p.camera)
}

fn no_poses(folder: &Path) -> Error {
    Error::usage(folder.display().to_string())
        .expected(
            "posed photos: COLMAP's sparse/0, transforms.json or transforms_train.json in the folder or beside it",
        )
        .found("none")
        .advice("Give --poses PATH, or let COLMAP compute them: --sfm colmap.")
}
