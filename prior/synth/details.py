"""DetailNet's training batches: the scenes of `batches`, photographed again with the subject alone in the picture."""

from typing import NamedTuple

import torch
import torch.nn.functional as F

from .batches import points, seen_by, staged, subjects, taken, uniform
from .cameras import extent, fixed, magnified
from .lens import coarsened
from .masks import worn
from .textures import textured

# Of the subjects so many have thin or pierced parts, beyond their share of all objects.
SLENDER_SHARE = 0.35


class DetailBatch(NamedTuple):
    """photo [n, 3, S, S] sRGB 0..1, around the subject; rough [n, 1, S, S], a mask of it that is not fine; alpha, depth and
    shade [n, S, S] as in `SceneBatch`; before [n, S, S], the rough mask before it was worn."""

    photo: torch.Tensor
    rough: torch.Tensor
    alpha: torch.Tensor
    depth: torch.Tensor
    shade: torch.Tensor
    before: torch.Tensor


def detail_batch(pool, n, masks, size=384, seen=256):
    """The same scenes as in `scene_batch`, photographed again with the subject alone in the picture.

    `masks` is SceneNet's answer to a photo and point [n, 4, seen, seen]: a mask [n, 1, seen, seen].
    """
    stage = staged(pool, subjects(pool, n, SLENDER_SHARE), seen)
    rgb, alpha, depth, _ = seen_by(stage, stage.cameras, seen)
    paint = patches(rgb, alpha)
    rgb = painted(rgb, alpha, paint)
    photo = taken(textured(rgb, alpha, depth, pool.textures), rgb, alpha, depth, stage.daylight)
    whole = masks(torch.cat([photo, points(alpha, stage.pointed)], 1))
    # What the program looks at is the box of the rough mask; that may be too large or too small.
    found = (uniform(alpha, 0, 1) < 0.3) & ((whole[:, 0] > 0.5).flatten(1).sum(1) > 40)
    box = close_up(torch.where(found[:, None, None], whole[:, 0], alpha))
    rgb, alpha, depth, shade = seen_by(stage, magnified(stage.cameras, box, seen, size), size)
    rgb = painted(rgb, alpha, paint._replace(where=cut_out(paint.where, box, seen, size)))
    photo = taken(coarsened(textured(rgb, alpha, depth, pool.textures)), rgb, alpha, depth, stage.daylight)
    before = cut_out(whole, box, seen, size)
    return DetailBatch(photo, worn(before, alpha[:, None]), alpha, depth, shade, before[:, 0])


class Paint(NamedTuple):
    """Patches of other colours: where [n, 1, S, S], 0..1, on the subject where `on` [n] is 1 and around it where it is 0, and
    their colours [n, 3, 1, 1], sRGB."""

    where: torch.Tensor
    on: torch.Tensor
    colour: torch.Tensor


def patches(rgb, alpha):
    """Patches for pictures rgb [n, 3, S, S] with subjects alpha [n, S, S]: part of the subject looks like what is around it, or
    like nothing else, or part of what is around it looks like the subject. In four of ten pictures there are any.

    What belongs together in life is often not of one colour: faces, pied coats, markings, windows.
    """
    n, size = alpha.shape[0], alpha.shape[-1]
    device = rgb.device

    def draw(low, high):
        return torch.rand(n, 1, 1, 1, device=device) * (high - low) + low

    cells = 7
    field = F.interpolate(torch.randn(n, 1, cells, cells, device=device), size=size, mode="bicubic")
    where = torch.sigmoid((field - draw(-0.4, 0.8)) * torch.exp(draw(1.5, 4))) * (draw(0, 1) < 0.4)
    on = (draw(0, 1) < 0.75).float()
    other = alpha[:, None] * (1 - on) + (1 - alpha[:, None]) * on
    mean = (rgb * other).sum((2, 3), keepdim=True) / other.sum((2, 3), keepdim=True).clamp(min=1)
    like = mean * torch.exp(0.25 * torch.randn(n, 1, 1, 1, device=device))
    free = torch.rand(n, 3, 1, 1, device=device)
    return Paint(where, on[:, 0, 0, 0], torch.where(draw(0, 1) < 0.6, like, free))


def painted(rgb, alpha, paint):
    """Pictures rgb [n, 3, S, S] of subjects alpha [n, S, S] with patches; their light and shade stay."""
    on = paint.on[:, None, None, None]
    covered = alpha[:, None] * on + (1 - alpha[:, None]) * (1 - on)
    grey = rgb.mean(1, keepdim=True)
    usual = (grey * covered).sum((2, 3), keepdim=True) / covered.sum((2, 3), keepdim=True).clamp(min=1)
    lit = (grey / usual.clamp(min=0.02)).clamp(0.2, 2.5)
    return rgb + paint.where * covered * ((paint.colour * lit).clamp(0, 1) - rgb)


def close_up(mask):
    """Boxes [n, 4] (left, top, right, bottom; pixels) around masks [n, S, S] with more or less room; whole pictures where none is."""
    n, size = mask.shape[0], mask.shape[-1]
    x0, x1 = extent(mask.amax(1) > 0.3)
    y0, y1 = extent(mask.amax(2) > 0.3)
    empty = (x1 <= x0) | (y1 <= y0)
    low, high = torch.stack([x0, y0], 1), torch.stack([x1, y1], 1)
    longest = (high - low).amax(1, keepdim=True)
    room = torch.rand(2, n, 2, device=mask.device) * 0.38 - 0.03
    low, high = low - room[0] * longest, high + room[1] * longest
    # Neither too narrow nor too small to say anything.
    least = (high - low).amax(1, keepdim=True) * uniform(mask, 0.5, 1)[:, None]
    more = (torch.maximum(least, torch.full_like(least, size / 12)) - (high - low)).clamp(min=0) / 2
    low, high = (low - more).clamp(0, size - 8), (high + more).clamp(8, size)
    high = torch.maximum(high, low + 8)
    box = torch.cat([low, high], 1)
    return torch.where(empty[:, None], fixed((0.0, 0.0, 1.0, 1.0), mask.device) * size, box)


def cut_out(mask, box, seen, size):
    """The box [n, 4] of masks [n, 1, seen, seen], resampled to `size` pixels."""
    half = (box[:, 2:] - box[:, :2]) / seen
    middle = (box[:, 2:] + box[:, :2]) / seen - 1
    theta = torch.zeros(len(mask), 2, 3, device=mask.device)
    theta[:, 0, 0], theta[:, 1, 1], theta[:, :, 2] = half[:, 0], half[:, 1], middle
    grid = F.affine_grid(theta, (len(mask), 1, size, size), align_corners=False)
    return F.grid_sample(mask, grid, mode="bilinear", padding_mode="border", align_corners=False)
