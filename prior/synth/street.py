"""What stands in streets and markets: boxes, lamps, signs, stops, bins, hydrants, machines, racks, stalls."""

import numpy as np

from .belongings import black, cloth, enamel, lens, pale, steel, timber
from .fittings import bent, box, disc, glass, iron, near, planks, posts, rod, shining, stone
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, PRISM, SPOKES, TUBE
from .materials import PLAIN, SPECKLES, STRIPES, WRITING
from .toys import bright


def stall(kit):
    rng = kit.rng
    wood, hy, high = planks(kit), rng.uniform(0.8, 1.2), rng.uniform(1.8, 2.1)
    awning = near(kit, (0.6, 0.05, 0.04), (0.05, 0.3, 0.12), (0.05, 0.12, 0.45), (0.7, 0.4, 0.05), pattern=STRIPES, frequency=rng.uniform(5, 10), second=[0.85, 0.83, 0.78])
    rod(kit, (0.45, hy, 0), (0.45, hy, high), 0.035, wood, True, BOX)
    rod(kit, (-0.45, hy, 0), (-0.45, hy, high + 0.25), 0.035, wood, True, BOX)
    kit.between((-0.55, 0, high + 0.3), (0.85, 0, high - 0.12), (0.02, hy + 0.12), BOX, material=awning)
    box(kit, (0.85, 0, high - 0.2), (0.012, hy + 0.12, 0.09), awning)
    box(kit, (0.1, 0, 0.45), (0.38, hy - 0.03, 0.42), wood if kit.chance(0.5) else cloth(kit))
    for k, x in enumerate((0.32, -0.05)):
        for y in np.linspace(-1, 1, 4) * (hy - 0.25):
            load = bright(kit)
            z = 0.92 + 0.1 * k
            kit.add(BOX, (x, y, z), (0.17, 0.2, 0.09 + 0.06 * k), material=timber(kit))
            if kit.chance(0.5):
                kit.add(BALL, (x, y, z + 0.08 + 0.06 * k), (0.15, 0.18, 0.08), material=load._replace(pattern=SPECKLES, frequency=20.0, second=load.first * 0.5))
            else:
                for a, b in ((0.07, 0.08), (-0.07, 0.08), (0, -0.08)):
                    kit.add(BALL, (x + a, y + b, z + 0.11 + 0.06 * k), (0.075,) * 3, material=load)
    box(kit, (0.87, 0, high + 0.02), (0.015, hy * 0.6, 0.13), bright(kit)._replace(pattern=WRITING, frequency=8.0))
    if kit.chance(0.5):
        box(kit, (-0.47, 0, high * 0.5), (0.015, hy, high * 0.5), wood)


def phone_box(kit):
    red, half = near(kit, (0.5, 0.02, 0.02), (0.5, 0.02, 0.02), (0.03, 0.1, 0.35), (0.6, 0.4, 0.05), gloss=0.3), 0.44
    box(kit, (0, 0, 0.08), (half + 0.03, half + 0.03, 0.08), black(kit))
    box(kit, (0, 0, 1.1), (half - 0.05, half - 0.05, 1.0), glass(kit))
    posts(kit, half - 0.05, half - 0.05, 0.1, 2.2, 0.06, red, kind=BOX)
    for x, y, hx, hy in ((half - 0.03, 0, 0.02, half - 0.05), (-half + 0.03, 0, 0.02, half - 0.05), (0, half - 0.03, half - 0.05, 0.02), (0, -half + 0.03, half - 0.05, 0.02)):
        box(kit, (x, y, 1.15), (hx, hy, 0.95), red, cut=(GRID, 5, 0.25))
        box(kit, (x, y, 0.3), (hx, hy, 0.15), red)
    box(kit, (0, 0, 2.24), (half + 0.02, half + 0.02, 0.14), red)
    for side in (0, 90, 180, 270):
        kit.add(BOX, turn("z", side) @ [half + 0.02, 0, 2.25], (0.01, half * 0.75, 0.07), rotation=turn("z", side), material=pale(kit)._replace(pattern=WRITING, frequency=12.0))
    kit.loft((0, 0, 2.38), [(0, half), (0.1, half * 0.85), (0.17, half * 0.45), (0.19, 0.05)], red, BOX)


