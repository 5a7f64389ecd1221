// Raster, the way back, with subgroups: a workgroup of THREADS threads a tile of 16×16 pixels, PIXELS pixels a thread,
// every subgroup on its own block of the tile. (THREADS · PIXELS = 256; GROUPS = THREADS / lanes.)
//
// The tile's splats pass through workgroup memory 32 at a time. A subgroup lists those whose box meets its block, sums
// the nine numbers of records.wgsl over its pixels, and leaves them; when all have, the subgroups' sums are added in
// order and written to the pair's own place. Nothing is added atomically: the same bytes every time.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> ranges: array<vec2<u32>>;
@group(0) @binding(2) var<storage, read> pair_gaussians: array<u32>;
@group(0) @binding(3) var<storage, read> places: array<u32>;
// Σ w rgb over black, alpha.
@group(0) @binding(4) var<storage, read> picture: array<vec4<f32>>;
// ∂L/∂(Σ w rgb), ∂L/∂T.
@group(0) @binding(5) var<storage, read> pulls: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read_write> records: array<f32>;

const BATCH: u32 = 32u;

var<workgroup> boxes: array<vec4<f32>, BATCH>;
var<workgroup> forms: array<vec4<f32>, BATCH>;
var<workgroup> tints: array<vec4<f32>, BATCH>;
var<workgroup> targets: array<u32, BATCH>;
// Which of the batch meet each subgroup's block.
var<workgroup> lists: array<u32, GROUPS * BATCH>;
// Which of them it touched, and its sums.
var<workgroup> touched: array<u32, GROUPS>;
var<workgroup> partials: array<f32, GROUPS * BATCH * RECORD>;
var<workgroup> open: atomic<u32>;

// Sums over 32 lanes: eight values in nine exchanges instead of forty. Lane 4k holds value k.
fn transposed_sums(a: vec4<f32>, b: vec4<f32>, lane: u32) -> f32 {
    let high = (lane & 16u) != 0u;
    let four = select(a, b, high) + subgroupShuffleXor(select(b, a, high), 16u);
    let second = (lane & 8u) != 0u;
    let two = select(four.xy, four.zw, second) + subgroupShuffleXor(select(four.zw, four.xy, second), 8u);
    let third = (lane & 4u) != 0u;
    var one = select(two.x, two.y, third) + subgroupShuffleXor(select(two.y, two.x, third), 4u);
    one += subgroupShuffleXor(one, 2u);
    one += subgroupShuffleXor(one, 1u);
    return one;
}

// A splat of the batch and where its sums go.
struct Fetched {
    splat: Splat,
    place: u32,
}

fn ahead(index: u32, at: u32, end: u32) -> Fetched {
    var f: Fetched;
    if (index < BATCH && at < end) {
        f.splat = fetch(pair_gaussians[at]);
        f.place = places[at];
    }
    return f;
}

