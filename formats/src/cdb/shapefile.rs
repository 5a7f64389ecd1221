//! Point shapefiles (`.shp`, `.shx`), to the byte.
//!
//! Source: "ESRI Shapefile Technical Description", July 1998: main file header, PointZ record, index file. CDB uses one
//! PointZ a feature: x longitude, y latitude, z height.

use crate::{Error, Result};

const FORMAT: &str = "shapefile";
const HEADER: usize = 100;
const POINT: i32 = 1;
const POINT_Z: i32 = 11;
/// A PointZ record's content: type, x, y, z, m.
const CONTENT: usize = 36;
/// A measure below −1e38 means "none".
pub const NO_MEASURE: f64 = -1e39;

/// A PointZ: degrees, metres, measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointZ {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub m: f64,
}

/// Writes the `.shp` and the `.shx`; `None` is a null shape (a record of the table without a place).
pub fn write(points: &[Option<PointZ>]) -> (Vec<u8>, Vec<u8>) {
    let record = |p: &Option<PointZ>| 8 + if p.is_some() { CONTENT } else { 4 };
    let length = HEADER + points.iter().map(record).sum::<usize>();
    let mut shp = header(points, length);
    let mut shx = header(points, HEADER + 8 * points.len());
    for (i, point) in points.iter().enumerate() {
        let content = (record(point) - 8) as i32 / 2;
        shx.extend(((shp.len() / 2) as i32).to_be_bytes());
        shx.extend(content.to_be_bytes());
        shp.extend((i as i32 + 1).to_be_bytes());
        shp.extend(content.to_be_bytes());
        match point {
            None => shp.extend(0i32.to_le_bytes()),
            Some(p) => {
                shp.extend(POINT_Z.to_le_bytes());
                shp.extend([p.x, p.y, p.z, p.m].iter().flat_map(|v| v.to_le_bytes()));
            }
        }
    }
    (shp, shx)
}

/// Reads a `.shp` of points; a Point without height gets height 0 and no measure.
///
/// # Errors
/// [`Error::Malformed`] for cut or inconsistent bytes, [`Error::Unsupported`] for another shape type.
pub fn read(shp: &[u8]) -> Result<Vec<Option<PointZ>>> {
    let shape = le(shp, 32)?;
    if be(shp, 0)? != 9994 {
        return malformed(0, "file code 9994", be(shp, 0)?);
    }
    if shape != POINT_Z && shape != POINT {
        return Err(Error::Unsupported {
            format: FORMAT,
            what: format!("shape type {shape} cannot be kept beside models: expected 11 (PointZ) or 1 (Point)"),
        });
    }
    let end = 2 * i64::from(be(shp, 24)?);
    if end != shp.len() as i64 {
        return malformed(24, "the file's length in 16-bit words", format!("{end} bytes in a file of {}", shp.len()));
    }
    let (mut points, mut at) = (Vec::new(), HEADER);
    while at < shp.len() {
        let number = be(shp, at)?;
        if i64::from(number) != points.len() as i64 + 1 {
            return malformed(at, &format!("record number {}", points.len() + 1), number);
        }
        let words = be(shp, at + 4)?;
        let kind = le(shp, at + 8)?;
        let float = |i: usize| double(shp, at + 12 + 8 * i);
        points.push(match (kind, words) {
            (0, 2) => None,
            (POINT, 10) => Some(PointZ { x: float(0)?, y: float(1)?, z: 0.0, m: NO_MEASURE }),
            // Writers may leave the measure out.
            (POINT_Z, 14) => Some(PointZ { x: float(0)?, y: float(1)?, z: float(2)?, m: NO_MEASURE }),
            (POINT_Z, 18) => Some(PointZ { x: float(0)?, y: float(1)?, z: float(2)?, m: float(3)? }),
            _ => return malformed(at + 8, "a point record", format!("shape type {kind} of {words} words")),
        });
        at += 8 + 2 * words as usize;
    }
    Ok(points)
}

fn header(points: &[Option<PointZ>], length: usize) -> Vec<u8> {
    let mut out = Vec::with_capacity(length);
    out.extend(9994i32.to_be_bytes());
    out.extend([0; 20]);
    out.extend(((length / 2) as i32).to_be_bytes());
    out.extend(1000i32.to_le_bytes());
    out.extend(POINT_Z.to_le_bytes());
    let range = |value: fn(&PointZ) -> f64| {
        let values = points.iter().flatten().map(value).filter(|v| *v >= -1e38);
        values.fold(None, |r: Option<(f64, f64)>, v| Some(r.map_or((v, v), |(lo, hi)| (lo.min(v), hi.max(v)))))
    };
    let (x, y) = (range(|p| p.x).unwrap_or_default(), range(|p| p.y).unwrap_or_default());
    let (z, m) = (range(|p| p.z).unwrap_or_default(), range(|p| p.m).unwrap_or_default());
    out.extend([x.0, y.0, x.1, y.1, z.0, z.1, m.0, m.1].iter().flat_map(|v| v.to_le_bytes()));
    out
}

