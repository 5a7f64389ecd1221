"""Makers of vehicles with four sides that differ, each finished all around: off-roaders, vans, covered lorries, carriers."""

import numpy as np

from .kit import ALONG_X, ALONG_Y
from .layout import BALL, BOX, CYL
from .machines import wheel
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, RIBS, SEAMS, STREAKS, WRITING
from .vehicles import wheels

SERVICE = [[0.16, 0.17, 0.09], [0.45, 0.36, 0.22], [0.12, 0.14, 0.12], [0.3, 0.3, 0.26], [0.2, 0.22, 0.18]]


def coat(kit):
    """Service paint or any; plain, patched or streaked."""
    if kit.chance(0.5):
        base = np.array(kit.rng.choice(SERVICE)) * kit.rng.uniform(0.6, 1.6)
        return kit.material(base=base, pattern=kit.rng.choice([PLAIN, PLAIN, CAMOUFLAGE, CLOUDY]))
    return kit.material(pattern=kit.rng.choice([PLAIN, PLAIN, STREAKS, CLOUDY]))


def glazing(kit):
    return kit.material(base=np.array([0.05, 0.06, 0.07]) + kit.rng.uniform(0, 0.1), gloss=kit.rng.uniform(0.2, 0.7), pattern=PLAIN)


def lamps(kit, front, rear, wide, high, size):
    """Head lamps at x = front and tail lamps at x = rear, `wide` from the middle and `high` above the ground."""
    white = kit.material(base=[0.8, 0.8, 0.72], pattern=PLAIN, gloss=0.5)
    red = kit.material(base=[0.45, 0.03, 0.03], pattern=PLAIN, gloss=0.4)
    if kit.chance(0.6):
        kit.add(CYL, (front, wide * 0.75, high), (size, size, 0.04), rotation=ALONG_X, material=white, mirror=True)
    else:
        kit.add(BOX, (front, wide * 0.72, high), (0.04, size * 1.3, size * 0.8), material=white, mirror=True)
    kit.add(BOX, (rear, wide * 0.86, high), (0.04, size * 0.6, size * kit.rng.uniform(0.8, 2)), material=red, mirror=True)


def plates(kit, front, rear, high):
    plate = kit.material(base=[0.8, 0.8, 0.7], pattern=WRITING, frequency=30, second=[0.02] * 3)
    for x in (front, rear):
        kit.add(BOX, (x, kit.rng.choice([0, 0, 0.3]), high), (0.03, 0.24, 0.06), material=plate)


def doors(kit, edges, wide, floor, top, dark):
    """Upright seams at every x of `edges` on both sides, and a handle beside each but the last."""
    for i, x in enumerate(edges):
        kit.add(BOX, (x, wide, (floor + top) / 2), (0.012, 0.012, (top - floor) / 2), material=dark, mirror=True)
        if i + 1 < len(edges):
            kit.add(BOX, (x + 0.12, wide, top - 0.12), (0.07, 0.025, 0.02), material=dark, mirror=True)


