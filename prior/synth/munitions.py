"""Makers of bombs, missiles, torpedoes, shells, mines, boxes, cans, drums and crates."""


import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .launchers import SERVICE, band, drab, fins, metal, missile, timber
from .layout import BALL, BOX, CYL, TUBE
from .materials import BANDS, CLOUDY, PLAIN, PLANKS, SEAMS, STREAKS, WRITING
from .wheeled import glazing


def support(kit, low, long, radius, kind):
    """What carries a body of `radius` whose lowest line lies at z = `low`: cradles, blocks or a trolley, from -long to long."""
    rng = kit.rng
    wood, steel, dark = timber(kit), drab(kit) if kit.chance(0.6) else kit.material(), kit.material(dark=True)
    wide = radius * 1.15
    saddle = low + radius * 0.3
    for x in (-0.55, 0.5):
        material = wood if kind == "blocks" else steel
        kit.add(BOX, (x * long, 0, low * 0.55), (long * 0.06, wide, low * 0.5), material=material)
        kit.add(BOX, (x * long, wide * 0.85, saddle), (long * 0.06, wide * 0.18, radius * 0.36), material=material, mirror=True)
    if kind == "cradle":
        kit.add(BOX, (0, wide * 0.8, 0.08 * radius), (long * 0.75, wide * 0.14, 0.1 * radius), material=steel, mirror=True)
    elif kind == "trolley":
        size = low * 0.42
        for x in (-0.55, 0.5):
            kit.add(CYL, (x * long, wide * 1.05, size), (size, size, radius * 0.16), rotation=ALONG_Y, material=dark, mirror=True)
            kit.add(CYL, (x * long, 0, size), (size * 0.35, size * 0.35, wide * 1.2), rotation=ALONG_Y, material=steel)
        kit.add(BOX, (0, 0, low * 0.6), (long * 0.7, wide * 0.4, low * 0.18), material=steel)
        kit.between((long * 0.68, 0, low * 0.6), (long * rng.uniform(1.15, 1.4), 0, low * rng.choice([0.3, 1.2])), radius * 0.09, material=steel)


def casing(kit):
    """Paint of bombs and missiles."""
    rng = kit.rng
    base = [[0.14, 0.17, 0.08], [0.3, 0.33, 0.34], [0.7, 0.7, 0.68], [0.4, 0.36, 0.24], [0.08, 0.09, 0.1], [0.1, 0.2, 0.32]][rng.integers(6)]
    base = np.array(base) * rng.uniform(0.7, 1.3)
    return kit.material(base=base, pattern=rng.choice([PLAIN, PLAIN, PLAIN, STREAKS, CLOUDY, SEAMS]), second=base * 0.6, gloss=rng.uniform(0, 0.35))


