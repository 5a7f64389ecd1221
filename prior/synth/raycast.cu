// Ray-casts scenes of convex primitives with sun, shadow, sky, ground and backdrop.
//
// Threads: one a pixel, 16 x 16 blocks, blockIdx.z = view. Dynamic shared memory: the view's primitives,
// prims_per_scene * 32 floats. Rows of primitives, cameras and environments: see layout.py.
// Compiled as one text with columns.cuh, shapes.cuh and surfaces.cuh before it (raycast.py).
//
// Inputs:  prims [S, P, 32], counts [S], scene_of_view [V], cameras [V, 20], environments [S, 32].
// Outputs: rgb [V, 3, H, W] (sRGB by a 1/2.2 power; views of the subject alone are premultiplied in linear light),
//          alpha [V, H, W] (coverage by the subject), depth [V, H, W] (camera z; 0 = nothing there).

struct Scene {
    const float* prims;
    int count;
    bool subject_only;
};

// Nearest primitive on the ray, or -1.
__device__ int nearest(const Scene& scene, const float* o, const float* d, float& t, float* n) {
    int which = -1;
    t = 1e8f;
    for (int i = 0; i < scene.count; i++) {
        const float* q = scene.prims + i * ROW;
        if (scene.subject_only && q[SUBJECT] < .5f) continue;
        float s, m[3];
        if (!hit(q, o, d, 1e-3f, t, s, m)) continue;
        t = s;
        which = i;
        n[0] = m[0];
        n[1] = m[1];
        n[2] = m[2];
    }
    return which;
}

__device__ bool blocked(const Scene& scene, const float* o, const float* d, float tmax) {
    for (int i = 0; i < scene.count; i++) {
        const float* q = scene.prims + i * ROW;
        if (scene.subject_only && q[SUBJECT] < .5f) continue;
        float s, m[3];
        if (hit(q, o, d, 2e-3f, tmax, s, m)) return true;
    }
    return false;
}

// Sunlight with shadow and a Blinn-Phong highlight, and ambient light with one occlusion ray.
__device__ void shade(const Scene& scene, const float* E, const float* o, const float* d, float t, const float* N,
                      float gloss, float shininess, float* colour) {
    float sun[3] = {E[SUN], E[SUN + 1], E[SUN + 2]}, p[3];
    for (int i = 0; i < 3; i++) p[i] = o[i] + t * d[i] + N[i] * 2e-3f;
    float facing = dot(N, sun), lit = 0;
    if (facing > 0) lit = blocked(scene, p, sun, 1e8f) ? 0 : 1;
    float up[3] = {N[0] * .7f, N[1] * .7f, N[2] * .7f + .7f};
    float open = blocked(scene, p, up, .9f) ? .55f : 1;
    float halfway[3], length2 = 0;
    for (int i = 0; i < 3; i++) {
        halfway[i] = sun[i] - d[i];
        length2 += halfway[i] * halfway[i];
    }
    float highlight = gloss * powf(fmaxf(0.f, dot(N, halfway) * rsqrtf(length2)), shininess) * lit;
    float ambient = E[AMBIENT] * open * (.7f + .3f * N[2]);
    for (int i = 0; i < 3; i++) {
        float light = E[SUNLIGHT + i] * fmaxf(0.f, facing) * lit + ambient * (.6f + .4f * E[ZENITH + i]);
        colour[i] = colour[i] * light + highlight * E[SUNLIGHT + i];
    }
}

struct Sample {
    float colour[3];
    float z;  // camera z of what was hit
    bool subject, sky;
};

// Follow one ray from o in the unit direction d; `depth_row` is the camera's viewing direction.
__device__ Sample trace(const Scene& scene, const float* E, const float* o, const float* d, const float* depth_row) {
    Sample out = {{0, 0, 0}, 0, false, false};
    float t, n[3] = {0, 0, 1}, N[3] = {0, 0, 1}, gloss = 0, shininess = 10;
    int which = nearest(scene, o, d, t, n);
    if (which >= 0) {
        const float* q = scene.prims + which * ROW;
        const float* R = q + ROTATION;
        for (int i = 0; i < 3; i++) N[i] = R[i] * n[0] + R[3 + i] * n[1] + R[6 + i] * n[2];
        float scale = rsqrtf(dot(N, N));
        for (int i = 0; i < 3; i++) N[i] *= scale;
        float p[3] = {o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]};
        paint(q, p, out.colour);
        out.subject = q[SUBJECT] > .5f;
        gloss = q[GLOSS];
        shininess = q[SHININESS];
    } else if (scene.subject_only) {
        out.sky = true;
    } else {
        out.sky = !surroundings(E, o, d, t, N, out.colour);
    }
    if (out.sky) return out;
    shade(scene, E, o, d, t, N, gloss, shininess, out.colour);
    out.z = t * dot(depth_row, d);
    return out;
}

extern "C" __global__ void cast(const float* prims, const int* counts, const int* scene_of_view, const float* cameras,
                                const float* environments, float* rgb, float* alpha, float* depth, int height,
                                int width, int prims_per_scene, int supersample) {
    extern __shared__ float shared_prims[];
    int view = blockIdx.z, index = scene_of_view[view], count = counts[index];
    const float* source = prims + (size_t)index * prims_per_scene * ROW;
    for (int i = threadIdx.y * blockDim.x + threadIdx.x; i < count * ROW; i += blockDim.x * blockDim.y)
        shared_prims[i] = source[i];
    __syncthreads();
    int px = blockIdx.x * blockDim.x + threadIdx.x, py = blockIdx.y * blockDim.y + threadIdx.y;
    if (px >= width || py >= height) return;

    const float* K = cameras + view * CAMERA_ROW;  // rotation 0:9, translation 9:12, fx, fy, cx, cy, subject only
    const float* E = environments + index * ENVIRONMENT_ROW;
    Scene scene = {shared_prims, count, K[16] > .5f};
    float origin[3];
    for (int i = 0; i < 3; i++) origin[i] = -(K[i] * K[9] + K[3 + i] * K[10] + K[6 + i] * K[11]);

    size_t pixel = ((size_t)view * height + py) * width + px;
    float sum[3] = {0, 0, 0}, covered = 0, subject_z = 1e9f;
    for (int s = 0; s < supersample * supersample; s++) {
        float ux = (px + ((s % supersample) + .5f) / supersample - K[14]) / K[12];
        float uy = (py + ((s / supersample) + .5f) / supersample - K[15]) / K[13];
        float d[3];
        for (int i = 0; i < 3; i++) d[i] = K[i] * ux + K[3 + i] * uy + K[6 + i];
        float scale = rsqrtf(dot(d, d));
        for (int i = 0; i < 3; i++) d[i] *= scale;
        Sample sample = trace(scene, E, origin, d, K + 6);
        if (sample.subject) {
            covered += 1;
            subject_z = fminf(subject_z, sample.z);
        }
        if (!scene.subject_only || sample.subject)
            for (int i = 0; i < 3; i++) sum[i] += sample.colour[i];
        // Where the subject is not, the first sample gives the depth of what is.
        if (!sample.subject && !scene.subject_only && !sample.sky && s == 0) depth[pixel] = sample.z;
    }
    float share = 1.f / (supersample * supersample);
    for (int i = 0; i < 3; i++)
        rgb[(((size_t)view * 3 + i) * height + py) * width + px] = powf(fminf(1.f, fmaxf(0.f, sum[i] * share)), .4545f);
    alpha[pixel] = covered * share;
    if (subject_z < 1e8f) depth[pixel] = subject_z;
}
