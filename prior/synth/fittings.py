"""What the makers of furniture, playgrounds and workshops share: boxes, discs, rods, posts, hoops, wares."""

import numpy as np

from .belongings import black, brass, cloth, enamel, pale, steel, timber
from .kit import ALONG_X, around, turn
from .layout import BALL, BOX, CYL, LATTICE, PRISM, TUBE
from .materials import BRICKS, CLOUDY, PLAIN, PLANKS, SPECKLES
from .toys import bright


def box(kit, at, half, material, mirror=False, taper=(1, 1), **rest):
    kit.add(BOX, at, half, taper, material=material, mirror=mirror, **rest)


def disc(kit, at, radius, half, material, mirror=False, rotation=None, taper=1, kind=CYL, **rest):
    kit.add(kind, at, (radius, radius, half), (taper, 1), rotation=rotation, material=material, mirror=mirror, **rest)


def rod(kit, start, end, radius, material, mirror=False, kind=CYL):
    kit.between(start, end, radius, kind, material=material, mirror=mirror)


def bent(kit, points, radius, material, mirror=False):
    """A tube through the points."""
    for start, end in zip(points[:-1], points[1:], strict=True):
        along = (np.array(end) - start) / np.linalg.norm(np.array(end) - start) * radius * 0.4
        kit.between(start - along, end + along, radius, material=material, mirror=mirror)


def posts(kit, half_x, half_y, low, high, radius, material, splay=1.0, kind=CYL, x=0.0):
    """Four legs, `splay` times as far apart at their feet."""
    for way in (-1, 1):
        kit.between((x + way * half_x * splay, half_y * splay, low), (x + way * half_x, half_y, high), radius, kind, material=material, mirror=True)


def near(kit, *bases, pattern=PLAIN, **rest):
    """A material near one of the colours."""
    base = np.array(bases[kit.rng.integers(len(bases))]) * kit.rng.uniform(0.7, 1.25)
    return kit.material(base=base, pattern=pattern, **{"second": np.clip(base * kit.rng.uniform(0.4, 0.8), 0.01, 0.95), **rest})


def iron(kit):
    return near(kit, (0.05, 0.05, 0.055), (0.12, 0.12, 0.13), (0.2, 0.2, 0.2), gloss=kit.rng.uniform(0.05, 0.3))


def planks(kit):
    return near(kit, (0.4, 0.26, 0.12), (0.25, 0.14, 0.07), (0.5, 0.4, 0.28), (0.3, 0.28, 0.25), pattern=PLANKS, frequency=kit.rng.uniform(6, 14))


def stone(kit):
    return near(kit, (0.45, 0.42, 0.37), (0.55, 0.46, 0.33), (0.6, 0.58, 0.55), pattern=kit.rng.choice([PLAIN, BRICKS, CLOUDY, SPECKLES]), frequency=10, gloss=0.02)


def glass(kit):
    return near(kit, (0.1, 0.16, 0.2), (0.3, 0.4, 0.42), (0.05, 0.07, 0.09), gloss=0.6)


def shining(kit):
    return kit.material(base=np.array([0.9, 0.8, 0.55]) * kit.rng.uniform(0.6, 1), pattern=PLAIN, gloss=-0.7)


def pick(kit, kinds):
    kinds[kit.rng.choice(len(kinds))](kit)


def ware(kit, at, high):
    """A pot, a pile of books, a box or a bottle on `at`."""
    kind = kit.rng.integers(3)
    if kind == 0:
        kit.loft(at, [(0, high * 0.3), (high * 0.5, high * 0.42), (high, high * 0.28)], enamel(kit))
    elif kind == 1:
        kit.add(BOX, np.array(at) + [0, 0, high * 0.4], (high * 0.45, high * 0.6, high * 0.4), material=enamel(kit))
    else:
        kit.loft(at, [(0, high * 0.22), (high * 0.6, high * 0.22), (high * 0.75, high * 0.08), (high * 1.2, high * 0.08)], glass(kit))


def fronts(kit, x, hy, low, high, rows, columns, material, knob):
    """Drawers or doors with knobs on the front plane `x`."""
    tall, wide = (high - low) / rows, 2 * hy / columns
    for r in range(rows):
        for c in range(columns):
            y, z = -hy + (c + 0.5) * wide, low + (r + 0.5) * tall
            box(kit, (x, y, z), (0.012, wide * 0.46, tall * 0.44), material)
            kit.add(BALL, (x + 0.02, y if tall < wide else y + (0.35 - 0.7 * (c % 2)) * wide * (1 if columns > 1 else -1), z), (0.018,) * 3, material=knob)


