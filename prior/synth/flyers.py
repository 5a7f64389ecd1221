"""Makers of what flies: aeroplanes of every age, and what hovers, floats or hangs in the air."""

import numpy as np

from .aircraft import propeller
from .craft import rotor
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import BANDS, CAMOUFLAGE, CHECKER, CLOUDY, PLAIN, SEAMS, STREAKS, STRIPES, paint
from .people import person_body, skin_material
from .seacraft import crew, ports, white_paint
from .wheeled import coat, glazing


def fixed_wing(kit):
    """Airliners, high-wing transports, flying wings, canard deltas, swing-wing jets, fighters and bombers of the 1940s, seaplanes, gliders, ultralights."""
    kit.rng.choice([airliner, transport, flying_wing, canard_delta, swing_wing, old_fighter, old_bomber, seaplane, glider, ultralight])(kit)


def hovering(kit):
    """Tiltrotors, tandem and coaxial helicopters, small helicopters, gyrocopters, drones, flying cars, hang gliders, paragliders, kites, parachutes, hot-air balloons."""
    kit.rng.choice([tiltrotor, tandem, coaxial, bubble_copter, gyrocopter, multicopter, flying_car, hang_glider, paraglider, kite, parachute, hot_air_balloon])(kit)


def panel(kit, root, length, chord, skin, ratio=0.5, sweep=0.0, lift=0.0, thin=0.03, mirror=True, slim=4.5):
    """A wing from `root`, the middle of its chord (half: `chord`), out to the left and `lift` degrees up; 90: a fin."""
    way = np.array([0, np.cos(np.radians(lift)), np.sin(np.radians(lift))])
    if sweep and length > slim * chord:  # along its sweep, so that `variation.Warp` keeps it where its engines are
        half = np.hypot(sweep, length) / 2
        kit.add(BOX, root + (way * length - [sweep, 0, 0]) / 2, (chord, thin, half), (ratio, 0.5), (0, 0), turn("x", lift - 90) @ turn("y", -np.degrees(np.arctan2(sweep, length))), skin, mirror)
        return
    centre = np.array(root, float) + way * length / 2 - [sweep / 2, 0, 0]
    kit.add(BOX, centre, (chord, thin, length / 2), (ratio, 0.5), (-sweep, 0), turn("x", lift - 90), skin, mirror)


def fuselage(kit, z, profile, skin, flat=1.0):
    """A round body along x: profile [(x, radius), ...] from tail to nose."""
    kit.loft((0, 0, z), profile, skin, axis=ALONG_X, flat=flat)


def rounds(kit, points, radius, paint):
    """Wheels on legs from points [(x, y, z), ...] of the belly down to the ground."""
    dark = kit.material(dark=True)
    for x, y, z in points:
        kit.between((x, y * 0.9, z), (x, y, radius), radius * 0.25, material=paint, mirror=y > 0)
        kit.add(CYL, (x, y, radius), (radius, radius, radius * 0.4), rotation=ALONG_Y, material=dark, mirror=y > 0)


def warpaint(kit):
    """Camouflage, grey, olive or bare metal."""
    rng = kit.rng
    base = np.array([[0.12, 0.13, 0.06], [0.3, 0.32, 0.34], [0.5, 0.52, 0.54], [0.08, 0.1, 0.14], [0.35, 0.27, 0.14], [0.1, 0.16, 0.1]][rng.integers(6)]) * rng.uniform(0.7, 1.3)
    second = np.array([[0.1, 0.07, 0.04], [0.2, 0.2, 0.2], [0.05, 0.08, 0.05]][rng.integers(3)])
    return kit.material(base=base, second=second if kit.chance(0.5) else base * 0.8, pattern=rng.choice([PLAIN, CAMOUFLAGE, SEAMS, CLOUDY, STREAKS]), frequency=rng.uniform(3, 9), gloss=rng.uniform(0, 0.3))


def roundels(kit, x, y, z, size):
    """Round marks on both wings' upper sides."""
    first, second = kit.material(base=kit.rng.choice([[0.03, 0.06, 0.3], [0.6, 0.03, 0.03], [0.75] * 3]), pattern=PLAIN), kit.material(base=[0.75] * 3, pattern=PLAIN)
    kit.add(CYL, (x, y, z), (size, size, 0.006), material=first, mirror=True)
    kit.add(CYL, (x, y, z), (size * 0.5, size * 0.5, 0.009), material=second if kit.chance(0.6) else first, mirror=True)


def nacelle(kit, at, radius, long, skin, dark, mirror=True):
    """A turbofan: a barrel, a dark mouth, a cone behind."""
    at = np.array(at, float)
    kit.add(CYL, at, (radius, radius, long), (0.9, 1), rotation=turn("y", -90), material=skin, mirror=mirror)
    kit.add(CYL, at + [long, 0, 0], (radius * 0.82, radius * 0.82, 0.012), rotation=ALONG_X, material=dark, mirror=mirror)
    kit.add(CYL, at - [long * 1.25, 0, 0], (radius * 0.7, radius * 0.7, long * 0.35), (0.4, 1), rotation=turn("y", -90), material=dark, mirror=mirror)


def airliner(kit):
    """Two or four engines under swept wings or two at the tail, windows, a coloured fin."""
    rng = kit.rng
    skin = white_paint(kit) if kit.chance(0.75) else kit.material(pattern=PLAIN, gloss=0.4)
    metal, tail = kit.material(base=np.ones(3) * rng.uniform(0.35, 0.7), pattern=PLAIN, gloss=0.4), kit.material(pattern=rng.choice([PLAIN, STRIPES, BANDS, CLOUDY]), gloss=0.3)
    dark, long, fat = kit.material(dark=True), rng.uniform(2.4, 3.3), rng.uniform(0.27, 0.36)
    z = rng.uniform(0.75, 0.9) if kit.chance(0.6) else 0.0
    fuselage(kit, z, [(-long * 0.55, fat), (long * 0.78, fat), (long * 0.9, fat * 0.75), (long * 0.97, fat * 0.42), (long, fat * 0.1)], skin)
    kit.between((-long * 0.54, 0, z), (-long, 0, z + fat * 0.55), fat, taper=0.22, material=skin)
    kit.add(BOX, (0.1 * long, 0, z + fat * 0.25), (long * 0.62, fat * 0.985, 0.022), material=ports(kit, 30))
    if kit.chance(0.5):
        kit.add(BOX, (0.1 * long, 0, z + fat * 0.02), (long * 0.66, fat * 1.006, 0.02), material=tail)
    kit.add(BOX, (long * 0.88, 0, z + fat * 0.42), (0.06, fat * 0.62, 0.045), (0.7, 0.8), (-0.05, 0), material=glazing(kit))
    for x in (0.74, -0.5):
        kit.add(BOX, (x * long, fat * 0.975, z + 0.02), (0.05, 0.02, 0.11), material=metal, mirror=True)
    span, chord = long * rng.uniform(0.8, 1.0), rng.uniform(0.4, 0.52)
    sweep, lift = span * rng.uniform(0.35, 0.6), rng.uniform(3, 8)
    kit.add(BALL, (0.05, 0, z - fat * 0.7), (long * 0.26, fat * 0.8, fat * 0.42), material=skin)
    root = np.array([0.15, fat * 0.4, z - fat * 0.55])
    panel(kit, root, span, chord, metal, 0.3, sweep, lift, 0.04)
    tip = root + [-sweep, span * np.cos(np.radians(lift)), span * np.sin(np.radians(lift))]
    if kit.chance(0.6):
        panel(kit, tip + [0, -0.02, 0], 0.25, 0.13, tail, 0.5, 0.12, 75, 0.015)
    radius = rng.uniform(0.12, 0.17)
    at_tail = kit.chance(0.2)
    if at_tail:
        nacelle(kit, (-long * 0.62, fat + radius * 0.9, z + fat * 0.45), radius, 0.32, skin, dark)
        kit.add(BOX, (-long * 0.62, fat, z + fat * 0.4), (0.2, 0.12, 0.03), material=skin, mirror=True)
        if kit.chance(0.3):
            nacelle(kit, (-long * 0.72, 0, z + fat * 1.3), radius * 0.9, 0.3, skin, dark, False)
    else:
        for share in (0.34,) if kit.chance(0.65) else (0.32, 0.6):
            on = root + (tip - root) * share
            kit.add(BOX, on + [chord * 0.55, 0, -radius * 0.5], (0.22, 0.02, radius * 0.7), (1, 1), (-0.1, 0), material=metal, mirror=True)
            nacelle(kit, on + [chord * 0.75, 0, -radius * 1.25], radius, 0.26, tail if kit.chance(0.3) else skin, dark)
    fin = rng.uniform(0.75, 1.0)
    panel(kit, (-long * 0.8, 0, z + fat * 0.5), fin, 0.36, tail, 0.45, 0.5, 90, 0.035, False)
    height = z + fat * 0.45 + (fin if at_tail else 0)
    panel(kit, (-long * 0.86 - (0.45 if at_tail else 0), 0, height), span * 0.36, 0.22, metal, 0.45, 0.3, 2 if at_tail else 6, 0.025)
    if z:
        rounds(kit, [(long * 0.72, 0, z - fat * 0.8), (-0.1, fat * 0.75, z - fat * 0.8), (-0.32, fat * 0.75, z - fat * 0.8)], 0.11, metal)
        kit.add(CYL, (long * 0.72, 0, 0.11), (0.11, 0.11, 0.09), rotation=ALONG_Y, material=dark)


