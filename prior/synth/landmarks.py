"""Makers of mosques, pyramids, iron towers, columns, domes, cathedrals, stones, theatres, bridge towers, wheels, ruins."""

import numpy as np

from .frames import lattice_tower
from .installations import (
    BLACK,
    BLUE,
    BRICK,
    CONCRETE,
    COPPER,
    EARTH,
    GOLD,
    GREEN,
    GREY,
    ORANGE,
    RED,
    RUST,
    SAND,
    SLATE,
    STONE,
    TILE,
    WHITE,
    WOOD,
    YELLOW,
    corners,
    railed,
    stairs,
    stonework,
    tinted,
)
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, PRISM, SPOKES, TUBE
from .materials import BANDS, BRICKS, CLOUDY, FACADE, LEDGES, PATCHWORK, PLAIN, PLANKS, RIBS, SEAMS, SHINGLES, STREAKS, WINDOWS, WRITING
from .people import person_body


def monumental(kit):
    """Mosques, pyramids, ziggurats, lattice towers on four curved legs, triumphal columns, domed capitols, cathedrals, obelisks, standing stones, amphitheatres,
    towers of suspension bridges, ferris wheels, bombed houses."""
    kinds = [mosque, pyramid, ziggurat, iron_tower, victory_column, capitol, cathedral, obelisk, stones, amphitheatre, bridge_tower, ferris_wheel, ruin, ruin]
    kinds[kit.rng.choice(len(kinds))](kit)


def arched(kit, at, half, high, material, deep=0.03, along=1):
    """An opening with a round head whose foot's middle is `at`, on a wall along x (0) or y (1)."""
    at = np.array(at, float)
    flat = (half, deep) if along == 0 else (deep, half)
    kit.add(BOX, at + [0, 0, (high - half) / 2], (*flat, (high - half) / 2), material=material)
    kit.add(CYL, at + [0, 0, high - half], (half, half, deep), rotation=ALONG_Y if along == 0 else ALONG_X, material=material)


def dome(kit, at, radius, style, skin, metal):
    """A round, pointed or onion-shaped dome with a finial; returns its height."""
    x, y, z = at
    if style == "round":
        tall = radius
        kit.add(BALL, at, (radius, radius, radius), material=skin)
    elif style == "flat":
        tall = radius * 0.65
        kit.add(BALL, at, (radius, radius, tall), material=skin)
    else:
        bulge, tall = (1.12, radius * 1.7) if style == "onion" else (1.0, radius * 1.4)
        kit.add(BALL, (x, y, z + radius * (0.35 if style == "onion" else 0.0)), (radius * bulge, radius * bulge, radius * 0.95), material=skin)
        low = radius * (0.95 if style == "onion" else 0.6)
        wide = radius * (0.87 if style == "onion" else 0.78)
        kit.loft((x, y, z), [(low, wide), (low + (tall - low) * 0.5, wide * 0.42), (tall, 0.02)], skin)
    kit.between((x, y, z + tall * 0.95), (x, y, z + tall + radius * 0.35), radius * 0.04, material=metal)
    kit.add(BALL, (x, y, z + tall + radius * 0.12), (radius * 0.09,) * 3, material=metal)
    return tall


def mosque(kit):
    rng = kit.rng
    wall, gold, dark = stonework(kit), tinted(kit, (GOLD, GREY), gloss=0.5), kit.material(dark=True)
    skin = tinted(kit, (GOLD, COPPER, WHITE, GREY, STONE, (0.05, 0.25, 0.4), GREEN), (PLAIN, SEAMS, RIBS), gloss=0.4)
    half, high, style = rng.uniform(1.0, 1.4), rng.uniform(0.6, 1.0), rng.choice(["round", "flat", "pointed", "onion"])
    kit.add(BOX, (0, 0, 0.06), (half * 1.7, half * 1.7, 0.06), material=wall)
    kit.add(BOX, (0, 0, high / 2 + 0.1), (half, half, high / 2), material=wall)
    top = high + 0.1
    kit.add(BOX, (0, 0, top), (half * 1.03, half * 1.03, 0.05), material=wall)
    radius, drum = half * rng.uniform(0.55, 0.75), rng.uniform(0.2, 0.4)
    kit.add(PRISM, (0, 0, top + drum / 2), (radius * 1.06, radius * 1.06, drum / 2), (1, 8 if kit.chance(0.5) else 16), material=wall)
    dome(kit, (0, 0, top + drum), min(radius, top + drum), style, skin, gold)
    if kit.chance(0.7):
        small = half * rng.uniform(0.2, 0.28)
        for x in (-1, 1):
            at = (x * half * 0.72, half * 0.72, top)
            kit.add(CYL, (at[0], at[1], top + 0.06), (small, small, 0.08), material=wall, mirror=True)
            kit.add(BALL, (at[0], at[1], top + 0.12), (small, small, small * (1.3 if style in ("onion", "pointed") else 1)), material=skin, mirror=True)
    gate, tall = half * 0.42, high * rng.uniform(1.1, 1.4)
    kit.add(BOX, (half, 0, 0.1 + tall / 2), (0.15, gate, tall / 2), material=wall)
    arched(kit, (half + 0.14, 0, 0.1), gate * 0.6, tall * 0.85, dark)
    spots = [(1, 1), (-1, 1)] if kit.chance(0.65) else [(rng.choice([-1, 1]), 1)]
    pair, spire, thin = kit.chance(0.8), rng.uniform(2.6, 4.2), rng.uniform(0.13, 0.2)
    for x, y in spots:
        for side in (1, -1) if pair else (1,):
            px, py = x * half * 1.25, y * side * half * 1.25
            kit.add(BOX, (px, py, 0.35), (thin * 1.5, thin * 1.5, 0.35), material=wall)
            kit.add(CYL, (px, py, spire / 2), (thin, thin, spire / 2), (0.8, 1), material=wall)
            for share in (0.66, 0.9):
                kit.add(CYL, (px, py, spire * share), (thin * 1.1, thin * 1.1, 0.06), (1.5, 1), material=wall)
            if style in ("onion", "round"):
                kit.add(BALL, (px, py, spire + 0.05), (thin * 1.05, thin * 1.05, thin * 1.5), material=skin)
            else:
                kit.add(CYL, (px, py, spire + thin * 1.7), (thin, thin, thin * 1.8), (0.03, 1), material=skin)
    for y in (-0.66, 0.66):
        arched(kit, (half, y * half, 0.25), half * 0.11, high * 0.65, dark)
    for x in (-0.6, 0, 0.6):
        kit.add(BOX, (x * half, 0, 0.1 + high * 0.45), (half * 0.1, half * 1.01, high * 0.28), material=dark)


