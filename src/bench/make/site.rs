//! A whole place from all around, as scenes are trained on: things on ground, houses behind, clouds above; if asked, photos
//! of drifting exposure and a van that is elsewhere in each. With what COLMAP would have found: poses and points.
//!
//! Or one thing alone with clear surroundings: `super::nerf`.

use glam::{DMat3, DQuat, Mat3, Vec2, Vec3};
use image::{DynamicImage, GrayImage, Luma, Rgb, RgbImage};
use orb_formats::File;
use rayon::prelude::*;
use serde_json::json;

use super::parts::smooth_noise;
use super::photos::{GRAIN, HEADING, HOME, tags, written_world};
use super::{Random, entry, rgba, things};
use crate::audit::{Marking, inband};
use crate::geo::Enu;
use crate::mesh::color::{to_linear, to_srgb};
use crate::mesh::{self, Mesh};
use crate::splat::Camera;
use crate::{Error, Result, views};

/// What is made.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    pub seed: u64,
    pub count: usize,
    /// Pixels across a photo; three quarters of that down, but square in NeRF's layout.
    pub width: u32,
    /// Standard deviation of each coordinate of the cameras' places in the photos, metres; up twice that. Independent.
    pub gps_noise: f64,
    /// Standard deviation of each photo's brightness (natural logarithm, linear light); of its tint a fifth of that.
    pub exposure_drift: f32,
    /// A van that stands elsewhere in each photo, and masks of it.
    pub moving: bool,
    /// NeRF's synthetic layout: one thing, clear surroundings, a test set of a quarter as many besides.
    pub nerf: bool,
}

/// Sparse points of a place.
const POINTS: usize = 12_000;
/// Samples a pixel along each side of ground and sky.
const FINER: u32 = 2;

/// Ground, houses and sky of one place.
struct Place {
    things: Vec<(Mesh, RgbImage)>,
    /// All of them as one.
    mesh: Mesh,
    texture: RgbImage,
    /// Middle and half sizes of what stands on the ground.
    feet: Vec<(Vec2, Vec2)>,
    /// Of what is in the middle, metres.
    radius: f32,
    seed: u32,
}

/// Set number `index`: its name, and its files relative to the folder of all.
///
/// # Errors
/// None in practice: what is made fits its formats.
pub fn set(index: usize, options: &Options, marking: &Marking) -> Result<(String, Vec<File>)> {
    let mut random = begun(index, options.seed);
    match options.nerf {
        true => super::nerf::thing(index, options, &mut random, marking),
        false => place(index, options, &mut random, marking),
    }
}

fn begun(index: usize, seed: u64) -> Random {
    Random::new(seed.wrapping_mul(1_000_003).wrapping_add(index as u64) ^ 0x7369_7465)
}

/// The boxes around everything that stands on the ground of set `index`, metres: low and high corners.
#[cfg(test)]
pub fn boxes(index: usize, seed: u64) -> Vec<(Vec3, Vec3)> {
    build(index, &mut begun(index, seed)).things.iter().map(|(m, _)| m.bounds()).collect()
}

/// Set `index` from straight above, without haze: a square of `half` metres to each side of its middle, +Y up.
#[cfg(test)]
pub fn from_above(index: usize, seed: u64, half: f32, size: u32) -> RgbImage {
    let place = build(index, &mut begun(index, seed));
    let high = 1000.0 * half;
    let camera = Camera::look_at(Vec3::Z * high, Vec3::ZERO, 2.0 * (half / high).atan(), size);
    let things = rgba(&place.mesh, &place.texture, &camera);
    RgbImage::from_fn(size, size, |x, y| {
        let at = |v: u32| 2.0 * half * ((v as f32 + 0.5) / size as f32) - half;
        let below = ground(&place, Vec2::new(at(x), -at(y)), 2.0 * place.radius);
        let [.., a] = things.get_pixel(x, y).0.map(|v| f32::from(v) / 255.0);
        let over = things.get_pixel(x, y).0;
        Rgb([0, 1, 2].map(|k| (f32::from(over[k]) * a + 255.0 * below[k].clamp(0.0, 1.0) * (1.0 - a) + 0.5) as u8))
    })
}

