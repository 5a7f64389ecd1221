//! Layer → crate file, version 0.8.0 (OpenUSD, `pxr/usd/usd/crateFile.h`).
//!
//! A header of 88 bytes; values too large for their reference; then the sections: tokens, strings, fields (a name and a
//! value), sets of fields, the tree of paths, specs (a path, a set of fields, a kind); last the table of contents.
//! All numbers are little-endian. 0.8.0 (2018) is the oldest version that OpenUSD of today does not call deprecated.

use std::collections::HashMap;

use super::layer::{Kind, Spec, Value};
use super::packing::{pack, pack_ints};

pub const MAGIC: &[u8; 8] = b"PXR-USDC";
pub const SECTIONS: [&str; 6] = ["TOKENS", "STRINGS", "FIELDS", "FIELDSETS", "PATHS", "SPECS"];
/// Ends a set of fields.
pub const END: u32 = u32::MAX;

/// Bits of a reference to a value.
pub const ARRAY: u64 = 1 << 63;
pub const INLINED: u64 = 1 << 62;
pub const COMPRESSED: u64 = 1 << 61;
pub const PAYLOAD: u64 = (1 << 48) - 1;

/// Numbers of types.
pub mod code {
    pub const BOOL: u8 = 1;
    pub const INT: u8 = 3;
    pub const FLOAT: u8 = 8;
    pub const DOUBLE: u8 = 9;
    pub const STRING: u8 = 10;
    pub const TOKEN: u8 = 11;
    pub const ASSET: u8 = 12;
    /// x, y, z, w.
    pub const QUATF: u8 = 17;
    pub const VEC2F: u8 = 20;
    pub const VEC3F: u8 = 24;
    pub const VEC4F: u8 = 28;
    pub const DICTIONARY: u8 = 31;
    pub const TOKEN_LIST: u8 = 32;
    pub const PATH_LIST: u8 = 34;
    pub const TOKENS: u8 = 41;
    pub const SPECIFIER: u8 = 42;
    pub const VARIABILITY: u8 = 44;
}

/// Bits of a list operation: it has prepended items; it is explicit and has items.
pub const PREPENDED: u8 = 1 << 5;
pub const EXPLICIT: u8 = 1 | 1 << 1;

/// The bytes of a layer. The names of children become the fields `primChildren` and `properties`.
pub fn encode(root: &Spec) -> Vec<u8> {
    let mut out = Encoder { bytes: vec![0; 88], ..Encoder::default() };
    // Token 0 is nobody's name: the sign of a path's token says whether it is a property.
    out.token("");
    number_paths(root, String::new(), &mut out.paths);
    out.spec(root, "");
    let mut tree = Tree::default();
    out.path_tree(root, "", false, &mut tree);
    let mut sections = Vec::new();
    for name in SECTIONS {
        let begin = out.bytes.len();
        out.section(name, &tree);
        sections.push((name, begin, out.bytes.len() - begin));
    }
    let contents = out.bytes.len() as u64;
    out.u64(sections.len());
    for (name, start, size) in sections {
        let mut field = [0; 16];
        field[..name.len()].copy_from_slice(name.as_bytes());
        out.bytes.extend(field);
        out.u64(start);
        out.u64(size);
    }
    let version = [0, 8, 0, 0, 0, 0, 0, 0];
    let header = [*MAGIC, version, contents.to_le_bytes()].concat();
    out.bytes[..header.len()].copy_from_slice(&header);
    out.bytes
}

/// The paths in the order of their tree.
#[derive(Default)]
struct Tree {
    indices: Vec<i32>,
    /// Negative for properties.
    tokens: Vec<i32>,
    /// Entries to the sibling where there are children too; 0 for a sibling alone, −1 for children alone, −2 for none.
    jumps: Vec<i32>,
}

/// `/Model`, `/Model/Mesh`, `/Model/Mesh.points`.
pub fn join(parent: &str, child: &Spec) -> String {
    match child.kind {
        Kind::Root => String::new(),
        Kind::Prim => format!("{parent}/{}", child.name),
        Kind::Attribute | Kind::Relationship => format!("{parent}.{}", child.name),
    }
}

fn number_paths(spec: &Spec, path: String, paths: &mut HashMap<String, u32>) {
    let next = paths.len() as u32;
    paths.insert(path.clone(), next);
    for child in &spec.children {
        number_paths(child, join(&path, child), paths);
    }
}

