"""Makers of camps and exercise areas: tents, kitchens, hospitals, cabins, stores, generators, light towers, toilets, helipads, targets, obstacle courses."""

import numpy as np

from .earthworks import bag, cast, rusty, sacking, swing
from .extent import bounds
from .installations import BLUE, CONCRETE, GREEN, GREY, OLIVE, ORANGE, RED, RUST, SAND, WHITE, WOOD, YELLOW, stairs, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .launchers import drab, metal, timber
from .layout import BALL, BARS, BOX, CYL, GRID, PRISM, RUNGS, TUBE
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, WRITING
from .wheeled import glazing


def canvas(kit):
    return tinted(kit, (OLIVE, SAND, (0.16, 0.16, 0.09), OLIVE, WHITE), (PLAIN, CLOUDY, CAMOUFLAGE, PLAIN), frequency=kit.rng.uniform(5, 10), gloss=0.02)


def tent(kit, style=None, x0=0.0, skin=None):
    rng = kit.rng
    skin, dark, pole = skin or canvas(kit), kit.material(dark=True, pattern=PLAIN), timber(kit)
    style = style or rng.choice(["ridge", "frame", "geodesic", "tunnel", "marquee", "bell", "pyramid"])
    long, wide, eave = rng.uniform(1.8, 3.4), rng.uniform(1.3, 2.0), rng.uniform(1.2, 1.6)
    top = eave + wide * rng.uniform(0.4, 0.7)
    if style in ("ridge", "frame"):
        eave = eave if style == "frame" else rng.uniform(0.3, 0.6)
        kit.add(BOX, (x0, 0, eave / 2), (long, wide, eave / 2), material=skin)
        kit.add(BOX, (x0, 0, (eave + top) / 2), (long * 1.01, wide * 1.06, (top - eave) / 2), (1, 0.02), material=skin)
        kit.add(BOX, (x0 + long, 0, top * 0.38), (0.03, wide * 0.3, top * 0.38), (1, 0.35), material=dark)
        kit.add(BOX, (x0 + long + 0.03, wide * 0.34, top * 0.36), (0.04, 0.1, top * 0.36), (1, 0.4), (0, -wide * 0.1), material=skin, mirror=True)
        for x in np.linspace(-0.7, 0.7, 4) * long + x0:
            if style == "frame":
                kit.add(BOX, (x, wide, eave * 0.6), (0.25, 0.02, eave * 0.18), material=dark, mirror=True)
            kit.between((x, wide * 1.04, eave), (x, wide * 1.04 + eave * 0.8, 0), 0.012, material=pole, mirror=True)
        kit.between((x0 - long * 1.02, 0, top), (x0 + long * 1.02, 0, top), 0.03, material=pole)
    elif style == "geodesic":
        kit.loft(
            (x0, 0, 0),
            [(0, wide * 1.3), (top * 0.35, wide * 1.22), (top * 0.7, wide * 0.85), (top * 0.95, wide * 0.35), (top, wide * 0.02)],
            skin,
            PRISM,
            sides=int(rng.integers(6, 11)),
        )
        kit.add(BOX, (x0 + wide * 1.15, 0, top * 0.32), (wide * 0.3, wide * 0.35, top * 0.34), (0.8, 0.6), material=skin)
        kit.add(BOX, (x0 + wide * 1.44, 0, top * 0.28), (0.03, wide * 0.25, top * 0.28), (1, 0.6), material=dark)
    elif style == "tunnel":
        points = [(wide * np.cos(a), top * np.sin(a) * 0.95) for a in np.linspace(0, np.pi / 2, 6)]
        for (w0, z0), (w1, z1) in zip(points[:-1], points[1:], strict=True):
            kit.add(BOX, (x0, 0, (z0 + z1) / 2), (long, w0, (z1 - z0) / 2), (1, max(w1 / w0, 0.02)), material=skin)
            for x in (-0.98, -0.33, 0.33, 0.98):
                kit.add(
                    BOX, (x0 + x * long, 0, (z0 + z1) / 2), (0.07, w0 + 0.05, (z1 - z0) / 2 + 0.02), (1, max(w1 / w0, 0.05)), material=skin._replace(first=skin.first * 0.75)
                )
        kit.add(BOX, (x0 + long, 0, top * 0.36), (0.12, wide * 0.35, top * 0.36), material=dark)
    elif style == "marquee":
        count = int(rng.integers(1, 4))
        for k in range(count):
            x = x0 + (k - (count - 1) / 2) * 2 * wide
            kit.add(BOX, (x, 0, 2.05), (wide * 1.02, wide * 1.02, 0.16), material=skin)
            kit.add(BOX, (x, 0, 2.5), (wide * 1.02, wide * 1.02, 0.3), (0.45, 0.45), material=skin)
            kit.add(BOX, (x, 0, 3.1), (wide * 0.46, wide * 0.46, 0.32), (0.12, 0.12), material=skin)
            if count == 1 or k:
                kit.add(BOX, (x, 0, 1.0), (wide * 0.97, wide * 0.97, 1.0), material=skin)
            for px in (-wide, wide):
                kit.between((x + px, wide, 0), (x + px, wide, 2.0), 0.05, material=pole, mirror=True)
    else:
        sides, low = (4, 0.9) if style == "pyramid" else (12, 0.7)
        spin = turn("z", 0)
        kit.loft((x0, 0, 0), [(0, wide * 1.2), (low, wide * 1.15), (low + 0.02, wide * 1.25), (top + 0.5, wide * 0.06)], skin, PRISM, spin, sides=sides)
        kit.add(BOX, (x0 + wide * 1.12, 0, 0.75), (0.1, 0.4, 0.75), (1, 0.5), (-0.25, 0), material=dark)
        kit.between((x0, 0, top + 0.4), (x0, 0, top + 0.8), 0.05, material=pole)
        for x, y in around(8, 1, 22.5):
            kit.between((x0 + wide * 1.2 * x, wide * 1.2 * y, low), (x0 + wide * 1.7 * x, wide * 1.7 * y, 0), 0.012, material=pole)


