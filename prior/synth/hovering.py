"""A maker of what hovers and hangs: helicopters of every build, tiltrotors, multicopters, gliders of cloth, kites, parachutes, balloons."""

import numpy as np

from .aircraft import propeller
from .boats import crew, white_paint
from .craft import rotor
from .flyers import panel, rounds, warpaint
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import BANDS, CHECKER, PLAIN, SEAMS, STREAKS, STRIPES, paint
from .people import person_body, skin_material
from .seacraft import ports
from .wheeled import coat, glazing


def hovering(kit):
    """Tiltrotors, tandem and coaxial helicopters, small helicopters, gyrocopters, drones, flying cars, hang gliders, paragliders, kites, parachutes, hot-air balloons."""
    kit.rng.choice([tiltrotor, tandem, coaxial, bubble_copter, gyrocopter, multicopter, flying_car, hang_glider, paraglider, kite, parachute, hot_air_balloon])(kit)


def tiltrotor(kit):
    """Tiltrotors with the nacelles up, forward or between; a high wing, twin fins or a T-tail."""
    rng = kit.rng
    skin, dark, glass = warpaint(kit) if kit.chance(0.65) else white_paint(kit), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(1.4, 1.7), rng.uniform(0.34, 0.4)
    z = fat + 0.28
    kit.add(BOX, (0, 0, z), (long * 0.6, fat * 0.85, fat), (1, 0.8), material=skin)
    kit.add(BALL, (long * 0.58, 0, z - fat * 0.08), (long * 0.4, fat * 0.82, fat * 0.88), material=skin)
    kit.add(BALL, (long * 0.66, 0, z + fat * 0.22), (long * 0.27, fat * 0.72, fat * 0.6), material=glass)
    kit.add(BOX, (-long * 0.82, 0, z + fat * 0.12), (fat * 0.85, fat * 0.8, long * 0.25), (0.35, 0.5), (fat * 0.5, 0), turn("y", -90), skin)
    kit.add(BOX, (-0.1, fat * 0.95, z - fat * 0.6), (0.5, fat * 0.3, fat * 0.35), (0.8, 0.8), material=skin, mirror=True)
    kit.add(BOX, (0.0, 0, z + fat * 0.25), (long * 0.45, fat * 0.86, 0.07), material=ports(kit, 8))
    high, span = z + fat * 1.1, rng.uniform(1.25, 1.5)
    kit.add(BOX, (0, 0, high - 0.05), (0.45, fat * 0.6, 0.12), (0.8, 0.8), material=skin)
    panel(kit, (0, 0, high), span, 0.3, skin, 0.9, -0.1, 2, 0.07)
    tilt = turn("y", rng.choice([0.0, 0.0, 90.0, rng.uniform(20, 75)]))
    for y in (-1, 1):
        pod = np.array([0.1, y * span, high + 0.05])
        kit.add(CYL, pod + tilt @ np.array([0, 0, 0.08]), (0.17, 0.16, 0.42), (0.75, 1), rotation=tilt, material=skin)
        hub = pod + tilt @ np.array([0, 0, 0.58])
        kit.add(CYL, hub, (0.12, 0.12, 0.12), (0.3, 1), rotation=tilt, material=dark)
        first, reach = rng.uniform(0, 120), span * rng.uniform(0.7, 0.85)
        for k in range(3):
            way = tilt @ turn("z", first + 120 * k)
            kit.add(BOX, hub + way @ np.array([reach / 2, 0, 0]), (reach / 2, 0.075, 0.014), rotation=way @ turn("x", 12), material=dark)
    tail = np.array([-long * 1.0, 0, z + fat * 0.45])
    kit.add(BOX, tail, (0.2, 0.72, 0.03), material=skin)
    kit.add(BOX, tail + [-0.02, 0.72, 0.05], (0.25, 0.03, 0.42), (0.65, 1), (-0.1, 0), material=skin, mirror=True)
    rounds(kit, [(long * 0.6, 0, z - fat * 0.7), (-0.15, fat * 1.0, z - fat * 0.7)], 0.13, dark)
    kit.add(BOX, (-long * 0.78, 0, z - fat * 0.38), (0.3, fat * 0.5, 0.02), rotation=turn("y", 28), material=dark)


