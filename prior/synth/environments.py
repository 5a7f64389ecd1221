"""Random light and surroundings: sun, sky, ground, backdrop; one row a scene as `layout` describes it."""

import torch

from .cameras import fixed
from .layout import (
    EARTH,
    ENVIRONMENT_FLOATS,
    GRASS,
    NO_CASTER,
    NOISE_ROOM,
    OPEN_SKY,
    PLANKED,
    ROOM,
    RUNWAY,
    TREES,
    WALL,
    WATER,
)

# Open sky, landscape, wall, room of noise, clutter, trees, town, room.
BACKDROP_CHANCES = [0.16, 0.16, 0.18, 0.04, 0.11, 0.16, 0.13, 0.06]
# Earth, tiles, paving, grass, water, planks, runway.
GROUND_CHANCES = [0.36, 0.1, 0.15, 0.18, 0.06, 0.1, 0.05]
# Clear, overcast, low sun, night, studio.
WEATHER_CHANCES = [0.37, 0.24, 0.15, 0.07, 0.17]
DAY_CHANCES = [0.68, 0.14, 0.18, 0, 0]
CLEAR, OVERCAST, LOW_SUN, NIGHT, STUDIO = range(5)
# Asphalt, two concretes, gravel, sand, soil; linear light.
NATURAL_GROUNDS = (
    (0.09, 0.09, 0.1),
    (0.2, 0.2, 0.2),
    (0.42, 0.4, 0.37),
    (0.3, 0.27, 0.23),
    (0.5, 0.4, 0.27),
    (0.2, 0.13, 0.08),
)
# What out of the picture casts a shadow into it where the sun shines: nothing, a roofline, a tree's crown, posts.
CASTER_CHANCES = [0.76, 0.08, 0.13, 0.03]
# Patterns of walls: none, bricks, planks, façade, patchwork, windows, ribs, checker, hedge (-1).
WALL_KINDS = [0, 0, 0, 8, 8, 10, 15, 16, 3, 18, 4, -1, -1]


