//! `cameras.txt`, `images.txt`, `points3D.txt`: lines of words, comments after `#`.

use std::collections::BTreeMap;
use std::str::FromStr;

use glam::DVec3;

use super::{Camera, Image, Lens, Point, camera, pose};
use crate::{Error, Result};

/// The words of a line, taken one after the other.
struct Words<'a> {
    at: String,
    line: &'a str,
    words: std::str::SplitWhitespace<'a>,
}

impl<'a> Words<'a> {
    fn new(file: &str, (number, line): (usize, &'a str)) -> Self {
        Words { at: format!("{file}, line {}", number + 1), line, words: line.split_whitespace() }
    }

    fn wrong(&self, expected: &str, found: &str) -> Error {
        Error::usage(&self.at).expected(expected).found(found)
    }

    fn word(&mut self, what: &str) -> Result<&'a str> {
        let shown: String = self.line.chars().take(60).collect();
        self.words.next().ok_or_else(|| self.wrong(what, &format!("the end of {shown:?}")))
    }

    fn value<T: FromStr>(&mut self, what: &str) -> Result<T> {
        let word = self.word(what)?;
        word.parse().map_err(|_| self.wrong(what, &format!("{word:?}")))
    }

    fn values<const N: usize>(&mut self, what: &str) -> Result<[f64; N]> {
        let mut out = [0.0; N];
        for v in &mut out {
            *v = self.value(what)?;
        }
        Ok(out)
    }

    fn is_done(&self) -> bool {
        self.words.clone().next().is_none()
    }
}

fn lines<'a>(file: &str, bytes: &'a [u8]) -> Result<impl Iterator<Item = (usize, &'a str)>> {
    let text = std::str::from_utf8(bytes).map_err(|e| {
        Error::usage(format!("{file}, byte {}", e.valid_up_to())).expected("UTF-8 text").found("other bytes")
    })?;
    Ok(text.lines().enumerate().filter(|(_, l)| !l.trim_start().starts_with('#')))
}

/// `CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]`
pub fn cameras(file: &str, bytes: &[u8]) -> Result<BTreeMap<u32, Camera>> {
    let mut out = BTreeMap::new();
    for line in lines(file, bytes)?.filter(|(_, l)| !l.trim().is_empty()) {
        let mut words = Words::new(file, line);
        let id: u32 = words.value("a camera's number")?;
        let name = words.word("a camera model")?;
        let lens = Lens::of_name(name)
            .ok_or_else(|| words.wrong(&format!("one of {}", Lens::ALL.map(Lens::name).join(", ")), name))?;
        let (width, height) = (words.value("a width")?, words.value("a height")?);
        let what = format!("the {} parameters {}", lens.count(), lens.parameters());
        let mut parameters = Vec::new();
        while parameters.len() < lens.count() {
            parameters.push(words.value(&what)?);
        }
        if !words.is_done() {
            return Err(words.wrong(&what, "more"));
        }
        out.insert(id, camera(&words.at, lens, width, height, parameters)?);
    }
    Ok(out)
}

/// Two lines each: `IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME`, then `POINTS2D[] as (X Y POINT3D_ID)`, which may be
/// empty.
pub fn images(file: &str, bytes: &[u8]) -> Result<Vec<Image>> {
    let mut out = Vec::new();
    let mut lines = lines(file, bytes)?;
    while let Some(line) = lines.next() {
        if line.1.trim().is_empty() {
            continue;
        }
        let mut words = Words::new(file, line);
        let id = words.value("an image's number")?;
        let (q, t) = (words.values("a quaternion")?, words.values("a translation")?);
        let camera = words.value("a camera's number")?;
        // What is left is the name: it may hold spaces.
        let name = words.words.clone().collect::<Vec<_>>().join(" ");
        if name.is_empty() {
            return Err(words.wrong("a picture's name", "the end of the line"));
        }
        let (rotation, translation) = pose(&words.at, q, t)?;
        let mut observations = Vec::new();
        if let Some(line) = lines.next() {
            let mut words = Words::new(file, line);
            while !words.is_done() {
                let at = words.values("a place in pixels")?;
                let point: i64 = words.value("a point's number, or -1")?;
                observations.push((at, u64::try_from(point).ok()));
            }
        }
        out.push(Image { id, rotation, translation, camera, name, observations });
    }
    Ok(out)
}

/// `POINT3D_ID X Y Z R G B ERROR TRACK[] as (IMAGE_ID POINT2D_IDX)`
pub fn points(file: &str, bytes: &[u8]) -> Result<Vec<Point>> {
    let mut out = Vec::new();
    for line in lines(file, bytes)?.filter(|(_, l)| !l.trim().is_empty()) {
        let mut words = Words::new(file, line);
        let id = words.value("a point's number")?;
        let position = DVec3::from_array(words.values("a position")?);
        let mut color = [0; 3];
        for c in &mut color {
            *c = words.value("a colour from 0 to 255")?;
        }
        let error = words.value("an error in pixels")?;
        let mut track = Vec::new();
        while !words.is_done() {
            track.push((words.value("an image's number")?, words.value("an observation's index")?));
        }
        if !position.is_finite() {
            return Err(words.wrong("a finite position", &position.to_string()));
        }
        out.push(Point { id, position, color, error, track });
    }
    Ok(out)
}
