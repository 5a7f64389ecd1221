"""Makers of motorcycles of every build and of light vehicles for one or a few."""

from contextlib import contextmanager
from typing import NamedTuple

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .launchers import drab
from .layout import BALL, BARS, BOX, CYL, GRID, SPOKES
from .materials import BANDS, CHECKER, PLAIN, PLANKS, RIBS, STRIPES, WRITING, Material
from .materials import paint as hue_paint
from .roadcraft import RING, arch, car_paint, chrome, hide, hood, rims, rubber, seat, section, slab, steering, timber
from .wheeled import glazing

WHITE, RED = [0.85, 0.85, 0.78], [0.5, 0.02, 0.02]


class Bike(NamedTuple):
    """What a motorcycle's parts share; `base`: half its wheelbase; radii and half widths are of the front and the rear wheel."""

    base: float
    radii: tuple
    halves: tuple
    rake: float
    head: np.ndarray  # [3], the top of the fork
    up: np.ndarray  # [3], along the fork
    saddle: float
    pivot: np.ndarray  # [3], of the swing arm
    steer: float
    paint: Material
    second: Material
    dark: Material
    metal: Material
    engine: Material
    hide: Material


def flat(kit, colour, gloss=0.4):
    return kit.material(base=colour, pattern=PLAIN, gloss=gloss)


def fins(kit, base=None):
    """Metal with cooling fins across the local z."""
    base = kit.rng.choice([0.03, 0.06, 0.3, 0.45]) * np.ones(3) if base is None else base
    return kit.material(base=base, pattern=BANDS, frequency=kit.rng.uniform(38, 55), gloss=0.3, second=np.array(base) * 0.3)


def lacquer(kit):
    """Paint of tanks and fairings: strong colours, black, white, silver, seldom striped."""
    if kit.chance(0.35):
        return car_paint(kit)
    base = hue_paint(kit.rng.choice([0, 0.0, 0.03, 0.07, 0.14, 0.33, 0.38, 0.58, 0.62, 0.64, 0.78]), kit.rng.uniform(0.75, 1), kit.rng.uniform(0.2, 0.9))
    return kit.material(base=base, pattern=kit.rng.choice([PLAIN, PLAIN, PLAIN, STRIPES]), frequency=kit.rng.uniform(3, 7), gloss=kit.rng.uniform(0.3, 0.6))


@contextmanager
def steered(kit, bike):
    """What is added within turns with the steering."""
    first = len(kit.primitives)
    yield
    if bike.steer:
        tilt = turn("y", -bike.rake)
        frame = tilt @ turn("z", bike.steer) @ tilt.T
        kit.primitives[first:] = [p._replace(centre=bike.head + frame @ (p.centre - bike.head), rotation=frame @ p.rotation) for p in kit.primitives[first:]]


def lean(kit, degrees, foot, material):
    """Everything leans to the left onto a side stand, whose upper end is at `foot`."""
    frame = turn("x", -degrees)
    kit.primitives = [p._replace(centre=frame @ p.centre, rotation=frame @ p.rotation) for p in kit.primitives[:63]]
    top = frame @ np.array(foot)
    kit.between(top, (top[0] - 0.07, top[1] + 0.17, 0.0), 0.014, material=material)


def open_wheel(kit, centre, radius, half, tyre, rim, spokes, mirror=False):
    """A tyre with a rounded tread, rim and spokes between which one sees, and a hub; with mirror its pair too."""
    deep = min(0.86, 1 - half / radius * 0.55)
    kit.add(CYL, centre, (radius, radius, half * 0.6), rotation=ALONG_Y, material=tyre, cut=RING, mirror=mirror)
    kit.add(CYL, centre, (radius * 0.96, radius * 0.96, half), rotation=ALONG_Y, material=tyre, cut=RING, mirror=mirror)
    kit.add(CYL, centre, (radius * deep, radius * deep, half * 0.62), rotation=ALONG_Y, material=rim, cut=spokes, mirror=mirror)
    kit.add(CYL, centre, (radius * 0.15, radius * 0.15, half * 1.25), rotation=ALONG_Y, material=rim, mirror=mirror)


def chassis(kit, base, radii, halves, rake, crown, saddle, spokes="cast", fork="tele", paint=None, knobbly=False, steer=True):
    """Wheels, discs, fork and swing arm of a motorcycle; `crown`: height of the fork's upper clamp."""
    rng = kit.rng
    up = np.array([-np.sin(np.radians(rake)), 0, np.cos(np.radians(rake))])
    head = np.array([base, 0, radii[0]]) + up * (crown - radii[0]) / up[2]
    dark, metal = kit.material(base=rng.uniform(0.015, 0.05) * np.ones(3), pattern=PLAIN, gloss=0.2), chrome(kit)
    engine = flat(kit, rng.choice([0.03, 0.08, 0.3, 0.5]) * np.ones(3), 0.5)
    paint = paint or lacquer(kit)
    turned = rng.uniform(8, 28) * rng.choice([1, 1, -1]) if steer and kit.chance(0.4) else 0.0
    pivot = np.array([-base + rng.uniform(0.5, 0.58), 0, rng.uniform(0.36, 0.42)])
    bike = Bike(base, radii, halves, rake, head, up, saddle, pivot, turned, paint, lacquer(kit), dark, metal, engine, hide(kit))
    tyre = kit.material(base=[0.03] * 3, pattern=CHECKER, frequency=35, second=[0.008] * 3, gloss=0.02) if knobbly else rubber(kit)
    if spokes == "wire":
        rim, cut = metal if kit.chance(0.7) else flat(kit, [0.6, 0.42, 0.12]), (SPOKES, int(rng.integers(14, 22)), rng.uniform(0.07, 0.11))
    else:
        rim, cut = rng.choice([0, 1, 2]), (SPOKES, int(rng.choice([3, 5, 6, 7, 10])), rng.uniform(0.12, 0.2))
        rim = [dark, metal, flat(kit, bike.second.first)][rim]
    disc = flat(kit, [0.4] * 3, 0.6)
    open_wheel(kit, (-base, 0, radii[1]), radii[1], halves[1], tyre, rim, cut)
    arm = bike.metal if kit.chance(0.5) else dark
    wide = halves[1] + 0.035
    kit.between(pivot + [0, wide - 0.02, 0], (-base, wide, radii[1]), (0.036, 0.018), BOX, 0.75, arm, True)
    with steered(kit, bike):
        open_wheel(kit, (base, 0, radii[0]), radii[0], halves[0], tyre, rim, cut)
        apart, foot = halves[0] + 0.045, np.array([base, 0, radii[0]])
        if spokes == "cast" or fork in ("usd", "gaiter"):
            kit.add(CYL, (base, halves[0] + 0.012, radii[0]), (radii[0] * 0.52,) * 2 + (0.006,), rotation=ALONG_Y, material=disc, mirror=halves[0] > 0.05, cut=(SPOKES, 6, 0.14))
        else:
            kit.add(CYL, (base, 0, radii[0]), (radii[0] * 0.28,) * 2 + (halves[0] * 1.1,), rotation=ALONG_Y, material=metal)
        length = np.linalg.norm(head - foot)
        if fork == "girder":
            kit.between(foot + [0, apart, 0], foot + up * length * 0.96 + [0, apart * 0.8, 0], (0.03, 0.015), BOX, material=paint if kit.chance(0.5) else dark, mirror=True)
            kit.between(foot + up * length * 0.6 + [0.03, 0, 0], head + [0.03, 0, 0], 0.035, material=fins(kit, [0.2] * 3))
        else:
            fat, thin = (0.034, 0.027) if fork != "springer" else (0.022, 0.018)
            tops = {"usd": rng.choice([0, 1]), "gaiter": 2}.get(fork, 3)
            sleeve = [dark, flat(kit, [0.6, 0.38, 0.06], 0.6), kit.material(base=[0.03] * 3, pattern=BANDS, frequency=40, second=[0.1] * 3), metal][tops]
            split = length * {"usd": 0.36, "gaiter": 0.42}.get(fork, rng.uniform(0.48, 0.55))
            kit.between(foot + [0, apart, 0], foot + up * split + [0, apart, 0], thin if fork == "usd" else fat, material=metal if fork == "usd" or kit.chance(0.5) else dark, mirror=True)
            kit.between(foot + up * split * 0.97 + [0, apart, 0], head + [0, apart, 0], fat if fork in ("usd", "gaiter") else thin, material=sleeve, mirror=True)
            if fork == "springer":
                kit.between(foot + [0.04, apart + 0.01, 0.06], head + [0.08, apart, -0.02], 0.014, material=metal, mirror=True)
        kit.add(BOX, head, (0.055, apart + 0.035, 0.018), rotation=turn("y", -rake), material=metal if kit.chance(0.4) else dark)
        kit.add(BOX, head - up * 0.19, (0.055, apart + 0.035, 0.022), rotation=turn("y", -rake), material=dark)
    kit.between(head - up * 0.2 - [0.03, 0, 0], head - up * 0.01 - [0.03, 0, 0], 0.045, material=dark)
    return bike


def frame(kit, b, sort, material, tail=None):
    """Cradle of tubes, beams of metal, a trellis or a spine with two tubes, and what carries the seat."""
    neck, tail = b.head - b.up * 0.1 - [0.04, 0, 0], np.array(tail if tail is not None else (-b.base * 0.9, 0.07, b.saddle - 0.04))
    joint, low = np.array([b.pivot[0] + 0.02, 0.09, b.saddle - 0.1]), b.pivot + [0.02, 0.09, -0.14]
    if sort == "beam":
        kit.between(neck + [0, 0.06, -0.02], b.pivot + [0.02, 0.13, 0.16], (0.03, 0.06), BOX, 1.2, material, True)
        kit.between(b.pivot + [0.02, 0.13, 0.2], b.pivot + [0, 0.12, -0.08], (0.05, 0.03), BOX, 0.8, material, True)
    elif sort == "spine":
        kit.between(neck - b.up * 0.06, (b.base - b.radii[0] - 0.12, 0.09, 0.28), 0.022, material=material, mirror=True)
    elif sort == "trellis":
        knee = np.array([0.12, 0.13, b.saddle - 0.22])
        for start, end in ((neck, joint), (neck - b.up * 0.08, knee), (knee, joint)):
            kit.between(start + [0, 0.05 if start is neck else 0, 0], end, 0.02, material=material, mirror=True)
    else:
        shin = np.array([b.base - b.radii[0] - 0.12, 0.08, 0.28])
        kit.between(neck, joint * [1, 0, 1], 0.028, material=material)
        kit.between(neck - b.up * 0.06, shin, 0.02, material=material, mirror=True)
        kit.between(shin, low, 0.02, material=material, mirror=True)
        kit.between(low, joint, 0.022, material=material, mirror=True)
    kit.between(joint - [0, 0.02, 0], tail, 0.02, material=material, mirror=True)


def motor(kit, b, sort, x=0.06, big=1.0):
    """An engine: crankcase with covers, then cylinders of a four, parallel twin, single, V or L twin, boxer or two-stroke, all with fins. Returns where the exhaust starts."""
    rng, case, block = kit.rng, b.engine, fins(kit)
    z, wide = 0.36, {"four": 0.2, "boxer": 0.14, "two": 0.11, "single": 0.12}.get(sort, 0.15)
    c = np.array([x, 0, z])
    kit.add(BOX, c + [-0.03, 0, 0], (0.25 * big, wide * 0.8, 0.12), (0.85, 0.9), material=case)
    kit.add(CYL, c + [0.08, 0, 0], (0.115, 0.115, wide + 0.015), rotation=ALONG_Y, material=case if kit.chance(0.5) else b.metal)
    kit.add(CYL, c + [-0.14, 0, 0.02], (0.085, 0.085, wide), rotation=ALONG_Y, material=b.dark if kit.chance(0.4) else case)
    top = b.saddle - 0.1 - z
    if sort in ("vtwin", "ltwin"):
        for angle, dx in ((-24, -0.06), (24, 0.06)) if sort == "vtwin" else ((-12, -0.06), (78, 0.1)):
            spin, long = turn("y", angle), 0.13 if sort == "vtwin" else 0.11
            foot = c + [dx, 0, 0.06]
            kit.add(CYL, foot + spin @ [0, 0, long], (0.095 * big, 0.095 * big, long), rotation=spin, material=block)
            kit.add(BOX, foot + spin @ [0, 0, 2 * long + 0.03], (0.085 * big, 0.08, 0.05), (0.8, 0.8), rotation=spin, material=case)
        kit.add(CYL, c + [0, -0.1, 0.24], (0.085, 0.085, 0.06), rotation=ALONG_Y, material=b.metal)
        return c + [0.2, 0, 0.22]
    if sort == "boxer":
        kit.add(CYL, c + [0.1, 0.22, 0.04], (0.09, 0.1, 0.12), rotation=ALONG_Y, material=block, mirror=True)
        kit.add(BOX, c + [0.1, 0.35, 0.04], (0.09, 0.04, 0.08), (0.9, 0.9), material=b.metal if kit.chance(0.6) else case, mirror=True)
        kit.add(BOX, c + [-0.04, 0, top * 0.6], (0.2, 0.1, top * 0.36), (0.9, 0.9), material=b.dark)
        return c + [0.18, 0.26, 0.0]
    tilt = turn("y", rng.uniform(5, 25) if sort == "four" else rng.uniform(-2, 14))
    half = {"four": (0.09, 0.2), "parallel": (0.09, 0.15), "two": (0.075, 0.075)}.get(sort, (0.085, 0.085))
    kit.add(BOX if sort != "two" else CYL, c + tilt @ [0.07, 0, 0.18], half + (0.1,), rotation=tilt, material=block)
    kit.add(BOX, c + tilt @ [0.07, 0, min(0.31, top - 0.02)], (half[0] * 0.95, half[1] * 0.92, 0.055), (0.8, 0.9), rotation=tilt, material=case)
    kit.add(BOX, c + [-0.12, 0, top * 0.62], (0.12, 0.11, top * 0.34), (1.1, 1), material=b.dark)
    return c + tilt @ [0.15, half[1] * 0.6, 0.25]


def exhaust(kit, b, start, sort, material=None):
    """Pipes down before the engine and back under it to a silencer low, high, under the tail, stubby, in pairs or staggered."""
    rng, pipe = kit.rng, b.metal if kit.chance(0.65) else flat(kit, [0.28, 0.2, 0.13], 0.5)
    can, y = material or (b.metal if kit.chance(0.5) else b.dark), max(abs(start[1]), 0.05)
    if sort == "scrambler":  # both high along the right side
        for k in range(2):
            bend = np.array([start[0] + 0.08, -0.17, start[2] - 0.06 - 0.1 * k])
            kit.between(start * [1, -1, 1], bend, 0.024, material=pipe)
            kit.between(bend, (-0.2, -0.19, 0.58 - 0.1 * k), 0.024, material=pipe)
            kit.between((-0.18, -0.19, 0.58 - 0.1 * k), (-b.base * 1.02, -0.2, 0.66 - 0.08 * k), 0.042, material=can)
        return
    if sort == "dirt":
        bend = np.array([start[0] + 0.1, -0.08, start[2] - 0.05])
        kit.between(start, bend, 0.028, material=pipe)
        kit.between(bend, (-0.1, -0.13, b.saddle - 0.32), 0.03, material=pipe)
        kit.between((-0.1, -0.13, b.saddle - 0.32), (-0.3, -0.13, b.saddle - 0.2), 0.028, material=pipe)
        kit.between((-0.28, -0.13, b.saddle - 0.21), (-b.base * 1.0, -0.13, b.saddle - 0.1), (0.05, 0.04), material=can)
        return
    if sort == "staggered":
        for k, x in enumerate((start[0] - 0.02, start[0] - 0.3)):
            low = np.array([x + 0.04, -0.2, 0.34 - 0.07 * k + 0.05])
            kit.between((x, -0.06, start[2]), low, 0.026, material=b.metal)
            kit.between(low, (-b.base - rng.uniform(0.05, 0.2), -0.22, 0.39 - 0.1 * k), 0.044, material=b.metal)
        return
    shin = np.array([b.base - b.radii[0] - 0.08, y * 0.9, 0.3])
    kit.between(start * [1, 0, 1] + [0, y, 0], shin, 0.024, material=pipe, mirror=True)
    kit.between(shin, (b.pivot[0] + 0.02, 0.1, 0.22), 0.026, material=pipe, mirror=True)
    if sort == "stubby":
        kit.add(BOX, (b.pivot[0] + 0.05, -0.02, 0.22), (0.16, 0.13, 0.06), (0.9, 0.85), material=can)
    elif sort == "under":
        kit.between((b.pivot[0], -0.12, 0.24), (b.pivot[0] - 0.1, -0.12, b.saddle - 0.05), 0.028, material=pipe)
        kit.between((b.pivot[0] - 0.1, 0.07, b.saddle - 0.06), (-b.base - 0.14, 0.08, b.saddle + 0.03), 0.055, material=can, mirror=True)
    else:
        rise = {"low": rng.uniform(0.32, 0.4), "high": 0.62}[sort]
        y, mirror = b.halves[1] + 0.1, sort == "low" and kit.chance(0.5)
        kit.between((b.pivot[0] + 0.05, -0.1 if not mirror else 0.1, 0.22), (b.pivot[0] - 0.12, y if mirror else -y, 0.3), 0.028, material=pipe, mirror=mirror)
        kit.between((b.pivot[0] - 0.1, y if mirror else -y, 0.3), (-b.base - rng.uniform(0, 0.15), (y + 0.03) * (1 if mirror else -1), rise), (0.055, 0.048), taper=1.1, material=can, mirror=mirror)


def bars(kit, b, out, rise, back, mirrors=True, clipons=False):
    """Handlebars with grips, levers and mirrors; they turn with the steering."""
    grip = b.head + [-back, out, rise]
    with steered(kit, b):
        if clipons:
            kit.between(b.head + [0.02, 0.1, -0.03], grip, 0.019, material=b.dark, mirror=True)
        else:
            knee = b.head + [-0.01, out * 0.45, rise]
            kit.between(b.head + [0, 0.03, 0], knee, 0.014, material=b.metal, mirror=True)
            kit.between(knee, grip, 0.018, material=b.dark, mirror=True)
        if mirrors:
            root = grip * [1, 0.72, 1] + [0.03, 0, 0.01]
            kit.between(root, root + [0.02, 0.04, 0.17], 0.008, material=b.dark, mirror=True)
            kit.add(BALL, root + [0.01, 0.06, 0.18], (0.02, 0.06, 0.04), material=b.dark, mirror=True)
    return grip