def offroad(kit):
    """Off-roaders and utility vehicles: flat sides, upright or sloping screen, arches, spare wheel or cans behind."""
    rng = kit.rng
    wide, radius = rng.uniform(0.8, 1.12), rng.uniform(0.38, 0.52)
    front, rear = rng.uniform(0.75, 1.1), rng.uniform(0.0, 1.0)
    cabin = rng.uniform(0.7, 1.15)
    sill, belt = radius * rng.uniform(0.9, 1.3), radius * 2 + rng.uniform(0.15, 0.45)
    roof = belt + rng.uniform(0.4, 0.75)
    body, dark, glass = coat(kit), kit.material(dark=True), glazing(kit)
    middle, nose, tail = (sill + belt) / 2, cabin + 2 * front, -cabin - 2 * rear
    kit.add(BOX, ((cabin + tail) / 2, 0, middle), ((cabin - tail) / 2, wide, (belt - sill) / 2), (1, rng.uniform(0.95, 1)), material=body)
    drop = rng.uniform(0, 0.12)
    kit.add(BOX, (cabin + front, 0, middle - drop / 2), (front, wide * rng.uniform(0.72, 1), (belt - sill - drop) / 2), (1, 0.96), material=body)
    kit.add(BOX, (cabin + front, 0, sill + 0.1), (front, wide, 0.14), material=body)
    lean = rng.uniform(0.02, 0.35)
    taper, shift = (1 - lean / cabin / 2, rng.uniform(0.82, 0.98)), (-lean / 2, 0)
    tall = (roof - belt) / 2
    rag = kit.chance(0.25)
    upper = kit.material(pattern=rng.choice([PLAIN, CLOUDY])) if rag else body
    kit.add(BOX, (0, 0, belt + tall), (cabin, wide * 0.97, tall), taper, shift, material=upper)
    kit.add(BOX, (0.01, 0, belt + tall * 0.95), (cabin + 0.01, wide * 0.82, tall * 0.7), taper, shift, material=glass)
    count = int(rng.integers(2, 4))
    for i in range(count):
        x = cabin * ((2 * i + 1) / count - 1) * 0.95 - lean / 4
        kit.add(BOX, (x, 0, belt + tall * 0.95), (cabin * 0.78 / count, wide * 0.985, tall * 0.68), (0.97, taper[1]), material=glass)
    doors(kit, np.linspace(-cabin * 0.97, cabin * 0.97, count + 1), wide, sill + 0.1, belt, dark)
    if rear > 0.25:  # what stands behind the cabin: a sloping back, a bed, a hard or a soft box
        kind, x = rng.random(), -cabin - rear
        if kind < 0.3:
            kit.add(BOX, (x, 0, belt + tall), (rear, wide * 0.95, tall), (0.08, 0.9), (rear * 0.92, 0), material=body)
        elif kind < 0.6:
            kit.add(BOX, (x, 0, belt + tall), (rear, wide * 0.96, tall * rng.uniform(0.9, 1.2)), (0.97, 0.93), material=upper)
        else:
            kit.add(BOX, (x, 0, belt), (rear * 0.93, wide * 0.9, 0.03), material=dark)
    axles = (cabin + front * rng.uniform(0.9, 1.2), tail + radius * rng.uniform(1.3, 1.8))
    tyre, hub = kit.material(dark=True), kit.material(base=rng.uniform(0.1, 0.7) * np.ones(3))
    for x in axles:
        kit.add(BOX, (x, wide * 0.97, radius * 1.95), (radius * 1.25, 0.1, 0.07), (0.8, 1), material=rng.choice([0, 1]) and body or dark, mirror=True)
        wheel(kit, (x, wide * 0.9, radius), radius, rng.uniform(0.12, 0.18), tyre, hub)
    high = middle + 0.05
    lamps(kit, nose, tail, wide, high, rng.uniform(0.08, 0.13))
    plates(kit, nose + 0.06, tail - 0.04, sill + 0.1)
    kit.add(BOX, (nose, 0, middle), (0.02, wide * 0.42, (belt - sill) * 0.25), material=kit.material(pattern=RIBS, frequency=40, second=[0.02] * 3))
    for x in (nose + 0.07, tail - 0.05):
        kit.add(BOX, (x, 0, sill + 0.02), (0.07, wide * 0.97, 0.08), material=dark)
    if kit.chance(0.5):
        kit.add(CYL, (tail - 0.1, rng.choice([0, 0.35]) * wide, middle + 0.25), (radius * 0.85, radius * 0.85, 0.1), rotation=ALONG_X, material=tyre)
    elif kit.chance(0.5):
        kit.add(BOX, (tail - 0.08, wide * 0.55, middle + 0.15), (0.09, 0.15, 0.22), material=coat(kit), mirror=kit.chance(0.5))
    if kit.chance(0.4):
        kit.between((tail + 0.1, wide * 0.9, belt), (tail + 0.1, wide * 0.9, roof + rng.uniform(0.5, 1.4)), 0.012, material=dark)
    kit.add(BOX, (cabin * 0.9, wide * 1.12, belt + 0.12), (0.03, 0.08, 0.12), material=dark, mirror=True)


