//! Lists of posed pictures: `transforms.json` of NeRF (Mildenhall et al. 2020), with the fields that Instant-NGP and
//! Nerfstudio add for cameras that are not alike or not straight.

use std::path::{Path, PathBuf};

use glam::{DMat3, DQuat, DVec3};
use serde::Deserialize;

use super::colmap::{Camera, Lens};
use crate::{Error, Result};

/// A picture of the list.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    /// As written.
    pub name: String,
    /// Beside the list, `.png` where nothing is written; or among given photos.
    pub file: PathBuf,
    pub camera: Camera,
    /// World→camera, OpenCV axes.
    pub rotation: DQuat,
    pub translation: DVec3,
}

/// A camera's inside, for the whole list or for one frame.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
struct Inside {
    camera_angle_x: Option<f64>,
    fl_x: Option<f64>,
    fl_y: Option<f64>,
    cx: Option<f64>,
    cy: Option<f64>,
    w: Option<f64>,
    h: Option<f64>,
    k1: Option<f64>,
    k2: Option<f64>,
    k3: Option<f64>,
    k4: Option<f64>,
    p1: Option<f64>,
    p2: Option<f64>,
}

#[derive(Deserialize)]
struct List {
    camera_model: Option<String>,
    #[serde(flatten)]
    inside: Inside,
    frames: Vec<Frame>,
    /// Nerfstudio's: points, beside the list.
    ply_file_path: Option<PathBuf>,
}

#[derive(Deserialize)]
struct Frame {
    file_path: String,
    #[serde(flatten)]
    inside: Inside,
    /// Camera→world, rows; x right, y up, z backwards.
    transform_matrix: Vec<[f64; 4]>,
}

/// The points that a list names, in its own world; none where it names none.
///
/// # Errors
/// Usage, naming the file, for a list or points that cannot be read.
pub fn points(list: &Path) -> Result<Option<(PathBuf, Vec<orb_formats::ply::Point>)>> {
    let Some(named) = parsed(list)?.ply_file_path else { return Ok(None) };
    let file = list.parent().unwrap_or(Path::new(".")).join(named);
    let bytes = std::fs::read(&file).map_err(|e| Error::io(&file, &e).advice("The list names it: ply_file_path."))?;
    let wrong =
        |e: orb_formats::Error| Error::usage(file.display().to_string()).expected("points").found(e.to_string());
    let points = orb_formats::ply::points(&bytes).map_err(wrong)?;
    Ok(Some((file, points)))
}

/// Reads a list. The pictures' sizes are looked up where it does not say them.
///
/// # Errors
/// Usage, naming the list and the frame, for one that cannot be read or has a camera that is none.
pub fn read(list: &Path) -> Result<Vec<Listed>> {
    let folder = list.parent().unwrap_or(Path::new("."));
    let beside = |name: &str| {
        let mut file = folder.join(name);
        if file.extension().is_none() {
            file.set_extension("png");
        }
        Some(file)
    };
    Ok(read_of(list, &beside)?.into_iter().flatten().collect())
}

/// As [`read`], of the frames that `file` knows the picture of, by what is written; `None` for the others, and no other file
/// is looked at.
///
/// # Errors
/// As [`read`].
pub fn read_of(list: &Path, file: &dyn Fn(&str) -> Option<PathBuf>) -> Result<Vec<Option<Listed>>> {
    let wrong =
        |expected: &str, found: String| Error::usage(list.display().to_string()).expected(expected).found(found);
    let read = parsed(list)?;
    if read.frames.is_empty() {
        return Err(wrong("frames", "none".into()));
    }
    let of = |f: &Frame| file(&f.file_path).map(|file| listed(f, &read, file, &wrong)).transpose();
    read.frames.iter().map(of).collect()
}

fn parsed(list: &Path) -> Result<List> {
    let bytes = std::fs::read(list).map_err(|e| Error::io(list, &e))?;
    serde_json::from_slice(&bytes).map_err(|e| {
        Error::usage(list.display().to_string())
            .expected("frames with a file_path and a transform_matrix as NeRF writes them")
            .found(e.to_string())
    })
}

