"""How far primitives reach: the box around them."""

import numpy as np

from .layout import BALL, BOX, PRISM

# All around, for `superellipsoid`: the corners and edges of a cube, where it bends most, and what lies between.
DIRECTIONS = np.array([d for d in np.ndindex(9, 9, 9) if 0 in d or 8 in d]) / 4.0 - 1


def bounds(primitives):
    """Lowest and highest corner, [3] each, of the box around all primitives."""
    low = np.full(3, 1e9)
    high = np.full(3, -1e9)
    for p in primitives:
        for end, reach in outline(p):
            place = p.centre + p.rotation @ end
            low = np.minimum(low, place - reach)
            high = np.maximum(high, place + reach)
    return low, high


def outline(p):
    """Points [3] of the primitive's own frame with what lies around each, [3] along the object's axes, that span it."""
    axes = p.rotation * p.half
    if p.kind == BALL:
        return [(np.zeros(3), np.linalg.norm(axes, axis=1))]
    bottom, top = -p.half[2], p.half[2]
    if p.kind == BOX and p.bevel > 1:
        around = superellipsoid(p) @ p.rotation.T
        low, high = around.min(0), around.max(0)
        return [(p.rotation.T @ ((low + high) / 2), (high - low) / 2)]
    if p.kind == BOX:
        wide = np.abs(p.rotation[:, 0]) * p.half[0], np.abs(p.rotation[:, 1]) * p.half[1]
        above = wide[0] * p.taper[0] + wide[1] * p.taper[1]
        return [(np.array([0, 0, bottom]), wide[0] + wide[1]), (np.array([*p.shift, top]), above)]
    # A prism's corners lie outside the circle of its sides' middles.
    wide = np.hypot(axes[:, 0], axes[:, 1]) / (np.cos(np.pi / p.taper[1]) if p.kind == PRISM else 1)
    return [(np.array([0, 0, bottom]), wide), (np.array([0, 0, top]), wide * p.taper[0])]


def superellipsoid(p):
    """Points [n, 3] all over the superellipsoid in the box `p`, in its own frame."""
    on = DIRECTIONS / (np.abs(DIRECTIONS) ** p.bevel).sum(1, keepdims=True) ** (1 / p.bevel)
    k = 0.5 + 0.5 * on[:, 2]
    across = [on[:, i] * p.half[i] * (1 + (p.taper[i] - 1) * k) + p.shift[i] * k for i in range(2)]
    return np.stack([*across, on[:, 2] * p.half[2]], 1)
