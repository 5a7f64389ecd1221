"""A maker of trees of many kinds, and what it shares with that of gardens: foliage, bark, pots."""


import numpy as np

from .kit import ALONG_X, around, towards, turn
from .layout import BALL, BOX, CYL, LEAVES
from .materials import BANDS, BRICKS, CLOUDY, DOTS, LEDGES, PLAIN, PLANKS, RIBS, SPECKLES, STREAKS, STRIPES, paint


def foliage(kit, hue=(0.17, 0.36), light=(0.06, 0.4)):
    """Materials of the leaves outside and, darker, inside, and how they are cut out."""
    rng = kit.rng
    green = paint(rng.uniform(*hue) % 1, rng.uniform(0.35, 0.9), rng.uniform(*light))
    outer = kit.material(base=green, pattern=CLOUDY, frequency=rng.uniform(6, 18), gloss=0.05, second=green * rng.uniform(0.3, 0.7))
    inner = kit.material(base=green * rng.uniform(0.35, 0.7), pattern=CLOUDY, frequency=rng.uniform(6, 18), gloss=0.02, second=green * 0.2)
    return outer, inner, (LEAVES, rng.uniform(4, 10), rng.uniform(0.46, 0.62))


def bark_material(kit):
    brown = kit.rng.uniform(0.4, 1.5) * (np.array([0.2, 0.14, 0.09]) if kit.chance(0.7) else np.array([0.19, 0.18, 0.16]))
    return kit.material(base=brown, pattern=kit.rng.choice([STREAKS, CLOUDY]), frequency=kit.rng.uniform(8, 20), gloss=0.02, second=brown * 0.45)


def leaf_material(kit, pattern=None):
    rng = kit.rng
    green = paint(rng.uniform(0.22, 0.38), rng.uniform(0.5, 0.9), rng.uniform(0.1, 0.45))
    pattern = rng.choice([PLAIN, CLOUDY, RIBS]) if pattern is None else pattern
    return kit.material(base=green, pattern=pattern, frequency=rng.uniform(6, 16), gloss=rng.uniform(0.05, 0.3), second=green * rng.uniform(0.5, 1.6))


def way(angle, lift=0.0):
    """The direction [3] of an azimuth and a height, both in radians."""
    return np.array([np.cos(angle) * np.cos(lift), np.sin(angle) * np.cos(lift), np.sin(lift)])


def balls(kit, middle, reach, count, size, leaves):
    """A crown: irregular balls in the outer part of the ellipsoid `reach` around a dark one."""
    rng = kit.rng
    outer, inner, cut = leaves
    reach = np.array(reach, float)
    kit.add(BALL, middle, reach * rng.uniform(0.6, 0.8), material=inner, cut=(LEAVES, cut[1] * 0.7, cut[2] + 0.06))
    for k in range(int(count)):
        away = way(2.4 * k + rng.normal(0, 0.3), np.arcsin(np.clip((2 * k + 1) / count - 1 + rng.normal(0, 0.1), -1, 1)))
        place = middle + reach * away * rng.uniform(0.65, 1)
        kit.add(BALL, place, size * rng.uniform(0.65, 1.35, 3), rotation=turn("z", rng.uniform(0, 90)), material=outer if kit.chance(0.75) else inner, cut=cut)


def pot(kit, radius, high):
    """A pot with earth in it, or a tub, from the ground to `high`."""
    rng = kit.rng
    look = kit.material(base=[0.5, 0.2, 0.1], pattern=PLAIN) if kit.chance(0.4) else kit.material(pattern=rng.choice([PLAIN, STREAKS, PLANKS, DOTS, RIBS, BANDS]))
    earth = kit.material(base=[0.06, 0.04, 0.03], pattern=SPECKLES)
    if kit.chance(0.25):
        kit.add(BOX, (0, 0, high / 2), (radius, radius, high / 2), (1.1, 1.1), material=look)
        kit.add(BOX, (0, 0, high), (radius * 1.02, radius * 1.02, 0.015), material=earth)
        return
    base = rng.uniform(0.6, 0.95)
    kit.loft((0, 0, 0), [(0, radius * base), (high * 0.55, radius * rng.uniform(0.85, 1.1)), (high, radius)], look)
    kit.add(CYL, (0, 0, high - 0.05 * radius), (radius * 1.08, radius * 1.08, 0.1 * radius), material=look)
    kit.add(CYL, (0, 0, high + 0.05 * radius), (radius * 0.95, radius * 0.95, 0.015), material=earth)


