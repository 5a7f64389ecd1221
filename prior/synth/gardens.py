"""Makers of potted plants, flowers, vegetables, corals, rocks, wells, hives, scarecrows."""

from itertools import pairwise

import numpy as np

from .greenery import balls, bark_material, foliage, leaf_material, pot, way
from .kit import ALONG_X, ALONG_Y, around, towards, turn
from .layout import BALL, BOX, CYL, GRID, LATTICE, PRISM, TUBE
from .materials import BANDS, BRICKS, CHECKER, CLOUDY, DOTS, PLAIN, PLANKS, RIBS, SHINGLES, SPECKLES, STREAKS, STRIPES, paint


def wood_material(kit):
    brown = np.array([0.4, 0.26, 0.14]) * kit.rng.uniform(0.35, 1.5)
    return kit.material(base=brown, pattern=kit.rng.choice([PLANKS, STREAKS, PLAIN]), frequency=kit.rng.uniform(6, 14), gloss=0.1, second=brown * 0.6)


def stone_material(kit):
    base = np.array([0.42, 0.4, 0.37]) * kit.rng.uniform(0.35, 1.5) + kit.rng.normal(0, 0.02, 3)
    return kit.material(
        base=base, pattern=kit.rng.choice([CLOUDY, SPECKLES, STREAKS]), frequency=kit.rng.uniform(3, 12), gloss=0.03, second=base * kit.rng.uniform(0.4, 0.8)
    )


def petal_material(kit):
    rng = kit.rng
    base = (
        np.full(3, 0.85)
        if kit.chance(0.2)
        else paint(rng.choice([0.0, 0.03, 0.1, 0.14, 0.62, 0.75, 0.88, 0.94]) + rng.normal(0, 0.015), rng.uniform(0.4, 1), rng.uniform(0.45, 0.95))
    )
    return kit.material(base=base, pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.08, second=base * 0.7)


def bloom(kit, at, facing, size, petals, material, centre, cup=0.3):
    """A flower that looks along the local z of `facing`, with `petals` petals."""
    for k in range(petals):
        angle = 360 * k / petals
        frame = facing @ turn("z", angle) @ turn("y", -np.degrees(cup))
        kit.add(BALL, at + frame @ np.array([0.55 * size, 0, 0]), np.array([0.55, min(0.5, 2.2 / petals), 0.07]) * size, rotation=frame, material=material)
    kit.add(BALL, at + facing @ np.array([0, 0, 0.05 * size]), np.array([0.25, 0.25, 0.16]) * size, rotation=facing, material=centre)


def leaf_fan(kit, root, angle, lift, reach, wide, material, bends=2):
    """An arching leaf of two or three flat parts."""
    points = [np.array(root, float)]
    for k in range(bends):
        points.append(points[-1] + way(angle, lift - k * 0.75) * reach / bends)
    for k, (start, end) in enumerate(pairwise(points)):
        last = k == bends - 1
        kit.between(start, end, (0.008, wide * (1 if k else 0.6)), BOX, 0.1 if last else 1.5, material=material)


def monstera(kit):
    rng = kit.rng
    high = rng.uniform(0.3, 0.5)
    pot(kit, rng.uniform(0.22, 0.3), high)
    leaf = leaf_material(kit)
    count = int(rng.integers(6, 9))
    for k in range(count):
        angle, lift = 2 * np.pi * k / count + rng.normal(0, 0.2), rng.uniform(0.5, 1.3)
        end = way(angle, lift) * rng.uniform(0.4, 0.85) + [0, 0, high]
        kit.between((0, 0, high), end, 0.014, material=leaf)
        frame = turn("z", np.degrees(angle)) @ turn("y", rng.uniform(5, 50)) @ turn("x", rng.normal(0, 12))
        size = rng.uniform(0.2, 0.32)
        for finger in (-115, -70, -25, 25, 70, 115):
            spread = frame @ turn("z", finger * 0.8)
            kit.add(BALL, end + spread @ np.array([0.5 * size, 0, 0]), (size * 0.62, size * 0.27, 0.012), rotation=spread, material=leaf)


def snake_plant(kit):
    rng = kit.rng
    high, wide = rng.uniform(0.25, 0.4), rng.uniform(0.18, 0.26)
    pot(kit, wide, high)
    green = paint(rng.uniform(0.25, 0.4), rng.uniform(0.3, 0.7), rng.uniform(0.08, 0.25))
    leaf = kit.material(base=green, pattern=rng.choice([BANDS, CLOUDY]), frequency=rng.uniform(10, 20), gloss=0.15, second=green * 2.2)
    rim = kit.material(base=[0.55, 0.55, 0.15], pattern=PLAIN) if kit.chance(0.6) else leaf
    for k in range(int(rng.integers(9, 16))):
        foot = way(2.4 * k) * wide * rng.uniform(0.1, 0.75) + [0, 0, high - 0.03]
        tip = foot * [2.2, 2.2, 1] + [0, 0, rng.uniform(0.45, 1.0)]
        girth = rng.uniform(0.045, 0.065)
        middle = foot + (tip - foot) * 0.6
        kit.between(foot, middle, (0.014, girth), BOX, 1.1, material=leaf)
        kit.between(middle, tip, (0.012, girth * 1.1), BOX, 0.08, material=leaf)
        if rim is not leaf and k < 9:
            kit.between(foot, middle, (0.006, girth * 1.15), BOX, 1.1, material=rim)


