"""Makers of motorcycles, scooters and bicycles, on their stands or ridden."""

from itertools import pairwise

import numpy as np

from .bodies import Outfit, somebody
from .kit import ALONG_X, ALONG_Y, turn
from .launchers import drab
from .layout import BALL, BARS, BOX, CYL, GRID, SPOKES
from .materials import PLAIN, RIBS
from .patrol import Look, flat, spare
from .wheeled import glazing


def wheel_at(kit, x, radius, half, dark, metal, spokes, fat=False, y=0.0):
    """An open wheel: ring of a tyre, rim with spokes, hub."""
    kit.add(CYL, (x, y, radius), (radius, radius, half), rotation=ALONG_Y, material=dark, cut=(SPOKES, 1, 0.0))
    inner = radius * (0.78 if fat else 0.88)
    if fat:
        kit.add(CYL, (x, y, radius), (radius * 0.87, radius * 0.87, half * 0.9), rotation=ALONG_Y, material=dark, cut=(SPOKES, 1, 0.0))
    kit.add(CYL, (x, y, radius), (inner, inner, half * 0.55), rotation=ALONG_Y, material=metal, cut=spokes)
    kit.add(CYL, (x, y, radius), (radius * 0.12, radius * 0.12, half * 1.3), rotation=ALONG_Y, material=metal)


def guard(kit, x, radius, half, angles, material, count=3):
    """A mudguard: plates around the wheel's axle between two angles from the front over the top, in degrees."""
    ends = np.radians(np.linspace(*angles, count + 1))
    points = [np.array([x + (radius + 0.03) * np.cos(a), 0, radius + (radius + 0.03) * np.sin(a)]) for a in ends]
    for start, end in pairwise(points):
        kit.between(start + (start - end) * 0.04, end + (end - start) * 0.04, (0.012, half), BOX, material=material)


def sit(kit, seat, grips, pegs, lean, dressed=None):
    """A rider with hands at the grips and feet at the pegs, both of the left side."""
    outfit = dressed or Outfit(kit, hat="helmet" if kit.chance(0.8) else "cap")
    turned = np.array([1, -1, 1])
    feet = [pegs, pegs * turned] if np.ndim(pegs) == 1 else pegs
    somebody(kit, outfit, seat + [0, 0, 0.1], turn("y", lean), [grips + [0, 0, 0.02], grips * turned + [0, 0, 0.02]], feet, look=np.eye(3), knees=(1, 0, 0.5), small=True)


def leaned(kit, degrees, start, material):
    """All leant to the left, with a side stand from `start` to the ground."""
    frame = turn("x", -degrees)
    kit.primitives = [p._replace(centre=frame @ p.centre, rotation=frame @ p.rotation) for p in kit.primitives]
    top = frame @ np.array(start)
    kit.between(top, (top[0] - 0.06, top[1] + 0.16, 0.0), 0.015, material=material)
    kit.primitives.insert(0, kit.primitives.pop())


