"""What the makers of people and statues share: heads with hair and hats, poses, clothes."""

from types import SimpleNamespace

import numpy as np

from .belongings import black, brass
from .bodies import FORE, HIP, SHIN, THIGH, UPPER, bent
from .kit import ALONG_Y, around, towards, turn
from .layout import BALL, BOX, CYL
from .materials import CHECKER, CLOUDY, DOTS, PLAIN, SPECKLES, STREAKS, STRIPES, paint
from .people import hair_material, skin_material

FLIP = np.diag([1.0, -1, 1])


def plain(kit, base, gloss=0.05):
    return kit.material(base=base, pattern=PLAIN, gloss=gloss)


def carved(kit):
    """One of the materials that statues are of."""
    rng = kit.rng
    kind = rng.choice(["marble", "sandstone", "granite", "bronze", "verdigris", "gold", "wood", "clay"], p=[0.22, 0.18, 0.1, 0.17, 0.12, 0.06, 0.08, 0.07])
    base = {
        "marble": np.array([0.78, 0.75, 0.7]) * rng.uniform(0.75, 1.1),
        "sandstone": np.array([0.52, 0.42, 0.28]) * rng.uniform(0.6, 1.2),
        "granite": np.ones(3) * rng.uniform(0.15, 0.45),
        "bronze": np.array([0.16, 0.1, 0.055]) * rng.uniform(0.5, 1.6),
        "verdigris": np.array([0.2, 0.4, 0.33]) * rng.uniform(0.6, 1.2),
        "gold": np.array([0.75, 0.52, 0.14]),
        "wood": np.array([0.36, 0.2, 0.09]) * rng.uniform(0.5, 1.4),
        "clay": np.array([0.5, 0.22, 0.12]) * rng.uniform(0.7, 1.2),
    }[kind]
    pattern = {"granite": SPECKLES, "wood": STREAKS, "verdigris": CLOUDY, "marble": rng.choice([PLAIN, CLOUDY])}.get(kind, rng.choice([PLAIN, CLOUDY]))
    gloss = rng.uniform(0.25, 0.6) if kind in ("bronze", "gold") else rng.uniform(0.0, 0.15)
    return kit.material(base=base, pattern=pattern, frequency=rng.uniform(4, 14), gloss=gloss, second=base * rng.uniform(0.65, 0.9))


def head_frame(kit, centre, size, frame):
    """A function that adds a part of the head by its place in half heads from the head's centre; with `mirror` both sides."""

    def part(kind, p, half, material, taper=(1, 1), tilt=None, mirror=False, shift=(0, 0)):
        tilt = np.eye(3) if tilt is None else tilt
        for side in (1, -1) if mirror else (1,):
            p_, t = (np.array(p, float), tilt) if side == 1 else (FLIP @ np.array(p, float), FLIP @ tilt @ FLIP)
            kit.add(kind, centre + frame @ p_ * size, np.array(half) * size, taper, (shift[0], shift[1] * side), frame @ t, material)

    return part


def bar(part, start, end, radius, material, taper=1.0, mirror=False, kind=CYL):
    start, end = np.array(start, float), np.array(end, float)
    radius = np.broadcast_to(radius, 2)
    part(kind, (start + end) / 2, (*radius, np.linalg.norm(end - start) / 2), material, (taper, taper if kind == BOX else 1), towards(end - start), mirror)


