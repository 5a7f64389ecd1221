"""A seed becomes an object: one maker's primitives, stretched, centred and scaled to a bounding box of diagonal 2."""

import numpy as np

from .buildings import house, mast, store, tower
from .craft import helicopter, plane, ship
from .kit import Kit, turn
from .layout import BOX, FLOATS, PRIMS
from .things import figure, furniture, kitbash, plant, ware
from .vehicles import bike, bus, car, tank, truck

# How often each kind of object is made, relative to the others.
MAKERS = [
    (car, 16),
    (truck, 9),
    (bus, 7),
    (bike, 5),
    (tank, 8),
    (plane, 13),
    (helicopter, 8),
    (ship, 5),
    (house, 13),
    (tower, 8),
    (store, 7),
    (plant, 5),
    (figure, 6),
    (ware, 6),
    (furniture, 4),
    (mast, 4),
    (kitbash, 9),
]


def make_object(seed):
    """One object: primitive rows float32 [PRIMS, FLOATS], how many are used, and the height of its ground.

    The bounding box is centred on the origin; lengths are in units of half its diagonal.
    """
    rng = np.random.default_rng(seed)
    kit = Kit(rng)
    draw_maker(rng)(kit)
    primitives = kit.primitives[:PRIMS]
    # Only the centres are stretched: gaps and overlaps vary, the primitives stay what they are.
    stretch = draw_stretch(rng)
    low, high = bounds(primitives, stretch)
    centre = (low + high) / 2
    scale = 1 / (np.linalg.norm(high - low) / 2)
    spin = turn("z", rng.uniform(0, 360) if rng.random() < 0.3 else 0)
    rows = np.zeros((PRIMS, FLOATS), np.float32)
    for i, primitive in enumerate(primitives):
        place = spin @ ((stretch @ primitive.centre - centre) * scale)
        rows[i] = row(primitive, place, spin @ primitive.rotation, scale)
    return rows, len(primitives), (low - centre)[2] * scale


def draw_maker(rng):
    weights = np.array([weight for _, weight in MAKERS], float)
    return MAKERS[rng.choice(len(MAKERS), p=weights / weights.sum())][0]


def draw_stretch(rng):
    if rng.random() < 0.5:
        return np.diag([rng.uniform(0.8, 1.25), rng.uniform(0.85, 1.18), rng.uniform(0.8, 1.25)])
    return np.eye(3)


def bounds(primitives, stretch):
    """Lowest and highest corner, [3] each, of a box that holds all primitives."""
    low = np.full(3, 1e9)
    high = np.full(3, -1e9)
    for p in primitives:
        lean = [abs(p.shift[0]) / p.half[0], abs(p.shift[1]) / p.half[1]] if p.kind == BOX else [0, 0]
        reach = np.array([max(1, p.taper[0]) + lean[0], max(1, p.taper[1]) + lean[1], 1])
        extent = np.abs(p.rotation) @ (p.half * reach)
        low = np.minimum(low, stretch @ p.centre - extent)
        high = np.maximum(high, stretch @ p.centre + extent)
    return low, high


def row(primitive, centre, rotation, scale):
    """The primitive's row as `layout` describes it; the last column says that it belongs to the subject."""
    kind, _, half, taper, shift, _, material = primitive
    shape = [kind, *centre, *rotation.T.ravel(), *(half * scale), *taper, shift[0] * scale, shift[1] * scale]
    look = [*material.first, *material.second, *material[2:]]
    return np.array([*shape, *look, 1])
