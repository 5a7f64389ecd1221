"""A maker of animals that stand, sit or perch upright, and what is no bird of them: kangaroos, apes, seals, frogs, bats, dragons, dinosaurs."""


import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, Head, bend, black, fur, hull, limb, looking
from .birds import eagle, membrane, owl, parrot, peacock, penguin, rooster, sail, swan, wader
from .kit import towards, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, PLAIN, SPECKLES, STREAKS


def kangaroo(kit):
    rng = kit.rng
    coat = fur(kit, RED, TAN, GREY, BROWN)
    pale = fur(kit, CREAM, WHITE)
    lean = rng.uniform(0.05, 0.45)
    hip, chest = np.array([-0.12, 0, 0.5]), np.array([lean, 0, 1.05])
    kit.add(BALL, hip, (0.3, 0.25, 0.3), material=coat)
    hull(kit, [hip, (hip + chest) / 2 + [0.02, 0, -0.02], chest], [0.26, 0.22, 0.15], coat, 0.88, first=False)
    kit.add(BALL, hip * 0.6 + chest * 0.4 + [0.08, 0, -0.03], (0.2, 0.19, 0.3), rotation=turn("y", 20), material=pale)
    hull(kit, [chest, chest + [0.1, 0, 0.26]], [0.14, 0.085], coat, first=False)
    head = Head(kit, chest + [0.15, 0, 0.33], looking(kit, 12), 0.1)
    head.ball((0, 0, 0), (1.2, 0.85, 0.95), coat)
    head.rods([(0.4, 0, -0.1), (1.9, 0, -0.35)], [0.7, 0.42], coat, both=False)
    head.ball((2.2, 0, -0.2), (0.18, 0.24, 0.18), black(kit))
    head.ear("leaf", 1.15, coat, fur(kit, PINK, CREAM))
    head.eyes(0.62, 0.66, 0.25, 0.15)
    hull(kit, bend(hip + [-0.15, 0, -0.12], (-0.6, 0, 0.05), (-1.15, rng.uniform(-0.2, 0.2), 0.05), 5), [0.17, 0.12, 0.09, 0.065, 0.045], coat)
    knee = (0.22, 0.24, 0.48)
    kit.add(BALL, (0.02, 0.2, 0.47), (0.31, 0.13, 0.24), rotation=turn("y", 5), material=coat, mirror=True)
    hull(kit, [knee, (-0.22, 0.24, 0.12), (0.25, 0.25, 0.045)], [0.11, 0.06, 0.045], coat, mirror=True)
    kit.add(BALL, (0.3, 0.25, 0.04), (0.16, 0.06, 0.04), material=fur(kit, DARK), mirror=True)
    hand = chest + [rng.uniform(0.2, 0.3), 0.1, -rng.uniform(0.15, 0.35)]
    hull(kit, [chest + [0, 0.13, 0.02], chest + [0.02, 0.17, -0.22], hand], [0.06, 0.05, 0.035], coat, mirror=True)
    kit.add(BALL, hand, (0.05, 0.04, 0.05), material=fur(kit, DARK), mirror=True)
    if kit.chance(0.4):
        joey = Head(kit, hip + [0.36, 0, 0.18], turn("z", rng.normal(0, 20)), 0.065)
        joey.ball((0, 0, 0), (1.2, 0.9, 1), coat)
        joey.rods([(0.3, 0, -0.1), (1.4, 0, -0.25)], [0.65, 0.4], coat, both=False)
        joey.ear("leaf", 0.9, coat)
        joey.eyes(0.65, 0.65, 0.25, 0.16)
        kit.add(BALL, hip + [0.22, 0, 0.06], (0.14, 0.16, 0.14), material=pale)


