//! One thing alone with clear surroundings, in the layout of NeRF's synthetic sets (Mildenhall et al. 2020).

use glam::{DMat3, DVec3, Vec3};
use orb_formats::File;
use rayon::prelude::*;
use serde_json::json;

use super::site::{Options, plain_png, text_of};
use super::{Random, rgba, things};
use crate::audit::Marking;
use crate::splat::Camera;
use crate::{Result, views};

/// Cameras of NeRF's synthetic sets stand so far from the middle; their field of view in radians.
const NERF_DISTANCE: f32 = 4.031;
const NERF_FOV: f32 = 0.691_111;

/// Set number `index`: its name and its files: `train`, `test`, and their lists.
///
/// # Errors
/// None in practice: what is made fits its formats.
pub fn thing(index: usize, options: &Options, random: &mut Random, marking: &Marking) -> Result<(String, Vec<File>)> {
    let kind = &things::KINDS[index % things::KINDS.len()];
    let name = format!("{index:02}_{}_nerf", kind.name);
    let (mut mesh, texture) = things::build(kind, random);
    let (low, high) = mesh.bounds();
    // As large as NeRF's are: in a ball of radius 1.2.
    let (middle, scale) = ((low + high) / 2.0, 1.2 / (low.distance(high) / 2.0));
    mesh.positions.iter_mut().for_each(|p| *p = (*p - middle) * scale);
    let mut files = Vec::new();
    let tests = (options.count / 4).max(1);
    for (group, count) in [("train", options.count), ("test", tests)] {
        let cameras: Vec<Camera> = (0..count)
            .map(|k| {
                let golden = 137.508 * k as f32 + if group == "test" { 61.0 } else { 0.0 };
                let elevation = (random.uniform() * 0.95).asin().to_degrees();
                Camera::look_at(views::eye(golden, elevation, NERF_DISTANCE), Vec3::ZERO, NERF_FOV, options.width)
            })
            .collect();
        let pictures: Vec<image::RgbaImage> = cameras.par_iter().map(|c| rgba(&mesh, &texture, c)).collect();
        let mut frames = Vec::new();
        for (k, (c, picture)) in cameras.iter().zip(pictures).enumerate() {
            let path = format!("{name}/{group}/r_{k}.png");
            files.push(File { path, bytes: plain_png(picture.into(), marking)?, media_type: "image/png" });
            // Camera→world; x right, y up, z backwards.
            let to_world: DMat3 = DMat3::from_cols_array(&c.rotation.to_cols_array().map(f64::from)).transpose();
            let m = to_world * DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0));
            let eye = c.position().as_dvec3();
            let row = |i: usize| [m.col(0)[i], m.col(1)[i], m.col(2)[i], eye[i]];
            frames.push(json!({
                "file_path": format!("./{group}/r_{k}"),
                "transform_matrix": [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]],
            }));
        }
        let list = json!({"camera_angle_x": NERF_FOV, "frames": frames});
        let path = format!("{name}/transforms_{group}.json");
        files.push(File { path, bytes: text_of(&list)?, media_type: "application/json" });
    }
    Ok((name, files))
}

#[cfg(test)]
mod tests {
    use super::super::site::tests::{options, written};
    use super::*;
    use crate::photos::dataset;

    #[test]
    fn nerfs_layout_is_read_back() {
        let (_keep, at) = written(&options(true));
        let found = dataset::find(&at, None).unwrap().unwrap();
        assert_eq!(found.poses.photos.len(), 7);
        assert_eq!(found.held_out.unwrap().iter().filter(|h| **h).count(), 1);
        let p = &found.poses.photos[3];
        assert!((p.centre().length() - f64::from(NERF_DISTANCE)).abs() < 1e-4);
        // All look at the middle.
        let [x, y] = p.pixel(DVec3::ZERO).unwrap();
        assert!((x - 32.0).abs() < 1e-3 && (y - 32.0).abs() < 1e-3);
        let image = image::open(&p.file).unwrap().into_rgba8();
        assert!(image.get_pixel(32, 32).0[3] == 255 && image.get_pixel(0, 0).0[3] == 0);
    }
}