def hair_on(part, rng, style, hair):
    """A head's hair."""
    if style == "bald":
        return
    if style == "rim":
        part(BALL, (-0.22, 0, 0.05), (0.72, 0.74, 0.34), hair)
        return
    if style == "mohawk":
        for a in np.linspace(-60, 110, 8):
            c, s = np.cos(np.radians(90 + a)), np.sin(np.radians(90 + a))
            part(BOX, (-0.1 + 0.92 * c, 0, 0.3 + 0.86 * s), (0.17, 0.08, rng.uniform(0.2, 0.32)), hair, (0.7, 0.4), turn("y", -a))
        return
    if style == "afro":
        r = rng.uniform(0.9, 1.25)
        part(BALL, (-0.3, 0, 0.55), (r * 0.95, r, r * 0.95), hair)
        return
    part(BALL, (-0.19, 0, rng.uniform(0.4, 0.47)), (0.82, 0.75, rng.uniform(0.7, 0.8)), hair)
    part(BALL, (-0.42, 0, 0.0), (0.52, 0.64, 0.6), hair)
    if style == "curls":
        for k in range(14):
            a, b = k * 2.4, 0.1 + 1.3 * ((k * 0.618) % 1)
            x, y = np.cos(a) * np.cos(b), np.sin(a) * np.cos(b)
            part(BALL, (-0.25 + 0.72 * x - (0.25 if x > 0.5 else 0), 0.72 * y, 0.42 + 0.68 * np.sin(b)), (rng.uniform(0.2, 0.3),) * 3, hair)
    elif style == "quiff":
        part(BALL, (0.3, 0, 0.95), (0.4, 0.5, rng.uniform(0.2, 0.32)), hair, tilt=turn("y", -15))
    elif style == "part":
        for side in (1, -0.6):
            part(BALL, (0.24, 0.32 * side, 0.85), (0.34, 0.42, 0.2), hair, tilt=turn("x", -35 * side))
    elif style in ("long", "bob", "braids", "locks"):
        low = -0.55 if style == "bob" else rng.uniform(-1.6, -0.9)
        if style != "braids":
            part(BALL, (-0.38, 0, (low + 0.4) / 2), (0.5, 0.8, (0.5 - low) / 2 + 0.1), hair)
            part(BALL, (-0.05, 0.64, (low * 0.8 + 0.6) / 2), (0.3, 0.18, (0.6 - low * 0.8) / 2), hair, tilt=turn("x", 6), mirror=True)
        else:
            for k in range(6):
                part(BALL, (-0.1 + 0.04 * k, 0.72 + 0.02 * k, -0.1 - 0.24 * k), (0.16 - 0.01 * k, 0.15 - 0.01 * k, 0.17), hair, mirror=True)
        if style == "locks":
            for k in range(9):
                a = np.radians(70 + 27.5 * k)
                x, y = np.cos(a) * 0.62 - 0.2, np.sin(a) * 0.78
                bar(part, (x * 0.9, y * 0.9, 0.6), (x * 1.15, y * 1.15, low * rng.uniform(0.8, 1.1)), 0.09, hair, 0.6)
        elif rng.random() < 0.5:
            part(BALL, (0.36, 0, 0.72), (0.3, 0.52, 0.28), hair)
    elif style == "tail":
        part(BALL, (-1.0, 0, 0.35), (0.2, 0.2, 0.2), hair)
        part(BALL, (-1.15, 0, -0.25), (0.22, 0.25, rng.uniform(0.6, 0.9)), hair, tilt=turn("y", -8))
    elif style == "bun":
        up = rng.uniform(0.1, 1.0)
        part(BALL, (-0.85 + 0.35 * up, 0, 0.35 + 0.75 * up), (0.34, 0.34, 0.32), hair)


