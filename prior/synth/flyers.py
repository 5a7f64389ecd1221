"""A maker of aeroplanes of every age, and what it shares with that of what hovers."""

import numpy as np

from .aircraft import propeller
from .boats import crew, white_paint
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CHECKER, CLOUDY, PLAIN, SEAMS, STREAKS, STRIPES, paint
from .seacraft import ports
from .wheeled import glazing


def fixed_wing(kit):
    """Airliners, high-wing transports, flying wings, canard deltas, swing-wing jets, fighters and bombers of the 1940s, seaplanes, gliders, ultralights."""
    kit.rng.choice([airliner, transport, flying_wing, canard_delta, swing_wing, old_fighter, old_bomber, seaplane, glider, ultralight])(kit)


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
