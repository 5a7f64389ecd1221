//! The unseen side from the seen one: a subject's vertical planes of symmetry, and what they give.
//!
//! [`find`] looks for the planes by how well the subject, mirrored, meets itself; [`complete`] puts mirrored Gaussians
//! where the photo saw nothing, and gives the photo as a camera on the other side would have taken it, a further picture to
//! train on and to take texture from. Letters and number plates come out mirrored.

mod complete;
mod evidence;
mod middle;
mod search;

#[cfg(test)]
mod tests;

use glam::{Mat3, Vec3};

use crate::splat::{Camera, Gaussians};

pub use complete::{Completed, MirroredPhoto, Origin, complete};
pub use evidence::Seen;
pub use search::{Basis, Fit, Found, assumed, find, used};

/// Which symmetry is used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Use {
    /// One plane or two, where the subject meets its mirror image well enough; else one that nothing speaks against.
    #[default]
    Auto,
    /// One plane or two, where the subject meets its mirror image well enough.
    Evident,
    /// The best plane, however well it fits.
    On,
    /// It and a second one at right angles: the back is the front's mirror image.
    Two,
    Off,
}

/// Points with normal · p = offset; the photo's camera is on the side that the normal points to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit length.
    pub normal: Vec3,
    pub offset: f32,
}

impl Plane {
    pub fn distance(&self, p: Vec3) -> f32 {
        self.normal.dot(p) - self.offset
    }

    pub fn reflect(&self, p: Vec3) -> Vec3 {
        p - 2.0 * self.distance(p) * self.normal
    }

    /// I − 2 n nᵀ.
    fn matrix(&self) -> Mat3 {
        let n = self.normal;
        Mat3::IDENTITY - Mat3::from_cols(n * n.x, n * n.y, n * n.z) * 2.0
    }

    /// The camera that sees the mirrored subject as `camera` sees the subject, left and right exchanged.
    ///
    /// With the reflection p' = S p + t and F = diag(−1, 1, 1): F (R p + T) = (F R S) p' + F (R t + T), a rotation again.
    pub fn camera(&self, camera: &Camera) -> Camera {
        let flip = Mat3::from_diagonal(Vec3::new(-1.0, 1.0, 1.0));
        let shift = 2.0 * self.offset * self.normal;
        Camera {
            rotation: flip * camera.rotation * self.matrix(),
            translation: flip * (camera.rotation * shift + camera.translation),
            cx: camera.width as f32 - camera.cx,
            ..*camera
        }
    }

    /// The mirror image of a scene.
    ///
    /// S = −H with H half a turn about the normal: shapes turn by H, and a harmonic of odd degree changes its sign.
    pub fn gaussians(&self, g: &Gaussians) -> Gaussians {
        let mut out = g.transformed(-self.matrix(), 1.0, Vec3::ZERO);
        for (to, from) in out.positions.iter_mut().zip(&g.positions) {
            *to = self.reflect(*from);
        }
        for sh in &mut out.sh {
            for basis in (1..4).chain(9..16) {
                sh[basis] = sh[basis].map(|v| -v);
            }
        }
        out
    }
}

/// Left and right of a row-major picture exchanged.
pub fn flipped<T: Copy>(picture: &[T], width: usize) -> Vec<T> {
    picture.chunks(width.max(1)).flat_map(|row| row.iter().rev().copied()).collect()
}