def hat_on(kit, part, kind, material, hair, stone=False):
    """What a head wears, and the hair below it."""
    rng = kit.rng
    dark, gold = (material, material) if stone else (black(kit), brass(kit))
    if kind in ("headphones", "laurel"):
        hair_on(part, rng, "short", hair)
    elif kind not in ("scarf", "hood", "helmet", "turban"):
        part(BALL, (-0.26, 0, 0.2), (0.74, 0.73, 0.7), hair)
    if kind in ("cap", "peaked", "beret", "beanie"):
        if kind == "peaked":
            part(CYL, (-0.1, 0, 0.66), (0.82, 0.76, 0.18), dark)
            part(CYL, (-0.08, 0, 0.98), (0.84, 0.78, 0.16), material, (1.28, 1), tilt=turn("y", -6))
            part(BALL, (0.75, 0, 0.85), (0.07, 0.15, 0.18), gold)
        elif kind == "beret":
            part(BALL, (-0.2, 0.18, 0.85), (0.98, 1.0, 0.34), material, tilt=turn("x", -14))
        else:
            part(BALL, (-0.11, 0, 0.52), (0.88, 0.78, 0.74 if kind == "cap" else 0.85), material)
            if kind == "beanie":
                part(CYL, (-0.1, 0, 0.5), (0.9, 0.8, 0.17), material._replace(first=material.first * 0.7), (0.97, 1))
                part(BALL, (-0.15, 0, 1.42), (0.22, 0.22, 0.22), dark if kit.chance(0.3) else material)
        if kind in ("cap", "peaked"):
            part(CYL, (0.7, 0, 0.54 if kind == "cap" else 0.52), (0.68, 0.6, 0.04), dark if kind == "peaked" else material, tilt=turn("y", 12))
    elif kind in ("brim", "cowboy", "top", "hard"):
        high = {"top": 0.75, "hard": 0.1}.get(kind, 0.34)
        wide = {"top": 1.15, "hard": 0.98, "cowboy": 1.6}.get(kind, rng.uniform(1.25, 1.7))
        part(CYL, (-0.08, 0, 0.6), (wide, wide * 0.88, 0.05), material)
        if kind == "hard":
            part(BALL, (-0.08, 0, 0.6), (0.95, 0.85, 0.68), material)
            part(BOX, (-0.08, 0, 1.05), (0.62, 0.09, 0.25), material)
            part(CYL, (0.75, 0, 0.58), (0.45, 0.55, 0.04), material)
        else:
            part(CYL, (-0.08, 0, 0.62 + high), (0.84, 0.76, high), material, (1.05 if kind == "top" else 0.8, 1))
            part(CYL, (-0.08, 0, 0.72), (0.86, 0.78, 0.09), dark)
            if kind == "cowboy":
                part(BALL, (-0.08, 1.25, 0.75), (1.1, 0.3, 0.07), material, tilt=turn("x", 35), mirror=True)
    elif kind == "helmet":
        part(BALL, (-0.08, 0, 0.42), (1.02, 0.9, 0.88), material)
        part(CYL, (-0.08, 0, 0.3), (1.08, 0.95, 0.09), material, (0.95, 1))
        part(BALL, (-0.35, 0.62, 0.05), (0.4, 0.24, 0.42), material, mirror=True)
        bar(part, (0.1, 0.68, 0.2), (0.45, 0.2, -0.88), 0.05, dark, mirror=True)
    elif kind == "crown":
        hair_on(part, rng, rng.choice(["short", "long"]), hair)
        part(CYL, (-0.1, 0, 0.85), (0.72, 0.68, 0.14), gold, (1.06, 1))
        for x, y in around(7, 0.72):
            part(CYL, (-0.1 + x, y * 0.95, 1.15), (0.15, 0.15, 0.22), gold, (0.1, 1))
    elif kind == "turban":
        for k, z in enumerate((0.5, 0.78, 1.02)):
            part(BALL, (-0.12, 0, z), (0.98 - 0.1 * k, 0.92 - 0.1 * k, 0.28), material, tilt=turn("x", 10 * (-1) ** k))
    elif kind in ("scarf", "hood"):
        part(BALL, (-0.25, 0, 0.32), (0.9, 0.84, 0.84), material)
        part(BALL, (-0.32, 0, -0.4), (0.66, 0.8, 0.95), material)
        part(BALL, (0.0, 0.6, -0.45), (0.42, 0.22, 0.75), material, tilt=turn("x", 8), mirror=True)
        part(CYL, (-0.1, 0, -1.25), (0.95, 1.1, 0.4), material, (0.62, 1))
        if kind == "hood":
            part(BALL, (-0.55, 0, 0.8), (0.5, 0.4, 0.5), material, tilt=turn("y", -30))
    elif kind == "headphones":
        for start, end in zip(np.linspace(0, 162, 10), np.linspace(18, 180, 10), strict=True):
            a, b = np.radians([start, end])
            bar(part, (-0.05, 0.8 * np.cos(a), 0.1 + 1.12 * np.sin(a)), (-0.05, 0.8 * np.cos(b), 0.1 + 1.12 * np.sin(b)), (0.05, 0.11), dark, kind=BOX)
        part(CYL, (-0.05, 0.78, 0), (0.3, 0.3, 0.13), material, tilt=ALONG_Y, mirror=True)
    else:
        for k in range(5):
            a = np.radians(30 + 28 * k)
            part(BALL, (-0.1 + 0.8 * np.cos(a), 0.76 * np.sin(a), 0.66), (0.2, 0.08, 0.13), gold, tilt=turn("z", np.degrees(a) + 60), mirror=True)


