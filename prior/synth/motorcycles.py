"""Makers of motorcycles with fairings and of scooters; open ones are `machines.cycle`'s."""

import numpy as np

from .kit import ALONG_Y, turn
from .layout import BALL, BOX, CYL, SPOKES
from .machines import spoked_wheel
from .materials import PLAIN, WRITING


def motorcycle(kit):
    """Sports and touring motorcycles: faired, with forks, swing arm, exhausts, some with cases; or a scooter."""
    rng = kit.rng
    coat, second = kit.material(gloss=rng.uniform(0.2, 0.6)), kit.material(gloss=0.4)
    dark, metal = kit.material(dark=True), kit.material(base=rng.uniform(0.25, 0.7) * np.ones(3), gloss=0.6)
    if kit.chance(0.3):
        scooter(kit, coat, dark, metal)
        return
    radius, reach = rng.uniform(0.28, 0.34), rng.uniform(0.62, 0.8)
    tyres(kit, reach, radius, rng.uniform(0.05, 0.08), rng.uniform(0.07, 0.12), dark, metal)
    fork = rng.uniform(0.09, 0.12)
    kit.between((reach * 0.68, fork, 0.92), (reach, fork, radius), 0.03, material=metal, mirror=True)
    kit.between((-0.1, fork, 0.42), (-reach, fork, radius), (0.03, 0.045), BOX, material=metal, mirror=True)
    kit.add(BOX, (reach * 0.98, 0, radius * 2.0), (radius * 0.6, 0.08, 0.04), (0.7, 0.8), material=coat)
    kit.add(BOX, (0.02, 0, 0.5), (0.25, 0.16, 0.22), material=metal)
    kit.add(BALL, (0.08, 0, 0.83), (0.3, rng.uniform(0.13, 0.18), 0.15), material=coat)
    full = kit.chance(0.7)
    if full:
        side = second if kit.chance(0.4) else coat
        kit.add(BALL, (0.25, 0, 0.64), (0.42, rng.uniform(0.19, 0.25), 0.28), rotation=turn("y", rng.uniform(0, 15)), material=side)
        kit.add(BOX, (0.1, 0, 0.33), (0.36, 0.17, 0.1), (0.9, 1.1), material=side)
    nose = np.array([reach * 0.8, 0, rng.uniform(0.9, 1.02)])
    kit.add(BALL, nose, (0.2, rng.uniform(0.15, 0.22), 0.18), material=coat)
    kit.add(BALL, nose + [0.15, 0.06, 0], (0.05, 0.06, 0.05), material=kit.material(base=[0.8, 0.8, 0.75], pattern=PLAIN, gloss=0.6), mirror=True)
    glass = kit.material(base=[0.1, 0.11, 0.12], pattern=PLAIN, gloss=0.6)
    kit.add(BALL, nose + [-0.1, 0, 0.16], (0.12, 0.14, rng.uniform(0.12, 0.28)), rotation=turn("y", -rng.uniform(15, 40)), material=glass)
    grip = np.array([reach * 0.5, rng.uniform(0.28, 0.38), rng.uniform(0.95, 1.12)])
    kit.between((reach * 0.62, 0.05, 0.96), grip, 0.022, material=dark, mirror=True)
    if kit.chance(0.7):
        kit.between(grip * [1, 0.8, 1], grip + [0.05, 0.05, 0.18], 0.01, material=dark, mirror=True)
        kit.add(BALL, grip + [0.05, 0.07, 0.2], (0.03, 0.06, 0.04), material=dark, mirror=True)
    rise = rng.uniform(0.02, 0.16)
    kit.add(BOX, (-0.32, 0, 0.82), (0.26, 0.14, 0.05), rotation=turn("y", 6), material=dark)
    kit.add(BOX, (-0.62, 0, 0.86 + rise), (0.3, 0.12, 0.07), (0.6, 0.6), rotation=turn("y", 12), material=coat)
    kit.add(BOX, (-0.93, 0, 0.86 + rise), (0.03, 0.09, 0.04), material=kit.material(base=[0.5, 0.03, 0.03], pattern=PLAIN))
    kit.between((-0.75, 0, 0.84 + rise), (-0.95, 0, 0.68), (0.015, 0.05), BOX, material=dark)
    kit.add(BOX, (-0.95, 0, 0.68), (0.012, 0.09, 0.08), rotation=turn("y", 20), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=30, second=[0.02] * 3))
    pipe = rng.uniform(0.3, 0.75)
    kit.between((-0.15, 0.15, 0.34), (-reach * 1.15, 0.19, 0.34 + pipe * 0.5), 0.055, material=metal if kit.chance(0.6) else dark, mirror=kit.chance(0.5))
    if kit.chance(0.3):
        case = second if kit.chance(0.5) else coat
        kit.add(BOX, (-0.6, 0.3, 0.72), (0.24, 0.11, 0.18), material=case, mirror=True)
        if kit.chance(0.6):
            kit.add(BOX, (-0.85, 0, 1.12), (0.17, 0.22, 0.15), (0.85, 0.85), material=case)