def bare(kit):
    rng = kit.rng
    bark, spread, droop = bark_material(kit), rng.uniform(25, 48), rng.uniform(-0.15, 0.3)
    trunk = rng.uniform(0.7, 1.6)
    fork = np.array([*rng.normal(0, 0.08, 2), trunk])
    thick = rng.uniform(0.08, 0.17)
    kit.between((0, 0, -0.02), (0, 0, 0.2), thick * 1.7, taper=0.65, material=bark)
    kit.between((0, 0, 0.1), fork, thick * 1.15, taper=0.75, material=bark)
    tips = [(fork, np.array([0, 0, 1.0]), rng.uniform(0.6, 1.0), thick * 0.85)]
    for level, forks in enumerate(((4, 3, 3), (3, 3, 4), (3, 4, 3))[rng.integers(3)]):
        grown = []
        for at, along, long, radius in tips:
            frame, first = towards(along), rng.uniform(0, 360)
            for k in range(forks):
                ahead = level > 0 and k == 0
                tilt = rng.normal(0, 10) if ahead else spread * rng.uniform(0.7, 1.4)
                heading = frame @ turn("z", first + 360 * k / forks + rng.normal(0, 15)) @ turn("y", tilt) @ np.array([0, 0, 1])
                heading = heading + np.array([0, 0, droop])
                heading /= np.linalg.norm(heading)
                end = at + heading * long * rng.uniform(0.7, 1.2)
                kit.between(at, end, radius * 0.75, taper=0.55, material=bark)
                grown.append((end, heading, long * 0.72, radius * 0.5))
        tips = grown


def conifer(kit):
    rng = kit.rng
    leaves, inner, cut = foliage(kit, (0.26, 0.42), (0.05, 0.25))
    tall, wide = rng.uniform(2.2, 3.6), rng.uniform(0.6, 1.1)
    foot, droop = rng.uniform(0.2, 0.7), rng.uniform(0.05, 0.5)
    kit.between((0, 0, 0), (0, 0, foot + tall * 0.9), rng.uniform(0.06, 0.11), taper=0.15, material=bark_material(kit))
    kit.loft((0, 0, foot), [(0.05 * tall, wide * 0.45), (tall * 0.98, 0.02)], inner)
    tiers = int(rng.integers(6, 9))
    for i in range(tiers):
        share = i / tiers
        boughs = [9, 9, 8, 7, 6, 5, 4, 4][i]
        for k in range(boughs):
            angle = 2 * np.pi * (k + 0.5 * (i % 2)) / boughs + rng.normal(0, 0.12)
            reach = wide * (1 - 0.9 * share) * rng.uniform(0.8, 1.1)
            start = np.array([0, 0, foot + tall * (share * 0.95 + 0.1)])
            kit.between(
                start,
                start + way(angle) * reach - [0, 0, reach * droop],
                (0.09 * tall / tiers + 0.06, 0.36 * reach + 0.03),
                BALL,
                material=leaves,
                cut=(LEAVES, cut[1] * 1.4, cut[2] + 0.04),
            )


def spruce(kit):
    rng = kit.rng
    outer, inner, cut = foliage(kit, (0.27, 0.5), (0.05, 0.3))
    tall, wide, foot = rng.uniform(2.2, 3.8), rng.uniform(0.5, 0.95), rng.uniform(0.1, 0.4)
    kit.between((0, 0, 0), (0, 0, foot + tall * 0.5), 0.09, taper=0.5, material=bark_material(kit))
    layers = int(rng.integers(7, 13))
    for i in range(layers):
        at = wide * (1 - 0.93 * i / layers)
        half = 1.1 * tall / layers
        middle = (rng.normal(0, 0.015), rng.normal(0, 0.015), foot + tall * (i + 0.5) / layers)
        kit.add(CYL, middle, (at * 0.8, at * 0.8, half), (0.2, 1), material=inner)
        kit.add(CYL, middle, (at, at, half), (0.15, 1), rotation=turn("z", 40 * i), material=outer, cut=(LEAVES, cut[1] * 2, cut[2]))
        for x, y in around(3, at * 0.85, 50 * i) if i < 8 else []:
            kit.add(BALL, (x, y, middle[2] - half * 0.85), np.array([0.3, 0.3, 0.12]) * at + 0.03, material=outer, cut=cut)


def umbrella_pine(kit):
    rng = kit.rng
    leaves, bark = foliage(kit, (0.24, 0.36), (0.06, 0.25)), bark_material(kit)
    tall, lean = rng.uniform(1.6, 2.8), rng.normal(0, 0.2, 2)
    fork = np.array([*lean, tall])
    kit.chain([(0, 0, 0), (lean[0] * 0.7, lean[1] * 0.2, tall * 0.5), fork], [0.13, 0.1, 0.09], bark)
    wide = rng.uniform(0.9, 1.5)
    for k in range(int(rng.integers(6, 9))):
        kit.between(fork - [0, 0, 0.1], fork + way(k * 1.05, 0.5) * wide * 0.7, 0.05, taper=0.4, material=bark)
    balls(kit, fork + [0, 0, 0.5], (wide, wide, 0.28), rng.integers(24, 40), np.array([0.42, 0.42, 0.2]), leaves)


