//! The renderer against the f64 reference: pictures, and gradients against the reference's finite differences.

use glam::Vec3;

use super::binning::TILE;
use super::projection::{Shown, View, backward};
use super::raster_backward::TileLoss;
use super::reference::{Pose, parameters, render as reference, render_shown};
use super::{Drawers, MEDIAN, Raster, SurfaceDepth, render};
use crate::splat::packed::Packed;
use crate::splat::train::random::Random;
use crate::splat::{Camera, Gaussians};

/// `n` Gaussians in the unit ball, `size` their median standard deviation.
pub fn scene(n: usize, size: f32, seed: u64) -> Gaussians {
    let mut r = Random::new(seed);
    let mut g = Gaussians::default();
    for _ in 0..n {
        g.positions.push(Vec3::new(r.normal(), r.normal(), r.normal()) * 0.4);
        g.log_scales.push(Vec3::splat(size.ln()) + Vec3::new(r.normal(), r.normal(), r.normal()) * 0.5);
        g.rotations.push(std::array::from_fn(|_| r.normal()));
        g.logit_opacities.push(1.5 * r.normal());
        g.sh.push(std::array::from_fn(|k| std::array::from_fn(|_| r.normal() * if k == 0 { 0.8 } else { 0.15 })));
    }
    g
}

/// A camera with a principal point off the centre and unequal focal lengths.
pub fn camera(width: u32, height: u32) -> Camera {
    let look = Camera::look_at(Vec3::new(1.2, -2.4, 0.9), Vec3::new(0.05, 0.1, -0.02), 0.6, 64);
    let focal = width as f32;
    Camera { width, height, fx: focal * 1.4, fy: focal * 1.6, cx: 0.4 * width as f32, cy: 0.57 * height as f32, ..look }
}

fn compare(g: &Gaussians, camera: &Camera) {
    let background = [0.2, 0.5, 0.9];
    let frame = render(g, camera, background);
    let expected = reference(&parameters(g), camera, &Pose::new(camera, [0.0; 6]));
    let mut doubtful = 0;
    for (i, p) in expected.iter().enumerate() {
        if p.doubtful {
            doubtful += 1;
            continue;
        }
        let at = (i % camera.width as usize, i / camera.width as usize);
        for c in 0..3 {
            let e = p.color[c] + p.transmittance * background[c] as f64;
            assert!((frame.color[i][c] as f64 - e).abs() < 1e-4, "{at:?} channel {c}: {} {e}", frame.color[i][c]);
        }
        let alpha = 1.0 - p.transmittance;
        assert!((frame.alpha[i] as f64 - alpha).abs() < 1e-4, "{at:?} alpha {} {alpha}", frame.alpha[i]);
        if alpha > 0.01 {
            let z = p.depth / alpha;
            assert!((frame.depth[i] as f64 - z).abs() < 1e-3, "{at:?} depth {} {z}", frame.depth[i]);
        }
        if (p.transmittance - 0.5).abs() > 1e-3 {
            assert!((frame.median_depth[i] as f64 - p.median).abs() < 1e-3 || p.median == 0.0, "{at:?} median");
        }
    }
    assert!(doubtful * 8 < expected.len(), "{doubtful} of {} pixels could not be compared", expected.len());
}

#[test]
fn pictures_match_the_reference() {
    for (seed, n, size) in [(1, 200, 0.05), (2, 30, 0.25), (3, 60, 0.01), (4, 1, 0.3)] {
        compare(&scene(n, size, seed), &camera(93, 70));
        compare(&scene(n, size, seed + 10), &camera(64, 64));
    }
}

#[test]
fn a_surface_may_be_met_before_half_the_light_is_stopped() {
    let mut g = scene(2, 0.2, 5);
    let c = camera(64, 64);
    let ray = c.rotation.transpose() * Vec3::new((32.5 - c.cx) / c.fx, (32.5 - c.cy) / c.fy, 1.0).normalize();
    g.positions = vec![c.position() + 2.0 * ray, c.position() + 3.0 * ray];
    g.logit_opacities = vec![(0.4f32 / 0.6).ln(); 2];
    let along = (c.rotation * ray).z;
    let at = |passing, settling| {
        let drawers = Drawers::with_surface(&g, SurfaceDepth { passing, settling });
        drawers.render(&c, [0.0; 3]).median_depth[32 * 64 + 32] / along
    };
    let (half, more, neither) = (at(MEDIAN, 0.0), at(0.7, 0.9), at(0.3, 0.0));
    assert!((half - 3.0).abs() < 1e-3 && (more - 2.0).abs() < 1e-3 && neither == 0.0, "{half} {more} {neither}");
    // Where half the light is stopped not far behind, the surface is there.
    let near = at(0.7, 1.1);
    assert!((near - 3.0).abs() < 1e-3, "{near}");
}

