// Draws 3D Gaussians on the CPU: projected covariances, sorted by depth, blended front to back. See evaluate.py.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

// position [n, 3] and covariance [n, 3, 3] in the world, opacity [n], colour [n, 3]; world -> camera matrices [v, 4, 4],
// intrinsics [v, 4] (fx, fy, cx, cy). Out: image [v, h, w, 3] over black, alpha [v, h, w].
extern "C" void draw(const float* position, const float* covariance, const float* opacity, const float* colour,
                     const float* cameras, const float* intrinsics, float* image, float* alpha, int n, int views,
                     int height, int width) {
#pragma omp parallel for schedule(dynamic)
    for (int v = 0; v < views; v++) {
        const float *M = cameras + 16 * v, *K = intrinsics + 4 * v;
        float* out = image + (size_t)v * height * width * 3;
        std::vector<float> depth(n), left(height * width, 1.f);
        std::vector<int> order;
        std::vector<float> camera(3 * (size_t)n);
        for (int i = 0; i < n; i++) {
            const float* p = position + 3 * i;
            float* c = &camera[3 * (size_t)i];
            for (int k = 0; k < 3; k++) c[k] = M[4 * k] * p[0] + M[4 * k + 1] * p[1] + M[4 * k + 2] * p[2] + M[4 * k + 3];
            depth[i] = c[2];
            if (c[2] > .05f && opacity[i] > 1 / 255.f) order.push_back(i);
        }
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
        for (int i : order) {
            const float *c = &camera[3 * (size_t)i], *S = covariance + 9 * i;
            float fx = K[0] / c[2], fy = K[1] / c[2];
            float J[2][3] = {{fx, 0, -fx * c[0] / c[2]}, {0, fy, -fy * c[1] / c[2]}}, T[2][3];
            for (int a = 0; a < 2; a++)
                for (int k = 0; k < 3; k++) T[a][k] = J[a][0] * M[k] + J[a][1] * M[4 + k] + J[a][2] * M[8 + k];
            float C[3] = {0, 0, 0};
            for (int k = 0; k < 3; k++)
                for (int l = 0; l < 3; l++) {
                    C[0] += T[0][k] * S[3 * k + l] * T[0][l];
                    C[1] += T[0][k] * S[3 * k + l] * T[1][l];
                    C[2] += T[1][k] * S[3 * k + l] * T[1][l];
                }
            // The usual widening by a third of a pixel; what is drawn larger by it counts less by as much, as in training.
            float own = std::max(0.f, C[0] * C[2] - C[1] * C[1]);
            C[0] += .3f, C[2] += .3f;
            float det = C[0] * C[2] - C[1] * C[1], solid = opacity[i] * std::sqrt(own / det);
            float u = fx * c[0] + K[2], w = fy * c[1] + K[3], rx = 3.3f * std::sqrt(C[0]), ry = 3.3f * std::sqrt(C[2]);
            int x0 = std::max(0, (int)std::floor(u - rx)), x1 = std::min(width - 1, (int)std::ceil(u + rx));
            int y0 = std::max(0, (int)std::floor(w - ry)), y1 = std::min(height - 1, (int)std::ceil(w + ry));
            for (int y = y0; y <= y1; y++)
                for (int x = x0; x <= x1; x++) {
                    float& t = left[y * width + x];
                    if (t < 1e-4f) continue;
                    float dx = x + .5f - u, dy = y + .5f - w;
                    float power = -.5f * (C[2] * dx * dx - 2 * C[1] * dx * dy + C[0] * dy * dy) / det;
                    float a = std::min(.999f, solid * std::exp(power));
                    if (a < 1 / 255.f) continue;
                    for (int k = 0; k < 3; k++) out[3 * (y * width + x) + k] += t * a * colour[3 * i + k];
                    t *= 1 - a;
                }
        }
        for (int i = 0; i < height * width; i++) alpha[(size_t)v * height * width + i] = 1 - left[i];
    }
}
