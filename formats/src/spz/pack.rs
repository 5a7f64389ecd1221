//! Numbers to bytes and back, attribute by attribute.

use super::axes::{Axes, Flip};
use super::{FORMAT, Header, Version};
use crate::splats::{BASES, logit, sigmoid, unit};
use crate::{Error, Result, Splats};

/// The colour coefficient is stored times this, about 0.5: wider than a colour, since other degrees may bring it back.
const COLOR_SCALE: f32 = 0.15;
/// Bits kept of harmonics of degree 1, and above.
const SH_BITS: [u32; 2] = [5, 4];
/// Opacity 0 and 255 of 255 read as ± this: half a step from the end.
const MAX_LOGIT: f32 = 6.232_448; // ln(509)

/// 12, or as many as the farthest coordinate leaves of 23.
pub fn fractional_bits(positions: &[[f32; 3]]) -> Result<u32> {
    let far = positions.iter().flatten().fold(0.0f32, |far, x| far.max(x.abs()));
    let fits = |bits: &u32| f64::from(far) * f64::from(1u32 << bits) < f64::from((1 << 23) - 1);
    (1..=12).rev().find(fits).ok_or_else(|| {
        Error::unsupported(FORMAT, format!("positions reach 4,194 km, found {} km; move the origin", far / 1000.0))
    })
}

/// The six streams in file order.
pub fn pack(splats: &Splats, header: &Header, axes: Axes) -> [Vec<u8>; 6] {
    let flip = Flip::between(axes, Axes::RUB);
    let mut streams = header.sizes().map(Vec::with_capacity);
    let one = f64::from(1u32 << header.fractional_bits);
    for p in &splats.positions {
        for (x, sign) in p.iter().zip(flip.position) {
            let fixed = (f64::from(x * sign) * one).round() as i32;
            streams[0].extend_from_slice(&fixed.to_le_bytes()[..3]);
        }
    }
    streams[1].extend(splats.logit_opacities.iter().map(|&o| byte(sigmoid(o) * 255.0)));
    let color = |c: f32| byte(c * (COLOR_SCALE * 255.0) + 127.5);
    streams[2].extend(splats.sh.iter().flat_map(|sh| sh[0].map(color)));
    streams[3].extend(splats.log_scales.iter().flat_map(|s| s.map(|x| byte((x + 10.0) * 16.0))));
    for q in &splats.rotations {
        let [w, x, y, z] = unit(*q).unwrap_or([1.0, 0.0, 0.0, 0.0]);
        let q = [x * flip.rotation[0], y * flip.rotation[1], z * flip.rotation[2], w];
        match header.version {
            Version::V2 => {
                let sign = if w < 0.0 { -127.5 } else { 127.5 };
                streams[4].extend(q[..3].iter().map(|x| byte(x * sign + 127.5)));
            }
            _ => streams[4].extend(smallest_three(q).to_le_bytes()),
        }
    }
    for sh in &splats.sh {
        for basis in 1..BASES[header.degree] {
            let bits = SH_BITS[usize::from(basis >= BASES[1])];
            streams[5].extend(sh[basis].map(|c| harmonic(c * flip.sh[basis], bits)));
        }
    }
    streams
}

