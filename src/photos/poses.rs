//! Which photos there are in a folder and where their cameras stood.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use glam::{DQuat, DVec3};

use super::{colmap, transforms};
use crate::{Error, Result};

/// A photo and its camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Posed {
    /// File name.
    pub name: String,
    pub file: PathBuf,
    pub camera: colmap::Camera,
    /// World→camera, OpenCV axes.
    pub rotation: DQuat,
    pub translation: DVec3,
}

impl Posed {
    /// The eye in world coordinates.
    pub fn centre(&self) -> DVec3 {
        -(self.rotation.inverse() * self.translation)
    }

    /// Where a point of the world falls in the picture without distortion, pixels of the camera; `None` behind it.
    pub fn pixel(&self, p: DVec3) -> Option<[f64; 2]> {
        let q = self.rotation * p + self.translation;
        let [fx, fy, cx, cy] = self.camera.pinhole();
        (q.z > 1e-9).then(|| [fx * q.x / q.z + cx, fy * q.y / q.z + cy])
    }
}

/// A photo shows a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// Among [`Poses::photos`].
    pub photo: usize,
    /// Among [`Poses::points`].
    pub point: usize,
    /// Pixels of the photo as it was taken, with its lens's distortion.
    pub at: [f64; 2],
}

/// Photos of one thing, in a world whose scale, place and up are nobody's yet.
#[derive(Clone, Debug)]
pub struct Poses {
    /// By name.
    pub photos: Vec<Posed>,
    /// Triangulated points and their colours.
    pub points: Vec<(DVec3, [u8; 3])>,
    /// Where the photos show the points; none where nobody says it.
    pub observations: Vec<Observation>,
    /// What was read, for people: `the COLMAP model sparse/0`.
    pub source: String,
    /// The files that say it.
    pub files: Vec<PathBuf>,
    /// What a user should know of them.
    pub notes: Vec<String>,
}

/// The photos directly in a folder, or in its `images` where it has none itself, by name.
///
/// # Errors
/// Environment for a folder that cannot be read; usage for one with fewer than two photos.
pub fn photos_in(folder: &Path) -> Result<Vec<PathBuf>> {
    let list = |folder: &Path| -> Result<Vec<PathBuf>> {
        let mut all = Vec::new();
        for entry in std::fs::read_dir(folder).map_err(|e| Error::io(folder, &e))? {
            let path = entry.map_err(|e| Error::io(folder, &e))?.path();
            let ending = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
            if path.is_file()
                && ["jpg", "jpeg", "heic", "heif", "png", "webp", "tif", "tiff"].contains(&ending.as_str())
            {
                all.push(path);
            }
        }
        all.sort();
        Ok(all)
    };
    let mut all = list(folder)?;
    if all.is_empty() && folder.join("images").is_dir() {
        all = list(&folder.join("images"))?;
    }
    if all.len() < 2 {
        return Err(Error::usage(folder.display().to_string())
            .expected("at least two photos (JPEG, HEIC, PNG, WebP, TIFF) in the folder or its `images`")
            .found(format!("{}", all.len())));
    }
    Ok(all)
}

/// The poses of the photos of a folder: from `given`, a COLMAP model's folder, a folder of models, or a list; else from what
/// lies in the folder or beside it. `None` where nothing is given and nothing is there.
///
/// # Errors
/// As the readers; usage where fewer than two photos have a pose.
pub fn find(folder: &Path, given: Option<&Path>) -> Result<Option<Poses>> {
    let photos = photos_in(folder)?;
    let Some(found) = (match given {
        Some(path) => Some(named(path)?),
        None => {
            let beside = photos[0].parent().filter(|p| *p != folder).map(Path::to_path_buf);
            let above = folder.canonicalize().ok().and_then(|p| p.parent().map(Path::to_path_buf));
            let mut found = None;
            for place_there in [Some(folder.to_path_buf()), beside, above].into_iter().flatten() {
                found = place(&place_there, false)?;
                if found.is_some() {
                    break;
                }
            }
            found
        }
    }) else {
        return Ok(None);
    };
    let read = match &found {
        Place::Model(model) => of_model(model)?.matched(&photos),
        Place::List(list) => of_list(list, &photos),
    };
    read.map(Some)
}

