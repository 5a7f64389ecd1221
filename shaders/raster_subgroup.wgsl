// Raster with subgroups: a workgroup of 256 threads a tile of 16×16 pixels, one pixel a thread, every subgroup on its
// own block of the tile (8×4 pixels for 32 lanes) and at its own pace.
//
// A subgroup looks at as many of the tile's splats as it has lanes, keeps those whose box meets its block, in order,
// in its own part of workgroup memory, and composites them. No workgroup barrier: a finished subgroup leaves.

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

@compute @workgroup_size(256)
fn main(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(subgroup_id) subgroup: u32,
    @builtin(subgroup_size) lanes: u32,
    @builtin(subgroup_invocation_id) lane: u32,
) {
    let base = subgroup * lanes;
    let corner = vec2(group.x, group.y + view.band.x) * TILE;
    let pixel = corner + morton(base + lane);
    let at = vec2<f32>(pixel) + 0.5;
    // The centres of the block's first and last pixel.
    let low = vec2<f32>(corner + morton(base)) + 0.49;
    let high = vec2<f32>(corner + morton(base + lanes - 1u)) + 0.51;
    let range = ranges[group.y * view.size.z + group.x];
    var p = Pixel(vec3(0.0), 1.0, vec2(0.0), pixel.x < view.size.x && pixel.y < view.size.y);
    for (var start = range.x; start < range.y; start += lanes) {
        var keep = false;
        var splat: Splat;
        if (start + lane < range.y) {
            splat = fetch(pair_gaussians[start + lane]);
            keep = all(splat.place.xy + splat.place.zw >= low) && all(splat.place.xy - splat.place.zw <= high);
        }
        let slot = base + subgroupExclusiveAdd(select(0u, 1u, keep));
        let kept = subgroupAdd(select(0u, 1u, keep));
        if (keep) {
            means[slot] = splat.place.xy;
            forms[slot] = splat.form;
            tints[slot] = splat.tint;
        }
        subgroupBarrier();
        for (var i = base; i < base + kept; i++) {
            blend(&p, at, means[i], forms[i], tints[i]);
        }
        subgroupBarrier();
        if (!subgroupAny(p.open)) {
            break;
        }
    }
    finish(p, pixel);
}
