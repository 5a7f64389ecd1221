"""A maker of ruins, wrecks and building sites."""

import numpy as np

from .earthworks import cast, heap, rusty, soil, swing
from .extent import bounds
from .installations import BLUE, BRICK, CONCRETE, EARTH, GREEN, GREY, OLIVE, RED, RUST, SAND, STONE, WHITE, WOOD, YELLOW, ladder, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .launchers import drab, metal, timber
from .layout import BALL, BOX, CYL, GRID, LEAVES, RUNGS, TUBE
from .materials import BRICKS, CLOUDY, PLANKS, RIBS, SEAMS, SPECKLES, STREAKS
from .wheeled import glazing


def masonry(kit):
    return tinted(kit, (BRICK, STONE, WHITE, CONCRETE, SAND), (BRICKS, BRICKS, STREAKS, CLOUDY), frequency=kit.rng.uniform(10, 24), gloss=0.0)


def debris(kit, count, x, y, rx, ry, size, materials, base=0.0):
    """Tilted lumps strewn about."""
    rng = kit.rng
    for _ in range(count):
        half = size * rng.uniform([0.5, 0.4, 0.2], [1.4, 0.9, 0.5])
        spin = turn("z", rng.uniform(0, 180)) @ turn("x", rng.uniform(-30, 30))
        at = (x + rng.uniform(-1, 1) * rx, y + rng.uniform(-1, 1) * ry, base + size * 0.4)
        kit.add(BOX, at, half, (rng.uniform(0.6, 1), rng.uniform(0.6, 1)), rotation=spin, material=materials[rng.integers(len(materials))])


def ruin(kit):
    """Burnt houses, broken towers, bombed blocks, abbeys, broken columns, castles, stone circles, wrecked cars, tanks, lorries, aeroplanes and boats, broken bridges,
    barns, overgrown huts, heaps of rubble, timber and scrap, bare frames, houses under scaffolds."""
    kinds = [burnt_house, burnt_house, broken_tower, bombed_block, abbey, columns, old_castle, stone_circle, wrecked_car, wrecked_tank, burnt_lorry, crashed_plane]
    kinds += [beached_boat, broken_bridge, barn, overgrown_hut, rubble, timber_pile, scrap_heap, bare_frame, scaffolded]
    kinds[kit.rng.choice(len(kinds))](kit)
    kit.primitives = [p._replace(centre=p.centre - [0, 0, min(bounds([p])[0][2], 0)]) for p in kit.primitives]


def ragged(kit, start, end, bays, tops, wall, storeys=1, storey=2.7, thick=0.15):
    """A wall with windows between piers of the heights `tops` [bays + 1], jagged where they end."""
    rng = kit.rng
    start, end = np.array(start, float), np.array(end, float)
    long, along = np.linalg.norm(end - start), (end - start) / np.linalg.norm(end - start)
    spin, pitch = turn("z", np.degrees(np.arctan2(along[1], along[0]))), long / bays

    def part(x, half, low, high, taper=1.0, shift=0.0):
        if high > low + 0.05:
            kit.add(BOX, (*(start + along * x), (low + high) / 2), (half, thick, (high - low) / 2), (taper, 1), (shift, 0), spin, wall)

    for k, top in enumerate(tops):
        half = pitch * (0.28 if 0 < k < bays else 0.14)
        x = np.clip(pitch * k, half, long - half)
        part(x, half, 0, top)
        lean = rng.uniform(-0.6, 0.6) * half
        part(x, half, top, top + rng.uniform(0.1, 0.5), 1 - abs(lean) / half, lean)
    for k in range(bays):
        low, x = min(tops[k], tops[k + 1]), pitch * (k + 0.5)
        for level in range(storeys):
            if low > storey * level + 0.5:
                part(x, pitch * 0.25, storey * level, storey * level + 0.85)
            if low > storey * (level + 1) - 0.45:
                part(x, pitch * 0.25, storey * level + 2.0, storey * (level + 1))


def burnt_house(kit):
    rng = kit.rng
    wall, char = masonry(kit), kit.material(dark=True, gloss=0.0)
    storeys = int(rng.choice([1, 1, 2]))
    x, y, high = rng.uniform(3, 4.5), rng.uniform(2.4, 3.2), 2.7 * storeys
    for side in (-1, 1):
        ragged(kit, (-x, side * y), (x, side * y), 3 if storeys == 1 else 2, high * np.clip(rng.uniform(0.5, 1.3, 4 if storeys == 1 else 3), 0.3, 1), wall, storeys)
    for side in (-1, 1):
        kit.add(BOX, (side * x, 0, high * 0.5), (0.15, y, high * 0.5), material=wall)
        if kit.chance(0.75):
            kit.add(BOX, (side * x, 0, high + 0.8), (0.15, y, 0.8), (1, rng.uniform(0.05, 0.4)), material=wall)
        kit.add(BOX, (side * x, rng.uniform(-0.4, 0.4) * y, 1.2), (0.17, 0.5, 0.8 if side < 0 else 1.2), material=char)
    for k in np.linspace(-0.7, 0.7, 4) * x:
        if kit.chance(0.6):
            kit.between((k, y, high * 0.98), (k, 0, high + 1.55), 0.07, BOX, material=char, mirror=kit.chance(0.7))
    kit.between((-x, 0, high + 1.5), (x, 0, high + 1.5), 0.08, BOX, material=char)
    if kit.chance(0.5):
        kit.add(BOX, (x * 0.3, 0.6, high * 0.5 + 1.1), (0.35, 0.35, high * 0.5 + 1.1), material=wall)
    heap(kit, 0, 0, x * 0.8, y * 0.8, 0.7, char)
    debris(kit, 5, x * 0.6, -y * 1.2, 2, 0.8, 0.35, (wall, char))


