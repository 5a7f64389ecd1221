"""Makers of birds, standing or in flight, from hens and herons to ostriches and penguins."""

import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, Head, bend, black, fur, hull, looking
from .birds import folded_wing, hooked, membrane, sail
from .hides import GOLD, SILVER, SLATE
from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import CLOUDY, DOTS, PLAIN, SPECKLES, STREAKS, paint

# Half length and radius of the body, legs, rise of the body in degrees; the neck's length and radius; skull; bill's length and depth; tail.
BIRDS = {
    "heron": (0.3, 0.15, 0.6, 18, 0.62, 0.042, 0.058, 0.34, 0.034, 0.14),
    "stork": (0.32, 0.17, 0.6, 14, 0.46, 0.055, 0.066, 0.36, 0.04, 0.13),
    "flamingo": (0.28, 0.16, 0.85, 10, 0.8, 0.034, 0.055, 0.16, 0.04, 0.12),
    "ostrich": (0.42, 0.3, 0.9, 5, 0.85, 0.058, 0.078, 0.13, 0.045, 0.24),
    "crane": (0.33, 0.17, 0.68, 12, 0.62, 0.05, 0.058, 0.24, 0.032, 0.18),
    "hen": (0.28, 0.2, 0.17, 18, 0.2, 0.09, 0.075, 0.075, 0.04, 0.2),
    "cock": (0.28, 0.18, 0.24, 30, 0.26, 0.09, 0.075, 0.08, 0.042, 0.2),
    "goose": (0.38, 0.2, 0.2, 10, 0.44, 0.058, 0.075, 0.13, 0.05, 0.16),
    "duck": (0.32, 0.17, 0.11, 6, 0.2, 0.06, 0.078, 0.14, 0.045, 0.14),
    "peacock": (0.3, 0.16, 0.3, 20, 0.36, 0.052, 0.055, 0.07, 0.03, 0.2),
    "pigeon": (0.24, 0.14, 0.11, 25, 0.13, 0.07, 0.062, 0.06, 0.026, 0.25),
    "gull": (0.27, 0.13, 0.14, 12, 0.12, 0.075, 0.07, 0.11, 0.034, 0.2),
    "crow": (0.25, 0.13, 0.14, 26, 0.1, 0.08, 0.072, 0.12, 0.042, 0.24),
    "robin": (0.17, 0.13, 0.11, 36, 0.06, 0.1, 0.088, 0.06, 0.026, 0.17),
    "toucan": (0.25, 0.14, 0.1, 48, 0.11, 0.085, 0.09, 0.3, 0.085, 0.24),
    "pelican": (0.38, 0.2, 0.14, 16, 0.36, 0.062, 0.078, 0.46, 0.055, 0.12),
    "parrot": (0.27, 0.14, 0.07, 62, 0.1, 0.105, 0.1, 0.07, 0.05, 0.42),
    "eagle": (0.32, 0.19, 0.13, 55, 0.13, 0.115, 0.088, 0.09, 0.05, 0.26),
    "owl": (0.28, 0.21, 0.07, 76, 0.06, 0.19, 0.185, 0.0, 0.0, 0.16),
    "penguin": (0.44, 0.21, 0.05, 86, 0.1, 0.13, 0.115, 0.13, 0.038, 0.06),
}
# Body, wing, head, legs, bill, breast.
PLUMES = {
    "heron": [((0.35, 0.38, 0.42), SLATE, WHITE, TAN, ORANGE, WHITE), (WHITE, WHITE, WHITE, BLACK, GOLD, None)],
    "stork": [(WHITE, BLACK, WHITE, (0.6, 0.08, 0.03), (0.6, 0.08, 0.03), None)],
    "flamingo": [
        ((0.85, 0.36, 0.32), (0.8, 0.15, 0.12), (0.85, 0.4, 0.35), (0.8, 0.32, 0.3), CREAM, None),
        ((0.82, 0.55, 0.5), (0.8, 0.3, 0.25), (0.82, 0.5, 0.45), PINK, CREAM, None),
    ],
    "ostrich": [(BLACK, WHITE, PINK, PINK, TAN, None), (BROWN, BROWN, TAN, TAN, TAN, None)],
    "crane": [(SILVER, DARK, BLACK, BLACK, GREY, None), (WHITE, BLACK, WHITE, BLACK, GREY, None)],
    "hen": [(RED, RED, RED, GOLD, GOLD, None), (WHITE, WHITE, WHITE, GOLD, GOLD, None), (BLACK, BLACK, BLACK, GREY, GREY, None), (TAN, BROWN, GOLD, GOLD, GOLD, None)],
    "cock": [(BLACK, RED, ORANGE, GOLD, GOLD, BLACK), (WHITE, WHITE, WHITE, GOLD, GOLD, None), (RED, BROWN, GOLD, GOLD, GOLD, BLACK)],
    "goose": [(WHITE, WHITE, WHITE, ORANGE, ORANGE, None), (GREY, BROWN, GREY, ORANGE, ORANGE, WHITE), (BROWN, BROWN, BLACK, BLACK, BLACK, CREAM)],
    "duck": [(SILVER, BROWN, (0.02, 0.16, 0.07), ORANGE, GOLD, BROWN), (TAN, BROWN, TAN, ORANGE, TAN, None), (WHITE, WHITE, WHITE, ORANGE, ORANGE, None)],
    "peacock": [((0.01, 0.06, 0.3), TAN, (0.01, 0.06, 0.35), GREY, GREY, None)],
    "pigeon": [((0.3, 0.33, 0.38), SILVER, SLATE, (0.6, 0.15, 0.12), DARK, None), (WHITE, WHITE, WHITE, PINK, PINK, None)],
    "gull": [(WHITE, SILVER, WHITE, PINK, GOLD, None), (WHITE, SLATE, WHITE, GOLD, GOLD, None)],
    "crow": [(BLACK,) * 5 + (None,), (BLACK, BLACK, BLACK, BLACK, BLACK, WHITE)],
    "robin": [(BROWN, BROWN, BROWN, DARK, DARK, ORANGE), (TAN, BROWN, BROWN, DARK, GREY, CREAM), ((0.05, 0.2, 0.45), (0.04, 0.12, 0.3), (0.05, 0.2, 0.5), DARK, DARK, GOLD)],
    "toucan": [(BLACK, BLACK, BLACK, SLATE, ORANGE, WHITE)],
    "pelican": [(WHITE, WHITE, WHITE, ORANGE, GOLD, None), (BROWN, GREY, WHITE, DARK, GREY, None)],
    "parrot": [((0.6, 0.02, 0.02), (0.02, 0.1, 0.5), (0.6, 0.02, 0.02), DARK, CREAM, None), ((0.02, 0.15, 0.55), (0.02, 0.1, 0.4), (0.02, 0.2, 0.5), DARK, BLACK, GOLD)]
    + [((0.08, 0.4, 0.04), (0.04, 0.25, 0.05), (0.1, 0.45, 0.05), GREY, RED, None), (SILVER, GREY, SILVER, DARK, BLACK, None), (WHITE, WHITE, WHITE, GREY, DARK, None)],
    "eagle": [(DARK, DARK, WHITE, GOLD, GOLD, None), (BROWN, DARK, GOLD, GOLD, DARK, None), (SLATE, SLATE, SLATE, GOLD, DARK, CREAM)],
    "owl": [(TAN, BROWN, TAN, TAN, DARK, CREAM), (WHITE, WHITE, WHITE, WHITE, BLACK, None), (BROWN, DARK, BROWN, TAN, DARK, TAN)],
    "penguin": [(BLACK, BLACK, BLACK, DARK, ORANGE, WHITE), (SLATE, BLACK, BLACK, ORANGE, BLACK, WHITE)],
}


