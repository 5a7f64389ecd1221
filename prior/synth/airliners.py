"""Makers of large aeroplanes and business jets: transports, radar aeroplanes, airliners, tankers, bombers with jets."""

import numpy as np

from .airframes import airscrew, cockpit, fan, hull, looks, on, roundels, surface, wheel
from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CLOUDY, PLAIN
from .seacraft import ports


def turboprops(kit, wing, shares, look, size, blades, drop=0.1):
    """Engines before a wing: a slender nacelle, intake below, boss and blades; one on either side at every share."""
    for share in shares:
        at = on(wing, share)
        front = on(wing, share, 0.5)[0] + size * 2.2
        kit.between((at[0] - size * 1.5, at[1], at[2]), (front, at[1], at[2] - drop), (size * 1.15, size * 0.85), taper=0.85, material=look.skin, mirror=True)
        kit.add(BOX, (front - size * 0.4, at[1], at[2] - drop - size * 0.75), (size * 0.42, size * 0.45, size * 0.25), material=look.metal, mirror=True)
        airscrew(kit, (front, at[1], at[2] - drop), size * 3.6, look, blades, size * 0.55, True)


def fuselage_door(kit, x, y, z, look):
    kit.add(BOX, (-x, y - 0.02, z), (0.4, 0.05, 0.8), material=look.metal, mirror=True)


def propeller_transport(kit):
    """High-winged turboprop transports of four engines or two, with an upswept tail; and the low-winged patrol aeroplane with a sting."""
    rng = kit.rng
    look = looks(kit, rng.choice(["grey", "grey", "drab"]))
    blades, patrol, twin = int(rng.choice([4, 4, 6])), kit.chance(0.35), kit.chance(0.35)
    if patrol:
        hull(kit, [(0, -0.2, 0.4, 0.4), (1.2, -0.1, 1.2, 1.2), (3, 0, 1.72, 1.72), (22, 0, 1.72, 1.72), (31, 0.8, 0.35, 0.45), (35, 0.9, 0.14, 0.14)], look.skin)
        kit.add(BALL, (-0.5, 0, -0.2), (0.7, 0.55, 0.55), material=look.skin)
        cockpit(kit, 2.6, 1.05, 1.2, 0.42, look)
        wing = surface(kit, (11.2, 1, -1.0, 5.6, 14.2, 4, 2.3, 6), look.skin, 0.13, True)
        turboprops(kit, wing, (0.25, 0.57), look, 0.6, 4)
        surface(kit, (27, 0.3, 1.0, 3.4, 6.3, 12, 1.6, 6), look.skin, 0.1)
        surface(kit, (25.6, 0, 1, 5.4, 5.4, 30, 2, 90), look.trim, 0.09)
        kit.add(BOX, (-15, 0, 0.4), (9, 1.74, 0.16), material=ports(kit, 22))
        low, ground, leg = -1.1, 3.3, on(wing, 0.25, 0.1)
    else:
        fat, long, rear = (1.5, 13, 22) if twin else (2.15, 19, 29.5)
        hull(kit, [(0, -fat * 0.3, fat * 0.25, fat * 0.25), (1.2, -fat * 0.2, fat * 0.68, fat * 0.68), (3.2, 0, fat, fat), (long, 0, fat, fat)], look.skin)
        hull(kit, [(long - 0.1, 0, fat, fat), (rear, fat * 0.75, fat * 0.3, fat * 0.25)], look.skin)
        kit.add(BALL, (-0.2, 0, -fat * 0.3), (0.9, fat * 0.36, fat * 0.36), material=look.dark if kit.chance(0.5) else look.skin)
        cockpit(kit, 2.5, fat * 0.55, fat * 0.72, fat * 0.3, look, 0.9)
        half = 12 if twin else 19
        wing = surface(kit, (long * 0.47, fat * 0.3, fat * 0.95, 4.9 if not twin else 3, half, 2 if not twin else 3, 2.3 if not twin else 1.5, 1.5), look.skin, 0.14, True)
        turboprops(kit, wing, (0.29,) if twin else (0.26, 0.53), look, 0.58, blades)
        kit.add(BOX, (-long * 0.56, 0, fat * 0.9), (2.6, fat * 0.8, fat * 0.2), (0.7, 0.7), material=look.skin)
        surface(kit, (rear - 5.2, 0.3, fat * 0.95, 3.8 if not twin else 2.6, half * 0.4, 9, 2, 0), look.skin, 0.1)
        surface(kit, (rear - 7, 0, fat * 0.7, 6 if not twin else 4.6, fat * 2.9, 22, 3 if not twin else 2.2, 90), look.trim, 0.09)
        kit.add(BOX, (-long * 0.6, fat * 0.95, -fat * 0.72), (3.2, 0.45, fat * 0.36), (0.7, 0.7), material=look.skin, mirror=True)
        low, ground, leg = -fat * 0.7, fat + 0.9, np.array([-long * 0.6, fat * 0.95, 0])
        fuselage_door(kit, 4.3, fat, -0.3, look)
    if patrol or kit.chance(0.75):
        wheel(kit, 3.3, 0, ground, 0.55, look, low, True)
        wheel(kit, -leg[0], leg[1], ground, 0.68, look, low, True)
        if not patrol:
            wheel(kit, -leg[0] + 1.6, leg[1], ground, 0.68, look, low, True)
    roundels(kit, wing, 0.75, 0.8)


