"""Makers of houses and play towers that one can look into: roofs of slabs with overhang, open porches, walls with holes."""

import numpy as np

from .kit import turn
from .layout import BOX, CYL, RUNGS
from .materials import PLANKS
from .structures import roof_material, swing, wall_material


def slab_roof(kit, base, half, rise, over, material, thick=0.05, gables=None):
    """Two slabs that lean on each other along x: base [3] at the walls' top, half sizes (x, y) of the walls.

    over: overhang at the eaves and (in the same measure) at the gables. gables: material of the triangles below, if any.
    """
    x, y, z = base
    half_x, half_y = half
    run = half_y + over
    slope = np.arctan2(rise, half_y)
    long = run / np.cos(slope)
    for side in (-1, 1):
        tilt = turn("x", -side * np.degrees(slope))
        centre = np.array([x, y + side * run / 2, z + rise - np.tan(slope) * run / 2 + thick])
        kit.add(BOX, centre, (half_x + over, long / 2, thick), rotation=tilt, material=material)
    if gables is not None:
        kit.add(BOX, (x, y, z + rise / 2), (half_x, half_y, rise / 2), (1, 0.02), material=gables)


def window(kit, centre, along, half, glass, frame):
    """A pane with a frame that stands out and a sill; `along` is the wall's axis, 0 (x) or 1 (y)."""
    wide, high = half

    def reach(across, deep):
        return (across, deep) if along == 0 else (deep, across)

    x, y, z = centre
    kit.add(BOX, centre, (*reach(wide, 0.02), high), material=glass)
    out = np.array([0, 0.03, 0]) if along == 0 else np.array([0.03, 0, 0])
    out = out * np.sign((y if along == 0 else x) or 1)
    for off in (-wide, wide):
        move = np.array([off, 0, 0]) if along == 0 else np.array([0, off, 0])
        kit.add(BOX, np.array(centre) + move + out, (*reach(0.04, 0.04), high), material=frame)
    for up in (-high, high):
        kit.add(BOX, np.array([x, y, z + up]) + out, (*reach(wide + 0.06, 0.05), 0.04), material=frame)


def eaved_house(kit):
    """A house under slabs with overhang, an open porch on posts, framed windows, a chimney, a second lower wing."""
    rng = kit.rng
    walls, roof, frame, glass = wall_material(kit), roof_material(kit), kit.material(), kit.material(dark=True, gloss=0.4)
    half_x, half_y, height = rng.uniform(1.2, 3.2), rng.uniform(0.9, 1.7), rng.uniform(1.1, 2.6)
    rise, over = half_y * rng.uniform(0.35, 1.2), rng.uniform(0.08, 0.4)
    kit.add(BOX, (0, 0, height / 2), (half_x, half_y, height / 2), material=walls)
    gables = walls if kit.chance(0.7) else kit.material(pattern=PLANKS)
    slab_roof(kit, (0, 0, height), (half_x, half_y), rise, over, roof, rng.uniform(0.03, 0.08), gables)
    count = int(rng.integers(1, 4))
    size = (min(0.45, half_x * 0.35 / count), rng.uniform(0.25, 0.42))
    sill = rng.uniform(0.5, 0.65) * height
    for side in (-1, 1):
        for i in range(count):
            if kit.chance(0.8):
                x = half_x * (2 * (i + 0.5) / count - 1)
                window(kit, (x, side * half_y, sill), 0, size, glass, frame)
    if kit.chance(0.6):
        window(kit, (half_x, 0, sill), 1, size, glass, frame)
    door = half_x * rng.uniform(-0.6, 0.6)
    kit.add(BOX, (door, half_y, 0.5), (0.22, 0.03, 0.5), material=kit.material(dark=kit.chance(0.4)))
    kind = rng.random()
    if kind < 0.45:  # porch under a roof of its own
        deep, long = rng.uniform(0.5, 1.1), half_x * rng.uniform(0.5, 1)
        eave = min(height * 0.9, rng.uniform(1.0, 1.5))
        kit.add(BOX, (0, half_y + deep / 2, 0.05), (long, deep / 2, 0.05), material=frame)
        lean = turn("x", -rng.uniform(4, 20))
        kit.add(BOX, (0, half_y + deep / 2, eave + 0.08), (long * 1.05, deep / 2 * 1.25, 0.03), rotation=lean, material=roof)
        for x in np.linspace(-long * 0.95, long * 0.95, int(rng.integers(2, 6))):
            kit.add(BOX, (x, half_y + deep * 0.95, eave / 2), (0.04, 0.04, eave / 2), material=frame)
        if kit.chance(0.6):
            kit.railing((-long * 0.95, half_y + deep * 0.95, 0.1), (-0.1 * long, half_y + deep * 0.95, 0.1), 0.4, frame, 0.13)
    elif kind < 0.7:  # a wing across
        wing, out = half_y * rng.uniform(0.5, 0.9), rng.uniform(0.5, 1.2)
        low = height * rng.uniform(0.6, 0.95)
        x = half_x * rng.uniform(-0.5, 0.5)
        kit.add(BOX, (x, half_y + out / 2, low / 2), (wing, out / 2, low / 2), material=walls)
        kit.add(BOX, (x, half_y + out * 0.4, low + rise * 0.3), (wing * 1.15, out * 0.75, rise * 0.3), (0.02, 1), material=roof)
    if kit.chance(0.6):
        kit.add(BOX, (half_x * rng.uniform(-0.7, 0.7), half_y * 0.25, height + rise), (0.15, 0.15, 0.4), material=kit.material(pattern=8))
    if kit.chance(0.3):
        kit.add(BOX, (0, 0, 0.08), (half_x * 1.15, half_y * 1.25, 0.08), material=kit.material(dark=kit.chance(0.5)))


