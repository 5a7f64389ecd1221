// Rays against the primitives. All of it happens in the primitive's own frame: ray a + t b, half sizes h.

// Box with a scaled and moved top: the slab method over its six planes.
__device__ bool hit_box(const float* q, const float* a, const float* b, float tmin, float tmax, float& t, float* n) {
    const float* h = q + HALF_SIZE;
    float near = tmin, far = tmax;
    int entered = -1;
    float grow_x = (q[TAPER] - 1) * h[0], grow_y = (q[TAPER + 1] - 1) * h[1];
    float shift_x = q[SHIFT], shift_y = q[SHIFT + 1];
    float slope = .5f / h[2];
    for (int face = 0; face < 6; face++) {
        float N[3] = {0, 0, 0}, c;
        if (face == 0) {
            N[0] = 1;
            N[2] = -(shift_x + grow_x) * slope;
            c = h[0] + .5f * (shift_x + grow_x);
        } else if (face == 1) {
            N[0] = -1;
            N[2] = (shift_x - grow_x) * slope;
            c = h[0] - .5f * (shift_x - grow_x);
        } else if (face == 2) {
            N[1] = 1;
            N[2] = -(shift_y + grow_y) * slope;
            c = h[1] + .5f * (shift_y + grow_y);
        } else if (face == 3) {
            N[1] = -1;
            N[2] = (shift_y - grow_y) * slope;
            c = h[1] - .5f * (shift_y - grow_y);
        } else {
            N[2] = face == 4 ? 1 : -1;
            c = h[2];
        }
        float along = dot(N, b), room = c - dot(N, a);
        if (fabsf(along) < 1e-9f) {
            if (room < 0) return false;
            continue;
        }
        float s = room / along;
        if (along < 0) {
            if (s > near) {
                near = s;
                entered = face;
                n[0] = N[0];
                n[1] = N[1];
                n[2] = N[2];
            }
        } else {
            far = fminf(far, s);
        }
        if (near > far) return false;
    }
    if (entered < 0) return false;
    t = near;
    return true;
}

// The p-norm, p > 1, of a superellipsoid's own coordinates (x, y, z over its half sizes at that height) at the point l; its
// gradient over l goes to g.
__device__ float superellipsoid(const float* q, const float* l, float p, float* g) {
    const float* h = q + HALF_SIZE;
    float slope = .5f / h[2], k = .5f + slope * l[2], up = l[2] / h[2], sum = 1e-12f;
    float own[2], over[2];
    for (int i = 0; i < 2; i++) {
        over[i] = 1 / (h[i] * (1 + (q[TAPER + i] - 1) * k));
        own[i] = (l[i] - q[SHIFT + i] * k) * over[i];
        sum += powf(fabsf(own[i]) + 1e-9f, p);
    }
    sum += powf(fabsf(up) + 1e-9f, p);
    float norm = powf(sum, 1 / p), scale = norm / sum;
    g[2] = copysignf(powf(fabsf(up) + 1e-9f, p - 1), up) * scale / h[2];
    for (int i = 0; i < 2; i++) {
        g[i] = copysignf(powf(fabsf(own[i]) + 1e-9f, p - 1), own[i]) * scale * over[i];
        g[2] -= g[i] * slope * (q[SHIFT + i] + own[i] * h[i] * (q[TAPER + i] - 1));
    }
    return norm;
}

// A superellipsoid fills its box: Newton's steps from where the ray enters that. Along a ray the norm is convex (where it does
// not taper, nearly where it does), so that no step goes too far, and where the norm grows before it is 1 the ray passes by.
__device__ bool hit_superellipsoid(const float* q, const float* a, const float* b, float tmin, float tmax, float& t, float* n) {
    float s, l[3];
    if (!hit_box(q, a, b, tmin, tmax, s, n)) return false;
    for (int step = 0; step < 12; step++) {
        for (int i = 0; i < 3; i++) l[i] = a[i] + s * b[i];
        float above = superellipsoid(q, l, q[BEVEL], n) - 1, along = dot(n, b);
        if (above < 5e-4f) {
            t = s;
            return s < tmax;
        }
        if (along > -1e-6f) return false;
        s -= above / along;
        if (s > tmax) return false;
    }
    return false;
}

__device__ bool hit_ellipsoid(const float* q, const float* a, const float* b, float tmin, float tmax, float& t, float* n) {
    const float* h = q + HALF_SIZE;
    float u[3] = {a[0] / h[0], a[1] / h[1], a[2] / h[2]};
    float v[3] = {b[0] / h[0], b[1] / h[1], b[2] / h[2]};
    float A = dot(v, v), B = dot(u, v), C = dot(u, u) - 1, D = B * B - A * C;
    if (D < 0) return false;
    float root = sqrtf(D), s = (-B - root) / A;
    // Through a hole in its foliage a ray goes on to the far side.
    if (s < tmin && q[CUTOUT] > .5f) s = (-B + root) / A;
    if (s < tmin || s > tmax) return false;
    t = s;
    for (int i = 0; i < 3; i++) n[i] = (u[i] + s * v[i]) / h[i];
    return true;
}

