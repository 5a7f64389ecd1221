"""Factories, warehouses, breweries, power stations; mills driven by water and wind."""

import numpy as np

from .building_parts import block, lettered, paving, posts, slab, timberwork, vivid
from .dwellings import (
    BLUE,
    BRICK,
    CONCRETE,
    COPPER,
    CREAM,
    GREEN,
    GREY,
    RED,
    SLATE,
    STONE,
    THATCH,
    TIMBER,
    WHITE,
    WOOD,
    brickwork,
    chimney,
    door,
    leaf,
    lights,
    masonry,
    panes,
    roof,
    row,
    tiles,
    trim,
    walls_of,
)
from .installations import stairs, steelwork, tinted
from .kit import ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, PRISM, SPOKES, TUBE
from .materials import BANDS, BRICKS, CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, SHINGLES, STREAKS, WRITING


def factory(kit):
    rng = kit.rng
    wall, cover, glass, frame = brickwork(kit) if kit.chance(0.6) else walls_of(kit), tiles(kit), panes(kit), trim(kit)
    teeth, x, high = int(rng.integers(3, 6)), rng.uniform(3, 4.5), rng.uniform(3.2, 4.2)
    half, rise = 1.6, rng.uniform(1.3, 1.8)
    y = half * teeth
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    for k in range(teeth):
        at = -y + half * (2 * k + 1)
        kit.add(BOX, (0, at, high + rise / 2), (x, half, rise / 2), (1, 0.06), (0, half * 0.93), material=wall)
        kit.between((0, at - half, high + 0.06), (0, at + half, high + rise + 0.06), (0.06, x + 0.12), BOX, material=cover)
        kit.add(BOX, (0, at + half * 0.99, high + rise * 0.5), (x * 0.93, 0.04, rise * 0.38), material=glass)
        lights(kit, (0, at, high * 0.58), (x, y), [at], (half * 0.6, high * 0.22), glass, frame, 0)
    lights(kit, (0, 0, high * 0.58), (x, y), row(3, x), (0.6, high * 0.22), glass, frame, 1)
    tall = high + rng.uniform(5, 9)
    cx = -x - 0.5
    slab(kit, cx, y * 0.5, 0, (0.75, 0.75, 1.0), wall)
    kit.add(CYL, (cx, y * 0.5, tall / 2), (0.55, 0.55, tall / 2), (0.65, 1), material=brickwork(kit))
    kit.add(TUBE, (cx, y * 0.5, tall - 0.2), (0.45, 0.45, 0.25), material=brickwork(kit))
    kit.add(BOX, (x + 0.03, -y + half, 1.3), (0.06, 0.9, 1.3), material=leaf(kit))
    slab(kit, x + 1.2, y - 1.3, 0, (1.2, 1.3, 1.6), wall)
    slab(kit, x + 1.2, y - 1.3, 3.2, (1.35, 1.45, 0.12), frame)
    lights(kit, (x + 1.2, y - 1.3, 1.7), (1.2, 1.3), row(2, 1.3), (0.35, 0.5), glass, frame, 0)


