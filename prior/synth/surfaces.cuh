// Colours of everything that a ray can meet: noise, the patterns of materials, ground, wall and sky.

__device__ inline float hash01(int x, int y, int z) {
    unsigned h = x * 374761393u + y * 668265263u + z * 2147483647u;
    h = (h ^ (h >> 13)) * 1274126177u;
    h ^= h >> 16;
    return (h & 0xffffff) / 16777216.f;
}

// Smoothly interpolated lattice noise, 0..1.
__device__ float value_noise(float x, float y, float z) {
    int i = floorf(x), j = floorf(y), k = floorf(z);
    float a = x - i, b = y - j, c = z - k;
    a = a * a * (3 - 2 * a);
    b = b * b * (3 - 2 * b);
    c = c * c * (3 - 2 * c);
    float sum = 0;
    for (int corner = 0; corner < 8; corner++) {
        int p = corner & 1, q = (corner >> 1) & 1, s = corner >> 2;
        sum += (p ? a : 1 - a) * (q ? b : 1 - b) * (s ? c : 1 - c) * hash01(i + p, j + q, k + s);
    }
    return sum;
}

// Four octaves of value noise.
__device__ float fractal_noise(float x, float y, float z) {
    float sum = 0, amplitude = .5f;
    for (int octave = 0; octave < 4; octave++) {
        sum += amplitude * value_noise(x, y, z);
        x = x * 2.03f + 7.1f;
        y = y * 2.03f + 3.7f;
        z = z * 2.03f + 1.3f;
        amplitude *= .5f;
    }
    return sum;
}

// ---------------------------------------------------------------- materials

// Weight 0..1 of the second colour at the pattern coordinates x, y, z.
__device__ float pattern_weight(int pattern, float x, float y, float z) {
    switch (pattern) {
        case 1:  // cloudy
            return fractal_noise(x, y, z) * 1.1f;
        case 2:  // bands
            return sinf(z * 2.5f) > .3f;
        case 3: {  // windows
            float gx = x * .6f - floorf(x * .6f), gy = y * .6f - floorf(y * .6f), gz = z * .8f - floorf(z * .8f);
            return gz > .3f && gz < .8f && gx > .25f && gy > .25f;
        }
        case 4:  // checker
            return (int)(floorf(x) + floorf(y) + floorf(z)) & 1;
        case 5:  // camouflage
            return fractal_noise(x * .5f, y * .5f, z * .5f) > .5f;
        case 6: {  // seams
            float gx = fabsf(x - roundf(x)), gz = fabsf(z - roundf(z));
            return gx < .04f || gz < .04f;
        }
        case 7:  // waves
            return .5f + .5f * sinf(x * 1.7f + 3 * value_noise(x, y, z));
        default:
            return 0;
    }
}

// Linear colour of primitive q at the world point p.
__device__ void paint(const float* q, const float* p, float* colour) {
    float l[3];
    rotate(q + ROTATION, p[0] - q[CENTRE], p[1] - q[CENTRE + 1], p[2] - q[CENTRE + 2], l);
    float f = q[FREQUENCY], offset = q[PATTERN_OFFSET];
    float x = l[0] * f + offset, y = l[1] * f + offset * .7f, z = l[2] * f + offset * 1.3f;
    float w = pattern_weight((int)(q[PATTERN] + .5f), x, y, z);
    float grain = .88f + .24f * value_noise(l[0] * 25 + offset, l[1] * 25, l[2] * 25);
    for (int i = 0; i < 3; i++) colour[i] = fminf(1.f, (q[FIRST + i] * (1 - w) + q[SECOND + i] * w) * grain);
}

// ---------------------------------------------------------------- surroundings

__device__ void ground_colour(const float* E, float x, float y, float distance, float* colour) {
    float f = E[GROUND_FREQUENCY], seed = E[SEED];
    float coarse = fractal_noise(x * f + seed, y * f, seed);
    float detail = E[TILES] > .5f ? (((int)(floorf(x * f * .3f) + floorf(y * f * .3f))) & 1)
                                  : value_noise(x * f * 6, y * f * 6, seed);
    float fine = value_noise(x * f * 23, y * f * 23, seed);
    float patch = fractal_noise(x * f * .4f + 9, y * f * .4f, seed);
    float patches = E[HILLS] > 1.2f ? .8f * (patch > .52f) : 0.f;
    float k = fminf(1.f, coarse * .9f + detail * .25f + (E[CLOUDS] - .4f) * .6f * (fine - .5f) + patches);
    float haze = fminf(1.f, distance / 50);
    for (int i = 0; i < 3; i++) {
        float c = E[GROUND_A + i] * (1 - k) + E[GROUND_B + i] * k;
        colour[i] = c * (1 - haze) + E[HORIZON + i] * haze;
    }
}

