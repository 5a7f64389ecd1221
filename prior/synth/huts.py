"""Huts, chalets, tents and houses on stilts or in trees; and the small houses of animals: dovecotes, hives, kennels, hen houses, bird tables."""

import numpy as np

from .building_parts import flight, greens, lettered, posts, slab, timberwork, vivid
from .dwellings import (
    BLUE,
    CREAM,
    GREEN,
    GREY,
    OCHRE,
    SAND,
    SNOW,
    STONE,
    THATCH,
    TILE,
    TIMBER,
    WHITE,
    WOOD,
    YELLOW,
    boards,
    brickwork,
    chimney,
    door,
    leaf,
    leaves,
    lights,
    masonry,
    panes,
    roof,
    row,
    tiles,
    trim,
    walls_of,
)
from .installations import ladder, railed, stairs, steelwork, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, LEAVES, PRISM, RUNGS, TUBE
from .materials import BANDS, BRICKS, CHECKER, CLOUDY, DOTS, PLAIN, PLANKS, RIBS, SHINGLES, SPECKLES, STREAKS, STRIPES


def veranda_house(kit):
    rng = kit.rng
    wall, cover, frame, glass, base = walls_of(kit), tiles(kit), trim(kit), panes(kit), masonry(kit)
    x, y, high, deep, lift = rng.uniform(2.4, 3.2), rng.uniform(3, 4.2), rng.uniform(2.8, 3.2), rng.uniform(1.2, 1.7), rng.uniform(0.3, 0.8)
    slab(kit, 0, 0, 0, (x + deep, y + deep, lift / 2), base)
    slab(kit, 0, 0, lift, (x, y, high / 2 + 0.25), wall)
    eave = lift + high - 0.45
    kit.add(BOX, (0, 0, eave + 0.3), (x + deep + 0.3, y + deep + 0.3, 0.3), ((x + 0.1) / (x + deep + 0.3), (y + 0.1) / (y + deep + 0.3)), material=cover)
    top = lift + high + 0.45
    roof(kit, (0, 0, top - 0.25), (x, y), x * rng.uniform(0.5, 0.8), rng.choice(["hip", "gable"]), 0.2, cover, wall, 1)
    ys, xs = np.linspace(-y - deep + 0.15, y + deep - 0.15, 5), (-x - deep + 0.15, x + deep - 0.15)
    posts(kit, xs, ys, lift, eave, 0.08, frame, CYL if kit.chance(0.4) else BOX)
    posts(kit, (0,), (ys[0], ys[-1]), lift, eave, 0.08, frame)
    for start, end in (
        ((xs[1], ys[0]), (xs[1], -0.8)),
        ((xs[1], 0.8), (xs[1], ys[-1])),
        ((xs[0], ys[0]), (xs[0], ys[-1])),
        ((xs[0], ys[0]), (xs[1], ys[0])),
        ((xs[0], ys[-1]), (xs[1], ys[-1])),
    ):
        kit.railing((*start, lift), (*end, lift), 0.8, frame, 0.25, rng.choice([BARS, LATTICE]), 0.03)
    flight(kit, x + deep, 0, lift, 0.8, base, 3)
    door(kit, (x, 0, lift), (0.5, 1.05), leaf(kit), frame)
    lights(kit, (0, 0, lift + 1.35), (x, y), (-y * 0.55, y * 0.55), (0.5, 0.6), glass, frame, 0)
    lights(kit, (0, 0, lift + 1.35), (x, y), (-x * 0.45, x * 0.45), (0.4, 0.6), glass, frame, 1)
    chimney(kit, -x * 0.4, y * 0.5, top, top + x * 0.9)


def chalet(kit):
    rng = kit.rng
    stone, wood, cover, frame, glass, flowers = (
        tinted(kit, (WHITE, CREAM, STONE), (PLAIN, BRICKS, CLOUDY)),
        timberwork(kit),
        tiles(kit),
        trim(kit),
        panes(kit),
        vivid(kit, (SPECKLES, DOTS), frequency=30),
    )
    x, y, low, high = rng.uniform(3.2, 4.2), rng.uniform(3.2, 4.4), 2.6, rng.uniform(2.5, 4.8)
    eave, rise, over = low + high, y * rng.uniform(0.4, 0.6), rng.uniform(1.2, 1.7)
    slab(kit, 0, 0, 0, (x, y, low / 2), stone)
    slab(kit, 0, 0, low, (x + 0.05, y + 0.05, high / 2), wood)
    kit.add(BOX, (0, 0, eave + rise / 2), (x, y, rise / 2), (1, 0.02), material=wood)
    leaves(kit, (0, 0, eave), np.eye(3), x + over, (y + over, -over * rise / y), (0, rise), 0.13, cover)
    if kit.chance(0.3):
        leaves(kit, (0, 0, eave + 0.22), np.eye(3), x + over - 0.1, (y + over - 0.1, -over * rise / y), (0, rise), 0.1, tinted(kit, (SNOW,), (CLOUDY,)))
    kit.between((x + over - 0.1, y + over, eave - over * rise / y), (x + over - 0.1, 0, eave + rise), (0.16, 0.04), BOX, material=wood, mirror=True)
    floors = [low] if high < 3.4 else [low, low + 2.5]
    for z in floors:
        kit.add(BOX, (x + 0.55, 0, z + 0.05), (0.65, y + 0.05, 0.08), material=wood)
        kit.railing((x + 1.15, -y, z + 0.1), (x + 1.15, y, z + 0.1), 0.85, wood, 0.22)
        for side in (-y, y):
            kit.railing((x, side, z + 0.1), (x + 1.15, side, z + 0.1), 0.85, wood, 0.22)
        kit.add(BOX, (x + 1.2, 0, z + 1.0), (0.1, y * 0.85, 0.12), material=flowers)
        lights(kit, (0, 0, z + 1.2), (x + 0.05, y), row(3, y), (0.4, 0.65), glass, frame, 0, False)
        for py in (-y * 0.9, y * 0.9):
            kit.between((x, py, z - 0.7), (x + 1.0, py, z), 0.08, BOX, material=wood)
    lights(kit, (0, 0, low + 1.2), (x, y + 0.05), row(2, x), (0.45, 0.5), glass, frame, 1)
    door(kit, (x, 0, 0), (0.5, 1.0), leaf(kit), frame)
    lights(kit, (0, 0, 1.4), (x, y), (-y * 0.55, y * 0.55), (0.4, 0.45), glass, frame, 0, False)
    kit.add(BOX, (x + 0.03, 0, eave + rise * 0.35), (0.05, 0.4, 0.45), material=glass)
    chimney(kit, -x * 0.3, y * 0.4, eave, eave + rise + 0.8, stone)


