"""Churches, chapels, pagodas, mosques; arched openings, spires, domes."""

import numpy as np

from .dwellings import (
    BLUE,
    BRICK,
    CLAY,
    COPPER,
    CREAM,
    GOLD,
    GREEN,
    GREY,
    OCHRE,
    PINK,
    RED,
    SAND,
    SLATE,
    STONE,
    TILE,
    TIMBER,
    WHITE,
    WOOD,
    boards,
    brickwork,
    door,
    leaf,
    lights,
    masonry,
    panes,
    render,
    roof,
    row,
    tiles,
)
from .installations import tinted
from .kit import ALONG_X, ALONG_Y, around
from .layout import BALL, BOX, CYL, PRISM
from .materials import BANDS, CLOUDY, PLAIN, PLANKS, SEAMS, SHINGLES, STREAKS, STRIPES


def arched(kit, at, half, places, wide, low, high, material, facing=0, out=0.05):
    """Round-headed openings, seen in both opposite walls, from `low` to the arch's spring `high`."""
    for place in places:
        point = np.array(at, float) + np.eye(3)[1 - facing] * place
        deep = half[facing] + out
        reach = (wide, deep, (high - low) / 2) if facing else (deep, wide, (high - low) / 2)
        kit.add(BOX, point + [0, 0, (low + high) / 2], reach, material=material)
        kit.add(CYL, point + [0, 0, high], (wide, wide, deep), rotation=ALONG_Y if facing else ALONG_X, material=material)


def spire(kit, x, y, z, half, tall, material, sides=4):
    if sides == 4:
        kit.add(BOX, (x, y, z + tall / 2), (half, half, tall / 2), (0.02, 0.02), material=material)
    else:
        kit.add(PRISM, (x, y, z + tall / 2), (half, half, tall / 2), (0.02, sides), material=material)


def cross(kit, x, y, z, size, material):
    kit.add(BOX, (x, y, z + size * 0.6), (size * 0.07, size * 0.07, size * 0.7), material=material)
    kit.add(BOX, (x, y, z + size * 0.85), (size * 0.07, size * 0.38, size * 0.07), material=material)


def clock(kit, at, half, size, rim):
    """Four dials around a tower."""
    face, hand = tinted(kit, (WHITE, WHITE, TIMBER)), tinted(kit, (GOLD, TIMBER))
    for axis in (ALONG_X, ALONG_Y):
        kit.add(CYL, at, (size, size, half + 0.05), rotation=axis, material=rim)
        kit.add(CYL, at, (size * 0.85, size * 0.85, half + 0.08), rotation=axis, material=face)
    for reach in ((half + 0.11, size * 0.06, size * 0.7), (size * 0.06, half + 0.11, size * 0.7)):
        kit.add(BOX, at, reach, material=hand)


def onion(kit, x, y, z, radius, material):
    profile = [(0, 0.62), (0.42, 1.0), (0.95, 0.88), (1.4, 0.45), (1.75, 0.18), (2.3, 0.03)]
    kit.loft((x, y, z), [(h * radius, r * radius) for h, r in profile], material)


