"""Makers of what stands in kitchens, baths, bedrooms and offices."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import CHECKER, CLOUDY, DOTS, PLAIN, PLANKS, STRIPES, WRITING


def appliance(kit):
    """Kettles, teapots, toasters, mixers, irons, clocks, telephones, vacuum cleaners, sewing machines, lamps, taps, basins, toilets."""
    rng = kit.rng
    shell, dark, metal = kit.material(gloss=rng.uniform(0, 0.5), pattern=rng.choice([PLAIN, PLAIN, STRIPES, DOTS])), kit.material(dark=True), kit.material(base=rng.uniform(0.3, 0.8) * np.ones(3), gloss=0.5, pattern=PLAIN)
    kind = rng.choice(["pot", "toaster", "mixer", "iron", "clock", "phone", "cleaner", "sewing", "lamp", "basin", "toilet"])
    if kind == "pot":
        wide, high = rng.uniform(0.4, 0.6), rng.uniform(0.4, 0.8)
        kit.loft((0, 0, 0), [(0, wide * 0.75), (high * 0.3, wide), (high * 0.7, wide * 0.9), (high, wide * rng.uniform(0.4, 0.7))], shell)
        kit.loft((0, 0, high), [(0, wide * 0.5), (0.07, wide * 0.35), (0.1, 0.05)], shell)
        kit.add(BALL, (0, 0, high + 0.15), (0.07, 0.07, 0.07), material=dark)
        kit.chain([(wide * 0.8, 0, high * 0.35), (wide * 1.35, 0, high * 0.6), (wide * 1.6, 0, high * rng.uniform(0.8, 1.05))], [0.12, 0.08, 0.05], shell)
        if kit.chance(0.5):
            kit.chain([(-wide * 0.85, 0, high * 0.8), (-wide * 1.5, 0, high * 0.75), (-wide * 1.4, 0, high * 0.3), (-wide * 0.9, 0, high * 0.25)], [0.045] * 4, dark)
        else:
            kit.chain([(-wide * 0.5, 0, high), (-wide * 0.5, 0, high + 0.45), (wide * 0.5, 0, high + 0.45), (wide * 0.5, 0, high)], [0.04] * 4, dark)
    elif kind == "toaster":
        kit.add(BOX, (0, 0, 0.4), (0.65, 0.33, 0.36), (0.95, 0.85), material=shell)
        for y in (-0.13, 0.13):
            kit.add(BOX, (0, y, 0.765), (0.5, 0.05, 0.01), material=dark)
            if kit.chance(0.5):
                kit.add(BOX, (0, y, 0.8), (0.4, 0.04, 0.18), material=kit.material(base=[0.5, 0.3, 0.12]))
        kit.add(BOX, (0.68, 0, 0.5), (0.06, 0.08, 0.03), material=dark)
        kit.add(CYL, (0.66, 0.15, 0.25), (0.06, 0.06, 0.03), rotation=ALONG_X, material=metal)
        kit.add(BOX, (0, 0, 0.03), (0.62, 0.31, 0.04), material=dark)
    elif kind == "mixer":
        kit.add(BOX, (-0.2, 0, 0.08), (0.75, 0.35, 0.08), (0.9, 0.9), material=shell)
        kit.add(BOX, (-0.65, 0, 0.6), (0.2, 0.22, 0.5), (1, 0.9), material=shell)
        kit.add(BALL, (-0.05, 0, 1.2), (0.8, 0.3, 0.28), material=shell)
        kit.loft((0.3, 0, 0.16), [(0, 0.2), (0.15, 0.36), (0.5, 0.45)], metal)
        kit.between((0.3, 0, 0.6), (0.3, 0, 1.0), 0.05, material=metal)
    elif kind == "iron":
        kit.add(BOX, (0, 0, 0.06), (0.06, 0.3, 0.65), (1, 0.1), rotation=ALONG_X, material=metal)
        kit.add(BOX, (-0.1, 0, 0.25), (0.5, 0.24, 0.16), (0.7, 0.5), (-0.1, 0), material=shell)
        kit.chain([(-0.45, 0, 0.35), (-0.5, 0, 0.62), (0.2, 0, 0.62), (0.25, 0, 0.35)], [0.07] * 4, dark)
    elif kind == "clock":
        size = rng.uniform(0.5, 0.8)
        kit.add(CYL, (0, 0, size + 0.15), (size, size, rng.uniform(0.1, 0.25)), rotation=ALONG_X, material=shell)
        kit.add(CYL, (0.2, 0, size + 0.15), (size * 0.86, size * 0.86, 0.06), rotation=ALONG_X, material=kit.material(base=[0.85, 0.85, 0.8], pattern=PLAIN))
        for length in (0.45, 0.7):
            angle = rng.uniform(0, 2 * np.pi)
            kit.between((0.27, 0, size + 0.15), (0.27, size * length * np.cos(angle), size + 0.15 + size * length * np.sin(angle)), (0.02, 0.03), BOX, material=dark)
        for y in (-1, 1):
            kit.between((0, y * size * 0.5, size * 0.3), (0, y * size * 0.8, 0), 0.06, material=metal)
            if kit.chance(0.5):
                kit.add(BALL, (0, y * size * 0.55, 2 * size + 0.2), (0.2, 0.24, 0.18), material=metal)
    elif kind == "phone":
        kit.add(BOX, (0, 0, 0.18), (0.5, 0.55, 0.18), (0.6, 0.85), (-0.15, 0), material=shell)
        kit.add(CYL, (0.22, 0, 0.3), (0.26, 0.26, 0.03), rotation=turn("y", 35), material=dark if kit.chance(0.5) else metal)
        kit.add(BOX, (-0.2, 0, 0.5), (0.12, 0.7, 0.07), material=dark if kit.chance(0.4) else shell)
        kit.add(BALL, (-0.15, 0.6, 0.45), (0.2, 0.16, 0.13), material=shell, mirror=True)
    elif kind == "cleaner":
        kit.add(BALL, (0, 0, 0.4), (0.6, 0.42, 0.4), material=shell)
        kit.add(CYL, (-0.35, 0.4, 0.3), (0.3, 0.3, 0.05), rotation=ALONG_Y, material=dark, mirror=True)
        kit.chain([(0.5, 0, 0.5), (1.0, 0.1, 0.9), (1.3, 0.0, 1.3), (1.7, 0, 0.8)], [0.07] * 4, dark)
        kit.between((1.6, 0, 1.0), (2.2, 0, 0.08), 0.05, material=metal)
        kit.add(BOX, (2.3, 0, 0.06), (0.12, 0.4, 0.06), material=dark)
    elif kind == "sewing":
        kit.add(BOX, (0, 0, 0.12), (0.9, 0.35, 0.12), material=shell)
        kit.add(BOX, (-0.65, 0, 0.6), (0.2, 0.2, 0.4), material=shell)
        kit.add(BOX, (0.05, 0, 0.95), (0.8, 0.18, 0.17), material=shell)
        kit.add(BOX, (0.7, 0, 0.72), (0.14, 0.15, 0.22), material=shell)
        kit.between((0.7, 0, 0.55), (0.7, 0, 0.25), 0.02, material=metal)
        kit.add(CYL, (-0.9, 0, 0.9), (0.26, 0.26, 0.06), rotation=ALONG_X, material=dark)
        kit.add(CYL, (-0.2, 0, 1.2), (0.08, 0.08, 0.12), material=kit.material())
    elif kind == "lamp":
        tall = rng.uniform(0.9, 2.4)
        kit.add(CYL, (0, 0, 0.04), (0.35, 0.35, 0.04), (0.8, 1), material=dark)
        if kit.chance(0.5):
            kit.between((0, 0, 0), (0, 0, tall), 0.03, material=metal)
            kit.add(TUBE, (0, 0, tall), (0.5, 0.5, rng.uniform(0.2, 0.35)), (rng.uniform(0.4, 0.9), 1), material=shell)
            kit.add(BALL, (0, 0, tall), (0.1, 0.1, 0.12), material=kit.material(base=[0.9, 0.85, 0.6]))
        else:
            elbow = np.array([-rng.uniform(0.2, 0.5), 0, tall * 0.6])
            tip = elbow + [rng.uniform(0.5, 0.9), 0, rng.uniform(0.1, 0.5)]
            kit.between((0, 0, 0.05), elbow, 0.03, material=metal)
            kit.between(elbow, tip, 0.03, material=metal)
            kit.add(CYL, tip + [0.08, 0, -0.1], (0.1, 0.1, 0.2), (2.4, 1), rotation=turn("y", 140), material=shell)
    elif kind == "basin":
        kit.add(CYL, (0, 0, 0.45), (0.18, 0.18, 0.45), (0.8, 1), material=shell)
        kit.loft((0, 0, 0.85), [(0, 0.25), (0.15, 0.5), (0.25, 0.6)], shell, flat=rng.uniform(1, 1.3))
        kit.add(CYL, (0.05, 0, 1.1), (0.42, 0.5, 0.015), material=dark)
        kit.chain([(-0.4, 0, 1.1), (-0.4, 0, 1.4), (-0.1, 0, 1.4), (-0.1, 0, 1.3)], [0.04] * 4, metal)
        kit.add(BOX, (-0.4, 0.2, 1.15), (0.05, 0.05, 0.05), material=metal, mirror=True)
    else:
        kit.loft((0.15, 0, 0), [(0, 0.3), (0.2, 0.25), (0.45, 0.42)], shell, flat=0.8)
        kit.add(CYL, (0.15, 0, 0.48), (0.48, 0.38, 0.04), material=shell if kit.chance(0.6) else kit.material(pattern=PLANKS))
        kit.add(BOX, (-0.42, 0, 0.75), (0.17, 0.42, 0.35), (1, 1.05), material=shell)
        kit.add(BOX, (-0.42, 0, 1.12), (0.19, 0.45, 0.03), material=shell)
        lid = rng.choice([0, 80])
        kit.add(CYL, (0.15, 0, 0.54) if lid == 0 else (-0.22, 0, 0.9), (0.46, 0.36, 0.02), rotation=turn("y", lid), material=shell)
        kit.add(BOX, (-0.24, 0.3, 1.0), (0.02, 0.06, 0.03), material=metal)


def large_furniture(kit):
    """Beds, wardrobes, sofas, desks with drawers, bookcases, cookers, refrigerators, washing machines, pianos, billiard tables."""
    rng = kit.rng
    wood = kit.material(pattern=rng.choice([PLANKS, PLAIN, CLOUDY]))
    cloth, second, dark, metal = kit.material(pattern=rng.choice([PLAIN, CHECKER, STRIPES, DOTS])), kit.material(), kit.material(dark=True), kit.material(base=rng.uniform(0.3, 0.8) * np.ones(3))
    kind = rng.choice(["bed", "wardrobe", "sofa", "desk", "shelves", "machine", "table"])
    if kind == "bed":
        long, wide, high = 1.0, rng.uniform(0.45, 0.9), rng.uniform(0.2, 0.35)
        kit.add(BOX, (0, 0, high), (long, wide, 0.1), material=wood)
        kit.add(BOX, (0, 0, high + 0.2), (long * 0.97, wide * 0.95, 0.12), material=kit.material(base=[0.8] * 3))
        kit.add(BOX, (-0.15, 0, high + 0.26), (long * 0.82, wide * 1.0, 0.1), material=cloth)
        for y in ([0] if wide < 0.65 else [-wide * 0.45, wide * 0.45]):
            kit.add(BALL, (long * 0.78, y, high + 0.36), (0.18, wide * 0.35, 0.09), material=second)
        kit.add(BOX, (long, 0, high + 0.3), (0.05, wide, rng.uniform(0.3, 0.6)), material=wood)
        if kit.chance(0.5):
            kit.add(BOX, (-long, 0, high + 0.1), (0.05, wide, 0.25), material=wood)
        for x in (-long, long):
            kit.add(BOX, (x, wide * 0.95, high / 2), (0.05, 0.05, high / 2), material=wood, mirror=True)
        if kit.chance(0.2):
            for x in (-long, long):
                kit.add(BOX, (x, wide * 0.97, 0.9), (0.04, 0.04, 0.9), material=wood, mirror=True)
            kit.add(BOX, (0, 0, 1.8), (long * 1.02, wide * 1.02, 0.04), material=cloth)
    elif kind == "sofa":
        wide, high = rng.uniform(0.7, 1.4), rng.uniform(0.35, 0.5)
        kit.add(BOX, (0, 0, high * 0.55), (0.5, wide, high * 0.45), material=cloth)
        kit.add(BOX, (-0.42, 0, high + 0.25), (0.14, wide, 0.4), (0.8, 1), (-0.1, 0), material=cloth)
        kit.add(BOX, (0, wide * 1.05, high * 0.8), (0.5, 0.14, high * 0.75), material=cloth, mirror=True)
        seats = int(rng.integers(1, 4))
        for k in range(seats):
            y = wide * ((2 * k + 1) / seats - 1)
            kit.add(BOX, (0.06, y, high + 0.06), (0.45, wide * 0.95 / seats, 0.1), material=cloth if kit.chance(0.6) else second)
            kit.add(BOX, (-0.28, y, high + 0.32), (0.1, wide * 0.9 / seats, 0.25), rotation=turn("y", -12), material=second)
        for x in (-0.42, 0.42):
            kit.add(CYL, (x, wide, 0.05), (0.05, 0.05, 0.06), material=dark, mirror=True)
    elif kind == "machine":
        wide, deep, high = rng.uniform(0.4, 0.55), rng.uniform(0.4, 0.5), rng.uniform(0.55, 1.2)
        kit.add(BOX, (0, 0, high), (deep, wide, high), material=metal if kit.chance(0.7) else second)
        if high > 0.85:
            split = rng.uniform(0.8, 1.5) * high
            for low, top in ((0.04, split), (split + 0.02, 2 * high - 0.03)):
                kit.add(BOX, (deep, 0, (low + top) / 2), (0.04, wide * 0.97, (top - low) / 2), material=metal)
                kit.add(BOX, (deep + 0.06, wide * 0.8, (low + top) / 2), (0.03, 0.03, (top - low) * 0.25), material=dark)
        elif kit.chance(0.5):
            kit.add(CYL, (deep, 0, high * 0.95), (0.3, 0.3, 0.04), rotation=ALONG_X, material=metal)
            kit.add(CYL, (deep + 0.02, 0, high * 0.95), (0.22, 0.22, 0.04), rotation=ALONG_X, material=dark)
            kit.add(BOX, (deep, 0, 2 * high - 0.1), (0.03, wide * 0.95, 0.07), material=kit.material(pattern=WRITING))
        else:
            kit.add(BOX, (deep, 0, high * 0.8), (0.03, wide * 0.85, high * 0.45), material=dark)
            kit.between((deep + 0.08, -wide * 0.7, high * 1.35), (deep + 0.08, wide * 0.7, high * 1.35), 0.025, material=metal)
            for x, y in ((-0.2, -0.22), (-0.2, 0.22), (0.2, -0.22), (0.2, 0.22)):
                kit.add(TUBE, (x, y, 2 * high + 0.02), (0.14, 0.14, 0.02), material=dark)
            for y in np.linspace(-0.7, 0.7, 5) * wide:
                kit.add(CYL, (deep + 0.04, y, high * 1.7), (0.045, 0.045, 0.04), rotation=ALONG_X, material=dark)
    elif kind == "shelves":
        wide, high, deep = rng.uniform(0.4, 0.9), rng.uniform(0.6, 1.2), rng.uniform(0.15, 0.25)
        kit.add(BOX, (0, wide, high), (deep, 0.03, high), material=wood, mirror=True)
        kit.add(BOX, (-deep, 0, high), (0.015, wide, high), material=wood)
        rows = int(rng.integers(3, 6))
        for k in range(rows + 1):
            kit.add(BOX, (0, 0, 2 * high * k / rows), (deep, wide, 0.025), material=wood)
        for k in range(rows):
            base, y = 2 * high * k / rows + 0.03, -wide * 0.92
            while y < wide * rng.uniform(0.3, 0.95) and len(kit.primitives) < 60:
                half, tall = rng.uniform(0.03, 0.12), rng.uniform(0.5, 0.85) * high / rows
                kit.add(BOX, (0, y + half, base + tall), (deep * rng.uniform(0.6, 0.9), half, tall))
                y += 2 * half + rng.choice([0.005, 0.1])
    elif kind == "wardrobe":
        wide, high, deep = rng.uniform(0.5, 0.9), rng.uniform(0.7, 1.1), rng.uniform(0.25, 0.4)
        kit.add(BOX, (0, 0, high + 0.08), (deep, wide, high), material=wood)
        doors = int(rng.integers(1, 4))
        base = rng.choice([0.0, 0.5])
        for k in range(doors):
            y = wide * ((2 * k + 1) / doors - 1)
            kit.add(BOX, (deep, y, high + 0.08 + base * 0.4), (0.03, wide * 0.94 / doors, high * (0.94 - base * 0.4)), material=wood if kit.chance(0.6) else second)
            kit.add(BALL, (deep + 0.06, y + wide * 0.6 / doors * (1 if k % 2 == 0 else -1), high), (0.03, 0.03, 0.03), material=metal)
        if base:
            for z in (0.2, 0.42):
                kit.add(BOX, (deep, 0, z), (0.035, wide * 0.94, 0.09), material=second)
        kit.add(BOX, (0, 0, 2 * high + 0.12), (deep * 1.1, wide * 1.06, 0.05), material=wood)
        for x in (-deep, deep):
            kit.add(CYL, (x * 0.9, wide * 0.9, 0.04), (0.05, 0.05, 0.06), material=wood, mirror=True)
    else:
        wide, deep, high = rng.uniform(0.6, 1.2), rng.uniform(0.35, 0.6), rng.uniform(0.6, 0.8)
        kit.add(BOX if kit.chance(0.75) else CYL, (0, 0, high), (deep, wide, 0.04), material=wood)
        if kind == "desk":
            kit.add(BOX, (0, wide * 0.7, high * 0.55), (deep * 0.9, wide * 0.25, high * 0.42), material=second, mirror=kit.chance(0.5))
            for z in (0.3, 0.55, 0.8):
                kit.add(BOX, (deep * 0.92, wide * 0.7, high * z), (0.02, wide * 0.22, high * 0.1), material=wood)
                kit.add(BALL, (deep * 0.97, wide * 0.7, high * z), (0.03, 0.05, 0.02), material=metal)
            kit.add(BOX, (-deep * 0.9, 0, high * 0.6), (0.02, wide * 0.9, high * 0.35), material=wood)
        for x in (-0.88, 0.88):
            kit.between((x * deep, wide * 0.9, high), (x * deep * rng.uniform(1, 1.1), wide * 0.92, 0), rng.uniform(0.025, 0.06), BOX, 0.8, material=wood, mirror=True)
        if kit.chance(0.4):
            kit.add(BOX, (0, 0, high + 0.045), (deep * 1.01, wide * rng.uniform(0.3, 1.01), 0.012), material=cloth)
        for _ in range(int(rng.integers(0, 6))):
            half = rng.uniform(0.04, 0.16, 3)
            kit.add(rng.choice([BOX, CYL, BALL]), (rng.uniform(-0.7, 0.7) * deep, rng.uniform(-0.8, 0.8) * wide, high + 0.05 + half[2]), half)
        if kit.chance(0.2):
            kit.add(BOX, (-deep * 0.5, 0, high + 0.4), (0.04, wide * 0.4, 0.25), material=dark)
            kit.add(BOX, (-deep * 0.45, 0, high + 0.1), (0.12, 0.12, 0.06), material=dark)
