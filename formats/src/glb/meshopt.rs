//! `EXT_meshopt_compression`: buffer views that a decoder unfolds, vertices in the order in which triangles name them.
//!
//! Sources: Khronos' registry, EXT_meshopt_compression (complete) and KHR_meshopt_compression (its successor, a draft when
//! this was written, with the same JSON: read where its new colour filter is not needed, not written); the codecs are
//! meshoptimizer's, by the crate `meshoptimizer-rs`. Normals and tangents become 16-bit integers (`KHR_mesh_quantization`).

use meshoptimizer_rs::codec::{self, BufferView, ExpMode, Filter, IndexEncoding, Mode, VertexEncoding};
use meshoptimizer_rs::{Limits, Workspace, optimize_vertex_cache, optimize_vertex_fetch_remap};
use serde::Deserialize;
use serde_json::{Value, json};

use super::FORMAT;
use super::write::{ARRAY_BUFFER, Buffer, ELEMENT_ARRAY_BUFFER, FLOAT, UNSIGNED_INT, UNSIGNED_SHORT, bounds};
use crate::{Error, Result};

pub const NAME: &str = "EXT_meshopt_compression";
pub const SUCCESSOR: &str = "KHR_meshopt_compression";
pub const QUANTIZATION: &str = "KHR_mesh_quantization";
const SHORT: u32 = 5122;

/// Bits of a coordinate with its sign: steps of 2⁻¹⁷ of the power of two that the largest of its axis is below.
pub const POSITION_BITS: u32 = 18;
/// Bits of a texture coordinate with its sign.
pub const UV_BITS: u32 = 16;
/// Bits of each octahedral coordinate of a direction.
pub const NORMAL_BITS: u32 = 12;

/// How a buffer view is packed, in either extension.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Packed {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: usize,
    pub count: usize,
    pub mode: String,
    #[serde(default)]
    pub filter: Option<String>,
}

impl Packed {
    /// The bytes of the view, at most `most`.
    ///
    /// # Errors
    /// [`Error::Malformed`] for a broken stream; [`Error::Unsupported`] for other modes and filters, and for what unfolds to
    /// more.
    pub fn unpack(&self, bin: &[u8], most: usize) -> Result<Vec<u8>> {
        let unknown = |what: &str| Error::unsupported(FORMAT, format!("{what} of a compressed buffer view"));
        let mode = Mode::parse(&self.mode).map_err(|_| unknown(&format!("the mode {}", self.mode)))?;
        let filter = self.filter.as_deref().unwrap_or("NONE");
        let filter = Filter::parse(filter).map_err(|_| unknown(&format!("the filter {filter}")))?;
        let broken = |e: meshoptimizer_rs::Error| {
            let expected = format!("{} values of {} bytes, packed", self.count, self.byte_stride);
            Error::malformed(FORMAT, 20, expected, e.to_string())
        };
        let view = BufferView::new(mode, filter, self.count, self.byte_stride).map_err(broken)?;
        if view.byte_length() > most {
            return Err(Error::unsupported(
                FORMAT,
                "compressed buffer views that unfold to many times the file's size",
            ));
        }
        let source = bin.get(self.byte_offset..).and_then(|rest| rest.get(..self.byte_length));
        let source = source.ok_or_else(|| {
            let found = format!("{} bytes at {}", self.byte_length, self.byte_offset);
            Error::malformed(FORMAT, 20, format!("packed bytes inside {}", bin.len()), found)
        })?;
        let limits =
            Limits { max_bytes: view.byte_length().saturating_mul(2).saturating_add(1 << 20), ..Limits::default() };
        view.decode(source, &mut Workspace::new(limits)).map_err(broken)
    }
}

/// Triangles in an order that packs well, and for each new vertex the old one. Vertices of no triangle are left out.
pub fn order(corners: &[u32], vertices: usize) -> Result<(Vec<u32>, Vec<u32>)> {
    let mut work = Workspace::default();
    let corners = optimize_vertex_cache(corners, vertices, &mut work).map_err(refused)?;
    let new = optimize_vertex_fetch_remap(&corners, vertices, &mut work).map_err(refused)?;
    let mut old = vec![0; new.vertex_count];
    for (from, &to) in (0u32..).zip(&new.remap) {
        if let Some(place) = old.get_mut(to as usize) {
            *place = from;
        }
    }
    let corners = corners.iter().filter_map(|&c| new.remap.get(c as usize).copied()).collect();
    Ok((corners, old))
}

fn refused(e: meshoptimizer_rs::Error) -> Error {
    Error::unsupported(FORMAT, format!("the mesh cannot be compressed: {e}"))
}

/// What a packed view says of itself.
struct Layout {
    mode: &'static str,
    filter: Option<&'static str>,
    count: usize,
    stride: usize,
}

