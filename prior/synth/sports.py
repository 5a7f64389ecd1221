"""People at sport and play: dancers, footballers, climbers, divers, skiers, surfers, swimmers, canoeists."""

from itertools import pairwise

import numpy as np

from .bodies import HIP, Outfit, somebody
from .kit import ALONG_X, ALONG_Y, around, towards, turn
from .layout import BALL, BOX, CYL
from .materials import CAMOUFLAGE, CHECKER, CLOUDY, PLAIN, SPECKLES, STRIPES, WRITING, paint
from .people import skin_material
from .soldiers import box, steel, wooden


def dancer(kit):
    rng = kit.rng
    cloth, arabesque = kit.material(gloss=0.2), kit.chance(0.5)
    outfit = Outfit(kit, top=cloth, bottom=cloth if kit.chance(0.6) else None, hat="bun", bare=(True, True), shoes=cloth)
    outfit.wide = 0.88
    if arabesque:
        somebody(
            kit,
            outfit,
            (0, 0, 0.96),
            turn("y", 28),
            [(0.7, 0.1, 1.75), (0.1, -0.7, 1.45)],
            [(-0.78, 0.1, 1.15), (0.0, -0.05, 0.15)],
            look=turn("y", -10),
            knees=(0.3, 0, -1),
            elbows=(0, 0, -0.3),
            toes=(150, 70),
        )
    else:
        somebody(
            kit,
            outfit,
            (0, 0, 0.98),
            turn("y", -3),
            [(0.1, 0.16, 2.0), (0.15, -0.16, 2.0)],
            [(0.05, 0.1, 0.55), (0.0, -0.04, 0.15)],
            look=turn("y", -5),
            knees=(0.4, 1, 0),
            elbows=(0, 0, 0),
            toes=(70, 75),
        )
    wide = rng.uniform(0.3, 0.42)
    if kit.chance(0.75):
        tilt = turn("y", 18 if arabesque else 0)
        for z, r in ((0.0, 1.0), (0.04, 0.85)):
            kit.add(CYL, (-0.03, 0, 0.99 + z), (wide * r, wide * r, 0.02), (0.6, 1), rotation=tilt, material=cloth)


def footballer(kit):
    rng = kit.rng
    shirt = kit.material(base=paint(rng.random(), rng.uniform(0.5, 1), rng.uniform(0.3, 0.9)), pattern=rng.choice([PLAIN, STRIPES]))
    outfit = Outfit(kit, top=shirt, bottom=kit.material(pattern=PLAIN), hat=rng.choice(["none", "bald", "long", "bun"]), bare=(True, True))
    kick = rng.uniform(0.2, 0.5)
    somebody(
        kit,
        outfit,
        (0, 0, 0.86),
        turn("y", -10) @ turn("z", 20),
        [(0.35, 0.45, 1.25), (-0.4, -0.4, 1.2)],
        [(-0.08, 0.12, 0.07), (0.6, -0.12, kick)],
        look=turn("y", 18),
        toes=(0, -10),
    )
    ball = kit.material(base=[0.85] * 3, pattern=rng.choice([CHECKER, SPECKLES, PLAIN]), frequency=12, second=[0.03] * 3)
    kit.add(BALL, (0.84, -0.13, kick if kick > 0.4 else max(0.12, kick)), (0.12,) * 3, material=ball)
    kit.add(BOX, (-0.2, 0, 1.2), (0.01, 0.07, 0.09), rotation=turn("y", -10) @ turn("z", 20), material=kit.material(base=[0.9] * 3, pattern=WRITING))