#[derive(Default)]
struct Encoder {
    bytes: Vec<u8>,
    tokens: Vec<String>,
    token_of: HashMap<String, u32>,
    strings: Vec<u32>,
    fields: Vec<(u32, u64)>,
    sets: Vec<u32>,
    specs: Vec<[u32; 3]>,
    paths: HashMap<String, u32>,
}

impl Encoder {
    fn u32(&mut self, value: u32) {
        self.bytes.extend(value.to_le_bytes());
    }

    fn u64(&mut self, value: usize) {
        self.bytes.extend((value as u64).to_le_bytes());
    }

    fn token(&mut self, text: &str) -> u32 {
        if let Some(&index) = self.token_of.get(text) {
            return index;
        }
        let index = self.tokens.len() as u32;
        self.tokens.push(text.to_owned());
        self.token_of.insert(text.to_owned(), index);
        index
    }

    fn string(&mut self, text: &str) -> u32 {
        let token = self.token(text);
        if let Some(index) = self.strings.iter().position(|&s| s == token) {
            return index as u32;
        }
        self.strings.push(token);
        self.strings.len() as u32 - 1
    }

    fn ints(&mut self, values: &[i32]) {
        let packed = pack_ints(values);
        self.u64(packed.len());
        self.bytes.extend(packed);
    }

    fn section(&mut self, name: &str, tree: &Tree) {
        match name {
            "TOKENS" => {
                let text: Vec<u8> = self.tokens.iter().flat_map(|t| [t.as_bytes(), b"\0"].concat()).collect();
                let packed = pack(&text);
                self.u64(self.tokens.len());
                self.u64(text.len());
                self.u64(packed.len());
                self.bytes.extend(packed);
            }
            "STRINGS" => {
                let strings = std::mem::take(&mut self.strings);
                self.u64(strings.len());
                strings.iter().for_each(|s| self.u32(*s));
            }
            "FIELDS" => {
                let fields = std::mem::take(&mut self.fields);
                self.u64(fields.len());
                self.ints(&fields.iter().map(|(token, _)| *token as i32).collect::<Vec<_>>());
                let values: Vec<u8> = fields.iter().flat_map(|(_, value)| value.to_le_bytes()).collect();
                let packed = pack(&values);
                self.u64(packed.len());
                self.bytes.extend(packed);
            }
            "FIELDSETS" => {
                let sets = std::mem::take(&mut self.sets);
                self.u64(sets.len());
                self.ints(&sets.iter().map(|s| *s as i32).collect::<Vec<_>>());
            }
            "PATHS" => {
                self.u64(tree.indices.len());
                self.u64(tree.indices.len());
                self.ints(&tree.indices);
                self.ints(&tree.tokens);
                self.ints(&tree.jumps);
            }
            _ => {
                let specs = std::mem::take(&mut self.specs);
                self.u64(specs.len());
                for column in 0..3 {
                    self.ints(&specs.iter().map(|s| s[column] as i32).collect::<Vec<_>>());
                }
            }
        }
    }

    fn spec(&mut self, spec: &Spec, path: &str) {
        let names = |prims: bool| {
            let of_kind = spec.children.iter().filter(|c| (c.kind == Kind::Prim) == prims);
            of_kind.map(|c| c.name.clone()).collect::<Vec<_>>()
        };
        let mut fields: Vec<(&str, Value)> = spec.fields.iter().map(|(n, v)| (n.as_str(), v.clone())).collect();
        for (field, names) in [("primChildren", names(true)), ("properties", names(false))] {
            if !names.is_empty() {
                fields.push((field, Value::Tokens(names)));
            }
        }
        let first = self.sets.len() as u32;
        for (name, value) in fields {
            let token = self.token(name);
            let value = self.value(&value);
            self.fields.push((token, value));
            self.sets.push(self.fields.len() as u32 - 1);
        }
        self.sets.push(END);
        self.specs.push([self.paths[path], first, spec.kind as u32]);
        for child in &spec.children {
            self.spec(child, &join(path, child));
        }
    }

