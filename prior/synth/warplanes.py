"""A maker of aeroplanes by their real types: fighters, attack aircraft, trainers, bombers, transports, and those of the 1940s, of the bush and of the airlines."""

from typing import NamedTuple

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, PLAIN, SEAMS, STREAKS, STRIPES, Material
from .seacraft import ports

GREYS = [[0.3, 0.32, 0.35], [0.42, 0.44, 0.46], [0.2, 0.22, 0.25], [0.26, 0.33, 0.4], [0.5, 0.53, 0.55]]
EARTHS = [[0.1, 0.12, 0.06], [0.13, 0.15, 0.08], [0.38, 0.3, 0.18], [0.18, 0.2, 0.17], [0.3, 0.22, 0.12]]
SECONDS = [[0.04, 0.06, 0.03], [0.12, 0.07, 0.03], [0.1, 0.1, 0.11], [0.2, 0.2, 0.2]]
GAY = [[0.65, 0.03, 0.03], [0.75, 0.45, 0.02], [0.02, 0.08, 0.35], [0.02, 0.02, 0.025], [0.7, 0.2, 0.02], [0.02, 0.25, 0.1], [0.8, 0.8, 0.78]]


class Look(NamedTuple):
    """An aeroplane's materials."""

    skin: Material
    trim: Material
    metal: Material
    dark: Material
    glass: Material
    rubber: Material


class Panel(NamedTuple):
    """A wing's or tail's middles of chord at its root and tip, the chords there, its thickness over the chord."""

    root: np.ndarray
    tip: np.ndarray
    chord: float
    narrow: float
    thick: float
    lift: float