def ficus(kit):
    rng = kit.rng
    high = rng.uniform(0.25, 0.4)
    pot(kit, rng.uniform(0.2, 0.28), high)
    bark, leaf, top = bark_material(kit), leaf_material(kit), high + rng.uniform(0.6, 1.1)
    if kit.chance(0.4):  # leaves, each by itself, along a stem
        kit.between((0, 0, high - 0.05), (0, 0, top + 0.3), 0.025, material=bark)
        for k in range(30):
            z = high + 0.15 + (top - high + 0.15) * k / 30
            reach = rng.uniform(0.28, 0.42) * (1 - 0.3 * k / 30)
            kit.between((0, 0, z), way(2.4 * k, rng.uniform(-0.1, 0.7)) * reach + [0, 0, z], (0.012, reach * 0.3), BALL, material=leaf)
        return
    for phase in (0, 2.1, 4.2) if kit.chance(0.5) else (0,):
        points = [way(phase + 1.5 * k) * (0.035 if phase or k % 2 else 0.02) + [0, 0, high - 0.05 + (top - high) * k / 4] for k in range(5)]
        kit.chain(points, 0.03, bark, joints=False)
    leaves = foliage(kit, (0.22, 0.36), (0.1, 0.4))
    balls(kit, np.array([0, 0, top + 0.25]), (0.42, 0.42, 0.42), 30, np.full(3, 0.17), leaves)


def orchid(kit):
    rng = kit.rng
    pot(kit, 0.15, 0.25)
    leaf, flower, heart = leaf_material(kit, PLAIN), petal_material(kit), petal_material(kit)
    for k in range(int(rng.integers(4, 7))):
        leaf_fan(kit, (0, 0, 0.25), 2 * np.pi * k / 5 + rng.normal(0, 0.2), rng.uniform(0.3, 0.7), rng.uniform(0.3, 0.45), 0.06, leaf)
    for side in (1, -1)[: int(rng.integers(1, 3))]:
        points = [np.array([x, side * y, z]) for x, y, z in ((0, 0.02, 0.25), (0.02, 0.08, 0.65), (0.08, 0.15, 0.95), (0.3, 0.25, 1.05), (0.5, 0.33, 0.92))]
        kit.chain(points, 0.012, leaf, joints=False)
        for k in range(4 if side == 1 else 2):
            at = points[2] + (points[4] - points[2]) * k / 3 + [0, 0, 0.1 * (k in (1, 2))]
            bloom(kit, at + [0.03, 0, 0], turn("y", 80 + rng.normal(0, 12)) @ turn("z", 90 + rng.normal(0, 10)), 0.11, 5, flower, heart, 0.1)


def fern(kit):
    rng = kit.rng
    leaf, high = leaf_material(kit, RIBS), 0.0
    if kit.chance(0.6):
        high = rng.uniform(0.25, 0.45)
        pot(kit, rng.uniform(0.2, 0.28), high)
    count = int(rng.integers(14, 20))
    for k in range(count):
        lift = rng.uniform(0.9, 1.3) if k % 2 else rng.uniform(0.5, 0.9)
        leaf_fan(kit, way(2.4 * k) * 0.06 + [0, 0, max(high - 0.02, 0.02)], 2.4 * k, lift, rng.uniform(0.6, 0.95) * (0.8 + high), rng.uniform(0.05, 0.09), leaf, 3)


def vase(kit, high, wide):
    rng = kit.rng
    look = kit.material(pattern=rng.choice([PLAIN, PLAIN, BANDS, DOTS, CLOUDY]), gloss=0.4)
    belly = rng.uniform(0.3, 0.6)
    kit.loft((0, 0, 0), [(0, wide * 0.7), (high * belly, wide * rng.uniform(0.9, 1.3)), (high * 0.85, wide * rng.uniform(0.45, 0.8)), (high, wide * 0.75)], look)


def bouquet(kit):
    rng = kit.rng
    high = rng.uniform(0.35, 0.55)
    vase(kit, high, rng.uniform(0.12, 0.18))
    leaf, looks = leaf_material(kit), [petal_material(kit) for _ in range(int(rng.integers(1, 4)))]
    heart = kit.material(base=paint(0.13, 0.8, rng.uniform(0.1, 0.8)), pattern=SPECKLES)
    petals = int(rng.choice([0, 5, 6]))
    count = 14 if petals == 0 else 6
    for k in range(count):
        lift = np.pi / 2 - 0.75 * ((k + 0.4) / count) ** 0.5
        end = way(2.4 * k, lift) * rng.uniform(0.4, 0.55) + [0, 0, high]
        kit.between((0, 0, high - 0.08), end, 0.009, material=leaf)
        look = looks[k % len(looks)]
        if petals:
            bloom(kit, end, towards(way(2.4 * k, lift)), rng.uniform(0.12, 0.17), petals, look, heart, rng.uniform(0.1, 0.6))
        else:
            kit.add(BALL, end, np.array([1, 1, 0.85]) * rng.uniform(0.08, 0.13), material=look)
            kit.add(BALL, end + [0, 0, 0.03], np.full(3, 0.07), material=look._replace(first=look.first * 0.75))
    for k in range(10):
        kit.between((0, 0, high - 0.02), way(2.4 * k + 1, rng.uniform(0.3, 1.1)) * rng.uniform(0.25, 0.4) + [0, 0, high], (0.01, 0.06), BALL, material=leaf)


def sunflower(kit):
    rng = kit.rng
    leaf = leaf_material(kit, CLOUDY)
    yellow = kit.material(base=paint(rng.uniform(0.1, 0.15), 0.95, rng.uniform(0.7, 0.95)), pattern=PLAIN)
    brown = kit.material(base=[0.1, 0.05, 0.02], pattern=SPECKLES, frequency=20, second=[0.3, 0.18, 0.05])
    for stem in range(int(rng.integers(1, 3))):
        tall, foot = rng.uniform(1.2, 1.8) - 0.3 * stem, np.array([0, 0.4 * stem, 0])
        top, size = foot + [0.05, rng.normal(0, 0.05), tall], rng.uniform(0.2, 0.3)
        kit.chain([foot, foot + [rng.normal(0, 0.04), 0, tall * 0.6], top], [0.03, 0.025, 0.022], leaf)
        facing = turn("z", rng.normal(0, 20)) @ turn("y", rng.uniform(60, 85))
        for k in range(18):
            frame = facing @ turn("z", 20 * k) @ turn("y", -8 if k % 2 else 6)
            kit.add(BALL, top + frame @ np.array([size * 1.15, 0, 0.02]), (size * 0.5, size * 0.17, 0.012), rotation=frame, material=yellow)
        kit.add(CYL, top + facing @ np.array([0, 0, 0.01]), (size * 0.8, size * 0.8, 0.045), (0.85, 1), rotation=facing, material=brown)
        kit.add(CYL, top + facing @ np.array([0, 0, -0.03]), (size * 0.4, size * 0.4, 0.04), (2.0, 1), rotation=facing, material=leaf)
        for k in range(4):
            at = foot + (top - foot) * (0.25 + 0.15 * k)
            kit.between(at, at + way(2.4 * k + stem, 0.3) * rng.uniform(0.25, 0.4), (0.012, 0.1), BALL, material=leaf)


