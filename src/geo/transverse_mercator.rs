//! Transverse Mercator and polar stereographic projections of WGS84.
//!
//! Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 85 (2011): Krüger's series to the sixth
//! order in the third flattening. The polar stereographic projection shares its conformal latitude.

use super::wgs84::{A, F, atan2_degrees, sin_cos_degrees};

/// Third flattening.
const N: f64 = F / (2.0 - F);
const N2: f64 = N * N;
const N3: f64 = N2 * N;
const N4: f64 = N3 * N;
const N5: f64 = N4 * N;
const N6: f64 = N5 * N;

/// Rectifying radius (eq. 14).
const RADIUS: f64 = A / (1.0 + N) * (1.0 + N2 / 4.0 + N4 / 64.0 + N6 / 256.0);

/// Eq. 35.
const ALPHA: [f64; 6] = [
    N / 2.0 - N2 * 2.0 / 3.0 + N3 * 5.0 / 16.0 + N4 * 41.0 / 180.0 - N5 * 127.0 / 288.0 + N6 * 7891.0 / 37800.0,
    N2 * 13.0 / 48.0 - N3 * 3.0 / 5.0 + N4 * 557.0 / 1440.0 + N5 * 281.0 / 630.0 - N6 * 1_983_433.0 / 1_935_360.0,
    N3 * 61.0 / 240.0 - N4 * 103.0 / 140.0 + N5 * 15061.0 / 26880.0 + N6 * 167_603.0 / 181_440.0,
    N4 * 49561.0 / 161_280.0 - N5 * 179.0 / 168.0 + N6 * 6_601_661.0 / 7_257_600.0,
    N5 * 34729.0 / 80640.0 - N6 * 3_418_889.0 / 1_995_840.0,
    N6 * 212_378_941.0 / 319_334_400.0,
];

/// Eq. 36.
const BETA: [f64; 6] = [
    N / 2.0 - N2 * 2.0 / 3.0 + N3 * 37.0 / 96.0 - N4 / 360.0 - N5 * 81.0 / 512.0 + N6 * 96199.0 / 604_800.0,
    N2 / 48.0 + N3 / 15.0 - N4 * 437.0 / 1440.0 + N5 * 46.0 / 105.0 - N6 * 1_118_711.0 / 3_870_720.0,
    N3 * 17.0 / 480.0 - N4 * 37.0 / 840.0 - N5 * 209.0 / 4480.0 + N6 * 5569.0 / 90720.0,
    N4 * 4397.0 / 161_280.0 - N5 * 11.0 / 504.0 - N6 * 830_251.0 / 7_257_600.0,
    N5 * 4583.0 / 161_280.0 - N6 * 108_847.0 / 3_991_680.0,
    N6 * 20_648_693.0 / 638_668_800.0,
];

/// From conformal to geographic latitude (Karney, "On auxiliary latitudes", Survey Review 56, 2024, appendix A).
const DELTA: [f64; 6] = [
    2.0 * N - N2 * 2.0 / 3.0 - 2.0 * N3 + N4 * 116.0 / 45.0 + N5 * 26.0 / 45.0 - N6 * 2854.0 / 675.0,
    N2 * 7.0 / 3.0 - N3 * 8.0 / 5.0 - N4 * 227.0 / 45.0 + N5 * 2704.0 / 315.0 + N6 * 2323.0 / 945.0,
    N3 * 56.0 / 15.0 - N4 * 136.0 / 35.0 - N5 * 1262.0 / 105.0 + N6 * 73814.0 / 2835.0,
    N4 * 4279.0 / 630.0 - N5 * 332.0 / 35.0 - N6 * 399_572.0 / 14175.0,
    N5 * 4174.0 / 315.0 - N6 * 144_838.0 / 6237.0,
    N6 * 601_676.0 / 22275.0,
];

