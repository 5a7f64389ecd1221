"""A maker of playgrounds, of what stands in gardens, and of street furniture."""

import numpy as np

from .belongings import arc, black, brass, cloth, enamel, lens, pale, ribbon, steel, timber
from .fittings import bent, box, disc, fronts, gable, glass, hoop, iron, near, pick, planks, posts, rod, shade, stone, ware
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, LEAVES, PRISM, RUNGS, TUBE
from .materials import BRICKS, CHECKER, CLOUDY, PLAIN, PLANKS, RIBS, SHINGLES, SPECKLES, STRIPES, WRITING
from .street import bin_, bollards, bus_stop, hydrant, phone_box, post_box, rack, road_sign, stall, street_lamp, tap, traffic_light, vending
from .toys import bright
from .worn import dome


def playground(kit):
    """Slides, swings, see-saws, climbing domes, roundabouts, spring riders, sandpits, play houses and forts, trampolines, goals, hoops, table tennis, picnic tables, parasols, tents,
    stalls, phone and post boxes, lamps, traffic lights, signs, bus stops, bollards, bins, hydrants, vending machines, bicycle racks, fountains, wells, arbours, pergolas, gazebos,
    sheds, greenhouses, barbecues, mowers, watering cans, fences with a gate."""
    pick(
        kit,
        [slide, spiral_slide, swings, seesaw, dome_frame, roundabout, spring_rider, sandpit, play_house, play_house, fort, fort, trampoline, goal, hoop, ping_pong, picnic]
        + [parasol, parasol, tent, stall, stall, phone_box, post_box, tap, street_lamp, traffic_light, road_sign, bus_stop, bollards, bin_, hydrant, vending, rack]
        + [tiers, well, arbour, pergola, gazebo, shed, greenhouse, barbecue, mower, can, wheelie, gate],
    )


def chute(kit, start, end, wide, material):
    """A straight slide with its side walls, along x."""
    start, end = np.array(start, float), np.array(end, float)
    level = end + [0.35, 0, -0.02]
    for a, b in ((start, end), (end, level)):
        kit.between(a, b, (0.02, wide), BOX, material=material)
        for side in (-wide, wide):
            kit.between(a + [0, side, 0.07], b + [0, side, 0.07], (0.09, 0.02), BOX, material=material)
    rod(kit, level - [0.15, wide * 0.7, level[2]], level - [0.15, wide * 0.7, 0], 0.03, material)
    rod(kit, level - [0.15, -wide * 0.7, level[2]], level - [0.15, -wide * 0.7, 0], 0.03, material)


def slide(kit):
    metal, high, long = bright(kit), kit.rng.uniform(1.2, 2.0), kit.rng.uniform(1.4, 2.0)
    chute(kit, (0.2, 0, high), (0.2 + high * long * 0.8, 0, 0.2), 0.24, bright(kit) if kit.chance(0.7) else steel(kit))
    box(kit, (0, 0, high), (0.28, 0.27, 0.03), metal)
    posts(kit, 0.24, 0.25, 0, high, 0.03, metal)
    kit.between((-0.2 - high * 0.3, 0, 0), (-0.25, 0, high), (0.03, 0.24), BOX, material=metal, cut=(RUNGS, 4.5, 0.35))
    rod(kit, (-0.2 - high * 0.3, 0.25, 0), (-0.25, 0.25, high), 0.025, metal, True)
    for y in (-0.26, 0.26):
        bent(kit, [(-0.28, y, high), (-0.25, y, high + 0.5), (0.2, y, high + 0.5), (0.28, y, high)], 0.02, metal)


def spiral_slide(kit):
    paint, metal, high, r = bright(kit), bright(kit), kit.rng.uniform(1.9, 2.6), 0.62
    turns, n = kit.rng.uniform(300, 430), 16
    rod(kit, (0, 0, 0), (0, 0, high + 1.0), 0.07, metal)
    points = [np.array([r * np.cos(a), r * np.sin(a), high - (high - 0.2) * k / n]) for k, a in enumerate(np.radians(180 + np.linspace(0, turns, n + 1)))]
    for a, b in zip(points[:-1], points[1:], strict=True):
        out = np.array([*(a + b)[:2], 0]) / np.linalg.norm((a + b)[:2])
        kit.between(a - (b - a) * 0.15, b + (b - a) * 0.15, (0.02, 0.3), BOX, material=paint)
        kit.between(a + out * 0.32 + [0, 0, 0.12] - (b - a) * 0.3, b + out * 0.32 + [0, 0, 0.12] + (b - a) * 0.3, (0.14, 0.02), BOX, material=paint)
    box(kit, (-0.75, -0.35, high), (0.35, 0.35, 0.03), metal)
    for x, y in ((-1.08, -0.03), (-1.08, -0.68), (-0.42, -0.68)):
        rod(kit, (x, y, 0), (x, y, high + 0.6), 0.035, metal)
    rod(kit, (-1.08, -0.68, high + 0.58), (-0.42, -0.68, high + 0.58), 0.025, metal)
    kit.between((-1.45, -0.35, 0), (-1.1, -0.35, high), (0.03, 0.25), BOX, material=metal, cut=(RUNGS, 4, 0.3))
    rod(kit, (-1.45, -0.6, 0), (-1.1, -0.6, high + 0.5), 0.025, metal)
    rod(kit, (-1.45, -0.1, 0), (-1.1, -0.1, high + 0.5), 0.025, metal)


def swings(kit):
    metal, n, high = bright(kit) if kit.chance(0.6) else timber(kit), int(kit.rng.integers(1, 4)), kit.rng.uniform(1.9, 2.3)
    half = 0.35 + 0.4 * n
    rod(kit, (0, -half, high), (0, half, high), 0.05, metal)
    for x in (-0.8, 0.8):
        rod(kit, (x, half + 0.15, 0), (0, half, high), 0.045, metal, True)
    rod(kit, (-0.4, half + 0.07, high / 2), (0.4, half + 0.07, high / 2), 0.03, metal, True)
    for k in range(n):
        y, sway, seat, chain = (k - (n - 1) / 2) * 0.8, kit.rng.uniform(-0.4, 0.4), bright(kit), iron(kit)
        low = 0.45 + sway * sway * 0.3
        for side in (-0.22, 0.22):
            rod(kit, (0, y + side, high), (sway, y + side, low), 0.01, chain)
        box(kit, (sway, y, low), (0.1, 0.24, 0.02), seat)
        if kit.chance(0.3):
            box(kit, (sway - 0.1, y, low + 0.15), (0.015, 0.22, 0.13), seat)
            box(kit, (sway + 0.1, y, low + 0.15), (0.015, 0.22, 0.04), seat)


