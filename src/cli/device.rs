//! `--device`: the GPU, the CPU, or the better of what is there.

use std::path::PathBuf;

use crate::Result;
use crate::audit::DataFolder;
use crate::splat::render::gpu::Gpu;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Device {
    /// The GPU where there is a real one, else the CPU.
    #[default]
    Auto,
    /// A GPU, in want of one a software implementation of Vulkan; fails without either.
    Gpu,
    Cpu,
}

impl Device {
    /// As [`Device::open`], silent where the CPU is taken for want of a GPU.
    ///
    /// Errors: as [`Device::open`].
    pub fn open_quietly(self, say: &mut dyn FnMut(&str)) -> Result<Option<Gpu>> {
        let mut lines = Vec::new();
        let gpu = self.open(&mut |line| lines.push(line.to_owned()))?;
        if gpu.is_some() {
            lines.iter().for_each(|line| say(line));
        }
        Ok(gpu)
    }

    /// The GPU to work on, None for the CPU. `say` gets one line on what was chosen or passed over, and why.
    ///
    /// Errors: environment, when a GPU was insisted on and none opens.
    pub fn open(self, say: &mut dyn FnMut(&str)) -> Result<Option<Gpu>> {
        match self {
            Device::Cpu => Ok(None),
            Device::Gpu => Gpu::open(true, kernels().as_deref()).map(|gpu| Some(told(gpu, say))),
            Device::Auto => Ok(match Gpu::open(false, kernels().as_deref()) {
                Ok(gpu) => Some(told(gpu, say)),
                Err(e) => {
                    say(&format!("no GPU is used: {e}"));
                    None
                }
            }),
        }
    }
}

/// Where compiled kernels are kept, for who has a data folder.
fn kernels() -> Option<PathBuf> {
    DataFolder::from_environment(|name| std::env::var_os(name)).ok().map(|data| kernels_in(&data))
}

pub(super) fn kernels_in(data: &DataFolder) -> PathBuf {
    data.path().join("cache").join("kernels")
}

fn told(gpu: Gpu, say: &mut dyn FnMut(&str)) -> Gpu {
    let (a, b) = (&gpu.adapter, &gpu.abilities);
    say(&format!(
        "{} ({}, {}{}): bindings to {} MiB, {}, {}",
        a.name,
        a.backend,
        a.driver,
        if a.hardware { "" } else { ", software" },
        a.largest_binding >> 20,
        if b.subgroups { format!("subgroups of {}", b.lanes) } else { "no subgroups".into() },
        match (b.float_atomics, b.swap_atomics) {
            (true, _) => "native float atomics",
            (false, true) => "float atomics by compare-and-swap",
            _ => "no float atomics",
        },
    ));
    gpu.notes.iter().for_each(|note| say(&format!("  {note}")));
    gpu
}
