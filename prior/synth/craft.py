"""Makers of aircraft and ships."""

import numpy as np

from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL


def plane(kit):
    rng = kit.rng
    length = rng.uniform(3, 5)
    radius = rng.uniform(0.25, 0.6)
    skin = kit.material()
    wing_skin = kit.material()
    z = rng.uniform(0.8, 1.4)
    kit.add(CYL, (0, 0, z), (radius, radius, length * 0.7), rotation=ALONG_X, material=skin)
    nose = (length * rng.uniform(0.15, 0.4), radius, radius)
    kit.add(BALL, (length * 0.7, 0, z), nose, material=skin)
    cone_centre = (-length * 0.7 - length * 0.2, 0, z + radius * 0.3)
    cone_half = (radius, radius, length * 0.25)
    kit.add(CYL, cone_centre, cone_half, (rng.uniform(0.1, 0.4), 1), rotation=turn("y", -90), material=skin)
    span = rng.uniform(2.2, 4.5)
    chord = rng.uniform(0.5, 1.2)
    sweep = rng.uniform(-0.2, 1.2)
    wing_z = z + radius * rng.uniform(-0.7, 0.9)
    for side in (1, -1):
        centre = (rng.uniform(-0.2, 0.4), side * span / 2, wing_z)
        half = (chord, rng.uniform(0.03, 0.08), span / 2)
        taper = (rng.uniform(0.25, 0.9), 1)
        kit.add(BOX, centre, half, taper, (-sweep, 0), rotation=turn("x", -90 * side), material=wing_skin)
    plane_tail(kit, length, radius, chord, z, wing_skin)
    canopy = kit.material(base=np.array([0.08, 0.1, 0.13]))
    canopy_half = (length * 0.16, radius * 0.5, radius * 0.5)
    kit.add(BALL, (length * 0.45, 0, z + radius * 0.8), canopy_half, material=canopy)
    if rng.random() < 0.6:
        y = span * rng.uniform(0.25, 0.45)
        for side in (1, -1):
            kit.add(CYL, (0.3, side * y, wing_z - 0.2), (0.18, 0.18, 0.5), rotation=ALONG_X)


def plane_tail(kit, length, radius, chord, z, skin):
    """Tailplane and fin, as tall as half the tailplane is wide."""
    size = kit.rng.uniform(0.6, 1.1)
    for side in (1, -1):
        centre = (-length * 0.95, side * size * 0.6, z + radius * 0.4)
        half = (chord * 0.45, 0.04, size * 0.6)
        kit.add(BOX, centre, half, (0.6, 1), (-0.2, 0), rotation=turn("x", -90 * side), material=skin)
    fin_centre = (-length * 0.95, 0, z + radius + size * 0.5)
    kit.add(BOX, fin_centre, (chord * 0.5, 0.05, size * 0.6), (0.6, 1), (-0.3, 0), material=skin)


def helicopter(kit):
    rng = kit.rng
    skin = kit.material()
    z = rng.uniform(0.9, 1.3)
    length = rng.uniform(1.2, 1.9)
    kit.add(BALL, (0, 0, z), (length, rng.uniform(0.55, 0.8), rng.uniform(0.6, 0.85)), material=skin)
    canopy = kit.material(base=np.array([0.07, 0.09, 0.11]))
    kit.add(BALL, (length * 0.45, 0, z + 0.1), (length * 0.55, 0.58, 0.55), material=canopy)
    boom_half = (0.2, 0.2, 1.3)
    kit.add(CYL, (-length - 0.9, 0, z + 0.2), boom_half, (0.4, 1), rotation=turn("y", -90), material=skin)
    kit.add(BOX, (-length - 2, 0, z + 0.55), (0.25, 0.05, 0.45), (0.6, 1), (-0.2, 0), material=skin)
    kit.add(CYL, (0, 0, z + 0.9), (0.08, 0.08, 0.25), material=kit.material(dark=True))
    angle = rng.uniform(0, 90)
    dark = kit.material(dark=True)
    for i in range(int(rng.choice([1, 2]))):
        blade = (rng.uniform(2, 2.8), 0.1, 0.025)
        kit.add(BOX, (0, 0, z + 1.12), blade, rotation=turn("z", angle + 90 * i), material=dark)
    for y in (-0.6, 0.6):
        kit.add(CYL, (0, y, 0.08), (0.05, 0.05, 1.2), rotation=ALONG_X, material=dark)
        kit.add(BOX, (0, y, 0.35), (0.5, 0.04, 0.3), material=dark)


def ship(kit):
    rng = kit.rng
    length = rng.uniform(3.5, 6)
    width = rng.uniform(0.6, 1.1)
    hull = kit.material()
    deck = kit.material()
    kit.add(BOX, (0, 0, 0.45), (length * 0.85, width * 0.8, 0.45), (1.12, 1.2), (0.25, 0), material=hull)
    kit.add(BOX, (0, 0, 1), (length * 0.95, width * 0.96, 0.1), material=deck)
    superstructure(kit, length, width, deck)
    kit.add(CYL, (length * 0.6, 0, 1.25), (0.25, 0.25, 0.15))
    kit.add(CYL, (length * 0.6 + 0.4, 0, 1.35), (0.05, 0.05, 0.4), rotation=ALONG_X)


def superstructure(kit, length, width, material):
    """Deck houses from aft forward, some with a funnel."""
    rng = kit.rng
    x = -length * 0.7
    deck_z = 1.1
    for _ in range(rng.integers(2, 6)):
        half_length = rng.uniform(0.3, 1.1)
        half_height = rng.uniform(0.2, 0.7)
        half = (half_length, width * rng.uniform(0.3, 0.8), half_height)
        taper = (rng.uniform(0.7, 1), rng.uniform(0.7, 1))
        kit.add(BOX, (x + half_length, 0, deck_z + half_height), half, taper, material=material)
        if rng.random() < 0.5:
            funnel = (x + half_length, 0, deck_z + 2 * half_height + 0.4)
            kit.add(CYL, funnel, (0.12, 0.12, 0.5), (0.7, 1))
        x += half_length * 1.5 + 0.2
        if x > length * 0.6:
            break
