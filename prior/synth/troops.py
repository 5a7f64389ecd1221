"""A maker of soldiers of every age and of others in full kit: riot police, firefighters, medics, pilots, divers, paratroopers."""

import numpy as np

from .figures import plain
from .helmets import drab, helm, webbing
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CLOUDY, DOTS, PLAIN, RIBS, STRIPES, WRITING, paint
from .outfits import buttons, clothe, fabric
from .people import skin_material
from .physiques import ARMS, UPRIGHT, Figure, build, finish, lowest
from .weapons import GUNS, aim, grips, gun, sword


def modern(kit):
    """A soldier or marine: firing, standing guard, patrolling, kneeling, prone; with rifle, machine gun or launcher."""
    rng = kit.rng
    b, cloth = build(kit, rng.choice(["man", "man", "man", "woman"])), drab(kit)
    vest = kit.material(base=cloth.first * rng.uniform(0.5, 1.2), pattern=PLAIN, gloss=0.02)
    w = clothe(
        kit,
        top=cloth,
        bottom=cloth,
        shoes=plain(kit, np.array([0.1, 0.07, 0.04]) * rng.uniform(0.3, 2)),
        gloves=kit.material(dark=True) if kit.chance(0.5) else None,
        cut=0.9,
        thick=1.12,
    )
    cover, hat = (cloth if kit.chance(0.7) else vest), rng.choice(["modern", "modern", "modern", "m1", "cap", "beret", "beanie"])
    stance = rng.choice(["stand", "stand", "walk", "kneel", "prone", "guard", "glass", "mine"])
    weapon = rng.choice(["rifle", "rifle", "rifle", "mg", "sniper", "smg", "launcher"])
    if stance == "prone":
        prone(kit, b, w, weapon if weapon != "launcher" else "mg", hat, cover, vest)
        return
    if stance == "glass":
        f = Figure(kit, b, w, rng.choice(["stand", "kneel"]), "photo", look=turn("y", 2), fists=True, lean=4)
        middle, dark = (f.hands[0] + f.hands[1]) / 2, kit.material(dark=True, pattern=PLAIN)
        helm(kit, f, hat, cover, vest)
        webbing(kit, f, vest)
        kit.add(CYL, middle + f.facing @ np.array([0.03, 0.04, 0.02]), (0.036, 0.036, 0.085), (0.75, 1), rotation=f.facing @ turn("y", -90), material=dark)
        kit.add(CYL, middle + f.facing @ np.array([0.03, -0.04, 0.02]), (0.036, 0.036, 0.085), (0.75, 1), rotation=f.facing @ turn("y", -90), material=dark)
        gun(kit, f, "rifle", f.high(0.17, -0.16, 0.46), f.trunk @ np.array([0.1, 0.45, -0.85]))
    elif stance == "mine":
        f = Figure(kit, b, w, "walk", lean=10, hands=[(0.36, 0.08, 0.12), (0.26, 0.17, 0.05)], look=turn("y", 22), fists=True)
        left, right = f.hands
        dark, along = kit.material(dark=True, pattern=PLAIN), left - right
        foot = np.array([1.05, 0.1, 0.06])
        kit.between(right + (right - foot) * 0.25, foot, 0.016, material=dark)
        kit.add(CYL, foot, (0.16, 0.16, 0.025), material=vest)
        kit.add(BOX, right - along * 0.3, (0.07, 0.035, 0.05), material=dark)
        helm(kit, f, hat, cover, vest)
        webbing(kit, f, vest)
    else:
        args, butt, along = aim(kit, weapon, stance)
        f = Figure(kit, b, w, **args)
        gun(kit, f, weapon, f.high(*butt), f.trunk @ along)
        helm(kit, f, hat, cover, vest)
        webbing(kit, f, vest, weapon != "launcher")
    f.chest(BOX, (f.b.deep + 0.05, 0.12, 0.42), (0.022, 0.03, 0.06), kit.material(dark=True))


