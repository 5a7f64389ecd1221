"""Makers of large animals on four legs: elephants to cats, standing, walking, grazing, sitting, lying."""


import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, Head, bend, black, fur, hull, limb, looking, neck_turned, swung
from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, DOTS, PLAIN, SEAMS, SPECKLES, paint

# With the withers at 1: from hip to shoulder; radii of chest, belly and rump; how far the rump lies above the withers; width over
# depth; the neck's length, rise in degrees and radii; radius of the skull, length and end of the muzzle; radius of the legs;
# how far the head looks down in degrees.
SHAPES = {
    "elephant": (0.66, 0.34, 0.36, 0.32, -0.03, 0.8, 0.12, 30, 0.26, 0.22, 0.23, 0.05, 0.13, 0.1, 10),
    "rhinoceros": (0.9, 0.33, 0.36, 0.33, -0.02, 0.85, 0.3, -8, 0.27, 0.2, 0.17, 0.32, 0.1, 0.095, 25),
    "hippopotamus": (1.05, 0.4, 0.44, 0.4, 0.0, 0.9, 0.25, 2, 0.36, 0.29, 0.24, 0.32, 0.2, 0.12, 18),
    "giraffe": (0.5, 0.22, 0.2, 0.17, -0.14, 0.7, 0.95, 66, 0.15, 0.07, 0.08, 0.2, 0.04, 0.038, 28),
    "camel": (0.72, 0.22, 0.22, 0.18, -0.04, 0.8, 0.62, 42, 0.13, 0.08, 0.09, 0.2, 0.055, 0.046, 12),
    "horse": (0.74, 0.22, 0.21, 0.21, 0.01, 0.78, 0.46, 50, 0.17, 0.09, 0.1, 0.28, 0.06, 0.042, 48),
    "donkey": (0.76, 0.22, 0.23, 0.2, 0.01, 0.78, 0.38, 42, 0.16, 0.095, 0.115, 0.29, 0.065, 0.042, 45),
    "zebra": (0.74, 0.23, 0.23, 0.22, 0.01, 0.8, 0.4, 46, 0.17, 0.1, 0.105, 0.27, 0.06, 0.042, 45),
    "cow": (0.88, 0.28, 0.31, 0.24, 0.0, 0.78, 0.34, 14, 0.2, 0.14, 0.125, 0.27, 0.085, 0.05, 38),
    "bull": (0.86, 0.33, 0.31, 0.25, -0.04, 0.78, 0.3, 10, 0.27, 0.19, 0.14, 0.26, 0.09, 0.055, 38),
    "bison": (0.84, 0.37, 0.31, 0.22, -0.2, 0.72, 0.26, -22, 0.28, 0.2, 0.17, 0.22, 0.09, 0.05, 48),
    "pig": (0.95, 0.34, 0.37, 0.34, 0.0, 0.82, 0.2, 2, 0.29, 0.22, 0.2, 0.28, 0.1, 0.075, 15),
    "boar": (0.86, 0.38, 0.34, 0.27, -0.12, 0.68, 0.24, -10, 0.29, 0.2, 0.18, 0.36, 0.075, 0.055, 22),
    "sheep": (0.68, 0.3, 0.34, 0.31, 0.0, 0.9, 0.28, 42, 0.18, 0.12, 0.11, 0.17, 0.06, 0.04, 28),
    "goat": (0.76, 0.24, 0.27, 0.23, 0.0, 0.8, 0.38, 50, 0.14, 0.09, 0.1, 0.18, 0.05, 0.038, 30),
    "deer": (0.76, 0.2, 0.19, 0.18, 0.0, 0.75, 0.46, 58, 0.13, 0.075, 0.085, 0.19, 0.04, 0.03, 22),
    "lion": (0.98, 0.24, 0.21, 0.21, -0.02, 0.75, 0.26, 30, 0.2, 0.16, 0.165, 0.13, 0.09, 0.065, 10),
    "tiger": (1.02, 0.24, 0.22, 0.21, -0.03, 0.75, 0.26, 24, 0.19, 0.16, 0.165, 0.12, 0.09, 0.065, 10),
    "bear": (0.88, 0.33, 0.36, 0.34, -0.02, 0.85, 0.27, 8, 0.27, 0.21, 0.2, 0.2, 0.08, 0.1, 12),
    "dog": (0.8, 0.23, 0.19, 0.18, -0.01, 0.75, 0.3, 46, 0.15, 0.115, 0.13, 0.2, 0.055, 0.046, 10),
    "dachshund": (1.75, 0.34, 0.3, 0.29, -0.02, 0.85, 0.42, 48, 0.22, 0.17, 0.21, 0.32, 0.08, 0.075, 10),
    "greyhound": (0.82, 0.22, 0.135, 0.16, 0.0, 0.68, 0.36, 52, 0.11, 0.075, 0.09, 0.21, 0.032, 0.034, 12),
    "bulldog": (0.85, 0.36, 0.28, 0.24, -0.05, 0.95, 0.22, 35, 0.28, 0.24, 0.25, 0.1, 0.14, 0.08, 5),
    "wolf": (0.82, 0.24, 0.2, 0.18, -0.02, 0.75, 0.3, 28, 0.19, 0.14, 0.13, 0.22, 0.05, 0.044, 10),
    "cat": (1.0, 0.21, 0.21, 0.2, -0.01, 0.8, 0.2, 42, 0.15, 0.13, 0.17, 0.06, 0.08, 0.055, 5),
}
WALKS = ["stand", "walk", "stand", "walk", "graze"]
POSES = {
    **dict.fromkeys(["elephant", "rhinoceros", "hippopotamus", "boar", "wolf", "pig"], ["stand", "walk"]),
    "giraffe": ["stand", "walk"],
    "horse": ["stand", "walk", "gallop", "gallop", "graze", "rear"],
    "zebra": [*WALKS, "gallop"],
    "deer": [*WALKS, "gallop", "lie"],
    **dict.fromkeys(["lion", "tiger"], ["stand", "walk", "sit", "lie"]),
    "bear": ["stand", "walk", "upright", "sit"],
    **dict.fromkeys(["dog", "cat"], ["stand", "walk", "sit", "sit", "lie"]),
    **dict.fromkeys(["dachshund", "bulldog"], ["stand", "walk", "sit"]),
    "greyhound": ["stand", "walk", "gallop"],
    **dict.fromkeys(["cow", "camel"], [*WALKS, "lie"]),
}
HOOFED = {"giraffe", "camel", "horse", "donkey", "zebra", "cow", "bull", "bison", "pig", "boar", "sheep", "goat", "deer"}
HEAVY = {"elephant", "rhinoceros", "hippopotamus", "bear"}
CANINE = {"dog", "dachshund", "greyhound", "bulldog", "wolf"}
FELINE = {"lion", "tiger", "cat"}


