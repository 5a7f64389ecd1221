"""Makers of what is held in a hand: arms and tools."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import PLAIN, PLANKS, RIBS, STREAKS


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