def features(kit, part, skin, hair, stone, woman):
    """Skull, jaw, nose, brows, eyes, lips and ears of a head seen close up."""
    rng = kit.rng
    wide, jaw, nose = rng.uniform(0.93, 1.08), rng.uniform(0.85, 1.12) * (0.9 if woman else 1), rng.uniform(0.85, 1.25)
    shade = skin._replace(first=np.clip(skin.first * [0.85, 0.55, 0.5] + [0.05 * woman, 0, 0], 0.01, 0.99)) if not stone else skin
    part(BALL, (-0.1, 0, 0.3), (0.82, 0.68 * wide, 0.72), skin)
    part(BALL, (0.18, 0, -0.12), (0.55, 0.57 * wide, 0.75), skin)
    part(BALL, (0.24, 0, -0.56), (0.48, 0.48 * jaw, 0.39), skin)
    part(BALL, (0.56, 0, -0.8), (0.2, 0.24 * jaw, 0.18), skin)
    part(BALL, (0.47, 0.33, -0.13), (0.2, 0.2, 0.2), skin, mirror=True)
    part(BALL, (0.57, 0.22, 0.2), (0.19, 0.28, 0.12), skin, tilt=turn("x", -5), mirror=True)
    if stone:
        part(BALL, (0.62, 0.25, 0.02), (0.11, 0.15, 0.09), skin, mirror=True)
    else:
        part(BALL, (0.6, 0.25, 0.02), (0.13, 0.16, 0.09), plain(kit, [0.8, 0.78, 0.74], 0.4), mirror=True)
        iris = plain(kit, paint(rng.choice([0.07, 0.07, 0.3, 0.58]), 0.7, rng.uniform(0.03, 0.2)), 0.5)
        part(BALL, (0.7, 0.245, 0.02), (0.045, 0.07, 0.075), iris, mirror=True)
        part(BALL, (0.62, 0.25, 0.1), (0.14, 0.18, 0.06), skin, mirror=True)
    bar(part, (0.67, 0, 0.16), (0.84, 0, -0.2), 0.075 * nose, skin, 1.35)
    part(BALL, (0.84, 0, -0.22), (0.14 * nose, 0.12 * nose, 0.1), skin)
    part(BALL, (0.74, 0.1 * nose, -0.25), (0.1, 0.075, 0.07), skin, mirror=True)
    part(BALL, (0.68, 0, -0.475), (0.1, 0.24, 0.05), shade)
    part(BALL, (0.67, 0, -0.56), (0.1, 0.19, 0.06), shade)
    part(BALL, (-0.04, 0.67 * wide, -0.05), (0.16, 0.08, 0.26), skin, tilt=turn("z", 20) @ turn("y", -10), mirror=True)
    part(BALL, (0.69, 0.28, 0.235), (0.09, 0.18, 0.035 if woman else 0.05), hair, tilt=turn("x", -6) @ turn("z", -22), mirror=True)


