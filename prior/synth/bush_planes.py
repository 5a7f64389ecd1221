"""Makers of aeroplanes of the bush: high-winged ones on wheels, floats or skis, crop dusters, flying boats."""

import numpy as np

from .airframes import airscrew, cockpit, hull, looks, on, surface, tilted, wheel
from .kit import ALONG_X, ALONG_Y
from .layout import BALL, BOX, CYL
from .seacraft import ports


def bush_plane(kit):
    """High-winged liaison and bush planes on a tail wheel or nose wheel, with struts; big tyres, floats or skis; flat engine or radial."""
    rng = kit.rng
    look = looks(kit, rng.choice(["gay", "gay", "gay", "drab"]))
    start, round_nose, on_tail = len(kit.primitives), kit.chance(0.35), kit.chance(0.6)
    fat = rng.uniform(0.48, 0.62)
    if round_nose:
        hull(kit, [(0.3, 0, 0.55, 0.55), (1.3, 0, 0.58, 0.6)], look.trim)
        kit.add(CYL, (-0.3, 0, 0), (0.45, 0.45, 0.03), rotation=ALONG_X, material=look.dark)
    else:
        hull(kit, [(0.2, 0, 0.3, 0.26), (1.3, 0, fat * 0.92, 0.45)], look.skin, box=True)
        kit.add(BOX, (-0.2, 0.17, 0.02), (0.03, 0.1, 0.08), material=look.dark, mirror=True)
    airscrew(kit, (-0.25, 0, 0), rng.uniform(0.95, 1.15), look, int(rng.choice([2, 2, 3])), 0.13)
    hull(kit, [(1.2, -0.03, fat, 0.5), (3.9, 0, fat, 0.55), (rng.uniform(7.2, 8.4), 0.18, 0.08, 0.16)], look.skin, box=True)
    rear = 7.6
    kit.add(BOX, (-2.65, 0, 0.78), (1.25, fat * 0.97, 0.36), (0.62, 0.9), (-0.12, 0), material=look.glass)
    kit.add(BOX, (-2.8, 0, 0.78), (0.06, fat * 0.99, 0.36), (1, 0.92), material=look.skin)
    kit.add(BOX, (-4.0, 0, 0.65), (0.9, fat * 0.9, 0.4), (0.5, 0.7), (0.4, 0), material=look.skin)
    half, chord = rng.uniform(5.0, 6.5), rng.uniform(1.45, 1.75)
    wing = surface(kit, (2.0, 0, 1.14, chord, half, 0, chord * rng.choice([1, 1, 0.75]), rng.uniform(0.5, 2)), look.skin, 0.13, True)
    kit.add(BALL, on(wing, 1.0), (chord * 0.36, 0.15, 0.1), material=look.trim, mirror=True)
    strut = on(wing, 0.5)
    for fore in (0.3, -0.35)[: int(rng.integers(1, 3))]:
        kit.between((-2.6 + fore, fat * 0.9, -0.35), strut + [fore, 0, -0.05], (0.06, 0.03), material=look.skin, mirror=True)
    surface(kit, (rear - 0.9, 0.02, 0.22, 1.05, rng.uniform(1.6, 1.9), 6, 0.8, 0), look.skin, 0.08, True)
    surface(kit, (rear - 1.0, 0, 0.15, 1.2, rng.uniform(1.2, 1.5), 30, 0.65, 90), look.trim, 0.08, True)
    surface(kit, (rear - 2.3, 0, 0.3, 1.8, 0.45, 70, 0.5, 90), look.trim, 0.05)
    kit.add(BOX, (-3.6, 0, -0.05), (2.3, fat * 1.005, rng.uniform(0.05, 0.12)), (1, 0.99), material=look.trim)
    if kit.chance(0.2):
        hull(kit, [(-0.2, -1.75, 0.08, 0.1), (1.4, -1.75, 0.36, 0.34), (3.4, -1.75, 0.36, 0.34), (6.4, -1.6, 0.1, 0.1)], look.trim, 1.15)
        for x in (1.7, 3.5):
            kit.between((-x, fat * 0.7, -0.35), (-x, 1.15, -1.6), 0.05, material=look.metal, mirror=True)
            kit.between((-x, -1.15, -1.6), (-x, 1.15, -1.6), 0.05, material=look.metal)
        return
    radius = rng.choice([0.24, 0.24, 0.38])
    x, ground = (1.75, 1.3) if on_tail else (3.1, 1.2)
    kit.between((-x - 0.1, fat * 0.7, -0.4), (-x, 1.15, radius - ground), (0.07, 0.05), material=look.skin, mirror=True)
    if kit.chance(0.15):
        kit.add(BOX, (-x + 0.2, 1.15, radius - ground - 0.1), (0.9, 0.16, 0.05), (1.15, 1), (0.1, 0), material=look.metal, mirror=True)
    else:
        kit.add(CYL, (-x, 1.18, radius - ground), (radius, radius, radius * 0.4), rotation=ALONG_Y, material=look.rubber, mirror=True)
        if radius < 0.3 and kit.chance(0.35):
            kit.add(BALL, (-x - 0.05, 1.18, radius - ground + 0.06), (0.42, 0.16, 0.2), material=look.skin, mirror=True)
    if on_tail:
        wheel(kit, rear - 0.3, 0, 0.2, 0.1, look, 0.12)
        tilted(kit, start, np.degrees(np.arctan2(1.1, rear - 0.3 - x)))
    else:
        wheel(kit, 0.9, 0, ground, 0.2, look, -0.3)