fn place(index: usize, options: &Options, random: &mut Random, marking: &Marking) -> Result<(String, Vec<File>)> {
    let name = format!("{index:02}_site");
    let place = build(index, random);
    let to_world = written_world();
    let mut files = Vec::new();
    let mut put = |path: String, bytes: Vec<u8>, media_type| {
        files.push(File { path: format!("{name}/{path}"), bytes, media_type })
    };
    let fov = 62f32.to_radians();
    let height = options.width * 3 / 4;
    let middle = Vec3::new(0.0, 0.0, 0.25 * place.radius);
    struct Shot {
        camera: Camera,
        gain: [f32; 3],
        van: Option<(Mesh, RgbImage)>,
        noise: [f64; 3],
    }
    let shots: Vec<Shot> = (0..options.count)
        .map(|k| {
            let azimuth = 360.0 * k as f32 / options.count as f32 + 3.0 * random.normal();
            // Five heights: every eighth photo has another.
            let elevation = [7.0, 24.0, 13.0, 34.0, 18.0][k % 5] + 1.5 * random.normal();
            let distance = place.radius * (2.1 + 0.15 * random.normal()).clamp(1.7, 2.6);
            let aim = middle + 0.15 * place.radius * Vec3::new(random.normal(), random.normal(), 0.3 * random.normal());
            let square = Camera::look_at(middle + views::eye(azimuth, elevation, distance), aim, fov, options.width);
            let brightness = options.exposure_drift * random.normal();
            let gain = [0; 3].map(|_| (brightness + 0.2 * options.exposure_drift * random.normal()).exp());
            let van = options.moving.then(|| {
                let (mut mesh, texture) =
                    things::build(&things::KINDS[1], &mut Random::new(options.seed.wrapping_add(77)));
                let angle = 0.7 + 2.4 * k as f32;
                let at = Vec3::new(angle.cos(), angle.sin(), 0.0) * place.radius * 0.8;
                turned(&mut mesh, angle, at);
                (mesh, texture)
            });
            let noise = [0; 3].map(|_| f64::from(random.normal()));
            Shot { camera: Camera { height, cy: height as f32 / 2.0, ..square }, gain, van, noise }
        })
        .collect();
    let drawn: Vec<Drawn> = shots.par_iter().map(|s| draw(&place, &s.camera, s.van.as_ref(), options.count)).collect();
    let (mut listed, mut lines, mut points) = (Vec::new(), Vec::new(), Vec::new());
    for (k, (shot, drawn)) in shots.iter().zip(&drawn).enumerate() {
        let camera = &shot.camera;
        let at = camera.position().as_dvec3();
        let (sin, cos) = HEADING.to_radians().sin_cos();
        let n = options.gps_noise;
        let seen = HOME.offset(Enu {
            east: at.x * cos + at.y * sin + n * shot.noise[0],
            north: -at.x * sin + at.y * cos + n * shot.noise[1],
            up: at.z + 2.0 * n * shot.noise[2],
        });
        let photo = exposed(&drawn.photo, shot.gain);
        let bytes = super::photos::png(&photo, tags(seen, n, camera.fx, options.width)?)?;
        put(format!("images/{k:03}.png"), inband::mark_png(&bytes, marking), "image/png");
        if let Some(mask) = &drawn.mask {
            put(format!("masks/{k:03}.png"), plain_png(mask.clone().into(), marking)?, "image/png");
        }
        if options.exposure_drift > 0.0 || options.moving {
            put(format!("truth/images/{k:03}.png"), plain_png(drawn.clean.clone().into(), marking)?, "image/png");
        }
        listed.push(json!({"exposure_gain": shot.gain, "camera": entry(&format!("{k:03}"), "train", &format!("images/{k:03}.png"), camera)}));
        let own = DMat3::from_cols_array(&camera.rotation.to_cols_array().map(f64::from));
        let rotation = DQuat::from_mat3(&own) * to_world.rotation.inverse();
        let moved = -(rotation * to_world.apply(at));
        let (q, t) = (rotation, moved);
        lines.push(format!("{} {} {} {} {} {} {} {} 1 {k:03}.png\n\n", k + 1, q.w, q.x, q.y, q.z, t.x, t.y, t.z));
        for (p, color) in &drawn.points {
            let p = to_world.apply(p.as_dvec3());
            let [r, g, b] = color;
            points.push(format!("{} {} {} {} {r} {g} {b} 0.5\n", points.len() + 1, p.x, p.y, p.z));
        }
        if k == 0 {
            let c = camera;
            let text = format!("1 PINHOLE {} {} {} {} {} {}\n", c.width, c.height, c.fx, c.fy, c.cx, c.cy);
            put("sparse/0/cameras.txt".into(), text.into_bytes(), "text/plain");
        }
    }
    put("sparse/0/images.txt".into(), lines.concat().into_bytes(), "text/plain");
    put("sparse/0/points3D.txt".into(), points.concat().into_bytes(), "text/plain");
    let facts = json!({
        "name": name, "world": "metres, Z up, on Z = 0", "radius_m": place.radius,
        "latitude": HOME.latitude, "longitude": HOME.longitude, "ellipsoidal_height_m": HOME.height, "heading_deg": HEADING,
        "gps_noise_m": options.gps_noise, "metres_per_world_unit": to_world.scale.recip(), "views": listed,
    });
    put("truth/cameras.json".into(), text_of(&facts)?, "application/json");
    Ok((name, files))
}