    /// Writes what does not fit into a reference; the reference.
    fn value(&mut self, value: &Value) -> u64 {
        let inlined = |code: u8, bits: u32| INLINED | u64::from(code) << 48 | u64::from(bits);
        match value {
            Value::Bool(b) => inlined(code::BOOL, u32::from(*b)),
            Value::Int(i) => inlined(code::INT, *i as u32),
            Value::Float(f) => inlined(code::FLOAT, f.to_bits()),
            Value::String(s) => inlined(code::STRING, self.string(s)),
            Value::Token(t) => inlined(code::TOKEN, self.token(t)),
            Value::Asset(path) => inlined(code::ASSET, self.token(path)),
            Value::Specifier(s) => inlined(code::SPECIFIER, *s),
            Value::Variability(v) => inlined(code::VARIABILITY, *v),
            Value::Double(d) => self.stored(code::DOUBLE, &d.to_le_bytes()),
            Value::Vec3f(v) => self.floats(code::VEC3F, v),
            Value::Vec4f(v) => self.floats(code::VEC4F, v),
            Value::Ints(v) => self.array(code::INT, v.len(), v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Value::Floats(v) => self.array(code::FLOAT, v.len(), v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Value::Quatfs(v) => {
                let in_file = |[w, x, y, z]: &[f32; 4]| [*x, *y, *z, *w].map(f32::to_le_bytes);
                self.array(code::QUATF, v.len(), v.iter().flat_map(in_file).flatten().collect())
            }
            Value::Vec2fs(v) => {
                self.array(code::VEC2F, v.len(), v.iter().flatten().flat_map(|x| x.to_le_bytes()).collect())
            }
            Value::Vec3fs(v) => {
                self.array(code::VEC3F, v.len(), v.iter().flatten().flat_map(|x| x.to_le_bytes()).collect())
            }
            Value::Tokens(tokens) => {
                let bytes = self.list(tokens.iter().map(String::as_str), Self::token);
                self.stored(code::TOKENS, &bytes)
            }
            Value::TokenList(tokens) => {
                let mut bytes = vec![PREPENDED];
                bytes.extend(self.list(tokens.iter().map(String::as_str), Self::token));
                self.stored(code::TOKEN_LIST, &bytes)
            }
            Value::PathList(paths) => {
                let mut bytes = vec![EXPLICIT];
                // A path that is none of the layer's own points to the root, and a reader finds nothing there.
                let index = |e: &mut Self, p: &str| e.paths.get(p).copied().unwrap_or(0);
                bytes.extend(self.list(paths.iter().map(String::as_str), index));
                self.stored(code::PATH_LIST, &bytes)
            }
            Value::Dictionary(entries) => {
                let mut bytes = (entries.len() as u64).to_le_bytes().to_vec();
                for (key, value) in entries {
                    let reference = self.value(value);
                    bytes.extend(self.string(key).to_le_bytes());
                    bytes.extend(8u64.to_le_bytes()); // the reference stands right behind this offset
                    bytes.extend(reference.to_le_bytes());
                }
                self.stored(code::DICTIONARY, &bytes)
            }
            Value::Other(code) => inlined(*code, 0),
        }
    }

    fn list<'a>(
        &mut self,
        items: impl ExactSizeIterator<Item = &'a str>,
        f: impl Fn(&mut Self, &str) -> u32,
    ) -> Vec<u8> {
        let mut bytes = (items.len() as u64).to_le_bytes().to_vec();
        for item in items {
            bytes.extend(f(self, item).to_le_bytes());
        }
        bytes
    }

    fn floats(&mut self, kind: u8, values: &[f32]) -> u64 {
        let bytes: Vec<u8> = values.iter().flat_map(|x| x.to_le_bytes()).collect();
        self.stored(kind, &bytes)
    }

    fn stored(&mut self, code: u8, bytes: &[u8]) -> u64 {
        self.bytes.resize(self.bytes.len().next_multiple_of(8), 0);
        let at = self.bytes.len() as u64;
        self.bytes.extend_from_slice(bytes);
        u64::from(code) << 48 | at
    }

    fn array(&mut self, code: u8, length: usize, data: Vec<u8>) -> u64 {
        if length == 0 {
            return ARRAY | u64::from(code) << 48;
        }
        let mut bytes = (length as u64).to_le_bytes().to_vec();
        bytes.extend(data);
        ARRAY | self.stored(code, &bytes)
    }

    fn path_tree(&mut self, spec: &Spec, path: &str, has_sibling: bool, tree: &mut Tree) {
        let property = matches!(spec.kind, Kind::Attribute | Kind::Relationship);
        let token = self.token(&spec.name) as i32;
        let here = tree.indices.len();
        tree.indices.push(self.paths[path] as i32);
        tree.tokens.push(if property { -token } else { token });
        tree.jumps.push(0);
        for (i, child) in spec.children.iter().enumerate() {
            self.path_tree(child, &join(path, child), i + 1 < spec.children.len(), tree);
        }
        tree.jumps[here] = match (spec.children.is_empty(), has_sibling) {
            (false, true) => (tree.indices.len() - here) as i32,
            (true, true) => 0,
            (false, false) => -1,
            (true, false) => -2,
        };
    }
}
