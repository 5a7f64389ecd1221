//! True meshes: glTF binary (2.0, §4) triangles in metres, turned Z up, and the heading of the photo's camera.

use std::path::{Path, PathBuf};

use glam::{Mat3, Mat4, Quat, Vec3};
use serde_json::Value;

use crate::mesh::Surface;
use crate::splat::Camera;
use crate::{Error, Result};

/// What is known of a photo made from a model.
pub struct Truth {
    pub name: String,
    pub photo: PathBuf,
    /// Metres, Z up.
    pub surface: Surface,
    /// Where the photo's camera looks, horizontally; unit length.
    pub forward: Vec3,
    /// True pictures from other sides.
    pub views: Vec<TrueView>,
}

/// A picture of the model with transparent surroundings.
pub struct TrueView {
    pub camera: Camera,
    pub file: PathBuf,
    /// Degrees from the photo's side, 0 to 180.
    pub away: f32,
}

/// A folder with `mesh.glb` and `cameras.json`, the photo its view `outdoor` or the last of its group `photo`.
pub fn read(folder: &Path) -> Result<Truth> {
    let path = folder.join("cameras.json");
    let list: Value = serde_json::from_slice(&std::fs::read(&path).map_err(|e| Error::io(&path, &e))?)
        .map_err(|e| Error::usage(path.display().to_string()).expected("JSON").found(e.to_string()))?;
    let no = |what: &str| Error::usage(path.display().to_string()).expected(what.to_owned()).found("none");
    let views = list["views"].as_array().ok_or_else(|| no("views"))?;
    let photos = || views.iter().filter(|v| v["group"] == "photo");
    let photo =
        photos().find(|v| v["name"] == "outdoor").or_else(|| photos().next_back()).ok_or_else(|| no("a photo"))?;
    let at = |i: usize| photo["w2c_opencv"][2][i].as_f64().ok_or_else(|| no("w2c_opencv"));
    let forward = Vec3::new(at(0)? as f32, at(1)? as f32, 0.0);
    let mut shown = Vec::new();
    for v in views.iter().filter(|v| v["group"] == "gt") {
        let file = folder.join(v["file"].as_str().ok_or_else(|| no("a view's file"))?);
        let away = v["azimuth_rel_photo_deg"].as_f64().unwrap_or(0.0).rem_euclid(360.0) as f32;
        let camera = camera(v).ok_or_else(|| no("a view's camera"))?;
        shown.push(TrueView { camera, file, away: away.min(360.0 - away) });
    }
    let file = photo["file"].as_str().ok_or_else(|| no("a photo's file"))?;
    let mesh = folder.join("mesh.glb");
    let bytes = std::fs::read(&mesh).map_err(|e| Error::io(&mesh, &e))?;
    let surface = glb(&bytes)
        .filter(|s| !s.triangles.is_empty())
        .ok_or_else(|| Error::usage(mesh.display().to_string()).expected("triangles in binary glTF").found("none"))?;
    Ok(Truth {
        name: folder.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default(),
        photo: folder.join(file),
        surface,
        forward: forward.normalize_or(Vec3::Y),
        views: shown,
    })
}

fn camera(v: &Value) -> Option<Camera> {
    let number = |name: &str| Some(v[name].as_f64()? as f32);
    let m = |row: usize, column: usize| Some(v["w2c_opencv"][row][column].as_f64()? as f32);
    let row = |i: usize| Some(Vec3::new(m(i, 0)?, m(i, 1)?, m(i, 2)?));
    Some(Camera {
        width: v["width"].as_u64()? as u32,
        height: v["height"].as_u64()? as u32,
        fx: number("fx")?,
        fy: number("fy")?,
        cx: number("cx")?,
        cy: number("cy")?,
        rotation: Mat3::from_cols(row(0)?, row(1)?, row(2)?).transpose(),
        translation: Vec3::new(m(0, 3)?, m(1, 3)?, m(2, 3)?),
    })
}

/// Every triangle of the first scene; None where the file is not what it says.
pub fn glb(bytes: &[u8]) -> Option<Surface> {
    let word = |at: usize| Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?) as usize);
    if bytes.get(..4)? != b"glTF" {
        return None;
    }
    let length = word(12)?;
    let json: Value = serde_json::from_slice(bytes.get(20..20 + length)?).ok()?;
    let binary = bytes.get(28 + length..)?;
    let mut surface = Surface::default();
    let scene = json["scene"].as_u64().unwrap_or(0) as usize;
    let mut stack: Vec<(usize, Mat4)> = json["scenes"][scene]["nodes"]
        .as_array()?
        .iter()
        .filter_map(|n| Some((n.as_u64()? as usize, Mat4::IDENTITY)))
        .collect();
    // Nodes are a tree: none is met twice.
    let mut left = json["nodes"].as_array()?.len();
    while let Some((index, above)) = stack.pop() {
        left = left.checked_sub(1)?;
        let node = &json["nodes"][index];
        let place = above * local(node);
        for child in node["children"].as_array().into_iter().flatten() {
            stack.push((child.as_u64()? as usize, place));
        }
        let Some(mesh) = node["mesh"].as_u64() else { continue };
        for primitive in json["meshes"][mesh as usize]["primitives"].as_array()? {
            if primitive["mode"].as_u64().unwrap_or(4) != 4 {
                continue;
            }
            let first = u32::try_from(surface.positions.len()).ok()?;
            let positions = numbers(&json, binary, primitive["attributes"]["POSITION"].as_u64()?)?;
            surface.positions.extend(positions.chunks_exact(3).map(|p| {
                let q = place.transform_point3(Vec3::new(p[0] as f32, p[1] as f32, p[2] as f32));
                Vec3::new(q.x, -q.z, q.y)
            }));
            let indices: Vec<u32> = match primitive["indices"].as_u64() {
                Some(accessor) => {
                    let indices = numbers(&json, binary, accessor)?;
                    indices.iter().map(|v| first.checked_add(*v as u32)).collect::<Option<_>>()?
                }
                None => (first..surface.positions.len() as u32).collect(),
            };
            surface.triangles.extend(indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]));
        }
    }
    let n = surface.positions.len() as u32;
    surface.triangles.iter().flatten().all(|i| *i < n).then_some(surface)
}

