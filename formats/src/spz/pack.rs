//! Numbers to bytes and back, attribute by attribute.

use super::axes::{Axes, Flip};
use super::{FORMAT, Header, Version};
use crate::splats::{BASES, logit, sigmoid, unit};
use crate::{Error, Result, Splats, threads};

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
    let widths = header.widths();
    let one = f64::from(1u32 << header.fractional_bits);
    let mut streams = header.sizes().map(|size| vec![0; size]);
    let mut fill = |stream: usize, one_splat: &(dyn Fn(usize, &mut [u8]) + Sync)| {
        let width = widths[stream];
        if width > 0 {
            threads::on_rows(&mut streams[stream], width, |first, rows| {
                rows.chunks_exact_mut(width).enumerate().for_each(|(i, row)| one_splat(first + i, row));
            });
        }
    };
    fill(0, &|i, row| {
        for ((x, sign), to) in splats.positions[i].iter().zip(flip.position).zip(row.chunks_exact_mut(3)) {
            let fixed = (f64::from(x * sign) * one).round() as i32;
            to.copy_from_slice(&fixed.to_le_bytes()[..3]);
        }
    });
    fill(1, &|i, row| row[0] = byte(sigmoid(splats.logit_opacities[i]) * 255.0));
    fill(2, &|i, row| row.copy_from_slice(&splats.sh[i][0].map(|c| byte(c * (COLOR_SCALE * 255.0) + 127.5))));
    fill(3, &|i, row| row.copy_from_slice(&splats.log_scales[i].map(|x| byte((x + 10.0) * 16.0))));
    fill(4, &|i, row| {
        let [w, x, y, z] = unit(splats.rotations[i]).unwrap_or([1.0, 0.0, 0.0, 0.0]);
        let q = [x * flip.rotation[0], y * flip.rotation[1], z * flip.rotation[2], w];
        match header.version {
            Version::V2 => {
                let sign = if w < 0.0 { -127.5 } else { 127.5 };
                row.iter_mut().zip(q).for_each(|(to, x)| *to = byte(x * sign + 127.5));
            }
            _ => row.copy_from_slice(&smallest_three(q).to_le_bytes()),
        }
    });
    fill(5, &|i, row| {
        for (basis, to) in (1..).zip(row.chunks_exact_mut(3)) {
            let bits = SH_BITS[usize::from(basis >= BASES[1])];
            to.copy_from_slice(&splats.sh[i][basis].map(|c| harmonic(c * flip.sh[basis], bits)));
        }
    });
    streams
}

/// The streams' splats; the lengths have been checked.
pub fn unpack(header: &Header, streams: &[Vec<u8>; 6], axes: Axes) -> Splats {
    let flip = Flip::between(Axes::RUB, axes);
    let one = f64::from(1u32 << header.fractional_bits);
    let fixed = |b: &[u8]| f64::from(i32::from_le_bytes([0, b[0], b[1], b[2]]) >> 8) / one;
    let triple = |b: &[u8], f: fn(u8) -> f32| [f(b[0]), f(b[1]), f(b[2])];
    let rotation = |b: &[u8]| {
        let [x, y, z, w] = match *b {
            [x, y, z] => first_three([x, y, z]),
            [a, b, c, d] => from_smallest_three(u32::from_le_bytes([a, b, c, d])),
            _ => [0.0, 0.0, 0.0, 1.0],
        };
        [w, x * flip.rotation[0], y * flip.rotation[1], z * flip.rotation[2]]
    };
    let opacities: Vec<f32> = (0..=255u8).map(|a| logit(f32::from(a) / 255.0, MAX_LOGIT)).collect();
    let widths = header.widths();
    let row = |stream: usize, i: usize| &streams[stream][i * widths[stream]..(i + 1) * widths[stream]];
    threads::splats(header.count, |part| {
        for i in 0..part.positions.len() {
            let at = part.first + i;
            let place = row(0, at);
            part.positions[i] = std::array::from_fn(|a| fixed(&place[3 * a..3 * a + 3]) as f32 * flip.position[a]);
            part.logit_opacities[i] = opacities[usize::from(streams[1][at])];
            part.log_scales[i] = triple(row(3, at), |b| f32::from(b) / 16.0 - 10.0);
            part.rotations[i] = rotation(row(4, at));
            part.sh[i][0] = triple(row(2, at), |b| (f32::from(b) / 255.0 - 0.5) / COLOR_SCALE);
            for ((sh, b), sign) in part.sh[i][1..].iter_mut().zip(row(5, at).chunks_exact(3)).zip(&flip.sh[1..]) {
                *sh = triple(b, |b| (f32::from(b) - 128.0) / 128.0).map(|c| c * sign);
            }
        }
    })
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
