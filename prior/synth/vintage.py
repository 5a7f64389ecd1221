"""Makers of cars of 1900 to 1960, old vans and buses, carriages."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, TUBE
from .materials import BANDS, CLOUDY, PLAIN, PLANKS, RIBS, WRITING
from .roadcraft import arch, car_paint, chrome, greenhouse, hide, hood, rims, rubber, seat, section, slab, steering, timber, wired
from .wheeled import glazing, plates

# Old cars, buses and carriages.


def vintage(kit):
    """Cars of 1900 to 1950, finned cars of the fifties, beetles, old vans and buses, lorries, horse-drawn coaches and buggies."""
    makers = [veteran, veteran, tourer, tourer, tourer, streamliner, streamliner, fifties, fifties, beetle, beetle, old_van, old_bus, coach, coach, buggy, buggy]
    kit.rng.choice(makers)(kit)


def veteran(kit):
    """A car of about 1905: high seats on a flat frame, thin wheels, brass lamps, some with a folding hood."""
    rng = kit.rng
    coat, wood, brass, dark, cloth = car_paint(kit), timber(kit), kit.material(base=[0.6, 0.42, 0.12], pattern=PLAIN, gloss=0.6), kit.material(dark=True), hide(kit)
    tyre = rubber(kit) if kit.chance(0.6) else kit.material(base=[0.6, 0.58, 0.52], pattern=PLAIN)
    rows = int(rng.integers(1, 3))
    radius, reach, wide = rng.uniform(0.36, 0.44), rng.uniform(0.95, 1.1) + 0.3 * (rows - 1), rng.uniform(0.46, 0.54)
    rim = coat if kit.chance(0.5) else wood
    for x in (reach, -reach):
        wired(kit, x, wide + 0.16, radius, 0.04, tyre, rim, int(rng.choice([10, 12, 14])), 0.28)
        kit.between((x, -wide - 0.2, radius), (x, wide + 0.2, radius), 0.03, material=dark)
        kit.between((x - 0.35, wide * 0.8, radius + 0.2), (x + 0.35, wide * 0.8, radius + 0.2), (0.05, 0.03), BOX, material=dark, mirror=True)
        if kit.chance(0.85):
            arch(kit, x, wide + 0.16, radius, radius + 0.08, 0.1, 30 if x > 0 else 20, 165, 3, coat)
            kit.between((x, wide * 0.7, radius + 0.25), (x, wide + 0.2, 2 * radius + 0.08), 0.02, material=dark, mirror=True)
    floor = radius + 0.26
    kit.add(BOX, (0.05, 0, floor), (reach + 0.2, wide * 0.9, 0.05), material=coat)
    dash = reach - rng.uniform(0.35, 0.5)
    bonnet = rng.uniform(0.28, 0.42)
    section(kit, dash, reach + 0.2, (floor, floor + bonnet, wide * 0.6), (floor, floor + bonnet * 0.9, wide * 0.5), coat)
    kit.add(BOX, (reach + 0.21, 0, floor + bonnet * 0.45), (0.04, wide * 0.5, bonnet * 0.5), material=brass)
    kit.add(BOX, (reach + 0.24, 0, floor + bonnet * 0.45), (0.015, wide * 0.42, bonnet * 0.4), material=kit.material(base=[0.04] * 3, pattern=RIBS, frequency=40))
    kit.add(BOX, (dash, 0, floor + 0.25), (0.03, wide * 0.85, 0.3), material=wood)
    seats = [dash - 0.6] if rows == 1 else [dash - 0.6, -reach - 0.0]
    for x in seats:
        kit.add(BOX, (x, 0, floor + 0.17), (0.26, wide * 0.9, 0.17), material=coat)
        seat(kit, x, 0, floor + 0.34, wide * 0.86, rng.uniform(0.35, 0.5), cloth)
        kit.add(BOX, (x - 0.1, wide * 0.88, floor + 0.5), (0.2, 0.03, 0.13), material=coat, mirror=True)
    back = seats[-1]
    if rows == 1:
        section(kit, -reach - 0.15, back - 0.2, (floor, floor + 0.25, wide * 0.75), (floor, floor + 0.36, wide * 0.85), coat)
    kit.add(BOX, (0, wide + 0.16, radius * 0.8), (reach - radius - 0.05, 0.13, 0.02), material=wood, mirror=True)
    kit.between((0, wide * 0.85, floor), (0, wide + 0.15, radius * 0.8), 0.02, material=dark, mirror=True)
    kit.add(TUBE, (dash - 0.22, wide * 0.4, floor + 0.75), (0.2, 0.2, 0.02), rotation=turn("y", -40), material=dark)
    kit.between((dash - 0.22, wide * 0.4, floor + 0.75), (dash, wide * 0.4, floor + 0.2), 0.018, material=brass)
    for x, y, z in ((reach + 0.16, wide * 0.75, floor + 0.2), (dash + 0.04, wide * 0.95, floor + 0.42)):
        kit.add(CYL, (x, y, z), (0.1, 0.1, 0.08), rotation=ALONG_X, material=brass, mirror=True)
        kit.between((x, y, z), (x, wide * 0.6, z - 0.12), 0.018, material=brass, mirror=True)
    kind = rng.random()
    if kind < 0.4:
        hood(kit, np.array([back - 0.05, 0, floor + 0.75]), 0.75, wide * 0.95, (25, 65, 100, 140), dark, brass)
    elif kind < 0.65:
        slab(kit, floor + 0.5, floor + 1.1, (dash - 0.02, dash + 0.02, wide * 0.8), (dash - 0.04, dash, wide * 0.8), glazing(kit))
        kit.between((dash, wide * 0.82, floor + 0.4), (dash - 0.02, wide * 0.82, floor + 1.12), 0.018, material=brass, mirror=True)


def grille_front(kit, x, low, high, wide, metal):
    """An upright radiator with its shell."""
    section(kit, x - 0.06, x + 0.03, (low, high, wide), (low, high - 0.02, wide * 0.95), metal)
    kit.add(BOX, (x + 0.035, 0, (low + high) / 2 - 0.01), (0.012, wide * 0.78, (high - low) * 0.42), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=45, second=metal.first))
    kit.add(CYL, (x - 0.02, 0, high + 0.02), (0.03, 0.03, 0.04), material=metal)


def tourer(kit):
    """A car of the twenties or thirties: long hood, separate wings over the wheels, running boards; open, a coupé or a saloon."""
    rng = kit.rng
    coat, metal, dark, tyre, cloth = car_paint(kit), chrome(kit), kit.material(dark=True), rubber(kit), hide(kit)
    wings = coat if kit.chance(0.5) else kit.material(base=[0.03] * 3, pattern=PLAIN, gloss=0.5)
    radius, front = rng.uniform(0.34, 0.4), rng.uniform(1.25, 1.65)
    rear, wide = -rng.uniform(1.15, 1.45), rng.uniform(0.5, 0.62)
    track, floor, belt = wide + 0.16, radius * 1.1, rng.uniform(1.0, 1.12)
    spokes = int(rng.integers(12, 22)) if kit.chance(0.8) else 0
    for x in (front, rear):
        if spokes:
            wired(kit, x, track, radius, 0.06, tyre, metal if kit.chance(0.5) else coat, spokes, 0.25)
        else:
            rims(kit, x, track, radius, 0.065, tyre, coat)
        kit.between((x, -track, radius), (x, track, radius), 0.035, material=dark)
    kit.between((rear - 0.35, wide * 0.7, radius + 0.05), (front + 0.25, wide * 0.6, radius + 0.05), (0.06, 0.03), BOX, material=dark, mirror=True)
    low = radius * 0.85
    arch(kit, front, track - 0.02, radius, radius + 0.07, 0.13, 20, 150, 3, wings)
    kit.between((front - 0.87 * (radius + 0.07), track - 0.02, radius + 0.5 * (radius + 0.07)), (front - radius - 0.42, track - 0.02, low), (0.02, 0.13), BOX, material=wings, mirror=True)
    arch(kit, rear, track - 0.02, radius, radius + 0.07, 0.13, 0, 165, 3, wings)
    x0, x1 = rear + radius + 0.05, front - radius - 0.36
    kit.add(BOX, ((x0 + x1) / 2, track - 0.02, low), ((x1 - x0) / 2, 0.13, 0.025), material=wings, mirror=True)
    kit.add(BOX, ((x0 + x1) / 2, wide * 0.9, (low + floor) / 2 + 0.06), ((x1 - x0) / 2, 0.05, 0.12), material=wings, mirror=True)
    dash = front - rng.uniform(0.95, 1.25)
    nose = front + rng.uniform(-0.1, 0.12)
    section(kit, dash - 0.1, nose, (floor, belt, wide * 0.95), (floor, belt - rng.uniform(0.02, 0.12), wide * 0.55), coat)
    grille_front(kit, nose, floor - 0.02, belt + 0.0, wide * 0.56, metal)
    vents = kit.material(base=coat.first, pattern=RIBS, frequency=30, second=coat.first * 0.3)
    kit.add(BOX, ((dash + nose) / 2, wide * 0.765, (floor + belt) / 2 + 0.03), ((nose - dash) * 0.3, 0.012, 0.13), rotation=turn("z", -np.degrees(np.arctan2(wide * 0.4, nose - dash + 0.1))), material=vents, mirror=True)
    kind = rng.choice(["open", "saloon", "saloon", "coupe", "sports"])
    tail = rear - rng.uniform(0.1, 0.35)
    if kind in ("saloon", "coupe"):
        back = tail if kind == "saloon" else rear * 0.45
        slab(kit, floor, belt, (back, dash, wide), (back - 0.03, dash, wide), coat)
        roof = belt + rng.uniform(0.45, 0.6)
        greenhouse(kit, back, dash, belt, roof, wide * 1.03, rng.uniform(0.02, 0.14), rng.uniform(0.02, 0.2), coat, 1, wings, share=0.9)
        if kind == "coupe":
            section(kit, tail - 0.1, back + 0.1, (floor, belt - 0.3, wide * 0.8), (floor, belt, wide), coat)
        else:
            kit.add(BOX, (back + 0.1, wide * 0.9, belt + 0.2), (0.14, 0.06, 0.2), material=coat, mirror=True)
        if kit.chance(0.4):
            kit.between((dash - 0.05, -wide * 0.8, roof - 0.03), (dash - 0.05, wide * 0.8, roof - 0.03), (0.02, 0.14), BOX, material=coat)
    else:
        section(kit, tail, dash, (floor, belt - 0.1, 0.05), (floor, belt - 0.06, 0.05), coat, wide * 0.93, True)
        kit.add(BOX, ((tail + dash) / 2, 0, floor + 0.06), ((dash - tail) / 2, wide * 0.93, 0.06), material=dark)
        if kind == "sports":
            section(kit, tail - 0.35, rear * 0.55, (floor + 0.1, belt - 0.35, wide * 0.35), (floor, belt - 0.05, wide * 0.98), coat)
        else:
            kit.add(BOX, (tail, 0, (floor + belt) / 2 - 0.05), (0.06, wide * 0.95, (belt - floor) / 2 - 0.04), material=coat)
            seat(kit, rear + 0.1, 0, belt - 0.42, wide * 0.85, 0.5, cloth)
        seat(kit, dash - 0.65, 0, belt - 0.42, wide * 0.85, 0.5, cloth)
        steering(kit, dash - 0.25, wide * 0.4, belt + 0.06, dark)
        tall = rng.uniform(0.3, 0.42)
        slab(kit, belt - 0.03, belt + tall, (dash - 0.02, dash, wide * 0.85), (dash - 0.1, dash - 0.08, wide * 0.85), glazing(kit))
        kit.between((dash, wide * 0.87, belt - 0.05), (dash - 0.09, wide * 0.87, belt + tall), 0.018, material=metal, mirror=True)
        if kind == "open" and kit.chance(0.4):
            top = kit.material(base=rng.uniform(0.03, 0.4) * np.ones(3), pattern=CLOUDY)
            kit.add(BOX, ((tail + dash) / 2, 0, belt + tall + 0.04), ((dash - tail) / 2 + 0.05, wide * 0.95, 0.04), (0.96, 0.9), material=top)
            kit.add(BOX, (tail, 0, belt + tall / 2), (0.02, wide * 0.92, tall / 2 + 0.02), material=top)
            kit.between((rear * 0.3, wide * 0.93, belt - 0.1), (rear * 0.3, wide * 0.9, belt + tall), 0.018, material=dark, mirror=True)
        elif kind == "open":
            kit.add(CYL, (tail - 0.02, 0, belt - 0.03), (0.11, 0.1, wide * 0.92), rotation=ALONG_Y, material=kit.material(base=[0.05] * 3, pattern=CLOUDY))
    kit.add(CYL, (tail - (0.1 if kind != "coupe" else 0.12), 0, floor + 0.25), (radius * 0.9, radius * 0.9, 0.07), rotation=ALONG_X, material=tyre)
    kit.add(CYL, (tail - (0.13 if kind != "coupe" else 0.15), 0, floor + 0.25), (radius * 0.5, radius * 0.5, 0.07), rotation=ALONG_X, material=coat)
    kit.add(BALL, (nose - 0.02, wide * 0.8, belt - 0.1), (0.14, 0.13, 0.13), material=metal, mirror=True)
    kit.add(BALL, (nose + 0.06, wide * 0.8, belt - 0.1), (0.075, 0.11, 0.11), material=kit.material(base=[0.85, 0.85, 0.75], pattern=PLAIN), mirror=True)
    kit.between((nose - 0.02, -wide * 0.8, belt - 0.2), (nose - 0.02, wide * 0.8, belt - 0.2), 0.02, material=metal)
    kit.between((front + radius + 0.12, -track, radius), (front + radius + 0.12, track, radius), (0.035, 0.012), BOX, material=metal)
    kit.between((front, wide * 0.6, radius + 0.05), (front + radius + 0.12, wide * 0.6, radius), 0.022, BOX, material=dark, mirror=True)


def streamliner(kit):
    """A car of the late thirties and the forties: drop-shaped wings, a round hood with a grille, a sloping back."""
    rng = kit.rng
    coat, metal, dark, tyre = car_paint(kit), chrome(kit), kit.material(dark=True), rubber(kit)
    radius, front, rear = rng.uniform(0.34, 0.38), rng.uniform(1.25, 1.5), -rng.uniform(1.2, 1.4)
    wide, floor, belt, roof = rng.uniform(0.62, 0.7), 0.32, rng.uniform(1.0, 1.1), rng.uniform(1.55, 1.7)
    for x in (front, rear):
        rims(kit, x, wide + 0.18, radius, 0.09, tyre, metal)
    dash, nose = front - rng.uniform(0.8, 1.0), front + rng.uniform(0.45, 0.6)
    slab(kit, floor, belt, (rear - 0.25, dash + 0.1, wide), (rear - 0.1, dash, wide * 0.96), coat)
    section(kit, dash - 0.15, nose - 0.12, (floor + 0.05, belt + 0.02, wide * 0.88), (floor + 0.05, belt - 0.12, wide * 0.4), coat)
    kit.add(CYL, (0.5 * (dash + nose) - 0.12, 0, belt - 0.12), (0.2, wide * 0.6, (nose - dash) / 2), (0.6, 1), rotation=ALONG_X, material=coat)
    section(kit, nose - 0.2, nose, (floor + 0.05, belt - 0.12, wide * 0.42), (floor + 0.08, belt - 0.3, wide * 0.22), coat)
    bars = kit.material(base=metal.first, pattern=rng.choice([RIBS, BANDS]), frequency=35, second=[0.03] * 3)
    section(kit, nose - 0.05, nose + 0.02, (floor + 0.12, belt - 0.2, wide * 0.24), (floor + 0.14, belt - 0.34, wide * 0.16), bars)
    for x, ahead, behind in ((front, 0.55, 0.85), (rear, 0.62, 0.75)):
        kit.add(BALL, (x + 0.02, wide + 0.03, radius + 0.2), (ahead, 0.2, radius + 0.12), material=coat, mirror=True)
        kit.add(BALL, (x - behind + 0.45, wide + 0.0, radius + 0.05), (behind * 0.8, 0.17, radius * 0.7), material=coat, mirror=True)
    kit.add(CYL, (front, wide + 0.15, radius), (radius * 1.08, radius * 1.08, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
    kit.add(CYL, (rear, wide + 0.15, radius * 0.9), (radius * 1.05, radius * 1.05, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
    back = rear - rng.uniform(0.1, 0.35)
    two = kit.chance(0.4)
    kit.add(BALL, (rear - 0.05, 0, belt - 0.22), (0.6, wide * 0.92, belt - floor - 0.2), material=coat)
    if two:
        back = rear * 0.75
    greenhouse(kit, back, dash + 0.02, belt, roof, wide, rng.uniform(0.2, 0.32), rng.uniform(0.35, 0.75), coat, 2 if not two else 1, share=0.8)
    kit.add(BALL, ((back + dash) / 2 - 0.0, 0, roof - 0.06), ((dash - back) * 0.33, wide * 0.72, 0.12), material=coat)
    kit.add(BALL, (front + 0.28, wide * 0.92, belt - 0.2), (0.17, 0.12, 0.12), material=coat, mirror=True)
    kit.add(BALL, (front + 0.37, wide * 0.92, belt - 0.2), (0.1, 0.105, 0.105), material=kit.material(base=[0.85, 0.85, 0.75], pattern=PLAIN, gloss=0.6), mirror=True)
    for x in (nose + 0.06, rear - 0.68):
        kit.add(BOX, (x, 0, floor + 0.1), (0.05, wide + 0.1, 0.06), material=metal)
    kit.between((nose - 0.2, wide * 0.35, floor + 0.1), (nose + 0.06, wide * 0.35, floor + 0.1), 0.03, BOX, material=metal, mirror=True)
    kit.between((rear - 0.3, wide * 0.35, floor + 0.1), (rear - 0.68, wide * 0.35, floor + 0.1), 0.03, BOX, material=metal, mirror=True)
    kit.add(BOX, ((front + rear) / 2, wide + 0.05, floor), ((front - rear) / 2 - radius, 0.12, 0.03), material=dark, mirror=True)
    for x in (dash - 0.12, (dash + back) / 2):
        kit.add(BOX, (x, wide * 0.98, (floor + belt) / 2 + 0.05), (0.008, 0.015, (belt - floor) * 0.4), material=dark, mirror=True)


def fifties(kit):
    """A wide car of the fifties with tail fins, chrome, two tones and a wrapped screen; a saloon, a hardtop or open."""
    rng = kit.rng
    coat, metal, dark, tyre = car_paint(kit), chrome(kit), kit.material(dark=True), rubber(kit)
    second = car_paint(kit) if kit.chance(0.5) else coat
    half, wide, radius = rng.uniform(2.4, 2.75), rng.uniform(0.92, 1.0), rng.uniform(0.34, 0.37)
    floor, belt = 0.28, rng.uniform(0.9, 0.98)
    front, rear, dash, back = half * 0.6, -half * 0.55, half * rng.uniform(0.28, 0.34), -half * rng.uniform(0.3, 0.38)
    slab(kit, floor, belt, (-half + 0.1, half - 0.3, wide), (-half + 0.25, half - 0.35, wide * 0.95), coat)
    section(kit, half - 0.5, half, (floor, belt, wide * 0.98), (floor + 0.1, belt - 0.1, wide * 0.93), coat)
    section(kit, -half, -half + 0.4, (floor + 0.08, belt - 0.1, wide * 0.9), (floor, belt, wide * 0.98), coat)
    kit.add(CYL, (half * 0.62, 0, belt - 0.02), (0.1, wide * 0.65, half * 0.33), rotation=ALONG_X, material=coat)
    kit.add(CYL, (half * 0.62, wide * 0.83, belt - 0.04), (0.11, 0.12, half * 0.39), (0.9, 1), rotation=ALONG_X, material=coat, mirror=True)
    fin = rng.uniform(0.12, 0.35)
    kit.add(BOX, (-half * 0.62, wide * 0.92, belt - 0.05), (0.06, 0.06, half * 0.4), ((0.05 + fin) / 0.06, 0.7), (-fin, 0), turn("y", -90) @ np.diag([-1.0, -1, 1]), material=second, mirror=True)
    tail = kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN, gloss=0.6)
    for k in range(int(rng.integers(1, 3))):
        kit.add(BALL, (-half - 0.0, wide * 0.9, belt - 0.08 - 0.2 * k + fin * 0.5), (0.12, 0.07, 0.08), material=tail, mirror=True)
    if second is not coat:
        kit.add(BOX, (-half * 0.3, wide * 0.995, (floor + belt) / 2 + 0.1), (half * 0.62, 0.02, 0.14), (0.85, 1), material=second, mirror=True)
    kit.add(BOX, (0, wide * 1.0, (floor + belt) / 2 + 0.02), (half * 0.9, 0.02, 0.022), material=metal, mirror=True)
    kit.add(BOX, (0, wide * 0.99, floor + 0.02), (half * 0.38, 0.025, 0.035), material=metal, mirror=True)
    if kit.chance(0.7):
        roof = belt + rng.uniform(0.42, 0.52)
        greenhouse(kit, back, dash, belt, roof, wide, rng.uniform(0.3, 0.45), rng.uniform(0.25, 0.6), metal if kit.chance(0.3) else coat, int(rng.integers(0, 2)), second, 0.78)
    else:
        cloth = hide(kit)
        kit.add(BOX, ((back + dash) / 2, 0, belt - 0.01), ((dash - back) / 2, wide * 0.8, 0.02), material=dark)
        for x in (back * 0.15, back * 0.9):
            kit.add(BOX, (x, 0, belt + 0.1), (0.1, wide * 0.75, 0.17), (0.7, 0.95), (-0.06, 0), material=cloth)
        steering(kit, dash - 0.4, wide * 0.4, belt + 0.14, dark, 0.2)
        slab(kit, belt - 0.03, belt + 0.36, (dash - 0.03, dash, wide * 0.85), (dash - 0.28, dash - 0.26, wide * 0.75), glazing(kit))
        kit.between((dash, wide * 0.87, belt - 0.03), (dash - 0.27, wide * 0.77, belt + 0.37), 0.022, material=metal, mirror=True)
        kit.add(BOX, (back - 0.1, 0, belt + 0.04), (0.2, wide * 0.75, 0.06), (0.8, 0.95), material=kit.material(base=[0.6] * 3))
    for x in (front, rear):
        kit.add(CYL, (x, wide * 0.92, radius + 0.04), (radius * 1.13, radius * 1.13, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(CYL, (x, wide * 0.92, radius), (radius, radius, 0.12), rotation=ALONG_Y, material=tyre, mirror=True)
        kit.add(CYL, (x, wide * 0.92, radius), (radius * 0.8, radius * 0.8, 0.13), rotation=ALONG_Y, material=kit.material(base=[0.85, 0.84, 0.8], pattern=PLAIN), mirror=True)
        kit.add(CYL, (x, wide * 0.92, radius), (radius * 0.55, radius * 0.55, 0.14), rotation=ALONG_Y, material=metal, mirror=True)
    kit.add(BOX, (half + 0.0, 0, belt - 0.32), (0.03, wide * 0.7, 0.13), material=kit.material(base=metal.first, pattern=RIBS, frequency=35, second=[0.03] * 3))
    for x in (half + 0.06, -half - 0.06):
        kit.add(BOX, (x, 0, floor + 0.08), (0.09, wide * 0.99, 0.09), (0.9, 0.98), material=metal)
    for y in (0.72, 0.5)[: int(rng.integers(1, 3))]:
        kit.add(BALL, (half - 0.0, wide * y + 0.08, belt - 0.2), (0.06, 0.1, 0.1), material=kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN, gloss=0.6), mirror=True)
    plates(kit, half + 0.15, -half - 0.15, floor + 0.1)


def beetle(kit):
    """A small round car: domed roof and back, round hood, separate round wings, running boards."""
    rng = kit.rng
    coat, metal, dark, tyre = car_paint(kit), chrome(kit), kit.material(dark=True), rubber(kit)
    radius, front, rear, wide = rng.uniform(0.3, 0.34), rng.uniform(1.1, 1.25), -rng.uniform(1.1, 1.25), rng.uniform(0.58, 0.65)
    floor, belt, roof = 0.26, rng.uniform(0.88, 0.95), rng.uniform(1.42, 1.52)
    slab(kit, floor, belt, (rear - 0.2, front * 0.5, wide), (rear * 0.95, front * 0.45, wide * 0.96), coat)
    kit.add(BALL, (front * 0.62, 0, belt - 0.36), (0.95, wide * 0.85, 0.38), material=coat)
    kit.add(BALL, (rear * 0.75, 0, belt - 0.28), (0.85, wide * 0.92, 0.42), material=coat)
    back, dash = rear * rng.uniform(0.72, 0.85), front * rng.uniform(0.36, 0.45)
    greenhouse(kit, back, dash, belt, roof - 0.06, wide * 1.02, 0.26, rng.uniform(0.45, 0.6), coat, 1, share=0.74)
    kit.add(BALL, ((back + 0.5 + dash - 0.26) / 2, 0, roof - 0.16), ((dash - back - 0.7) * 0.72, wide * 0.74, 0.17), material=coat)
    for x in (front, rear):
        kit.add(BALL, (x - 0.02, wide + 0.06, radius + 0.1), (radius * 1.65, 0.2, radius * 1.25), material=coat, mirror=True)
        kit.add(CYL, (x, wide + 0.13, radius * 0.95), (radius * 1.08, radius * 1.08, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
        rims(kit, x, wide + 0.15, radius, 0.1, tyre, metal)
    kit.add(BOX, (0, wide + 0.08, floor), (front - radius, 0.11, 0.03), material=dark, mirror=True)
    white = kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN, gloss=0.6)
    kit.add(BALL, (front + 0.34, wide + 0.02, belt - 0.28), (0.13, 0.11, 0.12), material=metal, mirror=True)
    kit.add(BALL, (front + 0.39, wide + 0.02, belt - 0.28), (0.1, 0.1, 0.11), material=white, mirror=True)
    kit.add(BALL, (rear - 0.4, wide + 0.02, belt - 0.33), (0.08, 0.06, 0.1), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN), mirror=True)
    for x, way in ((front + 0.58, -1), (rear - 0.62, 1)):
        kit.add(BOX, (x, 0, floor + 0.1), (0.04, wide + 0.1, 0.05), material=metal)
        kit.between((x, wide * 0.4, floor + 0.1), (x + way * 0.35, wide * 0.4, floor + 0.15), 0.03, BOX, material=metal, mirror=True)
    for x in (dash - 0.08, -0.4):
        kit.add(BOX, (x, wide * 0.98, (floor + belt) / 2 + 0.05), (0.008, 0.015, 0.27), material=dark, mirror=True)
    kit.add(BOX, (-0.3, wide * 1.0, belt - 0.12), (0.07, 0.02, 0.015), material=metal, mirror=True)
    plates(kit, front + 0.63, rear - 0.66, floor + 0.12)
    if kit.chance(0.3):
        kit.add(BOX, (-0.25, 0, roof + 0.08), (0.45, wide * 0.6, 0.012), material=metal, cut=(BARS, 9, 0.3))
        kit.between((-0.25, wide * 0.5, roof - 0.1), (-0.25, wide * 0.55, roof + 0.08), 0.015, material=metal, mirror=True)


def old_van(kit):
    """A van of the fifties with a divided screen and two tones, or a delivery van or lorry of the twenties with a hood."""
    rng = kit.rng
    coat, second, metal, dark, tyre = car_paint(kit), car_paint(kit), chrome(kit), kit.material(dark=True), rubber(kit)
    if kit.chance(0.5):
        half, wide, radius = rng.uniform(1.9, 2.3), rng.uniform(0.8, 0.88), rng.uniform(0.31, 0.35)
        floor, belt, roof = 0.32, rng.uniform(1.05, 1.15), rng.uniform(1.85, 2.0)
        slab(kit, floor, belt, (-half, half, wide), (-half, half - 0.06, wide * 0.99), coat)
        slab(kit, belt, roof - 0.12, (-half, half - 0.06, wide * 0.99), (-half + 0.12, half - 0.36, wide * 0.88), second)
        kit.add(CYL, (-0.12, 0, roof - 0.13), (0.14, wide * 0.88, half - 0.22), rotation=ALONG_X, material=second)
        kit.add(BALL, (half - 0.12, 0, (floor + belt) / 2), (0.24, wide * 0.97, (belt - floor) * 0.55), material=coat)
        z0, z1 = belt + 0.1, roof - 0.22
        for side in (-1, 1):
            slab(kit, z0, z1, (half - 0.25, half - 0.07, wide * 0.4), (half - 0.4, half - 0.26, wide * 0.38), glazing(kit), side * wide * 0.43)
        count = int(rng.integers(1, 5))
        long = (2 * half - 0.6) / max(count, 3)
        for k in range(count):
            x = half - 0.55 - long * (k + 0.5)
            slab(kit, z0, z1, (x - long * 0.42, x + long * 0.42, wide * 0.985), (x - long * 0.42, x + long * 0.42, wide * 0.905), glazing(kit))
        slab(kit, z0, z1 - 0.05, (-half - 0.01, -half + 0.2, wide * 0.6), (-half + 0.09, -half + 0.3, wide * 0.55), glazing(kit))
        kit.add(BOX, (0, 0, belt), (half * 1.0, wide * 1.005, 0.025), material=kit.material(base=[0.8] * 3, pattern=PLAIN))
        for x in (half * 0.55, -half * 0.58):
            kit.add(CYL, (x, wide * 0.94, radius + 0.05), (radius * 1.15, radius * 1.15, 0.06), rotation=ALONG_Y, material=dark, mirror=True)
            rims(kit, x, wide * 0.92, radius, 0.1, tyre, metal)
        kit.add(BALL, (half + 0.02, wide * 0.68, belt - 0.25), (0.09, 0.12, 0.12), material=metal, mirror=True)
        kit.add(BALL, (half + 0.05, wide * 0.68, belt - 0.25), (0.08, 0.1, 0.1), material=kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN), mirror=True)
        kit.add(CYL, (half + 0.08, 0, belt - 0.12), (0.15, 0.15, 0.05), rotation=ALONG_X, material=metal)
        for x in (half + 0.14, -half - 0.04):
            kit.add(BOX, (x, 0, floor + 0.08), (0.04, wide, 0.07), material=metal)
        kit.add(BOX, (-half - 0.01, wide * 0.85, belt - 0.2), (0.03, 0.05, 0.08), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN), mirror=True)
        for x in (half * 0.5, half * 0.1, -half * 0.3):
            kit.add(BOX, (x, wide, (floor + belt) / 2), (0.008, 0.01, 0.33), material=dark, mirror=True)
        plates(kit, half + 0.19, -half - 0.07, floor + 0.1)
        return
    radius, front, rear = rng.uniform(0.38, 0.44), rng.uniform(1.3, 1.5), -rng.uniform(1.1, 1.5)
    wide, track, floor, belt = rng.uniform(0.6, 0.7), 0.75, 0.6, 1.15
    for x in (front, rear):
        wired(kit, x, track, radius, 0.07, tyre, second, 12, 0.3)
        kit.between((x, -track, radius), (x, track, radius), 0.04, material=dark)
        arch(kit, x, track - 0.02, radius, radius + 0.08, 0.14, 15, 160, 3, dark)
    kit.add(BOX, (0, 0, floor - 0.08), (front + 0.1, wide * 0.6, 0.08), material=dark)
    dash, back = front - 0.85, rear - rng.uniform(0.4, 0.7)
    section(kit, dash - 0.1, front, (floor - 0.05, belt, wide * 0.7), (floor - 0.05, belt - 0.06, wide * 0.5), coat)
    grille_front(kit, front + 0.02, floor - 0.1, belt, wide * 0.5, metal)
    roof = rng.uniform(1.95, 2.15)
    cab = dash - 0.75
    slab(kit, floor, belt, (cab, dash, wide), (cab, dash, wide), coat)
    greenhouse(kit, cab, dash, belt, roof - 0.05, wide * 1.05, 0.03, 0.01, coat, 0, dark, 0.97)
    high = rng.uniform(0.5, 0.75)
    if kit.chance(0.6):
        kit.add(BOX, ((back + cab) / 2, 0, floor + 0.08 + high), ((cab - back) / 2 + 0.02, wide * 1.12, high), (0.98, 0.95), material=second)
        kit.add(CYL, ((back + cab) / 2, 0, floor + 0.06 + 2 * high), (0.1, wide * 1.06, (cab - back) / 2), rotation=ALONG_X, material=coat if kit.chance(0.5) else second)
        sign = kit.material(base=second.first, pattern=WRITING, frequency=10, second=[0.85, 0.75, 0.4])
        kit.add(BOX, ((back + cab) / 2, wide * 1.1, floor + high), ((cab - back) * 0.4, 0.015, high * 0.45), material=sign, mirror=True)
        kit.add(BOX, (back - 0.01, 0, floor + high), (0.015, 0.012, high * 0.85), material=dark)
    else:
        planks = kit.material(base=timber(kit).first, pattern=PLANKS, frequency=10)
        kit.add(BOX, ((back + cab) / 2, 0, floor + 0.06), ((cab - back) / 2, wide * 1.15, 0.06), material=planks)
        kit.add(BOX, ((back + cab) / 2, wide * 1.13, floor + 0.3), ((cab - back) / 2, 0.03, 0.22), material=planks, mirror=True)
        for x in (back, cab - 0.03):
            kit.add(BOX, (x, 0, floor + 0.3), (0.03, wide * 1.13, 0.22), material=planks)
        for _ in range(int(rng.integers(0, 5))):
            size = rng.uniform(0.15, 0.26)
            kit.add(rng.choice([BOX, CYL]), (rng.uniform(back + 0.35, cab - 0.35), rng.uniform(-0.5, 0.5) * wide, floor + 0.1 + size), (size, size, size), material=timber(kit))
    kit.add(BOX, ((dash + cab) / 2, track - 0.05, radius * 0.9), (0.62, 0.13, 0.02), material=dark, mirror=True)
    kit.between(((dash + cab) / 2, wide * 0.6, floor - 0.08), ((dash + cab) / 2, track - 0.05, radius * 0.9), 0.025, material=dark, mirror=True)
    kit.add(BALL, (front - 0.02, wide * 0.85, belt - 0.12), (0.12, 0.12, 0.12), material=metal, mirror=True)
    kit.between((front - 0.02, wide * 0.4, belt - 0.2), (front - 0.02, wide * 0.85, belt - 0.15), 0.02, material=metal, mirror=True)
    kit.add(BOX, (front + radius + 0.1, 0, radius + 0.05), (0.03, track, 0.05), material=dark)
    kit.between((front - 0.1, wide * 0.5, floor - 0.1), (front + radius + 0.1, wide * 0.5, radius + 0.05), 0.03, BOX, material=dark, mirror=True)


def old_bus(kit):
    """Buses of the thirties to the fifties: rounded, with a hood or a half cab, one deck or two, some with an open top or stairs."""
    rng = kit.rng
    coat, second, metal, dark, tyre = car_paint(kit), car_paint(kit), chrome(kit), kit.material(dark=True), rubber(kit)
    half, wide, radius = rng.uniform(2.6, 3.4), rng.uniform(0.95, 1.1), rng.uniform(0.42, 0.48)
    floor, belt, tall = 0.45, rng.uniform(1.3, 1.45), rng.uniform(0.6, 0.7)
    decks = 2 if kit.chance(0.4) else 1
    form = rng.choice(["half", "hood", "flat"])
    body = half - (0.95 if form != "flat" else 0.0)
    roof = belt + tall + 0.15
    slab(kit, floor, belt, (-half, body, wide), (-half, body, wide), coat)
    slab(kit, belt, roof, (-half, body, wide), (-half + 0.06, body - 0.08, wide * 0.95), second)
    levels = [belt]
    if decks == 2:
        levels.append(roof + 0.55)
        slab(kit, roof, roof + 0.55, (-half, body, wide * 0.97), (-half, body, wide * 0.97), coat)
        if kit.chance(0.75):
            slab(kit, roof + 0.55, roof + 1.25, (-half, body, wide * 0.97), (-half + 0.1, body - 0.12, wide * 0.92), second)
            roof += 1.25
        else:
            levels.pop()
            roof += 0.5
            for x in np.linspace(-half + 0.4, body - 0.4, 4):
                kit.add(BOX, (x, 0, roof + 0.15), (0.07, wide * 0.8, 0.2), material=timber(kit))
    kit.add(CYL, ((body - half) / 2, 0, roof - 0.02), (0.2, wide * 0.9, (body + half) / 2 - 0.08), rotation=ALONG_X, material=coat if kit.chance(0.5) else second)
    count = int(rng.integers(4, 8))
    for level in levels:
        for k in range(count):
            x = -half + 0.15 + (body + half - 0.3) * (k + 0.5) / count
            share = (body + half) * 0.41 / count
            slab(kit, level + 0.06, level + tall, (x - share, x + share, wide * 1.005), (x - share, x + share, wide * 0.965), glazing(kit))
        slab(kit, level + 0.08, level + tall, (-half - 0.01, body + 0.012, wide * 0.8), (-half + 0.04, body - 0.05, wide * 0.75), glazing(kit))
    kit.add(BOX, ((body - half) / 2, 0, belt - 0.06), ((body + half) / 2 + 0.01, wide * 1.01, 0.03), material=metal)
    nose = half
    if form == "flat":
        kit.add(BALL, (half - 0.08, 0, floor + 0.45), (0.25, wide * 0.96, 0.55), material=coat)
        nose = half + 0.12
        kit.add(BOX, (nose + 0.02, 0, floor + 0.4), (0.05, 0.35, 0.2), material=kit.material(base=metal.first, pattern=RIBS, frequency=30, second=[0.03] * 3))
    else:
        side = 0 if form == "hood" else -wide * 0.42
        section(kit, body - 0.1, half, (floor, belt - 0.05, wide * (0.6 if side == 0 else 0.45)), (floor, belt - 0.15, 0.32), coat, side)
        section(kit, half - 0.03, half + 0.05, (floor - 0.02, belt - 0.13, 0.34), (floor, belt - 0.15, 0.32), metal, side)
        kit.add(BOX, (half + 0.055, side, (floor + belt) / 2 - 0.08), (0.01, 0.25, 0.33), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=35, second=metal.first))
        if form == "half":
            slab(kit, floor, belt, (body - 0.1, half - 0.25, wide * 0.42), (body - 0.1, half - 0.28, wide * 0.42), coat, wide * 0.55)
            slab(kit, belt, belt + tall + 0.12, (body - 0.1, half - 0.28, wide * 0.42), (body - 0.1, half - 0.4, wide * 0.4), second, wide * 0.55)
            slab(kit, belt + 0.06, belt + tall, (body + 0.05, half - 0.27, wide * 0.36), (body + 0.05, half - 0.37, wide * 0.34), glazing(kit), wide * 0.55)
            slab(kit, belt + 0.06, belt + tall, (body + 0.05, half - 0.4, wide * 0.43), (body + 0.05, half - 0.48, wide * 0.41), glazing(kit), wide * 0.55)
    for x in (half - 0.62 if form != "flat" else half * 0.62, -half * 0.6):
        arch(kit, x, wide * 0.9, radius, radius + 0.08, 0.16, 10, 170, 3, dark)
        rims(kit, x, wide * 0.9, radius, 0.13, tyre, second)
    kit.add(BALL, (nose + 0.05, wide * 0.6, floor + 0.45), (0.1, 0.12, 0.12), material=metal, mirror=True)
    kit.between((nose - 0.15, wide * 0.3, floor + 0.3), (nose + 0.02, wide * 0.6, floor + 0.4), 0.025, material=metal, mirror=True)
    kit.add(BOX, (nose + 0.1, 0, floor - 0.02), (0.04, wide, 0.07), material=metal)
    kit.add(BOX, (nose - 0.1, 0, floor), (0.2, wide * 0.4, 0.05), material=dark)
    sign = kit.material(base=[0.03] * 3, pattern=WRITING, frequency=14, second=[0.9, 0.85, 0.6])
    kit.add(BOX, (body + 0.01, 0, belt + tall + 0.1), (0.03, 0.45, 0.09), material=sign)
    if kit.chance(0.4):
        kit.add(BOX, (-half * 0.15, wide * 0.99, (belt + floor) / 2 + (1.3 if decks == 2 else 0.1)), (half * 0.5, 0.02, 0.17), material=kit.material(pattern=WRITING, frequency=10), mirror=True)


def coach(kit):
    """Closed horse-drawn coaches: a curved body hung between high wheels, a driver's seat, lamps, doors; a state coach or a mail coach."""
    rng = kit.rng
    coat, second, dark = car_paint(kit), car_paint(kit), kit.material(dark=True)
    gold = kit.material(base=[0.65, 0.45, 0.12], pattern=PLAIN, gloss=0.6) if kit.chance(0.6) else second
    tyre = kit.material(base=[0.08] * 3, pattern=PLAIN)
    big, small = rng.uniform(0.58, 0.7), rng.uniform(0.4, 0.52)
    front, rear, track, wide = rng.uniform(1.15, 1.35), -rng.uniform(1.0, 1.25), rng.uniform(0.72, 0.8), rng.uniform(0.5, 0.58)
    wheel_paint = gold if kit.chance(0.6) else coat
    wired(kit, front, track, small, 0.04, tyre, wheel_paint, int(rng.choice([10, 12])), 0.25)
    wired(kit, rear, track, big, 0.04, tyre, wheel_paint, int(rng.choice([12, 14])), 0.25)
    for x, r in ((front, small), (rear, big)):
        kit.between((x, -track - 0.06, r), (x, track + 0.06, r), 0.035, material=wheel_paint)
        kit.between((x, 0, r), (x, 0, 0.75), 0.06, BOX, material=wheel_paint)
    kit.between((rear - 0.2, 0.3, 0.62), (front + 0.15, 0.25, 0.68), (0.045, 0.035), BOX, material=wheel_paint, mirror=True)
    low, belt, roof = rng.uniform(0.65, 0.75), rng.uniform(1.15, 1.25), rng.uniform(1.8, 2.0)
    back, ahead = rear * rng.uniform(0.62, 0.75), front * rng.uniform(0.5, 0.62)
    slab(kit, low, belt, (back * 0.7, ahead * 0.75, wide * 0.8), (back, ahead, wide), coat)
    slab(kit, belt, roof, (back, ahead, wide), (back * 1.06, ahead * 1.06, wide * 1.04), coat)
    slab(kit, belt + 0.1, roof - 0.12, (back * 0.35, ahead * 0.35, wide * 1.015), (back * 0.35, ahead * 0.35, wide * 1.035), glazing(kit))
    for x in (back * 0.72, ahead * 0.72):
        slab(kit, belt + 0.1, roof - 0.14, (x - 0.13, x + 0.13, wide * 1.012), (x - 0.13, x + 0.13, wide * 1.032), glazing(kit) if kit.chance(0.6) else second)
    slab(kit, belt + 0.1, roof - 0.12, (back * 0.9, ahead * 1.01, wide * 0.8), (back * 0.9, ahead * 1.065, wide * 0.82), glazing(kit))
    kit.add(BOX, ((back + ahead) / 2, 0, roof + 0.03), ((ahead - back) / 2 * 1.1, wide * 1.1, 0.05), (0.92, 0.88), material=dark if kit.chance(0.5) else gold)
    kit.add(BOX, ((back + ahead) / 2, 0, belt), ((ahead - back) / 2 * 1.01, wide * 1.02, 0.025), material=gold)
    for x in (back * 0.42, ahead * 0.42):
        kit.add(BOX, (x, wide * 0.96, (low + belt) / 2 + 0.06), (0.012, 0.04, (belt - low) * 0.42), material=gold, mirror=True)
    kit.add(BOX, (0, wide * 0.95, low - 0.1), (0.14, 0.1, 0.02), material=dark, mirror=True)
    kit.between((0, wide * 0.75, low + 0.05), (0, wide * 0.95, low - 0.1), 0.02, material=dark, mirror=True)
    for x, y in ((back * 0.9, rear), (ahead * 0.9, front)):
        kit.between((x, 0.3, low + 0.12), (y, 0.3, 0.68), 0.035, material=dark, mirror=True)
    box = ahead + 0.32
    section(kit, ahead - 0.05, box + 0.22, (0.8, belt + 0.06, wide * 0.75), (0.85, belt + 0.0, wide * 0.72), second)
    kit.between((box + 0.15, 0, 0.9), (front + 0.05, 0, 0.6), 0.1, BOX, material=dark)
    seat(kit, box, 0, belt + 0.05, wide * 0.72, 0.28, hide(kit))
    kit.between((box + 0.2, 0, 0.95), (box + 0.5, 0, 0.98 + 0.12), (0.02, wide * 0.65), BOX, material=dark)
    kit.add(CYL, (ahead + 0.02, wide * 1.18, belt + 0.25), (0.07, 0.07, 0.12), (1.2, 1), material=gold, mirror=True)
    kit.between((ahead - 0.05, wide * 0.95, belt + 0.15), (ahead + 0.02, wide * 1.18, belt + 0.2), 0.02, material=gold, mirror=True)
    pole = rng.uniform(1.2, 2.0)
    kit.between((front, 0, small), (front + pole, 0, small + 0.15), 0.035, material=wheel_paint)
    kit.between((front + 0.35, -0.5, small + 0.06), (front + 0.35, 0.5, small + 0.06), 0.025, material=wheel_paint)
    if kit.chance(0.5):
        section(kit, rear - 0.25, back, (0.7, belt - 0.1, wide * 0.75), (0.7, belt, wide * 0.8), dark)
    else:
        kit.add(BOX, (rear - 0.1, 0, 0.72), (0.25, wide * 0.6, 0.03), material=dark)
    if kit.chance(0.4):
        for _ in range(int(rng.integers(1, 4))):
            kit.add(BOX, (rng.uniform(back, ahead) * 0.6, rng.uniform(-0.15, 0.15), roof + 0.18), (rng.uniform(0.15, 0.35), 0.22, 0.13), material=timber(kit))
    elif kit.chance(0.4):
        for x in (back, ahead):
            kit.loft((x, wide, roof + 0.05), [(0, 0.05), (0.06, 0.03), (0.12, 0.06), (0.2, 0.01)], gold)
            kit.loft((x, -wide, roof + 0.05), [(0, 0.05), (0.06, 0.03), (0.12, 0.06), (0.2, 0.01)], gold)