def folded(kit, top, fore, radius, reach, coat, lower):
    """A leg of what lies: forearm or foot flat on the ground, pointing forwards."""
    x, y, _ = top
    out = np.sign(y) * radius
    if fore:
        hull(kit, [top, (x - 0.08 * reach, y + out, radius * 1.4), (x + 0.42 * reach, y + out, radius)], [radius * 1.6, radius * 1.3, radius], lower)
        kit.add(BALL, (x + 0.46 * reach, y + out, radius * 0.8), (radius * 1.6, radius * 1.15, radius * 0.8), material=lower)
    else:
        thigh = np.array([x + 0.1 * reach, y + out * 1.5, 0.27 * reach])
        kit.add(BALL, thigh, (0.32 * reach, radius * 1.8, 0.27 * reach), rotation=turn("y", 25), material=coat)
        hull(kit, [(x - 0.2 * reach, y + out * 2.2, radius), (x + 0.3 * reach, y + out * 2.6, radius * 0.9)], [radius * 1.1, radius * 0.9], lower)


def coats(kit, name):
    """Of a species: the coat, the legs', the muzzle's, the hair of mane and tail, and what lies on back and belly (or None)."""
    rng = kit.rng
    back = belly = None
    if name in ("elephant", "rhinoceros", "hippopotamus"):
        hide = fur(kit, GREY, (0.16, 0.14, 0.12), (0.3, 0.25, 0.2), gloss=0.1 if name != "hippopotamus" else 0.3)
        belly = fur(kit, PINK) if name == "hippopotamus" else None
        return hide, hide, belly or hide, fur(kit, DARK), None, belly
    if name == "giraffe":
        pattern, first, second = [(DOTS, CREAM, RED), (CAMOUFLAGE, CREAM, BROWN), (SEAMS, RED, CREAM)][rng.integers(3)]
        coat = fur(kit, first, pattern=pattern, frequency=rng.uniform(10, 17), second=second)
        return coat, coat if kit.chance(0.5) else fur(kit, CREAM), fur(kit, CREAM, TAN), fur(kit, BROWN), None, None
    if name == "zebra":
        coat = fur(kit, WHITE, pattern=BANDS, frequency=rng.uniform(20, 32), second=BLACK)
        return coat, coat, fur(kit, BLACK, DARK), coat, None, None
    if name == "tiger":
        coat = fur(kit, ORANGE, ORANGE, WHITE, pattern=BANDS, frequency=rng.uniform(20, 32), second=BLACK)
        return coat, coat, fur(kit, WHITE), coat, None, fur(kit, WHITE)
    if name in ("cow", "horse", "goat", "pig", "dog", "cat", "bulldog") and kit.chance(0.35):
        colours = [(BLACK, WHITE), (WHITE, BLACK), (RED, WHITE), (WHITE, BROWN), (TAN, WHITE), (PINK, BLACK) if name == "pig" else (BROWN, CREAM)]
        first, second = colours[rng.integers(len(colours))]
        coat = fur(kit, first, pattern=CAMOUFLAGE, frequency=rng.uniform(6, 13), second=second)
        return coat, fur(kit, second, first), fur(kit, second, WHITE, PINK), fur(kit, first, second), None, None
    if name == "cat" and kit.chance(0.45):
        coat = fur(kit, ORANGE, GREY, TAN, pattern=BANDS, frequency=rng.uniform(24, 38), second=DARK if kit.chance(0.6) else RED)
        return coat, coat, fur(kit, WHITE, CREAM), coat, None, fur(kit, WHITE, CREAM)
    if name == "deer":
        pattern, second = (SPECKLES, WHITE) if kit.chance(0.3) else (CLOUDY, BROWN)
        coat = fur(kit, TAN, RED, BROWN, pattern=pattern, frequency=rng.uniform(9, 14), second=second)
        return coat, coat._replace(pattern=CLOUDY), fur(kit, BROWN, CREAM), fur(kit, WHITE, CREAM), None, fur(kit, CREAM)
    choices = {
        "camel": [TAN, CREAM, BROWN],
        "horse": [BROWN, RED, BLACK, DARK, WHITE, GREY, TAN, RED],
        "donkey": [GREY, (0.3, 0.27, 0.23), BROWN],
        "bison": [DARK, BROWN],
        "pig": [PINK, PINK, BLACK, RED],
        "boar": [DARK, (0.1, 0.08, 0.06)],
        "sheep": [WHITE, WHITE, CREAM, DARK],
        "lion": [TAN, CREAM, (0.5, 0.32, 0.13)],
        "bear": [BROWN, DARK, BLACK, WHITE, RED],
        "wolf": [GREY, (0.35, 0.3, 0.25), WHITE, BLACK],
        "cat": [BLACK, GREY, WHITE, ORANGE, CREAM],
    }
    coat = fur(kit, *choices.get(name, [BLACK, BROWN, RED, TAN, WHITE, CREAM, GREY, DARK]))
    lower = muzzle = hair = coat
    if name in ("horse", "donkey", "camel", "cow", "bull", "goat", "bison", "lion"):
        hair = fur(kit, BLACK, DARK, BROWN, CREAM if name == "horse" else RED) if kit.chance(0.75) else coat
    if name == "horse":
        lower = fur(kit, BLACK, WHITE) if kit.chance(0.5) else coat
        muzzle = fur(kit, GREY, BLACK) if kit.chance(0.4) else coat
    elif name == "sheep":
        lower = muzzle = fur(kit, BLACK, DARK, WHITE, CREAM)
    elif name in ("cow", "bull", "donkey", "goat"):
        lower = fur(kit, WHITE, DARK) if kit.chance(0.4) else coat
        muzzle = fur(kit, WHITE, CREAM, GREY) if kit.chance(0.5) else coat
    elif name == "bear":
        muzzle = fur(kit, TAN, CREAM) if kit.chance(0.6) else coat
    elif name == "lion":
        muzzle = belly = fur(kit, CREAM, WHITE)
    elif name in ("dog", "dachshund", "greyhound", "bulldog", "wolf", "cat"):
        pale = fur(kit, WHITE, CREAM, TAN)
        lower = pale if kit.chance(0.35) else coat
        muzzle = pale if kit.chance(0.5) or name == "wolf" else coat
        belly = pale if kit.chance(0.4) or name == "wolf" else None
        back = fur(kit, BLACK, DARK, GREY) if kit.chance(0.3) else None
    return coat, lower, muzzle, hair, back, belly


