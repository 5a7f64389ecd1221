"""Makers of what flies without wings or above the air: airships, balloons, satellites, space ships."""

import numpy as np

from .kit import ALONG_X, around, turn
from .layout import BALL, BOX, CYL, GRID, TUBE
from .materials import BANDS, CHECKER, PLAIN, SEAMS, STRIPES
from .wheeled import glazing


def airborne(kit):
    """Airships, balloons with baskets, satellites with panels, capsules, saucers and space ships."""
    rng = kit.rng
    skin, second, dark = kit.material(pattern=rng.choice([PLAIN, STRIPES, CHECKER, SEAMS, BANDS]), frequency=rng.uniform(3, 10)), kit.material(), kit.material(dark=True)
    kind = rng.choice(["airship", "balloon", "satellite", "saucer", "fighter"])
    if kind == "airship":
        long, fat = rng.uniform(1.8, 3.0), rng.uniform(0.45, 0.8)
        kit.add(BALL, (0, 0, 0), (long, fat, fat), material=skin)
        for spin in (0, 90, 180, 270):
            out = turn("x", spin + (45 if long > 2.5 else 0))
            kit.add(BOX, np.array([-long * 0.8, 0, 0]) + out @ np.array([0, 0, fat * 0.75]), (long * 0.13, 0.03, fat * 0.4), (0.6, 1), (-0.1, 0), rotation=out, material=second)
        kit.add(BOX, (long * 0.15, 0, -fat * 1.1), (long * rng.uniform(0.12, 0.25), fat * 0.2, fat * 0.16), (0.95, 0.8), material=second)
        kit.add(BOX, (long * 0.16, 0, -fat * 1.08), (long * 0.2, fat * 0.205, 0.04), material=glazing(kit))
        for y in (-1, 1):
            kit.add(CYL, (-long * 0.05, y * fat * 0.45, -fat * 1.05), (0.09, 0.09, 0.2), rotation=ALONG_X, material=dark)
    elif kind == "balloon":
        fat = rng.uniform(0.9, 1.2)
        kit.add(BALL, (0, 0, 2.2), (fat, fat, fat * rng.uniform(0.95, 1.15)), material=skin)
        kit.add(CYL, (0, 0, 1.2), (0.25, 0.25, 0.5), (fat * 3.2, 1), material=skin)
        basket = rng.uniform(0.15, 0.22)
        kit.add(BOX, (0, 0, 0.15), (basket, basket, 0.15), (1.1, 1.1), material=kit.material(base=[0.3, 0.18, 0.08], pattern=CHECKER, frequency=30))
        for x, y in around(4, basket * 1.3, 45):
            kit.between((x, y, 0.3), (x * 0.9, y * 0.9, 0.75), 0.012, material=dark)
    elif kind == "satellite":
        body = rng.uniform(0.25, 0.5)
        kit.add(BOX if kit.chance(0.6) else CYL, (0, 0, 0), (body, body, body * rng.uniform(0.8, 1.8)), material=skin)
        cells = kit.material(base=[0.02, 0.04, 0.2], second=[0.3] * 3, pattern=CHECKER, frequency=rng.uniform(10, 25))
        reach, deep = rng.uniform(0.8, 2.0), rng.uniform(0.2, 0.5)
        tilt = turn("y", rng.uniform(-60, 60))
        kit.add(BOX, (0, body + 0.2 + reach / 2, 0), (deep, reach / 2, 0.015), rotation=tilt, material=cells, mirror=True)
        kit.between((0, body, 0), (0, body + 0.25, 0), 0.03, material=dark, mirror=True)
        for k in range(3):
            low, high = 0.1 * k, 0.1 * (k + 1)
            kit.add(TUBE, (0, 0, -body * 1.8 - 0.15 * (2 * k + 1) / 2 * 0.6), (high * 1.4, high * 1.4, 0.045), (max(low, 0.03) / high, 1), material=second)
        kit.between((0, 0, body), (rng.uniform(-0.3, 0.3), 0, body * 3), 0.02, material=dark)
    elif kind == "saucer":
        wide = rng.uniform(1.0, 1.5)
        kit.loft((0, 0, 0.3), [(0, wide * 0.35), (0.14, wide * 0.8), (0.22, wide), (0.3, wide * 0.85), (0.45, wide * 0.35)], skin)
        kit.add(BALL, (0, 0, 0.7), (wide * 0.35, wide * 0.35, rng.uniform(0.2, 0.4)), material=glazing(kit) if kit.chance(0.6) else second)
        for x, y in around(int(rng.integers(5, 12)), wide * 0.9):
            kit.add(BALL, (x, y, 0.5), (0.08, 0.08, 0.06), material=second)
        if kit.chance(0.6):
            for x, y in around(3, wide * 0.6):
                kit.between((x * 0.7, y * 0.7, 0.35), (x, y, 0), 0.04, material=dark)
    else:
        long, wide = rng.uniform(1.2, 2.0), rng.uniform(0.3, 0.5)
        kit.add(BOX, (long * 0.4, 0, 0), (0.25, wide, long * 0.6), (0.4, 0.35), rotation=ALONG_X, material=skin)
        kit.add(BOX, (-long * 0.35, 0, 0), (long * 0.35, wide, 0.28), (0.9, 0.8), material=skin)
        kit.add(BALL, (long * 0.1, 0, 0.2), (0.4, wide * 0.5, 0.22), material=glazing(kit))
        lean = rng.uniform(-25, 25)
        span = rng.uniform(0.7, 1.3)
        for y in (-1, 1):
            lift = turn("x", y * lean)
            kit.add(BOX, np.array([-long * 0.35, y * wide, 0]) + lift @ np.array([0, y * span / 2, 0]), (long * 0.3, span / 2, 0.05), rotation=lift, material=second)
            tip = np.array([-long * 0.3, y * wide, 0]) + lift @ np.array([0, y * span, 0])
            kit.add(CYL, tip, (0.09, 0.09, long * rng.uniform(0.3, 0.5)), rotation=ALONG_X, material=dark)
            kit.add(CYL, (-long * 0.72, y * wide * 0.55, 0.05), (0.18, 0.18, 0.2), (0.8, 1), rotation=turn("y", -90), material=dark)
        for _ in range(int(rng.integers(2, 7))):
            place = (rng.uniform(-0.6, 0.5) * long, rng.uniform(0.1, 0.9) * wide, 0.25)
            kit.add(BOX, place, rng.uniform(0.04, 0.15, 3), material=second if kit.chance(0.5) else skin, mirror=True)
        if kit.chance(0.3):
            kit.add(BOX, (-long * 0.5, 0, 0.4), (0.3, 0.03, 0.3), (0.5, 1), (-0.2, 0), material=second, cut=(GRID, 6, 0.5))
    if kit.chance(0.3):
        low = min(p.centre[2] - (np.abs(p.rotation) @ p.half)[2] for p in kit.primitives)
        kit.between((0, 0, low - 0.5), (0, 0, low + 0.1), 0.04, material=dark)
        kit.add(CYL, (0, 0, low - 0.5), (0.4, 0.4, 0.04), material=second)
