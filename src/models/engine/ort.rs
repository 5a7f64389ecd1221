//! A user's ONNX Runtime, loaded at run time: the CPU, CUDA, TensorRT.
//!
//! One library serves the whole process; what is loaded first stays.

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use half::f16;
use ort::environment::Environment;
use ort::ep::{self, ExecutionProvider as _};
use ort::session::builder::SessionBuilder;
use ort::session::{Session, SessionInputValue};
use ort::value::{DynValue, Outlet, Tensor as OrtTensor, TensorElementType as Type, TensorRef, ValueType};

use super::discovery::{Candidate, State};
use super::{Engine, Graph, Provider};
use crate::models::{Element, Port, Tensor};
use crate::{Error, Result};

/// The minor version of a library that is an ONNX Runtime 1.
pub(super) fn probe(path: &Path) -> Option<u32> {
    ort::util::probe(path)
}

/// Bytes of GPU memory that a session may take: with the largest of all, and what the driver keeps, a run stays below 8 GB.
const GPU_MEMORY: usize = 6 << 30;

/// An ONNX model: y = max(x, 0) of one number (IR version 8, operator set 17).
const SMALLEST: &[u8] = b"\x08\x08\x3a\x33\x0a\x0c\x0a\x01x\x12\x01y\x22\x04Relu\x12\x01g\
    \x5a\x0f\x0a\x01x\x12\x0a\x0a\x08\x08\x01\x12\x04\x0a\x02\x08\x01\
    \x62\x0f\x0a\x01y\x12\x0a\x0a\x08\x08\x01\x12\x04\x0a\x02\x08\x01\
    \x42\x02\x10\x11";

/// An ONNX Runtime with a provider that works.
pub struct Ort {
    environment: Environment,
    name: String,
    provider: Provider,
    /// TensorRT's engines, minutes to build, are kept here.
    cache: Option<PathBuf>,
}

/// The library and its environment, which are one a process by their own design: who opens them again gets the same.
static LOADED: Mutex<Option<(PathBuf, Environment)>> = Mutex::new(None);

fn environment(path: &Path, failed: &dyn Fn(&dyn std::fmt::Display) -> Error) -> Result<Environment> {
    let mut loaded = LOADED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    match &*loaded {
        Some((first, environment)) if first == path => return Ok(environment.clone()),
        Some((first, _)) => return Err(failed(&format!("{} is loaded, and stays", first.display()))),
        None => {}
    }
    let builder = ort::init_from(path).map_err(|e| failed(&e))?;
    let environment = builder.with_telemetry(false).build().map_err(|e| failed(&e))?;
    // Errors come back as results; what its libraries log besides is about ways that they tried and left (hundreds of lines a graph).
    environment.set_log_level(ort::logging::LogLevel::Fatal);
    *loaded = Some((path.to_owned(), environment.clone()));
    Ok(environment)
}

impl Ort {
    /// # Errors
    /// An environment error when the library does not load, or the provider that was asked for does not work.
    pub fn open(found: &Candidate, provider: Provider, cache: Option<&Path>, say: &mut dyn FnMut(&str)) -> Result<Ort> {
        let path = std::path::absolute(&found.path).ok().filter(|p| p.is_file()).unwrap_or_else(|| found.path.clone());
        let failed = |e: &dyn std::fmt::Display| {
            Error::environment(path.display().to_string()).expected("an ONNX Runtime").found(e.to_string())
        };
        let environment = environment(&path, &failed)?;
        let minor = match found.state {
            State::Good(minor) => format!("1.{minor}"),
            _ => "1".into(),
        };
        let mut engine = Ort { environment, name: String::new(), provider, cache: cache.map(Path::to_owned) };
        if provider == Provider::Auto {
            engine.provider = Provider::Cuda;
            if let Err(e) = engine.tried() {
                if !e.found.contains("built without") {
                    say(&format!("CUDA is not used: {}", e.found));
                }
                engine.provider = Provider::Cpu;
            }
        } else {
            // A provider that was asked for must work: found out now, not at the first network.
            engine.tried()?;
        }
        engine.name = format!("ONNX Runtime {minor} {}", engine.provider.name());
        say(&format!("{} ({}, {})", engine.name, found.origin, found.path.display()));
        Ok(engine)
    }

    /// Which providers this library was built with: name, and why not, if not.
    pub fn providers(&self) -> Vec<(&'static str, Option<String>)> {
        [Provider::Cpu, Provider::Cuda, Provider::Tensorrt]
            .map(|provider| {
                let tried = Ort {
                    environment: self.environment.clone(),
                    name: String::new(),
                    provider,
                    cache: self.cache.clone(),
                }
                .tried();
                (provider.name(), tried.err().map(|e| e.found))
            })
            .into()
    }

