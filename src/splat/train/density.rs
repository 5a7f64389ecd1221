//! Adaptive density control (Kerbl et al. 2023, §5.2): clone small Gaussians and split large ones where the picture
//! pulls hardest at their place, drop those that have faded.

use glam::{Mat3, Quat, Vec3};

use super::adam::Moments;
use super::random::Random;
use super::schedule::{Options, Region};
use crate::splat::packed::{Core, OPACITY, POSITION, Packed, ROTATION, SCALE};

/// For each Gaussian: Σ |∂L/∂mean| in normalised device units, and in how many pictures it was seen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    pub seen: Vec<[f32; 2]>,
}

impl Statistics {
    pub fn new(count: usize) -> Self {
        Statistics { seen: vec![[0.0; 2]; count] }
    }
}

/// Whether a Gaussian keeps its place and shape. One that is nowhere does not.
#[inline(always)]
pub fn is_still(core: &Core, moving: &Region) -> bool {
    let p = [core[POSITION], core[POSITION + 1], core[POSITION + 2]];
    p.iter().all(|v| v.is_finite()) && !moving.holds(p)
}

/// One round: grows, prunes, and starts the statistics anew.
pub fn refine(
    gaussians: &mut Packed,
    moments: &mut Moments,
    statistics: &mut Statistics,
    options: &Options,
    random: &mut Random,
) {
    let density = &options.density;
    let still = |core: &Core| is_still(core, &options.moving);
    let n = gaussians.len();
    let mut pulled: Vec<(f32, usize)> = statistics
        .seen
        .iter()
        .enumerate()
        .map(|(i, [sum, count])| (sum / count.max(1.0), i))
        .filter(|(g, i)| *g > density.gradient && !still(&gaussians.core[*i]))
        .collect();
    // The hardest pulled first; ties by index.
    pulled.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let room = density.max_gaussians.saturating_sub(n);
    pulled.truncate(room.min((n as f32 * density.growth) as usize));
    let mut keep = vec![true; n];
    for (_, i) in pulled {
        let core = gaussians.core[i];
        let scales: [f32; 3] = std::array::from_fn(|k| core[SCALE + k].exp());
        let largest = scales.iter().fold(0.0f32, |a, b| a.max(*b));
        let sh = gaussians.sh[i];
        let children = if largest > density.split_scale * options.scene_extent {
            keep[i] = false;
            2
        } else {
            1
        };
        for _ in 0..children {
            let child = if children == 2 { sample(&core, scales, random) } else { core };
            gaussians.core.push(child);
            gaussians.sh.push(sh);
            moments.core.push([[0.0; 16]; 2]);
            moments.sh.push([[0.0; 48]; 2]);
            moments.steps.push(0);
        }
    }
    keep.resize(gaussians.len(), true);
    let faintest = (density.prune_opacity / (1.0 - density.prune_opacity)).ln();
    for (keep, core) in keep.iter_mut().zip(&gaussians.core) {
        *keep &= core[OPACITY] >= faintest || still(core);
    }
    let mut at = keep.iter();
    gaussians.core.retain(|_| *at.next().unwrap_or(&true));
    at = keep.iter();
    gaussians.sh.retain(|_| *at.next().unwrap_or(&true));
    at = keep.iter();
    moments.core.retain(|_| *at.next().unwrap_or(&true));
    at = keep.iter();
    moments.sh.retain(|_| *at.next().unwrap_or(&true));
    at = keep.iter();
    moments.steps.retain(|_| *at.next().unwrap_or(&true));
    *statistics = Statistics::new(gaussians.len());
}

/// A child of a split: its place drawn from the parent, 1.6 times smaller.
fn sample(core: &Core, scales: [f32; 3], random: &mut Random) -> Core {
    let q = &core[ROTATION..ROTATION + 4];
    let turn = Mat3::from_quat(Quat::from_xyzw(q[1], q[2], q[3], q[0]).normalize());
    let offset = turn * Vec3::from_array(scales.map(|s| s * random.normal()));
    let mut child = *core;
    for k in 0..3 {
        child[POSITION + k] += offset[k];
        child[SCALE + k] -= 1.6f32.ln();
    }
    child
}

/// Brings every opacity but those of Gaussians that keep still down to at most twice the pruning threshold, and forgets its moments.
pub fn reset_opacity(gaussians: &mut Packed, moments: &mut Moments, options: &Options) {
    let prune_opacity = options.density.prune_opacity;
    let most = (2.0 * prune_opacity / (1.0 - 2.0 * prune_opacity)).ln();
    let all = gaussians.core.iter_mut().zip(&mut moments.core);
    for (core, moments) in all.filter(|(core, _)| !is_still(core, &options.moving)) {
        core[OPACITY] = core[OPACITY].min(most);
        moments[0][OPACITY] = 0.0;
        moments[1][OPACITY] = 0.0;
    }
}
