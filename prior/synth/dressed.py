"""Makers of people in all sorts of clothes and poses."""


import numpy as np

from .belongings import black, brass, ribbon, steel, timber
from .bodies import HIP
from .figures import ARMS, bar, dress_up, face_on, figure, hair_on, hat_on, plain
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL
from .materials import CAMOUFLAGE, CHECKER, PLAIN, STRIPES, paint
from .soldiers import rifle


def coat(kit, f, material, low, wide=0.2, open_front=None):
    """A coat's skirts from the waist to `low` metres below the hips."""
    f.part(CYL, (0, 0, 0.14 - (0.14 + low) / 2), (wide * 0.85, wide * 1.05, (0.14 + low) / 2), material, (0.72, 1))
    if open_front is not None:
        f.part(BOX, (wide * 0.68, 0, 0.14 - (0.14 + low) / 2), (0.03, 0.03, (0.14 + low) / 2), open_front, tilt=turn("y", -8))


def lapels(f, shirt, tie, jacket):
    f.part(BOX, (0.105, 0, 0.42), (0.03, 0.05, 0.11), shirt, (1, 1.2), turn("y", -12))
    f.part(BOX, (0.137, 0, 0.36), (0.012, 0.02, 0.15), tie, (1, 0.6), turn("y", -6))
    f.part(BOX, (0.125, 0.06, 0.4), (0.018, 0.026, 0.12), jacket, (1, 0.8), turn("x", -14) @ turn("y", -10), mirror=True)


def chair(kit, legs):
    """Something to sit on below a seated figure: chair, stool, bench or block."""
    if legs != "sit":
        return
    made, kind = timber(kit) if kit.chance(0.6) else kit.material(), kit.rng.choice(["chair", "stool", "block"])
    kit.add(BOX, (0.0, 0, 0.385), (0.23, 0.23, 0.03), material=made)
    if kind == "block":
        kit.add(BOX, (0.0, 0, 0.18), (0.2, 0.21, 0.18), material=made)
        return
    for x in (0.19, -0.19):
        kit.add(BOX, (x, 0.19, 0.18), (0.022, 0.022, 0.18), material=made, mirror=True)
    if kind == "chair":
        kit.add(BOX, (-0.22, 0.19, 0.6), (0.02, 0.02, 0.24), material=made, mirror=True)
        kit.add(BOX, (-0.22, 0, 0.74), (0.018, 0.2, 0.12), material=made)


def everyday(kit):
    """Somebody in plain clothes, a suit, a dress or a long robe; a child; somebody old with a stick."""
    rng, kind = kit.rng, kit.rng.choice(["casual", "casual", "suit", "dress", "robe", "child", "old"])
    legs = rng.choice(["stand", "rest", "walk", "run", "sit", "ground", "squat", "kneel"], p=[0.2, 0.18, 0.16, 0.08, 0.18, 0.08, 0.06, 0.06])
    if kind in ("robe", "dress", "old") and legs in ("run", "ground", "squat", "kneel"):
        legs = "stand"
    if kind == "robe":
        legs = "stand"
    standing = legs in ("stand", "rest", "walk")
    arms = rng.choice(["hang", "hips", "crossed", "raised", "up", "wave", "point", "behind", "carry", "pockets"]) if standing else "knees" if legs != "run" else "run"
    arms = "walk" if legs == "walk" and kit.chance(0.6) else arms
    wear = dress_up(kit, bare=(int(rng.choice([0, 1, 1, 2])), int(rng.choice([0, 0, 1]))))
    if kind == "suit":
        cloth_ = plain(kit, paint(rng.choice([0.6, 0.08]), rng.uniform(0, 0.5), rng.uniform(0.02, 0.3)))
        wear.__dict__.update(top=cloth_, bottom=cloth_, sleeve=cloth_, bare=(0, 0), shoes=black(kit), woman=kit.chance(0.2))
    elif kind in ("dress", "robe"):
        wear.__dict__.update(woman=kind == "dress" or kit.chance(0.6), fat=0, bare=(wear.bare[0], 2))
        if kit.chance(0.7):
            wear.bottom = wear.top
    elif kind == "child":
        wear.__dict__.update(head=rng.uniform(1.25, 1.6), woman=False)
    elif kind == "old":
        wear.hair = plain(kit, [0.6, 0.6, 0.58])
    hands = [(0.04, 0.27, -0.04), (0.28, 0.26, -0.02)] if kind == "old" and standing else None
    lean = {"run": 14, "squat": 18, "walk": 4, "kneel": 6}.get(legs, rng.uniform(-1, 3)) + (12 if hands else 0)
    f = figure(kit, wear, legs, arms, lean, robe=rng.uniform(0.04, 0.3) if kind == "robe" else 0, hands=hands, size=0.68 if kind == "child" else 1.0, flipped=False if hands else None)
    if hands:
        right = f.hands[1]
        kit.between((right[0] + 0.02, right[1], 0), right + [0, 0, 0.02], 0.014, material=timber(kit))
    if kind == "suit":
        lapels(f, plain(kit, [0.8, 0.8, 0.82]), kit.material(), wear.top)
        if standing:
            coat(kit, f, wear.top, 0.14, 0.19)
    elif kind == "dress" and standing:
        low, wide = rng.uniform(0.25, 0.7), rng.uniform(0.22, 0.42)
        kit.loft((0, 0, 0), [(HIP - low, wide), (HIP + 0.12, 0.12)], wear.bottom, flat=1.08)
    elif kind == "dress":
        f.part(BALL, (0.2, 0, -0.03), (0.33, 0.22, 0.12), wear.bottom)
    elif kit.chance(0.4):
        f.part(CYL, (0, 0, 0.07), (0.122 + wear.fat, 0.168 * wear.wide + wear.fat * 0.5, 0.02), kit.material(dark=True))
    if kit.chance(0.3):
        hat_on(kit, f.head, rng.choice(["cap", "brim", "beanie", "scarf", "turban"]), kit.material(pattern=PLAIN), wear.hair)
    else:
        hair_on(f.head, rng, rng.choice(["long", "bob", "tail", "bun", "part"]) if wear.woman else rng.choice(["short", "short", "quiff", "rim", "bald"]), wear.hair)
    chair(kit, legs)
    if kit.chance(0.2) and legs != "sit":
        f.part(BOX, (-0.19, 0, 0.32), (0.09, 0.15, 0.2), kit.material(), (0.85, 0.85))
    face_on(kit, f, wear)


