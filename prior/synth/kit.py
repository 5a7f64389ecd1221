"""What objects are built from: convex primitives collected in object space (x forward, y left, z up, about metres)."""

from typing import NamedTuple

import numpy as np

from .materials import Material, draw_material


class Primitive(NamedTuple):
    """One convex primitive; lengths in object units."""

    kind: int
    centre: np.ndarray  # [3]
    half: np.ndarray  # [3], half sizes along the local axes
    taper: tuple  # top size over bottom size, local x and y
    shift: tuple  # top centre against bottom centre, local x and y
    rotation: np.ndarray  # [3, 3], columns are the local axes in object space
    material: Material


class Kit:
    """Collects primitives. Every random draw of an object comes from `rng`, in a fixed order."""

    def __init__(self, rng):
        self.rng = rng
        self.primitives = []

    def add(self, kind, centre, half, taper=(1, 1), shift=(0, 0), rotation=None, material=None, mirror=False):
        """Add a primitive, with `mirror` also its twin across the plane y = 0. No material: a random one."""
        rotation = np.eye(3) if rotation is None else rotation
        centre = np.array(centre, float)
        half = np.array(half, float)
        material = material or self.material()
        self.primitives.append(Primitive(kind, centre, half, taper, shift, rotation, material))
        if mirror:
            flip = np.diag([1.0, -1, 1])
            twin_shift = (shift[0], -shift[1])
            twin_rotation = flip @ rotation @ flip
            self.primitives.append(Primitive(kind, flip @ centre, half, taper, twin_shift, twin_rotation, material))

    def material(self, base=None, dark=False):
        return draw_material(self.rng, base, dark)


def turn(axis, degrees):
    """Rotation matrix [3, 3] about the axis named "x", "y" or "z"."""
    angle = np.radians(degrees)
    c, s = np.cos(angle), np.sin(angle)
    i = "xyz".index(axis)
    j, k = (i + 1) % 3, (i + 2) % 3
    matrix = np.eye(3)
    matrix[j, j] = c
    matrix[k, k] = c
    matrix[j, k] = -s
    matrix[k, j] = s
    return matrix


# Turn a cylinder's axis (local z) along object y or x.
ALONG_Y = turn("x", 90)
ALONG_X = turn("y", 90)
