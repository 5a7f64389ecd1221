"""Makers of spacecraft: landers, probes, rovers."""

import numpy as np

from .belongings import black, pale, steel
from .fittings import bent, box, disc, near, pick, rod
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, LATTICE, PRISM, RUNGS, TUBE
from .materials import CHECKER, CLOUDY, PATCHWORK, PLAIN, RIBS, SEAMS
from .roadcraft import slab


def spacecraft(kit):
    """Landers on splayed legs in foil, and probes with a dish and booms."""
    pick(kit, [moon_lander, moon_lander, small_lander, probe, probe, rover_probe])


def foil(kit):
    return near(kit, (0.75, 0.48, 0.1), (0.6, 0.35, 0.06), (0.7, 0.68, 0.62), (0.06, 0.06, 0.07), pattern=kit.rng.choice([PATCHWORK, CLOUDY, CHECKER]), frequency=kit.rng.uniform(8, 18), gloss=0.6)


def solar(kit):
    return near(kit, (0.02, 0.05, 0.2), (0.03, 0.03, 0.07), pattern=CHECKER, frequency=kit.rng.uniform(8, 16), gloss=0.5)


def legs(kit, count, hip, reach, low, high, metal, pad, first=45):
    """Splayed legs with struts and pads: from the hip circle out to the circle of `reach`."""
    for k, (c, s) in enumerate(around(count, 1.0, first)):
        way, side = np.array([c, s, 0]), np.array([-s, c, 0])
        knee, end = way * hip + [0, 0, high], way * reach + [0, 0, 0.08]
        rod(kit, knee, end, 0.06 * hip, metal)
        for y in (-1, 1):
            rod(kit, way * hip * 0.95 + side * y * hip * 0.4 + [0, 0, low], knee * 0.35 + end * 0.65, 0.03 * hip, metal)
        kit.add(CYL, end - [0, 0, 0.04], (pad * 0.75, pad * 0.75, 0.04), (1.33, 1), material=metal)


def moon_lander(kit):
    """An octagonal descent stage in foil on four legs, above it the faceted cabin with hatch, windows, thrusters and aerials."""
    rng = kit.rng
    gold, grey, dark, metal = foil(kit), near(kit, (0.3, 0.31, 0.32), (0.6, 0.6, 0.58), (0.12, 0.12, 0.13), pattern=rng.choice([PLAIN, SEAMS, PATCHWORK]), frequency=6, gloss=0.2), black(kit), foil(kit) if kit.chance(0.6) else steel(kit)
    r, low, stage = rng.uniform(1.8, 2.1), rng.uniform(1.1, 1.5), rng.uniform(1.3, 1.7)
    kit.add(PRISM, (0, 0, low + stage / 2), (r, r, stage / 2), (1, 8), material=gold)
    for z in (low, low + stage):
        kit.add(PRISM, (0, 0, z), (r * 1.02, r * 1.02, 0.04), (1, 8), material=grey)
    kit.add(CYL, (0, 0, low - 0.25), (0.75, 0.75, 0.4), (0.45, 1), material=dark)
    legs(kit, 4, r * 0.95, r * rng.uniform(2.0, 2.4), low, low + stage * 0.85, metal, 0.45, first=0)
    rungs = np.array([r * 1.15, 0, 0])
    kit.between(rungs + [r * 0.75, 0, 0.5], rungs + [0, 0, low + stage], (0.02, 0.22), BOX, material=steel(kit), cut=(RUNGS, 4, 0.35))
    box(kit, (r * 1.05, 0, low + stage + 0.02), (0.4, 0.4, 0.03), grey)
    base, tall = low + stage, rng.uniform(1.7, 2.1)
    kit.add(CYL, (r * 0.2, 0, base + tall * 0.5), (tall * 0.5, 1.15, r * 0.55), rotation=ALONG_X, material=grey)
    slab(kit, base + 0.1, base + tall * 0.55, (r * 0.2, r * 0.78, 0.8), (r * 0.2, r * 0.86, 0.95), grey)
    slab(kit, base + tall * 0.5, base + tall * 0.98, (r * 0.1, r * 0.86, 0.95), (r * 0.1, r * 0.5, 0.6), grey)
    box(kit, (r * 0.83, 0, base + tall * 0.28), (0.02, 0.4, tall * 0.22), gold if kit.chance(0.3) else dark)
    for y in (-1, 1):
        kit.add(PRISM, (r * 0.75, y * 0.52, base + tall * 0.68), (0.22, 0.22, 0.03), (1, 3), rotation=turn("y", 62), material=dark)
        kit.add(BALL, (-r * 0.1, y * 1.3, base + tall * 0.45), (0.62, 0.55, 0.62), material=gold if kit.chance(0.4) else grey)
    box(kit, (-r * 0.62, 0, base + tall * 0.5), (0.4, 0.85, tall * 0.42), grey, taper=(0.9, 0.9))
    kit.add(CYL, (0, 0, base + tall), (0.5, 0.5, 0.16), (0.85, 1), material=dark)
    for x, y in around(4, 1.65, 45):
        rod(kit, (x * 0.6, y * 0.6, base + tall * 0.6), (x, y, base + tall * 0.62), 0.05, metal)
        kit.add(CYL, (x, y, base + tall * 0.78), (0.1, 0.1, 0.12), (1.5, 1), material=dark)
        kit.add(CYL, (x, y, base + tall * 0.46), (0.15, 0.15, 0.12), (0.65, 1), material=dark)
    dish = turn("y", rng.uniform(20, 80))
    at = np.array([r * 0.45, -0.9, base + tall * 1.2])
    rod(kit, (r * 0.3, -0.8, base + tall * 0.85), at, 0.04, metal)
    kit.add(TUBE, at + dish @ [0, 0, 0.1], (0.12, 0.12, 0.13), (3.6, 1), rotation=dish, material=grey)
    for y in (-0.5, 0.7):
        rod(kit, (-0.3, y, base + tall * 0.8), (-0.5, y * 1.4, base + tall * 1.5), 0.015, metal)