def jet_transport(kit):
    """High-winged jet transports with a T-tail, four fans or two, drooping wings, upswept tail and fairings for the wheels."""
    rng = kit.rng
    look = looks(kit, rng.choice(["grey", "grey", "drab", "gay"]))
    fat, long, rear = 3.0, rng.uniform(25, 30), rng.uniform(42, 47)
    hull(kit, [(0, -0.8, 0.7, 0.7), (2, -0.5, 2, 2), (5, 0, fat, fat), (long, 0, fat, fat), (rear, 2.3, 0.7, 0.7)], look.skin)
    kit.add(BALL, (-0.5, 0, -0.8), (1.3, 1.0, 1.0), material=look.skin)
    cockpit(kit, 3.6, 1.6, 1.9, 0.6, look, 1.2)
    lift = rng.uniform(-5, -2)
    inner = surface(kit, (11.5, 1, fat * 0.95, 11, 9, 28, 6.4, lift), look.skin, 0.12)
    x, y, z = on(inner, 1.0, 0.5)
    wing = surface(kit, (-x, y - 0.05, z, 6.4, 14.5, 27, 2.4, lift), look.skin, 0.11)
    kit.add(BOX, (-15.5, 0, fat * 0.95), (6, 2.3, 0.75), (0.8, 0.6), material=look.skin)
    for panel, share in ((inner, 0.75), (wing, 0.4)) if kit.chance(0.8) else ((inner, 0.7),):
        at = on(panel, share, 0.5)
        fan(kit, at + [1.2, 0, -1.75], 1.1, 1.7, look, look.skin, 1.75)
    surface(kit, (rear - 9.5, 0, 2.5, 7.5, 8.2, 36, 5.2, 90), look.trim, 0.1)
    surface(kit, (rear - 4.6, 0, 10.6, 5, 8.6, 28, 2.2, -2), look.skin, 0.1)
    kit.add(BALL, (-rear + 2.2, 0, 10.6), (3.4, 0.5, 0.5), material=look.skin)
    kit.add(BOX, (-21, fat * 0.95, -2.2), (5.5, 0.9, 1.1), (0.7, 0.6), material=look.skin, mirror=True)
    fuselage_door(kit, 7, fat, -0.6, look)
    if kit.chance(0.75):
        wheel(kit, 5.5, 0, 4.3, 0.6, look, -2, True)
        for x in (18.5, 20.5, 22.5):
            wheel(kit, x, 3.2, 4.3, 0.72, look, -2, True)
    if kit.chance(0.5):
        surface(kit, (-wing.tip[0] - 1.2, wing.tip[1] - 0.1, wing.tip[2], 2.4, 2.2, 40, 0.8, 75), look.trim, 0.06)