/// The parts of a primitive, packed; each gives the number of its accessor.
impl Buffer {
    /// Floats rounded to so many bits of the largest of their component.
    pub fn packed_floats<const N: usize>(&mut self, values: &[[f32; N]], bits: u32, bounded: bool) -> Result<usize> {
        let mut work = Workspace::default();
        let (count, stride) = (values.len(), 4 * N);
        let mode = ExpMode::SharedComponent;
        let mut filtered =
            codec::encode_filter_exp(count, stride, bits, values.as_flattened(), mode, &mut work).map_err(refused)?;
        let layout = Layout { mode: "ATTRIBUTES", filter: Some("EXPONENTIAL"), count, stride };
        let view = self.packed_attributes(&filtered, &layout, &mut work)?;
        let kind = ["", "SCALAR", "VEC2", "VEC3", "VEC4"][N];
        let mut accessor = json!({ "bufferView": view, "componentType": FLOAT, "count": count, "type": kind });
        if bounded {
            codec::decode_filter_exp(&mut filtered, count, stride, &mut work).map_err(refused)?;
            let float = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
            let rows = filtered.chunks_exact(stride).map(|row| std::array::from_fn(|i| float(&row[4 * i..])));
            bounds::<N>(&mut accessor, &rows.collect::<Vec<_>>());
        }
        self.accessors.push(accessor);
        Ok(self.accessors.len() - 1)
    }

    /// Directions of length 1, and with `signed` the sign that follows each.
    pub fn packed_directions(&mut self, values: &[[f32; 4]], signed: bool) -> Result<usize> {
        let mut work = Workspace::default();
        let (count, stride) = (values.len(), 8);
        let filtered = codec::encode_filter_oct(count, stride, NORMAL_BITS, values.as_flattened(), &mut work);
        let layout = Layout { mode: "ATTRIBUTES", filter: Some("OCTAHEDRAL"), count, stride };
        let view = self.packed_attributes(&filtered.map_err(refused)?, &layout, &mut work)?;
        let kind = if signed { "VEC4" } else { "VEC3" };
        self.accessors.push(
            json!({ "bufferView": view, "componentType": SHORT, "normalized": true, "count": count, "type": kind }),
        );
        Ok(self.accessors.len() - 1)
    }

    /// Corners of triangles.
    pub fn packed_triangles(&mut self, corners: &[u32], vertices: usize) -> Result<usize> {
        let mut work = Workspace::default();
        let bytes = codec::encode_index_buffer(corners, IndexEncoding::DEFAULT, &mut work).map_err(refused)?;
        // 65535 is the restart value, which no index may have.
        let (stride, component) = if vertices <= 65_535 { (2, UNSIGNED_SHORT) } else { (4, UNSIGNED_INT) };
        let layout = Layout { mode: "TRIANGLES", filter: None, count: corners.len(), stride };
        let view = self.packed_view(&bytes, &layout);
        self.accessors
            .push(json!({ "bufferView": view, "componentType": component, "count": corners.len(), "type": "SCALAR" }));
        Ok(self.accessors.len() - 1)
    }

    fn packed_attributes(&mut self, filtered: &[u8], layout: &Layout, work: &mut Workspace) -> Result<usize> {
        // The version that the extension is written for; the level is the later version's.
        let version = VertexEncoding::new(0, 0).map_err(refused)?;
        let bytes =
            codec::encode_vertex_buffer(filtered, layout.count, layout.stride, version, work).map_err(refused)?;
        Ok(self.packed_view(&bytes, layout))
    }

    /// A view of the buffer that is not there, and beside it where its packed bytes are.
    fn packed_view(&mut self, bytes: &[u8], layout: &Layout) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let start = self.unfolded.unwrap_or(0).next_multiple_of(4);
        let length = layout.count * layout.stride;
        let mut packed = json!({
            "buffer": 0,
            "byteOffset": self.bytes.len(),
            "byteLength": bytes.len(),
            "byteStride": layout.stride,
            "count": layout.count,
            "mode": layout.mode,
        });
        let mut view = json!({ "buffer": 1, "byteOffset": start, "byteLength": length });
        match layout.filter {
            Some(filter) => {
                packed["filter"] = filter.into();
                view["byteStride"] = layout.stride.into();
                view["target"] = ARRAY_BUFFER.into();
            }
            None => view["target"] = ELEMENT_ARRAY_BUFFER.into(),
        }
        view["extensions"] = json!({ NAME: packed });
        self.bytes.extend_from_slice(bytes);
        self.unfolded = Some(start + length);
        self.views.push(view);
        self.views.len() - 1
    }
}

/// The buffer whose bytes are unfolded from another.
pub fn fallback(length: usize) -> Value {
    json!({ "byteLength": length, "extensions": { NAME: { "fallback": true } } })
}
