"""What makes two objects of one maker differ beyond its own draws: proportions that change along the object, and small things on it."""

import numpy as np

from .extent import bounds
from .kit import ALONG_X, ALONG_Y, Primitive, mirrored, turn
from .layout import BALL, BOX, CYL, SOLID

# Slopes of the maps along x (forward), y (left) and z (up) differ from their mean by up to so much.
UNEVEN = (0.4, 0.35, 0.4)
# Standard deviation of the logarithm of each axis' mean slope.
STRETCH = 0.14
# Small things on one side of an object, at most; and the logarithms of their half sizes over half the diagonal of its box.
EXTRAS = 6
EXTRA_SIZE = np.log((0.009, 0.078))


class Warp:
    """A growing map of each axis, odd along y, so that what is symmetric stays so and what touches goes on touching."""

    def __init__(self, low, high, rng):
        self.middle = (low + high) / 2 * (1, 0, 1)
        self.reach = np.maximum(np.maximum(high - self.middle, self.middle - low), 1e-3)
        self.mean = np.exp(STRETCH * rng.normal(size=3))
        self.uneven = rng.uniform(-1, 1, 3) * UNEVEN
        self.phase = rng.uniform(0, 2 * np.pi, 3) * (1, 0, 1)

    def __call__(self, point):
        """Where `point` [3] goes. The slope at a distance of t reaches from the middle is mean (1 + uneven cos(pi t + phase))."""
        t = (np.asarray(point) - self.middle) / self.reach
        ripple = self.uneven * (np.sin(np.pi * t + self.phase) - np.sin(self.phase)) / np.pi
        return self.middle + self.reach * self.mean * (t + ripple)


def reshaped(primitives, warp):
    """The same object with other proportions. What is long turns as its ends go; wheels stay round."""
    return [moved(p, warp) for p in primitives]


def moved(p, warp):
    """The primitive where `warp` takes it: its longest axis from end to end, the others stretched as what it spans is."""
    begin, end = bounds([p])
    end = np.maximum(end, begin + 1e-6)
    low, high = warp(begin), warp(end)
    stretch = (high - low) / (end - begin)
    along = np.linalg.norm(stretch[:, None] * p.rotation, axis=0)
    longest = int(p.half.argmax())
    axis = p.rotation[:, longest] * p.half[longest]
    after = warp(p.centre + axis) - warp(p.centre - axis)
    half = p.half * along
    half[longest] = np.linalg.norm(after) / 2
    rotation = p.rotation
    if p.kind == CYL and abs(p.rotation[2, 2]) < 0.1 and p.half[2] < p.half[:2].min():
        half[:2] = p.half[:2] * stretch[2]
    elif p.kind != BALL:
        rotation = turned(axis, after) @ p.rotation
    shift = (p.shift[0] * half[0] / p.half[0], p.shift[1] * half[1] / p.half[1])
    return p._replace(centre=low + (p.centre - begin) * stretch, half=half, shift=shift, rotation=rotation)


def turned(before, after):
    """The smallest rotation [3, 3] that takes the direction of `before` [3] to that of `after` (Rodrigues' formula)."""
    a, b = before / np.linalg.norm(before), after / np.linalg.norm(after)
    x, y, z = np.cross(a, b)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + cross + cross @ cross / (1 + a @ b)


def adorned(primitives, low, high, room, rng, material):
    """The same object with up to `room` small boxes, knobs, rods and discs on its faces, most of them on both sides of it.

    material: called without arguments, a new one.
    """
    size = np.linalg.norm(high - low) / 2
    look = material()
    extras = []
    for _ in range(rng.integers(1, EXTRAS + 1)):
        host = primitives[rng.integers(len(primitives))]
        if host.half.max() < 0.1 * size or host.cut[0] != SOLID:
            continue
        if rng.random() < 0.4:
            look = host.material if rng.random() < 0.4 else material()
        face = int(rng.integers(3))
        place = rng.uniform(-0.85, 0.85, 3)
        place[face] = rng.choice([-1, 1])
        if host.kind == BALL:
            place /= np.linalg.norm(place)
        elif host.kind == CYL and face < 2:
            place[:2] /= np.linalg.norm(place[:2])
        centre = host.centre + host.rotation @ (place * host.half)
        half = np.exp(rng.uniform(*EXTRA_SIZE, 3)) * size
        extra = thing(centre, half, size, rng, look, host.bevel)
        extras.append(extra)
        if abs(centre[1]) > half[1] and rng.random() < 0.75:
            extras.append(mirrored(extra))
    return primitives + extras[:room]


def thing(centre, half, size, rng, look, bevel):
    """A small box, knob, upright rod or disc at `centre`."""
    kind = rng.choice(["box", "knob", "rod", "disc"], p=[0.55, 0.17, 0.1, 0.18])
    if kind == "rod":
        high = size * np.exp(rng.uniform(-2.6, -1.0))
        thin = size * rng.uniform(0.006, 0.02)
        return Primitive(CYL, centre + (0, 0, high * 0.9), np.array([thin, thin, high]), (1, 1), (0, 0), np.eye(3), look)
    if kind == "disc":
        around = ALONG_X if rng.random() < 0.5 else ALONG_Y
        return Primitive(CYL, centre, np.array([half[0], half[0], min(half) * 0.7]), (1, 1), (0, 0), around, look)
    if kind == "knob":
        return Primitive(BALL, centre, half, (1, 1), (0, 0), np.eye(3), look)
    spin = turn("z", rng.uniform(0, 360)) if rng.random() < 0.2 else np.eye(3)
    return Primitive(BOX, centre, half, (rng.uniform(0.7, 1), rng.uniform(0.7, 1)), (0, 0), spin, look, bevel=bevel)
