//! The loss against its definition in f64.

#![allow(clippy::needless_range_loop)]
use super::*;
use crate::splat::train::random::Random;

fn window() -> [f64; 11] {
    let raw: [f64; 11] = std::array::from_fn(|i| (-((i as f64 - 5.0).powi(2)) / 4.5).exp());
    let sum: f64 = raw.iter().sum();
    raw.map(|v| v / sum)
}

/// The loss as its definition reads, in f64, one pixel and window at a time.
fn reference(w: usize, h: usize, x: &[[f64; 3]], y: &[[f64; 3]], lambda: f64) -> f64 {
    weighed_reference(w, h, x, y, lambda, &vec![1.0; w * h])
}

/// The same with a weight a pixel.
fn weighed_reference(w: usize, h: usize, x: &[[f64; 3]], y: &[[f64; 3]], lambda: f64, weights: &[f32]) -> f64 {
    let k = window();
    let mut total = 0.0;
    for c in 0..3 {
        for py in 0..h as i64 {
            for px in 0..w as i64 {
                let [mut mx, mut my, mut xx, mut yy, mut xy] = [0.0; 5];
                for dy in -5..=5i64 {
                    for dx in -5..=5i64 {
                        let (qx, qy) = (px + dx, py + dy);
                        if qx < 0 || qy < 0 || qx >= w as i64 || qy >= h as i64 {
                            continue;
                        }
                        let g = k[(dx + 5) as usize] * k[(dy + 5) as usize];
                        let (a, b) = (x[qy as usize * w + qx as usize][c], y[qy as usize * w + qx as usize][c]);
                        mx += g * a;
                        my += g * b;
                        xx += g * a * a;
                        yy += g * b * b;
                        xy += g * a * b;
                    }
                }
                let (c1, c2) = (1e-4, 9e-4);
                let ssim = (2.0 * mx * my + c1) * (2.0 * (xy - mx * my) + c2)
                    / ((mx * mx + my * my + c1) * (xx - mx * mx + yy - my * my + c2));
                let i = py as usize * w + px as usize;
                let loss = (1.0 - lambda) * (x[i][c] - y[i][c]).abs() + lambda * (1.0 - ssim);
                total += f64::from(weights[i]) * loss;
            }
        }
    }
    total / (3 * w * h) as f64
}

#[test]
fn window_is_a_normalised_gaussian() {
    for (i, w) in window().iter().enumerate() {
        assert!((w - WINDOW[i.abs_diff(5)] as f64).abs() < 1e-7, "{i}: {w}");
    }
}

#[test]
fn value_and_gradient_match_the_definition() {
    matches_the_definition(None);
}

#[test]
fn value_and_gradient_match_the_definition_with_a_weight_a_pixel() {
    let mut random = Random::new(8);
    matches_the_definition(Some((0..37 * 21).map(|i| if i % 7 == 0 { 0.0 } else { 2.0 * random.uniform() }).collect()));
}

