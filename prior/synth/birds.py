"""Birds: penguins, owls, parrots, eagles, waders, swans, hens and cocks, peacocks; their plumage, wings, legs."""

import itertools

import numpy as np

from .animals import BLACK, BROWN, CREAM, DARK, GREY, ORANGE, PINK, RED, TAN, WHITE, Head, black, fur, hull, looking
from .kit import towards, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, PLAIN, SPECKLES, STREAKS, paint


def sail(kit, apex, first, second, thin, material, mirror=False):
    """A triangular plate with these corners."""
    apex, first, second = (np.array(p, float) for p in (apex, first, second))
    edge, rise = second - first, apex - (first + second) / 2
    x = edge / np.linalg.norm(edge)
    along = rise @ x
    up = rise - along * x
    z = up / np.linalg.norm(up)
    half = (np.linalg.norm(edge) / 2, thin, np.linalg.norm(up) / 2)
    kit.add(BOX, (first + second) / 2 + up / 2, half, (0.03, 1), (along, 0), np.stack([x, np.cross(z, x), z], 1), material, mirror)


def membrane(kit, stations, thin, material):
    """A wing and its twin of strips between `stations` [(front x, rear x, y, z), ...] from root to tip."""
    for (a0, b0, y0, z0), (a1, b1, y1, z1) in itertools.pairwise(stations):
        way = np.array([0, y1 - y0, z1 - z0])
        far = np.linalg.norm(way)
        rotation = np.stack([np.array([1.0, 0, 0]), np.cross(way / far, [1.0, 0, 0]), way / far], 1)
        middle = ((a0 + b0) / 2, (y0 + y1) / 2, (z0 + z1) / 2)
        taper, shift = max((a1 - b1) / (a0 - b0), 0.03), (a1 + b1 - a0 - b0) / 2
        kit.add(BOX, middle, ((a0 - b0) / 2, thin, far * 0.51), (taper, 1), (shift, 0), rotation, material, mirror=True)


def plumage(kit, *colours, **fixed):
    """Feathers of one of the colours, or of any."""
    if kit.chance(0.15):
        colours = [paint(kit.rng.random(), kit.rng.uniform(0.4, 1), kit.rng.uniform(0.15, 0.7))]
    return fur(kit, *colours, **fixed)


def folded_wing(kit, shoulder, tip, deep, thick, coat, quills):
    """Wings that lie against the body, the flight feathers darker and behind."""
    shoulder, tip = np.array(shoulder, float), np.array(tip, float)
    along = tip - shoulder
    far = np.linalg.norm(along)
    frame = towards(along)
    kit.add(BALL, shoulder + along * 0.36, (deep, thick, far * 0.42), rotation=frame, material=coat, mirror=True)
    kit.add(BALL, shoulder + along * 0.68 + frame[:, 0] * deep * 0.15, (deep * 0.62, thick * 0.75, far * 0.42), rotation=frame, material=quills, mirror=True)


def spread_wing(kit, root, wrist, tip, chord, coat, quills, fingers=5):
    """Wings held out: arm, a sheet of feathers behind it, and fingers at the end."""
    root, wrist, tip = (np.array(p, float) for p in (root, wrist, tip))
    back = np.array([-chord, 0, 0])
    hand = wrist * 0.55 + tip * 0.45
    kit.between(root, wrist, (0.05, 0.07), CYL, 0.7, coat, mirror=True)
    kit.add(BALL, wrist, (0.06, 0.06, 0.045), material=coat, mirror=True)
    stations = [(p[0] + 0.02, p[0] - chord * wide, p[1], p[2]) for p, wide in ((root, 1.0), (wrist, 1.2), (hand, 0.9))]
    membrane(kit, stations[:2], 0.02, coat)
    membrane(kit, [(root[0] - 0.6 * chord, root[0] - chord * 1.15, *root[1:]), (wrist[0] - 0.7 * chord, wrist[0] - chord * 1.3, *wrist[1:])], 0.015, quills)
    membrane(kit, stations[1:], 0.02, quills)
    for k in range(fingers):
        share = k / (fingers - 1)
        end = tip * (1 - share) + (wrist + back * 1.15) * share + (tip - wrist) * 0.35 * np.sin(np.pi * share)
        kit.between(wrist, end, (0.012, chord * 0.2), BOX, 0.5, quills, mirror=True)


