"""Procedural materials: two linear colours mixed by a pattern in the primitive's own frame."""

import math
from typing import NamedTuple

import numpy as np

PLAIN, CLOUDY, BANDS, WINDOWS, CHECKER, CAMOUFLAGE, SEAMS, WAVES = range(8)
PATTERN_CHANCES = [0.3, 0.22, 0.08, 0.06, 0.06, 0.1, 0.1, 0.08]


class Material(NamedTuple):
    """What a primitive looks like; fields in the order of the primitive row's columns 20 to 30."""

    first: np.ndarray  # [3], linear light
    second: np.ndarray  # [3]
    pattern: int
    frequency: float  # per unit of the normalised object
    gloss: float  # strength of the highlight, 0..0.64
    shininess: float  # its exponent
    offset: float  # where in the pattern the primitive lies


def draw_material(rng, base=None, dark=False):
    """A random material; `base` [3] fixes the first colour, `dark` keeps it near black (rubber, iron)."""
    if base is None:
        base = draw_colour(rng, dark)
    second = np.clip(base * rng.uniform(0.3, 1.6) + rng.normal(0, 0.06, 3), 0.01, 0.99)
    return Material(
        first=base,
        second=second,
        pattern=int(rng.choice(8, p=PATTERN_CHANCES)),
        frequency=math.exp(rng.uniform(0.5, 3.2)),
        gloss=rng.uniform(0, 0.8) ** 2,
        shininess=rng.uniform(4, 80),
        offset=rng.uniform(0, 100),
    )


def draw_colour(rng, dark):
    """A grey level and a departure from grey that is mostly small."""
    grey = rng.uniform(0.02, 0.15) if dark else rng.beta(1.6, 1.6)
    tint = rng.normal(0, 1, 3)
    return np.clip(grey + tint * rng.choice([0.02, 0.08, 0.3], p=[0.4, 0.35, 0.25]), 0.01, 0.99)