pub(super) fn text_of(facts: &serde_json::Value) -> Result<Vec<u8>> {
    let mut text = serde_json::to_vec_pretty(facts).map_err(|e| Error::environment("JSON").found(e.to_string()))?;
    text.push(b'\n');
    Ok(text)
}

pub(super) fn plain_png(image: DynamicImage, marking: &Marking) -> Result<Vec<u8>> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    image.write_to(&mut bytes, image::ImageFormat::Png).map_err(|e| Error::environment("PNG").found(e.to_string()))?;
    Ok(inband::mark_png(&bytes.into_inner(), marking))
}

/// Turned about the vertical, then moved.
fn turned(mesh: &mut Mesh, angle: f32, by: Vec3) {
    let turn = Mat3::from_rotation_z(angle);
    mesh.positions.iter_mut().for_each(|p| *p = turn * *p + by);
    mesh.normals.iter_mut().for_each(|n| *n = turn * *n);
}

/// One mesh of many, their textures, all of one size, above each other.
fn joined(all: &[(Mesh, RgbImage)]) -> (Mesh, RgbImage) {
    let n = all.len() as u32;
    let (w, h) = all.first().map_or((1, 1), |a| a.1.dimensions());
    let mut texture = RgbImage::new(w, h * n.max(1));
    let mut mesh = Mesh::default();
    for (k, (m, t)) in all.iter().enumerate() {
        image::imageops::replace(&mut texture, t, 0, (k as u32 * h).into());
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(&m.positions);
        mesh.normals.extend(&m.normals);
        // v counts from below.
        mesh.uvs.extend(m.uvs.iter().map(|uv| Vec2::new(uv.x, ((n - 1 - k as u32) as f32 + uv.y) / n as f32)));
        mesh.triangles.extend(m.triangles.iter().map(|t| t.map(|i| i + first)));
    }
    (mesh, texture)
}

fn build(index: usize, random: &mut Random) -> Place {
    let kind = |i: usize| &things::KINDS[i % things::KINDS.len()];
    let first = things::build(kind(index + 2), random);
    let size = |m: &Mesh| (m.bounds().1 - m.bounds().0).truncate().max_element();
    let near = size(&first.0);
    let mut all = vec![first];
    // Five things around it, then a ring of houses.
    for k in 0..5 {
        let (mut m, t) = things::build(kind(index + 3 + k), random);
        let angle = 1.1 + k as f32 * std::f32::consts::TAU / 5.0 + 0.1 * random.normal();
        let far = 0.75 * near + 0.75 * size(&m) + 1.0 + random.uniform();
        turned(&mut m, angle, Vec3::new(angle.cos(), angle.sin(), 0.0) * far);
        all.push((m, t));
    }
    let radius = all.iter().flat_map(|(m, _)| &m.positions).map(|p| p.truncate().length()).fold(0.0, f32::max);
    for k in 0..12 {
        let which = [2, 8, 5][k % 3];
        let (mut m, t) = things::build(kind(which), random);
        let angle = k as f32 * std::f32::consts::TAU / 12.0 + 0.08 * random.normal();
        let far = radius * (4.0 + 1.2 * random.uniform()) + size(&m);
        turned(&mut m, angle, Vec3::new(angle.cos(), angle.sin(), 0.0) * far);
        all.push((m, t));
    }
    let feet = all
        .iter()
        .map(|(m, _)| {
            let (low, high) = m.bounds();
            ((low + high).truncate() / 2.0, (high - low).truncate() / 2.0)
        })
        .collect();
    let (mesh, texture) = joined(&all);
    Place { things: all, mesh, texture, feet, radius, seed: (random.uniform() * 1e6) as u32 }
}

