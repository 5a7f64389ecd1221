"""Makers of toys: figures, animals on rockers and wheels, vehicles of blocks, games, garden figures."""

import numpy as np

from .belongings import arc, black, brass, cloth, enamel, pale, steel, timber, twin
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, PRISM
from .materials import BANDS, CAMOUFLAGE, CHECKER, CLOUDY, DOTS, PLAIN, STRIPES, WAVES, WRITING, paint


def bright(kit):
    return kit.material(
        base=paint(kit.rng.choice([0, 0.05, 0.13, 0.3, 0.55, 0.62, 0.8, 0.92]), kit.rng.uniform(0.7, 1), kit.rng.uniform(0.35, 0.85)),
        pattern=PLAIN,
        gloss=kit.rng.uniform(0.05, 0.5),
    )


def plush(kit):
    base = paint(kit.rng.choice([0.05, 0.08, 0.1, kit.rng.random()]), kit.rng.uniform(0, 0.7), kit.rng.uniform(0.06, 0.85))
    return kit.material(base=base, pattern=kit.rng.choice([PLAIN, CLOUDY]), frequency=20, gloss=0.01)


def flesh(kit):
    return kit.material(base=np.array([0.7, 0.42, 0.28]) * kit.rng.uniform(0.3, 1.15), pattern=PLAIN, gloss=0.15)


def face(kit, at, size, apart=0.36, smile=True):
    """Eyes and a mouth on the front of a head of radius `size` around `at`."""
    dark = black(kit)
    at = np.array(at, float)
    kit.add(BALL, at + [size * 0.9, size * apart, size * 0.2], (size * 0.1, size * 0.11, size * 0.13), material=dark, mirror=True)
    if smile:
        kit.add(BOX, at + [size * 0.9, 0, -size * 0.35], (size * 0.06, size * 0.25, size * 0.05), material=kit.material(base=[0.5, 0.05, 0.05], pattern=PLAIN))


def rocking_horse(kit):
    rng = kit.rng
    coat = timber(kit) if kit.chance(0.5) else pale(kit) if kit.chance(0.5) else bright(kit)
    if kit.chance(0.4):
        coat = coat._replace(pattern=DOTS, frequency=8.0)
    second, mane = bright(kit), black(kit) if kit.chance(0.5) else cloth(kit)
    z, long = 0.85, rng.uniform(0.42, 0.52)
    first = len(kit.primitives)
    radius, y = rng.uniform(1.3, 1.8), 0.24
    reach = np.degrees(np.arcsin(1.0 / radius))
    points = arc((0, y, radius + 0.04), radius, 270 - reach, 270 + reach, 9)
    for start, end in zip(points[:-1], points[1:], strict=True):
        kit.between(start, end, (0.05, 0.035), BOX, material=second)
    for x in (-1, 1):
        foot = (x * 0.62, y, radius + 0.04 - np.sqrt(radius**2 - 0.62**2))
        kit.chain([(x * long * 0.75, 0.14, z), (x * 0.52, 0.2, z * 0.6), foot], [0.12, 0.07, 0.06], coat)
    twin(kit, first)
    for x in (-0.75, 0.75):
        kit.between((x, -y, radius + 0.06 - np.sqrt(radius**2 - x**2)), (x, y, radius + 0.06 - np.sqrt(radius**2 - x**2)), 0.04, material=second)
    kit.add(BALL, (0, 0, z), (long * 1.15, 0.22, 0.23), material=coat)
    neck = np.array([long * 1.3, 0, z + rng.uniform(0.42, 0.55)])
    kit.chain([(long * 0.7, 0, z + 0.05), neck], [0.19, 0.12], coat)
    nose = neck + [0.3, 0, -0.22]
    kit.chain([neck, nose], [0.13, 0.085], coat)
    kit.add(BOX, neck + [-0.05, 0.07, 0.17], (0.04, 0.03, 0.07), (0.3, 0.3), material=coat, mirror=True)
    kit.add(BALL, neck + [0.1, 0.11, 0.02], (0.03, 0.02, 0.03), material=black(kit), mirror=True)
    kit.between((long * 0.55, 0, z + 0.2), neck + [-0.13, 0, 0.1], (0.07, 0.03), BOX, material=mane)
    kit.chain([(-long * 1.1, 0, z + 0.08), (-long * 1.1 - 0.2, 0, z + 0.05), (-long * 1.1 - 0.25, 0, z - 0.3)], [0.05, 0.07, 0.04], mane)
    kit.add(BALL, (-0.02, 0, z + 0.12), (0.2, 0.21, 0.16), material=second)
    kit.between(neck + [-0.02, -0.26, -0.02], neck + [-0.02, 0.26, -0.02], 0.03, material=second)
    kit.between(neck + [0.18, 0, -0.14], neck + [0.2, 0, -0.17], 0.12, material=bright(kit))


def toy_wheel(kit, x, y, r, material, hub, wide=0.06):
    kit.add(CYL, (x, y, r), (r, r, wide), rotation=ALONG_Y, material=material, mirror=True)
    kit.add(CYL, (x, y + wide * 0.6, r), (r * 0.45, r * 0.45, wide * 0.7), rotation=ALONG_Y, material=hub, mirror=True)


def train(kit):
    rng = kit.rng
    wheels, hub, r = bright(kit), pale(kit), rng.uniform(0.13, 0.18)
    wood, engine = timber(kit), bright(kit)
    base = wood if kit.chance(0.6) else engine
    kit.add(BOX, (0.1, 0, r + 0.08), (0.72, 0.27, 0.07), material=base)
    kit.add(CYL, (0.25, 0, r + 0.38), (0.23, 0.23, 0.5), rotation=ALONG_X, material=engine)
    kit.add(CYL, (0.76, 0, r + 0.38), (0.19, 0.19, 0.03), rotation=ALONG_X, material=black(kit))
    kit.add(BOX, (-0.38, 0, r + 0.5), (0.22, 0.26, 0.38), material=bright(kit))
    kit.add(BOX, (-0.38, 0, r + 0.92), (0.3, 0.32, 0.05), material=bright(kit))
    kit.add(BOX, (-0.36, 0.262, r + 0.65), (0.12, 0.008, 0.12), material=black(kit), mirror=True)
    kit.loft((0.55, 0, r + 0.58), [(0, 0.08), (0.15, 0.08), (0.3, rng.uniform(0.09, 0.18))], bright(kit))
    kit.add(BALL, (0.1, 0, r + 0.6), (0.1, 0.1, 0.12), material=brass(kit))
    kit.add(BOX, (0.85, 0, r + 0.02), (0.06, 0.25, 0.1), (1, 0.5), (-0.05, 0), material=wheels)
    for x in (-0.4, 0.1, 0.5):
        toy_wheel(kit, x, 0.28, r * (1.25 if x < 0 else 1), wheels, hub)
    for k in range(int(rng.integers(0, 3))):
        x = -1.35 - 1.15 * k
        kit.between((x + 0.75, 0, r + 0.06), (x + 0.4, 0, r + 0.06), 0.03, material=black(kit))
        kit.add(BOX, (x, 0, r + 0.08), (0.46, 0.26, 0.07), material=wood)
        for side in (-0.28, 0.28):
            toy_wheel(kit, x + side, 0.28, r, wheels, hub)
        load = rng.random()
        if load < 0.5:
            for j, shape in enumerate((BOX, CYL, BOX)):
                kit.add(shape, (x + 0.3 * (j - 1), 0, r + 0.35), (0.135, 0.2 if shape == BOX else 0.135, rng.uniform(0.12, 0.22)), material=bright(kit))
        else:
            kit.add(BOX, (x, 0, r + 0.35), (0.42, 0.24, 0.22), material=bright(kit))
            kit.add(BOX, (x, 0, r + 0.6), (0.46, 0.28, 0.04), material=bright(kit))