def trunk_and_tusks(kit, head, hide):
    """An elephant's: trunk in a curve, tusks, great ears like fans."""
    rng = kit.rng
    size = head.size
    head.ball((0.05, 0, 0.35), (0.9, 0.9, 0.85), hide)
    curl = rng.choice(["hang", "hang", "forward", "raised"])
    ways = {
        "hang": [(0.7, 0, -0.2), (1.15, 0, -1.0), (1.15, 0, -2.0), (1.25, 0, -2.8)],
        "forward": [(0.7, 0, -0.2), (1.2, 0, -1.0), (1.3, 0, -1.9), (1.9, 0, -2.3), (2.3, 0, -1.9)],
        "raised": [(0.7, 0, -0.2), (1.4, 0, -0.7), (2.1, 0, -0.3), (2.5, 0, 0.6), (2.9, 0, 0.9)],
    }
    path = [head.place(*p) for p in ways[curl]]
    hull(kit, path, np.linspace(0.46, 0.19, len(path)) * size, hide, first=False)
    large = rng.uniform(0.75, 1.15)
    for side in (1, -1):
        fan = head.facing @ turn("z", -48 * side) @ turn("x", 8 * side)
        kit.add(BALL, head.place(-0.35, (0.85 + 0.35 * large) * side, -0.15), np.array([0.75 * large, 0.09, 1.05 * large]) * size, rotation=fan, material=hide)
    if kit.chance(0.75):
        far = rng.uniform(0.5, 1.2)
        ivory = kit.material(base=[0.75, 0.68, 0.52], pattern=PLAIN, gloss=0.3)
        head.rods([(0.7, 0.4, -0.6), (1.1 + 0.3 * far, 0.55, -1.1), (1.3 + far, 0.5, -1.05 + 0.2 * far)], [0.12, 0.1, 0.04], ivory)
    head.eyes(0.72, 0.66, 0.1, 0.08)


