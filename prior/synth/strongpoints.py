"""Makers of military posts, camps and exercise areas, and of ruins, wrecks and building sites."""

import numpy as np

from .extent import bounds
from .installations import (
    BLUE,
    BRICK,
    CONCRETE,
    EARTH,
    GREEN,
    GREY,
    OLIVE,
    ORANGE,
    RED,
    RUST,
    SAND,
    STONE,
    WHITE,
    WOOD,
    YELLOW,
    ladder,
    stairs,
    tinted,
)
from .kit import ALONG_X, ALONG_Y, around, turn
from .launchers import drab, metal, timber
from .layout import BALL, BARS, BOX, CYL, GRID, LEAVES, PRISM, RUNGS, TUBE
from .materials import (
    BRICKS,
    CAMOUFLAGE,
    CLOUDY,
    PLAIN,
    PLANKS,
    RIBS,
    SEAMS,
    SPECKLES,
    STREAKS,
    STRIPES,
    WRITING,
)
from .wheeled import glazing


def cast(kit):
    return tinted(kit, (CONCRETE, GREY, CONCRETE, SAND), (CLOUDY, STREAKS, PLAIN), frequency=5, gloss=0.02)


def soil(kit):
    return tinted(kit, (EARTH, SAND, (0.14, 0.15, 0.06)), (CLOUDY, SPECKLES), frequency=kit.rng.uniform(8, 20), gloss=0.0)


def canvas(kit):
    return tinted(kit, (OLIVE, SAND, (0.16, 0.16, 0.09), OLIVE, WHITE), (PLAIN, CLOUDY, CAMOUFLAGE, PLAIN), frequency=kit.rng.uniform(5, 10), gloss=0.02)


def sacking(kit):
    return tinted(kit, (SAND, (0.36, 0.3, 0.2), (0.2, 0.19, 0.11)), (CLOUDY, SPECKLES), frequency=25, gloss=0.0)


def rusty(kit):
    return tinted(kit, (RUST, (0.3, 0.14, 0.07), (0.1, 0.06, 0.045)), (CLOUDY, STREAKS, SPECKLES), frequency=kit.rng.uniform(5, 14), gloss=0.02)


def masonry(kit):
    return tinted(kit, (BRICK, STONE, WHITE, CONCRETE, SAND), (BRICKS, BRICKS, STREAKS, CLOUDY), frequency=kit.rng.uniform(10, 24), gloss=0.0)


def bag(kit, at, half, spin, material):
    """A pillow: a box filled by a superellipsoid."""
    kit.add(BOX, at, half, rotation=turn("z", spin), material=material)
    kit.primitives[-1] = kit.primitives[-1]._replace(bevel=2.6)


def bag_ring(kit, radius, rows, sand, first=40, last=320, base=0.0):
    """Bags in `rows` courses on an arc between two angles in degrees."""
    count = max(3, int(np.radians(last - first) * radius / 0.58))
    step = (last - first) / count
    for row in range(rows):
        for k in range(count):
            angle = np.radians(first + step * (k + (0.5 if row % 2 == 0 else 0.25 if k == 0 else 0.0)))
            at = (radius * np.cos(angle), radius * np.sin(angle), base + 0.12 + 0.21 * row)
            bag(kit, at, (np.radians(step) * radius * 0.53, 0.21, 0.13), np.degrees(angle) + 90 + kit.rng.normal(0, 4), sand)


def bag_line(kit, start, end, rows, sand, base=0.0):
    """Bags in `rows` courses from start to end [2], every second course moved by half a bag."""
    start, end = np.array(start, float), np.array(end, float)
    along = end - start
    count = max(2, round(np.linalg.norm(along) / 0.6))
    spin = np.degrees(np.arctan2(along[1], along[0]))
    for row in range(rows):
        for k in range(count - row % 2):
            at = start + along * (k + 0.5 + 0.5 * (row % 2)) / count
            bag(kit, (*at, base + 0.12 + 0.21 * row), (np.linalg.norm(along) / count * 0.53, 0.2, 0.13), spin + kit.rng.normal(0, 3), sand)


def heap(kit, x, y, rx, ry, high, material):
    """A low mound on the ground."""
    rx = max(rx, 0.05)
    kit.loft((x, y, 0), [(0, rx), (high * 0.5, rx * 0.74), (high, rx * 0.28)], material, PRISM, turn("z", 0), ry / rx, int(kit.rng.integers(7, 11)))


def debris(kit, count, x, y, rx, ry, size, materials, base=0.0):
    """Tilted lumps strewn about."""
    rng = kit.rng
    for _ in range(count):
        half = size * rng.uniform([0.5, 0.4, 0.2], [1.4, 0.9, 0.5])
        spin = turn("z", rng.uniform(0, 180)) @ turn("x", rng.uniform(-30, 30))
        at = (x + rng.uniform(-1, 1) * rx, y + rng.uniform(-1, 1) * ry, base + size * 0.4)
        kit.add(BOX, at, half, (rng.uniform(0.6, 1), rng.uniform(0.6, 1)), rotation=spin, material=materials[rng.integers(len(materials))])


def swing(kit, first, spin, at=(0, 0, 0)):
    """Turns what was added since `first` about the origin, moves it to `at` and lets it stand on that height."""
    moved = [p._replace(centre=spin @ p.centre, rotation=spin @ p.rotation) for p in kit.primitives[first:]]
    lift = np.array(at, float) - [0, 0, bounds(moved)[0][2]]
    kit.primitives[first:] = [p._replace(centre=p.centre + lift) for p in moved]


def machine_gun(kit, at, high, metal_):
    """A gun on a tripod, its muzzle forward."""
    at = np.array(at, float)
    top = at + [0, 0, high]
    for x, y in around(3, 0.42, 60):
        kit.between(at + [x, y, 0], top, 0.025, material=metal_)
    kit.add(BOX, top + [0, 0, 0.07], (0.26, 0.06, 0.08), material=metal_)
    kit.between(top + [0.2, 0, 0.08], top + [1.0, 0, 0.08], 0.028, material=metal_)


def strongpoint(kit):
    """Sandbag posts, gabions, T-walls, checkpoints, sentry boxes, pillboxes, bunkers, gun pits, foxholes, trenches, netted posts, tents, field kitchens and hospitals,
    command posts, container camps, fuel bladders, ammunition, pallets, cans and drums, generators, light towers, toilets, obstacles, wire, spikes, bridges, helipads,
    revetments, targets, obstacle courses, watch platforms."""
    kinds = [sandbag_post, gabions, t_walls, checkpoint, sentry_box, pillbox, bunker, gun_pit, foxhole, trench, netted_post, tent, tent, tent, field_kitchen, field_hospital]
    kinds += [command_post, container_camp, fuel_bladder, ammunition, pallets, cans, generator, light_tower, toilets, obstacles, wire, spikes, pontoon, bridge_span, helipad]
    kinds += [revetment, targets, obstacle_course, watch_platform]
    kinds[kit.rng.choice(len(kinds))](kit)


def sandbag_post(kit):
    rng = kit.rng
    sand, wood, dark = sacking(kit), timber(kit), metal(kit)
    roofed = kit.chance(0.5)
    if kit.chance(0.5):
        bag_ring(kit, rng.uniform(1.1, 1.4), 4 if not roofed else 3, sand, -130, 130)
    else:
        x, y, rows = rng.uniform(0.9, 1.2), rng.uniform(1.1, 1.5), int(rng.integers(3, 5))
        bag_line(kit, (x, -y), (x, y), rows, sand)
        for side in (-1, 1):
            bag_line(kit, (-x, y * side), (x - 0.2, y * side), rows, sand)
    machine_gun(kit, (0.35, 0, 0), 0.9, dark)
    if roofed:
        for x in (-0.95, 0.95):
            kit.between((x, 1.0, 0), (x, 1.0, 1.9), 0.06, BOX, material=wood, mirror=True)
        kit.add(BOX, (0, 0, 1.94), (1.25, 1.35, 0.06), material=wood if kit.chance(0.5) else metal(kit)._replace(pattern=RIBS, frequency=12.0))
        bag_line(kit, (1.0, -1.2), (1.0, 1.2), 1, sand, 2.0)


def gabion(kit, x, y, half, high, mesh, fill, base=0.0):
    kit.add(BOX, (x, y, base + high / 2), (half - 0.03, half - 0.03, high / 2), material=fill)
    kit.add(BOX, (x, y, base + high / 2), (half, half, high / 2), material=mesh, cut=(GRID, 5, 0.13))


