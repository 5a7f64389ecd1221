//! Several materials → one texture: every level of detail has one.

use glam::Vec2;
use image::{Rgb, RgbImage};
use orb_formats::asset::{Asset, Part};

use crate::mesh::color::{to_byte, to_linear};
use crate::{Error, Result};

/// Texels around each picture that repeat its edge, so that filters do not mix neighbours.
const PAD: u32 = 2;
/// Across a material without a picture.
const FLAT: u32 = 4;
/// Across the whole texture at most.
const MAX: u32 = 4096;

/// The asset's parts as one mesh with one texture, sides powers of two. Base colours are multiplied in.
///
/// # Errors
/// Usage for pictures that cannot be decoded, that do not fit together, or that a part repeats too often.
pub fn merge(asset: &Asset) -> Result<(orb_formats::Mesh, RgbImage)> {
    let pictures = asset.images.iter().map(|i| {
        image::load_from_memory(&i.bytes)
            .map(|p| p.into_rgb8())
            .map_err(|e| Error::usage("a texture of the model").expected("PNG or JPEG").found(e.to_string()))
    });
    let pictures: Vec<RgbImage> = pictures.collect::<Result<_>>()?;
    // One tile for each material, as wide as its parts repeat it.
    let mut tiles: Vec<Tile> = Vec::new();
    for part in &asset.parts {
        let (low, high) = repeats(part, textured(asset, part));
        match tiles.iter_mut().find(|t| t.material == part.material) {
            Some(tile) => (tile.low, tile.high) = (tile.low.min(low), tile.high.max(high)),
            None => tiles.push(Tile { material: part.material, low, high, image: RgbImage::new(0, 0), at: [0; 2] }),
        }
    }
    for tile in &mut tiles {
        tile.image = tile.draw(asset, &pictures)?;
    }
    if let [one] = tiles.as_slice()
        && one.image.width().is_power_of_two()
        && one.image.height().is_power_of_two()
        && one.image.width().max(one.image.height()) <= MAX
    {
        let texture = one.image.clone();
        return Ok((join(asset, |_, uv| (uv - one.low) / (one.high - one.low)), texture));
    }
    let size = place(&mut tiles)?;
    let mut texture = RgbImage::new(size, size);
    for tile in &tiles {
        let (w, h) = tile.image.dimensions();
        for y in 0..h + 2 * PAD {
            for x in 0..w + 2 * PAD {
                let from = |v: u32, most: u32| v.saturating_sub(PAD).min(most - 1);
                texture.put_pixel(tile.at[0] + x, tile.at[1] + y, *tile.image.get_pixel(from(x, w), from(y, h)));
            }
        }
    }
    let mesh = join(asset, |part, uv| {
        let Some(tile) = tiles.iter().find(|t| t.material == part.material) else { return Vec2::ZERO };
        let inside = ((uv - tile.low) / (tile.high - tile.low)).clamp(Vec2::ZERO, Vec2::ONE);
        let (w, h) = (tile.image.width() as f32, tile.image.height() as f32);
        // v counts from the bottom, rows from the top.
        let x = (tile.at[0] + PAD) as f32 + inside.x * w;
        let y = (tile.at[1] + PAD) as f32 + (1.0 - inside.y) * h;
        Vec2::new(x, size as f32 - y) / size as f32
    });
    Ok((mesh, texture))
}

struct Tile {
    material: Option<usize>,
    /// Whole numbers around the texture coordinates.
    low: Vec2,
    high: Vec2,
    image: RgbImage,
    at: [u32; 2],
}

fn textured(asset: &Asset, part: &Part) -> bool {
    part.material.is_some_and(|m| asset.materials[m].image.is_some())
}

