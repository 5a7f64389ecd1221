"""Procedural materials: two linear colours mixed by a pattern in the primitive's own frame."""

import math
from typing import NamedTuple

import numpy as np

PLAIN, CLOUDY, BANDS, WINDOWS, CHECKER, CAMOUFLAGE, SEAMS, WAVES, BRICKS, SHINGLES = range(10)
PLANKS, STRIPES, DOTS, STREAKS, WRITING, FACADE, PATCHWORK, SPECKLES, RIBS, LEDGES = range(10, 20)
PATTERN_CHANCES = np.array([34, 16, 3, 2, 2, 3, 5, 4, 2, 2, 4, 3, 1.5, 7, 2.5, 1, 1.5, 3, 2.5, 1])


class Material(NamedTuple):
    """What a primitive looks like; fields in the order of the primitive row's columns 20 to 30."""

    first: np.ndarray  # [3], linear light
    second: np.ndarray  # [3]
    pattern: int
    frequency: float  # per unit of the normalised object
    gloss: float  # strength of the highlight, 0..0.64; negative: light of its own
    shininess: float  # its exponent
    offset: float  # where in the pattern the primitive lies


def draw_material(rng, base=None, dark=False):
    """A random material; `base` [3] fixes the first colour, `dark` keeps it near black (rubber, iron)."""
    if base is None:
        base = draw_colour(rng, dark)
    base = np.clip(np.array(base, float), 0.01, 0.99)
    if rng.random() < 0.25:  # another paint altogether
        second = draw_colour(rng, dark)
    else:
        second = np.clip(base * rng.uniform(0.3, 1.6) + rng.normal(0, 0.06, 3), 0.01, 0.99)
    return Material(
        first=base,
        second=second,
        pattern=int(rng.choice(len(PATTERN_CHANCES), p=PATTERN_CHANCES / PATTERN_CHANCES.sum())),
        frequency=math.exp(rng.uniform(0.5, 3.2)),
        gloss=rng.uniform(0, 0.8) ** 2,
        shininess=rng.uniform(4, 80),
        offset=rng.uniform(0, 100),
    )


def draw_colour(rng, dark):
    """Near grey, or a paint of some hue; `dark`: near black."""
    if dark:
        return np.clip(rng.uniform(0.015, 0.12) + rng.normal(0, 0.015, 3), 0.01, 0.99)
    if rng.random() < 0.3:
        return paint(rng.random(), rng.uniform(0.4, 1), rng.uniform(0.05, 0.9))
    grey = rng.beta(1.3, 1.6)
    tint = rng.normal(0, 1, 3)
    return np.clip(grey + tint * rng.choice([0.02, 0.08, 0.3], p=[0.45, 0.35, 0.2]), 0.01, 0.99)


def paint(hue, saturation, value):
    """Linear colour [3] of a hue 0..1, as in HSV."""
    angle = (hue * 6 + np.array([0, 4, 2])) % 6
    ramp = np.clip(np.abs(angle - 3) - 1, 0, 1)
    return np.clip(value * (1 - saturation + saturation * ramp), 0.01, 0.99)
