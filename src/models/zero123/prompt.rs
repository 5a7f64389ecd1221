//! The constants of the prompt: what the text encoder says to "", and the ramp that the picture's embedding is added by.
//!
//! The text encoder never sees anything else, so its 340 million weights stay at home.

use std::path::Path;

use crate::audit::disk::read_limited;
use crate::{Error, Result};

/// Tokens of a prompt.
pub const TOKENS: usize = 77;
/// Numbers a token.
pub const WIDTH: usize = 1024;

/// Read from a safetensors file with the tensors `prompt_embeds` (77 × 1024) and `ramp` (77), 32- or 16-bit floats; extra
/// dimensions of 1 do not matter.
#[derive(Clone, Debug, PartialEq)]
pub struct Prompt {
    /// 77 × 1024.
    pub empty: Vec<f32>,
    /// 77.
    pub ramp: Vec<f32>,
}

impl Prompt {
    /// # Errors
    /// A usage error that says what is missing.
    pub fn read(path: &Path) -> Result<Prompt> {
        let bytes = read_limited(path, 8 << 20)?;
        Prompt::parse(&bytes).map_err(|found| {
            Error::usage(path.display().to_string())
                .expected("a safetensors file with prompt_embeds [77,1024] and ramp [77]")
                .found(found)
        })
    }

    /// Layout: the header's length (8 bytes, little-endian), the header (JSON), the data.
    fn parse(bytes: &[u8]) -> Result<Prompt, String> {
        let (length, rest) = bytes.split_first_chunk::<8>().ok_or("a file of less than 8 bytes")?;
        let length = usize::try_from(u64::from_le_bytes(*length)).unwrap_or(usize::MAX);
        let (header, data) = rest.split_at_checked(length).ok_or("a header longer than the file")?;
        let header: serde_json::Value = serde_json::from_slice(header).map_err(|e| format!("a header: {e}"))?;
        let tensor = |name: &str, count: usize| -> Result<Vec<f32>, String> {
            let entry = &header[name];
            let number = |i: usize| entry["data_offsets"][i].as_u64().and_then(|v| usize::try_from(v).ok());
            let (start, end) = number(0).zip(number(1)).ok_or_else(|| format!("no tensor {name}"))?;
            let raw = data.get(start..end).ok_or_else(|| format!("{name} outside the file"))?;
            let values: Vec<f32> = match entry["dtype"].as_str() {
                Some("F32") => raw.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect(),
                Some("F16") => raw.chunks_exact(2).map(|b| from_half(u16::from_le_bytes([b[0], b[1]]))).collect(),
                other => return Err(format!("{name} of type {other:?}")),
            };
            match values.len() == count && values.iter().all(|v| v.is_finite()) {
                true => Ok(values),
                false => Err(format!("{name} with {} numbers, or some not finite", values.len())),
            }
        };
        Ok(Prompt { empty: tensor("prompt_embeds", TOKENS * WIDTH)?, ramp: tensor("ramp", TOKENS)? })
    }
}

/// IEEE 754 binary16.
fn from_half(bits: u16) -> f32 {
    let sign = if bits & 0x8000 == 0 { 1.0 } else { -1.0 };
    let (exponent, fraction) = (i32::from(bits >> 10 & 0x1f), f32::from(bits & 0x3ff));
    sign * match exponent {
        0 => fraction * 2f32.powi(-24),
        31 if fraction == 0.0 => f32::INFINITY,
        31 => f32::NAN,
        _ => (1.0 + fraction / 1024.0) * 2f32.powi(exponent - 15),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A file as the export writes it.
    pub(crate) fn file(empty: f32, ramp: impl Fn(usize) -> f32) -> Vec<u8> {
        let first = TOKENS * WIDTH * 4;
        let header = format!(
            r#"{{"prompt_embeds":{{"dtype":"F32","shape":[1,77,1024],"data_offsets":[0,{first}]}},"ramp":{{"dtype":"F32","shape":[77],"data_offsets":[{first},{}]}}}}"#,
            first + TOKENS * 4
        );
        let mut out = (header.len() as u64).to_le_bytes().to_vec();
        out.extend_from_slice(header.as_bytes());
        (0..TOKENS * WIDTH).for_each(|_| out.extend_from_slice(&empty.to_le_bytes()));
        (0..TOKENS).for_each(|i| out.extend_from_slice(&ramp(i).to_le_bytes()));
        out
    }

    #[test]
    fn a_file_reads_back() {
        let prompt = Prompt::parse(&file(0.25, |i| i as f32)).unwrap();
        assert!(prompt.empty.len() == TOKENS * WIDTH && prompt.empty.iter().all(|v| *v == 0.25));
        assert_eq!(prompt.ramp[76], 76.0);
    }

    #[test]
    fn damaged_files_say_what_is_wrong() {
        let good = file(0.25, |_| 1.0);
        for (bytes, words) in [
            (good[..4].to_vec(), "8 bytes"),
            (good[..100].to_vec(), "longer than the file"),
            (good[..good.len() - 4].to_vec(), "outside the file"),
            (file(f32::NAN, |_| 1.0), "not finite"),
        ] {
            let error = Prompt::parse(&bytes).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
    }

    #[test]
    fn half_floats_are_read_as_the_standard_says() {
        for (bits, value) in
            [(0x3c00, 1.0), (0xc000, -2.0), (0x3555, 0.333_251_95), (0x0001, 2f32.powi(-24)), (0x7bff, 65504.0)]
        {
            assert_eq!(from_half(bits), value);
        }
        assert!(from_half(0x7e00).is_nan() && from_half(0xfc00) == f32::NEG_INFINITY);
    }
}