def toy_car(kit):
    rng = kit.rng
    body, tyre, hub, glass = bright(kit), black(kit) if kit.chance(0.7) else bright(kit), bright(kit), kit.material(base=[0.06, 0.1, 0.16], pattern=PLAIN, gloss=0.5)
    r, long, wide = rng.uniform(0.2, 0.32), rng.uniform(0.7, 0.85), rng.uniform(0.36, 0.44)
    z = r * 0.9
    kind = rng.choice(["car", "truck", "racer", "bus"])
    kit.add(BOX, (0, 0, z + 0.14), (long, wide, 0.18 if kind != "racer" else 0.1), (0.96, 0.95), material=body)
    if kind == "car":
        kit.add(BOX, (-0.1, 0, z + 0.48), (long * 0.58, wide * 0.9, 0.2), (0.65, 0.85), material=glass)
        kit.add(BOX, (-0.1, 0, z + 0.68), (long * 0.4, wide * 0.79, 0.035), material=body)
        kit.add(BOX, (-0.1, 0, z + 0.48), (0.04, wide * 0.91, 0.2), (1, 0.86), material=body)
        kit.add(CYL, (long * 0.5, 0, z + 0.3), (wide * 0.9, 0.12, 0.06), material=body)
    elif kind == "truck":
        kit.add(BOX, (long * 0.6, 0, z + 0.5), (long * 0.34, wide * 0.95, 0.3), (0.85, 0.95), material=body)
        kit.add(BOX, (long * 0.62, 0, z + 0.6), (long * 0.35, wide * 0.82, 0.12), (0.9, 0.95), material=glass)
        bed = bright(kit)
        tilt = rng.choice([0, rng.uniform(10, 30)])
        lift = turn("y", tilt)
        hinge = np.array([-long * 1.0, 0, z + 0.3])
        kit.add(BOX, hinge + lift @ [long * 0.6, 0, 0.04], (long * 0.6, wide, 0.04), rotation=lift, material=bed)
        kit.add(BOX, hinge + lift @ [long * 0.6, wide * 0.95, 0.22], (long * 0.6, 0.04, 0.2), rotation=lift, material=bed, mirror=True)
        kit.add(BOX, hinge + lift @ [long * 1.2, 0, 0.25], (0.04, wide, 0.24), rotation=lift, material=bed)
        kit.add(BALL, hinge + lift @ [long * 0.6, 0, 0.15], (long * 0.5, wide * 0.85, 0.25), rotation=lift, material=kit.material(base=[0.35, 0.22, 0.1], pattern=CLOUDY))
    elif kind == "racer":
        kit.add(CYL, (0, 0, z + 0.16), (0.2, wide * 0.6, long * 1.15), (0.6, 1), rotation=ALONG_X, material=body)
        kit.add(BALL, (-0.05, 0, z + 0.42), (0.16, 0.16, 0.17), material=bright(kit))
        kit.add(BOX, (-long * 0.95, 0, z + 0.5), (0.12, wide * 1.05, 0.03), material=hub)
        kit.add(BOX, (-long * 0.95, wide * 0.6, z + 0.32), (0.08, 0.03, 0.2), material=hub, mirror=True)
        kit.add(CYL, (long * 0.1, wide * 0.96, z + 0.14), (0.14, 0.14, 0.02), rotation=ALONG_Y, material=pale(kit), mirror=True)
    else:
        kit.add(BOX, (0, 0, z + 0.55), (long * 0.98, wide * 0.96, 0.32), (0.95, 0.9), material=body)
        for k in range(4):
            kit.add(BOX, (long * (0.42 * k - 0.65), wide * 0.93, z + 0.62), (long * 0.14, 0.03, 0.13), material=glass, mirror=True)
        kit.add(BOX, (long * 0.95, 0, z + 0.6), (0.04, wide * 0.75, 0.15), material=glass)
    for x in (-0.6, 0.6):
        toy_wheel(kit, x * long, wide * 0.98, r, tyre, hub, rng.uniform(0.09, 0.14))
    if kind != "racer":
        kit.add(BALL, (long * 0.98, wide * 0.65, z + 0.18), (0.05, 0.07, 0.07), material=kit.material(base=[0.9, 0.85, 0.6], pattern=PLAIN), mirror=True)
        kit.add(BOX, (long * 1.0, 0, z + 0.02), (0.06, wide * 0.95, 0.05), material=steel(kit))


def toy_plane(kit):
    """An aeroplane of wood or tin with chunky wings."""
    rng = kit.rng
    body, wing, red = (timber(kit) if kit.chance(0.4) else bright(kit)), bright(kit), bright(kit)
    z, long, span = 0.5, rng.uniform(0.75, 0.95), rng.uniform(0.75, 1.0)
    kit.loft((-long, 0, z + 0.05), [(0, 0.07), (long * 0.7, 0.18), (long * 1.4, 0.25), (long * 1.75, 0.22), (long * 1.85, 0.12)], body, axis=ALONG_X)
    deep, levels = rng.uniform(0.18, 0.26), [z - 0.05] if kit.chance(0.6) else [z - 0.12, z + 0.5]
    for level in levels:
        kit.add(BOX, (long * 0.4, 0, level), (deep, span, 0.04), material=wing)
        kit.add(CYL, (long * 0.4, span, level), (deep, deep * 0.6, 0.04), material=wing, mirror=True)
    if len(levels) > 1:
        for x in (-0.12, 0.12):
            kit.between((long * 0.4 + x, span * 0.75, levels[0]), (long * 0.4 + x, span * 0.75, levels[1]), 0.025, material=body, mirror=True)
            kit.between((long * 0.4 + x, 0.12, z + 0.2), (long * 0.4 + x, 0.12, levels[1]), 0.025, material=body, mirror=True)
    kit.add(BOX, (-long * 0.9, 0, z + 0.08), (0.14, 0.36, 0.03), (1, 1), material=wing)
    kit.add(BOX, (-long * 0.92, 0, z + 0.28), (0.15, 0.03, 0.2), (0.6, 1), (-0.06, 0), material=red)
    kit.add(BALL, (long * 0.9, 0, z + 0.05), (0.12, 0.08, 0.08), material=red)
    spin = rng.uniform(0, 180)
    for k in range(int(rng.integers(2, 4))):
        way = turn("x", spin + (180 if k < 2 else 90) * k)
        kit.add(BALL, np.array([long * 0.93, 0, z + 0.05]) + way @ [0, 0, 0.2], (0.025, 0.07, 0.22), rotation=way, material=red)
    kit.add(
        BALL, (long * 0.1, 0, z + 0.36), (0.13, 0.13, 0.14), material=flesh(kit) if kit.chance(0.6) else kit.material(base=[0.1, 0.15, 0.25], pattern=PLAIN, gloss=0.6)
    )
    kit.between((long * 0.45, 0.12, z - 0.1), (long * 0.5, 0.26, 0.14), 0.03, material=body, mirror=True)
    kit.add(CYL, (long * 0.5, 0.28, 0.14), (0.14, 0.14, 0.05), rotation=ALONG_Y, material=black(kit), mirror=True)
    kit.between((-long * 0.85, 0, z), (-long * 0.95, 0, 0.12), 0.025, material=body)
    kit.add(CYL, (-long * 0.95, 0, 0.08), (0.08, 0.08, 0.03), rotation=ALONG_Y, material=black(kit))
    kit.add(CYL, (long * 0.4, span * 0.7, levels[-1] + 0.042), (0.11, 0.11, 0.004), material=pale(kit), mirror=True)


def blocks(kit):
    rng = kit.rng
    size, z = rng.uniform(0.2, 0.26), 0.0
    lettered = kit.chance(0.4)

    def block(at, spin):
        colour = bright(kit) if kit.chance(0.7) else timber(kit)
        kit.add(BOX, at, (size, size, size), rotation=spin, material=colour)
        if lettered:
            inner = pale(kit)._replace(pattern=WRITING, frequency=7.0, second=colour.first)
            for axis in (0, 1):
                half = np.full(3, size * 0.78)
                half[axis] = size * 1.02
                kit.add(BOX, at, half, rotation=spin, material=inner)

    rows = rng.choice(["tower", "pyramid", "castle"])
    if rows == "tower":
        for _ in range(int(rng.integers(3, 7))):
            block(np.array([*rng.normal(0, 0.03, 2), z + size]), turn("z", rng.normal(0, 12)))
            z += 2 * size
        if kit.chance(0.5):
            kit.add(PRISM, (0, 0, z + size * 0.7), (size, size, size * 0.7), (0.02, 4), material=bright(kit))
    elif rows == "pyramid":
        count = int(rng.integers(2, 5))
        for level in range(count):
            for k in range(count - level):
                block(np.array([0, (2 * k - count + level + 1) * size * 1.06, size * (2 * level + 1)]), turn("z", rng.normal(0, 6)))
    else:
        wide, tall = rng.uniform(0.5, 0.7), rng.uniform(0.6, 0.9)
        for y in (-wide, wide):
            kit.add(rng.choice([BOX, CYL]), (0, y, tall / 2), (size, size, tall / 2), material=bright(kit))
            if kit.chance(0.6):
                kit.add(CYL, (0, y, tall + 0.5 * size + 0.12), (size * 1.1, size * 1.1, size), (0.02, 1), material=bright(kit))
        kit.add(BOX, (0, 0, tall + 0.07 if not kit.chance(0.5) else tall * 0.5), (size * 0.85, wide * 0.99, 0.08), material=bright(kit))
        kit.add(BOX, (0, 0, tall * 0.25), (size * 0.8, wide, tall * 0.25), material=timber(kit))
        kit.add(BOX, (0, 0, tall * 0.5 + size), (size * 0.7, size * 0.7, size), material=bright(kit))
        kit.add(BOX, (0, 0, tall * 0.5 + 2.6 * size), (size * 0.75, size * 0.9, size * 0.6), (1, 0.02), material=bright(kit))
    if kit.chance(0.4):
        block(np.array([0.8, rng.uniform(-0.4, 0.4), size]), turn("z", rng.uniform(0, 90)))