ARMS = {
    "hang": [(0.04, 0.27, -0.04), (0.04, 0.27, -0.04)],
    "hips": [(0.07, 0.19, 0.07), (0.07, 0.19, 0.07)],
    "crossed": [(0.2, -0.09, 0.3), (0.21, -0.09, 0.34)],
    "raised": [(0.05, 0.36, 0.98), (0.04, 0.27, -0.04)],
    "up": [(0.05, 0.42, 0.96), (0.05, 0.42, 0.96)],
    "wave": [(0.04, 0.27, -0.04), (0.15, 0.46, 0.7)],
    "point": [(0.04, 0.27, -0.04), (0.55, 0.25, 0.5)],
    "behind": [(-0.15, 0.06, 0.02), (-0.15, 0.06, 0.02)],
    "pray": [(0.26, 0.035, 0.36), (0.26, 0.035, 0.36)],
    "carry": [(0.32, 0.13, 0.22), (0.32, 0.13, 0.22)],
    "knees": [(0.36, 0.13, 0.06), (0.36, 0.13, 0.06)],
    "pockets": [(0.08, 0.2, -0.02), (0.08, 0.2, -0.02)],
    "chin": [(0.33, 0.1, 0.1), (0.17, 0.0, 0.57)],
    "run": [(0.32, 0.2, 0.32), (-0.16, 0.26, 0.2)],
    "walk": [(-0.16, 0.25, 0.0), (0.22, 0.24, 0.03)],
}
LEGS = {
    "stand": (HIP + 0.025, [(0.02, 0.12, 0.07), (-0.02, 0.12, 0.07)], (1, 0, 0)),
    "rest": (HIP + 0.015, [(0.16, 0.17, 0.07), (0, 0.08, 0.07)], (1, 0.3, 0)),
    "walk": (HIP - 0.025, [(0.32, 0.09, 0.07), (-0.32, 0.09, 0.11)], (1, 0, 0)),
    "run": (HIP - 0.01, [(0.12, 0.09, 0.36), (-0.4, 0.08, 0.1)], (1, 0, 0.2)),
    "sit": (0.52, [(0.45, 0.13, 0.07), (0.42, 0.13, 0.07)], (1, 0, 0.6)),
    "ground": (0.13, [(0.6, 0.14, 0.07), (0.52, 0.15, 0.07)], (0, 0, 1)),
    "lotus": (0.15, [(0.27, -0.14, 0.13), (0.34, -0.14, 0.07)], (0.4, 1.2, -0.1)),
    "squat": (0.34, [(0.1, 0.16, 0.07), (0.06, 0.16, 0.07)], (1, 0.3, 0.6)),
    "kneel": (0.5, [(0.36, 0.13, 0.07), (-0.38, 0.13, 0.09)], (1, 0, 0)),
}


def dress_up(kit, stone=None, **more):
    """The materials and the build of somebody; `stone`: all of one material."""
    rng = kit.rng
    mats = ("skin", "hair", "top", "bottom", "shoes", "sleeve", "gloves")
    wear = SimpleNamespace(stone=stone is not None, woman=kit.chance(0.4), wide=rng.uniform(0.92, 1.12), fat=rng.choice([0, 0, 0.02, 0.05]))
    wear.head, wear.bare, wear.flare = 1.0, (0, 0), rng.uniform(0.7, 1.1)
    if stone is not None:
        wear.__dict__.update(dict.fromkeys(mats, stone))
    else:
        wear.skin, wear.hair = skin_material(kit), hair_material(kit)
        wear.top = kit.material(pattern=rng.choice([PLAIN, PLAIN, STRIPES, CHECKER, DOTS]), frequency=rng.uniform(6, 16), gloss=0.04)
        wear.bottom, wear.shoes = kit.material(pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.04), kit.material(dark=kit.chance(0.7), pattern=PLAIN)
        wear.sleeve, wear.gloves = None, wear.skin
    wear.__dict__.update(more)
    wear.sleeve = wear.sleeve or wear.top
    return wear


