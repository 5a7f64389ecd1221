//! Camera lists: `{"cameras": [{width, height, fx, fy, cx, cy, world_to_camera}]}` and the samples'
//! `{"views": [{…, w2c_opencv}]}`; row-major world→camera matrices of three or four rows, OpenCV axes.

use std::path::Path;

use glam::{Mat3, Vec3};
use serde_json::Value;

use super::{Camera, Gaussians};
use crate::{Error, Result};

/// Largest picture side.
const MOST_PIXELS: u32 = 32_768;

/// Reads a list from the bytes of `path`: each camera with its name, or its number where it has none.
///
/// Errors: usage, naming the file and the camera.
pub fn parse(path: &Path, bytes: &[u8]) -> Result<Vec<(String, Camera)>> {
    let wrong = |at: &str| Error::usage(format!("{}{at}", path.display()));
    let json: Value =
        serde_json::from_slice(bytes).map_err(|e| wrong("").expected("a camera list in JSON").found(e.to_string()))?;
    let (list, matrix) = match (&json["cameras"], &json["views"]) {
        (Value::Array(list), _) => (list, "world_to_camera"),
        (_, Value::Array(list)) => (list, "w2c_opencv"),
        _ => return Err(wrong("").expected("an array \"cameras\" or \"views\"").found("neither")),
    };
    list.iter()
        .enumerate()
        .map(|(i, c)| {
            let name = c["name"].as_str().map_or_else(|| format!("{i:04}"), str::to_owned);
            let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "._-".contains(c));
            if !plain || name.starts_with('.') || name.is_empty() {
                let at = format!(", camera {i}, name");
                return Err(wrong(&at).expected("letters, digits, '.', '_' and '-'").found(format!("{name:?}")));
            }
            camera(c, matrix).map(|c| (name, c)).map_err(|(field, expected)| {
                let found = c.get(field).map_or("nothing".to_owned(), |v| v.to_string().chars().take(80).collect());
                wrong(&format!(", camera {i}, {field}")).expected(expected).found(found)
            })
        })
        .collect()
}

type Wrong<'a> = (&'a str, &'static str);

fn camera<'a>(c: &Value, matrix: &'a str) -> Result<Camera, Wrong<'a>> {
    let side = |field| {
        let v = c[field].as_u64().and_then(|v| u32::try_from(v).ok());
        v.filter(|v| (1..=MOST_PIXELS).contains(v)).ok_or((field, "a whole number from 1 to 32768"))
    };
    let number = |field| {
        let v = c[field].as_f64().map(|v| v as f32);
        v.filter(|v| v.is_finite()).ok_or((field, "a finite number"))
    };
    let focal = |field| number(field).and_then(|v| if v > 0.0 { Ok(v) } else { Err((field, "a number above 0")) });
    let wrong = (matrix, "three or four rows of four finite numbers, the first three columns a rotation");
    let rows = c[matrix].as_array().filter(|r| r.len() == 3 || r.len() == 4).ok_or(wrong)?;
    let mut m = [[0f32; 4]; 3];
    for (out, row) in m.iter_mut().zip(rows) {
        let row = row.as_array().filter(|r| r.len() == 4).ok_or(wrong)?;
        for (o, v) in out.iter_mut().zip(row) {
            *o = v.as_f64().map(|v| v as f32).filter(|v| v.is_finite()).ok_or(wrong)?;
        }
    }
    let row = |i: usize| Vec3::new(m[i][0], m[i][1], m[i][2]);
    let rotation = Mat3::from_cols(row(0), row(1), row(2)).transpose();
    let unit = (rotation * rotation.transpose() - Mat3::IDENTITY).to_cols_array().iter().all(|v| v.abs() < 1e-3);
    if !unit || rotation.determinant() < 0.0 {
        return Err(wrong);
    }
    Ok(Camera {
        width: side("width")?,
        height: side("height")?,
        fx: focal("fx")?,
        fy: focal("fy")?,
        cx: number("cx")?,
        cy: number("cy")?,
        rotation,
        translation: Vec3::new(m[0][3], m[1][3], m[2][3]),
    })
}