# Along x all types are given in metres behind their nose, up from the body's axis. hull: (x, z, half width, half height).
# panels: (x of the leading edge, y, z at the root, chord, span, sweep of the leading edge, chord at the tip, degrees up), the wing first.
# intakes: (front, rear, y, z, half width, half height, rake). nozzles: (front, y, z, radius, length). canopy: (x, z, half sizes).
# gear: (nose wheel, main wheels, y, height of the axis over the ground, radius of the wheels).
FIGHTERS = {
    "falcon": {
        "hull": [(0, 0, 0.06, 0.06), (1.6, 0.02, 0.42, 0.4), (3.2, 0.08, 0.55, 0.6), (5.5, 0.1, 0.68, 0.75), (9.5, 0.02, 0.8, 0.75), (13.3, 0.05, 0.6, 0.6)],
        "panels": [(6.2, 0.7, 0.05, 4.4, 3.9, 40, 1.1, 0), (11.3, 0.6, 0, 2.3, 2.1, 40, 0.75, -8), (9.6, 0, 0.5, 3.4, 2.75, 47, 1.3, 90), (3.9, 0.35, 0.05, 4, 0.75, 72, 1.6, 0), (10.6, 0.45, -0.5, 1.3, 0.8, 35, 0.8, -68)],
        "intakes": [(4.4, 9.5, 0, -0.8, 0.55, 0.42, 0)],
        "nozzles": [(13.2, 0, 0.05, 0.6, 1.2)],
        "canopy": (4.5, 0.62, 1.75, 0.42, 0.62),
        "gear": (5.6, 8.4, 1.1, 2.0, 0.34),
        "tips": True,
    },
    "eagle": {
        "hull": [(0, -0.1, 0.06, 0.06), (2, -0.05, 0.52, 0.5), (4.2, 0.05, 0.68, 0.72), (8, 0.2, 0.85, 0.8), (12, 0.25, 0.85, 0.55), (16, 0.2, 0.5, 0.3)],
        "panels": [(8.2, 1.7, 0.62, 6, 4.8, 45, 1.7, -1), (15.1, 1.75, 0.1, 3, 2.4, 50, 1.1, 0), (13.4, 1.75, 0.2, 3.2, 3, 37, 0.9, 90)],
        "intakes": [(6.4, 16.2, 1.2, -0.05, 0.68, 0.8, 1.3)],
        "nozzles": [(15.8, 0.85, 0.02, 0.66, 2.3)],
        "canopy": (5.2, 0.72, 1.9, 0.5, 0.62),
        "gear": (5.8, 11.3, 1.4, 2.1, 0.42),
        "booms": (12.5, 17.2, 1.72, 0.15, 0.25, 0.25),
    },
    "hornet": {
        "hull": [(0, -0.1, 0.06, 0.06), (2, -0.05, 0.48, 0.46), (4.2, 0.05, 0.6, 0.68), (8, 0.1, 0.75, 0.8), (12, 0.05, 1.1, 0.65), (15.6, 0, 0.85, 0.5)],
        "panels": [(8.5, 1.1, 0.4, 4.1, 4.5, 26, 1.7, -2), (13.4, 1.0, -0.1, 2.5, 2.4, 46, 0.9, -2), (10.2, 0.85, 0.15, 2.9, 3, 42, 1.1, 70), (4.3, 0.5, 0.42, 5.5, 0.85, 75, 2.4, 0)],
        "intakes": [(8.0, 14, 1.0, -0.25, 0.42, 0.5, 0.25)],
        "nozzles": [(15.2, 0.52, 0, 0.5, 1.4)],
        "canopy": (4.6, 0.65, 1.8, 0.45, 0.58),
        "gear": (4.8, 9.9, 1.5, 1.95, 0.38),
        "tips": True,
    },
    "flanker": {
        "hull": [(0, -0.45, 0.06, 0.06), (2.5, -0.2, 0.55, 0.55), (5, 0.15, 0.75, 0.85), (8.5, 0.35, 0.85, 0.8), (12, 0.25, 0.9, 0.5), (17, 0.05, 0.45, 0.3), (21.5, 0.05, 0.2, 0.2)],
        "panels": [(9.4, 1.9, 0.1, 5.6, 5.3, 42, 1.7, -1), (16.3, 2.0, -0.1, 3.4, 2.7, 45, 1.3, 0), (14, 1.95, 0.1, 3.6, 3.4, 40, 1.5, 90), (5.5, 0.6, 0.15, 8, 1.5, 68, 4.5, 0)],
        "intakes": [(9.2, 15.5, 1.25, -0.75, 0.55, 0.62, 0.9)],
        "nozzles": [(15.2, 1.25, -0.45, 0.72, 4.2)],
        "canopy": (5.4, 0.85, 1.9, 0.5, 0.65),
        "gear": (6.5, 12, 1.9, 2.5, 0.5),
        "booms": (9.5, 18.2, 1.75, 0.02, 0.4, 0.22),
        "tips": True,
    },
    "fulcrum": {
        "hull": [(0, -0.35, 0.06, 0.06), (2, -0.15, 0.5, 0.5), (4, 0.1, 0.65, 0.75), (7, 0.25, 0.75, 0.7), (10, 0.2, 0.85, 0.5), (15.5, 0, 0.3, 0.22)],
        "panels": [(7.5, 1.5, 0.1, 4.5, 4.1, 42, 1.4, -2), (12.6, 1.6, -0.05, 2.8, 2.2, 50, 1.0, -3), (10.6, 1.5, 0.1, 3.3, 2.7, 47, 1.1, 83), (4.4, 0.5, 0.15, 7, 1.15, 71, 3.4, 0)],
        "intakes": [(6.7, 13, 0.98, -0.6, 0.42, 0.5, 0.9)],
        "nozzles": [(12.5, 0.98, -0.35, 0.56, 3.4)],
        "canopy": (4.4, 0.7, 1.6, 0.45, 0.58),
        "gear": (5.3, 9.2, 1.5, 2.0, 0.4),
        "booms": (7.6, 14.4, 1.35, 0.02, 0.32, 0.2),
    },
    "raptor": {
        "hull": [(0, 0, 0.08, 0.04), (2.6, 0.02, 0.65, 0.5), (5.5, 0.1, 0.95, 0.75), (9, 0.12, 1.5, 0.65), (13, 0.1, 1.6, 0.55), (17, 0.05, 1.3, 0.3)],
        "panels": [(7.2, 1.5, 0.25, 8.4, 5.2, 42, 1.6, -3), (14.2, 1.6, 0.1, 3.8, 2.7, 42, 1.0, 0), (12, 1.55, 0.35, 3.8, 2.9, 24, 1.5, 62), (3, 0.5, 0.15, 6, 1.1, 72, 3.5, 0)],
        "intakes": [(6.3, 12.5, 1.2, -0.18, 0.52, 0.5, -0.5)],
        "nozzles": [(15.8, 0.75, 0.05, 0.5, 1.9)],
        "canopy": (4.9, 0.6, 1.9, 0.5, 0.7),
        "gear": (6, 11, 1.6, 1.95, 0.45),
        "box": True,
    },
    "lightning": {
        "hull": [(0, -0.05, 0.08, 0.05), (2.2, 0, 0.6, 0.5), (4.5, 0.1, 0.85, 0.8), (8, 0.1, 1.25, 0.75), (11, 0.1, 1.25, 0.7), (13.8, 0.05, 0.85, 0.62)],
        "panels": [(6.3, 1.2, 0.25, 5.8, 4.1, 34, 1.3, -1), (11.6, 1.1, 0.05, 3.2, 2.5, 34, 1.0, 0), (10.2, 1.1, 0.4, 3.1, 2.4, 32, 1.3, 66), (2.8, 0.5, 0.2, 5, 0.85, 72, 3.2, 0)],
        "intakes": [(5.2, 10.5, 1.02, -0.1, 0.45, 0.55, -0.45)],
        "nozzles": [(13.5, 0, 0.05, 0.66, 1.6)],
        "canopy": (4.0, 0.65, 1.5, 0.48, 0.65),
        "gear": (4.9, 9.2, 1.5, 2.0, 0.42),
        "box": True,
    },
    "mirage": {
        "hull": [(0, 0, 0.05, 0.05), (2.2, 0, 0.4, 0.42), (4.5, 0.05, 0.55, 0.7), (8, 0, 0.72, 0.75), (12.5, 0, 0.6, 0.62)],
        "panels": [(5.9, 0.5, -0.35, 7.1, 3.6, 60, 0.35, -1), (9.2, 0, 0.5, 4.4, 2.6, 60, 1.1, 90)],
        "intakes": [(4.6, 9.2, 0.62, 0.05, 0.3, 0.5, 0)],
        "nozzles": [(12.4, 0, 0, 0.58, 1.1)],
        "canopy": (3.5, 0.55, 1.2, 0.38, 0.5),
        "gear": (4.4, 9.2, 1.55, 1.9, 0.36),
    },
    "fishbed": {
        "hull": [(0, 0, 0.45, 0.45), (2.5, 0.02, 0.58, 0.58), (5, 0.05, 0.62, 0.68), (9, 0, 0.62, 0.66), (13, 0, 0.55, 0.55)],
        "panels": [(6.1, 0.5, -0.1, 4.8, 3.1, 57, 0.35, -2), (11.3, 0.5, 0, 1.9, 1.8, 55, 0.7, 0), (9.6, 0, 0.4, 3.5, 2.5, 60, 1.1, 90), (11, 0, -0.5, 2, 0.5, 50, 1.2, -90)],
        "nozzles": [(12.8, 0, 0, 0.52, 0.7)],
        "canopy": (3.6, 0.5, 1.2, 0.38, 0.5),
        "gear": (2.8, 7.9, 1.3, 1.75, 0.36),
        "mouth": 0.7,
    },
    "sabre": {
        "hull": [(0, 0, 0.42, 0.42), (2.2, 0.02, 0.62, 0.7), (5, 0, 0.7, 0.78), (8, 0.05, 0.55, 0.62), (10.6, 0.12, 0.36, 0.38)],
        "panels": [(3.4, 0.5, -0.25, 3, 4.9, 36, 1.5, 2), (9, 0.2, 0.5, 1.4, 1.9, 36, 0.7, 6), (7.6, 0, 0.4, 2.6, 2.5, 42, 1.0, 90)],
        "nozzles": [(10.4, 0, 0.12, 0.34, 0.3)],
        "canopy": (3.4, 0.65, 1.1, 0.4, 0.55),
        "gear": (1.9, 5.5, 1.25, 1.7, 0.34),
        "mouth": 0.12,
    },
    "starfighter": {
        "hull": [(0, 0, 0.04, 0.04), (2.2, 0, 0.38, 0.38), (5, 0.05, 0.5, 0.62), (9, 0, 0.7, 0.66), (14, 0.05, 0.5, 0.5)],
        "panels": [(8, 0.6, -0.05, 3.8, 2.3, 26, 1.9, -10), (14.2, 0, 2.45, 1.9, 1.8, 12, 1.1, 0), (11.8, 0, 0.4, 3.6, 2.1, 42, 2.1, 90)],
        "intakes": [(6.4, 10.5, 0.68, 0.05, 0.28, 0.4, 0)],
        "nozzles": [(13.9, 0, 0.05, 0.5, 0.9)],
        "canopy": (4.4, 0.6, 1.3, 0.36, 0.45),
        "gear": (5.2, 9.6, 1.2, 1.75, 0.36),
        "tips": True,
    },
    "phantom": {
        "hull": [(0, -0.25, 0.06, 0.06), (2, -0.1, 0.5, 0.52), (4.5, 0.1, 0.62, 0.78), (8, 0.1, 0.75, 0.85), (12, 0.15, 0.7, 0.75), (17.4, 0.5, 0.14, 0.25)],
        "panels": [(6.8, 1.1, -0.55, 6.5, 3.0, 51, 3.4, 0), (10.5, 4.1, -0.55, 3.4, 1.6, 51, 1.4, 12), (14.9, 0.3, 0.45, 2.6, 2.5, 40, 0.9, -23), (13.2, 0, 0.7, 3.6, 1.9, 58, 1.4, 90)],
        "intakes": [(5.4, 11, 0.98, 0.05, 0.36, 0.72, 0)],
        "nozzles": [(11.5, 0.5, -0.3, 0.52, 2.4)],
        "canopy": (4.6, 0.78, 2.1, 0.42, 0.5),
        "gear": (5, 10, 2.4, 2.1, 0.42),
    },
    "tiger": {
        "hull": [(0, -0.15, 0.04, 0.04), (2.5, -0.05, 0.38, 0.4), (5, 0.05, 0.48, 0.62), (8, 0, 0.75, 0.62), (13, 0, 0.68, 0.5)],
        "panels": [(7, 0.65, -0.3, 3.1, 3.4, 30, 0.9, 0), (11.8, 0.5, -0.2, 2.0, 1.8, 32, 0.7, -4), (10.6, 0, 0.4, 2.8, 2.2, 32, 0.9, 90)],
        "intakes": [(6, 10, 0.7, 0, 0.26, 0.4, 0)],
        "nozzles": [(12.8, 0.35, 0, 0.35, 0.9)],
        "canopy": (4.5, 0.55, 1.6, 0.36, 0.48),
        "gear": (5.2, 9, 1.5, 1.7, 0.32),
        "tips": True,
    },
    "gripen": {
        "hull": [(0, -0.1, 0.05, 0.05), (2, -0.05, 0.45, 0.45), (4, 0.05, 0.55, 0.68), (7.5, 0.05, 0.85, 0.75), (12.8, 0, 0.6, 0.6)],
        "panels": [(6.4, 0.75, -0.1, 5.6, 3.5, 50, 1.0, -2), (4.4, 0.6, 0.35, 1.8, 1.6, 45, 0.6, 6), (9.4, 0, 0.5, 3.3, 2.5, 48, 1.0, 90)],
        "intakes": [(4.7, 9, 0.75, 0, 0.34, 0.5, 0)],
        "nozzles": [(12.6, 0, 0, 0.55, 1.2)],
        "canopy": (3.7, 0.62, 1.4, 0.42, 0.55),
        "gear": (4.5, 9, 1.2, 1.85, 0.36),
        "tips": True,
    },
    "typhoon": {
        "hull": [(0, -0.1, 0.05, 0.05), (2, -0.05, 0.48, 0.45), (4.2, 0.08, 0.6, 0.7), (8, 0.05, 0.85, 0.8), (13.5, 0, 0.95, 0.6)],
        "panels": [(6.2, 0.75, -0.15, 7.4, 4.6, 53, 0.8, -2), (3.4, 0.45, 0.05, 1.6, 1.7, 52, 0.4, -10), (10.2, 0, 0.5, 4.1, 2.6, 52, 1.2, 90)],
        "intakes": [(4.8, 11, 0, -0.88, 0.75, 0.4, 0.4)],
        "nozzles": [(13.2, 0.48, 0, 0.48, 1.4)],
        "canopy": (4.2, 0.65, 1.6, 0.44, 0.6),
        "gear": (5.3, 9.6, 1.5, 2.1, 0.38),
        "tips": True,
    },
    "rafale": {
        "hull": [(0, -0.2, 0.05, 0.05), (2, -0.08, 0.45, 0.45), (4.2, 0.08, 0.58, 0.7), (8, 0.05, 0.9, 0.75), (13.2, 0, 0.9, 0.58)],
        "panels": [(6.5, 0.8, 0.1, 6.2, 4.2, 48, 1.0, -3), (4.7, 0.7, 0.4, 2.2, 1.8, 55, 0.6, 3), (9.8, 0, 0.5, 3.6, 2.6, 50, 1.1, 90)],
        "intakes": [(5.2, 10, 0.72, -0.3, 0.4, 0.42, 0)],
        "nozzles": [(13, 0.46, 0, 0.46, 1.3)],
        "canopy": (4, 0.65, 1.5, 0.43, 0.58),
        "gear": (4.9, 9.3, 1.4, 2.0, 0.38),
        "tips": True,
    },
    "harrier": {
        "hull": [(0, -0.15, 0.08, 0.08), (1.6, 0, 0.42, 0.45), (4, 0.1, 0.62, 0.75), (7.5, 0.05, 0.7, 0.7), (10, 0.15, 0.42, 0.5), (13.8, 0.3, 0.1, 0.12)],
        "panels": [(5.2, 0.5, 0.7, 3.6, 4.1, 38, 1.2, -12), (11.3, 0.2, 0.35, 1.8, 2.0, 38, 0.7, -15), (10.2, 0, 0.4, 2.4, 1.7, 40, 0.9, 90), (11, 0, 0.1, 1.3, 0.6, 20, 0.8, -90)],
        "intakes": [(3.6, 7, 0.75, 0.05, 0.4, 0.62, 0)],
        "nozzles": [],
        "canopy": (3, 0.6, 1.2, 0.45, 0.6),
        "gear": (3.5, 8, 0.0, 1.65, 0.38),
    },
    "frogfoot": {
        "hull": [(0, -0.2, 0.25, 0.2), (1.8, -0.05, 0.48, 0.55), (4.5, 0.05, 0.6, 0.78), (9, 0, 0.6, 0.65), (15, 0.25, 0.22, 0.3)],
        "panels": [(5.4, 1.1, 0.4, 3.2, 6.1, 20, 1.4, -2), (12.6, 0.3, 0.4, 1.8, 2.3, 20, 1.0, 4), (11.2, 0, 0.5, 2.7, 2.3, 35, 1.2, 90)],
        "intakes": [(4.6, 9, 0.95, 0, 0.45, 0.55, 0.3)],
        "nozzles": [(8.5, 0.95, 0, 0.5, 2.6)],
        "canopy": (3.2, 0.65, 1.1, 0.44, 0.55),
        "gear": (3.5, 8, 1.4, 1.9, 0.42),
        "pods": True,
    },
    "hawk": {
        "hull": [(0, -0.1, 0.08, 0.08), (1.4, 0, 0.38, 0.38), (3.2, 0.1, 0.5, 0.7), (6.5, 0.05, 0.58, 0.62), (9.5, 0.15, 0.42, 0.45), (11.3, 0.2, 0.25, 0.26)],
        "panels": [(4.7, 0.2, -0.42, 2.8, 4.55, 26, 0.95, 2), (9.9, 0.25, 0.3, 1.5, 2.0, 28, 0.7, -10), (8.8, 0, 0.5, 2.4, 1.8, 38, 0.9, 90)],
        "intakes": [(4.2, 7.2, 0.58, 0.1, 0.2, 0.36, 0)],
        "nozzles": [(11.2, 0, 0.2, 0.25, 0.35)],
        "canopy": (3.3, 0.62, 1.75, 0.4, 0.6),
        "gear": (2.4, 5.9, 1.5, 1.4, 0.26),
    },
    "albatros": {
        "hull": [(0, -0.15, 0.06, 0.06), (2.2, -0.05, 0.38, 0.42), (4.2, 0.1, 0.48, 0.68), (7, 0.1, 0.55, 0.62), (11, 0.2, 0.28, 0.28)],
        "panels": [(4.9, 0.15, -0.45, 2.7, 4.5, 8, 1.25, 3), (9.8, 0.2, 0.25, 1.4, 2.1, 12, 0.8, 0), (8.4, 0, 0.5, 2.5, 2.1, 40, 1.0, 90)],
        "intakes": [(5.2, 8, 0.55, 0.4, 0.22, 0.34, 0)],
        "nozzles": [(10.9, 0, 0.2, 0.27, 0.35)],
        "canopy": (4.1, 0.6, 1.9, 0.38, 0.58),
        "gear": (2.6, 6.6, 1.2, 1.35, 0.27),
        "pods": True,
    },
    "alpha": {
        "hull": [(0, -0.2, 0.06, 0.06), (2, -0.05, 0.4, 0.42), (4, 0.1, 0.48, 0.7), (7, 0.2, 0.5, 0.6), (11.6, 0.35, 0.12, 0.18)],
        "panels": [(4.3, 0.2, 0.48, 2.9, 4.4, 31, 1.0, -6), (9.8, 0.2, 0.3, 1.6, 2.0, 32, 0.7, -8), (8.4, 0, 0.5, 2.5, 2.0, 44, 0.9, 90)],
        "intakes": [(4.3, 8, 0.65, -0.05, 0.28, 0.36, 0.2)],
        "nozzles": [(7.6, 0.62, -0.02, 0.3, 1.0)],
        "canopy": (3.5, 0.6, 1.75, 0.38, 0.58),
        "gear": (2.9, 6, 1.0, 1.45, 0.27),
    },
    "macchi": {
        "hull": [(0, -0.1, 0.12, 0.14), (1.2, 0, 0.38, 0.42), (3, 0.1, 0.48, 0.68), (6.5, 0.05, 0.52, 0.6), (10.7, 0.15, 0.28, 0.28)],
        "panels": [(4.2, 0.45, -0.4, 2.4, 4.7, 11, 1.3, 3), (9.2, 0.2, 0.3, 1.5, 1.9, 15, 0.9, 0), (8.1, 0, 0.5, 2.3, 1.8, 40, 1.0, 90)],
        "intakes": [(4.0, 6.8, 0.55, -0.15, 0.2, 0.3, 0)],
        "nozzles": [(10.6, 0, 0.15, 0.27, 0.35)],
        "canopy": (3.1, 0.6, 1.7, 0.38, 0.58),
        "gear": (1.9, 5.6, 1.3, 1.35, 0.27),
        "pods": True,
    },
}
TRAINERS = ("hawk", "albatros", "alpha", "macchi", "tiger")


