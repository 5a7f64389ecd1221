//! What there is to be made: ten kinds, each with the sizes that such things have.

use std::f32::consts::FRAC_PI_2;

use glam::{Mat3, Vec2, Vec3};
use image::RgbImage;

use super::parts::{Part, Pattern, assemble};
use crate::mesh::Mesh;
use crate::splat::train::random::Random;

pub struct Kind {
    pub name: &'static str,
    /// Least and most of the longest side, metres.
    pub sizes: [f64; 2],
    parts: fn(&mut Random) -> Vec<Part>,
}

pub const KINDS: [Kind; 10] = [
    Kind { name: "container", sizes: [5.0, 14.0], parts: container },
    Kind { name: "van", sizes: [4.0, 8.0], parts: van },
    Kind { name: "house", sizes: [5.0, 25.0], parts: house },
    Kind { name: "fuel_tank", sizes: [2.5, 15.0], parts: fuel_tank },
    Kind { name: "truck", sizes: [5.0, 14.0], parts: truck },
    Kind { name: "watch_tower", sizes: [4.0, 20.0], parts: watch_tower },
    Kind { name: "crates", sizes: [1.0, 6.0], parts: crates },
    Kind { name: "armoured_vehicle", sizes: [5.0, 11.0], parts: armoured_vehicle },
    Kind { name: "bunker", sizes: [4.0, 20.0], parts: bunker },
    Kind { name: "barrels", sizes: [0.8, 5.0], parts: barrels },
];

/// Pixels across a thing's texture.
const TEXTURE: u32 = 512;

/// One of a kind, turned at random, standing on Z = 0 with its bounding rectangle's middle at the origin.
pub fn build(kind: &Kind, random: &mut Random) -> (Mesh, RgbImage) {
    let mut parts = (kind.parts)(random);
    // Mostly a corner towards the camera.
    let side = if random.uniform() < 0.5 { -1.0 } else { 1.0 };
    let yaw = Mat3::from_rotation_z(side * between(random, 0.35, 1.15));
    for p in &mut parts {
        (p.turn, p.at) = (yaw * p.turn, yaw * p.at);
    }
    let (mut mesh, texture) = assemble(&parts, TEXTURE, (random.uniform() * 1e6) as u32);
    let (low, high) = mesh.bounds();
    let shift = Vec3::new((low.x + high.x) / 2.0, (low.y + high.y) / 2.0, low.z);
    mesh.positions.iter_mut().for_each(|p| *p -= shift);
    (mesh, texture)
}

fn between(random: &mut Random, low: f32, high: f32) -> f32 {
    low + (high - low) * random.uniform()
}

fn one_of<T: Copy>(random: &mut Random, all: &[T]) -> T {
    all[((random.uniform() * all.len() as f32) as usize).min(all.len() - 1)]
}

const PAINTS: [[f32; 3]; 8] = [
    [0.72, 0.24, 0.18],
    [0.22, 0.38, 0.62],
    [0.36, 0.52, 0.30],
    [0.80, 0.66, 0.28],
    [0.78, 0.78, 0.76],
    [0.60, 0.52, 0.40],
    [0.34, 0.55, 0.60],
    [0.82, 0.50, 0.22],
];
const OLIVE: [f32; 3] = [0.36, 0.40, 0.26];
const SAND: [f32; 3] = [0.72, 0.63, 0.46];
const EARTH: [f32; 3] = [0.40, 0.30, 0.20];
const RUBBER: [f32; 3] = [0.14, 0.14, 0.15];
const GLASS: [f32; 3] = [0.20, 0.26, 0.32];
const STEEL: [f32; 3] = [0.55, 0.56, 0.58];

fn block(x: f32, y: f32, z: f32, size: [f32; 3], color: [f32; 3], pattern: Pattern) -> Part {
    Part::cuboid(Vec3::new(x, y, z), Vec3::from_array(size), color, pattern)
}

/// Upright: the outline's own axis becomes Z.
fn upright() -> Mat3 {
    Mat3::from_rotation_x(FRAC_PI_2)
}

/// Wheels on both sides of a body that lies along Y.
fn wheels(ys: &[f32], x: f32, radius: f32, width: f32) -> Vec<Part> {
    let across = Mat3::from_rotation_z(FRAC_PI_2);
    let sides = [-x, x].into_iter().flat_map(|x| ys.iter().map(move |y| Vec3::new(x, *y, radius)));
    sides.map(|at| Part::cylinder(at, radius, width, across, RUBBER, Pattern::Plain)).collect()
}

