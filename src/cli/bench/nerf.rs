//! Pictures with poses as NeRF's synthetic scenes have them (Mildenhall et al. 2020): `transforms*.json` beside PNGs.

use std::path::Path;

use glam::Vec3;
use rayon::prelude::*;

use crate::bench::scene;
use crate::splat::render::Shown;
use crate::splat::{Gaussians, SH_COEFFICIENTS, Target};
use crate::{Error, Result};

/// The pictures of a list as targets of equal weight, and whether any has an alpha channel.
///
/// Errors: usage, naming the file, for a list or picture that cannot be read.
pub fn targets(list: &Path) -> Result<(Vec<Target>, bool)> {
    let mut any_alpha = false;
    let mut out = Vec::new();
    for view in scene::transforms(list)? {
        let picture = image::open(&view.file)
            .map_err(|e| Error::usage(view.file.display().to_string()).expected("a picture").found(e.to_string()))?;
        any_alpha |= picture.color().has_alpha();
        let picture = picture.into_rgba32f();
        out.push(Target {
            camera: view.camera,
            color: picture.pixels().map(|p| [p[0], p[1], p[2]]).collect(),
            alpha: picture.pixels().map(|p| p[3]).collect(),
            weight: 1.0,
            refine_pose: None,
            fit_exposure: false,
            held_back: None,
            confidence: None,
            shown: Shown::Color,
            name: view.name,
        });
    }
    Ok((out, any_alpha))
}

/// Points of a binary PLY whose properties are all floats.
///
/// Errors: usage for another file.
pub fn points(path: &Path) -> Result<Vec<Vec3>> {
    let wrong = |found: &str| {
        Error::usage(path.display().to_string())
            .expected("a binary little-endian PLY of float vertices with x, y and z")
            .found(found)
    };
    let bytes = std::fs::read(path).map_err(|e| Error::io(path, &e))?;
    let mark = b"end_header\n";
    let end = bytes.windows(mark.len()).position(|w| w == mark).ok_or_else(|| wrong("no header"))? + mark.len();
    let head = std::str::from_utf8(&bytes[..end]).map_err(|_| wrong("a header that is no text"))?;
    if !head.contains("format binary_little_endian") || head.matches("element ").count() != 1 {
        return Err(wrong("another format or more elements"));
    }
    let count = head.lines().find_map(|l| l.strip_prefix("element vertex ")).and_then(|n| n.trim().parse().ok());
    let count: usize = count.ok_or_else(|| wrong("no number of vertices"))?;
    let properties: Vec<&str> = head.lines().filter_map(|l| l.strip_prefix("property ")).collect();
    let at = |name: &str| properties.iter().position(|p| *p == format!("float {name}"));
    let (Some(x), Some(y), Some(z)) = (at("x"), at("y"), at("z")) else { return Err(wrong("no x, y, z")) };
    let floats = properties.len();
    if properties.iter().any(|p| !p.starts_with("float ")) || (bytes.len() - end) / 4 / floats < count {
        return Err(wrong("other types, or too few bytes"));
    }
    let value = |i: usize, k: usize| {
        let from = end + 4 * (i * floats + k);
        f32::from_le_bytes([bytes[from], bytes[from + 1], bytes[from + 2], bytes[from + 3]])
    };
    Ok((0..count).map(|i| Vec3::new(value(i, x), value(i, y), value(i, z))).collect())
}

/// Grey Gaussians at points, as far across as the three nearest neighbours are away (root mean square), opacity 0.1.
pub fn gaussians(points: Vec<Vec3>) -> Gaussians {
    let n = points.len();
    let spread = |i: usize| {
        let mut near = [f32::INFINITY; 3];
        for (j, p) in points.iter().enumerate() {
            let d = p.distance_squared(points[i]);
            if j != i && d < near[2] {
                near[2] = d;
                near.sort_by(f32::total_cmp);
            }
        }
        let known: Vec<f32> = near.into_iter().filter(|d| d.is_finite()).collect();
        (known.iter().sum::<f32>() / known.len().max(1) as f32).sqrt().max(1e-4).ln()
    };
    Gaussians {
        log_scales: (0..n).into_par_iter().map(|i| Vec3::splat(spread(i))).collect(),
        rotations: vec![[1.0, 0.0, 0.0, 0.0]; n],
        logit_opacities: vec![(0.1f32 / 0.9).ln(); n],
        sh: vec![[[0.0; 3]; SH_COEFFICIENTS]; n],
        positions: points,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_pictures_cameras_and_points() {
        let folder = tempfile::tempdir().unwrap();
        image::RgbaImage::from_pixel(4, 4, image::Rgba([255, 0, 0, 128])).save(folder.path().join("a.png")).unwrap();
        let list = folder.path().join("transforms.json");
        // At (0, -3, 0), looking along +Y with Z up.
        let text = r#"{"camera_angle_x": 1.5707963267948966, "frames": [{"file_path": "./a", "transform_matrix":
            [[1,0,0,0],[0,0,-1,-3],[0,1,0,0],[0,0,0,1]]}]}"#;
        std::fs::write(&list, text).unwrap();
        let (targets, alpha) = targets(&list).unwrap();
        let c = targets[0].camera;
        assert!(alpha && (c.fx - 2.0).abs() < 1e-6 && (c.position() - Vec3::new(0.0, -3.0, 0.0)).length() < 1e-6);
        assert!((c.rotation * Vec3::Y - Vec3::Z).length() < 1e-6, "forward");
        assert!((c.rotation * Vec3::Z + Vec3::Y).length() < 1e-6, "up");
        assert_eq!(targets[0].color[0], [1.0, 0.0, 0.0]);
        std::fs::write(&list, text.replace("-1,-3", "-2,-3")).unwrap();
        assert!(super::targets(&list).unwrap_err().to_string().contains("./a"));

        let path = folder.path().join("p.ply");
        let mut ply = b"ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float y\nproperty float x\nproperty float z\nend_header\n".to_vec();
        ply.extend([2f32, 1.0, 3.0, 0.0, 0.0, 0.0].iter().flat_map(|v| v.to_le_bytes()));
        std::fs::write(&path, &ply).unwrap();
        let p = points(&path).unwrap();
        assert_eq!(p, [Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO]);
        let g = gaussians(p);
        assert!((g.log_scales[0].x - 14f32.sqrt().ln()).abs() < 1e-6);
        std::fs::write(&path, &ply[..ply.len() - 5]).unwrap();
        assert!(points(&path).is_err());
    }
}