def bird_legs(kit, hip, knee, foot, radius, colour, toes=3):
    """Thin legs whose heel bends backwards, toes spread on the ground."""
    kit.chain([hip, knee, foot], [radius * 1.2, radius, radius], colour, mirror=True)
    for angle in np.linspace(-35, 35, toes) if toes > 1 else [0]:
        way = turn("z", angle) @ np.array([radius * 6, 0, 0])
        kit.between(foot, (foot[0] + way[0], foot[1] + way[1], foot[2] - radius * 0.4), radius * 0.8, CYL, 0.5, colour, mirror=True)


def hooked(head, coat, long, deep):
    """A beak whose tip bends down, as of eagles and parrots."""
    head.kit.between(head.place(0.6, 0, 0.05), head.place(0.9 + long, 0, -0.05), np.array([deep, deep * 0.7]) * head.size, CYL, 0.75, coat)
    head.kit.between(head.place(0.85 + long, 0, 0.0), head.place(1.0 + long, 0, -0.65 * deep - 0.35), np.array([deep, deep * 0.6]) * head.size * 0.75, CYL, 0.1, coat)


def perch(kit, height):
    """A branch, a post or a bar on a stand, that ends at `height`; not of the bird."""
    rng = kit.rng
    bird = len(kit.primitives)
    wood = kit.material(base=np.array(BROWN) * rng.uniform(0.6, 2), pattern=STREAKS, frequency=rng.uniform(6, 14))
    kind = rng.choice(["branch", "post", "stand"])
    if kind == "branch":
        hull(kit, [(0.1, -0.7, height - 0.22), (0, 0, height - 0.06), (-0.1, 0.7, height + 0.02)], [0.07, 0.06, 0.045], wood)
        kit.between((0, 0.3, height - 0.05), (0.35, 0.55, height + 0.25), 0.03, CYL, 0.5, wood)
    elif kind == "post":
        kit.add(CYL, (0, 0, height / 2 - 0.35), (0.14, 0.14, height / 2 + 0.35), material=wood)
    else:
        kit.between((0, -0.42, height - 0.03), (0, 0.42, height - 0.03), 0.035, material=wood)
        kit.between((0, 0, height - 0.7), (0, 0, height - 0.03), 0.03, material=wood)
        kit.add(CYL, (0, 0, height - 0.7), (0.28, 0.28, 0.03), material=wood)
    kit.only_carries(bird)


def penguin(kit):
    rng = kit.rng
    back, front = fur(kit, BLACK, BLACK, (0.05, 0.07, 0.1), GREY, pattern=PLAIN, gloss=0.1), fur(kit, WHITE, pattern=PLAIN)
    fat, lean = rng.uniform(0.21, 0.3), rng.uniform(-3, 10)
    orange = kit.material(base=ORANGE if kit.chance(0.6) else BLACK, pattern=PLAIN)
    kit.add(BALL, (0, 0, 0.55), (fat, fat * 1.02, 0.54), rotation=turn("y", lean), material=back)
    kit.add(BALL, (fat * 0.28, 0, 0.5), (fat * 0.82, fat * 0.86, 0.47), rotation=turn("y", lean), material=front)
    head = Head(kit, (0.04 + lean * 0.006, 0, 1.1), looking(kit, 0), 0.145)
    hull(kit, [(0, 0, 0.85), head.at], [fat * 0.72, 0.13], back, first=False)
    head.ball((0, 0, 0), (1.1, 0.95, 1), back)
    if kit.chance(0.5):
        head.ball((0, 0.5, -0.2), (0.6, 0.55, 0.55), fur(kit, WHITE, (0.8, 0.5, 0.08), pattern=PLAIN), True)
    kit.between(head.place(0.8, 0, -0.05), head.place(0.95 + rng.uniform(0.8, 1.6), 0, -0.2), 0.05, CYL, 0.2, orange)
    head.eyes(0.75, 0.55, 0.25, 0.13)
    if kit.chance(0.3):
        head.rods([(0.6, 0.5, 0.5), (-0.6, 0.9, 0.8)], [0.09, 0.05], fur(kit, (0.8, 0.6, 0.1), pattern=PLAIN))
    out = rng.uniform(0.05, 0.35)
    kit.add(BALL, (-0.02, fat * 1.02 + out * 0.45, 0.58), (0.11, 0.035, 0.3), rotation=turn("x", np.degrees(np.arctan2(out, 0.45))), material=back, mirror=True)
    kit.add(BALL, (0.1, 0.12, 0.03), (0.16, 0.09, 0.035), material=orange, mirror=True)
    kit.add(CYL, (0, 0.11, 0.1), (0.07, 0.07, 0.08), material=front, mirror=True)
    sail(kit, (-fat * 0.7, 0, 0.3), (-fat - 0.08, 0.07, 0.03), (-fat - 0.08, -0.07, 0.03), 0.03, back)