/// An outline in (y, z) pulled along X.
fn profile(outline: &[[f32; 2]], x: f32, width: f32, color: [f32; 3], pattern: Pattern) -> Part {
    // Local x is the world's −Y, local y its X.
    let turn = Mat3::from_cols(-Vec3::Y, Vec3::X, Vec3::Z);
    let mut outline: Vec<Vec2> = outline.iter().map(|p| Vec2::new(-p[0], p[1])).collect();
    outline.reverse();
    Part { outline, length: width, turn, at: Vec3::new(x, 0.0, 0.0), color, pattern }
}

fn container(r: &mut Random) -> Vec<Part> {
    let length = one_of(r, &[6.06, 12.19]);
    let color = one_of(r, &PAINTS);
    let (w, h) = (2.44, one_of(r, &[2.59, 2.9]));
    let mut all = vec![block(0.0, 0.0, h / 2.0, [w - 0.08, length - 0.08, h - 0.06], color, Pattern::Waves(0.28))];
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        let at = [x * (w / 2.0 - 0.08), y * (length / 2.0 - 0.08)];
        all.push(block(at[0], at[1], h / 2.0, [0.16, 0.16, h], color.map(|c| c * 0.8), Pattern::Plain));
    }
    // Doors' rods.
    for k in 0..4 {
        let x = -0.75 + 0.5 * k as f32;
        all.push(Part::cylinder(
            Vec3::new(x, length / 2.0 - 0.02, h / 2.0),
            0.03,
            h * 0.9,
            upright(),
            STEEL,
            Pattern::Plain,
        ));
    }
    all
}

fn van(r: &mut Random) -> Vec<Part> {
    let (l, w, h) = (between(r, 4.6, 6.2), between(r, 1.8, 2.1), between(r, 1.9, 2.5));
    let color = one_of(r, &PAINTS);
    let f = l / 2.0;
    let body = [[-f, 0.35], [f, 0.35], [f, 0.95], [f - 0.9, h * 0.62], [f - 1.5, h], [-f, h]];
    let mut all = vec![profile(&body, 0.0, w, color, Pattern::Plain)];
    all.push(block(0.0, f - 1.9, h * 0.78, [w + 0.03, 0.7, h * 0.26], GLASS, Pattern::Plain));
    all.push(block(0.0, 0.0, h * 0.45, [w + 0.02, l * 0.8, 0.12], color.map(|c| c * 0.5), Pattern::Plain));
    all.push(block(0.0, f, 0.5, [w * 0.95, 0.16, 0.25], RUBBER, Pattern::Plain));
    all.extend(wheels(&[-f * 0.6, f * 0.62], w / 2.0 - 0.08, 0.36, 0.26));
    all
}

fn house(r: &mut Random) -> Vec<Part> {
    let (w, l, h) = (between(r, 5.0, 9.0), between(r, 6.0, 13.0), between(r, 2.8, 5.6));
    let wall = one_of(r, &[SAND, [0.70, 0.42, 0.32], [0.80, 0.77, 0.70]]);
    let pattern = one_of(r, &[Pattern::Bricks, Pattern::Plain]);
    let mut all = vec![block(0.0, 0.0, h / 2.0, [w, l, h], wall, pattern)];
    let up = between(r, 1.2, 2.6);
    let roof = [(-w / 2.0 - 0.3, h), (w / 2.0 + 0.3, h), (0.0, h + up)].map(|(x, z)| Vec2::new(x, z)).to_vec();
    let color = one_of(r, &[[0.48, 0.24, 0.18], [0.32, 0.33, 0.36]]);
    let pattern = Pattern::Bricks;
    all.push(Part { outline: roof, length: l + 0.5, turn: Mat3::IDENTITY, at: Vec3::ZERO, color, pattern });
    let count = (l / 2.2) as usize;
    for k in 0..count {
        let y = (k as f32 + 0.5) * l / count as f32 - l / 2.0;
        for x in [-w / 2.0, w / 2.0] {
            all.push(block(x, y, h * 0.55, [0.08, 0.9, 1.1], GLASS, Pattern::Plain));
        }
    }
    all.push(block(0.0, -l / 2.0, 1.05, [1.1, 0.1, 2.1], [0.30, 0.20, 0.14], Pattern::Plain));
    all.push(block(w * 0.25, l * 0.2, h + up * 0.6, [0.6, 0.6, up], [0.5, 0.3, 0.25], Pattern::Bricks));
    all
}