def tulips(kit):
    rng = kit.rng
    high = 0.0
    if kit.chance(0.5):
        high = 0.28
        pot(kit, 0.24, high)
    leaf, looks = leaf_material(kit, PLAIN), [petal_material(kit) for _ in range(int(rng.integers(1, 3)))]
    count = int(rng.integers(3, 7))
    for k in range(count):
        foot = way(2.4 * k) * 0.14 * (k > 0) + [0, 0, max(high - 0.02, 0)]
        top = foot * [1.9, 1.9, 1] + [0, 0, rng.uniform(0.5, 0.75)]
        kit.between(foot, top, 0.014, material=leaf)
        for petal in range(4):
            x, y, _ = way(np.pi / 2 * petal) * 0.04
            kit.add(BALL, top + [x, y, 0.08], (0.055, 0.055, 0.11), rotation=turn("z", 90 * petal) @ turn("y", 10), material=looks[k % len(looks)])
        for side in (1, -1):
            kit.between(foot, foot + way(2.4 * k + side, 1.2) * rng.uniform(0.35, 0.5), (0.01, 0.05), BALL, material=leaf)


def roses(kit):
    rng = kit.rng
    leaf, petal = leaf_material(kit, PLAIN), petal_material(kit)
    count = int(rng.choice([1, 3, 4]))
    size = 0.15 if count == 1 else 0.11
    for k in range(count):
        out = way(2.4 * k) * (0.25 if count > 1 else 0.02)
        top = out + [0, 0, rng.uniform(0.7, 1.0)]
        kit.chain([out * 0.1, out * 0.5 + [0, 0.02, 0.4], top], 0.014, leaf, joints=False)
        kit.add(CYL, top, (size * 0.3, size * 0.3, size * 0.35), (1.8, 1), material=leaf)
        middle = top + [0, 0, size * 0.8]
        kit.add(BALL, middle, np.array([0.55, 0.55, 0.65]) * size, material=petal._replace(first=petal.first * 0.7))
        for ring, (n, away, tilt) in enumerate(((3, 0.4, 12), (5, 0.6, 32))):
            for i in range(n):
                frame = turn("z", 360 * i / n + 25 * ring) @ turn("y", tilt)
                kit.add(BALL, middle + frame @ np.array([away * size, 0, -0.05 * size * ring]), np.array([0.14, 0.55, 0.65]) * size, rotation=frame, material=petal)
        for i in range(3):
            at = out * (0.3 + 0.2 * i) + [0, 0, 0.25 + 0.15 * i]
            kit.between(at, at + way(2.4 * i + k, 0.3) * 0.2, (0.01, 0.055), BALL, material=leaf)


def pumpkin(kit):
    rng = kit.rng
    for k in range(int(rng.choice([1, 1, 2, 3]))):
        size, flat, ribs = rng.uniform(0.4, 0.7), rng.uniform(0.6, 1.05), int(rng.integers(9, 14))
        base = paint(rng.choice([0.05, 0.07, 0.09, 0.25]), rng.uniform(0.7, 0.95), rng.uniform(0.35, 0.85))
        look = kit.material(base=base, pattern=rng.choice([PLAIN, CLOUDY, SPECKLES]), gloss=0.15, second=base * 0.7)
        at = way(2.2 * k) * (1.0 if k else 0)
        for x, y in around(ribs, size * 0.55):
            kit.add(BALL, at + [x, y, size * flat], (size * 0.5, size * 0.3, size * flat), rotation=turn("z", np.degrees(np.arctan2(y, x))), material=look)
        stem = kit.material(base=[0.2, 0.2, 0.07], pattern=STREAKS)
        top = at + [0, 0, size * flat * 1.7]
        kit.chain([top, top + [0, 0, size * 0.3], top + [size * 0.2, 0.05, size * 0.5]], [size * 0.16, size * 0.09, size * 0.08], stem)


def carrots(kit):
    rng = kit.rng
    orange = kit.material(base=paint(rng.uniform(0.04, 0.08), 0.9, rng.uniform(0.6, 0.95)), pattern=BANDS if kit.chance(0.3) else CLOUDY, frequency=20, gloss=0.1)
    leaves = foliage(kit, (0.24, 0.34), (0.15, 0.4))
    stalk = kit.material(base=leaves[0].first * 1.1, pattern=PLAIN)
    count = int(rng.choice([1, 1, 3, 4]))
    for k in range(count):
        girth, long = rng.uniform(0.1, 0.16), rng.uniform(0.8, 1.2)
        frame = turn("z", (k - (count - 1) / 2) * 13) @ ALONG_X
        base = np.array([0, (k - (count - 1) / 2) * 0.24, girth])
        kit.loft(
            base,
            [(0, girth * 0.55), (0.05, girth * 0.95), (long * 0.3, girth * 0.8), (long * 0.75, girth * 0.4), (long * 0.92, girth * 0.12), (long * 1.1, 0.006)],
            orange,
            axis=frame,
        )
        for _ in range(4):
            end = base + frame @ np.array([rng.normal(0, 0.08), rng.normal(0, 0.1), -rng.uniform(0.35, 0.6)])
            end[2] = max(end[2], 0.05)
            kit.between(base, end, 0.02, material=stalk)
            kit.between(base + (end - base) * 0.4, end + (end - base) * 0.3, (0.07, 0.1), BALL, material=leaves[0], cut=leaves[2])


