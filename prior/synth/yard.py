"""Makers of what stands in yards and harbours: concrete mixers, bins and letter boxes, sailing boats with open hulls, spacecraft."""

import numpy as np

from .belongings import black, brass, pale, steel
from .boats import canvas, crew, timber
from .fittings import bent, box, disc, iron, near, pick, planks, posts, rod
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, LATTICE, PRISM, RUNGS, SPOKES, TUBE
from .materials import BANDS, CHECKER, CLOUDY, PATCHWORK, PLAIN, RIBS, SEAMS, STREAKS, STRIPES, WRITING
from .roadcraft import rims, slab
from .toys import bright


def worn_paint(kit, *bases):
    """Machine paint with cement or rust on it."""
    return near(kit, *bases, pattern=kit.rng.choice([PLAIN, PLAIN, STREAKS, CLOUDY]), gloss=kit.rng.uniform(0.02, 0.3))


# Concrete mixers.


def concrete_mixer(kit):
    """Tilting drum mixers: small ones with two wheels and stand legs, towed ones with a motor house, and ones on a tub stand."""
    pick(kit, [small_mixer, small_mixer, small_mixer, towed_mixer])


def drum(kit, at, axis, radius, paint, dark, metal):
    """A drum of two cones around `at` with an open mouth, paddles and a ring gear."""
    rng = kit.rng
    back, waist, neck = radius * rng.uniform(0.75, 0.9), radius * rng.uniform(0.25, 0.4), radius * rng.uniform(0.8, 1.0)
    mouth = radius * rng.uniform(0.5, 0.62)
    lower = paint if kit.chance(0.7) else worn_paint(kit, (0.1, 0.1, 0.1), (0.5, 0.5, 0.48), (0.65, 0.4, 0.02))
    kit.loft(at, [(-waist / 2 - back, radius * rng.uniform(0.45, 0.6)), (-waist / 2, radius), (waist / 2, radius)], lower, axis=axis)
    high = waist / 2 + neck
    kit.add(TUBE, at + axis @ [0, 0, waist / 2 + neck / 2], (radius, radius, neck / 2), (mouth / radius, 1), rotation=axis, material=paint)
    kit.add(TUBE, at + axis @ [0, 0, high + 0.02], (mouth * 1.04, mouth * 1.04, 0.03), rotation=axis, material=metal if kit.chance(0.4) else paint)
    kit.add(CYL, at + axis @ [0, 0, waist / 2 + 0.01], (radius * 0.97, radius * 0.97, 0.01), rotation=axis, material=near(kit, (0.2, 0.19, 0.17), (0.35, 0.34, 0.32), pattern=CLOUDY))
    for spin in (0, 180):
        blade = axis @ turn("z", spin)
        kit.between(at + blade @ [radius * 0.75, 0, 0.02], at + blade @ [mouth * 0.6, 0.05, high - 0.05], (0.012, 0.06), BOX, material=paint)
    kit.add(CYL, at + axis @ [0, 0, -waist * 0.1], (radius * 1.04, radius * 1.04, 0.02), rotation=axis, material=dark)
    if kit.chance(0.6):
        kit.add(CYL, at + axis @ [0, 0, waist * 0.25], (radius * 1.02, radius * 1.02, 0.03), rotation=axis, material=dark._replace(pattern=RIBS, frequency=60.0, second=metal.first))
    return waist / 2 + back


def small_mixer(kit):
    rng = kit.rng
    orange = ((0.7, 0.22, 0.02), (0.7, 0.42, 0.02), (0.05, 0.15, 0.4), (0.5, 0.05, 0.03), (0.1, 0.3, 0.12), (0.3, 0.3, 0.3))
    paint, dark, metal, tyre = worn_paint(kit, *orange), black(kit), steel(kit), black(kit)
    frame = paint if kit.chance(0.5) else worn_paint(kit, *orange)
    radius, high = rng.uniform(0.33, 0.42), rng.uniform(0.8, 0.95)
    tip = rng.uniform(15, 75)
    axis = turn("z", rng.choice([0, 90, -90])) @ turn("y", tip)
    at = np.array([0, 0, high])
    reach = drum(kit, at, axis, radius, paint, dark, metal)
    half = radius + 0.1
    foot = at - axis @ [0, 0, reach + 0.07]
    disc(kit, foot, 0.09, 0.08, frame, rotation=axis)
    cheek = axis @ [0, 1, 0]
    for way in (-1, 1):
        rod(kit, foot, at + way * cheek * (radius + 0.06) - axis @ [0, 0, radius * 0.9], 0.028, frame, kind=BOX)
        rod(kit, at + way * cheek * (radius + 0.06) - axis @ [0, 0, radius * 0.9], at + way * cheek * (radius + 0.06), 0.028, frame, kind=BOX)
        rod(kit, at + way * cheek * (radius + 0.03), at + way * cheek * (half + 0.05), 0.045, frame)
    across, level = cheek, np.array([cheek[1], -cheek[0], 0])
    wheel = rng.uniform(0.14, 0.2)
    for way in (-1, 1):
        top = at + way * across * half
        front, back = across * way * (half + 0.03) + level * 0.5, across * way * (half + 0.03) - level * 0.42
        rod(kit, top, front + [0, 0, 0.04], 0.025, frame, kind=BOX)
        rod(kit, top, back + [0, 0, wheel], 0.025, frame, kind=BOX)
        rod(kit, front * 0.72 + top * 0.28 * [1, 1, 1], back * 0.72 + top * 0.28 + [0, 0, wheel * 0.7], 0.018, frame, kind=BOX)
        hub = back + way * across * 0.06 + [0, 0, wheel]
        spin = np.stack([level, [0.0, 0, 1], across], 1)
        disc(kit, hub, wheel, 0.04, tyre, rotation=spin)
        disc(kit, hub, wheel * 0.6, 0.046, frame, rotation=spin)
    for end in (level * 0.5 + [0, 0, 0.04], level * -0.42 + [0, 0, wheel]):
        rod(kit, end - across * (half + 0.03), end + across * (half + 0.03), 0.022, frame, kind=BOX)
    side = across * (half + 0.14)
    housing = kit.chance(0.6)
    motor = at + side - [0, 0, 0.1]
    turned = np.stack([level, across, [0.0, 0, 1]], 1)
    kit.add(BOX, motor, (0.19, 0.12, rng.uniform(0.2, 0.27)), (0.9, 1), rotation=turned, material=frame if housing else worn_paint(kit, *orange))
    kit.add(BOX, motor + across * 0.121, (0.11, 0.004, 0.1), rotation=turned, material=dark._replace(pattern=RIBS, frequency=40.0, second=np.ones(3) * 0.2))
    kit.add(BOX, motor + level * 0.19 + [0, 0, 0.1], (0.012, 0.05, 0.06), rotation=turned, material=near(kit, (0.6, 0.03, 0.02), (0.1, 0.4, 0.1)))
    hand = at - across * (half + 0.1)
    spin = np.stack([level, [0.0, 0, 1], across], 1)
    if kit.chance(0.75):
        size = rng.uniform(0.2, 0.28)
        kit.add(TUBE, hand, (size, size, 0.018), rotation=spin, material=frame)
        kit.add(CYL, hand, (size, size, 0.012), rotation=spin, material=frame, cut=(SPOKES, int(rng.integers(3, 6)), 0.2))
        rod(kit, at - across * half, hand, 0.03, dark)
    else:
        lever = level * rng.uniform(-0.5, 0.5) + [0, 0, 0.6]
        rod(kit, hand, hand + lever, 0.018, frame)
        rod(kit, at - across * half, hand, 0.03, dark)
    if kit.chance(0.3):
        box(kit, level * 0.65 + [0, 0, 0.1], (0.3, 0.22, 0.1), worn_paint(kit, (0.4, 0.4, 0.38), (0.1, 0.3, 0.1)), taper=(1.25, 1.25))