def pyramid(kit):
    rng = kit.rng
    stone, half = tinted(kit, (SAND, STONE, CONCRETE, BRICK), (LEDGES, BRICKS, CLOUDY, STREAKS), frequency=rng.uniform(10, 30), gloss=0.0), rng.uniform(1.5, 2.2)
    if kit.chance(0.4):
        tall = half * rng.uniform(1.1, 1.5)
        kind = rng.choice(["plain", "capped", "bent", "glass"])
        if kind == "bent":
            kit.add(BOX, (0, 0, tall * 0.25), (half, half, tall * 0.25), (0.62, 0.62), material=stone)
            kit.add(BOX, (0, 0, tall * 0.68), (half * 0.62, half * 0.62, tall * 0.18), (0.01, 0.01), material=stone)
        elif kind == "glass":
            glass = kit.material(base=[0.12, 0.2, 0.24], pattern=SEAMS, second=[0.5] * 3, frequency=rng.uniform(8, 16), gloss=0.6)
            tall = half * rng.uniform(1.1, 1.35)
            kit.add(BOX, (0, 0, tall / 2), (half, half, tall / 2), (0.005, 0.005), material=glass)
            kit.add(BOX, (half * 0.95, 0, 0.25), (0.25, 0.3, 0.25), material=glass)
            for corner in corners(half, half, 0):
                kit.between(corner, (0, 0, tall), 0.03, BOX, material=tinted(kit, (GREY, WHITE)))
        else:
            kit.add(BOX, (0, 0, tall / 2), (half, half, tall / 2), (0.01, 0.01), material=stone)
            if kind == "capped":
                kit.add(BOX, (0, 0, tall * 0.88), (half * 0.255, half * 0.255, tall * 0.125), (0.02, 0.02), material=tinted(kit, (WHITE, GOLD, STONE)))
            kit.add(BOX, (half * 0.9, 0, tall * 0.07), (half * 0.1, 0.12, tall * 0.07), material=kit.material(dark=True))
        if kit.chance(0.6):  # lesser ones beside it
            for k in range(int(rng.integers(1, 4))):
                size = half * rng.uniform(0.22, 0.35)
                kit.add(BOX, (-half * 0.6 + k * half * 0.75, -half * 1.35, size * 0.6), (size, size, size * 0.6), (0.01, 0.01), material=stone)
        kit.add(BOX, (0, 0, 0.03), (half * 1.12, half * 1.12, 0.03), material=stone)
        return
    steps, rise, sharp = int(rng.integers(4, 10)), rng.uniform(0.9, 1.4) * half, rng.uniform(0.16, 0.35)
    high = rise / steps
    temple = kit.chance(0.75)
    last = half * (sharp if temple else 0.12)
    for k in range(steps):
        size = half + (last - half) * k / (steps - 1)
        kit.add(BOX, (0, 0, high * (k + 0.5)), (size, size, high / 2), (rng.choice([1, 0.96]),) * 2, material=stone)
    if not temple:
        return
    stair = kit.material(base=stone.first * 0.85, pattern=BANDS, frequency=30)
    run = half + (half - last) / (steps - 1) * 1.15 - last
    for way in range(int(rng.choice([1, 2, 4]))):
        spin = turn("z", (0, 180, 90, 270)[way])
        kit.add(BOX, spin @ [last + run / 2, 0, rise / 2], (run / 2, half * 0.13, rise / 2), (0.01, 1), (-run / 2, 0), spin, stair)
        for y in (-0.15, 0.15):
            kit.add(BOX, spin @ [last + run / 2 + 0.05, y * half, rise / 2 + 0.03], (run / 2 + 0.05, half * 0.03, rise / 2 + 0.03), (0.05, 1), (-run / 2, 0), spin, stone)
    room = rng.uniform(0.3, 0.5)
    kit.add(BOX, (0, 0, rise + room / 2), (last * 0.72, last * 0.72, room / 2), (0.95, 0.95), material=stone)
    kit.add(BOX, (0, 0, rise + room), (last * 0.78, last * 0.78, 0.06), material=stone)
    for y in (-0.4, 0, 0.4):
        kit.add(BOX, (last * 0.71, y * last, rise + room * 0.4), (0.03, last * 0.12, room * 0.4), material=kit.material(dark=True))
    if kit.chance(0.4):
        kit.add(BOX, (-last * 0.1, 0, rise + room + 0.25), (last * 0.15, last * 0.7, 0.22), material=stone, cut=(GRID, 3, 0.5))


def ziggurat(kit):
    rng = kit.rng
    brick = tinted(kit, (SAND, BRICK, STONE), (BRICKS, LEDGES, RIBS), frequency=rng.uniform(12, 30), gloss=0.0)
    long, wide, steps = rng.uniform(1.8, 2.4), rng.uniform(1.3, 1.8), int(rng.integers(2, 5))
    z, levels = 0.0, []
    for k in range(steps):
        high, share = rng.uniform(0.7, 0.95) if k == 0 else rng.uniform(0.3, 0.5), 1 - 0.75 * k / steps
        kit.add(BOX, (-0.1 * k, 0, z + high / 2), (long * share, wide * share, high / 2), (0.93, 0.92), material=brick)
        z += high
        levels.append((share, z))
        kit.add(BOX, (-0.1 * k, 0, z), (long * share * 0.94, wide * share * 0.93, 0.04), material=brick)
        if k == 0:
            for x in np.linspace(-0.85, 0.85, 6):
                kit.add(BOX, (x * long, 0, high / 2), (0.09, wide * 1.02, high / 2), (1, 0.92), material=brick)
            for y in np.linspace(-0.8, 0.8, 5):
                kit.add(BOX, (0, y * wide, high / 2), (long * 1.02, 0.09, high / 2), (0.93, 1), material=brick)
    stair = kit.material(base=brick.first * 0.9, pattern=BANDS, frequency=35)
    top = levels[0][1]
    kit.add(BOX, (long * 1.3, 0, top / 2), (long * 0.38, wide * 0.14, top / 2), (0.03, 1), (-long * 0.37, 0), material=stair)
    for y in (-0.155, 0.155):
        kit.add(BOX, (long * 1.31, y * wide, top / 2 + 0.04), (long * 0.4, wide * 0.02, top / 2 + 0.04), (0.05, 1), (-long * 0.37, 0), material=brick)
    for side in (-1, 1):
        kit.add(BOX, (long * 1.03, side * wide * 0.52, top / 2), (wide * 0.13, wide * 0.36, top / 2), (1, 0.03), (0, -side * wide * 0.35), material=stair)
    kit.add(BOX, (long * 1.0, 0, top * 0.5 + 0.1), (0.2, wide * 0.24, top * 0.5 + 0.1), material=brick)
    arched(kit, (long * 1.0 + 0.2, 0, top * 0.75), wide * 0.09, top * 0.4, kit.material(dark=True))
    for (low, foot), (upper, head) in zip(levels[:-1], levels[1:], strict=True):
        run = long * (low - upper) * 0.9
        kit.add(
            BOX,
            (long * (low + upper) / 2 * 0.93 - 0.1, 0, (foot + head) / 2),
            (np.hypot(run, head - foot) / 2, wide * 0.1, 0.08),
            rotation=turn("y", np.degrees(np.arctan2(head - foot, run))),
            material=stair,
        )
    if kit.chance(0.6):
        size = wide * levels[-1][0] * 0.5
        kit.add(BOX, (-0.1 * (steps - 1), 0, z + size * 0.45), (size, size, size * 0.45), (0.96, 0.96), material=tinted(kit, (BLUE, SAND, STONE, WHITE), (BRICKS, PLAIN)))
        kit.add(BOX, (-0.1 * (steps - 1) + size, 0, z + size * 0.3), (0.03, size * 0.25, size * 0.3), material=kit.material(dark=True))


