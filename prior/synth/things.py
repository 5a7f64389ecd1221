"""Makers of plants, people and animals, ware, furniture, and of bodies that are nothing known."""

import numpy as np

from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import CLOUDY


def plant(kit):
    """A trunk under a conifer's cones or a round crown."""
    rng = kit.rng
    height = rng.uniform(0.5, 2)
    bark = kit.material(base=np.array([0.25, 0.17, 0.1]))
    kit.add(CYL, (0, 0, height), (0.15, 0.15, height), (0.7, 1), material=bark)
    leaves = kit.material(base=np.array([0.12, 0.3, 0.08]) * rng.uniform(0.5, 1.8))
    leaves = leaves._replace(pattern=CLOUDY)
    if rng.random() < 0.4:
        for i in range(3):
            radius = 1.1 - 0.25 * i
            kit.add(CYL, (0, 0, height + 0.5 + 0.7 * i), (radius, radius, 0.6), (0.1, 1), material=leaves)
    else:
        for _ in range(rng.integers(2, 8)):
            centre = (*rng.normal(0, 0.45, 2), 2 * height + rng.normal(0, 0.35))
            kit.add(BALL, centre, rng.uniform(0.4, 1.1, 3), material=leaves)


def figure(kit):
    """A person or an animal."""
    rng = kit.rng
    cloth = kit.material()
    skin = kit.material(base=np.array([0.5, 0.36, 0.27]) * rng.uniform(0.4, 1.5))
    if rng.random() < 0.5:
        person(kit, cloth, skin)
    else:
        animal(kit, skin)


def person(kit, cloth, skin):
    rng = kit.rng
    for y in (-0.18, 0.18):
        leg = (rng.uniform(-0.15, 0.15), y, 0.45)
        kit.add(CYL, leg, (0.13, 0.13, 0.47), (1.2, 1), material=kit.material())
        arm = (rng.uniform(-0.1, 0.1), 2.1 * y, 1.2)
        swing = turn("x", rng.uniform(-25, 25))
        kit.add(CYL, arm, (0.09, 0.09, 0.38), rotation=swing, material=cloth)
    kit.add(BALL, (0, 0, 1.25), (0.2, 0.3, 0.45), material=cloth)
    kit.add(BALL, (0.02, 0, 1.78), (0.13, 0.12, 0.16), material=skin)


def animal(kit, skin):
    rng = kit.rng
    length = rng.uniform(0.6, 1.2)
    kit.add(BALL, (0, 0, 1), (length, 0.35, 0.4), material=skin)
    kit.add(BALL, (length * 1.1, 0, 1.3 + rng.uniform(-0.2, 0.3)), (0.32, 0.2, 0.22), material=skin)
    for x in (-0.6, 0.6):
        for y in (-0.2, 0.2):
            kit.add(CYL, (x * length, y, 0.4), (0.09, 0.09, 0.42), material=skin)
    kit.add(CYL, (-length * 1.1, 0, 1.1), (0.05, 0.05, 0.35), rotation=turn("y", 50), material=skin)


def ware(kit):
    """Bottles, mugs, vases, lamps: rings on top of each other, perhaps a lid and a handle."""
    rng = kit.rng
    z = 0
    radius = rng.uniform(0.3, 0.9)
    material = kit.material()
    for _ in range(rng.integers(2, 7)):
        half = rng.uniform(0.08, 0.7)
        top = np.clip(radius * rng.uniform(0.6, 1.5), 0.12, 1.2)
        ring = material if rng.random() < 0.7 else kit.material()
        kit.add(CYL, (0, 0, z + half), (radius, radius, half), (top / radius, 1), material=ring)
        z += 2 * half
        radius = top
    if rng.random() < 0.4:
        lid = (radius, radius, radius * rng.uniform(0.3, 1))
        kit.add(BALL, (0, 0, z), lid, material=kit.material())
    if rng.random() < 0.3:
        for i in (0, 1):
            half = (0.06 if i else 0.2, 0.06, z * 0.3 if i else 0.06)
            kit.add(BOX, (radius * 0.9 + 0.2 * i, 0, z * 0.5), half, material=material)


def furniture(kit):
    """Table, bench, chair or sofa."""
    rng = kit.rng
    half_x = rng.uniform(0.5, 1.6)
    half_y = rng.uniform(0.4, 1)
    leg = rng.uniform(0.3, 0.9)
    frame = kit.material()
    for x in (-1, 1):
        for y in (-1, 1):
            kind = BOX if rng.random() < 0.6 else CYL
            kit.add(kind, (x * half_x * 0.9, y * half_y * 0.9, leg), (0.06, 0.06, leg), material=frame)
    kit.add(BOX, (0, 0, 2 * leg + 0.06), (half_x, half_y, 0.08), material=kit.material())
    if rng.random() < 0.6:
        kit.add(BOX, (-half_x * 0.93, 0, 2 * leg + 0.7), (0.06, half_y, 0.65), material=kit.material())
    if rng.random() < 0.4:
        for side in (-1, 1):
            kit.add(BOX, (0, side * half_y * 0.95, 2 * leg + 0.35), (half_x, 0.07, 0.3), material=frame)


def kitbash(kit):
    """A random walk of random primitives, perhaps mirrored."""
    rng = kit.rng
    centre = np.zeros(3)
    symmetric = rng.random() < 0.5
    for _ in range(rng.integers(2, 14)):
        half = np.exp(rng.normal(-0.9, 0.6, 3))
        if rng.random() < 0.6:
            rotation = np.eye(3)
        else:
            rotation = turn("z", rng.uniform(0, 180)) @ turn("x", rng.uniform(-60, 60))
        kind = int(rng.integers(0, 3))
        taper = rng.uniform(0.3, 1.2, 2)
        shift = rng.normal(0, 0.1, 2)
        mirror = symmetric and rng.random() < 0.7
        kit.add(kind, centre, half, taper, shift, rotation, mirror=mirror)
        centre = centre + rng.normal(0, 1, 3) * half * 1.1
        centre[2] = max(centre[2], -1)
