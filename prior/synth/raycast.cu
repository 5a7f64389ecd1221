// Ray-casts scenes of convex primitives with sun, shadow, sky, ground and backdrop.
//
// Threads: one a pixel, 16 x 16 blocks, blockIdx.z = view. Dynamic shared memory: a sphere
// about each of the view's primitives and a bit set of those before the block, prims_per_scene * 5 floats.
// Rows of primitives, cameras and environments: see layout.py.
// Compiled as one text with columns.cuh, surfaces.cuh and shapes.cuh before it (raycast.py).
//
// Inputs:  prims [S, P, 36], counts [S], scene_of_view [V], cameras [V, 20], environments [S, 40].
// Outputs: rgb [V, 3, H, W] (sRGB by a 1/2.2 power; views of the subject alone are premultiplied in linear light),
//          alpha [V, H, W] (coverage by the subject), depth [V, H, W] (camera z; 0 = nothing there),
//          shade [V, H, W] (share of the pixel that is not the subject and lies in a shadow).

struct Scene {
    const float* prims;
    const float* spheres;  // centre and squared radius about every primitive
    const unsigned* seen;  // bit set of the primitives that this block's camera rays may meet
    int count;
    bool subject_only;
};

// Nearest primitive on a camera ray, or -1.
__device__ int nearest(const Scene& scene, const float* o, const float* d, float& t, float* n) {
    int which = -1;
    t = 1e8f;
    for (int word = 0; word * 32 < scene.count; word++) {
        for (unsigned left = scene.seen[word]; left; left &= left - 1) {
            int i = word * 32 + __ffs(left) - 1;
            if (!may_hit(scene.spheres + 4 * i, o, d, t)) continue;
            float s, m[3];
            if (!hit(scene.prims + i * ROW, o, d, 1e-3f, t, s, m)) continue;
            t = s;
            which = i;
            n[0] = m[0];
            n[1] = m[1];
            n[2] = m[2];
        }
    }
    return which;
}

__device__ bool blocked(const Scene& scene, const float* o, const float* d, float tmax) {
    for (int i = 0; i < scene.count; i++) {
        if (!may_hit(scene.spheres + 4 * i, o, d, tmax)) continue;
        const float* q = scene.prims + i * ROW;
        if (scene.subject_only && q[SUBJECT] < .5f) continue;
        float s, m[3];
        if (hit(q, o, d, 2e-3f, tmax, s, m)) return true;
    }
    return false;
}

// Light that comes from the direction d without any texture: sky above, ground below.
__device__ float coming(const float* E, float up, int channel) {
    float above = fmaxf(0.f, up), sky = E[HORIZON + channel] + (E[ZENITH + channel] - E[HORIZON + channel]) * above;
    float ground = E[GROUND_A + channel] * .6f, k = fminf(1.f, fmaxf(0.f, .5f + 3 * up));
    return ground + (sky - ground) * k;
}

// Share of the sunlight that what stands outside the picture lets through to the point p: a building's roofline, the crown
// of a tree, posts. The casters lie in a plane across the sun's direction.
__device__ float let_through(const float* E, const float* sun, const float* p) {
    int kind = (int)(E[CASTER] + .5f), s = (int)E[SEED];
    if (kind == NO_CASTER) return 1;
    float level = rsqrtf(sun[0] * sun[0] + sun[1] * sun[1] + 1e-6f);
    float aside[3] = {-sun[1] * level, sun[0] * level, 0};
    float above[3] = {-sun[2] * aside[1], sun[2] * aside[0], sun[0] * aside[1] - sun[1] * aside[0]};
    float u = dot(p, aside), v = dot(p, above), f = E[CASTER_FREQUENCY], edge = -1.1f + 1.5f * hash01(s, 3, 7);
    if (kind == ROOFLINE) {
        float place = u * f * .35f;
        float ridge = .35f * hash01((int)floorf(place), s, 1) + (hash01(s, 5, 2) > .5f ? .5f * fabsf(part(place) - .5f) : 0);
        return v < edge + ridge ? 0 : 1;
    }
    if (kind == POSTS) return part(u * f * .6f) < .25f || fabsf(v - edge) < .06f ? 0 : 1;
    float gap = fractal_noise(u * f + E[SEED], v * f, 3) - .33f - .3f * hash01(s, 4, 8);
    return fminf(1.f, fmaxf(0.f, gap * 14));
}