def climber(kit):
    """On a wall of rock, with rope, or on a pole."""
    rng = kit.rng
    stone = np.array([0.4, 0.36, 0.32]) * rng.uniform(0.5, 1.4)
    rock = kit.material(base=stone, pattern=CLOUDY, frequency=rng.uniform(3, 8), gloss=0.02, second=stone * 0.6)
    rope = kit.material(base=paint(rng.random(), 0.8, 0.6), pattern=PLAIN)
    outfit = Outfit(kit, hat=rng.choice(["helmet", "none", "bun"]))
    hips = (0, 0, 1.35)
    somebody(
        kit,
        outfit,
        hips,
        turn("y", 5),
        [(0.32, 0.25, 2.25), (0.32, -0.3, 2.0)],
        [(0.27, 0.25, 0.9), (0.27, -0.2, 0.58)],
        look=turn("y", -25),
        knees=(0.2, 0.0, 0.5),
        toes=-20,
    )
    for k in range(6):
        z = 0.26 + 0.45 * k
        kit.add(
            BOX,
            (0.55 + rng.normal(0, 0.03), rng.normal(0, 0.05), z),
            (0.22, rng.uniform(0.5, 0.62), 0.27),
            tuple(rng.uniform(0.9, 1.1, 2)),
            rotation=turn("z", rng.normal(0, 4)),
            material=rock,
        )
    for y, z in ((0.25, 2.22), (-0.3, 1.97), (0.25, 0.86), (-0.2, 0.54)):
        kit.add(BALL, (0.34, y, z), (0.1, 0.09, 0.05), material=rock if kit.chance(0.5) else kit.material())
    kit.chain([(0.12, 0, 1.4), (0.32, 0.05, 2.4), (0.45, 0.05, 2.8)], 0.015, rope, joints=False)
    kit.between((0.08, 0, 1.38), (-0.05, 0.1, 0.0), 0.015, material=rope)
    kit.add(CYL, (0, 0, 1.42), (0.125, 0.165, 0.025), rotation=turn("y", 5), material=kit.material(dark=True))


def diver(kit):
    """Under water with fins, mask and bottle: upright or swimming."""
    rng = kit.rng
    suit, accent, dark = (
        kit.material(base=[0.03, 0.03, 0.04], pattern=PLAIN, gloss=0.2),
        kit.material(base=paint(rng.random(), 0.9, 0.7), pattern=PLAIN),
        kit.material(dark=True),
    )
    outfit = Outfit(kit, top=suit, bottom=suit, shoes=accent, hat="hood", cover=suit, bare=(False, False))
    swims = kit.chance(0.55)
    lean = turn("y", 80) if swims else turn("y", 4)
    hips = np.array([0, 0, 0.5 if swims else HIP])
    hands = [(0.95, 0.25, 0.4), (0.1, -0.28, 0.42)] if swims else None
    feet = [(-0.8, 0.1, 0.62), (-0.82, -0.1, 0.4)] if swims else [(0, 0.13, 0.07), (0, -0.13, 0.07)]
    look = turn("y", 15)
    somebody(
        kit,
        outfit,
        hips,
        lean,
        hands,
        feet,
        look=look,
        knees=(0.2, 0, -1) if swims else (1, 0, 0),
        elbows=(0, 0, -1) if swims else (-0.4, 0, -0.6),
        toes=140 if swims else 0,
    )
    back = hips + lean @ np.array([-0.2, 0, 0.32])
    kit.add(CYL, back, (0.09, 0.09, 0.25), rotation=lean, material=accent)
    kit.add(BALL, back + lean @ np.array([0, 0, 0.25]), (0.09, 0.09, 0.08), rotation=lean, material=accent)
    kit.add(CYL, back + lean @ np.array([0, 0, 0.35]), (0.03, 0.03, 0.06), rotation=lean, material=dark)
    head = hips + lean @ np.array([0.02, 0, 0.72])
    kit.add(CYL, head + look @ np.array([0.085, 0, 0.02]), (0.05, 0.07, 0.03), rotation=look @ ALONG_X, material=kit.material(base=[0.1, 0.25, 0.35], gloss=0.6))
    kit.add(CYL, head + look @ np.array([0.1, 0, -0.07]), (0.03, 0.04, 0.03), rotation=look @ ALONG_X, material=dark)
    kit.chain([head + look @ np.array([0.1, 0, -0.07]), head + look @ np.array([0.0, 0.17, -0.08]), back + lean @ np.array([0, 0, 0.35])], 0.016, dark, joints=False)
    for foot, y in zip(feet, (1, -1), strict=True):
        way = turn("y", 158) if swims else turn("z", y * 8)
        at = np.array(foot) + way @ np.array([0.27, 0, -0.04])
        box(kit, at, (0.24, 0.1, 0.012), accent, way)
    kit.add(BALL, hips + lean @ np.array([0.03, 0, 0.35]), (0.14, 0.19, 0.18), rotation=lean, material=accent if kit.chance(0.5) else dark)