def van(kit):
    """Panel vans, minibuses, ambulances: one box with a short nose, doors behind, windows or none."""
    rng = kit.rng
    half, wide, radius = rng.uniform(1.8, 3.0), rng.uniform(0.85, 1.05), rng.uniform(0.3, 0.38)
    floor, roof = radius * rng.uniform(0.7, 1.0), rng.uniform(1.75, 2.7)
    body, dark, glass = kit.material(pattern=rng.choice([PLAIN, PLAIN, PLAIN, STREAKS])), kit.material(dark=True), glazing(kit)
    nose, belt = rng.uniform(0.25, 0.8), floor + (roof - floor) * rng.uniform(0.42, 0.52)
    low, tall = (floor + belt) / 2, (roof - belt) / 2
    kit.add(BOX, (0, 0, low), (half, wide, (belt - floor) / 2), (1, 0.98), material=body)
    lean = rng.uniform(0.3, 0.9) * tall * 2
    upper = half - nose / 2
    taper, shift = (1 - lean / upper / 2, rng.uniform(0.86, 0.96)), (-lean / 2, 0)
    kit.add(BOX, (-nose / 2, 0, belt + tall), (upper, wide * 0.985, tall), taper, shift, material=body)
    kit.add(BOX, (-nose / 2 + 0.012, 0, belt + tall * 0.8), (upper, wide * 0.86, tall * 0.66), taper, shift, material=glass)
    if kit.chance(0.35):  # no window behind
        kit.add(BOX, (-half + 0.1, 0, belt + tall * 0.8), (0.115, wide * 0.88, tall * 0.7), (1, taper[1]), material=body)
    count = rng.choice([1, 1, 2, 4])
    length = (2 * upper - lean) * rng.uniform(0.8, 0.95)
    for i in range(count if count > 1 else 1):
        share = length / (4 if count == 1 else count)
        x = upper - nose / 2 - lean * 0.75 - share * (i + 0.5)
        kit.add(BOX, (x, 0, belt + tall * 0.85), (share * 0.44, wide, tall * 0.55), (1, taper[1]), material=glass)
    doors(kit, [half * 0.62, half * 0.2, -half * 0.25], wide, floor + 0.1, belt + tall * 0.9, dark)
    kit.add(BOX, (-half, 0, (floor + roof) / 2), (0.015, 0.015, (roof - floor) * 0.42), material=dark)
    kit.add(BOX, (-half - 0.02, 0.08, low + 0.1), (0.03, 0.03, 0.08), material=dark)
    lamps(kit, half + 0.01, -half, wide, belt - 0.22, rng.uniform(0.09, 0.14))
    plates(kit, half + 0.05, -half - 0.03, floor + 0.2)
    for x in (half, -half):
        kit.add(BOX, (x, 0, floor + 0.08), (0.07, wide * 0.98, 0.1), material=dark)
    kit.add(BOX, (half, 0, low + 0.05), (0.03, wide * 0.45, 0.08), material=dark)
    if kit.chance(0.35):
        band = (floor + belt) / 2 + rng.uniform(-0.1, 0.25)
        kit.add(BOX, (0, 0, band), (half * 1.003, wide * 1.005, rng.uniform(0.05, 0.15)), material=kit.material())
    if kit.chance(0.25):
        kit.add(BOX, (upper * 0.4, 0, roof + 0.07), (0.12, wide * 0.6, 0.07), material=kit.material(base=[0.05, 0.1, 0.6], gloss=-0.6))
    tyre, hub = kit.material(dark=True), kit.material(base=rng.uniform(0.2, 0.8) * np.ones(3))
    for x in (half * rng.uniform(0.58, 0.7), -half * rng.uniform(0.55, 0.7)):
        kit.add(CYL, (x, wide * 0.93, radius + 0.03), (radius * 1.15, radius * 1.15, wide * 0.09), rotation=ALONG_Y, material=dark, mirror=True)
        wheel(kit, (x, wide * 0.92, radius), radius, 0.11, tyre, hub)
    kit.add(BOX, (half - nose * 0.8, wide * 1.12, belt + 0.15), (0.04, 0.1, 0.13), material=dark, mirror=True)


