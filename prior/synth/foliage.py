"""Makers of trees, bushes and hedges."""

import numpy as np

from .layout import BALL, CYL
from .materials import CLOUDY, paint


def leafy(kit):
    """Trees, bushes and hedges with gaps between their leaves."""
    rng = kit.rng
    green = paint(rng.uniform(0.16, 0.36), rng.uniform(0.4, 0.95), rng.uniform(0.06, 0.5))
    if kit.chance(0.12):
        green = paint(rng.uniform(0.95, 1.12) % 1, rng.uniform(0.4, 0.9), rng.uniform(0.2, 0.7))
    leaves = kit.material(base=green, pattern=CLOUDY, frequency=rng.uniform(4, 14), gloss=0.05, second=green * 0.4)
    bark = kit.material(base=rng.uniform(0.3, 1.3) * np.array([0.22, 0.16, 0.1]), pattern=13)
    cut = (1, rng.uniform(2.5, 8), rng.uniform(0.45, 0.62))
    kind = rng.random()
    if kind < 0.5:
        trunk, crown = rng.uniform(0.5, 2.2), rng.uniform(0.6, 1.3)
        kit.between((0, 0, 0), (rng.normal(0, 0.1), 0, trunk + 0.4 * crown), rng.uniform(0.06, 0.16), taper=0.6, material=bark)
        for _ in range(rng.integers(3, 10)):
            place = rng.normal(0, 0.5, 3) * crown + np.array([0, 0, trunk + crown])
            kit.add(BALL, place, rng.uniform(0.4, 0.85, 3) * crown, material=leaves, cut=cut)
            if kit.chance(0.3):
                kit.between((0, 0, trunk * 0.8), place, 0.035, material=bark)
    elif kind < 0.7:
        height, radius = rng.uniform(1.5, 3), rng.uniform(0.4, 0.9)
        kit.add(CYL, (0, 0, 0.3), (0.1, 0.1, 0.4), material=bark)
        layers = int(rng.integers(3, 7))
        for i in range(layers):
            wide = radius * (1 - 0.85 * i / layers)
            z = 0.4 + height * (i + 0.5) / layers
            kit.add(CYL, (0, 0, z), (wide, wide, 0.75 * height / layers), (0.25, 1), material=leaves, cut=(1, cut[1] * 1.5, cut[2] + 0.05))
    else:
        for _ in range(rng.integers(2, 9)):
            place = np.array([*rng.normal(0, 0.8, 2), rng.uniform(0.15, 0.6)])
            kit.add(BALL, place, rng.uniform(0.3, 0.7, 3), material=leaves, cut=cut)


def broadleaf(kit):
    """A crown of many small ragged bodies around a dark middle, on a forked trunk."""
    rng = kit.rng
    green = paint(rng.uniform(0.16, 0.36), rng.uniform(0.35, 0.9), rng.uniform(0.05, 0.45))
    outer = kit.material(base=green, pattern=CLOUDY, frequency=rng.uniform(6, 18), gloss=0.05, second=green * rng.uniform(0.25, 0.7))
    inner = kit.material(base=green * rng.uniform(0.3, 0.7), pattern=CLOUDY, frequency=rng.uniform(6, 18), gloss=0.02, second=green * 0.2)
    bark = kit.material(base=rng.uniform(0.3, 1.3) * np.array([0.22, 0.16, 0.1]), pattern=13)
    fine, share = rng.uniform(4, 11), rng.uniform(0.44, 0.62)
    trunk = rng.uniform(0.3, 1.6)
    reach = np.array([rng.uniform(0.7, 1.3), rng.uniform(0.7, 1.3), rng.uniform(0.7, 1.6)])
    middle = np.array([0, 0, trunk + reach[2] * 0.85])
    kit.between((0, 0, 0), (rng.normal(0, 0.06), rng.normal(0, 0.06), trunk + 0.5 * reach[2]), rng.uniform(0.06, 0.15), taper=0.6, material=bark)
    for _ in range(rng.integers(2, 6)):
        limb = middle + reach * rng.normal(0, 0.4, 3)
        kit.between((0, 0, trunk * rng.uniform(0.6, 1)), limb, 0.03, taper=0.5, material=bark)
    kit.add(BALL, middle, reach * rng.uniform(0.5, 0.75), material=inner, cut=(1, fine * 0.7, share + 0.05))
    for _ in range(rng.integers(14, 42)):
        away = rng.normal(0, 1, 3)
        away *= rng.uniform(0.55, 1) ** 0.5 / np.linalg.norm(away)
        size = rng.uniform(0.2, 0.5) * rng.uniform(0.7, 1.3, 3)
        kit.add(BALL, middle + reach * away, size, material=outer if kit.chance(0.75) else inner, cut=(1, fine, share))
