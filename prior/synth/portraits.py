"""Makers of heads and busts, half figures, hands, masks, skulls."""


import numpy as np

from .belongings import brass, cloth, steel, timber
from .bodies import bent
from .figures import bar, carved, features, hair_on, hat_on, head_frame, plain
from .kit import ALONG_X, towards, turn
from .layout import BALL, BOX, CYL, TUBE
from .materials import CLOUDY, PLAIN
from .people import hair_material, skin_material

HAIR = ["short", "short", "long", "long", "bob", "tail", "bun", "afro", "curls", "mohawk", "rim", "braids", "locks", "quiff", "part", "bald"]


HATS = ["cap", "brim", "beanie", "top", "helmet", "hard", "crown", "turban", "scarf", "hood", "headphones", "laurel", "peaked", "beret", "cowboy"]


def beard_on(part, rng, hair):
    kind = rng.choice(["full", "long", "goatee", "moustache"])
    if kind != "goatee":
        part(BALL, (0.72, 0.15, -0.41), (0.1, 0.2, 0.075), hair, tilt=turn("x", -18), mirror=True)
    if kind == "goatee":
        part(BALL, (0.62, 0, -0.86), (0.2, 0.22, 0.26), hair)
    elif kind != "moustache":
        low = -0.95 if kind == "full" else rng.uniform(-1.7, -1.25)
        part(BALL, (0.4, 0, (low - 0.45) / 2 - 0.06), (0.44, 0.5, (-0.45 - low) / 2 + 0.12), hair)
        part(BALL, (0.2, 0.5, -0.45), (0.26, 0.13, 0.4), hair, mirror=True)


def shoulders(kit, size, cloth_, skin, low, kind, woman):
    """Neck, shoulders and chest under a head at the origin, down to z = low (in half heads)."""
    at = head_frame(kit, np.zeros(3), size, np.eye(3))
    bar(at, (-0.22, 0, -1.75), (-0.08, 0, -0.35), 0.46, skin, 0.9)
    bust = cloth_ is skin
    at(BALL, (-0.15, 0, -2.05), (0.68, 1.5 if bust else 1.72, 0.55), cloth_)
    at(CYL, (-0.16, 0, -1.62), (0.68, 1.05, 0.32), cloth_, (0.62, 1))
    at(BALL, (-0.15, 1.1 if bust else 1.3, -2.27), (0.58, 0.66, 0.6), cloth_, mirror=True)
    if kind != "half" and not bust:
        bar(at, (-0.17, 1.72, low), (-0.15, 1.48, -2.25), 0.46, cloth_, mirror=True)
    deep = (-2.0 - low) / 2
    at(CYL, (-0.05, 0, low + deep), (0.7, 0.95, deep) if bust else (0.85, 1.35, deep), cloth_, (1.25 if bust else 1.0, 1))
    at(BALL, (0.12, 0, -2.65), (0.92, 1.3, min(0.85, -2.6 - low)), cloth_)
    if woman and low < -3.3:
        at(BALL, (0.55, 0.52, -2.95), (0.5, 0.53, 0.5), cloth_, mirror=True)
    return at