def horns(kit, head, name):
    """Cattle's, goats', rams' in a coil, antlers, a giraffe's knobs, a rhinoceros' on the nose."""
    rng = kit.rng
    horn = fur(kit, (0.3, 0.24, 0.17), DARK, CREAM, pattern=PLAIN, gloss=0.15)
    if name == "bison":
        head.rods([(0, 0.75, 0.6), (0.1, 1.35, 1.2)], [0.24, 0.06], horn)
    elif name in ("cow", "bull"):
        wide, up = rng.uniform(0.4, 1.0), rng.uniform(0.3, 1.1)
        head.rods([(0, 0.55, 0.75), (0.05, 0.9 + wide, 0.9), (0.3, 1.0 + wide, 0.9 + up)], [0.22, 0.16, 0.05], horn)
    elif name == "goat":
        far = rng.uniform(0.7, 1.4)
        head.rods([(0.1, 0.35, 0.8), (-0.1, 0.5, 0.9 + far), (-0.2 - far, 0.75, 1.1 + far)], [0.22, 0.17, 0.05], horn)
    elif name == "sheep":
        head.rods([(0, 0.5, 0.75), (-0.7, 1.1, 0.5), (-0.3, 1.3, -0.45), (0.5, 1.4, 0.0)], [0.34, 0.3, 0.22, 0.08], horn)
    elif name == "deer":
        far = rng.uniform(1.5, 2.6)
        beam = [(-0.1, 0.35, 0.8), (-0.6, 0.6 + 0.35 * far, 0.8 + 0.5 * far), (-0.2, 0.6 + 0.5 * far, 0.8 + 1.2 * far)]
        head.rods(beam, [0.17, 0.14, 0.06], horn)
        for side in (1, -1):
            for share, ahead, up in ((0.15, 0.8, 0.5), (0.6, 0.6, 0.7)):
                low, high = np.array(beam[0]), np.array(beam[1])
                root = low + (high - low) * share * 2 if share <= 0.5 else high + (np.array(beam[2]) - high) * (share * 2 - 1)
                tip = root + [ahead, 0.1, up]
                kit.between(head.place(root[0], root[1] * side, root[2]), head.place(tip[0], tip[1] * side, tip[2]), 0.11 * head.size, taper=0.3, material=horn)
    elif name == "giraffe":
        head.rods([(-0.1, 0.35, 0.6), (-0.35, 0.5, 1.7)], [0.17, 0.2], fur(kit, BROWN, DARK))


