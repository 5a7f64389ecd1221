"""Makers of jets, rotorcraft and rockets: swept wings, thin blades, fins."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, LATTICE, TUBE
from .materials import CAMOUFLAGE


def jet(kit):
    """Fighters, trainers, gliders, airliners: swept, delta or straight wings, one fin or two, engines, stores."""
    rng = kit.rng
    skin = kit.material(pattern=rng.choice([0, 0, 1, CAMOUFLAGE, 2, 6]), gloss=rng.uniform(0, 0.4))
    second = skin if kit.chance(0.7) else kit.material()
    glass, dark = kit.material(base=[0.06, 0.08, 0.1], gloss=0.6, pattern=0), kit.material(dark=True)
    long, radius = rng.uniform(2, 4), rng.uniform(0.16, 0.42)
    z = rng.uniform(0.7, 1.2) if kit.chance(0.75) else 0.0
    profile = [(-long, radius * rng.uniform(0.2, 0.8)), (-long * 0.6, radius * 0.95), (long * 0.3, radius)]
    profile += [(long * 0.7, radius * 0.75), (long * 0.95, radius * 0.25), (long * 1.05, 0.02)]
    kit.loft((0, 0, z), profile, skin, axis=ALONG_X, flat=rng.uniform(0.85, 1.3))
    kit.add(BALL, (long * 0.5, 0, z + radius * 0.65), (long * 0.16, radius * 0.6, radius * 0.6), material=glass)
    span, chord = rng.uniform(1.0, 3.6), rng.uniform(0.35, 1.2)
    sweep = rng.uniform(-0.1, 1.4) * min(1.0, span / 2)
    taper = rng.uniform(0.1, 0.8)
    thin = rng.uniform(0.02, 0.05)
    level = z + radius * rng.uniform(-0.6, 0.7)
    dihedral = rng.uniform(-4, 9)
    wing = (chord, thin, span / 2)
    x = rng.uniform(-0.4, 0.3)

    def panel(centre, half, narrow, back, tilt):
        kit.add(BOX, centre, half, (narrow, 0.6), (-back, 0), rotation=turn("x", -90 + tilt), material=second, mirror=True)

    panel((x - sweep / 2, radius * 0.6 + span / 2, level + np.sin(np.radians(dihedral)) * span / 2), wing, taper, sweep, dihedral)
    tail = rng.uniform(0.3, 0.5) * span
    tail_x = -long * rng.uniform(0.8, 0.95)
    tee = kit.chance(0.2)
    fins = 2 if kit.chance(0.3) else 1
    fin = rng.uniform(0.5, 1.1)
    tail_z = z + radius + 2 * fin * 0.45 if tee else z + radius * 0.3
    panel((tail_x - 0.1, tail / 2 + radius * 0.3 * (not tee), tail_z), (chord * 0.45, thin, tail / 2), 0.5, sweep * 0.4, 0)
    for k in range(fins):
        y = radius * 0.6 * (fins - 1)
        lean = rng.uniform(5, 25) if fins == 2 else 0
        kit.add(BOX, (tail_x, y, z + radius * 0.5 + fin * 0.5), (chord * 0.5, thin, fin * 0.55), (0.45, 1), (-fin * 0.5, 0), rotation=turn("x", -lean), material=second, mirror=fins == 2)
        if fins == 2:
            break
    engines = rng.random()
    if engines < 0.35:
        for k in rng.uniform(0.25, 0.7, 1 if kit.chance(0.7) else 2):
            kit.add(CYL, (x + 0.15 - sweep * k, radius * 0.6 + span * k, level - 0.2), (0.14, 0.14, 0.38), (0.9, 1), rotation=ALONG_X, material=skin, mirror=True)
    elif engines < 0.6:
        kit.add(BOX, (0, radius * 1.05, z - 0.05), (long * 0.35, radius * 0.4, radius * 0.55), material=skin, mirror=True)
        kit.add(BOX, (long * 0.35, radius * 1.05, z - 0.05), (0.02, radius * 0.33, radius * 0.45), material=dark, mirror=True)
    elif engines < 0.8:
        propeller(kit, (long * 1.05, 0, z), rng.uniform(0.5, 0.9), turn("y", 90), dark)
    for k in rng.uniform(0.3, 0.9, int(rng.integers(0, 3))):
        kit.add(CYL, (x - sweep * k, radius * 0.6 + span * k * 0.9, level - 0.12), (0.05, 0.05, 0.4), rotation=ALONG_X, mirror=True)
    if z > 0:
        for px, py in ((long * 0.55, 0), (-0.2, radius + 0.3)):
            kit.between((px, py, z - radius * 0.5), (px, py, 0.12), 0.03, material=dark, mirror=py > 0)
            kit.add(CYL, (px, py, 0.12), (0.12, 0.12, 0.05), rotation=ALONG_Y, material=dark, mirror=py > 0)


def propeller(kit, centre, radius, axis, material, blades=None):
    """Hub and thin blades turning about local z of `axis`."""
    blades = blades or int(kit.rng.choice([2, 2, 3, 4, 5]))
    first = kit.rng.uniform(0, 360)
    centre = np.array(centre, float)
    kit.add(CYL, centre, (radius * 0.08, radius * 0.08, radius * 0.12), rotation=axis, material=material)
    for k in range(blades):
        out = axis @ turn("z", first + 360 * k / blades) @ np.array([1.0, 0, 0])
        middle = centre + out * radius * 0.5
        rotation = axis @ turn("z", first + 360 * k / blades) @ turn("x", kit.rng.uniform(0, 12))
        half = (radius * 0.5, radius * kit.rng.uniform(0.03, 0.07), max(0.012, radius * 0.008))
        kit.add(BOX, middle, half, rotation=rotation, material=material)


def rotorcraft(kit):
    """Helicopters of every build, with rotors, tail rotor, skids or wheels; and drones."""
    rng = kit.rng
    skin = kit.material(pattern=rng.choice([0, 0, 1, CAMOUFLAGE, 2, 14]), gloss=rng.uniform(0, 0.4))
    glass, dark = kit.material(base=[0.06, 0.08, 0.1], gloss=0.6, pattern=0), kit.material(dark=True)
    if kit.chance(0.25):
        arm = rng.uniform(0.5, 1)
        body = rng.uniform(0.15, 0.35)
        kit.add(rng.choice([BALL, BOX]), (0, 0, 0.35), (body * 1.3, body, body * 0.45), material=skin)
        count = int(rng.choice([4, 4, 6, 8]))
        for x, y in around(count, arm, 45):
            kit.between((0, 0, 0.37), (x, y, 0.42), 0.03, material=skin)
            kit.add(CYL, (x, y, 0.44), (0.06, 0.06, 0.07), material=dark)
            if kit.chance(0.3):
                kit.add(TUBE, (x, y, 0.5), (arm * 0.48, arm * 0.48, 0.03), material=dark)
            propeller(kit, (x, y, 0.53), arm * rng.uniform(0.35, 0.48), np.eye(3), dark, 2)
        kit.add(BALL, (body, 0, 0.2), (0.09, 0.09, 0.09), material=dark)
        kit.between((0, body, 0.3), (0, body * 1.4, 0), 0.025, material=dark, mirror=True)
        kit.add(CYL, (0, body * 1.4, 0.02), (0.02, 0.02, 0.3), rotation=ALONG_X, material=dark, mirror=True)
        return
    long, fat = rng.uniform(1, 1.9), rng.uniform(0.38, 0.75)
    z = rng.uniform(0.8, 1.1) + fat * 0.3
    slim = rng.uniform(0.6, 1)
    kit.add(BALL, (0, 0, z), (long, fat * slim, fat), material=skin)
    kit.add(BALL, (long * 0.42, 0, z + 0.08 * fat), (long * 0.58, fat * slim * 0.95, fat * 0.85), material=glass)
    if kit.chance(0.6):
        kit.add(BOX, (-long * 0.1, 0, z + fat * 0.85), (long * 0.5, fat * 0.45, fat * 0.3), (0.8, 0.7), material=skin)
    boom = rng.uniform(1.4, 2.4)
    tail = np.array([-long * 0.6 - boom, 0, z + rng.uniform(0.1, 0.65)])
    lattice = kit.chance(0.15)
    if lattice:
        kit.between((-long * 0.6, 0, z), tail, (0.12, 0.01), BOX, 0.5, material=skin, cut=(LATTICE, 4, 0.2))
    kit.between((-long * 0.6, 0, z + 0.1), tail, fat * rng.uniform(0.3, 0.6) if not lattice else 0.03, taper=0.4, material=skin)
    fin = rng.uniform(0.4, 0.7)
    kit.add(BOX, tail + [-0.05, 0, fin * 0.4], (0.22, 0.03, fin * 0.6), (0.6, 1), (-0.25, 0), material=skin)
    kit.add(BOX, tail + [0.4, 0, 0], (0.15, rng.uniform(0.3, 0.6), 0.02), material=skin)
    if kit.chance(0.3):
        # The tail rotor in a duct at the foot of a high fin.
        duct = fat * rng.uniform(0.5, 0.7)
        kit.add(TUBE, tail, (duct, duct, 0.08), rotation=turn("x", 90), material=skin)
        propeller(kit, tail, duct * 0.85, turn("x", 90), dark, 6)
        kit.add(BOX, tail + [-duct * 0.7, 0, duct + fin * 0.5], (0.25, 0.05, fin * 0.9), (0.55, 1), (-0.35, 0), material=skin)
    else:
        propeller(kit, tail + [0, 0.08, fin * 0.6], rng.uniform(0.25, 0.4), turn("x", 90), dark)
    mast = z + fat * rng.uniform(1.2, 1.4)
    kit.between((0, 0, z + fat * 0.5), (0, 0, mast), 0.06, material=dark)
    propeller(kit, (0, 0, mast), long + boom * rng.uniform(0.5, 0.9), np.eye(3), dark)
    low = z - fat
    if kit.chance(0.6):
        skid = fat * rng.uniform(0.8, 1.1)
        for x in (-long * 0.4, long * 0.4):
            kit.between((x, fat * 0.5, z - fat * 0.7), (x, skid, low - 0.25), 0.03, material=dark, mirror=True)
        kit.add(CYL, (0.05, skid, low - 0.26), (0.03, 0.03, long * 0.85), rotation=ALONG_X, material=dark, mirror=True)
    else:
        for x, y in ((long * 0.5, 0.15), (-long * 0.4, fat * 0.9)):
            kit.between((x, y * 0.8, z - fat * 0.5), (x, y, low), 0.04, material=dark, mirror=True)
            kit.add(CYL, (x, y, low - 0.1), (0.15, 0.15, 0.06), rotation=ALONG_Y, material=dark, mirror=True)
    if kit.chance(0.3):
        kit.add(BOX, (-0.1, fat + 0.35, z - 0.1), (0.2, 0.4, 0.03), material=skin, mirror=True)
        kit.add(CYL, (0, fat + 0.6, z - 0.2), (0.1, 0.1, 0.35), rotation=ALONG_X, material=dark, mirror=True)


def rocket(kit):
    """Launchers with boosters, missiles on stands, toy rockets."""
    rng = kit.rng
    skin = kit.material(base=rng.uniform(0.4, 0.95) * np.ones(3), pattern=rng.choice([0, 0, 2, 14, 4])) if kit.chance(0.7) else kit.material()
    dark = kit.material(dark=True)
    height, radius = rng.uniform(2, 6), rng.uniform(0.2, 0.5)
    shoulder = rng.uniform(0.6, 0.85) * height
    nose = rng.uniform(0.8, 1.35) * radius
    start = rng.uniform(0, 0.5)
    profile = [(start, radius), (shoulder * 0.5, radius), (shoulder * 0.52, radius * rng.uniform(0.8, 1)), (shoulder, radius * 0.9)]
    profile += [(shoulder + 0.15, nose), (height * 0.9, nose), (height, nose * 0.5), (height + nose * 0.7, 0.02)]
    kit.loft((0, 0, 0), sorted(profile), skin)
    for _ in range(int(rng.integers(0, 4))):
        z = rng.uniform(0.1, 0.8) * shoulder
        kit.add(CYL, (0, 0, z + start), (radius * 1.02, radius * 1.02, rng.uniform(0.03, 0.2)), material=kit.material())
    if kit.chance(0.5):
        count = int(rng.choice([2, 4]))
        size, tall = radius * rng.uniform(0.4, 0.9), height * rng.uniform(0.3, 0.6)
        paint_two = kit.material()
        for x, y in around(count, radius + size):
            kit.loft((x, y, start * 0.8), [(0, size), (tall, size), (tall + size * 2, 0.02)], paint_two)
    if kit.chance(0.6):
        count = int(rng.choice([3, 4]))
        fin = rng.uniform(0.2, 0.6)
        fins = kit.material()
        for k in range(count):
            spin = turn("z", 360 * k / count + 20)
            centre = spin @ np.array([radius + fin / 2, 0, start + fin])
            kit.add(BOX, centre, (fin / 2 + 0.05, 0.025, fin), (0.3, 1), (-fin * 0.4, 0), rotation=spin, material=fins)
    kit.add(CYL, (0, 0, start * 0.5), (radius * 0.6, radius * 0.6, max(start * 0.5, 0.02)), (0.7, 1), material=dark)
    if kit.chance(0.3):
        kit.add(BOX, (0, 0, 0.06), (radius * 3, radius * 3, 0.06), material=kit.material())
