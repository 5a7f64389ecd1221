//! The options of one photo's camera and of several photos.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::audit::statement::Param;
use crate::{Error, Result};

/// What is known of the photo's camera, or how several photos belong together.
#[derive(Args, Clone, Debug, Default)]
pub struct PhotosArgs {
    /// How far the camera of one photo looked up, degrees above the horizon; down is negative. Default: the photo's XMP, else what
    /// the networks see.
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub pitch: Option<f64>,

    /// Focal length of one photo's camera, as its whole frame had it, for a frame of 36 × 24 mm (phones: 24 to 28). Default: the photo's
    /// EXIF, else unknown.
    #[arg(long, value_name = "MM")]
    pub focal: Option<f64>,

    /// Where the cameras of several photos stood: a COLMAP model, a folder of models (the largest is taken) or a
    /// transforms.json. Default: what lies in the folder of the photos or beside it.
    #[arg(long, value_name = "PATH", help_heading = "Several photos")]
    pub poses: Option<PathBuf>,

    /// Compute the poses by an installed program.
    #[arg(long, value_enum, conflicts_with = "poses", help_heading = "Several photos")]
    pub sfm: Option<Sfm>,

    /// Ground control points: a CSV file with the columns point, latitude, longitude, height, photo, x, y and, if known, sigma
    /// (metres).
    #[arg(long, value_name = "FILE", help_heading = "Several photos")]
    pub gcp: Option<PathBuf>,

    /// Refine the cameras' poses while the Gaussians are optimised.
    #[arg(long, help_heading = "Several photos")]
    pub refine_poses: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Sfm {
    /// The `colmap` program, on the CPU.
    Colmap,
}

impl PhotosArgs {
    /// Refuses what only a folder of photos can use of one photo, and of `several` what one camera alone has.
    ///
    /// # Errors
    /// Usage.
    pub fn check(&self, several: bool) -> Result<()> {
        if let Some(pitch) = self.pitch {
            let refused = Error::usage("--pitch");
            if several {
                return Err(refused
                    .expected("one photo")
                    .found(format!("{pitch}° of several, whose cameras look their own ways"))
                    .advice("Leave it out: the poses tell how each camera looks."));
            }
            if !(-90.0..=90.0).contains(&pitch) {
                return Err(refused.expected("degrees between -90 (straight down) and 90").found(pitch.to_string()));
            }
        }
        if let Some(focal) = self.focal {
            let refused = Error::usage("--focal");
            if several {
                return Err(refused
                    .expected("one photo")
                    .found(format!("{focal} mm of several"))
                    .advice("Leave it out: the poses tell what lens each camera has."));
            }
            if !(4.0..=3000.0).contains(&focal) {
                return Err(refused.expected("millimetres between 4 and 3000").found(focal.to_string()));
            }
        }
        if several {
            return Ok(());
        }
        let given = [
            ("--poses", self.poses.is_some()),
            ("--sfm", self.sfm.is_some()),
            ("--gcp", self.gcp.is_some()),
            ("--refine-poses", self.refine_poses),
        ];
        match given.iter().find(|(_, given)| *given) {
            Some((option, _)) => Err(Error::usage(*option).expected("a folder of photos").found("one photo")),
            None => Ok(()),
        }
    }

    /// What the record says of them beside the photos' own.
    pub fn params(&self) -> impl Iterator<Item = (String, Param)> {
        [("pitch_given_deg", self.pitch), ("focal_given_35mm", self.focal)]
            .into_iter()
            .filter_map(|(name, value)| Some((name.into(), Param::Text(value?.to_string()))))
    }
}
