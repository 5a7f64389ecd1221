//! The ground of a scene as terrain and imagery of a CDB store.

use glam::{DVec3, Vec2};
use orb_formats::File;
use orb_formats::cdb::{self, Store};

use super::{Around, Labels, format_error};
use crate::Result;
use crate::geo::{Enu, Geodetic};
use crate::photos::register::Registration;
use crate::pipeline::scene::ground::{Against, Surface};
use crate::pipeline::scene::nadir::Nadir;

/// Most tiles of the finest level of terrain, and of imagery: about 12 MiB of memory each.
const MOST_TILES: usize = 36;
/// The imagery's default where nothing was seen, half intensity.
const GREY: u8 = 128;

/// Where the frame of a surface lies on the Earth.
pub struct OnEarth<'a> {
    pub registration: &'a Registration,
    frame: crate::geo::LocalFrame,
    back: crate::geo::similarity::Similarity,
}

impl<'a> OnEarth<'a> {
    pub fn new(registration: &'a Registration) -> Self {
        let (frame, back) = (registration.origin.frame(), registration.to_enu.inverse());
        OnEarth { registration, frame, back }
    }

    pub fn place(&self, p: DVec3) -> Geodetic {
        let at = self.registration.to_enu.apply(p);
        self.frame.to_ecef(Enu { east: at.x, north: at.y, up: at.z }).to_geodetic()
    }

    pub fn unit(&self, place: Geodetic) -> DVec3 {
        let at = self.frame.to_enu(place.to_ecef());
        self.back.apply(DVec3::new(at.east, at.north, at.up))
    }

    /// The point of the surface at a latitude and longitude, and its height above the ellipsoid: upright there and in the
    /// surface's frame are not the same, but nearly. `near`: a height to begin with.
    pub fn on(&self, surface: &Surface, latitude: f64, longitude: f64, near: f64) -> (Vec2, f64) {
        let mut height = near;
        let mut at = Vec2::ZERO;
        for _ in 0..2 {
            let p = self.unit(Geodetic { latitude, longitude, height });
            at = p.truncate().as_vec2();
            height = self.place(DVec3::new(p.x, p.y, f64::from(surface.height(at)))).height;
        }
        (at, height)
    }
}

/// What became of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Finest levels of terrain and imagery.
    pub lods: [i8; 2],
    /// Metres above the ellipsoid: of what is around it, invented where nothing is known.
    pub level: f64,
    pub files: Vec<File>,
    pub notes: Vec<String>,
}

/// The levels whose samples are as far apart as a surface's cells and the photos' pixels on it, or the finest of which the
/// patch needs no more than 36 tiles.
pub fn levels(surface: &Surface, earth: &OnEarth) -> Result<[i8; 2]> {
    let bounds = bounds(surface, earth);
    let scale = earth.registration.to_enu.scale;
    let level = |spacing: f32| {
        let mut lod = cdb::ground::level_of(f64::from(spacing) * scale);
        while lod > 0 && !cdb::ground::tiles_within(bounds, lod).is_ok_and(|t| t.len() <= MOST_TILES) {
            lod -= 1;
        }
        lod
    };
    Ok([level(surface.cell), level(surface.pixel)])
}

/// South, west, north, east of everything that a surface has a share in, degrees; east beyond 180 over the date line.
fn bounds(surface: &Surface, earth: &OnEarth) -> [f64; 4] {
    let [low, high] = surface.bounds();
    let middle = earth.registration.origin.longitude;
    let mut out = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    for (x, y) in [(low.x, low.y), (high.x, low.y), (high.x, high.y), (low.x, high.y)] {
        let g = earth.place(DVec3::new(x.into(), y.into(), surface.height(Vec2::new(x, y)).into()));
        let longitude = middle + (g.longitude - middle + 540.0).rem_euclid(360.0) - 180.0;
        out = [out[0].min(g.latitude), out[1].min(longitude), out[2].max(g.latitude), out[3].max(longitude)];
    }
    if out[1] < -180.0 {
        (out[1], out[3]) = (out[1] + 360.0, out[3] + 360.0);
    }
    out
}

/// Metres across a pixel of a level of imagery.
pub fn pixel_of(lod: i8) -> f64 {
    cdb::geocell::DEGREE / 1024.0 / 2f64.powi(lod.into())
}

/// Lets the terrain around a surface say what lies in its holes; what the two differ by, in the surface's unit.
pub fn fill_from(surface: &mut Surface, earth: &OnEarth, around: &Around) -> Option<Against> {
    let scale = earth.registration.to_enu.scale;
    surface.fill_with(|at, z| {
        let here = earth.place(at.as_dvec2().extend(z.into()));
        let (height, share) = around.at(here.latitude, here.longitude)?;
        Some((z + ((height - here.height) / scale) as f32, share as f32))
    })
}

/// The files of terrain and imagery that a store gets. Over the band around the surface what it differs by from the terrain
/// `around` at the outline's nearest place goes to nothing, so that the terrain's own shape stays; where none is known, the height
/// of that place goes over into what the store has, or `level`.
///
/// # Errors
/// What [`cdb::ground::add_patch`] refuses.
pub fn add_terrain(
    store: &dyn Store,
    surface: &Surface,
    picture: &Nadir,
    earth: &OnEarth,
    around: Option<&Around>,
    lods: [i8; 2],
    labels: &Labels,
) -> Result<Patch> {
    let edge = surface.outline.iter().copied().sum::<Vec2>() / surface.outline.len().max(1) as f32;
    let level = earth.place(edge.as_dvec2().extend(surface.height_of_edge().into())).height;
    let marking = labels.marking.line();
    let mut heights = |latitude: f64, longitude: f64| {
        let (at, height) = earth.on(surface, latitude, longitude, level);
        let share = surface.share(at);
        let off = || {
            let around = around.filter(|_| share > 0.0 && share < 1.0)?;
            let edge = surface.nearest(at);
            let edge = earth.place(edge.as_dvec2().extend(surface.height(edge).into()));
            let (here, there) = (around.at(latitude, longitude)?, around.at(edge.latitude, edge.longitude)?);
            Some((here.0 - there.0) * here.1.min(there.1))
        };
        (share > 0.0).then(|| (height + off().unwrap_or(0.0), f64::from(share)))
    };
    let mut known = |latitude: f64, longitude: f64| around.and_then(|of| of.at(latitude, longitude));
    let mut colors = |latitude: f64, longitude: f64| {
        let (at, _) = earth.on(surface, latitude, longitude, level);
        let share = surface.share(at);
        let mixed = |v: u8| (f32::from(v) * share + f32::from(GREY) * (1.0 - share)).round() as u8;
        (share > 0.0).then(|| picture.color(at).map(mixed))
    };
    let patch = cdb::ground::Patch {
        bounds: bounds(surface, earth),
        lods,
        heights: &mut heights,
        colors: &mut colors,
        level,
        terrain: if around.is_some() { Some(&mut known) } else { None },
        marking: &marking,
    };
    let added = cdb::ground::add_patch(store, patch).map_err(format_error)?;
    Ok(Patch { lods, level, files: added.files, notes: added.notes })
}