def environments(n, ground, device="cuda", daylight=None):
    """Rows [n, 40] for n scenes; ground [n] is the height of each scene's ground. Colours in linear light.

    Where `daylight` [n] is set, light and ground are those of most outdoor photos: sun and sky in their usual measure on
    asphalt, concrete, gravel, sand, soil or grass.
    """
    day = torch.zeros(n, 1, dtype=torch.bool, device=device) if daylight is None else daylight[:, None]

    def uniform(low, high, count=1):
        return torch.rand(n, count, device=device) * (high - low) + low

    def normal():
        return torch.randn(n, 3, device=device)

    def drawn(chances):
        bounds = fixed(tuple(sum(chances[:i]) for i in range(1, len(chances))), device)
        return torch.bucketize(uniform(0, 1), bounds)

    weather = torch.where(day, drawn(DAY_CHANCES), drawn(WEATHER_CHANCES))
    dull, low, night, studio = (weather == kind for kind in (OVERCAST, LOW_SUN, NIGHT, STUDIO))
    azimuth = uniform(0, 6.283)
    elevation = torch.where(low, uniform(0.06, 0.35), uniform(0.25, 1.45))
    sun = torch.cat([elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()], 1)
    sunlight = uniform(0.4, 1.5) * (1 + 0.2 * normal()).clamp(0.3, 1.6)
    sunlight = torch.where(day, uniform(0.9, 1.9) * fixed((1.05, 1.0, 0.92), device), sunlight)
    warm = fixed((1.25, 0.9, 0.6), device)
    sunlight = torch.where(low, sunlight * warm, sunlight)
    sunlight = torch.where(dull, sunlight * uniform(0, 0.25), sunlight)
    sunlight = torch.where(night, sunlight * uniform(0, 0.5), sunlight)
    sun_size = torch.where(dull | studio, uniform(0.1, 0.5), uniform(0.0, 0.08))
    # The sun's own disc is 0.005 wide: shadows on clear days have hard edges.
    sun_size = torch.where(~(dull | studio) & (uniform(0, 1) < 0.7), uniform(0.002, 0.012), sun_size)

    blue = torch.cat([uniform(0.2, 0.6), uniform(0.35, 0.75), uniform(0.5, 1)], 1) * uniform(0.5, 1.1)
    grey = uniform(0.3, 0.95)
    zenith = torch.where((uniform(0, 1) < 0.25) | dull, grey + 0.04 * normal(), blue)
    horizon = (zenith * uniform(0.8, 1.4) + uniform(0, 0.3)).clamp(0, 1)
    sunset = torch.cat([uniform(0.6, 1), uniform(0.3, 0.7), uniform(0.1, 0.5)], 1)
    horizon = torch.where(low & (uniform(0, 1) < 0.6), sunset, horizon)
    zenith = torch.where(night, zenith * uniform(0.02, 0.35), zenith)
    horizon = torch.where(night, horizon * uniform(0.05, 0.6), horizon)

    ground_a = (uniform(0.05, 0.6) + 0.1 * normal()).clamp(0.02, 0.95)
    green = fixed((0.55, 1.1, 0.35), device)
    ground_kind = drawn(GROUND_CHANCES)
    ground_kind = torch.where(uniform(0, 1) < 0.03, torch.full_like(ground_kind, EARTH), ground_kind)
    grassy = (ground_kind == GRASS) & (uniform(0, 1) < 0.85)
    ground_a = torch.where(grassy, uniform(0.08, 0.5) * green * (1 + 0.15 * normal()), ground_a)
    wooden = (ground_kind == PLANKED) & (uniform(0, 1) < 0.7)
    wood = fixed((1.3, 0.8, 0.45), device)
    ground_a = torch.where(wooden, uniform(0.08, 0.5) * wood, ground_a).clamp(0.02, 0.95)
    which = torch.randint(len(NATURAL_GROUNDS), (n,), device=device)
    runway = ground_kind == RUNWAY  # asphalt or concrete
    natural = fixed(NATURAL_GROUNDS, device)[torch.where(runway[:, 0], which % 3, which)]
    natural = natural * torch.exp(uniform(-0.5, 0.5)) * (1 + 0.06 * normal())
    ground_a = torch.where(runway | (day & ~grassy & ~wooden), natural, ground_a).clamp(0.02, 0.95)
    ground_b = (ground_a * uniform(0.4, 1.7) + torch.where(day, 0.01, 0.05) * normal()).clamp(0.02, 0.95)

    # Asphalt, concrete, a mown lawn: one tone, and what is dark on it is a shadow.
    plain = uniform(0, 1) < 0.3
    ground_b = torch.where(plain, (ground_a * uniform(0.88, 1.1)).clamp(0.02, 0.95), ground_b)

    # White or yellow paint.
    yellow = fixed((0.95, 0.65, 0.08), device)
    paint = uniform(0.45, 0.9) * torch.where(uniform(0, 1) < 0.4, yellow, torch.ones_like(yellow))
    ground_b = torch.where(runway, paint, ground_b)

    backdrop = drawn(BACKDROP_CHANCES)
    backdrop = torch.where(day & (backdrop == ROOM), torch.full_like(backdrop, OPEN_SKY), backdrop)
    wall_azimuth = uniform(0, 6.283)
    hills = (uniform(0.05, 0.5) + 0.1 * normal()).clamp(0.02, 0.9)
    leafy = (backdrop == TREES) & (uniform(0, 1) < 0.85)
    hills = torch.where(leafy, uniform(0.1, 0.55) * green * (1 + 0.25 * normal()).clamp(0.3, 2), hills)
    kinds = fixed(tuple(WALL_KINDS), device)
    wall_kind = kinds[torch.randint(len(kinds), (n, 1), device=device)]

    # A studio: one even colour all around, as of product photos and cut-outs.
    even = torch.where(uniform(0, 1) < 0.5, uniform(0.7, 1.0).expand(n, 3), (uniform(0.03, 0.95) + 0.06 * normal()).clamp(0.01, 1))
    zenith, horizon = (torch.where(studio, even * uniform(0.93, 1.03), c) for c in (zenith, horizon))
    ground_a, ground_b, hills = (torch.where(studio, even * uniform(0.93, 1.03), c) for c in (ground_a, ground_b, hills))
    backdrop = torch.where(studio, torch.where(uniform(0, 1) < 0.5, WALL, NOISE_ROOM), backdrop)
    wall_kind = torch.where(studio, torch.zeros_like(wall_kind), wall_kind)
    # Indoors: lamps and windows, no sun to speak of.
    room = backdrop == ROOM
    sunlight = torch.where(room, sunlight * uniform(0, 0.5), sunlight)
    sun_size = torch.where(room, uniform(0.1, 0.5), sun_size)
    outdoors = (ground_kind == GRASS) | (ground_kind == WATER) | (ground_kind == RUNWAY)
    ground_kind = torch.where(room & outdoors, torch.full_like(ground_kind, PLANKED), ground_kind)
    ground_kind = torch.where(studio, torch.full_like(ground_kind, EARTH), ground_kind)

    ambient = torch.where(dull | studio | room, uniform(0.6, 1.15), uniform(0.14, 0.8))
    # The sky's share on level ground: a ninth of the sun's on a clear noon, two thirds under haze.
    level = sunlight[:, 1:2] * sun[:, 2:].clamp(min=0.25)
    ambient = torch.where(day & ~dull, (level * torch.exp(uniform(-2.2, -0.4))).clamp(0.05, 0.9), ambient)
    deep = ~(dull | studio | room | day) & (uniform(0, 1) < 0.25)
    ambient = torch.where(deep, uniform(0.06, 0.22), ambient)
    ambient = torch.where(night, uniform(0.12, 0.45), ambient)
    fog = torch.where(uniform(0, 1) < 0.2, uniform(0, 0.08), uniform(0, 0.008))
    rest = [
        torch.exp(uniform(-0.5, 2.5)),  # ground frequency
        ambient,
        ground_kind.float(),
        backdrop.float(),
        uniform(0, 500).floor(),  # seed of the noise
        ground[:, None],
        wall_azimuth.cos(),
        wall_azimuth.sin(),
        torch.where(uniform(0, 1) < 0.3, uniform(1.0, 1.6), uniform(1.5, 6)),  # wall distance
        uniform(0, 1),  # clouds
        uniform(0, 2),  # hills
    ]
    last = [sun_size, fog, wall_kind.float(), torch.exp(uniform(-0.3, 1.9))]
    casters = drawn(CASTER_CHANCES)
    casters = torch.where(dull | studio | room, torch.full_like(casters, NO_CASTER), casters)
    casters = torch.where(day & (uniform(0, 1) < 0.6), torch.full_like(casters, NO_CASTER), casters)
    last += [uniform(0.12, 0.55), uniform(0, 1) ** 1.5, casters.float(), torch.exp(uniform(0.2, 2.0))]
    rows = torch.cat([sun, sunlight, zenith, horizon, ground_a, ground_b, *rest, hills, *last], 1)
    assert rows.shape[1] == ENVIRONMENT_FLOATS
    return rows.contiguous()
