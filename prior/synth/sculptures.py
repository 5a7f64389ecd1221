"""Makers of statues, riders, lions, abstract sculptures, totem poles, fountains with figures, graves, obelisks."""


import numpy as np

from .belongings import arc, brass, steel, timber
from .bodies import FORE, UPPER, bent
from .figures import bar, carved, dress_up, face_on, features, figure, hair_on, hat_on, head_frame, plain, skirt
from .kit import ALONG_X, around, turn
from .layout import BALL, BOX, CYL, PRISM
from .materials import BANDS, FACADE, LEDGES, PLAIN, STREAKS, WRITING, paint


def pedestal(kit, high, half=0.35, long=1.0, material=None):
    """A base with steps, dado and cornice below z = 0, and often an inscription; returns the material."""
    stone = material or carved(kit)
    if kit.chance(0.3) and long == 1.0:
        kit.loft((0, 0, -high), [(0, half * 1.25), (0.1, half * 1.25), (0.14, half), (high - 0.1, half * 0.95), (high - 0.08, half * 1.12), (high, half * 1.12)], stone)
        return stone
    kit.add(BOX, (0, 0, -high / 2), (half * long, half, high / 2), (0.94, 0.94), material=stone)
    kit.add(BOX, (0, 0, -0.05), (half * long * 1.08, half * 1.1, 0.05), material=stone)
    kit.add(BOX, (0, 0, 0.06 - high), (half * long * 1.2, half * 1.25, 0.09), material=stone)
    if kit.chance(0.5) and high > 0.4:
        kit.add(BOX, (half * long * 0.97, 0, -high * 0.5), (0.02, half * 0.6, high * 0.2), material=stone._replace(pattern=WRITING, first=stone.first * 0.6))
    return stone


def wings(kit, f, material, spread):
    for side in (1, -1):
        root = np.array([-0.11, side * 0.06, 0.42])
        top = root + [-0.2, side * 0.42 * spread, 0.4]
        f.limb(f.high(*root), f.high(*top), 0.05, 0.7, material)
        for k in range(6):
            start = root + (top - root) * (0.2 + 0.155 * k)
            end = start + [-0.08, side * (0.02 + 0.09 * k) * spread, -0.5 - 0.1 * (k - 1)]
            kit.between(f.place(f.high(*start)), f.place(f.high(*end)), np.array([0.11, 0.025]) * f.size, CYL, 0.5, material)