def open_shed(kit):
    """Sheds, barns, stalls, shelters: walls of panels with openings in them, so that one sees the far wall and the floor."""
    rng = kit.rng
    walls, roof, post = wall_material(kit), roof_material(kit), kit.material()
    half_x, half_y, height = rng.uniform(0.8, 2.4), rng.uniform(0.7, 1.6), rng.uniform(1.1, 2.2)
    thin = rng.uniform(0.03, 0.07)
    kit.add(BOX, (0, 0, 0.05), (half_x, half_y, 0.05), material=kit.material())
    for axis, sign in ((0, -1), (0, 1), (1, -1), (1, 1)):
        long, away = (half_x, half_y) if axis == 0 else (half_y, half_x)
        kind = rng.random()
        pieces = []  # middle and half width along the wall, bottom, top
        if kind < 0.3:
            pieces = [(0, long, 0, height)]
        elif kind < 0.7:  # a door or a window
            middle, half = rng.uniform(-0.3, 0.3) * long, rng.uniform(0.2, 0.55) * long
            sill, lintel = (0 if kit.chance(0.5) else rng.uniform(0.25, 0.5) * height), rng.uniform(0.7, 0.92) * height
            left, right = middle - half + long, long - middle - half
            pieces = [(-long + left / 2, left / 2, 0, height), (long - right / 2, right / 2, 0, height)]
            pieces += [(middle, half, lintel, height)] + ([(middle, half, 0, sill)] if sill else [])
        elif kind < 0.85:  # a parapet or a fascia
            pieces = [(0, long, 0, height * rng.uniform(0.25, 0.5))]
        for middle, half, bottom, top in pieces:
            centre, reach = (middle, sign * (away - thin)), (max(half, 0.02), thin)
            if axis == 1:
                centre, reach = centre[::-1], reach[::-1]
            kit.add(BOX, (*centre, (bottom + top) / 2), (*reach, (top - bottom) / 2), material=walls)
    for x in (-half_x, half_x):
        kit.add(BOX, (x, half_y, height / 2), (0.05, 0.05, height / 2), material=post, mirror=True)
    over = rng.uniform(0.05, 0.35)
    kind = rng.random()
    if kind < 0.6:
        slab_roof(kit, (0, 0, height), (half_x, half_y), half_y * rng.uniform(0.3, 1), over, roof, 0.03, walls if kit.chance(0.5) else None)
    elif kind < 0.9:
        lean = turn("x", rng.uniform(-14, 14))
        kit.add(BOX, (0, 0, height + 0.15), (half_x + over, half_y + over, 0.04), rotation=lean, material=roof)
    for _ in range(int(rng.integers(0, 5))):  # goods
        half = rng.uniform(0.1, 0.35, 3)
        kit.add(rng.choice([BOX, CYL]), (rng.uniform(-0.7, 0.7) * half_x, rng.uniform(-0.6, 0.6) * half_y, 0.1 + half[2]), half)