def beast_head(kit, name, head, long, nose, coat, muzzle, hair):
    """Muzzle, ears, horns and eyes of a species."""
    rng = kit.rng
    size = head.size
    far = long / size
    end = nose / size
    inner = None if name in ("cow", "bull", "bison", "sheep", "deer") else fur(kit, PINK, CREAM, pattern=PLAIN)
    wide = 1.0 if name in FELINE or name in ("bear", "bulldog", "pig") else 0.82
    head.ball((0, 0, 0), (1.1, wide, 1), coat)
    tip = (0.75 + far, 0, -0.3 if name in HOOFED else -0.28)
    if name == "elephant":
        trunk_and_tusks(kit, head, coat)
        return
    if name in FELINE:
        head.ball((0.75 + far * 0.35, 0, -0.25), (0.35 + far * 0.5, 0.62, 0.45), muzzle)
        head.ball((0.65, 0, 0.08), (0.5 + far * 0.5, 0.3, 0.3), coat)
        head.ball((1.0 + far * 0.75, 0, -0.08), (0.13, 0.17, 0.1), fur(kit, PINK, BLACK, pattern=PLAIN, gloss=0.3))
        head.ball((0.2, 0, -0.55), (0.75, 0.55, 0.4), muzzle)
        kind = "prick" if name == "cat" else "round"
        head.ear(kind, rng.uniform(0.5, 0.7) if name == "cat" else 0.72, coat, inner if name == "cat" else muzzle)
        iris = kit.material(base=paint(rng.choice([0.13, 0.22, 0.3, 0.55]), 0.8, 0.6), pattern=PLAIN, gloss=0.6)
        head.eyes(0.87, 0.46, 0.25, 0.13, iris)
        return
    lower = [0.62, 0.7, 0.5, 0.62][rng.integers(4)] if name in CANINE else 0.78
    hull(kit, [head.place(0.35, 0, -0.12), head.place(*tip)], [size * lower, nose], muzzle if name in CANINE else coat, 0.85, first=False)
    if name in ("horse", "donkey", "zebra", "cow", "bull", "camel", "giraffe", "goat", "deer", "sheep", "bison"):
        head.ball((0.3, 0, -0.42), (0.75, 0.6, 0.72), coat)
        head.ball((tip[0], 0, tip[2] - 0.08), (end * 1.2, end * 1.02, end * 1.08), muzzle)
        dark = fur(kit, BLACK, DARK) if name not in ("cow", "bull") else fur(kit, PINK, BLACK, gloss=0.2)
        if name in ("cow", "bull", "bison", "deer"):
            head.ball((tip[0] + end * 0.62, 0, tip[2] + 0.08), (end * 0.65, end * 0.8, end * 0.6), dark)
        else:
            head.ball((tip[0] + end * 0.85, end * 0.5, tip[2] + 0.1), (end * 0.25, end * 0.25, end * 0.25), dark, True)
    if name in ("horse", "cow") and kit.chance(0.4):
        head.ball((0.55 + far * 0.35, 0, 0.22 - 0.05 * far), (0.45 + far * 0.45, 0.22, 0.42), fur(kit, WHITE), tilt=(0, -14))
    if name == "rhinoceros":
        horn = fur(kit, GREY, DARK, pattern=PLAIN)
        head.ball((0.3, 0, -0.4), (0.85, 0.75, 0.7), coat)
        head.ball((tip[0], 0, tip[2] - 0.1), (end * 1.15, end * 1.25, end * 1.2), coat)
        high = rng.uniform(1.2, 2.4)
        head.rods([(tip[0] + 0.1, 0, tip[2] + 0.3), (tip[0] + 0.45, 0, tip[2] + 0.3 + high * 0.6), (tip[0] + 0.4, 0, tip[2] + 0.3 + high)], [0.36, 0.2, 0.05], horn, both=False)
        if kit.chance(0.8):
            head.rods([(tip[0] - 0.65, 0, 0.1), (tip[0] - 0.5, 0, 0.4 + high * 0.35)], [0.32, 0.07], horn, both=False)
        head.ear("leaf", 0.6, coat)
    elif name == "hippopotamus":
        head.ball((tip[0] - 0.1, 0.28, tip[2]), (end * 0.8, end * 0.75, end * 0.92), coat, True)
        head.ball((tip[0] - 0.5, 0, tip[2] - 0.42), (1.0, 0.75, 0.42), muzzle)
        head.ball((tip[0] + 0.25, 0.3, tip[2] + end * 0.75), (0.14, 0.14, 0.14), fur(kit, DARK), True)
        head.ball((0.3, 0.5, 0.72), (0.27, 0.22, 0.25), coat, True)
        head.ear("round", 0.5, coat)
    elif name in ("pig", "boar"):
        head.ball((0.15, 0, -0.35), (0.85, 0.85, 0.75), coat)
        snout = fur(kit, PINK, DARK if name == "boar" else PINK, pattern=PLAIN, gloss=0.1)
        kit.between(head.place(tip[0] - 0.2, 0, tip[2]), head.place(tip[0] + end * 0.95, 0, tip[2] + 0.03), nose * 1.05, CYL, 1.12, snout)
        head.ball((tip[0] + end * 0.95, end * 0.45, tip[2] + 0.05), (0.05, 0.09, 0.13), black(kit), True)
        head.ear("prick" if name == "boar" or kit.chance(0.5) else "flop", rng.uniform(0.5, 0.8), coat, inner)
        if name == "boar":
            head.rods([(tip[0] - 0.3, 0.35, tip[2] - 0.2), (tip[0] - 0.1, 0.6, tip[2] + 0.4)], [0.09, 0.03], fur(kit, WHITE))
    elif name == "bear":
        head.ball((tip[0] - 0.3, 0, tip[2]), (end * 1.3, end * 1.15, end), muzzle)
        head.ball((tip[0] + end * 0.75, 0, tip[2] + 0.1), (0.16, 0.2, 0.15), black(kit))
        head.ear("round", 0.68, coat, inner if kit.chance(0.4) else None)
    elif name in CANINE:
        head.ball((tip[0] + end * 0.75, 0, tip[2] + end * 0.35), (0.17, 0.21, 0.17), black(kit))
        if name == "bulldog":
            head.ball((tip[0] - 0.15, 0.33, tip[2] - 0.25), (0.4, 0.3, 0.42), muzzle, True)
        elif kit.chance(0.5) and name != "wolf":
            head.ball((tip[0] - 0.1, 0, tip[2] - end * 1.1), (0.3, 0.16, 0.09), kit.material(base=[0.55, 0.16, 0.15], pattern=PLAIN, gloss=0.3))
        ear = {"dachshund": "flop", "bulldog": rng.choice(["prick", "flop"]), "greyhound": "flop", "wolf": "prick"}.get(name, rng.choice(["prick", "flop"]))
        small = 0.5 if name in ("greyhound", "bulldog") else 0.65
        head.ear(ear, rng.uniform(0.9, 1.3) * small * (1.4 if name == "dachshund" else 1), coat if kit.chance(0.6) else hair, inner)
    else:
        ears = {"donkey": ("leaf", 1.3), "horse": ("leaf", 0.5), "zebra": ("leaf", 0.65), "deer": ("side", 0.9), "goat": ("side", 0.9), "camel": ("leaf", 0.35)}
        head.ear(*ears.get(name, ("side", rng.uniform(0.6, 0.9))), coat, inner)
        chance = {"cow": 0.6, "bull": 0.9, "sheep": 0.3, "deer": 0.75, "goat": 0.85}.get(name, 1)
        if kit.chance(chance):
            horns(kit, head, name)
        if name == "goat" and kit.chance(0.7):
            head.ball((tip[0] - 0.2, 0, tip[2] - 0.85), (0.2, 0.16, 0.5), hair)
        if name in ("horse", "donkey") and kit.chance(0.6):
            head.ball((0.35, 0, 0.75), (0.55, 0.3, 0.42), hair)
    side = {"hippopotamus": (0.5, 0.5, 0.85), "rhinoceros": (0.7, 0.68, 0.15), "bear": (0.85, 0.45, 0.28), "bulldog": (0.88, 0.5, 0.2)}
    head.eyes(*side.get(name, (0.82, 0.5, 0.28) if name in CANINE else (0.52, 0.7, 0.22)), 0.1 if name in HEAVY else 0.14)


