"""Makers of turtles, crocodiles, lizards, chameleons, snakes and frogs, of dinosaurs and dragons."""

import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, RED, TAN, WHITE, Head, bend, black, hull, looking
from .birds import membrane, sail
from .hides import GOLD, skin
from .kit import towards, turn
from .layout import BALL, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, DOTS, LEDGES, PATCHWORK, PLAIN, SEAMS, SPECKLES, STREAKS
from .paws import foreleg, hindleg


def turtle(kit):
    """Tortoises with a dome on pillars, sea turtles with flippers."""
    rng = kit.rng
    sea = kit.chance(0.45)
    hide = skin(kit, (0.2, 0.2, 0.08), TAN, GREY, (0.12, 0.15, 0.1), pattern=SPECKLES, frequency=16, gloss=0.1)
    shell = skin(
        kit,
        BROWN,
        (0.15, 0.17, 0.06),
        DARK,
        TAN,
        pattern=rng.choice([SEAMS, PATCHWORK, CAMOUFLAGE, CLOUDY]),
        frequency=rng.uniform(6, 10),
        second=GOLD if kit.chance(0.5) else BLACK,
    )
    lift = 0.1 if sea else 0.2
    high = rng.uniform(0.16, 0.22) if sea else rng.uniform(0.34, 0.46)
    kit.add(BALL, (0, 0, lift + 0.06), (0.6, 0.48, high), material=shell)
    kit.add(CYL, (0, 0, lift + 0.04), (0.61, 0.49, 0.05), (0.92, 1), material=shell._replace(pattern=LEDGES))
    kit.add(BALL, (0, 0, lift + 0.02), (0.56, 0.44, 0.14), material=skin(kit, CREAM, TAN))
    if not sea and kit.chance(0.7):
        for x, y in ((0, 0), (0.27, 0), (-0.27, 0), (0.13, 0.24), (-0.16, 0.24), (0.13, -0.24), (-0.16, -0.24)):
            z = lift + 0.06 + high * np.sqrt(1 - (x / 0.6) ** 2 - (y / 0.48) ** 2)
            way = np.array([x / 0.36, y / 0.23, (z - lift) / high**2])
            kit.add(CYL, (x, y, z - 0.02), (0.14, 0.12, 0.045), (0.6, 1), rotation=towards(way), material=shell._replace(pattern=PLAIN))
    tip = np.array([0.86, 0, lift + (0.08 if sea else rng.uniform(0.1, 0.3))])
    hull(kit, [(0.45, 0, lift + 0.05), tip], [0.13, 0.085], hide, first=False)
    head = Head(kit, tip + [0.06, 0, 0.02], looking(kit, 5, 20), 0.11)
    head.ball((0, 0, 0), (1.25, 0.85, 0.85), hide)
    kit.between(head.place(0.6, 0, 0), head.place(1.5, 0, -0.25), (0.06, 0.07), CYL, 0.4, hide)
    head.eyes(0.6, 0.66, 0.25, 0.16)
    for side in (1, -1):
        if sea:
            hull(kit, [(0.38, side * 0.35, 0.13), (0.36, side * 0.75, 0.08), (0.02, side * 1.05, 0.05)], [0.09, 0.1, 0.03], hide, 0.8)
            kit.add(BALL, (0.18, side * 0.88, 0.06), (0.36, 0.11, 0.03), rotation=turn("z", -38 * side), material=hide)
            kit.add(BALL, (-0.5, side * 0.36, 0.07), (0.24, 0.11, 0.035), rotation=turn("z", -30 * side), material=hide)
        else:
            for x in (0.36, -0.38):
                hull(kit, [(x, side * 0.3, lift + 0.02), (x + np.sign(x) * 0.08, side * 0.44, 0.09)], [0.12, 0.095], hide)
                kit.add(CYL, (x + np.sign(x) * 0.08 + 0.02, side * 0.44, 0.045), (0.11, 0.1, 0.045), (0.85, 1), material=hide)
    kit.between((-0.55, 0, lift + 0.02), (-0.78, 0, lift - 0.04), 0.05, CYL, 0.2, hide)