def motorbike(kit):
    """Naked bikes, cruisers, enduros, sports, touring, cafe racers and dispatch bikes, the last also with a sidecar."""
    rng = kit.rng
    kind = rng.choice(["naked", "cruiser", "enduro", "sports", "touring", "cafe", "dispatch", "sidecar"])
    old = kind in ("dispatch", "sidecar")
    ridden = kind != "sidecar" and kit.chance(0.2)
    plain = ridden or kind == "sidecar"
    paint = drab(kit) if old else kit.material(gloss=rng.uniform(0.3, 0.6), pattern=PLAIN)
    dark, chrome = kit.material(dark=True, pattern=PLAIN), kit.material(base=rng.uniform(0.3, 0.7) * np.ones(3), pattern=PLAIN, gloss=0.6)
    frame = paint if kit.chance(0.3) else dark
    leather = dark if kit.chance(0.7) else flat(kit, [0.2, 0.09, 0.03])
    engine = kit.material(base=rng.uniform(0.05, 0.4) * np.ones(3), pattern=RIBS, frequency=30, second=[0.04] * 3)
    base, rake, saddle = {
        "naked": (0.71, 24, 0.8), "cruiser": (0.83, 34, 0.66), "enduro": (0.73, 27, 0.9), "sports": (0.69, 23, 0.82),
        "touring": (0.77, 26, 0.8), "cafe": (0.71, 25, 0.77), "dispatch": (0.7, 27, 0.74), "sidecar": (0.71, 27, 0.74),
    }[kind]  # fmt: skip
    base *= rng.uniform(0.96, 1.05)
    front, rear = (0.36, 0.33) if kind == "enduro" else (0.33, 0.32) if old else (0.31, 0.31)
    cast = kind in ("naked", "sports", "touring") or (kind == "cruiser" and kit.chance(0.4))
    spokes = (SPOKES, int(rng.integers(3, 9)), rng.uniform(0.12, 0.25)) if cast else (SPOKES, int(rng.integers(16, 28)), 0.1)
    thick = rng.uniform(0.05, 0.065) if not old else 0.045
    wheel_at(kit, base, front, thick, dark, chrome if kit.chance(0.6) else dark, spokes, not plain)
    wheel_at(kit, -base, rear, thick * (1.6 if kind in ("sports", "cruiser", "naked") else 1.1), dark, chrome, spokes, not plain)
    up = np.array([-np.sin(np.radians(rake)), 0, np.cos(np.radians(rake))])
    axle, apart = np.array([base, 0, front]), thick + 0.045
    head = axle + up * (0.78 if kind == "enduro" else 0.7)
    kit.between(axle + [0, apart, 0], axle + up * 0.4 + [0, apart, 0], 0.034, material=dark if kind == "enduro" else chrome, mirror=True)
    kit.between(axle + up * 0.38 + [0, apart, 0], head + [0, apart, 0], 0.025, material=chrome, mirror=True)
    if not plain:
        kit.add(BOX, head - up * 0.02, (0.05, apart + 0.03, 0.02), rotation=turn("y", -rake), material=dark)
    kit.add(BOX, head - up * 0.2, (0.05, apart + 0.03, 0.02), rotation=turn("y", -rake), material=dark)
    neck, pivot = head - up * 0.1 - [0.05, 0, 0], np.array([-0.22, 0, 0.38])
    kit.between(head - up * 0.22, head, 0.045, material=frame)
    kit.between(neck, (-0.2, 0, saddle - 0.1), 0.035, material=frame)
    kit.between(neck - up * 0.06, (0.26, 0.08, 0.3), 0.022, material=frame, mirror=True)
    if not plain:
        kit.between((0.26, 0.08, 0.3), pivot + [0, 0.08, -0.08], 0.022, material=frame, mirror=True)
        kit.between((-0.2, 0.08, saddle - 0.1), pivot + [0, 0.08, -0.08], 0.03, material=frame, mirror=True)
    kit.between((-0.15, 0.07, saddle - 0.07), (-base * 0.95, 0.08, saddle), 0.02, material=frame, mirror=True)
    kit.between(pivot + [0, 0.1, 0], (-base, 0.12, rear), (0.03, 0.02), BOX, material=frame, mirror=True)
    kit.between((-base * 0.9, 0.12, rear + 0.05), (-base * 0.68, 0.12, saddle - 0.03), 0.028, material=chrome, mirror=True)
    kit.add(BALL if kit.chance(0.4) else BOX, (0.02, 0, 0.36), (0.25, 0.15, 0.12), material=engine._replace(pattern=PLAIN))
    motor = "boxer" if old and kit.chance(0.6) else "twin" if kind == "cruiser" else rng.choice(["four", "single", "twin"]) if kind != "enduro" else "single"
    if motor == "boxer":
        kit.add(CYL, (0.1, 0.24, 0.4), (0.09, 0.09, 0.13), rotation=ALONG_Y, material=engine, mirror=True)
        kit.add(BALL, (0.1, 0.37, 0.4), (0.09, 0.04, 0.08), material=chrome, mirror=True)
        kit.add(BOX, (0.0, 0, 0.54), (0.2, 0.1, 0.1), material=engine)
    elif motor == "twin":
        for angle in (-25, 25):
            kit.add(CYL, np.array([0.04, 0, 0.42]) + turn("y", angle) @ np.array([0, 0, 0.17]), (0.1, 0.09, 0.14), rotation=turn("y", angle), material=engine)
    else:
        tilt = rng.uniform(0, 25)
        kit.add(BOX, np.array([0.1, 0, 0.42]) + turn("y", tilt) @ np.array([0, 0, 0.14]), (0.1, 0.18 if motor == "four" else 0.09, 0.15), rotation=turn("y", tilt), material=engine)
    kit.between((0.2, 0.1, 0.5), (0.3, 0.13, 0.24), 0.025, material=chrome, mirror=motor != "single")
    high = kind == "enduro" or (kind == "sports" and kit.chance(0.6))
    kit.between((0.3, 0.13, 0.24), (-0.25, 0.15, 0.24), 0.025, material=chrome, mirror=motor != "single")
    kit.between((-0.22, -0.15, 0.24), (-base - 0.1, -0.2, 0.68 if high else 0.3), 0.05, taper=1.15, material=chrome if kit.chance(0.6) else dark)
    if kind == "sidecar":
        y = -0.95
        wheel_at(kit, -0.2, 0.31, 0.045, dark, chrome, spokes, False, y - 0.42)
        kit.add(BOX, (0.05, y, 0.52), (0.62, 0.27, 0.2), (0.95, 1.05), material=paint)
        kit.add(BALL, (0.62, y, 0.54), (0.5, 0.27, 0.21), rotation=turn("y", -8), material=paint)
        kit.add(BOX, (-0.2, y, 0.73), (0.3, 0.22, 0.03), material=leather)
        kit.add(BOX, (-0.5, y, 0.86), (0.06, 0.24, 0.2), material=leather)
        for x in (0.35, -0.35):
            kit.between((x, -0.05, 0.36), (x, y - 0.2, 0.36), 0.025, material=frame)
        kit.add(BOX, (-0.2, y - 0.42, 0.66), (0.34, 0.07, 0.02), material=paint)
        kit.between((-0.2, y - 0.42, 0.31), (-0.2, y, 0.36), 0.025, material=frame)
        kit.between((-0.2, y - 0.4, 0.66), (-0.2, y - 0.25, 0.6), 0.02, material=frame)
        spare(kit, (-0.62, y, 0.62), 0.3, 0.05, Look(paint, dark, dark, chrome, paint, dark))
    if kind in ("cruiser", "cafe") or old:
        kit.add(BALL, (0.12, 0, saddle + 0.08), (0.29, 0.15, 0.12), rotation=turn("y", -4), material=paint)
        kit.add(BOX, (-0.15, 0, 0.56), (0.1, 0.13, 0.12), material=dark)
    else:
        kit.add(BOX, (0.12, 0, saddle + 0.04), (0.25, 0.15 if kind != "enduro" else 0.11, 0.13), (0.6, 0.6), (0.04, 0), rotation=turn("y", -6), material=paint)
    if old and kit.chance(0.5):
        kit.add(BALL, (-0.28, 0, saddle + 0.03), (0.17, 0.13, 0.05), material=leather)
        kit.add(BALL, (-0.68, 0, saddle + 0.08), (0.17, 0.13, 0.05), material=leather)
        kit.add(BOX, (-0.48, 0, saddle - 0.03), (0.3, 0.08, 0.05), material=frame)
        kit.add(BOX, (-0.68, 0, saddle + 0.02), (0.1, 0.08, 0.04), material=frame)
    else:
        tail = {"sports": 10, "cruiser": -2, "enduro": 4, "cafe": 0}.get(kind, 3)
        kit.add(BOX, (-0.42, 0, saddle - 0.01), (0.33, 0.13 if kind != "enduro" else 0.1, 0.05), (0.92, 0.8), rotation=turn("y", tail), material=leather)
        if kind in ("sports", "cafe", "naked"):
            kit.add(BOX, (-0.72, 0, saddle + (0.06 if kind == "sports" else 0.03)), (0.2, 0.11, 0.07), (0.6, 0.6), (-0.06, 0), rotation=turn("y", tail), material=paint)
    rise, out = {"sports": (-0.04, 0.3), "cafe": (-0.02, 0.3), "cruiser": (0.16, 0.4), "enduro": (0.12, 0.4)}.get(kind, (0.1, 0.36))
    grip = head + [-0.14 if kind != "cruiser" else -0.22, out, rise]
    kit.between(head + [0, 0.05, 0], head + [-0.03, 0.14, rise * 0.9], 0.018, material=chrome, mirror=True)
    kit.between(head + [-0.03, 0.14, rise * 0.9], grip, 0.019, material=dark, mirror=True)
    if ridden:
        sit(kit, np.array([-0.3, 0, saddle + 0.04]), grip, np.array([-0.12, 0.2, 0.35]), {"sports": 35, "cafe": 28, "cruiser": -3}.get(kind, 10))
    lamp = head + np.array([0.13, 0, -0.06])
    white = flat(kit, [0.85, 0.85, 0.78], gloss=0.6)
    if kind == "enduro":
        guard(kit, base, front + 0.13, 0.07, (35, 125), paint, 2)
        kit.add(BOX, lamp, (0.03, 0.1, 0.14), (0.7, 0.8), material=paint)
        kit.add(BOX, lamp + [0.02, 0, 0], (0.03, 0.06, 0.05), material=white)
        kit.between((-0.6, 0, saddle - 0.02), (-base - 0.25, 0, saddle + 0.05), (0.015, 0.08), BOX, material=paint)
    else:
        guard(kit, base, front, thick + 0.02, (30, 150), paint, 2 if plain else 3)
        guard(kit, -base, rear, thick * 1.5 + 0.02, (40, 170) if kind != "sports" else (60, 120), paint if kind != "naked" else dark, 1 if kind == "sports" else 2 if plain else 3)
    if kind in ("sports", "touring"):
        kit.add(BALL, head + [0.1, 0, -0.02], (0.24, 0.19, 0.17), rotation=turn("y", 20), material=paint)
        kit.add(BOX, head + [0.02, 0, 0.15], (0.1, 0.14, 0.14 if kind == "sports" else 0.24), (0.5, 0.7), (-0.08, 0), rotation=turn("y", -18), material=glazing(kit))
        if kind == "sports" or kit.chance(0.4):
            kit.add(BALL, (0.24, 0.08, 0.6), (0.38, 0.1, 0.25), rotation=turn("y", -14), material=paint, mirror=True)
            kit.add(BOX, (0.06, 0, 0.29), (0.36, 0.12, 0.09), (1.1, 1.25), material=paint)
        kit.add(BALL, head + [0.27, 0.08, -0.05], (0.05, 0.06, 0.035), material=white, mirror=True)
    elif kind != "enduro":
        kit.add(BALL, lamp, (0.12, 0.1, 0.1), material=chrome if kit.chance(0.5) else paint)
        kit.add(CYL, lamp + [0.06, 0, 0], (0.085, 0.085, 0.055), rotation=ALONG_X, material=white)
    if kind == "touring" or old:
        case = leather if old and kit.chance(0.4) else paint
        kit.add(BOX, (-0.68, 0.28, 0.62), (0.22, 0.11, 0.17), (0.95, 0.9), material=case, mirror=True)
        kit.add(BOX, (-0.62, 0, 0.7), (0.03, 0.2, 0.03), material=frame)
        if kind == "touring" and kit.chance(0.7):
            kit.add(BOX, (-0.8, 0, saddle + 0.03), (0.2, 0.1, 0.04), material=frame)
            kit.add(BOX, (-0.86, 0, saddle + 0.2), (0.18, 0.24, 0.16), (0.9, 0.9), material=paint)
    kit.between((-0.22, 0.13, 0.33), (-base, 0.13, rear + 0.06), (0.03, 0.012), BOX, material=dark)
    kit.add(BOX, (-0.12, 0, 0.27), (0.02, 0.28, 0.015), material=dark)
    if ridden or kind == "sidecar":
        return
    kit.add(BOX, (-base - 0.16, 0, saddle - 0.1 if kind != "cruiser" else 0.6), (0.03, 0.05, 0.03), material=flat(kit, [0.5, 0.02, 0.02], gloss=0.5))
    style = rng.choice(["side", "side", "centre", "upright"])
    if kit.chance(0.7):
        kit.between(grip * [1, 0.7, 1], grip * [1, 0.8, 1] + [0.03, 0, 0.15], 0.008, material=dark, mirror=True)
        kit.add(BALL, grip * [1, 0.85, 1] + [0.03, 0, 0.16], (0.02, 0.06, 0.04), material=dark, mirror=True)
    if style == "side":
        leaned(kit, rng.uniform(6, 11), (-0.12, 0.12, 0.28), dark)
    elif style == "centre":
        kit.between((-0.15, 0.08, 0.28), (-0.3, 0.17, 0.0), 0.018, material=dark, mirror=True)