def prone(kit, b, w, weapon, hat, cover, vest):
    """Lying on the belly behind a gun on its bipod."""
    butt, along = np.array([0.5, -0.1, 0.3]), np.array([1, 0.05, -0.02])
    left, right = grips(weapon, butt, along)
    f = Figure(kit, b, w, "prone", hands=[left - [0.1, 0, 0.03], right], pelvis=turn("y", 86), lean=-16, look=turn("y", -62), world=True, fists=True, up=0.13)
    gun(kit, f, weapon, butt, along)
    tip = butt + along * GUNS[weapon][0] * 0.75
    for y in (-0.1, 0.1):
        kit.between(f.place(tip), f.place([tip[0] + 0.03, tip[1] + y, 0.0]), 0.009, material=kit.material(dark=True))
    helm(kit, f, hat, cover, vest)
    f.chest(BOX, (0, 0, 0.33), (b.deep + 0.03, b.shoulder * 0.85, 0.16), vest, (0.9, 0.9))
    if kit.chance(0.5):
        f.chest(BOX, (-b.deep - 0.09, 0, 0.33), (0.08, 0.14, 0.18), vest, (0.9, 0.9))
    f.belt(vest, 0.03)


def parade(kit):
    """A guard, sailor, officer or guardsman at attention, marching, saluting, or with the rifle at the shoulder."""
    rng = kit.rng
    kind = rng.choice(["guardsman", "sailor", "officer", "marine", "soldier"])
    base = {
        "guardsman": [0.5, 0.03, 0.03],
        "sailor": [0.75, 0.75, 0.75] if kit.chance(0.5) else [0.02, 0.03, 0.08],
        "officer": [0.2, 0.19, 0.11],
        "marine": [0.02, 0.03, 0.07],
    }.get(kind)
    top = plain(kit, base) if base is not None else drab(kit)
    bottom = plain(kit, [0.02, 0.025, 0.05]) if kind in ("guardsman", "marine") and kit.chance(0.7) else top
    white = plain(kit, [0.8, 0.8, 0.78])
    b = build(kit, rng.choice(["man", "man", "woman"]))
    w = clothe(kit, top=top, bottom=bottom, shoes=plain(kit, [0.02] * 3, 0.5), gloves=white if kit.chance(0.5) else None, cut=1.3 if kind == "sailor" else 0.9)
    do = rng.choice(["arms", "arms", "salute", "attention", "march"])
    hands = [(0.02, 0.25, -0.05), (0.14, 0.18, 0.06)] if do == "arms" else None
    legs = {"march": rng.choice(["walk", "high_knee"]), "arms": rng.choice(["attention", "walk"])}.get(do, "attention")
    f = Figure(kit, b, w, legs, {"salute": "salute", "march": "walk"}.get(do, "hang"), hands=hands, look=turn("y", 1), fists=do in ("arms", "march"))
    hat = {"guardsman": "bearskin", "sailor": "sailor"}.get(kind) or rng.choice(["peaked", "beret", "peaked"])
    helm(kit, f, hat, kit.material(dark=True, pattern=PLAIN) if kind == "guardsman" else white if kind == "marine" else top, white)
    if do == "arms":
        gun(kit, f, rng.choice(["bolt", "rifle"]), f.high(0.15, -0.19, 0.02), f.trunk @ np.array([-0.08, 0.02, 1.0]), kit.chance(0.5))
    f.belt(white if kit.chance(0.6) else w.shoes, 0.028, 0.12)
    f.chest(CYL, (0, 0, 0.0), (b.deep + 0.03, b.hip + 0.022, 0.11), top, (0.88, 1), low=True)
    gold = plain(kit, [0.65, 0.45, 0.12], 0.5)
    buttons(f, gold, 4, 0.2, 0.46)
    f.chest(BOX, (0, b.shoulder - 0.02, 0.55), (0.03, 0.06, 0.01), gold, tilt=turn("x", -18), mirror=True)
    if kind == "sailor":
        f.chest(BOX, (-0.075, 0, 0.47), (0.02, 0.15, 0.08), kit.material(base=[0.03, 0.06, 0.2], pattern=PLAIN))
    else:
        f.chest(BOX, (b.deep * 1.12, 0.075, 0.4), (0.012, 0.05, 0.02), kit.material(pattern=STRIPES, frequency=20))