def stilt_house(kit):
    rng = kit.rng
    wall, cover, frame, glass = (
        tinted(kit, (WOOD, OCHRE, THATCH, BLUE, GREEN, GREY), (PLANKS, RIBS, BANDS), frequency=18),
        tinted(kit, (THATCH, GREY, TILE, TIMBER), (SHINGLES, STREAKS, RIBS), frequency=16),
        timberwork(kit),
        panes(kit),
    )
    x, y, lift, high = rng.uniform(1.8, 2.4), rng.uniform(2.0, 2.8), rng.uniform(1.8, 3.0), rng.uniform(2.0, 2.4)
    out = rng.uniform(1.0, 1.5)
    posts(kit, (-x, 0, x + out * 0.9), np.linspace(-y, y, 3), 0, lift, 0.11, frame, CYL)
    kit.between((x, -y, lift * 0.15), (x, y, lift * 0.9), 0.05, BOX, material=frame)
    kit.between((-x, y, lift * 0.15), (x, y, lift * 0.9), 0.05, BOX, material=frame, mirror=True)
    kit.add(BOX, (out / 2, 0, lift + 0.06), (x + out / 2 + 0.15, y + 0.15, 0.09), material=frame)
    slab(kit, 0, 0, lift, (x, y, high / 2), wall)
    rise = y * rng.uniform(0.7, 1.2)
    roof(kit, (out / 2, 0, lift + high), (x + out / 2, y), rise, rng.choice(["gable", "gable", "hip"]), 0.45, cover, wall)
    posts(kit, (x + out - 0.1,), (-y + 0.1, 0.7, y - 0.1), lift, lift + high, 0.07, frame)
    kit.railing((x + out, 0.7, lift + 0.1), (x + out, y, lift + 0.1), 0.8, frame, 0.25)
    for side in (-y, y):
        kit.railing((x, side, lift + 0.1), (x + out, side, lift + 0.1), 0.8, frame, 0.25)
    stairs(kit, (x + out + lift * 0.8, -y * 0.4, 0), (x + out, -y * 0.4, lift), 0.45, frame)
    kit.railing((x + out, -y, lift + 0.1), (x + out, -y * 0.75, lift + 0.1), 0.8, frame, 0.25)
    door(kit, (x, -y * 0.4, lift + 0.1), (0.4, 0.85), leaf(kit), trim(kit))
    lights(kit, (0, 0, lift + high * 0.55), (x, y), [y * 0.45], (0.4, 0.4), glass, frame, 0)
    lights(kit, (0, 0, lift + high * 0.55), (x, y), row(2, x), (0.35, 0.4), glass, frame, 1)
    kit.add(BALL, (0, 0, 0.35), (1.4, 0.4, 0.3), material=vivid(kit))
    kit.add(BOX, (0, 0, 0.15), (0.8, 0.35, 0.12), material=frame)


def tree_house(kit):
    rng = kit.rng
    bark, wood, cover, green = tinted(kit, (TIMBER, WOOD, GREY), (STREAKS, CLOUDY), frequency=20, gloss=0.0), timberwork(kit), tiles(kit), greens(kit)
    lift, x, y, high = rng.uniform(2.2, 3.4), rng.uniform(1.1, 1.5), rng.uniform(1.1, 1.6), rng.uniform(1.6, 1.9)
    trunk = np.array([-x * 1.0, 0, 0])
    kit.loft(trunk, [(0, 0.75), (0.4, 0.45), (lift, 0.38), (lift + high + 1, 0.3)], bark)
    for side, out, up in ((1, 1.6, 1.6), (-1, 1.8, 1.3), (0, 1.5, 2.0)):
        tip = trunk + [(-1.0 if side else 1.4), side * out, lift + high + up]
        kit.between(trunk + [0, 0, lift + high * 0.5 + 0.4], tip, 0.17, CYL, 0.5, material=bark)
        size = rng.uniform(1.2, 1.7)
        kit.add(BALL, tip + [0, 0, 0.6], (size, size, size * 0.75), material=green, cut=(LEAVES, rng.uniform(4, 8), rng.uniform(0.6, 0.85)))
    kit.add(BALL, trunk + [0, 0, lift + high + 2.3], (1.6, 1.6, 1.2), material=green, cut=(LEAVES, 5, 0.7))
    kit.add(BOX, (0.4, 0, lift), (x + 0.85, y + 0.3, 0.07), material=wood)
    for side in (-1, 1):
        kit.between(trunk + [0, 0, lift * 0.4], (x + 0.6, side * y, lift - 0.05), 0.09, BOX, material=bark)
        kit.add(BOX, (0, side * y, lift + high / 2), (x, 0.05, high / 2), material=wood, cut=(BARS, 0.9, 0.55))
        kit.add(BOX, (0, side * y, lift + high * 0.22), (x, 0.05, high * 0.22), material=wood)
    kit.add(BOX, (-x + 0.4, 0, lift + high / 2), (0.05, y, high / 2), material=wood)
    kit.add(BOX, (x, -y * 0.6, lift + high / 2), (0.05, y * 0.4, high / 2), material=wood)
    kit.add(BOX, (x, y * 0.8, lift + high / 2), (0.05, y * 0.2, high / 2), material=wood)
    kit.add(BOX, (x, 0.2 * y, lift + high * 0.92), (0.05, y * 0.8, high * 0.1), material=wood)
    roof(kit, (0.1, 0, lift + high), (x, y), rng.uniform(0.6, 1.0), rng.choice(["gable", "shed", "hip"]), 0.3, cover, wood)
    railed(kit, 0.6, 0, lift + 0.07, x + 0.6, y + 0.26, 0.65, wood)
    ladder(kit, (x + 1.9, y * 0.25, 0), (x + 1.25, y * 0.25, lift + 0.6), 0.28, wood)
    for side in (-0.28, 0.28):
        kit.between((x + 1.9, y * 0.25 + side, 0), (x + 1.25, y * 0.25 + side, lift + 0.6), 0.045, material=wood)
    kit.between((0.8, -y - 0.2, lift), (0.8, -y - 0.2, 0.5), 0.03, material=wood)
    kit.add(CYL, (0.8, -y - 0.2, 0.35), (0.35, 0.35, 0.1), rotation=ALONG_X, material=kit.material(dark=True))