    /// Whether the provider computes: a library that was built with CUDA finds out that there is no GPU, or none that its kernels
    /// run on, when it first loads and runs a graph.
    fn tried(&self) -> Result<()> {
        self.builder()?;
        let one = Tensor::new(&[1], vec![1.0])?;
        let run = self.load(SMALLEST).and_then(|graph| graph.run(&[("x", &one)]));
        run.map(drop).map_err(|e| self.unusable(e.found))
    }

    fn unusable(&self, found: String) -> Error {
        Error::environment(format!("ONNX Runtime's provider {}", self.provider.name()))
            .expected("one that works on this machine")
            .found(found)
            .advice("Choose --provider cpu, or install the runtime's GPU build with the libraries it names.")
    }

    /// Options of a session that runs a few times and goes: no memory kept for later, exact graph as in the file.
    fn builder(&self) -> Result<SessionBuilder> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let failed = |e: String| self.unusable(e);
        let plain = |e: ort::Error<SessionBuilder>| failed(e.to_string());
        let builder = Session::builder(&self.environment)
            .map_err(|e| failed(e.to_string()))?
            .with_intra_threads(threads)
            .map_err(plain)?
            .with_memory_pattern(false)
            .map_err(plain)?;
        let compiled = |available: ort::Result<bool>| match available {
            Ok(true) => Ok(()),
            _ => Err(failed("a library built without it".into())),
        };
        let cuda = || {
            ep::CUDA::default()
                .with_arena_extend_strategy(ep::ArenaExtendStrategy::SameAsRequested)
                .with_memory_limit(GPU_MEMORY)
                // The usual search times every algorithm there is, each with all the memory it likes, and may choose another in the
                // next run.
                .with_conv_algorithm_search(ep::cuda::ConvAlgorithmSearch::Heuristic)
                // Ten bits of mantissa would put answers further from the CPU's than a thousandth.
                .with_tf32(false)
        };
        let providers = match self.provider {
            // Memory goes back to the system when a session goes.
            Provider::Auto | Provider::Cpu => vec![ep::CPU::default().with_arena_allocator(false).build()],
            Provider::Cuda => {
                compiled(ep::CUDA::is_available())?;
                vec![cuda().build().error_on_failure()]
            }
            Provider::Tensorrt => {
                compiled(ep::TensorRT::is_available())?;
                let mut tensorrt = ep::TensorRT::default();
                if let Some(folder) = &self.cache {
                    std::fs::create_dir_all(folder).map_err(|e| Error::io(folder, &e))?;
                    tensorrt = tensorrt.with_engine_cache(true).with_engine_cache_path(folder.display());
                }
                // What TensorRT leaves, CUDA takes.
                vec![tensorrt.build().error_on_failure(), cuda().build().error_on_failure()]
            }
        };
        builder.with_execution_providers(providers).map_err(plain)
    }

    fn loaded(session: ort::Result<Session>, what: &str) -> Result<Box<dyn Graph>> {
        let session = session.map_err(|e| {
            Error::environment(what).expected("an ONNX file that ONNX Runtime reads").found(e.to_string())
        })?;
        Ok(Box::new(Loaded(RefCell::new(session))))
    }
}

impl Engine for Ort {
    fn name(&self) -> &str {
        &self.name
    }

    fn on_gpu(&self) -> bool {
        matches!(self.provider, Provider::Cuda | Provider::Tensorrt)
    }

    fn load(&self, onnx: &[u8]) -> Result<Box<dyn Graph>> {
        Ort::loaded(self.builder()?.commit_from_memory(onnx), "network graph")
    }

    fn load_file(&self, path: &Path) -> Result<Box<dyn Graph>> {
        Ort::loaded(self.builder()?.commit_from_file(path), &path.display().to_string())
    }
}

/// A session wants to be borrowed for itself while it runs.
struct Loaded(RefCell<Session>);

fn element(ty: Type) -> Element {
    match ty {
        Type::Float32 => Element::F32,
        Type::Float16 => Element::F16,
        Type::Float64 => Element::F64,
        Type::Int64 => Element::I64,
        Type::Int32 => Element::I32,
        Type::Bool => Element::Bool,
        _ => Element::Other,
    }
}

fn port(outlet: &Outlet) -> Port {
    let (shape, element) = match outlet.dtype() {
        ValueType::Tensor { ty, shape, .. } => {
            (Some(shape.iter().map(|&d| usize::try_from(d).ok()).collect()), Some(element(*ty)))
        }
        _ => (None, Some(Element::Other)),
    };
    Port { name: outlet.name().to_owned(), shape, element }
}