def radar_aeroplane(kit):
    """Airborne radar on a small twin turboprop: a dish over the body with four fins behind, or a beam along the back."""
    rng = kit.rng
    look = looks(kit, rng.choice(["grey", "grey", "gay"]))
    fat = 1.15
    hull(kit, [(0, -0.2, 0.3, 0.3), (1.2, -0.1, 0.8, 0.8), (2.8, 0, fat, fat), (10.5, 0, fat, fat), (17.3, 0.6, 0.25, 0.3)], look.skin)
    kit.add(BALL, (-0.1, 0, -0.2), (0.5, 0.36, 0.36), material=look.dark)
    cockpit(kit, 2.4, 0.75, 0.8, 0.35, look, 0.7)
    dish = kit.chance(0.6)
    level = fat * 0.9 if dish else -fat * 0.7
    wing = surface(kit, (5.4, 0.4, level, 3.2, 11.5, 4, 1.5, 3 if not dish else 1.5), look.skin, 0.13, True)
    turboprops(kit, wing, (0.28,), look, 0.55 if dish else 0.48, int(rng.choice([4, 4, 6])))
    tail = surface(kit, (14, 0.1, 0.7, 2.8, 3.7, 8, 1.9, 8), look.skin, 0.1)
    if dish:
        kit.add(BALL, (-8.6, 0, 2.65), (3.6, 3.6, 0.42), material=kit.material(base=look.skin.first, pattern=rng.choice([PLAIN, BANDS, CLOUDY])))
        for y in (-0.4, 0.4):
            for x in (-7.8, -9.4):
                kit.between((x, y * 1.8, 0.9), (x, y, 2.5), 0.12, material=look.skin)
        for share in (0.4, 1.0):
            at = on(tail, share, 0.5)
            surface(kit, (-at[0], at[1], at[2] - (1.0 if share > 0.5 else 0), 2, 2.5 if share > 0.5 else 1.5, 8, 1.5, 90), look.trim, 0.08)
    else:
        surface(kit, (12.6, 0, 0.6, 4, 3.8, 32, 1.8, 90), look.trim, 0.1)
        kit.add(BOX, (-8, 0, 2.1), (4.4, 0.28, 0.36), (0.96, 0.8), material=look.trim)
        for x in (-5, -8, -11):
            kit.add(BOX, (x, 0, 1.4), (0.28, 0.1, 0.6), material=look.skin)
        kit.add(BOX, (-6.5, 0, 0.25), (3.6, fat * 1.01, 0.14), material=ports(kit, 25))
    if kit.chance(0.7):
        at = on(wing, 0.28)
        ground = 2.3 if dish else 2.5
        wheel(kit, 2.4, 0, ground, 0.36, look, -0.8, True)
        wheel(kit, -at[0] + 0.1, at[1], ground, 0.48, look, at[2], True)
    roundels(kit, wing, 0.72, 0.5)


