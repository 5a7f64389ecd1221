//! Compiled kernels kept in a file from run to run, for drivers that keep none or have lost theirs.

use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::whole_file::{self, Found};

const KIND: &[u8; 8] = b"orbkern1";

/// The kernels of one adapter under one driver.
pub(super) struct Kept {
    pub cache: wgpu::PipelineCache,
    file: PathBuf,
    /// What was read; empty: nothing.
    read: Vec<u8>,
}

impl Kept {
    /// Takes up what `folder` holds for this adapter. A file that is damaged, or another driver's, counts as none.
    pub fn open(device: &wgpu::Device, info: &wgpu::AdapterInfo, folder: &Path) -> Kept {
        let file = folder.join(name(info));
        let read = match whole_file::read(&file, KIND) {
            Ok(Found::Whole(bytes)) => bytes,
            _ => Vec::new(),
        };
        let data = (!read.is_empty()).then_some(read.as_slice());
        let descriptor = wgpu::PipelineCacheDescriptor { label: Some("kernels"), data, fallback: true };
        // SAFETY: the bytes were written by `save` for the adapter and driver in the file's name, and arrived whole:
        // their SHA-256 is right. The file lies in the user's own folder, as a driver's cache does.
        let cache = unsafe { device.create_pipeline_cache(&descriptor) };
        Kept { cache, file, read }
    }

    /// Writes what is new. Whatever prevents it is no error: the next start takes longer.
    pub fn save(&self) {
        if let Some(data) = self.cache.get_data().filter(|d| !d.is_empty() && *d != self.read) {
            let _ = whole_file::write(&self.file, KIND, &data);
        }
    }
}

fn name(info: &wgpu::AdapterInfo) -> String {
    let what = format!(
        "{:?} {} {} {} {} {} {}",
        info.backend,
        info.vendor,
        info.device,
        info.name,
        info.driver,
        info.driver_info,
        env!("CARGO_PKG_VERSION")
    );
    format!("{}.kernels", hex::encode(&Sha256::digest(what)[..8]))
}
