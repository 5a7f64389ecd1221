"""Still water before a subject: below a line the picture shows what is above it once more, upside down."""

from typing import NamedTuple

import torch
import torch.nn.functional as F

SHARE = 0.06


class Water(NamedTuple):
    """below [n, S]: how far each row of a picture lies below the waterline, shares of its height, at most 0 above it and where there
    is no water; murk [n, 3, 1, 1]: the water's own colour, sRGB; clear [n]: share of the light that it reflects;
    grid [n, S, S, 2]: what each pixel reflects, -1..1, waves included."""

    below: torch.Tensor
    murk: torch.Tensor
    clear: torch.Tensor
    grid: torch.Tensor


def waters(alpha):
    """Water for some of the pictures of subjects alpha [n, S, S]: it hides at most a quarter of a subject's height, often next to
    nothing. Waves are noise that is long across and short along the picture, and grows towards the camera."""
    n, size = alpha.shape[0], alpha.shape[-1]

    def draw(*shape):
        return torch.rand(n, *shape, device=alpha.device)

    def noise(rows, columns):
        coarse = torch.randn(n, 1, rows, columns, device=alpha.device)
        return F.interpolate(coarse, size=size, mode="bilinear", align_corners=False)[:, 0]

    rows = alpha.amax(2) > 0.5
    top = rows.float().argmax(1) / size
    bottom = 1 - rows.flip(1).float().argmax(1) / size
    line = bottom - 0.25 * draw() ** 2 * (bottom - top)
    there = (draw() < SHARE) & rows.any(1)
    centres = (torch.arange(size, device=alpha.device) + 0.5) / size
    below = torch.where(there[:, None], (centres - line[:, None]).clamp(min=0), 0.0)

    reach = (0.02 * draw(1, 1) ** 3) * (0.2 + 3 * below)[:, :, None]
    down = (centres - 2 * below)[:, :, None] + reach * noise(size // 6, 5)
    across = centres[None, None, :] + 0.4 * reach * noise(size // 5, 8)
    murk = (0.6 * draw(1, 1, 1) + 0.1 * torch.randn(n, 3, 1, 1, device=alpha.device)).clamp(0, 1)
    return Water(below, murk, 0.45 + 0.55 * draw(), torch.stack([across, down.clamp(min=0)], -1) * 2 - 1)


def flooded(rgb, water):
    """Pictures rgb [n, 3 k, S, S], k of each scene, with the water in them."""
    mirrored = F.grid_sample(rgb, water.grid, mode="bilinear", padding_mode="reflection", align_corners=False)
    # Steeper down the less is reflected (Fresnel).
    share = (water.clear[:, None] * (1 - 0.5 * water.below))[:, None, :, None]
    surface = share * mirrored + (1 - share) * water.murk.repeat(1, rgb.shape[1] // 3, 1, 1)
    return torch.where((water.below > 0)[:, None, :, None], surface, rgb)


def above_water(alpha, shade, water):
    """Coverage and shade [n, S, S] once the water is there: what it hides is no subject any more, and the subject's mirror image
    is, like its shadow, what must not be taken for it."""
    wet = (water.below > 0)[:, :, None]
    mirrored = F.grid_sample(alpha[:, None], water.grid, mode="bilinear", align_corners=False)[:, 0]
    return torch.where(wet, torch.zeros_like(alpha), alpha), torch.where(wet, mirrored, shade)
