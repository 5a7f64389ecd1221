//! Asset → package.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::encode::encode;
use super::layer::{Kind, Spec, Value};
use super::{ALIGNMENT, FORMAT, splats};
use crate::asset::{Asset, Material, Part};
use crate::mesh::unit;
use crate::{Error, Result};

/// The prim that holds everything.
const ROOT: &str = "/Model";
/// Shaders of a material that read images.
const COLORS: &str = "Texture";
const NORMALS: &str = "NormalTexture";
const OCCLUSION: &str = "OcclusionTexture";

/// Writes the parts and their materials, and splats beside them as OpenUSD's field of Gaussians.
///
/// # Errors
/// [`Error::Unsupported`] for an asset without a part, splats that are none, a mesh that is not valid or empty, a material or an image
/// that does not exist, an image that is neither PNG nor JPEG.
pub fn write(asset: &Asset) -> Result<Vec<u8>> {
    if asset.parts.is_empty() {
        return refuse("an asset needs a mesh".into());
    }
    let images = asset.images.iter().enumerate().map(|(i, image)| match image.media_type.as_str() {
        "image/png" => Ok(format!("textures/image{i}.png")),
        "image/jpeg" => Ok(format!("textures/image{i}.jpg")),
        other => refuse(format!("an image must be image/png or image/jpeg, found {other:?}")),
    });
    let images: Vec<String> = images.collect::<Result<_>>()?;
    let layer = encode(&stage(asset, &images)?);
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let files = images.iter().zip(&asset.images).map(|(name, image)| (name.as_str(), image.bytes.as_slice()));
    for (name, bytes) in [("model.usdc", layer.as_slice())].into_iter().chain(files) {
        // One date for all: same asset, same bytes.
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::default())
            .with_alignment(ALIGNMENT as u16);
        let failed = |e: String| Error::unsupported(FORMAT, format!("{name}: {e}"));
        zip.start_file(name, options).map_err(|e| failed(e.to_string()))?;
        zip.write_all(bytes).map_err(|e| failed(e.to_string()))?;
    }
    Ok(zip.finish().map_err(|e| Error::unsupported(FORMAT, e.to_string()))?.into_inner())
}

fn stage(asset: &Asset, images: &[String]) -> Result<Spec> {
    let mut model = Spec::prim("Model", "Xform")
        .with("kind", Value::Token("component".into()))
        .with("assetInfo", Value::Dictionary(vec![("name".into(), Value::String(asset.name.clone()))]));
    for (i, part) in asset.parts.iter().enumerate() {
        let mesh = mesh(part, i).map_err(|e| Error::unsupported(FORMAT, format!("part {i}: {e}")))?;
        if part.material.is_some_and(|m| m >= asset.materials.len()) {
            return refuse(format!("part {i} names material {:?} of {}", part.material, asset.materials.len()));
        }
        model.children.push(mesh);
    }
    if let Some(field) = &asset.splats {
        model.children.push(splats::write(field)?);
    }
    if !asset.materials.is_empty() {
        let mut scope = Spec::prim("Materials", "Scope");
        for (i, material) in asset.materials.iter().enumerate() {
            scope.children.push(look(material, i, images)?);
        }
        model.children.push(scope);
    }
    let mut root = Spec::new("", Kind::Root)
        .with("defaultPrim", Value::Token("Model".into()))
        .with("metersPerUnit", Value::Double(1.0))
        .with("upAxis", Value::Token("Y".into()));
    let label = &asset.label;
    let mut data = Vec::new();
    if !label.marking.is_empty() {
        root = root.with("documentation", Value::String(label.marking.clone()));
        data.push(("orb:marking".into(), Value::String(label.marking.clone())));
    }
    if let Some(p) = label.place {
        for (name, value) in
            [("latitude", p.latitude), ("longitude", p.longitude), ("height", p.height), ("heading", p.heading)]
        {
            data.push((format!("orb:{name}"), Value::Double(value)));
        }
    }
    if !data.is_empty() {
        root = root.with("customLayerData", Value::Dictionary(data));
    }
    Ok(root.child(model))
}