def spinning_top(kit):
    rng = kit.rng
    skin = bright(kit)._replace(pattern=int(rng.choice([BANDS, STRIPES, DOTS, PLAIN])), frequency=rng.uniform(4, 12))
    r, trim = rng.uniform(0.6, 0.75), bright(kit)
    first = [(0, 0.02), (0.12, 0.05), (0.2, 0.15), (0.42, r * 0.75), (0.6, r)]
    kit.loft((0, 0, 0), first, skin if kit.chance(0.5) else bright(kit))
    kit.add(CYL, (0, 0, 0.63), (r * 1.02, r * 1.02, 0.04), material=trim)
    kit.loft((0, 0, 0.66), [(0, r), (0.12, r * 0.88), (0.25, r * 0.6), (0.36, r * 0.25), (0.4, 0.08)], skin)
    tall = rng.uniform(0.2, 0.6)
    kit.between((0, 0, 1.0), (0, 0, 1.05 + tall), 0.04, material=steel(kit))
    kit.add(BALL if kit.chance(0.7) else CYL, (0, 0, 1.07 + tall), (0.11, 0.11, 0.09), material=trim)
    if kit.chance(0.5):
        lean = turn("y", rng.uniform(15, 42))
        kit.primitives = [p._replace(centre=lean @ p.centre, rotation=lean @ p.rotation) for p in kit.primitives]


def teddy(kit):
    """A bear, rabbit, dog or elephant of plush, sitting or lying on its belly, with a bow."""
    rng = kit.rng
    fur = plush(kit)
    light, dark = fur._replace(first=np.clip(fur.first * 1.6 + 0.1, 0, 0.95)), black(kit)
    lying, kind = kit.chance(0.4), rng.choice(["bear", "bear", "rabbit", "dog", "elephant"])
    fat = rng.uniform(0.36, 0.46)
    head = rng.uniform(0.34, 0.42)
    if lying:
        kit.add(BALL, (-0.1, 0, fat * 0.75), (0.65, fat, fat * 0.75), material=fur)
        at = np.array([0.6, 0, head * rng.uniform(0.95, 1.3)])
        kit.chain([(0.3, 0.3, 0.2), (0.75, 0.5, 0.13)], [0.16, 0.14], fur, mirror=True)
        kit.chain([(-0.5, 0.25, 0.22), (-0.95, 0.42, 0.15)], [0.2, 0.16], fur, mirror=True)
        kit.add(BALL, (-1.04, 0.44, 0.17), (0.07, 0.14, 0.16), material=light, mirror=True)
        kit.add(BALL, (-0.75, 0, fat), (0.13, 0.11, 0.11), material=light if kind == "rabbit" else fur)
    else:
        kit.add(BALL, (0, 0, 0.5), (fat * 0.92, fat, 0.5), material=fur)
        kit.add(BALL, (0.1, 0, 0.46), (fat * 0.86, fat * 0.72, 0.38), material=light)
        at = np.array([0.05, 0, 0.92 + head * 0.75])
        out = rng.uniform(0.45, 0.65)
        kit.chain([(0.05, fat * 0.8, 0.75), (0.25, out, rng.uniform(0.35, 0.6))], [0.13, 0.14], fur, mirror=True)
        kit.chain([(0.1, 0.28, 0.18), (0.65, 0.42, 0.18)], [0.19, 0.17], fur, mirror=True)
        kit.add(BALL, (0.76, 0.43, 0.2), (0.08, 0.15, 0.19), material=light, mirror=True)
    kit.add(BALL, at, (head * 0.95, head * 1.05, head * 0.95), material=fur)
    if kind == "elephant":
        kit.chain([at + [head * 0.8, 0, -0.05], at + [head * 1.4, 0, -head * 0.6], at + [head * 1.9, 0, -head * 0.5]], [0.12, 0.09, 0.07], fur)
        kit.add(BALL, at + [-0.02, head * 1.25, 0.05], (0.06, head * 0.6, head * 0.7), rotation=turn("z", -20), material=fur, mirror=True)
    else:
        kit.add(BALL, at + [head * 0.8, 0, -head * 0.2], (head * 0.42, head * 0.42, head * 0.33), material=light)
        kit.add(BALL, at + [head * 1.2, 0, -head * 0.05], (head * 0.1, head * 0.15, head * 0.1), material=dark)
        if kind == "bear":
            kit.add(BALL, at + [0, head * 0.8, head * 0.72], (head * 0.2, head * 0.36, head * 0.36), material=fur, mirror=True)
            kit.add(BALL, at + [head * 0.14, head * 0.8, head * 0.72], (head * 0.12, head * 0.24, head * 0.24), material=light, mirror=True)
        elif kind == "rabbit":
            kit.chain(
                [at + [0, head * 0.4, head * 0.7], at + [-0.05, head * rng.uniform(0.5, 0.9), head * rng.uniform(1.8, 2.4)]], [head * 0.2, head * 0.17], fur, mirror=True
            )
        else:
            kit.chain([at + [0, head * 0.75, head * 0.6], at + [0, head * 1.2, -head * 0.4]], [head * 0.18, head * 0.3], light if kit.chance(0.5) else fur, mirror=True)
    kit.add(BALL, at + [head * 0.84, head * 0.38, head * 0.22], (head * 0.1, head * 0.11, head * 0.12), material=dark, mirror=True)
    if kit.chance(0.75):
        bow, front = bright(kit), at + ([head * 0.7, 0, -head * 0.9] if lying else [head * 0.85, 0, -head * 0.95])
        kit.add(CYL, front + [0, 0.15, 0], (0.11, 0.05, 0.11), (0.3, 1), rotation=turn("x", 90), material=bow, mirror=True)
        kit.add(BALL, front, (0.06, 0.06, 0.06), material=bow)


def doll(kit):
    """Rag dolls, ballerinas, princesses."""
    rng = kit.rng
    skin, dress, hair = flesh(kit), cloth(kit), kit.material(base=paint(rng.choice([0.02, 0.08, 0.12]), 0.7, rng.uniform(0.05, 0.7)), pattern=STRIPES, frequency=25)
    waist, head = rng.uniform(0.75, 0.95), rng.uniform(0.22, 0.3)
    hem = waist * rng.uniform(0.08, 0.6)
    wide = rng.uniform(0.3, 0.45)
    kit.add(CYL, (0, 0, (hem + waist) / 2), (wide, wide, (waist - hem) / 2), (0.14 / wide, 1), material=dress)
    kit.add(CYL, (0, 0, hem + 0.02), (wide * 1.02, wide * 1.02, 0.025), material=pale(kit))
    kit.add(CYL, (0, 0, waist + 0.15), (0.13, 0.16, 0.17), (1.15, 1), material=dress)
    kit.add(CYL, (0, 0, waist), (0.15, 0.16, 0.035), material=bright(kit))
    if hem > 0.12:
        kit.between((0, 0.1, 0.06), (0, 0.1, waist * 0.7), 0.06, material=pale(kit) if kit.chance(0.5) else skin, mirror=True)
        kit.add(BALL, (0.05, 0.1, 0.05), (0.12, 0.07, 0.06), material=bright(kit), mirror=True)
    shoulder = waist + 0.28
    hand = np.array([rng.uniform(0, 0.2), rng.uniform(0.32, 0.5), shoulder - rng.uniform(0.1, 0.4)])
    kit.add(BALL, (0, 0.17, shoulder), (0.1, 0.1, 0.1), material=dress, mirror=True)
    kit.chain([(0, 0.17, shoulder), hand], [0.055, 0.05], skin, mirror=True)
    kit.between((0, 0, shoulder), (0, 0, shoulder + 0.15), 0.06, material=skin)
    at = np.array([0, 0, shoulder + 0.1 + head])
    kit.add(BALL, at, (head * 0.92, head * 0.9, head), material=skin)
    kit.add(BALL, at + [-head * 0.2, 0, head * 0.2], (head * 0.95, head * 1.02, head * 0.95), material=hair)
    if kit.chance(0.5):
        kit.chain(
            [at + [0, head * 0.9, 0], at + [0, head * 1.25, -head * 0.6], at + [0, head * 1.1, -head * 1.4]], [head * 0.25, head * 0.22, head * 0.15], hair, mirror=True
        )
    else:
        kit.add(BALL, at + [-head * 0.45, 0, -head * 0.5], (head * 0.55, head * 0.95, head * 1.1), material=hair)
    face(kit, at, head * 0.98)
    what = rng.random()
    if what < 0.3:
        kit.add(CYL, at + [-0.02, 0, head * 0.85], (head * 0.6, head * 0.6, 0.07), (1.15, 1), material=brass(kit))
    elif what < 0.6:
        kit.add(CYL, at + [0, 0, head * 0.65], (head * 1.5, head * 1.5, 0.02), material=bright(kit))
        kit.add(CYL, at + [0, 0, head * 0.95], (head * 0.85, head * 0.85, head * 0.35), (0.85, 1), material=bright(kit))