def sprawler(kit):
    """Crocodiles, lizards, iguanas, salamanders, chameleons on a branch."""
    rng = kit.rng
    name = str(rng.choice(["crocodile", "lizard", "iguana", "salamander", "chameleon"]))
    greens = ((0.12, 0.14, 0.05), (0.2, 0.2, 0.1), (0.1, 0.35, 0.04), TAN, GREY)
    pattern = {"salamander": CAMOUFLAGE, "crocodile": PATCHWORK}.get(name, rng.choice([SPECKLES, CLOUDY, BANDS]))
    coat = skin(
        kit,
        *(greens if name not in ("salamander", "chameleon") else ((0.02, 0.02, 0.02), ORANGE) if name == "salamander" else ((0.1, 0.4, 0.05), (0.05, 0.35, 0.25))),
        pattern=pattern,
        frequency=rng.uniform(10, 18),
        second=GOLD if name in ("salamander", "chameleon") else None,
        gloss=0.2,
    )
    pale, croc = skin(kit, CREAM, TAN), name == "crocodile"
    long, fat, z = (0.5, 0.19, 0.24) if croc else (0.36, 0.12, 0.2) if name != "salamander" else (0.4, 0.1, 0.12)
    if name == "chameleon":
        z = 0.55
        animal = len(kit.primitives)
        kit.between((-0.9, 0, 0.1), (0.75, 0, 0.22), 0.075, CYL, 0.8, skin(kit, BROWN, pattern=STREAKS, gloss=0.02))
        kit.between((-0.9, 0, 0), (-0.9, 0, 0.12), 0.1, material=skin(kit, BROWN))
        kit.only_carries(animal)
    flat = 1.3 if croc else 0.6 if name == "chameleon" else 1.05
    tall = 1.6 if name == "chameleon" else 1.0
    hull(kit, [(-long, 0, z), (-long * 0.3, 0, z + 0.02), (long * 0.4, 0, z + 0.02), (long, 0, z + 0.02)], np.array([0.75, 1.0, 1.0, 0.7]) * fat * tall, coat, flat)
    kit.add(BALL, (0, 0, z - fat * 0.25 * tall), (long * 1.0, fat * flat * 0.92 * tall, fat * 0.82 * tall), material=pale)
    neck = np.array([long + 0.1, 0, z + (0.02 if croc else 0.08)])
    hull(kit, [(long, 0, z + 0.02), neck], [fat * 0.7, fat * 0.62], coat, first=False)
    size = fat * 0.8
    head = Head(kit, neck + [size * 0.6, 0, 0.02], looking(kit, 2, 20 if not croc else 8), size)
    head.ball((0, 0, 0), (1.15, 0.9, 0.75), coat)
    snout = 4.0 if croc else 1.7
    mouth = rng.choice([0.0, 18.0]) if croc else 0.0
    kit.between(head.place(0.2, 0, 0.05), head.place(snout, 0, 0.0), (size * 0.5, size * 0.72), CYL, 0.5, coat)
    head.ball((snout, 0, 0.02), (0.35, 0.38, 0.27), coat)
    jaw = head.facing @ turn("y", mouth) @ np.array([snout, 0, 0]) * size
    kit.between(head.place(0, 0, -0.35), head.place(0, 0, -0.35) + jaw, (size * 0.25, size * 0.66), CYL, 0.45, pale)
    if croc:
        for x in (2.2, 3.6):
            for y in (0.62 - 0.08 * x, 0.08 * x - 0.62):
                kit.between(head.place(x, y, -0.1), head.place(x, y, -0.5), size * 0.08, CYL, 0.1, skin(kit, WHITE, pattern=PLAIN))
    head.ball((0.3, 0.5, 0.55), (0.26, 0.2, 0.24) if name != "chameleon" else (0.4, 0.4, 0.4), coat, True)
    head.eyes(0.42 if name != "chameleon" else 0.5, 0.62 if name != "chameleon" else 0.82, 0.6, 0.14)
    if name == "chameleon":
        sail(kit, head.place(-1.3, 0, 1.5), head.place(0.4, 0, 0.5), head.place(-1.0, 0, -0.1), 0.03, coat)
    side = rng.choice([-1, 1]) * rng.uniform(0, 0.4)
    if name == "chameleon":
        path = [(-long, 0, z), (-0.65, 0, z - 0.05), (-0.95, 0, z - 0.15), (-1.05, 0, z - 0.4), (-0.85, 0, z - 0.42), (-0.8, 0, z - 0.27)]
    else:
        reach = 1.1 if croc else 1.2
        path = bend((-long, 0, z), (-long - reach * 0.5, side, z * 0.5), (-long - reach, -side, 0.03), 5)
    hull(kit, path, np.linspace(fat * 0.7, fat * 0.12, len(path)), coat, 0.8, first=False)
    for x, ahead in ((long * 0.75, 0.1), (-long * 0.8, -0.06)):
        for s in (1, -1):
            if name == "chameleon":
                joints = [(x, s * 0.07, z - 0.05), (x + ahead * 1.4, s * 0.2, z - 0.12), (x + ahead * 0.4, s * 0.06, 0.22)]
            else:
                joints = [(x, s * fat * flat * 0.8, z), (x - ahead * 0.6, s * (fat * flat + 0.16), z * 1.05), (x + ahead * 0.6, s * (fat * flat + 0.22), 0.03)]
            hull(kit, joints, np.array([0.42, 0.34, 0.24]) * fat, coat, first=False)
            if name != "chameleon":
                for angle in (-20, 30) if croc else (-25, 10, 45):
                    kit.between(joints[-1], np.array(joints[-1]) + turn("z", angle * s) @ np.array([fat * 0.75, 0, -0.012]), fat * 0.13, CYL, 0.4, coat)
    if name in ("iguana", "crocodile"):
        for x in np.linspace(-long * 1.1, long * 1.1, 7 if name == "iguana" else 5):
            high = fat * (0.5 if name == "iguana" else 0.2)
            for y in (0,) if name == "iguana" else (0.4 * fat, -0.4 * fat):
                kit.between((x, y, z + fat * 0.85), (x - 0.05, y, z + fat + high), (0.05, 0.014), CYL, 0.1, coat)