/// What the user names.
pub(super) fn named(path: &Path) -> Result<Place> {
    place(path, true)?.ok_or_else(|| {
        Error::usage(path.display().to_string())
            .expected("a COLMAP model (cameras, images, points3D; .bin or .txt), a folder of them, or transforms.json")
            .found("none of them")
    })
}

/// Where poses stand.
pub(super) enum Place {
    Model(PathBuf),
    List(PathBuf),
}

fn is_model(folder: &Path) -> bool {
    ["cameras.bin", "cameras.txt"].iter().any(|f| folder.join(f).is_file())
}

/// A model, the largest of several, or a list, in this order. `named`: by the user, so that its own folders may be models; beside
/// photos lie other things too.
pub(super) fn place(path: &Path, named: bool) -> Result<Option<Place>> {
    if path.is_file() {
        return Ok(Some(Place::List(path.to_owned())));
    }
    if is_model(path) {
        return Ok(Some(Place::Model(path.to_owned())));
    }
    let own = named.then(|| path.to_path_buf());
    for folder in own.into_iter().chain([path.join("sparse"), path.join("colmap/sparse")]) {
        if is_model(&folder) {
            return Ok(Some(Place::Model(folder)));
        }
        let mut models: Vec<PathBuf> = match std::fs::read_dir(&folder) {
            Ok(entries) => entries.filter_map(|e| Some(e.ok()?.path())).filter(|p| is_model(p)).collect(),
            Err(_) => Vec::new(),
        };
        models.sort();
        let mut largest: Option<(usize, PathBuf)> = None;
        for model in models {
            let images = colmap::read(&model)?.images.len();
            if largest.as_ref().is_none_or(|(most, _)| images > *most) {
                largest = Some((images, model));
            }
        }
        if let Some((_, model)) = largest {
            return Ok(Some(Place::Model(model)));
        }
    }
    let lists = ["transforms.json", "transforms_train.json"].map(|l| path.join(l));
    Ok(lists.into_iter().find(|l| l.is_file()).map(Place::List))
}

/// A COLMAP model as it is; the photos' files not known yet.
///
/// # Errors
/// As [`colmap::read`]; usage for a model without images.
pub fn of_model(folder: &Path) -> Result<Poses> {
    let model = colmap::read(folder)?;
    let photos: Vec<Posed> = model
        .images
        .iter()
        .filter_map(|i| {
            let camera = model.cameras.get(&i.camera)?.clone();
            let (rotation, translation) = (i.rotation, i.translation);
            Some(Posed { name: i.name.clone(), file: PathBuf::new(), camera, rotation, translation })
        })
        .collect();
    if photos.is_empty() {
        return Err(Error::usage(folder.display().to_string()).expected("a model with images").found("none"));
    }
    let numbers: BTreeMap<u64, usize> = model.points.iter().enumerate().map(|(n, p)| (p.id, n)).collect();
    let observations = |(photo, image): (usize, &colmap::Image)| -> Vec<Observation> {
        let of = |(at, id): &([f64; 2], Option<u64>)| {
            let point = *numbers.get(id.as_ref()?)?;
            Some(Observation { photo, point, at: *at })
        };
        image.observations.iter().filter_map(of).collect()
    };
    let file =
        |stem: &str| ["bin", "txt"].map(|e| folder.join(format!("{stem}.{e}"))).into_iter().find(|p| p.is_file());
    Ok(Poses {
        photos,
        points: model.points.iter().map(|p| (p.position, p.color)).collect(),
        // Every image has its camera, so that both lists are alike.
        observations: model.images.iter().enumerate().flat_map(observations).collect(),
        source: format!("the COLMAP model {}", folder.display()),
        files: ["cameras", "images", "points3D"].into_iter().filter_map(file).collect(),
        notes: Vec::new(),
    })
}

/// A list's poses of these photos. Who wrote the list may be anyone: no other file that it names is opened.
fn of_list(list: &Path, photos: &[PathBuf]) -> Result<Poses> {
    let there = ByName::new(photos);
    let listed = transforms::read_of(list, &|name| there.find(name).cloned())?;
    let posed_at_all = listed.len();
    let posed = |l: transforms::Listed| Posed {
        name: l.name,
        file: l.file,
        camera: l.camera,
        rotation: l.rotation,
        translation: l.translation,
    };
    let poses = Poses {
        photos: listed.into_iter().flatten().map(posed).collect(),
        points: Vec::new(),
        observations: Vec::new(),
        source: format!("the list {}", list.display()),
        files: vec![list.to_owned()],
        notes: Vec::new(),
    };
    poses.matched_of(posed_at_all, photos)
}