def post_box(kit):
    red, kind = near(kit, (0.5, 0.02, 0.02), (0.7, 0.45, 0.02), (0.03, 0.1, 0.35), gloss=0.3), kit.rng.integers(3)
    if kind == 0:
        kit.loft((0, 0, 0), [(0, 0.27), (0.15, 0.27)], black(kit))
        kit.loft((0, 0, 0.15), [(0, 0.25), (1.15, 0.25), (1.16, 0.3), (1.24, 0.3), (1.34, 0.2), (1.38, 0.03)], red)
        box(kit, (0.24, 0, 1.15), (0.03, 0.13, 0.025), black(kit))
        box(kit, (0.24, 0, 0.9), (0.025, 0.07, 0.1), pale(kit)._replace(pattern=WRITING, frequency=20.0))
        box(kit, (0.24, 0, 0.55), (0.02, 0.13, 0.22), red)
    elif kind == 1:
        posts(kit, 0.16, 0.2, 0, 0.4, 0.03, red, kind=BOX)
        box(kit, (0, 0, 0.75), (0.22, 0.27, 0.4), red)
        kit.add(CYL, (0, 0, 1.15), (0.27, 0.22, 0.27), rotation=ALONG_Y @ turn("z", 90), material=red)
        box(kit, (0.23, 0, 1.08), (0.02, 0.2, 0.05), black(kit))
        box(kit, (0.225, 0, 0.75), (0.008, 0.15, 0.12), pale(kit)._replace(pattern=WRITING, frequency=16.0))
    else:
        rod(kit, (0, 0, 0), (0, 0, 1.0), 0.05, timber(kit), kind=BOX)
        box(kit, (0, 0, 1.08), (0.28, 0.12, 0.1), red)
        kit.add(CYL, (0, 0, 1.18), (0.12, 0.12, 0.28), rotation=ALONG_X, material=red)
        box(kit, (0.05, 0.13, 1.28), (0.015, 0.01, 0.13), bright(kit))
        box(kit, (0.11, 0.13, 1.38), (0.06, 0.01, 0.03), bright(kit))
        box(kit, (0.285, 0, 1.1), (0.01, 0.1, 0.09), steel(kit))


def tap(kit):
    """Drinking fountains and hand pumps."""
    made = stone(kit) if kit.chance(0.4) else enamel(kit)
    kit.loft((0, 0, 0), [(0, 0.22), (0.1, 0.2), (0.14, 0.12), (0.7, 0.1), (0.78, 0.2), (0.9, 0.26), (0.94, 0.26)], made, CYL if kit.chance(0.6) else BOX)
    disc(kit, (0, 0, 0.945), 0.21, 0.006, near(kit, (0.2, 0.3, 0.33)))
    if kit.chance(0.5):
        bent(kit, [(-0.16, 0, 0.93), (-0.16, 0, 1.12), (-0.04, 0, 1.15), (0, 0, 1.08)], 0.02, steel(kit))
    else:
        bent(kit, [(-0.15, 0, 0.9), (-0.15, 0, 1.35), (-0.05, 0, 1.4), (0.02, 0, 1.3)], 0.04, made)
        rod(kit, (-0.15, 0, 1.35), (-0.5, 0, 1.05), 0.02, iron(kit))
    box(kit, (0.12, 0.05, 0.05), (0.25, 0.2, 0.04), stone(kit))


