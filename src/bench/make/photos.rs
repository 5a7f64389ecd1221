//! Several photos of a made thing, as a drone would take them: all around, on ground, with the camera's place on the Earth in
//! each, and what COLMAP would have found, in a world of its own.

use exif::{Field, In, Rational, Tag, Value, experimental::Writer};
use glam::{DMat3, DQuat, DVec3, Vec3};
use image::ImageEncoder;
use image::codecs::png::PngEncoder;
use orb_formats::File;
use serde_json::json;

use super::{Random, entry, mask, model, rgba, surroundings, things};
use crate::audit::{Marking, inband};
use crate::geo::similarity::Similarity;
use crate::geo::{Enu, Geodetic};
use crate::photo::DIAGONAL_35MM;
use crate::splat::Camera;
use crate::{Error, Result, views};

/// What is made.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    pub seed: u64,
    pub count: usize,
    /// Pixels across a photo; three quarters of that down.
    pub width: u32,
    /// Standard deviation of each coordinate of the cameras' places in the photos, metres; up twice that. Independent.
    pub gps_noise: f64,
    /// Whether the poses are written, as COLMAP's model.
    pub poses: bool,
}

/// The thing's place: its origin, and the bearing of its +Y.
pub const HOME: Geodetic = Geodetic { latitude: 48.1351, longitude: 11.5820, height: 565.0 };
pub const HEADING: f64 = 37.0;