/// The ground's colour at a place, metres; `far` from the eye.
fn ground(place: &Place, p: Vec2, far: f32) -> [f32; 3] {
    let seed = place.seed;
    let near = (6.0 * place.radius / far.max(1e-3)).min(1.0);
    let t = 0.55 * smooth_noise(p * 0.31, seed)
        + 0.3 * smooth_noise(p * 1.7, seed + 1)
        + 0.15 * smooth_noise(p * 6.1, seed + 2);
    let grain = 1.0 + 0.5 * GRAIN * near * (smooth_noise(p * 4.3, seed + 3) + smooth_noise(p * 11.0, seed + 4) - 1.0);
    let (grass, earth) = ([0.33, 0.42, 0.22], [0.56, 0.49, 0.37]);
    let share = ((t - 0.42) * 6.0).clamp(0.0, 1.0);
    let mut c: [f32; 3] = std::array::from_fn(|k| grass[k] * (1.0 - share) + earth[k] * share);
    // A road with a dashed line goes by.
    let across = (p.y + 0.9 * place.radius + 0.05 * p.x).abs();
    let road = (1.0 - (across - 3.2).max(0.0) / 0.3).clamp(0.0, 1.0);
    let is_line = across < 0.12 && (p.x / 6.0).rem_euclid(1.0) < 0.5;
    let asphalt = if is_line { [0.82, 0.82, 0.78] } else { [0.31, 0.31, 0.32] };
    c = std::array::from_fn(|k| c[k] * (1.0 - road) + asphalt[k] * road);
    let mut light = 1.0f32;
    for (middle, half) in &place.feet {
        let off = ((p - *middle).abs() - *half).max(Vec2::ZERO).length() / (0.25 * half.max_element());
        light *= 1.0 - 0.5 * (-off * off).exp();
    }
    c.map(|v| v * light * grain)
}

/// The sky's colour along a direction of length one.
fn sky(place: &Place, d: Vec3) -> [f32; 3] {
    let t = (d.z * 2.2).clamp(0.0, 1.0);
    let at = d.truncate() / (d.z + 0.25) * 1.6;
    let n = 0.6 * smooth_noise(at, place.seed + 9) + 0.4 * smooth_noise(at * 2.7, place.seed + 10);
    let cloud = ((n - 0.52) * 3.0).clamp(0.0, 0.8) * (d.z * 6.0).clamp(0.0, 1.0);
    [0.80 - 0.42 * t, 0.86 - 0.28 * t, 0.92 - 0.08 * t].map(|v: f32| v * (1.0 - cloud) + 0.95 * cloud)
}

/// One photo before the camera makes its own of it.
struct Drawn {
    photo: RgbImage,
    /// Without what moves.
    clean: RgbImage,
    mask: Option<GrayImage>,
    /// Seen in it, with their colours.
    points: Vec<(Vec3, [u8; 3])>,
}