def hopper(kit):
    rng = kit.rng
    hare, upright = kit.chance(0.4), kit.chance(0.3)
    coat = fur(kit, TAN, GREY, WHITE, BROWN, BLACK, CREAM)
    if kit.chance(0.25):
        coat = fur(kit, WHITE, pattern=CAMOUFLAGE, frequency=rng.uniform(5, 9), second=(BLACK, BROWN, GREY)[rng.integers(3)])
    pale = fur(kit, WHITE, CREAM) if kit.chance(0.6) else coat
    chest = np.array([0.22, 0, 0.62]) if upright else np.array([0.32, 0, rng.uniform(0.3, 0.38)])
    hip = np.array([-0.12, 0, 0.3])
    kit.add(BALL, hip, (0.32, 0.27, 0.3), material=coat)
    hull(kit, [hip, chest], [0.28, 0.19], coat, 0.85, first=False)
    kit.add(BALL, chest + [0.06, 0, -0.06], (0.15, 0.13, 0.18), material=pale)
    head = Head(kit, chest + [0.16, 0, 0.24], looking(kit, 12), 0.155 if not hare else 0.13)
    hull(kit, [chest, head.at], [0.17, 0.12], coat, first=False)
    head.ball((0.1, 0, 0), (1.2, 0.85, 0.98), coat)
    head.ball((0.95, 0, -0.25), (0.5, 0.5, 0.45), pale)
    head.ball((0.35, 0.4, -0.3), (0.6, 0.45, 0.5), coat, True)
    head.ball((1.42, 0, -0.1), (0.1, 0.15, 0.1), fur(kit, PINK, BLACK, pattern=PLAIN))
    if kit.chance(0.2) and not hare:
        head.ear("flop", 1.25, coat)
    else:
        head.ear("leaf", rng.uniform(1.1, 1.4) * (1.35 if hare else 1), coat, fur(kit, PINK, pattern=PLAIN))
    head.eyes(0.62, 0.68, 0.18, 0.17)
    kit.add(BALL, (-0.45, 0, 0.24), (0.1, 0.1, 0.1), material=fur(kit, WHITE))
    kit.add(BALL, hip + [0.08, 0.2, -0.06], (0.23, 0.11, 0.19), material=coat, mirror=True)
    kit.add(BALL, (0.12, 0.25, 0.055), (0.24, 0.07, 0.055), material=coat, mirror=True)
    foot = np.array([chest[0] + 0.16, 0.1, 0.3 if upright else 0.04])
    hull(kit, [chest + [0.02, 0.1, -0.05], foot], [0.08, 0.05], coat, mirror=True)
    kit.add(BALL, foot + [0.04, 0, 0], (0.09, 0.05, 0.04), material=pale, mirror=True)


def squirrel(kit):
    rng = kit.rng
    coat, pale = fur(kit, RED, GREY, BROWN, ORANGE), fur(kit, WHITE, CREAM)
    chest = np.array([0.16, 0, 0.56])
    kit.add(BALL, (0, 0, 0.25), (0.27, 0.23, 0.25), material=coat)
    hull(kit, [(0, 0, 0.27), chest], [0.24, 0.15], coat, 0.88, first=False)
    kit.add(BALL, (0.13, 0, 0.42), (0.15, 0.14, 0.22), rotation=turn("y", 20), material=pale)
    head = Head(kit, chest + [0.09, 0, 0.19], looking(kit, 8), 0.125)
    hull(kit, [chest, head.at], [0.14, 0.1], coat, first=False)
    head.ball((0.1, 0, 0), (1.25, 0.92, 0.95), coat)
    head.ball((1.0, 0, -0.25), (0.5, 0.45, 0.4), pale)
    head.ball((1.45, 0, -0.15), (0.12, 0.14, 0.12), black(kit))
    head.ear("prick", rng.uniform(0.5, 0.9), coat)
    head.eyes(0.68, 0.66, 0.2, 0.18)
    tail = [(-0.2, 0, 0.1), (-0.42, 0, 0.3), (-0.42, 0, 0.62), (-0.28, 0, 0.9), (-0.38, 0, 1.08), (-0.55, 0, 1.06)]
    count = 6 if kit.chance(0.6) else 4
    hull(kit, tail[:count], [0.07, 0.15, 0.19, 0.18, 0.14, 0.09][:count], coat._replace(pattern=CLOUDY), 0.8)
    kit.add(BALL, (0.08, 0.19, 0.22), (0.2, 0.1, 0.18), material=coat, mirror=True)
    kit.add(BALL, (0.22, 0.2, 0.04), (0.17, 0.06, 0.04), material=coat, mirror=True)
    hand = (0.36, 0.05, 0.5)
    hull(kit, [(0.18, 0.13, 0.55), (0.26, 0.16, 0.42), hand], [0.06, 0.05, 0.04], coat, mirror=True)
    if kit.chance(0.6):
        kit.add(BALL, (0.4, 0, 0.5), (0.07, 0.07, 0.09), material=fur(kit, BROWN, TAN, gloss=0.2))