def service(kit):
    """Riot police, a firefighter, a medic with a stretcher, a pilot, a diver, a paratrooper."""
    rng = kit.rng
    kind = rng.choice(["riot", "riot", "fire", "fire", "medic", "pilot", "diver", "para"])
    b, dark = build(kit, rng.choice(["man", "man", "woman"])), kit.material(dark=True, pattern=PLAIN)
    if kind == "riot":
        cloth = plain(kit, np.array([0.03, 0.035, 0.06]) * rng.uniform(0.5, 2.5))
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=dark, thick=1.2, cut=1.0)
        f = Figure(
            kit,
            b,
            w,
            rng.choice(["stride", "stand", "apart"]),
            hands=[(0.33, 0.16, 0.25), rng.choice([(0.1, 0.3, 0.0), (0.12, 0.36, 0.75), (0.3, 0.25, 0.3)])],
            lean=5,
            look=turn("y", 3),
            fists=True,
        )
        helm(kit, f, rng.choice(["visor", "visor", "police"]), cloth if kit.chance(0.6) else plain(kit, [0.75] * 3), dark)
        shield = kit.material(base=[0.35, 0.42, 0.46], pattern=PLAIN, gloss=0.5) if kit.chance(0.6) else dark
        at = f.hands[0] + [0.07, -0.05, -0.05]
        if kit.chance(0.7):
            kit.add(BOX, at, (0.02, 0.26, rng.uniform(0.4, 0.55)), material=shield)
            kit.add(BOX, at + [-0.012, 0.27, 0], (0.02, 0.05, 0.44), rotation=turn("z", 28), material=shield)
            kit.add(BOX, at + [-0.012, -0.27, 0], (0.02, 0.05, 0.44), rotation=turn("z", -28), material=shield)
            kit.add(BOX, at + [0.023, 0, 0.2], (0.005, 0.18, 0.05), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=4))
        else:
            kit.add(CYL, at, (0.32, 0.32, 0.02), rotation=ALONG_X, material=shield)
        kit.between(f.hands[1] - [0.05, 0, 0.1], f.hands[1] + [0.16, 0, 0.45], 0.018, material=dark)
        f.chest(BOX, (0.005, 0, 0.32), (b.deep + 0.035, b.shoulder * 0.9, 0.18), dark, (0.92, 0.9))
        f.chest(BALL, (0, b.shoulder + 0.03, 0.5), (0.09, 0.075, 0.08), dark, mirror=True)
        f.wrap(0, 0.15, 1.08, (0.075, 0.062), dark, BOX, 1.15)
        f.belt(dark, 0.035)
    elif kind == "fire":
        cloth = plain(kit, [[0.5, 0.38, 0.14], [0.03, 0.03, 0.05], [0.45, 0.06, 0.02], [0.3, 0.26, 0.18]][rng.integers(4)])
        bright = plain(kit, [0.75, 0.8, 0.15], 0.2)
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=dark, thick=1.35, cut=1.3)
        hose = kit.chance(0.6)
        f = Figure(
            kit,
            b,
            w,
            rng.choice(["stride", "stand", "walk", "kneel"]),
            hands=[(0.4, 0.02, 0.28), (0.14, 0.17, 0.14)] if hose else None,
            lean=5,
            look=turn("y", 3),
            fists=True,
        )
        helm(kit, f, "fire", plain(kit, [[0.7, 0.6, 0.05], [0.5, 0.03, 0.02], [0.03] * 3, [0.7] * 3][rng.integers(4)], 0.4), dark)
        f.chest(CYL, (0, 0, 0.0), (b.deep + 0.04, b.hip + 0.04, 0.15), cloth, (0.88, 1), low=True)
        f.chest(CYL, (0, 0, -0.1), (b.deep + 0.042, b.hip + 0.042, 0.022), bright, low=True)
        f.chest(CYL, (0.006, 0, 0.3), (b.deep * 1.14, b.shoulder * 0.95, 0.022), bright)
        f.chest(CYL, (-b.deep - 0.08, 0, 0.33), (0.075, 0.075, 0.22), plain(kit, [0.6, 0.5, 0.05], 0.4))
        f.chest(BOX, (-b.deep - 0.02, 0, 0.33), (0.03, 0.11, 0.2), dark)
        f.wrap(0, 0.28, 0.38, 0.088, bright)
        if hose:
            left, right = f.hands
            red = kit.material(base=[0.6, 0.55, 0.4] if kit.chance(0.5) else [0.45, 0.05, 0.03], pattern=PLAIN)
            kit.between(right, left, 0.03, material=red)
            kit.between(left, left + (left - right) * 0.8, 0.03, taper=0.55, material=plain(kit, [0.6, 0.45, 0.15], 0.5))
            kit.chain([right, right + [-0.35, -0.1, -0.35 * right[2]], [right[0] - 0.6, right[1] - 0.15, 0.04], [right[0] - 1.1, right[1] + 0.1, 0.035]], 0.032, red)
        else:
            right = f.hands[1]
            kit.between(right - [0, 0, 0.45], right + [0.08, 0, 0.4], 0.018, material=kit.material(base=[0.5, 0.35, 0.15]))
            kit.add(BOX, right + [0.13, 0, 0.37], (0.1, 0.015, 0.06), (0.6, 1), material=plain(kit, [0.5, 0.04, 0.03], 0.3))
    elif kind == "medic":
        white = plain(kit, [0.8, 0.78, 0.75])
        cloth = drab(kit) if kit.chance(0.6) else plain(kit, [0.65, 0.12, 0.02])
        b.arm *= 0.9
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark)
        f = Figure(kit, b, w, rng.choice(["stand", "walk"]), hands=[(0.16, 0.3, -0.04), (0.16, 0.3, -0.04)], lean=3, fists=True)
        helm(kit, f, rng.choice(["m1", "modern", "cap"]), cloth, white)
        left, right = f.hands
        z, long = left[2], 1.9
        for p in (left, right):
            kit.between(p - [0.12, 0, 0], p + [long + 0.4, 0, 0], 0.02, material=kit.material(base=[0.35, 0.22, 0.1]))
            kit.between((p[0] + 0.4, p[1] * 0.95, z), (p[0] + 0.4, p[1] * 0.95, 0), 0.018, material=dark)
            kit.between((p[0] + long + 0.1, p[1] * 0.95, z), (p[0] + long + 0.1, p[1] * 0.95, 0), 0.018, material=dark)
        kit.add(BOX, (left[0] + long / 2 + 0.25, 0, z - 0.01), (long / 2 - 0.08, abs(left[1]), 0.018), material=fabric(kit, [0.25, 0.24, 0.14], 0))
        if kit.chance(0.6):
            kit.add(BALL, (left[0] + 1.2, 0, z + 0.1), (0.75, 0.2, 0.12), material=fabric(kit, [0.3, 0.25, 0.2], 0))
            kit.add(BALL, (left[0] + 0.45, 0, z + 0.11), (0.11, 0.085, 0.1), material=skin_material(kit))
        red = plain(kit, [0.6, 0.02, 0.02])
        f.chest(BOX, (-b.deep - 0.07, 0, 0.32), (0.07, 0.14, 0.17), white if kit.chance(0.5) else cloth)
        f.chest(BOX, (-b.deep - 0.145, 0, 0.32), (0.005, 0.025, 0.08), red)
        f.chest(BOX, (-b.deep - 0.145, 0, 0.32), (0.005, 0.08, 0.025), red)
        f.belt(dark)
    elif kind == "pilot":
        cloth = plain(kit, [[0.12, 0.14, 0.08], [0.5, 0.14, 0.02], [0.3, 0.26, 0.18], [0.08, 0.1, 0.16]][rng.integers(4)])
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=kit.material(base=cloth.first) if kit.chance(0.5) else None, cut=0.9)
        f = Figure(kit, b, w, rng.choice(["stand", "rest", "walk"]), rng.choice(["hips", "hang", "crossed", "wave", "salute"]))
        helm(kit, f, rng.choice(["pilot", "pilot", "cap"]), plain(kit, [0.7, 0.7, 0.68] if kit.chance(0.5) else [0.15, 0.16, 0.12], 0.3), dark)
        harness = drab(kit, [0.12, 0.13, 0.07], 0)
        f.chest(BALL, (b.deep * 0.5, 0.09, 0.3), (0.1, 0.065, 0.2), harness, mirror=True)
        f.chest(CYL, (-0.0, 0, 0.57), (0.11, 0.12, 0.045), harness, (0.8, 1), turn("y", 12))
        f.chest(BOX, (0.01, 0, 0.13), (b.deep + 0.02, b.waist + 0.015, 0.03), harness)
        f.belt(harness, 0.02)
        f.wrap(1, 0.3, 0.7, (0.1, 0.088), harness, BOX, 1.1)
    elif kind == "diver":
        suit = plain(kit, np.array([0.02, 0.025, 0.03]) * rng.uniform(0.6, 2), 0.2)
        trim = plain(kit, paint(rng.choice([0.15, 0.6, 0.0, 0.33]), 0.9, 0.6), 0.3)
        w = clothe(kit, top=suit, bottom=suit, gloves=suit, shoes=suit, cut=0.75)
        f = Figure(kit, b, w, rng.choice(["stand", "rest", "kneel"]), rng.choice(["hang", "hips", "wave", "crossed"]))
        helm(kit, f, "diving", suit, trim)
        for y in (0.09, -0.09) if kit.chance(0.5) else (0,):
            f.chest(CYL, (-b.deep - 0.09, y, 0.25), (0.085, 0.085, 0.27), trim)
            f.chest(CYL, (-b.deep - 0.09, y, 0.54), (0.04, 0.04, 0.04), dark)
        f.chest(BOX, (0.005, 0, 0.3), (b.deep + 0.02, b.shoulder * 0.75, 0.17), dark, (1, 0.75))
        f.belt(dark, 0.03, 0.06)
        f.limb(f.high(-b.deep - 0.08, -0.05, 0.55), f.high(0.08, -0.19, 0.6), 0.014, 1, dark)
        f.limb(f.high(0.08, -0.19, 0.6), f.centre + f.facing @ np.array([0.09, -0.01, -0.06]), 0.014, 1, dark)
        for foot in f.feet:
            kit.add(BOX, foot + [0.28 * b.size, 0, -0.055 * b.size], np.array([0.2, 0.1, 0.014]) * b.size, (0.9, 1), material=trim)
    else:
        cloth, vest = drab(kit), drab(kit, None, 0)
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=dark, thick=1.15, cut=0.9)
        f = Figure(kit, b, w, rng.choice(["stand", "seat", "high_knee"]), "up", fists=True, look=turn("y", -8))
        helm(kit, f, "m1" if kit.chance(0.5) else "modern", cloth, vest)
        low = f.high(0, 0, 0.55)[2] * b.size + f.at[2]
        top = low + rng.uniform(2.4, 3.2)
        wide = rng.uniform(1.6, 2.2)
        canopy = kit.material(base=[0.3, 0.3, 0.2] if kit.chance(0.5) else paint(rng.random(), 0.7, 0.6), pattern=rng.choice([PLAIN, STRIPES, RIBS]), frequency=4)
        for k, (z, r) in enumerate(((0, 1.0), (0.28, 0.93), (0.52, 0.72))):
            kit.add(CYL, (0, 0, top + (z + 0.14) * wide * 0.9), (wide * r, wide * r, 0.14 * wide * 0.95), ((0.93, 0.77, 0.25)[k], 1), material=canopy)
        for hand in f.hands:
            kit.between(f.place(f.high(-0.03, np.sign(hand[1]) * 0.13, 0.52)), hand + [0, 0, 0.1], 0.014, material=vest)
            for x in (-0.9, 0, 0.9):
                kit.between(hand + [0, 0, 0.1], (x * wide, np.sign(hand[1]) * wide * (0.35 if x else 0.95), top + 0.1), 0.01, material=vest)
        f.chest(BOX, (-b.deep - 0.08, 0, 0.32), (0.08, 0.16, 0.2), vest)
        f.chest(BOX, (b.deep + 0.05, 0, 0.12), (0.06, 0.14, 0.09), vest)
        f.belt(vest)


