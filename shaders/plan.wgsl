// Plan: one thread. From what `project` counted, the sizes and indirect dispatches of everything after it.
//
// Where the pairs do not fit, nothing is drawn and `overflow` says so: the caller grows the lists and draws again.

struct Counts {
    seen: u32,
    pairs_low: u32,
    pairs_high: u32,
    // Gaussians and pairs to work on: 0 on overflow.
    gaussians: u32,
    pairs: u32,
    overflow: u32,
    // Pairs wanted, saturated.
    wanted: u32,
    // Gaussians in the scene; the caller's.
    all: u32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read_write> counts: Counts;
// Workgroups (x, y, z) of: radix over Gaussians, scan over Gaussians, radix over pairs, ranges.
@group(0) @binding(2) var<storage, read_write> dispatches: array<u32, 12>;

fn groups(n: u32, block: u32) -> u32 {
    return (n + block - 1u) / block;
}

@compute @workgroup_size(1)
fn main() {
    let high = counts.pairs_high + (counts.pairs_low >> 8u);
    var wanted = 0xffffffffu;
    if (high < 0x1000000u) {
        wanted = (high << 8u) | (counts.pairs_low & 255u);
    }
    let fits = wanted <= view.band.w;
    let n = select(0u, counts.seen, fits);
    let pairs = select(0u, wanted, fits);
    counts.gaussians = n;
    counts.pairs = pairs;
    counts.overflow = select(1u, 0u, fits);
    counts.wanted = wanted;
    for (var i = 0u; i < 12u; i++) {
        dispatches[i] = 1u;
    }
    dispatches[0] = groups(n, RADIX_BLOCK);
    dispatches[3] = groups(n, SCAN_BLOCK);
    dispatches[6] = groups(pairs, RADIX_BLOCK);
    dispatches[9] = groups(pairs, RANGE_BLOCK);
}
