"""Makers of mammals: the four-legged species in all their poses, and rabbits, squirrels, kangaroos, seals, apes, hedgehogs."""

import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, Head, bend, black, fur, hull, looking, neck_turned, swung
from .hides import FAWN, SAND, SILVER, SLATE
from .kit import towards, turn
from .layout import BALL, CYL
from .materials import BANDS, CLOUDY, PLAIN, SPECKLES
from .paws import foreleg, hindleg
from .skulls import skull
from .species import CANINE, CATTLE, EQUINE, FELINE, HOOFED, PILLARS, SHAPES, SPLIT, SUPPLE, coats


def trunk(kit, stations, coat, place):
    """A body through stations [(x, top, bottom, half width), ...] from buttock to breast."""
    points = [place((x, 0, (top + low) / 2)) for x, top, low, _ in stations]
    flat = sum(wide for *_, wide in stations) / sum((top - low) / 2 for _, top, low, _ in stations)
    sizes = [((top - low) / 2, (top - low) / 2 * flat) for _, top, low, _ in stations]
    for i in range(len(points) - 1):
        ratio = sizes[i + 1][0] / sizes[i][0]
        kit.between(points[i], points[i + 1], sizes[i], CYL, ratio, coat)
    for i, (deep, wide) in enumerate(sizes):
        way = towards(points[min(i + 1, len(points) - 1)] - points[max(i - 1, 0)])
        kit.add(BALL, points[i], (deep, wide, min(deep, wide * 1.3)), rotation=way, material=coat)


def tail(kit, name, root, leg, low, coat, hair):
    """Of a species, from `root`, with what is low lying on the ground."""
    rng = kit.rng
    z = root[2]
    if low and name not in PILLARS:
        side = rng.choice([-1, 1])
        far = 0.28 if name not in (*FELINE, "fox", "mouse") else 0.6
        path = bend(root, (root[0] - far * 0.6, 0, leg), (root[0] - far * 0.5, side * far * 0.7, leg * 1.1), 4)
    elif name in ("horse", "pony"):
        hull(kit, bend(root, root + [-0.16, 0, 0.04], root + [-0.13, 0, -z * 0.62], 4), [0.04, 0.055, 0.075, 0.03], hair)
        return
    elif name in (*FELINE, "mouse"):
        far = {"mouse": 1.3, "cat": 0.75}.get(name, 0.7)
        ends = [(-far * 0.55, 0, far * 0.75), (-far * 0.75, 0.1, -z * 0.65), (-far, 0, -z * 0.3)]
        stop = ends[rng.integers(1 if name == "mouse" else 0, 3)]
        path = bend(root, root + [-far * 0.5, 0, -far * 0.35], root + np.array(stop), 4)
    elif name == "fox":
        path = bend(root, root + [-0.3, 0, -0.1], root + [-0.62, 0, -z * 0.45], 4)
    elif name in ("husky", "pug"):
        scale = 1.0 if name == "husky" else 0.55
        path = [root, *(root + np.array(p) * scale for p in ((-0.13, 0, 0.14), (-0.05, 0.02, 0.27), (0.1, 0.05, 0.22)))]
    elif name in ("shepherd", "wolf", "hyena", "greyhound"):
        path = bend(root, root + [-0.16, 0, 0], root + [-0.2, 0, -z * 0.55], 4)
    elif name in CANINE and name not in ("bulldog", "corgi"):
        up = rng.uniform(-0.1, 0.4)
        path = bend(root, root + [-0.2, 0, 0], root + [-0.35, 0, up], 4)
    elif name in ("raccoon", "otter", "badger", "anteater", "armadillo"):
        far = {"otter": 1.3, "anteater": 1.0, "raccoon": 0.75, "armadillo": 0.7}.get(name, 0.35)
        path = bend(root, root + [-far * 0.5, 0, -0.05], (root[0] - far, 0, max(0.1, z * (0.5 if name != "armadillo" else 0.15))), 4)
    elif name in (*CATTLE, "giraffe", "zebra", "donkey", "elephant", "rhino", "hippo", "camel", "moose", "lion"):
        drop = {"hippo": 0.25, "rhino": 0.35, "bison": 0.35, "moose": 0.1}.get(name, 0.55) * z
        stop = root + [-0.1, rng.normal(0, 0.03), -drop]
        kit.chain(bend(root, root + [-0.12, 0, 0], stop, 3), [leg * 0.6, leg * 0.45, leg * 0.35], coat)
        kit.add(BALL, stop, (0.03, 0.03, 0.075), material=hair)
        return
    elif name in ("pig", "boar"):
        kit.chain([root, root + [-0.06, 0.03, 0.03], root + [-0.08, -0.03, 0.07]], 0.018, coat)
        return
    else:
        kit.add(BALL, root + [-0.03, 0, -0.04], (0.06, 0.045, 0.1), rotation=turn("y", 25), material=hair)
        return
    fat = {"fox": 2.6, "husky": 1.9, "raccoon": 1.7, "wolf": 1.7, "shepherd": 1.5, "retriever": 1.4, "anteater": 2.2, "otter": 1.5}.get(name, 0.85)
    radii = leg * fat * np.array([0.75, 1.0, 1.1, 0.6] if fat > 1.3 and name != "otter" else [1.0, 0.85, 0.7, 0.35])
    coat = hair if name in (*CANINE, "mouse", "anteater", "cat") else coat
    if name == "raccoon":
        coat = coat._replace(pattern=BANDS, frequency=22.0, second=np.array(BLACK))
    hull(kit, path, radii, coat)
    if name == "fox":
        kit.add(BALL, path[-1], (leg * 1.8,) * 3, material=fur(kit, WHITE))
    elif name == "poodle":
        kit.add(BALL, path[-1], (0.085,) * 3, material=hair)
    elif name == "lion":
        kit.add(BALL, path[-1], (0.05, 0.05, 0.07), material=hair)