def gabions(kit):
    rng = kit.rng
    fill, mesh, half, high = sacking(kit), metal(kit, 0.3, 0.6), 0.55, rng.uniform(1.2, 1.7)
    count = int(rng.integers(4, 8))
    places = [(0, (k - (count - 1) / 2) * 2 * half) for k in range(count)]
    if kit.chance(0.6):
        places += [(-2 * half * k, places[0][1]) for k in (1, 2)] + ([(-2 * half * k, places[-1][1]) for k in (1, 2)] if kit.chance(0.6) else [])
    for x, y in places:
        gabion(kit, x, y, half, high, mesh, fill)
        kit.add(BALL, (x, y, high), (half * 0.85, half * 0.85, 0.13), material=fill)
    if kit.chance(0.7):
        for x, y in places[: count - 1]:
            gabion(kit, x, y + half, half * 0.95, high * 0.8, mesh, fill, high)


def t_walls(kit):
    rng = kit.rng
    stone, dark, count = cast(kit), kit.material(dark=True), int(rng.integers(2, 9))
    high, half, gap = rng.uniform(2.4, 3.8), rng.uniform(0.6, 0.75), rng.uniform(0.0, 0.05)
    for k in range(count):
        y, x = (k - (count - 1) / 2) * (2 * half + gap), rng.normal(0, 0.03)
        kit.add(BOX, (x, y, 0.12), (0.85, half, 0.12), material=stone)
        kit.add(BOX, (x, y, 0.42), (0.78, half, 0.19), (0.28, 1), material=stone)
        kit.add(BOX, (x, y, high / 2 + 0.2), (0.16, half, high / 2 - 0.2), (0.75, 1), material=stone)
        for z in (high * 0.4, high * 0.8):
            kit.add(BOX, (x, y, z), (0.165, 0.07, 0.05), material=dark)
    if kit.chance(0.4):
        y = (int(count / 2) - (count - 1) / 2) * (2 * half + gap)
        kit.add(BOX, (0.1, y, high * 0.6), (0.06, half * 0.7, 0.35), material=tinted(kit, (WHITE, YELLOW), (WRITING,), frequency=12))
    if kit.chance(0.35):
        wire_coil(kit, (0, -half * count, high + 0.2), (0, half * count, high + 0.2), 0.25, 14, metal(kit))


def wire_coil(kit, start, end, radius, count, steel):
    """A coil of wire: leaning hoops from start to end, along x or y."""
    start, end = np.array(start, float), np.array(end, float)
    level = turn("z", np.degrees(np.arctan2(*(end - start)[1::-1])))
    for k in range(count):
        lean = level @ turn("z", 24 if k % 2 else -24) @ ALONG_X
        kit.add(TUBE, start + (end - start) * (k + 0.5) / count, (radius, radius, 0.022), rotation=lean, material=steel)


def booth(kit, x, y, half, high, wall, glass, roof):
    """A cabin with windows on all sides and a door to the back."""
    kit.add(BOX, (x, y, high / 2), (half, half, high / 2), material=wall)
    for spin in (0, 90, 180, 270):
        turned = turn("z", spin)
        kit.add(BOX, np.array([x, y, high * 0.64]) + turned @ [half, 0, 0], (0.02, half * 0.72, high * 0.17), rotation=turned, material=glass)
    kit.add(BOX, (x - half, y + half * 0.3, high * 0.42), (0.03, half * 0.36, high * 0.42), material=tinted(kit, (GREY, WOOD, WHITE)))
    kit.add(BOX, (x, y, high + 0.06), (half * 1.25, half * 1.25, 0.07), material=roof)


def checkpoint(kit):
    rng = kit.rng
    wall, dark, stone = tinted(kit, (WHITE, OLIVE, SAND, GREY, WOOD), (PLAIN, PLANKS, RIBS), frequency=9), kit.material(dark=True), cast(kit)
    bars = kit.material(base=(0.75, 0.75, 0.72), pattern=STRIPES, frequency=rng.uniform(4, 7), second=rng.choice([[0.5, 0.03, 0.02], [0.04, 0.04, 0.04], [0.6, 0.35, 0.02]]))
    booth(kit, -0.4, 2.6, rng.uniform(0.7, 1.0), 2.2, wall, glazing(kit), tinted(kit, (GREY, OLIVE, RED)))
    lift = rng.choice([0, 0, rng.uniform(0.4, 1.2)])
    way = np.array([0, -np.cos(lift), np.sin(lift)])
    pivot = np.array([0.9, 1.6, 1.0])
    kit.add(BOX, pivot - [0, 0, 0.45], (0.14, 0.14, 0.55), material=tinted(kit, (YELLOW, GREY, RED, WHITE)))
    kit.between(pivot - way * 0.6 + [0.18, 0, 0], pivot + way * 3.6 + [0.18, 0, 0], (0.05, 0.06), BOX, material=bars)
    kit.add(BOX, pivot - way * 0.6 + [0.18, 0, 0], (0.12, 0.16, 0.14), material=dark)
    kit.add(BOX, (1.05, -2.0, 0.47), (0.06, 0.06, 0.47), material=metal(kit))
    kit.between((1.6, -2.5, 0), (1.6, -2.5, 2.1), 0.03, material=metal(kit))
    kit.add(PRISM, (1.64, -2.5, 2.0), (0.3, 0.3, 0.02), (1, 8), rotation=ALONG_X, material=tinted(kit, (RED,), (WRITING,), frequency=14, second=(0.8, 0.8, 0.8)))
    for k in range(int(rng.integers(1, 4))):
        x = 2.6 + 1.0 * k
        kit.add(BOX, (x, -1.4 if k % 2 else 0.9, 0.14), (0.3, 0.9, 0.14), material=stone)
        kit.add(BOX, (x, -1.4 if k % 2 else 0.9, 0.5), (0.22, 0.9, 0.24), (0.55, 1), material=stone)
    if kit.chance(0.6):
        bag_line(kit, (0.95, 2.0), (0.95, 3.8), 4, sacking(kit))
    kit.between((-1.2, 1.6, 0), (-1.2, 1.6, 4.2), 0.03, material=metal(kit))
    kit.add(BOX, (-1.2, 1.2, 3.9), (0.012, 0.4, 0.25), material=tinted(kit, (RED, BLUE, GREEN, WHITE), (STRIPES, PLAIN), frequency=7))


def sentry_box(kit):
    rng = kit.rng
    chevron = kit.material(base=rng.choice([[0.75, 0.75, 0.7], [0.1, 0.2, 0.1], [0.3, 0.17, 0.08]]), pattern=rng.choice([STRIPES, PLANKS]), frequency=6, second=rng.choice([[0.45, 0.03, 0.02], [0.03, 0.03, 0.03], [0.05, 0.1, 0.35]]))
    dark, roof, high = kit.material(dark=True, pattern=PLAIN), tinted(kit, (GREY, RED, GREEN)), rng.uniform(1.9, 2.3)
    kit.add(BOX, (0, 0, 0.06), (0.65, 0.65, 0.06), material=cast(kit))
    kit.add(BOX, (-0.46, 0, high / 2), (0.05, 0.5, high / 2), material=chevron)
    kit.add(BOX, (0, 0.47, high / 2), (0.5, 0.04, high / 2), material=chevron, mirror=True)
    kit.add(BOX, (-0.4, 0, high / 2), (0.02, 0.44, high / 2), material=dark)
    kit.add(BOX, (0.45, 0, high - 0.12), (0.05, 0.5, 0.13), material=chevron)
    if kit.chance(0.5):
        kit.add(BOX, (0, 0, high + 0.25), (0.66, 0.66, 0.27), (0.05, 0.05), material=roof)
        kit.add(BALL, (0, 0, high + 0.54), (0.09, 0.09, 0.11), material=roof)
    else:
        kit.add(BOX, (0, 0, high + 0.22), (0.62, 0.66, 0.24), (1, 0.03), material=roof)
    if kit.chance(0.5):
        bag_line(kit, (0.9, -0.9), (0.9, 0.9), 3, sacking(kit))
    else:
        for side in (-1, 1):
            kit.between((0.9, side * 0.9, 0), (0.9, side * 0.9, 0.9), 0.05, material=metal(kit))
        kit.between((0.9, -0.9, 0.85), (0.9, 0.9, 0.85), 0.02, material=chevron)