/// The streams' splats; the lengths have been checked.
pub fn unpack(header: &Header, streams: &[Vec<u8>; 6], axes: Axes) -> Splats {
    let flip = Flip::between(Axes::RUB, axes);
    let one = f64::from(1u32 << header.fractional_bits);
    let fixed = |b: &[u8]| f64::from(i32::from_le_bytes([0, b[0], b[1], b[2]]) >> 8) / one;
    let position = |b: &[u8]| std::array::from_fn(|i| fixed(&b[3 * i..3 * i + 3]) as f32 * flip.position[i]);
    let triple = |b: &[u8], f: fn(u8) -> f32| [f(b[0]), f(b[1]), f(b[2])];
    let width = if header.version == Version::V2 { 3 } else { 4 };
    let rotation = |b: &[u8]| {
        let [x, y, z, w] = match *b {
            [x, y, z] => first_three([x, y, z]),
            [a, b, c, d] => from_smallest_three(u32::from_le_bytes([a, b, c, d])),
            _ => [0.0, 0.0, 0.0, 1.0],
        };
        [w, x * flip.rotation[0], y * flip.rotation[1], z * flip.rotation[2]]
    };
    let color = |b: u8| (f32::from(b) / 255.0 - 0.5) / COLOR_SCALE;
    let mut sh: Vec<[[f32; 3]; 16]> = streams[2]
        .chunks_exact(3)
        .map(|b| {
            let mut sh = [[0.0; 3]; 16];
            sh[0] = triple(b, color);
            sh
        })
        .collect();
    let bases = BASES[header.degree] - 1;
    if bases > 0 {
        for (sh, bytes) in sh.iter_mut().zip(streams[5].chunks_exact(3 * bases)) {
            for (basis, b) in bytes.chunks_exact(3).enumerate() {
                sh[basis + 1] = triple(b, |b| (f32::from(b) - 128.0) / 128.0).map(|c| c * flip.sh[basis + 1]);
            }
        }
    }
    Splats {
        positions: streams[0].chunks_exact(9).map(position).collect(),
        logit_opacities: streams[1].iter().map(|&a| logit(f32::from(a) / 255.0, MAX_LOGIT)).collect(),
        log_scales: streams[3].chunks_exact(3).map(|b| triple(b, |b| f32::from(b) / 16.0 - 10.0)).collect(),
        rotations: streams[4].chunks_exact(width).map(rotation).collect(),
        sh,
    }
}

fn byte(x: f32) -> u8 {
    x.round().clamp(0.0, 255.0) as u8
}

/// −1..1 to the nearest of 2^bits steps, one of which is 0.
fn harmonic(x: f32, bits: u32) -> u8 {
    let step = 1 << (8 - bits);
    let whole = (x * 128.0).round().clamp(-1000.0, 1000.0) as i32 + 128;
    ((whole + step / 2).div_euclid(step) * step).clamp(0, 255) as u8
}

/// x, y, z, w from three bytes: w ≥ 0 completes them.
fn first_three(bytes: [u8; 3]) -> [f32; 4] {
    let [x, y, z] = bytes.map(|b| f32::from(b) / 127.5 - 1.0);
    [x, y, z, (1.0 - x * x - y * y - z * z).max(0.0).sqrt()]
}

/// Index of the largest of x, y, z, w in 2 bits, then the others, each a sign and 9 bits of 0..√½.
fn smallest_three(q: [f32; 4]) -> u32 {
    let largest = (1..4).fold(0, |best, i| if q[i].abs() > q[best].abs() { i } else { best });
    let sign = if q[largest] < 0.0 { -1.0 } else { 1.0 };
    (0..4).filter(|&i| i != largest).fold(largest as u32, |bits, i| {
        let size = (q[i].abs() / std::f32::consts::FRAC_1_SQRT_2 * 511.0 + 0.5).min(511.0) as u32;
        bits << 10 | u32::from(q[i] * sign < 0.0) << 9 | size
    })
}

fn from_smallest_three(bits: u32) -> [f32; 4] {
    let largest = (bits >> 30) as usize;
    let mut q = [0.0f32; 4];
    let mut rest = bits;
    let mut sum = 0.0;
    for i in (0..4).rev().filter(|&i| i != largest) {
        let size = (rest & 511) as f32 / 511.0 * std::f32::consts::FRAC_1_SQRT_2;
        q[i] = if rest >> 9 & 1 == 1 { -size } else { size };
        sum += size * size;
        rest >>= 10;
    }
    q[largest] = (1.0 - sum).max(0.0).sqrt();
    q
}