def duster(kit):
    """Crop dusters: a long nose with the hopper, a humped cockpit high behind it, a low braced wing with spray booms, a tail wheel."""
    rng = kit.rng
    look = looks(kit, "gay")
    start, turbine = len(kit.primitives), kit.chance(0.6)
    if turbine:
        hull(kit, [(0.3, 0.05, 0.24, 0.26), (2.1, 0.02, 0.5, 0.55)], look.skin)
        kit.between((-1.0, 0.3, 0), (-1.9, 0.62, -0.1), 0.12, material=look.metal, mirror=True)
    else:
        hull(kit, [(0.5, 0, 0.58, 0.58), (1.4, 0, 0.6, 0.6), (2.1, 0, 0.5, 0.55)], look.trim)
        kit.add(CYL, (-0.5, 0, 0), (0.46, 0.46, 0.03), rotation=ALONG_X, material=look.dark)
    airscrew(kit, (-0.3 if turbine else -0.45, 0, 0.05 if turbine else 0), 1.4, look, 3, 0.24)
    hull(kit, [(2.0, 0, 0.52, 0.58), (5.2, 0.05, 0.5, 0.62), (9.6, 0.25, 0.1, 0.18)], look.skin, box=True)
    kit.add(BOX, (-3.0, 0, 0.62), (1.1, 0.45, 0.14), (0.85, 0.7), material=look.trim)
    kit.add(BOX, (-4.75, 0, 0.98), (0.75, 0.48, 0.45), (0.6, 0.72), (-0.08, 0), material=look.glass)
    kit.add(BOX, (-4.85, 0, 1.42), (0.46, 0.37, 0.05), material=look.skin)
    kit.add(BOX, (-5.9, 0, 0.78), (1.1, 0.4, 0.36), (0.35, 0.6), (0.6, 0), material=look.skin)
    half = rng.uniform(6.5, 8.5)
    wing = surface(kit, (3.1, 0.3, -0.5, 1.85, half, 0, 1.7, 3.5), look.skin, 0.14, True)
    surface(kit, (8.4, 0.05, 0.3, 1.25, 2.4, 4, 1.0, 0), look.trim, 0.08, True)
    surface(kit, (8.2, 0, 0.2, 1.5, 1.6, 20, 0.85, 90), look.trim, 0.08, True)
    kit.between(np.array([-8.9, 0.1, 0.05]) + [0, 0, 0.05], (-9.0, 1.5, 0.3), 0.035, material=look.metal, mirror=True)
    boom = on(wing, 0.0, -0.5)[0] - 0.25
    end = on(wing, 0.72)
    kit.between((boom, 0.2, -0.72), (boom, end[1], end[2] - 0.22), 0.045, material=look.metal, mirror=True)
    for share in (0.1, 0.38, 0.66):
        at = on(wing, share, -0.35)
        kit.between(at, (boom, at[1], at[2] - 0.22), 0.04, material=look.metal, mirror=True)
    if kit.chance(0.4):
        kit.between((-3.4, 0.42, 0.5), on(wing, 0.42), (0.06, 0.03), material=look.skin, mirror=True)
    kit.add(BOX, (-3.6, 0, -0.68), (0.5, 0.4, 0.16), (0.9, 0.8), material=look.metal)
    kit.between((-2.9, 0.4, -0.4), (-2.6, 1.35, -1.35), (0.09, 0.05), material=look.skin, mirror=True)
    kit.add(CYL, (-2.6, 1.4, -1.35), (0.37, 0.37, 0.14), rotation=ALONG_Y, material=look.rubber, mirror=True)
    wheel(kit, 9.0, 0, 0.28, 0.16, look, 0.15)
    kit.add(BOX, (-5.5, 0, 0.0), (2.2, 0.49, 0.1), (1, 0.98), material=look.trim)
    tilted(kit, start, 12.5)


