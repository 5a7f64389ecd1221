//! Textures of a level: their texel size, their mip chain, and where each mip is filed.
//!
//! Source: OGC CDB 1.x Volume 6, §6.13 "Textures" (Requirement 40: every mip is its own file, filed by its own texel size).

use super::geocell::LODS;
use super::lod;
use crate::{Error, Image, Mesh, Result};

/// A texture and its mips.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Texels a metre at full size, as the descriptor says it: six digits.
    pub resolution: f64,
    /// Full size first, each half of the one before, down to 1 × 1.
    pub mips: Vec<Image>,
}

impl Texture {
    /// The texture of a level.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for sides that are no powers of two from 2 to 65536/2, a wrong number of pixels, or a mesh
    /// that covers no texel.
    pub fn new(mesh: &Mesh, image: &Image) -> Result<Texture> {
        check(image)?;
        let texel = texel_size(mesh, image)?;
        // The level of detail must follow from what the descriptor tells, so rounding comes first.
        Ok(Texture { resolution: six_digits(1.0 / texel), mips: mips(image) })
    }

    /// The powers of two of the larger sides of the mips that can be filed: (smallest, largest).
    pub fn mipmap(&self) -> (u32, u32) {
        let last = log2(&self.mips[0]);
        let filed = self.filed().count() as u32;
        (last + 1 - filed, last)
    }

    /// Each mip and the level of detail of its texel size; LOD −10 ends the chain.
    pub fn filed(&self) -> impl Iterator<Item = (i8, &Image)> {
        filing(self.resolution).zip(&self.mips)
    }

    /// The first mip whose sides are at most `side`, and its texels a metre.
    pub fn within(&self, side: u32) -> (&Image, f64) {
        let fits = |m: &Image| m.width <= side && m.height <= side;
        let i = self.mips.iter().position(fits).unwrap_or(self.mips.len() - 1);
        (&self.mips[i], six_digits(self.resolution / 2f64.powi(i as i32)))
    }
}

/// The levels of detail of a full-size texture of a resolution and of its mips: each mip one coarser.
pub fn filing(resolution: f64) -> impl Iterator<Item = i8> {
    let finest = lod::of_texel(1.0 / resolution);
    (*LODS.start()..=finest).rev()
}

/// A value as six decimal digits say it.
fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// An image's larger side.
pub fn side(image: &Image) -> u32 {
    image.width.max(image.height)
}

/// The power of two of an image's larger side.
pub fn log2(image: &Image) -> u32 {
    side(image).max(1).ilog2()
}

fn check(image: &Image) -> Result<()> {
    let refuse = |what: String| Err(Error::Unsupported { format: "CDB texture", what });
    let (w, h, c) = (image.width, image.height, image.channels);
    if !w.is_power_of_two() || !h.is_power_of_two() || w < 2 || h < 2 || w > 1 << 15 || h > 1 << 15 {
        return refuse(format!("sides must be powers of two from 2 to 32768, found {w} × {h}"));
    }
    if !(1..=4).contains(&c) || image.pixels.len() != w as usize * h as usize * usize::from(c) {
        return refuse(format!("{w} × {h} pixels of {c} channels need as many bytes, found {}", image.pixels.len()));
    }
    Ok(())
}

/// Metres a texel: the root of the surface's area over the texels that its texture coordinates cover.
fn texel_size(mesh: &Mesh, image: &Image) -> Result<f64> {
    let (mut area, mut covered) = (0.0, 0.0);
    for t in &mesh.triangles {
        let p = t.map(|i| mesh.positions[i as usize]);
        let uv = t.map(|i| mesh.uvs[i as usize].map(f64::from));
        let side = |a: usize| -> [f64; 3] { std::array::from_fn(|k| p[a][k] - p[0][k]) };
        let (a, b) = (side(1), side(2));
        let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        area += 0.5 * cross.iter().map(|c| c * c).sum::<f64>().sqrt();
        let (u, v) = ([uv[1][0] - uv[0][0], uv[2][0] - uv[0][0]], [uv[1][1] - uv[0][1], uv[2][1] - uv[0][1]]);
        covered += 0.5 * (u[0] * v[1] - u[1] * v[0]).abs();
    }
    let texel = (area / (covered * f64::from(image.width) * f64::from(image.height))).sqrt();
    if texel.is_finite() && texel > 0.0 {
        return Ok(texel);
    }
    Err(Error::Unsupported {
        format: "CDB texture",
        what: format!("a surface of {area} m² that covers {covered} of its texture has no texel size; map the mesh"),
    })
}

/// Halves the image until 1 × 1, each texel the mean of two by two, in linear light; alpha is averaged as it is.
fn mips(image: &Image) -> Vec<Image> {
    let (linear, limits) = light();
    let mut chain = vec![image.clone()];
    while let Some(last) = chain.last().filter(|m| m.width > 1 || m.height > 1) {
        chain.push(halved(last, &linear, &limits));
    }
    chain
}

/// An image of half the sides, each texel the mean of two by two in linear light.
pub fn half(image: &Image) -> Image {
    let (linear, limits) = light();
    halved(image, &linear, &limits)
}