def bill(kit, name, head, far, deep, horn):
    """Dagger, hook, flat bill, the flamingo's bend, the pelican's pouch, the toucan's banana."""
    if name in ("parrot", "eagle"):
        hooked(head, horn, 0.2 if name == "parrot" else 0.45, 0.5)
    elif name == "flamingo":
        kit.chain([head.place(0.7, 0, 0), head.place(2.0, 0, -0.4)], [deep, deep * 1.05], horn)
        kit.between(head.place(2.0, 0, -0.4), head.place(2.5, 0, -1.7), deep * 1.05, CYL, 0.25, black(kit))
    elif name == "toucan":
        path = [head.place(0.6, 0, 0.05), head.place(2.2, 0, 0.15), head.place(3.6, 0, -0.1), head.place(4.2, 0, -0.6)]
        hull(kit, path, np.array([deep, deep * 0.92, deep * 0.6, deep * 0.2]), horn, 0.55, first=False)
    elif name in ("goose", "duck", "pelican"):
        reach = 0.8 + far / head.size
        kit.between(head.place(0.6, 0, -0.05), head.place(reach, 0, -0.3), (deep * 0.6, deep), CYL, 0.75, horn)
        head.ball((reach, 0, -0.3), (0.3, deep * 0.85 / head.size, 0.2), horn)
        if name == "pelican":
            head.ball((0.6 + reach * 0.42, 0, -0.65), (reach * 0.48, 0.45, 0.55), fur(kit, ORANGE, GOLD, pattern=PLAIN))
    elif far:
        kit.between(head.place(0.7, 0, 0), head.place(0.8 + far / head.size, 0, -0.2), (deep, deep * 0.75), CYL, 0.1, horn)