#[test]
fn long_thin_and_huge_ones_match_too() {
    let mut g = scene(20, 0.03, 9);
    g.log_scales[0] = Vec3::new(1.0, -5.0, -5.0);
    g.log_scales[1] = Vec3::splat(1.5);
    g.log_scales[2] = Vec3::new(-12.0, -12.0, -12.0);
    compare(&g, &camera(80, 48));
}

#[test]
fn what_cannot_be_drawn_is_left_out() {
    let good = scene(30, 0.08, 6);
    let picture = render(&good, &camera(50, 50), [0.0; 3]);
    let mut g = good.clone();
    let bad = scene(9, 0.1, 7);
    for i in 0..9 {
        g.positions.push(bad.positions[i]);
        g.log_scales.push(bad.log_scales[i]);
        g.rotations.push(bad.rotations[i]);
        g.logit_opacities.push(bad.logit_opacities[i]);
        g.sh.push(bad.sh[i]);
    }
    g.positions[30] = Vec3::new(4.0, -8.0, 3.0); // behind
    g.positions[31].x = f32::NAN;
    g.positions[32].y = f32::INFINITY;
    g.log_scales[33].z = f32::NAN;
    g.log_scales[34] = Vec3::splat(90.0); // e^90: not finite once squared
    g.rotations[35] = [0.0; 4];
    g.rotations[36][2] = f32::INFINITY;
    g.logit_opacities[37] = f32::NAN;
    g.sh[38][3][1] = f32::NAN;
    assert_eq!(render(&g, &camera(50, 50), [0.0; 3]), picture);
    // Nothing at all, and one pixel.
    let empty = render(&Gaussians::default(), &camera(50, 50), [0.1, 0.2, 0.3]);
    assert!(empty.color.iter().all(|c| *c == [0.1, 0.2, 0.3]) && empty.alpha.iter().all(|a| *a == 0.0));
    render(&g, &camera(1, 1), [0.0; 3]);
    // Extreme but finite ones must not panic.
    for s in [-80.0, 20.0, 35.0, 43.0] {
        let mut g = good.clone();
        g.log_scales.iter_mut().for_each(|v| v.x = s);
        let f = render(&g, &camera(40, 40), [0.0; 3]);
        assert!(f.color.iter().flatten().all(|v| v.is_finite()));
    }
}

#[test]
fn normals_are_those_of_the_surface() {
    // Discs on a sphere, their short axes along its radius, in any of the three places.
    let mut r = Random::new(40);
    let mut g = Gaussians::default();
    for i in 0..4000 {
        let out = Vec3::new(r.normal(), r.normal(), r.normal()).normalize();
        let mut scales = Vec3::splat(0.05f32.ln());
        scales[i % 3] = 0.004f32.ln();
        let q = glam::Quat::from_rotation_arc(Vec3::AXES[i % 3], if i % 2 == 0 { out } else { -out });
        g.positions.push(out);
        g.log_scales.push(scales);
        g.rotations.push([3.0 * q.w, 3.0 * q.x, 3.0 * q.y, 3.0 * q.z]);
        g.logit_opacities.push(4.0);
        g.sh.push([[0.3; 3]; 16]);
    }
    let c = camera(120, 100);
    let (frame, normals) = (render(&g, &c, [0.0; 3]), super::normals(&g, &c));
    let (mut seen, mut worst, mut sum) = (0, 0f32, 0f32);
    for (i, n) in normals.iter().enumerate() {
        if frame.alpha[i] < 1.0 / 255.0 {
            assert_eq!(*n, [0.0; 3]);
            continue;
        }
        let n = Vec3::from_array(*n);
        assert!((n.length() - 1.0).abs() < 1e-5);
        let (x, y) = ((i % 120) as f32 + 0.5, (i / 120) as f32 + 0.5);
        let ray = Vec3::new((x - c.cx) / c.fx, (y - c.cy) / c.fy, 1.0).normalize();
        // Where the ray first meets the sphere of radius 1 around the origin.
        let centre = c.translation;
        let along = ray.dot(centre);
        let under = along * along - centre.length_squared() + 1.0;
        if under > 0.1 {
            seen += 1;
            let want = (ray * (along - under.sqrt()) - centre).normalize();
            worst = worst.max(n.angle_between(want));
            sum += n.angle_between(want);
        }
    }
    // A disc reaches 0.15 rad around its own place; a standard deviation is 0.05, its mean distance 0.063.
    let mean = sum / seen as f32;
    assert!(seen > 2000 && worst < 0.3 && mean < 0.08, "{seen} pixels, {mean}, at most {worst} rad");
}