def small_lander(kit):
    """Robot landers on three or four legs: a deck with tanks, boxes, solar wings, a dish."""
    rng = kit.rng
    gold, grey, dark, metal, cells = foil(kit), pale(kit), black(kit), steel(kit), solar(kit)
    r, low, thick, count = rng.uniform(0.7, 1.0), rng.uniform(0.55, 0.8), rng.uniform(0.15, 0.4), int(rng.choice([3, 4, 4]))
    kit.add(PRISM, (0, 0, low + thick / 2), (r, r, thick / 2), (1, int(rng.choice([4, 6, 8]))), material=gold)
    legs(kit, count, r * 0.9, r * rng.uniform(1.5, 1.9), low, low + thick, metal, rng.uniform(0.14, 0.22), first=45 if count == 4 else 60)
    top = low + thick
    for x, y in around(4, r * 0.55, 0):
        kit.add(BALL, (x, y, low - 0.02), (r * 0.24,) * 3, material=metal if kit.chance(0.5) else gold)
    kit.add(CYL, (0, 0, low - 0.15), (0.2, 0.2, 0.16), (0.5, 1), material=dark)
    if kit.chance(0.7):
        shape, sides = (PRISM, 10) if kit.chance(0.5) else (BOX, 1)
        for side in (-1, 1):
            tilt = turn("x", side * rng.uniform(-10, 25))
            wing = rng.uniform(0.5, 0.9)
            kit.add(shape, (0, side * (r + wing * 0.95), top), (wing, wing, 0.02), (1, sides), rotation=tilt, material=cells)
            rod(kit, (0, side * r * 0.7, top - 0.05), (0, side * (r + wing * 0.5), top), 0.035, metal)
    else:
        slab(kit, top, top + r * 0.9, (-r * 0.6, r * 0.6, r * 0.6), (-r * 0.45, r * 0.45, r * 0.45), cells)
    mast = np.array([r * 0.35, r * 0.2, top])
    for _ in range(int(rng.integers(3, 6))):
        half = rng.uniform(0.08, 0.2, 3)
        kit.add(rng.choice([BOX, CYL]), (rng.uniform(-0.55, 0.55) * r, rng.uniform(-0.55, 0.55) * r, top + half[2]), half, material=gold if kit.chance(0.4) else grey)
    rod(kit, mast, mast + [0, 0, rng.uniform(0.7, 1.1)], 0.03, metal)
    dish = turn("z", rng.uniform(0, 360)) @ turn("y", rng.uniform(20, 60))
    tip = kit.primitives[-1].centre * [1, 1, 2] - [0, 0, top]
    kit.add(TUBE, tip + dish @ [0, 0, 0.06], (0.06, 0.06, 0.08), (rng.uniform(4, 6), 1), rotation=dish, material=grey)
    rod(kit, tip, tip + dish @ [0, 0, 0.28], 0.012, dark)
    rod(kit, (-r * 0.6, 0, top), (-r * 0.8, 0, top + rng.uniform(0.6, 1.4)), 0.012, metal)
    if kit.chance(0.4):
        bent(kit, [(r * 0.7, -r * 0.3, top), (r * 1.2, -r * 0.4, top + 0.4), (r * 1.9, -r * 0.5, top - 0.1)], 0.03, metal)