def warehouse(kit):
    rng = kit.rng
    wall, cover, accent, dark, concrete, glass = (
        tinted(kit, (GREY, WHITE, BLUE, CREAM, GREEN), (RIBS, SEAMS, PLAIN), frequency=18),
        steelwork(kit),
        vivid(kit),
        kit.material(dark=True),
        paving(kit),
        panes(kit),
    )
    x, y, high, docks = rng.uniform(4, 6), rng.uniform(6, 8), rng.uniform(3.8, 5), int(rng.integers(4, 7))
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    kit.add(BOX, (0, 0, high - 0.3), (x + 0.05, y + 0.05, 0.3), material=accent)
    roof(kit, (0, 0, high), (x, y), rng.uniform(0.6, 1.2), rng.choice(["gable", "flat"]), 0.15, cover, wall, 1)
    slab(kit, x + 0.7, 0, 0, (0.7, y * 0.92, 0.55), concrete)
    slab(kit, x + 1.0, 0, 3.3, (1.1, y * 0.92, 0.1), accent)
    for k, py in enumerate(row(docks, y * 0.9, 1)):
        kit.add(BOX, (x + 0.04, py, 2.1), (0.06, 0.75, 1.0), material=tinted(kit, (WHITE, GREY), (BANDS,), frequency=10))
        for side in (-1, 1):
            kit.add(BOX, (x + 0.12, py + side * 0.85, 2.15), (0.12, 0.1, 1.1), material=dark)
        if k == 1:
            kit.add(BOX, (x + 4.2, py, 2.3), (2.8, 0.72, 1.2), material=vivid(kit, (PLAIN, WRITING), frequency=8))
            for px in (x + 5.4, x + 6.2):
                kit.add(CYL, (px, py, 0.5), (0.5, 0.5, 0.72), rotation=ALONG_Y, material=dark)
            slab(kit, x + 2.4, py, 0, (0.1, 0.5, 0.55), dark)
    lights(kit, (0, 0, high * 0.72), (x, y), row(4, x), (0.6, 0.3), glass, accent, 1, False)
    slab(kit, x * 0.2, y + 1.3, 0, (x * 0.6, 1.4, 1.5), accent)
    kit.add(BOX, (x * 0.2, y + 1.3, 1.7), (x * 0.62, 1.43, 0.6), material=glass)
    kit.add(BOX, (-x, 0, 1.4), (0.06, 1.4, 1.4), material=dark)
    for px in row(3, x):
        kit.add(CYL, (px, -y * 0.4, high + 0.8), (0.3, 0.3, 0.8), material=cover)


def watermill(kit):
    rng = kit.rng
    wall, cover, wood, glass, frame, stone = walls_of(kit), tiles(kit), timberwork(kit), panes(kit), trim(kit), masonry(kit)
    x, y, high, r = rng.uniform(2.4, 3), rng.uniform(2.2, 2.8), rng.uniform(4.8, 6), rng.uniform(1.7, 2.3)
    slab(kit, 0, 0, 0, (x + 0.06, y + 0.06, 1.1), stone)
    slab(kit, 0, 0, 2.2, (x, y, high / 2 - 1.1), wall)
    roof(kit, (0, 0, high), (x, y), y * rng.uniform(0.8, 1.1), rng.choice(["gable", "gable", "halfhip"]), 0.4, cover, wall)
    lights(kit, (0, 0, high * 0.72), (x, y), row(3, x), (0.35, 0.45), glass, frame, 1)
    lights(kit, (0, 0, high * 0.72), (x, y), row(2, y), (0.35, 0.45), glass, frame, 0)
    door(kit, (x, -y * 0.3, 0.0), (0.5, 1.0), leaf(kit), frame)
    wheel_y = y + 0.65
    for side in (-0.35, 0.35):
        kit.add(CYL, (0, wheel_y + side, r + 0.1), (r, r, 0.06), rotation=ALONG_Y, material=wood, cut=(SPOKES, 8, 0.16))
    for px, pz in around(14, r * 0.93):
        kit.add(BOX, (px, wheel_y, r + 0.1 + pz), (0.22, 0.33, 0.03), rotation=turn("y", -np.degrees(np.arctan2(pz, px))), material=wood)
    kit.between((0, y - 0.2, r + 0.1), (0, wheel_y + 0.9, r + 0.1), 0.13, material=wood)
    slab(kit, 0, wheel_y + 0.85, 0, (0.5, 0.2, r / 2 + 0.05), stone)
    kit.add(BOX, (-r * 1.1, wheel_y, 2 * r + 0.35), (r * 1.1, 0.32, 0.12), material=wood)
    posts(kit, (-r * 1.4, -r * 2.1), (wheel_y - 0.25, wheel_y + 0.25), 0, 2 * r + 0.3, 0.08, wood)
    slab(kit, -x * 0.2, wheel_y, 0, (x * 1.3, 0.55, 0.04), tinted(kit, ((0.05, 0.12, 0.15),), gloss=0.5))
    chimney(kit, -x * 0.5, 0, high + y * 0.5, high + y + 0.9)