def body_stations(name, long, chest, loin, croup, wide, rng):
    haunch = chest * 0.5 + loin * 0.5
    dip = rng.uniform(0, 0.025) if name in (*EQUINE, "cow") else -0.03 * chest if name not in ("boar", "bison", "hyena") else 0.0
    round_back = 0.05 if name in ("mouse", "raccoon", "armadillo", "capybara", "elephant") else 0.0
    back = [croup, croup * 0.55 + 0.45 - dip + round_back, 0.3 * croup + 0.7 - dip + round_back]
    drop = 0.2 if name in ("cow", "bull", "zebu", "buffalo", "camel", "elephant") else 0.28
    return [
        (-0.5 * long, croup - haunch * drop, croup - haunch * 0.82, wide * 0.58),
        (-0.38 * long, back[0], croup - haunch, wide * 0.92),
        (-0.13 * long, back[1], back[1] - loin, wide * 0.9 if loin < chest * 0.9 else wide * 1.06),
        (0.12 * long, back[2], back[2] - 0.55 * chest - 0.45 * loin, wide * 1.03),
        (0.34 * long, 1.0, 1.0 - chest, wide * 0.92),
        (0.47 * long, 0.93, 1 - 0.8 * chest, wide * 0.66),
    ]


def beast_of(kit, name):
    """One of SHAPES, standing, walking, grazing, sitting or lying."""
    rng = kit.rng
    shape = np.array(SHAPES[name])
    shape[[0, 1, 2, 4, 5, 7, 8, 9, 10, 11, 12]] *= np.exp(rng.normal(0, 0.05, 11))
    long, chest, loin, croup, wide, neck, rise, neck0, neck1, size, m, e, leg, down = shape
    chest, loin = min(chest, 0.88), min(loin, 0.86)
    poses = ["stand", "walk", "walk"]
    if name in CANINE or name in FELINE:
        poses += ["sit", "sit", "lie"]
    elif name in SPLIT or name in EQUINE:
        poses += ["graze"] if name not in ("giraffe", "camel", "moose") else []
        poses += ["lie"] if name in ("cow", "zebu", "buffalo", "deer", "camel", "sheep", "goat", "llama") else []
    elif name == "bear":
        poses += ["sit"]
    pose = str(rng.choice(poses))
    coat, lower, muzzle, under, back, hair = coats(kit, name)
    male = kit.chance(0.65)
    end = "hoof" if name in HOOFED and name != "camel" else "pad" if name in PILLARS or name == "camel" else "paw"
    heavy = name in PILLARS
    stations = body_stations(name, long, chest, loin, croup, wide, rng)
    hip = np.array([-0.37 * long, 0, croup - 0.45 * chest])
    seat, tilt = hip.copy(), np.eye(3)
    if pose == "sit":
        seat[2] = 0.1 * long + 0.27 * chest
        lift = (1 - 0.5 * chest) * 0.98 - seat[2] - (1 - 0.5 * chest - hip[2])
        tilt = turn("y", -np.clip(np.degrees(np.arcsin(np.clip(lift / (0.73 * long), 0, 0.86))), 12, 58))
    elif pose == "lie":
        seat[2] -= (1 - chest) * 0.98

    def place(point):
        return seat + tilt @ (np.array(point, float) - hip)

    trunk(kit, stations, coat, place)
    # Neck.
    base = place((0.37 * long, 0, 1 - 0.36 * chest))
    if pose == "graze":
        goal = np.array([base[0] + 0.42 * neck + 0.1 * long, 0, m * 0.92 + 0.02])
        down = rng.uniform(62, 78)
    else:
        up = rise + rng.normal(0, 6)
        up += 22 if pose == "sit" else 12 if pose == "lie" and up < 40 else 0
        goal = base + turn("y", -up) @ np.array([neck + 0.3 * chest * (1 if up > 20 else 0.6), 0, 0])
    if name == "camel" and pose != "graze":
        path = bend(base - [0, 0, 0.04], base + [neck * 0.7, 0, -0.16], goal, 4)
    else:
        path = bend(base, base * 0.42 + goal * 0.58 + [0.03 * neck, 0, -0.05 * neck], goal, 3)
    yaw = neck_turned(kit, 25 if heavy else 40 if pose == "graze" else 85 if name in SUPPLE else 60)
    level, path = path, swung(path, yaw)
    radii = np.interp(np.linspace(0, 1, len(path)), [0, 0.5, 1], [neck0, neck0 * 0.42 + neck1 * 0.58, neck1])
    hull(kit, path, radii, coat if name != "sheep" else coat._replace(pattern=SPECKLES), 0.78 if name in HOOFED else 0.88)
    facing = turn("z", yaw) @ looking(kit, down, 22)
    head = Head(kit, path[-1] + facing @ np.array([size * 0.35, 0, 0]) + [0, 0, size * 0.2], facing, size)
    if name == "lion" and male:
        for where, half in (((-0.4, 0, 0.05), (0.8, 1.45, 1.45)), ((-1.0, 0, -0.6), (1.2, 1.4, 1.6)), ((0.05, 0, -0.95), (0.7, 0.8, 0.8))):
            head.ball(where, half, hair)
    skull(kit, name, head, m, e, coat, muzzle, hair, male)
    # Legs.
    fore_y, hind_y = wide * 0.6, wide * 0.58
    ground = 1 - chest
    stride = {"walk": rng.uniform(0.2, 0.36), "stand": rng.uniform(0, 0.08)}.get(pose, 0.0) * (ground + 0.1) * (0.7 if heavy else 1)
    hock_up = (0.72 if end == "hoof" else 0.35 if name in ("bear", "badger", "raccoon", "otter", "anteater", "armadillo", "mouse") else 0.5) * ground
    for side in (1, -1):
        top, elbow = place((0.38 * long, side * fore_y, 1 - 0.5 * chest)), place((0.33 * long, side * fore_y, 1 - 0.93 * chest))
        step = side * stride
        if pose == "lie":
            elbow = np.array([elbow[0], side * fore_y * 1.15, leg * 1.9])
            kit.add(BALL, (top + elbow) / 2, (chest * 0.24, wide * 0.36, chest * 0.36), rotation=towards(top - elbow), material=coat)
            knee = elbow + [0.62 * ground + 0.1 * long, 0, -leg * 0.7]
            kit.between(elbow, knee, leg * 1.8, CYL, 0.62, coat)
            if end == "hoof" or end == "pad":
                kit.chain([knee, (elbow[0] + 0.05, side * (fore_y * 1.15 + leg), leg)], [leg * 1.1, leg], lower)
            else:
                kit.add(BALL, knee + [leg, 0, -leg * 0.3], (leg * 1.9, leg * 1.4, leg * 0.85), material=lower)
        else:
            at = np.array([top[0] - 0.02 + step, top[1] * (0.92 if pose != "sit" else 0.8), 0])
            foreleg(kit, top, elbow + [step * 0.15, 0, 0], at, leg, chest * 0.27, coat, lower, end, 0.52 if end == "hoof" else 0.62)
        if pose in ("sit", "lie"):
            z = max(chest * 0.32, 0.14)
            x = seat[0] + (0.1 * long if pose == "lie" else 0.08)
            kit.add(BALL, (x, side * wide * 0.82, z), (chest * 0.46, wide * 0.38, z), rotation=turn("y", -20), material=coat)
            heel, toe = np.array([x - 0.1, side * wide * 1.1, leg * 1.2]), np.array([x + chest * 0.5, side * wide * 1.15, leg])
            kit.between(heel, toe, leg * 1.3, CYL, 0.85, lower)
            kit.add(BALL, toe + [leg, 0, -leg * 0.1], (leg * 1.8, leg * 1.35, leg * 0.9), material=lower)
            continue
        joint = (-0.36 * long, side * hind_y, croup - 0.4 * chest)
        knee = (-0.29 * long - 0.35 * step, side * hind_y, croup - chest * 0.95 if not heavy else croup - chest * 0.9)
        at = np.array([-0.44 * long - step, side * hind_y, 0])
        hock = np.array([at[0] - (0.08 * ground if heavy else 0.16 * ground) + 0.25 * step, side * hind_y, hock_up])
        if heavy:
            hock[0] = at[0] * 0.6 + knee[0] * 0.4
        hindleg(kit, joint, knee, hock, at, leg, chest * 0.37, coat, lower, end)
    root = place((-0.5 * long, 0, croup - chest * 0.22))
    tail(kit, name, root, leg, pose in ("sit", "lie"), coat, hair)
    # Markings, manes, humps, fleece.
    slope = tilt @ turn("y", np.degrees(np.arctan2(croup - 1, long)) * 0.8)
    if under:
        kit.add(
            BALL, place((0.02 * long, 0, 1 - chest * 0.68 + (chest - loin) * 0.2)), (long * 0.36, wide * 0.9, chest * 0.33), rotation=slope @ turn("y", -8), material=under
        )
        kit.add(BALL, place((0.42 * long, 0, 1 - chest * 0.55)), (long * 0.1, wide * 0.62, chest * 0.36), rotation=tilt, material=under)
    if back:
        kit.add(BALL, place((-0.06 * long, 0, 0.5 + croup / 2 - chest * 0.2)), (long * 0.43, wide * 0.98, chest * 0.24), rotation=slope, material=back)
    if name in EQUINE:
        aim = (level[-1] - level[0]) / np.linalg.norm(level[-1] - level[0])
        normal = np.array([-aim[2], 0, aim[0]])
        for k in (0.1, 0.4, 0.7, 0.98):
            width = np.interp(k, [0, 1], [neck0, neck1])
            half = (neck * 0.24, 0.03, width * (0.55 if name in ("horse", "pony") else 0.35))
            turned = turn("z", yaw * k)
            at = level[0] + turned @ ((level[-1] - level[0]) * k + normal * width * 0.85)
            kit.add(BALL, at, half, rotation=turned @ turn("y", -np.degrees(np.arctan2(aim[2], aim[0]))), material=hair)
    elif name == "camel":
        for x in (-0.2, 0.16) if kit.chance(0.5) else (-0.03,):
            kit.add(BALL, place((x * long, 0, 0.93)), (0.12 if x != -0.03 else 0.2, 0.11, rng.uniform(0.22, 0.3)), material=hair if kit.chance(0.4) else coat)
    elif name == "sheep":
        wool = coat._replace(pattern=SPECKLES, frequency=20.0)
        for x in (-0.34, 0.0, 0.32):
            kit.add(BALL, place((x * long, 0.55 * wide, 1 - chest * 0.46)), (long * 0.21, wide * 0.6, chest * 0.5), material=wool, mirror=True)
    elif name in ("bison", "moose", "bull"):
        half = {"bison": (0.3, wide * 0.72, 0.36), "moose": (0.2, wide * 0.6, 0.2), "bull": (0.26, wide * 0.6, 0.2)}[name]
        kit.add(BALL, place((0.24 * long, 0, 0.86)), half, material=hair if name == "bison" else coat)
        if name == "bison":
            kit.add(BALL, place((0.38 * long, 0, 0.6)), (0.22, wide * 0.95, 0.38), material=hair)
    elif name == "zebu":
        kit.add(BALL, place((0.27 * long, 0, 1.0)), (rng.uniform(0.15, 0.2), wide * 0.5, rng.uniform(0.14, 0.22)), rotation=turn("y", rng.uniform(-25, 5)), material=coat)
        hang = chest * rng.uniform(0.75, 0.95)
        kit.add(BALL, place((0.4 * long, 0, 1 - hang)), (0.18 * long, 0.035, chest * 0.3), rotation=turn("y", -30), material=coat)
    elif name == "poodle" and pose in ("stand", "walk"):
        kit.add(BALL, place((0.25 * long, 0, 1 - chest * 0.45)), (long * 0.3, wide * 1.35, chest * 0.62), material=hair)
    elif name == "hyena":
        kit.add(BALL, place((0.2 * long, 0, 0.97)), (0.3 * long, 0.03, 0.09), rotation=turn("y", 8), material=hair)
    elif name == "cow" and pose in ("stand", "walk", "graze") and kit.chance(0.7):
        kit.add(BALL, place((-0.27 * long, 0, 1 - loin - 0.03)), (0.12, 0.1, 0.09), material=fur(kit, PINK, pattern=PLAIN))
    if name in (*EQUINE[:3], "camel") and pose in ("stand", "walk") and kit.chance(0.2):
        kit.add(BALL, place((0.08 * long, 0, 0.86)), (0.17, wide * 1.05, 0.19), material=kit.material(base=BROWN if kit.chance(0.5) else None, gloss=0.2))
    if name in CANINE[:12] and kit.chance(0.4):
        kit.between(path[1] * 0.6 + path[-1] * 0.4, path[1] * 0.35 + path[-1] * 0.65, radii[1] * 1.04, material=kit.material(gloss=0.2))