def monkey(kit):
    rng = kit.rng
    ape = kit.chance(0.55)
    coat = fur(kit, BLACK, DARK, BROWN, (0.4, 0.13, 0.03)) if ape else fur(kit, BROWN, TAN, GREY, CREAM)
    face = fur(kit, DARK, (0.12, 0.09, 0.08), PINK, TAN, pattern=PLAIN)
    pose = rng.choice(["sit", "knuckle", "stand"] if ape else ["sit", "sit", "knuckle"])
    size = 1.0 if ape else 0.72
    if pose == "sit":
        hip, chest = np.array([-0.1, 0, 0.27 * size]), np.array([0.06, 0, 0.85 * size])
    elif pose == "knuckle":
        hip, chest = np.array([-0.4, 0, 0.55 * size]), np.array([0.2, 0, (0.85 if ape else 0.6) * size])
    else:
        hip, chest = np.array([-0.05, 0, 0.6]), np.array([0.05, 0, 1.15])
    big = 0.3 * size
    hull(kit, [hip, (hip + chest) / 2 + [0.02, 0, 0], chest], np.array([0.27, 0.29, 0.28 if ape else 0.2]) * size, coat, 1.05 if ape else 0.9)
    if ape:
        kit.add(BALL, chest + [0, 0, 0.02], (0.25, 0.4, 0.24), material=coat)
    at = chest + ([0.16, 0, 0.36] if pose != "knuckle" else [0.36, 0, 0.24]) * np.array([1, 1, size])
    head = Head(kit, at, looking(kit, 6), 0.19 * size if ape else 0.17)
    hull(kit, [chest, at], [0.2 * size, 0.14 * size], coat, first=False)
    head.ball((0, 0, 0), (1.05, 0.9, 1.1), coat)
    if ape:
        head.ball((-0.1, 0, 0.55), (0.75, 0.5, 0.75), coat)
    head.ball((0.45, 0, 0.1), (0.65, 0.72, 0.7), face)
    head.ball((0.8, 0, -0.45), (0.6, 0.62, 0.45), face)
    head.ball((0.75, 0, 0.48), (0.33, 0.62, 0.16), coat if ape else face)
    head.ball((1.2, 0.16, -0.2), (0.12, 0.1, 0.08), black(kit), True)
    head.ball((0, 0.95, 0), (0.2, 0.2, 0.32), face, True)
    head.eyes(1.02, 0.3, 0.22, 0.12)
    shoulder, arm = chest + [0.02, big * 1.05, 0.05], 0.1 * size
    for side in (1, -1):
        s = shoulder * [1, side, 1]
        if pose == "knuckle":
            swing = side * rng.uniform(0.02, 0.15)
            hand, elbow = np.array([0.38 + swing, s[1] * 1.15, 0.05]), np.array([0.3 + swing / 2, s[1] * 1.25, s[2] * 0.5])
        elif pose == "sit":
            hand, elbow = np.array([0.4, s[1] * rng.uniform(0.4, 1.2), rng.uniform(0.08, 0.6) * size]), np.array([0.16, s[1] * 1.5, 0.45 * size])
        elif side > 0 and kit.chance(0.3):
            hand, elbow = np.array([0.15, 0.5, 1.9]), np.array([0.1, 0.6, 1.5])
        else:
            hand, elbow = np.array([0.16, s[1] * 1.3, 0.35]), np.array([0.0, s[1] * 1.45, 0.78])
        hull(kit, [s, elbow, hand], np.array([1.25, 1, 0.7]) * arm, coat)
        kit.add(BALL, hand, (arm * 0.95, arm * 0.75, arm * 0.6), material=face)
        h = hip + [0.02, side * 0.15 * size, -0.02]
        if pose == "sit":
            knee, foot = np.array([0.32, side * 0.34 * size, 0.42 * size]), np.array([0.42, side * 0.3 * size, 0.05])
        else:
            knee, foot = h + [0.14, side * 0.06, -h[2] * 0.5], h * [1, 1, 0] + [-0.02 - side * 0.05, side * 0.07, 0.05]
        hull(kit, [h, knee, foot], np.array([1.5, 1.05, 0.75]) * arm, coat)
        kit.add(BALL, foot + [0.08, 0, -0.005], (0.15, arm * 0.75, 0.045), material=face)
    if not ape:
        root = hip + [-0.18, 0, -0.05]
        up = rng.uniform(0.05, 0.9) if pose == "knuckle" else 0.05
        hull(kit, bend(root, root + [-0.5, 0, -0.1], [root[0] - 0.55, rng.uniform(-0.3, 0.3), up], 5), [0.045, 0.04, 0.035, 0.035, 0.03], coat)


def meerkat(kit):
    rng = kit.rng
    coat, pale = fur(kit, TAN, CREAM, GREY, BROWN), fur(kit, CREAM, WHITE)
    lean = rng.uniform(-0.03, 0.08)
    hull(kit, [(0, 0, 0.26), (0.02 + lean, 0, 0.5), (lean, 0, 0.78)], [0.19, 0.17, 0.125], coat, 0.92)
    kit.add(BALL, (0.08 + lean, 0, 0.48), (0.13, 0.13, 0.32), material=pale)
    head = Head(kit, (0.05 + lean, 0, 1.0), looking(kit, 0, 40), 0.11)
    hull(kit, [(lean, 0, 0.78), head.at], [0.12, 0.085], coat, first=False)
    head.ball((0, 0, 0), (1.15, 0.95, 0.95), coat)
    head.rods([(0.4, 0, -0.15), (1.55, 0, -0.3)], [0.6, 0.25], pale, both=False)
    head.ball((1.75, 0, -0.22), (0.16, 0.17, 0.15), black(kit))
    head.ball((0.62, 0.46, 0.15), (0.3, 0.27, 0.27), fur(kit, DARK), True)
    head.eyes(0.86, 0.5, 0.17, 0.12)
    head.ear("round", 0.5, fur(kit, DARK, BROWN))
    hand = (0.2 + lean, 0.07, rng.uniform(0.45, 0.6))
    hull(kit, [(lean, 0.12, 0.74), (0.06 + lean, 0.17, 0.58), hand], [0.06, 0.045, 0.035], coat, mirror=True)
    kit.add(BALL, (0.04, 0.14, 0.2), (0.14, 0.09, 0.18), material=coat, mirror=True)
    kit.add(BALL, (0.14, 0.14, 0.035), (0.17, 0.055, 0.035), material=coat, mirror=True)
    hull(kit, bend((-0.12, 0, 0.16), (-0.35, 0, 0.02), (-0.75, rng.uniform(-0.2, 0.2), 0.04), 4), [0.06, 0.045, 0.035, 0.025], coat)