def broken_tower(kit):
    rng = kit.rng
    wall, dark, radius, high = masonry(kit), kit.material(dark=True), rng.uniform(1.6, 2.2), rng.uniform(5, 9)
    square = kit.chance(0.4)
    count = 4 if square else 12
    low = rng.uniform(0.3, 0.6) * high
    if not square:
        kit.add(CYL, (0, 0, low / 2), (radius * 1.1, radius * 1.1, low / 2), (0.95, 1), material=wall)
    for k in range(count):
        spin = turn("z", 360 * k / count)
        top = high * (0.72 + 0.33 * np.cos(2 * np.pi * k / count)) + rng.uniform(-0.3, 0.3)
        half = radius * np.tan(np.pi / count) * 1.05
        kit.add(BOX, spin @ [radius * 0.9, 0, top / 2], (radius * 0.11, half, top / 2), rotation=spin, material=wall)
        lean = rng.uniform(-0.5, 0.5) * half
        kit.add(BOX, spin @ [radius * 0.9, 0, top + 0.3], (radius * 0.11, half, 0.32), (1, 0.4), (0, lean), spin, wall)
        if k % 3 == 0:
            for z in np.arange(1.6, top - 0.8, 2.2):
                kit.add(BOX, spin @ [radius * 1.03, 0, z], (0.06, 0.16, 0.45), rotation=spin, material=dark)
    heap(kit, -radius * 1.2, 0, radius * 1.3, radius * 1.2, 1.0, wall)
    debris(kit, 10, -radius * 1.6, 0, 1.4, 1.8, 0.4, (wall,), 0.2)


def bombed_block(kit):
    rng = kit.rng
    slab, wall, dark = cast(kit), masonry(kit), kit.material(dark=True)
    storeys, x, y = int(rng.integers(3, 6)), rng.uniform(3, 4), rng.uniform(4, 6)
    for level in range(1, storeys + 1):
        reach = y * (1 - 0.14 * level * rng.uniform(0.5, 1))
        kit.add(BOX, (0, reach - y, 2.8 * level), (x, reach, 0.14), material=slab)
        for px in (-0.9, 0.9):
            for py in (-0.95, -0.3, 0.35):
                if py * y < 2 * reach - y:
                    kit.add(BOX, (px * x, py * y, 2.8 * level - 1.4), (0.18, 0.18, 1.4), material=slab)
        kit.add(BOX, (-x + 0.1, -y * 0.4, 2.8 * level - 1.4), (0.08, y * 0.55, 1.3), material=wall)
        if kit.chance(0.6):
            kit.add(BOX, (x - 0.1, -y * 0.62, 2.8 * level - 2.3), (0.08, y * 0.3, 0.5), material=wall)
    kit.add(BOX, (0.2 * x, y * 0.45, 1.4), (x * 0.7, 2.3, 0.12), rotation=turn("x", -36), material=slab)
    heap(kit, 0, y * 0.8, x * 0.9, y * 0.35, 0.9, slab)
    debris(kit, 7, 0, y * 0.8, x, y * 0.4, 0.5, (slab, wall), 0.4)
    for px in (-0.5, 0.1, 0.6):
        kit.between((px * x, -0.3 * y, 2.8 * storeys), (px * x + 0.2, -0.3 * y, 2.8 * storeys + 0.9), 0.03, material=dark)


def abbey(kit):
    rng = kit.rng
    wall = tinted(kit, (STONE, GREY, SAND), (BRICKS, CLOUDY, STREAKS), frequency=14, gloss=0.0)
    bays, pitch, y, spring = int(rng.integers(3, 5)), 2.0, rng.uniform(2.0, 2.6), rng.uniform(2.6, 3.6)
    kit.add(BOX, (0, 0, 0.06), (bays * 1.0 + 0.3, y + 0.4, 0.06), material=tinted(kit, ((0.1, 0.16, 0.05), EARTH), (CLOUDY,)))
    for side in (-1, 1):
        for k in range(bays + 1):
            x = (k - bays / 2) * pitch
            kit.add(BOX, (x, side * y, spring / 2), (0.3, 0.28, spring / 2), material=wall)
            whole = k < bays and (side > 0 or kit.chance(0.5))
            if whole:
                for way in (-1, 1):
                    kit.add(BOX, (x + 1.0 - way * 0.8, side * y, spring + 0.65), (0.22, 0.22, 0.65), (3.6, 1), (way * 0.5, 0), material=wall)
                if kit.chance(0.6):
                    kit.add(BOX, (x + 1, side * y, spring + 1.5), (1.0, 0.22, 0.25), (rng.uniform(0.5, 1), 1), material=wall)
    x, high = -bays * pitch / 2 - 0.2, spring + 1.4
    for side in (-1, 1):
        kit.add(BOX, (x, side * y * 0.78, high / 2), (0.28, y * 0.3, high / 2), material=wall)
        kit.add(BOX, (x, side * y * 0.5, high + 0.3), (0.26, 0.12, 1.1), (1, 5), (0, -side * y * 0.28), material=wall)
        kit.add(BOX, (x, side * y, high / 2 + 0.3), (0.4, 0.3, high / 2 + 0.3), (0.8, 0.8), material=wall)
    kit.add(BOX, (x, 0, high + 1.9), (0.26, y * 0.8, 0.6), (1, 0.1), material=wall)
    kit.add(BOX, (x, 0, 0.5), (0.25, y * 0.5, 0.5), material=wall)
    debris(kit, 5, 0, 0, bays * 0.8, y * 0.7, 0.3, (wall,))


