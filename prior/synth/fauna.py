"""Makers of animals true to their anatomy: four-legged ones from mice to elephants, and birds, fish, reptiles, insects, molluscs, dinosaurs."""

import itertools

import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, Head, bend, black, fur, hull, looking
from .birds import folded_wing, hooked, membrane, sail
from .kit import around, towards, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, DOTS, LEDGES, PATCHWORK, PLAIN, RIBS, SEAMS, SPECKLES, STREAKS, STRIPES, WAVES, paint

SAND, SILVER, GOLD, SLATE, FAWN = (0.55, 0.38, 0.2), (0.45, 0.45, 0.44), (0.62, 0.38, 0.14), (0.1, 0.12, 0.15), (0.5, 0.33, 0.19)
# With the withers at 1: length from breast to buttock, depth of chest and of loin, height of the croup, half width; the neck's length,
# rise in degrees and radii at both ends; radius of the skull, from its middle to the nose, radius of the nose; radius of the shins;
# how far the head looks down in degrees.
SHAPES = {
    "shepherd": (1.14, 0.46, 0.33, 0.92, 0.14, 0.27, 42, 0.15, 0.105, 0.115, 0.3, 0.045, 0.034, 8),
    "retriever": (1.1, 0.49, 0.4, 0.98, 0.17, 0.24, 42, 0.155, 0.12, 0.13, 0.28, 0.062, 0.04, 8),
    "husky": (1.08, 0.47, 0.36, 0.97, 0.155, 0.24, 42, 0.16, 0.125, 0.125, 0.27, 0.05, 0.036, 8),
    "greyhound": (1.06, 0.48, 0.23, 0.99, 0.12, 0.32, 55, 0.115, 0.068, 0.075, 0.26, 0.03, 0.025, 10),
    "dachshund": (2.15, 0.68, 0.54, 0.97, 0.26, 0.42, 52, 0.22, 0.15, 0.17, 0.48, 0.07, 0.07, 10),
    "bulldog": (1.3, 0.62, 0.44, 0.97, 0.29, 0.17, 32, 0.27, 0.24, 0.25, 0.33, 0.14, 0.075, 3),
    "pug": (1.15, 0.56, 0.45, 0.98, 0.22, 0.17, 45, 0.2, 0.18, 0.21, 0.25, 0.12, 0.058, 3),
    "poodle": (1.0, 0.44, 0.33, 0.98, 0.14, 0.31, 66, 0.125, 0.09, 0.11, 0.31, 0.034, 0.032, 8),
    "terrier": (1.1, 0.49, 0.42, 0.99, 0.18, 0.26, 55, 0.16, 0.12, 0.13, 0.32, 0.068, 0.045, 8),
    "beagle": (1.2, 0.5, 0.4, 0.98, 0.18, 0.25, 45, 0.155, 0.12, 0.135, 0.31, 0.065, 0.044, 8),
    "dalmatian": (1.08, 0.46, 0.32, 0.98, 0.145, 0.28, 48, 0.14, 0.095, 0.11, 0.28, 0.052, 0.033, 8),
    "corgi": (1.8, 0.66, 0.56, 0.98, 0.26, 0.3, 48, 0.23, 0.17, 0.19, 0.42, 0.055, 0.07, 8),
    "wolf": (1.1, 0.46, 0.34, 0.96, 0.15, 0.28, 24, 0.17, 0.125, 0.12, 0.3, 0.045, 0.034, 8),
    "fox": (1.22, 0.44, 0.36, 0.97, 0.145, 0.23, 34, 0.15, 0.11, 0.125, 0.31, 0.026, 0.03, 10),
    "cat": (1.35, 0.44, 0.4, 1.02, 0.165, 0.17, 45, 0.15, 0.125, 0.165, 0.19, 0.075, 0.04, 5),
    "lion": (1.28, 0.46, 0.35, 0.97, 0.17, 0.24, 26, 0.19, 0.15, 0.135, 0.25, 0.075, 0.05, 8),
    "tiger": (1.38, 0.46, 0.38, 0.97, 0.175, 0.23, 20, 0.18, 0.15, 0.14, 0.24, 0.075, 0.052, 8),
    "leopard": (1.32, 0.43, 0.34, 0.98, 0.15, 0.22, 22, 0.15, 0.125, 0.125, 0.22, 0.065, 0.045, 8),
    "cheetah": (1.14, 0.4, 0.24, 0.98, 0.12, 0.23, 32, 0.115, 0.09, 0.09, 0.145, 0.05, 0.031, 8),
    "hyena": (1.04, 0.45, 0.34, 0.8, 0.15, 0.34, 30, 0.18, 0.13, 0.13, 0.3, 0.058, 0.036, 10),
    "horse": (1.0, 0.46, 0.4, 1.0, 0.165, 0.5, 46, 0.19, 0.1, 0.1, 0.34, 0.055, 0.026, 45),
    "pony": (1.15, 0.54, 0.52, 1.0, 0.22, 0.42, 42, 0.23, 0.14, 0.125, 0.36, 0.07, 0.036, 42),
    "donkey": (1.02, 0.48, 0.46, 1.02, 0.175, 0.4, 42, 0.17, 0.105, 0.115, 0.36, 0.062, 0.029, 42),
    "zebra": (1.04, 0.48, 0.47, 1.0, 0.18, 0.42, 44, 0.19, 0.115, 0.11, 0.34, 0.06, 0.028, 42),
    "cow": (1.16, 0.53, 0.52, 1.0, 0.22, 0.32, 14, 0.22, 0.14, 0.12, 0.3, 0.075, 0.035, 35),
    "bull": (1.16, 0.58, 0.48, 0.97, 0.25, 0.28, 14, 0.3, 0.19, 0.14, 0.31, 0.09, 0.04, 35),
    "bison": (1.06, 0.6, 0.4, 0.78, 0.21, 0.24, -18, 0.3, 0.2, 0.16, 0.32, 0.08, 0.038, 42),
    "goat": (1.02, 0.47, 0.48, 1.0, 0.18, 0.33, 50, 0.16, 0.09, 0.095, 0.23, 0.045, 0.028, 28),
    "sheep": (1.08, 0.56, 0.56, 1.0, 0.23, 0.26, 40, 0.19, 0.12, 0.1, 0.25, 0.052, 0.031, 28),
    "pig": (1.5, 0.62, 0.6, 1.0, 0.28, 0.16, 2, 0.31, 0.25, 0.2, 0.42, 0.09, 0.052, 18),
    "boar": (1.3, 0.62, 0.46, 0.84, 0.2, 0.2, -6, 0.3, 0.21, 0.165, 0.45, 0.06, 0.04, 20),
    "deer": (0.98, 0.41, 0.34, 0.99, 0.135, 0.42, 52, 0.15, 0.08, 0.082, 0.23, 0.036, 0.021, 22),
    "moose": (0.9, 0.44, 0.36, 0.9, 0.155, 0.32, 20, 0.19, 0.12, 0.1, 0.38, 0.075, 0.027, 28),
    "camel": (0.84, 0.4, 0.3, 0.94, 0.16, 0.66, 42, 0.14, 0.075, 0.078, 0.23, 0.045, 0.03, 12),
    "llama": (0.9, 0.44, 0.4, 0.99, 0.18, 0.56, 74, 0.155, 0.095, 0.085, 0.2, 0.042, 0.032, 10),
    "elephant": (1.04, 0.56, 0.58, 0.93, 0.27, 0.14, 28, 0.3, 0.24, 0.21, 0.3, 0.1, 0.085, 10),
    "rhino": (1.4, 0.62, 0.62, 0.96, 0.28, 0.26, -4, 0.3, 0.22, 0.17, 0.46, 0.11, 0.08, 20),
    "hippo": (1.6, 0.7, 0.74, 0.95, 0.35, 0.2, 0, 0.36, 0.29, 0.24, 0.52, 0.2, 0.095, 14),
    "giraffe": (0.62, 0.33, 0.25, 0.82, 0.12, 0.78, 60, 0.17, 0.06, 0.065, 0.22, 0.036, 0.022, 25),
    "bear": (1.22, 0.56, 0.52, 0.97, 0.24, 0.24, 4, 0.27, 0.2, 0.17, 0.34, 0.065, 0.072, 10),
    "tapir": (1.35, 0.57, 0.56, 1.02, 0.24, 0.22, 22, 0.24, 0.17, 0.13, 0.34, 0.06, 0.052, 22),
    "capybara": (1.75, 0.66, 0.66, 1.0, 0.3, 0.24, 22, 0.27, 0.21, 0.18, 0.42, 0.12, 0.06, 8),
    "badger": (1.9, 0.64, 0.62, 1.0, 0.32, 0.22, 8, 0.26, 0.2, 0.2, 0.48, 0.05, 0.1, 12),
    "raccoon": (1.55, 0.56, 0.56, 1.04, 0.27, 0.18, 20, 0.22, 0.18, 0.2, 0.4, 0.05, 0.065, 10),
    "otter": (2.5, 0.62, 0.6, 1.05, 0.27, 0.42, 22, 0.25, 0.2, 0.2, 0.31, 0.1, 0.085, 8),
    "anteater": (1.6, 0.56, 0.54, 0.92, 0.2, 0.32, 0, 0.22, 0.13, 0.12, 0.8, 0.035, 0.075, 24),
    "armadillo": (1.9, 0.84, 0.82, 1.0, 0.38, 0.2, -4, 0.26, 0.16, 0.17, 0.52, 0.05, 0.08, 22),
    "mouse": (1.9, 0.74, 0.82, 1.1, 0.34, 0.2, 12, 0.3, 0.24, 0.25, 0.5, 0.05, 0.05, 14),
}
CANINE = ["shepherd", "retriever", "husky", "greyhound", "dachshund", "bulldog", "pug", "poodle", "terrier", "beagle", "dalmatian", "corgi", "wolf", "fox"]
FELINE = ["cat", "lion", "tiger", "leopard", "cheetah"]
EQUINE = ["horse", "pony", "donkey", "zebra"]
HOOFED = [*EQUINE, "cow", "bull", "bison", "goat", "sheep", "pig", "boar", "deer", "moose", "camel", "llama", "giraffe", "tapir"]
PILLARS = ["elephant", "rhino", "hippo"]
SPLIT = ["cow", "bull", "bison", "goat", "sheep", "deer", "moose", "camel", "llama", "giraffe"]
# Coats to choose from: coat, legs, muzzle, belly, back, hair of mane and tail; None: as the coat, or nothing on belly and back.
COATS = {
    "shepherd": [(GOLD, TAN, BLACK, None, BLACK, DARK), (BLACK, TAN, BLACK, None, None, BLACK), (SAND, CREAM, DARK, CREAM, DARK, DARK)],
    "retriever": [(GOLD, None, None, CREAM, None, GOLD), (CREAM, None, None, WHITE, None, CREAM), (BLACK, None, None, None, None, BLACK), (BROWN,) + (None,) * 5],
    "husky": [(SLATE, WHITE, WHITE, WHITE, BLACK, GREY), (BLACK, WHITE, WHITE, WHITE, None, BLACK), (RED, WHITE, WHITE, WHITE, None, RED)],
    "greyhound": [(FAWN,) + (None,) * 5, (SLATE, None, None, WHITE, None, None), (BLACK,) + (None,) * 5, (WHITE,) + (None,) * 5],
    "dachshund": [(BLACK, TAN, TAN, TAN, None, BLACK), (RED,) + (None,) * 5, (BROWN, TAN, TAN, None, None, None)],
    "bulldog": [(WHITE, None, None, None, TAN, None), (FAWN, WHITE, WHITE, WHITE, None, None), (SLATE, None, None, WHITE, None, None), (BROWN, WHITE, WHITE, None, None, None)],
    "pug": [(SAND, None, BLACK, None, None, None), (FAWN, None, BLACK, None, None, None), (BLACK,) + (None,) * 5],
    "poodle": [(WHITE,) + (None,) * 5, (BLACK,) + (None,) * 5, (ORANGE,) + (None,) * 5, (GREY,) + (None,) * 5],
    "terrier": [(TAN, None, None, None, BLACK, None), (WHITE,) + (None,) * 5, (GREY, SILVER, SILVER, None, None, None), (FAWN,) + (None,) * 5],
    "beagle": [(RED, WHITE, WHITE, WHITE, BLACK, WHITE)],
    "dalmatian": [(WHITE,) + (None,) * 5],
    "corgi": [(ORANGE, WHITE, WHITE, WHITE, None, ORANGE), (BLACK, WHITE, WHITE, WHITE, None, BLACK)],
    "wolf": [(GREY, SAND, WHITE, CREAM, DARK, GREY), (WHITE,) + (None,) * 5, (DARK, None, GREY, None, None, DARK)],
    "fox": [(ORANGE, BLACK, WHITE, WHITE, None, ORANGE), ((0.5, 0.16, 0.04), DARK, WHITE, WHITE, None, (0.5, 0.16, 0.04)), (WHITE,) + (None,) * 5],
    "cat": [(GREY, WHITE, WHITE, WHITE, None, None), (BLACK,) + (None,) * 5, (CREAM, DARK, DARK, None, None, DARK), (WHITE,) + (None,) * 5, (BLACK, WHITE, WHITE, WHITE, None, None)],
    "lion": [(SAND, None, CREAM, CREAM, None, BROWN), (FAWN, None, WHITE, CREAM, None, DARK)],
    "tiger": [(ORANGE, None, WHITE, WHITE, None, None), (WHITE,) + (None,) * 5],
    "leopard": [(SAND, None, CREAM, CREAM, None, None), (BLACK,) + (None,) * 5, (SILVER, None, WHITE, WHITE, None, None)],
    "cheetah": [(SAND, None, CREAM, CREAM, None, None)],
    "hyena": [(TAN, DARK, BLACK, None, None, DARK), (SAND, BROWN, DARK, None, None, BROWN)],
    "horse": [(RED, BLACK, None, None, None, BLACK), (BROWN, BLACK, DARK, None, None, BLACK), (BLACK,) + (None,) * 5, (GREY, DARK, DARK, None, None, WHITE)]
    + [(GOLD, WHITE, None, None, None, WHITE), (WHITE, None, GREY, None, None, None), (RED, WHITE, None, None, None, RED)],
    "pony": [(TAN, None, CREAM, None, None, CREAM), (DARK, None, None, None, None, CREAM), (SAND, None, None, None, None, DARK), (RED, None, None, None, None, CREAM)],
    "donkey": [(GREY, None, WHITE, CREAM, None, DARK), (BROWN, None, CREAM, CREAM, None, BLACK)],
    "zebra": [(WHITE, None, BLACK, None, None, BLACK)],
    "cow": [(RED, WHITE, WHITE, None, None, WHITE), (BROWN, None, CREAM, None, None, DARK), (BLACK,) + (None,) * 5, (FAWN, None, WHITE, None, None, DARK), (WHITE, None, PINK, None, None, None)],
    "bull": [(BLACK,) + (None,) * 5, (BROWN, None, None, None, None, BLACK), (RED,) + (None,) * 5, (CREAM,) + (None,) * 5],
    "bison": [(BROWN, DARK, DARK, None, None, DARK)],
    "goat": [(WHITE,) + (None,) * 5, (BROWN, BLACK, None, None, BLACK, BLACK), (BLACK, None, None, None, None, None), (TAN, DARK, None, WHITE, None, DARK)],
    "sheep": [(CREAM, BLACK, BLACK, None, None, None), (WHITE,) + (None,) * 5, (CREAM, WHITE, WHITE, None, None, None), (DARK,) + (None,) * 5],
    "pig": [(PINK,) + (None,) * 5, (BLACK,) + (None,) * 5, (RED,) + (None,) * 5],
    "boar": [(DARK, BLACK, None, None, None, BLACK), (BROWN, DARK, None, None, DARK, DARK)],
    "deer": [(RED, None, BROWN, CREAM, None, WHITE), (TAN, None, DARK, CREAM, None, WHITE), (BROWN, None, DARK, TAN, None, CREAM)],
    "moose": [(DARK, GREY, BROWN, None, None, DARK), (BROWN, SILVER, None, None, None, DARK)],
    "camel": [(SAND, None, None, None, None, BROWN), (TAN, None, None, None, None, DARK), (CREAM, None, None, None, None, TAN)],
    "llama": [(WHITE,) + (None,) * 5, (BROWN,) + (None,) * 5, (SAND, WHITE, WHITE, WHITE, None, None), (DARK, None, CREAM, None, None, None)],
    "elephant": [(GREY,) + (None,) * 5, ((0.22, 0.16, 0.12),) + (None,) * 5],
    "rhino": [(GREY,) + (None,) * 5, ((0.3, 0.25, 0.2),) + (None,) * 5],
    "hippo": [((0.17, 0.12, 0.11), None, PINK, PINK, None, None), (GREY, None, (0.4, 0.26, 0.22), (0.4, 0.26, 0.22), None, None)],
    "giraffe": [(CREAM, None, CREAM, None, None, BROWN)],
    "bear": [(BROWN, DARK, TAN, None, None, None), (BLACK, None, TAN, None, None, None), ((0.8, 0.76, 0.64),) + (None,) * 5, (RED, BROWN, None, None, None, None)],
    "tapir": [(BLACK, None, None, None, WHITE, None), (BROWN, None, None, None, None, None)],
    "capybara": [(TAN, BROWN, BROWN, None, None, None), (RED, None, None, None, None, None)],
    "badger": [(SILVER, BLACK, WHITE, BLACK, None, SILVER)],
    "raccoon": [(GREY, DARK, WHITE, SILVER, None, GREY)],
    "otter": [(BROWN, None, TAN, TAN, None, None), (DARK, None, SILVER, SILVER, None, None)],
    "anteater": [(GREY, SILVER, None, None, None, DARK), (BROWN, CREAM, None, None, None, DARK)],
    "armadillo": [(TAN, None, PINK, None, None, None), (GREY, None, None, None, None, None)],
    "mouse": [(GREY, PINK, None, SILVER, None, PINK), (TAN, PINK, None, WHITE, None, PINK), (WHITE, PINK, None, None, None, PINK)],
}


