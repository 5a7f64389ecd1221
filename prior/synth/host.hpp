// Lets a C++ compiler build the ray-caster for a machine without a GPU: one thread a block, blocks in a loop.

#include <cmath>
#include <cstddef>
#include <vector>

#define __device__ static
#define __global__
#define __shared__
#define rsqrtf(x) (1.f / std::sqrt(x))
#define __ffs __builtin_ffs
#define __syncthreads()

struct Index {
    int x, y, z;
};
static const Index threadIdx = {0, 0, 0}, blockDim = {1, 1, 1};
static thread_local Index blockIdx;
static thread_local float shared[1 << 14];
static void atomicOr(unsigned* at, unsigned bits) { *at |= bits; }