def round_lamp(kit, b, size, drop=0.1, ahead=0.14):
    """A round head lamp before the fork, its glass and a dial above."""
    place = b.head + [ahead, 0, -drop]
    with steered(kit, b):
        kit.add(BALL, place, (size * 1.15, size, size), material=b.metal if kit.chance(0.5) else b.dark)
        kit.add(CYL, place + [size * 0.7, 0, 0], (size * 0.88, size * 0.88, size * 0.35), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        kit.add(CYL, b.head + [0.04, 0, 0.05], (0.05, 0.05, 0.03), rotation=turn("y", -30), material=b.dark)


def front_guard(kit, b, first, last, count, material, lift=0.03):
    with steered(kit, b):
        arch(kit, b.base, 0, b.radii[0], b.radii[0] + lift, b.halves[0] + 0.012, first, last, count, material)


def rear_guard(kit, b, first, last, count, material, wider=0.012):
    arch(kit, -b.base, 0, b.radii[1], b.radii[1] + 0.035, b.halves[1] + wider, first, last, count, material)


def shocks(kit, b, top):
    """Two shock absorbers from the swing arm up to `top` (x, z)."""
    spring = fins(kit, kit.rng.choice([0.05, 0.5]) * np.ones(3) if kit.chance(0.6) else np.array([0.6, 0.05, 0.03]))
    kit.between((-b.base * 0.93, b.halves[1] + 0.06, b.radii[1] + 0.04), (top[0], b.halves[1] + 0.04, top[1]), 0.032, material=spring, mirror=True)


def finish(kit, b, grip, tail, plate, stand=None):
    """What is small: lamp and plate behind, chain guard, pegs, indicators, then a stand."""
    rng = kit.rng
    kit.add(BOX, tail, (0.035, 0.06, 0.03), (0.8, 0.9), material=flat(kit, RED))
    if plate is not None:
        kit.between(np.array(tail) - [-0.02, 0, 0.01], plate, (0.012, 0.05), BOX, material=b.dark)
        kit.add(BOX, plate, (0.008, 0.09, 0.065), rotation=turn("y", 20), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=30, second=[0.02] * 3))
    kit.between((b.pivot[0] + 0.06, -0.26, b.pivot[2] - 0.06), (b.pivot[0] + 0.06, 0.26, b.pivot[2] - 0.06), 0.017, material=b.dark)
    kit.between((b.pivot[0], b.halves[1] + 0.02, b.pivot[2] + 0.05), (-b.base, b.halves[1] + 0.02, b.radii[1] + 0.06), (0.02, 0.01), BOX, material=b.dark)
    stand = stand or rng.choice(["side", "side", "side", "centre", "none"])
    if stand == "side":
        lean(kit, rng.uniform(5, 11), (b.pivot[0] + 0.1, 0.13, 0.28), b.dark)
    elif stand == "centre":
        kit.between((b.pivot[0] + 0.06, 0.09, 0.26), (b.pivot[0] - 0.06, 0.16, 0.0), 0.016, material=b.dark, mirror=True)


def sport(kit):
    """A fully faired sport bike: pointed nose over a low screen, side panels to a belly pan, tail swept up."""
    rng = kit.rng
    b = chassis(kit, rng.uniform(0.68, 0.73), (0.3, 0.305), (0.06, rng.uniform(0.085, 0.1)), rng.uniform(23, 26), rng.uniform(0.86, 0.92), rng.uniform(0.8, 0.85), fork="usd")
    wide, nose = rng.uniform(0.19, 0.23), b.base + rng.uniform(0.0, 0.1)
    side = b.second if kit.chance(0.4) else b.paint
    kit.add(BOX, (0.02, 0, 0.45), (0.3, 0.13, 0.18), (1, 0.9), material=b.dark)
    slab(kit, 0.47, 0.76, (-0.06, 0.36, wide * 0.95), (0.08, 0.56, wide), side)
    slab(kit, 0.19, 0.48, (-0.3, 0.2, wide * 0.5), (-0.14, 0.35, wide * 0.95), side if kit.chance(0.6) else b.second)
    top = b.head[2] + 0.06
    section(kit, 0.28, 0.58, (0.6, top - 0.02, wide * 0.8), (0.72, top, wide * 0.85), b.paint)
    section(kit, 0.57, nose, (0.73, top, wide * 0.86), (0.83, 0.89, 0.05), b.paint)
    kit.between((0.62, 0, top - 0.02), (0.33, 0, top + rng.uniform(0.15, 0.2)), (0.012, wide * 0.75), BOX, 0.7, glazing(kit))
    lamp = flat(kit, WHITE, 0.6)
    kit.add(BOX, (nose - 0.075, 0.075, 0.885), (0.05, 0.05, 0.025), rotation=turn("z", -32), material=lamp, mirror=True)
    kit.add(BOX, (0.2, wide * 0.98, 0.6), (0.1, 0.008, 0.06), shift=(0.07, 0), material=b.dark, mirror=True)
    kit.add(BALL, (0.16, 0, b.saddle + 0.06), (0.27, 0.15, 0.13), rotation=turn("y", -8), material=b.paint)
    section(kit, -0.18, 0.12, (b.saddle - 0.16, b.saddle + 0.02, 0.09), (b.saddle - 0.2, b.saddle + 0.13, 0.15), b.paint)
    slab(kit, b.saddle - 0.05, b.saddle + 0.02, (-0.5, -0.1, 0.13), (-0.48, -0.12, 0.12), b.dark)
    section(kit, -0.98, -0.4, (b.saddle + 0.14, b.saddle + 0.2, 0.04), (b.saddle - 0.1, b.saddle + 0.1, 0.13), b.paint)
    kit.between((-0.12, 0.08, b.saddle - 0.12), (-0.5, 0.08, b.saddle - 0.0), (0.05, 0.02), BOX, material=b.dark, mirror=True)
    front_guard(kit, b, 40, 150, 3, b.paint)
    rear_guard(kit, b, 60, 130, 2, b.dark)
    exhaust(kit, b, np.array([0.2, 0.08, 0.5]), rng.choice(["low", "high", "stubby", "under"]))
    kit.between((b.pivot[0] - 0.05, 0, 0.4), (b.pivot[0] - 0.1, 0, 0.75), 0.05, material=fins(kit, [0.5, 0.4, 0.05]))
    grip = bars(kit, b, rng.uniform(0.28, 0.33), -0.03, 0.17, False, True)
    root = np.array([0.52, wide * 0.8, top - 0.03])
    kit.between(root, root + [0.0, 0.14, 0.06], 0.01, material=b.dark, mirror=True)
    kit.add(BALL, root + [0, 0.16, 0.07], (0.03, 0.07, 0.035), material=b.dark, mirror=True)
    finish(kit, b, grip, (-0.99, 0, b.saddle + 0.17), (-0.95, 0, b.saddle - 0.1), rng.choice(["side", "side", "none"]))


