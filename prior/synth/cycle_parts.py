"""What the makers of motorbikes and light vehicles share: paints, wheels, forks, frames, engines, exhausts, handlebars, lamps."""

from contextlib import contextmanager
from typing import NamedTuple

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, SPOKES
from .materials import BANDS, CHECKER, PLAIN, STRIPES, WRITING, Material
from .materials import paint as hue_paint
from .roadcraft import RING, arch, car_paint, chrome, hide, rubber

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
            kit.add(
                CYL,
                (base, halves[0] + 0.012, radii[0]),
                (radii[0] * 0.52,) * 2 + (0.006,),
                rotation=ALONG_Y,
                material=disc,
                mirror=halves[0] > 0.05,
                cut=(SPOKES, 6, 0.14),
            )
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
            kit.between(
                foot + [0, apart, 0],
                foot + up * split + [0, apart, 0],
                thin if fork == "usd" else fat,
                material=metal if fork == "usd" or kit.chance(0.5) else dark,
                mirror=True,
            )
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
        kit.between(
            (b.pivot[0] - 0.1, y if mirror else -y, 0.3),
            (-b.base - rng.uniform(0, 0.15), (y + 0.03) * (1 if mirror else -1), rise),
            (0.055, 0.048),
            taper=1.1,
            material=can,
            mirror=mirror,
        )


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