def snake(kit):
    """Winding, coiled with the head raised, cobras with a spread hood."""
    rng = kit.rng
    name = str(rng.choice(["winding", "coiled", "cobra"]))
    pattern = rng.choice([BANDS, SPECKLES, CAMOUFLAGE, PLAIN, DOTS])
    coat = skin(
        kit,
        GOLD,
        TAN,
        (0.1, 0.3, 0.05),
        BLACK,
        RED,
        GREY,
        (0.4, 0.05, 0.03),
        pattern=pattern,
        frequency=rng.uniform(8, 22),
        second=(BLACK, CREAM, DARK, WHITE)[rng.integers(4)],
        gloss=0.35,
    )
    thick = rng.uniform(0.06, 0.11)
    if name == "winding":
        t = np.linspace(0, 1, 26)
        wave = rng.uniform(0.18, 0.32)
        path = np.stack([2.4 * t - 1.2, wave * np.sin(2 * np.pi * rng.uniform(1.3, 2.3) * t + 1), np.full(26, thick)], 1)
        radii = thick * np.interp(t, [0, 0.35, 0.8, 1], [0.12, 0.95, 1, 0.7])
    else:
        turns = rng.uniform(1.6, 2.3) if name == "coiled" else 1.4
        t = np.linspace(0, 1, 21)
        angle, radius = 2 * np.pi * turns * t, np.interp(t, [0, 1], [0.42, 0.16])
        path = np.stack([radius * np.cos(angle), radius * np.sin(angle), thick + t * (turns - 0.8) * thick * 1.7], 1)
        radii = thick * np.interp(t, [0, 0.3, 1], [0.2, 1, 1])
        up = rng.uniform(0.25, 0.45) if name == "coiled" else rng.uniform(0.6, 0.8)
        top = path[-1][2]
        path = np.concatenate([path, [(0.12, 0, top + 0.1), (0.1, 0, top + up * 0.6), (0.14, 0, top + up), (0.24, 0, top + up + 0.06)]])
        radii = np.concatenate([radii, thick * np.array([0.95, 0.85, 0.8, 0.7])])
    for i in range(len(path) - 1):
        kit.between(path[i], path[i + 1], radii[i], CYL, radii[i + 1] / radii[i], coat)
        kit.add(BALL, path[i + 1], (radii[i + 1],) * 3, rotation=towards(path[i + 1] - path[i]), material=coat)
    way = path[-1] - path[-2]
    head = Head(kit, path[-1] + way / np.linalg.norm(way) * thick * 0.8, turn("z", np.degrees(np.arctan2(way[1], way[0]))) @ turn("y", 5), thick * 1.1)
    head.ball((0.1, 0, 0), (1.5, 1.0, 0.7), coat)
    head.ball((0.9, 0, -0.05), (0.9, 0.65, 0.5), coat)
    head.eyes(0.7, 0.62, 0.38, 0.17)
    if name == "cobra":
        kit.add(BALL, path[-2] + [0, 0, -0.1], (0.05, thick * 2.4, 0.24), rotation=turn("y", 8), material=coat)
    if kit.chance(0.6):
        kit.between(head.place(1.7, 0, -0.15), head.place(2.9, 0, -0.25), 0.008, material=skin(kit, (0.4, 0.03, 0.03), pattern=PLAIN))