def village_church(kit):
    rng = kit.rng
    walls, cover, glass = (masonry, render, brickwork, boards)[rng.integers(4)](kit), tiles(kit), panes(kit)
    frame, gold = tinted(kit, (WHITE, STONE, GREY)), tinted(kit, (GOLD, GREY, TIMBER))
    x, y, high = rng.uniform(5, 8), rng.uniform(2.6, 3.8), rng.uniform(3.6, 5)
    rise = y * rng.uniform(0.9, 1.5)
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    roof(kit, (0, 0, high), (x, y), rise, "gable", 0.3, cover, walls, 0)
    arched(kit, (0, 0, 0), (x, y), row(4, x, 0.75), 0.42, 1.3, 2.7, frame, 1, 0.04)
    arched(kit, (0, 0, 0), (x, y), row(4, x, 0.75), 0.32, 1.4, 2.7, glass, 1, 0.07)
    if kit.chance(0.4) and walls.pattern != PLANKS:
        for place in np.linspace(-0.95, 0.95, 5):
            kit.add(BOX, (place * x, 0, high * 0.42), (0.22, y + 0.55, high * 0.42), (1, 0.93), material=walls)
    style, half = rng.choice(["front", "front", "side", "ridge"]), rng.uniform(1.5, 2.1)
    tall = high + rise * rng.uniform(0.7, 1.3) + 1.5
    at, across = (x + half * 0.7, 0.0) if style == "front" else (x * 0.6, rng.choice([-1, 1]) * (y + half * 0.9)) if style == "side" else (x * 0.72, 0.0)
    low = 0.0
    if style == "ridge":
        half, low, tall = half * 0.6, high + rise * 0.4, high + rise + 1.5
    kit.add(BOX, (at, across, (low + tall) / 2), (half, half, (tall - low) / 2), material=walls)
    kit.add(BOX, (at, across, tall), (half + 0.15, half + 0.15, 0.14), material=frame)
    cap = rng.choice(["spire", "spire", "saddle", "pyramid", "octagon", "battlement"])
    top = tall + 0.1
    if cap == "saddle":
        roof(kit, (at, across, top), (half, half), half * 1.2, "gable", 0.15, cover, walls, 1)
        top += half * 1.2
    elif cap == "battlement":
        battlements(kit, at, across, top, half, half, walls)
        top += 0.5
    else:
        long = half * {"spire": rng.uniform(2.6, 4.5), "pyramid": 1.2, "octagon": rng.uniform(3, 4.5)}[cap]
        spire(kit, at, across, top, half * 1.06, long, cover, 8 if cap == "octagon" else 4)
        top += long - 0.1
    if cap != "battlement":
        cross(kit, at, across, top, 1.1, gold)
    arched(kit, (at, across, 0), (half, half), [0], half * 0.36, tall - 1.6, tall - 0.9, kit.material(dark=True), 0)
    arched(kit, (at, across, 0), (half, half), [0], half * 0.36, tall - 1.6, tall - 0.9, kit.material(dark=True), 1)
    if style != "ridge" and kit.chance(0.5):
        clock(kit, (at, across, tall - 2.9), half, half * 0.4, frame)
    front = at + half if style == "front" else x
    door(kit, (front, 0, 0), (0.75, 1.1), leaf(kit), frame)
    kit.add(CYL, (front, 0, 2.25), (0.75, 0.75, 0.09), rotation=ALONG_X, material=frame)
    if kit.chance(0.6):
        kit.add(CYL, (-x, 0, high * 0.42), (y * 0.72, y * 0.72, high * 0.42), material=walls)
        kit.add(CYL, (-x, 0, high * 0.84 + rise * 0.25), (y * 0.82, y * 0.82, rise * 0.25), (0.05, 1), material=cover)
    if kit.chance(0.6):
        side = rng.choice([-1, 1]) if style != "side" else -np.sign(across)
        kit.add(BOX, (-x * 0.55, side * (y + 1.1), 1.25), (x * 0.3, 1.2, 1.25), material=walls)
        kit.add(BOX, (-x * 0.55, side * (y + 1.1), 3.0), (x * 0.34, 1.5, 0.55), (1, 0.02), (0, -side * 1.4), material=cover)
        lights(kit, (-x * 0.55, side * (y + 1.1), 1.4), (x * 0.3, 1.2), [0], (0.4, 0.45), glass, frame, 1, False)


def battlements(kit, x, y, z, half_x, half_y, material, size=0.3):
    """Merlons along the four edges of a roof: bars of which parts stay."""
    for axis, away in ((0, half_y), (1, half_x)):
        long = half_x if axis == 0 else half_y
        for place in row(4, long, 1.0):
            for side in (-1, 1):
                spot = (place, side * (away - size * 0.4)) if axis == 0 else (side * (away - size * 0.4), place)
                reach = (long * 0.13, size * 0.4) if axis == 0 else (size * 0.4, long * 0.13)
                kit.add(BOX, (x + spot[0], y + spot[1], z + size), (*reach, size), material=material)


