//! The Merkle tree over a ledger's trail hashes (RFC 9162 §2.1): one root for any number of records, and a short proof
//! that a record is among them. Appending keeps only the tree's right edge, so it costs O(log n).

use sha2::{Digest as _, Sha256};

/// A node of the tree.
pub type Hash = [u8; 32];

/// A leaf's hash: SHA-256 of 0x00 and the data (RFC 9162 §2.1.1).
pub fn leaf(data: &[u8]) -> Hash {
    Sha256::new().chain_update([0]).chain_update(data).finalize().into()
}

fn node(left: &Hash, right: &Hash) -> Hash {
    Sha256::new().chain_update([1]).chain_update(left).chain_update(right).finalize().into()
}

/// The roots of the complete subtrees that a tree of `size` leaves consists of, the largest first: one for each bit
/// that is set in `size`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Frontier {
    size: u64,
    peaks: Vec<Hash>,
}

impl Frontier {
    /// `None` when the number of peaks does not fit the size.
    pub fn from_parts(size: u64, peaks: Vec<Hash>) -> Option<Frontier> {
        (peaks.len() == size.count_ones() as usize).then_some(Frontier { size, peaks })
    }

    /// Leaves in the tree.
    pub fn size(&self) -> u64 {
        self.size
    }

    pub fn peaks(&self) -> &[Hash] {
        &self.peaks
    }

    /// Appends a leaf, as [`leaf`] hashed it.
    pub fn push(&mut self, leaf: Hash) {
        let mut top = leaf;
        // Every trailing one bit of the size is a complete subtree that the new leaf closes.
        for _ in 0..self.size.trailing_ones() {
            if let Some(left) = self.peaks.pop() {
                top = node(&left, &top);
            }
        }
        self.peaks.push(top);
        self.size += 1;
    }

    /// The tree's root; SHA-256 of nothing for the empty tree.
    pub fn root(&self) -> Hash {
        let mut from_the_right = self.peaks.iter().rev();
        let Some(last) = from_the_right.next() else { return Sha256::digest([]).into() };
        from_the_right.fold(*last, |right, left| node(left, &right))
    }

    /// The inclusion proof of the leaf that is pushed next, in the tree that it makes: PATH(n, D[n + 1]) of RFC 9162
    /// §2.1.3.1, whose nodes are just the peaks so far, the smallest first.
    pub fn path_of_next(&self) -> Vec<Hash> {
        self.peaks.iter().rev().copied().collect()
    }
}

/// The root that an inclusion proof leads to (RFC 9162 §2.1.3.2); `None` when the path does not fit the tree.
pub fn root_from_path(leaf: Hash, index: u64, size: u64, path: &[Hash]) -> Option<Hash> {
    if index >= size {
        return None;
    }
    let (mut at, mut last, mut root) = (index, size - 1, leaf);
    for sibling in path {
        if last == 0 {
            return None;
        }
        if at & 1 == 1 || at == last {
            root = node(sibling, &root);
            while at & 1 == 0 && at != 0 {
                (at, last) = (at >> 1, last >> 1);
            }
        } else {
            root = node(&root, sibling);
        }
        (at, last) = (at >> 1, last >> 1);
    }
    (last == 0).then_some(root)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// MTH of RFC 9162 §2.1.1, word for word.
    fn tree_hash(leaves: &[Vec<u8>]) -> Hash {
        match leaves {
            [] => Sha256::digest([]).into(),
            [one] => leaf(one),
            many => {
                let k = (many.len() - 1).ilog2();
                let (left, right) = many.split_at(1 << k);
                node(&tree_hash(left), &tree_hash(right))
            }
        }
    }

    /// PATH of RFC 9162 §2.1.3.1, word for word.
    fn path(index: usize, leaves: &[Vec<u8>]) -> Vec<Hash> {
        if leaves.len() == 1 {
            return Vec::new();
        }
        let k = 1 << (leaves.len() - 1).ilog2();
        let (left, right) = leaves.split_at(k);
        let (mut below, sibling) =
            if index < k { (path(index, left), tree_hash(right)) } else { (path(index - k, right), tree_hash(left)) };
        below.push(sibling);
        below
    }

    fn leaves(n: usize) -> Vec<Vec<u8>> {
        (0..n).map(|i| i.to_be_bytes().to_vec()).collect()
    }

    /// The leaves and roots that Certificate Transparency's own test suites share.
    #[test]
    fn published_roots() {
        let data = ["", "00", "10", "2021", "3031", "40414243", "5051525354555657", "606162636465666768696a6b6c6d6e6f"];
        let roots = [
            "6e340b9cffb37a989ca544e6bb780a2c78901d3fb33738768511a30617afa01d",
            "fac54203e7cc696cf0dfcb42c92a1d9dbaf70ad9e621f4bd8d98662f00e3c125",
            "aeb6bcfe274b70a14fb067a5e5578264db0fa9b51af5e0ba159158f329e06e77",
            "d37ee418976dd95753c1c73862b9398fa2a2cf9b4ff0fdfe8b30cd95209614b7",
            "4e3bbb1f7b478dcfe71fb631631519a3bca12c9aefca1612bfce4c13a86264d4",
            "76e67dadbcdf1e10e1b74ddc608abd2f98dfb16fbce75277b5232a127f2087ef",
            "ddb89be403809e325750d3d263cd78929c2942b7942a34b77e122c9594a74c8c",
            "5dc9da79a70659a9ad559cb701ded9a2ab9d823aad2f4960cfe370eff4604328",
        ];
        let mut tree = Frontier::default();
        assert_eq!(hex::encode(tree.root()), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        for (leaf_data, root) in data.iter().zip(roots) {
            tree.push(leaf(&hex::decode(leaf_data).unwrap()));
            assert_eq!(hex::encode(tree.root()), root);
        }
    }

    #[test]
    fn every_root_and_every_proof_of_small_trees() {
        let mut tree = Frontier::default();
        for n in 1..=40 {
            let all = leaves(n);
            let next = tree.path_of_next();
            tree.push(leaf(&all[n - 1]));
            assert_eq!(tree.root(), tree_hash(&all));
            assert_eq!(next, path(n - 1, &all));
            assert_eq!(Frontier::from_parts(n as u64, tree.peaks().to_vec()), Some(tree.clone()));
            for (i, data) in all.iter().enumerate() {
                let path = path(i, &all);
                assert_eq!(root_from_path(leaf(data), i as u64, n as u64, &path), Some(tree.root()));
                // One node too few or too many never leads anywhere.
                assert_eq!(root_from_path(leaf(data), i as u64, n as u64, &[&path[..], &[[0; 32]]].concat()), None);
                if let Some((_, short)) = path.split_last() {
                    assert_eq!(root_from_path(leaf(data), i as u64, n as u64, short), None);
                }
            }
        }
        assert_eq!(root_from_path([0; 32], 3, 3, &[]), None);
        assert_eq!(Frontier::from_parts(3, vec![[0; 32]]), None);
    }

    proptest! {
        #[test]
        fn a_proof_fits_one_place_only(n in 2usize..200, i in 0usize..200, j in 0usize..200) {
            let (i, j) = (i % n, j % n);
            let all = leaves(n);
            let found = root_from_path(leaf(&all[i]), j as u64, n as u64, &path(i, &all));
            prop_assert_eq!(found == Some(tree_hash(&all)), i == j);
        }
    }
}