def crouched(kit):
    """Rabbits, hares and squirrels on their haunches."""
    rng = kit.rng
    name = str(rng.choice(["rabbit", "hare", "squirrel"]))
    coat = fur(kit, *{"rabbit": (GREY, TAN, WHITE, BROWN, BLACK), "hare": (TAN, SAND, WHITE), "squirrel": (RED, ORANGE, GREY)}[name])
    pale, pink = fur(kit, WHITE, CREAM), fur(kit, PINK, pattern=PLAIN)
    up = 58 if name == "squirrel" else rng.choice([12, 38])
    lift = turn("y", -up)
    seat = np.array([-0.18, 0, 0.26])
    chest = seat + lift @ np.array([0.42, 0, 0])
    hull(kit, [seat, (seat + chest) / 2 + lift @ np.array([0, 0, 0.04]), chest], [0.25, 0.25, 0.17], coat, 0.88)
    kit.add(BALL, (seat + chest) / 2 + lift @ np.array([0.08, 0, -0.08]), (0.3, 0.17, 0.18), rotation=lift, material=pale)
    neck = chest + np.array([0.13, 0, 0.16])
    hull(kit, [chest, neck], [0.16, 0.12], coat, first=False)
    head = Head(kit, neck + np.array([0.04, 0, 0.03]), looking(kit, 14, 25), 0.125)
    head.ball((0, 0, 0), (1.15, 0.9, 0.98), coat)
    head.ball((0.72, 0, -0.25), (0.62, 0.6, 0.55), coat)
    head.ball((0.98, 0.2, -0.38), (0.3, 0.28, 0.26), pale, True)
    head.ball((1.3, 0, -0.16), (0.1, 0.14, 0.1), pink)
    head.eyes(0.55, 0.74, 0.25, 0.17)
    if name == "squirrel":
        head.ear("leaf", 0.5, coat, pink)
    elif name == "rabbit" and kit.chance(0.3):
        head.ball((-0.1, 0.95, -0.35), (0.3, 0.17, 1.0), coat, True, (-10, 10))
    else:
        head.ear("leaf", 1.0 if name == "rabbit" else 1.25, coat, pink)
    for side in (1, -1):
        kit.add(BALL, seat + [0.08, side * 0.17, -0.03], (0.24, 0.11, 0.2), rotation=turn("y", -25), material=coat)
        kit.between((-0.18, side * 0.19, 0.045), (0.22, side * 0.2, 0.04), (0.045, 0.055), CYL, 0.8, coat)
        kit.add(BALL, (0.22, side * 0.2, 0.04), (0.07, 0.05, 0.04), material=pale)
        if name == "squirrel":
            hull(kit, [chest + [0.05, side * 0.12, -0.03], chest + [0.14, side * 0.14, -0.14], chest + [0.24, side * 0.04, -0.08]], [0.06, 0.045, 0.035], coat)
        else:
            hull(kit, [chest + [0.02, side * 0.1, -0.05], (chest[0] + 0.05, side * 0.1, 0.05)], [0.075, 0.05], coat)
            kit.add(BALL, (chest[0] + 0.1, side * 0.1, 0.04), (0.08, 0.05, 0.04), material=pale)
    if name == "squirrel":
        kit.add(BALL, chest + [0.26, 0, -0.06], (0.06, 0.055, 0.065), material=fur(kit, BROWN, pattern=PLAIN, gloss=0.3))
        path = [(-0.35, 0, 0.1), (-0.52, 0, 0.3), (-0.5, 0, 0.62), (-0.42, 0, 0.88), (-0.56, 0, 1.0)]
        hull(kit, path, [0.08, 0.14, 0.16, 0.14, 0.07], coat, 0.8)
    else:
        kit.add(BALL, seat + [-0.27, 0, -0.05], (0.08,) * 3, material=pale)