def cabbage(kit):
    rng = kit.rng
    hue = 0.28 if kit.chance(0.75) else 0.83
    base = paint(hue + rng.normal(0, 0.02), rng.uniform(0.25, 0.6), rng.uniform(0.3, 0.7))
    heart = kit.material(base=base * 1.2, pattern=CLOUDY, frequency=6, second=base * 0.8)
    size = 0.5
    lettuce = kit.chance(0.4)
    if not lettuce:
        kit.add(BALL, (0, 0, size * 0.95), (size, size, size * 0.92), material=heart)
    for ring, (count, lift, away, z) in enumerate(((5, 12, 0.35, 1.0), (7, 30, 0.65, 0.75), (9, 42, 0.95, 0.55))):
        tone = kit.material(base=base * (1.1 - 0.25 * ring), pattern=RIBS if kit.chance(0.4) else CLOUDY, frequency=8, second=base * 1.4)
        for k in range(count):
            frame = turn("z", 360 * k / count + 23 * ring + rng.normal(0, 5)) @ turn("y", lift + rng.normal(0, 5))
            kit.add(
                BALL,
                frame @ np.array([0, 0, 0]) + turn("z", 360 * k / count + 23 * ring) @ np.array([size * away, 0, size * z]),
                np.array([0.09, 0.6, 0.62]) * size,
                rotation=frame,
                material=tone,
            )


def pineapple(kit):
    rng = kit.rng
    base = paint(rng.uniform(0.08, 0.14), 0.85, rng.uniform(0.4, 0.75))
    skin = kit.material(base=base, pattern=rng.choice([CHECKER, DOTS, SPECKLES]), frequency=rng.uniform(10, 18), second=base * [0.4, 0.35, 0.2])
    leaf, wide, tall = leaf_material(kit, PLAIN), rng.uniform(0.28, 0.36), rng.uniform(0.75, 1.0)
    kit.loft((0, 0, 0), [(0, wide * 0.65), (tall * 0.15, wide * 0.95), (tall * 0.55, wide), (tall * 0.9, wide * 0.72), (tall, wide * 0.4)], skin)
    for ring in range(3):
        z = tall * (0.2 + 0.27 * ring)
        for x, y in around(8, wide * (0.95 - 0.05 * (ring == 2)), 22 * ring):
            kit.add(BALL, (x, y, z), (0.07, 0.07, 0.08), material=skin)
    for k in range(22):
        lift = 0.45 + 1.0 * k / 22
        leaf_fan(kit, (0, 0, tall - 0.03 + 0.006 * k), 2.4 * k, lift, rng.uniform(0.35, 0.5), 0.05, leaf, 1)


def bananas(kit):
    rng = kit.rng
    yellow = kit.material(
        base=paint(rng.choice([0.13, 0.15, 0.2]), 0.85, rng.uniform(0.6, 0.9)), pattern=rng.choice([PLAIN, SPECKLES]), gloss=0.15, second=[0.25, 0.15, 0.03]
    )
    dark, count = kit.material(base=[0.08, 0.06, 0.03]), int(rng.integers(4, 7))
    crown = np.array([0, 0, 0.62])
    for k in range(count):
        out = turn("z", (k - (count - 1) / 2) * 17)
        points = [crown] + [out @ np.array(p) for p in ((0.12, 0, 0.55), (0.38, 0, 0.3), (0.72, 0, 0.15), (1.02, 0, 0.2), (1.1, 0, 0.25))]
        kit.chain(points[:5], [0.04, 0.075, 0.1, 0.09, 0.04], yellow)
        kit.between(points[4], points[5], 0.035, taper=0.7, material=dark)
    kit.add(BALL, crown, (0.07, 0.09, 0.08), material=dark)
    kit.between(crown, crown + [-0.1, 0, 0.15], 0.05, material=dark)


def grapes(kit):
    rng = kit.rng
    look = kit.material(base=paint(rng.choice([0.22, 0.78, 0.72, 0.95]), rng.uniform(0.4, 0.8), rng.uniform(0.1, 0.5)), pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.3)
    tilt, r = turn("y", rng.uniform(62, 74)), rng.uniform(0.1, 0.125)
    rings = [(0, 1), (0.13, 4), (0.28, 7), (0.45, 9), (0.62, 10), (0.78, 9), (0.92, 5)]
    for z, count in rings:
        for x, y in around(count, 0.031 * count * (count > 1), 37 * z * 10):
            kit.add(BALL, tilt @ np.array([x, y, -1.0 + z * 1.15]), (r, r, r * 1.1), material=look)
    stem = kit.material(base=[0.2, 0.16, 0.06])
    kit.between(tilt @ np.array([0, 0, -0.6]), tilt @ np.array([0, 0, 0.4]), 0.03, material=stem)
    kit.between(tilt @ np.array([0, -0.15, 0.38]), tilt @ np.array([0, 0.15, 0.4]), 0.03, material=stem)
    leaf = leaf_material(kit)
    for finger in (-70, -35, 0, 35, 70):
        frame = tilt @ turn("x", 50) @ turn("z", 90 + finger)
        kit.add(BALL, tilt @ np.array([0.05, 0.1, 0.2]) + frame @ np.array([0.2, 0, 0]), (0.24, 0.11, 0.012), rotation=frame, material=leaf)


def boulder(kit, at, size, look):
    """A rock: a ball, and two or three blocks that lie askew in it."""
    rng = kit.rng
    kit.add(BALL, (at[0], at[1], at[2] + size * 0.4), size * rng.uniform(0.7, 0.95, 3) * [1, 1, 0.8], rotation=turn("z", rng.uniform(0, 90)), material=look)
    for _ in range(int(rng.integers(2, 4))):
        half = size * rng.uniform(0.5, 0.9, 3) * [1, 1, 0.8]
        spin = turn("z", rng.uniform(0, 180)) @ turn("x", rng.uniform(-28, 28)) @ turn("y", rng.uniform(-28, 28))
        place = np.array([at[0], at[1], at[2] + size * 0.42]) + rng.normal(0, 0.12, 3) * size
        if kit.chance(0.4):
            kit.add(PRISM, place, half, (rng.uniform(0.5, 0.9), int(rng.integers(5, 8))), rotation=spin, material=look)
        else:
            kit.add(BOX, place, half, tuple(rng.uniform(0.5, 0.95, 2)), tuple(rng.normal(0, 0.15, 2) * size), rotation=spin, material=look)