def warplane(kit):
    """Fighters of all ages and makes, attack and training jets, transports, bombers, radar and tanker aircraft, bush planes, dusters, business jets, airliners, amphibians."""
    kinds = [combat_jet, tank_killer, propeller_transport, jet_transport, radar_aeroplane, big_jet, big_delta, turbo_trainer, piston_fighter, piston_bomber, twin_boom, bush_plane, duster, business_jet, amphibian]
    chances = np.array([38, 5, 6, 5, 4, 8, 3, 5, 10, 8, 2, 7, 3, 5, 5], float)
    kinds[kit.rng.choice(len(kinds), p=chances / chances.sum())](kit)


def looks(kit, style):
    """Materials of the style `grey`, `drab` or `gay`; bare metal at times."""
    rng = kit.rng
    if style == "gay":
        base = np.array(GAY[rng.integers(len(GAY))]) if kit.chance(0.6) else np.ones(3) * rng.uniform(0.6, 0.9)
        skin = kit.material(base=base, pattern=rng.choice([PLAIN, PLAIN, PLAIN, CLOUDY, STREAKS]), second=base * 0.85, gloss=rng.uniform(0.1, 0.5))
    elif kit.chance(0.1):
        skin = kit.material(base=np.ones(3) * rng.uniform(0.4, 0.65), pattern=SEAMS, second=np.ones(3) * 0.3, frequency=rng.uniform(9, 18), gloss=0.5)
    else:
        tones = GREYS if style == "grey" else EARTHS
        base = np.array(tones[rng.integers(len(tones))]) * rng.uniform(0.75, 1.25)
        second = base * rng.uniform(0.5, 0.75) if style == "grey" else np.array(SECONDS[rng.integers(len(SECONDS))])
        pattern = rng.choice([PLAIN, CAMOUFLAGE, CAMOUFLAGE, CLOUDY, SEAMS])
        second, often = (base * 0.7, rng.uniform(9, 18)) if pattern == SEAMS else (second, rng.uniform(3, 8))
        skin = kit.material(base=base, pattern=pattern, second=second, frequency=often, gloss=rng.uniform(0, 0.25))
    trim = kit.material(base=GAY[rng.integers(len(GAY))], pattern=rng.choice([PLAIN, PLAIN, STRIPES]), frequency=8, gloss=0.2) if style == "gay" or kit.chance(0.2) else skin
    metal = kit.material(base=np.ones(3) * rng.uniform(0.08, 0.3), pattern=rng.choice([PLAIN, BANDS, CLOUDY]), second=[0.12, 0.1, 0.09], gloss=0.3)
    glass = kit.material(base=np.array([0.04, 0.05, 0.06]) * rng.uniform(0.6, 2.5), pattern=PLAIN, gloss=0.6)
    return Look(skin, trim, metal, kit.material(base=[0.015] * 3, pattern=PLAIN, gloss=0.05), glass, kit.material(dark=True, pattern=PLAIN))