/// The whole numbers around a part's texture coordinates, 0 and 1 where one picture is enough.
fn repeats(part: &Part, textured: bool) -> (Vec2, Vec2) {
    if !textured {
        return (Vec2::ZERO, Vec2::ONE);
    }
    // A hair outside is the writer's rounding, not a repetition.
    const HAIR: f32 = 1e-3;
    let mut low = Vec2::splat(f32::INFINITY);
    let mut high = Vec2::splat(f32::NEG_INFINITY);
    for uv in &part.mesh.uvs {
        low = low.min(Vec2::from_array(*uv));
        high = high.max(Vec2::from_array(*uv));
    }
    let low = (low + HAIR).floor();
    (low, (high - HAIR).ceil().max(low + 1.0))
}

impl Tile {
    fn draw(&self, asset: &Asset, pictures: &[RgbImage]) -> Result<RgbImage> {
        let material = self.material.map(|m| &asset.materials[m]);
        let factor = material.map_or([1.0; 3], |m| [m.base_color[0], m.base_color[1], m.base_color[2]]);
        // The factor is linear, pictures are sRGB.
        let tint = |c: u8, k: usize| to_byte(to_linear(f32::from(c) / 255.0) * factor[k]);
        let Some(picture) = material.and_then(|m| m.image).map(|i| &pictures[i]) else {
            return Ok(RgbImage::from_pixel(FLAT, FLAT, Rgb(std::array::from_fn(|k| tint(255, k)))));
        };
        let (w, h) = picture.dimensions();
        let count = (self.high - self.low).to_array();
        let across = [w as f32 * count[0], h as f32 * count[1]];
        // None at all where coordinates are so large that their whole numbers are not told apart.
        if !across.iter().all(|a| (1.0..=MAX as f32).contains(a)) {
            return Err(Error::usage("a texture of the model")
                .expected(format!("repetitions that fit into {MAX} texels"))
                .found(format!("{w} × {h} texels repeated {} × {} times", count[0], count[1]))
                .advice("Bake the repetition into the texture first."));
        }
        let (columns, rows) = (count[0] as u32, count[1] as u32);
        Ok(RgbImage::from_fn(w * columns, h * rows, |x, y| {
            let Rgb(c) = picture.get_pixel(x % w, y % h);
            Rgb(std::array::from_fn(|k| tint(c[k], k)))
        }))
    }
}

/// Shelves of falling height in the smallest square that holds them; its side.
fn place(tiles: &mut [Tile]) -> Result<u32> {
    let mut order: Vec<usize> = (0..tiles.len()).collect();
    order.sort_by_key(|&i| std::cmp::Reverse(tiles[i].image.height()));
    let mut size = 16;
    while size <= MAX {
        let (mut x, mut y, mut shelf) = (0, 0, 0);
        let mut fits = true;
        for &i in &order {
            let (w, h) = (tiles[i].image.width() + 2 * PAD, tiles[i].image.height() + 2 * PAD);
            if x + w > size {
                (x, y, shelf) = (0, y + shelf, 0);
            }
            fits &= x + w <= size && y + h <= size;
            tiles[i].at = [x, y];
            x += w;
            shelf = shelf.max(h);
        }
        if fits {
            return Ok(size);
        }
        size *= 2;
    }
    Err(Error::usage("the model's textures")
        .expected(format!("pictures that fit into one of {MAX} × {MAX} texels"))
        .advice("Make the model's textures smaller first."))
}

