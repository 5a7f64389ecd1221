"""Churches of six kinds, mosques, synagogues, Hindu temples, stupas, pagodas, shrines."""

import numpy as np

from .building_parts import flight, lettered, posts, slab, timberwork, vivid
from .dwellings import (
    BLUE,
    BRICK,
    CONCRETE,
    COPPER,
    CREAM,
    GOLD,
    GREEN,
    GREY,
    OCHRE,
    RED,
    SAND,
    SLATE,
    STONE,
    TIMBER,
    WHITE,
    WOOD,
    door,
    leaf,
    leaves,
    lights,
    masonry,
    panes,
    roof,
    row,
    tiles,
)
from .installations import tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .landmarks import dome
from .layout import BALL, BOX, CYL, GRID, PRISM, SPOKES
from .materials import BANDS, BRICKS, CHECKER, CLOUDY, DOTS, PLAIN, PLANKS, RIBS, SEAMS, SHINGLES, SPECKLES, STRIPES
from .worship import arched, cross, onion, spire


def nave(kit, x, y, high, rise, wall, cover, glass, count, buttress=None, head=0.42):
    """A gabled nave along x with round-headed windows and, perhaps, buttresses on both sides."""
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    roof(kit, (0, 0, high), (x, y), rise, "gable", 0.25, cover, wall)
    arched(kit, (0, 0, 0), (x, y), row(count, x), head, high * 0.32, high * 0.68, glass, 1)
    if buttress is not None:
        for k in range(count + 1):
            px = x * 0.8 * (2 * k / count - 1)
            kit.add(BOX, (px, y + 0.3, high * 0.42), (0.18, 0.4, high * 0.42), (1, 0.25), (0, -0.28), material=buttress, mirror=True)


def romanesque(kit):
    rng = kit.rng
    wall, cover, glass, stone = masonry(kit), tiles(kit), panes(kit), masonry(kit)
    x, y, high = rng.uniform(4.5, 6), rng.uniform(1.6, 2.1), rng.uniform(4.5, 5.5)
    nave(kit, x, y, high, y * 0.8, wall, cover, glass, 5, None, 0.3)
    slab(kit, 0, 0, 0, (x * 0.95, y + 1.3, high * 0.28), wall)
    for side in (-1, 1):
        kit.add(BOX, (0, side * (y + 0.65), high * 0.56 + 0.3), (x * 0.97, 0.85, 0.07), rotation=turn("x", -side * 24), material=cover)
    kit.add(CYL, (-x, 0, high * 0.4), (y * 0.85, y * 0.85, high * 0.4), material=wall)
    kit.add(CYL, (-x, 0, high * 0.8 + 0.5), (y * 0.95, y * 0.95, 0.5), (0.05, 1), material=cover)
    half, tall = rng.uniform(0.9, 1.15), high + rng.uniform(3, 4.5)
    for py in (-y, y) if kit.chance(0.6) else (0,):
        slab(kit, x + half * 0.6, py, 0, (half, half, tall / 2), wall)
        spire(kit, x + half * 0.6, py, tall, half + 0.15, rng.uniform(1.2, 2), cover)
        for z in (tall * 0.86, tall * 0.66):
            for facing in (0, 1):
                arched(kit, (x + half * 0.6, py, 0), (half, half), [0], half * 0.3, z - 0.5, z, glass, facing, 0.03)
    for grow, out, skin in ((1.0, 0.1, stone), (0.72, 0.16, leaf(kit))):
        kit.add(BOX, (x + half * 1.6, 0, 0.9), (out, 0.85 * grow, 0.9), material=skin)
        kit.add(CYL, (x + half * 1.6, 0, 1.8), (0.85 * grow, 0.85 * grow, out), rotation=ALONG_X, material=skin)
    slab(kit, x + half * 0.4, 0, 0, (half * 1.15, y * 0.8, high * 0.5), wall)


