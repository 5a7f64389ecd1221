//! What a run will take, said before it begins: memory by what is kept, and with it the cap on Gaussians.

/// Bytes that are held for one pixel of one photo: colour, alpha, the loss's layout of them; on a GPU besides.
const PIXEL: u64 = 16 + 20;
const PIXEL_GPU: u64 = 16;
/// Bytes of one Gaussian at the fullest moment: parameters, moments and statistics (780) with room to grow, sorted lists,
/// gradients, and the copy that a part of the run hands on.
const GAUSSIAN: u64 = 2600;
/// Where training is on a GPU: what is read back at the end, and what the GPU holds (728 and lists of about as much).
const GAUSSIAN_BESIDE_GPU: u64 = 1700;
const GAUSSIAN_GPU: u64 = 1600;
/// Part of the memory that is free that a run may take.
const SHARE: f64 = 0.7;
/// No more than this, whatever the memory.
const MOST: u64 = 10_000_000;
/// gsplat's cap for MCMC, which always fills it.
pub const MCMC: usize = 1_000_000;

/// Memory of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    pub photos: usize,
    /// Of all photos together.
    pub pixels: u64,
    pub on_gpu: bool,
    /// Bytes of main memory that are free, where the system says.
    pub free: Option<u64>,
}

impl Cost {
    /// Bytes of main memory for the photos.
    pub fn of_photos(&self) -> u64 {
        self.pixels * PIXEL
    }

    /// Bytes of main memory for so many Gaussians.
    pub fn of_gaussians(&self, count: usize) -> u64 {
        count as u64 * if self.on_gpu { GAUSSIAN_BESIDE_GPU } else { GAUSSIAN }
    }

    /// Bytes of the GPU's memory for photos and so many Gaussians; 0 without one.
    pub fn on_the_gpu(&self, count: usize) -> u64 {
        if self.on_gpu { self.pixels * PIXEL_GPU + count as u64 * GAUSSIAN_GPU } else { 0 }
    }

    /// How many Gaussians the free memory holds beside the photos; a million where nobody knows. Rounded down to two digits,
    /// so that like machines agree.
    pub fn cap(&self) -> usize {
        let Some(free) = self.free else { return MCMC };
        let left = ((free as f64 * SHARE) as u64).saturating_sub(self.of_photos());
        let each = if self.on_gpu { GAUSSIAN_BESIDE_GPU } else { GAUSSIAN };
        let count = (left / each).clamp(10_000, MOST);
        let unit = 10u64.pow(count.ilog10() - 1);
        (count / unit * unit) as usize
    }

    /// For a person, beforehand.
    pub fn words(&self, cap: usize) -> String {
        let mut out = format!(
            "{} photos of {:.1} megapixels together take {}, {cap} Gaussians up to {}",
            self.photos,
            self.pixels as f64 / 1e6,
            gib(self.of_photos()),
            gib(self.of_gaussians(cap)),
        );
        if self.on_gpu {
            out += &format!(", and {} of the GPU's memory", gib(self.on_the_gpu(cap)));
        }
        if let Some(free) = self.free {
            out += &format!("; {} of main memory are free", gib(free));
        }
        out
    }
}

/// For a person.
pub fn gib(bytes: u64) -> String {
    match bytes {
        0..0x0800_0000 => format!("{} MiB", bytes.div_ceil(1 << 20)),
        _ => format!("{:.1} GiB", bytes as f64 / f64::from(1 << 30)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cap_grows_with_memory_and_shrinks_with_photos() {
        let of = |gib: u64, megapixels: u64| {
            Cost { photos: 9, pixels: megapixels * 1_000_000, on_gpu: false, free: Some(gib << 30) }.cap()
        };
        assert!(of(4, 10) < of(8, 10) && of(8, 100) < of(8, 10));
        assert_eq!((of(1 << 20, 10), of(1, 1000)), (10_000_000, 10_000));
        let c = Cost { photos: 40, pixels: 25_600_000, on_gpu: false, free: Some(8 << 30) };
        // All of it fits what is free.
        assert!(c.of_photos() + c.of_gaussians(c.cap()) < 8 << 30 && c.cap().is_multiple_of(10_000));
        assert!(c.words(c.cap()).contains("40 photos"), "{}", c.words(c.cap()));
        assert_eq!(Cost { free: None, ..c }.cap(), MCMC);
    }
}