fn last(p: &Path) -> String {
    p.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Photos by their names' last part, and by that without its ending.
struct ByName<'a> {
    last: BTreeMap<String, &'a PathBuf>,
    stem: BTreeMap<String, &'a PathBuf>,
}

impl<'a> ByName<'a> {
    fn new(photos: &'a [PathBuf]) -> Self {
        let (mut by_last, mut by_stem) = (BTreeMap::new(), BTreeMap::new());
        for p in photos {
            by_last.insert(last(p), p);
            by_stem.insert(stem(p), p);
        }
        ByName { last: by_last, stem: by_stem }
    }

    /// The photo that poses mean by a name; without its ending where that alone fits.
    fn find(&self, name: &str) -> Option<&'a PathBuf> {
        let written = Path::new(name);
        self.last.get(&last(written)).or_else(|| self.stem.get(&stem(written))).copied()
    }
}

fn stem(p: &Path) -> String {
    p.file_stem().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}

impl Poses {
    /// Those whose photo is there, by the name's last part, without its ending where that alone fits.
    pub(super) fn matched(self, photos: &[PathBuf]) -> Result<Poses> {
        let posed = self.photos.len();
        self.matched_of(posed, photos)
    }

    /// As that, where `posed` were read and these may be fewer.
    fn matched_of(mut self, posed: usize, photos: &[PathBuf]) -> Result<Poses> {
        let there = ByName::new(photos);
        let mut out = BTreeMap::new();
        for (n, photo) in self.photos.into_iter().enumerate() {
            if let Some(file) = there.find(&photo.name) {
                out.entry(last(file)).or_insert((n, Posed { name: last(file), file: file.clone(), ..photo }));
            }
        }
        let now: BTreeMap<usize, usize> = out.values().enumerate().map(|(now, (n, _))| (*n, now)).collect();
        self.observations =
            self.observations.iter().filter_map(|o| Some(Observation { photo: *now.get(&o.photo)?, ..*o })).collect();
        self.photos = out.into_values().map(|p| p.1).collect();
        let matched = self.photos.len();
        if matched < 2 {
            return Err(Error::usage(self.source)
                .expected("poses of at least two of the photos")
                .found(format!("{matched}: {posed} poses, {} photos, other names", photos.len()))
                .advice(format!("The first photo is {}.", photos.first().map(|p| last(p)).unwrap_or_default())));
        }
        if matched < photos.len() {
            self.notes.push(format!(
                "{} of {} photos have no pose and are not used",
                photos.len() - matched,
                photos.len()
            ));
        }
        if matched < posed {
            self.notes.push(format!("{} of {posed} poses have no photo", posed - matched));
        }
        self.note_lenses();
        Ok(self)
    }