def garden_house(kit):
    rng = kit.rng
    wall, cover, frame, glass, wood = boards(kit), tiles(kit), trim(kit), panes(kit), timberwork(kit)
    x, y, high, porch = rng.uniform(1.1, 1.6), rng.uniform(1.2, 1.8), rng.uniform(1.9, 2.2), rng.choice([0.0, 0.8, 1.1])
    slab(kit, porch / 2, 0, 0, (x + porch / 2 + 0.1, y + 0.1, 0.07), wood)
    slab(kit, 0, 0, 0.14, (x, y, high / 2), wall)
    eave, axis = 0.14 + high, int(rng.integers(2)) if not porch else 0
    roof(kit, (porch / 2, 0, eave), (x + porch / 2, y), rng.uniform(0.5, 1.1), rng.choice(["gable", "gable", "hip", "shed"]), 0.25, cover, wall, axis)
    for px in (-x, x):
        posts(kit, (px,), (-y, y), 0.1, eave, 0.07, frame)
    if porch:
        posts(kit, (x + porch - 0.06,), (-y + 0.06, y - 0.06), 0.1, eave, 0.05, frame)
        kit.railing((x + porch, 0.5, 0.14), (x + porch, y, 0.14), 0.7, frame, 0.15, rng.choice([BARS, LATTICE]))
        kit.railing((x + porch, -y, 0.14), (x + porch, -0.5, 0.14), 0.7, frame, 0.15)
        for side in (-y, y):
            kit.railing((x, side, 0.14), (x + porch, side, 0.14), 0.7, frame, 0.15)
    at = 0.0 if y > 1.5 or kit.chance(0.5) else -y * 0.4
    for py in (at - 0.3, at + 0.3) if kit.chance(0.5) else (at,):
        door(kit, (x, py, 0.14), (0.28, 0.85), leaf(kit), frame)
        kit.add(BOX, (x + 0.1, py, 1.3), (0.02, 0.19, 0.32), material=glass)
    lights(kit, (0, 0, 1.3), (x, y), [y * 0.68, -y * 0.68] if at == 0 else [y * 0.45], (0.2 if at == 0 else 0.35, 0.32), glass, frame, 0)
    lights(kit, (0, 0, 1.3), (x, y), [0], (0.35, 0.32), glass, frame, 1)
    for side in (-1, 1):
        slab(kit, x + 0.15, side * y * 0.68, 0.75, (0.12, 0.25, 0.09), wood)
        kit.add(BALL, (x + 0.15, side * y * 0.68, 0.96), (0.15, 0.27, 0.12), material=vivid(kit, (SPECKLES,), frequency=30))


def play_house(kit):
    rng = kit.rng
    wall, cover, frame, accent, glass = boards(kit), vivid(kit, (SHINGLES, PLAIN, RIBS), frequency=12), trim(kit), vivid(kit), kit.material(dark=True)
    x, y, high, lift = rng.uniform(0.6, 0.8), rng.uniform(0.6, 0.85), rng.uniform(1.1, 1.3), rng.choice([0.1, 0.6, 1.0, 1.3])
    deep = rng.uniform(0.45, 0.65)
    posts(kit, (-x, x, x + deep), (-y, y), 0, lift, 0.06, frame)
    kit.add(BOX, (deep / 2, 0, lift), (x + deep / 2 + 0.05, y + 0.05, 0.05), material=frame)
    kit.add(BOX, (-x, 0, lift + high / 2), (0.03, y, high / 2), material=wall)
    for side in (-1, 1):
        kit.add(BOX, (0, side * y, lift + high * 0.25), (x, 0.03, high * 0.25), material=wall)
        kit.add(BOX, (0, side * y, lift + high * 0.92), (x, 0.03, high * 0.09), material=wall)
        for px in (-x * 0.72, x * 0.72):
            kit.add(BOX, (px, side * y, lift + high / 2), (x * 0.28, 0.03, high / 2), material=wall)
        kit.add(BOX, (0, side * (y + 0.02), lift + high * 0.66), (x * 0.48, 0.03, high * 0.2), material=frame, cut=(GRID, 1.0 / (x * 0.48), 0.12))
        kit.add(BOX, (x, side * y * 0.7, lift + high / 2), (0.03, y * 0.32, high / 2), material=wall)
        kit.add(BOX, (x + 0.02, side * y * 0.7, lift + high * 0.62), (0.03, y * 0.18, high * 0.16), material=glass)
        kit.add(BOX, (0, side * (y + 0.1), lift + high * 0.44), (x * 0.5, 0.09, 0.06), material=accent)
    kit.add(BOX, (x, 0, lift + high * 0.93), (0.03, y, high * 0.08), material=wall)
    roof(kit, (deep / 2, 0, lift + high), (x + deep / 2, y), rng.uniform(0.5, 0.8), rng.choice(["gable", "gable", "shed"]), 0.15, cover, wall)
    posts(kit, (x + deep,), (-y, y), lift, lift + high, 0.045, frame)
    kit.railing((x + deep, 0.28, lift + 0.05), (x + deep, y, lift + 0.05), 0.4, accent, 0.12)
    for side in (-y, y):
        kit.railing((x, side, lift + 0.05), (x + deep, side, lift + 0.05), 0.4, accent, 0.12)
    if lift > 0.3:
        run, end = lift * 1.4, np.array([x + deep + lift * 1.5, -y * 0.35, 0.12])
        kit.between((x + deep, -y * 0.35, lift), end, (0.025, 0.26), BOX, material=accent)
        for side in (-0.27, 0.27):
            kit.between((x + deep, -y * 0.35 + side, lift + 0.08), end + [0, side, 0.08], (0.09, 0.025), BOX, material=accent)
        kit.add(BOX, end + [0.18, 0, -0.03], (0.22, 0.27, 0.03), material=accent)
        slab(kit, end[0] + 0.1, end[1], 0, (0.05, 0.2, 0.06), frame)
        ladder(kit, (x + deep + run * 0.35, y * 0.15 + 0.08, 0), (x + deep, y * 0.15 + 0.08, lift), 0.2, frame)
    else:
        for start, stop in (
            ((x + deep + 0.8, -y - 0.4), (x + deep + 0.8, -0.25)),
            ((x + deep + 0.8, 0.25), (x + deep + 0.8, y + 0.4)),
            ((x, y + 0.4), (x + deep + 0.8, y + 0.4)),
            ((x, -y - 0.4), (x + deep + 0.8, -y - 0.4)),
        ):
            kit.railing((*start, 0), (*stop, 0), 0.45, frame, 0.14)
        kit.add(BOX, (x, 0, lift + high * 0.35), (0.02, y * 0.36, high * 0.33), material=accent)
    if kit.chance(0.4):
        slab(kit, -x * 0.3, y * 0.4, lift + high, (0.1, 0.1, 0.5), brickwork(kit))