#[test]
fn gradients_match_finite_differences() {
    for seed in 0..4 {
        let camera = camera(35, 28);
        let mut g = scene(9, 0.2, 100 + seed);
        g.logit_opacities[0] = 7.0; // saturates at its centre
        g.positions[1] = Vec3::new(-0.9, -0.6, 0.7); // near the edge or outside: the Jacobian's clamp
        g.log_scales[1] = Vec3::splat(-0.3);
        g.sh[2][0] = [-1.9, 0.3, -1.6]; // under the colour clamp
        check_gradients(&g, &camera, seed, Shown::Color);
        // A round one has no shortest axis.
        g.log_scales[1] -= Vec3::new(0.0, 0.4, 0.2);
        check_gradients(&g, &camera, seed, Shown::Normals);
    }
}

fn check_gradients(g: &Gaussians, camera: &Camera, seed: u64, shown: Shown) {
    let (w, h) = (camera.width as usize, camera.height as usize);
    let mut r = Random::new(seed);
    // The loss: fixed random weights on colour and final transmittance.
    let weights: Vec<[f32; 4]> = (0..w * h).map(|_| std::array::from_fn(|_| r.uniform() - 0.3)).collect();
    let packed = Packed::pack(g);
    let view = View { shown, ..View::new(camera) };
    let mut raster = Raster::default();
    raster.bins.build(&packed, &view, 3);
    raster.forward(&view, None);
    let tiles_x = raster.bins.tiles_x;
    let mut loss = vec![TileLoss::default(); raster.tiles.len()];
    for (i, v) in weights.iter().enumerate() {
        let (x, y) = (i % w, i / w);
        let (t, at) = (y / TILE * tiles_x + x / TILE, y % TILE * TILE + x % TILE);
        for c in 0..3 {
            loss[t].color[c][at] = v[c];
        }
        loss[t].transmittance[at] = v[3];
    }
    raster.backward(&loss);

    let base = parameters(g);
    let value = |p: &[super::reference::Parameters], by: [f64; 6]| -> f64 {
        let pixels = render_shown(p, camera, &Pose::new(camera, by), shown);
        let one = |(p, v): (&super::reference::Pixel, &[f32; 4])| {
            (0..3).map(|c| p.color[c] * v[c] as f64).sum::<f64>() + p.transmittance * v[3] as f64
        };
        pixels.iter().zip(&weights).map(one).sum()
    };
    // So small that hardly any pixel crosses the 1/255 cut between the two values; f64 still leaves 6 digits.
    let eps = 1e-8;
    let close = |got: f32, expected: f64, what: &str| {
        let allowed = 0.01 * expected.abs() + 2e-3;
        assert!((got as f64 - expected).abs() < allowed, "scene {seed}, {what}: {got}, differences give {expected}");
    };
    let names = ["x", "y", "z", "opacity", "qw", "qx", "qy", "qz", "sx", "sy", "sz"];
    let mut pose = [0.0f32; 6];
    let mut largest = [0.0f64; 12];
    for i in 0..g.len() {
        let up = raster.gradient_of(i).unwrap_or_default();
        let got = backward(&packed.core[i], &packed.sh[i], &view, 3, &up).unwrap();
        for k in 0..6 {
            pose[k] += got.pose[k];
        }
        for k in 0..59 {
            let (mut a, mut b) = (base.clone(), base.clone());
            a[i][k] += eps;
            b[i][k] -= eps;
            let expected = (value(&a, [0.0; 6]) - value(&b, [0.0; 6])) / (2.0 * eps);
            largest[k.min(11)] = largest[k.min(11)].max(expected.abs());
            match k {
                0..11 => close(got.core[k], expected, &format!("Gaussian {i} {}", names[k])),
                _ => close(got.sh[k - 11], expected, &format!("Gaussian {i} coefficient {}", k - 11)),
            }
        }
    }
    // The tolerance would let zeros pass if every gradient were tiny.
    let own = if shown == Shown::Color { 12 } else { 11 };
    assert!(largest[..own].iter().all(|v| *v > 0.1), "{largest:?}");
    for k in 0..6 {
        let mut by = [0.0; 6];
        by[k] = eps;
        let up = value(&base, by);
        by[k] = -eps;
        let expected = (up - value(&base, by)) / (2.0 * eps);
        close(pose[k], expected, &format!("pose {k}"));
    }
}