def bomb(kit):
    """Fat bombs with box fins or a ring, or guided ones with wings, on blocks, a cradle or a trolley, or standing."""
    rng = kit.rng
    radius = 0.4
    long = radius * rng.uniform(4.5, 8.0)
    low = radius * rng.uniform(0.5, 1.2)
    upright = kit.chance(0.15)
    frame = turn("y", -90) if upright else np.eye(3)
    axis = frame @ ALONG_X
    out = axis[:, 2]
    skin = casing(kit)
    tail = np.zeros(3) if upright else np.array([-long / 2, 0, low + radius])
    kind = rng.choice(["box", "ring", "cross", "guided"])
    fat = rng.uniform(0.35, 0.5)
    kit.add(CYL, tail + out * long * (0.32 + fat) / 2, (radius, radius, long * (fat - 0.32) / 2 + long * 0.12), rotation=axis, material=skin)
    ogive = long * (0.88 - (fat + 0.12))
    kit.add(BALL, tail + out * long * (fat + 0.12), (radius, radius, ogive), rotation=axis, material=skin)
    cone = long * 0.2
    kit.add(CYL, tail + out * cone / 2, (radius * 0.45, radius * 0.45, cone / 2), (2.2, 1), rotation=axis, material=skin)
    fuse = kit.material(base=[0.5, 0.4, 0.2], pattern=PLAIN, gloss=0.4)
    kit.add(CYL, tail + out * (long * (fat + 0.12) + ogive), (radius * 0.16, radius * 0.16, radius * 0.2), (0.6, 1), rotation=axis, material=fuse)
    fin = casing(kit) if kit.chance(0.4) else skin
    span = radius * (1.0 if kind in ("box", "ring") else 1.7)
    fins(kit, tail + out * cone * 0.4, axis, span, cone * 1.0, fin, 45 if not upright else 0, rng.uniform(0.75, 1.0), 0.03 * radius + 0.005)
    if kind == "box":
        for k in range(4):
            side = axis @ turn("z", 90 * k)
            kit.add(BOX, tail + out * cone * 0.25 + side[:, 0] * span * 0.7, (0.018, span * 0.72, cone * 0.38), rotation=side, material=fin)
    elif kind == "ring":
        kit.add(TUBE, tail + out * cone * 0.25, (span, span, cone * 0.4), rotation=axis, material=fin)
    elif kind == "guided":
        head = radius * 0.5
        kit.add(CYL, tail + out * long * 0.88, (head, head, long * 0.08), (0.75, 1), rotation=axis, material=kit.material(dark=True))
        kit.add(BALL, tail + out * long * 0.96, (head * 0.75, head * 0.75, head * 0.8), rotation=axis, material=glazing(kit))
        fins(kit, tail + out * long * 0.86, axis, radius * 1.2, long * 0.07, fin, 45 if not upright else 0, 0.5)
    for share in rng.uniform(0.3, fat + 0.1, int(rng.integers(0, 3))):
        kit.add(CYL, tail + out * long * share, (radius * 1.012, radius * 1.012, 0.05), rotation=axis, material=band(kit))
    if not upright:
        for share in (0.36, 0.5):
            kit.add(TUBE, tail + out * long * share + [0, 0, radius * 1.08], (0.09, 0.09, 0.025), rotation=ALONG_Y, material=fuse)
        support(kit, low, long * 0.42, radius, rng.choice(["blocks", "cradle", "trolley"]))


def slender(kit):
    """Air-to-air and air-defence missiles and torpedoes on cradles or trolleys."""
    rng = kit.rng
    skin = casing(kit)
    radius = 0.25
    long = radius * rng.uniform(11, 20)
    low = radius * rng.uniform(1.8, 2.8)
    tail = np.array([-long / 2, 0, low + radius])
    if kit.chance(0.6):
        tip = kit.material(base=rng.choice([[0.75, 0.73, 0.68], [0.08, 0.08, 0.08], [0.5, 0.35, 0.2]]), pattern=PLAIN)
        missile(kit, tail, np.eye(3), long, radius, skin, tip if kit.chance(0.6) else skin, skin if kit.chance(0.6) else casing(kit), spin=45)
        if kit.chance(0.35):
            boost = radius * rng.uniform(1.15, 1.5)
            low -= boost - radius
            kit.add(CYL, tail + [-long * 0.14, 0, 0], (boost, boost, long * 0.15), rotation=ALONG_X, material=skin)
            fins(kit, tail + [-long * 0.22, 0, 0], ALONG_X, boost * 2.2, long * 0.1, skin, 45)
    else:
        body = long * 0.8
        kit.add(CYL, (0, 0, low + radius), (radius, radius, body / 2), rotation=ALONG_X, material=skin)
        kit.add(BALL, (body / 2, 0, low + radius), (radius * 1.1, radius, radius), material=kit.material(dark=True) if kit.chance(0.4) else band(kit))
        kit.add(CYL, (-body / 2 - long * 0.06, 0, low + radius), (radius * 0.35, radius * 0.35, long * 0.06), (2.85, 1), rotation=ALONG_X, material=skin)
        fins(kit, (-body / 2 - long * 0.05, 0, low + radius), ALONG_X, radius * 1.05, long * 0.08, skin, 0, 0.9)
        brass = kit.material(base=[0.45, 0.28, 0.08], pattern=PLAIN, gloss=0.5)
        for k in range(5):
            blade = ALONG_X @ turn("z", 72 * k)
            place = np.array([-body / 2 - long * 0.125, 0, low + radius]) + blade[:, 0] * radius * 0.4
            kit.add(BOX, place, (radius * 0.45, radius * 0.16, 0.012), rotation=blade @ turn("x", 35), material=brass)
        kit.add(CYL, (-body / 2 - long * 0.13, 0, low + radius), (radius * 0.22, radius * 0.22, radius * 0.3), rotation=ALONG_X, material=brass)
    for share in rng.uniform(-0.4, 0.3, int(rng.integers(1, 4))):
        kit.add(CYL, (share * long, 0, tail[2]), (radius * 1.015, radius * 1.015, 0.06), rotation=ALONG_X, material=band(kit))
    support(kit, low, long * 0.42, radius, rng.choice(["blocks", "cradle", "trolley", "trolley"]))


