"""Makers of people at work, at play and in arms: with rifles and crews, at tables, with prams, dogs, umbrellas, ropes, skis, boards, boats."""

from itertools import pairwise

import numpy as np

from .kit import ALONG_X, ALONG_Y, around, towards, turn
from .layout import BALL, BOX, CYL, SPOKES, TUBE
from .materials import CAMOUFLAGE, CHECKER, CLOUDY, DOTS, PLAIN, PLANKS, SPECKLES, STREAKS, STRIPES, WRITING, paint
from .people import hair_material, skin_material

THIGH, SHIN, UPPER, FORE = 0.43, 0.42, 0.29, 0.27  # lengths in metres of somebody 1.75 m tall
HIP, SHOULDER = 0.9, 0.52  # above the ground, and above the hips


class Outfit:
    """What somebody wears, drawn at random but for what is given."""

    def __init__(self, kit, top=None, bottom=None, shoes=None, hat=None, cover=None, skirt=False, bare=None, skin=None, hair=None):
        rng = kit.rng
        self.skin = skin or skin_material(kit)
        self.hair = hair or hair_material(kit)
        self.top = top or kit.material(pattern=rng.choice([PLAIN, PLAIN, STRIPES, CHECKER, CLOUDY]), frequency=rng.uniform(6, 16), gloss=0.05)
        self.bottom = bottom or kit.material(pattern=rng.choice([PLAIN, PLAIN, CLOUDY]), gloss=0.05)
        self.shoes = shoes or kit.material(dark=kit.chance(0.7))
        self.hat = rng.choice(["none", "none", "long", "cap", "brim", "bun"]) if hat is None else hat
        self.cover = cover or kit.material(pattern=PLAIN)
        self.skirt = skirt
        self.bare = (kit.chance(0.35), kit.chance(0.15)) if bare is None else bare  # forearms, shins
        self.wide = rng.uniform(0.9, 1.15)


def bent(start, end, first, second, hint):
    """The joint between two bones, towards `hint`, and where their end comes to lie."""
    away = end - start
    far = max(np.linalg.norm(away), 1e-6)
    away = away / far
    far = np.clip(far, abs(first - second) + 0.01, first + second - 0.004)
    along = (first**2 - second**2 + far**2) / (2 * far)
    side = hint - away * (hint @ away)
    side = side / max(np.linalg.norm(side), 1e-6)
    return start + along * away + np.sqrt(max(first**2 - along**2, 0)) * side, start + far * away


def somebody(
    kit,
    outfit,
    hips=(0, 0, HIP),
    lean=None,
    hands=None,
    feet=None,
    at=(0, 0, 0),
    yaw=0,
    size=1.0,
    look=None,
    knees=(1, 0, 0),
    elbows=(-0.4, 0, -0.6),
    toes=0,
    small=False,
):
    """A body of about 28 primitives (`small`: 22) that looks along x, turned by `yaw`: hips, hands and feet (left, right) where they are told to be."""
    rng = kit.rng
    spin, at = turn("z", yaw), np.array(at, float)
    trunk = turn("y", rng.uniform(0, 5)) if lean is None else lean
    hips = np.array(hips, float)
    wide = outfit.wide
    hands = [(rng.uniform(-0.05, 0.12), y * rng.uniform(0.24, 0.3), hips[2] - 0.04) for y in (1, -1)] if hands is None else hands
    feet = [(rng.uniform(-0.05, 0.08), 0.12, 0.07), (rng.uniform(-0.05, 0.08), -0.12, 0.07)] if feet is None else feet
    facing = turn("z", rng.normal(0, 12)) @ turn("y", rng.normal(4, 5)) if look is None else look

    def place(p):
        return at + spin @ np.array(p, float) * size

    def part(kind, p, half, material, frame=trunk, taper=(1, 1)):
        kit.add(kind, place(p), np.array(half) * size, taper, rotation=spin @ frame, material=material)

    def limb(start, end, radius, taper, material):
        kit.between(place(start), place(end), radius * size, CYL, taper, material)

    def high(x, y, z):
        return hips + trunk @ np.array([x, y, z])

    part(BALL, high(0, 0, 0.03), (0.12, 0.165 * wide, 0.13), outfit.bottom)
    part(CYL, high(0, 0, 0.2), (0.1 * wide, 0.14 * wide, 0.17), outfit.top, taper=(1.12, 1))
    part(BALL, high(0.01, 0, 0.38), (0.125 * wide, 0.18 * wide, 0.17), outfit.top)
    part(BALL, high(0, 0, 0.5), (0.075, 0.2 * wide, 0.065), outfit.top)
    head = high(0.02, 0, 0.72)
    for foot, side in zip(feet, (1, -1), strict=True):
        joint = high(0, side * 0.085 * wide, -0.02)
        knee, ankle = bent(joint, np.array(foot, float), THIGH, SHIN, np.array(knees) + [0, 0.15 * side, 0])
        limb(joint, knee, 0.088 * wide, 0.72, outfit.bottom)
        if not small:
            part(BALL, knee, (0.064 * wide,) * 3, outfit.bottom)
        limb(knee, ankle, 0.062 * wide, 0.66, outfit.skin if outfit.bare[1] else outfit.bottom)
        tread = turn("z", side * rng.uniform(2, 15)) @ turn("y", toes if np.isscalar(toes) else toes[0 if side == 1 else 1])
        part(BALL, ankle + tread @ np.array([0.06, 0, -0.025]), (0.135, 0.05, 0.048), outfit.shoes, tread)
    for hand, side in zip(hands, (1, -1), strict=True):
        shoulder = high(0, side * 0.19 * wide, SHOULDER - 0.03)
        elbow, wrist = bent(shoulder, np.array(hand, float), UPPER, FORE, np.array(elbows) + [0, 0.5 * side, 0])
        limb(shoulder, elbow, 0.055 * wide, 0.8, outfit.top)
        if not small:
            part(BALL, elbow, (0.044 * wide,) * 3, outfit.top)
        limb(elbow, wrist, 0.043 * wide, 0.7, outfit.skin if outfit.bare[0] else outfit.top)
        part(BALL, wrist, (0.05, 0.038, 0.05), outfit.skin, np.eye(3))
    limb(high(0, 0, 0.5), head - facing @ np.array([0.01, 0, 0.06]), 0.052, 1, outfit.skin)

    def on_head(kind, p, half, material, taper=(1, 1)):
        part(kind, head + facing @ np.array(p), half, material, facing, taper)

    on_head(BALL, (0, 0, 0), (0.092, 0.075, 0.115), outfit.skin)
    dressed(kit, outfit, on_head)
    on_head(CYL, (0.092, 0, -0.015), (0.014, 0.016, 0.024), outfit.skin, (0.4, 1))
    if outfit.skirt:
        long = rng.uniform(0.2, 0.38)
        part(CYL, hips + [0, 0, 0.08 - long], (0.21, 0.24 * wide, long), outfit.bottom, np.eye(3), (0.6, 1))
    if not small:
        dark = kit.material(base=[0.03, 0.02, 0.02], pattern=PLAIN)
        for y in (0.03, -0.03):
            on_head(BALL, (0.08, y, 0.015), (0.012, 0.014, 0.011), dark)
    return place