def skier(kit):
    rng = kit.rng
    ski, dark = kit.material(gloss=0.4), kit.material(dark=True)
    crouch = rng.uniform(0, 1)
    hips = (-0.12 * crouch, 0, HIP - 0.05 - 0.22 * crouch)
    outfit = Outfit(kit, hat=rng.choice(["helmet", "cap", "none"]), bare=(False, False), shoes=dark)
    hands = [(0.3, 0.36, hips[2] + 0.25), (0.3, -0.36, hips[2] + 0.25)]
    somebody(kit, outfit, hips, turn("y", 12 + 25 * crouch), hands, [(0, 0.13, 0.16), (0.05, -0.13, 0.16)], look=turn("y", 5), elbows=(-0.8, 0, -0.4))
    for x, y in ((0.1, 0.13), (0.15, -0.13)):
        box(kit, (x, y, 0.03), (0.85, 0.045, 0.012), ski)
        box(kit, (x + 0.93, y, 0.06), (0.1, 0.04, 0.012), ski, turn("y", -24), (1, 0.5))
        box(kit, (x - 0.08, y, 0.06), (0.14, 0.04, 0.03), dark)
        tip = np.array([0.1 - 0.75 * crouch, y * 4.2, 0.06 + 0.4 * crouch])
        hand = np.array(hands[0 if y > 0 else 1])
        kit.between(hand + (hand - tip) * 0.08, tip, 0.012, material=steel(kit))
        kit.add(CYL, tip + (hand - tip) * 0.06, (0.05, 0.05, 0.008), rotation=towards(hand - tip), material=dark)
    head = np.array(hips) + turn("y", 12 + 25 * crouch) @ np.array([0.02, 0, 0.72])
    box(kit, head + [0.085, 0, 0.015], (0.02, 0.07, 0.03), kit.material(dark=True, gloss=0.6))


