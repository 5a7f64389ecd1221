//! File → asset.

use super::accessors::Accessors;
use super::json::{About, Index, Look, Picture, Primitive, Root, Shift};
use super::transform::Transform;
use super::{FORMAT, SPLATTING, TEXTURE_TRANSFORM, UNLIT, XMP, container, meshopt, splats};
use crate::asset::{Asset, EncodedImage, Material, Part};
use crate::{Error, Label, Mesh, Place, Result, Splats};

/// Extensions that a file may need: those that are read, and those that say nothing of shapes, base colours and places.
const KNOWN: [&str; 27] = [
    SPLATTING,
    TEXTURE_TRANSFORM,
    UNLIT,
    XMP,
    meshopt::NAME,
    meshopt::SUCCESSOR,
    meshopt::QUANTIZATION,
    "EXT_instance_features",
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "EXT_mesh_features",
    "EXT_structural_metadata",
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_materials_volume_scatter",
];
/// What a primitive of triangles costs at least, in vertices.
const LEAST: usize = 4;
/// What a splat costs, in vertices: its numbers take as much room.
const SPLAT: usize = 6;
/// Nodes below one another.
const MAX_DEPTH: usize = 64;

/// Reads the default scene (else the first, else every node): triangles with their nodes' transformations applied, base
/// colours and their images, splats, Orb's label.
///
/// Buffer views that are compressed by meshoptimizer are unfolded. Texture coordinates are those of the base colour (else of the
/// normals, else of the occlusion), as its `texCoord` and `KHR_texture_transform` say. Missing normals are computed; points and
/// lines, other textures, animation, skins, cameras and lights are left out.
/// What [`write`](super::write()) wrote comes back equal up to f32 positions and a v coordinate's last bit.
///
/// # Errors
/// [`Error::Malformed`] where the file breaks the format; [`Error::Unsupported`] for compressed or sparse data,
/// buffers outside the file, extensions that the file needs and that are not known, and a scene that unfolds to more than four
/// vertices a byte of the file.
pub fn read(bytes: &[u8]) -> Result<Asset> {
    let (json, bin) = container::split(bytes)?;
    let root: Root = serde_json::from_slice(json)
        .map_err(|e| Error::malformed(FORMAT, 20 + e.column(), "glTF 2.0 JSON", e.to_string()))?;
    if let Some(name) = root.extensions_required.iter().find(|e| !KNOWN.contains(&e.as_str())) {
        return Err(Error::unsupported(FORMAT, format!("the file needs {name}, which is not read; store it without")));
    }
    let accessors = Accessors::new(&root, bin);
    let mut out = Asset { materials: materials(&root)?, images: images(&accessors)?, ..Asset::default() };
    out.label = label(&root.asset);
    let scene = root.scenes.get(root.scene.unwrap_or(0));
    let starts: Vec<usize> = scene.map_or_else(|| (0..root.nodes.len()).collect(), |s| s.nodes.clone());
    let mut left = bytes.len().saturating_mul(4);
    let mut stack: Vec<(usize, Transform, usize)> = starts.iter().rev().map(|&n| (n, Transform::NONE, 0)).collect();
    while let Some((index, outer, depth)) = stack.pop() {
        let node = root.nodes.get(index).ok_or_else(|| missing("node", index))?;
        if depth > MAX_DEPTH || stack.len() > bytes.len() {
            return Err(Error::malformed(FORMAT, 20, format!("a tree of at most {MAX_DEPTH} levels"), "a deeper one"));
        }
        let here = Transform::of(node).then(&outer);
        stack.extend(node.children.iter().rev().map(|&child| (child, here, depth + 1)));
        // Every node costs something, or a tree that shares its branches would take for ever.
        left = spend(left, 1)?;
        let Some(mesh) = node.mesh else { continue };
        let mesh = root.meshes.get(mesh).ok_or_else(|| missing("mesh", mesh))?;
        if let Some(name) = node.name.as_ref().filter(|_| out.name.is_empty()) {
            out.name.clone_from(name);
        }
        for primitive in &mesh.primitives {
            if primitive.extensions.contains_key(SPLATTING) {
                left = spend(left, accessors.vertices(primitive)?.saturating_mul(SPLAT))?;
                let read = splats::read(&primitive.attributes, &accessors)?;
                add_splats(&mut out, read, &here)?;
            } else if matches!(primitive.mode.unwrap_or(4), 4..=6) {
                left = spend(left, accessors.vertices(primitive)?.max(LEAST))?;
                let material = primitive.material;
                let look = material.map(|m| root.materials.get(m).ok_or_else(|| missing("material", m))).transpose()?;
                let mesh = triangle_mesh(&accessors, primitive, look.and_then(texture_of), &here)?;
                out.parts.push(Part { mesh, material });
            } else {
                left = spend(left, 1)?;
            }
        }
    }
    Ok(out)
}

