"""Makers of busts, animals and soft toys out of ellipsoids and rounded limbs."""

import numpy as np

from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import SPECKLES, paint
from .people import hair_material, skin_material


def fur_material(kit):
    hue = kit.rng.choice([0.06, 0.08, 0.1, 0.12])
    base = paint(hue, kit.rng.uniform(0, 0.8), kit.rng.uniform(0.04, 0.85))
    if kit.chance(0.2):
        base = None
    return kit.material(base=base, pattern=kit.rng.choice([0, 1, 1, SPECKLES, 5]), gloss=0.01)


def soft_toy(kit):
    """Bears, rabbits, cats, dogs of cloth: big head, short limbs, sitting, standing or lying."""
    rng = kit.rng
    fur = fur_material(kit)
    pale = fur if kit.chance(0.4) else kit.material(base=np.clip(fur.first * 1.8 + 0.1, 0, 0.95), pattern=fur.pattern)
    dark = kit.material(dark=True, gloss=0.5, pattern=0)
    sitting = kit.chance(0.65)
    fat = rng.uniform(0.75, 1.15)
    tall = rng.uniform(0.45, 0.7)
    bottom = 0.0 if sitting else rng.uniform(0.35, 0.6)
    kit.add(BALL, (0, 0, bottom + tall * 0.9), (0.42 * fat, 0.46 * fat, tall), material=fur)
    if kit.chance(0.5):
        kit.add(BALL, (0.08 * fat, 0, bottom + tall * 0.85), (0.37 * fat, 0.36 * fat, tall * 0.8), material=pale)
    head = rng.uniform(0.34, 0.52)
    z = bottom + 1.75 * tall + 0.6 * head
    lean = rng.uniform(-0.05, 0.12)
    kit.add(BALL, (lean, 0, z), (head * 0.95, head * rng.uniform(0.95, 1.15), head * rng.uniform(0.85, 1)), material=fur)
    kit.add(BALL, (lean + head * 0.8, 0, z - head * 0.2), (head * 0.4, head * 0.42, head * 0.33), material=pale)
    kit.add(BALL, (lean + head * 1.17, 0, z - head * 0.1), (head * 0.1, head * 0.13, head * 0.1), material=dark)
    kit.add(BALL, (lean + head * 0.82, head * 0.35, z + head * 0.2), (head * 0.1,) * 3, material=dark, mirror=True)
    ear = rng.random()
    if ear < 0.55:
        size = head * rng.uniform(0.25, 0.42)
        kit.add(BALL, (lean, head * 0.75, z + head * 0.75), (size * 0.5, size, size), material=fur, mirror=True)
        kit.add(BALL, (lean + size * 0.35, head * 0.75, z + head * 0.75), (size * 0.3, size * 0.6, size * 0.6), material=pale, mirror=True)
    elif ear < 0.8:
        tip = (lean - 0.1, head * rng.uniform(0.5, 1.4), z + head * rng.uniform(0.2, 2))
        kit.chain([(lean, head * 0.5, z + head * 0.7), tip], [head * 0.2, head * 0.16], fur, mirror=True)
    else:
        kit.add(CYL, (lean, head * 0.6, z + head), (head * 0.3, head * 0.2, head * 0.35), (0.1, 1), material=fur, mirror=True)
    limb = rng.uniform(0.13, 0.22) * fat
    shoulder = (0.05, 0.36 * fat, bottom + 1.4 * tall)
    out = rng.uniform(0.2, 0.5)
    hand = (rng.uniform(0, 0.5), 0.4 * fat + out, bottom + 1.4 * tall + rng.uniform(-0.7, 0.3))
    kit.chain([shoulder, hand], [limb, limb * rng.uniform(0.8, 1.1)], fur, mirror=True)
    thick = limb * rng.uniform(1.1, 1.4)
    if sitting:
        foot = (0.55 + rng.uniform(0, 0.4), rng.uniform(0.3, 0.6), thick)
        kit.chain([(0.1, 0.25 * fat, thick * 1.1), foot], [thick, thick], fur, mirror=True)
        kit.add(BALL, (foot[0] + 0.1, foot[1], thick * 1.2), (thick * 0.5, thick * 1.05, thick * 1.3), material=pale, mirror=True)
    else:
        foot = (0.05, 0.25 * fat, thick)
        kit.chain([(0, 0.22 * fat, bottom + 0.3), foot], [thick, thick], fur, mirror=True)
        kit.add(BALL, (0.15, 0.25 * fat, thick * 0.7), (thick * 1.5, thick, thick * 0.7), material=pale, mirror=True)
    if kit.chance(0.3):
        bow = kit.material(gloss=0.2)
        kit.add(BALL, (0.3 * fat, 0.12, bottom + 1.7 * tall), (0.05, 0.13, 0.08), material=bow, mirror=True)
    if kit.chance(0.25):
        kit.add(CYL, (0, 0, bottom + tall * 0.9), (0.46 * fat, 0.49 * fat, tall * 0.5), (0.8, 1), material=kit.material())