def buggy(kit):
    """Open carriages: a light buggy with two or four wheels, shafts and a folding hood, a landau, a dog cart, a hansom."""
    rng = kit.rng
    coat, dark, cloth, wood = car_paint(kit), kit.material(dark=True), hide(kit), timber(kit)
    spoke = wood if kit.chance(0.4) else car_paint(kit)
    tyre = kit.material(base=[0.07] * 3, pattern=PLAIN)
    kind = rng.choice(["buggy", "landau", "gig"])
    wide = rng.uniform(0.42, 0.52)
    if kind == "gig":
        radius = rng.uniform(0.55, 0.7)
        wired(kit, 0, wide + 0.14, radius, 0.03, tyre, spoke, 12, 0.25)
        kit.between((0, -wide - 0.2, radius), (0, wide + 0.2, radius), 0.03, material=spoke)
        floor, back, ahead, reach = radius + 0.12, -0.45, 0.55, 2.1
        kit.between((-0.55, wide * 0.9, floor - 0.03), (reach, wide * 0.6, floor - 0.15), 0.03, material=wood, mirror=True)
    else:
        front, rear, small, big = rng.uniform(0.75, 1.0), -rng.uniform(0.75, 1.0), rng.uniform(0.42, 0.5), rng.uniform(0.5, 0.6)
        for x, r in ((front, small), (rear, big)):
            wired(kit, x, wide + 0.16, r, 0.03, tyre, spoke, 12, 0.25)
            kit.between((x, -wide - 0.2, r), (x, wide + 0.2, r), 0.025, material=spoke)
            kit.between((x - 0.3, 0, r + 0.12), (x + 0.3, 0, r + 0.12), (0.03, 0.04), BOX, material=dark)
            kit.between((x, 0, r), (x, 0, big + 0.22), 0.05, BOX, material=dark)
        kit.between((front, 0, small + 0.05), (rear, 0, big + 0.05), 0.035, BOX, material=spoke)
        floor, back, ahead, reach = big + 0.2, rear - 0.05, front + 0.1, front + 1.5
        if kit.chance(0.5):
            kit.between((front, wide * 0.7, small), (reach, wide * 0.55, small + 0.3), 0.025, material=wood, mirror=True)
        else:
            kit.between((front, 0, small), (reach, 0, small + 0.1), 0.03, material=wood)
        kit.between((front, -wide * 0.75, small), (front, wide * 0.75, small), 0.03, material=wood)
    kit.add(BOX, ((back + ahead) / 2, 0, floor), ((ahead - back) / 2, wide * 0.9, 0.04), material=coat)
    main = -0.2 if kind != "landau" else back * 0.62
    if kind == "landau":
        section(kit, back, back * 0.2, (floor + 0.05, floor + 0.6, wide), (floor - 0.12, floor + 0.28, wide), coat)
        section(kit, back * 0.2, ahead * 0.4, (floor - 0.12, floor + 0.28, wide), (floor, floor + 0.5, wide), coat)
        seat(kit, back * 0.58, 0, floor + 0.42, wide * 0.85, 0.4, cloth)
        kit.add(BOX, (ahead * 0.3, 0, floor + 0.42), (0.2, wide * 0.85, 0.1), material=cloth)
        section(kit, ahead * 0.4, ahead + 0.1, (floor, floor + 0.62, wide * 0.8), (floor + 0.1, floor + 0.62, wide * 0.75), coat)
        seat(kit, ahead * 0.8, 0, floor + 0.62, wide * 0.7, 0.3, cloth)
    else:
        kit.add(BOX, (main, 0, floor + 0.16), (0.26, wide * 0.9, 0.15), (1.05, 1.05), material=coat)
        seat(kit, main, 0, floor + 0.3, wide * 0.88, rng.uniform(0.35, 0.5), cloth)
        kit.add(BOX, (main - 0.06, wide * 0.92, floor + 0.42), (0.22, 0.025, 0.14), (0.7, 1), (-0.05, 0), material=coat, mirror=True)
        kit.add(BOX, ((back + ahead) / 2, wide * 0.9, floor + 0.1), ((ahead - back) / 2, 0.02, 0.1), material=coat, mirror=True)
    kit.between((ahead, 0, floor), (ahead + 0.18, 0, floor + 0.38), (0.018, wide * 0.8), BOX, material=dark)
    if kit.chance(0.7):
        canvas = kit.material(base=rng.choice([0.02, 0.05, 0.35]) * np.ones(3), pattern=rng.choice([PLAIN, CLOUDY]))
        hood(kit, np.array([main - 0.15, 0, floor + 0.6]), rng.uniform(0.62, 0.75), wide, (-10, 35, 75, 110, 140) if kit.chance(0.7) else (-20, 10, 40), canvas, dark)
    for x in ((front, rear) if kind != "gig" else (0,)):
        if kit.chance(0.5):
            r = big if x <= 0 and kind != "gig" else (radius if kind == "gig" else small)
            arch(kit, x, wide + 0.16, r, r + 0.05, 0.07, 40, 150, 3, dark)
            kit.between((x, wide * 0.85, floor), (x, wide + 0.18, 2 * r + 0.05), 0.02, material=dark, mirror=True)
    brass = kit.material(base=[0.6, 0.42, 0.12], pattern=PLAIN, gloss=0.6)
    if kit.chance(0.6):
        kit.add(CYL, (main + 0.3, wide * 1.1, floor + 0.38), (0.055, 0.055, 0.1), material=brass, mirror=True)
        kit.between((main + 0.3, wide * 0.85, floor + 0.1), (main + 0.3, wide * 1.1, floor + 0.3), 0.018, material=brass, mirror=True)
    kit.between((ahead - 0.1, wide * 0.8, floor), (ahead - 0.15, wide * 1.05, floor - 0.3), 0.016, material=dark, mirror=True)
    kit.add(BOX, (ahead - 0.15, wide * 1.05, floor - 0.3), (0.08, 0.06, 0.012), material=dark, mirror=True)
