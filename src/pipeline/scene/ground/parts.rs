//! Which parts of the ground that was seen belong together: ground is seen in pieces, as Gaussians are few between photos' details and
//! things stand on it, and wrong Gaussians far away look like pieces of it, too.

use super::WIDEST;

/// Leaves the parts that belong to the largest whole. `known`: rows of `side` cells, each `cell` wide in the unit frame.
///
/// Cells that touch, at a corner too, are a part. Parts and what has been joined of them become one where no more than w cells
/// that are not known lie between them, along rows and columns and diagonally alike, and each of both has w² cells or more; w is 1,
/// 2, 4 … up to the widest thing that may stand between them ([`WIDEST`] to each side). So a gap is bridged by parts that are as wide
/// as it is: a piece of ground beyond a house, and no speck beyond a gap of many cells. What has most cells in the end is kept.
pub fn keep_near(known: &mut [bool], side: usize, cell: f32) {
    let mut part = touching(known, side);
    let widest = (2.0 * WIDEST / cell).ceil() as usize;
    let mut gap = 1;
    while gap < 2 * widest {
        part = joined(&part, side, gap.min(widest));
        gap *= 2;
    }
    let sizes = sizes(&part);
    // Of several as large the first.
    let best = (0..sizes.len()).rev().max_by_key(|p| sizes[*p]);
    known.iter_mut().zip(part).for_each(|(k, p)| *k = *k && p == best);
}

/// The part of every known cell, numbered from 0 in the cells' order.
fn touching(known: &[bool], side: usize) -> Vec<Option<usize>> {
    let mut part = vec![None; known.len()];
    let mut count = 0;
    for start in 0..known.len() {
        if !known[start] || part[start].is_some() {
            continue;
        }
        let mut open = vec![start];
        part[start] = Some(count);
        while let Some(i) = open.pop() {
            for j in around(i, side, known.len()) {
                if known[j] && part[j].is_none() {
                    part[j] = Some(count);
                    open.push(j);
                }
            }
        }
        count += 1;
    }
    part
}

/// Parts of at least `gap`² cells with at most `gap` cells between them become one, which has the number of the first of them.
fn joined(part: &[Option<usize>], side: usize, gap: usize) -> Vec<Option<usize>> {
    let sizes = sizes(part);
    // Each part grows into what is not of a large one, all of them a cell at a time, until they meet.
    let mut grown: Vec<Option<usize>> = part.iter().map(|p| p.filter(|p| sizes[*p] >= gap * gap)).collect();
    let mut steps = vec![0usize; grown.len()];
    let mut root: Vec<usize> = (0..sizes.len()).collect();
    let mut front: Vec<usize> = (0..grown.len()).filter(|i| grown[*i].is_some()).collect();
    for step in 0..=gap.div_ceil(2) {
        let mut next = Vec::new();
        for &i in &front {
            let Some(own) = grown[i] else { continue };
            for j in around(i, side, grown.len()) {
                match grown[j] {
                    None if step < gap.div_ceil(2) => {
                        (grown[j], steps[j]) = (Some(own), step + 1);
                        next.push(j);
                    }
                    Some(other) if steps[i] + steps[j] <= gap => {
                        let (a, b) = (root_of(&mut root, own), root_of(&mut root, other));
                        root[a.max(b)] = a.min(b);
                    }
                    _ => {}
                }
            }
        }
        front = next;
    }
    part.iter().map(|p| p.map(|p| root_of(&mut root, p))).collect()
}

/// Cells of each part.
fn sizes(part: &[Option<usize>]) -> Vec<usize> {
    let mut sizes = vec![0; part.iter().flatten().max().map_or(0, |last| last + 1)];
    part.iter().flatten().for_each(|p| sizes[*p] += 1);
    sizes
}

fn root_of(root: &mut [usize], mut p: usize) -> usize {
    while root[p] != p {
        root[p] = root[root[p]];
        p = root[p];
    }
    p
}