def dressed(kit, outfit, on_head):
    """Hair, a helmet or a hat."""
    hat = outfit.hat
    if hat == "bald":
        return
    if hat == "helmet":
        on_head(BALL, (-0.01, 0, 0.045), (0.13, 0.115, 0.1), outfit.cover)
        on_head(CYL, (0.0, 0, 0.03), (0.14, 0.122, 0.012), outfit.cover)
    elif hat == "hood":
        on_head(BALL, (-0.025, 0, 0.01), (0.1, 0.098, 0.14), outfit.cover)
    elif hat in ("cap", "brim"):
        on_head(BALL, (-0.02, 0, 0.01), (0.092, 0.085, 0.1), outfit.hair)
        on_head(CYL, (-0.005, 0, 0.085), (0.105, 0.092, 0.045), outfit.cover, (0.85, 1))
        wide = (0.085, 0.075) if hat == "cap" else (0.18, 0.165)
        on_head(CYL, (0.075 if hat == "cap" else 0, 0, 0.05), (*wide, 0.008), outfit.cover)
    else:
        on_head(BALL, (-0.02, 0, 0.035), (0.097, 0.085, 0.1), outfit.hair)
        if hat == "long":
            on_head(BALL, (-0.06, 0, -0.08), (0.06, 0.09, 0.15), outfit.hair)
        elif hat == "bun":
            on_head(BALL, (-0.11, 0, 0.06), (0.05, 0.05, 0.05), outfit.hair)


def steel(kit):
    return kit.material(base=kit.rng.uniform(0.1, 0.65) * np.ones(3), pattern=PLAIN, gloss=kit.rng.uniform(0.1, 0.5))


def wooden(kit):
    brown = np.array([0.4, 0.26, 0.14]) * kit.rng.uniform(0.35, 1.5)
    return kit.material(base=brown, pattern=kit.rng.choice([PLANKS, STREAKS, PLAIN]), gloss=0.15, second=brown * 0.6)


def box(kit, centre, half, material=None, rotation=None, taper=(1, 1), mirror=False, cut=(0, 1, 1)):
    kit.add(BOX, centre, half, taper, rotation=rotation, material=material, mirror=mirror, cut=cut)


def uniform(kit, **more):
    """A soldier's outfit: of one cloth, with helmet."""
    rng = kit.rng
    base = np.array([0.2, 0.19, 0.11]) * rng.uniform(0.3, 1.8) if kit.chance(0.8) else np.array([0.3, 0.3, 0.3]) * rng.uniform(0.3, 1.6)
    cloth = kit.material(
        base=base, pattern=CAMOUFLAGE if kit.chance(0.7) else PLAIN, frequency=rng.uniform(10, 22), gloss=0.02, second=base * rng.uniform(0.3, 1.7) + 0.02
    )
    hat = rng.choice(["helmet", "helmet", "helmet", "cap", "hood"])
    return Outfit(
        kit, top=cloth, bottom=cloth, shoes=kit.material(dark=True), hat=more.pop("hat", hat), cover=cloth if kit.chance(0.7) else None, bare=(False, False), **more
    )


def rifle(kit, butt, muzzle, size=1.0):
    """Stock, body, magazine, barrel and sight between two points."""
    butt, muzzle = np.array(butt, float), np.array(muzzle, float)
    along, dark = muzzle - butt, kit.material(dark=True)
    frame = towards(along)
    stock = wooden(kit) if kit.chance(0.4) else dark

    def point(share, drop):
        return butt + share * along + frame @ np.array([1, 0, 0]) * drop * size * (-1 if frame[2, 0] > 0 else 1)

    kit.between(point(0, 0.02), point(0.33, 0), (0.045 * size, 0.018), BOX, 0.7, material=stock)
    kit.between(point(0.3, 0), point(0.7, 0), (0.033 * size, 0.022), BOX, material=dark)
    kit.between(point(0.68, 0), muzzle, 0.012, material=dark)
    kit.between(point(0.48, 0.02), point(0.53, 0.16), (0.03 * size, 0.014), BOX, material=dark)
    kit.between(point(0.35, 0.02), point(0.31, 0.12), (0.02, 0.015), BOX, material=stock)
    if kit.chance(0.5):
        kit.between(point(0.4, -0.06), point(0.58, -0.06), 0.02, material=dark)


def pack(kit, place, hips, lean, cloth):
    """A backpack with a roll, on the back of a trunk."""
    back = np.array(hips) + lean @ np.array([-0.22, 0, 0.33])
    box(kit, place(back), (0.1, 0.16, kit.rng.uniform(0.17, 0.26)), cloth, lean, (0.9, 0.9))
    kit.add(CYL, place(np.array(hips) + lean @ np.array([-0.2, 0, 0.58])), (0.075, 0.075, 0.2), rotation=lean @ ALONG_Y, material=cloth)
    box(kit, place(np.array(hips) + lean @ np.array([-0.33, 0, 0.28])), (0.035, 0.11, 0.09), cloth, lean)