fn listed(f: &Frame, list: &List, file: PathBuf, wrong: &dyn Fn(&str, String) -> Error) -> Result<Listed> {
    let of = |pick: fn(&Inside) -> Option<f64>| pick(&f.inside).or(pick(&list.inside));
    let size = match (of(|i| i.w), of(|i| i.h)) {
        (Some(w), Some(h)) if [w, h].iter().all(|v| v.fract() == 0.0 && (1.0..=65_535.0).contains(v)) => {
            (w as u32, h as u32)
        }
        (None, None) => image::image_dimensions(&file)
            .map_err(|e| Error::usage(file.display().to_string()).expected("a picture").found(e.to_string()))?,
        (w, h) => {
            return Err(wrong("w and h, whole numbers from 1 to 65535", format!("{w:?} and {h:?} at {}", f.file_path)));
        }
    };
    let (w, h) = (f64::from(size.0), f64::from(size.1));
    let by_angle = of(|i| i.camera_angle_x).map(|a| w / 2.0 / (a / 2.0).tan());
    let Some(fx) = of(|i| i.fl_x).or(by_angle).filter(|v| v.is_finite() && *v > 0.0) else {
        return Err(wrong("camera_angle_x or fl_x above 0", format!("another at {}", f.file_path)));
    };
    let fy = of(|i| i.fl_y).unwrap_or(fx);
    let plain = |v: Option<f64>| v.unwrap_or(0.0);
    let bent = [of(|i| i.k1), of(|i| i.k2), of(|i| i.p1), of(|i| i.p2), of(|i| i.k3), of(|i| i.k4)].map(plain);
    let [k1, k2, p1, p2, k3, k4] = bent;
    let lens = match list.camera_model.as_deref() {
        None | Some("OPENCV" | "PINHOLE" | "SIMPLE_PINHOLE" | "SIMPLE_RADIAL" | "RADIAL") if bent == [0.0; 6] => {
            Lens::Pinhole
        }
        None | Some("OPENCV" | "SIMPLE_RADIAL" | "RADIAL" | "FULL_OPENCV") => Lens::FullOpenCv,
        Some("OPENCV_FISHEYE") => Lens::OpenCvFisheye,
        Some(other) => return Err(wrong("camera_model OPENCV, OPENCV_FISHEYE or PINHOLE", other.to_owned())),
    };
    let mut parameters = vec![fx, fy, of(|i| i.cx).unwrap_or(w / 2.0), of(|i| i.cy).unwrap_or(h / 2.0)];
    match lens {
        Lens::OpenCvFisheye => parameters.extend([k1, k2, k3, k4]),
        Lens::FullOpenCv => parameters.extend([k1, k2, p1, p2, k3, k4, 0.0, 0.0]),
        _ => {}
    }
    let row = |i: usize| f.transform_matrix.get(i).map(|r| DVec3::new(r[0], r[1], r[2]));
    let bad = || {
        wrong(
            "a camera→world matrix whose first three columns are a rotation",
            format!("another camera at {}", f.file_path),
        )
    };
    let (Some(a), Some(b), Some(c)) = (row(0), row(1), row(2)) else { return Err(bad()) };
    let eye = DVec3::new(f.transform_matrix[0][3], f.transform_matrix[1][3], f.transform_matrix[2][3]);
    // Rows to columns, and from NeRF's axes to OpenCV's.
    let turn = DMat3::from_cols(a, b, c).transpose() * DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0));
    let unit = (turn * turn.transpose() - DMat3::IDENTITY).to_cols_array().iter().all(|v| v.abs() < 1e-3);
    if !(unit && turn.determinant() > 0.0 && eye.is_finite() && parameters.iter().all(|v| v.is_finite()) && fy > 0.0) {
        return Err(bad());
    }
    let rotation = DQuat::from_mat3(&turn.transpose()).normalize();
    Ok(Listed {
        name: f.file_path.clone(),
        file,
        camera: Camera { lens, width: size.0, height: size.1, parameters },
        rotation,
        translation: -(rotation * eye),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: &str = r#"{"file_path": "./a.jpg", "transform_matrix": [[1,0,0,0],[0,0,-1,-3],[0,1,0,0],[0,0,0,1]]}"#;

    fn of(head: &str, frame: &str) -> Result<Vec<Listed>> {
        let folder = tempfile::tempdir().unwrap();
        let list = folder.path().join("transforms.json");
        std::fs::write(&list, format!("{{{head}, \"frames\": [{frame}]}}")).unwrap();
        read(&list)
    }

    #[test]
    fn cameras_with_and_without_distortion() {
        let plain = r#""camera_angle_x": 1.5707963267948966, "w": 400, "h": 300"#;
        let one = of(plain, FRAME).unwrap().remove(0);
        assert_eq!((one.camera.lens, one.camera.parameters[2]), (Lens::Pinhole, 200.0));
        assert!((one.camera.parameters[0] - 200.0).abs() < 1e-9);
        let eye = -(one.rotation.inverse() * one.translation);
        assert!(
            (eye - DVec3::new(0.0, -3.0, 0.0)).length() < 1e-12
                && (one.rotation * DVec3::Y - DVec3::Z).length() < 1e-12
        );
        let bent =
            of(r#""fl_x": 500, "w": 400, "h": 300, "k1": 0.1, "p1": 0.01, "camera_model": "OPENCV""#, FRAME).unwrap();
        assert_eq!(bent[0].camera.parameters, [500.0, 500.0, 200.0, 150.0, 0.1, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let own = FRAME.replace("\"transform", "\"fl_x\": 7, \"cx\": 9, \"transform");
        assert_eq!(of(plain, &own).unwrap()[0].camera.parameters[..3], [7.0, 7.0, 9.0]);
    }

    #[test]
    fn what_is_wrong_is_named() {
        let plain = r#""camera_angle_x": 1.0, "w": 4, "h": 3"#;
        for (head, frame, said) in [
            (plain, FRAME.replace("-1,-3", "-2,-3"), "./a.jpg"),
            (plain, FRAME.replace("[0,1,0,0],[0,0,0,1]", ""), "transforms.json"),
            (r#""w": 4, "h": 3"#, FRAME.into(), "camera_angle_x"),
            (r#""fl_x": 4, "w": 4.5, "h": 3"#, FRAME.into(), "whole numbers"),
            (r#""fl_x": 4, "w": 4, "h": 3, "camera_model": "ROUND""#, FRAME.into(), "ROUND"),
            (r#""fl_x": 4"#, FRAME.into(), "a.jpg"),
        ] {
            let e = of(head, &frame).unwrap_err().to_string();
            assert!(e.contains(said), "{said}: {e}");
        }
    }
}
