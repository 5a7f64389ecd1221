//! Tensors, the named inputs and outputs of a graph, and the comparison of both with what a stage wants.

use super::Graph;
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

/// Type of the numbers in a file; inside Orb all are `f32`, and the engine converts at its door.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    F32,
    F16,
    F64,
    I64,
    I32,
    Bool,
    Other,
}

impl Element {
    pub fn is_float(self) -> bool {
        matches!(self, Element::F32 | Element::F16 | Element::F64)
    }

    pub fn is_integer(self) -> bool {
        matches!(self, Element::I64 | Element::I32)
    }

    /// What a stage feeds as one of these can be fed as the other.
    fn accepts(self, wanted: Element) -> bool {
        self == wanted || self.is_float() && wanted.is_float() || self.is_integer() && wanted.is_integer()
    }

    fn name(self) -> &'static str {
        match self {
            Element::F32 => "float32",
            Element::F16 => "float16",
            Element::F64 => "float64",
            Element::I64 => "int64",
            Element::I32 => "int32",
            Element::Bool => "bool",
            Element::Other => "another type",
        }
    }
}

/// A named input or output; `None` stands for a free dimension, an unknown shape, an unknown type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    pub name: String,
    pub shape: Option<Vec<Option<usize>>>,
    pub element: Option<Element>,
}

impl Port {
    /// Floats of a fixed shape.
    pub fn new(name: &str, shape: &[usize]) -> Self {
        Port::free(name, &shape.iter().map(|&d| Some(d)).collect::<Vec<_>>())
    }

    /// Floats; `None` for a dimension that may be anything.
    pub fn free(name: &str, shape: &[Option<usize>]) -> Self {
        Port { name: name.to_owned(), shape: Some(shape.to_vec()), element: Some(Element::F32) }
    }

    /// Floats of any shape.
    pub fn any(name: &str) -> Self {
        Port { name: name.to_owned(), shape: None, element: Some(Element::F32) }
    }

    /// The same port with whole numbers.
    pub fn integer(self) -> Self {
        Port { element: Some(Element::I64), ..self }
    }

    /// Whether a stage that wants `wanted` can work with this.
    pub fn accepts(&self, wanted: &Port) -> bool {
        if let (Some(have), Some(want)) = (self.element, wanted.element)
            && !have.accepts(want)
        {
            return false;
        }
        let (Some(have), Some(want)) = (&self.shape, &wanted.shape) else { return true };
        // Published SAM 2 encoders declare some outputs as scalars, which they are not.
        have.is_empty()
            || have.len() == want.len()
                && have.iter().zip(want).all(|(a, b)| match (a, b) {
                    (Some(a), Some(b)) => a == b,
                    _ => true,
                })
    }
}

impl std::fmt::Display for Port {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ", self.name)?;
        match &self.shape {
            None => write!(f, "[…]")?,
            Some(shape) => {
                let dims: Vec<String> = shape.iter().map(|d| d.map_or("?".to_owned(), |d| d.to_string())).collect();
                write!(f, "[{}]", dims.join(","))?;
            }
        }
        self.element.map_or(Ok(()), |e| write!(f, " {}", e.name()))
    }
}

/// Compares a graph with what a stage wants of it.
///
/// # Errors
/// An environment error that lists every missing or different port, `-` wanted and `+` found, as a diff does.
pub fn check_contract(what: &str, graph: &dyn Graph, inputs: &[Port], outputs: &[Port]) -> Result<()> {
    let lines = difference(&graph.inputs(), &graph.outputs(), inputs, outputs);
    if lines.is_empty() {
        return Ok(());
    }
    Err(Error::environment(what)
        .expected("a graph with the tensors marked -")
        .found(format!("these differences:\n{}", lines.join("\n")))
        .advice("The weights are not those that this version was made for."))
}

/// Every missing or different port, `-` wanted and `+` found; empty when the stage can work with the graph.
pub fn difference(found_inputs: &[Port], found_outputs: &[Port], inputs: &[Port], outputs: &[Port]) -> Vec<String> {
    let mut lines = Vec::new();
    for (kind, wanted, found) in [("input", inputs, found_inputs), ("output", outputs, found_outputs)] {
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
    lines
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
            vec![Port::free("image", &[None, Some(3)])]
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
        for line in [
            "- input picture [1,3] float32",
            "+ input image [?,3] float32",
            "- output mask [1,5]",
            "+ output mask [1,4]",
        ] {
            assert!(error.found.contains(line), "{error}");
        }
    }

    #[test]
    fn types_must_fit_and_precision_may_differ() {
        let half = Port { element: Some(Element::F16), ..Port::new("image", &[1]) };
        let whole = Port::new("image", &[1]).integer();
        let narrow = Port { element: Some(Element::I32), ..whole.clone() };
        assert!(half.accepts(&Port::new("image", &[1])) && narrow.accepts(&whole));
        assert!(!whole.accepts(&half) && !half.accepts(&whole));
        let lines = difference(&[whole], &[], &[half], &[]);
        assert_eq!(lines, ["- input image [1] float16\n+ input image [1] int64"]);
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
