//! The header record (opcode 1, 324 bytes in revision 16.0).

use super::record::{Record, Writer, opcode};
use super::{FORMAT, Model};
use crate::{Error, Result};

/// Format revision level of OpenFlight 16.0.
pub const REVISION: i32 = 1600;
/// Record length in revision 16.0; earlier revisions end sooner.
pub const LENGTH: usize = 324;

/// The fields of a header that vary between files.
#[derive(Clone, Debug, PartialEq)]
pub struct Header {
    pub date: String,
    /// The next free number for groups, levels of detail, objects and faces.
    pub next_ids: [i16; 4],
    /// The next free number for meshes.
    pub next_mesh: u16,
    /// South-west corner of the geometry, metres.
    pub southwest: [f64; 2],
    /// South-west and north-east corners (latitude, longitude), degrees.
    pub corners: [(f64, f64); 2],
    /// Latitude and longitude of the coordinates' origin, degrees.
    pub origin: (f64, f64),
    /// Distance from the origin to the farthest vertex, metres.
    pub radius: f64,
}

/// The free ID after those that are used.
pub fn next(used: usize) -> i16 {
    i16::try_from(used + 1).unwrap_or(i16::MAX)
}

impl Header {
    /// The header that describes a model: free IDs after those the writer hands out, extents of its geometry.
    /// `faces` is the number of face records.
    pub fn of(model: &Model, faces: usize) -> Self {
        let bounds = model.levels.iter().filter_map(|l| l.mesh.bounds()).reduce(union).unwrap_or_default();
        let farthest =
            model.levels.iter().flat_map(|l| &l.mesh.positions).map(|p| p.iter().map(|x| x * x).sum::<f64>());
        let levels = model.levels.len();
        Self {
            next_ids: [1 + model.points.len(), levels, levels, faces].map(next),
            radius: farthest.fold(0.0, f64::max).sqrt(),
            ..Self::around(&model.date, model.origin, bounds)
        }
    }

    /// The header of a file around a box; free IDs and the radius are not filled in.
    pub fn around(date: &str, origin: Option<(f64, f64)>, (lo, hi): ([f64; 3], [f64; 3])) -> Self {
        Self {
            date: date.into(),
            next_ids: [1; 4],
            next_mesh: 1,
            southwest: [lo[0], lo[1]],
            corners: origin.map(|at| geographic_corners(at, lo, hi)).unwrap_or_default(),
            origin: origin.unwrap_or_default(),
            radius: 0.0,
        }
    }

    /// The same for a model of meshes, one a level.
    pub fn of_meshes(model: &Model) -> Self {
        Self { next_mesh: u16::try_from(model.levels.len() + 1).unwrap_or(u16::MAX), ..Self::of(model, 0) }
    }

    pub fn write(&self, out: &mut Writer) {
        out.begin(opcode::HEADER);
        out.text("db", 8);
        out.i32(REVISION);
        out.i32(0); // edit revision
        out.text(&self.date, 32);
        self.next_ids.iter().for_each(|&id| out.i16(id));
        out.i16(1); // unit multiplier
        out.u8(0); // metres
        out.u8(0); // new faces are not drawn white
        out.u32(0x8000_0000); // vertex normals are saved
        out.zeros(24);
        out.i32(0); // flat earth
        out.zeros(28);
        out.i16(1); // next degree-of-freedom ID
        out.i16(1); // vertices in double precision
        out.i32(100); // database origin: OpenFlight
        out.f64s(&self.southwest);
        out.f64s(&[0.0, 0.0]); // offset to place the database
        out.i16(1); // next sound ID
        out.i16(1); // next path ID
        out.zeros(8);
        (0..4).for_each(|_| out.i16(1)); // next clip, text, separating plane and switch IDs
        out.zeros(4);
        for (latitude, longitude) in [self.corners[0], self.corners[1], self.origin] {
            out.f64s(&[latitude, longitude]);
        }
        out.f64s(&[0.0, 0.0]); // Lambert latitudes
        (0..4).for_each(|_| out.i16(1)); // next light source, light point, road and terrain IDs
        out.zeros(8);
        out.i32(0); // WGS 84
        out.i16(1); // next adaptive ID
        out.i16(1); // next curve ID
        out.i16(0); // no UTM zone
        out.zeros(6);
        out.f64s(&[0.0, self.radius]); // vertical offset, radius
        out.u16(self.next_mesh);
        out.u16(1); // next light point system ID
        out.zeros(4);
        out.f64s(&[0.0, 0.0]); // axes of a user-defined ellipsoid
        out.end();
    }
}