def kangaroo(kit):
    rng = kit.rng
    coat = fur(kit, TAN, RED, GREY, FAWN)
    pale, dark = fur(kit, CREAM, WHITE), fur(kit, DARK, BROWN)
    hip, chest = np.array([-0.1, 0, 0.5]), np.array([0.2, 0, rng.uniform(0.9, 1.0)])
    hull(kit, [hip, (hip + chest) / 2 - [0.01, 0, 0], chest], [0.25, 0.21, 0.14], coat, 0.85)
    kit.add(BALL, (hip + chest) / 2 + [0.08, 0, -0.05], (0.15, 0.15, 0.3), rotation=turn("y", 30), material=pale)
    neck = chest + [0.1, 0, 0.24]
    hull(kit, [chest, neck], [0.13, 0.075], coat, first=False)
    head = Head(kit, neck + [0.03, 0, 0.03], looking(kit, 15, 25), 0.085)
    head.ball((0, 0, 0), (1.1, 0.88, 0.95), coat)
    kit.between(head.place(0.2, 0, -0.08), head.place(2.0, 0, -0.35), 0.062, CYL, 0.65, coat)
    head.ball((2.05, 0, -0.35), (0.42, 0.45, 0.45), pale)
    head.ball((2.35, 0, -0.2), (0.18, 0.22, 0.16), black(kit))
    head.eyes(0.62, 0.72, 0.25, 0.17)
    head.ear("leaf", 1.1, coat, fur(kit, PINK))
    for side in (1, -1):
        kit.add(BALL, (0.0, side * 0.2, 0.42), (0.17, 0.1, 0.28), rotation=turn("y", -32), material=coat)
        hull(kit, [(0.14, side * 0.21, 0.26), (-0.16, side * 0.21, 0.09)], [0.075, 0.045], coat)
        kit.between((-0.2, side * 0.21, 0.04), (0.3, side * 0.21, 0.035), (0.035, 0.045), CYL, 0.7, dark)
        hull(kit, [chest + [0.06, side * 0.12, 0], chest + [0.16, side * 0.15, -0.2], chest + [0.28, side * 0.12, -0.24]], [0.055, 0.038, 0.03], coat)
        kit.add(BALL, chest + [0.31, side * 0.12, -0.25], (0.05, 0.035, 0.03), material=dark)
    hull(kit, bend((-0.25, 0, 0.4), (-0.6, 0, 0.0), (-1.25, 0, 0.04), 5), [0.17, 0.12, 0.085, 0.06, 0.03], coat)
    if kit.chance(0.35):
        joey = Head(kit, (hip + chest) / 2 + [0.26, 0, -0.08], turn("y", 5), 0.055)
        joey.ball((0, 0, 0), (1.4, 0.95, 1), coat)
        joey.ear("leaf", 1.0, coat)
        joey.eyes(0.7, 0.75, 0.25, 0.18)