def hull(kit, stations, skin, y=0.0, box=False):
    """A body through stations [(x behind the nose, z, half width, half height), ...]; with y: one on either side."""
    for a, b in zip(stations[:-1], stations[1:], strict=True):
        if b[2] * b[3] > a[2] * a[3]:
            a, b = b, a
        start, end = np.array([-a[0], y, a[1]]), np.array([-b[0], y, b[1]])
        if box:
            way = np.sign(end[0] - start[0])
            middle = (start + end) / 2 * (1, 1, 0) + [0, 0, a[1]]
            kit.add(BOX, middle, (a[3], a[2], abs(end[0] - start[0]) / 2), (b[3] / a[3], b[2] / a[2]), (-way * (b[1] - a[1]), 0), turn("y", 90 * way), skin, y > 0)
        else:
            kit.between(start + (start - end) * 0.02, end, (a[3], a[2]), taper=np.sqrt(b[2] * b[3] / (a[2] * a[3])), material=skin, mirror=y > 0)


def surface(kit, row, skin, thick=0.05, lens=False):
    """A wing, tail or fin of a row of `panels`; `lens`: with a round section, for those that hardly sweep. Returns its Panel."""
    x, y, z, chord, span, sweep, tip, lift = row
    way = np.array([0, np.cos(np.radians(lift)), np.sin(np.radians(lift))])
    root = np.array([-x - chord / 2, y, z])
    back = span * np.tan(np.radians(sweep)) + (tip - chord) / 2
    end = root + way * span - [back, 0, 0]
    mirror = y > 0 or abs(lift) != 90
    if lens:
        rotation = turn("x", lift - 90) @ turn("y", -np.degrees(np.arctan2(back, span)))
        kit.add(CYL, (root + end) / 2, (chord / 2, thick * chord * 0.6, np.hypot(back, span) / 2), (tip / chord, 1), (0, 0), rotation, skin, mirror)
    else:
        kit.add(BOX, root + way * span / 2, (chord / 2, thick * chord / 2, span / 2), (tip / chord, 0.8 * tip / chord), (-back, 0), turn("x", lift - 90), skin, mirror)
    return Panel(root, end, chord, tip, thick, lift)


def on(panel, share, fore=0.0):
    """A point of a Panel's middle plane, `share` of its span out and `fore` of the chord there before its middle."""
    return panel.root + (panel.tip - panel.root) * share + [fore * (panel.chord + (panel.narrow - panel.chord) * share), 0, 0]


def wheel(kit, x, y, ground, radius, look, top, twin=False, inner=None):
    """A leg from the height `top` down to one wheel, or a pair of them; with y: one on either side."""
    z = radius - ground
    kit.between((-x, y if inner is None else inner, top), (-x, y, z), radius * 0.22, material=look.metal, mirror=y > 0)
    kit.add(CYL, (-x, y, z), (radius, radius, radius * (0.75 if twin else 0.36)), rotation=ALONG_Y, material=look.rubber, mirror=y > 0)


def tricycle(kit, row, look, top=-0.2):
    """A nose wheel and two main ones with their doors."""
    nose, main, y, ground, radius = row
    wheel(kit, nose, 0, ground, radius * 0.75, look, top)
    wheel(kit, main, y, ground, radius, look, top, inner=y * 0.6)
    kit.add(BOX, (-nose, radius * 0.6, -0.15 - ground * 0.34), (radius * 0.9, 0.02, ground * 0.34 - 0.15), material=look.skin, mirror=True)


def roundels(kit, panel, share, size):
    """Round marks on both wings."""
    ring = kit.material(base=GAY[kit.rng.choice([0, 2, 2, 5])], pattern=PLAIN)
    core = kit.material(base=[[0.75] * 3, [0.65, 0.03, 0.03]][kit.rng.integers(2)], pattern=PLAIN)
    half = panel.thick * (panel.chord + (panel.narrow - panel.chord) * share) * 0.6
    for radius, paint, more in ((size, ring, 0.015), (size * 0.5, core, 0.03)):
        kit.add(CYL, on(panel, share), (radius, radius, half + more), rotation=turn("x", panel.lift), material=paint, mirror=True)


def stores(kit, panel, shares, look, size=1.0):
    """Pylons under a wing with drop tanks, bombs or missiles."""
    rng = kit.rng
    white = kit.material(base=np.ones(3) * rng.uniform(0.25, 0.8), pattern=PLAIN)
    green = kit.material(base=[0.1, 0.12, 0.06], pattern=BANDS, frequency=3, second=[0.12, 0.14, 0.07])
    for share in shares:
        kind = rng.choice(["tank", "bomb", "missile", "missile"])
        at = on(panel, share, 0.1)
        radius, long = {"tank": (0.33, 2.2), "bomb": (0.2, 1.2), "missile": (0.1, 1.5)}[kind]
        radius, long = radius * size, long * size
        low = at - [0, 0, 0.28 * size + radius]
        kit.add(BOX, (at + low) / 2, (0.6 * size, 0.05 * size, 0.16 * size + radius / 2), (1.3, 1), (-0.15, 0), material=look.skin, mirror=True)
        if kind == "missile":
            kit.add(CYL, low, (radius, radius, long), rotation=ALONG_X, material=white, mirror=True)
            kit.add(BALL, low + [long, 0, 0], (radius * 3, radius, radius), material=look.metal, mirror=True)
            for lean in (45, -45):
                kit.add(BOX, low - [long * 0.85, 0, 0], (0.2 * size, 0.3 * size, 0.012), rotation=turn("x", lean), material=white, mirror=True)
        else:
            kit.add(BALL, low, (long, radius, radius), material=look.skin if kind == "tank" and kit.chance(0.6) else green if kind == "bomb" else white, mirror=True)
            kit.add(BOX, low - [long * 0.85, 0, 0], (0.25 * size, radius, 0.015), material=look.skin, mirror=True)