/// Large ones touch nearly every tile: drawn in bands, down to a tile each, they are the same picture with the same way back.
#[test]
fn bands_do_not_change_a_byte() {
    let (g, c) = (scene(300, 0.8, 21), camera(93, 70));
    let (packed, view) = (Packed::pack(&g), View::new(&c));
    let run = |most: u64| {
        let (mut raster, mut depths) = (Raster::default(), Vec::new());
        raster.bins.build_within(&packed, &view, 3, most);
        raster.forward(&view, Some((&mut depths, SurfaceDepth::MEDIAN)));
        let touched: Vec<bool> = raster.bins.starts.windows(2).map(|w| w[0] < w[1]).collect();
        let mut loss = vec![TileLoss::default(); raster.tiles.len()];
        let all = loss.iter_mut().flat_map(|t| t.color.iter_mut().flatten().chain(&mut t.transmittance));
        all.enumerate().for_each(|(i, v)| *v = (i as f32 * 0.37).sin());
        raster.backward(&loss);
        let gradients: Vec<_> = (0..g.len()).map(|i| raster.gradient_of(i)).collect();
        let tiles: Vec<_> = raster.tiles.iter().map(|t| (t.transmittance, t.color, t.used)).collect();
        let depths: Vec<_> = depths.iter().map(|d| (d.expected, d.surface)).collect();
        (raster.bins.bands(), raster.bins.list.len(), (tiles, depths, touched, gradients))
    };
    let (bands, pairs, whole) = run(u64::MAX);
    assert!(bands == 1 && pairs > 2000 && whole.3.iter().any(Option::is_some), "{pairs} pairs");
    for (most, least) in [(pairs as u64, 1), (pairs as u64 / 3, 3), (1, 20)] {
        let (bands, listed, parts) = run(most);
        assert!(bands >= least && (bands == 1) == (least == 1), "{bands} bands");
        assert!(listed <= most.max(300) as usize, "{listed} of {most} pairs");
        assert!(parts == whole, "{bands} bands");
    }
}

#[test]
fn threads_do_not_change_a_byte() {
    let (g, c) = (scene(3000, 0.03, 20), camera(200, 150));
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| render(&g, &c, [0.0; 3]))
    };
    assert_eq!(run(1), run(2));
    assert_eq!(run(2), run(5));
}

#[test]
fn every_instruction_set_draws_the_same() {
    use super::raster_backward::Backward;
    use super::raster_forward::{Forward, TilePixels};
    use crate::splat::simd::{Portable, dispatch};
    let (packed, view) = (Packed::pack(&scene(300, 0.06, 31)), View::new(&camera(64, 48)));
    let mut raster = Raster::default();
    raster.bins.build(&packed, &view, 3);
    let bins = &raster.bins;
    let mut loss = TileLoss::default();
    loss.color.iter_mut().flatten().enumerate().for_each(|(i, v)| *v = (i as f32 * 0.37).sin());
    for t in 0..bins.tiles_x * bins.tiles_y {
        let list = &bins.list[bins.starts[t] as usize..bins.starts[t + 1] as usize];
        let (x0, y0) = (t % bins.tiles_x * TILE, t / bins.tiles_x * TILE);
        let draw = |run: &dyn Fn(Forward), pull: &dyn Fn(Backward)| {
            let mut pixels = TilePixels::default();
            run(Forward { splats: &bins.splats, list, x0, y0, pixels: &mut pixels, depth: None });
            let mut out = vec![Default::default(); list.len()];
            pull(Backward { splats: &bins.splats, list, x0, y0, pixels: &pixels, loss: &loss, out: &mut out });
            (pixels, out)
        };
        let compare = |a: (TilePixels, Vec<super::projection::SplatGradient>)| {
            let b = draw(&|k| dispatch(k), &|k| dispatch(k));
            for i in 0..TILE * TILE {
                assert!((a.0.color[1][i] - b.0.color[1][i]).abs() < 4e-3);
                assert!((a.0.transmittance[i].abs() - b.0.transmittance[i].abs()).abs() < 4e-3);
            }
            let sum = |a: &[super::projection::SplatGradient]| a.iter().map(|g| g.xx.abs() + g.g.abs()).sum::<f32>();
            assert!((sum(&a.1) - sum(&b.1)).abs() < 0.01 * sum(&b.1) + 1e-4);
        };
        use crate::splat::simd::Kernel;
        compare(draw(&|k| k.run(Portable), &|k| k.run(Portable)));
        #[cfg(target_arch = "x86_64")]
        if let Some(s) = crate::splat::simd::x86::Avx2::detect() {
            compare(draw(&|k| s.vectorize(k), &|k| s.vectorize(k)));
        }
    }
}
