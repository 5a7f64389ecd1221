//! Files of others → what the writers take: metres, Z up, the subject frame.

use glam::{Mat3, Vec3};
use orb_formats::spz::Axes;
use orb_formats::{Asset, Place, Splats, glb, ply, spz};

use super::scene::FRAME;
use super::{PlacedLevel, ToMetres, atlas, coarser};
use crate::geo::{Geodetic, HeadingSource, Placement};
use crate::mesh;
use crate::progress::Progress;
use crate::splat::{self, Camera, Gaussians};
use crate::{Error, Result};

/// What stands behind splats when their surface is looked for.
const GREY: [f32; 3] = [0.5; 3];
/// Fainter splats do not count for the size of a scene.
const OPAQUE: f32 = 0.1;

/// What a file holds.
#[derive(Clone, Debug, Default)]
pub struct Imported {
    pub gaussians: Option<Gaussians>,
    /// Finest first; none for splats alone.
    pub levels: Vec<PlacedLevel>,
    /// Where Orb put it, if Orb did.
    pub place: Option<Placement>,
    /// In the subject frame already, its origin under the subject.
    pub is_orbs: bool,
}

/// Which way the axes of splats in a PLY point; other formats say it themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplatAxes {
    /// x right, y forward, z up: Orb's own.
    ZUp,
    /// x right, y up, z back.
    YUp,
    /// x right, y down, z forward: the custom of 3DGS.
    YDown,
}

impl SplatAxes {
    fn to_z_up(self) -> Mat3 {
        match self {
            SplatAxes::ZUp => Mat3::IDENTITY,
            SplatAxes::YUp => Mat3::from_cols(Vec3::X, Vec3::Z, Vec3::NEG_Y),
            SplatAxes::YDown => Mat3::from_cols(Vec3::X, Vec3::NEG_Z, Vec3::Y),
        }
    }
}

/// Reads PLY and SPZ splats and GLB models and splats, told apart by their first bytes.
///
/// # Errors
/// Usage for other files, and for what a reader refuses.
pub fn read(name: &str, bytes: &[u8], axes: Option<SplatAxes>) -> Result<Imported> {
    let unreadable = |e: orb_formats::Error| Error::usage(name).found(e.to_string());
    match bytes {
        [b'p', b'l', b'y', ..] => {
            let (splats, comments) = ply::read(bytes).map_err(unreadable)?;
            let is_orbs = comments.iter().any(|c| c == FRAME);
            let axes = axes.unwrap_or(if is_orbs { SplatAxes::ZUp } else { SplatAxes::YDown });
            let place = place_of_comments(&comments);
            Ok(Imported { gaussians: Some(upright(splats, axes)), place, is_orbs, ..Imported::default() })
        }
        [0x1f, 0x8b, ..] | [b'N', b'G', b'S', b'P', ..] => {
            let (splats, info) = spz::read(bytes, Axes::RUB).map_err(unreadable)?;
            let gaussians = Some(upright(splats, SplatAxes::YUp));
            // Who writes a marking into the comment is Orb.
            Ok(Imported { gaussians, is_orbs: !info.comment.is_empty(), ..Imported::default() })
        }
        [b'g', b'l', b'T', b'F', ..] => {
            let mut asset = glb::read(bytes).map_err(unreadable)?;
            // Orb's frame, wherever it stands.
            let is_orbs = asset.label.place.is_some();
            let place = asset.label.place.and_then(placement);
            let splats = asset.splats.take().map(|s| upright(s, SplatAxes::YUp));
            let levels = if asset.parts.is_empty() { Vec::new() } else { vec![level(&asset)?] };
            if splats.is_none() && levels.is_empty() {
                return Err(Error::usage(name).expected("triangles or splats").found("neither"));
            }
            Ok(Imported { gaussians: splats, levels, is_orbs, place })
        }
        _ => Err(Error::usage(name)
            .expected("splats in PLY or SPZ, or a model or splats in GLB")
            .found("another kind of file")
            .advice("Pack a .gltf into a .glb first.")),
    }
}

/// A file's splats as they are.
pub fn gaussians(splats: Splats) -> Gaussians {
    Gaussians {
        positions: splats.positions.into_iter().map(Vec3::from_array).collect(),
        log_scales: splats.log_scales.into_iter().map(Vec3::from_array).collect(),
        rotations: splats.rotations,
        logit_opacities: splats.logit_opacities,
        sh: splats.sh,
    }
}

fn upright(splats: Splats, axes: SplatAxes) -> Gaussians {
    let g = gaussians(splats);
    if axes == SplatAxes::ZUp { g } else { g.transformed(axes.to_z_up(), 1.0, Vec3::ZERO) }
}

fn level(asset: &Asset) -> Result<PlacedLevel> {
    let (mesh, texture) = atlas::merge(asset)?;
    let (low, high) = mesh.bounds().ok_or_else(|| Error::usage("model").found("no vertices"))?;
    let size = (0..3).map(|i| (high[i] - low[i]).powi(2)).sum::<f64>().sqrt();
    Ok(PlacedLevel { mesh, texture, details: mesh::Details::default(), error: 0.0, significant_size: size })
}

