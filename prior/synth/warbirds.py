"""Makers of aeroplanes of the 1940s and of those with two booms: fighters and bombers, most of them with pistons."""

import numpy as np

from .airframes import GAY, airscrew, canopy_frames, cockpit, hull, looks, on, roundels, surface, tilted, wheel
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL
from .materials import PLAIN, SEAMS


def piston_fighter(kit):
    """Fighters of the 1940s: elliptic wing, inline with a belly radiator or a chin one, big round radials, gull wings up and down; on the tail wheel or in the air."""
    rng = kit.rng
    kind = rng.choice(["elliptic", "belly", "inline", "radial", "barrel", "gull", "stuka"])
    look = looks(kit, rng.choice(["drab", "drab", "grey"]))
    if kit.chance(0.7):
        look = look._replace(trim=kit.material(base=GAY[rng.integers(len(GAY))], pattern=PLAIN))
    start, round_nose = len(kit.primitives), kind in ("radial", "barrel", "gull")
    fat = {"barrel": 0.72, "gull": 0.66, "radial": 0.56}.get(kind, 0.45)
    if round_nose:
        hull(kit, [(0.35, 0, fat * 0.86, fat * 0.86), (0.55, 0, fat, fat), (1.9, 0, fat * 0.98, fat), (4.4, 0.03, fat * 0.78, fat * 0.98), (9.0, 0.22, 0.08, 0.16)], look.skin)
        kit.add(CYL, (-0.35, 0, 0), (fat * 0.76, fat * 0.76, 0.03), rotation=ALONG_X, material=look.dark)
        kit.add(CYL, (-1.85, 0, 0), (fat * 1.02, fat * 1.01, 0.08), rotation=ALONG_X, material=look.metal)
        airscrew(kit, (-0.32, 0, 0), 1.75, look, 4 if kind == "barrel" else 3, fat * 0.34)
    else:
        hull(kit, [(0.5, 0, 0.33, 0.36), (2.5, 0, 0.42, 0.55), (4.2, 0.02, 0.45, 0.66), (6.5, 0.08, 0.3, 0.45), (9.0, 0.22, 0.07, 0.16)], look.skin)
        airscrew(kit, (-0.55, 0, 0), 1.65, look, 4 if kind == "belly" else 3, 0.33)
        kit.add(BOX, (-1.5, 0.4, 0.18), (0.65, 0.06, 0.06), material=look.metal, mirror=True)
    x = 3.6 if kind == "belly" else 4.0
    bubble = kind in ("belly", "barrel") or kit.chance(0.3)
    z = fat * 0.95 if round_nose else 0.6
    if kind == "stuka":
        canopy_frames(kit, 4.2, 0.55, 1.7, 0.38, 0.6, look)
    elif bubble:
        canopy_frames(kit, x, z, 0.95, 0.36, 0.5, look)
    else:
        canopy_frames(kit, x, z, 0.75, 0.34, 0.46, look)
        kit.add(BOX, (-x - 1.6, 0, z - 0.08), (1.55, 0.3, 0.32), (0.6, 0.5), (0.62, 0), material=look.skin)
    low = -fat * 0.6
    if kind in ("gull", "stuka"):
        first = surface(kit, (2.6, 0.3, low + 0.1, 2.5, 1.5, 0, 2.4, -18 if kind == "gull" else -12), look.skin, 0.15, True)
        wing = surface(kit, (2.6, first.tip[1] - 0.08, first.tip[2], 2.4, 4.1, 4, 1.2, 11 if kind == "gull" else 9), look.skin, 0.13, True)
        leg = on(first, 0.95)
    elif kind == "elliptic":
        first = surface(kit, (2.75, 0.3, low + 0.05, 2.5, 2.6, 2, 2.3, 6), look.skin, 0.12, True)
        wing = surface(kit, (2.84, first.tip[1] - 0.03, first.tip[2], 2.3, 1.7, 11, 1.5, 6), look.skin, 0.1, True)
        end = on(wing, 1.0)
        kit.add(BALL, end, (0.75, 0.85, 0.07), rotation=turn("x", 6), material=look.skin, mirror=True)
        leg = on(first, 0.25)
    else:
        wing = surface(kit, (2.5, 0.3, low + 0.05, 2.5, 5.0, 4, 1.25, 5.5), look.skin, 0.13, True)
        if kind != "belly":
            kit.add(BALL, on(wing, 1.0), (0.62, 0.3, 0.09), material=look.skin, mirror=True)
        leg = on(wing, 0.28)
    surface(kit, (7.9, 0.05, 0.3, 1.15, 1.75, 8, 0.7, 2), look.skin, 0.1, True)
    surface(kit, (7.7, 0, 0.2, 1.45, 1.25, 22, 0.75, 90), look.trim if kit.chance(0.4) else look.skin, 0.1, True)
    if kind == "belly":
        kit.add(BOX, (-5.0, 0, -0.6), (1.2, 0.3, 0.3), (1.3, 0.9), material=look.skin)
        kit.add(BOX, (-3.82, 0, -0.62), (0.03, 0.25, 0.2), material=look.dark)
    elif kind in ("inline", "elliptic"):
        kit.add(BOX, on(wing, 0.15) - [0.2, 0, 0.22], (0.6, 0.35, 0.14), material=look.skin, mirror=True)
    elif kind == "stuka":
        kit.add(BOX, (-1.1, 0, -0.48), (0.55, 0.3, 0.3), (0.95, 0.8), material=look.skin)
        kit.add(BOX, (-0.54, 0, -0.48), (0.02, 0.24, 0.22), material=look.dark)
    down, at = kit.chance(0.75) or kind == "stuka", (leg[0] + 0.75, leg[1] + 0.1)
    if down:
        kit.between((leg[0] + 0.35, leg[1], leg[2]), (at[0], at[1], -1.5), 0.075, material=look.metal, mirror=True)
        kit.add(CYL, (at[0], at[1], -1.5), (0.36, 0.36, 0.1), rotation=ALONG_Y, material=look.rubber, mirror=True)
        if kind == "stuka":
            kit.add(BOX, (at[0] - 0.15, at[1], -1.3), (0.42, 0.2, 0.42), (0.7, 0.9), (-0.2, 0), material=look.skin, mirror=True)
        else:
            kit.add(BOX, (at[0] - 0.12, at[1] + 0.03, -1.1), (0.22, 0.03, 0.42), (1.1, 1), (-0.25, 0), material=look.skin, mirror=True)
        kit.between((-8.1, 0, 0.1), (-8.35, 0, -0.28), 0.05, material=look.metal)
        kit.add(CYL, (-8.35, 0, -0.3), (0.16, 0.16, 0.06), rotation=ALONG_Y, material=look.rubber)
    roundels(kit, wing, 0.6, 0.45)
    kit.add(CYL, (-6.6, 0, 0.09), (0.46 if round_nose else 0.45, 0.34 if round_nose else 0.3, 0.14), (0.93, 1), rotation=turn("y", -90), material=look.trim)
    for share in (0.4, 0.5) if kind not in ("gull", "stuka") else (0.2,):
        muzzle = on(wing, share, 0.45)
        kit.between(muzzle, muzzle + [0.55, 0, 0], 0.04, material=look.dark, mirror=True)
    if kit.chance(0.3):
        kit.add(BALL, (-3.6, 0, low - 0.42), (1.1, 0.27, 0.27), material=look.metal)
        kit.add(BOX, (-3.6, 0, low - 0.1), (0.25, 0.06, 0.25), material=look.skin)
    tilted(kit, start, np.degrees(np.arctan2(1.4, 8.35 + leg[0] + 0.75)) if down else rng.choice([0, 5, 10]))


