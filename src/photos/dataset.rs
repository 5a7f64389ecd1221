//! A set of posed photos as scenes are trained on: where the layout keeps poses and photos, which photos it holds out, which
//! of their pixels are masked.
//!
//! Known layouts: COLMAP's (`images`, `sparse/0`), Nerfstudio's and Instant-NGP's `transforms.json`, and the synthetic sets of
//! NeRF (Mildenhall et al. 2020): `transforms_train.json` and `transforms_test.json` beside the folders that they name.

use std::path::{Path, PathBuf};

use glam::DVec3;

use super::poses::{self, Place};
use super::{Posed, Poses, transforms};
use crate::{Error, Result};

/// Poses of a layout, and what it says of its split.
#[derive(Clone, Debug)]
pub struct Found {
    pub poses: Poses,
    /// One a photo, where the layout has test photos of its own.
    pub held_out: Option<Vec<bool>>,
}

const TRAIN: &str = "transforms_train.json";
const TEST: &str = "transforms_test.json";

/// The poses of a set: from `given` (a COLMAP model, a folder of them, a list), else from what lies in the folder or beside
/// it. `None` where nothing is given and nothing is there.
///
/// # Errors
/// As the readers; usage where fewer than two photos have a pose.
pub fn find(folder: &Path, given: Option<&Path>) -> Result<Option<Found>> {
    let list = |name: &str| Some(folder.join(name)).filter(|p| p.is_file());
    let place = match given {
        Some(path) => Some(poses::named(path)?),
        None => match list(TRAIN) {
            Some(list) => Some(Place::List(list)),
            None => beside(folder)?,
        },
    };
    match place {
        None => Ok(None),
        Some(Place::List(list)) => of_list(&list).map(Some),
        Some(Place::Model(model)) => {
            let photos = poses::photos_in(folder)?;
            let poses = poses::of_model(&model)?.matched(&photos)?;
            Ok(Some(Found { poses, held_out: None }))
        }
    }
}