fn bytes<const N: usize>(shp: &[u8], at: usize) -> Result<[u8; N]> {
    match shp.get(at..at + N) {
        Some(b) => Ok(std::array::from_fn(|i| b[i])),
        None => malformed(at, "more bytes", format!("the end of the file at {}", shp.len())),
    }
}

fn be(shp: &[u8], at: usize) -> Result<i32> {
    Ok(i32::from_be_bytes(bytes(shp, at)?))
}

fn le(shp: &[u8], at: usize) -> Result<i32> {
    Ok(i32::from_le_bytes(bytes(shp, at)?))
}

fn double(shp: &[u8], at: usize) -> Result<f64> {
    Ok(f64::from_le_bytes(bytes(shp, at)?))
}

fn malformed<T>(at: usize, expected: &str, found: impl ToString) -> Result<T> {
    Err(Error::Malformed { format: FORMAT, offset: at as u64, expected: expected.into(), found: found.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn an_empty_tile_is_two_headers_of_zero_bounds() {
        let (shp, shx) = write(&[]);
        assert_eq!((shp.len(), &shp), (100, &shx));
        assert_eq!(&shp[..4], [0, 0, 0x27, 0x0A]);
        assert_eq!(&shp[24..36], [0, 0, 0, 50, 0xE8, 3, 0, 0, 11, 0, 0, 0]);
        assert!(shp[36..].iter().all(|&b| b == 0));
        assert_eq!(read(&shp), Ok(vec![]));
    }

    #[test]
    fn the_index_points_at_the_records() {
        let p = PointZ { x: -118.4712, y: 34.5523, z: 740.0, m: 0.0 };
        let (shp, shx) = write(&[Some(p), None, Some(PointZ { x: 1.0, m: NO_MEASURE, ..p })]);
        assert_eq!((shp.len(), shx.len()), (100 + 44 + 12 + 44, 124));
        let word = |b: &[u8], at: usize| i32::from_be_bytes(b[at..at + 4].try_into().unwrap());
        assert_eq!((0..6).map(|i| word(&shx, 100 + 4 * i)).collect::<Vec<_>>(), [50, 18, 72, 2, 78, 18]);
        for (i, at) in [100usize, 144, 156].into_iter().enumerate() {
            assert_eq!(word(&shp, at), i as i32 + 1);
        }
        let bound = |i: usize| f64::from_le_bytes(shp[36 + 8 * i..44 + 8 * i].try_into().unwrap());
        assert_eq!((0..8).map(bound).collect::<Vec<_>>(), [-118.4712, 34.5523, 1.0, 34.5523, 740.0, 740.0, 0.0, 0.0]);
    }

    #[test]
    fn points_without_height_gain_height_zero() {
        let mut shp = write(&[]).0;
        shp[24..28].copy_from_slice(&64i32.to_be_bytes());
        shp[32] = 1;
        for v in [1i32, 10] {
            shp.extend(v.to_be_bytes());
        }
        shp.extend(1i32.to_le_bytes());
        shp.extend([7.5f64, -3.25].iter().flat_map(|v| v.to_le_bytes()));
        assert_eq!(read(&shp), Ok(vec![Some(PointZ { x: 7.5, y: -3.25, z: 0.0, m: NO_MEASURE })]));
    }

    #[test]
    fn other_shapes_and_broken_bytes_are_refused() {
        let p = PointZ { x: 1.0, y: 2.0, z: 3.0, m: 0.0 };
        let good = write(&[Some(p)]).0;
        let mut polygon = good.clone();
        polygon[32] = 15;
        assert!(matches!(read(&polygon), Err(Error::Unsupported { .. })));
        for end in 0..good.len() {
            assert!(matches!(read(&good[..end]), Err(Error::Malformed { .. })), "cut at {end}");
        }
        for (at, value) in [(0, 1), (27, 1), (103, 9), (107, 17), (108, 5), (104, 0xFF)] {
            let mut broken = good.clone();
            broken[at] = value;
            assert!(read(&broken).is_err(), "byte {at}");
        }
    }

    proptest! {
        #[test]
        fn what_is_written_reads_back(points in prop::collection::vec(
            prop::option::of((-180.0..180.0, -90.0..90.0, -500.0..9000.0, 0.0..1.0)), 0..40)) {
            let points: Vec<_> = points.into_iter().map(|p| p.map(|(x, y, z, m)| PointZ { x, y, z, m })).collect();
            prop_assert_eq!(read(&write(&points).0), Ok(points));
        }

        #[test]
        fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
            let mut shp = write(&[]).0;
            shp.extend(&bytes);
            let words = (shp.len() / 2) as i32;
            shp[24..28].copy_from_slice(&words.to_be_bytes());
            let _ = read(&shp);
            let _ = read(&bytes);
        }
    }
}