def iron_tower(kit):
    rng = kit.rng
    iron, second = tinted(kit, (WOOD, RUST, GREY, RED, GREY, BLACK)), tinted(kit, (WHITE, GREY, RED))
    spread, tall, power = rng.uniform(1.0, 1.35), rng.uniform(4.6, 6.2), rng.uniform(2.2, 3.0)
    levels = np.array([0, 0.17, 0.2, 0.37, 0.4, 0.66, 0.9])

    def reach(level):
        return spread * (1 - level) ** power + 0.05

    for low, high in ((0, 1), (2, 3)):  # four pillars apart
        a, b = reach(levels[low]), reach(levels[high])
        thick = 0.24 * spread * (1 if low == 0 else 0.62)
        for corner, top in zip(corners(a, a, levels[low] * tall + 0.24 * (low == 0)), corners(b, b, levels[high] * tall), strict=True):
            kit.between(corner, top, (thick, thick), BOX, 0.75, material=iron, cut=(GRID, 3.2, 0.3))
            kit.between(corner, top, (thick * 0.35, thick * 0.35), BOX, 0.75, material=iron)
    for level, size in ((1, 1.25), (3, 1.2)):
        half = reach(levels[level]) * size + 0.05
        z = (levels[level] + levels[level + 1]) / 2 * tall
        kit.add(BOX, (0, 0, z), (half, half, 0.015 * tall), (1.06, 1.06), material=iron)
        railed(kit, 0, 0, z + 0.015 * tall, half * 1.04, half * 1.04, 0.16, iron)
    bend = reach(levels[1]) * 0.95  # arches between the feet
    for k in range(4):
        spin = turn("z", 90 * k)
        angles = np.radians(np.linspace(12, 168, 5))
        edge = [spin @ [spread * 0.78, bend * 1.05 * np.cos(a), 0.165 * tall * np.sin(a)] for a in angles]
        for start, end in zip(edge[:-1], edge[1:], strict=True):
            kit.between(start, end, (0.04, 0.03), BOX, material=iron)
    a, b, c = reach(levels[4]) + 0.06, reach(levels[5]) + 0.01, reach(levels[6])
    lattice_tower(kit, (0, 0, levels[4] * tall), a, b, (levels[5] - levels[4]) * tall, iron, 4)
    kit.between((0, 0, levels[5] * tall), (0, 0, levels[6] * tall), (b, b), BOX, c / b, material=iron, cut=(GRID, 6, 0.4))
    kit.between((0, 0, levels[4] * tall), (0, 0, levels[6] * tall), (a * 0.4, a * 0.4), BOX, 0.3, material=iron)
    kit.add(BOX, (0, 0, levels[6] * tall), (0.16, 0.16, 0.06), material=iron)
    kit.add(BOX, (0, 0, levels[6] * tall + 0.13), (0.11, 0.11, 0.09), material=second)
    kit.between((0, 0, levels[6] * tall), (0, 0, tall * 1.03), 0.025, material=iron)
    for corner in corners(reach(0), reach(0), 0.05):
        kit.add(BOX, corner + [0, 0, 0.1], (0.3 * spread, 0.3 * spread, 0.15), (0.9, 0.9), material=tinted(kit, (STONE, CONCRETE)))


def victory_column(kit):
    rng = kit.rng
    stone, gold = stonework(kit), tinted(kit, (GOLD, COPPER, BLACK, STONE, WHITE), gloss=0.4)
    half, z = rng.uniform(0.8, 1.1), 0.0
    for _ in range(int(rng.integers(2, 5))):
        kit.add(BOX, (0, 0, z + 0.06), (half, half, 0.06), material=stone)
        z += 0.12
        half *= 0.87
    base, tall, radius = rng.uniform(0.5, 1.0), rng.uniform(2.4, 4), rng.uniform(0.22, 0.34)
    half = max(half * 0.85, radius * 1.3)
    kit.add(BOX, (0, 0, z + base / 2), (half, half, base / 2), (0.96, 0.96), material=stone)
    for side in range(4):
        spin = turn("z", 90 * side)
        kit.add(
            BOX, np.array([0, 0, z + base / 2]) + spin @ [half * 0.985, 0, 0], (0.03, half * 0.65, base * 0.3), rotation=spin, material=gold if kit.chance(0.5) else stone
        )
    z += base
    kit.add(BOX, (0, 0, z), (half * 1.12, half * 1.12, 0.05), material=stone)
    kit.loft((0, 0, z + 0.04), [(0, radius * 1.35), (0.1, radius * 1.3), (0.14, radius)], stone)
    shaft = tinted(kit, (STONE, WHITE, COPPER, CONCRETE), (RIBS, BANDS, PLAIN, CLOUDY), frequency=rng.uniform(20, 45)) if kit.chance(0.5) else stone
    kit.add(CYL, (0, 0, z + 0.15 + tall / 2), (radius, radius, tall / 2), (rng.uniform(0.78, 0.92), 1), material=shaft)
    if kit.chance(0.5):
        for share in rng.choice([[0.3, 0.6], [0.2, 0.45, 0.7]][int(kit.chance(0.5))], 2, replace=False):
            kit.add(CYL, (0, 0, z + 0.15 + tall * share), (radius * 1.06, radius * 1.06, 0.05), material=gold)
    z += 0.15 + tall
    kit.loft((0, 0, z - 0.02), [(0, radius * 0.85), (0.2, radius * 1.3)], gold if kit.chance(0.4) else stone)
    kit.add(BOX, (0, 0, z + 0.22), (radius * 1.4, radius * 1.4, 0.05), material=stone)
    if kit.chance(0.5):
        railed(kit, 0, 0, z + 0.27, radius * 1.3, radius * 1.3, 0.12, stone)
    kit.loft((0, 0, z + 0.25), [(0, radius * 0.8), (0.25, radius * 0.65)], stone)
    z += 0.5
    size = rng.uniform(0.45, 0.75)
    if kit.chance(0.8):
        person_body(kit, (0, 0, z), size, gold, gold, gold, "stand")
        if kit.chance(0.45):
            for side in (-1, 1):
                kit.add(
                    BOX,
                    (-size * 0.2, side * size * 0.38, z + size * 0.85),
                    (0.025, size * 0.13, size * 0.42),
                    (1, 1.4),
                    (0, side * size * 0.15),
                    turn("x", -side * 25),
                    gold,
                )
    else:
        kit.add(BALL, (0, 0, z + 0.2), (0.24, 0.24, 0.24), material=gold)
        kit.between((0, 0, z + 0.3), (0, 0, z + 0.8), 0.03, material=gold)
    if kit.chance(0.4):
        for corner in corners(half * 1.4, half * 1.4, 0.25):
            kit.add(BOX, corner, (0.14, 0.14, 0.25), material=stone)
            kit.add(BALL, corner + [0, 0, 0.35], (0.15, 0.12, 0.14), material=gold)


