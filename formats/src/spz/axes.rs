//! Axis conventions: which way x, y and z point.

use crate::splats::BASES;

/// Three letters in the custom of the field: x Left or Right, y Up or Down, z Front or Back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    pub right: bool,
    pub up: bool,
    pub back: bool,
}

impl Axes {
    /// The file's own: OpenGL, three.js, glTF.
    pub const RUB: Axes = Axes { right: true, up: true, back: true };
    /// 3D Gaussian Splatting's PLY files, COLMAP, OpenCV.
    pub const RDF: Axes = Axes { right: true, up: false, back: false };

    /// −1 for each axis that differs from the other's.
    fn signs_to(self, other: Axes) -> [f32; 3] {
        let sign = |same: bool| if same { 1.0 } else { -1.0 };
        [sign(self.right == other.right), sign(self.up == other.up), sign(self.back == other.back)]
    }
}

/// What flipping axes does to a splat.
#[derive(Clone, Copy, Debug)]
pub struct Flip {
    pub position: [f32; 3],
    /// x, y, z of the quaternion; w stays. Scales stand on the axes of the splat itself, and stay too.
    pub rotation: [f32; 3],
    pub sh: [f32; 16],
}

impl Flip {
    pub fn between(from: Axes, to: Axes) -> Self {
        let [x, y, z] = from.signs_to(to);
        // F R F for the mirror F: the rotation about x keeps its sense if y and z flip together.
        let rotation = [y * z, x * z, x * y];
        // Each basis function is a polynomial in x, y, z: its sign follows from the odd powers (Sloan, "Stupid
        // Spherical Harmonics Tricks", 2008, appendix A2).
        let sh = [
            1.0,
            y,
            z,
            x,
            x * y,
            y * z,
            1.0,
            x * z,
            1.0,
            y,         // y (3x² − y²)
            x * y * z, // xyz
            y,         // y (4z² − x² − y²)
            z,
            x,
            z, // z (x² − y²)
            x, // x (x² − 3y²)
        ];
        debug_assert_eq!(sh.len(), BASES[3]);
        Flip { position: [x, y, z], rotation, sh }
    }
}