def cruise(kit):
    """Cruise missiles: a long body with wings spread or folded, tail planes, an intake below or above, on a trolley or cradle."""
    rng = kit.rng
    skin, dark = casing(kit), kit.material(dark=True)
    radius, long = 0.27, rng.uniform(3.6, 5.0)
    low = radius * rng.uniform(1.8, 2.6)
    z = low + radius
    if kit.chance(0.6):
        kit.add(CYL, (0, 0, z), (radius, radius, long * 0.4), rotation=ALONG_X, material=skin)
        kit.add(BALL, (long * 0.4, 0, z), (long * 0.1, radius, radius), material=skin if kit.chance(0.6) else dark)
        kit.add(CYL, (-long * 0.45, 0, z), (radius * 0.65, radius * 0.65, long * 0.06), (1.5, 1), rotation=ALONG_X, material=skin)
    else:
        kit.add(BOX, (0, 0, z), (long * 0.4, radius * 1.05, radius), (1, 0.75), material=skin)
        kit.add(BOX, (long * 0.46, 0, z - radius * 0.15), (radius * 0.85, radius * 1.0, long * 0.06), (0.25, 0.4), (radius * 0.3, 0), rotation=ALONG_X, material=skin)
        kit.add(BOX, (-long * 0.43, 0, z), (radius * 0.9, radius * 0.85, long * 0.04), (0.7, 0.8), rotation=turn("y", -90), material=skin)
    if kit.chance(0.65):
        span, sweep = rng.uniform(1.1, 1.9), rng.uniform(0, 35)
        for y in (-1, 1):
            wing = turn("z", y * sweep)
            middle = np.array([0.05, y * radius * 0.5, z + radius * 0.3]) + wing @ np.array([0, y * span * 0.5, 0])
            kit.add(BOX, middle, (0.17, span / 2, 0.025), rotation=wing, material=skin)
    else:
        kit.add(BOX, (-0.35, radius * 0.55, z - radius * 0.8), (0.8, 0.06, 0.03), material=dark, mirror=True)
        kit.add(BOX, (-0.35, radius * 0.8, z + radius * 0.62), (0.75, 0.05, 0.16), material=skin, mirror=True)
    tail = -long * 0.41
    height = rng.uniform(0.4, 0.65)
    kit.add(BOX, (tail, 0, z + height / 2), (0.17, 0.02, height / 2), (0.55, 1), (-0.1, 0), material=skin)
    kit.add(BOX, (tail, 0, z), (height * 1.1, 0.02, 0.17), (0.6, 1), rotation=ALONG_X @ turn("z", 90), material=skin)
    below = -1 if kit.chance(0.7) else 1
    kit.add(BOX, (-long * 0.2, 0, z + below * radius * 1.05), (0.45, radius * 0.55, radius * 0.35), (0.9, 0.9), material=skin)
    kit.add(BOX, (-long * 0.2 + 0.44, 0, z + below * radius * 1.1), (0.03, radius * 0.45, radius * 0.26), material=dark)
    kit.add(CYL, (-long * 0.5, 0, z), (radius * 0.45, radius * 0.45, 0.06), rotation=ALONG_X, material=dark)
    if kit.chance(0.6):
        kit.add(BOX, (long * 0.15, 0, z), (0.35, radius * 1.06, 0.07), material=kit.material(base=skin.first, pattern=WRITING, frequency=25, second=[0.03] * 3))
    for at in rng.uniform(-0.3, 0.3, int(rng.integers(0, 2))):
        kit.add(CYL, (at * long, 0, z), (radius * 1.02, radius * 1.02, 0.04), rotation=ALONG_X, material=band(kit))
    support(kit, low, long * 0.36, radius, rng.choice(["cradle", "trolley", "trolley"]))


