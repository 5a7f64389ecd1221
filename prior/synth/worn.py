"""Makers of what is worn: helmets, boots, shoes, headphones, glasses, watches."""

import numpy as np

from .belongings import arc, black, brass, cloth, enamel, leather, lens, pale, ribbon, steel
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, RIBS, STREAKS, STRIPES, paint


def dome(kit, base, radius, height, material, flat=1.0, steps=9):
    angles = np.radians(np.linspace(0, 86, steps))
    kit.loft(base, [(height * np.sin(a), radius * np.cos(a)) for a in angles], material, flat=flat)


def helmet(kit):
    rng = kit.rng
    kind = rng.choice(["army", "motor", "works", "cycle"])
    dark, wide = black(kit), rng.uniform(0.8, 0.92)
    if kind == "army":
        shell = kit.material(
            base=paint(rng.uniform(0.1, 0.3), rng.uniform(0.1, 0.6), rng.uniform(0.05, 0.35)),
            pattern=rng.choice([PLAIN, CAMOUFLAGE, CLOUDY, STREAKS]),
            frequency=rng.uniform(4, 10),
        )
        high, skirt = rng.uniform(0.48, 0.6), rng.uniform(0.1, 0.28)
        flare = rng.uniform(1.02, 1.22)
        dome(kit, (0, 0, skirt), 0.62, high, shell, wide)
        kit.add(TUBE, (0, 0, skirt / 2), (0.62 * flare, 0.62 * flare * wide, skirt / 2), (1 / flare, 1), material=shell)
        kit.add(TUBE, (0, 0, skirt / 2), (0.58 * flare, 0.58 * flare * wide, skirt / 2), (1 / flare, 1), material=dark)
        style = rng.random()
        if style < 0.35:
            kit.add(CYL, (0, 0, skirt + 0.07), (0.635, 0.635 * wide, 0.035), (0.98, 1), material=leather(kit))
        elif style < 0.7:
            kit.add(BOX, (0.58, 0, skirt + 0.24), (0.05, 0.1, 0.1), rotation=turn("y", -20), material=dark)
            kit.add(BOX, (0, 0.6 * wide, skirt + 0.04), (0.26, 0.04, 0.03), material=dark, mirror=True)
            kit.add(BOX, (-0.02, 0.56 * flare * wide, 0.05), (0.2, 0.05, skirt * 0.6), (0.9, 1), material=shell, mirror=True)
        if kit.chance(0.4):
            kit.add(BOX, (0.6, 0.17, skirt + 0.16), (0.09, 0.15, 0.09), rotation=turn("z", 15) @ turn("y", -15), material=lens(kit), mirror=True)
            kit.add(BOX, (0.62, 0, skirt + 0.17), (0.05, 0.07, 0.03), material=dark)
        if kit.chance(0.5):
            kit.chain(arc((0.05, 0, skirt * 0.3), (0.58, 0.3), 0, -180, 6, "yx"), 0.025, leather(kit), joints=False)
    elif kind == "motor":
        shell = enamel(kit)
        shell = shell._replace(pattern=rng.choice([PLAIN, PLAIN, STRIPES, CAMOUFLAGE]), frequency=rng.uniform(2, 5))
        kit.add(CYL, (-0.03, 0, 0.14), (0.5, 0.42, 0.14), material=dark)
        kit.add(BALL, (0, 0, 0.62), (0.62, 0.54, 0.58), material=shell)
        open_face = kit.chance(0.3)
        if not open_face:
            kit.add(BALL, (0.2, 0, 0.34), (0.54, 0.46, 0.28), material=shell)
            kit.add(BOX, (0.69, 0, 0.3), (0.05, 0.13, 0.05), material=dark)
        kit.add(BALL, (0.16, 0, 0.65), (0.52, 0.5, 0.22 if not open_face else 0.3), material=lens(kit) if kit.chance(0.7) else steel(kit))
        kit.add(CYL, (0.12, 0.5, 0.64), (0.1, 0.1, 0.07), rotation=ALONG_Y, material=dark, mirror=True)
        if open_face or kit.chance(0.35):
            kit.add(BOX, (0.62, 0, 0.98), (0.3, 0.36, 0.02), (0.8, 0.9), rotation=turn("y", rng.uniform(0, 18)), material=enamel(kit))
        else:
            kit.add(BALL, (-0.25, 0, 1.0), (0.35, 0.2, 0.17), material=shell)
        kit.add(BALL, (0, 0, 0.64), (0.6, 0.1, 0.59), material=enamel(kit))
    elif kind == "works":
        shell = kit.material(
            base=[[0.85, 0.55, 0.02], [0.85, 0.83, 0.8], [0.7, 0.05, 0.03], [0.03, 0.15, 0.6], [0.8, 0.25, 0.02], [0.1, 0.4, 0.1]][rng.integers(6)],
            pattern=PLAIN,
            gloss=0.4,
        )
        high = rng.uniform(0.45, 0.56)
        kit.add(TUBE, (0, 0, 0.05), (0.54, 0.54 * wide, 0.05), material=dark)
        brim = rng.uniform(1.08, 1.4)
        kit.add(CYL, (0, 0, 0.1), (0.6 * brim, 0.6 * brim * wide, 0.02), (0.95, 1), material=shell)
        kit.add(CYL, (0.32, 0, 0.09), (0.52, 0.45, 0.02), rotation=turn("y", 4), material=shell)
        dome(kit, (0, 0, 0.1), 0.6, high, shell, wide)
        for y in (-0.13, 0, 0.13)[:: int(rng.choice([1, 2]))]:
            kit.chain(arc((0, y, 0.1), (0.6, high + 0.01 - abs(y) * 0.2), 28, 152, 6), 0.04, shell, joints=False)
        kit.add(BOX, (0.56, 0, 0.28), (0.03, 0.09, 0.07), rotation=turn("y", -25), material=enamel(kit))
        if kit.chance(0.35):
            kit.add(BALL, (0, 0.62 * wide, 0.14), (0.17, 0.1, 0.2), material=enamel(kit), mirror=True)
    else:
        shell, high = enamel(kit), rng.uniform(0.45, 0.55)
        dome(kit, (0, 0, 0.04), 0.64, high - 0.05, dark, 0.68)
        for y in (0, 0.15, 0.29):
            kit.chain(arc((0, y, 0.1), (0.7 - y * 0.4, high - y * 0.5), 5, 175, 7), 0.075, shell, mirror=y > 0, joints=False)
        kit.add(TUBE, (0, 0, 0.1), (0.68, 0.46, 0.09), material=shell)
        if kit.chance(0.5):
            kit.add(CYL, (0.55, 0, 0.16), (0.3, 0.32, 0.02), rotation=turn("y", 12), material=dark)