fn mesh(part: &Part, index: usize) -> Result<Spec> {
    part.mesh.validate()?;
    let corners: Vec<i32> = part.mesh.triangles.iter().flatten().map(|&c| c as i32).collect();
    if corners.is_empty() {
        return refuse("a mesh without a triangle".into());
    }
    let turned = |[x, y, z]: [f32; 3]| [x, z, -y];
    let points: Vec<[f32; 3]> = part.mesh.positions.iter().map(|p| turned(p.map(|x| x as f32))).collect();
    let normals: Vec<[f32; 3]> = part.mesh.normals.iter().map(|n| turned(unit(n.map(f64::from)))).collect();
    let edge = |pick: fn(f32, f32) -> f32| {
        points.iter().copied().reduce(|a, b| std::array::from_fn(|i| pick(a[i], b[i]))).unwrap_or_default()
    };
    let extent = vec![edge(f32::min), edge(f32::max)];
    let by_vertex = Value::Token("vertex".into());
    let mut mesh = Spec::prim(format!("Part{index}"), "Mesh")
        .child(Spec::attribute("extent", "float3[]", Value::Vec3fs(extent)))
        .child(Spec::attribute("faceVertexCounts", "int[]", Value::Ints(vec![3; corners.len() / 3])))
        .child(Spec::attribute("faceVertexIndices", "int[]", Value::Ints(corners)))
        .child(
            Spec::attribute("normals", "normal3f[]", Value::Vec3fs(normals)).with("interpolation", by_vertex.clone()),
        )
        .child(Spec::attribute("points", "point3f[]", Value::Vec3fs(points)))
        .child(
            Spec::attribute("primvars:st", "texCoord2f[]", Value::Vec2fs(part.mesh.uvs.clone()))
                .with("interpolation", by_vertex),
        )
        .child(Spec::uniform("subdivisionScheme", "none"));
    if let Some(m) = part.material {
        let target = Value::PathList(vec![format!("{ROOT}/Materials/Material{m}")]);
        mesh = mesh.with("apiSchemas", Value::TokenList(vec!["MaterialBindingAPI".into()])).child(
            Spec::new("material:binding", Kind::Relationship)
                .with("variability", Value::Variability(1))
                .with("targetPaths", target),
        );
    }
    Ok(mesh)
}

fn look(material: &Material, index: usize, images: &[String]) -> Result<Spec> {
    let path = format!("{ROOT}/Materials/Material{index}");
    let [r, g, b, opacity] = material.base_color;
    let mut surface = Spec::prim("Surface", "Shader").child(Spec::uniform("info:id", "UsdPreviewSurface"));
    let mut shaders = Vec::new();
    let mut texture = |name: &str, image: usize, space: &str, result: (&str, &str)| {
        let Some(file) = images.get(image) else {
            return refuse(format!("material {:?} names image {image} of {}", material.name, images.len()));
        };
        let mut shader = Spec::prim(name, "Shader")
            .child(Spec::uniform("info:id", "UsdUVTexture"))
            .child(Spec::attribute("inputs:file", "asset", Value::Asset(file.clone())))
            .child(Spec::attribute("inputs:sourceColorSpace", "token", Value::Token(space.into())))
            .child(Spec::attribute("inputs:wrapS", "token", Value::Token("clamp".into())))
            .child(Spec::attribute("inputs:wrapT", "token", Value::Token("clamp".into())))
            .child(Spec::connected("inputs:st", "float2", format!("{path}/Coordinates.outputs:result")));
        if name == NORMALS {
            // 0..1 of the file to −1..1.
            for (name, value) in [("inputs:scale", [2.0, 2.0, 2.0, 1.0]), ("inputs:bias", [-1.0, -1.0, -1.0, 0.0])] {
                shader.children.push(Spec::attribute(name, "float4", Value::Vec4f(value)));
            }
        }
        let (output_name, kind) = result;
        shaders.push(shader.child(output(output_name, kind)));
        Ok(format!("{path}/{name}.{output_name}"))
    };
    match material.image {
        None => surface.children.push(Spec::attribute("inputs:diffuseColor", "color3f", Value::Vec3f([r, g, b]))),
        Some(image) => {
            let from = texture(COLORS, image, "sRGB", ("outputs:rgb", "float3"))?;
            surface.children.push(Spec::connected("inputs:diffuseColor", "color3f", from));
        }
    }
    if let Some(image) = material.normal_image {
        let from = texture(NORMALS, image, "raw", ("outputs:rgb", "float3"))?;
        surface.children.push(Spec::connected("inputs:normal", "normal3f", from));
    }
    if let Some(image) = material.occlusion_image {
        let from = texture(OCCLUSION, image, "raw", ("outputs:r", "float"))?;
        surface.children.push(Spec::connected("inputs:occlusion", "float", from));
    }
    if !shaders.is_empty() {
        shaders.push(
            Spec::prim("Coordinates", "Shader")
                .child(Spec::uniform("info:id", "UsdPrimvarReader_float2"))
                .child(Spec::attribute("inputs:varname", "string", Value::String("st".into())))
                .child(output("outputs:result", "float2")),
        );
    }
    for (name, value) in
        [("inputs:metallic", material.metallic), ("inputs:roughness", material.roughness), ("inputs:opacity", opacity)]
    {
        surface.children.push(Spec::attribute(name, "float", Value::Float(value)));
    }
    surface.children.push(output("outputs:surface", "token"));
    let mut out = Spec::prim(format!("Material{index}"), "Material").child(Spec::connected(
        "outputs:surface",
        "token",
        format!("{path}/Surface.outputs:surface"),
    ));
    if !material.name.is_empty() {
        out = out.with("displayName", Value::String(material.name.clone()));
    }
    out.children.push(surface);
    out.children.extend(shaders);
    Ok(out)
}

fn output(name: &str, kind: &str) -> Spec {
    Spec::new(name, Kind::Attribute).with("typeName", Value::Token(kind.into()))
}

fn refuse<T>(what: String) -> Result<T> {
    Err(Error::unsupported(FORMAT, what))
}