def gothic(kit):
    rng = kit.rng
    wall, cover, glass = masonry(kit), tiles(kit), panes(kit)
    x, y, high = rng.uniform(4.5, 5.5), rng.uniform(1.7, 2.2), rng.uniform(5.5, 7)
    nave(kit, x, y, high, y * 1.5, wall, cover, glass, 5, wall, 0.34)
    kit.add(PRISM, (-x, 0, high * 0.45), (y, y, high * 0.45), (1, 8), rotation=turn("z", 22.5), material=wall)
    kit.add(PRISM, (-x, 0, high * 0.9 + 1.0), (y * 1.1, y * 1.1, 1.0), (0.04, 8), rotation=turn("z", 22.5), material=cover)
    half, tall = rng.uniform(0.95, 1.2), high + rng.uniform(2.5, 4)
    twin = kit.chance(0.5)
    for py in (-y * 0.9, y * 0.9) if twin else (0,):
        slab(kit, x + 0.7, py, 0, (half, half, tall / 2), wall)
        spire(kit, x + 0.7, py, tall, half, rng.uniform(3, 5) if py >= 0 else 4, cover, 8)
        for cx, cy in around(4, half * 1.35, 45):
            if not twin:
                slab(kit, x + 0.7 + cx * 0.75, py + cy * 0.75, 0, (0.2, 0.2, tall / 2 + 0.3), wall)
                spire(kit, x + 0.7 + cx * 0.75, py + cy * 0.75, tall + 0.6, 0.22, 1.1, wall)
        arched(kit, (x + 0.7, py, 0), (half, half), [0], half * 0.35, tall * 0.68, tall * 0.86, glass, 0, 0.04)
    front = x + 0.7 + half if not twin else x + 0.3
    kit.add(BOX, (x + 0.1, 0, high / 2), (0.25, y * 0.9, high / 2), material=wall)
    kit.add(CYL, (front, 0, high * 0.62), (0.65, 0.65, 0.08), rotation=ALONG_X, material=glass, cut=(SPOKES, 8, 0.7))
    kit.add(CYL, (front - 0.03, 0, high * 0.62), (0.68, 0.68, 0.06), rotation=ALONG_X, material=wall)
    for grow, out in ((1.0, 0.1), (0.7, 0.16)):
        skin = wall if grow == 1 else leaf(kit)
        kit.add(BOX, (front, 0, 0.9), (out, 0.7 * grow, 0.9), material=skin)
        kit.add(BOX, (front, 0, 1.8 + 0.55 * grow), (out, 0.7 * grow, 0.55 * grow), (1, 0.05), material=skin)


def stave(kit):
    rng = kit.rng
    wall, cover, frame = (
        tinted(kit, (TIMBER, WOOD, (0.12, 0.07, 0.04)), (STRIPES, PLANKS), frequency=22, gloss=0.0),
        tinted(kit, (TIMBER, SLATE, WOOD), (SHINGLES,), frequency=22),
        timberwork(kit),
    )
    x, y = rng.uniform(2.6, 3.2), rng.uniform(2.0, 2.4)
    z, last = 0.3, 0.0
    slab(kit, 0, 0, 0, (x + 0.9, y + 0.9, 0.15), masonry(kit))
    for k, (share, tall) in enumerate(((1.0, 1.3), (0.72, 1.5), (0.42, 1.3), (0.2, 0.9))):
        hx, hy = x * share, y * share
        slab(kit, 0, 0, z, (hx, hy, tall / 2 + 0.3), wall)
        z += tall
        rise = y * share * (0.75 if k < 3 else 3)
        if k == 0:
            kit.add(BOX, (0, 0, z + 0.35), (hx + 0.75, hy + 0.75, 0.4), (0.72, 0.68), material=cover)
            z += 0.5
        elif k < 3:
            roof(kit, (0, 0, z), (hx, hy), rise, "gable", 0.3, cover, wall)
            for end in (-1, 1):
                kit.between((end * (hx + 0.3), 0, z + rise), (end * (hx + 0.75), 0, z + rise + 0.45), 0.07, BOX, 0.5, material=frame)
            z += rise * 0.55
        else:
            spire(kit, 0, 0, z, hx + 0.15, rise, cover)
        last = z
    cross(kit, 0, 0, last + y * 0.6, 0.5, frame)
    posts(kit, np.linspace(-x - 0.6, x + 0.6, 4), (-y - 0.6, y + 0.6), 0.3, 1.6, 0.07, frame)
    slab(kit, x + 0.6, 0, 0.3, (0.8, 0.65, 0.75), wall)
    roof(kit, (x + 0.6, 0, 1.8), (0.8, 0.65), 0.8, "gable", 0.25, cover, wall)
    door(kit, (x + 1.4, 0, 0.3), (0.32, 0.62), leaf(kit), frame)
    kit.add(CYL, (-x - 0.4, 0, 1.0), (0.8, 0.8, 1.0), material=wall)
    kit.add(CYL, (-x - 0.4, 0, 2.4), (1.0, 1.0, 0.5), (0.05, 1), material=cover)


