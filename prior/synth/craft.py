"""Makers of aircraft and ships."""

import numpy as np

from .aircraft import propeller
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import CAMOUFLAGE, PLANKS


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
    """Utility and transport helicopters: cabins with flat sides, doors and windows, engines on top, tails that go on from the roof; some
    with a rotor at either end. Round ones are `aircraft.rotorcraft`'s."""
    rng = kit.rng
    skin = kit.material(pattern=rng.choice([0, 0, 1, CAMOUFLAGE, 2]), gloss=rng.uniform(0, 0.4))
    dark, glass = kit.material(dark=True), kit.material(base=[0.06, 0.08, 0.1], gloss=0.6, pattern=0)
    trim = kit.material()
    tandem = kit.chance(0.15)
    high = rng.uniform(0.45, 0.75)
    wide, long = high * rng.uniform(0.75, 1.1), rng.uniform(2, 3) if tandem else rng.uniform(0.8, 1.8)
    leg = rng.uniform(0.2, 0.5)
    z = leg + high
    kit.add(BOX, (0, 0, z), (long, wide, high), (1, rng.uniform(0.75, 1)), material=skin)
    nose = rng.uniform(0.45, 1.0)
    kit.add(BALL, (long * 0.97, 0, z - high * rng.uniform(0, 0.2)), (nose, wide * 0.98, high * rng.uniform(0.8, 0.97)), material=skin)
    kit.add(BALL, (long * 0.98 + nose * 0.12, 0, z + high * 0.22), (nose * 0.86, wide * 0.9, high * 0.68), material=glass)
    if kit.chance(0.4):
        kit.add(BOX, (0, 0, z - high * 0.72), (long * 1.01, wide * 1.01, high * 0.26), material=trim)
    windows = int(rng.integers(2, 5))
    for k in range(windows):
        x = long * (0.75 - 1.4 * k / windows)
        kit.add(BOX, (x, wide * 0.98, z + high * 0.3), (long * rng.uniform(0.35, 0.55) / windows, 0.03, high * 0.26), material=glass, mirror=True)
    if kit.chance(0.6):
        kit.add(BOX, (rng.uniform(-0.3, 0.4) * long, wide * 0.985, z - high * 0.1), (0.3, 0.03, high * 0.75), material=dark if kit.chance(0.4) else trim, mirror=True)
    if kit.chance(0.35):
        kit.add(CYL, (long + nose * 0.7, 0, z - high * 0.6), (0.09, 0.09, 0.12), material=dark)
    blades, reach = int(rng.choice([2, 3, 4, 4, 5, 6])), rng.uniform(1.7, 2.9)
    if tandem:
        for end in (-0.85, 0.8):
            tall = high * (rng.uniform(0.7, 1.1) if end < 0 else 0.35)
            kit.add(BOX, (end * long, 0, z + high + tall * 0.9), (0.55, wide * 0.4, tall), (0.7, 0.6), material=skin)
            rotor(kit, np.array([end * long, 0, z + high + 2 * tall + 0.1]), long * rng.uniform(0.8, 1.0), blades, dark)
    else:
        roof = z + high
        cowl = high * rng.uniform(0.22, 0.36)
        kit.add(BOX, (-long * 0.15, 0, roof + cowl * 0.8), (long * rng.uniform(0.55, 0.85), wide * 0.6, cowl), (0.75, 0.7), material=skin)
        for side in (-1, 1):
            kit.add(CYL, (long * 0.3, side * wide * 0.33, roof + cowl * 0.6), (cowl * 0.6, cowl * 0.6, 0.35), rotation=ALONG_X, material=dark)
        rotor(kit, np.array([0, 0, roof + 2 * cowl + rng.uniform(0.1, 0.3)]), reach, blades, dark)
        tail_boom(kit, long, wide, high, z, skin, trim, dark)
    undercarriage(kit, long, wide, z - high, dark, skin)