def owl(kit):
    rng = kit.rng
    coat = fur(kit, BROWN, WHITE, GREY, TAN, pattern=rng.choice([SPECKLES, CAMOUFLAGE, BANDS]), frequency=rng.uniform(14, 26))
    disc = fur(kit, CREAM, WHITE, TAN, pattern=PLAIN)
    chest = fur(kit, CREAM, TAN, WHITE, pattern=SPECKLES, frequency=rng.uniform(12, 24), second=BROWN)
    z = 0.9
    kit.add(BALL, (-0.02, 0, z + 0.4), (0.27, 0.28, 0.44), rotation=turn("y", 8), material=coat)
    kit.add(BALL, (0.07, 0, z + 0.36), (0.22, 0.22, 0.35), rotation=turn("y", 8), material=chest)
    folded_wing(kit, (0.02, 0.25, z + 0.68), (-0.28, 0.16, z - 0.08), 0.18, 0.06, coat, fur(kit, BROWN, DARK, pattern=BANDS, frequency=25, second=CREAM))
    kit.between((-0.12, 0, z + 0.15), (-0.3, 0, z - 0.2), (0.04, 0.13), BOX, 0.9, coat)
    head = Head(kit, (0.03, 0, z + 0.86), turn("z", rng.normal(0, 35)), 0.27)
    head.ball((0, 0, 0), (0.9, 1.08, 0.88), coat)
    head.ball((0.5, 0.4, 0), (0.42, 0.47, 0.6), disc, True, (0, 0))
    iris = kit.material(base=ORANGE if kit.chance(0.4) else (0.8, 0.55, 0.03), pattern=PLAIN, gloss=0.6)
    head.eyes(0.86, 0.38, 0.12, 0.15, iris if kit.chance(0.8) else None)
    kit.between(head.place(0.8, 0, 0.05), head.place(0.98, 0, -0.35), 0.045, CYL, 0.2, fur(kit, DARK, GREY, pattern=PLAIN, gloss=0.3))
    if kit.chance(0.55):
        head.rods([(0.1, 0.6, 0.6), (0, 0.85, 1.25)], [0.25, 0.04], coat)
    foot = fur(kit, CREAM, TAN, pattern=PLAIN)
    kit.chain([(0.05, 0.11, z + 0.1), (0.08, 0.11, z)], 0.075, foot, mirror=True)
    for y in (0.07, 0.15):
        kit.add(BALL, (0.13, y, z), (0.08, 0.028, 0.035), material=foot, mirror=True)
    perch(kit, z)


