//! Networks: engines, graphs, one file a family.
//!
//! A stage names the tensors it wants; which engine runs the graph is no concern of it.

pub mod align;
pub mod colour_model;
pub mod guided;
pub mod prior;
pub mod region;
mod rten;
pub mod scene;
pub mod splat_prior;

pub use self::rten::Rten;

use crate::{Error, Result};

/// Row-major, last dimension fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Tensor {
    pub shape: Vec<usize>,
    pub data: Vec<f32>,
}

impl Tensor {
    /// # Errors
    /// An environment error when the shape and the data disagree: a fault in the program, not in an input.
    pub fn new(shape: &[usize], data: Vec<f32>) -> Result<Self> {
        let expected: usize = shape.iter().product();
        if expected != data.len() {
            return Err(Error::environment("tensor")
                .expected(format!("{expected} numbers for shape {shape:?}"))
                .found(data.len().to_string()));
        }
        Ok(Tensor { shape: shape.to_vec(), data })
    }
}

/// Loads graphs. Implementations keep their own types out of every signature here.
pub trait Engine: Sync {
    /// As the record of a run names it, e.g. `rten 0.27`.
    fn name(&self) -> &'static str;
    /// # Errors
    /// An environment error when the bytes are no ONNX graph that this engine can run.
    fn load(&self, onnx: &[u8]) -> Result<Box<dyn Graph>>;
}

/// A loaded graph: drop it to give its memory back.
pub trait Graph {
    fn inputs(&self) -> Vec<Port>;
    fn outputs(&self) -> Vec<Port>;
    /// All outputs, in the graph's order.
    ///
    /// # Errors
    /// An environment error naming the input or output that does not fit.
    fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>>;
}

/// A named input or output; `None` stands for a free dimension or an unknown shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    pub name: String,
    pub shape: Option<Vec<Option<usize>>>,
}

impl Port {
    pub fn new(name: &str, shape: &[usize]) -> Self {
        Port { name: name.to_owned(), shape: Some(shape.iter().map(|&d| Some(d)).collect()) }
    }

    fn accepts(&self, wanted: &Port) -> bool {
        let (Some(have), Some(want)) = (&self.shape, &wanted.shape) else { return true };
        have.len() == want.len()
            && have.iter().zip(want).all(|(a, b)| match (a, b) {
                (Some(a), Some(b)) => a == b,
                _ => true,
            })
    }
}

impl std::fmt::Display for Port {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ", self.name)?;
        let Some(shape) = &self.shape else { return write!(f, "[…]") };
        let dims: Vec<String> = shape.iter().map(|d| d.map_or("?".to_owned(), |d| d.to_string())).collect();
        write!(f, "[{}]", dims.join(","))
    }
}

/// Compares a graph with what a stage wants of it.
///
/// # Errors
/// An environment error that lists every missing or different port, `-` wanted and `+` found, as a diff does.
pub fn check_contract(what: &str, graph: &dyn Graph, inputs: &[Port], outputs: &[Port]) -> Result<()> {
    let mut lines = Vec::new();
    for (kind, wanted, found) in [("input", inputs, graph.inputs()), ("output", outputs, graph.outputs())] {
        for port in wanted {
            match found.iter().find(|p| p.name == port.name) {
                Some(p) if p.accepts(port) => {}
                Some(p) => lines.push(format!("- {kind} {port}\n+ {kind} {p}")),
                None => lines.push(format!("- {kind} {port}")),
            }
        }
        // An output more is harmless, an input more cannot be fed.
        let extra = found.iter().filter(|p| !wanted.iter().any(|w| w.name == p.name));
        lines.extend(
            extra.filter(|_| kind == "input" || !lines.is_empty()).map(|p| format!("+ {kind} {p}")).collect::<Vec<_>>(),
        );
    }
    if lines.is_empty() {
        return Ok(());
    }
    Err(Error::environment(what)
        .expected("a graph with the tensors marked -")
        .found(format!("these differences:\n{}", lines.join("\n")))
        .advice("The weights are not those that this version was made for."))
}

/// Takes one output by name.
pub(crate) fn take(outputs: &mut Vec<(String, Tensor)>, name: &str, len: usize) -> Result<Vec<f32>> {
    let missing = |found: String| Error::environment(format!("network output {name}")).found(found);
    let at = outputs.iter().position(|(n, _)| n == name).ok_or_else(|| missing("nothing of that name".into()))?;
    let (_, tensor) = outputs.swap_remove(at);
    if tensor.data.len() != len {
        return Err(missing(format!("{} numbers", tensor.data.len())).expected(format!("{len} numbers")));
    }
    if !tensor.data.iter().all(|v| v.is_finite()) {
        return Err(missing("a number that is not finite".into()));
    }
    Ok(tensor.data)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Fixed;
    impl Graph for Fixed {
        fn inputs(&self) -> Vec<Port> {
            vec![Port { name: "image".into(), shape: Some(vec![None, Some(3)]) }]
        }
        fn outputs(&self) -> Vec<Port> {
            vec![Port::new("mask", &[1, 4]), Port::new("more", &[1])]
        }
        fn run(&self, _: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            Ok(vec![])
        }
    }

    #[test]
    fn a_contract_that_holds_passes() {
        check_contract("net", &Fixed, &[Port::new("image", &[1, 3])], &[Port::new("mask", &[1, 4])]).unwrap();
    }

    #[test]
    fn a_contract_that_breaks_lists_each_difference() {
        let error =
            check_contract("net", &Fixed, &[Port::new("picture", &[1, 3])], &[Port::new("mask", &[1, 5])]).unwrap_err();
        for line in ["- input picture [1,3]", "+ input image [?,3]", "- output mask [1,5]", "+ output mask [1,4]"] {
            assert!(error.found.contains(line), "{error}");
        }
    }

    #[test]
    fn outputs_are_taken_by_name_and_checked() {
        let mut outputs = vec![("a".to_owned(), Tensor::new(&[2], vec![1.0, f32::NAN]).unwrap())];
        assert!(take(&mut outputs.clone(), "b", 2).is_err());
        assert!(take(&mut outputs.clone(), "a", 3).is_err());
        assert!(take(&mut outputs, "a", 2).unwrap_err().found.contains("not finite"));
        assert!(Tensor::new(&[2, 2], vec![0.0; 3]).is_err());
    }
}
