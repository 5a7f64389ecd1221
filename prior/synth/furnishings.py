"""Makers of furniture: seats, tables, cupboards, beds, lamps, pianos, stoves, baths."""

import numpy as np

from .belongings import arc, black, brass, cloth, enamel, leather, lens, pale, ribbon, steel, timber
from .fittings import bent, box, disc, fronts, gable, glass, iron, mirror, near, pick, planks, posts, rod, shining, stone, ware
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, RUNGS, TUBE
from .materials import CHECKER, CLOUDY, PLAIN, RIBS, SHINGLES, SPECKLES, STREAKS, STRIPES, WAVES, WRITING
from .toys import bright


def furnishing(kit):
    """Chairs of all sorts, sofas, tables, desks, storage, beds, lamps, clocks, mirrors, screens, easels, pianos, harps, baths, stoves, fireplaces, basins, cradles,
    aquaria, cages, kennels, ladders, ironing boards, baskets."""
    pick(
        kit,
        [chair, chair, chair, windsor, cantilever, swivel, armchair, armchair, folding_chair, stool, deck_chair, bench, throne, wicker, table, table, dresser, billiard]
        + [chest, shelves, cabinet, bed, bunk, four_poster, cot, desk, coat_stand, lamp, chandelier, clock, mirror, screen, easel, upright, grand, harp, bath, stove]
        + [fireplace, basin, cradle, aquarium, cage, kennel, ladder, ironing, basket],
    )


def chair(kit):
    """With slats, on rockers, or high."""
    rng = kit.rng
    wood = timber(kit) if kit.chance(0.7) else enamel(kit)
    kind = rng.choice(["dining", "dining", "rocking", "high"])
    z, hx, hy, r = (0.85 if kind == "high" else rng.uniform(0.42, 0.48)), rng.uniform(0.18, 0.23), rng.uniform(0.18, 0.24), rng.uniform(0.016, 0.026)
    top, lean, foot = z + rng.uniform(0.4, 0.65), rng.uniform(0.03, 0.12), 0.06 if kind == "rocking" else 0
    square = BOX if kit.chance(0.5) else CYL
    posts(kit, hx - r, hy - r, foot, z, r, wood, 1.35 if kind == "high" else rng.uniform(1, 1.12), square)
    box(kit, (0, 0, z), (hx, hy, 0.02), wood)
    if kit.chance(0.5):
        box(kit, (0.01, 0, z + 0.03), (hx * 0.9, hy * 0.9, 0.025), cloth(kit) if kit.chance(0.6) else leather(kit), taper=(0.93, 0.93))
    rod(kit, (-hx + r, hy - r, z), (-hx + r - lean, hy - r, top), r, wood, True, square)
    back = rng.choice(["ladder", "slats", "panel", "cross"])

    def at(share):
        return np.array([-hx + r - lean * share, 0, z + (top - z) * share])

    rod(kit, at(0.95) - [0, hy, 0], at(0.95) + [0, hy, 0], (0.035, r * 0.8), wood, kind=BOX)
    if back == "ladder":
        for share in np.linspace(0.3, 0.75, int(rng.integers(1, 4))):
            rod(kit, at(share) - [0, hy - r, 0], at(share) + [0, hy - r, 0], (0.025, r * 0.5), wood, kind=BOX)
    elif back == "panel":
        rod(kit, at(0.3), at(0.92), (r * 0.8, hy - 2 * r), cloth(kit) if kit.chance(0.5) else wood, kind=BOX)
    elif back == "cross":
        rod(kit, at(0.15) - [0, hy - r, 0], at(0.9) + [0, hy - r, 0], r * 0.7, wood, True)
    else:
        rod(kit, at(0.2) - [0, hy - r, 0], at(0.2) + [0, hy - r, 0], (0.02, r * 0.6), wood, kind=BOX)
        for y in np.linspace(-0.6, 0.6, int(rng.integers(3, 7))):
            rod(kit, at(0.2) + [0, y * hy, 0], at(0.92) + [0, y * hy, 0], (r * 0.4, r * 0.7), wood, kind=BOX)
    if kit.chance(0.5) or kind == "high":
        rod(kit, (-hx + r, hy - r, z * 0.4), (hx - r, hy - r, z * 0.4), r * 0.7, wood, True)
        rod(kit, (hx - r, -hy * 1.1, z * 0.48), (hx - r, hy * 1.1, z * 0.48), r * 0.8, wood)
    if kind != "dining" or kit.chance(0.25):
        rod(kit, (hx - 0.03, hy - r, z), (hx - 0.03, hy - r, z + 0.22), r * 0.8, wood, True)
        box(kit, (-0.02, hy - r, z + 0.23), (hx + 0.03, 0.028, 0.014), wood, True)
    if kind == "high":
        box(kit, (hx + 0.05, 0, z + 0.25), (0.12, hy + 0.03, 0.015), enamel(kit) if kit.chance(0.5) else wood)
    if kind == "rocking":
        points = arc((0, hy - r, 1.05), 1.05, 245, 297, 8)
        ribbon(kit, [p + [0, 0, 0.02] for p in points], (0.024, 0.018), wood, True)


def windsor(kit):
    rng = kit.rng
    wood, z, high = timber(kit) if kit.chance(0.7) else enamel(kit), 0.45, rng.uniform(0.4, 0.6)
    kit.add(CYL, (0, 0, z), (0.22, 0.24, 0.025), (1.04, 1), material=wood)
    posts(kit, 0.13, 0.14, 0, z, 0.02, wood, rng.uniform(1.3, 1.6))
    rod(kit, (-0.16, 0.17, 0.2), (0.16, 0.17, 0.2), 0.012, wood, True)
    rod(kit, (0, -0.17, 0.2), (0, 0.17, 0.2), 0.012, wood)
    hoop = arc((-0.2, 0, z), (0.21, high), 0, 180, 11, "yz")
    hoop = [p - [0.25 * (p[2] - z), 0, 0] for p in hoop]
    bent(kit, hoop, 0.014, wood)
    for y in np.linspace(-0.75, 0.75, int(rng.choice([5, 7, 9]))):
        tall = high * np.sqrt(1 - y * y)
        rod(kit, (-0.19, y * 0.16, z), (-0.2 - 0.25 * tall, y * 0.21, z + tall), 0.008, wood)
    if kit.chance(0.5):
        ribbon(kit, arc((-0.02, 0, z + 0.22), (0.26, 0.27), 60, 300, 11, "xy"), (0.012, 0.025), wood)
        for x, y in ((0.1, 0.24), (0, 0.26), (-0.1, 0.24)):
            rod(kit, (x * 0.8, y * 0.8, z), (x, y, z + 0.22), 0.01, wood, True)


def cantilever(kit):
    rng = kit.rng
    metal, seat = steel(kit) if kit.chance(0.7) else iron(kit), leather(kit) if kit.chance(0.6) else cloth(kit)
    y, z, top = rng.uniform(0.21, 0.25), 0.45, rng.uniform(0.8, 0.95)
    bent(kit, [(-0.25, y, 0.02), (0.19, y, 0.02), (0.24, y, 0.06), (0.24, y, z - 0.05), (0.19, y, z), (-0.2, y, z), (-0.24, y, z + 0.05), (-0.32, y, top)], 0.015, metal, True)
    rod(kit, (-0.25, -y, 0.02), (-0.25, y, 0.02), 0.015, metal)
    box(kit, (0, 0, z + 0.01), (0.2, y, 0.02), seat)
    rod(kit, (-0.27, 0, z + 0.16), (-0.32, 0, top), (0.016, y), seat, kind=BOX)
    if kit.chance(0.5):
        bent(kit, [(-0.29, y, z + 0.2), (0.15, y, z + 0.2), (0.19, y, z + 0.16), (0.19, y, z)], 0.014, metal, True)