impl Graph for Loaded {
    fn inputs(&self) -> Vec<Port> {
        self.0.borrow().inputs().iter().map(port).collect()
    }

    fn outputs(&self) -> Vec<Port> {
        self.0.borrow().outputs().iter().map(port).collect()
    }

    fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
        let failed = |e: &dyn std::fmt::Display| not_run(e.to_string());
        let ports = self.inputs();
        let mut fed: Vec<(&str, SessionInputValue)> = Vec::with_capacity(inputs.len());
        for (name, tensor) in inputs {
            let port = ports.iter().find(|p| p.name == *name).ok_or_else(|| {
                Error::environment(format!("network input {name}")).found("no input of that name in the graph")
            })?;
            let value = feed(tensor, port.element.unwrap_or(Element::F32)).map_err(|e| failed(&e))?;
            fed.push((name, value));
        }
        let mut session = self.0.borrow_mut();
        let outputs = session.run(fed).map_err(|e| failed(&e))?;
        outputs.iter().map(|(name, value)| Ok((name.to_owned(), taken(name, &value)?))).collect()
    }
}

/// Why a graph did not run; ONNX Runtime says of memory only what its arena found.
fn not_run(found: String) -> Error {
    let error = Error::environment("network");
    if !found.contains("BFCArena") {
        return error.found(found);
    }
    error
        .expected(format!("a network that runs in {} GiB of GPU memory", GPU_MEMORY >> 30))
        .found(found)
        .advice("Export it with sliced or fused attention, choose a smaller one, or run it with --provider cpu.")
}

/// In the type that the graph wants.
fn feed<'a>(tensor: &'a Tensor, element: Element) -> ort::Result<SessionInputValue<'a>> {
    let shape = tensor.shape.clone();
    let data = tensor.data.as_slice();
    Ok(match element {
        Element::F16 => {
            let half: Vec<f16> = data.iter().map(|&v| f16::from_f32(v)).collect();
            OrtTensor::from_array((shape, half))?.into()
        }
        Element::F64 => OrtTensor::from_array((shape, data.iter().map(|&v| f64::from(v)).collect::<Vec<_>>()))?.into(),
        Element::I64 => OrtTensor::from_array((shape, data.iter().map(|&v| v as i64).collect::<Vec<_>>()))?.into(),
        Element::I32 => OrtTensor::from_array((shape, data.iter().map(|&v| v as i32).collect::<Vec<_>>()))?.into(),
        Element::Bool => OrtTensor::from_array((shape, data.iter().map(|&v| v != 0.0).collect::<Vec<_>>()))?.into(),
        Element::F32 | Element::Other => TensorRef::from_array_view((shape, data))?.into(),
    })
}

fn taken(name: &str, value: &DynValue) -> Result<Tensor> {
    let wrong = |e: &dyn std::fmt::Display| {
        Error::environment(format!("network output {name}")).expected("a tensor of numbers").found(e.to_string())
    };
    let ValueType::Tensor { ty, shape, .. } = value.dtype() else { return Err(wrong(&"no tensor")) };
    let dims: Vec<usize> = shape.iter().map(|&d| usize::try_from(d).unwrap_or(0)).collect();
    macro_rules! numbers {
        ($type:ty, $convert:expr) => {
            value.try_extract_tensor::<$type>().map_err(|e| wrong(&e))?.1.iter().map($convert).collect()
        };
    }
    let data: Vec<f32> = match ty {
        Type::Float32 => numbers!(f32, |v| *v),
        Type::Float16 => numbers!(f16, |v| v.to_f32()),
        Type::Float64 => numbers!(f64, |v| *v as f32),
        Type::Int64 => numbers!(i64, |v| *v as f32),
        Type::Int32 => numbers!(i32, |v| *v as f32),
        Type::Bool => numbers!(bool, |v| f32::from(u8::from(*v))),
        other => return Err(wrong(&format!("{other:?}"))),
    };
    Tensor::new(&dims, data)
}

#[cfg(test)]
mod tests {
    use super::not_run;

    #[test]
    fn a_network_that_finds_no_room_says_what_to_do() {
        let arena = "bfc_arena.cc:360 void* onnxruntime::BFCArena::AllocateRawInternal(...) Available memory of 657444352 is \
                     smaller than requested bytes of 1314816000";
        let error = not_run(arena.into());
        assert!(error.expected.contains("6 GiB") && error.advice.contains("sliced"), "{error}");
        assert!(not_run("Got invalid dimensions for input: x".into()).advice.is_empty());
    }
}
