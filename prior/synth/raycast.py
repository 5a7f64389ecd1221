"""Launches the ray-casting kernel on PyTorch's tensors and stream (CuPy compiles it at first use).

Tensors on the CPU are cast there: slower by far, but enough to look at pictures and to test without a GPU.
"""

import ctypes
import hashlib
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
import torch

SOURCES = ("columns.cuh", "surfaces.cuh", "shapes.cuh", "raycast.cu")
BLOCK = 16
HERE = Path(__file__).parent
# Calls the kernel for every pixel of every view.
HOST_LOOP = """
extern "C" void cast_host(const float* prims, const int* counts, const int* scene_of_view, const float* cameras,
                          const float* environments, float* rgb, float* alpha, float* depth, float* shade, int height,
                          int width, int prims_per_scene, int supersample, int views) {
#pragma omp parallel for schedule(dynamic)
    for (int row = 0; row < views * height; row++)
        for (int x = 0; x < width; x++) {
            blockIdx = {x, row % height, row / height};
            cast(prims, counts, scene_of_view, cameras, environments, rgb, alpha, depth, shade, height, width,
                 prims_per_scene, supersample);
        }
}
"""


def source():
    return "\n".join((HERE / name).read_text() for name in SOURCES)


@cache
def kernel(shared_bytes):
    import cupy

    function = cupy.RawModule(code=source(), options=("--use_fast_math",)).get_function("cast")
    if shared_bytes > 48 * 1024:
        function.max_dynamic_shared_size_bytes = shared_bytes
    return function


@cache
def host_library():
    """The same kernel compiled by g++ (or what calls itself so), kept in the temporary folder."""
    code = (HERE / "host.hpp").read_text() + source().replace("extern __shared__ float shared[];", "") + HOST_LOOP
    folder = Path(tempfile.gettempdir()) / f"raycast-{hashlib.sha256(code.encode()).hexdigest()[:16]}"
    library = folder / "cast.so"
    if not library.exists():
        folder.mkdir(exist_ok=True)
        (folder / "cast.cpp").write_text(code)
        command = ["g++", "-O2", "-fopenmp", "-shared", "-fPIC", "-w", "-o", library, folder / "cast.cpp"]
        subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))


def as_cupy(tensor):
    """The same memory, seen by CuPy."""
    import cupy

    dtypes = {torch.float32: cupy.float32, torch.int32: cupy.int32}
    memory = cupy.cuda.UnownedMemory(tensor.data_ptr(), tensor.numel() * tensor.element_size(), tensor)
    return cupy.ndarray(tuple(tensor.shape), dtypes[tensor.dtype], cupy.cuda.MemoryPointer(memory, 0))


def cast(prims, counts, scene_of_view, cameras, environments, size, supersample=2):
    """Render square views of `size` pixels with supersample^2 rays a pixel.

    prims [S, P, 36] float32, counts [S] int32, scene_of_view [V] int32, cameras [V, 20], environments [S, 40]
    (rows as in `layout`). Returns rgb [V, 3, H, W] (sRGB 0..1; views of the subject alone are premultiplied in linear
    light), alpha [V, H, W], depth [V, H, W] (camera z, 0 where there is nothing) and shade [V, H, W], the share of each
    pixel that is not the subject and lies in a shadow.
    """
    views = len(scene_of_view)
    prims_per_scene = prims.shape[1]
    rgb = torch.zeros(views, 3, size, size, device=prims.device)
    alpha = torch.zeros(views, size, size, device=prims.device)
    depth = torch.zeros(views, size, size, device=prims.device)
    shade = torch.zeros(views, size, size, device=prims.device)
    inputs = [t.contiguous() for t in (prims, counts, scene_of_view, cameras, environments)]
    tensors = (*inputs, rgb, alpha, depth, shade)
    numbers = (size, size, prims_per_scene, supersample)
    if prims.is_cuda:
        launch(tensors, numbers, views, size, prims_per_scene)
    else:
        pointers = [ctypes.c_void_p(t.data_ptr()) for t in tensors]
        host_library().cast_host(*pointers, *map(ctypes.c_int, (*numbers, views)))
    return rgb, alpha, depth, shade


def launch(tensors, numbers, views, size, prims_per_scene):
    import cupy

    blocks = (size + BLOCK - 1) // BLOCK
    shared_bytes = prims_per_scene * 5 * 4
    arguments = (*map(as_cupy, tensors), *map(np.int32, numbers))
    with cupy.cuda.ExternalStream(torch.cuda.current_stream().cuda_stream):
        kernel(shared_bytes)((blocks, blocks, views), (BLOCK, BLOCK, 1), arguments, shared_mem=shared_bytes)