def tin_robot(kit):
    rng = kit.rng
    body, trim, metal, lamp = (
        (enamel(kit) if kit.chance(0.6) else steel(kit)),
        bright(kit),
        steel(kit),
        kit.material(base=paint(rng.random(), 0.9, 0.9), pattern=PLAIN, gloss=-0.7),
    )
    leg, wide = rng.uniform(0.3, 0.5), rng.uniform(0.28, 0.36)
    kit.add(BOX, (0.06, wide * 0.5, 0.08), (0.2, wide * 0.42, 0.08), (0.9, 0.95), material=trim, mirror=True)
    kit.add(BOX, (0, wide * 0.5, 0.1 + leg / 2), (0.12, wide * 0.33, leg / 2), material=body, mirror=True)
    z = leg + 0.12
    tall = rng.uniform(0.27, 0.36)
    kit.add(BOX, (0, 0, z + tall), (0.22, wide, tall), (1, rng.uniform(1, 1.15)), material=body)
    kit.add(BOX, (0.22, 0, z + tall * 1.1), (0.015, wide * 0.7, tall * 0.55), material=trim)
    for k in range(3):
        kit.add(CYL, (0.24, (k - 1) * wide * 0.4, z + tall * 1.3), (0.05, 0.05, 0.02), rotation=ALONG_X, material=lamp if k == 1 else bright(kit))
    kit.add(CYL, (0.24, 0, z + tall * 0.85), (0.1, 0.1, 0.012), rotation=ALONG_X, material=pale(kit))
    top = z + 2 * tall
    kit.add(CYL, (0, 0, top + 0.03), (0.1, 0.1, 0.05), material=metal)
    head = rng.uniform(0.17, 0.24)
    kit.add(rng.choice([BOX, BOX, CYL]), (0, 0, top + 0.06 + head * 0.85), (head * 0.9, head, head * 0.85), material=body)
    if kit.chance(0.3):
        kit.add(BALL, (0, 0, top + 0.06 + 1.7 * head), (head * 0.85, head * 0.9, head * 0.6), material=body)
    face_z = top + 0.06 + head * 1.1
    kit.add(CYL, (head * 0.9, head * 0.45, face_z), (0.055, 0.055, 0.02), rotation=ALONG_X, material=lamp, mirror=True)
    kit.add(BOX, (head * 0.9, 0, face_z - head * 0.6), (0.015, head * 0.6, 0.035), material=black(kit))
    kit.add(CYL, (0, head * 1.05, face_z - 0.03), (0.07, 0.07, 0.04), rotation=ALONG_Y, material=trim, mirror=True)
    kit.between((0, head * 1.05, face_z), (0, head * 1.25, face_z + head * 1.2), 0.014, material=metal, mirror=True)
    arm = wide * 1.25
    kit.add(BALL, (0, arm, top - 0.12), (0.12, 0.12, 0.12), material=trim, mirror=True)
    lift = rng.uniform(-0.35, 0.1)
    kit.chain(
        [(0, arm + 0.03, top - 0.12), (0.03, arm + 0.1, top - 0.4), (0.28, arm + 0.08, top - 0.45 - lift * 0.3)],
        [0.075, 0.07, 0.07],
        body._replace(pattern=BANDS, frequency=25.0),
        mirror=True,
    )
    for y in (-0.06, 0.06):
        kit.between((0.3, arm + 0.08 + y, top - 0.45 - lift * 0.3), (0.43, arm + 0.08 + y * 0.8, top - 0.45 - lift * 0.3), (0.04, 0.02), BOX, material=metal, mirror=True)
    kit.between((-0.22, 0, z + tall), (-0.38, 0, z + tall), 0.025, material=metal)
    kit.add(CYL, (-0.4, 0.07, z + tall), (0.07, 0.07, 0.015), rotation=ALONG_X, material=metal, mirror=True)


def duck(kit):
    rng = kit.rng
    skin = kit.material(base=[0.85, 0.6, 0.03], pattern=PLAIN, gloss=0.4) if kit.chance(0.75) else bright(kit)
    beak = kit.material(base=[0.8, 0.2, 0.02], pattern=PLAIN, gloss=0.3)
    z, head = 0.36, rng.uniform(0.27, 0.34)
    lift = 0.0
    if kit.chance(0.25):
        lift = 0.2
        kit.add(BOX, (0, 0, 0.18), (0.6, 0.25, 0.04), material=bright(kit))
        for x in (-0.4, 0.4):
            toy_wheel(kit, x, 0.29, 0.15, bright(kit), pale(kit))
    kit.add(CYL, (0, 0, lift + 0.03), (0.46, 0.32, 0.03), (1.1, 1), material=skin)
    kit.add(BALL, (0, 0, lift + z), (0.62, 0.45, 0.34), material=skin)
    kit.add(BALL, (0.2, 0, lift + z + 0.05), (0.4, 0.4, 0.35), material=skin)
    kit.between((-0.38, 0, lift + z + 0.1), (-0.78, 0, lift + z + 0.38), (0.14, 0.22), CYL, 0.25, skin)
    kit.add(BALL, (-0.1, 0.4, lift + z + 0.1), (0.32, 0.1, 0.17), rotation=turn("y", 15), material=skin, mirror=True)
    at = np.array([0.3, 0, lift + z + 0.32 + head * 0.75])
    kit.add(BALL, at, (head, head * 0.95, head * 0.97), material=skin)
    kit.add(BALL, at + [head * 1.0, 0, -head * 0.1], (head * 0.5, head * 0.4, head * 0.13), rotation=turn("y", -12), material=beak)
    kit.add(BALL, at + [head * 0.95, 0, -head * 0.25], (head * 0.4, head * 0.35, head * 0.12), rotation=turn("y", 12), material=beak)
    kit.add(BALL, at + [head * 0.75, head * 0.5, head * 0.35], (head * 0.13, head * 0.14, head * 0.18), material=pale(kit), mirror=True)
    kit.add(BALL, at + [head * 0.84, head * 0.5, head * 0.35], (head * 0.1, head * 0.1, head * 0.13), material=black(kit), mirror=True)
    if kit.chance(0.3):
        kit.add(CYL, at + [0, 0, head * 0.8], (head * 0.9, head * 0.9, 0.02), material=black(kit))
        kit.add(CYL, at + [0, 0, head * 1.1], (head * 0.55, head * 0.55, head * 0.35), material=black(kit) if kit.chance(0.5) else bright(kit))


def brick_figure(kit):
    """A building-brick person: trapezoid trunk, cylinder head, clasped hands."""
    rng = kit.rng
    skin = kit.material(base=[0.85, 0.6, 0.05], pattern=PLAIN, gloss=0.4) if kit.chance(0.75) else flesh(kit)
    top, bottom, dark = bright(kit), bright(kit), black(kit)
    swing = rng.choice([0, rng.uniform(10, 30)])
    for side in (-1, 1):
        spin = turn("y", side * swing)
        hip = np.array([0, side * 0.15, 0.45])
        kit.add(BOX, hip + spin @ [0, 0, -0.21], (0.12, 0.14, 0.2), rotation=spin, material=bottom)
        kit.add(BOX, hip + spin @ [0.04, 0, -0.41], (0.17, 0.14, 0.04), rotation=spin, material=bottom)
        kit.add(CYL, hip, (0.12, 0.12, 0.14), rotation=ALONG_Y, material=bottom)
    kit.add(BOX, (0, 0, 0.57), (0.13, 0.3, 0.035), material=bottom if kit.chance(0.5) else dark)
    kit.add(BOX, (0, 0, 0.87), (0.15, 0.31, 0.27), (0.85, 0.7), material=top)
    kit.add(
        BOX,
        (0.145, 0, 0.85),
        (0.01, 0.13, 0.2),
        (1, 0.8),
        rotation=turn("y", -2.5),
        material=pale(kit)._replace(pattern=int(rng.choice([PLAIN, STRIPES, CHECKER, WRITING])), frequency=8.0),
    )
    kit.between((0, 0, 1.12), (0, 0, 1.2), 0.1, material=skin)
    for side in (-1, 1):
        raised = np.radians(rng.uniform(-30, 70))
        shoulder = np.array([0, side * 0.25, 1.06])
        elbow = shoulder + [0.05, side * 0.12, -0.2]
        hand = elbow + 0.24 * np.array([np.cos(raised), 0, np.sin(raised)])
        kit.add(BALL, shoulder, (0.1, 0.09, 0.1), material=top)
        kit.chain([shoulder, elbow, hand], [0.09, 0.085, 0.075], top)
        kit.add(CYL, hand + 0.45 * (hand - elbow), (0.085, 0.085, 0.06), material=skin)
    kit.add(CYL, (0, 0, 1.34), (0.17, 0.17, 0.15), material=skin)
    kit.add(CYL, (0, 0, 1.52), (0.09, 0.09, 0.04), material=skin)
    kit.add(BALL, (0.165, 0.065, 1.38), (0.015, 0.025, 0.03), material=dark, mirror=True)
    kit.add(BOX, (0.168, 0, 1.27), (0.008, 0.06, 0.012), material=dark)
    hat, colour = rng.choice(["hair", "helmet", "cap", "hat", "none"]), bright(kit)
    if hat == "hair":
        hair = kit.material(base=paint(0.07, 0.7, rng.uniform(0.03, 0.5)), pattern=PLAIN)
        kit.add(BALL, (-0.04, 0, 1.45), (0.21, 0.22, 0.16), material=hair)
        kit.add(BOX, (-0.12, 0, 1.34), (0.09, 0.2, 0.15), material=hair)
    elif hat == "helmet":
        kit.add(BALL, (-0.02, 0, 1.44), (0.23, 0.23, 0.2), material=colour)
        kit.add(BOX, (-0.08, 0, 1.34), (0.13, 0.22, 0.14), material=colour)
    elif hat == "cap":
        kit.add(CYL, (0, 0, 1.54), (0.18, 0.18, 0.07), (0.85, 1), material=colour)
        kit.add(BOX, (0.2, 0, 1.48), (0.1, 0.14, 0.012), material=colour)
    elif hat == "hat":
        kit.add(CYL, (0, 0, 1.49), (0.3, 0.3, 0.015), material=colour)
        kit.add(CYL, (0, 0, 1.6), (0.17, 0.17, 0.12), (0.85, 1), material=colour)
    if kit.chance(0.35):
        half = rng.uniform(0.45, 0.6)
        kit.primitives = [p._replace(centre=p.centre + [0, 0, 0.12]) for p in kit.primitives]
        kit.add(BOX, (0, 0, 0.06), (half, half, 0.06), material=bright(kit))