def footwear(kit):
    rng = kit.rng
    pair = kit.chance(0.65)
    y = rng.uniform(0.24, 0.34) if pair else 0.0
    hide, sole, dark = leather(kit), black(kit), black(kit)
    kind = rng.choice(["boot", "trainer", "heel", "wellington", "slipper"])

    def add(shape, centre, half, material, taper=(1, 1), shift=(0, 0), rotation=None):
        kit.add(shape, (centre[0], y + centre[1], centre[2]), half, taper, shift, rotation, material, pair)

    def bar(start, end, radius, material, shape=BOX, taper=1.0):
        kit.between((start[0], y + start[1], start[2]), (end[0], y + end[1], end[2]), radius, shape, taper, material, pair)

    if kind == "heel":
        high, hide = rng.uniform(0.35, 0.65), enamel(kit) if kit.chance(0.7) else hide
        add(BALL, (0.42, 0, 0.1), (0.3, 0.17, 0.1), hide)
        add(BOX, (0.35, 0, 0.015), (0.28, 0.13, 0.015), sole, (0.9, 0.9))
        bar((0.22, 0, 0.04), (-0.36, 0, high), (0.03, 0.14), hide)
        for side in (-1, 1):
            bar((0.3, side * 0.13, 0.1), (-0.4, side * 0.12, high + 0.1), (0.07, 0.02), hide, taper=1.5)
        add(CYL, (-0.42, 0, high + 0.08), (0.15, 0.14, 0.1), hide, (1.05, 1))
        add(CYL, (-0.4, 0, high + 0.185), (0.12, 0.11, 0.004), dark)
        thin = rng.uniform(0.2, 0.8)
        bar((-0.44, 0, high), (-0.48, 0, 0), 0.11, hide if kit.chance(0.5) else sole, CYL, thin)
        if kit.chance(0.4):
            add(TUBE, (-0.4, 0, high + 0.42), (0.14, 0.13, 0.03), hide)
            bar((-0.53, 0, high + 0.1), (-0.53, 0, high + 0.44), (0.015, 0.03), hide)
        return
    thick = rng.uniform(0.03, 0.09) if kind != "trainer" else rng.uniform(0.07, 0.13)
    if kind == "trainer":
        hide, sole = (enamel(kit) if kit.chance(0.6) else cloth(kit)), (pale(kit) if kit.chance(0.7) else enamel(kit))
    add(BOX, (0.05, 0, thick), (0.52, 0.19, thick), sole, (0.97, 0.95))
    add(CYL, (0.5, 0, thick * 1.1), (0.17, 0.185, thick * 0.95), sole)
    if kind in ("boot", "wellington"):
        add(BOX, (-0.32, 0, thick * 0.8), (0.2, 0.19, thick * 1.4), sole)
    add(BALL, (0.4, 0, thick + 0.13), (0.27, 0.19, 0.17), hide)
    add(BALL, (-0.3, 0, thick + 0.18), (0.28, 0.18, 0.24), hide)
    add(BOX, (0.05, 0, thick + 0.14), (0.38, 0.175, 0.15), hide, (0.8, 0.75), (-0.14, 0))
    if kind in ("boot", "wellington"):
        tall = rng.uniform(0.5, 1.0) if kind == "boot" else rng.uniform(0.8, 1.25)
        wide = rng.uniform(1.0, 1.2)
        if kind == "wellington":
            hide = enamel(kit)
            kit.primitives = [p._replace(material=hide) if p.material is not sole else p for p in kit.primitives]
        foot = thick + 0.2
        add(CYL, (-0.26, 0, foot + tall / 2), (0.24, 0.17, tall / 2), hide, (wide, 1))
        bar((0.36, 0, thick + 0.17), (-0.14, 0, foot + 0.28), (0.12, 0.15), hide, CYL, 1.05)
        top = foot + tall
        add(CYL, (-0.26, 0, top - 0.03), (0.25 * wide, 0.18 * wide, 0.04), hide if kit.chance(0.4) else cloth(kit))
        add(CYL, (-0.26, 0, top + 0.01), (0.21 * wide, 0.145 * wide, 0.008), dark)
        if kind == "boot":
            lace = pale(kit) if kit.chance(0.3) else dark
            bar((-0.02, 0, foot + 0.25), (0.0, 0, top + 0.06), (0.03, 0.08), hide)
            for k in range(int(rng.integers(3, 6))):
                z = foot + 0.2 + (tall - 0.25) * k / 5
                bar((0.02, -0.09, z), (0.02, 0.09, z), 0.015, lace)
            bar((0.3, -0.08, thick + 0.33), (0.3, 0.08, thick + 0.33), 0.015, lace)
            bar((0.16, -0.08, thick + 0.4), (0.16, 0.08, thick + 0.4), 0.015, lace)
    else:
        top = thick + 0.32
        add(CYL, (-0.3, 0, top), (0.24, 0.15, 0.1), hide, (0.95, 1))
        add(CYL, (-0.3, 0, top + 0.101), (0.19, 0.11, 0.005), dark)
        if kind == "trainer":
            trim = enamel(kit)
            bar((0.3, 0, thick + 0.22), (-0.12, 0, top + 0.17), (0.035, 0.11), trim, taper=0.9)
            for k in range(4):
                x, z = 0.24 - 0.1 * k, thick + 0.285 + 0.045 * k
                bar((x, -0.1, z), (x, 0.1, z), 0.016, pale(kit))
            for k in range(int(rng.integers(1, 4))):
                for side in (-1, 1):
                    add(BOX, (0.1 - 0.12 * k, side * 0.165, thick + 0.14), (0.025, 0.015, 0.12), trim, (1, 1), (-0.08, 0), turn("x", side * 12))
            add(BOX, (-0.53, 0, thick + 0.25), (0.03, 0.07, 0.12), trim)
        elif kit.chance(0.5):
            add(BOX, (0.18, 0, thick + 0.31), (0.06, 0.12, 0.02), enamel(kit), rotation=turn("y", 25))


