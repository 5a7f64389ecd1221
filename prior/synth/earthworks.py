"""What the makers of military posts, camps and ruins share: concrete, soil, sacking, rust; sandbags, heaps, what turns parts about."""

import numpy as np

from .extent import bounds
from .installations import CONCRETE, EARTH, GREY, RUST, SAND, tinted
from .kit import turn
from .layout import BOX, PRISM
from .materials import CLOUDY, PLAIN, SPECKLES, STREAKS


def cast(kit):
    return tinted(kit, (CONCRETE, GREY, CONCRETE, SAND), (CLOUDY, STREAKS, PLAIN), frequency=5, gloss=0.02)


def soil(kit):
    return tinted(kit, (EARTH, SAND, (0.14, 0.15, 0.06)), (CLOUDY, SPECKLES), frequency=kit.rng.uniform(8, 20), gloss=0.0)


def sacking(kit):
    return tinted(kit, (SAND, (0.36, 0.3, 0.2), (0.2, 0.19, 0.11)), (CLOUDY, SPECKLES), frequency=25, gloss=0.0)


def rusty(kit):
    return tinted(kit, (RUST, (0.3, 0.14, 0.07), (0.1, 0.06, 0.045)), (CLOUDY, STREAKS, SPECKLES), frequency=kit.rng.uniform(5, 14), gloss=0.02)


def bag(kit, at, half, spin, material):
    """A pillow: a box filled by a superellipsoid."""
    kit.add(BOX, at, half, rotation=turn("z", spin), material=material)
    kit.primitives[-1] = kit.primitives[-1]._replace(bevel=2.6)


def bag_ring(kit, radius, rows, sand, first=40, last=320, base=0.0):
    """Bags in `rows` courses on an arc between two angles in degrees."""
    count = max(3, int(np.radians(last - first) * radius / 0.58))
    step = (last - first) / count
    for row in range(rows):
        for k in range(count):
            angle = np.radians(first + step * (k + (0.5 if row % 2 == 0 else 0.25 if k == 0 else 0.0)))
            at = (radius * np.cos(angle), radius * np.sin(angle), base + 0.12 + 0.21 * row)
            bag(kit, at, (np.radians(step) * radius * 0.53, 0.21, 0.13), np.degrees(angle) + 90 + kit.rng.normal(0, 4), sand)


def bag_line(kit, start, end, rows, sand, base=0.0):
    """Bags in `rows` courses from start to end [2], every second course moved by half a bag."""
    start, end = np.array(start, float), np.array(end, float)
    along = end - start
    count = max(2, round(np.linalg.norm(along) / 0.6))
    spin = np.degrees(np.arctan2(along[1], along[0]))
    for row in range(rows):
        for k in range(count - row % 2):
            at = start + along * (k + 0.5 + 0.5 * (row % 2)) / count
            bag(kit, (*at, base + 0.12 + 0.21 * row), (np.linalg.norm(along) / count * 0.53, 0.2, 0.13), spin + kit.rng.normal(0, 3), sand)


def heap(kit, x, y, rx, ry, high, material):
    """A low mound on the ground."""
    rx = max(rx, 0.05)
    kit.loft((x, y, 0), [(0, rx), (high * 0.5, rx * 0.74), (high, rx * 0.28)], material, PRISM, turn("z", 0), ry / rx, int(kit.rng.integers(7, 11)))


def swing(kit, first, spin, at=(0, 0, 0)):
    """Turns what was added since `first` about the origin, moves it to `at` and lets it stand on that height."""
    moved = [p._replace(centre=spin @ p.centre, rotation=spin @ p.rotation) for p in kit.primitives[first:]]
    lift = np.array(at, float) - [0, 0, bounds(moved)[0][2]]
    kit.primitives[first:] = [p._replace(centre=p.centre + lift) for p in moved]
