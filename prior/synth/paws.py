"""Legs of four-legged animals down to their paws, hooves or pads."""

import numpy as np

from .animals import BLACK, DARK, fur
from .kit import towards
from .layout import BALL, CYL
from .materials import PLAIN


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