def tandem(kit):
    """Helicopters with a rotor at either end: long boxes with pods along the belly, or round and bent like a banana."""
    rng = kit.rng
    skin, dark, glass = coat(kit) if kit.chance(0.7) else kit.material(pattern=PLAIN, gloss=0.3), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(1.7, 2.2), rng.uniform(0.38, 0.46)
    z = fat + 0.3
    kit.add(BOX, (0, 0, z), (long * 0.75, fat, fat), (1, 0.85), material=skin)
    kit.add(BALL, (long * 0.74, 0, z - fat * 0.05), (0.55, fat * 0.95, fat * 0.92), material=skin)
    kit.add(BALL, (long * 0.8, 0, z + fat * 0.2), (0.47, fat * 0.84, fat * 0.62), material=glass)
    kit.add(BOX, (-long * 0.88, 0, z + fat * 0.1), (fat * 0.9, fat * 0.95, long * 0.16), (0.6, 0.8), (fat * 0.32, 0), turn("y", -90), skin)
    kit.add(BOX, (-long * 0.1, fat * 1.05, z - fat * 0.65), (long * 0.55, fat * 0.25, fat * 0.35), (0.9, 0.7), material=skin, mirror=True)
    for k in range(int(rng.integers(3, 6))):
        kit.add(CYL, (long * (0.5 - 0.25 * k), fat * 0.93, z + fat * 0.3), (0.09, 0.09, 0.03), rotation=ALONG_Y, material=glass, mirror=True)
    front, rear = np.array([long * 0.62, 0, z + fat * 1.75]), np.array([-long * 0.82, 0, z + fat * rng.uniform(2.6, 3.1)])
    kit.add(BOX, (front[0], 0, z + fat * 1.25), (0.42, fat * 0.5, fat * 0.4), (0.6, 0.6), material=skin)
    kit.add(BOX, (rear[0], 0, (z + fat * 0.8 + rear[2]) / 2 - 0.08), (0.5, fat * 0.42, (rear[2] - z - fat * 0.8) / 2), (0.65, 0.6), (-0.08, 0), material=skin)
    kit.add(CYL, (rear[0], fat * 0.62, z + fat * 1.15), (0.17, 0.17, 0.36), (0.85, 1), rotation=turn("y", -90), material=dark if kit.chance(0.5) else skin, mirror=True)
    kit.between((front[0], 0, z + fat * 1.05), (rear[0], 0, z + fat * 1.1), (0.1, fat * 0.3), BOX, material=skin)
    blades, reach = int(rng.choice([2, 3, 3])), long * rng.uniform(0.85, 1.0)
    rotor(kit, front, reach, blades, dark)
    rotor(kit, rear, reach, blades, dark)
    rounds(kit, [(long * 0.45, fat * 1.0, z - fat * 0.7), (-long * 0.55, fat * 1.0, z - fat * 0.7)], 0.15, dark)
    if kit.chance(0.5):
        kit.add(BOX, (-long * 1.02, 0, z - fat * 0.15), (0.03, fat * 0.7, fat * 0.4), rotation=turn("y", 15), material=dark)
    if kit.chance(0.3):
        drop = rng.uniform(0.5, 0.8)
        for p in kit.primitives:
            p.centre[2] += drop
        kit.between((0, 0, drop), (0, 0, z + drop - fat), 0.015, material=dark)
        kit.add(BOX, (0, 0, drop * 0.5), (drop * 0.8, drop * 0.5, drop * 0.5), material=coat(kit))


def coaxial(kit):
    """Helicopters with two rotors on one mast, a short tail and two fins."""
    rng = kit.rng
    skin, dark, glass = coat(kit) if kit.chance(0.5) else kit.material(pattern=PLAIN, gloss=0.3), kit.material(dark=True), glazing(kit)
    long, fat = rng.uniform(0.8, 1.1), rng.uniform(0.42, 0.52)
    z = fat + 0.35
    kit.add(BOX, (0, 0, z), (long * 0.75, fat * 0.85, fat), (0.9, 0.85), material=skin)
    kit.add(BALL, (long * 0.68, 0, z - fat * 0.1), (long * 0.48, fat * 0.82, fat * 0.88), material=skin)
    kit.add(BALL, (long * 0.76, 0, z + fat * 0.12), (long * 0.38, fat * 0.74, fat * 0.66), material=glass)
    kit.add(BOX, (-0.1, 0, z + fat * 1.2), (long * 0.6, fat * 0.55, fat * 0.3), (0.75, 0.7), material=skin)
    kit.add(CYL, (long * 0.25, fat * 0.4, z + fat * 1.2), (0.15, 0.15, 0.35), rotation=ALONG_X, material=dark, mirror=True)
    hub = np.array([0, 0, z + fat * 1.5])
    gap, reach, blades = rng.uniform(0.3, 0.42), rng.uniform(1.5, 2.0), int(rng.choice([2, 3, 3]))
    kit.between(hub - [0, 0, 0.1], hub + [0, 0, 0.25 + gap], 0.06, material=dark)
    rotor(kit, hub + [0, 0, 0.12], reach, blades, dark)
    rotor(kit, hub + [0, 0, 0.12 + gap], reach, blades, dark)
    tail = np.array([-long - rng.uniform(0.7, 1.0), 0, z + fat * 0.45])
    kit.between((-long * 0.7, 0, z + fat * 0.3), tail, (fat * 0.5, fat * 0.5), BOX if kit.chance(0.5) else CYL, 0.5, material=skin)
    kit.add(BOX, tail + [0.05, 0, 0.02], (0.18, 0.62, 0.025), material=skin)
    kit.add(BOX, tail + [0.0, 0.62, 0.1], (0.24, 0.03, 0.36), (0.65, 1), (-0.12, 0), material=skin, mirror=True)
    rounds(kit, [(long * 0.75, fat * 0.45, z - fat * 0.8), (-long * 0.4, fat * 1.05, z - fat * 0.5)], 0.15, dark)
    kit.add(BOX, (-0.05, fat * 0.84, z - fat * 0.05), (0.3, 0.03, fat * 0.65), material=kit.material(), mirror=True)
    kit.add(BOX, (long * 0.3, fat * 0.83, z + fat * 0.3), (0.15, 0.04, fat * 0.3), material=glass, mirror=True)
    kit.add(CYL, (-0.2, fat * 1.0, z - fat * 0.65), (0.13, 0.13, 0.4), rotation=ALONG_X, material=skin, mirror=True)


