//! A sparse model as text: poses go on to other programs, and back.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use glam::DVec3;

use super::Camera;
use crate::photos::reprojection::Pose;
use crate::photos::{Observation, Poses};

/// `cameras.txt`, `images.txt`, `points3D.txt`: names and contents. `at`: the poses to write, one a photo, in place of the
/// photos' own; `points`: in place of the points' own places. Their errors are unknown (−1).
pub fn text(all: &Poses, at: &[Pose], points: &[DVec3]) -> [(&'static str, String); 3] {
    // Cameras that are alike are one.
    let mut cameras: Vec<&Camera> = Vec::new();
    let mut number = |c| match cameras.iter().position(|k| *k == c) {
        Some(k) => k + 1,
        None => {
            cameras.push(c);
            cameras.len()
        }
    };
    let of_photo: Vec<usize> = all.photos.iter().map(|p| number(&p.camera)).collect();
    let mut seen: Vec<Vec<&Observation>> = vec![Vec::new(); all.photos.len()];
    // Of each point: the photo's number and the observation's place there.
    let mut tracks: BTreeMap<usize, String> = BTreeMap::new();
    for o in &all.observations {
        // Writing to a string cannot fail.
        let _ = write!(tracks.entry(o.point).or_default(), " {} {}", o.photo + 1, seen[o.photo].len());
        seen[o.photo].push(o);
    }
    let mut images = String::new();
    for (i, (p, (q, t))) in all.photos.iter().zip(at).enumerate() {
        let _ = writeln!(
            images,
            "{} {} {} {} {} {} {} {} {} {}",
            i + 1,
            q.w,
            q.x,
            q.y,
            q.z,
            t.x,
            t.y,
            t.z,
            of_photo[i],
            p.name
        );
        let line: Vec<String> = seen[i].iter().map(|o| format!("{} {} {}", o.at[0], o.at[1], o.point + 1)).collect();
        let _ = writeln!(images, "{}", line.join(" "));
    }
    let mut places = String::new();
    for (n, (p, (_, [r, g, b]))) in points.iter().zip(&all.points).enumerate() {
        let track = tracks.get(&n).map_or("", String::as_str);
        let _ = writeln!(places, "{} {} {} {} {r} {g} {b} -1{track}", n + 1, p.x, p.y, p.z);
    }
    let mut lenses = String::new();
    for (n, c) in cameras.iter().enumerate() {
        let parameters: Vec<String> = c.parameters.iter().map(f64::to_string).collect();
        let _ = writeln!(lenses, "{} {} {} {} {}", n + 1, c.lens.name(), c.width, c.height, parameters.join(" "));
    }
    [("cameras.txt", lenses), ("images.txt", images), ("points3D.txt", places)]
}