def street_lamp(kit):
    rng = kit.rng
    metal, high, kind = iron(kit) if kit.chance(0.6) else near(kit, (0.03, 0.12, 0.07), (0.3, 0.32, 0.33)), rng.uniform(2.6, 3.8), rng.choice(["lantern", "globes", "arm"])
    kit.loft((0, 0, 0), [(0, 0.2), (0.12, 0.18), (0.25, 0.1), (0.6, 0.08), (0.64, 0.1), (0.68, 0.06), (high, 0.04)], metal)
    if kind == "lantern":
        rod(kit, (0, -0.3, high - 0.35), (0, 0.3, high - 0.35), 0.02, metal)
        kit.add(PRISM, (0, 0, high + 0.2), (0.13, 0.13, 0.2), (1.5, 4 if kit.chance(0.5) else 6), material=shining(kit) if kit.chance(0.5) else glass(kit))
        kit.loft((0, 0, high + 0.4), [(0, 0.24), (0.14, 0.1), (0.2, 0.04), (0.28, 0.01)], metal)
        disc(kit, (0, 0, high), 0.13, 0.02, metal)
        for x, y in around(4, 0.16, 45):
            rod(kit, (x * 0.9, y * 0.9, high), (x * 1.3, y * 1.3, high + 0.4), 0.012, metal)
    elif kind == "globes":
        n, globe = int(rng.choice([1, 2, 3, 4])), shining(kit) if kit.chance(0.5) else pale(kit)
        for x, y in around(n, 0.45 if n > 1 else 0.001, 90):
            bent(kit, [(0, 0, high - 0.2), (x * 0.7, y * 0.7, high - 0.22), (x, y, high - 0.1), (x, y, high)], 0.025, metal)
            disc(kit, (x, y, high), 0.08, 0.03, metal, taper=1.3)
            kit.add(BALL, (x, y, high + 0.17), (0.17,) * 3, material=globe)
    else:
        for way in (1, -1) if kit.chance(0.4) else (1,):
            bent(kit, [(0, 0, high), (way * 0.1, 0, high + 0.25), (way * 0.4, 0, high + 0.4), (way * 0.8, 0, high + 0.42)], 0.035, metal)
            kit.add(BOX, (way * 0.95, 0, high + 0.42), (0.25, 0.1, 0.05), (0.8, 0.6), material=metal)
            box(kit, (way * 0.98, 0, high + 0.365), (0.18, 0.08, 0.012), shining(kit))


def signal(kit, x, y, z, dark):
    """A head of three lamps facing +x around the height `z`."""
    box(kit, (x, y, z), (0.1, 0.13, 0.38), dark)
    lit = kit.rng.integers(3)
    for k, base in enumerate(([0.8, 0.03, 0.02], [0.85, 0.45, 0.02], [0.03, 0.6, 0.15])):
        lamp_ = kit.material(base=np.array(base) * (1 if k == lit else 0.4), pattern=PLAIN, gloss=-0.7 if k == lit else 0.3)
        disc(kit, (x + 0.1, y, z + 0.24 - 0.24 * k), 0.085, 0.015, lamp_, rotation=ALONG_X)
        box(kit, (x + 0.16, y, z + 0.335 - 0.24 * k), (0.07, 0.09, 0.01), dark)


def traffic_light(kit):
    metal, dark, high = iron(kit), black(kit), kit.rng.uniform(2.0, 2.8)
    kit.loft((0, 0, 0), [(0, 0.14), (0.3, 0.12), (0.32, 0.06), (high, 0.055)], metal if kit.chance(0.6) else near(kit, (0.6, 0.4, 0.03)))
    if kit.chance(0.4):
        signal(kit, 0.1, 0, high - 0.5, dark)
        rod(kit, (0, 0, high), (0, 1.8, high + 0.35), 0.045, metal)
        signal(kit, 0.08, 1.6, high + 0.2, dark)
    else:
        signal(kit, 0.1 if kit.chance(0.5) else 0, 0, high + 0.2, dark)
        box(kit, (0.04, 0, high + 0.2), (0.01, 0.2, 0.5), dark)
    box(kit, (0.06, 0, 1.05), (0.05, 0.07, 0.11), near(kit, (0.7, 0.45, 0.03)))