def orthodox(kit):
    rng = kit.rng
    wall, glass, gold = tinted(kit, (WHITE, CREAM, WHITE, BLUE, RED), (PLAIN, CLOUDY)), panes(kit), tinted(kit, (GOLD, GOLD, GREEN, BLUE, COPPER), gloss=0.5)
    cap, metal = tinted(kit, (GREEN, GREY, SLATE)), tinted(kit, (GOLD,), gloss=0.6)
    x, high = rng.uniform(2.4, 3.0), rng.uniform(5, 6.5)
    slab(kit, 0, 0, 0, (x, x, high / 2), wall)
    for axis in (0, 1):
        for place in row(3, x, 1):
            spot = (0, place, high) if axis == 0 else (place, 0, high)
            kit.add(CYL, spot, (x / 3, x / 3, x + 0.05), rotation=ALONG_X if axis == 0 else ALONG_Y, material=wall)
        arched(kit, (0, 0, 0), (x, x), (-x * 2 / 3, x * 2 / 3), 0.24, high * 0.45, high * 0.72, glass, axis)
    kit.add(BOX, (0, 0, high + 0.3), (x * 0.98, x * 0.98, 0.45), (0.5, 0.5), material=cap)
    for px, py, r, tall in ((0, 0, 0.75, 2.6), (x * 0.6, x * 0.6, 0.48, 1.9), (-x * 0.6, x * 0.6, 0.48, 1.9), (x * 0.6, -x * 0.6, 0.48, 1.9), (-x * 0.6, -x * 0.6, 0.48, 1.9)):
        kit.add(CYL, (px, py, high + tall / 2), (r, r, tall / 2), material=wall)
        onion(kit, px, py, high + tall, r * 1.15, gold)
        cross(kit, px, py, high + tall + r * 2.5, 0.55, metal)
    slab(kit, x + 0.6, 0, 0, (0.7, 0.9, 1.3), wall)
    roof(kit, (x + 0.6, 0, 2.6), (0.7, 0.9), 0.9, "gable", 0.2, cap, wall)
    door(kit, (x + 1.3, 0, 0), (0.42, 0.85), leaf(kit), metal)
    kit.add(CYL, (-x, 0, high * 0.35), (x * 0.45, x * 0.45, high * 0.35), material=wall)
    kit.add(BALL, (-x, 0, high * 0.7), (x * 0.46, x * 0.46, x * 0.35), material=cap)


def clapboard(kit):
    rng = kit.rng
    wall, cover, glass, frame = tinted(kit, (WHITE, WHITE, WHITE, CREAM, RED), (PLANKS, BANDS), frequency=26), tiles(kit), panes(kit), tinted(kit, (WHITE,))
    x, y, high = rng.uniform(4, 5.2), rng.uniform(2.2, 2.8), rng.uniform(3.6, 4.4)
    nave(kit, x, y, high, y * rng.uniform(0.7, 1.1), wall, cover, glass, 4, None, 0.36)
    lights(kit, (0, 0, high * 0.5), (x, y), (-y * 0.6, y * 0.6), (0.3, 0.75), glass, frame, 0)
    slab(kit, 0, 0, 0, (x + 0.1, y + 0.1, 0.2), masonry(kit))
    half, tall = rng.uniform(0.85, 1.1), high + y + rng.uniform(0.5, 1.5)
    slab(kit, x, 0, 0, (half, half, tall / 2), wall)
    slab(kit, x, 0, tall, (half + 0.15, half + 0.15, 0.08), frame)
    posts(kit, (x - half * 0.65, x + half * 0.65), (-half * 0.65, half * 0.65), tall, tall + 1.4, 0.12, frame)
    slab(kit, x, 0, tall + 1.35, (half * 0.85, half * 0.85, 0.1), frame)
    kit.add(BALL, (x, 0, tall + 0.75), (0.35, 0.35, 0.4), material=tinted(kit, (GOLD, TIMBER), gloss=0.5))
    kit.between((x, 0, tall + 1), (x, 0, tall + 1.4), 0.06, material=frame)
    spire(kit, x, 0, tall + 1.5, half * 0.75, rng.uniform(2.5, 4), cover, int(rng.choice([4, 8])))
    door(kit, (x + half, 0, 0.4), (0.5, 1.05), leaf(kit), frame)
    flight(kit, x + half, 0, 0.4, 0.9, masonry(kit), 3)
    kit.add(CYL, (x, 0, tall * 0.75), (0.35, 0.35, half + 0.05), rotation=ALONG_X, material=glass)


