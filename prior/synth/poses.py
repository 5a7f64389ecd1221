"""A maker of single people of true anatomy, of any age, in many poses and clothes; of mannequins, scarecrows and statues."""

import numpy as np

from .figures import carved, hair_on, hat_on, plain
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, GRID, RUNGS
from .materials import BANDS, CLOUDY, DOTS, PLAIN, PLANKS, RIBS, STREAKS, WRITING, paint
from .outfits import OUTFITS, clothe, crown, fabric, garments, outfit
from .people import hair_material
from .physiques import UPRIGHT, Figure, build, finish


def held(kit, f, act):
    """What the hands hold, and what somebody sits on, leans at or pushes."""
    rng, b, s = kit.rng, f.b, f.b.size
    left, right = f.hands
    middle, dark = (left + right) / 2, kit.material(dark=True, pattern=PLAIN)
    if act == "carry":
        size = np.array([rng.uniform(0.12, 0.2), np.clip(abs(left[1] - right[1]) / 2 / s, 0.1, 0.2), rng.uniform(0.08, 0.2)]) * s
        kit.add(BOX if kit.chance(0.7) else BALL, middle + np.array([size[0] * 0.6, 0, size[2] * 0.4]), size, material=kit.material())
    elif act == "read":
        page = plain(kit, [0.8, 0.78, 0.7])._replace(pattern=WRITING, frequency=14.0)
        for side in (1, -1):
            f.chest(BOX, (0.37, 0.075 * side, 0.36), (0.01, 0.08, 0.11), page if kit.chance(0.5) else kit.material(), tilt=turn("z", -12 * side) @ turn("y", 35))
    elif act == "photo":
        kit.add(BOX, middle + f.facing @ np.array([0.04, 0, 0.02]) * s, np.array([0.03, 0.07, 0.045]) * s, rotation=f.facing, material=dark)
        kit.add(CYL, middle + f.facing @ np.array([0.1, 0, 0.015]) * s, np.array([0.035, 0.035, rng.uniform(0.03, 0.09)]) * s, rotation=f.facing @ ALONG_X, material=dark)
        kit.add(BOX, middle + f.facing @ np.array([0.04, 0, 0.075]) * s, np.array([0.025, 0.03, 0.02]) * s, (0.7, 0.7), rotation=f.facing, material=dark)
    elif act == "phone":
        kit.add(BOX, right + [0.01, 0.02, 0.04], np.array([0.035, 0.008, 0.075]) * s, rotation=turn("y", 15), material=dark)
    elif act == "push":
        x = max(left[0], right[0]) + 0.03
        if kit.chance(0.5):
            size = rng.uniform((0.3, 0.35, 0.45), (0.5, 0.6, 0.75))
            kit.add(
                BOX,
                (x + size[0], 0, max(size[2], middle[2] / 2 + 0.08)),
                (*size[:2], max(size[2], middle[2] / 2 + 0.08)),
                material=kit.material(pattern=rng.choice([PLANKS, PLAIN, BANDS])),
            )
        else:
            steel = plain(kit, [0.5, 0.5, 0.5], 0.4)
            kit.between((x - 0.02, -0.25, middle[2]), (x - 0.02, 0.25, middle[2]), 0.018, material=dark)
            kit.add(BOX, (x + 0.45, 0, 0.65 * s), (0.36, 0.24, 0.2), (1.15, 1.1), material=steel, cut=(GRID, 14.0, 0.3))
            kit.between((x + 0.02, 0.22, middle[2]), (x + 0.12, 0.2, 0.15), 0.015, material=steel, mirror=True)
            kit.between((x + 0.1, 0.2, 0.16), (x + 0.8, 0.2, 0.16), 0.015, material=steel, mirror=True)
            for xw in (0.14, 0.76):
                kit.add(CYL, (x + xw, 0.2, 0.07), (0.07, 0.07, 0.02), rotation=ALONG_Y, material=dark, mirror=True)
            kit.between((x + 0.78, 0.2, 0.16), (x + 0.7, 0.2, 0.5 * s), 0.015, material=steel, mirror=True)
    elif act == "throw":
        kit.add(BALL, right + [0.0, 0, 0.09 * s], (0.06 * s,) * 3 if kit.chance(0.6) else np.array([0.13, 0.08, 0.08]) * s, material=kit.material())
    elif act == "climb":
        x = max(left[0], right[0]) + 0.02
        tall = left[2] + rng.uniform(0.15, 0.6)
        if kit.chance(0.5):
            kit.add(
                BOX, (x + 0.2, 0, tall / 2), (0.2, rng.uniform(0.4, 0.6), tall / 2), material=kit.material(base=[0.4, 0.36, 0.3], pattern=rng.choice([CLOUDY, STREAKS]))
            )
            for k in range(6):
                kit.add(BALL, (x - 0.01, (0.3, -0.25, 0.1)[k % 3], tall * (0.12 + 0.15 * k)), (0.045, 0.06, 0.045), material=kit.material())
        else:
            wood = kit.material(base=[0.45, 0.3, 0.15], pattern=PLANKS)
            kit.between((x, 0.27, 0), (x, 0.27, tall), (0.025, 0.02), BOX, material=wood, mirror=True)
            count = int(tall / 0.3)
            for k in range(count):
                kit.between((x, -0.27, (k + 0.5) * tall / count), (x, 0.27, (k + 0.5) * tall / count), 0.018, material=wood)
        for foot, z in zip(f.feet, (0, 1), strict=True):
            if z == 0:
                kit.add(BOX, ((foot[0] + x) / 2 + 0.06, foot[1], foot[2] - 0.095 * s), ((x - foot[0]) / 2 + 0.05, 0.07, 0.02), material=dark)
    elif act == "lean":
        back = f.place(f.high(-b.deep * 1.1, 0, 0.4))[0] - 0.04
        kit.add(
            BOX, (back - 0.06, 0, 0.85 * s), (0.06, rng.uniform(0.35, 0.8), rng.uniform(0.85, 1.1) * s), material=kit.material(pattern=rng.choice([PLAIN, CLOUDY, 8]))
        )
    elif act == "sit":
        seat = f.place(f.low(0, 0, -0.13))[2] + 0.01
        under, wood = (0.06 * s, 0, seat), kit.material()
        kind = rng.choice(["stool", "block", "chair", "chair", "armchair", "log", "bench"])
        if kind == "block":
            kit.add(BOX, (-0.0, 0, seat / 2), (0.25 * s, rng.uniform(0.24, 0.5) * s, seat / 2), material=wood)
        elif kind == "log":
            kit.add(CYL, (-0.02, 0, seat / 2), (seat / 2, seat / 2, 0.6 * s), rotation=ALONG_Y, material=kit.material(base=[0.25, 0.17, 0.1], pattern=RIBS))
        elif kind == "armchair":
            kit.add(BOX, (0, 0, seat * 0.55), (0.3 * s, 0.3 * s, seat * 0.45), material=wood)
            kit.add(BOX, (-0.28 * s, 0, 0.55 * s), (0.09 * s, 0.33 * s, 0.52 * s), (0.8, 0.95), rotation=turn("y", -6), material=wood)
            kit.add(BOX, (0, 0.37 * s, 0.32 * s), (0.3 * s, 0.07 * s, 0.32 * s), material=wood, mirror=True)
            kit.add(BOX, (0, 0, 0.02), (0.28 * s, 0.34 * s, 0.02), material=dark)
        else:
            wide = 0.7 if kind == "bench" else 0.23
            kit.add(BOX, (under[0] - 0.04, 0, seat - 0.025), (0.23 * s, wide * s, 0.025), material=wood)
            for x in (-0.17, 0.18):
                kit.between((x * s, (wide - 0.04) * s, 0), (x * s, (wide - 0.04) * s, seat), 0.022 * s, material=wood, mirror=True)
            if kind == "chair":
                kit.add(
                    BOX,
                    (-0.21 * s, 0, seat + 0.27 * s),
                    (0.02 * s, 0.21 * s, 0.27 * s),
                    rotation=turn("y", -5),
                    material=wood,
                    cut=(RUNGS, 9.0, 0.5) if kit.chance(0.4) else (0, 1, 1),
                )
    elif act == "dumbbell":
        kit.between(left, right, 0.014, material=dark)
        for p, side in ((left, 1), (right, -1)):
            for k in (0, 1):
                kit.add(CYL, p + [0, side * (0.24 + 0.06 * k), 0], (0.2 - 0.05 * k, 0.2 - 0.05 * k, 0.025), rotation=ALONG_Y, material=kit.material(pattern=PLAIN))
            kit.between(p, p + [0, side * 0.34, 0], 0.016, material=dark)
    elif act == "bags":
        for p in (left, right) if kit.chance(0.5) else (right,):
            kit.add(BOX, p - [0, 0, 0.24 * s], np.array([0.13, 0.06, 0.15]) * s, (1.1, 1), material=kit.material())
            kit.add(BOX, p - [0, 0, 0.05 * s], np.array([0.05, 0.01, 0.06]) * s, material=dark, cut=(GRID, 8.0, 0.2))
    elif act == "cane":
        kit.between((right[0] + 0.03, right[1], 0), right, 0.014, material=kit.material(base=[0.2, 0.1, 0.05]))
    elif act == "lie" and kit.chance(0.7):
        kit.add(BOX, (0.0, 0, -0.04), (1.0 * s, 0.4 * s, 0.045), material=fabric(kit))
    elif act == "ball":
        kit.add(BALL, f.feet[1] + [0.28 * s, 0, 0.02], (0.11 * s,) * 3, material=kit.material(base=[0.8, 0.8, 0.8], pattern=DOTS, second=[0.03] * 3))