def onion_church(kit):
    rng = kit.rng
    walls = tinted(kit, (WHITE, WHITE, CREAM, PINK, BLUE, BRICK), (PLAIN, CLOUDY))
    dome, gold = tinted(kit, (GOLD, (0.05, 0.12, 0.4), COPPER, GREEN, SLATE), (PLAIN, SHINGLES, STRIPES), frequency=18, gloss=0.4), tinted(kit, (GOLD,), gloss=0.4)
    frame, dark = tinted(kit, (WHITE, CREAM)), panes(kit)
    if kit.chance(0.4):  # Bavarian: a nave, a tower with an onion
        x, y, high = rng.uniform(5, 7), rng.uniform(2.8, 3.5), 4.5
        kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
        roof(kit, (0, 0, high), (x, y), y * 1.1, "gable", 0.3, tiles(kit), walls, 0)
        arched(kit, (0, 0, 0), (x, y), row(4, x, 0.75), 0.45, 1.3, 2.9, dark, 1)
        kit.add(BOX, (x + 1, 0, 4.8), (1.6, 1.6, 4.8), material=walls)
        kit.add(PRISM, (x + 1, 0, 10.2), (1.45, 1.45, 0.7), (1, 8), material=walls)
        kit.add(BOX, (x + 1, 0, 9.6), (1.75, 1.75, 0.13), material=frame)
        clock(kit, (x + 1, 0, 8.4), 1.6, 0.75, frame)
        onion(kit, x + 1, 0, 10.8, 1.75, dome)
        cross(kit, x + 1, 0, 14.6, 1.2, gold)
        door(kit, (x + 2.6, 0, 0), (0.7, 1.2), leaf(kit), frame)
        return
    half, high = rng.uniform(3.4, 4.4), rng.uniform(5, 7)
    kit.add(BOX, (0, 0, high / 2), (half, half, high / 2), material=walls)
    kit.add(BOX, (0, 0, high), (half + 0.25, half + 0.25, 0.2), material=frame)
    kit.add(BOX, (0, 0, high + 0.5), (half, half, 0.4), (0.5, 0.5), material=tinted(kit, (GREEN, GREY)))
    arched(kit, (0, 0, 0), (half, half), row(3, half, 0.85), 0.32, high * 0.4, high * 0.65, dark, 0)
    arched(kit, (0, 0, 0), (half, half), row(3, half, 0.85), 0.32, high * 0.4, high * 0.65, dark, 1)
    spots = [(0.0, 0.0, half * 0.36, 3.0)]
    if kit.chance(0.75):
        spots += [(i * half * 0.62, j * half * 0.62, half * 0.2, 1.8) for i in (-1, 1) for j in (-1, 1)]
    for px, py, radius, tall in spots:
        kit.add(CYL, (px, py, high + tall / 2), (radius, radius, tall / 2), material=walls)
        kit.add(CYL, (px, py, high + tall * 0.62), (radius + 0.03, radius * 0.35, tall * 0.2), material=dark)
        onion(kit, px, py, high + tall, radius * 1.45, dome)
        cross(kit, px, py, high + tall + radius * 3.1, radius * 1.2, gold)
    kit.add(CYL, (-half, 0, high * 0.35), (half * 0.5, half * 0.5, high * 0.35), material=walls)
    kit.add(BALL, (-half, 0, high * 0.7), (half * 0.52, half * 0.52, half * 0.25), material=tinted(kit, (GREEN, GREY)))
    door(kit, (half, 0, 0), (0.7, 1.1), leaf(kit), frame)


