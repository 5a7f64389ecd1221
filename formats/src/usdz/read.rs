//! Package → asset.

use std::io::Cursor;

use zip::{CompressionMethod, ZipArchive};

use super::decode::decode;
use super::layer::{Kind, Spec, Value};
use super::{ALIGNMENT, FORMAT, splats};
use crate::asset::{Asset, EncodedImage, Material, Part};
use crate::{Error, Label, Mesh, Place, Result};

/// Reads the meshes of a package with their materials, images and label, and its first field of Gaussians. Meshes have triangles, and their normals and
/// texture coordinates a vertex, as [`write`](super::write()) makes them; it reads back equal up to f32 positions.
///
/// # Errors
/// [`Error::Malformed`] for a package whose entries are compressed or do not begin at multiples of 64, and for a layer
/// that breaks its format; [`Error::Unsupported`] for layers that are text, and for other polygons.
pub fn read(bytes: &[u8]) -> Result<Asset> {
    let entries = entries(bytes)?;
    let (name, layer) = root(&entries)?;
    let stage = decode(layer)?;
    let mut out = Asset { label: label(&stage), ..Asset::default() };
    let mut looks: Vec<String> = Vec::new();
    let mut pictures: Vec<String> = Vec::new();
    let mut open: Vec<(&Spec, String)> = stage.children.iter().map(|c| (c, format!("/{}", c.name))).rev().collect();
    while let Some((spec, path)) = open.pop() {
        if let Some(Value::Dictionary(info)) = spec.field("assetInfo")
            && let Some((_, Value::String(name))) = info.iter().find(|(key, _)| key == "name")
        {
            out.name.clone_from(name);
        }
        match spec.type_name() {
            "Mesh" => {
                let bound = spec.children.iter().find(|c| c.kind == Kind::Relationship && c.name == "material:binding");
                let material = match bound.and_then(|b| b.field("targetPaths")) {
                    Some(Value::PathList(paths)) => paths.first().map(|p| index(&mut looks, p)),
                    _ => None,
                };
                out.parts.push(Part { mesh: mesh(spec, name)?, material });
            }
            splats::TYPE if splats::is_field(spec) && out.splats.is_none() => out.splats = Some(splats::read(spec)?),
            "Material" => {
                let number = index(&mut looks, &path);
                let look = material(spec, &mut pictures);
                out.materials.resize_with(out.materials.len().max(number + 1), Material::default);
                out.materials[number] = look;
            }
            _ => {
                let prims = spec.children.iter().filter(|c| c.kind == Kind::Prim);
                open.extend(prims.map(|c| (c, format!("{path}/{}", c.name))).rev());
            }
        }
    }
    out.materials.resize_with(looks.len(), Material::default);
    for picture in pictures {
        let Some(at) = entries.iter().position(|(name, _)| *name == picture) else {
            return Err(Error::malformed(FORMAT, 0, format!("the file {picture}"), "none"));
        };
        let media_type = if picture.ends_with(".png") { "image/png" } else { "image/jpeg" };
        out.images.push(EncodedImage { media_type: media_type.into(), bytes: entries[at].1.to_vec() });
    }
    Ok(out)
}

/// The marking's line alone; empty without one.
///
/// # Errors
/// As [`read`].
pub fn marking(bytes: &[u8]) -> Result<String> {
    let entries = entries(bytes)?;
    let (_, layer) = root(&entries)?;
    Ok(label(&decode(layer)?).marking)
}

/// The number of a name in a list, added where it is new.
fn index(names: &mut Vec<String>, name: &str) -> usize {
    names.iter().position(|n| n == name).unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    })
}

/// Names and contents, whose check sums are looked at. What is stored, and not compressed, stays where it is.
fn entries(bytes: &[u8]) -> Result<Vec<(String, &[u8])>> {
    let broken = |e: zip::result::ZipError| Error::malformed(FORMAT, 0, "a ZIP archive", e.to_string());
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(broken)?;
    let mut out = Vec::new();
    // Entries that lie on each other would be looked at more than once.
    let mut left = bytes.len() as u64;
    for i in 0..archive.len() {
        let file = archive.by_index(i).map_err(broken)?;
        let name = file.name().map_err(broken)?.into_owned();
        let start = file.data_start().unwrap_or(1);
        if file.compression() != CompressionMethod::Stored || start % ALIGNMENT != 0 {
            let found = format!("{name}, {:?}, at {start}", file.compression());
            return Err(Error::malformed(FORMAT, start as usize, "files stored at multiples of 64", found));
        }
        left = left.checked_sub(file.size()).ok_or_else(|| {
            Error::malformed(FORMAT, start as usize, format!("at most {left} more bytes"), file.size().to_string())
        })?;
        let content = usize::try_from(start).ok().and_then(|start| bytes.get(start..));
        let content = content.zip(usize::try_from(file.size()).ok()).and_then(|(rest, size)| rest.get(..size));
        let mut sum = flate2::Crc::new();
        sum.update(content.unwrap_or_default());
        match content.filter(|_| sum.sum() == file.crc32()) {
            Some(content) => out.push((name, content)),
            None => {
                let expected = format!("the content of {name} with its check sum {:08x}", file.crc32());
                return Err(Error::malformed(FORMAT, start as usize, expected, format!("{:08x}", sum.sum())));
            }
        }
    }
    Ok(out)
}