def pose(kit, act):
    """Arguments of a Figure for what somebody does."""
    rng = kit.rng
    one, flat = rng.choice, turn("y", 4)
    return {
        "stand": lambda: {"legs": one(["stand", "rest", "rest", "attention"]), "arms": one(["hang", "hip", "hips", "crossed", "behind", "pockets", "chin", "head"])},
        "hips": lambda: {"legs": one(["stand", "rest", "apart"]), "arms": "hips"},
        "crossed": lambda: {"legs": one(["stand", "rest", "apart"]), "arms": "crossed", "lean": -2},
        "walk": lambda: {"legs": "walk", "arms": one(["walk", "walk", "carry", "pockets", "wave"]), "lean": rng.uniform(0, 7)},
        "run": lambda: {"legs": one(["run", "sprint"]), "arms": "run", "lean": rng.uniform(6, 16), "fists": True},
        "sit": lambda: {"legs": one(["seat", "seat", "cross_seat", "seat_out"]), "arms": one(["knees", "lap", "chin", "crossed", "hip"]), "lean": rng.uniform(-6, 18)},
        "ground": lambda: {"legs": "ground", "arms": one(["props", "knees"]), "lean": rng.uniform(-12, 4)},
        "hug": lambda: {"legs": "hug", "arms": "shins", "lean": rng.uniform(4, 16)},
        "handstand": lambda: {"legs": one(["inverted", "scissors"]), "hands": [(0.04, 0.2, 1.04)] * 2, "pelvis": turn("y", 180), "look": turn("y", -20)},
        "crawl": lambda: {"legs": "crawl", "hands": [(0.54, 0.17, 0.5), (0.52, 0.17, 0.42)], "pelvis": turn("y", 80), "look": turn("y", -50)},
        "lotus": lambda: {"legs": "lotus", "arms": one(["knees", "pray", "lap"]), "look": flat},
        "kneel": lambda: {"legs": one(["kneel", "both_knees", "seiza"]), "arms": one(["hang", "knees", "pray", "lap"]), "lean": rng.uniform(-2, 12)},
        "pray": lambda: {"legs": one(["both_knees", "seiza", "stand"]), "arms": "pray", "lean": rng.uniform(0, 8), "look": turn("y", rng.uniform(5, 25))},
        "crouch": lambda: {"legs": one(["squat", "crouch"]), "arms": one(["knees", "carry"]), "lean": rng.uniform(12, 32), "look": turn("y", -12)},
        "point": lambda: {"legs": one(["stand", "rest", "stride"]), "arms": one(["point", "point", "aside"])},
        "wave": lambda: {"legs": one(["stand", "rest"]), "arms": one(["wave", "up"])},
        "carry": lambda: {"legs": one(["stand", "walk", "walk"]), "arms": "carry", "lean": -4},
        "push": lambda: {"legs": "stride", "arms": "push", "lean": rng.uniform(15, 28), "look": turn("y", -12)},
        "throw": lambda: {"legs": one(["stride", "high_knee"]), "arms": "throw", "twist": -28, "lean": -8, "look": turn("z", 26)},
        "climb": lambda: {"legs": "climb", "arms": "climb", "look": turn("y", -22), "fists": True},
        "dance": lambda: {
            "legs": one(["arabesque", "tree", "high_knee", "kick", "leap", "stride"]),
            "arms": one(["flow", "fly", "tee", "overhead"]),
            "roll": rng.uniform(-10, 10),
        },
        "yoga": lambda: {
            "legs": (leg := one(["tree", "warrior", "lotus", "split"])),
            "arms": "tee" if leg == "warrior" else one(["overhead", "pray", "tee"]),
            "look": flat,
        },
        "boxing": lambda: {
            "legs": one(["stride", "crouch", "stand"]),
            "arms": one(["guard", "punch"]),
            "lean": 8,
            "twist": -14,
            "look": turn("z", 14) @ turn("y", 6),
            "fists": True,
        },
        "kicking": lambda: {"legs": "kick", "arms": one(["fly", "guard", "tee"]), "lean": -10, "look": flat},
        "lie": lambda: {"legs": one(["back", "back_bent"]), "arms": one(["hang", "head", "lap"]), "pelvis": turn("y", -90), "look": turn("y", 12)},
        "pushup": lambda: {"legs": "pushup", "hands": [(0.48, 0.24, 0.46)] * 2, "pelvis": turn("y", 70), "look": turn("y", -25)},
        "lean": lambda: {"legs": "lean", "arms": one(["crossed", "pockets", "phone"]), "pelvis": turn("y", -9), "look": turn("y", 8)},
        "read": lambda: {"legs": one(["stand", "rest", "lotus"]), "arms": "read", "look": turn("y", 26)},
        "photo": lambda: {"legs": one(["stand", "kneel", "stride"]), "arms": "photo", "look": flat, "lean": 6},
        "phone": lambda: {"legs": one(["stand", "rest", "walk"]), "arms": "phone"},
        "salute": lambda: {"legs": "attention", "arms": "salute", "look": flat},
        "bags": lambda: {"legs": one(["stand", "walk"]), "arms": "hang", "fists": True},
        "lift": lambda: {"legs": one(["apart", "stride"]), "arms": "up", "fists": True, "look": flat},
        "cane": lambda: {"legs": one(["stand", "walk"]), "hands": [(0.06, 0.26, -0.03), (0.26, 0.24, -0.02)], "lean": 6},
    }[act]()


