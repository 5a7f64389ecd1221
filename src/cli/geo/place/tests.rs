use super::*;
use crate::photo::{Gimbal, Position};

fn wanted(origin: Option<&str>, origin_is: Option<OriginIs>, heading: Option<f64>) -> Wanted {
    Wanted {
        origin: origin.map(|t| geo::parse_point("--origin", t).unwrap()),
        origin_is,
        datum: None,
        accuracy: None,
        heading,
        terrain: None,
        known: vec![],
        camera_height: None,
        distance: None,
    }
}

/// Every combination of what a photo and the options can say; the rule for each is written out a second time here.
#[test]
fn every_combination_of_tags_and_options() {
    let positions = [None, Some(None), Some(Some(AltitudeAbove::Sea)), Some(Some(AltitudeAbove::Ellipsoid))];
    let mut seen = 0;
    for position in positions {
        let exif_position = position.map(|altitude| Position {
            latitude: 10.0,
            longitude: 20.0,
            altitude: altitude.map(|_| 300.0),
            altitude_above: altitude.unwrap_or(AltitudeAbove::Sea),
            accuracy: Some(4.7),
            vertical_accuracy: None,
        });
        for (direction, magnetic) in [(None, false), (Some(90.0), false), (Some(90.0), true)] {
            for yaw in [None, Some(200.0)] {
                for origin in [None, Some("34.5,-118.4,740"), Some("geo:34.5,-118.4,740;u=2")] {
                    for origin_is in [None, Some(OriginIs::Subject), Some(OriginIs::Camera)] {
                        for given in [None, Some(45.0)] {
                            let exif = Exif {
                                position: exif_position,
                                image_direction: direction,
                                direction_is_magnetic: magnetic,
                                gimbal: yaw.map(|y| Gimbal { yaw: Some(y), ..Default::default() }),
                                ..Default::default()
                            };
                            let w = wanted(origin, origin_is, given);
                            one_combination(&w, &exif, origin, yaw);
                            seen += 1;
                        }
                    }
                }
            }
        }
    }
    assert_eq!(seen, 4 * 3 * 2 * 3 * 3 * 2);
}

fn one_combination(w: &Wanted, exif: &Exif, origin: Option<&str>, yaw: Option<f64>) {
    let anchor = match (origin, &exif.position) {
        (None, None) => return assert!(w.anchor(exif).is_err_and(|e| e.found.contains("GPS"))),
        (None, Some(p)) if p.altitude.is_none() => {
            return assert!(w.anchor(exif).is_err_and(|e| e.found.contains("altitude")));
        }
        _ => w.anchor(exif).unwrap(),
    };
    match origin {
        Some(text) => {
            assert_eq!((anchor.latitude, anchor.height, anchor.datum), (34.5, Some(740.0), AltDatum::Ellipsoid));
            assert_eq!(anchor.is, w.origin_is.unwrap_or(OriginIs::Subject));
            assert_eq!(anchor.horizontal == 2.0, text.starts_with("geo:"));
        }
        None => {
            let datum = match exif.position.unwrap().altitude_above {
                AltitudeAbove::Sea => AltDatum::Msl,
                AltitudeAbove::Ellipsoid => AltDatum::Ellipsoid,
            };
            assert_eq!((anchor.latitude, anchor.height, anchor.datum), (10.0, Some(300.0), datum));
            assert_eq!((anchor.is, anchor.horizontal), (w.origin_is.unwrap_or(OriginIs::Camera), 4.7));
        }
    }
    let mut warnings = vec![];
    let h = heading(w, exif, &anchor, 2026.5, |axis| axis + 1.0, &mut warnings);
    let at = Geodetic { latitude: anchor.latitude, longitude: anchor.longitude, height: 0.0 };
    let (source, degrees) = match (w.heading, yaw, exif.image_direction) {
        (Some(g), _, _) => (HeadingSource::Given, g),
        (_, Some(y), _) => (HeadingSource::Gimbal, y + 1.0),
        (_, _, Some(d)) if exif.direction_is_magnetic => {
            (HeadingSource::ExifMagnetic, d + 1.0 + magnetic::field(at, 2026.5).declination)
        }
        (_, _, Some(d)) => (HeadingSource::ExifTrue, d + 1.0),
        _ => (HeadingSource::Assumed, 0.0),
    };
    assert_eq!(h.source, source);
    assert!((h.degrees - degrees).abs() < 1e-9 && h.sigma > 0.0 && warnings.is_empty());
}

#[test]
fn a_compass_is_doubted_where_the_model_ends() {
    let exif =
        |date| Exif { image_direction: Some(0.0), direction_is_magnetic: true, date: Some(date), ..Default::default() };
    let w = wanted(Some("34.5,-118.4,0"), None, None);
    let anchor = w.anchor(&exif((2026, 1, 1))).unwrap();
    let mut warnings = vec![];
    let now = heading(&w, &exif((2026, 1, 1)), &anchor, 2026.0, |a| a, &mut warnings).sigma;
    assert!(warnings.is_empty());
    let old = heading(&w, &exif((2010, 1, 1)), &anchor, 2026.0, |a| a, &mut warnings).sigma;
    assert!(old > now && warnings.len() == 1);
    let w = wanted(Some("86,139,0"), None, None);
    let anchor = w.anchor(&exif((2026, 1, 1))).unwrap();
    let pole = heading(&w, &exif((2026, 1, 1)), &anchor, 2026.0, |a| a, &mut warnings).sigma;
    assert!(pole > 90.0 && warnings.len() == 2);
}

#[test]
fn the_camera_height_is_taken_from_whom_it_is_known_to() {
    let flown =
        |h| Exif { gimbal: Some(Gimbal { above_takeoff: Some(h), ..Default::default() }), ..Default::default() };
    let by = |w: &Wanted, exif: &Exif| hints(w, exif, None).camera_height.by;
    let mut w = wanted(None, None, None);
    assert_eq!(by(&w, &Exif::default()), By::Assumption);
    assert_eq!(by(&w, &flown(40.0)), By::Drone);
    assert_eq!(by(&w, &flown(0.3)), By::Assumption);
    w.camera_height = Some(2.0);
    assert_eq!(by(&w, &flown(40.0)), By::Operator);
}