def seal(kit):
    rng = kit.rng
    walrus, lion = kit.chance(0.4), kit.chance(0.5)
    coat = fur(kit, GREY, DARK, BROWN, (0.3, 0.26, 0.22), pattern=rng.choice([PLAIN, CLOUDY, SPECKLES]), gloss=0.35)
    if walrus:
        coat = fur(kit, (0.3, 0.17, 0.11), BROWN, PINK, pattern=CLOUDY, gloss=0.15)
    fat = rng.uniform(0.36, 0.44) if walrus else rng.uniform(0.26, 0.33)
    up = rng.uniform(0.45, 0.75) if walrus or lion else rng.uniform(0.15, 0.4)
    spine = np.array([(-1.05, 0, 0.11), (-0.6, 0, fat * 0.72), (-0.05, 0, fat), (0.38, 0, fat + up * 0.45), (0.52, 0, fat * 0.9 + up)])
    hull(kit, spine, [0.1, fat * 0.72, fat, fat * 0.82, fat * 0.55], coat, 1.05)
    size = fat * 0.55
    head = Head(kit, spine[-1] + [0.06, 0, size * 0.5], looking(kit, 0), size)
    head.ball((0, 0, 0), (1.1, 0.95, 0.95), coat)
    pale = fur(kit, TAN, CREAM) if kit.chance(0.4) else coat
    head.ball((0.9, 0, -0.2), (0.55, 0.45, 0.42), pale)
    head.ball((1.0, 0.26, -0.32), (0.42, 0.36, 0.36), pale, True)
    head.ball((1.4, 0, -0.02), (0.16, 0.22, 0.14), black(kit))
    head.eyes(0.78, 0.5, 0.26, 0.15)
    if walrus:
        far = rng.uniform(0.8, 1.7)
        head.rods([(1.15, 0.3, -0.5), (1.25, 0.38, -0.7 - far)], [0.14, 0.06], kit.material(base=(0.75, 0.68, 0.5), pattern=PLAIN, gloss=0.3))
    else:
        for k in (-1, 0, 1):
            tip = (1.5, 1.1, -0.35 + 0.25 * k)
            head.rods([(1.2, 0.5, -0.3), tip], [0.025, 0.015], fur(kit, WHITE))
    elbow = np.array([0.3, fat * 0.85, fat * 0.8])
    hand = np.array([rng.uniform(0.2, 0.6), fat * 1.55, 0.04])
    kit.chain([elbow, (elbow + hand) / 2 + [0, 0.03, 0.02], hand], [0.13, 0.1, 0.05], coat, mirror=True)
    kit.add(BALL, hand + [0.06, 0.06, 0], (0.2, 0.1, 0.035), rotation=turn("z", 35), material=coat, mirror=True)
    kit.add(BALL, (-1.22, 0.12, 0.07), (0.22, 0.08, 0.04), rotation=turn("z", -28), material=coat, mirror=True)