def swivel(kit):
    rng = kit.rng
    dark, cover, metal = black(kit), leather(kit) if kit.chance(0.4) else cloth(kit), steel(kit)
    base, high, z = dark if kit.chance(0.6) else metal, rng.uniform(0.45, 0.75), rng.uniform(0.44, 0.52)
    for x, y in around(5, 0.3, rng.uniform(0, 72)):
        rod(kit, (0, 0, 0.13), (x, y, 0.08), (0.018, 0.025), base, kind=BOX)
        disc(kit, (x, y, 0.03), 0.03, 0.025, dark, rotation=ALONG_Y)
    rod(kit, (0, 0, 0.07), (0, 0, z), 0.03, metal)
    rod(kit, (0, 0, 0.07), (0, 0, z * 0.6), 0.04, dark)
    box(kit, (0, 0, z), (0.24, 0.24, 0.045), cover, taper=(0.92, 0.92))
    rod(kit, (-0.2, 0, z - 0.02), (-0.3, 0, z + 0.3), (0.03, 0.04), dark, kind=BOX)
    rod(kit, (-0.25, 0, z + 0.1), (-0.32, 0, z + 0.12 + high), (0.035, 0.22), cover, kind=BOX)
    if kit.chance(0.7):
        rod(kit, (0, 0.27, z), (-0.05, 0.28, z + 0.21), (0.03, 0.015), dark, True, BOX)
        rod(kit, (0, 0.2, z - 0.02), (0, 0.28, z), 0.02, dark, True)
        box(kit, (-0.02, 0.28, z + 0.22), (0.14, 0.035, 0.018), dark, True)
    if high > 0.6 and kit.chance(0.5):
        box(kit, (-0.32, 0, z + 0.24 + high), (0.035, 0.13, 0.07), cover)
        rod(kit, (-0.32, 0, z + 0.1 + high), (-0.32, 0, z + 0.24 + high), 0.02, dark)


def armchair(kit):
    """Armchairs, some with wings, and sofas."""
    rng = kit.rng
    cover, seats, foot = cloth(kit) if kit.chance(0.6) else leather(kit), int(rng.choice([1, 1, 2, 3])), timber(kit)
    each, deep, z, arm = rng.uniform(0.27, 0.33), rng.uniform(0.36, 0.44), rng.uniform(0.08, 0.16), rng.uniform(0.07, 0.13)
    wide, top = each * seats, rng.uniform(0.75, 1.05)
    posts(kit, deep - 0.05, wide + arm - 0.05, 0, z, 0.025, foot)
    box(kit, (0, 0, z + 0.11), (deep, wide + arm, 0.11), cover)
    cushion = cloth(kit) if kit.chance(0.3) else cover
    for k in range(seats):
        y = (2 * k - seats + 1) * each
        box(kit, (0.08, y, z + 0.28), (deep - 0.09, each * 0.97, 0.07), cushion, taper=(0.96, 0.94))
        box(kit, (-deep + 0.2, y, (z + 0.3 + top) / 2), (0.07, each * 0.95, (top - z - 0.3) / 2), cushion, taper=(0.7, 0.93), shift=(-0.06, 0))
    box(kit, (-deep + 0.06, 0, (z + top) / 2), (0.08, wide + arm, (top - z) / 2), cover, shift=(-0.08, 0))
    rolled = kit.chance(0.5)
    box(kit, (0, wide + arm * 0.5, z + 0.27), (deep, arm * 0.6, 0.25 if not rolled else 0.2), cover, True)
    if rolled:
        disc(kit, (0, wide + arm * 0.6, z + 0.46), arm * 0.8, deep, cover, True, ALONG_X)
    if seats == 1 and top > 0.9:
        box(kit, (-deep * 0.5, wide + arm * 0.4, top - 0.22), (deep * 0.45, 0.045, 0.22), cover, True, (0.5, 1), shift=(-deep * 0.25, 0))
    for k in range(int(rng.integers(0, seats))):
        box(kit, (-deep + 0.38, (wide - 0.2) * (1 - 2 * k), z + 0.5), (0.06, 0.18, 0.17), bright(kit), rotation=turn("y", -20), taper=(0.7, 0.8))


def folding_chair(kit):
    rng = kit.rng
    frame, seat = (timber(kit), timber(kit)) if kit.chance(0.5) else (steel(kit), enamel(kit))
    y, top = rng.uniform(0.19, 0.23), rng.uniform(0.78, 0.9)
    slats = {"cut": (BARS, 14, 0.8)} if kit.chance(0.4) else {}
    rod(kit, (0.25, y, 0.0), (-0.2, y, top), (0.012, 0.014), frame, True, BOX)
    rod(kit, (-0.24, y - 0.03, 0.0), (0.17, y - 0.03, 0.45), (0.012, 0.014), frame, True, BOX)
    box(kit, (0.02, 0, 0.455), (0.19, y, 0.014), seat, **slats)
    rod(kit, (-0.15, 0, top - 0.16), (-0.2, 0, top), (0.012, y), seat, kind=BOX)
    rod(kit, (0.2, -y, 0.09), (0.2, y, 0.09), 0.012, frame)
    rod(kit, (-0.18, -y, 0.07), (-0.18, y, 0.07), 0.012, frame)


def stool(kit):
    """Low, bar and piano stools."""
    rng = kit.rng
    z, wood = rng.choice([0.42, 0.5, 0.75]), timber(kit) if kit.chance(0.6) else steel(kit)
    pad = leather(kit) if kit.chance(0.5) else wood
    r = rng.uniform(0.15, 0.2)
    kit.loft((0, 0, z - 0.03), [(0, r), (0.03, r), (0.06, r * 0.93)], pad)
    if kit.chance(0.35):
        rod(kit, (0, 0, 0.02), (0, 0, z), 0.03, wood)
        kit.loft((0, 0, 0), [(0, 0.22), (0.02, 0.21), (0.06, 0.04)], wood)
        rod(kit, (0, 0, z * 0.35), (0.16, 0, z * 0.35), 0.014, wood)
        kit.add(TUBE, (0, 0, z * 0.35), (0.16, 0.16, 0.012), material=wood)
    else:
        n = int(rng.choice([3, 4]))
        points = list(zip(around(n, r * 0.7, 45), around(n, r * rng.uniform(0.9, 1.3), 45), strict=True))
        for (x, y), (fx, fy) in points:
            rod(kit, (fx, fy, 0), (x, y, z), 0.018, wood)
        for k in range(n):
            a, b = points[k][1], points[k - 1][1]
            rod(kit, (*np.array(a) * 0.95, z * 0.3), (*np.array(b) * 0.95, z * 0.3), 0.012, wood)
    if z > 0.6 and kit.chance(0.4):
        ribbon(kit, arc((0, 0, z + 0.15), r, 110, 250, 6, "xy"), (0.05, 0.012), pad)
        for y in (-0.08, 0.08):
            rod(kit, (-r * 0.85, y, z), (-r * 0.9, y, z + 0.15), 0.012, wood)


def deck_chair(kit):
    wood, canvas, y = timber(kit), near(kit, (0.6, 0.1, 0.05), (0.1, 0.2, 0.5), (0.1, 0.4, 0.2), pattern=STRIPES, frequency=12, second=[0.8, 0.78, 0.7]), 0.27
    top = kit.rng.uniform(0.8, 1.0)
    rod(kit, (0.55, y, 0.02), (-0.55, y, top), (0.02, 0.015), wood, True, BOX)
    rod(kit, (-0.6, y - 0.035, 0.02), (0.5, y - 0.035, 0.42), (0.02, 0.015), wood, True, BOX)
    rod(kit, (-0.62, y + 0.03, 0.1), (-0.25, y + 0.03, top * 0.68), (0.015, 0.012), wood, True, BOX)
    for x, z in ((0.5, 0.42), (-0.54, top), (-0.58, 0.03), (0.53, 0.03)):
        rod(kit, (x, -y - 0.02, z), (x, y + 0.02, z), 0.018, wood)
    points = [np.array(p) for p in ((0.5, 0, 0.43), (0.25, 0, 0.27), (0.02, 0, 0.24), (-0.2, 0, 0.38), (-0.54, 0, top))]
    ribbon(kit, points, (0.008, y - 0.05), canvas)


def bench(kit):
    rng = kit.rng
    wood, metal, wide = planks(kit) if kit.chance(0.8) else enamel(kit), iron(kit), rng.uniform(0.6, 1.0)
    for x in np.linspace(-0.2, 0.2, 4):
        box(kit, (x, 0, 0.44), (0.055, wide, 0.018), wood)
    if kit.chance(0.75):
        for z in np.linspace(0.58, 0.85, int(rng.integers(2, 4))):
            box(kit, (-0.2 - (z - 0.44) * 0.25, 0, z), (0.015, wide, 0.05), wood)
        rod(kit, (-0.22, wide * 0.85, 0.42), (-0.34, wide * 0.85, 0.9), (0.025, 0.025), metal, True, BOX)
        if kit.chance(0.6):
            bent(kit, [(-0.26, wide * 0.85, 0.66), (0.2, wide * 0.85, 0.66), (0.24, wide * 0.85, 0.6), (0.2, wide * 0.85, 0.42)], 0.02, metal, True)
    if kit.chance(0.3):
        box(kit, (0, wide * 0.8, 0.21), (0.22, 0.08, 0.21), stone(kit), True)
    else:
        for x in (-0.22, 0.2):
            rod(kit, (x * 1.15, wide * 0.85, 0), (x, wide * 0.85, 0.43), 0.025, metal, True, BOX)
        rod(kit, (-0.22, wide * 0.85, 0.4), (0.2, wide * 0.85, 0.4), 0.025, metal, True, BOX)