def big_jet(kit):
    """Airliners with two and four engines below or two at the tail, some with a hump; tankers with a boom, radar with a rotodome; the bomber with eight engines in pairs,
    that with contrary propellers."""
    rng = kit.rng
    kind = rng.choice(["two", "two", "four", "hump", "tail", "tanker", "rotodome", "bear", "eight", "eight"])
    civil = kind in ("two", "four", "hump", "tail")
    look = looks(kit, "gay" if civil else "grey" if kind != "eight" or kit.chance(0.4) else "drab")
    if civil and kit.chance(0.85):
        look = look._replace(skin=kit.material(base=np.ones(3) * rng.uniform(0.7, 0.9), pattern=PLAIN, gloss=0.3))
    if kind == "eight":
        long, fat, tall, span, level, ground = 47.5, 1.5, 1.9, 27.5, 1.5, 3.6
    else:
        long, fat, span = {"two": (38, 2, 17), "four": (60, 2.8, 29), "hump": (66, 3.2, 30), "tail": (36, 1.7, 14)}.get(kind, (42, 1.95, 20.5))
        tall, level, ground = fat, -fat * 0.6, fat + {"four": 2.6, "hump": 2.6, "tail": 1.1}.get(kind, 1.9)
    nose = fat * 0.9
    hull(
        kit,
        [
            (0, -0.25 * fat, fat * 0.2, tall * 0.2),
            (nose, -0.12 * fat, fat * 0.7, tall * 0.7),
            (2.6 * nose, 0, fat, tall),
            (long * 0.66, 0, fat, tall),
            (long, tall * 0.55, fat * 0.18, tall * 0.18),
        ],
        look.skin,
    )
    kit.add(BALL, (-nose * 0.2, 0, -0.25 * fat), (nose * 0.5, fat * 0.29, tall * 0.29), material=look.skin)
    cockpit(kit, 1.75 * nose, tall * 0.55, fat * 0.62, tall * 0.2, look, nose * 0.45)
    sweep = {"tail": 26, "eight": 37, "hump": 40}.get(kind, 29 if kind == "two" else 34)
    chord, lift = span * (0.42 if kind != "eight" else 0.36), -1.5 if kind == "eight" else 5.5
    x = long * {"tail": 0.42, "eight": 0.27}.get(kind, 0.33)
    inner = surface(
        kit,
        (x, fat * 0.5, level, chord, span * 0.36, sweep, chord * (0.6 if kind != "eight" else 0.76), lift),
        look.skin if not civil else look.skin._replace(first=np.ones(3) * 0.5),
        0.12,
    )
    x, y, z = on(inner, 1.0, 0.5)
    wing = surface(
        kit,
        (-x, y - 0.02, z, inner.narrow, span * 0.62, sweep - 1, chord * (0.22 if kind != "eight" else 0.38), lift),
        look.skin if not civil else look.skin._replace(first=np.ones(3) * 0.5),
        0.1,
    )
    fin = span * (0.34 if kind != "eight" else 0.4)
    high = tall * 0.55
    surface(kit, (long - fin * 1.35, 0, high, fin * 0.95, fin if kind != "tail" else fin * 0.9, 40, fin * 0.36, 90), look.trim, 0.09)
    if kind == "tail":
        surface(kit, (long - fin * 0.68, 0, high + fin * 0.88, fin * 0.5, span * 0.4, 30, fin * 0.22, -1), look.skin, 0.09)
        fan(kit, (-long * 0.73, fat * 1.15 + 0.7, tall * 0.45), 0.85, 1.7, look, look.skin)
        kit.add(BOX, (-long * 0.74, fat * 0.95, tall * 0.4), (1.2, 0.9, 0.15), material=look.skin, mirror=True)
    else:
        surface(kit, (long - fin * 1.12, fat * 0.15, high * 0.8, fin * 0.75, span * 0.38, sweep + 2, fin * 0.28, 6), look.skin, 0.09)
    cowl = look.trim if civil and kit.chance(0.4) else look.skin
    size = {"two": 1.05, "four": 1.25, "hump": 1.3}.get(kind, 0.8)
    if kind == "eight":
        for panel, share in ((inner, 0.85), (wing, 0.45)):
            at = on(panel, share, 0.5) + [1.6, 0, -1.3]
            kit.add(BOX, at + [-2.2, 0, 0.6], (1.8, 0.15, 0.8), (1, 1), (-1.4, 0), material=look.skin, mirror=True)
            for side in (-0.62, 0.62):
                kit.add(CYL, at + [0, side, 0], (0.62, 0.62, 2.1), (0.75, 1), rotation=turn("y", -90), material=look.skin, mirror=True)
                kit.add(CYL, at + [2.1, side, 0], (0.5, 0.5, 0.04), rotation=ALONG_X, material=look.dark, mirror=True)
        kit.add(BALL, on(wing, 0.62) - [0, 0, 1.0], (3, 0.55, 0.55), material=look.skin, mirror=True)
        kit.add(BOX, on(wing, 0.62) - [0, 0, 0.4], (0.8, 0.1, 0.4), material=look.skin, mirror=True)
    elif kind == "bear":
        for panel, share in ((inner, 0.8), (wing, 0.38)):
            at = on(panel, share, 0.5)
            kit.between(at + [-4, 0, 0], at + [3.4, 0, 0], (0.95, 0.75), taper=0.75, material=look.skin, mirror=True)
            for fore in (3.4, 4.1):
                airscrew(kit, at + [fore, 0, 0], 2.8, look, 4, 0.5, True)
    elif kind != "tail":
        for panel, share in ((inner, 0.88),) if kind == "two" else ((inner, 0.8), (wing, 0.42)):
            at = on(panel, share, 0.5)
            fan(kit, at + [size * 0.7, 0, -size * 1.25], size, size * 1.5, look, cowl, size * 1.25)
    if kind == "hump":
        hull(kit, [(2.2, 0.4, 1.0, 0.8), (5.5, fat * 0.65, 1.9, 1.75), (17, fat * 0.65, 1.9, 1.75), (24, fat * 0.5, 1.3, 1.0)], look.skin)
        kit.add(BOX, (-11, 0, fat * 1.0), (6.5, 1.92, 0.16), material=ports(kit, 25))
        kit.add(BOX, (-3.9, 0, fat * 0.98), (0.9, 1.35, 0.35), (0.5, 0.8), (-0.4, 0), material=look.glass)
    elif kind == "rotodome":
        kit.add(BALL, (-long * 0.63, 0, tall + 3.1), (4.6, 4.6, 0.8), material=kit.material(base=[0.05] * 3, pattern=BANDS, second=look.skin.first, frequency=2))
        kit.between((-long * 0.62, 0.5, tall * 0.7), (-long * 0.63, 0.5, tall + 3.0), (1.0, 0.2), BOX, 0.7, material=look.skin, mirror=True)
    elif kind == "tanker":
        droop = tall * rng.choice([0.1, 1.7])
        kit.between((-long * 0.75, 0, -tall * 0.2), (-long - 3, 0, -tall * 0.2 - droop), 0.22, taper=0.8, material=look.metal)
        kit.add(BOX, (-long - 1, 0, -tall * 0.2 - droop * 0.85), (0.5, 1.5, 0.06), material=look.skin)
    if civil:
        kit.add(BOX, (-long * 0.42, 0, tall * 0.28), (long * 0.3, fat * 0.98, 0.17), material=ports(kit, 40))
        if kit.chance(0.5):
            kit.add(BOX, (-long * 0.4, 0, -0.02), (long * 0.32, fat * 1.006, rng.uniform(0.1, 0.3)), material=look.trim)
        kit.add(BOX, (-long * 0.13, fat * 0.97, 0.2), (0.45, 0.08, 0.9), material=look.trim, mirror=True)
        if kind != "tail" and kit.chance(0.6):
            surface(kit, (-wing.tip[0] - wing.narrow * 0.5, wing.tip[1] - 0.1, wing.tip[2], wing.narrow * 0.95, span * 0.13, 38, wing.narrow * 0.4, 72), look.trim, 0.07)
    if kit.chance(0.65):
        if kind == "eight":
            for x in (12, 29):
                wheel(kit, x, 1.3, ground, 0.68, look, -1.2, True)
            wheel(kit, -on(wing, 0.85)[0], on(wing, 0.85)[1], ground, 0.4, look, on(wing, 0.85)[2])
        else:
            wheel(kit, long * 0.13, 0, ground, tall * 0.24, look, -tall * 0.7, True)
            for back in (0, 0.62 * fat) if kind != "tail" else (0,):
                wheel(kit, long * 0.53 + back, fat * 1.25, ground, tall * 0.3, look, -tall * 0.5, True, fat * 0.65)