def shells(kit):
    """Shells and cartridges standing in rows, lying stacked, or one alone; mortar bombs with fins."""
    rng = kit.rng
    skin, brass = casing(kit), kit.material(base=[0.5, 0.33, 0.1], pattern=PLAIN, gloss=0.55)
    stripe, fuse = band(kit), kit.material(base=[0.55, 0.5, 0.4], pattern=PLAIN, gloss=0.5)
    radius, high = 0.16, rng.uniform(0.7, 1.1)
    kind = rng.choice(["plain", "cartridge", "mortar"])
    rows, cols = [(1, 1), (1, 3), (2, 3), (2, 4), (1, 5), (3, 3)][rng.integers(6)]
    lying = kit.chance(0.35) and kind != "mortar" and rows * cols > 1
    places = [(0, (c - (cols - 1) / 2) * 2.05, 0) for c in range(cols)] if lying else [(r * 2.4, (c - (cols - 1) / 2) * 2.4, 0) for r in range(rows) for c in range(cols)]
    if lying:
        places += [(0, (c - (cols - 2) / 2) * 2.05, 1.76) for c in range(cols - 1)]
    frame = ALONG_X if lying else np.eye(3)
    for place in places[:9]:
        foot = np.array(place) * radius + ([0, 0, radius] if lying else [0, 0, 0])
        if kind == "mortar":
            kit.loft(foot, [(0, radius * 0.35), (high * 0.35, radius * 0.4), (high * 0.5, radius), (high * 0.62, radius), (high * 0.95, radius * 0.35)], skin)
            for k in (0, 60, 120):
                kit.add(BOX, foot + [0, 0, high * 0.12], (radius * 0.95, 0.01, high * 0.12), rotation=turn("z", k), material=skin)
        else:
            shell = foot
            if kind == "cartridge":
                kit.add(CYL, foot + frame @ np.array([0, 0, high * 0.5]), (radius * 1.05, radius * 1.05, high * 0.5), (0.92, 1), rotation=frame, material=brass)
                shell = foot + frame @ np.array([0, 0, high * 0.95])
            body = high * (0.55 if kind == "plain" else 0.25)
            kit.add(CYL, shell + frame @ np.array([0, 0, body / 2]), (radius, radius, body / 2), rotation=frame, material=skin)
            kit.add(BALL, shell + frame @ np.array([0, 0, body]), (radius, radius, high * 0.5), rotation=frame, material=skin)
            kit.add(CYL, shell + frame @ np.array([0, 0, body + high * 0.47]), (radius * 0.35, radius * 0.35, high * 0.07), (0.5, 1), rotation=frame, material=fuse)
            kit.add(CYL, shell + frame @ np.array([0, 0, body * 0.9]), (radius * 1.02, radius * 1.02, 0.025), rotation=frame, material=stripe)
            if kind == "plain":
                kit.add(CYL, shell + frame @ np.array([0, 0, high * 0.09]), (radius * 1.04, radius * 1.04, 0.03), rotation=frame, material=brass)
    if kit.chance(0.4) and not lying:
        spots = np.array(places)
        half = (np.ptp(spots[:, :2], axis=0) / 2 + 1.4) * radius
        kit.add(BOX, (*(spots[:, :2].max(0) + spots[:, :2].min(0)) / 2 * radius, -0.04), (*half, 0.045), material=timber(kit))