def human_statue(kit):
    """Standing, draped, winged, seated, kneeling, of liberty, of a Madonna, of a warrior."""
    rng, stone = kit.rng, carved(kit)
    kind = rng.choice(["nude", "draped", "winged", "seated", "madonna", "liberty", "warrior", "man"])
    wear = dress_up(kit, stone, woman=kind in ("liberty", "madonna") or kit.chance(0.5))
    robe, legs, arms, lean, hands = 0.0, "rest", rng.choice(["hang", "hips", "raised", "point", "crossed", "behind"]), 0, None
    if kind in ("draped", "winged", "madonna", "liberty"):
        robe, legs = 0.02, "stand"
    if kind == "seated":
        legs, arms, lean = "sit", rng.choice(["chin", "knees"]), rng.uniform(4, 20)
    elif kind == "madonna":
        arms = "pray"
    elif kind in ("liberty", "warrior"):
        hands = [(0.16, 0.2, 0.2), (0.1, 0.26, 1.0)] if kind == "liberty" else [(0.3, 0.2, 0.25), (0.2, 0.4, 0.42)]
    f = figure(kit, wear, legs, arms, lean, robe=robe, hands=hands, flipped=False)
    if kind == "seated":
        kit.add(BOX, (-0.1, 0, 0.21), (0.26, 0.27, 0.21), material=stone)
    elif kind == "winged":
        wings(kit, f, stone, rng.uniform(0.7, 1.3))
    elif kind == "liberty":
        left, right = np.array(f.hands)
        kit.loft(right - [0, 0, 0.14], [(0, 0.02), (0.2, 0.035), (0.24, 0.07), (0.28, 0.07)], stone)
        kit.add(BALL, right + [0, 0, 0.2], (0.055, 0.055, 0.1), material=brass(kit) if kit.chance(0.4) else stone)
        kit.add(BOX, left + [0.0, 0.03, 0.08], (0.035, 0.1, 0.16), rotation=turn("y", -10), material=stone)
        for a in np.linspace(-75, 75, 7):
            s, c = np.sin(np.radians(a)), np.cos(np.radians(a))
            bar(f.head, (0.1 + 0.3 * c, s * 0.7, 0.75 + 0.2 * c), (0.1 + 0.7 * c, s * 1.7, 1.0 + 1.0 * c), 0.12, stone, 0.15)
    elif kind == "warrior":
        right = np.array(f.hands[1])
        kit.between((right[0], right[1], 0), (right[0], right[1], 2.1), 0.018, material=stone)
        kit.between((right[0], right[1], 2.08), (right[0], right[1], 2.32), (0.05, 0.02), taper=0.1, material=stone)
        left = np.array(f.hands[0])
        kit.add(CYL, left + [0.06, 0.03, 0], (0.3, 0.3, 0.02), rotation=ALONG_X, material=stone)
        kit.add(BALL, left + [0.08, 0.03, 0], (0.06, 0.09, 0.09), material=stone)
        skirt(kit, np.zeros(3), 1.0, 1.0, 0.6, stone, 0.23)
    elif kind == "man":
        skirt_low = rng.uniform(0.45, 0.7)
        kit.add(CYL, (0, 0, (skirt_low + 1.0) / 2), (0.2, 0.23, (1.0 - skirt_low) / 2), (0.72, 1), material=stone)
    if kind == "madonna" or (robe and kit.chance(0.3)):
        hat_on(kit, f.head, "scarf", stone, stone, True)
    elif kind == "warrior":
        f.head(BALL, (-0.12, 0, 0.4), (0.92, 0.78, 0.8), stone)
        for k in range(5):
            a = np.radians(30 + 35 * k)
            f.head(BOX, (-0.12 + 0.95 * np.cos(a), 0, 0.45 + 0.85 * np.sin(a)), (0.3, 0.09, 0.22), stone, tilt=turn("y", 90 - np.degrees(a)))
    else:
        hair_on(f.head, rng, rng.choice(["short", "bun", "long", "bob"]), stone)
    pedestal(kit, rng.uniform(0.1, 1.6), 0.42 if kind != "seated" else 0.55, material=stone if kit.chance(0.5) else None)
    face_on(kit, f, wear)


def buddha(kit):
    rng, stone = kit.rng, carved(kit)
    wear = dress_up(kit, stone, woman=False, fat=rng.choice([0.02, 0.05, 0.1]), head=1.25)
    pose = rng.choice([0, 1, 2])
    hands = [[(0.24, -0.02, 0.02), (0.24, 0.02, 0.03)], [(0.24, 0.0, 0.02), (0.33, 0.27, 0.05)], [(0.24, 0.0, 0.02), (0.3, 0.2, 0.4)]][pose]
    f = figure(kit, wear, "lotus", hands=hands, look=turn("y", 6), flipped=False)
    kit.add(BALL, (0.1, 0, 0.1), (0.36, 0.52, 0.13), material=stone)
    f.head(BALL, (-0.15, 0, 0.4), (0.82, 0.75, 0.75), stone)
    f.head(BALL, (-0.2, 0, 1.12), (0.38, 0.38, 0.32), stone)
    f.head(BALL, (-0.05, 0.68, -0.3), (0.15, 0.1, 0.45), stone, mirror=True)
    f.limb(f.high(0.1, 0.14, 0.5), f.high(0.14, -0.1, 0.1), (0.04, 0.03), 1, stone)
    base = stone if kit.chance(0.5) else carved(kit)
    kit.loft((0.1, 0, -0.34), [(0, 0.62), (0.08, 0.62), (0.12, 0.5), (0.22, 0.5), (0.34, 0.6)], base, flat=1.05)
    for x, y in around(12, 0.56):
        kit.add(BALL, (0.1 + x, y * 1.05, -0.1), (0.12, 0.12, 0.12), material=base)
    if kit.chance(0.3):
        kit.add(CYL, (-0.2, 0, 0.9), (0.42, 0.42, 0.03), rotation=ALONG_X, material=brass(kit))
        kit.between((-0.21, 0, -0.1), (-0.21, 0, 0.7), 0.06, material=stone)


