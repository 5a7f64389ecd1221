//! A made place in blocks.

use super::{SITE, brief, trained, with_source};
use crate::pipeline::scene::blocks::{self, Blocks, Made, coarse_side};
use crate::pipeline::scene::*;
use crate::progress::Silent;

fn in_blocks(folder: &std::path::Path, options: &Options, only: Option<usize>) -> (Option<Scene>, Made) {
    let blocks = Blocks { count: 4, folder: folder.to_owned(), only, run: "made".into() };
    with_source(&SITE, false, |source| {
        blocks::fit(source, splat::Engine::Cpu, options, &blocks, None, &Silent, &mut |_| ()).unwrap()
    })
}

/// The held-out views' error within a few pixels of the cells' borders and elsewhere, mean squares.
fn at_seams(s: &Scene, cells: &[blocks::cells::Cell]) -> (f64, f64) {
    let drawers = crate::splat::render::Drawers::new(&s.gaussians);
    let (mut seam, mut else_) = ((0.0, 0), (0.0, 0));
    for v in s.views.iter().filter(|v| v.role == Role::HeldOut) {
        for (i, p) in blocks::cells::surface(&drawers, &v.camera).into_iter().enumerate() {
            let Some(p) = p.filter(|p| p.length() < 3.0) else { continue };
            let off: f64 = (0..3).map(|c| f64::from(v.found.pixels[i][c] - v.truth.pixels[i][c]).powi(2)).sum();
            let near = cells.iter().filter(|c| c.grown(0.03).holds(p)).count() > 1;
            let at = if near { &mut seam } else { &mut else_ };
            *at = (at.0 + off, at.1 + 1);
        }
    }
    assert!(seam.1 > 100 && else_.1 > 1000, "{seam:?} {else_:?}");
    (seam.0 / f64::from(seam.1), else_.0 / f64::from(else_.1))
}

#[test]
fn blocks_put_together_are_as_good_as_the_whole_and_have_no_seam() {
    let dir = tempfile::tempdir().unwrap();
    let o = Options { iterations: 150, max_gaussians: 6000, ..brief() };
    let (cut, made) = in_blocks(dir.path(), &o, None);
    let cut = cut.unwrap();
    assert_eq!((made.trained, made.found, cut.report.iterations), (5, 0, 750));
    assert_eq!((cut.held_out.photos, cut.trained.photos, cut.views.len()), (3, 21, 24));
    // As many steps as each block has, and as many Gaussians, for the whole.
    let whole = trained(&SITE, &Options { iterations: 150, max_gaussians: cut.gaussians.len(), ..brief() }, false);
    eprintln!("blocks {:.2} dB, whole {:.2} dB", cut.held_out.psnr, whole.held_out.psnr);
    assert!(cut.held_out.psnr > whole.held_out.psnr - 1.0, "{:?} {:?}", cut.held_out, whole.held_out);
    // The sky stands once, and last.
    let far = sky::beyond(extent(cut.cameras.iter().map(Camera::position)));
    let first = cut.gaussians.len() - cut.sky;
    assert!(cut.sky > 100 && cut.gaussians.positions[first..].iter().all(|p| p.length() > far));
    assert!(cut.gaussians.positions[..first].iter().all(|p| p.length() <= far));
    // Every block has its own ground, and about as much.
    let near = &cut.gaussians.positions[..first];
    let (cells, _) = blocks::cells::cells(near, 4);
    // At seams they are as much worse than the whole as they are elsewhere.
    let (a, b) = (at_seams(&cut, &cells), at_seams(&whole, &cells));
    eprintln!("mean squares at seams and elsewhere: blocks {a:.5?}, whole {b:.5?}");
    assert!(a.0 / b.0 < 1.3 * a.1 / b.1, "{a:?} {b:?}");
}

#[test]
fn blocks_go_on_from_what_stands_there_to_the_same_bytes() {
    let o = Options { iterations: 30, max_gaussians: 3000, ..brief() };
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    let whole = in_blocks(&at("a"), &o, None).0.unwrap();
    // One machine makes the coarse scene and the third block, another, from its coarse scene, the first.
    let (none, made) = in_blocks(&at("b"), &o, Some(2));
    assert!(none.is_none() && made.trained == 2);
    std::fs::create_dir_all(at("c/coarse")).unwrap();
    std::fs::copy(at("b/coarse/gaussians.part"), at("c/coarse/gaussians.part")).unwrap();
    assert_eq!(in_blocks(&at("c"), &o, Some(0)).1, Made { trained: 1, found: 1 });
    std::fs::create_dir_all(at("b/block_001")).unwrap();
    std::fs::copy(at("c/block_001/gaussians.part"), at("b/block_001/gaussians.part")).unwrap();
    let (rest, made) = in_blocks(&at("b"), &o, None);
    let rest = rest.unwrap();
    assert_eq!(made, Made { trained: 2, found: 3 });
    assert!(rest.gaussians == whole.gaussians && rest.held_out == whole.held_out);
    assert!(!at("b/block_002/run.ckpt").exists());
    assert_eq!([coarse_side(1600, 4), coarse_side(1600, 10_000), coarse_side(96, 1)], [800, 16, 96]);
}
