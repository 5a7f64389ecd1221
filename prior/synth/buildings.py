"""Makers of buildings, towers, stores of goods, and masts."""

import numpy as np

from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL


def house(kit):
    """One to three wings, each with its roof, windows and door; perhaps a chimney on the last one."""
    rng = kit.rng
    walls = None
    for i in range(rng.integers(1, 4)):
        half = (rng.uniform(1, 3), rng.uniform(1, 2.2), rng.uniform(0.6, 2))
        place = (0, 0) if i == 0 else (rng.uniform(-2, 2), rng.uniform(-1.5, 1.5))
        own = kit.material()
        walls = walls or own
        house_wing(kit, place, half, walls)
    if rng.random() < 0.5:
        kit.add(BOX, (rng.uniform(-0.8, 0.8), 0.3, 2 * half[2] + 0.9), (0.18, 0.18, 0.4))


def house_wing(kit, place, half, walls):
    rng = kit.rng
    x, y = place
    half_x, half_y, half_z = half
    walls = walls._replace(pattern=int(rng.choice([0, 1, 2, 3, 6])))
    kit.add(BOX, (x, y, half_z), half, material=walls)
    house_roof(kit, place, half)
    glass = kit.material(base=np.array([0.1, 0.13, 0.16]) * rng.uniform(0.5, 2))
    count = int(rng.integers(1, 4))
    for i in range(count):
        across = half_x * (2 * (i + 0.5) / count - 1)
        centre = (x + across, y, half_z * rng.uniform(1, 1.2))
        kit.add(BOX, centre, (half_x * 0.5 / count, half_y * 1.01, half_z * 0.22), material=glass)
    door = (x + rng.choice([-1, 1]) * half_x, y + rng.uniform(-0.4, 0.4) * half_y, half_z * 0.45)
    kit.add(BOX, door, (0.05, 0.3, half_z * 0.45), material=kit.material())


def house_roof(kit, place, half):
    """Gabled or hipped, flat, or none."""
    rng = kit.rng
    half_x, half_y, half_z = half
    kind = rng.random()
    material = kit.material()
    if kind < 0.5:
        size = (half_x * 1.1, half_y * 1.12, 0.4 + rng.uniform(0, 0.4))
        taper = (1, 0.02) if rng.random() < 0.7 else (0.3, 0.02)
        kit.add(BOX, (*place, 2 * half_z + 0.4), size, taper, material=material)
    elif kind < 0.8:
        kit.add(BOX, (*place, 2 * half_z + 0.08), (half_x * 1.05, half_y * 1.05, 0.1), material=material)


def tower(kit):
    """A stack of storeys that narrow upward, with plant and perhaps an aerial on top."""
    rng = kit.rng
    z = 0
    half_x = rng.uniform(0.8, 2)
    half_y = rng.uniform(0.8, 2)
    material = kit.material()
    kind = CYL if rng.random() < 0.2 else BOX
    for _ in range(rng.integers(1, 5)):
        half_z = rng.uniform(0.3, 2.5)
        storey = material._replace(pattern=int(rng.choice([3, 3, 2, 0])))
        taper = (rng.uniform(0.85, 1), rng.uniform(0.85, 1))
        kit.add(kind, (0, 0, z + half_z), (half_x, half_y, half_z), taper, material=storey)
        z += 2 * half_z
        half_x *= rng.uniform(0.5, 1)
        half_y *= rng.uniform(0.5, 1)
        if rng.random() < 0.3:
            material = kit.material()
    for _ in range(rng.integers(0, 4)):
        centre = (rng.uniform(-0.5, 0.5) * half_x, rng.uniform(-0.5, 0.5) * half_y, z + 0.1)
        kit.add(BOX, centre, rng.uniform(0.05, 0.3, 3))
    if rng.random() < 0.4:
        kit.add(CYL, (0, 0, z + 0.5), (0.05, 0.05, 0.6))


def store(kit):
    """A group of containers, barrels, silos, tents and lying tanks."""
    rng = kit.rng
    for i in range(rng.integers(1, 6)):
        kind = rng.random()
        place = (rng.uniform(-1.5, 1.5), rng.uniform(-1, 1)) if i else (0, 0)
        size = rng.uniform(0.4, 1.4)
        if kind < 0.35:
            half = (size * rng.uniform(0.6, 2), size * 0.6, size * 0.6)
            kit.add(BOX, (*place, size * 0.6), half, rotation=turn("z", rng.uniform(0, 180)))
        elif kind < 0.6:
            kit.add(CYL, (*place, size), (size * 0.6, size * 0.6, size))
        elif kind < 0.75:
            kit.add(CYL, (*place, size * 1.2), (size * 0.7, size * 0.7, size * 1.2))
            kit.add(BALL, (*place, size * 2.4), (size * 0.7, size * 0.7, size * 0.4))
        elif kind < 0.88:
            half = (size * 1.4, size, size * 0.6)
            kit.add(BOX, (*place, size * 0.6), half, (1, 0.03), rotation=turn("z", rng.uniform(0, 180)))
        else:
            kit.add(CYL, (*place, size * 0.5), (size * 0.5, size * 0.5, size), rotation=ALONG_X)


def mast(kit):
    """A post on a cabinet, with a dish at its top."""
    rng = kit.rng
    height = rng.uniform(1, 3)
    kit.add(CYL, (0, 0, height), (0.14, 0.14, height), (0.6, 1))
    kit.add(BOX, (0, 0, 0.2), (rng.uniform(0.3, 1), rng.uniform(0.3, 1), 0.25))
    tilt = rng.uniform(-60, 20)
    dish = (rng.uniform(0.1, 0.3), rng.uniform(0.6, 1.4), rng.uniform(0.4, 1.2))
    kit.add(BALL, (0.2, 0, 2 * height), dish, rotation=turn("y", tilt))
    kit.add(CYL, (0.5, 0, 2 * height), (0.05, 0.05, 0.4), rotation=turn("y", 90 + tilt))