/// In the folder, in its `images`, or above.
fn beside(folder: &Path) -> Result<Option<Place>> {
    let above = folder.canonicalize().ok().and_then(|p| p.parent().map(Path::to_path_buf));
    for place in [Some(folder.to_path_buf()), Some(folder.join("images")), above].into_iter().flatten() {
        let found = poses::place(&place, false)?;
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// The photos that a list names, with those of its test list where it is a training list.
fn of_list(list: &Path) -> Result<Found> {
    let folder = list.parent().unwrap_or(Path::new("."));
    let mut lists = vec![list.to_owned()];
    if list.file_name().is_some_and(|n| n == TRAIN) {
        lists.extend(Some(folder.join(TEST)).filter(|p| p.is_file()));
    }
    let mut all: Vec<(Posed, bool)> = Vec::new();
    for (k, list) in lists.iter().enumerate() {
        for l in transforms::read(list)? {
            // Relative to the list: `train/r_0.png` and `test/r_0.png` are two.
            let name = l.file.strip_prefix(folder).unwrap_or(&l.file);
            let name = name.strip_prefix(".").unwrap_or(name).to_string_lossy().replace('\\', "/");
            let (rotation, translation) = (l.rotation, l.translation);
            all.push((Posed { name, file: l.file, camera: l.camera, rotation, translation }, k == 1));
        }
    }
    all.sort_by(|a, b| a.0.name.cmp(&b.0.name));
    all.dedup_by(|a, b| a.0.name == b.0.name);
    let posed = all.len();
    all.retain(|p| p.0.file.is_file());
    if all.len() < 2 {
        return Err(Error::usage(list.display().to_string())
            .expected("at least two photos that are there")
            .found(format!("{} of {posed}", all.len())));
    }
    let has_test = all.iter().any(|p| p.1);
    let held_out: Vec<bool> = all.iter().map(|p| p.1).collect();
    let mut notes = Vec::new();
    if all.len() < posed {
        notes.push(format!("{} of {posed} poses have no photo", posed - all.len()));
    }
    let (points_file, points) = transforms::points(list)?.unzip();
    let points = points.unwrap_or_default().into_iter().map(|(p, color)| (DVec3::from_array(p), color)).collect();
    let mut poses = Poses {
        photos: all.into_iter().map(|p| p.0).collect(),
        points,
        observations: Vec::new(),
        source: format!("the list {}", list.display()),
        files: lists.into_iter().chain(points_file).collect(),
        notes,
    };
    poses.note_lenses();
    Ok(Found { poses, held_out: has_test.then_some(held_out) })
}

/// Which photos are measured and never trained on: the layout's own, else every so-manieth by name, beginning with the
/// first; `None` with 0, and where too few would be left to train on.
pub fn split(found: Option<&[bool]>, photos: usize, every: usize) -> Vec<bool> {
    match found {
        Some(own) => own.to_vec(),
        None if every < 2 || photos < every => vec![false; photos],
        None => (0..photos).map(|i| i.is_multiple_of(every)).collect(),
    }
}

/// Every eighth, as Barron et al. 2022 and Kerbl et al. 2023 have it.
pub const EVERY: usize = 8;

/// Each photo's mask, by the photos' names: black where it is not to be looked at, the same name with `.png` at the end or in
/// the ending's place, as COLMAP and Nerfstudio have them. In `given`, else in `masks` in the set's folder or beside it.
///
/// # Errors
/// Usage for a given folder that has no photo's mask.
pub fn masks(folder: &Path, given: Option<&Path>, names: &[String]) -> Result<Vec<Option<PathBuf>>> {
    let own = || {
        let beside = folder.canonicalize().ok().and_then(|p| p.parent().map(|p| p.join("masks")));
        [Some(folder.join("masks")), beside].into_iter().flatten().find(|p| p.is_dir())
    };
    let Some(place) = given.map(Path::to_path_buf).or_else(own) else { return Ok(vec![None; names.len()]) };
    let of = |name: &String| {
        let name = Path::new(name);
        let last = Path::new(name.file_name().unwrap_or_default());
        let tries = [name, last].map(|n| [n.with_extension("png"), PathBuf::from(format!("{}.png", n.display()))]);
        tries.into_iter().flatten().map(|n| place.join(n)).find(|p| p.is_file())
    };
    let all: Vec<Option<PathBuf>> = names.iter().map(of).collect();
    if given.is_some() && all.iter().all(Option::is_none) {
        let first = Path::new(names.first().map_or("photo", String::as_str)).with_extension("png");
        return Err(Error::usage(place.display().to_string())
            .expected(format!("masks by the photos' names, such as {}", first.display()))
            .found("none"));
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(at: &Path, names: &[&str]) {
        let frame = |(i, n): (usize, &&str)| {
            std::fs::create_dir_all(at.parent().unwrap().join(n).parent().unwrap()).unwrap();
            image::RgbImage::new(4, 4).save(at.parent().unwrap().join(format!("{n}.png"))).unwrap();
            format!(r#"{{"file_path": "./{n}", "transform_matrix": [[1,0,0,{i}],[0,0,-1,-3],[0,1,0,0],[0,0,0,1]]}}"#)
        };
        let frames: Vec<String> = names.iter().enumerate().map(frame).collect();
        std::fs::write(at, format!(r#"{{"camera_angle_x": 1.0, "frames": [{}]}}"#, frames.join(","))).unwrap();
    }

    #[test]
    fn the_synthetic_sets_of_nerf_bring_their_own_split() {
        let f = tempfile::tempdir().unwrap();
        list(&f.path().join(TRAIN), &["train/r_0", "train/r_1", "train/r_2"]);
        let alone = find(f.path(), None).unwrap().unwrap();
        assert!(alone.held_out.is_none() && alone.poses.photos.len() == 3);
        list(&f.path().join(TEST), &["test/r_0"]);
        let found = find(f.path(), None).unwrap().unwrap();
        let names: Vec<&str> = found.poses.photos.iter().map(|p| p.name.as_str()).collect();
        assert_eq!(names, ["test/r_0.png", "train/r_0.png", "train/r_1.png", "train/r_2.png"]);
        assert_eq!(found.held_out.as_deref(), Some(&[true, false, false, false][..]));
        assert_eq!(found.poses.files.len(), 2);
        assert_eq!(split(found.held_out.as_deref(), 4, 8), [true, false, false, false]);
        // A photo that is not there is named by its number.
        std::fs::remove_file(f.path().join("train/r_2.png")).unwrap();
        let text = std::fs::read_to_string(f.path().join(TRAIN)).unwrap();
        std::fs::write(f.path().join(TRAIN), text.replace("\"frames\"", "\"w\": 4, \"h\": 4, \"frames\"")).unwrap();
        assert!(find(f.path(), None).unwrap().unwrap().poses.notes.join(";").contains("1 of 4"));
    }

    #[test]
    fn a_list_and_a_model_hold_every_eighth_out_and_masks_are_found() {
        let f = tempfile::tempdir().unwrap();
        let names: Vec<String> = (0..9).map(|i| format!("images/{i}")).collect();
        list(&f.path().join("transforms.json"), &names.iter().map(String::as_str).collect::<Vec<_>>());
        let found = find(f.path(), None).unwrap().unwrap();
        assert!(found.held_out.is_none() && found.poses.photos[8].name == "images/8.png");
        // Nerfstudio's points.
        let text = std::fs::read_to_string(f.path().join("transforms.json")).unwrap();
        let named = text.replacen('{', "{\"ply_file_path\": \"sparse_pc.ply\", ", 1);
        std::fs::write(f.path().join("transforms.json"), named).unwrap();
        assert!(find(f.path(), None).unwrap_err().to_string().contains("sparse_pc.ply"));
        let ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n";
        std::fs::write(f.path().join("sparse_pc.ply"), ply).unwrap();
        let with = find(f.path(), None).unwrap().unwrap().poses;
        assert_eq!((with.points.len(), with.points[0].0, with.files.len()), (1, DVec3::new(1.0, 2.0, 3.0), 2));
        let held = split(None, 9, EVERY);
        assert_eq!(held.iter().filter(|h| **h).count(), 2);
        assert!(held.iter().enumerate().all(|(i, h)| *h == crate::photos::colmap::is_test(i)));
        assert_eq!(split(None, 9, 0), [false; 9]);
        let photos: Vec<String> = found.poses.photos.iter().map(|p| p.name.clone()).collect();
        assert!(masks(f.path(), None, &photos).unwrap().iter().all(Option::is_none));
        std::fs::create_dir_all(f.path().join("masks/images")).unwrap();
        image::GrayImage::new(4, 4).save(f.path().join("masks/images/3.png")).unwrap();
        image::GrayImage::new(4, 4).save(f.path().join("masks/4.png.png")).unwrap();
        let all = masks(f.path(), None, &photos).unwrap();
        assert_eq!(all.iter().map(|m| usize::from(m.is_some())).collect::<Vec<_>>(), [0, 0, 0, 1, 1, 0, 0, 0, 0]);
        let none = f.path().join("images");
        assert!(masks(f.path(), Some(&none), &photos[..0]).is_err());
        // COLMAP's model wins over the list, as elsewhere.
        let model = f.path().join("sparse/0");
        std::fs::create_dir_all(&model).unwrap();
        std::fs::write(model.join("cameras.txt"), "1 PINHOLE 4 4 4 4 2 2\n").unwrap();
        std::fs::write(model.join("images.txt"), "1 1 0 0 0 0 0 5 1 1.png\n\n2 1 0 0 0 0 0 5 1 2.png\n\n").unwrap();
        std::fs::write(model.join("points3D.txt"), "").unwrap();
        assert_eq!(find(f.path(), None).unwrap().unwrap().poses.photos[0].name, "1.png");
        assert!(find(&f.path().join("masks/images"), Some(&f.path().join("nothing"))).is_err());
    }
}
