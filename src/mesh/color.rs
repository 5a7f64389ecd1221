//! sRGB and linear light (IEC 61966-2-1).

pub fn to_linear(c: f32) -> f32 {
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

pub fn to_srgb(c: f32) -> f32 {
    if c <= 0.003_130_8 { c * 12.92 } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
}

/// Rounded to 8 bits; anything outside 0..1 is clamped, NaN is 0.
pub fn to_byte(c: f32) -> u8 {
    (to_srgb(c.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8
}

/// `to_linear` by table: 4096 steps, for whole pictures.
pub struct Linear(Vec<f32>);

impl Default for Linear {
    fn default() -> Self {
        Linear((0..=4096).map(|i| to_linear(i as f32 / 4096.0)).collect())
    }
}

impl Linear {
    pub fn of(&self, c: f32) -> f32 {
        let x = c.clamp(0.0, 1.0) * 4096.0;
        let i = (x as usize).min(4095);
        self.0[i] + (self.0[i + 1] - self.0[i]) * (x - i as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_come_back() {
        let table = Linear::default();
        for b in 0..=255u8 {
            let c = b as f32 / 255.0;
            assert_eq!(to_byte(to_linear(c)), b);
            assert!((table.of(c) - to_linear(c)).abs() < 1e-5);
        }
        assert_eq!(to_byte(f32::NAN), 0);
    }
}
