//! Closest points on triangle meshes.

use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// A bounding volume hierarchy over triangles.
pub struct Bvh {
    nodes: Vec<Node>,
    /// Triangle numbers in tree order.
    order: Vec<u32>,
    corners: Vec<[Vec3; 3]>,
}

#[derive(Clone, Copy)]
struct Node {
    lo: Vec3,
    hi: Vec3,
    /// Leaf: first and count in `order`. Inner: left child is next, right child is `first`, `count` is 0.
    first: u32,
    count: u32,
}

/// The closest point on a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Closest {
    pub point: Vec3,
    pub triangle: u32,
    pub distance: f32,
}

const LEAF: usize = 4;

/// Nodes of the tree over so many triangles.
fn nodes_of(triangles: usize) -> usize {
    match triangles <= LEAF {
        true => 1,
        false => 1 + nodes_of(triangles / 2) + nodes_of(triangles - triangles / 2),
    }
}

/// Sorts `order` into the tree whose first node is `nodes[0]`. `at`: where that node and the first triangle of `order` are
/// numbered. Halves of many triangles are sorted side by side.
fn split(mesh: (&[[Vec3; 3]], &[Vec3]), order: &mut [u32], nodes: &mut [Node], at: [u32; 2]) {
    const MANY: usize = 4096;
    let (corners, middles) = mesh;
    let (mut lo, mut hi) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let (mut mid_lo, mut mid_hi) = (lo, hi);
    for &t in &*order {
        for p in corners[t as usize] {
            (lo, hi) = (lo.min(p), hi.max(p));
        }
        let mid = middles[t as usize];
        (mid_lo, mid_hi) = (mid_lo.min(mid), mid_hi.max(mid));
    }
    let count = order.len();
    if count <= LEAF {
        nodes[0] = Node { lo, hi, first: at[1], count: count as u32 };
        return;
    }
    let size = mid_hi - mid_lo;
    let axis = if size.x >= size.y && size.x >= size.z { 0 } else { 1 + usize::from(size.z > size.y) };
    let half = count / 2;
    let key = |t: u32| middles[t as usize][axis];
    order.select_nth_unstable_by(half, |a, b| key(*a).total_cmp(&key(*b)).then(a.cmp(b)));
    let left = nodes_of(half);
    nodes[0] = Node { lo, hi, first: at[0] + 1 + left as u32, count: 0 };
    let (near, far) = order.split_at_mut(half);
    let (first, second) = nodes[1..].split_at_mut(left);
    let mut one = || split(mesh, near, first, [at[0] + 1, at[1]]);
    let mut other = || split(mesh, far, second, [at[0] + 1 + left as u32, at[1] + half as u32]);
    if count > MANY {
        rayon::join(one, other);
    } else {
        one();
        other();
    }
}

impl Bvh {
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let corners: Vec<[Vec3; 3]> = triangles.iter().map(|t| t.map(|i| positions[i as usize])).collect();
        let mut order: Vec<u32> = (0..corners.len() as u32).collect();
        let mut nodes = Vec::new();
        if !corners.is_empty() {
            let middles: Vec<Vec3> = corners.iter().map(|[a, b, c]| *a + *b + *c).collect();
            nodes.resize(nodes_of(order.len()), Node { lo: Vec3::ZERO, hi: Vec3::ZERO, first: 0, count: 0 });
            split((&corners, &middles), &mut order, &mut nodes, [0, 0]);
        }
        Bvh { nodes, order, corners }
    }

    /// The closest point among triangles that `accept`s; None when there is none within `limit`.
    pub fn closest(&self, p: Vec3, limit: f32, accept: impl Fn(u32) -> bool) -> Option<Closest> {
        let mut best: Option<Closest> = None;
        let mut least = limit * limit;
        let mut stack = [0u32; 64];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let at = stack[depth] as usize;
            let node = &self.nodes[at];
            if box_distance(node, p) > least {
                continue;
            }
            if node.count > 0 {
                for &t in &self.order[node.first as usize..(node.first + node.count) as usize] {
                    let point = closest_on_triangle(p, &self.corners[t as usize]);
                    let d = point.distance_squared(p);
                    if d <= least && (d < least || best.is_none()) && accept(t) {
                        least = d;
                        best = Some(Closest { point, triangle: t, distance: d.sqrt() });
                    }
                }
                continue;
            }
            let (left, right) = (at as u32 + 1, node.first);
            let nearer_left =
                box_distance(&self.nodes[left as usize], p) <= box_distance(&self.nodes[right as usize], p);
            let (near, far) = if nearer_left { (left, right) } else { (right, left) };
            // Median splits keep the tree under 64 deep.
            stack[depth] = far;
            stack[depth + 1] = near;
            depth += 2;
        }
        best
    }

    /// Distance to the mesh; infinite when it is empty.
    pub fn distance(&self, p: Vec3) -> f32 {
        self.closest(p, f32::MAX.sqrt(), |_| true).map_or(f32::INFINITY, |c| c.distance)
    }
}