fn join(asset: &Asset, uv: impl Fn(&Part, Vec2) -> Vec2) -> orb_formats::Mesh {
    let mut out = orb_formats::Mesh::default();
    for part in &asset.parts {
        let first = out.positions.len() as u32;
        out.positions.extend_from_slice(&part.mesh.positions);
        out.normals.extend_from_slice(&part.mesh.normals);
        out.uvs.extend(part.mesh.uvs.iter().map(|t| uv(part, Vec2::from_array(*t)).to_array()));
        out.triangles.extend(part.mesh.triangles.iter().map(|t| t.map(|v| v + first)));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use orb_formats::asset::{EncodedImage, Material};

    fn picture(w: u32, h: u32) -> EncodedImage {
        let image = RgbImage::from_fn(w, h, |x, y| Rgb([(x * 40) as u8, (y * 40) as u8, 7]));
        let mut bytes = std::io::Cursor::new(Vec::new());
        image.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        EncodedImage { media_type: "image/png".into(), bytes: bytes.into_inner() }
    }

    fn part(material: Option<usize>, uvs: [[f32; 2]; 3]) -> Part {
        let mesh = orb_formats::Mesh {
            positions: vec![[0.0; 3]; 3],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            uvs: uvs.to_vec(),
            triangles: vec![[0, 1, 2]],
        };
        Part { mesh, material }
    }

    fn color_at(texture: &RgbImage, uv: [f32; 2]) -> [u8; 3] {
        let (w, h) = (texture.width() as f32, texture.height() as f32);
        let at = |v: f32, n: f32| ((v * n).floor() as u32).min(n as u32 - 1);
        texture.get_pixel(at(uv[0], w), at(1.0 - uv[1], h)).0
    }

    #[test]
    fn every_part_keeps_its_colours() {
        let red = Material { base_color: [1.0, 0.0, 0.0, 1.0], ..Material::default() };
        let photo = Material { image: Some(0), ..Material::default() };
        // The centres of three texels of 4 × 4, the last a repetition to the right.
        let uvs = [[0.125, 0.875], [0.875, 0.125], [1.375, 0.625]];
        let asset = Asset {
            parts: vec![part(Some(0), uvs), part(Some(1), [[9.0, -3.0]; 3]), part(None, uvs)],
            materials: vec![photo, red],
            images: vec![picture(4, 4)],
            ..Asset::default()
        };
        let (mesh, texture) = merge(&asset).unwrap();
        assert!(texture.width().is_power_of_two() && texture.height().is_power_of_two());
        assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 5], [6, 7, 8]]);
        let colors: Vec<[u8; 3]> = mesh.uvs.iter().map(|uv| color_at(&texture, *uv)).collect();
        assert_eq!(colors[..3], [[0, 0, 7], [120, 120, 7], [40, 40, 7]]);
        assert_eq!(colors[3..], [[255, 0, 0], [255, 0, 0], [255, 0, 0], [255; 3], [255; 3], [255; 3]]);
    }

    #[test]
    fn coordinates_too_large_to_have_a_fraction_are_refused() {
        let photo = Material { image: Some(0), ..Material::default() };
        for large in [[1e9, 0.5], [0.5, -1e9], [1e30, 1e30]] {
            let (materials, images) = (vec![photo.clone()], vec![picture(4, 4)]);
            let asset = Asset { parts: vec![part(Some(0), [large; 3])], materials, images, ..Asset::default() };
            assert!(merge(&asset).unwrap_err().found.contains("repeated"), "{large:?}");
        }
    }

    #[test]
    fn one_picture_stays_as_it_is() {
        let uvs = [[0.0, 0.0], [1.0, 0.0], [0.3, 1.0]];
        let asset = Asset {
            parts: vec![part(Some(0), uvs)],
            materials: vec![Material { image: Some(0), ..Material::default() }],
            images: vec![picture(8, 4)],
            ..Asset::default()
        };
        let (mesh, texture) = merge(&asset).unwrap();
        assert_eq!((texture.dimensions(), mesh.uvs), ((8, 4), uvs.to_vec()));
    }

    #[test]
    fn what_does_not_fit_is_named() {
        let mut asset = Asset {
            parts: vec![part(Some(0), [[0.0, 0.0], [2000.0, 0.0], [0.0, 1.0]])],
            materials: vec![Material { image: Some(0), ..Material::default() }],
            images: vec![picture(4, 4)],
            ..Asset::default()
        };
        assert!(merge(&asset).unwrap_err().to_string().contains("2000"));
        asset.images[0].bytes.truncate(20);
        assert!(merge(&asset).unwrap_err().to_string().contains("PNG or JPEG"));
    }
}