def surfer(kit):
    """On a surfboard, a skateboard or a paddle board."""
    rng = kit.rng
    what = rng.choice(["surf", "skate", "paddle"])
    suit = kit.material(pattern=PLAIN, gloss=0.1)
    bare = (what != "skate", what != "skate")
    outfit = Outfit(kit, bottom=suit, hat=rng.choice(["none", "bald", "long", "bun"]), bare=bare)
    if what != "skate" and kit.chance(0.5):
        outfit.top = suit if kit.chance(0.5) else outfit.skin
    look = kit.material(pattern=rng.choice([PLAIN, STRIPES, CAMOUFLAGE]), gloss=0.4)
    long, wide, deck = {"surf": (1.0, 0.27, 0.07), "skate": (0.42, 0.11, 0.13), "paddle": (1.5, 0.38, 0.1)}[what]
    if what == "paddle":
        somebody(kit, outfit, (0, 0, HIP + deck - 0.05), turn("y", 12), [(0.35, -0.1, 1.6), (0.4, -0.35, 1.1)], [(0.05, 0.16, 0.07 + deck), (-0.03, -0.16, 0.07 + deck)])
        kit.between((0.34, -0.08, 1.68), (0.55, -0.55, 0.25), 0.014, material=kit.material(dark=True))
        kit.between((0.53, -0.5, 0.4), (0.6, -0.66, 0.0), (0.012, 0.09), BOX, material=look)
    else:
        stance = 0.34 if what == "surf" else 0.27
        feet = [(0.0, stance, 0.07 + deck), (0.0, -stance, 0.07 + deck)]
        low = rng.uniform(0.12, 0.3)
        lean = turn("z", -50) @ turn("y", rng.uniform(10, 28))
        first = len(kit.primitives)
        somebody(
            kit,
            outfit,
            (-0.08, 0, HIP + deck - low),
            lean,
            [(0.25, 0.62, 1.3 + deck - low), (0.05, -0.65, 1.4 + deck - low)],
            feet,
            look=turn("z", 70),
            knees=(1, 0, 0),
            elbows=(0, 0, -1),
        )
        flip = turn("z", -90)
        kit.primitives[first:] = [p._replace(centre=flip @ p.centre, rotation=flip @ p.rotation) for p in kit.primitives[first:]]
    if what == "skate":
        kit.add(BOX, (0, 0, deck - 0.02), (long * 0.6, wide, 0.022), material=look)
        for x in (-1, 1):
            kit.add(CYL, (x * long * 0.6, 0, deck - 0.02), (wide, wide, 0.022), material=look)
        for x in (-0.3, 0.3):
            kit.between((x, 0, 0.035), (x, 0, deck - 0.02), 0.03, BOX, material=steel(kit))
            kit.add(CYL, (x, 0.1, 0.04), (0.04, 0.04, 0.025), rotation=ALONG_Y, material=kit.material(), mirror=True)
    else:
        kit.add(BALL, (0, 0, deck - 0.03), (long, wide, 0.05), material=look)
        kit.add(BALL, (0, 0, deck - 0.025), (long * 0.97, wide * 0.15, 0.05), material=kit.material(pattern=PLAIN))
        box(kit, (-long * 0.8, 0, deck - 0.09), (0.09, 0.01, 0.07), kit.material(dark=True), taper=(0.4, 1))


def swimmer(kit):
    """In a swimming ring or on an air bed."""
    rng = kit.rng
    skin = skin_material(kit)
    outfit = Outfit(kit, top=skin if kit.chance(0.5) else None, skin=skin, hat=rng.choice(["none", "bald", "bun", "cap"]), bare=(True, True), shoes=skin)
    one, two = kit.material(pattern=PLAIN, gloss=0.4), kit.material(base=[0.85] * 3, pattern=PLAIN, gloss=0.4)
    if kit.chance(0.6):
        wide, parts = rng.uniform(0.4, 0.5), 14
        for k, (x, y) in enumerate(around(parts, wide)):
            nx, ny = around(parts, wide)[(k + 1) % parts]
            look = one if k // 2 % 2 else two
            kit.between((x, y, 0.2), (nx, ny, 0.2), 0.14, material=look)
            kit.add(BALL, (x, y, 0.2), (0.14,) * 3, material=look)
        somebody(
            kit,
            outfit,
            (-0.22, 0, 0.27),
            turn("y", -30),
            [(-0.05, 0.5, 0.38), (-0.05, -0.5, 0.38)],
            [(0.62, 0.2, 0.25), (0.65, -0.2, 0.25)],
            look=turn("y", 5),
            knees=(0, 0, 1),
            elbows=(-0.4, 0, -0.4),
            toes=-50,
        )
        return
    for k in range(6):
        kit.between((-1.0, (k - 2.5) * 0.13, 0.09), (0.9, (k - 2.5) * 0.13, 0.09), (0.08, 0.075), material=one if k % 2 else two)
    kit.between((-0.95, -0.36, 0.17), (-0.95, 0.36, 0.17), 0.11, material=one)
    somebody(
        kit,
        outfit,
        (-0.1, 0, 0.28),
        turn("y", -84),
        [(-0.2, 0.36, 0.22), (-0.98, -0.18, 0.42)],
        [(0.74, 0.12, 0.22), (0.72, -0.14, 0.22)],
        look=turn("y", -75),
        knees=(0, 0, 1),
        elbows=(0, 0, 0.2),
        toes=-75,
    )


