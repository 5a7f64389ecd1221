"""Makers of what stands on tables and floors: cups, bowls, bottles, shoes, lamps, instruments, chairs, screens."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, PRISM, TUBE
from .materials import PLANKS, paint


def vessel(kit):
    """Cups with saucers, mugs, bowls, pots, buckets, baskets: hollow, with handles and what they hold."""
    rng = kit.rng
    glaze = kit.material(pattern=rng.choice([0, 0, 0, 2, 12, 17, 14]), gloss=rng.uniform(0.1, 0.64))
    inside = glaze if kit.chance(0.5) else kit.material(base=rng.uniform(0.6, 0.95) * np.ones(3), pattern=0)
    radius, height, flare = rng.uniform(0.35, 0.7), rng.uniform(0.3, 1.1), rng.uniform(1.0, 1.5)
    z = 0.0
    if kit.chance(0.4):
        plate = radius * rng.uniform(1.5, 2.2)
        kit.add(CYL, (0, 0, 0.05), (plate * 0.6, plate * 0.6, 0.05), (1 / 0.6, 1), material=glaze)
        kit.add(CYL, (0, 0, 0.101), (plate * 0.55, plate * 0.55, 0.004), material=inside)
        z = 0.1
        if kit.chance(0.4):
            spoon = kit.material(base=[0.6, 0.6, 0.6], gloss=0.64, pattern=0)
            kit.add(BALL, (0, plate * 0.75, z + 0.06), (0.14, 0.09, 0.03), material=spoon)
            kit.between((0, plate * 0.75, z + 0.06), (plate * 0.8, plate * 0.55, z + 0.1), 0.02, material=spoon)
    basket = kit.chance(0.12)
    cut = (rng.choice([GRID, LATTICE]), 24, 0.5) if basket else (0, 1, 1)
    low = radius * 0.75
    kit.add(TUBE, (0, 0, z + height * 0.15), (low, low, height * 0.15), (radius / low, 1), material=glaze, cut=cut)
    kit.add(TUBE, (0, 0, z + height * 0.65), (radius, radius, height * 0.35), (flare, 1), material=glaze, cut=cut)
    inner = 0.93
    kit.add(TUBE, (0, 0, z + height * 0.65), (radius * inner, radius * inner, height * 0.35), (flare, 1), material=inside, cut=cut)
    kit.add(CYL, (0, 0, z + height * 0.02), (low, low, height * 0.02), material=glaze)
    level = rng.uniform(0.2, 0.9)
    r = radius * (1 + (flare - 1) * (level - 0.3) / 0.7) * 0.92 if level > 0.3 else radius * 0.85
    kit.add(CYL, (0, 0, z + height * level - 0.02), (r, r, 0.02), material=kit.material(gloss=0.4))
    if kit.chance(0.65):
        top, out = z + height * 0.85, radius * flare
        size = height * 0.3
        points = [(out * 0.95, 0, top), (out + size, 0, top - 0.02), (out + size * 1.1, 0, top - size), (out * 0.85, 0, z + height * 0.25)]
        kit.chain(points, rng.uniform(0.04, 0.08), glaze)
    elif kit.chance(0.3):
        kit.chain([(0, -radius * flare, z + height), (0, 0, z + height * 1.7), (0, radius * flare, z + height)], 0.03, kit.material())
    for _ in range(int(rng.integers(1, 6)) if kit.chance(0.25) else 0):
        ball = rng.uniform(0.15, 0.3)
        kit.add(BALL, (*rng.normal(0, radius * 0.4, 2), z + height * level + ball * 0.6), (ball,) * 3, material=kit.material(pattern=1))


def turned(kit):
    """Bottles, vases, chessmen, trophies, lamps, candlesticks: bodies of revolution with smooth profiles."""
    rng = kit.rng
    body = kit.material(pattern=rng.choice([0, 0, 1, 2, 12, 14]), gloss=rng.uniform(0, 0.64))
    height, count = rng.uniform(1, 2.6), int(rng.integers(5, 12))
    knots = np.exp(rng.normal(-1.0, 0.5, 5))
    at = np.linspace(0, 1, count)
    radii = np.clip(np.interp(at, np.linspace(0, 1, 5), knots), 0.08, 0.9)
    profile = list(zip(at * height, radii, strict=True))
    kit.loft((0, 0, 0), profile, body)
    top = profile[-1][1]
    kind = rng.random()
    if kind < 0.25:
        kit.add(BALL, (0, 0, height + top * 0.6), (top * rng.uniform(0.8, 1.3),) * 3, material=body)
    elif kind < 0.45:
        kit.add(CYL, (0, 0, height + 0.05), (top * 1.1, top * 1.1, 0.07), material=kit.material())
    elif kind < 0.65:
        shade = rng.uniform(0.5, 0.9)
        kit.add(TUBE, (0, 0, height + 0.35), (shade, shade, 0.4), (rng.uniform(0.4, 0.9), 1), material=kit.material(gloss=0 if kit.chance(0.6) else -0.8))
        kit.add(CYL, (0, 0, height + 0.2), (0.03, 0.03, 0.4), material=body)
    elif kind < 0.8:
        kit.chain([(0, radii[-3], height * 0.8), (0, radii[-3] + 0.4, height * 0.75), (0, radii[2], height * 0.35)], 0.06, body, mirror=kit.chance(0.6))
    else:
        green = kit.material(base=paint(rng.uniform(0.2, 0.4), 0.8, 0.35), pattern=1)
        for _ in range(int(rng.integers(4, 12))):
            tip = np.array([*rng.normal(0, 0.6, 2), height + rng.uniform(0.3, 1.3)])
            kit.between((0, 0, height * 0.9), tip, (0.05, 0.02), BOX, 0.5, material=green)
            if kit.chance(0.4):
                kit.add(BALL, tip, (0.12, 0.12, 0.1), material=kit.material())
    if kit.chance(0.4):
        label = kit.material(base=rng.uniform(0.4, 0.95) * np.ones(3), pattern=14, frequency=rng.uniform(6, 20))
        k = count // 2
        kit.loft((0, 0, 0), [(z, r * 1.01) for z, r in profile[max(0, k - 2) : k + 1]], label)


def seat(kit):
    """Chairs, stools, armchairs, benches, prams, with spindles, slats, cushions, arms."""
    rng = kit.rng
    wood = kit.material(pattern=rng.choice([0, PLANKS, 1]))
    cloth = kit.material()
    half_x, half_y, leg = rng.uniform(0.3, 0.5), rng.uniform(0.3, 1.0), rng.uniform(0.35, 0.75)
    thick = rng.uniform(0.02, 0.06)
    soft = kit.chance(0.35)
    if soft:
        kit.add(BOX, (0, 0, leg * 0.55), (half_x * 1.2, half_y * 1.1, leg * 0.4), material=cloth)
        kit.add(BOX, (0.05, 0, leg * 1.05), (half_x * 1.1, half_y * 0.9, 0.1), material=cloth)
        kit.add(BOX, (-half_x, 0, leg + 0.4), (0.12, half_y * 1.1, 0.45), (0.8, 0.95), (-0.1, 0), material=cloth)
        kit.add(BOX, (0, half_y * 1.1, leg * 0.95), (half_x * 1.15, 0.1, leg * 0.5), material=cloth, mirror=True)
        return
    splay = rng.uniform(0, 0.12)
    for x in (-1, 1):
        kit.between((x * half_x * (1 + splay), half_y * (0.95 + splay), 0), (x * half_x * 0.9, half_y * 0.9, leg), thick, rng.choice([CYL, BOX]), material=wood, mirror=True)
    if kit.chance(0.5):
        kit.between((half_x * 0.9, half_y * 0.93, leg * 0.4), (-half_x * 0.9, half_y * 0.93, leg * 0.4), thick * 0.6, material=wood, mirror=True)
        kit.between((0, half_y * 0.93, leg * 0.4), (0, -half_y * 0.93, leg * 0.4), thick * 0.6, material=wood)
    kit.add(BOX, (0, 0, leg), (half_x, half_y, rng.uniform(0.02, 0.06)), material=wood if kit.chance(0.5) else cloth)
    back = rng.uniform(0.3, 0.7)
    if kit.chance(0.85):
        lean = rng.uniform(0, 0.15)
        top = (-half_x - lean, half_y * 0.92, leg + back)
        kit.between((-half_x * 0.95, half_y * 0.92, leg), top, thick, material=wood, mirror=True)
        kit.between((top[0], -half_y * 0.95, top[2]), (top[0], half_y * 0.95, top[2]), (0.05, 0.02), BOX, material=wood)
        tilt = turn("y", -np.degrees(np.arctan2(lean, back)))
        filling = (0, 1, 1) if kit.chance(0.3) else (BARS, rng.uniform(5, 12), rng.uniform(0.2, 0.45))
        kit.add(BOX, (-half_x - lean / 2, 0, leg + back / 2), (0.012, half_y * 0.9, back / 2), rotation=tilt, material=wood, cut=filling)
        if kit.chance(0.4):
            kit.between((-half_x, half_y, leg + back * 0.4), (half_x * 0.8, half_y, leg + back * 0.4), thick, BOX, material=wood, mirror=True)
            kit.between((half_x * 0.75, half_y, leg), (half_x * 0.75, half_y, leg + back * 0.4), thick * 0.7, material=wood, mirror=True)


def gadget(kit):
    """Screens, laptops, cameras, radios, ovens, robots, telescopes, fans."""
    rng = kit.rng
    shell, dark = kit.material(gloss=0.3, pattern=rng.choice([0, 0, 0, 1, 14])), kit.material(dark=True, gloss=0.4)
    kind = rng.integers(0, 7)
    lit = kit.material(pattern=rng.choice([14, 16, 1, 15, 0]), gloss=-rng.uniform(0.5, 1)) if kit.chance(0.6) else dark
    if kind == 0:
        wide, tall = rng.uniform(0.6, 1.2), rng.uniform(0.4, 0.7)
        kit.add(BOX, (0, 0, tall + 0.3), (0.05, wide, tall), material=shell)
        kit.add(BOX, (0.045, 0, tall + 0.3), (0.015, wide * 0.94, tall * 0.9), material=lit)
        kit.add(BOX, (-0.05, 0, 0.25), (0.04, 0.1, 0.25), material=shell)
        kit.add(rng.choice([BOX, CYL]), (0, 0, 0.02), (0.25, 0.4, 0.02), material=shell)
    elif kind == 1:
        kit.add(BOX, (0, 0, 0.03), (0.5, 0.7, 0.03), material=shell)
        kit.add(BOX, (0.08, 0, 0.065), (0.28, 0.62, 0.006), material=dark, cut=(GRID, 14, 0.75))
        lean = rng.uniform(-25, 5)
        tilt = turn("y", lean)
        centre = np.array([-0.5, 0, 0.05]) + tilt @ np.array([0, 0, 0.48])
        kit.add(BOX, centre, (0.02, 0.7, 0.48), rotation=tilt, material=shell)
        kit.add(BOX, centre + tilt @ np.array([0.02, 0, 0]), (0.006, 0.65, 0.42), rotation=tilt, material=lit)
    elif kind == 2:
        kit.add(BOX, (0, 0, 0.45), (0.25, 0.65, 0.42), material=shell)
        kit.loft((0.25, 0, 0.45), [(0, 0.33), (rng.uniform(0.1, 0.5), 0.33), (0.55, 0.36)], dark, axis=ALONG_X)
        kit.add(CYL, (0.8, 0, 0.45), (0.28, 0.28, 0.02), rotation=ALONG_X, material=kit.material(base=[0.05, 0.06, 0.12], gloss=0.64))
        kit.add(BOX, (0, 0, 0.93), (0.15, 0.2, 0.1), (0.8, 0.7), material=dark)
        kit.add(CYL, (0, 0.5, 0.9), (0.08, 0.08, 0.05), material=dark)
    elif kind == 3:
        skin = shell
        kit.add(BOX, (0, 0, 1.1), (0.25, 0.4, 0.4), (1, rng.uniform(0.8, 1.3)), material=skin)
        kit.add(rng.choice([BOX, BALL, CYL]), (0, 0, 1.75), (0.22, 0.25, 0.2), material=skin)
        kit.add(BALL, (0.2, 0.1, 1.78), (0.05,) * 3, material=lit, mirror=True)
        kit.chain([(0, 0.5, 1.4), (0, 0.62, 1.05), (0.25, 0.6, 0.85)], 0.08, dark, mirror=True)
        kit.chain([(0, 0.2, 0.7), (0.05, 0.22, 0.4), (0, 0.22, 0.12)], 0.1, dark, mirror=True)
        kit.add(BOX, (0.08, 0.22, 0.06), (0.2, 0.12, 0.06), material=skin, mirror=True)
        kit.between((0, 0.1, 1.95), (0, 0.15, 2.25), 0.015, material=dark, mirror=kit.chance(0.5))
    elif kind == 4:
        top = rng.uniform(0.9, 1.4)
        for x, y in around(3, 0.55):
            kit.between((x, y, 0), (0, 0, top), 0.03, material=dark)
        aim = turn("y", 90 - rng.uniform(-10, 50))
        kit.loft((0, 0, top), [(-0.6, 0.08), (-0.4, 0.12), (0.7, 0.14), (0.8, 0.18), (0.95, 0.18)], shell, axis=aim)
    elif kind == 5:
        height = rng.uniform(0.5, 1.4)
        kit.add(CYL, (0, 0, 0.04), (0.35, 0.35, 0.04), material=shell)
        kit.add(CYL, (0, 0, height / 2), (0.04, 0.04, height / 2), material=shell)
        kit.add(CYL, (0.1, 0, height + 0.3), (0.45, 0.45, 0.07), rotation=ALONG_X, material=dark, cut=(6, 24, 0.2))
        kit.add(CYL, (0.1, 0, height + 0.3), (0.42, 0.42, 0.01), rotation=ALONG_X, material=shell, cut=(6, 4, 0.5))
        kit.add(BALL, (-0.05, 0, height + 0.3), (0.18, 0.13, 0.13), material=shell)
    else:
        half = rng.uniform(0.3, 0.8, 3)
        kit.add(BOX, (0, 0, half[2]), half, material=shell)
        kit.add(BOX, (half[0], -half[1] * 0.15, half[2]), (0.02, half[1] * 0.7, half[2] * 0.7), material=lit)
        for k in range(3):
            kit.add(CYL, (half[0], half[1] * 0.78, half[2] * (0.5 + 0.5 * k)), (0.06, 0.06, 0.04), rotation=ALONG_X, material=dark)


def clothing(kit):
    """Shoes, boots, hats, bags, suitcases, rucksacks."""
    rng = kit.rng
    cloth, sole = kit.material(gloss=rng.uniform(0, 0.3)), kit.material(dark=kit.chance(0.5))
    kind = rng.integers(0, 3)
    if kind == 0:
        for y in ((-0.3, 0.3) if kit.chance(0.6) else (0,)):
            long = rng.uniform(0.55, 0.75)
            kit.add(BOX, (0, y, 0.05), (long, 0.2, 0.05), (0.95, 0.95), material=sole)
            kit.add(BALL, (long * 0.5, y, 0.17), (long * 0.5, 0.2, 0.17), material=cloth)
            kit.add(BALL, (-long * 0.3, y, 0.22), (long * 0.65, 0.19, 0.24), material=cloth)
            shaft = rng.uniform(0.2, 0.9)
            kit.add(TUBE, (-long * 0.5, y, 0.25 + shaft / 2), (0.24, 0.17, shaft / 2), (rng.uniform(0.9, 1.15), 1), material=cloth)
            kit.add(BOX, (long * 0.15, y, 0.38), (0.16, 0.1, 0.03), rotation=turn("y", 25), material=kit.material(), cut=(BARS, 10, 0.6))
    elif kind == 1:
        half = rng.uniform(0.2, 0.7, 3)
        kit.add(BOX, (0, 0, half[2] + 0.06), half, (rng.uniform(0.8, 1), rng.uniform(0.8, 1)), material=cloth)
        kit.add(BOX, (half[0], 0, half[2] * 0.8), (0.08, half[1] * 0.7, half[2] * 0.5), material=cloth)
        top = 2 * half[2] + 0.06
        kit.chain([(0, -half[1] * 0.5, top), (0, -half[1] * 0.4, top + 0.35), (0, half[1] * 0.4, top + 0.35), (0, half[1] * 0.5, top)], 0.035, sole)
        for x in (-0.7, 0.7):
            kit.add(BALL, (x * half[0], half[1] * 0.8, 0.06), (0.06,) * 3, material=sole, mirror=True)
    else:
        crown = rng.uniform(0.35, 0.5)
        kit.add(CYL, (0, 0, 0.03), (crown * 1.8, crown * 1.6, 0.02), material=cloth)
        kit.add(CYL, (0, 0, 0.3), (crown, crown * 0.9, 0.28), (rng.uniform(0.6, 1), 1), material=cloth)
        kit.add(CYL, (0, 0, 0.12), (crown * 1.01, crown * 0.92, 0.06), material=sole)


def instrument(kit):
    """Guitars, drums, pianos, umbrellas, ladders, barrows, trolleys."""
    rng = kit.rng
    wood, dark = kit.material(base=paint(0.07, rng.uniform(0.3, 0.9), rng.uniform(0.1, 0.7)), gloss=0.4), kit.material(dark=True)
    kind = rng.integers(0, 5)
    if kind == 0:
        flat = turn("y", rng.uniform(75, 100)) if kit.chance(0.7) else np.eye(3)
        for z, r in ((0.45, 0.48), (1.05, 0.36)):
            kit.add(CYL, flat @ np.array([0, 0, 0]) + np.array([0, 0, z]), (r, r, 0.09), rotation=flat, material=wood)
        kit.add(CYL, (0.09, 0, 0.75), (0.14, 0.14, 0.02), rotation=flat, material=dark)
        kit.between((0.09, 0, 0.7), (0.05, 0, 2.2), (0.03, 0.06), BOX, material=dark)
        kit.add(BOX, (0.04, 0, 2.3), (0.03, 0.1, 0.18), material=wood)
    elif kind == 1:
        for _ in range(int(rng.integers(1, 5))):
            r, h = rng.uniform(0.25, 0.5), rng.uniform(0.15, 0.4)
            x, y, z = rng.uniform(-0.7, 0.7), rng.uniform(-0.7, 0.7), rng.uniform(0.4, 0.9)
            kit.add(CYL, (x, y, z), (r, r, h), material=wood)
            kit.add(CYL, (x, y, z + h), (r * 1.02, r * 1.02, 0.02), material=kit.material(base=[0.85] * 3))
            for px, py in around(3, r):
                kit.between((x + px, y + py, 0), (x + px, y + py, z), 0.02, material=dark)
        kit.add(CYL, (0.6, 0.6, 1.3), (0.4, 0.4, 0.012), rotation=turn("x", 12), material=kit.material(base=[0.6, 0.45, 0.1], gloss=0.6))
        kit.between((0.6, 0.6, 0), (0.6, 0.6, 1.3), 0.02, material=dark)
    elif kind == 2:
        wide = rng.uniform(0.8, 1.4)
        top = rng.uniform(1.6, 2.2)
        kit.add(PRISM, (0, 0, top), (wide, wide, 0.2), (0.05, int(rng.choice([4, 6, 8]))), material=kit.material(pattern=rng.choice([0, 11, 16])))
        kit.between((0, 0, 0), (0, 0, top), 0.04, material=wood)
        kit.add(CYL, (0, 0, 0.05), (0.35, 0.35, 0.05), material=dark)
        if kit.chance(0.5):
            kit.add(CYL, (0, 0, 0.8), (0.6, 0.6, 0.03), material=wood)
    elif kind == 3:
        top, lean = rng.uniform(1.5, 2.6), rng.uniform(0.2, 0.5)
        for side in (-1, 1):
            kit.between((side * lean, 0, 0), (0, 0, top), (0.02, 0.28), BOX, 0.8, material=wood, cut=(4 if kit.chance(0.1) else 3, rng.uniform(3, 4.5), 0.18))
        kit.add(BOX, (0, 0, top), (0.1, 0.2, 0.03), material=wood)
    else:
        kit.add(BOX, (0, 0, 0.65), (0.5, 0.3, 0.25), (1.25, 1.25), material=kit.material(gloss=0.4), cut=(GRID, 9, 0.3) if kit.chance(0.6) else (0, 1, 1))
        kit.between((-0.75, -0.3, 0.95), (-0.75, 0.3, 0.95), 0.03, material=dark)
        kit.between((-0.75, 0.28, 0.95), (0.5, 0.25, 0.35), 0.025, material=dark, mirror=True)
        for x in (-0.45, 0.5):
            kit.between((x, 0.25, 0.35), (x, 0.25, 0.1), 0.02, material=dark, mirror=True)
            kit.add(CYL, (x, 0.25, 0.1), (0.1, 0.1, 0.03), rotation=ALONG_Y, material=dark, mirror=True)


def blob(kit):
    """Bodies nobody knows: smooth lofts, rounded boxes and limbs around a common plane of symmetry."""
    rng = kit.rng
    main, second = kit.material(), kit.material()
    axis = rng.choice([0, 1])
    count = int(rng.integers(3, 8))
    radii = np.exp(rng.normal(-0.9, 0.5, count + 1))
    lengths = np.cumsum(np.concatenate([[0], rng.uniform(0.2, 0.8, count)]))
    frame = ALONG_X if axis else np.eye(3)
    kind = rng.choice([CYL, CYL, BOX, PRISM])
    kit.loft((-lengths[-1] / 2 * axis, 0, radii.max() * axis), list(zip(lengths, radii, strict=True)), main, kind, frame, rng.uniform(0.6, 1.4), int(rng.integers(3, 9)))
    size = lengths[-1]
    for _ in range(int(rng.integers(1, 7))):
        place = np.array([rng.uniform(-0.5, 0.5) * size * axis, abs(rng.normal(0, 0.4)), rng.uniform(0.1, 0.9) * (size if not axis else 2 * radii.max())])
        mirror = kit.chance(0.8)
        material = main if kit.chance(0.4) else second if kit.chance(0.6) else kit.material()
        shape = rng.random()
        if shape < 0.35:
            kit.add(BALL, place, np.exp(rng.normal(-1.4, 0.5, 3)), material=material, mirror=mirror)
        elif shape < 0.6:
            kit.add(BOX, place, np.exp(rng.normal(-1.5, 0.6, 3)), rng.uniform(0.4, 1.2, 2), rotation=turn(rng.choice(["x", "y", "z"]), rng.uniform(-40, 40)), material=material, mirror=mirror)
        elif shape < 0.85:
            tip = place + rng.normal(0, 0.6, 3) * np.array([1, 0.6, 1]) + np.array([0, 0.5, 0])
            kit.chain([place * [1, 0.3, 1], place, tip], rng.uniform(0.03, 0.2), material, mirror=mirror)
        else:
            kit.add(BOX, place, (rng.uniform(0.2, 0.8), 0.02, rng.uniform(0.2, 0.6)), rng.uniform(0.3, 1, 2), material=material, mirror=mirror)
