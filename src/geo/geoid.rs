//! Height of the EGM96 geoid (mean sea level) above the WGS84 ellipsoid.
//!
//! `data/egm96.bin` holds EGM96 whole, as spherical harmonics to degree 360 fitted to the 15-minute grid;
//! `data/README.md` says how it was made and how far it is from the grid.

use super::wgs84::sin_cos_degrees;

const DEGREE: usize = 360;
/// Metres a step of the stored coefficients.
const STEP: f64 = 5e-5;
const TABLE: &[u8] = include_bytes!("data/egm96.bin");

/// What EGM96 itself is good to over land, metres, one standard deviation (NASA/TP-1998-206861, section 10: 0.5 to 1 m).
pub const SIGMA: f64 = 0.5;

/// Metres from the ellipsoid up to the geoid, latitude and longitude in degrees.
///
/// Σ (C cos mλ + S sin mλ) P̄ₙₘ(sin φ), φ geodetic; P̄ by the forward column recursion of Holmes and Featherstone
/// (J. Geodesy 76, 2002, eq. 11–13). Near the poles its seed underflows to 0 for those m alone whose sum is nothing.
pub fn undulation(latitude: f64, longitude: f64) -> f64 {
    let (sin_lat, cos_lat) = sin_cos_degrees(latitude);
    let (sin_lon, cos_lon) = sin_cos_degrees(longitude);
    let mut coefficients = Coefficients { at: 0 };
    let mut next = || coefficients.next() as f64;
    let (mut sum, mut seed) = (0.0, 1.0);
    let (mut sin_m, mut cos_m) = (0.0, 1.0);
    for m in 0..=DEGREE {
        let mf = m as f64;
        if m > 0 {
            let twice = if m == 1 { 2.0 } else { 1.0 };
            seed *= cos_lat * (twice * (2.0 * mf + 1.0) / (2.0 * mf)).sqrt();
            (sin_m, cos_m) = (sin_m * cos_lon + cos_m * sin_lon, cos_m * cos_lon - sin_m * sin_lon);
        }
        let (mut before, mut p) = (0.0, seed);
        for n in m..=DEGREE {
            if n > m {
                let nf = n as f64;
                let span = (nf - mf) * (nf + mf);
                let a = ((2.0 * nf - 1.0) * (2.0 * nf + 1.0) / span).sqrt();
                let b =
                    ((2.0 * nf + 1.0) * (nf + mf - 1.0) * (nf - mf - 1.0) / (span * (2.0 * nf - 3.0))).max(0.0).sqrt();
                (before, p) = (p, a * sin_lat * p - b * before);
            }
            let c = next();
            let s = if m > 0 { next() } else { 0.0 };
            sum += p * (c * cos_m + s * sin_m);
        }
    }
    sum * STEP
}

/// Zigzag LEB128 numbers of [`TABLE`].
struct Coefficients {
    at: usize,
}

impl Coefficients {
    /// 0 past the end: the test counts what is there.
    fn next(&mut self) -> i64 {
        let (mut value, mut shift) = (0u64, 0);
        while let Some(&byte) = TABLE.get(self.at) {
            self.at += 1;
            value |= u64::from(byte & 127) << shift;
            shift += 7;
            if byte & 128 == 0 {
                break;
            }
        }
        (value >> 1) as i64 ^ -((value & 1) as i64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_whole() {
        let mut c = Coefficients { at: 0 };
        let count = (DEGREE + 1) * (DEGREE + 2) + (DEGREE + 1) - 2 * (DEGREE + 1);
        (0..count).for_each(|_| _ = c.next());
        assert_eq!(c.at, TABLE.len());
    }

    /// `cs2cs -f %.4f EPSG:4326+5773 EPSG:4979` of PROJ 9.1 at nodes of its 15-minute grid, where it does not
    /// interpolate; the command stands in the table's head.
    #[test]
    fn agrees_with_proj_at_the_nodes_of_its_grid() {
        let (mut rows, mut worst, mut squares) = (0, 0f64, 0.0);
        for line in include_str!("../../tests/data/egm96.txt").lines().filter(|l| !l.starts_with('#')) {
            let v: Vec<f64> = line.split_whitespace().map(|t| t.parse().unwrap()).collect();
            let off = (undulation(v[0], v[1]) - v[2]).abs();
            worst = worst.max(off);
            squares += off * off;
            rows += 1;
        }
        assert!(rows >= 200);
        assert!(worst < 0.12 && (squares / rows as f64).sqrt() < 0.025, "{worst} {}", (squares / rows as f64).sqrt());
    }

    #[test]
    fn one_value_at_a_pole_and_no_seam() {
        for lat in [90.0, -90.0] {
            assert!((undulation(lat, 17.0) - undulation(lat, -140.0)).abs() < 1e-9);
        }
        assert!((undulation(10.0, 180.0) - undulation(10.0, -180.0)).abs() < 1e-9);
        assert!((undulation(89.999_999, 0.0) - undulation(90.0, 0.0)).abs() < 1e-3);
    }
}