def throne(kit):
    rng = kit.rng
    gold, red, top = brass(kit) if kit.chance(0.6) else timber(kit), near(kit, (0.4, 0.02, 0.03), (0.15, 0.03, 0.3), (0.03, 0.08, 0.3)), rng.uniform(1.3, 1.8)
    steps = int(rng.integers(0, 3))
    for k in range(steps):
        box(kit, (0.1, 0, 0.06 + 0.12 * k), (0.75 - 0.18 * k, 0.7 - 0.15 * k, 0.06), stone(kit))
    z = 0.12 * steps
    posts(kit, 0.27, 0.3, z, z + 0.45, 0.045, gold, kind=BOX)
    box(kit, (0, 0, z + 0.42), (0.32, 0.34, 0.07), gold)
    box(kit, (0.02, 0, z + 0.52), (0.27, 0.28, 0.05), red, taper=(0.9, 0.9))
    box(kit, (-0.29, 0, z + (0.4 + top) / 2), (0.05, 0.34, (top - 0.4) / 2), gold)
    box(kit, (-0.25, 0, z + (0.5 + top) / 2), (0.04, 0.26, (top - 0.7) / 2), red)
    box(kit, (-0.29, 0, z + top + 0.14), (0.05, 0.34, 0.15), gold, taper=(1, 0.05))
    for y in (-0.32, 0.32):
        kit.loft((-0.29, y, z + top - 0.02), [(0, 0.05), (0.1, 0.05), (0.25, 0.005)], gold)
    box(kit, (0.02, 0.31, z + 0.74), (0.3, 0.05, 0.035), gold, True)
    rod(kit, (0.26, 0.31, z + 0.45), (0.26, 0.31, z + 0.74), 0.035, gold, True)
    kit.add(BALL, (0.32, 0.31, z + 0.75), (0.06,) * 3, material=gold, mirror=True)
    kit.add(BALL, (-0.26, 0, z + top + 0.1), (0.05, 0.07, 0.07), material=bright(kit))


def wicker(kit):
    rng = kit.rng
    cane, pad = near(kit, (0.45, 0.28, 0.12), (0.2, 0.1, 0.05), (0.6, 0.55, 0.48), pattern=CHECKER, frequency=30), cloth(kit)
    top = rng.uniform(0.6, 0.95)
    kit.add(TUBE, (0, 0, 0.2), (0.3, 0.3, 0.2), (1.05, 1), material=cane)
    kit.add(CYL, (0, 0, 0.4), (0.31, 0.31, 0.02), material=cane)
    kit.add(CYL, (0, 0, 0.45), (0.28, 0.28, 0.05), (0.93, 1), material=pad)
    for a in np.arange(-100, 101, 25.0):
        high = 0.2 + (top - 0.3) * max(0.0, np.cos(np.radians(a * 0.85))) ** 0.8
        spin = turn("z", 180 + a)
        kit.add(BOX, spin @ [0.32, 0, 0.4 + high / 2], (0.025, 0.09, high / 2), (1, 1.15), (0.06, 0), spin, cane)
        rod(kit, spin @ [0.35, -0.09, 0.4 + high], spin @ [0.35, 0.09, 0.4 + high], 0.028, cane)


def table(kit):
    """On a pedestal, trestles or four legs, folding, low, with things on it or a cloth."""
    rng = kit.rng
    wood, kind = timber(kit) if kit.chance(0.7) else enamel(kit), rng.choice(["pedestal", "trestle", "legs", "folding", "coffee"])
    z, hx, hy = 0.42 if kind == "coffee" else 0.74, rng.uniform(0.3, 0.5), rng.uniform(0.5, 1.0)
    top = glass(kit) if kind == "coffee" and kit.chance(0.4) else wood
    if kind == "pedestal" or kit.chance(0.12):
        hx = hy = rng.uniform(0.35, 0.65)
        disc(kit, (0, 0, z), hx, 0.02, top)
    else:
        box(kit, (0, 0, z), (hx, hy, rng.uniform(0.014, 0.03)), top)
    if kind == "pedestal":
        kit.loft((0, 0, 0.08), [(0, 0.07), (0.1, 0.05), (0.2, 0.08), (0.3, 0.035), (z - 0.14, 0.05), (z - 0.09, 0.12)], wood)
        for x, y in around(int(rng.choice([3, 4])), hx * 0.7, 45):
            bent(kit, [(0, 0, 0.2), (x * 0.5, y * 0.5, 0.14), (x, y, 0.02)], 0.025, wood)
    elif kind == "trestle":
        rod(kit, (0, -hy * 0.7, z * 0.3), (0, hy * 0.7, z * 0.3), (0.04, 0.02), wood, kind=BOX)
        for x in (-1, 1):
            rod(kit, (x * hx * 0.8, hy * 0.7, 0), (x * hx * 0.1, hy * 0.7, z), 0.03, wood, True, BOX)
        rod(kit, (-hx * 0.55, hy * 0.7, z * 0.3), (hx * 0.55, hy * 0.7, z * 0.3), 0.025, wood, True, BOX)
        box(kit, (0, hy * 0.7, z - 0.04), (hx * 0.8, 0.04, 0.03), wood, True)
    elif kind == "folding":
        for x in (-1, 1):
            rod(kit, (x * hx * 0.85, hy * 0.8, 0), (-x * hx * 0.85, hy * 0.8, z), 0.018, wood, True, BOX)
        for x in (-1, 1):
            rod(kit, (x * hx * 0.8, -hy * 0.8, 0.04), (x * hx * 0.8, hy * 0.8, 0.04), 0.014, wood)
    else:
        posts(kit, min(hx, hx * 0.88), hy * 0.88 if hx != hy else hy * 0.6, 0, z, rng.uniform(0.02, 0.04), wood, rng.uniform(1, 1.1), BOX if kit.chance(0.6) else CYL)
        if hx != hy and kit.chance(0.7):
            box(kit, (0, 0, z - 0.06), (hx * 0.9, hy * 0.9, 0.05), wood)
        if kind == "coffee" and kit.chance(0.5):
            box(kit, (0, 0, z * 0.35), (hx * 0.88, hy * 0.88 if hx != hy else hx * 0.6, 0.012), wood)
    for _ in range(int(rng.integers(0, 4))):
        ware(kit, (rng.uniform(-0.5, 0.5) * hx, rng.uniform(-0.6, 0.6) * hy, z + 0.02), rng.uniform(0.08, 0.2))


def dresser(kit):
    """A dressing table with its mirror."""
    rng = kit.rng
    wood, hy = timber(kit) if kit.chance(0.6) else pale(kit), rng.uniform(0.4, 0.6)
    posts(kit, 0.2, hy - 0.03, 0, 0.5, 0.025, wood, kind=BOX)
    box(kit, (0, 0, 0.74), (0.25, hy + 0.02, 0.015), wood)
    box(kit, (0, hy - 0.15, 0.58), (0.23, 0.15, 0.15), wood, True)
    box(kit, (0, 0, 0.68), (0.23, hy - 0.05, 0.05), wood)
    for side in (-1, 1):
        for z in (0.5, 0.64):
            box(kit, (0.235, side * (hy - 0.15), z), (0.01, 0.13, 0.055), wood)
            kit.add(BALL, (0.25, side * (hy - 0.15), z), (0.015,) * 3, material=brass(kit))
    high = rng.uniform(0.3, 0.45)
    if kit.chance(0.5):
        kit.add(CYL, (-0.2, 0, 0.78 + high), (high, hy * 0.65, 0.02), rotation=ALONG_X, material=wood)
        kit.add(CYL, (-0.185, 0, 0.78 + high), (high * 0.9, hy * 0.58, 0.015), rotation=ALONG_X, material=glass(kit))
    else:
        box(kit, (-0.2, 0, 0.74 + high), (0.02, hy * 0.6, high), wood)
        box(kit, (-0.185, 0, 0.74 + high), (0.015, hy * 0.54, high * 0.9), glass(kit))
    rod(kit, (-0.2, hy * 0.7, 0.74), (-0.2, hy * 0.7, 0.8 + high), 0.02, wood, True)
    rod(kit, (-0.2, -hy * 0.7, 0.76 + high), (-0.2, hy * 0.7, 0.76 + high), 0.015, wood)
    ware(kit, (0.05, 0.2, 0.755), 0.1)


