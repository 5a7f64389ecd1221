"""Soldiers: riflemen, crews of machine guns and mortars, radio operators."""


import numpy as np

from .bodies import HIP, SHOULDER, Outfit, somebody
from .kit import ALONG_Y, towards, turn
from .layout import BALL, BOX, CYL
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, PLANKS, STREAKS, WRITING


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
