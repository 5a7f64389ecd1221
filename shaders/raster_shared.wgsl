// Raster without subgroups: a workgroup of 256 threads a tile of 16×16 pixels, one pixel a thread; the tile's splats
// pass through workgroup memory 256 at a time.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> ranges: array<vec2<u32>>;
@group(0) @binding(2) var<storage, read> pair_gaussians: array<u32>;
// Composited colour and alpha, rows from the top.
@group(0) @binding(3) var<storage, read_write> picture: array<vec4<f32>>;
// Expected and median depth.
@group(0) @binding(4) var<storage, read_write> depths: array<vec2<f32>>;

var<workgroup> means: array<vec2<f32>, 256>;
var<workgroup> forms: array<vec4<f32>, 256>;
var<workgroup> tints: array<vec4<f32>, 256>;
var<workgroup> open: atomic<u32>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let pixel = vec2(group.x, group.y + view.band.x) * TILE + morton(lane);
    let at = vec2<f32>(pixel) + 0.5;
    let range = ranges[group.y * view.size.z + group.x];
    var p = Pixel(vec3(0.0), 1.0, vec2(0.0), pixel.x < view.size.x && pixel.y < view.size.y);
    for (var start = range.x; start < range.y; start += 256u) {
        if (lane == 0u) {
            atomicStore(&open, 0u);
        }
        if (start + lane < range.y) {
            let splat = fetch(pair_gaussians[start + lane]);
            means[lane] = splat.place.xy;
            forms[lane] = splat.form;
            tints[lane] = splat.tint;
        }
        workgroupBarrier();
        let count = min(256u, range.y - start);
        for (var i = 0u; i < count && p.open; i++) {
            blend(&p, at, means[i], forms[i], tints[i]);
        }
        if (p.open) {
            atomicStore(&open, 1u);
        }
        workgroupBarrier();
        let more = atomicLoad(&open);
        workgroupBarrier();
        if (more == 0u) {
            break;
        }
    }
    finish(p, pixel);
}
