//! The least cut of a picture's grid: which pixels are the subject's, where each has an opinion and unlike neighbours may differ.
//!
//! Minimises Σ_i cost(i) + Σ_ij w_ij [x_i ≠ x_j] over all ways to label pixels, exactly: it is the least cut between a source and a
//! sink, found as the largest flow by the algorithm of Y. Boykov, V. Kolmogorov, "An Experimental Comparison of Min-Cut/Max-Flow
//! Algorithms for Energy Minimization in Vision", IEEE TPAMI 26(9), 2004, section 3. Both ends grow a tree each; where the trees meet,
//! flow is sent, and what a full edge cuts off finds another parent or becomes free.

use std::collections::VecDeque;

/// A parent that is the tree's own end: source or sink.
const END: u8 = 8;
/// No parent (any more).
const NONE: u8 = 9;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Tree {
    Free,
    Source,
    Sink,
}

/// A grid of pixels between a source and a sink. Capacities are whole numbers, so that the end is reached and is the same everywhere.
pub struct Grid {
    width: usize,
    height: usize,
    /// Of a pixel and its neighbour to the right, the left, below, above, below right, above left, below left, above right, in cells:
    /// around the pixels lies a frame one cell wide that nothing leads to, so every pixel has all eight.
    steps: [isize; 8],
    /// What still fits from each cell to its neighbour in each direction.
    room: [Vec<i32>; 8],
    /// What still fits from the source to the cell, or, where it is negative, from the cell to the sink.
    end: Vec<i32>,
}

impl Grid {
    /// `opinion` of each pixel: above 0 for the source, below for the sink; its size is what the other label costs.
    pub fn new(width: usize, height: usize, opinion: impl Fn(usize) -> i32) -> Self {
        let across = width as isize + 2;
        let steps = [1, -1, across, -across, across + 1, -across - 1, across - 1, -across + 1];
        let cells = (width + 2) * (height + 2);
        let mut grid =
            Self { width, height, steps, room: std::array::from_fn(|_| vec![0; cells]), end: vec![0; cells] };
        for i in 0..width * height {
            let cell = grid.cell(i);
            grid.end[cell] = opinion(i);
        }
        grid
    }

    /// Sets what it costs that neighbours differ: `cost(i, j)` for each pair of pixels that touch or meet at a corner, not below 0.
    #[must_use]
    pub fn joined(mut self, cost: impl Fn(usize, usize) -> i32) -> Self {
        for i in 0..self.width * self.height {
            let (x, y) = (i % self.width, i / self.width);
            let (right, below, left) = (x + 1 < self.width, y + 1 < self.height, x > 0);
            let pairs = [(right, i + 1), (below, i + self.width), (right && below, i + self.width + 1)];
            for (half, (there, j)) in pairs.into_iter().chain([(left && below, i + self.width - 1)]).enumerate() {
                if there {
                    let (forward, cost) = (2 * half, cost(i, j).max(0));
                    let (a, b) = (self.cell(i), self.cell(j));
                    self.room[forward][a] = cost;
                    self.room[forward + 1][b] = cost;
                }
            }
        }
        self
    }

    fn cell(&self, pixel: usize) -> usize {
        (pixel / self.width + 1) * (self.width + 2) + pixel % self.width + 1
    }

    fn neighbour(&self, cell: usize, direction: usize) -> usize {
        cell.wrapping_add_signed(self.steps[direction])
    }

    /// Which pixels are the source's in the least cut.
    pub fn cut(self) -> Vec<bool> {
        let cells: Vec<usize> = (0..self.width * self.height).map(|i| self.cell(i)).collect();
        let mut search = Search::new(self);
        while let Some((from, direction)) = search.grow() {
            search.augment(from, direction);
            search.adopt();
        }
        cells.into_iter().map(|cell| search.tree[cell] == Tree::Source).collect()
    }
}

struct Search {
    grid: Grid,
    tree: Vec<Tree>,
    /// The direction in which each cell's parent lies, [`END`] or [`NONE`].
    parent: Vec<u8>,
    /// Steps to the tree's end when it was last known, and when that was.
    distance: Vec<u32>,
    known: Vec<u32>,
    now: u32,
    active: VecDeque<usize>,
    waiting: Vec<bool>,
    current: Option<usize>,
    orphans: VecDeque<usize>,
}

impl Search {
    fn new(grid: Grid) -> Self {
        let of = |end: &i32| match end.signum() {
            1 => Tree::Source,
            -1 => Tree::Sink,
            _ => Tree::Free,
        };
        let tree: Vec<Tree> = grid.end.iter().map(of).collect();
        let waiting: Vec<bool> = tree.iter().map(|t| *t != Tree::Free).collect();
        Self {
            parent: waiting.iter().map(|rooted| if *rooted { END } else { NONE }).collect(),
            distance: vec![1; tree.len()],
            known: vec![0; tree.len()],
            now: 0,
            active: (0..tree.len()).filter(|i| waiting[*i]).collect(),
            waiting,
            current: None,
            orphans: VecDeque::new(),
            tree,
            grid,
        }
    }

