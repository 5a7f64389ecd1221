//! Where and when a photo was taken: EXIF's GPS directory (EXIF 3.0, section 4.6.6).

use exif::{Exif as Tags, In, Tag, Value};

use super::metadata::real;

/// What a written altitude is above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AltitudeAbove {
    /// EXIF's references 0 and 1, and where nothing is said.
    Sea,
    /// EXIF 3.0's references 2 and 3.
    Ellipsoid,
}

/// The camera's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// Degrees, WGS84.
    pub latitude: f64,
    pub longitude: f64,
    /// Metres.
    pub altitude: Option<f64>,
    pub altitude_above: AltitudeAbove,
    /// Horizontal and vertical error as the camera wrote it, metres.
    pub accuracy: Option<f64>,
    pub vertical_accuracy: Option<f64>,
}

impl Position {
    /// A point of the Earth, and not the 0, 0 that cameras without a fix write.
    pub(super) fn sound(self) -> Option<Position> {
        let on_earth = (-90.0..=90.0).contains(&self.latitude) && (-180.0..=180.0).contains(&self.longitude);
        let null_island = self.latitude == 0.0 && self.longitude == 0.0;
        let altitude = self.altitude.filter(|a| (-12_000.0..=100_000.0).contains(a));
        let plausible = |m: Option<f64>| m.filter(|m| m.is_finite() && (0.0..1e6).contains(m) && *m > 0.0);
        (on_earth && !null_island).then_some(Position {
            altitude,
            accuracy: plausible(self.accuracy),
            vertical_accuracy: plausible(self.vertical_accuracy),
            ..self
        })
    }
}

/// The position; `None` where it is missing, damaged, void by its status, or on another datum than WGS84.
pub(super) fn position(tags: &Tags) -> Option<Position> {
    let text = |tag| text(tags, tag);
    if text(Tag::GPSStatus).is_some_and(|s| s.starts_with('V')) || foreign_datum(tags).is_some() {
        return None;
    }
    let angle = |tag, reference, negative| {
        let sign = if text(reference)?.to_ascii_uppercase().starts_with(negative) { -1.0 } else { 1.0 };
        degrees(&tags.get_field(tag, In::PRIMARY)?.value).map(|d| sign * d)
    };
    let number = |tag| tags.get_field(tag, In::PRIMARY).and_then(|f| real(&f.value));
    let reference = tags.get_field(Tag::GPSAltitudeRef, In::PRIMARY).and_then(|f| match &f.value {
        Value::Byte(b) => b.first().copied(),
        // Some writers use a letter or a short.
        other => other.get_uint(0).map(|v| v as u8),
    });
    let (sign, altitude_above) = altitude_reference(reference.unwrap_or(0));
    let position = Position {
        latitude: angle(Tag::GPSLatitude, Tag::GPSLatitudeRef, 'S')?,
        longitude: angle(Tag::GPSLongitude, Tag::GPSLongitudeRef, 'W')?,
        altitude: number(Tag::GPSAltitude).map(|a| sign * a),
        altitude_above,
        accuracy: number(Tag::GPSHPositioningError),
        vertical_accuracy: None,
    };
    position.sound()
}

/// 0 above the sea, 1 below it, 2 above the ellipsoid, 3 below it.
pub(super) fn altitude_reference(code: u8) -> (f64, AltitudeAbove) {
    let above = if (2..=3).contains(&code) { AltitudeAbove::Ellipsoid } else { AltitudeAbove::Sea };
    (if code == 1 || code == 3 { -1.0 } else { 1.0 }, above)
}

/// The datum's name where it is neither WGS84 nor empty.
pub(super) fn foreign_datum(tags: &Tags) -> Option<String> {
    let datum = text(tags, Tag::GPSMapDatum)?;
    let bare: String = datum.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_uppercase();
    (!bare.is_empty() && !bare.starts_with("WGS84") && bare != "UNKNOWN").then_some(datum)
}

/// Year, month, day: of the satellites, else of the camera's clock.
pub(super) fn date(tags: &Tags) -> Option<(i64, i64, i64)> {
    let parse = |stamp: String| {
        let mut parts = stamp.split([':', '-', ' ']).map(|p| p.parse::<i64>().ok());
        Some((parts.next()??, parts.next()??, parts.next()??))
    };
    let sound =
        |&(y, m, d): &(i64, i64, i64)| (1990..2200).contains(&y) && (1..=12).contains(&m) && (1..=31).contains(&d);
    [Tag::GPSDateStamp, Tag::DateTimeOriginal, Tag::DateTime]
        .into_iter()
        .find_map(|tag| text(tags, tag).and_then(parse).filter(sound))
}

fn text(tags: &Tags, tag: Tag) -> Option<String> {
    match &tags.get_field(tag, In::PRIMARY)?.value {
        Value::Ascii(lines) => {
            let line = String::from_utf8_lossy(lines.first()?).trim_matches(['\0', ' ']).to_owned();
            (!line.is_empty()).then_some(line)
        }
        _ => None,
    }
}