def column_tree(kit):
    """Cypress and poplar."""
    rng = kit.rng
    cypress = kit.chance(0.5)
    outer, inner, cut = foliage(kit, (0.25, 0.38) if cypress else (0.18, 0.3), (0.04, 0.2) if cypress else (0.1, 0.4))
    foot, tall, wide = rng.uniform(0.1, 0.5), rng.uniform(2.4, 4), rng.uniform(0.28, 0.5)
    kit.between((0, 0, 0), (0, 0, foot + tall * 0.6), rng.uniform(0.06, 0.1), taper=0.5, material=bark_material(kit))
    kit.add(BALL, (0, 0, foot + tall * 0.5), (wide * 0.75, wide * 0.75, tall * 0.5), material=inner)
    if not cypress:
        for k in range(6):
            kit.between((0, 0, foot + 0.1 * k), way(k * 2.4) * wide * 0.7 + [0, 0, foot + tall * 0.25], 0.025, material=inner)
    for k in range(40):
        share = (k + 0.5) / 40
        girth = wide * np.sin(np.pi * share ** (0.65 if cypress else 0.8)) ** 0.7
        at = way(2.4 * k) * girth * rng.uniform(0.5, 0.8) + [0, 0, foot + tall * share]
        kit.add(BALL, at, np.array([0.5, 0.5, 1.1 if cypress else 0.9]) * wide * rng.uniform(0.6, 1.0), material=outer if kit.chance(0.8) else inner, cut=cut)


def willow(kit):
    rng = kit.rng
    leaves, bark = foliage(kit, (0.17, 0.28), (0.12, 0.45)), bark_material(kit)
    tall, wide = rng.uniform(1.4, 2.2), rng.uniform(0.9, 1.4)
    fork = np.array([*rng.normal(0, 0.08, 2), tall * 0.55])
    kit.between((0, 0, 0), fork, rng.uniform(0.12, 0.2), taper=0.75, material=bark)
    for k in range(5):
        kit.between(fork, way(1.26 * k, 0.3) * wide * 0.7 + [0, 0, tall], 0.06, taper=0.4, material=bark)
    balls(kit, np.array([0, 0, tall * 1.1]), (wide * 0.75, wide * 0.75, 0.4), 14, np.array([0.45, 0.45, 0.3]), leaves)
    outer, inner, cut = leaves
    for k in range(38):
        ring = wide * (1.0 if k % 3 else 0.65) * rng.uniform(0.85, 1.1)
        top, low = tall * rng.uniform(0.95, 1.2), tall * rng.uniform(0.08, 0.5)
        x, y, _ = way(2.4 * k) * ring
        kit.add(BALL, (x, y, (top + low) / 2), (*rng.uniform(0.1, 0.22, 2), (top - low) / 2), material=outer if k % 4 else inner, cut=cut)


def acacia(kit):
    rng = kit.rng
    outer, inner, cut = foliage(kit, (0.17, 0.27), (0.08, 0.3))
    bark, tall, wide = bark_material(kit), rng.uniform(1.3, 2.0), rng.uniform(1.2, 1.9)
    fork = np.array([*rng.normal(0, 0.1, 2), tall * rng.uniform(0.3, 0.55)])
    kit.between((0, 0, 0), fork, rng.uniform(0.08, 0.13), taper=0.8, material=bark)
    for k in range(6):
        out = way(k * 1.26 + rng.normal(0, 0.2)) * (k > 0)
        elbow = fork + out * wide * 0.25 + [0, 0, (tall - fork[2]) * 0.55]
        top = np.array([*(out * wide * rng.uniform(0.4, 0.75))[:2], tall + rng.normal(0, 0.06)])
        kit.chain([fork, elbow, top], [0.06, 0.045, 0.025], bark, joints=False)
        for _ in range(2):
            kit.add(BALL, top + rng.normal(0, 0.12, 3) * [1, 1, 0.3], (*rng.uniform(0.4, 0.6, 2) * wide * 0.7, rng.uniform(0.09, 0.15)), material=inner, cut=cut)
        for _ in range(4 if k else 6):
            kit.add(BALL, top + rng.normal(0, 0.25, 3) * [1, 1, 0.15] + [0, 0, 0.08], (*rng.uniform(0.25, 0.45, 2), rng.uniform(0.08, 0.14)), material=outer, cut=cut)


