"""A maker of military posts, camps and exercise areas; drawn here: posts of sandbags, gabions, walls, checkpoints, bunkers, trenches, obstacles, bridges."""

import numpy as np

from .camps import (
    ammunition,
    cans,
    command_post,
    container_camp,
    field_hospital,
    field_kitchen,
    fuel_bladder,
    generator,
    helipad,
    light_tower,
    obstacle_course,
    pallets,
    targets,
    tent,
    toilets,
)
from .earthworks import bag, bag_line, bag_ring, cast, heap, rusty, sacking, soil
from .installations import BLUE, BRICK, CONCRETE, GREEN, GREY, OLIVE, RED, RUST, SAND, WHITE, WOOD, YELLOW, ladder, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .launchers import drab, metal, timber
from .layout import BALL, BARS, BOX, CYL, GRID, LEAVES, PRISM, TUBE
from .materials import BRICKS, CAMOUFLAGE, PLAIN, PLANKS, RIBS, STRIPES, WRITING
from .wheeled import glazing


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
    chevron = kit.material(
        base=rng.choice([[0.75, 0.75, 0.7], [0.1, 0.2, 0.1], [0.3, 0.17, 0.08]]),
        pattern=rng.choice([STRIPES, PLANKS]),
        frequency=6,
        second=rng.choice([[0.45, 0.03, 0.02], [0.03, 0.03, 0.03], [0.05, 0.1, 0.35]]),
    )
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
    kit.add(
        BOX,
        (0, 0, high + 2.3),
        (half * 1.3, half * 1.3, 0.25),
        (0.1, 0.1) if kit.chance(0.5) else (1, 0.05),
        material=tinted(kit, (GREY, RUST, OLIVE, WOOD), (RIBS, PLANKS), frequency=12),
    )
    ladder(kit, (half * 1.7, 0, 0), (half * 1.05, 0, high), 0.25, wood)
    if kit.chance(0.5):
        bag_line(kit, (half, -half), (half, half), 2, sand, high + 0.05)
    kit.add(BOX, (half + 0.15, half * 0.5, high + 1.1), (0.12, 0.14, 0.14), material=metal(kit))