def dolls_house(kit):
    """A house of two floors, its front open on furnished rooms, or closed with windows."""
    rng = kit.rng
    wall, roof, trim = bright(kit) if kit.chance(0.6) else pale(kit), bright(kit), pale(kit)
    half, wide, floor = 0.32, rng.uniform(0.6, 0.85), rng.uniform(0.38, 0.48)
    tall = 2 * floor
    kit.add(BOX, (0, 0, 0.03), (half * 1.15, wide * 1.08, 0.03), material=timber(kit))
    kit.add(BOX, (-half, 0, tall / 2), (0.025, wide, tall / 2), material=wall)
    kit.add(BOX, (0, wide, tall / 2), (half, 0.025, tall / 2), material=wall, mirror=True)
    kit.add(BOX, (0, 0, floor), (half, wide, 0.02), material=timber(kit))
    kit.add(BOX, (0, 0, tall), (half * 1.02, wide * 1.02, 0.025), material=trim)
    high = rng.uniform(0.3, 0.5)
    kit.add(BOX, (-half, 0, tall + high / 2), (0.025, wide, high / 2), (1, 0.03), material=wall)
    slope = np.degrees(np.arctan2(high, wide))
    kit.add(BOX, (0, wide * 0.53, tall + high * 0.5), (half * 1.15, np.hypot(high, wide) * 0.56, 0.03), rotation=turn("x", -slope), material=roof, mirror=True)
    kit.add(BOX, (-half * 0.3, wide * 0.6, tall + high * 0.75), (0.08, 0.08, 0.25), material=bright(kit))
    if kit.chance(0.6):
        kit.add(BOX, (0, 0, tall / 2), (half, 0.02, tall / 2), material=trim)
        kit.add(BOX, (-half * 0.95, wide * 0.5, floor * 0.5), (0.015, wide * 0.45, floor * 0.45), material=kit.material(pattern=STRIPES), mirror=True)
        kit.add(BOX, (-half * 0.95, wide * 0.5, floor * 1.5), (0.015, wide * 0.45, floor * 0.45), material=kit.material(pattern=DOTS), mirror=True)
        kit.add(BOX, (-0.02, wide * 0.5, floor + 0.1), (0.15, 0.2, 0.06), material=bright(kit))
        kit.add(BOX, (-0.02, wide * 0.5 + 0.2, floor + 0.13), (0.15, 0.02, 0.12), material=timber(kit))
        kit.add(BOX, (-0.1, -wide * 0.5, floor + 0.12), (0.1, 0.16, 0.1), material=bright(kit))
        kit.add(CYL, (0, wide * 0.45, 0.22), (0.14, 0.14, 0.015), material=timber(kit))
        kit.between((0, wide * 0.45, 0.05), (0, wide * 0.45, 0.22), 0.03, material=timber(kit))
        for y in (0.25, -0.25):
            kit.add(BOX, (0, wide * 0.45 + y, 0.12), (0.06, 0.06, 0.07), material=bright(kit))
        kit.add(BOX, (-0.15, -wide * 0.5, 0.17), (0.12, 0.2, 0.12), material=bright(kit))
    else:
        kit.add(BOX, (half, 0, tall / 2), (0.025, wide, tall / 2), material=wall)
        kit.add(BOX, (half, 0, tall + high / 2), (0.025, wide, high / 2), (1, 0.03), material=wall)
        glass = kit.material(base=[0.1, 0.16, 0.22], pattern=PLAIN, gloss=0.5)
        for z in (floor * 0.55, floor * 1.5):
            kit.add(BOX, (half, wide * 0.6, z), (0.035, 0.15, 0.13), material=trim, mirror=True)
            kit.add(BOX, (half, wide * 0.6, z), (0.04, 0.12, 0.1), material=glass, mirror=True)
            kit.add(BOX, (half, wide * 0.6, z), (0.045, 0.012, 0.1), material=trim, mirror=True)
        kit.add(BOX, (half, 0, floor * 0.4), (0.04, 0.12, floor * 0.4), material=bright(kit))
        kit.add(BOX, (half, 0, floor * 1.5), (0.04, 0.12, 0.12), material=glass)
        kit.add(CYL, (half, 0, tall + high * 0.4), (0.09, 0.09, 0.035), rotation=ALONG_X, material=glass)


def chess(kit):
    """Pawns, rooks, bishops, knights, queens, kings; one or three in a row."""
    rng = kit.rng
    white = timber(kit) if kit.chance(0.5) else pale(kit)
    white = white._replace(pattern=int(rng.choice([PLAIN, WAVES, CLOUDY])), gloss=rng.uniform(0.2, 0.6))
    night = black(kit) if kit.chance(0.6) else timber(kit)
    count = int(rng.choice([1, 1, 3]))
    for k in range(count):
        wood = white if kit.chance(0.5) else night
        at, first = np.array([0, 0, 0.0]), len(kit.primitives)
        kind = rng.choice(["pawn", "rook", "bishop", "knight", "queen", "king"])
        tall = {"pawn": 0.75, "rook": 0.75, "bishop": 1.1, "knight": 0.5, "queen": 1.35, "king": 1.45}[kind] * rng.uniform(0.92, 1.08)
        kit.loft(at, [(0, 0.36), (0.08, 0.37), (0.11, 0.3), (0.18, 0.28), (0.22, 0.2)], wood)
        neck = 0.12 if kind in ("pawn", "bishop", "queen", "king") else 0.19
        if kind != "knight":
            kit.loft(at, [(0.22, 0.2), (tall * 0.45, neck * 1.1), (tall * 0.8, neck)], wood)
            kit.add(CYL, at + [0, 0, tall * 0.8], (neck * 1.8, neck * 1.8, 0.035), material=wood)
        top = tall * 0.83
        if kind == "pawn":
            kit.add(BALL, at + [0, 0, top + 0.15], (0.19, 0.19, 0.19), material=wood)
        elif kind == "rook":
            kit.add(CYL, at + [0, 0, top + 0.08], (0.25, 0.25, 0.1), (1.05, 1), material=wood)
            for x, y in around(6, 0.22):
                kit.add(BOX, at + [x, y, top + 0.22], (0.045, 0.08, 0.06), rotation=turn("z", np.degrees(np.arctan2(y, x))), material=wood)
        elif kind == "bishop":
            kit.loft(at + [0, 0, top], [(0, 0.1), (0.1, 0.17), (0.22, 0.16), (0.36, 0.05)], wood)
            kit.add(BALL, at + [0, 0, top + 0.4], (0.055, 0.055, 0.055), material=wood)
            kit.add(BOX, at + [0.13, 0, top + 0.24], (0.09, 0.2, 0.012), rotation=turn("y", -50), material=night if wood is white else white)
        elif kind == "knight":
            kit.chain([(-0.02, 0, 0.2), (-0.08, 0, 0.5), (-0.02, 0, 0.85)], [0.21, 0.17, 0.15], wood)
            kit.chain([(-0.02, 0, 0.88), (0.28, 0, 0.72)], [0.15, 0.1], wood)
            kit.add(BOX, (-0.06, 0.07, 1.05), (0.05, 0.04, 0.09), (0.3, 0.4), material=wood, mirror=True)
            kit.chain([(-0.1, 0, 1.0), (-0.23, 0, 0.75), (-0.25, 0, 0.4)], [0.05, 0.06, 0.05], wood)
            kit.add(BALL, (0.08, 0.12, 0.9), (0.025, 0.02, 0.025), material=night if wood is white else white, mirror=True)
        else:
            kit.loft(at + [0, 0, top], [(0, 0.12), (0.08, 0.13), (0.3, 0.22), (0.33, 0.2), (0.38, 0.08)], wood)
            if kind == "queen":
                for x, y in around(8, 0.19):
                    kit.add(BALL, at + [x, y, top + 0.32], (0.045, 0.045, 0.05), material=wood)
                kit.add(BALL, at + [0, 0, top + 0.43], (0.07, 0.07, 0.07), material=wood)
            else:
                kit.add(BOX, at + [0, 0, top + 0.5], (0.035, 0.035, 0.15), material=wood)
                kit.add(BOX, at + [0, 0, top + 0.53], (0.03, 0.1, 0.035), material=wood)
        move = np.array([rng.uniform(-0.1, 0.1), 0.95 * (k - (count - 1) / 2), 0])
        kit.primitives[first:] = [p._replace(centre=p.centre + move) for p in kit.primitives[first:]]
    if kit.chance(0.4):
        half = 0.5 + 0.48 * (count - 1)
        kit.add(BOX, (0, 0, -0.05), (0.5, half, 0.05), material=timber(kit)._replace(pattern=CHECKER, frequency=4.0))