def coats(kit, name):
    """Materials of the coat, the legs, the muzzle, belly, back (or None) and hair of a species."""
    rng = kit.rng
    options = COATS[name]
    chosen = options[rng.integers(len(options))]
    marks = {
        "zebra": (BANDS, rng.uniform(15, 24), BLACK),
        "tiger": (BANDS, rng.uniform(13, 20), BLACK),
        "giraffe": (CAMOUFLAGE, rng.uniform(12, 18), (0.28, 0.11, 0.03)),
        "leopard": (SPECKLES, rng.uniform(9, 13), BLACK),
        "cheetah": (SPECKLES, rng.uniform(12, 16), BLACK),
        "hyena": (SPECKLES, rng.uniform(7, 11), DARK),
        "dalmatian": (SPECKLES, rng.uniform(6, 9), BLACK),
        "armadillo": (BANDS, rng.uniform(18, 26), DARK),
        "elephant": (STREAKS, rng.uniform(8, 16), (0.12, 0.11, 0.1)),
    }
    if name == "deer" and kit.chance(0.4):
        marks["deer"] = (SPECKLES, rng.uniform(10, 14), WHITE)
    if name in ("cow", "horse", "pony", "pig", "goat") and kit.chance(0.45):
        marks[name] = (CAMOUFLAGE, rng.uniform(4, 8), WHITE if max(chosen[0]) < 0.6 else DARK)
    if name == "cat" and kit.chance(0.5):
        chosen, marks["cat"] = ((ORANGE, GREY, TAN)[rng.integers(3)], None, WHITE, WHITE, None, None), (BANDS, rng.uniform(16, 26), DARK)
    if name == "boar" and kit.chance(0.2) or name == "leopard" and chosen[0] is BLACK:
        marks.pop(name, None)
    if name in marks:
        pattern, frequency, second = marks[name]
        coat = fur(kit, chosen[0], pattern=pattern, frequency=frequency, second=second)
    else:
        coat = fur(kit, chosen[0], pattern=rng.choice([PLAIN, CLOUDY, CLOUDY, STREAKS]), gloss=0.12 if name in ("horse", "hippo", "otter") else 0.02)
    made = [coat] + [None if c is None else fur(kit, c, pattern=rng.choice([PLAIN, CLOUDY])) for c in chosen[1:]]
    return coat, made[1] or coat, made[2] or coat, made[3], made[4], made[5] or coat


def trunk(kit, stations, coat, place):
    """A body through stations [(x, top, bottom, half width), ...] from buttock to breast."""
    points = [place((x, 0, (top + low) / 2)) for x, top, low, _ in stations]
    flat = sum(wide for *_, wide in stations) / sum((top - low) / 2 for _, top, low, _ in stations)
    sizes = [((top - low) / 2, (top - low) / 2 * flat) for _, top, low, _ in stations]
    for i in range(len(points) - 1):
        ratio = sizes[i + 1][0] / sizes[i][0]
        kit.between(points[i], points[i + 1], sizes[i], CYL, ratio, coat)
    for i, (deep, wide) in enumerate(sizes):
        way = towards(points[min(i + 1, len(points) - 1)] - points[max(i - 1, 0)])
        kit.add(BALL, points[i], (deep, wide, min(deep, wide * 1.3)), rotation=way, material=coat)


def foot(kit, at, leg, end, lower):
    at = np.array(at, float)
    if end == "hoof":
        kit.add(CYL, at + [leg * 0.5, 0, leg * 1.1], (leg * 1.6, leg * 1.35, leg * 1.1), (0.68, 1), (-leg * 0.6, 0), material=fur(kit, BLACK, DARK, pattern=PLAIN))
    elif end == "paw":
        kit.add(BALL, at + [leg * 0.8, 0, leg * 0.75], (leg * 1.9, leg * 1.4, leg * 0.8), material=lower)
    else:
        kit.add(CYL, at + [leg * 0.1, 0, leg * 0.45], (leg * 1.28, leg * 1.22, leg * 0.45), (0.85, 1), material=lower)


def foreleg(kit, top, elbow, at, leg, bulk, coat, lower, end, hands=0.6):
    """Shoulder blade and upper arm, forearm, wrist at the share `hands` of the way down, shin, foot at `at`."""
    top, elbow, at = (np.array(p, float) for p in (top, elbow, at))
    kit.add(BALL, (top + elbow) / 2, (bulk, bulk * 0.62, np.linalg.norm(top - elbow) * 0.72), rotation=towards(top - elbow), material=coat)
    ankle = at + [0, 0, leg * (1.6 if end == "hoof" else 0.8)]
    wrist = elbow + (ankle - elbow) * hands + [leg * 0.5, 0, 0]
    thick = 1.3 if end == "pad" else 1.85
    kit.between(elbow + (elbow - wrist) * 0.12, wrist, leg * thick, CYL, 1.1 / thick, coat if end != "pad" else lower)
    kit.add(BALL, wrist, (leg * 1.14, leg * 1.08, leg * 1.3), material=lower)
    kit.between(wrist, ankle, leg * (1.1 if end == "pad" else 0.98), CYL, 0.97, lower)
    foot(kit, at, leg, end, lower)


def hindleg(kit, hip, knee, hock, at, leg, bulk, coat, lower, end):
    """Haunch, thigh to the knee, gaskin back to the hock, shin down to the foot."""
    hip, knee, hock, at = (np.array(p, float) for p in (hip, knee, hock, at))
    kit.add(BALL, (hip + knee) / 2, (bulk, bulk * 0.5, np.linalg.norm(hip - knee) * 0.8), rotation=towards(hip - knee), material=coat)
    thick = 1.35 if end == "pad" else 2.2
    kit.between(knee + (hip - knee) * 0.12, hock, leg * thick, CYL, 1.1 / thick, coat if end != "pad" else lower)
    kit.add(BALL, hock, (leg * 1.15, leg * 1.05, leg * 1.25), material=lower)
    kit.between(hock, at + [0, 0, leg * (1.6 if end == "hoof" else 0.8)], leg * 1.05, CYL, 0.95, lower)
    foot(kit, at, leg, end, lower)


def antlers(head, horn, far, palms):
    """Beams with tines, or with `palms` the shovels of a moose."""
    kit, size = head.kit, head.size
    for side in (1, -1):
        if palms:
            root, palm = head.place(-0.1, 0.4 * side, 0.7), head.place(-0.4, 1.6 * side, 1.0)
            kit.between(root, palm, size * 0.17, material=horn)
            way = head.facing @ turn("x", -42 * side) @ turn("y", -20)
            kit.add(BALL, head.place(-0.6, (1.9 + 0.3 * far) * side, 1.1 + 0.25 * far), np.array([0.16, 0.45 + 0.2 * far, 0.7 + 0.2 * far]) * size, rotation=way, material=horn)
            for x, y, z in ((0.5, 1.9, 1.7), (-0.7, 2.8, 2.7)):
                start = head.place(-0.5, (1.9 + 0.2 * far) * side, 1.2 + 0.2 * far)
                kit.between(start, head.place(x, (y + 0.2 * far) * side, z + 0.1 * far), size * 0.15, CYL, 0.25, horn)
        else:
            path = bend((-0.1, 0.35, 0.75), (-1.1, 1.3 + 0.3 * far, 0.9 + 0.5 * far), (-0.1, 0.7 + 0.4 * far, 0.9 + 1.1 * far), 4)
            spots = [head.place(x, y * side, z) for x, y, z in path]
            hull(kit, spots, np.array([0.17, 0.14, 0.12, 0.06]) * size, horn, first=False)
            for k, out in ((0, (0.9, 0.1, 0.6)), (1, (0.9, 0.1, 0.5)), (2, (-0.5, 0.2, 0.9))):
                tip = path[k] + np.array(out) * (0.5 + 0.25 * far) + [0.05, 0, 0.05]
                kit.between(spots[k] if k else head.place(*(path[0] * [1, side, 1] + [0, 0, 0.2])), head.place(tip[0], tip[1] * side, tip[2]), size * 0.12, CYL, 0.25, horn)


def skull(kit, name, head, m, e, coat, muzzle, hair, male):
    """Head of a species: skull, muzzle, jaw, nose, eyes, ears, horns; m: from the skull's middle to the nose, e: radius there."""
    rng, size = kit.rng, head.size
    far, end = m / size, e / size
    dark = fur(kit, BLACK, (0.04, 0.025, 0.02), pattern=PLAIN, gloss=0.4)
    pink = fur(kit, PINK, pattern=PLAIN)
    iris = kit.material(base=paint(rng.choice([0.1, 0.13, 0.3, 0.55]), 0.8, 0.6), pattern=PLAIN, gloss=0.6)
    horn = fur(kit, (0.3, 0.24, 0.17), DARK, CREAM, pattern=PLAIN, gloss=0.15)
    if name == "elephant":
        head.ball((0.05, 0, 0.3), (0.95, 0.88, 0.95), coat)
        head.ball((0.45, 0, -0.35), (0.6, 0.62, 0.75), coat)
        hang = [(0.75, 0, -0.1), (1.2, 0, -0.9), (1.25, 0, -1.9), (1.15, 0, -2.9), (1.4, 0, -3.3)]
        ways = [hang, [*hang[:3], (1.6, 0, -2.6), (2.1, 0, -2.4)], [(0.75, 0, -0.1), (1.5, 0, -0.6), (2.1, 0, -0.1), (2.4, 0, 0.8), (2.9, 0, 1.2)]]
        path = [head.place(*p) for p in ways[rng.integers(3)]]
        hull(kit, path, np.array([0.48, 0.37, 0.29, 0.22, 0.15]) * size, coat, first=False)
        large = rng.uniform(0.7, 1.15)
        for side in (1, -1):
            fan = head.facing @ turn("z", -40 * side) @ turn("x", 6 * side)
            kit.add(BALL, head.place(-0.4, (0.75 + 0.45 * large) * side, 0), np.array([0.8 * large, 0.08, 0.95 * large]) * size, rotation=fan, material=coat)
            kit.add(BALL, head.place(-0.35, (0.7 + 0.4 * large) * side, -0.65 * large), np.array([0.5 * large, 0.08, 0.7 * large]) * size, rotation=fan, material=coat)
        if kit.chance(0.8):
            long = rng.uniform(0.4, 1.2)
            head.rods([(0.7, 0.42, -0.6), (1.1 + 0.4 * long, 0.6, -1.2), (1.3 + long, 0.5, -1.1 + 0.2 * long)], [0.13, 0.11, 0.04], fur(kit, CREAM, pattern=PLAIN, gloss=0.3))
        head.eyes(0.72, 0.64, 0.1, 0.08)
        return
    if name in FELINE:
        head.ball((0, 0, 0.03), (1.0, 0.95, 0.92), coat)
        head.ball((0.1, 0, -0.32), (0.85, 0.88, 0.62), coat)
        head.ball((far * 0.52, 0, -0.05), (far * 0.42, 0.34, 0.4), coat)
        head.ball((far - end * 0.95, end * 0.42, -0.32), (end * 0.95, end * 0.75, end * 0.68), muzzle, True)
        head.ball((far - end * 1.25, 0, -0.62), (end * 0.85, end * 0.7, end * 0.42), muzzle)
        head.ball((far - end * 0.2, 0, -0.14), (0.11, 0.17, 0.1), pink if kit.chance(0.5) else dark)
        head.eyes(0.83, 0.42, 0.2, 0.15, iris)
        head.ear("prick" if name == "cat" else "round", rng.uniform(0.55, 0.75) if name == "cat" else 0.66, coat, pink if name == "cat" else muzzle)
        return
    if name in CANINE:
        flat = name in ("bulldog", "pug")
        head.ball((0, 0, 0), (1.05, 0.93 if not flat else 1.02, 0.93), coat)
        head.ball((0.2, 0, -0.3), (0.8, 0.86 if name in ("husky", "fox", "wolf", "corgi") else 0.75, 0.6), muzzle if name in ("husky", "fox", "corgi") else coat)
        tip = np.array([far - end, 0, -0.24])
        hull(kit, [head.place(0.35, 0, -0.12), head.place(*tip)], [size * (0.62 if not flat else 0.8), e], muzzle, 0.88 if not flat else 1.05, first=False)
        kit.between(head.place(0.2, 0, -0.5), head.place(far - end * 1.7, 0, -0.3 - end * 0.8), (size * 0.32, size * 0.5), CYL, max(0.45, end * 0.9), muzzle)
        head.ball((far - end * 0.25, 0, -0.24 + end * 0.5), (0.16, 0.2, 0.16), dark)
        if flat:
            head.ball((far - end * 1.1, end * 0.62, -0.42), (end * 0.8, end * 0.5, end * 0.95), muzzle, True)
        elif name == "terrier":
            head.ball((far - end * 1.4, 0, -0.5), (end * 1.3, end * 1.2, end * 1.3), muzzle)
            head.ball((0.78, 0.42, 0.5), (0.25, 0.25, 0.12), muzzle, True)
        elif kit.chance(0.35):
            head.ball((far - end * 1.1, 0, -0.35 - end), (end * 1.1, end * 0.5, 0.07), fur(kit, (0.55, 0.16, 0.15), pattern=PLAIN, gloss=0.3))
        head.eyes(0.78, 0.46, 0.24, 0.13, iris if name == "husky" else None)
        ears = {"shepherd": ("prick", 0.85), "husky": ("prick", 0.6), "wolf": ("prick", 0.6), "fox": ("prick", 0.85), "corgi": ("prick", 0.8)}
        ears |= {"bulldog": ("flop", 0.45), "pug": ("flop", 0.5), "greyhound": ("flop", 0.55), "terrier": ("flop", 0.45)}
        ears |= {"dachshund": ("flop", 1.0), "poodle": ("flop", 1.1), "beagle": ("flop", 1.0)}
        tint = hair if name not in ("bulldog", "pug", "beagle") else muzzle if name == "pug" else coat
        head.ear(*ears.get(name, ("flop", 0.75)), tint, pink if kit.chance(0.5) else dark if name == "fox" else muzzle)
        if name == "poodle":
            head.ball((-0.1, 0, 0.65), (0.85, 0.85, 0.8), hair)
        if name == "husky":
            head.ball((0.55, 0, 0.5), (0.5, 0.22, 0.4), coat)
        return
    if name in ("bear", "badger", "raccoon", "otter", "anteater", "armadillo", "mouse", "hyena", "capybara"):
        head.ball((0, 0, 0), (1.08, 0.95, 0.95), muzzle if name == "badger" else coat)
        head.ball((0.15, 0, -0.3), (0.85, 0.9, 0.62), coat if name != "otter" else muzzle)
        tip = np.array([far - end, 0, -0.3])
        root = 0.62 if name not in ("capybara", "hyena") else 0.78
        kit.between(head.place(0.3, 0, -0.1), head.place(*tip), (size * root, size * root * 0.88), CYL, end / root, muzzle if name != "capybara" else coat)
        head.ball(tip, (end * 1.05, end * 0.95, end), muzzle)
        kit.between(head.place(0.2, 0, -0.48), head.place(far - end * 1.8, 0, -0.3 - end * 0.6), (size * 0.32, size * 0.46), CYL, max(0.4, end * 0.8), muzzle)
        small = {"anteater": 0.6, "capybara": 1.5}.get(name, 1.0)
        head.ball((far - end * 0.25, 0, -0.27 + end * 0.4), (0.15 * small, 0.19 * small, 0.15 * small), pink if name == "mouse" else dark)
        head.eyes(*((0.72, 0.5, 0.28) if name not in ("capybara", "mouse") else (0.5, 0.78, 0.35)), 0.1 if name in ("bear", "badger") else 0.13)
        if name == "badger":
            for side in (1, -1):
                kit.add(BALL, head.place(0.35, 0.5 * side, 0.12), np.array([0.95, 0.26, 0.62]) * size, rotation=head.facing @ turn("z", 12 * -side), material=dark)
        elif name == "raccoon":
            head.ball((0.62, 0.5, 0.12), (0.36, 0.38, 0.24), dark, True)
            head.eyes(0.92, 0.58, 0.2, 0.1)
            head.ball((0.7, 0, 0.42), (0.3, 0.14, 0.3), muzzle)
        ears = {"bear": ("round", 0.62), "badger": ("round", 0.5), "otter": ("round", 0.35), "mouse": ("round", 1.25), "armadillo": ("leaf", 0.7)}
        kind, large = ears.get(name, ("round", 0.55))
        head.ear(kind, large, coat if name != "badger" else dark, pink if name == "mouse" else None)
        return
    # Hoofed animals and the rest: a long wedge of a head.
    head.ball((0, 0, 0), (1.05, 0.82, 0.95), coat)
    tip = np.array([far - end, 0, -0.32])
    blunt = 0.92 if name in ("pig", "boar", "hippo", "rhino") else 0.84
    hull(kit, [head.place(0.15, 0, -0.08), head.place(*tip)], [size * blunt, e], coat, 0.82 if name != "hippo" else 1.0, first=False)
    head.ball((0.22, 0, -0.42), (0.75, 0.6 if name not in ("pig", "boar", "hippo") else 0.88, 0.66), coat)
    if name in ("pig", "boar"):
        snout = fur(kit, PINK if max(coat.first) > 0.4 else DARK, pattern=PLAIN, gloss=0.1)
        kit.between(head.place(far - end * 1.4, 0, -0.32), head.place(far, 0, -0.3), e * 1.02, CYL, 1.16, snout)
        head.ball((far, end * 0.42, -0.27), (0.04, end * 0.18, end * 0.25), dark, True)
        head.ear("prick" if name == "boar" or kit.chance(0.5) else "flop", rng.uniform(0.55, 0.8), coat, pink)
        head.eyes(0.62, 0.62, 0.3, 0.09)
        if name == "boar":
            head.rods([(far - end * 1.6, end * 0.7, -0.5), (far - end * 1.1, end * 1.4, 0.05)], [0.1, 0.03], fur(kit, WHITE, pattern=PLAIN))
            head.ball((-0.6, 0, 0.75), (0.9, 0.25, 0.5), hair)
        return
    if name == "hippo":
        head.ball((far - end, end * 0.45, -0.3), (end * 0.9, end * 0.68, end * 0.95), coat, True)
        head.ball((far - end * 1.5, 0, -0.75), (end * 1.5, end * 1.1, end * 0.55), muzzle)
        head.ball((far - end * 0.5, end * 0.45, end * 0.55), (0.14, 0.13, 0.12), dark, True)
        head.ball((0.35, 0.48, 0.72), (0.26, 0.2, 0.24), coat, True)
        head.eyes(0.5, 0.6, 0.78, 0.1)
        head.ear("round", 0.45, coat, pink)
        return
    if name == "rhino":
        head.ball((far - end, 0, -0.42), (end * 1.15, end * 1.2, end * 1.15), coat)
        high = rng.uniform(1.0, 2.1)
        head.rods([(far - end * 0.8, 0, 0), (far - end * 0.3, 0, high * 0.6), (far - end * 0.6, 0, high)], [0.36, 0.2, 0.05], horn, both=False)
        if kit.chance(0.75):
            head.rods([(far - end * 2.1, 0, 0.15), (far - end * 1.9, 0, 0.45 + high * 0.35)], [0.3, 0.06], horn, both=False)
        head.ear("leaf", 0.5, coat, dark)
        head.eyes(0.62, 0.66, 0.1, 0.09)
        return
    head.ball(tip, (end * 1.15, end * 1.02, end * 1.06), muzzle)
    if name == "tapir":
        hull(kit, [head.place(*tip), head.place(far + end * 0.5, 0, -0.4), head.place(far + end * 0.8, 0, -0.85)], [e * 0.85, e * 0.6, e * 0.45], coat, first=False)
    elif name == "moose":
        head.ball((far - end * 1.5, 0, -0.1), (end * 1.8, end * 0.85, end * 0.95), muzzle)
        head.ball((0.35, 0, -1.35), (0.2, 0.14, 0.6), hair)
    elif name in ("cow", "bull", "bison", "deer"):
        head.ball((far - end * 0.35, 0, -0.26), (end * 0.55, end * 0.78, end * 0.6), fur(kit, PINK, BLACK, BLACK, pattern=PLAIN, gloss=0.3))
    if name not in ("cow", "bull", "bison", "deer", "tapir"):
        head.ball((far - end * 0.25, end * 0.5, -0.2), (end * 0.22, end * 0.22, end * 0.26), dark, True)
    head.eyes(0.42, 0.7, 0.26, 0.14)
    ears = {"donkey": ("leaf", 1.15), "horse": ("leaf", 0.5), "pony": ("leaf", 0.45), "zebra": ("leaf", 0.6), "llama": ("leaf", 0.75), "camel": ("leaf", 0.32), "tapir": ("round", 0.5)}
    head.ear(*ears.get(name, ("side", rng.uniform(0.6, 0.9))), coat, pink if name not in SPLIT or name == "deer" else None)
    if name in ("horse", "pony") and kit.chance(0.5):
        head.ball((far * 0.45, 0, 0.3 - 0.08 * far), (far * 0.42, 0.2, 0.4), fur(kit, WHITE, pattern=PLAIN), tilt=(0, -12))
    if name in ("horse", "pony", "llama"):
        head.ball((0.25, 0, 0.72), (0.55, 0.32, 0.38), hair)
    if name == "bison":
        head.rods([(0, 0.7, 0.5), (0.1, 1.25, 0.75), (0.1, 1.3, 1.3)], [0.24, 0.17, 0.05], horn)
        head.ball((0.15, 0, 0.45), (0.85, 0.85, 0.75), hair)
        head.ball((0.55, 0, -1.05), (0.4, 0.35, 0.8), hair)
    elif name in ("cow", "bull") and kit.chance(0.55 if name == "cow" else 0.9):
        wide, up = rng.uniform(0.3, 1.0), rng.uniform(0.2, 1.1)
        head.rods([(-0.1, 0.5, 0.75), (-0.05, 0.9 + wide, 0.9), (0.25, 1.0 + wide, 0.9 + up)], [0.2, 0.15, 0.04], horn)
    elif name == "goat":
        long = rng.uniform(0.6, 1.4)
        head.rods([(0.05, 0.3, 0.75), (-0.2, 0.45, 0.9 + long), (-0.4 - long, 0.7, 1.0 + long)], [0.22, 0.17, 0.05], horn)
        head.ball((far - end * 2, 0, -1.05), (0.2, 0.15, 0.5), hair)
    elif name == "sheep" and male:
        head.rods([(0, 0.5, 0.7), (-0.75, 1.05, 0.4), (-0.2, 1.35, -0.5), (0.45, 1.5, 0.1)], [0.34, 0.3, 0.2, 0.06], horn)
    elif name in ("deer", "moose") and male:
        antlers(head, horn, rng.uniform(1.4, 2.6), name == "moose")
    elif name == "giraffe":
        head.rods([(-0.1, 0.35, 0.6), (-0.35, 0.5, 1.6)], [0.17, 0.2], hair)