def lion(kit):
    """A lion lying on its plinth, or a sphinx."""
    rng, stone, sphinx = kit.rng, carved(kit), kit.chance(0.4)
    kit.add(BALL, (-0.1, 0, 0.36), (0.72, 0.26, 0.27), material=stone)
    kit.add(BALL, (0.35, 0, 0.42), (0.34, 0.27, 0.36), material=stone)
    kit.add(BALL, (-0.55, 0.2, 0.3), (0.3, 0.14, 0.29), material=stone, mirror=True)
    kit.add(BALL, (-0.3, 0.3, 0.08), (0.3, 0.08, 0.09), material=stone, mirror=True)
    kit.chain([(0.4, 0.2, 0.38), (0.42, 0.22, 0.1), (1.0, 0.2, 0.08)], [0.14, 0.11, 0.085], stone, mirror=True)
    kit.add(BALL, (1.03, 0.2, 0.07), (0.14, 0.1, 0.085), material=stone, mirror=True)
    kit.chain([(-0.78, 0, 0.25), (-0.95, 0.2, 0.08), (-0.6, 0.45, 0.05), (-0.3, 0.44, 0.05)], [0.06, 0.05, 0.045, 0.06], stone)
    if sphinx:
        part = head_frame(kit, np.array([0.55, 0, 1.0]), 0.24, np.eye(3))
        kit.between((0.4, 0, 0.5), (0.5, 0, 0.95), 0.15, material=stone)
        features(kit, part, stone, stone, True, False)
        part(BOX, (-0.25, 0, -0.3), (0.5, 1.1, 0.95), stone._replace(pattern=BANDS), (1, 0.7))
        part(BALL, (-0.15, 0, 0.5), (0.85, 0.8, 0.7), stone)
        part(CYL, (0.5, 0, -1.2), (0.12, 0.14, 0.4), stone, (1.3, 1))
    else:
        kit.add(BALL, (0.42, 0, 0.72), (0.34, 0.35, 0.4), material=stone)
        for x, y in around(9, 0.3, 10):
            kit.add(BALL, (0.5 + 0.04 * (x < 0), y, 0.78 + x), (0.16, 0.13, 0.15), material=stone)
        kit.add(BALL, (0.64, 0, 0.82), (0.22, 0.18, 0.22), material=stone)
        kit.add(BALL, (0.82, 0, 0.74), (0.15, 0.13, 0.11), material=stone)
        kit.add(BALL, (0.78, 0, 0.64), (0.12, 0.09, 0.07), material=stone)
        kit.add(BALL, (0.92, 0, 0.8), (0.05, 0.06, 0.04), material=stone)
        kit.add(BALL, (0.79, 0.09, 0.87), (0.05, 0.05, 0.035), material=stone, mirror=True)
        kit.add(BALL, (0.52, 0.2, 1.05), (0.05, 0.08, 0.09), material=stone, mirror=True)
    pedestal(kit, rng.uniform(0.15, 0.9), 0.48, 2.5, stone if kit.chance(0.6) else None)


def equestrian(kit):
    rng, stone = kit.rng, carved(kit)
    z = 1.25
    rears = kit.chance(0.3)
    kit.bevel = max(kit.bevel, 0.4)
    first = len(kit.primitives)
    kit.add(BALL, (0, 0, z), (0.78, 0.27, 0.3), material=stone)
    kit.add(BALL, (-0.5, 0, z + 0.04), (0.36, 0.29, 0.33), material=stone)
    kit.add(BALL, (0.5, 0, z + 0.03), (0.34, 0.26, 0.34), material=stone)
    head = np.array([1.08, 0, z + 0.72])
    kit.between((0.55, 0, z + 0.08), head, (0.25, 0.15), taper=0.55, material=stone)
    kit.between(head + [-0.06, 0, 0.04], head + [0.33, 0, -0.3], (0.13, 0.1), taper=0.65, material=stone)
    kit.add(BALL, head + [-0.02, 0, 0], (0.15, 0.11, 0.14), material=stone)
    kit.add(BALL, head + [0.33, 0, -0.3], (0.09, 0.075, 0.085), material=stone)
    kit.add(CYL, head + [-0.06, 0.06, 0.17], (0.04, 0.03, 0.09), (0.2, 1), material=stone, mirror=True)
    kit.between((0.4, 0, z + 0.36), head + [-0.12, 0, 0.08], (0.1, 0.04), BOX, material=stone)
    kit.chain([(-0.82, 0, z + 0.15), (-1.02, 0, z - 0.1), (-1.05, 0, z - 0.65)], [0.07, 0.11, 0.06], stone)
    lifted = rng.choice([-1, 1])
    for side in (1, -1):
        y, free = side * 0.16, rears or side == lifted
        front = [(0.52, y, z - 0.1), (0.82, y, z - 0.5), (0.68, y, z - 0.95)] if free else [(0.52, y, z - 0.1), (0.53, y, 0.6), (0.5, y, 0.06)]
        kit.chain(front, [0.14, 0.075, 0.05], stone)
        kit.chain([(-0.52, y, z - 0.1), (-0.42, y, 0.75), (-0.66, y, 0.48), (-0.6, y, 0.06)], [0.2, 0.11, 0.07, 0.055], stone)
    if rears:
        spin, foot = turn("y", -28), np.array([-0.6, 0, 0.0])
        for i in range(first, len(kit.primitives)):
            p = kit.primitives[i]
            if p.centre[2] > 0.75 or p.centre[0] > 0:
                kit.primitives[i] = p._replace(centre=foot + [0, 0, 0.62] + spin @ (p.centre - foot - [0, 0, 0.62]), rotation=spin @ p.rotation)
    seat = np.array([-0.05, 0, z + 0.36]) + ([-0.14, 0, 0.22] if rears else [0, 0, 0])
    hands = [(0.4, 0.1, 0.15), [(0.35, 0.12, 0.15), (0.4, 0.3, 0.85)][int(kit.chance(0.6))]]
    f = small_rider(kit, stone, seat, hands)
    if kit.chance(0.5):
        kit.between(f + [0, 0, -0.05], f + [0.25, 0, 0.7], (0.03, 0.012), BOX, 0.4, material=stone)
    pedestal(kit, rng.uniform(0.3, 1.9), 0.5, 2.2, stone if kit.chance(0.3) else None)