def dice(kit):
    rng = kit.rng
    colour = bright(kit) if kit.chance(0.5) else pale(kit)
    dots = black(kit) if colour.first.mean() > 0.4 else pale(kit)
    spots = {1: [(0, 0)], 2: [(-1, -1), (1, 1)], 3: [(-1, -1), (0, 0), (1, 1)]}
    spots[4] = [(-1, -1), (1, 1), (-1, 1), (1, -1)]
    spots[5] = [*spots[4], (0, 0)]
    for k in range(int(rng.choice([1, 2, 2]))):
        spin = turn("z", rng.uniform(0, 90))
        at = np.array([rng.uniform(-0.2, 0.2), 1.35 * k, 0.4])
        kit.add(BOX, at, (0.4, 0.4, 0.4), rotation=spin, material=colour)
        for number, face_turn in zip((1, 2, 3, 4, 5), ("z0", "x90", "y90", "y-90", "x-90"), strict=True):
            side = spin @ turn(face_turn[0], float(face_turn[1:]))
            for u, v in spots[number]:
                kit.add(CYL, at + side @ [0.19 * u, 0.19 * v, 0.382], (0.075, 0.075, 0.024), rotation=side, material=dots)


def uniformed(kit):
    """Nutcrackers, toy soldiers on a base, with bearskins, shakos or helmets and rifles."""
    rng = kit.rng
    skin, coat, legs, dark, gold = flesh(kit), bright(kit), pale(kit) if kit.chance(0.5) else bright(kit), black(kit), brass(kit)
    nutcracker = kit.chance(0.5)
    z = 0.12
    if nutcracker or kit.chance(0.7):
        kit.add(CYL if kit.chance(0.4) else BOX, (0, 0, 0.06), (0.4, 0.4, 0.06), material=bright(kit) if nutcracker else timber(kit))
    else:
        kit.add(CYL, (0, 0, 0.06), (0.42, 0.34, 0.06), (0.95, 1), material=kit.material(base=[0.08, 0.2, 0.05], pattern=CLOUDY))
    apart = 0.13
    kit.between((0, apart, z), (0, apart, z + 0.65), 0.1, material=legs, mirror=True)
    kit.between((0, apart, z), (0, apart, z + 0.28), 0.115, material=dark, mirror=True)
    kit.add(BALL, (0.08, apart, z + 0.05), (0.18, 0.1, 0.08), material=dark, mirror=True)
    kit.add(CYL, (0, 0, z + 0.68), (0.22, 0.26, 0.1), (0.85, 1), material=coat)
    kit.add(CYL, (0, 0, z + 0.98), (0.18, 0.23, 0.25), (1.1, 1), material=coat)
    kit.add(CYL, (0, 0, z + 0.78), (0.2, 0.24, 0.04), material=dark)
    kit.add(BOX, (0.18, 0, z + 0.98), (0.025, 0.02, 0.2), material=gold)
    top = z + 1.23
    kit.add(BALL, (0, 0.26, top - 0.08), (0.12, 0.13, 0.1), material=coat, mirror=True)
    kit.add(CYL, (0, 0.29, top - 0.01), (0.13, 0.12, 0.025), material=gold, mirror=True)
    for side in (-1, 1):
        bent = not nutcracker and (side < 0 or kit.chance(0.3))
        hand = np.array([0.22, side * 0.24, top - 0.36]) if bent else np.array([0.03, side * 0.36, top - 0.6])
        kit.chain([(0, side * 0.3, top - 0.1), (0, side * 0.37, top - 0.36), hand], [0.08, 0.075, 0.065], coat)
        kit.add(BALL, hand, (0.07, 0.06, 0.08), material=skin)
    kit.add(CYL, (0, 0, top + 0.15), (0.15, 0.15, 0.19), material=skin)
    head = top + 0.34
    kit.add(BALL, (0.145, 0.06, top + 0.24), (0.02, 0.03, 0.035), material=dark, mirror=True)
    kit.add(BALL, (0.16, 0, top + 0.17), (0.045, 0.03, 0.04), material=skin)
    hair = pale(kit) if nutcracker else dark
    hat = rng.choice(["tall", "bear", "helmet", "crown"]) if not nutcracker or kit.chance(0.5) else "tall"
    if nutcracker:
        kit.add(BOX, (0.15, 0, top + 0.02), (0.03, 0.08, 0.05), material=pale(kit))
        kit.add(BOX, (0.13, 0, top - 0.08), (0.05, 0.1, 0.1), (1, 1.2), material=hair)
        kit.add(BOX, (0.155, 0.06, top + 0.11), (0.02, 0.07, 0.022), rotation=turn("x", 12), material=hair, mirror=True)
        kit.add(BOX, (-0.02, 0.15, top + 0.12), (0.1, 0.03, 0.17), material=hair, mirror=True)
        kit.add(BOX, (-0.22, 0, top - 0.1), (0.03, 0.06, 0.35), (1, 1), (0.1, 0), material=coat)
    if hat == "bear":
        kit.add(CYL, (0, 0, head + 0.1), (0.19, 0.19, 0.14), material=dark)
        kit.add(BALL, (0, 0, head + 0.22), (0.2, 0.2, 0.2), material=dark)
    elif hat == "helmet":
        kit.add(BALL, (0, 0, head - 0.06), (0.22, 0.22, 0.16), material=coat)
        kit.add(CYL, (0, 0, head - 0.06), (0.25, 0.23, 0.015), material=coat)
    elif hat == "crown":
        kit.add(CYL, (0, 0, head + 0.05), (0.16, 0.16, 0.1), (1.25, 1), material=gold)
        for x, y in around(5, 0.18):
            kit.add(CYL, (x, y, head + 0.2), (0.05, 0.05, 0.06), (0.1, 1), material=gold)
        kit.add(BALL, (0, 0, head + 0.13), (0.15, 0.15, 0.1), material=coat)
    else:
        kit.add(CYL, (0, 0, head + 0.17), (0.17, 0.17, 0.19), (1.1, 1), material=dark if kit.chance(0.6) else coat)
        kit.add(CYL, (0.08, 0, head), (0.17, 0.16, 0.015), material=dark)
        kit.add(BALL, (0.18, 0, head + 0.17), (0.02, 0.06, 0.07), material=gold)
        kit.between((0.12, 0, head + 0.3), (0.12, 0, head + 0.52), 0.045, material=bright(kit))
    if not nutcracker:
        kit.between((0.25, -0.27, z + 0.5), (0.18, -0.29, top + 0.75), (0.02, 0.03), material=timber(kit))
        kit.between((0.24, -0.27, z + 0.7), (0.19, -0.28, z + 0.95), (0.05, 0.03), BOX, material=timber(kit))
        kit.between((0.18, -0.29, top + 0.7), (0.16, -0.29, top + 0.95), 0.012, material=steel(kit))
        kit.add(BOX, (0.19, 0, z + 1.0), (0.015, 0.03, 0.28), rotation=turn("x", 35), material=pale(kit))
        kit.add(BOX, (-0.28, 0, z + 1.0), (0.1, 0.16, 0.15), material=timber(kit))
    elif kit.chance(0.5):
        kit.between((0.1, -0.4, z), (0.1, -0.4, top + 0.2), 0.025, material=gold)
        kit.add(BALL, (0.1, -0.4, top + 0.24), (0.06, 0.06, 0.07), material=gold)


def nesting(kit):
    rng = kit.rng
    scarf, dress, skin = bright(kit), bright(kit), flesh(kit)
    y, size = 0.0, 1.0
    for _ in range(int(rng.choice([1, 1, 3, 4]))):
        first = len(kit.primitives)
        kit.loft(
            (0, 0, 0),
            [(0, 0.36), (0.06, 0.4), (0.4, 0.47), (0.62, 0.45)],
            dress._replace(pattern=int(rng.choice([DOTS, CAMOUFLAGE, PLAIN, WAVES])), frequency=rng.uniform(4, 9)),
        )
        kit.loft((0, 0, 0.62), [(0, 0.45), (0.18, 0.4), (0.3, 0.32)], scarf)
        kit.add(BALL, (0, 0, 1.14), (0.34, 0.34, 0.36), material=scarf)
        kit.add(BALL, (0.09, 0, 1.14), (0.275, 0.25, 0.26), material=skin)
        kit.add(
            BALL, (0.3, 0, 0.42), (0.185, 0.3, 0.32), material=pale(kit)._replace(pattern=int(rng.choice([DOTS, PLAIN, CAMOUFLAGE])), frequency=9.0, second=scarf.first)
        )
        kit.add(CYL, (0, 0, 0.63), (0.462, 0.462, 0.012), material=black(kit))
        face(kit, (0.0, 0, 1.14), 0.37, 0.28)
        kit.add(BALL, (0.26, 0, 1.33), (0.08, 0.2, 0.06), material=black(kit))
        kit.add(BALL, (0.31, 0.13, 1.05), (0.04, 0.05, 0.04), material=kit.material(base=[0.8, 0.15, 0.15], pattern=PLAIN), mirror=True)
        kit.primitives[first:] = [p._replace(centre=p.centre * size + [0, y, 0], half=p.half * size) for p in kit.primitives[first:]]
        y += size * 0.92
        size *= 0.76