def standing_bird(kit):
    """Waders, ostriches, poultry, ducks, peacocks, pigeons, gulls, crows, songbirds, toucans, pelicans, parrots, eagles, owls, penguins."""
    rng = kit.rng
    name = str(rng.choice(list(BIRDS)))
    shape = np.array(BIRDS[name])
    shape[[0, 1, 2, 4, 5, 6, 7, 9]] *= np.exp(rng.normal(0, 0.07, 8))
    long, fat, leg, pitch, neck, thick, size, far, deep, train = shape
    pitch += rng.normal(0, 4)
    options = PLUMES[name]
    chosen = options[rng.integers(len(options))]
    body, quills, hood, shank, horn = (fur(kit, c, pattern=rng.choice([PLAIN, CLOUDY, STREAKS]) if i < 2 else PLAIN, gloss=0.08) for i, c in enumerate(chosen[:5]))
    if name == "owl":
        body = body._replace(pattern=SPECKLES, frequency=14.0)
    breast = fur(kit, chosen[5], pattern=PLAIN) if chosen[5] else None
    aim = turn("y", -pitch) @ np.array([1.0, 0, 0])
    high = np.array([-aim[2], 0, aim[0]])
    centre = np.array([0, 0, leg + fat * 0.8 * aim[0] + (long * 0.72 + fat * 0.3) * aim[2]])
    radii = np.array([0.4, 0.84, 1.0, 0.78]) * fat
    hull(kit, [centre + aim * long * t for t in (-0.9, -0.35, 0.25, 0.7)], radii, body, 0.92)
    if breast:
        kit.add(BALL, centre + aim * long * 0.2 - high * fat * 0.22, (long * 0.78, fat * 0.83, fat * 0.85), rotation=turn("y", -pitch), material=breast)
    # Neck and head.
    fore = centre + aim * long * 0.75 + high * fat * 0.3
    if name in ("heron", "flamingo", "pelican"):
        steps = [(0.16, 0, 0.1), (0.12, 0, 0.38), (-0.02, 0, 0.6), (0.02, 0, 0.85), (0.14, 0, 0.97)]
    elif neck > 0.3:
        steps = [(0.16, 0, 0.12), (0.16, 0, 0.5), (0.14, 0, 1.0)]
    else:
        steps = [(0.3, 0, 0.9)]
    path = [fore, *(fore + np.array(p) * neck for p in steps)]
    slim = name in ("ostrich", "flamingo", "heron", "stork", "crane", "goose", "peacock", "pelican")
    wide = [fat * 0.62] + ([thick * 1.45] if len(path) > 2 else []) + [thick] * (len(path) - (2 if len(path) > 2 else 1))
    hull(kit, path, wide, hood if slim or name == "duck" else body if name != "cock" else hood, first=False)
    head = Head(kit, path[-1] + [size * 0.35, 0, size * 0.3], looking(kit, 4, 30), size)
    head.ball((0, 0, 0), (1.12, 0.95, 0.95), hood)
    bill(kit, name, head, far, deep, horn)
    if name == "owl":
        head.ball((0.6, 0.4, 0.0), (0.4, 0.46, 0.58), fur(kit, CREAM, WHITE, pattern=PLAIN), True)
        head.eyes(0.88, 0.38, 0.1, 0.16, kit.material(base=paint(rng.choice([0.1, 0.14]), 0.9, 0.8), pattern=PLAIN, gloss=0.6))
        kit.between(head.place(0.95, 0, -0.05), head.place(1.1, 0, -0.45), size * 0.12, CYL, 0.1, horn)
        if kit.chance(0.5):
            head.ear("prick", 0.4, quills)
    else:
        head.eyes(0.5, 0.76, 0.28, 0.2 if name != "penguin" else 0.12)
    if name in ("hen", "cock"):
        red, big = fur(kit, (0.55, 0.03, 0.02), pattern=PLAIN), 1.0 if name == "hen" else 1.6
        for x, z in ((0.42, 1.0), (-0.22, 1.0)):
            head.ball((x, 0, z), (0.4, 0.1, 0.4 * big), red)
        head.ball((0.85, 0.15, -0.8), (0.18, 0.1, 0.36 * big), red, True)
    elif name == "peacock":
        for angle in (-25, 0, 25):
            tip = turn("y", angle - 8) @ np.array([0, 0, 1.7])
            kit.between(head.place(0, 0, 0.8), head.place(0, 0, 0.8) + tip * size, 0.006, material=horn)
            kit.add(BALL, head.place(0, 0, 0.8) + tip * size, (0.016,) * 3, material=body)
    elif name == "heron":
        head.rods([(-0.6, 0, 0.5), (-3.0, 0, 0.0)], [0.22, 0.05], quills, both=False)
    elif name == "penguin":
        head.ball((-0.1, 0.62, -0.15), (0.42, 0.36, 0.5), fur(kit, GOLD, WHITE, pattern=PLAIN), True)
    # Wings, tail, legs.
    rear = centre - aim * long * 0.95
    if name == "penguin":
        kit.add(BALL, centre + [-0.02, fat * 1.02, 0.02], (0.11, 0.025, 0.3), rotation=turn("x", 12), material=quills, mirror=True)
    elif name == "ostrich":
        kit.add(BALL, centre + [-0.1, fat * 0.8, 0.02], (0.36, 0.12, 0.22), rotation=turn("y", 10), material=body, mirror=True)
        kit.add(BALL, centre + [-0.4, fat * 0.55, -0.06], (0.16, 0.14, 0.14), material=quills, mirror=True)
        kit.add(BALL, rear + [0, 0, 0.02], (0.2, 0.13, 0.17), material=quills)
    else:
        folded_wing(
            kit,
            fore + [-0.04, fat * 0.72, 0],
            rear + [-train * 0.25, fat * 0.3, 0] - high * fat * 0.1,
            fat * 0.66,
            fat * 0.28,
            quills if name in ("pelican", "eagle", "parrot") else body,
            quills,
        )
    if name == "cock":
        for k, reach in ((0, 0.42), (1, 0.36), (2, 0.28)):
            for side in (1, -1):
                start = rear + [0.05, side * 0.02, 0.05]
                hull(
                    kit,
                    bend(start, start + [-0.15 - 0.08 * k, side * 0.03, reach], start + [-0.38 - 0.03 * k, side * 0.05, reach * 0.55 - 0.12 * k], 3),
                    [0.05, 0.045, 0.015],
                    quills if k else body,
                    0.3,
                    first=False,
                )
    elif name == "peacock":
        eyed = fur(kit, (0.03, 0.2, 0.08), (0.02, 0.25, 0.2), pattern=DOTS, frequency=11, second=(0.02, 0.08, 0.4))
        if kit.chance(0.65):
            count, big = 13, rng.uniform(0.8, 1.05)
            for angle in np.linspace(-98, 98, count):
                way = np.array([-0.22, np.sin(np.radians(angle)), np.cos(np.radians(angle))])
                kit.between(rear + [0.1, 0, 0], rear + way * big, (0.014, 0.045), BOX, 2.9, eyed)
        else:
            kit.between(rear, (rear[0] - 0.9, 0, 0.05), (0.05, 0.1), CYL, 1.4, eyed)
            kit.add(BALL, (rear[0] - 0.9, 0, 0.08), (0.2, 0.16, 0.06), material=eyed)
    elif name != "ostrich":
        up = {"hen": 0.6, "penguin": 0.0}.get(name, -0.05)
        kit.between(rear + aim * 0.06, rear - aim * train + high * train * up, (0.02, fat * 0.3), BOX, 1.4 if name not in ("parrot", "heron") else 0.7, quills)
    hip = centre[2] - fat * 0.55 * aim[0] - long * 0.35 * aim[2]
    thin = {"ostrich": 0.04, "penguin": 0.06, "eagle": 0.03, "owl": 0.035}.get(name, 0.02)
    kit.add(BALL, (-0.02, fat * 0.48, hip), (fat * 0.42, fat * 0.34, fat * (0.62 if name != "ostrich" else 1.0)), material=body if name != "ostrich" else shank, mirror=True)
    heel, at = (-0.05 - 0.03 * leg, fat * 0.5, hip * 0.5), (0.02, fat * 0.5, thin * 0.9)
    hull(kit, [(0, fat * 0.48, hip), heel, at], [thin * 1.3, thin * 1.1, thin * 0.9], shank, mirror=True, first=False)
    if name in ("duck", "goose", "gull", "pelican", "penguin", "flamingo"):
        kit.add(BOX, (0.08, fat * 0.5, 0.012), (0.1, 0.075, 0.012), (0.9, 0.9), material=shank, mirror=True)
    else:
        for angle in (-32, 0, 32) if name != "ostrich" else (-15, 12):
            kit.between(at, np.array(at) * [1, 1, 0.5] + turn("z", angle) @ np.array([0.09 + thin * 2.5, 0, 0]), thin * 0.75, CYL, 0.5, shank, mirror=True)
        kit.between(at, (-0.08, fat * 0.5, thin * 0.5), thin * 0.7, CYL, 0.5, shank, mirror=True)