def beach_hut(kit):
    rng = kit.rng
    count = int(rng.integers(1, 4))
    x, y, high, lift = rng.uniform(1.1, 1.5), rng.uniform(0.85, 1.05), rng.uniform(1.9, 2.3), rng.choice([0.15, 0.4, 0.8])
    frame = tinted(kit, (WHITE,))
    for k in range(count):
        at, second = (k - (count - 1) / 2) * (2 * y + 0.45), vivid(kit)
        wall, cover = vivid(kit, (STRIPES, PLANKS, PLAIN), frequency=rng.uniform(8, 14), second=(0.75, 0.74, 0.7)), tiles(kit)
        posts(kit, (-x, x + 0.6), (at - y * 0.9, at + y * 0.9), 0, lift, 0.08, timberwork(kit))
        kit.add(BOX, (0.35, at, lift), (x + 0.4, y + 0.05, 0.06), material=frame)
        slab(kit, 0, at, lift, (x, y, high / 2), wall)
        roof(kit, (0.2, at, lift + high), (x + 0.15, y), y * rng.uniform(0.7, 1.1), "gable", 0.15, cover, wall)
        for side in (-0.25, 0.25):
            kit.add(BOX, (x + 0.03, at + side, lift + 0.9), (0.04, 0.235, 0.82), material=second)
        kit.add(BOX, (x + 0.05, at, lift + 1.75), (0.04, 0.6, 0.05), material=frame)
        kit.add(BOX, (x + 0.36, at, lift + high + y * 0.45), (0.02, 0.16, 0.16), material=frame)
        for step in range(2 if lift > 0.3 else 0):
            slab(kit, x + 0.85 + 0.25 * step, at, 0, (0.13, 0.4, lift * (0.35 - 0.16 * step)), frame)
    if count == 1:
        posts(kit, (x + 0.65,), (-y, y), lift, lift + 0.8, 0.04, frame)
        for side in (-y, y):
            kit.railing((x, side, lift), (x + 0.65, side, lift), 0.8, frame, 0.2)
        lights(kit, (0, 0, lift + 1.2), (x, y), [0], (0.3, 0.3), panes(kit), frame, 1)


def log_cabin(kit):
    rng = kit.rng
    logs, cover, frame, glass, stone = tinted(kit, (WOOD, OCHRE, TIMBER, GREY), (STREAKS, PLAIN), frequency=15, gloss=0.02), tiles(kit), trim(kit), panes(kit), masonry(kit)
    x, y, r, count = rng.uniform(1.9, 2.5), rng.uniform(2.2, 3.0), 0.17, 7
    high, porch = count * 2 * r, rng.choice([0.0, 1.2])
    slab(kit, 0, 0, 0, (x - 0.05, y - 0.05, high / 2), logs)
    for k in range(count):
        z = r + 2 * r * k
        for side in (-1, 1):
            kit.add(CYL, (0, side * y, z), (r, r, x + 0.35), rotation=ALONG_X, material=logs)
            if k < count - 1:
                kit.add(CYL, (side * x, 0, z + r), (r, r, y + 0.35), rotation=ALONG_Y, material=logs)
    rise = y * rng.uniform(0.45, 0.75)
    roof(kit, (porch / 2, 0, high), (x + porch / 2, y), rise, "gable", 0.45, cover, logs)
    if porch:
        slab(kit, x + porch / 2, 0, 0, (porch / 2 + 0.1, y, 0.12), logs)
        posts(kit, (x + porch - 0.1,), (-y + 0.1, -0.7, 0.7, y - 0.1), 0.1, high, 0.1, logs, CYL)
        kit.railing((x + porch, 0.7, 0.2), (x + porch, y, 0.2), 0.7, logs, 0.3)
        kit.railing((x + porch, -y, 0.2), (x + porch, -0.7, 0.2), 0.7, logs, 0.3)
    door(kit, (x + r * 0.9, 0, 0.05), (0.42, 0.95), leaf(kit), frame)
    lights(kit, (0, 0, 1.3), (x + r, y), (-y * 0.58, y * 0.58), (0.38, 0.38), glass, frame, 0)
    lights(kit, (0, 0, 1.3), (x, y + r), [x * 0.3], (0.38, 0.38), glass, frame, 1)
    slab(kit, -x * 0.4, y + 0.45, 0, (0.55, 0.4, high * 0.45), stone)
    slab(kit, -x * 0.4, y + 0.4, 0, (0.32, 0.32, (high + rise + 0.7) / 2), stone)


def yurt(kit):
    rng = kit.rng
    felt, band, wood, door_skin = (
        tinted(kit, (WHITE, CREAM, GREY, SAND), (PLAIN, CLOUDY, STREAKS)),
        vivid(kit, (CHECKER, DOTS, BANDS), frequency=14),
        timberwork(kit),
        vivid(kit),
    )
    r, high, rise = rng.uniform(2.2, 3.0), rng.uniform(1.5, 1.8), rng.uniform(0.8, 1.3)
    kit.add(PRISM, (0, 0, 0.1), (r + 0.5, r + 0.5, 0.1), (1, 12), material=wood)
    kit.add(CYL, (0, 0, 0.15 + high / 2), (r, r, high / 2), material=felt)
    for z in (0.35, high * 0.55, high):
        kit.add(CYL, (0, 0, 0.15 + z), (r + 0.03, r + 0.03, 0.06), material=band if z == high else wood)
    kit.loft((0, 0, 0.15 + high), [(0, r + 0.12), (rise * 0.85, r * 0.3), (rise, r * 0.2)], felt)
    kit.add(CYL, (0, 0, 0.15 + high + rise), (r * 0.2, r * 0.2, 0.1), material=wood)
    kit.add(BALL, (0, 0, 0.25 + high + rise), (r * 0.18, r * 0.18, 0.15), material=panes(kit))
    kit.between((-r * 0.4, r * 0.3, high), (-r * 0.4, r * 0.3, high + rise + 0.8), 0.08, material=kit.material(dark=True))
    for px, py in around(12, r + 0.1, 15):
        kit.between((px, py, 0.15 + high), (px * 0.25, py * 0.25, 0.2 + high + rise * 0.92), 0.025, material=band)
        kit.between((px, py, 0.15), (px, py, 0.15 + high), 0.02, material=wood)
    door(kit, (r * 0.98, 0, 0.2), (0.42, 0.78), door_skin, wood)
    kit.add(BOX, (r + 0.08, 0, 1.0), (0.02, 0.25, 0.45), material=band)
    slab(kit, r + 0.7, 0, 0, (0.35, 0.6, 0.06), wood)