ACTS = ["stand", "hips", "crossed", "walk", "run", "sit", "sit", "ground", "hug", "lotus", "kneel", "pray", "crouch", "point", "wave", "carry", "push", "throw", "climb"]
ACTS += ["handstand", "crawl", "dance", "yoga", "boxing", "kicking", "lie", "pushup", "lean", "read", "photo", "phone", "salute", "bags", "lift"]


def dummy(kit, kind):
    """A mannequin, a scarecrow, a statue on a plinth, or a toy soldier's base under a posed body."""
    rng = kit.rng
    b = build(kit, rng.choice(["man", "woman"]))
    if kind == "scarecrow":
        b.size = 1.0
        straw = kit.material(base=[0.6, 0.45, 0.16], pattern=STREAKS, gloss=0.0)
        w = clothe(kit, skin=straw, hair=straw, gloves=straw, top=fabric(kit, bold=0.9), bottom=fabric(kit, [0.12, 0.1, 0.08]), shoes=straw, cut=1.0, thick=1.2)
        f = Figure(kit, b, w, "attention", "tee", look=turn("x", rng.uniform(-14, 14)))
        first = len(kit.primitives)
        low = rng.uniform(0.2, 0.6)
        kit.primitives[:first] = [p._replace(centre=p.centre + [0, 0, low]) for p in kit.primitives]
        f.at = f.at + [0, 0, low]
        pole = kit.material(base=[0.3, 0.2, 0.1], pattern=PLANKS)
        kit.between((-0.1, 0, 0), f.place(f.high(-0.1, 0, 0.55)), 0.025, material=pole)
        kit.between(f.place(f.high(-0.05, -0.86, 0.5)), f.place(f.high(-0.05, 0.86, 0.5)), 0.022, material=pole)
        hat_on(kit, f.on_head(), rng.choice(["brim", "brim", "top", "cowboy"]), fabric(kit, bold=0.2), straw)
        f.chest(CYL, (0, 0, 0.02), (b.deep + 0.03, b.hip + 0.03, 0.13), w.top, (0.85, 1), low=True)
        f.belt(straw)
        f.face()
        return
    stone = carved(kit) if kind == "statue" else kit.material(base=rng.choice([0.03, 0.4, 0.75]) * np.array([1, 0.95, 0.88]), pattern=PLAIN, gloss=rng.uniform(0.05, 0.5))
    act = rng.choice(
        ["stand", "hips", "point", "walk", "crossed", "throw", "dance", "salute", "read"] if kind == "statue" else ["stand", "hips", "walk", "stand", "wave"]
    )
    w = clothe(kit, stone, sleeves=rng.integers(3), trousers=rng.choice([0, 0, 2]))
    if kind == "mannequin" and kit.chance(0.5):
        w.top = w.arm = fabric(kit)
        w.bottom = w.seat = fabric(kit)
        w.stone, w.trousers = True, 2
    f = Figure(kit, b, w, **pose(kit, act))
    if f.legs in UPRIGHT and kit.chance(0.4):
        f.skirt(w.bottom, rng.uniform(0.05, 0.5), 1.05)
    if kind == "statue":
        hair_on(f.on_head(), rng, rng.choice(["short", "long", "bun", "part", "quiff"]), stone)
        if kit.chance(0.4):
            f.limb(f.place((-0.2, 0, 0.15)) / b.size, f.high(-0.1, 0, 0.54), (0.04, 0.3), 0.6, stone, BOX)
        base = stone if kit.chance(0.4) else kit.material(base=np.ones(3) * rng.uniform(0.15, 0.6), pattern=CLOUDY)
        tall, wide = rng.uniform(0.1, 1.3), max(0.36, max(abs(p[0]) for p in f.feet if p[2] < 0.2) + 0.24)
        shape = BOX if kit.chance(0.6) else CYL
        kit.add(shape, (0, 0, -tall / 2 + 0.005), (wide * 0.85, wide * 0.85, tall / 2), (0.92, 0.92 if shape == BOX else 1), material=base)
        kit.add(shape, (0, 0, -0.03), (wide, wide, 0.04), material=base)
        kit.add(shape, (0, 0, -tall - 0.05), (wide * 1.15, wide * 1.15, 0.07), material=base)
    else:
        steel = plain(kit, [0.55, 0.55, 0.55], 0.5)
        kit.add(CYL, (-0.05, 0, 0.0), (0.27, 0.27, 0.015), material=steel)
        kit.between((-0.1, 0, 0.0), f.place(f.low(-0.08, 0, -0.05)), 0.012, material=steel)
        if kit.chance(0.4):
            hair_on(f.on_head(), rng, rng.choice(["bob", "short", "tail"]), hair_material(kit))
    f.face()


