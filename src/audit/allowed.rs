//! Lists of the only network weights that may have been used (`--models FILE`).

use std::path::Path;

use super::disk;
use crate::{Error, Result};

/// Largest list that is read, bytes: ten thousand digests with names.
const MAX_BYTES: u64 = 1 << 20;
/// Of a line that is no digest, characters that an error shows.
const SHOWN: usize = 80;

/// The SHA-256 digests of a list: the first word of each line, as `sha256sum` writes them, in lower case. Empty lines and
/// those that begin with `#` say nothing.
///
/// # Errors
/// [`crate::Kind::Usage`] naming the file and the line that does not begin with a digest, or the file that holds none;
/// [`crate::Kind::Environment`] when it cannot be read.
pub fn read(path: &Path) -> Result<Vec<String>> {
    let text = disk::read_limited(path, MAX_BYTES)?;
    let mut digests = Vec::new();
    for (n, line) in String::from_utf8_lossy(&text).trim_start_matches('\u{feff}').lines().enumerate() {
        let Some(word) = line.split_whitespace().next().filter(|word| !word.starts_with('#')) else { continue };
        if word.len() != 64 || !word.bytes().all(|b| b.is_ascii_hexdigit()) {
            return Err(Error::usage(format!("{}, line {}", path.display(), n + 1))
                .expected("64 hexadecimal digits, the SHA-256 of weights, and then anything")
                .found(format!("{:?}", line.trim().chars().take(SHOWN).collect::<String>()))
                .advice("`sha256sum FILE` writes such lines; `#` begins a remark."));
        }
        digests.push(word.to_ascii_lowercase());
    }
    if digests.is_empty() {
        return Err(Error::usage(path.display().to_string())
            .expected("at least one line that begins with the SHA-256 of weights")
            .found("none")
            .advice("A list without any would refuse every network."));
    }
    Ok(digests)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;

    #[test]
    fn lists_that_are_good_and_lists_that_are_not() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("allowed.txt");
        let read = |text: &[u8]| {
            std::fs::write(&path, text).unwrap();
            super::read(&path)
        };
        let (a, b) = ("ab".repeat(32), "01".repeat(32));
        let good = format!("# of the unit\n\n{a}  depth/model.onnx\r\n  {} *scene.rten\n", b.to_uppercase());
        assert_eq!(read(good.as_bytes()).unwrap(), [a.clone(), b.clone()]);
        assert_eq!(read(format!("\u{feff}{a}").as_bytes()).unwrap(), [a.as_str()]);

        let (short, long, letters) = (&a[1..], format!("{a}0"), format!("{}g", &a[1..]));
        for (what, line) in [("short", short), ("long", &long), ("letters", &letters), ("a name", "depth.onnx")] {
            let error = read(format!("{b}\n#\n{line} x\n").as_bytes()).unwrap_err();
            let shown = format!("{line} x");
            assert_eq!((error.kind, error.found), (Kind::Usage, format!("{shown:?}")), "{what}");
            assert!(error.subject.ends_with("allowed.txt, line 3"), "{}", error.subject);
            assert!(error.expected.contains("64 hexadecimal digits"), "{}", error.expected);
        }
        for text in [&b""[..], b"\n\n", b"# nothing yet\n"] {
            let error = read(text).unwrap_err();
            assert!(error.kind == Kind::Usage && error.subject.ends_with("allowed.txt"), "{error}");
        }
        // Not text at all, and much of it.
        assert!(read(&[0xff; 5000]).unwrap_err().found.chars().count() < 2 * SHOWN);
        assert!(read(&vec![b'\n'; (1 << 20) + 1]).unwrap_err().expected.contains("at most"));
        assert_eq!(super::read(&dir.path().join("none")).unwrap_err().kind, Kind::Environment);
    }
}
