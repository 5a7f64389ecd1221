//! Asset → file.

use serde_json::{Map, Value, json};

use super::{FORMAT, SPLATTING, UNLIT, XMP, container, meshopt, splats};
use crate::asset::{Asset, Material};
use crate::mesh::unit;
use crate::{Error, Label, Mesh, Result};

pub const FLOAT: u32 = 5126;
pub const UNSIGNED_SHORT: u32 = 5123;
pub const UNSIGNED_INT: u32 = 5125;
pub const ARRAY_BUFFER: u32 = 34962;
pub const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// Writes an asset as one node with one mesh for its parts, and one with the splats.
///
/// Positions become f32; normals have length 1; triangles with two corners at one vertex are left out; texture
/// coordinates are written where the material has an image, tangents where it has one of normals (glTF 2.0, §3.7.2.1).
///
/// # Errors
/// [`Error::Unsupported`] for what the format cannot hold: a mesh that is not valid or empty, a material or an image
/// that does not exist, an image that is neither PNG nor JPEG, values that are not finite, 4 GiB and more.
pub fn write(asset: &Asset) -> Result<Vec<u8>> {
    write_as(asset, Compression::None)
}

/// How the triangles of a file are stored. Splats and images are stored as they are in any case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Compression {
    /// Floats and integers that every reader takes.
    #[default]
    None,
    /// `EXT_meshopt_compression`, which a reader must know: positions within 2⁻¹⁸ of the power of two that the largest of
    /// their axis is below, texture coordinates within 2⁻¹⁶ of it, normals within 0.06°. Vertices and triangles are put into
    /// another order, and vertices of no triangle are left out.
    Meshopt,
}

