"""What several parts of the generator draw alike."""

import torch

from .layout import COLOURS, PATTERN_OFFSET


def uniform(like, low, high):
    """One number a row of `like` [n, ...], on its device."""
    return torch.rand(len(like), device=like.device) * (high - low) + low


def recolour(prims):
    """Fresh colours on known shapes, [n, P, 36] -> [n, P, 36]: per object, channels permuted and colours scaled."""
    n = len(prims)
    device = prims.device
    order = torch.argsort(torch.rand(n, 3, device=device), 1)
    out = prims.clone()
    gain = torch.exp(0.35 * torch.randn(n, 1, 1, device=device))
    permuted = (torch.rand(n, device=device) < 0.4)[:, None, None]
    for columns in COLOURS:
        colour = prims[..., columns]
        shuffled = torch.gather(colour, 2, order[:, None].expand(-1, colour.shape[1], -1))
        colour = torch.where(permuted, shuffled, colour)
        out[..., columns] = (colour * gain).clamp(0.005, 0.98)
    out[..., PATTERN_OFFSET] += 50 * torch.rand(n, 1, device=device)
    return out