def field_kitchen(kit):
    paint, steel, dark, skin = drab(kit), metal(kit, 0.3, 0.55), kit.material(dark=True, pattern=PLAIN), canvas(kit)
    kit.add(BOX, (0, 0, 0.62), (1.2, 0.7, 0.08), material=paint)
    kit.add(CYL, (-0.1, 0.78, 0.38), (0.38, 0.38, 0.11), rotation=ALONG_Y, material=dark, mirror=True)
    kit.add(CYL, (-0.1, 0.82, 0.38), (0.2, 0.2, 0.1), rotation=ALONG_Y, material=paint, mirror=True)
    kit.between((1.15, 0.5, 0.6), (2.2, 0, 0.55), 0.05, BOX, material=paint, mirror=True)
    kit.between((2.1, 0, 0), (2.1, 0, 0.6), 0.05, material=dark)
    kit.between((-1.1, 0.6, 0), (-1.1, 0.6, 0.6), 0.04, material=dark, mirror=True)
    for k in range(2):
        for side in (-0.34, 0.34):
            x = -0.75 + 0.75 * k
            kit.add(BOX, (x, side, 0.95), (0.34, 0.32, 0.27), material=paint)
            kit.add(CYL, (x, side, 1.28), (0.27, 0.27, 0.08), material=steel)
            kit.add(BALL, (x, side, 1.36), (0.26, 0.26, 0.1), material=steel)
    kit.between((0.75, 0, 0.65), (0.75, 0, 2.9), 0.09, material=dark)
    kit.add(CYL, (0.75, 0, 2.95), (0.15, 0.15, 0.06), material=dark)
    kit.add(BOX, (0.75, 0, 0.9), (0.3, 0.5, 0.25), material=paint)
    if kit.chance(0.6):
        for x in (-1.3, 0.5):
            kit.between((x, 1.3, 0), (x, 1.3, 2.1), 0.03, material=steel, mirror=True)
        kit.add(BOX, (-0.4, 0, 2.3), (1.05, 1.45, 0.22), (1, 0.05), material=skin)
    kit.add(BOX, (-0.3, 1.9, 0.72), (0.8, 0.3, 0.03), material=timber(kit))
    for x in (-1.0, 0.4):
        kit.add(BOX, (x, 1.9, 0.35), (0.03, 0.28, 0.35), material=steel)
    for x in (-0.7, -0.1):
        kit.add(CYL, (x, 1.9, 0.87), (0.15, 0.15, 0.13), material=steel)


