"""Makers of racing cars, karts, quads, buggies, rickshaws, choppers, wheelchairs, trolleys, barrows."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, GRID, RUNGS, SPOKES
from .machines import machine_paint
from .materials import BANDS, CLOUDY, PLAIN, PLANKS, RIBS, STRIPES, WRITING, paint
from .roadcraft import FLIP, RING, arch, car_paint, chrome, greenhouse, hide, hood, lights, rims, rubber, seat, section, slab, steering, timber, wired
from .wheeled import glazing


def driver(kit, x, z, reach=0.4):
    """Somebody with a helmet who sits on a seat at (x, z), both hands before them."""
    suit, helmet = kit.material(gloss=0.1), car_paint(kit)
    slab(kit, z, z + 0.5, (x - 0.13, x + 0.12, 0.16), (x - 0.12, x + 0.08, 0.21), suit)
    kit.add(BALL, (x + 0.02, 0, z + 0.66), (0.15, 0.13, 0.16), material=helmet)
    kit.add(BALL, (x + 0.07, 0, z + 0.66), (0.11, 0.1, 0.06), material=glazing(kit))
    kit.between((x, 0.2, z + 0.45), (x + reach, 0.15, z + 0.32), 0.055, taper=0.7, material=suit, mirror=True)
    kit.between((x, 0.1, z + 0.08), (x + 0.42, 0.16, z + 0.1), 0.085, taper=0.8, material=suit, mirror=True)


# Light, sporty, small.


def sporty(kit):
    """Racing cars, karts, quads, snowmobiles, golf carts, rickshaws, buggies, three-wheelers, hot rods, sidecars, choppers, mopeds, wheelchairs, prams, trolleys, barrows."""
    makers = [formula, formula, kart, quad, snowmobile, golf_cart, tuk_tuk, rickshaw, dune_buggy, beach_buggy, three_wheeler, hot_rod]
    makers += [sidecar, chopper, moped, upright, wheelchair, pushchair, trolley, wheelbarrow]
    kit.rng.choice(makers)(kit)


def formula(kit):
    rng = kit.rng
    coat, second, dark, tyre, hub = car_paint(kit), car_paint(kit), kit.material(dark=True, pattern=PLAIN), rubber(kit), chrome(kit)
    front, rear, track = rng.uniform(1.3, 1.6), -rng.uniform(1.3, 1.6), rng.uniform(0.66, 0.8)
    radius, nose = rng.uniform(0.29, 0.34), front + rng.uniform(0.7, 1.0)
    if kit.chance(0.25):  # a cigar of the fifties and sixties
        kit.loft((rear - 0.5, 0, 0.5), [(0, 0.12), (0.5, 0.3), (1.5, 0.36), (2.6, 0.33), (nose - rear, 0.24), (nose - rear + 0.3, 0.15)], coat, axis=ALONG_X)
        kit.add(CYL, (nose - 0.18, 0, 0.5), (0.15, 0.15, 0.02), rotation=ALONG_X, material=dark)
        kit.add(BALL, (-0.25, 0, 0.86), (0.4, 0.27, 0.1), material=dark)
        kit.add(BALL, (0.2, 0, 0.85), (0.12, 0.28, 0.2), rotation=turn("y", -30), material=glazing(kit))
        kit.between((-0.55, 0, 0.6), (-0.7, 0, 1.02), 0.1, BOX, 0.6, material=coat)
        kit.add(CYL, (0.5, 0.34, 0.6), (0.16, 0.16, 0.02), rotation=ALONG_Y, material=kit.material(base=[0.85] * 3, pattern=PLAIN), mirror=True)
        kit.between((rear * 0.4, 0.36, 0.42), (rear - 0.6, 0.4, 0.4), 0.05, material=hub, mirror=True)
        for x, half in ((front, 0.08), (rear, 0.11)):
            wired(kit, x, track, radius, half, tyre, hub, 16, 0.25)
            for dx, z in ((-0.2, 0.45), (0.2, 0.45), (0.0, 0.62)):
                kit.between((x + dx, 0.2, z), (x, track, radius), 0.022, material=hub, mirror=True)
    else:
        section(kit, 0.5, nose, (0.2, 0.62, 0.27), (0.2, rng.uniform(0.3, 0.4), 0.1), coat)
        section(kit, -0.7, 0.7, (0.08, 0.66, 0.36), (0.14, 0.6, 0.25), coat)
        section(kit, rear - 0.3, -0.5, (0.22, 0.5, 0.1), (0.1, rng.uniform(0.85, 1.0), 0.2), coat)
        pod = rng.uniform(0.4, 0.55)
        section(kit, rear + 0.25, 0.15, (0.1, 0.3, 0.1), (0.1, pod, 0.24), second if kit.chance(0.4) else coat, 0.48, True)
        kit.add(BOX, (0.16, 0.5, 0.32), (0.02, 0.18, (pod - 0.12) * 0.4), material=dark, mirror=True)
        kit.add(BOX, (-0.2, 0, 0.07), (1.3, track * 0.85, 0.025), material=dark)
        kit.add(BALL, (0.0, 0, 0.64), (0.45, 0.24, 0.06), material=dark)
        section(kit, -0.75, -0.42, (0.6, 1.0, 0.12), (0.7, 1.02, 0.15), second)
        kit.add(CYL, (-0.41, 0, 0.93), (0.07, 0.1, 0.02), rotation=ALONG_X, material=dark)
        kit.add(BALL, (-0.2, 0, 0.76), (0.14, 0.12, 0.15), material=car_paint(kit))
        kit.add(BALL, (-0.13, 0, 0.77), (0.1, 0.1, 0.05), material=glazing(kit))
        for x, half in ((front, 0.14), (rear, 0.19)):
            rims(kit, x, track, radius, half, tyre, hub, int(rng.integers(5, 10)) if kit.chance(0.5) else 0)
            for dx, z in ((-0.22, 0.25), (0.22, 0.25), (0.0, 0.46)):
                kit.between((x + dx, 0.1, z), (x, track, z * 0.6 + radius * 0.4), (0.015, 0.03), BOX, material=dark, mirror=True)
        wing = rng.uniform(0.75, 0.95)
        for k in range(int(rng.integers(1, 4))):
            kit.add(BOX, (nose - 0.05 - 0.17 * k, 0, 0.15 + 0.07 * k), (0.13, wing, 0.014), rotation=turn("y", 8 * k), material=coat if k else second)
        kit.add(BOX, (nose - 0.2, wing, 0.2), (0.28, 0.015, 0.12), material=second, mirror=True)
        kit.between((nose - 0.12, 0.07, 0.12), (nose - 0.2, 0.07, 0.36), (0.05, 0.02), BOX, material=coat, mirror=True)
        high, span = rng.uniform(0.8, 1.0), track * rng.uniform(0.75, 0.95)
        for k in range(2):
            kit.add(BOX, (rear - 0.4 - 0.16 * k, 0, high + 0.09 * k), (0.15, span, 0.016), rotation=turn("y", 12 + 12 * k), material=second if k else dark)
        kit.add(BOX, (rear - 0.45, span, high - 0.14), (0.3, 0.015, 0.28), material=second, mirror=True)
        kit.between((rear - 0.25, 0.06, 0.35), (rear - 0.4, 0.06, high), (0.08, 0.015), BOX, material=dark, mirror=True)
        if kit.chance(0.4):
            kit.between((-0.45, 0.26, 0.66), (0.15, 0.18, 0.88), 0.03, material=dark, mirror=True)
            kit.between((0.15, 0.19, 0.88), (0.42, 0, 0.84), 0.03, material=dark, mirror=True)
            kit.between((0.42, 0, 0.85), (0.5, 0, 0.58), 0.03, material=dark)


def kart(kit):
    rng = kit.rng
    coat, dark, tyre, steel = car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    front, rear, track, radius = rng.uniform(0.5, 0.62), -rng.uniform(0.45, 0.55), rng.uniform(0.5, 0.6), rng.uniform(0.12, 0.15)
    kit.add(BOX, (0.05, 0, 0.09), (front, 0.28, 0.02), material=steel)
    kit.between((rear - 0.1, 0.3, 0.1), (front + 0.15, 0.2, 0.1), 0.02, material=dark, mirror=True)
    kit.between((rear, -track, radius), (rear, track, radius), 0.02, material=steel)
    kit.between((front, -track, radius), (front, track, radius), 0.02, material=steel)
    for x, half in ((front, 0.06), (rear, 0.1)):
        rims(kit, x, track, radius, half, tyre, steel)
    section(kit, front + 0.05, front + 0.38, (0.06, 0.28, track * 0.8), (0.06, 0.14, track * 0.6), coat)
    section(kit, rear + 0.2, front - 0.22, (0.06, 0.22, 0.1), (0.06, 0.2, 0.08), coat, track - 0.03, True)
    section(kit, front - 0.2, front + 0.1, (0.2, 0.58, 0.13), (0.15, 0.28, 0.12), coat)
    seat_x = rng.uniform(-0.2, -0.1)
    slab(kit, 0.1, 0.2, (seat_x - 0.2, seat_x + 0.25, 0.17), (seat_x - 0.22, seat_x + 0.25, 0.19), dark)
    slab(kit, 0.12, 0.62, (seat_x - 0.24, seat_x - 0.15, 0.18), (seat_x - 0.4, seat_x - 0.36, 0.16), dark)
    kit.add(BOX, (seat_x - 0.05, 0.2, 0.25), (0.2, 0.015, 0.12), (0.7, 1), (-0.08, 0), material=dark, mirror=True)
    steering(kit, front - 0.3, 0, 0.55, dark, 0.15)
    kit.add(BOX, (rear + 0.1, -0.34, 0.27), (0.15, 0.12, 0.14), material=steel)
    kit.add(CYL, (rear + 0.12, -0.34, 0.45), (0.07, 0.07, 0.06), material=dark)
    kit.between((rear + 0.1, -0.2, 0.3), (rear - 0.28, -0.1, 0.28), 0.045, material=steel)
    kit.between((rear - 0.28, -track, 0.16), (rear - 0.28, track, 0.16), 0.03, BOX, material=coat if kit.chance(0.5) else dark)
    kit.between((rear, 0.25, 0.12), (rear - 0.28, 0.25, 0.16), 0.02, material=dark, mirror=True)
    kit.add(BOX, (front + 0.02, 0, 0.42), (0.01, 0.1, 0.1), rotation=turn("y", -30), material=kit.material(base=[0.85] * 3, pattern=WRITING, frequency=14, second=[0.02] * 3))
    if kit.chance(0.55):
        driver(kit, seat_x - 0.12, 0.2, front - 0.25 - seat_x)
        kit.between((seat_x + 0.28, 0.15, 0.28), (front + 0.05, 0.12, 0.14), 0.06, taper=0.8, material=dark, mirror=True)


def quad(kit):
    rng = kit.rng
    coat, dark, tyre, metal = car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    reach, track, radius = rng.uniform(0.55, 0.7), rng.uniform(0.4, 0.5), rng.uniform(0.25, 0.33)
    for x, half in ((reach, 0.12), (-reach, 0.15)):
        rims(kit, x, track, radius, half, tyre, metal)
        kit.between((x, -track, radius), (x, track, radius), 0.04, material=dark)
        kit.between((x * 0.6, 0.12, radius + 0.35), (x, track * 0.6, radius), 0.035, material=metal, mirror=True)
        section(kit, x - radius * 1.2, x + radius * 1.2, (2 * radius + 0.03, 2 * radius + 0.1, 0.15), (2 * radius + 0.0, 2 * radius + 0.12, 0.13), coat, track - 0.02, True)
        way = 1 if x > 0 else -1
        kit.between((x - way * radius * 1.1, track - 0.02, 2 * radius + 0.07), (x - way * radius * 1.35, track - 0.02, radius + 0.05), (0.025, 0.13), BOX, material=coat, mirror=True)
    deck = 2 * radius + 0.08
    kit.add(BOX, (0, 0, radius + 0.1), (reach * 0.8, 0.15, 0.16), material=dark)
    kit.add(BOX, (0, track * 0.75, radius * 0.75), (reach * 0.42, 0.12, 0.025), material=dark, mirror=True)
    kit.between((0, -track * 0.7, radius * 0.75), (0, track * 0.7, radius * 0.75), 0.03, material=dark)
    section(kit, -reach * 1.15, -0.05, (deck + 0.02, deck + 0.2, 0.13), (deck - 0.1, deck + 0.14, 0.12), hide(kit))
    kit.add(BALL, (reach * 0.25, 0, deck + 0.1), (0.26, 0.16, 0.16), material=coat)
    section(kit, reach * 0.35, reach * 1.2, (deck - 0.2, deck + 0.22, 0.2), (deck - 0.2, deck + 0.02, 0.14), coat)
    grip = np.array([reach * 0.3, rng.uniform(0.32, 0.4), deck + rng.uniform(0.38, 0.5)])
    kit.between((reach * 0.5, 0, deck + 0.1), (reach * 0.4, 0, grip[2]), 0.04, material=dark)
    kit.between((reach * 0.4, 0, grip[2]), grip, 0.022, material=dark, mirror=True)
    kit.add(BOX, (reach * 0.48, 0, grip[2]), (0.06, 0.09, 0.06), material=coat)
    if kit.chance(0.6):
        for x in (reach * 1.0, -reach * 1.0):
            kit.add(BOX, (x, 0, deck + 0.22), (0.28, track * 0.85, 0.015), material=dark, cut=(BARS, 9, 0.3))
            kit.between((x, track * 0.5, deck - 0.05), (x, track * 0.6, deck + 0.22), 0.02, material=dark, mirror=True)
    kit.between((reach * 1.15, 0.1, radius), (reach * 1.35, 0.12, deck), 0.022, material=dark, mirror=True)
    kit.between((reach * 1.35, -0.22, deck), (reach * 1.35, 0.22, deck), 0.025, material=dark)
    kit.add(BOX, (reach * 1.34, 0, deck - 0.16), (0.015, 0.13, 0.13), material=dark, cut=(GRID, 14, 0.3))
    kit.add(BALL, (reach * 1.08, 0.14, deck + 0.0), (0.07, 0.06, 0.05), material=kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN, gloss=0.6), mirror=True)
    kit.add(BOX, (-reach * 1.17, 0, deck + 0.05), (0.03, 0.08, 0.03), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN))
    if kit.chance(0.3):
        driver(kit, -reach * 0.45, deck + 0.17, reach * 0.75)


def snowmobile(kit):
    rng = kit.rng
    coat, second, dark, tyre, metal = car_paint(kit), car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    long, wide = rng.uniform(0.7, 1.0), rng.uniform(0.19, 0.26)
    kit.add(BOX, (-long * 0.35, 0, 0.17), (long * 0.75, wide, 0.14), material=kit.material(base=tyre.first, pattern=RIBS, frequency=25, second=[0.08] * 3))
    for x, radius in ((-long * 1.1, 0.15), (long * 0.4, 0.16)):
        kit.add(CYL, (x, 0, radius + 0.01), (radius, radius, wide), rotation=ALONG_Y, material=tyre)
    kit.between((-long * 1.1, wide + 0.01, 0.16), (long * 0.4, wide + 0.01, 0.18), (0.03, 0.01), BOX, material=metal, mirror=True)
    section(kit, -long * 1.3, long * 0.5, (0.36, 0.44, wide * 1.05), (0.3, 0.42, wide * 1.15), dark)
    section(kit, -long * 1.25, -long * 0.1, (0.42, rng.uniform(0.62, 0.72), wide * 0.75), (0.42, 0.62, wide * 0.6), hide(kit))
    nose = long * rng.uniform(1.25, 1.5)
    section(kit, -long * 0.15, long * 0.6, (0.38, 0.72, wide * 0.9), (0.25, 0.82, wide * 1.5), coat)
    section(kit, long * 0.55, nose, (0.2, 0.82, wide * 1.5), (0.28, 0.42, wide * 0.8), coat)
    section(kit, long * 0.0, nose * 0.8, (0.2, 0.5, wide * 1.3), (0.2, 0.4, wide * 1.25), second)
    glass = kit.material(base=[0.06, 0.07, 0.08], pattern=PLAIN, gloss=0.6)
    slab(kit, 0.72, rng.uniform(1.0, 1.2), (long * 0.35, long * 0.85, wide * 1.2), (long * 0.3, long * 0.4, wide * 0.9), glass)
    kit.between((long * 0.2, 0, 0.7), (long * 0.12, 0, 1.0), 0.04, material=dark)
    kit.between((long * 0.12, 0, 0.98), (long * 0.02, 0.36, 1.02), 0.022, material=dark, mirror=True)
    ski = rng.uniform(0.4, 0.5)
    y = rng.uniform(0.42, 0.55)
    kit.add(BOX, (long * 0.95, y, 0.03), (ski, 0.07, 0.015), material=second, mirror=True)
    kit.between((long * 0.95 + ski * 0.97, y, 0.03), (long * 0.95 + ski * 1.4, y, 0.18), (0.015, 0.06), BOX, material=second, mirror=True)
    kit.between((long * 0.95 + ski * 1.38, y, 0.18), (long * 0.95 + ski * 0.5, y, 0.12), (0.012, 0.02), BOX, material=dark, mirror=True)
    kit.between((long * 0.95 + ski * 0.5, y, 0.12), (long * 0.95, y, 0.05), (0.012, 0.02), BOX, material=dark, mirror=True)
    kit.between((long * 0.95, y, 0.03), (long * 0.88, y * 0.95, 0.36), 0.035, material=metal, mirror=True)
    for dx in (-0.15, 0.12):
        kit.between((long * 0.85 + dx, wide * 0.9, 0.3), (long * 0.9, y, 0.22), 0.022, material=dark, mirror=True)
    kit.add(BOX, (nose - 0.1, wide * 0.45, 0.52), (0.09, 0.08, 0.035), material=kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN), mirror=True)
    kit.add(BOX, (-long * 1.28, 0, 0.58), (0.03, wide * 0.5, 0.04), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN))
    kit.between((-long * 1.25, wide * 0.8, 0.42), (-long * 1.45, wide * 0.8, 0.5), 0.015, material=metal, mirror=True)
    kit.between((-long * 1.45, -wide * 0.8, 0.5), (-long * 1.45, wide * 0.8, 0.5), 0.015, material=metal)
    if kit.chance(0.35):
        driver(kit, -long * 0.45, 0.62, long * 0.5)


def golf_cart(kit):
    rng = kit.rng
    coat, dark, cloth, metal = car_paint(kit), kit.material(dark=True), hide(kit), chrome(kit)
    radius, wide, long = rng.uniform(0.21, 0.27), rng.uniform(0.55, 0.65), rng.uniform(1.1, 1.3)
    rows = int(kit.chance(0.35)) + 1
    if rows == 2:
        long += 0.35
    axles = (long * 0.68, -long * 0.6)
    for x in axles:
        rims(kit, x, wide * 0.88, radius, 0.1, rubber(kit), metal)
        kit.between((x, -wide * 0.8, radius), (x, wide * 0.8, radius), 0.04, material=dark)
    floor = radius + 0.08
    kit.add(BOX, (long * 0.15, 0, floor), (long * 0.75, wide * 0.95, 0.06), material=dark)
    section(kit, long * 0.5, long, (floor + 0.02, floor + 0.62, wide * 0.9), (floor - 0.02, floor + 0.24, wide * 0.75), coat)
    kit.add(BOX, (long * 0.68, wide * 0.88, radius * 2 + 0.07), (radius * 1.3, 0.12, 0.05), (0.8, 1), material=coat, mirror=True)
    section(kit, -long, -long * 0.1 if rows == 1 else -long * 0.25, (floor, floor + 0.35, wide * 0.8), (floor, floor + 0.42, wide * 0.92), coat)
    kit.add(CYL, (axles[1], wide * 0.9, radius + 0.03), (radius * 1.15, radius * 1.15, 0.04), rotation=ALONG_Y, material=dark, mirror=True)
    seats = [-long * 0.3] if rows == 1 else [long * 0.02, -long * 0.5]
    for x in seats:
        kit.add(BOX, (x, 0, floor + 0.2), (0.2, wide * 0.8, 0.18), material=coat)
        seat(kit, x, 0, floor + 0.42, wide * 0.85, 0.45, cloth)
    steering(kit, long * 0.42, wide * 0.4, floor + 0.75, dark, 0.17)
    roof = floor + rng.uniform(1.35, 1.5)
    back = min(seats) - 0.45
    for x, foot in ((long * 0.5, long * 0.75), (back + 0.08, back + 0.0)):
        kit.between((foot, wide * 0.82, floor + 0.3), (x, wide * 0.8, roof), 0.024, material=dark, mirror=True)
    kit.add(BOX, ((long * 0.55 + back) / 2, 0, roof + 0.03), ((long * 0.62 - back) / 2, wide * 0.95, 0.04), (0.95, 0.92), material=coat if kit.chance(0.4) else kit.material(base=[0.8, 0.79, 0.72], pattern=PLAIN))
    if kit.chance(0.7):
        slab(kit, floor + 0.6, roof, (long * 0.64, long * 0.66, wide * 0.8), (long * 0.49, long * 0.51, wide * 0.78), glazing(kit))
    lights(kit, long * 0.9, -long, wide * 0.58, floor + 0.3, 0.07, kit.chance(0.5))
    kit.add(BOX, (long, 0, floor), (0.05, wide * 0.7, 0.07), material=dark)
    if rows == 1:
        kit.add(BOX, (-long * 0.88, 0, floor + 0.38), (0.2, wide * 0.7, 0.03), material=dark)
        for y in (-0.25, 0.25)[: int(rng.integers(1, 3))]:
            kit.add(CYL, (-long * 0.9, y, floor + 0.78), (0.13, 0.13, 0.42), rotation=turn("y", -8), material=kit.material())
            kit.add(CYL, (-long * 0.92, y, floor + 1.22), (0.03, 0.03, 0.16), material=metal)
            kit.add(BALL, (-long * 0.92, y + 0.04, floor + 1.38), (0.05, 0.07, 0.05), material=dark)


def tuk_tuk(kit):
    rng = kit.rng
    coat, second, dark, cloth = car_paint(kit), car_paint(kit), kit.material(dark=True), hide(kit)
    radius, wide, long = rng.uniform(0.2, 0.25), rng.uniform(0.55, 0.65), rng.uniform(1.15, 1.35)
    tyre, hub = rubber(kit), chrome(kit)
    goods = kit.chance(0.3)
    rims(kit, long * 0.82, 0, radius, 0.06, tyre, hub)
    rims(kit, -long * 0.6, wide * 0.88, radius, 0.07, tyre, hub)
    kit.add(CYL, (-long * 0.6, wide * 0.84, radius + 0.05), (radius * 1.25, radius * 1.25, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
    floor, belt, roof = radius + 0.08, radius + 0.62, rng.uniform(1.6, 1.75)
    kit.add(BOX, (0, 0, floor), (long * 0.85, wide * 0.85, 0.06), material=dark)
    section(kit, long * 0.42, long * 0.98, (floor, belt + 0.05, wide * 0.85), (floor + 0.1, belt - 0.1, wide * 0.4), coat)
    kit.add(BALL, (long * 0.92, 0, radius * 1.75), (radius * 1.3, 0.12, radius * 0.7), material=second)
    kit.between((long * 0.85, 0.08, belt - 0.2), (long * 0.82, 0.08, radius), 0.03, material=dark, mirror=True)
    screen = (long * 0.5, long * 0.32)
    slab(kit, belt, roof, (screen[0] - 0.02, screen[0] + 0.1, wide * 0.8), (screen[1] - 0.02, screen[1] + 0.04, wide * 0.75), glazing(kit))
    kit.between((screen[0] + 0.06, wide * 0.84, belt - 0.1), (screen[1], wide * 0.8, roof), 0.03, BOX, material=coat, mirror=True)
    kit.add(BOX, (long * 0.25, 0, floor + 0.22), (0.16, wide * 0.4, 0.18), material=dark)
    kit.between((long * 0.42, 0, belt - 0.1), (long * 0.36, 0, belt + 0.15), 0.03, material=dark)
    kit.between((long * 0.36, -0.3, belt + 0.16), (long * 0.36, 0.3, belt + 0.16), 0.02, material=dark)
    canopy = kit.material(pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.1)
    if goods:
        section(kit, -long, 0.15, (floor, floor + 0.1, wide), (floor, floor + 0.1, wide), second)
        kit.add(BOX, (0.12, 0, (floor + roof) / 2), (0.03, wide * 0.82, (roof - floor) / 2), material=coat)
        slab(kit, roof - 0.05, roof + 0.05, (0.05, screen[1] + 0.1, wide * 0.82), (0.1, screen[1] + 0.05, wide * 0.75), coat)
        kit.add(BOX, (-long * 0.45, wide * 0.98, floor + 0.25), (long * 0.55, 0.03, 0.2), material=second, mirror=True)
        kit.add(BOX, (-long, 0, floor + 0.25), (0.03, wide, 0.2), material=second)
        for _ in range(int(rng.integers(0, 5))):
            half = rng.uniform(0.12, 0.28, 3)
            kit.add(rng.choice([BOX, BALL]), (-long * rng.uniform(0.2, 0.7), rng.uniform(-0.5, 0.5) * wide, floor + 0.08 + half[2]), half)
    else:
        section(kit, -long, -long * 0.25, (floor, belt, wide * 0.9), (floor, belt - 0.05, wide), coat)
        seat(kit, -long * 0.45, 0, belt - 0.15, wide * 0.8, 0.5, cloth)
        for x in (-long * 0.2, -long * 0.9):
            kit.between((x, wide * 0.92, belt - 0.1), (x, wide * 0.8, roof), 0.025, material=dark, mirror=True)
        kit.add(CYL, (-long * 0.22, 0, roof - 0.02), (0.16, wide * 0.95, long * 0.72), rotation=ALONG_X, material=canopy)
        kit.add(BOX, (-long * 0.93, 0, (belt + roof) / 2), (0.03, wide * 0.85, (roof - belt) / 2), material=canopy)
        kit.add(BOX, (-long * 0.965, 0, roof - 0.25), (0.01, wide * 0.4, 0.12), material=glazing(kit))
    kit.add(CYL, (long * 0.98, 0, belt - 0.2), (0.09, 0.09, 0.04), rotation=ALONG_X, material=kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN))
    kit.add(BOX, (-long - 0.02, wide * 0.75, belt - 0.25), (0.03, 0.05, 0.08), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN), mirror=True)
    kit.add(BOX, (0, wide * 0.86, floor + 0.02), (long * 0.5, 0.03, 0.04), material=second, mirror=True)
    kit.between((screen[0], wide * 0.8, belt + 0.2), (screen[0] + 0.1, wide * 1.05, belt + 0.25), 0.012, material=dark, mirror=True)
    kit.add(BALL, (screen[0] + 0.1, wide * 1.08, belt + 0.27), (0.03, 0.07, 0.06), material=dark, mirror=True)


def rickshaw(kit):
    rng = kit.rng
    coat, wood, metal, tyre, cloth = car_paint(kit), timber(kit), chrome(kit), rubber(kit), hide(kit)
    radius, wide = rng.uniform(0.4, 0.55), rng.uniform(0.4, 0.52)
    cycle = kit.chance(0.5)
    wired(kit, 0, wide + 0.1, radius, 0.035, tyre, metal, int(rng.integers(10, 20)), 0.18)
    kit.between((0, -wide - 0.12, radius), (0, wide + 0.12, radius), 0.03, material=metal)
    bed = radius + 0.1
    kit.add(BOX, (0.1, 0, bed), (0.5, wide * 0.95, 0.05), material=wood)
    section(kit, -0.4, 0.15, (bed, bed + 0.35, wide * 0.95), (bed, bed + 0.28, wide), coat)
    seat(kit, -0.1, 0, bed + 0.3, wide * 0.85, 0.5, cloth)
    kit.add(BOX, (-0.12, wide * 0.97, bed + 0.42), (0.3, 0.03, 0.12), material=coat, mirror=True)
    kit.add(BOX, (0.55, 0, bed - 0.1), (0.14, wide * 0.7, 0.02), material=wood)
    kit.between((0.45, wide * 0.6, bed), (0.55, wide * 0.6, bed - 0.1), 0.03, BOX, material=wood, mirror=True)
    arch(kit, 0, wide + 0.1, radius, radius + 0.06, 0.07, 20, 160, 4, coat)
    kit.between((0, wide * 0.9, bed), (0, wide + 0.1, 2 * radius + 0.05), 0.02, material=metal, mirror=True)
    if kit.chance(0.75):  # a folding hood
        canvas = kit.material(pattern=rng.choice([PLAIN, STRIPES, CLOUDY]))
        hinge = np.array([-0.3, 0, bed + 0.55])
        for degrees in (170, 135, 100, 65):
            a, b = np.radians(degrees), np.radians(degrees - 35)
            start, end = hinge + 0.62 * np.array([np.cos(a), 0, np.sin(a) * 1.1]), hinge + 0.62 * np.array([np.cos(b), 0, np.sin(b) * 1.1])
            kit.between(start, end, (0.02, wide * 1.0), BOX, material=canvas)
            kit.between(hinge + [0, wide, 0], end + [0, wide, 0], 0.014, material=metal, mirror=True)
    reach = rng.uniform(1.5, 1.9)
    if cycle:
        small = radius * 0.9
        wired(kit, reach, 0, small, 0.03, tyre, metal, 16, 0.15)
        crank, saddle, head = np.array([reach - 0.62, 0, small * 0.9]), np.array([reach - 0.72, 0, 0.9]), np.array([reach - 0.2, 0, 0.92])
        for start, end in ((crank, saddle), (crank, head), (saddle, head), (crank, [0.3, 0, bed]), (saddle, [0.4, 0, bed + 0.03])):
            kit.between(start, end, 0.025, material=coat)
        kit.between(head + [0, 0.05, 0], (reach, 0.05, small), 0.02, material=metal, mirror=True)
        kit.between(head, head + [-0.03, 0, 0.15], 0.02, material=metal)
        kit.between(head + [-0.03, 0, 0.15], head + [-0.18, 0.26, 0.17], 0.018, material=metal, mirror=True)
        kit.add(BALL, saddle + [0, 0, 0.08], (0.15, 0.09, 0.05), material=cloth)
        kit.add(CYL, crank, (0.1, 0.1, 0.015), rotation=ALONG_Y, material=metal)
        arch(kit, reach, 0, small, small + 0.05, 0.04, 40, 160, 3, coat)
    else:
        kit.between((-0.5, wide * 0.85, bed), (0.5, wide * 0.85, bed - 0.02), 0.035, BOX, material=wood, mirror=True)
        low = rng.uniform(0.05, bed + 0.2)
        kit.between((0.4, wide * 0.85, bed - 0.02), (reach, wide * 0.75, low), 0.03, material=wood, mirror=True)
        kit.between((reach - 0.1, -wide * 0.76, low), (reach - 0.1, wide * 0.76, low), 0.025, material=wood)
        if low > 0.3:
            kit.between((reach - 0.12, 0, low), (reach - 0.12, 0, 0), 0.025, material=wood)


def dune_buggy(kit):
    rng = kit.rng
    bar, coat, dark, cloth, metal = car_paint(kit), car_paint(kit), kit.material(dark=True), hide(kit), chrome(kit)
    front, rear, track = rng.uniform(1.1, 1.3), -rng.uniform(1.0, 1.2), rng.uniform(0.72, 0.85)
    radius, big = rng.uniform(0.3, 0.36), rng.uniform(0.36, 0.44)
    for x, r, half in ((front, radius, 0.11), (rear, big, 0.18)):
        rims(kit, x, track, r, half, rubber(kit), metal, int(rng.integers(5, 9)))
        kit.between((x * 0.85, 0.2, 0.42), (x, track, r), 0.035, material=metal, mirror=True)
        kit.between((x * 0.85, 0.25, 0.8), (x, track * 0.8, r), 0.04, material=coat, mirror=True)
    floor, roof, wide = 0.34, rng.uniform(1.4, 1.6), rng.uniform(0.45, 0.55)
    kit.add(BOX, (0, 0, floor), (front * 0.75, wide, 0.03), material=dark)
    tube = 0.03
    low, belt = np.array([0, wide, floor]), np.array([0, wide * 1.05, 0.8])
    top = np.array([0, wide * 0.75, roof])
    nose = np.array([front + 0.25, 0.18, 0.5])
    bars = [([front * 0.6, 0, 0] * np.ones(3) + low, nose), (belt + [front * 0.5, 0, 0], nose + [-0.1, 0, 0.12]), (belt + [front * 0.5, 0, 0], top + [0.25, 0, 0])]
    bars += [(top + [0.25, 0, 0], top + [-0.5, 0, 0]), (top + [-0.5, 0, 0], low + [-0.6, 0, 0]), (belt + [front * 0.5, 0, 0], belt + [-0.6, 0, 0])]
    bars += [(top + [-0.5, 0, 0], [rear - 0.25, wide * 0.7, 0.7]), (low + [-0.6, 0, 0], [rear - 0.25, wide * 0.6, 0.45]), (belt + [front * 0.5, 0, 0], low + [front * 0.55, 0, 0])]
    for start, end in bars:
        kit.between(start, end, tube, material=bar, mirror=True)
    for point in (top + [0.25, 0, 0], top + [-0.5, 0, 0], nose):
        kit.between(point, point * FLIP, tube, material=bar)
    kit.between((rear - 0.25, -wide * 0.7, 0.7), (rear - 0.25, wide * 0.7, 0.7), tube, material=bar)
    section(kit, front * 0.4, front + 0.2, (0.4, 0.76, wide * 0.9), (0.42, 0.55, 0.16), coat)
    seat(kit, -0.15, wide * 0.48, floor + 0.08, wide * 0.38, 0.7, cloth, True)
    steering(kit, 0.25, wide * 0.48, 0.78, dark)
    kit.add(BOX, (rear * 0.95, 0, 0.5), (0.3, 0.22, 0.2), material=metal)
    kit.add(CYL, (rear * 0.95, 0, 0.78), (0.12, 0.12, 0.1), material=dark)
    kit.between((rear - 0.1, 0.2, 0.55), (rear - 0.5, 0.1, 0.85), 0.05, material=metal)
    if kit.chance(0.6):
        for y in (0.12, 0.3):
            kit.add(CYL, (0.28, y, roof + 0.09), (0.08, 0.08, 0.04), rotation=ALONG_X, material=kit.material(base=[0.85, 0.85, 0.7], pattern=PLAIN), mirror=True)
    if kit.chance(0.4):
        kit.add(BOX, (-0.12, 0, roof + 0.03), (0.38, wide * 0.74, 0.015), material=coat)


def beach_buggy(kit):
    rng = kit.rng
    coat = kit.material(base=paint(rng.random(), rng.uniform(0.6, 1), rng.uniform(0.3, 0.9)), pattern=rng.choice([PLAIN, 17]), gloss=0.5)
    dark, cloth, metal, tyre = kit.material(dark=True), hide(kit), chrome(kit), rubber(kit)
    front, rear, wide = rng.uniform(0.95, 1.1), -rng.uniform(0.95, 1.1), rng.uniform(0.5, 0.58)
    radius, big = rng.uniform(0.29, 0.33), rng.uniform(0.34, 0.4)
    for x, r, half in ((front, radius, 0.12), (rear, big, 0.19)):
        rims(kit, x, wide + 0.18, r, half, tyre, metal, int(rng.integers(5, 9)))
        kit.between((x, -wide, r), (x, wide, r), 0.05, material=dark)
        arch(kit, x, wide + 0.14, r, r + 0.08, 0.2, 10, 170, 4, coat)
    floor, belt = 0.28, rng.uniform(0.72, 0.8)
    kit.add(BOX, (-0.05, 0, floor + 0.02), (0.9, wide * 0.95, 0.07), material=coat)
    section(kit, front * 0.35, front + 0.45, (floor, belt + 0.12, wide), (0.42, 0.52, wide * 0.7), coat)
    kit.add(BALL, (front * 0.5, 0, belt - 0.04), (0.55, wide * 0.7, 0.17), material=coat)
    section(kit, rear * 0.75, front * 0.4, (floor, belt, 0.06), (floor, belt - 0.12, 0.06), coat, wide * 0.95, True)
    section(kit, rear - 0.35, rear * 0.55, (0.55, 0.68, wide * 0.75), (floor, belt + 0.05, wide), coat)
    seat(kit, -0.2, wide * 0.5, floor + 0.12, wide * 0.38, 0.62, cloth, True)
    steering(kit, 0.2, wide * 0.5, belt + 0.05, dark)
    tall, lean = rng.uniform(0.38, 0.48), 0.16
    foot, top = np.array([front * 0.42, wide * 0.85, belt]), np.array([front * 0.42 - lean, wide * 0.8, belt + tall])
    kit.between(foot, top, 0.022, material=metal, mirror=True)
    kit.between(top, top * FLIP, 0.022, material=metal)
    slab(kit, belt, belt + tall, (foot[0] - 0.01, foot[0] + 0.01, wide * 0.84), (top[0] - 0.01, top[0] + 0.01, wide * 0.8), glazing(kit))
    if kit.chance(0.8):
        hoop = np.array([-0.55, wide * 0.75, belt + 0.6])
        kit.between((-0.55, wide * 0.85, belt - 0.1), hoop, 0.03, material=metal, mirror=True)
        kit.between(hoop, hoop * FLIP, 0.03, material=metal)
    kit.add(BALL, (front * 1.0, wide * 0.55, belt + 0.05), (0.12, 0.11, 0.11), material=metal, mirror=True)
    kit.add(BALL, (front * 1.0 + 0.05, wide * 0.55, belt + 0.05), (0.09, 0.1, 0.1), material=kit.material(base=[0.85, 0.85, 0.75], pattern=PLAIN), mirror=True)
    kit.add(BOX, (rear - 0.25, 0, 0.48), (0.22, 0.3, 0.15), material=metal)
    kit.between((rear - 0.3, 0.2, 0.42), (rear - 0.6, 0.25, 0.55), 0.045, material=metal, mirror=True)
    kit.between((front + 0.5, -wide * 0.7, 0.45), (front + 0.5, wide * 0.7, 0.45), 0.03, material=metal)
    kit.between((front + 0.3, 0.25, 0.48), (front + 0.5, 0.25, 0.45), 0.025, material=metal, mirror=True)


def three_wheeler(kit):
    rng = kit.rng
    coat, dark, tyre, metal, cloth = car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit), hide(kit)
    if kit.chance(0.5):  # two wheels before, a barrel that tapers behind
        front, rear, radius = rng.uniform(0.95, 1.1), -rng.uniform(0.95, 1.15), rng.uniform(0.3, 0.34)
        wide = rng.uniform(0.4, 0.48)
        wired(kit, front, wide + 0.28, radius, 0.05, tyre, metal, 18, 0.2)
        wired(kit, rear, 0, radius, 0.06, tyre, metal, 18, 0.2)
        kit.loft((rear - 0.4, 0, 0.52), [(0, 0.05), (0.4, 0.2), (1.1, wide * 0.9), (1.6, wide), (front - rear + 0.35, wide * 0.7)], coat, axis=ALONG_X)
        kit.add(CYL, (front + 0.05, 0, 0.52), (wide * 0.68, wide * 0.68, 0.12), rotation=ALONG_X, material=metal)
        kit.add(CYL, (front, 0, 0.52), (wide * 0.6, wide * 0.6, 0.19), rotation=ALONG_X, material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=40, second=[0.3] * 3))
        for y in (-1, 1):
            kit.between((front + 0.22, 0, 0.36), (front + 0.25, y * 0.22, 0.66), 0.1, material=metal)
        kit.add(BALL, (-0.1, 0, 0.93), (0.5, wide * 0.75, 0.1), material=cloth)
        kit.add(BOX, (-0.45, 0, 1.0), (0.05, wide * 0.7, 0.12), rotation=turn("y", -15), material=cloth)
        kit.add(BALL, (0.35, 0, 1.0), (0.04, wide * 0.7, 0.17), rotation=turn("y", -20), material=glazing(kit))
        steering(kit, 0.1, 0.15, 1.02, dark, 0.15)
        for z in (0.4, 0.58):
            kit.between((front, -wide - 0.25, radius), (front, wide + 0.25, z * 0.2 + radius * 0.8), 0.022, material=metal)
        arch(kit, front, wide + 0.28, radius, radius + 0.05, 0.07, 30, 170, 3, coat)
        kit.add(BALL, (front - 0.05, wide * 0.75, 0.9), (0.14, 0.11, 0.11), material=metal, mirror=True)
        kit.between((front - 0.05, wide * 0.6, 0.7), (front - 0.05, wide * 0.75, 0.9), 0.02, material=metal, mirror=True)
        kit.between((front - 0.1, wide * 0.9, 0.4), (rear * 0.9, wide * 0.85, 0.38), 0.04, material=metal, mirror=True)
    else:  # one wheel before, a small cabin
        long, wide, radius = rng.uniform(1.3, 1.7), rng.uniform(0.55, 0.68), rng.uniform(0.22, 0.27)
        belt, roof, floor = rng.uniform(0.75, 0.85), rng.uniform(1.25, 1.45), 0.2
        nose, screen = long, long * rng.uniform(0.3, 0.45)
        rims(kit, long * 0.68, 0, radius, 0.07, tyre, metal)
        rims(kit, -long * 0.62, wide * 0.92, radius, 0.08, tyre, metal)
        kit.add(CYL, (-long * 0.62, wide * 0.92, radius + 0.03), (radius * 1.12, radius * 1.12, 0.075), rotation=ALONG_Y, material=dark, mirror=True)
        slab(kit, floor, belt, (-long, screen + 0.15, wide), (-long * 0.97, screen + 0.1, wide * 0.95), coat)
        section(kit, screen, nose, (floor, belt, wide * 0.95), (floor + 0.08, belt - 0.25, wide * 0.45), coat)
        kit.add(BALL, (nose * 0.9, 0, 0.43), (0.25, wide * 0.5, 0.18), material=coat)
        greenhouse(kit, -long * rng.uniform(0.75, 0.95), screen + 0.05, belt, roof, wide, 0.3, rng.uniform(0.1, 0.5), coat, 1)
        lights(kit, nose * 0.93, -long, wide * 0.45, belt - 0.3, 0.08)
        kit.add(BOX, (-long, 0, floor + 0.08), (0.04, wide * 0.95, 0.06), material=metal)
        kit.add(BOX, (screen * 0.1, wide * 0.985, belt - 0.25), (0.01, 0.012, 0.22), material=dark, mirror=True)


def hot_rod(kit):
    rng = kit.rng
    coat, second, dark, metal, tyre = car_paint(kit), car_paint(kit), kit.material(dark=True), chrome(kit), rubber(kit)
    front, rear, radius, big = rng.uniform(1.25, 1.5), -rng.uniform(1.05, 1.25), rng.uniform(0.28, 0.32), rng.uniform(0.38, 0.46)
    wide, floor, belt = rng.uniform(0.52, 0.6), 0.38, rng.uniform(0.98, 1.08)
    for x, r, half, y in ((front, radius, 0.08, wide + 0.2), (rear, big, 0.18, wide + 0.12)):
        rims(kit, x, y, r, half, tyre, metal, int(rng.integers(5, 9)) if kit.chance(0.6) else 0)
        kit.between((x, -y, r), (x, y, r), 0.045, material=metal)
    kit.between((rear - 0.3, 0.32, 0.42), (front + 0.1, 0.26, 0.38), (0.06, 0.04), BOX, material=dark, mirror=True)
    section(kit, rear - 0.4, 0.4, (floor + 0.15, belt - 0.15, wide * 0.75), (floor, belt, wide), coat)
    section(kit, front - 0.12, front + 0.0, (floor + 0.02, 0.98, 0.24), (floor + 0.02, 0.95, 0.22), metal)
    kit.add(BOX, (front + 0.01, 0, 0.68), (0.01, 0.18, 0.26), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=45, second=[0.5] * 3))
    kit.add(BOX, (0.75, 0, 0.62), (0.4, 0.17, 0.2), material=metal)
    kit.add(BOX, (0.75, 0.2, 0.78), (0.32, 0.08, 0.06), rotation=turn("x", -35), material=second, mirror=True)
    if kit.chance(0.5):
        section(kit, 0.35, front - 0.1, (0.8, belt + 0.01, wide * 0.9), (0.78, 0.98, 0.25), second if kit.chance(0.4) else coat)
    else:
        kit.add(CYL, (0.75, 0, 1.02), (0.18, 0.18, 0.07), material=metal)
        kit.add(BOX, (0.75, 0, 0.9), (0.25, 0.12, 0.1), material=dark)
    for k in range(4):
        kit.between((0.48 + 0.17 * k, 0.2, 0.68), (0.38 + 0.17 * k, 0.36, 0.52), 0.025, material=metal, mirror=True)
    kit.between((1.0, 0.36, 0.5), (rear + 0.5, 0.48, 0.34), 0.04, material=metal, mirror=True)
    if kit.chance(0.6):
        roof = belt + rng.uniform(0.28, 0.42)
        greenhouse(kit, rear * 0.6, 0.3, belt, roof, wide, 0.12, 0.16, coat, 1, share=0.84)
    else:
        slab(kit, belt, belt + 0.26, (0.3, 0.33, wide * 0.85), (0.18, 0.2, wide * 0.8), glazing(kit))
        seat(kit, -0.25, 0, belt - 0.2, wide * 0.8, 0.35, hide(kit))
        steering(kit, 0.1, 0.25, belt + 0.08, dark, 0.16)
    kit.add(BALL, (front - 0.05, 0.4, 0.78), (0.11, 0.11, 0.11), material=metal, mirror=True)
    kit.add(BALL, (front + 0.02, 0.4, 0.78), (0.06, 0.1, 0.1), material=kit.material(base=[0.85, 0.85, 0.75], pattern=PLAIN), mirror=True)
    kit.between((front - 0.05, 0.24, 0.6), (front - 0.05, 0.4, 0.72), 0.02, material=metal, mirror=True)
    kit.add(CYL, (rear - 0.4, 0.36, 0.68), (0.05, 0.05, 0.03), rotation=ALONG_X, material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN), mirror=True)


def twin(kit, x, z, size, metal, dark):
    """A V-shaped engine with its crankcase."""
    kit.add(CYL, (x, 0, z), (0.15 * size, 0.15 * size, 0.1), rotation=ALONG_Y, material=metal)
    fins = kit.material(base=metal.first * 0.6, pattern=BANDS, frequency=60, second=metal.first)
    for way in (-1, 1):
        kit.between((x, 0, z), (x + way * 0.16 * size, 0, z + 0.3 * size), 0.085 * size, material=fins)
    kit.add(CYL, (x, 0.1, z + 0.2 * size), (0.07 * size, 0.07 * size, 0.05), rotation=ALONG_Y, material=dark)


def chopper(kit):
    rng = kit.rng
    coat, dark, metal, tyre, cloth = car_paint(kit), kit.material(dark=True), chrome(kit), rubber(kit), hide(kit)
    radius, back = rng.uniform(0.31, 0.36), rng.uniform(0.3, 0.34)
    front, rear = rng.uniform(1.15, 1.5), -0.65
    wired(kit, front, 0, radius, 0.04, tyre, metal, int(rng.integers(8, 24)), 0.2)
    rims(kit, rear, 0, back, rng.uniform(0.08, 0.12), tyre, metal, int(rng.integers(4, 9)))
    head = np.array([rng.uniform(0.5, 0.6), 0, rng.uniform(0.92, 1.05)])
    kit.between(head + [-0.04, 0.08, 0.08], (front, 0.08, radius), 0.024, material=metal, mirror=True)
    for z in (0.0, -0.12):
        kit.between(head + [0, -0.1, z], head + [0, 0.1, z], 0.035, material=metal)
    kit.between(head, (-0.3, 0, 0.62), 0.03, material=coat)
    kit.between(head - [0, 0, 0.1], (0.35, 0, 0.25), 0.028, material=coat)
    kit.between((0.35, 0.0, 0.25), (-0.25, 0.0, 0.25), 0.03, material=coat)
    kit.between((-0.25, 0.1, 0.27), (rear, 0.13, back), 0.03, material=coat, mirror=True)
    kit.between((-0.3, 0.1, 0.62), (rear, 0.13, back), 0.026, material=metal, mirror=True)
    kit.between((-0.3, 0, 0.62), (-0.25, 0, 0.27), 0.03, material=coat)
    twin(kit, 0.06, 0.4, 1.0, metal, dark)
    kit.add(BALL, (0.24, 0, head[2] - 0.07), (0.27, 0.14, 0.11), rotation=turn("y", -15), material=coat)
    section(kit, -0.5, 0.0, (0.64, 0.76, 0.14), (0.62, 0.7, 0.09), cloth)
    arch(kit, rear, 0, back, back + 0.06, 0.12, 60, 200, 4, coat)
    kit.between((-0.3, 0, 0.62), (-0.45, 0, 0.68), (0.04, 0.08), BOX, material=dark)
    if kit.chance(0.5):
        top = rng.uniform(1.0, 1.35)
        kit.between((rear - 0.02, 0.12, back), (rear - 0.2, 0.1, top), 0.015, material=metal, mirror=True)
        kit.between((rear - 0.2, -0.1, top), (rear - 0.2, 0.1, top), 0.015, material=metal)
        section(kit, rear - 0.2, rear - 0.1, (0.8, top - 0.04, 0.1), (0.78, top - 0.1, 0.1), cloth)
    rise = rng.uniform(0.15, 0.5)
    grip = head + [-0.2, rng.uniform(0.3, 0.38), rise]
    kit.between(head + [0, 0.05, 0.06], grip + [0.12, -0.06, 0], 0.016, material=metal, mirror=True)
    kit.between(grip + [0.12, -0.06, 0], grip + [-0.06, 0.02, -0.04], 0.022, material=dark, mirror=True)
    kit.add(BALL, head + [0.18, 0, -0.04], (0.1, 0.09, 0.09), material=metal)
    kit.add(CYL, head + [0.27, 0, -0.04], (0.08, 0.08, 0.015), rotation=ALONG_X, material=kit.material(base=[0.85, 0.85, 0.75], pattern=PLAIN))
    kit.between(head, head + [0.18, 0, -0.04], 0.03, material=metal)
    for z in (0.22, 0.3)[: int(rng.integers(1, 3))]:
        kit.between((0.15, -0.14, z + 0.05), (rear - 0.3, -0.17, z), 0.04, material=metal)
    kit.between((0.42, -0.22, 0.28), (0.42, 0.22, 0.28), 0.02, material=metal)
    kit.between((0.1, 0.1, 0.25), (0.0, 0.25, 0.0), 0.015, material=metal)
    kit.add(BALL, (rear - back * 0.75 - 0.04, 0, back * 1.65), (0.05, 0.05, 0.04), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN))


def cruiser(kit, coat, dark, metal, tyre, cloth):
    """A plain motorcycle of the old kind."""
    rng = kit.rng
    radius, reach = rng.uniform(0.3, 0.34), rng.uniform(0.66, 0.75)
    for x in (reach, -reach):
        wired(kit, x, 0, radius, 0.055, tyre, metal, 16, 0.2)
        arch(kit, x, 0, radius, radius + 0.05, 0.07, 30 if x > 0 else 40, 150 if x > 0 else 190, 3, coat)
    kit.between((reach - 0.28, 0.09, 0.95), (reach, 0.09, radius), 0.028, material=metal, mirror=True)
    kit.between((-0.2, 0.1, 0.35), (-reach, 0.1, radius), 0.028, material=coat, mirror=True)
    kit.between((-reach * 0.75, 0.1, 0.72), (-reach, 0.1, radius), 0.03, material=metal, mirror=True)
    kit.between((reach - 0.28, 0, 0.9), (0.3, 0, 0.28), 0.03, material=coat)
    kit.between((0.3, 0, 0.28), (-0.25, 0, 0.3), 0.05, material=coat)
    kit.between((reach - 0.28, 0, 0.86), (-reach * 0.75, 0, 0.7), 0.035, material=coat)
    twin(kit, 0.04, 0.4, 0.9, metal, dark)
    kit.add(BALL, (0.15, 0, 0.82), (0.26, 0.14, 0.12), material=coat)
    section(kit, -0.62, -0.08, (0.74, 0.82, 0.13), (0.72, 0.8, 0.1), cloth)
    kit.add(BALL, (reach - 0.12, 0, 0.88), (0.11, 0.1, 0.1), material=metal)
    kit.between((reach - 0.3, 0, 0.95), (reach - 0.42, 0.34, 1.02), 0.018, material=metal, mirror=True)
    kit.between((0.1, -0.14, 0.3), (-reach - 0.25, -0.17, 0.3), 0.04, material=metal)


def sidecar(kit):
    rng = kit.rng
    coat, dark, metal, tyre, cloth = car_paint(kit), kit.material(dark=True), chrome(kit), rubber(kit), hide(kit)
    cruiser(kit, coat, dark, metal, tyre, cloth)
    side = rng.choice([-1, 1])
    y, radius = side * rng.uniform(0.62, 0.75), 0.3
    nose = rng.uniform(0.75, 0.95)
    kit.loft((-0.75, y, 0.5), [(0, 0.16), (0.3, 0.26), (0.95, 0.28), (nose + 0.5, 0.16), (nose + 0.75, 0.05)], coat, axis=ALONG_X, flat=0.95)
    kit.add(BALL, (-0.12, y, 0.74), (0.36, 0.21, 0.08), material=cloth)
    kit.add(BOX, (-0.4, y, 0.82), (0.05, 0.19, 0.14), (0.9, 0.8), material=cloth)
    if kit.chance(0.6):
        kit.add(BOX, (0.25, y, 0.86), (0.01, 0.2, 0.13), (1, 0.8), (-0.06, 0), material=glazing(kit))
    at = y + side * 0.36
    kit.add(CYL, (-0.15, at, radius), (radius, radius, 0.05), rotation=ALONG_Y, material=tyre, cut=RING)
    kit.add(CYL, (-0.15, at, radius), (radius * 0.93, radius * 0.93, 0.03), rotation=ALONG_Y, material=metal, cut=(SPOKES, 16, 0.2))
    kit.add(BALL, (-0.15, at, 0.56), (0.36, 0.09, 0.1), material=coat)
    for x in (0.3, -0.3):
        kit.between((x, 0, 0.3), (x, at, 0.28), 0.025, material=dark)
    kit.between((-0.15, at, radius), (-0.15, y, radius), 0.03, material=dark)
    kit.add(BALL, (nose * 0.6, y + side * 0.2, 0.62), (0.06, 0.06, 0.06), material=metal)


def moped(kit):
    rng = kit.rng
    coat, dark, metal, tyre, cloth = car_paint(kit), kit.material(dark=True), chrome(kit), rubber(kit), hide(kit)
    radius, reach = rng.uniform(0.27, 0.32), rng.uniform(0.56, 0.64)
    for x in (reach, -reach):
        wired(kit, x, 0, radius, 0.03, tyre, metal, int(rng.integers(10, 24)), 0.15)
        arch(kit, x, 0, radius, radius + 0.04, 0.05, 25 if x > 0 else 50, 150 if x > 0 else 190, 3, coat)
    head = np.array([reach - 0.2, 0, 0.82])
    kit.between(head + [0, 0.06, 0], (reach, 0.06, radius), 0.022, material=metal, mirror=True)
    step = np.array([0.08, 0, rng.uniform(0.36, 0.48)])
    kit.between(head, step, (0.06, 0.04), BOX, material=coat)
    kit.between(step, (-0.32, 0, 0.5), (0.06, 0.045), BOX, material=coat)
    if kit.chance(0.4):
        kit.add(BALL, (0.12, 0, 0.68), (0.24, 0.1, 0.1), rotation=turn("y", -18), material=coat)
        kit.between(head, (-0.25, 0, 0.62), 0.035, material=coat)
    kit.between((-0.2, 0, 0.48), (-0.28, 0, 0.82), 0.02, material=metal)
    kit.add(BALL, (-0.3, 0, 0.84), (0.17, 0.1, 0.06), material=cloth)
    kit.between((-0.1, 0.07, 0.34), (-reach, 0.07, radius), 0.022, material=coat, mirror=True)
    kit.between((-0.3, 0.06, 0.55), (-reach, 0.07, radius), 0.022, material=metal, mirror=True)
    kit.add(CYL, (0.0, 0, 0.32), (0.11, 0.11, 0.08), rotation=ALONG_Y, material=metal)
    kit.add(BOX, (0.14, 0, 0.32), (0.12, 0.06, 0.06), material=dark)
    kit.add(BOX, (-0.25, 0.08, 0.36), (0.2, 0.03, 0.07), material=coat if kit.chance(0.5) else dark, mirror=True)
    kit.between((-0.02, -0.16, 0.24), (0.02, 0.16, 0.4), 0.012, material=metal)
    kit.add(BOX, (-0.02, 0.18, 0.4), (0.05, 0.05, 0.015), material=dark)
    kit.add(BOX, (-0.02, -0.18, 0.24), (0.05, 0.05, 0.015), material=dark)
    kit.between(head, head + [-0.04, 0, 0.18], 0.025, material=metal)
    kit.between(head + [-0.04, 0, 0.17], head + [-0.16, 0.28, 0.22], 0.016, material=metal, mirror=True)
    kit.add(BALL, head + [0.08, 0, 0.05], (0.1, 0.07, 0.07), material=coat)
    kit.add(CYL, head + [0.16, 0, 0.05], (0.06, 0.06, 0.015), rotation=ALONG_X, material=kit.material(base=[0.85, 0.85, 0.75], pattern=PLAIN))
    kit.add(BOX, (-reach, 0, 2 * radius + 0.12), (0.2, 0.1, 0.012), material=metal, cut=(RUNGS, 14, 0.3))
    kit.between((-reach, 0.08, radius), (-reach - 0.1, 0.08, 2 * radius + 0.12), 0.012, material=metal, mirror=True)
    kit.between((0.05, -0.1, 0.27), (-reach - 0.1, -0.11, 0.25), 0.03, material=metal)
    if kit.chance(0.3):
        kit.add(BOX, (-reach - 0.02, 0, 2 * radius + 0.29), (0.17, 0.17, 0.16), material=kit.material())
    kit.add(BOX, (-reach - radius - 0.03, 0, radius + 0.12), (0.02, 0.04, 0.04), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN))


def upright(kit):
    """What one rides standing: two wheels side by side, or a kick scooter with its deck between small wheels."""
    rng = kit.rng
    coat, dark, metal, tyre = car_paint(kit), kit.material(dark=True), chrome(kit), rubber(kit)
    if kit.chance(0.55):
        radius, wide, tall = rng.uniform(0.2, 0.26), rng.uniform(0.24, 0.3), rng.uniform(1.0, 1.2)
        rims(kit, 0, wide, radius, 0.06, tyre, metal, int(rng.integers(0, 7)))
        kit.add(BOX, (0, 0, radius), (0.18, wide * 0.85, 0.07), (0.9, 0.95), material=coat)
        kit.add(BOX, (0, 0, radius + 0.08), (0.17, wide * 0.75, 0.015), material=dark)
        arch(kit, 0, wide, radius, radius + 0.03, 0.07, 30, 150, 4, coat)
        kit.between((0.14, 0, radius), (0.22, 0, radius + 0.25), 0.05, material=coat)
        kit.between((0.22, 0, radius + 0.2), (0.14, 0, tall), 0.024, material=metal)
        kit.add(BOX, (0.14, 0, tall), (0.04, 0.07, 0.05), material=dark)
        kit.between((0.14, 0, tall), (0.08, 0.26, tall + 0.06), 0.02, material=dark, mirror=True)
        if kit.chance(0.4):
            kit.add(BOX, (0.24, 0, tall * 0.75), (0.08, 0.15, 0.12), material=kit.material())
    else:
        radius, reach, tall = rng.uniform(0.07, 0.13), rng.uniform(0.38, 0.45), rng.uniform(0.9, 1.1)
        for x in (reach, -reach):
            rims(kit, x, 0, radius, 0.03, tyre, metal)
        kit.add(BOX, (-0.03, 0, radius + 0.03), (reach - radius, rng.uniform(0.07, 0.1), 0.03), material=coat)
        kit.between((-reach + 0.05, 0.045, radius + 0.03), (-reach, 0.045, radius), 0.015, BOX, material=coat, mirror=True)
        kit.between((reach - radius - 0.08, 0, radius + 0.03), (reach - 0.05, 0, 0.34), (0.03, 0.04), BOX, material=coat)
        kit.between((reach, 0.045, radius), (reach - 0.04, 0.045, 0.26), 0.015, BOX, material=metal, mirror=True)
        kit.add(BOX, (reach - 0.04, 0, 0.27), (0.05, 0.065, 0.03), material=metal)
        kit.between((reach - 0.03, 0, 0.24), (reach - 0.13, 0, tall), 0.022, material=metal)
        kit.between((reach - 0.13, -0.24, tall), (reach - 0.13, 0.24, tall), 0.017, material=dark)
        arch(kit, -reach, 0, radius, radius + 0.02, 0.035, 60, 160, 2, dark)
        kit.add(BALL, (reach - 0.08, 0, tall - 0.08), (0.03, 0.035, 0.03), material=kit.material(base=[0.85, 0.85, 0.75], pattern=PLAIN))


def wheelchair(kit):
    rng = kit.rng
    coat, dark, metal, tyre, cloth = car_paint(kit), kit.material(dark=True), chrome(kit), rubber(kit), hide(kit)
    wide, deck, back = rng.uniform(0.21, 0.26), rng.uniform(0.46, 0.52), rng.uniform(0.4, 0.55)
    bar = coat if kit.chance(0.5) else metal
    kit.add(BOX, (0, 0, deck), (0.21, wide, 0.035), material=cloth)
    kit.add(BOX, (-0.23, 0, deck + back / 2), (0.025, wide * 0.95, back / 2), (1, 1), (-0.05, 0), material=cloth)
    if kit.chance(0.3):  # electric
        kit.add(BOX, (-0.05, 0, 0.27), (0.3, wide * 0.8, 0.12), (0.9, 0.9), material=coat)
        kit.between((0, 0, 0.3), (0, 0, deck), 0.07, material=dark)
        rims(kit, -0.1, wide + 0.05, 0.18, 0.05, tyre, metal, int(rng.integers(0, 6)))
        for x in (0.32, -0.4):
            rims(kit, x, wide * 0.9, 0.09, 0.03, tyre, metal)
            kit.between((x, wide * 0.9, 0.1), (x * 0.7, wide * 0.6, 0.25), 0.025, BOX, material=dark, mirror=True)
        kit.add(BOX, (0.28, -wide - 0.04, deck + 0.25), (0.06, 0.04, 0.03), material=dark)
        kit.between((0.28, -wide - 0.04, deck + 0.25), (0.29, -wide - 0.04, deck + 0.34), 0.012, material=dark)
    else:
        radius = rng.uniform(0.28, 0.33)
        wired(kit, -0.14, wide + 0.07, radius, 0.018, tyre, metal, int(rng.integers(12, 26)), 0.15)
        kit.add(CYL, (-0.14, wide + 0.105, radius), (radius * 0.9, radius * 0.9, 0.01), rotation=ALONG_Y, material=metal, mirror=True, cut=RING)
        kit.between((-0.14, -wide - 0.1, radius), (-0.14, wide + 0.1, radius), 0.02, material=metal)
        rims(kit, 0.3, wide * 0.95, 0.09, 0.02, tyre, metal)
        kit.between((0.3, wide * 0.95, 0.09), (0.26, wide * 0.95, 0.24), 0.015, BOX, material=dark, mirror=True)
        kit.between((0.25, wide, 0.22), (0.25, wide, deck + 0.03), 0.014, material=bar, mirror=True)
        kit.between((-0.2, wide, 0.22), (0.26, wide, 0.22), 0.014, material=bar, mirror=True)
        kit.between((0.18, -wide, 0.24), (0.1, wide, deck), 0.013, material=bar)
        kit.between((0.18, wide, 0.24), (0.1, -wide, deck), 0.013, material=bar)
    kit.between((-0.21, wide, 0.2), (-0.27, wide, deck + back + 0.06), 0.015, material=bar, mirror=True)
    kit.between((-0.27, wide, deck + back + 0.05), (-0.42, wide, deck + back + 0.03), 0.02, material=dark, mirror=True)
    kit.between((-0.25, wide + 0.02, deck + 0.22), (0.16, wide + 0.02, deck + 0.22), (0.018, 0.03), BOX, material=dark, mirror=True)
    kit.between((0.15, wide + 0.02, deck + 0.22), (0.16, wide, deck), 0.013, material=bar, mirror=True)
    kit.between((-0.22, wide, deck), (0.24, wide, deck), 0.015, material=bar, mirror=True)
    kit.between((0.23, wide * 0.8, deck), (0.48, wide * 0.7, 0.14), 0.014, material=bar, mirror=True)
    kit.add(BOX, (0.52, wide * 0.48, 0.13), (0.1, wide * 0.35, 0.012), rotation=turn("y", -12), material=dark, mirror=True)


def pushchair(kit):
    rng = kit.rng
    cloth, second, dark, metal, tyre = kit.material(gloss=0.05), kit.material(), kit.material(dark=True), chrome(kit), rubber(kit)
    if kit.chance(0.4):  # a pram with its cot on high wheels
        radius, wide = rng.uniform(0.2, 0.28), rng.uniform(0.22, 0.27)
        for x in (0.36, -0.36):
            wired(kit, x, wide, radius * rng.choice([0.85, 1.0]), 0.015, tyre, metal, 16, 0.18)
            kit.between((x, -wide, radius * 0.95), (x, wide, radius * 0.95), 0.012, material=metal)
        low = 2 * radius + rng.uniform(0.05, 0.15)
        kit.between((0.36, wide * 0.8, radius), (-0.3, wide * 0.8, low + 0.02), 0.014, material=metal, mirror=True)
        kit.between((-0.36, wide * 0.8, radius), (0.3, wide * 0.8, low + 0.02), 0.014, material=metal, mirror=True)
        slab(kit, low, low + 0.32, (-0.36, 0.36, wide * 0.72), (-0.48, 0.5, wide), cloth)
        slab(kit, low + 0.3, low + 0.36, (-0.45, 0.5, wide), (-0.43, 0.47, wide * 0.9), second)
        reach = -0.43
        hood(kit, np.array([-0.12, 0, low + 0.3]), 0.38, wide, (0, 45, 90, 130), cloth, metal)
        kit.between((reach, wide * 0.9, low + 0.25), (-0.85, wide * 0.9, low + 0.42), 0.014, material=metal, mirror=True)
        kit.between((-0.85, -wide * 0.9, low + 0.42), (-0.85, wide * 0.9, low + 0.42), 0.02, material=dark)
    else:
        wide, radius = rng.uniform(0.22, 0.27), rng.uniform(0.08, 0.15)
        three = kit.chance(0.4)
        rims(kit, -0.3, wide, radius * 1.1, 0.025, tyre, metal, int(rng.integers(0, 7)))
        rims(kit, 0.42, 0 if three else wide * 0.9, radius, 0.025, tyre, metal)
        kit.between((0.42, 0.03 if three else wide * 0.9, radius), (-0.12, wide * 0.85, 0.62), 0.016, material=metal, mirror=True)
        kit.between((-0.3, wide * 0.95, radius), (0.08, wide * 0.85, 0.55), 0.016, material=metal, mirror=True)
        kit.between((-0.12, wide * 0.85, 0.62), (-0.55, wide * 0.85, 1.02), 0.016, material=metal, mirror=True)
        kit.between((-0.55, -wide * 0.87, 1.02), (-0.55, wide * 0.87, 1.02), 0.02, material=dark)
        kit.between((-0.3, -wide, radius * 1.1), (-0.3, wide, radius * 1.1), 0.012, material=metal)
        kit.add(BOX, (0.08, 0, 0.48), (0.2, wide * 0.78, 0.05), material=cloth)
        kit.between((-0.08, 0, 0.48), (-0.3, 0, 0.95), (0.035, wide * 0.75), BOX, material=cloth)
        kit.between((0.26, 0, 0.48), (0.38, 0, 0.26), (0.03, wide * 0.6), BOX, material=cloth)
        kit.add(BOX, (0.42, 0, 0.24), (0.09, wide * 0.6, 0.015), material=dark)
        kit.add(BOX, (-0.02, wide * 0.78, 0.58), (0.2, 0.02, 0.1), material=cloth, mirror=True)
        kit.between((0.2, -wide * 0.8, 0.68), (0.2, wide * 0.8, 0.68), 0.02, material=dark)
        kit.between((0.2, wide * 0.8, 0.68), (-0.05, wide * 0.8, 0.6), 0.014, material=dark, mirror=True)
        hood(kit, np.array([-0.18, 0, 0.78]), 0.34, wide * 0.85, (40, 85, 130), second if kit.chance(0.6) else cloth, metal)
        kit.add(BOX, (-0.05, 0, 0.22), (0.22, wide * 0.7, 0.06), (1.1, 1.1), material=dark)
        kit.between((-0.1, -wide * 0.9, 0.24), (-0.1, wide * 0.9, 0.24), 0.015, material=metal)
    if kit.chance(0.4):
        kit.add(BALL, (0.05, 0, 0.62 if radius < 0.18 else low + 0.4), (0.14, 0.12, 0.12), material=kit.material())


def trolley(kit):
    rng = kit.rng
    wire = chrome(kit) if kit.chance(0.7) else car_paint(kit)
    plastic, dark = kit.material(base=paint(rng.random(), 0.9, 0.5), pattern=PLAIN), kit.material(dark=True)
    wide, low, high = rng.uniform(0.24, 0.3), rng.uniform(0.45, 0.6), rng.uniform(0.95, 1.05)
    mesh = (GRID, rng.uniform(10, 16), rng.uniform(0.15, 0.3))
    back, front = -0.42, rng.uniform(0.4, 0.5)
    drop = rng.uniform(0.0, 0.12)
    kit.add(BOX, ((back + front) / 2, 0, low), ((front - back) / 2 * 0.95, wide * 0.85, 0.012), rotation=turn("y", np.degrees(np.arctan2(-drop, front - back))), material=wire, cut=mesh)
    tilt = np.degrees(np.arctan2(wide * 0.15, high - low))
    for side in (-1, 1):
        kit.add(BOX, ((back + front) / 2, side * wide * 0.93, (low + high) / 2), ((front - back) / 2, 0.01, (high - low) / 2), rotation=turn("x", -side * tilt), material=wire, cut=mesh)
    for x in (back, front):
        kit.add(BOX, (x, 0, (low + high) / 2), (0.01, wide * 0.95, (high - low) / 2), material=wire, cut=mesh)
    for z, share in ((high, 1.0), (low, 0.86)):
        kit.between((back, wide * share, z), (front, wide * share, z), 0.012, material=wire, mirror=True)
        for x in (back, front):
            kit.between((x, -wide * share, z), (x, wide * share, z), 0.012, material=wire)
    kit.between((-0.45, wide, 0.14), (-0.45, wide, high), 0.014, material=wire, mirror=True)
    kit.between((-0.45, wide, 0.14), (0.42, wide * 0.75, 0.14), 0.016, material=wire, mirror=True)
    kit.between((0.42, -wide * 0.75, 0.14), (0.42, wide * 0.75, 0.14), 0.016, material=wire)
    kit.between((-0.3, wide, 0.14), (0.25, wide * 0.86, low), 0.014, material=wire, mirror=True)
    kit.between((-0.45, wide, high - 0.02), (-0.58, wide, high + 0.06), 0.013, material=wire, mirror=True)
    kit.between((-0.58, -wide * 1.05, high + 0.06), (-0.58, wide * 1.05, high + 0.06), 0.022, material=plastic)
    for x, y in ((-0.42, wide), (0.38, wide * 0.75)):
        kit.add(CYL, (x, y, 0.06), (0.06, 0.06, 0.015), rotation=ALONG_Y, material=dark, mirror=True)
        kit.between((x, y, 0.06), (x, y, 0.15), 0.02, BOX, material=wire, mirror=True)
    kit.add(BOX, (0, 0, 0.17), (0.4, wide * 0.8, 0.01), material=wire, cut=(BARS, 12, 0.25))
    kit.add(BOX, (-0.3, 0, high - 0.1), (0.1, wide * 0.8, 0.012), rotation=turn("y", 25), material=plastic)
    for _ in range(int(rng.integers(0, 7))):
        half = rng.uniform(0.06, 0.14, 3)
        kit.add(rng.choice([BOX, CYL, BALL]), (rng.uniform(-0.2, 0.3), rng.uniform(-0.4, 0.4) * wide, low + 0.02 + half[2] * rng.uniform(1, 2)), half)


def wheelbarrow(kit):
    rng = kit.rng
    tray, wood, dark, tyre = machine_paint(kit), timber(kit), kit.material(dark=True), rubber(kit)
    bar = wood if kit.chance(0.45) else kit.material(dark=kit.chance(0.5), pattern=PLAIN)
    radius, wide, tall = rng.uniform(0.17, 0.22), rng.uniform(0.27, 0.34), rng.uniform(0.2, 0.28)
    if kit.chance(0.25):
        tray = kit.material(base=wood.first, pattern=PLANKS, frequency=8)
    front = rng.uniform(0.5, 0.6)
    rims(kit, front, 0, radius, 0.045, tyre, car_paint(kit))
    kit.between((front + 0.02, -0.1, radius), (front + 0.02, 0.1, radius), 0.015, material=dark)
    low = rng.uniform(0.36, 0.42)
    kit.between((front + 0.08, 0.09, radius), (-0.95, rng.uniform(0.24, 0.3), rng.uniform(0.52, 0.62)), 0.022, BOX if bar is wood else CYL, material=bar, mirror=True)
    kit.add(BOX, (-0.05, 0, low), (0.28, wide * 0.6, 0.02), rotation=turn("y", 6), material=tray)
    top = low + tall
    kit.between((-0.32, 0, low), (-0.48, 0, top), (0.015, wide * 0.72), BOX, 1, material=tray)
    kit.between((0.22, 0, low - 0.02), (0.52, 0, top + 0.04), (0.015, wide * 0.72), BOX, 1, material=tray)
    lean = np.arctan2(wide * 0.3, tall)
    for side in (-1, 1):
        at = (-0.02, side * wide * 0.75, (low + top) / 2)
        kit.add(BOX, at, (0.29, 0.014, tall / 2 / np.cos(lean) + 0.02), (1.65, 1), (0.04, 0), rotation=turn("x", -side * np.degrees(lean)), material=tray)
    kit.between((-0.15, 0.17, low), (-0.28, 0.24, 0.0), 0.018, BOX if bar is wood else CYL, material=bar, mirror=True)
    kit.between((-0.28, 0.24, 0.015), (-0.05, 0.2, low - 0.03), 0.014, material=bar, mirror=True)
    kit.between((-0.24, -0.22, 0.15), (-0.24, 0.22, 0.15), 0.012, material=bar)
    kit.between((front + 0.06, 0.08, radius + 0.02), (0.36, 0.1, low + 0.08), 0.014, BOX, material=bar, mirror=True)
    if kit.chance(0.45):
        load = kit.material(base=rng.choice([[0.12, 0.07, 0.04], [0.4, 0.3, 0.18], [0.1, 0.25, 0.05], [0.35, 0.35, 0.35]]), pattern=rng.choice([CLOUDY, 17]), frequency=20)
        kit.add(BALL, (0.0, 0, top - 0.02), (0.4, wide * 0.85, rng.uniform(0.1, 0.25)), material=load)
