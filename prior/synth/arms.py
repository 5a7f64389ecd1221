"""Makers of what is held in a hand: arms and tools; and of what is round: balls, fruit, cakes."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import CHECKER, PLAIN, PLANKS, RIBS, SPECKLES, STREAKS, STRIPES, paint


def hand_tool(kit):
    """Rifles, pistols, drills, hammers, axes, saws, spanners, swords, brushes: lying, standing or leaning."""
    rng = kit.rng
    grip = kit.material(pattern=rng.choice([PLANKS, PLAIN, RIBS, STREAKS])) if kit.chance(0.6) else kit.material(dark=True)
    steel, dark = kit.material(base=rng.uniform(0.1, 0.7) * np.ones(3), pattern=PLAIN, gloss=rng.uniform(0.1, 0.6)), kit.material(dark=True)
    kind = rng.choice(["rifle", "pistol", "drill", "hammer", "saw", "spanner", "sword"])
    if kind == "rifle":
        stock, barrel = rng.uniform(0.5, 0.9), rng.uniform(0.7, 1.4)
        kit.add(BOX, (0, 0, 0), (0.35, 0.05, 0.1), material=steel)
        kit.add(BOX, (-0.35 - stock / 2, 0, -0.06), (0.13, 0.05, stock / 2), (rng.uniform(1.0, 1.6), 1), (-0.06, 0), rotation=turn("y", -90), material=grip)
        kit.between((0.3, 0, 0.03), (0.3 + barrel, 0, 0.03), 0.03, material=dark)
        kit.add(BOX, (0.3 + barrel * 0.3, 0, -0.02), (barrel * 0.32, 0.05, 0.06), (0.9, 0.9), material=grip)
        kit.between((0.3 + barrel * 0.92, 0, 0.03), (0.3 + barrel * 0.92, 0, 0.12), 0.012, BOX, material=dark)
        kit.add(BOX, (-0.22, 0, -0.2), (0.06, 0.035, 0.14), (1, 1), (0.08, 0), material=grip)
        if kit.chance(0.7):
            kit.add(BOX, (0.1, 0, -0.28), (0.08, 0.03, rng.uniform(0.12, 0.28)), (1, 1), (-rng.uniform(-0.15, 0.1), 0), material=steel)
        if kit.chance(0.4):
            kit.add(CYL, (0.02, 0, 0.2), (0.06, 0.06, 0.22), (1.2, 1), rotation=ALONG_X, material=dark)
            kit.add(BOX, (0.02, 0, 0.12), (0.1, 0.03, 0.03), material=dark)
        if kit.chance(0.3):
            kit.between((0.3 + barrel * 0.6, 0.02, 0), (0.3 + barrel * 0.65, 0.2, -0.45), 0.015, material=dark, mirror=True)
    elif kind == "pistol":
        kit.add(BOX, (0.15, 0, 0.1), (0.5, 0.07, 0.09), material=steel)
        kit.add(BOX, (-0.2, 0, -0.22), (0.13, 0.065, 0.28), (1, 1), (0.12, 0), material=grip)
        kit.add(TUBE, (0.12, 0, -0.06), (0.12, 0.1, 0.02), rotation=ALONG_Y, material=steel)
        kit.add(CYL, (0.68, 0, 0.11), (0.035, 0.035, 0.06), rotation=ALONG_X, material=dark)
        if kit.chance(0.4):
            kit.add(CYL, (0.0, 0, 0.06), (0.13, 0.13, 0.16), rotation=ALONG_X, material=steel)
        kit.add(BOX, (-0.3, 0, 0.21), (0.03, 0.03, 0.04), material=dark)
    elif kind == "drill":
        shell = kit.material()
        kit.add(CYL, (0, 0, 0.5), (0.17, 0.15, 0.42), rotation=ALONG_X, material=shell)
        kit.add(CYL, (0.5, 0, 0.5), (0.13, 0.13, 0.14), (0.6, 1), rotation=ALONG_X, material=dark)
        kit.between((0.6, 0, 0.5), (rng.uniform(0.9, 1.3), 0, 0.5), 0.025, material=steel)
        kit.add(BOX, (-0.2, 0, 0.1), (0.12, 0.09, 0.35), (1, 1), (0.1, 0), material=grip)
        kit.add(BOX, (-0.2, 0, -0.28), (0.28, 0.17, 0.13), material=dark if kit.chance(0.5) else shell)
        kit.add(BOX, (-0.06, 0, 0.28), (0.04, 0.03, 0.07), material=dark)
    elif kind == "hammer":
        long = rng.uniform(1.2, 2.2)
        kit.between((0, 0, 0), (0, 0, long), (0.06, 0.045), taper=rng.uniform(0.7, 1), material=grip)
        if kit.chance(0.5):
            kit.add(BOX, (0.05, 0, long), (0.3, 0.1, 0.1), material=steel)
            kit.add(CYL, (0.4, 0, long), (0.12, 0.12, 0.07), rotation=ALONG_X, material=steel)
            kit.add(BOX, (-0.35, 0, long - 0.02), (0.1, 0.1, 0.15), (1, 0.2), rotation=turn("y", -90), material=steel)
        else:
            kit.add(BOX, (0.25, 0, long - 0.1), (0.3, 0.07, 0.28), (1.5, 0.12), rotation=ALONG_X, material=steel)
            kit.add(BOX, (0, 0, long - 0.1), (0.1, 0.08, 0.12), material=steel)
    elif kind == "saw":
        long = rng.uniform(1.0, 1.8)
        kit.add(BOX, (long / 2, 0, 0.1), (rng.uniform(0.14, 0.24), 0.01, long / 2), (0.45, 1), (0.06, 0), rotation=ALONG_X, material=steel)
        kit.add(TUBE, (-0.2, 0, 0.05), (0.2, 0.26, 0.05), rotation=ALONG_Y, material=grip)
        kit.add(BOX, (-0.05, 0, 0.05), (0.12, 0.05, 0.12), material=grip)
    elif kind == "spanner":
        long = rng.uniform(0.8, 1.6)
        kit.between((-long / 2, 0, 0), (long / 2, 0, 0), (0.03, 0.08), BOX, material=steel)
        kit.add(TUBE, (-long / 2 - 0.12, 0, 0), (0.16, 0.16, 0.05), material=steel)
        for y in (-0.13, 0.13):
            kit.add(BOX, (long / 2 + 0.14, y, 0), (0.18, 0.06, 0.05), rotation=turn("z", y * 120), material=steel)
    else:
        long = rng.uniform(1.0, 2.2)
        kit.add(BOX, (0, 0, 0.35 + long / 2), (rng.uniform(0.04, 0.1), 0.015, long / 2), (rng.uniform(0.3, 1), 1), material=steel)
        kit.add(BOX, (0, 0, 0.34), (rng.uniform(0.12, 0.3), 0.05, 0.03), material=dark)
        kit.between((0, 0, 0), (0, 0, 0.34), 0.04, material=grip)
        kit.add(BALL, (0, 0, -0.02), (0.06, 0.06, 0.06), material=dark)
    laid = turn("x", rng.choice([0, 0, 90])) @ turn("y", rng.choice([0, rng.uniform(-60, 60)]))
    kit.primitives = [p._replace(centre=laid @ p.centre, rotation=laid @ p.rotation) for p in kit.primitives]


def fare(kit):
    """Balls, fruit, cakes, loaves, burgers, cones of ice, some on a plate: round things with a top and a bottom."""
    rng = kit.rng
    first, second = kit.material(), kit.material()
    kind = rng.choice(["ball", "fruit", "cake", "burger", "cone", "loaf"])
    if kind == "ball":
        kit.add(BALL, (0, 0, 1), (1, 1, 1), material=kit.material(pattern=rng.choice([CHECKER, STRIPES, PLAIN, SPECKLES]), frequency=rng.uniform(2, 8)))
        if kit.chance(0.5):
            kit.add(CYL, (0, 0, 0.08), (0.6, 0.6, 0.1), (0.8, 1), material=second)
    elif kind == "fruit":
        tone = paint(rng.choice([0.0, 0.04, 0.09, 0.14, 0.25, 0.8]), rng.uniform(0.6, 1), rng.uniform(0.3, 0.9))
        flesh = kit.material(base=tone, pattern=rng.choice([PLAIN, STREAKS, SPECKLES]), gloss=0.3)
        for _ in range(int(rng.choice([1, 1, 2, 3, 5]))):
            at = np.array([*rng.normal(0, 0.7, 2), 0]) if len(kit.primitives) else np.zeros(3)
            wide, high = rng.uniform(0.4, 0.6), rng.uniform(0.35, 0.75)
            kit.add(BALL, at + [0, 0, high], (wide, wide, high), material=flesh)
            if kit.chance(0.5):
                kit.add(BALL, at + [0, 0, high * 1.6], (wide * 0.55, wide * 0.55, high * 0.6), material=flesh)
            kit.between(at + [0, 0, 1.9 * high], at + [0.08, 0, 2.3 * high], 0.03, material=kit.material(base=[0.15, 0.09, 0.04]))
            if kit.chance(0.5):
                kit.add(BALL, at + [0.2, 0.05, 2.1 * high], (0.2, 0.08, 0.02), rotation=turn("y", 20), material=kit.material(base=[0.1, 0.3, 0.06]))
    elif kind == "cake":
        wide, z = rng.uniform(0.7, 1.1), 0.0
        for _ in range(int(rng.integers(1, 5))):
            high = rng.uniform(0.15, 0.5)
            kit.add(CYL, (0, 0, z + high / 2), (wide, wide, high / 2), material=first)
            kit.add(CYL, (0, 0, z + high), (wide * 1.02, wide * 1.02, 0.04), material=second)
            z, wide = z + high, wide * rng.uniform(0.6, 1)
        count = int(rng.integers(0, 9))
        for k in range(count):
            angle = 2 * np.pi * k / count
            at = (wide * 0.75 * np.cos(angle), wide * 0.75 * np.sin(angle), z + 0.1)
            if kit.chance(0.5):
                kit.add(BALL, at, (0.09, 0.09, 0.09), material=kit.material(base=[0.6, 0.03, 0.04]))
            else:
                kit.between(at, (at[0], at[1], at[2] + 0.3), 0.025, material=second)
    elif kind == "burger":
        bun = kit.material(base=np.array([0.55, 0.3, 0.1]) * rng.uniform(0.6, 1.3), pattern=SPECKLES)
        kit.add(CYL, (0, 0, 0.12), (0.9, 0.9, 0.12), (1.08, 1), material=bun)
        z = 0.26
        for _ in range(int(rng.integers(2, 6))):
            high = rng.uniform(0.04, 0.14)
            kit.add(CYL if kit.chance(0.7) else BOX, (0, 0, z + high), (rng.uniform(0.8, 1.05),) * 2 + (high,), rotation=turn("z", rng.uniform(0, 90)), material=kit.material())
            z += 2 * high
        kit.loft((0, 0, z), [(0, 0.95), (0.2, 0.9), (0.38, 0.65), (0.48, 0.2)], bun)
    elif kind == "cone":
        kit.add(CYL, (0, 0, 0.75), (0.05, 0.05, 0.75), (8, 1), material=kit.material(base=[0.6, 0.4, 0.18], pattern=CHECKER, frequency=12))
        for k in range(int(rng.integers(1, 4))):
            kit.add(BALL, (rng.normal(0, 0.08), rng.normal(0, 0.12), 1.6 + 0.5 * k), (0.45, 0.45, 0.4), material=kit.material())
    else:
        crust = kit.material(base=np.array([0.5, 0.3, 0.12]) * rng.uniform(0.5, 1.4), pattern=STREAKS)
        long, wide, high = rng.uniform(0.7, 1.6), rng.uniform(0.35, 0.7), rng.uniform(0.25, 0.5)
        kit.add(BALL, (0, 0, high), (long, wide, high), material=crust)
        for x in np.linspace(-0.6, 0.6, int(rng.integers(0, 5))):
            kit.add(BOX, (x * long, 0, high * 1.92), (0.03, wide * 0.5, 0.03), rotation=turn("z", 35), material=kit.material(base=[0.8, 0.65, 0.4]))
        if kit.chance(0.4):
            kit.add(BOX, (0, 0, 0), (long * 1.2, wide * 1.5, 0.04), material=kit.material(pattern=PLANKS))
    if kit.chance(0.3):
        low = min(p.centre[2] - (np.abs(p.rotation) @ p.half)[2] for p in kit.primitives)
        kit.add(CYL, (0, 0, low - 0.03), (1.3, 1.3, 0.03), (1.1, 1), material=kit.material(gloss=0.4))