def motor_scooter(kit):
    """Scooters with a leg shield, a flat floor and the engine under the seat."""
    rng = kit.rng
    paint, dark = kit.material(gloss=0.5, pattern=PLAIN), kit.material(dark=True, pattern=PLAIN)
    chrome, white = kit.material(base=[0.55] * 3, gloss=0.6, pattern=PLAIN), flat(kit, [0.85, 0.85, 0.78], gloss=0.6)
    radius, base = rng.uniform(0.21, 0.25), rng.uniform(0.6, 0.68)
    spokes = (SPOKES, int(rng.integers(3, 8)), 0.3)
    wheel_at(kit, base, radius, 0.05, dark, chrome, spokes, True)
    wheel_at(kit, -base, radius, 0.055, dark, chrome, spokes, True)
    head = np.array([base - 0.22, 0, rng.uniform(0.95, 1.03)])
    kit.between((base, 0.075, radius), (base - 0.08, 0.075, radius + 0.32), 0.022, material=chrome, mirror=True)
    kit.between((base - 0.06, 0, radius + 0.28), head, 0.05, material=paint)
    kit.add(BOX, (base - 0.08, 0, radius + 0.3), (0.05, 0.1, 0.04), material=paint)
    kit.add(BALL, (base + 0.01, 0, radius * 1.75), (radius * 1.15, 0.1, radius * 0.6), material=paint)
    kit.add(BOX, (base - 0.22, 0, 0.62), (0.035, rng.uniform(0.2, 0.26), 0.33), (1, 0.7), (-0.1, 0), material=paint)
    kit.add(BOX, (0.08, 0, 0.31), (0.36, rng.uniform(0.17, 0.21), 0.035), material=dark)
    kit.add(BOX, (0.08, 0, 0.26), (0.36, 0.13, 0.04), material=paint)
    kit.add(BOX, (-0.28, 0, 0.5), (0.12, 0.14, 0.24), (0.9, 0.9), (-0.05, 0), material=paint)
    kit.add(BALL, (-0.5, 0, 0.57), (0.4, rng.uniform(0.17, 0.23), 0.2), rotation=turn("y", 8), material=paint)
    kit.add(BOX, (-0.4, 0, 0.77), (rng.uniform(0.28, 0.36), 0.13, 0.05), (0.9, 0.85), material=dark if kit.chance(0.6) else flat(kit, [0.25, 0.11, 0.04]))
    kit.add(BOX, (-0.5, 0.1, 0.27), (0.25, 0.05, 0.09), material=chrome)
    kit.add(CYL, (-0.55, -0.13, 0.28), (0.06, 0.06, 0.22), rotation=ALONG_X, material=dark)
    kit.add(BALL, head, (0.13, 0.13, 0.1), material=paint)
    kit.add(CYL, head + [0.1, 0, 0], (0.07, 0.07, 0.04), rotation=ALONG_X, material=white)
    grip = head + [-0.1, 0.32, 0.05]
    kit.between(head + [0, 0.05, 0.02], grip, 0.02, material=dark, mirror=True)
    kit.between((-0.8, 0, 0.55), (-0.9, 0, 0.4), (0.015, 0.07), BOX, material=dark)
    kit.add(BOX, (-0.88, 0, 0.6), (0.04, 0.07, 0.04), material=flat(kit, [0.5, 0.02, 0.02]))
    if kit.chance(0.25):
        sit(kit, np.array([-0.35, 0, 0.78]), grip, np.array([0.12, 0.13, 0.42]), 2)
        return
    kit.between(grip * [1, 0.75, 1], grip * [1, 0.85, 1] + [0.03, 0, 0.17], 0.009, material=chrome, mirror=True)
    kit.add(CYL, grip * [1, 0.9, 1] + [0.03, 0, 0.18], (0.055, 0.055, 0.012), rotation=ALONG_X, material=chrome, mirror=True)
    if kit.chance(0.4):
        kit.add(BOX, (-0.85, 0, 0.95), (0.18, 0.2, 0.17), (0.9, 0.9), material=kit.material())
        kit.add(BOX, (-0.75, 0, 0.77), (0.2, 0.1, 0.03), material=chrome)
    kit.between((-0.1, 0.08, 0.25), (-0.22, 0.16, 0.0), 0.016, material=dark, mirror=True)


