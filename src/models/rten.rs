//! The built-in engine: `rten`, pure Rust.

use super::{Engine, Graph, Port, Tensor};
use crate::{Error, Result};
use rten::{Dimension, Model, ModelOptions, NodeId, Value, ValueOrView};
use rten_tensor::TensorView;

/// Runs graphs on the CPU.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rten;

struct Loaded(Model);

impl Engine for Rten {
    fn name(&self) -> &'static str {
        "rten 0.27"
    }

    fn load(&self, onnx: &[u8]) -> Result<Box<dyn Graph>> {
        let model = ModelOptions::with_all_ops().load(onnx.to_vec()).map_err(|error| {
            Error::environment("network graph")
                .expected("an ONNX file that the built-in engine reads")
                .found(error.to_string())
        })?;
        Ok(Box::new(Loaded(model)))
    }
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
            Some(Port { name: info.name()?.to_owned(), shape })
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
            let view = TensorView::from_data(tensor.shape.as_slice(), tensor.data.as_slice());
            fed.push((id, view.into()));
        }
        let ids = self.0.output_ids();
        let names = self.outputs();
        let values = self.0.run(fed, ids, None).map_err(failed)?;
        let mut out = Vec::with_capacity(values.len());
        for (port, value) in names.into_iter().zip(values) {
            let Value::FloatTensor(tensor) = value else {
                return Err(Error::environment(format!("network output {}", port.name)).expected("32-bit floats"));
            };
            let shape = rten_tensor::Layout::shape(&tensor).to_vec();
            out.push((port.name, Tensor { shape, data: tensor.into_data() }));
        }
        Ok(out)
    }
}