fn fuel_tank(r: &mut Random) -> Vec<Part> {
    let (radius, length) = (between(r, 0.8, 1.6), between(r, 3.5, 9.0));
    let color = one_of(r, &[[0.80, 0.80, 0.78], OLIVE, PAINTS[3]]);
    let z = radius + 0.5;
    let mut all = vec![Part::cylinder(
        Vec3::new(0.0, 0.0, z),
        radius,
        length,
        Mat3::IDENTITY,
        color,
        Pattern::Waves(radius * 1.57),
    )];
    for y in [-length * 0.3, length * 0.3] {
        all.push(block(0.0, y, z * 0.4, [radius * 1.7, 0.35, z * 0.8], STEEL.map(|c| c * 0.7), Pattern::Plain));
    }
    all.push(Part::cylinder(Vec3::new(0.0, 0.0, z + radius), 0.35, 0.35, upright(), STEEL, Pattern::Plain));
    all
}

fn truck(r: &mut Random) -> Vec<Part> {
    let (l, w) = (between(r, 6.5, 10.0), between(r, 2.3, 2.5));
    let color = one_of(r, &PAINTS);
    let f = l / 2.0;
    let cab = [[f - 1.9, 0.6], [f, 0.6], [f, 1.6], [f - 0.35, 2.7], [f - 1.9, 2.7]];
    let mut all = vec![profile(&cab, 0.0, w, color, Pattern::Plain)];
    all.push(block(0.0, 0.0, 0.75, [w * 0.5, l * 0.96, 0.3], RUBBER, Pattern::Plain));
    all.push(block(0.0, f - 0.75, 2.05, [w + 0.03, 0.7, 0.6], GLASS, Pattern::Plain));
    let cargo = l - 2.2;
    let (tint, pattern) =
        one_of(r, &[(OLIVE, Pattern::Plain), (PAINTS[4], Pattern::Waves(0.5)), (SAND, Pattern::Blotches(EARTH))]);
    let top = between(r, 1.8, 2.4);
    all.push(block(0.0, -f + cargo / 2.0, 0.95 + top / 2.0, [w, cargo, top], tint, pattern));
    all.extend(wheels(&[-f * 0.75, -f * 0.45, f * 0.7], w / 2.0 - 0.15, 0.48, 0.32));
    all
}

fn watch_tower(r: &mut Random) -> Vec<Part> {
    let (h, w) = (between(r, 5.0, 9.0), between(r, 2.2, 3.2));
    let wood = one_of(r, &[[0.50, 0.37, 0.24], STEEL]);
    let mut all = Vec::new();
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        all.push(block(x * w * 0.45, y * w * 0.45, h * 0.35, [0.28, 0.28, h * 0.7], wood, Pattern::Plain));
    }
    for z in [0.25, 0.5] {
        for s in [-1.0, 1.0] {
            all.push(block(0.0, s * w * 0.45, h * z, [w, 0.14, 0.2], wood.map(|c| c * 0.9), Pattern::Plain));
            all.push(block(s * w * 0.45, 0.0, h * z, [0.14, w, 0.2], wood.map(|c| c * 0.9), Pattern::Plain));
        }
    }
    all.push(block(
        0.0,
        0.0,
        h * 0.8,
        [w * 1.25, w * 1.25, h * 0.22],
        one_of(r, &[OLIVE, SAND]),
        Pattern::Windows(0.9),
    ));
    let e = w * 0.8;
    let roof = [(-e, h * 0.91), (e, h * 0.91), (0.0, h)].map(|(x, z)| Vec2::new(x, z)).to_vec();
    let color = [0.34, 0.30, 0.28];
    all.push(Part {
        outline: roof,
        length: 2.0 * e,
        turn: Mat3::IDENTITY,
        at: Vec3::ZERO,
        color,
        pattern: Pattern::Plain,
    });
    all
}

fn crates(r: &mut Random) -> Vec<Part> {
    let size = between(r, 0.8, 1.3);
    let color = [0.62, 0.46, 0.28];
    let mut all = Vec::new();
    for (k, (x, y, z)) in [(0.0, 0.0, 0.0), (1.08, 0.1, 0.0), (0.1, 1.1, 0.0), (0.5, 0.2, 1.0)].into_iter().enumerate()
    {
        let s = size * [1.0, 0.9, 0.95, 0.8][k];
        let at = Vec3::new(x, y, 0.0) * size + Vec3::Z * (s / 2.0 + z * size * 0.95);
        let turn = Mat3::from_rotation_z(between(r, -0.3, 0.3));
        let tint = color.map(|c| c * between(r, 0.75, 1.15));
        all.push(Part { turn, ..Part::cuboid(at, Vec3::splat(s), tint, Pattern::Waves(0.2)) });
        for e in [-1.0, 1.0] {
            let rim = Vec3::new(s + 0.04, s + 0.04, 0.1);
            all.push(Part {
                turn,
                ..Part::cuboid(at + Vec3::Z * e * (s / 2.0 - 0.05), rim, tint.map(|c| c * 0.7), Pattern::Plain)
            });
        }
    }
    all
}