/// As [`write()`], compressed or not.
///
/// # Errors
/// As [`write()`].
pub fn write_as(asset: &Asset, compression: Compression) -> Result<Vec<u8>> {
    let unfolded = (compression == Compression::Meshopt && !asset.parts.is_empty()).then_some(0);
    let mut out = Buffer { unfolded, ..Buffer::default() };
    let mut nodes = Vec::new();
    let mut meshes = Vec::new();
    if !asset.parts.is_empty() {
        let primitives = asset.parts.iter().enumerate().map(|(i, part)| {
            if part.material.is_some_and(|m| m >= asset.materials.len()) {
                return refuse(format!("part {i} names material {:?} of {}", part.material, asset.materials.len()));
            }
            let material = part.material.map(|m| &asset.materials[m]);
            let needs = |image: fn(&Material) -> Option<usize>| material.and_then(image).is_some();
            let bumpy = needs(|m| m.normal_image);
            let textured = bumpy || needs(|m| m.image) || needs(|m| m.occlusion_image);
            let mut primitive = primitive(&part.mesh, textured, bumpy, &mut out)
                .map_err(|e| Error::unsupported(FORMAT, format!("part {i}: {e}")))?;
            if let Some(material) = part.material {
                primitive["material"] = material.into();
            }
            Ok(primitive)
        });
        let primitives: Vec<Value> = primitives.collect::<Result<_>>()?;
        nodes.push(json!({ "mesh": meshes.len(), "name": asset.name }));
        meshes.push(json!({ "name": asset.name, "primitives": primitives }));
    }
    if let Some(cloud) = &asset.splats {
        nodes.push(json!({ "mesh": meshes.len(), "name": format!("{} splats", asset.name) }));
        meshes.push(json!({ "primitives": [splats::write(cloud, &mut out)?] }));
    }
    if nodes.is_empty() {
        return refuse("an asset needs a mesh or splats".into());
    }
    let images = asset.images.iter().map(|image| {
        if !matches!(image.media_type.as_str(), "image/png" | "image/jpeg") {
            return refuse(format!("an image must be image/png or image/jpeg, found {:?}", image.media_type));
        }
        Ok(json!({ "bufferView": out.view(&image.bytes, None), "mimeType": image.media_type }))
    });
    let images: Vec<Value> = images.collect::<Result<_>>()?;
    let materials: Vec<Value> = asset.materials.iter().map(|m| material(m, images.len())).collect::<Result<_>>()?;

    let (mut used, mut required) = (Vec::new(), Vec::new());
    let mut buffers = vec![json!({ "byteLength": out.bytes.len() })];
    if let Some(length) = out.unfolded {
        buffers.push(meshopt::fallback(length));
        required = vec![meshopt::NAME, meshopt::QUANTIZATION];
        used.clone_from(&required);
    }
    if asset.splats.is_some() {
        used.push(SPLATTING);
    }
    if asset.materials.iter().any(|m| m.unlit) {
        used.push(UNLIT);
    }
    let mut root = json!({
        "asset": { "version": "2.0", "generator": "Orb" },
        "scene": 0,
        "scenes": [{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }],
        "nodes": nodes,
        "meshes": meshes,
        "accessors": out.accessors,
        "bufferViews": out.views,
        "buffers": buffers,
    });
    if !materials.is_empty() {
        root["materials"] = materials.into();
    }
    if !images.is_empty() {
        root["textures"] = (0..images.len()).map(|i| json!({ "source": i, "sampler": 0 })).collect();
        root["samplers"] = json!([{ "magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071 }]);
        root["images"] = images.into();
    }
    if asset.label != Label::default() {
        used.push(XMP);
        mark(&mut root, &asset.label);
    }
    if !required.is_empty() {
        root["extensionsRequired"] = required.into();
    }
    if !used.is_empty() {
        root["extensionsUsed"] = used.into();
    }
    container::join(root.to_string().as_bytes(), &out.bytes)
}

/// The marking stands where people look (copyright), where machines look (XMP), and with the place in `extras`.
fn mark(root: &mut Value, label: &Label) {
    let mut extras = Map::new();
    let mut packet = json!({
        "@context": {
            "dc": "http://purl.org/dc/elements/1.1/",
            "rdf": "http://www.w3.org/1999/02/22-rdf-syntax-ns#",
        },
        "@id": "",
        "dc:format": "model/gltf-binary",
    });
    if !label.marking.is_empty() {
        extras.insert("marking".into(), label.marking.as_str().into());
        root["asset"]["copyright"] = label.marking.as_str().into();
        packet["dc:rights"] = json!({
            "@type": "rdf:Alt",
            "rdf:_1": { "@language": "x-default", "@value": label.marking },
        });
    }
    if let Some(p) = &label.place {
        extras.insert("place".into(), json!(p));
        packet["dc:coverage"] = format!(
            "WGS84 latitude {} longitude {} ellipsoidal height {} m, -Z points to {} degrees clockwise from true north",
            p.latitude, p.longitude, p.height, p.heading
        )
        .into();
    }
    root["asset"]["extras"] = json!({ "orb": extras });
    root["asset"]["extensions"] = json!({ XMP: { "packet": 0 } });
    root["extensions"] = json!({ XMP: { "packets": [packet] } });
}

fn material(m: &Material, images: usize) -> Result<Value> {
    let factors = m.base_color.iter().chain([&m.metallic, &m.roughness]);
    if !factors.clone().all(|f| (0.0..=1.0).contains(f)) {
        return refuse(format!("the factors of material {:?} must lie in 0..1", m.name));
    }
    let mut pbr = json!({
        "baseColorFactor": m.base_color,
        "metallicFactor": m.metallic,
        "roughnessFactor": m.roughness,
    });
    let named = [m.image, m.normal_image, m.occlusion_image];
    if let Some(image) = named.into_iter().flatten().find(|i| *i >= images) {
        return refuse(format!("material {:?} names image {image} of {images}", m.name));
    }
    if let Some(image) = m.image {
        pbr["baseColorTexture"] = json!({ "index": image });
    }
    let mut out = json!({ "pbrMetallicRoughness": pbr });
    if let Some(image) = m.normal_image {
        out["normalTexture"] = json!({ "index": image });
    }
    if let Some(image) = m.occlusion_image {
        out["occlusionTexture"] = json!({ "index": image });
    }
    if !m.name.is_empty() {
        out["name"] = m.name.as_str().into();
    }
    if m.double_sided {
        out["doubleSided"] = true.into();
    }
    if m.unlit {
        out["extensions"] = json!({ UNLIT: {} });
    }
    if m.base_color[3] < 1.0 {
        out["alphaMode"] = "BLEND".into();
    }
    Ok(out)
}

fn primitive(mesh: &Mesh, textured: bool, bumpy: bool, out: &mut Buffer) -> Result<Value> {
    mesh.validate()?;
    let whole = |t: &&[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    let corners: Vec<u32> = mesh.triangles.iter().filter(whole).flatten().copied().collect();
    if corners.is_empty() {
        return refuse("a mesh without a triangle".into());
    }
    if out.unfolded.is_some() {
        return packed_primitive(mesh, &corners, textured, bumpy, out);
    }
    let positions: Vec<[f32; 3]> = mesh.positions.iter().map(|&[x, y, z]| [x as f32, z as f32, -y as f32]).collect();
    let mut attributes = Map::new();
    attributes.insert("POSITION".into(), out.floats(&positions, true).into());
    let normals: Vec<[f32; 3]> =
        mesh.normals.iter().map(|n| unit(n.map(f64::from))).map(|[x, y, z]| [x, z, -y]).collect();
    attributes.insert("NORMAL".into(), out.floats(&normals, false).into());
    if bumpy {
        let tangents: Vec<[f32; 4]> = mesh.tangents().iter().map(|&[x, y, z, w]| [x, z, -y, w]).collect();
        attributes.insert("TANGENT".into(), out.floats(&tangents, false).into());
    }
    if textured {
        let uvs: Vec<[f32; 2]> = mesh.uvs.iter().map(|&[u, v]| [u, 1.0 - v]).collect();
        attributes.insert("TEXCOORD_0".into(), out.floats(&uvs, false).into());
    }
    // 65535 is the restart value, which no index may have.
    let short = mesh.positions.len() <= 65_535;
    let bytes: Vec<u8> = if short {
        corners.iter().flat_map(|&c| (c as u16).to_le_bytes()).collect()
    } else {
        corners.iter().flat_map(|c| c.to_le_bytes()).collect()
    };
    let view = out.view(&bytes, Some(ELEMENT_ARRAY_BUFFER));
    let component = if short { UNSIGNED_SHORT } else { UNSIGNED_INT };
    out.accessors
        .push(json!({ "bufferView": view, "componentType": component, "count": corners.len(), "type": "SCALAR" }));
    Ok(json!({ "attributes": attributes, "indices": out.accessors.len() - 1, "mode": 4 }))
}

/// The same, compressed.
fn packed_primitive(mesh: &Mesh, corners: &[u32], textured: bool, bumpy: bool, out: &mut Buffer) -> Result<Value> {
    let (corners, order) = meshopt::order(corners, mesh.positions.len())?;
    let order = || order.iter().map(|&i| i as usize);
    let mut attributes = Map::new();
    let positions: Vec<[f32; 3]> =
        order().map(|i| mesh.positions[i]).map(|[x, y, z]| [x as f32, z as f32, -y as f32]).collect();
    attributes.insert("POSITION".into(), out.packed_floats(&positions, meshopt::POSITION_BITS, true)?.into());
    let normals: Vec<[f32; 4]> =
        order().map(|i| unit(mesh.normals[i].map(f64::from))).map(|[x, y, z]| [x, z, -y, 0.0]).collect();
    attributes.insert("NORMAL".into(), out.packed_directions(&normals, false)?.into());
    if bumpy {
        let tangents = mesh.tangents();
        let tangents: Vec<[f32; 4]> = order().map(|i| tangents[i]).map(|[x, y, z, w]| [x, z, -y, w]).collect();
        attributes.insert("TANGENT".into(), out.packed_directions(&tangents, true)?.into());
    }
    if textured {
        let uvs: Vec<[f32; 2]> = order().map(|i| mesh.uvs[i]).map(|[u, v]| [u, 1.0 - v]).collect();
        attributes.insert("TEXCOORD_0".into(), out.packed_floats(&uvs, meshopt::UV_BITS, false)?.into());
    }
    let indices = out.packed_triangles(&corners, positions.len())?;
    Ok(json!({ "attributes": attributes, "indices": indices, "mode": 4 }))
}

/// The least and the most of each component, as the format wants them of positions.
pub fn bounds<const N: usize>(accessor: &mut Value, values: &[[f32; N]]) {
    let edge = |pick: fn(f32, f32) -> f32, start: f32| {
        values.iter().fold([start; N], |edge, v| std::array::from_fn(|i| pick(edge[i], v[i]))).to_vec()
    };
    accessor["min"] = edge(f32::min, f32::INFINITY).into();
    accessor["max"] = edge(f32::max, f32::NEG_INFINITY).into();
}

/// The binary chunk in the making.
#[derive(Default)]
pub struct Buffer {
    /// Where triangles are compressed: the bytes that they unfold to.
    pub unfolded: Option<usize>,
    pub bytes: Vec<u8>,
    pub views: Vec<Value>,
    pub accessors: Vec<Value>,
}

impl Buffer {
    /// Adds bytes at a multiple of 4; the number of their view.
    pub fn view(&mut self, bytes: &[u8], target: Option<u32>) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let mut view = json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = target.into();
        }
        self.bytes.extend_from_slice(bytes);
        self.views.push(view);
        self.views.len() - 1
    }

    /// Adds vectors of floats; the number of their accessor.
    pub fn floats<const N: usize>(&mut self, values: &[[f32; N]], bounded: bool) -> usize {
        let bytes: Vec<u8> = values.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let view = self.view(&bytes, Some(ARRAY_BUFFER));
        let kind = ["", "SCALAR", "VEC2", "VEC3", "VEC4"][N];
        let mut accessor = json!({ "bufferView": view, "componentType": FLOAT, "count": values.len(), "type": kind });
        if bounded {
            bounds(&mut accessor, values);
        }
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

fn refuse<T>(what: String) -> Result<T> {
    Err(Error::unsupported(FORMAT, what))
}
