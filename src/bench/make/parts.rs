//! Convex outlines pulled along an axis, painted, and laid out on one texture.

use std::f32::consts::TAU;

use glam::{Mat3, Vec2, Vec3};
use image::{Rgb, RgbImage};

use crate::mesh::Mesh;

/// How a part's sides are painted.
#[derive(Clone, Copy, Debug)]
pub enum Pattern {
    Plain,
    /// Corrugated, so many metres a wave, across the strip of sides.
    Waves(f32),
    /// Rows of windows, so many metres apart.
    Windows(f32),
    Bricks,
    /// Blotches of a second colour.
    Blotches([f32; 3]),
}

/// A convex outline (metres, counter-clockwise) pulled from `−length / 2` to `length / 2` along local +Y, then turned and
/// moved; local x and z are the outline's.
#[derive(Clone, Debug)]
pub struct Part {
    pub outline: Vec<Vec2>,
    pub length: f32,
    pub turn: Mat3,
    pub at: Vec3,
    pub color: [f32; 3],
    pub pattern: Pattern,
}

impl Part {
    /// A box from its middle and sizes.
    pub fn cuboid(at: Vec3, size: Vec3, color: [f32; 3], pattern: Pattern) -> Part {
        let (x, z) = (size.x / 2.0, size.z / 2.0);
        let outline = [(-x, -z), (x, -z), (x, z), (-x, z)].map(|(x, z)| Vec2::new(x, z)).to_vec();
        Part { outline, length: size.y, turn: Mat3::IDENTITY, at, color, pattern }
    }

    /// A cylinder along local +Y turned as told.
    pub fn cylinder(at: Vec3, radius: f32, length: f32, turn: Mat3, color: [f32; 3], pattern: Pattern) -> Part {
        const SIDES: usize = 24;
        let outline = (0..SIDES)
            .map(|k| {
                radius * Vec2::from_angle(TAU * (k as f32 + 0.5) / SIDES as f32) / (TAU / (2 * SIDES) as f32).cos()
            })
            .collect();
        Part { outline, length, turn, at, color, pattern }
    }

    fn perimeter(&self) -> f32 {
        (0..self.outline.len()).map(|i| self.side(i).length()).sum()
    }

    fn side(&self, i: usize) -> Vec2 {
        self.outline[(i + 1) % self.outline.len()] - self.outline[i]
    }

    fn bounds(&self) -> (Vec2, Vec2) {
        self.outline.iter().fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)))
    }

    fn world(&self, p: Vec2, y: f32) -> Vec3 {
        self.turn * Vec3::new(p.x, y, p.y) + self.at
    }
}

/// Where the light comes from; the texture holds what it leaves.
const SUN: Vec3 = Vec3::new(-0.45, -0.55, 0.70);

fn shade(normal: Vec3) -> f32 {
    0.48 + 0.12 * normal.z + 0.44 * normal.dot(SUN.normalize()).max(0.0)
}

/// Even noise in 0..1 that is the same for the same place.
pub fn noise(x: i32, y: i32, seed: u32) -> f32 {
    let mut h =
        (x as u32).wrapping_mul(0x8da6_b343) ^ (y as u32).wrapping_mul(0xd816_3841) ^ seed.wrapping_mul(0xcb1a_b31f);
    h ^= h >> 15;
    h = h.wrapping_mul(0x2c1b_3c6d);
    h ^= h >> 12;
    h = h.wrapping_mul(0x297a_2d39);
    h ^= h >> 15;
    (h >> 8) as f32 / (1 << 24) as f32
}

/// The same, bilinear between whole numbers.
pub fn smooth_noise(p: Vec2, seed: u32) -> f32 {
    let (f, i) = (p - p.floor(), p.floor().as_ivec2());
    let s = f * f * (3.0 - 2.0 * f);
    let row = |y: i32| noise(i.x, y, seed) * (1.0 - s.x) + noise(i.x + 1, y, seed) * s.x;
    row(i.y) * (1.0 - s.y) + row(i.y + 1) * s.y
}

/// The paint at a place (metres) on the strip of sides, or on a cap.
fn paint(part: &Part, p: Vec2, cap: bool, seed: u32) -> [f32; 3] {
    let mut c = part.color;
    let mut light = 0.9 + 0.2 * smooth_noise(p * 3.0, seed) * smooth_noise(p * 11.0, seed + 1).sqrt();
    match part.pattern {
        Pattern::Plain => {}
        Pattern::Waves(length) if !cap => light *= 0.82 + 0.18 * (TAU * p.x / length).cos(),
        Pattern::Windows(apart) if !cap => {
            let q = (p / apart).fract().abs();
            if (0.25..0.75).contains(&q.x) && (0.25..0.7).contains(&q.y) {
                c = [0.16, 0.2, 0.26];
            }
        }
        Pattern::Bricks => {
            let row = (p.y / 0.3).floor();
            let q = Vec2::new((p.x / 0.6 + 0.5 * row.rem_euclid(2.0)).fract().abs(), (p.y / 0.3).fract().abs());
            light *=
                if q.x < 0.08 || q.y < 0.12 { 0.7 } else { 0.9 + 0.15 * noise((p.x / 0.6) as i32, row as i32, seed) };
        }
        Pattern::Blotches(other) => {
            if smooth_noise(p * 1.3, seed + 2) + 0.3 * smooth_noise(p * 4.0, seed + 3) > 0.68 {
                c = other;
            }
        }
        Pattern::Waves(_) | Pattern::Windows(_) => {}
    }
    c.map(|v| v * light)
}

struct Tile {
    part: usize,
    /// The strip of sides, the cap at −Y, the cap at +Y.
    face: usize,
    /// Metres.
    size: Vec2,
    at: [u32; 2],
    pixels: [u32; 2],
}

