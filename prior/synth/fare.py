"""Makers of what is round: balls, and what is eaten."""

import numpy as np

from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import CHECKER, PLAIN, PLANKS, SPECKLES, STREAKS, STRIPES, paint


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
