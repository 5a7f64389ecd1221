"""A maker of people at work, at play and in arms: at tables, with prams, dogs, umbrellas, barrows, instruments, on benches and swings."""


import numpy as np

from .bodies import HIP, Outfit, somebody
from .kit import ALONG_X, ALONG_Y, towards, turn
from .layout import BALL, BOX, CYL, SPOKES, TUBE
from .materials import CHECKER, CLOUDY, DOTS, PLAIN, PLANKS, SPECKLES, STRIPES, WRITING, paint
from .soldiers import box, gun_crew, mortar_crew, radio_operator, rifleman, steel, wooden
from .sports import canoe, climber, dancer, diver, footballer, skier, surfer, swimmer


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