def roadster(kit):
    """Naked bikes of today, cafe racers, scramblers and classics: round lamp, tank, bare engine."""
    rng = kit.rng
    kind = rng.choice(["naked", "naked", "cafe", "scrambler", "classic"])
    modern = kind == "naked"
    front = 0.3 if modern else rng.uniform(0.31, 0.34)
    halves = (0.06, 0.09) if modern else (0.05, 0.062)
    style = dict(spokes="cast" if modern else "wire", fork="usd" if modern else rng.choice(["tele", "gaiter"]) if kind == "scrambler" else "tele", knobbly=kind == "scrambler")
    b = chassis(kit, rng.uniform(0.69, 0.74), (front, 0.31), halves, rng.uniform(24, 28), rng.uniform(0.94, 1.0) if kind != "cafe" else 0.9, rng.uniform(0.77, 0.83), **style)
    sort = rng.choice(["trellis", "beam", "cradle"]) if modern else "cradle"
    frame(kit, b, sort, flat(kit, rng.choice([[0.03] * 3, [0.03] * 3, [0.5] * 3, [0.5, 0.03, 0.02]])))
    engine = rng.choice(["four", "parallel", "ltwin"]) if modern else rng.choice(["four", "parallel", "parallel", "single", "boxer", "vtwin"])
    start = motor(kit, b, engine)
    exhaust(kit, b, start, "scrambler" if kind == "scrambler" and engine != "boxer" else rng.choice(["low", "high", "stubby"]) if modern else "low")
    z = b.saddle
    if modern:
        section(kit, -0.14, 0.14, (z - 0.1, z + 0.02, 0.09), (z - 0.12, z + 0.17, 0.16), b.paint)
        section(kit, 0.13, b.head[0] - 0.04, (z - 0.12, z + 0.17, 0.16), (z - 0.02, z + 0.12, 0.1), b.paint)
        slab(kit, z - 0.16, z + 0.02, (0.18, 0.4, 0.19), (0.12, 0.44, 0.15), b.second if kit.chance(0.5) else b.dark)
        kit.add(BOX, (0.34, 0, 0.52), (0.03, 0.15, 0.15), rotation=turn("y", -12), material=kit.material(base=[0.04] * 3, pattern=RIBS, frequency=40, second=[0.1] * 3))
        section(kit, -0.55, -0.1, (z + 0.01, z + 0.09, 0.12), (z - 0.06, z + 0.03, 0.12), b.dark)
        section(kit, -0.88, -0.3, (z + 0.06, z + 0.12, 0.05), (z - 0.1, z + 0.02, 0.11), b.paint)
        with steered(kit, b):
            if kit.chance(0.5):
                section(kit, b.head[0] + 0.02, b.head[0] + 0.22, (z - 0.0, b.head[2] + 0.1, 0.14), (z + 0.02, z + 0.08, 0.07), b.paint)
                kit.add(BOX, b.head + [0.16, 0, -0.08], (0.06, 0.09, 0.045), rotation=turn("y", -30), material=flat(kit, WHITE, 0.6))
            else:
                kit.add(CYL, b.head + [0.15, 0, -0.09], (0.1, 0.1, 0.06), rotation=ALONG_X, material=b.dark)
                kit.add(CYL, b.head + [0.18, 0, -0.09], (0.088, 0.088, 0.04), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        front_guard(kit, b, 45, 150, 3, b.paint)
        rear_guard(kit, b, 55, 130, 2, b.dark)
        kit.between(b.pivot + [-0.06, 0, 0], b.pivot + [-0.12, 0, 0.36], 0.045, material=fins(kit, [0.6, 0.05, 0.03]))
        grip, plate, end = bars(kit, b, rng.uniform(0.35, 0.4), 0.05, 0.1), (-0.88, 0, z - 0.12), (-0.89, 0, z + 0.08)
    else:
        long = 0.34 if kind == "cafe" else 0.28
        kit.add(BALL, (0.13, 0, z + 0.06), (long, rng.uniform(0.13, 0.16), 0.125), rotation=turn("y", -6), material=b.paint)
        kit.add(BOX, (0.12, 0, z - 0.0), (long * 0.8, 0.115, 0.07), (0.95, 1.1), material=b.paint)
        kit.add(CYL, (-0.16, 0, z - 0.22), (0.1, 0.1, 0.12), rotation=ALONG_Y, material=b.dark if kit.chance(0.5) else b.paint)
        shocks(kit, b, (-b.base * 0.62, z - 0.05))
        if kind == "cafe":
            slab(kit, z - 0.05, z + 0.02, (-0.48, -0.1, 0.12), (-0.5, -0.14, 0.1), b.hide)
            section(kit, -0.86, -0.44, (z + 0.0, z + 0.06, 0.05), (z - 0.05, z + 0.14, 0.12), b.paint)
            if kit.chance(0.4):
                with steered(kit, b):
                    kit.add(BALL, b.head + [0.14, 0, 0.0], (0.2, 0.18, 0.19), material=b.paint)
                    kit.between(b.head + [0.16, 0, 0.14], b.head + [0, 0, 0.3], (0.01, 0.12), BOX, 0.7, glazing(kit))
        else:
            slab(kit, z - 0.05, z + 0.04, (-0.82, -0.1, 0.12), (-0.8, -0.1, 0.11), b.hide)
        round_lamp(kit, b, rng.uniform(0.085, 0.105))
        high = kind == "scrambler" and kit.chance(0.5)
        front_guard(kit, b, 50 if high else 20, 150, 3, b.metal if kit.chance(0.4) else b.paint, 0.12 if high else 0.03)
        rear_guard(kit, b, 40, 160, 3, b.metal if kit.chance(0.4) else b.paint)
        grip = bars(kit, b, 0.3, -0.02, 0.14, kit.chance(0.4), True) if kind == "cafe" else bars(kit, b, rng.uniform(0.34, 0.42), rng.uniform(0.06, 0.14), 0.14, kit.chance(0.5))
        plate, end = (-b.base - 0.3, 0, 0.5), (-b.base - 0.2, 0, z - 0.14)
        kit.between((-b.base - 0.12, 0, z - 0.14), end, (0.03, 0.03), BOX, material=b.dark)
    finish(kit, b, grip, end, plate)


def cruiser(kit):
    """Cruisers, baggers with a batwing and choppers: long, low, a V of two cylinders, chrome, high bars."""
    rng = kit.rng
    kind = rng.choice(["cruiser", "cruiser", "bagger", "bobber", "chopper", "chopper"])
    chopper = kind == "chopper"
    front = (0.35, 0.034) if chopper or kit.chance(0.3) else (0.32, 0.06)
    rear = (0.33, rng.uniform(0.08, 0.12))
    base, rake = (rng.uniform(0.95, 1.12), rng.uniform(38, 46)) if chopper else (rng.uniform(0.8, 0.87), rng.uniform(29, 34))
    fork = "springer" if kit.chance(0.35) else "tele"
    b = chassis(kit, base, (front[0], rear[0]), (front[1], rear[1]), rake, rng.uniform(0.95, 1.05) if chopper else 0.92, rng.uniform(0.62, 0.7), rng.choice(["cast", "wire"]), fork)
    b = b._replace(pivot=np.array([-base + 0.55, 0, 0.34]))
    z, x = b.saddle, -0.02 if not chopper else -0.12
    start = motor(kit, b, "vtwin", x, rng.uniform(1.0, 1.2))
    tube = b.paint if kit.chance(0.4) else b.dark
    shin, neck = np.array([x + 0.36, 0.09, 0.24]), b.head - b.up * 0.12 - [0.04, 0, 0]
    kit.between(neck, (x - 0.3, 0, z - 0.04), 0.03, material=tube)
    kit.between(neck - b.up * 0.06, shin, 0.023, material=tube, mirror=True)
    kit.between(shin, b.pivot + [0, 0.09, -0.1], 0.023, material=tube, mirror=True)
    kit.between((x - 0.3, 0.06, z - 0.04), b.pivot + [-0.02, 0.09, -0.1], 0.024, material=tube, mirror=True)
    kit.between((x - 0.3, 0.05, z - 0.06), (-base, rear[1] + 0.04, rear[0] + 0.02), 0.022, material=tube, mirror=True)
    exhaust(kit, b, start + [-0.04, 0, 0], "staggered")
    way = (neck - np.array([x - 0.2, 0, z]))[[0, 2]]
    pitch = turn("y", -np.degrees(np.arctan2(way[1], way[0])) * 0.9)
    middle = (neck + np.array([x - 0.1, 0, z])) / 2 + [0, 0, 0.07]
    kit.add(BALL, middle, (0.28 if not chopper else 0.24, 0.16 if not chopper else 0.11, 0.11), rotation=pitch, material=b.paint)
    kit.add(BOX, middle - [0, 0, 0.03], (0.2, 0.1, 0.05), (1, 1.1), rotation=pitch, material=b.paint)
    kit.add(BALL, (x - 0.34, 0, z + 0.02), (0.21, 0.16, 0.06), material=b.hide)
    kit.add(BOX, (x - 0.27, 0, z - 0.14), (0.13, 0.11, 0.12), material=b.dark)
    if kind in ("cruiser", "bagger"):
        kit.add(BOX, (-base + 0.06, 0, rear[0] * 2 + 0.08), (0.17, 0.11, 0.045), (0.9, 0.8), rotation=turn("y", 5), material=b.hide)
        if kit.chance(0.6):
            kit.add(BOX, (-base - 0.12, 0, rear[0] * 2 + 0.27), (0.03, 0.1, 0.1), (0.8, 0.8), rotation=turn("y", -12), material=b.hide)
            kit.between((-base - 0.1, 0.1, rear[0] * 2), (-base - 0.14, 0.08, rear[0] * 2 + 0.27), 0.012, material=b.metal, mirror=True)
    rear_guard(kit, b, 20 if kind == "bagger" else 45, 170 if kind != "bobber" else 150, 4, b.paint, 0.02)
    kit.between((-base - 0.02, 0, rear[0] * 2 + 0.03), (x - 0.3, 0, z - 0.06), (0.03, 0.07), BOX, material=b.paint)
    front_guard(kit, b, 20 if kind == "bagger" else 45, 150, 3 if not chopper else 2, b.paint)
    round_lamp(kit, b, 0.1 if not chopper else 0.08, 0.12, 0.16)
    hang = rng.uniform(0.28, 0.42) if chopper and kit.chance(0.7) else rng.uniform(0.12, 0.22)
    grip = bars(kit, b, rng.uniform(0.36, 0.44), hang, 0.28 if not chopper else 0.25, kit.chance(0.6))
    if kind == "bagger":
        with steered(kit, b):
            section(kit, b.head[0] + 0.02, b.head[0] + 0.22, (b.head[2] - 0.14, b.head[2] + 0.2, 0.34), (b.head[2] - 0.08, b.head[2] + 0.1, 0.2), b.paint)
            kit.between(b.head + [0.16, 0, 0.14], b.head + [0.05, 0, 0.36], (0.012, 0.26), BOX, 0.8, glazing(kit))
        section(kit, -base - 0.34, -base + 0.28, (0.36, 0.58, 0.09), (0.34, 0.66, 0.1), b.paint, rear[1] + 0.15, True)
    elif kind == "cruiser" and kit.chance(0.5):
        kit.add(BOX, (-base - 0.0, rear[1] + 0.14, 0.55), (0.2, 0.09, 0.14), (0.9, 0.9), material=b.hide, mirror=True)
    kit.between((x + 0.42, -0.3, 0.27), (x + 0.42, 0.3, 0.27), 0.018, material=b.metal)
    kit.between(shin + [0, -0.03, 0.03], (x + 0.42, 0.1, 0.27), 0.02, material=b.metal, mirror=True)
    tail = (-base - rear[0] * 0.75, 0, rear[0] * 1.75)
    finish(kit, b, grip, tail, (-base - rear[0] * 1.12, 0, rear[0] * 1.3), "side")


def tourer(kit):
    """Tourers: a broad fairing with a tall screen, deep seat, panniers and a top case with a back rest."""
    rng = kit.rng
    b = chassis(kit, rng.uniform(0.76, 0.84), (0.31, 0.31), (0.062, 0.09), rng.uniform(25, 29), 0.98, rng.uniform(0.74, 0.79))
    z, wide = b.saddle, rng.uniform(0.27, 0.34)
    big = kit.chance(0.5)
    motor(kit, b, "boxer" if kit.chance(0.6) else "four")
    kit.between((b.pivot[0] + 0.1, 0.1, 0.22), (b.pivot[0] - 0.14, 0.2, 0.26), 0.03, material=b.metal, mirror=True)
    kit.between((b.pivot[0] - 0.12, 0.2, 0.26), (-b.base - 0.3, 0.24, 0.33), 0.05, taper=1.1, material=b.metal if kit.chance(0.6) else b.dark, mirror=True)
    section(kit, 0.24, 0.5, (0.5, 1.04, wide * 0.9), (0.62, 1.06, wide), b.paint)
    section(kit, 0.49, b.base + 0.1, (0.63, 1.06, wide), (0.8, 0.95, wide * 0.35), b.paint)
    slab(kit, 0.25, 0.66, (0.1, 0.36, wide * 0.6), (0.12, 0.48, wide * 0.92), b.paint if kit.chance(0.6) else b.second)
    kit.between((0.6, 0, 1.02), (0.34, 0, rng.uniform(1.32, 1.5)), (0.012, wide * 0.75), BOX, 0.75, glazing(kit))
    kit.add(BOX, (b.base + 0.02, 0.08, 0.9), (0.07, 0.07, 0.04), (0.8, 0.9), rotation=turn("z", -22), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.add(BALL, (0.12, 0, z + 0.1), (0.3, 0.17, 0.13), material=b.paint)
    kit.add(BOX, (0.1, 0, z - 0.02), (0.28, 0.15, 0.1), material=b.paint)
    slab(kit, z - 0.08, z + 0.03, (-0.5, -0.08, 0.17), (-0.52, -0.1, 0.15), b.hide)
    slab(kit, z - 0.04, z + 0.13, (-0.9, -0.46, 0.16), (-0.88, -0.5, 0.14), b.hide)
    section(kit, -b.base - 0.28, -0.3, (z - 0.12, z + 0.04, 0.12), (z - 0.2, z - 0.02, 0.15), b.paint)
    kit.add(BOX, (-b.base, 0.3, 0.6), (0.27, 0.11, 0.19), (0.95, 0.85), (-0.02, 0), material=b.paint, mirror=True)
    kit.add(BOX, (-b.base + 0.02, 0, 0.66), (0.05, 0.22, 0.04), material=b.dark)
    if big or kit.chance(0.5):
        kit.add(BOX, (-b.base - 0.2, 0, z + 0.08), (0.14, 0.1, 0.06), material=b.dark)
        kit.add(BOX, (-b.base - 0.2, 0, z + 0.24), (0.2, 0.27, 0.14), (0.85, 0.88), material=b.paint)
        kit.add(BOX, (-b.base + 0.04, 0, z + 0.26), (0.04, 0.2, 0.14), (0.7, 0.9), (-0.03, 0), material=b.hide)
        kit.add(BOX, (-b.base - 0.39, 0, z + 0.2), (0.02, 0.2, 0.025), material=flat(kit, RED))
    front_guard(kit, b, 15, 150, 3, b.paint)
    rear_guard(kit, b, 70, 185, 2, b.dark)
    grip = bars(kit, b, 0.37, 0.12, 0.26, False)
    root = np.array([0.42, wide * 0.93, 1.02])
    kit.between(root, root + [0, 0.12, 0.05], 0.016, material=b.paint, mirror=True)
    kit.add(BALL, root + [0, 0.14, 0.05], (0.04, 0.08, 0.055), material=b.paint, mirror=True)
    finish(kit, b, grip, (-b.base - 0.29, 0, z - 0.03), (-b.base - 0.36, 0, z - 0.24))


def adventure(kit):
    """Adventure bikes: beak, tall screen, broad tank, long fork, wire wheels, crash bars, cases of aluminium."""
    rng = kit.rng
    fork = rng.choice(["usd", "tele"])
    b = chassis(kit, rng.uniform(0.75, 0.8), (0.34, 0.32), (0.055, 0.078), rng.uniform(25, 28), rng.uniform(1.06, 1.12), rng.uniform(0.84, 0.9), rng.choice(["wire", "wire", "cast"]), fork, knobbly=kit.chance(0.6))
    z = b.saddle
    frame(kit, b, "spine", flat(kit, rng.choice([[0.03] * 3, [0.4] * 3, [0.5, 0.03, 0.02], [0.7, 0.25, 0.02]])))
    sort = rng.choice(["boxer", "parallel", "vtwin"])
    exhaust(kit, b, motor(kit, b, sort) * [1, 0.5, 1], "dirt")
    section(kit, -0.14, 0.16, (z - 0.12, z + 0.03, 0.1), (z - 0.16, z + 0.2, 0.19), b.paint)
    section(kit, 0.15, b.head[0] + 0.06, (z - 0.16, z + 0.2, 0.2), (z - 0.02, b.head[2] + 0.02, 0.13), b.paint)
    slab(kit, z - 0.3, z + 0.06, (0.2, 0.36, 0.16), (0.16, 0.44, 0.22), b.second if kit.chance(0.5) else b.dark)
    face = b.head[0] + 0.06
    section(kit, face - 0.03, face + 0.2, (z - 0.04, b.head[2] + 0.06, 0.15), (z + 0.02, b.head[2] - 0.02, 0.11), b.paint if kit.chance(0.5) else b.dark)
    section(kit, face + 0.02, b.base + rng.uniform(0.18, 0.3), (z - 0.07, z + 0.03, 0.12), (z - 0.08, z - 0.05, 0.05), b.paint)
    kit.add(BOX, (face + 0.2, 0.06, z + 0.1), (0.02, 0.05, 0.055), material=flat(kit, WHITE, 0.6), mirror=kit.chance(0.7))
    kit.between((face + 0.12, 0, b.head[2] + 0.02), (face - 0.06, 0, b.head[2] + rng.uniform(0.25, 0.38)), (0.01, 0.16), BOX, 0.75, glazing(kit))
    slab(kit, z - 0.06, z + 0.03, (-0.48, -0.08, 0.14), (-0.46, -0.1, 0.12), b.hide)
    slab(kit, z - 0.05, z + 0.08, (-0.82, -0.44, 0.13), (-0.8, -0.46, 0.11), b.hide)
    section(kit, -0.98, -0.3, (z - 0.02, z + 0.03, 0.1), (z - 0.14, z - 0.04, 0.1), b.dark)
    front_guard(kit, b, 60, 150, 2, b.dark)
    rear_guard(kit, b, 70, 160, 2, b.dark)
    kit.between(b.pivot + [-0.06, 0, 0.02], b.pivot + [-0.1, 0, 0.38], 0.05, material=fins(kit, [0.6, 0.45, 0.05]))
    grip = bars(kit, b, rng.uniform(0.4, 0.45), 0.1, 0.12, kit.chance(0.5))
    with steered(kit, b):
        kit.add(BOX, grip + [0.07, -0.04, 0.0], (0.02, 0.09, 0.06), (0.8, 0.8), material=b.dark, mirror=True)
    if kit.chance(0.6):
        alloy = flat(kit, [0.5] * 3, 0.5) if kit.chance(0.7) else b.dark
        kit.add(BOX, (-b.base - 0.02, 0.31, z - 0.17), (0.22, 0.12, 0.18), (1, 0.95), material=alloy, mirror=True)
        kit.between((-b.base - 0.02, -0.22, z - 0.06), (-b.base - 0.02, 0.22, z - 0.06), 0.016, material=b.dark)
        if kit.chance(0.6):
            kit.add(BOX, (-b.base - 0.16, 0, z + 0.2), (0.18, 0.2, 0.14), material=alloy)
            kit.add(BOX, (-b.base - 0.14, 0, z + 0.05), (0.18, 0.1, 0.015), material=b.dark)
    elif kit.chance(0.7):
        kit.between((0.36, 0.1, 0.3), (0.34, 0.27, 0.48), 0.016, material=b.metal, mirror=True)
        kit.between((0.34, 0.27, 0.48), (0.36, 0.16, z - 0.16), 0.016, material=b.metal, mirror=True)
    kit.add(BOX, (0.12, 0, 0.2), (0.26, 0.14, 0.03), (1.1, 1.2), material=b.metal if kit.chance(0.5) else b.dark)
    finish(kit, b, grip, (-0.98, 0, z + 0.0), (-1.02, 0, z - 0.18))


def dirt(kit):
    """Motocross and enduro bikes with a high guard and number plates, trial bikes with hardly a seat, supermoto on small wheels."""
    rng = kit.rng
    kind = rng.choice(["cross", "cross", "enduro", "trial", "supermoto"])
    trial = kind == "trial"
    radii = (0.3, 0.3) if kind == "supermoto" else (0.35, 0.33)
    halves = (0.058, 0.075) if kind == "supermoto" else (0.042, 0.055)
    b = chassis(kit, rng.uniform(0.72, 0.76) if not trial else 0.66, radii, halves, rng.uniform(24, 28), rng.uniform(1.06, 1.12) if not trial else 0.98, 0.94 if not trial else 0.72, "wire", rng.choice(["usd", "gaiter"]), knobbly=kind != "supermoto")
    b = b._replace(pivot=np.array([-b.base + 0.56, 0, 0.42]))
    z = b.saddle
    frame(kit, b, rng.choice(["cradle", "cradle", "beam"]), rng.choice([0, 1]) and b.metal or flat(kit, b.second.first), (-b.base * 0.85, 0.06, z - 0.02 if not trial else 0.72))
    start = motor(kit, b, rng.choice(["two", "single"]), 0.07)
    exhaust(kit, b, start, "dirt")
    back = b.head - [0.08, 0, 0.05]
    if trial:
        section(kit, -0.2, back[0], (z - 0.07, z, 0.07), (back[2] - 0.16, back[2] - 0.02, 0.06), b.paint)
        section(kit, -b.base - 0.3, -0.18, (z + 0.08, z + 0.1, 0.08), (z - 0.05, z + 0.01, 0.07), b.paint)
    else:
        section(kit, -0.1, back[0] + 0.02, (z - 0.14, z + 0.02, 0.08), (z - 0.1, back[2] + 0.02, 0.12), b.paint)
        slab(kit, z - 0.36, z - 0.02, (0.22, 0.36, 0.15), (0.06, 0.42, 0.19), b.paint if kit.chance(0.6) else b.second)
        section(kit, -0.64, 0.12, (z - 0.02, z + 0.06, 0.09), (z - 0.04, z + 0.04, 0.08), b.hide if kit.chance(0.5) else b.dark)
        section(kit, -b.base - rng.uniform(0.25, 0.34), -0.35, (z + 0.03, z + 0.06, 0.08), (z - 0.1, z - 0.0, 0.1), b.paint)
        plates = flat(kit, rng.choice([[0.85] * 3, [0.8, 0.6, 0.03], [0.03] * 3]))._replace(pattern=WRITING, frequency=9.0)
        kit.add(BOX, (-0.42, 0.12, z - 0.14), (0.17, 0.012, 0.1), (0.8, 1), (-0.06, 0), material=plates, mirror=True)
    with steered(kit, b):
        foot = np.array([b.base, 0, b.radii[0]])
        high = (foot + b.up * (b.radii[0] + rng.uniform(0.12, 0.18))) if not trial else foot + b.up * (b.radii[0] + 0.06)
        kit.between(high + [-0.1, 0, 0.02], high + [0.14, 0, 0.03], (0.014, 0.07), BOX, material=b.paint)
        kit.between(high + [0.12, 0, 0.03], high + [0.42, 0, -0.05], (0.012, 0.068), BOX, 0.75, b.paint)
        kit.between(high + [-0.1, 0, 0.025], high + [-0.24, 0, -0.08], (0.012, 0.068), BOX, 0.9, b.paint)
        kit.add(BOX, b.head + [0.07, 0, -0.06], (0.018, 0.1, 0.12), (0.9, 0.85), rotation=turn("y", -b.rake), material=b.paint if kind == "enduro" or trial else plates)
        if kind == "enduro":
            kit.add(BOX, b.head + [0.09, 0, -0.08], (0.02, 0.065, 0.05), rotation=turn("y", -b.rake), material=flat(kit, WHITE, 0.6))
    grip = bars(kit, b, 0.4, rng.uniform(0.09, 0.13), 0.1, False)
    with steered(kit, b):
        knee = b.head + [-0.01, 0.18, 0.1]
        kit.between(knee * [1, -1, 1], knee, 0.022, material=b.paint)
        if kit.chance(0.5):
            kit.add(BOX, grip + [0.07, -0.04, 0], (0.02, 0.09, 0.045), (0.8, 0.8), material=b.paint, mirror=True)
    kit.between(b.pivot + [-0.04, 0, 0.02], b.pivot + [-0.12, 0, z - b.pivot[2] - 0.12], 0.042, material=fins(kit, [0.65, 0.08, 0.03] if kit.chance(0.5) else [0.6, 0.5, 0.05]))
    finish(kit, b, grip, (-b.base - 0.12, 0, z - 0.01 if not trial else z + 0.03), (-b.base - 0.28, 0, z - 0.2) if kind == "enduro" else None, rng.choice(["side", "side", "none"]))


def moped(kit):
    """Mopeds with pedals, a tank or a step through, and small utility bikes with leg shields and rack."""
    rng = kit.rng
    step = kit.chance(0.6)
    b = chassis(kit, rng.uniform(0.57, 0.63), (0.29, 0.29), (0.033, 0.036), rng.uniform(24, 28), 0.9, rng.uniform(0.74, 0.79), "wire" if kit.chance(0.8) else "cast", "tele")
    z = b.saddle
    b = b._replace(pivot=np.array([-0.1, 0, 0.34]))
    neck = b.head - b.up * 0.14
    kit.add(BOX, (0.0, 0, 0.3), (0.14, 0.07, 0.09), (0.85, 0.9), material=b.engine)
    kit.add(CYL, (0.18, 0, 0.33), (0.065, 0.065, 0.09), rotation=turn("y", 80), material=fins(kit))
    kit.add(CYL, (0.0, 0, 0.31), (0.08, 0.08, 0.11), rotation=ALONG_Y, material=b.metal if kit.chance(0.5) else b.engine)
    if step:
        kit.between(neck, (0.1, 0, 0.42), (0.06, 0.05), BOX, 1.2, b.paint)
        kit.between((0.14, 0, 0.43), (-0.26, 0, 0.5), (0.07, 0.06), BOX, 1.1, b.paint)
        kit.between((-0.18, 0, 0.46), (-0.26, 0, z - 0.04), (0.11, 0.09), BOX, 0.9, b.paint)
        if kit.chance(0.5):
            kit.between((0.36, 0.16, 0.72), (0.16, 0.17, 0.26), (0.015, 0.12), BOX, 0.8, flat(kit, [0.75, 0.74, 0.68]), True)
            kit.between((0.36, -0.12, 0.7), (0.36, 0.12, 0.7), 0.03, BOX, material=b.paint)
    else:
        kit.between(neck, (-0.28, 0, 0.62), 0.03, material=b.paint)
        kit.between(neck - b.up * 0.06, (0.05, 0, 0.36), 0.025, material=b.paint)
        kit.between((-0.1, 0, 0.36), (-0.26, 0, z - 0.04), 0.03, material=b.paint)
        kit.add(BALL, (0.08, 0, 0.72), (0.24, 0.1, 0.1), rotation=turn("y", -8), material=b.paint)
        kit.add(BOX, (-0.1, 0, 0.5), (0.1, 0.06, 0.14), material=b.dark)
    kit.between((-0.24, 0.05, z - 0.12), (-b.base - 0.05, 0.06, z - 0.1), 0.016, material=b.paint, mirror=True)
    shocks(kit, b, (-b.base * 0.75, z - 0.1))
    if kit.chance(0.5):
        slab(kit, z - 0.03, z + 0.05, (-0.66, -0.1, 0.11), (-0.64, -0.12, 0.1), b.hide)
    else:
        kit.add(BALL, (-0.26, 0, z + 0.02), (0.16, 0.12, 0.06), material=b.hide)
        kit.add(BOX, (-b.base - 0.02, 0, z - 0.04), (0.2, 0.1, 0.012), material=b.metal, cut=(BARS, 14, 0.4))
        kit.between((-b.base, 0.06, z - 0.1), (-b.base - 0.1, 0.08, z - 0.04), 0.012, material=b.metal, mirror=True)
        if kit.chance(0.4):
            kit.add(BOX, (-b.base - 0.05, 0, z + 0.12), (0.18, 0.2, 0.15), material=kit.material(pattern=rng.choice([PLAIN, WRITING])))
    front_guard(kit, b, 15, 165, 4, b.paint)
    rear_guard(kit, b, 15, 165, 4, b.paint)
    round_lamp(kit, b, 0.075, 0.06, 0.12)
    kit.between((0.16, -0.06, 0.27), (-0.1, -0.12, 0.2), 0.018, material=b.metal)
    kit.between((-0.08, -0.12, 0.2), (-b.base - 0.1, -0.13, 0.26), 0.036, material=b.metal)
    grip = bars(kit, b, rng.uniform(0.3, 0.34), 0.1, 0.16, kit.chance(0.7))
    if kit.chance(0.5):
        for way in (1, -1):
            end = np.array([way * 0.14, way * 0.13, 0.3 - way * 0.09])
            kit.between((0, way * 0.12, 0.3), end, 0.012, material=b.metal)
            kit.add(BOX, end + [0, way * 0.06, 0], (0.035, 0.05, 0.014), material=b.dark)
    finish(kit, b, grip, (-b.base - 0.26, 0, 0.5), None, rng.choice(["side", "centre"]))


def small_scooter(kit):
    """A classic step-through scooter with cowls at the sides, or one of plastic of today, also the sharp-edged electric sort."""
    rng = kit.rng
    classic = kit.chance(0.55)
    paint, dark, metal = (kit.material(base=rng.choice([[0.75, 0.7, 0.55], [0.3, 0.55, 0.5], [0.5, 0.05, 0.05], [0.75] * 3, [0.25, 0.4, 0.6], [0.7, 0.55, 0.15]]), pattern=PLAIN, gloss=0.5) if classic and kit.chance(0.6) else lacquer(kit)), kit.material(dark=True, pattern=PLAIN), chrome(kit)
    b = scooter_base(kit, rng.uniform(0.61, 0.66), rng.uniform(0.2, 0.235), 0.05, rng.uniform(0.93, 1.0), paint, dark, metal)
    z, base, radius = b.saddle, b.base, b.radii[0]
    shield = b.head[0] - 0.03
    kit.between((shield - 0.02, 0, b.head[2] - 0.06), (shield + 0.07, 0, 0.3), (0.02, rng.uniform(0.2, 0.26)), BOX, 0.9, paint)
    kit.add(BOX, (0.08, 0, 0.285), (0.34, 0.2, 0.025), material=paint)
    kit.add(BOX, (0.08, 0, 0.315), (0.3, 0.17, 0.008), material=kit.material(base=[0.04] * 3, pattern=RIBS, frequency=25, second=[0.12] * 3))
    kit.add(BOX, (0.05, 0, 0.24), (0.34, 0.08, 0.04), material=dark)
    if classic:
        kit.between((-0.2, 0, 0.28), (-0.22, 0, z - 0.04), (0.06, 0.15), BOX, 0.85, paint)
        kit.add(BALL, (-0.52, 0.15, 0.5), (0.36, 0.11, 0.19), rotation=turn("y", 6), material=paint, mirror=True)
        section(kit, -base - 0.28, -0.2, (0.42, 0.6, 0.1), (0.45, z - 0.02, 0.15), paint)
        with steered(kit, b):
            arch(kit, base, 0, radius, radius + 0.045, 0.075, -5, 160, 4, paint)
            kit.add(BALL, b.head + [0.02, 0, 0.05], (0.13, 0.12, 0.09), material=paint)
            kit.add(CYL, b.head + [0.12, 0, 0.05], (0.068, 0.068, 0.03), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        kit.add(BALL, (shield + 0.06, 0, 0.62), (0.05, 0.05, 0.16), material=metal if kit.chance(0.4) else paint)
    else:
        section(kit, shield - 0.02, base - 0.02, (0.42, b.head[2] - 0.06, 0.22), (0.5, 0.78, 0.1), paint)
        kit.add(BOX, (base - 0.08, 0.07, 0.72), (0.05, 0.05, 0.05), shift=(-0.03, 0), material=flat(kit, WHITE, 0.6), mirror=True)
        slab(kit, 0.28, z - 0.04, (-0.5, -0.2, 0.15), (-0.66, -0.16, 0.15), paint)
        section(kit, -base - 0.3, -0.3, (0.62, z + 0.02, 0.07), (0.45, z - 0.03, 0.18), paint)
        with steered(kit, b):
            arch(kit, base, 0, radius, radius + 0.035, 0.07, 20, 150, 3, dark)
            kit.add(BOX, b.head + [0.0, 0, 0.04], (0.1, 0.1, 0.07), (0.7, 0.9), material=paint)
    slab(kit, z - 0.04, z + 0.05, (-0.78, -0.12, 0.13), (-0.74, -0.14, 0.11), hide(kit))
    arch(kit, -base, 0, radius, radius + 0.04, 0.07, 70, 190, 3, dark)
    scooter_end(kit, b, classic)


def maxi_scooter(kit):
    """A maxi scooter: long, faired, with screen, stepped seat, big wheels; some with two wheels before."""
    rng = kit.rng
    paint, dark, metal = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit)
    twin = kit.chance(0.35)
    b = scooter_base(kit, rng.uniform(0.75, 0.8), rng.uniform(0.26, 0.29), 0.06, 1.0, paint, dark, metal, 0.2 if twin else 0.0)
    z, base, radius = b.saddle, b.base, b.radii[0]
    section(kit, 0.32, 0.55, (0.34, 1.0, 0.24), (0.48, 1.02, 0.27), paint)
    section(kit, 0.54, base + 0.1, (0.56, 1.02, 0.27), (0.72, 0.82, 0.1), paint)
    kit.between((0.66, 0, 0.98), (0.42, 0, rng.uniform(1.22, 1.42)), (0.012, 0.2), BOX, 0.75, glazing(kit))
    kit.add(BOX, (base + 0.0, 0.1, 0.8), (0.09, 0.06, 0.045), (0.8, 0.8), rotation=turn("z", -30), material=flat(kit, WHITE, 0.6), mirror=True)
    section(kit, -0.1, 0.36, (0.26, 0.6, 0.13), (0.28, 0.72, 0.15), paint)
    kit.add(BOX, (0.12, 0, 0.28), (0.36, 0.24, 0.05), (1, 1), material=dark)
    slab(kit, 0.26, z - 0.03, (-0.48, -0.04, 0.17), (-0.62, -0.06, 0.19), paint if kit.chance(0.6) else dark)
    section(kit, -base - 0.32, -0.35, (z - 0.04, z + 0.1, 0.08), (0.5, z - 0.01, 0.2), paint)
    slab(kit, z - 0.04, z + 0.06, (-0.5, -0.02, 0.17), (-0.48, -0.04, 0.15), b.hide)
    slab(kit, z - 0.02, z + 0.15, (-0.95, -0.46, 0.15), (-0.92, -0.5, 0.13), b.hide)
    with steered(kit, b):
        kit.add(BOX, b.head + [-0.02, 0, 0.04], (0.09, 0.12, 0.06), (0.7, 0.9), material=dark)
        arch(kit, base, 0.2 if twin else 0, radius, radius + 0.035, 0.08, 20, 150, 3, paint)
    arch(kit, -base, 0, radius, radius + 0.04, 0.08, 50, 185, 3, dark)
    scooter_end(kit, b, False)


def scooter_base(kit, base, radius, half, crown, paint, dark, metal, apart=0.0):
    """Wheels, fork and the motor beside the rear wheel of a scooter; `apart`: half the track of two front wheels."""
    rng = kit.rng
    rake = rng.uniform(24, 28)
    up = np.array([-np.sin(np.radians(rake)), 0, np.cos(np.radians(rake))])
    head = np.array([base, 0, radius]) + up * (crown - radius) / up[2]
    steer = 0.0 if apart or kit.chance(0.55) else rng.uniform(-25, 25)
    b = Bike(base, (radius, radius), (half, half), rake, head, up, rng.uniform(0.74, 0.8), np.array([-0.2, 0, 0.28]), steer, paint, paint, dark, metal, metal, hide(kit))
    cut = (SPOKES, int(rng.choice([3, 5, 6, 8])), rng.uniform(0.2, 0.32))
    tyre = rubber(kit)
    open_wheel(kit, (-base, 0, radius), radius, half, tyre, metal, cut)
    section(kit, -base - 0.05, -0.2, (radius - 0.09, radius + 0.09, 0.05), (radius - 0.08, radius + 0.1, 0.07), metal if kit.chance(0.5) else dark, half + 0.06)
    kit.between((-base + 0.02, half + 0.06, radius + 0.05), (-base + 0.08, half + 0.06, 0.62), 0.03, material=fins(kit, [0.3] * 3))
    kit.between((-0.3, -0.12, radius), (-base - 0.14, -half - 0.08, radius + 0.09), (0.06, 0.045), taper=1.15, material=dark if kit.chance(0.6) else metal)
    with steered(kit, b):
        open_wheel(kit, (base, apart, radius), radius, half, tyre, metal, cut, bool(apart))
        side = apart - half - 0.03 if apart else half + 0.03
        kit.between((base, side, radius), np.array([base, side, radius]) + up * 0.3, 0.024, material=metal, mirror=True)
        top = np.array([base, 0, radius]) + up * 0.29
        kit.add(BOX, top, (0.04, max(side, half + 0.03) + 0.03, 0.03), rotation=turn("y", -rake), material=dark)
        kit.between(top, head, 0.035, material=dark)
    return b


def scooter_end(kit, b, classic):
    """Bars, lamp, plate, rack or case and stand of a scooter."""
    rng = kit.rng
    bars(kit, b._replace(head=b.head + [-0.01, 0, 0.05]) if not b.steer else b, rng.uniform(0.3, 0.35), 0.05, 0.12)
    kit.add(BOX, (-b.base - 0.29, 0, 0.62 if classic else b.saddle - 0.02), (0.03, 0.07, 0.03), material=flat(kit, RED))
    kit.between((-b.base - 0.2, 0, 0.5), (-b.base - 0.3, 0, 0.36), (0.012, 0.07), BOX, material=b.dark)
    kit.add(BOX, (-b.base - 0.3, 0, 0.42), (0.008, 0.08, 0.06), rotation=turn("y", 25), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=30, second=[0.02] * 3))
    if kit.chance(0.4):
        kit.add(BOX, (-b.base - 0.2, 0, b.saddle + 0.03), (0.16, 0.09, 0.015), material=b.metal)
        kit.between((-b.base - 0.06, 0.08, b.saddle - 0.08), (-b.base - 0.2, 0.08, b.saddle + 0.03), 0.012, material=b.metal, mirror=True)
        if kit.chance(0.6):
            kit.add(BOX, (-b.base - 0.2, 0, b.saddle + 0.19), (0.17, 0.19, 0.15), (0.9, 0.9), material=kit.material())
    if kit.chance(0.5):
        lean(kit, rng.uniform(5, 9), (-0.1, 0.1, 0.24), b.dark)
    else:
        kit.between((-0.2, 0.08, 0.26), (-0.3, 0.15, 0.0), 0.016, material=b.dark, mirror=True)


def trike(kit):
    """Three wheels: a touring motorcycle with two wheels behind under fenders, or a roadster with two before on arms."""
    rng = kit.rng
    paint, dark, metal, tyre, cloth = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), hide(kit)
    if kit.chance(0.5):
        radius, base, track = 0.29, 0.85, rng.uniform(0.6, 0.7)
        rims(kit, base, track, radius, 0.08, tyre, metal, int(rng.integers(5, 9)))
        for dz in (-0.06, 0.1):
            kit.between((base - 0.12, 0.15, radius + dz), (base, track - 0.06, radius + dz * 0.6), (0.03, 0.02), BOX, material=dark, mirror=True)
            kit.between((base + 0.12, 0.15, radius + dz), (base, track - 0.06, radius + dz * 0.6), (0.03, 0.02), BOX, material=dark, mirror=True)
        kit.between((base, 0.18, 0.62), (base, track - 0.1, radius + 0.02), 0.035, material=fins(kit, [0.6, 0.1, 0.03]), mirror=True)
        arch(kit, base, track, radius, radius + 0.04, 0.1, 30, 150, 3, paint)
        open_wheel(kit, (-base, 0, 0.3), 0.3, 0.11, tyre, metal, (SPOKES, 5, 0.2))
        kit.between((-0.3, 0.15, 0.36), (-base, 0.15, 0.3), (0.04, 0.02), BOX, material=dark, mirror=True)
        section(kit, 0.2, base + 0.05, (0.2, 0.82, 0.3), (0.24, 0.72, 0.28), paint)
        section(kit, base + 0.04, base + 0.42, (0.24, 0.72, 0.28), (0.38, 0.5, 0.14), paint)
        section(kit, -0.4, 0.22, (0.22, 0.6, 0.2), (0.2, 0.8, 0.28), dark)
        kit.add(BALL, (0.12, 0, 0.8), (0.36, 0.19, 0.15), material=paint)
        kit.add(BOX, (base + 0.3, 0.15, 0.56), (0.08, 0.06, 0.05), (0.8, 0.8), rotation=turn("z", -20), material=flat(kit, WHITE, 0.6), mirror=True)
        kit.add(BOX, (base + 0.36, 0, 0.42), (0.05, 0.12, 0.05), material=dark)
        kit.between((0.55, 0, 0.78), (0.36, 0, 1.15), (0.012, 0.22), BOX, 0.8, glazing(kit))
        kit.between((0.4, 0.05, 0.82), (0.2, 0.34, 0.98), 0.02, material=dark, mirror=True)
        seat_z, rear = 0.74, -0.85
    else:
        radius, base, track = 0.31, 0.95, rng.uniform(0.5, 0.6)
        b = chassis(kit, base, (0.32, 0.3), (0.065, 0.1), 32, 1.0, 0.72, "cast", "tele", steer=False)
        kit.primitives[:6] = []
        motor(kit, b, "vtwin", 0.05, 1.2)
        rims(kit, -base + 0.1, track, radius, 0.12, tyre, metal, int(rng.integers(5, 9)))
        kit.between((-base + 0.1, -track, radius), (-base + 0.1, track, radius), 0.05, material=dark)
        arch(kit, -base + 0.1, track, radius, radius + 0.06, 0.15, 10, 165, 4, paint)
        section(kit, -base - 0.3, -0.4, (0.4, 0.76, track * 0.7), (0.3, 0.66, 0.2), paint)
        kit.add(BOX, (-0.1, 0, 0.4), (0.5, 0.12, 0.14), material=dark)
        kit.between(b.head - b.up * 0.14, (0.1, 0, 0.72), (0.06, 0.04), BOX, material=dark)
        kit.between(b.head - b.up * 0.2, (0.38, 0.1, 0.32), 0.03, material=dark, mirror=True)
        kit.add(BALL, (0.16, 0, 0.84), (0.34, 0.18, 0.13), rotation=turn("y", -14), material=paint)
        kit.add(BOX, (0.1, 0, 0.6), (0.2, 0.1, 0.16), material=dark)
        front_guard(kit, b, 10, 160, 4, paint)
        round_lamp(kit, b, 0.1, 0.14, 0.16)
        bars(kit, b, 0.4, 0.16, 0.3)
        if kit.chance(0.5):
            kit.between(b.head + [0.12, 0, 0.05], b.head + [0, 0, 0.5], (0.012, 0.26), BOX, 0.85, glazing(kit))
        seat_z, rear = 0.72, -base - 0.2
    slab(kit, seat_z - 0.14, seat_z + 0.02, (-0.46, -0.05, 0.19), (-0.45, -0.06, 0.18), cloth)
    slab(kit, seat_z - 0.1, seat_z + 0.14, (-0.86, -0.42, 0.17), (-0.84, -0.46, 0.15), cloth)
    section(kit, rear - 0.05, -0.3, (seat_z - 0.05, seat_z + 0.04, 0.1), (seat_z - 0.22, seat_z - 0.04, 0.17), paint)
    if kit.chance(0.6):
        kit.add(BOX, (-0.9, 0, seat_z + 0.22), (0.05, 0.16, 0.2), (0.8, 0.9), (-0.04, 0), material=cloth)
    kit.add(BOX, (rear - 0.1, 0.09, seat_z - 0.02), (0.05, 0.05, 0.03), material=flat(kit, RED), mirror=True)