def play_tower(kit):
    """Wooden towers with a roof of slabs, decks at several heights, walls of slats, rails, ladders, a bent slide, swings."""
    rng = kit.rng
    wood = kit.material(base=rng.uniform(0.6, 1.8) * np.array([0.5, 0.36, 0.22]), pattern=rng.choice([0, 1, PLANKS]))
    if kit.chance(0.25):
        wood = kit.material()
    loud, roof = kit.material(), roof_material(kit) if kit.chance(0.5) else kit.material()
    half, deck, post = rng.uniform(0.45, 0.75), rng.uniform(0.7, 1.5), rng.uniform(0.03, 0.07)
    top = deck + rng.uniform(0.85, 1.3)
    decks = [(0.0, 0.0, half, deck, top)]
    for _ in range(int(rng.integers(0, 3))):  # lower decks without a roof, on the free sides
        side, low, size = rng.integers(1, 4), deck * rng.uniform(0.6, 1), half * rng.uniform(0.7, 1.2)
        x, y = turn("z", 90 * side)[:2, 0] * (half + size)
        if all(abs(x - d[0]) + abs(y - d[1]) > 0.1 for d in decks):
            decks.append((x, y, size, low, low + rng.uniform(0.4, 0.6)))
    slats = kit.chance(0.5)
    for x, y, size, floor, high in decks:
        for dx in (-size, size):
            for dy in (-size, size):
                kit.add(BOX, (x + dx, y + dy, high / 2), (post, post, high / 2), material=wood)
        kit.add(BOX, (x, y, floor), (size, size, 0.035), material=wood)
        for side in range(1, 4):
            if not kit.chance(0.7):
                continue
            spin = turn("z", 90 * side)
            place = np.array([x, y, floor + 0.26]) + spin @ np.array([size, 0, 0])
            if slats:
                cut = (RUNGS, rng.uniform(5, 9), rng.uniform(0.5, 0.8))
                kit.add(BOX, place, (0.015, size, 0.22), rotation=spin, material=wood, cut=cut)
            else:
                ends = (spin @ np.array([size, s * size, 0]) + np.array([x, y, floor + 0.03]) for s in (-1, 1))
                kit.railing(*ends, 0.45, wood if kit.chance(0.7) else loud, rng.uniform(0.07, 0.16))
    if kit.chance(0.85):
        rise = half * rng.uniform(0.5, 1.3)
        gables = wood if kit.chance(0.5) else None
        slab_roof(kit, (0, 0, top), (half, half), rise, rng.uniform(0.08, 0.25), roof, 0.025, gables)
    # The slide: steep, then flat, between two cheeks.
    wide, run = rng.uniform(0.16, 0.26), deck * rng.uniform(1, 1.7)
    bends = np.array([[half, deck], [half + 0.3 * run, deck * rng.uniform(0.6, 0.8)], [half + 0.8 * run, 0.16 * deck], [half + run, 0.08]])
    for (x0, z0), (x1, z1) in zip(bends[:-1], bends[1:], strict=True):
        kit.between((x0, 0, z0), (x1, 0, z1), (0.015, wide), BOX, material=loud)
        kit.between((x0, wide, z0 + 0.05), (x1, wide, z1 + 0.05), (0.06, 0.015), BOX, material=loud, mirror=True)
    spot = rng.integers(1, 4)
    foot = turn("z", 90 * spot) @ np.array([half + deck * rng.uniform(0.1, 0.6), 0, 0])
    head = turn("z", 90 * spot) @ np.array([half, 0, 0]) + np.array([0, 0, deck])
    kit.between(foot, head, (0.03, 0.22), BOX, material=wood, cut=(RUNGS, rng.uniform(3, 6), 0.25))
    if kit.chance(0.3) and len(decks) == 1:
        swing(kit, (0, half + 0.1, 0), wood)
