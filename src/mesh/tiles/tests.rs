use super::super::raster::texture_at;
use super::super::{scenes, surrounding_cameras};
use super::*;
use crate::progress::Silent;
use std::collections::BTreeSet;

/// Half the width of the ground that is meshed.
const HALF: f32 = 0.8;
const VOXEL: f32 = 0.02;

/// Waves with a block and a ball on them, over all that cameras see.
fn ground() -> scenes::Scene {
    scenes::Scene::new(|p: Vec3| {
        // Less than the waves' distance: they are up to 0.15 steep.
        let waves = 0.9 * (p.z - 0.03 * (4.0 * p.x).sin() * (3.0 * p.y).cos());
        let q = (p - Vec3::new(0.1, -0.05, 0.1)).abs() - Vec3::new(0.3, 0.22, 0.12);
        let block = q.max(Vec3::ZERO).length() + q.max_element().min(0.0);
        let ball = p.distance(Vec3::new(-0.45, 0.4, 0.1)) - 0.16;
        waves.min(block).min(ball)
    })
}

fn cameras() -> Vec<Camera> {
    surrounding_cameras(64, 200).into_iter().filter(|c| c.position().z > 1.6).collect()
}

fn inside(p: Vec2) -> bool {
    p.abs().max_element() < HALF
}

fn with_scene<T>(run: impl FnOnce(&Scene) -> T) -> T {
    let (ground, cameras) = (ground(), cameras());
    let render = |c: &Camera| ground.render(c);
    let pixel = super::super::VIEW_DISTANCE / cameras[0].fx;
    let (low, high) = (Vec3::new(-HALF, -HALF, -0.15), Vec3::new(HALF, HALF, 0.4));
    run(&Scene { render: &render, cameras: &cameras, inside: &inside, low, high, pixel })
}

fn options() -> Options {
    // Closer than by default, or too little is left of so smooth a scene.
    Options { voxel: Some(VOXEL), tile: 16, error: 0.05 }
}

type Edge = [[u32; 3]; 2];