const PAD: u32 = 2;

/// Every part as one closed mesh with one square texture so many pixels across.
pub fn assemble(parts: &[Part], across: u32, seed: u32) -> (Mesh, RgbImage) {
    let mut tiles: Vec<Tile> = Vec::new();
    for (i, p) in parts.iter().enumerate() {
        let (low, high) = p.bounds();
        for (face, size) in [Vec2::new(p.perimeter(), p.length), high - low, high - low].into_iter().enumerate() {
            tiles.push(Tile { part: i, face, size, at: [0; 2], pixels: [0; 2] });
        }
    }
    // Highest first onto shelves; the finest texels that find room.
    tiles.sort_by(|a, b| b.size.y.total_cmp(&a.size.y).then(a.part.cmp(&b.part)).then(a.face.cmp(&b.face)));
    let widest = tiles.iter().map(|t| t.size.x).fold(0.0, f32::max);
    let mut density = (across - 2 * PAD) as f32 / widest;
    while !shelve(&mut tiles, density, across) {
        density *= 0.95;
    }
    let mut texture = RgbImage::from_pixel(across, across, Rgb([90; 3]));
    let mut mesh = Mesh::default();
    for tile in &tiles {
        let part = &parts[tile.part];
        let seed = seed + 17 * tile.part as u32;
        draw(part, tile, seed, &mut texture);
        faces(part, tile, across, &mut mesh);
    }
    (mesh, texture)
}

fn shelve(tiles: &mut [Tile], density: f32, across: u32) -> bool {
    let (mut x, mut y, mut shelf) = (0, 0, 0);
    for t in tiles {
        t.pixels = (t.size * density).ceil().max(Vec2::splat(2.0)).as_uvec2().to_array();
        let [w, h] = t.pixels.map(|v| v + 2 * PAD);
        if x + w > across {
            (x, y, shelf) = (0, y + shelf, 0);
        }
        if x + w > across || y + h > across {
            return false;
        }
        t.at = [x + PAD, y + PAD];
        (x, shelf) = (x + w, shelf.max(h));
    }
    true
}

fn draw(part: &Part, tile: &Tile, seed: u32, texture: &mut RgbImage) {
    let [w, h] = tile.pixels;
    let (low, _) = part.bounds();
    for y in 0..h + 2 * PAD {
        for x in 0..w + 2 * PAD {
            let inside = |v: u32, n: u32| (v.saturating_sub(PAD).min(n - 1) as f32 + 0.5) / n as f32;
            // Metres; rows from the top.
            let p = Vec2::new(inside(x, w), 1.0 - inside(y, h)) * tile.size;
            let cap = tile.face > 0;
            let normal = match tile.face {
                1 => -Vec3::Y,
                2 => Vec3::Y,
                _ => side_normal(part, p.x),
            };
            let at = if cap { p + low } else { p };
            let light = shade(part.turn * normal);
            let c = paint(part, at, cap, seed + tile.face as u32)
                .map(|v| ((v * light).clamp(0.0, 1.0) * 255.0 + 0.5) as u8);
            texture.put_pixel(tile.at[0] + x - PAD, tile.at[1] + y - PAD, Rgb(c));
        }
    }
}

/// Outward, of the side that holds the place so many metres along the strip.
fn side_normal(part: &Part, along: f32) -> Vec3 {
    let mut rest = along;
    let mut i = 0;
    while i + 1 < part.outline.len() && rest > part.side(i).length() {
        rest -= part.side(i).length();
        i += 1;
    }
    let d = part.side(i).normalize_or_zero();
    Vec3::new(d.y, 0.0, -d.x)
}

fn faces(part: &Part, tile: &Tile, across: u32, mesh: &mut Mesh) {
    let uv = |p: Vec2| {
        let [x, y] = tile.at.map(|v| v as f32);
        let [w, h] = tile.pixels.map(|v| v as f32);
        let q = (p / tile.size).clamp(Vec2::ZERO, Vec2::ONE);
        Vec2::new(x + q.x * w, across as f32 - (y + (1.0 - q.y) * h)) / across as f32
    };
    let n = part.outline.len();
    let half = part.length / 2.0;
    let first = |mesh: &Mesh| mesh.positions.len() as u32;
    let push = |mesh: &mut Mesh, p: Vec3, normal: Vec3, at: Vec2| {
        mesh.positions.push(p);
        mesh.normals.push((part.turn * normal).normalize());
        mesh.uvs.push(uv(at));
    };
    if tile.face == 0 {
        let mut along = 0.0;
        for i in 0..n {
            let start = first(mesh);
            let (a, b, d) = (part.outline[i], part.outline[(i + 1) % n], part.side(i));
            let normal = Vec3::new(d.y, 0.0, -d.x);
            for (p, y, x) in [(a, -half, 0.0), (b, -half, d.length()), (b, half, d.length()), (a, half, 0.0)] {
                push(mesh, part.world(p, y), normal, Vec2::new(along + x, y + half));
            }
            // Seen from outside, from −Y to +Y is to the left of the outline's way round.
            mesh.triangles.extend([[start, start + 2, start + 1], [start, start + 3, start + 2]]);
            along += d.length();
        }
        return;
    }
    let (low, _) = part.bounds();
    let (y, normal) = if tile.face == 1 { (-half, -Vec3::Y) } else { (half, Vec3::Y) };
    let start = first(mesh);
    for p in &part.outline {
        push(mesh, part.world(*p, y), normal, *p - low);
    }
    for i in 1..n as u32 - 1 {
        // (x, z) counter-clockwise is counter-clockwise seen from −Y.
        let t = [start, start + i, start + i + 1];
        mesh.triangles.push(if tile.face == 1 { t } else { [t[0], t[2], t[1]] });
    }
}