def bust(kit):
    """Head and shoulders, as portraits show them."""
    rng = kit.rng
    skin, cloth = skin_material(kit), kit.material()
    hair = hair_material(kit)
    kit.add(BALL, (0, 0, 0.1), (0.28, 0.52, 0.42), material=cloth)
    kit.add(BALL, (0, 0.36, 0.12), (0.2, 0.2, 0.24), material=cloth, mirror=True)
    kit.between((0, 0, 0.35), (0.03, 0, 0.7), 0.13, material=skin)
    kit.add(BALL, (0.05, 0, 0.9), (0.25, 0.2, 0.31), material=skin)
    long = rng.uniform(0.26, 0.5)
    kit.add(BALL, (-0.06, 0, 1.1 - long * 0.4), (0.26, 0.24, long), material=hair)
    kit.add(BALL, (0.29, 0, 0.87), (0.06, 0.04, 0.07), material=skin)
    dark = kit.material(dark=True, gloss=0.4)
    kit.add(BALL, (0.24, 0.08, 0.96), (0.05, 0.045, 0.025), material=dark, mirror=True)
    kit.add(BALL, (0.25, 0, 0.76), (0.05, 0.07, 0.02), material=kit.material(base=[0.45, 0.12, 0.1], pattern=0))
    kit.add(BALL, (0.02, 0.2, 0.9), (0.05, 0.03, 0.08), material=skin, mirror=True)