def worker(kit):
    """A worker in overalls, a police officer, a doctor, a cook, or a monk."""
    rng, kind = kit.rng, kit.rng.choice(["worker", "police", "doctor", "cook", "monk"])
    legs, arms = rng.choice(["stand", "rest", "walk"]), rng.choice(["hang", "hips", "crossed", "behind", "carry", "point", "wave"])
    wear, vivid = dress_up(kit), plain(kit, paint(rng.choice([0.03, 0.08, 0.13, 0.2, 0.6]), rng.uniform(0.6, 1), rng.uniform(0.3, 0.9)))
    white, dark = plain(kit, [0.78, 0.78, 0.78]), plain(kit, paint(0.62, 0.5, rng.uniform(0.02, 0.12)))
    hat = {"worker": "hard", "police": "peaked", "cook": "none", "doctor": "none", "monk": "none"}[kind]
    if kind == "worker":
        wear.__dict__.update(bottom=plain(kit, paint(rng.choice([0.6, 0.08, 0.07]), 0.6, rng.uniform(0.08, 0.5))), shoes=black(kit))
    elif kind == "police":
        wear.__dict__.update(top=dark, bottom=dark, sleeve=dark, shoes=black(kit))
    elif kind in ("doctor", "cook"):
        wear.__dict__.update(top=white, sleeve=white, bottom=wear.bottom if kind == "doctor" else kit.material(pattern=CHECKER, frequency=20.0))
    else:
        brown = plain(kit, rng.choice([[0.16, 0.09, 0.05], [0.6, 0.2, 0.03], [0.05, 0.05, 0.05], [0.5, 0.45, 0.35]]))
        wear.__dict__.update(top=brown, bottom=brown, sleeve=brown, woman=False)
        arms, legs = rng.choice(["pray", "crossed", "hang"]), "stand"
    f = figure(kit, wear, legs, arms, rng.uniform(-1, 4), robe=0.05 if kind == "monk" else 0)
    if kind == "worker":
        f.part(BOX, (0.115, 0, 0.3), (0.03, 0.1, 0.13), wear.bottom, (1, 0.85))
        f.part(BOX, (0.06, 0.09, 0.48), (0.08, 0.02, 0.02), wear.bottom, tilt=turn("y", 22), mirror=True)
        if kit.chance(0.6):
            f.part(CYL, (0.005, 0, 0.32), (0.135, 0.185 * wear.wide, 0.17), vivid, (1.0, 1))
            f.part(CYL, (0.005, 0, 0.24), (0.137, 0.187 * wear.wide, 0.025), plain(kit, [0.75, 0.76, 0.7]))
        hat_on(kit, f.head, hat, vivid, wear.hair)
        if kit.chance(0.5):
            hand_, made = f.hands[0], timber(kit)
            kit.between(hand_ - [0, 0, 0.12], hand_ + [0.02, 0, 0.2], 0.015, material=made)
            kit.add(BOX, hand_ + [0.02, 0, 0.21], (0.07, 0.025, 0.025), material=steel(kit))
    elif kind == "police":
        f.part(CYL, (0, 0, 0.06), (0.125, 0.175 * wear.wide, 0.03), black(kit))
        f.part(BOX, (0.02, -0.185 * wear.wide, -0.02), (0.05, 0.025, 0.08), black(kit))
        f.part(BOX, (0.128, 0.08, 0.42), (0.012, 0.025, 0.03), brass(kit))
        if kit.chance(0.5):
            f.part(BALL, (0.012, 0, 0.33), (0.14, 0.18, 0.2), black(kit))
        hat_on(kit, f.head, hat, dark, wear.hair)
    elif kind == "doctor":
        coat(kit, f, white, rng.uniform(0.3, 0.5), 0.215, wear.bottom)
        f.part(BOX, (0.115, 0, 0.44), (0.03, 0.045, 0.09), kit.material(), (1, 1.3), turn("y", -12))
        ribbon(kit, [f.place(f.high(0.1, 0.06, 0.54)), f.place(f.high(0.15, 0.05, 0.36)), f.place(f.high(0.155, 0.0, 0.3))], (0.012, 0.012), black(kit))
        hair_on(f.head, rng, rng.choice(["short", "bun", "tail", "part"]), wear.hair)
    elif kind == "cook":
        f.part(BOX, (0.12, 0, -0.12), (0.03, 0.14, 0.24), white, (1, 0.8))
        for y in (0.035, -0.035):
            for z in (0.3, 0.38, 0.46):
                f.part(BALL, (0.132, y, z), (0.012,) * 3, black(kit))
        f.head(BALL, (-0.26, 0, 0.2), (0.74, 0.73, 0.7), wear.hair)
        f.head(CYL, (-0.1, 0, 0.85), (0.78, 0.72, 0.35), white)
        f.head(BALL, (-0.1, 0, 1.4), (1.0, 0.95, 0.42), white)
    else:
        f.part(CYL, (0, 0, 0.1), (0.125, 0.16, 0.02), plain(kit, [0.6, 0.5, 0.3]))
        if kit.chance(0.6):
            hat_on(kit, f.head, "hood", wear.top, wear.hair)
        else:
            hair_on(f.head, rng, rng.choice(["rim", "bald"]), wear.hair)
    face_on(kit, f, wear)