def towed_mixer(kit):
    rng = kit.rng
    orange = ((0.7, 0.22, 0.02), (0.7, 0.42, 0.02), (0.05, 0.15, 0.4), (0.1, 0.3, 0.12), (0.5, 0.5, 0.48))
    paint, dark, metal, tyre = worn_paint(kit, *orange), black(kit), steel(kit), black(kit)
    frame = paint if kit.chance(0.6) else worn_paint(kit, *orange)
    radius, high, wheel = rng.uniform(0.5, 0.62), rng.uniform(1.15, 1.3), rng.uniform(0.28, 0.34)
    at, way = np.array([0.2, 0, high]), rng.choice([-1, 1])
    axis = turn("z", 90 * way) @ turn("y", rng.uniform(10, 70))
    reach = drum(kit, at, axis, radius, paint, dark, metal)
    for x in (-radius - 0.1, radius + 0.1):
        for y in (-0.5, 0.5):
            rod(kit, at * [1, 0, 0] + [x, y, 0.45], at + [x, 0, 0], (0.04, 0.05), frame, kind=BOX)
        disc(kit, at + [x * 0.97, 0, 0], 0.09, 0.1, dark, rotation=ALONG_X)
    rod(kit, at - axis @ [0, 0, reach], at - axis @ [0, 0, reach + 0.12], 0.12, frame)
    rod(kit, (-1.3, 0.5, 0.45), (1.0, 0.5, 0.45), (0.05, 0.04), frame, True, BOX)
    for x in (-1.3, -0.4, 1.0):
        rod(kit, (x, -0.5, 0.45), (x, 0.5, 0.45), 0.045, frame, kind=BOX)
    rims(kit, 0.1, 0.66, wheel, 0.09, tyre, frame)
    rod(kit, (0.1, -0.62, wheel), (0.1, 0.62, wheel), 0.04, dark)
    rod(kit, (0.1, 0.5, wheel), (0.1, 0.5, 0.45), 0.05, frame, True, BOX)
    rod(kit, (1.0, 0.4, 0.45), (1.7, 0, 0.45), 0.045, frame, True, BOX)
    rod(kit, (1.7, 0, 0.45), (2.0, 0, 0.45), 0.035, frame)
    disc(kit, (2.02, 0, 0.45), 0.07, 0.02, dark, kind=TUBE)
    rod(kit, (1.65, 0, 0), (1.65, 0, 0.6), 0.03, metal)
    rod(kit, (-1.25, 0.45, 0), (-1.25, 0.45, 0.45), 0.03, frame, True)
    slab(kit, 0.48, rng.uniform(1.2, 1.4), (-1.3, -0.6, 0.48), (-1.25, -0.62, 0.45), frame)
    box(kit, (-1.3, 0, 0.85), (0.01, 0.32, 0.25), dark._replace(pattern=RIBS, frequency=25.0, second=frame.first))
    box(kit, (-0.95, 0.475, 0.8), (0.22, 0.01, 0.18), dark._replace(pattern=RIBS, frequency=25.0, second=frame.first), True)
    rod(kit, (-1.1, 0.2, 1.2), (-1.1, 0.2, 1.65), 0.03, dark)
    hand = at + [radius + 0.28, 0, 0]
    kit.add(TUBE, hand, (0.36, 0.36, 0.02), rotation=ALONG_X, material=frame)
    kit.add(CYL, hand, (0.36, 0.36, 0.014), rotation=ALONG_X, material=frame, cut=(SPOKES, 4, 0.18))
    rod(kit, at + [radius, 0, 0], hand, 0.035, dark)
    if kit.chance(0.4):
        tray = turn("x", -way * rng.uniform(0, 40))
        middle = np.array([0.2, way * 1.05, 0.55])
        box(kit, middle, (0.45, 0.42, 0.03), frame, rotation=tray)
        for x in (-0.45, 0.45):
            box(kit, middle + tray @ [x, 0, 0.16], (0.02, 0.42, 0.16), frame, rotation=tray)
        box(kit, middle + tray @ [0, way * 0.42, 0.16], (0.45, 0.02, 0.16), frame, rotation=tray)


# Bins.


def waste_bin(kit):
    """Wheeled refuse bins, dustbins, compost bins, skips, gas cylinders, pillar boxes, mail boxes."""
    pick(kit, [two_wheeled, two_wheeled, two_wheeled, four_wheeled, four_wheeled, dustbin, dustbin, compost, skip, skip, cylinder, pillar_box, mail_box, mail_box])


def plastic(kit):
    return near(kit, (0.03, 0.15, 0.06), (0.05, 0.06, 0.07), (0.02, 0.1, 0.35), (0.2, 0.1, 0.05), (0.15, 0.16, 0.17), (0.75, 0.55, 0.03), (0.4, 0.03, 0.03), gloss=kit.rng.uniform(0.05, 0.35))


def label(kit):
    return pale(kit)._replace(pattern=WRITING, frequency=kit.rng.uniform(10, 20))


def two_wheeled(kit):
    rng = kit.rng
    body, tyre = plastic(kit), black(kit)
    lid = body if kit.chance(0.6) else plastic(kit)
    for k in range(int(rng.choice([1, 1, 1, 2]))):
        start = len(kit.primitives)
        small, tall = rng.uniform(0.75, 1.0), rng.uniform(0.88, 1.0)
        deep, wide = 0.24 * small + 0.03, 0.25 * small
        lifted = rng.choice([0, 0, 0, rng.uniform(5, 30), rng.uniform(100, 200)])
        slab(kit, 0.06, tall, (-deep * 0.72, deep * 0.78, wide * 0.8), (-deep, deep, wide), body)
        slab(kit, 0.0, 0.1, (deep * 0.3, deep * 0.76, wide * 0.78), (deep * 0.2, deep * 0.78, wide * 0.8), body)
        box(kit, (0, 0, tall - 0.03), (deep * 1.05, wide * 1.06, 0.025), body)
        if kit.chance(0.5):
            box(kit, (deep * 0.86, 0, tall * 0.45), (0.03, wide * 0.5, tall * 0.3), body, taper=(1, 1.15), rotation=turn("y", 4))
        if lifted > 30:
            box(kit, (0, 0, tall - 0.004), (deep * 0.95, wide * 0.94, 0.006), black(kit))
        hinge, open_ = np.array([-deep * 0.98, 0, tall + 0.02]), turn("y", -lifted)
        kit.add(BOX, hinge + open_ @ [deep * 1.05, 0, 0.025], (deep * 1.14, wide * 1.1, 0.03), (0.9, 0.88), rotation=open_, material=lid)
        rod(kit, hinge + [-0.03, -wide * 0.95, 0.0], hinge + [-0.03, wide * 0.95, 0.0], 0.022, body)
        rod(kit, hinge + [-0.1, -wide * 0.8, 0.0], hinge + [-0.1, wide * 0.8, 0.0], 0.018, lid)
        rod(kit, hinge + [-0.1, wide * 0.8, 0.0], hinge + [0.02, wide * 0.8, -0.02], 0.018, lid, True)
        wheel = 0.1 * rng.uniform(0.9, 1.15)
        disc(kit, (-deep * 0.85, wide * 0.88, wheel), wheel, 0.028, tyre, True, ALONG_Y)
        disc(kit, (-deep * 0.85, wide * 0.88, wheel), wheel * 0.5, 0.032, body, True, ALONG_Y)
        rod(kit, (-deep * 0.85, -wide * 0.85, wheel), (-deep * 0.85, wide * 0.85, wheel), 0.014, iron(kit))
        slab(kit, wheel * 0.7, wheel * 2.6, (-deep * 0.95, -deep * 0.5, wide * 0.76), (-deep * 0.85, -deep * 0.5, wide * 0.84), body)
        if kit.chance(0.5):
            kit.add(BOX, (deep * 0.93, 0, tall * 0.75), (0.006, 0.09, 0.08), rotation=turn("y", 7), material=label(kit))
        if k:
            spin, move = turn("z", rng.uniform(-15, 15)), np.array([rng.uniform(-0.1, 0.1), rng.uniform(0.62, 0.75), 0])
            kit.primitives[start:] = [p._replace(centre=spin @ p.centre + move, rotation=spin @ p.rotation) for p in kit.primitives[start:]]
        body = lid = plastic(kit)