def small_rider(kit, stone, seat, hands):
    """Somebody astride, of few primitives; returns where the right hand is."""
    seat = np.array(seat)
    kit.add(CYL, seat + [0, 0, 0.25], (0.13, 0.16, 0.27), (1.2, 1), material=stone)
    kit.add(BALL, seat + [0, 0, 0.48], (0.13, 0.22, 0.13), material=stone)
    kit.between(seat + [-0.1, 0, 0.55], seat + [-0.38, 0, -0.1], (0.05, 0.24), BOX, 1.2, material=stone)
    kit.between(seat + [0, 0, 0.5], seat + [0.02, 0, 0.72], 0.06, material=stone)
    kit.add(BALL, seat + [0.02, 0, 0.78], (0.1, 0.085, 0.13), material=stone)
    if kit.chance(0.6):
        kit.add(BOX, seat + [0.02, 0, 0.88], (0.09, 0.2, 0.05), (1.0, 0.4), material=stone)
    for side, reach in zip((1, -1), hands, strict=True):
        kit.chain([seat + [0, side * 0.12, 0.02], seat + [0.32, side * 0.31, -0.2], seat + [0.14, side * 0.32, -0.62]], [0.13, 0.1, 0.07], stone)
        kit.add(BALL, seat + [0.22, side * 0.32, -0.66], (0.14, 0.05, 0.05), material=stone)
        shoulder = seat + [0, side * 0.2, 0.48]
        elbow, wrist = bent(shoulder, seat + np.array(reach) * [1, side, 1], UPPER, FORE, np.array([-0.4, 0.4 * side, -0.6]))
        kit.chain([shoulder, elbow, wrist], [0.07, 0.055, 0.045], stone)
    return wrist


def abstract(kit):
    """Rings, a twisted column, stacked balls or stones, or a pierced form on a base."""
    rng, kind = kit.rng, kit.rng.choice(["rings", "twist", "stack", "arcs", "cubes"])
    made = steel(kit) if kit.chance(0.3) else carved(kit) if kit.chance(0.7) else kit.material(pattern=PLAIN, gloss=0.4)
    if kind == "rings":
        for k in range(int(rng.integers(1, 4))):
            r, thick, spin = 0.9 - 0.27 * k, rng.uniform(0.07, 0.13), turn("z", 60 * k)
            points = [spin @ np.array(p) for p in arc((0, 0, 1.0), r, 0, 360, 18)]
            kit.chain(points, thick, made, joints=False)
        kit.between((0, 0, 0), (0, 0, 1.0 - r), 0.06, material=made)
    elif kind == "twist":
        n, step, taper = 14, rng.uniform(5, 16), rng.uniform(0.3, 1)
        for k in range(n):
            r = 0.36 * (1 - (1 - taper) * k / n)
            kit.add(BOX, (0, 0, 0.09 + 0.18 * k), (r, r * 0.6, 0.092), rotation=turn("z", step * k), material=made)
    elif kind == "stack":
        z = 0.0
        for k in range(int(rng.integers(3, 7))):
            r = 0.5 * rng.uniform(0.6, 1.05) * 0.9**k
            tall = r * rng.uniform(0.5, 1)
            kit.add(BALL, (rng.uniform(-0.04, 0.04), rng.uniform(-0.04, 0.04), z + tall * 0.96), (r, r, tall), material=made if kit.chance(0.6) else carved(kit))
            z += tall * 1.9
    elif kind == "arcs":
        for k in range(3):
            spin = turn("z", 120 * k)
            points = [spin @ np.array(p) for p in arc((0.9, 0, 0), 0.95, 75, 180, 8)]
            points = [p * [1, 1, 1.6] for p in points]
            kit.chain(points[::-1], np.linspace(0.14, 0.05, 8), made)
    else:
        z = 0.0
        for k in range(5):
            h = rng.uniform(0.18, 0.34)
            kit.add(BOX, (rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), z + h), (h, h, h), rotation=turn("z", rng.uniform(0, 90)), material=made)
            z += 2 * h
    pedestal(kit, rng.uniform(0.1, 0.8), 0.6)


