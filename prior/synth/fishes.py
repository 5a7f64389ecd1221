"""Makers of fish, sharks, rays, dolphins and whales."""

import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, TAN, WHITE, bend, black, hull
from .birds import membrane, sail
from .hides import GOLD, SILVER, SLATE, skin
from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, PLAIN, RIBS, SPECKLES, STRIPES

FISHES = {  # half length, half height, half width, colours
    "tuna": (0.8, 0.24, 0.17, [(SLATE, SILVER), ((0.03, 0.08, 0.2), WHITE)]),
    "trout": (0.8, 0.19, 0.12, [((0.25, 0.2, 0.08), CREAM), (GREY, PINK), (SILVER, WHITE)]),
    "carp": (0.7, 0.26, 0.18, [(GOLD, CREAM), (WHITE, ORANGE), (ORANGE, WHITE)]),
    "goldfish": (0.5, 0.26, 0.19, [((0.75, 0.22, 0.02), GOLD), (WHITE, ORANGE)]),
    "clown": (0.52, 0.24, 0.13, [((0.75, 0.2, 0.01), WHITE)]),
    "angel": (0.42, 0.4, 0.08, [(GOLD, BLACK), ((0.05, 0.15, 0.5), GOLD), (SILVER, BLACK)]),
    "pike": (1.0, 0.15, 0.11, [((0.12, 0.16, 0.04), CREAM)]),
    "puffer": (0.42, 0.34, 0.33, [(TAN, WHITE), (GOLD, WHITE)]),
}


def fish(kit):
    rng = kit.rng
    name = str(rng.choice(list(FISHES)))
    long, high, wide, colours = FISHES[name]
    long, high, wide = np.array([long, high, wide]) * np.exp(rng.normal(0, 0.08, 3))
    first, second = colours[rng.integers(len(colours))]
    marks = {"clown": (BANDS, 5.5), "angel": (BANDS, rng.uniform(6, 9)), "trout": (SPECKLES, 16), "puffer": (SPECKLES, 12), "carp": (CAMOUFLAGE, 6), "pike": (SPECKLES, 14)}
    pattern, frequency = marks.get(name, (CLOUDY, 8))
    coat = skin(kit, first, pattern=pattern, frequency=frequency, second=second if name not in ("trout", "pike", "puffer") else DARK if name != "pike" else CREAM)
    belly = skin(kit, second) if name in ("tuna", "trout", "pike", "puffer") else None
    fin = skin(kit, first, second, pattern=STRIPES, frequency=20, second=np.array(first) * 0.5)
    points = np.array([(-0.98, 0, 0), (-0.6, 0, 0), (-0.1, 0, 0), (0.35, 0, 0), (0.75, 0, -0.02)]) * [long, 1, high]
    hull(kit, points, np.array([0.2, 0.58, 0.98, 0.95, 0.55]) * high, coat, wide / high)
    kit.add(BALL, (0.62 * long, 0, -0.05 * high), (0.38 * long, wide * 0.66, high * 0.52), material=coat)
    if belly:
        kit.add(BALL, (0.12 * long, 0, -0.3 * high), (0.78 * long, wide * 0.94, high * 0.74), material=belly)
    fork = {"tuna": 1.25, "angel": 0.8, "goldfish": 1.15}.get(name, 0.8) * (high if name != "pike" else high * 1.4)
    for way in (1, -1):
        sail(kit, (-1.0 * long - fork * (0.65 if name == "tuna" else 0.9), 0, way * fork), (-0.9 * long, 0, way * 0.14 * high), (-1.0 * long - fork * 0.35, 0, 0), 0.014, fin)
    tall = {"angel": 1.0, "tuna": 0.5, "pike": 0.7, "puffer": 0.25}.get(name, 0.5) * high
    back = -0.55 if name == "pike" else -0.1
    kit.add(
        BOX,
        (back * long, 0, high * (1.0 if name != "pike" else 0.75) + tall * 0.3),
        (long * (0.38 if name not in ("pike", "tuna") else 0.16), 0.012, tall * 0.65),
        (0.5, 1),
        (-long * 0.2, 0),
        material=fin,
    )
    sail(kit, (-0.6 * long, 0, -high * 0.7 - tall * 0.8), (-0.2 * long, 0, -high * 0.75), (-0.62 * long, 0, -high * 0.45), 0.012, fin)
    sail(kit, (0.05 * long, wide * 1.9, -high * 0.6), (0.42 * long, wide * 0.8, -high * 0.15), (0.28 * long, wide * 0.85, -high * 0.45), 0.01, fin, mirror=True)
    sail(kit, (0.0, wide * 0.7, -high * 1.35), (0.25 * long, wide * 0.4, -high * 0.8), (0.08 * long, wide * 0.4, -high * 0.85), 0.01, fin, mirror=True)
    eye = np.array([0.7 * long, wide * 0.56, high * 0.16])
    kit.add(BALL, eye, (high * 0.13, wide * 0.12, high * 0.13), material=skin(kit, WHITE, GOLD, pattern=PLAIN, gloss=0.5), mirror=True)
    kit.add(BALL, eye + [0, wide * 0.08, 0], (high * 0.08, wide * 0.08, high * 0.08), material=black(kit), mirror=True)
    kit.add(BALL, (0.98 * long, 0, -0.12 * high), (0.06 * long, wide * 0.25, high * 0.1), material=belly or fin)
    kit.add(BALL, (0.42 * long, 0, 0), (0.02, wide * 0.99, high * 0.7), material=coat._replace(first=coat.first * 0.7, pattern=PLAIN))