def tipi(kit):
    rng = kit.rng
    hide, second, wood = tinted(kit, (CREAM, WHITE, SAND, OCHRE), (PLAIN, CLOUDY, STREAKS)), vivid(kit, (BANDS, CHECKER, DOTS, PLAIN), frequency=9), timberwork(kit)
    r, tall, count = rng.uniform(1.5, 2.1), rng.uniform(3.4, 4.4), int(rng.integers(9, 13))
    low, mid = tall * 0.22, tall * rng.uniform(0.6, 0.75)

    def wide(z):
        return r * (1 - z / tall) + 0.06

    kit.loft((0, 0, 0), [(0, wide(0)), (low, wide(low))], second, PRISM, sides=count)
    kit.loft((0, 0, 0), [(low, wide(low)), (mid, wide(mid))], hide, PRISM, sides=count)
    kit.loft((0, 0, 0), [(mid, wide(mid)), (tall * 0.95, wide(tall * 0.95))], second if kit.chance(0.6) else hide, PRISM, sides=count)
    for px, py in around(count, 1):
        kit.between((px * r, py * r, 0), (-px * r * 0.28, -py * r * 0.28, tall * 1.28), 0.035, CYL, 0.7, material=wood)
    slope = np.degrees(np.arctan2(r, tall))
    lean = turn("y", -slope)
    dark = kit.material(dark=True)
    kit.add(BOX, (wide(0.75) * 0.99, 0, 0.75), (0.04, 0.42, 0.78), (1, 0.15), rotation=lean, material=dark)
    kit.add(BOX, (wide(0.75) + 0.08, 0.42, 0.7), (0.03, 0.22, 0.7), (1, 0.4), rotation=lean @ turn("z", 30), material=hide)
    for k in range(5):
        z = tall * (0.48 + 0.08 * k)
        kit.between((wide(z), -0.15, z), (wide(z), 0.15, z), 0.025, material=wood)
    for side in (-1, 1):
        kit.add(BOX, (wide(tall * 0.9) + 0.2, side * 0.28, tall * 0.92), (0.03, 0.22, 0.45), (1, 1.4), rotation=turn("z", side * 35), material=hide)
        kit.between((r * 0.7, side * r * 1.1, 0), (wide(tall * 0.9) + 0.2, side * 0.4, tall * 1.05), 0.03, material=wood)
    for px, py in around(count, r + 0.12, 15):
        kit.between((px, py, 0), (px * 0.93, py * 0.93, 0.3), 0.035, material=wood)


def igloo(kit):
    rng = kit.rng
    snow, dark = (
        tinted(kit, (SNOW, SNOW, (0.6, 0.7, 0.8)), (BRICKS,), frequency=rng.uniform(6, 10), second=(0.4, 0.5, 0.62), gloss=0.1),
        kit.material(base=(0.03, 0.05, 0.08), pattern=PLAIN),
    )
    r, squash, levels = rng.uniform(1.5, 2.0), rng.uniform(0.78, 1.0), 7
    for k in range(levels):
        a, b = np.pi / 2 * k / levels, np.pi / 2 * (k + 1) / levels
        low, top = r * np.cos(a), max(r * np.cos(b), 0.12)
        kit.add(
            PRISM,
            (0, 0, r * squash * (np.sin(a) + np.sin(b)) / 2),
            (low, low, r * squash * (np.sin(b) - np.sin(a)) / 2),
            (top / low, 16),
            rotation=turn("z", 11 * (k % 2)),
            material=snow,
        )
    for k in range(3):
        x, tall = r * 0.85 + 0.42 * k, 0.72 - 0.04 * k
        for start, end in ((15, 55), (55, 90), (90, 125), (125, 165)):
            a, b = np.radians(start), np.radians(end)
            kit.between((x, tall * np.cos(a), tall * np.sin(a)), (x, tall * np.cos(b), tall * np.sin(b)), (0.15, 0.24), BOX, material=snow)
        kit.add(BOX, (x, tall * 0.95, 0.13), (0.22, 0.15, 0.14), material=snow, mirror=True)
    kit.add(CYL, (r * 0.95, 0, 0), (0.6, 0.6, 0.12), rotation=ALONG_X, material=dark)
    for k in range(int(rng.integers(2, 6))):
        slab(kit, r * 0.6 + 0.3 * k, -r * 1.25 + 0.1 * (k % 2), 0, (0.25, 0.3, 0.17), snow, rotation=turn("z", rng.uniform(-30, 30)))
    if kit.chance(0.5):
        kit.between((r * 0.5, r * 1.15, 0), (r * 0.3, r * 1.0, 1.7), (0.02, 0.07), BOX, material=vivid(kit))