def rocks(kit):
    rng = kit.rng
    look, grow = stone_material(kit), foliage(kit)
    boulder(kit, (0, 0, 0), rng.uniform(0.6, 0.9), look)
    for k in range(int(rng.integers(1, 9))):
        size = rng.uniform(0.15, 0.6)
        boulder(kit, way(2.4 * k) * rng.uniform(0.6, 1.2), size, look)
    if kit.chance(0.3):
        boulder(kit, (0.05, 0.05, 0.75), 0.45, look)
    for k in range(int(rng.choice([0, 0, 4, 8]))):
        kit.add(BALL, way(2.4 * k + 0.7) * rng.uniform(0.7, 1.2) + [0, 0, 0.1], rng.uniform(0.1, 0.25, 3), material=grow[0], cut=grow[2])


def rock_arch(kit):
    rng = kit.rng
    base = np.array([0.45, 0.25, 0.14]) * rng.uniform(0.6, 1.5) if kit.chance(0.6) else np.full(3, rng.uniform(0.15, 0.6))
    look = kit.material(base=base, pattern=rng.choice([BANDS, CLOUDY, STREAKS]), frequency=rng.uniform(3, 8), gloss=0.02, second=base * 0.65)
    span, rise, steps = rng.uniform(0.9, 1.4), rng.uniform(1.0, 1.6), 13
    for k in range(steps):
        angle = np.pi * k / (steps - 1)
        thick = 0.28 + 0.22 * abs(np.cos(angle)) ** 2
        at = np.array([rng.normal(0, 0.04), span * np.cos(angle), 0.55 + rise * np.sin(angle)])
        spin = turn("x", np.degrees(angle)) @ turn("y", rng.normal(0, 10)) @ turn("z", rng.uniform(0, 45))
        kit.add(BOX, at, np.array([thick, thick, 0.34]) * rng.uniform(0.85, 1.2, 3), tuple(rng.uniform(0.75, 1.1, 2)), rotation=spin, material=look)
        kit.add(BALL, at, np.array([thick, thick, thick]) * rng.uniform(0.9, 1.2, 3), rotation=spin, material=look)
    for side in (-1, 1):
        kit.add(PRISM, (0, side * span * 1.05, 0.32), (0.65, 0.6, 0.45), (0.7, 7), material=look)
        for k in range(3):
            boulder(kit, (rng.normal(0, 0.5), side * span + rng.normal(0, 0.3), 0), rng.uniform(0.2, 0.4), look)


def snow_mound(kit):
    rng = kit.rng
    snow = kit.material(base=[0.85, 0.88, 0.92], pattern=CLOUDY, frequency=rng.uniform(3, 8), gloss=0.1, second=[0.7, 0.75, 0.85])
    look, cairn = stone_material(kit), kit.chance(0.5)
    for k in range(int(rng.integers(4, 8))):
        at, size = way(2.4 * k) * (0.75 if k else 0) + [0, 0, 0], rng.uniform(0.35, 0.6) if k else 0.75
        if cairn:
            boulder(kit, at, size, look)
        kit.add(BALL, at + [0, 0, size * (0.85 if cairn else 0.2)], size * np.array([0.95, 0.95, 0.32 if cairn else 0.75]), material=snow)
        kit.add(
            BALL, at + rng.normal(0, 0.15, 3) * [1, 1, 0] + [0, 0, size * (0.9 if cairn else 0.3)], size * np.array([0.6, 0.6, 0.38 if cairn else 0.8]), material=snow
        )
    for k in range(6):
        kit.add(BALL, way(1.05 * k) * 0.95, (0.5, 0.5, rng.uniform(0.08, 0.2)), material=snow)


def termite_mound(kit):
    rng = kit.rng
    earth = np.array([0.4, 0.2, 0.1]) * rng.uniform(0.5, 1.4)
    look = kit.material(base=earth, pattern=rng.choice([STREAKS, CLOUDY]), frequency=rng.uniform(5, 14), gloss=0.01, second=earth * 0.6)
    for k in range(int(rng.integers(4, 10))):
        tall, wide = (rng.uniform(1.3, 2.2), 0.42) if k == 0 else (rng.uniform(0.4, 1.5), rng.uniform(0.15, 0.3))
        lean, foot = rng.normal(0, 0.06, 2), way(2.4 * k) * (rng.uniform(0.25, 0.5) if k else 0)
        frame = towards(np.array([*lean, 1.0]))
        kit.loft(foot, [(0, wide * 1.3), (tall * 0.3, wide), (tall * 0.7, wide * 0.65), (tall * 0.93, wide * 0.3)], look, axis=frame, flat=rng.uniform(0.7, 1))
        kit.add(BALL, foot + frame @ np.array([0, 0, tall * 0.92]), (wide * 0.31, wide * 0.3, tall * 0.08), rotation=frame, material=look)
    kit.add(BALL, (0, 0, 0), (0.95, 0.95, 0.2), material=look)