def seal(kit):
    """Seals, sea lions on their flippers and walruses."""
    rng = kit.rng
    kind = str(rng.choice(["seal", "lion", "walrus"]))
    coat = fur(
        kit, *{"seal": (GREY, SILVER, SLATE), "lion": (DARK, BROWN), "walrus": (BROWN, (0.3, 0.17, 0.11))}[kind], pattern=SPECKLES if kind == "seal" else CLOUDY, gloss=0.25
    )
    up = {"seal": 0.05, "lion": 0.42, "walrus": 0.28}[kind]
    fat = {"seal": 0.25, "lion": 0.23, "walrus": 0.34}[kind]
    path = [(-0.95, 0, 0.08), (-0.6, 0, fat * 0.62), (-0.15, 0, fat * 0.95), (0.25, 0, fat * 0.95 + up * 0.45), (0.48, 0, fat + up * 1.15)]
    hull(kit, path, np.array([0.3, 0.68, 1.0, 0.92, 0.6]) * fat, coat)
    tip = np.array(path[-1]) + [0.14, 0, 0.16]
    hull(kit, [path[-1], tip], [fat * 0.6, fat * 0.5], coat, first=False)
    head = Head(kit, tip + [0.04, 0, 0.02], looking(kit, 5, 20), fat * 0.52)
    head.ball((0, 0, 0), (1.15, 0.95, 0.95), coat)
    head.ball((0.75, 0.24, -0.25), (0.5, 0.38, 0.36), coat if kind != "walrus" else fur(kit, TAN), True)
    head.ball((1.2, 0, 0), (0.14, 0.2, 0.13), black(kit))
    head.eyes(0.78, 0.5, 0.28, 0.15 if kind == "seal" else 0.1)
    if kind == "walrus":
        head.rods([(0.95, 0.3, -0.4), (1.15, 0.34, -1.3), (1.1, 0.32, -2.0)], [0.13, 0.1, 0.04], fur(kit, CREAM, pattern=PLAIN, gloss=0.3))
    for side in (1, -1):
        sole = fur(kit, DARK) if kind == "lion" else coat
        hull(kit, [(0.25, side * fat * 0.75, fat * 0.7), (0.28, side * (fat + 0.12), 0.05)], [0.09, 0.06], sole)
        kit.add(BALL, (0.22, side * (fat + 0.25), 0.03), (0.12, 0.22, 0.03), rotation=turn("z", -25 * side), material=sole)
        kit.add(BALL, (-1.12, side * 0.1, 0.05), (0.2, 0.075, 0.035), rotation=turn("z", -22 * side), material=sole)