def posed_person(kit):
    """One person of any age and build: standing, walking, running, sitting, kneeling, at work, sport, yoga or rest, in clothes of many kinds; mannequin, scarecrow, statue."""
    rng = kit.rng
    odd = rng.random()
    if odd < 0.13:
        dummy(kit, rng.choice(["mannequin", "scarecrow", "statue", "statue"]))
        finish(kit)
        return
    b = build(kit, rng.choice(["man", "woman", "child", "old", "heavy"], p=[0.33, 0.33, 0.14, 0.1, 0.1]))
    act = rng.choice(ACTS) if b.kind != "old" or kit.chance(0.6) else "cane"
    how = pose(kit, act)
    long = how["legs"] in UPRIGHT and act not in ("climb", "run") and kit.chance(0.6 if b.woman else 0.3)
    kinds = (["dress", "dress", "skirt", "skirt", "coat", "robe", "sari", "kimono"] if b.woman else ["coat", "coat", "robe", "kilt", "thobe"]) if long else OUTFITS
    kind = rng.choice(kinds)
    if act in ("boxing", "yoga", "pushup", "handstand", "lift", "kicking", "dance") and kit.chance(0.7):
        kind = rng.choice(["sport", "sport", "swim", "tee"])
    w = outfit(kit, b, kind)
    if act == "boxing" and kit.chance(0.7):
        w.gloves = plain(kit, paint(rng.choice([0, 0.6]), 0.9, 0.5), 0.3)
    how["lean"] = how.get("lean", 0) + b.stoop
    f = Figure(kit, b, w, **how)
    if w.gloves is not w.skin:
        for p in f.hands:
            kit.add(BALL, p, np.array([0.085, 0.075, 0.085]) * b.size, material=w.gloves)
    crown(kit, f, kind)
    garments(kit, f, kind)
    held(kit, f, {"lift": "dumbbell", "kicking": "ball" if kit.chance(0.5) else ""}.get(act, act))
    if kit.chance(0.12) and act in ("stand", "walk", "point", "wave", "photo"):
        f.chest(BOX, (-b.deep - 0.09, 0, 0.33), (0.085, 0.14, 0.2), kit.material(), (0.9, 0.85))
    f.face()
    finish(kit)