def rifleman(kit):
    """Standing, walking, kneeling or prone, with the rifle at the shoulder or across the chest."""
    rng = kit.rng
    outfit, pose = uniform(kit), rng.choice(["stand", "stand", "walk", "kneel", "prone"])
    aims = pose == "prone" or kit.chance(0.6)
    if pose == "prone":
        lean, hips = turn("y", 76), (0, 0, 0.14)
        somebody(
            kit,
            outfit,
            hips,
            lean,
            [(0.98, 0.04, 0.3), (0.74, -0.12, 0.27)],
            [(-0.85, 0.3, 0.07), (-0.87, -0.25, 0.07)],
            look=turn("y", 5),
            knees=(0, 0, -1),
            elbows=(0.2, 0, -1),
            toes=60,
        )
        rifle(kit, (0.5, -0.14, 0.33), (1.5, 0.02, 0.34))
        for y in (-0.1, 0.1):
            kit.between((1.32, 0, 0.33), (1.36, y, 0.0), 0.01, material=outfit.shoes)
        if kit.chance(0.4):
            box(kit, (0.25, 0, 0.36), (0.2, 0.15, 0.1), outfit.cover, turn("y", -14))
        if kit.chance(0.5):
            for k in range(5):
                kit.add(
                    BALL,
                    (1.3, (k % 3 - 1) * 0.36 + 0.18 * (k > 2), 0.08 + 0.12 * (k > 2)),
                    (0.13, 0.22, 0.085),
                    material=kit.material(base=[0.4, 0.33, 0.2], pattern=PLAIN),
                )
        return
    hips, feet = (0, 0, HIP), [(0.16, 0.15, 0.07), (-0.16, -0.16, 0.07)]
    if pose == "walk":
        hips, feet = (0, 0, HIP - 0.04), [(0.32, 0.1, 0.07), (-0.34, -0.1, 0.12)]
    elif pose == "kneel":
        hips, feet = (0, 0, 0.5), [(0.38, 0.14, 0.07), (-0.4, -0.14, 0.09)]
    lean = turn("z", -25 if aims else 0) @ turn("y", rng.uniform(4, 12))
    up = hips[2] + SHOULDER
    ahead = 0.06 if pose == "walk" else 0.04
    if aims:
        hands, gun = [(0.55, 0.02, up - 0.03), (0.3, -0.13, up - 0.08)], ((ahead + 0.02, -0.16, up - 0.01), (1.0, 0.02, up + 0.03))
    else:
        hands, gun = [(0.3, 0.14, up - 0.14), (0.2, -0.13, up - 0.36)], ((0.17, -0.32, up - 0.46), (0.33, 0.36, up + 0.08))
    place = somebody(
        kit,
        outfit,
        hips,
        lean,
        hands,
        feet,
        look=turn("y", 4),
        knees=(1, 0, 0.4) if pose == "kneel" else (1, 0, 0),
        elbows=(0.1, 0, -1),
        toes=(0, 50) if pose == "kneel" else (0, 15),
    )
    rifle(kit, *gun)
    if kit.chance(0.55):
        pack(kit, place, hips, lean, outfit.cover)
    chest = np.array(hips) + lean @ np.array([0.03, 0, 0.33])
    vest = outfit.cover if kit.chance(0.5) else kit.material(base=np.array([0.15, 0.15, 0.1]) * rng.uniform(0.5, 2))
    kit.add(BALL, place(chest), (0.15, 0.19, 0.2), rotation=lean, material=vest)
    for y in (-0.09, 0.0, 0.09):
        box(kit, place(chest + lean @ np.array([0.13, y, -0.1])), (0.035, 0.038, 0.06), vest, lean)


def gun_crew(kit):
    """Two at a machine gun on a tripod, behind sandbags."""
    rng = kit.rng
    dark, metal = kit.material(dark=True), steel(kit)
    top = np.array([0.75, 0, 0.55])
    kit.between(top - [0.25, 0, 0], top + [0.2, 0, 0], (0.06, 0.045), BOX, material=dark)
    kit.between(top + [0.2, 0, 0.01], top + [0.8, 0, 0.03], 0.03 if kit.chance(0.5) else 0.045, material=metal)
    kit.between(top - [0.25, 0, 0], top - [0.36, 0, 0], (0.07, 0.02), BOX, material=dark)
    for end in ((1.15, 0.3, 0.02), (1.15, -0.3, 0.02), (0.35, 0, 0.02)):
        kit.between(top - [0, 0, 0.06], end, 0.018, material=metal)
    box(kit, top + [-0.02, 0.15, -0.05], (0.08, 0.07, 0.08), dark)
    cloth = uniform(kit)
    feet = [(0.36, 0.16, 0.07), (-0.4, -0.16, 0.09)]
    somebody(
        kit,
        cloth,
        (0, 0, 0.45),
        turn("y", 16),
        [(0.44, 0.07, 0.6), (0.44, -0.07, 0.6)],
        feet,
        look=turn("y", 5),
        knees=(1, 0, 0.4),
        elbows=(0, 0, -1),
        toes=(0, 50),
        small=True,
    )
    cloth.hat = "helmet"
    where = (0.3, 0.62, 0)
    somebody(
        kit,
        cloth,
        (0, 0, 0.45),
        turn("y", 18),
        [(0.45, 0.0, 0.5), (0.42, -0.32, 0.5)],
        feet,
        where,
        rng.uniform(-25, 0),
        look=turn("y", 8),
        knees=(1, 0, 0.4),
        elbows=(0, 0, -1),
        toes=(0, 50),
        small=True,
    )
    bag = kit.material(base=np.array([0.4, 0.33, 0.2]) * rng.uniform(0.5, 1.4), pattern=CLOUDY)
    for k in range(9):
        row = k // 5
        kit.add(BALL, (1.3, (k % 5 - 1.6) * 0.4 + 0.2 * row, 0.09 + 0.15 * row), (0.15, 0.24, 0.1), material=bag)


def mortar_crew(kit):
    """Two at a mortar: one drops the round, the other steadies the tube."""
    metal, cloth = kit.material(base=[0.1, 0.11, 0.08], pattern=PLAIN, gloss=0.2), uniform(kit)
    muzzle = np.array([0.38, 0, 1.0])
    kit.between((0, 0, 0.06), muzzle, 0.065, material=metal)
    kit.add(CYL, (-0.02, 0, 0.03), (0.25, 0.25, 0.03), material=metal)
    kit.between(muzzle * [0.8, 1, 0.8], (0.6, 0.26, 0.02), 0.02, material=metal, mirror=True)
    kit.between((0.47, -0.14, 0.4), (0.47, 0.14, 0.4), 0.015, material=metal)
    somebody(
        kit,
        cloth,
        (0, 0, 0.5),
        turn("y", 12),
        [(0.42, 0.1, 0.78), (0.36, -0.1, 0.6)],
        [(0.34, 0.15, 0.07), (-0.4, -0.15, 0.09)],
        (0.0, -0.6, 0),
        70,
        look=turn("y", 4),
        knees=(1, 0, 0.4),
        toes=(0, 50),
        small=True,
    )
    cloth.hat = "helmet"
    somebody(
        kit,
        cloth,
        (0, 0, 0.85),
        turn("y", 14),
        [(0.42, 0.1, 1.18), (0.45, -0.05, 1.2)],
        [(0.15, 0.15, 0.07), (-0.12, -0.16, 0.07)],
        (0.2, 0.62, 0),
        -75,
        look=turn("y", 15),
        small=True,
    )
    kit.between((0.37, 0.15, 1.3), (0.37, 0.1, 1.0), 0.045, taper=0.6, material=kit.material(base=[0.2, 0.2, 0.08]))
    box(kit, (-0.5, 0.3, 0.14), (0.3, 0.18, 0.14), kit.material(base=[0.16, 0.17, 0.09], pattern=PLANKS))
    for y in (0.2, 0.4):
        kit.between((-0.75, y, 0.33), (-0.3, y, 0.33), 0.045, taper=0.6, material=metal)