def box_cabin(kit, x, y, z, half, paint, glass, dark, spin=0):
    """A freight container as a room: ribbed, with corner posts, a door at +y and windows."""
    turned, base = turn("z", spin), np.array([x, y, z + 1.2])
    kit.add(BOX, base, (half, 1.1, 1.12), rotation=turned, material=paint)
    for end in (-1, 1):
        kit.add(BOX, base + turned @ [end * (half - 0.06), 0, 0], (0.09, 1.16, 1.2), rotation=turned, material=paint._replace(pattern=PLAIN))
    kit.add(BOX, base + turned @ [half * 0.3, 1.1, -0.15], (0.42, 0.04, 1.0), rotation=turned, material=dark)
    kit.add(BOX, base + turned @ [-half * 0.4, 0, 0.25], (0.45, 1.13, 0.38), rotation=turned, material=glass)
    kit.add(BOX, base + turned @ [half + 0.2, 0.4, 0.5], (0.2, 0.4, 0.3), rotation=turned, material=tinted(kit, (WHITE, GREY)))


def cabin_paint(kit):
    return tinted(kit, (SAND, WHITE, OLIVE, GREY, BLUE), (RIBS,), frequency=kit.rng.uniform(10, 18), gloss=0.08)


def field_hospital(kit):
    paint, red, white, dark = (
        cabin_paint(kit),
        kit.material(base=(0.55, 0.02, 0.02), pattern=PLAIN),
        kit.material(base=(0.8, 0.8, 0.78), pattern=PLAIN),
        kit.material(dark=True),
    )
    skin = canvas(kit)
    tent(kit, kit.rng.choice(["frame", "tunnel"]), 0, skin)
    reach = bounds(kit.primitives)[0][0]
    for k, y in enumerate((-1.3, 1.3)[: int(kit.rng.integers(1, 3))]):
        box_cabin(kit, reach - 2.4, y, 0, 2.6, paint, glazing(kit), dark, 0 if k else 180)
        side = 1 if k else -1
        kit.add(BOX, (reach - 1.5, y + side * 1.12, 1.45), (0.5, 0.05, 0.5), material=white)
        kit.add(BOX, (reach - 1.5, y + side * 1.15, 1.45), (0.4, 0.05, 0.12), material=red)
        kit.add(BOX, (reach - 1.5, y + side * 1.15, 1.45), (0.12, 0.05, 0.4), material=red)
    kit.add(BOX, (reach - 2.4, 0, 2.45), (0.75, 0.75, 0.06), material=white)
    kit.add(BOX, (reach - 2.4, 0, 2.5), (0.6, 0.18, 0.05), material=red)
    kit.add(BOX, (reach - 2.4, 0, 2.5), (0.18, 0.6, 0.05), material=red)