fn armoured_vehicle(r: &mut Random) -> Vec<Part> {
    let (l, w) = (between(r, 6.0, 7.2), between(r, 2.8, 3.4));
    let (color, blotch) = one_of(r, &[(OLIVE, EARTH), (SAND, [0.55, 0.42, 0.28])]);
    let pattern = Pattern::Blotches(blotch);
    let f = l / 2.0;
    let hull = [[-f * 0.9, 0.5], [f * 0.85, 0.5], [f, 1.0], [f * 0.55, 1.6], [-f, 1.6], [-f, 0.8]];
    let mut all = vec![profile(&hull, 0.0, w * 0.72, color, pattern)];
    let track = [[-f * 0.8, 0.0], [f * 0.75, 0.0], [f * 0.95, 0.5], [f * 0.85, 0.95], [-f * 0.9, 0.95], [-f, 0.5]];
    for x in [-w * 0.42, w * 0.42] {
        all.push(profile(&track, x, w * 0.16, RUBBER, Pattern::Waves(0.2)));
    }
    all.push(Part::cylinder(Vec3::new(0.0, -0.2, 1.95), w * 0.34, 0.75, upright(), color, pattern));
    let barrel = between(r, 2.2, 3.2);
    all.push(Part::cylinder(
        Vec3::new(0.0, w * 0.3 + barrel / 2.0, 2.0),
        0.1,
        barrel,
        Mat3::IDENTITY,
        color.map(|c| c * 0.8),
        Pattern::Plain,
    ));
    all.push(Part::cylinder(Vec3::new(0.4, -0.5, 2.4), 0.3, 0.25, upright(), color.map(|c| c * 0.9), Pattern::Plain));
    all
}

fn bunker(r: &mut Random) -> Vec<Part> {
    let (l, w, h) = (between(r, 5.0, 10.0), between(r, 4.0, 7.0), between(r, 2.0, 3.0));
    let color = one_of(r, &[[0.60, 0.60, 0.56], SAND]);
    let slope = [(-w / 2.0, 0.0), (w / 2.0, 0.0), (w * 0.38, h), (-w * 0.38, h)].map(|(x, z)| Vec2::new(x, z)).to_vec();
    let pattern = Pattern::Blotches(color.map(|c| c * 0.8));
    let mut all = vec![Part { outline: slope, length: l, turn: Mat3::IDENTITY, at: Vec3::ZERO, color, pattern }];
    all.push(block(0.0, -l / 2.0, h * 0.42, [1.2, 0.12, h * 0.84], [0.25, 0.27, 0.24], Pattern::Plain));
    all.push(block(0.0, l * 0.1, h + 0.3, [w * 0.45, l * 0.4, 0.6], color.map(|c| c * 0.92), Pattern::Plain));
    all.push(block(0.0, l / 2.0, h * 0.65, [w * 0.55, 0.14, 0.3], [0.08; 3], Pattern::Plain));
    all
}

fn barrels(r: &mut Random) -> Vec<Part> {
    let mut all = Vec::new();
    for (x, y) in [(0.0, 0.0), (0.68, 0.1), (0.3, 0.66), (-0.4, 0.6)] {
        let color = one_of(r, &PAINTS);
        all.push(Part::cylinder(Vec3::new(x, y, 0.44), 0.29, 0.88, upright(), color, Pattern::Plain));
        for z in [0.03, 0.3, 0.6, 0.85] {
            let at = Vec3::new(x, y, z);
            all.push(Part::cylinder(at, 0.305, 0.06, upright(), color.map(|c| c * 0.75), Pattern::Plain));
        }
    }
    all.push(block(0.13, 0.33, 0.06, [1.7, 1.5, 0.12], [0.5, 0.38, 0.25], Pattern::Waves(0.15)));
    all.iter_mut().rev().skip(1).for_each(|p| p.at.z += 0.12);
    all
}