def modern_church(kit):
    rng = kit.rng
    wall, cover, glass, frame = (
        tinted(kit, (WHITE, CONCRETE, BRICK), (PLAIN, BRICKS, CLOUDY), frequency=20),
        tiles(kit),
        vivid(kit, (CHECKER, DOTS), frequency=14),
        tinted(kit, (WOOD, GREY, WHITE)),
    )
    x, y, tall = rng.uniform(4, 5), rng.uniform(3, 4), rng.uniform(5, 8)
    if kit.chance(0.5):  # a tent of concrete or copper
        for k in range(4):
            px, size = x * (0.75 - 0.5 * k), 1 - 0.12 * k
            leaves(kit, (px, 0, 0), np.eye(3), x * 0.26, (y * size, 0.0), (0, tall * size), 0.1, cover)
            kit.add(BOX, (px + x * 0.24, 0, tall * size / 2), (0.03, y * size, tall * size / 2), (1, 0.02), material=glass if k == 0 else frame)
        kit.add(BOX, (-x * 0.98, 0, tall * 0.3), (0.05, y * 0.62, tall * 0.3), (1, 0.02), material=wall)
    else:
        kit.add(BOX, (0, 0, 2), (x, y, 2), (1, 0.95), material=wall)
        kit.add(BOX, (0, 0, 4 + tall * 0.15), (x + 0.4, y + 0.4, tall * 0.15), (1, 0.1), (0, y * 0.8), material=cover)
        for px in row(6, x):
            kit.add(BOX, (px, y, 2.1), (0.13, 0.06, 1.5), material=glass, mirror=True)
        kit.add(BOX, (x, 0, 2), (0.05, y * 0.4, 1.8), material=glass)
    door(kit, (x + 0.03, 0, 0), (0.8, 1.1), leaf(kit), frame)
    kit.add(BOX, (x + 0.8, 0, 2.5), (0.9, 1.6, 0.1), material=frame)
    posts(kit, (x + 1.5,), (-1.4, 1.4), 0, 2.5, 0.09, frame)
    kit.add(BOX, (x * 0.6, y + 2.0, tall * 0.75), (0.18, 0.8, tall * 0.75), material=wall)
    kit.add(BOX, (x * 0.6 + 0.8, y + 2.0, tall * 0.7), (0.18, 0.8, tall * 0.7), material=wall)
    kit.add(BOX, (x * 0.6 + 0.4, y + 2.0, tall * 1.2), (0.5, 0.6, 0.1), material=frame)
    cross(kit, x * 0.6, y + 2.0, tall * 1.5, 1.5, frame)
    slab(kit, 0, y + 1.3, 0, (x * 0.7, 1.4, 1.2), wall)


