//! The ground of a made place as terrain on the Earth, against the truth: heights, colours, place.

use glam::{DVec3, Vec2};
use orb_formats::cdb::{self, Memory, geocell::Tile, ground as tiles, names};
use orb_formats::geotiff::Grid;

use super::{BRIEF, PLAIN, SITE};
use crate::audit::Marking;
use crate::bench::make::photos::{HEADING, HOME, written_world};
use crate::bench::make::site;
use crate::export::{self, Labels, OnEarth, Patch};
use crate::geo::{Enu, Geodetic};
use crate::photos::dataset;
use crate::photos::register::{self, Fix, Registration};
use crate::pipeline::scene::bodies::{self, Body};
use crate::pipeline::scene::ground::{Filter, Surface, separated};
use crate::pipeline::scene::nadir::{Nadir, as_seen};
use crate::pipeline::scene::{Role, Scene};
use crate::splat::Camera;
use crate::splat::train::random::Random;

/// Standard deviations of the receivers, metres: across, up.
const NOISE: [f64; 2] = [0.3, 0.6];

/// From the place's own metres to the Earth.
fn place_of(own: DVec3) -> Geodetic {
    let (sin, cos) = HEADING.to_radians().sin_cos();
    HOME.offset(Enu { east: own.x * cos + own.y * sin, north: -own.x * sin + own.y * cos, up: own.z })
}

fn own_of(place: Geodetic) -> DVec3 {
    let e = HOME.local(place.to_ecef());
    let (sin, cos) = HEADING.to_radians().sin_cos();
    DVec3::new(e.east * cos - e.north * sin, e.east * sin + e.north * cos, e.up)
}

/// The cameras' places as receivers have them.
fn registered(s: &Scene) -> Registration {
    let found = dataset::find(&SITE.at, None).unwrap().unwrap();
    let (own, mut random) = (written_world().inverse(), Random::new(11));
    let mut off = |sigma: f64| sigma * f64::from(random.normal());
    let fixes: Vec<Fix> = found
        .poses
        .photos
        .iter()
        .map(|p| {
            let at = own.apply(p.centre()) + DVec3::new(off(NOISE[0]), off(NOISE[0]), off(NOISE[1]));
            let (name, place) = (p.name.clone(), place_of(at));
            Fix { name, at: p.centre(), place, horizontal: NOISE[0], vertical: NOISE[1], control: false }
        })
        .collect();
    register::register(&fixes, &s.to_unit, 1).unwrap()
}

fn measured(s: &Scene, metres: f32) -> (Surface, Vec<Camera>, Vec<Body>) {
    let near = s.gaussians.len() - s.sky;
    let (terrain, ground) = separated(&s.gaussians, near, &Filter::default()).unwrap();
    let cameras: Vec<Camera> = s.views.iter().filter(|v| v.role == Role::Trained).map(|v| v.camera).collect();
    let surface = Surface::of(&s.gaussians, &ground, &terrain, &cameras).unwrap();
    let all = bodies::of(&s.gaussians, near, &ground, &surface, 1.0 / metres);
    (Surface::of(&s.gaussians, &bodies::cleared(&ground, &all), &terrain, &cameras).unwrap(), cameras, all)
}

/// A new store with the terrain of a surface, and what became of that.
fn written(
    surface: &Surface,
    picture: &Nadir,
    earth: &OnEarth,
    around: Option<&export::Around>,
    lods: [i8; 2],
) -> (Memory, Patch) {
    let labels = Labels {
        stem: "scene".into(),
        marking: Marking::UNCLASSIFIED,
        utc: "2026-11-21T04:05:06.789Z".into(),
        heading_source: "georegistration",
        scale_source: "georegistration",
    };
    let mut store = Memory::default();
    store.write(cdb::new_store(&labels.marking.line(), "a test").0);
    let mut patch = export::add_terrain(&store, surface, picture, earth, around, lods, &labels).unwrap();
    store.write(std::mem::take(&mut patch.files));
    (store, patch)
}