// Sunlight with shadow and a Blinn-Phong highlight, light from sky and ground with two occlusion rays, a high one and a short
// one that keeps low, and what a glossy surface mirrors. `turn` 0..3 picks a part of the sun and of the sky, so that a
// pixel's samples soften both. Returns whether the point lies in a shadow.
__device__ bool shade(const Scene& scene, const float* E, const float* o, const float* d, float t, const float* N,
                      float gloss, float shininess, int turn, float* colour) {
    float away_x = (turn & 1) ? .7f : -.7f, away_y = (turn & 2) ? .7f : -.7f;
    float sun[3] = {E[SUN] + E[SUN_SIZE] * away_x, E[SUN + 1] + E[SUN_SIZE] * away_y, E[SUN + 2]}, p[3];
    float longer = rsqrtf(dot(sun, sun));
    for (int i = 0; i < 3; i++) {
        sun[i] *= longer;
        p[i] = o[i] + t * d[i] + N[i] * 2e-3f;
    }
    float facing = dot(N, sun), lit = 0;
    bool sunny = E[SUNLIGHT] + E[SUNLIGHT + 1] > .01f;
    if (facing > 0 && sunny) lit = blocked(scene, p, sun, 1e8f) ? 0 : 1;
    if (lit > 0 && !scene.subject_only) lit = let_through(E, sun, p);
    float up[3] = {N[0] + .55f * away_x, N[1] + .55f * away_y, N[2] + .5f};
    float low[3] = {N[0] + .9f * (away_x - away_y), N[1] + .9f * (away_x + away_y), N[2] + .1f};
    longer = rsqrtf(dot(up, up) + 1e-6f);
    float shorter = rsqrtf(dot(low, low) + 1e-6f);
    for (int i = 0; i < 3; i++) {
        up[i] *= longer;
        low[i] *= shorter;
    }
    float open = blocked(scene, p, up, .9f) ? E[LEFT_OPEN] : 1;
    if (blocked(scene, p, low, .3f)) open *= .5f + .5f * E[LEFT_OPEN];
    float halfway[3], mirror[3], length2 = 0, against = dot(N, d);
    for (int i = 0; i < 3; i++) {
        halfway[i] = sun[i] - d[i];
        length2 += halfway[i] * halfway[i];
        mirror[i] = d[i] - 2 * against * N[i];
    }
    float highlight = gloss * powf(fmaxf(0.f, dot(N, halfway) * rsqrtf(length2)), shininess) * lit;
    float grazing = powf(1 - fminf(1.f, fabsf(against)), 4.f), shine = fminf(.6f, gloss * (.12f + .6f * grazing)) * open;
    for (int i = 0; i < 3; i++) {
        float sky = E[SKY_FILL], around = E[AMBIENT] * open * (.45f * (1 - sky) + (.75f + .6f * sky) * coming(E, N[2] * .6f, i));
        float light = E[SUNLIGHT + i] * fmaxf(0.f, facing) * lit + around;
        colour[i] = colour[i] * light * (1 - shine) + highlight * E[SUNLIGHT + i] + shine * coming(E, mirror[2], i);
    }
    return (facing > 0 && sunny && lit < .5f) || open < .6f;
}

// A box's shading normal turns towards its neighbour near an edge.
__device__ void round_edges(const float* q, const float* p, float* n) {
    const float* h = q + HALF_SIZE;
    float width = q[BEVEL] * fminf(h[0], fminf(h[1], h[2])), l[3];
    rotate(q + ROTATION, p[0] - q[CENTRE], p[1] - q[CENTRE + 1], p[2] - q[CENTRE + 2], l);
    float k = .5f + .5f * l[2] / h[2], scale = rsqrtf(dot(n, n));
    float reach[3] = {h[0] * (1 + (q[TAPER] - 1) * k), h[1] * (1 + (q[TAPER + 1] - 1) * k), h[2]};
    float middle[3] = {q[SHIFT] * k, q[SHIFT + 1] * k, 0};
    for (int i = 0; i < 3; i++) {
        n[i] *= scale;
        float x = l[i] - middle[i], edge = reach[i] - fabsf(x);
        if (fabsf(n[i]) < .6f && edge < width) n[i] += (x > 0 ? .8f : -.8f) * (1 - fmaxf(0.f, edge) / width);
    }
}

