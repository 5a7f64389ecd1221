"""A maker of motorcycles of every build, with scooters, three-wheelers and sidecars."""

import numpy as np

from .cycle_parts import RED, WHITE, bars, chassis, exhaust, finish, fins, flat, frame, front_guard, lacquer, motor, open_wheel, rear_guard, round_lamp, shocks, steered
from .kit import ALONG_X, ALONG_Y, turn
from .launchers import drab
from .layout import BALL, BOX, CYL, SPOKES
from .materials import PLAIN, RIBS, WRITING
from .roadcraft import RING, arch, chrome, hide, rims, rubber, section, slab
from .scooters import maxi_scooter, moped, small_scooter
from .wheeled import glazing


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
        grip = (
            bars(kit, b, 0.3, -0.02, 0.14, kit.chance(0.4), True)
            if kind == "cafe"
            else bars(kit, b, rng.uniform(0.34, 0.42), rng.uniform(0.06, 0.14), 0.14, kit.chance(0.5))
        )
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
    b = chassis(
        kit,
        base,
        (front[0], rear[0]),
        (front[1], rear[1]),
        rake,
        rng.uniform(0.95, 1.05) if chopper else 0.92,
        rng.uniform(0.62, 0.7),
        rng.choice(["cast", "wire"]),
        fork,
    )
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
    b = chassis(
        kit,
        rng.uniform(0.75, 0.8),
        (0.34, 0.32),
        (0.055, 0.078),
        rng.uniform(25, 28),
        rng.uniform(1.06, 1.12),
        rng.uniform(0.84, 0.9),
        rng.choice(["wire", "wire", "cast"]),
        fork,
        knobbly=kit.chance(0.6),
    )
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
    b = chassis(
        kit,
        rng.uniform(0.72, 0.76) if not trial else 0.66,
        radii,
        halves,
        rng.uniform(24, 28),
        rng.uniform(1.06, 1.12) if not trial else 0.98,
        0.94 if not trial else 0.72,
        "wire",
        rng.choice(["usd", "gaiter"]),
        knobbly=kind != "supermoto",
    )
    b = b._replace(pivot=np.array([-b.base + 0.56, 0, 0.42]))
    z = b.saddle
    frame(
        kit,
        b,
        rng.choice(["cradle", "cradle", "beam"]),
        rng.choice([0, 1]) and b.metal or flat(kit, b.second.first),
        (-b.base * 0.85, 0.06, z - 0.02 if not trial else 0.72),
    )
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
    kit.between(
        b.pivot + [-0.04, 0, 0.02], b.pivot + [-0.12, 0, z - b.pivot[2] - 0.12], 0.042, material=fins(kit, [0.65, 0.08, 0.03] if kit.chance(0.5) else [0.6, 0.5, 0.05])
    )
    finish(
        kit,
        b,
        grip,
        (-b.base - 0.12, 0, z - 0.01 if not trial else z + 0.03),
        (-b.base - 0.28, 0, z - 0.2) if kind == "enduro" else None,
        rng.choice(["side", "side", "none"]),
    )


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
    b = chassis(
        kit,
        rng.uniform(0.7, 0.74),
        (0.33, 0.33),
        (0.048, 0.052),
        rng.uniform(26, 29),
        0.96,
        rng.uniform(0.72, 0.76),
        "wire",
        rng.choice(["girder", "tele"]),
        paint,
        service,
        not sidecar,
    )
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
    """Sport bikes, naked bikes, cafe racers, scramblers, classics, cruisers, baggers, choppers, tourers, adventure, cross, trial and dispatch bikes, mopeds, scooters,
    three-wheelers, sidecars."""
    makers = [sport, sport, roadster, roadster, roadster, cruiser, cruiser, tourer, adventure, adventure, dirt, dirt, moped, small_scooter, maxi_scooter, trike]
    makers += [dispatch, dispatch]
    kit.rng.choice(makers)(kit)
