//! The parts of glTF's JSON that the reader looks at.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::meshopt::Packed;

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Root {
    #[serde(default)]
    pub asset: About,
    pub scene: Option<usize>,
    #[serde(default)]
    pub scenes: Vec<Scene>,
    #[serde(default)]
    pub nodes: Vec<Node>,
    #[serde(default)]
    pub meshes: Vec<Meshes>,
    #[serde(default)]
    pub accessors: Vec<Accessor>,
    #[serde(default)]
    pub buffer_views: Vec<View>,
    #[serde(default)]
    pub buffers: Vec<Buffer>,
    #[serde(default)]
    pub materials: Vec<Look>,
    #[serde(default)]
    pub textures: Vec<Texture>,
    #[serde(default)]
    pub images: Vec<Picture>,
    #[serde(default)]
    pub extensions_required: Vec<String>,
}

#[derive(Default, Deserialize)]
pub struct About {
    #[serde(default)]
    pub copyright: String,
    #[serde(default)]
    pub extras: serde_json::Value,
}

#[derive(Deserialize)]
pub struct Scene {
    #[serde(default)]
    pub nodes: Vec<usize>,
}

#[derive(Deserialize)]
pub struct Node {
    pub name: Option<String>,
    pub mesh: Option<usize>,
    #[serde(default)]
    pub children: Vec<usize>,
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
}

#[derive(Deserialize)]
pub struct Meshes {
    #[serde(default)]
    pub primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
pub struct Primitive {
    #[serde(default)]
    pub attributes: BTreeMap<String, usize>,
    pub indices: Option<usize>,
    pub material: Option<usize>,
    pub mode: Option<u32>,
    #[serde(default)]
    pub extensions: BTreeMap<String, serde_json::Value>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Accessor {
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: usize,
    #[serde(rename = "type")]
    pub kind: String,
    pub sparse: Option<serde_json::Value>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct View {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: Option<usize>,
    #[serde(default)]
    pub extensions: OfView,
}

#[derive(Default, Deserialize)]
pub struct OfView {
    #[serde(rename = "EXT_meshopt_compression", alias = "KHR_meshopt_compression")]
    pub packed: Option<Packed>,
}

#[derive(Deserialize)]
pub struct Buffer {
    pub uri: Option<String>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Look {
    #[serde(default)]
    pub name: String,
    #[serde(default)]
    pub pbr_metallic_roughness: Pbr,
    pub normal_texture: Option<Index>,
    pub occlusion_texture: Option<Index>,
    #[serde(default)]
    pub double_sided: bool,
    #[serde(default)]
    pub extensions: serde_json::Value,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Pbr {
    pub base_color_factor: Option<[f32; 4]>,
    pub base_color_texture: Option<Index>,
    pub metallic_factor: Option<f32>,
    pub roughness_factor: Option<f32>,
}

/// Where a material finds a texture.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Index {
    pub index: usize,
    /// The set of texture coordinates.
    #[serde(default)]
    pub tex_coord: usize,
    #[serde(default)]
    pub extensions: OfTexture,
}

#[derive(Default, Deserialize)]
pub struct OfTexture {
    #[serde(rename = "KHR_texture_transform")]
    pub shift: Option<Shift>,
}

/// How texture coordinates are changed: scaled, then turned, then moved.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Shift {
    #[serde(default)]
    pub offset: [f64; 2],
    /// Radians.
    #[serde(default)]
    pub rotation: f64,
    pub scale: Option<[f64; 2]>,
    /// In place of the texture's own.
    pub tex_coord: Option<usize>,
}

#[derive(Deserialize)]
pub struct Texture {
    pub source: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Picture {
    pub buffer_view: Option<usize>,
    pub mime_type: Option<String>,
}