fn matches_the_definition(weights: Option<Vec<f32>>) {
    let (w, h) = (37usize, 21usize);
    let weight = weights.clone().unwrap_or(vec![1.0; w * h]);
    let mut random = Random::new(5);
    let mut unit = || random.uniform();
    let color: Vec<[f32; 3]> = (0..w * h).map(|_| std::array::from_fn(|_| unit())).collect();
    let alpha: Vec<f32> = (0..w * h).map(|i| if i % w > 4 { unit() } else { 0.0 }).collect();
    let held: Vec<bool> = (0..w * h).map(|i| i / w > 15 && i % w > 20).collect();
    let tiles_x = w.div_ceil(TILE);
    let mut rendered = vec![TilePixels::default(); tiles_x * h.div_ceil(TILE)];
    for t in &mut rendered {
        t.transmittance.iter_mut().for_each(|v| *v = 0.1 + 0.8 * unit());
        t.color.iter_mut().for_each(|c| c.iter_mut().for_each(|v| *v = 0.5 * unit()));
    }
    let wanted = Wanted::new(w, h, &color, &alpha, Some(&held)).weighed(weights.as_deref());
    let behind = [0.9f32, 0.3, 0.0];
    let mut loss = Loss::new(w, h);
    let plain = |background| Terms { background, lambda: 0.2, exposure: None };
    let value = loss.evaluate(&rendered, |_| true, &wanted, plain(Background::Flat(behind)));
    let index = |x: usize, y: usize| (y / TILE * tiles_x + x / TILE, y % TILE * TILE + x % TILE);
    let picture = |rendered: &[TilePixels]| -> Vec<[f64; 3]> {
        (0..w * h)
            .map(|i| {
                let (t, p) = index(i % w, i / w);
                std::array::from_fn(|c| {
                    rendered[t].color[c][p] as f64 + rendered[t].transmittance[p] as f64 * behind[c] as f64
                })
            })
            .collect()
    };
    let x = picture(&rendered);
    let y: Vec<[f64; 3]> =
        (0..w * h)
            .map(|i| {
                let a = alpha[i] as f64;
                std::array::from_fn(|c| {
                    if held[i] { x[i][c] } else { color[i][c] as f64 * a + (1.0 - a) * behind[c] as f64 }
                })
            })
            .collect();
    let expected = weighed_reference(w, h, &x, &y, 0.2, &weight);
    assert!((value - expected).abs() < 1e-6, "{value} {expected}");
    for (px, py) in [(0, 0), (7, 3), (36, 20), (36, 2), (20, 15), (16, 16), (30, 18)] {
        let (t, p) = index(px, py);
        for c in 0..3 {
            let shifted = |by: f64| {
                let mut x = x.clone();
                x[py * w + px][c] += by;
                weighed_reference(w, h, &x, &y, 0.2, &weight)
            };
            let difference = (shifted(1e-5) - shifted(-1e-5)) / 2e-5;
            let difference = if held[py * w + px] { 0.0 } else { difference };
            let got = loss.tiles[t].color[c][p] as f64;
            assert!((got - difference).abs() < 1e-7 + 1e-3 * difference.abs(), "{px} {py} {c}: {got} {difference}");
        }
        let sum: f32 = (0..3).map(|c| loss.tiles[t].color[c][p] * behind[c]).sum();
        assert!((sum - loss.tiles[t].transmittance[p]).abs() < 1e-8);
    }
    // Padding of the last tiles must not pull on anything.
    assert_eq!(loss.tiles[tiles_x - 1].color[0][w % TILE], 0.0);
    assert_eq!(loss.tiles[tiles_x].transmittance[(h % TILE) * TILE], 0.0);
}

#[test]
fn equal_pictures_cost_nothing() {
    let (w, h) = (32, 32);
    let wanted = Wanted::new(w, h, &vec![[0.0; 3]; w * h], &vec![0.0; w * h], None);
    let rendered = vec![TilePixels::default(); 4];
    let mut loss = Loss::new(w, h);
    let terms = Terms { background: Background::Noise(3), lambda: 0.2, exposure: None };
    assert!(loss.evaluate(&rendered, |_| true, &wanted, terms).abs() < 1e-7);
    assert!(loss.tiles.iter().all(|t| t.color[0].iter().all(|v| v.abs() < 1e-8)));
}