def big_delta(kit):
    """The slender airliner for more than the speed of sound, and the bomber of one great delta, engines in its roots."""
    rng = kit.rng
    slender = kit.chance(0.5)
    look = looks(kit, "gay" if slender else rng.choice(["drab", "grey"]))
    if slender:
        look = look._replace(skin=kit.material(base=np.ones(3) * rng.uniform(0.7, 0.9), pattern=PLAIN, gloss=0.3))
        droop = rng.choice([0, 0.9])
        hull(kit, [(0, -droop, 0.08, 0.08), (7, -droop * 0.2, 0.95, 0.95), (11, 0, 1.42, 1.5), (42, 0, 1.42, 1.5), (61, 1.2, 0.15, 0.15)], look.skin)
        cockpit(kit, 8.4, 0.75, 0.8, 0.45, look, 1.0)
        kit.add(BOX, (-27, 0, 0.4), (15, 1.41, 0.13), material=ports(kit, 40))
        first = surface(kit, (18, 0.7, -0.8, 37, 4.8, 73, 22, 0), look.skin, 0.025)
        surface(kit, (-first.tip[0] - 11, first.tip[1] - 0.05, -0.8, 22, 7.2, 65, 4.5, -1), look.skin, 0.025)
        surface(kit, (46, 0, 1, 11.5, 6.4, 48, 3.2, 90), look.trim, 0.06)
        kit.add(BOX, (-50, 5.2, -1.75), (6, 1.45, 0.95), shift=(0.8, 0), material=look.skin, mirror=True)
        for y in (4.5, 5.9):
            kit.add(BOX, (-44.1, y, -1.75), (0.15, 0.56, 0.78), shift=(0.65, 0), material=look.dark, mirror=True)
            kit.add(CYL, (-56.2, y, -1.7), (0.62, 0.62, 1.2), (0.85, 1), rotation=turn("y", -90), material=look.metal, mirror=True)
        ground, nose, main, y, radius = 5.0, 17, 37, 3.8, 0.6
    else:
        hull(kit, [(0, -0.2, 0.35, 0.35), (2, 0, 1.1, 1.15), (5, 0.1, 1.5, 1.5), (22, 0.2, 1.3, 1.3), (29.5, 0.7, 0.45, 0.5)], look.skin)
        kit.add(BALL, (-0.1, 0, -0.2), (0.75, 0.38, 0.38), material=look.dark)
        kit.add(BALL, (-3.9, 0, 1.3), (1.5, 0.75, 0.75), material=look.glass)
        wing = surface(kit, (6.4, 1, 0.15, 18.6, 15.4, 50, 3.2, -1.5), look.skin, 0.075)
        surface(kit, (19.8, 0, 1, 7.2, 4.8, 47, 3.2, 90), look.trim, 0.07)
        kit.add(BOX, (-15.6, 2.7, 0.15), (8.1, 1.45, 0.85), (0.95, 0.8), material=look.skin, mirror=True)
        kit.add(BOX, (-7.5, 2.75, 0.1), (0.08, 1.15, 0.45), material=look.dark, mirror=True)
        for y in (2.1, 3.5):
            kit.add(CYL, (-24.2, y, 0.1), (0.7, 0.7, 1.7), (0.8, 1), rotation=turn("y", -90), material=look.metal, mirror=True)
            kit.add(CYL, (-25.9, y, 0.1), (0.46, 0.46, 0.03), rotation=ALONG_X, material=look.dark, mirror=True)
        roundels(kit, wing, 0.55, 0.9)
        ground, nose, main, y, radius = 3.6, 5.5, 15.5, 4.0, 0.55
    if kit.chance(0.7):
        wheel(kit, nose, 0, ground, radius * 0.85, look, -0.8, True)
        for back in (0, 1.5):
            wheel(kit, main + back, y, ground, radius, look, -0.8 if slender else 0.1, True)