def animal_bust(kit):
    """Head and shoulders of dogs, cats, bears, calves, goats: coats of two or three colours, as close-ups show them."""
    rng = kit.rng
    fur, second, third = fur_material(kit), fur_material(kit), fur_material(kit)
    if kit.chance(0.3):
        second = fur
    dark = kit.material(dark=True, gloss=0.6, pattern=0)
    wide, high = rng.uniform(0.26, 0.36), rng.uniform(0.26, 0.38)
    long = rng.uniform(0.24, 0.34)
    skull = np.array([rng.uniform(0, 0.25), 0, rng.uniform(0.75, 1.0)])
    chest = np.array([-0.15, 0, 0.2])
    kit.add(BALL, chest, (0.38, rng.uniform(0.35, 0.5), rng.uniform(0.4, 0.55)), material=fur)
    kit.add(BALL, chest + [0.2, 0, 0.1], (0.2, rng.uniform(0.15, 0.3), 0.34), material=second if kit.chance(0.6) else fur)
    if kit.chance(0.6):
        kit.add(BALL, chest + [-0.6, 0, rng.uniform(-0.1, 0.2)], (0.6, 0.36, 0.34), material=fur)
    kit.between(chest + [0, 0, 0.2], skull - [0.03, 0, 0.1], rng.uniform(0.16, 0.26), material=fur)
    kit.add(BALL, skull, (long, wide, high), material=fur)
    # The cheeks, the muzzle and the blaze are patches that lie on the skull and reach a little beyond it.
    cheek = second if kit.chance(0.5) else fur
    kit.add(BALL, skull + [long * 0.35, wide * 0.55, -high * 0.3], (long * 0.6, wide * 0.55, high * 0.55), material=cheek, mirror=True)
    if kit.chance(0.5):
        blaze = third if kit.chance(0.5) else second
        kit.add(BALL, skull + [long * 0.5, 0, high * 0.4], (long * 0.54, wide * rng.uniform(0.12, 0.4), high * 0.58), material=blaze)
    if kit.chance(0.3):
        kit.add(BALL, skull + [long * 0.55, wide * 0.42, high * 0.2], (long * 0.42, wide * 0.35, high * 0.4), material=third)
    reach = rng.uniform(0.1, 0.6) * rng.choice([0.6, 1])
    muzzle = second if kit.chance(0.7) else fur
    root = skull + [long * 0.7, 0, -high * rng.uniform(0.2, 0.45)]
    tip = root + [reach, 0, -rng.uniform(0, 0.4) * reach]
    narrow = rng.uniform(0.09, 0.17)
    kit.chain([root, tip], [narrow * rng.uniform(1.1, 1.6), narrow], muzzle)
    kit.add(BALL, tip + [0, narrow * 0.5, -narrow * 0.2], (narrow * 0.9, narrow * 0.75, narrow * 0.8), material=muzzle, mirror=True)
    kit.add(BALL, tip + [narrow * 0.85, 0, narrow * 0.35], (narrow * 0.35, narrow * 0.5, narrow * 0.36), material=dark)
    if kit.chance(0.3):
        tongue = kit.material(base=[0.55, 0.2, 0.2], pattern=0, gloss=0.3)
        kit.add(BALL, tip + [narrow * 0.3, 0, -narrow * 1.2], (narrow * 0.4, narrow * 0.5, narrow), material=tongue)
    else:
        kit.add(BALL, tip + [narrow * 0.3, 0, -narrow * 0.85], (narrow * 0.6, narrow * 0.8, narrow * 0.3), material=dark)
    eye = rng.uniform(0.025, 0.06)
    iris = kit.material(gloss=0.6, pattern=0) if kit.chance(0.6) else dark
    at = skull + [long * 0.82, wide * rng.uniform(0.38, 0.6), high * rng.uniform(0.05, 0.3)]
    kit.add(BALL, at, (eye, eye, eye), material=iris, mirror=True)
    kit.add(BALL, at + [eye * 0.5, 0, 0], (eye * 0.6,) * 3, material=dark, mirror=True)
    ear = rng.uniform(0.12, 0.45)
    hang = rng.choice([-1, 0.2, 1, 1])
    base = skull + [-0.02, wide * rng.uniform(0.6, 0.9), high * rng.uniform(0.6, 0.85)]
    aside = rng.uniform(0.1, 0.6) if hang > 0 else rng.uniform(0.3, 0.6)
    end = base + [rng.uniform(-0.05, 0.1), aside * ear, hang * ear]
    kit.chain([base, end], [ear * 0.34, ear * rng.uniform(0.08, 0.3)], third if kit.chance(0.4) else fur, mirror=True)
    if hang > 0 and kit.chance(0.6):
        inner = kit.material(base=[0.5, 0.3, 0.26], pattern=0)
        kit.between(base + [ear * 0.24, 0, 0.02], end * 0.8 + base * 0.2 + [ear * 0.1, 0, 0], ear * 0.16, taper=0.3, material=inner, mirror=True)
    if kit.chance(0.2):
        horn = base + [rng.uniform(-0.2, 0.05), rng.uniform(-0.05, 0.3), rng.uniform(0.2, 0.7)]
        kit.chain([base + [0.05, -0.06, 0.05], horn], [0.05, 0.02], kit.material(base=[0.35, 0.28, 0.2], pattern=0), mirror=True)
    if kit.chance(0.25):
        kit.add(CYL, chest + [0.08, 0, 0.42], (0.24, 0.24, 0.04), (0.9, 1), rotation=turn("y", 20), material=kit.material())


def markings(kit, place, half):
    """Patches on a body, an ellipsoid of half sizes `half` at `place`: a coat of more than one colour."""
    rng = kit.rng
    patch = fur_material(kit)
    for _ in range(rng.integers(1, 4)):
        direction = rng.normal(size=3)
        direction /= np.linalg.norm(direction)
        size = rng.uniform(0.35, 0.75)
        # It reaches beyond the body by a twentieth.
        kit.add(BALL, place + direction * half * (1.05 - size), half * size, material=patch)


def looking(kit, down):
    """The frame of a head that looks `down` by so many degrees, in three of five turned aside."""
    aside = kit.rng.normal(0, 35) if kit.chance(0.6) else 0.0
    return turn("z", aside) @ turn("y", down)


def animal_head(kit, at, size, facing, fur, second):
    """Skull, muzzle, ears, eyes, nose and some horns where a neck ends; `facing` [3, 3]: forward, left and up of the head."""
    rng = kit.rng

    def place(x, y, z):
        return at + facing @ np.array([x, y, z]) * size

    def ball(where, half, material, rotation=None):
        kit.add(BALL, place(*where), np.array(half) * size, rotation=facing if rotation is None else facing @ rotation, material=material)

    ball((0.28, 0, 0.08), (1.08, 0.85, 0.83), fur)
    long = rng.uniform(0.3, 1.4)
    nose = (0.75 + long, 0, rng.uniform(-0.45, 0))
    kit.chain([place(0.62, 0, -0.05), place(*nose)], [size * 0.54, size * 0.35], second)
    ear, hang = rng.uniform(0.25, 1.2), rng.choice([-0.5, 0.3, 0.5])
    dark = kit.material(dark=True, gloss=0.5)
    horned = kit.chance(0.2)
    for side in (-1, 1):
        ball((0, side * 0.67, 0.65 + hang * ear), (ear * 0.23, ear * 0.45, ear), second, turn("x", -25 * side))
        ball((0.98, side * 0.46, 0.32), (0.13, 0.13, 0.13), dark)
        if horned:
            kit.chain([place(0, side * 0.4, 0.7), place(0.1, side * 1.1, 1.5)], [size * 0.12, size * 0.05], dark)
    if kit.chance(0.7):
        ball((nose[0] + 0.28, 0, nose[2] + 0.08), (0.14, 0.2, 0.14), dark)


