//! 3D Gaussian Splatting as Markov Chain Monte Carlo (Kheradmand et al. 2024) on the CPU: dead Gaussians move to live
//! ones, drawn in proportion to their opacity, and a few more join them, up to a hard cap. The GPU does the same in
//! shaders/mcmc*.wgsl.

use glam::{Mat3, Quat, Vec3};

use super::adam::Moments;
use super::density::{Statistics, is_still};
use super::random::{Random, hash};
use super::schedule::{Density, Options};
use crate::splat::packed::{Core, OPACITY, POSITION, Packed, ROTATION, SCALE};

/// Steepness and scale of the noise as in gsplat: times the position's rate.
pub const NOISE: f32 = 5e5;
/// Weight of mean opacity and of mean scale in the loss.
pub const REGULARISER: f32 = 0.01;
/// Copies that share one Gaussian's look.
const MOST_COPIES: u32 = 51;

fn opaque(logit: f32) -> f32 {
    1.0 / (1.0 + (-logit).exp())
}

/// How many there are after a round.
pub fn grown(count: usize, density: &Density) -> usize {
    ((count as f64 * (1.0 + f64::from(density.growth))) as usize).min(density.max_gaussians).max(count)
}

/// One round.
pub fn relocate(
    gaussians: &mut Packed,
    moments: &mut Moments,
    statistics: &mut Statistics,
    options: &Options,
    random: &mut Random,
) {
    let density = &options.density;
    let n = gaussians.len();
    let mut running = Vec::with_capacity(n);
    let mut sum = 0.0f64;
    let mut targets = Vec::new();
    for (i, core) in gaussians.core.iter().enumerate() {
        let o = opaque(core[OPACITY]);
        if is_still(core, &options.moving) {
            // Neither dead nor copied.
        } else if o > density.prune_opacity {
            sum += f64::from(o);
        } else {
            targets.push(i);
        }
        running.push(sum);
    }
    if sum <= 0.0 {
        return;
    }
    targets.extend(n..grown(n, density));
    let mut chosen = vec![0u32; n];
    let sources: Vec<usize> = targets
        .iter()
        .map(|_| {
            let at = f64::from(random.uniform()) * sum;
            let source = running.partition_point(|r| *r <= at).min(n - 1);
            chosen[source] += 1;
            source
        })
        .collect();
    for (i, m) in chosen.iter().enumerate().filter(|(_, m)| **m > 0) {
        let o = opaque(gaussians.core[i][OPACITY]);
        let (opacity, scale) = shared(o, m + 1, density.prune_opacity);
        let core = &mut gaussians.core[i];
        core[OPACITY] = (opacity / (1.0 - opacity)).ln();
        core[SCALE..SCALE + 3].iter_mut().for_each(|s| *s += scale.ln());
        moments.core[i] = [[0.0; 16]; 2];
        moments.sh[i] = [[0.0; 48]; 2];
        moments.steps[i] = 0;
    }
    for (to, from) in targets.into_iter().zip(sources) {
        let (core, sh) = (gaussians.core[from], gaussians.sh[from]);
        if to == gaussians.len() {
            gaussians.core.push(core);
            gaussians.sh.push(sh);
            moments.core.push([[0.0; 16]; 2]);
            moments.sh.push([[0.0; 48]; 2]);
            moments.steps.push(0);
        } else {
            gaussians.core[to] = core;
            gaussians.sh[to] = sh;
            moments.core[to] = [[0.0; 16]; 2];
            moments.sh[to] = [[0.0; 48]; 2];
            moments.steps[to] = 0;
        }
    }
    *statistics = Statistics::new(gaussians.len());
}

/// Opacity and scale factor of each of `n` that together look as one of opacity `o` did (Eq. 9).
fn shared(o: f32, n: u32, faintest: f32) -> (f32, f32) {
    let n = n.min(MOST_COPIES);
    let next = (1.0 - (1.0 - f64::from(o)).powf(1.0 / f64::from(n))).clamp(f64::from(faintest), 0.999_999);
    let mut sum = 0.0;
    for j in 1..=n {
        // C(j−1, k) (−1)^k o'^(k+1)
        let mut term = next;
        for k in 0..j {
            sum += term / f64::from(k + 1).sqrt();
            term *= -next * f64::from(j - 1 - k) / f64::from(k + 1);
        }
    }
    (next as f32, (f64::from(o) / sum) as f32)
}

/// Pushes a Gaussian at random along its own shape, the fainter the harder. `rate`: [`NOISE`] times the position's rate.
pub fn disturb(core: &mut Core, rate: f32, seed: u64) {
    let gate = opaque(-100.0 * (opaque(core[OPACITY]) - 0.005));
    let mut random = Random::new(hash(seed));
    let n = Vec3::new(random.normal(), random.normal(), random.normal());
    let q = &core[ROTATION..ROTATION + 4];
    let turn = Mat3::from_quat(Quat::from_xyzw(q[1], q[2], q[3], q[0]).normalize());
    let variance = Vec3::from_array(std::array::from_fn(|k| (2.0 * core[SCALE + k]).exp()));
    let push = rate * gate * (turn * (variance * (turn.transpose() * n)));
    if push.is_finite() {
        (0..3).for_each(|k| core[POSITION + k] += push[k]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::render::tests::scene;

    #[test]
    fn copies_look_as_one_did() {
        // Along a ray through the centre, n of opacity o' let through what one of opacity o did.
        for (o, n) in [(0.3f32, 2), (0.9, 5), (0.99, 20)] {
            let (each, scale) = shared(o, n, 0.005);
            assert!(((1.0 - each).powi(n as i32) - (1.0 - o)).abs() < 1e-5);
            // n = 1 changes nothing; more copies, each fainter, must be wider only where the sum falls short.
            assert!(scale > 0.5 && scale < 1.5, "{o} {n}: {scale}");
        }
        let (each, scale) = shared(0.4, 1, 0.005);
        assert!((each - 0.4).abs() < 1e-6 && (scale - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_dead_move_and_the_cap_holds() {
        let mut g = Packed::pack(&scene(50, 0.1, 3));
        g.core.iter_mut().for_each(|c| c[OPACITY] = 1.0);
        for i in 0..10 {
            g.core[i][OPACITY] = -9.0;
        }
        g.core[10][OPACITY] = f32::NAN;
        let mut moments = Moments::new(&g);
        moments.steps.fill(5);
        let mut statistics = Statistics::new(50);
        let d = Density { growth: 0.05, max_gaussians: 51, ..Options::default().density };
        let o = Options { density: d, ..Options::default() };
        relocate(&mut g, &mut moments, &mut statistics, &o, &mut Random::new(1));
        assert_eq!((g.len(), moments.steps.len(), statistics.seen.len()), (51, 51, 51));
        assert!(g.core.iter().all(|c| opaque(c[OPACITY]) > d.prune_opacity));
        assert!(moments.steps[..11].iter().all(|s| *s == 0));
        assert_eq!(grown(100, &Density { max_gaussians: 90, ..d }), 100);
    }
}