/// From geographic to conformal latitude (the same).
const CHI: [f64; 6] = [
    -2.0 * N + N2 * 2.0 / 3.0 + N3 * 4.0 / 3.0 - N4 * 82.0 / 45.0 + N5 * 32.0 / 45.0 + N6 * 4642.0 / 4725.0,
    N2 * 5.0 / 3.0 - N3 * 16.0 / 15.0 - N4 * 13.0 / 9.0 + N5 * 904.0 / 315.0 - N6 * 1522.0 / 945.0,
    -N3 * 26.0 / 15.0 + N4 * 34.0 / 21.0 + N5 * 8.0 / 5.0 - N6 * 12686.0 / 2835.0,
    N4 * 1237.0 / 630.0 - N5 * 12.0 / 5.0 - N6 * 24832.0 / 14175.0,
    -N5 * 734.0 / 315.0 + N6 * 109_598.0 / 31185.0,
    N6 * 444_337.0 / 155_925.0,
];

/// Of UTM.
const UTM_SCALE: f64 = 0.9996;

/// c_1 sin 2x + c_2 sin 4x + … by Clenshaw, from sine and cosine of x.
fn sine_series(c: &[f64; 6], sin: f64, cos: f64) -> f64 {
    let (s, c2) = (2.0 * sin * cos, 2.0 * (cos - sin) * (cos + sin));
    let (mut y1, mut y2) = (0.0, 0.0);
    for &c in c.iter().rev() {
        (y1, y2) = (c2 * y1 - y2 + c, y1);
    }
    s * y1
}

/// Sine and cosine of x + d from those of x, |d| below 0.01.
fn turned_by(sin: f64, cos: f64, d: f64) -> (f64, f64) {
    let d2 = d * d;
    let s = d * (1.0 - d2 / 6.0 * (1.0 - d2 / 20.0 * (1.0 - d2 / 42.0)));
    // One less than the cosine, so that nothing of the angle itself is rounded away.
    let c = -d2 / 2.0 * (1.0 - d2 / 12.0 * (1.0 - d2 / 30.0));
    (sin + (sin * c + cos * s), cos + (cos * c - sin * s))
}

/// Sine and cosine of the conformal latitude from those of the geographic latitude.
fn conformal(sin: f64, cos: f64) -> (f64, f64) {
    turned_by(sin, cos, sine_series(&CHI, sin, cos))
}

/// Geographic latitude, degrees, of the conformal latitude whose sine and cosine stand in this ratio.
fn geographic(sin: f64, cos: f64) -> f64 {
    let norm = (sin * sin + cos * cos).sqrt();
    atan2_degrees(sin, cos) + sine_series(&DELTA, sin / norm, cos / norm).to_degrees()
}

/// Sum of c_j times the sine of 2j (ξ + iη) by Clenshaw, given sine and cosine of 2ξ and hyperbolic ones of 2η.
fn complex_sine_series(c: &[f64; 6], [sin, cos, sinh, cosh]: [f64; 4]) -> (f64, f64) {
    // 2 cos(2ζ) and sin(2ζ) of the complex ζ.
    let (ar, ai) = (2.0 * cos * cosh, -2.0 * sin * sinh);
    let (mut y1, mut y2) = ((0.0, 0.0), (0.0, 0.0));
    for &c in c.iter().rev() {
        let y0 = (ar * y1.0 - ai * y1.1 - y2.0 + c, ar * y1.1 + ai * y1.0 - y2.1);
        (y2, y1) = (y1, y0);
    }
    let (sr, si) = (sin * cosh, cos * sinh);
    (sr * y1.0 - si * y1.1, sr * y1.1 + si * y1.0)
}

/// Degrees → metres east of the central meridian and north of the equator, scale 0.9996.
/// Within 35° of the central meridian the series is good to nanometres.
pub fn utm_forward(latitude: f64, longitude_off: f64) -> (f64, f64) {
    let (sin_lat, cos_lat) = sin_cos_degrees(latitude);
    let (sin_lon, cos_lon) = sin_cos_degrees(longitude_off);
    let (sin_chi, cos_chi) = conformal(sin_lat, cos_lat);
    let (north, east) = (cos_chi * cos_lon, cos_chi * sin_lon);
    let r = (sin_chi * sin_chi + north * north).sqrt();
    let xi = sin_chi.atan2(north);
    let sinh = east / r;
    let cosh = (1.0 + sinh * sinh).sqrt();
    let eta = sinh.asinh();
    let (s, c) = (sin_chi / r, north / r);
    let doubled = [2.0 * s * c, (c - s) * (c + s), 2.0 * sinh * cosh, 1.0 + 2.0 * sinh * sinh];
    let (d_xi, d_eta) = complex_sine_series(&ALPHA, doubled);
    (UTM_SCALE * RADIUS * (eta + d_eta), UTM_SCALE * RADIUS * (xi + d_xi))
}

