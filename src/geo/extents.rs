//! The size of a reconstruction in its own units, whatever way it is turned.

/// Extents of the reconstruction in its own units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extents {
    pub height: f64,
    pub length: f64,
    pub width: f64,
    /// Height of the frame's centre above the ground contact.
    pub centre_above_ground: f64,
}

impl Extents {
    /// Of points in the unit frame (Z up). The footprint's rectangle is the one of smallest area.
    pub fn of(points: impl Iterator<Item = [f64; 3]>) -> Option<Self> {
        let (mut low, mut high, mut flat) = (f64::INFINITY, f64::NEG_INFINITY, Vec::new());
        for [x, y, z] in points {
            low = low.min(z);
            high = high.max(z);
            flat.push([x, y]);
        }
        let hull = convex_hull(flat);
        if hull.is_empty() {
            return None;
        }
        let (length, width) = smallest_rectangle(&hull);
        Some(Extents { height: high - low, length, width, centre_above_ground: -low })
    }
}

/// Andrew's monotone chain, counter-clockwise.
pub fn convex_hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let turn = |o: [f64; 2], a: [f64; 2], b: [f64; 2]| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    let mut hull: Vec<[f64; 2]> = Vec::new();
    for pass in 0..2 {
        let base = hull.len();
        let step = |hull: &mut Vec<[f64; 2]>, p: [f64; 2]| {
            while hull.len() >= base + 2 && turn(hull[hull.len() - 2], hull[hull.len() - 1], p) <= 0.0 {
                hull.pop();
            }
            hull.push(p);
        };
        if pass == 0 {
            points.iter().for_each(|&p| step(&mut hull, p));
        } else {
            points.iter().rev().for_each(|&p| step(&mut hull, p));
        }
        hull.pop();
    }
    hull
}

/// The smallest enclosing rectangle has a side along a hull edge (Freeman and Shapira 1975): (longer, shorter).
fn smallest_rectangle(hull: &[[f64; 2]]) -> (f64, f64) {
    let extent = |ux: f64, uy: f64| {
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        for p in hull {
            let d = p[0] * ux + p[1] * uy;
            lo = lo.min(d);
            hi = hi.max(d);
        }
        hi - lo
    };
    let mut best = (f64::INFINITY, 0.0, 0.0);
    for i in 0..hull.len() {
        let (a, b) = (hull[i], hull[(i + 1) % hull.len()]);
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let l = dx.hypot(dy);
        let (ux, uy) = if l > 0.0 { (dx / l, dy / l) } else { (1.0, 0.0) };
        let (along, across) = (extent(ux, uy), extent(-uy, ux));
        if along * across < best.0 {
            best = (along * across, along.max(across), along.min(across));
        }
    }
    (best.1, best.2)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned_box(degrees: f64) -> Vec<[f64; 3]> {
        let (s, c) = degrees.to_radians().sin_cos();
        let mut v = Vec::new();
        for x in [-1.0, 1.0] {
            for y in [-0.4, 0.4] {
                for z in [-0.3, 0.5] {
                    v.push([x * c - y * s, x * s + y * c, z]);
                }
            }
        }
        v
    }

    #[test]
    fn extents_do_not_depend_on_heading() {
        for d in [0.0, 17.0, 45.0, 80.0, 133.0] {
            let e = Extents::of(turned_box(d).into_iter()).unwrap();
            assert!((e.length - 2.0).abs() < 1e-12 && (e.width - 0.8).abs() < 1e-12 && (e.height - 0.8).abs() < 1e-12);
            assert!((e.centre_above_ground - 0.3).abs() < 1e-12);
        }
        assert!(Extents::of(std::iter::empty()).is_none());
    }
}