def stave_church(kit):
    rng = kit.rng
    wood = tinted(kit, (TIMBER, WOOD, (0.12, 0.06, 0.03)), (STRIPES, PLANKS), frequency=rng.uniform(20, 32), gloss=0.02)
    cover = tinted(kit, (TIMBER, (0.1, 0.05, 0.025), SLATE), (SHINGLES,), frequency=26, gloss=0.02)
    x, y, z = rng.uniform(4.2, 5.4), rng.uniform(3, 3.8), 0.0
    for share, tall in ((1.0, 1.7), (0.68, 2.4)):
        hx, hy = x * share, y * share
        kit.add(BOX, (0, 0, z + tall / 2), (hx, hy, tall / 2), material=wood)
        kit.add(BOX, (0, 0, z + tall + 0.6), (hx + 0.4, hy + 0.4, 0.65), (0.74, 0.64), material=cover)
        lights(kit, (0, 0, z + tall * 0.6), (hx, hy), row(4, hx), (0.2, 0.25), panes(kit), wood, 1, False)
        z += tall + 0.6
    kit.add(BOX, (0, 0, z + 0.8), (x * 0.45, y * 0.42, 0.8), material=wood)
    rise = y * rng.uniform(0.9, 1.2)
    roof(kit, (0, 0, z + 1.6), (x * 0.45, y * 0.42), rise, "gable", 0.35, cover, wood, 0)
    ridge = z + 1.6 + rise
    half = 0.75
    for tall in (1.5, 1.1):
        kit.add(BOX, (0, 0, ridge + tall / 2 - 0.5), (half, half, tall / 2 + 0.3), material=wood)
        kit.add(BOX, (0, 0, ridge + tall + 0.05), (half + 0.3, half + 0.3, 0.35), (0.45, 0.45), material=cover)
        ridge += tall
        half *= 0.62
    spire(kit, 0, 0, ridge, 0.55, rng.uniform(2, 3), cover)
    for end in (-1, 1):
        top = np.array([end * (x * 0.45 + 0.35), 0, z + 1.6 + rise])
        kit.between(top - [end * 0.3, 0, 0.1], top + [end * 0.5, 0, 0.75], 0.1, BOX, 0.3, material=wood)
        kit.add(BOX, (end * x, 0, 1.3), (0.8, 0.9, 1.3), material=wood)
        roof(kit, (end * (x + 0.1), 0, 2.4), (0.9, 0.9), 1.6, "gable", 0.25, cover, wood, 0)
    door(kit, (x + 0.8, 0, 0), (0.45, 0.95), leaf(kit), wood)
    kit.add(CYL, (-x - 0.4, 0, 1.0), (1.5, 1.5, 1.0), material=wood)
    kit.add(CYL, (-x - 0.4, 0, 2.5), (1.8, 1.8, 0.6), (0.1, 1), material=cover)