__device__ void wall_colour(const float* E, float x, float y, float z, float* colour) {
    float g = fractal_noise((x + y) * E[GROUND_FREQUENCY] + E[SEED], z * E[GROUND_FREQUENCY], E[SEED]);
    for (int i = 0; i < 3; i++) colour[i] = E[ZENITH + i] * (1 - g) + E[HORIZON + i] * g;
}

// Five layers of coloured, textured patches around the horizon: a busy background at no cost.
__device__ void clutter_colour(const float* E, float azimuth, float up, float* colour) {
    float seed = E[SEED], v = up * 6;
    int s = (int)seed;
    for (int layer = 0; layer < 5; layer++) {
        float k = (2.5f + 4 * hash01(layer, 9, s));
        float wobble = .6f * value_noise(azimuth * 5 + layer * 7, v * 2, seed);
        int ci = floorf(azimuth * k + layer * .37f + wobble);
        int cj = floorf(v * k * .25f + .7f * layer + hash01(ci, layer, s) * 3);
        if (layer > 0 && hash01(ci + layer * 31, cj, s) <= .55f) continue;
        float cloudy = fractal_noise(azimuth * 30 + ci * 3, v * 12 + cj, seed), striped = 0;
        if (hash01(ci, cj, 7) > .6f) striped = sinf(azimuth * 120 * hash01(ci, cj, 3) + v * 60 * hash01(cj, ci, 4)) > 0;
        for (int i = 0; i < 3; i++) {
            float base = .9f * hash01(ci * 7 + i, cj * 5 + layer, s) * .6f + E[ZENITH + i] * .4f;
            colour[i] = fminf(1.f, base * (.45f + .8f * cloudy) * (1 - .4f * striped));
        }
    }
}

// What lies behind everything in the direction d.
__device__ void sky_colour(const float* E, int backdrop, const float* d, float* colour) {
    float seed = E[SEED], up = fmaxf(0.f, d[2]), to_horizon = powf(1 - up, 3.f), azimuth = atan2f(d[1], d[0]);
    float cloud = 0, hill = 0;
    if (backdrop != NOISE_ROOM) {
        float noise = fractal_noise(d[0] / (up + .15f) * 1.5f + seed, d[1] / (up + .15f) * 1.5f, seed);
        cloud = fmaxf(0.f, noise - .45f) * 1.8f * E[CLOUDS];
    }
    if (backdrop == LANDSCAPE) {
        float ridge = .1f * E[HILLS] * fractal_noise(azimuth * 3 + seed, seed, 0);
        bool built = fractal_noise(floorf(azimuth * 14) + seed, 1, 2) > .5f;
        hill = ridge + .06f * E[HILLS] * built * hash01((int)floorf(azimuth * 30), 3, (int)seed);
    }
    for (int i = 0; i < 3; i++) {
        float c = E[ZENITH + i] * (1 - to_horizon) + E[HORIZON + i] * to_horizon;
        c = c * (1 - cloud) + cloud;
        if (backdrop == LANDSCAPE && d[2] < hill - .01f)
            c = E[HILL_COLOUR + i] * (.4f + .6f * fractal_noise(azimuth * 20, d[2] * 40, seed));
        if (backdrop == NOISE_ROOM) {
            float f = E[GROUND_FREQUENCY];
            c = E[ZENITH + i] * (.7f + .6f * fractal_noise(d[0] * f + seed, d[1] * f, d[2] * f));
        }
        colour[i] = c;
    }
    if (backdrop == CLUTTER) clutter_colour(E, azimuth, d[2], colour);
}

// Ground, wall or sky. Returns whether there is a surface; then t is its distance and N its normal.
__device__ bool surroundings(const float* E, const float* o, const float* d, float& t, float* N, float* colour) {
    int backdrop = (int)(E[BACKDROP] + .5f);
    float to_ground = (E[GROUND_Z] - o[2]) / d[2], to_wall = 1e8f;
    if (backdrop == WALL) {
        float facing = d[0] * E[WALL_X] + d[1] * E[WALL_Y];
        if (facing < -1e-4f) to_wall = (-E[WALL_DISTANCE] - o[0] * E[WALL_X] - o[1] * E[WALL_Y]) / facing;
        if (to_wall < 0) to_wall = 1e8f;
    }
    bool on_ground = backdrop != NOISE_ROOM && d[2] < -1e-4f && to_ground > 0 && to_ground < to_wall && to_ground < 60;
    if (on_ground) {
        t = to_ground;
        ground_colour(E, o[0] + t * d[0], o[1] + t * d[1], t, colour);
        return true;
    }
    if (backdrop == WALL && to_wall < 1e7f) {
        t = to_wall;
        N[0] = E[WALL_X];
        N[1] = E[WALL_Y];
        N[2] = 0;
        wall_colour(E, o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2], colour);
        return true;
    }
    sky_colour(E, backdrop, d, colour);
    return false;
}