    /// Says which lenses are straightened.
    pub(super) fn note_lenses(&mut self) {
        let mut bent: Vec<&str> =
            self.photos.iter().filter(|p| !p.camera.lens.is_pinhole()).map(|p| p.camera.lens.name()).collect();
        bent.sort_unstable();
        bent.dedup();
        if !bent.is_empty() {
            self.notes.push(format!("lens distortion is taken out of the photos ({})", bent.join(", ")));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(photos: &[&str]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for name in photos {
            image::RgbImage::new(4, 4).save(folder.path().join(name)).unwrap();
        }
        folder
    }

    fn model(at: &Path, names: &[&str]) {
        std::fs::create_dir_all(at).unwrap();
        std::fs::write(at.join("cameras.txt"), "1 SIMPLE_RADIAL 4 4 4 2 2 0.01\n").unwrap();
        let lines: Vec<String> =
            names.iter().enumerate().map(|(i, n)| format!("{} 1 0 0 0 0 0 5 1 {n}\n\n", i + 1)).collect();
        std::fs::write(at.join("images.txt"), lines.concat()).unwrap();
        std::fs::write(at.join("points3D.txt"), "1 1 2 3 9 8 7 0.5 1 0\n").unwrap();
    }

    #[test]
    fn the_largest_model_beside_the_photos_is_taken() {
        let f = folder(&["a.png", "b.png", "c.png"]);
        assert!(find(f.path(), None).unwrap().is_none());
        model(&f.path().join("sparse/0"), &["a.png", "lost.png"]);
        model(&f.path().join("sparse/1"), &["sub/a.png", "b.jpg", "d.png"]);
        let found = find(f.path(), None).unwrap().unwrap();
        assert!(found.source.contains("sparse/1") && found.files.len() == 3 && found.points.len() == 1);
        let names: Vec<&str> = found.photos.iter().map(|p| p.name.as_str()).collect();
        assert_eq!(names, ["a.png", "b.png"]);
        assert!(found.notes.join(";").contains("1 of 3 photos") && found.notes.join(";").contains("SIMPLE_RADIAL"));
        assert_eq!(found.photos[0].centre(), DVec3::new(0.0, 0.0, -5.0));
        assert_eq!(found.photos[0].pixel(DVec3::ZERO), Some([2.0, 2.0]));
        let e = find(f.path(), Some(&f.path().join("sparse/0"))).unwrap_err().to_string();
        assert!(e.contains("2 poses, 3 photos"), "{e}");
        assert!(find(f.path(), Some(Path::new("/nowhere"))).unwrap_err().to_string().contains("/nowhere"));
    }

    #[test]
    fn a_list_may_lie_anywhere_and_opens_no_file_but_the_photos() {
        let (f, elsewhere) = (folder(&["a.png", "b.png"]), tempfile::tempdir().unwrap());
        let list = elsewhere.path().join("transforms.json");
        let of = |names: &[&str]| {
            let frame = |n: &&str| {
                format!(r#"{{"file_path": "{n}", "transform_matrix": [[1,0,0,0],[0,0,-1,-3],[0,1,0,0],[0,0,0,1]]}}"#)
            };
            let frames: Vec<String> = names.iter().map(frame).collect();
            std::fs::write(&list, format!(r#"{{"camera_angle_x": 1.0, "frames": [{}]}}"#, frames.join(","))).unwrap();
            find(f.path(), Some(&list)).map(|found| format!("{:?}", found.unwrap())).map_err(|e| e.to_string())
        };
        of(&["./images/a.png", "b"]).unwrap();
        let found = find(f.path(), Some(&list)).unwrap().unwrap();
        assert_eq!((found.photos.len(), found.photos[1].camera.width), (2, 4));
        assert!(found.photos[1].file == f.path().join("b.png") && found.notes.is_empty(), "{:?}", found.notes);
        // One is there and no picture, one a picture of another size, one is missing.
        let [words, picture, missing] = ["words.png", "picture.png", "no.png"].map(|n| elsewhere.path().join(n));
        std::fs::write(&words, "x").unwrap();
        image::RgbImage::new(9, 9).save(&picture).unwrap();
        let answers = [&words, &picture, &missing].map(|outside| {
            let outside = outside.to_str().unwrap().replace('\\', "/");
            [of(&["a.png", "b.png", &outside]), of(&["a.png", &outside])]
        });
        assert!(answers[0][0].as_ref().unwrap().contains("1 of 3 poses have no photo"), "{answers:?}");
        assert!(answers[0][1].as_ref().unwrap_err().contains("1: 2 poses, 2 photos"), "{answers:?}");
        assert!(answers[0] == answers[1] && answers[1] == answers[2], "{answers:?}");
    }

    #[test]
    fn photos_may_lie_in_a_folder_of_their_own() {
        let f = folder(&[]);
        std::fs::create_dir(f.path().join("images")).unwrap();
        assert!(photos_in(f.path()).unwrap_err().to_string().contains("at least two photos"));
        for n in ["2.png", "1.png"] {
            image::RgbImage::new(4, 4).save(f.path().join("images").join(n)).unwrap();
        }
        model(&f.path().join("sparse"), &["1.png", "2.png"]);
        for place in [f.path().to_path_buf(), f.path().join("images")] {
            assert_eq!(find(&place, None).unwrap().unwrap().photos[1].name, "2.png");
        }
    }
}
