"""Launches the ray-casting kernel on PyTorch's tensors and stream (CuPy compiles it at first use)."""

from functools import cache
from pathlib import Path

import cupy
import numpy as np
import torch

from .layout import FLOATS

SOURCES = ("columns.cuh", "shapes.cuh", "surfaces.cuh", "raycast.cu")
BLOCK = 16
DTYPES = {torch.float32: cupy.float32, torch.int32: cupy.int32}


@cache
def kernel():
    folder = Path(__file__).parent
    code = "\n".join((folder / name).read_text() for name in SOURCES)
    return cupy.RawModule(code=code, options=("--use_fast_math",)).get_function("cast")


def as_cupy(tensor):
    """The same memory, seen by CuPy."""
    memory = cupy.cuda.UnownedMemory(tensor.data_ptr(), tensor.numel() * tensor.element_size(), tensor)
    return cupy.ndarray(tuple(tensor.shape), DTYPES[tensor.dtype], cupy.cuda.MemoryPointer(memory, 0))


def cast(prims, counts, scene_of_view, cameras, environments, size, supersample=2):
    """Render square views of `size` pixels with supersample^2 rays a pixel.

    prims [S, P, 32] float32, counts [S] int32, scene_of_view [V] int32, cameras [V, 20], environments [S, 32]
    (CUDA tensors; rows as in `layout`). Returns rgb [V, 3, H, W] (sRGB 0..1; views of the subject alone are
    premultiplied in linear light), alpha [V, H, W] and depth [V, H, W] (camera z, 0 where there is nothing).
    """
    views = len(scene_of_view)
    prims_per_scene = prims.shape[1]
    rgb = torch.zeros(views, 3, size, size, device=prims.device)
    alpha = torch.zeros(views, size, size, device=prims.device)
    depth = torch.zeros(views, size, size, device=prims.device)
    inputs = [t.contiguous() for t in (prims, counts, scene_of_view, cameras, environments)]
    arrays = [as_cupy(t) for t in (*inputs, rgb, alpha, depth)]
    numbers = [np.int32(n) for n in (size, size, prims_per_scene, supersample)]
    blocks = (size + BLOCK - 1) // BLOCK
    shared_bytes = prims_per_scene * FLOATS * 4
    with cupy.cuda.ExternalStream(torch.cuda.current_stream().cuda_stream):
        kernel()((blocks, blocks, views), (BLOCK, BLOCK, 1), (*arrays, *numbers), shared_mem=shared_bytes)
    return rgb, alpha, depth
