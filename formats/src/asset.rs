//! Triangles with materials, images and a label: what GLB and USDZ write and read.

use crate::{Label, Mesh, Splats};

/// A model as glTF and USD hold it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Asset {
    pub name: String,
    pub parts: Vec<Part>,
    pub materials: Vec<Material>,
    pub images: Vec<EncodedImage>,
    /// Y up: x right, y up, z to the viewer, as in the file. Turning splats needs their harmonics turned, which is the
    /// caller's to do.
    pub splats: Option<Splats>,
    pub label: Label,
}

/// Triangles of one material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Part {
    /// Z up, metres.
    pub mesh: Mesh,
    /// Index into [`Asset::materials`].
    pub material: Option<usize>,
}

/// A metallic-roughness material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub name: String,
    /// Linear red, green, blue and opacity, times the image.
    pub base_color: [f32; 4],
    /// Index into [`Asset::images`].
    pub image: Option<usize>,
    /// Index of an image of normals: tangent space, +X right and +Y up in the image, −1..1 as 0..1 of linear RGB.
    pub normal_image: Option<usize>,
    /// Index of an image whose red says, linearly, how much light from around arrives.
    pub occlusion_image: Option<usize>,
    pub metallic: f32,
    pub roughness: f32,
    pub double_sided: bool,
    /// The image is what is seen, light and all: a photo's.
    pub unlit: bool,
}

impl Default for Material {
    /// White, matt.
    fn default() -> Self {
        Material {
            name: String::new(),
            base_color: [1.0; 4],
            image: None,
            normal_image: None,
            occlusion_image: None,
            metallic: 0.0,
            roughness: 1.0,
            double_sided: false,
            unlit: false,
        }
    }
}

/// A PNG or JPEG file inside the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EncodedImage {
    /// `image/png` or `image/jpeg`.
    pub media_type: String,
    pub bytes: Vec<u8>,
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::Place;

    /// A unit square in the XZ plane facing −Y, the photo's side.
    fn square() -> Mesh {
        Mesh {
            positions: vec![[0.0, 0.25, 0.0], [1.0, 0.25, 0.0], [1.0, 0.25, 2.0], [0.0, 0.25, 2.0]],
            normals: vec![[0.0, -1.0, 0.0]; 4],
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        }
    }

    pub fn label() -> Label {
        let place = Place { latitude: 34.5523, longitude: -118.4712, height: 740.0, heading: 12.5 };
        Label { marking: "CLASSIFICATION: UNCLASSIFIED".into(), place: Some(place) }
    }

    /// One white pixel.
    fn png() -> EncodedImage {
        let bytes = [
            137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0, 58,
            126, 155, 85, 0, 0, 0, 10, 73, 68, 65, 84, 8, 215, 99, 248, 15, 0, 1, 1, 1, 0, 27, 182, 238, 86, 0, 0, 0,
            0, 73, 69, 78, 68, 174, 66, 96, 130,
        ];
        EncodedImage { media_type: "image/png".into(), bytes: bytes.to_vec() }
    }

    pub fn asset() -> Asset {
        let textured = Material {
            name: "photo".into(),
            image: Some(0),
            normal_image: Some(1),
            occlusion_image: Some(2),
            ..Material::default()
        };
        let plain = Material { name: "plain".into(), base_color: [0.5, 0.25, 1.0, 1.0], ..Material::default() };
        let mut bare = square();
        bare.uvs.fill([0.0, 1.0]); // what a part without texture reads back
        bare.positions.iter_mut().for_each(|p| p[1] = -3.0);
        Asset {
            name: "gate".into(),
            parts: vec![Part { mesh: square(), material: Some(0) }, Part { mesh: bare, material: Some(1) }],
            materials: vec![textured, plain],
            images: vec![png(); 3],
            splats: None,
            label: label(),
        }
    }
}