def bubble_copter(kit):
    """Small helicopters: a round bubble, an open lattice or a slender boom, two blades, skids."""
    rng = kit.rng
    skin, dark, glass = kit.material(pattern=PLAIN, gloss=0.4), kit.material(dark=True), kit.material(base=[0.12, 0.16, 0.18], gloss=0.64, pattern=PLAIN)
    tube = skin if kit.chance(0.4) else kit.material(base=np.ones(3) * rng.uniform(0.1, 0.6))
    fat, z = rng.uniform(0.48, 0.58), 0.95
    lattice = kit.chance(0.6)
    kit.add(BALL, (0.35, 0, z), (fat * rng.uniform(1.0, 1.25), fat * 0.95, fat), material=glass)
    kit.add(BOX, (0.2, 0, z - fat * 0.75), (0.6, fat * 0.6, fat * 0.25), (0.9, 1.1), material=skin)
    kit.add(BOX, (0.05, 0, z - fat * 0.3), (0.1, fat * 0.6, fat * 0.5), (0.8, 1), (-0.08, 0), material=dark)
    if not lattice:
        kit.add(BALL, (-0.1, 0, z), (0.75, fat * 0.85, fat * 0.8), material=skin)
    kit.add(BOX, (-0.4, 0, z - 0.15), (0.28, 0.25, 0.28), (0.8, 0.8), material=dark)
    kit.add(CYL, (-0.25, 0.38, z + 0.1), (0.16, 0.16, 0.26), rotation=ALONG_X, material=skin, mirror=True)
    mast = np.array([-0.2, 0, z + fat + rng.uniform(0.35, 0.5)])
    kit.between((-0.2, 0, z), mast, 0.05, material=dark)
    rotor(kit, mast, rng.uniform(2.0, 2.5), 2 if kit.chance(0.7) else 3, dark)
    tail = np.array([-2.4, 0, z + 0.25])
    if lattice:
        for y0, z0 in ((0.25, 0.25), (0.2, -0.3)):
            kit.between((-0.3, y0, z + z0), tail + [0, 0.02, 0], 0.022, material=tube, mirror=True)
        for k in range(5):
            t, u = k / 5, (k + 1) / 5
            a, b = np.array([-0.3, 0.25, z + 0.25]), np.array([-0.3, 0.2, z - 0.3])
            kit.between(a + (tail - a) * t, b + (tail - b) * u, 0.013, material=tube, mirror=True)
            kit.between(b + (tail - b) * t, b * (1, -1, 1) + (tail - b * (1, -1, 1)) * u, 0.013, material=tube)
    else:
        kit.between((-0.6, 0, z + 0.1), tail, 0.13, taper=0.5, material=skin)
    propeller(kit, tail + [-0.02, 0.1, 0.05], rng.uniform(0.3, 0.4), turn("x", 90), dark, 2)
    kit.add(TUBE, tail + [-0.05, 0.1, 0.0], (0.38, 0.42, 0.012), rotation=ALONG_Y, material=tube)
    kit.add(BOX, tail + [0.5, 0, 0.0], (0.13, 0.35, 0.015), material=skin)
    if not lattice:
        panel(kit, tail + [0.1, 0, -0.25], 0.7, 0.14, skin, 0.7, 0.12, 90, 0.02, False)
    for x in (-0.4, 0.55):
        kit.between((x, 0.25, z - fat * 0.8), (x, 0.75, 0.06), 0.028, material=tube, mirror=True)
    kit.add(CYL, (0.1, 0.75, 0.04), (0.035, 0.035, 1.0), rotation=ALONG_X, material=tube, mirror=True)
    kit.between((1.1, 0.75, 0.04), (1.25, 0.75, 0.16), 0.035, material=tube, mirror=True)
    if kit.chance(0.3):
        kit.add(BOX, (-0.05, 0.7, 0.3), (0.6, 0.18, 0.06), material=kit.material(), mirror=True)


def gyrocopter(kit):
    """Gyrocopters: an open or half-closed seat, an engine with a pushing propeller, a free rotor, a tall rudder."""
    rng = kit.rng
    skin, dark, tube = kit.material(pattern=PLAIN, gloss=0.4), kit.material(dark=True), kit.material(base=np.ones(3) * rng.uniform(0.1, 0.7), gloss=0.4)
    kit.add(BALL, (0.45, 0, 0.5), (0.75, 0.28, 0.26), material=skin)
    kit.between((-1.3, 0, 0.36), (0.9, 0, 0.36), 0.045, BOX, material=tube)
    if kit.chance(0.35):
        kit.add(BALL, (0.3, 0, 0.85), (0.62, 0.3, 0.45), material=glazing(kit))
    else:
        crew(kit, (0.1, 0, 0.62), (0.35, 0.15, 0.12), (0.7, 0.12, -0.08), 0.85, -0.15)
        kit.add(BOX, (0.72, 0, 0.82), (0.012, 0.2, 0.14), (1, 0.7), (-0.1, 0), material=glazing(kit))
    kit.add(BOX, (-0.08, 0, 0.75), (0.06, 0.2, 0.28), (1, 0.9), (-0.08, 0), material=dark)
    kit.add(BOX, (-0.5, 0, 0.75), (0.25, 0.2, 0.18), material=dark)
    propeller(kit, (-0.8, 0, 0.8), 0.5, ALONG_X, dark, int(rng.choice([2, 3])))
    hub = np.array([-0.2, 0, rng.uniform(1.6, 1.8)])
    kit.between((-0.2, 0, 0.38), hub, (0.04, 0.06), BOX, material=tube)
    start = len(kit.primitives)
    rotor(kit, hub + [0, 0, 0.1], rng.uniform(1.6, 2.0), 2, dark)
    lean = turn("y", -rng.uniform(4, 10))
    kit.primitives[start:] = [p._replace(centre=hub + lean @ (p.centre - hub), rotation=lean @ p.rotation) for p in kit.primitives[start:]]
    rounds(kit, [(0.85, 0, 0.4), (-0.25, 0.62, 0.42)], 0.17, tube)
    kit.between((-0.25, 0, 0.38), (-0.25, 0.6, 0.3), 0.03, material=tube, mirror=True)
    panel(kit, (-1.35, 0, 0.3), rng.uniform(0.7, 0.9), 0.25, skin, 0.7, 0.12, 90, 0.025, False)
    kit.add(BOX, (-1.3, 0, 0.4), (0.2, 0.45, 0.02), material=skin)
    kit.add(BOX, (-1.32, 0.45, 0.5), (0.2, 0.018, 0.22), (0.7, 1), (-0.06, 0), material=skin, mirror=True)


