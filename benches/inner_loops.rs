//! The inner loops: drawing splats, drawing triangles, closest points, the metrics of a picture.
//! `cargo bench --bench inner_loops`; the whole, with stages: `orb bench speed`.

use divan::{Bencher, bench, black_box};
use glam::{Quat, Vec2, Vec3};
use image::RgbImage;
use orb::bench::surfaces::{Shape, scores};
use orb::bench::{Picture, consistency, perception};
use orb::mesh::{self, Mesh, Surface};
use orb::splat::{Gaussians, SH_COEFFICIENTS, render};
use orb::views;

/// SplitMix64 (Steele et al. 2014), 0..1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / (1u64 << 24) as f32
    }
}

/// Flat splats on the unit sphere.
fn splats(n: usize) -> Gaussians {
    let mut r = Random(5);
    let mut g = Gaussians::default();
    for p in mesh::fibonacci_sphere(n) {
        g.positions.push(0.9 * p);
        let size = (2.0 / (n as f32).sqrt()).ln();
        g.log_scales.push(Vec3::new(size, size, size - 1.5));
        let q = Quat::from_rotation_arc(Vec3::Z, p);
        g.rotations.push([q.w, q.x, q.y, q.z]);
        g.logit_opacities.push(1.0 + 2.0 * r.next());
        g.sh.push([[0.3 * (r.next() - 0.5); 3]; SH_COEFFICIENTS]);
    }
    g
}

/// A textured ball of about 2 n² triangles.
fn ball(n: u32, radius: f32) -> (Mesh, RgbImage) {
    let mut m = Mesh::default();
    for i in 0..=n {
        for j in 0..=n {
            let (u, v) = (i as f32 / n as f32, j as f32 / n as f32);
            let (a, e) = (std::f32::consts::TAU * u, std::f32::consts::PI * (v - 0.5));
            let d = Vec3::new(a.cos() * e.cos(), a.sin() * e.cos(), e.sin());
            m.positions.push(radius * d);
            m.normals.push(d);
            m.uvs.push(Vec2::new(u, v));
            if i < n && j < n {
                let k = i * (n + 1) + j;
                m.triangles.extend([[k, k + n + 1, k + 1], [k + 1, k + n + 1, k + n + 2]]);
            }
        }
    }
    (m, RgbImage::from_fn(512, 512, |x, y| image::Rgb([x as u8, y as u8, (x ^ y) as u8])))
}

fn surface((m, _): &(Mesh, RgbImage)) -> Surface {
    Surface { positions: m.positions.clone(), triangles: m.triangles.clone() }
}

#[bench(name = "splats, 30,000 at 512²", sample_count = 20)]
fn splats_drawn(b: Bencher) {
    let (g, camera) = (splats(30_000), views::orbit(30.0, 20.0, views::DISTANCE, 512));
    b.bench(|| render(black_box(&g), &camera, [1.0; 3]));
}

#[bench(name = "triangles, 8,192 at 512²", sample_count = 20)]
fn triangles_drawn(b: Bencher) {
    let ((m, texture), camera) = (ball(64, 0.9), views::orbit(30.0, 20.0, views::DISTANCE, 512));
    b.bench(|| mesh::raster(black_box(&m), Some(&texture), &camera, [255; 3], 2));
}

#[bench(name = "what is seen of 8,192 triangles from 32 sides", sample_count = 20)]
fn what_is_seen(b: Bencher) {
    let a = surface(&ball(64, 0.9));
    b.bench(|| Shape::of_surface(black_box(&a)));
}

fn shapes() -> [Shape; 2] {
    [0.9, 0.92].map(|radius| Shape::of_surface(&surface(&ball(64, radius))))
}

#[bench(name = "Chamfer and F-score, 20,000 points a side", sample_count = 20)]
fn distances(b: Bencher) {
    let [found, truth] = shapes();
    b.bench(|| scores(black_box(&found), &truth, 3.0));
}

#[bench(name = "volume IoU, 48 cells", sample_count = 20)]
fn volumes(b: Bencher) {
    let [found, truth] = shapes();
    b.bench(|| black_box(&found).volume_iou(&truth, (Vec3::splat(-1.0), Vec3::splat(1.0)), 48));
}

fn pictures() -> [Picture; 2] {
    let mut r = Random(9);
    [(); 2].map(|()| Picture::new(256, 256, (0..256 * 256).map(|_| [r.next(), r.next(), r.next()]).collect()))
}

#[bench(name = "PSNR, 256²", sample_count = 20)]
fn psnr(b: Bencher) {
    let [found, truth] = pictures();
    b.bench(|| perception::psnr(black_box(&found.pixels), &truth.pixels));
}

#[bench(name = "SSIM, 256²", sample_count = 20)]
fn ssim(b: Bencher) {
    let [found, truth] = pictures();
    b.bench(|| perception::ssim(black_box(&found), &truth));
}

#[bench(name = "MS-SSIM, 256²", sample_count = 20)]
fn ms_ssim(b: Bencher) {
    let [found, truth] = pictures();
    b.bench(|| perception::ms_ssim(black_box(&found), &truth));
}

#[bench(name = "ΔE2000, 256²", sample_count = 20)]
fn delta_e(b: Bencher) {
    let [found, truth] = pictures();
    b.bench(|| perception::delta_e_2000(black_box(&found.pixels), &truth.pixels, |_| true));
}

#[bench(name = "reprojection error, 256²", sample_count = 20)]
fn reprojection_error(b: Bencher) {
    let [found, truth] = pictures();
    b.bench(|| consistency::reprojection_error(black_box(&found), &truth));
}

fn main() {
    divan::main();
}
