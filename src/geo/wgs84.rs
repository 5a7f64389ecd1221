//! The WGS84 ellipsoid: geodetic ↔ earth-centred ↔ local east-north-up, f64.

/// Semi-major axis, metres (NGA.STND.0036, table 3.1).
pub const A: f64 = 6_378_137.0;
/// Flattening.
pub const F: f64 = 1.0 / 298.257_223_563;
/// First eccentricity squared, f(2 − f).
pub const E2: f64 = F * (2.0 - F);
/// 1 − f, the ratio of the axes and the root of 1 − e².
const ONE_LESS_F: f64 = 1.0 - F;

/// Latitude and longitude in degrees, height above the ellipsoid in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geodetic {
    pub latitude: f64,
    pub longitude: f64,
    pub height: f64,
}

/// Earth-centred, earth-fixed, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ecef {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

/// East, north, up of an origin, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enu {
    pub east: f64,
    pub north: f64,
    pub up: f64,
}

impl Geodetic {
    /// Closed form: N = a / √(1 − e² sin²φ).
    pub fn to_ecef(self) -> Ecef {
        let (sin_lat, cos_lat) = sin_cos_degrees(self.latitude);
        let (sin_lon, cos_lon) = sin_cos_degrees(self.longitude);
        let n = A / (1.0 - E2 * sin_lat * sin_lat).sqrt();
        Ecef {
            x: (n + self.height) * cos_lat * cos_lon,
            y: (n + self.height) * cos_lat * sin_lon,
            z: (n * (1.0 - E2) + self.height) * sin_lat,
        }
    }

    /// The point that lies `local` from `self`.
    pub fn offset(self, local: Enu) -> Geodetic {
        let o = self.to_ecef();
        let [e, n, u] = self.axes();
        let d = |i: usize| e[i] * local.east + n[i] * local.north + u[i] * local.up;
        Ecef { x: o.x + d(0), y: o.y + d(1), z: o.z + d(2) }.to_geodetic()
    }

    /// `point` in the frame of `self`.
    pub fn local(self, point: Ecef) -> Enu {
        let o = self.to_ecef();
        let d = [point.x - o.x, point.y - o.y, point.z - o.z];
        let dot = |a: [f64; 3]| a[0] * d[0] + a[1] * d[1] + a[2] * d[2];
        let [e, n, u] = self.axes();
        Enu { east: dot(e), north: dot(n), up: dot(u) }
    }

    /// East, north and up as unit vectors in the earth-centred frame.
    pub fn axes(self) -> [[f64; 3]; 3] {
        let (sin_lat, cos_lat) = sin_cos_degrees(self.latitude);
        let (sin_lon, cos_lon) = sin_cos_degrees(self.longitude);
        [
            [-sin_lon, cos_lon, 0.0],
            [-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat],
            [cos_lat * cos_lon, cos_lat * sin_lon, sin_lat],
        ]
    }
}

impl Ecef {
    /// Fukushima, "Transformation from Cartesian to geodetic coordinates accelerated by Halley's method", J. Geodesy 79
    /// (2006), eq. 12-26, two steps: from 5,000 km below the surface outwards the error is rounding alone.
    /// The longitude of a point on the axis is 0.
    pub fn to_geodetic(self) -> Geodetic {
        let p = (self.x * self.x + self.y * self.y).sqrt();
        let longitude = self.y.atan2(self.x).to_degrees();
        let height_at_pole = self.z.abs() - A * ONE_LESS_F;
        if p < 1e-9 {
            return Geodetic { latitude: 90f64.copysign(self.z), longitude: 0.0, height: height_at_pole };
        }
        let (r, z) = (p / A, ONE_LESS_F / A * self.z.abs());
        let (mut s, mut c) = (z, ONE_LESS_F * r);
        for _ in 0..2 {
            let a = (s * s + c * c).sqrt();
            let a3 = a * a * a;
            let d = z * a3 + E2 * s * s * s;
            let f = r * a3 - E2 * c * c * c;
            let b = 1.5 * E2 * s * c * c * ((r * s - z * c) * a - E2 * s * c);
            (s, c) = (d * f - b * s, f * f - b * c);
        }
        let cc = ONE_LESS_F * c;
        let latitude = (s / cc).atan().to_degrees().copysign(self.z);
        let n = (cc * cc + s * s).sqrt();
        // Along the normal: well conditioned at the poles as at the equator.
        let height = (p * cc + self.z.abs() * s - A * ONE_LESS_F * (s * s + c * c).sqrt()) / n;
        Geodetic { latitude, longitude, height }
    }
}