def frog(kit):
    rng = kit.rng
    pattern = rng.choice([PLAIN, SPECKLES, CAMOUFLAGE, CLOUDY])
    coat = fur(kit, (0.1, 0.3, 0.03), (0.2, 0.35, 0.05), BROWN, (0.5, 0.06, 0.02), (0.02, 0.2, 0.5), pattern=pattern, frequency=rng.uniform(6, 14), gloss=0.45)
    pale = fur(kit, CREAM, (0.6, 0.6, 0.25), pattern=PLAIN, gloss=0.4)
    up = rng.uniform(20, 38)
    frame = turn("y", -up)
    centre = np.array([0, 0, 0.36])

    def at(x, y, z):
        return centre + frame @ np.array([x, y, z])

    kit.add(BALL, centre, (0.5, 0.33, 0.24), rotation=frame, material=coat)
    kit.add(BALL, at(0, 0, -0.08), (0.46, 0.29, 0.2), rotation=frame, material=pale)
    kit.add(BALL, at(0.42, 0, 0.03), (0.28, 0.3, 0.17), rotation=turn("y", -up * 0.4), material=coat)
    kit.add(BALL, at(0.44, 0, -0.05), (0.26, 0.285, 0.14), rotation=turn("y", -up * 0.4), material=pale)
    kit.add(BALL, at(0.38, 0.19, 0.18), (0.1, 0.09, 0.1), material=coat, mirror=True)
    iris = kit.material(base=(0.7, 0.45, 0.03) if kit.chance(0.7) else (0.6, 0.03, 0.02), pattern=PLAIN, gloss=0.6)
    kit.add(BALL, at(0.41, 0.225, 0.19), (0.075, 0.06, 0.08), material=iris, mirror=True)
    kit.add(BALL, at(0.43, 0.26, 0.19), (0.05, 0.035, 0.035), material=black(kit), mirror=True)
    hull(kit, [(-0.28, 0.2, 0.2), (0.22, 0.48, 0.26), (-0.35, 0.44, 0.08)], [0.14, 0.12, 0.07], coat, mirror=True)
    kit.chain([(-0.35, 0.44, 0.08), (0.08, 0.58, 0.03)], [0.06, 0.035], coat, mirror=True)
    for angle in (-10, 20, 50):
        way = turn("z", angle) @ np.array([0.24, 0, 0])
        kit.between((0.08, 0.58, 0.03), np.array([0.08, 0.58, 0.02]) + way, (0.016, 0.028), CYL, 0.8, coat, mirror=True)
    hull(kit, [at(0.28, 0.24, -0.06), (0.24, 0.4, 0.22), (0.42, 0.34, 0.03)], [0.09, 0.07, 0.05], coat, mirror=True)
    for angle in (-35, 0, 45):
        way = turn("z", angle) @ np.array([0.14, 0, 0])
        kit.between((0.42, 0.34, 0.025), np.array([0.42, 0.34, 0.02]) + way, (0.016, 0.024), CYL, 0.9, coat, mirror=True)


def bat(kit):
    rng = kit.rng
    coat, skin = fur(kit, BROWN, DARK, BLACK, RED, GREY), fur(kit, DARK, (0.1, 0.06, 0.05), RED, pattern=STREAKS, second=DARK)
    lift = rng.uniform(-0.2, 0.7)

    kit.add(BALL, (0, 0, 0), (0.3, 0.14, 0.13), material=coat)
    kit.add(BALL, (0.14, 0, 0.01), (0.17, 0.16, 0.15), material=coat)
    head = Head(kit, (0.36, 0, 0.05), looking(kit, 0, 15), 0.11)
    head.ball((0, 0, 0), (1.1, 0.95, 0.95), coat)
    head.ball((0.85, 0, -0.2), (0.5, 0.45, 0.4), skin)
    head.ear("prick", rng.uniform(0.8, 1.5), skin, fur(kit, PINK))
    head.eyes(0.8, 0.42, 0.2, 0.13)
    slope = lift * 0.72

    def on(x, y):
        return (x, y, 0.035 + slope * max(y - 0.15, 0))

    kit.chain([on(0.18, 0.1), on(0.02, 0.42), on(0.32, 0.72)], [0.045, 0.03, 0.025], coat, mirror=True)
    for end in (on(0.2, 1.55), on(-0.22, 1.2), on(-0.39, 0.74)):
        kit.between(on(0.32, 0.72), end, 0.018, CYL, 0.4, coat, mirror=True)
    edge = [(0.2, -0.22, 0.05), (0.26, -0.4, 0.3), (0.3, -0.3, 0.5), (0.33, -0.41, 0.74), (0.32, -0.24, 0.98), (0.28, -0.23, 1.2), (0.22, 0.19, 1.56)]
    membrane(kit, [(front, rear, y, 0.03 + slope * max(y - 0.15, 0)) for front, rear, y in edge], 0.01, skin)
    kit.chain([(-0.22, 0.07, -0.02), (-0.45, 0.14, -0.04)], [0.035, 0.02], coat, mirror=True)
    sail(kit, (-0.2, 0, 0), (-0.44, 0.14, -0.03), (-0.44, -0.14, -0.03), 0.008, skin)


def scales(kit):
    rng = kit.rng
    colours = [(0.12, 0.2, 0.05), (0.2, 0.17, 0.08), BROWN, GREY, (0.3, 0.05, 0.03), (0.05, 0.15, 0.2), TAN, (0.07, 0.08, 0.05)]
    return fur(kit, *colours, pattern=rng.choice([CAMOUFLAGE, CLOUDY, SPECKLES, BANDS, PLAIN]), frequency=rng.uniform(8, 20), gloss=0.15)


