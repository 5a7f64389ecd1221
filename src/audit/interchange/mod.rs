//! A verified record in the words of other systems: files only, nothing is sent anywhere. The record itself stays the
//! evidence; these say where to find it and what it holds.

pub mod civium;
pub mod oscal;
pub mod slsa;

use super::canonical::sha256_hex;

/// A UUID made from a name, so that the same record always exports the same bytes: laid out as a name-based UUID (RFC
/// 9562 §5.5), but over SHA-256.
fn named_uuid(name: &str) -> String {
    let mut digits: Vec<u8> = sha256_hex(name.as_bytes()).into_bytes();
    digits[12] = b'5';
    digits[16] = b'a';
    let text = String::from_utf8_lossy(&digits[..32]).into_owned();
    format!("{}-{}-{}-{}-{}", &text[..8], &text[8..12], &text[12..16], &text[16..20], &text[20..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_gives_one_uuid() {
        let uuid = named_uuid("a");
        assert_eq!(uuid, named_uuid("a"));
        assert_ne!(uuid, named_uuid("b"));
        assert_eq!((uuid.len(), &uuid[14..15], &uuid[19..20]), (36, "5", "a"));
    }
}
