// Refine, last step: the halves of the split ones, each drawn from its parent's Gaussian and 1.6 times smaller. One
// thread a Gaussian, 256 a workgroup.

@group(0) @binding(0) var<uniform> refine: Refine;
@group(0) @binding(1) var<storage, read> sources: array<u32>;
@group(0) @binding(2) var<storage, read_write> core: array<vec4<f32>>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if (i < refine.after && (sources[i] & HALF) != 0u) {
        let s = core[2u * refine.stride + i];
        let q = core[refine.stride + i];
        let r = turn(q * inverseSqrt(dot(q, q)));
        let n = vec3(normals(refine.seed.xy ^ vec2(i, 0u)), normals(refine.seed.xy ^ vec2(i, 1u)).x);
        let offset = r * (exp(s.xyz) * n);
        core[i] += vec4(offset, 0.0);
        core[2u * refine.stride + i] = s - vec4(vec3(0.47000363), 0.0);
    }
}