def columns(kit):
    rng = kit.rng
    stone, count = tinted(kit, (STONE, WHITE, SAND), (CLOUDY, STREAKS), gloss=0.03), int(rng.integers(3, 7))
    for k in range(2):
        kit.add(BOX, (0, 0, 0.12 + 0.24 * k), (1.5 - 0.25 * k, count * 0.75 + 0.4 - 0.25 * k, 0.12), material=stone)
    whole = int(rng.integers(0, count - 1))
    for k in range(count):
        y, high = 1.5 * (k - (count - 1) / 2), 4.0 if whole <= k <= whole + 1 else rng.uniform(0.5, 3.4)
        kit.add(BOX, (0, y, 0.55), (0.5, 0.5, 0.07), material=stone)
        kit.add(CYL, (0, y, 0.6 + high / 2), (0.38, 0.38, high / 2), (1 - 0.05 * high, 1), material=stone._replace(pattern=RIBS, frequency=25.0))
        if high == 4.0:
            kit.add(CYL, (0, y, 4.68), (0.32, 0.32, 0.1), (1.5, 1), material=stone)
            kit.add(BOX, (0, y, 4.84), (0.5, 0.5, 0.08), material=stone)
    kit.add(BOX, (0, 1.5 * (whole + 0.5 - (count - 1) / 2), 5.15), (0.42, 1.3, 0.25), (1, 0.8), material=stone)
    for _ in range(4):
        at = (rng.choice([-1, 1]) * rng.uniform(1.9, 2.6), rng.uniform(-1, 1) * count * 0.6, 0.36)
        kit.add(CYL, at, (0.36, 0.36, rng.uniform(0.3, 0.7)), rotation=turn("z", rng.uniform(0, 180)) @ ALONG_X, material=stone)


def old_castle(kit):
    rng = kit.rng
    wall, dark, x = tinted(kit, (STONE, GREY, SAND), (BRICKS, CLOUDY), frequency=14, gloss=0.0), kit.material(dark=True), 3.2
    for k, (px, py) in enumerate(((x, x), (x, -x), (-x, x), (-x, -x))):
        high = rng.uniform(2.2, 5.5)
        kit.add(CYL, (px, py, high / 2), (1.05, 1.05, high / 2), (0.94, 1), material=wall)
        for a, b in around(5, 0.82, 20 * k):
            if kit.chance(0.75):
                kit.add(BOX, (px + a, py + b, high + 0.2), (0.24, 0.24, 0.35), (rng.uniform(0.4, 1), 1), material=wall)
        kit.add(BOX, (px * 1.29, py, high * 0.6), (0.1, 0.09, 0.4), material=dark)
    for spin in (0, 90, 180, 270):
        turned = turn("z", spin)
        for y in (-1.3, 0, 1.3):
            high = rng.uniform(0.6, 2.9)
            kit.add(BOX, turned @ [x, y, high / 2], (0.3, 0.68, high / 2), rotation=turned, material=wall)
            kit.add(BOX, turned @ [x, y, high + 0.2], (0.3, 0.5, 0.22), (1, 0.6), (0, rng.uniform(-0.2, 0.2)), turned, wall)
    kit.add(BOX, (-0.5, 0, 2.4), (1.3, 1.3, 2.4), (0.95, 0.95), material=wall)
    kit.add(BOX, (-1.3, 0, 5.1), (0.4, 1.1, 0.5), (1, 0.4), material=wall)


def stone_circle(kit):
    rng = kit.rng
    stone, count, radius = tinted(kit, (GREY, STONE, CONCRETE), (CLOUDY, SPECKLES, STREAKS), gloss=0.0), int(rng.integers(8, 14)), 4.5
    linteled, high = kit.chance(0.6), rng.uniform(1.6, 2.4)
    for k in range(count):
        spin = turn("z", 360 * k / count + (0 if linteled else rng.normal(0, 8)))
        tall = high if linteled else high * rng.uniform(0.5, 1.2)
        if kit.chance(0.15):
            kit.add(BOX, spin @ [radius + 0.5, 0, 0.25], (tall / 2, 0.45, 0.25), (0.9, 0.8), rotation=spin, material=stone)
            continue
        kit.add(BOX, spin @ [radius, 0, tall / 2], (0.28, 0.55, tall / 2), (rng.uniform(0.7, 0.95), rng.uniform(0.6, 0.9)), (0, rng.normal(0, 0.06)), spin, stone)
        if linteled and kit.chance(0.5):
            next_ = turn("z", 360 * (k + 0.5) / count)
            kit.add(BOX, spin @ turn("z", 180 / count) @ [radius * 0.97, 0, high + 0.2], (0.3, radius * np.pi / count * 1.15, 0.22), rotation=next_, material=stone)
            other = turn("z", 360 * (k + 1) / count)
            kit.add(BOX, other @ [radius, 0, high / 2], (0.27, 0.5, high / 2), (0.85, 0.75), rotation=other, material=stone)
    if kit.chance(0.5):
        for y in (-0.8, 0.8):
            kit.add(BOX, (-1, y, 1.5), (0.35, 0.5, 1.5), (0.8, 0.8), material=stone)
        kit.add(BOX, (-1, 0, 3.25), (0.42, 1.4, 0.27), material=stone)