def seesaw(kit):
    metal, tip = bright(kit), kit.rng.uniform(5, 14) * kit.rng.choice([-1, 1])
    spin, z = turn("y", tip), 0.45
    for x in (-0.3, 0.3):
        rod(kit, (x, 0.25, 0), (0, 0.12, z), 0.035, metal, True)
    rod(kit, (0, -0.2, z), (0, 0.2, z), 0.05, metal)
    kit.add(BOX, (0, 0, z + 0.04), (1.4, 0.09, 0.035), rotation=spin, material=planks(kit) if kit.chance(0.5) else bright(kit))
    seat, grip = bright(kit), iron(kit)
    for x in (-1.25, 1.25):
        kit.add(BOX, spin @ [x, 0, 0.1] + [0, 0, z], (0.17, 0.15, 0.03), rotation=spin, material=seat)
        a, b = spin @ [x * 0.76, 0, 0.05] + [0, 0, z], spin @ [x * 0.76, 0, 0.35] + [0, 0, z]
        rod(kit, a, b, 0.02, grip)
        rod(kit, b - [0, 0.17, 0], b + [0, 0.17, 0], 0.02, grip)
    kit.add(CYL, (np.sign(tip) * 1.3, 0, 0.05), (0.2, 0.2, 0.05), material=iron(kit))


def dome_frame(kit):
    metal, r, n = bright(kit) if kit.chance(0.7) else steel(kit), 1.2, int(kit.rng.choice([6, 7]))
    second = bright(kit) if kit.chance(0.5) else metal
    rings = [[np.array([x, y, z]) for x, y in around(n, r * s, t)] for z, s, t in ((0, 1, 0), (0.55, 0.87, 180 / n), (1.0, 0.5, 0))]
    top = np.array([0, 0, 1.2])
    for k in range(n):
        rod(kit, rings[1][k], rings[1][k - 1], 0.022, second)
        rod(kit, rings[2][k], rings[2][k - 1], 0.022, second)
        rod(kit, rings[0][k], rings[1][k], 0.022, metal)
        rod(kit, rings[0][k], rings[1][k - 1], 0.022, metal)
        rod(kit, rings[1][k], rings[2][k], 0.022, metal)
        rod(kit, rings[1][k - 1], rings[2][k], 0.022, metal)
        rod(kit, rings[2][k], top, 0.022, metal)
        kit.add(BALL, rings[1][k], (0.04,) * 3, material=second)
    kit.add(BALL, top, (0.05,) * 3, material=second)


def roundabout(kit):
    metal, deck, n = bright(kit) if kit.chance(0.6) else steel(kit), bright(kit), int(kit.rng.choice([4, 5, 6]))
    disc(kit, (0, 0, 0.06), 0.3, 0.06, iron(kit))
    disc(kit, (0, 0, 0.16), 1.1, 0.05, deck._replace(pattern=int(kit.rng.choice([PLAIN, SPECKLES, CHECKER])), frequency=6.0))
    kit.loft((0, 0, 0.15), [(0, 0.1), (0.7, 0.07), (0.74, 0.25), (0.78, 0.25)], metal)
    seat = bright(kit)
    for k, (x, y) in enumerate(around(n, 1.0)):
        bent(kit, [(x, y, 0.2), (x, y, 0.75), (x * 0.75, y * 0.75, 0.88), (0, 0, 0.88)], 0.025, metal)
        if k % 2 == 0 or n == 5:
            kit.add(BOX, (x * 0.62, y * 0.62, 0.48), (0.1, 0.2, 0.025), rotation=turn("z", 360 * k / n), material=seat)
            rod(kit, (x * 0.62, y * 0.62, 0.2), (x * 0.62, y * 0.62, 0.48), 0.03, metal)


def spring_rider(kit):
    body, second, dark = bright(kit), bright(kit), black(kit)
    disc(kit, (0, 0, 0.03), 0.22, 0.03, dark)
    coil = [np.array([0.12 * np.cos(a), 0.12 * np.sin(a), 0.05 + 0.33 * a / (2 * np.pi * 3)]) for a in np.linspace(0, 6 * np.pi, 25)]
    bent(kit, coil, 0.022, second)
    disc(kit, (0, 0, 0.4), 0.15, 0.02, dark)
    kind = kit.rng.integers(3)
    if kind == 0:
        kit.add(BALL, (0, 0, 0.56), (0.45, 0.13, 0.17), material=body)
        kit.chain([(0.3, 0, 0.6), (0.42, 0, 0.92)], [0.12, 0.09], body)
        kit.add(BALL, (0.5, 0, 0.9), (0.18, 0.09, 0.09), (1, 1), rotation=turn("y", 20), material=body)
        rod(kit, (-0.4, 0, 0.6), (-0.58, 0, 0.8), 0.04, second)
    elif kind == 1:
        box(kit, (0, 0, 0.53), (0.5, 0.15, 0.11), body)
        box(kit, (0.4, 0, 0.7), (0.08, 0.15, 0.1), glass(kit), taper=(0.4, 0.9))
        for x in (-0.3, 0.3):
            disc(kit, (x, 0.16, 0.44), 0.12, 0.03, dark, True, ALONG_Y)
    else:
        kit.add(BALL, (-0.03, 0, 0.58), (0.42, 0.2, 0.2), material=body)
        kit.add(BALL, (0.38, 0, 0.78), (0.16,) * 3, material=body)
        kit.add(CYL, (0.56, 0, 0.76), (0.06, 0.08, 0.07), (0.2, 1), rotation=ALONG_X, material=second)
        kit.add(BOX, (-0.48, 0, 0.68), (0.12, 0.1, 0.03), rotation=turn("y", 30), material=second)
    kit.add(BALL, (0.5, 0.1, 0.86) if kind != 1 else (0.5, 0.09, 0.56), (0.03,) * 3, material=dark, mirror=True)
    rod(kit, (0.22, -0.26, 0.78), (0.22, 0.26, 0.78), 0.022, dark)
    rod(kit, (0.22, 0, 0.55), (0.22, 0, 0.78), 0.025, dark)
    box(kit, (-0.15, 0, 0.73), (0.17, 0.13, 0.03), second)
    rod(kit, (-0.15, 0, 0.5), (-0.15, 0, 0.73), 0.1, body)


