// Refine, second step: how many grow, and the sizes of what follows. One thread.

@group(0) @binding(0) var<uniform> refine: Refine;
@group(0) @binding(1) var<storage, read_write> counts: array<u32>;
// Items to count in word 3, Gaussians that grow in word 4.
@group(0) @binding(2) var<storage, read_write> items: array<u32>;
// Workgroups of: radix over candidates, Gaussians that grow, items.
@group(0) @binding(3) var<storage, read_write> dispatches: array<u32>;

@compute @workgroup_size(1)
fn main() {
    let candidates = counts[0];
    let grown = min(candidates, refine.most);
    counts[3] = candidates;
    items[3] = refine.gaussians + grown;
    items[4] = grown;
    for (var i = 0u; i < 9u; i++) {
        dispatches[i] = 1u;
    }
    dispatches[0] = (candidates + RADIX_BLOCK - 1u) / RADIX_BLOCK;
    dispatches[3] = (grown + 255u) / 256u;
    dispatches[6] = (refine.gaussians + grown + SCAN_BLOCK - 1u) / SCAN_BLOCK;
}