def ape(kit):
    """Gorillas on their knuckles, monkeys on four hands or sitting, with long tails."""
    rng = kit.rng
    gorilla = kit.chance(0.45)
    coat = fur(kit, BLACK, (0.05, 0.05, 0.06)) if gorilla else fur(kit, BROWN, TAN, GREY, DARK, ORANGE)
    face = fur(kit, (0.05, 0.045, 0.045), pattern=PLAIN, gloss=0.15) if gorilla else fur(kit, PINK, TAN, CREAM, DARK, pattern=PLAIN)
    fat = 1.0 if gorilla else 0.62
    sits = kit.chance(0.4)
    hip = np.array([-0.38, 0, 0.52]) if not sits else np.array([-0.12, 0, 0.24 * fat + 0.03])
    chest = np.array([0.25, 0, 0.82 if gorilla else 0.66]) if not sits else np.array([0.05, 0, 0.85])
    middle = (hip + chest) / 2
    hull(kit, [hip, middle, chest], np.array([0.26, 0.3, 0.3]) * fat, coat, [1.0, 1.05, 1.12])
    if gorilla and kit.chance(0.6):
        kit.add(BALL, middle + ([0, 0, 0.12] if not sits else [-0.12, 0, 0]), (0.28, 0.27, 0.2), rotation=turn("y", -20 if not sits else -75), material=fur(kit, SILVER))
    neck = chest + np.array([0.2, 0, 0.26]) * (1 if gorilla else 0.75) * ([1, 1, 1] if not sits else [0.3, 1, 1.3])
    hull(kit, [chest, neck], np.array([0.22, 0.16]) * fat, coat, first=False)
    size = 0.17 if gorilla else 0.135
    head = Head(kit, neck + [0.03, 0, 0.05], looking(kit, 5, 25), size)
    head.ball((-0.05, 0, 0.1), (1.0, 0.9, 1.05), coat)
    if gorilla:
        head.ball((-0.25, 0, 0.75), (0.75, 0.5, 0.7), coat)
    head.ball((0.55, 0, -0.1), (0.5, 0.72, 0.75), face)
    head.ball((0.8, 0, -0.45), (0.5, 0.55, 0.45), face)
    head.ball((0.8, 0, 0.3), (0.25, 0.68, 0.16), face)
    head.ball((1.25, 0.16, -0.3), (0.08, 0.1, 0.07), black(kit), True)
    head.eyes(0.96, 0.3, 0.12, 0.1)
    head.ball((-0.05, 0.92, 0.05), (0.2, 0.14, 0.3), face, True)
    for side in (1, -1):
        shoulder = chest + np.array([0.06, side * 0.28 * fat, 0.06])
        if sits:
            hand = np.array([0.34, side * 0.3 * fat, 0.42 * fat + 0.1])
            elbow = (shoulder + hand) / 2 + [-0.03, side * 0.12, -0.12]
        else:
            hand = np.array([0.42 + side * 0.1, side * 0.3 * fat, 0.06])
            elbow = (shoulder + hand) / 2 + [-0.05, side * 0.06, 0]
        hull(kit, [shoulder, elbow, hand], np.array([0.15, 0.115, 0.085]) * fat, coat)
        kit.add(BALL, hand + [0.04, 0, -0.01], np.array([0.12, 0.085, 0.07]) * fat, material=face)
        thigh = hip + [0.02, side * 0.2 * fat, 0]
        knee = np.array([0.3, side * 0.36 * fat, 0.42 * fat + 0.05]) if sits else hip + [0.18, side * 0.24 * fat, -0.2]
        sole = np.array([0.28 if sits else -0.34 - side * 0.08, side * 0.3 * fat, 0.05])
        hull(kit, [thigh, knee, sole], np.array([0.17, 0.12, 0.08]) * fat, coat)
        kit.add(BALL, sole + [0.08, 0, -0.01], np.array([0.15, 0.08, 0.06]) * fat, material=face)
    if not gorilla:
        start = hip + [-0.14, 0, 0.02]
        way = bend(start, start + [-0.5, 0, 0.1 if not sits else -0.25], start + [-0.55, rng.uniform(-0.2, 0.2), 0.6 if not sits else -0.12], 6)
        hull(kit, way, np.linspace(0.055, 0.03, 6), coat)