// Leaves look every way.
__device__ void ruffle(const float* p, float* n) {
    float scale = rsqrtf(dot(n, n));
    n[0] = n[0] * scale + 1.6f * (value_noise(p[0] * 37, p[1] * 37, p[2] * 37) - .5f);
    n[1] = n[1] * scale + 1.6f * (value_noise(p[0] * 37 + 90, p[1] * 37, p[2] * 37) - .5f);
    n[2] = n[2] * scale + 1.6f * (value_noise(p[0] * 37, p[1] * 37 + 90, p[2] * 37) - .5f);
}

// Dents, grain, folds: some primitives' normals N waver with the noise at the world point p.
__device__ void roughen(const float* q, const float* p, float* N) {
    float own = part(q[PATTERN_OFFSET] * .618f + q[FREQUENCY] * 1.7f), f = 3 + 60 * part(own * 7.3f);
    if (own > .45f) return;
    float strength = .15f + 2.2f * own, o = q[PATTERN_OFFSET];
    for (int i = 0; i < 3; i++) N[i] += strength * (value_noise(p[0] * f + o + 17 * i, p[1] * f, p[2] * f) - .5f);
    float scale = rsqrtf(dot(N, N) + 1e-9f);
    for (int i = 0; i < 3; i++) N[i] *= scale;
}

struct Sample {
    float colour[3];
    float z;  // camera z of what was hit
    bool subject, sky, shaded;
};

// Follow one ray from o in the unit direction d; `depth_row` is the camera's viewing direction.
__device__ Sample trace(const Scene& scene, const float* E, const float* o, const float* d, const float* depth_row,
                        int turn) {
    Sample out = {{0, 0, 0}, 0, false, false, false};
    float t, n[3] = {0, 0, 1}, N[3] = {0, 0, 1}, gloss = 0, shininess = 10;
    int which = nearest(scene, o, d, t, n);
    if (which >= 0) {
        const float* q = scene.prims + which * ROW;
        const float* R = q + ROTATION;
        float p[3] = {o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]};
        if (q[KIND] < .5f && q[BEVEL] > .01f && q[BEVEL] <= 1) round_edges(q, p, n);
        if (q[CUTOUT] > LEAVES - .5f && q[CUTOUT] < LEAVES + .5f) ruffle(p, n);
        for (int i = 0; i < 3; i++) N[i] = R[i] * n[0] + R[3 + i] * n[1] + R[6 + i] * n[2];
        float scale = rsqrtf(dot(N, N));
        for (int i = 0; i < 3; i++) N[i] *= scale;
        roughen(q, p, N);
        paint(q, p, out.colour);
        out.subject = q[SUBJECT] > .5f;
        gloss = q[GLOSS];
        shininess = q[SHININESS];
        if (gloss < 0) {  // a lamp, a lit window, a screen
            for (int i = 0; i < 3; i++) out.colour[i] *= -gloss;
            out.z = t * dot(depth_row, d);
            return out;
        }
    } else if (scene.subject_only) {
        out.sky = true;
    } else {
        out.sky = !surroundings(E, o, d, t, N, out.colour);
    }
    if (out.sky) return out;
    out.shaded = shade(scene, E, o, d, t, N, gloss, shininess, turn, out.colour);
    float fog = 1 - expf(-E[FOG] * t);
    if (!scene.subject_only)
        for (int i = 0; i < 3; i++) out.colour[i] += fog * (E[HORIZON + i] - out.colour[i]);
    out.z = t * dot(depth_row, d);
    return out;
}

// Whether the sphere reaches into the cone of rays from o about the unit axis, of half angle `wide`.
__device__ bool in_cone(const float* sphere, const float* o, const float* axis, float wide) {
    float v[3] = {sphere[0] - o[0], sphere[1] - o[1], sphere[2] - o[2]};
    float away2 = dot(v, v);
    if (away2 <= sphere[3] * 1.01f) return true;
    float away = sqrtf(away2);
    float angle = acosf(fminf(1.f, fmaxf(-1.f, dot(v, axis) / away))), radius = asinf(fminf(1.f, sqrtf(sphere[3]) / away));
    return angle <= wide + radius + 1e-3f;
}

