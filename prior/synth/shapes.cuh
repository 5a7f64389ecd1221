// Rays against the three convex primitives. All of it happens in the primitive's own frame: ray a + t b, half sizes h.

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

__device__ bool hit_ellipsoid(const float* q, const float* a, const float* b, float tmin, float tmax, float& t, float* n) {
    const float* h = q + HALF_SIZE;
    float u[3] = {a[0] / h[0], a[1] / h[1], a[2] / h[2]};
    float v[3] = {b[0] / h[0], b[1] / h[1], b[2] / h[2]};
    float A = dot(v, v), B = dot(u, v), C = dot(u, u) - 1, D = B * B - A * C;
    if (D < 0) return false;
    float s = (-B - sqrtf(D)) / A;
    if (s < tmin || s > tmax) return false;
    t = s;
    for (int i = 0; i < 3; i++) n[i] = (u[i] + s * v[i]) / h[i];
    return true;
}

// Elliptic cone frustum: its mantle, then its two caps. Radius in units of the bottom's: mean + slope * z.
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
    if (fabsf(b[2]) > 1e-9f) {
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

// Squared radius of a sphere about the primitive's centre that holds it.
__device__ inline float reach2(const float* q) {
    const float* h = q + HALF_SIZE;
    float r2 = h[0] * h[0] * fmaxf(1.f, q[TAPER] * q[TAPER]) + h[1] * h[1] * fmaxf(1.f, q[TAPER + 1] * q[TAPER + 1]) + h[2] * h[2];
    if (q[KIND] < .5f) {
        float sx = q[SHIFT], sy = q[SHIFT + 1];
        r2 += 2 * (fabsf(sx) * h[0] + fabsf(sy) * h[1]) * 2 + sx * sx + sy * sy;
    }
    return r2;
}

// Nearest hit of primitive q by the ray o + t d with tmin < t < tmax; n = its local normal, not normalised.
__device__ bool hit(const float* q, const float* o, const float* d, float tmin, float tmax, float& t, float* n) {
    float a[3], b[3];
    rotate(q + ROTATION, o[0] - q[CENTRE], o[1] - q[CENTRE + 1], o[2] - q[CENTRE + 2], a);
    rotate(q + ROTATION, d[0], d[1], d[2], b);
    float bb = dot(b, b), ab = dot(a, b), aa = dot(a, a);
    if (aa - ab * ab / bb > reach2(q) * 1.05f) return false;
    if (q[KIND] < .5f) return hit_box(q, a, b, tmin, tmax, t, n);
    if (q[KIND] < 1.5f) return hit_ellipsoid(q, a, b, tmin, tmax, t, n);
    return hit_cylinder(q, a, b, tmin, tmax, t, n);
}