/// The inverse of [`utm_forward`].
pub fn utm_reverse(east: f64, north: f64) -> (f64, f64) {
    let (xi, eta) = (north / (UTM_SCALE * RADIUS), east / (UTM_SCALE * RADIUS));
    let (s, c) = xi.sin_cos();
    let sinh = eta.sinh();
    let cosh = (1.0 + sinh * sinh).sqrt();
    let doubled = [2.0 * s * c, (c - s) * (c + s), 2.0 * sinh * cosh, 1.0 + 2.0 * sinh * sinh];
    let (d_xi, d_eta) = complex_sine_series(&BETA, doubled);
    let (sin, cos) = turned_by(s, c, -d_xi);
    // sinh(η − d) for the small d.
    let d2 = d_eta * d_eta;
    let sinh_d = d_eta * (1.0 + d2 / 6.0 * (1.0 + d2 / 20.0));
    let sinh = sinh + (sinh * (d2 / 2.0 * (1.0 + d2 / 12.0 * (1.0 + d2 / 30.0))) - cosh * sinh_d);
    (geographic(sin, (sinh * sinh + cos * cos).sqrt()), atan2_degrees(sinh, cos))
}

/// 2 k₀ a / c of the stereographic projection, k₀ = 0.994, c = √((1 + e)^(1 + e) (1 − e)^(1 − e)) (Snyder 1987, eq. 21-33), metres.
const STEREOGRAPHIC_SCALE: f64 = 12_637_318.498_257_402;

/// Degrees → metres from the pole along 90° E and along 180° (north) or 0° (south): false origin not added.
pub fn ups_forward(north: bool, latitude: f64, longitude: f64) -> (f64, f64) {
    let (sin_lat, cos_lat) = sin_cos_degrees(if north { latitude } else { -latitude });
    let (sin_lon, cos_lon) = sin_cos_degrees(longitude);
    let (sin_chi, cos_chi) = conformal(sin_lat, cos_lat);
    // tan of half the angle from the pole; the other hemisphere is far away, and its pole infinitely.
    let t = if sin_chi >= 0.0 { cos_chi / (1.0 + sin_chi) } else { (1.0 - sin_chi) / cos_chi };
    let rho = STEREOGRAPHIC_SCALE * t;
    (rho * sin_lon, if north { -rho * cos_lon } else { rho * cos_lon })
}

/// The inverse of [`ups_forward`]; the longitude of the pole is 0.
pub fn ups_reverse(north: bool, east: f64, along: f64) -> (f64, f64) {
    let rho = east.hypot(along);
    let down = if north { -along } else { along };
    let latitude = if rho == 0.0 {
        90.0
    } else {
        let t = rho / STEREOGRAPHIC_SCALE;
        geographic((1.0 - t) * (1.0 + t), 2.0 * t)
    };
    let longitude = if rho == 0.0 { 0.0 } else { atan2_degrees(east, down) };
    (if north { latitude } else { -latitude }, longitude)
}

#[cfg(test)]
mod tests {
    use super::super::wgs84::E2;
    use super::*;

    #[test]
    fn constants_are_their_formulas() {
        let e = E2.sqrt();
        let scale = 2.0 * 0.994 * A / ((1.0 - F) * (e * e.atanh()).exp());
        assert!((scale - STEREOGRAPHIC_SCALE).abs() < 1e-8, "{scale}");
        // Karney 2011, eq. 7-9: the conformal latitude by its own formula.
        for degrees in [0.0, 1e-7, 12.5, 45.0, 71.0, 89.0, 90.0 - 1e-7] {
            let (sin, cos) = sin_cos_degrees(degrees);
            let tau = sin / cos;
            let root = (1.0 + tau * tau).sqrt();
            let sigma = (e * (e * tau / root).atanh()).sinh();
            let (s, c) = conformal(sin, cos);
            let expected = tau * (1.0 + sigma * sigma).sqrt() - sigma * root;
            assert!(
                (s / c / expected.max(1e-300) - 1.0).abs() < 2e-14 || degrees == 0.0,
                "{degrees}: {} {expected}",
                s / c
            );
        }
    }
}