// Unit direction of the ray through the picture point x, y (pixels) of camera K.
__device__ void ray(const float* K, float x, float y, float* d) {
    float ux = (x - K[14]) / K[12], uy = (y - K[15]) / K[13];
    for (int i = 0; i < 3; i++) d[i] = K[i] * ux + K[3 + i] * uy + K[6 + i];
    float scale = rsqrtf(dot(d, d));
    for (int i = 0; i < 3; i++) d[i] *= scale;
}

extern "C" __global__ void cast(const float* prims, const int* counts, const int* scene_of_view, const float* cameras,
                                const float* environments, float* rgb, float* alpha, float* depth, float* shaded,
                                int height, int width, int prims_per_scene, int supersample) {
    extern __shared__ float shared[];
    int view = blockIdx.z, index = scene_of_view[view], count = counts[index];
    const float* rows = prims + (size_t)index * prims_per_scene * ROW;
    float* spheres = shared;
    unsigned* seen = (unsigned*)(shared + 4 * prims_per_scene);

    const float* K = cameras + view * CAMERA_ROW;  // rotation 0:9, translation 9:12, fx, fy, cx, cy, subject only
    const float* E = environments + index * ENVIRONMENT_ROW;
    Scene scene = {rows, spheres, seen, count, K[16] > .5f};
    float origin[3];
    for (int i = 0; i < 3; i++) origin[i] = -(K[i] * K[9] + K[3 + i] * K[10] + K[6 + i] * K[11]);

    int threads = blockDim.x * blockDim.y, thread = threadIdx.y * blockDim.x + threadIdx.x;
    float left = blockIdx.x * blockDim.x, top = blockIdx.y * blockDim.y, axis[3], corner[3], widest = 1;
    ray(K, left + blockDim.x * .5f, top + blockDim.y * .5f, axis);
    for (int i = 0; i < 4; i++) {
        ray(K, left + (i & 1) * blockDim.x, top + (i >> 1) * blockDim.y, corner);
        widest = fminf(widest, dot(axis, corner));
    }
    float wide = acosf(fminf(1.f, widest)) + 1e-3f;
    for (int i = thread; i * 32 < count; i += threads) seen[i] = 0;
    __syncthreads();
    for (int i = thread; i < count; i += threads) {
        const float* q = rows + i * ROW;
        float* sphere = spheres + 4 * i;
        for (int j = 0; j < 3; j++) sphere[j] = q[CENTRE + j];
        sphere[3] = reach2(q) * 1.05f;
        bool counts_here = !scene.subject_only || q[SUBJECT] > .5f;
        if (counts_here && in_cone(sphere, origin, axis, wide)) atomicOr(seen + i / 32, 1u << (i % 32));
    }
    __syncthreads();
    int px = blockIdx.x * blockDim.x + threadIdx.x, py = blockIdx.y * blockDim.y + threadIdx.y;
    if (px >= width || py >= height) return;

    size_t pixel = ((size_t)view * height + py) * width + px;
    float sum[3] = {0, 0, 0}, covered = 0, dark = 0, subject_z = 1e9f;
    for (int s = 0; s < supersample * supersample; s++) {
        float d[3];
        ray(K, px + ((s % supersample) + .5f) / supersample, py + ((s / supersample) + .5f) / supersample, d);
        Sample sample = trace(scene, E, origin, d, K + 6, s & 3);
        if (sample.subject) {
            covered += 1;
            subject_z = fminf(subject_z, sample.z);
        }
        if (!sample.subject && sample.shaded) dark += 1;
        if (!scene.subject_only || sample.subject)
            for (int i = 0; i < 3; i++) sum[i] += sample.colour[i];
        // Where the subject is not, the first sample gives the depth of what is.
        if (!sample.subject && !scene.subject_only && !sample.sky && s == 0) depth[pixel] = sample.z;
    }
    float share = 1.f / (supersample * supersample);
    for (int i = 0; i < 3; i++)
        rgb[(((size_t)view * 3 + i) * height + py) * width + px] = powf(fminf(1.f, fmaxf(0.f, sum[i] * share)), .4545f);
    alpha[pixel] = covered * share;
    shaded[pixel] = dark * share;
    if (subject_z < 1e8f) depth[pixel] = subject_z;
}
