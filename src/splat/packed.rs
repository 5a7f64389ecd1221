//! Gaussians as the kernels read them: one record for the shape, one for the colour, each a whole number of lanes.

use glam::Vec3;

use super::Gaussians;

/// Where each parameter stands in [`Core`].
pub const POSITION: usize = 0;
pub const OPACITY: usize = 3;
pub const ROTATION: usize = 4;
pub const SCALE: usize = 8;

/// x y z, logit opacity, quaternion w x y z, log scales, padding.
pub type Core = [f32; 16];
/// Channel-major: 16 coefficients of red, then green, then blue.
pub type Sh = [f32; 48];

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Packed {
    pub core: Vec<Core>,
    pub sh: Vec<Sh>,
}

impl Packed {
    pub fn len(&self) -> usize {
        self.core.len()
    }

    pub fn pack(g: &Gaussians) -> Self {
        let core = |i: usize| {
            let (p, s, q) = (g.positions[i], g.log_scales[i], g.rotations[i]);
            let mut c = [0.0; 16];
            c[POSITION..POSITION + 3].copy_from_slice(&p.to_array());
            c[OPACITY] = g.logit_opacities[i];
            c[ROTATION..ROTATION + 4].copy_from_slice(&q);
            c[SCALE..SCALE + 3].copy_from_slice(&s.to_array());
            c
        };
        let sh = |i: usize| std::array::from_fn(|k| g.sh[i][k % 16][k / 16]);
        Packed { core: (0..g.len()).map(core).collect(), sh: (0..g.len()).map(sh).collect() }
    }

    pub fn unpack(&self) -> Gaussians {
        Gaussians {
            positions: self.core.iter().map(|c| Vec3::new(c[0], c[1], c[2])).collect(),
            log_scales: self.core.iter().map(|c| Vec3::from_slice(&c[SCALE..])).collect(),
            rotations: self.core.iter().map(|c| std::array::from_fn(|k| c[ROTATION + k])).collect(),
            logit_opacities: self.core.iter().map(|c| c[OPACITY]).collect(),
            sh: self.sh.iter().map(|s| std::array::from_fn(|k| std::array::from_fn(|ch| s[ch * 16 + k]))).collect(),
        }
    }
}