def capitol(kit):
    rng = kit.rng
    stone, skin, glass = (
        tinted(kit, (WHITE, WHITE, STONE, CONCRETE), (PLAIN, CLOUDY, STREAKS)),
        tinted(kit, (WHITE, COPPER, GOLD, GREY), (PLAIN, RIBS), gloss=0.3),
        kit.material(dark=True),
    )
    long, deep, high = rng.uniform(1.8, 2.6), rng.uniform(0.7, 0.9), rng.uniform(0.65, 0.9)
    front = kit.material(base=stone.first, pattern=rng.choice([WINDOWS, FACADE, PLAIN]), frequency=rng.uniform(10, 16), second=[0.04, 0.05, 0.06])
    kit.add(BOX, (0, 0, 0.08), (deep * 1.35, long * 1.05, 0.08), material=stone)
    kit.add(BOX, (0, 0, 0.16 + high / 2), (deep, long, high / 2), material=front)
    top = 0.16 + high
    kit.add(BOX, (0, 0, top), (deep * 1.05, long * 1.02, 0.06), material=stone)
    kit.add(BOX, (0, long * 0.88, 0.16 + high / 2), (deep * 1.2, long * 0.2, high / 2), material=front, mirror=True)
    kit.add(BOX, (0, long * 0.88, top + 0.04), (deep * 1.24, long * 0.22, 0.07), material=stone, mirror=True)
    portico, count = deep + rng.uniform(0.3, 0.45), int(rng.choice([6, 8]))
    span = long * 0.36
    kit.add(BOX, (deep + 0.2, 0, 0.1), (portico - deep + 0.3, span * 1.1, 0.1), material=stone)
    for k in range(4):
        kit.add(BOX, (portico + 0.45 - 0.09 * k, 0, 0.03 + 0.05 * k), (0.2, span * 1.0, 0.03 + 0.01 * k), material=stone)
    for y in np.linspace(-0.95, 0.95, count) * span:
        kit.add(CYL, (portico, y, 0.2 + high / 2), (0.065, 0.065, high / 2), (0.85, 1), material=stone)
    kit.add(BOX, ((portico + deep * 0.5) / 2, 0, top + 0.07), ((portico - deep * 0.5) / 2 + 0.12, span * 1.1, 0.08), material=stone)
    kit.add(BOX, ((portico + deep * 0.5) / 2, 0, top + 0.28), ((portico - deep * 0.5) / 2 + 0.12, span * 1.12, 0.14), (1, 0.03), material=stone)
    radius, drum = deep * rng.uniform(0.62, 0.8), rng.uniform(0.5, 0.8)
    kit.add(PRISM, (0, 0, top + 0.15), (radius * 1.3, radius * 1.3, 0.17), (1, 8), material=stone)
    foot = top + 0.3
    kit.add(CYL, (0, 0, foot + drum / 2), (radius * 0.85, radius * 0.85, drum / 2), material=glass if kit.chance(0.3) else stone)
    for x, y in around(int(rng.choice([12, 16])), radius * 0.98, 11):
        kit.add(CYL, (x, y, foot + drum / 2), (0.045, 0.045, drum / 2), material=stone)
    kit.add(CYL, (0, 0, foot + drum + 0.04), (radius * 1.07, radius * 1.07, 0.06), material=stone)
    kit.add(CYL, (0, 0, foot + drum + 0.2), (radius * 0.9, radius * 0.9, 0.12), material=stone)
    peak = foot + drum + 0.3 + radius * rng.uniform(0.85, 1.2)
    kit.add(BALL, (0, 0, foot + drum + 0.28), (radius * 0.9, radius * 0.9, peak - foot - drum - 0.28), material=skin)
    kit.loft((0, 0, peak - 0.05), [(0, 0.17), (0.3, 0.15), (0.31, 0.19), (0.36, 0.14), (0.55, 0.03)], stone)
    kit.between((0, 0, peak + 0.45), (0, 0, peak + 0.75), 0.035, material=tinted(kit, (GOLD, COPPER, STONE)))
    for y in (0.55, 0.75):
        kit.add(BOX, (0, y * long, 0.2 + high * 0.55), (deep * 1.01, 0.05, high * 0.25), material=glass, mirror=True)