def covered_lorry(kit):
    """Service lorries: cab with screen and doors, a bed with sides under a cover or open, three axles or two."""
    rng = kit.rng
    wide, radius = rng.uniform(0.95, 1.2), rng.uniform(0.42, 0.58)
    bed, cab = rng.uniform(1.4, 2.5), rng.uniform(0.6, 0.9)
    floor = radius * 2.2
    body, dark, glass = coat(kit), kit.material(dark=True), glazing(kit)
    hood = rng.uniform(0.5, 0.9) if kit.chance(0.45) else 0
    tall = rng.uniform(0.7, 0.95)
    base = radius * 1.2
    x = bed + 0.12 + cab
    kit.add(BOX, (0.3, 0, floor - 0.14), (bed + cab, wide * 0.4, 0.1), material=dark)
    kit.add(BOX, (x, 0, base + tall), (cab, wide, tall), (rng.uniform(0.85, 1), 0.96), (-0.04, 0), material=body)
    kit.add(BOX, (x, 0, base + tall * 1.5), (cab * 1.0, wide * 0.86, tall * 0.3), (0.95, 0.98), material=glass)
    kit.add(BOX, (x + cab * 0.1, 0, base + tall * 1.5), (cab * 0.55, wide * 1.005, tall * 0.28), (1, 0.98), material=glass)
    doors(kit, [x - cab * 0.6, x + cab * 0.75], wide, base + 0.1, base + tall * 1.2, dark)
    front = x + cab
    if hood:
        kit.add(BOX, (front + hood, 0, base + tall * 0.6), (hood, wide * 0.8, tall * 0.5), (0.96, 0.9), material=body)
        kit.add(BOX, (front + hood, 0, base + 0.1), (hood, wide * 0.98, 0.12), material=body)
        front += 2 * hood
    kit.add(BOX, (front, 0, base + tall * 0.55), (0.03, wide * 0.5, tall * 0.28), material=kit.material(pattern=RIBS, frequency=35, second=[0.02] * 3))
    kit.add(BOX, (front + 0.08, 0, base), (0.09, wide, 0.12), material=dark)
    lamps(kit, front + 0.02, -bed - 0.02, wide, base + 0.25, rng.uniform(0.09, 0.13))
    plates(kit, front + 0.18, -bed - 0.05, base)
    board = rng.uniform(0.2, 0.35)
    side = kit.material(base=body.first, pattern=rng.choice([PLAIN, SEAMS, RIBS]), frequency=rng.uniform(5, 15))
    kit.add(BOX, (0, 0, floor), (bed, wide, 0.06), material=dark)
    for x in (-bed, bed):
        kit.add(BOX, (x, 0, floor + board), (0.04, wide, board), material=side)
    kit.add(BOX, (0, wide * 0.98, floor + board), (bed, 0.03, board), material=side, mirror=True)
    kind = rng.random()
    if kind < 0.6:
        cloth = coat(kit) if kit.chance(0.7) else kit.material(pattern=CLOUDY)
        rise = rng.uniform(0.45, 0.7)
        kit.add(BOX, (0, 0, floor + 2 * board + rise), (bed, wide * 0.99, rise), (0.99, 0.9), material=cloth)
        if kit.chance(0.7):
            kit.add(CYL, (0, 0, floor + 2 * board + 2 * rise), (0.25, wide * 0.88, bed * 0.99), rotation=ALONG_X, material=cloth)
        if kit.chance(0.5):
            kit.add(BOX, (-bed, 0, floor + 2 * board + rise * 0.8), (0.02, wide * 0.6, rise * 0.8), material=dark)
    elif kind < 0.8:
        for x in np.linspace(-bed, bed, 5):
            for y in (-1, 1):
                kit.between((x, y * wide * 0.96, floor), (x, y * wide * 0.96, floor + 1.5), 0.025, BOX, material=dark)
    elif kind < 0.9:
        load = rng.uniform(0.35, 0.6)
        kit.add(BOX, (rng.uniform(-0.2, 0.2), 0, floor + load), (bed * rng.uniform(0.4, 0.85), wide * 0.8, load))
    axles = [-bed * 0.85 + radius * 0.5, front - (hood or cab) - 0.1]
    if kit.chance(0.5):
        axles.append(axles[0] + 2.15 * radius)
    wheels(kit, axles, wide * 0.88, radius, 0.17)
    kit.add(BOX, (bed + cab * 1.9, wide * 1.15, base + tall * 1.4), (0.03, 0.1, 0.2), material=dark, mirror=True)
    kit.add(BOX, (bed * 0.3, wide * 0.85, radius * 1.3), (0.4, 0.14, 0.2), material=body if kit.chance(0.5) else dark, mirror=True)