def gnome(kit):
    rng = kit.rng
    skin, coat, hat, beard = flesh(kit), bright(kit), bright(kit), pale(kit)
    fat = rng.uniform(0.3, 0.4)
    kit.add(CYL, (0, 0, 0.03), (0.42, 0.45, 0.03), material=kit.material(base=[0.15, 0.3, 0.06], pattern=CLOUDY))
    kit.add(BALL, (0.14, 0.17, 0.12), (0.24, 0.13, 0.11), material=black(kit), mirror=True)
    kit.between((0, 0.15, 0.06), (0, 0.14, 0.42), 0.14, material=bright(kit), mirror=True)
    kit.add(BALL, (0, 0, 0.62), (fat * 0.95, fat, 0.38), material=coat)
    kit.add(CYL, (0, 0, 0.55), (fat * 0.97, fat * 1.0, 0.045), material=black(kit))
    kit.add(BOX, (fat * 0.97, 0, 0.55), (0.03, 0.07, 0.06), material=brass(kit))
    z = 1.06
    kit.add(BALL, (0, 0, z), (0.23, 0.24, 0.24), material=skin)
    kit.add(BALL, (0.13, 0, z - 0.25), (0.18, 0.21, 0.32), material=beard)
    kit.add(BALL, (0.21, 0.09, z - 0.08), (0.06, 0.12, 0.045), rotation=turn("x", -15), material=beard, mirror=True)
    kit.add(BALL, (0.25, 0, z), (0.075, 0.065, 0.06), material=skin)
    kit.add(BALL, (0.2, 0.09, z + 0.07), (0.03, 0.03, 0.035), material=black(kit), mirror=True)
    tall, bend = rng.uniform(0.5, 0.8), rng.uniform(-0.25, 0.05)
    kit.between((0, 0, z + 0.1), (bend * 0.3, 0, z + 0.1 + tall * 0.55), 0.27, taper=0.55, material=hat)
    kit.between((bend * 0.3, 0, z + 0.1 + tall * 0.53), (bend, 0, z + 0.1 + tall), 0.15, taper=0.12, material=hat)
    kit.add(CYL, (0, 0, z + 0.12), (0.275, 0.275, 0.035), material=hat)
    hands = []
    for side in (-1, 1):
        hand = np.array([rng.uniform(0.2, 0.38), side * rng.uniform(0.32, 0.46), rng.uniform(0.5, 0.85)])
        kit.chain([(0, side * fat * 0.85, 0.83), (0.03, side * (fat + 0.12), 0.62), hand], [0.11, 0.1, 0.085], coat)
        kit.add(BALL, hand, (0.085, 0.08, 0.085), material=skin)
        hands.append(hand)
    hold = rng.choice(["rod", "lantern", "spade", "none"])
    if hold == "rod":
        kit.between(hands[0] - [0.1, 0, 0.15], hands[0] + [0.55, 0, 0.6], 0.02, material=timber(kit))
    elif hold == "lantern":
        kit.between(hands[1], hands[1] - [0, 0, 0.12], 0.015, material=black(kit))
        kit.add(CYL, hands[1] - [0, 0, 0.22], (0.08, 0.08, 0.1), material=kit.material(base=[0.9, 0.7, 0.2], pattern=PLAIN, gloss=-0.8))
        kit.add(CYL, hands[1] - [0, 0, 0.1], (0.1, 0.1, 0.04), (0.3, 1), material=black(kit))
    elif hold == "spade":
        x, y = hands[0][:2]
        kit.between((x, y, 0.3), (x, y, 1.15), 0.025, material=timber(kit))
        kit.add(BOX, (x, y, 0.18), (0.015, 0.1, 0.17), material=steel(kit))
        kit.add(BOX, (x, y, 1.16), (0.025, 0.1, 0.025), material=timber(kit))


def piggy_bank(kit):
    rng = kit.rng
    skin = (
        kit.material(base=[0.8, 0.35, 0.38], pattern=PLAIN, gloss=0.5)
        if kit.chance(0.6)
        else bright(kit)._replace(pattern=int(rng.choice([PLAIN, DOTS, CAMOUFLAGE])), frequency=6.0)
    )
    fat, dark = rng.uniform(0.4, 0.48), black(kit)
    z = fat + 0.15
    kit.add(BALL, (0, 0, z), (0.58, fat, fat), material=skin)
    for x in (-0.28, 0.28):
        kit.add(CYL, (x, 0.22, 0.15), (0.12, 0.12, 0.15), (1.2, 1), material=skin, mirror=True)
    kit.add(BALL, (0.38, 0, z + 0.08), (0.32, 0.33, 0.32), material=skin)
    kit.add(CYL, (0.7, 0, z + 0.02), (0.15, 0.17, 0.09), (0.9, 1), rotation=ALONG_X, material=skin)
    kit.add(BALL, (0.79, 0.06, z + 0.02), (0.012, 0.03, 0.045), material=dark, mirror=True)
    kit.add(BOX, (0.36, 0.24, z + 0.4), (0.05, 0.1, 0.11), (0.5, 0.1), rotation=turn("x", -20) @ turn("y", 15), material=skin, mirror=True)
    kit.add(BALL, (0.62, 0.17, z + 0.2), (0.04, 0.035, 0.05), material=dark, mirror=True)
    kit.chain(arc((-0.62, 0.0, z + 0.12), (0.06, 0.09), -90, 200, 7), 0.03, skin, joints=False)
    kit.between((-0.5, 0, z + 0.05), (-0.62, 0, z + 0.03), 0.035, material=skin)
    kit.add(BOX, (-0.05, 0, z + fat - 0.003), (0.13, 0.02, 0.012), material=dark)
    if kit.chance(0.4):
        kit.add(CYL, (-0.05, 0, z + fat + 0.08), (0.13, 0.13, 0.015), rotation=ALONG_Y, material=brass(kit))


def jack_in_box(kit):
    rng = kit.rng
    half = rng.uniform(0.36, 0.45)
    box = bright(kit)._replace(pattern=int(rng.choice([PLAIN, DOTS, CHECKER, STRIPES])), frequency=rng.uniform(3, 7))
    kit.add(BOX, (0, 0, half), (half, half, half), material=box)
    trim = bright(kit)
    for z in (0.04, 2 * half - 0.02):
        kit.add(BOX, (0, 0, z), (half * 1.04, half * 1.04, 0.04), material=trim)
    kit.add(BOX, (0, 0, half), (half * 1.03, half * 0.5, half * 0.5), material=pale(kit)._replace(pattern=int(rng.choice([WRITING, DOTS])), frequency=7.0))
    lean = turn("y", -rng.uniform(10, 40))
    kit.add(BOX, np.array([-half, 0, 2 * half]) + lean @ [0, 0, half], (0.03, half * 1.03, half), rotation=lean, material=trim)
    kit.add(BOX, (0, 0, 2 * half + 0.02), (half * 0.9, half * 0.9, 0.006), material=black(kit))
    kit.chain([(0, -half, half), (0, -half - 0.14, half), (0, -half - 0.14, half + 0.18), (0, -half - 0.28, half + 0.18)], 0.03, steel(kit))
    coils, tall, coat = int(rng.integers(4, 7)), rng.uniform(0.35, 0.6), bright(kit)
    spring = kit.chance(0.5)
    z = 2 * half
    for k in range(coils):
        high = tall / coils
        kit.add(
            CYL,
            (0, 0, z + high * (k + 0.5)),
            (0.16 if spring else 0.24, 0.16 if spring else 0.24, high * (0.3 if spring else 0.5)),
            (1 if spring else rng.choice([0.75, 0.85]), 1),
            material=steel(kit) if spring else coat,
        )
    if spring:
        kit.between((0, 0, z), (0, 0, z + tall), 0.12, material=black(kit))
    z += tall
    kit.add(BALL, (0, 0, z + 0.1), (0.22, 0.26, 0.18), material=coat)
    kit.chain([(0, 0.2, z + 0.12), (0.1, 0.5, z + rng.uniform(0, 0.4))], [0.08, 0.08], coat, mirror=True)
    kit.add(CYL, (0, 0, z + 0.24), (0.3, 0.3, 0.04), material=pale(kit))
    head = np.array([0, 0, z + 0.5])
    kit.add(BALL, head, (0.25, 0.25, 0.27), material=flesh(kit))
    face(kit, head, 0.27)
    kit.add(BALL, head + [0.27, 0, -0.02], (0.07, 0.07, 0.07), material=kit.material(base=[0.75, 0.03, 0.03], pattern=PLAIN, gloss=0.4))
    kit.add(BALL, head + [-0.05, 0.24, 0.05], (0.12, 0.12, 0.14), material=bright(kit), mirror=True)
    for side in (-1, 1):
        kit.chain([head + [0, side * 0.08, 0.18], head + [0, side * 0.25, 0.42], head + [0, side * 0.42, 0.3]], [0.14, 0.09, 0.03], bright(kit))
        kit.add(BALL, head + [0, side * 0.44, 0.28], (0.05, 0.05, 0.05), material=brass(kit))


