"""Makers of frames, lattices and what stands along streets: scaffolds, pylons, cranes, fences, lamps, signs."""

import numpy as np

from .kit import ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, PRISM
from .materials import PLANKS, paint


def scaffold(kit):
    """Open frames: scaffolds, shelves, racks, climbing frames, goals."""
    rng = kit.rng
    columns, rows = int(rng.integers(2, 5)), int(rng.integers(1, 5))
    half_x, half_y, level = rng.uniform(0.5, 2), rng.uniform(0.2, 0.8), rng.uniform(0.4, 1)
    bar = rng.uniform(0.015, 0.06)
    metal = kit.material(gloss=0.3)
    boards = kit.chance(0.6)
    top = rows * level
    kind = CYL if kit.chance(0.5) else BOX
    for x in np.linspace(-half_x, half_x, columns):
        kit.add(kind, (x, half_y, top / 2), (bar, bar, top / 2), material=metal, mirror=True)
    for row in range(1, rows + 1):
        z = row * level
        for y in (-half_y, half_y):
            kit.between((-half_x, y, z), (half_x, y, z), bar, kind, material=metal)
        for x in (-half_x, half_x):
            kit.between((x, -half_y, z), (x, half_y, z), bar, kind, material=metal)
        if boards:
            kit.add(BOX, (0, 0, z + bar), (half_x, half_y, 0.02), material=kit.material(pattern=PLANKS))
        if kit.chance(0.5):
            kit.between((-half_x, half_y, z - level), (half_x, half_y, z), bar * 0.8, material=metal, mirror=True)
        if boards and kit.chance(0.6):  # goods
            for _ in range(int(rng.integers(1, 5))):
                half = rng.uniform(0.08, 0.25, 3) * np.array([1, half_y * 2, level])
                kit.add(rng.choice([BOX, CYL]), (rng.uniform(-0.8, 0.8) * half_x, 0, z + half[2]), half)
    if kit.chance(0.4):
        kit.add(BOX, (0, half_y, top / 2), (half_x, 0.01, top / 2), material=metal, cut=(rng.choice([GRID, LATTICE]), rng.uniform(2, 6), 0.12))


def lattice_tower(kit, base, half, top_half, height, material, bars=None):
    """Four leaning lattice panels around the axis over `base`."""
    share = (LATTICE, bars or kit.rng.uniform(0.7, 1.4) / half, kit.rng.uniform(0.1, 0.22))
    lean = half - top_half
    tilt = np.degrees(np.arctan2(lean, height))
    x, y, z = base
    for k in range(4):
        spin = turn("z", 90 * k)
        centre = np.array([x, y, z + height / 2]) + spin @ np.array([0, (half + top_half) / 2, 0])
        rotation = spin @ turn("x", tilt)
        kit.add(BOX, centre, (half, 0.012, height / 2), (top_half / half, 1), rotation=rotation, material=material, cut=share)


def lattice_mast(kit):
    """Pylons, radio and launch towers, with arms, dishes and platforms."""
    rng = kit.rng
    metal = kit.material(gloss=0.25, pattern=rng.choice([0, 2, 13]))
    height, half = rng.uniform(2.5, 6), rng.uniform(0.25, 0.7)
    lattice_tower(kit, (0, 0, 0), half, half * rng.uniform(0.15, 1), height, metal)
    if kit.chance(0.5):
        for k in range(int(rng.integers(1, 4))):
            z = height * (0.95 - 0.17 * k)
            kit.between((0, -half * 2.4, z), (0, half * 2.4, z), (0.06, 0.04), BOX, material=metal)
    if kit.chance(0.5):
        kit.between((0, 0, height), (0, 0, height + rng.uniform(0.4, 1.5)), 0.03, material=metal)
    for _ in range(rng.integers(0, 4)):
        a = rng.uniform(0, 360)
        size = rng.uniform(0.15, 0.4)
        place = turn("z", a) @ np.array([half, 0, 0]) + np.array([0, 0, height * rng.uniform(0.5, 0.95)])
        kit.add(CYL, place, (size, size, 0.08), (0.5, 1), rotation=turn("z", a) @ turn("y", 90))
    if kit.chance(0.4):
        kit.add(BOX, (0, 0, 0.15), (half * 1.6, half * 1.6, 0.15), material=kit.material())


def crane(kit):
    """Tower crane or a crane on a truck's or ship's deck."""
    rng = kit.rng
    metal = kit.material(base=paint(rng.choice([0.12, 0.02, 0.6]), rng.uniform(0.5, 1), 0.7), pattern=0)
    height, half, jib = rng.uniform(3, 6), rng.uniform(0.15, 0.3), rng.uniform(2, 5)
    bars = (LATTICE, rng.uniform(2.5, 5), 0.16)
    for k in (0, 90):
        for side in (-half, half):
            place = turn("z", k) @ np.array([0, side, height / 2])
            kit.add(BOX, place, (half, 0.015, height / 2), rotation=turn("z", k), material=metal, cut=bars)
    for side in (-half * 0.8, half * 0.8):
        kit.add(BOX, (jib / 2, side, height + half), (jib / 2, 0.015, half * 0.8), material=metal, cut=bars)
    kit.add(BOX, (jib / 2, 0, height + half * 0.2), (jib / 2, half * 0.8, 0.015), material=metal, cut=bars)
    kit.add(BOX, (-jib * 0.2, 0, height + half), (jib * 0.2, half * 0.7, half * 0.4), material=metal, cut=bars)
    kit.add(BOX, (-jib * 0.36, 0, height + half * 0.3), (jib * 0.06, half * 0.9, half * 1.4), material=kit.material())
    kit.add(BOX, (half, half * 1.4, height - half), (half, half * 0.8, half * 1.1), material=kit.material())
    peak = height + rng.uniform(0.6, 1.4)
    kit.between((0, 0, height), (0, 0, peak), half * 0.5, BOX, 0.3, material=metal)
    for end in (jib * 0.85, -jib * 0.35):
        kit.between((0, 0, peak), (end, 0, height + 1.8 * half), 0.015, material=metal)
    hook = jib * rng.uniform(0.4, 0.9)
    kit.between((hook, 0, height), (hook, 0, height * rng.uniform(0.3, 0.8)), 0.015)
    kit.add(BOX, (0, 0, 0.1), (half * 3, half * 3, 0.1), material=kit.material())