def pillbox(kit):
    rng = kit.rng
    dark, high, wide = kit.material(dark=True, pattern=PLAIN), rng.uniform(1.6, 2.3), rng.uniform(1.7, 2.4)
    wall = cast(kit) if kit.chance(0.5) else tinted(kit, (BRICK, CONCRETE), (BRICKS,), frequency=18, gloss=0.0)
    top, sides = cast(kit), int(rng.choice([4, 6, 6, 8, 30]))
    kit.loft((0, 0, 0), [(0, wide), (high, wide * rng.uniform(0.95, 1))], wall, PRISM if sides < 20 else CYL, sides=sides)
    kit.loft((0, 0, high), [(0, wide * 1.07), (0.3, wide * 1.05), (0.42, wide * 0.9)], top, PRISM if sides < 20 else CYL, sides=sides)
    spins = np.arange(min(sides, 8)) * 360 / min(sides, 8)
    for spin in spins[[abs(s - 180) > 30 for s in spins]]:
        turned = turn("z", spin)
        kit.add(BOX, turned @ [wide * 0.985, 0, high * 0.68], (0.06, wide * 0.24, 0.2), rotation=turned, material=top)
        kit.add(BOX, turned @ [wide * 1.0, 0, high * 0.68], (0.07, wide * 0.2, 0.11), rotation=turned, material=dark)
    kit.add(BOX, (-wide, 0, 0.75), (0.08, 0.38, 0.75), material=dark)
    kit.add(BOX, (-wide - 0.5, -0.5, 0.85), (0.5, 0.12, 0.85), material=wall)
    if kit.chance(0.4):
        kit.add(CYL, (0, 0, high + 0.5), (0.5, 0.5, 0.14), material=metal(kit))
    if kit.chance(0.5):
        heap(kit, 0.4, 0, wide * 1.6, wide * 1.6, 0.55, soil(kit))


def bunker(kit):
    rng = kit.rng
    wall, dark, earth = cast(kit), kit.material(dark=True, pattern=PLAIN), soil(kit)
    wide, deep, high = rng.uniform(2.0, 3.0), rng.uniform(1.8, 2.8), rng.uniform(2.0, 2.7)
    kit.add(BOX, (-0.2, 0, high / 2), (deep - 0.8, wide, high / 2), material=wall)
    for side in (-1, 1):
        for k in range(3):
            inner = 0.75 + 0.22 * k
            kit.add(BOX, (deep - 0.8 + 0.25 * k, side * (inner + wide) / 2, high * 0.5), (0.25, (wide - inner) / 2, high * 0.5), material=wall)
    kit.add(BOX, (deep - 0.5, 0, high * 0.17), (0.6, wide * 0.9, high * 0.17), material=wall)
    kit.add(BOX, (0.0, 0, high + 0.22), (deep, wide * 1.04, 0.24), (0.96, 0.96), material=wall)
    kit.add(BOX, (deep - 1.02, 0, high * 0.65), (0.05, 0.75, high * 0.33), material=dark)
    if kit.chance(0.65):
        kit.between((deep - 1.1, 0, high * 0.55), (deep + rng.uniform(0.7, 1.6), 0, high * 0.6), 0.12, CYL, 0.65, material=drab(kit))
    if kit.chance(0.6):
        kit.add(BOX, (-0.5, 0, high * 0.45), (deep * 1.05, wide * 1.9, high * 0.45), (0.7, 0.55), material=earth)
        kit.add(BOX, (-0.4, 0, high + 0.55), (deep * 0.8, wide * 0.95, 0.14), (0.8, 0.8), material=earth)
    else:
        kit.add(BOX, (-deep + 0.58, 0.8, 0.9), (0.05, 0.45, 0.9), material=dark)
        kit.add(CYL, (-0.4, 0, high + 0.55), (0.45, 0.45, 0.2), material=metal(kit))


def gun_pit(kit):
    rng = kit.rng
    paint, dark = drab(kit), kit.material(dark=True, pattern=PLAIN)
    radius = rng.uniform(1.9, 2.3)
    if kit.chance(0.5):
        bag_ring(kit, radius, 2, sacking(kit), 20, 340)
    else:
        earth = soil(kit)
        for k in range(11):
            spin = turn("z", 30 + 30 * k)
            kit.add(BOX, spin @ [radius, 0, 0.33], (0.55, radius * 0.31, 0.33), (0.3, 0.85), rotation=spin, material=earth)
    rise = np.radians(rng.uniform(5, 60))
    way, pivot = np.array([np.cos(rise), 0, np.sin(rise)]), np.array([0, 0, 0.95])
    if kit.chance(0.5):
        for x, y in around(4, 1.1, 45):
            kit.between((0, 0, 0.2), (x, y, 0.06), (0.06, 0.08), BOX, material=paint)
        kit.loft((0, 0, 0), [(0, 0.4), (0.3, 0.35), (0.5, 0.22)], paint)
        kit.add(BOX, (0, 0.3, 0.75), (0.2, 0.05, 0.3), material=paint, mirror=True)
        kit.add(BOX, pivot, (0.35, 0.22, 0.16), rotation=turn("y", -np.degrees(rise)), material=paint)
        kit.between(pivot, pivot + way * 2.1, 0.045, material=dark, mirror=True)
        for side in (-0.12, 0.12):
            kit.between(pivot + [0, side, 0], pivot + way * 2.0 + [0, side, 0], 0.05, CYL, 0.7, material=dark)
        kit.add(BOX, (-0.5, 0.4, 0.6), (0.15, 0.15, 0.04), material=dark, mirror=True)
        kit.between((0, 0.35, 0.5), (-0.5, 0.4, 0.58), 0.03, material=paint, mirror=True)
    else:
        for side in (-1, 1):
            kit.between((0, side * 0.3, 0.5), (-1.6, side * 0.8, 0.08), (0.08, 0.07), BOX, material=paint)
            kit.add(CYL, (0, side * 0.62, 0.45), (0.45, 0.45, 0.12), rotation=ALONG_Y, material=dark)
            kit.add(CYL, (0, side * 0.66, 0.45), (0.27, 0.27, 0.12), rotation=ALONG_Y, material=paint)
            kit.add(BOX, (0.2, side * 0.55, 0.95), (0.03, 0.42, 0.42), rotation=turn("y", -15), material=paint)
        kit.add(BOX, (0, 0, 0.5), (0.2, 0.55, 0.13), material=paint)
        kit.between(pivot - way * 0.7, pivot + way * 0.6, (0.15, 0.15), BOX, material=paint)
        kit.between(pivot + way * 0.5, pivot + way * 2.3, 0.09, CYL, 0.75, material=paint)
        kit.between(pivot + way * 2.2, pivot + way * 2.5, 0.1, material=paint)
    kit.add(BOX, (-0.9, 1.2, 0.15), (0.4, 0.2, 0.15), material=timber(kit))


def foxhole(kit):
    rng = kit.rng
    earth, sand, dark, helmet = soil(kit), sacking(kit), kit.material(dark=True, pattern=PLAIN), drab(kit)
    for k in range(10):
        spin = turn("z", 36 * k)
        kit.add(BOX, spin @ [0.95, 0, 0.22], (0.5, 0.42, 0.22), (0.3, 0.75), rotation=spin, material=earth)
    kit.add(CYL, (0, 0, 0.03), (0.8, 0.8, 0.03), material=dark)
    bag_ring(kit, 0.95, 2, sand, -70, 70, 0.36)
    for y in (-0.25, 0.3)[: int(rng.integers(1, 3))]:
        kit.add(BALL, (0.0, y, 0.3), (0.17, 0.25, 0.3), material=helmet)
        kit.add(BALL, (0.05, y, 0.66), (0.1, 0.09, 0.13), material=tinted(kit, ((0.5, 0.3, 0.2),)))
        kit.add(BALL, (0.04, y, 0.75), (0.16, 0.14, 0.11), material=helmet)
        kit.between((0.1, y - 0.12, 0.62), (1.1, y - 0.1, 0.86), 0.03, BOX, material=dark)
        kit.between((0.0, y + 0.2, 0.45), (0.5, y - 0.1, 0.72), 0.06, material=helmet)


