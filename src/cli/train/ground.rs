//! The ground of a trained scene, as every output that tells it from what stands on it needs it; and the words where there is none.

use crate::pipeline::scene::ground::{self, Filter, Surface, Terrain};
use crate::pipeline::scene::{Role, Scene};
use crate::splat::Camera;
use crate::{Error, Result};

pub struct Ground {
    /// The first so many Gaussians are not the sky's.
    pub near: usize,
    pub terrain: Terrain,
    /// Of every Gaussian.
    pub is_ground: Vec<bool>,
    /// Those trained on.
    pub cameras: Vec<Camera>,
    /// What it is for, as the user asked for it.
    option: &'static str,
}

impl Ground {
    /// # Errors
    /// Usage where too few Gaussians are opaque to say.
    pub fn of(done: &Scene, option: &'static str) -> Result<Ground> {
        let near = done.gaussians.len() - done.sky;
        let (terrain, is_ground) = ground::separated(&done.gaussians, near, &Filter::default())
            .ok_or_else(|| missing(option, "too few opaque Gaussians below what the photos look at"))?;
        let cameras = done.views.iter().filter(|v| v.role == Role::Trained).map(|v| v.camera).collect();
        Ok(Ground { near, terrain, is_ground, cameras, option })
    }

    /// Its surface where three photos see it, of the Gaussians that are chosen.
    ///
    /// # Errors
    /// Usage where there is no such place.
    pub fn surface(&self, done: &Scene, is_ground: &[bool]) -> Result<Surface> {
        Surface::of(&done.gaussians, is_ground, &self.terrain, &self.cameras)
            .ok_or_else(|| missing(self.option, "no such place"))
    }

    /// Half of the cameras are higher: what hangs above it is taken for air.
    pub fn ceiling(&self) -> f32 {
        let mut eyes: Vec<f32> = self.cameras.iter().map(|c| c.position().z).collect();
        eyes.sort_unstable_by(f32::total_cmp);
        eyes.get(eyes.len() / 2).copied().unwrap_or(f32::INFINITY)
    }
}

fn missing(option: &str, found: &str) -> Error {
    Error::usage(option)
        .expected("ground that at least three photos see from above")
        .found(found)
        .advice("Train for longer, or leave it out.")
}
