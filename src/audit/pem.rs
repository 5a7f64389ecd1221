//! Textual encoding of keys: RFC 7468, the strict form.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// Largest file that is read as a key, bytes.
pub const MAX_BYTES: u64 = 64 * 1024;

/// `-----BEGIN label-----`, 64 columns of base64, `-----END label-----`.
pub fn encode(label: &str, der: &[u8]) -> String {
    let text = STANDARD.encode(der);
    let mut out = format!("-----BEGIN {label}-----\n");
    let mut rest = text.as_str();
    while !rest.is_empty() {
        let (line, tail) = rest.split_at(rest.len().min(64));
        out.push_str(line);
        out.push('\n');
        rest = tail;
    }
    out.push_str(&format!("-----END {label}-----\n"));
    out
}

/// Reads the one block in `text`; `Err` says in words what is wrong.
pub fn decode(label: &str, text: &str) -> Result<Vec<u8>, String> {
    let mut lines = text.trim().lines();
    let begin = format!("-----BEGIN {label}-----");
    let first = lines.next().unwrap_or_default().trim_end();
    if first != begin {
        return Err(match first.strip_prefix("-----BEGIN ").and_then(|f| f.strip_suffix("-----")) {
            Some(other) => format!("a PEM block of type {other}"),
            None => "no PEM block".into(),
        });
    }
    let end = format!("-----END {label}-----");
    let mut body = String::new();
    for line in lines.by_ref() {
        if line.trim_end() == end {
            if lines.next().is_some() {
                return Err("text after the PEM block".into());
            }
            return STANDARD.decode(body).map_err(|e| format!("a damaged PEM block ({e})"));
        }
        body.push_str(line.trim_end());
    }
    Err("a PEM block without its end".into())
}

/// The text of each block. What stands before the first belongs to it, so that [`decode`] refuses both.
pub fn blocks(text: &str) -> Vec<&str> {
    let mut blocks = Vec::new();
    let mut from = 0;
    for (at, _) in text.match_indices("-----BEGIN ").skip(1) {
        blocks.push(&text[from..at]);
        from = at;
    }
    blocks.push(&text[from..]);
    blocks
}

/// Reads one block after another, as chains of certificates stand in files; other lines between them are left out.
pub fn decode_all(label: &str, text: &str) -> Result<Vec<Vec<u8>>, String> {
    let (begin, end) = (format!("-----BEGIN {label}-----"), format!("-----END {label}-----"));
    let mut blocks = Vec::new();
    let mut rest = text;
    while let Some(from) = rest.find(&begin) {
        let to = rest[from..].find(&end).ok_or("a PEM block without its end")? + from + end.len();
        blocks.push(decode(label, &rest[from..to])?);
        rest = &rest[to..];
    }
    if blocks.is_empty() { Err(format!("no PEM block of type {label}")) } else { Ok(blocks) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn written_blocks_are_read() {
        for length in [0, 1, 47, 48, 49, 1000] {
            let der: Vec<u8> = (0..length).map(|i| i as u8).collect();
            let text = encode("PUBLIC KEY", &der);
            assert!(text.lines().all(|l| l.len() <= 64));
            assert_eq!(decode("PUBLIC KEY", &text), Ok(der.clone()));
            assert_eq!(decode("PUBLIC KEY", &text.replace('\n', "\r\n")), Ok(der));
            assert!(decode("PRIVATE KEY", &text).unwrap_err().contains("PUBLIC KEY"));
        }
    }

    #[test]
    fn blocks_one_after_another() {
        let (a, b) = (encode("PUBLIC KEY", b"one"), encode("PUBLIC KEY", b"two"));
        assert_eq!(blocks(&format!("{a}{b}")), [a.as_str(), &b]);
        assert_eq!(blocks(&a), [a.as_str()]);
        assert_eq!(blocks(""), [""]);
        let before = format!("words\n{a}");
        assert!(blocks(&before) == [before.as_str()] && decode("PUBLIC KEY", &before).is_err());
    }

    #[test]
    fn damaged_blocks_are_refused() {
        let text = encode("PUBLIC KEY", b"some bytes of a key");
        assert!(decode("PUBLIC KEY", "").is_err());
        assert!(decode("PUBLIC KEY", text.trim_end().trim_end_matches('-')).is_err());
        assert!(decode("PUBLIC KEY", &text.replacen('c', "!", 1)).is_err());
        assert!(decode("PUBLIC KEY", &format!("{text}{text}")).is_err());
    }
}
