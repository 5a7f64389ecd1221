"""Makers of crabs, scorpions, spiders, insects, snails, octopuses, starfish and jellyfish, and of seahorses."""

import itertools

import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, Head, black, hull
from .birds import membrane, sail
from .hides import GOLD, skin
from .kit import around, towards, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, DOTS, PLAIN, SEAMS, SPECKLES, STREAKS, STRIPES, WAVES, paint


def claw(kit, at, way, size, coat):
    """A pincer at `at` that points along the angle `way` in degrees, its two fingers apart; with its twin."""
    frame = turn("z", way)
    at = np.array(at, float)
    kit.add(BALL, at, np.array([0.5, 0.32, 0.24]) * size, rotation=frame, material=coat, mirror=True)
    for y, bow in ((0.16, 0.3), (-0.16, -0.3)):
        knuckle, tip = at + frame @ np.array([0.75, y + bow * 0.6, 0]) * size, at + frame @ np.array([1.15, y * 0.2, 0]) * size
        kit.chain([at + frame @ np.array([0.25, y, 0]) * size, knuckle, tip], np.array([0.17, 0.13, 0.04]) * size, coat, mirror=True, joints=False)


def shellfish(kit):
    """Crabs, lobsters, scorpions."""
    rng = kit.rng
    name = str(rng.choice(["crab", "lobster", "scorpion"]))
    coat = skin(
        kit,
        *{"crab": (ORANGE, (0.5, 0.08, 0.03), TAN, (0.1, 0.2, 0.3)), "lobster": ((0.55, 0.05, 0.02), (0.03, 0.08, 0.2), ORANGE)}.get(name, (BLACK, GOLD, BROWN)),
        pattern=rng.choice([PLAIN, CLOUDY, SPECKLES]),
        gloss=0.4,
    )
    dark = black(kit)
    if name == "crab":
        z, legs = 0.24, ((0.2, 55), (0.05, 85), (-0.1, 105), (-0.22, 130))
        kit.add(BALL, (0, 0, z), (0.34, 0.5, 0.16), material=coat)
        kit.add(BALL, (0.04, 0, z - 0.04), (0.3, 0.44, 0.14), material=skin(kit, CREAM))
        kit.chain([(0.22, 0.36, z), (0.42, 0.58, z + 0.02), (0.58, 0.45, z)], [0.1, 0.09, 0.08], coat, mirror=True)
        claw(kit, (0.72, 0.36, z), -35, rng.uniform(0.25, 0.36), coat)
        kit.between((0.28, 0.12, z + 0.06), (0.34, 0.13, z + 0.22), 0.022, material=coat, mirror=True)
        kit.add(BALL, (0.34, 0.13, z + 0.23), (0.035,) * 3, material=dark, mirror=True)
        reach, root = 0.55, 0.32
    else:
        scorpion = name == "scorpion"
        z, legs = 0.15, ((0.18, 60), (0.08, 82), (-0.02, 105), (-0.12, 128))
        kit.add(BALL, (0.15, 0, z), (0.36, 0.15, 0.12), material=coat)
        for k in range(5):
            kit.add(CYL, (-0.1 - 0.12 * k, 0, z - 0.005 * k), (0.11 - 0.008 * k, 0.15 - 0.012 * k, 0.075), (0.88, 1), rotation=turn("y", -90), material=coat)
        if scorpion:
            tail_way = [(-0.62, 0, z), (-0.85, 0, z + 0.15), (-0.92, 0, z + 0.42), (-0.78, 0, z + 0.66), (-0.52, 0, z + 0.72), (-0.36, 0, z + 0.62)]
            for a, b in itertools.pairwise(tail_way):
                kit.add(BALL, (np.array(a) + b) / 2, (0.07, 0.07, 0.16), rotation=towards(np.subtract(b, a)), material=coat)
            kit.between(tail_way[-1], (-0.26, 0, z + 0.46), 0.04, CYL, 0.1, dark)
        else:
            for angle in (-50, -25, 0, 25, 50):
                kit.add(
                    BALL, np.array([-0.66, 0, z - 0.03]) + turn("z", 180 + angle) @ np.array([0.16, 0, 0]), (0.15, 0.06, 0.02), rotation=turn("z", 180 + angle), material=coat
                )
            kit.chain([(0.48, 0.04, z + 0.04), (0.75, 0.2, z + 0.25), (0.3, 0.75, z + 0.35)], [0.016, 0.01, 0.006], coat, mirror=True)
        kit.chain([(0.36, 0.1, z), (0.5, 0.3, z), (0.78, 0.3, z)], [0.05, 0.055, 0.05], coat, mirror=True)
        claw(kit, (0.92, 0.26, z), -8, rng.uniform(0.3, 0.42) if not scorpion else 0.25, coat)
        kit.add(BALL, (0.45, 0.06, z + 0.09), (0.03,) * 3, material=dark, mirror=True)
        reach, root = 0.42, 0.1
    for x, angle in legs:
        out = turn("z", angle) @ np.array([reach, 0, 0])
        kit.chain([(x, root, z), (x + out[0] * 0.5, root + out[1] * 0.55, z + 0.12), (x + out[0], root + out[1], 0.0)], [0.045, 0.035, 0.01], coat, mirror=True, joints=False)


