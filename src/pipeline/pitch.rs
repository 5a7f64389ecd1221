//! The camera's elevation over the subject where somebody says how far it looked up or down, or a drone's gimbal measured it:
//! better than what any network guesses.

use crate::geo::scale::{ASSUMED_FOCAL_35MM, ASSUMED_FOCAL_SIGMA};
use crate::geo::sight::{GIVEN_PITCH_SIGMA, PITCH_SIGMA, below_axis};
use crate::models::scene::Elevation;
use crate::photo::{Exif, Rect, focal_in_pixels};

/// By the pitch of the optical axis, degrees above the horizon (`given`, else the gimbal's), and the row of the crop's middle in a
/// photo of `width` by `height` pixels. `None` where nobody says.
pub fn elevation(given: Option<f64>, exif: &Exif, (width, height): (u32, u32), crop: Rect) -> Option<Elevation> {
    let (pitch, sigma) = match given {
        Some(pitch) => (pitch, GIVEN_PITCH_SIGMA),
        None => (exif.gimbal?.pitch?, PITCH_SIGMA),
    };
    let row = f64::from(crop.y + crop.height / 2.0);
    let focal = focal_in_pixels(exif.focal_35mm.unwrap_or(ASSUMED_FOCAL_35MM), width, height);
    let below = below_axis(row, height, focal);
    let unsure = if exif.focal_35mm.is_some() { 0.0 } else { ASSUMED_FOCAL_SIGMA * below.abs() };
    Some(Elevation { mean: (below - pitch.to_radians()) as f32, spread: (sigma.to_radians() + unsure) as f32 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photo::Gimbal;

    #[test]
    fn the_subject_is_seen_by_the_pitch_and_by_how_far_it_is_beside_the_axis() {
        let pitched = |focal_35mm| Exif {
            gimbal: Some(Gimbal { pitch: Some(-40.0), ..Gimbal::default() }),
            focal_35mm,
            ..Exif::default()
        };
        // As far above the middle as the focal length of a 35 mm lens is long: 45°.
        let focal = focal_in_pixels(35.0, 4000, 3000) as f32;
        let at = |middle: f32| Rect { x: 0.0, y: middle - 100.0, width: 200.0, height: 200.0 };
        let degrees = |e: Option<Elevation>| e.unwrap().mean.to_degrees();
        assert!((degrees(elevation(None, &pitched(Some(35.0)), (4000, 3000), at(1500.0))) - 40.0).abs() < 1e-3);
        let aside = elevation(None, &pitched(Some(35.0)), (4000, 3000), at(1500.0 - focal)).unwrap();
        assert!((aside.mean.to_degrees() + 5.0).abs() < 1e-3 && (aside.spread.to_degrees() - 1.5).abs() < 1e-4);
        // Without a focal length the angle beside the axis is a guess.
        let guessed = elevation(None, &pitched(None), (4000, 3000), at(1500.0 - focal)).unwrap();
        assert!(guessed.spread > 0.2, "{guessed:?}");
        assert_eq!(elevation(None, &Exif::default(), (4000, 3000), at(1500.0)), None);
        // Who looks up sees the subject from below; a word counts before a gimbal's.
        let up = elevation(Some(25.0), &pitched(Some(35.0)), (4000, 3000), at(1500.0)).unwrap();
        assert!((up.mean.to_degrees() + 25.0).abs() < 1e-3 && (up.spread.to_degrees() - 3.0).abs() < 1e-3);
    }
}