/// How many triangles have each edge, by the bits of its ends.
fn edges<'a>(tiles: impl IntoIterator<Item = &'a Surface>) -> BTreeMap<Edge, usize> {
    let mut out = BTreeMap::new();
    for tile in tiles {
        for t in &tile.triangles {
            for k in 0..3 {
                let [a, b] = [t[k], t[(k + 1) % 3]].map(|v| bits(tile.positions[v as usize]));
                *out.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
    }
    out
}

fn on_rim(end: &[u32; 3]) -> bool {
    let p = Vec3::from_array(end.map(f32::from_bits));
    p.truncate().abs().max_element() > HALF - 1.5 * VOXEL
}

/// Two triangles at every edge but those of the scene's rim.
fn assert_closed(tiles: &[Surface], what: &str) {
    let edges = edges(tiles);
    let (mut open, mut rim) = (Vec::new(), 0);
    for (ends, count) in &edges {
        assert!(*count <= 2, "{what}: {count} triangles at an edge");
        match *count == 2 {
            true => {}
            false if ends.iter().all(on_rim) => rim += 1,
            false => open.push(ends.map(|e| Vec3::from_array(e.map(f32::from_bits)))),
        }
    }
    assert!(open.is_empty(), "{what}: {} open edges of {}, such as {:?}", open.len(), edges.len(), open[0]);
    assert!(rim > 8, "{what}: {rim}");
}

#[test]
fn no_border_gapes_whatever_levels_meet() {
    let tiled = with_scene(|s| surface(s, &options(), &Silent)).unwrap();
    assert_eq!((tiled.tiles(0).count(), tiled.levels()), (25, 4));
    let of = |level: usize, at: &At| tiled.levels[level].tile(at).0;
    for level in 0..tiled.levels() {
        let tiles: Vec<Surface> = tiled.tiles(level).map(|at| of(level, &at)).collect();
        assert_closed(&tiles, &format!("level {level}"));
        // Each by itself is open where another goes on.
        if tiles.len() > 1 {
            let border: usize =
                edges([&tiles[0]]).into_iter().filter(|(e, n)| *n == 1 && !e.iter().all(on_rim)).count();
            assert!(border >= 2, "level {level}: {border}");
        }
    }
    // All ways in which the four squares below the root are drawn in one level or another, their own squares too.
    for choice in 0..81usize {
        let mut drawn = Vec::new();
        for (k, at) in [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().enumerate() {
            let finer = choice / 3usize.pow(k as u32) % 3;
            let level = tiled.levels() - 2 - finer;
            drawn.extend(tiled.tiles(level).filter(|t| t.map(|v| v >> finer) == at).map(|t| of(level, &t)));
        }
        assert_closed(&drawn, &format!("choice {choice}"));
    }
    let counts: Vec<usize> = (0..tiled.levels()).map(|l| tiled.triangles(l)).collect();
    // Of so few vertices coarse tiles keep most.
    assert!(counts.is_sorted_by(|a, b| a >= b) && counts[3] < counts[0] / 2, "{counts:?}");
    assert!(counts[0] < tiled.raw / 3, "{counts:?} of {}", tiled.raw);
}

#[test]
fn the_surface_lies_where_the_truth_is_and_errors_are_what_was_measured() {
    let truth = ground();
    let tiled = with_scene(|s| surface(s, &options(), &Silent)).unwrap();
    let off = |level: usize| -> Vec<f32> {
        let all = tiled.tiles(level).map(|at| tiled.levels[level].tile(&at).0);
        let mut off: Vec<f32> = all
            .flat_map(|s| samples(&s.positions, &s.triangles, usize::MAX))
            .map(|p| (truth.distance)(p).abs())
            .collect();
        off.sort_unstable_by(f32::total_cmp);
        off
    };
    let finest = off(0);
    let at = |q: f32| finest[(q * (finest.len() - 1) as f32) as usize];
    // Measured: 0.23, 0.50 and 0.84 voxels; smoothing rounds edges and what is bent.
    assert!(at(0.5) < 0.3 * VOXEL && at(0.95) < 0.7 * VOXEL && at(1.0) < VOXEL, "{} {} {}", at(0.5), at(0.95), at(1.0));
    let errors: Vec<f32> = (0..tiled.levels())
        .map(|l| tiled.tiles(l).map(|at| tiled.error(l, &at, &tiled.levels[l].tile(&at).0)).fold(0.0, f32::max))
        .collect();
    assert!(errors[0] < 1.5 * VOXEL && errors[3] > errors[0], "{errors:?}");
    // No level is farther from the finest than is said: points of the finest to the coarse one.
    for level in 1..tiled.levels() {
        for at in tiled.tiles(level) {
            let (coarse, fine) = (tiled.levels[level].tile(&at).0, tiled.levels[0].below(&at, level));
            let bvh = Bvh::new(&coarse.positions, &coarse.triangles);
            let said = tiled.error(level, &at, &coarse);
            let found = farthest(&fine.positions, &bvh).0;
            assert!(found < 1.1 * said + errors[0] + 0.5 * VOXEL, "level {level}: {found} for {said}");
        }
    }
}

#[test]
fn samples_do_not_depend_on_the_tile_that_asks() {
    let vertices = |tile: usize| -> BTreeSet<[u32; 3]> {
        with_scene(|s| {
            let dims = [81, 81, 32];
            let lattice = Lattice { origin: s.low, voxel: VOXEL, dims, tile };
            let field = Field::new(s.render, s.cameras, lattice, s.pixel).unwrap();
            let [columns, rows] = lattice.tiles();
            let all = (0..rows).flat_map(|y| (0..columns).map(move |x| [x, y]));
            let raw = all.map(|at| field.tile(at, s.inside, &Silent).unwrap());
            raw.flat_map(|r| r.surface.positions.into_iter().map(bits)).collect()
        })
    };
    let (whole, tiles) = (vertices(80), vertices(16));
    assert!(whole.len() > 5000 && whole == tiles, "{} {}", whole.len(), tiles.len());
}

#[test]
fn colours_go_on_across_borders() {
    let mut all: BTreeMap<(usize, At), Tile> = BTreeMap::new();
    let levels = with_scene(|s| {
        let ground = scenes::Scene { color: Box::new(|p, _| waves(p)), ..ground() };
        let render = |c: &Camera| ground.render(c);
        let s = Scene { render: &render, ..*s };
        let tiled = surface(&s, &options(), &Silent).unwrap();
        let mut take = |level, at, tile| {
            all.insert((level, at), tile);
            Ok(())
        };
        tiled.skinned(&s, &Silent, &mut take).unwrap();
        tiled.levels()
    });
    for level in 0..levels - 1 {
        let mut colors: BTreeMap<[u32; 3], Vec<[f32; 3]>> = BTreeMap::new();
        let mut normals: BTreeMap<[u32; 3], Vec<Vec3>> = BTreeMap::new();
        let mut off_truth = Vec::new();
        for (_, tile) in all.iter().filter(|t| t.0.0 == level) {
            let mut own = BTreeSet::new();
            for ((p, uv), n) in tile.mesh.positions.iter().zip(&tile.mesh.uvs).zip(&tile.mesh.normals) {
                let color = texture_at(&tile.texture, *uv).map(|c| c / 255.0);
                if p.z < 0.04 && n.z > 0.8 {
                    off_truth.push(color.iter().zip(waves(*p)).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max));
                }
                if own.insert(bits(*p)) {
                    colors.entry(bits(*p)).or_default().push(color);
                    normals.entry(bits(*p)).or_default().push(*n);
                }
            }
        }
        let differ = |c: &Vec<[f32; 3]>| {
            let from_first = |b: &[f32; 3]| (0..3).map(|k| (c[0][k] - b[k]).abs()).fold(0.0, f32::max);
            c.iter().map(from_first).fold(0.0, f32::max)
        };
        let shared: Vec<f32> = colors.values().filter(|c| c.len() > 1).map(differ).collect();
        let mean = shared.iter().sum::<f32>() / shared.len() as f32;
        assert!(shared.len() > 20 && mean < 0.02, "level {level}: {mean} at {} vertices", shared.len());
        assert!(normals.values().all(|n| n.iter().all(|m| *m == n[0])), "level {level}");
        off_truth.sort_unstable_by(f32::total_cmp);
        let median = off_truth[off_truth.len() / 2];
        assert!(median < 0.05, "level {level}: {median}");
    }
}

/// Bands that no texel is too wide for.
fn waves(p: Vec3) -> [f32; 3] {
    [0.5 + 0.3 * (9.0 * p.x).sin(), 0.5 + 0.3 * (7.0 * p.y).sin(), 0.4]
}
