//! Where a subject stands on the Earth and which way it looks, and how well both are known.

use super::{Ecef, Enu, Geodetic};

/// Where the heading came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeadingSource {
    Given,
    ExifTrue,
    /// The camera wrote a magnetic bearing; the World Magnetic Model made it a true one.
    ExifMagnetic,
    /// A drone's gimbal, from XMP.
    Gimbal,
    /// Several cameras' positions on the Earth, or ground control points.
    Georegistration,
    /// Nothing known: 0.
    Assumed,
}

impl HeadingSource {
    pub fn label(self) -> &'static str {
        match self {
            HeadingSource::Given => "given",
            HeadingSource::ExifTrue => "exif-true-north",
            HeadingSource::ExifMagnetic => "exif-magnetic-wmm2025",
            HeadingSource::Gimbal => "gimbal",
            HeadingSource::Georegistration => "georegistration",
            HeadingSource::Assumed => "assumed",
        }
    }
}

/// The subject frame on the Earth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The ground point under the subject; height above the ellipsoid.
    pub origin: Geodetic,
    /// Bearing of the subject frame's +Y, degrees clockwise from true north, [0, 360).
    pub heading: f64,
    pub heading_source: HeadingSource,
}

/// One standard deviation of each.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Uncertainty {
    /// Metres, along any horizontal direction.
    pub horizontal: f64,
    /// Metres.
    pub vertical: f64,
    /// Degrees.
    pub heading: f64,
    /// Relative.
    pub scale: f64,
}

impl Uncertainty {
    /// Of a point of the model that lies `across` metres from its origin on the ground and `up` above it: the origin's
    /// own, and what heading and scale move it by.
    pub fn at(&self, across: f64, up: f64) -> (f64, f64) {
        let turned = across * self.heading.to_radians().min(1.0);
        (self.horizontal.hypot(turned).hypot(across * self.scale), self.vertical.hypot(up * self.scale))
    }
}

impl Placement {
    /// Subject frame (metres) → east, north, up of the origin:
    /// east = x·cos h + y·sin h, north = −x·sin h + y·cos h, up = z.
    pub fn to_enu(&self, point: [f64; 3]) -> Enu {
        let (sin, cos) = self.heading.to_radians().sin_cos();
        let [x, y, z] = point;
        Enu { east: x * cos + y * sin, north: -x * sin + y * cos, up: z }
    }

    /// Subject frame (metres) → earth-centred, earth-fixed.
    pub fn to_ecef(&self, point: [f64; 3]) -> Ecef {
        self.origin.frame().to_ecef(self.to_enu(point))
    }

    /// Subject frame (metres) → latitude, longitude, height above the ellipsoid.
    pub fn to_geodetic(&self, point: [f64; 3]) -> Geodetic {
        self.origin.offset(self.to_enu(point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heading_turns_clockwise_from_north() {
        let at = |heading| Placement {
            origin: Geodetic { latitude: 34.5, longitude: -118.5, height: 740.0 },
            heading,
            heading_source: HeadingSource::Given,
        };
        let front = at(90.0).to_enu([0.0, 2.0, 0.0]);
        assert!((front.east - 2.0).abs() < 1e-12 && front.north.abs() < 1e-12);
        let right = at(0.0).to_enu([1.0, 0.0, 0.0]);
        assert!((right.east - 1.0).abs() < 1e-12 && right.north.abs() < 1e-12);
        let p = at(200.0);
        let e = p.to_ecef([1.0, 2.0, 3.0]);
        let back = p.origin.local(e);
        let want = p.to_enu([1.0, 2.0, 3.0]);
        assert!((back.east - want.east).abs() < 1e-8 && (back.up - want.up).abs() < 1e-8);
    }

    #[test]
    fn deviations_of_a_corner() {
        let u = Uncertainty { horizontal: 3.0, vertical: 4.0, heading: 0.0, scale: 0.1 };
        assert_eq!(u.at(0.0, 0.0), (3.0, 4.0));
        let (h, v) = u.at(40.0, 30.0);
        assert!((h - 5.0).abs() < 1e-12 && (v - 5.0).abs() < 1e-12);
        let turned = Uncertainty { horizontal: 0.0, heading: 1.0, ..Default::default() };
        assert!((turned.at(100.0, 0.0).0 - 1.745).abs() < 1e-3);
    }
}