/// Linear light of every byte, and the limits between bytes: halfway between neighbours in sRGB, so that the byte of a
/// linear value is the number of limits below it.
fn light() -> (Vec<f32>, Vec<f32>) {
    let linear = (0..=255u8).map(|v| to_linear(f32::from(v) / 255.0)).collect();
    let limits = (0..255u8).map(|v| to_linear((f32::from(v) + 0.5) / 255.0)).collect();
    (linear, limits)
}

fn halved(image: &Image, linear: &[f32], limits: &[f32]) -> Image {
    let channels = usize::from(image.channels);
    let (width, height) = ((image.width / 2).max(1), (image.height / 2).max(1));
    let (step_x, step_y) = (image.width / width, image.height / height);
    let count = step_x * step_y;
    let mut pixels = Vec::with_capacity(width as usize * height as usize * channels);
    for y in 0..height {
        for x in 0..width {
            for c in 0..channels {
                let alpha = channels.is_multiple_of(2) && c == channels - 1;
                let texels = (0..count).map(|i| {
                    let (sx, sy) = (x * step_x + i % step_x, y * step_y + i / step_x);
                    image.pixels[(sy as usize * image.width as usize + sx as usize) * channels + c]
                });
                pixels.push(if alpha {
                    ((texels.map(u32::from).sum::<u32>() + count / 2) / count) as u8
                } else {
                    let mean = texels.map(|v| linear[usize::from(v)]).sum::<f32>() / count as f32;
                    limits.partition_point(|&limit| limit <= mean) as u8
                });
            }
        }
    }
    Image { width, height, channels: image.channels, pixels }
}

/// IEC 61966-2-1.
fn to_linear(v: f32) -> f32 {
    if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of `side` metres on the whole texture.
    fn square(side: f64) -> Mesh {
        Mesh {
            positions: vec![[0.0, 0.0, 0.0], [side, 0.0, 0.0], [side, side, 0.0], [0.0, side, 0.0]],
            normals: vec![[0.0, 0.0, 1.0]; 4],
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        }
    }

    fn grey(width: u32, height: u32, value: u8) -> Image {
        Image { width, height, channels: 3, pixels: vec![value; (width * height * 3) as usize] }
    }

    #[test]
    fn the_chain_ends_at_one_texel_and_is_filed_by_texel_size() {
        // 512 texels over 5.12 m: one centimetre, LOD 10.
        let t = Texture::new(&square(5.12), &grey(512, 128, 77)).unwrap();
        let sides: Vec<_> = t.mips.iter().map(|m| (m.width, m.height)).collect();
        assert_eq!(sides.len(), 10, "max(n, m) + 1 files");
        assert_eq!((sides[0], sides[7], sides[8], sides[9]), ((512, 128), (4, 1), (2, 1), (1, 1)));
        let square = Texture::new(&square(5.12), &grey(512, 512, 77)).unwrap();
        assert_eq!(square.resolution, 100.0);
        assert_eq!(square.filed().map(|(l, _)| l).collect::<Vec<_>>(), (1..=10).rev().collect::<Vec<_>>());
        for (lod, mip) in square.filed() {
            let texel = 5.12 / f64::from(mip.width);
            assert_eq!(lod::of_texel(texel), lod);
            assert!(mip.pixels.iter().all(|&v| v == 77), "a flat colour stays");
        }
        assert_eq!(square.mipmap(), (0, 9));
        assert_eq!((square.within(128).0.width, square.within(128).1), (128, 25.0));
        assert_eq!(square.within(4096).0.width, 512);
    }

    #[test]
    fn a_chain_past_the_coarsest_level_is_cut() {
        let t = Texture::new(&square(2e6), &grey(1024, 1024, 1)).unwrap();
        assert_eq!(t.filed().map(|(l, _)| l).collect::<Vec<_>>(), [-8, -9, -10]);
        assert_eq!(t.mipmap(), (8, 10));
    }

    #[test]
    fn mips_average_light_not_code_values() {
        let mut image = grey(2, 2, 0);
        image.pixels[..6].fill(255);
        assert_eq!(mips(&image)[1].pixels, [188; 3], "half of white light is 188 in sRGB");
        let alpha = Image { width: 2, height: 2, channels: 2, pixels: vec![9, 255, 9, 255, 9, 0, 9, 1] };
        assert_eq!(mips(&alpha)[1].pixels, [9, 128]);
    }

    #[test]
    fn textures_that_cannot_be_filed_are_refused() {
        for image in [
            grey(3, 4, 0),
            grey(1, 4, 0),
            Image { channels: 5, ..grey(4, 4, 0) },
            Image { pixels: vec![], ..grey(4, 4, 0) },
        ] {
            assert!(Texture::new(&square(1.0), &image).is_err());
        }
        let unmapped = Mesh { uvs: vec![[0.0; 2]; 4], ..square(1.0) };
        assert!(Texture::new(&unmapped, &grey(4, 4, 0)).unwrap_err().to_string().contains("map the mesh"));
    }
}