def sandpit(kit):
    wood, half, n = planks(kit) if kit.chance(0.6) else bright(kit), kit.rng.uniform(0.8, 1.2), int(kit.rng.choice([4, 6]))
    sand = near(kit, (0.6, 0.45, 0.25), pattern=SPECKLES, frequency=30, gloss=0)
    points = [np.array([x, y, 0.12]) for x, y in around(n, half * (1.3 if n == 4 else 1.1), 45 if n == 4 else 0)]
    kit.add(PRISM, (0, 0, 0.07), (half * (0.92 if n == 4 else 0.95),) * 2 + (0.07,), (1, n), rotation=turn("z", 0 if n == 4 else 30), material=sand)
    for k in range(n):
        rod(kit, points[k], points[k - 1], (0.12, 0.05), wood, kind=BOX)
        kit.add(CYL, points[k] + [0, 0, 0.12], (0.16, 0.16, 0.03), material=wood)
    kit.add(CYL, (0.1, -0.2, 0.22), (0.3, 0.3, 0.1), (0.1, 1), material=sand)
    disc(kit, (-0.3, 0.3, 0.24), 0.09, 0.11, bright(kit), taper=1.3)
    if kit.chance(0.5):
        canopy = bright(kit)
        for y in (-half * 0.9, half * 0.9):
            rod(kit, (0, y, 0), (0, y, 1.4), 0.04, wood)
        kit.add(BOX, (0, 0, 1.5), (half, half, 0.16), (0.9, 0.02), material=canopy)


def turret(kit, x, half, floor, high, wood, paint, roof):
    """A square tower on posts with railings and a roof."""
    posts(kit, half, half, 0, high, 0.05, wood, kind=BOX, x=x)
    box(kit, (x, 0, floor), (half + 0.04, half + 0.04, 0.04), wood)
    box(kit, (x, half, floor + 0.3), (half, 0.02, 0.24), paint, True, cut=(BARS, 6, 0.75))
    if roof == "gable":
        slope, long = turn("x", -42), half * 0.8
        kit.add(BOX, (x, half * 0.55, high + half * 0.4), (half * 1.2, long, 0.025), rotation=slope, material=paint, mirror=True)
        kit.add(BOX, (x, 0, high + half * 0.42), (half * 0.95, half * 0.95, half * 0.45), (1, 0.05), material=wood)
    elif roof == "pyramid":
        kit.add(BOX, (x, 0, high + half * 0.6), (half * 1.25, half * 1.25, half * 0.6), (0.03, 0.03), material=paint)
    else:
        kit.add(CYL, (x, 0, high), (half * 1.1, half * 1.1, half * 1.05), rotation=ALONG_X, material=paint)


def play_house(kit):
    """A wooden house on posts with ladder, slide or stairs, or on the ground with a porch."""
    rng = kit.rng
    wood, wall, roof, half, floor = planks(kit), planks(kit) if kit.chance(0.5) else bright(kit)._replace(pattern=PLANKS, frequency=8.0), bright(kit), rng.uniform(0.65, 0.85), rng.choice([0.15, 1.0, 1.4])
    posts(kit, half + 0.35, half - 0.04, 0, floor, 0.06, wood, kind=BOX, x=0.3)
    box(kit, (0.3, 0, floor), (half + 0.42, half, 0.05), wood)
    box(kit, (0, 0, floor + 0.6), (half, half * 0.96, 0.6), wall)
    gable(kit, 0.1, floor + 1.2, half + 0.3, half * 1.15, half * rng.uniform(0.6, 0.9), roof, wall)
    box(kit, (half, 0.2, floor + 0.47), (0.012, 0.2, 0.43), bright(kit))
    box(kit, (half, -half * 0.5, floor + 0.75), (0.015, 0.18, 0.18), pale(kit))
    box(kit, (half + 0.005, -half * 0.5, floor + 0.75), (0.015, 0.15, 0.15), lens(kit), cut=(GRID, 6, 0.8))
    box(kit, (0, half * 0.965, floor + 0.75), (0.22, 0.015, 0.2), lens(kit), True)
    edge = half + 0.68
    for y in (half - 0.04, -half + 0.04):
        rod(kit, (edge, y, floor), (edge, y, floor + 1.15 if kit.chance(0.5) else floor + 0.55), 0.04, wood, kind=BOX)
    box(kit, (edge, half * 0.6, floor + 0.3), (0.02, half * 0.4, 0.22), wood, cut=(BARS, 8, 0.5))
    box(kit, (half + 0.35, half - 0.04, floor + 0.3), (0.35, 0.02, 0.22), wood, True, cut=(BARS, 8, 0.5))
    if floor > 0.5:
        kit.between((edge + 0.4, -half * 0.3, 0), (edge, -half * 0.3, floor + 0.1), (0.03, 0.22), BOX, material=wood, cut=(RUNGS, 4.5, 0.35))
        for side in (-0.22, 0.22):
            rod(kit, (edge + 0.4, side - half * 0.3, 0), (edge - 0.05, side - half * 0.3, floor + 0.4), 0.03, wood, kind=BOX)
        if kit.chance(0.6):
            first = len(kit.primitives)
            chute(kit, (0, 0, floor), (floor * 1.3, 0, 0.15), 0.22, bright(kit))
            spin, at = turn("z", 90), np.array([half + 0.35, half, 0])
            kit.primitives[first:] = [p._replace(centre=spin @ p.centre + at, rotation=spin @ p.rotation) for p in kit.primitives[first:]]


