//! Photos with every combination of the tags that place a model, as bytes, through the decoder.

use super::tests::{exif_block, jpeg_with, quarters};
use super::{AltitudeAbove, Limits, Photo, decode};
use ::exif::{Rational, Tag, Value};

fn ratio(num: u32, denom: u32) -> Value {
    Value::Rational(vec![Rational { num, denom }])
}

fn ascii(text: &str) -> Value {
    Value::Ascii(vec![text.into()])
}

/// A JPEG with these tags, and an XMP packet after them.
fn photo(tags: &[(Tag, Value)], xmp: Option<&str>) -> Photo {
    let mut bytes = jpeg_with(&exif_block(tags), &quarters(64, 64));
    if let Some(attributes) = xmp {
        let packet = format!(
            "http://ns.adobe.com/xap/1.0/\0<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/\
             22-rdf-syntax-ns#\"><rdf:Description xmlns:drone-dji=\"http://www.dji.com/drone-dji/1.0/\" {attributes}/></rdf:RDF>\
             </x:xmpmeta>"
        );
        let mut segment = vec![0xff, 0xe1];
        segment.extend((packet.len() as u16 + 2).to_be_bytes());
        segment.extend(packet.as_bytes());
        bytes.splice(2..2, segment);
    }
    decode("tags.jpg", &bytes, &Limits::default()).unwrap()
}

#[test]
fn every_combination() {
    const GIMBAL: &str =
        "drone-dji:GimbalYawDegree=\"+12.5\" drone-dji:GimbalPitchDegree=\"-30\" drone-dji:RelativeAltitude=\"+40\"";
    const RTK: &str = "drone-dji:RtkStdLat=\"0.02\" drone-dji:RtkStdLon=\"0.02\" drone-dji:RtkStdHgt=\"0.04\"";
    // One bit a group of tags: latitude, longitude, altitude, its reference, accuracy, direction, its reference, focal
    // length, date, gimbal, what the drone's receiver is good to, distance of the subject.
    for bits in 0u32..1 << 12 {
        let has = |bit: u32| bits >> bit & 1 == 1;
        let mut tags = vec![(Tag::Orientation, Value::Short(vec![1]))];
        let mut put = |bit: u32, more: Vec<(Tag, Value)>| {
            if has(bit) {
                tags.extend(more);
            }
        };
        put(0, vec![(Tag::GPSLatitudeRef, ascii("S")), (Tag::GPSLatitude, ratio(345, 10))]);
        put(1, vec![(Tag::GPSLongitudeRef, ascii("W")), (Tag::GPSLongitude, ratio(1184, 10))]);
        put(2, vec![(Tag::GPSAltitude, ratio(7405, 10))]);
        put(3, vec![(Tag::GPSAltitudeRef, Value::Byte(vec![3]))]);
        put(4, vec![(Tag::GPSHPositioningError, ratio(47, 10))]);
        put(5, vec![(Tag::GPSImgDirection, ratio(12345, 100))]);
        put(6, vec![(Tag::GPSImgDirectionRef, ascii("M"))]);
        put(7, vec![(Tag::FocalLengthIn35mmFilm, Value::Short(vec![26]))]);
        put(8, vec![(Tag::DateTimeOriginal, ascii("2026:03:04 05:06:07"))]);
        put(11, vec![(Tag::SubjectDistance, ratio(62, 10))]);
        let xmp = format!("{} {}", if has(9) { GIMBAL } else { "" }, if has(10) { RTK } else { "" });
        let exif = photo(&tags, (has(9) || has(10)).then_some(&xmp)).exif;

        assert_eq!(exif.position.is_some(), has(0) && has(1), "{bits:b}");
        if let Some(p) = exif.position {
            assert_eq!((p.latitude, p.longitude), (-34.5, -118.4));
            assert_eq!(p.altitude, has(2).then_some(if has(3) { -740.5 } else { 740.5 }));
            assert_eq!(p.altitude_above, if has(3) { AltitudeAbove::Ellipsoid } else { AltitudeAbove::Sea });
            // A drone's receiver knows its own accuracy best.
            let (across, up) = if has(10) { (Some(0.02), Some(0.04)) } else { (has(4).then_some(4.7), None) };
            assert_eq!((p.accuracy, p.vertical_accuracy), (across, up), "{bits:b}");
        }
        assert_eq!(exif.image_direction, has(5).then_some(123.45));
        assert_eq!(exif.direction_is_magnetic, has(5) && has(6));
        assert_eq!(exif.focal_35mm, has(7).then_some(26.0));
        assert_eq!(exif.date, has(8).then_some((2026, 3, 4)));
        assert_eq!(exif.subject_distance, has(11).then_some(6.2));
        let gimbal = exif.gimbal.map(|g| (g.yaw, g.pitch, g.above_takeoff));
        assert_eq!(gimbal, has(9).then_some((Some(12.5), Some(-30.0), Some(40.0))));
    }
}