    fn activate(&mut self, cell: usize) {
        if !self.waiting[cell] {
            self.waiting[cell] = true;
            self.active.push_back(cell);
        }
    }

    /// What still fits between a cell of a tree and its neighbour, in the tree's own sense: away from the source, or to the sink.
    fn outward(&self, cell: usize, direction: usize, tree: Tree) -> i32 {
        if tree == Tree::Source {
            self.grid.room[direction][cell]
        } else {
            self.grid.room[direction ^ 1][self.grid.neighbour(cell, direction)]
        }
    }

    /// Grows the trees until they meet: the source's cell there and the direction of the sink's. None where they cannot.
    fn grow(&mut self) -> Option<(usize, usize)> {
        loop {
            let cell = match self.current.take() {
                Some(cell) => cell,
                None => {
                    let cell = self.active.pop_front()?;
                    self.waiting[cell] = false;
                    cell
                }
            };
            // It may have lost its parent since.
            if self.parent[cell] == NONE {
                continue;
            }
            let tree = self.tree[cell];
            for direction in 0..8 {
                if self.outward(cell, direction, tree) == 0 {
                    continue;
                }
                let next = self.grid.neighbour(cell, direction);
                let shorter = self.known[next] <= self.known[cell] && self.distance[next] > self.distance[cell];
                if self.tree[next] == Tree::Free {
                    self.tree[next] = tree;
                    self.descend(next, direction, cell);
                    self.activate(next);
                } else if self.tree[next] != tree {
                    // There may be more to find from here.
                    self.current = Some(cell);
                    return Some(if tree == Tree::Source { (cell, direction) } else { (next, direction ^ 1) });
                } else if shorter {
                    self.descend(next, direction, cell);
                }
            }
        }
    }

    /// Makes `cell`, from which `next` lies in `direction`, its parent.
    fn descend(&mut self, next: usize, direction: usize, cell: usize) {
        self.parent[next] = direction as u8 ^ 1;
        (self.known[next], self.distance[next]) = (self.known[cell], self.distance[cell] + 1);
    }

    /// The cells from `cell` to the one at its tree's end.
    fn way(&self, mut cell: usize) -> Vec<usize> {
        let mut way = vec![cell];
        while self.parent[cell] < END {
            cell = self.grid.neighbour(cell, self.parent[cell] as usize);
            way.push(cell);
        }
        way
    }

    /// What still fits between a cell and its parent, or its tree's end.
    fn inward(&self, cell: usize, tree: Tree) -> i32 {
        match self.parent[cell] {
            END | NONE => self.grid.end[cell].abs(),
            towards => self.outward(self.grid.neighbour(cell, towards as usize), towards as usize ^ 1, tree),
        }
    }

    /// Sends what fits along the way that [`Self::grow`] found; what it cuts off are orphans.
    fn augment(&mut self, from: usize, direction: usize) {
        let to = self.grid.neighbour(from, direction);
        let ways = [(Tree::Source, self.way(from)), (Tree::Sink, self.way(to))];
        let along = |(tree, way): &(Tree, Vec<usize>)| way.iter().map(|cell| self.inward(*cell, *tree)).min();
        let flow = ways.iter().filter_map(along).fold(self.grid.room[direction][from], i32::min);
        self.grid.room[direction][from] -= flow;
        self.grid.room[direction ^ 1][to] += flow;
        for (tree, way) in ways {
            for cell in way {
                match self.parent[cell] {
                    END | NONE => self.grid.end[cell] -= if tree == Tree::Source { flow } else { -flow },
                    towards => {
                        let towards = towards as usize;
                        let above = self.grid.neighbour(cell, towards);
                        let sent = if tree == Tree::Source { flow } else { -flow };
                        self.grid.room[towards ^ 1][above] -= sent;
                        self.grid.room[towards][cell] += sent;
                    }
                }
                if self.inward(cell, tree) == 0 {
                    self.parent[cell] = NONE;
                    self.orphans.push_front(cell);
                }
            }
        }
        self.now += 1;
    }