def fort(kit):
    """Two towers with a bridge, a slide and a ladder, perhaps a swing."""
    rng = kit.rng
    wood, paint, half, floor = planks(kit) if kit.chance(0.6) else bright(kit), bright(kit), rng.uniform(0.45, 0.6), rng.uniform(0.9, 1.3)
    far, roof = rng.uniform(1.1, 1.6), rng.choice(["gable", "pyramid", "vault"])
    for x in (-far, far):
        turret(kit, x, half, floor, floor + rng.uniform(1.1, 1.4), wood, paint if kit.chance(0.7) else bright(kit), roof)
    inner = far - half
    sag = [np.array([x, 0, floor - 0.12 * (1 - (x / inner) ** 2)]) for x in np.linspace(-inner, inner, 5)]
    ribbon(kit, sag, (0.03, half * 0.8), wood)
    for y in (-half * 0.8, half * 0.8):
        rod(kit, (-inner, y, floor + 0.5), (inner, y, floor + 0.5), 0.025, wood)
        box(kit, (0, y, floor + 0.2), (inner, 0.012, 0.3), iron(kit), cut=(rng.choice([BARS, LATTICE]), 5, 0.2))
    chute(kit, (far + half, 0, floor), (far + half + floor * 1.2, 0, 0.18), 0.24, bright(kit))
    kit.between((-far - half - 0.45, 0, 0), (-far - half, 0, floor), (0.03, 0.26), BOX, material=wood, cut=(RUNGS, 4.5, 0.35))
    for y in (-0.26, 0.26):
        rod(kit, (-far - half - 0.45, y, 0), (-far - half, y, floor + 0.4), 0.03, wood)


def trampoline(kit):
    rng = kit.rng
    metal, r, n, z = steel(kit), 1.3, int(rng.choice([6, 8])), rng.uniform(0.6, 0.8)
    disc(kit, (0, 0, z), r * 0.88, 0.012, black(kit))
    bent(kit, [np.array([r * np.cos(a), r * np.sin(a), z]) for a in np.linspace(0, 2 * np.pi, 25)], 0.07, bright(kit))
    net = kit.chance(0.6)
    for x, y in around(n, r * 1.03):
        rod(kit, (x, y, 0), (x, y, z + (1.5 if net else 0)), 0.03, metal)
    if net:
        kit.add(TUBE, (0, 0, z + 0.75), (r, r, 0.74), material=black(kit), cut=(GRID, 9, 0.16))
        kit.add(TUBE, (0, 0, z + 1.48), (r, r, 0.03), material=metal)
    kit.between((r + 0.35, 0, 0), (r, 0, z), (0.02, 0.18), BOX, material=metal, cut=(RUNGS, 4, 0.3))


def goal(kit):
    metal, half, high, deep = pale(kit) if kit.chance(0.8) else bright(kit), kit.rng.uniform(1.0, 1.8), kit.rng.uniform(1.1, 1.5), kit.rng.uniform(0.6, 0.9)
    net = pale(kit)
    rod(kit, (0, half, 0), (0, half, high), 0.045, metal, True)
    rod(kit, (0, -half - 0.04, high), (0, half + 0.04, high), 0.045, metal)
    rod(kit, (0, half, high), (-deep, half, 0.03), 0.03, metal, True)
    rod(kit, (0, half, 0.03), (-deep, half, 0.03), 0.03, metal, True)
    rod(kit, (-deep, -half, 0.03), (-deep, half, 0.03), 0.03, metal)
    kit.between((0, 0, high), (-deep, 0, 0.03), (0.006, half), BOX, material=net, cut=(GRID, 7, 0.15))
    for k in range(5):
        x = -deep * (k + 0.5) / 5
        box(kit, (x, half, (high * (1 + x / deep)) / 2), (deep / 10, 0.006, high * (1 + x / deep) / 2), net, True, cut=(GRID, 7, 0.15))


def ping_pong(kit):
    top, metal = near(kit, (0.03, 0.15, 0.4), (0.03, 0.25, 0.12), (0.1, 0.1, 0.12)), iron(kit) if kit.chance(0.6) else stone(kit)
    box(kit, (0, 0, 0.76), (1.37, 0.76, 0.02), top)
    for y in (-0.74, 0, 0.74):
        box(kit, (0, y, 0.781), (1.37, 0.02 if y else 0.008, 0.003), pale(kit))
    for x in (-1.35, 1.35):
        box(kit, (x, 0, 0.781), (0.02, 0.76, 0.003), pale(kit))
    box(kit, (0, 0, 0.85), (0.008, 0.85, 0.08), pale(kit), cut=(GRID, 25, 0.4))
    box(kit, (0, 0, 0.93), (0.01, 0.85, 0.012), pale(kit))
    rod(kit, (0, 0.85, 0.72), (0, 0.85, 0.94), 0.015, metal, True)
    rod(kit, (0, 0.7, 0.74), (0, 0.86, 0.74), 0.015, metal, True)
    posts(kit, 1.0, 0.6, 0, 0.75, 0.035, metal, kind=BOX)
    rod(kit, (-1.0, 0.6, 0.2), (1.0, 0.6, 0.2), 0.025, metal, True, BOX)
    box(kit, (0, 0, 0.7), (1.3, 0.65, 0.03), metal)
    for x, y in ((0.9, 0.3), (-0.9, -0.2)):
        disc(kit, (x, y, 0.79), 0.08, 0.01, bright(kit))
        box(kit, (x + 0.12, y, 0.79), (0.05, 0.015, 0.01), timber(kit))