def mirror(kit):
    wood, oval, tip = timber(kit) if kit.chance(0.6) else brass(kit), kit.chance(0.5), turn("y", kit.rng.uniform(-10, 2))
    rod(kit, (0, 0.4, 0.04), (0, 0.4, 1.35), 0.022, wood, True)
    rod(kit, (-0.24, 0.4, 0.03), (0.24, 0.4, 0.03), 0.025, wood, True)
    rod(kit, (0, -0.4, 0.22), (0, 0.4, 0.22), 0.02, wood)
    rod(kit, (0, -0.4, 0.95), (0, 0.4, 0.95), 0.016, wood)
    kit.add(BALL, (0, 0.4, 1.37), (0.035,) * 3, material=wood, mirror=True)
    for wide, deep, at, made in ((0.36, 0.02, 0, wood), (0.32, 0.018, 0.008, glass(kit))):
        if oval:
            kit.add(CYL, tip @ [at, 0, 0] + [0, 0, 0.95], (wide * 1.9, wide, deep), rotation=tip @ ALONG_X, material=made)
        else:
            kit.add(BOX, tip @ [at, 0, 0] + [0, 0, 0.95], (deep, wide, wide * 1.9), rotation=tip, material=made)


def gable(kit, x, z, half_x, half_y, rise, material, wall):
    """A roof with its ridge along x over gable walls."""
    kit.add(BOX, (x, 0, z + rise / 2), (half_x * 0.9, half_y * 0.9, rise / 2), (1, 0.02), material=wall)
    slope = np.degrees(np.arctan2(rise, half_y))
    long = np.hypot(rise, half_y) / 2 + 0.04
    kit.add(BOX, (x, half_y / 2 + 0.01, z + rise / 2 + 0.02), (half_x, long, 0.03), rotation=turn("x", -slope), material=material, mirror=True)


def hoop(kit):
    metal, base, high = steel(kit) if kit.chance(0.5) else black(kit), enamel(kit), kit.rng.uniform(2.0, 2.8)
    box(kit, (-0.6, 0, 0.12), (0.4, 0.35, 0.12), base, taper=(0.75, 0.8))
    rod(kit, (-0.6, 0, 0.2), (-0.6, 0, high), 0.05, metal)
    for z in (high - 0.5, high - 0.05):
        rod(kit, (-0.6, 0, z), (0, 0, z + 0.15), 0.025, metal)
    box(kit, (0, 0, high), (0.02, 0.65, 0.42), pale(kit) if kit.chance(0.7) else bright(kit))
    red = near(kit, (0.6, 0.08, 0.03))
    for half, z in ((0.25, high - 0.08), (0.64, high)):
        for side in (-1, 1):
            box(kit, (0.02, 0, z + side * half * 0.62), (0.006, half, 0.02), red)
            box(kit, (0.02, side * half, z), (0.006, 0.02, half * 0.62), red)
    rim = [np.array([0.28 + 0.23 * np.cos(a), 0.23 * np.sin(a), high - 0.26]) for a in np.linspace(0, 2 * np.pi, 13)]
    bent(kit, rim, 0.016, red)
    box(kit, (0.04, 0, high - 0.26), (0.04, 0.06, 0.03), red)
    kit.add(TUBE, (0.28, 0, high - 0.46), (0.14, 0.14, 0.2), (1.6, 1), material=pale(kit), cut=(LATTICE, 12, 0.2))


def shade(kit, high, radius, rise):
    """A sun umbrella in segments of one or two colours, with a pole."""
    n, first = int(kit.rng.choice([6, 8])), bright(kit) if kit.chance(0.6) else cloth(kit)
    rod(kit, (0, 0, 0), (0, 0, high), 0.025, timber(kit) if kit.chance(0.5) else steel(kit))
    kit.add(PRISM, (0, 0, high - rise / 2), (radius, radius, rise / 2), (0.03, n), material=first)
    kit.add(BALL, (0, 0, high + 0.02), (0.035,) * 3, material=timber(kit))
    if kit.chance(0.6):
        low = high - rise - 0.08
        corners = [np.array([x, y, low]) for x, y in around(n, radius / np.cos(np.pi / n) * 0.98, 180 / n)]
        second = pale(kit) if kit.chance(0.5) else first
        for k in range(n):
            rod(kit, corners[k], corners[k - 1], (0.09, 0.006), second, kind=BOX)