def headphones(kit):
    rng = kit.rng
    shell, dark = enamel(kit), black(kit)
    half, r, tall = rng.uniform(0.5, 0.62), rng.uniform(0.24, 0.38), rng.uniform(0.5, 0.75)
    band = steel(kit) if kit.chance(0.3) else shell
    round_cups = kit.chance(0.7)
    flat = 1.0 if round_cups else rng.uniform(1.1, 1.35)
    z = r * flat
    ribbon(kit, arc((0, 0, z + 0.1), (half + 0.06, tall), 0, 90, 6, "yz"), (0.03, rng.uniform(0.05, 0.12)), band, True)
    ribbon(kit, arc((0, 0, z + 0.1), (half, tall - 0.06), 50, 90, 3, "yz"), (0.035, 0.11), dark, True)
    kit.between((0, half + 0.06, z + 0.15), (0, half + 0.06, z - 0.05), (0.05, 0.04), BOX, material=steel(kit), mirror=True)
    kit.add(CYL, (0, half + 0.03, z), (r, z, 0.09), (0.85, 1), rotation=turn("x", -90), material=shell, mirror=True)
    kit.add(CYL, (0, half - 0.12, z), (r * 0.98, z * 0.98, 0.08), rotation=turn("x", -90), material=dark, mirror=True)
    kit.add(CYL, (0, half - 0.205, z), (r * 0.55, z * 0.55, 0.006), rotation=turn("x", -90), material=cloth(kit), mirror=True)
    kit.add(CYL, (0, half + 0.125, z), (r * 0.5, r * 0.5, 0.01), rotation=turn("x", -90), material=enamel(kit), mirror=True)
    if kit.chance(0.35):
        kit.chain([(0.1, half, z * 0.8), (0.45, half * 0.7, z * 0.4), (0.6, half * 0.4, z * 0.3)], [0.02, 0.02, 0.05], dark)