/// One to three rationals: degrees, minutes, seconds.
fn degrees(value: &Value) -> Option<f64> {
    let Value::Rational(parts) = value else { return None };
    let mut sum = 0.0;
    for (i, part) in parts.iter().take(3).enumerate() {
        let v = part.to_f64();
        // 0/0 seconds after sound degrees and minutes are common, and mean none.
        if !v.is_finite() {
            return if i > 0 { Some(sum) } else { None };
        }
        if i > 0 && v >= 60.0 + 1e-9 {
            return None;
        }
        sum += v / 60f64.powi(i as i32);
    }
    (!parts.is_empty()).then_some(sum)
}

#[cfg(test)]
mod tests {
    use super::super::metadata::read;
    use super::super::tests::exif_block;
    use super::*;
    use exif::Rational;

    fn ratio(parts: &[(u32, u32)]) -> Value {
        Value::Rational(parts.iter().map(|&(num, denom)| Rational { num, denom }).collect())
    }

    fn ascii(text: &str) -> Value {
        Value::Ascii(vec![text.into()])
    }

    fn fix() -> Vec<(Tag, Value)> {
        vec![
            (Tag::GPSLatitudeRef, ascii("N")),
            (Tag::GPSLatitude, ratio(&[(34, 1), (33, 1), (828, 100)])),
            (Tag::GPSLongitudeRef, ascii("W")),
            (Tag::GPSLongitude, ratio(&[(118, 1), (28, 1), (1632, 100)])),
        ]
    }

    fn of(tags: &[(Tag, Value)]) -> Option<Position> {
        read(exif_block(tags)).0.position
    }

    #[test]
    fn hemispheres_and_spellings_of_degrees() {
        for (ns, ew, lat, lon) in
            [("N", "E", 1.0, 1.0), ("S", "E", -1.0, 1.0), ("S", "W", -1.0, -1.0), ("n", "w", 1.0, -1.0)]
        {
            let mut tags = fix();
            (tags[0].1, tags[2].1) = (ascii(ns), ascii(ew));
            let p = of(&tags).unwrap();
            assert!((p.latitude - lat * 34.5523).abs() < 1e-9 && (p.longitude - lon * 118.4712).abs() < 1e-9);
        }
        let mut tags = fix();
        tags[1].1 = ratio(&[(345_523, 10_000)]);
        tags[3].1 = ratio(&[(118, 1), (28_272, 1000), (0, 0)]);
        let p = of(&tags).unwrap();
        assert!((p.latitude - 34.5523).abs() < 1e-9 && (p.longitude + 118.4712).abs() < 1e-9);
    }

    #[test]
    fn altitudes_by_reference() {
        for (reference, altitude, above) in [
            (None, 740.0, AltitudeAbove::Sea),
            (Some(0), 740.0, AltitudeAbove::Sea),
            (Some(1), -740.0, AltitudeAbove::Sea),
            (Some(2), 740.0, AltitudeAbove::Ellipsoid),
            (Some(3), -740.0, AltitudeAbove::Ellipsoid),
        ] {
            let mut tags = fix();
            tags.push((Tag::GPSAltitude, ratio(&[(7400, 10)])));
            tags.extend(reference.map(|r| (Tag::GPSAltitudeRef, Value::Byte(vec![r]))));
            let p = of(&tags).unwrap();
            assert_eq!((p.altitude, p.altitude_above), (Some(altitude), above));
        }
        assert_eq!(of(&fix()).unwrap().altitude, None);
    }

    #[test]
    fn accuracy_distance_and_date() {
        let mut tags = fix();
        tags.push((Tag::GPSHPositioningError, ratio(&[(47, 10)])));
        tags.push((Tag::SubjectDistance, ratio(&[(62, 10)])));
        tags.push((Tag::DateTimeOriginal, ascii("2026:03:04 05:06:07")));
        let exif = read(exif_block(&tags)).0;
        assert_eq!(exif.position.unwrap().accuracy, Some(4.7));
        assert_eq!(exif.subject_distance, Some(6.2));
        assert_eq!(exif.date, Some((2026, 3, 4)));
        tags.push((Tag::GPSDateStamp, ascii("2026:03:05")));
        assert_eq!(read(exif_block(&tags)).0.date, Some((2026, 3, 5)));
    }

    #[test]
    fn what_is_no_position() {
        let with = |tag, value| {
            let mut tags = fix();
            tags.retain(|(t, _)| *t != tag);
            tags.push((tag, value));
            of(&tags)
        };
        assert!(with(Tag::GPSStatus, ascii("A")).is_some());
        assert!(with(Tag::GPSMapDatum, ascii("WGS-84")).is_some());
        assert_eq!(with(Tag::GPSStatus, ascii("V")), None);
        assert_eq!(with(Tag::GPSMapDatum, ascii("TOKYO")), None);
        assert_eq!(with(Tag::GPSLatitude, ratio(&[(91, 1)])), None);
        assert_eq!(with(Tag::GPSLatitude, ratio(&[(0, 0), (0, 0), (0, 0)])), None);
        assert_eq!(with(Tag::GPSLatitude, ratio(&[(34, 1), (61, 1)])), None);
        assert_eq!(with(Tag::GPSLatitude, ratio(&[])), None);
        let mut null = fix();
        (null[1].1, null[3].1) = (ratio(&[(0, 1)]), ratio(&[(0, 1)]));
        assert_eq!(of(&null), None);
        assert_eq!(of(&fix()[..3]), None);
    }
}