def beehive(kit):
    rng = kit.rng
    dark = kit.material(base=[0.03, 0.02, 0.01], pattern=PLAIN)
    if kit.chance(0.45):  # of straw
        straw = kit.material(base=np.array([0.6, 0.42, 0.16]) * rng.uniform(0.6, 1.3), pattern=RIBS, frequency=12)
        kit.add(BOX, (0, 0, 0.42), (0.6, 0.6, 0.05), material=wood_material(kit))
        for x, y in around(4, 0.62, 45):
            kit.add(BOX, (x, y, 0.2), (0.05, 0.05, 0.2), material=wood_material(kit))
        rows = int(rng.integers(7, 10))
        for k in range(rows):
            r = 0.52 * (1 - (k / rows) ** 2.2) ** 0.6 + 0.03
            kit.add(BALL, (0, 0, 0.53 + 0.115 * k), (r, r, 0.085), material=straw)
            kit.add(CYL, (0, 0, 0.53 + 0.115 * k), (r * 0.94, r * 0.94, 0.06), material=straw)
        kit.add(BALL, (0, 0, 0.53 + 0.115 * rows), (0.09, 0.09, 0.1), material=straw)
        kit.add(CYL, (0.48, 0, 0.53), (0.08, 0.09, 0.06), rotation=ALONG_X, material=dark)
        return
    for hive in range(int(rng.integers(1, 4))):
        y, z, look = (
            0.95 * hive,
            0.3,
            kit.material(base=np.full(3, 0.8) if kit.chance(0.4) else paint(rng.random(), rng.uniform(0.2, 0.7), rng.uniform(0.3, 0.8)), pattern=PLANKS),
        )
        for x in (-0.28, 0.28):
            for side in (-0.28, 0.28):
                kit.add(BOX, (x, y + side, 0.14), (0.05, 0.05, 0.15), material=look)
        kit.add(BOX, (0.06, y, z - 0.02), (0.44, 0.38, 0.035), material=look)
        for _ in range(int(rng.integers(2, 5))):
            half = rng.uniform(0.1, 0.17)
            kit.add(BOX, (0, y, z + half), (0.36, 0.34, half - 0.006), material=look)
            kit.add(BOX, (0, y, z + half * 1.3), (0.375, 0.1, 0.03), material=dark if kit.chance(0.5) else look)
            z += 2 * half
        kit.add(BOX, (0, y, z + 0.04), (0.41, 0.39, 0.05), material=kit.material(base=[0.5, 0.52, 0.55], pattern=PLAIN, gloss=0.4))
        kit.add(BOX, (0.36, y, 0.325), (0.01, 0.2, 0.018), material=dark)


def bird_house(kit):
    rng = kit.rng
    wood, roof, dark = (
        wood_material(kit) if kit.chance(0.5) else kit.material(pattern=PLANKS),
        kit.material(pattern=rng.choice([SHINGLES, PLAIN, PLANKS])),
        kit.material(base=[0.02] * 3, pattern=PLAIN),
    )
    post, half, high = rng.uniform(0.9, 1.8), rng.uniform(0.18, 0.28), rng.uniform(0.2, 0.35)
    kit.between((0, 0, 0), (0, 0, post), 0.05, BOX if kit.chance(0.5) else CYL, material=wood_material(kit))
    pitch = np.radians(rng.uniform(30, 50))
    rise = half * np.tan(pitch)
    if kit.chance(0.35):  # a feeder: an open table under a roof
        kit.add(BOX, (0, 0, post), (half * 1.5, half * 1.3, 0.03), material=wood)
        for x in (-1, 1):
            kit.add(BOX, (x * half * 1.1, half * 0.9, post + high), (0.025, 0.025, high), material=wood, mirror=True)
        for x in (-1.5, 1.5):
            kit.add(BOX, (x * half, 0, post + 0.05), (0.02, half * 1.3, 0.04), material=wood)
        kit.add(BALL, (0, 0, post + 0.03), (half * 0.7, half * 0.7, 0.06), material=kit.material(base=[0.4, 0.28, 0.1], pattern=SPECKLES))
    else:
        kit.add(BOX, (0, 0, post + high), (half, half, high), material=wood)
        kit.add(CYL, (half, 0, post + high * 1.25), (half * 0.3, half * 0.3, 0.012), rotation=ALONG_X, material=dark)
        kit.between((half, 0, post + high * 0.75), (half + 0.12, 0, post + high * 0.75), 0.015, material=wood)
        kit.add(BOX, (0.03, 0, post - 0.02), (half * 1.35, half * 1.2, 0.025), material=wood)
    top = post + 2 * high
    kit.add(BOX, (0, 0, top + rise * 0.5), (half * 0.98, half, rise * 0.5), (1, 0.02), material=wood)
    length = half * 1.35 / np.cos(pitch)
    kit.add(
        BOX,
        (0, half * 0.62, top + rise - half * 0.62 * np.tan(pitch) + 0.02),
        (half * 1.3, length / 2, 0.02),
        rotation=turn("x", -np.degrees(pitch)),
        material=roof,
        mirror=True,
    )
    for side in (1, -1):
        kit.between((0, side * 0.03, post * 0.75), (0, side * half, post), 0.02, BOX, material=wood)


def well(kit):
    rng = kit.rng
    radius, high, tall = rng.uniform(0.55, 0.8), rng.uniform(0.6, 0.9), rng.uniform(1.7, 2.3)
    base = np.array([0.45, 0.42, 0.38]) * rng.uniform(0.5, 1.4)
    stone = kit.material(base=base, pattern=BRICKS, frequency=rng.uniform(7, 13), second=base * 0.5, gloss=0.02)
    wood, roof, dark = wood_material(kit), kit.material(pattern=rng.choice([SHINGLES, PLANKS])), kit.material(base=[0.02, 0.03, 0.04], pattern=PLAIN)
    kit.add(CYL, (0, 0, high / 2), (radius, radius, high / 2), material=stone)
    for x, y in around(16, radius * 0.92):
        kit.add(BOX, (x, y, high + 0.05), (radius * 0.13, radius * 0.19, 0.07), rotation=turn("z", np.degrees(np.arctan2(y, x))), material=stone)
    kit.add(CYL, (0, 0, high + 0.01), (radius * 0.82, radius * 0.82, 0.015), material=dark)
    kit.add(BOX, (0, radius * 0.9, (tall + high * 0.5) / 2), (0.07, 0.07, (tall - high * 0.5) / 2), material=wood, mirror=True)
    kit.between((0, -radius * 1.15, tall * 0.78), (0, radius * 1.15, tall * 0.78), 0.07, material=wood)
    kit.between((0, radius * 1.15, tall * 0.78), (0.2, radius * 1.15, tall * 0.7), 0.02, material=wood)
    kit.between((0.2, radius * 1.12, tall * 0.7), (0.2, radius * 1.3, tall * 0.7), 0.025, material=wood)
    pitch = np.radians(rng.uniform(30, 48))
    half = radius * 1.05
    for side in (-1, 1):
        slope = turn("y", side * np.degrees(pitch))
        kit.add(BOX, (side * half * 0.5, 0, tall + half * 0.5 * np.tan(pitch)), (half * 0.58 / np.cos(pitch), radius * 1.35, 0.03), rotation=slope, material=roof)
    for y in (-0.9, 0.9):
        kit.add(BOX, (0, y * radius, tall + half * 0.45 * np.tan(pitch)), (half * 0.9, 0.04, half * 0.45 * np.tan(pitch)), (0.05, 1), material=wood)
    bucket = high + rng.uniform(0.15, 0.35)
    kit.between((0, 0, bucket), (0, 0, tall * 0.78), 0.015, material=kit.material(base=[0.5, 0.4, 0.25]))
    kit.add(CYL, (0, 0, bucket), (0.13, 0.13, 0.14), (1.25, 1), material=wood)
    kit.add(CYL, (0, 0, bucket + 0.05), (0.16, 0.16, 0.015), material=dark)