def command_post(kit):
    rng = kit.rng
    steel, dark, paint = metal(kit), kit.material(dark=True), drab(kit)
    tent(kit, rng.choice(["frame", "geodesic", "pyramid"]))
    reach = bounds(kit.primitives)[0][0]
    box_cabin(kit, reach - 1.3, 0, 0.5, 1.5, paint, glazing(kit), dark)
    for x in (-2.2, -0.5):
        kit.add(CYL, (reach + x, 0.9, 0.4), (0.4, 0.4, 0.16), rotation=ALONG_Y, material=dark, mirror=True)
    high = rng.uniform(5, 8)
    kit.between((reach - 3.3, 0, 0), (reach - 3.3, 0, high), 0.07, CYL, 0.5, material=steel)
    kit.between((reach - 2.7, 0, 2.4), (reach - 3.3, 0, 2.4), 0.06, material=steel)
    for x, y in around(3, 1.4):
        kit.between((reach - 3.3 + x, y, 0), (reach - 3.3, 0, high * 0.6), 0.015, material=steel)
    for z in (high, high * 0.93, high * 0.86):
        kit.between((reach - 3.3, -0.5, z), (reach - 3.3, 0.5, z), 0.02, material=steel)
    if kit.chance(0.5):
        kit.add(CYL, (reach - 1.3, 0, 3.3), (0.5, 0.5, 0.06), (0.7, 1), rotation=turn("y", 50), material=tinted(kit, (WHITE, GREY)))
        kit.between((reach - 1.3, 0, 2.8), (reach - 1.3, 0, 3.3), 0.05, material=steel)


def container_camp(kit):
    rng = kit.rng
    dark, steel, count = kit.material(dark=True), metal(kit), int(rng.integers(2, 4))
    paint, two = cabin_paint(kit), kit.chance(0.6)
    for k in range(count):
        for level in range(2 if two and (k < count - 1 or kit.chance(0.5)) else 1):
            box_cabin(kit, 0, 0, 0, 2.6, paint if kit.chance(0.7) else cabin_paint(kit), glazing(kit), dark)
            swing(kit, len(kit.primitives) - 6, turn("z", -90), (0, (k - (count - 1) / 2) * 2.4, 2.42 * level))
    if two:
        y = -(count - 1) * 1.2
        kit.add(BOX, (3.2, 0, 2.42), (0.6, count * 1.2, 0.06), material=steel)
        stairs(kit, (3.2, y - 3.8, 0), (3.2, y - 1.2, 2.4), 0.45, steel)
        kit.railing((3.75, -count * 1.2, 2.45), (3.75, count * 1.2, 2.45), 1.0, steel, 0.3)
        for side in (-1, 1):
            kit.between((3.7, side * count * 1.15, 0), (3.7, side * count * 1.15, 2.4), 0.06, BOX, material=steel)


def fuel_bladder(kit):
    skin, liner, steel = tinted(kit, (SAND, OLIVE, (0.04, 0.04, 0.04)), (PLAIN, SEAMS)), kit.material(dark=True, gloss=0.2), metal(kit)
    long, count = kit.rng.uniform(1.6, 2.4), int(kit.rng.integers(1, 4))
    for k in range(count):
        y = (k - (count - 1) / 2) * 3.2
        kit.add(BOX, (0, y, 0.03), (long + 0.3, 1.5, 0.03), material=liner)
        bag(kit, (0, y, 0.45), (long, 1.25, 0.45), 0, skin)
        for side in (-1, 1):
            kit.add(BOX, (0, y + side * 1.45, 0.2), (long + 0.4, 0.16, 0.2), (0.98, 0.4), material=liner)
            kit.add(BOX, (side * (long + 0.3), y, 0.2), (0.16, 1.4, 0.2), (0.4, 1), material=liner)
        kit.add(CYL, (0, y, 0.92), (0.18, 0.18, 0.06), material=steel)
        kit.chain([(long * 0.9, y, 0.4), (long + 0.5, y, 0.5), (long + 0.9, y, 0.07)], 0.06, liner)
    kit.between((long + 0.9, -1.6 * count, 0.07), (long + 0.9, 1.6 * count, 0.07), 0.07, material=liner)
    kit.add(BOX, (long + 1.1, 1.6 * count, 0.3), (0.3, 0.4, 0.3), material=drab(kit))