def mosque(kit):
    rng = kit.rng
    wall, skin, gold, glass = (
        tinted(kit, (WHITE, CREAM, SAND, STONE), (PLAIN, CLOUDY, BRICKS), frequency=16),
        tinted(kit, (COPPER, GOLD, BLUE, GREY, WHITE), (PLAIN, SEAMS), gloss=0.3),
        tinted(kit, (GOLD,)),
        panes(kit),
    )
    x, high, style = rng.uniform(3, 3.8), rng.uniform(3.4, 4.2), rng.choice(["round", "pointed", "onion"])
    slab(kit, 0, 0, 0, (x, x, high / 2), wall)
    slab(kit, 0, 0, high, (x + 0.1, x + 0.1, 0.12), wall)
    for axis in (0, 1):
        arched(kit, (0, 0, 0), (x, x), row(4, x) if axis else (-x * 0.65, x * 0.65), 0.3, high * 0.3, high * 0.62, glass, axis)
    kit.add(PRISM, (0, 0, high + 0.6), (x * 0.68, x * 0.68, 0.6), (1, 8), material=wall)
    dome(kit, (0, 0, high + 1.1), x * 0.6, style, skin, gold)
    for px, py in around(4, x * 1.0, 45):
        dome(kit, (px, py, high + 0.2), x * 0.22, "round", skin, gold)
    slab(kit, x + 0.7, 0, 0, (0.8, 1.3, high * 0.6), wall)
    kit.add(BOX, (x + 1.5, 0, 0.9), (0.04, 0.55, 0.9), material=glass)
    kit.add(CYL, (x + 1.5, 0, 1.8), (0.55, 0.55, 0.04), rotation=ALONG_X, material=glass)
    count, tall = int(rng.choice([1, 2, 2, 4])), high + rng.uniform(4, 6.5)
    for px, py in [(x + 0.2, x + 0.2), (x + 0.2, -x - 0.2), (-x - 0.2, x + 0.2), (-x - 0.2, -x - 0.2)][:count]:
        slab(kit, px, py, 0, (0.5, 0.5, high / 2), wall)
        kit.add(CYL, (px, py, (high + tall) / 2), (0.34, 0.34, (tall - high) / 2), (0.85, 1), material=wall)
        kit.add(CYL, (px, py, tall * 0.78), (0.55, 0.55, 0.1), material=gold)
        kit.add(CYL, (px, py, tall + 0.6), (0.33, 0.33, 0.65), (0.03, 1), material=skin)
        kit.between((px, py, tall + 1), (px, py, tall + 1.6), 0.04, material=gold)


def synagogue(kit):
    rng = kit.rng
    wall = kit.material(
        base=np.array(CREAM) * rng.uniform(0.7, 1.2),
        second=np.array((BRICK, SAND, GREY))[rng.integers(3)],
        pattern=rng.choice([BANDS, BRICKS]),
        frequency=rng.uniform(10, 18),
        gloss=0.02,
    )
    skin, glass, stone, gold = tinted(kit, (COPPER, SLATE, GOLD)), panes(kit), masonry(kit), tinted(kit, (GOLD,), gloss=0.5)
    x, y, high = rng.uniform(4, 5), rng.uniform(2.8, 3.4), rng.uniform(4.6, 5.4)
    nave(kit, x, y, high, y * 0.5, wall, tiles(kit), glass, 4, None, 0.4)
    kit.add(BOX, (x, 0, high * 0.6), (0.25, y * 0.55, high * 0.6), material=wall)
    for side in (-1, 1):
        slab(kit, x - 0.2, side * y, 0, (0.8, 0.8, high / 2 + 0.5), wall)
        kit.add(PRISM, (x - 0.2, side * y, high + 1.4), (0.65, 0.65, 0.45), (1, 8), material=wall)
        dome(kit, (x - 0.2, side * y, high + 1.8), 0.65, "onion", skin, gold)
    kit.add(CYL, (x + 0.25, 0, high * 0.72), (0.95, 0.95, 0.06), rotation=ALONG_X, material=stone)
    kit.add(CYL, (x + 0.27, 0, high * 0.72), (0.8, 0.8, 0.08), rotation=ALONG_X, material=glass)
    for spin in (0, 180):
        for k in range(3):
            way = turn("x", 120 * k + spin)
            kit.add(BOX, np.array([x + 0.38, 0, high * 0.72]) + way @ [0, 0, -0.33], (0.03, 0.57, 0.04), rotation=way, material=gold)
    for py in (-1, 0, 1):
        kit.add(BOX, (x + 0.25, py * y * 0.3, 0.9), (0.08, 0.35, 0.8), material=leaf(kit))
        kit.add(CYL, (x + 0.25, py * y * 0.3, 1.7), (0.35, 0.35, 0.08), rotation=ALONG_X, material=glass)
    flight(kit, x + 0.25, 0, 0.3, y * 0.6, stone, 2)
    arched(kit, (x - 0.2, 0, 0), (0.8, y + 0.8), [0], 0.22, 1.8, 2.8, glass, 1)