def picnic(kit):
    wood, hy = planks(kit), kit.rng.uniform(0.7, 1.0)
    for x in np.linspace(-0.31, 0.31, 5):
        box(kit, (x, 0, 0.74), (0.07, hy, 0.02), wood)
    for x in (-0.75, -0.59, 0.59, 0.75):
        box(kit, (x, 0, 0.44), (0.07, hy, 0.02), wood)
    for way in (-1, 1):
        rod(kit, (way * 0.6, hy * 0.75, 0), (way * 0.22, hy * 0.75, 0.73), (0.02, 0.05), wood, True, BOX)
    rod(kit, (-0.8, hy * 0.75, 0.39), (0.8, hy * 0.75, 0.39), (0.045, 0.02), wood, True, BOX)
    rod(kit, (-0.36, hy * 0.75, 0.69), (0.36, hy * 0.75, 0.69), (0.04, 0.02), wood, True, BOX)
    if kit.chance(0.4):
        shade(kit, 2.3, 1.2, 0.3)
    else:
        for _ in range(int(kit.rng.integers(0, 4))):
            ware(kit, (kit.rng.uniform(-0.2, 0.2), kit.rng.uniform(-0.5, 0.5) * hy, 0.76), kit.rng.uniform(0.1, 0.22))


def parasol(kit):
    """Alone or over a round table with chairs."""
    high, radius = kit.rng.uniform(2.0, 2.5), kit.rng.uniform(0.9, 1.4)
    shade(kit, high, radius, kit.rng.uniform(0.25, 0.5))
    kit.loft((0, 0, 0), [(0, 0.28), (0.06, 0.26), (0.09, 0.05), (0.3, 0.04)], stone(kit))
    if kit.chance(0.6):
        made, seats = enamel(kit) if kit.chance(0.5) else timber(kit), int(kit.rng.choice([2, 3, 4]))
        disc(kit, (0, 0, 0.72), 0.5, 0.02, made)
        for x, y in around(3, 0.35, 20):
            rod(kit, (x, y, 0), (x, y, 0.72), 0.022, made)
        for k, (x, y) in enumerate(around(seats, 0.85)):
            spin = turn("z", 360 * k / seats)
            kit.add(BOX, (x, y, 0.43), (0.19, 0.19, 0.02), rotation=spin, material=made)
            kit.add(BOX, np.array([x, y, 0.65]) + spin @ [0.2, 0, 0], (0.015, 0.19, 0.22), rotation=spin @ turn("y", 8), material=made, cut=(BARS, 10, 0.7))
            for a, b in ((0.16, 0.16), (0.16, -0.16), (-0.16, 0.16), (-0.16, -0.16)):
                at = np.array([x, y, 0]) + spin @ [a, b, 0]
                rod(kit, at, at + [0, 0, 0.43], 0.016, made)


def tent(kit):
    """Garden pavilions with open or closed sides and festival tents."""
    rng = kit.rng
    canvas, metal, hx, hy, high = pale(kit) if kit.chance(0.5) else bright(kit), steel(kit), rng.uniform(1.2, 1.6), rng.uniform(1.2, 1.8), rng.uniform(1.9, 2.2)
    if kit.chance(0.4):
        canvas = canvas._replace(pattern=STRIPES, frequency=6.0)
    posts(kit, hx - 0.05, hy - 0.05, 0, high, 0.035, metal)
    rise = rng.uniform(0.35, 0.6)
    if kit.chance(0.4):
        kit.add(BOX, (0, 0, high + 0.18), (hx, hy, 0.18), (0.5, 0.5), material=canvas)
        kit.add(BOX, (0, 0, high + 0.36 + rise / 2), (hx * 0.5, hy * 0.5, rise / 2), (0.05, 0.05), material=canvas)
    else:
        kit.add(BOX, (0, 0, high + rise / 2), (hx, hy, rise / 2), (0.03, 0.03 if kit.chance(0.5) else 0.5), material=canvas)
    for x in (-hx, hx):
        box(kit, (x, 0, high - 0.1), (0.012, hy, 0.12), canvas)
    box(kit, (0, hy, high - 0.1), (hx, 0.012, 0.12), canvas, True)
    if kit.chance(0.5):
        box(kit, (-hx, 0, high / 2), (0.012, hy, high / 2), canvas)
        if kit.chance(0.6):
            box(kit, (0, hy, high / 2), (hx, 0.012, high / 2), canvas, True)
            box(kit, (-0.1, hy + 0.005, high * 0.55), (hx * 0.5, 0.012, 0.35), glass(kit), True)
    if kit.chance(0.4):
        box(kit, (0.2, 0, 0.7), (0.35, hy * 0.6, 0.03), timber(kit))
        posts(kit, 0.3, hy * 0.55, 0, 0.7, 0.025, timber(kit), x=0.2)


def tiers(kit):
    """Fountains of bowls on each other in a basin."""
    rock, water, n, z = stone(kit), near(kit, (0.15, 0.35, 0.42), (0.5, 0.6, 0.65), pattern=CLOUDY, gloss=0.5), int(kit.rng.integers(1, 4)), 0.1
    sides = kit.rng.choice([0, 6, 8])
    kit.add(PRISM if sides else CYL, (0, 0, 0.2), (1.3, 1.3, 0.2), (1, sides or 1), material=rock)
    kit.add(PRISM if sides else CYL, (0, 0, 0.4), (1.4, 1.4, 0.04), (1, sides or 1), material=rock)
    kit.add(PRISM if sides else CYL, (0, 0, 0.42), (1.2, 1.2, 0.03), (1, sides or 1), material=water)
    z = 0.4
    for k in range(n):
        r, tall = 0.8 * 0.62**k, 0.6 * 0.8**k
        kit.loft((0, 0, z), [(0, r * 0.35), (0.08, r * 0.25), (tall * 0.5, r * 0.16), (tall * 0.75, r * 0.22), (tall * 0.85, r * 0.6), (tall, r), (tall + 0.04, r)], rock)
        disc(kit, (0, 0, z + tall + 0.035), r * 0.9, 0.012, water)
        z += tall + 0.03
    kit.loft((0, 0, z), [(0, 0.08), (0.1, 0.05), (0.16, 0.09), (0.26, 0.02)], rock)
    if kit.chance(0.6):
        jet = near(kit, (0.7, 0.78, 0.82))
        kit.loft((0, 0, z + 0.2), [(0, 0.02), (0.3, 0.035)], jet)
        for x, y in around(8, 0.8 * 0.62 ** (n - 1) * 0.8):
            bent(kit, [(0, 0, z + 0.48), (x * 0.4, y * 0.4, z + 0.5), (x * 0.85, y * 0.85, z + 0.25), (x, y, z)], 0.014, jet)