def collar(kit, at, cloth_, kind, stone):
    if kind == "suit":
        shirt = cloth_ if stone else plain(kit, [0.8, 0.8, 0.82])
        at(BOX, (0.7, 0, -2.45), (0.3, 0.3, 0.62), shirt, (1.4, 0.8), turn("y", -14))
        at(BOX, (0.98, 0, -2.6), (0.08, 0.12, 0.65), cloth_ if stone else kit.material(), (1, 0.6), turn("y", -12))
        at(BOX, (0.92, 0.34, -2.5), (0.08, 0.16, 0.72), cloth_, (1, 0.8), turn("x", -12) @ turn("y", -14), mirror=True)
        at(CYL, (-0.14, 0, -1.32), (0.55, 0.55, 0.18), shirt, (0.92, 1))
    elif kind == "polo":
        at(CYL, (-0.14, 0, -1.36), (0.6, 0.62, 0.17), cloth_, (0.9, 1), turn("y", 8))
    elif kind == "scarf":
        scarf = cloth_ if stone else cloth(kit)
        for z, r in ((-1.5, 0.72), (-1.28, 0.66)):
            at(BALL, (-0.12, 0, z), (r, r * 1.05, 0.2), scarf, tilt=turn("x", 8))
        at(BOX, (0.78, 0.35, -2.3), (0.14, 0.28, 0.75), scarf, tilt=turn("y", -16))
    elif kind == "necklace" and not stone:
        pearl = brass(kit) if kit.chance(0.5) else plain(kit, [0.8, 0.78, 0.72], 0.5)
        for k in range(7):
            a = np.radians(-66 + 22 * k)
            at(BALL, (-0.1 + 0.82 * np.cos(a), 0.75 * np.sin(a), -1.72 - 0.3 * np.cos(a)), (0.09,) * 3, pearl)


def glasses_on(kit, part):
    rim = kit.material(dark=kit.chance(0.7), pattern=PLAIN)
    lens = plain(kit, [0.02, 0.02, 0.025], 0.6) if kit.chance(0.4) else None
    if lens:
        part(CYL, (0.82, 0.28, 0.0), (0.19, 0.22, 0.025), lens, tilt=ALONG_X, mirror=True)
    else:
        part(TUBE, (0.82, 0.28, 0.0), (0.19, 0.22, 0.04), rim, tilt=ALONG_X, mirror=True)
    bar(part, (0.85, -0.08, 0.05), (0.85, 0.08, 0.05), 0.035, rim)
    bar(part, (0.8, 0.5, 0.05), (-0.02, 0.7, 0.08), 0.03, rim, mirror=True)


def likeness(kit):
    """A person's head and shoulders, a half figure, or a bust of stone on a plinth."""
    rng = kit.rng
    kind = rng.choice(["person", "person", "half", "bust", "bust"])
    stone, woman, size = kind == "bust", kit.chance(0.45), 1.0
    skin = carved(kit) if stone else skin_material(kit)
    hair, wear = (skin, skin) if stone else (hair_material(kit), cloth(kit) if kit.chance(0.7) else kit.material())
    low = -5.6 if kind == "half" else rng.uniform(-3.9, -2.9)
    at = shoulders(kit, size, skin if not stone and kit.chance(0.07) else wear, skin, low, kind, woman)
    facing = turn("z", rng.normal(0, 14)) @ turn("y", rng.normal(2, 5))
    part = head_frame(kit, np.zeros(3), size, facing)
    features(kit, part, skin, hair, stone, woman)
    if stone:
        flat = rng.choice([1.0, 0.75])
        kit.loft((0, 0, low - 1.5), [(0, 1.0), (0.3, 1.0), (0.45, 0.55), (1.1, 0.5), (1.5, 0.8)], skin if kit.chance(0.6) else carved(kit), flat=flat)
        if kit.chance(0.5):
            plinth, high = carved(kit), rng.uniform(0.5, 4)
            kit.add(BOX, (0, 0, low - 1.5 - high), (1.1, 1.1, high), material=plinth)
            kit.add(BOX, (0, 0, low - 1.55 - 2 * high), (1.35, 1.35, 0.25), material=plinth)
    style = rng.choice(HAIR) if not woman else rng.choice(["long", "bob", "tail", "bun", "curls", "braids", "part", "afro"])
    bearded = not woman and kit.chance(0.35)
    if bearded:
        beard_on(part, rng, hair)
    if kit.chance(0.38):
        hat = rng.choice(["laurel", "helmet", "crown", "scarf"] if stone else HATS)
        hat_on(kit, part, hat, skin if stone else cloth(kit) if hat in ("scarf", "turban", "beanie") else kit.material(pattern=PLAIN), hair, stone)
    else:
        hair_on(part, rng, style, hair)
    if kind == "half":
        pose = rng.choice(["hang", "crossed", "hips"])
        hands = {"hang": [(0.1, 1.9, -5.4)] * 2, "crossed": [(1.25, -0.5, -3.6), (1.3, -0.5, -3.9)], "hips": [(0.2, 1.3, -5.2)] * 2}[pose]
        at(CYL, (0, 0, -5.1), (0.82, 1.2, 0.9), wear, (0.95, 1))
        for side, hand in zip((1, -1), hands, strict=True):
            shoulder, hand = np.array([-0.15, side * 1.62, -2.25]), np.array(hand) * [1, side, 1]
            elbow, wrist = bent(shoulder, hand, 2.2, 2.0, np.array([-0.3, side * (1.2 if pose != "hang" else 0.3), -0.4]))
            kit.chain([shoulder, elbow, wrist], [0.5, 0.38, 0.3], wear)
            kit.add(BALL, wrist + (wrist - elbow) * 0.12, (0.3, 0.24, 0.4), rotation=towards(wrist - elbow), material=skin)
    if not stone and kit.chance(0.28):
        glasses_on(kit, part)
    collar(kit, at, wear, rng.choice(["suit", "polo", "scarf", "necklace", "none"]), stone)