def four_wheeled(kit):
    rng = kit.rng
    metal = kit.chance(0.35)
    body = near(kit, (0.4, 0.42, 0.42), (0.1, 0.25, 0.15), gloss=0.3, pattern=rng.choice([PLAIN, STREAKS])) if metal else plastic(kit)
    lid, dark = body if kit.chance(0.5) else plastic(kit), black(kit)
    deep, wide, low, tall = rng.uniform(0.42, 0.54), rng.uniform(0.6, 0.7), 0.2, rng.uniform(1.05, 1.2)
    slab(kit, low, tall, (-deep * 0.8, deep * 0.8, wide * 0.88), (-deep, deep, wide), body)
    box(kit, (0, 0, tall - 0.02), (deep * 1.05, wide * 1.04, 0.035), body)
    lean = np.degrees(np.arctan2(deep * 0.2, tall - low))
    for y in (-0.6, -0.2, 0.2, 0.6):
        kit.add(BOX, (deep * 0.9, y * wide, (low + tall) / 2), (0.02, 0.03, (tall - low) * 0.46), rotation=turn("y", lean), material=body)
    lifted = rng.choice([0, 0, 0, rng.uniform(20, 80)])
    if kit.chance(0.5):
        kit.add(CYL, (0, 0, tall), (deep * 1.04, 0.32, wide * 1.05), rotation=ALONG_Y, material=lid)
        for y in (-0.5, 0.5):
            rod(kit, (deep * 0.75, y * wide, tall + 0.2), (deep * 0.4, y * wide, tall + 0.32), 0.015, dark)
    else:
        hinge, open_ = np.array([-deep, 0, tall + 0.02]), turn("y", -lifted)
        if lifted:
            box(kit, (0, 0, tall + 0.012), (deep * 0.95, wide * 0.94, 0.008), dark)
        kit.add(BOX, hinge + open_ @ [deep * 1.03, 0, 0.05], (deep * 1.08, wide * 1.06, 0.055), (0.88, 0.92), rotation=open_, material=lid)
        rod(kit, hinge + [-0.03, -wide, 0], hinge + [-0.03, wide, 0], 0.025, dark)
    for x in (-0.62, 0.62):
        disc(kit, (x * deep, wide * 0.66, 0.09), 0.09, 0.025, dark, True, ALONG_Y)
        box(kit, (x * deep, wide * 0.66, 0.17), (0.06, 0.05, 0.035), steel(kit), True)
    for y in (-wide * 1.0, wide * 1.0):
        disc(kit, (0, y * 1.03, tall - 0.1), 0.035, 0.05, steel(kit), rotation=ALONG_Y)
    rod(kit, (deep * 1.1, -wide * 0.7, tall - 0.06), (deep * 1.1, wide * 0.7, tall - 0.06), 0.018, dark)
    rod(kit, (deep * 0.95, wide * 0.7, tall - 0.06), (deep * 1.1, wide * 0.7, tall - 0.06), 0.018, dark, True)
    if kit.chance(0.6):
        kit.add(BOX, (deep * 0.92, 0, tall * 0.72), (0.006, 0.18, 0.1), rotation=turn("y", lean), material=label(kit))


def dustbin(kit):
    rng = kit.rng
    zinc = near(kit, (0.45, 0.47, 0.48), (0.3, 0.31, 0.32), (0.55, 0.55, 0.53), pattern=RIBS, frequency=rng.uniform(20, 35), gloss=0.4) if kit.chance(0.65) else plastic(kit)
    plain, r, tall = zinc._replace(pattern=PLAIN), rng.uniform(0.2, 0.25), rng.uniform(0.55, 0.75)
    kit.loft((0, 0, 0), [(0, r * 0.86), (0.03, r * 0.86)], plain)
    kit.loft((0, 0, 0.03), [(0, r * 0.84), (tall - 0.03, r)], zinc)
    for z in (tall * 0.35, tall * 0.7)[: int(rng.integers(0, 3))]:
        kit.add(CYL, (0, 0, z), (r * (0.87 + 0.14 * z / tall),) * 2 + (0.012,), material=plain)
    kit.add(CYL, (0, 0, tall), (r * 1.03, r * 1.03, 0.015), material=plain)
    lid, shut = plain if kit.chance(0.8) else plastic(kit), kit.chance(0.8)
    spot, tip = (np.array([0, 0, tall + 0.01]), np.eye(3)) if shut else (np.array([r * 1.35, 0, r * 0.95]), turn("y", rng.uniform(60, 75)))
    kit.loft(spot, [(0, r * 1.09), (0.035, r * 1.07), (rng.uniform(0.07, 0.12), r * 0.25), (0.125, r * 0.1)], lid, axis=tip)
    bent(kit, [spot + tip @ p for p in ([0, -0.07, 0.09], [0, -0.06, 0.15], [0, 0.06, 0.15], [0, 0.07, 0.09])], 0.01, lid)
    if not shut:
        kit.add(CYL, (0, 0, tall + 0.014), (r * 0.96, r * 0.96, 0.004), material=black(kit))
    for way in (-1, 1):
        z, y = tall * 0.78, way * r * 0.97
        bent(kit, [(-0.07, y, z), (-0.06, y + way * 0.045, z), (0.06, y + way * 0.045, z), (0.07, y, z)], 0.009, plain)


def compost(kit):
    rng = kit.rng
    wide = rng.uniform(0.38, 0.5)
    if kit.chance(0.5):
        skin = near(kit, (0.03, 0.12, 0.05), (0.04, 0.04, 0.04), gloss=0.1, pattern=BANDS, frequency=12)
        sides, tall = int(rng.choice([4, 6, 8, 16])), rng.uniform(0.8, 1.0)
        kit.loft((0, 0, 0), [(0, wide), (tall, wide * rng.uniform(0.62, 0.75))], skin, PRISM, sides=sides)
        kit.loft((0, 0, tall), [(0, wide * 0.74), (0.06, wide * 0.72), (0.14, wide * 0.3)], skin._replace(pattern=PLAIN), PRISM, sides=sides)
        disc(kit, (0, 0, tall + 0.15), wide * 0.12, 0.03, skin)
        box(kit, (wide * 0.9, 0, 0.16), (0.03, wide * 0.36, 0.15), skin._replace(pattern=PLAIN))
        return
    wood, soil = planks(kit), near(kit, (0.1, 0.06, 0.03), (0.2, 0.16, 0.06), pattern=CLOUDY)
    tall, count = rng.uniform(0.7, 1.0), int(rng.integers(4, 7))
    for x in (-wide, wide):
        rod(kit, (x, wide, 0), (x, wide, tall + 0.03), 0.035, wood, True, BOX)
    for k in range(count):
        z = tall * (k + 0.5) / count
        plank = tall / count * 0.36
        box(kit, (0, wide + 0.03, z), (wide + 0.05, 0.012, plank), wood, True)
        for x in (-wide - 0.03, wide + 0.03)[: 2 if k < count - 1 or kit.chance(0.5) else 1]:
            box(kit, (x, 0, z), (0.012, wide + 0.05, plank), wood)
    kit.add(BOX, (0, 0, tall * 0.36), (wide * 0.97, wide * 0.97, tall * 0.36), material=soil)
    kit.add(BALL, (0, 0, tall * 0.7), (wide * 0.9, wide * 0.9, tall * 0.25), material=soil)


