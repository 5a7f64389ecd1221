"""Makers of aircraft and ships."""

import numpy as np

from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL
from .materials import PLANKS


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


def trawler(kit):
    """Fishing boats and tugs: a sheer hull with a striped rim, a wheelhouse, masts with stays, booms, a gallows, gear on deck."""
    rng = kit.rng
    hull, rim, house = kit.material(gloss=0.2), kit.material(), kit.material(base=rng.uniform(0.5, 0.95) * np.ones(3))
    deck, steel, glass = kit.material(pattern=PLANKS), kit.material(), kit.material(dark=True, gloss=0.5)
    if kit.chance(0.3):
        house = kit.material()
    long, wide, side = rng.uniform(1.6, 2.8), rng.uniform(0.5, 0.85), rng.uniform(0.25, 0.5)
    flare = rng.uniform(1.1, 1.35)
    # Amidships, stern and bow; the bow rises in steps.
    kit.add(BOX, (-long * 0.2, 0, side), (long * 0.6, wide / flare, side), (1.02, flare), material=hull)
    kit.add(BOX, (-long * 0.82, 0, side * 1.15), (long * 0.08, wide * 0.9 / flare, side * 0.95), (1.6, flare), (-0.1, 0), material=hull)
    rise = rng.uniform(0.1, 0.5) * side
    for i, (end, narrow) in enumerate(((0.62, 0.8), (0.8, 0.5))):
        start = (0.4, 0.62)[i]
        tall = side + rise * (i + 1) / 2
        kit.add(BOX, (long * (start + end) / 2, 0, tall), (long * (end - start) / 2 * 1.05, wide * narrow / flare, tall), (1.05, flare * 1.1), (0.06, 0), material=hull)
        kit.add(BOX, (long * (start + end) / 2 + 0.04, 0, 2 * tall), (long * (end - start) / 2 * 1.15, wide * narrow * 1.12, 0.04), material=rim)
    prow = side + rise
    kit.add(BOX, (long * 0.86, 0, prow * 1.05), (prow, wide * 0.5, long * 0.09), (0.8, 0.02), (-prow * 0.25, 0), rotation=ALONG_X, material=hull)
    kit.add(BOX, (-long * 0.2, 0, 2 * side - 0.04), (long * 0.62, wide * 0.93, 0.03), material=deck)
    for y in (-wide * 0.97, wide * 0.97):
        kit.add(BOX, (-long * 0.25, y, 2 * side + 0.06), (long * 0.66, 0.03, 0.1), material=rim)
    # Wheelhouse.
    x = long * rng.choice([rng.uniform(0.05, 0.35), rng.uniform(-0.7, -0.45)])
    cabin, reach = rng.uniform(0.25, 0.5), rng.uniform(0.16, 0.3) * long
    kit.add(BOX, (x, 0, 2 * side + cabin), (reach, wide * 0.62, cabin), (0.92, 0.95), material=house)
    kit.add(BOX, (x, 0, 2 * side + cabin * 1.4), (reach * 1.0, wide * 0.64, cabin * 0.22), (0.95, 0.97), material=glass)
    kit.add(BOX, (x, 0, 2 * side + 2 * cabin + 0.03), (reach * 1.15, wide * 0.72, 0.04), material=rim if kit.chance(0.5) else house)
    roof = 2 * side + 2 * cabin
    if kit.chance(0.5):
        kit.add(BOX, (x, 0, roof + 0.2), (reach * 0.6, wide * 0.4, 0.2), (0.9, 0.9), material=house)
        kit.add(BOX, (x, 0, roof + 0.25), (reach * 0.58, wide * 0.39, 0.08), material=glass)
    if kit.chance(0.5):
        kit.add(CYL, (x - reach * 0.8, 0, roof + 0.2), (0.12, 0.1, 0.3), (0.85, 1), material=kit.material())
    # Masts, stays and booms.
    thin = rng.uniform(0.015, 0.035)
    for mast_x in ([x + rng.uniform(-0.2, 0.2)] + ([long * 0.45 if x < 0 else -long * 0.3] if kit.chance(0.7) else [])):
        foot = roof if abs(mast_x - x) < reach else 2 * side
        high = foot + rng.uniform(0.7, 2)
        kit.between((mast_x, 0, foot), (mast_x, 0, high), thin * 1.4, taper=0.6, material=steel)
        kit.between((mast_x, -0.25, high * 0.85), (mast_x, 0.25, high * 0.85), thin * 0.7, material=steel)
        if kit.chance(0.6):
            kit.between((mast_x, 0, foot + 0.2), (mast_x + rng.choice([-1, 1]) * rng.uniform(0.5, 1.1), 0, high * rng.uniform(0.6, 1)), thin, material=steel)
        if kit.chance(0.6):
            kit.between((mast_x, 0, high), (long * rng.choice([0.85, -0.85]), 0, 2 * side + 0.2), 0.008, material=steel)
    if kit.chance(0.6):  # gallows
        z = 2 * side + rng.uniform(0.6, 1.1)
        kit.between((-long * 0.75, wide * 0.8, 2 * side), (-long * 0.72, wide * 0.6, z), thin * 1.5, material=steel, mirror=True)
        kit.between((-long * 0.72, -wide * 0.65, z), (-long * 0.72, wide * 0.65, z), thin * 1.5, material=steel)
    if kit.chance(0.6):
        kit.railing((long * 0.3, wide * 0.85, 2 * side + rise), (long * 0.8, wide * 0.35, 2 * side + 2 * rise), 0.25, steel, 0.15)
        kit.railing((long * 0.3, -wide * 0.85, 2 * side + rise), (long * 0.8, -wide * 0.35, 2 * side + 2 * rise), 0.25, steel, 0.15)
    for _ in range(int(rng.integers(0, 5))):  # gear
        half = rng.uniform(0.06, 0.2, 3)
        place = (rng.uniform(-0.7, 0.3) * long, rng.uniform(-0.5, 0.5) * wide, 2 * side + half[2])
        kit.add(rng.choice([BOX, CYL]), place, half)