def sitting(kit):
    """Dogs, cats, hares, bears on their haunches: the back slopes, the forelegs stand."""
    rng = kit.rng
    fur = fur_material(kit)
    second = fur if kit.chance(0.6) else fur_material(kit)
    fat, long, lean = rng.uniform(0.2, 0.36), rng.uniform(0.45, 0.8), np.radians(rng.uniform(40, 75))
    along = np.array([np.cos(lean), 0, np.sin(lean)])
    rump = np.array([0, 0, fat])
    chest = rump + along * long
    slope = turn("y", -np.degrees(lean))
    kit.add(BALL, (rump + chest) / 2, (long * 0.65, fat * 0.85, fat * 0.95), rotation=slope, material=fur)
    kit.add(BALL, rump + [0.02, 0, 0], (fat * 1.1, fat * rng.uniform(1, 1.25), fat), material=fur)
    kit.add(BALL, chest, (fat * 0.95, fat * 0.85, fat * 1.05), material=second if kit.chance(0.3) else fur)
    leg = fat * rng.uniform(0.2, 0.36)
    fore = chest + [rng.uniform(0.02, 0.2), fat * 0.55, -chest[2] + leg * 0.6]
    kit.chain([chest + [0.05, fat * 0.5, 0], fore], [leg * 1.2, leg * 0.8], fur, mirror=True)
    kit.add(BALL, fore + [leg * 0.8, 0, 0], (leg * 1.7, leg, leg * 0.7), material=second, mirror=True)
    thigh = rump + [fat * 0.5, fat * 0.85, -fat * 0.25]
    kit.add(BALL, thigh, (fat * 0.8, fat * 0.4, fat * 0.75), material=fur, mirror=True)
    kit.add(BALL, (thigh[0] + fat * 0.7, thigh[1] + fat * 0.1, leg * 0.7), (leg * 2.4, leg, leg * 0.7), material=second, mirror=True)
    if kit.chance(0.4):
        markings(kit, (rump + chest) / 2, np.array([fat, fat * 0.87, long * 0.6]))
    if kit.chance(0.35):
        kit.add(BALL, chest + [fat * 0.45, 0, -fat * 0.3], (fat * 0.55, fat * 0.5, fat * 0.9), material=second)
    neck = chest + [rng.uniform(0, 0.15), 0, fat * rng.uniform(0.9, 1.6)]
    kit.chain([chest + [0, 0, fat * 0.3], neck], [fat * 0.75, fat * 0.5], fur)
    skull = fat * rng.uniform(0.55, 0.85)
    animal_head(kit, neck + [0, 0, skull * 0.15], skull, looking(kit, rng.normal(2, 10)), fur, second)
    tail = rng.uniform(0.2, 0.7)
    kit.chain([rump + [-fat * 0.8, 0, -fat * 0.6], (-fat - tail, rng.uniform(-0.2, 0.2), rng.uniform(0.05, 0.4))], [fat * 0.2, fat * 0.1], second)


