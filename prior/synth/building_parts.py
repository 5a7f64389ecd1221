"""What open and public buildings share: paints and materials, posts, steps, arched roofs, rafters, benches, walls pierced by windows."""

import numpy as np

from .dwellings import CONCRETE, GREEN, GREY, LEAF, OCHRE, STONE, TIMBER, WHITE, WOOD
from .installations import tinted
from .kit import turn
from .layout import BARS, BOX
from .materials import CLOUDY, PLAIN, PLANKS, SEAMS, STREAKS, STRIPES, WRITING


def timberwork(kit):
    return tinted(kit, (WOOD, WOOD, TIMBER, WHITE, OCHRE, GREY, GREEN), (PLANKS, STREAKS, PLAIN), frequency=kit.rng.uniform(8, 22), gloss=0.03)


def vivid(kit, patterns=(PLAIN,), **fixed):
    return tinted(kit, ((0.6, 0.04, 0.03), (0.04, 0.15, 0.5), (0.75, 0.45, 0.03), (0.05, 0.35, 0.12), (0.7, 0.2, 0.03), (0.1, 0.4, 0.5)), patterns, **{"gloss": 0.15, **fixed})


def striped(kit):
    return vivid(kit, (STRIPES,), frequency=kit.rng.uniform(8, 18), second=(0.75, 0.74, 0.68), gloss=0.02)


def paving(kit):
    return tinted(kit, (CONCRETE, GREY, STONE), (CLOUDY, SEAMS, PLAIN), frequency=12, gloss=0.0)


def greens(kit):
    base = np.array(LEAF) * kit.rng.uniform(0.7, 2.2)
    return kit.material(base=base, second=base * 2.2, pattern=CLOUDY, frequency=22, gloss=0.0)


def lettered(kit):
    base, second = [
        ((0.75, 0.74, 0.7), (0.05, 0.05, 0.2)),
        ((0.05, 0.08, 0.3), (0.75, 0.75, 0.7)),
        ((0.5, 0.03, 0.03), (0.8, 0.78, 0.7)),
        ((0.05, 0.2, 0.1), (0.8, 0.7, 0.3)),
    ][kit.rng.integers(4)]
    return kit.material(base=base, second=second, pattern=WRITING, frequency=kit.rng.uniform(14, 24), gloss=0.1)


def slab(kit, x, y, z, half, material, **more):
    """A box that stands on z."""
    kit.add(BOX, (x, y, z + half[2]), half, material=material, **more)


def posts(kit, xs, ys, low, high, r, material, kind=BOX):
    for x in xs:
        for y in ys:
            kit.add(kind, (x, y, (low + high) / 2), (r, r, (high - low) / 2), material=material)


def flight(kit, x, y, high, wide, material, count=4, way=1, deep=0.3, axis=0):
    """Steps that rise to a wall at `x` (axis 0) or `y` (axis 1) from the side `way`."""
    for k in range(count):
        run = deep * (count - k) / 2
        spot = (x + way * run, y) if axis == 0 else (x, y + way * run)
        half = (run, wide) if axis == 0 else (wide, run)
        slab(kit, *spot, 0, (*half, high * (k + 1) / count / 2), material)


def barrel(kit, x, z, long, wide, rise, count, material, thick=0.06):
    """An arched roof along x on walls at y = +-`wide`, of `count` flat pieces."""
    angles = np.linspace(0, np.pi, count + 1)
    for a, b in zip(angles[:-1], angles[1:], strict=True):
        y0, z0, y1, z1 = wide * np.cos(a), rise * np.sin(a), wide * np.cos(b), rise * np.sin(b)
        spin = turn("x", np.degrees(np.arctan2(z1 - z0, y1 - y0)))
        kit.add(BOX, (x, (y0 + y1) / 2, z + (z0 + z1) / 2), (long, np.hypot(y1 - y0, z1 - z0) / 2 + thick, thick), rotation=spin, material=material)


def rafters(kit, x, half, z, rise, r, material, post=True):
    """A tie, two rafters and a king post across y."""
    kit.between((x, -half, z), (x, half, z), r, BOX, material=material)
    kit.between((x, half, z), (x, 0, z + rise), r, BOX, material=material, mirror=True)
    if post:
        kit.between((x, 0, z), (x, 0, z + rise), r, BOX, material=material)


def bench(kit, x, y, z, long, material, back=-1):
    kit.add(BOX, (x, y, z + 0.45), (0.2, long, 0.04), material=material)
    kit.add(BOX, (x, y, z + 0.22), (0.14, long * 0.8, 0.22), material=material, cut=(BARS, 0.7 / long, 0.15))
    if back:
        kit.add(BOX, (x + back * 0.2, y, z + 0.7), (0.03, long, 0.2), material=material)


def pierced(kit, axis, at, half, count, material, share=0.55, thick=0.14):
    """A wall whose `count` windows are openings: `axis` is its normal, `at` its middle, `half` (along it, up); the solid rest closes one end."""
    long, high = half
    even = count % 2 == 0
    pitch = 2 * long / (count + (3 * share if even else 2 - share))
    off = pitch * (share if even else share - 1) / 2
    for move, wide, cut in ((-off, long - abs(off), (BARS, 1 / pitch, share)), (np.sign(off) * (long - abs(off)), abs(off), None)):
        centre = np.array(at, float) + np.eye(3)[1 - axis] * move
        reach = (thick, wide, high) if axis == 0 else (wide, thick, high)
        kit.add(BOX, centre, reach, material=material, **({"cut": cut} if cut else {}))


def block(kit, at, half, storeys, counts, wall, glass, course=None, share=0.55, back=None):
    """Storeys [3.2 high by default `half` up] around a body of glass: windows set in on all sides, `counts` (front, back, sides) of them; ledges of `course`."""
    (x, y, z), (hx, hy, hz), step = at, half, 2 * half[2] / storeys
    kit.add(BOX, (x, y, z + hz), (hx - 0.2, hy - 0.2, hz - 0.02), material=glass)
    for k in range(storeys):
        middle = z + step * (k + 0.5)
        pierced(kit, 0, (x + hx - 0.14, y, middle), (hy, step / 2), counts[0], wall, share)
        pierced(kit, 0, (x - hx + 0.14, y, middle), (hy, step / 2), counts[1], back or wall, share)
        for side in (-1, 1):
            pierced(kit, 1, (x, y + side * (hy - 0.14), middle), (hx, step / 2), counts[2], wall, share)
        if course is not None:
            kit.add(BOX, (x, y, z + step * (k + 1)), (hx + 0.06, hy + 0.06, 0.1), material=course)
