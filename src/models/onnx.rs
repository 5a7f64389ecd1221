//! What an ONNX file says of itself, read without an engine and without its weights: tensors, opset, external data.
//!
//! Only the few fields needed of the protocol buffer `ModelProto` (onnx.proto3, ONNX 1.16) are looked at; payloads are
//! skipped, so a file of gigabytes takes a moment. Nothing in a file can make this read outside the file.

use std::io::{Read, Seek, SeekFrom};

use super::{Element, Port};

/// What was read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Description {
    /// In the order of the graph, without those that have a default in the file.
    pub inputs: Vec<Port>,
    pub outputs: Vec<Port>,
    /// Of the standard domain.
    pub opset: Option<u64>,
    /// Operator domains beside the standard one, e.g. `com.microsoft`.
    pub domains: Vec<String>,
    /// Numbers in all initialisers.
    pub parameters: u64,
    /// Where weights lie outside this file.
    pub external: Vec<External>,
}

/// A piece of another file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct External {
    pub tensor: String,
    pub location: String,
    pub offset: u64,
    /// To the end of the file where the model does not say.
    pub length: Option<u64>,
}

/// What is wrong with a file, in words for an error's `found`.
pub type Fault = String;

/// Subgraphs inside subgraphs are read this deep.
const DEEPEST: usize = 16;
/// Names and shapes longer than this are no names and shapes.
const LONGEST: u64 = 1 << 20;

/// Reads a description.
///
/// # Errors
/// A sentence when the bytes are no ONNX model, or end too early.
pub fn describe(file: &mut (impl Read + Seek)) -> Result<Description, Fault> {
    let end = file.seek(SeekFrom::End(0)).map_err(|e| e.to_string())?;
    file.seek(SeekFrom::Start(0)).map_err(|e| e.to_string())?;
    let mut reader = Reader { file, position: 0 };
    let mut out = Description::default();
    let mut graphs = 0;
    while let Some(field) = reader.field(end)? {
        match (field.number, field.wire) {
            (7, Wire::Bytes(stop)) => {
                graphs += 1;
                reader.graph(stop, &mut out, 0)?;
            }
            (8, Wire::Bytes(stop)) => reader.opset(stop, &mut out)?,
            (25, Wire::Bytes(stop)) => reader.function(stop, &mut out)?,
            (_, wire) => reader.skip(wire)?,
        }
    }
    if graphs != 1 || out.opset.is_none() || out.outputs.is_empty() {
        return Err("no ONNX model: no graph with outputs and an operator set".into());
    }
    Ok(out)
}

/// What follows a field's key: a number, or bytes up to a position in the file.
#[derive(Clone, Copy)]
enum Wire {
    Number(u64),
    Fixed(u64),
    Bytes(u64),
}

struct Field {
    number: u64,
    wire: Wire,
}

struct Reader<'a, F> {
    file: &'a mut F,
    position: u64,
}

fn truncated() -> Fault {
    "the file ends too early, or is no ONNX model".into()
}