def figure(kit, wear, legs="stand", arms="hang", lean=0.0, at=(0, 0, 0), size=1.0, robe=0.0, hands=None, look=None, hips=None, feet=None, flipped=None):
    """A smooth body of about 42 primitives; `robe`: height of a long skirt's hem in place of legs (0: none). Returns its frames."""
    rng, at = kit.rng, np.array(at, float)
    up, soles, knees = LEGS[legs]
    soles = feet or soles
    trunk, hips = turn("y", lean), np.array([0, 0, up] if hips is None else hips, float)
    flipped = kit.chance(0.5) if flipped is None else flipped
    hands = hands or ARMS[arms]
    if flipped:
        hands, soles = hands[::-1], soles[::-1]
    wide, r = wear.wide, (0.92 if wear.woman else 1.0)
    look = turn("z", rng.normal(0, 10)) @ turn("y", rng.normal(3, 4)) if look is None else look

    def place(p):
        return at + np.array(p, float) * size

    def high(*p):
        return hips + trunk @ np.array(p, float)

    def part(kind, p, half, material, taper=(1, 1), tilt=None, mirror=False):
        for side in (1, -1) if mirror else (1,):
            spun = np.eye(3) if tilt is None else tilt if side == 1 else FLIP @ tilt @ FLIP
            kit.add(kind, place(high(p[0], p[1] * side, p[2])), np.array(half) * size, taper, rotation=trunk @ spun, material=material)

    def limb(start, end, radius, taper, material):
        kit.between(place(start), place(end), np.array(radius) * size, CYL, taper, material)

    def ball(p, radius, material, frame=None):
        kit.add(BALL, place(p), np.broadcast_to(radius, 3) * size, rotation=frame, material=material)

    slim = 0.86 if wear.woman else 1.0
    part(BALL, (0, 0, 0.02), (0.118, 0.168 * wide, 0.13), wear.bottom)
    part(CYL, (0, 0, 0.19), (0.098 + wear.fat, 0.135 * wide * slim + wear.fat, 0.16), wear.top, (1.14 if not wear.fat else 1, 1))
    part(BALL, (0.015 + wear.fat / 2, 0, 0.15), (0.112 + wear.fat * 1.3, 0.15 * wide * slim + wear.fat, 0.16), wear.top)
    part(BALL, (0.01, 0, 0.36), (0.125, 0.172 * wide * r, 0.19), wear.top)
    part(BALL, (-0.005, 0, 0.495), (0.08, 0.195 * wide * r, 0.07), wear.top)
    part(CYL, (-0.005, 0, 0.555), (0.075, 0.13 * wide * r, 0.04), wear.top, (0.55, 1))
    if wear.woman:
        part(BALL, (0.085, 0.075, 0.36), (0.075, 0.078, 0.08), wear.top, mirror=True)
    for foot, side in zip(soles, (1, -1), strict=True):
        joint = high(0, side * 0.085 * wide, -0.02)
        knee, ankle = bent(joint, np.array(foot, float) * [1, side, 1], THIGH, SHIN, np.array(knees) * [1, side, 1] + [0, 0.15 * side, 0])
        toe = turn("z", side * 9) @ turn("y", 40 if ankle[2] > 0.095 and legs in ("run", "walk") else 70 if foot[0] < -0.36 and legs == "kneel" else 0)
        if not robe:
            thigh, shin = wear.bottom if wear.bare[1] < 2 else wear.skin, wear.skin if wear.bare[1] else wear.bottom
            ball(joint, 0.092 * wide, wear.bottom)
            limb(joint, knee, 0.092 * wide, 0.72, thigh)
            ball(knee, 0.067 * wide, thigh)
            limb(knee, ankle, 0.063 * wide, 0.66 if wear.bare[1] or wear.stone else wear.flare, shin)
            ball(ankle + (knee - ankle) * 0.62 - [0.012, 0, 0], (0.064 * wide, 0.06 * wide, 0.14), shin, towards(knee - ankle))
        if robe:
            limb(ankle, knee, 0.04, 1.2, wear.bottom if wear.stone else wear.skin)
        ball(ankle + toe @ np.array([0.065, 0, -0.03]), (0.13, 0.05, 0.04), wear.shoes, toe)
        if not robe or not wear.stone:
            ball(ankle + toe @ np.array([-0.015, 0, -0.015]), (0.055, 0.046, 0.055), wear.shoes, toe)
    if robe:
        skirt(kit, place(hips * [1, 1, 0]), size, hips[2] + 0.1, robe, wear.bottom)
    wrists = []
    for reach, side in zip(hands, (1, -1), strict=True):
        shoulder = high(0, side * 0.185 * wide * r, 0.485)
        out = 1.6 if arms == "hips" else 0.5
        elbow, wrist = bent(shoulder, high(reach[0], reach[1] * side, reach[2]), UPPER, FORE, np.array([-0.4, out * side, -0.6]))
        upper = wear.skin if wear.bare[0] == 2 else wear.sleeve
        fore, along = wear.skin if wear.bare[0] else wear.sleeve, towards(wrist - elbow)
        ball(shoulder, 0.066 * wide * r, wear.sleeve)
        limb(shoulder, elbow, 0.057 * wide * r, 0.78, upper)
        ball(elbow, 0.045 * wide * r, upper)
        limb(elbow, wrist, 0.044 * wide * r, 0.7, fore)
        ball(wrist + along @ np.array([0, 0, 0.045]), (0.04, 0.03, 0.075), wear.gloves, along)
        ball(wrist + along @ np.array([0.03, side * -0.008, 0.03]), (0.018, 0.016, 0.042), wear.gloves, along)
        wrists.append(wrist + along @ np.array([0, 0, 0.05]))
    half = 0.118 * wear.head
    centre = high(0.025, 0, 0.62) + trunk @ look @ np.array([0, 0, half * 1.0])
    limb(high(-0.005, 0, 0.5), centre, 0.053, 1, wear.skin)
    head = head_frame(kit, place(centre), half * size, trunk @ look)
    head(BALL, (-0.1, 0, 0.25), (0.82, 0.67, 0.75), wear.skin)
    head(BALL, (0.18, 0, -0.3), (0.56, 0.54, 0.7), wear.skin)
    bar(head, (0.68, 0, 0.1), (0.84, 0, -0.22), 0.1, wear.skin, 1.3)
    return SimpleNamespace(place=place, high=high, part=part, head=head, hands=wrists, trunk=trunk, size=size, hips=hips, limb=limb)


