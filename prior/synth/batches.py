"""Training batches: random objects, freshly coloured, in random surroundings, seen by random cameras.

Every random draw on the GPU comes from PyTorch's global generator, in a fixed order.
"""

import math
from multiprocessing import Pool as Processes
from typing import NamedTuple

import numpy as np
import torch
import torch.nn.functional as F

from .cameras import crop, inverses, look_at, matrices, orbit, pack, rolled
from .environments import environments
from .layout import CENTRE, COLOURS, FLOATS, HALF_SIZE, PATTERN_OFFSET, PRIMS, SHIFT, SUBJECT
from .objects import make_object
from .raycast import cast

# Objects that may stand around the subject of a photo.
DISTRACTORS = 5
GREY = 0.5


class Pool(NamedTuple):
    """Objects to draw from: prims [N, PRIMS, 32], counts [N] int32, grounds [N] (height of the ground)."""

    prims: torch.Tensor
    counts: torch.Tensor
    grounds: torch.Tensor


def make_pool(first_seed, count, processes, device="cuda"):
    """The objects of `count` consecutive seeds."""
    seeds = range(first_seed, first_seed + count)
    with Processes(processes) as workers:
        made = workers.map(make_object, seeds, chunksize=256)
    return Pool(
        prims=torch.from_numpy(np.stack([rows for rows, _, _ in made])).to(device),
        counts=torch.tensor([used for _, used, _ in made], dtype=torch.int32, device=device),
        grounds=torch.tensor([ground for _, _, ground in made], dtype=torch.float32, device=device),
    )


def uniform(n, low, high, device="cuda"):
    return torch.rand(n, device=device) * (high - low) + low


def recolour(prims):
    """Fresh colours on known shapes, [n, P, 32] -> [n, P, 32]: per object, channels permuted and colours scaled."""
    n = len(prims)
    device = prims.device
    order = torch.argsort(torch.rand(n, 3, device=device), 1)
    out = prims.clone()
    gain = torch.exp(0.35 * torch.randn(n, 1, 1, device=device))
    permuted = (torch.rand(n, device=device) < 0.6)[:, None, None]
    for columns in COLOURS:
        colour = prims[..., columns]
        shuffled = torch.gather(colour, 2, order[:, None].expand(-1, colour.shape[1], -1))
        colour = torch.where(permuted, shuffled, colour)
        out[..., columns] = (colour * gain).clamp(0.005, 0.98)
    out[..., PATTERN_OFFSET] += 50 * torch.rand(n, 1, device=device)
    return out


# ---------------------------------------------------------------- photos of scenes


class SceneBatch(NamedTuple):
    """photo [n, 3, S, S] sRGB 0..1; alpha [n, S, S], coverage by the subject; depth [n, S, S], 0 = sky."""

    photo: torch.Tensor
    alpha: torch.Tensor
    depth: torch.Tensor


def scene_batch(pool, n, size=256):
    """Photos of a subject near the middle, with other objects on the same ground."""
    device = pool.prims.device
    chosen = torch.randint(len(pool.prims), (n,), device=device)
    subject = recolour(pool.prims[chosen])
    azimuth = uniform(n, 0, 6.283)
    elevation = uniform(n, -0.03, 0.8)
    prims = torch.zeros(n, PRIMS * (1 + DISTRACTORS), FLOATS, device=device)
    prims[:, :PRIMS] = subject
    counts = pool.counts[chosen].clone().long()
    for _ in range(DISTRACTORS):
        add_distractor(prims, counts, pool, pool.grounds[chosen], azimuth)
    cameras = photo_cameras(azimuth, elevation, pool.grounds[chosen], size)
    surroundings = environments(n, pool.grounds[chosen])
    each = torch.arange(n, device=device, dtype=torch.int32)
    rgb, alpha, depth = cast(prims, counts.int(), each, cameras, surroundings, size, 2)
    return SceneBatch(photo_noise(rgb), alpha, depth)