def well(kit):
    rock, wood, roof = stone(kit)._replace(pattern=BRICKS, frequency=7.0), timber(kit), near(kit, (0.35, 0.12, 0.06), (0.1, 0.12, 0.14), (0.3, 0.2, 0.1), pattern=SHINGLES, frequency=9)
    r, high = kit.rng.uniform(0.5, 0.65), kit.rng.uniform(1.7, 2.1)
    kit.add(TUBE, (0, 0, 0.38), (r, r, 0.38), material=rock)
    kit.add(TUBE, (0, 0, 0.38), (r * 0.78, r * 0.78, 0.38), material=rock)
    bent(kit, [np.array([r * 0.9 * np.cos(a), r * 0.9 * np.sin(a), 0.76]) for a in np.linspace(0, 2 * np.pi, 15)], 0.08, rock)
    disc(kit, (0, 0, 0.5), r * 0.8, 0.02, black(kit))
    rod(kit, (0, r * 0.9, 0), (0, r * 0.9, high), 0.055, wood, True, BOX)
    rod(kit, (0, -r * 1.1, 1.2), (0, r * 1.1, 1.2), 0.07, wood)
    bent(kit, [(0, r * 1.1, 1.2), (0, r * 1.25, 1.2), (0.15, r * 1.25, 1.05), (0.15, r * 1.45, 1.05)], 0.018, iron(kit))
    rod(kit, (0.07, 0, 1.2), (0.07, 0, 0.95), 0.012, pale(kit))
    disc(kit, (0.07, 0, 0.85), 0.1, 0.12, planks(kit), taper=1.2)
    first = len(kit.primitives)
    gable(kit, 0, high - 0.1, r * 1.4, 0.65, 0.5, roof, wood)
    spin = turn("z", 90)
    kit.primitives[first:] = [p._replace(centre=spin @ p.centre, rotation=spin @ p.rotation) for p in kit.primitives[first:]]


def arbour(kit):
    wood, leaves = timber(kit) if kit.chance(0.5) else pale(kit) if kit.chance(0.6) else iron(kit), near(kit, (0.06, 0.2, 0.04), (0.1, 0.25, 0.06), pattern=CLOUDY, frequency=20)
    posts(kit, 0.28, 0.7, 0, 1.8, 0.035, wood, kind=BOX)
    box(kit, (0, 0.7, 0.9), (0.28, 0.012, 0.88), wood, True, cut=(LATTICE, 6, 0.3))
    for x in (-0.28, 0.28):
        ribbon(kit, arc((x, 0, 1.8), (0.7, kit.rng.uniform(0.45, 0.6)), 0, 180, 9, "yz"), (0.035, 0.03), wood)
    for a in np.radians([20, 50, 90, 130, 160]):
        rod(kit, (-0.36, 0.7 * np.cos(a), 1.8 + 0.55 * np.sin(a)), (0.36, 0.7 * np.cos(a), 1.8 + 0.55 * np.sin(a)), 0.02, wood, kind=BOX)
    if kit.chance(0.6):
        for y, z, r in ((0.72, 0.6, 0.2), (0.72, 1.3, 0.24), (0.55, 2.15, 0.28), (0.1, 2.4, 0.28), (-0.7, 0.4, 0.2)):
            kit.add(BALL, (0, y, z), (r * 1.3, r, r * 1.4), material=leaves, cut=(LEAVES, 12, 0.6))
    if kit.chance(0.5):
        box(kit, (0, 0, 0.42), (0.2, 0.68, 0.02), wood)
        box(kit, (-0.25, 0, 0.75), (0.015, 0.68, 0.2), wood, cut=(BARS, 8, 0.6))


def pergola(kit):
    wood, hx, hy, high = planks(kit) if kit.chance(0.6) else pale(kit), kit.rng.uniform(1.0, 1.5), kit.rng.uniform(1.0, 1.8), 2.1
    for x in (-hx, hx):
        for y in np.linspace(-hy, hy, int(kit.rng.choice([2, 3]))):
            rod(kit, (x, y, 0), (x, y, high), 0.06, wood, kind=BOX)
        box(kit, (x, 0, high + 0.06), (0.04, hy + 0.3, 0.07), wood)
        rod(kit, (x, hy, high - 0.4), (x, hy - 0.4, high), 0.035, wood, True, BOX)
    for y in np.linspace(-hy - 0.15, hy + 0.15, int(kit.rng.integers(6, 11))):
        box(kit, (0, y, high + 0.18), (hx + 0.35, 0.03, 0.06), wood)
    if kit.chance(0.5):
        for _ in range(6):
            kit.add(BALL, (kit.rng.uniform(-1, 1) * hx, kit.rng.uniform(-1, 1) * hy, high + 0.22), (0.4, 0.45, 0.18), material=near(kit, (0.06, 0.2, 0.04)), cut=(LEAVES, 10, 0.55))


def gazebo(kit):
    rng = kit.rng
    wood, roof, n, r = pale(kit) if kit.chance(0.5) else timber(kit), near(kit, (0.3, 0.1, 0.05), (0.1, 0.2, 0.16), (0.12, 0.13, 0.15), pattern=SHINGLES, frequency=9), int(rng.choice([6, 8])), 1.3
    kit.add(PRISM, (0, 0, 0.12), (r * 1.05, r * 1.05, 0.12), (1, n), material=stone(kit) if kit.chance(0.5) else wood)
    ring = [np.array([x, y, 0]) for x, y in around(n, r * 1.05, 180 / n)]
    for k in range(n):
        rod(kit, ring[k] + [0, 0, 0.2], ring[k] + [0, 0, 2.2], 0.055, wood, kind=BOX)
        rod(kit, ring[k] + [0, 0, 2.15], ring[k - 1] + [0, 0, 2.15], 0.06, wood, kind=BOX)
        if k != 0:
            kit.railing(ring[k] + [0, 0, 0.3], ring[k - 1] + [0, 0, 0.3], 0.55, wood, 0.12)
            rod(kit, ring[k] + [0, 0, 0.85], ring[k - 1] + [0, 0, 0.85], 0.035, wood, kind=BOX)
    kit.add(PRISM, (0, 0, 2.2 + 0.35), (r * 1.25, r * 1.25, 0.35), (0.25 if kit.chance(0.4) else 0.02, n), material=roof)
    kit.add(PRISM, (0, 0, 3.0), (r * 0.33, r * 0.33, 0.2), (0.05, n), material=roof)
    kit.add(CYL, (0, 0, 2.85), (0.05, 0.05, 0.45), material=wood)
    kit.add(BALL, (0, 0, 3.3), (0.08,) * 3, material=brass(kit))
    kit.add(BOX, (r + 0.15, 0, 0.06), (0.25, 0.4, 0.06), material=stone(kit))