def baobab(kit):
    rng = kit.rng
    bark, leaves = bark_material(kit), foliage(kit)
    girth, tall = rng.uniform(0.32, 0.6), rng.uniform(1.4, 2.2)
    bulge = rng.uniform(0.9, 1.2)
    kit.loft((0, 0, 0), [(0, girth * 1.25), (0.15, girth), (tall * 0.45, girth * bulge), (tall * 0.8, girth * 0.85), (tall, girth * 0.5)], bark)
    for x, y in around(6, girth * 0.95, rng.uniform(0, 60)):
        kit.between((x * 1.3, y * 1.3, 0.0), (x * 0.8, y * 0.8, tall * 0.3), girth * 0.25, taper=0.4, material=bark)
    for k in range(int(rng.integers(6, 9))):
        root = way(k * 2.4) * girth * 0.4 + [0, 0, tall * 0.88]
        elbow = root + way(k * 2.4 + rng.normal(0, 0.2), rng.uniform(0.2, 0.8)) * rng.uniform(0.35, 0.6)
        kit.chain([root, elbow], [girth * 0.3, girth * 0.16], bark)
        for bend in (-0.5, 0.5):
            tip = elbow + way(k * 2.4 + bend, rng.uniform(0.3, 1.1)) * rng.uniform(0.25, 0.45)
            kit.between(elbow, tip, girth * 0.14, taper=0.4, material=bark)
            kit.add(BALL, tip, rng.uniform(0.15, 0.28, 3) * [1.2, 1.2, 0.7], material=leaves[0], cut=leaves[2])


def birch(kit):
    rng = kit.rng
    white = kit.material(base=np.array([0.8, 0.78, 0.72]) * rng.uniform(0.7, 1.1), pattern=SPECKLES, frequency=rng.uniform(6, 14), gloss=0.05, second=[0.08, 0.07, 0.06])
    dark, leaves = kit.material(base=[0.05, 0.045, 0.04], pattern=PLAIN, gloss=0), foliage(kit, (0.14, 0.28), (0.15, 0.5))
    for stem in range(int(rng.choice([1, 1, 2, 3]))):
        lean, tall, thick = rng.normal(0, 0.12 + 0.2 * (stem > 0), 2), rng.uniform(2.0, 2.9), rng.uniform(0.05, 0.09)
        foot, top = np.array([*rng.normal(0, 0.1, 2) * stem, 0]), np.array([*lean, tall])
        kit.between(foot, top, thick, taper=0.35, material=white)
        for _ in range(6 if stem == 0 else 3):
            at = rng.uniform(0.05, 0.6)
            point = foot + (top - foot) * at
            kit.add(CYL, point, (thick * (1.02 - 0.65 * at), thick * (1.02 - 0.65 * at), rng.uniform(0.008, 0.025)), material=dark)
        for k in range(4):
            at = foot + (top - foot) * rng.uniform(0.45, 0.8)
            kit.between(at, at + way(2.4 * k + stem, 0.8) * 0.6, 0.02, material=dark)
    balls(kit, np.array([0, 0, 2.0]), (rng.uniform(0.55, 0.85), rng.uniform(0.55, 0.85), rng.uniform(0.8, 1.05)), 30, np.array([0.22, 0.22, 0.3]), leaves)


def palm(kit):
    rng = kit.rng
    tall, lean = rng.uniform(1.6, 3.2), rng.normal(0, 0.35, 2)
    trunk = kit.material(base=np.array([0.3, 0.24, 0.17]) * rng.uniform(0.5, 1.6), pattern=BANDS, frequency=rng.uniform(14, 30), gloss=0.03, second=[0.12, 0.09, 0.06])
    leaf, top = leaf_material(kit, RIBS), np.array([*lean, tall])
    kit.chain([(0, 0, 0), (lean[0] * 0.15, lean[1] * 0.15, tall * 0.35), (lean[0] * 0.5, lean[1] * 0.5, tall * 0.7), top], [0.14, 0.1, 0.085, 0.08], trunk)
    kit.add(BALL, top + [0, 0, 0.02], (0.13, 0.13, 0.16), material=leaf)
    nuts = kit.material(base=paint(rng.choice([0.07, 0.12, 0.25]), 0.7, rng.uniform(0.12, 0.5)), pattern=PLAIN)
    for x, y in around(int(rng.integers(0, 6)), 0.13):
        kit.add(BALL, top + [x, y, -0.11], (0.09, 0.09, 0.1), material=nuts)
    fronds = int(rng.integers(9, 14))
    for k in range(fronds):
        angle, reach, rise = 2 * np.pi * k / fronds + rng.normal(0, 0.12), rng.uniform(0.8, 1.15), rng.uniform(0.0, 0.6) * (1 if k % 3 else 1.6)
        out = way(angle)
        bend, tip = top + out * reach * 0.55 + [0, 0, rise * 0.55], top + out * reach + [0, 0, rise * 0.5 - rng.uniform(0.3, 0.6)]
        aside = np.array([-out[1], out[0], -0.7])
        for start, end, wide, taper in ((top, bend, 0.09, 1.3), (bend, tip, 0.11, 0.25)):
            for hand in (1, -1):
                hang = aside * [hand, hand, 1] * wide * 0.9
                along = (end - start) / np.linalg.norm(end - start)
                side = hang / np.linalg.norm(hang)
                side = side - along * (side @ along)
                side /= np.linalg.norm(side)
                frame = np.stack([np.cross(side, along), side, along], 1)
                kit.add(BOX, (start + end) / 2 + hang * 0.8, (0.012, wide, np.linalg.norm(end - start) / 2), (1, taper), rotation=frame, material=leaf)


