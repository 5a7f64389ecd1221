//! Crate file → layer: versions 0.4.0 to 0.13, the values that a model needs.

use std::cell::Cell;

use super::FORMAT;
use super::encode::{ARRAY, COMPRESSED, END, EXPLICIT, INLINED, MAGIC, PAYLOAD, PREPENDED, SECTIONS, code};
use super::layer::{Kind, Spec, Value};
use super::packing::{unpack, unpack_ints};
use crate::{Error, Result};

/// Prims below one another, dictionaries inside one another.
const MAX_DEPTH: usize = 64;
/// What a field of a spec costs besides its texts, bytes: sets of fields may be shared.
const FIELD: usize = 16;

/// The layer's root with everything below it.
///
/// # Errors
/// [`Error::Malformed`] with the place; [`Error::Unsupported`] for other versions, and for a file that
/// says the same so often that it would unfold to many times its size.
pub fn decode(bytes: &[u8]) -> Result<Spec> {
    if !bytes.starts_with(MAGIC) {
        return Err(malformed(0, "PXR-USDC", "other bytes"));
    }
    let all = Source { bytes };
    let version = [all.u8(8)?, all.u8(9)?, all.u8(10)?];
    if version[0] != 0 || !(4..=13).contains(&version[1]) {
        let [a, b, c] = version;
        return Err(Error::unsupported(FORMAT, format!("layers of crate version {a}.{b}.{c}; 0.4 to 0.13 are read")));
    }
    let contents = all.place(16)?;
    let count = all.place(contents)?;
    let mut sections = [(0, 0); 6];
    for i in 0..count.min(64) {
        let at = contents + 8 + 32 * i;
        let name = all.slice(at, 16)?;
        let name = name.split(|b| *b == 0).next().unwrap_or_default();
        if let Some(index) = SECTIONS.iter().position(|s| s.as_bytes() == name) {
            sections[index] = (all.place(at + 16)?, all.place(at + 24)?);
        }
    }
    let mut starts = [0; 6];
    for ((start, size), (to, name)) in sections.iter().zip(starts.iter_mut().zip(SECTIONS)) {
        if *start < 88 || all.slice(*start, *size).is_err() {
            return Err(malformed(contents, format!("the section {name} inside the file"), format!("{start}")));
        }
        *to = *start;
    }
    let left = Cell::new(bytes.len().saturating_mul(16).saturating_add(1 << 20));
    let mut file = Crate {
        all,
        minor: version[1],
        left,
        tokens: Vec::new(),
        strings: Vec::new(),
        paths: Vec::new(),
        order: Vec::new(),
    };
    file.tokens = file.read_tokens(starts[0])?;
    file.strings = file.all.u32s(starts[1])?;
    let fields = file.read_fields(starts[2])?;
    let (count, at) = file.count(starts[3])?;
    let (sets, _) = file.ints(at, count)?;
    file.read_paths(starts[4])?;
    let (count, at) = file.count(starts[5])?;
    let (spec_paths, at) = file.ints(at, count)?;
    let (spec_sets, at) = file.ints(at, count)?;
    let (spec_kinds, _) = file.ints(at, count)?;
    let mut built: Vec<Option<Spec>> = vec![None; file.paths.len()];
    for ((path, set), kind) in spec_paths.into_iter().zip(spec_sets).zip(spec_kinds) {
        let kind = match kind {
            1 => Kind::Attribute,
            6 => Kind::Prim,
            7 => Kind::Root,
            8 => Kind::Relationship,
            _ => continue, // variants and the like
        };
        let place = starts[5];
        let (Some(slot), Some(Some(at))) = (built.get_mut(path as usize), file.paths.get(path as usize)) else {
            return Err(malformed(place, format!("a path below {}", file.paths.len()), path.to_string()));
        };
        let mut spec = Spec::new(at.name.clone(), kind);
        let own = sets.get(set as usize..).ok_or_else(|| malformed(place, "a set of fields", set.to_string()))?;
        for &field in own.iter().take_while(|f| **f as u32 != END) {
            let Some(&(token, value)) = fields.get(field as usize) else {
                return Err(malformed(place, format!("a field below {}", fields.len()), field.to_string()));
            };
            file.spend(FIELD)?;
            let name = file.token(token as u32, place)?.to_owned();
            // What the tree says already.
            if name != "primChildren" && name != "properties" {
                spec.fields.push((name, file.value(value, starts[2], 0)?));
            }
        }
        *slot = Some(spec);
    }
    // Backwards through the tree: everything below a spec is whole when its turn comes, its children last to first.
    let mut root = None;
    for &index in file.order.iter().rev() {
        let (Some(path), Some(mut spec)) = (&file.paths[index], built[index].take()) else { continue };
        spec.children.reverse();
        match path.parent {
            None => root = Some(spec),
            Some(parent) => {
                if let Some(parent) = &mut built[parent] {
                    parent.children.push(spec);
                }
            }
        }
    }
    root.ok_or_else(|| malformed(starts[5], "the spec of the layer itself", "none"))
}

