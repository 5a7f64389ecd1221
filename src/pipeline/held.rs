//! How the photo's camera was held, where somebody says how far it looked up or down, or a drone's gimbal or a phone measured it:
//! better than what any network guesses. And the picture of the subject that follows from it.

use glam::{DVec2, DVec3};

use crate::geo::scale::{ASSUMED_FOCAL_35MM, ASSUMED_FOCAL_SIGMA};
use crate::geo::sight::{GIVEN_PITCH_SIGMA, PHONE_PITCH_SIGMA, PITCH_SIGMA};
use crate::models::scene::{Angle, Subject};
use crate::models::splat_prior::Aim;
use crate::photo::{Photo, down};

/// By this focal length, for a frame of 36 × 24 mm, a photo that does not say its own is drawn straight: what lies aside is brought half
/// the way of a phone's lens, and not too far of a long one.
pub const STRAIGHTENED_BY_35MM: f64 = 50.0;

/// What is known of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Over what is in the photo's `middle` of the subject.
    pub elevation: Angle,
    /// Where down is, in its axes: right, down, forward.
    pub down: DVec3,
}

/// By the pitch of the optical axis that is `given`, degrees above the horizon, else the gimbal's, else what the phone felt; over what lies
/// in the `middle` of what the photo shows of the subject, pixels; where who says it says nothing of the camera's `roll`, it is this.
/// `None` where nobody says.
pub fn held(given: Option<f64>, photo: &Photo, middle: DVec2, roll: f64) -> Option<Held> {
    let exif = &photo.exif;
    let by_pitch = |degrees: f64| down::by_pitch(degrees.to_radians());
    let (down, sigma) = match (given, exif.gimbal.and_then(|g| g.pitch), exif.down) {
        // A word on the pitch says nothing of how the phone was rolled.
        (Some(pitch), _, Some(felt)) => (rolled_as(felt, pitch), GIVEN_PITCH_SIGMA),
        (Some(pitch), _, None) => (down::rolled(by_pitch(pitch), roll), GIVEN_PITCH_SIGMA),
        (None, Some(pitch), _) => (by_pitch(pitch), PITCH_SIGMA),
        (None, None, felt) => (felt?, PHONE_PITCH_SIGMA),
    };
    let ray = photo.pinhole_of(exif.focal_35mm.unwrap_or(ASSUMED_FOCAL_35MM)).ray(middle);
    let elevation = down::elevation(down, ray);
    let beside = elevation - down::elevation(down, DVec3::Z);
    let unsure = if exif.focal_35mm.is_some() { 0.0 } else { ASSUMED_FOCAL_SIGMA * beside.abs() };
    Some(Held { elevation: Angle { mean: elevation as f32, spread: (sigma.to_radians() + unsure) as f32 }, down })
}

/// As far from the picture's own down as `felt`, but with another pitch, degrees.
fn rolled_as(felt: DVec3, pitch: f64) -> DVec3 {
    let level = down::by_pitch(pitch.to_radians());
    match felt.truncate().try_normalize() {
        Some(across) => (across * level.y).extend(level.z),
        None => level,
    }
}

/// Of the camera, radians, as the subject's surroundings tell it; a gimbal keeps its camera level.
pub fn roll(photo: &Photo, subject: &Subject) -> f64 {
    if photo.exif.gimbal.is_some() { 0.0 } else { subject.roll.into() }
}

/// The photo's camera, to be turned at its subject.
pub fn aim(photo: &Photo, held: Option<&Held>, roll: f64) -> Aim {
    let lens = photo.pinhole();
    Aim {
        lens: lens.unwrap_or_else(|| photo.pinhole_of(STRAIGHTENED_BY_35MM)),
        lens_assumed: lens.is_none(),
        down: held.map(|h| h.down),
        roll,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photo::{Exif, Gimbal};

    fn photo(exif: Exif) -> Photo {
        Photo {
            name: "a.jpg".into(),
            media_type: "image/jpeg",
            sha256: [0; 32],
            byte_len: 0,
            pixels: image::RgbImage::new(400, 300),
            cutout: None,
            exif,
        }
    }

    #[test]
    fn the_subject_is_seen_by_the_pitch_and_by_how_far_it_is_beside_the_axis() {
        let pitched = |focal_35mm| {
            let gimbal = Some(Gimbal { pitch: Some(-40.0), ..Gimbal::default() });
            photo(Exif { gimbal, focal_35mm, ..Exif::default() })
        };
        let seen = |given, photo: &Photo, at: f64| held(given, photo, DVec2::new(200.0, at), 0.0).map(|h| h.elevation);
        let degrees = |e: Option<Angle>| e.unwrap().mean.to_degrees();
        // As far above the middle as the focal length of a 35 mm lens is long: 45°.
        let above = 150.0 - pitched(None).pinhole_of(35.0).focal.y;
        assert!((degrees(seen(None, &pitched(Some(35.0)), 150.0)) - 40.0).abs() < 1e-3);
        let aside = seen(None, &pitched(Some(35.0)), above).unwrap();
        assert!((aside.mean.to_degrees() + 5.0).abs() < 1e-3 && (aside.spread.to_degrees() - 1.5).abs() < 1e-4);
        // Without a focal length the angle beside the axis is a guess.
        let guessed = seen(None, &pitched(None), above).unwrap();
        assert!(guessed.spread > 0.2, "{guessed:?}");
        assert_eq!(held(None, &photo(Exif::default()), DVec2::new(200.0, 150.0), 0.0), None);
        // Who looks up sees the subject from below; a word counts before a gimbal's.
        let up = seen(Some(25.0), &pitched(Some(35.0)), 150.0).unwrap();
        assert!((up.mean.to_degrees() + 25.0).abs() < 1e-3 && (up.spread.to_degrees() - 3.0).abs() < 1e-4);
    }

    #[test]
    fn a_phone_felt_how_it_was_held_and_a_word_on_its_pitch_leaves_its_roll() {
        let felt = DVec3::new(-0.1, 0.9, 0.3).normalize();
        let photo = photo(Exif { down: Some(felt), focal_35mm: Some(26.0), ..Exif::default() });
        let middle = DVec2::new(200.0, 150.0);
        let seen = held(None, &photo, middle, 0.2).unwrap();
        assert_eq!(seen.down, felt);
        assert!((f64::from(seen.elevation.mean) - felt.z.asin()).abs() < 1e-6, "{seen:?}");
        let told = held(Some(-50.0), &photo, middle, 0.2).unwrap();
        assert!((told.elevation.mean.to_degrees() - 50.0).abs() < 1e-3, "{told:?}");
        assert!((told.down.x / told.down.y - felt.x / felt.y).abs() < 1e-9 && (told.down.length() - 1.0).abs() < 1e-9);
        // Where it felt nothing its surroundings say how it was rolled.
        let unfelt = Photo { exif: Exif { down: None, ..photo.exif.clone() }, ..photo.clone() };
        let rolled = held(Some(-50.0), &unfelt, middle, 0.2).unwrap().down;
        assert!((rolled.x.atan2(rolled.y) - 0.2).abs() < 1e-9 && (rolled.z - 50f64.to_radians().sin()).abs() < 1e-9);
        let nadir = Photo { exif: Exif { down: Some(DVec3::Z), ..photo.exif.clone() }, ..photo.clone() };
        assert_eq!(held(Some(-50.0), &nadir, middle, 0.2).unwrap().down, down::by_pitch(-50f64.to_radians()));
    }
}