def tail(kit, name, root, leg, low, coat, hair):
    """Of a species, from `root`, with what is low lying on the ground."""
    rng = kit.rng
    z = root[2]
    if low and name not in PILLARS:
        side = rng.choice([-1, 1])
        far = 0.28 if name not in (*FELINE, "fox", "mouse") else 0.6
        path = bend(root, (root[0] - far * 0.6, 0, leg), (root[0] - far * 0.5, side * far * 0.7, leg * 1.1), 4)
    elif name in ("horse", "pony"):
        hull(kit, bend(root, root + [-0.16, 0, 0.04], root + [-0.13, 0, -z * 0.62], 4), [0.04, 0.055, 0.075, 0.03], hair)
        return
    elif name in (*FELINE, "mouse"):
        far = {"mouse": 1.3, "cat": 0.75}.get(name, 0.7)
        ends = [(-far * 0.55, 0, far * 0.75), (-far * 0.75, 0.1, -z * 0.65), (-far, 0, -z * 0.3)]
        stop = ends[rng.integers(1 if name == "mouse" else 0, 3)]
        path = bend(root, root + [-far * 0.5, 0, -far * 0.35], root + np.array(stop), 4)
    elif name == "fox":
        path = bend(root, root + [-0.3, 0, -0.1], root + [-0.62, 0, -z * 0.45], 4)
    elif name in ("husky", "pug"):
        scale = 1.0 if name == "husky" else 0.55
        path = [root, *(root + np.array(p) * scale for p in ((-0.13, 0, 0.14), (-0.05, 0.02, 0.27), (0.1, 0.05, 0.22)))]
    elif name in ("shepherd", "wolf", "hyena", "greyhound"):
        path = bend(root, root + [-0.16, 0, 0], root + [-0.2, 0, -z * 0.55], 4)
    elif name in CANINE and name not in ("bulldog", "corgi"):
        up = rng.uniform(-0.1, 0.4)
        path = bend(root, root + [-0.2, 0, 0], root + [-0.35, 0, up], 4)
    elif name in ("raccoon", "otter", "badger", "anteater", "armadillo"):
        far = {"otter": 1.3, "anteater": 1.0, "raccoon": 0.75, "armadillo": 0.7}.get(name, 0.35)
        path = bend(root, root + [-far * 0.5, 0, -0.05], (root[0] - far, 0, max(0.1, z * (0.5 if name != "armadillo" else 0.15))), 4)
    elif name in ("cow", "bull", "bison", "giraffe", "zebra", "donkey", "elephant", "rhino", "hippo", "camel", "moose", "lion"):
        drop = {"hippo": 0.25, "rhino": 0.35, "bison": 0.35, "moose": 0.1}.get(name, 0.55) * z
        stop = root + [-0.1, rng.normal(0, 0.03), -drop]
        kit.chain(bend(root, root + [-0.12, 0, 0], stop, 3), [leg * 0.6, leg * 0.45, leg * 0.35], coat)
        kit.add(BALL, stop, (0.03, 0.03, 0.075), material=hair)
        return
    elif name in ("pig", "boar"):
        kit.chain([root, root + [-0.06, 0.03, 0.03], root + [-0.08, -0.03, 0.07]], 0.018, coat)
        return
    else:
        kit.add(BALL, root + [-0.03, 0, -0.04], (0.06, 0.045, 0.1), rotation=turn("y", 25), material=hair)
        return
    fat = {"fox": 2.6, "husky": 1.9, "raccoon": 1.7, "wolf": 1.7, "shepherd": 1.5, "retriever": 1.4, "anteater": 2.2, "otter": 1.5}.get(name, 0.85)
    radii = leg * fat * np.array([0.75, 1.0, 1.1, 0.6] if fat > 1.3 and name != "otter" else [1.0, 0.85, 0.7, 0.35])
    coat = hair if name in (*CANINE, "mouse", "anteater", "cat") else coat
    if name == "raccoon":
        coat = coat._replace(pattern=BANDS, frequency=22.0, second=np.array(BLACK))
    hull(kit, path, radii, coat)
    if name == "fox":
        kit.add(BALL, path[-1], (leg * 1.8,) * 3, material=fur(kit, WHITE))
    elif name == "poodle":
        kit.add(BALL, path[-1], (0.085,) * 3, material=hair)
    elif name == "lion":
        kit.add(BALL, path[-1], (0.05, 0.05, 0.07), material=hair)


def body_stations(name, long, chest, loin, croup, wide, rng):
    haunch = chest * 0.5 + loin * 0.5
    dip = rng.uniform(0, 0.025) if name in (*EQUINE, "cow") else -0.03 * chest if name not in ("boar", "bison", "hyena") else 0.0
    round_back = 0.05 if name in ("mouse", "raccoon", "armadillo", "capybara", "elephant") else 0.0
    back = [croup, croup * 0.55 + 0.45 - dip + round_back, 0.3 * croup + 0.7 - dip + round_back]
    drop = 0.2 if name in ("cow", "bull", "camel", "elephant") else 0.28
    return [
        (-0.5 * long, croup - haunch * drop, croup - haunch * 0.82, wide * 0.58),
        (-0.38 * long, back[0], croup - haunch, wide * 0.92),
        (-0.13 * long, back[1], back[1] - loin, wide * 0.9 if loin < chest * 0.9 else wide * 1.06),
        (0.12 * long, back[2], back[2] - 0.55 * chest - 0.45 * loin, wide * 1.03),
        (0.34 * long, 1.0, 1.0 - chest, wide * 0.92),
        (0.47 * long, 0.93, 1 - 0.8 * chest, wide * 0.66),
    ]


def beast_of(kit, name):
    """One of SHAPES, standing, walking, grazing, sitting or lying."""
    rng = kit.rng
    shape = np.array(SHAPES[name])
    shape[[0, 1, 2, 4, 5, 7, 8, 9, 10, 11, 12]] *= np.exp(rng.normal(0, 0.05, 11))
    long, chest, loin, croup, wide, neck, rise, neck0, neck1, size, m, e, leg, down = shape
    chest, loin = min(chest, 0.88), min(loin, 0.86)
    poses = ["stand", "walk", "walk"]
    if name in CANINE or name in FELINE:
        poses += ["sit", "sit", "lie"]
    elif name in SPLIT or name in EQUINE:
        poses += ["graze"] if name not in ("giraffe", "camel", "moose") else []
        poses += ["lie"] if name in ("cow", "deer", "camel", "sheep", "goat", "llama") else []
    elif name == "bear":
        poses += ["sit"]
    pose = str(rng.choice(poses))
    coat, lower, muzzle, under, back, hair = coats(kit, name)
    male = kit.chance(0.65)
    end = "hoof" if name in HOOFED and name != "camel" else "pad" if name in PILLARS or name == "camel" else "paw"
    heavy = name in PILLARS
    stations = body_stations(name, long, chest, loin, croup, wide, rng)
    hip = np.array([-0.37 * long, 0, croup - 0.45 * chest])
    seat, tilt = hip.copy(), np.eye(3)
    if pose == "sit":
        seat[2] = 0.1 * long + 0.27 * chest
        lift = (1 - 0.5 * chest) * 0.98 - seat[2] - (1 - 0.5 * chest - hip[2])
        tilt = turn("y", -np.clip(np.degrees(np.arcsin(np.clip(lift / (0.73 * long), 0, 0.86))), 12, 58))
    elif pose == "lie":
        seat[2] -= (1 - chest) * 0.98

    def place(point):
        return seat + tilt @ (np.array(point, float) - hip)

    trunk(kit, stations, coat, place)
    # Neck.
    base = place((0.37 * long, 0, 1 - 0.36 * chest))
    if pose == "graze":
        goal = np.array([base[0] + 0.42 * neck + 0.1 * long, 0, m * 0.92 + 0.02])
        down = rng.uniform(62, 78)
    else:
        up = rise + rng.normal(0, 6)
        up += 22 if pose == "sit" else 12 if pose == "lie" and up < 40 else 0
        goal = base + turn("y", -up) @ np.array([neck + 0.3 * chest * (1 if up > 20 else 0.6), 0, 0])
    if name == "camel" and pose != "graze":
        path = bend(base - [0, 0, 0.04], base + [neck * 0.7, 0, -0.16], goal, 4)
    else:
        path = bend(base, base * 0.42 + goal * 0.58 + [0.03 * neck, 0, -0.05 * neck], goal, 3)
    radii = np.interp(np.linspace(0, 1, len(path)), [0, 0.5, 1], [neck0, neck0 * 0.42 + neck1 * 0.58, neck1])
    hull(kit, path, radii, coat if name != "sheep" else coat._replace(pattern=SPECKLES), 0.78 if name in HOOFED else 0.88)
    facing = looking(kit, down, 22)
    head = Head(kit, path[-1] + facing @ np.array([size * 0.35, 0, 0]) + [0, 0, size * 0.2], facing, size)
    if name == "lion" and male:
        for where, half in (((-0.4, 0, 0.05), (0.8, 1.45, 1.45)), ((-1.0, 0, -0.6), (1.2, 1.4, 1.6)), ((0.05, 0, -0.95), (0.7, 0.8, 0.8))):
            head.ball(where, half, hair)
    skull(kit, name, head, m, e, coat, muzzle, hair, male)
    # Legs.
    fore_y, hind_y = wide * 0.6, wide * 0.58
    ground = 1 - chest
    stride = {"walk": rng.uniform(0.2, 0.36), "stand": rng.uniform(0, 0.08)}.get(pose, 0.0) * (ground + 0.1) * (0.7 if heavy else 1)
    hock_up = (0.72 if end == "hoof" else 0.35 if name in ("bear", "badger", "raccoon", "otter", "anteater", "armadillo", "mouse") else 0.5) * ground
    for side in (1, -1):
        top, elbow = place((0.38 * long, side * fore_y, 1 - 0.5 * chest)), place((0.33 * long, side * fore_y, 1 - 0.93 * chest))
        step = side * stride
        if pose == "lie":
            elbow = np.array([elbow[0], side * fore_y * 1.15, leg * 1.9])
            kit.add(BALL, (top + elbow) / 2, (chest * 0.24, wide * 0.36, chest * 0.36), rotation=towards(top - elbow), material=coat)
            knee = elbow + [0.62 * ground + 0.1 * long, 0, -leg * 0.7]
            kit.between(elbow, knee, leg * 1.8, CYL, 0.62, coat)
            if end == "hoof" or end == "pad":
                kit.chain([knee, (elbow[0] + 0.05, side * (fore_y * 1.15 + leg), leg)], [leg * 1.1, leg], lower)
            else:
                kit.add(BALL, knee + [leg, 0, -leg * 0.3], (leg * 1.9, leg * 1.4, leg * 0.85), material=lower)
        else:
            at = np.array([top[0] - 0.02 + step, top[1] * (0.92 if pose != "sit" else 0.8), 0])
            foreleg(kit, top, elbow + [step * 0.15, 0, 0], at, leg, chest * 0.27, coat, lower, end, 0.52 if end == "hoof" else 0.62)
        if pose in ("sit", "lie"):
            z = max(chest * 0.32, 0.14)
            x = seat[0] + (0.1 * long if pose == "lie" else 0.08)
            kit.add(BALL, (x, side * wide * 0.82, z), (chest * 0.46, wide * 0.38, z), rotation=turn("y", -20), material=coat)
            heel, toe = np.array([x - 0.1, side * wide * 1.1, leg * 1.2]), np.array([x + chest * 0.5, side * wide * 1.15, leg])
            kit.between(heel, toe, leg * 1.3, CYL, 0.85, lower)
            kit.add(BALL, toe + [leg, 0, -leg * 0.1], (leg * 1.8, leg * 1.35, leg * 0.9), material=lower)
            continue
        joint = (-0.36 * long, side * hind_y, croup - 0.4 * chest)
        knee = (-0.29 * long - 0.35 * step, side * hind_y, croup - chest * 0.95 if not heavy else croup - chest * 0.9)
        at = np.array([-0.44 * long - step, side * hind_y, 0])
        hock = np.array([at[0] - (0.08 * ground if heavy else 0.16 * ground) + 0.25 * step, side * hind_y, hock_up])
        if heavy:
            hock[0] = at[0] * 0.6 + knee[0] * 0.4
        hindleg(kit, joint, knee, hock, at, leg, chest * 0.37, coat, lower, end)
    root = place((-0.5 * long, 0, croup - chest * 0.22))
    tail(kit, name, root, leg, pose in ("sit", "lie"), coat, hair)
    # Markings, manes, humps, fleece.
    slope = tilt @ turn("y", np.degrees(np.arctan2(croup - 1, long)) * 0.8)
    if under:
        kit.add(BALL, place((0.02 * long, 0, 1 - chest * 0.68 + (chest - loin) * 0.2)), (long * 0.36, wide * 0.9, chest * 0.33), rotation=slope @ turn("y", -8), material=under)
        kit.add(BALL, place((0.42 * long, 0, 1 - chest * 0.55)), (long * 0.1, wide * 0.62, chest * 0.36), rotation=tilt, material=under)
    if back:
        kit.add(BALL, place((-0.06 * long, 0, 0.5 + croup / 2 - chest * 0.2)), (long * 0.43, wide * 0.98, chest * 0.24), rotation=slope, material=back)
    if name in EQUINE:
        aim = (path[-1] - path[0]) / np.linalg.norm(path[-1] - path[0])
        normal = np.array([-aim[2], 0, aim[0]])
        for k in (0.1, 0.4, 0.7, 0.98):
            width = np.interp(k, [0, 1], [neck0, neck1])
            half = (neck * 0.24, 0.03, width * (0.55 if name in ("horse", "pony") else 0.35))
            kit.add(BALL, path[0] + (path[-1] - path[0]) * k + normal * width * 0.85, half, rotation=turn("y", -np.degrees(np.arctan2(aim[2], aim[0]))), material=hair)
    elif name == "camel":
        for x in (-0.2, 0.16) if kit.chance(0.5) else (-0.03,):
            kit.add(BALL, place((x * long, 0, 0.93)), (0.12 if x != -0.03 else 0.2, 0.11, rng.uniform(0.22, 0.3)), material=hair if kit.chance(0.4) else coat)
    elif name == "sheep":
        wool = coat._replace(pattern=SPECKLES, frequency=20.0)
        for x in (-0.34, 0.0, 0.32):
            kit.add(BALL, place((x * long, 0.55 * wide, 1 - chest * 0.46)), (long * 0.21, wide * 0.6, chest * 0.5), material=wool, mirror=True)
    elif name in ("bison", "moose", "bull"):
        half = {"bison": (0.3, wide * 0.72, 0.36), "moose": (0.2, wide * 0.6, 0.2), "bull": (0.26, wide * 0.6, 0.2)}[name]
        kit.add(BALL, place((0.24 * long, 0, 0.86)), half, material=hair if name == "bison" else coat)
        if name == "bison":
            kit.add(BALL, place((0.38 * long, 0, 0.6)), (0.22, wide * 0.95, 0.38), material=hair)
    elif name == "poodle" and pose in ("stand", "walk"):
        kit.add(BALL, place((0.25 * long, 0, 1 - chest * 0.45)), (long * 0.3, wide * 1.35, chest * 0.62), material=hair)
    elif name == "hyena":
        kit.add(BALL, place((0.2 * long, 0, 0.97)), (0.3 * long, 0.03, 0.09), rotation=turn("y", 8), material=hair)
    elif name == "cow" and pose in ("stand", "walk", "graze") and kit.chance(0.7):
        kit.add(BALL, place((-0.27 * long, 0, 1 - loin - 0.03)), (0.12, 0.1, 0.09), material=fur(kit, PINK, pattern=PLAIN))
    if name in (*EQUINE[:3], "camel") and pose in ("stand", "walk") and kit.chance(0.2):
        kit.add(BALL, place((0.08 * long, 0, 0.86)), (0.17, wide * 1.05, 0.19), material=kit.material(base=BROWN if kit.chance(0.5) else None, gloss=0.2))
    if name in CANINE[:12] and kit.chance(0.4):
        kit.between(path[1] * 0.6 + path[-1] * 0.4, path[1] * 0.35 + path[-1] * 0.65, radii[1] * 1.04, material=kit.material(gloss=0.2))


