//! From a reconstruction to placed files: metres, subject frame, formats, preview.

mod around;
mod atlas;
mod coarser;
pub mod import;
mod mesh_tree;
mod model;
mod scene;
mod sheet;
mod splat_tree;
mod standing;
mod terrain;

use glam::{Mat3, Vec3};
use image::RgbImage;
use orb_formats::{File, Image, Label, Place, cdb, collada, kmz, openflight, sgi};

use crate::audit::{Marking, inband};
use crate::geo::Placement;
use crate::mesh::{self, Details, Level, Model, provenance};
use crate::models::scene::Subject;
use crate::pipeline::{ExpectedError, Fitted, Reconstruction};
use crate::preview::{self, Tile};
use crate::splat::{self, Camera, Frame, Gaussians};
use crate::{Error, Kind, Result, symmetry, views};

pub use around::Around;
pub use mesh_tree::{FOLDER as MESH_TREE, MeshTree};
pub use model::{glb, tiles3d, usdz};
pub use scene::{gaussians_ply, posed_ply, scene_ply, splat_glb, splat_tiles3d, spz, subject_ply, unit_ply};
pub use sheet::scene_png;
pub use splat_tree::{TILE as TILE_OF_SPLATS, splat_tree};
pub use standing::standing;
pub use terrain::{OnEarth, Patch, add_terrain, fill_from, levels, pixel_of};

/// One level of detail in the subject frame, metres.
#[derive(Clone, Debug)]
pub struct PlacedLevel {
    pub mesh: orb_formats::Mesh,
    /// Sides are powers of two.
    pub texture: RgbImage,
    pub details: Details,
    /// Largest distance to the surface that the levels come from.
    pub error: f64,
    /// Largest distance to the next coarser level; for the coarsest, its size.
    pub significant_size: f64,
}

/// The move from the unit frame to the subject frame: p → scale · (p − base).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToMetres {
    /// Centre of the footprint's rectangle, at the ground, in the unit frame.
    pub base: Vec3,
    pub scale: f32,
}

impl ToMetres {
    /// The finest level's bounding rectangle decides the centre, its lowest vertex the ground.
    pub fn new(finest: &mesh::Mesh, metres_per_unit: f64) -> Self {
        let (low, high) = finest.bounds();
        let centre = (low + high) / 2.0;
        ToMetres { base: Vec3::new(centre.x, centre.y, low.z), scale: metres_per_unit as f32 }
    }

    pub fn gaussians(&self, g: &Gaussians) -> Gaussians {
        g.transformed(Mat3::IDENTITY, self.scale, -self.scale * self.base)
    }

    /// One point, metres.
    pub fn point(&self, p: Vec3) -> [f64; 3] {
        ((p - self.base).as_dvec3() * f64::from(self.scale)).to_array()
    }

    fn mesh(&self, m: &mesh::Mesh) -> orb_formats::Mesh {
        orb_formats::Mesh {
            positions: m.positions.iter().map(|p| self.point(*p)).collect(),
            normals: m.normals.iter().map(|n| n.to_array()).collect(),
            uvs: m.uvs.iter().map(|t| t.to_array()).collect(),
            triangles: m.triangles.clone(),
        }
    }

    /// Finest first, as given.
    pub fn levels(&self, levels: &[Level]) -> Vec<PlacedLevel> {
        let placed = |l: &Level| PlacedLevel {
            mesh: self.mesh(&l.mesh),
            texture: l.texture.clone(),
            details: l.details.clone(),
            error: f64::from(l.error * self.scale),
            significant_size: f64::from(l.error_to_coarser * self.scale),
        };
        levels.iter().map(placed).collect()
    }
}

/// What every writer is told beside the geometry.
#[derive(Clone, Debug, PartialEq)]
pub struct Labels {
    /// The photo's stem, safe for file names.
    pub stem: String,
    pub marking: Marking,
    /// `YYYY-MM-DDTHH:MM:SS.mmmZ`.
    pub utc: String,
    pub heading_source: &'static str,
    pub scale_source: &'static str,
}