def insect(kit):
    """Spiders, beetles (stag, rhinoceros, ladybird), ants, bees, wasps, grasshoppers, mantises."""
    rng = kit.rng
    name = str(rng.choice(["spider", "ladybird", "stag", "rhino", "ant", "bee", "wasp", "grasshopper", "mantis"]))
    dark, glass = skin(kit, BLACK, DARK, pattern=PLAIN, gloss=0.5), skin(kit, (0.6, 0.62, 0.6), pattern=SEAMS, frequency=14, second=DARK, gloss=0.5)
    legs, z, y, reach, knee, thin = ((0.2, 50), (0.02, 95), (-0.15, 135)), 0.22, 0.12, 0.45, 0.1, 0.026
    limbs = dark
    if name == "spider":
        coat = skin(kit, BLACK, BROWN, TAN, GREY, GOLD, pattern=rng.choice([PLAIN, BANDS, SPECKLES]), frequency=12, gloss=0.1)
        limbs, z, reach, knee = coat, 0.24, rng.uniform(0.65, 0.95), rng.uniform(0.25, 0.5)
        kit.add(BALL, (-0.38, 0, 0.28), (0.34, 0.25, 0.24), rotation=turn("y", -12), material=coat)
        kit.add(BALL, (0.08, 0, z), (0.2, 0.16, 0.12), material=coat)
        kit.between((0.22, 0.05, z), (0.34, 0.05, z - 0.14), 0.045, CYL, 0.4, dark, mirror=True)
        for p, r in (((0.24, 0.045, z + 0.08), 0.028), ((0.2, 0.1, z + 0.07), 0.022)):
            kit.add(BALL, p, (r,) * 3, material=dark, mirror=True)
        kit.chain([(0.2, 0.1, z - 0.03), (0.36, 0.15, z + 0.03), (0.46, 0.1, z - 0.12)], [0.03, 0.025, 0.02], coat, mirror=True)
        legs, thin = ((0.15, 35), (0.08, 70), (0.02, 105), (-0.04, 145)), rng.uniform(0.02, 0.042)
    elif name in ("ladybird", "stag", "rhino"):
        colours = {"ladybird": ((0.6, 0.03, 0.01), ORANGE), "stag": (DARK, (0.12, 0.04, 0.02)), "rhino": (BLACK, (0.1, 0.05, 0.02), (0.02, 0.15, 0.08))}[name]
        coat = skin(kit, *colours, pattern=DOTS if name == "ladybird" else PLAIN, frequency=7.5, second=BLACK, gloss=0.55)
        long, high = (0.36, 0.3) if name == "ladybird" else (0.44, 0.22)
        kit.add(BALL, (-0.2, 0.01, 0.2), (long, 0.3, high), material=coat, mirror=True)
        kit.add(BALL, (-0.2, 0, 0.15), (long * 0.95, 0.28, 0.12), material=dark)
        kit.add(BOX, (-0.24, 0, 0.2 + high), (long * 0.6, 0.006, 0.012), material=dark)
        kit.add(BALL, (0.2, 0, 0.2), (0.17, 0.23 if name != "ladybird" else 0.2, 0.15), material=dark if name == "ladybird" else coat)
        kit.add(BALL, (0.38, 0, 0.17), (0.12, 0.13, 0.09), material=dark)
        if name == "ladybird":
            kit.add(BALL, (0.27, 0.13, 0.26), (0.06, 0.05, 0.05), material=skin(kit, WHITE, pattern=PLAIN), mirror=True)
            kit.chain([(0.45, 0.06, 0.2), (0.58, 0.15, 0.26)], 0.012, dark, mirror=True)
        elif name == "stag":
            kit.chain([(0.46, 0.07, 0.17), (0.66, 0.22, 0.2), (0.86, 0.2, 0.2), (0.95, 0.06, 0.2)], [0.045, 0.045, 0.035, 0.012], coat, mirror=True)
            kit.between((0.72, 0.21, 0.2), (0.75, 0.08, 0.2), 0.03, CYL, 0.2, coat, mirror=True)
        else:
            hull(kit, [(0.44, 0, 0.2), (0.72, 0, 0.3), (0.8, 0, 0.55)], [0.065, 0.05, 0.02], coat)
            kit.between((0.25, 0, 0.33), (0.42, 0, 0.45), 0.05, CYL, 0.2, coat)
        kit.add(BALL, (0.42, 0.1, 0.2), (0.028,) * 3, material=black(kit), mirror=True)
        z, y, reach = 0.16, 0.2, 0.35
    elif name == "ant":
        coat = limbs = skin(kit, BLACK, RED, BROWN, pattern=PLAIN, gloss=0.45)
        kit.add(BALL, (-0.5, 0, 0.32), (0.3, 0.19, 0.19), rotation=turn("y", 8), material=coat)
        kit.add(BALL, (-0.2, 0, 0.3), (0.07, 0.05, 0.09), material=coat)
        kit.add(BALL, (0.05, 0, 0.31), (0.24, 0.1, 0.11), material=coat)
        kit.add(BALL, (0.4, 0, 0.33), (0.17, 0.16, 0.13), rotation=turn("y", 25), material=coat)
        kit.chain([(0.5, 0.06, 0.38), (0.62, 0.2, 0.52), (0.85, 0.3, 0.42)], [0.018, 0.015, 0.014], coat, mirror=True)
        kit.chain([(0.5, 0.08, 0.25), (0.64, 0.1, 0.2), (0.68, 0.02, 0.18)], [0.035, 0.03, 0.01], coat, mirror=True)
        kit.add(BALL, (0.43, 0.13, 0.37), (0.035,) * 3, material=black(kit), mirror=True)
        z, y, reach, knee = 0.28, 0.07, 0.55, 0.18
    elif name in ("bee", "wasp"):
        coat = skin(kit, GOLD, pattern=BANDS, frequency=13 if name == "bee" else 16, second=BLACK, gloss=0.2)
        fuzz, fat = skin(kit, GOLD, BROWN, DARK, gloss=0.02) if name == "bee" else dark, 1.0 if name == "bee" else 0.75
        hull(kit, [(-0.7, 0, 0.24), (-0.45, 0, 0.32), (-0.2, 0, 0.35)], np.array([0.07, 0.2, 0.12 if name == "wasp" else 0.2]) * fat, coat)
        kit.between((-0.7, 0, 0.24), (-0.86, 0, 0.18), 0.03, CYL, 0.1, dark)
        kit.add(BALL, (0.08, 0, 0.38), (0.22, 0.2 * fat, 0.2 * fat), material=fuzz)
        kit.add(BALL, (0.36, 0, 0.34), (0.12, 0.15, 0.14), material=dark if name == "bee" else coat._replace(pattern=PLAIN))
        kit.add(BALL, (0.4, 0.11, 0.38), (0.07, 0.05, 0.1), material=black(kit), mirror=True)
        kit.chain([(0.46, 0.05, 0.4), (0.56, 0.1, 0.5), (0.66, 0.14, 0.42)], 0.015, dark, mirror=True)
        up = rng.uniform(5, 45)
        for x, span, back in ((0.05, 0.75, -0.15), (-0.08, 0.55, -0.35)):
            way = np.array([back, np.cos(np.radians(up)), np.sin(np.radians(up))]) * span
            kit.between((x, 0.1, 0.53), np.array([x, 0.1, 0.53]) + way, (0.01, 0.09), BOX, 1.9, glass, mirror=True)
        z, y, reach = 0.3, 0.12, 0.32
    elif name == "grasshopper":
        coat = limbs = skin(kit, (0.15, 0.4, 0.04), (0.3, 0.3, 0.08), TAN, pattern=rng.choice([PLAIN, SPECKLES]))
        hull(kit, [(-0.75, 0, 0.26), (-0.3, 0, 0.32), (0.1, 0, 0.36)], [0.05, 0.12, 0.14], coat, 0.85)
        kit.add(BALL, (0.14, 0, 0.4), (0.2, 0.14, 0.17), material=coat)
        kit.add(BALL, (0.37, 0, 0.38), (0.12, 0.12, 0.18), rotation=turn("y", -15), material=coat)
        kit.add(BALL, (0.42, 0.1, 0.46), (0.06, 0.035, 0.07), material=black(kit), mirror=True)
        kit.add(BOX, (-0.4, 0.09, 0.44), (0.5, 0.014, 0.08), rotation=turn("y", -6), material=skin(kit, (0.2, 0.35, 0.08), TAN, pattern=STREAKS), mirror=True)
        kit.chain([(0.45, 0.05, 0.5), (0.9, 0.2, 0.75)], [0.014, 0.006], coat, mirror=True)
        hull(kit, [(-0.12, 0.15, 0.34), (-0.6, 0.28, 0.78)], [0.085, 0.035], coat, mirror=True)
        kit.chain([(-0.6, 0.28, 0.78), (-0.85, 0.32, 0.04), (-0.68, 0.34, 0.02)], [0.03, 0.022, 0.016], coat, mirror=True)
        legs, z, y, reach = ((0.25, 50), (0.08, 95)), 0.3, 0.1, 0.35
    else:
        coat = limbs = skin(kit, (0.15, 0.42, 0.05), TAN, (0.4, 0.42, 0.1), pattern=PLAIN)
        hull(kit, [(-0.8, 0, 0.4), (-0.4, 0, 0.42), (-0.05, 0, 0.45)], [0.05, 0.12, 0.07], coat)
        hull(kit, [(-0.05, 0, 0.45), (0.3, 0, 0.82)], [0.06, 0.055], coat)
        kit.add(BOX, (-0.42, 0.06, 0.54), (0.42, 0.07, 0.012), rotation=turn("x", -35), material=coat, mirror=True)
        kit.add(CYL, (0.36, 0, 0.9), (0.09, 0.13, 0.09), (0.3, 1), rotation=turn("y", 150), material=coat)
        kit.add(BALL, (0.37, 0.11, 0.95), (0.05, 0.045, 0.06), material=black(kit), mirror=True)
        kit.chain([(0.4, 0.04, 0.97), (0.75, 0.2, 1.2)], [0.012, 0.005], coat, mirror=True)
        kit.chain([(0.25, 0.06, 0.76), (0.5, 0.14, 0.5), (0.62, 0.1, 0.86), (0.7, 0.08, 0.62)], [0.035, 0.05, 0.035, 0.012], coat, mirror=True)
        legs, z, y, reach, knee = ((0.05, 60), (-0.12, 120)), 0.43, 0.06, 0.55, 0.2
    for x, angle in legs:
        out = turn("z", angle) @ np.array([reach, 0, 0])
        joints = [(x, y, z), (x + out[0] * 0.45, y + out[1] * 0.5, z + knee), (x + out[0] * 0.85, y + out[1] * 0.9, 0.04), (x + out[0] * 1.05, y + out[1] * 1.05, 0.01)]
        kit.chain(joints, [thin * 1.4, thin * 1.1, thin * 0.8, thin * 0.5], limbs, mirror=True, joints=False)