def road_sign(kit):
    metal, high, red, white = steel(kit), kit.rng.uniform(1.8, 2.4), near(kit, (0.55, 0.02, 0.02)), pale(kit)
    rod(kit, (0, 0, 0), (0, 0, high + 0.3), 0.035, metal)
    disc(kit, (0, 0, 0.03), 0.16, 0.03, stone(kit))
    x, kind = 0.045, kit.rng.integers(5)
    if kind == 0:
        disc(kit, (x, 0, high), 0.34, 0.012, red, rotation=ALONG_X)
        disc(kit, (x + 0.012, 0, high), 0.26, 0.01, white, rotation=ALONG_X)
        box(kit, (x + 0.025, 0, high), (0.005, 0.14, 0.1), black(kit), cut=(BARS, 8, 0.5))
    elif kind == 1:
        kit.add(PRISM, (x, 0, high), (0.3, 0.3, 0.012), (1, 8), rotation=ALONG_X, material=red)
        box(kit, (x + 0.012, 0, high), (0.006, 0.22, 0.08), white._replace(pattern=WRITING, frequency=14.0))
    elif kind == 2:
        for size, depth, made in ((0.36, 0.012, red), (0.26, 0.02, white)):
            kit.add(BOX, (x, 0, high + 0.02), (depth, size, size * 0.87), (1, 0.02), material=made)
        rod(kit, (x + 0.022, 0, high - 0.12), (x + 0.022, 0, high + 0.05), 0.02, black(kit))
    elif kind == 3:
        for k in range(int(kit.rng.integers(1, 4))):
            way = kit.rng.choice([-1, 1])
            board = near(kit, (0.02, 0.25, 0.1), (0.02, 0.1, 0.4), (0.7, 0.68, 0.6), pattern=WRITING, frequency=9)
            box(kit, (x, way * 0.35, high - 0.25 * k), (0.012, 0.45, 0.1), board)
            kit.add(BOX, (x, way * 0.88, high - 0.25 * k), (0.012, 0.1, 0.08), (1, 0.05), rotation=turn("x", -90 * way), material=board)
    else:
        kit.add(BOX, (x, 0, high), (0.012, 0.32, 0.32), rotation=turn("x", 45), material=near(kit, (0.75, 0.5, 0.02)))
        kit.add(BOX, (x + 0.01, 0, high), (0.01, 0.18, 0.18), rotation=turn("x", 45), material=black(kit)._replace(pattern=PLAIN))
    if kit.chance(0.4):
        box(kit, (x, 0, high - 0.55), (0.012, 0.28, 0.13), white._replace(pattern=WRITING, frequency=12.0))


def bus_stop(kit):
    metal, hy, high = iron(kit) if kit.chance(0.5) else enamel(kit), kit.rng.uniform(1.1, 1.7), 2.2
    rod(kit, (-0.5, hy, 0), (-0.5, hy, high), 0.04, metal, True, BOX)
    rod(kit, (0.4, hy, 0), (0.4, hy, high), 0.04, metal, True, BOX)
    box(kit, (0, 0, high + 0.04), (0.75, hy + 0.15, 0.05), metal)
    box(kit, (-0.5, 0, 1.15), (0.012, hy, 0.9), glass(kit))
    box(kit, (-0.05, hy, 1.15), (0.42, 0.012, 0.9), kit.material(pattern=WRITING, frequency=5), True)
    box(kit, (-0.28, 0, 0.47), (0.18, hy * 0.7, 0.025), planks(kit))
    rod(kit, (-0.28, hy * 0.55, 0), (-0.28, hy * 0.55, 0.46), 0.03, metal, True)
    rod(kit, (0.9, hy + 0.4, 0), (0.9, hy + 0.4, 2.6), 0.03, metal)
    box(kit, (0.9, hy + 0.4, 2.45), (0.25, 0.015, 0.2), bright(kit))
    box(kit, (0.25, hy + 0.25, 0.06), (0.95, 0.4, 0.06), stone(kit))
    box(kit, (0.25, 0, 0.04), (0.95, hy + 0.2, 0.04), stone(kit))