def great_war(kit):
    """A rifleman of the first or second world war."""
    rng = kit.rng
    nation = rng.choice(["british", "french", "german", "american", "soviet"])
    base = {"british": [0.22, 0.17, 0.09], "french": [0.22, 0.28, 0.38], "german": [0.17, 0.19, 0.15], "american": [0.2, 0.19, 0.1], "soviet": [0.28, 0.23, 0.12]}[nation]
    cloth, leather = plain(kit, np.array(base) * rng.uniform(0.7, 1.3)), kit.material(base=[0.12, 0.06, 0.03], pattern=PLAIN, gloss=0.15)
    canvas = plain(kit, [0.32, 0.28, 0.17])
    b = build(kit, "man")
    w = clothe(kit, top=cloth, bottom=cloth, shoes=leather, cut=0.85, socks=canvas, thick=1.12)
    if nation in ("british", "french"):
        w.cut = 0.78
    weapon = "bolt" if nation != "american" or kit.chance(0.6) else "smg"
    helmet = {"british": "brodie", "french": "adrian", "german": "stahl"}.get(nation, "m1")
    metal = plain(kit, np.array(base) * rng.uniform(0.5, 0.9), 0.15)
    if kit.chance(0.15):
        prone(kit, b, w, "mg" if kit.chance(0.3) else weapon, helmet, metal, canvas)
        return
    args, butt, along = aim(kit, weapon, rng.choice(["stand", "walk", "kneel", "guard"]))
    f = Figure(kit, b, w, **args)
    gun(kit, f, weapon, f.high(*butt), f.trunk @ along, weapon == "bolt" and kit.chance(0.4))
    helm(kit, f, helmet, metal, leather)
    if args["legs"] in UPRIGHT and nation in ("french", "soviet") and kit.chance(0.6):
        f.skirt(cloth, rng.uniform(0.4, 0.6), 1.0)
    else:
        f.chest(CYL, (0, 0, 0.0), (b.deep + 0.032, b.hip + 0.026, 0.12), cloth, (0.88, 1), low=True)
    f.belt(leather, 0.03, 0.12)
    for y in (0.1, -0.1):
        f.chest(BOX, (b.deep + 0.02, y, 0.13), (0.035, 0.055, 0.045), leather if nation == "german" else canvas, low=True)
        f.limb(f.high(b.deep + 0.02, y, 0.16), f.high(0.0, y, 0.565), (0.008, 0.018), 1, leather, BOX)
    f.chest(BOX, (-b.deep - 0.07, 0, 0.34), (0.07, 0.14, 0.15), canvas)
    f.chest(CYL, (-b.deep - 0.07, 0, 0.52), (0.06, 0.06, 0.2), cloth, tilt=ALONG_Y)
    f.chest(BOX, (-0.06, -b.hip - 0.05, 0.0), (0.08, 0.05, 0.09), canvas, low=True)
    buttons(f, leather, 3, 0.22, 0.46)