/// Set number `index`: its name, and its files relative to the folder of all: `photos/NN.png`, `sparse/0/*.txt`, and the
/// truth in `truth/`.
///
/// # Errors
/// None in practice: what is made fits its formats.
pub fn set(index: usize, options: &Options, marking: &Marking) -> Result<(String, Vec<File>)> {
    let mut random = Random::new(options.seed.wrapping_mul(1_000_003).wrapping_add(index as u64));
    let kind = &things::KINDS[index % things::KINDS.len()];
    let name = format!("{index:02}_{}", kind.name);
    let (mesh, texture) = things::build(kind, &mut random);
    let (low, high) = mesh.bounds();
    let middle = (low + high) / 2.0;
    let radius = low.distance(high) / 2.0;
    let to_world = written_world();
    let (mut files, mut listed, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    let mut put = |path: String, bytes: Vec<u8>, media_type| {
        files.push(File { path: format!("{name}/{path}"), bytes, media_type })
    };
    let fov = 50f32.to_radians();
    // The same ground in every photo.
    let ground = Random::new(random.next());
    for k in 0..options.count {
        let azimuth = 360.0 * k as f32 / options.count as f32 + 4.0 * random.normal();
        let elevation = [14.0, 26.0, 38.0][k % 3] + 2.0 * random.normal();
        let distance = (1.0 + 0.06 * random.normal()).clamp(0.9, 1.2) * radius / (fov * 0.375).sin();
        let aim = middle + 0.08 * radius * Vec3::new(random.normal(), random.normal(), random.normal());
        let square = Camera::look_at(middle + views::eye(azimuth, elevation, distance), aim, fov, options.width);
        let height = options.width * 3 / 4;
        let camera = Camera { height, cy: height as f32 / 2.0, ..square };
        let cut = rgba(&mesh, &texture, &camera);
        let picture = surroundings::behind(&cut, &camera, &mesh, &mut ground.clone(), GRAIN);
        let noise = |r: &mut Random, s: f64| s * f64::from(r.normal());
        let at = camera.position().as_dvec3();
        let (sin, cos) = HEADING.to_radians().sin_cos();
        let n = options.gps_noise;
        let seen = HOME.offset(Enu {
            east: at.x * cos + at.y * sin + noise(&mut random, n),
            north: -at.x * sin + at.y * cos + noise(&mut random, n),
            up: at.z + noise(&mut random, 2.0 * n),
        });
        let failed = |e: String| Error::environment("PNG").found(e);
        let bytes = png(&picture, tags(seen, n, camera.fx, options.width)?)?;
        put(format!("photos/{k:02}.png"), inband::mark_png(&bytes, marking), "image/png");
        let mut bytes = std::io::Cursor::new(Vec::new());
        mask(&cut).write_to(&mut bytes, image::ImageFormat::Png).map_err(|e| failed(e.to_string()))?;
        put(format!("truth/masks/{k:02}.png"), inband::mark_png(&bytes.into_inner(), marking), "image/png");
        listed.push(entry(&format!("{k:02}"), "train", &format!("photos/{k:02}.png"), &camera));
        // World→camera in COLMAP's world: its camera sees lengths of that world.
        let own = DMat3::from_cols_array(&camera.rotation.to_cols_array().map(f64::from));
        let rotation = DQuat::from_mat3(&own) * to_world.rotation.inverse();
        let moved = -(rotation * to_world.apply(at));
        lines.push(format!(
            "{} {} {} {} {} {} {} {} 1 {k:02}.png\n\n",
            k + 1,
            rotation.w,
            rotation.x,
            rotation.y,
            rotation.z,
            moved.x,
            moved.y,
            moved.z
        ));
        if k == 0 {
            let c = &camera;
            let text = format!("1 PINHOLE {} {} {} {} {} {}\n", c.width, c.height, c.fx, c.fy, c.cx, c.cy);
            if options.poses {
                put("sparse/0/cameras.txt".into(), text.into_bytes(), "text/plain");
            }
        }
    }
    if options.poses {
        put("sparse/0/images.txt".into(), lines.concat().into_bytes(), "text/plain");
        put("sparse/0/points3D.txt".into(), Vec::new(), "text/plain");
    }
    put("truth/mesh.glb".into(), model(&name, &mesh, &texture, marking)?, "model/gltf-binary");
    let facts = json!({
        "name": name, "class": kind.name, "world": "metres, Z up, on Z = 0", "size_m": (high - low).to_array(),
        "latitude": HOME.latitude, "longitude": HOME.longitude, "ellipsoidal_height_m": HOME.height, "heading_deg": HEADING,
        "gps_noise_m": options.gps_noise, "metres_per_world_unit": to_world.scale.recip(), "views": listed,
    });
    let mut text = serde_json::to_vec_pretty(&facts).map_err(|e| Error::environment("truth").found(e.to_string()))?;
    text.push(b'\n');
    put("truth/cameras.json".into(), text, "application/json");
    Ok((name, files))
}

/// COLMAP's world: another scale, turned and moved.
pub(crate) fn written_world() -> Similarity {
    Similarity {
        scale: 0.37,
        rotation: DQuat::from_euler(glam::EulerRot::XYZ, 1.9, 0.3, -0.7),
        translation: DVec3::new(1.5, -0.4, 3.0),
    }
}

/// A photo with what its camera says of itself.
pub(super) fn png(picture: &image::RgbImage, tags: Vec<u8>) -> Result<Vec<u8>> {
    let failed = |e: String| Error::environment("PNG").found(e);
    let mut bytes = Vec::new();
    let mut encoder = PngEncoder::new(&mut bytes);
    encoder.set_exif_metadata(tags).map_err(|e| failed(e.to_string()))?;
    encoder
        .write_image(picture.as_raw(), picture.width(), picture.height(), image::ExtendedColorType::Rgb8)
        .map_err(|e| failed(e.to_string()))?;
    Ok(bytes)
}

/// EXIF: the camera's place above the ellipsoid, what it is known to, and the focal length.
pub(super) fn tags(at: Geodetic, noise: f64, focal: f32, width: u32) -> Result<Vec<u8>> {
    let rational = |v: f64, per: u32| Rational { num: (v * f64::from(per)).round() as u32, denom: per };
    let angle = |v: f64| {
        let v = v.abs();
        let minutes = v.fract() * 60.0;
        vec![rational(v.trunc(), 1), rational(minutes.trunc(), 1), rational(minutes.fract() * 60.0, 1_000_000)]
    };
    let letter = |v: f64, plus: &str, minus: &str| Value::Ascii(vec![if v < 0.0 { minus } else { plus }.into()]);
    let diagonal = f64::from(width).hypot(f64::from(width) * 0.75);
    let focal_35mm = (f64::from(focal) / diagonal * DIAGONAL_35MM).round() as u16;
    let fields = [
        (Tag::FocalLengthIn35mmFilm, Value::Short(vec![focal_35mm])),
        (Tag::GPSLatitudeRef, letter(at.latitude, "N", "S")),
        (Tag::GPSLatitude, Value::Rational(angle(at.latitude))),
        (Tag::GPSLongitudeRef, letter(at.longitude, "E", "W")),
        (Tag::GPSLongitude, Value::Rational(angle(at.longitude))),
        (Tag::GPSAltitudeRef, Value::Byte(vec![2])),
        (Tag::GPSAltitude, Value::Rational(vec![rational(at.height, 1000)])),
        (Tag::GPSHPositioningError, Value::Rational(vec![rational(noise.max(0.01), 1000)])),
    ];
    let fields: Vec<Field> =
        fields.into_iter().map(|(tag, value)| Field { tag, ifd_num: In::PRIMARY, value }).collect();
    let mut writer = Writer::new();
    fields.iter().for_each(|f| writer.push_field(f));
    let mut out = std::io::Cursor::new(Vec::new());
    writer.write(&mut out, true).map_err(|e| Error::environment("EXIF").found(e.to_string()))?;
    Ok(out.into_inner())
}

/// The ground's, that features be found on it.
pub(super) const GRAIN: f32 = 0.7;
