"""Makers of what stands in yards: concrete mixers, bins, skips, gas cylinders, letter boxes."""

import numpy as np

from .belongings import black, brass, pale, steel
from .fittings import bent, box, disc, iron, near, pick, planks, posts, rod
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, PRISM, SPOKES, TUBE
from .materials import BANDS, CLOUDY, PLAIN, RIBS, STREAKS, WRITING
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
