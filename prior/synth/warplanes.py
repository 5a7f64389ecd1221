"""A maker of aeroplanes by their real types; drawn here: fighters, attack aircraft, trainers."""

import numpy as np

from .airframes import airscrew, canopy_frames, hull, looks, on, roundels, surface, wheel
from .airliners import big_delta, big_jet, business_jet, jet_transport, propeller_transport, radar_aeroplane
from .bush_planes import amphibian, bush_plane, duster
from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, PLAIN
from .warbirds import piston_bomber, piston_fighter, twin_boom

# Along x all types are given in metres behind their nose, up from the body's axis. hull: (x, z, half width, half height).
# panels: (x of the leading edge, y, z at the root, chord, span, sweep of the leading edge, chord at the tip, degrees up), the wing first.
# intakes: (front, rear, y, z, half width, half height, rake). nozzles: (front, y, z, radius, length). canopy: (x, z, half sizes).
# gear: (nose wheel, main wheels, y, height of the axis over the ground, radius of the wheels).
FIGHTERS = {
    "falcon": {
        "hull": [(0, 0, 0.06, 0.06), (1.6, 0.02, 0.42, 0.4), (3.2, 0.08, 0.55, 0.6), (5.5, 0.1, 0.68, 0.75), (9.5, 0.02, 0.8, 0.75), (13.3, 0.05, 0.6, 0.6)],
        "panels": [
            (6.2, 0.7, 0.05, 4.4, 3.9, 40, 1.1, 0),
            (11.3, 0.6, 0, 2.3, 2.1, 40, 0.75, -8),
            (9.6, 0, 0.5, 3.4, 2.75, 47, 1.3, 90),
            (3.9, 0.35, 0.05, 4, 0.75, 72, 1.6, 0),
            (10.6, 0.45, -0.5, 1.3, 0.8, 35, 0.8, -68),
        ],
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
        "panels": [
            (8.5, 1.1, 0.4, 4.1, 4.5, 26, 1.7, -2),
            (13.4, 1.0, -0.1, 2.5, 2.4, 46, 0.9, -2),
            (10.2, 0.85, 0.15, 2.9, 3, 42, 1.1, 70),
            (4.3, 0.5, 0.42, 5.5, 0.85, 75, 2.4, 0),
        ],
        "intakes": [(8.0, 14, 1.0, -0.25, 0.42, 0.5, 0.25)],
        "nozzles": [(15.2, 0.52, 0, 0.5, 1.4)],
        "canopy": (4.6, 0.65, 1.8, 0.45, 0.58),
        "gear": (4.8, 9.9, 1.5, 1.95, 0.38),
        "tips": True,
    },
    "flanker": {
        "hull": [
            (0, -0.45, 0.06, 0.06),
            (2.5, -0.2, 0.55, 0.55),
            (5, 0.15, 0.75, 0.85),
            (8.5, 0.35, 0.85, 0.8),
            (12, 0.25, 0.9, 0.5),
            (17, 0.05, 0.45, 0.3),
            (21.5, 0.05, 0.2, 0.2),
        ],
        "panels": [
            (9.4, 1.9, 0.1, 5.6, 5.3, 42, 1.7, -1),
            (16.3, 2.0, -0.1, 3.4, 2.7, 45, 1.3, 0),
            (14, 1.95, 0.1, 3.6, 3.4, 40, 1.5, 90),
            (5.5, 0.6, 0.15, 8, 1.5, 68, 4.5, 0),
        ],
        "intakes": [(9.2, 15.5, 1.25, -0.75, 0.55, 0.62, 0.9)],
        "nozzles": [(15.2, 1.25, -0.45, 0.72, 4.2)],
        "canopy": (5.4, 0.85, 1.9, 0.5, 0.65),
        "gear": (6.5, 12, 1.9, 2.5, 0.5),
        "booms": (9.5, 18.2, 1.75, 0.02, 0.4, 0.22),
        "tips": True,
    },
    "fulcrum": {
        "hull": [(0, -0.35, 0.06, 0.06), (2, -0.15, 0.5, 0.5), (4, 0.1, 0.65, 0.75), (7, 0.25, 0.75, 0.7), (10, 0.2, 0.85, 0.5), (15.5, 0, 0.3, 0.22)],
        "panels": [
            (7.5, 1.5, 0.1, 4.5, 4.1, 42, 1.4, -2),
            (12.6, 1.6, -0.05, 2.8, 2.2, 50, 1.0, -3),
            (10.6, 1.5, 0.1, 3.3, 2.7, 47, 1.1, 83),
            (4.4, 0.5, 0.15, 7, 1.15, 71, 3.4, 0),
        ],
        "intakes": [(6.7, 13, 0.98, -0.6, 0.42, 0.5, 0.9)],
        "nozzles": [(12.5, 0.98, -0.35, 0.56, 3.4)],
        "canopy": (4.4, 0.7, 1.6, 0.45, 0.58),
        "gear": (5.3, 9.2, 1.5, 2.0, 0.4),
        "booms": (7.6, 14.4, 1.35, 0.02, 0.32, 0.2),
    },
    "raptor": {
        "hull": [(0, 0, 0.08, 0.04), (2.6, 0.02, 0.65, 0.5), (5.5, 0.1, 0.95, 0.75), (9, 0.12, 1.5, 0.65), (13, 0.1, 1.6, 0.55), (17, 0.05, 1.3, 0.3)],
        "panels": [
            (7.2, 1.5, 0.25, 8.4, 5.2, 42, 1.6, -3),
            (14.2, 1.6, 0.1, 3.8, 2.7, 42, 1.0, 0),
            (12, 1.55, 0.35, 3.8, 2.9, 24, 1.5, 62),
            (3, 0.5, 0.15, 6, 1.1, 72, 3.5, 0),
        ],
        "intakes": [(6.3, 12.5, 1.2, -0.18, 0.52, 0.5, -0.5)],
        "nozzles": [(15.8, 0.75, 0.05, 0.5, 1.9)],
        "canopy": (4.9, 0.6, 1.9, 0.5, 0.7),
        "gear": (6, 11, 1.6, 1.95, 0.45),
        "box": True,
    },
    "lightning": {
        "hull": [(0, -0.05, 0.08, 0.05), (2.2, 0, 0.6, 0.5), (4.5, 0.1, 0.85, 0.8), (8, 0.1, 1.25, 0.75), (11, 0.1, 1.25, 0.7), (13.8, 0.05, 0.85, 0.62)],
        "panels": [
            (6.3, 1.2, 0.25, 5.8, 4.1, 34, 1.3, -1),
            (11.6, 1.1, 0.05, 3.2, 2.5, 34, 1.0, 0),
            (10.2, 1.1, 0.4, 3.1, 2.4, 32, 1.3, 66),
            (2.8, 0.5, 0.2, 5, 0.85, 72, 3.2, 0),
        ],
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
        "panels": [
            (6.8, 1.1, -0.55, 6.5, 3.0, 51, 3.4, 0),
            (10.5, 4.1, -0.55, 3.4, 1.6, 51, 1.4, 12),
            (14.9, 0.3, 0.45, 2.6, 2.5, 40, 0.9, -23),
            (13.2, 0, 0.7, 3.6, 1.9, 58, 1.4, 90),
        ],
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
        "panels": [
            (5.2, 0.5, 0.7, 3.6, 4.1, 38, 1.2, -12),
            (11.3, 0.2, 0.35, 1.8, 2.0, 38, 0.7, -15),
            (10.2, 0, 0.4, 2.4, 1.7, 40, 0.9, 90),
            (11, 0, 0.1, 1.3, 0.6, 20, 0.8, -90),
        ],
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
    """Fighters of all ages and makes, attack and training jets, transports, bombers, radar and tanker aircraft, bush planes, dusters, business jets, airliners,
    amphibians."""
    kinds = [combat_jet, tank_killer, propeller_transport, jet_transport, radar_aeroplane, big_jet, big_delta, turbo_trainer, piston_fighter, piston_bomber]
    kinds += [twin_boom, bush_plane, duster, business_jet, amphibian]
    chances = np.array([38, 5, 6, 5, 4, 8, 3, 5, 10, 8, 2, 7, 3, 5, 5], float)
    kinds[kit.rng.choice(len(kinds), p=chances / chances.sum())](kit)


def tricycle(kit, row, look, top=-0.2):
    """A nose wheel and two main ones with their doors."""
    nose, main, y, ground, radius = row
    wheel(kit, nose, 0, ground, radius * 0.75, look, top)
    wheel(kit, main, y, ground, radius, look, top, inner=y * 0.6)
    kit.add(BOX, (-nose, radius * 0.6, -0.15 - ground * 0.34), (radius * 0.9, 0.02, ground * 0.34 - 0.15), material=look.skin, mirror=True)


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
            kit.add(
                BOX,
                (-front - rake * 0.93 - (0.02 if rake > 0 else -0.02 + rake * 0.06), y, z),
                (0.06, wide * 0.84, high * 0.86),
                shift=(rake * 0.86, 0),
                material=look.dark,
                mirror=y > 0,
            )
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
