//! Holes of a grid filled smoothly: inside them the values are those of a membrane that is stretched over the cells around
//! (Laplace's equation), begun on coarser and coarser grids (Gortler et al. 1996, pull and push) and relaxed on each.

/// Gauss-Seidel passes on each grid.
const PASSES: usize = 24;

/// Gives every cell that is not `known` a value; those that are keep theirs. Row by row, `width` a row. Where none is known
/// nothing changes.
pub fn fill(values: &mut [f32], known: &[bool], width: usize) {
    let height = values.len().checked_div(width).unwrap_or(0);
    if !known.contains(&true) || !known.contains(&false) {
        return;
    }
    let (half, half_height) = (width.div_ceil(2), height.div_ceil(2));
    let (mut coarse, mut coarse_known) = (vec![0.0; half * half_height], vec![false; half * half_height]);
    for i in 0..coarse.len() {
        let (mut sum, mut count) = (0.0, 0u8);
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let (x, y) = (2 * (i % half) + dx, 2 * (i / half) + dy);
            if x < width && y < height && known[y * width + x] {
                sum += values[y * width + x];
                count += 1;
            }
        }
        (coarse[i], coarse_known[i]) = (sum / f32::from(count.max(1)), count > 0);
    }
    fill(&mut coarse, &coarse_known, half);
    // A cell's middle lies a quarter of a coarse cell beside the coarse one's.
    let between = |x: usize, y: usize| {
        let at = |v: usize, last: usize| {
            let v = (v as f32 / 2.0 - 0.25).clamp(0.0, (last - 1) as f32);
            (v as usize, (v as usize + 1).min(last - 1), v.fract())
        };
        let ((x0, x1, a), (y0, y1, b)) = (at(x, half), at(y, half_height));
        let row = |y: usize| coarse[y * half + x0] * (1.0 - a) + coarse[y * half + x1] * a;
        row(y0) * (1.0 - b) + row(y1) * b
    };
    let open: Vec<usize> = (0..values.len()).filter(|i| !known[*i]).collect();
    for &i in &open {
        values[i] = between(i % width, i / width);
    }
    for _ in 0..PASSES {
        for &i in &open {
            let (x, y) = (i % width, i / width);
            // Beyond the grid it goes on as it is at its edge.
            let around = [
                values[if x > 0 { i - 1 } else { i }],
                values[if x + 1 < width { i + 1 } else { i }],
                values[if y > 0 { i - width } else { i }],
                values[if y + 1 < height { i + width } else { i }],
            ];
            values[i] = around.iter().sum::<f32>() / 4.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hole_in_a_slope_is_the_slope_and_nothing_leaves_the_range_around() {
        // 90 × 70: a plane with a hole of 40 × 30, and one at the corner.
        let (w, h) = (90usize, 70usize);
        let plane = |i: usize| 3.0 + 0.02 * (i % w) as f32 - 0.01 * (i / w) as f32;
        let hole = |i: usize| {
            let (x, y) = (i % w, i / w);
            ((20..60).contains(&x) && (20..50).contains(&y)) || (x > 80 && y < 5)
        };
        let known: Vec<bool> = (0..w * h).map(|i| !hole(i)).collect();
        let mut values: Vec<f32> = (0..w * h).map(|i| if hole(i) { 99.0 } else { plane(i) }).collect();
        fill(&mut values, &known, w);
        let inner = |i: usize| (20..60).contains(&(i % w));
        let worst = (0..w * h).filter(|i| inner(*i)).map(|i| (values[i] - plane(i)).abs()).fold(0.0, f32::max);
        assert!(worst < 0.03, "{worst}");
        assert!((0..w * h).filter(|i| !hole(*i)).all(|i| values[i] == plane(i)));
        let (low, high) = (plane((h - 1) * w), plane(w - 1));
        assert!(values.iter().all(|v| (low..=high).contains(v)));
        // One cell says it all; none leaves everything.
        let mut one = vec![0.0; 12];
        one[5] = 7.0;
        fill(&mut one, &(0..12).map(|i| i == 5).collect::<Vec<_>>(), 4);
        assert_eq!(one, [7.0; 12]);
        let mut none = vec![1.0, 2.0];
        fill(&mut none, &[false; 2], 2);
        assert_eq!(none, [1.0, 2.0]);
    }
}
