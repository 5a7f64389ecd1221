//! Gaussians to files: PLY, SPZ, glTF.

use glam::{Mat3, Vec3};
use orb_formats::tiles3d::{self, Tile, Tileset, Volume};
use orb_formats::{Asset, File, Splats, glb, ply, spz};

use super::model::to_earth;
use super::{Labels, ToMetres, format_error, label};
use crate::Result;
use crate::audit::Marking;
use crate::geo::Placement;
use crate::geo::similarity::Similarity;
use crate::splat::Gaussians;

/// The comment by which Orb knows its own axes again.
pub const FRAME: &str = "frame: subject, right-handed, metres, Z up, +Y where the camera pointed, origin on the ground";

/// Gaussians of the unit frame as `path` in metres, the georeference in the header's comments, the marking first.
pub fn gaussians_ply(
    path: &str,
    g: &Gaussians,
    to_metres: &ToMetres,
    placement: &Placement,
    labels: &Labels,
) -> Result<File> {
    let centre = -to_metres.scale * to_metres.base;
    let mut comments = comments(placement, labels);
    comments.push(format!("unit frame: centre {} {} {} m, radius {} m", centre.x, centre.y, centre.z, to_metres.scale));
    ply_file(path, &to_metres.gaussians(g), &comments)
}

/// Gaussians in metres as `scene.ply`, with the same comments.
pub fn scene_ply(g: &Gaussians, placement: &Placement, labels: &Labels) -> Result<File> {
    ply_file("scene.ply", g, &comments(placement, labels))
}

/// Gaussians in whatever frame they are in, for a program that draws them there; the marking in the header, where there is one.
pub fn subject_ply(g: &Gaussians, marking: Option<&Marking>) -> Result<Vec<u8>> {
    let comments: Vec<String> = marking.iter().map(|m| m.line()).collect();
    Ok(ply_file("scene.ply", g, &comments)?.bytes)
}

/// Gaussians of the unit frame as `scene.ply`, neither placed nor scaled, the marking first in the header.
pub fn unit_ply(g: &Gaussians, marking: &Marking) -> Result<File> {
    let comments = [
        marking.line(),
        "frame: unit, right-handed, Z up, +Y where the camera pointed, the subject's bounding sphere of radius 1"
            .into(),
        "not placed, not scaled".into(),
    ];
    ply_file("scene.ply", g, &comments)
}

/// The Gaussians of posed photos as `scene.ply`, in the unit frame: `to_unit` says how that lies in the poses' own world.
pub fn posed_ply(g: &Gaussians, to_unit: &Similarity, marking: &Marking) -> Result<File> {
    let comments = [
        marking.line(),
        "frame: unit, right-handed, Z up, +Y where the first photo's camera pointed, the cameras' median distance from what \
         they look at is 1"
            .into(),
        "not placed, not scaled".into(),
        format!("from the poses' world: {to_unit}"),
    ];
    ply_file("scene.ply", g, &comments)
}

fn ply_file(path: &str, g: &Gaussians, comments: &[String]) -> Result<File> {
    let bytes = ply::write(&splats(g), comments).map_err(format_error)?;
    Ok(File { path: path.into(), bytes, media_type: "application/ply" })
}

fn comments(placement: &Placement, labels: &Labels) -> Vec<String> {
    let o = &placement.origin;
    vec![
        labels.marking.line(),
        FRAME.into(),
        format!("origin WGS84 latitude {} longitude {} ellipsoidal height {} m", o.latitude, o.longitude, o.height),
        format!("heading of +Y {} degrees clockwise from true north ({})", placement.heading, labels.heading_source),
        format!("scale source: {}", labels.scale_source),
    ]
}

/// The Gaussians turned to the format's axes: x right, y up, z back.
pub fn spz(g: &Gaussians, labels: &Labels, version: spz::Version) -> Result<File> {
    let options = spz::Options { version, comment: labels.marking.line(), ..spz::Options::default() };
    let bytes = spz::write(&splats(&y_up(g)), &options).map_err(format_error)?;
    Ok(File { path: format!("{}.spz", labels.stem), bytes, media_type: "model/x-spz" })
}

/// The Gaussians as `KHR_gaussian_splatting`.
pub fn splat_glb(g: &Gaussians, placement: &Placement, labels: &Labels) -> Result<File> {
    let bytes = glb::write(&splat_asset(&y_up(g), placement, labels)).map_err(format_error)?;
    Ok(File { path: format!("{}_splats.glb", labels.stem), bytes, media_type: "model/gltf-binary" })
}

/// Gaussians of glTF's axes, with their labels.
pub(super) fn splat_asset(g: &Gaussians, placement: &Placement, labels: &Labels) -> Asset {
    Asset { name: labels.stem.clone(), splats: Some(splats(g)), label: label(placement, labels), ..Asset::default() }
}

/// `tiles3d/tileset.json` with one tile of Gaussians at their place on the Earth.
pub fn splat_tiles3d(g: &Gaussians, placement: &Placement, labels: &Labels) -> Result<Vec<File>> {
    let mut content = splat_glb(g, placement, labels)?;
    content.path = "tiles3d/splats.glb".into();
    // Three standard deviations are drawn.
    let reach = |i: usize| f64::from(3.0 * g.log_scales[i].max_element().exp());
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for (i, p) in g.positions.iter().enumerate() {
        for (axis, at) in p.as_dvec3().to_array().into_iter().enumerate() {
            low[axis] = low[axis].min(at - reach(i));
            high[axis] = high[axis].max(at + reach(i));
        }
    }
    let size = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
    let root = Tile {
        transform: Some(to_earth(placement)),
        volume: Volume::around(low, high),
        geometric_error: 0.0,
        content: Some("splats.glb".into()),
        children: Vec::new(),
    };
    let gltf_extensions = vec!["KHR_gaussian_splatting".into(), "KHR_xmp_json_ld".into()];
    let tileset = Tileset { geometric_error: size, root, gltf_extensions, label: label(placement, labels) };
    let bytes = tiles3d::write(&tileset).map_err(format_error)?;
    let tileset = File { path: "tiles3d/tileset.json".into(), bytes, media_type: "application/json" };
    Ok(vec![tileset, content])
}

/// Subject frame (Z up) → Y up: (x, y, z) → (x, z, −y).
pub(super) fn y_up(g: &Gaussians) -> Gaussians {
    g.transformed(Mat3::from_cols(Vec3::X, Vec3::NEG_Z, Vec3::Y), 1.0, Vec3::ZERO)
}

fn splats(g: &Gaussians) -> Splats {
    Splats {
        positions: g.positions.iter().map(|p| p.to_array()).collect(),
        log_scales: g.log_scales.iter().map(|s| s.to_array()).collect(),
        rotations: g.rotations.clone(),
        logit_opacities: g.logit_opacities.clone(),
        sh: g.sh.clone(),
    }
}
