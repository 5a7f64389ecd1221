//! `--tiles mesh`: the whole scene as textured meshes in tiles.

use glam::{Vec2, Vec3};

use super::Placed;
use super::ground::Ground;
use crate::Result;
use crate::audit::Publication;
use crate::audit::statement::Param;
use crate::export::{Labels, MeshTree};
use crate::mesh::{self, tiles};
use crate::pipeline::scene::ground::Surface;
use crate::pipeline::scene::{Scene, nadir};
use crate::progress::Progress;
use crate::splat::Camera;
use crate::splat::render::Drawers;

/// Of the opaque Gaussians over the ground, so many lie below the top of the meshes; what hangs higher is cut off.
const TOP: f64 = 0.999;
/// Fainter Gaussians do not count for that.
const OPAQUE: f32 = 0.3;

/// What was made, for who is told.
pub struct Tiled {
    pub levels: Vec<Level>,
    /// Metres: distance of samples, how far views disagree, edge of a tile of the finest level.
    pub voxel: f64,
    pub noise: f64,
    pub side: f64,
    /// Triangles before simplification.
    pub raw: usize,
    pub bytes: u64,
}

/// A level, finest first.
#[derive(Clone, Copy, Default)]
pub struct Level {
    pub tiles: usize,
    pub triangles: usize,
    /// Metres: largest distance from the surface before simplification, widest texel.
    pub error: f64,
    pub texel: f64,
}

/// Puts `tiles3d-mesh` into the publication. `voxel`: metres.
///
/// # Errors
/// Usage where there is no ground to speak of; what the writer and the publication refuse.
pub fn publish(
    done: &Scene,
    ground: &Ground,
    placed: &Placed,
    labels: &Labels,
    publication: &mut Publication,
    voxel: Option<f64>,
    progress: &dyn Progress,
) -> Result<Tiled> {
    let surface = ground.surface(done, &ground.is_ground)?;
    let scale = placed.registration.to_enu.scale;
    let inside = |p: Vec2| surface.holds(p);
    let seen = nadir::as_seen(&done.gaussians, &ground.cameras).filtered(|i| i < ground.near);
    let [low, high] = heights(done, &surface, ground);
    let [from, to] = surface.bounds();
    let margin = 8.0 * surface.cell;
    let drawers = Drawers::new(&seen);
    let render = |camera: &Camera| mesh::View::drawn(&drawers, camera, [0.0; 3]);
    let scene = tiles::Scene {
        render: &render,
        cameras: &ground.cameras,
        inside: &inside,
        low: (from + surface.band - surface.cell).extend(low - margin),
        high: (to - surface.band + surface.cell).extend(high + 2.0 * surface.cell),
        pixel: surface.pixel,
    };
    let options = tiles::Options { voxel: voxel.map(|v| (v / scale) as f32), ..tiles::Options::default() };
    let all = tiles::surface(&scene, &options, progress)?;
    let to_metres = |p: Vec3| ((p - placed.base).as_dvec3() * f64::from(placed.scale)).to_array();
    let mut tree = MeshTree::new(&placed.placement, labels, &to_metres);
    let mut levels = vec![Level::default(); all.levels()];
    let mut bytes = 0;
    all.skinned(&scene, progress, &mut |level, at, tile| {
        let file = tree.add(level, at, &tile, scale)?;
        let l = &mut levels[level];
        l.tiles += 1;
        l.triangles += tile.mesh.triangles.len();
        l.error = l.error.max(f64::from(tile.error) * scale);
        l.texel = l.texel.max(f64::from(tile.texel) * scale);
        bytes += file.bytes.len() as u64;
        publication.add(&file.path, &file.bytes, file.media_type, "mesh")
    })?;
    let tileset = tree.tileset()?;
    publication.add(&tileset.path, &tileset.bytes, tileset.media_type, "mesh")?;
    let metres = |v: f32| f64::from(v) * scale;
    Ok(Tiled {
        levels,
        voxel: metres(all.voxel),
        noise: metres(all.noise),
        side: metres(all.side),
        raw: all.raw,
        bytes: bytes + tileset.bytes.len() as u64,
    })
}

/// Lowest ground and highest thing inside the outline. What hangs above most cameras is taken for air.
fn heights(done: &Scene, surface: &Surface, ground: &Ground) -> [f32; 2] {
    let g = &done.gaussians;
    let logit = (OPAQUE / (1.0 - OPAQUE)).ln();
    let ceiling = ground.ceiling();
    let opaque = (0..ground.near).filter(|i| g.logit_opacities[*i] > logit).map(|i| g.positions[i]);
    let mut z: Vec<f32> = opaque.filter(|p| p.z < ceiling && surface.holds(p.truncate())).map(|p| p.z).collect();
    z.sort_unstable_by(f32::total_cmp);
    let ground = surface.heights();
    let top = z.get((TOP * z.len() as f64) as usize).copied().unwrap_or(ground[1]);
    [ground[0], top.max(ground[1])]
}

impl Tiled {
    /// For a person.
    pub fn words(&self) -> String {
        let of = |l: &Level| format!("{} tiles of {} triangles (to {:.2} m)", l.tiles, l.triangles, l.error);
        let levels: Vec<String> = self.levels.iter().map(of).collect();
        format!(
            "{}: sampled every {:.3} m, views disagree by {:.3} m; {} triangles made, {}; {:.1} MB",
            crate::export::MESH_TREE,
            self.voxel,
            self.noise,
            self.raw,
            levels.join(", "),
            self.bytes as f64 / 1e6
        )
    }

    /// For the record.
    pub fn params(&self) -> Vec<(String, Param)> {
        let text = |v: String| Param::Text(v);
        let finest = self.levels.first().copied().unwrap_or_default();
        vec![
            ("mesh_sample_m".into(), text(format!("{:.4}", self.voxel))),
            ("mesh_views_disagree_m".into(), text(format!("{:.4}", self.noise))),
            ("mesh_tile_m".into(), text(format!("{:.3}", self.side))),
            ("mesh_levels".into(), Param::Int(self.levels.len() as i64)),
            ("mesh_tiles".into(), Param::Int(self.levels.iter().map(|l| l.tiles as i64).sum())),
            ("mesh_triangles".into(), Param::Int(finest.triangles as i64)),
            ("mesh_error_m".into(), text(format!("{:.4}", finest.error))),
        ]
    }

    /// For programs.
    pub fn json(&self) -> serde_json::Value {
        let level = |l: &Level| serde_json::json!({ "tiles": l.tiles, "triangles": l.triangles, "error_m": l.error, "texel_m": l.texel });
        serde_json::json!({
            "sample_m": self.voxel, "views_disagree_m": self.noise, "tile_m": self.side, "triangles_made": self.raw,
            "bytes": self.bytes, "levels": self.levels.iter().map(level).collect::<Vec<_>>(),
        })
    }
}
