//! `cameras.bin`, `images.bin`, `points3D.bin`: little-endian, each begins with a 64-bit count.

use std::collections::BTreeMap;

use glam::DVec3;

use super::{Camera, Image, Lens, Point, camera, pose};
use crate::{Error, Result};

struct Bytes<'a> {
    file: &'a str,
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Bytes<'a> {
    fn new(file: &'a str, bytes: &'a [u8]) -> Self {
        Bytes { file, bytes, at: 0 }
    }

    fn place(&self) -> String {
        format!("{}, byte {}", self.file, self.at)
    }

    fn take<const N: usize>(&mut self, what: &str) -> Result<[u8; N]> {
        let rest = &self.bytes[self.at..];
        let Some(found) = rest.first_chunk::<N>() else {
            let found = format!("{} bytes before the end", rest.len());
            return Err(Error::usage(self.place()).expected(what).found(found));
        };
        self.at += N;
        Ok(*found)
    }

    fn u64(&mut self, what: &str) -> Result<u64> {
        Ok(u64::from_le_bytes(self.take(what)?))
    }

    fn u32(&mut self, what: &str) -> Result<u32> {
        Ok(u32::from_le_bytes(self.take(what)?))
    }

    fn doubles<const N: usize>(&mut self, what: &str) -> Result<[f64; N]> {
        let mut out = [0.0; N];
        for v in &mut out {
            *v = f64::from_le_bytes(self.take(what)?);
        }
        Ok(out)
    }

    /// A number of things that take so many bytes each at least.
    fn count(&mut self, what: &str, least: usize) -> Result<usize> {
        let at = self.place();
        let count = self.u64(what)?;
        let room = (self.bytes.len() - self.at) / least;
        usize::try_from(count).ok().filter(|n| *n <= room).ok_or_else(|| {
            Error::usage(at).expected(format!("{what}: at most {room} fit in the file")).found(count.to_string())
        })
    }

    fn done(&self) -> Result<()> {
        match self.bytes.len() - self.at {
            0 => Ok(()),
            more => Err(Error::usage(self.place()).expected("the end of the file").found(format!("{more} more bytes"))),
        }
    }
}

pub fn cameras(file: &str, bytes: &[u8]) -> Result<BTreeMap<u32, Camera>> {
    let mut b = Bytes::new(file, bytes);
    let mut out = BTreeMap::new();
    for _ in 0..b.count("a number of cameras", 48)? {
        let id = b.u32("a camera's number")?;
        let at = b.place();
        let number = b.u32("a camera model's number")? as i32;
        let Some(lens) = Lens::of_number(number) else {
            let names = Lens::ALL.map(|l| format!("{} {}", l as i32, l.name())).join(", ");
            return Err(Error::usage(at).expected(format!("one of {names}")).found(number.to_string()));
        };
        let (width, height) = (b.u64("a width")?, b.u64("a height")?);
        let mut parameters = Vec::new();
        for name in lens.parameters().split(' ') {
            parameters.extend(b.doubles::<1>(name)?);
        }
        out.insert(id, camera(&at, lens, width, height, parameters)?);
    }
    b.done()?;
    Ok(out)
}

pub fn images(file: &str, bytes: &[u8]) -> Result<Vec<Image>> {
    let mut b = Bytes::new(file, bytes);
    let mut out = Vec::new();
    for _ in 0..b.count("a number of images", 73)? {
        let at = b.place();
        let id = b.u32("an image's number")?;
        let (q, t) = (b.doubles("a quaternion")?, b.doubles("a translation")?);
        let camera = b.u32("a camera's number")?;
        let mut name = Vec::new();
        loop {
            match b.take::<1>("a picture's name and a zero byte")? {
                [0] => break,
                [c] => name.push(c),
            }
        }
        let (rotation, translation) = pose(&at, q, t)?;
        let mut observations = Vec::new();
        for _ in 0..b.count("a number of observations", 24)? {
            let place = b.doubles("a place in pixels")?;
            let point = b.u64("a point's number")?;
            observations.push((place, (point != u64::MAX).then_some(point)));
        }
        let name = String::from_utf8(name)
            .map_err(|e| Error::usage(&at).expected("a picture's name in UTF-8").found(e.to_string()))?;
        out.push(Image { id, rotation, translation, camera, name, observations });
    }
    b.done()?;
    Ok(out)
}

pub fn points(file: &str, bytes: &[u8]) -> Result<Vec<Point>> {
    let mut b = Bytes::new(file, bytes);
    let mut out = Vec::new();
    for _ in 0..b.count("a number of points", 51)? {
        let at = b.place();
        let id = b.u64("a point's number")?;
        let position = DVec3::from_array(b.doubles("a position")?);
        let color = b.take("a colour")?;
        let [error] = b.doubles("an error")?;
        let mut track = Vec::new();
        for _ in 0..b.count("a number of observations", 8)? {
            track.push((b.u32("an image's number")?, b.u32("an observation's index")?));
        }
        if !position.is_finite() {
            return Err(Error::usage(at).expected("a finite position").found(position.to_string()));
        }
        out.push(Point { id, position, color, error, track });
    }
    b.done()?;
    Ok(out)
}
