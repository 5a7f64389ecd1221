// Raster, the way back, without subgroups: a workgroup of 256 threads a tile of 16×16 pixels, one pixel a thread.
//
// The tile's splats pass through workgroup memory 4 at a time. Every pixel leaves its g and w for each of them (see
// records.wgsl and pull.wgsl); then 16 threads a splat and number sum those of 16 pixels each, in order, and one adds
// the 16.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> ranges: array<vec2<u32>>;
@group(0) @binding(2) var<storage, read> pair_gaussians: array<u32>;
@group(0) @binding(3) var<storage, read> places: array<u32>;
// Σ w rgb over black, alpha.
@group(0) @binding(4) var<storage, read> picture: array<vec4<f32>>;
// ∂L/∂(Σ w rgb), ∂L/∂T.
@group(0) @binding(5) var<storage, read> pulls: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read_write> records: array<f32>;

const BATCH: u32 = 4u;

var<workgroup> means: array<vec2<f32>, BATCH>;
var<workgroup> forms: array<vec4<f32>, BATCH>;
var<workgroup> tints: array<vec4<f32>, BATCH>;
var<workgroup> shares: array<vec2<f32>, 1024>;
var<workgroup> partials: array<f32, 576>;
var<workgroup> open: atomic<u32>;

// Number k of a record, of one pixel's share.
fn number(k: u32, share: vec2<f32>, d: vec2<f32>, v: vec3<f32>) -> f32 {
    switch (k) {
        case 0u: { return share.x; }
        case 1u: { return share.x * d.x; }
        case 2u: { return share.x * d.y; }
        case 3u: { return share.x * d.x * d.x; }
        case 4u: { return share.x * d.x * d.y; }
        case 5u: { return share.x * d.y * d.y; }
        case 6u: { return share.y * v.x; }
        case 7u: { return share.y * v.y; }
        default: { return share.y * v.z; }
    }
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let corner = vec2(group.x, group.y + view.band.x) * TILE;
    let pixel = corner + vec2(lane % TILE, lane / TILE);
    let centre = vec2<f32>(pixel) + 0.5;
    var p = Walk(1.0, 0.0, false, vec3(0.0));
    if (pixel.x < view.size.x && pixel.y < view.size.y) {
        let at = pixel.y * view.size.x + pixel.x;
        let v = pulls[at];
        let drawn = picture[at];
        p = Walk(1.0, dot(drawn.xyz, v.xyz) + (1.0 - drawn.w) * v.w, true, v.xyz);
    }
    let range = ranges[group.y * view.size.z + group.x];
    var start = range.x;
    for (; start < range.y; start += BATCH) {
        let count = min(BATCH, range.y - start);
        if (lane < count) {
            let splat = fetch(pair_gaussians[start + lane]);
            means[lane] = splat.place.xy;
            forms[lane] = splat.form;
            tints[lane] = splat.tint;
        }
        if (lane == 0u) {
            atomicStore(&open, 0u);
        }
        workgroupBarrier();
        for (var i = 0u; i < count; i++) {
            let e = exponent(centre - means[i], forms[i]);
            var s = Share(0.0, 0.0);
            if (e >= MIN_LEVEL && p.open) {
                s = walk(&p, e, tints[i].xyz);
            }
            shares[i * 256u + lane] = vec2(s.g, s.w);
        }
        if (p.open) {
            atomicStore(&open, 1u);
        }
        workgroupBarrier();
        for (var j = lane; j < count * RECORD * 16u; j += 256u) {
            let i = j / (RECORD * 16u);
            let k = j / 16u % RECORD;
            let row = j % 16u;
            var sum = 0.0;
            for (var x = 0u; x < TILE; x++) {
                let at = corner + vec2(x, row);
                let share = shares[i * 256u + row * TILE + x];
                if (share.x != 0.0 || share.y != 0.0) {
                    sum += number(k, share, vec2<f32>(at) + 0.5 - means[i], pulls[at.y * view.size.x + at.x].xyz);
                }
            }
            partials[j] = sum;
        }
        workgroupBarrier();
        if (lane < count * RECORD) {
            var sum = 0.0;
            for (var row = 0u; row < 16u; row++) {
                sum += partials[lane * 16u + row];
            }
            records[places[start + lane / RECORD] * RECORD + lane % RECORD] = sum;
        }
        let more = atomicLoad(&open);
        workgroupBarrier();
        if (more == 0u) {
            break;
        }
    }
    // Nothing behind a finished tile is seen.
    for (var i = start + BATCH + lane / RECORD; i < range.y && lane < 252u; i += 28u) {
        records[places[i] * RECORD + lane % RECORD] = 0.0;
    }
}