def skip(kit):
    rng = kit.rng
    paint = worn_paint(kit, (0.7, 0.45, 0.02), (0.05, 0.15, 0.4), (0.1, 0.3, 0.15), (0.5, 0.06, 0.03), (0.3, 0.3, 0.3), (0.55, 0.53, 0.5))
    long, wide, tall = rng.uniform(1.2, 1.9), rng.uniform(0.7, 0.9), rng.uniform(0.9, 1.35)
    foot, over = long * rng.uniform(0.5, 0.62), rng.uniform(0.0, 0.15)
    inside = paint._replace(first=paint.first * 0.5, pattern=CLOUDY)
    box(kit, (0, 0, 0.08), (foot, wide * (1 - over), 0.05), inside)
    lean = turn("x", -np.degrees(np.arctan2(wide * over, tall)))
    kit.add(BOX, (0, wide * (1 - over / 2), tall / 2 + 0.04), (foot, 0.025, tall / 2), (long / foot, 1), rotation=lean, material=paint, mirror=True)
    for way in (-1, 1):
        kit.between((way * foot, 0, 0.05), (way * long, 0, tall + 0.04), (0.025, wide * (1 - over)), BOX, 1 / (1 - over), material=paint)
        rod(kit, (way * long, -wide, tall + 0.04), (way * long, wide, tall + 0.04), 0.045, paint, kind=BOX)
        for y in (-0.45, 0.45):
            rod(kit, (way * (foot + 0.03), y * wide, 0.08), (way * (long + 0.03), y * wide, tall), (0.03, 0.04), paint, kind=BOX)
    rod(kit, (-long, wide, tall + 0.04), (long, wide, tall + 0.04), 0.045, paint, True, BOX)
    for x in (-0.6, -0.2, 0.2, 0.6):
        rod(kit, (x * foot, wide * (1 - over) + 0.03, 0.06), (x * foot, wide + 0.03, tall), (0.03, 0.035), paint, True, BOX)
    for x in (-0.5, 0.5):
        disc(kit, (x * long, wide + 0.1, tall * 0.72), 0.05, 0.1, iron(kit), True, ALONG_Y)
    for x in (-0.6, 0.6):
        box(kit, (x * foot, wide * 0.5, 0.02), (0.15, 0.08, 0.03), paint, True)
    fill = tall * rng.uniform(0.25, 0.85)
    at = foot + (long - foot) * fill / tall
    if kit.chance(0.65):
        load = near(kit, (0.35, 0.3, 0.25), (0.15, 0.1, 0.06), (0.45, 0.44, 0.42), (0.4, 0.2, 0.12), pattern=CLOUDY, frequency=14)
        slab(kit, 0.1, fill, (-foot * 0.97, foot * 0.97, wide * (1 - over) * 0.96), (-at * 0.96, at * 0.96, wide * 0.95 * (1 - over)), load)
        for _ in range(int(rng.integers(3, 9))):
            place = (rng.uniform(-0.7, 0.7) * at, rng.uniform(-0.55, 0.55) * wide, fill + rng.uniform(-0.02, 0.12))
            spin = turn("z", rng.uniform(0, 180)) @ turn("y", rng.uniform(-40, 40))
            kit.add(BOX, place, rng.uniform(0.03, 0.35, 3) * [1.2, 0.7, 0.6], rotation=spin, material=load if kit.chance(0.4) else kit.material())
    if kit.chance(0.5):
        kit.add(BOX, (0, wide * (1 - over * 0.4) + 0.035, tall * 0.6), (foot * 0.55, 0.006, tall * 0.16), rotation=lean, material=label(kit), mirror=True)


def cylinder(kit):
    """Propane bottles with a collar, and tall cylinders with a cap, alone or in twos and threes."""
    rng = kit.rng
    paint, metal = worn_paint(kit, (0.6, 0.08, 0.03), (0.75, 0.35, 0.02), (0.05, 0.2, 0.45), (0.4, 0.42, 0.42), (0.1, 0.3, 0.15), (0.7, 0.7, 0.68)), brass(kit)
    squat, count = kit.chance(0.7), int(rng.choice([1, 1, 2, 3]))
    r, tall = (rng.uniform(0.14, 0.18), rng.uniform(0.4, 0.75)) if squat else (rng.uniform(0.1, 0.13), rng.uniform(1.2, 1.5))
    for k in range(count):
        at = np.array([rng.uniform(-0.04, 0.04), (k - (count - 1) / 2) * (2.15 * r), 0])
        coat = paint if kit.chance(0.7) else bright(kit)
        kit.loft(at, [(0, r * 0.85), (0.06, r * 0.85)], coat)
        kit.loft(at, [(0.06, r * 0.9), (0.12, r), (tall - r * 0.5, r), (tall - r * 0.18, r * 0.8), (tall, r * 0.35)], coat)
        if squat:
            kit.add(CYL, at + [0, 0, tall * 0.52], (r * 1.02, r * 1.02, 0.012), material=coat)
            kit.add(TUBE, at + [0, 0, tall + 0.03], (r * 0.72, r * 0.72, 0.08), material=coat, cut=(BARS, 6, rng.uniform(0.7, 0.95)))
            disc(kit, at + [0, 0, tall + 0.05], 0.03, 0.06, metal)
            disc(kit, at + [0, 0, tall + 0.12], 0.04, 0.012, black(kit))
        else:
            shoulder = kit.material(base=bright(kit).first, pattern=PLAIN)
            kit.loft(at, [(tall - r * 0.5, r * 1.01), (tall - r * 0.17, r * 0.82)], shoulder)
            kit.loft(at, [(tall - 0.02, r * 0.4), (tall + 0.12, r * 0.42), (tall + 0.16, r * 0.25)], coat if kit.chance(0.5) else metal)
        if kit.chance(0.5):
            kit.add(BOX, at + [r * 0.97, 0, tall * 0.6], (0.01, r * 0.35, r * 0.4), material=label(kit))


def pillar_box(kit):
    rng = kit.rng
    coat, dark = near(kit, (0.55, 0.02, 0.02), (0.55, 0.02, 0.02), (0.7, 0.5, 0.02), (0.03, 0.2, 0.08), (0.03, 0.08, 0.3), gloss=0.4), black(kit)
    r, tall = rng.uniform(0.22, 0.27), rng.uniform(1.35, 1.55)
    sides = dict(kind=PRISM, sides=6) if kit.chance(0.2) else {}
    kit.loft((0, 0, 0), [(0, r * 1.06), (0.16, r * 1.06)], dark, **sides)
    kit.loft((0, 0, 0.16), [(0, r * 1.04), (0.05, r), (tall - 0.3, r)], coat, **sides)
    kit.loft((0, 0, tall - 0.16), [(0, r * 1.02), (0.04, r * 1.18), (0.1, r * 1.18)], coat, **sides)
    kit.loft((0, 0, tall - 0.06), [(0, r * 1.12), (0.06, r * 0.95), (0.12, r * 0.5), (0.14, 0.03)], coat, **sides)
    box(kit, (r * 0.98, 0, tall - 0.27), (0.03, r * 0.62, 0.05), coat)
    box(kit, (r * 1.02, 0, tall - 0.27), (0.025, r * 0.5, 0.02), dark)
    box(kit, (r * 0.94, 0, tall * 0.45), (0.03, r * 0.5, tall * 0.22), coat)
    box(kit, (r * 0.95, 0, tall * 0.58), (0.035, r * 0.28, 0.09), label(kit))


def mail_box(kit):
    """Street collection boxes with a round top on four legs, and roadside boxes on a post with a flag."""
    rng = kit.rng
    coat = near(kit, (0.02, 0.06, 0.3), (0.02, 0.06, 0.3), (0.5, 0.03, 0.03), (0.7, 0.5, 0.02), (0.1, 0.2, 0.1), (0.6, 0.6, 0.6), gloss=0.3)
    if kit.chance(0.6):
        deep, wide, low, tall = rng.uniform(0.22, 0.28), rng.uniform(0.24, 0.3), rng.uniform(0.15, 0.28), rng.uniform(0.95, 1.1)
        posts(kit, deep * 0.85, wide * 0.82, 0, low + 0.3, 0.03, coat, kind=BOX)
        box(kit, (0, 0, (low + tall) / 2), (deep, wide, (tall - low) / 2), coat)
        kit.add(CYL, (0, 0, tall), (deep, deep * rng.uniform(0.85, 1.05), wide), rotation=ALONG_Y, material=coat)
        kit.add(CYL, (0, wide, tall), (deep * 1.04, deep * 1.06, 0.015), rotation=ALONG_Y, material=coat, mirror=True)
        kit.add(BOX, (deep * 0.72, 0, tall + deep * 0.7), (0.02, wide * 0.8, 0.1), rotation=turn("y", -42), material=coat)
        rod(kit, (deep * 0.85, -wide * 0.4, tall + deep * 0.78), (deep * 0.85, wide * 0.4, tall + deep * 0.78), 0.015, steel(kit))
        box(kit, (deep, 0, (low + tall) / 2 - 0.05), (0.012, wide * 0.75, (tall - low) * 0.35), coat)
        box(kit, (deep + 0.01, 0, tall - 0.1), (0.008, wide * 0.6, 0.06), label(kit))
        box(kit, (0, wide, tall * 0.7), (deep * 0.6, 0.01, 0.09), label(kit), True)
        return
    long, wide, high = rng.uniform(0.22, 0.28), rng.uniform(0.08, 0.11), rng.uniform(1.0, 1.15)
    wood = planks(kit) if kit.chance(0.7) else pale(kit)
    rod(kit, (0, 0, 0), (0, 0, high), 0.05, wood, kind=BOX)
    if kit.chance(0.5):
        rod(kit, (-0.3, 0, high - 0.03), (0.35, 0, high - 0.03), 0.045, wood, kind=BOX)
        rod(kit, (0, 0, high - 0.35), (0.25, 0, high - 0.06), 0.03, wood, kind=BOX)
    box(kit, (0, 0, high + 0.02), (long * 0.95, wide * 0.95, 0.015), wood)
    box(kit, (0, 0, high + 0.09), (long, wide, 0.06), coat)
    kit.add(CYL, (0, 0, high + 0.15), (wide, wide, long), rotation=ALONG_X, material=coat)
    for x in (-long, long):
        kit.add(CYL, (x, 0, high + 0.15), (wide * 1.04, wide * 1.04, 0.012), rotation=ALONG_X, material=coat)
        box(kit, (x, 0, high + 0.09), (0.012, wide * 1.04, 0.065), coat)
    box(kit, (long + 0.02, 0, high + 0.22), (0.012, 0.02, 0.02), steel(kit))
    red, up = near(kit, (0.6, 0.03, 0.02), (0.8, 0.5, 0.03)), kit.chance(0.5)
    start = np.array([0.05, wide + 0.012, high + 0.13])
    end = start + ([0, 0, 0.2] if up else [0.2, 0, 0])
    rod(kit, start, end, 0.01, red, kind=BOX)
    box(kit, end, (0.045, 0.006, 0.03), red)