impl<F: Read + Seek> Reader<'_, F> {
    fn byte(&mut self) -> Result<u8, Fault> {
        let mut one = [0];
        self.file.read_exact(&mut one).map_err(|_| truncated())?;
        self.position += 1;
        Ok(one[0])
    }

    fn varint(&mut self) -> Result<u64, Fault> {
        let mut value = 0u64;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err("a number of more than 64 bits: no ONNX model".into())
    }

    /// The next field before `end`.
    fn field(&mut self, end: u64) -> Result<Option<Field>, Fault> {
        if self.position == end {
            return Ok(None);
        }
        let key = self.varint()?;
        let wire = match key & 7 {
            0 => Wire::Number(self.varint()?),
            1 => Wire::Fixed(8),
            5 => Wire::Fixed(4),
            2 => {
                let length = self.varint()?;
                Wire::Bytes(self.position.checked_add(length).ok_or_else(truncated)?)
            }
            _ => return Err("no ONNX model: a field of unknown kind".into()),
        };
        let stop = match wire {
            Wire::Bytes(stop) => stop,
            Wire::Fixed(length) => self.position + length,
            Wire::Number(_) => self.position,
        };
        if stop > end || key >> 3 == 0 {
            return Err(truncated());
        }
        Ok(Some(Field { number: key >> 3, wire }))
    }

    fn skip(&mut self, wire: Wire) -> Result<(), Fault> {
        let stop = match wire {
            Wire::Number(_) => return Ok(()),
            Wire::Fixed(length) => self.position + length,
            Wire::Bytes(stop) => stop,
        };
        self.file.seek(SeekFrom::Start(stop)).map_err(|e| e.to_string())?;
        self.position = stop;
        Ok(())
    }

    fn text(&mut self, stop: u64) -> Result<String, Fault> {
        let length = stop - self.position;
        if length > LONGEST {
            return Err(format!("a name of {length} bytes"));
        }
        let mut bytes = vec![0; length as usize];
        self.file.read_exact(&mut bytes).map_err(|_| truncated())?;
        self.position = stop;
        String::from_utf8(bytes).map_err(|_| "a name that is not text".into())
    }

    fn opset(&mut self, end: u64, out: &mut Description) -> Result<(), Fault> {
        let (mut domain, mut version) = (String::new(), 0);
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (1, Wire::Bytes(stop)) => domain = self.text(stop)?,
                (2, Wire::Number(v)) => version = v,
                (_, wire) => self.skip(wire)?,
            }
        }
        if domain.is_empty() || domain == "ai.onnx" {
            out.opset = Some(version);
        } else {
            out.domains.push(domain);
        }
        Ok(())
    }

    fn graph(&mut self, end: u64, out: &mut Description, depth: usize) -> Result<(), Fault> {
        if depth > DEEPEST {
            return Err(format!("graphs in graphs, more than {DEEPEST} deep"));
        }
        let mut initialised = Vec::new();
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (1, Wire::Bytes(stop)) => self.node(stop, out, depth)?,
                (5, Wire::Bytes(stop)) => initialised.push(self.tensor(stop, out)?),
                (15, Wire::Bytes(stop)) => self.sparse(stop, out)?,
                (11, Wire::Bytes(stop)) if depth == 0 => {
                    let port = self.port(stop)?;
                    out.inputs.push(port);
                }
                (12, Wire::Bytes(stop)) if depth == 0 => {
                    let port = self.port(stop)?;
                    out.outputs.push(port);
                }
                (_, wire) => self.skip(wire)?,
            }
        }
        if depth == 0 {
            out.inputs.retain(|p| !initialised.contains(&p.name));
        }
        Ok(())
    }

    fn function(&mut self, end: u64, out: &mut Description) -> Result<(), Fault> {
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (7, Wire::Bytes(stop)) => self.node(stop, out, 1)?,
                (_, wire) => self.skip(wire)?,
            }
        }
        Ok(())
    }

    /// For the tensors and graphs in its attributes.
    fn node(&mut self, end: u64, out: &mut Description, depth: usize) -> Result<(), Fault> {
        while let Some(field) = self.field(end)? {
            let (5, Wire::Bytes(attribute)) = (field.number, field.wire) else {
                self.skip(field.wire)?;
                continue;
            };
            while let Some(field) = self.field(attribute)? {
                match (field.number, field.wire) {
                    (5 | 10, Wire::Bytes(stop)) => drop(self.tensor(stop, out)?),
                    (6 | 11, Wire::Bytes(stop)) => self.graph(stop, out, depth + 1)?,
                    (22 | 23, Wire::Bytes(stop)) => self.sparse(stop, out)?,
                    (_, wire) => self.skip(wire)?,
                }
            }
        }
        Ok(())
    }

    fn sparse(&mut self, end: u64, out: &mut Description) -> Result<(), Fault> {
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (1 | 2, Wire::Bytes(stop)) => drop(self.tensor(stop, out)?),
                (_, wire) => self.skip(wire)?,
            }
        }
        Ok(())
    }

    /// Its name; size and external data go to `out`.
    fn tensor(&mut self, end: u64, out: &mut Description) -> Result<String, Fault> {
        let (mut name, mut elements, mut bits, mut raw) = (String::new(), 1u64, 0u64, None);
        let mut external: Option<External> = None;
        let mut outside = false;
        let mut grow = |by: u64| -> Result<(), Fault> {
            elements = elements.checked_mul(by).filter(|n| *n < 1 << 40).ok_or("a tensor of impossible size")?;
            Ok(())
        };
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (1, Wire::Number(dim)) => grow(dim)?,
                (1, Wire::Bytes(stop)) => {
                    while self.position < stop {
                        grow(self.varint()?)?;
                    }
                }
                (2, Wire::Number(ty)) => bits = bits_of(ty),
                (8, Wire::Bytes(stop)) => name = self.text(stop)?,
                (9, Wire::Bytes(stop)) => {
                    raw = Some(stop - self.position);
                    self.skip(field.wire)?;
                }
                (13, Wire::Bytes(stop)) => {
                    let (key, value) = self.pair(stop)?;
                    let entry = external.get_or_insert(External {
                        tensor: String::new(),
                        location: String::new(),
                        offset: 0,
                        length: None,
                    });
                    let number = || value.parse::<u64>().map_err(|_| format!("external data with {key} `{value}`"));
                    match key.as_str() {
                        "location" => entry.location = value,
                        "offset" => entry.offset = number()?,
                        "length" => entry.length = Some(number()?),
                        _ => {}
                    }
                }
                (14, Wire::Number(place)) => outside = place == 1,
                (_, wire) => self.skip(wire)?,
            }
        }
        out.parameters = out.parameters.saturating_add(elements);
        let bytes = (elements * bits).div_ceil(8);
        match (outside, external) {
            (true, Some(entry)) => {
                if entry.length.is_some_and(|l| bits > 0 && l != bytes) {
                    return Err(format!("tensor {name} of {bytes} bytes with {:?} outside", entry.length));
                }
                out.external.push(External { tensor: name.clone(), ..entry });
            }
            (true, None) => return Err(format!("tensor {name} lies outside, but nothing says where")),
            // A shape that promises more than the file holds would have an engine set memory aside for nothing.
            (false, _) => {
                if raw.is_some_and(|r| bits > 0 && r != bytes) {
                    return Err(format!(
                        "tensor {name} of {bytes} bytes by its shape, {} in the file",
                        raw.unwrap_or(0)
                    ));
                }
            }
        }
        Ok(name)
    }

    fn pair(&mut self, end: u64) -> Result<(String, String), Fault> {
        let (mut key, mut value) = (String::new(), String::new());
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (1, Wire::Bytes(stop)) => key = self.text(stop)?,
                (2, Wire::Bytes(stop)) => value = self.text(stop)?,
                (_, wire) => self.skip(wire)?,
            }
        }
        Ok((key, value))
    }

    /// `ValueInfoProto` → `TypeProto` → `TypeProto.Tensor` → `TensorShapeProto`.
    fn port(&mut self, end: u64) -> Result<Port, Fault> {
        let mut port = Port { name: String::new(), shape: None, element: Some(Element::Other) };
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (1, Wire::Bytes(stop)) => port.name = self.text(stop)?,
                (2, Wire::Bytes(stop)) => {
                    while let Some(field) = self.field(stop)? {
                        match (field.number, field.wire) {
                            (1, Wire::Bytes(stop)) => self.tensor_type(stop, &mut port)?,
                            (_, wire) => self.skip(wire)?,
                        }
                    }
                }
                (_, wire) => self.skip(wire)?,
            }
        }
        Ok(port)
    }

    fn tensor_type(&mut self, end: u64, port: &mut Port) -> Result<(), Fault> {
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                (1, Wire::Number(ty)) => port.element = Some(element_of(ty)),
                (2, Wire::Bytes(stop)) => {
                    let mut dims = Vec::new();
                    while let Some(field) = self.field(stop)? {
                        match (field.number, field.wire) {
                            (1, Wire::Bytes(stop)) => dims.push(self.dimension(stop)?),
                            (_, wire) => self.skip(wire)?,
                        }
                    }
                    port.shape = Some(dims);
                }
                (_, wire) => self.skip(wire)?,
            }
        }
        Ok(())
    }

    fn dimension(&mut self, end: u64) -> Result<Option<usize>, Fault> {
        let mut size = None;
        while let Some(field) = self.field(end)? {
            match (field.number, field.wire) {
                // A negative size is another way to say that it is free.
                (1, Wire::Number(v)) => size = usize::try_from(v as i64).ok(),
                (_, wire) => self.skip(wire)?,
            }
        }
        Ok(size)
    }
}

/// `TensorProto.DataType`.
fn element_of(ty: u64) -> Element {
    match ty {
        1 => Element::F32,
        6 => Element::I32,
        7 => Element::I64,
        9 => Element::Bool,
        10 => Element::F16,
        11 => Element::F64,
        _ => Element::Other,
    }
}

/// Of one number in `raw_data`; 0 where it does not matter.
fn bits_of(ty: u64) -> u64 {
    match ty {
        1 | 6 | 12 => 32,
        2 | 3 | 9 | 17..=20 => 8,
        4 | 5 | 10 | 16 => 16,
        7 | 11 | 13 | 14 => 64,
        15 => 128,
        21..=23 => 4,
        _ => 0,
    }
}