def parrot(kit):
    rng = kit.rng
    hues = rng.choice([0.0, 0.02, 0.13, 0.3, 0.36, 0.55, 0.62], 3)
    body, wing, tail = (kit.material(base=paint(h, rng.uniform(0.75, 1), rng.uniform(0.25, 0.75)), pattern=PLAIN, second=(0.1, 0.1, 0.1), gloss=0.1) for h in hues)
    if kit.chance(0.2):
        body = wing = tail = fur(kit, WHITE, GREY, pattern=PLAIN)
    z, lean = 0.95, rng.uniform(10, 35)
    along = turn("y", lean) @ np.array([0, 0, 1.0])
    centre = np.array([0.0, 0, z + 0.27])
    kit.add(BALL, centre, (0.19, 0.18, 0.34), rotation=turn("y", lean), material=body)
    neck = centre + along * 0.3
    head = Head(kit, neck + along * 0.13 + [0.05, 0, 0.03], looking(kit, 5), 0.145)
    hull(kit, [neck, head.at], [0.145, 0.125], body, first=False)
    head.ball((0, 0, 0), (1.1, 0.92, 1), body)
    head.ball((0.5, 0.5, -0.05), (0.45, 0.4, 0.45), fur(kit, WHITE, pattern=PLAIN) if kit.chance(0.5) else wing, True)
    hooked(head, fur(kit, DARK, CREAM, BLACK, pattern=PLAIN, gloss=0.4), 0.4, 0.45)
    head.eyes(0.62, 0.78, 0.18, 0.13)
    if kit.chance(0.35):
        for k in range(3):
            head.rods([(0.2 - 0.3 * k, 0, 0.8), (-0.5 - 0.4 * k, 0, 1.9 - 0.3 * k)], [0.2, 0.06], wing, both=False)
    folded_wing(kit, centre + along * 0.2 + [0, 0.15, 0], centre - along * 0.5 + [-0.08, 0.09, 0], 0.13, 0.06, wing, kit.material(base=paint(hues[1] + 0.1, 0.9, 0.4), pattern=PLAIN))
    long = rng.uniform(0.35, 0.95)
    for y in (0, 0.05, -0.05):
        kit.between(centre - along * 0.24 + [-0.02, y, 0], centre - along * (0.3 + long) + [-0.06, y * 1.4, 0], (0.02, 0.055), BOX, 0.5, tail)
    foot = fur(kit, GREY, PINK, pattern=PLAIN)
    kit.chain([centre + [0.03, 0.08, -0.2], (0.02, 0.08, z)], 0.035, foot, mirror=True)
    kit.add(BALL, (0.05, 0.08, z), (0.07, 0.03, 0.03), material=foot, mirror=True)
    perch(kit, z)


def eagle(kit):
    rng = kit.rng
    coat = fur(kit, DARK, BROWN, RED, GREY, pattern=CLOUDY)
    top = fur(kit, WHITE, pattern=PLAIN) if kit.chance(0.5) else coat
    quills = fur(kit, DARK, BROWN, pattern=rng.choice([PLAIN, BANDS]), frequency=18)
    yellow = kit.material(base=(0.75, 0.5, 0.06), pattern=PLAIN, gloss=0.3)
    if kit.chance(0.6):
        z, lift, ahead = 0.62, rng.uniform(-0.1, 0.75), rng.uniform(0.0, 0.2)
        lean = rng.uniform(-5, 30)
        kit.add(BALL, (0, 0, z), (0.42, 0.17, 0.17), rotation=turn("y", -lean), material=coat)
        fore = turn("y", -lean) @ np.array([0.42, 0, 0.02]) + [0, 0, z]
        head = Head(kit, fore + [0.1, 0, 0.03], looking(kit, 10, 15), 0.105)
        hull(kit, [fore - [0.12, 0, 0.02], head.at], [0.13, 0.1], top, first=False)
        rear = turn("y", -lean) @ np.array([-0.35, 0, 0.0]) + [0, 0, z]
        for angle in np.linspace(-22, 22, 5):
            way = turn("y", -lean) @ turn("z", angle) @ np.array([-0.38, 0, 0])
            kit.between(rear, rear + way, (0.014, 0.05), BOX, 1.3, top)
        root = np.array([0.12, 0.1, z + 0.06])
        spread_wing(kit, root, root + [0.12 + ahead, 0.5, lift * 0.6], root + [-0.05 + ahead, 1.2, lift + 0.1], 0.42, coat, quills, 6)
        kit.chain([(-0.08, 0.08, z - 0.1), (-0.02, 0.09, z - 0.28)], [0.07, 0.045], coat, mirror=True)
        for y in (0.06, 0.12):
            kit.between((-0.02, 0.09, z - 0.28), (0.08, y, z - 0.36), 0.02, CYL, 0.3, yellow, mirror=True)
    else:
        z = 0.9
        kit.add(BALL, (-0.02, 0, z + 0.35), (0.22, 0.21, 0.4), rotation=turn("y", 20), material=coat)
        head = Head(kit, (0.19, 0, z + 0.82), looking(kit, 5), 0.125)
        hull(kit, [(0.08, 0, z + 0.55), head.at], [0.17, 0.11], top, first=False)
        folded_wing(kit, (0.08, 0.2, z + 0.66), (-0.38, 0.1, z - 0.2), 0.15, 0.06, coat, quills)
        kit.between((-0.14, 0, z + 0.12), (-0.36, 0, z - 0.32), (0.03, 0.1), BOX, 1.1, top if kit.chance(0.5) else coat)
        kit.chain([(0.0, 0.11, z + 0.18), (0.02, 0.11, z + 0.06)], [0.11, 0.06], coat, mirror=True)
        for y in (0.07, 0.11, 0.15):
            kit.between((0.0, 0.11, z + 0.03), (0.14, y, z), 0.025, CYL, 0.5, yellow, mirror=True)
        perch(kit, z)
    head.ball((0, 0, 0), (1.2, 0.85, 0.95), top)
    hooked(head, yellow, 0.5, 0.42)
    head.eyes(0.6, 0.68, 0.2, 0.14)