def brewery(kit):
    rng = kit.rng
    wall, cover, stone, glass, steel = brickwork(kit), tiles(kit), masonry(kit), panes(kit), tinted(kit, (GREY, WHITE, COPPER), (PLAIN, SEAMS), gloss=0.4)
    x, y, storeys = rng.uniform(2.6, 3.2), rng.uniform(3, 3.8), 3
    block(kit, (0, 0, 0), (x, y, 4.8), storeys, (5, 4, 4), wall, glass, stone, 0.58)
    roof(kit, (0, 0, 9.6), (x, y), 1.6, rng.choice(["mansard", "gable", "flat"]), 0.25, cover, wall, 1)
    tall = rng.uniform(11, 16)
    kit.add(PRISM, (-x - 0.9, -y * 0.5, tall / 2), (0.7, 0.7, tall / 2), (0.6, 8), material=wall)
    kit.add(PRISM, (-x - 0.9, -y * 0.5, tall), (0.55, 0.55, 0.25), (1, 8), material=stone)
    slab(kit, 0, -y - 2.2, 0, (x, 2.3, 2.2), wall)
    roof(kit, (0, -y - 2.2, 4.4), (x, 2.3), 1.2, "gable", 0.2, cover, wall)
    for k in range(2):
        kit.add(BOX, (x + 0.03, -y - 1.2 - 2 * k, 1.2), (0.06, 0.7, 1.2), material=leaf(kit))
        kit.add(CYL, (x * (0.6 - 1.1 * k), y + 1.1, 3.4), (0.9, 0.9, 2.4), material=steel)
        kit.add(CYL, (x * (0.6 - 1.1 * k), y + 1.1, 6.1), (0.9, 0.9, 0.3), (0.3, 1), material=steel)
        kit.add(CYL, (x * (0.6 - 1.1 * k), y + 1.1, 0.6), (0.75, 0.75, 0.6), material=stone)
    kit.add(BOX, (x + 0.07, 0, 8.8), (0.06, y * 0.75, 0.4), material=lettered(kit))


def windmill(kit):
    rng = kit.rng
    wall, cap, wood, glass, cloth = (
        tinted(kit, (WHITE, BRICK, STONE, TIMBER, WOOD), (BRICKS, PLAIN, SHINGLES, PLANKS), frequency=16),
        tinted(kit, (TIMBER, SLATE, THATCH, RED), (SHINGLES, PLAIN), frequency=16),
        timberwork(kit),
        panes(kit),
        tinted(kit, (WHITE, WOOD, CREAM)),
    )
    kind = rng.choice(["tower", "smock", "post"])
    r, high = rng.uniform(1.7, 2.1), rng.uniform(5, 6.5)
    top, front = high, r * 0.62
    if kind == "post":
        for way in range(4):
            spin = turn("z", 90 * way + 45)
            kit.between(spin @ np.array([2.0, 0, 0.1]), spin @ np.array([0.15, 0, 2.2]), 0.13, BOX, material=wood)
            kit.add(BOX, spin @ np.array([1.0, 0, 0.15]), (1.15, 0.14, 0.14), rotation=spin, material=wood)
        slab(kit, 0, 0, 0, (0.25, 0.25, 1.3), wood)
        slab(kit, 0, 0, 2.2, (1.6, 1.2, 1.7), wall)
        roof(kit, (0, 0, 5.6), (1.6, 1.2), 1.3, rng.choice(["gable", "gambrel"]), 0.2, cap, wall)
        stairs(kit, (-3.6, 0, 0), (-1.6, 0, 2.5), 0.4, wood)
        top, front = 5.4, 1.6
        kit.between((-1.6, 0.6, 2.4), (-4.2, 0.6, 0.5), 0.09, material=wood)
        lights(kit, (0, 0, 4), (1.6, 1.2), [0], (0.3, 0.35), glass, wood, 1)
    else:
        kit.add(CYL if kind == "tower" else PRISM, (0, 0, high / 2), (r, r, high / 2), (0.62, 8 if kind == "smock" else 1), material=wall)
        if kind == "smock":
            kit.add(PRISM, (0, 0, 0.8), (r * 1.08, r * 1.08, 0.8), (0.96, 8), material=brickwork(kit))
        if kit.chance(0.5):
            kit.add(PRISM, (0, 0, high * 0.36), (r * 1.45, r * 1.45, 0.06), (1, 12), material=wood)
            kit.add(TUBE, (0, 0, high * 0.36 + 0.4), (r * 1.4, r * 1.4, 0.4), material=wood, cut=(BARS, 40, 0.2))
            for px, py in around(8, 1):
                kit.between((px * r * 0.9, py * r * 0.9, high * 0.22), (px * r * 1.35, py * r * 1.35, high * 0.35), 0.06, BOX, material=wood)
        if kit.chance(0.5):
            kit.add(BALL, (0, 0, high), (r * 0.72, r * 0.68, r * 0.7), material=cap)
        else:
            kit.add(CYL, (0, 0, high + r * 0.45), (r * 0.75, r * 0.75, r * 0.5), (0.05, 1), material=cap)
        top, front = high + 0.35, r * 0.66
        for z, share in ((high * 0.5, 0.81), (high * 0.75, 0.715)):
            kit.add(BOX, (0, 0, z), (0.25, r * share, 0.35), material=glass)
        door(kit, (r * 0.93, 0, 0), (0.42, 0.9), leaf(kit), wood)
        for side in (-1, 1):
            kit.between((-r * 0.5, side * r * 0.3, high + 0.2), (-r * 1.7, 0, high * 0.35), 0.06, BOX, material=wood)
    hub, long, spin0 = np.array([front + 0.45, 0, top]), min(top - 0.5, 5.0) * 0.95, rng.uniform(0, 90)
    kit.between((front - 0.6, 0, top - 0.1), hub, 0.16, material=wood)
    kit.add(BALL, hub, (0.25, 0.25, 0.25), material=wood)
    for k in range(4):
        spin = turn("x", spin0 + 90 * k)
        kit.add(BOX, hub + spin @ [0, 0, long / 2], (0.07, 0.08, long / 2), (0.6, 0.6), rotation=spin, material=wood)
        kit.add(
            BOX,
            hub + spin @ [0.03, 0.38, long * 0.6],
            (0.025, 0.36, long * 0.39),
            rotation=spin,
            material=cloth,
            cut=(GRID, 2.6, 0.3) if cloth.gloss > 0.1 or kind != "tower" else (LATTICE, 2.0, 0.4),
        )