fn box_distance(node: &Node, p: Vec3) -> f32 {
    (node.lo - p).max(p - node.hi).max(Vec3::ZERO).length_squared()
}

/// Ericson, "Real-Time Collision Detection" (2005), §5.1.5.
fn closest_on_triangle(p: Vec3, [a, b, c]: &[Vec3; 3]) -> Vec3 {
    let (ab, ac, ap) = (*b - *a, *c - *a, p - *a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return *a;
    }
    let bp = p - *b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return *b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return *a + ab * (d1 / (d1 - d3));
    }
    let cp = p - *c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return *c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return *a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return *b + (*c - *b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let sum = va + vb + vc;
    if sum > 0.0 { *a + ab * (vb / sum) + ac * (vc / sum) } else { *a }
}

/// Barycentric coordinates of `p` in a plane triangle; None when it has no area.
pub fn barycentric(p: Vec2, [a, b, c]: [Vec2; 3]) -> Option<[f32; 3]> {
    let area = (b - a).perp_dot(c - a);
    if area.abs() < 1e-20 {
        return None;
    }
    let v = (p - a).perp_dot(c - a) / area;
    let w = (b - a).perp_dot(p - a) / area;
    Some([1.0 - v - w, v, w])
}

/// Barycentric coordinates of a point in the plane of a triangle in space; the first corner where it has no area.
pub fn barycentric_3d(p: Vec3, [a, b, c]: [Vec3; 3]) -> Vec3 {
    let n = (b - a).cross(c - a);
    let area = n.length_squared();
    if area <= 1e-30 {
        return Vec3::X;
    }
    let v = (p - a).cross(c - a).dot(n) / area;
    let w = (b - a).cross(p - a).dot(n) / area;
    Vec3::new(1.0 - v - w, v, w)
}

/// Largest and mean distance from `points` to a mesh.
pub fn farthest(points: &[Vec3], bvh: &Bvh) -> (f32, f32) {
    /// Points that one thread asks about in turn: neighbours have neighbours.
    const RUN: usize = 256;
    let distances: Vec<f32> = points
        .par_chunks(RUN)
        .flat_map_iter(|points| {
            let mut last = None;
            points.iter().map(move |p| {
                last = bvh.closest(*p, within(*p, &last, f32::MAX.sqrt()), |_| true);
                last.map_or(f32::INFINITY, |c| c.distance)
            })
        })
        .collect();
    let mean = distances.iter().map(|d| *d as f64).sum::<f64>() / distances.len().max(1) as f64;
    (distances.iter().copied().fold(0.0, f32::max), mean as f32)
}

/// How far from `p` to look at most, when the last point found lies on a triangle that may be found again.
pub fn within(p: Vec3, last: &Option<Closest>, limit: f32) -> f32 {
    // A little more, as the distance to that triangle is rounded otherwise.
    last.map_or(limit, |c| (p.distance(c.point) * 1.0001 + 1e-6).min(limit))
}

/// Vertices, edge middles and face centres, every `step`th: where distances are taken.
pub fn samples(positions: &[Vec3], triangles: &[[u32; 3]], most: usize) -> Vec<Vec3> {
    let step = (triangles.len() * 3 / most.max(1)).max(1);
    triangles
        .iter()
        .step_by(step)
        .flat_map(|t| {
            let [a, b, c] = t.map(|i| positions[i as usize]);
            [a, (a + b) / 2.0, (a + b + c) / 3.0]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closest_agrees_with_trying_all() {
        let mut state = 7u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32
        };
        let positions: Vec<Vec3> = (0..300).map(|_| Vec3::new(next(), next(), next())).collect();
        let triangles: Vec<[u32; 3]> = (0..100).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let bvh = Bvh::new(&positions, &triangles);
        for _ in 0..200 {
            let p = Vec3::new(next(), next(), next()) * 2.0 - 0.5;
            let brute = bvh.corners.iter().map(|c| closest_on_triangle(p, c).distance(p)).fold(f32::INFINITY, f32::min);
            assert_eq!(bvh.distance(p), brute);
            let odd = bvh.closest(p, 10.0, |t| t % 2 == 1).unwrap();
            assert!(odd.triangle % 2 == 1 && odd.distance >= brute);
        }
        assert_eq!(Bvh::new(&[], &[]).distance(Vec3::ZERO), f32::INFINITY);
    }
}