def radial(kit, at, radius, look, blades=3, inline=False):
    """A piston engine on either side, with its nacelle running into the wing behind."""
    at = np.array(at, float)
    kit.between(at + [-1.3, 0, 0], at + [1.5, 0, 0], (radius, radius * (0.8 if inline else 1)), taper=0.85 if inline else 1, material=look.skin, mirror=True)
    kit.between(at + [-1.3, 0, 0], at + [-3.6, 0, 0], (radius, radius * (0.8 if inline else 1)), taper=0.15, material=look.skin, mirror=True)
    if not inline:
        kit.add(CYL, at + [1.5, 0, 0], (radius * 0.8, radius * 0.8, 0.03), rotation=ALONG_X, material=look.dark, mirror=True)
    airscrew(kit, at + [1.5, 0, 0], 1.75, look, blades, radius * (0.7 if inline else 0.3), True)


def piston_bomber(kit):
    """Bombers of the 1940s with two or four engines: glazed nose, turrets, one great fin or two, on tail wheel or nose wheel, and the slender unarmed twin."""
    rng = kit.rng
    look = looks(kit, rng.choice(["drab", "drab", "grey"]))
    glass = kit.material(base=[0.09, 0.11, 0.13], second=[0.3, 0.3, 0.28], pattern=SEAMS, frequency=22, gloss=0.5)
    kind = rng.choice(["lancaster", "fortress", "liberator", "mitchell", "junkers", "mosquito"])
    four, inline = kind in ("lancaster", "fortress", "liberator"), kind in ("lancaster", "junkers", "mosquito")
    long, fat, tall = {"lancaster": (21, 0.95, 1.15), "fortress": (22, 1.1, 1.2), "liberator": (20, 1.05, 1.5), "mosquito": (12.6, 0.62, 0.72)}.get(kind, (15.5, 0.72, 0.95))
    half = {"lancaster": 15.5, "fortress": 15.8, "liberator": 16.8, "mosquito": 8.2}.get(kind, 10)
    start = len(kit.primitives)
    hull(kit, [(0.8, 0, fat * 0.72, tall * 0.75), (long * 0.14, 0, fat, tall), (long * 0.5, 0.05, fat, tall), (long, tall * 0.5, fat * 0.28, tall * 0.3)], look.skin)
    kit.add(BALL, (-0.9, 0, 0), (0.95, fat * 0.72, tall * 0.75), material=glass if kind != "mosquito" or kit.chance(0.4) else look.skin)
    if kind == "mosquito":
        canopy_frames(kit, 2.5, tall * 0.75, 1.1, 0.5, 0.5, look)
    elif kind == "lancaster":
        kit.add(BOX, (-long * 0.2, 0, tall * 1.05), (1.8, fat * 0.6, 0.42), (0.75, 0.8), material=glass)
    else:
        cockpit(kit, long * 0.16, tall * 0.95, fat * 0.7, tall * 0.38, look, 1.2)
        kit.add(BOX, (-long * 0.3, 0, tall * 0.95), (long * 0.12, fat * 0.6, tall * 0.25), (0.8, 0.6), (0.2, 0), material=look.skin)
    level = {"fortress": -0.5, "liberator": 0.8, "lancaster": -0.1, "mitchell": 0.15}.get(kind, -0.25) * tall
    chord = half * (0.26 if kind == "liberator" else 0.33)
    wing = surface(kit, (long * 0.26, fat * 0.3, level, chord, half, {"fortress": 7, "mosquito": 2}.get(kind, 4), chord * 0.42, 4), look.skin, 0.14, True)
    size = 0.6 if four or inline else 0.72
    shares = (0.24, 0.5) if four else (0.27,)
    for share in shares:
        radial(kit, on(wing, share, 0.5) + [0.3, 0, -0.15], size * (0.85 if inline else 1), look, int(rng.choice([3, 3, 4])) if four else 3, inline)
    tail = half * 0.26
    twin = kind in ("lancaster", "liberator", "mitchell")
    surface(kit, (long * 0.87, 0.1, tall * 0.6, long * 0.12, tail * 1.25, 4, long * 0.085, 3 if not twin else 1), look.skin, 0.1)
    if twin:
        kit.add(CYL, (-long * 0.935, tail * 1.25, tall * 0.9), (long * 0.065, tail * 0.42, 0.08), rotation=ALONG_Y, material=look.skin, mirror=True)
    else:
        surface(
            kit,
            (
                long * (0.78 if kind == "fortress" else 0.83),
                0,
                tall * 0.5,
                long * (0.2 if kind == "fortress" else 0.15),
                tail * 0.95,
                40 if kind == "fortress" else 22,
                long * 0.085,
                90,
            ),
            look.skin,
            0.09,
            False,
        )
        if kind == "fortress":
            surface(kit, (long * 0.6, 0, tall * 0.5, long * 0.3, 1.1, 78, long * 0.1, 90), look.skin, 0.03)
    if kind != "mosquito":
        gun = long * (0.52 if kind != "junkers" else 0.24)
        kit.add(BALL, (-gun, 0, tall * 0.95), (0.6, 0.52, 0.55), material=glass)
        kit.between((-gun - 0.3, 0.15, tall * 1.15), (-gun - 1.5, 0.15, tall * 1.35), 0.045, material=look.dark, mirror=True)
        kit.add(BALL, (-long, 0, tall * 0.5), (0.7, fat * 0.45, tall * 0.42), material=glass)
        kit.between((-long, 0.15, tall * 0.5), (-long - 1.3, 0.15, tall * 0.5), 0.045, material=look.dark, mirror=True)
        if kind == "fortress":
            kit.add(BALL, (-long * 0.55, 0, -tall * 0.85), (0.6, 0.6, 0.6), material=glass)
    roundels(kit, wing, 0.75, 0.7)
    if kit.chance(0.75):
        at, big = on(wing, shares[0], 0.3), 0.62 if four else 0.46
        nose_wheel = kind in ("liberator", "mitchell")
        ground = 2.8 if four else 2.4
        x = at[0] - (1.6 if nose_wheel else -0.4)
        kit.between((x, at[1], at[2] - 0.2), (x, at[1], big - ground), 0.14, material=look.metal, mirror=True)
        kit.add(CYL, (x, at[1], big - ground), (big, big, big * 0.36), rotation=ALONG_Y, material=look.rubber, mirror=True)
        if nose_wheel:
            wheel(kit, 2.4, 0, ground, big * 0.75, look, -0.4)
        else:
            angle = np.radians(8)
            rear = long * 0.88
            drop = -ground + (rear + x) * np.tan(angle)
            drop = min(drop, tall * 0.15)
            wheel(kit, rear, 0, -drop, 0.26, look, tall * 0.4)
            tilted(kit, start, np.degrees(np.arctan2(drop + ground, rear + x)))