def hedgehog(kit):
    """A dome of spines over a pale face and belly."""
    rng = kit.rng
    spine, pale = fur(kit, BROWN, DARK, TAN, pattern=SPECKLES, frequency=24, second=CREAM), fur(kit, CREAM, TAN)
    kit.add(BALL, (-0.05, 0, 0.3), (0.5, 0.33, 0.29), material=spine)
    kit.add(BALL, (0.05, 0, 0.22), (0.48, 0.29, 0.2), material=pale)
    hull(kit, [(0.35, 0, 0.27), (0.66, 0, 0.2)], [0.19, 0.06], pale)
    kit.add(BALL, (0.74, 0, 0.21), (0.045,) * 3, material=black(kit))
    kit.add(BALL, (0.55, 0.11, 0.3), (0.03,) * 3, material=black(kit), mirror=True)
    kit.add(BALL, (0.4, 0.18, 0.37), (0.03, 0.06, 0.07), material=pale, mirror=True)
    for x in (0.28, -0.3):
        kit.chain([(x, 0.18, 0.15), (x + 0.02, 0.2, 0.04)], [0.07, 0.05], pale, mirror=True)
        kit.add(BALL, (x + 0.07, 0.2, 0.03), (0.08, 0.05, 0.03), material=pale, mirror=True)
    for row, count in ((20, 9), (45, 9), (68, 7), (90, 3)):
        for k in range(count):
            angle, lift = np.radians(50 + 260 * (k + 0.5 * (row % 2)) / max(count - 0.5, 1)), np.radians(row + rng.uniform(-6, 6))
            way = np.array([np.cos(angle) * np.cos(lift), np.sin(angle) * np.cos(lift), np.sin(lift)])
            foot_at = np.array([-0.05, 0, 0.3]) + way * [0.46, 0.3, 0.26]
            kit.between(foot_at, foot_at + way * 0.14 + [-0.06, 0, 0], 0.035, CYL, 0.05, spine)