def add_distractor(prims, counts, pool, ground, azimuth):
    """In just under half of the scenes, one more object behind or beside the subject; prims and counts grow in place.

    prims [n, P, 32], counts [n] int64, ground [n], azimuth [n] of the camera in radians.
    """
    n, capacity, _ = prims.shape
    device = prims.device
    chosen = torch.randint(len(pool.prims), (n,), device=device)
    rows = recolour(pool.prims[chosen])
    scale = torch.exp(uniform(n, -1.1, 0.9))
    near = torch.rand(n, device=device) < 0.3
    distance = torch.where(near, uniform(n, 0.9, 1.6), uniform(n, 1.5, 6))
    distance = distance * (0.6 + 0.5 * scale) + 0.3 * scale
    bearing = azimuth + math.pi + uniform(n, -1, 1) * torch.where(near, 2.4, 1.4)
    present = torch.rand(n, device=device) < 0.45
    up = ground - pool.grounds[chosen] * scale
    offset = torch.stack([distance * bearing.cos(), distance * bearing.sin(), up], 1)
    rows[..., CENTRE] = rows[..., CENTRE] * scale[:, None, None] + offset[:, None]
    rows[..., HALF_SIZE] *= scale[:, None, None]
    rows[..., SHIFT] *= scale[:, None, None]
    rows[..., SUBJECT] = 0

    added = torch.where(present, pool.counts[chosen].long(), torch.zeros_like(counts))
    slot = torch.arange(PRIMS, device=device)[None]
    target = counts[:, None] + slot
    # Rows that are not used land on the last slot, which no scene reaches.
    target = torch.where(slot < added[:, None], target, torch.full_like(target, capacity - 1))
    prims.scatter_(1, target[..., None].expand(-1, -1, FLOATS), rows)
    counts += added


def photo_cameras(azimuth, elevation, ground, size):
    """Hand-held cameras: above the ground, roughly at the subject, slightly rolled; the subject small to overfull."""
    n = len(azimuth)
    device = azimuth.device
    fov = uniform(n, 0.35, 1.2)
    distance = 1 / torch.tan(fov / 2) / torch.exp(uniform(n, -1.05, 0.42)) + 0.25
    eye = orbit(azimuth, elevation, distance)
    eye[:, 2] = torch.maximum(eye[:, 2], ground + 0.12)
    rotation, translation = look_at(eye, target=torch.randn(n, 3, device=device) * 0.14)
    rotation, translation = rolled(rotation, translation, torch.randn(n, device=device) * 0.05)
    return pack(rotation, translation, fov, size, subject_only=False)


def photo_noise(photo):
    """What cameras do to light [n, 3, H, W]: gamma, exposure, white balance, blur or sharpening, noise."""
    n = len(photo)
    device = photo.device

    def normal(channels, sigma):
        return torch.randn(n, channels, 1, 1, device=device) * sigma

    photo = photo.clamp(1e-4, 1) ** torch.exp(normal(1, 0.15))
    photo = photo * torch.exp(normal(1, 0.12) + normal(3, 0.04))
    choice = torch.rand(n, 1, 1, 1, device=device)
    blurred = F.avg_pool2d(F.pad(photo, (1, 1, 1, 1), mode="replicate"), 3, 1)
    sharpened = torch.where(choice > 0.75, photo + 0.7 * (photo - blurred), photo)
    photo = torch.where(choice < 0.3, blurred, sharpened)
    noise = torch.randn_like(photo)
    return (photo + noise * (0.03 * torch.rand(n, 1, 1, 1, device=device) ** 2)).clamp(0, 1)


# ---------------------------------------------------------------- subjects from many sides


class SplatBatch(NamedTuple):
    """What SplatNet sees and what it should have answered.

    rgba [n, 4, S, S]: subject on grey and mask. views [n, V, 4, 4]: from the canonical camera's frame to each truth
    view; the first one is the canonical camera itself. colour [n, V, 3, S, S] (sRGB, premultiplied), alpha
    [n, V, 1, S, S], depth [n, V, S, S]. elevation [n] in radians. empty [n]: the crop shows nothing.
    """

    rgba: torch.Tensor
    views: torch.Tensor
    colour: torch.Tensor
    alpha: torch.Tensor
    depth: torch.Tensor
    elevation: torch.Tensor
    empty: torch.Tensor


