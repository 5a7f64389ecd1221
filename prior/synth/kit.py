"""What objects are built from: convex primitives collected in object space (x forward, y left, z up, about metres)."""

from typing import NamedTuple

import numpy as np

from .layout import BALL, BARS, BOX, CYL, SOLID
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
    cut: tuple = (SOLID, 1.0, 1.0)  # what is cut out, bars per unit length, share that stays
    bevel: float = 0.0  # a box's rounded edges, as `layout.BEVEL` has them
    subject: bool = True  # or something that it sits on, which no mask of it has


class Kit:
    """Collects primitives. Every random draw of an object comes from `rng`, in a fixed order."""

    def __init__(self, rng):
        self.rng = rng
        self.primitives = []
        self.bevel = 0.0 if rng.random() < 0.35 else rng.uniform(0.1, 0.7)

    def add(
        self,
        kind,
        centre,
        half,
        taper=(1, 1),
        shift=(0, 0),
        rotation=None,
        material=None,
        mirror=False,
        cut=(SOLID, 1.0, 1.0),
    ):
        """Add a primitive, with `mirror` also its twin across the plane y = 0. No material: a random one."""
        rotation = np.eye(3) if rotation is None else rotation
        centre = np.array(centre, float)
        half = np.maximum(np.array(half, float), 1e-3)
        material = material or self.material()
        made = Primitive(kind, centre, half, taper, shift, rotation, material, cut, self.bevel)
        self.primitives += [made, mirrored(made)] if mirror else [made]

    def only_carries(self, since):
        """What was added after the first `since` primitives is not of the subject, but what it sits on."""
        self.primitives[since:] = [p._replace(subject=False) for p in self.primitives[since:]]

    def material(self, base=None, dark=False, pattern=None, frequency=None, gloss=None, second=None):
        """A random material with whatever is given fixed; colours in linear light."""
        made = draw_material(self.rng, base, dark)
        if pattern is not None:
            made = made._replace(pattern=int(pattern))
        if frequency is not None:
            made = made._replace(frequency=float(frequency))
        if gloss is not None:
            made = made._replace(gloss=float(gloss))
        if second is not None:
            made = made._replace(second=np.array(second, float))
        return made

    def chance(self, probability):
        return self.rng.random() < probability

    def between(self, start, end, radius, kind=CYL, taper=1.0, material=None, mirror=False, cut=(SOLID, 1.0, 1.0)):
        """A bar from start to end; radius: one half width or two, along the bar's own x and y."""
        start, end = np.array(start, float), np.array(end, float)
        half_x, half_y = np.broadcast_to(np.array(radius, float), 2)
        half = (half_x, half_y, np.linalg.norm(end - start) / 2)
        taper = (taper, taper if kind == BOX else 1)
        self.add(kind, (start + end) / 2, half, taper, (0, 0), towards(end - start), material, mirror, cut)

    def chain(self, points, radii, material=None, mirror=False, joints=True):
        """Rounded limbs through points [[3], ...] of the given radii (one, or one a point)."""
        material = material or self.material()
        radii = np.broadcast_to(np.array(radii, float), len(points))
        for i, (start, end) in enumerate(zip(points[:-1], points[1:], strict=True)):
            self.between(start, end, radii[i], CYL, radii[i + 1] / radii[i], material, mirror)
        if joints:
            for point, radius in zip(points[1:], radii[1:], strict=True):
                self.add(BALL, point, (radius,) * 3, material=material, mirror=mirror)

    def loft(self, base, profile, material=None, kind=CYL, axis=None, flat=1.0, sides=1):
        """A stack of frusta along local z from `base`: profile [(height, radius), ...] with heights growing.

        axis: rotation of the stack; flat: the second radius over the first; sides: of a PRISM.
        """
        material = material or self.material()
        axis = np.eye(3) if axis is None else axis
        for (z0, r0), (z1, r1) in zip(profile[:-1], profile[1:], strict=True):
            if z1 - z0 < 1e-4:
                continue
            r0 = max(r0, 1e-3)
            centre = np.array(base, float) + axis @ np.array([0, 0, (z0 + z1) / 2])
            ratio = max(r1 / r0, 0.01)
            taper = (ratio, sides) if kind != BOX else (ratio, ratio)
            self.add(kind, centre, (r0, r0 * flat, (z1 - z0) / 2), taper, (0, 0), axis, material)

    def railing(self, start, end, height, material, spacing=0.15, kind=BARS, thick=0.02):
        """A thin upright panel of bars from start to end (both at its foot)."""
        start, end = np.array(start, float), np.array(end, float)
        along = end - start
        middle = (start + end) / 2 + np.array([0, 0, height / 2])
        flat = np.hypot(along[0], along[1])
        spin = turn("z", np.degrees(np.arctan2(along[1], along[0])))
        half = (flat / 2, thick, height / 2)
        share = self.rng.uniform(0.25, 0.55)
        self.add(BOX, middle, half, rotation=spin, material=material, cut=(kind, 1 / spacing, share))


def mirrored(p):
    """The primitive's twin across the plane y = 0."""
    flip = np.diag([1.0, -1, 1])
    return p._replace(centre=flip @ p.centre, shift=(p.shift[0], -p.shift[1]), rotation=flip @ p.rotation @ flip)


def towards(direction):
    """Rotation whose local z points along `direction` [3]; local x lies level where it can."""
    z = direction / max(np.linalg.norm(direction), 1e-9)
    side = np.cross([0.0, 0, 1], z)
    if np.linalg.norm(side) < 1e-6:
        side = np.array([0.0, 1, 0])
    y = side / np.linalg.norm(side)
    return np.stack([np.cross(y, z), y, z], 1)


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


def around(count, radius, first=0.0):
    """`count` points [(x, y), ...] on a circle, from the angle `first` in degrees."""
    angles = np.radians(first) + 2 * np.pi * np.arange(count) / count
    return [(radius * np.cos(a), radius * np.sin(a)) for a in angles]


# Turn a cylinder's axis (local z) along object y or x.
ALONG_Y = turn("x", 90)
ALONG_X = turn("y", 90)