def dispatch(kit):
    """Military dispatch bikes and outfits, classic or drab: girder fork, sprung saddle, bags, jerrycan; with a sidecar as it comes."""
    rng = kit.rng
    sidecar = kit.chance(0.6)
    service = kit.chance(0.6)
    paint = drab(kit) if service else lacquer(kit)
    b = chassis(kit, rng.uniform(0.7, 0.74), (0.33, 0.33), (0.048, 0.052), rng.uniform(26, 29), 0.96, rng.uniform(0.72, 0.76), "wire", rng.choice(["girder", "tele"]), paint, service, not sidecar)
    z = b.saddle
    start = motor(kit, b, rng.choice(["boxer", "single", "vtwin"]))
    frame(kit, b, "cradle", b.paint if service else b.dark, (-b.base, 0.075, 0.42))
    kit.between((b.pivot[0], -0.12, 0.24), (-b.base - 0.2, -0.13, 0.3), 0.042, material=b.dark)
    kit.between(start * [1, 0, 1] + [0, -0.1, 0], (0.3, -0.12, 0.26), 0.024, material=b.metal)
    kit.between((0.3, -0.12, 0.26), (b.pivot[0] + 0.02, -0.12, 0.24), 0.026, material=b.metal)
    kit.add(BALL, (0.12, 0, z + 0.06), (0.28, 0.13, 0.12), rotation=turn("y", -8), material=b.paint)
    kit.add(BOX, (0.1, 0, z - 0.0), (0.22, 0.1, 0.07), rotation=turn("y", -8), material=b.paint)
    kit.add(BALL, (-0.28, 0, z + 0.05), (0.18, 0.14, 0.055), material=b.hide)
    kit.add(BOX, (-0.26, 0, z - 0.06), (0.1, 0.08, 0.08), material=b.dark)
    rear_guard(kit, b, 15, 165, 3, b.paint)
    front_guard(kit, b, 20, 170, 3, b.paint)
    round_lamp(kit, b, 0.09)
    grip = bars(kit, b, 0.38, 0.08, 0.22, False)
    bag = b.hide if kit.chance(0.6) else b.paint
    if sidecar:
        y, wheel_y = -rng.uniform(0.7, 0.78), -1.16
        kit.add(CYL, (-0.15, wheel_y, 0.31), (0.31, 0.31, 0.045), rotation=ALONG_Y, material=rubber(kit), cut=RING)
        kit.add(CYL, (-0.15, wheel_y, 0.31), (0.275, 0.275, 0.03), rotation=ALONG_Y, material=b.metal, cut=(SPOKES, 16, 0.1))
        slab(kit, 0.3, 0.68, (-0.62, 0.3, 0.22), (-0.62, 0.36, 0.27), b.paint, y)
        section(kit, 0.34, rng.uniform(0.85, 1.05), (0.3, 0.68, 0.25), (0.44, 0.6, 0.08), b.paint, y)
        section(kit, -0.95, -0.61, (0.5, 0.68, 0.14), (0.3, 0.7, 0.26), b.paint, y)
        kit.add(BOX, (-0.1, y, 0.69), (0.26, 0.21, 0.02), material=b.dark)
        kit.add(BOX, (-0.42, y, 0.78), (0.07, 0.22, 0.16), (0.7, 0.9), material=b.hide)
        kit.add(BOX, (0.26, y, 0.78), (0.012, 0.2, 0.1), (1, 0.85), (-0.05, 0), material=glazing(kit))
        for x in (0.3, -0.3):
            kit.between((x, -0.05, 0.3), (x, wheel_y + 0.12, 0.32), 0.022, material=b.dark)
        kit.between((-0.15, y, 0.32), (-0.15, wheel_y, 0.31), 0.025, material=b.dark)
        kit.add(BOX, (-0.15, wheel_y, 0.65), (0.3, 0.075, 0.012), material=b.paint)
        kit.add(BOX, (-0.15, wheel_y + 0.1, 0.6), (0.2, 0.035, 0.05), material=b.paint)
        if kit.chance(0.5):
            kit.add(CYL, (-0.86, y, 0.72), (0.27, 0.27, 0.05), material=b.dark)
    else:
        kit.add(BOX, (-b.base, 0.19, 0.58), (0.18, 0.09, 0.15), (0.95, 0.9), material=bag, mirror=True)
        kit.add(BOX, (-b.base + 0.03, 0, 0.73), (0.22, 0.14, 0.015), material=b.dark)
        if kit.chance(0.5):
            kit.add(CYL, (-b.base + 0.02, 0, 0.82), (0.09, 0.09, 0.22), rotation=ALONG_Y, material=bag)
    finish(kit, b, grip, (-b.base - 0.32, 0, 0.52), None, "none" if sidecar else rng.choice(["side", "centre"]))