def radio_operator(kit):
    cloth, lean = uniform(kit), turn("y", 6)
    hips = (0, 0, HIP) if kit.chance(0.5) else (0, 0, 0.5)
    feet = [(0.08, 0.13, 0.07), (-0.05, -0.13, 0.07)] if hips[2] > 0.8 else [(0.38, 0.14, 0.07), (-0.4, -0.14, 0.09)]
    ear = hips[2] + 0.7
    place = somebody(
        kit,
        cloth,
        hips,
        lean,
        [(0.3, 0.12, hips[2] + 0.25), (0.1, -0.13, ear - 0.04)],
        feet,
        look=turn("y", 6),
        knees=(1, 0, 0.4),
        elbows=(0.4, 0, -0.8),
        toes=0 if hips[2] > 0.8 else (0, 50),
    )
    dark, green = kit.material(dark=True), kit.material(base=[0.14, 0.16, 0.09], pattern=PLAIN)
    box(kit, place((-0.25, 0, hips[2] + 0.33)), (0.11, 0.17, 0.22), green, lean)
    box(kit, place((-0.25, 0, hips[2] + 0.56)), (0.09, 0.15, 0.02), dark, lean)
    kit.between((-0.25, 0.12, hips[2] + 0.5), (-0.3, 0.14, hips[2] + kit.rng.uniform(1.2, 1.9)), 0.01, material=dark)
    kit.between((0.11, -0.1, ear - 0.1), (0.06, -0.1, ear + 0.06), 0.025, BOX, material=dark)
    kit.chain([(0.1, -0.12, ear - 0.1), (0.05, -0.25, hips[2] + 0.3), (-0.2, -0.15, hips[2] + 0.25)], 0.01, dark, joints=False)
    box(kit, place((0.32, 0.05, hips[2] + 0.26)), (0.08, 0.11, 0.01), kit.material(base=[0.75, 0.72, 0.6], pattern=WRITING))


def chair(kit, look, x=-0.05, seat=0.45):
    box(kit, (x, 0, seat - 0.03), (0.22, 0.22, 0.025), look)
    for dx in (-0.19, 0.19):
        box(kit, (x + dx, 0.19, seat / 2 - 0.03), (0.02, 0.02, seat / 2 - 0.03), look, mirror=True)
    box(kit, (x - 0.21, 0, seat + 0.28), (0.02, 0.21, 0.16), look)
    box(kit, (x - 0.21, 0.19, seat + 0.1), (0.02, 0.02, 0.32), look, mirror=True)


SEATED = [(0.42, 0.12, 0.07), (0.4, -0.12, 0.07)]


def at_table(kit):
    """At a table with a meal or papers, or at a desk with a computer."""
    rng = kit.rng
    desk, look, dark = kit.chance(0.5), wooden(kit) if kit.chance(0.7) else kit.material(), kit.material(dark=True)
    somebody(kit, Outfit(kit), (-0.05, 0, 0.53), turn("y", rng.uniform(4, 12)), [(0.42, 0.15, 0.79), (0.4, -0.17, 0.79)], SEATED, look=turn("y", 8))
    chair(kit, wooden(kit) if kit.chance(0.6) else kit.material())
    box(kit, (0.65, 0, 0.73), (0.4, 0.7, 0.025), look)
    if desk:
        box(kit, (0.65, 0.66, 0.36), (0.36, 0.02, 0.36), look, mirror=True)
        if kit.chance(0.5):
            box(kit, (0.65, -0.45, 0.45), (0.34, 0.2, 0.26), look)
            for z in (0.33, 0.52):
                box(kit, (0.3, -0.45, z), (0.012, 0.17, 0.07), look)
        box(kit, (0.44, 0, 0.765), (0.08, 0.22, 0.01), dark)
        screen = kit.material(base=[0.2, 0.35, 0.6], pattern=WRITING, gloss=0.3, second=[0.7, 0.75, 0.8])
        box(kit, (0.82, 0, 1.05), (0.02, 0.3, 0.19), dark)
        box(kit, (0.797, 0, 1.055), (0.004, 0.28, 0.165), screen)
        box(kit, (0.84, 0, 0.83), (0.02, 0.04, 0.1), dark)
        box(kit, (0.82, 0, 0.76), (0.1, 0.12, 0.01), dark)
        if kit.chance(0.5):
            box(kit, (0.75, 0.5, 0.95), (0.2, 0.08, 0.2), dark)
    else:
        for x in (0.3, 1.0):
            box(kit, (x, 0.62, 0.36), (0.03, 0.03, 0.36), look, mirror=True)
        white = kit.material(base=[0.8] * 3, pattern=PLAIN, gloss=0.3)
        kit.add(CYL, (0.5, 0, 0.765), (0.13, 0.13, 0.012), (1.15, 1), material=white)
        kit.add(BALL, (0.5, 0, 0.78), (0.08, 0.09, 0.035), material=kit.material())
        kit.add(CYL, (0.62, 0.25, 0.81), (0.035, 0.035, 0.055), material=kit.material())
        kit.loft((0.7, -0.2, 0.755), [(0, 0.04), (0.16, 0.04), (0.22, 0.015), (0.29, 0.015)], kit.material(gloss=0.5))
        box(kit, (0.75, 0.4, 0.765), (0.14, 0.1, 0.01), kit.material(base=[0.8, 0.78, 0.7], pattern=WRITING))


def wheelbarrow(kit):
    metal, tray, dark = steel(kit), kit.material(pattern=PLAIN, gloss=0.2), kit.material(dark=True)
    grip = np.array([0.3, 0.29, 0.72])
    somebody(kit, Outfit(kit), (-0.05, 0, HIP - 0.04), turn("y", 12), [grip, grip * [1, -1, 1]], [(0.2, 0.12, 0.07), (-0.35, -0.12, 0.1)], toes=(0, 25))
    kit.between(grip, (1.45, 0.09, 0.22), 0.022, material=metal, mirror=True)
    kit.add(CYL, (1.45, 0, 0.2), (0.2, 0.2, 0.045), rotation=ALONG_Y, material=dark)
    kit.add(CYL, (1.45, 0, 0.2), (0.09, 0.09, 0.06), rotation=ALONG_Y, material=metal)
    box(kit, (1.0, 0, 0.6), (0.26, 0.22, 0.14), tray, turn("y", 8), (1.55, 1.4))
    kit.chain([(0.75, 0.2, 0.48), (0.7, 0.22, 0.08)], 0.02, metal, mirror=True, joints=False)
    heap = kit.material(base=np.array([0.3, 0.2, 0.1]) * kit.rng.uniform(0.4, 2), pattern=SPECKLES)
    if kit.chance(0.7):
        kit.add(BALL, (1.0, 0, 0.72), (0.34, 0.26, kit.rng.uniform(0.1, 0.25)), material=heap)