def wader(kit):
    rng = kit.rng
    kind = rng.choice(["heron", "flamingo", "stork", "ostrich"])
    coat, quills, leg_colour, beak = {
        "heron": ((GREY, (0.35, 0.4, 0.45), WHITE), (DARK, GREY), (TAN, DARK), (ORANGE, TAN)),
        "flamingo": (((0.85, 0.35, 0.3), (0.8, 0.5, 0.45)), ((0.75, 0.15, 0.12), PINK), (PINK, (0.8, 0.35, 0.3)), (CREAM, BLACK)),
        "stork": ((WHITE,), (BLACK,), ((0.6, 0.1, 0.04),), ((0.6, 0.1, 0.04),)),
        "ostrich": ((BLACK, BROWN), (WHITE, CREAM), (PINK, CREAM), (PINK, CREAM)),
    }[kind]
    coat, quills, shank, beak = fur(kit, *coat), fur(kit, *quills, pattern=PLAIN), fur(kit, *leg_colour, pattern=PLAIN), fur(kit, *beak, pattern=PLAIN)
    big = kind == "ostrich"
    tall = rng.uniform(0.75, 1.0) if not big else 0.95
    fat = 0.21 if not big else 0.33
    long = 0.36 if not big else 0.46
    centre = np.array([0, 0, tall + fat * 0.8])
    kit.add(BALL, centre, (long, fat * 0.9, fat), rotation=turn("y", -14), material=coat)
    fore = centre + [long * 0.75, 0, fat * 0.4]
    hull(kit, [centre + [-long * 0.4, 0, 0], centre + [-long * 1.2, 0, -fat * 0.25]], [fat * 0.65, fat * 0.2], quills, 0.8, first=False)
    skin = shank if big else coat
    down = rng.random()
    if kind == "flamingo" and down < 0.3:
        path = [fore, fore + [0.25, 0, 0.12], fore + [0.42, 0, -0.2], fore + [0.42, 0, -0.6], fore + [0.45, 0, -0.9]]
    elif big or down < 0.5 and kind != "heron":
        path = [fore, fore + [0.14, 0, 0.1], fore + [0.16, 0, 0.4], fore + [0.12, 0, 0.75 if big else 0.6]]
    else:
        path = [fore, fore + [0.14, 0, 0.12], fore + [0.02, 0, 0.3], fore + [-0.04, 0, 0.5], fore + [0.08, 0, 0.66]]
    neck = 0.045 if not big else 0.06
    hull(kit, [centre + [long * 0.4, 0, 0], *path], [fat * 0.7, fat * 0.38, neck * 1.3, *[neck] * (len(path) - 2)], skin, first=False)
    head = Head(kit, path[-1] + np.array([0.03, 0, 0.02]), looking(kit, 70 if path[-1][2] < fore[2] else 5), 0.072)
    head.ball((0, 0, 0), (1.4, 0.9, 0.9), skin)
    if kind == "flamingo":
        kit.chain([head.place(1, 0, 0), head.place(2.2, 0, -0.5)], [0.045, 0.04], beak)
        kit.between(head.place(2.2, 0, -0.5), head.place(2.7, 0, -1.6), 0.04, CYL, 0.3, black(kit))
    else:
        far, deep = (2.6, 0.055) if big else (rng.uniform(4.2, 5.5), 0.035)
        kit.between(head.place(0.8, 0, 0), head.place(far, 0, -0.25), (deep * 0.7, deep), CYL, 0.15, beak)
    head.eyes(0.5, 0.75, 0.3, 0.25)
    if kind == "heron" and kit.chance(0.7):
        head.rods([(-0.5, 0, 0.5), (-3.2, 0, -0.1)], [0.25, 0.06], quills, both=False)
    shoulder = fore + [-0.06, fat * 0.72, -0.02]
    folded_wing(kit, shoulder, centre + [-long * 1.15, fat * 0.45, -fat * 0.1], fat * 0.62, fat * 0.3, coat, quills)
    thick = 0.022 if not big else 0.042
    if big:
        kit.add(BALL, (0, 0.16, tall - 0.08), (0.14, 0.1, 0.26), material=shank, mirror=True)
    else:
        kit.add(BALL, (0.02, 0.08, tall - 0.02), (0.08, 0.065, 0.16), material=coat, mirror=True)
    y = 0.09 if not big else 0.16
    one = kind != "ostrich" and kit.chance(0.3)
    toes = [-0.2, 0.2] if big else [-0.55, 0, 0.55]
    for side in (1, -1):
        hip, heel, foot = np.array([0.02, y * side, tall]), np.array([-0.06, y * side, tall * 0.5]), np.array([0.02, y * side, thick])
        if one:
            foot = np.array([0.02, 0.0, thick]) if side > 0 else np.array([0.1, -0.02, tall * 0.78])
            heel = np.array([0, 0.03, tall * 0.5]) if side > 0 else np.array([-0.2, -y, tall * 0.7])
        hull(kit, [hip, heel, foot], [thick * 1.3, thick * 1.1, thick], shank)
        for angle in toes:
            kit.between(foot, foot + np.array([0.16 * np.cos(angle), 0.16 * np.sin(angle), -thick * 0.4]), thick * 0.8, CYL, 0.6, shank)


