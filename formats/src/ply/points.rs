//! Coloured points: what structure from motion leaves beside poses.

use super::header::Header;
use super::malformed;
use super::values::Source;
use crate::Result;

/// A point and its colour; mid-grey where the file has none.
pub type Point = ([f64; 3], [u8; 3]);

/// Reads the vertices of any PLY: x, y, z and, where they are there, red, green, blue in 0 to 255. Other properties and
/// elements are skipped.
///
/// # Errors
/// [`crate::Error::Malformed`] with the byte offset for a broken header, a missing coordinate or a cut file.
pub fn points(bytes: &[u8]) -> Result<Vec<Point>> {
    let header = Header::parse(bytes)?;
    let mut source = Source { bytes, at: header.end, encoding: header.encoding };
    for element in &header.elements {
        if element.name != "vertex" {
            source.skip(element)?;
            continue;
        }
        let names = ["x", "y", "z", "red", "green", "blue"];
        let place = |name: &str| names.iter().position(|n| *n == name);
        if let Some(missing) = names[..3].iter().find(|n| !element.properties.iter().any(|p| p.name == **n)) {
            return malformed(element.offset, format!("a vertex property {missing}"), "none".into());
        }
        source.check_room(element)?;
        let mut out = Vec::with_capacity(element.count);
        for _ in 0..element.count {
            let mut values = [0.0, 0.0, 0.0, 128.0, 128.0, 128.0];
            for property in &element.properties {
                match place(&property.name).filter(|_| property.list.is_none()) {
                    Some(k) => values[k] = source.number(property.kind)?,
                    None => source.skip_property(property)?,
                }
            }
            let [x, y, z, r, g, b] = values;
            out.push(([x, y, z], [r, g, b].map(|v| v.round().clamp(0.0, 255.0) as u8)));
        }
        return Ok(out);
    }
    malformed(header.end, "an element called vertex".into(), "none".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_either_encoding_with_and_without_colours() {
        let text = b"ply\nformat ascii 1.0\nelement vertex 2\nproperty double z\nproperty float x\nproperty uchar red\n\
            property float y\nproperty uchar green\nproperty uchar blue\nelement face 0\nend_header\n3 1 255 2 0 7\n-3 -1 1 -2 2 3\n";
        assert_eq!(points(text).unwrap(), [([1.0, 2.0, 3.0], [255, 0, 7]), ([-1.0, -2.0, -3.0], [1, 2, 3])]);
        let mut binary =
            b"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                .to_vec();
        binary.extend([0.5f32, 1.5, -2.5].iter().flat_map(|v| v.to_le_bytes()));
        assert_eq!(points(&binary).unwrap(), [([0.5, 1.5, -2.5], [128; 3])]);
        assert!(points(&binary[..binary.len() - 1]).is_err());
        let no_z = String::from_utf8_lossy(text).replace("double z", "double w");
        assert!(points(no_z.as_bytes()).unwrap_err().to_string().contains("property z"));
    }
}