def cathedral(kit):
    rng = kit.rng
    stone = tinted(kit, (STONE, CONCRETE, GREY, SAND, BRICK), (STREAKS, BRICKS, CLOUDY, PLAIN), frequency=rng.uniform(12, 25), gloss=0.0)
    roof, glass, metal = (
        tinted(kit, (SLATE, COPPER, TILE, GREY), (SHINGLES, SEAMS, PLAIN)),
        kit.material(base=[0.03, 0.035, 0.05], pattern=PLAIN, gloss=0.3),
        tinted(kit, (GOLD, BLACK)),
    )
    long, wide, high = rng.uniform(1.8, 2.4), rng.uniform(0.4, 0.5), rng.uniform(1.1, 1.5)
    rise, aisle, low = wide * rng.uniform(0.9, 1.4), rng.uniform(0.3, 0.4), high * 0.55
    kit.add(BOX, (-0.2, 0, high / 2), (long, wide, high / 2), material=stone)
    kit.add(BOX, (-0.2, 0, high + rise / 2), (long * 1.01, wide * 1.06, rise / 2), (1, 0.02), material=roof)
    for side in (-1, 1):
        kit.add(BOX, (-0.2, side * (wide + aisle / 2), low / 2), (long * 0.98, aisle / 2, low / 2), material=stone)
        kit.add(BOX, (-0.2, side * (wide + aisle / 2), low + 0.1), (long * 0.99, aisle * 0.55, 0.1), (1, 0.02), (0, -side * aisle * 0.52), material=roof)
    cross = -long * rng.uniform(0.25, 0.4)
    kit.add(BOX, (cross, 0, high / 2), (wide, wide + aisle + 0.3, high / 2), material=stone)
    kit.add(BOX, (cross, 0, high + rise / 2), (wide * 1.06, wide + aisle + 0.32, rise / 2), (0.02, 1), material=roof)
    kit.add(CYL, (cross, 0, high * 0.68), (wide * 0.5, wide * 0.5, wide + aisle + 0.32), rotation=ALONG_Y, material=glass)
    kit.add(CYL, (-0.2 - long, 0, high * 0.45), (wide * 0.98, wide * 0.98, high * 0.45), material=stone)
    kit.add(CYL, (-0.2 - long, 0, high * 0.9 + rise * 0.35), (wide * 1.04, wide * 1.04, rise * 0.35), (0.05, 1), material=roof)
    half, tall, x = rng.uniform(0.3, 0.38), high * rng.uniform(1.6, 2.3), long - 0.1
    y = wide * 0.5 + half
    spire = rng.choice([0, rng.uniform(0.8, 1.6), rng.uniform(1.2, 2.0)])
    for side in (-1, 1):
        kit.add(BOX, (x, side * y, tall / 2), (half, half, tall / 2), (0.95, 0.95), material=stone)
        for share in (0.36, 0.66):
            kit.add(BOX, (x, side * y, tall * share), (half * 1.06, half * 1.06, 0.03), material=stone)
        kit.add(BOX, (x, side * y, tall * 0.82), (half * 1.0, half * 0.36, tall * 0.12), material=glass)
        kit.add(BOX, (x, side * y, tall * 0.82), (half * 0.36, half * 1.0, tall * 0.12), material=glass)
        if spire:
            kit.add(PRISM, (x, side * y, tall + spire / 2), (half * 0.85, half * 0.85, spire / 2), (0.03, 8), material=stone if kit.chance(0.4) else roof)
            kit.between((x, side * y, tall + spire * 0.95), (x, side * y, tall + spire + 0.25), 0.018, material=metal)
        for px, py in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            if spire or side > 0:
                kit.add(BOX, (x + px * half * 0.85, side * y + py * half * 0.85, tall + 0.1), (0.05, 0.05, 0.14), (0.2, 0.2), material=stone)
    kit.add(BOX, (x + 0.05, 0, high * 0.6), (half * 0.8, y, high * 0.6), material=stone)
    face = x + 0.05 + half * 0.8
    kit.add(CYL, (face, 0, high * 0.85), (wide * 0.45, wide * 0.45, 0.04), rotation=ALONG_X, material=glass)
    for off, size in ((0, 0.16), (y, 0.11), (-y, 0.11)):
        arched(kit, ((face if off == 0 else x + half * 0.98) + 0.01, off, 0), size, 0.5, glass, 0.04)
    if kit.chance(0.6):
        kit.add(PRISM, (cross, 0, high + rise + 0.55), (0.16, 0.16, 0.75), (0.03, 8), material=roof)
    for px in np.linspace(-0.8, 0.55, 4):
        kit.add(BOX, (px * long, 0, low * 0.5), (0.07, wide + aisle + 0.02, low * 0.3), material=glass)
        kit.add(BOX, (px * long, 0, (low + high) / 2 + 0.15), (0.07, wide + 0.02, (high - low) * 0.3), material=glass)


def obelisk(kit):
    rng = kit.rng
    stone = tinted(kit, (STONE, CONCRETE, WHITE, BRICK, GREY, BLACK), (PLAIN, CLOUDY, WRITING, BRICKS, STREAKS), frequency=rng.uniform(10, 30))
    foot, gold = stonework(kit), tinted(kit, (GOLD, COPPER, BLACK), gloss=0.4)
    half, z = rng.uniform(0.7, 1.2), 0.0
    for _ in range(int(rng.integers(1, 5))):
        kit.add(BOX, (0, 0, z + 0.07), (half, half, 0.07), material=foot)
        z += 0.14
        half *= rng.uniform(0.75, 0.88)
    thick, tall = rng.uniform(0.25, 0.4), rng.uniform(2.6, 5)
    half = max(half * 0.85, thick * 1.25)
    if kit.chance(0.75):
        base = rng.uniform(0.3, 0.8)
        kit.add(BOX, (0, 0, z + base / 2), (half, half, base / 2), (0.94, 0.94), material=foot)
        kit.add(BOX, (0, 0, z + base), (half * 1.1, half * 1.1, 0.06), material=foot)
        kit.add(BOX, (half * 0.97, 0, z + base * 0.5), (0.03, half * 0.6, base * 0.3), material=tinted(kit, (GOLD, BLACK, WHITE), (WRITING,), frequency=40))
        z += base + 0.05
    if kit.chance(0.4):
        for corner in corners(thick * 0.8, thick * 0.8, z + 0.06):
            kit.add(BALL, corner, (0.09, 0.09, 0.08), material=gold)
        z += 0.11
    taper = rng.uniform(0.6, 0.75)
    kit.add(BOX, (0, 0, z + tall / 2), (thick, thick, tall / 2), (taper, taper), material=stone)
    tip = thick * taper
    kit.add(BOX, (0, 0, z + tall + tip * 0.8), (tip, tip, tip * 0.8), (0.02, 0.02), material=gold if kit.chance(0.25) else stone)
    if kit.chance(0.3):
        kit.add(CYL, (0, 0, z + tall + tip * 1.9), (0.02, 0.02, tip * 0.5), material=gold)
    if kit.chance(0.4):
        size = half * 2.2 + 0.4
        for corner in corners(size, size, 0.2):
            kit.add(CYL, corner, (0.07, 0.07, 0.2), material=foot)
        for y in (-size, size):
            kit.between((-size, y, 0.3), (size, y, 0.3), 0.025, material=gold)
        for x in (-size, size):
            kit.between((x, -size, 0.3), (x, size, 0.3), 0.025, material=gold)
        kit.add(BOX, (0, 0, 0.02), (size * 1.06, size * 1.06, 0.03), material=foot)


