//! A body of a scene as a model of its own, standing on the terrain.

use glam::{DVec3, Mat3, Vec3};

use super::{OnEarth, PlacedLevel, import};
use crate::geo::{HeadingSource, Placement};
use crate::mesh;
use crate::mesh::smooth::turn_out;
use crate::pipeline::scene::bodies::Body;
use crate::pipeline::scene::ground::Surface;
use crate::progress::Progress;
use crate::splat::Gaussians;
use crate::{Error, Result};

/// What is made of a body: smaller than the main job's, as there are many.
fn options() -> mesh::Options {
    mesh::Options {
        voxels: 96,
        vertex_caps: [2048, 1024, 512, 128],
        texture_size: [512, 256, 128, 64],
        views: 32,
        view_size: 192,
        color_views: 24,
        color_size: 320,
        ..mesh::Options::default()
    }
}

/// A body's surface in metres about the middle of its footprint on the terrain, finest level first, and where that is.
///
/// `g`: of the whole scene, unit frame.
///
/// # Errors
/// As [`mesh::build`].
pub fn standing(
    g: &Gaussians,
    body: &Body,
    surface: &Surface,
    earth: &OnEarth,
    progress: &dyn Progress,
) -> Result<(Vec<PlacedLevel>, Placement)> {
    let scale = earth.registration.to_enu.scale;
    let base = body.middle.extend(surface.height(body.middle));
    let own = g.filtered(|i| body.members.binary_search(&i).is_ok());
    let in_metres = own.transformed(Mat3::IDENTITY, scale as f32, -(scale as f32) * base);
    let mut levels = import::surface(&in_metres, options(), progress)?;
    let bounds = levels.first().and_then(|l| l.mesh.bounds());
    let (low, high) = bounds.ok_or_else(|| Error::usage("a body of the scene").found("no surface"))?;
    let middle = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
    for level in &mut levels {
        stand(&mut level.mesh, middle);
    }
    let moved = base + Vec3::new(middle[0] as f32, middle[1] as f32, 0.0) / scale as f32;
    let on = DVec3::new(moved.x.into(), moved.y.into(), surface.height(moved.truncate()).into());
    let placement = Placement {
        origin: earth.place(on),
        heading: earth.registration.heading(),
        heading_source: HeadingSource::Georegistration,
    };
    Ok((levels, placement))
}

/// Moves a mesh over the origin and draws it out, or pushes it together, until it stands on the ground: its top stays where it
/// is. The Gaussians of its foot were taken for ground.
fn stand(mesh: &mut orb_formats::Mesh, middle: [f64; 2]) {
    let Some((low, high)) = mesh.bounds() else { return };
    let by = if high[2] > 0.0 && high[2] > low[2] { high[2] / (high[2] - low[2]) } else { 1.0 };
    for p in &mut mesh.positions {
        *p = [p[0] - middle[0], p[1] - middle[1], ((p[2] - low[2]) * by).max(0.0)];
    }
    let turned = |n: &[f32; 3]| Vec3::new(n[0], n[1], n[2] / by as f32).normalize_or(Vec3::from_array(*n));
    let mut normals: Vec<Vec3> = mesh.normals.iter().map(turned).collect();
    // What lies along a triangle's normal by little may lie against it once each corner's is turned and of length 1 again.
    let positions: Vec<Vec3> = mesh.positions.iter().map(|p| DVec3::from_array(*p).as_vec3()).collect();
    turn_out(&positions, &mesh.triangles, &mut normals);
    mesh.normals = normals.iter().map(Vec3::to_array).collect();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_reaches_the_ground_and_keeps_its_top_and_its_normals() {
        for (low, by) in [(0.5, 4.0 / 3.5), (-0.4, 4.0 / 4.4), (0.0, 1.0)] {
            let mut mesh = orb_formats::Mesh {
                positions: vec![[3.0, 5.0, low], [4.0, 5.0, low], [3.0, 5.0, 4.0]],
                normals: vec![[0.0, -0.8, 0.6], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]],
                uvs: Vec::new(),
                triangles: vec![[0, 1, 2]],
            };
            stand(&mut mesh, [3.5, 5.0]);
            assert_eq!(mesh.positions, [[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0], [-0.5, 0.0, 4.0]]);
            // A plane of the steepness of the first normal keeps it.
            let n = Vec3::from_array(mesh.normals[0]);
            let along = Vec3::new(0.0, 0.6, 0.8 * by as f32);
            assert!(n.dot(along).abs() < 1e-6 && (n.length() - 1.0).abs() < 1e-6, "{n}");
            assert_eq!(mesh.normals[1..], [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
        }
    }

    #[test]
    fn a_triangle_faces_as_its_corners_do_when_pushed_together() {
        let mut mesh = orb_formats::Mesh {
            positions: vec![[3.0, 5.0, -12.0], [4.0, 5.0, -12.0], [3.0, 5.0, 4.0]],
            normals: [[0.0, -0.2, 0.98], [0.0, -0.2, 0.98], [0.0, 0.39, -0.92]]
                .map(|n| Vec3::from_array(n).normalize().to_array())
                .to_vec(),
            uvs: Vec::new(),
            triangles: vec![[0, 1, 2]],
        };
        let along = |m: &orb_formats::Mesh| -m.normals.iter().map(|n| n[1]).sum::<f32>();
        assert!(along(&mesh) > 0.0);
        stand(&mut mesh, [3.5, 5.0]);
        assert!(along(&mesh) > 0.0, "{:?}", mesh.normals);
    }
}