def skull(kit):
    rng = kit.rng
    bone = kit.material(base=np.array([0.66, 0.58, 0.42]) * rng.uniform(0.6, 1.2), pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.1)
    hole = plain(kit, [0.02, 0.015, 0.012])
    part = head_frame(kit, np.zeros(3), 1.0, np.eye(3))
    drop = rng.uniform(0, 0.2)
    part(BALL, (-0.16, 0, 0.3), (0.86, 0.69, 0.7), bone)
    part(BALL, (0.28, 0, 0.12), (0.45, 0.56, 0.5), bone)
    part(CYL, (0.36, 0, -0.36), (0.33, 0.28, 0.3), bone, (1.15, 1))
    part(BALL, (0.5, 0.28, 0.26), (0.26, 0.28, 0.11), bone, tilt=turn("x", -8), mirror=True)
    part(BALL, (0.52, 0.27, 0.03), (0.24, 0.2, 0.19), hole, mirror=True)
    part(BALL, (0.45, 0.44, -0.22), (0.24, 0.14, 0.12), bone, mirror=True)
    bar(part, (0.4, 0.54, -0.2), (-0.25, 0.64, -0.12), 0.06, bone, mirror=True)
    part(CYL, (0.64, 0, -0.2), (0.08, 0.13, 0.16), hole, (0.35, 1))
    part(BALL, (0.71, 0, 0.08), (0.09, 0.07, 0.16), bone)
    bar(part, (-0.1, 0.5, -0.2), (0.0, 0.44, -0.75 - drop), (0.12, 0.05), bone, mirror=True, kind=BOX)
    bar(part, (0.0, 0.44, -0.75 - drop), (0.6, 0.17, -0.94 - drop), (0.11, 0.06), bone, mirror=True, kind=BOX)
    part(BALL, (0.58, 0, -0.92 - drop), (0.15, 0.25, 0.16), bone)
    part(BOX, (0.3, 0, -0.75 - drop * 0.5), (0.2, 0.2, 0.2 + drop), hole)
    for k in range(6):
        y = (k - 2.5) * 0.095
        for z in (-0.66, -0.82 - drop):
            part(BOX, (0.67 - y * y * 1.2, y, z), (0.04, 0.042, 0.07), bone)
    part(BALL, (-0.35, 0, -0.25), (0.5, 0.45, 0.3), bone)
    if kit.chance(0.5):
        kit.add(BOX, (0, 0, -1.17 - drop), (1.0, 0.8, 0.1), material=timber(kit))