def frog(kit):
    rng = kit.rng
    coat = skin(
        kit,
        (0.1, 0.35, 0.03),
        (0.2, 0.22, 0.06),
        BROWN,
        (0.02, 0.1, 0.5),
        (0.6, 0.05, 0.02),
        GOLD,
        pattern=rng.choice([PLAIN, SPECKLES, CAMOUFLAGE]),
        frequency=10,
        second=BLACK if kit.chance(0.5) else None,
        gloss=0.4,
    )
    pale = skin(kit, CREAM, WHITE, pattern=PLAIN)
    tilt = turn("y", -30)
    kit.add(BALL, (-0.08, 0, 0.3), (0.42, 0.3, 0.22), rotation=tilt, material=coat)
    kit.add(BALL, (0, 0, 0.26), (0.38, 0.27, 0.2), rotation=tilt, material=pale)
    kit.add(BALL, (0.26, 0, 0.49), (0.25, 0.27, 0.15), rotation=turn("y", 8), material=coat)
    kit.add(BALL, (0.28, 0, 0.43), (0.22, 0.25, 0.11), material=pale)
    kit.add(BALL, (0.24, 0.17, 0.61), (0.09, 0.08, 0.09), material=coat, mirror=True)
    kit.add(BALL, (0.275, 0.2, 0.625), (0.06, 0.055, 0.065), material=skin(kit, GOLD, (0.6, 0.05, 0.02), pattern=PLAIN, gloss=0.6), mirror=True)
    kit.add(BALL, (0.3, 0.222, 0.63), (0.035, 0.035, 0.045), material=black(kit), mirror=True)
    hull(kit, [(0.16, 0.22, 0.34), (0.12, 0.34, 0.2), (0.26, 0.32, 0.04)], [0.075, 0.06, 0.045], coat, mirror=True)
    hull(kit, [(-0.35, 0.17, 0.16), (0.02, 0.4, 0.22), (-0.34, 0.38, 0.08)], [0.13, 0.1, 0.055], coat, mirror=True)
    kit.between((-0.36, 0.36, 0.04), (0.0, 0.48, 0.03), 0.045, CYL, 0.8, coat, mirror=True)
    for angle in (-25, 5, 35):
        way = turn("z", angle) @ np.array([0.14, 0, -0.012])
        for at in ((0.26, 0.32, 0.03), (0.0, 0.48, 0.03)):
            kit.between(at, np.array(at) + way * (1 if at[0] else 1.5), 0.022, CYL, 0.6, coat, mirror=True)
            kit.add(BALL, np.array(at) + way * (1 if at[0] else 1.5), (0.03, 0.03, 0.018), material=coat, mirror=True)


def pillar(kit, hip, at, radius, coat):
    """A thick leg with a slight bend and a round foot with toes."""
    hip, at = np.array(hip, float), np.array(at, float)
    ahead = 0.08 * (hip[2] - at[2])
    hull(kit, [hip, (hip + at) / 2 + [ahead, 0, 0], at + [0, 0, radius * 0.8]], [radius * 1.6, radius * 1.15, radius * 0.95], coat, first=True)
    kit.add(CYL, at + [0.02, 0, radius * 0.45], (radius * 1.25, radius * 1.15, radius * 0.45), (0.8, 1), material=coat)


def jaws(kit, head, far, coat, under, mouth, deep=0.6):
    """Snout and lower jaw, open by `mouth` degrees, with teeth."""
    size = head.size
    kit.between(head.place(0.2, 0, 0.1), head.place(far, 0, 0.02), (size * deep, size * 0.7), CYL, 0.62, coat)
    head.ball((far, 0, 0.0), (0.42, 0.45, deep * 0.64), coat)
    low = head.facing @ turn("y", 6 + mouth) @ np.array([far + 0.2, 0, 0]) * size
    start = head.place(-0.05, 0, -0.42)
    kit.between(start, start + low, (size * 0.3, size * 0.6), CYL, 0.6, under)
    if mouth > 5:
        for x, y in ((0.95, 0.3), (0.95, -0.3), (0.6, 0.42), (0.6, -0.42)):
            kit.between(head.place(far * x, y, -0.2), head.place(far * x, y, -0.6), size * 0.1, CYL, 0.1, skin(kit, WHITE, pattern=PLAIN))