/// Gradients of the exposure and of what it was applied to, against differences of the definition in f64.
#[test]
fn an_exposures_gradients_match_the_definition() {
    let (w, h) = (37usize, 21usize);
    let mut random = Random::new(9);
    let mut unit = || random.uniform();
    let color: Vec<[f32; 3]> = (0..w * h).map(|_| std::array::from_fn(|_| unit())).collect();
    let alpha: Vec<f32> = (0..w * h).map(|i| if i % w > 20 { unit() } else { 0.0 }).collect();
    let held: Vec<bool> = (0..w * h).map(|i| i / w > 15 && i % w > 20).collect();
    let tiles_x = w.div_ceil(TILE);
    let mut rendered = vec![TilePixels::default(); tiles_x * h.div_ceil(TILE)];
    for t in &mut rendered {
        // Finished early: the sign says so.
        t.transmittance.iter_mut().for_each(|v| *v = (0.1 + 0.8 * unit()) * if unit() < 0.2 { -1.0 } else { 1.0 });
        t.color.iter_mut().for_each(|c| c.iter_mut().for_each(|v| *v = 0.5 * unit()));
    }
    let wanted = Wanted::new(w, h, &color, &alpha, Some(&held));
    let behind = [0.9f32, 0.3, 0.1];
    let change: Change = [[1.2, 0.05, -0.1, 0.03], [0.02, 0.8, 0.0, -0.05], [-0.04, 0.1, 1.1, 0.02]];
    let terms = Terms { background: Background::Flat(behind), lambda: 0.2, exposure: Some(&change) };
    let mut loss = Loss::new(w, h);
    // Nothing is drawn anywhere, and yet all of it counts.
    let value = loss.evaluate(&rendered, |_| false, &wanted, terms);
    let index = |x: usize, y: usize| (y / TILE * tiles_x + x / TILE, y % TILE * TILE + x % TILE);
    let plain: Vec<[f64; 3]> = (0..w * h)
        .map(|i| {
            let (t, p) = index(i % w, i / w);
            let through = f64::from(rendered[t].transmittance[p].abs());
            std::array::from_fn(|c| f64::from(rendered[t].color[c][p]) + through * f64::from(behind[c]))
        })
        .collect();
    let exposed = |plain: &[[f64; 3]], m: &[[f64; 4]; 3]| -> Vec<[f64; 3]> {
        plain.iter().map(|x| m.map(|r| r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + r[3])).collect()
    };
    let m = change.map(|r| r.map(f64::from));
    let start = exposed(&plain, &m);
    // Where it is held back, the target is the render as it stands, and does not move with it.
    let y: Vec<[f64; 3]> = (0..w * h)
        .map(|i| {
            let a = f64::from(alpha[i]);
            std::array::from_fn(|c| {
                if held[i] { start[i][c] } else { f64::from(color[i][c]) * a + (1.0 - a) * f64::from(behind[c]) }
            })
        })
        .collect();
    assert!((value - reference(w, h, &start, &y, 0.2)).abs() < 1e-6);
    // What a held-back pixel does to its neighbours' windows is not counted: neither render nor target moves there.
    let frozen = |mut x: Vec<[f64; 3]>| {
        (0..w * h).filter(|i| held[*i]).for_each(|i| x[i] = start[i]);
        reference(w, h, &x, &y, 0.2)
    };
    for i in 0..3 {
        for k in 0..4 {
            let shifted = |by: f64| {
                let mut m = m;
                m[i][k] += by;
                frozen(exposed(&plain, &m))
            };
            let difference = (shifted(1e-6) - shifted(-1e-6)) / 2e-6;
            let got = f64::from(loss.exposure[i][k]);
            assert!((got - difference).abs() < 2e-6 + 2e-3 * difference.abs(), "{i} {k}: {got} {difference}");
        }
    }
    for (px, py) in [(0, 0), (7, 3), (36, 20), (36, 2), (20, 15), (16, 16), (30, 18)] {
        let (t, p) = index(px, py);
        for c in 0..3 {
            let shifted = |by: f64| {
                let mut x = plain.clone();
                x[py * w + px][c] += by;
                frozen(exposed(&x, &m))
            };
            let difference = (shifted(1e-6) - shifted(-1e-6)) / 2e-6;
            let got = f64::from(loss.tiles[t].color[c][p]);
            assert!((got - difference).abs() < 1e-7 + 1e-3 * difference.abs(), "{px} {py} {c}: {got} {difference}");
        }
        let sum: f32 = (0..3).map(|c| loss.tiles[t].color[c][p] * behind[c]).sum();
        assert!((sum - loss.tiles[t].transmittance[p]).abs() < 1e-8);
    }
}

#[test]
fn weights_of_one_change_no_bit_and_what_weighs_nothing_pulls_at_nothing() {
    let (w, h) = (40usize, 24usize);
    let mut random = Random::new(3);
    let mut unit = || random.uniform();
    let color: Vec<[f32; 3]> = (0..w * h).map(|_| std::array::from_fn(|_| unit())).collect();
    let alpha: Vec<f32> = (0..w * h).map(|_| unit()).collect();
    let mut rendered = vec![TilePixels::default(); 6];
    for t in &mut rendered {
        t.color.iter_mut().for_each(|c| c.iter_mut().for_each(|v| *v = 0.5 * unit()));
    }
    let evaluated = |weights: Option<&[f32]>| {
        let wanted = Wanted::new(w, h, &color, &alpha, None).weighed(weights);
        let mut loss = Loss::new(w, h);
        let terms = Terms { background: Background::Flat([0.2, 0.4, 0.6]), lambda: 0.2, exposure: None };
        let value = loss.evaluate(&rendered, |_| true, &wanted, terms);
        (value, loss.tiles)
    };
    let (plain, one) = (evaluated(None), evaluated(Some(&vec![1.0; w * h])));
    assert_eq!(plain.0, one.0);
    assert!(plain.1.iter().zip(&one.1).all(|(a, b)| a.color == b.color && a.transmittance == b.transmittance));
    // Farther than a window from what counts: columns 0 to 9 beside columns from 16 on.
    let right: Vec<f32> = (0..w * h).map(|i| if i % w < 16 { 0.0 } else { 1.0 }).collect();
    let (_, tiles) = evaluated(Some(&right));
    let pull = |x: usize| tiles[x / TILE].color[1][5 * TILE + x % TILE];
    assert!((0..10).all(|x| pull(x) == 0.0) && (20..w).all(|x| pull(x) != 0.0));
}