def wigwam(kit):
    rng = kit.rng
    bark, wood, dark = (
        tinted(kit, (WOOD, THATCH, GREY, TIMBER), (SHINGLES, STREAKS, BANDS), frequency=rng.uniform(10, 18), gloss=0.0),
        timberwork(kit),
        kit.material(dark=True),
    )
    r, high, long = rng.uniform(1.4, 1.8), rng.uniform(1.7, 2.1), rng.choice([0.0, 0.0, 1.6])
    profile = [(0, 1.0), (0.45, 0.96), (0.7, 0.8), (0.88, 0.55), (1.0, 0.2)]
    for end in (-long, long) if long else (0,):
        kit.loft((end, 0, 0), [(h * high, w * r) for h, w in profile], bark)
    if long:
        for (h0, w0), (h1, w1) in zip(profile[:-1], profile[1:], strict=True):
            kit.add(BOX, (0, 0, high * (h0 + h1) / 2), (long, r * w0, high * (h1 - h0) / 2), (1, w1 / w0), material=bark)
    for share in (0.3, 0.6):
        wide = r * (0.99 if share < 0.5 else 0.9) + 0.02
        for end in (-long, long) if long else (0,):
            kit.add(CYL, (end, 0, high * share), (wide, wide, 0.035), material=wood)
        if long:
            kit.add(BOX, (0, 0, high * share), (long, wide, 0.035), material=wood)
    for end in np.linspace(-long, long, 5 if long else 1):
        for axis in (turn("z", 90), turn("z", 45), turn("z", 135)) if not long else (turn("z", 90),):
            points = [axis @ np.array([s * w * (r + 0.03), 0, h * (high + 0.02)]) + [end, 0, 0] for s, seq in ((1, profile), (-1, profile[::-1])) for h, w in seq]
            for start, stop in zip(points[:-1], points[1:], strict=True):
                if len(kit.primitives) < 58:
                    kit.between(start, stop, 0.03, material=wood)
    front = long + r
    kit.add(BOX, (front - 0.06, 0, 0.6), (0.12, 0.4, 0.6), material=dark)
    kit.add(BOX, (front + 0.02, 0.5, 0.62), (0.08, 0.1, 0.64), material=wood, mirror=True)
    kit.add(BOX, (front + 0.02, 0, 1.25), (0.1, 0.6, 0.07), material=wood)
    kit.add(CYL, (0, 0, high), (0.3, 0.3, 0.05), material=dark)


def dovecote(kit):
    rng = kit.rng
    wall, cover, wood, dark = tinted(kit, (WHITE, CREAM, WOOD, STONE), (PLAIN, PLANKS, BRICKS), frequency=12), tiles(kit), timberwork(kit), kit.material(dark=True)
    sides, r, on_post = int(rng.choice([6, 8])), rng.uniform(0.5, 0.65), kit.chance(0.6)
    flat, lift = r * np.cos(np.pi / sides), rng.uniform(1.6, 2.2)
    tall = rng.uniform(0.9, 1.2)
    if on_post:
        slab(kit, 0, 0, 0, (0.1, 0.1, lift / 2), wood)
        for px, py in around(4, 1):
            kit.between((px * 0.05, py * 0.05, lift - 0.5), (px * r * 0.8, py * r * 0.8, lift), 0.05, BOX, material=wood)
            kit.between((px * 0.5, py * 0.5, 0.05), (px * 0.05, py * 0.05, 0.5), 0.05, BOX, material=wood)
    else:
        kit.add(PRISM, (0, 0, lift / 2), (r * 1.1, r * 1.1, lift / 2), (0.92, sides), material=masonry(kit))
        spin = turn("z", 180 / sides)
        kit.add(BOX, spin @ np.array([flat, 0, 0.6]), (0.12, r * 0.35, 0.6), rotation=spin, material=wood)
    kit.add(PRISM, (0, 0, lift + tall / 2), (r, r, tall / 2), (1, sides), material=wall)
    for z in (0.0, 0.5):
        kit.add(PRISM, (0, 0, lift + tall * z), (r + 0.17, r + 0.17, 0.03), (1, sides), material=wood)
        for k in range(sides):
            spin = turn("z", 360 / sides * (k + 0.5))
            kit.add(BOX, spin @ np.array([flat, 0, lift + tall * (z + 0.15)]), (0.012, 0.09, 0.11), rotation=spin, material=dark)
            kit.add(CYL, spin @ np.array([flat, 0, lift + tall * (z + 0.15) + 0.1]), (0.09, 0.09, 0.012), rotation=spin @ ALONG_X, material=dark)
    kit.add(PRISM, (0, 0, lift + tall + 0.3), (r + 0.25, r + 0.25, 0.3), (0.25, sides), material=cover)
    kit.add(PRISM, (0, 0, lift + tall + 0.72), (r * 0.24, r * 0.24, 0.14), (1, sides), material=wall)
    kit.add(PRISM, (0, 0, lift + tall + 0.98), (r * 0.38, r * 0.38, 0.14), (0.05, sides), material=cover)
    for k in range(3):
        spin = turn("z", 120 * k + 20)
        kit.add(BALL, spin @ np.array([r + 0.08, 0, lift + 0.13]), (0.11, 0.06, 0.07), rotation=spin, material=tinted(kit, (WHITE, GREY)))
        kit.add(BALL, spin @ np.array([r + 0.18, 0, lift + 0.21]), (0.04, 0.04, 0.04), material=tinted(kit, (WHITE, GREY)))


def beehives(kit):
    rng = kit.rng
    wood, dark, metal, count = timberwork(kit), kit.material(dark=True), tinted(kit, (GREY, WHITE)), int(rng.integers(1, 4))
    kind = rng.choice(["box", "skep", "slatted"])
    slab(kit, 0, 0, 0.28, (0.4, 0.55 * count, 0.05), wood)
    posts(kit, (-0.28, 0.28), np.linspace(-0.5 * count, 0.5 * count, count + 1), 0, 0.3, 0.06, wood)
    for y in row(count, 0.58 * count, 1):
        paint = vivid(kit, (PLAIN, PLANKS), frequency=8) if kit.chance(0.6) else tinted(kit, (WHITE, CREAM, WOOD))
        z = 0.38
        if kind == "skep":
            straw = tinted(kit, (OCHRE, THATCH), (BANDS,), frequency=rng.uniform(18, 30), gloss=0.0)
            for k in range(6):
                wide = 0.4 * np.sqrt(max(1 - (k / 6.2) ** 2, 0.02))
                kit.add(CYL, (0, y, z + 0.055 + 0.1 * k), (wide, wide, 0.055), (0.95, 1), material=straw)
                kit.add(TUBE, (0, y, z + 0.055 + 0.1 * k), (wide + 0.02, wide + 0.02, 0.02), material=straw)
            kit.add(BOX, (0.37, y, z + 0.07), (0.06, 0.09, 0.06), material=dark)
            kit.add(BALL, (0, y, z + 0.63), (0.07, 0.07, 0.07), material=straw)
            continue
        boxes = int(rng.integers(2, 5))
        kit.add(BOX, (0.06, y, z + 0.04), (0.44, 0.36, 0.04), material=wood)
        for k in range(boxes):
            high = 0.13 if k == 0 or kit.chance(0.6) else 0.09
            kit.add(
                BOX,
                (0, y, z + 0.08 + high),
                (0.36, 0.34, high),
                (1.08, 1.08) if kind == "slatted" else (1, 1),
                material=paint if k % 2 == 0 or kind == "slatted" else paint._replace(first=paint.second),
            )
            kit.add(BOX, (0, y, z + 0.08 + high * 1.3), (0.375, 0.08, 0.02), material=dark)
            z += 2 * high
        kit.add(BOX, (0.36, y, 0.5), (0.015, 0.2, 0.025), material=dark)
        kit.add(BOX, (0, y, z + 0.12), (0.4, 0.38, 0.05), material=metal)
        if kind == "slatted":
            roof(kit, (0, y, z + 0.16), (0.36, 0.33), 0.2, "gable", 0.06, metal, paint)
        else:
            slab(kit, 0, y, z + 0.17, (0.12, 0.08, 0.05), brickwork(kit))