def crouched(kit):
    """Rabbits, hares and squirrels on their haunches."""
    rng = kit.rng
    name = str(rng.choice(["rabbit", "hare", "squirrel"]))
    coat = fur(kit, *{"rabbit": (GREY, TAN, WHITE, BROWN, BLACK), "hare": (TAN, SAND, WHITE), "squirrel": (RED, ORANGE, GREY)}[name])
    pale, pink = fur(kit, WHITE, CREAM), fur(kit, PINK, pattern=PLAIN)
    up = 58 if name == "squirrel" else rng.choice([12, 38])
    lift = turn("y", -up)
    seat = np.array([-0.18, 0, 0.26])
    chest = seat + lift @ np.array([0.42, 0, 0])
    hull(kit, [seat, (seat + chest) / 2 + lift @ np.array([0, 0, 0.04]), chest], [0.25, 0.25, 0.17], coat, 0.88)
    kit.add(BALL, (seat + chest) / 2 + lift @ np.array([0.08, 0, -0.08]), (0.3, 0.17, 0.18), rotation=lift, material=pale)
    neck = chest + np.array([0.13, 0, 0.16])
    hull(kit, [chest, neck], [0.16, 0.12], coat, first=False)
    head = Head(kit, neck + np.array([0.04, 0, 0.03]), looking(kit, 14, 25), 0.125)
    head.ball((0, 0, 0), (1.15, 0.9, 0.98), coat)
    head.ball((0.72, 0, -0.25), (0.62, 0.6, 0.55), coat)
    head.ball((0.98, 0.2, -0.38), (0.3, 0.28, 0.26), pale, True)
    head.ball((1.3, 0, -0.16), (0.1, 0.14, 0.1), pink)
    head.eyes(0.55, 0.74, 0.25, 0.17)
    if name == "squirrel":
        head.ear("leaf", 0.5, coat, pink)
    elif name == "rabbit" and kit.chance(0.3):
        head.ball((-0.1, 0.95, -0.35), (0.3, 0.17, 1.0), coat, True, (-10, 10))
    else:
        head.ear("leaf", 1.0 if name == "rabbit" else 1.25, coat, pink)
    for side in (1, -1):
        kit.add(BALL, seat + [0.08, side * 0.17, -0.03], (0.24, 0.11, 0.2), rotation=turn("y", -25), material=coat)
        kit.between((-0.18, side * 0.19, 0.045), (0.22, side * 0.2, 0.04), (0.045, 0.055), CYL, 0.8, coat)
        kit.add(BALL, (0.22, side * 0.2, 0.04), (0.07, 0.05, 0.04), material=pale)
        if name == "squirrel":
            hull(kit, [chest + [0.05, side * 0.12, -0.03], chest + [0.14, side * 0.14, -0.14], chest + [0.24, side * 0.04, -0.08]], [0.06, 0.045, 0.035], coat)
        else:
            hull(kit, [chest + [0.02, side * 0.1, -0.05], (chest[0] + 0.05, side * 0.1, 0.05)], [0.075, 0.05], coat)
            kit.add(BALL, (chest[0] + 0.1, side * 0.1, 0.04), (0.08, 0.05, 0.04), material=pale)
    if name == "squirrel":
        kit.add(BALL, chest + [0.26, 0, -0.06], (0.06, 0.055, 0.065), material=fur(kit, BROWN, pattern=PLAIN, gloss=0.3))
        path = [(-0.35, 0, 0.1), (-0.52, 0, 0.3), (-0.5, 0, 0.62), (-0.42, 0, 0.88), (-0.56, 0, 1.0)]
        hull(kit, path, [0.08, 0.14, 0.16, 0.14, 0.07], coat, 0.8)
    else:
        kit.add(BALL, seat + [-0.27, 0, -0.05], (0.08,) * 3, material=pale)


def kangaroo(kit):
    rng = kit.rng
    coat = fur(kit, TAN, RED, GREY, FAWN)
    pale, dark = fur(kit, CREAM, WHITE), fur(kit, DARK, BROWN)
    hip, chest = np.array([-0.1, 0, 0.5]), np.array([0.2, 0, rng.uniform(0.9, 1.0)])
    hull(kit, [hip, (hip + chest) / 2 - [0.01, 0, 0], chest], [0.25, 0.21, 0.14], coat, 0.85)
    kit.add(BALL, (hip + chest) / 2 + [0.08, 0, -0.05], (0.15, 0.15, 0.3), rotation=turn("y", 30), material=pale)
    neck = chest + [0.1, 0, 0.24]
    hull(kit, [chest, neck], [0.13, 0.075], coat, first=False)
    head = Head(kit, neck + [0.03, 0, 0.03], looking(kit, 15, 25), 0.085)
    head.ball((0, 0, 0), (1.1, 0.88, 0.95), coat)
    kit.between(head.place(0.2, 0, -0.08), head.place(2.0, 0, -0.35), 0.062, CYL, 0.65, coat)
    head.ball((2.05, 0, -0.35), (0.42, 0.45, 0.45), pale)
    head.ball((2.35, 0, -0.2), (0.18, 0.22, 0.16), black(kit))
    head.eyes(0.62, 0.72, 0.25, 0.17)
    head.ear("leaf", 1.1, coat, fur(kit, PINK))
    for side in (1, -1):
        kit.add(BALL, (0.0, side * 0.2, 0.42), (0.17, 0.1, 0.28), rotation=turn("y", -32), material=coat)
        hull(kit, [(0.14, side * 0.21, 0.26), (-0.16, side * 0.21, 0.09)], [0.075, 0.045], coat)
        kit.between((-0.2, side * 0.21, 0.04), (0.3, side * 0.21, 0.035), (0.035, 0.045), CYL, 0.7, dark)
        hull(kit, [chest + [0.06, side * 0.12, 0], chest + [0.16, side * 0.15, -0.2], chest + [0.28, side * 0.12, -0.24]], [0.055, 0.038, 0.03], coat)
        kit.add(BALL, chest + [0.31, side * 0.12, -0.25], (0.05, 0.035, 0.03), material=dark)
    hull(kit, bend((-0.25, 0, 0.4), (-0.6, 0, 0.0), (-1.25, 0, 0.04), 5), [0.17, 0.12, 0.085, 0.06, 0.03], coat)
    if kit.chance(0.35):
        joey = Head(kit, (hip + chest) / 2 + [0.26, 0, -0.08], turn("y", 5), 0.055)
        joey.ball((0, 0, 0), (1.4, 0.95, 1), coat)
        joey.ear("leaf", 1.0, coat)
        joey.eyes(0.7, 0.75, 0.25, 0.18)


def seal(kit):
    """Seals, sea lions on their flippers and walruses."""
    rng = kit.rng
    kind = str(rng.choice(["seal", "lion", "walrus"]))
    coat = fur(kit, *{"seal": (GREY, SILVER, SLATE), "lion": (DARK, BROWN), "walrus": (BROWN, (0.3, 0.17, 0.11))}[kind], pattern=SPECKLES if kind == "seal" else CLOUDY, gloss=0.25)
    up = {"seal": 0.05, "lion": 0.42, "walrus": 0.28}[kind]
    fat = {"seal": 0.25, "lion": 0.23, "walrus": 0.34}[kind]
    path = [(-0.95, 0, 0.08), (-0.6, 0, fat * 0.62), (-0.15, 0, fat * 0.95), (0.25, 0, fat * 0.95 + up * 0.45), (0.48, 0, fat + up * 1.15)]
    hull(kit, path, np.array([0.3, 0.68, 1.0, 0.92, 0.6]) * fat, coat)
    tip = np.array(path[-1]) + [0.14, 0, 0.16]
    hull(kit, [path[-1], tip], [fat * 0.6, fat * 0.5], coat, first=False)
    head = Head(kit, tip + [0.04, 0, 0.02], looking(kit, 5, 20), fat * 0.52)
    head.ball((0, 0, 0), (1.15, 0.95, 0.95), coat)
    head.ball((0.75, 0.24, -0.25), (0.5, 0.38, 0.36), coat if kind != "walrus" else fur(kit, TAN), True)
    head.ball((1.2, 0, 0), (0.14, 0.2, 0.13), black(kit))
    head.eyes(0.78, 0.5, 0.28, 0.15 if kind == "seal" else 0.1)
    if kind == "walrus":
        head.rods([(0.95, 0.3, -0.4), (1.15, 0.34, -1.3), (1.1, 0.32, -2.0)], [0.13, 0.1, 0.04], fur(kit, CREAM, pattern=PLAIN, gloss=0.3))
    for side in (1, -1):
        sole = fur(kit, DARK) if kind == "lion" else coat
        hull(kit, [(0.25, side * fat * 0.75, fat * 0.7), (0.28, side * (fat + 0.12), 0.05)], [0.09, 0.06], sole)
        kit.add(BALL, (0.22, side * (fat + 0.25), 0.03), (0.12, 0.22, 0.03), rotation=turn("z", -25 * side), material=sole)
        kit.add(BALL, (-1.12, side * 0.1, 0.05), (0.2, 0.075, 0.035), rotation=turn("z", -22 * side), material=sole)


def ape(kit):
    """Gorillas on their knuckles, monkeys on four hands or sitting, with long tails."""
    rng = kit.rng
    gorilla = kit.chance(0.45)
    coat = fur(kit, BLACK, (0.05, 0.05, 0.06)) if gorilla else fur(kit, BROWN, TAN, GREY, DARK, ORANGE)
    face = fur(kit, (0.05, 0.045, 0.045), pattern=PLAIN, gloss=0.15) if gorilla else fur(kit, PINK, TAN, CREAM, DARK, pattern=PLAIN)
    fat = 1.0 if gorilla else 0.62
    sits = kit.chance(0.4)
    hip = np.array([-0.38, 0, 0.52]) if not sits else np.array([-0.12, 0, 0.24 * fat + 0.03])
    chest = np.array([0.25, 0, 0.82 if gorilla else 0.66]) if not sits else np.array([0.05, 0, 0.85])
    middle = (hip + chest) / 2
    hull(kit, [hip, middle, chest], np.array([0.26, 0.3, 0.3]) * fat, coat, [1.0, 1.05, 1.12])
    if gorilla and kit.chance(0.6):
        kit.add(BALL, middle + ([0, 0, 0.12] if not sits else [-0.12, 0, 0]), (0.28, 0.27, 0.2), rotation=turn("y", -20 if not sits else -75), material=fur(kit, SILVER))
    neck = chest + np.array([0.2, 0, 0.26]) * (1 if gorilla else 0.75) * ([1, 1, 1] if not sits else [0.3, 1, 1.3])
    hull(kit, [chest, neck], np.array([0.22, 0.16]) * fat, coat, first=False)
    size = 0.17 if gorilla else 0.135
    head = Head(kit, neck + [0.03, 0, 0.05], looking(kit, 5, 25), size)
    head.ball((-0.05, 0, 0.1), (1.0, 0.9, 1.05), coat)
    if gorilla:
        head.ball((-0.25, 0, 0.75), (0.75, 0.5, 0.7), coat)
    head.ball((0.55, 0, -0.1), (0.5, 0.72, 0.75), face)
    head.ball((0.8, 0, -0.45), (0.5, 0.55, 0.45), face)
    head.ball((0.8, 0, 0.3), (0.25, 0.68, 0.16), face)
    head.ball((1.25, 0.16, -0.3), (0.08, 0.1, 0.07), black(kit), True)
    head.eyes(0.96, 0.3, 0.12, 0.1)
    head.ball((-0.05, 0.92, 0.05), (0.2, 0.14, 0.3), face, True)
    for side in (1, -1):
        shoulder = chest + np.array([0.06, side * 0.28 * fat, 0.06])
        if sits:
            hand = np.array([0.34, side * 0.3 * fat, 0.42 * fat + 0.1])
            elbow = (shoulder + hand) / 2 + [-0.03, side * 0.12, -0.12]
        else:
            hand = np.array([0.42 + side * 0.1, side * 0.3 * fat, 0.06])
            elbow = (shoulder + hand) / 2 + [-0.05, side * 0.06, 0]
        hull(kit, [shoulder, elbow, hand], np.array([0.15, 0.115, 0.085]) * fat, coat)
        kit.add(BALL, hand + [0.04, 0, -0.01], np.array([0.12, 0.085, 0.07]) * fat, material=face)
        thigh = hip + [0.02, side * 0.2 * fat, 0]
        knee = np.array([0.3, side * 0.36 * fat, 0.42 * fat + 0.05]) if sits else hip + [0.18, side * 0.24 * fat, -0.2]
        sole = np.array([0.28 if sits else -0.34 - side * 0.08, side * 0.3 * fat, 0.05])
        hull(kit, [thigh, knee, sole], np.array([0.17, 0.12, 0.08]) * fat, coat)
        kit.add(BALL, sole + [0.08, 0, -0.01], np.array([0.15, 0.08, 0.06]) * fat, material=face)
    if not gorilla:
        start = hip + [-0.14, 0, 0.02]
        way = bend(start, start + [-0.5, 0, 0.1 if not sits else -0.25], start + [-0.55, rng.uniform(-0.2, 0.2), 0.6 if not sits else -0.12], 6)
        hull(kit, way, np.linspace(0.055, 0.03, 6), coat)


def hedgehog(kit):
    """A dome of spines over a pale face and belly."""
    rng = kit.rng
    spine, pale = fur(kit, BROWN, DARK, TAN, pattern=SPECKLES, frequency=24, second=CREAM), fur(kit, CREAM, TAN)
    kit.add(BALL, (-0.05, 0, 0.3), (0.5, 0.33, 0.29), material=spine)
    kit.add(BALL, (0.05, 0, 0.22), (0.48, 0.29, 0.2), material=pale)
    hull(kit, [(0.35, 0, 0.27), (0.66, 0, 0.2)], [0.19, 0.06], pale)
    kit.add(BALL, (0.74, 0, 0.21), (0.045,) * 3, material=black(kit))
    kit.add(BALL, (0.55, 0.11, 0.3), (0.03,) * 3, material=black(kit), mirror=True)
    kit.add(BALL, (0.4, 0.18, 0.37), (0.03, 0.06, 0.07), material=pale, mirror=True)
    for x in (0.28, -0.3):
        kit.chain([(x, 0.18, 0.15), (x + 0.02, 0.2, 0.04)], [0.07, 0.05], pale, mirror=True)
        kit.add(BALL, (x + 0.07, 0.2, 0.03), (0.08, 0.05, 0.03), material=pale, mirror=True)
    for row, count in ((20, 9), (45, 9), (68, 7), (90, 3)):
        for k in range(count):
            angle, lift = np.radians(50 + 260 * (k + 0.5 * (row % 2)) / max(count - 0.5, 1)), np.radians(row + rng.uniform(-6, 6))
            way = np.array([np.cos(angle) * np.cos(lift), np.sin(angle) * np.cos(lift), np.sin(lift)])
            foot_at = np.array([-0.05, 0, 0.3]) + way * [0.46, 0.3, 0.26]
            kit.between(foot_at, foot_at + way * 0.14 + [-0.06, 0, 0], 0.035, CYL, 0.05, spine)


def four_legged(kit):
    """Dogs of twelve breeds, wolves, foxes, cats great and small, hyenas, horses, donkeys, zebras, cattle, bison, goats, sheep, pigs, boars, deer, moose,
    camels, llamas, elephants, rhinos, hippos, giraffes, bears, tapirs, capybaras, badgers, raccoons, otters, anteaters, armadillos, mice, hedgehogs,
    rabbits, hares, squirrels, kangaroos, seals, walruses, monkeys, gorillas."""
    special = {"crouched": crouched, "kangaroo": kangaroo, "seal": seal, "ape": ape, "hedgehog": hedgehog}
    names = [*SHAPES, *special]
    often = {"cat": 3, "horse": 3, "cow": 2, "crouched": 3, "ape": 2, "seal": 1.5, "elephant": 2, "lion": 2, "deer": 2, "sheep": 1.5, "bear": 1.5}
    weights = np.array([often.get(n, 1) for n in names], float)
    name = str(kit.rng.choice(names, p=weights / weights.sum()))
    if name in special:
        special[name](kit)
    else:
        beast_of(kit, name)