/// What a CDB store files a model under.
#[derive(Clone, Debug, PartialEq)]
pub struct Catalogue {
    pub kind: cdb::Kind,
    /// Feature code and subcode.
    pub facc: String,
    pub fsc: u16,
    pub material: cdb::Material,
}

impl Default for Catalogue {
    /// A geospecific man-made object, of the material that is assumed for it.
    fn default() -> Self {
        let facc = "UA005";
        Catalogue { kind: cdb::Kind::Geospecific, facc: facc.into(), fsc: 0, material: cdb::Material::assumed(facc) }
    }
}

/// What the stages handed on, for who measures them: the subject's mask over the whole photo at working resolution, and
/// the network's Gaussians before the optimisation, in the frame of the scene.
pub fn stage_files(
    r: &Reconstruction,
    to_metres: &ToMetres,
    placement: &Placement,
    labels: &Labels,
) -> Result<[File; 2]> {
    let mask = &r.subject.mask;
    let levels = mask.data.iter().map(|v| (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8).collect();
    let image = image::GrayImage::from_raw(mask.width as u32, mask.height as u32, levels)
        .ok_or_else(|| Error::environment("mask.png").found("a mask of another size than its own"))?;
    let mask =
        File { path: "mask.png".into(), bytes: marked_png(&image.into(), &labels.marking)?, media_type: "image/png" };
    Ok([mask, gaussians_ply("network.ply", &r.prior.gaussians, to_metres, placement, labels)?])
}

fn marked_png(image: &image::DynamicImage, marking: &Marking) -> Result<Vec<u8>> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    image.write_to(&mut bytes, image::ImageFormat::Png).map_err(|e| Error::environment("PNG").found(e.to_string()))?;
    Ok(inband::mark_png(&bytes.into_inner(), marking))
}

/// The model for a CDB store; levels finest first.
pub fn cdb_model(levels: &[PlacedLevel], placement: &Placement, labels: &Labels, catalogue: &Catalogue) -> cdb::Model {
    let level = |l: &PlacedLevel| cdb::Level {
        mesh: l.mesh.clone(),
        significant_size: l.significant_size,
        texture: rgb(&l.texture),
    };
    cdb::Model {
        kind: catalogue.kind,
        name: labels.stem.clone(),
        facc: catalogue.facc.clone(),
        fsc: catalogue.fsc,
        material: catalogue.material.clone(),
        latitude: placement.origin.latitude,
        longitude: placement.origin.longitude,
        height: placement.origin.height,
        heading: placement.heading,
        levels: levels.iter().rev().map(level).collect(),
        marking: labels.marking.line(),
        date: openflight_date(&labels.utc),
        dbf_date: dbf_date(&labels.utc),
        comment: "made by Orb".into(),
    }
}

