// Begin: the next iteration's camera and numbers to where the kernels look for them; last iteration's counts and ranges
// cleared. 256 threads a workgroup, a tile a thread.

@group(0) @binding(0) var<storage, read> state: State;
@group(0) @binding(1) var<storage, read> steps: array<Step>;
@group(0) @binding(2) var<storage, read> cameras: array<View>;
@group(0) @binding(3) var<storage, read_write> now: Step;
@group(0) @binding(4) var<storage, read_write> view: View;
@group(0) @binding(5) var<storage, read_write> chunk: Chunk;
@group(0) @binding(6) var<storage, read_write> counts: array<u32>;
@group(0) @binding(7) var<storage, read_write> ranges: array<vec2<u32>>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < arrayLength(&ranges)) {
        ranges[id.x] = vec2(0u);
    }
    if (id.x == 0u) {
        let at = min(state.iteration, arrayLength(&steps) - 1u);
        var camera = cameras[steps[at].words.z];
        camera.eye.w = f32(steps[at].words.w);
        camera.background.w = f32(steps[at].more_words.z);
        camera.band.z = state.gaussians;
        camera.band.w = state.room;
        now = steps[at];
        view = camera;
        // Nothing to do once halted.
        let count = select(state.gaussians, 0u, state.halted != 0u);
        chunk = Chunk(0u, count, state.stride, 0u);
        for (var i = 0u; i < 7u; i++) {
            counts[i] = 0u;
        }
        counts[7] = count;
    }
}
