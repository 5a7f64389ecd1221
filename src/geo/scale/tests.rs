use super::*;
use crate::photo::DIAGONAL_35MM;

const EXTENTS: Extents = Extents { height: 0.8, length: 2.0, width: 0.8, centre_above_ground: 0.35 };

fn view(elevation_deg: f32) -> View {
    View {
        elevation: elevation_deg.to_radians(),
        elevation_sigma: 5f64.to_radians(),
        crop_side: 400.0,
        photo_width: 512,
        photo_height: 512,
        canonical_distance: 3.9,
        canonical_fov: 30f32.to_radians(),
        focal_35mm: Some(50.0),
        focal_given: false,
        posed_focal: None,
    }
}

fn hints(known: &[Known]) -> Hints {
    Hints { known: known.to_vec(), camera_height: ASSUMED_CAMERA_HEIGHT, distance: None, front: None, registered: None }
}

fn standing(metres: f64) -> Hints {
    Hints { camera_height: Measured { metres, sigma: 0.05, by: By::Operator }, ..hints(&[]) }
}

#[test]
fn a_known_dimension_outweighs_what_is_assumed() {
    let s = metres_per_unit(&hints(&[Known::Length(4.6)]), &EXTENTS, &view(10.0)).unwrap();
    assert_eq!((s.metres_per_unit, s.source), (2.3, ScaleSource::KnownLength));
    assert_eq!(s.words(), "length 4.6 m given");
    assert!((0.01..0.03).contains(&s.sigma) && !s.contradictory);
}

#[test]
fn an_eyes_height_is_doubted_where_the_photo_looks_down() {
    let said = |elevation, hints: &Hints| {
        metres_per_unit(hints, &EXTENTS, &view(elevation)).unwrap().doubt_from_the_air(hints, &view(elevation))
    };
    assert!(said(60.0, &hints(&[])).unwrap().contains("by 60°"));
    assert_eq!(said(30.0, &hints(&[])), None);
    assert_eq!(said(60.0, &standing(40.0)), None);
    assert_eq!(said(60.0, &hints(&[Known::Length(4.6)])), None);
}

/// A camera built from the formula's own geometry, seen from 3 m up, gives its scale back.
#[test]
fn camera_height_gives_the_scale_of_a_known_scene() {
    let (metres_a_unit, elevation) = (2.0f64, 15f64.to_radians());
    let v = View { elevation_sigma: 0.01, ..view(15.0) };
    let focal = 50.0 * 512f64.hypot(512.0) / DIAGONAL_35MM;
    let distance = 3.9 * 2.0 * 15f64.to_radians().tan() * focal / 400.0;
    let height = metres_a_unit * (distance * elevation.sin() + 0.35);
    let s = metres_per_unit(&standing(height), &EXTENTS, &v).unwrap();
    assert!((s.metres_per_unit - metres_a_unit).abs() < 1e-6);
    assert_eq!(s.source, ScaleSource::CameraHeightExifFocal);
    assert!(metres_per_unit(&hints(&[]), &EXTENTS, &view(-30.0)).is_err());
    let far = Hints { distance: Some(Measured { metres: 2.0 * distance, sigma: 0.3, by: By::Exif }), ..hints(&[]) };
    let s = metres_per_unit(&far, &EXTENTS, &v).unwrap();
    assert!((s.metres_per_unit - metres_a_unit).abs() < 1e-6);
    assert_eq!(s.source, ScaleSource::DistanceExifFocal);
    let told = metres_per_unit(&far, &EXTENTS, &View { focal_given: true, ..v }).unwrap();
    assert_eq!((told.metres_per_unit, told.source), (s.metres_per_unit, ScaleSource::DistanceGivenFocal));
    assert!(told.words().ends_with("focal length 50 mm given"), "{}", told.words());
}

/// Before a building the camera stands below its middle; where the angle says that it stands below the ground, the angle is off.
#[test]
fn a_photo_that_looks_up_gives_a_scale_that_is_hardly_known() {
    let scale = |elevation| metres_per_unit(&hints(&[]), &EXTENTS, &view(elevation));
    let (level, up, steep) = (scale(0.0).unwrap(), scale(-6.0).unwrap(), scale(-10.0).unwrap());
    assert!(level.sigma < up.sigma && up.sigma < steep.sigma && steep.sigma < 1.2, "{level:?} {up:?} {steep:?}");
    assert!((level.metres_per_unit / (1.6 / 0.35) - 1.0).abs() < 0.3, "{level:?}");
    assert!(steep.metres_per_unit < 20.0 * level.metres_per_unit && steep.metres_per_unit > up.metres_per_unit);
    assert!(scale(-20.0).is_err());
}