def stones(kit):
    rng = kit.rng
    rock = tinted(kit, (GREY, CONCRETE, STONE, SLATE), (CLOUDY, STREAKS, CLOUDY), frequency=rng.uniform(4, 12), gloss=0.0)
    grass = tinted(kit, ((0.1, 0.16, 0.04), EARTH), (CLOUDY,), gloss=0.0)

    def upright(x, y, spin, wide, deep, tall):
        lean = turn("z", spin + rng.normal(0, 5)) @ turn("x", rng.normal(0, 1.5)) @ turn("y", rng.normal(0, 1.5))
        share = rng.uniform(0.72, 0.95)
        kit.add(BOX, (x, y, tall / 2 - 0.04), (deep, wide, tall / 2 + 0.04), (share, share), rotation=lean, material=rock)

    kind = rng.choice(["ring", "dolmen", "row", "trilithon"])
    if kind in ("ring", "trilithon"):
        count, radius, tall = (int(rng.integers(9, 15)), rng.uniform(2.0, 2.6), rng.uniform(0.9, 1.3)) if kind == "ring" else (0, 0.0, 1.5)
        missing = rng.random(count) < rng.choice([0, 0.2, 0.4])
        wide = radius * np.pi / max(count, 1) * 0.6
        kit.add(CYL, (0, 0, 0.0), (max(radius, 1.5) * 1.12, max(radius, 1.5) * 1.12, 0.05), material=grass)
        for k, (x, y) in enumerate(around(count, radius)):
            if not missing[k]:
                upright(x, y, 360 * k / count, wide, 0.16, tall * rng.choice([1, 1, rng.uniform(0.8, 1)]))
            if not missing[k] and not missing[(k + 1) % count] and kit.chance(0.75):
                spin = turn("z", 360 * (k + 0.5) / count)
                kit.add(BOX, spin @ [radius * np.cos(np.pi / count), 0, tall + 0.1], (0.17, radius * np.sin(np.pi / count) * 1.04, 0.13), rotation=spin, material=rock)
        for angle in [0, 60, 120, 180, 240][: int(rng.integers(0, 6))] if kind == "ring" else np.arange(int(rng.integers(1, 4))) * 120.0:
            spin, at, high = turn("z", angle), radius * 0.5 if kind == "ring" else 0.75, tall * 1.3
            for y in (-0.32, 0.32):
                x, y = (spin @ [at, y, 0])[:2]
                upright(x, y, angle, 0.2, 0.17, high)
            kit.add(BOX, spin @ [at, 0, high + 0.08], (0.2, 0.6, 0.13), rotation=spin, material=rock)
        for _ in range(int(rng.integers(0, 4))):
            x, y = rng.uniform(-0.4, 0.4, 2) * max(radius, 1.5)
            kit.add(BOX, (x, y, 0.12), (0.5, 0.18, 0.13), (0.9, 0.9), rotation=turn("z", rng.uniform(0, 180)), material=rock)
    elif kind == "dolmen":
        tall = rng.uniform(0.8, 1.3)
        for side in (-1, 1):
            for x in np.linspace(-0.6, 0.6, int(rng.integers(2, 4))):
                upright(x, side * rng.uniform(0.45, 0.55), 90, 0.24, 0.13, tall)
        upright(-0.85, 0, 0, 0.4, 0.13, tall)
        for x, long in ((0.0, 1.15),) if kit.chance(0.6) else ((-0.5, 0.6), (0.55, 0.55)):
            kit.add(BOX, (x, 0, tall + 0.1), (long, 0.85, 0.19), (0.85, 0.85), rotation=turn("y", rng.normal(0, 3)), material=rock)
        kit.add(CYL, (0, 0, 0.06), (1.7, 1.4, 0.07), (0.85, 1), material=grass)
    else:
        count = int(rng.integers(1, 8))
        for k in range(count):
            high = rng.uniform(0.8, 2.0)
            kit.add(
                BOX,
                (0.95 * k, rng.normal(0, 0.08), high / 2 - 0.02),
                (rng.uniform(0.18, 0.32), rng.uniform(0.15, 0.22), high / 2 + 0.02),
                (rng.uniform(0.3, 0.8), rng.uniform(0.5, 0.9)),
                (rng.normal(0, 0.08), 0),
                turn("z", rng.normal(0, 15)),
                rock,
            )
        kit.add(BOX, (0.475 * (count - 1), 0, 0.0), (0.475 * count + 0.4, 0.6, 0.05), material=grass)


def amphitheatre(kit):
    rng = kit.rng
    stone, sand, dark = (
        tinted(kit, (STONE, SAND, CONCRETE, BRICK), (STREAKS, CLOUDY, BRICKS), gloss=0.0),
        tinted(kit, (SAND, EARTH), (CLOUDY,), gloss=0.0),
        kit.material(dark=True),
    )
    if kit.chance(0.55):  # a whole ring with arcades
        long, wide, levels = rng.uniform(2.2, 2.8), rng.uniform(1.7, 2.2), int(rng.integers(2, 4))
        storey, count = rng.uniform(0.38, 0.5), 18
        high = storey * levels
        kit.add(TUBE, (0, 0, high / 2), (long, wide, high / 2), material=stone)
        arena, steps = rng.uniform(0.42, 0.52), int(rng.integers(3, 6))
        for k in range(steps):
            inner, outer = (arena + (1 - arena) * (k + i) / steps for i in (0, 1))
            top = high * (0.15 + 0.8 * (k + 0.5) / steps)
            kit.add(
                TUBE,
                (0, 0, top),
                (long * inner, wide * inner, high * 0.4 / steps),
                (outer / inner, 1),
                material=kit.material(base=stone.first * rng.uniform(0.85, 1.05), pattern=rng.choice([PLAIN, CLOUDY, BANDS]), frequency=30),
            )
        kit.add(TUBE, (0, 0, high * 0.08), (long * arena, wide * arena, high * 0.09), material=stone)
        kit.add(CYL, (0, 0, 0.02), (long * arena, wide * arena, 0.03), material=sand)
        for k in range(levels + 1):
            kit.add(TUBE, (0, 0, max(k * storey, 0.05)), (long * 1.015, wide * 1.015, 0.035), material=stone)
        outer_wall = kit.chance(0.5)  # what remains of a higher one
        for k in range(count):
            angle = 2 * np.pi * (k + 0.5) / count
            if outer_wall and np.pi / 2 < angle < np.pi * 1.08:
                continue
            at, out = np.array([long * np.cos(angle), wide * np.sin(angle), 0]), np.degrees(np.arctan2(long * np.sin(angle), wide * np.cos(angle)))
            for level in range(min(levels, 2)):
                kit.add(BOX, at + [0, 0, storey * (level + 0.45)], (0.05, 0.16, storey * 0.33), (1, 0.7), rotation=turn("z", out), material=dark)
        if outer_wall:
            for k in range(8):
                angle = 2 * np.pi * (k + 6) / 24
                at, out = np.array([long * 1.08 * np.cos(angle), wide * 1.08 * np.sin(angle), 0]), np.degrees(np.arctan2(long * np.sin(angle), wide * np.cos(angle)))
                tall = (high + storey) / 2 * (1 if 0 < k < 7 else 0.75)
                kit.add(BOX, at + [0, 0, tall], (0.1, np.pi * long / 24 * 1.12, tall), rotation=turn("z", out), material=stone)
                for z in (0.45, 1.45):
                    kit.add(BOX, at * 1.045 + [0, 0, storey * z], (0.05, 0.15, storey * 0.32), (1, 0.7), rotation=turn("z", out), material=dark)
        return
    rings, deep, rise = int(rng.integers(4, 7)), rng.uniform(0.24, 0.34), rng.uniform(0.12, 0.2)
    inner, pieces = rng.uniform(0.7, 1.0), 8
    for k in range(rings):
        radius = inner + deep * (k + 0.5)
        for j in range(pieces):
            spin = turn("z", 90 + 180 * (j + 0.5) / pieces)
            half = (radius + deep / 2) * np.tan(np.pi / 2 / pieces) * 1.02
            kit.add(BOX, spin @ [radius, 0, rise * (k + 1) / 2], (deep / 2, half, rise * (k + 1) / 2), rotation=spin, material=stone)
    kit.add(CYL, (0, 0, 0.02), (inner * 1.03, inner * 1.03, 0.03), material=sand)
    back, wide = inner * 0.55, inner + deep * rings * 0.75
    kit.add(BOX, (back, 0, 0.1), (inner * 0.35, wide, 0.1), material=stone)
    for y in np.linspace(-0.9, 0.9, 6) * wide:
        kit.add(CYL, (back + 0.2, y, 0.55), (0.06, 0.06, 0.4), (0.85, 1), material=stone)
    kit.add(BOX, (back + 0.2, 0, 0.98), (0.1, wide, 0.06), material=stone)
    kit.add(BOX, (back + inner * 0.35, 0, 0.5), (0.07, wide, 0.5), material=stone)