/// The posts of each tile of a level of terrain, row by row from the north-west, and by what they are apart.
fn finest(store: &Memory, lod: i8) -> Vec<(Grid, Vec<Geodetic>)> {
    let of = |tile: Tile| {
        let (grid, side) = (tiles::elevation_grid(tile), tiles::side(tile.lod) as usize);
        let heights = tiles::heights(store, tile, names::ELEVATION, tiles::SELECTOR).unwrap().unwrap();
        let post = |(i, height): (usize, f32)| Geodetic {
            latitude: grid.north - (i / side) as f64 * grid.step_y,
            longitude: grid.west + (i % side) as f64 * grid.step_x,
            height: f64::from(height),
        };
        let posts = heights.into_iter().enumerate().map(post).collect();
        (grid, posts)
    };
    let terrain = store.files.keys().filter_map(|path| names::parse(path));
    terrain.filter(|f| f.dataset == names::ELEVATION && f.tile.lod == lod).map(|f| of(f.tile)).collect()
}

fn rms(v: &[f64]) -> f64 {
    (v.iter().map(|x| x * x).sum::<f64>() / v.len() as f64).sqrt()
}

#[test]
fn the_ground_becomes_terrain_at_its_place_without_what_stands_on_it() {
    let s = &*BRIEF;
    let registration = registered(s);
    let (surface, cameras, all) = measured(s, registration.to_enu.scale as f32);
    let earth = OnEarth::new(&registration);
    let lods = export::levels(&surface, &earth).unwrap();
    let pixel = (export::pixel_of(lods[1]) / registration.to_enu.scale) as f32;
    let near = s.gaussians.len() - s.sky;
    let picture = Nadir::of(&as_seen(&s.gaussians.filtered(|i| i < near), &cameras), surface.bounds(), pixel);
    let (store, patch) = written(&surface, &picture, &earth, None, lods);
    assert_eq!(cdb::check(&store).unwrap(), []);
    assert!(patch.notes[0].contains("invented") && (patch.level - HOME.height).abs() < 1.0, "{}", patch.level);

    // Every post of the finest level: where it lies in the place's own metres, and where in the surface's frame.
    let boxes = site::boxes(0, PLAIN.seed);
    let (mut open, mut below, mut beyond) = (Vec::new(), Vec::new(), 0);
    for (_, posts) in finest(&store, lods[0]) {
        for place in posts {
            let own = own_of(place);
            let share = surface.share(earth.unit(place).truncate().as_vec2());
            let on = boxes
                .iter()
                .any(|(low, high)| (0..2).all(|k| own[k] > f64::from(low[k]) && own[k] < f64::from(high[k])));
            match (share, on) {
                (1.0, false) => open.push(own.z),
                (1.0, true) => below.push(own.z),
                (0.0, _) => {
                    beyond += 1;
                    assert!((place.height - patch.level).abs() < 1e-3);
                }
                _ => {}
            }
        }
    }
    let highest = boxes.iter().take(6).map(|b| b.1.z).fold(0.0, f32::max);
    let most = below.iter().copied().fold(f64::MIN, f64::max);
    eprintln!(
        "levels {lods:?}; {} posts of open ground off by {:.3} m (rms), {} below things by {:.3} m, {most:.2} m at most; \
         the highest thing is {highest:.1} m",
        open.len(),
        rms(&open),
        below.len(),
        rms(&below),
    );
    assert!(open.len() > 300 && below.len() > 20 && beyond > 1000, "{} {} {beyond}", open.len(), below.len());
    assert!(rms(&open) < 0.6 && rms(&below) < 0.8, "{} {}", rms(&open), rms(&below));
    assert!(most < 1.5 && highest > 2.0, "{most} {highest}");

    // What stands there is found, each thing once and nothing else; of the six in the middle at least four, from photos so small.
    let mut taken = std::collections::BTreeSet::new();
    for body in &all {
        let middle = own_of(earth.place(body.middle.as_dvec2().extend(surface.height(body.middle).into())));
        let near =
            |b: &(glam::Vec3, glam::Vec3)| ((b.0 + b.1) / 2.0).truncate().distance(middle.truncate().as_vec2()) < 1.5;
        let which = boxes.iter().position(near).unwrap_or_else(|| panic!("nothing stands at {middle}"));
        assert!(taken.insert(which), "{which} twice");
        let height = f64::from(body.height) * registration.to_enu.scale;
        let truth = f64::from(boxes[which].1.z);
        eprintln!("thing {which}: {height:.2} m high, {truth:.2} in truth");
        assert!((height / truth - 1.0).abs() < 0.25, "{height} {truth}");
    }
    assert!(taken.len() >= 4 && taken.iter().all(|w| *w < 6), "{taken:?}");

    // Colours where they belong: the picture from above matches best where it is, to half a metre.
    let (half, size) = (40.0f32, 800u32);
    let truth = site::from_above(0, PLAIN.seed, half, size);
    let of_truth = |own: DVec3| {
        let at = |v: f64| ((v + f64::from(half)) / f64::from(2.0 * half) * f64::from(size)) as u32;
        let (x, y) = (at(own.x), at(-own.y));
        (x < size && y < size).then(|| truth.get_pixel(x, y).0)
    };
    let apart = |east: f64, north: f64| {
        let (mut sum, mut count) = (0.0, 0);
        for k in 0..100 * 100 {
            let own = DVec3::new(f64::from(k % 100) * 0.5 - 25.0, f64::from(k / 100) * 0.5 - 25.0, 0.0);
            let at = earth.unit(place_of(own)).truncate().as_vec2();
            if let (1.0, Some(b)) = (surface.share(at), of_truth(own + DVec3::new(east, north, 0.0))) {
                let a = picture.color(at);
                sum += (0..3).map(|c| (f64::from(a[c]) - f64::from(b[c])).powi(2)).sum::<f64>() / 3.0;
                count += 1;
            }
        }
        (sum / f64::from(count)).sqrt()
    };
    let mut best = (f64::MAX, [0.0; 2]);
    for k in 0..13 * 13 {
        let by = [f64::from(k % 13) * 0.25 - 1.5, f64::from(k / 13) * 0.25 - 1.5];
        let off = apart(by[0], by[1]);
        if off < best.0 {
            best = (off, by);
        }
    }
    let here = apart(0.0, 0.0);
    eprintln!("colours off by {here:.1} of 255; by {:.1} at best, moved by {:?} m", best.0, best.1);
    assert!(best.1[0].hypot(best.1[1]) <= 0.51, "{best:?}");
    assert!(here < 26.0, "{here}");
}