fn draw(place: &Place, camera: &Camera, van: Option<&(Mesh, RgbImage)>, photos: usize) -> Drawn {
    let behind = behind(place, camera);
    let over = |mesh: &Mesh, texture: &RgbImage| {
        let cut = rgba(mesh, texture, camera);
        RgbImage::from_fn(camera.width, camera.height, |x, y| {
            let (p, b) = (cut.get_pixel(x, y).0, behind.get_pixel(x, y).0);
            let a = f32::from(p[3]) / 255.0;
            Rgb(std::array::from_fn(|k| (f32::from(p[k]) * a + f32::from(b[k]) * (1.0 - a) + 0.5) as u8))
        })
    };
    let clean = over(&place.mesh, &place.texture);
    let (photo, mask) = match van {
        None => (clean.clone(), None),
        Some(van) => {
            let mut all = place.things.clone();
            all.push(van.clone());
            let (mesh, texture) = joined(&all);
            let seen = mesh::raster::visibility(&mesh.positions, &mesh.triangles, camera);
            let first = place.mesh.triangles.len() as u32;
            let is_van = |x: i64, y: i64| {
                let (w, h) = (seen.width as i64, seen.height as i64);
                let inside = (0..w).contains(&x) && (0..h).contains(&y);
                inside && Some(seen.triangle[(y * w + x) as usize]).is_some_and(|t| t != u32::MAX && t >= first)
            };
            let reach = 1 + i64::from(camera.width) / 200;
            let mask = GrayImage::from_fn(camera.width, camera.height, |x, y| {
                let near =
                    (-reach..=reach).any(|dy| (-reach..=reach).any(|dx| is_van(i64::from(x) + dx, i64::from(y) + dy)));
                Luma([if near { 0 } else { 255 }])
            });
            (over(&mesh, &texture), Some(mask))
        }
    };
    let points = points(place, camera, &clean, POINTS / photos.max(1) + 1);
    Drawn { photo, clean, mask, points }
}

/// Ground and sky.
fn behind(place: &Place, camera: &Camera) -> RgbImage {
    let (eye, back) = (camera.position(), camera.rotation.transpose());
    let fine = camera.resized(camera.width * FINER, camera.height * FINER);
    RgbImage::from_fn(camera.width, camera.height, |x, y| {
        let mut sum = [0.0f32; 3];
        for i in 0..FINER * FINER {
            let (u, v) = (x * FINER + i % FINER, y * FINER + i / FINER);
            let ray = back * Vec3::new((u as f32 + 0.5 - fine.cx) / fine.fx, (v as f32 + 0.5 - fine.cy) / fine.fy, 1.0);
            let d = ray.normalize();
            let horizon = sky(place, Vec3::new(d.x, d.y, 0.0).normalize_or(Vec3::X));
            let c = if d.z < -1e-3 {
                let far = -eye.z / d.z;
                let g = ground(place, (eye + d * far).truncate(), far);
                // Haze: the ground's end is the sky's.
                let haze = 1.0 - (-far / (25.0 * place.radius)).exp();
                std::array::from_fn(|k| g[k] * (1.0 - haze) + horizon[k] * haze)
            } else if d.z < 0.0 {
                horizon
            } else {
                sky(place, d)
            };
            (0..3).for_each(|k| sum[k] += to_linear(c[k].clamp(0.0, 1.0)));
        }
        Rgb(sum.map(|v| (to_srgb(v / (FINER * FINER) as f32) * 255.0 + 0.5) as u8))
    })
}

/// What a camera sees at pixels spread over its picture, moved by a fifth of a pixel.
fn points(place: &Place, camera: &Camera, picture: &RgbImage, count: usize) -> Vec<(Vec3, [u8; 3])> {
    let seen = mesh::raster::visibility(&place.mesh.positions, &place.mesh.triangles, camera);
    let (eye, back) = (camera.position(), camera.rotation.transpose());
    let at = camera.position();
    let mut random = Random::new(u64::from(at.x.to_bits()) << 32 | u64::from(at.y.to_bits()));
    let mut out = Vec::new();
    for _ in 0..4 * count {
        let x = (random.uniform() * camera.width as f32) as u32;
        let y = (random.uniform() * camera.height as f32) as u32;
        let mut off = || 0.2 * random.normal();
        let ray = Vec3::new(
            (x as f32 + 0.5 + off() - camera.cx) / camera.fx,
            (y as f32 + 0.5 + off() - camera.cy) / camera.fy,
            1.0,
        );
        let i = y as usize * seen.width + x as usize;
        let world = back * ray;
        let depth = match seen.depth[i] {
            z if z > 0.0 => z,
            _ if world.z < -1e-3 => -eye.z / world.z,
            _ => continue,
        };
        let p = eye + world * depth;
        if out.len() < count && p.distance(eye) < 14.0 * place.radius {
            out.push((p, picture.get_pixel(x, y).0));
        }
    }
    out
}

