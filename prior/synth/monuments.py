"""Makers of landmarks: fountains, statues, windmills, water towers and lighthouses."""

import numpy as np

from .kit import around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, PRISM, TUBE
from .materials import BRICKS, PLANKS, RIBS
from .people import person_body
from .structures import roof_material, storey, wall_material


def fountain(kit):
    """Basins on stems, water in them, a figure or a jet on top."""
    rng = kit.rng
    stone = kit.material(base=rng.uniform(0.3, 0.85) * np.array([1, 0.95, 0.88]), pattern=rng.choice([0, 1, 13]))
    water = kit.material(base=[0.1, 0.2, 0.25], gloss=0.6, pattern=7)
    radius = rng.uniform(1, 2)
    rim = rng.uniform(0.2, 0.5)
    sides = int(rng.choice([6, 8, 12]))
    round_basin = kit.chance(0.6)
    for k in (1.0, 0.92):
        if round_basin:
            kit.add(TUBE, (0, 0, rim / 2), (radius * k, radius * k, rim / 2), material=stone)
        else:
            kit.add(PRISM, (0, 0, rim * (k - 0.5) * 0.8), (radius * k, radius * k, rim / 2), (1, sides), material=stone if k == 1 else water)
    if round_basin:
        kit.add(CYL, (0, 0, rim * 0.35), (radius * 0.95, radius * 0.95, rim * 0.35), material=water)
    z = 0.0
    bowl = radius * rng.uniform(0.45, 0.65)
    for _ in range(int(rng.integers(1, 4))):
        stem = rng.uniform(0.5, 1.1)
        kit.loft((0, 0, z), [(0, bowl * 0.28), (stem * 0.3, bowl * 0.13), (stem * 0.8, bowl * 0.12), (stem, bowl * 0.25)], stone)
        z += stem
        kit.add(CYL, (0, 0, z + 0.1), (bowl * 0.35, bowl * 0.35, 0.12), (2.85, 1), material=stone)
        kit.add(CYL, (0, 0, z + 0.215), (bowl * 0.93, bowl * 0.93, 0.015), material=water)
        bowl *= rng.uniform(0.5, 0.7)
    if kit.chance(0.4):
        person_body(kit, (0, 0, z), rng.uniform(0.3, 0.6), stone, stone, stone, upright(kit))
    else:
        kit.loft((0, 0, z), [(0, 0.1), (0.3, 0.06), (0.5, 0.1), (0.7, 0.01)], stone)
    if kit.chance(0.5):
        jet = kit.material(base=[0.8, 0.85, 0.9], pattern=1)
        kit.between((0, 0, z), (0, 0, z + rng.uniform(0.5, 1.3)), 0.05, taper=0.4, material=jet)
        for x, y in around(6, radius * 0.7):
            kit.between((x, y, rim * 0.6), (x * 0.45, y * 0.45, z * 0.8 + 0.4), 0.018, material=jet)


def upright(kit):
    """A pose of somebody who needs no seat."""
    return kit.rng.choice(["stand", "walk", "kneel"], p=[0.65, 0.25, 0.1])


def statue(kit):
    """A figure, an animal's body or an obelisk on a pedestal of steps."""
    rng = kit.rng
    stone = kit.material(base=rng.uniform(0.1, 0.8) * np.array([1, 0.97, 0.9]), pattern=rng.choice([0, 1, 13]))
    foot = kit.material(pattern=rng.choice([0, 1, BRICKS]))
    half, z = rng.uniform(0.4, 0.8), 0.0
    for _ in range(int(rng.integers(1, 4))):
        step = rng.uniform(0.1, 0.6)
        kit.add(BOX, (0, 0, z + step / 2), (half, half, step / 2), (rng.uniform(0.85, 1),) * 2, material=foot)
        z += step
        half *= rng.uniform(0.65, 0.9)
    if kit.chance(0.65):
        person_body(kit, (0, 0, z), rng.uniform(0.8, 1.5), stone, stone, stone, upright(kit))
    else:
        tall = rng.uniform(1.5, 4)
        storey(kit, int(rng.choice([4, 4, 0, 8])), z, half * 0.6, tall, stone, rng.uniform(0.5, 0.9))
        kit.add(PRISM, (0, 0, z + tall + 0.12), (half * 0.4, half * 0.4, 0.13), (0.02, 4), material=stone)