def fence(kit):
    """A run of posts and rails, perhaps with a gate, perhaps around a corner."""
    rng = kit.rng
    wood = kit.material()
    height, step = rng.uniform(0.6, 1.4), rng.uniform(0.8, 1.6)
    points = [np.array([-step * 1.5, 0, 0])]
    for _ in range(int(rng.integers(2, 5))):
        bend = rng.choice([0, 0, 0, 90])
        previous = points[-1] - points[-2] if len(points) > 1 else np.array([step, 0, 0])
        points.append(points[-1] + turn("z", bend) @ previous)
    kind = rng.choice([BARS, LATTICE, GRID])
    for start, end in zip(points[:-1], points[1:], strict=True):
        kit.railing(start + [0, 0, 0.1], end + [0, 0, 0.1], height * 0.85, wood, rng.uniform(0.1, 0.3), kind)
    for point in points:
        kit.add(BOX, point + [0, 0, height / 2], (0.05, 0.05, height / 2), material=wood)


def street_furniture(kit):
    """Lamps, traffic lights, signs, hydrants, bins, letter boxes, kiosks, flags."""
    rng = kit.rng
    kind = rng.integers(0, 6)
    metal = kit.material(dark=kit.chance(0.5), gloss=0.3)
    height = rng.uniform(1.5, 3.5)
    if kind == 0:
        kit.loft((0, 0, 0), [(0, 0.12), (0.3, 0.06), (height, 0.035)], metal)
        arms = int(rng.integers(1, 4))
        for x, y in around(arms, rng.uniform(0.3, 0.7)):
            kit.chain([(0, 0, height * 0.92), (x * 0.6, y * 0.6, height), (x, y, height)], 0.025, metal)
            kit.add(BALL, (x, y, height - 0.05), (0.14, 0.14, 0.1), material=kit.material(base=[0.9, 0.85, 0.7], gloss=-1))
    elif kind == 1:
        kit.add(CYL, (0, 0, height / 2), (0.05, 0.05, height / 2), material=metal)
        kit.add(BOX, (0.06, 0, height), (0.09, 0.13, 0.36), material=metal)
        for i, hue in enumerate((0.33, 0.13, 0.0)):
            lamp = kit.material(base=paint(hue, 0.9, 0.7), pattern=0, gloss=-1 if kit.chance(0.4) else 0.1)
            kit.add(CYL, (0.15, 0, height + 0.22 * (i - 1)), (0.08, 0.08, 0.03), rotation=turn("y", 90), material=lamp)
    elif kind == 2:
        kit.add(CYL, (0, 0, height / 2), (0.03, 0.03, height / 2), material=metal)
        plate = kit.material(pattern=rng.choice([0, 14, 11, 4]), frequency=rng.uniform(3, 10))
        shape, sides = (PRISM, int(rng.choice([3, 4, 8]))) if kit.chance(0.5) else (CYL, 1)
        kit.add(shape, (0.05, 0, height), (0.35, 0.35, 0.015), (1, sides), rotation=turn("y", 90), material=plate)
    elif kind == 3:
        body = kit.material(base=paint(rng.choice([0, 0.13, 0.6]), 0.9, 0.6))
        kit.loft((0, 0, 0), [(0, 0.2), (0.06, 0.2), (0.08, 0.13), (0.6, 0.12), (0.62, 0.16), (0.75, 0.03)], body)
        for y in (-0.15, 0.15):
            kit.add(CYL, (0, y, 0.45), (0.06, 0.06, 0.07), rotation=ALONG_Y, material=body)
    elif kind == 4:
        body = kit.material()
        half = rng.uniform(0.25, 0.6, 2)
        kit.add(BOX, (0, 0, height * 0.3), (*half, height * 0.3), material=body)
        kit.add(BOX, (half[0], 0, height * 0.4), (0.02, half[1] * 0.7, height * 0.12), material=kit.material(dark=True, gloss=0.5))
        kit.add(CYL, (0, 0, height * 0.6), (half[0], half[0], half[1]), rotation=ALONG_Y, material=body)
        kit.add(BOX, (half[0], 0, height * 0.2), (0.015, half[1] * 0.6, 0.1), material=kit.material(pattern=14, frequency=14))
    else:
        kit.add(CYL, (0, 0, height * 0.7), (0.03, 0.03, height * 0.7), material=metal)
        kit.add(BALL, (0, 0, height * 1.4), (0.06, 0.06, 0.06), material=metal)
        kit.add(BOX, (0.45, 0, height * 1.25), (0.42, 0.02, 0.25), (1, 1), (0.1, 0), material=kit.material(pattern=rng.choice([2, 11, 16, 0])))
