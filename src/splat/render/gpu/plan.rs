//! One picture size and one scene: the lists in GPU memory and the kernels bound to them, in the order they run.

use wgpu::{Buffer, ComputePipeline};

use super::buffers::{PARTS, SPLAT, Scene};
use super::device::Gpu;
use super::kernel::{Binding, Size, Step, compile, group};
use super::sort::{self, First, Radix, Request, Sort};
use crate::splat::Camera;

/// Pixels along a tile's side.
pub const TILE: u32 = 16;
/// As in shaders/blocks.wgsl.
pub const SCAN_BLOCK: u32 = 1024;
pub const RANGE_BLOCK: u32 = 2048;
/// Words of the counts that `plan.wgsl` writes.
pub const COUNTS: u64 = 8;
/// The word of the counts that is not cleared from picture to picture: the scene's Gaussians.
pub const ALL: u64 = 7;

/// A camera as the kernels read it; shaders/view.wgsl.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct View {
    rows: [[f32; 4]; 3],
    eye: [f32; 4],
    lens: [f32; 4],
    limits: [f32; 4],
    background: [f32; 4],
    size: [u32; 4],
    band: [u32; 4],
}

impl View {
    /// `rows` of tiles of the camera's picture, for lists of `room` pairs.
    pub fn new(c: &Camera, background: [f32; 3], rows: [u32; 2], gaussians: u32, room: u32) -> View {
        let (w, h) = (c.width as f32, c.height as f32);
        let (mx, my) = (0.15 * w / c.fx, 0.15 * h / c.fy);
        let t = c.translation;
        View {
            rows: std::array::from_fn(|i| c.rotation.row(i).extend(t[i]).to_array()),
            eye: c.position().extend(3.0).to_array(),
            lens: [c.fx, c.fy, c.cx, c.cy],
            limits: [-c.cx / c.fx - mx, (w - c.cx) / c.fx + mx, -c.cy / c.fy - my, (h - c.cy) / c.fy + my],
            background: [background[0], background[1], background[2], 0.0],
            size: [c.width, c.height, c.width.div_ceil(TILE), c.height.div_ceil(TILE)],
            band: [rows[0], rows[1], gaussians, room],
        }
    }

    /// Shows normals in place of colours.
    pub fn of_normals(self) -> View {
        let [r, g, b, _] = self.background;
        View { background: [r, g, b, 1.0], ..self }
    }
}

impl View {
    /// The camera `c` where this one stands.
    pub fn moved(&self, c: &Camera) -> Camera {
        let row = |i: usize| glam::Vec3::from_slice(&self.rows[i][..3]);
        let rotation = glam::Mat3::from_cols(row(0), row(1), row(2)).transpose();
        let translation = glam::Vec3::from_array(std::array::from_fn(|i| self.rows[i][3]));
        Camera { rotation, translation, ..*c }
    }
}

macro_rules! sources {
    ($($name:literal),*) => { concat!($(include_str!(concat!("../../../../shaders/", $name, ".wgsl"))),*) };
}

/// The compiled kernels.
pub struct Kernels {
    radix: Radix,
    project: ComputePipeline,
    plan: ComputePipeline,
    scan_reduce: ComputePipeline,
    scan_blocks: ComputePipeline,
    ranges: ComputePipeline,
    resolve: ComputePipeline,
    /// Emit and raster, compiled for what they were asked for so far.
    variants: Vec<(Variant, ComputePipeline, ComputePipeline)>,
}

/// What emit and raster are compiled for.
#[derive(Clone, Copy, PartialEq)]
struct Variant {
    parts: usize,
    part: u32,
    depth: bool,
    subgroups: bool,
    training: bool,
}

impl Kernels {
    pub fn new(gpu: &Gpu) -> Kernels {
        Kernels {
            radix: Radix::new(gpu),
            project: compile(
                gpu,
                "project",
                sources!("view", "chunk", "rotation", "geometry", "tiles", "harmonics", "project"),
                &[],
            ),
            plan: compile(gpu, "plan", sources!("view", "blocks", "plan"), &[]),
            scan_reduce: compile(gpu, "scan_reduce", sources!("blocks", "scan_reduce"), &[]),
            scan_blocks: compile(gpu, "scan_blocks", sources!("blocks", "scan_blocks"), &[]),
            ranges: compile(gpu, "ranges", sources!("view", "blocks", "ranges"), &[]),
            resolve: compile(gpu, "resolve", sources!("view", "blocks", "records", "resolve"), &[]),
            variants: Vec::new(),
        }
    }