def mask(kit):
    """A theatre, carved, carnival or hockey mask on a stand."""
    rng, kind = kit.rng, kit.rng.choice(["carved", "carnival", "hockey", "theatre"])
    face = timber(kit) if kind == "carved" else brass(kit) if kit.chance(0.2) else kit.material(pattern=PLAIN) if kit.chance(0.5) else plain(kit, [0.75, 0.73, 0.68], 0.3)
    trim, hole, long = kit.material(), plain(kit, [0.02, 0.015, 0.012]), 1.3 if kind == "carved" else 1.0
    part = head_frame(kit, np.zeros(3), 1.0, np.eye(3))
    part(BALL, (0, 0, 0.1), (0.5, 0.74, 0.95 * long), face)
    part(BALL, (0.07, 0, -0.4 * long), (0.44, 0.59, 0.6), face)
    slant = rng.uniform(-18, 18)
    part(BALL, (0.42, 0.3, 0.2), (0.1, 0.18, rng.uniform(0.06, 0.13)), hole, tilt=turn("z", -25) @ turn("x", slant), mirror=True)
    if kind == "hockey":
        for z in (0.8, 0.55, -0.25, -0.5, -0.75):
            for y in (0.12, 0.34):
                part(BALL, (0.48 * np.sqrt(max(0.05, 1 - (y / 0.74) ** 2 - ((z - 0.1) / 0.95) ** 2)) + (0.06 if z < 0 else 0), y, z), (0.06, 0.045, 0.045), hole, mirror=True)
        part(BOX, (0.38, 0, 0.85), (0.1, 0.1, 0.18), trim, (0.3, 0.2))
    else:
        beak = rng.uniform(0.1, 0.9) if kind == "carnival" else 0.12
        bar(part, (0.42, 0, 0.2), (0.55 + beak, 0, -0.2 - 0.3 * beak), 0.11, face, 0.5 if beak > 0.3 else 1.4)
        part(BALL, (0.42, 0.3, 0.38), (0.14, 0.24, 0.06), trim, tilt=turn("z", -25) @ turn("x", slant - 8), mirror=True)
        smile = rng.choice([-1, 1])
        part(BALL, (0.5, 0, -0.55), (0.1, 0.16, 0.07), hole)
        part(BALL, (0.44, 0.2, -0.55 + 0.06 * smile), (0.11, 0.15, 0.06), hole, tilt=turn("z", -20) @ turn("x", 28 * smile), mirror=True)
        if kind == "carved":
            part(BALL, (0.3, 0.45, -0.15), (0.1, 0.05, 0.3), trim, mirror=True)
            for k in range(5):
                bar(part, (0.1, 0.6 - 0.13 * k, 0.85 + 0.12 * k), (0.0, 0.95 - 0.22 * k, 1.6 + 0.12 * k), 0.09, trim, 0.3, mirror=True)
        elif kind == "carnival":
            for k in range(6):
                part(BALL, (0.0, 0.6 - 0.11 * k, 1.1 + 0.11 * k), (0.05, 0.13, 0.5), trim, tilt=turn("x", -50 + 9 * k), mirror=True)
    wood = timber(kit)
    kit.between((-0.2, 0, -2.2), (-0.1, 0, 0), 0.07, material=wood)
    kit.add(CYL, (-0.2, 0, -2.25), (0.65, 0.65, 0.1), material=wood)


def mannequin_head(kit):
    rng = kit.rng
    body = plain(kit, rng.choice([[0.75, 0.73, 0.7], [0.03, 0.03, 0.03], [0.6, 0.42, 0.32], [0.7, 0.7, 0.72]]), 0.3)
    part = head_frame(kit, np.zeros(3), 1.0, np.eye(3))
    if kit.chance(0.5):
        features(kit, part, body, body, True, True)
    else:
        part(BALL, (-0.1, 0, 0.3), (0.82, 0.66, 0.72), body)
        part(BALL, (0.16, 0, -0.2), (0.55, 0.53, 0.78), body)
        part(BALL, (0.66, 0, -0.18), (0.12, 0.1, 0.25), body)
    bar(part, (-0.2, 0, -2.0), (-0.08, 0, -0.3), 0.48, body, 0.85)
    part(CYL, (-0.2, 0, -2.1), (0.95, 1.1, 0.4), body, (0.5, 1))
    part(CYL, (-0.2, 0, -2.55), (0.98, 1.15, 0.08), steel(kit))
    if kit.chance(0.45):
        hair_on(part, rng, rng.choice(["long", "bob", "curls", "tail"]), hair_material(kit))
    elif kit.chance(0.6):
        hat_on(kit, part, rng.choice(["cap", "brim", "beanie", "headphones", "beret"]), kit.material(), body)