def winged_insect(kit):
    """Butterflies and moths with spread or lifted wings, dragonflies."""
    rng = kit.rng
    body = skin(kit, BLACK, DARK, BROWN, (0.02, 0.2, 0.3), gloss=0.2)
    if kit.chance(0.6):
        main = paint(rng.choice([0.05, 0.09, 0.14, 0.55, 0.6, 0.75, 0.3]), rng.uniform(0.5, 1), rng.uniform(0.3, 0.8))
        wing = kit.material(base=main, pattern=rng.choice([SEAMS, DOTS, PLAIN, WAVES, CAMOUFLAGE]), frequency=rng.uniform(4, 9), second=BLACK, gloss=0.05)
        edge = kit.material(base=BLACK if kit.chance(0.7) else main * 0.4, pattern=SPECKLES, frequency=18, second=WHITE, gloss=0.05)
        lift = rng.choice([rng.uniform(0, 25), rng.uniform(35, 75)])
        c, s = np.cos(np.radians(lift)), np.sin(np.radians(lift))
        z = 0.12
        hull(kit, [(-0.42, 0, z - 0.02), (-0.15, 0, z), (0.12, 0, z)], [0.025, 0.05, 0.06], body)
        kit.add(BALL, (0.24, 0, z + 0.01), (0.06, 0.055, 0.055), material=body)
        kit.chain([(0.27, 0.02, z + 0.04), (0.52, 0.2, z + 0.14)], [0.009, 0.007], body, mirror=True)
        kit.add(BALL, (0.53, 0.21, z + 0.145), (0.018,) * 3, material=body, mirror=True)

        def strips(outline, thin, material):
            membrane(kit, [(front, rear, 0.02 + y * c, z + 0.03 + y * s) for front, rear, y in outline], thin, material)

        strips([(0.12, -0.06, 0), (0.32, -0.08, 0.3), (0.5, -0.02, 0.62), (0.55, 0.1, 0.82)], 0.012, wing)
        strips([(0.55, 0.1, 0.82), (0.53, 0.2, 0.92)], 0.0125, edge)
        strips([(-0.0, -0.22, 0), (-0.05, -0.52, 0.25), (-0.1, -0.6, 0.5)], 0.011, wing)
        strips([(-0.1, -0.6, 0.5), (-0.2, -0.48, 0.66)], 0.0115, edge)
        sail(
            kit,
            (-0.85, 0.02 + 0.36 * c, z + 0.03 + 0.36 * s),
            (-0.5, 0.02 + 0.22 * c, z + 0.03 + 0.22 * s),
            (-0.55, 0.02 + 0.42 * c, z + 0.03 + 0.42 * s),
            0.011,
            edge,
            mirror=True,
        )
        for x, reach in ((0.1, 0.12), (0, 0.0), (-0.08, -0.1)):
            kit.chain([(x, 0.03, z - 0.03), (x + reach, 0.14, 0.0)], [0.012, 0.006], body, mirror=True)
    else:
        coat = skin(kit, (0.02, 0.25, 0.4), (0.1, 0.4, 0.1), (0.5, 0.05, 0.02), GOLD, pattern=BANDS, frequency=14, second=BLACK, gloss=0.5)
        glass = skin(kit, (0.55, 0.6, 0.6), (0.5, 0.4, 0.25), pattern=SEAMS, frequency=12, second=DARK, gloss=0.5)
        hull(kit, [(-1.05, 0, 0.2), (-0.3, 0, 0.21), (-0.05, 0, 0.24)], [0.035, 0.035, 0.07], coat)
        kit.add(BALL, (0.08, 0, 0.25), (0.2, 0.11, 0.13), material=coat)
        kit.add(BALL, (0.32, 0, 0.26), (0.09, 0.11, 0.09), material=body)
        kit.add(BALL, (0.34, 0.085, 0.29), (0.09, 0.085, 0.09), material=skin(kit, (0.1, 0.3, 0.2), RED, pattern=PLAIN, gloss=0.6), mirror=True)
        lift, sweep = rng.uniform(-5, 20), rng.uniform(-0.05, 0.15)
        c, s = np.cos(np.radians(lift)), np.sin(np.radians(lift))
        for x, wide in ((0.1, 0.13), (-0.08, 0.17)):
            outline = [(x + 0.05, x - 0.03, 0), (x + 0.09, x - wide, 0.3), (x + 0.1 - sweep, x - wide - sweep * 0.5, 0.75), (x + 0.02 - sweep, x - 0.1 - sweep, 0.95)]
            membrane(kit, [(a, b, 0.03 + y * c, 0.34 + y * s) for a, b, y in outline], 0.008, glass)
        for x, reach in ((0.18, 0.14), (0.08, 0.04), (0.0, -0.1)):
            kit.chain([(x, 0.06, 0.16), (x + reach, 0.16, 0.1), (x + reach * 1.3, 0.17, 0.0)], [0.016, 0.012, 0.006], body, mirror=True)


