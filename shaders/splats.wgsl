// Shared: the projected Gaussians as the later kernels read them. One binding may hold too few (128 MiB on some
// adapters), so they are split into up to eight parts of PART Gaussians; with one part the choice folds away.

override PARTS: u32 = 1u;
override PART: u32 = 0xffffffffu;

@group(1) @binding(0) var<storage, read> splats0: array<Splat>;
@group(1) @binding(1) var<storage, read> splats1: array<Splat>;
@group(1) @binding(2) var<storage, read> splats2: array<Splat>;
@group(1) @binding(3) var<storage, read> splats3: array<Splat>;
@group(1) @binding(4) var<storage, read> splats4: array<Splat>;
@group(1) @binding(5) var<storage, read> splats5: array<Splat>;
@group(1) @binding(6) var<storage, read> splats6: array<Splat>;
@group(1) @binding(7) var<storage, read> splats7: array<Splat>;

fn fetch(id: u32) -> Splat {
    if (PARTS == 1u) {
        return splats0[id];
    }
    let at = id % PART;
    switch (id / PART) {
        case 0u: { return splats0[at]; }
        case 1u: { return splats1[at]; }
        case 2u: { return splats2[at]; }
        case 3u: { return splats3[at]; }
        case 4u: { return splats4[at]; }
        case 5u: { return splats5[at]; }
        case 6u: { return splats6[at]; }
        default: { return splats7[at]; }
    }
}