def mission(kit):
    rng = kit.rng
    white = tinted(kit, (WHITE, CREAM, SAND, OCHRE, PINK), (PLAIN, CLOUDY, STREAKS), gloss=0.0)
    cover, dark, edge = tinted(kit, (TILE, CLAY), (SHINGLES,), frequency=20), kit.material(dark=True), tinted(kit, (BRICK, CLAY, WHITE, SAND))
    x, y, high = rng.uniform(5, 7), rng.uniform(2.8, 3.6), rng.uniform(4, 5)
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=white)
    roof(kit, (0, 0, high), (x, y), y * 0.45, "gable", 0.4, cover, white, 0)
    arched(kit, (0, 0, 0), (x, y), row(3, x, 0.75), 0.4, 2.0, 2.9, dark, 1)
    front, up = x + 0.2, high + y * 0.45
    kit.add(BOX, (front, 0, up / 2), (0.45, y + 0.5, up / 2), material=white)
    if kit.chance(0.5):  # a bell gable
        for wide, z in ((y * 0.72, up + 0.7), (y * 0.45, up + 2.0)):
            kit.add(BOX, (front, 0, z), (0.45, wide, 0.75), material=white)
            kit.add(BOX, (front, 0, z + 0.75), (0.52, wide + 0.1, 0.08), material=edge)
            for place in [-0.45, 0.45] if z < up + 1 else [0]:
                arched(kit, (front, place * wide, 0), (0.45, 1), [0], 0.34, z - 0.4, z + 0.15, dark, 0, 0.03)
        kit.add(CYL, (front, 0, up + 2.75), (y * 0.45, y * 0.45, 0.45), rotation=ALONG_X, material=white)
        top = up + 2.75 + y * 0.45
    else:
        kit.add(CYL, (front, 0, up), (y * 0.62, y * 0.62, 0.45), rotation=ALONG_X, material=white)
        for side in (-1, 1):
            tall = up + rng.uniform(1.6, 2.0) if side < 0 else up + 1.8
            kit.add(BOX, (front - 0.5, side * (y + 0.4), tall / 2), (1.1, 1.1, tall / 2), material=white)
            kit.add(BOX, (front - 0.5, side * (y + 0.4), tall), (1.25, 1.25, 0.12), material=edge)
            for facing in (0, 1):
                arched(kit, (front - 0.5, side * (y + 0.4), 0), (1.1, 1.1), [0], 0.42, tall - 1.5, tall - 0.8, dark, facing)
            kit.add(BALL, (front - 0.5, side * (y + 0.4), tall + 0.1), (0.95, 0.95, 0.9), material=edge if kit.chance(0.5) else white)
        top = up + y * 0.6
    cross(kit, front, 0, top, 1.2, tinted(kit, (TIMBER, GREY)))
    out = front + 0.46
    kit.add(BOX, (out, 0, 1.1), (0.07, 0.8, 1.1), material=leaf(kit))
    kit.add(CYL, (out, 0, 2.2), (0.8, 0.8, 0.07), rotation=ALONG_X, material=edge)
    kit.add(CYL, (out, 0, up - 0.9), (0.5, 0.5, 0.06), rotation=ALONG_X, material=dark)
    side = rng.choice([-1, 1])
    kit.add(BOX, (-x * 0.3, side * (y + 2), 1.5), (x * 0.65, 2, 1.5), material=white)
    kit.add(BOX, (-x * 0.3, side * (y + 2.1), 3.4), (x * 0.68, 2.4, 0.45), (1, 0.02), (0, -side * 2.3), material=cover)
    arched(kit, (-x * 0.3, side * (y + 2), 0), (x * 0.65, 2), row(4, x * 0.65, 0.95), 0.5, 0, 1.5, dark, 1)


def pagoda(kit):
    rng = kit.rng
    post = tinted(kit, ((0.4, 0.04, 0.02), TIMBER, WOOD, RED))
    walls, cover, gold = tinted(kit, (WHITE, RED, CREAM, WOOD)), tinted(kit, (SLATE, GREEN, TILE, GREY), (SHINGLES, STRIPES), frequency=20), tinted(kit, (GOLD, GREY))
    eight, tiers = kit.chance(0.45), int(rng.choice([3, 5, 5, 7]))
    half, z, shrink = rng.uniform(2.6, 3.4), 0.6, rng.uniform(0.84, 0.92)
    sides = 8 if eight else 4
    kit.add(PRISM if eight else BOX, (0, 0, 0.3), (half * 1.5, half * 1.5, 0.3), (1, 8) if eight else (1, 1), material=masonry(kit))
    tall = 2.4
    for k in range(tiers):
        kind, taper = (PRISM, (1, 8)) if eight else (BOX, (1, 1))
        kit.add(kind, (0, 0, z + tall / 2), (half, half, tall / 2), taper, material=walls)
        if not eight:
            lights(kit, (0, 0, z + tall * 0.45), (half, half), [0], (half * 0.3, tall * 0.34), kit.material(dark=True), post, 0, False)
            if tiers < 6:
                lights(kit, (0, 0, z + tall * 0.45), (half, half), [0], (half * 0.3, tall * 0.34), kit.material(dark=True), post, 1, False)
        else:
            kit.add(kind, (0, 0, z + tall * 0.2), (half * 1.05, half * 1.05, 0.09), taper, material=post)
            arched(kit, (0, 0, z), (half * 0.93, half * 0.93), [0], half * 0.18, 0.2, tall * 0.55, kit.material(dark=True), k % 2)
        z += tall
        flare = half + rng.uniform(0.9, 1.1)
        for lift, wide, ratio, deep in ((-0.1, flare * 1.04, 0.86, 0.16), (0.2, flare * 0.9, 0.62, 0.34)):
            kit.add(kind, (0, 0, z + lift), (wide, wide, deep), (ratio, 8) if eight else (ratio, ratio), material=cover)
        if tiers < 5:
            for px, py in around(sides, flare * (1.0 if eight else 1.42), 0 if eight else 45):
                kit.between((px * 0.94, py * 0.94, z - 0.22), (px * 1.05, py * 1.05, z + 0.22), 0.09, BOX, material=gold)
        z += 0.5
        half, tall = half * shrink, max(tall * 0.88, 1.2)
    spire(kit, 0, 0, z - 0.25, half * 1.3, 1.2, cover, sides)
    kit.loft((0, 0, z + 0.5), [(0, 0.25), (0.6, 0.2), (3.2, 0.06)], gold)
    for k in range(3):
        kit.add(CYL, (0, 0, z + 1.4 + 0.45 * k), (0.4 - 0.08 * k, 0.4 - 0.08 * k, 0.07), material=gold)


