// Gradient: as update.wgsl, but the gradients are written and nothing moves. One thread a Gaussian, 256 a workgroup.

@group(0) @binding(8) var<storage, read> core: array<vec4<f32>>;
@group(0) @binding(9) var<storage, read> harmonics: array<vec4<f32>>;
// Planes as core's and harmonics'.
@group(0) @binding(10) var<storage, read_write> core_gradient: array<vec4<f32>>;
@group(0) @binding(11) var<storage, read_write> harmonics_gradient: array<vec4<f32>>;
// ∂L/∂(mean in pixels).
@group(0) @binding(12) var<storage, read_write> mean_gradient: array<vec2<f32>>;

@compute @workgroup_size(256)
fn main(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let up = collect(id.x, lane);
    var shift = vec3(0.0);
    var turn = vec3(0.0);
    if (id.x < chunk.count) {
        let i = id.x;
        let stride = chunk.stride;
        let planes = planes_of(u32(view.eye.w));
        var sh: array<vec4<f32>, 12>;
        for (var j = 0u; j < 12u; j++) {
            sh[j] = vec4(0.0);
            if (j < planes) {
                sh[j] = harmonics[j * stride + i];
            }
        }
        cut(&sh, u32(view.eye.w));
        var g = project_backward(core[i], core[stride + i], core[2u * stride + i].xyz, &sh, up);
        if (!g.sound) {
            g = Gradient();
        }
        shift = g.shift;
        turn = g.turn;
        core_gradient[i] = vec4(g.position, g.opacity);
        core_gradient[stride + i] = g.rotation;
        core_gradient[2u * stride + i] = vec4(g.scale, 0.0);
        mean_gradient[i] = g.mean;
        for (var m = 0u; m < 4u; m++) {
            let b = g.basis[m];
            let v = g.color;
            let at = 3u * m * stride + i;
            harmonics_gradient[at] = vec4(v * b.x, v.x * b.y);
            harmonics_gradient[at + stride] = vec4(v.yz * b.y, v.xy * b.z);
            harmonics_gradient[at + 2u * stride] = vec4(v.z * b.z, v * b.w);
        }
    }
    sum_pose(group.x, lane, shift, turn);
}