fn spend(left: usize, vertices: usize) -> Result<usize> {
    left.checked_sub(vertices)
        .ok_or_else(|| Error::unsupported(FORMAT, "the scene repeats its meshes too often; apply the instances first"))
}

/// Only nodes without a transformation: turning splats is not this reader's to do.
fn add_splats(out: &mut Asset, read: Splats, here: &Transform) -> Result<()> {
    if *here != Transform::NONE {
        return Err(Error::unsupported(FORMAT, "splats below a node with a transformation; apply it first"));
    }
    match &mut out.splats {
        None => out.splats = Some(read),
        Some(all) => {
            all.positions.extend(read.positions);
            all.log_scales.extend(read.log_scales);
            all.rotations.extend(read.rotations);
            all.logit_opacities.extend(read.logit_opacities);
            all.sh.extend(read.sh);
        }
    }
    Ok(())
}

fn materials(root: &Root) -> Result<Vec<Material>> {
    let image = |texture: &Option<Index>| {
        let source = match texture {
            None => None,
            Some(Index { index, .. }) => root.textures.get(*index).ok_or_else(|| missing("texture", *index))?.source,
        };
        match source.filter(|&i| i >= root.images.len()) {
            Some(i) => Err(missing("image", i)),
            None => Ok(source),
        }
    };
    let one = |look: &Look| {
        let pbr = &look.pbr_metallic_roughness;
        Ok(Material {
            name: look.name.clone(),
            base_color: pbr.base_color_factor.unwrap_or([1.0; 4]),
            image: image(&pbr.base_color_texture)?,
            normal_image: image(&look.normal_texture)?,
            occlusion_image: image(&look.occlusion_texture)?,
            metallic: pbr.metallic_factor.unwrap_or(1.0),
            roughness: pbr.roughness_factor.unwrap_or(1.0),
            double_sided: look.double_sided,
            unlit: look.extensions.get(UNLIT).is_some(),
        })
    };
    root.materials.iter().map(one).collect()
}

fn images(accessors: &Accessors) -> Result<Vec<EncodedImage>> {
    let one = |picture: &Picture| {
        let Some(view) = picture.buffer_view else {
            return Err(Error::unsupported(FORMAT, "an image outside the file; pack it into the GLB"));
        };
        let (bytes, _) = accessors.view(view)?;
        Ok(EncodedImage { media_type: picture.mime_type.clone().unwrap_or_default(), bytes: bytes.to_vec() })
    };
    // Views may overlap: what is copied stays below a few files.
    let mut left = accessors.bin.len().saturating_mul(4);
    let mut all = Vec::new();
    for picture in &accessors.root.images {
        let image = one(picture)?;
        left = spend(left, image.bytes.len())?;
        all.push(image);
    }
    Ok(all)
}

fn label(about: &About) -> Label {
    let own = &about.extras["orb"];
    let marking = own["marking"].as_str().map_or_else(|| about.copyright.clone(), str::to_owned);
    Label { marking, place: serde_json::from_value::<Place>(own["place"].clone()).ok() }
}

pub fn missing(what: &str, index: usize) -> Error {
    Error::malformed(FORMAT, 20, format!("the {what} {index}"), "none")
}

/// The texture whose coordinates a part has: it has one set of them.
fn texture_of(look: &Look) -> Option<&Index> {
    let pbr = &look.pbr_metallic_roughness;
    [&pbr.base_color_texture, &look.normal_texture, &look.occlusion_texture].into_iter().flatten().next()
}