fn malformed(at: usize, expected: impl Into<String>, found: impl Into<String>) -> Error {
    Error::malformed(FORMAT, at, expected, found)
}

struct Source<'a> {
    bytes: &'a [u8],
}

impl<'a> Source<'a> {
    fn slice(&self, at: usize, length: usize) -> Result<&'a [u8]> {
        let rest = self.bytes.get(at..).and_then(|rest| rest.get(..length));
        rest.ok_or_else(|| malformed(at, format!("{length} bytes"), format!("{} in the file", self.bytes.len())))
    }

    fn u8(&self, at: usize) -> Result<u8> {
        Ok(self.slice(at, 1)?[0])
    }

    fn u32(&self, at: usize) -> Result<u32> {
        let b = self.slice(at, 4)?;
        Ok(u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
    }

    fn u64(&self, at: usize) -> Result<u64> {
        Ok(u64::from(self.u32(at)?) | u64::from(self.u32(at + 4)?) << 32)
    }

    /// A length or a place: at most the file's.
    fn place(&self, at: usize) -> Result<usize> {
        let value = self.u64(at)?;
        if value > self.bytes.len() as u64 {
            return Err(malformed(at, format!("at most {}", self.bytes.len()), value.to_string()));
        }
        Ok(value as usize)
    }

    fn u32s(&self, at: usize) -> Result<Vec<u32>> {
        self.rows(at, 4)?.into_iter().map(|at| self.u32(at)).collect()
    }

    /// A count and so many rows of a size: their places.
    fn rows(&self, at: usize, size: usize) -> Result<Vec<usize>> {
        let count = self.place(at)?;
        self.slice(at + 8, count.saturating_mul(size))?;
        Ok((0..count).map(|i| at + 8 + i * size).collect())
    }

    fn floats<const N: usize>(&self, at: usize, count: usize) -> Result<Vec<[f32; N]>> {
        let bytes = self.slice(at, count.saturating_mul(4 * N))?;
        let float = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
        Ok(bytes.chunks_exact(4 * N).map(|row| std::array::from_fn(|i| float(&row[4 * i..]))).collect())
    }
}

struct Path {
    name: String,
    full: String,
    parent: Option<usize>,
}

struct Crate<'a> {
    all: Source<'a>,
    /// The version's second number.
    minor: u8,
    /// Bytes that may still be made of what the file says more than once.
    left: Cell<usize>,
    tokens: Vec<String>,
    strings: Vec<u32>,
    paths: Vec<Option<Path>>,
    /// Indices of the paths, parents before children.
    order: Vec<usize>,
}