def twin_boom(kit):
    """Two booms with engines, a pod between them and one tailplane across: the heavy fighter, the jet of the 1950s, the forward air controller."""
    rng = kit.rng
    kind = rng.choice(["lightning", "vampire", "bronco"])
    look = looks(kit, rng.choice(["drab", "grey", "gay"]))
    y, rear = {"lightning": (2.45, 11), "vampire": (1.7, 9), "bronco": (2.3, 11.5)}[kind]
    pod = [(0.3, 0, 0.25, 0.25), (1.4, 0.05, 0.5, 0.55), (3.6, 0.05, 0.62, 0.72), (6, 0.05, 0.5, 0.5), (7, 0.1, 0.3, 0.3)]
    hull(kit, pod, look.skin)
    kit.add(BALL, (-0.35, 0, 0), (0.4, 0.26, 0.26), material=look.skin)
    canopy_frames(kit, 3.0, 0.55, 1.6 if kind == "bronco" else 1.1, 0.46, 0.6, look)
    high = 0.6 if kind == "bronco" else -0.1
    wing = surface(kit, (3.4, 0.3, high, 2.7, 7.0 if kind != "vampire" else 5.4, 5, 1.2 if kind != "bronco" else 2.4, 4 if kind == "lightning" else 1), look.skin, 0.13, True)
    fore = 1.6 if kind != "vampire" else 4.6
    hull(
        kit,
        [(fore, high, 0.42, 0.46), (fore + 3, high, 0.36, 0.4), (rear, high + 0.15, 0.15, 0.18)]
        if kind != "vampire"
        else [(4, high, 0.15, 0.16), (rear, high + 0.15, 0.12, 0.14)],
        look.skin,
        y,
    )
    if kind == "vampire":
        kit.add(BOX, (-3.6, 0.85, -0.1), (0.7, 0.4, 0.22), (1, 0.8), material=look.skin, mirror=True)
        kit.add(BOX, (-2.92, 0.85, -0.1), (0.03, 0.33, 0.16), material=look.dark, mirror=True)
        kit.add(CYL, (-7, 0, 0.1), (0.24, 0.24, 0.03), rotation=ALONG_X, material=look.dark)
    else:
        airscrew(kit, (-fore, y, high), 1.6 if kind == "lightning" else 1.3, look, 3, 0.36, True)
    tall = 1.3 if kind != "bronco" else 2.0
    surface(kit, (rear - 1.6, y, high + 0.1, 1.6, tall, 18, 1.0, 90), look.trim, 0.08)
    kit.add(BOX, (-rear + 0.5, 0, high + (0.2 if kind != "bronco" else tall)), (0.5, y + 0.1, 0.06), material=look.skin)
    if kind == "lightning":
        kit.between((-0.4, 0.1, 0.05), (0.6, 0.1, 0.05), 0.04, material=look.dark, mirror=True)
    if kit.chance(0.75):
        wheel(kit, 1.6, 0, 1.7, 0.28, look, -0.2)
        wheel(kit, 5.2, y, 1.7, 0.36, look, high)
    roundels(kit, wing, 0.7, 0.45)
