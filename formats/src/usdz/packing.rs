//! How crate files from 0.4.0 on pack their tables: LZ4 blocks, and integers as differences.
//!
//! Sources: OpenUSD `pxr/base/tf/fastCompression.h` and `pxr/usd/usd/integerCoding.cpp`; the LZ4 block format (Collet).

use super::FORMAT;
use crate::{Error, Result};

/// A block of one chunk that is all literals: what little there is needs no compression.
pub fn pack(bytes: &[u8]) -> Vec<u8> {
    // The number of chunks less one, the token with 15 literals or fewer, and the rest of their number.
    let mut out = vec![0];
    if bytes.len() < 15 {
        out.push((bytes.len() as u8) << 4);
    } else {
        out.push(0xf0);
        let mut rest = bytes.len() - 15;
        while rest >= 255 {
            out.push(255);
            rest -= 255;
        }
        out.push(rest as u8);
    }
    out.extend_from_slice(bytes);
    out
}

/// The `size` bytes that a block unfolds to.
///
/// # Errors
/// [`Error::Malformed`] for a block that unfolds to another size or is broken.
pub fn unpack(packed: &[u8], size: usize, at: usize) -> Result<Vec<u8>> {
    let broken = || Error::malformed(FORMAT, at, format!("an LZ4 block of {size} bytes"), "another");
    let Some((&chunks, mut rest)) = packed.split_first() else { return Err(broken()) };
    // Grows with what is there: a byte unfolds to 255 at most.
    let mut out = Vec::with_capacity(size.min(packed.len().saturating_mul(4)));
    if chunks == 0 {
        unpack_chunk(rest, size, &mut out).ok_or_else(broken)?;
    }
    for _ in 0..chunks {
        let (length, tail) = rest.split_first_chunk().ok_or_else(broken)?;
        let length = usize::try_from(i32::from_le_bytes(*length)).map_err(|_| broken())?;
        let (chunk, tail) = tail.split_at_checked(length).ok_or_else(broken)?;
        unpack_chunk(chunk, size, &mut out).ok_or_else(broken)?;
        rest = tail;
    }
    if out.len() == size { Ok(out) } else { Err(broken()) }
}

/// Sequences: a token with two lengths, literals, the distance back to a match; the last has no match.
fn unpack_chunk(mut rest: &[u8], most: usize, out: &mut Vec<u8>) -> Option<()> {
    let start = out.len();
    loop {
        let (&token, tail) = rest.split_first()?;
        rest = tail;
        let literals = length(token >> 4, &mut rest)?;
        let (bytes, tail) = rest.split_at_checked(literals)?;
        if out.len() + literals > most {
            return None;
        }
        out.extend_from_slice(bytes);
        rest = tail;
        if rest.is_empty() {
            return Some(());
        }
        let (distance, tail) = rest.split_first_chunk()?;
        rest = tail;
        let distance = usize::from(u16::from_le_bytes(*distance));
        let count = length(token & 15, &mut rest)? + 4;
        let from = out.len().checked_sub(distance).filter(|from| distance > 0 && *from >= start)?;
        if out.len() + count > most {
            return None;
        }
        // A match may reach into what it writes.
        for i in 0..count {
            out.push(out[from + i]);
        }
    }
}

/// 15 goes on with bytes of 255, and ends with a smaller one.
fn length(first: u8, rest: &mut &[u8]) -> Option<usize> {
    let mut sum = usize::from(first);
    if first == 15 {
        loop {
            let (&byte, tail) = rest.split_first()?;
            *rest = tail;
            sum += usize::from(byte);
            if byte != 255 {
                break;
            }
        }
    }
    Some(sum)
}

