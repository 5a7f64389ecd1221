//! Declination of the Earth's magnetic field: the World Magnetic Model 2025 (NOAA NCEI and BGS), degree 12.
//!
//! Chulliat et al., "The US/UK World Magnetic Model for 2025-2030": technical report, section 1.2, eq. 4-19.

use super::Geodetic;
use super::wgs84::{A, E2, sin_cos_degrees};

const DEGREE: usize = 12;
const EPOCH: f64 = 2025.0;
/// Geomagnetic reference radius, metres.
const RADIUS: f64 = 6_371_200.0;
/// NOAA's own file: n, m, g, h (nT), and their change a year.
const TABLE: &str = include_str!("data/wmm2025.cof");

/// What the model says at a place and time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// Degrees that a compass points east of true north.
    pub declination: f64,
    /// Horizontal intensity, nanotesla: below 6,000 (caution) and 2,000 (blackout) a compass is not to be trusted.
    pub horizontal: f64,
    /// The report's error of declination, degrees, one standard deviation: √(0.26² + (5417 / H)²).
    pub sigma: f64,
    /// The time lies outside the five years for which the model was made.
    pub out_of_date: bool,
}

/// `year` with its fraction.
pub fn field(at: Geodetic, year: f64) -> Field {
    let (sin_lat, cos_lat) = sin_cos_degrees(at.latitude);
    let (sin_lon, cos_lon) = sin_cos_degrees(at.longitude);
    // Geocentric latitude and radius.
    let n = A / (1.0 - E2 * sin_lat * sin_lat).sqrt();
    let (p, z) = ((n + at.height) * cos_lat, (n * (1.0 - E2) + at.height) * sin_lat);
    let r = p.hypot(z);
    // On the axis east and north have no meaning; a hair beside it they have.
    let (sin, cos) = (z / r, (p / r).max(1e-10));
    let (legendre, slope) = schmidt(sin, cos);

    let (mut north, mut east, mut down) = (0.0, 0.0, 0.0);
    let mut multiples = [(0.0, 1.0); DEGREE + 1];
    for m in 1..=DEGREE {
        let (s, c) = multiples[m - 1];
        multiples[m] = (s * cos_lon + c * sin_lon, c * cos_lon - s * sin_lon);
    }
    for [n, m, g, h, g_year, h_year] in rows() {
        let (n, m) = (n as usize, m as usize);
        let (g, h) = (g + g_year * (year - EPOCH), h + h_year * (year - EPOCH));
        let (sin_m, cos_m) = multiples[m];
        let falloff = (RADIUS / r).powi(n as i32 + 2);
        let along = g * cos_m + h * sin_m;
        north -= falloff * along * slope[n][m];
        east += falloff * m as f64 * (g * sin_m - h * cos_m) * legendre[n][m] / cos;
        down -= falloff * (n + 1) as f64 * along * legendre[n][m];
    }
    // From geocentric to geodetic north.
    let turn = (sin * cos_lat - cos * sin_lat).asin();
    let north = north * turn.cos() - down * turn.sin();
    let horizontal = north.hypot(east);
    Field {
        declination: east.atan2(north).to_degrees(),
        horizontal,
        sigma: 0.26f64.hypot(5417.0 / horizontal.max(1.0)),
        out_of_date: !(EPOCH..EPOCH + 5.0).contains(&year),
    }
}

fn rows() -> impl Iterator<Item = [f64; 6]> {
    TABLE.lines().skip(1).filter_map(|line| {
        let mut row = [0.0; 6];
        let mut words = line.split_whitespace();
        for value in &mut row {
            *value = words.next()?.parse().ok()?;
        }
        Some(row)
    })
}

type Table = [[f64; DEGREE + 1]; DEGREE + 1];

/// Schmidt semi-normalised Legendre functions of the sine of the latitude and their derivatives by the latitude.
fn schmidt(sin: f64, cos: f64) -> (Table, Table) {
    let (mut p, mut d) = ([[0.0; DEGREE + 1]; DEGREE + 1], [[0.0; DEGREE + 1]; DEGREE + 1]);
    p[0][0] = 1.0;
    for n in 1..=DEGREE {
        for m in 0..=n {
            let (nf, mf) = (n as f64, m as f64);
            (p[n][m], d[n][m]) = if n == m {
                let k = if n == 1 { 1.0 } else { ((2.0 * nf - 1.0) / (2.0 * nf)).sqrt() };
                (k * cos * p[n - 1][m - 1], k * (cos * d[n - 1][m - 1] - sin * p[n - 1][m - 1]))
            } else {
                let root = ((nf - mf) * (nf + mf)).sqrt();
                let (p2, d2) = if n >= 2 && m <= n - 2 { (p[n - 2][m], d[n - 2][m]) } else { (0.0, 0.0) };
                let back = ((nf - 1.0 - mf) * (nf - 1.0 + mf)).max(0.0).sqrt();
                let once = 2.0 * nf - 1.0;
                (
                    (once * sin * p[n - 1][m] - back * p2) / root,
                    (once * (sin * d[n - 1][m] + cos * p[n - 1][m]) - back * d2) / root,
                )
            };
        }
    }
    (p, d)
}

/// `2025:07:01`, the form of EXIF's date stamp, as a year with its fraction.
pub fn decimal_year(year: i64, month: i64, day: i64) -> Option<f64> {
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    let leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    let months = [31, if leap { 29 } else { 28 }, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let before: i64 = months[..month as usize - 1].iter().sum();
    Some(year as f64 + (before + day - 1) as f64 / if leap { 366.0 } else { 365.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table of NOAA's own program; the command stands in its head.
    #[test]
    fn agrees_with_noaas_program() {
        let mut rows = 0;
        for line in include_str!("../../tests/data/wmm2025.txt").lines().filter(|l| !l.starts_with('#')) {
            let v: Vec<f64> = line.split_whitespace().map(|t| t.parse().unwrap()).collect();
            let f = field(Geodetic { latitude: v[1], longitude: v[2], height: v[3] * 1000.0 }, v[0]);
            let off = (f.declination - v[4] + 180.0).rem_euclid(360.0) - 180.0;
            assert!(off.abs() < 1e-4 && (f.horizontal - v[5]).abs() < 0.05, "{line}: {f:?}");
            rows += 1;
        }
        assert!(rows >= 100);
    }

    #[test]
    fn dates() {
        assert_eq!(decimal_year(2025, 1, 1), Some(2025.0));
        assert_eq!(decimal_year(2025, 7, 2), Some(2025.0 + 182.0 / 365.0));
        assert_eq!(decimal_year(2025, 13, 1), None);
    }
}