def mollusc(kit):
    """Snails, octopuses, starfish, seahorses, jellyfish."""
    rng = kit.rng
    name = str(rng.choice(["snail", "octopus", "starfish", "seahorse", "jellyfish"]))
    coat = skin(kit, ORANGE, RED, PINK, TAN, (0.35, 0.1, 0.3), GOLD, (0.08, 0.2, 0.35), pattern=rng.choice([PLAIN, CLOUDY, SPECKLES]), frequency=14, gloss=0.3)
    if name == "snail":
        flesh = skin(kit, TAN, GREY, (0.35, 0.25, 0.15), pattern=SPECKLES, frequency=22)
        shell = skin(kit, TAN, BROWN, CREAM, GOLD, pattern=rng.choice([BANDS, CLOUDY, STREAKS]), frequency=16, gloss=0.4)
        hull(kit, [(-0.7, 0, 0.03), (-0.2, 0, 0.09), (0.4, 0, 0.1), (0.68, 0, 0.24)], [0.03, 0.11, 0.12, 0.1], flesh, 1.15)
        for z, far in ((0.3, 0.24), (0.2, 0.1)):
            kit.chain([(0.72, 0.05, z), (0.78 + far * 0.5, 0.1, z + far)], [0.022, 0.016], flesh, mirror=True)
            kit.add(BALL, (0.78 + far * 0.5, 0.1, z + far), (0.026,) * 3, material=black(kit) if far > 0.2 else flesh, mirror=True)
        t = np.linspace(0, 1, 17)
        angle, radius = np.radians(-75) - 2 * np.pi * 2.0 * t, 0.3 * (1 - t) + 0.02
        for k, (a, r) in enumerate(zip(angle, radius, strict=True)):
            at = np.array([-0.1 + r * np.cos(a), 0.12 * t[k] - 0.02, 0.45 + r * np.sin(a)])
            size = 0.19 * (1 - t[k]) + 0.06
            kit.add(BALL, at, (min(size * 1.6, r + size * 0.6), size * 0.9, size), rotation=turn("y", -90 - np.degrees(a)), material=shell)
    elif name == "octopus":
        kit.add(BALL, (-0.12, 0, 0.52), (0.3, 0.26, 0.33), rotation=turn("y", -25), material=coat)
        kit.add(BALL, (0.02, 0, 0.26), (0.24, 0.22, 0.18), material=coat)
        kit.add(BALL, (0.14, 0.15, 0.37), (0.08, 0.07, 0.08), material=coat, mirror=True)
        kit.add(BALL, (0.18, 0.19, 0.39), (0.045, 0.045, 0.03), material=black(kit), mirror=True)
        for k, (x, y) in enumerate(around(8, 1.0, 22)):
            curl, reach = rng.uniform(-0.5, 0.5), rng.uniform(0.7, 1.0)
            side = np.array([-y, x, 0]) * curl
            way = np.array([x, y, 0])
            end_up = rng.choice([0.03, 0.2])
            path = [
                way * 0.14 + [0, 0, 0.2],
                way * 0.4 + side * 0.12 + [0, 0, 0.1],
                way * reach * 0.75 + side * 0.4 + [0, 0, 0.045],
                way * reach * 0.9 + side * 0.95 + [0, 0, end_up],
            ]
            kit.chain(path, [0.11, 0.085, 0.055, 0.02], coat)
    elif name == "starfish":
        arms = int(rng.choice([5, 5, 5, 6]))
        coat = coat._replace(pattern=SPECKLES, frequency=20.0, second=np.array(CREAM))
        kit.add(BALL, (0, 0, 0.1), (0.25, 0.25, 0.13), material=coat)
        for x, y in around(arms, 1.0, 0):
            bow = np.array([-y, x, 0]) * rng.uniform(-0.12, 0.12)
            hull(
                kit,
                [(x * 0.15, y * 0.15, 0.09), np.array([x * 0.5, y * 0.5, 0.07]) + bow, np.array([x * 0.85, y * 0.85, 0.04]) + bow * 2],
                [0.15, 0.11, 0.035],
                coat,
                first=False,
            )
            for r in (0.25, 0.45, 0.65):
                kit.add(
                    BALL, np.array([x * r, y * r, 0.21 - 0.16 * r]) + bow * max(0, r * 2 - 0.1), (0.03,) * 3, material=skin(kit, CREAM, pattern=PLAIN) if r == 0.25 else coat
                )
    elif name == "seahorse":
        ridge = coat._replace(pattern=BANDS, frequency=22.0)
        path = [(0.02, 0, 1.0), (0.0, 0, 0.82), (0.1, 0, 0.62), (0.06, 0, 0.42), (-0.06, 0, 0.28), (-0.04, 0, 0.12), (0.08, 0, 0.06), (0.15, 0, 0.12), (0.1, 0, 0.17)]
        hull(kit, path, [0.085, 0.09, 0.15, 0.11, 0.07, 0.05, 0.038, 0.028, 0.02], ridge, 0.75)
        head = Head(kit, (0.06, 0, 1.05), turn("y", 25), 0.1)
        head.ball((0, 0, 0), (1.1, 0.8, 0.9), coat)
        kit.between(head.place(0.5, 0, -0.1), head.place(2.4, 0, -0.15), 0.04, CYL, 0.8, coat)
        head.ball((2.4, 0, -0.15), (0.35, 0.42, 0.45), coat)
        head.eyes(0.4, 0.65, 0.15, 0.17)
        for k in range(5):
            kit.between((-0.02 - 0.015 * k, 0, 1.1 - 0.02 * k), (-0.02 - 0.07 * k, 0, 1.24 - 0.04 * k), 0.025, CYL, 0.15, coat)
        sail(kit, (-0.2, 0, 0.66), (-0.02, 0, 0.72), (-0.03, 0, 0.5), 0.012, skin(kit, CREAM, GOLD, pattern=STRIPES, frequency=30))
        kit.add(BALL, (-0.02, 0.08, 0.92), (0.07, 0.015, 0.05), material=coat, mirror=True)
    else:
        bell = skin(kit, PINK, (0.4, 0.5, 0.7), WHITE, ORANGE, (0.4, 0.2, 0.5), pattern=CLOUDY, gloss=0.5)
        kit.loft((0, 0, 0.9), [(0, 0.46), (0.1, 0.48), (0.24, 0.42), (0.36, 0.28), (0.43, 0.12)], bell)
        kit.add(BALL, (0, 0, 1.0), (0.47, 0.47, 0.36), material=bell)
        for k, (x, y) in enumerate(around(10, 0.4)):
            low = rng.uniform(0, 0.35)
            kit.chain(
                [(x, y, 0.92), (x * 1.1 + rng.normal(0, 0.05), y * 1.1 + rng.normal(0, 0.05), 0.5), (x + rng.normal(0, 0.1), y + rng.normal(0, 0.1), low)],
                [0.022, 0.016, 0.01],
                bell,
                joints=False,
            )
        for x, y in around(4, 0.12, 45):
            hull(kit, [(x, y, 0.95), (x * 1.5, y * 1.5, 0.6), (x * 0.8, y * 0.8, 0.25)], [0.09, 0.07, 0.03], coat, first=False)