def pram(kit):
    cloth, metal, dark = kit.material(pattern=kit.rng.choice([PLAIN, DOTS, CHECKER])), steel(kit), kit.material(dark=True)
    bar = (0.36, 0.16, 1.02)
    somebody(
        kit, Outfit(kit, skirt=kit.chance(0.4)), (-0.05, 0, HIP - 0.02), turn("y", 6), [bar, (0.36, -0.16, 1.02)], [(0.18, 0.1, 0.07), (-0.28, -0.1, 0.1)], toes=(0, 25)
    )
    kit.between((0.36, -0.22, 1.02), (0.36, 0.22, 1.02), 0.018, material=dark)
    kit.between((0.36, 0.22, 1.02), (1.25, 0.22, 0.2), 0.015, material=metal, mirror=True)
    kit.between((0.6, 0.22, 0.2), (1.1, 0.22, 0.6), 0.015, material=metal, mirror=True)
    for x in (0.6, 1.25):
        kit.add(CYL, (x, 0.25, 0.17), (0.17, 0.17, 0.02), rotation=ALONG_Y, material=dark, mirror=True, cut=(SPOKES, 8, 0.3))
    box(kit, (0.95, 0, 0.66), (0.3, 0.18, 0.14), cloth, taper=(1.3, 1.15))
    hood = (1.12 if kit.chance(0.5) else 0.72, 0, 0.82)
    kit.add(BALL, hood, (0.24, 0.22, 0.26), material=cloth)
    box(kit, (0.93, 0, 0.81), (0.28, 0.19, 0.03), kit.material())


def umbrella(kit):
    cloth = kit.material(pattern=kit.rng.choice([PLAIN, PLAIN, DOTS, STRIPES]))
    walk = kit.chance(0.5)
    feet = [(0.2, 0.1, 0.07), (-0.25, -0.1, 0.1)] if walk else None
    somebody(kit, Outfit(kit, skirt=kit.chance(0.4)), (0, 0, HIP - 0.03 * walk), hands=[(0.0, 0.28, 0.86), (0.24, -0.16, 1.22)], feet=feet, elbows=(0, 0, -1))
    tip = np.array([0.1, -0.08, 2.15])
    kit.between((0.25, -0.16, 1.1), tip, 0.012, material=kit.material(dark=True))
    lean = towards(tip - np.array([0.25, -0.16, 1.1]))
    wide = kit.rng.uniform(0.48, 0.65)
    for z, r, top in ((-0.22, 1.0, 0.86), (-0.12, 0.86, 0.55), (-0.05, 0.55, 0.05)):
        kit.add(
            TUBE if z < -0.1 else CYL, tip + lean @ np.array([0, 0, z]), (wide * r, wide * r, 0.05 if z < -0.06 else 0.03), (top / r, 1), rotation=lean, material=cloth
        )
    if kit.chance(0.4):
        box(kit, (0.02, 0.3, 0.66), (0.16, 0.05, 0.14), kit.material())


def carrying(kit):
    """A box, a barrel, a ladder or a sack."""
    rng = kit.rng
    what, metal = rng.choice(["box", "barrel", "ladder", "sack", "bags"]), steel(kit)
    half = rng.uniform(0.12, 0.2)
    hands = {
        "ladder": [(0.16, 0.28, 0.95), (0.2, -0.2, 1.33)],
        "sack": [(0.2, 0.15, 1.3), (0.12, -0.2, 1.55)],
        "bags": [(0.05, 0.3, 0.82), (0.05, -0.3, 0.82)],
    }.get(what, [(0.36, half + 0.06, 1.03), (0.36, -half - 0.06, 1.03)])
    somebody(
        kit, Outfit(kit), (0, 0, HIP - 0.03), turn("y", -5 if what == "box" else 8), hands, [(0.2, 0.12, 0.07), (-0.22, -0.12, 0.1)], elbows=(-0.6, 0, -0.6), toes=(0, 20)
    )
    if what == "box":
        card = kit.material(base=[0.45, 0.3, 0.16], pattern=rng.choice([PLAIN, WRITING, PLANKS]))
        for k in range(int(rng.integers(1, 3))):
            box(kit, (0.38, 0, 1.05 + half * 0.4 + 1.9 * half * k), (half * 1.1, half + 0.08, half * 0.95), card)
    elif what == "barrel":
        kit.loft((0.4, 0, 0.9), [(0, 0.16), (0.2, 0.2), (0.4, 0.16)], wooden(kit))
        for z in (0.98, 1.22):
            kit.add(CYL, (0.4, 0, z), (0.195, 0.195, 0.015), material=metal)
    elif what == "ladder":
        for z in (-0.17, 0.17):
            kit.between((-1.2, -0.25, 1.47 + z), (1.4, -0.25, 1.47 + z), 0.025, BOX, material=metal)
        for x in np.linspace(-1.05, 1.25, 8):
            kit.between((x, -0.25, 1.3), (x, -0.25, 1.64), 0.018, material=metal)
    elif what == "sack":
        kit.add(BALL, (-0.1, -0.1, 1.6), (0.2, 0.36, 0.17), rotation=turn("z", 70), material=kit.material(base=[0.5, 0.42, 0.28], pattern=CLOUDY))
    else:
        box(kit, (0.06, 0.33, 0.58), (0.2, 0.09, 0.2), kit.material(), mirror=True)
        kit.between((0.06, 0.32, 0.75), (0.06, 0.31, 0.85), 0.015, material=metal, mirror=True)