def billiard(kit):
    wood, felt = timber(kit), near(kit, (0.02, 0.25, 0.1), (0.03, 0.15, 0.35), (0.3, 0.03, 0.05), gloss=0)
    posts(kit, 0.5, 1.0, 0, 0.6, 0.07, wood, kind=CYL)
    box(kit, (0, 0, 0.66), (0.6, 1.15, 0.12), wood)
    box(kit, (0, 0, 0.79), (0.56, 1.1, 0.012), felt)
    box(kit, (0.61, 0, 0.79), (0.06, 1.22, 0.04), wood)
    box(kit, (-0.61, 0, 0.79), (0.06, 1.22, 0.04), wood)
    box(kit, (0, 1.16, 0.79), (0.6, 0.06, 0.04), wood, True)
    for x in (-0.57, 0.57):
        disc(kit, (x, 0, 0.82), 0.05, 0.012, black(kit))
        disc(kit, (x, 1.12, 0.82), 0.05, 0.012, black(kit), True)
    for _ in range(8):
        kit.add(BALL, (kit.rng.uniform(-0.4, 0.4), kit.rng.uniform(-0.9, 0.9), 0.83), (0.035,) * 3, material=bright(kit))


def chest(kit):
    """Chests of drawers, bedside chests and wardrobes."""
    rng = kit.rng
    wood, knob, hx, hy = timber(kit) if kit.chance(0.7) else enamel(kit), brass(kit) if kit.chance(0.6) else black(kit), rng.uniform(0.2, 0.28), rng.uniform(0.25, 0.6)
    tall = kit.chance(0.25)
    z, foot = rng.uniform(1.7, 2.1) if tall else rng.uniform(0.5, 1.2), rng.uniform(0.04, 0.15)
    posts(kit, hx - 0.04, hy - 0.04, 0, foot + 0.02, 0.03, wood, kind=BOX if kit.chance(0.5) else CYL)
    box(kit, (0, 0, (foot + z) / 2), (hx, hy, (z - foot) / 2), wood)
    box(kit, (0.01, 0, z + 0.015), (hx + 0.03, hy + 0.03, 0.02), wood)
    front = wood._replace(first=wood.first * 0.85) if kit.chance(0.6) else pale(kit)
    fronts(kit, hx, hy * 0.97, foot + 0.02, z - 0.02, 1 if tall else int(rng.integers(2, 6)), 2 if tall else int(rng.choice([1, 1, 2])), front, knob)
    for _ in range(int(rng.integers(0, 3))):
        ware(kit, (0, rng.uniform(-0.6, 0.6) * hy, z + 0.035), rng.uniform(0.1, 0.25))


def shelves(kit):
    rng = kit.rng
    wood, hx, hy, z, rows = timber(kit) if kit.chance(0.7) else enamel(kit), rng.uniform(0.14, 0.22), rng.uniform(0.35, 0.6), rng.uniform(1.2, 2.0), int(rng.integers(3, 6))
    box(kit, (0, hy, z / 2), (hx, 0.018, z / 2), wood, True)
    if kit.chance(0.7):
        box(kit, (-hx, 0, z / 2), (0.01, hy, z / 2), wood)
    for k in range(rows + 1):
        box(kit, (0, 0, 0.05 + (z - 0.07) * k / rows), (hx, hy, 0.015), wood)
    gap = (z - 0.07) / rows
    for k in range(rows):
        y = -hy + 0.03
        while y < hy - 0.12 and len(kit.primitives) < 62:
            wide, tall = rng.uniform(0.03, 0.12), gap * rng.uniform(0.45, 0.85)
            if kit.chance(0.75):
                box(kit, (-0.02, y + wide, 0.06 + gap * k + tall / 2), (hx * 0.75, wide, tall / 2), kit.material(pattern=rng.choice([STRIPES, PLAIN]), frequency=25))
            y += 2 * wide + rng.uniform(0, 0.15)


def cabinet(kit):
    rng = kit.rng
    wood, hx, hy, z = timber(kit), 0.22, rng.uniform(0.35, 0.6), rng.uniform(1.5, 2.0)
    box(kit, (0, 0, 0.4), (hx + 0.03, hy + 0.02, 0.4), wood)
    fronts(kit, hx + 0.03, hy, 0.06, 0.76, 1, 2, wood._replace(first=wood.first * 0.8), brass(kit))
    box(kit, (-hx, 0, (z + 0.8) / 2), (0.015, hy, (z - 0.8) / 2), wood)
    box(kit, (0, hy - 0.02, (z + 0.8) / 2), (hx, 0.02, (z - 0.8) / 2), wood, True)
    box(kit, (0, 0, z), (hx + 0.05, hy + 0.04, 0.04), wood)
    if kit.chance(0.5):
        box(kit, (0, 0, z + 0.1), (0.03, hy * 0.7, 0.07), wood, taper=(1, 0.1))
    for k in (1, 2):
        level = 0.8 + (z - 0.8) * k / 3
        box(kit, (-0.02, 0, level), (hx - 0.03, hy, 0.012), wood)
    for k in range(3):
        for y in np.linspace(-0.65, 0.65, 4) * hy:
            if kit.chance(0.7):
                disc(kit, (0, y, 0.9 + (z - 0.8) * k / 3), 0.05, 0.09, pale(kit) if kit.chance(0.5) else enamel(kit), taper=rng.uniform(0.5, 1.3))
    box(kit, (hx - 0.01, hy / 2, (z + 0.8) / 2), (0.012, hy / 2, (z - 0.8) / 2), wood, True, cut=(GRID, 3.5, 0.14))


def bed(kit):
    rng = kit.rng
    wood, cover, hy, head = timber(kit) if kit.chance(0.6) else iron(kit), cloth(kit), rng.choice([0.46, 0.7, 0.85]), rng.uniform(0.75, 1.2)
    posts(kit, 0.98, hy, 0, 0.35, 0.035, wood, kind=BOX)
    box(kit, (0, 0, 0.3), (1.0, hy, 0.07), wood)
    box(kit, (0.02, 0, 0.44), (0.97, hy - 0.03, 0.1), pale(kit), taper=(0.98, 0.98))
    box(kit, (0.25, 0, 0.5), (0.75, hy + 0.015, 0.08), cover, taper=(0.98, 0.96))
    pieces = {"cut": (BARS, 8, 0.3)} if kit.chance(0.35) else {}
    box(kit, (-1.0, 0, head / 2 + 0.1), (0.03, hy, head / 2 - 0.1), wood, **pieces)
    rod(kit, (-1.0, hy, 0), (-1.0, hy, head + 0.05), 0.04, wood, True)
    rod(kit, (-1.0, -hy, head), (-1.0, hy, head), 0.035, wood)
    if kit.chance(0.6):
        box(kit, (1.0, 0, head * 0.35 + 0.05), (0.03, hy, head * 0.35), wood, **pieces)
    for y in (0,) if hy < 0.5 else (-hy / 2, hy / 2):
        box(kit, (-0.75, y, 0.6), (0.17, 0.32 if hy > 0.5 else 0.33, 0.07), pale(kit), taper=(0.7, 0.8))


def bunk(kit):
    wood = timber(kit) if kit.chance(0.6) else enamel(kit)
    posts(kit, 1.0, 0.45, 0, 1.65, 0.035, wood, kind=BOX)
    for z in (0.35, 1.2):
        box(kit, (0, 0, z), (1.0, 0.45, 0.05), wood)
        box(kit, (0, 0, z + 0.12), (0.96, 0.42, 0.08), pale(kit))
        box(kit, (0.25, 0, z + 0.15), (0.7, 0.43, 0.08), cloth(kit))
        box(kit, (-0.75, 0, z + 0.24), (0.15, 0.3, 0.06), pale(kit), taper=(0.7, 0.8))
        for x in (-1, 1):
            box(kit, (x, 0, z + 0.3), (0.02, 0.45, 0.14), wood, cut=(BARS, 6, 0.4))
    box(kit, (-0.15, 0.46, 1.45), (0.85, 0.015, 0.05), wood)
    box(kit, (0, -0.46, 1.45), (1.0, 0.015, 0.05), wood)
    kit.between((0.8, 0.62, 0), (0.8, 0.48, 1.55), (0.18, 0.02), BOX, material=wood, cut=(RUNGS, 4.5, 0.25))
    for x in (0.63, 0.97):
        rod(kit, (x, 0.62, 0), (x, 0.48, 1.6), 0.022, wood, kind=BOX)