def probe(kit):
    """Deep-space probes: a great dish over a bus of many sides, long booms, a power source or solar wings."""
    rng = kit.rng
    gold, grey, dark, metal = foil(kit), pale(kit), black(kit), steel(kit)
    tip = turn("y", rng.uniform(0, 90)) @ turn("x", rng.uniform(-30, 30))
    start, dish = len(kit.primitives), rng.uniform(0.9, 1.3)
    sides, half = int(rng.choice([6, 8, 10])), rng.uniform(0.2, 0.4)
    bus = dish * rng.uniform(0.45, 0.65)
    kit.add(PRISM, (0, 0, 0), (bus, bus, half), (1, sides), material=gold)
    kit.add(PRISM, (0, 0, half * 0.2), (bus * 1.02, bus * 1.02, half * 0.35), (1, sides), material=dark if kit.chance(0.5) else grey)
    z = half
    for low, high, rise in ((0.12, 0.5, 0.06), (0.5, 0.8, 0.1), (0.8, 1.0, 0.13)):
        kit.add(TUBE, (0, 0, z + rise * dish / 2), (dish * low, dish * low, rise * dish / 2), (high / low, 1), material=grey)
        z += rise * dish
    kit.add(CYL, (0, 0, z + dish * 0.3), (0.05, 0.05, 0.07), (2.2, 1), material=grey)
    for x, y in around(3, 1.0, 30):
        rod(kit, (x * dish * 0.75, y * dish * 0.75, half + dish * 0.14), (x * 0.05, y * 0.05, z + dish * 0.3), 0.014, metal)
    reach = dish * rng.uniform(1.4, 2.4)
    if kit.chance(0.5):
        kit.between((bus, 0, 0), (bus + reach, 0, 0), 0.07, BOX, material=metal, cut=(LATTICE, 6, 0.35))
        kit.add(CYL, (bus + reach, 0, 0), (0.1, 0.1, 0.14), rotation=ALONG_X, material=dark)
        rod(kit, (-bus, 0, 0), (-bus - reach * 0.5, 0, -0.1), 0.03, metal)
        for k in range(3):
            kit.add(CYL, (-bus - reach * 0.5 - 0.3 * k, 0, -0.1), (0.13, 0.13, 0.13), rotation=ALONG_X, material=dark._replace(pattern=RIBS, frequency=20.0, second=grey.first))
    else:
        cells, wide = solar(kit), rng.uniform(0.3, 0.5)
        for side in (-1, 1):
            rod(kit, (0, side * bus, 0), (0, side * (bus + 0.3), 0), 0.03, metal)
            for k in range(2):
                box(kit, (0, side * (bus + 0.3 + (0.5 + k) * reach * 0.42), 0), (wide, reach * 0.2, 0.015), cells)
    rod(kit, (0, bus * 0.8, -half), (0.3, bus + reach * 0.6, -half - 0.2), 0.025, metal)
    box(kit, (0.3, bus + reach * 0.6, -half - 0.2), (0.14, 0.2, 0.12), gold)
    kit.add(CYL, (0.3, bus + reach * 0.6 + 0.25, -half - 0.2), (0.08, 0.08, 0.14), rotation=ALONG_Y, material=dark)
    kit.add(CYL, (0, 0, -half - 0.14), (0.22, 0.22, 0.16), (0.45, 1), material=dark)
    for x, y in around(4, bus * 0.85, 20):
        kit.add(BOX if kit.chance(0.6) else CYL, (x, y, -half * 0.9), rng.uniform(0.07, 0.16, 3), material=grey if kit.chance(0.5) else gold)
    for _ in range(int(rng.integers(1, 3))):
        end = np.array([rng.uniform(-0.6, 0.6), rng.uniform(-0.8, -0.4), -rng.uniform(0.5, 1.0)]) * reach
        rod(kit, (0, -bus * 0.8, -half * 0.8), end, 0.012, metal)
    kit.primitives[start:] = [p._replace(centre=tip @ p.centre, rotation=tip @ p.rotation) for p in kit.primitives[start:]]