/// What the reader takes from a header.
pub struct Read {
    pub date: String,
    pub origin: Option<(f64, f64)>,
    /// Metres in one vertex coordinate unit.
    pub metres: f64,
}

/// Reads a header of any revision; fields past its end have their defaults.
pub fn read(record: &Record) -> Result<Read> {
    let unit = record.bytes.get(62).copied().unwrap_or(0);
    let metres = match unit {
        0 => 1.0,
        1 => 1000.0,
        4 => 0.3048,
        5 => 0.0254,
        8 => 1852.0,
        other => {
            return Err(Error::Malformed {
                format: FORMAT,
                offset: record.offset as u64 + 62,
                expected: "coordinate units 0 (m), 1 (km), 4 (ft), 5 (in) or 8 (nautical miles)".into(),
                found: other.to_string(),
            });
        }
    };
    let field = |index: usize| record.f64(188 + index * 8).unwrap_or(0.0);
    // A file without georeference has zeros here; a real origin at 0, 0 shows in its corners.
    let georeferenced = (0..6).any(|i| field(i) != 0.0);
    let origin = georeferenced.then(|| (field(4), field(5)));
    Ok(Read { date: record.text(20, 32), origin, metres })
}

/// The union of two boxes (min, max).
pub fn union(a: ([f64; 3], [f64; 3]), b: ([f64; 3], [f64; 3])) -> ([f64; 3], [f64; 3]) {
    (std::array::from_fn(|i| a.0[i].min(b.0[i])), std::array::from_fn(|i| a.1[i].max(b.1[i])))
}

/// South-west and north-east corners of a box about an origin on WGS 84, degrees.
///
/// First-order: a metre is 1/M of latitude and 1/(N cos φ) of longitude, with the meridional and prime-vertical radii
/// M = a(1−e²)/(1−e² sin²φ)^1.5 and N = a/√(1−e² sin²φ) (Snyder, "Map Projections: A Working Manual", Eq. 4-18, 4-20).
fn geographic_corners(origin: (f64, f64), lo: [f64; 3], hi: [f64; 3]) -> [(f64, f64); 2] {
    const A: f64 = 6_378_137.0;
    const E2: f64 = 0.006_694_379_990_14;
    let (sin, cos) = origin.0.to_radians().sin_cos();
    let w = 1.0 - E2 * sin * sin;
    let meridional = A * (1.0 - E2) / w.powf(1.5);
    let parallel = A / w.sqrt() * cos;
    // Around a pole a metre spans any longitude: the box then covers all of them.
    let everywhere = parallel < 1.0 || ((hi[0] - lo[0]) / parallel).to_degrees() >= 360.0;
    let latitude = |y: f64| (origin.0 + (y / meridional).to_degrees()).clamp(-90.0, 90.0);
    let longitude = |x: f64, all: f64| {
        let l = origin.1 + (x / parallel).to_degrees();
        if everywhere {
            all
        } else if (-180.0..=180.0).contains(&l) {
            l
        } else {
            (l + 180.0).rem_euclid(360.0) - 180.0
        }
    };
    [(latitude(lo[1]), longitude(lo[0], -180.0)), (latitude(hi[1]), longitude(hi[0], 180.0))]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_follow_the_ellipsoid() {
        // A degree of latitude is 110,574 m at the equator and 111,694 m at the poles; one of longitude is 111,320 m at
        // the equator (published lengths of a degree on WGS 84, to the metre).
        let [sw, ne] = geographic_corners((0.0, 0.0), [-111_320.0, -110_574.0, 0.0], [0.0, 0.0, 0.0]);
        assert!((sw.0 + 1.0).abs() < 1e-5 && (sw.1 + 1.0).abs() < 1e-5, "{sw:?}");
        assert_eq!(ne, (0.0, 0.0));
        let [_, ne] = geographic_corners((89.0, 0.0), [0.0; 3], [0.0, 55_847.0, 0.0]);
        assert!((ne.0 - 89.5).abs() < 1e-5, "{ne:?}");
    }

    #[test]
    fn corners_wrap_at_the_date_line_and_cover_the_pole() {
        let [sw, ne] = geographic_corners((0.0, 180.0), [-10.0, -10.0, 0.0], [10.0, 10.0, 0.0]);
        assert!(sw.1 > 179.9 && ne.1 < -179.9, "{sw:?} {ne:?}");
        let [sw, ne] = geographic_corners((90.0, 0.0), [-10.0, -10.0, 0.0], [10.0, 10.0, 0.0]);
        assert_eq!((sw.1, ne.0, ne.1), (-180.0, 90.0, 180.0));
    }
}