def four_poster(kit):
    wood, drape, hy, top = timber(kit), cloth(kit), 0.8, kit.rng.uniform(1.9, 2.2)
    posts(kit, 1.0, hy, 0, top, 0.05, wood, kind=CYL if kit.chance(0.6) else BOX)
    box(kit, (0, 0, 0.35), (1.0, hy, 0.1), wood)
    box(kit, (0, 0, 0.52), (0.96, hy - 0.04, 0.12), pale(kit))
    box(kit, (0.25, 0, 0.56), (0.73, hy, 0.12), cloth(kit), taper=(0.98, 0.95))
    box(kit, (-1.0, 0, 0.8), (0.03, hy, 0.4), wood)
    box(kit, (-0.72, 0.38, 0.7), (0.18, 0.3, 0.08), pale(kit), True, (0.7, 0.8))
    if kit.chance(0.6):
        box(kit, (0, 0, top), (1.06, hy + 0.06, 0.04), wood)
        box(kit, (0, hy + 0.04, top - 0.13), (1.05, 0.015, 0.12), drape, True)
        box(kit, (1.04, 0, top - 0.13), (0.015, hy + 0.05, 0.12), drape)
    else:
        rod(kit, (-1, hy, top - 0.03), (1, hy, top - 0.03), 0.03, wood, True)
        for x in (-1, 1):
            rod(kit, (x, -hy, top - 0.03), (x, hy, top - 0.03), 0.03, wood)
    for x in (-0.98, 0.98):
        kit.add(CYL, (x, hy - 0.03, (top + 0.1) / 2), (0.12, 0.07, top / 2 - 0.08), (0.8, 1), material=drape._replace(pattern=RIBS, frequency=20.0), mirror=True)


def cot(kit):
    wood = timber(kit) if kit.chance(0.5) else pale(kit)
    posts(kit, 0.62, 0.33, 0, 0.98, 0.025, wood, kind=BOX)
    box(kit, (0, 0, 0.35), (0.6, 0.32, 0.03), wood)
    box(kit, (0, 0, 0.44), (0.58, 0.3, 0.07), pale(kit))
    box(kit, (0.2, 0, 0.5), (0.35, 0.29, 0.04), cloth(kit))
    for y in np.linspace(-0.55, 0.55, 9):
        rod(kit, (y, 0.33, 0.35), (y, 0.33, 0.92), 0.01, wood, True)
    rod(kit, (-0.62, 0.33, 0.93), (0.62, 0.33, 0.93), 0.022, wood, True, BOX)
    rod(kit, (-0.62, 0.33, 0.36), (0.62, 0.33, 0.36), 0.022, wood, True, BOX)
    for x in (-0.62, 0.62):
        box(kit, (x, 0, 0.65), (0.015, 0.33, 0.32), wood)


def desk(kit):
    rng = kit.rng
    wood, hy, hx = timber(kit) if kit.chance(0.7) else pale(kit), rng.uniform(0.6, 0.85), rng.uniform(0.3, 0.4)
    box(kit, (0, 0, 0.74), (hx, hy, 0.02), wood)
    side = hy - 0.2
    for y in (-side, side) if kit.chance(0.5) else (side,):
        box(kit, (0, y, 0.37), (hx - 0.04, 0.18, 0.35), wood)
        for z in (0.14, 0.36, 0.58):
            box(kit, (-hx + 0.03, y, z), (0.012, 0.16, 0.1), wood)
            box(kit, (-hx + 0.015, y, z), (0.01, 0.05, 0.012), black(kit))
    rod(kit, (hx - 0.05, -hy + 0.04, 0), (hx - 0.05, -hy + 0.04, 0.73), 0.025, wood, kind=BOX)
    rod(kit, (-hx + 0.05, -hy + 0.04, 0), (-hx + 0.05, -hy + 0.04, 0.73), 0.025, wood, kind=BOX)
    box(kit, (hx - 0.06, 0, 0.5), (0.015, hy - 0.05, 0.22), wood)
    if kit.chance(0.7):
        box(kit, (0.1, 0, 1.03), (0.02, 0.3, 0.18), black(kit))
        box(kit, (0.085, 0, 1.03), (0.012, 0.28, 0.16), lens(kit))
        box(kit, (0.13, 0, 0.86), (0.03, 0.04, 0.12), black(kit))
        box(kit, (0.12, 0, 0.77), (0.1, 0.12, 0.012), black(kit))
        box(kit, (-0.15, 0, 0.77), (0.07, 0.22, 0.012), iron(kit))
    metal = enamel(kit)
    disc(kit, (0.12, hy - 0.2, 0.77), 0.08, 0.02, metal)
    bent(kit, [(0.12, hy - 0.2, 0.78), (0.18, hy - 0.2, 1.0), (0.02, hy - 0.25, 1.16)], 0.012, metal)
    kit.between((0.03, hy - 0.25, 1.18), (-0.07, hy - 0.28, 1.07), 0.035, CYL, 2, material=metal)
    for _ in range(int(rng.integers(0, 3))):
        ware(kit, (0.05, rng.uniform(-0.9, -0.5) * hy, 0.76), 0.15)


def coat_stand(kit):
    rng = kit.rng
    wood, high = timber(kit) if kit.chance(0.6) else iron(kit), rng.uniform(1.65, 1.9)
    rod(kit, (0, 0, 0.1), (0, 0, high), 0.025, wood)
    kit.add(BALL, (0, 0, high + 0.02), (0.045,) * 3, material=wood)
    n = int(rng.choice([3, 4, 5]))
    for x, y in around(n, 0.28):
        bent(kit, [(0, 0, 0.25), (x * 0.5, y * 0.5, 0.15), (x, y, 0.02)], 0.022, wood)
        bent(kit, [(0, 0, high - 0.25), (x * 0.45, y * 0.45, high - 0.22), (x * 0.7, y * 0.7, high - 0.06)], 0.014, wood)
        kit.add(BALL, (x * 0.7, y * 0.7, high - 0.06), (0.022,) * 3, material=wood)
    if kit.chance(0.6):
        cover = cloth(kit)
        kit.add(BOX, (0.17, 0, high - 0.65), (0.11, 0.22, 0.5), (0.7, 0.5), material=cover)
    if kit.chance(0.5):
        felt = black(kit)
        disc(kit, (0, 0, high + 0.03), 0.16, 0.012, felt)
        disc(kit, (0, 0, high + 0.1), 0.1, 0.07, felt, taper=0.85)


def lamp(kit):
    """Standing lamps with a shade, a bowl or an arm."""
    rng = kit.rng
    metal, high, shade = brass(kit) if kit.chance(0.4) else iron(kit), rng.uniform(1.3, 1.7), shining(kit) if kit.chance(0.5) else pale(kit)
    r = rng.uniform(0.16, 0.28)
    if kit.chance(0.3):
        for x, y in around(3, 0.3):
            rod(kit, (x, y, 0), (0, 0, high), 0.016, timber(kit))
    else:
        kit.loft((0, 0, 0), [(0, 0.16), (0.025, 0.15), (0.05, 0.02)], metal)
        rod(kit, (0, 0, 0), (0, 0, high), 0.014, metal)
    kind = rng.choice(["shade", "bowl", "arm"])
    if kind == "shade":
        kit.add(TUBE, (0, 0, high + 0.05), (r, r, 0.16), (rng.uniform(0.45, 1), 1), material=shade)
        kit.add(CYL, (0, 0, high + 0.02), (r * 0.7, r * 0.7, 0.14), (0.6, 1), material=shade)
    elif kind == "bowl":
        kit.loft((0, 0, high - 0.02), [(0, 0.04), (0.08, r * 0.8), (0.14, r)], metal)
    else:
        points = [np.array(p) for p in ((0, 0, high - 0.02), (0.15, 0, high + 0.25), (0.45, 0, high + 0.32), (0.75, 0, high + 0.2), (0.85, 0, high))]
        bent(kit, points, 0.014, metal)
        kit.loft((0.85, 0, high - 0.18), [(0, 0.2), (0.1, 0.17), (0.2, 0.05)], metal)
        kit.add(BALL, (0.85, 0, high - 0.16), (0.07,) * 3, material=shining(kit))