def hand(kit):
    """A hand and its wrist: open, a fist, pointing, thumb up, or two fingers up; of flesh, plaster or a robot's."""
    rng, pose = kit.rng, kit.rng.choice(["open", "open", "fist", "point", "thumb", "two", "loose"])
    skin = carved(kit) if kit.chance(0.3) else skin_material(kit)
    curls = {"open": (4,) * 4, "fist": (82,) * 4, "point": (5, 82, 82, 82), "thumb": (82,) * 4, "two": (4, 4, 82, 82), "loose": (18, 25, 32, 40)}[pose]
    side, spread = rng.choice([-1, 1]), rng.uniform(2, 7)
    kit.add(BALL, (0, 0, 0.45), (0.17, 0.43, 0.52), material=skin)
    kit.add(BOX, (0, 0, 0.52), (0.12, 0.36, 0.36), (1, 1.1), material=skin)
    kit.add(BALL, (0.09, side * 0.24, 0.3), (0.17, 0.2, 0.32), rotation=turn("x", side * -20), material=skin)
    kit.between((0, 0, -0.9), (0, 0, 0.15), (0.2, 0.27), material=skin)
    for k, curl in enumerate(curls):
        p, angle = np.array([0.0, side * (0.31 - 0.205 * k), 0.9 - 0.05 * abs(k - 1.2)]), 0
        lean = turn("x", -side * spread * (1.5 - k))
        thick, points = 0.105 - 0.008 * k, [p]
        for long in np.array([0.42, 0.28, 0.22]) * (0.95, 1.05, 0.98, 0.78)[k]:
            angle += curl
            p = p + lean @ np.array([np.sin(np.radians(angle)), 0, np.cos(np.radians(angle))]) * long
            points.append(p)
        kit.add(BALL, points[0], (thick * 1.08,) * 3, material=skin)
        kit.chain(points, thick * np.array([1, 0.93, 0.85, 0.75]), skin)
    root = np.array([0.1, side * 0.36, 0.3])
    tips = {"open": [(0.15, 0.62, 0.55), (0.17, 0.78, 0.82)], "loose": [(0.28, 0.52, 0.55), (0.36, 0.52, 0.85)], "thumb": [(0.1, 0.55, 0.65), (0.05, 0.56, 1.2)]}
    thumb = [root] + [np.array(t) * [1, side, 1] for t in tips.get(pose, [(0.42, 0.34, 0.55), (0.52, 0.02, 0.62)])]
    if pose == "thumb":
        thumb = [root, np.array([0.08, side * 0.6, 0.62]), np.array([0.04, side * 1.0, 0.66])]
    kit.chain(thumb, [0.15, 0.115, 0.085], skin)
    if kit.chance(0.5):
        kit.loft((0, 0, -1.3), [(0, 0.36), (0.75, 0.32)], cloth(kit))
    else:
        kit.loft((0, 0, -1.1), [(0, 0.5), (0.12, 0.5), (0.3, 0.28)], skin)
    if pose == "thumb":
        for i, p in enumerate(kit.primitives):
            kit.primitives[i] = p._replace(centre=turn("x", side * 90) @ p.centre, rotation=turn("x", side * 90) @ p.rotation)


def portrait(kit):
    """A head and shoulders close up, a half figure, a bust on a plinth, a hand, a mask, a mannequin's head, or a skull."""
    kit.bevel = max(kit.bevel, 0.3)
    makers = [likeness, skull, mask, mannequin_head, hand]
    makers[kit.rng.choice(5, p=[0.64, 0.09, 0.09, 0.07, 0.11])](kit)