def glasses(kit):
    rng = kit.rng
    frame = enamel(kit) if kit.chance(0.6) else brass(kit) if kit.chance(0.4) else steel(kit)
    glass = lens(kit) if kit.chance(0.6) else kit.material(base=np.array([0.7, 0.75, 0.8]) * rng.uniform(0.6, 1.1), pattern=PLAIN, gloss=0.64)
    rx, rz = rng.uniform(0.26, 0.33), rng.uniform(0.17, 0.3)
    middle, thick = rx + rng.uniform(0.06, 0.1), rng.uniform(0.02, 0.045)
    if kit.chance(0.6):
        kit.chain(arc((0, middle, rz + thick), (rx, rz), 0, 360, 13, "yz"), thick, frame, True, joints=False)
        kit.add(CYL, (0, middle, rz + thick), (rz, rx, 0.012), rotation=ALONG_X, material=glass, mirror=True)
    else:
        kit.add(BOX, (0, middle, rz + thick), (0.03, rx + thick, rz + thick), (1, 1), material=frame, mirror=True)
        kit.add(BOX, (0, middle, rz + thick), (0.04, rx - thick * 0.5, rz - thick * 0.5), material=glass, mirror=True)
    bridge = rz * 1.4 + thick
    kit.between((0, middle - rx * 0.98, bridge), (0, -middle + rx * 0.98, bridge), thick, material=frame)
    side, long = middle + rx, rng.uniform(1.0, 1.2)
    kit.between((0, side - 0.02, bridge), (-0.05, side + 0.04, bridge), thick * 1.4, BOX, material=frame, mirror=True)
    kit.between((-0.02, side + 0.03, bridge), (-long, side, bridge * 0.9), (thick * 1.3, thick * 0.6), BOX, material=frame, mirror=True)
    kit.between((-long, side, bridge * 0.9), (-long - 0.28, side - 0.05, 0.02), (thick * 1.3, thick * 0.7), BOX, material=frame, mirror=True)