def with_dog(kit):
    rng = kit.rng
    fur = kit.material(base=np.array([0.4, 0.27, 0.15]) * rng.uniform(0.1, 2), pattern=rng.choice([PLAIN, CLOUDY, SPECKLES]))
    somebody(
        kit,
        Outfit(kit, skirt=kit.chance(0.25)),
        (0, 0, HIP - 0.03),
        hands=[(0.0, 0.27, 0.85), (0.3, -0.22, 1.0)],
        feet=[(0.22, 0.1, 0.07), (-0.25, -0.1, 0.1)],
        toes=(0, 20),
    )
    s, x, y = rng.uniform(0.7, 1.2), rng.uniform(0.8, 1.1), -0.3
    back = 0.48 * s
    kit.add(BALL, (x, y, back), (0.3 * s, 0.11 * s, 0.13 * s), material=fur)
    kit.add(BALL, (x + 0.2 * s, y, back), (0.13 * s, 0.12 * s, 0.16 * s), material=fur)
    for dx in (-0.22, 0.2):
        for dy in (-0.06, 0.06):
            swing = rng.uniform(-0.1, 0.1)
            kit.chain([(x + dx * s, y + dy * s, back), (x + (dx + swing) * s, y + dy * s, 0.03)], [0.055 * s, 0.03 * s], fur)
    neck = np.array([x + 0.38 * s, y, back + 0.24 * s])
    kit.between((x + 0.22 * s, y, back + 0.04), neck, 0.085 * s, taper=0.8, material=fur)
    kit.add(BALL, neck + [0.03 * s, 0, 0.02], (0.12 * s, 0.085 * s, 0.09 * s), material=fur)
    kit.between(neck, neck + [0.22 * s, 0, -0.03 * s], 0.055 * s, taper=0.7, material=fur)
    kit.add(BALL, neck + [0.22 * s, 0, -0.01 * s], (0.02, 0.02, 0.02), material=kit.material(dark=True))
    for dy in (-0.07, 0.07):
        box(kit, neck + [-0.03 * s, dy * s, 0.08 * s], (0.035 * s, 0.012, 0.06 * s), fur, taper=(0.3, 1))
    kit.between((x - 0.27 * s, y, back + 0.05), (x - 0.48 * s, y, back + rng.uniform(-0.1, 0.28) * s), 0.03 * s, taper=0.4, material=fur)
    kit.between((0.3, -0.22, 1.0), neck + [-0.06, 0, -0.1], 0.008, material=kit.material())


def child_up(kit):
    """A child on the shoulders."""
    somebody(kit, Outfit(kit, hat="none"), lean=turn("y", 3), hands=[(0.17, 0.13, 1.28), (0.17, -0.13, 1.28)], look=turn("y", 4))
    child = Outfit(kit, bare=(True, True))
    child.wide = 0.95
    size = 0.58
    hips = np.array([-0.1, 0, 1.52]) / size
    hands = [hips + [0.22, 0.13, 0.5], hips + [0.22, -0.13, 0.5]]
    feet = [hips + [0.42, 0.2, -0.45], hips + [0.42, -0.2, -0.45]]
    somebody(kit, child, hips, turn("y", 8), hands, feet, size=size, small=True)


def two_people(kit):
    """Two who embrace, shake hands, talk or dance."""
    rng = kit.rng
    what = rng.choice(["hug", "shake", "talk", "dance"])
    half = {"hug": 0.15, "shake": 0.4, "talk": 0.42, "dance": 0.22}[what]
    for side in (-1, 1):
        outfit = Outfit(kit, skirt=kit.chance(0.5) if side > 0 else False)
        hands = {
            "hug": [(0.4, 0.12, 1.2 + 0.1 * side), (0.4, -0.12, 1.2 - 0.1 * side)],
            "shake": [(0.02, 0.27, 0.86), (0.41, -0.02, 1.08)],
            "talk": [(0.28, 0.25, 1.15), (0.02, -0.28, 0.86)] if side < 0 else [(0.25, -0.03, 1.15), (0.24, 0.05, 1.12)],
            "dance": [(0.22, 0.45, 1.38), (0.34, -0.14, 1.15)] if side < 0 else [(0.3, 0.16, 1.4), (0.22, -0.45, 1.38)],
        }[what]
        lean = turn("y", 6 if what == "hug" else 2)
        feet = None if what != "dance" else [(0.12 * side, 0.12, 0.07), (-0.15, -0.12, 0.07)]
        looks = turn("z", 25) @ turn("y", 3) if what in ("hug", "dance") else turn("y", 3)
        size = 1.0 if side < 0 else rng.uniform(0.9, 1.0)
        somebody(kit, outfit, (0, 0, HIP), lean, hands, feet, (side * half, 0, 0), 0 if side < 0 else 180, size, looks, elbows=(-0.3, 0, -0.8), small=True)


def on_bench(kit):
    look, metal = wooden(kit), kit.material(dark=kit.chance(0.7))
    pair = kit.chance(0.4)
    for k in range(2 if pair else 1):
        hands = [(0.3, 0.15, 0.62), (0.3, -0.15, 0.62)] if kit.chance(0.5) else [(0.3, 0.07, 0.85), (0.3, -0.07, 0.85)]
        outfit = Outfit(kit)
        somebody(kit, outfit, (-0.02, 0, 0.54), turn("y", kit.rng.uniform(-12, 3)), hands, SEATED, (0, 0.65 * k - 0.3 * pair, 0), small=pair)
        if hands[0][2] > 0.7 and not pair:
            box(kit, (0.34, 0, 0.9), (0.012, 0.14, 0.1), kit.material(base=[0.75] * 3, pattern=WRITING), turn("y", -25))
    for x in (-0.18, 0.0, 0.18):
        box(kit, (x, 0, 0.44), (0.08, 0.85, 0.018), look)
    for z in (0.62, 0.8):
        box(kit, (-0.27, 0, z), (0.018, 0.85, 0.07), look, turn("y", -8))
    box(kit, (0.12, 0.65, 0.21), (0.03, 0.03, 0.21), metal, mirror=True)
    box(kit, (-0.26, 0.65, 0.43), (0.03, 0.03, 0.43), metal, turn("y", -8), mirror=True)


def on_swing(kit):
    rng = kit.rng
    high, swing = rng.uniform(2.1, 2.4), rng.uniform(-22, 22)
    beam, frame = kit.material(), turn("y", swing)
    kit.between((0, -1.0, high), (0, 1.0, high), 0.045, material=beam)
    for y in (-1, 1):
        for x in (-0.6, 0.6):
            kit.between((0, y * 0.95, high), (x, y * 1.1, 0), 0.035, material=beam)
    seat = np.array([0, 0, high]) - frame @ np.array([0, 0, high - 0.5])
    box(kit, seat, (0.12, 0.22, 0.02), wooden(kit), frame)
    for y in (-0.2, 0.2):
        kit.between(seat + [0, y, 0], (0, y, high), 0.01, material=kit.material(dark=True))
    hips = seat + [0, 0, 0.1]
    feet = [hips + frame @ np.array([0.65, y, -0.35]) for y in (0.1, -0.1)]
    hold = [seat + frame @ np.array([0, y, 0.55]) for y in (0.2, -0.2)]
    somebody(kit, Outfit(kit), hips, turn("y", swing * 0.7), hold, feet, knees=(1, 0, 0.5), elbows=(-0.2, 0, -1), toes=20)


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