def saurian(kit):
    """T. rex, raptors, stegosaurs, triceratops, sauropods, dragons on four legs."""
    rng = kit.rng
    name = str(rng.choice(["rex", "stegosaur", "triceratops", "sauropod", "dragon", "dragon"]))
    colours = (
        ((0.14, 0.18, 0.06), BROWN, (0.25, 0.2, 0.1), GREY, (0.1, 0.2, 0.2), RED)
        if name != "dragon"
        else ((0.4, 0.02, 0.02), (0.03, 0.25, 0.06), (0.03, 0.06, 0.3), BLACK, GOLD)
    )
    coat = skin(kit, *colours, pattern=rng.choice([CLOUDY, SPECKLES, BANDS, CAMOUFLAGE]), frequency=rng.uniform(7, 14), gloss=0.15)
    under, horn = skin(kit, CREAM, TAN, GOLD), skin(kit, CREAM, pattern=PLAIN)
    iris = kit.material(base=(0.8, 0.5, 0.03), pattern=PLAIN, gloss=0.5)
    swing = rng.uniform(-0.35, 0.35)
    if name == "rex":
        raptor = kit.chance(0.3)
        fat = 0.17 if raptor else 0.25
        hip, chest = np.array([0, 0, 0.85]), np.array([0.48, 0, 0.92])
        hull(kit, [hip, (hip + chest) / 2, chest], [fat, fat * 1.02, fat * 0.88], coat, 0.82)
        kit.add(BALL, (0.26, 0, 0.83), (0.36, fat * 0.72, fat * 0.85), material=under)
        hull(kit, bend(hip, (-0.75, 0, 0.92), (-1.55, swing, 0.85), 5), np.array([0.95, 0.66, 0.46, 0.28, 0.1]) * fat, coat, 0.85, first=False)
        neck = bend(chest, chest + [0.24, 0, 0.02], chest + [0.26, 0, 0.32], 3)
        hull(kit, neck, np.array([0.82, 0.66, 0.58]) * fat, coat, 0.85, first=False)
        head = Head(kit, neck[-1] + [0.1, 0, 0.06], looking(kit, 4, 15), 0.115 if raptor else 0.185)
        head.ball((0, 0, 0), (1.05, 0.85, 0.92), coat)
        jaws(kit, head, 2.0, coat, under, rng.choice([0.0, 22.0]), 0.68)
        for side in (1, -1):
            step = side * rng.uniform(0.05, 0.3)
            knee, heel, toe = np.array([0.2 + step * 0.5, side * 0.2, 0.52]), np.array([-0.14 + step, side * 0.2, 0.24]), np.array([0.0 + step, side * 0.2, 0.045])
            kit.add(BALL, (hip + knee) / 2 * [1, 0, 1] + [0, side * 0.16, 0], (0.17, 0.11, 0.27), rotation=towards(hip - knee), material=coat)
            hull(kit, [knee, heel, toe], [0.11, 0.06, 0.055], coat)
            for angle in (-28, 0, 28):
                kit.between(toe, toe * [1, 1, 0.5] + turn("z", angle) @ np.array([0.2, 0, 0]), 0.042, CYL, 0.45, coat)
            hull(kit, [chest + [0.1, side * fat * 0.6, -0.1], chest + [0.12, side * fat * 0.75, -0.24], chest + [0.24, side * fat * 0.7, -0.22]], [0.055, 0.035, 0.022], coat)
    elif name == "stegosaur":
        hull(kit, [(-0.45, 0, 0.72), (0, 0, 0.76), (0.4, 0, 0.56), (0.62, 0, 0.42)], [0.27, 0.34, 0.24, 0.14], coat, 0.75)
        hull(kit, [(0.62, 0, 0.42), (0.88, 0, 0.34)], [0.13, 0.09], coat, first=False)
        head = Head(kit, (0.92, 0, 0.34), looking(kit, 12, 15), 0.085)
        head.ball((0, 0, 0), (1.1, 0.9, 0.9), coat)
        kit.between(head.place(0.3, 0, 0), head.place(2.0, 0, -0.2), 0.068, CYL, 0.45, coat)
        rear = bend((-0.5, 0, 0.72), (-0.95, 0, 0.6), (-1.45, swing, 0.6), 4)
        hull(kit, rear, [0.24, 0.16, 0.09, 0.04], coat, first=False)
        plate = skin(kit, ORANGE, RED, TAN, BROWN, pattern=STREAKS)
        for k, x in enumerate(np.linspace(-0.95, 0.72, 8)):
            z = np.interp(x, [-1.0, -0.45, 0, 0.4, 0.72], [0.66, 0.97, 1.08, 0.78, 0.5])
            big = np.interp(x, [-1.0, -0.1, 0.72], [0.1, 0.24, 0.09])
            at = np.array([x, 0.05 * (-1) ** k, z])
            kit.add(CYL, at + [0, 0, big * 0.12], (big * 0.5, 0.02, big * 0.3), (1.5, 1), material=plate)
            kit.add(CYL, at + [0, 0, big * 0.8], (big * 0.75, 0.02, big * 0.4), (0.1, 1), material=plate)
        for x, y in ((-0.02, 0.3), (0.1, 0.3)):
            kit.between(rear[-1] + [x + 0.05, 0, 0], rear[-1] + [x - 0.12, y, 0.2], 0.03, CYL, 0.1, horn)
            kit.between(rear[-1] + [x + 0.05, 0, 0], rear[-1] + [x - 0.12, -y, 0.2], 0.03, CYL, 0.1, horn)
        for side in (1, -1):
            pillar(kit, (0.38, side * 0.16, 0.45), (0.4 + side * 0.06, side * 0.2, 0), 0.07, coat)
            pillar(kit, (-0.38, side * 0.17, 0.6), (-0.38 - side * 0.06, side * 0.19, 0), 0.085, coat)
    elif name == "triceratops":
        hull(kit, [(-0.55, 0, 0.58), (-0.1, 0, 0.62), (0.35, 0, 0.56)], [0.28, 0.35, 0.28], coat, 0.92)
        hull(kit, bend((-0.55, 0, 0.56), (-0.95, 0, 0.4), (-1.3, swing, 0.16), 4), [0.25, 0.16, 0.09, 0.03], coat, first=False)
        hull(kit, [(0.35, 0, 0.56), (0.68, 0, 0.52)], [0.27, 0.2], coat, first=False)
        head = Head(kit, (0.8, 0, 0.5), looking(kit, 12, 15), 0.2)
        head.ball((0, 0, 0), (1.0, 0.82, 0.9), coat)
        kit.between(head.place(0.2, 0, -0.1), head.place(1.9, 0, -0.35), (0.15, 0.13), CYL, 0.5, coat)
        kit.between(head.place(1.7, 0, -0.25), head.place(2.25, 0, -0.75), 0.08, CYL, 0.2, horn)
        frill = head.facing @ turn("y", -58)
        kit.add(
            CYL, head.place(-0.55, 0, 0.55), np.array([1.5, 1.65, 0.11]) * head.size, (0.9, 1), rotation=frill, material=skin(kit, RED, ORANGE, BROWN, TAN, pattern=CLOUDY)
        )
        head.rods([(0.45, 0.45, 0.6), (1.1, 0.6, 1.2), (1.9, 0.62, 1.4)], [0.2, 0.14, 0.03], horn)
        head.rods([(1.55, 0, 0.05), (1.8, 0, 0.65)], [0.17, 0.03], horn, both=False)
        for side in (1, -1):
            pillar(kit, (0.33, side * 0.22, 0.45), (0.36 + side * 0.07, side * 0.25, 0), 0.09, coat)
            pillar(kit, (-0.45, side * 0.21, 0.5), (-0.45 - side * 0.07, side * 0.23, 0), 0.1, coat)
    elif name == "sauropod":
        up = rng.uniform(0.15, 1.0)
        hull(kit, [(-0.42, 0, 0.7), (0, 0, 0.72), (0.36, 0, 0.74)], [0.24, 0.3, 0.23], coat, 0.9)
        kit.add(BALL, (0, 0, 0.63), (0.42, 0.24, 0.26), material=under)
        path = bend((0.4, 0, 0.8), (0.85, 0, 0.85 + 0.2 * up), (1.25, rng.uniform(-0.2, 0.2), 1.0 + 0.7 * up), 5)
        hull(kit, path, [0.18, 0.13, 0.1, 0.08, 0.065], coat, first=False)
        head = Head(kit, path[-1] + [0.05, 0, 0.02], looking(kit, 12, 20), 0.085)
        head.ball((0, 0, 0), (1.1, 0.85, 0.9), coat)
        kit.between(head.place(0.3, 0, -0.1), head.place(1.7, 0, -0.25), 0.062, CYL, 0.72, coat)
        head.ball((1.7, 0, -0.25), (0.4, 0.5, 0.45), coat)
        hull(kit, bend((-0.45, 0, 0.7), (-1.0, 0, 0.55), (-1.8, swing * 2, 0.4), 6), [0.2, 0.13, 0.09, 0.06, 0.04, 0.015], coat, first=False)
        for side in (1, -1):
            pillar(kit, (0.33, side * 0.16, 0.6), (0.34 + side * 0.08, side * 0.18, 0), 0.085, coat)
            pillar(kit, (-0.38, side * 0.16, 0.6), (-0.38 - side * 0.08, side * 0.18, 0), 0.095, coat)
    else:
        wing = skin(kit, ORANGE, RED, DARK, (0.3, 0.05, 0.2), TAN, pattern=STREAKS)
        hull(kit, [(-0.4, 0, 0.5), (0, 0, 0.55), (0.35, 0, 0.6)], [0.19, 0.2, 0.22], coat, 0.82)
        kit.add(BALL, (0.05, 0, 0.49), (0.42, 0.14, 0.17), rotation=turn("y", -8), material=under._replace(pattern=BANDS, frequency=20.0))
        path = bend((0.42, 0, 0.68), (0.88, 0, 0.7), (0.74, 0, 1.22), 3)
        hull(kit, path, [0.18, 0.12, 0.09], coat, first=False)
        head = Head(kit, path[-1] + [0.06, 0, 0.03], looking(kit, 12, 18), 0.115)
        head.ball((0, 0, 0), (1.1, 0.85, 0.85), coat)
        jaws(kit, head, 2.2, coat, under, rng.choice([0.0, 22.0]))
        head.rods([(-0.3, 0.5, 0.55), (-1.8, 0.8, 1.3)], [0.2, 0.03], horn)
        rear = bend((-0.45, 0, 0.5), (-1.1, 0, 0.1), (-1.6, swing * 1.5, rng.uniform(0.1, 0.4)), 4)
        hull(kit, rear, [0.16, 0.11, 0.06, 0.025], coat, first=False)
        lift = rng.uniform(0.3, 1.0)
        wrist, tip = np.array([0.4, 0.5, 1.0 + lift * 0.6]), np.array([-0.05, 1.4, 0.9 + lift])
        kit.chain([(0.28, 0.14, 0.72), wrist, tip], [0.06, 0.035, 0.012], coat, mirror=True, joints=False)
        edge = [(0.3, -0.3, 0.12, 0.72), (0.4, -0.5, 0.5, wrist[2])]
        membrane(kit, edge, 0.012, wing)
        membrane(
            kit, [edge[1], (0.24, -0.34, 0.82, wrist[2] * 0.64 + tip[2] * 0.36), (0.1, -0.38, 1.08, wrist[2] * 0.36 + tip[2] * 0.64), (-0.04, -0.1, 1.4, tip[2])], 0.012, wing
        )
        for side in (1, -1):
            foreleg(kit, (0.32, side * 0.16, 0.56), (0.27, side * 0.17, 0.36), (0.36 + side * 0.07, side * 0.18, 0), 0.048, 0.13, coat, coat, "paw")
            hindleg(
                kit, (-0.34, side * 0.14, 0.48), (-0.24, side * 0.17, 0.32), (-0.48, side * 0.17, 0.2), (-0.42 - side * 0.07, side * 0.17, 0), 0.05, 0.15, coat, coat, "paw"
            )
        sail(kit, rear[-1] + [-0.24, 0, 0.02], rear[-1] + [0.02, 0.12, 0], rear[-1] + [0.02, -0.12, 0], 0.015, wing)
    head.eyes(0.5, 0.68, 0.38, 0.14, iris if name in ("rex", "sauropod", "triceratops") else None)