def orchard(kit):
    rng = kit.rng
    leaves, bark, trunk = foliage(kit, (0.2, 0.34), (0.1, 0.35)), bark_material(kit), rng.uniform(0.5, 0.9)
    wide = rng.uniform(0.65, 0.95)
    kit.between((0, 0, 0), (0, 0, trunk), rng.uniform(0.07, 0.11), taper=0.8, material=bark)
    for k in range(4):
        kit.between((0, 0, trunk * 0.9), way(1.57 * k, 0.8) * wide + [0, 0, trunk], 0.045, taper=0.5, material=bark)
    middle = np.array([0, 0, trunk + wide * 0.75])
    fruit = kit.material(base=paint(rng.choice([0.0, 0.07, 0.13, 0.2, 0.8]), rng.uniform(0.7, 1), rng.uniform(0.4, 0.9)), pattern=PLAIN, gloss=0.3)
    size = rng.uniform(0.05, 0.085)
    fruits = int(rng.integers(14, 24))
    for k in range(fruits):
        at = way(2.4 * k, np.arcsin(1.5 * (k + 0.5) / fruits - 0.8))
        kit.add(BALL, middle + at * np.array([wide, wide, wide * 0.85]) * 1.12, (size,) * 3, material=fruit)
    balls(kit, middle, (wide, wide, wide * 0.85), 30, np.array([0.3, 0.3, 0.26]) * wide / 0.8, leaves)


def bonsai(kit):
    rng = kit.rng
    outer, inner, cut = foliage(kit, (0.22, 0.38), (0.08, 0.35)) if kit.chance(0.85) else foliage(kit, (0.95, 1.05), (0.3, 0.7))
    tray, bark = kit.material(base=paint(rng.random(), rng.uniform(0.1, 0.6), rng.uniform(0.05, 0.4)), pattern=PLAIN, gloss=0.3), bark_material(kit)
    long, wide = rng.uniform(0.5, 0.75), rng.uniform(0.32, 0.45)
    shape = BOX if kit.chance(0.6) else CYL
    kit.add(shape, (0, 0, 0.13), (long * 0.92, wide * 0.92, 0.1), (1.1, 1.1), material=tray)
    kit.add(shape, (0, 0, 0.23), (long * 1.04, wide * 1.04, 0.025), material=tray)
    for x in (-0.7, 0.7):
        kit.add(BOX, (x * long, wide * 0.55, 0.02), (0.08, 0.07, 0.025), material=tray, mirror=True)
    kit.add(BALL, (0, 0, 0.24), (long * 0.9, wide * 0.9, 0.07), material=kit.material(base=[0.1, 0.14, 0.04], pattern=SPECKLES))
    points, at = [np.array([rng.normal(0, 0.1), 0, 0.22])], 0.22
    for k in range(4):
        at += rng.uniform(0.15, 0.26)
        points.append(np.array([(-1) ** k * rng.uniform(0.05, 0.22), rng.normal(0, 0.06), at]))
    kit.chain(points, [0.13, 0.1, 0.085, 0.065, 0.05], bark)
    for k, point in enumerate([*points[2:], *points[2:4]]):
        end = point + way(rng.uniform(-0.5, 0.5) + np.pi * k) * rng.uniform(0.2, 0.5) if k != 2 else point + [0, 0, 0.05]
        kit.between(point, end, 0.035, taper=0.6, material=bark)
        kit.add(BALL, end + [0, 0, 0.03], (0.28, 0.22, 0.09), material=inner, cut=cut)
        for _ in range(5):
            kit.add(BALL, end + rng.normal(0, 1, 3) * [0.15, 0.12, 0.015] + [0, 0, 0.07], rng.uniform(0.1, 0.19, 3) * [1, 1, 0.55], material=outer, cut=cut)