def sea_giant(kit):
    """Sharks, hammerheads, dolphins, orcas, humpback and sperm whales."""
    rng = kit.rng
    name = str(rng.choice(["shark", "hammerhead", "dolphin", "orca", "humpback", "sperm"]))
    fish_like = name in ("shark", "hammerhead")
    back = skin(
        kit,
        *{"dolphin": (SLATE, GREY), "orca": (BLACK,), "humpback": (SLATE,), "sperm": (GREY, SLATE)}.get(name, (GREY, (0.2, 0.25, 0.3))),
        pattern=rng.choice([PLAIN, CLOUDY]),
        gloss=0.35,
    )
    pale = skin(kit, WHITE, pattern=PLAIN) if name != "sperm" else back
    fat = {"orca": 0.27, "humpback": 0.28, "sperm": 0.27, "dolphin": 0.21}.get(name, 0.2)
    bow = rng.uniform(-0.1, 0.22) * (0 if fish_like else 1)
    side = rng.uniform(-0.15, 0.15) * (1 if fish_like else 0)
    xs = np.array([-1.15, -0.75, -0.3, 0.15, 0.5, 0.78])
    points = np.stack([xs, side * (xs - 0.3) ** 2, -bow * (xs - 0.1) ** 2], 1)
    shape = {"sperm": (0.2, 0.45, 0.8, 1.0, 0.98, 0.85), "humpback": (0.2, 0.5, 0.88, 1.0, 0.85, 0.5)}.get(name, (0.17, 0.48, 0.85, 1.0, 0.85, 0.5))
    hull(kit, points, np.array(shape) * fat, back, 0.88)
    nose = points[-1]
    if name == "dolphin":
        hull(kit, [nose + [0.02, 0, -0.04], nose + [0.27, 0, -0.07]], [0.075, 0.04], back, 1.1, first=False)
    elif name in ("orca", "shark"):
        hull(kit, [nose, nose + [0.2, 0, 0.0]], [fat * 0.5, fat * 0.2], back, first=False)
    elif name == "humpback":
        kit.add(BALL, nose + [0.12, 0, -0.02], (0.32, fat * 0.5, fat * 0.38), material=back)
    elif name == "hammerhead":
        kit.add(BALL, nose + [0.1, 0, 0], (0.11, 0.36, 0.05), material=back)
        kit.add(BALL, nose + [0.1, 0.35, 0], (0.06, 0.04, 0.05), material=black(kit), mirror=True)
    else:
        kit.add(BALL, nose + [0.1, 0, 0.02], (0.22, fat * 0.68, fat * 0.82), material=back)
        kit.between(nose + [-0.3, 0, -0.2], nose + [0.1, 0, -0.2], (0.05, 0.07), CYL, 0.5, back)
    if name != "sperm":
        belly = pale._replace(pattern=RIBS, frequency=14.0, second=np.array(GREY)) if name == "humpback" else pale
        kit.add(BALL, points[3] + [0.12, 0, -fat * 0.3], (0.68, fat * 0.79, fat * 0.76), material=belly)
    tail_end = points[0]
    if fish_like:
        sail(kit, tail_end + [-0.36, 0, 0.46], tail_end + [0.12, 0, 0.03], tail_end + [-0.1, 0, -0.01], 0.016, back)
        sail(kit, tail_end + [-0.2, 0, -0.24], tail_end + [0.1, 0, -0.02], tail_end + [-0.1, 0, 0.03], 0.016, back)
        sail(kit, points[1] + [-0.13, 0, 0.17], points[1] + [0.06, 0, 0.06], points[1] + [-0.09, 0, 0.05], 0.012, back)
    else:
        sail(kit, tail_end + [-0.26, 0.36, 0], tail_end + [0.12, 0, 0], tail_end + [-0.12, 0, 0], 0.02, back, mirror=True)
    tall = {"orca": 0.5, "dolphin": 0.27, "humpback": 0.12, "sperm": 0.08}.get(name, 0.34)
    root = points[2] + [0.18, 0, fat * 0.86]
    sail(kit, root + [-0.26, 0, tall], root + [0.18, 0, -0.03], root + [-0.2, 0, -0.03], 0.022, back)
    reach = {"humpback": 0.8, "sperm": 0.25, "orca": 0.36}.get(name, 0.4)
    sail(
        kit,
        points[3] + [0.02 - reach * 0.6, fat * 0.6 + reach * 0.8, -fat * 0.6 - reach * 0.4],
        points[3] + [0.28, fat * 0.6, -fat * 0.42],
        points[3] + [0.04, fat * 0.62, -fat * 0.5],
        0.022,
        back,
        mirror=True,
    )
    kit.add(BALL, nose + [-0.02, fat * 0.46, 0.0], (0.022,) * 3, material=black(kit), mirror=True)
    if name == "orca":
        kit.add(BALL, nose + [-0.13, fat * 0.55, 0.06], (0.1, 0.04, 0.045), rotation=turn("z", -18), material=pale, mirror=True)
        kit.add(BALL, points[2] + [0.02, 0, fat * 0.52], (0.16, fat * 0.5, fat * 0.42), material=skin(kit, GREY))
    elif name == "shark":
        for k in range(4):
            kit.add(BOX, points[4] + [-0.08 - 0.05 * k, fat * 0.77, 0], (0.006, 0.012, 0.06), rotation=turn("y", 15), material=black(kit), mirror=True)
        kit.add(BALL, nose + [0.06, 0, -fat * 0.36], (0.09, 0.075, 0.03), material=black(kit))


