// End: keeps the books of an iteration and moves its camera. One workgroup of 256 threads.
//
// The camera's step is Adam's on a left-multiplied increment of world→camera, p' = exp(ω)·(p − c) + c + v, c so far before the
// camera as the step says; translations count in units of that depth, of the camera's distance from the origin where it is 0.

// Adam's memory for one camera.
struct Pose {
    // Of translation (xyz, w: steps taken) and rotation; then the second moments.
    shift_m: vec4<f32>,
    turn_m: vec4<f32>,
    shift_v: vec4<f32>,
    turn_v: vec4<f32>,
}

@group(0) @binding(0) var<storage, read_write> state: State;
@group(0) @binding(1) var<uniform> now: Step;
@group(0) @binding(2) var<storage, read> counts: array<u32>;
@group(0) @binding(3) var<storage, read> pose_partials: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> cameras: array<View>;
@group(0) @binding(5) var<storage, read_write> poses: array<Pose>;
@group(0) @binding(6) var<storage, read> corrections: array<vec2<f32>>;

var<workgroup> sums: array<vec3<f32>, 512>;

// The rotation by a rotation vector (Rodrigues), applied to v.
fn turned(by: vec3<f32>, v: vec3<f32>) -> vec3<f32> {
    let angle = length(by);
    if (angle < 1e-12) {
        return v;
    }
    let axis = by / angle;
    return v * cos(angle) + cross(axis, v) * sin(angle) + axis * dot(axis, v) * (1.0 - cos(angle));
}

fn move_camera(shift_gradient: vec3<f32>, turn_gradient: vec3<f32>) {
    let at = now.words.z;
    var camera = cameras[at];
    var pose = poses[at];
    let translation = vec3(camera.row0.w, camera.row1.w, camera.row2.w);
    let c = vec3(0.0, 0.0, now.exposure.z);
    let distance = select(length(translation), c.z, c.z > 0.0);
    let steps = pose.shift_m.w + 1.0;
    let corrected = corrections[min(u32(steps), arrayLength(&corrections) - 1u)];
    let g = shift_gradient * distance;
    let h = turn_gradient - cross(c, shift_gradient);
    let gm = 0.9 * pose.shift_m.xyz + 0.1 * g;
    let gv = 0.999 * pose.shift_v.xyz + 0.001 * g * g;
    let hm = 0.9 * pose.turn_m.xyz + 0.1 * h;
    let hv = 0.999 * pose.turn_v.xyz + 0.001 * h * h;
    poses[at] = Pose(vec4(gm, steps), vec4(hm, 0.0), vec4(gv, 0.0), vec4(hv, 0.0));
    let rate = now.more_rates.z;
    let shift = -rate * distance * gm * corrected.x / (sqrt(gv * corrected.y) + 1e-15);
    let by = -rate * hm * corrected.x / (sqrt(hv * corrected.y) + 1e-15);
    // Columns of the rotation turn; the rows are made orthonormal again, lest many small steps wear them off.
    let x = turned(by, vec3(camera.row0.x, camera.row1.x, camera.row2.x));
    let y = turned(by, vec3(camera.row0.y, camera.row1.y, camera.row2.y));
    let z = turned(by, vec3(camera.row0.z, camera.row1.z, camera.row2.z));
    let r0 = normalize(vec3(x.x, y.x, z.x));
    var r1 = vec3(x.y, y.y, z.y);
    r1 = normalize(r1 - dot(r0, r1) * r0);
    let r2 = cross(r0, r1);
    let t = turned(by, translation - c) + c + shift;
    camera.row0 = vec4(r0, t.x);
    camera.row1 = vec4(r1, t.y);
    camera.row2 = vec4(r2, t.z);
    camera.eye = vec4(-(t.x * r0 + t.y * r1 + t.z * r2), camera.eye.w);
    cameras[at] = camera;
}

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) lane: u32) {
    let live = state.halted == 0u && counts[5] == 0u;
    if (live && now.more_rates.z != 0.0) {
        let groups = (state.gaussians + 255u) / 256u;
        var shift = vec3(0.0);
        var turn = vec3(0.0);
        for (var i = lane; i < groups; i += 256u) {
            shift += pose_partials[2u * i].xyz;
            turn += pose_partials[2u * i + 1u].xyz;
        }
        sums[lane] = shift;
        sums[256u + lane] = turn;
    }
    workgroupBarrier();
    if (lane == 0u) {
        if (live && now.more_rates.z != 0.0) {
            var shift = vec3(0.0);
            var turn = vec3(0.0);
            for (var i = 0u; i < 256u; i++) {
                shift += sums[i];
                turn += sums[256u + i];
            }
            if (finite(dot(shift, vec3(1.0)) + dot(turn, vec3(1.0)))) {
                move_camera(shift, turn);
            }
        }
        state.most_pairs = max(state.most_pairs, counts[6]);
        if (live) {
            state.iteration += 1u;
        } else {
            state.halted = 1u;
        }
    }
}