impl Crate<'_> {
    fn spend(&self, bytes: usize) -> Result<()> {
        let left = self.left.get().checked_sub(bytes);
        self.left.set(left.ok_or_else(|| Error::unsupported(FORMAT, "a layer that unfolds to many times its size"))?);
        Ok(())
    }

    /// A number of things, at most one a byte of the file, and what follows it.
    fn count(&self, at: usize) -> Result<(usize, usize)> {
        Ok((self.all.place(at)?, at + 8))
    }

    /// The length of something packed, its bytes, and what follows.
    fn packed(&self, at: usize) -> Result<(&[u8], usize)> {
        let size = self.all.place(at)?;
        Ok((self.all.slice(at + 8, size)?, at + 8 + size))
    }

    fn ints(&self, at: usize, count: usize) -> Result<(Vec<i32>, usize)> {
        let (packed, next) = self.packed(at)?;
        self.spend(count.saturating_mul(4))?;
        if count == 0 {
            return Ok((Vec::new(), next));
        }
        Ok((unpack_ints(packed, count, at)?, next))
    }

    fn read_tokens(&self, at: usize) -> Result<Vec<String>> {
        let (count, at) = self.count(at)?;
        // Texts repeat words: more than the file's own length is nothing unusual, but not much more.
        let size = self.all.u64(at)?;
        let size = usize::try_from(size).unwrap_or(usize::MAX);
        self.spend(size.saturating_mul(2))?;
        let (packed, _) = self.packed(at + 8)?;
        let text = unpack(packed, size, at)?;
        self.spend(count.saturating_mul(24))?;
        let tokens: Vec<String> =
            text.split(|b| *b == 0).take(count).map(|t| String::from_utf8_lossy(t).into_owned()).collect();
        if tokens.len() != count {
            return Err(malformed(at, format!("{count} tokens"), tokens.len().to_string()));
        }
        Ok(tokens)
    }

    /// Name and value of each field.
    fn read_fields(&self, at: usize) -> Result<Vec<(i32, u64)>> {
        let (count, at) = self.count(at)?;
        let (tokens, at) = self.ints(at, count)?;
        let (packed, _) = self.packed(at)?;
        self.spend(count.saturating_mul(24))?;
        let values = unpack(packed, count.saturating_mul(8), at)?;
        let value = |b: &[u8]| b.iter().rev().fold(0u64, |v, b| v << 8 | u64::from(*b));
        Ok(tokens.into_iter().zip(values.chunks_exact(8).map(value)).collect())
    }

    fn token(&self, index: u32, at: usize) -> Result<&str> {
        let token = self.tokens.get(index as usize);
        let token =
            token.ok_or_else(|| malformed(at, format!("a token below {}", self.tokens.len()), index.to_string()))?;
        self.spend(token.len())?;
        Ok(token)
    }

    fn string(&self, index: u32, at: usize) -> Result<&str> {
        let token = self.strings.get(index as usize);
        let missing = || malformed(at, format!("a string below {}", self.strings.len()), index.to_string());
        self.token(*token.ok_or_else(missing)?, at)
    }

    /// The tree: for each entry its path, its name, and where its sibling is.
    fn read_paths(&mut self, at: usize) -> Result<()> {
        let (count, place) = self.count(at)?;
        let (entries, place) = self.count(place)?;
        let (indices, place) = self.ints(place, entries)?;
        let (tokens, place) = self.ints(place, entries)?;
        let (jumps, _) = self.ints(place, entries)?;
        self.spend(count.saturating_mul(80))?;
        self.paths.resize_with(count, || None);
        // Entries still to read: their number, their parent, their depth.
        let mut open = vec![(0usize, None, 0usize)];
        while let Some((entry, parent, depth)) = open.pop() {
            let (Some(&index), Some(&token), Some(&jump)) = (indices.get(entry), tokens.get(entry), jumps.get(entry))
            else {
                return Err(malformed(at, format!("an entry below {entries}"), entry.to_string()));
            };
            let free = usize::try_from(index).ok().filter(|i| matches!(self.paths.get(*i), Some(None)));
            let Some(index) = free.filter(|_| depth <= MAX_DEPTH) else {
                let expected = format!("a path of {count}, each once, at most {MAX_DEPTH} deep");
                return Err(malformed(at, expected, format!("{index}, {depth} deep")));
            };
            let name = if parent.is_none() { String::new() } else { self.token(token.unsigned_abs(), at)?.to_owned() };
            let separator = if token < 0 { '.' } else { '/' };
            let full = match parent.and_then(|p: usize| self.paths[p].as_ref()) {
                None => String::new(),
                Some(above) => {
                    self.spend(above.full.len() + name.len())?;
                    format!("{}{separator}{name}", above.full)
                }
            };
            self.paths[index] = Some(Path { name, full, parent });
            self.order.push(index);
            if jump >= 0 {
                let sibling = if jump > 0 { entry.saturating_add(jump as usize) } else { entry + 1 };
                open.push((sibling, parent, depth));
            }
            if jump > 0 || jump == -1 {
                open.push((entry + 1, Some(index), depth + 1));
            }
        }
        Ok(())
    }

    fn value(&self, bits: u64, at: usize, depth: usize) -> Result<Value> {
        let kind = (bits >> 48) as u8;
        let payload = bits & PAYLOAD;
        if bits & INLINED != 0 {
            let word = payload as u32;
            return Ok(match kind {
                code::BOOL => Value::Bool(word != 0),
                code::INT => Value::Int(word as i32),
                code::FLOAT => Value::Float(f32::from_bits(word)),
                code::DOUBLE => Value::Double(f32::from_bits(word).into()),
                code::STRING => Value::String(self.string(word, at)?.into()),
                code::TOKEN => Value::Token(self.token(word, at)?.into()),
                code::ASSET => Value::Asset(self.token(word, at)?.into()),
                code::SPECIFIER => Value::Specifier(word),
                code::VARIABILITY => Value::Variability(word),
                _ => Value::Other(kind),
            });
        }
        let place = payload as usize;
        if bits & ARRAY != 0 {
            return self.array(kind, place, bits & COMPRESSED != 0);
        }
        let indices = |at: usize| {
            self.spend(self.all.place(at)?.saturating_mul(32))?;
            self.all.u32s(at)
        };
        let tokens =
            |at: usize| indices(at)?.into_iter().map(|t| Ok(self.token(t, at)?.to_owned())).collect::<Result<Vec<_>>>();
        Ok(match kind {
            code::DOUBLE => Value::Double(f64::from_bits(self.all.u64(place)?)),
            code::VEC3F => Value::Vec3f(self.all.floats(place, 1)?[0]),
            code::VEC4F => Value::Vec4f(self.all.floats(place, 1)?[0]),
            code::TOKENS => Value::Tokens(tokens(place)?),
            code::TOKEN_LIST if matches!(self.all.u8(place)?, PREPENDED | EXPLICIT) => {
                Value::TokenList(tokens(place + 1)?)
            }
            code::PATH_LIST if matches!(self.all.u8(place)?, PREPENDED | EXPLICIT) => {
                let path = |index: u32| {
                    let path = self.paths.get(index as usize).and_then(Option::as_ref);
                    let missing = || malformed(place, format!("a path below {}", self.paths.len()), index.to_string());
                    let full = &path.ok_or_else(missing)?.full;
                    self.spend(full.len())?;
                    Ok(full.clone())
                };
                Value::PathList(indices(place + 1)?.into_iter().map(path).collect::<Result<_>>()?)
            }
            code::DICTIONARY => self.dictionary(place, depth)?,
            _ => Value::Other(kind),
        })
    }

    /// Entries are a key, the distance to a reference, values between, and the reference.
    fn dictionary(&self, place: usize, depth: usize) -> Result<Value> {
        if depth > MAX_DEPTH {
            return Err(malformed(place, format!("dictionaries at most {MAX_DEPTH} deep"), "deeper ones"));
        }
        let count = self.all.place(place)?;
        self.all.slice(place + 8, count.saturating_mul(20))?;
        self.spend(count.saturating_mul(80))?;
        let mut at = place + 8;
        let mut out = Vec::new();
        for _ in 0..count {
            let key = self.string(self.all.u32(at)?, at)?.to_owned();
            let reference = (at + 4).saturating_add(self.all.place(at + 4)?);
            // Dictionaries inside dictionaries could share their content: only Orb's own, which are flat.
            let bits = self.all.u64(reference)?;
            let value = match (bits >> 48) as u8 {
                code::DICTIONARY => Value::Other(code::DICTIONARY),
                _ => self.value(bits, reference, depth + 1)?,
            };
            out.push((key, value));
            at = reference + 8;
        }
        Ok(Value::Dictionary(out))
    }

    /// A length of 64 bits, before 0.7 of 32, before 0.5 after a rank that is always 1; then the values. Long runs of
    /// integers may be packed.
    fn array(&self, kind: u8, place: usize, packed: bool) -> Result<Value> {
        let (count, data) = match (place, self.minor) {
            (0, _) => (0, 0),
            (_, 7..) => (self.all.place(place)?, place.saturating_add(8)),
            (_, 5..) => (self.all.u32(place)? as usize, place.saturating_add(4)),
            _ => (self.all.u32(place.saturating_add(4))? as usize, place.saturating_add(8)),
        };
        if count > self.all.bytes.len() {
            return Err(malformed(place, format!("at most {} values", self.all.bytes.len()), count.to_string()));
        }
        let spend = |width: usize| self.spend(count.saturating_mul(8 * width));
        Ok(match kind {
            // Fewer than 16 are never packed.
            code::INT if packed && count >= 16 => Value::Ints(self.ints(data, count)?.0),
            code::INT => {
                self.spend(count.saturating_mul(4))?;
                let int = |b: &[u8]| i32::from_le_bytes([b[0], b[1], b[2], b[3]]);
                Value::Ints(self.all.slice(data, count.saturating_mul(4))?.chunks_exact(4).map(int).collect())
            }
            _ if packed => Value::Other(kind),
            code::FLOAT => {
                spend(1)?;
                Value::Floats(self.all.floats(data, count)?.into_iter().map(|[x]| x).collect())
            }
            code::QUATF => {
                spend(4)?;
                let turns = self.all.floats(data, count)?;
                Value::Quatfs(turns.into_iter().map(|[x, y, z, w]| [w, x, y, z]).collect())
            }
            code::VEC2F => {
                spend(2)?;
                Value::Vec2fs(self.all.floats(data, count)?)
            }
            code::VEC3F => {
                spend(3)?;
                Value::Vec3fs(self.all.floats(data, count)?)
            }
            _ => Value::Other(kind),
        })
    }
}
