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
        self.frame().to_ecef(local).to_geodetic()
    }

    /// `point` in the frame of `self`.
    pub fn local(self, point: Ecef) -> Enu {
        self.frame().to_enu(point)
    }

    /// East, north, up of `self`, for more points than one.
    pub fn frame(self) -> LocalFrame {
        LocalFrame { origin: self.to_ecef(), axes: self.axes() }
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

/// East, north and up of a point in the earth-centred frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalFrame {
    origin: Ecef,
    axes: [[f64; 3]; 3],
}

impl LocalFrame {
    pub fn to_ecef(&self, local: Enu) -> Ecef {
        let ([e, n, u], o) = (&self.axes, &self.origin);
        let d = |i: usize| e[i] * local.east + n[i] * local.north + u[i] * local.up;
        Ecef { x: o.x + d(0), y: o.y + d(1), z: o.z + d(2) }
    }

    pub fn to_enu(&self, point: Ecef) -> Enu {
        let d = [point.x - self.origin.x, point.y - self.origin.y, point.z - self.origin.z];
        let dot = |a: &[f64; 3]| a[0] * d[0] + a[1] * d[1] + a[2] * d[2];
        Enu { east: dot(&self.axes[0]), north: dot(&self.axes[1]), up: dot(&self.axes[2]) }
    }
}

impl Ecef {
    /// Fukushima, "Transformation from Cartesian to geodetic coordinates accelerated by Halley's method", J. Geodesy 79
    /// (2006), eq. 12-26, two steps: from 5,000 km below the surface outwards the error is rounding alone.
    /// The longitude of a point on the axis is 0.
    pub fn to_geodetic(self) -> Geodetic {
        let p = (self.x * self.x + self.y * self.y).sqrt();
        let longitude = atan2_degrees(self.y, self.x);
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
        let latitude = atan2_degrees(s, cc).copysign(self.z);
        let n = (cc * cc + s * s).sqrt();
        // Along the normal: well conditioned at the poles as at the equator.
        let height = (p * cc + self.z.abs() * s - A * ONE_LESS_F * (s * s + c * c).sqrt()) / n;
        Geodetic { latitude, longitude, height }
    }
}

/// One rounding at most in the last place of the result: the arc tangent is taken below 45 degrees only.
pub(super) fn atan2_degrees(y: f64, x: f64) -> f64 {
    if y.abs() > x.abs() {
        90f64.copysign(y) - (x / y).atan().to_degrees()
    } else {
        let t = (y / x).atan().to_degrees();
        if x >= 0.0 { t } else { 180f64.copysign(y) + t }
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

    /// Over the whole Earth the mean cost of a way there and back is a last place, 1e-9 m.
    #[test]
    fn mean_of_round_trips() {
        let (mut squares, mut worst, n) = (0.0, 0f64, 200);
        for i in 0..n {
            for j in 0..n {
                let latitude = (2.0 * (f64::from(i) + 0.37) / f64::from(n) - 1.0).asin().to_degrees();
                let longitude = 360.0 * (f64::from(j) + 0.61) / f64::from(n) - 180.0;
                let e = Geodetic { latitude, longitude, height: f64::from((i * j) % 9_973) }.to_ecef();
                let b = e.to_geodetic().to_ecef();
                let off = (e.x - b.x).hypot(e.y - b.y).hypot(e.z - b.z);
                squares += off * off;
                worst = worst.max(off);
            }
        }
        let mean = (squares / f64::from(n * n)).sqrt();
        assert!(mean < 1.2e-9 && worst < 5e-9, "{mean} {worst}");
    }

    #[test]
    fn arc_tangents_in_every_octant() {
        for i in 0..=720 {
            let degrees = f64::from(i) / 2.0 - 180.0;
            let (s, c) = sin_cos_degrees(degrees);
            let off = (atan2_degrees(s, c) - degrees).abs();
            assert!(off < 3e-14 || (off - 360.0).abs() < 3e-14, "{degrees}: {off}");
        }
        let exact = [(0.0, 1.0, 0.0), (1.0, 0.0, 90.0), (0.0, -1.0, 180.0), (-0.0, -1.0, -180.0), (-1.0, 0.0, -90.0)];
        for (y, x, degrees) in exact {
            assert_eq!(atan2_degrees(y, x), degrees);
        }
        assert!(atan2_degrees(-0.0, 1.0).is_sign_negative());
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
            prop_assert!((back.east - e).abs() < 6e-9 && (back.north - n).abs() < 6e-9 && (back.up - u).abs() < 6e-9);
        }

        /// A nanometre is the last place of an earth-centred coordinate.
        #[test]
        fn local_there_and_back_within_a_nanometre(lat in -90.0..=90.0f64, lon in -180.0..=180.0f64, h in -10_000.0..1_000_000.0f64, e in -5e3..5e3f64, n in -5e3..5e3f64, u in -1e3..1e3f64) {
            let frame = Geodetic { latitude: lat, longitude: lon, height: h }.frame();
            let back = frame.to_enu(frame.to_ecef(Enu { east: e, north: n, up: u }));
            prop_assert!((back.east - e).hypot(back.north - n).hypot(back.up - u) < 1e-9);
        }
    }
}