def swan(kit):
    rng = kit.rng
    goose = kit.chance(0.4)
    coat = fur(kit, BLACK if kit.chance(0.15) else WHITE, GREY if goose else WHITE, pattern=PLAIN)
    beak = kit.material(base=ORANGE, pattern=PLAIN)
    tall = rng.uniform(0.14, 0.25) if goose or kit.chance(0.4) else 0.0
    z = tall + 0.25
    kit.add(BALL, (0, 0, z), (0.58, 0.3, 0.28), rotation=turn("y", -5), material=coat)
    kit.add(BALL, (0.25, 0, z), (0.32, 0.26, 0.27), material=coat)
    kit.between((-0.4, 0, z + 0.05), (-0.78, 0, z + 0.16), (0.13, 0.18), CYL, 0.2, coat)
    rise = rng.uniform(0.35, 0.5) if goose else rng.uniform(0.6, 0.8)
    path = [(0.4, 0, z + 0.05), (0.66, 0, z + 0.22), (0.58, 0, z + 0.5 * rise + 0.1), (0.48, 0, z + 0.8 * rise + 0.1), (0.56, 0, z + rise + 0.14), (0.68, 0, z + rise + 0.14)]
    hull(kit, path, [0.2, 0.12, 0.082, 0.068, 0.065, 0.07], coat, first=False)
    head = Head(kit, path[-1], looking(kit, 22, 15), 0.085)
    head.ball((0.2, 0, 0.05), (1.3, 0.9, 0.95), coat)
    kit.between(head.place(0.9, 0, 0), head.place(2.9, 0, -0.35), (0.05, 0.055), CYL, 0.5, beak)
    head.ball((1.15, 0, 0.3), (0.5, 0.45, 0.4), black(kit) if not goose else beak)
    head.eyes(0.8, 0.72, 0.3, 0.16)
    raised = not goose and kit.chance(0.4)
    up = 0.28 if raised else 0.1
    folded_wing(kit, (0.25, 0.25, z + up), (-0.72, 0.13, z + up + 0.14), 0.26 if raised else 0.2, 0.08, coat, fur(kit, GREY, BROWN) if goose else coat)
    if tall:
        bird_legs(kit, (-0.05, 0.13, z - 0.15), (-0.08, 0.13, tall * 0.6), (-0.02, 0.13, 0.025), 0.028, beak if goose else black(kit))
        kit.add(BOX, (0.06, 0.13, 0.015), (0.1, 0.09, 0.012), (1, 1), material=beak if goose else black(kit), mirror=True)