def bollards(kit):
    made, n, chain = iron(kit) if kit.chance(0.5) else stone(kit), int(kit.rng.integers(1, 5)), iron(kit)
    gap, band = kit.rng.uniform(0.8, 1.2), pale(kit) if kit.chance(0.5) else bright(kit)
    for k in range(n):
        y = (k - (n - 1) / 2) * gap
        kit.loft((0, y, 0), [(0, 0.14), (0.1, 0.12), (0.14, 0.08), (0.75, 0.07), (0.78, 0.11), (0.84, 0.11), (0.92, 0.04)], made)
        disc(kit, (0, y, 0.62), 0.082, 0.05, band)
        if k:
            bent(kit, [np.array([0, y - gap * s, 0.7 - 0.9 * s * (1 - s)]) for s in np.linspace(0, 1, 5)], 0.018, chain)


def bin_(kit):
    """Litter bins with openings, a hood or a swinging pail between posts."""
    made, r, kind = enamel(kit) if kit.chance(0.6) else planks(kit), kit.rng.uniform(0.2, 0.28), kit.rng.integers(3)
    if kind == 0:
        kit.loft((0, 0, 0), [(0, r), (0.7, r)], made)
        disc(kit, (0, 0, 0.75), r * 0.8, 0.12, black(kit))
        for x, y in around(4, r * 0.85, 45):
            rod(kit, (x, y, 0.65), (x, y, 0.9), 0.02, made)
        kit.loft((0, 0, 0.86), [(0, r * 1.08), (0.04, r * 1.05), (0.16, r * 0.5), (0.19, 0.02)], made)
    elif kind == 1:
        box(kit, (0, 0, 0.5), (r, r, 0.48), made, taper=(1.1, 1.1))
        box(kit, (0, 0, 1.08), (r * 1.15, r * 1.15, 0.1), black(kit), taper=(0.8, 0.8))
        box(kit, (r * 1.1, 0, 0.85), (0.02, r * 0.7, 0.06), black(kit))
        box(kit, (r * 1.06, 0, 0.5), (0.02, 0.1, 0.1), pale(kit)._replace(pattern=WRITING, frequency=16.0))
    else:
        rod(kit, (0, r + 0.06, 0), (0, r + 0.06, 1.0), 0.025, iron(kit), True)
        disc(kit, (0, 0, 0.55), r * 0.85, 0.3, made, taper=1.18)
        disc(kit, (0, 0, 0.852), r * 0.9, 0.004, black(kit))
        rod(kit, (0, -r - 0.06, 0.75), (0, r + 0.06, 0.75), 0.015, iron(kit))
        rod(kit, (0, -r - 0.06, 1.0), (0, r + 0.06, 1.0), 0.02, iron(kit))


def hydrant(kit):
    paint, cap = near(kit, (0.5, 0.03, 0.02), (0.75, 0.45, 0.02), (0.05, 0.15, 0.4), gloss=0.3), steel(kit) if kit.chance(0.5) else pale(kit)
    kit.loft((0, 0, 0), [(0, 0.2), (0.05, 0.2), (0.051, 0.13), (0.5, 0.12), (0.51, 0.17), (0.55, 0.17), (0.63, 0.14), (0.7, 0.08), (0.72, 0.04), (0.78, 0.04)], paint)
    for y, r in ((0.15, 0.075), (0.19, 0.09)):
        disc(kit, (0, y, 0.4), r, 0.05 if r < 0.08 else 0.02, paint if r < 0.08 else cap, True, ALONG_Y)
    kit.add(PRISM, (0, 0.22, 0.4), (0.035, 0.035, 0.03), (1, 5), rotation=ALONG_Y, material=cap, mirror=True)
    disc(kit, (0.16, 0, 0.36), 0.1, 0.05, paint, rotation=ALONG_X)
    disc(kit, (0.21, 0, 0.36), 0.12, 0.02, cap, rotation=ALONG_X)
    kit.add(PRISM, (0.24, 0, 0.36), (0.04, 0.04, 0.03), (1, 5), rotation=ALONG_X, material=cap)
    for x, y in around(6, 0.17):
        disc(kit, (x, y, 0.07), 0.02, 0.03, iron(kit))