def airscrew(kit, at, radius, look, blades=None, boss=0.1, mirror=False):
    """A pointed boss with blades, before `at`; with `mirror`, one on either side."""
    blades, first, wide = blades or int(kit.rng.choice([2, 3, 4])), kit.rng.uniform(0, 120), kit.rng.uniform(0.06, 0.085)
    at = np.array(at, float)
    kit.add(CYL, at + [boss * 0.8, 0, 0], (boss, boss, boss), (0.25, 1), rotation=ALONG_X, material=look.trim, mirror=mirror)
    whole = blades % 2 == 0
    for k in range(blades // 2 if whole else blades):
        spin = turn("x", first + 360 * k / blades)
        middle = at + [boss * 0.8, 0, 0] + (0 if whole else radius / 2) * spin[:, 2]
        kit.add(BOX, middle, (0.03 * radius, wide * radius, radius if whole else radius / 2), rotation=spin, material=look.dark, mirror=mirror)


def combat_jet(kit):
    """A row of FIGHTERS: on its gear or in the air, clean or with stores; two seats or one."""
    rng = kit.rng
    name = rng.choice(list(FIGHTERS))
    row = FIGHTERS[name]
    look = looks(kit, "gay" if name in TRAINERS and kit.chance(0.65) else "grey" if kit.chance(0.65) else "drab")
    tip = look.skin if kit.chance(0.5) else kit.material(base=np.ones(3) * rng.uniform(0.02, 0.3), pattern=PLAIN)
    stations = row["hull"]
    box = row.get("box", False)
    mouth = row.get("mouth")
    hull(kit, stations[:2], look.skin if mouth else tip, box=box)
    hull(kit, stations[1:], look.skin, box=box)
    x, z, *half = row["canopy"]
    longer = rng.uniform(1.0, 1.25)
    kit.add(BALL, (-x - half[0] * (longer - 1), 0, z), (half[0] * longer, half[1], half[2]), material=look.glass)
    if not box:
        back, high = x + half[0] * 0.6, half[2] * 0.5
        kit.add(BOX, (-back - 1.8, 0, z), (2.2, half[1] * 0.85, high), (0.75, 0.6), (0.4, 0), material=look.skin)
    wing = surface(kit, row["panels"][0], look.skin, 0.045)
    fins = look.trim if kit.chance(0.3) else look.skin
    for part in row["panels"][1:]:
        surface(kit, part, fins if part[-1] > 50 else look.skin, 0.045)
    for front, rear, y, z, wide, high, rake in row.get("intakes", []):
        if rake:
            kit.add(BOX, (-(front + rear + rake) / 2 - rake / 2, y, z), ((rear - front) / 2, wide, high), shift=(rake, 0), material=look.skin, mirror=y > 0)
            kit.add(BOX, (-front - rake * 0.93 - (0.02 if rake > 0 else -0.02 + rake * 0.06), y, z), (0.06, wide * 0.84, high * 0.86), shift=(rake * 0.86, 0), material=look.dark, mirror=y > 0)
        else:
            flow = (0.75, 0.55) if y else (0.6, 0.9)
            kit.add(BOX, (-(front + rear) / 2, y, z), (high, wide, (rear - front) / 2), flow, (0.25 * high if not y else 0, -0.3 * wide), turn("y", -90), look.skin, y > 0)
            kit.add(BOX, (-front, y, z), (0.03, wide * 0.82, high * 0.85), material=look.dark, mirror=y > 0)
    for x, y, z, radius, long in row["nozzles"]:
        kit.add(CYL, (-x - long / 2, y, z), (radius, radius, long / 2), (0.82, 1), rotation=turn("y", -90), material=look.metal if long < 2 else look.skin, mirror=y > 0)
        kit.add(CYL, (-x - long, y, z), (radius * 0.72, radius * 0.72, 0.03), rotation=ALONG_X, material=look.dark, mirror=y > 0)
        if long >= 2:
            kit.add(CYL, (-x - long * 0.86, y, z), (radius * 0.89, radius * 0.89, long * 0.13), (0.92, 1), rotation=turn("y", -90), material=look.metal, mirror=y > 0)
    if "booms" in row:
        front, rear, y, z, wide, high = row["booms"]
        kit.add(BOX, (-(front + rear) / 2, y, z), ((rear - front) / 2, wide, high), (0.97, 0.8), material=look.skin, mirror=True)
    if mouth:
        nose = stations[0][2]
        kit.add(CYL, (0, 0, 0), (nose * 0.86, nose * 0.86, 0.03), rotation=ALONG_X, material=look.dark)
        kit.add(CYL, (mouth / 2, 0, 0), (nose * 0.5, nose * 0.5, mouth / 2), (0.05, 1), rotation=ALONG_X, material=look.metal if mouth > 0.3 else look.dark)
    if name == "harrier":
        for x, y in ((5.0, 0.95), (6.9, 0.78)):
            kit.add(BOX, (-x, y, -0.2), (0.34, 0.24, 0.26), (1, 0.8), rotation=turn("y", rng.choice([0, 0, 25])), material=look.metal, mirror=True)
    down = kit.chance(0.7)
    if down and name == "harrier":
        wheel(kit, 3.4, 0, 1.65, 0.3, look, -0.3)
        wheel(kit, 8, 0, 1.65, 0.38, look, -0.3, twin=True)
        at = on(wing, 0.8)
        wheel(kit, -at[0], at[1], 1.65, 0.2, look, at[2])
    elif down:
        tricycle(kit, row["gear"], look, min(-0.2, row["panels"][0][2] + 0.05))
    if row.get("pods"):
        long, fat = (1.5, 0.28) if name != "frogfoot" else (1.1, 0.22)
        kit.add(BALL, on(wing, 1.0), (long, fat, fat), material=look.trim, mirror=True)
    elif row.get("tips") and kit.chance(0.75):
        at = on(wing, 1.0, 0.2)
        kit.add(CYL, at, (0.09, 0.09, 1.45), rotation=ALONG_X, material=look.metal, mirror=True)
        kit.add(BOX, at - [1.2, 0, 0], (0.22, 0.3, 0.012), rotation=turn("x", 45), material=look.metal, mirror=True)
    if not box and kit.chance(0.55):
        kit.between((-0.4, 0, stations[0][1]), (1.1, 0, stations[0][1]), 0.03, material=look.metal)
    if kit.chance(0.6):
        roundels(kit, wing, rng.uniform(0.5, 0.75), min(0.45, wing.narrow * 0.5))
    if kit.chance(0.65 if not box else 0.25):
        stores(kit, wing, np.sort(rng.uniform(0.2, 0.75, int(rng.integers(1, 3)))), look, 0.7 if name in TRAINERS else 1)


def tank_killer(kit):
    """The straight-winged attack aircraft with two fans on the rear body, twin fins and a gun in its nose."""
    rng = kit.rng
    look = looks(kit, rng.choice(["grey", "drab"]))
    hull(kit, [(0, -0.15, 0.3, 0.35), (1.5, -0.05, 0.6, 0.7), (4, 0, 0.68, 0.85), (10, 0.05, 0.65, 0.75), (15.6, 0.25, 0.25, 0.3)], look.skin)
    kit.add(BALL, (0, 0, -0.15), (0.35, 0.3, 0.35), material=look.skin)
    kit.add(BALL, (-3, 0, 0.75), (1.25, 0.46, 0.62), material=look.glass)
    kit.add(BOX, (-6.2, 0, 0.62), (3, 0.4, 0.32), (0.85, 0.6), (0.2, 0), material=look.skin)
    inner = surface(kit, (6.2, 0.5, -0.6, 3.05, 2.4, 0, 3.05, 0), look.skin, 0.14, True)
    wing = surface(kit, (6.2, 2.85, -0.6, 3.05, 5.6, 2.5, 2.0, 7), look.skin, 0.13, True)
    kit.add(BALL, on(wing, 1.0), (1.0, 0.15, 0.35), material=look.skin, mirror=True)
    kit.add(CYL, (-10.6, 1.35, 0.95), (0.72, 0.72, 1.4), (0.82, 1), rotation=turn("y", -90), material=look.skin, mirror=True)
    kit.add(CYL, (-9.2, 1.35, 0.95), (0.6, 0.6, 0.03), rotation=ALONG_X, material=look.dark, mirror=True)
    kit.add(BALL, (-9.2, 1.35, 0.95), (0.25, 0.22, 0.22), material=look.metal, mirror=True)
    kit.add(CYL, (-12.2, 1.35, 0.98), (0.45, 0.45, 0.5), (0.7, 1), rotation=turn("y", -90), material=look.metal, mirror=True)
    kit.add(BOX, (-10.6, 0.6, 0.7), (0.9, 0.7, 0.18), material=look.skin, mirror=True)
    tail = surface(kit, (13.6, 0, 0.25, 2.1, 2.9, 0, 2.0, 0), look.skin, 0.1)
    surface(kit, (13.2, tail.tip[1], -0.35, 2.4, 2.7, 8, 1.7, 90), look.trim, 0.08)
    kit.between((-0.5, -0.12, -0.5), (0.7, -0.12, -0.5), 0.13, material=look.metal)
    at = on(inner, 0.85, 0.1)
    kit.add(BALL, at - [0, 0, 0.3], (1.5, 0.3, 0.42), material=look.skin, mirror=True)
    if kit.chance(0.75):
        wheel(kit, 2.2, 0, 2.35, 0.34, look, -0.5)
        wheel(kit, -at[0] - 0.3, at[1], 2.35, 0.48, look, -0.8)
    if kit.chance(0.8):
        stores(kit, wing, np.sort(rng.uniform(0.05, 0.6, 2)), look)


def turboprops(kit, wing, shares, look, size, blades, drop=0.1):
    """Engines before a wing: a slender nacelle, intake below, boss and blades; one on either side at every share."""
    for share in shares:
        at = on(wing, share)
        front = on(wing, share, 0.5)[0] + size * 2.2
        kit.between((at[0] - size * 1.5, at[1], at[2]), (front, at[1], at[2] - drop), (size * 1.15, size * 0.85), taper=0.85, material=look.skin, mirror=True)
        kit.add(BOX, (front - size * 0.4, at[1], at[2] - drop - size * 0.75), (size * 0.42, size * 0.45, size * 0.25), material=look.metal, mirror=True)
        airscrew(kit, (front, at[1], at[2] - drop), size * 3.6, look, blades, size * 0.55, True)


def cockpit(kit, x, z, wide, high, look, long=0.8):
    """Slanting front windows across the body and others at its sides."""
    kit.add(BOX, (-x, 0, z), (long, wide, high), (0.55, 0.72), (-long * 0.35, 0), material=look.glass)


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


def fan(kit, at, radius, long, look, skin, pylon=None):
    """A fan engine on either side: cowl, dark mouth with its boss, hot nozzle; `pylon`: height of the wing above."""
    at = np.array(at, float)
    if pylon:
        kit.add(BOX, at + [-long * 0.75, 0, pylon / 2], (long * 0.8, radius * 0.12, pylon / 2 + 0.1), (1, 1), (-long * 0.4, 0), material=look.skin, mirror=True)
    kit.add(CYL, at, (radius, radius, long), (0.8, 1), rotation=turn("y", -90), material=skin, mirror=True)
    kit.add(CYL, at + [long, 0, 0], (radius * 0.84, radius * 0.84, 0.04), rotation=ALONG_X, material=look.dark, mirror=True)
    kit.add(BALL, at + [long, 0, 0], (radius * 0.35, radius * 0.25, radius * 0.25), material=look.metal, mirror=True)
    kit.add(CYL, at - [long * 1.3, 0, 0], (radius * 0.6, radius * 0.6, long * 0.35), (0.55, 1), rotation=turn("y", -90), material=look.metal, mirror=True)


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
    """Airliners with two and four engines below or two at the tail, some with a hump; tankers with a boom, radar with a rotodome; the bomber with eight engines in pairs, that with contrary propellers."""
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
    hull(kit, [(0, -0.25 * fat, fat * 0.2, tall * 0.2), (nose, -0.12 * fat, fat * 0.7, tall * 0.7), (2.6 * nose, 0, fat, tall), (long * 0.66, 0, fat, tall), (long, tall * 0.55, fat * 0.18, tall * 0.18)], look.skin)
    kit.add(BALL, (-nose * 0.2, 0, -0.25 * fat), (nose * 0.5, fat * 0.29, tall * 0.29), material=look.skin)
    cockpit(kit, 1.75 * nose, tall * 0.55, fat * 0.62, tall * 0.2, look, nose * 0.45)
    sweep = {"tail": 26, "eight": 37, "hump": 40}.get(kind, 29 if kind == "two" else 34)
    chord, lift = span * (0.42 if kind != "eight" else 0.36), -1.5 if kind == "eight" else 5.5
    x = long * {"tail": 0.42, "eight": 0.27}.get(kind, 0.33)
    inner = surface(kit, (x, fat * 0.5, level, chord, span * 0.36, sweep, chord * (0.6 if kind != "eight" else 0.76), lift), look.skin if not civil else look.skin._replace(first=np.ones(3) * 0.5), 0.12)
    x, y, z = on(inner, 1.0, 0.5)
    wing = surface(kit, (-x, y - 0.02, z, inner.narrow, span * 0.62, sweep - 1, chord * (0.22 if kind != "eight" else 0.38), lift), look.skin if not civil else look.skin._replace(first=np.ones(3) * 0.5), 0.1)
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


def canopy_frames(kit, x, z, long, wide, high, look):
    """A glass canopy with a hoop or two over it."""
    kit.add(BALL, (-x, 0, z), (long, wide, high), material=look.glass)
    for share in (0.25, -0.3)[: int(kit.rng.integers(0, 3))]:
        fit = np.sqrt(1 - share**2) * 1.02
        kit.add(CYL, (-x + long * share, 0, z), (high * fit, wide * fit, 0.03), rotation=ALONG_X, material=look.skin)


def turbo_trainer(kit):
    """Turboprop trainers with two seats under one long canopy, exhausts beside the cowling, a straight low wing."""
    rng = kit.rng
    look = looks(kit, rng.choice(["gay", "gay", "gay", "grey", "drab"]))
    hull(kit, [(0.4, 0, 0.26, 0.27), (1.6, 0, 0.4, 0.45), (3, 0.05, 0.48, 0.62), (5.5, 0.05, 0.48, 0.6), (9.8, 0.3, 0.1, 0.16)], look.skin)
    canopy_frames(kit, 4.2, 0.55, 1.85, 0.4, 0.68, look)
    kit.add(BOX, (-6.4, 0, 0.45), (1.3, 0.33, 0.3), (0.7, 0.5), (0.35, 0), material=look.skin)
    wing = surface(kit, (3.3, 0.35, -0.4, 2.1, 4.8, 3, 1.05, 6), look.skin, 0.14, True)
    surface(kit, (8.3, 0.1, 0.35, 1.2, 1.8, 8, 0.65, 0), look.trim, 0.1)
    surface(kit, (7.8, 0, 0.3, 1.7, 1.5, 28, 0.85, 90), look.trim, 0.1)
    surface(kit, (6.7, 0, 0.35, 1.7, 0.5, 65, 0.6, 90), look.trim, 0.08)
    airscrew(kit, (-0.4, 0, 0), 1.2, look, int(rng.choice([3, 4, 5])), 0.26)
    kit.between((-1.2, 0.36, -0.05), (-1.75, 0.56, -0.12), 0.12, material=look.metal, mirror=True)
    kit.add(BOX, (-0.65, 0, -0.3), (0.3, 0.17, 0.12), material=look.dark)
    if kit.chance(0.75):
        at = on(wing, 0.22)
        wheel(kit, 1.3, 0, 1.35, 0.22, look, -0.3)
        wheel(kit, -at[0] + 0.2, at[1], 1.35, 0.26, look, at[2])
    kit.add(BOX, (-4.2, 0, 0.02), (3, 0.487, rng.uniform(0.04, 0.09)), material=look.trim)
    roundels(kit, wing, 0.7, 0.4)
    if kit.chance(0.35):
        stores(kit, wing, rng.uniform(0.3, 0.6, 1), look, 0.5)


def tilted(kit, start, degrees):
    """What was made since `start` sits on its tail wheel, nose up."""
    tilt = turn("y", -degrees)
    kit.primitives[start:] = [p._replace(centre=tilt @ p.centre, rotation=tilt @ p.rotation) for p in kit.primitives[start:]]


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
        surface(kit, (long * (0.78 if kind == "fortress" else 0.83), 0, tall * 0.5, long * (0.2 if kind == "fortress" else 0.15), tail * 0.95, 40 if kind == "fortress" else 22, long * 0.085, 90), look.skin, 0.09, False)
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
    hull(kit, [(fore, high, 0.42, 0.46), (fore + 3, high, 0.36, 0.4), (rear, high + 0.15, 0.15, 0.18)] if kind != "vampire" else [(4, high, 0.15, 0.16), (rear, high + 0.15, 0.12, 0.14)], look.skin, y)
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


def bush_plane(kit):
    """High-winged liaison and bush planes on a tail wheel or nose wheel, with struts; big tyres, floats or skis; flat engine or radial."""
    rng = kit.rng
    look = looks(kit, rng.choice(["gay", "gay", "gay", "drab"]))
    start, round_nose, on_tail = len(kit.primitives), kit.chance(0.35), kit.chance(0.6)
    fat = rng.uniform(0.48, 0.62)
    if round_nose:
        hull(kit, [(0.3, 0, 0.55, 0.55), (1.3, 0, 0.58, 0.6)], look.trim)
        kit.add(CYL, (-0.3, 0, 0), (0.45, 0.45, 0.03), rotation=ALONG_X, material=look.dark)
    else:
        hull(kit, [(0.2, 0, 0.3, 0.26), (1.3, 0, fat * 0.92, 0.45)], look.skin, box=True)
        kit.add(BOX, (-0.2, 0.17, 0.02), (0.03, 0.1, 0.08), material=look.dark, mirror=True)
    airscrew(kit, (-0.25, 0, 0), rng.uniform(0.95, 1.15), look, int(rng.choice([2, 2, 3])), 0.13)
    hull(kit, [(1.2, -0.03, fat, 0.5), (3.9, 0, fat, 0.55), (rng.uniform(7.2, 8.4), 0.18, 0.08, 0.16)], look.skin, box=True)
    rear = 7.6
    kit.add(BOX, (-2.65, 0, 0.78), (1.25, fat * 0.97, 0.36), (0.62, 0.9), (-0.12, 0), material=look.glass)
    kit.add(BOX, (-2.8, 0, 0.78), (0.06, fat * 0.99, 0.36), (1, 0.92), material=look.skin)
    kit.add(BOX, (-4.0, 0, 0.65), (0.9, fat * 0.9, 0.4), (0.5, 0.7), (0.4, 0), material=look.skin)
    half, chord = rng.uniform(5.0, 6.5), rng.uniform(1.45, 1.75)
    wing = surface(kit, (2.0, 0, 1.14, chord, half, 0, chord * rng.choice([1, 1, 0.75]), rng.uniform(0.5, 2)), look.skin, 0.13, True)
    kit.add(BALL, on(wing, 1.0), (chord * 0.36, 0.15, 0.1), material=look.trim, mirror=True)
    strut = on(wing, 0.5)
    for fore in (0.3, -0.35)[: int(rng.integers(1, 3))]:
        kit.between((-2.6 + fore, fat * 0.9, -0.35), strut + [fore, 0, -0.05], (0.06, 0.03), material=look.skin, mirror=True)
    surface(kit, (rear - 0.9, 0.02, 0.22, 1.05, rng.uniform(1.6, 1.9), 6, 0.8, 0), look.skin, 0.08, True)
    surface(kit, (rear - 1.0, 0, 0.15, 1.2, rng.uniform(1.2, 1.5), 30, 0.65, 90), look.trim, 0.08, True)
    surface(kit, (rear - 2.3, 0, 0.3, 1.8, 0.45, 70, 0.5, 90), look.trim, 0.05)
    kit.add(BOX, (-3.6, 0, -0.05), (2.3, fat * 1.005, rng.uniform(0.05, 0.12)), (1, 0.99), material=look.trim)
    if kit.chance(0.2):
        hull(kit, [(-0.2, -1.75, 0.08, 0.1), (1.4, -1.75, 0.36, 0.34), (3.4, -1.75, 0.36, 0.34), (6.4, -1.6, 0.1, 0.1)], look.trim, 1.15)
        for x in (1.7, 3.5):
            kit.between((-x, fat * 0.7, -0.35), (-x, 1.15, -1.6), 0.05, material=look.metal, mirror=True)
            kit.between((-x, -1.15, -1.6), (-x, 1.15, -1.6), 0.05, material=look.metal)
        return
    radius = rng.choice([0.24, 0.24, 0.38])
    x, ground = (1.75, 1.3) if on_tail else (3.1, 1.2)
    kit.between((-x - 0.1, fat * 0.7, -0.4), (-x, 1.15, radius - ground), (0.07, 0.05), material=look.skin, mirror=True)
    if kit.chance(0.15):
        kit.add(BOX, (-x + 0.2, 1.15, radius - ground - 0.1), (0.9, 0.16, 0.05), (1.15, 1), (0.1, 0), material=look.metal, mirror=True)
    else:
        kit.add(CYL, (-x, 1.18, radius - ground), (radius, radius, radius * 0.4), rotation=ALONG_Y, material=look.rubber, mirror=True)
        if radius < 0.3 and kit.chance(0.35):
            kit.add(BALL, (-x - 0.05, 1.18, radius - ground + 0.06), (0.42, 0.16, 0.2), material=look.skin, mirror=True)
    if on_tail:
        wheel(kit, rear - 0.3, 0, 0.2, 0.1, look, 0.12)
        tilted(kit, start, np.degrees(np.arctan2(1.1, rear - 0.3 - x)))
    else:
        wheel(kit, 0.9, 0, ground, 0.2, look, -0.3)


def duster(kit):
    """Crop dusters: a long nose with the hopper, a humped cockpit high behind it, a low braced wing with spray booms, a tail wheel."""
    rng = kit.rng
    look = looks(kit, "gay")
    start, turbine = len(kit.primitives), kit.chance(0.6)
    if turbine:
        hull(kit, [(0.3, 0.05, 0.24, 0.26), (2.1, 0.02, 0.5, 0.55)], look.skin)
        kit.between((-1.0, 0.3, 0), (-1.9, 0.62, -0.1), 0.12, material=look.metal, mirror=True)
    else:
        hull(kit, [(0.5, 0, 0.58, 0.58), (1.4, 0, 0.6, 0.6), (2.1, 0, 0.5, 0.55)], look.trim)
        kit.add(CYL, (-0.5, 0, 0), (0.46, 0.46, 0.03), rotation=ALONG_X, material=look.dark)
    airscrew(kit, (-0.3 if turbine else -0.45, 0, 0.05 if turbine else 0), 1.4, look, 3, 0.24)
    hull(kit, [(2.0, 0, 0.52, 0.58), (5.2, 0.05, 0.5, 0.62), (9.6, 0.25, 0.1, 0.18)], look.skin, box=True)
    kit.add(BOX, (-3.0, 0, 0.62), (1.1, 0.45, 0.14), (0.85, 0.7), material=look.trim)
    kit.add(BOX, (-4.75, 0, 0.98), (0.75, 0.48, 0.45), (0.6, 0.72), (-0.08, 0), material=look.glass)
    kit.add(BOX, (-4.85, 0, 1.42), (0.46, 0.37, 0.05), material=look.skin)
    kit.add(BOX, (-5.9, 0, 0.78), (1.1, 0.4, 0.36), (0.35, 0.6), (0.6, 0), material=look.skin)
    half = rng.uniform(6.5, 8.5)
    wing = surface(kit, (3.1, 0.3, -0.5, 1.85, half, 0, 1.7, 3.5), look.skin, 0.14, True)
    surface(kit, (8.4, 0.05, 0.3, 1.25, 2.4, 4, 1.0, 0), look.trim, 0.08, True)
    surface(kit, (8.2, 0, 0.2, 1.5, 1.6, 20, 0.85, 90), look.trim, 0.08, True)
    kit.between(np.array([-8.9, 0.1, 0.05]) + [0, 0, 0.05], (-9.0, 1.5, 0.3), 0.035, material=look.metal, mirror=True)
    boom = on(wing, 0.0, -0.5)[0] - 0.25
    end = on(wing, 0.72)
    kit.between((boom, 0.2, -0.72), (boom, end[1], end[2] - 0.22), 0.045, material=look.metal, mirror=True)
    for share in (0.1, 0.38, 0.66):
        at = on(wing, share, -0.35)
        kit.between(at, (boom, at[1], at[2] - 0.22), 0.04, material=look.metal, mirror=True)
    if kit.chance(0.4):
        kit.between((-3.4, 0.42, 0.5), on(wing, 0.42), (0.06, 0.03), material=look.skin, mirror=True)
    kit.add(BOX, (-3.6, 0, -0.68), (0.5, 0.4, 0.16), (0.9, 0.8), material=look.metal)
    kit.between((-2.9, 0.4, -0.4), (-2.6, 1.35, -1.35), (0.09, 0.05), material=look.skin, mirror=True)
    kit.add(CYL, (-2.6, 1.4, -1.35), (0.37, 0.37, 0.14), rotation=ALONG_Y, material=look.rubber, mirror=True)
    wheel(kit, 9.0, 0, 0.28, 0.16, look, 0.15)
    kit.add(BOX, (-5.5, 0, 0.0), (2.2, 0.49, 0.1), (1, 0.98), material=look.trim)
    tilted(kit, start, 12.5)


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
    wing = surface(kit, (long * 0.38, 0.3, -fat * 0.75, half * 0.4, half, rng.uniform(8, 32) if not tanks else 12, half * 0.13 if not tanks else half * 0.2, 3.5), look.skin._replace(first=np.ones(3) * 0.55), 0.1)
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


def amphibian(kit):
    """Flying boats: the parasol patrol boat, the fire fighter, the twin with engines on a high wing, the light one with its propeller on a pylon."""
    rng = kit.rng
    kind = rng.choice(["parasol", "fire", "goose", "light"])
    look = looks(kit, "gay" if kind != "parasol" or kit.chance(0.4) else "grey")
    light = kind == "light"
    long, fat, tall = (7.8, 0.55, 0.5) if light else (19, 1.3, 1.3)
    hull(kit, [(0, 0.15, 0.15, 0.2), (long * 0.12, 0.05, fat * 0.75, tall * 0.75), (long * 0.3, 0, fat, tall), (long * 0.52, 0, fat, tall), (long, tall * 0.75, fat * 0.2, tall * 0.25)], look.skin, box=True)
    kit.add(BOX, (-long * 0.3, 0, -tall * 0.95), (long * 0.25, fat * 0.6, tall * 0.45), (1.15, 1.65), (0.1, 0), material=look.trim if kit.chance(0.6) else look.skin)
    high = {"parasol": tall * 2.1, "light": tall * 0.4}.get(kind, tall * 1.25)
    half = 5.5 if light else rng.uniform(14, 15.5)
    chord = half * rng.uniform(0.25, 0.29)
    x = long * (0.42 if light else 0.3)
    if light:
        kit.add(BALL, (-long * 0.28, 0, tall * 0.85), (1.15, fat * 0.88, 0.5), material=look.glass)
    else:
        cockpit(kit, long * 0.17, tall * 1.1, fat * 0.72, tall * 0.38, look, 1.2)
        kit.add(BOX, (-long * 0.4, 0, tall * 0.35), (long * 0.14, fat * 0.97, 0.2), material=ports(kit, 14))
    wing = surface(kit, (x, 0, high, chord, half, 2, chord * rng.uniform(0.55, 1), 2 if light else 0.5), look.skin, 0.14, True)
    if kind == "parasol":
        kit.add(BOX, (-x - chord * 0.5, 0, tall * 1.5), (1.5, 0.5, tall * 0.7), (0.8, 0.9), material=look.skin)
        for fore in (0.25, -0.25):
            kit.between((-x - chord * (0.5 - fore), fat * 0.9, tall * 0.3), on(wing, 0.35, fore), (0.14, 0.06), material=look.skin, mirror=True)
        kit.add(BALL, (-long * 0.62, fat * 0.75, tall * 0.55), (1.1, 0.6, 0.7), material=look.glass, mirror=True)
    elif not light:
        kit.add(BOX, (-x - chord * 0.5, 0, tall * 1.1), (chord * 0.6, fat * 0.7, tall * 0.25), (0.8, 0.7), material=look.skin)
    if light:
        kit.add(BOX, (-long * 0.52, 0, tall * 1.7), (0.35, 0.1, tall * 0.9), (0.8, 1), (-0.1, 0), material=look.skin)
        kit.add(BALL, (-long * 0.53, 0, tall * 2.6), (0.75, 0.28, 0.28), material=look.trim)
        airscrew(kit, (-long * 0.53 - 0.85, 0, tall * 2.6), 0.8, look, int(rng.choice([2, 3])), 0.12)
    else:
        share = 0.16 if kind == "parasol" else 0.23
        at = on(wing, share, 0.5)
        kit.between(at + [-2.6, 0, 0], at + [1.1, 0, 0], 0.75, taper=0.9, material=look.trim if kit.chance(0.4) else look.skin, mirror=True)
        kit.add(CYL, at + [1.1, 0, 0], (0.55, 0.55, 0.03), rotation=ALONG_X, material=look.dark, mirror=True)
        airscrew(kit, at + [1.15, 0, 0], 1.85, look, int(rng.choice([3, 4])), 0.26, True)
    fin = tall * (2.4 if not light else 2.6)
    surface(kit, (long - fin * 1.05, 0, tall * 0.7, fin * 1.05, fin, 25, fin * 0.6, 90), look.trim, 0.09)
    surface(kit, (long - fin * 0.75, 0, tall * 0.7 + fin * (0.45 if not light else 0.6), fin * 0.65, half * 0.33, 6, fin * 0.48, 0), look.skin, 0.09)
    at, size = on(wing, 0.78), 0.5 if light else 1
    low = -tall * 0.35 if not light else -0.1
    kit.add(BOX, at + [0, 0, (low - at[2]) / 2], (size * 0.25, 0.05, (at[2] - low) / 2), material=look.skin, mirror=True)
    kit.add(BALL, (at[0], at[1], low), (size * 1.5, size * 0.36, size * 0.36), material=look.trim, mirror=True)
    if kit.chance(0.45):
        radius = 0.2 if light else 0.5
        ground = tall * 1.4 + radius
        x = long * 0.5
        kit.between((-x, fat * 0.85, 0), (-x, fat * 1.35, radius - ground), radius * 0.25, material=look.metal, mirror=True)
        kit.add(CYL, (-x, fat * 1.4, radius - ground), (radius, radius, radius * 0.4), rotation=ALONG_Y, material=look.rubber, mirror=True)
        wheel(kit, long * 0.12, 0, ground, radius * 0.8, look, -tall * 0.3)
