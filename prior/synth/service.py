"""Makers of lorries with work to do, of airships, balloons, satellites and space ships."""

import numpy as np

from .kit import ALONG_X, around, turn
from .layout import BALL, BOX, CYL, GRID, LATTICE, RUNGS, TUBE
from .machines import wheel
from .materials import BANDS, CHECKER, PLAIN, RIBS, SEAMS, STRIPES, WRITING
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