def christmas_tree(kit):
    rng = kit.rng
    outer, inner, cut = foliage(kit, (0.28, 0.42), (0.05, 0.25))
    tall, wide = rng.uniform(1.7, 2.4), rng.uniform(0.6, 0.85)
    if kit.chance(0.5):
        pot(kit, 0.22, 0.3)
    else:
        kit.between((-0.35, 0, 0.03), (0.35, 0, 0.03), (0.03, 0.06), BOX, material=bark_material(kit))
        kit.between((0, -0.35, 0.03), (0, 0.35, 0.03), (0.03, 0.06), BOX, material=bark_material(kit))
    kit.between((0, 0, 0), (0, 0, 0.7), 0.06, material=bark_material(kit))
    layers = int(rng.integers(5, 8))
    for i in range(layers):
        at = wide * (1 - 0.85 * i / layers)
        middle = (0, 0, 0.4 + tall * (i + 0.5) / layers)
        kit.add(CYL, middle, (at * 0.9, at * 0.9, tall / layers), (0.25, 1), material=inner)
        kit.add(CYL, middle, (at, at, tall / layers), (0.3, 1), material=outer, cut=(LEAVES, cut[1] * 2, cut[2]))
    gold = kit.material(base=[0.8, 0.6, 0.1], pattern=PLAIN, gloss=0.5)
    top = 0.4 + tall * (1 + 0.5 / layers)
    for angle in (0, 60, 120) if kit.chance(0.8) else ():
        kit.add(BOX, (0, 0, top + 0.05), (0.025, 0.03, 0.14), (0.3, 0.3), rotation=turn("x", angle), material=gold)
        kit.add(BOX, (0, 0, top + 0.05), (0.025, 0.03, 0.14), (0.3, 0.3), rotation=turn("x", angle + 180), material=gold)
    shine = [kit.material(base=paint(rng.random(), 0.9, 0.7), pattern=PLAIN, gloss=0.6), kit.material(base=[0.75, 0.05, 0.05], pattern=PLAIN, gloss=0.6), gold]
    for k in range(int(rng.integers(18, 28))):
        share = rng.uniform(0.02, 0.85)
        kit.add(BALL, way(2.4 * k) * wide * (1.0 - 0.9 * share) + [0, 0, 0.38 + tall * share], (0.055,) * 3, material=shine[k % 3])
    for k in range(int(rng.choice([0, 2, 4]))):
        half = rng.uniform(0.08, 0.18, 3)
        kit.add(BOX, way(1.7 * k + 0.6) * wide * 0.9 + [0, 0, half[2]], half, material=kit.material(pattern=rng.choice([PLAIN, STRIPES, DOTS])))


def stump(kit):
    rng = kit.rng
    bark, girth, tall = bark_material(kit), rng.uniform(0.3, 0.5), rng.uniform(0.35, 0.9)
    if kit.chance(0.35):
        tall *= 3
    heart = kit.material(base=np.array([0.55, 0.38, 0.2]) * rng.uniform(0.5, 1.3), pattern=CLOUDY, second=[0.25, 0.15, 0.08])
    kit.loft((0, 0, 0), [(0, girth * 1.25), (0.15, girth), (tall, girth * 0.88)], bark)
    for k in range(int(rng.integers(4, 8))):
        angle, reach = 1.1 * k + rng.normal(0, 0.2), girth * rng.uniform(1.5, 2.3)
        kit.between(way(angle) * reach + [0, 0, 0.02], way(angle) * girth * 0.6 + [0, 0, 0.25], 0.05, taper=2.6, material=bark)
    if tall < 1:
        for k in range(3):
            ring = girth * (0.84 - 0.28 * k)
            kit.add(CYL, (0, 0, tall + 0.006 * k), (ring, ring, 0.012), material=heart if k != 1 else bark)
    else:
        for k in range(7):
            x, y, _ = way(0.9 * k) * girth * rng.uniform(0.3, 0.7)
            kit.add(BOX, (x, y, tall + 0.1), (0.1, 0.1, rng.uniform(0.1, 0.45)), (0.05, 0.3), rotation=turn("z", 52 * k), material=heart if k % 3 == 0 else bark)
        for k in range(int(rng.integers(1, 5))):
            at = np.array([0, 0, tall * rng.uniform(0.45, 0.95)])
            kit.between(at, at + way(2.4 * k, rng.uniform(0.1, 0.8)) * rng.uniform(0.5, 1.1), girth * 0.25, taper=0.4, material=bark)
    moss = foliage(kit, (0.2, 0.3))
    for k in range(int(rng.integers(0, 5))):
        kit.add(BALL, way(2.4 * k) * girth + [0, 0, rng.uniform(0.02, 0.25)], rng.uniform(0.08, 0.2, 3), material=moss[0], cut=moss[2])
    for k in range(int(rng.choice([0, 0, 2, 4]))):
        kit.add(CYL, way(0.5 * k) * girth * 0.95 + [0, 0, tall * (0.3 + 0.15 * k)], (0.12, 0.12, 0.025), (0.7, 1), material=heart)