def hindu_temple(kit):
    rng = kit.rng
    skin, gold, dark = (
        tinted(kit, (SAND, STONE, WHITE, (0.45, 0.2, 0.12), OCHRE), (BANDS, SPECKLES, SEAMS, CLOUDY), frequency=18, gloss=0.02),
        tinted(kit, (GOLD,), gloss=0.5),
        kit.material(dark=True),
    )
    slab(kit, 0, 0, 0, (5, 2.6, 0.4), skin)
    flight(kit, 5, 0, 0.8, 0.9, skin, 4)
    south = kit.chance(0.5)
    tall, r = rng.uniform(5, 7), 1.9
    slab(kit, -2.6, 0, 0.8, (r, r, 1.1), skin)
    count = 8
    for k in range(count):
        share, after = k / count, (k + 1) / count
        wide = r * (1 - 0.72 * (share if south else share**2.2))
        slab(kit, -2.6, 0, 3 + tall * share, (wide, wide, tall / count * 0.5), vivid(kit, (DOTS, SPECKLES), frequency=25) if south and k % 2 else skin, taper=(0.9, 0.9))
        if k < 5:
            kit.add(BOX, (-2.6, 0, 3 + tall * (share + after) / 2), (wide * 1.12, wide * 0.3, tall / count * 0.38), (0.9, 0.9), material=skin)
            kit.add(BOX, (-2.6, 0, 3 + tall * (share + after) / 2), (wide * 0.3, wide * 1.12, tall / count * 0.38), (0.9, 0.9), material=skin)
    top = 3 + tall
    if south:
        kit.add(CYL, (-2.6, 0, top), (0.5, 0.5, 0.9), rotation=ALONG_Y, material=skin)
    else:
        kit.add(BALL, (-2.6, 0, top + 0.15), (0.7, 0.7, 0.28), material=skin)
    kit.loft((-2.6, 0, top + 0.3), [(0, 0.2), (0.25, 0.28), (0.4, 0.1), (0.8, 0.01)], gold)
    for x, wide, rise in ((0.3, 1.5, 1.6), (2.7, 1.2, 1.1)):
        slab(kit, x, 0, 0.8, (1.0, wide * 0.75, 1.0), skin)
        posts(kit, (x - 0.9, x + 0.9), (-wide, wide), 0.8, 2.8, 0.14, skin)
        slab(kit, x, 0, 2.8, (1.3, wide + 0.3, 0.12), skin)
        for k in range(3):
            slab(kit, x, 0, 3.04 + rise * k / 3, (1.15 - 0.3 * k, wide - 0.3 * k, rise / 6), skin, taper=(0.8, 0.8))
        kit.add(BALL, (x, 0, 3.1 + rise), (0.25, 0.25, 0.25), material=gold)
    kit.add(BOX, (3.72, 0, 1.6), (0.04, 0.45, 0.8), material=dark)