fn root<'a>(entries: &'a [(String, &'a [u8])]) -> Result<(&'a str, &'a [u8])> {
    match entries.first() {
        Some((name, bytes)) if name.ends_with(".usdc") || name.ends_with(".usd") => Ok((name, bytes)),
        Some((name, _)) => Err(Error::unsupported(FORMAT, format!("the root layer must be .usdc, found {name}"))),
        None => Err(Error::malformed(FORMAT, 0, "a root layer", "an empty package")),
    }
}

fn label(stage: &Spec) -> Label {
    let Some(Value::Dictionary(data)) = stage.field("customLayerData") else { return Label::default() };
    let find = |name: &str| data.iter().find(|(key, _)| key == name).map(|(_, value)| value);
    let number = |name: &str| match find(name) {
        Some(Value::Double(d)) => Some(*d),
        _ => None,
    };
    let place = || {
        Some(Place {
            latitude: number("orb:latitude")?,
            longitude: number("orb:longitude")?,
            height: number("orb:height")?,
            heading: number("orb:heading")?,
        })
    };
    let marking = match find("orb:marking") {
        Some(Value::String(line)) => line.clone(),
        _ => String::new(),
    };
    Label { marking, place: place() }
}

fn mesh(spec: &Spec, file: &str) -> Result<Mesh> {
    let missing = |what: &str| Error::malformed(FORMAT, 0, format!("{what} of {} in {file}", spec.name), "none");
    let Some(Value::Vec3fs(points)) = spec.value("points") else { return Err(missing("points")) };
    let Some(Value::Ints(corners)) = spec.value("faceVertexIndices") else { return Err(missing("faceVertexIndices")) };
    let Some(Value::Ints(counts)) = spec.value("faceVertexCounts") else { return Err(missing("faceVertexCounts")) };
    if counts.iter().any(|c| *c != 3) || counts.len() * 3 != corners.len() {
        return Err(Error::unsupported(FORMAT, format!("{}: only triangles are read", spec.name)));
    }
    // An index below 0 becomes one that no mesh has.
    let corner = |c: i32| u32::try_from(c).unwrap_or(u32::MAX);
    let triangles: Vec<[u32; 3]> = corners.chunks_exact(3).map(|t| [t[0], t[1], t[2]].map(corner)).collect();
    let turned = |[x, y, z]: [f32; 3]| [x, -z, y];
    let positions: Vec<[f64; 3]> = points.iter().map(|p| turned(*p).map(f64::from)).collect();
    // All at once first, as they are nearly always in range.
    let (low, high) = corners.iter().fold((0, -1), |(low, high), &c| (c.min(low), c.max(high)));
    let outside = low < 0 || usize::try_from(high).is_ok_and(|h| h >= positions.len());
    if let Some(t) = triangles.iter().find(|t| outside && t.iter().any(|c| *c as usize >= positions.len())) {
        let expected = format!("indices below {} in {}", positions.len(), spec.name);
        return Err(Error::malformed(FORMAT, 0, expected, format!("{t:?}")));
    }
    let normals = match spec.value("normals") {
        Some(Value::Vec3fs(n)) if n.len() == positions.len() => n.iter().map(|n| turned(*n)).collect(),
        _ => crate::mesh::smooth_normals(&positions, &triangles),
    };
    let uvs = match spec.value("primvars:st") {
        Some(Value::Vec2fs(uvs)) if uvs.len() == positions.len() => uvs.clone(),
        _ => vec![[0.0; 2]; positions.len()],
    };
    let mesh = Mesh { positions, normals, uvs, triangles };
    mesh.validate()?;
    Ok(mesh)
}

fn material(spec: &Spec, pictures: &mut Vec<String>) -> Material {
    let mut out = Material::default();
    if let Some(Value::String(name)) = spec.field("displayName") {
        out.name.clone_from(name);
    }
    // The shader that an input of the surface takes its value from.
    let feeds = |input: &str, shader: &str| {
        let inputs = spec.children.iter().flat_map(|c| &c.children).filter(|a| a.name == input);
        let mut paths = inputs.filter_map(|a| match a.field("connectionPaths") {
            Some(Value::PathList(paths)) => paths.first(),
            _ => None,
        });
        paths.any(|p| p.rsplit('/').next().and_then(|end| end.split('.').next()) == Some(shader))
    };
    for shader in spec.children.iter().filter(|c| c.type_name() == "Shader") {
        let number = |name: &str| match shader.value(name) {
            Some(Value::Float(f)) => Some(*f),
            _ => None,
        };
        match shader.value("info:id") {
            Some(Value::Token(id)) if id == "UsdPreviewSurface" => {
                if let Some(Value::Vec3f([r, g, b])) = shader.value("inputs:diffuseColor") {
                    out.base_color = [*r, *g, *b, 1.0];
                }
                // The fallbacks of UsdPreviewSurface.
                out.base_color[3] = number("inputs:opacity").unwrap_or(1.0);
                out.metallic = number("inputs:metallic").unwrap_or(0.0);
                out.roughness = number("inputs:roughness").unwrap_or(0.5);
            }
            Some(Value::Token(id)) if id == "UsdUVTexture" => {
                if let Some(Value::Asset(file)) = shader.value("inputs:file") {
                    let image = Some(index(pictures, file));
                    match shader.name.as_str() {
                        name if feeds("inputs:normal", name) => out.normal_image = image,
                        name if feeds("inputs:occlusion", name) => out.occlusion_image = image,
                        _ => out.image = image,
                    }
                }
            }
            _ => {}
        }
    }
    out
}