def windmill(kit):
    """Old mills and wind turbines."""
    rng = kit.rng
    modern = kit.chance(0.5)
    height = rng.uniform(2, 4.5) if modern else rng.uniform(1.5, 2.5)
    body = kit.material(base=[0.8, 0.8, 0.8]) if modern else wall_material(kit)
    radius = 0.1 if modern else rng.uniform(0.6, 0.9)
    kit.add(CYL, (0, 0, height / 2), (radius, radius, height / 2), (0.55, 1), material=body)
    hub = np.array([radius * 0.8 + 0.15, 0, height])
    if modern:
        kit.add(BOX, (0, 0, height), (0.28, 0.11, 0.12), material=body)
    else:
        kit.add(CYL, (0, 0, height + 0.25), (radius * 0.65, radius * 0.65, 0.35), (0.1, 1), material=roof_material(kit))
    kit.add(BALL, hub, (0.12, 0.12, 0.12), material=body)
    first, blades = rng.uniform(0, 120), 3 if modern else 4
    long = height * rng.uniform(0.5, 0.75)
    blade_skin = body if modern else kit.material()
    for k in range(blades):
        out = turn("x", first + 360 * k / blades) @ np.array([0, 0, 1.0])
        if modern:
            kit.between(hub, hub + long * out, (0.02, 0.09), BOX, 0.25, material=blade_skin)
        else:
            kit.between(hub, hub + long * out, (0.02, 0.03), BOX, material=blade_skin)
            sail = (GRID, 5, 0.25) if kit.chance(0.5) else (0, 1.0, 1.0)
            kit.between(hub + 0.2 * long * out, hub + long * out, (0.01, 0.16), BOX, material=blade_skin, cut=sail)


def tank_tower(kit):
    """Water towers, lighthouses, silos in groups, observation towers."""
    rng = kit.rng
    kind = rng.random()
    metal = kit.material(pattern=rng.choice([0, RIBS, 2, 13]))
    if kind < 0.4:
        height, radius = rng.uniform(1.5, 3), rng.uniform(0.5, 1)
        for x, y in around(int(rng.choice([4, 6])), radius * 0.85, 45):
            kit.between((x * 1.3, y * 1.3, 0), (x, y, height), 0.04, material=metal)
        kit.between((0, 0, 0), (0, 0, height), 0.07, material=metal)
        profile = [(0, radius * 0.6), (radius * 0.35, radius), (radius * 1.5, radius), (radius * 2, 0.05)]
        kit.loft((0, 0, height), profile, kit.material(pattern=rng.choice([0, PLANKS, RIBS, 14])))
    elif kind < 0.7:
        height, radius = rng.uniform(2, 4), rng.uniform(0.35, 0.6)
        bands = kit.material(pattern=2, frequency=rng.uniform(2, 5))
        kit.add(CYL, (0, 0, height / 2), (radius, radius, height / 2), (0.6, 1), material=bands)
        kit.add(CYL, (0, 0, height + 0.03), (radius * 0.85, radius * 0.85, 0.05), material=metal)
        kit.add(TUBE, (0, 0, height + 0.15), (radius * 0.82, radius * 0.82, 0.1), material=metal, cut=(BARS, 24, 0.25))
        kit.add(CYL, (0, 0, height + 0.3), (radius * 0.42, radius * 0.42, 0.25), material=kit.material(gloss=0.6))
        kit.add(BALL, (0, 0, height + 0.55), (radius * 0.48, radius * 0.48, 0.25), material=kit.material())
        if kit.chance(0.5):
            kit.add(BOX, (0.6, 0.3, 0.3), (0.5, 0.4, 0.3), material=wall_material(kit))
    else:
        for i in range(int(rng.integers(2, 6))):
            radius, height = rng.uniform(0.3, 0.5), rng.uniform(1.5, 3)
            x, y = 1.02 * (i % 3), 1.02 * (i // 3)
            kit.loft((x, y, 0), [(0, radius), (height, radius), (height + 0.3, 0.05)], metal)
        kit.between((0, 0, 3.2), (2, 0.5, 3.2), (0.08, 0.1), BOX, material=metal)
        kit.between((0, 0.5, 0), (0, 0.5, 3.2), 0.1, BOX, material=metal, cut=(LATTICE, 5, 0.2))