# Half length and radius of the body, legs, rise of the body in degrees; the neck's length and radius; skull; bill's length and depth; tail.
BIRDS = {
    "heron": (0.3, 0.15, 0.6, 18, 0.62, 0.042, 0.058, 0.34, 0.034, 0.14),
    "stork": (0.32, 0.17, 0.6, 14, 0.46, 0.055, 0.066, 0.36, 0.04, 0.13),
    "flamingo": (0.28, 0.16, 0.85, 10, 0.8, 0.034, 0.055, 0.16, 0.04, 0.12),
    "ostrich": (0.42, 0.3, 0.9, 5, 0.85, 0.058, 0.078, 0.13, 0.045, 0.24),
    "crane": (0.33, 0.17, 0.68, 12, 0.62, 0.05, 0.058, 0.24, 0.032, 0.18),
    "hen": (0.28, 0.2, 0.17, 18, 0.2, 0.09, 0.075, 0.075, 0.04, 0.2),
    "cock": (0.28, 0.18, 0.24, 30, 0.26, 0.09, 0.075, 0.08, 0.042, 0.2),
    "goose": (0.38, 0.2, 0.2, 10, 0.44, 0.058, 0.075, 0.13, 0.05, 0.16),
    "duck": (0.32, 0.17, 0.11, 6, 0.2, 0.06, 0.078, 0.14, 0.045, 0.14),
    "peacock": (0.3, 0.16, 0.3, 20, 0.36, 0.052, 0.055, 0.07, 0.03, 0.2),
    "pigeon": (0.24, 0.14, 0.11, 25, 0.13, 0.07, 0.062, 0.06, 0.026, 0.25),
    "gull": (0.27, 0.13, 0.14, 12, 0.12, 0.075, 0.07, 0.11, 0.034, 0.2),
    "crow": (0.25, 0.13, 0.14, 26, 0.1, 0.08, 0.072, 0.12, 0.042, 0.24),
    "robin": (0.17, 0.13, 0.11, 36, 0.06, 0.1, 0.088, 0.06, 0.026, 0.17),
    "toucan": (0.25, 0.14, 0.1, 48, 0.11, 0.085, 0.09, 0.3, 0.085, 0.24),
    "pelican": (0.38, 0.2, 0.14, 16, 0.36, 0.062, 0.078, 0.46, 0.055, 0.12),
    "parrot": (0.27, 0.14, 0.07, 62, 0.1, 0.105, 0.1, 0.07, 0.05, 0.42),
    "eagle": (0.32, 0.19, 0.13, 55, 0.13, 0.115, 0.088, 0.09, 0.05, 0.26),
    "owl": (0.28, 0.21, 0.07, 76, 0.06, 0.19, 0.185, 0.0, 0.0, 0.16),
    "penguin": (0.44, 0.21, 0.05, 86, 0.1, 0.13, 0.115, 0.13, 0.038, 0.06),
}
# Body, wing, head, legs, bill, breast.
PLUMES = {
    "heron": [((0.35, 0.38, 0.42), SLATE, WHITE, TAN, ORANGE, WHITE), (WHITE, WHITE, WHITE, BLACK, GOLD, None)],
    "stork": [(WHITE, BLACK, WHITE, (0.6, 0.08, 0.03), (0.6, 0.08, 0.03), None)],
    "flamingo": [((0.85, 0.36, 0.32), (0.8, 0.15, 0.12), (0.85, 0.4, 0.35), (0.8, 0.32, 0.3), CREAM, None), ((0.82, 0.55, 0.5), (0.8, 0.3, 0.25), (0.82, 0.5, 0.45), PINK, CREAM, None)],
    "ostrich": [(BLACK, WHITE, PINK, PINK, TAN, None), (BROWN, BROWN, TAN, TAN, TAN, None)],
    "crane": [(SILVER, DARK, BLACK, BLACK, GREY, None), (WHITE, BLACK, WHITE, BLACK, GREY, None)],
    "hen": [(RED, RED, RED, GOLD, GOLD, None), (WHITE, WHITE, WHITE, GOLD, GOLD, None), (BLACK, BLACK, BLACK, GREY, GREY, None), (TAN, BROWN, GOLD, GOLD, GOLD, None)],
    "cock": [(BLACK, RED, ORANGE, GOLD, GOLD, BLACK), (WHITE, WHITE, WHITE, GOLD, GOLD, None), (RED, BROWN, GOLD, GOLD, GOLD, BLACK)],
    "goose": [(WHITE, WHITE, WHITE, ORANGE, ORANGE, None), (GREY, BROWN, GREY, ORANGE, ORANGE, WHITE), (BROWN, BROWN, BLACK, BLACK, BLACK, CREAM)],
    "duck": [(SILVER, BROWN, (0.02, 0.16, 0.07), ORANGE, GOLD, BROWN), (TAN, BROWN, TAN, ORANGE, TAN, None), (WHITE, WHITE, WHITE, ORANGE, ORANGE, None)],
    "peacock": [((0.01, 0.06, 0.3), TAN, (0.01, 0.06, 0.35), GREY, GREY, None)],
    "pigeon": [((0.3, 0.33, 0.38), SILVER, SLATE, (0.6, 0.15, 0.12), DARK, None), (WHITE, WHITE, WHITE, PINK, PINK, None)],
    "gull": [(WHITE, SILVER, WHITE, PINK, GOLD, None), (WHITE, SLATE, WHITE, GOLD, GOLD, None)],
    "crow": [(BLACK,) * 5 + (None,), (BLACK, BLACK, BLACK, BLACK, BLACK, WHITE)],
    "robin": [(BROWN, BROWN, BROWN, DARK, DARK, ORANGE), (TAN, BROWN, BROWN, DARK, GREY, CREAM), ((0.05, 0.2, 0.45), (0.04, 0.12, 0.3), (0.05, 0.2, 0.5), DARK, DARK, GOLD)],
    "toucan": [(BLACK, BLACK, BLACK, SLATE, ORANGE, WHITE)],
    "pelican": [(WHITE, WHITE, WHITE, ORANGE, GOLD, None), (BROWN, GREY, WHITE, DARK, GREY, None)],
    "parrot": [((0.6, 0.02, 0.02), (0.02, 0.1, 0.5), (0.6, 0.02, 0.02), DARK, CREAM, None), ((0.02, 0.15, 0.55), (0.02, 0.1, 0.4), (0.02, 0.2, 0.5), DARK, BLACK, GOLD)]
    + [((0.08, 0.4, 0.04), (0.04, 0.25, 0.05), (0.1, 0.45, 0.05), GREY, RED, None), (SILVER, GREY, SILVER, DARK, BLACK, None), (WHITE, WHITE, WHITE, GREY, DARK, None)],
    "eagle": [(DARK, DARK, WHITE, GOLD, GOLD, None), (BROWN, DARK, GOLD, GOLD, DARK, None), (SLATE, SLATE, SLATE, GOLD, DARK, CREAM)],
    "owl": [(TAN, BROWN, TAN, TAN, DARK, CREAM), (WHITE, WHITE, WHITE, WHITE, BLACK, None), (BROWN, DARK, BROWN, TAN, DARK, TAN)],
    "penguin": [(BLACK, BLACK, BLACK, DARK, ORANGE, WHITE), (SLATE, BLACK, BLACK, ORANGE, BLACK, WHITE)],
}


def bill(kit, name, head, far, deep, horn):
    """Dagger, hook, flat bill, the flamingo's bend, the pelican's pouch, the toucan's banana."""
    if name in ("parrot", "eagle"):
        hooked(head, horn, 0.2 if name == "parrot" else 0.45, 0.5)
    elif name == "flamingo":
        kit.chain([head.place(0.7, 0, 0), head.place(2.0, 0, -0.4)], [deep, deep * 1.05], horn)
        kit.between(head.place(2.0, 0, -0.4), head.place(2.5, 0, -1.7), deep * 1.05, CYL, 0.25, black(kit))
    elif name == "toucan":
        path = [head.place(0.6, 0, 0.05), head.place(2.2, 0, 0.15), head.place(3.6, 0, -0.1), head.place(4.2, 0, -0.6)]
        hull(kit, path, np.array([deep, deep * 0.92, deep * 0.6, deep * 0.2]), horn, 0.55, first=False)
    elif name in ("goose", "duck", "pelican"):
        reach = 0.8 + far / head.size
        kit.between(head.place(0.6, 0, -0.05), head.place(reach, 0, -0.3), (deep * 0.6, deep), CYL, 0.75, horn)
        head.ball((reach, 0, -0.3), (0.3, deep * 0.85 / head.size, 0.2), horn)
        if name == "pelican":
            head.ball((0.6 + reach * 0.42, 0, -0.65), (reach * 0.48, 0.45, 0.55), fur(kit, ORANGE, GOLD, pattern=PLAIN))
    elif far:
        kit.between(head.place(0.7, 0, 0), head.place(0.8 + far / head.size, 0, -0.2), (deep, deep * 0.75), CYL, 0.1, horn)


def standing_bird(kit):
    """Waders, ostriches, poultry, ducks, peacocks, pigeons, gulls, crows, songbirds, toucans, pelicans, parrots, eagles, owls, penguins."""
    rng = kit.rng
    name = str(rng.choice(list(BIRDS)))
    shape = np.array(BIRDS[name])
    shape[[0, 1, 2, 4, 5, 6, 7, 9]] *= np.exp(rng.normal(0, 0.07, 8))
    long, fat, leg, pitch, neck, thick, size, far, deep, train = shape
    pitch += rng.normal(0, 4)
    options = PLUMES[name]
    chosen = options[rng.integers(len(options))]
    body, quills, hood, shank, horn = (fur(kit, c, pattern=rng.choice([PLAIN, CLOUDY, STREAKS]) if i < 2 else PLAIN, gloss=0.08) for i, c in enumerate(chosen[:5]))
    if name == "owl":
        body = body._replace(pattern=SPECKLES, frequency=14.0)
    breast = fur(kit, chosen[5], pattern=PLAIN) if chosen[5] else None
    aim = turn("y", -pitch) @ np.array([1.0, 0, 0])
    high = np.array([-aim[2], 0, aim[0]])
    centre = np.array([0, 0, leg + fat * 0.8 * aim[0] + (long * 0.72 + fat * 0.3) * aim[2]])
    radii = np.array([0.4, 0.84, 1.0, 0.78]) * fat
    hull(kit, [centre + aim * long * t for t in (-0.9, -0.35, 0.25, 0.7)], radii, body, 0.92)
    if breast:
        kit.add(BALL, centre + aim * long * 0.2 - high * fat * 0.22, (long * 0.78, fat * 0.83, fat * 0.85), rotation=turn("y", -pitch), material=breast)
    # Neck and head.
    fore = centre + aim * long * 0.75 + high * fat * 0.3
    if name in ("heron", "flamingo", "pelican"):
        steps = [(0.16, 0, 0.1), (0.12, 0, 0.38), (-0.02, 0, 0.6), (0.02, 0, 0.85), (0.14, 0, 0.97)]
    elif neck > 0.3:
        steps = [(0.16, 0, 0.12), (0.16, 0, 0.5), (0.14, 0, 1.0)]
    else:
        steps = [(0.3, 0, 0.9)]
    path = [fore, *(fore + np.array(p) * neck for p in steps)]
    slim = name in ("ostrich", "flamingo", "heron", "stork", "crane", "goose", "peacock", "pelican")
    wide = [fat * 0.62] + ([thick * 1.45] if len(path) > 2 else []) + [thick] * (len(path) - (2 if len(path) > 2 else 1))
    hull(kit, path, wide, hood if slim or name == "duck" else body if name != "cock" else hood, first=False)
    head = Head(kit, path[-1] + [size * 0.35, 0, size * 0.3], looking(kit, 4, 30), size)
    head.ball((0, 0, 0), (1.12, 0.95, 0.95), hood)
    bill(kit, name, head, far, deep, horn)
    if name == "owl":
        head.ball((0.6, 0.4, 0.0), (0.4, 0.46, 0.58), fur(kit, CREAM, WHITE, pattern=PLAIN), True)
        head.eyes(0.88, 0.38, 0.1, 0.16, kit.material(base=paint(rng.choice([0.1, 0.14]), 0.9, 0.8), pattern=PLAIN, gloss=0.6))
        kit.between(head.place(0.95, 0, -0.05), head.place(1.1, 0, -0.45), size * 0.12, CYL, 0.1, horn)
        if kit.chance(0.5):
            head.ear("prick", 0.4, quills)
    else:
        head.eyes(0.5, 0.76, 0.28, 0.2 if name != "penguin" else 0.12)
    if name in ("hen", "cock"):
        red, big = fur(kit, (0.55, 0.03, 0.02), pattern=PLAIN), 1.0 if name == "hen" else 1.6
        for x, z in ((0.42, 1.0), (-0.22, 1.0)):
            head.ball((x, 0, z), (0.4, 0.1, 0.4 * big), red)
        head.ball((0.85, 0.15, -0.8), (0.18, 0.1, 0.36 * big), red, True)
    elif name == "peacock":
        for angle in (-25, 0, 25):
            tip = turn("y", angle - 8) @ np.array([0, 0, 1.7])
            kit.between(head.place(0, 0, 0.8), head.place(0, 0, 0.8) + tip * size, 0.006, material=horn)
            kit.add(BALL, head.place(0, 0, 0.8) + tip * size, (0.016,) * 3, material=body)
    elif name == "heron":
        head.rods([(-0.6, 0, 0.5), (-3.0, 0, 0.0)], [0.22, 0.05], quills, both=False)
    elif name == "penguin":
        head.ball((-0.1, 0.62, -0.15), (0.42, 0.36, 0.5), fur(kit, GOLD, WHITE, pattern=PLAIN), True)
    # Wings, tail, legs.
    rear = centre - aim * long * 0.95
    if name == "penguin":
        kit.add(BALL, centre + [-0.02, fat * 1.02, 0.02], (0.11, 0.025, 0.3), rotation=turn("x", 12), material=quills, mirror=True)
    elif name == "ostrich":
        kit.add(BALL, centre + [-0.1, fat * 0.8, 0.02], (0.36, 0.12, 0.22), rotation=turn("y", 10), material=body, mirror=True)
        kit.add(BALL, centre + [-0.4, fat * 0.55, -0.06], (0.16, 0.14, 0.14), material=quills, mirror=True)
        kit.add(BALL, rear + [0, 0, 0.02], (0.2, 0.13, 0.17), material=quills)
    else:
        folded_wing(kit, fore + [-0.04, fat * 0.72, 0], rear + [-train * 0.25, fat * 0.3, 0] - high * fat * 0.1, fat * 0.66, fat * 0.28, quills if name in ("pelican", "eagle", "parrot") else body, quills)
    if name == "cock":
        for k, reach in ((0, 0.42), (1, 0.36), (2, 0.28)):
            for side in (1, -1):
                start = rear + [0.05, side * 0.02, 0.05]
                hull(kit, bend(start, start + [-0.15 - 0.08 * k, side * 0.03, reach], start + [-0.38 - 0.03 * k, side * 0.05, reach * 0.55 - 0.12 * k], 3), [0.05, 0.045, 0.015], quills if k else body, 0.3, first=False)
    elif name == "peacock":
        eyed = fur(kit, (0.03, 0.2, 0.08), (0.02, 0.25, 0.2), pattern=DOTS, frequency=11, second=(0.02, 0.08, 0.4))
        if kit.chance(0.65):
            count, big = 13, rng.uniform(0.8, 1.05)
            for angle in np.linspace(-98, 98, count):
                way = np.array([-0.22, np.sin(np.radians(angle)), np.cos(np.radians(angle))])
                kit.between(rear + [0.1, 0, 0], rear + way * big, (0.014, 0.045), BOX, 2.9, eyed)
        else:
            kit.between(rear, (rear[0] - 0.9, 0, 0.05), (0.05, 0.1), CYL, 1.4, eyed)
            kit.add(BALL, (rear[0] - 0.9, 0, 0.08), (0.2, 0.16, 0.06), material=eyed)
    elif name != "ostrich":
        up = {"hen": 0.6, "penguin": 0.0}.get(name, -0.05)
        kit.between(rear + aim * 0.06, rear - aim * train + high * train * up, (0.02, fat * 0.3), BOX, 1.4 if name not in ("parrot", "heron") else 0.7, quills)
    hip = centre[2] - fat * 0.55 * aim[0] - long * 0.35 * aim[2]
    thin = {"ostrich": 0.04, "penguin": 0.06, "eagle": 0.03, "owl": 0.035}.get(name, 0.02)
    kit.add(BALL, (-0.02, fat * 0.48, hip), (fat * 0.42, fat * 0.34, fat * (0.62 if name != "ostrich" else 1.0)), material=body if name != "ostrich" else shank, mirror=True)
    heel, at = (-0.05 - 0.03 * leg, fat * 0.5, hip * 0.5), (0.02, fat * 0.5, thin * 0.9)
    hull(kit, [(0, fat * 0.48, hip), heel, at], [thin * 1.3, thin * 1.1, thin * 0.9], shank, mirror=True, first=False)
    if name in ("duck", "goose", "gull", "pelican", "penguin", "flamingo"):
        kit.add(BOX, (0.08, fat * 0.5, 0.012), (0.1, 0.075, 0.012), (0.9, 0.9), material=shank, mirror=True)
    else:
        for angle in (-32, 0, 32) if name != "ostrich" else (-15, 12):
            kit.between(at, np.array(at) * [1, 1, 0.5] + turn("z", angle) @ np.array([0.09 + thin * 2.5, 0, 0]), thin * 0.75, CYL, 0.5, shank, mirror=True)
        kit.between(at, (-0.08, fat * 0.5, thin * 0.5), thin * 0.7, CYL, 0.5, shank, mirror=True)


def flying_bird(kit):
    """Gulls, eagles, swallows, geese, ducks, parrots, doves, owls with spread wings, gliding or beating."""
    rng = kit.rng
    name = str(rng.choice(["gull", "eagle", "swallow", "goose", "duck", "parrot", "pigeon", "owl", "stork", "crow"]))
    chosen = PLUMES.get(name, [((0.02, 0.04, 0.12), BLACK, (0.02, 0.04, 0.14), DARK, DARK, WHITE)])
    chosen = chosen[rng.integers(len(chosen))]
    body, quills, hood, shank, horn = (fur(kit, c, pattern=PLAIN if i != 1 else STREAKS) for i, c in enumerate(chosen[:5]))
    span, chord = {"gull": (1.1, 0.2), "eagle": (1.15, 0.36), "swallow": (0.85, 0.16), "goose": (1.05, 0.3), "stork": (1.1, 0.34)}.get(name, (0.85, 0.3))
    fat = 0.11 if name != "swallow" else 0.075
    hull(kit, [(-0.34, 0, -0.01), (-0.1, 0, 0), (0.12, 0, 0), (0.28, 0, 0.01)], np.array([0.4, 0.9, 1.0, 0.7]) * fat, body, 1.05)
    if chosen[5]:
        kit.add(BALL, (0.06, 0, -0.025), (0.27, fat * 0.9, fat * 0.9), material=fur(kit, chosen[5]))
    reach = {"goose": 0.4, "stork": 0.38, "duck": 0.22}.get(name, 0.1)
    hull(kit, [(0.28, 0, 0.01), (0.32 + reach, 0, 0.04)], [fat * 0.7, 0.05], hood, first=False)
    head = Head(kit, (0.36 + reach, 0, 0.05), turn("y", 3), 0.07 if name != "owl" else 0.1)
    head.ball((0, 0, 0), (1.1, 0.9, 0.92), hood)
    bill(kit, name, head, 0.3 if name == "stork" else 0.09, 0.034, horn)
    head.eyes(0.5, 0.72, 0.25, 0.17)
    lift = rng.uniform(-0.25, 0.75)
    wrist, sweep = span * 0.42, rng.uniform(0, 0.15) + (0.2 if name in ("gull", "swallow") else 0)
    z = [0.04, 0.04 + lift * wrist, 0.04 + lift * wrist + (span - wrist) * (lift * 0.7 - 0.1)]
    front = [0.2, 0.27, 0.27 - sweep]
    arm = [(front[0], front[0] - chord * 1.15, fat * 0.5, z[0]), (front[1], front[1] - chord * 1.15, wrist, z[1])]
    blunt = 0.25 if name not in ("gull", "swallow") else 0.08
    hand = [arm[1], (front[2] + 0.03, front[2] - chord * 0.75, wrist + (span - wrist) * 0.6, z[1] * 0.4 + z[2] * 0.6), (front[2] - sweep * 0.6, front[2] - sweep * 0.6 - chord * blunt - 0.02, span, z[2])]
    membrane(kit, arm, 0.02, body)
    membrane(kit, [(arm[0][1] + 0.1, arm[0][1] - 0.05, *arm[0][2:]), (arm[1][1] + 0.1, arm[1][1] - 0.04, *arm[1][2:])], 0.012, quills)
    membrane(kit, hand, 0.014, quills)
    kit.chain([(front[0] - 0.02, fat * 0.4, z[0]), (front[1] - 0.02, wrist, z[1]), (front[2], span * 0.8, z[1] * 0.4 + z[2] * 0.6)], [0.04, 0.03, 0.014], body, mirror=True)
    if name in ("eagle", "stork", "crow", "owl"):
        for k in range(5):
            start = np.array([front[2] - 0.05 * k, span * (0.86 - 0.05 * k), np.interp(0.7 - 0.08 * k, [0, 1], z[1:])])
            kit.between(start, start + [-0.06 - 0.05 * k, 0.24 - 0.03 * k, 0.24 * (lift * 0.7)], (0.01, 0.03), BOX, 0.5, quills, mirror=True)
    if name == "swallow":
        sail(kit, (-0.8, 0.14, 0), (-0.3, 0, 0), (-0.36, 0.08, 0), 0.01, quills, mirror=True)
    else:
        long = 0.5 if name == "parrot" else 0.24
        kit.between((-0.3, 0, 0), (-0.3 - long, 0, -0.01), (0.012, 0.07), BOX, 2.0 if name != "parrot" else 0.6, quills if name != "eagle" else hood)
    if name in ("stork", "goose"):
        kit.chain([(-0.15, 0.05, -0.08), (-0.75 if name == "stork" else -0.4, 0.04, -0.05)], [0.02, 0.014], shank, mirror=True)


