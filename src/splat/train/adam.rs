//! Adam (Kingma and Ba 2015) over one Gaussian's records; a Gaussian that no pixel depends on keeps still.

use crate::splat::packed::{Core, OPACITY, POSITION, Packed, ROTATION, SCALE, Sh};
use crate::splat::simd::Simd;

pub const BETA1: f32 = 0.9;
pub const BETA2: f32 = 0.999;
const EPSILON: f32 = 1e-15;

/// First and second moments, and how often each Gaussian was stepped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moments {
    pub core: Vec<[Core; 2]>,
    pub sh: Vec<[Sh; 2]>,
    pub steps: Vec<u32>,
}

impl Moments {
    pub fn new(gaussians: &Packed) -> Self {
        let n = gaussians.len();
        Moments { core: vec![[[0.0; 16]; 2]; n], sh: vec![[[0.0; 48]; 2]; n], steps: vec![0; n] }
    }
}

/// The step size of every lane of the records in one iteration.
#[derive(Clone, Copy, Debug)]
pub struct LaneRates {
    pub core: Core,
    pub sh: Sh,
}

impl LaneRates {
    pub fn new(position: f32, opacity: f32, rotation: f32, scale: f32, color: f32, harmonics: f32) -> Self {
        let mut core = [0.0; 16];
        core[POSITION..POSITION + 3].fill(position);
        core[OPACITY] = opacity;
        core[ROTATION..ROTATION + 4].fill(rotation);
        core[SCALE..SCALE + 3].fill(scale);
        LaneRates { core, sh: std::array::from_fn(|k| if k % 16 == 0 { color } else { harmonics }) }
    }
}

/// 1 / (1 − β^t) of both moments.
pub fn corrections(step: u32) -> [f32; 2] {
    [BETA1, BETA2].map(|b| (1.0 / (1.0 - (b as f64).powi(step as i32))) as f32)
}

/// One step of some lanes.
#[inline(always)]
pub fn step<S: Simd>(
    s: S,
    values: &mut [f32],
    moments: (&mut [f32], &mut [f32]),
    gradient: &[f32],
    rates: &[f32],
    correction: [f32; 2],
) {
    let (b1, b2) = (s.splat(BETA1), s.splat(BETA2));
    let (r1, r2) = (s.splat(1.0 - BETA1), s.splat(1.0 - BETA2));
    let (c1, c2) = (s.splat(correction[0]), s.splat(correction[1]));
    let epsilon = s.splat(EPSILON);
    for i in (0..values.len()).step_by(S::LANES) {
        let g = s.load(&gradient[i..]);
        let m = s.fma(b1, s.load(&moments.0[i..]), s.mul(r1, g));
        let v = s.fma(b2, s.load(&moments.1[i..]), s.mul(r2, s.mul(g, g)));
        s.store(m, &mut moments.0[i..]);
        s.store(v, &mut moments.1[i..]);
        let change = s.div(s.mul(s.load(&rates[i..]), s.mul(m, c1)), s.add(s.sqrt(s.mul(v, c2)), epsilon));
        s.store(s.sub(s.load(&values[i..]), change), &mut values[i..]);
    }
}
