//! Values after the header, one by one, ASCII or binary.

use super::header::{Element, Encoding, Kind, Property};
use super::malformed;
use crate::Result;

pub struct Source<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
    pub encoding: Encoding,
}

impl Source<'_> {
    /// The next value. f64 holds every type exactly.
    pub fn number(&mut self, kind: Kind) -> Result<f64> {
        match self.encoding {
            Encoding::Ascii => self.word(),
            Encoding::LittleEndian => self.binary(kind, false),
            Encoding::BigEndian => self.binary(kind, true),
        }
    }

    fn binary(&mut self, kind: Kind, big: bool) -> Result<f64> {
        let size = kind.size();
        let Some(bytes) = self.bytes[self.at..].get(..size) else {
            return malformed(self.bytes.len(), format!("{size} more bytes"), "the end of the file".into());
        };
        self.at += size;
        let mut wide = [0; 8]; // little-endian, zero-extended
        for (i, to) in wide[..size].iter_mut().enumerate() {
            *to = bytes[if big { size - 1 - i } else { i }];
        }
        let [a, b, c, d, ..] = wide;
        Ok(match kind {
            Kind::I8 => f64::from(a as i8),
            Kind::U8 => f64::from(a),
            Kind::I16 => f64::from(i16::from_le_bytes([a, b])),
            Kind::U16 => f64::from(u16::from_le_bytes([a, b])),
            Kind::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            Kind::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            Kind::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Kind::F64 => f64::from_le_bytes(wide),
        })
    }

    fn word(&mut self) -> Result<f64> {
        let rest = &self.bytes[self.at..];
        let start = rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(rest.len());
        let length = rest[start..].iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len() - start);
        if length == 0 {
            return malformed(self.bytes.len(), "a number".into(), "the end of the file".into());
        }
        let word = &rest[start..start + length];
        let number = std::str::from_utf8(word).ok().and_then(|w| w.parse().ok());
        let Some(number) = number else {
            let found = format!("{:?}", String::from_utf8_lossy(&word[..length.min(40)]));
            return malformed(self.at + start, "a number".into(), found);
        };
        self.at += start + length;
        Ok(number)
    }

    /// Refuses an element whose shortest form is longer than what is left.
    pub fn check_room(&self, element: &Element) -> Result<()> {
        let smallest = |p: &Property| match self.encoding {
            Encoding::Ascii => 2, // a digit and a space
            _ => p.list.unwrap_or(p.kind).size(),
        };
        let each: usize = element.properties.iter().map(smallest).sum();
        let left = self.bytes.len() - self.at;
        let left = if self.encoding == Encoding::Ascii { left + 1 } else { left }; // the last space may be missing
        if element.count > left / each.max(1) {
            let expected = format!("{} {} elements of at least {each} bytes", element.count, element.name);
            return malformed(self.at, expected, format!("{left} bytes to the end of the file"));
        }
        Ok(())
    }

    /// The bytes of an element whose values are little-endian floats and nothing else; the element has been checked for
    /// room.
    pub fn float_rows(&self, element: &Element) -> Option<&[u8]> {
        let floats = element.properties.iter().all(|p| p.kind == Kind::F32 && p.list.is_none());
        let length = element.count.checked_mul(4 * element.properties.len())?;
        let rows = self.bytes.get(self.at..self.at.checked_add(length)?)?;
        (floats && self.encoding == Encoding::LittleEndian).then_some(rows)
    }

    pub fn skip(&mut self, element: &Element) -> Result<()> {
        if element.properties.is_empty() {
            return Ok(());
        }
        self.check_room(element)?;
        for _ in 0..element.count {
            for property in &element.properties {
                self.skip_property(property)?;
            }
        }
        Ok(())
    }

    pub fn skip_property(&mut self, property: &Property) -> Result<()> {
        let Some(list) = property.list else { return self.number(property.kind).map(drop) };
        let start = self.at;
        let count = self.number(list)?;
        if !(count >= 0.0 && count.fract() == 0.0 && count <= self.bytes.len() as f64) {
            return malformed(start, "the length of a list inside the file".into(), count.to_string());
        }
        (0..count as usize).try_for_each(|_| self.number(property.kind).map(drop))
    }
}