/// A network that is off by a tenth, and one that agrees with a length that is known far better.
#[test]
fn a_metric_network_gives_a_scale_and_is_outweighed_by_a_tape() {
    let v = view(15.0);
    let seen = |metres: f64| (Measured { metres, sigma: 0.25 * metres, by: By::Network }, 0.4);
    let truth = 2.3 * (v.distance() - 0.4);
    let alone = Hints { front: Some(seen(truth)), ..hints(&[]) };
    let s = metres_per_unit(&alone, &EXTENTS, &v).unwrap();
    assert!((s.metres_per_unit - 2.3).abs() < 1e-9 && (0.25..0.27).contains(&s.sigma), "{s:?}");
    assert_eq!((s.source, s.estimates.len()), (ScaleSource::MetricDepthExifFocal, 1), "what is assumed has no say");
    assert!(s.words().contains("by a metric depth network"), "{}", s.words());
    let taped = Hints { front: Some(seen(1.1 * truth)), ..hints(&[Known::Length(4.6)]) };
    let s = metres_per_unit(&taped, &EXTENTS, &v).unwrap();
    assert_eq!((s.source, s.estimates.len(), s.contradictory), (ScaleSource::KnownLength, 2, false));
    assert!((s.metres_per_unit / 2.3 - 1.0).abs() < 2e-3 && s.sigma < 0.0224, "{s:?}");
    let behind = Hints { front: Some((seen(5.0).0, v.distance())), ..hints(&[Known::Length(4.6)]) };
    assert_eq!(metres_per_unit(&behind, &EXTENTS, &v).unwrap().estimates.len(), 1);
}

/// The deviation that is propagated is the one that five hundred disturbed cameras show.
#[test]
fn propagated_deviation_matches_disturbed_inputs() {
    // Small enough for the first order that is propagated.
    let v = View { elevation_sigma: 1f64.to_radians(), ..view(20.0) };
    let height = Measured { metres: 1.6, sigma: 0.1, by: By::Operator };
    let stated = from_camera_height(height, &EXTENTS, &v).unwrap();
    let mut squares = Vec::new();
    // Eight-point symmetric samples of a normal law in each of three directions: mean square 1.
    let steps = [-1.645, -1.036, -0.6745, -0.3186, 0.3186, 0.6745, 1.036, 1.645].map(|x: f64| x * 1.0515);
    for dh in steps {
        for df in steps {
            for de in steps {
                let disturbed = View {
                    elevation: v.elevation + (de * v.elevation_sigma) as f32,
                    focal_35mm: Some(50.0 * (1.0 + df * EXIF_FOCAL_SIGMA)),
                    ..v
                };
                let h = Measured { metres: 1.6 + dh * 0.1, ..height };
                let e = from_camera_height(h, &EXTENTS, &disturbed).unwrap();
                squares.push((e.metres_per_unit / stated.metres_per_unit).ln().powi(2));
            }
        }
    }
    let seen = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    assert!((seen / stated.sigma - 1.0).abs() < 0.12, "{seen} {}", stated.sigma);
}

#[test]
fn agreeing_measurements_sharpen_and_contradicting_ones_are_said() {
    let v = View { elevation_sigma: 0.01, ..view(15.0) };
    let true_height = 2.3 * v.camera_above_ground(&EXTENTS);
    let both = Hints { known: vec![Known::Length(4.6), Known::Height(1.84)], ..standing(true_height) };
    let s = metres_per_unit(&both, &EXTENTS, &v).unwrap();
    assert!((s.metres_per_unit - 2.3).abs() < 1e-9 && s.estimates.len() == 3 && !s.contradictory);
    assert!(s.sigma < s.estimates[0].sigma);
    let wrong = Hints { known: vec![Known::Length(4.6), Known::Height(3.7)], ..hints(&[]) };
    let s = metres_per_unit(&wrong, &EXTENTS, &v).unwrap();
    assert!(s.contradictory && s.sigma > 0.2, "{s:?}");
}

#[test]
fn places_follow_the_deviation() {
    assert_eq!(with_deviation(4.6123, 0.52, " m"), "4.6 m ± 0.5");
    assert_eq!(with_deviation(4.6123, 0.0321, " m"), "4.61 m ± 0.03");
    assert_eq!(with_deviation(4.6123, 0.12, " m"), "4.61 m ± 0.12");
    assert_eq!(with_deviation(87.3, 104.0, "°"), "87° ± 104");
}