def kennel(kit):
    rng = kit.rng
    wall, cover, frame, dark, coat = (
        boards(kit),
        tiles(kit),
        trim(kit),
        kit.material(dark=True),
        tinted(kit, (WOOD, TIMBER, CREAM, OCHRE, WHITE, (0.1, 0.08, 0.07)), (PLAIN, CLOUDY)),
    )
    x, y, high = rng.uniform(0.5, 0.7), rng.uniform(0.36, 0.46), rng.uniform(0.55, 0.7)
    slab(kit, 0, 0, 0, (x + 0.04, y + 0.04, 0.05), frame)
    kit.add(BOX, (0, y, 0.1 + high / 2), (x, 0.025, high / 2), material=wall, mirror=True)
    kit.add(BOX, (-x, 0, 0.1 + high / 2), (0.025, y, high / 2), material=wall)
    kit.add(BOX, (x, y * 0.8, 0.1 + high / 2), (0.025, y * 0.22, high / 2), material=wall, mirror=True)
    rise = y * rng.uniform(0.7, 1.1)
    for end in (-1, 1):
        kit.add(BOX, (end * x, 0, 0.1 + high + rise / 2), (0.025, y, rise / 2), (1, 0.02), material=wall)
    kit.add(BOX, (x, 0, 0.1 + high - 0.05), (0.027, y * 0.62, 0.06), material=wall)
    for side in (-1, 1):
        kit.add(BOX, (x + 0.02, side * y * 0.6, 0.1 + high * 0.45), (0.02, 0.03, high * 0.45), material=frame)
    kit.add(BOX, (x + 0.02, 0, 0.1 + high * 0.92), (0.02, y * 0.66, 0.03), material=frame)
    leaves(kit, (0.05, 0, 0.1 + high), np.eye(3), x + 0.14, (y + 0.12, -0.12 * rise / y), (0, rise), 0.025, cover)
    kit.add(BOX, (x + 0.05, 0, 0.1 + high + rise * 0.35), (0.015, y * 0.4, 0.06), material=lettered(kit))
    if kit.chance(0.7):
        kit.add(BALL, (x - 0.1, 0, 0.3), (0.35, 0.16, 0.2), material=coat)
        kit.add(BALL, (x + 0.17, 0, 0.5), (0.15, 0.13, 0.13), material=coat)
        kit.add(CYL, (x + 0.32, 0, 0.46), (0.065, 0.075, 0.09), (0.8, 1), rotation=ALONG_X, material=coat)
        kit.add(BALL, (x + 0.42, 0, 0.48), (0.03, 0.035, 0.03), material=dark)
        kit.add(BALL, (x + 0.12, 0.13, 0.48), (0.06, 0.03, 0.12), material=tinted(kit, (TIMBER, WOOD)), mirror=True)
        kit.add(BALL, (x + 0.28, 0.06, 0.55), (0.02, 0.02, 0.02), material=dark, mirror=True)
        kit.chain([(x + 0.02, 0.11, 0.3), (x + 0.12, 0.1, 0.06), (x + 0.22, 0.1, 0.04)], [0.06, 0.045, 0.05], coat, mirror=True)
        kit.add(TUBE, (x + 0.08, 0, 0.41), (0.12, 0.12, 0.03), material=vivid(kit))
    slab(kit, x + 0.12, 0, 0, (0.22, y * 0.8, 0.025), frame)
    kit.add(CYL, (x + 0.55, -y * 0.9, 0.05), (0.15, 0.15, 0.05), (0.8, 1), material=vivid(kit))
    slab(kit, x + 0.4, -y * 0.9, 0, (0.2, 0.2, 0.008), frame)
    if kit.chance(0.3):
        for start, end in (
            ((-x, -y - 0.5), (x + 1.1, -y - 0.5)),
            ((-x, y + 0.5), (x + 1.1, y + 0.5)),
            ((x + 1.1, -y - 0.5), (x + 1.1, y + 0.5)),
            ((-x, -y - 0.5), (-x, y + 0.5)),
        ):
            kit.railing((*start, 0), (*end, 0), 1.0, steelwork(kit), 0.12)