/// One OpenFlight file with every level, its geometry turned so that +Y is true north, and its textures with their
/// attributes. Levels blend into one another over the last tenth of their distances.
pub fn flt(
    levels: &[PlacedLevel],
    geometry: openflight::Geometry,
    placement: &Placement,
    labels: &Labels,
) -> Result<Vec<File>> {
    let stem = &labels.stem;
    let coarsest_first: Vec<&PlacedLevel> = levels.iter().rev().collect();
    let turned: Vec<orb_formats::Mesh> = coarsest_first.iter().map(|l| to_north(&l.mesh, placement.heading)).collect();
    let center = turned
        .last()
        .and_then(orb_formats::Mesh::bounds)
        .map_or([0.0; 3], |(low, high)| std::array::from_fn(|i| (low[i] + high[i]) / 2.0));
    let mut files = Vec::new();
    let mut model = openflight::Model {
        name: stem.clone(),
        date: openflight_date(&labels.utc),
        origin: Some((placement.origin.latitude, placement.origin.longitude)),
        header_comment: Some(labels.marking.line()),
        zone_comment: None,
        ..openflight::Model::default()
    };
    let count = coarsest_first.len();
    for (i, (level, mesh)) in coarsest_first.iter().zip(turned).enumerate() {
        let texture = format!("{stem}_{i}.rgb");
        // The image's name has room for 79 bytes; the attributes beside it hold the whole line.
        let name: String = labels.marking.line().chars().take(79).collect();
        let bytes = sgi::write(&rgb(&level.texture), &name, true).map_err(format_error)?;
        files.push(File { path: texture.clone(), bytes, media_type: "image/x-sgi" });
        let attributes = openflight::attributes::Attributes {
            width: level.texture.width(),
            height: level.texture.height(),
            alpha: false,
            clamp: true,
            comment: labels.marking.line(),
        };
        let bytes = openflight::attributes::write(&attributes).map_err(format_error)?;
        files.push(File { path: format!("{texture}.attr"), bytes, media_type: "application/x-openflight-attributes" });
        model.textures.push(texture);
        let distance = openflight::switch_distance;
        let switch_in = if i == 0 { 100_000.0 } else { distance(level.significant_size) };
        let switch_out = if i + 1 == count { 0.0 } else { distance(coarsest_first[i + 1].significant_size) };
        model.levels.push(openflight::Level {
            name: format!("{stem}_{i}"),
            switch_in,
            switch_out,
            transition: if i == 0 { 0.0 } else { (switch_in - switch_out) / 10.0 },
            significant_size: level.significant_size,
            center,
            texture: Some(i),
            mesh,
        });
    }
    let bytes = openflight::write_as(&model, geometry).map_err(format_error)?;
    files.insert(0, File { path: format!("{stem}.flt"), bytes, media_type: "application/x-openflight" });
    Ok(files)
}

/// One level as COLLADA under its KML document, the texture beside it.
pub fn kmz(level: &Level, to_metres: &ToMetres, document: &str, labels: &Labels) -> Result<File> {
    let stem = &labels.stem;
    let mut png = std::io::Cursor::new(Vec::new());
    let picture = level.texture.write_to(&mut png, image::ImageFormat::Png);
    picture.map_err(|e| Error::environment(format!("{stem}.png")).found(e.to_string()))?;
    let marking = labels.marking.line();
    let model = collada::write(&to_metres.mesh(&level.mesh), &format!("{stem}.png"), &marking, &labels.utc)
        .map_err(format_error)?;
    let files = [
        (format!("models/{stem}.dae"), model),
        (format!("models/{stem}.png"), inband::mark_png(&png.into_inner(), &labels.marking)),
    ];
    let bytes = kmz::write(document, &files, &marking).map_err(format_error)?;
    Ok(File { path: format!("{stem}.kmz"), bytes, media_type: "application/vnd.google-earth.kmz" })
}

/// Subject frame → east, north, up.
fn to_north(mesh: &orb_formats::Mesh, heading: f64) -> orb_formats::Mesh {
    let (sin, cos) = heading.to_radians().sin_cos();
    let turn = |x: f64, y: f64| (x * cos + y * sin, -x * sin + y * cos);
    let mut out = mesh.clone();
    for p in &mut out.positions {
        (p[0], p[1]) = turn(p[0], p[1]);
    }
    for n in &mut out.normals {
        let (e, m) = turn(n[0].into(), n[1].into());
        (n[0], n[1]) = (e as f32, m as f32);
    }
    out
}

/// Photo, mask and depth; the six views; the model turned; its levels.
pub fn preview_png(photo: &RgbImage, r: &Reconstruction, marking: &Marking) -> Result<Vec<u8>> {
    let [what, six] = seen_rows(photo, &r.subject, &r.six);
    let finest = &r.model.levels[0];
    let draw =
        |level: &Level, camera: &Camera| mesh::raster(&level.mesh, Some(&level.texture), camera, [255, 255, 255], 2);
    const AROUND: [f32; 6] = [0.0, 60.0, 120.0, 180.0, 240.0, 300.0];
    let directions: Vec<[f32; 2]> =
        AROUND.iter().map(|a| [*a, 15.0]).chain([[0.0, 89.0], [0.0, -60.0], [30.0, 20.0]]).collect();
    let cameras = views::framed(&finest.mesh.positions, &directions, 384);
    let [turned, known, expected] = around(r, finest, &cameras[..AROUND.len()], &AROUND);
    let mut last = vec![tile(draw(finest, &cameras[6]), "from above"), tile(draw(finest, &cameras[7]), "from below")];
    for level in &r.model.levels {
        let caption = format!("{} vertices", level.mesh.positions.len());
        last.push(tile(draw(level, &cameras[8]), &caption));
    }
    let expected = r.expected_error.is_some().then_some(expected);
    let rows: Vec<Vec<Tile>> = [what, six, turned, known].into_iter().chain(expected).chain([last]).collect();
    marked_png(&preview::sheet(&rows, &marking.banner()).into(), marking)
}

