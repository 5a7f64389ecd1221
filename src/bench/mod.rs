//! Orb-Bench: seven domains, thirty metrics. One file a domain, plain functions over slices; [`evaluate`] runs them all
//! on one scene and one result, [`score`] adds them up. `docs/orb-bench.md` says what each is.

pub mod alignment;
pub mod catalogue;
pub mod consistency;
pub mod efficiency;
pub mod evaluate;
pub mod geometry;
pub mod make;
pub mod perception;
pub mod physics;
pub mod report;
pub mod scene;
pub mod score;
pub mod submission;
pub mod surfaces;
pub mod temporal;
pub mod truth;
pub mod unit;

#[cfg(test)]
mod tests;

/// A picture, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    pub width: usize,
    pub height: usize,
    /// sRGB, 0..1.
    pub pixels: Vec<[f32; 3]>,
}

impl Picture {
    pub fn new(width: usize, height: usize, pixels: Vec<[f32; 3]>) -> Self {
        debug_assert_eq!(pixels.len(), width * height);
        Picture { width, height, pixels }
    }

    pub fn of_rgb(image: &image::RgbImage) -> Self {
        let pixels = image.pixels().map(|p| p.0.map(|v| f32::from(v) / 255.0)).collect();
        Picture { width: image.width() as usize, height: image.height() as usize, pixels }
    }

    /// Over a background of one colour.
    pub fn of_rgba(image: &image::RgbaImage, behind: [f32; 3]) -> Self {
        let over = |p: &image::Rgba<u8>| {
            let a = f32::from(p.0[3]) / 255.0;
            std::array::from_fn(|k| f32::from(p.0[k]) / 255.0 * a + behind[k] * (1.0 - a))
        };
        let pixels = image.pixels().map(over).collect();
        Picture { width: image.width() as usize, height: image.height() as usize, pixels }
    }

    /// Eight bits, rounded.
    pub fn to_rgb(&self) -> image::RgbImage {
        crate::preview::from_floats(self.width, self.height, &self.pixels)
    }

    /// ITU-R BT.601 luma of the coded values, as SSIM's authors take it.
    pub fn luma(&self) -> Vec<f32> {
        self.pixels.iter().map(|p| 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]).collect()
    }
}