fn local(node: &Value) -> Mat4 {
    let list = |name: &str| -> Option<Vec<f32>> {
        node[name].as_array().map(|a| a.iter().filter_map(|v| Some(v.as_f64()? as f32)).collect())
    };
    if let Some(m) = list("matrix").and_then(|m| <[f32; 16]>::try_from(m).ok()) {
        return Mat4::from_cols_array(&m);
    }
    let three = |name: &str, default: Vec3| {
        list(name).and_then(|v| <[f32; 3]>::try_from(v).ok()).map_or(default, Vec3::from_array)
    };
    let turn = list("rotation").and_then(|v| <[f32; 4]>::try_from(v).ok()).map_or(Quat::IDENTITY, Quat::from_array);
    Mat4::from_scale_rotation_translation(three("scale", Vec3::ONE), turn, three("translation", Vec3::ZERO))
}

/// An accessor's numbers, one after the other.
fn numbers(json: &Value, binary: &[u8], accessor: u64) -> Option<Vec<f64>> {
    let accessor = &json["accessors"][accessor as usize];
    let view = &json["bufferViews"][accessor["bufferView"].as_u64()? as usize];
    let (size, wide): (usize, fn(&[u8]) -> f64) = match accessor["componentType"].as_u64()? {
        5121 => (1, |b| f64::from(b[0])),
        5123 => (2, |b| f64::from(u16::from_le_bytes([b[0], b[1]]))),
        5125 => (4, |b| f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]]))),
        5126 => (4, |b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]))),
        _ => return None,
    };
    let parts = match accessor["type"].as_str()? {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        _ => return None,
    };
    let offset = |v: &Value| v["byteOffset"].as_u64().unwrap_or(0) as usize;
    let stride = view["byteStride"].as_u64().map_or(size * parts, |s| s as usize);
    if stride < size * parts {
        return None;
    }
    let start = offset(view).checked_add(offset(accessor))?;
    let mut out = Vec::new();
    for i in 0..accessor["count"].as_u64()? as usize {
        for k in 0..parts {
            let at = i.checked_mul(stride)?.checked_add(start)?.checked_add(k * size)?;
            out.push(wide(binary.get(at..)?.get(..size)?));
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_samples_are_read_at_their_true_size() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/truth/smart_car");
        let truth = read(&folder).unwrap();
        let (low, high) = truth.surface.bounds();
        assert!((high - low - Vec3::new(2.528, 1.708, 1.546)).abs().max_element() < 2e-3, "{low} {high}");
        assert!(low.z.abs() < 1e-3 && truth.photo.is_file());
        // The photo was taken from azimuth 35° of the model's own axes.
        assert!((truth.forward.length() - 1.0).abs() < 1e-6);
        assert!(glb(b"glTF").is_none() && glb(&[0; 64]).is_none());
    }

    /// One triangle; `node` and `view` are put into its node and its buffer view.
    fn triangle(node: &str, view: &str, count: u64) -> Vec<u8> {
        let json = format!(
            r#"{{"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0{node}}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"type":"VEC3","count":{count}}}],"bufferViews":[{{"buffer":0{view}}}]}}"#
        );
        let corners = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let length = (json.len() as u32).to_le_bytes();
        let binary: Vec<u8> = corners.iter().flat_map(|v| v.to_le_bytes()).collect();
        [b"glTF\0\0\0\0\0\0\0\0", &length[..], b"JSON", json.as_bytes(), &[0; 8], &binary].concat()
    }

    #[test]
    fn files_that_never_end_are_refused() {
        assert_eq!(glb(&triangle("", "", 3)).unwrap().triangles, [[0, 1, 2]]);
        assert!(glb(&triangle(r#","children":[0]"#, "", 3)).is_none());
        assert!(glb(&triangle("", r#","byteStride":0"#, 1_000_000_000_000_000)).is_none());
        assert!(glb(&triangle("", r#","byteOffset":18446744073709551615"#, 3)).is_none());
    }
}