def trench(kit):
    rng = kit.rng
    earth, wood, sand = soil(kit), timber(kit), sacking(kit)
    high, wide, bags = rng.uniform(1.0, 1.4), rng.uniform(0.5, 0.65), kit.chance(0.7)
    points = np.array([[-2.6, 0, 0], [-0.9, rng.choice([0, 0.8, -0.8]), 0], [0.9, 0, 0], [2.6, rng.choice([0, 0.8]), 0]])
    for start, end in zip(points[:-1], points[1:], strict=True):
        along, middle = end - start, (start + end) / 2
        half, spin = np.linalg.norm(along) / 2 + 0.12, turn("z", np.degrees(np.arctan2(along[1], along[0])))
        for side in (-1, 1):
            kit.add(BOX, middle + spin @ [0, side * (wide + 0.75), high / 2], (half, 0.75, high / 2), (1, 0.4), (0, -side * 0.4), spin, earth)
            kit.add(BOX, middle + spin @ [0, side * wide, high / 2], (half, 0.04, high / 2 + 0.03), rotation=spin, material=wood)
            for x in (-0.6, 0.6):
                kit.add(BOX, middle + spin @ [x, side * (wide - 0.06), high / 2 + 0.05], (0.05, 0.05, high / 2 + 0.05), rotation=spin, material=wood)
            if bags and side > 0:
                for k in range(3):
                    bag(kit, middle + spin @ [half * (k - 1) * 0.66, wide + 0.3, high + 0.1], (half * 0.36, 0.24, 0.13), np.degrees(np.arctan2(along[1], along[0])), sand)
        kit.add(BOX, middle + [0, 0, 0.05], (half, wide * 0.6, 0.03), rotation=spin, material=wood, cut=(BARS, 6, 0.7))
    ladder(kit, (0, wide - 0.35, 0), (0, wide - 0.02, high + 0.2), 0.2, wood)


def netted_post(kit):
    rng = kit.rng
    net = tinted(kit, (OLIVE, (0.1, 0.14, 0.05), SAND), (CAMOUFLAGE,), frequency=9, second=(0.16, 0.11, 0.06), gloss=0.0)
    x, y, high, dark = rng.uniform(1.3, 2.0), rng.uniform(1.3, 1.8), rng.uniform(1.7, 2.1), metal(kit)
    leaves = (LEAVES, rng.uniform(3, 6), rng.uniform(0.55, 0.66))
    kit.add(BOX, (0, 0, high + 0.25), (x * 1.05, y * 1.05, 0.3), (0.35, 0.35), material=net, cut=leaves)
    for spin, half, reach in ((0, y, x), (90, x, y), (180, y, x), (270, x, y)):
        if spin or kit.chance(0.3):
            turned = turn("z", spin)
            kit.add(BOX, turned @ [reach * 1.35, 0, high / 2], (0.03, half * 1.3, high / 2), (1, 0.8), (-reach * 0.35, 0), turned, net, cut=leaves)
    for px in (-x, x):
        kit.between((px, y, 0), (px, y, high + 0.1), 0.035, material=dark, mirror=True)
    kit.between((0, 0, 0), (0, 0, high + 0.55), 0.04, material=dark)
    bag_line(kit, (x * 0.9, -y * 0.9), (x * 0.9, y * 0.9), 4, sacking(kit))
    for px, py in around(3, 0.35):
        kit.between((0.4 + px, py, 0), (0.4, 0, 1.2), 0.02, material=dark)
    kit.add(BOX, (0.45, 0, 1.27), (0.2, 0.14, 0.09), material=dark)


def tent(kit, style=None, x0=0.0, skin=None):
    rng = kit.rng
    skin, dark, pole = skin or canvas(kit), kit.material(dark=True, pattern=PLAIN), timber(kit)
    style = style or rng.choice(["ridge", "frame", "geodesic", "tunnel", "marquee", "bell", "pyramid"])
    long, wide, eave = rng.uniform(1.8, 3.4), rng.uniform(1.3, 2.0), rng.uniform(1.2, 1.6)
    top = eave + wide * rng.uniform(0.4, 0.7)
    if style in ("ridge", "frame"):
        eave = eave if style == "frame" else rng.uniform(0.3, 0.6)
        kit.add(BOX, (x0, 0, eave / 2), (long, wide, eave / 2), material=skin)
        kit.add(BOX, (x0, 0, (eave + top) / 2), (long * 1.01, wide * 1.06, (top - eave) / 2), (1, 0.02), material=skin)
        kit.add(BOX, (x0 + long, 0, top * 0.38), (0.03, wide * 0.3, top * 0.38), (1, 0.35), material=dark)
        kit.add(BOX, (x0 + long + 0.03, wide * 0.34, top * 0.36), (0.04, 0.1, top * 0.36), (1, 0.4), (0, -wide * 0.1), material=skin, mirror=True)
        for x in np.linspace(-0.7, 0.7, 4) * long + x0:
            if style == "frame":
                kit.add(BOX, (x, wide, eave * 0.6), (0.25, 0.02, eave * 0.18), material=dark, mirror=True)
            kit.between((x, wide * 1.04, eave), (x, wide * 1.04 + eave * 0.8, 0), 0.012, material=pole, mirror=True)
        kit.between((x0 - long * 1.02, 0, top), (x0 + long * 1.02, 0, top), 0.03, material=pole)
    elif style == "geodesic":
        kit.loft((x0, 0, 0), [(0, wide * 1.3), (top * 0.35, wide * 1.22), (top * 0.7, wide * 0.85), (top * 0.95, wide * 0.35), (top, wide * 0.02)], skin, PRISM, sides=int(rng.integers(6, 11)))
        kit.add(BOX, (x0 + wide * 1.15, 0, top * 0.32), (wide * 0.3, wide * 0.35, top * 0.34), (0.8, 0.6), material=skin)
        kit.add(BOX, (x0 + wide * 1.44, 0, top * 0.28), (0.03, wide * 0.25, top * 0.28), (1, 0.6), material=dark)
    elif style == "tunnel":
        points = [(wide * np.cos(a), top * np.sin(a) * 0.95) for a in np.linspace(0, np.pi / 2, 6)]
        for (w0, z0), (w1, z1) in zip(points[:-1], points[1:], strict=True):
            kit.add(BOX, (x0, 0, (z0 + z1) / 2), (long, w0, (z1 - z0) / 2), (1, max(w1 / w0, 0.02)), material=skin)
            for x in (-0.98, -0.33, 0.33, 0.98):
                kit.add(BOX, (x0 + x * long, 0, (z0 + z1) / 2), (0.07, w0 + 0.05, (z1 - z0) / 2 + 0.02), (1, max(w1 / w0, 0.05)), material=skin._replace(first=skin.first * 0.75))
        kit.add(BOX, (x0 + long, 0, top * 0.36), (0.12, wide * 0.35, top * 0.36), material=dark)
    elif style == "marquee":
        count = int(rng.integers(1, 4))
        for k in range(count):
            x = x0 + (k - (count - 1) / 2) * 2 * wide
            kit.add(BOX, (x, 0, 2.05), (wide * 1.02, wide * 1.02, 0.16), material=skin)
            kit.add(BOX, (x, 0, 2.5), (wide * 1.02, wide * 1.02, 0.3), (0.45, 0.45), material=skin)
            kit.add(BOX, (x, 0, 3.1), (wide * 0.46, wide * 0.46, 0.32), (0.12, 0.12), material=skin)
            if count == 1 or k:
                kit.add(BOX, (x, 0, 1.0), (wide * 0.97, wide * 0.97, 1.0), material=skin)
            for px in (-wide, wide):
                kit.between((x + px, wide, 0), (x + px, wide, 2.0), 0.05, material=pole, mirror=True)
    else:
        sides, low = (4, 0.9) if style == "pyramid" else (12, 0.7)
        spin = turn("z", 0)
        kit.loft((x0, 0, 0), [(0, wide * 1.2), (low, wide * 1.15), (low + 0.02, wide * 1.25), (top + 0.5, wide * 0.06)], skin, PRISM, spin, sides=sides)
        kit.add(BOX, (x0 + wide * 1.12, 0, 0.75), (0.1, 0.4, 0.75), (1, 0.5), (-0.25, 0), material=dark)
        kit.between((x0, 0, top + 0.4), (x0, 0, top + 0.8), 0.05, material=pole)
        for x, y in around(8, 1, 22.5):
            kit.between((x0 + wide * 1.2 * x, wide * 1.2 * y, low), (x0 + wide * 1.7 * x, wide * 1.7 * y, 0), 0.012, material=pole)