def totem(kit):
    rng, wood = kit.rng, kit.material(base=[0.3, 0.18, 0.09], pattern=STREAKS) if kit.chance(0.5) else timber(kit)
    z, r = 0.0, rng.uniform(0.36, 0.46)
    paints = [plain(kit, c) for c in ([0.45, 0.06, 0.04], [0.03, 0.03, 0.03], [0.1, 0.35, 0.3], [0.7, 0.65, 0.5])]
    for k in range(int(rng.integers(3, 5))):
        h, a, b = rng.uniform(0.42, 0.56), paints[rng.integers(4)], paints[(k + 1) % 4]
        kit.add(CYL, (0, 0, z + h), (r, r, h), material=wood)
        kit.add(CYL, (0, 0, z + h * 1.95), (r * 1.06, r * 1.06, 0.05), material=a)
        kit.add(BALL, (r * 0.86, 0.15, z + h * 1.4), (0.1, 0.14, 0.13), material=paints[3], mirror=True)
        kit.add(BALL, (r * 1.02, 0.16, z + h * 1.4), (0.07, 0.07, 0.07), material=paints[1], mirror=True)
        if kit.chance(0.6):
            kit.between((r * 0.8, 0, z + h * 1.2), (r + rng.uniform(0.25, 0.6), 0, z + h * 0.9), (0.17, 0.13), taper=0.3, material=b)
        else:
            kit.add(BOX, (r, 0, z + h * 1.05), (0.15, 0.12, 0.16), (0.5, 0.6), material=b)
        kit.add(BALL, (r * 0.92, 0, z + h * 0.5), (0.1, 0.26, 0.1), material=a)
        kit.add(BALL, (0.1, r * 0.95, z + h * 1.65), (0.1, 0.12, 0.2), material=b, mirror=True)
        z += 2 * h
    if kit.chance(0.7):
        for side in (1, -1):
            kit.between((0, side * r * 0.8, z - 0.45), (-0.05, side * 1.15, z - 0.25), (0.2, 0.06), BOX, 0.6, material=paints[rng.integers(4)])
    kit.add(BALL, (0, 0, z), (r, r, 0.22), material=wood)


def figure_fountain(kit):
    rng, stone = kit.rng, carved(kit)
    water, r = kit.material(base=[0.12, 0.3, 0.36], pattern=PLAIN, gloss=0.5), rng.uniform(1.1, 1.7)
    sides = 8 if kit.chance(0.4) else 0
    kit.add(PRISM if sides else CYL, (0, 0, -0.78), (r, r, 0.22), (1.05, sides or 1), material=stone)
    kit.add(CYL, (0, 0, -0.6), (r * 0.9, r * 0.9, 0.05), material=water)
    kit.loft((0, 0, -0.6), [(0, 0.3), (0.15, 0.2), (0.35, 0.2), (0.5, 0.62), (0.6, 0.65)], stone)
    figure(kit, dress_up(kit, stone), rng.choice(["stand", "rest"]), rng.choice(["raised", "up", "hips", "carry"]), size=rng.uniform(0.7, 1.1))
    for x, y in around(4, r * 0.62, 45):
        kit.add(CYL, (x, y, -0.3), (0.03, 0.03, 0.3), (0.3, 1), material=water)