/// `None` for numbers that are no place on the Earth: a file may say anything.
fn placement(p: Place) -> Option<Placement> {
    let on_earth = p.latitude.abs() <= 90.0 && p.longitude.abs() <= 180.0;
    let origin = Geodetic { latitude: p.latitude, longitude: p.longitude, height: p.height };
    (on_earth && p.height.is_finite() && p.heading.is_finite()).then_some(Placement {
        origin,
        heading: p.heading,
        heading_source: HeadingSource::Given,
    })
}

/// The comments of [`scene_ply`](super::scene_ply), read back.
fn place_of_comments(comments: &[String]) -> Option<Placement> {
    let numbers = |start: &str| -> Option<Vec<f64>> {
        let line = comments.iter().find_map(|c| c.strip_prefix(start))?;
        Some(line.split_whitespace().filter_map(|w| w.parse().ok()).collect())
    };
    let origin = numbers("origin WGS84 ")?;
    let heading = numbers("heading of +Y ")?;
    match (origin.as_slice(), heading.first()) {
        (&[latitude, longitude, height], Some(&heading)) => placement(Place { latitude, longitude, height, heading }),
        _ => None,
    }
}

/// A uniform scale and a shift: everything of the import with it.
impl Imported {
    pub fn scaled(mut self, factor: f64) -> Self {
        self.moved(factor, [0.0; 3]);
        self
    }

    /// The centre of the footprint's rectangle, at the lowest point, becomes the origin.
    pub fn recentred(mut self) -> Self {
        let bounds = match (self.levels.first(), &self.gaussians) {
            (Some(level), _) => level.mesh.bounds(),
            (None, Some(g)) => bounds(g),
            (None, None) => None,
        };
        if let Some((low, high)) = bounds {
            self.moved(1.0, [-(low[0] + high[0]) / 2.0, -(low[1] + high[1]) / 2.0, -low[2]]);
        }
        self
    }

    fn moved(&mut self, factor: f64, shift: [f64; 3]) {
        if let Some(g) = &self.gaussians {
            let shift = Vec3::from_array(shift.map(|x| x as f32));
            self.gaussians = Some(g.transformed(Mat3::IDENTITY, factor as f32, shift));
        }
        for level in &mut self.levels {
            for p in &mut level.mesh.positions {
                *p = std::array::from_fn(|i| p[i] * factor + shift[i]);
            }
            level.error *= factor;
            level.significant_size *= factor;
        }
    }

    /// Makes the levels that are missing: `count` of splats, at least one; at most `count` coarser ones of a model.
    ///
    /// # Errors
    /// As [`mesh::build`].
    pub fn with_levels(mut self, count: usize, progress: &dyn Progress) -> Result<Self> {
        let made = match (self.levels.pop(), &self.gaussians) {
            (Some(finest), _) => coarser::with_coarser(finest, count, progress)?,
            (None, Some(g)) => {
                surface(g, mesh::Options { levels: count.max(1), ..mesh::Options::default() }, progress)?
            }
            (None, None) => Vec::new(),
        };
        // What is made is off by millimetres, and must not reach below the ground by them.
        let lowest = made.first().and_then(|l| l.mesh.bounds()).map_or(0.0, |(low, _)| low[2]);
        let ground = if self.is_orbs && self.gaussians.is_some() { 0.0 } else { lowest };
        self.levels = made;
        for p in self.levels.iter_mut().flat_map(|l| &mut l.mesh.positions) {
            p[2] = p[2].max(ground);
        }
        Ok(self)
    }
}

/// Around the splats that can be seen.
fn bounds(g: &Gaussians) -> Option<([f64; 3], [f64; 3])> {
    let seen = g.pruned(OPAQUE);
    let first = seen.positions.first()?;
    let (low, high) = seen.positions.iter().fold((*first, *first), |(l, h), p| (l.min(*p), h.max(*p)));
    Some((low.as_dvec3().to_array(), high.as_dvec3().to_array()))
}