def reptile_leg(kit, hip, foot, radius, coat, claws, two=False):
    """A pillar of a leg, or with `two` that of a runner: thigh, shank, long foot."""
    hip, foot = np.array(hip, float), np.array(foot, float)
    if two:
        knee, heel = hip + [0.16, 0.02 * np.sign(hip[1]), -hip[2] * 0.42], np.array([foot[0] - 0.14, foot[1], hip[2] * 0.24])
        kit.add(BALL, hip * 0.6 + knee * 0.4, (radius * 2.2, radius * 1.4, hip[2] * 0.34), rotation=towards(hip - knee), material=coat)
        hull(kit, [knee, heel, foot + [0, 0, 0.04]], [radius * 1.2, radius * 0.7, radius * 0.65], coat)
        for y in (-0.07, 0.0, 0.07):
            kit.between(foot + [-0.02, 0, 0.035], foot + [0.17, y, 0.02], radius * 0.42, CYL, 0.4, coat)
    else:
        hull(kit, [hip, (hip + foot) / 2 + [0.02, 0.03 * np.sign(hip[1]), 0], foot + [0, 0, radius]], [radius * 1.7, radius * 1.2, radius], coat)
        kit.add(CYL, foot + [0.02, 0, radius * 0.45], (radius * 1.25, radius * 1.15, radius * 0.45), (0.85, 1), material=coat)
        if claws:
            kit.add(BALL, foot + [radius * 1.15, 0, radius * 0.2], (radius * 0.3, radius * 0.8, radius * 0.2), material=claws)


def reptile_head(kit, at, facing, size, long, coat, jaws, teeth=None, mouth=0.0):
    """Skull and two jaws, the lower one open by `mouth` degrees."""
    head = Head(kit, at, facing, size)
    head.ball((0, 0, 0.05), (1.05, 0.85, 0.9), coat)
    kit.between(head.place(0.1, 0, 0.1), head.place(long, 0, 0.0), np.array([0.6, 0.72]) * size, CYL, 0.65, coat)
    head.ball((long, 0, 0), (0.42, 0.48, 0.4), coat)
    low = facing @ turn("y", 8 + mouth)
    start = head.place(-0.1, 0, -0.4)
    kit.between(start, start + low @ np.array([long + 0.1, 0, 0]) * size, np.array([0.3, 0.6]) * size, CYL, 0.65, jaws)
    head.ball((0.45, 0.55, 0.5), (0.3, 0.22, 0.18), coat, True)
    head.eyes(0.5, 0.68, 0.38, 0.15, kit.material(base=(0.8, 0.5, 0.03), pattern=PLAIN, gloss=0.5))
    if teeth and mouth > 5:
        for x in (0.65, 1.0):
            for side in (1, -1):
                kit.between(head.place(x * long, 0.38 * side, -0.25), head.place(x * long, 0.36 * side, -0.62), size * 0.09, CYL, 0.1, teeth)
    return head


def tyrannosaur(kit):
    rng = kit.rng
    coat, claws = scales(kit), kit.material(base=(0.75, 0.7, 0.55), pattern=PLAIN, gloss=0.3)
    belly = fur(kit, CREAM, TAN) if kit.chance(0.5) else coat
    rise = rng.uniform(-0.05, 0.35)
    hip, chest = np.array([0, 0, 0.82]), np.array([0.45, 0, 0.86 + rise * 0.6])
    hull(kit, [hip, chest], [0.25, 0.22], coat, 0.8)
    kit.add(BALL, (hip + chest) / 2 + [0.05, 0, -0.06], (0.33, 0.16, 0.2), rotation=turn("y", -25 * rise), material=belly)
    hull(kit, bend(hip, (-0.6, 0, 0.9 - rise), (-1.45, rng.uniform(-0.3, 0.3), 0.7 - rise * 0.9), 5), [0.23, 0.17, 0.12, 0.075, 0.03], coat, 0.85, first=False)
    top = chest + [0.24, 0, 0.28]
    hull(kit, [chest, top], [0.2, 0.14], coat, 0.85, first=False)
    reptile_head(kit, top + [0.1, 0, 0.06], looking(kit, 5, 15), 0.17, 2.3, coat, belly, claws, rng.choice([0.0, 15.0, 28.0]))
    step = rng.uniform(-0.3, 0.3)
    for side in (1, -1):
        reptile_leg(kit, hip + [0, side * 0.17, -0.02], (0.02 + side * step, side * 0.2, 0), 0.1, coat, claws, True)
    hull(kit, [chest + [0.12, 0.15, -0.08], chest + [0.16, 0.19, -0.2], chest + [0.28, 0.17, -0.19]], [0.05, 0.035, 0.025], coat, mirror=True)