def face_on(kit, f, wear):
    """Eyes, mouth and ears, after all that matters more."""
    f.head(BALL, (-0.05, 0.66, -0.08), (0.16, 0.1, 0.24), wear.skin, mirror=True)
    if not wear.stone:
        f.head(BALL, (0.65, 0.26, 0.02), (0.07, 0.12, 0.08), plain(kit, [0.03, 0.02, 0.02], 0.4), mirror=True)
        f.head(BALL, (0.68, 0, -0.58), (0.07, 0.22, 0.05), plain(kit, [0.3, 0.08, 0.07]))


def skirt(kit, foot, size, waist, hem, material, wide=None):
    """A long skirt from the waist's height down to the hem's, with folds."""
    rng = kit.rng
    wide = wide or rng.uniform(0.22, 0.34)
    middle = hem + (waist - hem) * 0.6
    kit.loft(foot, [(hem * size, wide * size), (middle * size, (wide * 0.35 + 0.13) * size), (waist * size, 0.12 * size)], material, flat=1.08)
    for x, y in around(9, 1.0, rng.uniform(0, 40)):
        low = foot + np.array([x * wide * 0.97, y * wide * 1.04, hem + 0.002]) * size
        kit.between(low, foot + np.array([x * 0.13, y * 0.15, waist - 0.1]) * size, 0.06 * size, CYL, 0.3, material)