def chandelier(kit):
    rng = kit.rng
    gold, high, n = brass(kit) if kit.chance(0.7) else iron(kit), rng.uniform(0.5, 1.5), int(rng.choice([4, 5, 6]))
    kit.loft((0, 0, 0), [(0, 0.2), (0.04, 0.18), (0.1, 0.06), (0.2, 0.04), (high * 0.5, 0.03), (high * 0.55, 0.07), (high * 0.65, 0.03), (high, 0.05)], gold)
    for x, y in [*around(n, 0.3), (0, 0)]:
        if x or y:
            bent(kit, [(0, 0, high * 0.85), (x * 0.5, y * 0.5, high * 0.85 - 0.08), (x, y, high * 0.85 + 0.05)], 0.016, gold)
        z = high * 0.85 + 0.05 if x or y else high
        disc(kit, (x, y, z + 0.02), 0.045, 0.02, gold, taper=1.3)
        rod(kit, (x, y, z + 0.03), (x, y, z + 0.2), 0.018, pale(kit))
        kit.add(BALL, (x, y, z + 0.23), (0.014, 0.014, 0.035), material=shining(kit))


def clock(kit):
    wood, high = timber(kit), kit.rng.uniform(1.7, 2.1)
    box(kit, (0, 0, 0.2), (0.2, 0.27, 0.2), wood)
    box(kit, (0, 0, high * 0.45), (0.15, 0.19, high * 0.3), wood)
    box(kit, (0, 0, high - 0.27), (0.19, 0.26, 0.27), wood)
    box(kit, (0, 0, high + 0.05), (0.19, 0.28, 0.07), wood, taper=(1, 0.1) if kit.chance(0.5) else (0.8, 0.8))
    disc(kit, (0.19, 0, high - 0.27), 0.19, 0.015, brass(kit), rotation=ALONG_X)
    disc(kit, (0.2, 0, high - 0.27), 0.165, 0.015, pale(kit), rotation=ALONG_X)
    rod(kit, (0.222, 0, high - 0.27), (0.222, 0.08, high - 0.2), 0.009, black(kit))
    rod(kit, (0.222, 0, high - 0.27), (0.222, -0.02, high - 0.13), 0.007, black(kit))
    box(kit, (0.15, 0, high * 0.48), (0.01, 0.12, high * 0.2), lens(kit))
    rod(kit, (0.16, 0, high * 0.66), (0.16, 0, high * 0.38), 0.01, brass(kit))
    disc(kit, (0.165, 0, high * 0.36), 0.06, 0.01, brass(kit), rotation=ALONG_X)


def screen(kit):
    wood, n, high, panel = timber(kit), int(kit.rng.choice([3, 4])), kit.rng.uniform(0.75, 0.9), cloth(kit)
    for k in range(n):
        way, y = (1 if k % 2 else -1), (k - (n - 1) / 2) * 0.44
        spin = turn("z", way * 28)
        at = np.array([0, y, high])
        kit.add(BOX, at, (0.012, 0.22, high * 0.92), rotation=spin, material=panel, cut=(GRID, 5, 0.2) if panel.pattern == PLAIN else (0, 1.0, 1.0))
        for side in (-0.235, 0.235):
            kit.add(BOX, at + spin @ [0, side, 0], (0.016, 0.018, high), rotation=spin, material=wood)
        for z in (0.1 - high, 0.0, high - 0.03):
            kit.add(BOX, at + spin @ [0, 0, z], (0.016, 0.24, 0.025), rotation=spin, material=wood)


def easel(kit):
    wood, wide, high = timber(kit), kit.rng.uniform(0.25, 0.5), kit.rng.uniform(0.25, 0.42)
    rod(kit, (0.25, 0.35, 0), (0, 0.05, 1.7), 0.02, wood, True, BOX)
    rod(kit, (-0.5, 0, 0), (0, 0, 1.6), 0.02, wood, kind=BOX)
    rod(kit, (0.15, -0.28, 0.65), (0.15, 0.28, 0.65), (0.025, 0.05), wood, kind=BOX)
    rod(kit, (0.02, -0.1, 1.55), (0.02, 0.1, 1.55), 0.025, wood, kind=BOX)
    tip = turn("y", -8)
    kit.add(BOX, (0.14, 0, 0.68 + high), (0.02, wide, high), rotation=tip, material=pale(kit))
    kit.add(BOX, (0.157, 0, 0.68 + high), (0.008, wide * 0.9, high * 0.9), rotation=tip, material=kit.material(pattern=kit.rng.choice([CLOUDY, WAVES, STREAKS]), frequency=5))
    for y in (-0.4, 0.2) if kit.chance(0.5) else ():
        kit.add(BALL, (0.165, y * wide, 0.68 + high), (0.012, wide * 0.3, high * 0.4), material=bright(kit))


def keys(kit, x, z, half):
    box(kit, (x, 0, z), (0.07, half, 0.015), pale(kit))
    box(kit, (x - 0.025, 0, z + 0.017), (0.04, half, 0.012), black(kit), cut=(BARS, 14, 0.5))


def upright(kit):
    wood, high = (timber(kit) if kit.chance(0.6) else black(kit)._replace(gloss=0.5)), kit.rng.uniform(1.1, 1.35)
    box(kit, (-0.15, 0, high / 2), (0.17, 0.74, high / 2), wood)
    box(kit, (-0.14, 0, high), (0.2, 0.77, 0.02), wood)
    box(kit, (0.15, 0, 0.65), (0.2, 0.74, 0.06), wood)
    keys(kit, 0.27, 0.72, 0.62)
    box(kit, (0.2, 0.68, 0.74), (0.14, 0.06, 0.05), wood, True)
    box(kit, (0.28, 0.69, 0.3), (0.03, 0.04, 0.3), wood, True)
    box(kit, (0.14, 0.71, 0.05), (0.2, 0.04, 0.05), wood, True)
    box(kit, (0.06, 0, 0.98), (0.02, 0.35, 0.12), pale(kit), rotation=turn("y", -15))
    for y in (-0.06, 0.06):
        box(kit, (0.06, y, 0.08), (0.08, 0.02, 0.012), brass(kit))
    if kit.chance(0.5):
        posts(kit, 0.12, 0.3, 0, 0.45, 0.025, wood, kind=BOX, x=0.7)
        box(kit, (0.7, 0, 0.46), (0.16, 0.35, 0.04), leather(kit))


def grand(kit):
    wood = black(kit)._replace(gloss=0.5) if kit.chance(0.7) else timber(kit)
    for x, y, hx, hy in ((0.25, 0, 0.3, 0.74), (-0.3, 0.12, 0.3, 0.62), (-0.75, 0.27, 0.25, 0.47)):
        box(kit, (x, y, 0.8), (hx, hy, 0.15), wood)
    disc(kit, (-0.95, 0.32, 0.8), 0.42, 0.15, wood)
    disc(kit, (-0.55, -0.05, 0.8), 0.4, 0.15, wood)
    box(kit, (0.62, 0, 0.72), (0.16, 0.74, 0.06), wood)
    keys(kit, 0.68, 0.79, 0.62)
    box(kit, (0.64, 0.68, 0.8), (0.14, 0.06, 0.06), wood, True)
    if kit.chance(0.7):
        tip = turn("x", -40)
        for x, hx, deep in ((0.1, 0.35, 1.4), (-0.45, 0.3, 1.2), (-0.95, 0.3, 0.85)):
            kit.add(BOX, np.array([x, 0.74, 0.96]) + tip @ [0, -deep / 2, 0], (hx, deep / 2, 0.015), rotation=tip, material=wood)
        rod(kit, (0.3, -0.6, 0.9), (0.3, -0.25, 1.78), 0.012, wood)
        box(kit, (-0.2, 0.15, 0.95), (0.55, 0.5, 0.005), brass(kit)._replace(pattern=STRIPES, frequency=25.0))
    box(kit, (0.35, 0, 1.06), (0.015, 0.35, 0.13), wood, rotation=turn("y", -20))
    for x, y in ((0.55, 0.6), (0.55, -0.6), (-0.95, 0.35)):
        kit.loft((x, y, 0), [(0, 0.035), (0.1, 0.04), (0.66, 0.08)], wood)
    rod(kit, (0.35, 0.06, 0.08), (0.35, 0.06, 0.7), 0.02, wood, True)
    box(kit, (0.37, 0, 0.1), (0.06, 0.13, 0.03), wood)
    if kit.chance(0.6):
        posts(kit, 0.12, 0.3, 0, 0.45, 0.025, wood, kind=BOX, x=1.2)
        box(kit, (1.2, 0, 0.47), (0.17, 0.35, 0.05), leather(kit))