def sauropod(kit):
    rng = kit.rng
    coat, claws = scales(kit), fur(kit, CREAM, GREY)
    up = rng.uniform(0.3, 1.2)
    hull(kit, [(-0.35, 0, 0.72), (0, 0, 0.7), (0.38, 0, 0.78)], [0.27, 0.33, 0.25], coat, 0.85)
    aside = rng.uniform(-0.4, 0.4)
    path = bend((0.5, 0, 0.88), (1.05, 0, 0.95), (1.35 - 0.25 * up, aside, 1.0 + up), 6)
    hull(kit, path, [0.2, 0.15, 0.12, 0.095, 0.08, 0.075], coat, first=False)
    head = Head(kit, path[-1] + [0.06, 0, 0.01], looking(kit, 18, 15), 0.095)
    head.ball((0, 0, 0), (1.1, 0.85, 0.85), coat)
    head.rods([(0.4, 0, -0.1), (1.5, 0, -0.25)], [0.75, 0.5], coat, both=False)
    head.eyes(0.5, 0.72, 0.25, 0.16)
    hull(kit, bend((-0.45, 0, 0.74), (-1.1, 0, 0.6), (-1.9, rng.uniform(-0.6, 0.6), rng.uniform(0.1, 0.5)), 6), [0.24, 0.16, 0.1, 0.065, 0.04, 0.02], coat, first=False)
    for side in (1, -1):
        step = rng.uniform(-0.12, 0.12)
        reptile_leg(kit, (0.36, side * 0.17, 0.62), (0.36 + step, side * 0.19, 0), 0.1, coat, claws)
        reptile_leg(kit, (-0.36, side * 0.18, 0.6), (-0.38 - step, side * 0.2, 0), 0.11, coat, claws)


def plated(kit):
    rng = kit.rng
    coat, plate, claws = scales(kit), scales(kit), fur(kit, CREAM, GREY)
    spine = [(-0.95, 0.0, 0.55), (-0.4, 0, 0.78), (0.05, 0, 0.72), (0.42, 0, 0.5), (0.68, 0, 0.4)]
    hull(kit, spine, [0.13, 0.3, 0.33, 0.22, 0.12], coat, 0.75)
    tail = np.array([-1.5, rng.uniform(-0.25, 0.25), 0.5])
    hull(kit, [spine[0], tail], [0.13, 0.05], coat, first=False)
    head = Head(kit, (0.8, 0, 0.36), looking(kit, 15, 15), 0.1)
    head.ball((0, 0, 0), (1.2, 0.8, 0.8), coat)
    head.rods([(0.4, 0, -0.1), (1.8, 0, -0.35)], [0.65, 0.32], coat, both=False)
    head.eyes(0.5, 0.68, 0.3, 0.15)
    for side in (1, -1):
        reptile_leg(kit, (0.4, side * 0.15, 0.42), (0.42, side * 0.19, 0), 0.07, coat, None)
        reptile_leg(kit, (-0.38, side * 0.15, 0.6), (-0.36, side * 0.2, 0), 0.1, coat, None)
    tops = bend((-1.25, 0, 0.58), (-0.25, 0, 1.62), (0.72, 0, 0.5), 10)
    for k, foot in enumerate(tops):
        high = 0.1 + 0.3 * np.sin(np.pi * (k + 0.5) / 10)
        y = 0.05 if k % 2 else -0.05
        kit.add(BOX, foot + [0, y, high * 0.15], (high * 0.38, 0.02, high * 0.4), (1.35, 1), material=plate)
        kit.add(BOX, foot + [0, y, high * 0.8], (high * 0.51, 0.02, high * 0.28), (0.06, 1), material=plate)
    for x in (0.1, 0.28):
        point = tail + [x, 0, 0]
        kit.between(point, point + [-0.12, 0.2, 0.14], 0.03, CYL, 0.15, claws)
        kit.between(point, point + [-0.12, -0.2, 0.14], 0.03, CYL, 0.15, claws)


def horned(kit):
    rng = kit.rng
    coat, claws = scales(kit), kit.material(base=(0.7, 0.64, 0.5), pattern=PLAIN, gloss=0.2)
    frill = scales(kit) if kit.chance(0.5) else coat
    hull(kit, [(-0.5, 0, 0.62), (-0.05, 0, 0.6), (0.35, 0, 0.58)], [0.27, 0.33, 0.26], coat, 0.88)
    hull(kit, bend((-0.6, 0, 0.62), (-0.95, 0, 0.55), (-1.4, rng.uniform(-0.25, 0.25), 0.18), 4), [0.22, 0.15, 0.09, 0.03], coat, first=False)
    facing = looking(kit, 15, 18)
    head = Head(kit, (0.72, 0, 0.62), facing, 0.2)
    hull(kit, [(0.35, 0, 0.58), head.at], [0.25, 0.19], coat, first=False)
    head.ball((0.1, 0, 0), (1.15, 0.85, 0.9), coat)
    high = rng.uniform(1.5, 2.0)
    head.ball((-0.5, 0, 0.75), (0.22, high * 0.88, high), frill, tilt=(0, 32))
    kit.between(head.place(0.5, 0, -0.05), head.place(1.9, 0, -0.45), np.array([0.75, 0.62]) * 0.2, CYL, 0.5, coat)
    kit.between(head.place(1.7, 0, -0.3), head.place(2.15, 0, -0.95), np.array([0.4, 0.28]) * 0.2, CYL, 0.2, claws)
    far = rng.uniform(1.3, 2.1)
    head.rods([(0.35, 0.5, 0.6), (0.9, 0.62, 0.9 + far * 0.55), (0.8 + far * 0.6, 0.6, 0.85 + far)], [0.22, 0.15, 0.04], claws)
    head.rods([(1.45, 0, 0.15), (1.75, 0, 0.95)], [0.24, 0.05], claws, both=False)
    head.eyes(0.75, 0.75, 0.25, 0.12)
    step = rng.uniform(-0.1, 0.1)
    for side in (1, -1):
        reptile_leg(kit, (0.34, side * 0.2, 0.44), (0.38 + side * step, side * 0.25, 0), 0.1, coat, claws)
        reptile_leg(kit, (-0.48, side * 0.19, 0.5), (-0.46 - side * step, side * 0.24, 0), 0.11, coat, claws)
    for angle in np.linspace(-65, 65, 7):
        a = np.radians(angle)
        tip = np.array([0, np.sin(a) * high * 0.88, np.cos(a) * high])
        root = np.array([-0.5, 0, 0.75]) + turn("y", -32) @ tip
        head.ball(root, (0.14, 0.2, 0.2), claws)