# Sailing boats.


def sailing_boat(kit):
    """Junks with fanned sails, dhows and feluccas under great lateens, luggers, proas: planked open hulls, thin masts."""
    pick(kit, [junk, junk, dhow, dhow, open_lugger, open_lugger, proa])


def strakes(kit, stations, levels, skin, inside, thick=0.018):
    """An open hull of planks that flare: stations (x, half width, rim's height, keel's height); levels: (share of the height, share of the width)."""
    for (t0, f0), (t1, f1) in zip(levels[:-1], levels[1:], strict=True):
        for (xa, wa, ha, ka), (xb, wb, hb, kb) in zip(stations[:-1], stations[1:], strict=True):
            low = [np.array([xa, wa * f0, ka + (ha - ka) * t0]), np.array([xb, wb * f0, kb + (hb - kb) * t0])]
            high = [np.array([xa, wa * f1, ka + (ha - ka) * t1]), np.array([xb, wb * f1, kb + (hb - kb) * t1])]
            panel(kit, low, high, thick, skin)
    for (xa, wa, ha, ka), (xb, wb, hb, kb) in zip(stations[:-1], stations[1:], strict=True):
        rod(kit, (xa, wa, ha), (xb, wb, hb), thick * 1.6, inside, True, BOX)
        t, f = levels[1]
        low_a, low_b = ka + (ha - ka) * t * 0.9, kb + (hb - kb) * t * 0.9
        if min(wa, wb) > 0.05 or max(wa, wb) > 0.1:
            kit.between((xa, 0, low_a), (xb, 0, low_b), (0.012, max(wa, wb) * f * 0.85), BOX, material=inside)
        rod(kit, (xa, 0, ka), (xb, 0, kb), (0.03, 0.025), inside, kind=BOX)


def panel(kit, low, high, thick, material):
    """A flat board between two edges, and its twin on the other side."""
    start, end = (low[0] + high[0]) / 2, (low[1] + high[1]) / 2
    rise = (high[0] - low[0] + high[1] - low[1]) / 2
    z = (end - start) / np.linalg.norm(end - start)
    rise = rise - (rise @ z) * z
    x = rise / np.linalg.norm(rise)
    tall = [max(abs((high[k] - low[k]) @ x), 0.02) for k in (0, 1)]
    frame = np.stack([x, np.cross(z, x), z], 1)
    kit.add(BOX, (start + end) / 2, (tall[0] / 2 * 1.04, thick, np.linalg.norm(end - start) / 2), (tall[1] / tall[0], 1), rotation=frame, material=material, mirror=True)


def cloth_triangle(kit, a, b, c, cloth, thin=0.01):
    """A sail's part with the edge from a to b and the corner c."""
    corners = np.array([a, b, c], float)
    a, b, c = corners + (corners - corners.mean(0)) * 0.05
    along = (b - a) / np.linalg.norm(b - a)
    reach = c - (a + b) / 2
    shift = reach @ along
    across = reach - shift * along
    deep = np.linalg.norm(across)
    frame = np.stack([along, np.cross(across / deep, along), across / deep], 1)
    kit.add(BOX, (a + b) / 2 + across / 2, (np.linalg.norm(b - a) / 2, thin, deep / 2), (0.02, 1), (shift, 0), frame, cloth)


def boat_hull(kit, long, wide, high, bow, stern, skin, inside, rake=0.0, transom=0.75, draft=0.0):
    """Stations and strakes of an open boat whose ends rise to `bow` and `stern`; a flat transom, thwarts, rudder."""
    stations = [
        (-long, wide * transom, stern, 0.12 * high + draft),
        (-long * 0.45, wide * 0.98, high + (stern - high) * 0.25, 0.0),
        (long * 0.25, wide * 0.95, high * 1.02, 0.0),
        (long * 0.7, wide * 0.6, high + (bow - high) * 0.4, 0.05 * high),
        (long * (1 + rake), 0.03, bow, bow * (0.25 + 0.8 * rake)),
    ]
    strakes(kit, stations, [(0.0, 0.1), (0.28, 0.72), (0.62, 0.93), (1.0, 1.0)], skin, inside)
    back = stations[0]
    if transom > 0.2:
        slab(kit, back[3], stern, (-long - 0.02, -long + 0.02, wide * transom * 0.35), (-long - 0.02, -long + 0.02, wide * transom), skin)
    for x in (-0.5, 0.0, 0.4):
        box(kit, (x * long, 0, high * 0.72), (0.09, wide * (0.88 if x < 0.3 else 0.75), 0.018), inside)
    box(kit, (-long - 0.1, 0, stern * 0.42), (0.1, 0.02, stern * 0.42), inside, taper=(0.6, 1))
    rod(kit, (-long - 0.1, 0, stern * 0.86), (-long + 0.5, 0.05, stern * 1.02), 0.02, inside)


def boat_colours(kit):
    skin = timber(kit) if kit.chance(0.6) else near(kit, (0.75, 0.73, 0.68), (0.05, 0.25, 0.3), (0.03, 0.08, 0.2), (0.4, 0.05, 0.04), (0.04, 0.04, 0.04), (0.1, 0.25, 0.12), pattern=STREAKS)
    return skin, timber(kit, 0.7, 1.8), timber(kit, 0.8, 1.8)


def tanned(kit):
    """Sailcloth: tanned red or brown, ochre, white, patched."""
    if kit.chance(0.4):
        return canvas(kit)
    return near(kit, (0.4, 0.07, 0.03), (0.5, 0.25, 0.07), (0.65, 0.48, 0.25), (0.75, 0.7, 0.58), (0.22, 0.1, 0.05), pattern=kit.rng.choice([PLAIN, CLOUDY, SEAMS, PATCHWORK, STRIPES]), frequency=kit.rng.uniform(5, 12))