def motorbike(kit):
    """Sport bikes, naked bikes, cafe racers, scramblers, classics, cruisers, baggers, choppers, tourers, adventure, cross, trial and dispatch bikes, mopeds, scooters, three-wheelers, sidecars."""
    makers = [sport, sport, roadster, roadster, roadster, cruiser, cruiser, tourer, adventure, adventure, dirt, dirt, moped, small_scooter, maxi_scooter, trike, dispatch, dispatch]
    kit.rng.choice(makers)(kit)


# Light vehicles.


def fat_wheels(kit, x, y, radius, half, tyre, hub, spokes=0):
    """A pair of tyres with rounded shoulders on small rims."""
    kit.add(CYL, (x, y, radius), (radius, radius, half * 0.7), rotation=ALONG_Y, material=tyre, mirror=True)
    kit.add(CYL, (x, y, radius), (radius * 0.9, radius * 0.9, half), rotation=ALONG_Y, material=tyre, mirror=True)
    kit.add(CYL, (x, y, radius), (radius * 0.52, radius * 0.52, half * 1.04), rotation=ALONG_Y, material=hub, mirror=True, cut=(SPOKES, spokes, 0.3) if spokes else (0, 1, 1))


def treads(kit):
    return kit.material(base=[0.03] * 3, pattern=CHECKER, frequency=kit.rng.uniform(20, 32), second=[0.008] * 3, gloss=0.02)


def quad(kit):
    """A quad: a sporty one with pointed nose and bumper, or a farmer's with racks."""
    rng = kit.rng
    coat, dark, tyre, metal = lacquer(kit), kit.material(dark=True, pattern=PLAIN), treads(kit), chrome(kit)
    work = kit.chance(0.5)
    base, track, radius = rng.uniform(0.6, 0.68), rng.uniform(0.42, 0.5), rng.uniform(0.28, 0.33)
    z = 2 * radius
    for x, half in ((base, 0.1), (-base, 0.13)):
        fat_wheels(kit, x, track, radius * (1 if work or x > 0 else 0.92), half, tyre, metal if kit.chance(0.6) else dark, int(rng.choice([0, 4, 5, 6, 8])))
    kit.between((-base, -track, radius * 0.95), (-base, track, radius * 0.95), 0.05, material=dark)
    for dx in (-0.12, 0.12):
        kit.between((base * 0.9 + dx, 0.1, radius), (base, track - 0.06, radius), 0.018, material=metal, mirror=True)
    kit.between((base * 0.85, 0.13, z + 0.12), (base * 0.98, track * 0.68, radius + 0.04), 0.035, material=fins(kit, [0.6, 0.1, 0.03]), mirror=True)
    kit.add(BOX, (0.0, 0, radius + 0.1), (base * 0.85, 0.12, 0.13), material=dark)
    kit.add(BOX, (0, 0, radius + 0.16), (0.2, 0.17, 0.14), material=fins(kit))
    nose = base + radius * (1.0 if work else 1.15)
    if work:
        section(kit, 0.3, nose, (z - 0.04, z + 0.16, 0.34), (z - 0.06, z + 0.08, 0.3), coat)
        section(kit, -nose, -0.35, (z - 0.06, z + 0.1, 0.34), (z - 0.06, z + 0.13, 0.32), coat)
        for x in (base, -base):
            arch(kit, x, track, radius + 0.02, radius + 0.08, 0.13, 25, 155, 3, coat)
            kit.add(BOX, (x * 1.02, 0, z + 0.25), (0.3, track * 0.95, 0.012), material=dark, cut=(BARS, 12, 0.3))
            kit.between((x, track * 0.5, z + 0.05), (x, track * 0.6, z + 0.25), 0.014, material=dark, mirror=True)
    else:
        section(kit, 0.25, nose, (z - 0.06, z + 0.16, 0.14), (z - 0.06, z - 0.0, 0.07), coat)
        section(kit, base - radius * 1.3, base + radius, (z + 0.01, z + 0.06, 0.18), (z + 0.03, z + 0.07, 0.16), coat, track * 0.56, True)
        section(kit, -nose, -base + radius * 1.3, (z + 0.1, z + 0.13, 0.34), (z - 0.0, z + 0.04, 0.3), coat)
    kit.add(BALL, (0.2, 0, z + 0.14), (0.24, 0.14, 0.13), material=coat)
    section(kit, -base - 0.1, 0.08, (z + 0.02, z + 0.2, 0.14), (z - 0.06, z + 0.14, 0.12), hide(kit))
    kit.add(BOX, (0.02, track * 0.78, radius * 0.75), (base - radius * 0.8, 0.11, 0.022), material=dark, mirror=True)
    kit.between((0.0, -track * 0.7, radius * 0.75), (0, track * 0.7, radius * 0.75), 0.03, material=dark)
    kit.between((0.42, 0, z + 0.05), (0.32, 0, z + 0.36), 0.03, material=dark)
    kit.between((0.32, 0, z + 0.36), (0.24, 0.38, z + 0.42), 0.018, material=dark, mirror=True)
    kit.add(BOX, (0.35, 0, z + 0.36), (0.05, 0.1, 0.06), (0.7, 0.9), material=coat)
    for a, e in (((nose - 0.15, 0.1, radius), (nose + 0.08, 0.13, z - 0.05)), ((nose - 0.1, -0.14, z - 0.06), (nose + 0.08, -0.14, z - 0.05))):
        kit.between(a, e, 0.016, material=metal, mirror=True)
    kit.between((nose + 0.08, -0.15, z - 0.05), (nose + 0.08, 0.15, z - 0.05), 0.018, material=metal)
    kit.add(BALL, (nose - 0.08, 0.1 if not work else 0.22, z + 0.03), (0.06, 0.045, 0.035), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.between((-0.1, -0.17, z - 0.08), (-base - 0.2, -0.17, z + 0.02), 0.05, material=metal)
    kit.add(BOX, (-nose + 0.03, 0, z + 0.06), (0.03, 0.06, 0.03), material=flat(kit, RED))


def buggy(kit):
    """A side-by-side with doors, cage, roof and a bed behind, or a sand rail: bare tubes, engine and big wheels behind."""
    rng = kit.rng
    coat, dark, tyre, metal, cloth = lacquer(kit), kit.material(dark=True, pattern=PLAIN), treads(kit), chrome(kit), hide(kit)
    rail = kit.chance(0.4)
    tube = (coat if kit.chance(0.7) else metal) if rail else (dark if kit.chance(0.7) else coat)
    base, track, radius = rng.uniform(1.05, 1.25), rng.uniform(0.68, 0.78), rng.uniform(0.34, 0.4)
    small = radius * (0.85 if rail else 1)
    fat_wheels(kit, base, track, small, 0.09 if rail else 0.13, tyre, metal, int(rng.integers(4, 8)))
    fat_wheels(kit, -base, track, radius, 0.17 if rail else 0.14, tyre, metal, int(rng.integers(4, 8)))
    floor, belt, roof, wide = 0.38, 0.88, rng.uniform(1.65, 1.8), 0.62
    kit.add(BOX, (0, 0, floor), (base * 0.9, 0.45, 0.05), material=dark)
    for x, r in ((base, small), (-base, radius)):
        for dx in (-0.16, 0.12):
            kit.between((x + dx, 0.25, r + 0.06), (x, track - 0.08, r), 0.022, material=metal, mirror=True)
        kit.between((x * 0.95, 0.4, belt - 0.05), (x, track - 0.16, r + 0.03), 0.04, material=fins(kit, rng.choice([[0.6, 0.1, 0.03], [0.6, 0.5, 0.05], [0.1, 0.2, 0.5]])), mirror=True)
    front, back = 0.35, -0.55
    kit.between((front + 0.4, wide, belt), (front, wide * 0.85, roof), 0.028, material=tube, mirror=True)
    kit.between((front, wide * 0.85, roof), (back, wide * 0.85, roof), 0.028, material=tube, mirror=True)
    kit.between((back, wide * 0.85, roof), (back - 0.12, wide * 0.95, floor), 0.028, material=tube, mirror=True)
    kit.between((back, wide * 0.85, roof - 0.05), (-base - 0.1, wide * 0.7, belt), 0.026, material=tube, mirror=True)
    for x in (front, back):
        kit.between((x, -wide * 0.86, roof), (x, wide * 0.86, roof), 0.028, material=tube)
    kit.add(BOX, (-0.15, 0.3, floor + 0.15), (0.25, 0.2, 0.1), material=cloth, mirror=True)
    kit.add(BOX, (-0.42, 0.3, floor + 0.52), (0.06, 0.2, 0.36), (1, 0.75), (-0.12, 0), material=cloth, mirror=True)
    steering(kit, 0.3, 0.3, belt + 0.06, dark, 0.16)
    if rail:
        nose = base + 0.35
        for z in (floor, belt):
            kit.between((front + 0.4, wide, z), (nose, 0.18, z * 0.5 + 0.22), 0.026, material=tube, mirror=True)
            kit.between((-base - 0.1, wide * 0.7, z), (front + 0.4, wide, z), 0.026, material=tube, mirror=True)
        kit.between((nose, -0.2, 0.42), (nose, 0.2, 0.42), 0.026, material=tube)
        section(kit, 0.5, nose - 0.03, (floor, belt - 0.02, 0.42), (0.38, 0.6, 0.15), coat)
        kit.add(BOX, (-base, 0, 0.55), (0.3, 0.2, 0.18), material=fins(kit))
        kit.add(CYL, (-base, 0.3, 0.55), (0.1, 0.1, 0.1), rotation=ALONG_Y, material=fins(kit), mirror=True)
        kit.add(CYL, (-base - 0.12, 0, 0.8), (0.13, 0.13, 0.12), material=metal)
        kit.between((-base - 0.2, 0.15, 0.5), (-base - 0.42, 0.18, 0.85), 0.04, material=metal, mirror=True)
    else:
        nose = base + radius + 0.05
        section(kit, 0.5, nose, (floor, belt + 0.08, wide * 0.85), (0.5, 0.74, wide * 0.6), coat)
        for x in (base, -base):
            arch(kit, x, track - 0.02, radius + 0.04, radius + 0.1, 0.14, 25, 155, 3, dark if kit.chance(0.5) else coat)
        kit.add(BOX, (0.08, wide, floor + 0.24), (0.42, 0.025, 0.22), (1.1, 1), material=coat, mirror=True)
        section(kit, -base - 0.5, -0.75, (0.62, 0.98, wide), (0.6, 0.98, wide), dark)
        section(kit, -base - 0.52, -0.72, (0.86, 1.0, wide * 1.03), (0.86, 1.02, wide * 1.03), coat)
        kit.add(BOX, (-0.1, 0, roof + 0.04), (0.52, wide * 0.92, 0.03), (0.95, 0.92), material=coat if kit.chance(0.6) else dark)
        kit.add(BOX, (nose - 0.06, 0.26, 0.72), (0.06, 0.12, 0.04), (0.8, 0.8), material=flat(kit, WHITE, 0.6), mirror=True)
        kit.between((nose + 0.02, -0.3, 0.5), (nose + 0.02, 0.3, 0.5), 0.03, material=tube)
        if kit.chance(0.4):
            kit.between((front + 0.36, 0, belt + 0.08), (front + 0.04, 0, roof - 0.05), (0.01, wide * 0.85), BOX, 0.95, glazing(kit))
    if kit.chance(0.5):
        kit.add(BOX, (front + 0.05, 0, roof + 0.07), (0.03, wide * 0.7, 0.04), material=flat(kit, WHITE, 0.6))
    kit.add(BOX, (-base - (0.1 if rail else 0.52), wide * 0.7, belt - 0.05), (0.03, 0.05, 0.05), material=flat(kit, RED), mirror=True)


def snowmobile(kit):
    """A snowmobile: track round its wheels under a tunnel, long saddle, wedge of a hood, screen, two skis on arms."""
    rng = kit.rng
    coat, second, dark, metal = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit)
    track = kit.material(base=[0.015] * 3, pattern=RIBS, frequency=22, second=[0.06] * 3)
    wide, rear, ski_x, apart = 0.2, -rng.uniform(1.25, 1.6), rng.uniform(0.72, 0.85), rng.uniform(0.46, 0.54)
    section(kit, rear + 0.12, 0.1, (0.0, 0.26, wide * 0.9), (0.0, 0.36, wide * 0.9), track)
    kit.add(CYL, (rear + 0.13, 0, 0.14), (0.14, 0.14, wide * 0.9), rotation=ALONG_Y, material=track)
    section(kit, 0.09, 0.38, (0.0, 0.36, wide * 0.9), (0.16, 0.44, wide * 0.9), track)
    kit.add(CYL, (rear + 0.14, wide * 0.86, 0.14), (0.09, 0.09, 0.02), rotation=ALONG_Y, material=metal, mirror=True)
    kit.between((rear + 0.14, wide * 0.88, 0.07), (0.05, wide * 0.88, 0.07), (0.03, 0.02), BOX, material=metal, mirror=True)
    section(kit, rear - 0.1, 0.2, (0.38, 0.44, wide), (0.38, 0.48, wide * 1.1), metal if kit.chance(0.5) else dark)
    kit.add(BOX, (-0.1, 0.3, 0.36), (0.45, 0.1, 0.02), material=dark, mirror=True)
    section(kit, rear + 0.1, 0.02, (0.43, 0.64, 0.15), (0.43, 0.7, 0.13), hide(kit))
    section(kit, -0.02, 0.4, (0.4, 0.78, 0.16), (0.3, 0.88, 0.26), coat)
    section(kit, 0.38, rng.uniform(1.0, 1.15), (0.22, 0.88, 0.34), (0.34, 0.52, 0.16), coat)
    section(kit, 0.1, 0.9, (0.24, 0.5, 0.3), (0.26, 0.46, 0.24), second)
    kit.between((0.6, 0, 0.78), (0.36, 0, rng.uniform(0.98, 1.2)), (0.01, 0.24), BOX, 0.75, glazing(kit))
    kit.add(BOX, (0.86, 0.12, 0.64), (0.08, 0.08, 0.03), rotation=turn("y", 30), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.between((0.2, 0, 0.7), (0.1, 0, 0.98), 0.03, material=dark)
    kit.between((0.1, 0, 0.97), (0.02, 0.36, 1.0), 0.02, material=dark, mirror=True)
    kit.add(BOX, (ski_x - 0.1, apart, 0.025), (0.42, 0.075, 0.015), material=second, mirror=True)
    kit.between((ski_x + 0.3, apart, 0.02), (ski_x + 0.52, apart, 0.16), (0.014, 0.07), BOX, 0.8, second, True)
    kit.between((ski_x + 0.51, apart, 0.16), (ski_x + 0.2, apart, 0.13), (0.01, 0.03), BOX, material=dark, mirror=True)
    kit.between((ski_x + 0.2, apart, 0.13), (ski_x + 0.1, apart, 0.03), (0.01, 0.03), BOX, material=dark, mirror=True)
    kit.between((ski_x, apart, 0.03), (ski_x - 0.06, apart - 0.02, 0.34), 0.032, material=dark, mirror=True)
    for dx, dz in ((-0.18, 0.02), (0.1, 0.02), (-0.04, 0.14)):
        kit.between((ski_x - 0.08 + dx, 0.2, 0.32 + dz), (ski_x - 0.05, apart - 0.02, 0.24 + dz * 0.3), 0.018, material=metal, mirror=True)
    kit.between((ski_x - 0.1, 0.22, 0.56), (ski_x - 0.05, apart - 0.06, 0.26), 0.036, material=fins(kit, [0.6, 0.1, 0.03]), mirror=True)
    kit.add(BOX, (rear + 0.09, 0, 0.57), (0.02, 0.1, 0.03), material=flat(kit, RED))
    kit.between((rear - 0.08, wide * 0.8, 0.42), (rear - 0.2, wide * 0.8, 0.5), 0.014, material=metal, mirror=True)
    kit.between((rear - 0.2, -wide * 0.8, 0.5), (rear - 0.2, wide * 0.8, 0.5), 0.014, material=metal)
    kit.between((rear - 0.02, 0, 0.4), (rear - 0.12, 0, 0.12), (0.008, wide), BOX, material=dark)


def jet_ski(kit):
    """A water scooter with V hull, stepped saddle and cowl with mirrors, alone or on a trailer with wheels and winch post."""
    rng = kit.rng
    coat, second, dark, metal = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit)
    up = 0.34 if kit.chance(0.5) else 0.0
    rear, nose, wide = -1.35, rng.uniform(1.45, 1.65), rng.uniform(0.5, 0.58)
    if up:
        kit.add(BOX, (-0.3, 0.16, up + 0.03), (0.9, 0.05, 0.04), material=kit.material(base=[0.1, 0.1, 0.12], pattern=PLAIN), mirror=True)
        kit.between((-1.3, 0.45, 0.28), (0.7, 0.45, 0.28), 0.035, BOX, material=metal, mirror=True)
        kit.between((0.65, 0.46, 0.28), (1.9, 0, 0.3), 0.035, BOX, material=metal, mirror=True)
        kit.between((1.8, 0, 0.3), (2.3, 0, 0.32), 0.035, BOX, material=metal)
        for x in (-1.2, -0.35, 0.55):
            kit.between((x, -0.45, 0.28), (x, 0.45, 0.28), 0.03, BOX, material=metal)
        kit.between((-0.4, -0.75, 0.24), (-0.4, 0.75, 0.24), 0.03, material=metal)
        fat_wheels(kit, -0.4, 0.74, 0.24, 0.08, rubber(kit), metal)
        arch(kit, -0.4, 0.74, 0.26, 0.3, 0.1, 10, 170, 3, dark)
        kit.between((1.75, 0, 0.3), (1.68, 0, up + 0.5), 0.04, BOX, material=metal)
        kit.between((2.15, 0.07, 0.3), (2.15, 0.07, 0.0), 0.025, material=metal)
    section(kit, rear, 0.4, (up, up + 0.34, wide * 0.55), (up, up + 0.36, wide * 0.55), second)
    slab(kit, up + 0.1, up + 0.36, (rear, 0.5, wide * 0.5), (rear, 0.75, wide), second)
    section(kit, 0.38, nose, (up + 0.02, up + 0.38, wide * 0.7), (up + 0.36, up + 0.5, 0.06), second)
    section(kit, rear - 0.02, 0.6, (up + 0.33, up + 0.4, wide * 1.03), (up + 0.34, up + 0.42, wide * 1.03), dark)
    section(kit, 0.59, nose + 0.03, (up + 0.34, up + 0.46, wide * 1.03), (up + 0.46, up + 0.52, 0.08), coat)
    section(kit, rear + 0.1, 0.5, (up + 0.38, up + 0.5, wide * 0.9), (up + 0.4, up + 0.56, wide * 0.95), coat)
    section(kit, 0.25, nose - 0.12, (up + 0.42, up + 0.86, 0.3), (up + 0.44, up + 0.52, 0.1), coat)
    section(kit, -0.95, 0.2, (up + 0.44, up + 0.7, 0.2), (up + 0.44, up + 0.68, 0.2), coat)
    section(kit, -0.35, 0.28, (up + 0.68, up + 0.8, 0.19), (up + 0.66, up + 0.8, 0.15), dark)
    section(kit, -1.0, -0.3, (up + 0.68, up + 0.88, 0.19), (up + 0.68, up + 0.86, 0.19), hide(kit))
    kit.between((0.45, 0, up + 0.76), (0.28, 0, up + 1.0), (0.08, 0.09), BOX, 0.8, dark)
    kit.between((0.28, 0, up + 0.98), (0.16, 0.38, up + 1.02), 0.022, material=dark, mirror=True)
    kit.between((0.56, 0.26, up + 0.76), (0.5, 0.42, up + 0.84), 0.02, material=coat, mirror=True)
    kit.add(BALL, (0.5, 0.42, up + 0.85), (0.04, 0.09, 0.06), material=dark, mirror=True)
    kit.between((0.66, 0, up + 0.8), (0.5, 0, up + 0.93), (0.01, 0.18), BOX, 0.8, glazing(kit))
    kit.add(BOX, (0.1, wide * 0.94, up + 0.48), (0.35, 0.02, 0.04), (0.7, 1), (0.06, 0), material=second, mirror=True)
    kit.add(CYL, (rear - 0.06, 0, up + 0.14), (0.09, 0.09, 0.07), rotation=ALONG_X, material=dark)


