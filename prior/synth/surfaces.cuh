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

__device__ inline float part(float x) {
    return x - floorf(x);
}

// Courses of blocks of `length` times their height: 1 in the joints, a tone of its own below .5 for every block.
__device__ float coursed(float u, float v, float length, float joint) {
    int row = floorf(v);
    float along = u / length + .5f * (row & 1);
    if (part(v) < joint || part(along) < joint / length) return 1;
    return .5f * hash01((int)floorf(along), row, 5);
}

// Rows of marks that look like writing from afar.
__device__ float writing(float u, float v) {
    int row = floorf(v), letter = floorf(u * 1.6f);
    float high = part(v) * 1.5f, wide = part(u * 1.6f) * 1.4f;
    if (high > 1 || wide > 1 || hash01(row, letter, 3) < .18f || hash01(row, letter >> 3, 4) < .3f) return 0;
    return hash01(letter * 3 + (int)(wide * 3), row * 5 + (int)(high * 5), 9) > .42f;
}

// Weight 0..1 of the second colour at the pattern coordinates x, y, z.
__device__ float pattern_weight(int pattern, float x, float y, float z) {
    float u = x + y;
    switch (pattern) {
        case 1:  // cloudy
            return fractal_noise(x, y, z) * 1.1f;
        case 2:  // bands
            return sinf(z * 2.5f) > .3f;
        case 3: {  // windows
            float gx = part(x * .6f), gy = part(y * .6f), gz = part(z * .8f);
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
        case 8:  // bricks
            return coursed(u, z * 1.6f, 2.2f, .14f);
        case 9: {  // shingles: ribs down the slope, courses across
            float rib = fabsf(part(u * 1.5f) - .5f) * 2;
            return fminf(1.f, rib * rib * .8f + .5f * (part(z * 2) < .2f));
        }
        case 10: {  // planks with grain
            int plank = floorf(z * 1.3f);
            float grain = value_noise(u * .6f + plank * 7.3f, z * 9, x - y);
            return part(z * 1.3f) < .06f ? 1 : .55f * grain + .25f * hash01(plank, 2, 6);
        }
        case 11:  // stripes
            return part(u * .8f) < .4f;
        case 12: {  // dots
            float gx = part(x) - .5f, gy = part(y) - .5f, gz = part(z) - .5f;
            return gx * gx + gy * gy + gz * gz < .16f;
        }
        case 13: {  // streaks of rust or dirt
            float streak = value_noise(x * 2.5f, y * 2.5f, z * .35f) * value_noise(x * .4f, y * .4f, z * .4f);
            return fminf(1.f, fmaxf(0.f, streak * 3.2f - .55f));
        }
        case 14:  // writing
            return writing(u, z * .8f);
        case 15: {  // facade: framed windows of different lights
            float gu = part(u * .55f), gz = part(z * .7f);
            if (gu < .22f || gu > .78f || gz < .25f || gz > .8f) return 0;
            if (gu < .27f || gu > .73f || gz < .3f || gz > .75f || fabsf(gu - .5f) < .02f) return .25f;
            return .6f + .4f * hash01((int)floorf(u * .55f), (int)floorf(z * .7f), 8);
        }
        case 16:  // patchwork
            return hash01((int)floorf(x * .7f), (int)floorf(y * .7f), (int)floorf(z * .7f));
        case 17:  // speckles
            return value_noise(x * 2.2f, y * 2.2f, z * 2.2f) > .62f;
        case 18: {  // ribs, as of sheet metal
            float rib = sinf(u * 6.2832f);
            return .5f + .5f * rib;
        }
        case 19:  // columns and ledges
            return part(u * .5f) < .18f || part(z * .5f) < .14f ? 1 : .25f * fractal_noise(x, y, z);
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
    if (q[CUTOUT] > .5f && q[CUTOUT] < 1.5f) grain *= .45f + 1.1f * value_noise(l[0] * 31, l[1] * 31 + offset, l[2] * 31);
    for (int i = 0; i < 3; i++) colour[i] = fminf(1.f, (q[FIRST + i] * (1 - w) + q[SECOND + i] * w) * grain);
}

// ---------------------------------------------------------------- surroundings

// How much of a runway's paint lies at a point: centre line, edge lines and threshold bars, along the wall's direction.
__device__ float runway_paint(const float* E, float x, float y, float f) {
    float finer = .6f + .2f * sqrtf(f), along = (x * E[WALL_X] + y * E[WALL_Y]) * finer;
    int s = (int)E[SEED];
    float across = (y * E[WALL_X] - x * E[WALL_Y]) * finer + 3 * hash01(s, 2, 6) - 1.5f, aside = fabsf(across);
    along += 9 * hash01(s, 3, 6);
    bool dash = aside < .07f && part(along * .3f) < .6f, edge = fabsf(aside - 2.2f) < .05f;
    bool bars = part(along * .06f) < .09f && aside > .2f && aside < 2 && part(across * 1.7f) < .55f;
    float worn = .55f + .9f * fractal_noise(x * 9 + E[SEED], y * 9, 3);
    return dash || edge || bars ? fminf(1.f, worn) : 0;
}

__device__ void ground_colour(const float* E, float x, float y, float distance, float* colour) {
    float f = E[GROUND_FREQUENCY], seed = E[SEED];
    int kind = (int)(E[GROUND_KIND] + .5f);
    float coarse = fractal_noise(x * f + seed, y * f, seed);
    float detail, coarse_part = .9f;
    if (kind == TILED) {
        detail = (((int)(floorf(x * f * .3f) + floorf(y * f * .3f))) & 1) * .25f;
    } else if (kind == PAVED) {
        coarse_part = .3f;
        detail = .8f * coursed(x * f * 1.2f, y * f * 1.2f, 2, .1f);
    } else if (kind == GRASS) {
        coarse_part = .5f;
        detail = .55f * value_noise(x * 29 + seed, y * 29, seed) + .3f * (value_noise(x * 61, y * 23, seed) > .6f);
    } else if (kind == PLANKED) {
        coarse_part = .15f;
        int plank = floorf(y * f);
        detail = part(y * f) < .04f ? 1 : .5f * value_noise(x * f * .7f + 5 * plank, y * f * 8, seed) + .3f * hash01(plank, 1, 2);
    } else if (kind == RUNWAY) {
        coarse_part = .12f;
        detail = runway_paint(E, x, y, f);
    } else {
        detail = .25f * value_noise(x * f * 6, y * f * 6, seed);
    }
    float fine = value_noise(x * f * 23, y * f * 23, seed);
    float patch = fractal_noise(x * f * .4f + 9, y * f * .4f, seed);
    float patches = E[HILLS] > 1.4f && kind != RUNWAY ? .8f * (patch > .52f) : 0.f;
    // Between asphalt and paint lies nothing.
    float rough = kind == RUNWAY ? 0.f : (E[CLOUDS] - .4f) * .6f * (fine - .5f);
    float k = fminf(1.f, coarse * coarse_part + detail + rough + patches);
    float haze = fminf(1.f, distance / 50);
    for (int i = 0; i < 3; i++) {
        float c = E[GROUND_A + i] * (1 - k) + E[GROUND_B + i] * k;
        colour[i] = c * (1 - haze) + E[HORIZON + i] * haze;
    }
}

// Of the wall with the level normal n.
__device__ void wall_colour(const float* E, const float* n, float x, float y, float z, float* colour) {
    float f = E[SCALE], u = (x * n[1] - y * n[0]) * f + E[SEED];
    int kind = (int)(E[WALL_KIND] + .5f);
    float g = fractal_noise(u, z * f, E[SEED]);
    if (kind > 0) g = .25f * g + .75f * pattern_weight(kind, u, 0, z * f);
    // A hedge: leaves with dark gaps.
    if (kind < 0) g = .2f + 1.4f * value_noise(u * 7, z * f * 7, E[SEED]) * g;
    for (int i = 0; i < 3; i++)
        colour[i] = kind < 0 ? E[HILL_COLOUR + i] * g : E[GROUND_B + i] * g + E[HILL_COLOUR + i] * (1 - g);
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

// A near and a far row of trees before the sky.
__device__ void tree_colour(const float* E, float azimuth, float up, float* colour) {
    float seed = E[SEED];
    for (int row = 0; row < 2; row++) {
        float crown = fractal_noise(azimuth * (4 + 5 * row) + seed + 40 * row, up * 4, seed + row);
        float top = (.04f + .32f * E[HILLS] * (row ? .45f : 1.f)) * crown;
        float leaf = fractal_noise(azimuth * 34 + 9 * row, up * 40, seed);
        if (up > top + .05f * (leaf - .5f)) continue;
        float light = (row ? .75f : .95f) * fmaxf(.08f, 2.6f * leaf - .55f);
        for (int i = 0; i < 3; i++) colour[i] = fminf(1.f, E[HILL_COLOUR + i] * light + .12f * row * E[HORIZON + i]);
        bool trunk = up < .4f * top && part(azimuth * 9 + hash01((int)floorf(azimuth * 9), row, 2)) < .06f;
        if (trunk)
            for (int i = 0; i < 3; i++) colour[i] *= .4f;
    }
}

// Houses of different heights and colours side by side, in two rows.
__device__ void town_colour(const float* E, float azimuth, float up, float* colour) {
    int s = (int)E[SEED];
    for (int row = 1; row >= 0; row--) {
        float place = azimuth * (row ? 11 : 6) + hash01(row, 1, s) * 9;
        int house = floorf(place);
        float top = (.05f + .3f * E[HILLS] * hash01(house, row, s)) * (row ? 1.2f : 1.f);
        if (up > top || hash01(house, row + 5, s) < (row ? .1f : .35f)) continue;
        float windows = pattern_weight(hash01(house, row, 11) > .4f ? 15 : 3, place * 9, 0, up * 55);
        for (int i = 0; i < 3; i++) {
            float wall = (.15f + .75f * hash01(house, row + 2, s)) * (.75f + .5f * hash01(house * 3 + i, row, s));
            float haze = row ? .35f : .1f;
            float c = wall * (1 - .75f * windows) * (.7f + .5f * fractal_noise(place * 5, up * 30, E[SEED]));
            colour[i] = fminf(1.f, c * (1 - haze) + haze * E[HORIZON + i]);
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
    if (backdrop == TREES) tree_colour(E, azimuth, d[2], colour);
    if (backdrop == TOWN) town_colour(E, azimuth, d[2], colour);
}

// A ceiling with lamps.
__device__ void ceiling_colour(const float* E, float x, float y, float* colour) {
    float u = x * E[WALL_X] + y * E[WALL_Y], v = y * E[WALL_X] - x * E[WALL_Y];
    bool lamp = part(u * .35f) < .3f && part(v * .7f) < .2f;
    for (int i = 0; i < 3; i++) colour[i] = lamp ? 1 : (.4f + .5f * E[HORIZON + i]) * (.85f + .3f * fractal_noise(x, y, E[SEED]));
}

// Ground, walls, ceiling or sky. Returns whether there is a surface; then t is its distance and N its normal.
__device__ bool surroundings(const float* E, const float* o, const float* d, float& t, float* N, float* colour) {
    int backdrop = (int)(E[BACKDROP] + .5f);
    float to_ground = (E[GROUND_Z] - o[2]) / d[2], to_wall = 1e8f, to_ceiling = 1e8f, wall[2] = {0, 0};
    // One wall, or a room's four; seen from inside alone, so that no camera is walled out.
    for (int k = 0; k < (backdrop == ROOM ? 4 : backdrop == WALL); k++) {
        float sign = k < 2 ? 1.f : -1.f, away = E[WALL_DISTANCE] * (k ? .7f + .6f * hash01((int)E[SEED], k, 4) : 1);
        float n[2] = {sign * (k & 1 ? -E[WALL_Y] : E[WALL_X]), sign * (k & 1 ? E[WALL_X] : E[WALL_Y])};
        float facing = d[0] * n[0] + d[1] * n[1];
        float to = facing < -1e-4f ? (-away - o[0] * n[0] - o[1] * n[1]) / facing : -1;
        if (to < 0 || to >= to_wall) continue;
        to_wall = to;
        wall[0] = n[0];
        wall[1] = n[1];
    }
    if (backdrop == ROOM && d[2] > 1e-4f) {
        to_ceiling = (E[GROUND_Z] + 2.2f + 2 * hash01((int)E[SEED], 6, 1) - o[2]) / d[2];
        if (to_ceiling < 0) to_ceiling = 1e8f;
    }
    bool on_ground = backdrop != NOISE_ROOM && d[2] < -1e-4f && to_ground > 0 && to_ground < to_wall && to_ground < 60;
    if (on_ground) {
        t = to_ground;
        float x = o[0] + t * d[0], y = o[1] + t * d[1];
        ground_colour(E, x, y, t, colour);
        if (E[GROUND_KIND] > WATER - .5f && E[GROUND_KIND] < WATER + .5f) {
            float f = E[GROUND_FREQUENCY] * 3, wave = .25f * (value_noise(x * f, y * f * 2, E[SEED]) - .5f);
            float up[3] = {d[0] + wave, d[1] + wave, fmaxf(.02f, -d[2] + wave)}, sky[3];
            sky_colour(E, backdrop, up, sky);
            float mirror = powf(1 - fminf(1.f, -d[2]), 3.f) * .8f + .1f;
            for (int i = 0; i < 3; i++) colour[i] = colour[i] * (1 - mirror) + sky[i] * mirror;
        }
        return true;
    }
    if (to_ceiling < fminf(to_wall, 1e7f)) {
        t = to_ceiling;
        N[0] = N[1] = 0;
        N[2] = -1;
        ceiling_colour(E, o[0] + t * d[0], o[1] + t * d[1], colour);
        return true;
    }
    if (to_wall < 1e7f) {
        t = to_wall;
        N[0] = wall[0];
        N[1] = wall[1];
        N[2] = 0;
        wall_colour(E, wall, o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2], colour);
        return true;
    }
    sky_colour(E, backdrop, d, colour);
    return false;
}