// Elliptic cone frustum: its mantle, then its two caps (a tube has none). Radius in units of the bottom's:
// mean + slope * z.
__device__ bool hit_cylinder(const float* q, const float* a, const float* b, float tmin, float tmax, float& t, float* n) {
    const float* h = q + HALF_SIZE;
    float ux = a[0] / h[0], uy = a[1] / h[1], vx = b[0] / h[0], vy = b[1] / h[1];
    float slope = (q[TAPER] - 1) / (2 * h[2]), mean = (1 + q[TAPER]) * .5f, radius = mean + slope * a[2];
    float best = tmax;
    bool found = false;
    float A = vx * vx + vy * vy - slope * slope * b[2] * b[2];
    float B = ux * vx + uy * vy - slope * b[2] * radius;
    float C = ux * ux + uy * uy - radius * radius;
    float D = B * B - A * C;
    if (D >= 0 && fabsf(A) > 1e-9f) {
        float root = sqrtf(D);
        for (int side = 0; side < 2; side++) {
            float s = (-B + (side ? root : -root)) / A, z = a[2] + s * b[2];
            if (s > tmin && s < best && fabsf(z) <= h[2] && mean + slope * z >= 0) {
                best = s;
                found = true;
                n[0] = (ux + s * vx) / h[0];
                n[1] = (uy + s * vy) / h[1];
                n[2] = -(mean + slope * z) * slope;
            }
        }
    }
    if (q[KIND] < TUBE - .5f && fabsf(b[2]) > 1e-9f) {
        for (int end = -1; end < 2; end += 2) {
            float s = (end * h[2] - a[2]) / b[2], x = ux + s * vx, y = uy + s * vy, r = mean + slope * end * h[2];
            if (s > tmin && s < best && x * x + y * y <= r * r) {
                best = s;
                found = true;
                n[0] = n[1] = 0;
                n[2] = end;
            }
        }
    }
    if (found) t = best;
    return found;
}

// Frustum of a regular prism: TAPER = top over bottom, TAPER + 1 = its number of sides; half sizes to the sides' middle.
__device__ bool hit_prism(const float* q, const float* a, const float* b, float tmin, float tmax, float& t, float* n) {
    const float* h = q + HALF_SIZE;
    int sides = (int)(q[TAPER + 1] + .5f);
    float near = tmin, far = tmax, lean = .5f * (1 - q[TAPER]) / h[2], mean = .5f * (1 + q[TAPER]);
    bool entered = false;
    for (int face = 0; face < sides + 2; face++) {
        float N[3] = {0, 0, face == sides ? 1.f : -1.f}, c = h[2];
        if (face < sides) {
            float angle = 6.2831853f * face / sides;
            N[0] = cosf(angle) / h[0];
            N[1] = sinf(angle) / h[1];
            N[2] = lean;
            c = mean;
        }
        float along = dot(N, b), room = c - dot(N, a);
        if (fabsf(along) < 1e-9f) {
            if (room < 0) return false;
            continue;
        }
        float s = room / along;
        if (along < 0) {
            if (s > near) {
                near = s;
                entered = true;
                for (int i = 0; i < 3; i++) n[i] = N[i];
            }
        } else {
            far = fminf(far, s);
        }
        if (near > far) return false;
    }
    t = near;
    return entered;
}

// Squared radius of a sphere about the primitive's centre that holds it.
__device__ inline float reach2(const float* q) {
    const float* h = q + HALF_SIZE;
    bool box = q[KIND] < .5f;
    float wx = fmaxf(1.f, q[TAPER]), wy = fmaxf(1.f, box ? q[TAPER + 1] : q[TAPER]);
    if (q[KIND] > PRISM - .5f) {
        float corner = 1 / cosf(3.1415927f / q[TAPER + 1]);
        wx *= corner;
        wy *= corner;
    }
    float r2 = h[0] * h[0] * wx * wx + h[1] * h[1] * wy * wy + h[2] * h[2];
    if (q[KIND] > .5f && q[KIND] < 1.5f) r2 = fmaxf(h[0] * h[0], fmaxf(h[1] * h[1], h[2] * h[2]));
    if (q[KIND] > 1.5f && q[KIND] < 3.5f) r2 = fmaxf(h[0] * h[0] * wx * wx, h[1] * h[1] * wy * wy) + h[2] * h[2];
    if (box) {
        float sx = q[SHIFT], sy = q[SHIFT + 1];
        r2 += 2 * (fabsf(sx) * h[0] + fabsf(sy) * h[1]) * 2 + sx * sx + sy * sy;
    }
    return r2;
}