def skin(kit, *colours, gloss=0.25, **fixed):
    return fur(kit, *colours, gloss=gloss, **fixed)


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
    kit.add(BOX, (back * long, 0, high * (1.0 if name != "pike" else 0.75) + tall * 0.3), (long * (0.38 if name not in ("pike", "tuna") else 0.16), 0.012, tall * 0.65), (0.5, 1), (-long * 0.2, 0), material=fin)
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
    back = skin(kit, *{"dolphin": (SLATE, GREY), "orca": (BLACK,), "humpback": (SLATE,), "sperm": (GREY, SLATE)}.get(name, (GREY, (0.2, 0.25, 0.3))), pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.35)
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
    sail(kit, points[3] + [0.02 - reach * 0.6, fat * 0.6 + reach * 0.8, -fat * 0.6 - reach * 0.4], points[3] + [0.28, fat * 0.6, -fat * 0.42], points[3] + [0.04, fat * 0.62, -fat * 0.5], 0.022, back, mirror=True)
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


def turtle(kit):
    """Tortoises with a dome on pillars, sea turtles with flippers."""
    rng = kit.rng
    sea = kit.chance(0.45)
    hide = skin(kit, (0.2, 0.2, 0.08), TAN, GREY, (0.12, 0.15, 0.1), pattern=SPECKLES, frequency=16, gloss=0.1)
    shell = skin(kit, BROWN, (0.15, 0.17, 0.06), DARK, TAN, pattern=rng.choice([SEAMS, PATCHWORK, CAMOUFLAGE, CLOUDY]), frequency=rng.uniform(6, 10), second=GOLD if kit.chance(0.5) else BLACK)
    lift = 0.1 if sea else 0.2
    high = rng.uniform(0.16, 0.22) if sea else rng.uniform(0.34, 0.46)
    kit.add(BALL, (0, 0, lift + 0.06), (0.6, 0.48, high), material=shell)
    kit.add(CYL, (0, 0, lift + 0.04), (0.61, 0.49, 0.05), (0.92, 1), material=shell._replace(pattern=LEDGES))
    kit.add(BALL, (0, 0, lift + 0.02), (0.56, 0.44, 0.14), material=skin(kit, CREAM, TAN))
    if not sea and kit.chance(0.7):
        for x, y in ((0, 0), (0.27, 0), (-0.27, 0), (0.13, 0.24), (-0.16, 0.24), (0.13, -0.24), (-0.16, -0.24)):
            z = lift + 0.06 + high * np.sqrt(1 - (x / 0.6) ** 2 - (y / 0.48) ** 2)
            way = np.array([x / 0.36, y / 0.23, (z - lift) / high**2])
            kit.add(CYL, (x, y, z - 0.02), (0.14, 0.12, 0.045), (0.6, 1), rotation=towards(way), material=shell._replace(pattern=PLAIN))
    tip = np.array([0.86, 0, lift + (0.08 if sea else rng.uniform(0.1, 0.3))])
    hull(kit, [(0.45, 0, lift + 0.05), tip], [0.13, 0.085], hide, first=False)
    head = Head(kit, tip + [0.06, 0, 0.02], looking(kit, 5, 20), 0.11)
    head.ball((0, 0, 0), (1.25, 0.85, 0.85), hide)
    kit.between(head.place(0.6, 0, 0), head.place(1.5, 0, -0.25), (0.06, 0.07), CYL, 0.4, hide)
    head.eyes(0.6, 0.66, 0.25, 0.16)
    for side in (1, -1):
        if sea:
            hull(kit, [(0.38, side * 0.35, 0.13), (0.36, side * 0.75, 0.08), (0.02, side * 1.05, 0.05)], [0.09, 0.1, 0.03], hide, 0.8)
            kit.add(BALL, (0.18, side * 0.88, 0.06), (0.36, 0.11, 0.03), rotation=turn("z", -38 * side), material=hide)
            kit.add(BALL, (-0.5, side * 0.36, 0.07), (0.24, 0.11, 0.035), rotation=turn("z", -30 * side), material=hide)
        else:
            for x in (0.36, -0.38):
                hull(kit, [(x, side * 0.3, lift + 0.02), (x + np.sign(x) * 0.08, side * 0.44, 0.09)], [0.12, 0.095], hide)
                kit.add(CYL, (x + np.sign(x) * 0.08 + 0.02, side * 0.44, 0.045), (0.11, 0.1, 0.045), (0.85, 1), material=hide)
    kit.between((-0.55, 0, lift + 0.02), (-0.78, 0, lift - 0.04), 0.05, CYL, 0.2, hide)


def sprawler(kit):
    """Crocodiles, lizards, iguanas, salamanders, chameleons on a branch."""
    rng = kit.rng
    name = str(rng.choice(["crocodile", "lizard", "iguana", "salamander", "chameleon"]))
    greens = ((0.12, 0.14, 0.05), (0.2, 0.2, 0.1), (0.1, 0.35, 0.04), TAN, GREY)
    pattern = {"salamander": CAMOUFLAGE, "crocodile": PATCHWORK}.get(name, rng.choice([SPECKLES, CLOUDY, BANDS]))
    coat = skin(kit, *(greens if name not in ("salamander", "chameleon") else ((0.02, 0.02, 0.02), ORANGE) if name == "salamander" else ((0.1, 0.4, 0.05), (0.05, 0.35, 0.25))), pattern=pattern, frequency=rng.uniform(10, 18), second=GOLD if name in ("salamander", "chameleon") else None, gloss=0.2)
    pale, croc = skin(kit, CREAM, TAN), name == "crocodile"
    long, fat, z = (0.5, 0.19, 0.24) if croc else (0.36, 0.12, 0.2) if name != "salamander" else (0.4, 0.1, 0.12)
    if name == "chameleon":
        z = 0.55
        kit.between((-0.9, 0, 0.1), (0.75, 0, 0.22), 0.075, CYL, 0.8, skin(kit, BROWN, pattern=STREAKS, gloss=0.02))
        kit.between((-0.9, 0, 0), (-0.9, 0, 0.12), 0.1, material=skin(kit, BROWN))
    flat = 1.3 if croc else 0.6 if name == "chameleon" else 1.05
    tall = 1.6 if name == "chameleon" else 1.0
    hull(kit, [(-long, 0, z), (-long * 0.3, 0, z + 0.02), (long * 0.4, 0, z + 0.02), (long, 0, z + 0.02)], np.array([0.75, 1.0, 1.0, 0.7]) * fat * tall, coat, flat)
    kit.add(BALL, (0, 0, z - fat * 0.25 * tall), (long * 1.0, fat * flat * 0.92 * tall, fat * 0.82 * tall), material=pale)
    neck = np.array([long + 0.1, 0, z + (0.02 if croc else 0.08)])
    hull(kit, [(long, 0, z + 0.02), neck], [fat * 0.7, fat * 0.62], coat, first=False)
    size = fat * 0.8
    head = Head(kit, neck + [size * 0.6, 0, 0.02], looking(kit, 2, 20 if not croc else 8), size)
    head.ball((0, 0, 0), (1.15, 0.9, 0.75), coat)
    snout = 4.0 if croc else 1.7
    mouth = rng.choice([0.0, 18.0]) if croc else 0.0
    kit.between(head.place(0.2, 0, 0.05), head.place(snout, 0, 0.0), (size * 0.5, size * 0.72), CYL, 0.5, coat)
    head.ball((snout, 0, 0.02), (0.35, 0.38, 0.27), coat)
    jaw = head.facing @ turn("y", mouth) @ np.array([snout, 0, 0]) * size
    kit.between(head.place(0, 0, -0.35), head.place(0, 0, -0.35) + jaw, (size * 0.25, size * 0.66), CYL, 0.45, pale)
    if croc:
        for x in (2.2, 3.6):
            for y in (0.62 - 0.08 * x, 0.08 * x - 0.62):
                kit.between(head.place(x, y, -0.1), head.place(x, y, -0.5), size * 0.08, CYL, 0.1, skin(kit, WHITE, pattern=PLAIN))
    head.ball((0.3, 0.5, 0.55), (0.26, 0.2, 0.24) if name != "chameleon" else (0.4, 0.4, 0.4), coat, True)
    head.eyes(0.42 if name != "chameleon" else 0.5, 0.62 if name != "chameleon" else 0.82, 0.6, 0.14)
    if name == "chameleon":
        sail(kit, head.place(-1.3, 0, 1.5), head.place(0.4, 0, 0.5), head.place(-1.0, 0, -0.1), 0.03, coat)
    side = rng.choice([-1, 1]) * rng.uniform(0, 0.4)
    if name == "chameleon":
        path = [(-long, 0, z), (-0.65, 0, z - 0.05), (-0.95, 0, z - 0.15), (-1.05, 0, z - 0.4), (-0.85, 0, z - 0.42), (-0.8, 0, z - 0.27)]
    else:
        reach = 1.1 if croc else 1.2
        path = bend((-long, 0, z), (-long - reach * 0.5, side, z * 0.5), (-long - reach, -side, 0.03), 5)
    hull(kit, path, np.linspace(fat * 0.7, fat * 0.12, len(path)), coat, 0.8, first=False)
    for x, ahead in ((long * 0.75, 0.1), (-long * 0.8, -0.06)):
        for s in (1, -1):
            if name == "chameleon":
                joints = [(x, s * 0.07, z - 0.05), (x + ahead * 1.4, s * 0.2, z - 0.12), (x + ahead * 0.4, s * 0.06, 0.22)]
            else:
                joints = [(x, s * fat * flat * 0.8, z), (x - ahead * 0.6, s * (fat * flat + 0.16), z * 1.05), (x + ahead * 0.6, s * (fat * flat + 0.22), 0.03)]
            hull(kit, joints, np.array([0.42, 0.34, 0.24]) * fat, coat, first=False)
            if name != "chameleon":
                for angle in (-20, 30) if croc else (-25, 10, 45):
                    kit.between(joints[-1], np.array(joints[-1]) + turn("z", angle * s) @ np.array([fat * 0.75, 0, -0.012]), fat * 0.13, CYL, 0.4, coat)
    if name in ("iguana", "crocodile"):
        for x in np.linspace(-long * 1.1, long * 1.1, 7 if name == "iguana" else 5):
            high = fat * (0.5 if name == "iguana" else 0.2)
            for y in (0,) if name == "iguana" else (0.4 * fat, -0.4 * fat):
                kit.between((x, y, z + fat * 0.85), (x - 0.05, y, z + fat + high), (0.05, 0.014), CYL, 0.1, coat)


def snake(kit):
    """Winding, coiled with the head raised, cobras with a spread hood."""
    rng = kit.rng
    name = str(rng.choice(["winding", "coiled", "cobra"]))
    pattern = rng.choice([BANDS, SPECKLES, CAMOUFLAGE, PLAIN, DOTS])
    coat = skin(kit, GOLD, TAN, (0.1, 0.3, 0.05), BLACK, RED, GREY, (0.4, 0.05, 0.03), pattern=pattern, frequency=rng.uniform(8, 22), second=(BLACK, CREAM, DARK, WHITE)[rng.integers(4)], gloss=0.35)
    thick = rng.uniform(0.06, 0.11)
    if name == "winding":
        t = np.linspace(0, 1, 26)
        wave = rng.uniform(0.18, 0.32)
        path = np.stack([2.4 * t - 1.2, wave * np.sin(2 * np.pi * rng.uniform(1.3, 2.3) * t + 1), np.full(26, thick)], 1)
        radii = thick * np.interp(t, [0, 0.35, 0.8, 1], [0.12, 0.95, 1, 0.7])
    else:
        turns = rng.uniform(1.6, 2.3) if name == "coiled" else 1.4
        t = np.linspace(0, 1, 21)
        angle, radius = 2 * np.pi * turns * t, np.interp(t, [0, 1], [0.42, 0.16])
        path = np.stack([radius * np.cos(angle), radius * np.sin(angle), thick + t * (turns - 0.8) * thick * 1.7], 1)
        radii = thick * np.interp(t, [0, 0.3, 1], [0.2, 1, 1])
        up = rng.uniform(0.25, 0.45) if name == "coiled" else rng.uniform(0.6, 0.8)
        top = path[-1][2]
        path = np.concatenate([path, [(0.12, 0, top + 0.1), (0.1, 0, top + up * 0.6), (0.14, 0, top + up), (0.24, 0, top + up + 0.06)]])
        radii = np.concatenate([radii, thick * np.array([0.95, 0.85, 0.8, 0.7])])
    for i in range(len(path) - 1):
        kit.between(path[i], path[i + 1], radii[i], CYL, radii[i + 1] / radii[i], coat)
        kit.add(BALL, path[i + 1], (radii[i + 1],) * 3, rotation=towards(path[i + 1] - path[i]), material=coat)
    way = path[-1] - path[-2]
    head = Head(kit, path[-1] + way / np.linalg.norm(way) * thick * 0.8, turn("z", np.degrees(np.arctan2(way[1], way[0]))) @ turn("y", 5), thick * 1.1)
    head.ball((0.1, 0, 0), (1.5, 1.0, 0.7), coat)
    head.ball((0.9, 0, -0.05), (0.9, 0.65, 0.5), coat)
    head.eyes(0.7, 0.62, 0.38, 0.17)
    if name == "cobra":
        kit.add(BALL, path[-2] + [0, 0, -0.1], (0.05, thick * 2.4, 0.24), rotation=turn("y", 8), material=coat)
    if kit.chance(0.6):
        kit.between(head.place(1.7, 0, -0.15), head.place(2.9, 0, -0.25), 0.008, material=skin(kit, (0.4, 0.03, 0.03), pattern=PLAIN))


def frog(kit):
    rng = kit.rng
    coat = skin(kit, (0.1, 0.35, 0.03), (0.2, 0.22, 0.06), BROWN, (0.02, 0.1, 0.5), (0.6, 0.05, 0.02), GOLD, pattern=rng.choice([PLAIN, SPECKLES, CAMOUFLAGE]), frequency=10, second=BLACK if kit.chance(0.5) else None, gloss=0.4)
    pale = skin(kit, CREAM, WHITE, pattern=PLAIN)
    tilt = turn("y", -30)
    kit.add(BALL, (-0.08, 0, 0.3), (0.42, 0.3, 0.22), rotation=tilt, material=coat)
    kit.add(BALL, (0, 0, 0.26), (0.38, 0.27, 0.2), rotation=tilt, material=pale)
    kit.add(BALL, (0.26, 0, 0.49), (0.25, 0.27, 0.15), rotation=turn("y", 8), material=coat)
    kit.add(BALL, (0.28, 0, 0.43), (0.22, 0.25, 0.11), material=pale)
    kit.add(BALL, (0.24, 0.17, 0.61), (0.09, 0.08, 0.09), material=coat, mirror=True)
    kit.add(BALL, (0.275, 0.2, 0.625), (0.06, 0.055, 0.065), material=skin(kit, GOLD, (0.6, 0.05, 0.02), pattern=PLAIN, gloss=0.6), mirror=True)
    kit.add(BALL, (0.3, 0.222, 0.63), (0.035, 0.035, 0.045), material=black(kit), mirror=True)
    hull(kit, [(0.16, 0.22, 0.34), (0.12, 0.34, 0.2), (0.26, 0.32, 0.04)], [0.075, 0.06, 0.045], coat, mirror=True)
    hull(kit, [(-0.35, 0.17, 0.16), (0.02, 0.4, 0.22), (-0.34, 0.38, 0.08)], [0.13, 0.1, 0.055], coat, mirror=True)
    kit.between((-0.36, 0.36, 0.04), (0.0, 0.48, 0.03), 0.045, CYL, 0.8, coat, mirror=True)
    for angle in (-25, 5, 35):
        way = turn("z", angle) @ np.array([0.14, 0, -0.012])
        for at in ((0.26, 0.32, 0.03), (0.0, 0.48, 0.03)):
            kit.between(at, np.array(at) + way * (1 if at[0] else 1.5), 0.022, CYL, 0.6, coat, mirror=True)
            kit.add(BALL, np.array(at) + way * (1 if at[0] else 1.5), (0.03, 0.03, 0.018), material=coat, mirror=True)


def claw(kit, at, way, size, coat):
    """A pincer at `at` that points along the angle `way` in degrees, its two fingers apart; with its twin."""
    frame = turn("z", way)
    at = np.array(at, float)
    kit.add(BALL, at, np.array([0.5, 0.32, 0.24]) * size, rotation=frame, material=coat, mirror=True)
    for y, bow in ((0.16, 0.3), (-0.16, -0.3)):
        knuckle, tip = at + frame @ np.array([0.75, y + bow * 0.6, 0]) * size, at + frame @ np.array([1.15, y * 0.2, 0]) * size
        kit.chain([at + frame @ np.array([0.25, y, 0]) * size, knuckle, tip], np.array([0.17, 0.13, 0.04]) * size, coat, mirror=True, joints=False)


def shellfish(kit):
    """Crabs, lobsters, scorpions."""
    rng = kit.rng
    name = str(rng.choice(["crab", "lobster", "scorpion"]))
    coat = skin(kit, *{"crab": (ORANGE, (0.5, 0.08, 0.03), TAN, (0.1, 0.2, 0.3)), "lobster": ((0.55, 0.05, 0.02), (0.03, 0.08, 0.2), ORANGE)}.get(name, (BLACK, GOLD, BROWN)), pattern=rng.choice([PLAIN, CLOUDY, SPECKLES]), gloss=0.4)
    dark = black(kit)
    if name == "crab":
        z, legs = 0.24, ((0.2, 55), (0.05, 85), (-0.1, 105), (-0.22, 130))
        kit.add(BALL, (0, 0, z), (0.34, 0.5, 0.16), material=coat)
        kit.add(BALL, (0.04, 0, z - 0.04), (0.3, 0.44, 0.14), material=skin(kit, CREAM))
        kit.chain([(0.22, 0.36, z), (0.42, 0.58, z + 0.02), (0.58, 0.45, z)], [0.1, 0.09, 0.08], coat, mirror=True)
        claw(kit, (0.72, 0.36, z), -35, rng.uniform(0.25, 0.36), coat)
        kit.between((0.28, 0.12, z + 0.06), (0.34, 0.13, z + 0.22), 0.022, material=coat, mirror=True)
        kit.add(BALL, (0.34, 0.13, z + 0.23), (0.035,) * 3, material=dark, mirror=True)
        reach, root = 0.55, 0.32
    else:
        scorpion = name == "scorpion"
        z, legs = 0.15, ((0.18, 60), (0.08, 82), (-0.02, 105), (-0.12, 128))
        kit.add(BALL, (0.15, 0, z), (0.36, 0.15, 0.12), material=coat)
        for k in range(5):
            kit.add(CYL, (-0.1 - 0.12 * k, 0, z - 0.005 * k), (0.11 - 0.008 * k, 0.15 - 0.012 * k, 0.075), (0.88, 1), rotation=turn("y", -90), material=coat)
        if scorpion:
            tail_way = [(-0.62, 0, z), (-0.85, 0, z + 0.15), (-0.92, 0, z + 0.42), (-0.78, 0, z + 0.66), (-0.52, 0, z + 0.72), (-0.36, 0, z + 0.62)]
            for a, b in itertools.pairwise(tail_way):
                kit.add(BALL, (np.array(a) + b) / 2, (0.07, 0.07, 0.16), rotation=towards(np.subtract(b, a)), material=coat)
            kit.between(tail_way[-1], (-0.26, 0, z + 0.46), 0.04, CYL, 0.1, dark)
        else:
            for angle in (-50, -25, 0, 25, 50):
                kit.add(BALL, np.array([-0.66, 0, z - 0.03]) + turn("z", 180 + angle) @ np.array([0.16, 0, 0]), (0.15, 0.06, 0.02), rotation=turn("z", 180 + angle), material=coat)
            kit.chain([(0.48, 0.04, z + 0.04), (0.75, 0.2, z + 0.25), (0.3, 0.75, z + 0.35)], [0.016, 0.01, 0.006], coat, mirror=True)
        kit.chain([(0.36, 0.1, z), (0.5, 0.3, z), (0.78, 0.3, z)], [0.05, 0.055, 0.05], coat, mirror=True)
        claw(kit, (0.92, 0.26, z), -8, rng.uniform(0.3, 0.42) if not scorpion else 0.25, coat)
        kit.add(BALL, (0.45, 0.06, z + 0.09), (0.03,) * 3, material=dark, mirror=True)
        reach, root = 0.42, 0.1
    for x, angle in legs:
        out = turn("z", angle) @ np.array([reach, 0, 0])
        kit.chain([(x, root, z), (x + out[0] * 0.5, root + out[1] * 0.55, z + 0.12), (x + out[0], root + out[1], 0.0)], [0.045, 0.035, 0.01], coat, mirror=True, joints=False)


