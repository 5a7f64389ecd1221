//! Where a subject stands on the Earth and which way it looks.

use super::{Ecef, Enu, Geodetic};

/// Where the heading came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeadingSource {
    Given,
    ExifTrue,
    /// The camera wrote a magnetic bearing; used uncorrected, with a warning.
    ExifMagnetic,
    /// Nothing known: 0.
    Assumed,
}

impl HeadingSource {
    pub fn label(self) -> &'static str {
        match self {
            HeadingSource::Given => "given",
            HeadingSource::ExifTrue => "exif-true-north",
            HeadingSource::ExifMagnetic => "exif-magnetic-uncorrected",
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
        self.origin.offset(self.to_enu(point)).to_ecef()
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
}