def dragon(kit):
    rng = kit.rng
    coat = scales(kit) if kit.chance(0.5) else fur(kit, (0.4, 0.02, 0.02), (0.03, 0.25, 0.06), (0.02, 0.06, 0.3), BLACK, (0.5, 0.35, 0.05), pattern=SPECKLES, gloss=0.35)
    skin, claws = fur(kit, RED, ORANGE, DARK, (0.3, 0.05, 0.2), pattern=STREAKS), fur(kit, CREAM, DARK, pattern=PLAIN, gloss=0.3)
    belly = fur(kit, CREAM, TAN, ORANGE, pattern=BANDS, frequency=25)
    hull(kit, [(-0.35, 0, 0.55), (0.3, 0, 0.65)], [0.2, 0.23], coat, 0.85)
    kit.add(BALL, (0.05, 0, 0.53), (0.42, 0.15, 0.16), rotation=turn("y", -8), material=belly)
    path = bend((0.4, 0, 0.72), (0.95, 0, 0.75), (0.72, 0, 1.3), 3)
    hull(kit, path, [0.19, 0.13, 0.09], coat, first=False)
    head = reptile_head(kit, path[-1] + [0.06, 0, 0.03], looking(kit, 12, 18), 0.11, 2.2, coat, belly, None, rng.choice([0.0, 20.0]))
    for y in (0.5, -0.5):
        kit.between(head.place(-0.3, y, 0.6), head.place(-1.9, y * 1.6, 1.4), 0.03, CYL, 0.1, claws)
    tail = bend((-0.45, 0, 0.52), (-1.1, 0, 0.1), (-1.6, rng.uniform(-0.5, 0.5), rng.uniform(0.2, 0.5)), 4)
    hull(kit, tail, [0.17, 0.12, 0.075, 0.03], coat, first=False)
    lift = rng.uniform(0.25, 0.9)
    root, wrist = np.array([0.25, 0.14, 0.82]), np.array([0.35, 0.55, 0.95 + lift * 0.7])
    ends = np.array([0.06, 1.46, 0.95 + lift])
    kit.between(root, wrist, 0.07, CYL, 0.5, coat, mirror=True)
    kit.between(wrist, ends, 0.03, CYL, 0.3, coat, mirror=True)
    edge = [(0.3, -0.3, 0.1), (0.38, -0.55, 0.55), (0.36, -0.32, 0.8), (0.27, -0.42, 1.08), (0.08, 0.03, 1.46)]
    membrane(kit, [(front, rear, y, np.interp(y, [0.14, 0.55, 1.45], [0.78, wrist[2], ends[2]])) for front, rear, y in edge], 0.012, skin)
    for side in (1, -1):
        limb(kit, (0.3, side * 0.15, 0.58), (0.38, side * 0.2, 0), True, 0.58, 0.065, coat, coat, "paw", True)
        limb(kit, (-0.35, side * 0.15, 0.52), (-0.32, side * 0.2, 0), False, 0.52, 0.07, coat, coat, "paw", True)
    sail(kit, tail[-1] + [-0.25, 0, 0.02], tail[-1] + [0, 0, 0.12], tail[-1] - [0, 0, 0.12], 0.02, skin)


UPRIGHT = {
    maker.__name__: maker
    for maker in (
        *(kangaroo, hopper, squirrel, monkey, penguin, owl, parrot, eagle, wader, swan, rooster, peacock, meerkat, seal, frog, bat),
        *(dragon, tyrannosaur, sauropod, plated, horned),
    )
}


def upright_animal(kit):
    """Kangaroos, rabbits, squirrels, monkeys and apes, penguins, owls, parrots, eagles, herons, flamingos, storks, ostriches, swans,
    geese, poultry, peacocks, meerkats, seals, walruses, frogs, bats, dragons, dinosaurs."""
    names = list(UPRIGHT)
    weights = np.array([2.0 if name in ("monkey", "wader", "hopper") else 1.0 for name in names])
    UPRIGHT[str(kit.rng.choice(names, p=weights / weights.sum()))](kit)