def junk(kit):
    """Fanned sails of panels between battens on two or three masts."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.4, 3.2), rng.uniform(0.6, 0.8), rng.uniform(0.5, 0.65)
    boat_hull(kit, long, wide, high, high * rng.uniform(1.3, 1.7), high * rng.uniform(1.5, 2.1), skin, inside, transom=0.8)
    if kit.chance(0.6):
        kit.add(CYL, (-long * 0.35, 0, high * 0.9), (high * 0.75, wide * 0.75, long * 0.2), rotation=ALONG_X, material=near(kit, (0.4, 0.3, 0.15), (0.2, 0.13, 0.07), pattern=BANDS, frequency=14))
    cloth, swing = tanned(kit), rng.uniform(-0.35, 0.35)
    masts = [(0.72, 0.62), (0.05, 1.0), (-0.82, 0.5)] if kit.chance(0.55) else [(0.55, 0.72), (-0.1, 1.0)]
    tall = long * rng.uniform(1.35, 1.65)
    for share, size in masts:
        top, count = tall * size, 5 if len(masts) == 2 else 4 if size == 1 else 3
        foot = np.array([share * long, 0, high * 1.35])
        rod(kit, foot * [1, 1, 0.3], foot + [0.05 * top, 0, top * 1.08], 0.032 * size + 0.012, spar)
        out = np.array([-np.cos(swing), np.sin(swing), 0])
        side = foot + [0, 0.06, 0]
        lifts = top * (np.linspace(0, 1, count + 1) ** 0.9) * 0.66
        tilts = np.radians(np.linspace(2, 52, count + 1) + rng.uniform(-3, 3))
        lengths = top * np.interp(np.linspace(0, 1, count + 1), [0, 0.5, 0.8, 1], [0.55, 0.66, 0.62, 0.5]) * rng.uniform(0.9, 1.0)
        luff = [side - out * top * 0.11 * (1 - k / count * 0.6) + [0, 0, z] for k, z in enumerate(lifts)]
        leech = [p + n * (out * np.cos(a) + [0, 0, np.sin(a)]) for p, n, a in zip(luff, lengths, tilts, strict=True)]
        for k in range(count):
            cloth_triangle(kit, luff[k], leech[k], leech[k + 1], cloth)
            cloth_triangle(kit, leech[k + 1], luff[k + 1], luff[k], cloth)
        for start, end in zip(luff, leech, strict=True):
            rod(kit, start, end, 0.022, spar)


def dhow(kit):
    """One or two lateens on long bent yards, low bow far out, open waist."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.4, 3.4), rng.uniform(0.55, 0.75), rng.uniform(0.42, 0.55)
    boat_hull(kit, long, wide, high, high * rng.uniform(1.5, 2.2), high * rng.uniform(1.2, 1.8), skin, inside, rake=rng.uniform(0.05, 0.25), transom=rng.choice([0.05, 0.6, 0.75]))
    cloth, side = tanned(kit), rng.choice([-1, 1])
    for share, size in [(0.12, 1.0)] if kit.chance(0.55) else [(0.3, 1.0), (-0.6, 0.62)]:
        tall, x = long * rng.uniform(1.1, 1.35) * size, share * long
        rod(kit, (x, 0, 0.05), (x + tall * 0.1, 0, high + tall), 0.045, spar)
        sling = np.array([x + tall * 0.09, side * 0.06, high + tall * 0.93])
        steep = np.radians(rng.uniform(42, 62))
        yard = np.array([-np.cos(steep), 0, np.sin(steep)])
        low, peak = sling - yard * tall * 0.98, sling + yard * tall * rng.uniform(0.75, 1.0)
        low[2] = max(low[2], high * 1.2)
        middle = (low + peak) / 2 + [0.03 * tall, 0, 0.03 * tall]
        rod(kit, low, middle, 0.028, spar)
        rod(kit, middle, peak, 0.024, spar)
        clew = np.array([x - tall * rng.uniform(0.75, 0.95), side * rng.uniform(0.2, 0.8) * wide, high * rng.uniform(1.5, 2.2)])
        belly = (middle + clew) / 2 + [0, side * 0.08 * tall, 0]
        for a, b, c in ((low, middle, belly), (middle, peak, belly), (low, belly, clew), (belly, peak, clew)):
            cloth_triangle(kit, a, b, c, cloth)
        rod(kit, clew, (x - tall * 0.95, side * wide * 0.5, high), 0.008, spar)
        rod(kit, sling, (x - tall * 0.25, wide * 0.9, high), 0.008, spar, True)
    if kit.chance(0.5):
        crew(kit, (-0.75 * long, 0.05, high), (0.1, 0.22, 0.12), (0.3, 0.12, -0.25), 0.8)


def open_lugger(kit):
    """Open boats with one to three four-cornered lugsails, a bowsprit and a jib."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.0, 3.0), rng.uniform(0.6, 0.8), rng.uniform(0.42, 0.55)
    bow = high * rng.uniform(1.15, 1.5)
    boat_hull(kit, long, wide, high, bow, high * rng.uniform(1.05, 1.3), skin, inside, transom=rng.choice([0.05, 0.65, 0.8]))
    cloth, side = tanned(kit), rng.choice([-1, 1])
    masts = {1: [(0.3, 1.0)], 2: [(0.5, 1.0), (-0.75, 0.6)], 3: [(0.62, 0.85), (-0.02, 1.0), (-0.9, 0.5)]}[int(rng.choice([1, 2, 2, 3]))]
    for share, size in masts:
        tall, x = long * rng.uniform(1.1, 1.35) * size, share * long
        deep = tall * rng.uniform(0.55, 0.7) if len(masts) < 3 else min(tall * 0.6, long * 0.62)
        rake = tall * rng.uniform(-0.06, 0.04)
        rod(kit, (x, 0, 0.05), (x + rake, 0, high + tall), 0.038, spar)
        swing = side * rng.uniform(0.1, 0.5)
        out = np.array([-np.cos(swing), np.sin(swing), 0])
        at = np.array([x, side * 0.05, high * 1.35])
        tack, clew = at - out * deep * 0.22, at + out * deep * 0.85 + [0, 0, rng.uniform(0, 0.15)]
        throat, peak = at - out * deep * 0.15 + [rake, 0, tall * 0.66], at + out * deep * 0.68 + [rake, 0, tall * rng.uniform(0.95, 1.12)]
        belly = (tack + clew + throat + peak) / 4 + [0, side * 0.06 * tall, 0]
        for a, b in ((tack, clew), (clew, peak), (peak, throat), (throat, tack)):
            cloth_triangle(kit, a, b, belly, cloth)
        rod(kit, throat - (peak - throat) * 0.05, peak + (peak - throat) * 0.05, 0.026, spar)
        if kit.chance(0.5):
            rod(kit, tack, clew, 0.022, spar)
        rod(kit, (x + rake, 0, high + tall * 0.97), (x - 0.15, wide * 0.9, high), 0.008, spar, True)
    if kit.chance(0.5):
        x, tall = masts[0][0] * long, long * 0.95 * masts[0][1]
        tip = np.array([long * rng.uniform(1.25, 1.5), 0, bow + 0.15])
        rod(kit, (long * 0.6, 0, bow * 0.95), tip, 0.028, spar)
        cloth_triangle(kit, tip, (x, 0, high + tall), (x + 0.15, side * 0.3, high * 1.5), cloth if kit.chance(0.6) else tanned(kit))
    if kit.chance(0.45):
        crew(kit, (-0.6 * long, 0.1, high), (0.1, 0.22, 0.12), (0.3, 0.12, -0.25), 0.8)


def proa(kit):
    """Outrigger canoes under a crab-claw sail."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.2, 3.0), rng.uniform(0.22, 0.3), rng.uniform(0.35, 0.45)
    end = high * rng.uniform(1.3, 2.0)
    stations = [(-long, 0.03, end, end * 0.5), (-long * 0.6, wide * 0.8, high * 1.1, 0.05), (0, wide, high, 0), (long * 0.6, wide * 0.8, high * 1.1, 0.05), (long, 0.03, end, end * 0.5)]
    strakes(kit, stations, [(0.0, 0.15), (0.4, 0.85), (1.0, 1.0)], skin, inside)
    out = rng.choice([-1, 1]) * rng.uniform(1.2, 1.8)
    for y in (out, -out)[: 1 if kit.chance(0.65) else 2]:
        rod(kit, (-long * 0.65, y, 0.1), (long * 0.6, y, 0.1), 0.075, inside)
        kit.add(CYL, (long * 0.68, y, 0.14), (0.075, 0.075, long * 0.09), (0.3, 1), rotation=turn("y", 75), material=inside)
        for x in (-0.35, 0.3):
            rod(kit, (x * long, -np.sign(y) * wide, high * 1.05), (x * long, y * 0.8, high * 1.05), 0.028, spar)
            rod(kit, (x * long, y * 0.78, high * 1.05), (x * long, y, 0.12), 0.026, spar)
    if kit.chance(0.4):
        box(kit, (0, out * 0.35, high * 1.1), (long * 0.25, abs(out) * 0.3, 0.02), inside, cut=(BARS, 10, 0.7))
    cloth, tall = tanned(kit), long * rng.uniform(0.95, 1.2)
    rod(kit, (0.1 * long, 0, 0.1), (0.16 * long, 0, high + tall * 0.8), 0.035, spar)
    tack = np.array([long * 0.62, 0.04, high * 1.35])
    head, foot = np.array([-long * 0.2, 0.05, high + tall * 1.3]), np.array([-long * 0.8, rng.uniform(-0.4, 0.4), high + tall * 0.45])
    arch = (tack + head) / 2 + [0.1 * long, 0, 0.08 * long]
    sag = (tack + foot) / 2 - [0, 0, 0.06 * long]
    hollow = (head + foot) / 2 * 0.72 + tack * 0.28
    for a, b in ((tack, arch), (arch, head), (foot, sag), (sag, tack)):
        cloth_triangle(kit, a, b, hollow, cloth)
        rod(kit, a, b, 0.024, spar)
    if kit.chance(0.5):
        crew(kit, (-0.6 * long, 0, high), (0.1, 0.2, 0.12), (0.3, 0.1, -0.2), 0.8)