/// Integers as differences to the one before: the commonest of them, two bits for each that say how it is stored, and
/// those that are not the commonest in one, two or four bytes.
pub fn pack_ints(values: &[i32]) -> Vec<u8> {
    let before = [0].into_iter().chain(values.iter().copied());
    let differences: Vec<i32> = values.iter().zip(before).map(|(v, b)| v.wrapping_sub(b)).collect();
    let mut counts = std::collections::BTreeMap::new();
    differences.iter().for_each(|d| *counts.entry(*d).or_insert(0usize) += 1);
    let common = counts.iter().max_by_key(|(value, count)| (**count, **value)).map_or(0, |(value, _)| *value);
    let mut codes = vec![0u8; (values.len() * 2).div_ceil(8)];
    let mut bytes = Vec::new();
    for (i, d) in differences.into_iter().enumerate() {
        let code = if d == common {
            0
        } else if let Ok(small) = i8::try_from(d) {
            bytes.extend(small.to_le_bytes());
            1
        } else if let Ok(medium) = i16::try_from(d) {
            bytes.extend(medium.to_le_bytes());
            2
        } else {
            bytes.extend(d.to_le_bytes());
            3
        };
        codes[i / 4] |= code << (i % 4 * 2);
    }
    pack(&[&common.to_le_bytes(), codes.as_slice(), &bytes].concat())
}

/// `count` integers. The caller has bounded the count.
///
/// # Errors
/// [`Error::Malformed`] for a block that holds others.
pub fn unpack_ints(packed: &[u8], count: usize, at: usize) -> Result<Vec<i32>> {
    let broken = || Error::malformed(FORMAT, at, format!("{count} packed integers"), "another number");
    let codes = (count * 2).div_ceil(8);
    // How many bytes they take is not said: as many as there are, at most this.
    let most = 4 + codes + 4 * count;
    let Some((&chunks, rest)) = packed.split_first() else { return Err(broken()) };
    let mut bytes = Vec::new();
    if chunks != 0 {
        return Err(Error::unsupported(FORMAT, "integers in several chunks"));
    }
    unpack_chunk(rest, most, &mut bytes).ok_or_else(broken)?;
    let end = bytes.len();
    // So that four bytes can be taken for every integer; what is beyond the end is noticed there.
    bytes.extend([0; 4]);
    let (common, rest) = bytes.split_first_chunk().ok_or_else(broken)?;
    let common = i32::from_le_bytes(*common);
    let (codes, rest) = rest.split_at_checked(codes).ok_or_else(broken)?;
    let (mut value, mut at) = (0i32, 0);
    let mut out = vec![0; count];
    for (group, codes) in out.chunks_mut(4).zip(codes) {
        for (i, to) in group.iter_mut().enumerate() {
            let word = rest.get(at..).and_then(|rest| rest.first_chunk()).ok_or_else(broken)?;
            let word = i32::from_le_bytes(*word);
            let (difference, width) = match codes >> (2 * i) & 3 {
                0 => (common, 0),
                1 => (i32::from(word as i8), 1),
                2 => (i32::from(word as i16), 2),
                _ => (word, 4),
            };
            value = value.wrapping_add(difference);
            at += width;
            *to = value;
        }
    }
    if 4 + codes.len() + at > end {
        return Err(broken());
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn matches_are_copied_even_from_themselves() {
        // Four literals, then seven bytes from two back; five literals end the block, as LZ4 asks.
        let block = [0, 0x43, b'a', b'b', b'c', b'd', 2, 0, 0x50, b'v', b'w', b'x', b'y', b'z'];
        assert_eq!(unpack(&block, 16, 0).unwrap(), b"abcdcdcdcdcvwxyz");
        assert!(unpack(&block, 15, 0).is_err() && unpack(&block, 17, 0).is_err());
        assert!((0..block.len()).all(|n| unpack(&block[..n], 16, 0).is_err()));
        assert!(unpack(&[0, 0x10, b'a', 0, 0, 0], 5, 0).is_err(), "a distance of 0");
        assert!(unpack(&[0, 0x10, b'a', 2, 0, 0], 5, 0).is_err(), "before the start");
        let twice = [&[2u8][..], &3i32.to_le_bytes(), &[0x20, b'a', b'b'], &2i32.to_le_bytes(), &[0x10, b'c']].concat();
        assert_eq!(unpack(&twice, 3, 0).unwrap(), b"abc");
    }

    proptest! {
        #[test]
        fn bytes_come_back(bytes in prop::collection::vec(any::<u8>(), 0..700)) {
            prop_assert_eq!(unpack(&pack(&bytes), bytes.len(), 0).unwrap(), bytes);
        }

        #[test]
        fn integers_come_back(values in prop::collection::vec(prop_oneof![any::<i32>(), -3..300i32], 0..200)) {
            prop_assert_eq!(unpack_ints(&pack_ints(&values), values.len(), 0).unwrap(), values);
        }
    }
}