def carrier(kit):
    """Armoured carriers on four to eight wheels: sloping plates, hatches, a turret or a shield, cans and boxes behind."""
    rng = kit.rng
    half, wide, radius = rng.uniform(2.0, 3.4), rng.uniform(0.95, 1.35), rng.uniform(0.45, 0.6)
    belly, waist = radius * rng.uniform(0.8, 1.1), radius * 2 + rng.uniform(0.05, 0.25)
    top = waist + rng.uniform(0.45, 0.8)
    body, dark = coat(kit), kit.material(dark=True)
    kit.add(BOX, (0, 0, (belly + waist) / 2), (half * 0.9, wide * 0.75, (waist - belly) / 2), (1.08, 1.3), material=body)
    slope = rng.uniform(0.25, 0.75) * (top - waist) * 2
    kit.add(BOX, (0, 0, (waist + top) / 2), (half, wide, (top - waist) / 2), (1 - slope / half / 2, rng.uniform(0.7, 0.92)), (-slope / 2.2, 0), material=body)
    count = int(rng.choice([2, 3, 4]))
    places = np.linspace(-0.72, 0.72, count) * half
    tyre, hub = kit.material(dark=True), kit.material(base=body.first, pattern=PLAIN)
    for x in places:
        wheel(kit, (x, wide * 0.88, radius), radius, rng.uniform(0.14, 0.2), tyre, hub)
    roof = top + 0.03
    kind = rng.random()
    x = rng.uniform(-0.3, 0.3) * half
    if kind < 0.45:
        size = rng.uniform(0.45, 0.8) * wide
        kit.add(CYL, (x, 0, roof + 0.2), (size * 1.15, size, 0.22), (rng.uniform(0.6, 0.9), 1), material=body)
        gun = rng.uniform(0.5, 1.1)
        kit.add(CYL, (x + size + gun * 0.9, 0, roof + 0.25), (0.05, 0.05, gun), rotation=ALONG_X, material=dark)
    elif kind < 0.75:
        kit.add(CYL, (x, 0, roof), (0.4, 0.4, 0.06), material=dark)
        kit.add(BOX, (x + 0.35, 0, roof + 0.2), (0.03, 0.35, 0.2), (0.8, 0.9), material=body)
        kit.add(CYL, (x + 0.6, 0, roof + 0.3), (0.03, 0.03, 0.5), rotation=ALONG_X, material=dark)
    for y in (-0.45, 0.45):
        kit.add(CYL, (half * 0.45, y * wide, top), (0.25, 0.25, 0.05), material=body)
        kit.add(BOX, (-half * 0.6, y * wide, top), (0.35, 0.28, 0.04), material=body)
    slit = glazing(kit)
    for y in (-0.4, 0.4):
        kit.add(BOX, (half - slope * 0.8, y * wide, waist + (top - waist) * 0.7), (0.12, 0.2, 0.07), material=slit)
    lamps(kit, half * 0.97, -half * 0.99, wide, waist - 0.05, rng.uniform(0.07, 0.11))
    kit.add(BOX, (-half, 0, (waist + top) / 2), (0.04, wide * 0.42, (top - waist) * 0.46), material=kit.material(base=body.first * 0.8, pattern=PLAIN))
    doors(kit, np.linspace(-half * 0.3, half * 0.2, 2), wide * 0.97, waist, top - 0.1, dark)
    if kit.chance(0.6):
        kit.add(BOX, (-half * 0.4, wide * 0.98, waist + 0.12), (half * 0.3, 0.12, 0.12), material=body, mirror=True)
    if kit.chance(0.5):
        kit.add(BOX, (-half - 0.08, wide * 0.7, waist + 0.15), (0.09, 0.14, 0.22), material=coat(kit), mirror=True)
    if kit.chance(0.4):
        kit.add(BALL, (half * 0.1, wide * 0.85, top), (0.1, 0.1, 0.1), material=slit, mirror=True)
    for y in kit.rng.choice([-1, 1], int(rng.integers(0, 3))):
        kit.between((-half * 0.8, y * wide * 0.7, top), (-half * 0.85, y * wide * 0.7, top + rng.uniform(0.8, 1.8)), 0.012, material=dark)
