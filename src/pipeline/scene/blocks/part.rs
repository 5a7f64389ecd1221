//! What one part of a run in blocks leaves for the others, as a file: the coarse scene, or one block's Gaussians.

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::pipeline::scene::From;
use crate::splat::Gaussians;
use crate::splat::packed::{Core, Packed, Sh};
use crate::whole_file::{self, Found};
use crate::{Error, Result};

const KIND: &[u8; 8] = b"orbpart1";

/// One part's end.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    pub head: Head,
    /// In the unit frame; the sky's last.
    pub gaussians: Gaussians,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Head {
    /// What must be the same for parts to belong together: SHA-256 of photos, poses, options.
    pub run: String,
    /// `coarse`, `block 3 of 8`.
    pub what: String,
    pub gaussians: usize,
    /// How many of them are the sky's.
    pub sky: usize,
    /// How many photos it was trained on, in how many steps.
    pub photos: usize,
    pub steps: usize,
    /// Gaussians that it began with; whether at random places.
    pub begun: usize,
    pub random: bool,
    /// What stands behind all Gaussians.
    pub behind: [f32; 3],
}

impl Head {
    /// What the scene's first Gaussians were made of, the sky's left out.
    pub fn begun_from(&self) -> From {
        let begun = self.begun.saturating_sub(self.sky);
        if self.random { From::Random(begun) } else { From::Points(begun) }
    }
}

/// What a part's file says of itself; `None` for another file.
pub fn head(file: &[u8]) -> Option<Head> {
    match whole_file::of(file.to_vec(), KIND) {
        Found::Whole(bytes) => split(&bytes).map(|(head, _)| head),
        Found::Other | Found::Damaged => None,
    }
}

/// The head, and what follows.
fn split(bytes: &[u8]) -> Option<(Head, &[u8])> {
    let (length, rest) = bytes.split_first_chunk()?;
    let (head, rest) = rest.split_at_checked(u32::from_le_bytes(*length) as usize)?;
    Some((serde_json::from_slice(head).ok()?, rest))
}

impl Part {
    /// # Errors
    /// Environment: it cannot be written; an older file then still stands.
    pub fn write(&self, path: &Path) -> Result<()> {
        // Plain numbers and strings: this cannot fail.
        let head = serde_json::to_vec(&self.head).unwrap_or_default();
        let packed = Packed::pack(&self.gaussians);
        let mut out = Vec::with_capacity(4 + head.len() + 256 * packed.len());
        out.extend((head.len() as u32).to_le_bytes());
        out.extend(head);
        out.extend_from_slice(bytemuck::cast_slice(&packed.core));
        out.extend_from_slice(bytemuck::cast_slice(&packed.sh));
        whole_file::write(path, KIND, &out).map_err(|e| {
            Error::io(path, &e).expected("room for a part of the scene").advice("Choose another place with --parts.")
        })
    }

    /// The part, if there is one. `run` and `what`: what it has to be.
    ///
    /// # Errors
    /// Environment: it cannot be read. Usage: it is another run's, or no part. Integrity: it is cut off or changed.
    pub fn read(path: &Path, run: &str, what: &str) -> Result<Option<Part>> {
        let name = path.display().to_string();
        let bytes = match whole_file::read(path, KIND) {
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return Err(Error::io(path, &e)),
            Ok(Found::Other) => {
                return Err(Error::usage(name)
                    .expected("a part of a scene by this version of orb")
                    .found("another file"));
            }
            Ok(Found::Damaged) => {
                return Err(Error::integrity(name)
                    .expected("a part of a scene as it was written")
                    .found("one that is cut off or changed")
                    .advice("Remove it: it is trained again."));
            }
            Ok(Found::Whole(bytes)) => bytes,
        };
        let part = Part::parse(&bytes).ok_or_else(|| {
            Error::integrity(name.clone())
                .expected("a part as this version writes it")
                .found("other contents")
                .advice("Remove it: it is trained again.")
        })?;
        let asked = (run, what);
        let found = (part.head.run.as_str(), part.head.what.as_str());
        if asked != found {
            return Err(Error::usage(name)
                .expected(format!("{} of the run {}", asked.1, asked.0))
                .found(format!("{} of the run {}", found.1, found.0))
                .advice(
                    "Give the same photos and options as the run that it belongs to, or another folder with --parts.",
                ));
        }
        Ok(Some(part))
    }

    fn parse(bytes: &[u8]) -> Option<Part> {
        let (head, rest) = split(bytes)?;
        if head.gaussians.checked_mul(256)? != rest.len() || head.sky > head.gaussians {
            return None;
        }
        let (core, sh) = rest.split_at(64 * head.gaussians);
        let core: Vec<Core> = bytemuck::pod_collect_to_vec(core);
        let sh: Vec<Sh> = bytemuck::pod_collect_to_vec(sh);
        Some(Part { head, gaussians: Packed { core, sh }.unpack() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;
    use crate::splat::render::tests::scene;

    #[test]
    fn a_part_is_read_back_and_anothers_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("coarse/part");
        let what = |what: &str| Head {
            run: "ab".into(),
            what: what.into(),
            gaussians: 7,
            sky: 2,
            photos: 5,
            steps: 60,
            begun: 4,
            random: false,
            behind: [0.0, 0.1, 1.0],
        };
        let part = Part { head: what("coarse"), gaussians: scene(7, 0.1, 1) };
        assert_eq!(Part::read(&path, "ab", "coarse").unwrap(), None);
        part.write(&path).unwrap();
        assert_eq!(Part::read(&path, "ab", "coarse").unwrap(), Some(part.clone()));
        for (run, what) in [("ac", "coarse"), ("ab", "block 1 of 2")] {
            let e = Part::read(&path, run, what).unwrap_err();
            assert!(e.kind == Kind::Usage && e.to_string().contains("--parts"), "{e}");
        }
        let whole = std::fs::read(&path).unwrap();
        assert_eq!(head(&whole), Some(part.head.clone()));
        assert_eq!((head(&whole[..50]), head(b"ply\n")), (None, None));
        for (bytes, kind) in [(&whole[..50], Kind::Integrity), (b"ply\n", Kind::Usage)] {
            std::fs::write(&path, bytes).unwrap();
            assert_eq!(Part::read(&path, "ab", "coarse").unwrap_err().kind, kind);
        }
        // More Gaussians in its head than stand in it.
        Part { head: Head { gaussians: 8, ..part.head.clone() }, ..part }.write(&path).unwrap();
        assert_eq!(Part::read(&path, "ab", "coarse").unwrap_err().kind, Kind::Integrity);
    }
}