// Whether a cut-out primitive is solid at the local point l.
__device__ bool solid_at(const float* q, const float* l) {
    int cut = (int)(q[CUTOUT] + .5f);
    const float* h = q + HALF_SIZE;
    float f = q[CUT_FREQUENCY], share = q[CUT_SHARE];
    if (cut == LEAVES) {
        float o = q[PATTERN_OFFSET];
        float coarse = value_noise(l[0] * f + o, l[1] * f, l[2] * f + o);
        return coarse * .6f + .4f * value_noise(l[0] * f * 2.7f, l[1] * f * 2.7f + o, l[2] * f * 2.7f) < share;
    }
    if (cut == SPOKES) {
        float r = sqrtf(l[0] * l[0] / (h[0] * h[0]) + l[1] * l[1] / (h[1] * h[1]));
        float turn = atan2f(l[1], l[0]) * .15915494f * f;
        return r > .86f || r < .2f || turn - floorf(turn) < share / fmaxf(r, .3f);
    }
    // The plane of the panel: everything but its thinnest axis.
    int u = h[0] >= h[1] ? 0 : 1, v = 2;
    if (h[2] < h[0] && h[2] < h[1]) {
        u = 0;
        v = 1;
    }
    float edge = share / f, x = l[u] * f, y = l[v] * f;
    bool left = h[u] - fabsf(l[u]) < edge, top = h[v] - fabsf(l[v]) < edge;
    if (q[KIND] > 1.5f && v == 2) {  // a round wall: its bars stand around it, `f` a turn
        x = atan2f(l[1] / h[1], l[0] / h[0]) * .15915494f * f;
        y = l[2] / (h[0] + h[1]) * .31830989f * f;
        left = false;
        top = h[2] - fabsf(l[2]) < .12f * h[2];
    }
    bool bar = x - floorf(x) < share, rung = y - floorf(y) < share;
    if (cut == BARS) return top || bar;
    if (cut == RUNGS) return left || rung;
    if (cut == GRID) return left || top || bar || rung;
    float p = x + y, m = x - y;
    return left || top || p - floorf(p) < share || m - floorf(m) < share;
}

__device__ bool hit_kind(const float* q, const float* a, const float* b, float tmin, float tmax, float& t, float* n) {
    int kind = (int)(q[KIND] + .5f);
    if (kind == BOX && q[BEVEL] > 1) return hit_superellipsoid(q, a, b, tmin, tmax, t, n);
    if (kind == BOX) return hit_box(q, a, b, tmin, tmax, t, n);
    if (kind == BALL) return hit_ellipsoid(q, a, b, tmin, tmax, t, n);
    if (kind == PRISM) return hit_prism(q, a, b, tmin, tmax, t, n);
    return hit_cylinder(q, a, b, tmin, tmax, t, n);
}

// Whether the ray from o in the unit direction d can meet the sphere (centre, squared radius) in 0 < t < tmax.
__device__ inline bool may_hit(const float* sphere, const float* o, const float* d, float tmax) {
    float v[3] = {sphere[0] - o[0], sphere[1] - o[1], sphere[2] - o[2]};
    float along = dot(v, d), away = dot(v, v), r2 = sphere[3];
    if (away > r2 && along < 0) return false;
    if (away - along * along > r2) return false;
    float reach = along - tmax;
    return reach < 0 || reach * reach <= r2;
}

// Nearest hit of primitive q by the ray o + t d with tmin < t < tmax; n = its local normal, not normalised.
__device__ bool hit(const float* q, const float* o, const float* d, float tmin, float tmax, float& t, float* n) {
    float a[3], b[3];
    rotate(q + ROTATION, o[0] - q[CENTRE], o[1] - q[CENTRE + 1], o[2] - q[CENTRE + 2], a);
    rotate(q + ROTATION, d[0], d[1], d[2], b);
    if (!hit_kind(q, a, b, tmin, tmax, t, n)) return false;
    if (q[CUTOUT] > .5f) {
        float l[3] = {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
        if (!solid_at(q, l)) {
            if (!hit_kind(q, a, b, t + 1e-3f, tmax, t, n)) return false;
            for (int i = 0; i < 3; i++) l[i] = a[i] + t * b[i];
            if (!solid_at(q, l)) return false;
        }
    }
    // Thin shells are seen from both sides.
    if ((q[KIND] > TUBE - .5f && q[KIND] < TUBE + .5f) || q[CUTOUT] > .5f) {
        if (dot(n, b) > 0)
            for (int i = 0; i < 3; i++) n[i] = -n[i];
    }
    return true;
}