def rotor(kit, hub, reach, blades, material):
    """Blades that droop or cone a little on a mast and a hub; some with tips of another colour."""
    rng = kit.rng
    kit.add(CYL, hub - [0, 0, 0.15], (0.07, 0.07, 0.2), material=material)
    kit.add(CYL, hub, (0.16, 0.16, 0.05), (0.7, 1), material=material)
    chord, droop, first = rng.uniform(0.06, 0.12), rng.uniform(-0.12, 0.05), rng.uniform(0, 6.3)
    for k in range(blades):
        turned = first + 2 * np.pi * k / blades
        way = np.array([np.cos(turned), np.sin(turned), droop])
        kit.between(hub + 0.1 * way, hub + reach * way, (0.014, chord), BOX, material=material)


def tail_boom(kit, long, wide, high, z, skin, trim, dark):
    """From the cabin's end, narrower, the roof's line going on; fin, tailplane, and a tail rotor in the open or in the fin."""
    rng = kit.rng
    rear, narrow = rng.uniform(0.25, 0.7), rng.uniform(0.3, 0.5)
    rise = high * (1 - narrow) * rng.uniform(0.5, 1)
    kit.add(BOX, (-long - rear, 0, z), (high, wide * 0.98, rear), (narrow, narrow), (rise, 0), rotation=turn("y", -90), material=skin)
    start = np.array([-long - 1.9 * rear, 0, z + rise * 0.97])
    tail = start + [-rng.uniform(1.0, 2.0), 0, rng.uniform(0, 0.35)]
    thick = high * narrow * 0.95
    kit.between(start, tail, (thick, min(thick, wide * narrow)), BOX if kit.chance(0.5) else CYL, rng.uniform(0.4, 0.7), material=skin)
    fin, sweep = rng.uniform(0.5, 0.9), rng.uniform(0.15, 0.6)
    if kit.chance(0.45):
        duct = rng.uniform(0.3, 0.45)
        middle = tail + [-duct, 0, duct * 0.3]
        kit.add(TUBE, middle, (duct * 1.25, duct * 1.25, 0.12), rotation=turn("x", 90), material=skin)
        propeller(kit, middle, duct, turn("x", 90), dark, 8)
        root = middle + [-duct * 0.6, 0, duct]
    else:
        propeller(kit, tail + [-0.3 - sweep * 0.5, rng.choice([-1, 1]) * 0.12, fin * 0.8], rng.uniform(0.3, 0.5), turn("x", 90), dark)
        root = tail + [-0.2, 0, 0]
    kit.add(BOX, root + [-sweep / 2, 0, fin * 0.5], (rng.uniform(0.25, 0.4), 0.05, fin * 0.6), (0.6, 1), (-sweep, 0), material=trim if kit.chance(0.4) else skin)
    span = rng.uniform(0.4, 0.85)
    plane_at = (tail + start) / 2 if kit.chance(0.5) else tail + [0.1, 0, 0.02]
    kit.add(BOX, plane_at, (0.16, span, 0.03), material=skin)
    if kit.chance(0.5):
        kit.add(BOX, plane_at + [-0.05, span, 0.05], (0.2, 0.03, 0.25), (0.7, 1), (-0.1, 0), material=trim, mirror=True)


def undercarriage(kit, long, wide, belly, dark, skin):
    """Skids, or wheels on legs or beside the cabin in fairings."""
    rng = kit.rng
    if kit.chance(0.35):
        out = wide * rng.uniform(1.0, 1.3)
        for x in (-long * 0.45, long * 0.5):
            kit.between((x, wide * 0.7, belly + 0.05), (x, out, 0.05), 0.03, material=dark, mirror=True)
        kit.add(CYL, (0.1 * long, out, 0.04), (0.035, 0.035, long * 1.05), rotation=ALONG_X, material=dark, mirror=True)
        return
    if kit.chance(0.5):
        kit.add(BOX, (-0.1 * long, wide * 1.1, belly + 0.12), (long * 0.4, 0.16, 0.16), (0.8, 0.8), material=skin, mirror=True)
    tyre = rng.uniform(0.12, 0.2)
    for x, y in ((long * 0.75, wide * 0.3), (-long * 0.35, wide * 1.05)):
        kit.between((x, y * 0.9, belly + 0.15), (x, y, tyre), 0.045, material=dark, mirror=True)
        kit.add(CYL, (x, y, tyre), (tyre, tyre, 0.07), rotation=ALONG_Y, material=dark, mirror=True)


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
