// Emit: the (tile, Gaussian) pairs, in depth order. 256 threads a block of 1,024 Gaussians, four each.
//
// A Gaussian gets exactly the room that `project` counted for it: should two compilers round an edge differently, a
// pair too many is dropped and a place too many is filled with a tile past the last. A Gaussian of more than LARGE
// tiles is written by the whole workgroup, row by row of tiles as well.
// With STARTS each Gaussian's first place is kept, for the way back.

const LARGE: u32 = 32u;

override STARTS: bool = false;

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> counts: array<u32>;
@group(0) @binding(2) var<storage, read> order: array<u32>;
@group(0) @binding(3) var<storage, read> touched: array<u32>;
@group(0) @binding(4) var<storage, read> block_sums: array<u32>;
@group(0) @binding(5) var<storage, read_write> pair_tiles: array<u32>;
@group(0) @binding(6) var<storage, read_write> pair_gaussians: array<u32>;
@group(0) @binding(7) var<storage, read_write> starts: array<u32>;

var<workgroup> sums: array<u32, 256>;
// Gaussian, and its first place.
var<workgroup> large: array<vec2<u32>, 1024>;
var<workgroup> large_count: atomic<u32>;

fn past_last() -> u32 {
    return (view.band.y - view.band.x) * view.size.z;
}

fn small(id: u32, start: u32, room: u32) {
    let splat = fetch(id);
    let end = start + room;
    var at = start;
    let rows = tile_rows(splat.place, view);
    for (var row = rows.x; row < rows.y; row++) {
        let span = tile_span(splat.place, splat.form, row, view);
        let base = (row - view.band.x) * view.size.z;
        for (var x = span.x; x < span.y && at < end; x++) {
            pair_tiles[at] = base + x;
            pair_gaussians[at] = id;
            at++;
        }
    }
    for (; at < end; at++) {
        pair_tiles[at] = past_last();
        pair_gaussians[at] = id;
    }
}

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let n = counts[3];
    if (lane == 0u) {
        atomicStore(&large_count, 0u);
    }
    var ids: array<u32, 4>;
    var rooms: array<u32, 4>;
    var sum = 0u;
    for (var i = 0u; i < SCAN_ITEMS; i++) {
        let rank = group.x * SCAN_BLOCK + lane * SCAN_ITEMS + i;
        ids[i] = 0u;
        rooms[i] = 0u;
        if (rank < n) {
            ids[i] = order[rank];
            rooms[i] = touched[ids[i]];
        }
        sum += rooms[i];
    }
    sums[lane] = sum;
    workgroupBarrier();
    for (var reach = 1u; reach < 256u; reach <<= 1u) {
        var add = 0u;
        if (lane >= reach) {
            add = sums[lane - reach];
        }
        workgroupBarrier();
        sums[lane] += add;
        workgroupBarrier();
    }
    var start = block_sums[group.x] + sums[lane] - sum;
    for (var i = 0u; i < SCAN_ITEMS; i++) {
        if (STARTS && rooms[i] > 0u) {
            starts[ids[i]] = start;
        }
        if (rooms[i] > LARGE) {
            large[atomicAdd(&large_count, 1u)] = vec2(ids[i], start);
        } else if (rooms[i] > 0u) {
            small(ids[i], start, rooms[i]);
        }
        start += rooms[i];
    }
    workgroupBarrier();
    let many = atomicLoad(&large_count);
    for (var k = 0u; k < many; k++) {
        let id = large[k].x;
        let first = large[k].y;
        let room = touched[id];
        let splat = fetch(id);
        let rows = tile_rows(splat.place, view);
        var done = 0u;
        for (var block = rows.x; block < rows.y; block += 256u) {
            // Where each of up to 256 rows of tiles begins, then a few threads a row.
            let height = min(rows.y - block, 256u);
            var width = 0u;
            if (lane < height) {
                let span = tile_span(splat.place, splat.form, block + lane, view);
                width = span.y - span.x;
            }
            sums[lane] = width;
            workgroupBarrier();
            for (var reach = 1u; reach < height; reach <<= 1u) {
                var add = 0u;
                if (lane >= reach) {
                    add = sums[lane - reach];
                }
                workgroupBarrier();
                sums[lane] += add;
                workgroupBarrier();
            }
            let share = 256u / height;
            let r = lane / share;
            if (r < height) {
                let span = tile_span(splat.place, splat.form, block + r, view);
                let base = (block + r - view.band.x) * view.size.z;
                let begin = done + sums[r] - (span.y - span.x);
                for (var x = span.x + lane % share; x < span.y; x += share) {
                    let at = begin + x - span.x;
                    if (at < room) {
                        pair_tiles[first + at] = base + x;
                        pair_gaussians[first + at] = id;
                    }
                }
            }
            done += sums[height - 1u];
            workgroupBarrier();
        }
        for (var at = done + lane; at < room; at += 256u) {
            pair_tiles[first + at] = past_last();
            pair_gaussians[first + at] = id;
        }
    }
}