def harp(kit):
    wood, high = brass(kit) if kit.chance(0.6) else timber(kit), kit.rng.uniform(1.6, 1.9)
    kit.add(CYL, (-0.2, 0, 0.06), (0.32, 0.22, 0.06), (0.9, 1), material=wood)
    kit.between((-0.15, 0, 0.1), (-0.62, 0, high * 0.78), (0.05, 0.17), BOX, 0.45, material=wood)
    kit.loft((0.1, 0, 0.1), [(0, 0.05), (0.15, 0.035), (high - 0.2, 0.035), (high - 0.12, 0.06), (high - 0.02, 0.08), (high, 0.02)], wood)
    neck = [np.array(p) for p in ((-0.63, 0, high * 0.78), (-0.52, 0, high * 0.85), (-0.35, 0, high * 0.8), (-0.15, 0, high * 0.78), (0.02, 0, high * 0.87), (0.1, 0, high))]
    ribbon(kit, neck, (0.05, 0.03), wood)
    for share in np.linspace(0.1, 0.92, 16):
        x = -0.58 + 0.62 * share
        top = np.interp(x, [-0.63, -0.52, -0.35, -0.15, 0.1], np.array([0.78, 0.85, 0.8, 0.78, 0.95]) * high)
        foot = np.array([-0.62 + 0.47 * share, 0, high * 0.78 + (0.1 - high * 0.78) * share])
        rod(kit, foot, (x, 0, top), 0.004, pale(kit) if kit.chance(0.9) else bright(kit))


def bath(kit):
    white, metal, long, wide, z = pale(kit)._replace(gloss=0.5), brass(kit) if kit.chance(0.5) else steel(kit), kit.rng.uniform(0.75, 0.9), kit.rng.uniform(0.34, 0.42), 0.12
    outer = white if kit.chance(0.5) else enamel(kit)
    kit.add(CYL, (0, 0, z + 0.03), (long * 0.72, wide * 0.72, 0.04), (1.12, 1), material=outer)
    kit.add(TUBE, (0, 0, z + 0.28), (long * 0.8, wide * 0.8, 0.23), (1.25, 1), material=outer)
    kit.add(TUBE, (0, 0, z + 0.28), (long * 0.77, wide * 0.77, 0.23), (1.25, 1), material=white)
    rim = [np.array([long * np.cos(a), wide * np.sin(a), z + 0.51]) for a in np.linspace(0, 2 * np.pi, 21)]
    bent(kit, rim, 0.028, white)
    if kit.chance(0.6):
        kit.add(CYL, (0, 0, z + 0.36), (long * 0.86, wide * 0.86, 0.02), material=near(kit, (0.4, 0.6, 0.65), (0.75, 0.78, 0.8), pattern=CLOUDY))
    posts(kit, long * 0.55, wide * 0.6, 0, z + 0.12, 0.04, metal, 1.15)
    bent(kit, [(long + 0.02, 0, 0), (long + 0.02, 0, z + 0.68), (long - 0.14, 0, z + 0.68), (long - 0.16, 0, z + 0.58)], 0.022, metal)
    rod(kit, (long + 0.02, -0.12, z + 0.62), (long + 0.02, 0.12, z + 0.62), 0.02, metal)


def stove(kit):
    """Iron stoves with a pipe, and kitchen ranges."""
    rng = kit.rng
    metal, trim = iron(kit) if kit.chance(0.7) else enamel(kit), brass(kit) if kit.chance(0.5) else steel(kit)
    if kit.chance(0.4):
        posts(kit, 0.2, 0.2, 0, 0.15, 0.03, metal, 1.2)
        kit.loft((0, 0, 0.12), [(0, 0.3), (0.05, 0.26), (0.7, 0.26), (0.75, 0.32), (0.8, 0.32), (0.95, 0.08)], metal)
        box(kit, (0.24, 0, 0.45), (0.04, 0.13, 0.15), iron(kit))
        box(kit, (0.28, 0, 0.45), (0.005, 0.09, 0.08), shining(kit)._replace(first=np.array([0.9, 0.35, 0.05])))
        rod(kit, (-0.05, 0, 0.9), (-0.05, 0, rng.uniform(1.6, 2.2)), 0.07, metal)
    else:
        posts(kit, 0.25, 0.42, 0, 0.15, 0.03, metal)
        box(kit, (0, 0, 0.48), (0.3, 0.48, 0.36), metal)
        box(kit, (0, 0, 0.86), (0.33, 0.52, 0.025), iron(kit))
        fronts(kit, 0.3, 0.45, 0.18, 0.78, 2, 2, iron(kit) if kit.chance(0.5) else metal, trim)
        rod(kit, (0.37, -0.45, 0.8), (0.37, 0.45, 0.8), 0.015, trim)
        rod(kit, (0.3, 0.42, 0.8), (0.37, 0.42, 0.8), 0.012, trim, True)
        for x, y in ((0.12, 0.25), (-0.14, 0.25)):
            disc(kit, (x, y, 0.89), 0.1, 0.01, black(kit), True)
        disc(kit, (0.1, 0.25, 0.97), 0.1, 0.08, enamel(kit))
        if kit.chance(0.5):
            rod(kit, (-0.22, 0, 0.85), (-0.22, 0, rng.uniform(1.5, 2.1)), 0.08, metal)
        else:
            box(kit, (-0.3, 0, 1.1), (0.03, 0.5, 0.25), metal)


def fireplace(kit):
    rock, wide, high = stone(kit), kit.rng.uniform(0.6, 0.85), kit.rng.uniform(1.0, 1.25)
    box(kit, (0.2, 0, 0.04), (0.5, wide + 0.1, 0.04), stone(kit))
    box(kit, (0, wide - 0.12, high / 2), (0.2, 0.13, high / 2), rock, True)
    box(kit, (0, 0, high - 0.14), (0.2, wide, 0.14), rock)
    box(kit, (-0.17, 0, high / 2), (0.04, wide, high / 2), black(kit))
    box(kit, (0.03, 0, high + 0.03), (0.27, wide + 0.1, 0.04), rock if kit.chance(0.5) else timber(kit))
    if kit.chance(0.6):
        box(kit, (-0.05, 0, high + 0.6), (0.16, wide * 0.7, 0.56), rock, taper=(0.9, 0.8))
    for k, y in enumerate((-0.08, 0.1, 0.0)):
        rod(kit, (0.02, y - 0.22, 0.13 + 0.07 * k), (0.05, y + 0.2, 0.15 + 0.06 * k), 0.05, timber(kit))
    for y in (-0.1, 0.02, 0.12):
        kit.add(CYL, (0, y, 0.38), (0.05, 0.06, 0.15), (0.1, 1), material=shining(kit)._replace(first=np.array([0.95, 0.4, 0.05])))
    box(kit, (0.24, 0, 0.15), (0.012, wide - 0.28, 0.09), iron(kit), cut=(BARS, 12, 0.3))
    for y in (-0.4, 0, 0.4):
        ware(kit, (0.03, y * wide, high + 0.07), kit.rng.uniform(0.15, 0.25))


def basin(kit):
    white, metal = pale(kit)._replace(gloss=0.5), steel(kit)
    kit.loft((0, 0, 0), [(0, 0.15), (0.04, 0.13), (0.15, 0.09), (0.6, 0.09), (0.68, 0.15), (0.82, 0.28), (0.86, 0.3)], white, flat=1.15)
    kit.add(CYL, (0.02, 0, 0.862), (0.22, 0.27, 0.004), material=near(kit, (0.3, 0.33, 0.35)))
    box(kit, (-0.25, 0, 0.8), (0.08, 0.34, 0.09), white)
    bent(kit, [(-0.22, 0, 0.86), (-0.22, 0, 0.99), (-0.09, 0, 0.99), (-0.07, 0, 0.93)], 0.018, metal)
    rod(kit, (-0.23, 0.12, 0.88), (-0.23, 0.12, 0.95), 0.025, metal, True)


def cradle(kit):
    wood = timber(kit)
    kit.add(BOX, (0, 0, 0.36), (0.42, 0.2, 0.16), (1.12, 1.3), material=wood)
    kit.add(BOX, (0.05, 0, 0.55), (0.4, 0.24, 0.05), (0.95, 0.9), material=cloth(kit))
    kit.add(BALL, (-0.3, 0, 0.58), (0.12, 0.17, 0.06), material=pale(kit))
    box(kit, (-0.47, 0, 0.55), (0.02, 0.25, 0.32), wood)
    box(kit, (0.46, 0, 0.45), (0.02, 0.24, 0.2), wood)
    for x in (-0.36, 0.36):
        ribbon(kit, arc((x, 0, 0.75), 0.72, 240, 300, 7, "yz"), (0.025, 0.025), wood)
        rod(kit, (x, 0.12, 0.05), (x, 0.17, 0.25), 0.022, wood, True, BOX)
    if kit.chance(0.6):
        hood = arc((-0.28, 0, 0.55), (0.26, 0.3), 0, 180, 8, "yz")
        ribbon(kit, hood, (0.012, 0.19), wood)