def insect(kit):
    """Spiders, beetles (stag, rhinoceros, ladybird), ants, bees, wasps, grasshoppers, mantises."""
    rng = kit.rng
    name = str(rng.choice(["spider", "ladybird", "stag", "rhino", "ant", "bee", "wasp", "grasshopper", "mantis"]))
    dark, glass = skin(kit, BLACK, DARK, pattern=PLAIN, gloss=0.5), skin(kit, (0.6, 0.62, 0.6), pattern=SEAMS, frequency=14, second=DARK, gloss=0.5)
    legs, z, y, reach, knee, thin = ((0.2, 50), (0.02, 95), (-0.15, 135)), 0.22, 0.12, 0.45, 0.1, 0.026
    limbs = dark
    if name == "spider":
        coat = skin(kit, BLACK, BROWN, TAN, GREY, GOLD, pattern=rng.choice([PLAIN, BANDS, SPECKLES]), frequency=12, gloss=0.1)
        limbs, z, reach, knee = coat, 0.24, rng.uniform(0.65, 0.95), rng.uniform(0.25, 0.5)
        kit.add(BALL, (-0.38, 0, 0.28), (0.34, 0.25, 0.24), rotation=turn("y", -12), material=coat)
        kit.add(BALL, (0.08, 0, z), (0.2, 0.16, 0.12), material=coat)
        kit.between((0.22, 0.05, z), (0.34, 0.05, z - 0.14), 0.045, CYL, 0.4, dark, mirror=True)
        for p, r in (((0.24, 0.045, z + 0.08), 0.028), ((0.2, 0.1, z + 0.07), 0.022)):
            kit.add(BALL, p, (r,) * 3, material=dark, mirror=True)
        kit.chain([(0.2, 0.1, z - 0.03), (0.36, 0.15, z + 0.03), (0.46, 0.1, z - 0.12)], [0.03, 0.025, 0.02], coat, mirror=True)
        legs, thin = ((0.15, 35), (0.08, 70), (0.02, 105), (-0.04, 145)), rng.uniform(0.02, 0.042)
    elif name in ("ladybird", "stag", "rhino"):
        colours = {"ladybird": ((0.6, 0.03, 0.01), ORANGE), "stag": (DARK, (0.12, 0.04, 0.02)), "rhino": (BLACK, (0.1, 0.05, 0.02), (0.02, 0.15, 0.08))}[name]
        coat = skin(kit, *colours, pattern=DOTS if name == "ladybird" else PLAIN, frequency=7.5, second=BLACK, gloss=0.55)
        long, high = (0.36, 0.3) if name == "ladybird" else (0.44, 0.22)
        kit.add(BALL, (-0.2, 0.01, 0.2), (long, 0.3, high), material=coat, mirror=True)
        kit.add(BALL, (-0.2, 0, 0.15), (long * 0.95, 0.28, 0.12), material=dark)
        kit.add(BOX, (-0.24, 0, 0.2 + high), (long * 0.6, 0.006, 0.012), material=dark)
        kit.add(BALL, (0.2, 0, 0.2), (0.17, 0.23 if name != "ladybird" else 0.2, 0.15), material=dark if name == "ladybird" else coat)
        kit.add(BALL, (0.38, 0, 0.17), (0.12, 0.13, 0.09), material=dark)
        if name == "ladybird":
            kit.add(BALL, (0.27, 0.13, 0.26), (0.06, 0.05, 0.05), material=skin(kit, WHITE, pattern=PLAIN), mirror=True)
            kit.chain([(0.45, 0.06, 0.2), (0.58, 0.15, 0.26)], 0.012, dark, mirror=True)
        elif name == "stag":
            kit.chain([(0.46, 0.07, 0.17), (0.66, 0.22, 0.2), (0.86, 0.2, 0.2), (0.95, 0.06, 0.2)], [0.045, 0.045, 0.035, 0.012], coat, mirror=True)
            kit.between((0.72, 0.21, 0.2), (0.75, 0.08, 0.2), 0.03, CYL, 0.2, coat, mirror=True)
        else:
            hull(kit, [(0.44, 0, 0.2), (0.72, 0, 0.3), (0.8, 0, 0.55)], [0.065, 0.05, 0.02], coat)
            kit.between((0.25, 0, 0.33), (0.42, 0, 0.45), 0.05, CYL, 0.2, coat)
        kit.add(BALL, (0.42, 0.1, 0.2), (0.028,) * 3, material=black(kit), mirror=True)
        z, y, reach = 0.16, 0.2, 0.35
    elif name == "ant":
        coat = limbs = skin(kit, BLACK, RED, BROWN, pattern=PLAIN, gloss=0.45)
        kit.add(BALL, (-0.5, 0, 0.32), (0.3, 0.19, 0.19), rotation=turn("y", 8), material=coat)
        kit.add(BALL, (-0.2, 0, 0.3), (0.07, 0.05, 0.09), material=coat)
        kit.add(BALL, (0.05, 0, 0.31), (0.24, 0.1, 0.11), material=coat)
        kit.add(BALL, (0.4, 0, 0.33), (0.17, 0.16, 0.13), rotation=turn("y", 25), material=coat)
        kit.chain([(0.5, 0.06, 0.38), (0.62, 0.2, 0.52), (0.85, 0.3, 0.42)], [0.018, 0.015, 0.014], coat, mirror=True)
        kit.chain([(0.5, 0.08, 0.25), (0.64, 0.1, 0.2), (0.68, 0.02, 0.18)], [0.035, 0.03, 0.01], coat, mirror=True)
        kit.add(BALL, (0.43, 0.13, 0.37), (0.035,) * 3, material=black(kit), mirror=True)
        z, y, reach, knee = 0.28, 0.07, 0.55, 0.18
    elif name in ("bee", "wasp"):
        coat = skin(kit, GOLD, pattern=BANDS, frequency=13 if name == "bee" else 16, second=BLACK, gloss=0.2)
        fuzz, fat = skin(kit, GOLD, BROWN, DARK, gloss=0.02) if name == "bee" else dark, 1.0 if name == "bee" else 0.75
        hull(kit, [(-0.7, 0, 0.24), (-0.45, 0, 0.32), (-0.2, 0, 0.35)], np.array([0.07, 0.2, 0.12 if name == "wasp" else 0.2]) * fat, coat)
        kit.between((-0.7, 0, 0.24), (-0.86, 0, 0.18), 0.03, CYL, 0.1, dark)
        kit.add(BALL, (0.08, 0, 0.38), (0.22, 0.2 * fat, 0.2 * fat), material=fuzz)
        kit.add(BALL, (0.36, 0, 0.34), (0.12, 0.15, 0.14), material=dark if name == "bee" else coat._replace(pattern=PLAIN))
        kit.add(BALL, (0.4, 0.11, 0.38), (0.07, 0.05, 0.1), material=black(kit), mirror=True)
        kit.chain([(0.46, 0.05, 0.4), (0.56, 0.1, 0.5), (0.66, 0.14, 0.42)], 0.015, dark, mirror=True)
        up = rng.uniform(5, 45)
        for x, span, back in ((0.05, 0.75, -0.15), (-0.08, 0.55, -0.35)):
            way = np.array([back, np.cos(np.radians(up)), np.sin(np.radians(up))]) * span
            kit.between((x, 0.1, 0.53), np.array([x, 0.1, 0.53]) + way, (0.01, 0.09), BOX, 1.9, glass, mirror=True)
        z, y, reach = 0.3, 0.12, 0.32
    elif name == "grasshopper":
        coat = limbs = skin(kit, (0.15, 0.4, 0.04), (0.3, 0.3, 0.08), TAN, pattern=rng.choice([PLAIN, SPECKLES]))
        hull(kit, [(-0.75, 0, 0.26), (-0.3, 0, 0.32), (0.1, 0, 0.36)], [0.05, 0.12, 0.14], coat, 0.85)
        kit.add(BALL, (0.14, 0, 0.4), (0.2, 0.14, 0.17), material=coat)
        kit.add(BALL, (0.37, 0, 0.38), (0.12, 0.12, 0.18), rotation=turn("y", -15), material=coat)
        kit.add(BALL, (0.42, 0.1, 0.46), (0.06, 0.035, 0.07), material=black(kit), mirror=True)
        kit.add(BOX, (-0.4, 0.09, 0.44), (0.5, 0.014, 0.08), rotation=turn("y", -6), material=skin(kit, (0.2, 0.35, 0.08), TAN, pattern=STREAKS), mirror=True)
        kit.chain([(0.45, 0.05, 0.5), (0.9, 0.2, 0.75)], [0.014, 0.006], coat, mirror=True)
        hull(kit, [(-0.12, 0.15, 0.34), (-0.6, 0.28, 0.78)], [0.085, 0.035], coat, mirror=True)
        kit.chain([(-0.6, 0.28, 0.78), (-0.85, 0.32, 0.04), (-0.68, 0.34, 0.02)], [0.03, 0.022, 0.016], coat, mirror=True)
        legs, z, y, reach = ((0.25, 50), (0.08, 95)), 0.3, 0.1, 0.35
    else:
        coat = limbs = skin(kit, (0.15, 0.42, 0.05), TAN, (0.4, 0.42, 0.1), pattern=PLAIN)
        hull(kit, [(-0.8, 0, 0.4), (-0.4, 0, 0.42), (-0.05, 0, 0.45)], [0.05, 0.12, 0.07], coat)
        hull(kit, [(-0.05, 0, 0.45), (0.3, 0, 0.82)], [0.06, 0.055], coat)
        kit.add(BOX, (-0.42, 0.06, 0.54), (0.42, 0.07, 0.012), rotation=turn("x", -35), material=coat, mirror=True)
        kit.add(CYL, (0.36, 0, 0.9), (0.09, 0.13, 0.09), (0.3, 1), rotation=turn("y", 150), material=coat)
        kit.add(BALL, (0.37, 0.11, 0.95), (0.05, 0.045, 0.06), material=black(kit), mirror=True)
        kit.chain([(0.4, 0.04, 0.97), (0.75, 0.2, 1.2)], [0.012, 0.005], coat, mirror=True)
        kit.chain([(0.25, 0.06, 0.76), (0.5, 0.14, 0.5), (0.62, 0.1, 0.86), (0.7, 0.08, 0.62)], [0.035, 0.05, 0.035, 0.012], coat, mirror=True)
        legs, z, y, reach, knee = ((0.05, 60), (-0.12, 120)), 0.43, 0.06, 0.55, 0.2
    for x, angle in legs:
        out = turn("z", angle) @ np.array([reach, 0, 0])
        joints = [(x, y, z), (x + out[0] * 0.45, y + out[1] * 0.5, z + knee), (x + out[0] * 0.85, y + out[1] * 0.9, 0.04), (x + out[0] * 1.05, y + out[1] * 1.05, 0.01)]
        kit.chain(joints, [thin * 1.4, thin * 1.1, thin * 0.8, thin * 0.5], limbs, mirror=True, joints=False)


def winged_insect(kit):
    """Butterflies and moths with spread or lifted wings, dragonflies."""
    rng = kit.rng
    body = skin(kit, BLACK, DARK, BROWN, (0.02, 0.2, 0.3), gloss=0.2)
    if kit.chance(0.6):
        main = paint(rng.choice([0.05, 0.09, 0.14, 0.55, 0.6, 0.75, 0.3]), rng.uniform(0.5, 1), rng.uniform(0.3, 0.8))
        wing = kit.material(base=main, pattern=rng.choice([SEAMS, DOTS, PLAIN, WAVES, CAMOUFLAGE]), frequency=rng.uniform(4, 9), second=BLACK, gloss=0.05)
        edge = kit.material(base=BLACK if kit.chance(0.7) else main * 0.4, pattern=SPECKLES, frequency=18, second=WHITE, gloss=0.05)
        lift = rng.choice([rng.uniform(0, 25), rng.uniform(35, 75)])
        c, s = np.cos(np.radians(lift)), np.sin(np.radians(lift))
        z = 0.12
        hull(kit, [(-0.42, 0, z - 0.02), (-0.15, 0, z), (0.12, 0, z)], [0.025, 0.05, 0.06], body)
        kit.add(BALL, (0.24, 0, z + 0.01), (0.06, 0.055, 0.055), material=body)
        kit.chain([(0.27, 0.02, z + 0.04), (0.52, 0.2, z + 0.14)], [0.009, 0.007], body, mirror=True)
        kit.add(BALL, (0.53, 0.21, z + 0.145), (0.018,) * 3, material=body, mirror=True)

        def strips(outline, thin, material):
            membrane(kit, [(front, rear, 0.02 + y * c, z + 0.03 + y * s) for front, rear, y in outline], thin, material)

        strips([(0.12, -0.06, 0), (0.32, -0.08, 0.3), (0.5, -0.02, 0.62), (0.55, 0.1, 0.82)], 0.012, wing)
        strips([(0.55, 0.1, 0.82), (0.53, 0.2, 0.92)], 0.0125, edge)
        strips([(-0.0, -0.22, 0), (-0.05, -0.52, 0.25), (-0.1, -0.6, 0.5)], 0.011, wing)
        strips([(-0.1, -0.6, 0.5), (-0.2, -0.48, 0.66)], 0.0115, edge)
        sail(kit, (-0.85, 0.02 + 0.36 * c, z + 0.03 + 0.36 * s), (-0.5, 0.02 + 0.22 * c, z + 0.03 + 0.22 * s), (-0.55, 0.02 + 0.42 * c, z + 0.03 + 0.42 * s), 0.011, edge, mirror=True)
        for x, reach in ((0.1, 0.12), (0, 0.0), (-0.08, -0.1)):
            kit.chain([(x, 0.03, z - 0.03), (x + reach, 0.14, 0.0)], [0.012, 0.006], body, mirror=True)
    else:
        coat = skin(kit, (0.02, 0.25, 0.4), (0.1, 0.4, 0.1), (0.5, 0.05, 0.02), GOLD, pattern=BANDS, frequency=14, second=BLACK, gloss=0.5)
        glass = skin(kit, (0.55, 0.6, 0.6), (0.5, 0.4, 0.25), pattern=SEAMS, frequency=12, second=DARK, gloss=0.5)
        hull(kit, [(-1.05, 0, 0.2), (-0.3, 0, 0.21), (-0.05, 0, 0.24)], [0.035, 0.035, 0.07], coat)
        kit.add(BALL, (0.08, 0, 0.25), (0.2, 0.11, 0.13), material=coat)
        kit.add(BALL, (0.32, 0, 0.26), (0.09, 0.11, 0.09), material=body)
        kit.add(BALL, (0.34, 0.085, 0.29), (0.09, 0.085, 0.09), material=skin(kit, (0.1, 0.3, 0.2), RED, pattern=PLAIN, gloss=0.6), mirror=True)
        lift, sweep = rng.uniform(-5, 20), rng.uniform(-0.05, 0.15)
        c, s = np.cos(np.radians(lift)), np.sin(np.radians(lift))
        for x, wide in ((0.1, 0.13), (-0.08, 0.17)):
            outline = [(x + 0.05, x - 0.03, 0), (x + 0.09, x - wide, 0.3), (x + 0.1 - sweep, x - wide - sweep * 0.5, 0.75), (x + 0.02 - sweep, x - 0.1 - sweep, 0.95)]
            membrane(kit, [(a, b, 0.03 + y * c, 0.34 + y * s) for a, b, y in outline], 0.008, glass)
        for x, reach in ((0.18, 0.14), (0.08, 0.04), (0.0, -0.1)):
            kit.chain([(x, 0.06, 0.16), (x + reach, 0.16, 0.1), (x + reach * 1.3, 0.17, 0.0)], [0.016, 0.012, 0.006], body, mirror=True)