def puppet(kit):
    """A jointed marionette with strings from a cross, or a wooden artist's or action figure."""
    rng = kit.rng
    strung = kit.chance(0.5)
    wood = timber(kit) if kit.chance(0.6) or not strung else flesh(kit)
    coat = bright(kit) if strung else wood
    z = 0.85
    trunk = [(0, 0.13), (0.08, 0.16), (0.2, 0.12), (0.25, 0.13), (0.45, 0.19), (0.52, 0.12)]
    kit.loft((0, 0, z - 0.05), trunk, coat, flat=1.35)
    head = np.array([0.02, 0, z + 0.72])
    kit.between((0, 0, z + 0.45), (0, 0, z + 0.58), 0.06, material=wood)
    kit.add(BALL, head, (0.15, 0.14, 0.19), material=wood)
    hands, knees = [], []
    for side in (-1, 1):
        shoulder = np.array([0, side * 0.28, z + 0.42])
        elbow = shoulder + [rng.uniform(-0.1, 0.2), side * rng.uniform(0.05, 0.25), -rng.uniform(0.1, 0.28)]
        hand = elbow + [rng.uniform(0, 0.25), side * rng.uniform(-0.05, 0.15), rng.uniform(-0.22, 0.25)]
        hip = np.array([0, side * 0.12, z - 0.05])
        bend = rng.uniform(0, 0.2)
        knee, foot = hip + [bend, side * 0.04, -0.36], np.array([bend * 0.6, side * 0.18, 0.07])
        kit.add(BALL, shoulder, (0.085, 0.085, 0.085), material=wood)
        kit.chain([shoulder, elbow, hand], [0.065, 0.055, 0.045], coat if strung else wood)
        kit.add(BALL, hand, (0.07, 0.05, 0.07), material=wood)
        kit.add(BALL, hip, (0.1, 0.1, 0.1), material=wood)
        kit.chain([hip, knee, foot], [0.09, 0.075, 0.055], wood if not strung else cloth(kit))
        kit.add(BOX, foot + [0.07, 0, -0.03], (0.14, 0.065, 0.045), (0.8, 0.8), material=wood if not strung else black(kit))
        hands.append(hand)
        knees.append(knee)
    if strung:
        top = z + rng.uniform(1.3, 1.7)
        thread, bar = pale(kit), timber(kit)
        kit.between((-0.35, 0, top), (0.4, 0, top), (0.025, 0.04), BOX, material=bar)
        kit.between((0.15, -0.45, top + 0.03), (0.15, 0.45, top + 0.03), (0.02, 0.035), BOX, material=bar)
        kit.between(head + [0, 0, 0.15], (0, 0, top), 0.008, material=thread)
        for side, hand, knee in zip((-1, 1), hands, knees, strict=True):
            kit.between(hand, (0.15, side * 0.42, top), 0.007, material=thread)
            kit.between(knee, (0.35, side * 0.02, top), 0.007, material=thread)
        face(kit, head, 0.15, 0.4)
        kit.between(head + [0.13, 0, -0.01], head + [0.13 + rng.uniform(0.05, 0.25), 0, 0], 0.03, taper=0.6, material=wood)
        if kit.chance(0.6):
            kit.add(CYL, head + [0, 0, 0.22], (0.16, 0.16, 0.12), (0.1, 1), material=bright(kit))
    else:
        kit.add(CYL, (0, 0, 0.01), (0.4, 0.4, 0.025), (0.95, 1), material=wood)
        kit.between((-0.3, 0, 0.02), (-0.3, 0, z - 0.15), 0.02, material=steel(kit))
        kit.between((-0.3, 0, z - 0.15), (0, 0, z - 0.02), 0.02, material=steel(kit))


def action_figure(kit):
    """Heroes with a cape, astronauts, commandos: broad shoulders, jointed limbs, on a disc."""
    rng = kit.rng
    suit, second, skin, dark = bright(kit), bright(kit), flesh(kit), black(kit)
    kind = rng.choice(["hero", "astronaut", "commando"])
    if kind == "astronaut":
        suit, second = pale(kit), bright(kit)
    elif kind == "commando":
        suit = kit.material(base=paint(rng.uniform(0.12, 0.3), 0.5, 0.2), pattern=CAMOUFLAGE, frequency=9)
        second = kit.material(base=paint(0.1, 0.5, 0.15), pattern=PLAIN)
    bulk, wide = (1.3 if kind == "astronaut" else 1.0), rng.uniform(0.17, 0.26)
    kit.add(CYL, (0, 0, 0.03), (0.4, 0.4, 0.03), material=dark)
    kit.chain([(0, 0.1, 0.85), (0.04, wide * 0.85, 0.5), (0, wide, 0.14)], np.array([0.13, 0.1, 0.09]) * bulk, suit, mirror=True)
    kit.between((0.01, wide * 0.95, 0.38), (0, wide, 0.1), 0.115 * bulk, taper=0.9, material=second, mirror=True)
    kit.add(BALL, (0.07, wide * 1.05, 0.11), (0.17, 0.09, 0.07), material=second, mirror=True)
    kit.add(BALL, (0, 0, 0.88), (0.15, 0.19, 0.15), material=second)
    kit.add(BOX, (0, 0, 1.2), (0.13, 0.19 * bulk, 0.25), (1.15, 1.4 / bulk), material=suit)
    kit.add(BALL, (0.09, 0.12, 1.32), (0.1, 0.14, 0.12), material=suit, mirror=True)
    kit.add(CYL, (0, 0, 0.98), (0.155, 0.2, 0.04), material=second if kind != "commando" else dark)
    for side in (-1, 1):
        shoulder = np.array([0, side * 0.33, 1.38])
        elbow = shoulder + [rng.uniform(-0.05, 0.12), side * rng.uniform(0.08, 0.2), -rng.uniform(0.15, 0.3)]
        hand = elbow + [rng.uniform(0.05, 0.25), -side * rng.uniform(-0.1, 0.1), rng.uniform(-0.2, 0.2)]
        kit.add(BALL, shoulder, np.array([0.125, 0.125, 0.125]) * bulk**0.5, material=suit)
        kit.chain([shoulder, elbow, hand], np.array([0.1, 0.085, 0.07]) * bulk**0.7, suit)
        kit.add(BALL, hand, (0.09, 0.075, 0.08), material=second)
        if kind == "commando" and side < 0:
            kit.add(BOX, hand + [0.12, 0, 0.05], (0.28, 0.03, 0.05), material=dark)
            kit.between(hand + [0.35, 0, 0.07], hand + [0.6, 0, 0.07], 0.016, material=dark)
            kit.add(BOX, hand + [0.15, 0, -0.05], (0.04, 0.02, 0.1), material=dark)
    kit.between((0, 0, 1.42), (0, 0, 1.56), 0.075, material=skin if kind != "astronaut" else suit)
    head = np.array([0.02, 0, 1.66])
    if kind == "astronaut":
        kit.add(BALL, head, (0.24, 0.24, 0.25), material=suit)
        kit.add(
            BALL,
            head + [0.08, 0, 0.01],
            (0.19, 0.18, 0.17),
            material=kit.material(base=[0.5, 0.3, 0.05] if kit.chance(0.5) else [0.05, 0.06, 0.1], pattern=PLAIN, gloss=0.64),
        )
        kit.add(BOX, (-0.24, 0, 1.25), (0.12, 0.24, 0.32), material=suit)
        kit.add(BOX, (0.17, 0, 1.2), (0.04, 0.12, 0.08), material=second)
    else:
        kit.add(BALL, head, (0.13, 0.115, 0.16), material=skin)
        face(kit, head, 0.13)
        if kind == "hero":
            kit.add(BALL, head + [-0.025, 0, 0.05], (0.13, 0.122, 0.135), material=second if kit.chance(0.5) else dark)
            if kit.chance(0.4):
                kit.add(BOX, head + [0, 0.09, 0.19], (0.03, 0.02, 0.06), (0.3, 0.3), material=second if kit.chance(0.5) else dark, mirror=True)
            if kit.chance(0.75):
                kit.add(BOX, (-0.28, 0, 0.88), (0.025, rng.uniform(0.42, 0.55), 0.56), (1, 0.55), (0.22, 0), material=second)
                kit.add(BALL, (-0.06, 0, 1.45), (0.14, 0.28, 0.06), material=second)
            kit.add(BALL, (0.17, 0, 1.3), (0.04, 0.1, 0.1), material=second)
        else:
            kit.add(BALL, head + [-0.01, 0, 0.06], (0.16, 0.15, 0.12), material=suit)
            kit.add(CYL, head + [0.02, 0, 0.04], (0.18, 0.16, 0.012), material=suit)
            kit.add(BOX, (-0.22, 0, 1.22), (0.1, 0.19, 0.22), material=second)
            for y in (-0.12, 0, 0.12):
                kit.add(BOX, (0.19, y, 1.1), (0.04, 0.05, 0.07), material=second)


def toy(kit):
    """Rocking horses, trains, cars, aeroplanes, blocks, tops, plush animals, dolls, robots, ducks, brick people, dolls' houses, games, soldiers, gnomes, banks."""
    vehicles = [rocking_horse, train, toy_car, toy_plane, blocks, spinning_top]
    figures = [teddy, teddy, doll, tin_robot, duck, brick_figure, uniformed, uniformed, nesting, gnome, puppet, action_figure]
    games = [dolls_house, chess, dice, piggy_bank, jack_in_box]
    kit.rng.choice(vehicles + figures + games)(kit)
