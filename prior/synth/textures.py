"""Textures in picture space: fur, foliage, stains, pebbles, clutter; what no pattern on a primitive looks like.

A bank of square pictures is made once from PyTorch's generator; every photo then draws its own cut-outs of it. They have
the statistics of photographs (spectra that fall with frequency, leaves of every size that cover each other: Lee, Mumford
and Huang 2001, "Occlusion models for natural images"; Baradad et al. 2021, "Learning to see by looking at noise").
"""

import math

import torch
import torch.nn.functional as F

from .cameras import fixed

SIZE = 256
LEAVES_EACH = 400


def make_bank(count, device):
    """[count, 3, SIZE, SIZE], about 0..1 with a mean near one half; three of four are spectral."""
    return torch.cat([spectral(count - count // 4, device), dead_leaves(count // 4, device)])


def spectral(n, device):
    """Noise of random slope, direction and colour; some of it cut into blotches, ridges or strands."""
    fy = torch.fft.fftfreq(SIZE, device=device)[:, None] * SIZE
    fx = torch.fft.rfftfreq(SIZE, device=device)[None] * SIZE

    def uniform(low, high):
        return torch.rand(n, 1, 1, device=device) * (high - low) + low

    turn = uniform(0, math.pi)
    along, aside = fx * turn.cos() + fy * turn.sin(), fy * turn.cos() - fx * turn.sin()
    # Strands: one direction is much smoother than the other.
    longer = torch.where(uniform(0, 1) < 0.45, torch.exp(uniform(0.5, 2.2)), torch.ones(n, 1, 1, device=device))
    radius = torch.hypot(along * longer, aside)
    slope, knee = uniform(0.9, 2.1), torch.exp(uniform(0, 3.5))
    amplitude = (radius + knee) ** -slope
    amplitude[:, 0, 0] = 0
    planes = torch.fft.irfft2(torch.fft.rfft2(torch.randn(n, 3, SIZE, SIZE, device=device)) * amplitude[:, None])
    planes = planes / planes.std((2, 3), keepdim=True).clamp(min=1e-6)
    # Light and dark far more than colour.
    chroma = uniform(0, 0.7)[:, None]
    planes = planes[:, :1] * (1 - chroma) + planes * chroma
    shape = torch.rand(n, 1, 1, 1, device=device)
    ridged = 1.2 - 2 * planes.abs()
    blotches = torch.tanh(planes * 6)
    planes = torch.where(shape < 0.2, ridged, torch.where(shape < 0.35, blotches, planes))
    return (0.5 + 0.22 * planes).clamp(0, 1)


def dead_leaves(n, device):
    """Ellipses and rectangles of all sizes thrown on each other, each with a shade of its own."""
    at = (torch.arange(SIZE, device=device) + 0.5) / SIZE
    picture = torch.rand(n, 3, 1, 1, device=device).expand(n, 3, SIZE, SIZE).clone()

    def uniform(low, high, *shape):
        return torch.rand(n, *shape, 1, 1, device=device) * (high - low) + low

    base, spread = uniform(0.15, 0.8, 3), uniform(0.05, 0.35, 1)
    smallest = uniform(math.log(0.008), math.log(0.05))
    square = uniform(0, 1) < 0.4
    for _ in range(LEAVES_EACH):
        # Sizes fall as their inverse cube, as those of things in photographs do.
        size = torch.exp(smallest) * (uniform(0, 1).clamp(min=4e-3)) ** -0.5
        turn, flat = uniform(0, math.pi), torch.exp(uniform(-0.9, 0))
        x, y = at[None, None] - uniform(-0.1, 1.1), at[None, :, None] - uniform(-0.1, 1.1)
        u, v = (x * turn.cos() + y * turn.sin()) / size, (y * turn.cos() - x * turn.sin()) / (size * flat)
        inside = torch.where(square, torch.maximum(u.abs(), v.abs()) < 0.85, u * u + v * v < 1)[:, None]
        shade = base + spread * torch.randn(n, 1, 1, 1, device=device) + 0.35 * spread * torch.randn(n, 3, 1, 1, device=device)
        lit = 1 + 0.25 * (u * torch.randn(n, 1, 1, device=device)).clamp(-1, 1)[:, None]
        picture = torch.where(inside, shade * lit, picture)
    return picture.clamp(0, 1)


def cut_outs(bank, n, size):
    """n pieces of the bank [n, 3, size, size], each of any scale, turn and aspect."""
    device = bank.device
    chosen = bank[torch.randint(len(bank), (n,), device=device)]
    scale = torch.exp(torch.rand(n, 2, device=device) * 0.5 + torch.rand(n, 1, device=device) * 1.8 - 1.3)
    turn = torch.rand(n, device=device) * 0.8 - 0.4
    theta = torch.stack([
        torch.stack([scale[:, 0] * turn.cos(), -scale[:, 1] * turn.sin(), torch.rand(n, device=device) - 0.5], 1),
        torch.stack([scale[:, 0] * turn.sin(), scale[:, 1] * turn.cos(), torch.rand(n, device=device) - 0.5], 1),
    ], 1)  # fmt: skip
    grid = F.affine_grid(theta, (n, 3, size, size), align_corners=False)
    return F.grid_sample(chosen, grid, mode="bilinear", padding_mode="reflection", align_corners=False)


def textured(photo, alpha, depth, bank):
    """A photo [n, 3, S, S] in sRGB with textures on the subject, on what is around, and for the far background.

    alpha [n, S, S]: coverage by the subject; depth [n, S, S], 0 = sky. Every picture gets some of it, a part none.
    """
    n, size = alpha.shape[0], alpha.shape[-1]
    device = photo.device

    def uniform(low, high):
        return torch.rand(n, 1, 1, 1, device=device) * (high - low) + low

    def strength(chance, most):
        return torch.where(uniform(0, 1) < chance, most * uniform(0, 1) ** 1.5, torch.zeros(n, 1, 1, 1, device=device))

    def relief():
        piece = cut_outs(bank, n, size)
        piece = piece - piece.mean((2, 3), keepdim=True)
        colourful = uniform(0, 1) ** 2
        return piece * colourful + piece.mean(1, keepdim=True) * (1 - colourful)

    subject = alpha[:, None]
    sky = ((depth == 0)[:, None] & (subject < 0.5)).float()
    # Behind everything, clutter or foliage instead of sky: out of focus or not.
    behind = cut_outs(bank, n, size)
    soft = F.avg_pool2d(F.pad(behind, (4, 4, 4, 4), mode="replicate"), 9, 1)
    behind = torch.where(uniform(0, 1) < 0.4, soft, behind)
    tint = torch.exp(0.35 * torch.randn(n, 3, 1, 1, device=device))
    tint = torch.where(uniform(0, 1) < 0.4, tint * green(n, device), tint)
    photo = photo + sky * strength(0.3, 1.4).clamp(max=1) * ((behind * tint).clamp(0, 1) - photo)
    # Reliefs: fur, dirt, leaves and the like multiply what is there.
    ground, own = relief(), relief()
    # Now and then both are alike: a stone on stones, a hare in dry grass.
    own = torch.where(uniform(0, 1) < 0.2, ground, own)
    photo = photo * torch.exp(subject * strength(0.6, 2.0) * own)
    around = (1 - subject) * (1 - sky)
    photo = photo * torch.exp(around * strength(0.6, 2.2) * ground)
    # One veil over everything now and then: light through leaves, stains, reflections.
    return (photo * torch.exp(strength(0.12, 1.2) * ground.flip(3))).clamp(0, 1)


def green(n, device):
    """Factors [n, 3, 1, 1] of foliage and dry grass."""
    leaf = fixed((0.75, 1.0, 0.45), device)
    dry = fixed((1.05, 0.9, 0.55), device)
    mixed = torch.rand(n, 1, device=device)
    return (leaf * (1 - mixed) + dry * mixed)[:, :, None, None]