/// A ball around Gaussians: centre and radius, in their units.
pub fn ball(g: &Gaussians) -> (Vec3, f32) {
    // Two standard deviations along the longest axis belong to a Gaussian.
    let balls = g.positions.iter().zip(&g.log_scales).map(|(p, s)| (*p, 2.0 * s.max_element().exp()));
    let finite: Vec<(Vec3, f32)> = balls.filter(|(p, r)| p.is_finite() && r.is_finite()).collect();
    let n = finite.len().max(1);
    let centre = (finite.iter().map(|(p, _)| p.as_dvec3()).sum::<glam::DVec3>() / n as f64).as_vec3();
    let mut far: Vec<f32> = finite.iter().map(|(p, r)| p.distance(centre) + r).collect();
    far.sort_by(f32::total_cmp);
    // A few floaters must not make the subject small.
    (centre, far.get(far.len() * 98 / 100).copied().unwrap_or(1.0).max(1e-3))
}

/// `count` square cameras around Gaussians, 20° above them, counter-clockwise from −Y, all of them in view.
pub fn turntable(g: &Gaussians, count: usize, size: u32) -> Vec<(String, Camera)> {
    let (centre, radius) = ball(g);
    let fov = 40f32.to_radians();
    let distance = 1.1 * radius / (fov / 2.0).sin();
    let elevation = 20f32.to_radians();
    (0..count)
        .map(|i| {
            let turn = std::f32::consts::TAU * i as f32 / count as f32;
            let out = Vec3::new(turn.sin() * elevation.cos(), -turn.cos() * elevation.cos(), elevation.sin());
            (format!("{i:04}"), Camera::look_at(centre + distance * out, centre, fov, size))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: &str = r#"{"width":4,"height":3,"fx":5,"fy":6,"cx":2,"cy":1.5,
        "world_to_camera":[[1,0,0,7],[0,0,-1,8],[0,1,0,9],[0,0,0,1]]}"#;

    #[test]
    fn reads_both_lists() {
        let path = Path::new("c.json");
        let a = parse(path, format!("{{\"cameras\":[{ONE}]}}").as_bytes()).unwrap();
        assert_eq!(a[0].0, "0000");
        assert_eq!(a[0].1.translation, Vec3::new(7.0, 8.0, 9.0));
        assert_eq!(a[0].1.rotation * Vec3::Y, Vec3::Z);
        let view = ONE.replace("world_to_camera", "w2c_opencv").replace("{\"width", "{\"name\":\"photo\",\"width");
        let b = parse(path, format!("{{\"views\":[{view}]}}").as_bytes()).unwrap();
        assert_eq!(b, vec![("photo".to_owned(), a[0].1)]);
    }

    #[test]
    fn says_what_is_wrong_and_where() {
        for (from, to, said) in [
            ("\"width\":4", "\"width\":0", "camera 0, width"),
            ("\"fy\":6", "\"fy\":-6", "camera 0, fy"),
            ("\"cx\":2", "\"cx\":null", "camera 0, cx"),
            ("[1,0,0,7]", "[1,0,7]", "camera 0, world_to_camera"),
            ("[1,0,0,7]", "[2,0,0,7]", "camera 0, world_to_camera"),
            ("{\"width", "{\"name\":\"../x\",\"width", "camera 0, name"),
            ("{\"width", "\"width", "c.json"),
        ] {
            let text = format!("{{\"cameras\":[{}]}}", ONE.replace(from, to));
            let e = parse(Path::new("c.json"), text.as_bytes()).unwrap_err().to_string();
            assert!(e.contains(said), "{to}: {e}");
        }
    }

    #[test]
    fn turntable_holds_the_subject() {
        let positions = [Vec3::new(1.0, 2.0, 3.0), Vec3::new(3.0, 2.0, 3.0), Vec3::new(2.0, 3.0, 4.0)];
        let g = Gaussians { positions: positions.into(), log_scales: vec![Vec3::splat(-2.0); 3], ..Default::default() };
        for (_, c) in turntable(&g, 5, 100) {
            for p in positions {
                let q = c.rotation * p + c.translation;
                let (x, y) = (c.fx * q.x / q.z + c.cx, c.fy * q.y / q.z + c.cy);
                assert!(q.z > 0.0 && (0.0..100.0).contains(&x) && (0.0..100.0).contains(&y), "{x} {y}");
            }
        }
    }
}