def power_station(kit):
    rng = kit.rng
    wall, glass, stone, steel = tinted(kit, (BRICK, CONCRETE, GREY, CREAM), (PLAIN, BRICKS, RIBS), frequency=18), panes(kit), tinted(kit, (WHITE, CONCRETE)), steelwork(kit)
    x, y, high = rng.uniform(3, 3.8), rng.uniform(5, 7), rng.uniform(5, 6.5)
    block(kit, (0, 0, 0), (x, y, high / 2), 1, (9, 8, 4), wall, glass, stone, 0.55)
    slab(kit, 0, 0, high, (x * 0.6, y * 0.95, 0.5), wall)
    kit.add(BOX, (0, 0, high + 0.5), (x * 0.62, y * 0.9, 0.25), material=glass)
    kind = rng.choice(["stacks", "cooling"])
    concrete = tinted(kit, (CONCRETE, WHITE, GREY), (STREAKS, PLAIN, CLOUDY))
    if kind == "stacks":
        slab(kit, -x - 2, 0, 0, (2.2, y * 0.9, high * 0.7), wall)
        for py in row(int(rng.integers(2, 5)), y * 0.9, 0.9):
            tall = high + rng.uniform(7, 7.1)
            kit.add(CYL, (-x - 2, py, tall / 2), (0.7, 0.7, tall / 2), (0.65, 1), material=concrete)
            kit.add(CYL, (-x - 2, py, tall - 0.5), (0.5, 0.5, 0.4), material=tinted(kit, ((0.55, 0.04, 0.03),)))
    else:
        for py in (-y * 0.55, y * 0.55):
            r = 2.6
            kit.loft((-x - 3.4, py, 0), [(0, r), (2.5, r * 0.8), (4.5, r * 0.66), (6, r * 0.62), (7.2, r * 0.64), (8.2, r * 0.7)], concrete)
            kit.add(CYL, (-x - 3.4, py, 8.2), (r * 0.62, r * 0.62, 0.03), material=kit.material(dark=True))
        kit.between((-x, 0, high * 0.5), (-x - 2.2, y * 0.5, 1.0), 0.3, material=steel)
    kit.add(BOX, (x + 0.05, 0, 1.4), (0.06, 0.9, 1.4), material=leaf(kit))
    for k in range(3):
        slab(kit, x + 1.6, y * (0.5 - 0.5 * k), 0, (0.6, 0.5, 0.55), steel)
        posts(kit, (x + 1.4, x + 1.8), (y * (0.5 - 0.5 * k),), 1.0, 1.6, 0.08, stone)