def mollusc(kit):
    """Snails, octopuses, starfish, seahorses, jellyfish."""
    rng = kit.rng
    name = str(rng.choice(["snail", "octopus", "starfish", "seahorse", "jellyfish"]))
    coat = skin(kit, ORANGE, RED, PINK, TAN, (0.35, 0.1, 0.3), GOLD, (0.08, 0.2, 0.35), pattern=rng.choice([PLAIN, CLOUDY, SPECKLES]), frequency=14, gloss=0.3)
    if name == "snail":
        flesh = skin(kit, TAN, GREY, (0.35, 0.25, 0.15), pattern=SPECKLES, frequency=22)
        shell = skin(kit, TAN, BROWN, CREAM, GOLD, pattern=rng.choice([BANDS, CLOUDY, STREAKS]), frequency=16, gloss=0.4)
        hull(kit, [(-0.7, 0, 0.03), (-0.2, 0, 0.09), (0.4, 0, 0.1), (0.68, 0, 0.24)], [0.03, 0.11, 0.12, 0.1], flesh, 1.15)
        for z, far in ((0.3, 0.24), (0.2, 0.1)):
            kit.chain([(0.72, 0.05, z), (0.78 + far * 0.5, 0.1, z + far)], [0.022, 0.016], flesh, mirror=True)
            kit.add(BALL, (0.78 + far * 0.5, 0.1, z + far), (0.026,) * 3, material=black(kit) if far > 0.2 else flesh, mirror=True)
        t = np.linspace(0, 1, 17)
        angle, radius = np.radians(-75) - 2 * np.pi * 2.0 * t, 0.3 * (1 - t) + 0.02
        for k, (a, r) in enumerate(zip(angle, radius, strict=True)):
            at = np.array([-0.1 + r * np.cos(a), 0.12 * t[k] - 0.02, 0.45 + r * np.sin(a)])
            size = 0.19 * (1 - t[k]) + 0.06
            kit.add(BALL, at, (min(size * 1.6, r + size * 0.6), size * 0.9, size), rotation=turn("y", -90 - np.degrees(a)), material=shell)
    elif name == "octopus":
        kit.add(BALL, (-0.12, 0, 0.52), (0.3, 0.26, 0.33), rotation=turn("y", -25), material=coat)
        kit.add(BALL, (0.02, 0, 0.26), (0.24, 0.22, 0.18), material=coat)
        kit.add(BALL, (0.14, 0.15, 0.37), (0.08, 0.07, 0.08), material=coat, mirror=True)
        kit.add(BALL, (0.18, 0.19, 0.39), (0.045, 0.045, 0.03), material=black(kit), mirror=True)
        for k, (x, y) in enumerate(around(8, 1.0, 22)):
            curl, reach = rng.uniform(-0.5, 0.5), rng.uniform(0.7, 1.0)
            side = np.array([-y, x, 0]) * curl
            way = np.array([x, y, 0])
            end_up = rng.choice([0.03, 0.2])
            path = [way * 0.14 + [0, 0, 0.2], way * 0.4 + side * 0.12 + [0, 0, 0.1], way * reach * 0.75 + side * 0.4 + [0, 0, 0.045], way * reach * 0.9 + side * 0.95 + [0, 0, end_up]]
            kit.chain(path, [0.11, 0.085, 0.055, 0.02], coat)
    elif name == "starfish":
        arms = int(rng.choice([5, 5, 5, 6]))
        coat = coat._replace(pattern=SPECKLES, frequency=20.0, second=np.array(CREAM))
        kit.add(BALL, (0, 0, 0.1), (0.25, 0.25, 0.13), material=coat)
        for x, y in around(arms, 1.0, 0):
            bow = np.array([-y, x, 0]) * rng.uniform(-0.12, 0.12)
            hull(kit, [(x * 0.15, y * 0.15, 0.09), np.array([x * 0.5, y * 0.5, 0.07]) + bow, np.array([x * 0.85, y * 0.85, 0.04]) + bow * 2], [0.15, 0.11, 0.035], coat, first=False)
            for r in (0.25, 0.45, 0.65):
                kit.add(BALL, np.array([x * r, y * r, 0.21 - 0.16 * r]) + bow * max(0, r * 2 - 0.1), (0.03,) * 3, material=skin(kit, CREAM, pattern=PLAIN) if r == 0.25 else coat)
    elif name == "seahorse":
        ridge = coat._replace(pattern=BANDS, frequency=22.0)
        path = [(0.02, 0, 1.0), (0.0, 0, 0.82), (0.1, 0, 0.62), (0.06, 0, 0.42), (-0.06, 0, 0.28), (-0.04, 0, 0.12), (0.08, 0, 0.06), (0.15, 0, 0.12), (0.1, 0, 0.17)]
        hull(kit, path, [0.085, 0.09, 0.15, 0.11, 0.07, 0.05, 0.038, 0.028, 0.02], ridge, 0.75)
        head = Head(kit, (0.06, 0, 1.05), turn("y", 25), 0.1)
        head.ball((0, 0, 0), (1.1, 0.8, 0.9), coat)
        kit.between(head.place(0.5, 0, -0.1), head.place(2.4, 0, -0.15), 0.04, CYL, 0.8, coat)
        head.ball((2.4, 0, -0.15), (0.35, 0.42, 0.45), coat)
        head.eyes(0.4, 0.65, 0.15, 0.17)
        for k in range(5):
            kit.between((-0.02 - 0.015 * k, 0, 1.1 - 0.02 * k), (-0.02 - 0.07 * k, 0, 1.24 - 0.04 * k), 0.025, CYL, 0.15, coat)
        sail(kit, (-0.2, 0, 0.66), (-0.02, 0, 0.72), (-0.03, 0, 0.5), 0.012, skin(kit, CREAM, GOLD, pattern=STRIPES, frequency=30))
        kit.add(BALL, (-0.02, 0.08, 0.92), (0.07, 0.015, 0.05), material=coat, mirror=True)
    else:
        bell = skin(kit, PINK, (0.4, 0.5, 0.7), WHITE, ORANGE, (0.4, 0.2, 0.5), pattern=CLOUDY, gloss=0.5)
        kit.loft((0, 0, 0.9), [(0, 0.46), (0.1, 0.48), (0.24, 0.42), (0.36, 0.28), (0.43, 0.12)], bell)
        kit.add(BALL, (0, 0, 1.0), (0.47, 0.47, 0.36), material=bell)
        for k, (x, y) in enumerate(around(10, 0.4)):
            low = rng.uniform(0, 0.35)
            kit.chain([(x, y, 0.92), (x * 1.1 + rng.normal(0, 0.05), y * 1.1 + rng.normal(0, 0.05), 0.5), (x + rng.normal(0, 0.1), y + rng.normal(0, 0.1), low)], [0.022, 0.016, 0.01], bell, joints=False)
        for x, y in around(4, 0.12, 45):
            hull(kit, [(x, y, 0.95), (x * 1.5, y * 1.5, 0.6), (x * 0.8, y * 0.8, 0.25)], [0.09, 0.07, 0.03], coat, first=False)


def pillar(kit, hip, at, radius, coat):
    """A thick leg with a slight bend and a round foot with toes."""
    hip, at = np.array(hip, float), np.array(at, float)
    ahead = 0.08 * (hip[2] - at[2])
    hull(kit, [hip, (hip + at) / 2 + [ahead, 0, 0], at + [0, 0, radius * 0.8]], [radius * 1.6, radius * 1.15, radius * 0.95], coat, first=True)
    kit.add(CYL, at + [0.02, 0, radius * 0.45], (radius * 1.25, radius * 1.15, radius * 0.45), (0.8, 1), material=coat)


def jaws(kit, head, far, coat, under, mouth, deep=0.6):
    """Snout and lower jaw, open by `mouth` degrees, with teeth."""
    size = head.size
    kit.between(head.place(0.2, 0, 0.1), head.place(far, 0, 0.02), (size * deep, size * 0.7), CYL, 0.62, coat)
    head.ball((far, 0, 0.0), (0.42, 0.45, deep * 0.64), coat)
    low = head.facing @ turn("y", 6 + mouth) @ np.array([far + 0.2, 0, 0]) * size
    start = head.place(-0.05, 0, -0.42)
    kit.between(start, start + low, (size * 0.3, size * 0.6), CYL, 0.6, under)
    if mouth > 5:
        for x, y in ((0.95, 0.3), (0.95, -0.3), (0.6, 0.42), (0.6, -0.42)):
            kit.between(head.place(far * x, y, -0.2), head.place(far * x, y, -0.6), size * 0.1, CYL, 0.1, skin(kit, WHITE, pattern=PLAIN))


def saurian(kit):
    """T. rex, raptors, stegosaurs, triceratops, sauropods, dragons on four legs."""
    rng = kit.rng
    name = str(rng.choice(["rex", "stegosaur", "triceratops", "sauropod", "dragon", "dragon"]))
    colours = ((0.14, 0.18, 0.06), BROWN, (0.25, 0.2, 0.1), GREY, (0.1, 0.2, 0.2), RED) if name != "dragon" else ((0.4, 0.02, 0.02), (0.03, 0.25, 0.06), (0.03, 0.06, 0.3), BLACK, GOLD)
    coat = skin(kit, *colours, pattern=rng.choice([CLOUDY, SPECKLES, BANDS, CAMOUFLAGE]), frequency=rng.uniform(7, 14), gloss=0.15)
    under, horn = skin(kit, CREAM, TAN, GOLD), skin(kit, CREAM, pattern=PLAIN)
    iris = kit.material(base=(0.8, 0.5, 0.03), pattern=PLAIN, gloss=0.5)
    swing = rng.uniform(-0.35, 0.35)
    if name == "rex":
        raptor = kit.chance(0.3)
        fat = 0.17 if raptor else 0.25
        hip, chest = np.array([0, 0, 0.85]), np.array([0.48, 0, 0.92])
        hull(kit, [hip, (hip + chest) / 2, chest], [fat, fat * 1.02, fat * 0.88], coat, 0.82)
        kit.add(BALL, (0.26, 0, 0.83), (0.36, fat * 0.72, fat * 0.85), material=under)
        hull(kit, bend(hip, (-0.75, 0, 0.92), (-1.55, swing, 0.85), 5), np.array([0.95, 0.66, 0.46, 0.28, 0.1]) * fat, coat, 0.85, first=False)
        neck = bend(chest, chest + [0.24, 0, 0.02], chest + [0.26, 0, 0.32], 3)
        hull(kit, neck, np.array([0.82, 0.66, 0.58]) * fat, coat, 0.85, first=False)
        head = Head(kit, neck[-1] + [0.1, 0, 0.06], looking(kit, 4, 15), 0.115 if raptor else 0.185)
        head.ball((0, 0, 0), (1.05, 0.85, 0.92), coat)
        jaws(kit, head, 2.0, coat, under, rng.choice([0.0, 22.0]), 0.68)
        for side in (1, -1):
            step = side * rng.uniform(0.05, 0.3)
            knee, heel, toe = np.array([0.2 + step * 0.5, side * 0.2, 0.52]), np.array([-0.14 + step, side * 0.2, 0.24]), np.array([0.0 + step, side * 0.2, 0.045])
            kit.add(BALL, (hip + knee) / 2 * [1, 0, 1] + [0, side * 0.16, 0], (0.17, 0.11, 0.27), rotation=towards(hip - knee), material=coat)
            hull(kit, [knee, heel, toe], [0.11, 0.06, 0.055], coat)
            for angle in (-28, 0, 28):
                kit.between(toe, toe * [1, 1, 0.5] + turn("z", angle) @ np.array([0.2, 0, 0]), 0.042, CYL, 0.45, coat)
            hull(kit, [chest + [0.1, side * fat * 0.6, -0.1], chest + [0.12, side * fat * 0.75, -0.24], chest + [0.24, side * fat * 0.7, -0.22]], [0.055, 0.035, 0.022], coat)
    elif name == "stegosaur":
        hull(kit, [(-0.45, 0, 0.72), (0, 0, 0.76), (0.4, 0, 0.56), (0.62, 0, 0.42)], [0.27, 0.34, 0.24, 0.14], coat, 0.75)
        hull(kit, [(0.62, 0, 0.42), (0.88, 0, 0.34)], [0.13, 0.09], coat, first=False)
        head = Head(kit, (0.92, 0, 0.34), looking(kit, 12, 15), 0.085)
        head.ball((0, 0, 0), (1.1, 0.9, 0.9), coat)
        kit.between(head.place(0.3, 0, 0), head.place(2.0, 0, -0.2), 0.068, CYL, 0.45, coat)
        rear = bend((-0.5, 0, 0.72), (-0.95, 0, 0.6), (-1.45, swing, 0.6), 4)
        hull(kit, rear, [0.24, 0.16, 0.09, 0.04], coat, first=False)
        plate = skin(kit, ORANGE, RED, TAN, BROWN, pattern=STREAKS)
        for k, x in enumerate(np.linspace(-0.95, 0.72, 8)):
            z = np.interp(x, [-1.0, -0.45, 0, 0.4, 0.72], [0.66, 0.97, 1.08, 0.78, 0.5])
            big = np.interp(x, [-1.0, -0.1, 0.72], [0.1, 0.24, 0.09])
            at = np.array([x, 0.05 * (-1) ** k, z])
            kit.add(CYL, at + [0, 0, big * 0.12], (big * 0.5, 0.02, big * 0.3), (1.5, 1), material=plate)
            kit.add(CYL, at + [0, 0, big * 0.8], (big * 0.75, 0.02, big * 0.4), (0.1, 1), material=plate)
        for x, y in ((-0.02, 0.3), (0.1, 0.3)):
            kit.between(rear[-1] + [x + 0.05, 0, 0], rear[-1] + [x - 0.12, y, 0.2], 0.03, CYL, 0.1, horn)
            kit.between(rear[-1] + [x + 0.05, 0, 0], rear[-1] + [x - 0.12, -y, 0.2], 0.03, CYL, 0.1, horn)
        for side in (1, -1):
            pillar(kit, (0.38, side * 0.16, 0.45), (0.4 + side * 0.06, side * 0.2, 0), 0.07, coat)
            pillar(kit, (-0.38, side * 0.17, 0.6), (-0.38 - side * 0.06, side * 0.19, 0), 0.085, coat)
    elif name == "triceratops":
        hull(kit, [(-0.55, 0, 0.58), (-0.1, 0, 0.62), (0.35, 0, 0.56)], [0.28, 0.35, 0.28], coat, 0.92)
        hull(kit, bend((-0.55, 0, 0.56), (-0.95, 0, 0.4), (-1.3, swing, 0.16), 4), [0.25, 0.16, 0.09, 0.03], coat, first=False)
        hull(kit, [(0.35, 0, 0.56), (0.68, 0, 0.52)], [0.27, 0.2], coat, first=False)
        head = Head(kit, (0.8, 0, 0.5), looking(kit, 12, 15), 0.2)
        head.ball((0, 0, 0), (1.0, 0.82, 0.9), coat)
        kit.between(head.place(0.2, 0, -0.1), head.place(1.9, 0, -0.35), (0.15, 0.13), CYL, 0.5, coat)
        kit.between(head.place(1.7, 0, -0.25), head.place(2.25, 0, -0.75), 0.08, CYL, 0.2, horn)
        frill = head.facing @ turn("y", -58)
        kit.add(CYL, head.place(-0.55, 0, 0.55), np.array([1.5, 1.65, 0.11]) * head.size, (0.9, 1), rotation=frill, material=skin(kit, RED, ORANGE, BROWN, TAN, pattern=CLOUDY))
        head.rods([(0.45, 0.45, 0.6), (1.1, 0.6, 1.2), (1.9, 0.62, 1.4)], [0.2, 0.14, 0.03], horn)
        head.rods([(1.55, 0, 0.05), (1.8, 0, 0.65)], [0.17, 0.03], horn, both=False)
        for side in (1, -1):
            pillar(kit, (0.33, side * 0.22, 0.45), (0.36 + side * 0.07, side * 0.25, 0), 0.09, coat)
            pillar(kit, (-0.45, side * 0.21, 0.5), (-0.45 - side * 0.07, side * 0.23, 0), 0.1, coat)
    elif name == "sauropod":
        up = rng.uniform(0.15, 1.0)
        hull(kit, [(-0.42, 0, 0.7), (0, 0, 0.72), (0.36, 0, 0.74)], [0.24, 0.3, 0.23], coat, 0.9)
        kit.add(BALL, (0, 0, 0.63), (0.42, 0.24, 0.26), material=under)
        path = bend((0.4, 0, 0.8), (0.85, 0, 0.85 + 0.2 * up), (1.25, rng.uniform(-0.2, 0.2), 1.0 + 0.7 * up), 5)
        hull(kit, path, [0.18, 0.13, 0.1, 0.08, 0.065], coat, first=False)
        head = Head(kit, path[-1] + [0.05, 0, 0.02], looking(kit, 12, 20), 0.085)
        head.ball((0, 0, 0), (1.1, 0.85, 0.9), coat)
        kit.between(head.place(0.3, 0, -0.1), head.place(1.7, 0, -0.25), 0.062, CYL, 0.72, coat)
        head.ball((1.7, 0, -0.25), (0.4, 0.5, 0.45), coat)
        hull(kit, bend((-0.45, 0, 0.7), (-1.0, 0, 0.55), (-1.8, swing * 2, 0.4), 6), [0.2, 0.13, 0.09, 0.06, 0.04, 0.015], coat, first=False)
        for side in (1, -1):
            pillar(kit, (0.33, side * 0.16, 0.6), (0.34 + side * 0.08, side * 0.18, 0), 0.085, coat)
            pillar(kit, (-0.38, side * 0.16, 0.6), (-0.38 - side * 0.08, side * 0.18, 0), 0.095, coat)
    else:
        wing = skin(kit, ORANGE, RED, DARK, (0.3, 0.05, 0.2), TAN, pattern=STREAKS)
        hull(kit, [(-0.4, 0, 0.5), (0, 0, 0.55), (0.35, 0, 0.6)], [0.19, 0.2, 0.22], coat, 0.82)
        kit.add(BALL, (0.05, 0, 0.49), (0.42, 0.14, 0.17), rotation=turn("y", -8), material=under._replace(pattern=BANDS, frequency=20.0))
        path = bend((0.42, 0, 0.68), (0.88, 0, 0.7), (0.74, 0, 1.22), 3)
        hull(kit, path, [0.18, 0.12, 0.09], coat, first=False)
        head = Head(kit, path[-1] + [0.06, 0, 0.03], looking(kit, 12, 18), 0.115)
        head.ball((0, 0, 0), (1.1, 0.85, 0.85), coat)
        jaws(kit, head, 2.2, coat, under, rng.choice([0.0, 22.0]))
        head.rods([(-0.3, 0.5, 0.55), (-1.8, 0.8, 1.3)], [0.2, 0.03], horn)
        rear = bend((-0.45, 0, 0.5), (-1.1, 0, 0.1), (-1.6, swing * 1.5, rng.uniform(0.1, 0.4)), 4)
        hull(kit, rear, [0.16, 0.11, 0.06, 0.025], coat, first=False)
        lift = rng.uniform(0.3, 1.0)
        wrist, tip = np.array([0.4, 0.5, 1.0 + lift * 0.6]), np.array([-0.05, 1.4, 0.9 + lift])
        kit.chain([(0.28, 0.14, 0.72), wrist, tip], [0.06, 0.035, 0.012], coat, mirror=True, joints=False)
        edge = [(0.3, -0.3, 0.12, 0.72), (0.4, -0.5, 0.5, wrist[2])]
        membrane(kit, edge, 0.012, wing)
        membrane(kit, [edge[1], (0.24, -0.34, 0.82, wrist[2] * 0.64 + tip[2] * 0.36), (0.1, -0.38, 1.08, wrist[2] * 0.36 + tip[2] * 0.64), (-0.04, -0.1, 1.4, tip[2])], 0.012, wing)
        for side in (1, -1):
            foreleg(kit, (0.32, side * 0.16, 0.56), (0.27, side * 0.17, 0.36), (0.36 + side * 0.07, side * 0.18, 0), 0.048, 0.13, coat, coat, "paw")
            hindleg(kit, (-0.34, side * 0.14, 0.48), (-0.24, side * 0.17, 0.32), (-0.48, side * 0.17, 0.2), (-0.42 - side * 0.07, side * 0.17, 0), 0.05, 0.15, coat, coat, "paw")
        sail(kit, rear[-1] + [-0.24, 0, 0.02], rear[-1] + [0.02, 0.12, 0], rear[-1] + [0.02, -0.12, 0], 0.015, wing)
    head.eyes(0.5, 0.68, 0.38, 0.14, iris if name in ("rex", "sauropod", "triceratops") else None)


def other_animal(kit):
    """Standing and flying birds, fish, sharks, whales, dolphins, rays, turtles, crocodiles, lizards, chameleons, snakes, frogs, crabs, lobsters,
    scorpions, spiders, beetles, ants, bees, grasshoppers, mantises, butterflies, dragonflies, snails, octopuses, starfish, seahorses, jellyfish,
    dinosaurs, dragons."""
    makers = [(standing_bird, 8), (flying_bird, 3), (fish, 2.5), (sea_giant, 3), (ray, 0.7), (turtle, 2), (sprawler, 3), (snake, 1.7), (frog, 1)]
    makers += [(shellfish, 2), (insect, 4), (winged_insect, 2), (mollusc, 3), (saurian, 3.5)]
    weights = np.array([weight for _, weight in makers], float)
    makers[kit.rng.choice(len(makers), p=weights / weights.sum())][0](kit)