# Spacecraft.


def spacecraft(kit):
    """Landers on splayed legs in foil, and probes with a dish and booms."""
    pick(kit, [moon_lander, moon_lander, small_lander, probe, probe, rover_probe])


def foil(kit):
    return near(kit, (0.75, 0.48, 0.1), (0.6, 0.35, 0.06), (0.7, 0.68, 0.62), (0.06, 0.06, 0.07), pattern=kit.rng.choice([PATCHWORK, CLOUDY, CHECKER]), frequency=kit.rng.uniform(8, 18), gloss=0.6)


def solar(kit):
    return near(kit, (0.02, 0.05, 0.2), (0.03, 0.03, 0.07), pattern=CHECKER, frequency=kit.rng.uniform(8, 16), gloss=0.5)


def legs(kit, count, hip, reach, low, high, metal, pad, first=45):
    """Splayed legs with struts and pads: from the hip circle out to the circle of `reach`."""
    for k, (c, s) in enumerate(around(count, 1.0, first)):
        way, side = np.array([c, s, 0]), np.array([-s, c, 0])
        knee, end = way * hip + [0, 0, high], way * reach + [0, 0, 0.08]
        rod(kit, knee, end, 0.06 * hip, metal)
        for y in (-1, 1):
            rod(kit, way * hip * 0.95 + side * y * hip * 0.4 + [0, 0, low], knee * 0.35 + end * 0.65, 0.03 * hip, metal)
        kit.add(CYL, end - [0, 0, 0.04], (pad * 0.75, pad * 0.75, 0.04), (1.33, 1), material=metal)


def moon_lander(kit):
    """An octagonal descent stage in foil on four legs, above it the faceted cabin with hatch, windows, thrusters and aerials."""
    rng = kit.rng
    gold, grey, dark, metal = foil(kit), near(kit, (0.3, 0.31, 0.32), (0.6, 0.6, 0.58), (0.12, 0.12, 0.13), pattern=rng.choice([PLAIN, SEAMS, PATCHWORK]), frequency=6, gloss=0.2), black(kit), foil(kit) if kit.chance(0.6) else steel(kit)
    r, low, stage = rng.uniform(1.8, 2.1), rng.uniform(1.1, 1.5), rng.uniform(1.3, 1.7)
    kit.add(PRISM, (0, 0, low + stage / 2), (r, r, stage / 2), (1, 8), material=gold)
    for z in (low, low + stage):
        kit.add(PRISM, (0, 0, z), (r * 1.02, r * 1.02, 0.04), (1, 8), material=grey)
    kit.add(CYL, (0, 0, low - 0.25), (0.75, 0.75, 0.4), (0.45, 1), material=dark)
    legs(kit, 4, r * 0.95, r * rng.uniform(2.0, 2.4), low, low + stage * 0.85, metal, 0.45, first=0)
    rungs = np.array([r * 1.15, 0, 0])
    kit.between(rungs + [r * 0.75, 0, 0.5], rungs + [0, 0, low + stage], (0.02, 0.22), BOX, material=steel(kit), cut=(RUNGS, 4, 0.35))
    box(kit, (r * 1.05, 0, low + stage + 0.02), (0.4, 0.4, 0.03), grey)
    base, tall = low + stage, rng.uniform(1.7, 2.1)
    kit.add(CYL, (r * 0.2, 0, base + tall * 0.5), (tall * 0.5, 1.15, r * 0.55), rotation=ALONG_X, material=grey)
    slab(kit, base + 0.1, base + tall * 0.55, (r * 0.2, r * 0.78, 0.8), (r * 0.2, r * 0.86, 0.95), grey)
    slab(kit, base + tall * 0.5, base + tall * 0.98, (r * 0.1, r * 0.86, 0.95), (r * 0.1, r * 0.5, 0.6), grey)
    box(kit, (r * 0.83, 0, base + tall * 0.28), (0.02, 0.4, tall * 0.22), gold if kit.chance(0.3) else dark)
    for y in (-1, 1):
        kit.add(PRISM, (r * 0.75, y * 0.52, base + tall * 0.68), (0.22, 0.22, 0.03), (1, 3), rotation=turn("y", 62), material=dark)
        kit.add(BALL, (-r * 0.1, y * 1.3, base + tall * 0.45), (0.62, 0.55, 0.62), material=gold if kit.chance(0.4) else grey)
    box(kit, (-r * 0.62, 0, base + tall * 0.5), (0.4, 0.85, tall * 0.42), grey, taper=(0.9, 0.9))
    kit.add(CYL, (0, 0, base + tall), (0.5, 0.5, 0.16), (0.85, 1), material=dark)
    for x, y in around(4, 1.65, 45):
        rod(kit, (x * 0.6, y * 0.6, base + tall * 0.6), (x, y, base + tall * 0.62), 0.05, metal)
        kit.add(CYL, (x, y, base + tall * 0.78), (0.1, 0.1, 0.12), (1.5, 1), material=dark)
        kit.add(CYL, (x, y, base + tall * 0.46), (0.15, 0.15, 0.12), (0.65, 1), material=dark)
    dish = turn("y", rng.uniform(20, 80))
    at = np.array([r * 0.45, -0.9, base + tall * 1.2])
    rod(kit, (r * 0.3, -0.8, base + tall * 0.85), at, 0.04, metal)
    kit.add(TUBE, at + dish @ [0, 0, 0.1], (0.12, 0.12, 0.13), (3.6, 1), rotation=dish, material=grey)
    for y in (-0.5, 0.7):
        rod(kit, (-0.3, y, base + tall * 0.8), (-0.5, y * 1.4, base + tall * 1.5), 0.015, metal)


def small_lander(kit):
    """Robot landers on three or four legs: a deck with tanks, boxes, solar wings, a dish."""
    rng = kit.rng
    gold, grey, dark, metal, cells = foil(kit), pale(kit), black(kit), steel(kit), solar(kit)
    r, low, thick, count = rng.uniform(0.7, 1.0), rng.uniform(0.55, 0.8), rng.uniform(0.15, 0.4), int(rng.choice([3, 4, 4]))
    kit.add(PRISM, (0, 0, low + thick / 2), (r, r, thick / 2), (1, int(rng.choice([4, 6, 8]))), material=gold)
    legs(kit, count, r * 0.9, r * rng.uniform(1.5, 1.9), low, low + thick, metal, rng.uniform(0.14, 0.22), first=45 if count == 4 else 60)
    top = low + thick
    for x, y in around(4, r * 0.55, 0):
        kit.add(BALL, (x, y, low - 0.02), (r * 0.24,) * 3, material=metal if kit.chance(0.5) else gold)
    kit.add(CYL, (0, 0, low - 0.15), (0.2, 0.2, 0.16), (0.5, 1), material=dark)
    if kit.chance(0.7):
        shape, sides = (PRISM, 10) if kit.chance(0.5) else (BOX, 1)
        for side in (-1, 1):
            tilt = turn("x", side * rng.uniform(-10, 25))
            wing = rng.uniform(0.5, 0.9)
            kit.add(shape, (0, side * (r + wing * 0.95), top), (wing, wing, 0.02), (1, sides), rotation=tilt, material=cells)
            rod(kit, (0, side * r * 0.7, top - 0.05), (0, side * (r + wing * 0.5), top), 0.035, metal)
    else:
        slab(kit, top, top + r * 0.9, (-r * 0.6, r * 0.6, r * 0.6), (-r * 0.45, r * 0.45, r * 0.45), cells)
    mast = np.array([r * 0.35, r * 0.2, top])
    for _ in range(int(rng.integers(3, 6))):
        half = rng.uniform(0.08, 0.2, 3)
        kit.add(rng.choice([BOX, CYL]), (rng.uniform(-0.55, 0.55) * r, rng.uniform(-0.55, 0.55) * r, top + half[2]), half, material=gold if kit.chance(0.4) else grey)
    rod(kit, mast, mast + [0, 0, rng.uniform(0.7, 1.1)], 0.03, metal)
    dish = turn("z", rng.uniform(0, 360)) @ turn("y", rng.uniform(20, 60))
    tip = kit.primitives[-1].centre * [1, 1, 2] - [0, 0, top]
    kit.add(TUBE, tip + dish @ [0, 0, 0.06], (0.06, 0.06, 0.08), (rng.uniform(4, 6), 1), rotation=dish, material=grey)
    rod(kit, tip, tip + dish @ [0, 0, 0.28], 0.012, dark)
    rod(kit, (-r * 0.6, 0, top), (-r * 0.8, 0, top + rng.uniform(0.6, 1.4)), 0.012, metal)
    if kit.chance(0.4):
        bent(kit, [(r * 0.7, -r * 0.3, top), (r * 1.2, -r * 0.4, top + 0.4), (r * 1.9, -r * 0.5, top - 0.1)], 0.03, metal)


