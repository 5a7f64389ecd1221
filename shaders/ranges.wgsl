// Ranges: where each tile's pairs begin and end in the sorted list. 256 threads, 2,048 pairs a workgroup.
//
// ranges[tile] = (begin, end); cleared to (0, 0) before, so a tile without pairs is empty.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> counts: array<u32>;
@group(0) @binding(2) var<storage, read> pair_tiles: array<u32>;
// Two words a tile.
@group(0) @binding(3) var<storage, read_write> ranges: array<u32>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let n = counts[4];
    let tiles = (view.band.y - view.band.x) * view.size.z;
    for (var i = 0u; i < RANGE_ITEMS; i++) {
        let at = group.x * RANGE_BLOCK + i * 256u + lane;
        if (at < n) {
            let tile = pair_tiles[at];
            if (tile < tiles) {
                if (at == 0u || pair_tiles[max(at, 1u) - 1u] != tile) {
                    ranges[2u * tile] = at;
                }
                if (at + 1u == n || pair_tiles[min(at + 1u, n - 1u)] != tile) {
                    ranges[2u * tile + 1u] = at + 1u;
                }
            }
        }
    }
}