/// Exact at multiples of 90 degrees, full precision elsewhere.
pub(super) fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turned = if degrees.abs() <= 360.0 { degrees } else { degrees % 360.0 };
    let quarter = (turned * (1.0 / 90.0) + 0.5f64.copysign(turned)) as i32;
    // No rounding: both are multiples of the smaller one's last place.
    let (s, c) = (turned - 90.0 * f64::from(quarter)).to_radians().sin_cos();
    match quarter & 3 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// `echo "LAT LON H" | CartConvert -p 9` (GeographicLib 2.1.2).
    const GEOGRAPHICLIB: &str = include_str!("../../tests/data/cartconvert.txt");

    #[test]
    fn agrees_with_geographiclib() {
        let mut rows = 0;
        for line in GEOGRAPHICLIB.lines().filter(|l| !l.starts_with('#')) {
            let v: Vec<f64> = line.split_whitespace().map(|t| t.parse().unwrap()).collect();
            let e = Geodetic { latitude: v[0], longitude: v[1], height: v[2] }.to_ecef();
            for (ours, theirs) in [(e.x, v[3]), (e.y, v[4]), (e.z, v[5])] {
                assert!((ours - theirs).abs() < 1e-8, "{line}: {ours} against {theirs}");
            }
            let g = Ecef { x: v[3], y: v[4], z: v[5] }.to_geodetic().to_ecef();
            let off = (g.x - v[3]).hypot(g.y - v[4]).hypot(g.z - v[5]);
            assert!(off < 1e-8, "{line}: {off} m off after a round trip");
            rows += 1;
        }
        assert!(rows > 40);
    }

    /// The last place of an f64 is 0.9 nm for a coordinate near 7,000 km and 3 nm for a longitude of 150 degrees: a
    /// rounding or two of each is what a way there and back costs.
    fn there_and_back(lat: f64, lon: f64, h: f64) {
        let e = Geodetic { latitude: lat, longitude: lon, height: h }.to_ecef();
        let b = e.to_geodetic().to_ecef();
        let off = (e.x - b.x).hypot(e.y - b.y).hypot(e.z - b.z);
        assert!(off < 6e-9, "{lat} {lon} {h}: {off}");
    }

    proptest! {
        #[test]
        fn round_trip(lat in -90.0..=90.0f64, lon in -180.0..=180.0f64, h in -10_000.0..1_000_000.0f64) {
            there_and_back(lat, lon, h);
        }

        #[test]
        fn round_trip_at_the_poles_and_the_antimeridian(off in -1e-7..1e-7f64, lon in -180.0..=180.0f64, h in -10_000.0..1_000_000.0f64) {
            there_and_back(90.0 - off.abs(), lon, h);
            there_and_back(-90.0 + off.abs(), lon, h);
            there_and_back(off, 180.0 - off.abs(), h);
            there_and_back(lon / 2.0, -180.0, h);
        }

        #[test]
        fn antipodes_are_opposite(lat in -90.0..=90.0f64, lon in -180.0..=0.0f64, h in -10_000.0..1_000_000.0f64) {
            let here = Geodetic { latitude: lat, longitude: lon, height: h }.to_ecef();
            let there = Geodetic { latitude: -lat, longitude: lon + 180.0, height: h }.to_ecef();
            prop_assert!((here.x + there.x).hypot(here.y + there.y).hypot(here.z + there.z) < 6e-9);
        }

        #[test]
        fn local_frame_is_isometric(lat in -89.9..89.9f64, lon in -180.0..180.0f64, e in -500.0..500.0f64, n in -500.0..500.0f64, u in -50.0..50.0f64) {
            let origin = Geodetic { latitude: lat, longitude: lon, height: 100.0 };
            let there = origin.offset(Enu { east: e, north: n, up: u });
            let back = origin.local(there.to_ecef());
            prop_assert!((back.east - e).abs() < 2e-8 && (back.north - n).abs() < 2e-8 && (back.up - u).abs() < 2e-8);
        }
    }
}