/// The cells around a cell of a grid of `count`.
fn around(i: usize, side: usize, count: usize) -> impl Iterator<Item = usize> {
    let (x, y) = (i % side, i / side);
    let rows = y.saturating_sub(1)..=(y + 1).min(count / side - 1);
    rows.flat_map(move |v| (x.saturating_sub(1)..=(x + 1).min(side - 1)).map(move |u| v * side + u))
        .filter(move |j| *j != i)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 120;
    /// The widest thing is 50 cells wide.
    const CELL: f32 = 0.01;

    /// Rectangles of known cells: column, row, width, height. Which of them are kept, each wholly or not at all.
    fn kept(all: &[[usize; 4]]) -> Vec<bool> {
        let holds = |r: &[usize; 4], i: usize| {
            (r[0]..r[0] + r[2]).contains(&(i % SIDE)) && (r[1]..r[1] + r[3]).contains(&(i / SIDE))
        };
        let before: Vec<bool> = (0..SIDE * SIDE).map(|i| all.iter().any(|r| holds(r, i))).collect();
        let mut known = before.clone();
        keep_near(&mut known, SIDE, CELL);
        assert!(known.iter().zip(&before).all(|(k, b)| *b || !*k), "nothing new is known");
        let of = |r: &[usize; 4]| {
            let kept = (0..known.len()).filter(|i| holds(r, *i) && known[*i]).count();
            assert!(kept == 0 || kept == r[2] * r[3], "{r:?} in part");
            kept > 0
        };
        all.iter().map(of).collect()
    }

    #[test]
    fn parts_are_joined_over_gaps_as_wide_as_they_are_and_specks_are_not() {
        // Two halves of a place, one smaller, with more and more cells between them.
        let halves = |gap: usize| kept(&[[10, 10, 20, 40], [30 + gap, 10, 12, 40]]);
        assert_eq!([1, 4, 9, 16].map(halves), [(); 4].map(|()| vec![true, true]));
        assert_eq!(halves(17), [true, false], "480 cells are less than 32²");
        // The same side by side along the other axis, and corner to corner: diagonally it is as far.
        assert_eq!(kept(&[[10, 10, 40, 20], [10, 46, 40, 12]]), [true, true]);
        assert_eq!(kept(&[[10, 10, 20, 20], [46, 46, 20, 20]]), [true, true]);
        assert_eq!(kept(&[[10, 10, 20, 20], [47, 47, 20, 20]]), [true, false]);
        // A speck of four cells: beside the place, two cells off, three cells off, far away.
        for (away, near) in [(1, true), (2, true), (3, false), (60, false)] {
            assert_eq!(kept(&[[10, 10, 30, 30], [40 + away, 20, 2, 2]]), [true, near], "{away}");
        }
        // A single one that touches at a corner.
        assert_eq!(kept(&[[10, 10, 30, 30], [40, 40, 1, 1]]), [true, true]);
        // What stands between two large parts is at most 50 cells wide here.
        assert_eq!(kept(&[[0, 0, 34, 120], [84, 0, 36, 120]]), [true, true]);
        assert_eq!(kept(&[[0, 0, 33, 120], [84, 0, 36, 120]]), [false, true]);
    }

    #[test]
    fn many_parts_count_together_and_none_is_none() {
        // Stripes, each with a gap to the next; together more than the one large part far off; specks between them stay out of it.
        let stripes: Vec<[usize; 4]> = (0..6).map(|k| [5, 5 + 9 * k, 40, 6]).collect();
        let far = [100, 60, 18, 55];
        assert_eq!(kept(&[&stripes[..], &[far]].concat()), [true, true, true, true, true, true, false]);
        let specks: Vec<[usize; 4]> = (0..6).map(|k| [70 + 4 * (k % 2), 5 + 9 * k, 1, 1]).collect();
        let all = [&stripes[..], &specks].concat();
        assert_eq!(kept(&all).iter().filter(|k| **k).count(), stripes.len());
        // Of two as large the first; nothing of nothing.
        assert_eq!(kept(&[[0, 0, 4, 4], [100, 100, 4, 4]]), [true, false]);
        let mut none = vec![false; 9];
        keep_near(&mut none, 3, CELL);
        assert_eq!(none, [false; 9]);
    }
}