def bridge_tower(kit):
    rng = kit.rng
    paint = tinted(kit, ((0.5, 0.1, 0.04), GREY, RED, GREEN, WHITE), (PLAIN, STREAKS)) if kit.chance(0.65) else stonework(kit)
    cable, road = tinted(kit, ((0.5, 0.1, 0.04), GREY, BLACK, WHITE)), tinted(kit, (GREY, BLACK, CONCRETE))
    half, tall, deck, thick = rng.uniform(0.45, 0.65), rng.uniform(3, 4.5), rng.uniform(0.8, 1.3), rng.uniform(0.12, 0.2)
    masonry, long = kit.chance(0.3), rng.uniform(2.2, 3.4)
    kit.add(BOX, (0, 0, 0.12), (thick * 2.2, half + thick * 2, 0.14), material=tinted(kit, (CONCRETE, STONE)))
    lean = rng.choice([0, 0, 0.12])
    for y in (-1, 1):
        kit.between((0, y * (half + lean), 0.2), (0, y * half, tall), (thick, thick), BOX, 0.8, material=paint)
    if masonry:
        kit.add(BOX, (0, 0, tall * 0.88), (thick * 0.95, half, tall * 0.12), material=paint)
        kit.add(BOX, (0, 0, deck * 0.5), (thick * 1.05, half, deck * 0.5), material=paint)
        kit.between((0, 0, 0.2), (0, 0, tall), (thick, thick * 0.8), BOX, material=paint)
        kit.add(BOX, (0, 0, tall + 0.05), (thick * 1.2, half + thick * 1.4, 0.08), material=paint)
        for y in (-0.5, 0.5):  # pointed heads of the two gateways
            for side in (-1, 1):
                kit.add(BOX, (0, y * half + side * half * 0.3, tall * 0.73), (thick * 0.9, half * 0.13, tall * 0.06), (1, 2), (0, -side * half * 0.1), material=paint)
    else:
        beams = int(rng.integers(2, 5))
        for share in np.linspace(0.98, 0.55, beams):
            kit.add(BOX, (0, 0, tall * share), (thick * 0.7, half, tall * 0.03), material=paint)
        kit.add(BOX, (0, 0, deck - 0.13), (thick * 0.8, half + lean, 0.08), material=paint)
        if kit.chance(0.4):
            kit.between((0, -half, 0.35), (0, half, deck - 0.2), 0.06, BOX, material=paint, mirror=True)
        for y in (-half, half):
            kit.add(BOX, (0, y, tall + 0.06), (thick * 1.0, thick * 0.9, 0.09), material=paint)
    kit.add(BOX, (0, 0, deck), (long, half * 0.85, 0.07), material=road)
    for y in (-1, 1):
        kit.add(BOX, (0, y * half * 0.85, deck), (long, 0.03, 0.13), material=paint, cut=(LATTICE, 5, 0.3) if kit.chance(0.5) else (0, 1.0, 1.0))
    stays, sag = kit.chance(0.3), rng.uniform(0.1, 0.25)
    for way in (-1, 1):
        if stays:
            for k in range(1, 6):
                kit.between((0, half * 0.9, tall * (0.6 + 0.07 * k)), (way * long * k / 5 * 0.97, half * 0.85, deck), 0.018, material=cable, mirror=True)
            continue
        spots = np.linspace(0, 1, 5)
        drop = [tall + (deck + 0.25 + sag - tall) * (1.7 * t - 0.7 * t * t) for t in spots]
        for a in range(4):
            kit.between((way * long * spots[a], half * 0.92, drop[a]), (way * long * spots[a + 1], half * 0.92, drop[a + 1]), 0.03, material=cable, mirror=True)
        for k in range(1, 5):
            kit.between((way * long * spots[k], half * 0.92, deck), (way * long * spots[k], half * 0.92, drop[k]), 0.014, material=cable, mirror=True)