def wrecked_car(kit):
    rng = kit.rng
    skin, dark, rim = rusty(kit) if kit.chance(0.6) else drab(kit), kit.material(dark=True, gloss=0.0), rusty(kit)
    sunk = rng.uniform(0, 0.08)
    kit.add(BOX, (0, 0, 0.4), (2.0, 0.8, 0.17), material=skin)
    kit.add(BOX, (-1.6, 0, 0.66), (0.45, 0.8, 0.14), (0.9, 0.95), material=skin)
    kit.add(BOX, (0, 0.76, 0.62), (1.2, 0.05, 0.16), material=skin, mirror=True)
    kit.add(BOX, (1.35, 0.76, 0.62), (0.6, 0.08, 0.16), material=skin, mirror=True)
    kit.add(BOX, (1.3, 0, 0.62), (0.35, 0.3, 0.2), material=dark)
    rise = rng.choice([0, rng.uniform(15, 50)])
    kit.add(BOX, np.array([0.7, 0, 0.82]) + turn("y", -rise) @ [0.62, 0, 0], (0.62, 0.74, 0.035), rotation=turn("y", -rise), material=skin)
    for start, end in (((0.75, 0.74, 0.78), (0.2, 0.6, 1.36)), ((-0.25, 0.76, 0.78), (-0.25, 0.6, 1.36)), ((-1.25, 0.74, 0.78), (-0.85, 0.6, 1.36))):
        kit.between(start, end, 0.045, BOX, material=skin, mirror=True)
    kit.add(BOX, (-0.32, 0, 1.38), (0.6, 0.66, 0.04), rotation=turn("x", rng.normal(0, 4)), material=skin)
    for x in (0.3, -0.7):
        kit.add(BOX, (x, 0.35, 0.75), (0.08, 0.25, 0.25), rotation=turn("y", -15), material=dark, mirror=True)
    kit.add(TUBE, (0.55, 0.35, 0.9), (0.17, 0.17, 0.02), rotation=turn("y", -60), material=dark)
    kit.between((0.75, 0.35, 0.75), (0.55, 0.35, 0.9), 0.03, material=dark)
    for x in (1.3, -1.25):
        for side in (-1, 1):
            if kit.chance(0.8):
                kit.add(CYL, (x, side * 0.8, 0.26 - sunk * 0.5), (0.25, 0.25, 0.1), rotation=ALONG_Y, material=rim if kit.chance(0.6) else dark)
                kit.add(CYL, (x, side * 0.82, 0.26 - sunk * 0.5), (0.14, 0.14, 0.1), rotation=ALONG_Y, material=dark)
            else:
                kit.add(BOX, (x, side * 0.6, 0.15), (0.18, 0.18, 0.15), material=cast(kit))
    kit.add(BOX, (2.02, 0, 0.5), (0.05, 0.75, 0.1), rotation=turn("x", rng.normal(0, 5)), material=dark)


def wrecked_tank(kit):
    rng = kit.rng
    paint, dark, rust = drab(kit), kit.material(dark=True, gloss=0.0), rusty(kit)
    paint = paint if kit.chance(0.4) else rust
    kit.add(BOX, (-0.1, 0, 0.95), (2.9, 1.15, 0.4), (0.88, 1), (-0.1, 0), material=paint)
    kit.add(BOX, (-0.2, 1.35, 1.05), (2.7, 0.35, 0.06), material=paint, mirror=True)
    kit.add(BOX, (0, 1.35, 0.5), (2.3, 0.27, 0.42), (1.3, 1), material=dark, mirror=True)
    for x in np.linspace(-2, 2, 6):
        kit.add(CYL, (x, 1.55, 0.42), (0.36, 0.36, 0.12), rotation=ALONG_Y, material=rust, mirror=True)
    for x in (-2.75, 2.75):
        kit.add(CYL, (x, 1.35, 0.75), (0.35, 0.35, 0.27), rotation=ALONG_Y, material=dark, mirror=True)
    kit.add(TUBE, (0, 0, 1.4), (0.95, 0.95, 0.08), material=rust)
    kit.add(CYL, (0, 0, 1.36), (0.9, 0.9, 0.03), material=dark)
    kit.add(BOX, (-2.0, 0, 1.37), (0.5, 0.8, 0.03), material=dark, cut=(RUNGS, 5, 0.5))
    first = len(kit.primitives)
    kit.add(CYL, (0, 0, 0), (1.2, 1.05, 0.3), (0.7, 1), material=paint)
    kit.add(BOX, (-1.1, 0, 0.05), (0.5, 0.7, 0.22), material=paint)
    kit.between((0.7, 0, 0), (3.6, 0, 0.05), 0.1, CYL, 0.8, material=paint)
    kit.between((1.8, 0, 0), (2.3, 0, 0.02), 0.14, material=paint)
    kit.add(CYL, (-0.2, 0.4, 0.34), (0.3, 0.3, 0.08), material=paint)
    kit.add(CYL, (0, 0, -0.33), (0.85, 0.8, 0.04), material=dark)
    swing(kit, first, turn("z", rng.uniform(-40, 40)) @ turn("x", rng.choice([160, 200, 30])), (rng.uniform(-1, 1), rng.choice([-3.2, 3.2]), 0))