/// What a camera of its own exposure makes of linear light.
fn exposed(photo: &RgbImage, gain: [f32; 3]) -> RgbImage {
    if gain == [1.0; 3] {
        return photo.clone();
    }
    let tables: [Vec<u8>; 3] = gain
        .map(|g| (0..256).map(|v| (to_srgb((to_linear(v as f32 / 255.0) * g).min(1.0)) * 255.0 + 0.5) as u8).collect());
    RgbImage::from_fn(photo.width(), photo.height(), |x, y| {
        let p = photo.get_pixel(x, y).0;
        Rgb(std::array::from_fn(|k| tables[k][p[k] as usize]))
    })
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::photos::dataset;

    pub fn options(nerf: bool) -> Options {
        Options { seed: 3, count: 6, width: 64, gps_noise: 0.5, exposure_drift: 0.2, moving: true, nerf }
    }

    pub fn written(o: &Options) -> (tempfile::TempDir, std::path::PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let (name, files) = set(0, o, &Marking::UNCLASSIFIED).unwrap();
        for f in files {
            let path = folder.path().join(&f.path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, f.bytes).unwrap();
        }
        let at = folder.path().join(name);
        (folder, at)
    }

    #[test]
    fn points_lie_where_the_photos_show_their_colour() {
        let (_keep, at) = written(&Options { exposure_drift: 0.0, moving: false, ..options(false) });
        let found = dataset::find(&at, None).unwrap().unwrap().poses;
        assert!(found.photos.len() == 6 && found.points.len() > POINTS / 2, "{}", found.points.len());
        // The first photo's points come first.
        let picture = image::open(&found.photos[0].file).unwrap().into_rgb8();
        let own = &found.points[..found.points.len() / 6];
        let close = own.iter().filter(|(p, color)| {
            let Some([x, y]) = found.photos[0].pixel(*p) else { return false };
            let (x, y) = (x.clamp(0.0, 63.0) as u32, y.clamp(0.0, 47.0) as u32);
            picture.get_pixel(x, y).0.iter().zip(color).all(|(a, b)| a.abs_diff(*b) < 40)
        });
        assert!(close.count() * 10 > own.len() * 8);
    }

    #[test]
    fn the_largest_seed_is_a_seed() {
        let largest = Options { seed: u64::MAX, count: 2, ..options(false) };
        assert!(set(0, &largest, &Marking::UNCLASSIFIED).is_ok_and(|(_, files)| !files.is_empty()));
    }

    #[test]
    fn drift_and_the_van_are_in_the_photos_and_not_in_the_truth() {
        let (_keep, at) = written(&options(false));
        let open = |path: &str| image::open(at.join(path)).unwrap();
        let (photo, clean, mask) = (
            open("images/002.png").into_rgb8(),
            open("truth/images/002.png").into_rgb8(),
            open("masks/002.png").into_luma8(),
        );
        assert_ne!(photo, clean);
        let hidden = mask.pixels().filter(|p| p.0[0] == 0).count();
        assert!(hidden > 10 && hidden < mask.len() / 3, "{hidden}");
        let facts: serde_json::Value =
            serde_json::from_slice(&std::fs::read(at.join("truth/cameras.json")).unwrap()).unwrap();
        let gain = facts["views"][2]["exposure_gain"][1].as_f64().unwrap() as f32;
        // Where nothing moves, the photo is the truth under its gain.
        let off = photo.pixels().zip(clean.pixels()).zip(mask.pixels()).filter(|(_, m)| m.0[0] == 255).filter(
            |((p, c), _)| {
                let expected = (to_linear(f32::from(c.0[1]) / 255.0) * gain).min(1.0);
                (to_linear(f32::from(p.0[1]) / 255.0) - expected).abs() > 0.02
            },
        );
        assert!(off.count() < 20);
        assert_eq!(dataset::masks(&at, None, &["002.png".into()]).unwrap().iter().flatten().count(), 1);
    }
}
