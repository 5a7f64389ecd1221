"""Makers of things on wheels and tracks."""

import numpy as np

from .kit import ALONG_X, ALONG_Y
from .layout import BOX, CYL


def wheels(kit, xs, y, radius, width):
    """A pair of wheels with hubs at every x."""
    tyre = kit.material(dark=True)
    hub = kit.material()
    for x in xs:
        kit.add(CYL, (x, y, radius), (radius, radius, width), rotation=ALONG_Y, material=tyre, mirror=True)
        hub_centre = (x, y + width * 0.6, radius)
        hub_half = (radius * 0.55, radius * 0.55, width * 0.6)
        kit.add(CYL, hub_centre, hub_half, rotation=ALONG_Y, material=hub, mirror=True)


def car(kit):
    rng = kit.rng
    length = rng.uniform(1.6, 2.6)
    width = rng.uniform(0.75, 1.05)
    height = rng.uniform(0.25, 0.5)
    wheel = rng.uniform(0.28, 0.42)
    sill = wheel * rng.uniform(0.6, 1)
    paint = kit.material()
    glass = kit.material(base=np.array([0.05, 0.07, 0.09]) + rng.uniform(0, 0.15))
    body_taper = (rng.uniform(0.92, 1), rng.uniform(0.9, 1))
    kit.add(BOX, (0, 0, sill + height), (length, width, height), body_taper, material=paint)
    car_cabin(kit, length, width, sill + 2 * height, paint, glass)
    wheels(kit, (length * 0.62, -length * 0.62), width * 0.93, wheel, rng.uniform(0.1, 0.16))
    lamp_z = sill + height * 1.2
    lamp_half = (0.05, width * 0.18, height * 0.25)
    head = kit.material(base=np.array([0.9, 0.9, 0.8]))
    kit.add(BOX, (length, width * 0.7, lamp_z), lamp_half, material=head, mirror=True)
    tail = kit.material(base=np.array([0.6, 0.05, 0.05]))
    kit.add(BOX, (-length, width * 0.7, lamp_z), lamp_half, material=tail, mirror=True)
    bumper_centre = (length * rng.choice([1, -1]), 0, sill + height * 0.5)
    bumper = kit.material(dark=True)
    kit.add(BOX, bumper_centre, (0.1, width * 0.95, height * 0.3), material=bumper)


def car_cabin(kit, length, width, base, paint, glass):
    """Cabin on the body whose top is at `base`, with glass on its sides and its ends."""
    rng = kit.rng
    half_length = length * rng.uniform(0.4, 0.7)
    x = length * rng.uniform(-0.35, 0.15)
    half_height = rng.uniform(0.22, 0.4)
    taper = (rng.uniform(0.5, 0.85), rng.uniform(0.7, 0.92))
    shift = (rng.uniform(-0.15, 0.1), 0)
    glass_z = base + half_height * 0.92
    glass_height = half_height * 0.72
    kit.add(BOX, (x, 0, base + half_height), (half_length, width * 0.92, half_height), taper, shift, material=paint)
    sides = (half_length * 0.86, width * 0.935, glass_height)
    kit.add(BOX, (x, 0, glass_z), sides, taper, shift, material=glass)
    ends = (half_length * 1.01, width * 0.8, glass_height)
    kit.add(BOX, (x, 0, glass_z), ends, taper, shift, material=glass)


def truck(kit):
    rng = kit.rng
    length = rng.uniform(2.5, 5)
    width = rng.uniform(0.9, 1.3)
    wheel = rng.uniform(0.4, 0.6)
    frame = wheel * 1.3
    paint = kit.material()
    kit.add(BOX, (0, 0, frame), (length, width * 0.8, 0.15), material=kit.material(dark=True))
    cab_height = rng.uniform(0.8, 1.2)
    cab_length = rng.uniform(0.7, 1)
    cab_x = length - cab_length
    cab_taper = (rng.uniform(0.75, 1), 0.95)
    cab_shift = (rng.uniform(-0.2, 0), 0)
    cab_half = (cab_length, width, cab_height)
    kit.add(BOX, (cab_x, 0, frame + cab_height), cab_half, cab_taper, cab_shift, material=paint)
    glass_half = (cab_length * 0.98, width * 1.01, cab_height * 0.35)
    glass = kit.material(base=np.array([0.06, 0.08, 0.1]))
    kit.add(BOX, (cab_x + 0.04, 0, frame + cab_height * 1.35), glass_half, (0.85, 0.95), material=glass)
    truck_load(kit, cab_length, length - cab_length - 0.1, width, frame)
    axles = rng.integers(2, 5)
    rear = list(np.linspace(-length * 0.9, -length * 0.1, axles)[: axles - 1])
    wheels(kit, [cab_x] + rear, width * 0.92, wheel, 0.2)


def truck_load(kit, cab_length, bed, width, frame):
    """Box body, tank or open bed with goods, `bed` its half length."""
    rng = kit.rng
    material = kit.material()
    kind = rng.random()
    if kind < 0.45:
        centre = (-cab_length, 0, frame + 0.15 + rng.uniform(0.8, 1.5))
        half = (bed, width * 1.02, rng.uniform(0.8, 1.4))
        kit.add(BOX, centre, half, (1, rng.uniform(0.8, 1)), material=material)
    elif kind < 0.7:
        centre = (-cab_length, 0, frame + 0.15 + width * 0.85)
        kit.add(CYL, centre, (width * 0.85, width * 0.95, bed), rotation=ALONG_X, material=material)
    else:
        for y in (-width, width):
            kit.add(BOX, (-cab_length, y, frame + 0.5), (bed, 0.06, 0.35), material=material)
        kit.add(BOX, (-cab_length, 0, frame + 0.2), (bed, width, 0.08), material=material)
        for _ in range(rng.integers(0, 4)):
            x = -cab_length + rng.uniform(-0.7, 0.7) * bed
            y = rng.uniform(-0.4, 0.4) * width
            kit.add(BOX, (x, y, frame + 0.6), rng.uniform(0.2, 0.5, 3))