def field_kitchen(kit):
    paint, steel, dark, skin = drab(kit), metal(kit, 0.3, 0.55), kit.material(dark=True, pattern=PLAIN), canvas(kit)
    kit.add(BOX, (0, 0, 0.62), (1.2, 0.7, 0.08), material=paint)
    kit.add(CYL, (-0.1, 0.78, 0.38), (0.38, 0.38, 0.11), rotation=ALONG_Y, material=dark, mirror=True)
    kit.add(CYL, (-0.1, 0.82, 0.38), (0.2, 0.2, 0.1), rotation=ALONG_Y, material=paint, mirror=True)
    kit.between((1.15, 0.5, 0.6), (2.2, 0, 0.55), 0.05, BOX, material=paint, mirror=True)
    kit.between((2.1, 0, 0), (2.1, 0, 0.6), 0.05, material=dark)
    kit.between((-1.1, 0.6, 0), (-1.1, 0.6, 0.6), 0.04, material=dark, mirror=True)
    for k in range(2):
        for side in (-0.34, 0.34):
            x = -0.75 + 0.75 * k
            kit.add(BOX, (x, side, 0.95), (0.34, 0.32, 0.27), material=paint)
            kit.add(CYL, (x, side, 1.28), (0.27, 0.27, 0.08), material=steel)
            kit.add(BALL, (x, side, 1.36), (0.26, 0.26, 0.1), material=steel)
    kit.between((0.75, 0, 0.65), (0.75, 0, 2.9), 0.09, material=dark)
    kit.add(CYL, (0.75, 0, 2.95), (0.15, 0.15, 0.06), material=dark)
    kit.add(BOX, (0.75, 0, 0.9), (0.3, 0.5, 0.25), material=paint)
    if kit.chance(0.6):
        for x in (-1.3, 0.5):
            kit.between((x, 1.3, 0), (x, 1.3, 2.1), 0.03, material=steel, mirror=True)
        kit.add(BOX, (-0.4, 0, 2.3), (1.05, 1.45, 0.22), (1, 0.05), material=skin)
    kit.add(BOX, (-0.3, 1.9, 0.72), (0.8, 0.3, 0.03), material=timber(kit))
    for x in (-1.0, 0.4):
        kit.add(BOX, (x, 1.9, 0.35), (0.03, 0.28, 0.35), material=steel)
    for x in (-0.7, -0.1):
        kit.add(CYL, (x, 1.9, 0.87), (0.15, 0.15, 0.13), material=steel)


def box_cabin(kit, x, y, z, half, paint, glass, dark, spin=0):
    """A freight container as a room: ribbed, with corner posts, a door at +y and windows."""
    turned, base = turn("z", spin), np.array([x, y, z + 1.2])
    kit.add(BOX, base, (half, 1.1, 1.12), rotation=turned, material=paint)
    for end in (-1, 1):
        kit.add(BOX, base + turned @ [end * (half - 0.06), 0, 0], (0.09, 1.16, 1.2), rotation=turned, material=paint._replace(pattern=PLAIN))
    kit.add(BOX, base + turned @ [half * 0.3, 1.1, -0.15], (0.42, 0.04, 1.0), rotation=turned, material=dark)
    kit.add(BOX, base + turned @ [-half * 0.4, 0, 0.25], (0.45, 1.13, 0.38), rotation=turned, material=glass)
    kit.add(BOX, base + turned @ [half + 0.2, 0.4, 0.5], (0.2, 0.4, 0.3), rotation=turned, material=tinted(kit, (WHITE, GREY)))


def cabin_paint(kit):
    return tinted(kit, (SAND, WHITE, OLIVE, GREY, BLUE), (RIBS,), frequency=kit.rng.uniform(10, 18), gloss=0.08)


def field_hospital(kit):
    paint, red, white, dark = cabin_paint(kit), kit.material(base=(0.55, 0.02, 0.02), pattern=PLAIN), kit.material(base=(0.8, 0.8, 0.78), pattern=PLAIN), kit.material(dark=True)
    skin = canvas(kit)
    tent(kit, kit.rng.choice(["frame", "tunnel"]), 0, skin)
    reach = bounds(kit.primitives)[0][0]
    for k, y in enumerate((-1.3, 1.3)[: int(kit.rng.integers(1, 3))]):
        box_cabin(kit, reach - 2.4, y, 0, 2.6, paint, glazing(kit), dark, 0 if k else 180)
        side = 1 if k else -1
        kit.add(BOX, (reach - 1.5, y + side * 1.12, 1.45), (0.5, 0.05, 0.5), material=white)
        kit.add(BOX, (reach - 1.5, y + side * 1.15, 1.45), (0.4, 0.05, 0.12), material=red)
        kit.add(BOX, (reach - 1.5, y + side * 1.15, 1.45), (0.12, 0.05, 0.4), material=red)
    kit.add(BOX, (reach - 2.4, 0, 2.45), (0.75, 0.75, 0.06), material=white)
    kit.add(BOX, (reach - 2.4, 0, 2.5), (0.6, 0.18, 0.05), material=red)
    kit.add(BOX, (reach - 2.4, 0, 2.5), (0.18, 0.6, 0.05), material=red)


def command_post(kit):
    rng = kit.rng
    steel, dark, paint = metal(kit), kit.material(dark=True), drab(kit)
    tent(kit, rng.choice(["frame", "geodesic", "pyramid"]))
    reach = bounds(kit.primitives)[0][0]
    box_cabin(kit, reach - 1.3, 0, 0.5, 1.5, paint, glazing(kit), dark)
    for x in (-2.2, -0.5):
        kit.add(CYL, (reach + x, 0.9, 0.4), (0.4, 0.4, 0.16), rotation=ALONG_Y, material=dark, mirror=True)
    high = rng.uniform(5, 8)
    kit.between((reach - 3.3, 0, 0), (reach - 3.3, 0, high), 0.07, CYL, 0.5, material=steel)
    kit.between((reach - 2.7, 0, 2.4), (reach - 3.3, 0, 2.4), 0.06, material=steel)
    for x, y in around(3, 1.4):
        kit.between((reach - 3.3 + x, y, 0), (reach - 3.3, 0, high * 0.6), 0.015, material=steel)
    for z in (high, high * 0.93, high * 0.86):
        kit.between((reach - 3.3, -0.5, z), (reach - 3.3, 0.5, z), 0.02, material=steel)
    if kit.chance(0.5):
        kit.add(CYL, (reach - 1.3, 0, 3.3), (0.5, 0.5, 0.06), (0.7, 1), rotation=turn("y", 50), material=tinted(kit, (WHITE, GREY)))
        kit.between((reach - 1.3, 0, 2.8), (reach - 1.3, 0, 3.3), 0.05, material=steel)


def container_camp(kit):
    rng = kit.rng
    dark, steel, count = kit.material(dark=True), metal(kit), int(rng.integers(2, 4))
    paint, two = cabin_paint(kit), kit.chance(0.6)
    for k in range(count):
        for level in range(2 if two and (k < count - 1 or kit.chance(0.5)) else 1):
            box_cabin(kit, 0, 0, 0, 2.6, paint if kit.chance(0.7) else cabin_paint(kit), glazing(kit), dark)
            swing(kit, len(kit.primitives) - 6, turn("z", -90), (0, (k - (count - 1) / 2) * 2.4, 2.42 * level))
    if two:
        y = -(count - 1) * 1.2
        kit.add(BOX, (3.2, 0, 2.42), (0.6, count * 1.2, 0.06), material=steel)
        stairs(kit, (3.2, y - 3.8, 0), (3.2, y - 1.2, 2.4), 0.45, steel)
        kit.railing((3.75, -count * 1.2, 2.45), (3.75, count * 1.2, 2.45), 1.0, steel, 0.3)
        for side in (-1, 1):
            kit.between((3.7, side * count * 1.15, 0), (3.7, side * count * 1.15, 2.4), 0.06, BOX, material=steel)