def multicopter(kit):
    """Quadcopters and hexacopters with a camera, big spraying or parcel drones, racers."""
    rng = kit.rng
    skin = kit.material(base=np.ones(3) * rng.choice([0.03, 0.3, 0.75]), pattern=PLAIN, gloss=0.3) if kit.chance(0.7) else kit.material(gloss=0.3)
    dark, metal, trim = kit.material(dark=True), kit.material(base=np.ones(3) * rng.uniform(0.2, 0.6), gloss=0.5), kit.material(base=paint(rng.random(), 0.9, 0.6), pattern=PLAIN)
    count = int(rng.choice([4, 4, 6]))
    arm, z = rng.uniform(0.8, 1.05), rng.uniform(0.5, 0.65)
    body = rng.uniform(0.24, 0.34)
    if kit.chance(0.5):
        kit.add(BOX, (0, 0, z), (body * 1.4, body * 0.75, body * 0.36), (0.85, 0.75), (-0.04, 0), material=skin)
        kit.add(BALL, (body * 0.2, 0, z + body * 0.3), (body * 1.0, body * 0.6, body * 0.25), material=skin)
    else:
        kit.add(CYL, (0, 0, z), (body, body, body * 0.3), (0.85, 1), material=skin)
        kit.add(BALL, (0, 0, z + body * 0.28), (body * 0.8, body * 0.8, body * 0.3), material=dark if kit.chance(0.5) else skin)
    kit.add(BOX, (-body * 1.2, 0, z + 0.02), (0.1, body * 0.5, body * 0.22), material=dark)
    reach = arm * (0.62 if count == 4 else 0.46)
    for x, y in around(count, arm, 45 if count == 4 else 30):
        kit.between((x * 0.2, y * 0.2, z), (x, y, z + 0.06), (0.035, 0.045), BOX, 0.8, material=skin)
        kit.add(CYL, (x, y, z + 0.1), (0.075, 0.075, 0.07), material=metal)
        spin = turn("z", rng.uniform(0, 180))
        kit.add(BOX, (x, y, z + 0.18), (reach, 0.05, 0.01), rotation=spin, material=dark)
        if count == 4 and kit.chance(0.5):
            kit.add(BALL, (x, y, z + 0.0), (0.04, 0.04, 0.03), material=trim)
    kind = rng.choice(["camera", "tank", "parcel"], p=[0.6, 0.2, 0.2])
    if kind == "camera":
        kit.add(CYL, (body * 1.0, 0, z - body * 0.45), (0.05, 0.05, 0.08), material=metal)
        kit.add(BOX, (body * 1.0, 0.12, z - body * 0.65), (0.03, 0.02, 0.12), material=metal)
        kit.add(BOX, (body * 1.0, 0, z - body * 0.8), (0.12, 0.1, 0.09), rotation=turn("y", rng.uniform(0, 30)), material=dark)
        kit.add(CYL, (body * 1.0 + 0.13, 0, z - body * 0.84), (0.06, 0.06, 0.05), rotation=ALONG_X, material=kit.material(base=[0.02, 0.02, 0.04], gloss=0.64))
    elif kind == "tank":
        kit.add(BOX, (0, 0, z - 0.22), (0.2, 0.28, 0.16), material=kit.material(base=[0.7, 0.72, 0.68], pattern=PLAIN))
        kit.between((0, -arm, z - 0.12), (0, arm, z - 0.12), 0.018, material=metal)
    else:
        kit.add(BOX, (0, 0, z - 0.24), (0.26, 0.22, 0.17), material=kit.material(base=[0.42, 0.28, 0.15], pattern=PLAIN))
        kit.add(BOX, (0, 0, z - 0.24), (0.265, 0.03, 0.172), material=trim)
    foot = body * rng.uniform(1.0, 1.5)
    if kit.chance(0.7):
        for x in (-0.18, 0.18):
            kit.between((x, body * 0.4, z - 0.05), (x, foot, 0.03), 0.02, material=dark, mirror=True)
        kit.add(CYL, (0, foot, 0.025), (0.025, 0.025, 0.4), rotation=ALONG_X, material=dark, mirror=True)
    else:
        for x, y in around(count, arm * 0.95, 45 if count == 4 else 30):
            kit.between((x, y, z + 0.04), (x, y, 0), 0.025, taper=0.6, material=skin)