def mosque(kit):
    rng = kit.rng
    walls, dark, gold = tinted(kit, (WHITE, SAND, CREAM, STONE), (PLAIN, CLOUDY, BANDS), frequency=8), panes(kit), tinted(kit, (GOLD,), gloss=0.4)
    dome = tinted(kit, (GOLD, COPPER, (0.03, 0.25, 0.4), WHITE, GREY, GREEN), (PLAIN, STRIPES, SEAMS), frequency=12, gloss=0.3)
    half, high = rng.uniform(4, 5), rng.uniform(3.8, 4.8)
    kit.add(BOX, (0, 0, 0.2), (half * 1.25, half * 1.25, 0.2), material=masonry(kit))
    kit.add(BOX, (0, 0, high / 2), (half, half, high / 2), material=walls)
    kit.add(BOX, (0, 0, high), (half + 0.15, half + 0.15, 0.2), material=walls)
    for facing in (0, 1):
        arched(kit, (0, 0, 0.3), (half, half), row(3, half, 0.9)[::2] if facing == 0 else row(3, half, 0.9), 0.6, 0.7, high * 0.5, dark, facing)
    radius, drum = half * rng.uniform(0.55, 0.7), rng.uniform(0.8, 1.6)
    kit.add(CYL, (0, 0, high + drum / 2), (radius, radius, drum / 2), material=walls)
    for px, py in around(8, radius, 22):
        kit.add(CYL, (px, py, high + drum * 0.55), (0.2, 0.2, drum * 0.28), material=dark)
    if kit.chance(0.5):
        kit.add(BALL, (0, 0, high + drum), (radius * 1.02, radius * 1.02, radius * 0.95), material=dome)
        top = high + drum + radius * 0.9
    else:
        onion(kit, 0, 0, high + drum, radius * 1.08, dome)
        top = high + drum + radius * 2.3
    kit.loft((0, 0, top), [(0, 0.12), (0.8, 0.05)], gold)
    kit.add(BALL, (0, 0, top + 0.8), (0.08, 0.25, 0.25), material=gold)
    kit.add(BOX, (half + 0.3, 0, high * 0.58), (0.6, 1.7, high * 0.58), material=walls)
    arched(kit, (half + 0.3, 0, 0), (0.6, 1), [0], 1.0, 0, high * 0.55, dark, 0)
    spots = [(half, half), (half, -half), (-half, half), (-half, -half)][: int(rng.choice([1, 2, 4]))]
    tall = high + rng.uniform(5, 9)
    for px, py in spots:
        kit.add(PRISM, (px * 1.05, py * 1.05, high * 0.45), (0.75, 0.75, high * 0.45), (1, 8), material=walls)
        kit.add(CYL, (px * 1.05, py * 1.05, tall / 2), (0.5, 0.5, tall / 2), (0.85, 1), material=walls)
        kit.add(CYL, (px * 1.05, py * 1.05, tall * 0.75), (0.75, 0.75, 0.2), (1.15, 1), material=walls)
        kit.add(CYL, (px * 1.05, py * 1.05, tall + 0.75), (0.5, 0.5, 0.8), (0.03, 1), material=dome)
        kit.add(BALL, (px * 1.05, py * 1.05, tall + 1.6), (0.12, 0.12, 0.16), material=gold)