def amphibian(kit):
    """Flying boats: the parasol patrol boat, the fire fighter, the twin with engines on a high wing, the light one with its propeller on a pylon."""
    rng = kit.rng
    kind = rng.choice(["parasol", "fire", "goose", "light"])
    look = looks(kit, "gay" if kind != "parasol" or kit.chance(0.4) else "grey")
    light = kind == "light"
    long, fat, tall = (7.8, 0.55, 0.5) if light else (19, 1.3, 1.3)
    hull(
        kit,
        [
            (0, 0.15, 0.15, 0.2),
            (long * 0.12, 0.05, fat * 0.75, tall * 0.75),
            (long * 0.3, 0, fat, tall),
            (long * 0.52, 0, fat, tall),
            (long, tall * 0.75, fat * 0.2, tall * 0.25),
        ],
        look.skin,
        box=True,
    )
    kit.add(BOX, (-long * 0.3, 0, -tall * 0.95), (long * 0.25, fat * 0.6, tall * 0.45), (1.15, 1.65), (0.1, 0), material=look.trim if kit.chance(0.6) else look.skin)
    high = {"parasol": tall * 2.1, "light": tall * 0.4}.get(kind, tall * 1.25)
    half = 5.5 if light else rng.uniform(14, 15.5)
    chord = half * rng.uniform(0.25, 0.29)
    x = long * (0.42 if light else 0.3)
    if light:
        kit.add(BALL, (-long * 0.28, 0, tall * 0.85), (1.15, fat * 0.88, 0.5), material=look.glass)
    else:
        cockpit(kit, long * 0.17, tall * 1.1, fat * 0.72, tall * 0.38, look, 1.2)
        kit.add(BOX, (-long * 0.4, 0, tall * 0.35), (long * 0.14, fat * 0.97, 0.2), material=ports(kit, 14))
    wing = surface(kit, (x, 0, high, chord, half, 2, chord * rng.uniform(0.55, 1), 2 if light else 0.5), look.skin, 0.14, True)
    if kind == "parasol":
        kit.add(BOX, (-x - chord * 0.5, 0, tall * 1.5), (1.5, 0.5, tall * 0.7), (0.8, 0.9), material=look.skin)
        for fore in (0.25, -0.25):
            kit.between((-x - chord * (0.5 - fore), fat * 0.9, tall * 0.3), on(wing, 0.35, fore), (0.14, 0.06), material=look.skin, mirror=True)
        kit.add(BALL, (-long * 0.62, fat * 0.75, tall * 0.55), (1.1, 0.6, 0.7), material=look.glass, mirror=True)
    elif not light:
        kit.add(BOX, (-x - chord * 0.5, 0, tall * 1.1), (chord * 0.6, fat * 0.7, tall * 0.25), (0.8, 0.7), material=look.skin)
    if light:
        kit.add(BOX, (-long * 0.52, 0, tall * 1.7), (0.35, 0.1, tall * 0.9), (0.8, 1), (-0.1, 0), material=look.skin)
        kit.add(BALL, (-long * 0.53, 0, tall * 2.6), (0.75, 0.28, 0.28), material=look.trim)
        airscrew(kit, (-long * 0.53 - 0.85, 0, tall * 2.6), 0.8, look, int(rng.choice([2, 3])), 0.12)
    else:
        share = 0.16 if kind == "parasol" else 0.23
        at = on(wing, share, 0.5)
        kit.between(at + [-2.6, 0, 0], at + [1.1, 0, 0], 0.75, taper=0.9, material=look.trim if kit.chance(0.4) else look.skin, mirror=True)
        kit.add(CYL, at + [1.1, 0, 0], (0.55, 0.55, 0.03), rotation=ALONG_X, material=look.dark, mirror=True)
        airscrew(kit, at + [1.15, 0, 0], 1.85, look, int(rng.choice([3, 4])), 0.26, True)
    fin = tall * (2.4 if not light else 2.6)
    surface(kit, (long - fin * 1.05, 0, tall * 0.7, fin * 1.05, fin, 25, fin * 0.6, 90), look.trim, 0.09)
    surface(kit, (long - fin * 0.75, 0, tall * 0.7 + fin * (0.45 if not light else 0.6), fin * 0.65, half * 0.33, 6, fin * 0.48, 0), look.skin, 0.09)
    at, size = on(wing, 0.78), 0.5 if light else 1
    low = -tall * 0.35 if not light else -0.1
    kit.add(BOX, at + [0, 0, (low - at[2]) / 2], (size * 0.25, 0.05, (at[2] - low) / 2), material=look.skin, mirror=True)
    kit.add(BALL, (at[0], at[1], low), (size * 1.5, size * 0.36, size * 0.36), material=look.trim, mirror=True)
    if kit.chance(0.45):
        radius = 0.2 if light else 0.5
        ground = tall * 1.4 + radius
        x = long * 0.5
        kit.between((-x, fat * 0.85, 0), (-x, fat * 1.35, radius - ground), radius * 0.25, material=look.metal, mirror=True)
        kit.add(CYL, (-x, fat * 1.4, radius - ground), (radius, radius, radius * 0.4), rotation=ALONG_Y, material=look.rubber, mirror=True)
        wheel(kit, long * 0.12, 0, ground, radius * 0.8, look, -tall * 0.3)