def kart(kit):
    """A racing kart: tube frame, side pods, nose cone, number panel, bucket seat, engine beside it, slick tyres."""
    rng = kit.rng
    coat, second, dark, tyre, metal = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), rubber(kit), chrome(kit)
    front, rear, track, radius = 0.52, -0.52, rng.uniform(0.5, 0.58), rng.uniform(0.125, 0.145)
    fat_wheels(kit, front, track - 0.02, radius * 0.95, 0.065, tyre, metal, 3)
    fat_wheels(kit, rear, track, radius, 0.105, tyre, metal, 3)
    kit.between((rear, -track, radius), (rear, track, radius), 0.02, material=metal)
    kit.between((front, 0.25, 0.1), (front, track - 0.05, radius), 0.018, material=dark, mirror=True)
    kit.between((rear - 0.1, 0.32, 0.09), (front - 0.1, 0.3, 0.08), 0.018, material=second, mirror=True)
    kit.between((front - 0.1, 0.3, 0.08), (front + 0.22, 0.2, 0.08), 0.018, material=second, mirror=True)
    kit.add(BOX, (0.3, 0, 0.07), (0.36, 0.28, 0.008), material=metal)
    for x in (rear - 0.1, -0.1, front):
        kit.between((x, -0.3, 0.085), (x, 0.3, 0.085), 0.018, material=second)
    section(kit, front + 0.06, front + 0.42, (0.06, 0.27, track * 0.95), (0.05, 0.15, track * 0.7), coat)
    section(kit, rear + 0.22, front - 0.2, (0.05, 0.26, 0.1), (0.05, 0.22, 0.08), coat, track + 0.02, True)
    kit.between((0, 0.28, 0.12), (0, track, 0.14), 0.018, material=dark, mirror=True)
    kit.between((front + 0.16, 0, 0.2), (front - 0.02, 0, 0.5), (0.015, 0.13), BOX, 0.85, coat)
    kit.add(BOX, (front + 0.02, 0, 0.44), (0.012, 0.09, 0.07), rotation=turn("y", -31), material=kit.material(base=[0.85] * 3, pattern=WRITING, frequency=12, second=[0.02] * 3))
    steering(kit, front - 0.26, 0, 0.48, dark, 0.15)
    kit.between((front - 0.04, 0, 0.37), (front + 0.06, 0, 0.12), 0.014, material=metal)
    slab(kit, 0.08, 0.2, (-0.3, 0.1, 0.16), (-0.34, 0.12, 0.19), dark)
    kit.between((-0.27, 0, 0.14), (-0.42, 0, 0.62), (0.02, 0.19), BOX, 0.85, dark)
    kit.add(BOX, (-0.16, 0.19, 0.26), (0.2, 0.012, 0.12), (0.6, 1), (-0.09, 0), material=dark, mirror=True)
    kit.add(BOX, (-0.32, -0.35, 0.24), (0.12, 0.09, 0.12), material=dark)
    kit.between((-0.3, -0.35, 0.34), (-0.26, -0.35, 0.5), 0.07, material=fins(kit))
    kit.between((-0.36, -0.3, 0.34), (-0.62, -0.2, 0.28), 0.045, material=metal)
    kit.add(BOX, (-0.1, 0.33, 0.3), (0.03, 0.1, 0.14), rotation=turn("y", 14), material=kit.material(base=[0.1] * 3, pattern=RIBS, frequency=40, second=[0.3] * 3))
    section(kit, rear - 0.28, rear - 0.2, (0.1, 0.26, track * 0.95), (0.1, 0.26, track), dark if kit.chance(0.5) else coat)
    kit.between((rear - 0.1, 0.32, 0.09), (rear - 0.22, 0.32, 0.16), 0.018, material=dark, mirror=True)
    kit.add(BOX, (front - 0.2, 0.12, 0.14), (0.012, 0.03, 0.08), rotation=turn("y", 15), material=metal, mirror=True)


def golf_cart(kit):
    """A golf cart or a shuttle with rows of seats, sometimes the last one backward."""
    rng = kit.rng
    coat, dark, cloth, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), hide(kit), chrome(kit), rubber(kit)
    rows = int(rng.choice([1, 1, 2, 3]))
    radius, wide, front = 0.23, 0.6, 0.55 + 0.4 * rows
    rear, floor = -front + 0.05, 0.34
    for x in (front - 0.15, rear + 0.3):
        fat_wheels(kit, x, wide - 0.06, radius, 0.1, tyre, metal, int(rng.choice([0, 4, 5, 6, 8])))
        kit.between((x, -wide + 0.1, radius), (x, wide - 0.1, radius), 0.04, material=dark)
    section(kit, rear, front - 0.1, (floor - 0.08, floor, wide * 0.9), (floor - 0.08, floor, wide * 0.9), dark)
    section(kit, front - 0.42, front + 0.12, (floor - 0.04, floor + 0.62, wide * 0.88), (floor - 0.06, floor + 0.26, wide * 0.72), coat)
    section(kit, front - 0.42, front + 0.05, (floor + 0.16, floor + 0.34, wide), (floor + 0.14, floor + 0.22, wide * 0.9), coat)
    section(kit, rear - 0.05, rear + 0.75, (floor - 0.05, floor + 0.36, wide * 0.82), (floor - 0.05, floor + 0.32, wide * 0.95), coat)
    arch(kit, rear + 0.3, wide - 0.03, radius, radius + 0.07, 0.09, 15, 165, 3, dark)
    for k in range(rows):
        x = front - 0.95 - 0.75 * k
        back = rows > 1 and k == rows - 1 and kit.chance(0.6)
        kit.add(BOX, (x, 0, floor + 0.18), (0.22, wide * 0.85, 0.18), material=coat)
        kit.add(BOX, (x, 0, floor + 0.42), (0.26, wide * 0.88, 0.06), material=cloth)
        kit.add(BOX, (x + (0.26 if back else -0.26), 0, floor + 0.68), (0.05, wide * 0.86, 0.22), (1, 0.95), (0.05 if back else -0.06, 0), material=cloth)
    steering(kit, front - 0.52, wide * 0.4, floor + 0.72, dark, 0.16)
    roof = floor + rng.uniform(1.38, 1.5)
    kit.between((front - 0.25, wide * 0.84, floor + 0.5), (front - 0.5, wide * 0.8, roof), 0.022, material=metal if kit.chance(0.5) else dark, mirror=True)
    kit.between((rear + 0.12, wide * 0.8, floor + 0.3), (rear + 0.02, wide * 0.8, roof), 0.022, material=dark, mirror=True)
    kit.add(BOX, ((front - 0.4 + rear) / 2, 0, roof + 0.03), ((front - 0.25 - rear) / 2 + 0.06, wide * 1.0, 0.04), (0.95, 0.92), material=flat(kit, [0.8, 0.79, 0.72]) if kit.chance(0.6) else coat)
    if kit.chance(0.7):
        kit.between((front - 0.3, 0, floor + 0.56), (front - 0.49, 0, roof - 0.02), (0.008, wide * 0.8), BOX, material=glazing(kit))
    kit.add(BOX, (front + 0.07, wide * 0.5, floor + 0.2), (0.05, 0.1, 0.04), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.add(BOX, (rear - 0.04, wide * 0.65, floor + 0.25), (0.03, 0.05, 0.05), material=flat(kit, RED), mirror=True)
    if rows == 1:
        for y in (0.2, -0.2):
            kit.add(CYL, (rear - 0.05, y, floor + 0.62), (0.12, 0.13, 0.4), rotation=turn("y", -7), material=kit.material())
            kit.add(CYL, (rear - 0.1, y, floor + 1.08), (0.08, 0.07, 0.07), (1.2, 1), material=metal)
        kit.add(BOX, (rear - 0.08, 0, floor + 0.2), (0.15, 0.4, 0.03), material=dark)


def mobility(kit):
    """A mobility scooter with tiller, basket and armchair, or a power chair with joystick."""
    rng = kit.rng
    coat, dark, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), kit.material(base=rng.choice([0.03, 0.3]) * np.ones(3), pattern=PLAIN)
    three, radius = kit.chance(0.4), rng.uniform(0.13, 0.18)
    base, track = rng.uniform(0.42, 0.55), rng.uniform(0.24, 0.29)
    cloth, z = hide(kit), rng.uniform(0.56, 0.64)
    chair = kit.chance(0.3)
    x = -0.22 if not chair else 0.0
    rims(kit, -base if not chair else -0.05, track + 0.03, radius, 0.055, tyre, metal, int(rng.choice([0, 3, 5, 6])))
    if chair:
        for end in (0.36, -0.4):
            rims(kit, end, track - 0.02, 0.08, 0.03, tyre, metal)
            kit.between((end, track - 0.02, 0.09), (end * 0.6, track - 0.06, 0.22), 0.025, BOX, material=dark, mirror=True)
        section(kit, -0.34, 0.3, (0.12, 0.36, track - 0.05), (0.14, 0.32, track - 0.06), coat)
        kit.between((0.25, 0.1, 0.42), (0.42, 0.1, 0.14), 0.018, material=dark, mirror=True)
        kit.add(BOX, (0.48, 0, 0.13), (0.12, 0.18, 0.012), material=dark)
    else:
        rims(kit, base, 0.0 if three else track, radius * 0.95, 0.05, tyre, metal, int(rng.choice([0, 3, 5, 6])))
        section(kit, -base - 0.2, -base + 0.34, (0.16, 0.36, track - 0.03), (0.14, 0.4, track - 0.02), coat)
        arch(kit, -base, track + 0.02, radius, radius + 0.04, 0.06, 10, 170, 3, coat)
        section(kit, -base + 0.3, base - radius - 0.02, (0.1, 0.17, track + 0.04), (0.1, 0.17, track), dark)
        section(kit, base - radius - 0.1, base + radius + 0.08, (0.12, 0.42, 0.15 if three else track * 0.75), (2 * radius + 0.02, 2 * radius + 0.14, 0.09), coat)
        if not three:
            arch(kit, base, track, radius, radius + 0.035, 0.06, 10, 165, 3, coat)
        top = np.array([base - 0.24, 0, rng.uniform(0.9, 1.0)])
        kit.between((base - 0.06, 0, 0.34), top, (0.05, 0.06), BOX, 0.8, coat)
        kit.add(BOX, top, (0.08, 0.12, 0.06), (0.7, 0.9), rotation=turn("y", -25), material=dark)
        kit.between(top + [0, 0.08, 0], top + [-0.08, 0.27, 0.04], 0.018, material=dark, mirror=True)
        kit.add(CYL, top + [0.1, 0, -0.14], (0.055, 0.055, 0.04), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        if kit.chance(0.7):
            kit.add(BOX, top + [0.24, 0, -0.2], (0.12, 0.17, 0.11), (1.15, 1.1), material=dark, cut=(GRID, 22, 0.25))
            kit.between(top + [0, 0, -0.14], top + [0.14, 0, -0.2], 0.02, material=dark)
        if kit.chance(0.6):
            kit.between(top + [0, 0.16, 0.02], top + [0.03, 0.28, 0.16], 0.008, material=dark, mirror=True)
            kit.add(BOX, top + [0.03, 0.28, 0.18], (0.01, 0.06, 0.04), material=dark, mirror=True)
    kit.between((x, 0, 0.3), (x, 0, z), 0.06, material=dark)
    kit.add(BOX, (x + 0.02, 0, z), (0.23, 0.22, 0.055), material=cloth)
    kit.add(BOX, (x - 0.22, 0, z + 0.28), (0.055, 0.21, 0.26), (0.8, 0.9), (-0.06, 0), material=cloth)
    if kit.chance(0.6):
        kit.add(BOX, (x - 0.28, 0, z + 0.62), (0.035, 0.12, 0.07), material=cloth)
        kit.between((x - 0.27, 0, z + 0.5), (x - 0.28, 0, z + 0.6), 0.015, material=metal)
    kit.between((x - 0.22, 0.26, z + 0.2), (x + 0.16, 0.26, z + 0.2), (0.022, 0.03), BOX, material=dark, mirror=True)
    kit.between((x - 0.24, 0.2, z + 0.2), (x - 0.22, 0.27, z + 0.2), 0.016, material=metal, mirror=True)
    if chair:
        kit.add(BOX, (x + 0.18, -0.26, z + 0.25), (0.05, 0.035, 0.03), material=dark)
        kit.between((x + 0.19, -0.26, z + 0.26), (x + 0.19, -0.26, z + 0.34), 0.01, material=dark)
    kit.add(BOX, (-base - 0.2 if not chair else -0.34, track * 0.7, 0.28), (0.015, 0.05, 0.025), material=flat(kit, RED), mirror=True)


def stander(kit):
    """What one rides standing: a kick scooter with a motor or a two-wheeled self-balancing one with tread and post."""
    rng = kit.rng
    coat, dark, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit)
    main = dark if kit.chance(0.6) else coat
    if kit.chance(0.6):
        radius, reach, tall = rng.uniform(0.1, 0.15), rng.uniform(0.44, 0.5), rng.uniform(1.0, 1.15)
        for x in (reach, -reach):
            kit.add(CYL, (x, 0, radius), (radius, radius, 0.03), rotation=ALONG_Y, material=tyre)
            kit.add(CYL, (x, 0, radius), (radius * 0.66, radius * 0.66, 0.034), rotation=ALONG_Y, material=metal if kit.chance(0.5) else coat)
        deck = radius + 0.03
        kit.add(BOX, (-0.06, 0, deck), (reach - radius - 0.04, rng.uniform(0.08, 0.11), 0.045), (1, 0.95), material=main)
        kit.add(BOX, (-0.06, 0, deck + 0.05), (reach - radius - 0.06, 0.07, 0.006), material=kit.material(base=[0.02] * 3, pattern=RIBS, frequency=30, second=[0.07] * 3))
        kit.between((-reach + radius - 0.02, 0.045, deck), (-reach, 0.045, radius), (0.022, 0.012), BOX, material=main, mirror=True)
        top = np.array([reach - 0.16, 0, tall])
        kit.between((reach - radius - 0.12, 0, deck), (reach - 0.055, 0, 0.38), (0.045, 0.04), BOX, 0.8, main)
        kit.between((reach, 0.045, radius), (reach - 0.03, 0.045, 2 * radius + 0.05), (0.02, 0.012), BOX, material=main, mirror=True)
        kit.add(BOX, (reach - 0.035, 0, 2 * radius + 0.05), (0.03, 0.06, 0.025), material=main)
        kit.between((reach - 0.035, 0, 2 * radius + 0.02), top, 0.028, material=main)
        kit.between(top + [0, 0, 0], top + [-0.03, 0.25, 0.02], 0.014, material=main, mirror=True)
        kit.between(top + [-0.015, 0.14, 0.01], top + [-0.03, 0.26, 0.02], 0.02, material=dark, mirror=True)
        arch(kit, -reach, 0, radius, radius + 0.025, 0.04, 40, 180, 4, main)
        arch(kit, reach, 0, radius, radius + 0.025, 0.04, 30, 130, 3, main)
        kit.add(CYL, top + [0.05, 0, -0.08], (0.03, 0.03, 0.02), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        kit.add(BOX, (-reach - radius - 0.02, 0, radius + 0.06), (0.012, 0.03, 0.02), material=flat(kit, RED))
        if kit.chance(0.35):
            kit.between((-0.2, 0, deck), (-0.22, 0, 0.6), 0.018, material=metal)
            kit.add(BALL, (-0.22, 0, 0.64), (0.14, 0.1, 0.05), material=dark)
        elif kit.chance(0.3):
            kit.add(BOX, (reach + 0.1, 0, 0.78), (0.1, 0.15, 0.1), (1.1, 1.1), material=dark, cut=(GRID, 24, 0.3))
            kit.between((reach - 0.12, 0, 0.8), (reach + 0.03, 0, 0.76), 0.015, material=dark)
        kit.between((0.1, 0.08, deck), (0.05, 0.16, 0.0), 0.01, material=dark)
    else:
        radius, wide, tall = rng.uniform(0.22, 0.26), rng.uniform(0.27, 0.31), rng.uniform(1.1, 1.25)
        fat_wheels(kit, 0, wide, radius, 0.055, tyre, metal, int(rng.integers(4, 9)))
        kit.add(BOX, (0, 0, radius - 0.03), (0.14, wide - 0.04, 0.07), (0.9, 1), material=main)
        kit.add(BOX, (-0.01, 0, radius + 0.05), (0.17, wide - 0.07, 0.015), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=25, second=[0.08] * 3))
        arch(kit, 0, wide - 0.02, radius, radius + 0.035, 0.075, 25, 155, 4, coat)
        kit.between((0.12, 0, radius), (0.2, 0, radius + 0.3), (0.05, 0.07), BOX, 0.6, main)
        kit.between((0.19, 0, radius + 0.26), (0.16, 0, tall), 0.022, material=metal)
        kit.add(BOX, (0.16, 0, tall), (0.035, 0.07, 0.05), material=dark)
        kit.between((0.16, 0.04, tall), (0.1, 0.26, tall + 0.05), 0.016, material=metal, mirror=True)
        kit.between((0.12, 0.17, tall + 0.035), (0.095, 0.28, tall + 0.055), 0.022, material=dark, mirror=True)
        if kit.chance(0.5):
            kit.add(BOX, (0.27, 0, radius + 0.5), (0.08, 0.16, 0.13), (0.9, 0.9), material=coat)
        if kit.chance(0.5):
            kit.add(BOX, (0.02, wide + 0.03, radius * 2 + 0.16), (0.14, 0.05, 0.1), (0.9, 0.8), material=dark, mirror=True)