def quadruped(kit):
    """Dogs, cats, horses, cows, giraffes, elephants and what lies between; some sit."""
    rng = kit.rng
    if kit.chance(0.25):
        sitting(kit)
        return
    fur = fur_material(kit)
    second = fur if kit.chance(0.5) else fur_material(kit)
    long, tall = rng.uniform(0.5, 1.1), rng.uniform(0.35, 1.3)
    fat = rng.uniform(0.2, 0.5)
    leg = fat * rng.uniform(0.13, 0.32)
    z = tall + fat * 0.7
    kit.add(BALL, (0, 0, z), (long, fat * 0.85, fat), material=fur)
    kit.add(BALL, (long * 0.6, 0, z + 0.03), (long * 0.4, fat * 0.85, fat * 1.02), material=fur)
    kit.add(BALL, (-long * 0.6, 0, z + 0.02), (long * 0.4, fat * 0.88, fat * 1.05), material=fur)
    if kit.chance(0.4):
        markings(kit, np.array([0, 0, z]), np.array([long, fat * 0.87, fat]))
    socks = second if kit.chance(0.4) else fur
    lying = kit.chance(0.1)
    stride = rng.uniform(-0.2, 0.2)
    for x in (-0.65, 0.65):
        for side in (-1, 1):
            if lying:
                continue
            swing = side * stride * np.sign(x)
            # Hind legs bend backwards at the hock.
            back = 0.14 * tall * (x < 0)
            knee = (x * long + swing * 0.6 - back, side * fat * 0.55, tall * 0.45)
            foot = (x * long + swing, side * fat * 0.55, leg * 0.6)
            top = (x * long, side * fat * 0.5, z - fat * 0.1)
            kit.add(BALL, top, (leg * (1.6 + 0.8 * (x < 0)), leg * 1.3, leg * 2.2), material=fur)
            kit.chain([top, knee], [leg * 1.35, leg * 0.95], fur)
            kit.chain([knee, foot], [leg * 0.95, leg * 0.7], socks)
            kit.add(BALL, (foot[0] + leg * 0.4, foot[1], leg * 0.5), (leg * 1.2, leg, leg * 0.5), material=socks)
    neck = rng.uniform(0.2, 1.2) * rng.choice([0.6, 1])
    grazing = not lying and kit.chance(0.18)
    up = rng.uniform(20, 75)
    if grazing:
        neck, up = tall * rng.uniform(0.55, 0.9), rng.uniform(-60, -35)
    start = np.array([long * 0.85, 0, z + fat * 0.3])
    end = start + neck * np.array([np.cos(np.radians(up)), 0, np.sin(np.radians(up))])
    kit.chain([start, end], [fat * 0.55, fat * 0.38], fur)
    animal_head(kit, end, fat * rng.uniform(0.45, 0.8), looking(kit, 40 if grazing else rng.normal(8, 8)), fur, second)
    tail = rng.uniform(0.2, 0.9)
    kit.chain([(-long * 0.95, 0, z + fat * 0.4), (-long - tail * 0.6, 0, z + tail * rng.uniform(-1, 0.8))], [fat * 0.14, fat * 0.07], second)


def bird(kit):
    """Ducks, hens, pigeons, toys of their shape; some with wings spread."""
    rng = kit.rng
    body, wing = fur_material(kit), fur_material(kit)
    beak = kit.material(base=[0.7, 0.4, 0.05], pattern=0)
    long, fat = rng.uniform(0.4, 0.7), rng.uniform(0.25, 0.4)
    leg = rng.uniform(0.0, 0.6)
    z = leg + fat
    kit.add(BALL, (0, 0, z), (long, fat, fat), rotation=turn("y", rng.uniform(-35, 5)), material=body)
    neck = rng.uniform(0.1, 0.7)
    head = (long * 0.8 + 0.1, 0, z + fat * 0.6 + neck)
    kit.chain([(long * 0.6, 0, z + fat * 0.3), head], [fat * 0.5, fat * 0.35], body)
    kit.add(BALL, head, (fat * 0.5, fat * 0.42, fat * 0.42), material=body)
    kit.between(head, (head[0] + fat * rng.uniform(0.8, 1.4), 0, head[2] - 0.05), fat * 0.16, taper=0.2, material=beak)
    kit.add(BALL, (head[0] + fat * 0.25, fat * 0.33, head[2] + 0.08), (0.035,) * 3, material=kit.material(dark=True), mirror=True)
    if kit.chance(0.25):
        kit.add(BOX, (0, long, z + fat * 0.4), (long * 0.5, 0.03, long * 0.9), (0.3, 1), rotation=turn("x", -75), material=wing, mirror=True)
    else:
        kit.add(BALL, (-long * 0.15, fat * 0.85, z + fat * 0.15), (long * 0.7, fat * 0.25, fat * 0.6), material=wing, mirror=True)
    kit.add(BOX, (-long * 1.05, 0, z + fat * 0.2), (long * 0.4, fat * 0.5, 0.03), rotation=turn("y", rng.uniform(-10, 40)), material=wing)
    if leg > 0.1:
        kit.between((0, fat * 0.35, z - fat * 0.7), (0.05, fat * 0.4, 0), 0.03, material=beak, mirror=True)
        kit.add(BOX, (0.1, fat * 0.4, 0.015), (0.12, 0.08, 0.015), material=beak, mirror=True)
