//! The built-in engine: `rten`, pure Rust.

use std::path::Path;

use rten::{DataType, Dimension, LoadError, Model, ModelOptions, NodeId, Value, ValueOrView, ValueType};
use rten_tensor::{Layout, TensorView};

use super::{Engine, Graph};
use crate::models::{Element, Port, Tensor};
use crate::{Error, Result};

/// Runs graphs on the CPU.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rten;

struct Loaded(Model);

impl Engine for Rten {
    fn name(&self) -> &str {
        "rten 0.27"
    }

    fn load(&self, onnx: &[u8]) -> Result<Box<dyn Graph>> {
        loaded(ModelOptions::with_all_ops().load(onnx.to_vec()), "network graph")
    }

    fn load_static(&self, onnx: &'static [u8]) -> Result<Box<dyn Graph>> {
        loaded(ModelOptions::with_all_ops().load_static_slice(onnx), "network graph")
    }

    fn load_file(&self, path: &Path) -> Result<Box<dyn Graph>> {
        loaded(ModelOptions::with_all_ops().load_file(path), &path.display().to_string())
    }
}

fn loaded(model: Result<Model, LoadError>, what: &str) -> Result<Box<dyn Graph>> {
    let model = model.map_err(|error| {
        Error::environment(what)
            .expected("an ONNX file that the built-in engine reads")
            .found(error.to_string())
            .advice("Where the file is sound, ONNX Runtime may run it: --engine ort.")
    })?;
    Ok(Box::new(Loaded(model)))
}

impl Loaded {
    fn ports(&self, ids: &[NodeId]) -> Vec<Port> {
        let port = |id: &NodeId| {
            let info = self.0.node_info(*id)?;
            let fixed = |d: Dimension| match d {
                Dimension::Fixed(size) => Some(size),
                Dimension::Symbolic(_) => None,
            };
            let shape = info.shape().map(|dims| dims.into_iter().map(fixed).collect());
            let element = info.dtype().map(|ty| match ty {
                ValueType::Tensor(DataType::Float) => Element::F32,
                // 64-bit integers are read as 32-bit ones.
                ValueType::Tensor(DataType::Int32) => Element::I32,
                _ => Element::Other,
            });
            Some(Port { name: info.name()?.to_owned(), shape, element })
        };
        ids.iter().filter_map(port).collect()
    }
}

impl Graph for Loaded {
    fn inputs(&self) -> Vec<Port> {
        self.ports(self.0.input_ids())
    }

    fn outputs(&self) -> Vec<Port> {
        self.ports(self.0.output_ids())
    }

    fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
        let failed = |error: rten::RunError| Error::environment("network").found(error.to_string());
        let mut fed: Vec<(NodeId, ValueOrView)> = Vec::with_capacity(inputs.len());
        for (name, tensor) in inputs {
            let id = self.0.node_id(name).map_err(failed)?;
            let whole =
                matches!(self.0.node_info(id).and_then(|i| i.dtype()), Some(ValueType::Tensor(DataType::Int32)));
            let shape = tensor.shape.as_slice();
            if whole {
                let data: Vec<i32> = tensor.data.iter().map(|&v| v as i32).collect();
                fed.push((id, Value::from(rten_tensor::Tensor::from_data(shape, data)).into()));
            } else {
                fed.push((id, TensorView::from_data(shape, tensor.data.as_slice()).into()));
            }
        }
        let ids = self.0.output_ids();
        let names = self.outputs();
        let values = self.0.run(fed, ids, None).map_err(failed)?;
        let mut out = Vec::with_capacity(values.len());
        for (port, value) in names.into_iter().zip(values) {
            let (shape, data) = match value {
                Value::FloatTensor(t) => (t.shape().to_vec(), t.into_data()),
                Value::Int32Tensor(t) => (t.shape().to_vec(), t.into_data().into_iter().map(|v| v as f32).collect()),
                _ => return Err(Error::environment(format!("network output {}", port.name)).expected("32-bit numbers")),
            };
            out.push((port.name, Tensor { shape, data }));
        }
        Ok(out)
    }
}
