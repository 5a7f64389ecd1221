// Shared: the pose's gradient summed over a workgroup, in a fixed order, only where the camera is to move.

@group(0) @binding(7) var<storage, read_write> pose_partials: array<vec4<f32>>;

var<workgroup> moves: array<vec3<f32>, 256>;

fn sum_pose(group: u32, lane: u32, shift: vec3<f32>, turn: vec3<f32>) {
    if (now.more_rates.z == 0.0) {
        return;
    }
    for (var k = 0u; k < 2u; k++) {
        moves[lane] = select(turn, shift, k == 0u);
        workgroupBarrier();
        for (var half = 128u; half > 0u; half >>= 1u) {
            if (lane < half) {
                moves[lane] += moves[lane + half];
            }
            workgroupBarrier();
        }
        if (lane == 0u) {
            pose_partials[2u * group + k] = vec4(moves[0], 0.0);
        }
        workgroupBarrier();
    }
}