def vending(kit):
    """Vending and ticket machines."""
    paint = enamel(kit)
    if kit.chance(0.6):
        hy = kit.rng.uniform(0.4, 0.6)
        box(kit, (0, 0, 0.92), (0.38, hy, 0.9), paint)
        box(kit, (0.38, -0.12, 1.1), (0.012, hy - 0.2, 0.6), lens(kit))
        for k in range(5):
            box(kit, (0.395, -0.12, 0.6 + 0.24 * k), (0.008, hy - 0.22, 0.01), steel(kit))
            for y in np.linspace(-1, 1, 5) * (hy - 0.28):
                disc(kit, (0.392, y - 0.12, 0.68 + 0.24 * k), 0.035, 0.065, bright(kit))
        box(kit, (0.38, hy - 0.16, 1.1), (0.015, 0.1, 0.35), steel(kit)._replace(pattern=WRITING, frequency=12.0))
        box(kit, (0.38, -0.1, 0.3), (0.012, hy - 0.25, 0.1), black(kit))
        box(kit, (0.38, 0, 1.76), (0.015, hy - 0.05, 0.05), bright(kit)._replace(pattern=WRITING, frequency=8.0))
    else:
        box(kit, (0, 0, 0.35), (0.15, 0.18, 0.35), black(kit))
        box(kit, (0, 0, 1.1), (0.24, 0.32, 0.5), paint)
        box(kit, (0.02, 0, 1.68), (0.26, 0.34, 0.08), bright(kit)._replace(pattern=WRITING, frequency=10.0))
        kit.add(BOX, (0.24, 0.05, 1.35), (0.02, 0.2, 0.15), rotation=turn("y", -12), material=lens(kit))
        box(kit, (0.24, -0.22, 1.1), (0.015, 0.05, 0.1), black(kit))
        for y in (-0.05, 0.03, 0.11):
            box(kit, (0.24, y, 1.1), (0.02, 0.025, 0.025), steel(kit))
        box(kit, (0.24, 0.02, 0.8), (0.02, 0.15, 0.07), black(kit))


def rack(kit):
    """A stand with one or two bicycles."""
    metal, tyre = steel(kit), black(kit)
    for y in np.linspace(-0.6, 0.6, 4):
        bent(kit, [(0.5, y, 0), (0.5, y, 0.5), (0.75, y, 0.5), (0.75, y, 0)], 0.02, metal)
    for x in (0.5, 0.75):
        rod(kit, (x, -0.7, 0.02), (x, 0.7, 0.02), 0.025, metal)
    for y in (-0.45, 0.15)[: int(kit.rng.integers(1, 3))]:
        paint = bright(kit)
        y += 0.05
        for x in (-0.55, 0.5):
            kit.add(TUBE, (x, y, 0.34), (0.34, 0.34, 0.018), rotation=ALONG_Y, material=tyre)
            kit.add(TUBE, (x, y, 0.34), (0.31, 0.31, 0.018), rotation=ALONG_Y, material=tyre)
            kit.add(CYL, (x, y, 0.34), (0.335, 0.335, 0.012), rotation=ALONG_Y, material=metal, cut=(SPOKES, 14, 0.06))
        for a, b in (((-0.55, 0.34), (-0.1, 0.3)), ((-0.1, 0.3), (-0.22, 0.85)), ((-0.2, 0.75), (0.33, 0.78)), ((-0.1, 0.3), (0.35, 0.7)), ((-0.2, 0.75), (-0.55, 0.34)), ((0.5, 0.34), (0.31, 0.95))):
            rod(kit, (a[0], y, a[1]), (b[0], y, b[1]), 0.018, paint)
        rod(kit, (0.33, y - 0.24, 0.97), (0.33, y + 0.24, 0.97), 0.016, tyre)
        box(kit, (-0.24, y, 0.88), (0.13, 0.06, 0.025), tyre, taper=(0.9, 0.7))
        disc(kit, (-0.1, y - 0.04, 0.3), 0.08, 0.01, metal, rotation=ALONG_Y)