def hen_house(kit):
    rng = kit.rng
    wall, cover, frame, dark, mesh = boards(kit), tiles(kit), timberwork(kit), kit.material(dark=True), tinted(kit, (GREY, TIMBER))
    x, y, lift, high = rng.uniform(0.5, 0.65), rng.uniform(0.6, 0.9), rng.uniform(0.5, 0.8), rng.uniform(0.6, 0.8)
    run = rng.uniform(1.2, 1.8)
    posts(kit, (-x, x), (-y, y), 0, lift + high, 0.05, frame)
    slab(kit, 0, 0, lift, (x, y, high / 2), wall)
    roof(kit, (0, 0, lift + high), (x, y), rng.uniform(0.25, 0.5), rng.choice(["gable", "shed", "gable"]), 0.14, cover, wall)
    kit.add(BOX, (x + 0.02, 0, lift + 0.24), (0.02, 0.16, 0.2), material=dark)
    kit.between((x, 0, lift), (x + lift * 1.25, 0, 0.02), (0.02, 0.16), BOX, material=frame)
    kit.between((x, 0, lift + 0.03), (x + lift * 1.25, 0, 0.05), (0.02, 0.16), BOX, material=frame, cut=(RUNGS, 9, 0.3))
    kit.add(BOX, (0, y + 0.14, lift + 0.2), (x * 0.9, 0.16, 0.18), material=wall)
    kit.add(BOX, (0, y + 0.15, lift + 0.4), (x * 0.95, 0.2, 0.025), rotation=turn("x", -14), material=cover)
    for side in (-1, 1):
        kit.add(BOX, (x + run / 2, side * y, lift * 0.75), (run / 2, 0.02, lift * 0.75), material=mesh, cut=(LATTICE, 10, 0.14))
        kit.between((x, side * y, lift * 1.5), (x + run, side * y, lift * 1.5), 0.03, BOX, material=frame)
        kit.between((x, side * y, 0.03), (x + run, side * y, 0.03), 0.03, BOX, material=frame)
        posts(kit, (x + run,), (side * y,), 0, lift * 1.5, 0.04, frame)
    kit.add(BOX, (x + run, 0, lift * 0.75), (0.02, y, lift * 0.75), material=mesh, cut=(LATTICE, 10, 0.14))
    kit.between((x + run, -y, lift * 1.5), (x + run, y, lift * 1.5), 0.03, BOX, material=frame)
    lights(kit, (0, 0, lift + high * 0.6), (x, y), [0], (0.16, 0.14), dark, frame, 1)
    for k in range(int(rng.integers(1, 4))):
        at, spin = np.array([x + run * (0.45 + 0.25 * k) - 0.1, y * (0.5 if k % 2 else -0.5), 0.0]), turn("z", rng.uniform(0, 360))
        coat, red = tinted(kit, (WHITE, WOOD, (0.3, 0.1, 0.03), TIMBER)), kit.material(base=(0.6, 0.03, 0.03), pattern=PLAIN)
        kit.add(BALL, at + [0, 0, 0.24], (0.17, 0.11, 0.12), rotation=spin, material=coat)
        kit.between(at + spin @ [0.1, 0, 0.27], at + spin @ [0.17, 0, 0.42], 0.055, CYL, 0.8, material=coat)
        kit.add(BALL, at + spin @ [0.18, 0, 0.44], (0.05, 0.045, 0.05), rotation=spin, material=coat)
        kit.add(BOX, at + spin @ [0.18, 0, 0.5], (0.04, 0.012, 0.03), rotation=spin, material=red)
        kit.between(at + spin @ [-0.08, 0, 0.26], at + spin @ [-0.24, 0, 0.42], (0.08, 0.05), BOX, 0.6, material=coat)
        kit.between(at + [0, 0, 0.16], at, 0.025, material=tinted(kit, (YELLOW,)))
        kit.add(BOX, at + spin @ [0.03, 0, 0.01], (0.06, 0.05, 0.01), rotation=spin, material=tinted(kit, (YELLOW,)))


def bird_table(kit):
    rng = kit.rng
    wood, cover, seed = timberwork(kit), tiles(kit), tinted(kit, (OCHRE, SAND), (SPECKLES,), frequency=40)
    lift, x, y, high = rng.uniform(1.1, 1.5), rng.uniform(0.28, 0.36), rng.uniform(0.32, 0.45), rng.uniform(0.3, 0.42)
    kit.add(CYL, (0, 0, lift / 2), (0.045, 0.045, lift / 2), material=wood)
    feet = rng.choice(["cross", "tripod", "disc"])
    if feet == "disc":
        kit.add(CYL, (0, 0, 0.04), (0.3, 0.3, 0.04), (0.9, 1), material=masonry(kit))
    else:
        for px, py in around(4 if feet == "cross" else 3, 1):
            kit.between((px * 0.42, py * 0.42, 0.02), (0, 0, 0.05 if feet == "cross" else 0.55), 0.04, BOX, material=wood)
            if feet == "cross":
                kit.between((px * 0.3, py * 0.3, 0.04), (0, 0, 0.4), 0.025, BOX, material=wood)
    for px, py in around(4, 1):
        kit.between((0, 0, lift - 0.3), (px * x * 0.8, py * y * 0.7, lift), 0.025, BOX, material=wood)
    kit.add(BOX, (0, 0, lift), (x, y, 0.02), material=wood)
    for side in (-1, 1):
        kit.add(BOX, (side * x, 0, lift + 0.03), (0.015, y, 0.04), material=wood)
        kit.add(BOX, (0, side * y, lift + 0.03), (x, 0.015, 0.04), material=wood)
    posts(kit, (-x * 0.92, x * 0.92), (-y * 0.92, y * 0.92), lift, lift + high, 0.022, wood)
    rise = rng.uniform(0.18, 0.32)
    leaves(kit, (0, 0, lift + high), turn("z", 90), y + 0.08, (x + 0.1, -0.06), (0, rise), 0.018, cover)
    for side in (-1, 1):
        kit.add(BOX, (0, side * y * 0.9, lift + high + rise / 2), (x, 0.015, rise / 2), (0.03, 1), material=wood)
    kit.add(BALL, (0.03, 0.02, lift + 0.03), (x * 0.6, y * 0.55, 0.04), material=seed)
    for k in range(int(rng.integers(1, 4))):
        at, spin = np.array([x * (0.95 if k else 0.2), y * (0.5 - 0.55 * k), lift + 0.11]), turn("z", rng.uniform(0, 360))
        coat = tinted(kit, ((0.1, 0.15, 0.3), WOOD, GREY, (0.4, 0.1, 0.03), YELLOW))
        kit.add(BALL, at + [0, 0, 0.03], (0.085, 0.055, 0.055), rotation=spin, material=coat)
        kit.add(BALL, at + spin @ [0.07, 0, 0.09], (0.042, 0.04, 0.04), rotation=spin, material=tinted(kit, (TIMBER, GREY, (0.1, 0.15, 0.3))))
        kit.between(at + spin @ [0.1, 0, 0.09], at + spin @ [0.145, 0, 0.085], 0.013, CYL, 0.3, material=kit.material(dark=True))
        kit.between(at + spin @ [-0.06, 0, 0.03], at + spin @ [-0.18, 0, 0.07], (0.012, 0.03), BOX, material=coat)
        kit.between(at, at - [0, 0, 0.06], 0.01, material=kit.material(dark=True))