def fallen_log(kit):
    rng = kit.rng
    bark, moss = bark_material(kit), foliage(kit, (0.2, 0.3))
    heart = kit.material(base=np.array([0.55, 0.38, 0.2]) * rng.uniform(0.5, 1.3), pattern=CLOUDY, second=[0.25, 0.15, 0.08])
    logs = [(0, 0)] if kit.chance(0.55) else [(-1, 0), (1, 0), (0, 1)] if kit.chance(0.5) else [(-2, 0), (0, 0), (2, 0), (-1, 1), (1, 1), (0, 2)]
    thick, long = rng.uniform(0.16, 0.3), rng.uniform(0.9, 1.6)
    for column, row in logs:
        r = thick if len(logs) == 1 else thick * rng.uniform(0.85, 1.0)
        middle = np.array([rng.normal(0, 0.05) * (len(logs) > 1), column * thick, thick + row * thick * 1.7])
        taper = rng.uniform(0.75, 1)
        kit.add(CYL, middle, (r, r, long), (taper, 1), rotation=ALONG_X, material=bark)
        for end, size in ((-1, 1), (1, taper)):
            kit.add(CYL, middle + [end * long, 0, 0], (r * size * 0.9, r * size * 0.9, 0.012), rotation=ALONG_X, material=heart)
    if len(logs) > 1:
        for x in (-0.7, 0.7):
            kit.add(BOX, (x * long, (len(logs) > 3) * 2.9 * thick + (len(logs) == 3) * 1.9 * thick, thick), (0.05, 0.05, thick), material=bark, mirror=True)
        return
    for _ in range(int(rng.integers(2, 6))):
        x, angle = rng.uniform(-0.8, 0.8) * long, rng.uniform(-20, 200)
        out = turn("x", angle) @ np.array([rng.uniform(0.1, 0.5), 1.0, 0])
        kit.between(
            (x, 0, thick), np.array([x, 0, thick]) + out * thick * rng.uniform(1.4, 3.5) * max(0.45, np.sin(np.radians(angle))), thick * 0.3, taper=0.6, material=bark
        )
    for _ in range(int(rng.integers(2, 9))):
        kit.add(BALL, (rng.uniform(-0.9, 0.9) * long, rng.normal(0, 0.08), 1.8 * thick), rng.uniform(0.08, 0.22, 3) * [1.5, 1, 0.5], material=moss[0], cut=moss[2])
    for k in range(int(rng.integers(0, 4))):
        kit.add(CYL, (rng.uniform(-0.6, 0.6) * long, thick * 0.95, thick + 0.05 * k), (0.12, 0.12, 0.02), (0.7, 1), material=heart)