def soldier(kit):
    rng = kit.rng
    base = np.array([0.2, 0.19, 0.11]) * rng.uniform(0.4, 1.8)
    camo = kit.material(base=base, pattern=CAMOUFLAGE if kit.chance(0.75) else PLAIN, frequency=rng.uniform(10, 22), gloss=0.02, second=base * rng.uniform(0.3, 0.6))
    vest, legs = plain(kit, base * rng.uniform(0.5, 1.1)), rng.choice(["stand", "rest", "walk", "kneel"])
    wear = dress_up(kit, top=camo, bottom=camo, woman=False, shoes=plain(kit, [0.08, 0.06, 0.04]), flare=0.75, fat=0)
    if kit.chance(0.5):
        wear.gloves = black(kit)
    how = rng.choice(["aim", "ready", "slung"])
    hands = {"aim": [(0.5, -0.02, 0.46), (0.24, 0.12, 0.44)], "ready": [(0.3, 0.08, 0.32), (0.17, 0.14, 0.16)], "slung": ARMS[rng.choice(["hang", "hips", "wave"])]}[how]
    f = figure(kit, wear, legs, "hang", rng.uniform(0, 6), hands=hands, look=turn("y", 4), flipped=False)
    f.part(BOX, (0.012, 0, 0.33), (0.14, 0.165, 0.17), vest, (0.92, 0.9))
    ends = {"aim": ((0.08, -0.15, 0.5), (0.95, 0.03, 0.52)), "ready": ((0.16, -0.27, 0.08), (0.3, 0.34, 0.52)), "slung": ((-0.27, -0.22, 0.0), (-0.17, 0.2, 0.78))}[how]
    hat_on(kit, f.head, rng.choice(["helmet", "helmet", "beret", "cap"]), camo if kit.chance(0.7) else vest, wear.hair)
    rifle(kit, f.place(f.high(*ends[0])), f.place(f.high(*ends[1])))
    if how != "slung":
        f.part(BOX, (-0.22, 0, 0.34), (0.1, 0.16, 0.22), vest, (0.9, 0.9))
    else:
        f.part(BOX, (-0.17, 0, 0.3), (0.06, 0.13, 0.14), vest)
    for y in (-0.09, 0.0, 0.09):
        f.part(BOX, (0.165, y, 0.22), (0.03, 0.038, 0.065), vest)
    face_on(kit, f, wear)