    fn variant(&mut self, gpu: &Gpu, wanted: Variant) -> (ComputePipeline, ComputePipeline) {
        if let Some((_, emit, raster)) = self.variants.iter().find(|v| v.0 == wanted) {
            return (emit.clone(), raster.clone());
        }
        let parts = [("PARTS", wanted.parts as f64), ("PART", f64::from(wanted.part))];
        let starts = ("STARTS", f64::from(u8::from(wanted.training)));
        let emit =
            compile(gpu, "emit", sources!("view", "tiles", "blocks", "splats", "emit"), &[parts[0], parts[1], starts]);
        let (name, source) = if wanted.subgroups {
            ("raster_subgroup", sources!("view", "splats", "pixels", "finish", "raster_subgroup"))
        } else {
            ("raster_shared", sources!("view", "splats", "pixels", "finish", "raster_shared"))
        };
        let constants = [parts[0], parts[1], ("DEPTH", f64::from(u8::from(wanted.depth)))];
        let raster = compile(gpu, name, source, &constants);
        self.variants.push((wanted, emit.clone(), raster.clone()));
        (emit, raster)
    }
}

/// What a plan is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    pub width: u32,
    pub height: u32,
    /// Room for (tile, Gaussian) pairs.
    pub room: u32,
    /// Tile rows of a band.
    pub band: u32,
    pub depth: bool,
    pub subgroups: bool,
    /// Keeps what the way back needs.
    pub training: bool,
}

/// Lists that the way back needs.
pub struct WayBack {
    /// Tiles of each Gaussian, and the place where the first was emitted.
    pub touched: Buffer,
    pub starts: Buffer,
    /// In the order of the tiles: whose each pair is, and where it was emitted.
    pub gaussians: Buffer,
    pub places: Buffer,
    /// Nine sums a pair, by the place where it was emitted; shaders/records.wgsl.
    pub records: Buffer,
    /// Projected Gaussians.
    pub splats: Vec<Buffer>,
}

/// Floats of a record.
pub const RECORD: u64 = 9;

pub struct Plan {
    pub shape: Shape,
    /// Of the scene it is bound to.
    pub scene: u64,
    pub view: Buffer,
    pub counts: Buffer,
    pub ranges: Buffer,
    pub picture: Buffer,
    pub depths: Buffer,
    pub way_back: Option<WayBack>,
    /// Bytes of all buffers but the scene's own.
    pub bytes: u64,
    project: Vec<Step>,
    plan: Step,
    by_depth: Sort,
    pairs: Vec<Step>,
    by_tile: Sort,
    ends: Vec<Step>,
    raster: Step,
}