def business_jet(kit):
    """Business jets: fans beside the rear body, sometimes a third in it, a T-tail or a cross one, winglets or tip tanks, few windows."""
    rng = kit.rng
    look = looks(kit, "gay")
    if kit.chance(0.75):
        look = look._replace(skin=kit.material(base=np.ones(3) * rng.uniform(0.75, 0.9), pattern=PLAIN, gloss=0.4))
    long, fat = rng.uniform(14, 21), rng.uniform(0.85, 1.05)
    hull(kit, [(0, -0.3, 0.06, 0.06), (1.2, -0.2, fat * 0.52, fat * 0.5), (3.1, 0, fat, fat), (long * 0.68, 0, fat, fat), (long, 0.5, 0.14, 0.16)], look.skin)
    cockpit(kit, 2.35, 0.52 * fat, fat * 0.7, fat * 0.26, look, 0.7)
    kit.add(BOX, (-long * 0.42, 0, fat * 0.22), (long * 0.19, fat * 0.985, 0.13), material=ports(kit, 16))
    tanks, three = kit.chance(0.2), kit.chance(0.25)
    half = rng.uniform(0.44, 0.5) * long
    wing = surface(
        kit,
        (long * 0.38, 0.3, -fat * 0.75, half * 0.4, half, rng.uniform(8, 32) if not tanks else 12, half * 0.13 if not tanks else half * 0.2, 3.5),
        look.skin._replace(first=np.ones(3) * 0.55),
        0.1,
    )
    kit.add(BALL, (-long * 0.48, 0, -fat * 0.7), (long * 0.18, fat * 0.85, fat * 0.45), material=look.skin)
    if tanks:
        kit.add(BALL, on(wing, 1.0), (1.9, 0.32, 0.32), material=look.trim, mirror=True)
    elif kit.chance(0.7):
        surface(kit, (-wing.tip[0] - wing.narrow * 0.4, wing.tip[1] - 0.05, wing.tip[2], wing.narrow, 1.1, 38, wing.narrow * 0.5, 75), look.trim, 0.07)
    radius = rng.uniform(0.45, 0.6)
    fan(kit, (-long * 0.72, fat + radius * 0.9, fat * 0.55), radius, radius * 2.2, look, look.skin)
    kit.add(BOX, (-long * 0.73, fat * 0.9, fat * 0.45), (0.6, radius * 0.9, 0.1), material=look.skin, mirror=True)
    fin, tee = long * 0.17, kit.chance(0.65)
    surface(kit, (long - fin * 1.6, 0, fat * 0.5, fin * 1.25, fin, 42, fin * 0.75, 90), look.trim, 0.09)
    share = 0.97 if tee else 0.4
    surface(kit, (long - fin * 1.6 + fin * share * 0.9 + 0.15, 0, fat * 0.5 + fin * share, fin * 0.75, half * 0.42, 28, fin * 0.38, -1), look.skin, 0.09)
    if three:
        kit.add(CYL, (-long + fin * 1.25, 0, fat * 1.05), (0.48, 0.48, 1.1), (0.75, 1), rotation=turn("y", -90), material=look.skin)
        kit.add(CYL, (-long + fin * 1.25 + 1.1, 0, fat * 1.05), (0.4, 0.4, 0.03), rotation=ALONG_X, material=look.dark)
    for z in rng.uniform(-0.35, 0.05, int(rng.integers(1, 3))) * fat:
        kit.add(BOX, (-long * 0.42, 0, z), (long * 0.3, fat * 0.99, rng.uniform(0.03, 0.09)), material=look.trim)
    kit.add(BOX, (-3.9, fat * 0.96, 0), (0.4, 0.06, 0.7), material=look.metal)
    if kit.chance(0.7):
        wheel(kit, 2.6, 0, fat + 0.75, 0.24, look, -fat * 0.6, True)
        at = on(wing, 0.2)
        wheel(kit, -at[0] + 0.3, at[1], fat + 0.75, 0.3, look, at[2], True)