def astronaut(kit):
    rng = kit.rng
    white = kit.material(
        base=np.array([0.8, 0.8, 0.78]) if kit.chance(0.75) else np.array([0.8, 0.3, 0.05]),
        pattern=rng.choice([PLAIN, CLOUDY]),
        frequency=6,
        gloss=0.05,
        second=[0.6, 0.6, 0.6],
    )
    visor = kit.material(base=[0.5, 0.33, 0.05] if kit.chance(0.5) else [0.03, 0.04, 0.07], pattern=PLAIN, gloss=0.64)
    outfit = Outfit(kit, top=white, bottom=white, shoes=white if kit.chance(0.5) else None, hat="bald", bare=(False, False), skin=white)
    outfit.wide = 1.45
    lean = turn("y", 6)
    hands = [(0.15, 0.42, 0.98), (0.15, -0.42, 0.98)] if kit.chance(0.5) else [(0.25, 0.4, 1.6), (0.2, -0.42, 0.98)]
    somebody(kit, outfit, (0, 0, HIP), lean, hands, [(0.12, 0.2, 0.09), (-0.08, -0.2, 0.09)], look=turn("y", 2), small=True)
    head = np.array([0, 0, HIP]) + lean @ np.array([0.02, 0, 0.72])
    kit.add(BALL, head, (0.18, 0.175, 0.18), material=white)
    kit.add(BALL, head + [0.055, 0, 0.005], (0.145, 0.145, 0.13), material=visor)
    kit.add(CYL, head - [0, 0, 0.17], (0.16, 0.16, 0.025), material=steel(kit))
    box(kit, (-0.27, 0, 1.3), (0.13, 0.23, 0.34), white, lean, (0.95, 0.9))
    box(kit, (0.21, 0, 1.22), (0.05, 0.12, 0.08), steel(kit), lean)
    red = kit.material(base=[0.6, 0.03, 0.03], pattern=PLAIN)
    for y in (0.06, -0.06):
        kit.chain([(0.22, y, 1.18), (0.2, y * 3.6, 1.05), (-0.15, y * 3.8, 1.05)], 0.02, red if y > 0 else white, joints=False)
        kit.add(BOX, (0.265, y, 1.25), (0.012, 0.02, 0.02), material=red)
    if kit.chance(0.5):
        kit.between((0.5, -0.7, 0), (0.5, -0.7, 1.9), 0.015, material=steel(kit))
        box(kit, (0.5, -0.42, 1.68), (0.01, 0.28, 0.18), kit.material(pattern=STRIPES))


def knight(kit):
    rng = kit.rng
    plate = kit.material(base=np.full(3, rng.uniform(0.25, 0.7)), pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.6, second=np.full(3, 0.2))
    coat = kit.material(pattern=rng.choice([PLAIN, CHECKER, STRIPES]))
    outfit = Outfit(kit, top=plate, bottom=plate, shoes=plate, hat="bald", bare=(False, False), skin=plate)
    raised = kit.chance(0.45)
    hand = np.array([0.3, -0.38, 1.6]) if raised else np.array([0.35, -0.3, 1.05])
    somebody(kit, outfit, (0, 0, HIP), turn("y", 4), [(0.32, 0.22, 1.15), hand], [(0.15, 0.15, 0.07), (-0.12, -0.16, 0.07)], look=turn("y", 3), small=True)
    head = np.array([0.07, 0, HIP + 0.72])
    kit.add(CYL, head, (0.11, 0.1, 0.13), (0.85, 1), material=plate)
    kit.add(BALL, head + [0, 0, 0.12], (0.095, 0.087, 0.07), material=plate)
    box(kit, head + [0.085, 0, 0.03], (0.022, 0.075, 0.01), kit.material(dark=True))
    if kit.chance(0.5):
        kit.chain([head + [0, 0, 0.16], head + [-0.08, 0, 0.3], head + [-0.22, 0, 0.25]], [0.02, 0.05, 0.03], coat)
    kit.add(BALL, (0.03, 0.24, HIP + 0.5), (0.1, 0.09, 0.09), material=plate, mirror=True)
    kit.add(CYL, (0.02, 0, HIP - 0.12), (0.18, 0.22, 0.22), (0.7, 1), material=coat)
    kit.add(CYL, (0.02, 0, HIP + 0.25), (0.15, 0.185, 0.2), (1.1, 1), material=coat)
    up = np.array([0.15, -0.1, 1.0]) if raised else np.array([0.55, 0.0, 0.8])
    up = up / np.linalg.norm(up)
    kit.between(hand - up * 0.15, hand + up * 0.08, 0.02, material=kit.material(dark=True))
    kit.between(hand + up * 0.08 - [0, 0.12, 0], hand + up * 0.08 + [0, 0.12, 0], 0.015, BOX, material=plate)
    kit.between(hand + up * 0.08, hand + up * 0.95, (0.012, 0.03), BOX, 0.4, material=plate)
    shield = kit.material(base=paint(rng.random(), 0.8, 0.5), pattern=rng.choice([PLAIN, STRIPES, CHECKER]), frequency=4)
    at = np.array([0.4, 0.28, 1.1])
    if kit.chance(0.4):
        kit.add(CYL, at, (0.32, 0.32, 0.025), rotation=turn("z", 15) @ ALONG_X, material=shield)
        kit.add(BALL, at + [0.02, 0, 0], (0.06, 0.08, 0.08), material=plate)
    else:
        box(kit, at + [0, 0, 0.12], (0.02, 0.23, 0.2), shield, turn("z", 15))
        kit.add(BOX, at + [0, 0, -0.25], (0.02, 0.23, 0.18), (1, 0.1), rotation=turn("z", 15) @ turn("x", 180), material=shield)
        box(kit, at + [0.02, 0, 0.1], (0.015, 0.035, 0.2), plate, turn("z", 15))
        box(kit, at + [0.02, 0, 0.14], (0.015, 0.2, 0.035), plate, turn("z", 15))