def tuk_tuk(kit):
    """Auto and electric rickshaws: three wheels, a canopy on posts, a bench behind the driver."""
    rng = kit.rng
    coat, second, dark, cloth, metal, tyre = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), hide(kit), chrome(kit), rubber(kit)
    boxy = kit.chance(0.45)
    radius, wide, front, rear, roof = 0.22, 0.6, 1.15, -1.25, rng.uniform(1.62, 1.75)
    rims(kit, front - 0.12, 0, radius, 0.055, tyre, metal)
    rims(kit, rear + 0.5, wide - 0.06, radius, 0.06, tyre, metal)
    kit.between((rear + 0.5, -wide + 0.1, radius), (rear + 0.5, wide - 0.1, radius), 0.035, material=dark)
    kit.add(BOX, (-0.1, 0, 0.32), (1.0, wide * 0.9, 0.045), material=dark)
    kit.between((front - 0.12, 0.08, radius), (front - 0.22, 0.08, 0.7), 0.028, material=metal, mirror=True)
    if boxy:
        kit.add(BOX, (0.72, 0, 0.62), (0.06, wide * 0.9, 0.34), material=coat)
        kit.between((0.78, 0, 0.5), (front - 0.2, 0, 0.72), (0.2, 0.14), BOX, 0.7, coat)
        section(kit, rear, -0.1, (0.3, 0.62, wide), (0.3, 0.58, wide), coat)
        kit.add(BOX, (-0.15, 0, roof), (0.98, wide * 1.03, 0.04), (0.97, 0.94), material=second)
        posts = ((0.74, 0.68), (-0.15, -0.15), (rear + 0.05, rear + 0.05))
    else:
        section(kit, 0.48, front, (0.3, 0.92, wide * 0.88), (0.42, 0.74, 0.2), coat)
        section(kit, rear, -0.3, (0.3, 0.86, wide * 0.92), (0.28, 0.8, wide), coat)
        kit.add(CYL, (-0.35, 0, roof - 0.14), (0.2, wide, 0.86), rotation=ALONG_X, material=second)
        kit.add(BOX, (rear + 0.07, 0, (roof + 0.75) / 2), (0.03, wide * 0.9, (roof - 0.85) / 2), material=second)
        kit.add(BOX, (rear + 0.03, 0, roof - 0.38), (0.012, 0.26, 0.1), material=glazing(kit))
        posts = ((0.62, 0.4), (-0.3, -0.3), (rear + 0.05, rear + 0.05))
    with_screen = posts[0]
    for foot, head in posts:
        kit.between((foot, wide * 0.88, 0.55), (head, wide * 0.92, roof - 0.1), 0.024, material=dark if not boxy else metal, mirror=True)
    kit.between((with_screen[0] + 0.02, 0, 0.94), (with_screen[1] + 0.02, 0, roof - 0.06), (0.01, wide * 0.86), BOX, material=glazing(kit))
    kit.add(CYL, (front - 0.02 if not boxy else 0.8, 0, 0.72), (0.085, 0.085, 0.05), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
    arch(kit, front - 0.12, 0, radius, radius + 0.05, 0.08, 10, 160, 4, second)
    kit.add(BOX, (0.18, 0, 0.5), (0.15, 0.24, 0.18), material=coat)
    kit.add(BOX, (0.17, 0, 0.7), (0.17, 0.26, 0.05), material=cloth)
    kit.add(BOX, (-0.7, 0, 0.68), (0.26, wide * 0.82, 0.09), material=cloth)
    kit.add(BOX, (-0.98, 0, 0.95), (0.06, wide * 0.82, 0.24), (1, 1), (-0.06, 0), material=cloth)
    kit.between((0.5, 0, 0.8), (0.42, 0, 1.0), 0.03, material=dark)
    kit.between((0.42, -0.28, 1.0), (0.42, 0.28, 1.0), 0.02, material=dark)
    arch(kit, rear + 0.5, wide - 0.03, radius, radius + 0.05, 0.1, 10, 170, 3, coat if boxy else dark)
    kit.add(BOX, (rear - 0.015, wide * 0.75, 0.52), (0.025, 0.06, 0.09), material=flat(kit, RED), mirror=True)
    kit.add(BOX, (rear - 0.02, 0, 0.45), (0.015, 0.2, 0.06), material=kit.material(base=[0.8, 0.65, 0.1], pattern=WRITING, frequency=25, second=[0.02] * 3))
    kit.between((with_screen[0], wide * 0.9, 1.1), (with_screen[0] + 0.04, wide * 1.12, 1.16), 0.01, material=dark, mirror=True)
    kit.add(BOX, (with_screen[0] + 0.04, wide * 1.14, 1.2), (0.012, 0.05, 0.08), material=dark, mirror=True)


def microcar(kit):
    """A bubble car of the fifties or a small electric one for two of today."""
    rng = kit.rng
    coat, second, dark, metal, tyre, glass = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), glazing(kit)
    bubble = kit.chance(0.5)
    if bubble:
        pastel = flat(kit, rng.choice([[0.5, 0.05, 0.05], [0.3, 0.55, 0.55], [0.75, 0.7, 0.5], [0.2, 0.4, 0.6], [0.6, 0.3, 0.1]]), 0.5)
        radius, wide, long = 0.22, 0.62, rng.uniform(1.05, 1.15)
        rims(kit, 0.62, wide - 0.06, radius, 0.06, tyre, metal)
        rims(kit, -0.72, 0.26, radius, 0.06, tyre, metal)
        kit.add(BALL, (0.0, 0, 0.62), (long, wide, 0.42), material=pastel)
        kit.add(BALL, (0.06, 0, 0.86), (long * 0.78, wide * 0.9, 0.5), material=glass)
        kit.add(BALL, (-0.02, 0, 1.2), (long * 0.5, wide * 0.68, 0.2), material=second if kit.chance(0.5) else pastel)
        kit.add(CYL, (0, 0, 0.74), (long * 0.985, wide * 1.0, 0.018), material=metal)
        kit.add(BOX, (0.05, 0, 0.38), (0.75, wide * 0.8, 0.14), (1.1, 1.15), material=pastel)
        kit.between((0.5, wide * 0.78, 0.72), (0.22, wide * 0.6, 1.24), (0.03, 0.025), BOX, material=pastel, mirror=True)
        kit.between((-0.42, wide * 0.8, 0.74), (-0.26, wide * 0.58, 1.24), (0.06, 0.025), BOX, material=pastel, mirror=True)
        kit.between((long * 0.93, 0, 0.5), (long * 0.93, 0, 0.8), (0.02, 0.02), BOX, material=metal)
        kit.add(BALL, (0.78, wide * 0.72, 0.68), (0.14, 0.09, 0.09), material=pastel, mirror=True)
        kit.add(CYL, (0.9, wide * 0.72, 0.68), (0.072, 0.072, 0.02), rotation=ALONG_X, material=flat(kit, WHITE, 0.6), mirror=True)
        kit.between((0.98, -0.42, 0.42), (0.98, 0.42, 0.42), 0.025, material=metal)
        kit.between((-1.0, -0.3, 0.45), (-1.0, 0.3, 0.45), 0.025, material=metal)
        kit.add(BOX, (-0.98, 0.25, 0.62), (0.05, 0.05, 0.05), material=flat(kit, RED), mirror=True)
        return
    radius, wide, long = 0.27, 0.68, rng.uniform(1.15, 1.3)
    rims(kit, long - 0.4, wide - 0.05, radius, 0.09, tyre, metal, int(rng.integers(4, 9)))
    rims(kit, -long + 0.4, wide - 0.05, radius, 0.09, tyre, metal, int(rng.integers(4, 9)))
    roof, belt, rake = rng.uniform(1.45, 1.55), 0.88, rng.uniform(0.35, 0.55)
    for x in (long - 0.4, -long + 0.4):
        kit.add(CYL, (x, wide - 0.1, radius * 1.16), (radius * 1.14, radius * 1.14, 0.108), rotation=ALONG_Y, material=dark, mirror=True)
    section(kit, -long, long - 0.28, (0.3, belt, wide * 0.94), (0.28, belt, wide), coat)
    section(kit, long - 0.3, long + 0.03, (0.28, belt, wide), (0.34, 0.66, wide * 0.72), coat)
    slab(kit, belt - 0.02, roof, (-long + 0.02, long - 0.22, wide * 0.93), (-long + 0.22, long - 0.22 - rake, wide * 0.78), glass)
    slab(kit, roof - 0.03, roof + 0.05, (-long + 0.18, long - 0.16 - rake, wide * 0.81), (-long + 0.3, long - 0.36 - rake, wide * 0.72), second if kit.chance(0.5) else coat)
    kit.between((long - 0.2, wide * 0.94, belt - 0.02), (long - 0.22 - rake, wide * 0.79, roof), (0.035, 0.025), BOX, material=coat, mirror=True)
    kit.between((-long + 0.2, wide * 0.93, belt - 0.02), (-long + 0.34, wide * 0.79, roof), (0.16, 0.025), BOX, material=coat, mirror=True)
    kit.add(BOX, (0.02, wide * 0.98, 0.6), (0.36, 0.012, 0.22), (1.1, 1), material=second, mirror=True)
    kit.add(BOX, (0.3, wide * 1.0, 0.7), (0.07, 0.02, 0.015), material=dark, mirror=True)
    kit.add(BALL, (long - 0.08, wide * 0.64, 0.66), (0.08, 0.12, 0.09), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.add(BOX, (long + 0.01, 0, 0.44), (0.03, wide * 0.6, 0.07), material=dark)
    kit.add(BOX, (-long - 0.005, wide * 0.72, 0.7), (0.02, 0.07, 0.09), material=flat(kit, RED), mirror=True)
    kit.add(BOX, (-long - 0.01, 0, 0.42), (0.03, wide * 0.8, 0.08), material=dark)
    kit.add(BOX, (-long - 0.04, 0, 0.56), (0.012, 0.22, 0.05), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=25, second=[0.02] * 3))
    kit.add(BOX, (long - 0.36, wide * 1.06, belt + 0.06), (0.04, 0.07, 0.05), material=coat, mirror=True)


def mower(kit):
    """A ride-on mower: hood with grille, small wheels before and big ones behind, deck beneath, some with a grass box; or a zero-turn."""
    rng = kit.rng
    coat = flat(kit, rng.choice([[0.03, 0.25, 0.05], [0.7, 0.2, 0.02], [0.6, 0.04, 0.03], [0.65, 0.5, 0.03], [0.12, 0.12, 0.12]]), 0.4)
    dark, tyre, cloth = kit.material(dark=True, pattern=PLAIN), treads(kit), hide(kit)
    rim = flat(kit, [0.7, 0.55, 0.05]) if kit.chance(0.5) else flat(kit, [0.75] * 3)
    zero = kit.chance(0.35)
    big, small, base = rng.uniform(0.25, 0.29), rng.uniform(0.16, 0.19), rng.uniform(0.58, 0.65)
    fat_wheels(kit, -base + 0.06, 0.36, big, 0.11, tyre, rim)
    fat_wheels(kit, base, 0.36, small, 0.07, tyre, rim)
    deck = 0.45
    kit.between((-base + 0.06, -0.3, big), (-base + 0.06, 0.3, big), 0.05, material=dark)
    slab(kit, 0.08, 0.22, (-0.28, 0.36, deck), (-0.22, 0.3, deck * 0.85), coat if kit.chance(0.5) else dark)
    kit.add(CYL, (0.03, 0.2, 0.22), (0.1, 0.1, 0.05), material=dark, mirror=True)
    kit.add(BOX, (0.02, -deck - 0.06, 0.16), (0.14, 0.1, 0.04), (0.9, 0.8), material=dark)
    if zero:
        kit.between((-base - 0.1, 0.22, 0.3), (base - 0.12, 0.22, 0.3), 0.04, BOX, material=coat, mirror=True)
        kit.between((base - 0.12, -0.36, 0.32), (base - 0.12, 0.36, 0.32), 0.04, BOX, material=coat)
        kit.between((base - 0.12, 0.36, 0.36), (base, 0.36, small), (0.03, 0.05), BOX, material=dark, mirror=True)
        section(kit, -base - 0.35, -0.36, (0.3, 0.62, 0.3), (0.3, 0.58, 0.3), dark)
        kit.add(CYL, (-base - 0.1, 0, 0.7), (0.17, 0.17, 0.09), material=fins(kit))
        kit.add(BOX, (-base + 0.05, 0.36, 0.6), (0.32, 0.11, 0.05), (0.9, 0.9), material=coat, mirror=True)
        kit.add(BOX, (0.18, 0, 0.36), (0.34, 0.22, 0.02), material=dark)
        kit.between((0.0, 0.3, 0.5), (0.16, 0.27, 0.86), 0.016, material=dark, mirror=True)
        kit.between((0.16, 0.29, 0.86), (0.14, 0.07, 0.92), 0.02, material=dark, mirror=True)
        kit.add(BOX, (-0.12, 0, 0.46), (0.2, 0.2, 0.1), material=dark)
        x, z = -0.12, 0.58
        if kit.chance(0.5):
            kit.between((-base - 0.1, 0.34, 0.5), (-base - 0.2, 0.34, 1.45), 0.025, material=dark, mirror=True)
            kit.between((-base - 0.2, -0.36, 1.45), (-base - 0.2, 0.36, 1.45), 0.025, material=dark)
    else:
        section(kit, 0.08, base + 0.24, (0.3, 0.7, 0.23), (0.28, 0.6, 0.2), coat)
        kit.add(BOX, (base + 0.245, 0, 0.42), (0.012, 0.16, 0.1), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=30, second=[0.1] * 3))
        kit.add(BOX, (base + 0.24, 0.13, 0.54), (0.02, 0.05, 0.025), material=flat(kit, WHITE, 0.6), mirror=True)
        kit.add(BOX, (base - 0.15, 0.22, 0.5), (0.14, 0.014, 0.06), material=dark, mirror=True)
        kit.add(BOX, (base + 0.28, 0, 0.3), (0.04, 0.2, 0.04), material=dark)
        kit.between((base, -0.32, small), (base, 0.32, small), 0.03, material=dark)
        kit.add(BOX, (base, 0, 0.26), (0.06, 0.08, 0.09), material=dark)
        section(kit, 0.0, 0.12, (0.3, 0.78, 0.2), (0.3, 0.7, 0.23), dark)
        kit.add(BOX, (-0.05, 0, 0.3), (0.3, 0.36, 0.025), material=dark)
        section(kit, -base - 0.28, -0.32, (0.3, 0.56, 0.24), (0.3, 0.56, 0.24), coat)
        kit.add(BOX, (-base + 0.06, 0.34, 0.58), (0.32, 0.13, 0.03), (0.9, 0.9), material=coat, mirror=True)
        kit.between((-base + 0.36, 0.34, 0.57), (-base + 0.42, 0.34, 0.32), (0.015, 0.12), BOX, material=coat, mirror=True)
        steering(kit, -0.02, 0, 0.88, dark, 0.15)
        x, z = -base + 0.12, 0.62
        if kit.chance(0.4):
            section(kit, -base - 0.75, -base - 0.29, (0.25, 0.75, 0.34), (0.32, 0.78, 0.36), dark)
    kit.add(BOX, (x, 0, z), (0.2, 0.2, 0.05), material=cloth)
    kit.add(BOX, (x - 0.2, 0, z + 0.2), (0.045, 0.19, 0.18), (0.8, 0.85), (-0.04, 0), material=cloth)
    kit.add(BOX, (-base - 0.29 if not zero else -base - 0.36, 0.15, 0.48), (0.012, 0.04, 0.03), material=flat(kit, RED), mirror=True)