def stupa(kit):
    rng = kit.rng
    skin, gold, stone = tinted(kit, (WHITE, WHITE, GOLD, SAND, BRICK), (PLAIN, CLOUDY, BRICKS), frequency=14), tinted(kit, (GOLD,), gloss=0.6), masonry(kit)
    r = rng.uniform(2.2, 3)
    bell = kit.chance(0.5)
    for k in range(3):
        slab(kit, 0, 0, 0.5 * k, (r * (1.5 - 0.17 * k), r * (1.5 - 0.17 * k), 0.25), stone)
    for way in range(4):
        spin = turn("z", 90 * way)
        kit.add(BOX, spin @ np.array([r * 1.5, 0, 0.75]), (0.75, 0.5, 0.75), (0.1, 1), (-0.6, 0), rotation=spin, material=stone)
        kit.add(BOX, spin @ np.array([r * 1.02, 0, 2.2]), (0.3, 0.5, 0.7), rotation=spin, material=skin)
        kit.add(BOX, spin @ np.array([r * 1.02 + 0.1, 0, 3.1]), (0.3, 0.6, 0.3), (1, 0.05), rotation=spin, material=gold)
        kit.add(BOX, spin @ np.array([r * 1.02 + 0.31, 0, 2.1]), (0.02, 0.28, 0.5), rotation=spin, material=kit.material(dark=True))
    kit.add(CYL, (0, 0, 1.75), (r * 1.08, r * 1.08, 0.25), material=skin)
    if bell:
        kit.loft((0, 0, 2), [(0, r), (0.3, r * 0.9), (1.2, r * 0.7), (2.2, r * 0.58), (2.9, r * 0.42), (3.2, r * 0.2)], skin)
        top = 5.2
    else:
        kit.add(BALL, (0, 0, 2), (r, r, r * 0.95), material=skin)
        top = 2 + r * 0.93
        slab(kit, 0, 0, top - 0.1, (r * 0.27, r * 0.27, 0.35), gold)
        top += 0.55
    count = 9
    for k in range(count):
        wide = r * 0.24 * (1 - 0.85 * k / count)
        kit.add(CYL, (0, 0, top + 0.11 + 0.22 * k), (wide, wide, 0.12), (0.82, 1), material=gold)
    kit.loft((0, 0, top + 0.22 * count), [(0, 0.1), (0.15, 0.22), (0.25, 0.05), (0.8, 0.01)], gold)
    for px, py in around(4, r * 1.75, 45):
        slab(kit, px, py, 0, (0.35, 0.35, 0.5), stone)
        kit.loft((px, py, 1), [(0, 0.32), (0.4, 0.3), (0.6, 0.12), (1.3, 0.01)], skin)


def pagoda(kit):
    rng = kit.rng
    wall, cover, frame, gold, stone = (
        tinted(kit, (RED, WHITE, WOOD)),
        tinted(kit, (SLATE, GREEN, GREY, OCHRE), (RIBS, SHINGLES), frequency=18),
        tinted(kit, (RED, TIMBER, WOOD)),
        tinted(kit, (GOLD,)),
        masonry(kit),
    )
    sides, levels, r = int(rng.choice([4, 4, 6, 8])), int(rng.integers(3, 8)), rng.uniform(1.7, 2.2)
    spin = turn("z", 45 if sides == 4 else 0)
    grow = 1.414 if sides == 4 else 1
    kit.add(PRISM, (0, 0, 0.3), (r * grow * 1.4, r * grow * 1.4, 0.3), (0.96, sides), rotation=spin, material=stone)
    z = 0.6
    for k in range(levels):
        size = r * (1 - 0.55 * k / levels)
        tall = 1.5 * (1 - 0.35 * k / levels)
        kit.add(PRISM, (0, 0, z + tall / 2), (size * grow * 0.8, size * grow * 0.8, tall / 2), (1, sides), rotation=spin, material=wall)
        kit.add(PRISM, (0, 0, z + tall * 0.95), (size * grow * 1.5, size * grow * 1.5, 0.1), (0.97, sides), rotation=spin, material=frame)
        kit.add(PRISM, (0, 0, z + tall + 0.15), (size * grow * 1.55, size * grow * 1.55, 0.17), (0.72, sides), rotation=spin, material=cover)
        kit.add(PRISM, (0, 0, z + tall + 0.5), (size * grow * 1.1, size * grow * 1.1, 0.22), (0.6, sides), rotation=spin, material=cover)
        kit.add(PRISM, (0, 0, z + tall * 0.28), (size * grow * 0.98, size * grow * 0.98, 0.05), (1, sides), rotation=spin, material=frame)
        z += tall + 0.4
    kit.add(PRISM, (0, 0, z + 0.45), (r * 0.62 * grow, r * 0.62 * grow, 0.4), (0.05, sides), rotation=spin, material=cover)
    kit.loft((0, 0, z + 0.7), [(0, 0.12), (0.5, 0.1), (0.6, 0.25), (0.8, 0.25), (0.9, 0.08), (2.0, 0.01)], gold)
    kit.add(BOX, (r * 0.82, 0, 1.2), (0.05, 0.4, 0.55), material=leaf(kit))
    flight(kit, r * 1.35, 0, 0.6, 0.7, stone, 3)