def rover_probe(kit):
    """Rovers on six wheels with rocker arms, a mast with cameras, an arm and a power source."""
    rng = kit.rng
    gold, grey, dark, metal = foil(kit), pale(kit), black(kit), steel(kit)
    wheel, long, wide = rng.uniform(0.22, 0.28), rng.uniform(0.95, 1.15), rng.uniform(0.75, 0.95)
    tread = near(kit, (0.3, 0.3, 0.3), (0.08, 0.08, 0.08), pattern=RIBS, frequency=30, gloss=0.2)
    for x in (-long, 0, long):
        disc(kit, (x, wide, wheel), wheel, 0.16, tread, True, ALONG_Y)
        disc(kit, (x, wide, wheel), wheel * 0.5, 0.17, metal, True, ALONG_Y)
        rod(kit, (x, wide - 0.24, wheel), (x, wide - 0.24, wheel + 0.35), 0.035, metal, True)
    deck, pivot = wheel * 2 + 0.3, (0.15, wide - 0.24, wheel + 0.55)
    rod(kit, (long, wide - 0.24, wheel + 0.35), pivot, 0.04, metal, True)
    rod(kit, pivot, (-long * 0.5, wide - 0.24, wheel + 0.38), 0.04, metal, True)
    rod(kit, (0, wide - 0.24, wheel + 0.35), (-long, wide - 0.24, wheel + 0.35), 0.035, metal, True)
    rod(kit, (0.15, -wide + 0.24, wheel + 0.55), (0.15, wide - 0.24, wheel + 0.55), 0.04, metal)
    box(kit, (0, 0, deck + 0.1), (long * 0.75, wide * 0.55, 0.18), gold if kit.chance(0.5) else grey)
    if kit.chance(0.5):
        box(kit, (-0.1, 0, deck + 0.32), (long * 1.0, wide * 1.0, 0.02), solar(kit))
    else:
        box(kit, (0, 0, deck + 0.3), (long * 0.8, wide * 0.62, 0.025), grey)
        kit.add(PRISM, (-long * 1.05, 0, deck + 0.35), (0.2, 0.2, 0.3), (1, 8), rotation=turn("y", -45), material=dark._replace(pattern=RIBS, frequency=15.0, second=grey.first))
        rod(kit, (-long * 0.7, 0, deck + 0.1), (-long * 1.0, 0, deck + 0.3), 0.06, metal)
    head = np.array([long * 0.6, rng.choice([-1, 1]) * wide * 0.35, deck + rng.uniform(1.0, 1.3)])
    rod(kit, head * [1, 1, 0] + [0, 0, deck + 0.3], head, 0.05, grey)
    box(kit, head, (0.1, 0.24, 0.09), grey)
    for y in (-0.13, 0.13):
        disc(kit, head + [0.1, y, 0], 0.05, 0.02, dark, rotation=ALONG_X)
    bent(kit, [(long * 0.75, 0, deck), (long * 1.15, 0, deck + 0.4), (long * 1.5, 0, deck - 0.1)], 0.04, metal)
    box(kit, (long * 1.52, 0, deck - 0.18), (0.1, 0.1, 0.1), dark)
    kit.add(PRISM, (-long * 0.3, -wide * 0.4, deck + 0.45), (0.2, 0.2, 0.02), (1, 6), rotation=turn("y", 25), material=grey)
    rod(kit, (-long * 0.3, -wide * 0.4, deck + 0.28), (-long * 0.3, -wide * 0.4, deck + 0.45), 0.025, metal)
    rod(kit, (-long * 0.6, wide * 0.4, deck + 0.3), (-long * 0.6, wide * 0.4, deck + 0.9), 0.025, dark)
