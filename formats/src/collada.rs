//! COLLADA 1.4.1 (Khronos, 2008): one textured mesh, as KML shows it.

use std::fmt::Write;

use crate::xml::{comment, escape};
use crate::{Mesh, Result};

/// A document of one mesh under one texture, metres, Z up. `texture` is the picture's path relative to the document,
/// `marking` a line for the head, `created` an ISO 8601 time.
///
/// # Errors
/// As [`Mesh::validate`].
pub fn write(mesh: &Mesh, texture: &str, marking: &str, created: &str) -> Result<Vec<u8>> {
    mesh.validate()?;
    let mut positions = String::new();
    let mut normals = String::new();
    let mut uvs = String::new();
    let mut triangles = String::new();
    // Writing to a string cannot fail. Six places are a micrometre.
    for p in &mesh.positions {
        let _ = write!(positions, "{:.6} {:.6} {:.6} ", p[0], p[1], p[2]);
    }
    for n in &mesh.normals {
        let _ = write!(normals, "{:.5} {:.5} {:.5} ", n[0], n[1], n[2]);
    }
    for t in &mesh.uvs {
        let _ = write!(uvs, "{:.6} {:.6} ", t[0], t[1]);
    }
    for i in mesh.triangles.iter().flatten() {
        let _ = write!(triangles, "{i} ");
    }
    let source = |id: &str, values: &str, count: usize, axes: &[&str]| {
        let params: String = axes.iter().map(|a| format!("<param name=\"{a}\" type=\"float\"/>")).collect();
        format!(
            "<source id=\"{id}\"><float_array id=\"{id}-array\" count=\"{}\">{}</float_array><technique_common><accessor \
             source=\"#{id}-array\" count=\"{count}\" stride=\"{}\">{params}</accessor></technique_common></source>\n",
            count * axes.len(),
            values.trim_end(),
            axes.len()
        )
    };
    let count = mesh.positions.len();
    let picture = escape(texture);
    let time = escape(created);
    let document = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{head}\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" \
         version=\"1.4.1\">\n<asset><created>{time}</created><modified>{time}</modified><unit name=\"meter\" meter=\"1\"/>\
         <up_axis>Z_UP</up_axis></asset>\n\
         <library_images><image id=\"picture\"><init_from>{picture}</init_from></image></library_images>\n\
         <library_effects><effect id=\"look\"><profile_COMMON><newparam sid=\"surface\"><surface type=\"2D\">\
         <init_from>picture</init_from></surface></newparam><newparam sid=\"sampler\"><sampler2D><source>surface</source>\
         </sampler2D></newparam><technique sid=\"common\"><lambert><diffuse><texture texture=\"sampler\" texcoord=\"UV\"/>\
         </diffuse></lambert></technique></profile_COMMON></effect></library_effects>\n\
         <library_materials><material id=\"material\"><instance_effect url=\"#look\"/></material></library_materials>\n\
         <library_geometries><geometry id=\"mesh\"><mesh>\n{positions}{normals}{uvs}\
         <vertices id=\"vertices\"><input semantic=\"POSITION\" source=\"#positions\"/></vertices>\n\
         <triangles material=\"skin\" count=\"{faces}\"><input semantic=\"VERTEX\" source=\"#vertices\" offset=\"0\"/>\
         <input semantic=\"NORMAL\" source=\"#normals\" offset=\"0\"/><input semantic=\"TEXCOORD\" source=\"#uvs\" offset=\"0\" \
         set=\"0\"/><p>{triangles}</p></triangles>\n</mesh></geometry></library_geometries>\n\
         <library_visual_scenes><visual_scene id=\"scene\"><node id=\"model\"><instance_geometry url=\"#mesh\"><bind_material>\
         <technique_common><instance_material symbol=\"skin\" target=\"#material\"><bind_vertex_input semantic=\"UV\" \
         input_semantic=\"TEXCOORD\" input_set=\"0\"/></instance_material></technique_common></bind_material>\
         </instance_geometry></node></visual_scene></library_visual_scenes>\n\
         <scene><instance_visual_scene url=\"#scene\"/></scene>\n</COLLADA>\n",
        head = comment(marking),
        positions = source("positions", &positions, count, &["X", "Y", "Z"]),
        normals = source("normals", &normals, count, &["X", "Y", "Z"]),
        uvs = source("uvs", &uvs, count, &["S", "T"]),
        faces = mesh.triangles.len(),
        triangles = triangles.trim_end(),
    );
    Ok(document.into_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xml::{Element, parse};

    fn find<'a>(e: &'a Element, name: &str) -> Option<&'a Element> {
        if e.local_name() == name { Some(e) } else { e.children.iter().find_map(|c| find(c, name)) }
    }

    #[test]
    fn what_is_written_reads_back() {
        let mesh = Mesh {
            positions: vec![[0.0, 0.0, 0.0], [2.125, 0.0, -1.0], [0.0, 3.0, 0.5]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            triangles: vec![[0, 1, 2]],
        };
        let text =
            String::from_utf8(write(&mesh, "a&b.png", "CLASSIFICATION: CUI", "2026-11-21T04:05:06Z").unwrap()).unwrap();
        assert!(text.contains("CLASSIFICATION: CUI"));
        let root = parse(&text).unwrap();
        let numbers = |name| -> Vec<f64> {
            find(&root, name).unwrap().text.split_whitespace().map(|t| t.parse().unwrap()).collect()
        };
        assert_eq!(numbers("float_array"), mesh.positions.concat());
        assert_eq!(numbers("p"), [0.0, 1.0, 2.0]);
        assert_eq!(find(&root, "init_from").unwrap().text, "a&b.png");
        assert_eq!(find(&root, "up_axis").unwrap().text, "Z_UP");
        assert!(write(&Mesh { triangles: vec![[0, 1, 3]], ..mesh }, "", "", "").is_err());
    }
}