def shrine(kit):
    rng = kit.rng
    red, cover, wall, stone, dark = (
        tinted(kit, ((0.6, 0.09, 0.03), (0.5, 0.06, 0.03), WOOD, GREY)),
        tinted(kit, (SLATE, COPPER, TIMBER), (SHINGLES, RIBS), frequency=16),
        tinted(kit, (WHITE, CREAM, WOOD)),
        masonry(kit),
        kit.material(dark=True),
    )
    x, y, lift, high = rng.uniform(1.4, 1.8), rng.uniform(1.8, 2.4), 0.7, 2.0
    slab(kit, 0, 0, 0, (x + 1, y + 0.9, 0.2), stone)
    slab(kit, 0, 0, lift - 0.1, (x + 0.7, y + 0.6, 0.07), red)
    posts(kit, (-x - 0.5, x + 0.5), (-y - 0.4, y + 0.4), 0.3, lift, 0.09, red)
    slab(kit, 0, 0, lift, (x, y, high / 2), wall)
    posts(kit, (-x, x), np.linspace(-y, y, 4), lift, lift + high, 0.1, red, CYL)
    eave, rise = lift + high, rng.uniform(1.1, 1.5)
    leaves(kit, (0.2, 0, eave), turn("z", 90), y + 0.8, (x + 1.0, -0.15), (x * 0.5, rise * 0.45), 0.08, cover)
    leaves(kit, (0.2, 0, eave), turn("z", 90), y + 0.8, (x * 0.55, rise * 0.4), (0, rise + 0.2), 0.08, cover)
    for side in (-1, 1):
        kit.add(BOX, (0.2, side * y, eave + rise / 2), (x * 0.9, 0.07, rise / 2), (0.05, 1), material=wall)
        for way in (-1, 1):
            kit.between((0.2 - way * 0.1, side * (y + 0.7), eave + rise), (0.2 + way * 0.5, side * (y + 0.7), eave + rise + 0.8), 0.06, BOX, material=red)
    kit.add(BOX, (0.2, 0, eave + rise + 0.3), (0.16, y + 0.9, 0.1), material=cover)
    for place in (-0.5, 0, 0.5):
        kit.add(CYL, (0.2, place * y, eave + rise + 0.48), (0.11, 0.11, 0.4), rotation=ALONG_X, material=red)
    kit.add(BOX, (x, 0, lift + 0.9), (0.05, 0.6, 0.85), material=dark, cut=(GRID, 4, 0.2))
    flight(kit, x + 0.7, 0, lift, 0.7, red, 4)
    gate, wide, tall = x + 4.2, 1.7, rng.uniform(3, 3.6)
    for side in (-1, 1):
        kit.between((gate, side * wide * 1.08, 0), (gate, side * wide * 0.95, tall), 0.15, CYL, 0.9, material=red)
        kit.add(CYL, (gate, side * wide * 1.08, 0.15), (0.24, 0.24, 0.15), material=dark)
        kit.between((gate, 0, tall + 0.12), (gate, side * (wide + 0.8), tall + 0.28), (0.13, 0.2), BOX, material=red)
        kit.between((gate, 0, tall + 0.3), (gate, side * (wide + 0.9), tall + 0.48), (0.07, 0.26), BOX, material=dark)
        slab(kit, x + 2.4, side * 1.4, 0, (0.14, 0.14, 0.5), stone)
        slab(kit, x + 2.4, side * 1.4, 1.0, (0.24, 0.24, 0.18), stone)
        kit.add(BOX, (x + 2.4, side * 1.4, 1.5), (0.36, 0.36, 0.14), (0.1, 0.1), material=stone)
    kit.add(BOX, (gate, 0, tall - 0.6), (0.1, wide + 0.45, 0.13), material=red)
    kit.add(BOX, (gate, 0, tall - 0.2), (0.08, 0.25, 0.35), material=lettered(kit))
    slab(kit, gate / 2, 0, 0, (gate / 2 + 0.4, 0.7, 0.04), stone)