def fabled(kit):
    """A king with a cape, a cartoon hero, a knight in armour, or a robot of human shape."""
    rng, kind = kit.rng, kit.rng.choice(["king", "hero", "knight", "robot"])
    legs, arms = rng.choice(["stand", "rest", "walk"]), rng.choice(["hang", "hips", "raised", "carry", "crossed", "point"])
    if kind == "king":
        rich = plain(kit, paint(rng.choice([0.0, 0.62, 0.78, 0.35]), 0.85, rng.uniform(0.15, 0.5)), 0.15)
        wear = dress_up(kit, top=rich, woman=kit.chance(0.3))
        wear.bottom = rich if kit.chance(0.5) else wear.bottom
        f = figure(kit, wear, "stand", "hang", robe=0.05, hands=[(0.06, 0.26, 0.0), (0.25, 0.27, 0.18)], flipped=False)
        cape(kit, f, plain(kit, paint(rng.choice([0.0, 0.78, 0.6]), 0.9, 0.3), 0.05))
        f.part(BALL, (-0.01, 0, 0.54), (0.13, 0.2, 0.06), plain(kit, [0.8, 0.78, 0.72]))
        gold, right = brass(kit), f.hands[1]
        kit.between((right[0], right[1], 0.0 if kit.chance(0.5) else right[2] - 0.2), right + [0, 0, 0.4], 0.016, material=gold)
        kit.add(BALL, right + [0, 0, 0.42], (0.045,) * 3, material=gold)
        f.head(CYL, (-0.1, 0, 0.85), (0.78, 0.72, 0.16), gold, (1.1, 1))
        for x, y in around(5, 0.76):
            f.head(CYL, (-0.1 + x, y * 0.95, 1.15), (0.2, 0.2, 0.22), gold, (0.1, 1))
        f.head(BALL, (-0.26, 0, 0.15), (0.72, 0.75, 0.72), wear.hair)
        if not wear.woman:
            f.head(BALL, (0.42, 0, -0.9), (0.4, 0.48, 0.5), wear.hair)
        face_on(kit, f, wear)
    elif kind == "hero":
        suit = plain(kit, paint(rng.random(), 0.9, rng.uniform(0.3, 0.8)), 0.2)
        second = plain(kit, paint(rng.random(), 0.9, rng.uniform(0.2, 0.8)), 0.2)
        wear = dress_up(kit, top=suit, bottom=suit if kit.chance(0.6) else second, gloves=second, shoes=second, woman=False, flare=0.8)
        wear.head, wear.wide = rng.uniform(1.2, 2.2), rng.uniform(1.1, 1.45)
        f = figure(kit, wear, legs, arms)
        for p in f.hands:
            kit.add(BALL, p, (0.085, 0.075, 0.085), material=second)
        if kit.chance(0.6):
            cape(kit, f, second)
        f.part(CYL, (0, 0, 0.07), (0.125 + wear.fat, 0.172 * wear.wide + wear.fat * 0.5, 0.03), brass(kit))
        f.part(BOX, (0.13, 0, 0.4), (0.015, 0.06, 0.06), second, (1, 0.6))
        hair_on(f.head, rng, rng.choice(["short", "quiff", "mohawk", "part"]), wear.hair)
        if kit.chance(0.4):
            f.head(BALL, (0.12, 0, 0.03), (0.62, 0.6, 0.2), second)
        f.head(BALL, (0.66, 0.27, 0.03), (0.1, 0.16, 0.2), plain(kit, [0.85, 0.85, 0.85]), mirror=True)
        f.head(BALL, (0.74, 0.26, 0.02), (0.05, 0.08, 0.1), black(kit), mirror=True)
    else:
        metal = kit.material(base=np.ones(3) * rng.uniform(0.2, 0.65), pattern=PLAIN, gloss=0.55) if kind == "knight" or kit.chance(0.4) else kit.material(pattern=PLAIN, gloss=0.4)
        second = black(kit) if kind == "robot" else kit.material(base=metal.first * 0.6, pattern=PLAIN, gloss=0.4)
        wear = dress_up(kit, metal, sleeve=second if kind == "robot" else metal, woman=False, wide=rng.uniform(1.0, 1.2))
        hands = [(0.2, 0.2, 0.2), (0.25, 0.28, 0.15)] if kind == "knight" else None
        f = figure(kit, wear, legs, arms, hands=hands, look=np.eye(3), flipped=False)
        f.part(BALL, (0.0, 0.22 * wear.wide, 0.49), (0.1, 0.1, 0.09), metal, mirror=True)
        if kind == "knight":
            f.head(CYL, (0.02, 0, -0.05), (0.9, 0.78, 0.95), metal, (0.85, 1))
            f.head(BALL, (0.02, 0, 0.85), (0.78, 0.68, 0.4), metal)
            f.head(BOX, (0.86, 0, 0.12), (0.06, 0.55, 0.06), black(kit))
            f.head(BOX, (0.86, 0, -0.4), (0.06, 0.05, 0.5), second)
            right, left = f.hands[1], f.hands[0]
            kit.between(right - [0, 0, 0.1], right + [0, 0, 0.1], 0.02, material=timber(kit))
            kit.add(BOX, right + [0, 0, 0.11], (0.03, 0.13, 0.02), material=second)
            kit.between(right + [0, 0, 0.1], right + [0.1, 0, 1.0], (0.03, 0.012), BOX, 0.5, material=steel(kit))
            shield = kit.material(pattern=rng.choice([PLAIN, STRIPES, CHECKER]), frequency=3.0)
            kit.add(BOX, left + [0.06, 0.03, 0.06], (0.025, 0.22, 0.16), material=shield)
            kit.add(BOX, left + [0.06, 0.03, -0.26], (0.025, 0.22, 0.16), (1, 0.1), rotation=turn("x", 180), material=shield)
            for k in range(3 * int(kit.chance(0.6))):
                f.head(BALL, (-0.1 - 0.4 * k, 0, 1.5 - 0.22 * k), (0.35, 0.14, 0.3), shield)
            f.part(CYL, (0, 0, -0.08), (0.18, 0.22, 0.13), metal if kit.chance(0.5) else shield, (0.8, 1))
        else:
            f.head(BOX if kit.chance(0.5) else BALL, (0, 0, 0.1), (0.85, 0.78, 0.85), metal)
            glow = kit.material(base=paint(rng.choice([0.55, 0.0, 0.15]), 0.8, 0.9), pattern=PLAIN, gloss=-0.7)
            f.head(BALL, (0.78, 0.32, 0.2), (0.14, 0.17, 0.17), glow, mirror=True)
            f.head(BOX, (0.8, 0, -0.4), (0.07, 0.35, 0.1), second)
            f.part(BOX, (0.04, 0, 0.36), (0.13, 0.18, 0.15), metal, (1.0, 1.15))
            f.part(CYL, (0.17, 0, 0.38), (0.06, 0.06, 0.02), glow, tilt=ALONG_X)
            f.head(CYL, (-0.05, 0.8, 0.1), (0.22, 0.22, 0.12), second, tilt=ALONG_Y, mirror=True)
            if kit.chance(0.5):
                bar(f.head, (0, 0, 0.8), (0, 0, 1.7), 0.06, second)
                f.head(BALL, (0, 0, 1.75), (0.14,) * 3, glow)


def cape(kit, f, material):
    low = kit.rng.uniform(0.05, 0.35)
    kit.between(f.place((-0.25, 0, low)), f.place(f.high(-0.08, 0, 0.54)), (0.035, 0.36), BOX, 0.55, material=material)
    for y in (-0.26, -0.09, 0.09, 0.26):
        kit.between(f.place((-0.27, y, low + 0.01)), f.place(f.high(-0.09, y * 0.55, 0.52)), 0.05, taper=0.5, material=material)


def people_dressed(kit):
    """People in everyday and work clothes, soldiers, and kings, heroes, knights and robots, in many poses."""
    kit.bevel = max(kit.bevel, 0.25)
    makers = [everyday, worker, soldier, fabled]
    makers[kit.rng.choice(4, p=[0.42, 0.22, 0.16, 0.2])](kit)