def ray(kit):
    rng = kit.rng
    coat = skin(kit, BLACK, SLATE, TAN, BROWN, (0.1, 0.2, 0.3), pattern=rng.choice([PLAIN, SPECKLES, CLOUDY]), second=WHITE, frequency=12)
    flap = rng.uniform(-0.2, 0.45)
    kit.add(BALL, (0, 0, 0), (0.55, 0.3, 0.12), material=coat)
    stations = [(0.42, -0.48, 0.0, 0), (0.32, -0.42, 0.3, flap * 0.15), (0.1, -0.32, 0.62, flap * 0.45), (-0.16, -0.26, 1.0, flap)]
    membrane(kit, stations[:2], 0.06, coat)
    membrane(kit, stations[1:3], 0.035, coat)
    membrane(kit, stations[2:], 0.016, coat)
    kit.add(BALL, (0.02, 0, -0.03), (0.46, 0.26, 0.1), material=skin(kit, WHITE, pattern=PLAIN))
    hull(kit, bend((-0.45, 0, 0), (-0.9, 0, 0.05), (-1.5, rng.uniform(-0.3, 0.3), -0.02), 4), [0.05, 0.03, 0.02, 0.01], coat)
    if kit.chance(0.5):
        kit.between((0.42, 0.18, 0.01), (0.66, 0.14, -0.03), (0.06, 0.025), BOX, 0.7, coat, mirror=True)
    kit.add(BALL, (0.36, 0.22, 0.07), (0.035, 0.03, 0.035), material=black(kit), mirror=True)