def fuel_bladder(kit):
    skin, liner, steel = tinted(kit, (SAND, OLIVE, (0.04, 0.04, 0.04)), (PLAIN, SEAMS)), kit.material(dark=True, gloss=0.2), metal(kit)
    long, count = kit.rng.uniform(1.6, 2.4), int(kit.rng.integers(1, 4))
    for k in range(count):
        y = (k - (count - 1) / 2) * 3.2
        kit.add(BOX, (0, y, 0.03), (long + 0.3, 1.5, 0.03), material=liner)
        bag(kit, (0, y, 0.45), (long, 1.25, 0.45), 0, skin)
        for side in (-1, 1):
            kit.add(BOX, (0, y + side * 1.45, 0.2), (long + 0.4, 0.16, 0.2), (0.98, 0.4), material=liner)
            kit.add(BOX, (side * (long + 0.3), y, 0.2), (0.16, 1.4, 0.2), (0.4, 1), material=liner)
        kit.add(CYL, (0, y, 0.92), (0.18, 0.18, 0.06), material=steel)
        kit.chain([(long * 0.9, y, 0.4), (long + 0.5, y, 0.5), (long + 0.9, y, 0.07)], 0.06, liner)
    kit.between((long + 0.9, -1.6 * count, 0.07), (long + 0.9, 1.6 * count, 0.07), 0.07, material=liner)
    kit.add(BOX, (long + 1.1, 1.6 * count, 0.3), (0.3, 0.4, 0.3), material=drab(kit))


def pallet(kit, x, y, wood):
    kit.add(BOX, (x, y, 0.13), (0.6, 0.5, 0.02), material=wood)
    for side in (-0.42, 0, 0.42):
        kit.add(BOX, (x, y + side, 0.055), (0.6, 0.06, 0.055), material=wood)


def ammunition(kit):
    rng = kit.rng
    crate, wood, brass, dark = tinted(kit, (OLIVE, WOOD, OLIVE), (PLANKS, PLAIN), frequency=9), timber(kit), drab(kit), kit.material(dark=True)
    levels, count = int(rng.integers(2, 5)), int(rng.integers(2, 4))
    for k in range(count):
        for level in range(levels - (k == count - 1) * int(rng.integers(0, 2))):
            at = (rng.normal(0, 0.03), (k - 1) * 1.05, 0.17 + 0.31 * level)
            kit.add(BOX, at, (0.42, 0.5, 0.15), material=crate)
            kit.add(BOX, (at[0] + 0.25, at[1], at[2]), (0.04, 0.51, 0.16), material=wood)
            kit.add(BOX, (at[0] - 0.25, at[1], at[2]), (0.04, 0.51, 0.16), material=wood)
    for k in range(int(rng.integers(2, 6))):
        at = (0.9, (k - 2) * 0.3, 0)
        kit.loft(at, [(0, 0.1), (0.5, 0.1), (0.72, 0.06), (0.85, 0.015)], brass)
    kit.add(BOX, (0.9, 1.0, 0.13), (0.3, 0.2, 0.13), material=crate)
    kit.add(BOX, (0.7, 1.0, 0.4), (0.02, 0.2, 0.18), rotation=turn("y", -20), material=dark)


def pallets(kit):
    rng = kit.rng
    wood = timber(kit)
    for k in range(int(rng.integers(1, 4))):
        y, goods = 1.25 * k, rng.choice(["sacks", "boxes", "drums", "wrapped"])
        pallet(kit, 0, y, wood)
        if goods == "sacks":
            sand = sacking(kit)
            for level in range(3):
                for x in (-0.3, 0.3):
                    bag(kit, (x, y, 0.26 + 0.21 * level), (0.31, 0.48, 0.13), rng.normal(0, 3), sand)
        elif goods == "boxes":
            card = tinted(kit, ((0.38, 0.25, 0.13), OLIVE, WHITE), (PLAIN, WRITING), frequency=9)
            for level in range(3):
                for x in (-0.29, 0.29):
                    for side in (-0.24, 0.24):
                        if level < 2 or kit.chance(0.6):
                            kit.add(BOX, (x, y + side, 0.34 + 0.385 * level), (0.28, 0.23, 0.19), material=card)
        elif goods == "drums":
            paint = tinted(kit, (BLUE, OLIVE, RED, RUST))
            for x in (-0.29, 0.29):
                for side in (-0.25, 0.25):
                    kit.add(CYL, (x, y + side, 0.55), (0.25, 0.25, 0.4), material=paint)
                    kit.add(TUBE, (x, y + side, 0.55), (0.265, 0.265, 0.16), material=paint)
        else:
            high = rng.uniform(0.4, 0.7)
            kit.add(BOX, (0, y, 0.15 + high), (0.57, 0.47, high), material=tinted(kit, (WHITE, GREY, (0.1, 0.1, 0.1)), gloss=0.5))
            kit.add(BOX, (0.2, y, 0.15 + high), (0.03, 0.48, high + 0.01), material=kit.material(dark=True))