def topiary(kit):
    rng = kit.rng
    outer, inner, cut = foliage(kit, (0.22, 0.36), (0.06, 0.3))
    cut = (LEAVES, rng.uniform(9, 18), rng.uniform(0.52, 0.68))

    def clipped(kind, centre, half, taper=(1, 1), rotation=None):
        """A shape of leaves over a solid dark one."""
        fine = (LEAVES, cut[1] * (2 if kind == CYL else 1), cut[2])
        kit.add(kind, centre, np.array(half) * 0.94, taper, rotation=rotation, material=inner)
        kit.add(kind, centre, half, taper, rotation=rotation, material=outer, cut=fine)

    shape = rng.choice(["box", "arch", "tiers", "spiral", "cone", "animal"])
    if shape == "box":
        long, wide, tall = rng.uniform(0.8, 1.8), rng.uniform(0.2, 0.5), rng.uniform(0.3, 0.8)
        clipped(BOX, (0, 0, tall), (wide, long, tall), (rng.uniform(0.85, 1), 1))
        for y in np.linspace(-0.85, 0.85, int(rng.integers(2, 5))) * long if kit.chance(0.5) else ():
            clipped(BALL, (0, y, 2 * tall + 0.12), (wide * 0.8, wide * 0.8, wide * 0.8))
        if kit.chance(0.4):
            clipped(BOX, (1.0, long - wide, tall), (1.0, wide, tall))
    elif shape == "arch":
        apart, wide = rng.uniform(0.6, 0.8), rng.uniform(0.2, 0.35)
        for side in (-1, 1):
            clipped(BOX, (0, side * (apart + 0.2), 0.75), (wide, 0.28, 0.75))
        for angle in np.linspace(0, 180, 9):
            at = turn("x", angle) @ np.array([0, apart + 0.18, 0])
            clipped(BOX, (0, at[1], 1.45 + at[2] * 0.8), (wide, 0.22, 0.2), rotation=turn("x", angle))
    elif shape == "animal":
        tall = rng.uniform(0.45, 0.6)
        clipped(BALL, (0, 0, tall + 0.3), (0.7, 0.34, 0.34))
        for x, y in ((0.45, 0.18), (0.45, -0.18), (-0.45, 0.18), (-0.45, -0.18)):
            clipped(CYL, (x, y, tall * 0.45), (0.14, 0.14, tall * 0.5))
        long = rng.uniform(0.3, 0.8)
        kit.between((0.5, 0, tall + 0.4), (0.65 + 0.2 * long, 0, tall + 0.5 + long), 0.16, material=outer)
        clipped(BALL, (0.75 + 0.2 * long, 0, tall + 0.55 + long), (0.3, 0.16, 0.17))
        for y in (-0.1, 0.1):
            clipped(BALL, (0.62 + 0.2 * long, y, tall + 0.75 + long), (0.06, 0.05, 0.15))
        clipped(BALL, (-0.75, 0, tall + 0.45), (0.12, 0.12, 0.2))
    else:
        pot(kit, rng.uniform(0.3, 0.4), 0.4)
        bark = bark_material(kit)
        if shape == "tiers":
            z, size = 0.75, rng.uniform(0.35, 0.5)
            for _ in range(int(rng.integers(1, 4))):
                clipped(BALL, (0, 0, z + size * 0.5), (size, size, size))
                z, size = z + size * 1.9, size * 0.75
            kit.between((0, 0, 0.3), (0, 0, z - size * 1.5), 0.05, material=bark)
        elif shape == "cone":
            kit.between((0, 0, 0.3), (0, 0, 0.7), 0.05, material=bark)
            clipped(CYL, (0, 0, 1.35), (0.42, 0.42, 0.85), (0.12, 1))
        else:
            kit.add(CYL, (0, 0, 1.3), (0.16, 0.16, 0.85), (0.3, 1), material=inner)
            for k in range(26):
                share = k / 26
                at = way(0.62 * k) * 0.33 * (1 - 0.8 * share)
                kit.add(BALL, at + [0, 0, 0.55 + 1.65 * share], np.array([0.24, 0.24, 0.16]) * (1 - 0.6 * share), material=outer, cut=(LEAVES, cut[1], cut[2] + 0.05))


def potted_tree(kit):
    rng = kit.rng
    wide, high = rng.uniform(0.35, 0.7), rng.uniform(0.35, 0.6)
    look = kit.material(pattern=rng.choice([PLAIN, BRICKS, PLANKS, STREAKS, LEDGES]))
    kit.add(BOX, (0, 0, high / 2), (wide, wide, high / 2), (rng.uniform(0.9, 1.15),) * 2, material=look)
    kit.add(BOX, (0, 0, high), (wide * 1.1, wide * 1.1, 0.04), material=look if kit.chance(0.5) else kit.material())
    kit.add(BOX, (0, 0, high + 0.03), (wide * 0.95, wide * 0.95, 0.03), material=kit.material(base=[0.08, 0.05, 0.03]))
    trunk = high + rng.uniform(0.5, 1.1)
    bark, size = bark_material(kit), rng.uniform(0.5, 0.75)
    kit.between((0, 0, high), (0, 0, trunk + size * 0.5), 0.06, taper=0.8, material=bark)
    if kit.chance(0.4):
        for y in (-0.25, 0.25):
            kit.between((0, y, high), (0, y, trunk), 0.025, material=bark)
        kit.between((0, -0.25, trunk - 0.15), (0, 0.25, trunk - 0.15), 0.02, material=bark)
    balls(kit, np.array([0, 0, trunk + size * 0.75]), (size, size, size * rng.uniform(0.8, 1.3)), rng.integers(22, 36), np.full(3, size * 0.36), foliage(kit))


TREES = [bare, conifer, spruce, umbrella_pine, column_tree, willow, acacia, baobab, birch, palm, orchard, bonsai, christmas_tree, stump, fallen_log, topiary, potted_tree]


def tree(kit):
    """Bare trees, conifers, pines, cypresses, willows, acacias, baobabs, birches, palms, fruit, bonsai and Christmas trees, stumps, logs, topiary."""
    TREES[kit.rng.integers(len(TREES))](kit)