def rooster(kit):
    hen = kit.chance(0.35)
    coat = plumage(kit, RED, WHITE, BLACK, BROWN, TAN)
    neck = coat if kit.chance(0.3) else fur(kit, ORANGE, TAN, RED)
    sickle = fur(kit, (0.02, 0.06, 0.05), BLACK, WHITE, pattern=PLAIN, gloss=0.3) if not hen else coat
    comb = kit.material(base=(0.55, 0.03, 0.03), pattern=PLAIN)
    yellow = kit.material(base=(0.65, 0.42, 0.1), pattern=PLAIN)
    z = 0.52
    kit.add(BALL, (0, 0, z), (0.34, 0.23, 0.25), rotation=turn("y", -12), material=coat)
    kit.add(BALL, (0.2, 0, z + 0.02), (0.2, 0.2, 0.23), material=coat)
    high = 0.32 if hen else 0.45
    path = [(0.18, 0, z + 0.08), (0.3, 0, z + high * 0.6), (0.33, 0, z + high)]
    hull(kit, path, [0.22, 0.13, 0.09], neck, 0.9, first=False)
    head = Head(kit, (0.37, 0, z + high + 0.04), looking(kit, 5), 0.09)
    head.ball((0, 0, 0), (1.1, 0.85, 0.95), neck if kit.chance(0.5) else comb)
    kit.between(head.place(0.8, 0, 0), head.place(1.9, 0, -0.3), 0.035, CYL, 0.1, yellow)
    for x, up in ((0.8, 0.8), (0.4, 1.1), (-0.05, 1.15), (-0.5, 0.95), (-0.85, 0.6))[: 3 if hen else 5]:
        head.ball((x, 0, 0.6 + up * 0.35), (0.24, 0.12, up * (0.3 if hen else 0.6)), comb)
    head.ball((0.65, 0.25, -0.95), (0.2, 0.14, 0.3 if hen else 0.55), comb, True)
    head.eyes(0.5, 0.72, 0.25, 0.17)
    folded_wing(kit, (0.2, 0.21, z + 0.1), (-0.35, 0.17, z - 0.02), 0.15, 0.06, neck if kit.chance(0.4) else coat, fur(kit, DARK, RED, WHITE))
    count = 5 if hen else 6
    for k in range(count):
        share = k / (count - 1)
        y = (0.07 if k % 2 else -0.07) * (0.3 + share)
        if hen:
            kit.between((-0.22, y, z + 0.1), (-0.5, y, z + 0.2 + 0.2 * share), (0.02, 0.06), BOX, 0.7, sickle)
        else:
            reach = np.array([-0.3 - 0.22 * share, y, 0.42 - 0.05 * share])
            root = np.array([-0.24, y * 0.5, z + 0.1])
            top, end = root + reach * (0.8 + 0.2 * share), root + reach + [-0.25, y * 0.5, -0.1 - 0.3 * share]
            kit.chain([root, top], [0.055, 0.05], sickle)
            kit.between(top, end, 0.05, CYL, 0.35, sickle)
    kit.chain([(0, 0.1, z - 0.14), (0.02, 0.11, z - 0.28)], [0.11, 0.06], coat, mirror=True)
    bird_legs(kit, (0.02, 0.11, z - 0.25), (-0.03, 0.11, z * 0.4), (0.03, 0.11, 0.025), 0.022, yellow)