def grave(kit):
    """A gravestone, a cross, or a Celtic cross, with steps."""
    rng, stone, kind = kit.rng, carved(kit), kit.rng.choice(["slab", "round", "cross", "celtic", "crucifix"])
    steps = int(rng.integers(1, 4))
    carving = stone._replace(pattern=WRITING, frequency=10.0, second=stone.first * 0.4)
    if kind in ("slab", "round"):
        wide, high = rng.uniform(0.3, 0.45), rng.uniform(0.35, 0.6)
        kit.add(BOX, (0, 0, high), (0.09, wide, high), material=stone)
        kit.add(BOX, (0.085, 0, high), (0.012, wide * 0.8, high * 0.7), material=carving)
        if kind == "round":
            kit.add(CYL, (0, 0, 2 * high), (wide, wide, 0.09), rotation=ALONG_X, material=stone)
            kit.add(BALL, (0.08, 0, 2 * high + wide * 0.45), (0.04, 0.1, 0.1), material=stone)
        else:
            kit.add(BOX, (0, 0, 2 * high + 0.015), (0.12, wide * 1.08, 0.06), (0.8, 0.9), material=stone)
        if kit.chance(0.5):
            kit.add(BOX, (0.95, 0, 0.025 - 0.08 * steps), (0.85, wide * 1.1, 0.035 + 0.08 * steps), material=stone)
        for k in range(5 * int(kit.chance(0.5))):
            kit.add(BALL, (0.25, (k - 2) * 0.11, 0.1), (0.07, 0.08, 0.1), material=kit.material(base=paint(rng.choice([0, 0.15, 0.33, 0.9]), 0.8, 0.5), pattern=PLAIN))
    else:
        tall, t = rng.uniform(1.3, 2.0), rng.uniform(0.08, 0.12)
        kit.add(BOX, (0, 0, tall / 2), (t * 0.9, t, tall / 2), (0.85, 0.85), material=stone)
        kit.add(BOX, (0, 0, tall * 0.7), (t * 0.85, tall * 0.27, t * 0.9), material=stone)
        if kind == "celtic":
            kit.chain([np.array([0, p[0], p[2]]) for p in arc((0, 0, tall * 0.7), tall * 0.18, 0, 360, 17)], 0.06, stone, joints=False)
        elif kind == "crucifix":
            christ = dress_up(kit, stone, woman=False)
            figure(kit, christ, hands=[(0.0, 0.62, 0.66)] * 2, at=(0.12, 0, tall * 0.2), size=tall * 0.34, look=turn("y", 20), feet=[(0.03, 0.03, 0.07)] * 2)
    for k in range(steps):
        kit.add(BOX, (0, 0, -0.08 - 0.16 * k), (0.28 + 0.12 * k, 0.5 + 0.12 * k, 0.09), material=stone)


def obelisk(kit):
    rng, stone = kit.rng, carved(kit)
    tall, half = rng.uniform(2.4, 4.2), rng.uniform(0.28, 0.36)
    relief = stone._replace(pattern=rng.choice([WRITING, LEDGES, FACADE]), frequency=rng.uniform(4, 9), second=stone.first * 0.5)
    kit.add(BOX, (0, 0, tall / 2), (half, half, tall / 2), (0.68, 0.68), material=relief if kit.chance(0.6) else stone)
    kit.add(BOX, (0, 0, tall + half * 0.4), (half * 0.68, half * 0.68, half * 0.4), (0.02, 0.02), material=brass(kit) if kit.chance(0.3) else stone)
    for k in range(int(rng.integers(0, 6))):
        z = 0.3 + k * tall * 0.15
        kit.add(BOX, (half * (1 - 0.32 * z / tall), 0, z), (0.03, half * 0.45, 0.12), material=stone)
    high = rng.uniform(0.5, 1.0)
    pedestal(kit, high, half * 1.5, material=stone)
    for k in range(3):
        kit.add(BOX, (0, 0, -high - 0.14 * k), (half * (2 + 0.5 * k), half * (2 + 0.5 * k), 0.16), material=stone)


def sculpture(kit):
    """Statues of people, riders, lions, sphinxes and Buddhas, abstract forms, totem poles, fountains with figures, graves and crosses, obelisks."""
    kit.bevel = max(kit.bevel, 0.2)
    makers = [human_statue, buddha, lion, equestrian, abstract, totem, figure_fountain, grave, obelisk]
    makers[kit.rng.choice(9, p=[0.38, 0.08, 0.1, 0.11, 0.09, 0.06, 0.05, 0.08, 0.05])](kit)