def canoe(kit):
    """In a canoe, a kayak or a rowing boat, with a paddle."""
    rng = kit.rng
    hull, inside, dark = kit.material(gloss=0.4), wooden(kit), kit.material(dark=True)
    kayak, pair = kit.chance(0.45), kit.chance(0.35)
    long, wide, high = rng.uniform(1.7, 2.3), 0.3 if kayak else 0.38, 0.17 if kayak else 0.2
    if kayak:
        kit.add(BALL, (0, 0, high), (long, wide, high), material=hull)
        kit.add(BALL, (0, 0, 1.5 * high), (long * 0.97, wide * 0.75, high * 0.6), material=kit.material(gloss=0.4) if kit.chance(0.5) else hull)
        kit.add(CYL, (0.02, 0, 2 * high - 0.01), (0.36, 0.22, 0.05), material=dark)
    else:
        kit.add(BALL, (0, 0, high), (long * 0.97, wide * 0.9, high), material=hull)
        cuts = ((0, 1.0), (0.4, 0.94), (0.75, 0.6), (1.0, 0.05))
        for (x0, y0), (x1, y1) in pairwise(cuts):
            for way in (1, -1):
                half = ((x1 - x0) * long / 2 + 0.02, 0.1 + 0.05 * x0)
                kit.add(
                    BOX,
                    (way * (x0 + x1) * long / 2, 0, 1.5 * high + 0.06 * x1),
                    (half[1], wide * y0, half[0]),
                    (1.15, y1 / y0),
                    rotation=turn("y", 90 * way),
                    material=hull,
                )
        kit.add(BOX, (0, 0, 2 * high + 0.01), (long * 0.4, wide * 0.84, 0.015), material=dark)
        kit.between((0, wide * 0.97, 2 * high + 0.01), (long * 0.4, wide * 0.91, 2 * high + 0.02), 0.02, BOX, material=inside, mirror=True)
        kit.between((0, wide * 0.97, 2 * high + 0.01), (-long * 0.4, wide * 0.91, 2 * high + 0.02), 0.02, BOX, material=inside, mirror=True)
        for x in (-0.5, 0.75):
            box(kit, (x, 0, 2 * high + 0.01), (0.09, wide * 0.95, 0.02), inside)
    for k in range(2 if pair and not kayak else 1):
        x = (-0.55 + 1.25 * k) if pair and not kayak else -0.1
        seat = 2 * high + 0.06
        hands = [(0.42, 0.25, seat + 0.55), (0.42, -0.3, seat + 0.3)]
        outfit = Outfit(kit, hat=rng.choice(["helmet", "cap", "brim", "none"]))
        somebody(kit, outfit, (0, 0, seat), turn("y", 8), hands, [(0.62, 0.14, seat - 0.02), (0.62, -0.14, seat - 0.02)], (x, 0, 0), knees=(0.2, 0, 1), small=True)
        upper = np.array([x + 0.42, 0.25, seat + 0.55])
        lower = np.array([x + 0.42, -0.3, seat + 0.3])
        along = (lower - upper) / np.linalg.norm(lower - upper)
        start = upper - along * (0.6 if kayak else 0.08)
        kit.between(start, lower + along * 0.45, 0.016, material=inside)
        for end, way in ((lower + along * 0.4, 1), (start + along * 0.05, -1))[: 2 if kayak else 1]:
            kit.between(end, end + along * way * 0.38, (0.015, 0.08), BOX, 0.8, material=hull if kit.chance(0.5) else inside)
        kit.add(
            BALL,
            (x + 0.05, 0, seat + 0.33),
            (0.16, 0.2, 0.2),
            rotation=turn("y", 8),
            material=kit.material(base=paint(rng.choice([0.0, 0.05, 0.15, 0.6]), 0.9, 0.8), pattern=PLAIN),
        )
