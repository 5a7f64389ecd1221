//! Ancestral Euler steps for v-prediction, timesteps "trailing".
//!
//! T. Karras et al., "Elucidating the design space of diffusion-based generative models", NeurIPS 2022, in the discrete form of
//! k-diffusion and diffusers; v-prediction: T. Salimans and J. Ho, ICLR 2022; trailing timesteps: S. Lin et al., "Common
//! diffusion noise schedules and sample steps are flawed", 2023.

/// Training steps.
const TRAINED: usize = 1000;
/// Linear in β itself, unlike Stable Diffusion's own schedule.
const BETA: (f64, f64) = (0.000_85, 0.012);

/// Timesteps from noise to picture, and the noise level at each, in deviations.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    pub timesteps: Vec<f32>,
    /// One more than the timesteps: the last is 0.
    pub sigmas: Vec<f32>,
}

impl Schedule {
    /// `steps` of 1 to 1000.
    pub fn new(steps: usize) -> Schedule {
        let steps = steps.clamp(1, TRAINED);
        let mut kept = 1.0;
        let all: Vec<f64> = (0..TRAINED)
            .map(|i| {
                kept *= 1.0 - (BETA.0 + (BETA.1 - BETA.0) * i as f64 / (TRAINED - 1) as f64);
                ((1.0 - kept) / kept).sqrt()
            })
            .collect();
        let ratio = TRAINED as f64 / steps as f64;
        // Halves go to the even neighbour, as NumPy rounds.
        let times = (0..steps).map(|i| (TRAINED as f64 - i as f64 * ratio).round_ties_even() as usize - 1);
        let timesteps: Vec<usize> = times.collect();
        let mut sigmas: Vec<f32> = timesteps.iter().map(|t| all[*t] as f32).collect();
        sigmas.push(0.0);
        Schedule { timesteps: timesteps.into_iter().map(|t| t as f32).collect(), sigmas }
    }

    /// What pure noise is multiplied by.
    pub fn first_sigma(&self) -> f32 {
        self.sigmas[0]
    }
}

/// A noisy sample as the network wants it: x / √(σ² + 1).
pub fn scaled(sample: &[f32], sigma: f32) -> Vec<f32> {
    let by = 1.0 / (sigma * sigma + 1.0).sqrt();
    sample.iter().map(|x| x * by).collect()
}

/// The condition at the sample's noise level, scaled: (c + σ·n) / √(σ² + 1).
pub fn noised(clean: &[f32], noise: &[f32], sigma: f32) -> Vec<f32> {
    let by = 1.0 / (sigma * sigma + 1.0).sqrt();
    clean.iter().zip(noise).map(|(c, n)| (c + sigma * n) * by).collect()
}

/// Classifier-free guidance: without + scale · (with − without).
pub fn guided(without: &[f32], with: &[f32], scale: f32) -> Vec<f32> {
    without.iter().zip(with).map(|(n, p)| n + scale * (p - n)).collect()
}

/// One ancestral step from σ to the next σ, in place; `noise` is standard normal.
pub fn step(sample: &mut [f32], v: &[f32], noise: &[f32], sigma: f32, next: f32) {
    let (s, n) = (f64::from(sigma), f64::from(next));
    let up = (n * n * (s * s - n * n) / (s * s)).max(0.0).sqrt();
    let down = (n * n - up * up).max(0.0).sqrt();
    let (keep, take) = (1.0 / (s * s + 1.0), s / (s * s + 1.0).sqrt());
    for ((x, &v), &z) in sample.iter_mut().zip(v).zip(noise) {
        let clean = f64::from(*x) * keep - f64::from(v) * take;
        let slope = (f64::from(*x) - clean) / s;
        *x = (f64::from(*x) + slope * (down - s) + up * f64::from(z)) as f32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn golden() -> serde_json::Value {
        serde_json::from_str(include_str!("../../../tests/data/zero123_schedule.json")).unwrap()
    }

    fn list(v: &serde_json::Value) -> Vec<f32> {
        serde_json::from_value(v.clone()).unwrap()
    }

    #[test]
    fn timesteps_and_noise_levels_are_the_golden_ones() {
        for steps in [28, 75] {
            let (made, want) = (Schedule::new(steps), &golden()[steps.to_string()]);
            assert_eq!(made.timesteps, list(&want["timesteps"]));
            let sigmas = list(&want["sigmas"]);
            assert_eq!(made.sigmas.len(), sigmas.len());
            for (a, b) in made.sigmas.iter().zip(sigmas) {
                assert!((a - b).abs() <= 1e-4 * b.max(1.0), "{a} {b}");
            }
        }
        let s = Schedule::new(28);
        assert_eq!((&s.timesteps[..4], &s.timesteps[26..]), (&[999.0, 963.0, 928.0, 892.0][..], &[70.0, 35.0][..]));
        assert!((s.first_sigma() - 25.146).abs() < 1e-3, "{}", s.first_sigma());
    }

    #[test]
    fn a_step_is_the_golden_one() {
        let want = &golden()["step"];
        let mut sample = list(&want["sample"]);
        let sigma = |name: &str| want[name].as_f64().unwrap() as f32;
        step(&mut sample, &list(&want["v"]), &list(&want["noise"]), sigma("sigma"), sigma("next"));
        for (a, b) in sample.iter().zip(list(&want["result"])) {
            assert!((a - b).abs() < 1e-4 * b.abs().max(1.0), "{a} {b}");
        }
    }

    /// A network that knows the picture gives it back, whatever the noise.
    #[test]
    fn the_right_v_leads_to_the_picture() {
        let picture = [0.7f32, -0.4, 0.1];
        let schedule = Schedule::new(28);
        let mut random = crate::splat::train::random::Random::new(1);
        let mut x: Vec<f32> = picture.iter().map(|_| schedule.first_sigma() * random.normal()).collect();
        for pair in schedule.sigmas.windows(2) {
            let s = pair[0];
            // v = (x / (σ² + 1) − x₀) · √(σ² + 1) / σ.
            let v: Vec<f32> =
                x.iter().zip(picture).map(|(x, p)| (x / (s * s + 1.0) - p) * (s * s + 1.0).sqrt() / s).collect();
            let noise: Vec<f32> = x.iter().map(|_| random.normal()).collect();
            step(&mut x, &v, &noise, s, pair[1]);
        }
        assert!(x.iter().zip(picture).all(|(a, b)| (a - b).abs() < 1e-4), "{x:?}");
    }

    #[test]
    fn guidance_and_scaling_are_plain_arithmetic() {
        assert_eq!(guided(&[1.0, 2.0], &[2.0, 1.0], 4.0), [5.0, -2.0]);
        assert_eq!(guided(&[1.0], &[3.0], 1.0), [3.0]);
        assert_eq!(scaled(&[5.0], 3f32.sqrt()), [2.5]);
        assert_eq!(noised(&[1.0], &[0.0], 0.0), [1.0]);
        assert!((noised(&[1.0], &[2.0], 2.0)[0] - 5.0 / 5f32.sqrt()).abs() < 1e-6);
    }
}