def shed(kit):
    wood, hx, hy, high = planks(kit) if kit.chance(0.7) else enamel(kit)._replace(pattern=RIBS, frequency=10.0), kit.rng.uniform(0.8, 1.4), kit.rng.uniform(0.7, 1.0), 1.8
    box(kit, (0, 0, 0.05), (hx + 0.05, hy + 0.05, 0.05), stone(kit))
    box(kit, (0, 0, high / 2), (hx, hy, high / 2), wood)
    gable(kit, 0, high, hx + 0.15, hy + 0.15, hy * kit.rng.uniform(0.4, 0.8), near(kit, (0.1, 0.11, 0.12), (0.3, 0.1, 0.05), (0.1, 0.2, 0.1), pattern=SHINGLES), wood)
    box(kit, (hx, 0.1, 0.85), (0.02, 0.38, 0.8), planks(kit))
    for z in (0.35, 1.35):
        box(kit, (hx + 0.022, 0.2, z), (0.006, 0.24, 0.03), iron(kit))
    kit.add(BALL, (hx + 0.03, -0.18, 0.85), (0.03,) * 3, material=iron(kit))
    box(kit, (0, hy, 1.2), (0.3, 0.02, 0.25), pale(kit), True)
    box(kit, (0, hy + 0.01, 1.2), (0.26, 0.02, 0.21), lens(kit), True, cut=(GRID, 4, 0.85))
    if kit.chance(0.5):
        rod(kit, (hx + 0.35, -hy * 0.7, 0), (hx, -hy * 0.75, 1.3), 0.018, timber(kit))
        disc(kit, (hx + 0.25, hy * 0.8, 0.12), 0.14, 0.12, near(kit, (0.4, 0.15, 0.07)), taper=1.25)


def greenhouse(kit):
    metal, hx, hy, high = pale(kit) if kit.chance(0.5) else near(kit, (0.03, 0.12, 0.07), (0.4, 0.42, 0.43)), kit.rng.uniform(0.9, 1.5), 0.8, 1.3
    pane = near(kit, (0.45, 0.55, 0.55), (0.3, 0.42, 0.4), pattern=CLOUDY, gloss=0.6)
    box(kit, (0, 0, 0.12), (hx, hy, 0.12), stone(kit))
    box(kit, (0, 0, high / 2 + 0.1), (hx - 0.02, hy - 0.02, high / 2 - 0.1), pane)
    kit.add(BOX, (0, 0, high + 0.3), (hx - 0.02, hy - 0.02, 0.3), (1, 0.02), material=pane)
    n = int(kit.rng.integers(4, 7))
    for x in np.linspace(-hx, hx, n):
        rod(kit, (x, hy, 0.1), (x, hy, high), 0.02, metal, True, BOX)
        rod(kit, (x, hy, high), (x, 0, high + 0.6), 0.02, metal, True, BOX)
    rod(kit, (-hx, hy, high), (hx, hy, high), 0.025, metal, True, BOX)
    rod(kit, (-hx, 0, high + 0.6), (hx, 0, high + 0.6), 0.03, metal, kind=BOX)
    for x in (-hx, hx):
        for y in (-0.3, 0.3):
            rod(kit, (x, y, 0.1), (x, y, high + 0.37), 0.018, metal, kind=BOX)
        rod(kit, (x, -hy, high), (x, hy, high), 0.02, metal, kind=BOX)
    for _ in range(4):
        kit.add(BALL, (kit.rng.uniform(-0.8, 0.8) * hx, kit.rng.choice([-1, 1]) * (hy - 0.08), 0.45), (0.2, 0.09, 0.25), material=near(kit, (0.05, 0.2, 0.04)))


def barbecue(kit):
    iron_, wood = enamel(kit) if kit.chance(0.5) else black(kit), timber(kit)
    if kit.chance(0.5):
        for x, y in around(3, 0.32, 30):
            rod(kit, (x, y, 0), (x * 0.5, y * 0.5, 0.65), 0.016, steel(kit))
        kit.loft((0, 0, 0.52), [(0, 0.12), (0.08, 0.25), (0.18, 0.32), (0.25, 0.33)], iron_)
        disc(kit, (0, 0, 0.775), 0.31, 0.006, steel(kit)._replace(pattern=STRIPES, frequency=40.0))
        if kit.chance(0.5):
            dome(kit, (0, 0, 0.78), 0.33, 0.22, iron_, steps=6)
            rod(kit, (0, -0.07, 1.03), (0, 0.07, 1.03), 0.016, wood)
            rod(kit, (0, 0, 0.98), (0, 0, 1.03), 0.02, iron_)
        else:
            for _ in range(5):
                kit.add(BALL, (kit.rng.uniform(-0.18, 0.18), kit.rng.uniform(-0.18, 0.18), 0.79), (0.07, 0.035, 0.025), material=near(kit, (0.3, 0.1, 0.04)))
    else:
        posts(kit, 0.22, 0.5, 0, 0.8, 0.022, iron_, kind=BOX)
        box(kit, (0, 0, 0.45), (0.24, 0.5, 0.33), iron_)
        box(kit, (0, 0, 0.82), (0.26, 0.4, 0.08), steel(kit))
        kit.add(CYL, (-0.02, 0, 0.9), (0.24, 0.26, 0.39), rotation=ALONG_Y, material=iron_)
        rod(kit, (0.27, -0.25, 0.98), (0.27, 0.25, 0.98), 0.016, steel(kit))
        box(kit, (0, 0.58, 0.86), (0.22, 0.17, 0.015), wood, True)
        for y in (-0.25, 0, 0.25):
            disc(kit, (0.265, y, 0.82), 0.03, 0.015, black(kit), rotation=ALONG_X)
        fronts(kit, 0.24, 0.47, 0.15, 0.72, 1, 2, iron_, steel(kit))