def ancient(kit):
    """A legionary, a knight, or a samurai, with sword, spear and shield."""
    rng, kind = kit.rng, kit.rng.choice(["legionary", "knight", "samurai"])
    b, steel, leather = build(kit, "man"), plain(kit, np.ones(3) * rng.uniform(0.3, 0.65), 0.55), kit.material(base=[0.14, 0.07, 0.03], pattern=PLAIN)
    gold, right_up = plain(kit, [0.65, 0.45, 0.12], 0.5), kit.chance(0.4)
    colour = plain(kit, paint(rng.choice([0.0, 0.0, 0.6, 0.35, 0.13]), 0.9, rng.uniform(0.15, 0.6)))
    hands = [(0.28, 0.26, 0.2), (0.2, 0.36, 0.85) if right_up else (0.3, 0.26, 0.22)]
    legs = rng.choice(["stand", "rest", "walk", "stride"])
    if kind == "legionary":
        plates = steel._replace(pattern=BANDS, frequency=22.0, second=steel.first * 0.45)
        w = clothe(kit, top=plates, bottom=colour, arm=colour, sleeves=1, trousers=0, shoes=leather)
        f = Figure(kit, b, w, legs, hands=hands, look=turn("y", 3), fists=True)
        helm(kit, f, "galea", steel if kit.chance(0.6) else gold, colour)
        f.chest(CYL, (0, 0, -0.1), (0.17, 0.205, 0.17), colour, (0.78, 1), low=True)
        f.chest(BOX, (b.deep + 0.05, 0, -0.08), (0.015, 0.06, 0.13), leather, low=True)
        f.belt(leather, 0.025, 0.1)
        for side in (1, -1):
            f.chest(BALL, (0, side * (b.shoulder + 0.005), 0.5), (0.085, 0.08, 0.075), plates)
        left = f.hands[0] + [0.09, 0, -0.1]
        kit.add(BOX, left, (0.025, 0.2, 0.5), material=colour)
        for side in (1, -1):
            kit.add(BOX, left + [-0.035, side * 0.255, 0], (0.02, 0.075, 0.5), rotation=turn("z", 28 * side), material=colour)
        kit.add(BALL, left + [0.03, 0, 0], (0.06, 0.09, 0.09), material=gold)
        kit.add(BOX, left + [0.025, 0, 0], (0.012, 0.02, 0.46), material=gold)
        right = f.hands[1]
        if kit.chance(0.55):
            low = 0.0 if not right_up else right[2] - 0.7
            kit.between((right[0], right[1], low), (right[0], right[1], low + 1.35), 0.018, material=leather)
            kit.between((right[0], right[1], low + 1.3), (right[0], right[1], low + 1.95), 0.009, material=steel)
            kit.between((right[0], right[1], low + 1.9), (right[0], right[1], low + 2.05), 0.03, taper=0.1, material=steel)
        else:
            sword(kit, right, [0.5, 0, 0.85], 0.5, steel, leather, gold)
        if kit.chance(0.4):
            f.limb(f.place((-0.26, 0, 0.4)) / b.size, f.high(-0.1, 0, 0.52), (0.03, 0.26), 0.7, colour, BOX)
    elif kind == "knight":
        mail = kit.material(base=np.ones(3) * 0.25, pattern=DOTS, frequency=30, second=[0.08] * 3, gloss=0.3)
        full = kit.chance(0.5)
        w = clothe(
            kit,
            top=steel if full else colour,
            bottom=steel if full else mail,
            arm=steel if full else mail,
            shoes=steel if full else mail,
            gloves=steel,
            cut=0.78,
            thick=1.15,
        )
        both = kit.chance(0.35)
        f = Figure(kit, b, w, legs, hands=[(0.34, -0.02, 0.14), (0.32, 0.05, 0.24)] if both else hands, look=turn("y", 2), fists=True)
        helm(kit, f, rng.choice(["bascinet", "greathelm"]), steel, colour)
        if full:
            f.chest(CYL, (0, 0, -0.03), (b.deep + 0.05, b.hip + 0.045, 0.12), steel, (0.78, 1), low=True)
            f.chest(BALL, (0, b.shoulder + 0.015, 0.49), (0.1, 0.09, 0.085), steel, mirror=True)
        else:
            f.skirt(colour, 0.45 if legs in UPRIGHT else 0.55, 1.05 if legs in UPRIGHT else 1.3)
            f.chest(BOX, (b.deep * 1.05, 0, 0.33), (0.03, 0.03, 0.14), gold)
            f.chest(BOX, (b.deep * 1.05, 0, 0.37), (0.03, 0.09, 0.03), gold)
        f.belt(leather, 0.028, 0.1)
        left, right = f.hands
        if both:
            kit.between((right[0], right[1], right[2] + 0.14), (left[0], left[1], left[2] - 0.02), 0.016, material=leather)
            sword(kit, right, [0.15, 0, 1.0], rng.uniform(0.85, 1.05), steel, leather, gold)
        else:
            sword(kit, right, [0.3, 0, 0.95], rng.uniform(0.65, 0.85), steel, leather, gold)
            kit.add(BOX, left + [0.06, 0, 0.05], (0.022, 0.23, 0.18), material=colour)
            kit.add(BOX, left + [0.06, 0, -0.34], (0.022, 0.23, 0.22), (1, 0.08), rotation=turn("x", 180), material=colour)
            kit.add(BOX, left + [0.078, 0, -0.04], (0.012, 0.03, 0.26), material=gold)
            kit.add(BOX, left + [0.078, 0, 0.08], (0.012, 0.22, 0.03), material=gold)
    else:
        lacquer = colour if kit.chance(0.5) else plain(kit, [0.03, 0.025, 0.02], 0.4)
        plates = lacquer._replace(pattern=BANDS, frequency=18.0, second=np.array([0.02, 0.02, 0.02]))
        w = clothe(kit, top=plates, bottom=fabric(kit), arm=fabric(kit), shoes=leather, cut=1.3, thick=1.15)
        both = kit.chance(0.7)
        f = Figure(
            kit,
            b,
            w,
            rng.choice(["stride", "stand", "apart", "kneel"]),
            hands=[(0.36, 0.0, 0.18), (0.34, 0.06, 0.28)] if both else ARMS["hang"],
            look=turn("y", 2),
            fists=True,
        )
        helm(kit, f, "kabuto", lacquer, gold if kit.chance(0.3) else plates)
        for side in (1, -1):
            f.chest(BOX, (0, side * (b.shoulder + 0.06), 0.4), (0.1, 0.02, 0.13), plates, (0.85, 1), turn("x", 12 * side))
            f.chest(BOX, (0.02, side * 0.13, -0.12), (0.1, 0.07, 0.14), plates, (0.85, 0.8), turn("x", 10 * side), low=True)
        f.chest(BOX, (b.deep + 0.02, 0, -0.1), (0.025, 0.08, 0.13), plates, (1, 0.85), turn("y", -8), low=True)
        f.belt(fabric(kit), 0.035, 0.1)
        f.wrap(0, 0.1, 0.95, (0.085, 0.08), plates, CYL, 1.1)
        left, right = f.hands
        if both:
            kit.between(left - [0, 0, 0.06], right + [0, 0, 0.04], 0.017, material=leather)
            sword(kit, right, [0.25, 0, 0.97], 0.72, steel, leather, gold, True)
        f.limb(f.low(0.16, 0.2, 0.16), f.low(-0.5, 0.26, -0.02), (0.02, 0.013), 1, plain(kit, [0.03, 0.01, 0.01], 0.4))