def transport(kit):
    """Four propellers or jets under a high wing, fairings for the wheels, an upswept tail with a ramp; a T-tail or a low one."""
    rng = kit.rng
    skin = warpaint(kit) if kit.chance(0.8) else white_paint(kit)
    dark, glass, long, fat = kit.material(dark=True), glazing(kit), rng.uniform(1.9, 2.5), rng.uniform(0.38, 0.46)
    z = fat + rng.uniform(0.2, 0.3)
    fuselage(kit, z, [(-long * 0.4, fat), (long * 0.68, fat), (long * 0.85, fat * 0.8), (long * 0.95, fat * 0.5), (long, fat * 0.15)], skin)
    end = np.array([-long * 1.0, 0, z + fat * 0.75])
    kit.between((-long * 0.38, 0, z), end, fat, taper=0.25, material=skin)
    kit.add(BOX, (-long * 0.58, 0, z - fat * 0.42), (long * 0.2, fat * 0.55, 0.02), rotation=turn("y", 19), material=dark if kit.chance(0.4) else skin)
    kit.add(BOX, (long * 0.83, 0, z + fat * 0.48), (0.13, fat * 0.66, 0.09), (0.7, 0.8), (-0.06, 0), material=glass)
    kit.add(BALL, (0, fat * 0.9, z - fat * 0.62), (long * 0.32, fat * 0.32, fat * 0.36), material=skin, mirror=True)
    jets, tee = kit.chance(0.3), kit.chance(0.5)
    span, chord = long * rng.uniform(0.95, 1.1), rng.uniform(0.34, 0.42)
    sweep = span * (0.4 if jets else rng.uniform(0.02, 0.12))
    top = z + fat * 0.92
    kit.add(BOX, (0.1, 0, top), (chord * 1.2, fat * 0.6, 0.09), (0.9, 0.7), material=skin)
    root = np.array([0.1, 0.1, top + 0.04])
    lift = -3 if jets else 1
    panel(kit, root, span, chord, skin, 0.5, sweep, lift, 0.045)
    for share in (0.33, 0.6) if jets or kit.chance(0.75) else (0.36,):
        at = root + np.array([-sweep, span, np.radians(lift) * span]) * share
        if jets:
            kit.add(BOX, at + [chord * 0.5, 0, -0.08], (0.22, 0.02, 0.09), material=skin, mirror=True)
            nacelle(kit, at + [chord * 0.7, 0, -0.24], 0.15, 0.26, skin, dark)
        else:
            kit.add(CYL, at + [chord * 0.7, 0, -0.04], (0.11, 0.1, chord * 1.0), (0.75, 1), rotation=ALONG_X, material=skin, mirror=True)
            start = len(kit.primitives)
            propeller(kit, at + [chord * 1.7 + 0.03, 0, -0.04], 0.42, ALONG_X, dark, int(rng.choice([3, 4, 4])))
            kit.primitives += [p._replace(centre=p.centre * (1, -1, 1), rotation=np.diag([1.0, -1, 1]) @ p.rotation @ np.diag([1.0, -1, 1])) for p in kit.primitives[start:]]
    fin = rng.uniform(0.8, 1.05)
    panel(kit, (-long * 0.84, 0, z + fat * 0.6), fin, 0.4, skin, 0.6, 0.35, 90, 0.04, False)
    panel(kit, (-long * 0.9 - 0.3 * tee, 0, end[2] + (fin - 0.2 if tee else 0)), span * 0.36, 0.22, skin, 0.5, 0.15 + 0.2 * jets, 0, 0.028)
    rounds(kit, [(long * 0.7, 0, z - fat * 0.8), (0.15, fat * 0.95, z - fat * 0.7), (-0.15, fat * 0.95, z - fat * 0.7)], 0.12, dark)
    roundels(kit, root[0] - sweep * 0.8, span * 0.8, top + 0.07 + np.radians(lift) * span * 0.8, 0.16)
    kit.add(BOX, (long * 0.45, fat * 0.98, z), (0.08, 0.015, 0.16), material=dark, mirror=True)


def flying_wing(kit):
    """Stealth bombers and other aeroplanes of wing alone, with sawtooth edges; unmanned ones too."""
    rng = kit.rng
    skin = kit.material(base=np.ones(3) * rng.uniform(0.03, 0.3), pattern=rng.choice([PLAIN, CLOUDY, SEAMS]), gloss=0.1) if kit.chance(0.7) else kit.material(base=np.ones(3) * rng.uniform(0.4, 0.8), pattern=PLAIN)
    dark, glass, z = kit.material(dark=True), glazing(kit), rng.uniform(0.3, 0.45)
    span, chord = rng.uniform(1.9, 2.6), rng.uniform(0.42, 0.6)
    sweep = span * rng.uniform(0.55, 0.75)
    down = z if kit.chance(0.6) else 0.0
    panel(kit, (0, 0, down), span * 0.45, chord, skin, 0.62, sweep * 0.45, 0, 0.1)
    panel(kit, (-sweep * 0.44, span * 0.44, down), span * 0.56, chord * 0.63, skin, rng.uniform(0.35, 0.75), sweep * 0.56, rng.uniform(0, 3), 0.055, slim=9)
    kit.add(BOX, (chord * 0.62, 0, down), (0.08, chord * 0.85, chord * 0.6), (0.25, 0.06), (0, 0), ALONG_X, skin)
    kit.add(BOX, (-chord * 1.2, 0, down), (0.06, chord * 0.7, chord * 0.5), (0.2, 0.06), rotation=turn("y", -90), material=skin)
    kit.add(BALL, (0.02, 0, down + 0.06), (chord * 1.35, 0.26, 0.2), material=skin)
    kit.add(BALL, (chord * 0.55, 0, down + 0.15), (chord * 0.35, 0.17, 0.11), material=glass if kit.chance(0.8) else skin)
    kit.add(BALL, (-0.1, chord * 0.75, down + 0.06), (chord * 0.75, 0.17, 0.13), material=skin, mirror=True)
    kit.add(BOX, (chord * 0.3, chord * 0.75, down + 0.12), (0.06, 0.12, 0.035), (0.5, 0.9), (-0.05, 0), material=dark, mirror=True)
    kit.add(BOX, (-chord * 0.85, chord * 0.75, down + 0.07), (0.12, 0.1, 0.015), material=dark, mirror=True)
    if kit.chance(0.25):
        panel(kit, (-chord * 0.6, chord * 0.8, down + 0.05), 0.4, 0.2, skin, 0.4, 0.25, 68, 0.02)
    if kit.chance(0.15):
        propeller(kit, (-chord * 1.6, 0, down), 0.4, ALONG_X, dark)
        kit.between((-chord, 0, down), (-chord * 1.6, 0, down), 0.05, material=dark)
    if down:
        rounds(kit, [(chord * 0.8, 0, down - 0.02), (-chord * 0.5, chord * 0.75, down - 0.02)], 0.1, dark)
        kit.add(BOX, (-chord * 0.3, chord * 0.9, down - 0.12), (0.16, 0.01, 0.06), material=skin, mirror=True)


def jet_body(kit, z, long, fat, skin, glass):
    """A fighter's body: pointed nose, cockpit, spine, flat belly."""
    fuselage(kit, z, [(-long * 0.9, fat * 0.75), (-long * 0.5, fat), (long * 0.3, fat * 0.95), (long * 0.62, fat * 0.72), (long * 0.85, fat * 0.36), (long, fat * 0.03)], skin, kit.rng.uniform(1.0, 1.25))
    kit.add(BALL, (long * 0.45, 0, z + fat * 0.75), (long * 0.2, fat * 0.5, fat * 0.62), material=glass)
    kit.add(BOX, (-long * 0.02, 0, z + fat * 0.85), (long * 0.38, fat * 0.35, fat * 0.3), (0.8, 0.6), (-0.05, 0), material=skin)
    kit.between((long * 0.97, 0, z), (long * 1.12, 0, z), 0.012, material=skin)


def stores(kit, x, ys, z, paint):
    """Missiles, bombs or tanks on pylons below a wing."""
    for y in ys:
        size = kit.rng.uniform(0.035, 0.08)
        kit.add(BOX, (x, y, z - 0.05), (0.13, 0.015, 0.06), material=paint, mirror=True)
        kit.add(CYL, (x + 0.05, y, z - 0.1 - size), (size, size, 0.32), (0.35, 1), rotation=ALONG_X, material=kit.material(base=np.ones(3) * kit.rng.uniform(0.15, 0.8), pattern=BANDS, frequency=6), mirror=True)


def canard_delta(kit):
    """Delta fighters with canards, one or two engines, intakes below or beside."""
    rng = kit.rng
    skin, dark, glass = warpaint(kit), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(1.8, 2.2), rng.uniform(0.2, 0.26)
    z = rng.uniform(0.6, 0.75) if kit.chance(0.6) else 0.0
    jet_body(kit, z, long, fat, skin, glass)
    span, chord = rng.uniform(0.85, 1.15), rng.uniform(0.75, 0.95)
    panel(kit, (-long * 0.3, fat * 0.5, z - fat * 0.3), span, chord, skin, 0.18, chord * 0.72, rng.uniform(-2, 2), 0.035)
    panel(kit, (long * 0.32, fat * 0.6, z + fat * 0.35), rng.uniform(0.35, 0.5), 0.2, skin, 0.3, 0.2, rng.uniform(-8, 8), 0.02)
    twin = kit.chance(0.5)
    if kit.chance(0.5):
        kit.add(BOX, (long * 0.08, 0, z - fat * 1.0), (long * 0.3, fat * 0.8, fat * 0.4), (0.9, 0.95), material=skin)
        kit.add(BOX, (long * 0.38, 0, z - fat * 1.02), (0.02, fat * 0.7, fat * 0.3), material=dark)
    else:
        kit.add(BOX, (-long * 0.1, fat * 1.1, z - fat * 0.1), (long * 0.38, fat * 0.4, fat * 0.6), (0.9, 0.9), material=skin, mirror=True)
        kit.add(BOX, (long * 0.28, fat * 1.12, z - fat * 0.1), (0.015, fat * 0.3, fat * 0.48), material=dark, mirror=True)
    if twin:
        kit.add(CYL, (-long * 0.85, fat * 0.55, z), (fat * 0.6, fat * 0.6, long * 0.16), (0.85, 1), rotation=turn("y", -90), material=dark, mirror=True)
    else:
        kit.add(CYL, (-long * 0.95, 0, z), (fat * 0.75, fat * 0.75, long * 0.08), (0.85, 1), rotation=turn("y", -90), material=dark)
    panel(kit, (-long * 0.6, 0, z + fat * 0.6), rng.uniform(0.6, 0.75), 0.42, skin, 0.35, 0.45, 90, 0.03, False)
    stores(kit, -long * 0.35, np.sort(rng.uniform(0.45, 0.85, int(rng.integers(0, 4)))) * span, z - fat * 0.3, skin)
    roundels(kit, -long * 0.5, fat + span * 0.5, z - fat * 0.3 + 0.035, 0.11)
    if z:
        rounds(kit, [(long * 0.35, 0, z - fat * 0.8), (-long * 0.3, fat * 1.3, z - fat * 0.5)], 0.11, skin)


def swing_wing(kit):
    """Swing-wing strike aircraft and bombers, swept or spread; the glove, big intakes, one or two fins."""
    rng = kit.rng
    skin, dark, glass = warpaint(kit), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(2.0, 2.5), rng.uniform(0.23, 0.3)
    z = rng.uniform(0.65, 0.8) if kit.chance(0.6) else 0.0
    jet_body(kit, z, long, fat, skin, glass)
    kit.add(BOX, (-long * 0.1, fat * 1.15, z - fat * 0.1), (long * 0.42, fat * 0.5, fat * 0.65), (0.9, 0.85), material=skin, mirror=True)
    kit.add(BOX, (long * 0.32, fat * 1.15, z - fat * 0.1), (0.015, fat * 0.4, fat * 0.52), material=dark, mirror=True)
    high = z + fat * 0.45
    panel(kit, (long * 0.02, fat * 0.5, high), 0.55, 0.75, skin, 0.5, 0.35, 0, 0.06)
    angle = rng.choice([rng.uniform(10, 25), rng.uniform(45, 68)])
    out, reach = turn("z", angle), rng.uniform(1.3, 1.7)
    root = np.array([-long * 0.1, fat * 0.5 + 0.42, high])
    way = out @ np.array([0, 1.0, 0])
    kit.add(BOX, root + way * reach / 2, (0.26, 0.03, reach / 2), (0.5, 0.6), (0.02, 0), out @ turn("x", -90), skin, True)
    kit.add(CYL, (-long * 0.82, fat * 0.95, z - fat * 0.05), (fat * 0.62, fat * 0.62, long * 0.2), (0.85, 1), rotation=turn("y", -90), material=skin, mirror=True)
    kit.add(CYL, (-long * 1.03, fat * 0.95, z - fat * 0.05), (fat * 0.5, fat * 0.5, 0.03), rotation=ALONG_X, material=dark, mirror=True)
    if kit.chance(0.5):
        panel(kit, (-long * 0.72, fat * 0.95, z + fat * 0.4), 0.65, 0.34, skin, 0.45, 0.35, 84, 0.025)
    else:
        panel(kit, (-long * 0.7, 0, z + fat * 0.6), 0.8, 0.46, skin, 0.35, 0.5, 90, 0.035, False)
    panel(kit, (-long * 0.88, fat * 1.0, z), rng.uniform(0.6, 0.8), 0.32, skin, 0.4, 0.42, -2, 0.025)
    stores(kit, 0, rng.uniform(0.42, 0.5, int(rng.integers(0, 2))) + fat * 0.4, high, skin)
    if z:
        rounds(kit, [(long * 0.4, 0, z - fat * 0.8), (-long * 0.2, fat * 1.2, z - fat * 0.6)], 0.13, skin)


