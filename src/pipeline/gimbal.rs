//! The camera's elevation over the subject where a drone's gimbal measured it: better than what any network guesses.

use crate::geo::scale::{ASSUMED_FOCAL_35MM, ASSUMED_FOCAL_SIGMA, focal_in_pixels};
use crate::geo::sight::{PITCH_SIGMA, below_axis};
use crate::models::scene::Elevation;
use crate::photo::{Exif, Rect};

/// By the pitch of the optical axis and the row of the crop's middle in a photo of `width` by `height` pixels.
pub fn elevation(exif: &Exif, (width, height): (u32, u32), crop: Rect) -> Option<Elevation> {
    let pitch = exif.gimbal?.pitch?;
    let row = f64::from(crop.y + crop.height / 2.0);
    let focal = focal_in_pixels(exif.focal_35mm.unwrap_or(ASSUMED_FOCAL_35MM), width, height);
    let below = below_axis(row, height, focal);
    let unsure = if exif.focal_35mm.is_some() { 0.0 } else { ASSUMED_FOCAL_SIGMA * below.abs() };
    Some(Elevation { mean: (below - pitch.to_radians()) as f32, spread: (PITCH_SIGMA.to_radians() + unsure) as f32 })
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
        assert!((degrees(elevation(&pitched(Some(35.0)), (4000, 3000), at(1500.0))) - 40.0).abs() < 1e-3);
        let aside = elevation(&pitched(Some(35.0)), (4000, 3000), at(1500.0 - focal)).unwrap();
        assert!((aside.mean.to_degrees() + 5.0).abs() < 1e-3 && (aside.spread.to_degrees() - 1.5).abs() < 1e-4);
        // Without a focal length the angle beside the axis is a guess.
        let guessed = elevation(&pitched(None), (4000, 3000), at(1500.0 - focal)).unwrap();
        assert!(guessed.spread > 0.2, "{guessed:?}");
        assert_eq!(elevation(&Exif::default(), (4000, 3000), at(1500.0)), None);
    }
}