def cans(kit):
    rng = kit.rng
    paint, dark = tinted(kit, (OLIVE, OLIVE, SAND, RED)), kit.material(dark=True)
    if kit.chance(0.5):
        for row in range(2):
            for k in range(int(rng.integers(3, 6))):
                x, y = 0.55 * row, 0.24 * k
                kit.add(BOX, (x, y, 0.2), (0.17, 0.08, 0.2), material=paint)
                kit.add(BOX, (x, y, 0.43), (0.17, 0.08, 0.035), (0.7, 0.8), (-0.03, 0), material=paint)
                kit.add(BOX, (x - 0.02, y, 0.51), (0.1, 0.06, 0.012), material=paint)
                kit.add(BOX, (x - 0.02, y, 0.48), (0.015, 0.06, 0.03), material=paint)
                kit.add(CYL, (x + 0.14, y, 0.48), (0.035, 0.035, 0.035), material=dark)
    else:
        for k in range(int(rng.integers(4, 12))):
            x, y = 0.64 * (k % 2), 0.64 * (k // 2)
            kit.add(CYL, (x, y, 0.44), (0.29, 0.29, 0.44), material=paint if kit.chance(0.8) else rusty(kit))
            for z in (0.02, 0.3, 0.58, 0.86):
                kit.add(TUBE, (x, y, z), (0.305, 0.305, 0.022), material=paint)


def generator(kit):
    rng = kit.rng
    paint, dark, long = tinted(kit, (OLIVE, SAND, YELLOW, WHITE, GREEN)), kit.material(dark=True), rng.uniform(1.0, 1.7)
    kit.add(BOX, (0, 0, 0.12), (long * 1.05, 0.6, 0.12), material=dark)
    kit.add(BOX, (0, 0, 0.8), (long, 0.58, 0.58), material=paint)
    kit.add(BOX, (0, 0, 1.42), (long * 1.02, 0.6, 0.05), (0.95, 0.9), material=paint)
    for x in (-0.5, 0.1):
        kit.add(BOX, (x * long, 0, 0.75), (long * 0.22, 0.59, 0.4), material=paint._replace(first=paint.first * 0.8))
    kit.add(BOX, (long, 0, 0.85), (0.02, 0.42, 0.38), material=dark, cut=(RUNGS, 8, 0.6))
    kit.add(BOX, (0.7 * long, 0, 0.9), (0.2, 0.6, 0.22), material=dark)
    kit.between((-0.6 * long, 0.2, 1.4), (-0.6 * long, 0.2, 1.8), 0.06, material=dark)
    kit.add(BOX, (-0.3 * long, 0.585, 0.8), (0.04, 0.02, 0.08), material=dark, mirror=True)
    kit.chain([(-long, 0.3, 0.3), (-long - 0.4, 0.4, 0.05), (-long - 1.0, 0.1, 0.05)], 0.04, dark)


def light_tower(kit):
    rng = kit.rng
    paint, steel, dark, lamp = tinted(kit, (YELLOW, OLIVE, WHITE, ORANGE)), metal(kit, 0.3, 0.5), kit.material(dark=True), kit.material(base=(0.9, 0.9, 0.8), pattern=PLAIN, gloss=0.6)
    high = rng.uniform(4, 6.5)
    kit.add(BOX, (0, 0, 0.8), (0.95, 0.55, 0.4), (0.95, 0.85), material=paint)
    kit.add(CYL, (-0.1, 0.65, 0.32), (0.32, 0.32, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
    kit.between((0.9, 0, 0.45), (1.9, 0, 0.45), 0.05, BOX, material=steel)
    kit.between((1.8, 0, 0), (1.8, 0, 0.5), 0.04, material=steel)
    for x in (-0.8, 0.8):
        kit.between((x, 0.5, 0.45), (x, 1.2, 0.45), 0.04, BOX, material=steel, mirror=True)
        kit.between((x, 1.2, 0), (x, 1.2, 0.6), 0.04, material=steel, mirror=True)
    for k, radius in enumerate((0.1, 0.075, 0.05)):
        kit.between((0.7, 0, 0.5 if k == 0 else high * k / 3), (0.7, 0, high * (k + 1) / 3), radius, BOX, material=steel)
    kit.between((0.7, -0.9, high), (0.7, 0.9, high), 0.04, BOX, material=steel)
    for y in (0.3, 0.8):
        kit.add(BOX, (0.78, y, high + 0.02), (0.12, 0.22, 0.2), rotation=turn("y", 20), material=dark, mirror=True)
        kit.add(BOX, (0.89, y, high - 0.02), (0.02, 0.19, 0.17), rotation=turn("y", 20), material=lamp, mirror=True)


def toilets(kit):
    rng = kit.rng
    paint, white, dark, count = tinted(kit, (BLUE, GREEN, OLIVE, ORANGE, GREY)), tinted(kit, (WHITE,)), kit.material(dark=True), int(rng.integers(1, 6))
    for k in range(count):
        y = 1.2 * (k - (count - 1) / 2)
        kit.add(BOX, (0, y, 0.08), (0.56, 0.54, 0.08), material=dark)
        kit.add(BOX, (0, y, 1.1), (0.52, 0.52, 0.98), material=paint)
        kit.add(BOX, (0.52, y, 1.1), (0.03, 0.38, 0.88), material=paint._replace(first=paint.first * 0.7))
        kit.add(BOX, (0, y, 2.2), (0.57, 0.57, 0.14), (0.8, 0.6), material=white)
        kit.add(BOX, (0.55, y + 0.28, 1.1), (0.02, 0.03, 0.06), material=dark)
        kit.add(BOX, (0.55, y, 1.65), (0.02, 0.14, 0.12), material=white)
        kit.between((-0.4, y + 0.4, 2.1), (-0.4, y + 0.4, 2.5), 0.05, material=dark)


def obstacles(kit):
    rng = kit.rng
    if kit.chance(0.5):
        steel = rusty(kit) if kit.chance(0.6) else metal(kit)
        for k in range(int(rng.integers(1, 4))):
            spin, at = turn("z", rng.uniform(0, 90)), np.array([1.9 * k, rng.uniform(-0.3, 0.3), 0.62])
            for way in ((1, 1, 1), (1, -1, -1), (-1, 1, -1)):
                out = spin @ np.array(way) * 0.56
                kit.between(at - out, at + out, (0.02, 0.1), BOX, material=steel)
                kit.between(at - out, at + out, (0.1, 0.02), BOX, material=steel)
            kit.add(BOX, at, (0.17, 0.17, 0.17), rotation=spin, material=steel)
    else:
        stone, rows = cast(kit), int(rng.integers(2, 4))
        for row in range(rows):
            kit.add(BOX, (1.3 * row, 0, 0.1), (0.55, 3.0, 0.1), material=stone)
            for k in range(4):
                kit.add(BOX, (1.3 * row, 1.45 * (k - 1.5) + 0.3 * (row % 2), 0.65), (0.5, 0.5, 0.47), (rng.uniform(0.25, 0.45),) * 2, material=stone)


def wire(kit):
    steel, high = metal(kit, 0.2, 0.5), kit.rng.uniform(0.38, 0.5)
    long = 2.4
    wire_coil(kit, (0.42, -long, high), (0.42, long, high), high, 16, steel)
    wire_coil(kit, (-0.42, -long, high), (-0.42, long, high), high, 16, steel)
    if kit.chance(0.6):
        wire_coil(kit, (0, -long, high * 2.7), (0, long, high * 2.7), high, 16, steel)
    for y in (-long, 0, long):
        kit.between((0, y, 0), (0, y, high * 3.8), 0.035, BOX, material=rusty(kit))
    for z in (high * 0.9, high * 2.7):
        kit.between((0, -long, z), (0, long, z), 0.012, material=steel)


def spikes(kit):
    steel, dark = metal(kit, 0.35, 0.6), kit.material(dark=True)
    count = int(kit.rng.integers(7, 13))
    for k in range(count):
        way = turn("z", 35 if k % 2 else -35)
        at = np.array([0, 0.34 * (k - (count - 1) / 2), 0.05])
        kit.add(BOX, at, (0.03, 0.24, 0.03), rotation=way, material=dark)
        for y in (-0.18, 0, 0.18):
            kit.add(CYL, at + way @ [0, y, 0.12], (0.03, 0.03, 0.1), (0.1, 1), material=steel)


def pontoon(kit):
    rng = kit.rng
    hull, deck, steel, count = drab(kit), metal(kit, 0.15, 0.35), metal(kit), int(rng.integers(3, 6))
    for k in range(count):
        x = 2.6 * (k - (count - 1) / 2)
        kit.add(BOX, (x, 0, 0.4), (0.85, 2.6, 0.4), (1.1, 1.1), material=hull)
        for side in (-1, 1):
            kit.add(BOX, (x, side * 3.1, 0.5), (0.85, 0.6, 0.3), (1.1, 0.7), (0, side * 0.5), material=hull)
        kit.between((x, 1.9, 0.8), (x, 1.9, 1.9), 0.05, material=steel, mirror=True)
    reach = 1.3 * count
    kit.add(BOX, (0, 0, 0.95), (reach, 1.9, 0.12), material=deck._replace(pattern=PLANKS, frequency=14.0))
    kit.add(BOX, (0, 1.8, 1.12), (reach, 0.12, 0.1), material=hull, mirror=True)
    kit.add(BOX, (reach + 1.4, 0, 0.5), (1.55, 1.8, 0.08), rotation=turn("y", 17), material=deck)
    kit.add(BOX, (-reach - 1.4, 0, 0.5), (1.55, 1.8, 0.08), rotation=turn("y", -17), material=deck)
    for side in (-1.9, 1.9):
        kit.between((-reach, side, 1.8), (reach, side, 1.8), 0.035, material=steel)


def bridge_span(kit):
    paint, half, deep = drab(kit), kit.rng.uniform(5, 8), kit.rng.uniform(0.5, 0.8)
    stone, earth = cast(kit), soil(kit)
    for side in (-1.15, 1.15):
        for way in (-1, 1):
            kit.add(BOX, (way * half / 2, side, 1.3), (half / 2, 0.7, deep / 2 - 0.1), (1, 1), material=paint)
            kit.add(BOX, (way * half, side, 1.2 + deep / 2 - 0.1), (half * 0.25, 0.7, 0.12), rotation=turn("y", way * 6), material=paint)
        kit.add(BOX, (0, side, 1.3 + deep / 2), (half, 0.72, 0.06), material=metal(kit)._replace(pattern=STRIPES, frequency=25.0))
        kit.add(BOX, (0, side, 1.3), (0.2, 0.76, deep / 2), material=metal(kit))
    for x in np.linspace(-0.8, 0.8, 5) * half:
        kit.between((x, -1.1, 1.2), (x, 1.1, 1.2), 0.08, BOX, material=paint)
    for way in (-1, 1):
        kit.add(BOX, (way * (half + 0.4), 0, 0.5), (1.6, 2.6, 0.5), (0.75, 0.9), material=stone if kit.chance(0.4) else earth)


def helipad(kit):
    rng = kit.rng
    stone, white, steel = cast(kit), tinted(kit, (WHITE, YELLOW)), metal(kit)
    radius, sides, high = 4.0, int(rng.choice([4, 8, 8, 30])), rng.choice([0.15, 1.8])
    kind = CYL if sides == 30 else PRISM
    turned = turn("z", 180 / sides)
    kit.add(kind, (0, 0, high), (radius, radius, 0.15), (1, sides), rotation=turned, material=stone)
    kit.add(CYL, (0, 0, high + 0.155), (radius * 0.86, radius * 0.86, 0.01), material=white)
    kit.add(CYL, (0, 0, high + 0.165), (radius * 0.78, radius * 0.78, 0.01), material=tinted(kit, (GREY, GREEN, CONCRETE, BLUE)))
    kit.add(BOX, (0, 0.85, high + 0.175), (1.5, 0.22, 0.015), material=white, mirror=True)
    kit.add(BOX, (0, 0, high + 0.175), (0.22, 0.8, 0.015), material=white)
    for x, y in around(8, radius * 0.95, 22.5):
        kit.add(CYL, (x, y, high + 0.2), (0.1, 0.1, 0.07), material=tinted(kit, (YELLOW, GREEN), gloss=0.4))
        if high > 1:
            kit.between((x * 0.85, y * 0.85, 0), (x * 0.85, y * 0.85, high), 0.12, material=steel)
    base = 0 if high < 1 else high
    kit.between((radius * 0.97, 0, base), (radius * 0.97, 0, base + 2.6), 0.05, material=steel)
    for k in range(3):
        kit.add(CYL, (radius * 0.97 - 0.25 - 0.45 * k, 0, base + 2.5 - 0.07 * k), (0.22 - 0.04 * k, 0.22 - 0.04 * k, 0.24), (0.8, 1), rotation=ALONG_X.T, material=tinted(kit, (RED, WHITE)[k % 2 : k % 2 + 1]))


def revetment(kit):
    fill, mesh, paint, dark = sacking(kit), metal(kit, 0.3, 0.6), drab(kit), kit.material(dark=True)
    if kit.chance(0.5):
        for k in range(4):
            for side in (-1, 1):
                gabion(kit, -2.4 + 1.2 * k, side * 2.4, 0.6, 1.3, mesh, fill)
            gabion(kit, -3.6, 1.2 * (k - 1.5), 0.6, 1.3, mesh, fill)
    else:
        for side in (-1, 1):
            kit.add(BOX, (-0.4, side * 2.6, 0.8), (3.3, 1.1, 0.8), (0.9, 0.3), material=fill)
        kit.add(BOX, (-3.4, 0, 0.8), (1.1, 3.6, 0.8), (0.3, 0.75), material=fill)
    kit.add(BOX, (0, 0, 0.85), (2.2, 1.1, 0.35), (0.95, 0.95), (-0.1, 0), material=paint)
    kit.add(BOX, (0, 1.0, 0.42), (2.1, 0.28, 0.4), (0.92, 1), material=dark, mirror=True)
    for x in np.linspace(-1.6, 1.6, 5):
        kit.add(CYL, (x, 1.27, 0.36), (0.32, 0.32, 0.05), rotation=ALONG_Y, material=paint, mirror=True)
    kit.add(BOX, (-0.2, 0, 1.45), (0.95, 0.85, 0.3), (0.75, 0.8), material=paint)
    kit.between((0.5, 0, 1.45), (3.0, 0, 1.5), 0.08, material=paint)
    kit.add(CYL, (-0.3, 0.3, 1.8), (0.25, 0.25, 0.08), material=paint)


def targets(kit):
    rng = kit.rng
    wood, face = timber(kit), tinted(kit, (GREEN, (0.04, 0.04, 0.04), OLIVE, (0.38, 0.25, 0.13), WHITE))
    kind = rng.choice(["man", "round", "tank"])
    for k in range(int(rng.integers(1, 6)) if kind != "tank" else 1):
        y = 1.3 * k
        if kind == "tank":
            kit.add(BOX, (0, 0, 0.75), (0.03, 2.2, 0.45), (1, 0.9), material=face)
            kit.add(BOX, (0, -0.2, 1.5), (0.03, 1.0, 0.3), (1, 0.7), material=face)
            kit.add(BOX, (0, 1.7, 1.5), (0.03, 1.2, 0.07), material=face)
            for side in (-1.6, 0, 1.6):
                kit.between((-0.06, side, 0), (-0.06, side, 1.2), 0.05, BOX, material=wood)
                kit.between((-0.9, side, 0), (-0.06, side, 1.0), 0.04, BOX, material=wood)
            continue
        kit.between((-0.05, y + 0.2, 0), (-0.05, y + 0.2, 1.5), 0.03, BOX, material=wood)
        kit.between((-0.05, y - 0.2, 0), (-0.05, y - 0.2, 1.5), 0.03, BOX, material=wood)
        kit.add(BOX, (-0.05, y, 0.06), (0.35, 0.3, 0.06), material=wood)
        if kind == "man":
            kit.add(BOX, (0, y, 1.1), (0.02, 0.3, 0.4), (1, 0.9), material=face)
            kit.add(BOX, (0, y, 1.56), (0.02, 0.27, 0.07), (1, 0.5), material=face)
            kit.add(CYL, (0, y, 1.75), (0.15, 0.14, 0.02), rotation=ALONG_X, material=face)
        for n, shade in enumerate((0.75, 0.04, 0.75, 0.04)[: 4 if kind == "round" else 2]):
            radius = (0.5 if kind == "round" else 0.16) * (1 - 0.26 * n)
            kit.add(CYL, (0.025 + 0.008 * n, y, 1.15), (radius, radius, 0.02), rotation=ALONG_X, material=kit.material(base=(shade, shade, shade), pattern=PLAIN))


def obstacle_course(kit):
    rng = kit.rng
    wood, rope = timber(kit), tinted(kit, (SAND,))
    kinds = rng.permutation(["wall", "bars", "net", "beams"])[: int(rng.integers(1, 4))]
    for k, kind in enumerate(kinds):
        x = 2.6 * k
        if kind == "wall":
            kit.add(BOX, (x, 0, 1.1), (0.06, 1.1, 1.1), material=wood)
            for y in (-1, 0, 1):
                kit.between((x, y, 0), (x, y, 2.25), 0.08, BOX, material=wood)
                kit.between((x - 1.0, y, 0), (x, y, 1.9), 0.06, BOX, material=wood)
            kit.between((x + 0.1, 0.5, 0.1), (x + 0.08, 0.5, 2.2), 0.025, material=rope)
            continue
        for px in (-0.9, 0.9) if kind != "beams" else ():
            kit.between((x + px, 1.0, 0), (x + px, 1.0, 2.4), 0.07, material=wood, mirror=True)
            kit.between((x + px, -1.1, 2.4), (x + px, 1.1, 2.4), 0.06, material=wood)
        if kind == "bars":
            kit.add(BOX, (x, 0, 2.5), (1.0, 1.0, 0.04), material=wood, cut=(BARS, 3, 0.25))
        elif kind == "net":
            kit.add(BOX, (x + 0.9, 0, 1.2), (0.03, 1.0, 1.2), material=rope, cut=(GRID, 4, 0.18))
            kit.add(BOX, (x - 0.9, 0, 1.2), (0.03, 1.0, 1.2), material=rope, cut=(GRID, 4, 0.18))
            kit.between((x - 0.9, 0, 2.4), (x + 0.9, 0, 2.4), 0.06, material=wood)
        else:
            for px, high in ((-0.9, 0.6), (0, 1.1), (0.9, 0.8)):
                kit.between((x + px, 1.1, 0), (x + px, 1.1, high + 0.2), 0.07, material=wood, mirror=True)
                kit.between((x + px, -1.2, high), (x + px, 1.2, high), 0.09, material=wood)


def watch_platform(kit):
    rng = kit.rng
    wood, high, half, sand = timber(kit) if kit.chance(0.6) else metal(kit), rng.uniform(2.5, 5.5), rng.uniform(0.9, 1.2), sacking(kit)
    ring = [(i * half, j * half) for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    for (x, y), (u, v) in zip(ring, ring[1:] + ring[:1], strict=True):
        kit.between((x * 1.3, y * 1.3, 0), (x, y, high), 0.08, BOX, material=wood)
        kit.between((x, y, high), (x, y, high + 2.1), 0.06, BOX, material=wood)
        kit.between((x * 1.27, y * 1.27, high * 0.1), (u * 1.03, v * 1.03, high * 0.9), 0.05, BOX, material=wood)
        if kit.chance(0.8):
            kit.add(BOX, ((x + u) / 2, (y + v) / 2, high + 0.5), (max(abs(x - u) / 2, 0.04), max(abs(y - v) / 2, 0.04), 0.45), material=wood)
    kit.add(BOX, (0, 0, high), (half * 1.1, half * 1.1, 0.07), material=wood)
    kit.add(BOX, (0, 0, high + 2.3), (half * 1.3, half * 1.3, 0.25), (0.1, 0.1) if kit.chance(0.5) else (1, 0.05), material=tinted(kit, (GREY, RUST, OLIVE, WOOD), (RIBS, PLANKS), frequency=12))
    ladder(kit, (half * 1.7, 0, 0), (half * 1.05, 0, high), 0.25, wood)
    if kit.chance(0.5):
        bag_line(kit, (half, -half), (half, half), 2, sand, high + 0.05)
    kit.add(BOX, (half + 0.15, half * 0.5, high + 1.1), (0.12, 0.14, 0.14), material=metal(kit))


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
