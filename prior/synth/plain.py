"""Makers of what fills its bounding box or has few parts, each in its right proportion: containers, houses without
additions, articulated lorries, pick-ups, light aeroplanes."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL
from .materials import BRICKS, CLOUDY, FACADE, PLAIN, PLANKS, RIBS, SEAMS, STREAKS, WRITING
from .structures import roof_material, wall_material
from .vehicles import wheels


def container(kit):
    """Freight containers, cabins, crates, cabinets: ribbed or smooth, with corner posts, doors and their bars."""
    rng = kit.rng
    half_y = rng.uniform(0.9, 1.3)
    half_x = half_y * np.exp(rng.uniform(-0.3, 1.7))
    half_z = half_y * np.exp(rng.uniform(-0.3, 0.35))
    pattern = rng.choice([RIBS, RIBS, PLAIN, SEAMS, PLANKS, STREAKS, CLOUDY, WRITING])
    paint = kit.material(pattern=pattern, frequency=np.exp(rng.uniform(1.2, 3.2)) if pattern == RIBS else None)
    kit.add(BOX, (0, 0, half_z), (half_x, half_y, half_z), material=paint)
    if kit.chance(0.65):
        post, frame = rng.uniform(0.04, 0.1), kit.material(base=paint.first * rng.uniform(0.5, 1.3), pattern=PLAIN)
        for x in (-half_x, half_x):
            kit.add(BOX, (x, half_y, half_z), (post, post, half_z * 1.01), material=frame, mirror=True)
        if kit.chance(0.7):
            for z in (post, 2 * half_z - post):
                kit.add(BOX, (0, half_y, z), (half_x, post, post), material=frame, mirror=True)
                for x in (-half_x, half_x):
                    kit.add(BOX, (x, 0, z), (post, half_y, post), material=frame)
    if kit.chance(0.6):
        bar = kit.material(base=[0.5, 0.5, 0.5])
        for y in (0.25, 0.7):
            kit.add(CYL, (half_x + 0.03, y * half_y, half_z), (0.03, 0.03, half_z * 0.93), material=bar, mirror=True)
    if kit.chance(0.25):  # a door and windows: a cabin
        dark = kit.material(dark=True, gloss=0.4)
        kit.add(BOX, (half_x * rng.uniform(-0.6, 0.6), half_y, half_z * 0.8), (0.35, 0.02, half_z * 0.8), material=kit.material())
        for x in (-0.5, 0.5):
            kit.add(BOX, (x * half_x, half_y, half_z * 1.2), (half_x * 0.2, 0.02, half_z * 0.3), material=dark, mirror=kit.chance(0.6))


def plain_house(kit):
    """Walls and a steep or flat roof with nothing on it; windows painted or set into all sides alike."""
    rng = kit.rng
    half_x, half_y = rng.uniform(1.2, 3.0), rng.uniform(0.8, 1.6)
    height, rise = rng.uniform(0.7, 2.2), half_y * rng.uniform(0.5, 1.7)
    walls, roof = wall_material(kit), roof_material(kit)
    if kit.chance(0.35):
        walls = kit.material(base=walls.first, pattern=rng.choice([FACADE, BRICKS]))
    kit.add(BOX, (0, 0, height / 2), (half_x, half_y, height / 2), material=walls)
    if kit.chance(0.5):
        base = kit.material(base=walls.first * rng.uniform(0.3, 0.8), pattern=PLAIN)
        kit.add(BOX, (0, 0, 0.12), (half_x * 1.01, half_y * 1.01, 0.12), material=base)
    over = rng.uniform(1.0, 1.12)
    if kit.chance(0.75):
        kit.add(BOX, (0, 0, height + rise / 2), (half_x, half_y, rise / 2), (1, 0.02), material=walls)
        slope = np.arctan2(rise, half_y)
        for side in (-1, 1):
            long = half_y * over / np.cos(slope) / 2
            middle = (0, side * half_y * over / 2, height + rise - rise * over / 2 + 0.03)
            kit.add(BOX, middle, (half_x * over, long, 0.04), rotation=turn("x", -side * np.degrees(slope)), material=roof)
    elif kit.chance(0.6):
        kit.add(BOX, (0, 0, height + rise / 2), (half_x * over, half_y * over, rise / 2), (rng.uniform(0.3, 0.7), 0.02), material=roof)
    else:
        kit.add(BOX, (0, 0, height + 0.08), (half_x * over, half_y * over, 0.08), material=roof)
    glass, count = kit.material(dark=True, gloss=0.4), int(rng.integers(2, 6))
    size = (half_x * 0.4 / count, height * rng.uniform(0.15, 0.25))
    rows = [0.55] if height < 1.4 else [0.3, 0.75]
    for z in rows:
        for i in range(count):
            x = half_x * (2 * (i + 0.5) / count - 1)
            kit.add(BOX, (x, half_y, z * height), (size[0], 0.03, size[1]), material=glass, mirror=True)
        for x in (-half_x, half_x):
            for y in (-0.4, 0.4):
                kit.add(BOX, (x, y * half_y, z * height), (0.03, size[0], size[1]), material=glass)
    if kit.chance(0.6):
        kit.add(BOX, (half_x * rng.uniform(-0.5, 0.5), half_y, height * 0.35), (0.2, 0.04, height * 0.35), material=kit.material())


def articulated(kit):
    """A tractor with a long trailer: box, tank or flat with a container."""
    rng = kit.rng
    width, wheel, long = rng.uniform(0.9, 1.15), rng.uniform(0.38, 0.5), rng.uniform(3.2, 5.2)
    bed, high = 2.2 * wheel, rng.uniform(0.9, 1.4)
    cab, chassis = kit.material(), kit.material(dark=True)
    load = cab if kit.chance(0.4) else kit.material()
    nose = long + 0.35
    cab_high = bed * 0.35 + high * rng.uniform(0.65, 0.85)
    kit.add(BOX, (nose + 0.75, 0, wheel + cab_high), (0.75, width, cab_high), (rng.uniform(0.8, 0.97), 0.95), (-0.1, 0), material=cab)
    glass = kit.material(base=[0.05, 0.06, 0.08], gloss=0.5)
    kit.add(BOX, (nose + 0.8, 0, wheel + cab_high * 1.4), (0.72, width * 1.01, cab_high * 0.28), (0.92, 0.97), material=glass)
    if kit.chance(0.6):
        kit.add(BOX, (nose + 0.4, 0, wheel + 2 * cab_high + 0.15), (0.4, width * 0.9, 0.2), (0.4, 0.9), (-0.2, 0), material=cab)
    kit.add(BOX, (nose + 1.5, 0, wheel * 1.1), (0.06, width, 0.18), material=chassis if kit.chance(0.5) else cab)
    kit.add(BOX, (long * 0.1, 0, bed * 0.85), (long * 1.15, width * 0.45, 0.12), material=chassis)
    kind = rng.random()
    if kind < 0.6:
        kit.add(BOX, (-0.05, 0, bed + high), (long, width * 1.03, high), material=load)
    elif kind < 0.8:
        kit.add(CYL, (-0.05, 0, bed + width), (width, width, long), rotation=ALONG_X, material=load)
    else:
        kit.add(BOX, (-0.05, 0, bed), (long, width * 1.02, 0.08), material=chassis)
        kit.add(BOX, (-0.3, 0, bed + high * 0.8), (long * rng.uniform(0.5, 0.9), width, high * 0.8), material=load)
    axles = [-long * 0.95 + wheel + i * 2.15 * wheel for i in range(int(rng.integers(2, 4)))]
    wheels(kit, [*axles, nose + 0.9, long * 0.62], width * 0.9, wheel, 0.15)
    if kit.chance(0.5):
        kit.add(BOX, (-long * 0.1, width * 0.95, bed * 0.6), (long * 0.35, 0.04, bed * 0.25), material=chassis, mirror=True)


def pickup(kit):
    """Bonnet, cab with upright or leaning screen, bed open or under a cover, wheels under arches; roll bars, spare wheel."""
    rng = kit.rng
    width, wheel = rng.uniform(0.85, 1.15), rng.uniform(0.36, 0.52)
    sill, body = wheel * rng.uniform(0.75, 1.2), rng.uniform(0.26, 0.42)
    front, rear = rng.uniform(0.9, 1.3), rng.uniform(0.7, 1.5)
    cab = rng.uniform(0.5, 0.9)
    paint, dark = kit.material(), kit.material(dark=True)
    top = sill + 2 * body
    kit.add(BOX, (cab + front / 2, 0, sill + body * 0.95), (front / 2, width, body * 0.95), (0.95, 0.9), material=paint)
    kit.add(BOX, (0, 0, sill + body), (cab, width, body), material=paint)
    floor = sill + body * 0.7
    kit.add(BOX, (-cab - rear / 2, 0, floor), (rear / 2, width, body * 0.5), material=paint)
    for y in (-1, 1):
        kit.add(BOX, (-cab - rear / 2, y * width * 0.96, sill + body), (rear / 2, width * 0.05, body), material=paint)
    kit.add(BOX, (-cab - rear, 0, sill + body), (0.05, width, body), material=paint)
    high = rng.uniform(0.25, 0.42)
    if kit.chance(0.65):
        taper = (rng.uniform(0.6, 0.95), rng.uniform(0.8, 0.95))
        kit.add(BOX, (-0.05, 0, top + high), (cab * 0.95, width * 0.93, high), taper, (-0.1, 0), material=paint)
        glass = kit.material(base=[0.05, 0.06, 0.07], gloss=0.5)
        kit.add(BOX, (-0.05, 0, top + high * 0.95), (cab * 0.965, width * 0.8, high * 0.72), taper, (-0.1, 0), material=glass)
        kit.add(BOX, (-0.05, 0, top + high * 0.95), (cab * 0.75, width * 0.945, high * 0.72), taper, (-0.1, 0), material=glass)
    else:  # open: a screen's frame and a roll bar
        for x in (cab * 0.85, -cab * 0.85):
            kit.between((x, width * 0.85, top), (x - 0.08, width * 0.8, top + 2 * high), 0.04, BOX, material=paint, mirror=True)
            kit.add(BOX, (x - 0.08, 0, top + 2 * high), (0.04, width * 0.84, 0.04), material=paint)
        for y in (-0.45, 0.45):
            kit.add(BOX, (-0.2, y * width, top), (0.25, width * 0.3, 0.2), material=dark)
    kind = rng.random()
    if kind < 0.3:
        kit.add(BOX, (-cab - rear / 2, 0, top + high * 0.8), (rear / 2, width * 0.95, high * 0.8), (1, 0.85), material=kit.material())
    elif kind < 0.5:
        kit.add(CYL, (-cab - rear * 0.5, 0, top), (wheel, wheel, 0.12), material=dark)
    kit.add(BOX, (cab + front + 0.04, 0, sill + body * 0.5), (0.08, width * 0.98, 0.12), material=dark)
    lamp = kit.material(base=[0.8, 0.8, 0.75])
    kit.add(CYL, (cab + front, 0.7 * width, sill + body * 1.2), (0.12, 0.12, 0.04), rotation=ALONG_X, material=lamp, mirror=True)
    if kit.chance(0.5):
        for x in (cab + front * 0.4, -cab - rear * 0.5):
            kit.add(BOX, (x, width * 0.97, wheel * 1.95), (wheel * 1.25, 0.12, 0.06), material=dark, mirror=True)
    wheels(kit, (cab + front * 0.4, -cab - rear * 0.5), width * 0.92, wheel, rng.uniform(0.12, 0.2))


def light_plane(kit):
    """A light aeroplane: rounded fuselage, bubble or cabin, thin low or high wing with dihedral, tail, fixed wheels."""
    rng = kit.rng
    radius, long = rng.uniform(0.28, 0.42), rng.uniform(2.0, 3.0)
    paint, trim = kit.material(), kit.material()
    glass = kit.material(base=[0.05, 0.07, 0.09], gloss=0.5)
    profile = [(0, 0.45), (0.1, 0.8), (0.28, 1.0), (0.5, 0.95), (0.75, 0.55), (1.0, 0.2)]
    nose = np.array([long * 0.45, 0, 0])
    back = turn("y", -90)
    kit.loft(nose, [(z * long, r * radius) for z, r in profile], paint, axis=back, flat=rng.uniform(0.75, 1.0))
    middle = long * rng.uniform(0.0, 0.12)
    kit.add(BALL, (middle - 0.15, 0, radius * 0.75), (long * 0.2, radius * 0.75, radius * 0.65), material=glass)
    high = kit.chance(0.4)
    level = radius * 1.25 if high else -radius * 0.55
    span, chord = rng.uniform(1.7, 2.8), rng.uniform(0.32, 0.5)
    rise = span * (rng.uniform(-0.01, 0.04) if high else rng.uniform(0.03, 0.11))
    wing = paint if kit.chance(0.5) else trim
    for side in (-1, 1):
        half = np.array([chord, span / 2, 0.035])
        lift = turn("x", side * np.degrees(np.arctan2(rise, span)))
        kit.add(BOX, (middle, side * span / 2, level + rise / 2), half, rotation=lift, material=wing)
        if kit.chance(0.4) or side > 0:
            kit.add(BOX, (middle, side * span * 0.96, level + rise), (chord * 0.95, span * 0.05, 0.05), rotation=lift, material=trim)
    if high and kit.chance(0.7):
        kit.between((middle, radius * 0.8, -radius * 0.6), (middle, span * 0.5, level), 0.03, material=paint, mirror=True)
    tail = -long * 0.52
    tail_z = rng.choice([0.1, 0.1, 0.85])
    kit.add(BOX, (tail, 0, tail_z), (chord * 0.6, span * rng.uniform(0.28, 0.38), 0.025), (0.8, 1), material=wing)
    kit.add(BOX, (tail - 0.02, 0, 0.5), (chord * 0.6, 0.025, 0.42), (rng.uniform(0.45, 0.8), 1), (-0.25, 0), material=trim if kit.chance(0.5) else paint)
    wheel = rng.uniform(0.12, 0.18)
    under = -radius - rng.uniform(0.15, 0.35)
    kit.between((middle - 0.1, 0.25, -radius * 0.6), (middle - 0.1, 0.6, under), 0.03, material=paint, mirror=True)
    kit.add(CYL, (middle - 0.1, 0.6, under), (wheel, wheel, 0.05), rotation=ALONG_Y, material=kit.material(dark=True), mirror=True)
    fore = long * 0.35 if kit.chance(0.6) else tail
    kit.add(CYL, (fore, 0, under if fore > 0 else -0.2), (wheel * 0.8, wheel * 0.8, 0.04), rotation=ALONG_Y, material=kit.material(dark=True))
    if fore > 0:
        kit.between((fore, 0, -radius * 0.5), (fore, 0, under), 0.025, material=paint)
    blade = turn("x", rng.uniform(0, 180))
    kit.add(BOX, (long * 0.45 + 0.08, 0, 0), (0.015, 0.05, rng.uniform(0.5, 0.7)), rotation=blade, material=kit.material(dark=True))
    kit.add(CYL, (long * 0.45 + 0.06, 0, 0), (0.09, 0.09, 0.1), (0.2, 1), rotation=ALONG_X, material=trim)