def ferris_wheel(kit):
    rng = kit.rng
    paint, second, dark = tinted(kit, (WHITE, WHITE, RED, BLUE, YELLOW, GREY)), tinted(kit, (RED, BLUE, WHITE, YELLOW)), kit.material(dark=True)
    radius, cabins = rng.uniform(1.6, 2.2), int(rng.choice([10, 12, 14, 16]))
    hub, deep = radius * rng.uniform(1.12, 1.2) + 0.3, rng.uniform(0.16, 0.28)
    spokes = cabins * int(rng.choice([1, 1, 2]))
    for y in (-deep, deep):
        kit.add(CYL, (0, y, hub), (radius, radius, 0.02), rotation=ALONG_Y, material=paint, cut=(SPOKES, spokes, 0.07))
    kit.add(TUBE, (0, 0, hub), (radius * 0.99, radius * 0.99, deep), rotation=ALONG_Y, material=second, cut=(BARS, 16, 0.2))
    kit.add(CYL, (0, 0, hub), (0.2, 0.2, deep * 2.2), rotation=ALONG_Y, material=second)
    kit.add(CYL, (0, 0, hub), (0.1, 0.1, deep * 2.8), rotation=ALONG_Y, material=dark)
    for x in (-1, 1):
        kit.between((x * radius * 0.55, deep * 3.2, 0.1), (0, deep * 2.3, hub), 0.075, material=paint, mirror=True)
    if kit.chance(0.6):
        kit.between((-radius * 0.3, deep * 2.8, hub * 0.45), (radius * 0.3, deep * 2.8, hub * 0.45), 0.05, material=paint, mirror=True)
    kit.add(BOX, (0, 0, 0.07), (radius * 0.75, deep * 4, 0.08), material=tinted(kit, (GREY, CONCRETE, WOOD, BLUE), (PLAIN, PLANKS)))
    kind, colours = rng.choice(["gondola", "capsule", "box"]), [tinted(kit, (RED, BLUE, YELLOW, GREEN, ORANGE, WHITE), gloss=0.4) for _ in range(int(rng.integers(1, 5)))]
    size = radius * np.pi / cabins * 0.42
    first = rng.uniform(0, 360 / cabins)
    for k, (x, z) in enumerate(around(cabins, radius, first)):
        skin, at = colours[k % len(colours)], np.array([x, 0, hub + z])
        if kind == "capsule":
            kit.add(BALL, at * [1, 1, 1] - [0, 0, size * 0.2], (size, deep * 0.95, size * 0.85), material=skin)
        elif kind == "box":
            kit.add(BOX, at - [0, 0, size * 0.7], (size * 0.75, deep * 0.85, size * 0.75), (0.9, 0.9), material=skin)
        else:
            kit.add(CYL, at - [0, 0, size * 1.1], (size * 0.6, size * 0.6, size * 0.4), (1.35, 1), material=skin)
            kit.add(CYL, at + [0, 0, size * 0.05], (size * 0.95, size * 0.95, size * 0.28), (0.1, 1), material=skin)
        if kind != "capsule" and cabins <= 12:
            kit.add(
                BOX,
                at - [0, 0, size * 0.45],
                (size * 0.12 if kind == "gondola" else size * 0.71, deep * 0.87 if kind == "box" else size * 0.12, size * (0.55 if kind == "gondola" else 0.25)),
                material=dark,
            )
    kit.add(BOX, (radius * 0.6, deep * 2.5, 0.35), (0.2, 0.2, 0.28), material=second)
    stairs(kit, (radius * 0.75 + 0.45, 0, 0.0), (radius * 0.72, 0, 0.15), 0.3, dark)


def ruin(kit):
    rng = kit.rng
    wall = tinted(kit, (BRICK, CONCRETE, WHITE, STONE, SAND), (BRICKS, STREAKS, CLOUDY, BRICKS), frequency=rng.uniform(12, 28), gloss=0.0)
    burnt, rubble = kit.material(dark=True, gloss=0.0), tinted(kit, (BRICK, CONCRETE, GREY, EARTH), (CLOUDY, BRICKS, PATCHWORK), gloss=0.0)
    long, wide, thick, levels = rng.uniform(1.3, 2.2), rng.uniform(1.0, 1.5), 0.09, int(rng.choice([1, 2, 2, 3, 3]))
    high = rng.uniform(0.85, 1.05)
    limit = {1: 4, 2: 3, 3: 3}[levels]

    def facade(place, spin, half, columns, tops):
        """A wall along local x: per level piers, sills and lintels around openings; `tops` [columns + 1] heights of the piers, in levels."""
        pitch = 2 * half / columns
        for k in range(columns + 1):
            x = -half + pitch * k
            top = max(tops[k], 0.35) * high
            kit.add(
                BOX,
                place + spin @ [x, 0, top / 2],
                (pitch * 0.24 if 0 < k < columns else pitch * 0.16, thick, top / 2),
                (rng.uniform(0.6, 1), 1),
                (rng.normal(0, 0.05), 0),
                spin,
                wall,
            )
        for level in range(levels):
            for k in range(columns):
                reached = min(tops[k], tops[k + 1])
                x = -half + pitch * (k + 0.5)
                if reached >= level + 0.3:
                    kit.add(BOX, place + spin @ [x, 0, high * (level + 0.15)], (pitch * 0.42, thick * 0.98, high * 0.16), rotation=spin, material=wall)
                if reached >= level + 0.9:
                    kit.add(BOX, place + spin @ [x, 0, high * (level + 0.89)], (pitch * 0.42, thick * 0.98, high * 0.12), rotation=spin, material=wall)

    columns = int(rng.integers(2, limit + 1))
    peak = float(levels)
    slope = rng.choice([-1, 1])

    def profile(count, keep):
        tops = peak - np.maximum(0, np.linspace(-0.3, 1, count)[::slope]) * rng.uniform(0.2, 1) * keep * levels
        return np.clip(tops - rng.uniform(0, 0.35, count), 0.35, peak)

    facade(np.array([0, wide, 0]), np.eye(3), long, columns, profile(columns + 1, 0.8))
    facade(np.array([0, -wide, 0]), np.eye(3), long, columns, profile(columns + 1, 1.0) * rng.uniform(0.4, 1))
    side = rng.uniform(0.5, 1.0)
    for x, keep in ((-long, 1.0), (long, side)):
        tall = peak * high * keep
        kit.add(BOX, (x, wide * 0.45, tall * 0.4), (thick, wide * 0.55, tall * 0.4), (1, rng.uniform(0.6, 1)), (0, rng.uniform(0, 0.2)), material=wall)
        kit.add(BOX, (x, -wide * 0.5, tall * 0.25), (thick, wide * 0.5, tall * 0.25), (1, rng.uniform(0.4, 0.9)), (0, -rng.uniform(0, 0.2)), material=wall)
    if kit.chance(0.5):
        x = -long
        kit.add(BOX, (x, 0, peak * high * 0.75), (thick * 0.95, wide * 0.7, peak * high * 0.3), (1, 0.05), (0, rng.uniform(-0.3, 0.3)), material=wall)
        kit.add(BOX, (x, wide * 0.3, peak * high * 0.85), (0.14, 0.14, peak * high * 0.3), material=wall)
    kit.add(BOX, (0, 0, 0.03), (long * 1.1, wide * 1.1, 0.04), material=rubble)
    for level in range(1, levels):
        kit.add(
            BOX,
            (-slope * long * 0.4, wide * 0.4, high * level),
            (long * 0.58, wide * 0.6, 0.05),
            rotation=turn("y", rng.normal(0, 2)),
            material=burnt if kit.chance(0.5) else wall,
        )
    for _ in range(int(rng.integers(3, 7))):
        size = rng.uniform(0.2, 0.55)
        tall, at = size * rng.uniform(0.2, 0.45), rng.uniform(-1, 1, 2) * (long, wide)
        kit.add(CYL, (*at, tall), (size, size * rng.uniform(0.6, 1), tall), (rng.uniform(0.1, 0.4), 1), material=rubble)
    for x in np.linspace(-0.7, 0.7, int(rng.integers(0, 4))):
        kit.between(
            (x * long, wide, peak * high * rng.uniform(0.5, 0.6)), (x * long + rng.uniform(-0.2, 0.2), -wide * rng.uniform(-0.2, 0.6), 0.15), 0.045, BOX, material=burnt
        )