def bicycle(kit):
    """Road, mountain, city, folding, tandem, cargo and children's bicycles, BMX."""
    rng = kit.rng
    kind = rng.choice(["road", "mountain", "city", "folding", "tandem", "cargo", "child", "bmx"])
    paint, dark = kit.material(gloss=0.5, pattern=PLAIN), kit.material(dark=True, pattern=PLAIN)
    chrome = kit.material(base=rng.uniform(0.35, 0.7) * np.ones(3), gloss=0.6, pattern=PLAIN)
    radius = {"folding": 0.22, "child": 0.2, "bmx": 0.25}.get(kind, 0.34)
    half = {"mountain": 0.03, "bmx": 0.028, "road": 0.014}.get(kind, 0.02)
    front = {"tandem": 1.2, "cargo": 1.5, "child": 0.38, "bmx": 0.5, "folding": 0.52}.get(kind, 0.58)
    rear, tube = {"child": -0.32, "bmx": -0.4, "folding": -0.45}.get(kind, -0.47), rng.uniform(0.016, 0.024)
    ahead = 0.24 if kind == "cargo" else radius
    spokes = (SPOKES, int(rng.integers(14, 26)), rng.uniform(0.06, 0.1))
    wheel_at(kit, front, ahead, half, dark, chrome, spokes)
    wheel_at(kit, rear, radius, half, dark, chrome, spokes)
    crank = np.array([-0.03, 0, {"child": 0.2, "bmx": 0.28}.get(kind, 0.29)])
    saddle = np.array([-0.2 if kind not in ("child", "bmx") else -0.16, 0, {"child": 0.52, "bmx": 0.62}.get(kind, rng.uniform(0.86, 0.98))])
    bar = {"child": 0.62, "bmx": 0.78}.get(kind, 0.82 if kind in ("road", "mountain", "tandem") else 0.8)
    head = np.array([(0.4 if kind == "cargo" else front - 0.18 if radius > 0.3 else front - 0.12), 0, bar])
    crown = np.array([front - 0.08, 0, 2 * radius + 0.06]) if kind != "cargo" else np.array([0.46, 0, 0.55])
    joint = crank + (saddle - crank) * (0.45 if kind in ("folding", "city") else 0.75)
    kit.between(crank, saddle, tube, material=paint)
    low = crank + [0.58, 0, 0] if kind == "tandem" else crank
    kit.between(crown + [-0.01, 0, 0.04], head, tube * 1.3, material=paint)
    if kind == "tandem":
        second = saddle + [0.62, 0, 0]
        kit.between(low, second, tube, material=paint)
        kit.between(crank, low, tube, material=paint)
        kit.between(joint, low + (second - low) * 0.4, tube, material=paint)
        kit.add(BALL, second + [0, 0, 0.02], (0.13, 0.075, 0.035), material=dark)
        kit.between(second - [0, 0, 0.08], second + [-0.22, 0, 0.06], tube * 0.8, material=chrome)
        kit.between(second + [-0.22, -0.25, 0.06], second + [-0.22, 0.25, 0.06], 0.014, material=dark)
    if kind == "cargo":
        kit.between(low, (0.5, 0, 0.3), tube * 1.4, material=paint)
        kit.between((0.5, 0, 0.3), (1.25, 0, 0.3), tube * 1.4, material=paint)
        kit.between((1.25, 0, 0.3), (1.38, 0, 0.66), tube * 1.4, material=paint)
        kit.between((1.38, 0, 0.66), (1.44, 0, 0.5), 0.03, material=chrome)
        kit.between((0.46, 0, 0.58), (0.5, 0, 0.3), tube * 1.3, material=paint)
        kit.add(BOX, (0.9, 0, 0.52), (0.38, 0.26, 0.2), (1.1, 1.12), material=kit.material(base=[0.4, 0.27, 0.14]) if kit.chance(0.5) else paint)
        crown = np.array([1.44, 0, 0.52])
    else:
        kit.between(crown + [-0.03, 0, 0.07] if kind != "folding" else head * [1, 1, 0.6], low, tube * 1.25, material=paint)
    if kind == "city" and kit.chance(0.6):
        kit.between(head - [0, 0, 0.08], crank + (saddle - crank) * 0.3, tube, material=paint)
    elif kind != "folding":
        kit.between(head - [0, 0, 0.04], joint if kind != "tandem" else saddle + [0.62, 0, -0.15], tube, material=paint)
        if kind == "tandem":
            kit.between(saddle + [0.62, 0, -0.15], joint, tube, material=paint)
    kit.between(joint, (rear, half + 0.03, radius), tube * 0.6, material=paint, mirror=True)
    kit.between(crank, (rear, half + 0.03, radius), tube * 0.7, material=paint, mirror=True)
    sprung = kind == "mountain"
    kit.between(crown + [0, half + 0.03, 0], (front, half + 0.03, ahead), 0.02 if sprung else tube * 0.75, material=dark if sprung else paint, mirror=True)
    kit.add(BOX, crown, (0.025, half + 0.05, 0.02), material=paint)
    kit.add(BALL, saddle + [-0.01, 0, 0.02], (0.13, 0.075 if kind != "road" else 0.06, 0.035), material=dark)
    top = head + [0.0, 0, {"city": 0.18, "folding": 0.2, "cargo": 0.2, "child": 0.08, "bmx": 0.06}.get(kind, 0.07)]
    kit.between(head, top, 0.016, material=chrome)
    if kind == "road" or (kind == "tandem" and kit.chance(0.5)):
        kit.between(top + [0.07, -0.2, 0], top + [0.07, 0.2, 0], 0.013, material=dark)
        kit.between(top, top + [0.08, 0, 0], 0.015, material=chrome)
        kit.between(top + [0.07, 0.2, 0], top + [0.17, 0.2, -0.03], 0.014, material=dark, mirror=True)
        kit.between(top + [0.17, 0.2, -0.03], top + [0.14, 0.2, -0.13], 0.014, material=dark, mirror=True)
        kit.between(top + [0.14, 0.2, -0.13], top + [0.03, 0.2, -0.14], 0.014, material=dark, mirror=True)
        grip = top + [0.15, 0.2, 0.0]
    elif kind in ("city", "cargo", "folding", "child"):
        grip = top + [-0.16, 0.24, 0.03]
        kit.between(top, top + [0.02, 0.16, 0.04], 0.012, material=chrome, mirror=True)
        kit.between(top + [0.02, 0.16, 0.04], grip, 0.015, material=dark, mirror=True)
    elif kind == "bmx":
        grip = top + [-0.03, 0.34, 0.18]
        kit.between(top, top + [0, 0.16, 0.17], 0.013, material=chrome, mirror=True)
        kit.between(top + [0, 0.16, 0.17], grip, 0.016, material=dark, mirror=True)
    else:
        grip = top + [-0.03, 0.34, 0.0]
        kit.between(top, grip, 0.014, material=dark, mirror=True)
    kit.add(CYL, crank + [0, -0.05, 0], (0.09 if kind != "child" else 0.06,) * 2 + (0.006,), rotation=ALONG_Y, material=chrome, cut=(SPOKES, 5, 0.3))
    arm = np.array([np.cos(t := rng.uniform(0, 6.28)), 0, np.sin(t)]) * (0.16 if kind != "child" else 0.1)
    for side in (-1, 1):
        kit.between(crank + [0, 0.07 * side, 0], crank + arm * side + [0, 0.09 * side, 0], 0.012, BOX, material=chrome)
        kit.add(BOX, crank + arm * side + [0, 0.14 * side, 0], (0.04, 0.05, 0.012), material=dark)
    kit.between(crank + [0, 0, 0], crank + [0, -0.08, 0], 0.022, material=chrome)
    if kind in ("city", "child") and kit.chance(0.7):
        kit.between(crank + [0.07, -0.06, 0.03], (rear, -0.06, radius), (0.05, 0.01), BOX, material=paint)
    else:
        for dz in (0.075, -0.075):
            kit.between(crank + [0, -0.05, dz], (rear, -0.05, radius + dz * 0.4), 0.006, material=dark)
    rider = kit.chance(0.2) and kind not in ("tandem", "child", "bmx")
    if kind in ("city", "folding", "cargo", "child") or kit.chance(0.1):
        guard(kit, rear, radius, half + 0.015, (30, 180), paint if kit.chance(0.6) else chrome, 4)
        guard(kit, front, ahead, half + 0.015, (55, 150), paint if kit.chance(0.6) else chrome, 3)
    if rider:
        feet = [crank + arm * s + [-0.02, 0.13 * s, 0.08] for s in (1, -1)]
        sit(kit, saddle + [0, 0, -0.02], grip, np.array(feet), {"road": 42, "mountain": 25}.get(kind, 8))
        return
    if kind == "child":
        for side in (-1, 1):
            kit.add(CYL, (rear, side * 0.2, 0.065), (0.065, 0.065, 0.018), rotation=ALONG_Y, material=dark)
            kit.between((rear, side * 0.03, radius), (rear, side * 0.18, 0.065), 0.012, material=chrome)
    if kind in ("city", "folding") and kit.chance(0.7):
        deck = 2 * radius + 0.1
        kit.add(BOX, (rear - 0.02, 0, deck), (0.22, 0.08, 0.012), material=chrome, cut=(BARS, 16, 0.4))
        kit.between((rear - 0.1, 0.07, deck), (rear, 0.05, radius), 0.008, material=chrome, mirror=True)
        kit.between((rear + 0.2, 0, deck), joint, 0.01, material=chrome)
    if kind == "city" and kit.chance(0.6):
        wicker = kit.material(base=[0.4, 0.25, 0.12]) if kit.chance(0.5) else chrome
        kit.add(BOX, head + [0.2, 0, 0.06], (0.14, 0.19, 0.12), (1.1, 1.1), material=wicker, cut=(GRID, 16, 0.35))
        kit.between(head - [0, 0, 0.04], head + [0.2, 0, -0.05], 0.012, material=chrome)
    kit.add(CYL, head + [0.05, 0, 0.02], (0.035, 0.035, 0.035), rotation=ALONG_X, material=chrome)
    if kind in ("road", "mountain") and kit.chance(0.6):
        kit.between(low + (crown - low) * 0.35 + [0, 0, 0.05], low + (crown - low) * 0.7 + [0, 0, 0.06], 0.036, material=kit.material())
    if kind != "child" and kit.chance(0.6):
        leaned(kit, rng.uniform(4, 8), (-0.12, 0.04, 0.3), chrome)