def scooter(kit, coat, dark, metal):
    """A leg shield, a floor to put the feet on, an engine under the seat."""
    rng = kit.rng
    radius, reach = rng.uniform(0.18, 0.25), rng.uniform(0.55, 0.68)
    tyres(kit, reach, radius, 0.05, 0.06, dark, metal)
    lean = turn("y", -rng.uniform(8, 20))
    kit.add(BOX, (reach * 0.72, 0, 0.62), (0.06, rng.uniform(0.17, 0.26), 0.34), (0.8, 0.75), rotation=lean, material=coat)
    kit.add(BALL, (reach, 0, radius * 1.7), (radius * 1.1, 0.11, radius * 0.75), material=coat)
    kit.between((reach * 0.62, 0.05, 0.95), (reach, 0.05, radius), 0.03, material=metal, mirror=True)
    kit.add(BOX, (0.1, 0, 0.32), (0.28, rng.uniform(0.14, 0.2), 0.04), material=dark)
    kit.add(BALL, (-0.42, 0, 0.5), (0.42, rng.uniform(0.17, 0.24), 0.23), material=coat)
    kit.add(BOX, (-0.25, 0, 0.5), (0.16, 0.15, 0.2), material=coat)
    kit.add(BALL, (-0.35, 0, 0.76), (rng.uniform(0.3, 0.4), 0.15, 0.07), material=dark)
    head = np.array([reach * 0.58, 0, 1.0])
    kit.add(BALL, head, (0.12, 0.11, 0.1), material=coat)
    kit.add(BALL, head + [0.1, 0, 0], (0.04, 0.07, 0.07), material=metal)
    kit.between(head, head + [-0.08, rng.uniform(0.26, 0.36), 0.06], 0.022, material=dark, mirror=True)
    if kit.chance(0.5):
        kit.between(head + [-0.06, 0.22, 0.05], head + [-0.02, 0.3, 0.2], 0.01, material=dark, mirror=True)
        kit.add(BOX, head + [-0.02, 0.3, 0.2], (0.01, 0.06, 0.05), material=dark, mirror=True)
    if kit.chance(0.4):
        kit.add(BOX, (-0.85, 0, 0.85), (0.18, 0.2, 0.17), material=kit.material())
    kit.between((-0.2, -0.15, 0.25), (-reach - 0.15, -0.17, 0.3), 0.05, material=metal)


def tyres(kit, reach, radius, front, rear, dark, metal):
    """Two wheels, `front` and `rear` half as wide, alike but for that, with a brake disc before."""
    rng = kit.rng
    spokes = (SPOKES, rng.integers(3, 12), rng.uniform(0.15, 0.45))
    for x, wide in ((reach, front), (-reach, rear)):
        spoked_wheel(kit, x, radius, wide, dark, metal, spokes)
    kit.add(CYL, (reach, 0, radius), (radius * 0.5, radius * 0.5, front * 1.1), rotation=ALONG_Y, material=metal)