def mower(kit):
    paint, tyre = bright(kit), black(kit)
    box(kit, (0, 0, 0.2), (0.4, 0.26, 0.08), paint, taper=(0.85, 0.85))
    kit.add(CYL, (0, 0, 0.34), (0.2, 0.18, 0.09), (0.8, 1), material=tyre if kit.chance(0.5) else paint)
    disc(kit, (0.0, 0, 0.45), 0.1, 0.03, tyre)
    disc(kit, (0.3, 0.28, 0.11), 0.11, 0.035, tyre, True, ALONG_Y)
    disc(kit, (-0.32, 0.28, 0.13), 0.13, 0.035, tyre, True, ALONG_Y)
    disc(kit, (0.3, 0.31, 0.11), 0.05, 0.015, pale(kit), True, ALONG_Y)
    disc(kit, (-0.32, 0.31, 0.13), 0.06, 0.015, pale(kit), True, ALONG_Y)
    bent(kit, [(-0.3, 0.2, 0.25), (-0.75, 0.2, 0.7), (-1.05, 0.18, 0.95)], 0.016, steel(kit), True)
    rod(kit, (-1.05, -0.2, 0.95), (-1.05, 0.2, 0.95), 0.022, tyre)
    if kit.chance(0.7):
        kit.add(BOX, (-0.62, 0, 0.3), (0.27, 0.2, 0.16), (0.8, 0.9), (0.1, 0), material=cloth(kit) if kit.chance(0.5) else tyre)


def can(kit):
    metal, r, high = enamel(kit) if kit.chance(0.6) else steel(kit), kit.rng.uniform(0.16, 0.22), kit.rng.uniform(0.3, 0.42)
    kit.loft((0, 0, 0), [(0, r), (high, r * 0.85), (high + 0.03, r * 0.6)], metal)
    disc(kit, (0, 0, high * 0.7), r * 0.93, 0.012, metal)
    bent(kit, [(r * 0.8, 0, 0.08), (r * 0.8 + 0.35, 0, high + 0.12)], 0.028, metal)
    kit.between((r * 0.8 + 0.33, 0, high + 0.1), (r * 0.8 + 0.42, 0, high + 0.2), 0.035, CYL, 2.2, material=brass(kit) if kit.chance(0.4) else metal)
    rod(kit, (r * 0.7, 0, high * 0.85), (r * 0.8 + 0.2, 0, high * 0.6), 0.01, metal)
    bent(kit, arc((-r * 0.4, 0, high * 0.72), (r * 1.5, high * 0.65), 30, 240, 8), 0.018, metal)


def wheelie(kit):
    n = int(kit.rng.integers(1, 4))
    for k in range(n):
        paint, y, dark = near(kit, (0.04, 0.15, 0.06), (0.03, 0.08, 0.3), (0.5, 0.33, 0.02), (0.06, 0.06, 0.065), (0.25, 0.12, 0.05)), (k - (n - 1) / 2) * 0.68, black(kit)
        kit.add(BOX, (0, y, 0.52), (0.24, 0.22, 0.45), (1.25, 1.22), (-0.03, 0), material=paint)
        kit.add(BOX, (-0.04, y, 1.0), (0.33, 0.29, 0.05), (0.9, 0.8), material=paint if kit.chance(0.6) else bright(kit))
        rod(kit, (-0.38, y - 0.24, 0.98), (-0.38, y + 0.24, 0.98), 0.02, dark)
        rod(kit, (-0.28, y - 0.24, 0.1), (-0.28, y + 0.24, 0.1), 0.02, dark)
        for side in (-0.26, 0.26):
            disc(kit, (-0.26, y + side, 0.11), 0.11, 0.03, dark, rotation=ALONG_Y)
        box(kit, (0.05, y, 0.05), (0.18, 0.2, 0.05), paint)
        box(kit, (0.255, y, 0.65), (0.012, 0.1, 0.08), pale(kit)._replace(pattern=WRITING, frequency=14.0), rotation=turn("y", 3))


def gate(kit):
    """Fences of pickets, boards or iron with a gate."""
    rng = kit.rng
    made, kind, high, half = timber(kit) if kit.chance(0.5) else pale(kit), rng.choice(["pickets", "iron", "rails"]), rng.uniform(0.8, 1.4), rng.uniform(1.2, 1.6)
    if kind == "iron":
        made = iron(kit)
    pillars = stone(kit) if kit.chance(0.4) else made
    wide = 0.14 if pillars is not made else 0.06
    for y in (0.45, half):
        box(kit, (0, y, high * 0.55), (wide, wide, high * 0.55), pillars, True)
        kit.add(BOX, (0, y, high * 1.1 + 0.05), (wide * 1.2, wide * 1.2, 0.06), (0.2, 0.2), material=pillars, mirror=True)
    for y0, y1, x in ((0.45, half, 0), (-half, -0.45, 0), (-0.42, 0.42, 0.03)):
        for z in (0.25, 0.8) if kind != "rails" else (0.25, 0.55, 0.85):
            rod(kit, (x, y0, high * z), (x, y1, high * z), (0.035, 0.02) if kind != "iron" else 0.016, made, kind=BOX)
        if kind != "rails":
            for y in np.linspace(y0, y1, 8)[1:-1]:
                tall = high * (0.5 + (0.08 * np.cos(y / 0.42 * 1.5) if x else 0))
                box(kit, (x + 0.02, y, tall), (0.012, 0.035 if kind == "pickets" else 0.014, tall - 0.04), made)
    if kind == "rails":
        rod(kit, (0.03, -0.4, high * 0.25), (0.03, 0.4, high * 0.85), 0.025, made, kind=BOX)
        for y in (-0.4, 0.4):
            rod(kit, (0.03, y, high * 0.15), (0.03, y, high * 0.95), 0.025, made, kind=BOX)