@compute @workgroup_size(THREADS)
fn main(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(local_invocation_index) index: u32,
    @builtin(subgroup_id) subgroup: u32,
    @builtin(subgroup_size) lanes: u32,
    @builtin(subgroup_invocation_id) lane: u32,
) {
    let base = subgroup * lanes * PIXELS;
    let corner = vec2(group.x, group.y + view.band.x) * TILE;
    // The centres of the block's first and last pixel.
    let low = vec2<f32>(corner + morton(base)) + 0.49;
    let high = vec2<f32>(corner + morton(base + lanes * PIXELS - 1u)) + 0.51;
    var centres: array<vec2<f32>, PIXELS>;
    var walks: array<Walk, PIXELS>;
    for (var k = 0u; k < PIXELS; k++) {
        let pixel = corner + morton(base + k * lanes + lane);
        centres[k] = vec2<f32>(pixel) + 0.5;
        walks[k] = Walk(1.0, 0.0, false, vec3(0.0));
        if (pixel.x < view.size.x && pixel.y < view.size.y) {
            let at = pixel.y * view.size.x + pixel.x;
            let v = pulls[at];
            let drawn = picture[at];
            walks[k] = Walk(1.0, dot(drawn.xyz, v.xyz) + (1.0 - drawn.w) * v.w, true, v.xyz);
        }
    }
    let range = ranges[group.y * view.size.z + group.x];
    var start = range.x;
    var next = ahead(index, start + index, range.y);
    for (; start < range.y; start += BATCH) {
        let count = min(BATCH, range.y - start);
        if (index < BATCH) {
            boxes[index] = next.splat.place;
            forms[index] = next.splat.form;
            tints[index] = next.splat.tint;
            targets[index] = next.place;
        }
        // On its way while this batch is worked on.
        next = ahead(index, start + BATCH + index, range.y);
        if (index == 0u) {
            atomicStore(&open, 0u);
        }
        workgroupBarrier();
        var any_open = false;
        for (var k = 0u; k < PIXELS; k++) {
            any_open = any_open || walks[k].open;
        }
        any_open = subgroupAny(any_open);
        var kept = 0u;
        for (var j = 0u; j < BATCH; j += LANES) {
            let i = j + lane;
            var meets = false;
            if (i < count && any_open) {
                let place = boxes[i];
                meets = all(place.xy + place.zw >= low) && all(place.xy - place.zw <= high);
            }
            let slot = kept + subgroupExclusiveAdd(select(0u, 1u, meets));
            kept += subgroupAdd(select(0u, 1u, meets));
            if (meets) {
                lists[subgroup * BATCH + slot] = i;
            }
        }
        subgroupBarrier();
        var mine = 0u;
        for (var l = 0u; l < kept; l++) {
            let i = lists[subgroup * BATCH + l];
            let place = boxes[i];
            let form = forms[i];
            let tint = tints[i].xyz;
            var first = vec4(0.0);
            var second = vec4(0.0);
            var last = 0.0;
            var hit = false;
            for (var k = 0u; k < PIXELS; k++) {
                let d = centres[k] - place.xy;
                let e = exponent(d, form);
                var p = walks[k];
                if (e >= MIN_LEVEL && p.open) {
                    let s = walk(&p, e, tint);
                    walks[k] = p;
                    hit = true;
                    let gd = s.g * d;
                    first += vec4(s.g, gd, gd.x * d.x);
                    second += vec4(gd.x * d.y, gd.y * d.y, s.w * p.v.xy);
                    last += s.w * p.v.z;
                }
            }
            if (!subgroupAny(hit)) {
                continue;
            }
            mine |= 1u << i;
            let to = (subgroup * BATCH + i) * RECORD;
            if (LANES == 32u) {
                let one = transposed_sums(first, second, lane);
                last = subgroupAdd(last);
                if ((lane & 3u) == 0u) {
                    partials[to + (lane >> 2u)] = one;
                }
                if (lane == 1u) {
                    partials[to + 8u] = last;
                }
            } else {
                first = subgroupAdd(first);
                second = subgroupAdd(second);
                last = subgroupAdd(last);
                if (lane == 0u) {
                    partials[to] = first.x;
                    partials[to + 1u] = first.y;
                    partials[to + 2u] = first.z;
                    partials[to + 3u] = first.w;
                    partials[to + 4u] = second.x;
                    partials[to + 5u] = second.y;
                    partials[to + 6u] = second.z;
                    partials[to + 7u] = second.w;
                    partials[to + 8u] = last;
                }
            }
        }
        if (lane == 0u) {
            touched[subgroup] = mine;
        }
        for (var k = 0u; k < PIXELS; k++) {
            if (walks[k].open) {
                atomicStore(&open, 1u);
            }
        }
        workgroupBarrier();
        for (var j = index; j < count * RECORD; j += THREADS) {
            let i = j / RECORD;
            var sum = 0.0;
            for (var s = 0u; s < GROUPS; s++) {
                if ((touched[s] >> i & 1u) != 0u) {
                    sum += partials[s * BATCH * RECORD + j];
                }
            }
            records[targets[i] * RECORD + j % RECORD] = sum;
        }
        let more = atomicLoad(&open);
        workgroupBarrier();
        if (more == 0u) {
            break;
        }
    }
    // Nothing behind a finished tile is seen.
    for (var i = start + BATCH + index / RECORD; i < range.y && index < THREADS / RECORD * RECORD; i += THREADS / RECORD) {
        records[places[i] * RECORD + index % RECORD] = 0.0;
    }
}