/// Scaled, turned and moved, as `KHR_texture_transform` has it: counter-clockwise as the picture is seen, v down. So say its text
/// and its example, and so do renderers; its lines of GLSL, taken by columns, would turn the other way.
fn shifted(uvs: &mut [[f32; 2]], by: &Shift) {
    let ([x, y], [across, down]) = (by.offset, by.scale.unwrap_or([1.0; 2]));
    let (sin, cos) = by.rotation.sin_cos();
    for uv in uvs {
        let [u, v] = [across * f64::from(uv[0]), down * f64::from(uv[1])];
        *uv = [x + cos * u + sin * v, y - sin * u + cos * v].map(|c| c as f32);
    }
}

fn triangle_mesh(
    accessors: &Accessors,
    primitive: &Primitive,
    texture: Option<&Index>,
    here: &Transform,
) -> Result<Mesh> {
    let Some(&positions) = primitive.attributes.get("POSITION") else {
        return Err(Error::malformed(FORMAT, 20, "positions of a primitive", "none"));
    };
    let positions: Vec<[f32; 3]> = accessors.vectors(positions)?;
    let count = positions.len();
    let optional = |name: &str| primitive.attributes.get(name).copied();
    let shift = texture.and_then(|t| t.extensions.shift.as_ref());
    let set = shift.and_then(|s| s.tex_coord).or(texture.map(|t| t.tex_coord)).unwrap_or(0);
    let mut uvs: Vec<[f32; 2]> = match optional(&format!("TEXCOORD_{set}")) {
        Some(index) => accessors.vectors(index)?,
        None => vec![[0.0; 2]; count],
    };
    if let Some(shift) = shift {
        shifted(&mut uvs, shift);
    }
    let corners: Vec<u32> = match primitive.indices {
        Some(index) => accessors.indices(index)?,
        None => (0..count as u32).collect(),
    };
    let highest = corners.iter().max();
    if uvs.len() != count || highest.is_some_and(|&c| c as usize >= count) {
        let found = format!("{} texture coordinates, indices to {highest:?}", uvs.len());
        return Err(Error::malformed(FORMAT, 20, format!("{count} vertices throughout"), found));
    }
    let mut triangles = triangles(primitive.mode.unwrap_or(4), &corners);
    if here.mirrors() {
        triangles.iter_mut().for_each(|t| t.swap(1, 2));
    }
    let out = |[x, y, z]: [f64; 3]| [x, -z, y];
    // Most files have nodes that move nothing.
    let still = *here == Transform::NONE;
    let positions: Vec<[f64; 3]> = match still {
        true => positions.iter().map(|p| out(p.map(f64::from))).collect(),
        false => positions.iter().map(|p| out(here.point(p.map(f64::from)))).collect(),
    };
    let normals = match optional("NORMAL") {
        Some(index) => {
            let normals: Vec<[f32; 3]> = accessors.vectors(index)?;
            let turned = |n: &[f32; 3]| match still && (dot32(n, n) - 1.0).abs() < UNIT {
                true => [n[0], -n[2], n[1]],
                false => out(here.normal(n.map(f64::from))).map(|x| x as f32),
            };
            normals.iter().map(turned).collect()
        }
        None => crate::mesh::smooth_normals(&positions, &triangles),
    };
    let mesh = Mesh { positions, normals, uvs: uvs.iter().map(|&[u, v]| [u, 1.0 - v]).collect(), triangles };
    mesh.validate()?;
    Ok(mesh)
}

/// How far the square of a normal's length is from 1 at the most where it is taken as it is: what rounding to f32 gives.
const UNIT: f32 = 1e-6;

fn dot32(a: &[f32; 3], b: &[f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Lists (4), strips (5) and fans (6) as triangles.
fn triangles(mode: u32, corners: &[u32]) -> Vec<[u32; 3]> {
    match mode {
        5 => (2..corners.len())
            .map(|i| if i % 2 == 0 { [i - 2, i - 1, i] } else { [i - 1, i - 2, i] })
            .map(|t| t.map(|i| corners[i]))
            .collect(),
        6 => (2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]).collect(),
        _ => corners.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect(),
    }
}
