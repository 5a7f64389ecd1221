//! Tiles made earlier, by what decided them: an hour's work is not done twice.

use std::path::{Path, PathBuf};

use image::{ImageFormat, RgbImage};
use sha2::{Digest as _, Sha256};

use super::{Settings, TILE};
use crate::audit::canonical::sha256_hex;
use crate::audit::disk::read_limited;
use crate::{Error, Result};

/// A folder of PNG files, `<key>-<sha256 of the file>.png`: one that was changed is not found.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
}

/// SHA-256 over the picture, the weights, the engine and the settings.
pub fn key(picture: &RgbImage, weights_sha256: &str, engine: &str, settings: &Settings) -> String {
    let mut hash = Sha256::new();
    let Settings { steps, guidance, seed } = settings;
    let (w, h) = picture.dimensions();
    hash.update(format!("orb.six-views/v1\n{weights_sha256}\n{engine}\n{steps}\n{guidance}\n{seed}\n{w}x{h}\n"));
    hash.update(picture.as_raw());
    hex::encode(hash.finalize())
}

impl Cache {
    pub fn at(folder: impl Into<PathBuf>) -> Cache {
        Cache { folder: folder.into() }
    }

    /// The tile of a key; none where there is none, or not as it was written.
    pub fn get(&self, key: &str) -> Option<RgbImage> {
        let prefix = format!("{key}-");
        for entry in std::fs::read_dir(&self.folder).ok()?.flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            let Some(sha256) = name.strip_prefix(&prefix).and_then(|n| n.strip_suffix(".png")) else { continue };
            let bytes = read_limited(&entry.path(), 64 << 20).ok()?;
            if sha256_hex(&bytes) == sha256 {
                let tile = image::load_from_memory_with_format(&bytes, ImageFormat::Png).ok()?.into_rgb8();
                return (tile.dimensions() == TILE).then_some(tile);
            }
        }
        None
    }

    /// # Errors
    /// An environment error when the folder cannot be written.
    pub fn put(&self, key: &str, tile: &RgbImage) -> Result<()> {
        let mut bytes = Vec::new();
        tile.write_to(&mut std::io::Cursor::new(&mut bytes), ImageFormat::Png)
            .map_err(|e| Error::environment("six views").found(e.to_string()))?;
        let write = |path: &Path| -> std::io::Result<()> {
            std::fs::create_dir_all(&self.folder)?;
            // Written aside first: two runs may write the same.
            let aside = self.folder.join(format!(".{}-{key}", std::process::id()));
            std::fs::write(&aside, &bytes)?;
            std::fs::rename(aside, path)
        };
        let path = self.folder.join(format!("{key}-{}.png", sha256_hex(&bytes)));
        write(&path).map_err(|e| Error::io(&path, &e))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tile_is_found_by_its_key_until_it_is_changed() {
        let dir = tempfile::tempdir().unwrap();
        let cache = Cache::at(dir.path().join("views"));
        let picture = RgbImage::new(4, 4);
        let settings = Settings::default();
        let k = key(&picture, "aa", "rten", &settings);
        assert!(cache.get(&k).is_none());
        let tile = RgbImage::from_fn(TILE.0, TILE.1, |x, y| image::Rgb([x as u8, y as u8, 9]));
        cache.put(&k, &tile).unwrap();
        assert_eq!(cache.get(&k), Some(tile));
        for other in [
            key(&RgbImage::new(4, 5), "aa", "rten", &settings),
            key(&picture, "ab", "rten", &settings),
            key(&picture, "aa", "ONNX Runtime", &settings),
            key(&picture, "aa", "rten", &Settings { seed: 1, ..settings }),
            key(&picture, "aa", "rten", &Settings { steps: 29, ..settings }),
            key(&picture, "aa", "rten", &Settings { guidance: 1.0, ..settings }),
        ] {
            assert!(other != k && cache.get(&other).is_none());
        }
        let file = std::fs::read_dir(dir.path().join("views")).unwrap().next().unwrap().unwrap().path();
        let mut bytes = std::fs::read(&file).unwrap();
        let last = bytes.len() - 30;
        bytes[last] ^= 1;
        std::fs::write(&file, bytes).unwrap();
        assert!(cache.get(&k).is_none());
    }
}