def spinner(kit, at, radius, reach, paint, dark, blades=None):
    """A pointed boss with a propeller around it."""
    kit.add(CYL, np.array(at, float) + [radius * 0.8, 0, 0], (radius, radius, radius), (0.15, 1), rotation=ALONG_X, material=paint)
    propeller(kit, at, reach, ALONG_X, dark, blades or int(kit.rng.choice([2, 3, 3, 4])))


def old_fighter(kit):
    """Fighters of the 1940s: a low wing, a bubble or framed canopy, a round radial or a pointed inline nose, a tail wheel."""
    rng = kit.rng
    skin, dark, glass = warpaint(kit), kit.material(dark=True), glazing(kit)
    trim = kit.material(base=rng.choice([[0.6, 0.03, 0.03], [0.7, 0.5, 0.03], [0.75] * 3, [0.03, 0.08, 0.3]]), pattern=PLAIN)
    long, fat = rng.uniform(1.4, 1.7), rng.uniform(0.2, 0.26)
    down = kit.chance(0.65)
    tilt = turn("y", -rng.uniform(8, 12)) if down else np.eye(3)
    z = fat * 1.6 + 0.3
    start = len(kit.primitives)
    radial = kit.chance(0.5)
    if radial:
        fuselage(kit, z, [(-long, fat * 0.25), (-long * 0.2, fat * 0.95), (long * 0.45, fat), (long * 0.48, fat * 1.15), (long * 0.78, fat * 1.15), (long * 0.84, fat * 0.95)], skin, 0.92)
        kit.add(CYL, (long * 0.845, 0, z), (fat * 0.8, fat * 0.76, 0.012), rotation=ALONG_X, material=dark)
        kit.add(BALL, (long * 0.84, 0, z), (0.08, fat * 0.3, fat * 0.3), material=dark)
        spinner(kit, (long * 0.92, 0, z), fat * 0.25, 0.62, trim, dark)
        kit.add(CYL, (long * 0.62, 0, z), (fat * 1.165, fat * 1.075, 0.05), rotation=ALONG_X, material=trim)
    else:
        fuselage(kit, z, [(-long, fat * 0.22), (-long * 0.2, fat * 0.92), (long * 0.3, fat), (long * 0.9, fat * 0.68)], skin, 0.8)
        spinner(kit, (long * 0.93, 0, z), fat * 0.62, 0.66, trim, dark)
        kit.add(BOX, (rng.uniform(-0.1, 0.6) * long, 0, z - fat * 0.95), (0.25, fat * 0.45, fat * 0.28), (1.2, 0.9), material=skin)
        for k in range(3):
            kit.add(CYL, (long * (0.5 + 0.1 * k), fat * 0.62, z + fat * 0.35), (0.025, 0.025, 0.05), rotation=ALONG_X, material=dark, mirror=True)
    if kit.chance(0.55):
        kit.add(BALL, (long * 0.02, 0, z + fat * 0.85), (0.36, fat * 0.55, fat * 0.7), material=glass)
    else:
        kit.add(BOX, (long * 0.02, 0, z + fat * 1.1), (0.3, fat * 0.5, fat * 0.38), (0.75, 0.6), material=glass)
        kit.add(BOX, (-long * 0.38, 0, z + fat * 0.85), (0.36, fat * 0.5, fat * 0.35), (0.6, 0.6), (0.16, 0), material=skin)
        kit.add(BOX, (long * 0.02, 0, z + fat * 1.1), (0.02, fat * 0.52, fat * 0.4), (1, 0.62), material=skin)
    span, chord, lift = rng.uniform(1.35, 1.6), rng.uniform(0.33, 0.4), rng.uniform(3, 7)
    root = np.array([long * 0.18, fat * 0.3, z - fat * 0.62])
    panel(kit, root, span * 0.75, chord, skin, 0.75, 0.05, lift, 0.05)
    panel(kit, root + [-0.05, span * 0.74 * np.cos(np.radians(lift)), span * 0.74 * np.sin(np.radians(lift))], span * 0.27, chord * 0.75, skin, rng.uniform(0.3, 0.8), 0.04, lift, 0.03)
    panel(kit, (-long * 0.88, 0, z + fat * 0.15), rng.uniform(0.5, 0.6), 0.18, skin, 0.65, 0.04, 2, 0.025)
    panel(kit, (-long * 0.86, 0, z), rng.uniform(0.5, 0.6), 0.22, trim if kit.chance(0.3) else skin, 0.55, 0.1, 90, 0.025, False)
    roundels(kit, root[0] - 0.04, span * 0.7, root[2] + np.sin(np.radians(lift)) * span * 0.62 + 0.055, 0.15)
    kit.add(CYL, (-long * 0.42, 0, z), (fat * 0.78, fat * 0.68, 0.05), (0.93, 1), rotation=turn("y", -90), material=trim)
    for y in rng.uniform(0.5, 0.8, int(rng.integers(0, 3))):
        kit.between((root[0] + 0.25, y, root[2] + 0.05), (root[0] + 0.52, y, root[2] + 0.05), 0.018, material=dark, mirror=True)
    if kit.chance(0.3):
        kit.add(BALL, (long * 0.15, 0, z - fat * 1.25), (0.35, 0.1, 0.1), material=kit.material(base=np.ones(3) * 0.5))
    if down:
        y = rng.uniform(0.45, 0.6)
        kit.between((root[0] + 0.1, y, root[2]), (root[0] + 0.25, y, 0.14), 0.03, material=dark, mirror=True)
        kit.add(CYL, (root[0] + 0.25, y, 0.14), (0.15, 0.15, 0.05), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(BOX, (root[0] + 0.17, y + 0.07, 0.3), (0.1, 0.012, 0.16), material=skin, mirror=True)
        kit.between((-long * 0.8, 0, z), (-long * 0.86, 0, z - fat - 0.06), 0.025, material=dark)
        kit.add(CYL, (-long * 0.87, 0, z - fat - 0.08), (0.07, 0.07, 0.03), rotation=ALONG_Y, material=dark)
    kit.primitives[start:] = [p._replace(centre=tilt @ p.centre, rotation=tilt @ p.rotation) for p in kit.primitives[start:]]


def old_bomber(kit):
    """Bombers of the 1940s: two or four engines on the wing, a glazed nose, turrets, twin fins or one."""
    rng = kit.rng
    skin, dark, glass = warpaint(kit), kit.material(dark=True), kit.material(base=[0.1, 0.13, 0.15], second=[0.3] * 3, pattern=CHECKER, frequency=20, gloss=0.5)
    long, fat = rng.uniform(1.7, 2.2), rng.uniform(0.23, 0.3)
    z = fat + rng.uniform(0.34, 0.44)
    fuselage(kit, z, [(-long, fat * 0.3), (-long * 0.3, fat * 0.85), (long * 0.1, fat), (long * 0.75, fat * 0.9)], skin, rng.uniform(0.75, 0.95))
    kit.add(BALL, (long * 0.75, 0, z), (rng.uniform(0.25, 0.4), fat * 0.76, fat * 0.88), material=glass)
    kit.add(BOX, (long * 0.48, 0, z + fat * 0.95), (0.3, fat * 0.5, fat * 0.3), (0.7, 0.75), (-0.05, 0), material=glass)
    span, chord, lift = long * rng.uniform(0.95, 1.15), rng.uniform(0.36, 0.44), rng.uniform(2, 6)
    root = np.array([0.15, fat * 0.2, z + fat * rng.choice([-0.45, 0.1, 0.5])])
    panel(kit, root, span, chord, skin, 0.4, 0.08, lift, 0.06)
    for share in (0.3,) if kit.chance(0.65) else (0.27, 0.52):
        at = root + np.array([0, span, span * np.sin(np.radians(lift))]) * share
        kit.add(CYL, at + [chord * 0.65, 0, 0], (0.15, 0.15, chord * 0.6), rotation=ALONG_X, material=skin, mirror=True)
        kit.add(CYL, at + [-chord * 0.6, 0, -0.02], (0.15, 0.14, chord * 0.75), (0.25, 1), rotation=turn("y", -90), material=skin, mirror=True)
        kit.add(CYL, at + [chord * 1.25, 0, 0], (0.12, 0.12, 0.015), rotation=ALONG_X, material=dark, mirror=True)
        first = len(kit.primitives)
        propeller(kit, at + [chord * 1.35, 0, 0], 0.42, ALONG_X, dark, 3)
        kit.primitives += [p._replace(centre=p.centre * (1, -1, 1), rotation=np.diag([1.0, -1, 1]) @ p.rotation @ np.diag([1.0, -1, 1])) for p in kit.primitives[first:]]
        if share < 0.31:
            kit.between(at + [0.1, 0, 0], (at[0] + 0.14, at[1], 0.16), 0.04, material=dark, mirror=True)
            kit.add(CYL, (at[0] + 0.14, at[1], 0.17), (0.17, 0.17, 0.06), rotation=ALONG_Y, material=dark, mirror=True)
    tail = rng.uniform(0.65, 0.85)
    panel(kit, (-long * 0.9, 0, z + fat * 0.25), tail, 0.22, skin, 0.75, 0.03, 3, 0.03)
    if kit.chance(0.6):
        kit.add(CYL, (-long * 0.92, tail * 0.95, z + fat * 0.35), (0.24, 0.36, 0.025), rotation=ALONG_Y, material=skin, mirror=True)
    else:
        panel(kit, (-long * 0.86, 0, z), 0.85, 0.32, skin, 0.5, 0.2, 90, 0.035, False)
    kit.add(BALL, (-long * rng.uniform(0.1, 0.3), 0, z + fat * 0.85), (0.15, 0.14, 0.15), material=glass)
    kit.between((-long * 0.25, 0, z + fat), (-long * 0.45, 0, z + fat * 1.15), 0.014, material=dark)
    kit.add(BALL, (-long * 1.0, 0, z), (0.14, fat * 0.35, fat * 0.38), material=glass)
    kit.between((-long, 0, z), (-long * 1.15, 0, z), 0.014, material=dark)
    roundels(kit, root[0] - 0.07, span * 0.78, root[2] + np.sin(np.radians(lift)) * span * 0.78 + 0.04, 0.15)
    kit.between((-long * 0.7, 0, z - fat * 0.3), (-long * 0.72, 0, 0.3), 0.03, material=dark)
    kit.add(CYL, (-long * 0.73, 0, 0.26), (0.09, 0.09, 0.035), rotation=ALONG_Y, material=dark)


def seaplane(kit):
    """Floatplanes and flying boats with stepped hulls, wing floats and engines above the wing."""
    rng = kit.rng
    skin, trim, dark, glass = (white_paint(kit) if kit.chance(0.5) else kit.material(pattern=PLAIN, gloss=0.4)), kit.material(pattern=PLAIN), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(1.4, 1.8), rng.uniform(0.24, 0.3)
    span, chord = long * rng.uniform(1.0, 1.2), rng.uniform(0.3, 0.36)
    if kit.chance(0.5):
        z = rng.uniform(0.75, 0.9)
        fuselage(kit, z, [(-long, fat * 0.25), (-long * 0.15, fat * 0.95), (long * 0.5, fat), (long * 0.85, fat * 0.75)], skin, 0.9)
        spinner(kit, (long * 0.9, 0, z), fat * 0.35, 0.5, trim, dark)
        kit.add(BOX, (long * 0.22, 0, z + fat * 0.85), (0.4, fat * 0.75, fat * 0.45), (0.7, 0.8), (-0.06, 0), material=glass)
        kit.add(BOX, (long * 0.0, 0, z + fat * 0.05), (long * 0.6, fat * 0.92, 0.025), material=trim)
        high = z + fat * rng.choice([1.25, 1.25, -0.5])
        panel(kit, (long * 0.18, 0, high), span, chord, skin, rng.uniform(0.6, 1), 0.02, 2, 0.045)
        if high > z:
            kit.between((long * 0.18, fat * 0.8, z - fat * 0.5), (long * 0.18, span * 0.5, high), 0.025, material=trim, mirror=True)
        y, deep = rng.uniform(0.42, 0.55), rng.uniform(0.13, 0.17)
        kit.add(BOX, (-long * 0.1, y, deep), (long * 0.55, deep * 0.8, deep), (1, 1.05), material=trim if kit.chance(0.4) else skin, mirror=True)
        kit.add(BOX, (long * 0.68, y, deep * 1.1), (deep * 0.9, deep * 0.8, long * 0.26), (0.35, 0.4), (-deep * 0.6, 0), ALONG_X, trim, True)
        kit.add(BOX, (-long * 0.8, y, deep * 1.2), (deep * 0.8, deep * 0.75, long * 0.18), (0.4, 0.4), (deep * 0.5, 0), turn("y", -90), trim, True)
        for x in (-0.2, 0.4):
            kit.between((x * long, fat * 0.5, z - fat * 0.6), (x * long, y, deep * 1.9), 0.025, material=dark, mirror=True)
            kit.between((x * long, -y, deep * 1.7), (x * long, y, deep * 1.7), 0.02, material=dark)
        kit.between((-0.2 * long, y, deep * 1.9), (0.35 * long, fat * 0.5, z - fat * 0.6), 0.018, material=dark, mirror=True)
    else:
        z = fat * 1.1
        fuselage(kit, z + fat * 0.2, [(-long * 0.3, fat * 0.95), (long * 0.6, fat), (long * 0.85, fat * 0.7), (long * 0.98, fat * 0.3)], skin, 0.9)
        kit.between((-long * 0.28, 0, z + fat * 0.2), (-long, 0, z + fat * 1.1), fat * 0.95, taper=0.25, material=skin)
        kit.add(BOX, (long * 0.2, 0, fat * 0.5), (long * 0.42, fat * 0.45, fat * 0.5), (1, 2), material=trim)
        kit.add(BOX, (long * 0.75, 0, fat * 0.65), (fat * 0.5, fat * 0.75, long * 0.2), (0.35, 0.2), (-fat * 0.5, 0), ALONG_X, trim)
        kit.add(BOX, (long * 0.62, 0, z + fat * 1.0), (0.2, fat * 0.6, fat * 0.32), (0.65, 0.75), (-0.05, 0), material=glass)
        kit.add(BOX, (0.05, 0, z + fat * 0.5), (long * 0.3, fat * 0.88, 0.05), material=ports(kit, 12))
        high = z + fat * rng.uniform(1.35, 1.8)
        kit.add(BOX, (0.1, 0, (z + fat + high) / 2), (chord * 0.7, fat * 0.35, (high - z - fat) / 2 + 0.08), material=skin)
        panel(kit, (0.1, 0, high), span, chord, skin, 0.65, 0.03, 1, 0.05)
        for y in (0,) if kit.chance(0.25) else (-0.5, 0.5):
            at = np.array([0.2, y, high + (0.24 if y == 0 else 0.02)])
            kit.add(CYL, at, (0.15, 0.15, 0.4), (0.7, 1), rotation=turn("y", -90), material=trim)
            if y == 0:
                kit.between((0.1, 0, high), at, 0.05, material=skin)
            propeller(kit, at + [0.44, 0, 0], 0.4, ALONG_X, dark, 3)
        y = span * rng.uniform(0.65, 0.85)
        kit.add(BALL, (0.12, y, fat * 0.55), (0.34, 0.1, 0.11), material=trim, mirror=True)
        kit.between((0.1, y, fat * 0.6), (0.1, y, high), 0.025, material=dark, mirror=True)
        z += fat * 0.6
    panel(kit, (-long * 0.86, 0, z + fat * 0.2), rng.uniform(0.5, 0.65), 0.2, skin, 0.7, 0.03, 0, 0.025)
    panel(kit, (-long * 0.82, 0, z), rng.uniform(0.6, 0.75), 0.26, trim, 0.55, 0.16, 90, 0.03, False)


def glider(kit):
    """Sailplanes: long slender wings, a long canopy, a T-tail; motor gliders."""
    rng = kit.rng
    skin, trim, dark = white_paint(kit), kit.material(base=paint(rng.choice([0, 0.6, 0.05]), 0.9, 0.5), pattern=PLAIN), kit.material(dark=True)
    long, fat, z = rng.uniform(1.2, 1.5), rng.uniform(0.15, 0.19), 0.32
    fuselage(kit, z, [(-long, fat * 0.28), (-long * 0.25, fat * 0.4), (long * 0.15, fat * 0.95), (long * 0.5, fat), (long * 0.82, fat * 0.62), (long * 0.97, fat * 0.1)], skin, 0.85)
    kit.add(BALL, (long * 0.5, 0, z + fat * 0.5), (long * 0.34, fat * 0.68, fat * 0.75), material=glazing(kit))
    span, chord, lift = rng.uniform(2.2, 3.2), rng.uniform(0.15, 0.2), rng.uniform(2, 5)
    root = np.array([long * 0.12, 0, z + fat * 0.5])
    panel(kit, root, span * 0.65, chord, skin, 0.8, 0.02, lift, 0.022)
    at = root + np.array([-0.02, np.cos(np.radians(lift)), np.sin(np.radians(lift))]) * [1, span * 0.65, span * 0.65]
    panel(kit, at, span * 0.35, chord * 0.8, trim if kit.chance(0.3) else skin, 0.4, 0.06, lift + 1, 0.015)
    tip = at + [-0.06, span * 0.35, span * 0.35 * np.sin(np.radians(lift + 1))]
    if kit.chance(0.5):
        panel(kit, tip, 0.16, 0.06, trim, 0.5, 0.05, 75, 0.008)
    fin = rng.uniform(0.4, 0.5)
    panel(kit, (-long * 0.93, 0, z), fin, 0.15, trim if kit.chance(0.5) else skin, 0.75, 0.08, 90, 0.018, False)
    panel(kit, (-long * 0.98, 0, z + fin * (0.97 if kit.chance(0.7) else 0.3)), 0.4, 0.1, skin, 0.6, 0.04, 0, 0.012)
    kit.between((long * 0.25, 0, z - fat * 0.5), (long * 0.22, 0, 0.1), 0.03, material=dark)
    kit.add(CYL, (long * 0.22, 0, 0.1), (0.1, 0.1, 0.035), rotation=ALONG_Y, material=dark)
    kit.add(CYL, (-long * 0.93, 0, z - 0.09), (0.05, 0.05, 0.02), rotation=ALONG_Y, material=dark)
    kit.add(BOX, (long * 0.2, 0, z), (long * 0.55, fat * 0.75, 0.012), material=trim)
    if kit.chance(0.2):
        kit.between((-long * 0.02, 0, z + fat * 0.3), (-long * 0.05, 0, z + 0.55), 0.03, material=dark)
        propeller(kit, (-long * 0.05, 0, z + 0.55), 0.35, ALONG_X, dark, 2)


def ultralight(kit):
    """Trikes under a cloth wing and open-framed aeroplanes with a high wing, the pilot in the open."""
    rng = kit.rng
    cloth = kit.material(pattern=rng.choice([PLAIN, STRIPES, SEAMS]), frequency=rng.uniform(2, 5), gloss=0.1)
    tip, tube, dark = kit.material(), kit.material(base=np.ones(3) * rng.uniform(0.1, 0.7), pattern=PLAIN, gloss=0.4), kit.material(dark=True)
    kit.add(BALL, (0.55, 0, 0.42), (0.55, 0.22, 0.2), material=tip)
    kit.between((-0.5, 0, 0.35), (1.0, 0, 0.35), 0.035, material=tube)
    rounds(kit, [(0.95, 0, 0.35), (-0.35, 0.6, 0.36)], 0.15, tube)
    kit.between((-0.35, 0, 0.36), (-0.35, 0.55, 0.3), 0.025, material=tube, mirror=True)
    kit.add(BOX, (-0.1, 0, 0.55), (0.06, 0.2, 0.22), (1, 0.9), (-0.1, 0), material=dark)
    crew(kit, (0.1, 0, 0.55), (0.38, 0.2, 0.25), (0.72, 0.12, -0.05), 0.85, -0.15)
    high = rng.uniform(1.45, 1.75)
    kit.add(BOX, (-0.5, 0, 0.68), (0.2, 0.16, 0.13), material=dark)
    propeller(kit, (-0.76, 0, 0.72), 0.5, ALONG_X, dark, int(rng.choice([2, 3])))
    kit.between((-0.5, 0, 0.35), (-0.35, 0, high), 0.03, material=tube)
    span, chord = rng.uniform(1.7, 2.1), rng.uniform(0.42, 0.55)
    if kit.chance(0.55):
        panel(kit, (-0.05, 0, high + 0.04), span, chord * 1.25, cloth, 0.3, span * 0.42, -1, 0.02)
        panel(kit, (-0.05 - span * 0.4, span * 0.93, high), span * 0.1, chord * 0.45, tip, 0.4, 0.1, -1, 0.018)
        kit.between((-0.3, 0, high), (-0.3, 0, high + 0.4), 0.02, material=tube)
        for x in (0.4, -0.9):
            kit.between((-0.3, 0, high + 0.4), (x, 0, high + 0.05), 0.008, material=dark)
        kit.between((-0.3, 0, high + 0.4), (-0.5, span * 0.7, high), 0.008, material=dark, mirror=True)
        bar = np.array([0.5, 0, 0.95])
        kit.between(bar + [0, -0.5, 0], bar + [0, 0.5, 0], 0.02, material=tube)
        kit.between(bar + [0, 0.5, 0], (-0.3, 0.05, high), 0.018, material=tube, mirror=True)
        kit.between(bar + [0, 0.5, 0], (-0.5, span * 0.7, high - 0.02), 0.008, material=dark, mirror=True)
    else:
        panel(kit, (-0.1, 0, high), span, chord, cloth, rng.uniform(0.8, 1), 0.03, 2, 0.035)
        kit.between((0.4, 0, 0.35), (0.15, 0, high), 0.03, material=tube)
        kit.between((0.0, 0.05, 0.37), (-0.05, span * 0.6, high + 0.05), 0.022, material=tube, mirror=True)
        tail = np.array([-2.0, 0, high - 0.15])
        kit.between((-0.2, 0, high - 0.05), tail, 0.04, material=tube)
        kit.between((-0.45, 0, 0.4), tail + [0.6, 0, 0], 0.02, material=tube)
        panel(kit, tail, 0.65, 0.28, cloth, 0.8, 0.03, 0, 0.02)
        panel(kit, tail - [0.02, 0, 0.1], 0.6, 0.26, tip, 0.6, 0.12, 90, 0.02, False)


def tiltrotor(kit):
    """Tiltrotors with the nacelles up, forward or between; a high wing, twin fins or a T-tail."""
    rng = kit.rng
    skin, dark, glass = warpaint(kit) if kit.chance(0.65) else white_paint(kit), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(1.4, 1.7), rng.uniform(0.34, 0.4)
    z = fat + 0.28
    kit.add(BOX, (0, 0, z), (long * 0.6, fat * 0.85, fat), (1, 0.8), material=skin)
    kit.add(BALL, (long * 0.58, 0, z - fat * 0.08), (long * 0.4, fat * 0.82, fat * 0.88), material=skin)
    kit.add(BALL, (long * 0.66, 0, z + fat * 0.22), (long * 0.27, fat * 0.72, fat * 0.6), material=glass)
    kit.add(BOX, (-long * 0.82, 0, z + fat * 0.12), (fat * 0.85, fat * 0.8, long * 0.25), (0.35, 0.5), (fat * 0.5, 0), turn("y", -90), skin)
    kit.add(BOX, (-0.1, fat * 0.95, z - fat * 0.6), (0.5, fat * 0.3, fat * 0.35), (0.8, 0.8), material=skin, mirror=True)
    kit.add(BOX, (0.0, 0, z + fat * 0.25), (long * 0.45, fat * 0.86, 0.07), material=ports(kit, 8))
    high, span = z + fat * 1.1, rng.uniform(1.25, 1.5)
    kit.add(BOX, (0, 0, high - 0.05), (0.45, fat * 0.6, 0.12), (0.8, 0.8), material=skin)
    panel(kit, (0, 0, high), span, 0.3, skin, 0.9, -0.1, 2, 0.07)
    tilt = turn("y", rng.choice([0.0, 0.0, 90.0, rng.uniform(20, 75)]))
    for y in (-1, 1):
        pod = np.array([0.1, y * span, high + 0.05])
        kit.add(CYL, pod + tilt @ np.array([0, 0, 0.08]), (0.17, 0.16, 0.42), (0.75, 1), rotation=tilt, material=skin)
        hub = pod + tilt @ np.array([0, 0, 0.58])
        kit.add(CYL, hub, (0.12, 0.12, 0.12), (0.3, 1), rotation=tilt, material=dark)
        first, reach = rng.uniform(0, 120), span * rng.uniform(0.7, 0.85)
        for k in range(3):
            way = tilt @ turn("z", first + 120 * k)
            kit.add(BOX, hub + way @ np.array([reach / 2, 0, 0]), (reach / 2, 0.075, 0.014), rotation=way @ turn("x", 12), material=dark)
    tail = np.array([-long * 1.0, 0, z + fat * 0.45])
    kit.add(BOX, tail, (0.2, 0.72, 0.03), material=skin)
    kit.add(BOX, tail + [-0.02, 0.72, 0.05], (0.25, 0.03, 0.42), (0.65, 1), (-0.1, 0), material=skin, mirror=True)
    rounds(kit, [(long * 0.6, 0, z - fat * 0.7), (-0.15, fat * 1.0, z - fat * 0.7)], 0.13, dark)
    kit.add(BOX, (-long * 0.78, 0, z - fat * 0.38), (0.3, fat * 0.5, 0.02), rotation=turn("y", 28), material=dark)


def tandem(kit):
    """Helicopters with a rotor at either end: long boxes with pods along the belly, or round and bent like a banana."""
    rng = kit.rng
    skin, dark, glass = coat(kit) if kit.chance(0.7) else kit.material(pattern=PLAIN, gloss=0.3), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(1.7, 2.2), rng.uniform(0.38, 0.46)
    z = fat + 0.3
    kit.add(BOX, (0, 0, z), (long * 0.75, fat, fat), (1, 0.85), material=skin)
    kit.add(BALL, (long * 0.74, 0, z - fat * 0.05), (0.55, fat * 0.95, fat * 0.92), material=skin)
    kit.add(BALL, (long * 0.8, 0, z + fat * 0.2), (0.47, fat * 0.84, fat * 0.62), material=glass)
    kit.add(BOX, (-long * 0.88, 0, z + fat * 0.1), (fat * 0.9, fat * 0.95, long * 0.16), (0.6, 0.8), (fat * 0.32, 0), turn("y", -90), skin)
    kit.add(BOX, (-long * 0.1, fat * 1.05, z - fat * 0.65), (long * 0.55, fat * 0.25, fat * 0.35), (0.9, 0.7), material=skin, mirror=True)
    for k in range(int(rng.integers(3, 6))):
        kit.add(CYL, (long * (0.5 - 0.25 * k), fat * 0.93, z + fat * 0.3), (0.09, 0.09, 0.03), rotation=ALONG_Y, material=glass, mirror=True)
    front, rear = np.array([long * 0.62, 0, z + fat * 1.75]), np.array([-long * 0.82, 0, z + fat * rng.uniform(2.6, 3.1)])
    kit.add(BOX, (front[0], 0, z + fat * 1.25), (0.42, fat * 0.5, fat * 0.4), (0.6, 0.6), material=skin)
    kit.add(BOX, (rear[0], 0, (z + fat * 0.8 + rear[2]) / 2 - 0.08), (0.5, fat * 0.42, (rear[2] - z - fat * 0.8) / 2), (0.65, 0.6), (-0.08, 0), material=skin)
    kit.add(CYL, (rear[0], fat * 0.62, z + fat * 1.15), (0.17, 0.17, 0.36), (0.85, 1), rotation=turn("y", -90), material=dark if kit.chance(0.5) else skin, mirror=True)
    kit.between((front[0], 0, z + fat * 1.05), (rear[0], 0, z + fat * 1.1), (0.1, fat * 0.3), BOX, material=skin)
    blades, reach = int(rng.choice([2, 3, 3])), long * rng.uniform(0.85, 1.0)
    rotor(kit, front, reach, blades, dark)
    rotor(kit, rear, reach, blades, dark)
    rounds(kit, [(long * 0.45, fat * 1.0, z - fat * 0.7), (-long * 0.55, fat * 1.0, z - fat * 0.7)], 0.15, dark)
    if kit.chance(0.5):
        kit.add(BOX, (-long * 1.02, 0, z - fat * 0.15), (0.03, fat * 0.7, fat * 0.4), rotation=turn("y", 15), material=dark)
    if kit.chance(0.3):
        drop = rng.uniform(0.5, 0.8)
        for p in kit.primitives:
            p.centre[2] += drop
        kit.between((0, 0, drop), (0, 0, z + drop - fat), 0.015, material=dark)
        kit.add(BOX, (0, 0, drop * 0.5), (drop * 0.8, drop * 0.5, drop * 0.5), material=coat(kit))


def coaxial(kit):
    """Helicopters with two rotors on one mast, a short tail and two fins."""
    rng = kit.rng
    skin, dark, glass = coat(kit) if kit.chance(0.5) else kit.material(pattern=PLAIN, gloss=0.3), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(0.8, 1.1), rng.uniform(0.42, 0.52)
    z = fat + 0.35
    kit.add(BOX, (0, 0, z), (long * 0.75, fat * 0.85, fat), (0.9, 0.85), material=skin)
    kit.add(BALL, (long * 0.68, 0, z - fat * 0.1), (long * 0.48, fat * 0.82, fat * 0.88), material=skin)
    kit.add(BALL, (long * 0.76, 0, z + fat * 0.12), (long * 0.38, fat * 0.74, fat * 0.66), material=glass)
    kit.add(BOX, (-0.1, 0, z + fat * 1.2), (long * 0.6, fat * 0.55, fat * 0.3), (0.75, 0.7), material=skin)
    kit.add(CYL, (long * 0.25, fat * 0.4, z + fat * 1.2), (0.15, 0.15, 0.35), rotation=ALONG_X, material=dark, mirror=True)
    hub = np.array([0, 0, z + fat * 1.5])
    gap, reach, blades = rng.uniform(0.3, 0.42), rng.uniform(1.5, 2.0), int(rng.choice([2, 3, 3]))
    kit.between(hub - [0, 0, 0.1], hub + [0, 0, 0.25 + gap], 0.06, material=dark)
    rotor(kit, hub + [0, 0, 0.12], reach, blades, dark)
    rotor(kit, hub + [0, 0, 0.12 + gap], reach, blades, dark)
    tail = np.array([-long - rng.uniform(0.7, 1.0), 0, z + fat * 0.45])
    kit.between((-long * 0.7, 0, z + fat * 0.3), tail, (fat * 0.5, fat * 0.5), BOX if kit.chance(0.5) else CYL, 0.5, material=skin)
    kit.add(BOX, tail + [0.05, 0, 0.02], (0.18, 0.62, 0.025), material=skin)
    kit.add(BOX, tail + [0.0, 0.62, 0.1], (0.24, 0.03, 0.36), (0.65, 1), (-0.12, 0), material=skin, mirror=True)
    rounds(kit, [(long * 0.75, fat * 0.45, z - fat * 0.8), (-long * 0.4, fat * 1.05, z - fat * 0.5)], 0.15, dark)
    kit.add(BOX, (-0.05, fat * 0.84, z - fat * 0.05), (0.3, 0.03, fat * 0.65), material=kit.material(), mirror=True)
    kit.add(BOX, (long * 0.3, fat * 0.83, z + fat * 0.3), (0.15, 0.04, fat * 0.3), material=glass, mirror=True)
    kit.add(CYL, (-0.2, fat * 1.0, z - fat * 0.65), (0.13, 0.13, 0.4), rotation=ALONG_X, material=skin, mirror=True)


def bubble_copter(kit):
    """Small helicopters: a round bubble, an open lattice or a slender boom, two blades, skids."""
    rng = kit.rng
    skin, dark, glass = kit.material(pattern=PLAIN, gloss=0.4), kit.material(dark=True), kit.material(base=[0.12, 0.16, 0.18], gloss=0.64, pattern=PLAIN)
    tube = skin if kit.chance(0.4) else kit.material(base=np.ones(3) * rng.uniform(0.1, 0.6))
    fat, z = rng.uniform(0.48, 0.58), 0.95
    lattice = kit.chance(0.6)
    kit.add(BALL, (0.35, 0, z), (fat * rng.uniform(1.0, 1.25), fat * 0.95, fat), material=glass)
    kit.add(BOX, (0.2, 0, z - fat * 0.75), (0.6, fat * 0.6, fat * 0.25), (0.9, 1.1), material=skin)
    kit.add(BOX, (0.05, 0, z - fat * 0.3), (0.1, fat * 0.6, fat * 0.5), (0.8, 1), (-0.08, 0), material=dark)
    if not lattice:
        kit.add(BALL, (-0.1, 0, z), (0.75, fat * 0.85, fat * 0.8), material=skin)
    kit.add(BOX, (-0.4, 0, z - 0.15), (0.28, 0.25, 0.28), (0.8, 0.8), material=dark)
    kit.add(CYL, (-0.25, 0.38, z + 0.1), (0.16, 0.16, 0.26), rotation=ALONG_X, material=skin, mirror=True)
    mast = np.array([-0.2, 0, z + fat + rng.uniform(0.35, 0.5)])
    kit.between((-0.2, 0, z), mast, 0.05, material=dark)
    rotor(kit, mast, rng.uniform(2.0, 2.5), 2 if kit.chance(0.7) else 3, dark)
    tail = np.array([-2.4, 0, z + 0.25])
    if lattice:
        for y0, z0 in ((0.25, 0.25), (0.2, -0.3)):
            kit.between((-0.3, y0, z + z0), tail + [0, 0.02, 0], 0.022, material=tube, mirror=True)
        for k in range(5):
            t, u = k / 5, (k + 1) / 5
            a, b = np.array([-0.3, 0.25, z + 0.25]), np.array([-0.3, 0.2, z - 0.3])
            kit.between(a + (tail - a) * t, b + (tail - b) * u, 0.013, material=tube, mirror=True)
            kit.between(b + (tail - b) * t, b * (1, -1, 1) + (tail - b * (1, -1, 1)) * u, 0.013, material=tube)
    else:
        kit.between((-0.6, 0, z + 0.1), tail, 0.13, taper=0.5, material=skin)
    propeller(kit, tail + [-0.02, 0.1, 0.05], rng.uniform(0.3, 0.4), turn("x", 90), dark, 2)
    kit.add(TUBE, tail + [-0.05, 0.1, 0.0], (0.38, 0.42, 0.012), rotation=ALONG_Y, material=tube)
    kit.add(BOX, tail + [0.5, 0, 0.0], (0.13, 0.35, 0.015), material=skin)
    if not lattice:
        panel(kit, tail + [0.1, 0, -0.25], 0.7, 0.14, skin, 0.7, 0.12, 90, 0.02, False)
    for x in (-0.4, 0.55):
        kit.between((x, 0.25, z - fat * 0.8), (x, 0.75, 0.06), 0.028, material=tube, mirror=True)
    kit.add(CYL, (0.1, 0.75, 0.04), (0.035, 0.035, 1.0), rotation=ALONG_X, material=tube, mirror=True)
    kit.between((1.1, 0.75, 0.04), (1.25, 0.75, 0.16), 0.035, material=tube, mirror=True)
    if kit.chance(0.3):
        kit.add(BOX, (-0.05, 0.7, 0.3), (0.6, 0.18, 0.06), material=kit.material(), mirror=True)


def gyrocopter(kit):
    """Gyrocopters: an open or half-closed seat, an engine with a pushing propeller, a free rotor, a tall rudder."""
    rng = kit.rng
    skin, dark, tube = kit.material(pattern=PLAIN, gloss=0.4), kit.material(dark=True), kit.material(base=np.ones(3) * rng.uniform(0.1, 0.7), gloss=0.4)
    kit.add(BALL, (0.45, 0, 0.5), (0.75, 0.28, 0.26), material=skin)
    kit.between((-1.3, 0, 0.36), (0.9, 0, 0.36), 0.045, BOX, material=tube)
    if kit.chance(0.35):
        kit.add(BALL, (0.3, 0, 0.85), (0.62, 0.3, 0.45), material=glazing(kit))
    else:
        crew(kit, (0.1, 0, 0.62), (0.35, 0.15, 0.12), (0.7, 0.12, -0.08), 0.85, -0.15)
        kit.add(BOX, (0.72, 0, 0.82), (0.012, 0.2, 0.14), (1, 0.7), (-0.1, 0), material=glazing(kit))
    kit.add(BOX, (-0.08, 0, 0.75), (0.06, 0.2, 0.28), (1, 0.9), (-0.08, 0), material=dark)
    kit.add(BOX, (-0.5, 0, 0.75), (0.25, 0.2, 0.18), material=dark)
    propeller(kit, (-0.8, 0, 0.8), 0.5, ALONG_X, dark, int(rng.choice([2, 3])))
    hub = np.array([-0.2, 0, rng.uniform(1.6, 1.8)])
    kit.between((-0.2, 0, 0.38), hub, (0.04, 0.06), BOX, material=tube)
    start = len(kit.primitives)
    rotor(kit, hub + [0, 0, 0.1], rng.uniform(1.6, 2.0), 2, dark)
    lean = turn("y", -rng.uniform(4, 10))
    kit.primitives[start:] = [p._replace(centre=hub + lean @ (p.centre - hub), rotation=lean @ p.rotation) for p in kit.primitives[start:]]
    rounds(kit, [(0.85, 0, 0.4), (-0.25, 0.62, 0.42)], 0.17, tube)
    kit.between((-0.25, 0, 0.38), (-0.25, 0.6, 0.3), 0.03, material=tube, mirror=True)
    panel(kit, (-1.35, 0, 0.3), rng.uniform(0.7, 0.9), 0.25, skin, 0.7, 0.12, 90, 0.025, False)
    kit.add(BOX, (-1.3, 0, 0.4), (0.2, 0.45, 0.02), material=skin)
    kit.add(BOX, (-1.32, 0.45, 0.5), (0.2, 0.018, 0.22), (0.7, 1), (-0.06, 0), material=skin, mirror=True)


def multicopter(kit):
    """Quadcopters and hexacopters with a camera, big spraying or parcel drones, racers."""
    rng = kit.rng
    skin = kit.material(base=np.ones(3) * rng.choice([0.03, 0.3, 0.75]), pattern=PLAIN, gloss=0.3) if kit.chance(0.7) else kit.material(gloss=0.3)
    dark, metal, trim = kit.material(dark=True), kit.material(base=np.ones(3) * rng.uniform(0.2, 0.6), gloss=0.5), kit.material(base=paint(rng.random(), 0.9, 0.6), pattern=PLAIN)
    count = int(rng.choice([4, 4, 6]))
    arm, z = rng.uniform(0.8, 1.05), rng.uniform(0.5, 0.65)
    body = rng.uniform(0.24, 0.34)
    if kit.chance(0.5):
        kit.add(BOX, (0, 0, z), (body * 1.4, body * 0.75, body * 0.36), (0.85, 0.75), (-0.04, 0), material=skin)
        kit.add(BALL, (body * 0.2, 0, z + body * 0.3), (body * 1.0, body * 0.6, body * 0.25), material=skin)
    else:
        kit.add(CYL, (0, 0, z), (body, body, body * 0.3), (0.85, 1), material=skin)
        kit.add(BALL, (0, 0, z + body * 0.28), (body * 0.8, body * 0.8, body * 0.3), material=dark if kit.chance(0.5) else skin)
    kit.add(BOX, (-body * 1.2, 0, z + 0.02), (0.1, body * 0.5, body * 0.22), material=dark)
    reach = arm * (0.62 if count == 4 else 0.46)
    for x, y in around(count, arm, 45 if count == 4 else 30):
        kit.between((x * 0.2, y * 0.2, z), (x, y, z + 0.06), (0.035, 0.045), BOX, 0.8, material=skin)
        kit.add(CYL, (x, y, z + 0.1), (0.075, 0.075, 0.07), material=metal)
        spin = turn("z", rng.uniform(0, 180))
        kit.add(BOX, (x, y, z + 0.18), (reach, 0.05, 0.01), rotation=spin, material=dark)
        if count == 4 and kit.chance(0.5):
            kit.add(BALL, (x, y, z + 0.0), (0.04, 0.04, 0.03), material=trim)
    kind = rng.choice(["camera", "tank", "parcel"], p=[0.6, 0.2, 0.2])
    if kind == "camera":
        kit.add(CYL, (body * 1.0, 0, z - body * 0.45), (0.05, 0.05, 0.08), material=metal)
        kit.add(BOX, (body * 1.0, 0.12, z - body * 0.65), (0.03, 0.02, 0.12), material=metal)
        kit.add(BOX, (body * 1.0, 0, z - body * 0.8), (0.12, 0.1, 0.09), rotation=turn("y", rng.uniform(0, 30)), material=dark)
        kit.add(CYL, (body * 1.0 + 0.13, 0, z - body * 0.84), (0.06, 0.06, 0.05), rotation=ALONG_X, material=kit.material(base=[0.02, 0.02, 0.04], gloss=0.64))
    elif kind == "tank":
        kit.add(BOX, (0, 0, z - 0.22), (0.2, 0.28, 0.16), material=kit.material(base=[0.7, 0.72, 0.68], pattern=PLAIN))
        kit.between((0, -arm, z - 0.12), (0, arm, z - 0.12), 0.018, material=metal)
    else:
        kit.add(BOX, (0, 0, z - 0.24), (0.26, 0.22, 0.17), material=kit.material(base=[0.42, 0.28, 0.15], pattern=PLAIN))
        kit.add(BOX, (0, 0, z - 0.24), (0.265, 0.03, 0.172), material=trim)
    foot = body * rng.uniform(1.0, 1.5)
    if kit.chance(0.7):
        for x in (-0.18, 0.18):
            kit.between((x, body * 0.4, z - 0.05), (x, foot, 0.03), 0.02, material=dark, mirror=True)
        kit.add(CYL, (0, foot, 0.025), (0.025, 0.025, 0.4), rotation=ALONG_X, material=dark, mirror=True)
    else:
        for x, y in around(count, arm * 0.95, 45 if count == 4 else 30):
            kit.between((x, y, z + 0.04), (x, y, 0), 0.025, taper=0.6, material=skin)


def flying_car(kit):
    """Flying cars and air taxis: a pod or a car with ducted fans, rotors on booms, or folding wings."""
    rng = kit.rng
    skin, dark, glass, trim = kit.material(pattern=PLAIN, gloss=0.5), kit.material(dark=True), glazing(kit), kit.material()
    long, fat, z = rng.uniform(0.9, 1.2), rng.uniform(0.4, 0.5), 0.55
    kind = rng.choice(["taxi", "ducts", "winged"])
    kit.add(BALL, (0, 0, z), (long, fat, fat * 0.75), material=skin)
    kit.add(BALL, (long * 0.22, 0, z + fat * 0.28), (long * 0.62, fat * 0.82, fat * 0.68), material=glass)
    kit.add(BOX, (0, 0, z - fat * 0.5), (long * 0.7, fat * 0.6, fat * 0.3), (1.1, 1.2), material=skin)
    if kind == "taxi":
        high = z + fat * 0.95
        kit.add(BOX, (-0.1, 0, high - 0.1), (0.35, fat * 0.5, 0.14), (0.9, 0.7), material=skin)
        panel(kit, (-0.1, 0, high), 1.7, 0.26, skin, 0.6, 0.1, 1, 0.04)
        for y in (0.75, 1.35)[: int(rng.integers(1, 3))]:
            kit.between((-1.0, y, high), (0.8, y, high), 0.06, material=skin, mirror=True)
            for x in (-0.95, 0.75):
                kit.between((x, y, high), (x, y, high + 0.16), 0.05, material=dark, mirror=True)
                kit.add(BOX, (x, y, high + 0.17), (0.035, 0.4, 0.012), rotation=turn("z", rng.uniform(0, 180)), material=dark, mirror=True)
        kit.between((-long * 0.7, 0, z + 0.1), (-long * 1.7, 0, z + 0.35), 0.18, taper=0.4, material=skin)
        panel(kit, (-long * 1.6, 0, z + 0.3), 0.6, 0.18, skin, 0.6, 0.15, 38, 0.025)
        kit.between((-0.45, fat * 0.5, z - fat * 0.6), (-0.5, fat * 0.9, 0.05), 0.03, material=dark, mirror=True)
        kit.between((0.45, fat * 0.5, z - fat * 0.6), (0.5, fat * 0.9, 0.05), 0.03, material=dark, mirror=True)
        kit.add(CYL, (0, fat * 0.9, 0.04), (0.035, 0.035, 0.75), rotation=ALONG_X, material=dark, mirror=True)
        return
    for x in (-long * 0.55, long * 0.55):
        kit.add(CYL, (x, fat * 0.85, 0.2), (0.2, 0.2, 0.08), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(CYL, (x, fat * 0.87, 0.2), (0.12, 0.12, 0.08), rotation=ALONG_Y, material=trim, mirror=True)
        kit.between((x, -fat * 0.8, 0.2), (x, fat * 0.8, 0.2), 0.05, material=dark)
    kit.add(BOX, (long * 0.93, fat * 0.45, z), (0.05, 0.1, 0.04), material=kit.material(base=[0.8] * 3), mirror=True)
    kit.add(BOX, (-long * 0.93, fat * 0.45, z), (0.05, 0.1, 0.04), material=kit.material(base=[0.5, 0.03, 0.03]), mirror=True)
    if kind == "ducts":
        radius = rng.uniform(0.34, 0.42)
        for x in (-long * 0.75, long * 0.75):
            for y in (-1, 1):
                at = np.array([x, y * (fat + radius * 1.05), z + 0.15])
                kit.add(TUBE, at, (radius, radius, 0.09), material=skin)
                kit.add(TUBE, at, (radius * 0.95, radius * 0.95, 0.085), material=dark)
                kit.between((x * 0.7, y * fat * 0.5, z), at, (0.035, 0.06), BOX, material=skin)
                propeller(kit, at, radius * 0.92, np.eye(3), dark, 4)
    else:
        panel(kit, (-long * 0.25, fat * 0.5, z + fat * 0.3), rng.uniform(1.4, 1.8), 0.32, skin, 0.65, 0.1, 3, 0.04)
        kit.between((-long * 0.6, fat * 0.7, z + 0.1), (-long * 1.8, fat * 0.7, z + 0.3), 0.07, taper=0.6, material=skin, mirror=True)
        kit.add(BOX, (-long * 1.78, 0, z + 0.32), (0.17, fat * 0.75, 0.025), material=skin)
        panel(kit, (-long * 1.72, fat * 0.7, z + 0.25), 0.42, 0.2, trim, 0.6, 0.15, 90, 0.025)
        propeller(kit, (-long * 1.06, 0, z + 0.1), 0.3, ALONG_X, dark)
        kit.between((-long * 0.9, 0, z + 0.1), (-long * 1.06, 0, z + 0.1), 0.06, material=dark)


def hang_glider(kit):
    """Hang gliders: a swept cloth wing on tubes and wires, the pilot prone or standing below."""
    rng = kit.rng
    cloth, edge = kit.material(pattern=rng.choice([PLAIN, STRIPES, BANDS]), frequency=rng.uniform(2, 4), gloss=0.1), kit.material()
    tube, dark = kit.material(base=np.ones(3) * rng.uniform(0.3, 0.7), gloss=0.5), kit.material(dark=True)
    span, chord, high = rng.uniform(1.9, 2.4), rng.uniform(0.5, 0.65), 1.7
    sweep, lift = span * rng.uniform(0.4, 0.55), rng.uniform(-1, 4)
    panel(kit, (0.1, 0, high), span, chord, cloth, 0.25, sweep, lift, 0.014)
    panel(kit, (0.1 + chord * 0.85, 0, high), span, chord * 0.16, edge, 0.4, sweep + chord * 0.62, lift, 0.024)
    kit.between((chord + 0.15, 0, high + 0.01), (-0.9, 0, high), 0.025, material=tube)
    if kit.chance(0.6):
        kit.between((0, 0, high), (0, 0, high + 0.45), 0.018, material=tube)
        for x in (chord, -0.85):
            kit.between((0, 0, high + 0.45), (x, 0, high), 0.006, material=dark)
        kit.between((0, 0, high + 0.45), (-sweep * 0.55, span * 0.6, high + span * 0.6 * np.radians(lift)), 0.006, material=dark, mirror=True)
    bar = np.array([0.25, 0, 0.75])
    kit.between(bar + [0, -0.5, 0], bar + [0, 0.5, 0], 0.02, material=tube)
    kit.between(bar + [0, 0.5, 0], (0.1, 0.03, high), 0.02, material=tube, mirror=True)
    for end in ((chord + 0.1, 0.02, high), (-0.85, 0.02, high), (-sweep * 0.55, span * 0.6, high + span * 0.6 * np.radians(lift))):
        kit.between(bar + [0, 0.5, 0], end, 0.006, material=dark, mirror=True)
    if kit.chance(0.75):
        suit, skin = kit.material(pattern=PLAIN), skin_material(kit)
        chest = np.array([0.05, 0, 0.98])
        kit.add(BALL, chest, (0.33, 0.19, 0.15), material=suit)
        kit.between(chest - [0.1, 0, 0], chest - [1.25, 0, 0.05], (0.14, 0.17), CYL, 0.55, material=suit)
        kit.add(BALL, chest + [0.4, 0, 0.1], (0.13, 0.11, 0.14), material=edge)
        kit.add(BALL, chest + [0.46, 0, 0.06], (0.09, 0.085, 0.09), material=skin)
        kit.chain([chest + [0.15, 0.18, 0], chest + [0.2, 0.36, -0.12], bar + [0, 0.25, 0]], [0.06, 0.05, 0.04], suit, mirror=True)
        kit.between(chest, (0, 0, high), 0.012, material=dark)
    else:
        person_body(kit, (0.1, 0, 0), 0.9, kit.material(), kit.material(), skin_material(kit), "stand")


def arch(kit, span, high, chord, cells, cloth, second, ends=0.35):
    """A canopy curved from side to side, of slabs across x. Returns the seams' points [(y, z), ...]."""
    angles = np.linspace(-1, 1, cells + 1) * np.pi * 0.42
    points = np.stack([np.sin(angles) / np.sin(np.pi * 0.42) * span, np.cos(angles) * high], 1)
    for k in range(cells):
        (y0, z0), (y1, z1) = points[k], points[k + 1]
        middle = abs(k - (cells - 1) / 2) / (cells / 2)
        half = chord * (1 - (1 - ends) * middle**2.5)
        roll = turn("x", np.degrees(np.arctan2(z1 - z0, y1 - y0)))
        centre = np.array([-(chord - half) * 0.5, (y0 + y1) / 2, (z0 + z1) / 2])
        kit.add(BOX, centre, (half, np.hypot(y1 - y0, z1 - z0) / 2 * 1.04, 0.05), (0.92, 1), (-0.03, 0), roll @ turn("y", 5), cloth if k % 2 == 0 or second is None else second)
    return points


def paraglider(kit):
    """Paragliders, kite-surfers' and ram-air canopies: a curved wing, lines, the pilot seated; some with a motor on the back."""
    rng = kit.rng
    cloth = kit.material(base=paint(rng.random(), rng.uniform(0.7, 1), rng.uniform(0.4, 0.9)), pattern=rng.choice([PLAIN, SEAMS, STRIPES]), frequency=rng.uniform(3, 8), gloss=0.1)
    second, line, dark = kit.material(pattern=PLAIN) if kit.chance(0.6) else None, kit.material(dark=True), kit.material(dark=True)
    span, drop = rng.uniform(1.7, 2.4), rng.uniform(1.6, 2.3)
    rise = span * rng.uniform(0.4, 0.6)
    cells = int(rng.choice([9, 11]))
    points = arch(kit, span, rise, rng.uniform(0.35, 0.5), cells, cloth, second, rng.choice([0.3, 0.75]))
    for p in kit.primitives:
        p.centre[2] += drop
    hip = np.array([0, 0, 0.0])
    seat = kit.material(pattern=PLAIN)
    crew(kit, hip, (0.05, 0.28, 0.75), (0.62, 0.12, -0.12), 0.62, -0.15)
    kit.add(BOX, (-0.1, 0, 0.08), (0.1, 0.16, 0.22), (0.8, 0.9), (-0.06, 0), material=seat)
    kit.add(BOX, (0.04, 0, -0.06), (0.18, 0.15, 0.05), material=seat)
    for y, z in points[cells // 2 + 1 :]:
        for x in (0.2, -0.2):
            kit.between((0, 0.12, 0.35), (x * 0.9, y, z + drop - 0.03), 0.006, material=line, mirror=True)
    if kit.chance(0.3):
        kit.add(TUBE, (-0.32, 0, 0.2), (0.48, 0.48, 0.015), rotation=ALONG_X, material=dark)
        propeller(kit, (-0.3, 0, 0.2), 0.42, ALONG_X, dark, 2)
        kit.between((-0.1, 0, 0.15), (-0.32, 0, 0.2), 0.08, material=dark)


def kite(kit):
    """Diamond, delta, box and sled kites with tails and bridles, some held by a child."""
    rng = kit.rng
    cloth = kit.material(base=paint(rng.random(), rng.uniform(0.7, 1), rng.uniform(0.4, 0.9)), pattern=rng.choice([PLAIN, STRIPES, BANDS, CHECKER]), frequency=rng.uniform(2, 5), gloss=0.1)
    second, stick, line = kit.material(pattern=PLAIN), kit.material(base=[0.35, 0.22, 0.1]), kit.material(dark=True)
    lean = turn("y", -rng.uniform(15, 60))
    kind = rng.choice(["diamond", "delta", "box"])
    start = len(kit.primitives)
    low = np.zeros(3)
    if kind == "diamond":
        wide, up, down = rng.uniform(0.65, 0.85), rng.uniform(0.4, 0.55), rng.uniform(1.0, 1.4)
        for y in (-1, 1):
            kit.add(BOX, (0, y * wide / 4, up / 2), (0.012, wide / 2, up / 2), (1, 0.03), (0, -y * wide / 2), material=cloth if y > 0 else second)
            kit.add(BOX, (0, y * wide / 4, -down / 2), (0.012, wide / 2, down / 2), (1, 0.03), (0, -y * wide / 2), turn("y", 180), second if y > 0 else cloth)
        kit.between((0.02, -wide, 0), (0.02, wide, 0), 0.018, material=stick)
        kit.between((0.02, 0, -down), (0.02, 0, up), 0.018, material=stick)
        low = np.array([0, 0, -down])
    elif kind == "delta":
        wide, tall = rng.uniform(1.2, 1.7), rng.uniform(0.9, 1.2)
        for y in (-1, 1):
            kit.add(BOX, (0, y * wide / 4, 0), (0.012, wide / 2, tall / 2), (1, 0.03), (0, -y * wide / 2), material=cloth)
            kit.between((0.015, y * wide, -tall / 2), (0.015, 0, tall / 2), 0.018, material=stick)
        kit.between((0.015, 0, -tall * 0.6), (0.015, 0, tall / 2), 0.018, material=stick)
        kit.add(BOX, (0.17, 0, -0.05), (0.17, 0.01, tall * 0.3), (0.05, 1), (-0.16, 0), material=second)
        kit.add(BOX, (0, 0, -tall * 0.53), (0.011, wide * 0.4, 0.09), (1, 1.6), material=second)
        low = np.array([0, 0, -tall * 0.6])
    else:
        half, tall = rng.uniform(0.4, 0.55), rng.uniform(0.9, 1.2)
        for z in (-1, 1):
            for k in range(4):
                spin = turn("z", 45 + 90 * k)
                kit.add(BOX, spin @ np.array([half * 0.72, 0, 0]) + [0, 0, z * tall * 0.66], (0.012, half * 0.72, tall * 0.3), rotation=spin, material=cloth if k % 2 else second)
        for x, y in around(4, half * 1.0):
            kit.between((x, y, -tall), (x, y, tall), 0.02, material=stick)
        kit.between((-half, 0, tall * 0.66), (half, 0, tall * 0.66), 0.014, material=stick)
        kit.between((0, -half, -tall * 0.66), (0, half, -tall * 0.66), 0.014, material=stick)
    kit.primitives[start:] = [p._replace(centre=lean @ p.centre, rotation=lean @ p.rotation) for p in kit.primitives[start:]]
    at = lean @ low
    if kind != "box":
        for _ in range(int(rng.integers(3, 7))):
            after = at + [rng.uniform(-0.25, 0.05), rng.uniform(-0.14, 0.14), -rng.uniform(0.2, 0.3)]
            kit.between(at, after, 0.012, material=line)
            kit.add(BOX, after, (0.02, 0.13, 0.05), rotation=turn("x", rng.uniform(-40, 40)), material=cloth if kit.chance(0.5) else second)
            at = after
    hand = np.array([1.3, 0, -1.4])
    kit.between((0.05, 0, 0), hand, 0.008, material=line)
    if kit.chance(0.35):
        person_body(kit, hand + [0.3, 0, -1.1], 0.75, kit.material(), kit.material(), skin_material(kit), "stand")
    else:
        kit.add(CYL, hand, (0.05, 0.05, 0.12), rotation=ALONG_Y, material=second)


def parachute(kit):
    """Round and square parachutes with somebody, a crate or a vehicle on their lines."""
    rng = kit.rng
    cloth = kit.material(base=np.array([0.3, 0.33, 0.2]) * rng.uniform(0.6, 2) if kit.chance(0.5) else paint(rng.random(), rng.uniform(0.1, 1), 0.8), pattern=rng.choice([PLAIN, STRIPES, SEAMS, CHECKER]), frequency=rng.uniform(3, 8), gloss=0.1)
    line, radius = kit.material(base=np.ones(3) * rng.uniform(0.05, 0.6)), rng.uniform(1.0, 1.3)
    lift = radius * rng.uniform(2.0, 2.4)
    high = radius * rng.uniform(0.55, 0.8)
    dome = [(0, 1.0), (0.3, 0.97), (0.58, 0.84), (0.82, 0.58), (0.96, 0.26), (1.0, 0.08)]
    for (z0, r0), (z1, r1) in zip(dome[:-1], dome[1:], strict=True):
        half = (radius * r0, radius * r0, (z1 - z0) * high / 2)
        kit.add(CYL if z0 else TUBE, (0, 0, lift + (z0 + z1) * high / 2), half, (r1 / r0, 1), material=cloth)
    rim = kit.material(pattern=PLAIN) if kit.chance(0.5) else cloth
    kit.add(TUBE, (0, 0, lift - 0.03), (radius, radius, 0.05), material=rim)
    top, count = np.array([0, 0, 0.95]), int(rng.choice([8, 10, 12]))
    load = rng.choice(["person", "crate", "capsule"], p=[0.5, 0.3, 0.2])
    if load == "person":
        for x, y in around(count, radius, 11):
            kit.between(top + [0, 0.14 * np.sign(y), 0], (x, y, lift), 0.008, material=line)
        crew(kit, (0, 0, 0.5), (0.04, 0.24, 0.72), (rng.uniform(0, 0.3), 0.15, -0.72), 0.8, 0.0)
        kit.add(BOX, (-0.13, 0, 0.75), (0.09, 0.15, 0.2), material=kit.material())
    else:
        for x, y in around(count, radius, 11):
            kit.between(top, (x, y, lift), 0.008, material=line)
        half = rng.uniform(0.28, 0.4)
        if load == "crate":
            kit.add(BOX, (0, 0, half), (half, half, half), material=kit.material(pattern=rng.choice([PLAIN, SEAMS, STRIPES])))
            for spin in (0, 90):
                kit.add(BOX, (0, 0, half), (half * 1.02, 0.05, half * 1.02), rotation=turn("z", spin), material=line)
            ends = [(x, y, 2 * half) for x, y in around(4, half * 1.3, 45)]
        else:
            kit.loft((0, 0, 0), [(0, half * 1.1), (0.08, half * 1.25), (half * 1.6, half * 0.55), (half * 1.8, half * 0.4)], kit.material(base=np.ones(3) * rng.uniform(0.1, 0.7), pattern=STREAKS))
            ends = [(x, y, half * 1.7) for x, y in around(4, half * 0.4, 45)]
        for end in ends:
            kit.between(end, top, 0.012, material=line)


def hot_air_balloon(kit):
    """Hot-air balloons: a drop-shaped envelope in gay stripes, a skirt, burner, ropes and a wicker basket with people."""
    rng = kit.rng
    base = paint(rng.random(), rng.uniform(0.6, 1), rng.uniform(0.4, 0.9))
    first = kit.material(base=base, second=paint(rng.random(), rng.uniform(0.3, 1), rng.uniform(0.3, 0.9)), pattern=rng.choice([PLAIN, STRIPES, BANDS, CHECKER, SEAMS]), frequency=rng.uniform(4, 9), gloss=0.15)
    others = [kit.material(base=paint(rng.random(), rng.uniform(0.5, 1), rng.uniform(0.3, 0.9)), pattern=PLAIN) for _ in range(2)]
    fat, start = rng.uniform(1.1, 1.4), 1.15
    tall = fat * rng.uniform(2.1, 2.5)
    profile = [(0, 0.2), (0.16, 0.4), (0.34, 0.69), (0.5, 0.89), (0.62, 0.98), (0.72, 1.0), (0.82, 0.93), (0.9, 0.77), (0.96, 0.53), (0.99, 0.27), (1.0, 0.1)]
    ringed = kit.chance(0.4)
    for k, ((z0, r0), (z1, r1)) in enumerate(zip(profile[:-1], profile[1:], strict=True)):
        skin = [first, *others][k // 2 % 3] if ringed else first
        kit.add(CYL, (0, 0, start + (z0 + z1) / 2 * tall), (fat * r0, fat * r0, (z1 - z0) * tall / 2), (r1 / r0, 1), material=skin)
    kit.add(TUBE, (0, 0, start - 0.1), (fat * 0.17, fat * 0.17, 0.11), (1.18, 1), material=others[0])
    if kit.chance(0.4):
        kit.add(CYL, (0, 0, start + 0.72 * tall), (fat * 1.01, fat * 1.01, tall * 0.05), material=others[1])
    half = rng.uniform(0.2, 0.28)
    wicker, dark = kit.material(base=[0.3, 0.17, 0.07], second=[0.16, 0.08, 0.03], pattern=CHECKER, frequency=40), kit.material(dark=True)
    kit.add(BOX, (0, 0, 0.05), (half, half, 0.05), material=wicker)
    for spin in (0, 90, 180, 270):
        out = turn("z", spin)
        kit.add(BOX, out @ np.array([half, 0, 0.2]), (0.03, half, 0.2), rotation=out, material=wicker)
    kit.add(BOX, (0, 0, 0.4), (half * 1.12, 0.03, 0.03), rotation=np.eye(3), material=dark)
    for x, y in around(4, half * 1.35, 45):
        kit.between((x, y, 0.35), (x * 0.75, y * 0.75, 0.8), 0.018, material=dark)
        kit.between((x * 0.75, y * 0.75, 0.8), (x * 0.8, y * 0.8, start + 0.05), 0.008, material=dark)
    kit.add(BOX, (0, 0, 0.8), (half * 0.75, half * 0.75, 0.02), material=dark)
    kit.add(CYL, (0, 0.06, 0.88), (0.05, 0.05, 0.08), material=dark, mirror=True)
    for x, y in ((0.09, 0.09), (-0.08, -0.1), (-0.08, 0.1))[: int(rng.integers(0, 4))]:
        kit.between((x, y, 0.05), (x, y, 0.5), (0.06, 0.08), CYL, material=kit.material())
        kit.add(BALL, (x, y, 0.56), (0.05, 0.05, 0.065), material=skin_material(kit))
        kit.add(BALL, (x - 0.01, y, 0.59), (0.053, 0.053, 0.05), material=dark)
