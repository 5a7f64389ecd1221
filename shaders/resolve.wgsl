// Resolve: whose each sorted pair is. 256 threads, 2,048 pairs a workgroup.
//
// The tile sort carries the place where a pair was emitted, so that its gradient can be left there, beside those of the
// same Gaussian. A pair past the last tile, which no tile will look at, has none.

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> counts: array<u32>;
@group(0) @binding(2) var<storage, read> pair_tiles: array<u32>;
@group(0) @binding(3) var<storage, read> places: array<u32>;
// By place.
@group(0) @binding(4) var<storage, read> owners: array<u32>;
@group(0) @binding(5) var<storage, read_write> pair_gaussians: array<u32>;
@group(0) @binding(6) var<storage, read_write> records: array<f32>;

@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let n = counts[4];
    let tiles = (view.band.y - view.band.x) * view.size.z;
    for (var i = 0u; i < RANGE_ITEMS; i++) {
        let at = group.x * RANGE_BLOCK + i * 256u + lane;
        if (at < n) {
            let place = places[at];
            pair_gaussians[at] = owners[place];
            if (pair_tiles[at] >= tiles) {
                for (var k = 0u; k < RECORD; k++) {
                    records[place * RECORD + k] = 0.0;
                }
            }
        }
    }
}