def pallet(kit, x, y, wood):
    kit.add(BOX, (x, y, 0.13), (0.6, 0.5, 0.02), material=wood)
    for side in (-0.42, 0, 0.42):
        kit.add(BOX, (x, y + side, 0.055), (0.6, 0.06, 0.055), material=wood)


def ammunition(kit):
    rng = kit.rng
    crate, wood, brass, dark = tinted(kit, (OLIVE, WOOD, OLIVE), (PLANKS, PLAIN), frequency=9), timber(kit), drab(kit), kit.material(dark=True)
    levels, count = int(rng.integers(2, 5)), int(rng.integers(2, 4))
    for k in range(count):
        for level in range(levels - (k == count - 1) * int(rng.integers(0, 2))):
            at = (rng.normal(0, 0.03), (k - 1) * 1.05, 0.17 + 0.31 * level)
            kit.add(BOX, at, (0.42, 0.5, 0.15), material=crate)
            kit.add(BOX, (at[0] + 0.25, at[1], at[2]), (0.04, 0.51, 0.16), material=wood)
            kit.add(BOX, (at[0] - 0.25, at[1], at[2]), (0.04, 0.51, 0.16), material=wood)
    for k in range(int(rng.integers(2, 6))):
        at = (0.9, (k - 2) * 0.3, 0)
        kit.loft(at, [(0, 0.1), (0.5, 0.1), (0.72, 0.06), (0.85, 0.015)], brass)
    kit.add(BOX, (0.9, 1.0, 0.13), (0.3, 0.2, 0.13), material=crate)
    kit.add(BOX, (0.7, 1.0, 0.4), (0.02, 0.2, 0.18), rotation=turn("y", -20), material=dark)


def pallets(kit):
    rng = kit.rng
    wood = timber(kit)
    for k in range(int(rng.integers(1, 4))):
        y, goods = 1.25 * k, rng.choice(["sacks", "boxes", "drums", "wrapped"])
        pallet(kit, 0, y, wood)
        if goods == "sacks":
            sand = sacking(kit)
            for level in range(3):
                for x in (-0.3, 0.3):
                    bag(kit, (x, y, 0.26 + 0.21 * level), (0.31, 0.48, 0.13), rng.normal(0, 3), sand)
        elif goods == "boxes":
            card = tinted(kit, ((0.38, 0.25, 0.13), OLIVE, WHITE), (PLAIN, WRITING), frequency=9)
            for level in range(3):
                for x in (-0.29, 0.29):
                    for side in (-0.24, 0.24):
                        if level < 2 or kit.chance(0.6):
                            kit.add(BOX, (x, y + side, 0.34 + 0.385 * level), (0.28, 0.23, 0.19), material=card)
        elif goods == "drums":
            paint = tinted(kit, (BLUE, OLIVE, RED, RUST))
            for x in (-0.29, 0.29):
                for side in (-0.25, 0.25):
                    kit.add(CYL, (x, y + side, 0.55), (0.25, 0.25, 0.4), material=paint)
                    kit.add(TUBE, (x, y + side, 0.55), (0.265, 0.265, 0.16), material=paint)
        else:
            high = rng.uniform(0.4, 0.7)
            kit.add(BOX, (0, y, 0.15 + high), (0.57, 0.47, high), material=tinted(kit, (WHITE, GREY, (0.1, 0.1, 0.1)), gloss=0.5))
            kit.add(BOX, (0.2, y, 0.15 + high), (0.03, 0.48, high + 0.01), material=kit.material(dark=True))


