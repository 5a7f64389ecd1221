//! What runs a graph: `rten` built in, a user's ONNX Runtime where there is one.

pub mod discovery;
#[cfg(feature = "ort")]
mod ort;
mod rten;

use std::path::Path;

#[cfg(feature = "ort")]
pub use self::ort::Ort;
pub use self::rten::Rten;
use super::{Port, Tensor};
use crate::{Error, Result};
use discovery::Search;

/// Loads graphs. Implementations keep their own types out of every signature here.
pub trait Engine: Sync {
    /// As the record of a run names it, e.g. `rten 0.27`.
    fn name(&self) -> &str;
    /// Runs on a GPU.
    fn on_gpu(&self) -> bool {
        false
    }
    /// # Errors
    /// An environment error when the bytes are no ONNX graph that this engine can run.
    fn load(&self, onnx: &[u8]) -> Result<Box<dyn Graph>>;
    /// The same of bytes that stay, as the built-in weights do: read where they are, where the engine can.
    ///
    /// # Errors
    /// As [`Engine::load`].
    fn load_static(&self, onnx: &'static [u8]) -> Result<Box<dyn Graph>> {
        self.load(onnx)
    }
    /// The same from a file, whose external data lies beside it.
    ///
    /// # Errors
    /// As [`Engine::load`].
    fn load_file(&self, path: &Path) -> Result<Box<dyn Graph>>;
}

/// A loaded graph: drop it to give its memory back.
pub trait Graph: Send {
    fn inputs(&self) -> Vec<Port>;
    fn outputs(&self) -> Vec<Port>;
    /// All outputs, in the graph's order.
    ///
    /// # Errors
    /// An environment error naming the input or output that does not fit.
    fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>>;
}

/// Which engine runs imported networks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Choice {
    /// ONNX Runtime where one is found, else the built-in engine.
    #[default]
    Auto,
    /// The built-in engine, on the CPU.
    Rten,
    /// ONNX Runtime; fails without one.
    Ort,
}

/// What ONNX Runtime computes on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Provider {
    /// CUDA where it works, else the CPU.
    #[default]
    Auto,
    Cpu,
    /// NVIDIA; fails where the runtime cannot use it.
    Cuda,
    /// NVIDIA TensorRT; fails where the runtime cannot use it.
    Tensorrt,
}

impl Provider {
    pub fn name(self) -> &'static str {
        match self {
            Provider::Auto => "auto",
            Provider::Cpu => "CPU",
            Provider::Cuda => "CUDA",
            Provider::Tensorrt => "TensorRT",
        }
    }
}

/// The engine asked for. `say` gets a line on what was found where the choice was Orb's.
///
/// # Errors
/// An environment error when what was asked for is missing: never another engine or provider in its place.
pub fn open(choice: Choice, provider: Provider, search: &Search, say: &mut dyn FnMut(&str)) -> Result<Box<dyn Engine>> {
    let insists = matches!(provider, Provider::Cuda | Provider::Tensorrt);
    if choice == Choice::Rten {
        if insists {
            return Err(Error::usage("--provider")
                .expected(format!("--engine ort, which alone knows {}", provider.name()))
                .found("--engine rten, which computes on the CPU"));
        }
        return Ok(Box::new(Rten));
    }
    let candidates = discovery::look(search);
    if let Some(bad) = candidates.iter().find(|c| c.asked_for && !c.is_good()) {
        return Err(Error::environment(format!("{} ({})", bad.origin, bad.path.display()))
            .expected(format!("an ONNX Runtime library, 1.{} or newer", discovery::LEAST_MINOR))
            .found(bad.state.to_string())
            .advice("Point it at a libonnxruntime that this machine can load, or leave it out."));
    }
    let Some(best) = candidates.iter().find(|c| c.is_good()) else {
        if choice == Choice::Ort || insists {
            return Err(missing_runtime(&candidates));
        }
        say("no ONNX Runtime is found: imported networks run on the built-in engine, on the CPU");
        return Ok(Box::new(Rten));
    };
    open_runtime(best, provider, search, say)
}

fn missing_runtime(candidates: &[discovery::Candidate]) -> Error {
    let looked: Vec<String> = candidates.iter().map(|c| format!("{}: {}", c.path.display(), c.state)).collect();
    Error::environment("ONNX Runtime")
        .expected(format!("a libonnxruntime, 1.{} or newer", discovery::LEAST_MINOR))
        .found(if looked.is_empty() { "none".to_owned() } else { looked.join("; ") })
        .advice("Name one with --onnxruntime or ORT_DYLIB_PATH; the Python wheel `onnxruntime` brings one.")
}

#[cfg(feature = "ort")]
fn open_runtime(
    best: &discovery::Candidate,
    provider: Provider,
    search: &Search,
    say: &mut dyn FnMut(&str),
) -> Result<Box<dyn Engine>> {
    Ok(Box::new(Ort::open(best, provider, search.cache.as_deref(), say)?))
}

#[cfg(not(feature = "ort"))]
fn open_runtime(
    best: &discovery::Candidate,
    _: Provider,
    _: &Search,
    _: &mut dyn FnMut(&str),
) -> Result<Box<dyn Engine>> {
    Err(Error::environment(best.path.display().to_string())
        .expected("a program built with the feature `ort`")
        .found("one built without it")
        .advice("Use --engine rten."))
}