def burnt_lorry(kit):
    rng = kit.rng
    rust, dark, long = rusty(kit), kit.material(dark=True, gloss=0.0), rng.uniform(2.6, 3.6)
    for side in (-1, 1):
        kit.add(BOX, (0, side * 0.45, 0.75), (long, 0.06, 0.1), material=rust)
    for x in (long - 0.9, -long + 0.9, *((-long + 2.0,) if kit.chance(0.5) else ())):
        kit.between((x, -0.95, 0.36), (x, 0.95, 0.36), 0.08, material=dark)
        kit.add(BOX, (x, 0, 0.53), (0.12, 0.5, 0.14), material=dark)
        kit.add(CYL, (x, 0.95, 0.3), (0.3, 0.3, 0.1), rotation=ALONG_Y, material=rust, mirror=True)
        kit.add(CYL, (x, 0.98, 0.3), (0.17, 0.17, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
    x = long - 0.7
    kit.add(BOX, (x, 0, 1.2), (0.75, 1.05, 0.4), material=rust)
    for px in (0.68, -0.68):
        kit.between((x + px, 0.98, 1.5), (x + px * 0.9, 0.9, 2.35), 0.06, BOX, material=rust, mirror=True)
    kit.add(BOX, (x - 0.68, 0, 1.95), (0.04, 0.9, 0.4), material=rust)
    kit.add(BOX, (x, 0, 2.38), (0.72, 0.98, 0.05), rotation=turn("y", rng.uniform(-6, 6)), material=rust)
    kit.add(BOX, (long + 0.05, 0, 1.15), (0.03, 0.6, 0.22), material=dark, cut=(RUNGS, 7, 0.5))
    kit.add(TUBE, (x + 0.4, 0.5, 1.75), (0.22, 0.22, 0.02), rotation=turn("y", -40), material=dark)
    kit.between((x + 0.5, 0.5, 1.5), (x + 0.4, 0.5, 1.75), 0.03, material=dark)
    middle, half = -0.75, long - 0.8
    kit.add(BOX, (middle, 0, 0.9), (half, 1.1, 0.05), material=rust)
    for px in np.linspace(-0.97, 0.97, 5) * half + middle:
        kit.between((px, 1.06, 0.9), (px, 1.06, 2.2), 0.035, BOX, material=rust, mirror=True)
        kit.between((px, -1.06, 2.2), (px, 1.06, 2.2), 0.035, BOX, material=rust)
    kit.add(BOX, (middle, -1.08, 1.2), (half, 0.03, 0.25), material=rust)


def crashed_plane(kit):
    rng = kit.rng
    skin, dark, earth = tinted(kit, (WHITE, OLIVE, GREY, SAND), (STREAKS, SEAMS, CLOUDY), frequency=8, gloss=0.15), kit.material(dark=True, gloss=0.0), soil(kit)
    kit.loft((-0.4, 0, 0.62), [(0, 0.55), (1.4, 0.62), (2.6, 0.55), (3.2, 0.36)], skin, axis=ALONG_X)
    kit.add(BALL, (2.8, 0, 0.62), (0.45, 0.36, 0.36), material=skin)
    kit.add(CYL, (-0.42, 0, 0.62), (0.5, 0.5, 0.02), rotation=ALONG_X, material=dark)
    kit.add(BALL, (1.3, 0, 1.1), (0.8, 0.4, 0.4), material=glazing(kit))
    kit.add(BOX, (0.9, 2.0, 0.3), (0.65, 1.8, 0.09), (1, 1), rotation=turn("x", -4), material=skin)
    for angle in (40, 160, 280):
        spin = turn("x", angle)
        kit.add(BOX, np.array([3.25, 0, 0.62]) + spin @ [0, 0, 0.36], (0.03, 0.09, 0.35), (1, 0.7), (-0.3, 0), spin, dark)
    kit.add(CYL, (3.25, 0, 0.62), (0.14, 0.14, 0.15), (0.4, 1), rotation=ALONG_X, material=skin)
    first = len(kit.primitives)
    kit.loft((-2.6, 0, 0), [(0, 0.22), (2.6, 0.52)], skin, axis=ALONG_X)
    kit.add(CYL, (0.02, 0, 0), (0.47, 0.47, 0.02), rotation=ALONG_X, material=dark)
    kit.add(BOX, (-2.3, 0, 0.75), (0.45, 0.05, 0.6), (0.6, 1), (-0.3, 0), material=skin)
    kit.add(BOX, (-2.3, 0, 0.1), (0.35, 1.2, 0.05), material=skin)
    swing(kit, first, turn("z", rng.uniform(-35, 35)) @ turn("x", rng.uniform(-20, 20)), (-0.9, 0.3, 0))
    kit.add(BOX, (0.3, -2.6, 0.12), (0.65, 1.6, 0.08), rotation=turn("z", rng.uniform(-50, 50)), material=skin)
    heap(kit, 2.9, 0, 0.9, 1.0, 0.35, earth)
    debris(kit, 8, 0, 0, 2.5, 2.2, 0.22, (skin, dark))


def beached_boat(kit):
    rng = kit.rng
    hull, wood, dark = tinted(kit, (BLUE, WHITE, RED, GREEN, RUST), (STREAKS, PLANKS, CLOUDY), frequency=9), timber(kit), kit.material(dark=True)
    if kit.chance(0.5):
        for k, x in enumerate(np.linspace(-2.4, 2.4, 9)):
            wide = 1.1 * np.sqrt(max(1 - (x / 2.9) ** 2, 0.05))
            tall = rng.uniform(0.6, 1.3)
            kit.between((x, 0.05, 0.12), (x, wide * 0.8, 0.35), 0.06, BOX, material=wood, mirror=True)
            kit.between((x, wide * 0.8, 0.33), (x, wide, 0.35 + tall), 0.06, BOX, material=wood, mirror=True)
        kit.add(BOX, (0, 0, 0.1), (2.9, 0.09, 0.1), material=wood)
        kit.between((2.7, 0, 0.1), (3.2, 0, 1.7), 0.09, BOX, material=wood)
        kit.between((-2.7, 0, 0.1), (-2.9, 0, 1.3), 0.09, BOX, material=wood)
        for z, wide in ((0.4, 0.84), (0.65, 0.92)):
            kit.add(BOX, (-0.2, wide * 0.95, z), (1.4, 0.03, 0.11), material=wood, mirror=True)
    else:
        for x, half, w, lift in ((-1.9, 0.7, 0.95, 0.05), (-0.6, 0.7, 1.1, 0), (0.7, 0.7, 1.05, 0.05)):
            kit.add(BOX, (x, 0, 0.6 + lift), (half, w * 0.6, 0.6), (1, 1.6), material=hull)
        kit.add(BOX, (1.9, 0, 0.7), (0.55, 0.5, 0.6), (1.5, 1.7), (0.25, 0), material=hull)
        kit.add(BOX, (2.75, 0, 0.95), (0.35, 0.22, 0.5), (1.5, 1.3), (0.25, 0), material=hull)
        kit.add(BOX, (-1.0, 0, 1.6), (0.7, 0.6, 0.5), (0.9, 0.9), material=tinted(kit, (WHITE, RUST, WOOD)))
        kit.add(BOX, (-1.0, 0, 1.72), (0.5, 0.6, 0.2), material=dark)
        kit.add(BOX, (0.8, 0, 1.25), (0.5, 0.55, 0.03), material=dark)
        kit.between((0.1, 0, 1.1), (0.2, 0, 3.4), 0.06, material=wood)
        kit.between((0.15, 0, 1.5), (1.4, 0, 2.6), 0.04, material=wood)
    swing(kit, 0, turn("x", rng.choice([-1, 1]) * rng.uniform(12, 32)))
    sand = tinted(kit, (SAND,), (CLOUDY,), gloss=0.0)
    heap(kit, 0, 0, 2.6, 1.2, 0.3, sand)


def broken_bridge(kit):
    rng = kit.rng
    stone, dark = masonry(kit), kit.material(dark=True)
    gap = int(rng.integers(1, 3))
    for k in range(5):
        x = 3.0 * (k - 2)
        kit.add(BOX, (x, 0, 1.3), (0.45, 1.1, 1.3), (0.9, 0.9), material=stone)
        if k == 4:
            continue
        angles = np.linspace(np.pi, 0, 6)
        for n in range(5):
            if k == gap and 0 < n < 4:
                continue
            a, b = ([x + 1.5 + 1.2 * np.cos(t), 0, 2.5 + 1.1 * np.sin(t)] for t in angles[n : n + 2])
            kit.between(a, b, (0.2, 1.0), BOX, material=stone)
        if k != gap:
            kit.add(BOX, (x + 1.5, 0, 3.75), (1.5, 1.0, 0.17), material=stone)
            kit.add(BOX, (x + 1.5, 0.95, 4.1), (1.5, 0.1, 0.25), material=stone, mirror=True)
            for side in (0.25, 2.75):
                kit.add(BOX, (x + side, 0, 3.15), (0.3, 0.98, 0.5), material=stone)
    debris(kit, 7, 3.0 * (gap - 2) + 1.5, 0, 0.9, 1.0, 0.4, (stone, dark))


def barn(kit):
    rng = kit.rng
    wood, frame, tin = timber(kit), kit.material(dark=True, gloss=0.0), tinted(kit, (RUST, GREY), (RIBS, STREAKS), frequency=14)
    x, y, eave, top = rng.uniform(2.6, 3.6), rng.uniform(1.8, 2.4), rng.uniform(2.0, 2.5), rng.uniform(3.6, 4.4)
    lean, slope = rng.uniform(-0.5, 0.5), np.hypot(y, top - eave)
    for px in np.linspace(-1, 1, 5) * x:
        for side in (-1, 1):
            kit.between((px, side * y, 0), (px, side * y + lean, eave), 0.08, BOX, material=frame)
            kit.between((px, side * y + lean, eave), (px, lean, top), 0.06, BOX, material=frame)
    kit.between((-x, lean, top), (x, lean, top), 0.08, BOX, material=frame)
    for side in (-1, 1):
        for k in range(4):
            px = (-0.75 + 0.5 * k) * x
            if kit.chance(0.65):
                kit.add(BOX, (px, side * y, eave / 2), (x * 0.245, 0.04, eave / 2), shift=(0, lean), material=wood)
            if kit.chance(0.55):
                spin = turn("x", -side * np.degrees(np.arctan2(top - eave, y)))
                kit.add(BOX, (px, side * y * 0.5 + lean, (eave + top) / 2 + 0.06), (x * 0.25, slope / 2 + 0.12, 0.035), rotation=spin, material=tin)
    for px in (-x, x):
        for side in (-1, 1):
            if kit.chance(0.75):
                kit.add(BOX, (px, side * y * 0.68, eave / 2), (0.04, y * 0.32, eave / 2), shift=(0, lean), material=wood)
        if kit.chance(0.7):
            kit.add(BOX, (px, lean, (eave + top) / 2), (0.04, y, (top - eave) / 2), (1, 0.03), material=wood)
    debris(kit, 5, 0, y * 1.3, x, 0.5, 0.4, (wood, tin))


def overgrown_hut(kit):
    rng = kit.rng
    wall, dark, green = masonry(kit), kit.material(dark=True), tinted(kit, (GREEN, (0.1, 0.2, 0.04), (0.15, 0.2, 0.06)), (CLOUDY, SPECKLES), frequency=20, gloss=0.0)
    x, y, high = rng.uniform(1.6, 2.4), rng.uniform(1.3, 1.7), rng.uniform(1.9, 2.3)
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=wall)
    kit.add(BOX, (0, 0, high + 0.5), (x, y, 0.5), (1, 0.03), material=wall)
    roof, steep = tinted(kit, (RUST, (0.4, 0.13, 0.06), GREY), (RIBS, STREAKS), frequency=12), np.degrees(np.arctan2(1.0, y))
    for side in (-1, 1):
        for px in (-0.5, 0.5):
            if side > 0 or px > 0 or kit.chance(0.4):
                kit.add(BOX, (px * x * 1.05, side * y * 0.53, high + 0.5), (x * 0.55, np.hypot(1, y) * 0.55, 0.05), rotation=turn("x", -side * steep), material=roof)
    kit.add(BOX, (x, 0, 0.85), (0.03, 0.4, 0.85), material=dark)
    for px in (-0.5, 0.5):
        kit.add(BOX, (px * x, 0, high * 0.58), (0.3, y + 0.03, 0.32), material=dark)
    for _ in range(14):
        side, size = rng.choice([-1, 1]), rng.uniform(0.3, 0.75)
        at = (rng.uniform(-1, 1) * x, side * (y + 0.1), size * 0.8) if kit.chance(0.7) else (-x, rng.uniform(-1, 1) * y, size)
        kit.add(BALL, at, (size, size * 0.7, size * rng.uniform(0.8, 1.5)), material=green, cut=(LEAVES, 4, 0.58))
    kit.add(BALL, (-x * 0.5, -y * 0.5, high + 0.6), (0.9, 0.7, 0.4), material=green, cut=(LEAVES, 4, 0.58))


def rubble(kit):
    wall, slab, dark = masonry(kit), cast(kit), metal(kit)
    heap(kit, 0, 0, 2.2, 1.8, 1.1, wall._replace(pattern=SPECKLES, frequency=14.0))
    for k in range(40):
        angle, out = kit.rng.uniform(0, 2 * np.pi), kit.rng.uniform(0, 1) ** 0.5
        debris(kit, 1, 2.2 * out * np.cos(angle), 1.8 * out * np.sin(angle), 0.05, 0.05, kit.rng.uniform(0.2, 0.5), (wall, slab), 1.05 * (1 - out))
    for _ in range(6):
        x, y = kit.rng.uniform(-0.8, 0.8, 2)
        kit.between((x, y, 0.5), (x * 1.8, y * 1.8, kit.rng.uniform(1.3, 1.9)), 0.035, BOX, material=dark)


def timber_pile(kit):
    rng = kit.rng
    wood, logs = timber(kit), kit.chance(0.4)
    if logs:
        bark, cut_end, radius, base = tinted(kit, (WOOD, GREY), (STREAKS, CLOUDY)), tinted(kit, ((0.5, 0.36, 0.2),)), 0.25, int(rng.integers(4, 7))
        for level in range(min(base, 4)):
            for k in range(base - level):
                at = (rng.normal(0, 0.06), (2 * k + level - base + 1) * radius, radius * (1 + 1.73 * level))
                kit.add(CYL, at, (radius, radius, 2.0), rotation=ALONG_X, material=bark)
                kit.add(CYL, at, (radius * 0.85, radius * 0.85, 2.01), rotation=ALONG_X, material=cut_end)
    elif kit.chance(0.5):
        for level in range(int(rng.integers(3, 7))):
            for k in range(6):
                kit.add(BOX, (rng.normal(0, 0.07), 0.3 * (k - 2.5), 0.15 + 0.17 * level), (1.9, 0.13, 0.055), material=wood)
            for x in (-1.3, 1.3):
                kit.add(BOX, (x, 0, 0.05 + 0.17 * level), (0.06, 0.9, 0.05), material=wood)
    else:
        heap(kit, 0, 0, 1.2, 1.0, 0.6, wood)
        for _ in range(32):
            spin = turn("z", rng.uniform(0, 180)) @ turn("y", rng.uniform(-16, 16))
            kit.add(BOX, (*rng.normal(0, 0.35, 2), rng.uniform(0.3, 0.85)), (rng.uniform(0.7, 1.5), 0.09, 0.04), rotation=spin, material=wood)


def scrap_heap(kit):
    rng = kit.rng
    heap(kit, 0, 0, 1.9, 1.7, 1.3, rusty(kit))
    mats = [rusty(kit), metal(kit), drab(kit), tinted(kit, (BLUE, RED, WHITE, YELLOW))]
    for k in range(52):
        angle, out = rng.uniform(0, 2 * np.pi), rng.uniform(0, 1) ** 0.5
        at = (1.8 * out * np.cos(angle), 1.6 * out * np.sin(angle), 0.25 + 1.2 * (1 - out))
        spin, mat, size = turn("z", rng.uniform(0, 180)) @ turn("x", rng.uniform(-60, 60)), mats[rng.integers(4)], rng.uniform(0.2, 0.5)
        form = rng.choice(["sheet", "pipe", "drum", "ring", "beam"])
        if form in ("pipe", "drum", "ring"):
            kit.add(CYL if form != "ring" else TUBE, at, {"pipe": (0.06, 0.06, 2 * size), "drum": (0.2, 0.2, 0.3), "ring": (0.3, 0.3, 0.1)}[form], rotation=spin, material=mat)
        else:
            kit.add(BOX, at, (size, size * 0.8, 0.03) if form == "sheet" else (2 * size, 0.06, 0.08), rotation=spin, material=mat)


def bare_frame(kit):
    rng = kit.rng
    slab, steel = cast(kit) if kit.chance(0.6) else tinted(kit, (RED, RUST, GREY)), metal(kit)
    storeys, x, y, open_ = int(rng.integers(2, 5)), rng.uniform(3, 4.5), rng.uniform(2.2, 3), kit.chance(0.35)
    kit.add(BOX, (0, 0, 0.1), (x + 0.3, y + 0.3, 0.1), material=slab)
    for level in range(storeys):
        z, top = 0.2 + 2.9 * level, level == storeys - 1
        for px in np.linspace(-1, 1, 4 if storeys < 4 else 3) * x * 0.96:
            for py in (-0.95, 0.95):
                kit.add(BOX, (px, py * y, z + 1.35), (0.16, 0.16, 1.4), material=slab)
                if top:
                    kit.between((px, py * y, z + 2.9), (px, py * y, z + 3.7), 0.04, material=steel)
        if open_:
            kit.add(BOX, (0, 0, z + 2.75), (x, y, 0.12), material=slab, cut=(GRID, 1 / 1.5, 0.15))
        else:
            kit.add(BOX, (0, 0, z + 2.75), (x, y, 0.14), material=slab)
        if level < 2:
            kit.between((-x * 0.3, 0, z), (x * 0.4, 0, z + 2.8), (0.1, 0.5), BOX, material=slab)


def scaffolded(kit):
    rng = kit.rng
    wall, steel, plank, dark = masonry(kit), metal(kit, 0.3, 0.55), timber(kit), kit.material(dark=True)
    x, y, storeys = rng.uniform(2.6, 3.4), rng.uniform(2, 2.6), 2
    high = 2.6 * storeys
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=wall)
    for level in range(storeys):
        for px in (-0.55, 0.1, 0.65):
            kit.add(BOX, (px * x, 0, 2.6 * level + 1.5), (0.4, y + 0.02, 0.55), material=dark)
    kit.add(BOX, (x, 0, 1.05), (0.03, 0.5, 1.05), material=dark)
    for px in np.linspace(-1, 1, 5) * x:
        kit.between((px, y, high), (px, 0, high + 1.7), 0.06, BOX, material=plank, mirror=True)
    kit.between((-x, 0, high + 1.7), (x, 0, high + 1.7), 0.07, BOX, material=plank)
    for px in (-x + 0.12, x - 0.12):
        kit.add(BOX, (px, 0, high + 0.7), (0.12, y * 0.95, 0.7), (1, 0.1), material=wall)
    for px in np.linspace(-1.05, 1.05, 4) * x:
        for py in (y + 0.25, y + 1.0):
            kit.between((px, py, 0), (px, py, high + 0.9), 0.04, material=steel)
    for z in (1.9, 3.8, high):
        kit.add(BOX, (0, y + 0.62, z), (x * 1.08, 0.42, 0.04), material=plank)
        kit.between((-x * 1.08, y + 1.0, z + 0.8), (x * 1.08, y + 1.0, z + 0.8), 0.03, material=steel)
    kit.between((-x, y + 1.02, 0), (x * 0.0, y + 1.02, 3.8), 0.03, material=steel)
    ladder(kit, (x * 0.9, y + 1.35, 0), (x * 0.9, y + 0.8, 2.1), 0.2, steel)