/// Splats to textured levels, as the main job makes them: into the unit sphere, and back.
///
/// # Errors
/// Usage where no splat can be seen; as [`mesh::build`].
pub fn surface(g: &Gaussians, options: mesh::Options, progress: &dyn Progress) -> Result<Vec<PlacedLevel>> {
    let (low, high) = bounds(g).ok_or_else(|| Error::usage("the scene").found("no splat that can be seen"))?;
    let (low, high) = (Vec3::from_array(low.map(|x| x as f32)), Vec3::from_array(high.map(|x| x as f32)));
    let centre = (low + high) / 2.0;
    // Splats reach beyond their centres.
    let radius = (high - low).length() / 2.0 * 1.1;
    if !(radius.is_finite() && radius > 0.0) {
        return Err(Error::usage("the scene").expected("splats around a body").found(format!("a radius of {radius}")));
    }
    let unit = g.transformed(Mat3::IDENTITY, 1.0 / radius, -centre / radius);
    let drawers = splat::render::Drawers::with_surface(&unit, mesh::FIRM);
    drop(unit);
    let render = |camera: &Camera| mesh::View::drawn(&drawers, camera, GREY);
    let options = mesh::Options { background: GREY, ..options };
    let model = mesh::build(&render, &[], &options, progress)?;
    let back = ToMetres { base: -centre / radius, scale: radius };
    Ok(back.levels(&model.levels))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::Marking;
    use crate::export::{Labels, scene_ply, splat_glb, spz as write_spz};
    use crate::splat::render::tests::scene;

    fn labels() -> Labels {
        Labels {
            stem: "s".into(),
            marking: Marking::CUI,
            utc: "2026-11-21T04:05:06.789Z".into(),
            heading_source: "given",
            scale_source: "given",
        }
    }

    /// Largest difference of positions and harmonics.
    fn off(a: &Gaussians, b: &Gaussians) -> [f32; 2] {
        let positions = a.positions.iter().zip(&b.positions).map(|(a, b)| (*a - *b).abs().max_element());
        let colors = a.sh.iter().flatten().zip(b.sh.iter().flatten());
        let colors = colors.flat_map(|(a, b)| (0..3).map(move |c| (a[c] - b[c]).abs()));
        [positions.fold(0.0, f32::max), colors.fold(0.0, f32::max)]
    }

    #[test]
    fn every_splat_format_comes_back_upright() {
        let g = scene(40, 0.1, 5);
        let origin = Geodetic { latitude: -12.5, longitude: 130.25, height: -3.5 };
        let placement = Placement { origin, heading: 77.5, heading_source: HeadingSource::Given };
        let ply = scene_ply(&g, &placement, &labels()).unwrap();
        let back = read("s.ply", &ply.bytes, None).unwrap();
        assert!(back.is_orbs);
        assert_eq!(back.place, Some(placement));
        assert_eq!(off(&g, &back.gaussians.unwrap()), [0.0; 2]);
        let file = splat_glb(&g, &placement, &labels()).unwrap();
        let back = read("s.glb", &file.bytes, None).unwrap();
        assert_eq!(back.place, Some(placement));
        let [position, color] = off(&g, &back.gaussians.unwrap());
        assert!(position < 1e-6 && color < 1e-4, "{position} {color}");
        let file = write_spz(&g, &labels(), spz::Version::V4).unwrap();
        let back = read("s.spz", &file.bytes, None).unwrap();
        assert!(back.is_orbs && back.place.is_none());
        assert!(off(&g, &back.gaussians.unwrap())[0] < 2e-4);
    }

    #[test]
    fn a_place_that_is_none_is_not_believed() {
        let g = scene(5, 0.1, 5);
        let sound = Placement {
            origin: Geodetic { latitude: 90.0, longitude: -180.0, height: 3.0 },
            heading: 7.0,
            heading_source: HeadingSource::Given,
        };
        let at = |latitude, longitude, height, heading| Placement {
            origin: Geodetic { latitude, longitude, height },
            heading,
            ..sound
        };
        for (placement, expected) in [
            (sound, Some(sound)),
            (at(4000.0, 0.0, 0.0, 0.0), None),
            (at(0.0, 180.5, 0.0, 0.0), None),
            (at(f64::NAN, 0.0, 0.0, 0.0), None),
            (at(0.0, 0.0, f64::INFINITY, 0.0), None),
            (at(0.0, 0.0, 0.0, f64::NAN), None),
        ] {
            let ply = read("s.ply", &scene_ply(&g, &placement, &labels()).unwrap().bytes, None).unwrap();
            let glb = read("s.glb", &splat_glb(&g, &placement, &labels()).unwrap().bytes, None).unwrap();
            assert_eq!((ply.place, glb.place), (expected, expected), "{placement:?}");
            assert!(ply.is_orbs);
        }
    }

    #[test]
    fn files_of_others_are_taken_as_y_down() {
        let g = scene(5, 0.1, 6);
        let bytes = ply::write(
            &Splats {
                positions: g.positions.iter().map(|p| p.to_array()).collect(),
                log_scales: g.log_scales.iter().map(|s| s.to_array()).collect(),
                rotations: g.rotations.clone(),
                logit_opacities: g.logit_opacities.clone(),
                sh: g.sh.clone(),
            },
            &[],
        )
        .unwrap();
        let Vec3 { x, y, z } = g.positions[3];
        for (axes, expected) in [
            (None, Vec3::new(x, z, -y)),
            (Some(SplatAxes::YUp), Vec3::new(x, -z, y)),
            (Some(SplatAxes::ZUp), Vec3::new(x, y, z)),
        ] {
            let back = read("s.ply", &bytes, axes).unwrap().gaussians.unwrap();
            assert!((back.positions[3] - expected).length() < 1e-6, "{axes:?}");
        }
        let ground = read("s.ply", &bytes, None).unwrap().scaled(2.0).recentred().gaussians.unwrap();
        let (low, high) = bounds(&ground).unwrap();
        assert!(low[2].abs() < 1e-5 && (low[0] + high[0]).abs() < 1e-5 && (low[1] + high[1]).abs() < 1e-5);
        assert!(read("x.obj", b"o cube", None).unwrap_err().to_string().contains("PLY"));
    }
}