def splat_batch(pool, n, fov, distance, size=128, views=4):
    """Crops of subjects photographed anyhow, and `views` truth views by cameras of `fov` radians at `distance`."""
    device = pool.prims.device
    chosen = torch.randint(len(pool.prims), (n,), device=device)
    prims = recolour(pool.prims[chosen])
    counts = pool.counts[chosen]
    azimuth = uniform(n, 0, 6.283)
    elevation = uniform(n, -0.1, 0.9)
    photo_fov = uniform(n, 0.2, 1.0)
    rotation, translation = look_at(orbit(azimuth, elevation, 1.02 / torch.sin(photo_fov / 2)))
    # The ground lies far below: nothing but the subject is in the picture, and nothing shades it from below.
    surroundings = environments(n, pool.grounds[chosen] - 1e3)
    each = torch.arange(n, device=device, dtype=torch.int32)

    probe = pack(rotation, translation, photo_fov * 1.1, 64, subject_only=True)
    fill = uniform(n, 0.82, 0.94)
    _, coarse, _ = cast(prims, counts, each, probe, surroundings, 64, 1)
    cameras, empty = crop(probe, coarse, size, fill)
    rgb, alpha, _ = cast(prims, counts, each, cameras, surroundings, size, 2)
    alpha = alpha[:, None]
    photo = photo_noise(on_grey(rgb, alpha))
    rgba = torch.cat([photo * (alpha > 0.02) + GREY * (alpha <= 0.02), alpha], 1)

    canonical = look_at(orbit(azimuth, elevation, torch.full_like(azimuth, distance)))
    rotation, translation = truth_cameras(azimuth, elevation, distance, views)
    truth_fov = torch.full((n * views,), fov, device=device)
    cameras = pack(rotation.reshape(-1, 3, 3), translation.reshape(-1, 3), truth_fov, size, subject_only=True)
    rgb, truth_alpha, depth = cast(prims, counts, each.repeat_interleave(views), cameras, surroundings, size, 2)
    rgb = rgb.reshape(n, views, 3, size, size)
    truth_alpha = truth_alpha.reshape(n, views, 1, size, size)
    return SplatBatch(
        rgba=rgba,
        views=matrices(rotation, translation) @ inverses(*canonical)[:, None],
        colour=premultiplied(rgb, truth_alpha),
        alpha=truth_alpha,
        depth=depth.reshape(n, views, size, size),
        elevation=elevation,
        empty=empty,
    )


def truth_cameras(azimuth, elevation, distance, views):
    """The photo's own side, one near it, the others anywhere; rotation [n, V, 3, 3], translation [n, V, 3]."""
    n = len(azimuth)
    around = [azimuth, azimuth + uniform(n, -0.9, 0.9)]
    around += [uniform(n, 0, 6.283) for _ in range(views - 2)]
    above = [elevation] + [uniform(n, -0.25, 1.0) for _ in range(views - 1)]
    around = torch.stack(around, 1)
    return look_at(orbit(around, torch.stack(above, 1), torch.full_like(around, distance)))


def on_grey(rgb, alpha):
    """A view of the subject alone (premultiplied in linear light, gamma-encoded) over grey, sRGB."""
    linear = rgb.clamp(min=0) ** 2.2 + (1 - alpha) * GREY**2.2
    return linear.clamp(1e-6, 1) ** (1 / 2.2)


def premultiplied(rgb, alpha):
    """The same view premultiplied in sRGB, as splatting blends it."""
    linear = (rgb**2.2 / alpha.clamp(min=1e-3)).clamp(0, 1)
    return torch.where(alpha > 1e-3, linear ** (1 / 2.2), torch.zeros_like(rgb)) * alpha