/// The model from around: as it is, in the colours of where its texture comes from, and in those of how far the network expected
/// its colours to be off (where it said so; else as it is). Captions say what the colours mean.
fn around(r: &Reconstruction, finest: &Level, cameras: &[Camera], azimuths: &[f32]) -> [Vec<Tile>; 3] {
    let known = provenance::shown(&r.model.provenance, &finest.texture);
    let sources = [
        "green: photo",
        if symmetry::assumed(&r.symmetry) { "blue: assumed" } else { "blue: mirrored" },
        "orange: invented",
    ];
    let errors = r.expected_error.as_ref().map(|e| preview::error_colours(&e.texture));
    let most = preview::LARGEST_ERROR;
    let mean = r.expected_error.as_ref().map_or(0.0, |e| 255.0 * e.mean);
    let legend = ["expected error", "dark: 0 of 255", &format!("yellow: {most}"), &format!("mean: {mean:.0}")];
    let textures = [&finest.texture, &known, errors.as_ref().unwrap_or(&finest.texture)];
    let mut rows = [const { Vec::new() }; 3];
    for (i, (camera, azimuth)) in cameras.iter().zip(azimuths).enumerate() {
        let pictures = mesh::rasters(&finest.mesh, textures, camera, [255, 255, 255], 2);
        let angle = format!("model {azimuth}");
        let captions =
            [angle.as_str(), sources.get(i).copied().unwrap_or_default(), legend.get(i).copied().unwrap_or_default()];
        for ((row, picture), caption) in rows.iter_mut().zip(pictures).zip(captions) {
            row.push(tile(picture, caption));
        }
    }
    rows
}

/// The file beside a model that says where its texture comes from.
pub const PROVENANCE: &str = "texture_provenance.png";

/// Where the texture of the finest level comes from: [`provenance::shares`] by its texture coordinates, which every format
/// shares.
pub fn provenance_png(model: &Model, marking: &Marking) -> Result<Vec<u8>> {
    marked_png(&model.provenance.clone().into(), marking)
}

/// The file beside a model that says how far its network expected colours to be off.
pub const EXPECTED_ERROR: &str = "texture_expected_error.png";

/// Expected errors by the finest level's texture coordinates, sRGB 0..1 in eight bits.
pub fn expected_error_png(expected: &ExpectedError, marking: &Marking) -> Result<Vec<u8>> {
    marked_png(&expected.texture.clone().into(), marking)
}

/// The same of a photo that no mesh was made of: the Gaussians turned.
pub fn fitted_png(photo: &RgbImage, f: &Fitted, marking: &Marking) -> Result<Vec<u8>> {
    let [what, six] = seen_rows(photo, &f.subject, &f.six);
    let turned = (0..6).map(|i| {
        let azimuth = 60.0 * i as f32;
        let frame = splat::render(&f.gaussians, &views::orbit(azimuth, 15.0, views::DISTANCE, 384), [1.0; 3]);
        let image = preview::from_floats(frame.width, frame.height, &frame.color);
        tile(image, &format!("Gaussians {azimuth}"))
    });
    marked_png(&preview::sheet(&[what, six, turned.collect()], &marking.banner()).into(), marking)
}

fn tile(image: RgbImage, caption: &str) -> Tile {
    Tile { image, caption: caption.into() }
}