def bower(kit):
    """A bench under an arch with leaves."""
    rng = kit.rng
    wood = kit.material(base=np.full(3, 0.8), pattern=PLAIN) if kit.chance(0.4) else wood_material(kit)
    outer, inner, cut = foliage(kit)
    flower, wide, high = petal_material(kit), rng.uniform(0.7, 0.95), rng.uniform(1.4, 1.7)
    for x in (-0.35, 0.35):
        kit.add(BOX, (x, wide, high / 2), (0.04, 0.04, high / 2), material=wood, mirror=True)
        for k in range(6):
            at = [turn("x", 180 * (k + j) / 6) @ np.array([0, wide, 0]) * [1, 1, 0.75] + [x, 0, high] for j in (0, 1)]
            kit.between(*at, 0.04, BOX, material=wood)
    if kit.chance(0.7):
        kit.add(BOX, (0, wide, high / 2), (0.35, 0.015, high / 2), material=wood, mirror=True, cut=(LATTICE if kit.chance(0.5) else GRID, 6, 0.2))
    for x in (-0.15, 0.05, 0.25):
        kit.add(BOX, (x, 0, 0.45), (0.085, wide * 0.93, 0.025), material=wood)
    for z in (0.65, 0.82):
        kit.add(BOX, (-0.27, 0, z), (0.025, wide * 0.93, 0.07), material=wood)
    for y in (-0.7, 0.7):
        kit.add(BOX, (0, y * wide, 0.22), (0.25, 0.04, 0.22), material=wood)
        kit.add(BOX, (-0.27, y * wide, 0.62), (0.03, 0.04, 0.3), material=wood)
    for k in range(15):
        angle = 180 * k / 14
        at = turn("x", angle) @ np.array([0, wide, 0]) * [1, 1, 0.75] + [rng.normal(0, 0.15), 0, high + 0.03]
        kit.add(BALL, at, rng.uniform(0.14, 0.28, 3) * [1.6, 1, 0.8], material=outer if k % 3 else inner, cut=cut)
        if k % 3 == 0:
            kit.add(BALL, at * [1, 1.1, 1] + [0.2, 0, 0.1], (0.07,) * 3, material=flower)
    kit.add(BALL, (0, wide + 0.05, 0.7), (0.3, 0.12, 0.7), material=outer, cut=cut, mirror=True)


def sundial(kit):
    rng = kit.rng
    stone, brass = stone_material(kit), kit.material(base=rng.choice([0.3, 0.6]) * np.array([1, 0.75, 0.35]), pattern=CLOUDY, gloss=0.5, second=[0.1, 0.25, 0.2])
    tall, shaft = rng.uniform(0.8, 1.1), rng.uniform(0.13, 0.2)
    square = kit.chance(0.4)
    kit.add(BOX, (0, 0, 0.06), (0.36, 0.36, 0.06), material=stone)
    kit.add(BOX, (0, 0, 0.17), (0.27, 0.27, 0.06), (0.85, 0.85), material=stone)
    profile = [(0.2, shaft * 1.25), (0.3, shaft * 0.9), (tall * 0.5, shaft * 1.1), (tall * 0.85, shaft * 0.75), (tall * 0.93, shaft * 1.3), (tall, shaft * 1.6)]
    kit.loft((0, 0, 0), profile, stone, PRISM if square else CYL, sides=8)
    if kit.chance(0.3):  # rings around a rod
        middle = np.array([0, 0, tall + 0.42])
        for spin in (ALONG_Y, ALONG_X, turn("x", 42)):
            kit.add(TUBE, middle, (0.38, 0.38, 0.03), rotation=spin, material=brass)
        kit.between(middle - [0.3, 0, 0.3], middle + [0.3, 0, 0.3], 0.015, material=brass)
        kit.between((0, 0, tall), (0, 0, tall + 0.06), 0.05, material=brass)
        return
    kit.add(CYL, (0, 0, tall + 0.03), (0.36, 0.36, 0.035), material=stone)
    kit.add(CYL, (0, 0, tall + 0.07), (0.3, 0.3, 0.012), material=brass)
    kit.add(BOX, (0.02, 0, tall + 0.08 + 0.12), (0.2, 0.012, 0.12), (0.05, 1), (-0.36, 0), material=brass)
    for k in range(12):
        spin = turn("z", 30 * k)
        kit.add(BOX, spin @ np.array([0.25, 0, 0]) + [0, 0, tall + 0.085], (0.035, 0.008, 0.004), rotation=spin, material=kit.material(dark=True))