def peacock(kit):
    rng = kit.rng
    white = kit.chance(0.1)
    blue = fur(kit, WHITE if white else (0.02, 0.07, 0.4), pattern=PLAIN, gloss=0.2)
    green = fur(kit, WHITE if white else (0.03, 0.22, 0.1), pattern=STREAKS, second=(0.1, 0.2, 0.05) if not white else CREAM)
    wing = fur(kit, CREAM, TAN, pattern=BANDS, frequency=30, second=BROWN)
    eye = kit.material(base=(0.02, 0.1, 0.3), pattern=PLAIN) if not white else blue
    grey, z = fur(kit, GREY, pattern=PLAIN), 0.5
    kit.add(BALL, (0, 0, z), (0.3, 0.17, 0.18), rotation=turn("y", -18), material=blue)
    hull(kit, [(0.15, 0, z + 0.05), (0.3, 0, z + 0.25), (0.3, 0, z + 0.5)], [0.15, 0.075, 0.05], blue, first=False)
    head = Head(kit, (0.34, 0, z + 0.54), looking(kit, 8, 15), 0.065)
    head.ball((0, 0, 0), (1.2, 0.85, 0.9), blue)
    kit.between(head.place(0.9, 0, 0), head.place(2.0, 0, -0.3), 0.025, CYL, 0.1, grey)
    folded_wing(kit, (0.15, 0.15, z + 0.08), (-0.32, 0.1, z), 0.11, 0.05, wing, fur(kit, BROWN, RED))
    kit.chain([(0, 0.08, z - 0.1), (-0.04, 0.08, 0.25), (0.02, 0.08, 0.02)], [0.05, 0.022, 0.02], grey, mirror=True)
    kit.add(BOX, (0.07, 0.08, 0.012), (0.09, 0.05, 0.012), material=grey, mirror=True)
    if kit.chance(0.75):
        root, back, far = np.array([-0.2, 0, z + 0.02]), rng.uniform(0.05, 0.3), rng.uniform(0.95, 1.2)
        count = 13
        for k, angle in enumerate(np.radians(np.linspace(-98, 98, count))):
            way = np.array([-back * np.cos(angle * 0.7), np.sin(angle), np.cos(angle)])
            side = np.cross(way, [1.0, 0, 0])
            frame = np.stack([side / np.linalg.norm(side), np.cross(way / np.linalg.norm(way), side / np.linalg.norm(side)), way / np.linalg.norm(way)], 1)
            kit.add(BALL, root + way * far * 0.54, (0.15, 0.015 + 0.004 * (k % 2), far * 0.5), rotation=frame, material=green)
            kit.add(BALL, root + way * far * 0.9, (0.075, 0.03, 0.085), rotation=frame, material=eye)
    else:
        tip = np.array([-1.5, 0, 0.08])
        kit.add(BALL, (-0.75, 0, z * 0.65), (0.68, 0.17, 0.1), rotation=turn("y", -18), material=green)
        for y in np.linspace(-0.2, 0.2, 5):
            kit.between((-0.25, y * 0.3, z), tip + [0, y, 0], (0.02, 0.04), BOX, 1.4, green)
            kit.add(BALL, tip + [0.1, y, 0.03], (0.08, 0.045, 0.03), material=eye)
    for k in (-1, 0, 1):
        head.rods([(-0.1, 0.1 * k, 0.7), (-0.4 + 0.1 * abs(k), 0.5 * k, 2.2)], [0.07, 0.16], blue, both=False)
    head.ball((0.6, 0.6, -0.1), (0.4, 0.3, 0.3), fur(kit, WHITE, pattern=PLAIN), True)
    head.eyes(0.65, 0.7, 0.2, 0.17)