/// What went in and what the networks saw; the six views.
fn seen_rows(photo: &RgbImage, subject: &Subject, six: &[(Camera, Frame)]) -> [Vec<Tile>; 2] {
    let small = image::imageops::thumbnail(photo, fitted(photo, 0), fitted(photo, 1));
    let sure = subject.expected_iou.map(|iou| format!(", expected IoU {iou:.2}"));
    let mask = format!("subject mask{}", sure.unwrap_or_default());
    let what = vec![
        tile(small.clone(), "photo"),
        tile(preview::masked(&small, &subject.mask), &mask),
        tile(preview::depth_colours(&subject.depth, &subject.mask), "relative depth"),
    ];
    let six = six.iter().zip(views::SIX_AZIMUTHS).map(|((camera, f), azimuth)| {
        let image = preview::from_floats(camera.width as usize, camera.height as usize, &f.color);
        tile(image, &format!("view {azimuth}"))
    });
    [what, six.collect()]
}

/// Width (0) or height (1) of the photo brought down to the preview's size.
fn fitted(photo: &RgbImage, axis: usize) -> u32 {
    let size = [photo.width(), photo.height()];
    let scale = (512.0 / f64::from(size[0].max(size[1]))).min(1.0);
    ((f64::from(size[axis]) * scale).round() as u32).max(1)
}

/// `Mon Jan  1 00:00:00 2024`, the form of the OpenFlight header, from an ISO 8601 time.
fn openflight_date(utc: &str) -> String {
    const MONTHS: [&str; 12] = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"];
    const DAYS: [&str; 7] = ["Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"];
    let (year, month, day) = dbf_date(utc);
    let clock = utc.get(11..19).unwrap_or("00:00:00");
    // Sakamoto's method.
    const T: [u32; 12] = [0, 3, 2, 5, 0, 3, 5, 1, 4, 6, 2, 4];
    let m = usize::from(month.clamp(1, 12)) - 1;
    let y = u32::from(year) - u32::from(m < 2);
    let weekday = (y + y / 4 - y / 100 + y / 400 + T[m] + u32::from(day)) % 7;
    format!("{} {} {day:>2} {clock} {year}", DAYS[weekday as usize], MONTHS[m])
}

fn dbf_date(utc: &str) -> (u16, u8, u8) {
    let part = |range: std::ops::Range<usize>| utc.get(range).and_then(|t| t.parse::<u16>().ok()).unwrap_or(1);
    (part(0..4), part(5..7) as u8, part(8..10) as u8)
}

/// What the writers put beside the geometry.
fn label(placement: &Placement, labels: &Labels) -> Label {
    let o = &placement.origin;
    let place = Place { latitude: o.latitude, longitude: o.longitude, height: o.height, heading: placement.heading };
    Label { marking: labels.marking.line(), place: Some(place) }
}

fn rgb(image: &RgbImage) -> Image {
    Image { width: image.width(), height: image.height(), channels: 3, pixels: image.as_raw().clone() }
}

/// A writer refused: what it says is what the user can act on.
pub fn format_error(e: orb_formats::Error) -> Error {
    Error::new(Kind::Usage, "export").found(e.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_as_openflight_writes_them() {
        assert_eq!(openflight_date("2024-01-01T00:00:00.000Z"), "Mon Jan  1 00:00:00 2024");
        assert_eq!(openflight_date("2026-11-21T04:05:06.789Z"), "Sat Nov 21 04:05:06 2026");
        assert_eq!(dbf_date("2026-11-21T04:05:06.789Z"), (2026, 11, 21));
    }

    #[test]
    fn north_is_y_after_turning() {
        let mesh = orb_formats::Mesh {
            positions: vec![[0.0, 1.0, 0.0]],
            normals: vec![[0.0, 1.0, 0.0]],
            uvs: vec![[0.0; 2]],
            triangles: vec![],
        };
        let east = to_north(&mesh, 90.0);
        assert!((east.positions[0][0] - 1.0).abs() < 1e-12 && east.positions[0][1].abs() < 1e-12);
        assert!((east.normals[0][0] - 1.0).abs() < 1e-6);
    }
}