/// Metres east and north of the place.
fn from_home(latitude: f64, longitude: f64) -> [f64; 2] {
    let e = HOME.local(Geodetic { latitude, longitude, height: HOME.height }.to_ecef());
    [e.east, e.north]
}

/// Terrain that lies three metres below the scene and has hills of its own.
fn wavy(latitude: f64, longitude: f64) -> f64 {
    let [east, north] = from_home(latitude, longitude);
    HOME.height - 3.0 + 4.0 * (east / 25.0).sin() + 3.0 * (north / 30.0).cos()
}

/// Terrain that ends in the west: well outside of the place, and in the middle of it, with a hole elsewhere.
#[test]
fn the_ground_goes_over_into_terrain_that_is_known_and_out_of_it_without_a_step() {
    let s = &*BRIEF;
    let registration = registered(s);
    let metres = registration.to_enu.scale;
    let (given, ..) = measured(s, metres as f32);
    let earth = OnEarth::new(&registration);
    let lods = [export::levels(&given, &earth).unwrap()[0], 0];
    let picture = Nadir::of(&s.gaussians.filtered(|_| false), given.bounds(), 0.05);
    let band = f64::from(given.band) * metres;
    let steepest = |all: &[(Grid, Vec<Geodetic>)]| {
        let of = |(grid, posts): &(Grid, Vec<Geodetic>)| {
            let side = (posts.len() as f64).sqrt() as usize;
            let rows = posts.chunks(side).flat_map(|row| row.windows(2));
            rows.map(|w| (w[1].height - w[0].height).abs()).fold(0.0, f64::max) / (grid.step_x * 74_300.0)
        };
        all.iter().map(of).fold(0.0, f64::max)
    };
    for (west, hole) in [(-60.0, 0.0), (-5.0, 4.0)] {
        let is_hole = |[east, north]: [f64; 2]| (east - 16.0).hypot(north + 12.0) < hole;
        let depth = |latitude: f64, longitude: f64| from_home(latitude, longitude)[0] - west;
        let height = |latitude: f64, longitude: f64| {
            let known = depth(latitude, longitude) > 0.0 && !is_hole(from_home(latitude, longitude));
            known.then(|| wavy(latitude, longitude))
        };
        let around = export::Around::new(&given, &earth, &height, &depth);
        assert_eq!(around.ends, west > -50.0);
        let mut surface = given.clone();
        let against = export::fill_from(&mut surface, &earth, &around).unwrap();
        let [median, low, high] =
            [against.median, against.quartiles[0], against.quartiles[1]].map(|v| f64::from(v) * metres);
        // The place is level: the hills' own heights are what they differ by, besides the three metres.
        assert!((-4.0..10.0).contains(&median) && low < median && median < high, "{median} {low} {high}");
        // What was seen stays as it was; of the holes some do not.
        let grid = |k: usize| Vec2::new((k % 200) as f32, (k / 200) as f32) / 100.0 - 1.0;
        let inside = || (0..200 * 200).map(grid).filter(|p| surface.holds(*p));
        let moved = inside().filter(|p| surface.height(*p) != given.height(*p)).count();
        assert!(moved > 0 && moved < inside().count() / 2, "{moved} of {}", inside().count());

        let (store, patch) = written(&surface, &picture, &earth, Some(&around), lods);
        assert!(patch.notes.iter().all(|n| !n.contains("invented")), "{:?}", patch.notes);
        let all = finest(&store, lods[0]);
        let (mut outside, mut beyond, mut between) = (0, 0, 0);
        for post in all.iter().flat_map(|(_, posts)| posts) {
            let Geodetic { latitude, longitude, height } = *post;
            if surface.share(earth.unit(*post).truncate().as_vec2()) > 0.0 {
                continue;
            }
            let there = wavy(latitude, longitude);
            match around.at(latitude, longitude) {
                Some((_, 1.0)) => {
                    outside += 1;
                    assert!((height - there).abs() < 1e-3, "{height} {there}");
                }
                // Over as wide a band as the ground goes over into what is around.
                Some((found, share)) => {
                    between += 1;
                    let mixed = patch.level + (there - patch.level) * share;
                    assert!(found == there && depth(latitude, longitude) < band, "{found} {there}");
                    assert!((height - mixed).abs() < 1e-3, "{height} {mixed}");
                }
                None => {
                    beyond += 1;
                    assert!((height - patch.level).abs() < 1e-3, "{height} {}", patch.level);
                }
            }
        }
        let steepest = steepest(&all);
        eprintln!("{west}: {moved} places filled; {outside} {between} {beyond} posts outside; steepest {steepest:.2}");
        assert!(outside > 10_000 && beyond > 1000 && between > 1000, "{outside} {between} {beyond}");
        // The hills rise by 0.3 at most; ten metres over a band of eight are 1.9 where it is steepest, and in a corner two bands meet.
        // A step of ten metres from one post to the next would be 17.
        assert!(steepest < 3.5, "{steepest}");
    }
}

/// The Earth's curve and the two uprights: a point of the surface is found again from its latitude and longitude.
#[test]
fn places_of_the_earth_are_found_on_the_surface() {
    let s = &*BRIEF;
    let mut far = registered(s);
    far.to_enu.scale = 2000.0;
    let earth = OnEarth::new(&far);
    for (x, y, z) in [(0.3, -0.4, 0.02), (-2.5, 1.5, -0.05), (0.0, 0.0, 0.0)] {
        let place = earth.place(DVec3::new(x, y, z));
        let back = earth.unit(place);
        assert!(back.distance(DVec3::new(x, y, z)) < 1e-11, "{back}");
        assert!((place.height - far.place(DVec3::new(x, y, z)).height).abs() < 1e-6);
    }
    let (surface, ..) = measured(s, 30.0);
    let p = surface.outline[0] * 0.7;
    let truth = earth.place(p.as_dvec2().extend(surface.height(p).into()));
    let (at, height) = earth.on(&surface, truth.latitude, truth.longitude, truth.height + 80.0);
    assert!(at.distance(p) < 2e-6 && (height - truth.height).abs() < 0.01, "{at} {p} {height}");
    assert!(Vec2::ZERO.distance(at) > 0.05);
}