def beast(kit):
    """Elephants, rhinoceroses, hippopotamuses, giraffes, camels, horses, donkeys, zebras, cattle, bison, pigs, sheep, goats, deer,
    big cats, bears, dogs of many breeds, wolves, cats: they stand, walk, gallop, graze, rear, sit, lie, beg, arch their backs."""
    rng = kit.rng
    often = {"horse": 3, "dog": 3, "cat": 3, "elephant": 2, "cow": 2, "lion": 2, "bear": 2}
    weights = np.array([often.get(n, 1) for n in SHAPES], float)
    name = str(rng.choice(list(SHAPES), p=weights / weights.sum()))
    shape = np.array(SHAPES[name])
    shape[[0, 1, 2, 3, 5, 6, 8, 9, 10, 11, 12, 13]] *= np.exp(rng.normal(0, 0.055, 12))
    length, chest, belly, rump, sink, flat, neck, rise, neck0, neck1, skull, long, nose, leg, down = shape
    if name == "dog":
        neck0, skull, long, leg = neck0 * rng.uniform(0.9, 1.3), skull * rng.uniform(0.85, 1.2), long * rng.uniform(0.7, 1.3), leg * rng.uniform(0.8, 1.25)
    pose = str(rng.choice(POSES.get(name, WALKS)))
    coat, lower, muzzle, hair, back, under = coats(kit, name)
    male = kit.chance(0.6)
    young = kit.chance(0.12) and name in ("horse", "cow", "deer", "elephant", "lion")
    if young:
        skull, long, nose, neck, leg = skull * 1.3, long * 0.95, nose * 1.15, neck * 0.85, leg * 1.1
        chest, belly, rump, length = chest * 0.85, belly * 0.85, rump * 0.85, length * 0.85
    if name == "dog" and kit.chance(0.15):
        pose = "beg"

    hip, shoulder = np.array([-length / 2, 0, 1 + sink - rump]), np.array([length / 2, 0, 1 - chest])
    reach = hip[2], shoulder[2]
    pitch = {"rear": rng.uniform(38, 58), "sit": rng.uniform(42, 56), "upright": rng.uniform(68, 80), "beg": rng.uniform(62, 74), "gallop": rng.uniform(-7, 7)}
    pitch = pitch.get(pose, 0.0)
    if name == "dachshund":
        pitch *= 0.6
    if pose in ("sit", "beg"):
        hip[2] = rump * 0.98
        shoulder[2] = rump * 0.98 + 0.02
    elif pose == "lie":
        hip[2], shoulder[2] = rump * 0.95, max(chest, belly * 0.95)
    tilt = turn("y", -pitch)

    def place(point):
        """Where a point of the level body goes as the body turns about the hip."""
        return hip + tilt @ (np.array(point, float) - hip)

    arched = name == "cat" and pose in ("stand", "walk") and kit.chance(0.35)
    middle = (hip + shoulder) / 2
    middle[2] += max(chest, rump) - belly - 0.025 + (0.28 if arched else 0)
    if name == "greyhound":
        middle = hip * 0.6 + shoulder * 0.4 + [0, 0, 0.06]
    spine = [place(hip), place(middle), place(shoulder)]
    if name == "sheep" and pose != "lie":
        wool = coat._replace(pattern=SPECKLES, frequency=22.0)
        hull(kit, spine, [rump, belly, chest], wool, flat)
        for x, y, z in ((-0.45, 0.5, 0.3), (0.45, 0.5, 0.3), (0.0, 0.6, 0.05)):
            kit.add(BALL, hip * 0.5 + shoulder * 0.5 + [x * length, y * belly, z * belly], (belly * 0.55,) * 3, material=wool, mirror=True)
    else:
        hull(kit, spine, [rump, belly, chest], coat, [flat, flat * 1.08, flat])
    slope = turn("y", -pitch - np.degrees(np.arctan2(shoulder[2] - hip[2], length)))
    if under:
        kit.add(BALL, place(middle - [0, 0, belly * 0.5]), (length * 0.52, belly * flat * 0.85, belly * 0.54), rotation=slope, material=under)
    if back:
        kit.add(BALL, place((hip + shoulder) / 2 + [0, 0, rump * 0.55]), (length * 0.66, rump * flat * 0.95, rump * 0.52), rotation=slope, material=back)
    if name == "bison" or name == "bull" and kit.chance(0.5):
        kit.add(BALL, place(shoulder + [-0.1, 0, chest * 0.3]), (0.34, chest * 0.55, chest * 0.95), material=hair if name == "bison" else coat)
    if name == "bison":
        kit.add(BALL, place(shoulder + [0.1, 0, -chest * 0.35]), (chest * 0.8, chest * 0.66, chest * 0.95), material=hair)
    if name == "camel":
        for x in (-0.22, 0.22) if kit.chance(0.5) else (0.0,):
            high = rng.uniform(0.26, 0.36)
            kit.add(BALL, middle + [x * length / 0.7, 0, belly * 0.95], (0.13 if x else 0.2, 0.12, high * 0.85), material=hair if kit.chance(0.4) else coat)

    # Neck and head.
    if pose == "graze":
        rise, down = -rng.uniform(38, 52), rng.uniform(55, 75)
        root_z = shoulder[2] + 0.05
        neck = max(neck, (root_z - 0.28 - long * 0.8) / np.sin(np.radians(-rise)))
    elif pose in ("sit", "lie", "beg", "upright"):
        rise = max(rise, rng.uniform(50, 75))
    elif pose == "rear":
        rise = rise + 15
    else:
        rise = rise + rng.normal(0, 8)
    aim = turn("y", -rise) @ np.array([1.0, 0, 0])
    start = place(shoulder + [chest * 0.35, 0, chest * 0.3])
    stop = start + neck * aim + [0, rng.normal(0, 0.06) * neck, 0]
    if name == "camel" and pose != "graze":
        path = bend(start - [0, 0, 0.05], start + [neck * 0.75, 0, -0.1], stop, 4)
    else:
        path = bend(start, start * 0.45 + stop * 0.55 + [0, 0, 0.03 * neck], stop, 2 if name == "sheep" else 3)
    supple = name in ("giraffe", "camel", "horse", "zebra", "deer", "goat", "cat", "dog")
    yaw = neck_turned(kit, 25 if name in HEAVY else 40 if pose == "graze" else 80 if supple else 55)
    path = swung(path, yaw)
    hull(kit, [place(shoulder), *path], np.interp(np.linspace(-0.4, 1, len(path) + 1), [-0.4, 0, 1], [chest * 0.9, neck0, neck1]), coat, 0.8, first=False)
    facing = turn("z", yaw) @ looking(kit, down if pose != "rear" else 20, 22)
    at = path[-1] + facing @ np.array([skull * 0.35, 0, 0]) + [0, 0, skull * 0.25]
    head = Head(kit, at, facing, skull)
    if name == "lion" and male and not young:
        head.ball((-0.45, 0, -0.1), (0.95, 1.55, 1.6), hair)
        head.ball((-1.0, 0, -0.75), (1.3, 1.45, 1.6), hair)
        head.ball((0.1, 0, -0.9), (0.7, 0.7, 0.75), hair)
    elif name == "bison":
        head.ball((-0.1, 0, 0.3), (0.9, 1.0, 0.95), hair)
        head.ball((0.5, 0, -1.0), (0.5, 0.4, 0.7), hair)
    beast_head(kit, name, head, long, nose, coat, muzzle, hair)

    # Legs.
    end = "hoof" if name in HOOFED else "pad" if name in HEAVY - {"bear"} else "paw"
    heavy = name in HEAVY or name in ("pig", "bulldog", "sheep")
    aside = (chest * flat - leg * 1.1) * 0.85
    stride = {"walk": rng.uniform(0.14, 0.26), "stand": rng.uniform(0, 0.05)}.get(pose, 0.0) * reach[1] * (0.7 if heavy else 1)
    gather = kit.chance(0.5)
    for side in (1, -1):
        top = place(shoulder + [-0.02, side * aside, -chest * 0.2])
        foot = np.array([top[0] + 0.02 + side * stride, top[1], 0.0])
        if pose == "walk" and side > 0 and not heavy:
            foot[2] = 0.08
        elif pose == "gallop":
            foot = top + [(-0.1 if gather else 0.5) + 0.15 * side, 0, -reach[1] * (0.62 if gather else 0.78)]
        elif pose == "rear":
            foot = top + [0.3 + 0.06 * side, 0, -0.3 - 0.08 * side]
        elif pose in ("beg", "upright"):
            foot = top + [0.34 if pose == "beg" else 0.22, 0, -0.28 if pose == "beg" else -0.6 * reach[1]]
        if pose == "lie":
            folded(kit, top, True, leg, reach[1], coat, lower)
        else:
            limb(kit, top, foot, True, reach[1] * 0.97, leg, coat, lower, end, heavy)
        top = place(hip + [0, side * aside, -rump * 0.05])
        foot = np.array([top[0] - 0.04 - side * stride, top[1], 0.0])
        if pose == "gallop":
            foot = top + [(0.22 if gather else -0.5) + 0.12 * side, 0, -reach[0] * (0.85 if gather else 0.7)]
        elif pose in ("rear", "upright"):
            foot = top + [0.1 + 0.05 * side, 0, -reach[0] * 0.93]
        if pose in ("lie", "sit", "beg"):
            folded(kit, top, False, leg, reach[0] * 0.85, coat, lower)
        else:
            limb(kit, top, foot, False, reach[0] * 0.97, leg, coat, lower, end, heavy)

    # Tail and mane.
    root = place(hip + [-rump * 0.85, 0, rump * 0.45])
    if name == "horse":
        fly = 0.45 if pose in ("gallop", "rear") else 0.1
        hull(kit, bend(root, root + [-fly - 0.12, 0, 0.05], root + [-fly - 0.1, 0, -0.5 + fly], 3), [0.05, 0.075, 0.03], hair)
        for k in np.linspace(0.1, 0.9, 4):
            normal, turned = np.array([-aim[2], 0, aim[0]]), turn("z", yaw * k)
            width = neck0 + (neck1 - neck0) * k
            point = start + turned @ ((stop - start) * k + normal * width * 0.72)
            kit.add(BALL, point, (neck * 0.2, 0.035, width * 0.55), rotation=turned @ turn("y", -rise), material=hair)
    elif name in ("donkey", "zebra", "cow", "bull", "giraffe", "bison", "elephant", "rhinoceros", "lion", "hippopotamus"):
        drop = 0.5 if name not in ("hippopotamus", "rhinoceros") else 0.28
        tip = root + [-0.12, rng.normal(0, 0.05), -drop if pose != "lie" else -hip[2] - rump * 0.3]
        if name == "lion":
            tip = root + [-0.45, 0, -0.25]
        kit.chain(bend(root, root + [-0.14, 0, 0], tip, 3), [leg * 0.55, leg * 0.38, leg * 0.35], coat)
        kit.add(BALL, tip, (0.035, 0.035, 0.08), material=hair)
        if name in ("donkey", "zebra", "giraffe"):
            normal = np.array([-aim[2], 0, aim[0]])
            kit.between(path[0] + normal * neck0 * 0.8, path[-1] + turn("z", yaw) @ normal * neck1 * 0.85, (0.05, 0.022), BOX, 0.8, hair)
    elif name in CANINE | {"cat", "tiger"}:
        style = rng.choice(["up", "down", "curl", "straight"]) if name in ("dog", "cat") else rng.choice(["down", "straight"])
        far = {"bulldog": 0.15, "cat": 0.75, "tiger": 0.75}.get(name, rng.uniform(0.4, 0.6))
        thick = leg * rng.uniform(0.6, 1.0) * (1.7 if name == "wolf" or name == "dog" and kit.chance(0.35) else 1)
        if pose in ("sit", "lie", "beg"):
            path = bend((root[0] + 0.02, 0, thick + rump * 0.3), (root[0] - far * 0.5, 0, thick * 0.5), (root[0] - far * 0.6, far * rng.choice([-0.6, 0.6]), thick), 4)
        elif style == "up" or arched:
            path = bend(root, root + [-far * 0.5, 0, far * 0.2], root + [-far * 0.3, 0, far], 4)
        elif style == "curl" and name == "dog":
            path = [root, root + [-0.12, 0, 0.14], root + [-0.04, 0.03, 0.25], root + [0.1, 0.05, 0.2]]
        else:
            path = bend(root, root + [-far * 0.5, 0, 0], root + [-far * 0.75, 0, -far * (0.7 if style == "down" else 0.15)], 4)
        hull(kit, path, [thick * 0.9, thick, thick, thick * 0.6], coat)
    elif name in ("pig", "boar"):
        kit.chain([root, root + [-0.06, 0.03, 0.03], root + [-0.08, -0.03, 0.07]], 0.018, coat)
    else:
        kit.add(BALL, root + [-0.04, 0, -0.03], (0.07, 0.05, 0.1), rotation=turn("y", 25), material=hair if name == "deer" else coat)
    if name == "cow" and pose != "lie":
        kit.add(BALL, (-length * 0.3, 0, middle[2] - belly * 0.92), (0.13, 0.11, 0.1), material=fur(kit, PINK, pattern=PLAIN))
    if name in ("horse", "camel", "donkey") and kit.chance(0.2) and pose != "lie":
        kit.add(BALL, place(middle + [0.05, 0, belly * 0.55]), (0.17, belly * flat * 1.07, belly * 0.6), material=kit.material(base=BROWN if kit.chance(0.5) else None, gloss=0.2))
    if name in CANINE and kit.chance(0.4):
        kit.between(path[0] * 0.35 + path[-1] * 0.65, path[0] * 0.2 + path[-1] * 0.8, neck1 * 1.12, material=kit.material(gloss=0.2))