    /// How far a cell's tree's end is, if its way there is whole; marks the way as known now.
    fn steps_to_end(&mut self, from: usize) -> Option<u32> {
        let (mut cell, mut steps) = (from, 0);
        let total = loop {
            if self.known[cell] == self.now {
                break steps + self.distance[cell];
            }
            steps += 1;
            match self.parent[cell] {
                END => break steps,
                NONE => return None,
                towards => cell = self.grid.neighbour(cell, towards as usize),
            }
        };
        (cell, steps) = (from, total);
        while self.known[cell] != self.now {
            (self.known[cell], self.distance[cell]) = (self.now, steps);
            if self.parent[cell] == END {
                break;
            }
            cell = self.grid.neighbour(cell, self.parent[cell] as usize);
            steps -= 1;
        }
        Some(total)
    }

    /// Finds another parent for each orphan, the nearest to the tree's end, or sets it free.
    fn adopt(&mut self) {
        while let Some(cell) = self.orphans.pop_front() {
            let tree = self.tree[cell];
            let mut best: Option<(u32, usize)> = None;
            for direction in 0..8 {
                let next = self.grid.neighbour(cell, direction);
                let family = self.tree[next] == tree && self.parent[next] != NONE;
                if !family || self.outward(next, direction ^ 1, tree) == 0 {
                    continue;
                }
                if let Some(steps) = self.steps_to_end(next)
                    && best.is_none_or(|(least, _)| steps < least)
                {
                    best = Some((steps, direction));
                }
            }
            if let Some((steps, direction)) = best {
                self.parent[cell] = direction as u8;
                (self.known[cell], self.distance[cell]) = (self.now, steps + 1);
                continue;
            }
            for direction in 0..8 {
                let next = self.grid.neighbour(cell, direction);
                if self.tree[next] != tree || self.parent[next] == NONE {
                    continue;
                }
                if self.outward(next, direction ^ 1, tree) > 0 {
                    self.activate(next);
                }
                if self.parent[next] == direction as u8 ^ 1 {
                    self.parent[next] = NONE;
                    self.orphans.push_back(next);
                }
            }
            self.tree[cell] = Tree::Free;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers below `limit`, the same ones every time (Steele et al. 2014, SplitMix64).
    fn numbers(mut state: u64) -> impl FnMut(u64) -> i32 {
        move |limit| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) % limit) as i32
        }
    }

    /// What a labelling costs, counted pair by pair.
    fn energy(
        width: usize,
        opinion: &[i32],
        cost: &dyn Fn(usize, usize) -> i32,
        source: &dyn Fn(usize) -> bool,
    ) -> i32 {
        let own = |i: usize| if source(i) { (-opinion[i]).max(0) } else { opinion[i].max(0) };
        let touch = |i: usize, j: usize| {
            (i % width).abs_diff(j % width) <= 1 && (i / width).abs_diff(j / width) <= 1 && source(i) != source(j)
        };
        let pairs = (0..opinion.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let between: i32 = pairs.filter(|(i, j)| touch(*i, *j)).map(|(i, j)| cost(i, j)).sum();
        (0..opinion.len()).map(own).sum::<i32>() + between
    }

    #[test]
    fn no_labelling_of_a_small_grid_costs_less() {
        let mut number = numbers(7);
        for round in 0..300 {
            let (width, height) = [(4, 3), (3, 4), (1, 9), (9, 1), (2, 6)][round % 5];
            let pixels = width * height;
            let opinion: Vec<i32> = (0..pixels).map(|_| number(19) - 9).collect();
            let table: Vec<i32> = (0..pixels * pixels).map(|_| number(8)).collect();
            let cost = |i: usize, j: usize| table[i.min(j) * pixels + i.max(j)];
            let found = Grid::new(width, height, |i| opinion[i]).joined(cost).cut();
            let least = (0..1u32 << pixels).map(|m| energy(width, &opinion, &cost, &|i| m >> i & 1 == 1)).min();
            assert_eq!(Some(energy(width, &opinion, &cost, &|i| found[i])), least, "round {round}");
        }
    }

    #[test]
    fn a_gap_between_like_pixels_is_filled_and_a_speck_goes() {
        let (w, h) = (60, 40);
        let square = |i: usize| (15..45).contains(&(i % w)) && (10..30).contains(&(i / w));
        let gap = |i: usize| (28..32).contains(&(i % w)) && (18..22).contains(&(i / w));
        let speck = |i: usize| i == 5 * w + 5;
        let opinion = |i: usize| if square(i) && !gap(i) || speck(i) { 20 } else { -4 };
        // Across the square's outline neighbours are unlike.
        let cut = Grid::new(w, h, opinion).joined(|i, j| if square(i) == square(j) { 20 } else { 1 }).cut();
        assert!((0..w * h).all(|i| cut[i] == square(i)));
    }

    #[test]
    fn without_neighbours_each_has_its_own_opinion() {
        assert_eq!(Grid::new(3, 1, |i| [5, -1, 0][i]).cut(), [true, false, false]);
    }
}