def napoleonic(kit):
    """A musketeer of the line, a redcoat, or one of the plumed hat and rapier."""
    rng, kind = kit.rng, kit.rng.choice(["line", "line", "redcoat", "plumed"])
    white, gold, dark = plain(kit, [0.78, 0.76, 0.7]), plain(kit, [0.65, 0.45, 0.12], 0.5), kit.material(dark=True, pattern=PLAIN)
    base = paint(rng.choice([0.62, 0.0, 0.33, 0.6]), 0.85, rng.uniform(0.08, 0.35)) if kind != "redcoat" else np.array([0.5, 0.03, 0.03])
    coat, second = plain(kit, base), plain(kit, paint(rng.choice([0.0, 0.15, 0.6]), 0.9, 0.5))
    b = build(kit, "man")
    w = clothe(kit, top=coat, bottom=white if kit.chance(0.7) else plain(kit, [0.25, 0.25, 0.25]), shoes=dark, cut=0.85, thick=1.1)
    if kind == "plumed" and kit.chance(0.5):
        f = Figure(kit, b, w, rng.choice(["stride", "rest"]), hands=[(0.04, 0.2, 0.06), (0.52, 0.2, 0.4)], look=turn("y", 2), fists=True)
        sword(kit, f.hands[1], [0.95, 0, 0.2], 0.85, plain(kit, [0.6] * 3, 0.5), dark, gold)
    elif kit.chance(0.4):
        f = Figure(kit, b, w, rng.choice(["attention", "walk", "high_knee"]), hands=[(0.02, 0.25, -0.05), (0.14, 0.18, 0.06)], look=turn("y", 2), fists=True)
        gun(kit, f, "musket", f.high(0.15, -0.19, 0.02), f.trunk @ np.array([-0.08, 0.02, 1.0]), kit.chance(0.7))
    else:
        args, butt, along = aim(kit, "musket", rng.choice(["stand", "walk", "kneel"]))
        f = Figure(kit, b, w, **args)
        gun(kit, f, "musket", f.high(*butt), f.trunk @ along, kit.chance(0.6))
    helm(kit, f, {"line": rng.choice(["shako", "shako", "bearskin"]), "redcoat": rng.choice(["tricorn", "shako"]), "plumed": "plumed"}[kind], dark, second)
    for y in (0.1, -0.1):
        f.limb(f.high(b.deep * 1.1, -y, 0.14), f.high(0.02, y, 0.56), (0.008, 0.026), 1, white, BOX)
        f.limb(f.low(-0.1, y * 0.8, 0.1), f.low(-0.2, y * 0.9, -0.32), (0.02, 0.065), 0.9, coat, BOX)
    f.chest(BALL, (0, b.shoulder + 0.01, 0.545), (0.06, 0.06, 0.028), gold if kit.chance(0.5) else second, mirror=True)
    f.chest(CYL, (0.004, 0, 0.585), (0.066, 0.068, 0.03), second)
    f.chest(BOX, (b.deep * 0.95, 0, 0.3), (0.04, 0.06, 0.16), second if kit.chance(0.6) else white, (0.8, 1.3))
    f.belt(white, 0.022, 0.12)
    f.wrap(0, 0.0, 0.85, 0.062, dark, CYL, 1.3)
    if kind != "plumed":
        f.chest(BOX, (-b.deep - 0.07, 0, 0.34), (0.065, 0.15, 0.12), kit.material(base=[0.3, 0.18, 0.1], pattern=CLOUDY))
        f.chest(CYL, (-b.deep - 0.07, 0, 0.5), (0.06, 0.06, 0.19), plain(kit, [0.4] * 3), tilt=ALONG_Y)