def aquarium(kit):
    wood, hy = iron(kit) if kit.chance(0.5) else timber(kit), kit.rng.uniform(0.4, 0.65)
    low = kit.rng.choice([0.0, 0.7])
    if low:
        box(kit, (0, 0, low / 2), (0.24, hy, low / 2), wood)
        fronts(kit, 0.24, hy, 0.05, low - 0.03, 1, 2, wood._replace(first=wood.first * 1.3), steel(kit))
    water = near(kit, (0.1, 0.35, 0.42), (0.15, 0.45, 0.5), pattern=CLOUDY, frequency=3, gloss=0.6)
    box(kit, (0, 0, low + 0.03), (0.23, hy, 0.03), black(kit))
    box(kit, (0, 0, low + 0.1), (0.22, hy - 0.01, 0.05), near(kit, (0.5, 0.4, 0.25), pattern=SPECKLES, frequency=30))
    box(kit, (0, 0, low + 0.34), (0.215, hy - 0.015, 0.2), water)
    box(kit, (0, 0, low + 0.56), (0.23, hy, 0.03), black(kit))
    posts(kit, 0.22, hy - 0.01, low, low + 0.56, 0.008, black(kit), kind=BOX)
    for _ in range(5):
        y, z = kit.rng.uniform(-0.8, 0.6) * hy, low + kit.rng.uniform(0.25, 0.48)
        fish = bright(kit)
        kit.add(BALL, (0.217, y, z), (0.01, 0.05, 0.025), material=fish)
        kit.add(BOX, (0.217, y + 0.06, z), (0.006, 0.02, 0.025), material=fish)
    for y in (-0.5, 0.7):
        kit.add(CYL, (0.216, y * hy, low + 0.25), (0.008, 0.05, 0.13), (0.2, 1), material=near(kit, (0.05, 0.3, 0.05)))


def cage(kit):
    metal, r, z = brass(kit) if kit.chance(0.6) else pale(kit), kit.rng.uniform(0.2, 0.28), kit.rng.choice([0.03, 0.9])
    if z > 0.5:
        kit.loft((0, 0, 0), [(0, 0.2), (0.03, 0.18), (0.06, 0.03), (z, 0.025)], metal)
    disc(kit, (0, 0, z + 0.03), r * 1.05, 0.04, metal)
    for x, y in around(14, r):
        rod(kit, (x, y, z), (x, y, z + 0.45), 0.006, metal)
        bent(kit, [(x, y, z + 0.45), (x * 0.8, y * 0.8, z + 0.58), (0, 0, z + 0.68)], 0.006, metal)
    for high in (0.25, 0.45):
        kit.add(TUBE, (0, 0, z + high), (r, r, 0.01), material=metal)
    kit.add(BALL, (0, 0, z + 0.69), (0.03,) * 3, material=metal)
    rod(kit, (0, -r, z + 0.22), (0, r, z + 0.22), 0.008, timber(kit))
    feathers = bright(kit)
    kit.add(BALL, (0, 0, z + 0.28), (0.05, 0.035, 0.055), material=feathers)
    kit.add(BALL, (0.03, 0, z + 0.35), (0.03,) * 3, material=feathers)


def kennel(kit):
    wood, roof = planks(kit) if kit.chance(0.6) else enamel(kit), near(kit, (0.4, 0.06, 0.04), (0.1, 0.12, 0.15), (0.1, 0.25, 0.15), pattern=SHINGLES, frequency=8)
    box(kit, (0, 0, 0.33), (0.45, 0.32, 0.3), wood)
    box(kit, (0, 0, 0.03), (0.47, 0.34, 0.03), timber(kit))
    gable(kit, 0, 0.6, 0.55, 0.42, 0.32, roof, wood)
    box(kit, (0.45, 0, 0.25), (0.008, 0.15, 0.2), black(kit))
    disc(kit, (0.45, 0, 0.45), 0.15, 0.008, black(kit), rotation=ALONG_X)
    box(kit, (0.46, 0, 0.7), (0.015, 0.14, 0.045), pale(kit)._replace(pattern=WRITING, frequency=14.0))
    if kit.chance(0.5):
        disc(kit, (0.75, 0.2, 0.04), 0.11, 0.04, bright(kit), taper=0.8)


def ladder(kit):
    """Step ladders, also with a platform, and plain ones on a stay."""
    rng = kit.rng
    metal, high = steel(kit) if kit.chance(0.5) else timber(kit) if kit.chance(0.6) else bright(kit), rng.uniform(1.2, 2.4)
    reach = high * 0.28
    rod(kit, (reach, 0.3, 0), (0.03, 0.2, high), (0.03, 0.014), metal, True, BOX)
    rod(kit, (-reach, 0.28, 0), (-0.03, 0.2, high), (0.02, 0.014), metal, True, BOX)
    for share in np.arange(1, int(high / 0.27)) * 0.27 / high:
        y, x = 0.3 - 0.1 * share, reach + (0.03 - reach) * share
        box(kit, (x, 0, high * share), (0.045, y, 0.014), metal)
    for share in (0.25, 0.6):
        rod(kit, (-reach * (1 - share), -0.26, high * share), (-reach * (1 - share), 0.26, high * share), 0.014, metal)
    box(kit, (0, 0, high), (0.09, 0.21, 0.025), bright(kit) if kit.chance(0.5) else metal)
    rod(kit, (reach * 0.6, 0.265, high * 0.42), (-reach * 0.6, 0.25, high * 0.42), 0.008, black(kit), True)


def ironing(kit):
    metal, cover = steel(kit), cloth(kit)
    box(kit, (-0.1, 0, 0.9), (0.45, 0.19, 0.025), cover)
    kit.add(CYL, (0.35, 0, 0.9), (0.28, 0.19, 0.025), material=cover)
    rod(kit, (0.4, 0.1, 0.0), (-0.4, 0.1, 0.88), 0.015, metal, True)
    rod(kit, (-0.45, 0.06, 0.0), (0.3, 0.06, 0.88), 0.015, metal, True)
    rod(kit, (0.4, -0.22, 0.015), (0.4, 0.22, 0.015), 0.015, metal)
    rod(kit, (-0.45, -0.22, 0.015), (-0.45, 0.22, 0.015), 0.015, metal)
    kit.add(BOX, (-0.2, 0, 0.97), (0.13, 0.06, 0.05), (0.6, 0.4), material=enamel(kit))
    bent(kit, [(-0.29, 0, 1.0), (-0.28, 0, 1.08), (-0.12, 0, 1.08), (-0.11, 0, 1.0)], 0.015, black(kit))


def basket(kit):
    cane, r, high = near(kit, (0.5, 0.33, 0.15), (0.3, 0.17, 0.07), pattern=CHECKER, frequency=24), kit.rng.uniform(0.2, 0.3), kit.rng.uniform(0.15, 0.5)
    flat, flare = kit.rng.uniform(0.7, 1), kit.rng.uniform(1, 1.4)
    kit.add(CYL, (0, 0, 0.03), (r, r * flat, 0.03), material=cane)
    kit.add(TUBE, (0, 0, high / 2), (r, r * flat, high / 2), (flare, 1), material=cane)
    top = r * flare
    bent(kit, [np.array([top * np.cos(a), top * flat * np.sin(a), high]) for a in np.linspace(0, 2 * np.pi, 15)], 0.02, cane)
    if kit.chance(0.6):
        bent(kit, arc((0, 0, high), (top, kit.rng.uniform(0.2, 0.35)), 0, 180, 9, "xz"), 0.018, cane)
    kind, load = kit.rng.integers(3), bright(kit)
    if kind == 0:
        kit.add(BALL, (0, 0, high * 0.85), (top * 0.9, top * flat * 0.9, high * 0.35 + 0.05), material=cloth(kit))
    else:
        kit.add(CYL, (0, 0, high * 0.75), (top * 0.8, top * flat * 0.8, 0.02), material=black(kit))
        for x, y in [*around(7, top * 0.58), (0, 0)]:
            kit.add(BALL, (x, y * flat, high * 0.9), (top * 0.3,) * 3, material=load if kind == 1 else bright(kit))