def scarecrow(kit):
    rng = kit.rng
    wood, straw = wood_material(kit), kit.material(base=[0.6, 0.45, 0.15], pattern=STREAKS)
    shirt, trousers = kit.material(pattern=rng.choice([CHECKER, STRIPES, PLAIN, CLOUDY]), frequency=rng.uniform(6, 14)), kit.material(pattern=rng.choice([PLAIN, CLOUDY]))
    sack, hat = kit.material(base=np.array([0.55, 0.42, 0.25]) * rng.uniform(0.7, 1.3), pattern=CLOUDY), kit.material(pattern=PLAIN)
    droop, dark = rng.uniform(-0.1, 0.25), kit.material(dark=True)
    kit.between((0, 0, 0), (0, 0, 1.7), 0.035, BOX, material=wood)
    kit.between((0, -0.85, 1.38), (0, 0.85, 1.38), 0.028, BOX, material=wood)
    kit.add(CYL, (0, 0, 1.15), (0.17, 0.25, 0.32), (0.85, 1), material=shirt)
    kit.between((0, 0.15, 1.38), (0, 0.7, 1.36), (0.09, 0.11), taper=1.15, material=shirt, mirror=True)
    kit.add(BOX, (0, 0.52, 1.3 - droop * 0.3), (0.03, 0.15, 0.1), (1, 0.9), material=shirt, mirror=True)
    for angle in (-25, 0, 25):
        spread = np.array([np.sin(np.radians(angle)) * 0.1, 0.2, -0.07 + 0.002 * angle])
        kit.between((0, 0.68, 1.37), np.array([0, 0.68, 1.37]) + spread, 0.02, material=straw, mirror=True)
    kit.between((0, 0.1, 0.88), (0.02, 0.15, 0.3), 0.12, taper=0.9, material=trousers, mirror=True)
    kit.between((0.02, 0.15, 0.32), (0.02, 0.16, 0.16), 0.06, taper=1.5, material=straw, mirror=True)
    kit.add(CYL, (0, 0, 0.88), (0.18, 0.24, 0.06), material=trousers)
    kit.add(CYL, (0, 0, 0.95), (0.19, 0.25, 0.02), material=wood)
    kit.add(BALL, (0, 0, 1.62), (0.14, 0.135, 0.17), material=sack)
    kit.add(CYL, (0, 0, 1.47), (0.12, 0.12, 0.03), material=straw)
    kit.add(CYL, (0, 0, 1.72), (0.28, 0.28, 0.012), material=hat)
    kit.add(CYL, (0, 0, 1.82), (0.15, 0.15, 0.1), (rng.uniform(0.3, 0.95), 1), material=hat)
    kit.add(BALL, (0.125, 0.05, 1.66), (0.02, 0.022, 0.022), material=dark, mirror=True)
    kit.add(BOX, (0.13, 0, 1.55), (0.012, 0.05, 0.008), material=dark)
    kit.between((0.13, 0, 1.61), (0.2, 0, 1.6), 0.025, taper=0.2, material=kit.material(base=[0.8, 0.3, 0.05]))
    for x, y, z in ((0.17, 0.08, 1.1), (0.15, -0.1, 0.55)):
        kit.add(BOX, (x, y, z), (0.015, 0.06, 0.06), material=kit.material())
    kit.add(BALL, (0, 0, 0), (0.3, 0.3, 0.08), material=kit.material(base=[0.15, 0.1, 0.06], pattern=SPECKLES))


def coral(kit):
    rng = kit.rng
    look = kit.material(
        base=paint(rng.choice([0.0, 0.05, 0.1, 0.85, 0.93, 0.55]), rng.uniform(0.3, 0.9), rng.uniform(0.4, 0.9)),
        pattern=rng.choice([PLAIN, SPECKLES, DOTS]),
        frequency=rng.uniform(10, 20),
    )
    for k in range(3):
        kit.add(BALL, way(2.1 * k) * 0.2, rng.uniform(0.25, 0.45, 3) * [1, 1, 0.5], material=stone_material(kit))
    kind = rng.choice(["branches", "tubes", "table", "fan"])
    if kind == "tubes":
        for k in range(int(rng.integers(7, 16))):
            foot, tall, r = way(2.4 * k) * 0.035 * k, rng.uniform(0.4, 1.0), rng.uniform(0.06, 0.11)
            end = foot + way(2.4 * k, 1.35) * tall
            kit.between(foot, end, r, taper=1.25, material=look)
            kit.between(end - (end - foot) * 0.01, end + (end - foot) * 0.012, r * 0.95, material=kit.material(dark=True))
    elif kind == "table":
        for k in range(int(rng.integers(2, 5))):
            at, wide = np.array([*rng.normal(0, 0.15, 2), 0.35 + 0.28 * k]), rng.uniform(0.5, 0.8) * (1 - 0.12 * k)
            kit.between((0, 0, 0), at, 0.12, taper=0.8, material=look)
            kit.add(CYL, at, (wide * 0.3, wide * 0.25, 0.06), (3.2, 1), material=look)
            for x, y in around(9, wide * 0.85):
                kit.add(BALL, at + [x, y * 0.85, 0.06], (0.14, 0.14, 0.05), material=look)
    else:
        flat = 0.15 if kind == "fan" else 1.0
        tips = [(np.array([0, 0, 0.1]), np.array([0, 0, 1.0]), 0.34, 0.085)]
        for forks in (4, 3, 3):
            grown = []
            for at, along, long, radius in tips:
                first = rng.uniform(0, 360)
                for k in range(forks):
                    heading = (
                        along + turn("z", first + 360 * k / forks) @ np.array([0.75, 0, 0.1]) * rng.uniform(0.7, 1.1)
                        if flat == 1
                        else along + np.array([0, (k - (forks - 1) / 2) * 0.8 + rng.normal(0, 0.1), 0])
                    )
                    heading = heading * [flat, 1, 1] / np.linalg.norm(heading * [flat, 1, 1])
                    end = at + heading * long * rng.uniform(0.8, 1.2)
                    kit.between(at, end, radius, taper=0.75, material=look)
                    grown.append((end, heading, long * 0.85, radius * 0.75))
            tips = grown


GARDEN = [
    *(monstera, snake_plant, ficus, orchid, fern, bouquet, sunflower, tulips, roses, pumpkin, carrots, cabbage, pineapple, bananas, grapes),
    *(coral, rocks, rock_arch, snow_mound, termite_mound, beehive, bird_house, well, bower, sundial, scarecrow),
]


def garden(kit):
    """Pot plants, ferns, flowers, vegetables, fruit, corals, rocks, rock arches, snow, termite mounds, beehives, bird houses, wells, bowers, sundials, scarecrows."""
    GARDEN[kit.rng.integers(len(GARDEN))](kit)
