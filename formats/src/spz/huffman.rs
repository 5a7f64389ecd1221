//! Deflate without matches: what noise is best packed with.
//!
//! Source: RFC 1951. The rounded harmonics of a trained scene are few values in no order: looking for repetitions among
//! them takes most of the time and finds ones that cost more than they save.

/// A byte, or the end of a block.
const SYMBOLS: usize = 257;
const LONGEST: u32 = 15;

/// Bits of the codes for so many of each symbol (Huffman 1952), none longer than deflate allows; 0 for none of it.
fn lengths(counts: &[u32; SYMBOLS]) -> [u32; SYMBOLS] {
    let mut counts = *counts;
    loop {
        let found = unlimited(&counts);
        if found.iter().all(|l| *l <= LONGEST) {
            return found;
        }
        // Rare symbols made less rare: their codes get shorter.
        counts.iter_mut().filter(|c| **c > 0).for_each(|c| *c = *c / 2 + 1);
    }
}

fn unlimited(counts: &[u32; SYMBOLS]) -> [u32; SYMBOLS] {
    let mut leaves: Vec<(u64, usize)> =
        counts.iter().enumerate().filter(|(_, c)| **c > 0).map(|(i, c)| (u64::from(*c), i)).collect();
    let mut out = [0; SYMBOLS];
    if let [(_, only)] = leaves[..] {
        out[only] = 1;
        return out;
    }
    leaves.sort_unstable();
    // Both queues are sorted: leaves, and the nodes made of them, which only grow.
    let mut weights: Vec<u64> = leaves.iter().map(|l| l.0).collect();
    let mut parents = vec![0; 2 * leaves.len().max(1) - 1];
    let (mut leaf, mut node) = (0, leaves.len());
    while weights.len() + 1 < 2 * leaves.len() {
        let mut sum = 0;
        for _ in 0..2 {
            let from_leaves = leaf < leaves.len() && (node >= weights.len() || weights[leaf] <= weights[node]);
            let least = if from_leaves { &mut leaf } else { &mut node };
            sum += weights[*least];
            parents[*least] = weights.len();
            *least += 1;
        }
        weights.push(sum);
    }
    let mut depths = vec![0u32; weights.len()];
    for i in (0..weights.len().saturating_sub(1)).rev() {
        depths[i] = depths[parents[i]] + 1;
        if let Some((_, symbol)) = leaves.get(i) {
            out[*symbol] = depths[i];
        }
    }
    out
}

fn counts(bytes: &[u8]) -> [u32; SYMBOLS] {
    // Four tables: counting the same byte twice in a row does not wait for itself.
    let mut each = [[0u32; 256]; 4];
    for (i, byte) in bytes.iter().enumerate() {
        each[i % 4][usize::from(*byte)] += 1;
    }
    std::array::from_fn(|i| if i == 256 { 1 } else { each.iter().map(|c| c[i]).sum() })
}

/// Bytes that [`block`] takes for some.
pub fn size(bytes: &[u8]) -> usize {
    let counts = counts(bytes);
    let bits: u64 = lengths(&counts).iter().zip(counts).map(|(l, c)| u64::from(*l) * u64::from(c)).sum();
    140 + (bits / 8) as usize
}

struct Bits {
    out: Vec<u8>,
    held: u64,
    count: u32,
}

impl Bits {
    /// The lowest `count` bits, at most 32, lowest first.
    fn put(&mut self, bits: u32, count: u32) {
        self.held |= u64::from(bits) << self.count;
        self.count += count;
        if self.count >= 32 {
            self.out.extend_from_slice(&(self.held as u32).to_le_bytes());
            self.held >>= 32;
            self.count -= 32;
        }
    }

    fn fill_byte(&mut self) {
        let bytes = self.count.div_ceil(8) as usize;
        self.out.extend_from_slice(&self.held.to_le_bytes()[..bytes]);
        (self.held, self.count) = (0, 0);
    }
}