def soldier_kit(kit):
    """Soldiers, guards, sailors, pilots, divers, paratroopers, riot police, firefighters, medics, of all ages; as toys of one plastic on bases too."""
    kind = kit.rng.choice([modern, parade, service, great_war, ancient, napoleonic], p=[0.36, 0.1, 0.25, 0.12, 0.1, 0.07])
    kind(kit)
    if kind is not service and kit.chance(0.12):
        toy = kit.material(
            base=[[0.06, 0.2, 0.05], [0.5, 0.4, 0.2], [0.25, 0.27, 0.28], [0.03, 0.1, 0.3]][kit.rng.integers(4)], pattern=PLAIN, gloss=kit.rng.uniform(0.1, 0.4)
        )
        if kit.chance(0.7):
            kit.primitives[:] = [p._replace(material=toy) for p in kit.primitives]
        low = min(lowest(p) for p in kit.primitives)
        feet = [p.centre for p in kit.primitives if lowest(p) < low + 0.12]
        first, last = np.min(feet, 0), np.max(feet, 0)
        half = (last - first) / 2 + [0.2, 0.18, 0]
        base = kit.primitives[:58]
        kit.primitives[:] = base
        shape = BALL if kit.chance(0.3) else CYL
        kit.add(shape, (*((first + last) / 2)[:2], low), (half[0], half[1], 0.035), (0.95, 1), material=toy)
    finish(kit, 0.15)