def probe(kit):
    """Deep-space probes: a great dish over a bus of many sides, long booms, a power source or solar wings."""
    rng = kit.rng
    gold, grey, dark, metal = foil(kit), pale(kit), black(kit), steel(kit)
    tip = turn("y", rng.uniform(0, 90)) @ turn("x", rng.uniform(-30, 30))
    start, dish = len(kit.primitives), rng.uniform(0.9, 1.3)
    sides, half = int(rng.choice([6, 8, 10])), rng.uniform(0.2, 0.4)
    bus = dish * rng.uniform(0.45, 0.65)
    kit.add(PRISM, (0, 0, 0), (bus, bus, half), (1, sides), material=gold)
    kit.add(PRISM, (0, 0, half * 0.2), (bus * 1.02, bus * 1.02, half * 0.35), (1, sides), material=dark if kit.chance(0.5) else grey)
    z = half
    for low, high, rise in ((0.12, 0.5, 0.06), (0.5, 0.8, 0.1), (0.8, 1.0, 0.13)):
        kit.add(TUBE, (0, 0, z + rise * dish / 2), (dish * low, dish * low, rise * dish / 2), (high / low, 1), material=grey)
        z += rise * dish
    kit.add(CYL, (0, 0, z + dish * 0.3), (0.05, 0.05, 0.07), (2.2, 1), material=grey)
    for x, y in around(3, 1.0, 30):
        rod(kit, (x * dish * 0.75, y * dish * 0.75, half + dish * 0.14), (x * 0.05, y * 0.05, z + dish * 0.3), 0.014, metal)
    reach = dish * rng.uniform(1.4, 2.4)
    if kit.chance(0.5):
        kit.between((bus, 0, 0), (bus + reach, 0, 0), 0.07, BOX, material=metal, cut=(LATTICE, 6, 0.35))
        kit.add(CYL, (bus + reach, 0, 0), (0.1, 0.1, 0.14), rotation=ALONG_X, material=dark)
        rod(kit, (-bus, 0, 0), (-bus - reach * 0.5, 0, -0.1), 0.03, metal)
        for k in range(3):
            kit.add(CYL, (-bus - reach * 0.5 - 0.3 * k, 0, -0.1), (0.13, 0.13, 0.13), rotation=ALONG_X, material=dark._replace(pattern=RIBS, frequency=20.0, second=grey.first))
    else:
        cells, wide = solar(kit), rng.uniform(0.3, 0.5)
        for side in (-1, 1):
            rod(kit, (0, side * bus, 0), (0, side * (bus + 0.3), 0), 0.03, metal)
            for k in range(2):
                box(kit, (0, side * (bus + 0.3 + (0.5 + k) * reach * 0.42), 0), (wide, reach * 0.2, 0.015), cells)
    rod(kit, (0, bus * 0.8, -half), (0.3, bus + reach * 0.6, -half - 0.2), 0.025, metal)
    box(kit, (0.3, bus + reach * 0.6, -half - 0.2), (0.14, 0.2, 0.12), gold)
    kit.add(CYL, (0.3, bus + reach * 0.6 + 0.25, -half - 0.2), (0.08, 0.08, 0.14), rotation=ALONG_Y, material=dark)
    kit.add(CYL, (0, 0, -half - 0.14), (0.22, 0.22, 0.16), (0.45, 1), material=dark)
    for x, y in around(4, bus * 0.85, 20):
        kit.add(BOX if kit.chance(0.6) else CYL, (x, y, -half * 0.9), rng.uniform(0.07, 0.16, 3), material=grey if kit.chance(0.5) else gold)
    for _ in range(int(rng.integers(1, 3))):
        end = np.array([rng.uniform(-0.6, 0.6), rng.uniform(-0.8, -0.4), -rng.uniform(0.5, 1.0)]) * reach
        rod(kit, (0, -bus * 0.8, -half * 0.8), end, 0.012, metal)
    kit.primitives[start:] = [p._replace(centre=tip @ p.centre, rotation=tip @ p.rotation) for p in kit.primitives[start:]]


def rover_probe(kit):
    """Rovers on six wheels with rocker arms, a mast with cameras, an arm and a power source."""
    rng = kit.rng
    gold, grey, dark, metal = foil(kit), pale(kit), black(kit), steel(kit)
    wheel, long, wide = rng.uniform(0.22, 0.28), rng.uniform(0.95, 1.15), rng.uniform(0.75, 0.95)
    tread = near(kit, (0.3, 0.3, 0.3), (0.08, 0.08, 0.08), pattern=RIBS, frequency=30, gloss=0.2)
    for x in (-long, 0, long):
        disc(kit, (x, wide, wheel), wheel, 0.16, tread, True, ALONG_Y)
        disc(kit, (x, wide, wheel), wheel * 0.5, 0.17, metal, True, ALONG_Y)
        rod(kit, (x, wide - 0.24, wheel), (x, wide - 0.24, wheel + 0.35), 0.035, metal, True)
    deck, pivot = wheel * 2 + 0.3, (0.15, wide - 0.24, wheel + 0.55)
    rod(kit, (long, wide - 0.24, wheel + 0.35), pivot, 0.04, metal, True)
    rod(kit, pivot, (-long * 0.5, wide - 0.24, wheel + 0.38), 0.04, metal, True)
    rod(kit, (0, wide - 0.24, wheel + 0.35), (-long, wide - 0.24, wheel + 0.35), 0.035, metal, True)
    rod(kit, (0.15, -wide + 0.24, wheel + 0.55), (0.15, wide - 0.24, wheel + 0.55), 0.04, metal)
    box(kit, (0, 0, deck + 0.1), (long * 0.75, wide * 0.55, 0.18), gold if kit.chance(0.5) else grey)
    if kit.chance(0.5):
        box(kit, (-0.1, 0, deck + 0.32), (long * 1.0, wide * 1.0, 0.02), solar(kit))
    else:
        box(kit, (0, 0, deck + 0.3), (long * 0.8, wide * 0.62, 0.025), grey)
        kit.add(PRISM, (-long * 1.05, 0, deck + 0.35), (0.2, 0.2, 0.3), (1, 8), rotation=turn("y", -45), material=dark._replace(pattern=RIBS, frequency=15.0, second=grey.first))
        rod(kit, (-long * 0.7, 0, deck + 0.1), (-long * 1.0, 0, deck + 0.3), 0.06, metal)
    head = np.array([long * 0.6, rng.choice([-1, 1]) * wide * 0.35, deck + rng.uniform(1.0, 1.3)])
    rod(kit, head * [1, 1, 0] + [0, 0, deck + 0.3], head, 0.05, grey)
    box(kit, head, (0.1, 0.24, 0.09), grey)
    for y in (-0.13, 0.13):
        disc(kit, head + [0.1, y, 0], 0.05, 0.02, dark, rotation=ALONG_X)
    bent(kit, [(long * 0.75, 0, deck), (long * 1.15, 0, deck + 0.4), (long * 1.5, 0, deck - 0.1)], 0.04, metal)
    box(kit, (long * 1.52, 0, deck - 0.18), (0.1, 0.1, 0.1), dark)
    kit.add(PRISM, (-long * 0.3, -wide * 0.4, deck + 0.45), (0.2, 0.2, 0.02), (1, 6), rotation=turn("y", 25), material=grey)
    rod(kit, (-long * 0.3, -wide * 0.4, deck + 0.28), (-long * 0.3, -wide * 0.4, deck + 0.45), 0.025, metal)
    rod(kit, (-long * 0.6, wide * 0.4, deck + 0.3), (-long * 0.6, wide * 0.4, deck + 0.9), 0.025, dark)