impl Plan {
    /// Errors show in [`Gpu::check`].
    pub fn new(gpu: &Gpu, kernels: &mut Kernels, scene: &Scene, shape: Shape) -> Plan {
        use Binding::{Part, Whole};
        let n = u64::from(scene.count);
        let room = u64::from(shape.room);
        let tiles_x = shape.width.div_ceil(TILE);
        let band_tiles = tiles_x * shape.band;
        let pixels = u64::from(shape.width) * u64::from(shape.height);
        let mut bytes = 0;
        let mut buffer = |label: &str, size: u64| {
            bytes += size;
            gpu.buffer(label, size)
        };

        let per_part = u64::from(scene.part);
        let parts: Vec<Buffer> = (0..scene.parts() as u64)
            .map(|p| buffer("splats", SPLAT * per_part.min(n.saturating_sub(p * per_part)).max(1)))
            .collect();
        let [depth_a, depth_b, order_a, order_b, touched] =
            ["depths", "depths", "order", "order", "touched"].map(|l| buffer(l, 4 * n));
        let [tiles_a, tiles_b, ids_a, ids_b] = ["tiles", "tiles", "pairs", "pairs"].map(|l| buffer(l, 4 * room));
        let counts = buffer("counts", 4 * COUNTS);
        let dispatches = buffer("dispatches", 48);
        let block_sums = buffer("block sums", 4 * n.div_ceil(SCAN_BLOCK.into()));
        let table = buffer("radix table", sort::table_bytes(n.max(room)));
        let digits = buffer("radix digits", 1024);
        let ranges = buffer("ranges", 8 * u64::from(band_tiles));
        let picture = buffer("picture", 16 * pixels);
        let depths = buffer("depth", if shape.depth { 8 * pixels } else { 8 });
        let lists = shape.training.then(|| {
            let [owners, gaussians] = ["owners", "pairs"].map(|l| buffer(l, 4 * room));
            (owners, gaussians, buffer("records", 4 * RECORD * room))
        });
        let starts = buffer("starts", if shape.training { 4 * n } else { 4 });
        let view = gpu.uniform(&<View as bytemuck::Zeroable>::zeroed());
        // All Gaussians of the scene: what the first pass of the depth sort looks at.
        gpu.queue.write_buffer(&counts, 4 * ALL, &scene.count.to_le_bytes());

        let step = |kernel: &ComputePipeline, bindings: &[Binding], size: Size| Step {
            kernel: kernel.clone(),
            groups: vec![group(gpu, kernel, 0, bindings)],
            size,
        };
        let project = scene
            .chunks
            .iter()
            .map(|c| {
                let at = u64::from(c.first % scene.part) * SPLAT;
                let splats = Part(&parts[(c.first / scene.part) as usize], at, SPLAT * u64::from(c.count));
                let rest = [&depth_a, &touched, &counts].map(Whole);
                let inputs = [&view, &c.place, &c.core, &c.harmonics].map(Whole);
                let bindings: Vec<_> = inputs.into_iter().chain([splats]).chain(rest).collect();
                step(&kernels.project, &bindings, Size::Direct(c.count.div_ceil(256), 1))
            })
            .collect();
        let plan = step(&kernels.plan, &[&view, &counts, &dispatches].map(Whole), Size::Direct(1, 1));
        let indirect = |i: u64| Size::Indirect(dispatches.clone(), 12 * i);
        let by_depth = kernels.radix.prepare(
            gpu,
            &Request {
                keys: [&depth_a, &depth_b],
                values: [&order_a, &order_b],
                counts: &counts,
                slot: 3,
                size: indirect(0),
                table: &table,
                digits: &digits,
                bits: 31,
                first: Some(First { slot: ALL as u32, size: Size::Direct(scene.count.div_ceil(sort::BLOCK), 1) }),
            },
        );
        let order = &order_a;

        // Past the last tile stands the sentinel.
        let bits = 32 - band_tiles.leading_zeros();
        let sorted = sort::passes(bits) % 2;
        let (tiles, ids) = ([&tiles_a, &tiles_b], [&ids_a, &ids_b]);
        let (sorted_tiles, sorted_ids) = (tiles[sorted], ids[sorted]);
        let variant = Variant {
            parts: parts.len(),
            part: scene.part,
            depth: shape.depth,
            subgroups: shape.subgroups,
            training: shape.training,
        };
        let (emit, raster) = kernels.variant(gpu, variant);
        // Unused parts are bound to the first.
        let splats: Vec<&Buffer> = (0..PARTS).map(|p| parts.get(p).unwrap_or(&parts[0])).collect();
        let with_splats = |kernel: ComputePipeline, bindings: &[Binding], size: Size| {
            let splats: Vec<_> = splats.iter().map(|b| Whole(b)).collect();
            let groups = vec![group(gpu, &kernel, 0, bindings), group(gpu, &kernel, 1, &splats)];
            Step { kernel, groups, size }
        };
        // In training the sort carries places, and whose they are stands aside.
        let owners = lists.as_ref().map_or(&ids_a, |l| &l.0);
        let reduce = [&counts, order, &touched, &block_sums].map(Whole);
        let pairs = vec![
            step(&kernels.scan_reduce, &reduce, indirect(1)),
            step(&kernels.scan_blocks, &[&counts, &block_sums].map(Whole), Size::Direct(1, 1)),
            with_splats(
                emit,
                &[&view, &counts, order, &touched, &block_sums, &tiles_a, owners, &starts].map(Whole),
                indirect(1),
            ),
        ];
        let by_tile = kernels.radix.prepare(
            gpu,
            &Request {
                keys: tiles,
                values: ids,
                counts: &counts,
                slot: 4,
                size: indirect(2),
                table: &table,
                digits: &digits,
                bits,
                first: lists.as_ref().map(|_| First { slot: 4, size: indirect(2) }),
            },
        );
        let mut ends = vec![step(&kernels.ranges, &[&view, &counts, sorted_tiles, &ranges].map(Whole), indirect(3))];
        let mut drawn = sorted_ids;
        if let Some((owners, gaussians, records)) = &lists {
            let bindings = [&view, &counts, sorted_tiles, sorted_ids, owners, gaussians, records].map(Whole);
            ends.push(step(&kernels.resolve, &bindings, indirect(3)));
            drawn = gaussians;
        }
        let bindings = [&view, &ranges, drawn, &picture, &depths].map(Whole);
        let raster = with_splats(raster, &bindings, Size::Direct(tiles_x, shape.band));
        let way_back = lists.map(|(_, gaussians, records)| WayBack {
            touched: touched.clone(),
            starts,
            gaussians,
            places: sorted_ids.clone(),
            records,
            splats: parts.clone(),
        });
        Plan {
            shape,
            scene: scene.id,
            view,
            counts,
            ranges,
            picture,
            depths,
            way_back,
            bytes,
            project,
            plan,
            by_depth,
            pairs,
            by_tile,
            ends,
            raster,
        }
    }

    /// Records the last stage for a picture of so many tiles, at most the shape's.
    pub fn record_raster(&self, pass: &mut wgpu::ComputePass, tiles: (u32, u32)) {
        self.raster.record_sized(pass, tiles);
    }

    /// Records stage `stage` of [`super::STAGES`].
    pub fn record(&self, stage: usize, pass: &mut wgpu::ComputePass) {
        match stage {
            0 => {
                self.project.iter().for_each(|s| s.record(pass));
                self.plan.record(pass);
            }
            1 => self.by_depth.record(pass),
            2 => self.pairs.iter().for_each(|s| s.record(pass)),
            3 => self.by_tile.record(pass),
            4 => self.ends.iter().for_each(|s| s.record(pass)),
            _ => self.raster.record(pass),
        }
    }
}