def mines(kit):
    """Flat land mines, sea mines with horns on a sinker or alone."""
    rng = kit.rng
    skin, dark = casing(kit), kit.material(dark=True)
    if kit.chance(0.65):
        radius = 0.8
        stand = rng.choice(["sinker", "stand", "none"])
        low = {"sinker": 0.75, "stand": 0.35, "none": 0.0}[stand]
        hub = np.array([0, 0, low + radius])
        shell = rng.choice([BALL, BALL, BALL, CYL])
        kit.add(BALL, hub, (radius, radius, radius), material=skin)
        if shell == CYL:
            kit.add(CYL, hub, (radius * 0.98, radius * 0.98, radius * 0.3), material=skin)
        kit.add(CYL, hub, (radius * 1.02, radius * 1.02, 0.03), material=skin if kit.chance(0.5) else dark)
        kit.add(CYL, hub + [0, 0, radius * 0.97], (0.24, 0.24, 0.05), material=dark)
        horn = dark if kit.chance(0.5) else band(kit)
        spots = [(45, k) for k in range(0, 360, 60)] + [(-35, k + 30) for k in range(0, 360, 90)] + ([(5, k) for k in range(30, 390, 60)] if kit.chance(0.6) else [])
        first = rng.uniform(0, 60)
        for up, spin in spots:
            out = turn("z", spin + first) @ turn("y", -up) @ np.array([1.0, 0, 0])
            kit.between(hub + out * radius * 0.95, hub + out * (radius + 0.2), 0.065, taper=0.75, material=horn)
            if len(spots) < 12:
                kit.between(hub + out * radius * 0.95, hub + out * (radius + 0.05), 0.11, material=skin)
        for k in (0, 90):
            kit.add(TUBE, hub + turn("z", k) @ np.array([0.35, 0, 0]) + [0, 0, radius * 0.97], (0.1, 0.1, 0.025), rotation=turn("z", k) @ ALONG_Y, material=dark)
        if stand == "sinker":
            kit.add(BOX, (0, 0, 0.42), (0.7, 0.6, 0.42), (0.95, 0.95), material=kit.material(base=rng.uniform(0.1, 0.4) * np.ones(3), pattern=STREAKS))
            for x in (-0.5, 0.5):
                kit.add(CYL, (x, 0.62, 0.14), (0.14, 0.14, 0.06), rotation=ALONG_Y, material=dark, mirror=True)
        elif stand == "stand":
            kit.add(CYL, (0, 0, 0.22), (0.55, 0.55, 0.22), (0.85, 1), material=dark)
    else:
        radius, high = rng.uniform(0.4, 0.6), rng.uniform(0.1, 0.2)
        for k in range(int(rng.integers(1, 5))):
            spot = np.array([(k % 2) * 2.2 * radius, (k // 2) * 2.2 * radius, 0])
            kit.add(CYL, spot + [0, 0, high / 2], (radius, radius, high / 2), (0.97, 1), material=skin)
            kit.add(CYL, spot + [0, 0, high], (radius * 0.72, radius * 0.72, high * 0.2), (0.9, 1), material=skin)
            kit.add(CYL, spot + [0, 0, high * 1.3], (radius * 0.25, radius * 0.25, high * 0.25), material=dark)
            for x, y in around(6, radius * 0.45):
                kit.add(BOX, spot + [x, y, high * 1.2], (radius * 0.07, radius * 0.07, 0.02), material=dark)
            kit.add(TUBE, spot + [radius * 1.08, 0, high * 0.6], (0.1, 0.13, 0.015), material=dark)


def boxes(kit):
    """Stacked ammunition boxes of wood or metal, with battens, handles, latches and lettering; an open one."""
    rng = kit.rng
    wooden = kit.chance(0.55)
    base = np.array([0.42, 0.29, 0.14] if wooden and kit.chance(0.5) else SERVICE[rng.integers(len(SERVICE))]) * rng.uniform(0.7, 1.3)
    skin = kit.material(base=base, pattern=PLANKS if wooden else rng.choice([PLAIN, STREAKS]), frequency=rng.uniform(8, 16), second=base * 0.5)
    batten, dark = kit.material(base=base * 0.8, pattern=PLAIN), metal(kit, 0.03, 0.15)
    text = kit.material(base=base, pattern=WRITING, frequency=rng.uniform(12, 25), second=rng.choice([[0.75, 0.7, 0.4], [0.02, 0.02, 0.02], [0.8, 0.8, 0.8]]))
    half = np.array([rng.uniform(0.22, 0.3), rng.uniform(0.4, 0.65), rng.uniform(0.15, 0.28)]) if wooden else np.array([0.15, 0.3, 0.26])
    spots = [[(0, 0)], [(0, 0), (0, 1)], [(0, 0), (1, 0)], [(0, 0), (1, 0), (0.5, 1)], [(0, 0), (1, 0), (0, 1), (1, 1)], [(0, 0), (0, 1), (0, 2)]][rng.integers(6)]
    for row, level in spots:
        jitter = turn("z", rng.uniform(-6, 6) if level else 0)
        at = np.array([row * 2.15 * half[0], 0, half[2] * (1 + 2.12 * level)])
        kit.add(BOX, at, half, rotation=jitter, material=skin)
        kit.add(BOX, at + jitter @ np.array([half[0] + 0.004, 0, -half[2] * 0.1]), (0.006, half[1] * 0.55, half[2] * 0.5), rotation=jitter, material=text)
        kit.add(BOX, at + [0, 0, half[2] * 0.62], (half[0] * 1.02, half[1] * 1.02, 0.008), rotation=jitter, material=dark)
        for y in (-0.72, 0.72):
            if wooden:
                kit.add(BOX, at + jitter @ np.array([0, y * half[1], 0]), (half[0] * 1.07, 0.045, half[2] * 1.05), rotation=jitter, material=batten)
            else:
                kit.add(BOX, at + jitter @ np.array([0, np.sign(y) * (half[1] + 0.01), half[2] * 0.5]), (0.06, 0.02, half[2] * 0.35), rotation=jitter, material=dark)
        for y in (-1, 1):
            if wooden:
                kit.add(BOX, at + jitter @ np.array([0, y * (half[1] + 0.025), 0.0]), (half[0] * 0.55, 0.025, 0.03), rotation=jitter, material=batten)
            elif y > 0:
                kit.add(BOX, at + [0, 0, half[2] + 0.04], (0.02, half[1] * 0.45, 0.012), rotation=jitter, material=dark)
                kit.add(BOX, at + jitter @ np.array([0, -half[1] * 0.42, half[2] + 0.02]), (0.015, 0.015, 0.03), rotation=jitter, material=dark)
                kit.add(BOX, at + jitter @ np.array([0, half[1] * 0.42, half[2] + 0.02]), (0.015, 0.015, 0.03), rotation=jitter, material=dark)


def jerry_cans(kit):
    """Jerry cans with three handles, ribs pressed into the sides and a slanting spout, one or a row."""
    rng = kit.rng
    count = int(rng.choice([1, 1, 2, 3, 4]))
    skin, dark = drab(kit) if kit.chance(0.7) else kit.material(pattern=PLAIN), kit.material(dark=True)
    rib = kit.material(base=skin.first * 0.6, pattern=PLAIN)
    for k in range(count):
        y = (k - (count - 1) / 2) * 0.38
        paint = skin if kit.chance(0.8) else drab(kit)
        kit.add(BOX, (0, y, 0.42), (0.34, 0.16, 0.42), material=paint)
        kit.add(BOX, (0, y, 0.42), (0.35, 0.012, 0.43), material=rib)
        kit.add(BOX, (-0.1, y, 0.87), (0.24, 0.155, 0.05), (0.9, 0.95), material=paint)
        for side in (-0.11, 0, 0.11):
            kit.between((-0.24, y + side, 0.99), (0.1, y + side, 0.99), 0.024, material=paint)
        for x in (-0.24, 0.1):
            kit.add(BOX, (x, y, 0.94), (0.025, 0.135, 0.06), material=paint)
        kit.between((0.2, y, 0.82), (0.34, y, 0.98), 0.075, material=paint)
        kit.between((0.33, y, 0.97), (0.38, y, 1.02), 0.085, material=dark)
        for lean in (-1, 1):
            kit.add(BOX, (0, y, 0.42), (0.38, 0.168, 0.02), rotation=turn("y", lean * 45), material=rib)


def drums(kit):
    """Drums with hoops on a pallet, standing or lying."""
    rng = kit.rng
    wood = timber(kit)
    low = 0.0
    count = int(rng.integers(1, 5))
    spots = [(-0.31, -0.31), (0.31, 0.31), (-0.31, 0.31), (0.31, -0.31)][:count] if count > 1 else [(0.0, 0.0)]
    if kit.chance(0.65):
        low = 0.29
        for x in np.linspace(-0.6, 0.6, 5):
            kit.add(BOX, (x, 0, 0.26), (0.11, 0.7, 0.03), material=wood)
        for y in (-0.6, 0, 0.6):
            kit.add(BOX, (0, y, 0.2), (0.7, 0.07, 0.03), material=wood)
            kit.add(BOX, (0, y, 0.03), (0.7, 0.07, 0.03), material=wood)
            for x in (-0.6, 0, 0.6):
                kit.add(BOX, (x, y, 0.115), (0.09, 0.07, 0.06), material=wood)
    hoops = kit.chance(0.5)
    for x, y in spots:
        skin = kit.material(pattern=rng.choice([PLAIN, PLAIN, STREAKS, BANDS]), frequency=3) if kit.chance(0.6) else drab(kit)
        kit.add(CYL, (x, y, low + 0.44), (0.29, 0.29, 0.44), material=skin)
        rim = kit.material(base=skin.first * 0.8, pattern=PLAIN)
        for z in (0.02, 0.3, 0.58, 0.87):
            kit.add(CYL, (x, y, low + z), (0.302, 0.302, 0.016), material=rim)
        kit.add(CYL, (x + 0.16, y, low + 0.895), (0.05, 0.05, 0.02), material=kit.material(dark=True))
        if hoops:
            kit.add(BOX, (x, y, low + 0.44), (0.294, 0.1, 0.1), material=kit.material(base=[0.8, 0.75, 0.6], pattern=WRITING, frequency=20, second=[0.03] * 3))


def dropped_crate(kit):
    """A crate on a skid board under a parachute with lines, or with the chute packed on top."""
    rng = kit.rng
    skin = timber(kit) if kit.chance(0.4) else drab(kit)
    strap, half = kit.material(dark=True) if kit.chance(0.5) else band(kit), np.array([rng.uniform(0.5, 0.8), rng.uniform(0.5, 0.7), rng.uniform(0.4, 0.65)])
    kit.add(BOX, (0, 0, 0.06), (half[0] * 1.1, half[1] * 1.1, 0.06), material=timber(kit))
    kit.add(BOX, (0, 0, 0.12 + half[2]), half, material=skin)
    for share in (-0.5, 0.5):
        kit.add(BOX, (share * half[0], 0, 0.12 + half[2]), (0.05, half[1] * 1.02, half[2] * 1.02), material=strap)
        kit.add(BOX, (0, share * half[1], 0.12 + half[2]), (half[0] * 1.02, 0.05, half[2] * 1.02), material=strap)
    top = 0.12 + 2 * half[2]
    cloth = kit.material(base=rng.choice([[0.75, 0.75, 0.7], [0.2, 0.22, 0.1], [0.7, 0.25, 0.05]]), pattern=rng.choice([PLAIN, SEAMS, CLOUDY]))
    if kit.chance(0.65):
        radius, rise = rng.uniform(1.5, 2.2), rng.uniform(2.2, 3.4)
        second = kit.material(base=rng.uniform(0.1, 0.8, 3), pattern=PLAIN) if kit.chance(0.4) else cloth
        dome = [(0, radius), (radius * 0.3, radius * 0.95), (radius * 0.55, radius * 0.78), (radius * 0.72, radius * 0.5), (radius * 0.8, radius * 0.12)]
        for k, ((z0, r0), (z1, r1)) in enumerate(zip(dome[:-1], dome[1:], strict=True)):
            kit.add(TUBE, (0, 0, top + rise + (z0 + z1) / 2), (r0, r0, (z1 - z0) / 2), (r1 / r0, 1), material=second if k % 2 else cloth)
        knot = np.array([0, 0, top + 0.5])
        for x, y in around(12, radius):
            kit.between(knot, (x, y, top + rise), 0.012, material=strap)
        for x, y in ((1, 1), (-1, 1)):
            kit.between((x * half[0] * 0.95, y * half[1] * 0.95, top), knot, 0.02, material=strap, mirror=True)
    else:
        kit.add(BOX, (0, 0, top + 0.16), (half[0] * 0.6, half[1] * 0.6, 0.17), (0.8, 0.8), material=cloth)
        for spin in (0, 90):
            kit.add(BOX, (0, 0, top + 0.17), (half[0] * 0.64, 0.04, 0.18), (0.8, 1), rotation=turn("z", spin), material=strap)


def munition(kit):
    """Bombs, missiles, torpedoes, cruise missiles, shells, land and sea mines, ammunition boxes, jerry cans, drums, dropped crates."""
    makers = [bomb, slender, cruise, shells, mines, boxes, jerry_cans, drums, dropped_crate]
    makers[kit.rng.choice(9, p=[0.17, 0.17, 0.12, 0.1, 0.12, 0.1, 0.07, 0.08, 0.07])](kit)
