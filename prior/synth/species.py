"""The four-legged species: their proportions, their families and their coats."""

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, fur
from .hides import FAWN, GOLD, SAND, SILVER, SLATE
from .materials import BANDS, CAMOUFLAGE, CLOUDY, PLAIN, SPECKLES, STREAKS

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
    "zebu": (1.1, 0.5, 0.44, 1.0, 0.19, 0.34, 24, 0.2, 0.125, 0.115, 0.33, 0.066, 0.033, 32),
    "buffalo": (1.24, 0.58, 0.54, 0.98, 0.25, 0.32, 4, 0.25, 0.16, 0.135, 0.33, 0.09, 0.042, 30),
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
CATTLE = ["cow", "bull", "zebu", "buffalo", "bison"]
HOOFED = [*EQUINE, *CATTLE, "goat", "sheep", "pig", "boar", "deer", "moose", "camel", "llama", "giraffe", "tapir"]
PILLARS = ["elephant", "rhino", "hippo"]
SPLIT = [*CATTLE, "goat", "sheep", "deer", "moose", "camel", "llama", "giraffe"]
# Those that look back over their shoulders.
SUPPLE = ["deer", "camel", "llama", "giraffe", "goat", "greyhound", "cat", "horse", "zebu", "fox"]
# Coats to choose from: coat, legs, muzzle, belly, back, hair of mane and tail; None: as the coat, or nothing on belly and back.
COATS = {
    "shepherd": [(GOLD, TAN, BLACK, None, BLACK, DARK), (BLACK, TAN, BLACK, None, None, BLACK), (SAND, CREAM, DARK, CREAM, DARK, DARK)],
    "retriever": [(GOLD, None, None, CREAM, None, GOLD), (CREAM, None, None, WHITE, None, CREAM), (BLACK, None, None, None, None, BLACK), (BROWN,) + (None,) * 5],
    "husky": [(SLATE, WHITE, WHITE, WHITE, BLACK, GREY), (BLACK, WHITE, WHITE, WHITE, None, BLACK), (RED, WHITE, WHITE, WHITE, None, RED)],
    "greyhound": [(FAWN,) + (None,) * 5, (SLATE, None, None, WHITE, None, None), (BLACK,) + (None,) * 5, (WHITE,) + (None,) * 5],
    "dachshund": [(BLACK, TAN, TAN, TAN, None, BLACK), (RED,) + (None,) * 5, (BROWN, TAN, TAN, None, None, None)],
    "bulldog": [
        (WHITE, None, None, None, TAN, None),
        (FAWN, WHITE, WHITE, WHITE, None, None),
        (SLATE, None, None, WHITE, None, None),
        (BROWN, WHITE, WHITE, None, None, None),
    ],
    "pug": [(SAND, None, BLACK, None, None, None), (FAWN, None, BLACK, None, None, None), (BLACK,) + (None,) * 5],
    "poodle": [(WHITE,) + (None,) * 5, (BLACK,) + (None,) * 5, (ORANGE,) + (None,) * 5, (GREY,) + (None,) * 5],
    "terrier": [(TAN, None, None, None, BLACK, None), (WHITE,) + (None,) * 5, (GREY, SILVER, SILVER, None, None, None), (FAWN,) + (None,) * 5],
    "beagle": [(RED, WHITE, WHITE, WHITE, BLACK, WHITE)],
    "dalmatian": [(WHITE,) + (None,) * 5],
    "corgi": [(ORANGE, WHITE, WHITE, WHITE, None, ORANGE), (BLACK, WHITE, WHITE, WHITE, None, BLACK)],
    "wolf": [(GREY, SAND, WHITE, CREAM, DARK, GREY), (WHITE,) + (None,) * 5, (DARK, None, GREY, None, None, DARK)],
    "fox": [(ORANGE, BLACK, WHITE, WHITE, None, ORANGE), ((0.5, 0.16, 0.04), DARK, WHITE, WHITE, None, (0.5, 0.16, 0.04)), (WHITE,) + (None,) * 5],
    "cat": [
        (GREY, WHITE, WHITE, WHITE, None, None),
        (BLACK,) + (None,) * 5,
        (CREAM, DARK, DARK, None, None, DARK),
        (WHITE,) + (None,) * 5,
        (BLACK, WHITE, WHITE, WHITE, None, None),
    ],
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
    "cow": [
        (RED, WHITE, WHITE, None, None, WHITE),
        (BROWN, None, CREAM, None, None, DARK),
        (BLACK,) + (None,) * 5,
        (FAWN, None, WHITE, None, None, DARK),
        (WHITE, None, PINK, None, None, None),
    ],
    "bull": [(BLACK,) + (None,) * 5, (BROWN, None, None, None, None, BLACK), (RED,) + (None,) * 5, (CREAM,) + (None,) * 5],
    "zebu": [(WHITE, None, None, None, GREY, DARK), (SILVER, GREY, DARK, None, SLATE, BLACK), (RED, None, None, CREAM, None, DARK), (SAND, None, CREAM, None, None, DARK)],
    "buffalo": [(SLATE, None, None, None, None, BLACK), (BLACK, GREY, None, None, None, BLACK), ((0.17, 0.12, 0.1),) + (None,) * 5],
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
