"""Faults that masks of photographs have: what the networks are shown in place of the true ones."""

import torch
import torch.nn.functional as F


def damaged(alpha):
    """Masks [n, 1, S, S] as a network would find them: a little wide, tight or soft, as a whole or here and there, some cut off at one
    side."""
    n, _, size, _ = alpha.shape
    device = alpha.device
    soft = F.avg_pool2d(F.pad(alpha, (1, 1, 1, 1)), 3, 1)
    shift = 0.45 * torch.randn(n, 1, 1, 1, device=device).clamp(-1.5, 1.5)
    gain = torch.exp(torch.rand(n, 1, 1, 1, device=device) * 1.5)
    moved = ((soft - 0.5 + 0.5 * shift) * gain + 0.5).clamp(0, 1) * (soft > 0.02)
    chosen = torch.rand(n, 1, 1, 1, device=device)
    mask = torch.where(chosen < 0.3, alpha, torch.where(chosen < 0.6, moved, wavering(alpha)))
    centres = (torch.arange(size, device=device) + 0.5) / size
    side = torch.randint(4, (n, 1, 1, 1), device=device)
    across, down = centres[None, None, None, :], centres[None, None, :, None]
    along = torch.where(side == 0, across, torch.where(side == 1, 1 - across, torch.where(side == 2, down, 1 - down)))
    cut = torch.where(torch.rand(n, 1, 1, 1, device=device) < 0.1, torch.rand(n, 1, 1, 1, device=device) * 0.2, -1.0)
    return mask * (along > cut + 0.06 * (cut > 0))


def wavering(alpha):
    """Masks [n, 1, S, S] whose edge runs a little outside the true one for a while and then inside, with a hole now and
    then; half of them lack what is thin."""
    n, _, size, _ = alpha.shape
    device = alpha.device
    wide = size // 96 + 1
    cells = int(torch.randint(max(size // 32, 2), max(size // 8, 3), ()))
    field = F.interpolate(torch.randn(n, 1, cells, cells, device=device), size=size, mode="bicubic")
    soft = F.avg_pool2d(F.pad(alpha, (wide,) * 4), 2 * wide + 1, 1)
    gain = torch.exp(1 + torch.rand(n, 1, 1, 1, device=device) * 1.5)
    amount = 0.25 * torch.rand(n, 1, 1, 1, device=device)
    mask = ((soft - 0.5 + amount * field) * gain + 0.5).clamp(0, 1)
    thin = (alpha - grown(shrunk(alpha, wide), wide)).clamp(min=0)
    mask = torch.where(torch.rand(n, 1, 1, 1, device=device) < 0.5, torch.maximum(mask, thin), mask)
    return mask * (grown(alpha, wide) > 0.02)


def leaked(photo, mask, alpha, leaky):
    """Photos [n, 3, S, S] and masks [n, 1, S, S] with a piece of shaded ground beside the subject's foot, where leaky [n].

    The piece lies within a tenth of the picture of the subject's coverage alpha [n, 1, S, S], in its lower part.
    """
    n, _, size, _ = alpha.shape
    device = alpha.device
    reach = size * 6 // 128
    near = grown(grown(alpha, reach), reach) - alpha
    rows = (torch.arange(size, device=device) + 0.5)[None, None, :, None]
    foot = torch.where(alpha > 0.1, rows, torch.zeros_like(rows)).amax((2, 3), keepdim=True)
    head = torch.where(alpha > 0.1, rows, torch.full_like(rows, float(size))).amin((2, 3), keepdim=True)
    high = torch.rand(n, 1, 1, 1, device=device) * 0.4
    low = (rows > foot - high * (foot - head)).float()
    shape = F.interpolate(torch.randn(n, 1, 6, 6, device=device), size=size, mode="bicubic")
    threshold = torch.rand(n, 1, 1, 1, device=device) * 0.8
    piece = near.clamp(min=0) * low * torch.sigmoid((shape - threshold) * 20) * leaky[:, None, None, None]
    grain = F.interpolate(torch.randn(n, 1, 32, 32, device=device), size=size, mode="bilinear")
    shade = torch.rand(n, 3, 1, 1, device=device) * 0.15 + torch.rand(n, 1, 1, 1, device=device) ** 1.5 * 0.55
    ground = (shade * (1 + 0.12 * grain)).clamp(0, 1)
    return photo * (1 - piece) + ground * piece, torch.maximum(mask, piece)


def grown(mask, by):
    """The largest of masks [n, 1, S, S] within a square of 2 `by` + 1 pixels, row by row and then column by column."""
    return F.max_pool2d(F.max_pool2d(mask, (1, 2 * by + 1), 1, (0, by)), (2 * by + 1, 1), 1, (by, 0))


def shrunk(mask, by):
    """The smallest of masks [n, 1, S, S] within a square of 2 `by` + 1 pixels."""
    return -grown(-mask, by)


def closed(mask, by):
    """Masks [n, 1, S, S] without gaps up to 2 `by` pixels wide."""
    return shrunk(grown(mask, by), by)


def without_openings(mask):
    """Masks [n, 1, S, S] whose openings, up to a random width of at most a fifth of the picture, are filled: a cab's windows, the room
    between legs or branches."""
    widest = mask.shape[-1] // 40
    by = int(torch.randint(2, max(widest, 2) + 1, ()))
    return F.interpolate(closed(F.max_pool2d(mask, 4), by), scale_factor=4, mode="bilinear")


def worn(rough, alpha):
    """Rough masks [n, 1, S, S] with the faults that masks of real photos have: worse than those of generated ones.

    Thin parts lost, gaps and openings filled, the edge moved here and there, pieces of what stands beside the subject taken in, or parts
    of the subject (alpha [n, 1, S, S]) left out.
    """
    n, _, size, _ = rough.shape
    device = rough.device

    def chance(share):
        return torch.rand(n, 1, 1, 1, device=device) < share

    def field(cells):
        return F.interpolate(torch.randn(n, 1, cells, cells, device=device), size=size, mode="bicubic")

    few = size // 48
    rough = torch.where(chance(0.25), grown(shrunk(rough, few), few), rough)
    rough = torch.where(chance(0.15), closed(rough, few), rough)
    rough = torch.where(chance(0.2), torch.maximum(rough, 0.9 * without_openings(rough)), rough)
    around = F.avg_pool2d(grown(grown(rough, 12), 12), 9, 1, 4)
    near = (around - F.avg_pool2d(shrunk(rough, 12), 9, 1, 4)).clamp(0, 1)
    moved = (rough + 0.7 * field(12) * near).clamp(0, 1)
    rough = torch.where(chance(0.4), moved, rough)
    piece = torch.sigmoid((field(7) - 1.0) * 12)
    rough = torch.where(chance(0.2), torch.maximum(rough, piece * around * 0.9), rough)
    cells = int(torch.randint(3, 9, ()))
    rough = torch.where(chance(0.35), rough * (1 - torch.sigmoid((field(cells) - 1.0) * 12) * alpha), rough)
    # What the program doubts more than this it has taken away before it looks closely.
    rough = torch.where(chance(0.5), rough * (rough > 0.35), rough)
    return torch.where(chance(0.3), F.avg_pool2d(F.pad(rough, (4,) * 4, mode="replicate"), 9, 1), rough)