def flying_car(kit):
    """Flying cars and air taxis: a pod or a car with ducted fans, rotors on booms, or folding wings."""
    rng = kit.rng
    skin, dark, glass, trim = kit.material(pattern=PLAIN, gloss=0.5), kit.material(dark=True), glazing(kit), kit.material()
    long, fat, z = rng.uniform(0.9, 1.2), rng.uniform(0.4, 0.5), 0.55
    kind = rng.choice(["taxi", "ducts", "winged"])
    kit.add(BALL, (0, 0, z), (long, fat, fat * 0.75), material=skin)
    kit.add(BALL, (long * 0.22, 0, z + fat * 0.28), (long * 0.62, fat * 0.82, fat * 0.68), material=glass)
    kit.add(BOX, (0, 0, z - fat * 0.5), (long * 0.7, fat * 0.6, fat * 0.3), (1.1, 1.2), material=skin)
    if kind == "taxi":
        high = z + fat * 0.95
        kit.add(BOX, (-0.1, 0, high - 0.1), (0.35, fat * 0.5, 0.14), (0.9, 0.7), material=skin)
        panel(kit, (-0.1, 0, high), 1.7, 0.26, skin, 0.6, 0.1, 1, 0.04)
        for y in (0.75, 1.35)[: int(rng.integers(1, 3))]:
            kit.between((-1.0, y, high), (0.8, y, high), 0.06, material=skin, mirror=True)
            for x in (-0.95, 0.75):
                kit.between((x, y, high), (x, y, high + 0.16), 0.05, material=dark, mirror=True)
                kit.add(BOX, (x, y, high + 0.17), (0.035, 0.4, 0.012), rotation=turn("z", rng.uniform(0, 180)), material=dark, mirror=True)
        kit.between((-long * 0.7, 0, z + 0.1), (-long * 1.7, 0, z + 0.35), 0.18, taper=0.4, material=skin)
        panel(kit, (-long * 1.6, 0, z + 0.3), 0.6, 0.18, skin, 0.6, 0.15, 38, 0.025)
        kit.between((-0.45, fat * 0.5, z - fat * 0.6), (-0.5, fat * 0.9, 0.05), 0.03, material=dark, mirror=True)
        kit.between((0.45, fat * 0.5, z - fat * 0.6), (0.5, fat * 0.9, 0.05), 0.03, material=dark, mirror=True)
        kit.add(CYL, (0, fat * 0.9, 0.04), (0.035, 0.035, 0.75), rotation=ALONG_X, material=dark, mirror=True)
        return
    for x in (-long * 0.55, long * 0.55):
        kit.add(CYL, (x, fat * 0.85, 0.2), (0.2, 0.2, 0.08), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(CYL, (x, fat * 0.87, 0.2), (0.12, 0.12, 0.08), rotation=ALONG_Y, material=trim, mirror=True)
        kit.between((x, -fat * 0.8, 0.2), (x, fat * 0.8, 0.2), 0.05, material=dark)
    kit.add(BOX, (long * 0.93, fat * 0.45, z), (0.05, 0.1, 0.04), material=kit.material(base=[0.8] * 3), mirror=True)
    kit.add(BOX, (-long * 0.93, fat * 0.45, z), (0.05, 0.1, 0.04), material=kit.material(base=[0.5, 0.03, 0.03]), mirror=True)
    if kind == "ducts":
        radius = rng.uniform(0.34, 0.42)
        for x in (-long * 0.75, long * 0.75):
            for y in (-1, 1):
                at = np.array([x, y * (fat + radius * 1.05), z + 0.15])
                kit.add(TUBE, at, (radius, radius, 0.09), material=skin)
                kit.add(TUBE, at, (radius * 0.95, radius * 0.95, 0.085), material=dark)
                kit.between((x * 0.7, y * fat * 0.5, z), at, (0.035, 0.06), BOX, material=skin)
                propeller(kit, at, radius * 0.92, np.eye(3), dark, 4)
    else:
        panel(kit, (-long * 0.25, fat * 0.5, z + fat * 0.3), rng.uniform(1.4, 1.8), 0.32, skin, 0.65, 0.1, 3, 0.04)
        kit.between((-long * 0.6, fat * 0.7, z + 0.1), (-long * 1.8, fat * 0.7, z + 0.3), 0.07, taper=0.6, material=skin, mirror=True)
        kit.add(BOX, (-long * 1.78, 0, z + 0.32), (0.17, fat * 0.75, 0.025), material=skin)
        panel(kit, (-long * 1.72, fat * 0.7, z + 0.25), 0.42, 0.2, trim, 0.6, 0.15, 90, 0.025)
        propeller(kit, (-long * 1.06, 0, z + 0.1), 0.3, ALONG_X, dark)
        kit.between((-long * 0.9, 0, z + 0.1), (-long * 1.06, 0, z + 0.1), 0.06, material=dark)


def hang_glider(kit):
    """Hang gliders: a swept cloth wing on tubes and wires, the pilot prone or standing below."""
    rng = kit.rng
    cloth, edge = kit.material(pattern=rng.choice([PLAIN, STRIPES, BANDS]), frequency=rng.uniform(2, 4), gloss=0.1), kit.material()
    tube, dark = kit.material(base=np.ones(3) * rng.uniform(0.3, 0.7), gloss=0.5), kit.material(dark=True)
    span, chord, high = rng.uniform(1.9, 2.4), rng.uniform(0.5, 0.65), 1.7
    sweep, lift = span * rng.uniform(0.4, 0.55), rng.uniform(-1, 4)
    panel(kit, (0.1, 0, high), span, chord, cloth, 0.25, sweep, lift, 0.014)
    panel(kit, (0.1 + chord * 0.85, 0, high), span, chord * 0.16, edge, 0.4, sweep + chord * 0.62, lift, 0.024)
    kit.between((chord + 0.15, 0, high + 0.01), (-0.9, 0, high), 0.025, material=tube)
    if kit.chance(0.6):
        kit.between((0, 0, high), (0, 0, high + 0.45), 0.018, material=tube)
        for x in (chord, -0.85):
            kit.between((0, 0, high + 0.45), (x, 0, high), 0.006, material=dark)
        kit.between((0, 0, high + 0.45), (-sweep * 0.55, span * 0.6, high + span * 0.6 * np.radians(lift)), 0.006, material=dark, mirror=True)
    bar = np.array([0.25, 0, 0.75])
    kit.between(bar + [0, -0.5, 0], bar + [0, 0.5, 0], 0.02, material=tube)
    kit.between(bar + [0, 0.5, 0], (0.1, 0.03, high), 0.02, material=tube, mirror=True)
    for end in ((chord + 0.1, 0.02, high), (-0.85, 0.02, high), (-sweep * 0.55, span * 0.6, high + span * 0.6 * np.radians(lift))):
        kit.between(bar + [0, 0.5, 0], end, 0.006, material=dark, mirror=True)
    if kit.chance(0.75):
        suit, skin = kit.material(pattern=PLAIN), skin_material(kit)
        chest = np.array([0.05, 0, 0.98])
        kit.add(BALL, chest, (0.33, 0.19, 0.15), material=suit)
        kit.between(chest - [0.1, 0, 0], chest - [1.25, 0, 0.05], (0.14, 0.17), CYL, 0.55, material=suit)
        kit.add(BALL, chest + [0.4, 0, 0.1], (0.13, 0.11, 0.14), material=edge)
        kit.add(BALL, chest + [0.46, 0, 0.06], (0.09, 0.085, 0.09), material=skin)
        kit.chain([chest + [0.15, 0.18, 0], chest + [0.2, 0.36, -0.12], bar + [0, 0.25, 0]], [0.06, 0.05, 0.04], suit, mirror=True)
        kit.between(chest, (0, 0, high), 0.012, material=dark)
    else:
        person_body(kit, (0.1, 0, 0), 0.9, kit.material(), kit.material(), skin_material(kit), "stand")


def arch(kit, span, high, chord, cells, cloth, second, ends=0.35):
    """A canopy curved from side to side, of slabs across x. Returns the seams' points [(y, z), ...]."""
    angles = np.linspace(-1, 1, cells + 1) * np.pi * 0.42
    points = np.stack([np.sin(angles) / np.sin(np.pi * 0.42) * span, np.cos(angles) * high], 1)
    for k in range(cells):
        (y0, z0), (y1, z1) = points[k], points[k + 1]
        middle = abs(k - (cells - 1) / 2) / (cells / 2)
        half = chord * (1 - (1 - ends) * middle**2.5)
        roll = turn("x", np.degrees(np.arctan2(z1 - z0, y1 - y0)))
        centre = np.array([-(chord - half) * 0.5, (y0 + y1) / 2, (z0 + z1) / 2])
        kit.add(BOX, centre, (half, np.hypot(y1 - y0, z1 - z0) / 2 * 1.04, 0.05), (0.92, 1), (-0.03, 0), roll @ turn("y", 5), cloth if k % 2 == 0 or second is None else second)
    return points


def paraglider(kit):
    """Paragliders, kite-surfers' and ram-air canopies: a curved wing, lines, the pilot seated; some with a motor on the back."""
    rng = kit.rng
    cloth = kit.material(base=paint(rng.random(), rng.uniform(0.7, 1), rng.uniform(0.4, 0.9)), pattern=rng.choice([PLAIN, SEAMS, STRIPES]), frequency=rng.uniform(3, 8), gloss=0.1)
    second, line, dark = kit.material(pattern=PLAIN) if kit.chance(0.6) else None, kit.material(dark=True), kit.material(dark=True)
    span, drop = rng.uniform(1.7, 2.4), rng.uniform(1.6, 2.3)
    rise = span * rng.uniform(0.4, 0.6)
    cells = int(rng.choice([9, 11]))
    points = arch(kit, span, rise, rng.uniform(0.35, 0.5), cells, cloth, second, rng.choice([0.3, 0.75]))
    for p in kit.primitives:
        p.centre[2] += drop
    hip = np.array([0, 0, 0.0])
    seat = kit.material(pattern=PLAIN)
    crew(kit, hip, (0.05, 0.28, 0.75), (0.62, 0.12, -0.12), 0.62, -0.15)
    kit.add(BOX, (-0.1, 0, 0.08), (0.1, 0.16, 0.22), (0.8, 0.9), (-0.06, 0), material=seat)
    kit.add(BOX, (0.04, 0, -0.06), (0.18, 0.15, 0.05), material=seat)
    for y, z in points[cells // 2 + 1 :]:
        for x in (0.2, -0.2):
            kit.between((0, 0.12, 0.35), (x * 0.9, y, z + drop - 0.03), 0.006, material=line, mirror=True)
    if kit.chance(0.3):
        kit.add(TUBE, (-0.32, 0, 0.2), (0.48, 0.48, 0.015), rotation=ALONG_X, material=dark)
        propeller(kit, (-0.3, 0, 0.2), 0.42, ALONG_X, dark, 2)
        kit.between((-0.1, 0, 0.15), (-0.32, 0, 0.2), 0.08, material=dark)


def kite(kit):
    """Diamond, delta, box and sled kites with tails and bridles, some held by a child."""
    rng = kit.rng
    cloth = kit.material(base=paint(rng.random(), rng.uniform(0.7, 1), rng.uniform(0.4, 0.9)), pattern=rng.choice([PLAIN, STRIPES, BANDS, CHECKER]), frequency=rng.uniform(2, 5), gloss=0.1)
    second, stick, line = kit.material(pattern=PLAIN), kit.material(base=[0.35, 0.22, 0.1]), kit.material(dark=True)
    lean = turn("y", -rng.uniform(15, 60))
    kind = rng.choice(["diamond", "delta", "box"])
    start = len(kit.primitives)
    low = np.zeros(3)
    if kind == "diamond":
        wide, up, down = rng.uniform(0.65, 0.85), rng.uniform(0.4, 0.55), rng.uniform(1.0, 1.4)
        for y in (-1, 1):
            kit.add(BOX, (0, y * wide / 4, up / 2), (0.012, wide / 2, up / 2), (1, 0.03), (0, -y * wide / 2), material=cloth if y > 0 else second)
            kit.add(BOX, (0, y * wide / 4, -down / 2), (0.012, wide / 2, down / 2), (1, 0.03), (0, -y * wide / 2), turn("y", 180), second if y > 0 else cloth)
        kit.between((0.02, -wide, 0), (0.02, wide, 0), 0.018, material=stick)
        kit.between((0.02, 0, -down), (0.02, 0, up), 0.018, material=stick)
        low = np.array([0, 0, -down])
    elif kind == "delta":
        wide, tall = rng.uniform(1.2, 1.7), rng.uniform(0.9, 1.2)
        for y in (-1, 1):
            kit.add(BOX, (0, y * wide / 4, 0), (0.012, wide / 2, tall / 2), (1, 0.03), (0, -y * wide / 2), material=cloth)
            kit.between((0.015, y * wide, -tall / 2), (0.015, 0, tall / 2), 0.018, material=stick)
        kit.between((0.015, 0, -tall * 0.6), (0.015, 0, tall / 2), 0.018, material=stick)
        kit.add(BOX, (0.17, 0, -0.05), (0.17, 0.01, tall * 0.3), (0.05, 1), (-0.16, 0), material=second)
        kit.add(BOX, (0, 0, -tall * 0.53), (0.011, wide * 0.4, 0.09), (1, 1.6), material=second)
        low = np.array([0, 0, -tall * 0.6])
    else:
        half, tall = rng.uniform(0.4, 0.55), rng.uniform(0.9, 1.2)
        for z in (-1, 1):
            for k in range(4):
                spin = turn("z", 45 + 90 * k)
                kit.add(BOX, spin @ np.array([half * 0.72, 0, 0]) + [0, 0, z * tall * 0.66], (0.012, half * 0.72, tall * 0.3), rotation=spin, material=cloth if k % 2 else second)
        for x, y in around(4, half * 1.0):
            kit.between((x, y, -tall), (x, y, tall), 0.02, material=stick)
        kit.between((-half, 0, tall * 0.66), (half, 0, tall * 0.66), 0.014, material=stick)
        kit.between((0, -half, -tall * 0.66), (0, half, -tall * 0.66), 0.014, material=stick)
    kit.primitives[start:] = [p._replace(centre=lean @ p.centre, rotation=lean @ p.rotation) for p in kit.primitives[start:]]
    at = lean @ low
    if kind != "box":
        for _ in range(int(rng.integers(3, 7))):
            after = at + [rng.uniform(-0.25, 0.05), rng.uniform(-0.14, 0.14), -rng.uniform(0.2, 0.3)]
            kit.between(at, after, 0.012, material=line)
            kit.add(BOX, after, (0.02, 0.13, 0.05), rotation=turn("x", rng.uniform(-40, 40)), material=cloth if kit.chance(0.5) else second)
            at = after
    hand = np.array([1.3, 0, -1.4])
    kit.between((0.05, 0, 0), hand, 0.008, material=line)
    if kit.chance(0.35):
        person_body(kit, hand + [0.3, 0, -1.1], 0.75, kit.material(), kit.material(), skin_material(kit), "stand")
    else:
        kit.add(CYL, hand, (0.05, 0.05, 0.12), rotation=ALONG_Y, material=second)


def parachute(kit):
    """Round and square parachutes with somebody, a crate or a vehicle on their lines."""
    rng = kit.rng
    cloth = kit.material(base=np.array([0.3, 0.33, 0.2]) * rng.uniform(0.6, 2) if kit.chance(0.5) else paint(rng.random(), rng.uniform(0.1, 1), 0.8), pattern=rng.choice([PLAIN, STRIPES, SEAMS, CHECKER]), frequency=rng.uniform(3, 8), gloss=0.1)
    line, radius = kit.material(base=np.ones(3) * rng.uniform(0.05, 0.6)), rng.uniform(1.0, 1.3)
    lift = radius * rng.uniform(2.0, 2.4)
    high = radius * rng.uniform(0.55, 0.8)
    dome = [(0, 1.0), (0.3, 0.97), (0.58, 0.84), (0.82, 0.58), (0.96, 0.26), (1.0, 0.08)]
    for (z0, r0), (z1, r1) in zip(dome[:-1], dome[1:], strict=True):
        half = (radius * r0, radius * r0, (z1 - z0) * high / 2)
        kit.add(CYL if z0 else TUBE, (0, 0, lift + (z0 + z1) * high / 2), half, (r1 / r0, 1), material=cloth)
    rim = kit.material(pattern=PLAIN) if kit.chance(0.5) else cloth
    kit.add(TUBE, (0, 0, lift - 0.03), (radius, radius, 0.05), material=rim)
    top, count = np.array([0, 0, 0.95]), int(rng.choice([8, 10, 12]))
    load = rng.choice(["person", "crate", "capsule"], p=[0.5, 0.3, 0.2])
    if load == "person":
        for x, y in around(count, radius, 11):
            kit.between(top + [0, 0.14 * np.sign(y), 0], (x, y, lift), 0.008, material=line)
        crew(kit, (0, 0, 0.5), (0.04, 0.24, 0.72), (rng.uniform(0, 0.3), 0.15, -0.72), 0.8, 0.0)
        kit.add(BOX, (-0.13, 0, 0.75), (0.09, 0.15, 0.2), material=kit.material())
    else:
        for x, y in around(count, radius, 11):
            kit.between(top, (x, y, lift), 0.008, material=line)
        half = rng.uniform(0.28, 0.4)
        if load == "crate":
            kit.add(BOX, (0, 0, half), (half, half, half), material=kit.material(pattern=rng.choice([PLAIN, SEAMS, STRIPES])))
            for spin in (0, 90):
                kit.add(BOX, (0, 0, half), (half * 1.02, 0.05, half * 1.02), rotation=turn("z", spin), material=line)
            ends = [(x, y, 2 * half) for x, y in around(4, half * 1.3, 45)]
        else:
            kit.loft((0, 0, 0), [(0, half * 1.1), (0.08, half * 1.25), (half * 1.6, half * 0.55), (half * 1.8, half * 0.4)], kit.material(base=np.ones(3) * rng.uniform(0.1, 0.7), pattern=STREAKS))
            ends = [(x, y, half * 1.7) for x, y in around(4, half * 0.4, 45)]
        for end in ends:
            kit.between(end, top, 0.012, material=line)


def hot_air_balloon(kit):
    """Hot-air balloons: a drop-shaped envelope in gay stripes, a skirt, burner, ropes and a wicker basket with people."""
    rng = kit.rng
    base = paint(rng.random(), rng.uniform(0.6, 1), rng.uniform(0.4, 0.9))
    first = kit.material(base=base, second=paint(rng.random(), rng.uniform(0.3, 1), rng.uniform(0.3, 0.9)), pattern=rng.choice([PLAIN, STRIPES, BANDS, CHECKER, SEAMS]), frequency=rng.uniform(4, 9), gloss=0.15)
    others = [kit.material(base=paint(rng.random(), rng.uniform(0.5, 1), rng.uniform(0.3, 0.9)), pattern=PLAIN) for _ in range(2)]
    fat, start = rng.uniform(1.1, 1.4), 1.15
    tall = fat * rng.uniform(2.1, 2.5)
    profile = [(0, 0.2), (0.16, 0.4), (0.34, 0.69), (0.5, 0.89), (0.62, 0.98), (0.72, 1.0), (0.82, 0.93), (0.9, 0.77), (0.96, 0.53), (0.99, 0.27), (1.0, 0.1)]
    ringed = kit.chance(0.4)
    for k, ((z0, r0), (z1, r1)) in enumerate(zip(profile[:-1], profile[1:], strict=True)):
        skin = [first, *others][k // 2 % 3] if ringed else first
        kit.add(CYL, (0, 0, start + (z0 + z1) / 2 * tall), (fat * r0, fat * r0, (z1 - z0) * tall / 2), (r1 / r0, 1), material=skin)
    kit.add(TUBE, (0, 0, start - 0.1), (fat * 0.17, fat * 0.17, 0.11), (1.18, 1), material=others[0])
    if kit.chance(0.4):
        kit.add(CYL, (0, 0, start + 0.72 * tall), (fat * 1.01, fat * 1.01, tall * 0.05), material=others[1])
    half = rng.uniform(0.2, 0.28)
    wicker, dark = kit.material(base=[0.3, 0.17, 0.07], second=[0.16, 0.08, 0.03], pattern=CHECKER, frequency=40), kit.material(dark=True)
    kit.add(BOX, (0, 0, 0.05), (half, half, 0.05), material=wicker)
    for spin in (0, 90, 180, 270):
        out = turn("z", spin)
        kit.add(BOX, out @ np.array([half, 0, 0.2]), (0.03, half, 0.2), rotation=out, material=wicker)
    kit.add(BOX, (0, 0, 0.4), (half * 1.12, 0.03, 0.03), rotation=np.eye(3), material=dark)
    for x, y in around(4, half * 1.35, 45):
        kit.between((x, y, 0.35), (x * 0.75, y * 0.75, 0.8), 0.018, material=dark)
        kit.between((x * 0.75, y * 0.75, 0.8), (x * 0.8, y * 0.8, start + 0.05), 0.008, material=dark)
    kit.add(BOX, (0, 0, 0.8), (half * 0.75, half * 0.75, 0.02), material=dark)
    kit.add(CYL, (0, 0.06, 0.88), (0.05, 0.05, 0.08), material=dark, mirror=True)
    for x, y in ((0.09, 0.09), (-0.08, -0.1), (-0.08, 0.1))[: int(rng.integers(0, 4))]:
        kit.between((x, y, 0.05), (x, y, 0.5), (0.06, 0.08), CYL, material=kit.material())
        kit.add(BALL, (x, y, 0.56), (0.05, 0.05, 0.065), material=skin_material(kit))
        kit.add(BALL, (x - 0.01, y, 0.59), (0.053, 0.053, 0.05), material=dark)