def pedal_car(kit):
    """A child's pedal car, or a soapbox racer: plank with a body of boards, rope or wheel to steer, four small wheels."""
    rng = kit.rng
    coat, second, dark, metal, tyre, wood = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), timber(kit)
    radius, base, track = rng.uniform(0.13, 0.16), rng.uniform(0.36, 0.42), rng.uniform(0.22, 0.26)
    if kit.chance(0.5):
        for x in (base, -base):
            fat_wheels(kit, x, track, radius, 0.035, tyre, flat(kit, [0.7] * 3), 0)
            kit.between((x, -track, radius), (x, track, radius), 0.012, material=metal)
            arch(kit, x, track, radius, radius + 0.035, 0.05, 10, 165, 4, second)
        section(kit, -0.06, base + 0.18, (0.16, 0.46, 0.16), (0.16, 0.4, 0.12), coat)
        kit.add(CYL, (base + 0.18, 0, 0.28), (0.12, 0.1, 0.02), rotation=ALONG_X, material=kit.material(base=[0.6] * 3, pattern=RIBS, frequency=40, second=[0.1] * 3))
        kit.add(BOX, (-0.2, 0.165, 0.26), (0.2, 0.014, 0.1), (1, 1), material=coat, mirror=True)
        section(kit, -base - 0.2, -0.32, (0.18, 0.38, 0.1), (0.16, 0.48, 0.17), coat)
        kit.add(BOX, (-0.15, 0, 0.17), (0.4, 0.15, 0.015), material=dark)
        kit.add(BOX, (-0.24, 0, 0.26), (0.1, 0.12, 0.03), material=dark)
        kit.add(BOX, (-0.33, 0, 0.4), (0.02, 0.13, 0.13), (0.8, 0.9), (-0.03, 0), material=dark)
        kit.between((-0.02, 0, 0.46), (-0.06, 0, 0.56), (0.006, 0.13), BOX, 0.9, glazing(kit))
        steering(kit, -0.14, 0, 0.48, dark, 0.085)
        kit.add(BALL, (base + 0.06, 0.2, 0.42), (0.05, 0.045, 0.045), material=metal, mirror=True)
        kit.add(CYL, (base + 0.1, 0.2, 0.42), (0.038, 0.038, 0.012), rotation=ALONG_X, material=flat(kit, WHITE, 0.6), mirror=True)
        kit.between((base + 0.1, 0.05, 0.36), (base + 0.06, 0.19, 0.4), 0.012, material=metal, mirror=True)
        kit.between((base + 0.24, -0.28, 0.16), (base + 0.24, 0.28, 0.16), 0.02, material=metal)
        kit.between((base + 0.12, 0.1, 0.18), (base + 0.24, 0.1, 0.16), 0.014, material=metal, mirror=True)
        kit.add(BOX, (-0.12, 0.172, 0.28), (0.09, 0.01, 0.07), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=9, second=[0.03] * 3), mirror=True)
        if kit.chance(0.5):
            kit.add(CYL, (-base - 0.2, 0, 0.32), (0.1, 0.1, 0.03), rotation=turn("y", 80), material=tyre)
        return
    long = rng.uniform(0.75, 0.95)
    spokes = int(rng.integers(8, 14))
    for x, r in ((long * 0.75, radius * 1.0), (-long * 0.7, radius * rng.uniform(1.0, 1.4))):
        kit.add(CYL, (x, track + 0.08, r), (r, r, 0.025), rotation=ALONG_Y, material=tyre, mirror=True, cut=RING)
        kit.add(CYL, (x, track + 0.08, r), (r * 0.9, r * 0.9, 0.015), rotation=ALONG_Y, material=metal, mirror=True, cut=(SPOKES, spokes, 0.13))
        kit.between((x, -track - 0.1, r), (x, track + 0.1, r), 0.014, material=metal)
        kit.add(BOX, (x, 0, r + 0.035), (0.045, track, 0.025), material=wood)
    kit.add(BOX, (0, 0, radius + 0.075), (long, 0.12, 0.02), material=wood)
    skin = wood if kit.chance(0.4) else kit.material(base=coat.first, pattern=PLANKS, frequency=12)
    low = radius + 0.09
    if kit.chance(0.5):
        section(kit, 0.12, long * 1.1, (low, low + 0.28, 0.2), (low, low + 0.1, 0.06), skin)
        section(kit, -long * 1.05, -0.32, (low, low + 0.22, 0.06), (low, low + 0.36, 0.2), skin)
        kit.add(BOX, (-0.1, 0.2, low + 0.12), (0.26, 0.015, 0.12), material=skin, mirror=True)
        steering(kit, 0.02, 0, low + 0.3, dark, 0.11)
        kit.add(CYL, (0.4, 0.16, low + 0.12), (0.08, 0.08, 0.012), rotation=ALONG_Y, material=flat(kit, [0.85] * 3), mirror=True)
        kit.add(BOX, (-0.12, 0, low + 0.03), (0.2, 0.18, 0.03), material=dark)
    else:
        kit.add(BOX, (-0.38, 0, low + 0.02), (0.18, 0.2, 0.02), material=wood)
        kit.add(BOX, (-0.55, 0, low + 0.2), (0.015, 0.2, 0.2), material=skin)
        kit.add(BOX, (-0.38, 0.2, low + 0.1), (0.18, 0.015, 0.1), (0.9, 1), (-0.02, 0), material=skin, mirror=True)
        kit.chain([(long * 0.75, track - 0.03, radius + 0.06), (0.1, 0.12, low + 0.18), (-0.1, 0.0, low + 0.24)], 0.01, flat(kit, [0.6, 0.5, 0.3], 0), True, False)
        kit.between((-0.25, 0.24, low), (-0.12, 0.24, low + 0.25), 0.018, BOX, material=wood)
        kit.between((-0.25, 0.18, low + 0.0), (-0.25, 0.26, low + 0.0), 0.016, BOX, material=wood)
    kit.add(BOX, (long + 0.0, 0, radius + 0.09), (0.03, 0.14, 0.04), material=second)
    kit.between((-long * 0.95, 0, low), (-long * 0.98, 0, low + 0.6), 0.008, material=metal)
    kit.between((-long * 0.98, 0, low + 0.53), (-long * 1.2, 0, low + 0.52), (0.06, 0.004), BOX, material=second)


def low_trike(kit):
    """A hand bike or recumbent trike: mesh seat lying low, boom, chain, hand cranks or pedals, three spoked wheels."""
    rng = kit.rng
    coat, dark, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit)
    cut, mesh = (SPOKES, int(rng.integers(14, 22)), 0.08), kit.material(base=[0.03] * 3, pattern=CHECKER, frequency=30, second=[0.08] * 3)
    hand = kit.chance(0.5)
    pair_x, single_x = (-0.35, 0.85) if hand else (0.35, -0.85)
    pair, single, track = (0.3, 0.25, 0.34) if hand else (0.25, rng.choice([0.25, 0.33]), 0.38)
    tilt = turn("x", 6 if hand else 0)
    kit.add(CYL, (pair_x, track, pair), (pair, pair, 0.018), rotation=tilt @ ALONG_Y, material=tyre, mirror=True, cut=RING)
    kit.add(CYL, (pair_x, track, pair), (pair * 0.92, pair * 0.92, 0.012), rotation=tilt @ ALONG_Y, material=metal, mirror=True, cut=cut)
    kit.add(CYL, (single_x, 0, single), (single, single, 0.02), rotation=ALONG_Y, material=tyre, cut=RING)
    kit.add(CYL, (single_x, 0, single), (single * 0.92, single * 0.92, 0.012), rotation=ALONG_Y, material=metal, cut=cut)
    kit.between((pair_x, -track, pair), (pair_x, track, pair), 0.018, material=coat)
    kit.add(BOX, (pair_x, 0, 0.28), (0.05, 0.035, 0.04), material=coat)
    kit.between((-0.45, 0, 0.28), (0.5, 0, 0.28), 0.025, material=coat)
    if hand:
        kit.between((0.5, 0, 0.28), (0.62, 0, 0.66), 0.025, material=coat)
        kit.between((0.6, 0, 0.66), (0.66, 0, 0.5), 0.03, material=coat)
        kit.between((0.66, 0.05, 0.54), (single_x, 0.05, single), 0.016, material=coat, mirror=True)
        kit.between((0.66, 0, 0.55), (0.5, 0, 0.8), 0.022, material=coat)
        crank, pair_of = np.array([0.5, 0, 0.8]), 1
    else:
        kit.between((0.48, 0, 0.28), (0.98, 0, 0.4), 0.025, material=coat)
        kit.between((-0.45, 0.04, 0.28), (single_x, 0.05, single), 0.016, material=coat, mirror=True)
        crank, pair_of = np.array([0.98, 0, 0.4]), -1
        kit.between((0.1, 0.02, 0.28), (0.0, 0.32, 0.26), 0.014, material=dark, mirror=True)
        kit.between((0.0, 0.32, 0.26), (0.0, 0.34, 0.58), 0.016, material=dark, mirror=True)
    kit.add(CYL, crank + [0, 0.04, 0], (0.1, 0.1, 0.006), rotation=ALONG_Y, material=metal)
    kit.between(crank + [0, 0.045, 0.08], (single_x, 0.045, single + 0.04), 0.008, material=dark)
    kit.between(crank + [0, 0.045, -0.08], (single_x, 0.045, single - 0.04), 0.008, material=dark)
    for way in (1, -1):
        end = crank + np.array([0.1, way * 0.08, 0.12]) * ([1, 1, 1] if way > 0 or pair_of > 0 else [-1, 1, -1])
        kit.between(crank + [0, way * 0.05, 0], end, 0.013, material=metal)
        kit.add(BOX, end + [0, way * 0.07, 0], (0.02 if hand else 0.045, 0.06, 0.02), material=dark)
    kit.between((0.08, 0, 0.31), (-0.3, 0, 0.3), (0.025, 0.2), BOX, material=mesh)
    kit.between((-0.28, 0, 0.3), (-0.62, 0, rng.uniform(0.66, 0.85)), (0.025, 0.2), BOX, 0.9, mesh)
    kit.between((-0.42, 0.14, 0.28), (-0.52, 0.14, 0.6), 0.012, material=coat, mirror=True)
    kit.between((-0.42, -0.14, 0.28), (-0.42, 0.14, 0.28), 0.014, material=coat)
    kit.add(BOX, (-0.66, 0, 0.84), (0.04, 0.09, 0.06), material=dark)
    kit.between((-0.56, 0, 0.7), (-0.66, 0, 0.84), 0.014, material=dark)
    if hand:
        kit.between((0.08, 0.1, 0.3), (0.42, 0.2, 0.26), 0.014, material=coat, mirror=True)
        kit.add(BOX, (0.46, 0.2, 0.28), (0.1, 0.05, 0.012), rotation=turn("y", -30), material=dark, mirror=True)
    else:
        arch(kit, single_x, 0, single, single + 0.03, 0.028, 30, 170, 4, dark)
    if kit.chance(0.5):
        kit.between((-0.5, 0.1, 0.3), (-0.62, 0.1, 1.5), 0.005, material=dark)
        kit.between((-0.62, 0.1, 1.46), (-0.78, 0.1, 1.45), (0.07, 0.004), BOX, material=flat(kit, [0.8, 0.25, 0.03]))


def wheelchair(kit):
    """A wheelchair: folding with footrests and push handles, or a sporty one with slanted wheels."""
    rng = kit.rng
    coat, dark, metal, tyre, cloth = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), hide(kit)
    sporty = kit.chance(0.45)
    tube = coat if sporty or kit.chance(0.5) else metal
    wide, z, radius = rng.uniform(0.2, 0.24), rng.uniform(0.46, 0.5), 0.3
    track, camber = wide + (0.16 if sporty else 0.07), rng.uniform(10, 18) if sporty else 0
    axis = turn("x", camber) @ ALONG_Y
    back = rng.uniform(0.22, 0.32) if sporty else rng.uniform(0.42, 0.5)
    kit.add(CYL, (-0.12, track, radius), (radius, radius, 0.016), rotation=axis, material=tyre, mirror=True, cut=RING)
    kit.add(CYL, (-0.12, track, radius), (radius * 0.93, radius * 0.93, 0.01), rotation=axis, material=metal, mirror=True, cut=(SPOKES, int(rng.integers(12, 22)), 0.09))
    kit.add(CYL, np.array([-0.12, track, radius]) + turn("x", camber) @ [0, 0.035, 0], (radius * 0.88, radius * 0.88, 0.008), rotation=axis, material=metal, mirror=True, cut=RING)
    kit.between((-0.12, -track, radius), (-0.12, track, radius), 0.02, material=tube)
    kit.between((-0.12, wide * 0.9, radius), (-0.16, wide * 0.9, z), 0.016, material=tube, mirror=True)
    kit.add(BOX, (0.02, 0, z + 0.02), (0.21, wide, 0.03), material=cloth)
    kit.between((-0.2, 0, z), (-0.27, 0, z + back), (0.015, wide * 0.95), BOX, material=cloth)
    kit.between((-0.19, wide, z - 0.02), (-0.27, wide, z + back + 0.04), 0.013, material=tube, mirror=True)
    kit.between((-0.2, wide, z - 0.01), (0.26, wide, z - 0.01), 0.014, material=tube, mirror=True)
    kit.between((0.25, wide, z - 0.01), (0.36, wide * 0.7, 0.12), 0.014, material=tube, mirror=True)
    kit.add(CYL, (0.24, wide * 0.95, 0.07), (0.07, 0.07, 0.018), rotation=ALONG_Y, material=tyre, mirror=True)
    kit.between((0.24, wide * 0.95, 0.07), (0.2, wide * 0.95, 0.18), (0.014, 0.03), BOX, material=tube, mirror=True)
    kit.between((-0.12, wide * 0.95, 0.22), (0.22, wide * 0.95, 0.18), 0.014, material=tube, mirror=True)
    kit.between((0.2, wide * 0.95, 0.18), (0.22, wide, z - 0.01), 0.014, material=tube, mirror=True)
    kit.between((-0.12, wide * 0.95, 0.2), (-0.12, wide * 0.95, radius), 0.014, material=tube, mirror=True)
    if sporty:
        kit.add(BOX, (0.4, 0, 0.12), (0.09, wide * 0.72, 0.012), material=dark)
        kit.add(BOX, (-0.06, wide + 0.015, z + 0.1), (0.18, 0.008, 0.1), (0.6, 1), (-0.06, 0), material=coat, mirror=True)
        if kit.chance(0.5):
            kit.between((0.44, -wide * 0.9, 0.2), (0.44, wide * 0.9, 0.2), 0.016, material=tube)
            kit.between((0.3, wide * 0.85, 0.3), (0.44, wide * 0.88, 0.2), 0.014, material=tube, mirror=True)
        return
    kit.add(BOX, (0.42, wide * 0.55, 0.12), (0.09, 0.07, 0.01), rotation=turn("y", -10), material=dark, mirror=True)
    kit.between((-0.265, wide, z + back + 0.03), (-0.4, wide, z + back + 0.02), 0.018, material=dark, mirror=True)
    kit.between((-0.22, wide + 0.02, z + 0.22), (0.14, wide + 0.02, z + 0.22), (0.016, 0.028), BOX, material=dark, mirror=True)
    kit.between((0.14, wide + 0.02, z + 0.22), (0.16, wide, z), 0.013, material=tube, mirror=True)
    kit.between((0.05, -wide, z - 0.03), (0.05, wide * 0.95, 0.2), 0.013, material=tube)
    kit.between((0.07, wide, z - 0.03), (0.07, -wide * 0.95, 0.2), 0.013, material=tube)
    kit.add(BOX, (-0.03, wide + 0.015, z + 0.11), (0.17, 0.006, 0.09), material=cloth, mirror=True)


def rickshaw(kit):
    """A cycle rickshaw or pedicab: the front of a bicycle, a bench for two between wheels, hood; or a cargo trike with a box before."""
    rng = kit.rng
    coat, second, dark, metal, tyre, cloth = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), hide(kit)
    cargo = kit.chance(0.4)
    radius, track = rng.uniform(0.28, 0.34), rng.uniform(0.42, 0.5)
    cut = (SPOKES, int(rng.integers(14, 22)), 0.08)
    pair, single = (0.75, -0.75) if cargo else (-0.55, 1.15)
    kit.add(CYL, (pair, track, radius), (radius, radius, 0.024), rotation=ALONG_Y, material=tyre, mirror=True, cut=RING)
    kit.add(CYL, (pair, track, radius), (radius * 0.92, radius * 0.92, 0.014), rotation=ALONG_Y, material=metal, mirror=True, cut=cut)
    kit.add(CYL, (single, 0, radius), (radius, radius, 0.024), rotation=ALONG_Y, material=tyre, cut=RING)
    kit.add(CYL, (single, 0, radius), (radius * 0.92, radius * 0.92, 0.014), rotation=ALONG_Y, material=metal, cut=cut)
    kit.between((pair, -track, radius), (pair, track, radius), 0.018, material=metal)
    crank = np.array([single + (0.45 if cargo else -0.6), 0, 0.3])
    saddle = crank + [-0.22, 0, 0.58]
    head = np.array([saddle[0] + 0.62, 0, 0.88])
    kit.between(crank, saddle, 0.02, material=coat)
    kit.add(BALL, saddle + [0, 0, 0.03], (0.13, 0.08, 0.045), material=cloth)
    kit.add(CYL, crank, (0.1, 0.1, 0.012), rotation=ALONG_Y, material=metal)
    for side in (1, -1):
        end = crank + np.array([0.12 * side, 0.09 * side, -0.1 * side])
        kit.between(crank + [0, 0.04 * side, 0], end, 0.012, material=metal)
        kit.add(BOX, end + [0, 0.05 * side, 0], (0.04, 0.045, 0.014), material=dark)
    arch(kit, single, 0, radius, radius + 0.035, 0.03, 20, 160, 4, coat)
    if cargo:
        kit.between(crank, (0.3, 0, 0.34), 0.024, material=coat)
        kit.between(crank + [0, 0.04, 0], (single, 0.05, radius), 0.014, material=coat, mirror=True)
        kit.between(saddle - [-0.04, 0, 0.14], (single, 0.05, radius), 0.014, material=coat, mirror=True)
        kit.between(crank + [-0.1, 0, 0.28], (0.32, 0, 0.5), 0.022, material=coat)
        slab(kit, 0.3, rng.uniform(0.7, 0.85), (0.3, 1.1, track - 0.06), (0.22, 1.2, track - 0.03), kit.material(base=second.first, pattern=rng.choice([PLAIN, PLANKS, WRITING]), frequency=8))
        kit.between((0.24, 0.3, 0.76), (0.1, 0.3, 0.92), 0.016, material=metal, mirror=True)
        kit.between((0.1, -0.34, 0.92), (0.1, 0.34, 0.92), 0.016, material=dark)
        kit.add(BOX, (pair, 0, 0.3), (0.1, track - 0.1, 0.03), material=dark)
        if kit.chance(0.5):
            for x in (0.26, 1.15):
                kit.between((x, track - 0.06, 0.7), (x, track - 0.08, 1.35), 0.014, material=metal, mirror=True)
            kit.add(BOX, (0.7, 0, 1.37), (0.56, track, 0.03), (0.95, 0.9), material=kit.material(pattern=rng.choice([PLAIN, STRIPES]), frequency=9))
        return
    kit.between(crank, head - [0, 0, 0.12], 0.024, material=coat)
    kit.between(saddle - [-0.04, 0, 0.12], head - [0, 0, 0.02], 0.022, material=coat)
    kit.between(head + [-0.02, 0, 0.12], head + [0.05, 0, -0.2], 0.026, material=coat)
    kit.between(head + [0.04, 0.05, -0.18], (single, 0.05, radius), 0.015, material=metal, mirror=True)
    kit.between(head + [-0.02, 0, 0.11], head + [-0.14, 0.28, 0.13], 0.014, material=metal, mirror=True)
    kit.between(crank, (-0.2, 0.2, 0.4), 0.02, material=coat, mirror=True)
    kit.add(BOX, (-0.35, 0, 0.42), (0.45, track - 0.06, 0.025), material=dark)
    kit.between((pair, 0.3, radius), (pair, 0.3, 0.42), 0.02, material=metal, mirror=True)
    section(kit, -0.8, -0.3, (0.43, 0.68, track - 0.06), (0.43, 0.66, track - 0.06), coat)
    seat(kit, -0.5, 0, 0.62, track - 0.1, 0.5, cloth)
    kit.add(BOX, (-0.5, track - 0.05, 0.78), (0.26, 0.025, 0.1), (0.9, 1), material=coat, mirror=True)
    arch(kit, pair, track, radius, radius + 0.045, 0.05, 20, 160, 3, second)
    if kit.chance(0.75):
        canopy = kit.material(pattern=rng.choice([PLAIN, STRIPES]), frequency=8)
        hood(kit, np.array([-0.68, 0, 0.9]), rng.uniform(0.62, 0.72), track - 0.02, (15, 60, 100, 140), canopy, metal)


def light_vehicle(kit):
    """Quads, side-by-sides, sand rails, snowmobiles, jet skis, karts, golf carts, mobility scooters, kick scooters, tuk-tuks, microcars, mowers, pedal and soapbox cars, hand bikes, wheelchairs, rickshaws."""
    makers = [quad, quad, buggy, buggy, snowmobile, jet_ski, kart, golf_cart, mobility, stander, tuk_tuk, microcar, mower, mower, pedal_car, low_trike, wheelchair, rickshaw]
    kit.rng.choice(makers)(kit)
