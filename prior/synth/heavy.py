"""Makers of working machines: bulldozers, rollers, dumpers, loaders, harvesters, cranes, transporters, caravans."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, RUNGS, SPOKES, TUBE
from .machines import machine_paint
from .materials import BANDS, CLOUDY, PLAIN, PLANKS, RIBS, STREAKS, STRIPES, WRITING
from .roadcraft import FLIP, RING, arch, car_paint, chrome, hide, lights, rims, rubber, seat, section, slab, steering
from .wheeled import glazing

# Heavy machines.


def heavy(kit):
    """Bulldozers, rollers, mine dump trucks, loaders, graders, combines, tractors at work, telehandlers, mobile cranes, big lorries, campers, airport and articulated vehicles."""
    makers = [bulldozer, roller, mine_dump, loader, grader, combine, farm_tractor, farm_tractor, telehandler, mobile_crane, mobile_crane]
    makers += [car_transporter, log_lorry, camper, caravan, airport_tug, airport_stairs, articulated_bus]
    kit.rng.choice(makers)(kit)


def loud(kit):
    return machine_paint(kit)._replace(pattern=int(kit.rng.choice([PLAIN, PLAIN, STREAKS])))


def glass_cab(kit, x, y, z, long, wide, tall, coat, dark, lean=0.0):
    """A cab of panes between posts under a roof, on z."""
    slab(kit, z, z + tall * 0.3, (x - long, x + long, wide), (x - long, x + long, wide), coat, y)
    slab(kit, z + tall * 0.28, z + tall * 0.97, (x - long * 0.97, x + long * 0.97, wide * 0.97), (x - long * 0.93, x + long * 0.95 - lean, wide * 0.9), glazing(kit), y)
    slab(kit, z + tall * 0.94, z + tall * 1.03, (x - long * 1.05, x + long * 1.08 - lean, wide * 1.0), (x - long, x + long - lean, wide * 0.92), coat, y)
    for side in (-1, 1):
        for end, top in ((x - long * 0.97, x - long * 0.93), (x, x), (x + long * 0.97, x + long * 0.95 - lean)):
            kit.between((end, y + side * wide * 0.96, z + tall * 0.2), (top, y + side * wide * 0.9, z + tall * 0.96), (0.035, 0.03), BOX, material=dark)


def crawler_track(kit, long, y, radius, half, dark, steel):
    """Tracks of two rounded ends and a run between, with the wheels inside."""
    shoes = kit.material(base=dark.first, pattern=RIBS, frequency=25, second=steel.first)
    for x in (-long, long):
        kit.add(CYL, (x, y, radius), (radius, radius, half), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(CYL, (x, y, radius), (radius * 0.65, radius * 0.65, half * 1.12), rotation=ALONG_Y, material=steel, mirror=True)
    for z in (0.06, 2 * radius - 0.06):
        kit.add(BOX, (0, y, z), (long, half, 0.06), material=shoes, mirror=True)
    kit.add(BOX, (0, y, radius), (long * 0.95, half * 0.9, radius * 0.75), material=steel, mirror=True)


def bulldozer(kit):
    rng = kit.rng
    coat, dark, steel = loud(kit), kit.material(dark=True), kit.material(base=rng.uniform(0.1, 0.4) * np.ones(3), pattern=STREAKS)
    long, radius, wide = rng.uniform(0.95, 1.2), rng.uniform(0.38, 0.46), rng.uniform(0.75, 0.9)
    crawler_track(kit, long, wide, radius, rng.uniform(0.2, 0.28), dark, steel)
    deck = 2 * radius + 0.08
    kit.add(BOX, (-0.05, 0, radius + 0.15), (long * 1.1, wide * 0.7, radius * 0.8), material=dark)
    section(kit, 0.05, long + 0.35, (radius + 0.1, deck + 0.62, 0.42), (radius + 0.15, deck + 0.45, 0.36), coat)
    kit.add(BOX, (long + 0.36, 0, deck + 0.02), (0.015, 0.3, 0.34), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=35, second=coat.first))
    kit.between((long * 0.65, 0.18, deck + 0.4), (long * 0.65, 0.18, deck + rng.uniform(0.9, 1.2)), 0.05, material=dark)
    kit.add(BOX, (-0.35, wide * 0.95, deck + 0.05), (long * 0.65, 0.22, 0.07), material=coat, mirror=True)
    section(kit, -long - 0.3, -long * 0.35, (radius + 0.1, deck + 0.4, 0.5), (radius, deck + 0.45, 0.55), coat)
    if kit.chance(0.75):
        glass_cab(kit, -0.3, 0, deck + 0.05, 0.45, 0.5, rng.uniform(1.15, 1.35), coat, dark)
    else:
        seat(kit, -0.35, 0, deck + 0.3, 0.3, 0.5, hide(kit))
        for x in (0.1, -0.8):
            kit.between((x, 0.52, deck), (x, 0.52, deck + 1.35), 0.035, BOX, material=dark, mirror=True)
        kit.add(BOX, (-0.35, 0, deck + 1.38), (0.6, 0.6, 0.04), material=coat)
    blade, front, lift = wide + rng.uniform(0.3, 0.5), long + rng.uniform(0.6, 0.8), rng.uniform(0.0, 0.35)
    high = rng.uniform(0.38, 0.5)
    for k, (tilt, z) in enumerate(((-18, 0.28), (0, 1.0), (18, 1.72))):
        kit.add(BOX, (front + (0.08, 0, 0.08)[k], 0, lift + high * z), (0.04, blade, high * 0.42), rotation=turn("y", -tilt), material=coat)
    kit.add(BOX, (front + 0.17, 0, lift + 0.04), (0.05, blade, 0.05), material=steel)
    kit.between((0, wide + 0.3, radius), (front, wide + 0.2, lift + 0.3), (0.08, 0.05), BOX, material=coat, mirror=True)
    kit.add(CYL, (0, wide + 0.24, radius), (0.12, 0.12, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
    kit.between((long * 0.8, 0.36, deck + 0.15), (front, 0.45, lift + high * 1.1), 0.045, material=steel, mirror=True)
    if kit.chance(0.6):
        kit.between((-long - 0.2, 0.3, radius), (-long - 0.75, 0.3, radius + 0.1), (0.07, 0.06), BOX, material=coat, mirror=True)
        kit.add(BOX, (-long - 0.75, 0, radius + 0.15), (0.08, 0.5, 0.1), material=coat)
        for y in (-0.38, 0, 0.38)[:: 2 if kit.chance(0.4) else 1]:
            kit.between((-long - 0.75, y, radius + 0.3), (-long - 0.85, y, 0.08), (0.06, 0.035), BOX, 0.6, material=steel)
    kit.add(BOX, (long * 0.6, 0.42, deck + 0.2), (0.3, 0.02, 0.15), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=35, second=coat.first), mirror=True)


def roller(kit):
    rng = kit.rng
    coat, dark, steel, tyre = loud(kit), kit.material(dark=True), kit.material(base=rng.uniform(0.2, 0.5) * np.ones(3), pattern=rng.choice([PLAIN, STREAKS])), rubber(kit)
    front, rear, radius, wide = rng.uniform(1.1, 1.3), -rng.uniform(0.9, 1.1), rng.uniform(0.55, 0.7), rng.uniform(0.7, 0.85)
    kind = rng.choice(["single", "tandem", "steam"])
    kit.add(CYL, (front, 0, radius), (radius, radius, wide), rotation=ALONG_Y, material=steel)
    kit.add(CYL, (front, 0, radius), (radius * 0.3, radius * 0.3, wide + 0.05), rotation=ALONG_Y, material=dark)
    if kind == "steam":  # one great wheel each side, a boiler, a roof
        big = rng.uniform(0.75, 0.85)
        kit.add(CYL, (rear, wide + 0.05, big), (big, big, 0.2), rotation=ALONG_Y, material=steel, mirror=True, cut=RING)
        kit.add(CYL, (rear, wide + 0.05, big), (big * 0.95, big * 0.95, 0.12), rotation=ALONG_Y, material=coat, mirror=True, cut=(SPOKES, 10, 0.3))
        kit.between((rear, -wide, big), (rear, wide, big), 0.06, material=dark)
        kit.add(CYL, (0.2, 0, 1.2), (0.36, 0.36, 0.95), rotation=ALONG_X, material=coat)
        kit.add(CYL, (front, 0, 1.3), (0.4, 0.4, 0.16), rotation=ALONG_X, material=dark)
        kit.add(CYL, (front, 0, 2.0), (0.11, 0.11, 0.55), (1.2, 1), material=dark)
        kit.between((front, -wide - 0.05, radius), (front, -wide - 0.05, 2 * radius + 0.1), 0.05, BOX, material=coat)
        kit.between((front, wide + 0.05, radius), (front, wide + 0.05, 2 * radius + 0.1), 0.05, BOX, material=coat)
        kit.add(BOX, (front, 0, 2 * radius + 0.1), (0.1, wide + 0.1, 0.06), material=coat)
        kit.add(BOX, (rear + 0.1, 0, 1.0), (0.6, wide * 0.75, 0.4), material=coat)
        section(kit, rear - 0.9, rear - 0.3, (0.7, 1.5, wide * 0.7), (0.7, 1.5, wide * 0.75), coat)
        for x in (rear - 0.8, front - 0.6):
            kit.between((x, wide * 0.6, 1.2), (x, wide * 0.6, 2.5), 0.03, material=dark, mirror=True)
        kit.add(BOX, ((rear + front) / 2 - 0.7, 0, 2.53), ((front - rear) / 2 + 0.2, wide * 0.9, 0.05), material=kit.material())
        kit.add(CYL, (0.3, wide * 0.75, 1.35), (0.42, 0.42, 0.05), rotation=ALONG_Y, material=dark, cut=(SPOKES, 6, 0.2))
        kit.between((0.3, 0, 1.35), (0.3, wide * 0.75, 1.35), 0.04, material=dark)
        return
    kit.add(BOX, (front, wide + 0.06, radius), (radius * 1.1, 0.05, 0.12), material=coat, mirror=True)
    for x in (front - radius - 0.12, front + radius + 0.12)[: 1 if kit.chance(0.4) else 2]:
        kit.add(BOX, (x, 0, radius), (0.07, wide + 0.1, 0.14), material=coat)
    deck = radius + 0.25
    if kind == "single":
        big = rng.uniform(0.6, 0.68)
        rims(kit, rear, wide * 0.75, big, 0.24, tyre, coat)
        kit.between((rear, -wide * 0.7, big), (rear, wide * 0.7, big), 0.12, material=dark)
        kit.between((0.2, 0, radius), (front - radius - 0.1, 0, radius), (0.12, 0.25), BOX, material=coat)
        section(kit, rear - 0.7, rear + 0.5, (big * 0.9, big * 2 + 0.25, 0.42), (big * 0.9, big * 2 + 0.35, 0.45), coat)
        kit.add(BOX, (0.05, 0, radius + 0.05), (0.5, wide * 0.6, 0.25), material=coat)
        cab = 0.05
    else:
        kit.add(CYL, (rear, 0, radius), (radius, radius, wide), rotation=ALONG_Y, material=steel)
        kit.add(CYL, (rear, 0, radius), (radius * 0.3, radius * 0.3, wide + 0.05), rotation=ALONG_Y, material=dark)
        kit.add(BOX, (rear, wide + 0.06, radius), (radius * 0.4, 0.05, 0.12), material=coat, mirror=True)
        section(kit, rear - 0.35, front + 0.3, (2 * radius + 0.04, 2 * radius + 0.45, wide * 0.75), (2 * radius + 0.04, 2 * radius + 0.35, wide * 0.7), coat)
        for x in (front, rear):
            kit.add(BOX, (x, wide + 0.06, radius * 1.5 + 0.1), (0.12, 0.05, radius * 0.6), material=coat, mirror=True)
            kit.add(BOX, (x, 0, 2 * radius + 0.12), (0.16, wide + 0.1, 0.08), material=coat)
        kit.add(BOX, (0.1, 0, radius + 0.15), (front - radius - 0.1, wide * 0.6, 0.3), material=dark)
        deck, cab = 2 * radius + 0.3, 0.1
    if kit.chance(0.5):
        glass_cab(kit, cab, 0, deck, 0.45, 0.48, 1.4, coat, dark)
    else:
        seat(kit, cab - 0.1, 0, deck + 0.2, 0.25, 0.45, hide(kit))
        kit.add(BOX, (cab - 0.1, 0, deck + 0.1), (0.25, 0.25, 0.14), material=dark)
        steering(kit, cab + 0.3, 0, deck + 0.55, dark)
        for x in (cab - 0.5, cab + 0.55)[: int(rng.integers(1, 3))]:
            kit.between((x, 0.45, deck - 0.15), (x, 0.45, deck + 1.4), 0.035, BOX, material=dark, mirror=True)
            kit.between((x, -0.45, deck + 1.4), (x, 0.45, deck + 1.4), 0.035, BOX, material=dark)
        if kit.chance(0.6):
            kit.add(BOX, (cab - 0.1, 0, deck + 1.42), (0.65, 0.55, 0.04), material=coat)


def mine_dump(kit):
    rng = kit.rng
    coat, dark, tyre = loud(kit), kit.material(dark=True), rubber(kit)
    radius, front, rear, wide = rng.uniform(0.85, 1.0), rng.uniform(1.7, 2.0), -rng.uniform(1.2, 1.5), rng.uniform(1.25, 1.45)
    rims(kit, front, wide, radius, 0.3, tyre, coat)
    for y in (wide * 0.95, wide * 0.5):
        rims(kit, rear, y, radius, 0.28, tyre, coat)
    kit.between((rear, -wide, radius), (rear, wide, radius), 0.35, material=dark)
    kit.between((rear - 0.4, 0.4, radius + 0.25), (front + 0.4, 0.4, radius + 0.25), (0.22, 0.15), BOX, material=coat, mirror=True)
    kit.between((front, -wide, radius), (front, wide, radius), 0.18, material=dark)
    deck = 2 * radius + rng.uniform(0.25, 0.4)
    section(kit, front - 0.5, front + 0.65, (radius + 0.1, deck, 0.75), (radius + 0.1, deck, 0.7), coat)
    kit.add(BOX, (front + 0.66, 0, radius + 0.65), (0.03, 0.55, 0.5), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=25, second=[0.15] * 3))
    kit.add(BOX, (front + 0.05, 0, deck), (0.65, wide + 0.25, 0.06), material=coat)
    kit.add(BOX, (front + 0.7, 0, radius * 0.75), (0.15, wide * 0.9, 0.2), material=coat)
    kit.between((front + 0.35, 0.6, radius + 0.2), (front + 0.7, 0.6, radius * 0.75), 0.1, BOX, material=coat, mirror=True)
    glass_cab(kit, front + 0.05, wide * 0.62, deck, 0.45, 0.45, 1.0, coat, dark)
    kit.add(BOX, (front + 0.05, -wide * 0.6, deck + 0.25), (0.4, 0.4, 0.25), material=coat)
    kit.railing((front + 0.68, -wide - 0.2, deck), (front + 0.68, wide + 0.2, deck), 0.4, dark, 0.4, GRID)
    kit.between((front + 0.72, wide * 0.6, radius * 0.7), (front + 0.8, -wide * 0.6, deck), (0.02, 0.16), BOX, material=dark)
    lift = turn("y", -rng.choice([0, 0, rng.uniform(10, 40)]))
    hinge = np.array([rear - 0.5, 0, radius + 0.6])
    bed = kit.material(base=coat.first, pattern=RIBS, frequency=8, second=coat.first * 0.7)
    long = front - 0.55 - hinge[0]
    top = deck + 0.95 - hinge[2]

    def tilted(start, end, radii, material):
        kit.between(hinge + lift @ np.array(start), hinge + lift @ np.array(end), radii, BOX, material=material)

    tilted((-0.5, 0, 0.4), (long * 0.6, 0, 0.1), (0.08, wide * 0.9), bed)
    tilted((long * 0.55, 0, 0.1), (long, 0, top), (0.08, wide * 1.05), bed)
    tilted((long - 0.05, 0, top), (long + 1.25, 0, top + 0.08), (0.06, wide * 1.0), bed)
    for y in (-wide * 1.05, wide * 1.05):
        tilted((long * 0.2, y, 0.55), (long * 0.85, y, 0.75), (0.5, 0.06), bed)
        tilted((-0.55, y, 0.68), (long * 0.5, y, 0.72), (0.3, 0.06), bed)
        tilted((-0.5, y, 1.0), (long, y, top), (0.08, 0.1), bed)
    if kit.chance(0.5):
        load = kit.material(base=rng.choice([[0.3, 0.24, 0.16], [0.05, 0.05, 0.05], [0.35, 0.35, 0.34]]), pattern=17, frequency=20)
        kit.add(BALL, hinge + lift @ np.array([long * 0.42, 0, 0.75]), (long * 0.5, wide * 0.95, rng.uniform(0.5, 0.75)), rotation=lift, material=load)
    kit.between((0.2, 0.3, radius + 0.3), hinge + lift @ np.array([long * 0.55, 0.3, 0.1]), 0.09, material=dark, mirror=True)
    lights(kit, front + 0.68, rear - 0.45, 0.62, radius + 0.15, 0.1)
    kit.add(BOX, (rear - 0.43, 0, radius + 0.25), (0.06, 0.55, 0.2), material=coat)


def loader(kit):
    rng = kit.rng
    coat, dark, tyre, steel = loud(kit), kit.material(dark=True), rubber(kit), kit.material(base=rng.uniform(0.1, 0.4) * np.ones(3), pattern=STREAKS)
    radius, front, rear, wide = rng.uniform(0.58, 0.7), rng.uniform(1.0, 1.2), -rng.uniform(1.1, 1.3), rng.uniform(0.75, 0.9)
    for x in (front, rear):
        rims(kit, x, wide, radius, 0.23, tyre, coat)
        kit.between((x, -wide, radius), (x, wide, radius), 0.12, material=dark)
    deck = 2 * radius + 0.1
    kit.add(BOX, (front - 0.1, 0, radius + 0.2), (0.75, 0.32, 0.42), material=coat)
    kit.add(BOX, (0, 0, radius + 0.1), (0.6, 0.25, 0.2), material=dark)
    section(kit, rear - 0.75, -0.05, (radius * 0.9, deck + 0.45, 0.5), (radius * 0.9, deck + 0.55, 0.55), coat)
    kit.add(BOX, (rear - 0.8, 0, radius + 0.05), (0.14, wide * 0.9, 0.28), material=coat)
    kit.add(BOX, (rear, wide * 0.95, 2 * radius + 0.07), (radius * 1.05, 0.25, 0.04), (0.85, 1), material=coat, mirror=True)
    kit.add(BOX, (rear - 0.76, 0, deck + 0.05), (0.02, 0.4, 0.3), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=35, second=coat.first))
    glass_cab(kit, -0.2, 0, deck - 0.1, 0.48, 0.52, rng.uniform(1.3, 1.5), coat, dark, 0.05)
    kit.between((rear * 0.8, 0.25, deck + 0.4), (rear * 0.8, 0.25, deck + 0.85), 0.05, material=dark)
    lift = rng.uniform(0.1, 1.6)
    root, tip = np.array([front - 0.45, 0.3, deck + 0.25]), np.array([front + rng.uniform(1.0, 1.2), 0.35, 0.25 + lift])
    knee = (root + tip) / 2 + [0.1, 0, 0.22]
    kit.between((front - 0.45, 0.28, radius), root, (0.14, 0.06), BOX, material=coat, mirror=True)
    kit.between(root, knee, (0.12, 0.06), BOX, material=coat, mirror=True)
    kit.between(knee, tip, (0.11, 0.06), BOX, material=coat, mirror=True)
    kit.between((front, 0.28, radius + 0.3), knee, 0.055, material=steel, mirror=True)
    kit.between((front - 0.3, 0, deck + 0.15), tip * [1, 0, 1] + [0.05, 0, 0.45], 0.07, BOX, material=coat)
    if kit.chance(0.25):
        kit.between(tip * [1, 0, 1] + [0, -0.6, 0.1], tip * [1, 0, 1] + [0, 0.6, 0.1], 0.09, BOX, material=coat)
        kit.between(tip + [0, 0, 0.1], tip + [0, 0, 0.6], 0.05, BOX, material=coat, mirror=True)
        kit.between(tip + [0, 0, 0.02], tip + [1.1, 0, -0.02], (0.03, 0.07), BOX, material=steel, mirror=True)
    else:
        roll = turn("y", rng.uniform(-40, 15))
        span = wide + rng.uniform(0.25, 0.4)
        for x, z, half_x, half_z, lean in ((0.08, 0.25, 0.05, 0.34, 0), (0.42, -0.05, 0.42, 0.05, 0), (0.12, 0.03, 0.05, 0.16, 45)):
            kit.add(BOX, tip * [1, 0, 1] + roll @ np.array([x, 0, z]), (half_x, span, half_z), rotation=roll @ turn("y", lean), material=coat if kit.chance(0.5) else steel)
        for side in (-1, 1):
            kit.add(BOX, tip * [1, 0, 1] + roll @ np.array([0.42, side * span, 0.24]), (0.42, 0.03, 0.32), (0.25, 1), (-0.3, 0), rotation=roll, material=coat)
    lights(kit, front + 0.66, rear - 0.94, 0.3, radius + 0.35, 0.08)


def grader(kit):
    rng = kit.rng
    coat, dark, tyre, steel = loud(kit), kit.material(dark=True), rubber(kit), kit.material(base=rng.uniform(0.15, 0.4) * np.ones(3), pattern=STREAKS)
    radius, wide, front = rng.uniform(0.5, 0.58), rng.uniform(0.8, 0.95), rng.uniform(2.6, 3.1)
    for x in (-0.75, -0.75 - 2.2 * radius):
        rims(kit, x, wide, radius, 0.17, tyre, coat)
    rims(kit, front, wide, radius, 0.15, tyre, coat)
    kit.between((front, -wide, radius), (front, wide, radius), 0.1, BOX, material=coat)
    kit.add(BOX, (-0.75 - 1.1 * radius, wide * 0.72, radius), (radius * 1.5, 0.08, 0.16), material=coat, mirror=True)
    deck = 2 * radius + 0.1
    section(kit, -0.75 - 3.3 * radius, -0.1, (radius, deck + 0.5, 0.42), (radius, deck + 0.6, 0.45), coat)
    glass_cab(kit, 0.3, 0, deck - 0.15, 0.5, 0.5, rng.uniform(1.4, 1.6), coat, dark)
    kit.add(BOX, (0.3, 0, radius + 0.25), (0.55, 0.4, 0.32), material=coat)
    arched = np.array([1.5, 0, deck + 0.65])
    kit.between((0.7, 0, deck + 0.15), arched, (0.15, 0.12), BOX, material=coat)
    kit.between(arched + [-0.1, 0, 0.02], (front + 0.15, 0, deck + 0.05), (0.14, 0.12), BOX, material=coat)
    kit.between((front + 0.05, 0, deck + 0.1), (front + 0.05, 0, radius), (0.15, 0.18), BOX, material=coat)
    x, yaw = 1.35, turn("z", rng.uniform(-35, 35))
    kit.add(CYL, (x, 0, 0.72), (0.48, 0.48, 0.06), material=dark)
    kit.between((x + 0.35, 0.3, 0.72), (front - 0.1, 0.05, 0.8), (0.06, 0.05), BOX, material=coat, mirror=True)
    for tilt, z, dx in ((-15, 0.15, 0.04), (12, 0.42, 0.03)):
        kit.add(BOX, np.array([x, 0, z]) + yaw @ np.array([dx, 0, 0]), (0.025, wide * rng.uniform(1.25, 1.35), 0.16), rotation=yaw @ turn("y", tilt), material=steel)
    for y in (-0.4, 0.4):
        kit.between(np.array([x, 0, 0.72]) + yaw @ np.array([-0.05, y, 0]), np.array([x, 0, 0.3]) + yaw @ np.array([-0.05, y, 0]), 0.06, BOX, material=coat)
        kit.between((x - 0.05, y * 0.8, 0.75), (x + 0.05, y * 1.4, deck + 0.85), 0.05, material=steel)
    kit.between((x + 0.05, -0.58, deck + 0.72), (x + 0.05, 0.58, deck + 0.72), 0.06, BOX, material=coat)
    kit.between((-1.2, 0.25, deck + 0.5), (-1.2, 0.25, deck + 1.0), 0.05, material=dark)
    kit.add(BOX, (-0.77 - 3.3 * radius, 0, radius + 0.3), (0.05, wide * 0.7, 0.25), material=coat)
    if kit.chance(0.5):
        kit.between((front, 0, 0.7), (front + 0.7, 0, 0.5), 0.07, BOX, material=coat)
        kit.add(BOX, (front + 0.75, 0, 0.4), (0.04, wide * 1.1, 0.3), rotation=turn("y", -12), material=coat)
    lights(kit, front + 0.21, -0.77 - 3.4 * radius, 0.15, deck, 0.07)


def combine(kit):
    rng = kit.rng
    coat, second, dark, tyre = loud(kit), loud(kit), kit.material(dark=True), rubber(kit)
    big, small, wide, half = rng.uniform(0.78, 0.92), rng.uniform(0.45, 0.55), rng.uniform(0.8, 0.95), rng.uniform(1.9, 2.2)
    front, rear = half * 0.4, -half * 0.65
    rims(kit, front, wide + 0.22, big, 0.25, tyre, second)
    rims(kit, rear, wide * 0.85, small, 0.16, tyre, second)
    for x, r in ((front, big), (rear, small)):
        kit.between((x, -wide, r), (x, wide, r), 0.13, material=dark)
    floor, roof = big * 1.0, rng.uniform(2.3, 2.6)
    section(kit, -half * 0.55, half * 0.62, (floor, roof, wide * 0.98), (floor, roof, wide), coat)
    section(kit, -half * 1.05, -half * 0.5, (floor + 0.5, roof - 0.45, wide * 0.9), (floor, roof - 0.02, wide * 0.97), coat)
    kit.add(BOX, (half * 0.0, 0, roof + 0.1), (half * 0.4, wide * 0.8, 0.14), (1.12, 1.12), material=second if kit.chance(0.4) else coat)
    glass_cab(kit, half * 0.62 + 0.4, 0, roof - 1.2, 0.48, wide * 0.72, 1.35, coat, dark, -0.1)
    kit.add(BOX, (half * 0.75, 0, floor + 0.35), (0.35, wide * 0.6, 0.35), material=dark)
    head, cutter = half + 0.9, rng.uniform(1.7, 2.4)
    section(kit, half * 0.55, head - 0.1, (floor + 0.1, floor + 0.75, 0.42), (0.25, 0.8, 0.45), dark)
    section(kit, head - 0.3, head + 0.35, (0.15, 0.95, cutter), (0.12, 0.2, cutter), second)
    kit.add(BOX, (head + 0.2, cutter, 0.5), (0.55, 0.05, 0.38), (0.7, 1), (-0.15, 0), material=coat, mirror=True)
    kit.between((head + 0.6, cutter, 0.25), (head + 1.0, cutter, 0.12), (0.12, 0.05), BOX, 0.2, material=coat, mirror=True)
    if kit.chance(0.65):
        reel = np.array([head + 0.45, 0, 0.85])
        kit.between(reel + [0, -cutter + 0.05, 0], reel + [0, cutter - 0.05, 0], 0.05, material=dark)
        for k in range(5):
            a = 2 * np.pi * k / 5
            at = reel + 0.42 * np.array([np.cos(a), 0, np.sin(a)])
            kit.between(at + [0, -cutter + 0.05, 0], at + [0, cutter - 0.05, 0], (0.02, 0.05), BOX, material=second)
        kit.add(CYL, reel + [0, cutter - 0.06, 0], (0.44, 0.44, 0.015), rotation=ALONG_Y, material=dark, mirror=True, cut=(SPOKES, 5, 0.2))
        kit.between((head - 0.2, cutter - 0.03, 0.85), reel + [0, cutter - 0.03, 0], 0.05, BOX, material=coat, mirror=True)
    else:
        for y in np.linspace(-cutter + 0.2, cutter - 0.2, 6):
            kit.between((head + 0.1, y, 0.5), (head + 1.1, y, 0.1), 0.15, CYL, 0.1, material=second)
    spout = np.array([half * 0.25, wide * 0.95, roof + 0.05])
    if kit.chance(0.5):
        kit.between(spout, spout + [-half * 1.3, 0.1, 0.1], 0.14, material=coat)
    else:
        kit.between(spout, spout + [0.1, rng.uniform(1.4, 2.0), 0.5], 0.14, material=coat)
    kit.add(CYL, spout - [0, 0, 0.2], (0.17, 0.17, 0.35), material=coat)
    kit.add(BOX, (-half * 0.1, wide * 0.99, (floor + roof) / 2 + 0.1), (half * 0.35, 0.03, 0.4), material=kit.material(base=dark.first, pattern=RIBS, frequency=20), mirror=True)
    kit.add(BOX, (half * 0.05, wide * 1.0, roof - 0.2), (half * 0.5, 0.03, 0.08), material=second, mirror=True)
    kit.between((half * 0.75, wide * 0.95, floor - 0.3), (half * 0.9, wide * 0.8, roof - 1.1), (0.02, 0.15), BOX, material=dark)


def farm_tractor(kit):
    """A tractor of today with its implement: a plough, a front loader, a roller of bales, a sprayer, a seed drill or a tanker."""
    rng = kit.rng
    coat, second, dark, tyre = loud(kit), loud(kit), kit.material(dark=True), rubber(kit)
    big, small, wide = rng.uniform(0.75, 0.9), rng.uniform(0.5, 0.62), rng.uniform(0.65, 0.78)
    front = rng.uniform(1.6, 1.9)
    for x, r, half in ((front, small, 0.17), (0, big, 0.24)):
        rims(kit, x, wide, r, half, tyre, second)
        kit.between((x, -wide, r), (x, wide, r), 0.1, material=dark)
    kit.between((0.0, 0, big), (front + 0.2, 0, small + 0.15), (0.2, 0.2), BOX, material=dark)
    section(kit, 0.4, front + 0.5, (small + 0.35, 1.65, 0.36), (small + 0.35, rng.uniform(1.3, 1.5), 0.28), coat)
    kit.add(BOX, (front + 0.51, 0, 1.1), (0.015, 0.22, 0.22), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=40, second=[0.2] * 3))
    arch(kit, 0, wide, big, big + 0.08, 0.2, 15, 130, 3, coat)
    kit.add(BOX, (0.05, wide * 0.7, big + 0.35), (0.5, 0.18, 0.4), material=coat, mirror=True)
    glass_cab(kit, 0.0, 0, big + 0.35, 0.55, 0.55, rng.uniform(1.35, 1.5), coat, dark, 0.05)
    kit.between((0.75, -0.3, 1.5), (0.75, -0.3, 2.4), 0.04, material=dark)
    lights(kit, front + 0.5, -0.5, 0.2, 1.3, 0.06)
    kind = rng.choice(["plough", "loader", "baler", "tank", "drill", "none"])
    hitch = np.array([-0.6, 0, 0.55])
    if kind in ("plough", "drill"):
        kit.between((-0.2, 0.3, big * 0.7), (-1.2, 0.4, 0.6), 0.04, BOX, material=dark, mirror=True)
        kit.between((-0.4, 0, big + 0.3), (-1.2, 0, 1.0), 0.04, material=dark)
        kit.between((-1.2, 0, 0.5), (-1.2, 0, 1.05), 0.06, BOX, material=second)
        kit.between((-1.2, -0.5, 0.6), (-1.2, 0.5, 0.6), 0.06, BOX, material=second)
    if kind == "plough":
        kit.between((-1.2, 0.45, 0.65), (-3.2, -0.7, 0.65), 0.08, BOX, material=second)
        steel = kit.material(base=rng.uniform(0.2, 0.5) * np.ones(3), gloss=0.5, pattern=PLAIN)
        for k in range(4):
            at = np.array([-1.4 - 0.5 * k, 0.34 - 0.28 * k, 0.6])
            kit.between(at, at + [0.15, 0, -0.4], (0.05, 0.03), BOX, material=second)
            kit.add(BOX, at + [0.1, -0.08, -0.38], (0.28, 0.02, 0.17), (1.2, 1), rotation=turn("z", 30) @ turn("x", 20), material=steel)
        kit.add(CYL, (-3.0, -0.75, 0.25), (0.25, 0.25, 0.06), rotation=ALONG_Y, material=tyre)
        kit.between((-3.0, -0.6, 0.65), (-3.0, -0.72, 0.25), 0.03, BOX, material=second)
    elif kind == "drill":
        span = rng.uniform(1.1, 1.6)
        kit.add(BOX, (-1.75, 0, 1.05), (0.3, span, 0.25), (1.3, 1), material=second)
        kit.add(BOX, (-1.6, 0, 0.6), (0.4, span, 0.05), material=coat)
        kit.between((-1.75, span * 0.7, 0.6), (-1.75, span * 0.7, 0.9), 0.05, BOX, material=second, mirror=True)
        for y in np.linspace(-span * 0.95, span * 0.95, 8):
            kit.between((-1.7, y, 0.6), (-1.95, y, 0.18), 0.03, BOX, material=dark)
            kit.add(CYL, (-1.95, y, 0.17), (0.17, 0.17, 0.015), rotation=ALONG_Y, material=dark)
    elif kind == "loader":
        lift = rng.uniform(0.1, 1.5)
        root, tip = np.array([0.6, 0.52, 1.55]), np.array([front + 1.5, 0.45, 0.2 + lift])
        knee = np.array([front + 0.5, 0.48, 1.1 + lift * 0.6])
        kit.between((0.7, 0.45, 0.8), root, (0.1, 0.05), BOX, material=second, mirror=True)
        kit.between((0.7, -0.45, 0.85), (0.7, 0.45, 0.85), 0.07, BOX, material=dark)
        kit.between(root, knee, (0.09, 0.05), BOX, material=second, mirror=True)
        kit.between(knee, tip, (0.08, 0.05), BOX, material=second, mirror=True)
        kit.between((0.72, 0.46, 1.0), knee, 0.04, material=dark, mirror=True)
        kit.between(tip * FLIP, tip, 0.05, material=second)
        kit.add(BOX, tip * [1, 0, 1] + [0.05, 0, 0.15], (0.04, 0.85, 0.28), material=second)
        if kit.chance(0.5):
            kit.add(CYL, tip * [1, 0, 1] + [0.7, 0, 0.45], (0.6, 0.6, 0.6), rotation=ALONG_Y, material=kit.material(base=[0.55, 0.42, 0.16], pattern=STRIPES, frequency=20))
        else:
            kit.add(BOX, tip * [1, 0, 1] + [0.45, 0, -0.1], (0.4, 0.85, 0.03), material=second)
            kit.add(BOX, tip * [1, 0, 1] + [0.45, 0.84, 0.12], (0.4, 0.02, 0.23), (0.3, 1), (-0.28, 0), material=second, mirror=True)
    elif kind in ("baler", "tank"):
        kit.between(hitch, hitch + [-1.0, 0, 0.05], (0.05, 0.08), BOX, material=second)
        x = -2.7
        if kind == "tank":
            kit.add(CYL, (x, 0, 1.15), (0.62, 0.68, 1.2), rotation=ALONG_X, material=second)
            for end in (-1.2, 1.2):
                kit.add(BALL, (x + end, 0, 1.15), (0.18, 0.66, 0.6), material=second)
            kit.add(BOX, (x, 0, 0.6), (1.3, 0.3, 0.1), material=dark)
            kit.between(hitch + [-0.9, 0, 0.05], (x + 0.8, 0, 0.6), 0.1, BOX, material=dark)
        else:
            kit.add(CYL, (x, 0, 1.1), (0.75, 0.75, 0.6), rotation=ALONG_Y, material=second)
            section(kit, x, x + 0.9, (0.4, 1.4, 0.58), (0.35, 0.8, 0.58), coat)
            kit.add(BOX, (x + 0.1, 0.63, 1.05), (0.6, 0.04, 0.5), material=coat, mirror=True)
            kit.between(hitch + [-0.9, 0, 0.05], (x + 0.8, 0, 0.55), 0.1, BOX, material=dark)
        rims(kit, x, 0.85, 0.5, 0.17, tyre, coat)
        kit.between((x, -0.85, 0.5), (x, 0.85, 0.5), 0.07, material=dark)


def telehandler(kit):
    rng = kit.rng
    coat, dark, tyre, steel = loud(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    radius, front, rear, wide = rng.uniform(0.5, 0.6), rng.uniform(1.0, 1.2), -rng.uniform(1.0, 1.2), rng.uniform(0.8, 0.9)
    for x in (front, rear):
        rims(kit, x, wide, radius, 0.2, tyre, coat)
        kit.between((x, -wide, radius), (x, wide, radius), 0.1, material=dark)
    kit.add(BOX, (0, 0, radius + 0.15), (front + 0.5, 0.38, 0.25), material=coat)
    glass_cab(kit, -0.05, 0.55, radius - 0.05, 0.55, 0.36, rng.uniform(1.6, 1.75), coat, dark, 0.08)
    kit.add(BOX, (-0.05, -0.6, radius + 0.3), (0.7, 0.3, 0.35), (0.95, 0.9), material=coat)
    kit.add(BOX, (rear - 0.35, 0, radius + 0.35), (0.22, 0.45, 0.5), (0.8, 0.9), material=coat)
    lift, reach = np.radians(rng.uniform(0, 55)), rng.uniform(2.6, 3.2)
    aim = np.array([np.cos(lift), 0, np.sin(lift)])
    root = np.array([rear - 0.3, -0.05, radius + 0.85])
    kit.between(root - aim * 0.2, root + aim * reach, (0.16, 0.13), BOX, material=coat)
    out = reach + rng.uniform(0.4, 1.6)
    kit.between(root + aim * reach * 0.9, root + aim * out, (0.12, 0.1), BOX, material=steel)
    kit.between((0.1, -0.05, radius + 0.3), root + aim * reach * 0.55, 0.07, material=steel)
    tip = root + aim * out
    down = tip + [0.15, 0, -0.35]
    kit.between(tip - aim * 0.1, down, (0.12, 0.1), BOX, material=coat)
    if kit.chance(0.6):
        kit.add(BOX, down + [0.12, 0, 0.1], (0.03, 0.55, 0.3), material=dark, cut=(GRID, 4, 0.3))
        kit.between(down, down + [0.12, 0, 0.0], (0.15, 0.2), BOX, material=coat)
        for y in (-0.3, 0.3):
            kit.between(down + [0.12, y, -0.2], down + [1.15, y, -0.22], (0.03, 0.07), BOX, material=steel)
        if kit.chance(0.5):
            kit.add(BOX, down + [0.65, 0, 0.2], (0.45, 0.5, rng.uniform(0.2, 0.4)), material=kit.material())
    else:
        kit.add(BOX, down + [0.15, 0, 0.05], (0.04, 0.9, 0.3), material=dark)
        kit.add(BOX, down + [0.5, 0, -0.22], (0.38, 0.9, 0.03), material=dark)
        for y in (-0.9, 0.9):
            kit.add(BOX, down + [0.5, y, 0.02], (0.38, 0.02, 0.26), (0.3, 1), (-0.26, 0), material=dark)
    if kit.chance(0.4):
        kit.between((front + 0.4, wide * 0.5, 0.5), (front + 0.5, wide * 0.9, 0.05), 0.06, BOX, material=coat, mirror=True)
        kit.add(BOX, (front + 0.5, wide * 0.9, 0.03), (0.12, 0.15, 0.03), material=dark, mirror=True)
    lights(kit, front + 0.52, rear - 0.56, 0.32, radius + 0.25, 0.07)


def mobile_crane(kit):
    """A crane on a carrier with many axles and a telescopic boom, or on tracks with one of lattice."""
    rng = kit.rng
    coat, second, dark, tyre, steel = loud(kit), loud(kit), kit.material(dark=True), rubber(kit), kit.material(base=rng.uniform(0.15, 0.5) * np.ones(3), pattern=PLAIN)
    lift, long = np.radians(rng.uniform(25, 75)), rng.uniform(3.5, 7.0)
    aim, up = np.array([np.cos(lift), 0, np.sin(lift)]), np.array([-np.sin(lift), 0, np.cos(lift)])
    if kit.chance(0.5):
        crawler_track(kit, 1.2, 1.05, 0.36, 0.25, dark, steel)
        kit.add(BOX, (0, 0, 0.5), (0.6, 0.95, 0.22), material=dark)
        kit.add(CYL, (0, 0, 0.8), (0.55, 0.55, 0.12), material=steel)
        section(kit, -1.6, 0.8, (0.9, 1.7, 0.7), (0.9, 1.6, 0.7), coat)
        kit.add(BOX, (-1.65, 0, 1.25), (0.25, 0.9, 0.42), material=second)
        glass_cab(kit, 0.75, 0.7, 0.85, 0.45, 0.35, 1.2, coat, dark)
        root, half = np.array([0.7, 0, 1.15]), rng.uniform(0.2, 0.3)
        tip, frame = root + aim * long, (LATTICE, rng.uniform(1.6, 2.6), 0.18)
        middle, spin = (root + tip) / 2, np.stack([aim, [0, 1, 0], up], 1)
        for y in (-half, half):
            kit.add(BOX, middle + [0, y, 0], (long / 2, 0.02, half), rotation=spin, material=second, cut=frame)
            for z in (-half, half):
                kit.between(root + up * z * 0.5 + [0, y, 0], tip + up * z + [0, y, 0], 0.035, material=second)
        for z in (-half, half):
            kit.add(BOX, middle + up * z, (long / 2, half, 0.02), rotation=spin, material=second, cut=frame)
        kit.add(CYL, tip, (0.22, 0.22, half), rotation=ALONG_Y, material=dark)
        kit.between((-1.2, 0.4, 1.6), (-1.0, 0.3, 3.0), 0.05, BOX, material=second, mirror=True)
        kit.between((0.3, 0.4, 1.6), (-1.0, 0.3, 3.0), 0.05, BOX, material=second, mirror=True)
        kit.between((-1.0, -0.3, 3.0), (-1.0, 0.3, 3.0), 0.05, material=second)
        kit.between((-1.0, 0.15, 3.0), tip + up * half, 0.018, material=dark, mirror=True)
    else:
        half, wide, radius = rng.uniform(2.6, 3.4), 0.95, rng.uniform(0.42, 0.48)
        for x in np.linspace(-half * 0.8, half * 0.72, int(rng.integers(3, 6))):
            rims(kit, x, wide * 0.85, radius, 0.16, tyre, coat)
        kit.add(BOX, (0, 0, radius * 2), (half, wide * 0.6, 0.22), material=coat)
        kit.add(BOX, (-half * 0.1, 0, radius * 2 + 0.17), (half * 0.9, wide, 0.06), material=coat)
        section(kit, half * 0.7, half + 0.35, (radius + 0.05, radius + 1.0, wide), (radius + 0.05, radius + 0.9, wide * 0.95), coat)
        slab(kit, radius + 0.9, radius + 1.45, (half * 0.7, half + 0.3, wide * 0.95), (half * 0.72, half + 0.1, wide * 0.85), glazing(kit))
        kit.add(BOX, (half * 0.95, 0, radius + 1.47), (half * 0.1 + 0.2, wide * 0.9, 0.04), material=coat)
        lights(kit, half + 0.35, -half - 0.01, wide * 0.7, radius + 0.35, 0.1)
        deck = 2 * radius + 0.25
        base = -half * 0.25
        kit.add(CYL, (base, 0, deck + 0.06), (0.7, 0.7, 0.1), material=dark)
        kit.add(BOX, (base - 0.35, 0, deck + 0.5), (0.7, 0.6, 0.36), (0.8, 0.9), material=coat)
        kit.add(BOX, (base - 1.1, 0, deck + 0.45), (0.28, 0.85, 0.32), material=second)
        glass_cab(kit, base + 0.45, 0.68, deck + 0.1, 0.45, 0.3, 1.0, coat, dark)
        root = np.array([base - 0.6, 0, deck + 0.85])
        if kit.chance(0.3):
            lift = np.radians(4)
            aim, up = np.array([np.cos(lift), 0, np.sin(lift)]), np.array([-np.sin(lift), 0, np.cos(lift)])
            long = min(long, half * 1.6)
        first, parts = long * 0.45, int(rng.integers(2, 5))
        kit.between(root - aim * 0.2, root + aim * first, (0.25, 0.2), BOX, material=second)
        for k in range(1, parts):
            size = 1 - 0.17 * k
            at = first + (long - first) * (k - 1) / (parts - 1)
            kit.between(root + aim * (at - 0.2), root + aim * (first + (long - first) * k / (parts - 1)), (0.25 * size, 0.2 * size), BOX, material=second if kit.chance(0.7) else steel)
        tip = root + aim * long
        kit.between((base + 0.5, 0, deck + 0.3), root + aim * first * 0.75, 0.1, material=steel)
        kit.add(BOX, tip, (0.2, 0.12, 0.18), rotation=turn("y", -np.degrees(lift)), material=dark)
        spread = rng.uniform(1.0, 1.7)
        for x in (half * 0.55, -half * 0.95):
            kit.between((x, -wide * spread, radius * 1.5), (x, wide * spread, radius * 1.5), (0.09, 0.1), BOX, material=second)
            if spread > 1.25:
                kit.between((x, wide * spread, radius * 1.5), (x, wide * spread, 0.05), 0.06, material=steel, mirror=True)
                kit.add(CYL, (x, wide * spread, 0.04), (0.22, 0.22, 0.04), material=dark, mirror=True)
    if lift > 0.2:
        hook = tip + [0.12, 0, -rng.uniform(0.5, max(0.6, tip[2] * 0.8))]
        kit.between(tip + [0.12, 0, 0], hook, 0.02, material=dark)
        kit.add(BOX, hook, (0.1, 0.06, 0.16), material=second)
        kit.add(TUBE, hook - [0, 0, 0.22], (0.08, 0.08, 0.03), rotation=ALONG_Y, material=dark)


def tractor_unit(kit, front, coat, dark, tyre, metal, floor, radius, hooded):
    """The cab of an articulated lorry, its nose at `front`. Returns the x of its rear wall."""
    rng = kit.rng
    wide, tall = 0.95, rng.uniform(1.35, 1.6)
    nose = front
    if hooded:
        front -= 0.9
        section(kit, front - 0.1, nose, (floor - 0.15, floor + 0.65, wide * 0.75), (floor - 0.15, floor + 0.5, wide * 0.62), coat)
        kit.add(BOX, (nose - 0.55, wide * 0.8, floor + 0.1), (0.5, 0.16, 0.12), (0.8, 1), material=coat, mirror=True)
        kit.add(CYL, (front - 0.2, wide + 0.02, floor + 1.1), (0.07, 0.07, 1.0), material=metal, mirror=True)
    back = front - rng.uniform(1.0, 1.5)
    slab(kit, floor - 0.2, floor + tall * 0.5, (back, front, wide), (back, front - 0.02, wide), coat)
    slab(kit, floor + tall * 0.5, floor + tall, (back, front - 0.02, wide), (back, front - 0.15, wide * 0.92), coat)
    slab(kit, floor + tall * 0.5, floor + tall * 0.9, (back + 0.3, front + 0.005, wide * 0.85), (back + 0.3, front - 0.11, wide * 0.8), glazing(kit))
    slab(kit, floor + tall * 0.52, floor + tall * 0.86, (front - 0.75, front - 0.1, wide * 1.01), (front - 0.75, front - 0.2, wide * 0.96), glazing(kit))
    slab(kit, floor + tall, floor + tall + rng.uniform(0.15, 0.5), (back, front - 0.3, wide * 0.9), (back, back + 0.4, wide * 0.85), coat)
    kit.add(BOX, (nose + 0.02, 0, floor + 0.12), (0.03, wide * 0.5, 0.28), material=kit.material(base=[0.03] * 3, pattern=BANDS, frequency=30, second=metal.first))
    kit.add(BOX, (nose + 0.02, 0, floor - 0.25), (0.1, wide * 0.98, 0.15), material=metal if kit.chance(0.5) else coat)
    kit.add(BOX, (front - 0.1, wide * 1.15, floor + tall * 0.65), (0.06, 0.07, 0.18), material=dark, mirror=True)
    kit.add(BOX, (front - 0.1, wide * 1.05, floor + tall * 0.75), (0.02, 0.1, 0.02), material=dark, mirror=True)
    rims(kit, nose - radius - 0.25, wide * 0.86, radius, 0.13, tyre, metal)
    white = kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN, gloss=0.6)
    kit.add(BOX, (nose + 0.04, wide * 0.6, floor - 0.02), (0.04, 0.14, 0.08), material=white, mirror=True)
    return back


def car_transporter(kit):
    rng = kit.rng
    coat, steel, dark, tyre, metal = car_paint(kit), loud(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    radius, floor, half = 0.42, 0.75, rng.uniform(3.6, 4.4)
    back = tractor_unit(kit, half, coat, dark, tyre, metal, floor, radius, kit.chance(0.25))
    kit.add(BOX, (0, 0, 0.68), (half * 0.95, 0.35, 0.1), material=dark)
    for x in (back - 0.55, -half * 0.55, -half * 0.55 - 2.2 * radius):
        rims(kit, x, 0.8, radius, 0.14, tyre, metal)
    low, high, end = 0.9, rng.uniform(2.1, 2.4), -half
    front = back - 0.2
    kit.add(BOX, ((front + end) / 2, 0, low), ((front - end) / 2, 0.95, 0.05), material=steel)
    kit.add(BOX, ((front + end) / 2, 0, high), ((front - end) / 2, 0.95, 0.05), rotation=turn("y", rng.uniform(-2, 2)), material=steel)
    for x in np.linspace(front - 0.1, end + 0.2, 4):
        kit.between((x, 0.96, low - 0.1), (x - 0.1, 0.96, high + 0.05), 0.05, BOX, material=steel, mirror=True)
    for level in (low, high):
        for x in np.linspace(front - 1.0, end + 1.0, 2 if kit.chance(0.7) else 3):
            if kit.chance(0.7):
                paintwork, z = car_paint(kit), level + 0.2
                kit.add(BOX, (x, 0, z + 0.2), (0.85, 0.62, 0.2), (0.95, 0.95), material=paintwork)
                slab(kit, z + 0.38, z + 0.72, (x - 0.65, x + 0.4, 0.58), (x - 0.45, x + 0.1, 0.48), glazing(kit))
                kit.add(BOX, (x, 0, z - 0.03), (0.75, 0.6, 0.13), (0.9, 1), material=dark)
    lights(kit, half + 0.05, end - 0.02, 0.6, floor + 0.02, 0.06, False)


def log_lorry(kit):
    rng = kit.rng
    coat, dark, tyre, metal = car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    radius, floor, half = 0.44, 0.8, rng.uniform(3.2, 4.2)
    back = tractor_unit(kit, half, coat, dark, tyre, metal, floor, radius, kit.chance(0.6))
    kit.add(BOX, (0, 0, 0.78), (half * 0.95, 0.3, 0.12), material=dark)
    for x in (back - 0.45, back - 0.45 - 2.15 * radius, -half * 0.65, -half * 0.65 - 2.15 * radius):
        rims(kit, x, 0.8, radius, 0.15, tyre, metal)
    front, end = back - 0.25, -half
    bark = kit.material(base=np.array([0.25, 0.16, 0.09]) * rng.uniform(0.5, 1.5), pattern=rng.choice([STREAKS, CLOUDY, PLANKS]), frequency=20)
    thick, deck = rng.uniform(0.2, 0.26), 0.98
    rows = int(rng.integers(1, 4))
    for row_at in range(rows):
        count = int(1.75 / (2 * thick)) - row_at % 2
        for k in range(count):
            y, z = (k - (count - 1) / 2) * 2 * thick, deck + thick * (1 + 1.75 * row_at)
            r, shorten = thick * rng.uniform(0.92, 1.05), rng.uniform(0, 0.3)
            kit.add(CYL, ((front + end) / 2, y, z), (r, r, (front - end) / 2 - shorten), (rng.uniform(0.8, 1), 1), rotation=ALONG_X, material=bark)
    for x in np.linspace(front - 0.4, end + 0.5, 3):
        kit.add(BOX, (x, 0, deck - 0.06), (0.08, 0.98, 0.07), material=metal)
        kit.between((x, 0.97, deck - 0.1), (x, 0.99, deck + 1.55), 0.05, BOX, material=metal, mirror=True)
    kit.add(BOX, (front + 0.08, 0, deck + 0.6), (0.04, 0.95, 0.75), material=metal, cut=(GRID, 5, 0.3))
    lights(kit, half + 0.05, end * 0.95, 0.4, floor, 0.06, False)


def camper(kit):
    rng = kit.rng
    coat, band, dark, tyre, metal = kit.material(base=rng.uniform(0.6, 0.85) * np.ones(3), pattern=PLAIN, gloss=0.3), car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    half, wide, radius, floor = rng.uniform(2.4, 3.3), rng.uniform(0.95, 1.08), 0.33, 0.42
    roof, belt = rng.uniform(2.4, 2.65), 1.25
    form = rng.choice(["alcove", "low", "liner"])
    body = half - (1.15 if form != "liner" else 0)
    section(kit, -half, body, (floor, roof, wide), (floor, roof, wide), coat)
    if form == "liner":
        slab(kit, belt, roof - 0.35, (half - 0.5, half + 0.02, wide * 0.9), (half - 0.5, half + 0.0, wide * 0.88), glazing(kit))
        section(kit, half - 0.1, half + 0.1, (floor, belt - 0.1, wide * 0.97), (floor, belt - 0.2, wide * 0.9), coat)
    else:
        dash = half - 0.55
        slab(kit, floor, belt, (body - 0.1, dash + 0.05, wide * 0.9), (body - 0.1, dash, wide * 0.88), coat)
        section(kit, dash - 0.1, half, (floor, belt, wide * 0.88), (floor, belt - 0.35, wide * 0.75), coat)
        slab(kit, belt - 0.05, belt + 0.62, (body - 0.05, dash, wide * 0.86), (body - 0.05, dash - 0.55, wide * 0.78), glazing(kit))
        kit.between((dash, wide * 0.86, belt - 0.03), (dash - 0.54, wide * 0.79, belt + 0.6), 0.035, BOX, material=coat, mirror=True)
        if form == "alcove":
            section(kit, body - 0.1, half - 0.35, (belt + 0.55, roof, wide), (belt + 0.75, roof - 0.2, wide * 0.92), coat)
            slab(kit, roof - 0.55, roof - 0.3, (body + 0.1, body + 0.5, wide * 1.0), (body + 0.1, body + 0.45, wide * 1.0), glazing(kit))
        else:
            section(kit, body - 0.05, dash - 0.3, (belt + 0.5, roof, wide * 0.97), (belt + 0.55, belt + 0.7, wide * 0.8), coat)
    for x, size in ((body - 0.8, 0.32), (-half * 0.15, 0.22), (-half * 0.72, 0.34)):
        kit.add(BOX, (x, 0, belt + 0.45), (size, wide * 1.005, 0.24), material=glazing(kit))
    kit.add(BOX, (-half, 0, belt + 0.45), (0.012, wide * 0.55, 0.25), material=glazing(kit))
    kit.add(BOX, (-half * 0.42, wide, 1.3), (0.32, 0.015, 0.85), material=kit.material(base=coat.first * 0.9, pattern=PLAIN))
    kit.add(BOX, ((body - half) / 2, 0, belt - 0.1), ((body + half) / 2 * 0.99, wide * 1.004, rng.uniform(0.04, 0.14)), material=band)
    for x in (half - 0.85, -half * 0.45):
        kit.add(CYL, (x, wide * 0.88, radius + 0.04), (radius * 1.15, radius * 1.15, 0.125), rotation=ALONG_Y, material=dark, mirror=True)
        rims(kit, x, wide * 0.88, radius, 0.13, tyre, metal)
    lights(kit, half - 0.05 + (0.15 if form == "liner" else 0), -half - 0.01, wide * 0.6, belt - 0.5, 0.1, False)
    kit.add(BOX, (half, 0, floor + 0.05), (0.12, wide * 0.8, 0.1), material=dark)
    kit.add(BOX, (half - 1.0, wide * 1.02, belt + 0.15), (0.06, 0.1, 0.16), material=dark, mirror=True)
    for x in rng.uniform(-half * 0.8, body * 0.8, 2):
        kit.add(BOX, (x, 0, roof + 0.05), (0.3, 0.3, 0.07), (0.85, 0.85), material=coat)
    kit.add(CYL, (0, wide * 0.96, roof - 0.02), (0.09, 0.09, half * 0.55), rotation=ALONG_X, material=metal)
    if kit.chance(0.5):
        kit.add(BOX, (0.1, wide + 0.85, roof - 0.12), (half * 0.5, 0.9, 0.015), rotation=turn("x", -8), material=kit.material(pattern=STRIPES))
        for x in (-half * 0.35, half * 0.45):
            kit.between((x, wide + 1.65, 0), (x, wide + 1.65, roof - 0.23), 0.025, material=metal)
    if kit.chance(0.4):
        kit.between((-half - 0.06, 0.55, 0.8), (-half - 0.06, 0.55, roof), 0.02, material=metal)
        kit.between((-half - 0.06, 0.3, 0.8), (-half - 0.06, 0.3, roof), 0.02, material=metal)
        kit.add(BOX, (-half - 0.06, 0.42, (roof + 0.8) / 2), (0.012, 0.13, (roof - 0.8) / 2), material=metal, cut=(RUNGS, 4, 0.15))


def caravan(kit):
    rng = kit.rng
    shiny = kit.chance(0.3)
    coat = kit.material(base=(0.5 if shiny else rng.uniform(0.6, 0.85)) * np.ones(3), pattern=rng.choice([PLAIN, RIBS]) if shiny else PLAIN, gloss=0.6 if shiny else 0.3)
    band, dark, tyre, metal = car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    half, wide, floor, roof = rng.uniform(1.5, 2.6), rng.uniform(0.85, 1.0), 0.42, rng.uniform(1.95, 2.3)
    middle, tall = (floor + roof) / 2, (roof - floor) / 2
    if kit.chance(0.45) or shiny:  # round ends
        kit.add(BOX, (0, 0, middle), (half * 0.8, wide, tall), (1, 0.94), material=coat)
        for x in (-half * 0.75, half * 0.75):
            kit.add(CYL, (x, 0, middle - tall * 0.1), (tall * 0.95, half * 0.38, wide * 0.98), rotation=ALONG_Y @ turn("z", 90), material=coat)
        kit.add(CYL, (0, 0, roof - 0.03), (0.16, wide * 0.85, half * 0.85), rotation=ALONG_X, material=coat)
    else:
        section(kit, -half * 0.75, half * 0.75, (floor, roof, wide), (floor, roof, wide), coat)
        section(kit, half * 0.7, half, (floor, roof, wide * 0.99), (floor + 0.25, roof - 0.5, wide * 0.96), coat)
        section(kit, -half, -half * 0.7, (floor + 0.15, roof - 0.25, wide * 0.96), (floor, roof, wide * 0.99), coat)
    for x in (half * 0.42, -half * 0.5):
        kit.add(BOX, (x, 0, middle + tall * 0.25), (half * 0.2, wide * 1.006, tall * 0.27), (1, 0.99), material=glazing(kit))
    for x in (half * 0.8, -half * 0.8):
        kit.add(BOX, (x + np.sign(x) * 0.11, 0, middle + tall * 0.15), (half * 0.14, wide * 0.7, tall * 0.25), material=glazing(kit))
    kit.add(BOX, (-half * 0.08, wide * 0.97, middle - 0.08), (0.28, 0.03, tall * 0.82), material=kit.material(base=coat.first * 0.85, pattern=PLAIN))
    kit.add(BOX, (-half * 0.08, wide * 0.98, middle + tall * 0.3), (0.18, 0.035, tall * 0.22), material=glazing(kit))
    kit.add(BOX, (0, 0, middle - tall * 0.35), (half * 0.76, wide * 1.006, rng.uniform(0.05, 0.16)), material=band)
    axles = [0] if half < 2.1 else [-0.38, 0.38]
    for x in axles:
        kit.add(CYL, (x, wide * 0.9, 0.34), (0.37, 0.37, 0.115), rotation=ALONG_Y, material=dark, mirror=True)
        rims(kit, x, wide * 0.9, 0.31, 0.12, tyre, metal)
    kit.between((half * 0.7, wide * 0.6, floor), (half + 0.85, 0.03, floor + 0.02), 0.045, BOX, material=dark, mirror=True)
    kit.add(BOX, (half + 0.9, 0, floor + 0.05), (0.14, 0.05, 0.05), material=metal)
    kit.between((half + 0.7, 0, floor + 0.2), (half + 0.7, 0, 0.08), 0.03, material=metal)
    kit.add(CYL, (half + 0.7, 0, 0.09), (0.09, 0.09, 0.04), rotation=ALONG_Y, material=dark)
    if kit.chance(0.6):
        kit.add(BOX, (half + 0.25, 0, floor + 0.22), (0.25, 0.35, 0.2), (0.85, 0.9), material=coat)
    else:
        for y in (-0.14, 0.14):
            kit.add(CYL, (half + 0.2, y, floor + 0.28), (0.13, 0.13, 0.26), material=kit.material())
    kit.add(BOX, (0.2, 0, roof + 0.04), (0.25, 0.25, 0.06), (0.85, 0.85), material=coat)
    kit.add(BOX, (-half * 0.97, wide * 0.75, floor + 0.3), (0.06, 0.08, 0.1), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN), mirror=True)
    for x in (half * 0.65, -half * 0.75):
        kit.between((x, wide * 0.75, floor), (x * 1.05, wide * 0.75, 0.0), 0.025, BOX, material=metal, mirror=True)
    kit.add(BOX, (-half * 0.08, wide + 0.15, 0.2), (0.25, 0.15, 0.2), material=dark)


def airport_tug(kit):
    rng = kit.rng
    coat, dark, tyre, metal = loud(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    half, wide, radius = rng.uniform(1.2, 1.9), rng.uniform(0.7, 0.95), rng.uniform(0.3, 0.42)
    floor, deck = radius * 0.55, rng.uniform(0.85, 1.05)
    slab(kit, floor, deck, (-half, half, wide), (-half * 0.97, half * 0.96, wide * 0.97), coat)
    for x in (half * 0.62, -half * 0.6):
        kit.add(CYL, (x, wide * 0.92, radius + 0.04), (radius * 1.15, radius * 1.15, 0.12), rotation=ALONG_Y, material=dark, mirror=True)
        rims(kit, x, wide * 0.92, radius, 0.13, tyre, metal)
    cab = rng.choice([half * 0.4, -half * 0.3])
    if kit.chance(0.55):
        glass_cab(kit, cab, 0, deck - 0.05, 0.5, wide * 0.8, rng.uniform(0.9, 1.2), coat, dark, 0.08)
    else:
        kit.add(BOX, (cab - 0.1, 0, deck), (0.45, wide * 0.85, 0.02), material=dark)
        seat(kit, cab - 0.15, wide * 0.4, deck, wide * 0.3, 0.45, hide(kit), True)
        kit.add(BOX, (cab + 0.45, 0, deck + 0.12), (0.12, wide * 0.85, 0.15), material=coat)
        steering(kit, cab + 0.25, wide * 0.4, deck + 0.38, dark)
    warn = kit.material(base=[0.8, 0.6, 0.05], pattern=STRIPES, frequency=16, second=[0.03] * 3)
    for x in (half, -half):
        kit.add(BOX, (x, 0, floor + 0.12), (0.08, wide * 0.98, 0.12), material=warn)
    lights(kit, half * 0.98, -half * 1.0, wide * 0.7, deck - 0.22, 0.09)
    kit.add(CYL, (cab - 0.3, 0, deck + 0.02), (0.07, 0.07, 0.1), material=kit.material(base=[0.8, 0.35, 0.02], pattern=PLAIN, gloss=-0.5))
    kit.between((-half, 0, 0.4), (-half - 0.4, 0, 0.4), 0.04, BOX, material=dark)
    x = -half - 0.45
    if half < 1.6:
        for _ in range(int(rng.integers(0, 3))):
            long = 0.85
            middle = x - 0.3 - long
            kit.between((x, 0, 0.4), (middle, 0, 0.42), 0.035, BOX, material=dark)
            kit.add(BOX, (middle, 0, 0.45), (long, 0.6, 0.05), material=metal)
            for dx in (-0.55, 0.55):
                rims(kit, middle + dx, 0.5, 0.2, 0.06, tyre, metal)
            for dx in (-long + 0.03, long - 0.03):
                kit.add(BOX, (middle + dx, 0, 0.85), (0.02, 0.6, 0.4), material=metal, cut=(BARS, 6, 0.3))
            for _ in range(int(rng.integers(2, 6))):
                size = rng.uniform(0.15, 0.3, 3)
                kit.add(BOX, (middle + rng.uniform(-0.5, 0.5), rng.uniform(-0.25, 0.25), 0.5 + size[2]), size, material=kit.material())
            x = middle - long


def airport_stairs(kit):
    rng = kit.rng
    coat, dark, tyre, metal = car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    half, wide, radius = rng.uniform(2.0, 2.5), 0.85, 0.36
    truck = kit.chance(0.65)
    kit.add(BOX, (0, 0, 0.6), (half, wide * 0.75, 0.13), material=coat)
    for x in (half * 0.7, -half * 0.65):
        rims(kit, x, wide * 0.85, radius, 0.12, tyre, metal)
        kit.between((x, -wide * 0.8, radius), (x, wide * 0.8, radius), 0.06, material=dark)
    high = rng.uniform(2.4, 3.4)
    foot, top = np.array([-half - 0.1, 0, 0.35]), np.array([half * 0.55, 0, high])
    if truck:
        slab(kit, 0.4, 1.05, (half * 0.45, half + 0.15, wide), (half * 0.45, half + 0.1, wide), coat)
        slab(kit, 1.05, 1.6, (half * 0.45, half + 0.1, wide * 0.95), (half * 0.48, half - 0.1, wide * 0.85), glazing(kit))
        kit.add(BOX, (half * 0.74, 0, 1.62), (half * 0.26, wide * 0.9, 0.04), material=coat)
        lights(kit, half + 0.15, -half - 0.02, wide * 0.7, 0.75, 0.09)
    count = 11
    length = np.linalg.norm(top - foot)
    for side in (-1, 1):
        y = np.array([0, side * wide * 0.72, 0])
        kit.between(foot + y, top + y, (0.13, 0.03), BOX, material=coat)
        rail = y + np.array([0, 0, 0.9])
        kit.between(foot + rail, top + rail, 0.03, material=metal)
        pitch = turn("y", -np.degrees(np.arctan2(top[2] - foot[2], top[0] - foot[0])))
        panel = (BARS, 2.5, 0.12) if kit.chance(0.6) else (0, 1, 1)
        kit.add(BOX, (foot + top) / 2 + y + [0, 0, 0.42], (length / 2, 0.012, 0.36), rotation=pitch, material=metal if panel[0] else coat, cut=panel)
        kit.between(top + rail, top + rail + [0.95, 0, 0], 0.03, material=metal)
        kit.add(BOX, top + y + [0.47, 0, 0.45], (0.47, 0.012, 0.42), material=coat)
    for k in range(count):
        at = foot + (top - foot) * (k + 0.5) / count
        kit.add(BOX, at, (length / count * 0.5, wide * 0.72, 0.02), material=metal)
    kit.add(BOX, top + [0.45, 0, 0], (0.55, wide * 0.75, 0.05), material=metal)
    kit.add(BOX, top + [1.02, 0, 0.0], (0.06, wide * 0.8, 0.12), material=dark)
    for x in (-half * 0.3, half * 0.3):
        z = foot[2] + (top[2] - foot[2]) * (x - foot[0]) / (top[0] - foot[0])
        kit.between((x, wide * 0.6, 0.65), (x, wide * 0.6, z), 0.05, BOX, material=coat, mirror=True)
    kit.between((half * 0.4, wide * 0.55, 0.65), top + [0.3, wide * 0.55, 0], 0.05, BOX, material=coat, mirror=True)
    if kit.chance(0.3):
        kit.add(BOX, (foot + top) / 2 + [0.3, 0, 2.1], (length / 2 + 0.5, wide * 0.85, 0.03), rotation=pitch, material=coat)
        for share in (0.12, 0.92):
            at = foot + (top - foot) * share
            kit.between(at + [0, wide * 0.72, 0.3], at + [0, wide * 0.78, 2.05], 0.03, material=metal, mirror=True)


def articulated_bus(kit):
    rng = kit.rng
    coat, second, dark, tyre, metal = car_paint(kit), car_paint(kit), kit.material(dark=True), rubber(kit), chrome(kit)
    wide, floor, roof, radius = rng.uniform(0.98, 1.1), 0.28, rng.uniform(2.35, 2.6), 0.42
    front, rear = rng.uniform(4.0, 4.8), -rng.uniform(3.4, 4.2)
    bend = np.radians(rng.choice([0, rng.uniform(-20, 20)]))
    spin = turn("z", np.degrees(bend))
    belt = floor + (roof - floor) * 0.45
    window = kit.material(base=[0.04, 0.05, 0.06], pattern=PLAIN, gloss=0.5)
    bellows = kit.material(base=[0.04] * 3, pattern=RIBS, frequency=30, second=[0.12] * 3)
    first = len(kit.primitives)

    def half_bus(x0, x1, count):
        slab(kit, floor, roof, (x0, x1, wide), (x0, x1 - 0.04, wide * 0.97), coat)
        for k in range(count):
            x, share = x0 + (x1 - x0) * (k + 0.5) / count, (x1 - x0) / count * 0.45
            kit.add(BOX, (x, 0, (belt + roof) / 2 - 0.12), (share, wide * 1.0, (roof - belt) / 2 - 0.14), (1, 0.985), material=window)
        kit.add(BOX, ((x0 + x1) / 2, 0, floor + 0.3), ((x1 - x0) / 2, wide * 1.004, 0.09), material=second)
        kit.add(BOX, ((x0 + x1) / 2, 0, roof + 0.08), ((x1 - x0) * 0.35, wide * 0.7, 0.1), (0.95, 0.85), material=coat if kit.chance(0.6) else metal)

    half_bus(rear, -0.35, 4)
    kit.add(BOX, (rear, 0, (belt + roof) / 2), (0.012, wide * 0.8, (roof - belt) * 0.35), material=window)
    kit.add(BOX, (rear - 0.01, wide * 0.9, belt - 0.3), (0.03, 0.05, 0.2), material=kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN), mirror=True)
    kit.add(CYL, (rear * 0.45, wide * 0.88, radius + 0.03), (radius * 1.13, radius * 1.13, 0.13), rotation=ALONG_Y, material=dark, mirror=True)
    rims(kit, rear * 0.45, wide * 0.88, radius, 0.14, tyre, metal)
    kit.primitives[first:] = [p._replace(centre=spin @ p.centre, rotation=spin @ p.rotation) for p in kit.primitives[first:]]
    kit.add(CYL, (0, 0, (floor + roof) / 2), (wide * 0.72, wide * 0.95, (roof - floor) / 2 * 0.97), rotation=turn("z", np.degrees(bend / 2)), material=bellows)
    half_bus(0.35, front, 5)
    slab(kit, belt - 0.25, roof - 0.1, (front - 0.3, front + 0.012, wide * 0.9), (front - 0.3, front - 0.028, wide * 0.87), window)
    sign = kit.material(base=[0.03] * 3, pattern=WRITING, frequency=14, second=[0.9, 0.6, 0.1])
    kit.add(BOX, (front - 0.01, 0, roof - 0.14), (0.035, wide * 0.7, 0.11), material=sign)
    for x in (front * 0.78, front * 0.25):
        kit.add(CYL, (x, wide * 0.88, radius + 0.03), (radius * 1.13, radius * 1.13, 0.13), rotation=ALONG_Y, material=dark, mirror=True)
        rims(kit, x, wide * 0.88, radius, 0.14, tyre, metal)
    for x in (front * 0.92, front * 0.52):
        kit.add(BOX, (x, -wide * 0.99, (floor + roof) / 2 - 0.05), (0.32, 0.025, (roof - floor) * 0.42), material=window)
        kit.add(BOX, (x, -wide * 1.0, (floor + roof) / 2 - 0.05), (0.015, 0.03, (roof - floor) * 0.42), material=metal)
    kit.add(BOX, (front, wide * 0.72, floor + 0.45), (0.03, 0.15, 0.07), material=kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN), mirror=True)
    kit.add(BOX, (front, 0, floor + 0.1), (0.06, wide * 0.97, 0.12), material=second)
    kit.between((front - 0.05, wide * 0.95, roof - 0.2), (front + 0.25, wide * 1.1, roof - 0.35), 0.02, material=dark, mirror=True)
    kit.add(BOX, (front + 0.25, wide * 1.1, roof - 0.5), (0.05, 0.08, 0.17), material=dark, mirror=True)