def wristwatch(kit):
    rng = kit.rng
    case = steel(kit) if kit.chance(0.5) else brass(kit) if kit.chance(0.4) else black(kit)
    linked = kit.chance(0.35)
    strap = case._replace(pattern=RIBS, frequency=12) if linked else leather(kit) if kit.chance(0.7) else enamel(kit)
    rx, rz, wide, r = rng.uniform(0.5, 0.62), rng.uniform(0.42, 0.5), rng.uniform(0.14, 0.22), rng.uniform(0.26, 0.38)
    place = rng.uniform(35, 90)
    points = arc((0, 0, rz + 0.03), (rx, rz), place + 25, place + 335, 15)
    ribbon(kit, points, (0.03, wide), strap)
    angle = np.radians(place)
    at = np.array([rx * np.cos(angle), 0, rz + 0.03 + rz * np.sin(angle)])
    tilt = turn("y", 90 - np.degrees(np.arctan2(np.sin(angle) / rz, np.cos(angle) / rx)))
    shape = BOX if kit.chance(0.25) else CYL
    ends = (points[0], points[-1])
    for end in ends:
        kit.between(at, end, (0.03, wide * 0.9), BOX, material=case)
    kit.add(shape, at + tilt @ [0, 0, 0.03], (r, r, 0.08), rotation=tilt, material=case)
    kit.add(shape, at + tilt @ [0, 0, 0.12], (r * 0.95, r * 0.95, 0.03), (0.92, 0.92), rotation=tilt, material=case if kit.chance(0.5) else enamel(kit))
    kit.add(shape, at + tilt @ [0, 0, 0.15], (r * 0.78, r * 0.78, 0.006), rotation=tilt, material=pale(kit) if kit.chance(0.5) else lens(kit))
    hand = black(kit) if kit.chance(0.5) else steel(kit)
    for length, spin in ((0.45, rng.uniform(0, 360)), (0.68, rng.uniform(0, 360))):
        out = turn("z", spin) @ np.array([r * length, 0, 0])
        kit.between(at + tilt @ [0, 0, 0.16], at + tilt @ (out + [0, 0, 0.16]), 0.014, BOX, material=hand)
    for x, y in around(4, r * 0.66):
        kit.add(BOX, at + tilt @ [x, y, 0.155], (0.02, 0.02, 0.006), rotation=tilt, material=hand)
    kit.add(CYL, at + tilt @ [0, -r - 0.03, 0.03], (0.04, 0.04, 0.04), rotation=ALONG_Y, material=case)


def worn(kit):
    """Helmets of soldiers, riders, workers and cyclists; boots, trainers, high heels; headphones, spectacles, wristwatches."""
    kit.rng.choice([helmet, helmet, footwear, footwear, headphones, glasses, wristwatch])(kit)