/// Bytes as a block of dynamic codes (§3.2.7); one that is not the last is followed by an empty stored block, which ends it
/// at a whole byte.
pub fn block(bytes: &[u8], last: bool) -> Vec<u8> {
    let lengths = lengths(&counts(bytes));
    let mut bits = Bits { out: Vec::with_capacity(bytes.len() / 2), held: 0, count: 0 };
    bits.put(u32::from(last) | 2 << 1, 3);
    // 257 codes of bytes and the end, 2 of distances, 19 of lengths.
    bits.put(1 << 5 | 15 << 10, 14);
    // Code lengths 0 to 15 are written in 4 bits each: no repetitions (16, 17, 18), which come first in the order.
    for i in 0..19 {
        bits.put(if i < 3 { 0 } else { 4 }, 3);
    }
    let reversed = |code: u32, length: u32| code.reverse_bits() >> (32 - length);
    // Two distances that nothing uses: the least that makes a whole code.
    for length in lengths.iter().chain(&[1, 1]) {
        bits.put(reversed(*length, 4), 4);
    }
    let mut codes = [(0u32, 0u32); SYMBOLS];
    let mut code = 0;
    for length in 1..=LONGEST {
        for (to, _) in codes.iter_mut().zip(&lengths).filter(|(_, l)| **l == length) {
            *to = (reversed(code, length), length);
            code += 1;
        }
        code <<= 1;
    }
    for byte in bytes {
        let (code, length) = codes[usize::from(*byte)];
        bits.put(code, length);
    }
    bits.put(codes[256].0, codes[256].1);
    if !last {
        bits.put(0, 3);
    }
    bits.fill_byte();
    if !last {
        bits.out.extend([0, 0, 0xff, 0xff]);
    }
    bits.out
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    fn unpacked(bytes: &[u8]) -> Vec<u8> {
        let mut out = Vec::new();
        flate2::read::DeflateDecoder::new(bytes).read_to_end(&mut out).unwrap();
        out
    }

    #[test]
    fn blocks_come_back_and_have_the_size_that_was_told() {
        let mut state = 7u64;
        let mut noise = |few: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            ((state >> 33) % few * 16) as u8
        };
        let few: Vec<u8> = (0..100_000).map(|_| noise(9)).collect();
        let all: Vec<u8> = (0..70_000u32).map(|i| (i % 251) as u8).collect();
        for bytes in [&[][..], &[7], &[7; 1000], &few, &all] {
            let packed = block(bytes, true);
            assert_eq!(unpacked(&packed), bytes);
            assert!(packed.len().abs_diff(size(bytes)) < 16, "{} {}", packed.len(), size(bytes));
            let both = [block(bytes, false), block(&few, true)].concat();
            assert_eq!(unpacked(&both), [bytes, &few].concat());
        }
        // Nine values as likely as one another, and the end: six codes of three bits and four of four.
        let bits = (6.0 * 3.0 + 3.0 * 4.0) / 9.0 * few.len() as f64;
        assert!((block(&few, true).len() as f64 - bits / 8.0).abs() < 0.01 * bits / 8.0 + 200.0);
    }

    #[test]
    fn no_code_is_longer_than_deflate_allows() {
        // Fibonacci numbers give the deepest trees.
        let mut counts = [0; SYMBOLS];
        let (mut a, mut b) = (1u32, 1u32);
        for count in counts.iter_mut().take(40) {
            *count = a;
            (a, b) = (b, a + b);
        }
        assert!(unlimited(&counts).iter().max() > Some(&30));
        let limited = lengths(&counts);
        assert!(limited.iter().all(|l| *l <= LONGEST));
        let whole: f64 = limited.iter().filter(|l| **l > 0).map(|l| 0.5f64.powi(*l as i32)).sum();
        assert_eq!(whole, 1.0, "a complete prefix code (Kraft)");
    }
}