def cans(kit):
    rng = kit.rng
    paint, dark = tinted(kit, (OLIVE, OLIVE, SAND, RED)), kit.material(dark=True)
    if kit.chance(0.5):
        for row in range(2):
            for k in range(int(rng.integers(3, 6))):
                x, y = 0.55 * row, 0.24 * k
                kit.add(BOX, (x, y, 0.2), (0.17, 0.08, 0.2), material=paint)
                kit.add(BOX, (x, y, 0.43), (0.17, 0.08, 0.035), (0.7, 0.8), (-0.03, 0), material=paint)
                kit.add(BOX, (x - 0.02, y, 0.51), (0.1, 0.06, 0.012), material=paint)
                kit.add(BOX, (x - 0.02, y, 0.48), (0.015, 0.06, 0.03), material=paint)
                kit.add(CYL, (x + 0.14, y, 0.48), (0.035, 0.035, 0.035), material=dark)
    else:
        for k in range(int(rng.integers(4, 12))):
            x, y = 0.64 * (k % 2), 0.64 * (k // 2)
            kit.add(CYL, (x, y, 0.44), (0.29, 0.29, 0.44), material=paint if kit.chance(0.8) else rusty(kit))
            for z in (0.02, 0.3, 0.58, 0.86):
                kit.add(TUBE, (x, y, z), (0.305, 0.305, 0.022), material=paint)


def generator(kit):
    rng = kit.rng
    paint, dark, long = tinted(kit, (OLIVE, SAND, YELLOW, WHITE, GREEN)), kit.material(dark=True), rng.uniform(1.0, 1.7)
    kit.add(BOX, (0, 0, 0.12), (long * 1.05, 0.6, 0.12), material=dark)
    kit.add(BOX, (0, 0, 0.8), (long, 0.58, 0.58), material=paint)
    kit.add(BOX, (0, 0, 1.42), (long * 1.02, 0.6, 0.05), (0.95, 0.9), material=paint)
    for x in (-0.5, 0.1):
        kit.add(BOX, (x * long, 0, 0.75), (long * 0.22, 0.59, 0.4), material=paint._replace(first=paint.first * 0.8))
    kit.add(BOX, (long, 0, 0.85), (0.02, 0.42, 0.38), material=dark, cut=(RUNGS, 8, 0.6))
    kit.add(BOX, (0.7 * long, 0, 0.9), (0.2, 0.6, 0.22), material=dark)
    kit.between((-0.6 * long, 0.2, 1.4), (-0.6 * long, 0.2, 1.8), 0.06, material=dark)
    kit.add(BOX, (-0.3 * long, 0.585, 0.8), (0.04, 0.02, 0.08), material=dark, mirror=True)
    kit.chain([(-long, 0.3, 0.3), (-long - 0.4, 0.4, 0.05), (-long - 1.0, 0.1, 0.05)], 0.04, dark)


def light_tower(kit):
    rng = kit.rng
    paint, steel, dark, lamp = (
        tinted(kit, (YELLOW, OLIVE, WHITE, ORANGE)),
        metal(kit, 0.3, 0.5),
        kit.material(dark=True),
        kit.material(base=(0.9, 0.9, 0.8), pattern=PLAIN, gloss=0.6),
    )
    high = rng.uniform(4, 6.5)
    kit.add(BOX, (0, 0, 0.8), (0.95, 0.55, 0.4), (0.95, 0.85), material=paint)
    kit.add(CYL, (-0.1, 0.65, 0.32), (0.32, 0.32, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
    kit.between((0.9, 0, 0.45), (1.9, 0, 0.45), 0.05, BOX, material=steel)
    kit.between((1.8, 0, 0), (1.8, 0, 0.5), 0.04, material=steel)
    for x in (-0.8, 0.8):
        kit.between((x, 0.5, 0.45), (x, 1.2, 0.45), 0.04, BOX, material=steel, mirror=True)
        kit.between((x, 1.2, 0), (x, 1.2, 0.6), 0.04, material=steel, mirror=True)
    for k, radius in enumerate((0.1, 0.075, 0.05)):
        kit.between((0.7, 0, 0.5 if k == 0 else high * k / 3), (0.7, 0, high * (k + 1) / 3), radius, BOX, material=steel)
    kit.between((0.7, -0.9, high), (0.7, 0.9, high), 0.04, BOX, material=steel)
    for y in (0.3, 0.8):
        kit.add(BOX, (0.78, y, high + 0.02), (0.12, 0.22, 0.2), rotation=turn("y", 20), material=dark, mirror=True)
        kit.add(BOX, (0.89, y, high - 0.02), (0.02, 0.19, 0.17), rotation=turn("y", 20), material=lamp, mirror=True)


def toilets(kit):
    rng = kit.rng
    paint, white, dark, count = tinted(kit, (BLUE, GREEN, OLIVE, ORANGE, GREY)), tinted(kit, (WHITE,)), kit.material(dark=True), int(rng.integers(1, 6))
    for k in range(count):
        y = 1.2 * (k - (count - 1) / 2)
        kit.add(BOX, (0, y, 0.08), (0.56, 0.54, 0.08), material=dark)
        kit.add(BOX, (0, y, 1.1), (0.52, 0.52, 0.98), material=paint)
        kit.add(BOX, (0.52, y, 1.1), (0.03, 0.38, 0.88), material=paint._replace(first=paint.first * 0.7))
        kit.add(BOX, (0, y, 2.2), (0.57, 0.57, 0.14), (0.8, 0.6), material=white)
        kit.add(BOX, (0.55, y + 0.28, 1.1), (0.02, 0.03, 0.06), material=dark)
        kit.add(BOX, (0.55, y, 1.65), (0.02, 0.14, 0.12), material=white)
        kit.between((-0.4, y + 0.4, 2.1), (-0.4, y + 0.4, 2.5), 0.05, material=dark)


def helipad(kit):
    rng = kit.rng
    stone, white, steel = cast(kit), tinted(kit, (WHITE, YELLOW)), metal(kit)
    radius, sides, high = 4.0, int(rng.choice([4, 8, 8, 30])), rng.choice([0.15, 1.8])
    kind = CYL if sides == 30 else PRISM
    turned = turn("z", 180 / sides)
    kit.add(kind, (0, 0, high), (radius, radius, 0.15), (1, sides), rotation=turned, material=stone)
    kit.add(CYL, (0, 0, high + 0.155), (radius * 0.86, radius * 0.86, 0.01), material=white)
    kit.add(CYL, (0, 0, high + 0.165), (radius * 0.78, radius * 0.78, 0.01), material=tinted(kit, (GREY, GREEN, CONCRETE, BLUE)))
    kit.add(BOX, (0, 0.85, high + 0.175), (1.5, 0.22, 0.015), material=white, mirror=True)
    kit.add(BOX, (0, 0, high + 0.175), (0.22, 0.8, 0.015), material=white)
    for x, y in around(8, radius * 0.95, 22.5):
        kit.add(CYL, (x, y, high + 0.2), (0.1, 0.1, 0.07), material=tinted(kit, (YELLOW, GREEN), gloss=0.4))
        if high > 1:
            kit.between((x * 0.85, y * 0.85, 0), (x * 0.85, y * 0.85, high), 0.12, material=steel)
    base = 0 if high < 1 else high
    kit.between((radius * 0.97, 0, base), (radius * 0.97, 0, base + 2.6), 0.05, material=steel)
    for k in range(3):
        kit.add(
            CYL,
            (radius * 0.97 - 0.25 - 0.45 * k, 0, base + 2.5 - 0.07 * k),
            (0.22 - 0.04 * k, 0.22 - 0.04 * k, 0.24),
            (0.8, 1),
            rotation=ALONG_X.T,
            material=tinted(kit, (RED, WHITE)[k % 2 : k % 2 + 1]),
        )


def targets(kit):
    rng = kit.rng
    wood, face = timber(kit), tinted(kit, (GREEN, (0.04, 0.04, 0.04), OLIVE, (0.38, 0.25, 0.13), WHITE))
    kind = rng.choice(["man", "round", "tank"])
    for k in range(int(rng.integers(1, 6)) if kind != "tank" else 1):
        y = 1.3 * k
        if kind == "tank":
            kit.add(BOX, (0, 0, 0.75), (0.03, 2.2, 0.45), (1, 0.9), material=face)
            kit.add(BOX, (0, -0.2, 1.5), (0.03, 1.0, 0.3), (1, 0.7), material=face)
            kit.add(BOX, (0, 1.7, 1.5), (0.03, 1.2, 0.07), material=face)
            for side in (-1.6, 0, 1.6):
                kit.between((-0.06, side, 0), (-0.06, side, 1.2), 0.05, BOX, material=wood)
                kit.between((-0.9, side, 0), (-0.06, side, 1.0), 0.04, BOX, material=wood)
            continue
        kit.between((-0.05, y + 0.2, 0), (-0.05, y + 0.2, 1.5), 0.03, BOX, material=wood)
        kit.between((-0.05, y - 0.2, 0), (-0.05, y - 0.2, 1.5), 0.03, BOX, material=wood)
        kit.add(BOX, (-0.05, y, 0.06), (0.35, 0.3, 0.06), material=wood)
        if kind == "man":
            kit.add(BOX, (0, y, 1.1), (0.02, 0.3, 0.4), (1, 0.9), material=face)
            kit.add(BOX, (0, y, 1.56), (0.02, 0.27, 0.07), (1, 0.5), material=face)
            kit.add(CYL, (0, y, 1.75), (0.15, 0.14, 0.02), rotation=ALONG_X, material=face)
        for n, shade in enumerate((0.75, 0.04, 0.75, 0.04)[: 4 if kind == "round" else 2]):
            radius = (0.5 if kind == "round" else 0.16) * (1 - 0.26 * n)
            kit.add(CYL, (0.025 + 0.008 * n, y, 1.15), (radius, radius, 0.02), rotation=ALONG_X, material=kit.material(base=(shade, shade, shade), pattern=PLAIN))


def obstacle_course(kit):
    rng = kit.rng
    wood, rope = timber(kit), tinted(kit, (SAND,))
    kinds = rng.permutation(["wall", "bars", "net", "beams"])[: int(rng.integers(1, 4))]
    for k, kind in enumerate(kinds):
        x = 2.6 * k
        if kind == "wall":
            kit.add(BOX, (x, 0, 1.1), (0.06, 1.1, 1.1), material=wood)
            for y in (-1, 0, 1):
                kit.between((x, y, 0), (x, y, 2.25), 0.08, BOX, material=wood)
                kit.between((x - 1.0, y, 0), (x, y, 1.9), 0.06, BOX, material=wood)
            kit.between((x + 0.1, 0.5, 0.1), (x + 0.08, 0.5, 2.2), 0.025, material=rope)
            continue
        for px in (-0.9, 0.9) if kind != "beams" else ():
            kit.between((x + px, 1.0, 0), (x + px, 1.0, 2.4), 0.07, material=wood, mirror=True)
            kit.between((x + px, -1.1, 2.4), (x + px, 1.1, 2.4), 0.06, material=wood)
        if kind == "bars":
            kit.add(BOX, (x, 0, 2.5), (1.0, 1.0, 0.04), material=wood, cut=(BARS, 3, 0.25))
        elif kind == "net":
            kit.add(BOX, (x + 0.9, 0, 1.2), (0.03, 1.0, 1.2), material=rope, cut=(GRID, 4, 0.18))
            kit.add(BOX, (x - 0.9, 0, 1.2), (0.03, 1.0, 1.2), material=rope, cut=(GRID, 4, 0.18))
            kit.between((x - 0.9, 0, 2.4), (x + 0.9, 0, 2.4), 0.06, material=wood)
        else:
            for px, high in ((-0.9, 0.6), (0, 1.1), (0.9, 0.8)):
                kit.between((x + px, 1.1, 0), (x + px, 1.1, high + 0.2), 0.07, material=wood, mirror=True)
                kit.between((x + px, -1.2, high), (x + px, 1.2, high), 0.09, material=wood)