def tank(kit):
    rng = kit.rng
    length = rng.uniform(2.5, 3.5)
    width = rng.uniform(1.2, 1.7)
    height = rng.uniform(0.4, 0.6)
    hues = [[0.3, 0.32, 0.2], [0.55, 0.47, 0.33], [0.25, 0.27, 0.25], [0.4, 0.36, 0.25]]
    paint = kit.material(base=np.array(rng.choice(hues)) * rng.uniform(0.6, 1.2))
    paint = paint._replace(pattern=int(rng.choice([0, 1, 5])))
    hull_taper = (rng.uniform(0.7, 0.95), 0.95)
    hull_shift = (rng.uniform(-0.3, 0.3), 0)
    hull_half = (length, width * 0.7, height)
    kit.add(BOX, (0, 0, 0.55 + height), hull_half, hull_taper, hull_shift, material=paint)
    tank_tracks(kit, length, width, paint)
    tank_turret(kit, width, 0.55 + 2 * height, paint)
    for _ in range(rng.integers(0, 5)):
        x = rng.uniform(-1, 1) * length * 0.8
        y = rng.choice([-1, 1]) * width * rng.uniform(0.5, 0.9)
        kit.add(BOX, (x, y, 1.15), rng.uniform(0.08, 0.35, 3), material=paint)


def tank_tracks(kit, length, width, paint):
    """Tracks with rounded ends under a fender, both sides."""
    track = kit.material(dark=True)
    for y in (-width * 0.85, width * 0.85):
        kit.add(BOX, (0, y, 0.5), (length * 0.85, 0.25, 0.42), material=track)
        kit.add(CYL, (length * 0.85, y, 0.5), (0.42, 0.42, 0.25), rotation=ALONG_Y, material=track)
        kit.add(CYL, (-length * 0.85, y, 0.5), (0.42, 0.42, 0.25), rotation=ALONG_Y, material=track)
        kit.add(BOX, (0, y, 1.0), (length * 0.98, 0.3, 0.06), material=paint)


def tank_turret(kit, width, base, paint):
    """Turret standing at height `base`, with its gun and hatch."""
    rng = kit.rng
    x = rng.uniform(-0.4, 0.5)
    if rng.random() < 0.6:
        half = (rng.uniform(0.9, 1.5), width * 0.62, 0.38)
        taper = (rng.uniform(0.6, 0.95), rng.uniform(0.6, 0.9))
        kit.add(BOX, (x, 0, base + 0.35), half, taper, material=paint)
    else:
        taper = (rng.uniform(0.6, 0.9), 1)
        kit.add(CYL, (x, 0, base + 0.3), (1.1, width * 0.65, 0.35), taper, material=paint)
    gun = rng.uniform(1.2, 2.2)
    kit.add(CYL, (x + 1 + gun, 0, base + 0.4), (0.09, 0.09, gun), rotation=ALONG_X, material=paint)
    kit.add(CYL, (x - 0.3, 0.4, base + 0.8), (0.3, 0.3, 0.12), material=paint)


def bus(kit):
    rng = kit.rng
    length = rng.uniform(2.8, 5.5)
    width = rng.uniform(0.95, 1.25)
    height = rng.uniform(0.9, 1.7)
    wheel = rng.uniform(0.35, 0.5)
    paint = kit.material()
    glass = kit.material(base=np.array([0.06, 0.08, 0.1]) * rng.uniform(0.6, 2))
    z = wheel * 0.9 + height
    kit.add(BOX, (0, 0, z), (length, width, height), (rng.uniform(0.95, 1), rng.uniform(0.9, 1)), material=paint)
    bus_windows(kit, length, width, height, z, glass)
    stripe_z = z - height * rng.uniform(0.1, 0.8)
    stripe_half = (length * 1.005, width * 1.01, height * rng.uniform(0.03, 0.12))
    kit.add(BOX, (0, 0, stripe_z), stripe_half, material=kit.material())
    if rng.random() < 0.4:
        x = rng.uniform(-0.5, 0.5) * length
        kit.add(BOX, (x, 0, z + height + 0.12), (length * rng.uniform(0.1, 0.4), width * 0.5, 0.14))
    axles = (length * rng.uniform(0.5, 0.7), -length * rng.uniform(0.45, 0.7))
    wheels(kit, axles, width * 0.95, wheel, 0.16)


def bus_windows(kit, length, width, height, z, glass):
    """One or two rows of side windows (a tall bus has two decks), and the front and rear panes."""
    rng = kit.rng
    decks = [(0.45, 0.2), (-0.35, 0.2)] if height > 1.35 else [(0.35, 0.3)]
    for level, size in decks:
        row_z = z + height * level
        half_height = height * size
        count = int(rng.integers(1, 6))
        for i in range(count):
            x = length * ((2 * i + 1) / count - 1) * 0.93
            kit.add(BOX, (x, 0, row_z), (length * 0.86 / count, width * 1.012, half_height), material=glass)
        kit.add(BOX, (length * 0.01, 0, row_z), (length * 1.006, width * 0.85, half_height), material=glass)