def flying_bird(kit):
    """Gulls, eagles, swallows, geese, ducks, parrots, doves, owls with spread wings, gliding or beating."""
    rng = kit.rng
    name = str(rng.choice(["gull", "eagle", "swallow", "goose", "duck", "parrot", "pigeon", "owl", "stork", "crow"]))
    chosen = PLUMES.get(name, [((0.02, 0.04, 0.12), BLACK, (0.02, 0.04, 0.14), DARK, DARK, WHITE)])
    chosen = chosen[rng.integers(len(chosen))]
    body, quills, hood, shank, horn = (fur(kit, c, pattern=PLAIN if i != 1 else STREAKS) for i, c in enumerate(chosen[:5]))
    span, chord = {"gull": (1.1, 0.2), "eagle": (1.15, 0.36), "swallow": (0.85, 0.16), "goose": (1.05, 0.3), "stork": (1.1, 0.34)}.get(name, (0.85, 0.3))
    fat = 0.11 if name != "swallow" else 0.075
    hull(kit, [(-0.34, 0, -0.01), (-0.1, 0, 0), (0.12, 0, 0), (0.28, 0, 0.01)], np.array([0.4, 0.9, 1.0, 0.7]) * fat, body, 1.05)
    if chosen[5]:
        kit.add(BALL, (0.06, 0, -0.025), (0.27, fat * 0.9, fat * 0.9), material=fur(kit, chosen[5]))
    reach = {"goose": 0.4, "stork": 0.38, "duck": 0.22}.get(name, 0.1)
    hull(kit, [(0.28, 0, 0.01), (0.32 + reach, 0, 0.04)], [fat * 0.7, 0.05], hood, first=False)
    head = Head(kit, (0.36 + reach, 0, 0.05), turn("y", 3), 0.07 if name != "owl" else 0.1)
    head.ball((0, 0, 0), (1.1, 0.9, 0.92), hood)
    bill(kit, name, head, 0.3 if name == "stork" else 0.09, 0.034, horn)
    head.eyes(0.5, 0.72, 0.25, 0.17)
    lift = rng.uniform(-0.25, 0.75)
    wrist, sweep = span * 0.42, rng.uniform(0, 0.15) + (0.2 if name in ("gull", "swallow") else 0)
    z = [0.04, 0.04 + lift * wrist, 0.04 + lift * wrist + (span - wrist) * (lift * 0.7 - 0.1)]
    front = [0.2, 0.27, 0.27 - sweep]
    arm = [(front[0], front[0] - chord * 1.15, fat * 0.5, z[0]), (front[1], front[1] - chord * 1.15, wrist, z[1])]
    blunt = 0.25 if name not in ("gull", "swallow") else 0.08
    hand = [
        arm[1],
        (front[2] + 0.03, front[2] - chord * 0.75, wrist + (span - wrist) * 0.6, z[1] * 0.4 + z[2] * 0.6),
        (front[2] - sweep * 0.6, front[2] - sweep * 0.6 - chord * blunt - 0.02, span, z[2]),
    ]
    membrane(kit, arm, 0.02, body)
    membrane(kit, [(arm[0][1] + 0.1, arm[0][1] - 0.05, *arm[0][2:]), (arm[1][1] + 0.1, arm[1][1] - 0.04, *arm[1][2:])], 0.012, quills)
    membrane(kit, hand, 0.014, quills)
    kit.chain([(front[0] - 0.02, fat * 0.4, z[0]), (front[1] - 0.02, wrist, z[1]), (front[2], span * 0.8, z[1] * 0.4 + z[2] * 0.6)], [0.04, 0.03, 0.014], body, mirror=True)
    if name in ("eagle", "stork", "crow", "owl"):
        for k in range(5):
            start = np.array([front[2] - 0.05 * k, span * (0.86 - 0.05 * k), np.interp(0.7 - 0.08 * k, [0, 1], z[1:])])
            kit.between(start, start + [-0.06 - 0.05 * k, 0.24 - 0.03 * k, 0.24 * (lift * 0.7)], (0.01, 0.03), BOX, 0.5, quills, mirror=True)
    if name == "swallow":
        sail(kit, (-0.8, 0.14, 0), (-0.3, 0, 0), (-0.36, 0.08, 0), 0.01, quills, mirror=True)
    else:
        long = 0.5 if name == "parrot" else 0.24
        kit.between((-0.3, 0, 0), (-0.3 - long, 0, -0.01), (0.012, 0.07), BOX, 2.0 if name != "parrot" else 0.6, quills if name != "eagle" else hood)
    if name in ("stork", "goose"):
        kit.chain([(-0.15, 0.05, -0.08), (-0.75 if name == "stork" else -0.4, 0.04, -0.05)], [0.02, 0.014], shank, mirror=True)
