"""Makers of lorries with work to do."""

import numpy as np

from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL, LATTICE, RUNGS
from .machines import wheel
from .materials import BANDS, PLAIN, RIBS, SEAMS, STRIPES, WRITING
from .wheeled import coat, glazing, lamps, plates


def service_lorry(kit):
    """Fire engines with ladders, concrete mixers, tippers, tow and crane lorries, sweepers, dustcarts, tankers: a cab before what does the work."""
    rng = kit.rng
    paint = kit.material(base=rng.choice([[0.5, 0.02, 0.02], [0.75, 0.4, 0.03], [0.7, 0.7, 0.68], [0.05, 0.15, 0.4], [0.1, 0.3, 0.1]]), pattern=PLAIN, gloss=0.3) if kit.chance(0.6) else coat(kit)
    second, dark, glass = kit.material(), kit.material(dark=True), glazing(kit)
    steel = kit.material(base=rng.uniform(0.2, 0.75) * np.ones(3), pattern=rng.choice([PLAIN, RIBS]))
    long, wide, radius = rng.uniform(2.0, 3.0), rng.uniform(0.85, 1.05), rng.uniform(0.38, 0.5)
    floor = radius * 1.7
    kit.add(BOX, (0, 0, floor), (long, wide * 0.55, 0.1), material=dark)
    cab, tall = rng.uniform(0.55, 0.8), rng.uniform(0.75, 1.0)
    x = long - cab
    bonnet = kit.chance(0.25)
    if bonnet:
        x -= 0.8
        kit.add(BOX, (x + cab + 0.4, 0, floor + 0.35), (0.42, wide * 0.75, 0.35), (1, 0.9), material=paint)
    kit.add(BOX, (x, 0, floor + tall), (cab, wide, tall), (rng.uniform(0.85, 1), 0.95), (-0.05, 0), material=paint)
    kit.add(BOX, (x + 0.02, 0, floor + tall * 1.45), (cab, wide * 0.85, tall * 0.32), (0.93, 0.98), (-0.04, 0), material=glass)
    kit.add(BOX, (x, 0, floor + tall * 1.45), (cab * 0.6, wide * 1.0, tall * 0.28), material=glass)
    nose = x + cab + (0.82 if bonnet else 0)
    kit.add(BOX, (nose, 0, floor - 0.1), (0.08, wide, 0.14), material=dark if kit.chance(0.6) else second)
    lamps(kit, nose + 0.06, -long - 0.02, wide, floor + 0.15, 0.1)
    plates(kit, nose + 0.09, -long - 0.05, floor - 0.1)
    axles = [nose - radius * 1.6, -long * 0.45, -long * 0.45 - 2.2 * radius] if long > 2.4 else [nose - radius * 1.6, -long * 0.55]
    for at in axles:
        wheel(kit, (at, wide * 0.88, radius), radius, 0.16, dark, steel)
    back, deck, half = x - cab - 0.1, floor + 0.1, (x - cab - 0.1 + long) / 2
    middle = back - half
    kind = rng.choice(["fire", "mixer", "tipper", "crane", "dust", "tanker"])
    if kind == "fire":
        high = rng.uniform(0.6, 0.8)
        kit.add(BOX, (middle, 0, deck + high), (half, wide, high), material=paint)
        lockers = int(rng.integers(2, 5))
        for k in range(lockers):
            at = middle + half * ((2 * k + 1) / lockers - 1)
            kit.add(BOX, (at, wide * 1.0, deck + high), (half * 0.85 / lockers, 0.02, high * 0.75), material=steel, mirror=True)
        roof = deck + 2 * high
        lift = turn("y", -rng.choice([0, 0, rng.uniform(10, 50)]))
        reach = half * rng.uniform(1.1, 1.6)
        kit.add(CYL, (back - 2 * half + 0.5, 0, roof + 0.1), (0.4, 0.4, 0.12), material=second)
        for z in (0.22, 0.36)[: int(rng.integers(1, 3))]:
            kit.add(BOX, np.array([back - 2 * half + 0.5, 0, roof + z]) + lift @ np.array([reach, 0, 0]), (reach, 0.25, 0.06), rotation=lift, material=steel, cut=(LATTICE if kit.chance(0.4) else RUNGS, 5, 0.35))
        kit.add(BOX, (x, 0, floor + 2 * tall + 0.06), (0.1, wide * 0.7, 0.06), material=kit.material(base=[0.03, 0.1, 0.6]))
        kit.add(BOX, (0, 0, floor + tall * 0.5), (long * 0.99, wide * 1.005, 0.06), material=kit.material(base=[0.85] * 3, pattern=PLAIN))
    elif kind == "mixer":
        lean = turn("y", -90 - rng.uniform(8, 18))
        profile = [(0, 0.3), (0.3, 0.62), (0.9, 0.85), (1.4, 0.8), (2.0, 0.45), (2.2, 0.4)]
        share = 2 * half / 2.2
        kit.loft((back - 0.05, 0, deck + 0.75), [(z * share, r * wide * 1.05) for z, r in profile], kit.material(pattern=rng.choice([PLAIN, STRIPES, BANDS])), axis=lean)
        kit.add(BOX, (back - 0.2, 0, deck + 0.4), (0.15, wide * 0.6, 0.4), material=steel)
        kit.between((back - 1.7 * half, wide * 0.6, deck), (back - 1.7 * half, wide * 0.3, deck + 1.0), 0.05, material=steel, mirror=True)
        kit.add(BOX, (-long - 0.1, 0, deck + 0.3), (0.2, 0.2, 0.4), (0.6, 0.6), rotation=turn("y", 35), material=steel)
    elif kind == "tipper":
        lift = turn("y", rng.choice([0, 0, -rng.uniform(10, 40)]))
        hinge = np.array([back - 2 * half, 0, deck])
        high = rng.uniform(0.35, 0.6)
        kit.add(BOX, hinge + lift @ np.array([half, 0, 0.05]), (half, wide, 0.05), rotation=lift, material=paint)
        for y in (-1, 1):
            kit.add(BOX, hinge + lift @ np.array([half, y * wide, high]), (half, 0.04, high), rotation=lift, material=second)
            for k in range(4):
                kit.add(BOX, hinge + lift @ np.array([half * (0.25 + 0.5 * k), y * (wide + 0.05), high]), (0.05, 0.04, high), rotation=lift, material=second)
        kit.add(BOX, hinge + lift @ np.array([2 * half, 0, high * 1.15]), (0.04, wide, high * 1.15), rotation=lift, material=second)
        if kit.chance(0.5):
            kit.add(BALL, hinge + lift @ np.array([half, 0, high * 1.3]), (half * 0.9, wide * 0.85, high), rotation=lift, material=kit.material())
        kit.between(hinge + [1.2 * half, 0, 0], hinge + lift @ np.array([1.4 * half, 0, 0]), 0.06, material=steel)
    elif kind == "crane":
        kit.add(BOX, (middle, 0, deck + 0.06), (half, wide, 0.06), material=second)
        base = np.array([rng.choice([back - 0.3, back - 1.6 * half]), 0, deck])
        kit.add(CYL, base + [0, 0, 0.4], (0.25, 0.25, 0.4), material=paint)
        lift = np.radians(rng.uniform(5, 60))
        aim = np.array([np.cos(lift) * rng.choice([-1, 1]), 0, np.sin(lift)])
        start, first = base + [0, 0, 0.8], rng.uniform(1.0, 1.8)
        kit.between(start, start + aim * first, (0.13, 0.11), BOX, material=paint)
        kit.between(start + aim * first * 0.9, start + aim * first * 1.7, (0.08, 0.07), BOX, material=steel)
        tip = start + aim * first * 1.7
        kit.between(tip, tip - [0, 0, rng.uniform(0.3, 0.9)], 0.015, material=dark)
        kit.between(start + [0, 0, -0.2], start + aim * first * 0.5, 0.05, material=steel)
        for y in (-1, 1):
            kit.between((base[0], y * wide, deck), (base[0], y * wide * 1.35, deck), 0.06, BOX, material=dark)
            kit.between((base[0], y * wide * 1.35, deck), (base[0], y * wide * 1.35, 0.03), 0.05, material=steel)
        if kit.chance(0.5):
            kit.add(BOX, (middle - 0.3, 0, deck + 0.4), (half * 0.5, wide * 0.8, 0.3), material=kit.material())
    elif kind == "dust":
        high = rng.uniform(0.75, 0.95)
        kit.add(BOX, (middle + 0.25, 0, deck + high), (half * 0.85, wide, high), (0.95, 0.92), material=second)
        kit.add(BOX, (back - 2 * half + 0.1, 0, deck + high * 0.85), (0.45, wide, high * 1.05), (0.55, 1), (0.25, 0), material=paint)
        kit.add(BOX, (back - 2 * half - 0.3, 0, deck + 0.25), (0.12, wide * 0.8, 0.25), material=dark)
        for k in range(3):
            kit.add(BOX, (middle + half * (0.6 * k - 0.3), wide * 0.98, deck + high), (0.04, 0.05, high * 0.95), material=second, mirror=True)
    else:
        high = rng.uniform(0.6, 0.8)
        kit.add(CYL, (middle, 0, deck + high), (high, wide * 0.98, half * 0.97), rotation=ALONG_X, material=kit.material(pattern=rng.choice([PLAIN, WRITING, SEAMS]), gloss=0.4))
        for k in range(int(rng.integers(1, 4))):
            kit.add(CYL, (middle + (k - 1) * 0.7 * half, 0, deck + 2 * high), (0.2, 0.2, 0.05), material=steel)
        kit.add(BOX, (middle, wide * 0.8, deck), (half * 0.8, 0.12, 0.15), material=dark, mirror=True)
        kit.railing((middle - half * 0.8, 0.25, deck + 2 * high), (middle + half * 0.8, 0.25, deck + 2 * high), 0.2, steel)
