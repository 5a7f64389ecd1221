"""Random light and surroundings: sun, sky, ground, backdrop; one row a scene as `layout` describes it."""

import torch

from .layout import ENVIRONMENT_FLOATS

# Open sky, landscape, wall, room of noise, clutter.
BACKDROP_CHANCES = [0.18, 0.3, 0.2, 0.07, 0.25]


def environments(n, ground, device="cuda"):
    """Rows [n, 32] for n scenes; ground [n] is the height of each scene's ground. Colours in linear light."""

    def uniform(low, high, count=1):
        return torch.rand(n, count, device=device) * (high - low) + low

    def normal():
        return torch.randn(n, 3, device=device)

    azimuth = uniform(0, 6.283)
    elevation = uniform(0.25, 1.45)
    sun = torch.cat([elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()], 1)
    sunlight = uniform(0.4, 1.5) * (1 + 0.25 * normal()).clamp(0.3, 1.6)

    blue = torch.cat([uniform(0.2, 0.6), uniform(0.35, 0.75), uniform(0.5, 1)], 1) * uniform(0.5, 1.1)
    grey = uniform(0.3, 0.95)
    zenith = torch.where(uniform(0, 1) < 0.4, grey + 0.05 * normal(), blue)
    horizon = (zenith * uniform(0.8, 1.4) + uniform(0, 0.3)).clamp(0, 1)

    ground_a = (uniform(0.05, 0.6) + 0.12 * normal()).clamp(0.02, 0.95)
    green = torch.tensor([0.7, 1.1, 0.5], device=device)
    ground_a = torch.where(uniform(0, 1) < 0.3, ground_a * green, ground_a)
    ground_b = (ground_a * uniform(0.4, 1.7) + 0.05 * normal()).clamp(0.02, 0.95)

    chances = torch.tensor(BACKDROP_CHANCES, device=device)
    backdrop = torch.multinomial(chances, n, True)[:, None].float()
    wall_azimuth = uniform(0, 6.283)
    hills = (uniform(0.05, 0.5) + 0.1 * normal()).clamp(0.02, 0.9)
    rest = [
        torch.exp(uniform(-0.5, 2.5)),  # ground frequency
        uniform(0.25, 0.9),  # ambient light
        (uniform(0, 1) < 0.2).float(),  # tiled ground
        backdrop,
        uniform(0, 500).floor(),  # seed of the noise
        ground[:, None],
        wall_azimuth.cos(),
        wall_azimuth.sin(),
        uniform(1.5, 6),  # wall distance
        uniform(0, 1),  # clouds
        uniform(0, 2),  # hills
    ]
    rows = torch.cat([sun, sunlight, zenith, horizon, ground_a, ground_b, *rest, hills], 1)
    assert rows.shape[1] == ENVIRONMENT_FLOATS
    return rows.contiguous()