def odd_cycle(kit):
    """Penny-farthings and e-scooters."""
    rng = kit.rng
    paint, dark = kit.material(gloss=0.4, pattern=PLAIN, dark=kit.chance(0.5)), kit.material(dark=True, pattern=PLAIN)
    chrome = kit.material(base=[0.5] * 3, gloss=0.6, pattern=PLAIN)
    if kit.chance(0.5):
        big, small = rng.uniform(0.62, 0.74), rng.uniform(0.19, 0.25)
        rear = -big - small * rng.uniform(0.55, 0.9)
        spokes = (SPOKES, int(rng.integers(28, 44)), 0.07)
        wheel_at(kit, 0, big, 0.016, dark, chrome, spokes)
        wheel_at(kit, rear, small, 0.014, dark, chrome, (SPOKES, 16, 0.07))
        head = np.array([-0.06, 0, 2 * big + 0.1])
        kit.between((0, 0.05, big), head + [0, 0.04, 0], 0.016, material=paint, mirror=True)
        kit.add(BOX, head, (0.04, 0.06, 0.03), material=paint)
        reach = big + 0.06
        points = [head] + [np.array([reach * np.cos(a), 0, big + reach * np.sin(a)]) for a in np.radians([110, 130, 150, 170, 188])]
        points.append(np.array([rear + 0.03, 0, 2 * small + 0.05]))
        kit.chain(points, np.linspace(0.026, 0.018, len(points)), paint)
        kit.between(points[-1] + [0, 0.025, 0], (rear, 0.03, small), 0.011, material=paint, mirror=True)
        kit.add(BOX, points[-1], (0.03, 0.035, 0.015), material=paint)
        kit.add(BALL, (-0.24, 0, 2 * big + 0.14), (0.14, 0.09, 0.035), material=flat(kit, [0.2, 0.09, 0.04]))
        kit.between((-0.06, 0, 2 * big + 0.08), (-0.34, 0, 2 * big + 0.1), 0.015, material=paint)
        kit.between((-0.3, 0, 2 * big + 0.1), points[2], 0.012, material=paint)
        kit.between(head, head + [-0.02, 0, 0.1], 0.018, material=paint)
        kit.between(head + [-0.02, 0, 0.1], head + [-0.12, 0.32, 0.03], 0.014, material=dark, mirror=True)
        for side in (-1, 1):
            kit.between((0, 0.06 * side, big), (0.11 * side, 0.09 * side, big - 0.06 * side), 0.011, material=chrome)
            kit.add(BOX, (0.11 * side, 0.13 * side, big - 0.06 * side), (0.04, 0.05, 0.014), material=dark)
        return
    radius, base = rng.uniform(0.1, 0.14), rng.uniform(0.42, 0.5)
    for x in (base, -base):
        wheel_at(kit, x, radius, 0.022, dark, chrome, (SPOKES, 5, 0.4))
    deck = radius + 0.03
    kit.add(BOX, (-0.05, 0, deck), (base * 0.78, 0.085, 0.035), material=paint)
    kit.add(BOX, (-0.05, 0, deck + 0.037), (base * 0.72, 0.075, 0.005), material=dark)
    kit.between((-base * 0.75, 0.04, deck), (-base, 0.04, radius), (0.02, 0.012), BOX, material=paint, mirror=True)
    crown, top = np.array([base - 0.07, 0, 2 * radius + 0.06]), np.array([base - 0.22, 0, rng.uniform(1.02, 1.14)])
    kit.between(crown + [0.0, 0.035, 0], (base, 0.035, radius), 0.016, material=paint, mirror=True)
    kit.between(crown + [0, 0, -0.03], top, 0.028, material=paint)
    kit.between((base * 0.65, 0, deck), crown + [-0.01, 0, 0.05], (0.03, 0.045), BOX, material=paint)
    kit.add(BOX, crown, (0.03, 0.05, 0.025), material=paint)
    kit.between(top, top + [-0.03, 0.25, 0.02], 0.016, material=dark, mirror=True)
    kit.add(BOX, top, (0.05, 0.05, 0.03), material=dark)
    kit.add(CYL, top + [0.05, 0, -0.06], (0.03, 0.03, 0.03), rotation=ALONG_X, material=flat(kit, [0.85] * 3))
    guard(kit, -base, radius, 0.03, (50, 160), dark, 3)
    guard(kit, base, radius, 0.03, (30, 130), dark, 2)
    if kit.chance(0.3):
        feet = [np.array([0.12, 0.04, deck + 0.1]), np.array([-0.2, -0.04, deck + 0.1])]
        somebody(kit, Outfit(kit), (-0.1, 0, 0.88 + deck), turn("y", 4), [top + [-0.02, y, 0.04] for y in (0.22, -0.22)], feet, look=np.eye(3), small=True)
    else:
        kit.between((0.1, 0.06, deck), (0.06, 0.14, 0.0), 0.012, material=chrome)


def two_wheeler(kit):
    """Motorcycles of eight sorts, scooters, bicycles of eight sorts, penny-farthings and e-scooters, some with a rider."""
    kit.rng.choice([motorbike, motor_scooter, bicycle, odd_cycle], p=[0.42, 0.12, 0.34, 0.12])(kit)