def musician(kit):
    rng = kit.rng
    what = rng.choice(["guitar", "drum", "trumpet", "violin"])
    hands = {
        "guitar": [(0.28, 0.5, 1.28), (0.24, -0.12, 1.02)],
        "drum": [(0.38, 0.14, 1.14), (0.38, -0.14, 1.14)],
        "trumpet": [(0.32, 0.05, 1.52), (0.3, -0.06, 1.54)],
        "violin": [(0.42, 0.22, 1.46), (0.34, -0.1, 1.42)],
    }[what]
    somebody(kit, Outfit(kit), hands=hands, look=turn("y", 3), elbows=(-0.2, 0, -1), feet=[(0.1, 0.15, 0.07), (-0.05, -0.14, 0.07)])
    wood, dark, metal = wooden(kit)._replace(gloss=0.4), kit.material(dark=True), steel(kit)
    brass = kit.material(base=[0.6, 0.4, 0.08], pattern=PLAIN, gloss=0.6)
    if what in ("guitar", "violin"):
        body, end = (np.array([0.21, -0.08, 1.03]), np.array([0.28, 0.68, 1.35])) if what == "guitar" else (np.array([0.2, 0.1, 1.46]), np.array([0.5, 0.26, 1.48]))
        size = 1.0 if what == "guitar" else 0.52
        along = (end - body) / np.linalg.norm(end - body)
        front = np.array([1.0, 0, 0.0]) if what == "guitar" else np.array([0, 0, 1.0])
        front = front - along * (along @ front)
        front /= np.linalg.norm(front)
        frame = np.stack([along, np.cross(front, along), front], 1)
        kit.add(CYL, body - along * 0.11 * size, np.array([0.19, 0.19, 0.045]) * size, rotation=frame, material=wood)
        kit.add(CYL, body + along * 0.14 * size, np.array([0.15, 0.14, 0.045]) * size, rotation=frame, material=wood)
        kit.add(CYL, body + along * 0.06 * size + front * 0.045 * size, np.array([0.055, 0.055, 0.006]) * size, rotation=frame, material=dark)
        box(kit, body - along * 0.15 * size + front * 0.05 * size, np.array([0.015, 0.07, 0.01]) * size, dark, frame)
        kit.between(body + along * 0.2 * size + front * 0.03 * size, end, (0.02 * size, 0.028 * size), BOX, material=dark)
        box(kit, end + along * 0.06 * size, np.array([0.07, 0.04, 0.015]) * size, wood, frame)
        if what == "violin":
            kit.between((0.36, -0.22, 1.4), (0.26, 0.5, 1.56), 0.008, material=dark)
        else:
            kit.between((0.1, 0.14, 1.44), body + along * 0.3, 0.012, material=dark)
    elif what == "drum":
        kit.add(CYL, (0.42, 0, 0.92), (0.22, 0.22, 0.13), material=kit.material(gloss=0.3))
        kit.add(CYL, (0.42, 0, 1.055), (0.215, 0.215, 0.012), material=kit.material(base=[0.8, 0.78, 0.7], pattern=PLAIN))
        for z in (0.8, 1.04):
            kit.add(CYL, (0.42, 0, z), (0.23, 0.23, 0.015), material=metal)
        for y in (-0.14, 0.14):
            kit.between((0.33, y, 1.16), (0.52, y * 0.4, 1.08), 0.01, material=wood)
        kit.between((0.1, 0.15, 1.42), (0.3, 0.18, 1.0), 0.015, material=dark)
    else:
        kit.between((0.12, 0, 1.6), (0.6, 0, 1.55), 0.015, material=brass)
        kit.between((0.6, 0, 1.55), (0.75, 0, 1.535), 0.025, taper=2.8, material=brass)
        kit.between((0.25, 0, 1.53), (0.5, 0, 1.5), 0.012, material=brass)
        for x in (0.32, 0.36, 0.4):
            kit.between((x, 0, 1.5), (x, 0, 1.64), 0.014, material=brass)


def street_worker(kit):
    """In a bright vest, with a sign, a broom or a shovel, beside cones."""
    rng = kit.rng
    bright = kit.material(base=paint(rng.choice([0.06, 0.18]), 0.95, 0.9), pattern=PLAIN)
    white, red, grey = kit.material(base=[0.8] * 3, pattern=PLAIN, gloss=0.3), kit.material(base=[0.75, 0.12, 0.02], pattern=PLAIN), steel(kit)
    outfit = Outfit(kit, top=bright, hat="helmet", cover=kit.material(base=paint(rng.choice([0.14, 0.0, 0.6]), rng.uniform(0, 1), 0.8), pattern=PLAIN, gloss=0.3))
    what = rng.choice(["sign", "broom", "shovel"])
    somebody(
        kit,
        outfit,
        hands=[(0.05, 0.27, 0.86), (0.32, -0.3, 1.15)] if what == "sign" else [(0.35, 0.12, 1.0), (0.3, -0.1, 1.22)],
        lean=turn("y", 2 if what == "sign" else 14),
    )
    for z in (1.05, 1.2):
        kit.add(CYL, (0.02, 0, z), (0.14, 0.185, 0.025), material=white)
    if what == "sign":
        kit.between((0.34, -0.32, 0.02), (0.34, -0.32, 1.75), 0.018, material=grey)
        disc = kit.material(base=[0.7, 0.03, 0.03] if kit.chance(0.6) else [0.02, 0.35, 0.12], pattern=PLAIN)
        kit.add(CYL, (0.36, -0.32, 1.95), (0.24, 0.24, 0.012), rotation=ALONG_X, material=white)
        kit.add(CYL, (0.368, -0.32, 1.95), (0.215, 0.215, 0.012), rotation=ALONG_X, material=disc)
        box(kit, (0.382, -0.32, 1.95), (0.006, 0.14, 0.045), white)
    else:
        foot = np.array([0.75, 0.3, 0.1])
        kit.between((0.27, -0.18, 1.35), foot, 0.018, material=wooden(kit))
        if what == "broom":
            box(kit, foot, (0.05, 0.26, 0.03), wooden(kit))
            box(kit, foot - [0, 0, 0.06], (0.045, 0.25, 0.05), kit.material(dark=True))
        else:
            kit.between(foot - [0.05, -0.02, -0.1], foot + [0.16, 0.1, -0.08], (0.015, 0.12), BOX, 0.75, material=grey)
    for k in range(int(rng.integers(0, 3))):
        at = np.array([0.5, -0.75 - 0.5 * k, 0])
        box(kit, at + [0, 0, 0.02], (0.2, 0.2, 0.02), red)
        kit.loft(at, [(0.03, 0.15), (0.25, 0.095), (0.42, 0.06), (0.6, 0.03)], red)
        kit.add(CYL, at + [0, 0, 0.33], (0.099, 0.099, 0.07), (0.68, 1), material=white)


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


CREWS = [
    *(
        rifleman,
        rifleman,
        gun_crew,
        mortar_crew,
        radio_operator,
        at_table,
        at_table,
        wheelbarrow,
        pram,
        umbrella,
        carrying,
        with_dog,
        child_up,
        two_people,
        on_bench,
        on_swing,
    ),
    *(dancer, footballer, climber, diver, astronaut, knight, musician, street_worker, skier, surfer, swimmer, canoe),
]


def crew(kit):
    """Soldiers and gun crews, people at tables, with barrows, prams, umbrellas, loads, dogs, children; couples, sport, divers, astronauts, knights, musicians."""
    CREWS[kit.rng.integers(len(CREWS))](kit)
