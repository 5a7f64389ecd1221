"""What posed people wear: cloth, shirts, suits, coats, dresses, robes, hats, hair."""

from types import SimpleNamespace

import numpy as np

from .figures import hair_on, hat_on, plain
from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CHECKER, CLOUDY, DOTS, PATCHWORK, PLAIN, STRIPES, WRITING, paint
from .people import hair_material, skin_material


def fabric(kit, base=None, bold=0.4):
    pattern = kit.rng.choice([STRIPES, CHECKER, DOTS, BANDS, CLOUDY, PATCHWORK]) if kit.chance(bold) else PLAIN
    return kit.material(base=base, pattern=pattern, frequency=kit.rng.uniform(6, 18), gloss=kit.rng.uniform(0, 0.08))


def clothe(kit, stone=None, **more):
    """What somebody wears: materials; sleeves 0 to 2 and trousers 0 to 2 long; how wide the trousers end."""
    rng = kit.rng
    w = SimpleNamespace(stone=stone is not None, sleeves=2, trousers=2, cut=rng.choice([0.75, 0.85, 1.0, 1.3]), hem=None, hem_wide=1.0, thick=1.0, skirt=None, seat=None)
    names = ("skin", "hair", "top", "bottom", "shoes", "gloves", "socks", "arm")
    if w.stone:
        w.__dict__.update(dict.fromkeys(names, stone))
    else:
        w.skin, w.hair, w.top, w.bottom = skin_material(kit), hair_material(kit), fabric(kit), fabric(kit, bold=0.15)
        w.shoes, w.gloves, w.socks, w.arm = kit.material(dark=kit.chance(0.6), pattern=PLAIN), None, None, None
    w.__dict__.update(more)
    w.gloves, w.socks, w.arm, w.skirt, w.seat = w.gloves or w.skin, w.socks or w.skin, w.arm or w.top, w.skirt or w.bottom, w.seat or w.bottom
    return w


def coat_front(f, jacket, shirt, tie=None, low=0.1, wide=0.05):
    """The shirt that shows in an open jacket, and its collar."""
    b = f.b
    x = b.deep * 1.12 + 0.012
    f.chest(BALL, (0.022, 0, 0.36), (b.deep * 1.12, wide * 1.6, 0.2), shirt)
    f.chest(BOX, (x - 0.035, 0, (0.3 + low) / 2), (0.035 + b.belly * 0.5, wide, (0.34 - low) / 2), shirt)
    if tie is not None:
        f.chest(BOX, (x + 0.016, 0, 0.34), (0.012, 0.022, 0.16), tie, (0.5, 1), (turn("y", -4)))
    f.chest(BOX, (x - 0.012, wide + 0.025, 0.4), (0.014, 0.032, 0.12), jacket, (1, 0.6), turn("x", 14) @ turn("y", -9), mirror=True)
    f.chest(CYL, (0.0, 0, 0.585), (0.063, 0.066, 0.025), shirt, (0.93, 1))


def buttons(f, material, count, low, high, y=0.0):
    for z in np.linspace(low, high, count):
        f.chest(BALL, (f.b.deep * 1.1 + 0.012 - 0.1 * max(z - 0.42, 0), y, z), (0.012, 0.012, 0.012), material)


OUTFITS = ["casual", "tee", "shorts", "suit", "jacket", "hoodie", "overalls", "sport", "swim"]


def outfit(kit, b, kind):
    rng = kit.rng
    if kind == "casual":
        return clothe(kit, bottom=fabric(kit, np.array([0.09, 0.13, 0.25]) * rng.uniform(0.4, 2.2), 0) if kit.chance(0.5) else None or fabric(kit, bold=0.1))
    if kind == "tee":
        return clothe(kit, sleeves=1)
    if kind == "shorts":
        return clothe(kit, sleeves=1, trousers=1)
    if kind in ("suit", "jacket", "coat"):
        cloth = (
            fabric(kit, rng.uniform(0.015, 0.3) * np.array([1, rng.uniform(0.75, 1), rng.uniform(0.6, 1.3)]), 0.12)
            if kind != "jacket" or kit.chance(0.4)
            else fabric(kit)
        )
        return clothe(kit, top=cloth, seat=cloth, bottom=cloth if kind == "suit" else fabric(kit, bold=0.1), thick=1.1, cut=rng.choice([0.85, 1.0]))
    if kind == "hoodie":
        return clothe(kit, top=fabric(kit, bold=0.2) if kit.chance(0.6) else kit.material(pattern=BANDS, frequency=rng.uniform(10, 18), gloss=0.15), thick=1.25)
    if kind == "overalls":
        return clothe(
            kit, bottom=fabric(kit, paint(rng.choice([0.6, 0.58, 0.08, 0.3, 0.12]), rng.uniform(0.3, 0.9), rng.uniform(0.1, 0.5)), 0), sleeves=rng.choice([1, 2]), cut=1.0
        )
    if kind == "sport":
        team = fabric(kit, paint(rng.random(), 0.9, rng.uniform(0.2, 0.9)), 0.3)
        return clothe(
            kit, top=team, bottom=fabric(kit, bold=0), sleeves=rng.choice([0, 1]), trousers=rng.choice([1, 1, 2]), cut=0.75, socks=team if kit.chance(0.4) else None
        )
    if kind == "swim":
        w = clothe(kit, sleeves=0, trousers=rng.choice([0, 1]) if not b.woman else 0)
        w.shoes = w.skin
        w.top = w.top if b.woman and kit.chance(0.5) else w.skin
        if w.top is not w.skin:
            w.bottom = w.seat = w.top
        return w
    cloth = fabric(kit, bold=0.5)
    if kind == "kilt":
        tartan = kit.material(
            base=paint(rng.choice([0.0, 0.33, 0.6]), 0.8, rng.uniform(0.1, 0.4)),
            pattern=CHECKER,
            frequency=rng.uniform(8, 14),
            second=paint(rng.choice([0.33, 0.6, 0.15]), 0.7, 0.1),
        )
        return clothe(kit, bottom=tartan, hem=0.5, trousers=0, socks=plain(kit, [0.7, 0.66, 0.55]), hem_wide=1.1)
    if kind == "skirt":
        return clothe(kit, hem=rng.uniform(0.3, 0.68), trousers=0, hem_wide=rng.uniform(0.85, 1.4), sleeves=rng.integers(3))
    if kind == "dress":
        return clothe(kit, top=cloth, bottom=cloth, hem=rng.uniform(0.05, 0.6), trousers=0, hem_wide=rng.uniform(0.9, 1.9), sleeves=rng.integers(3))
    if kind == "thobe":
        cloth = plain(kit, np.array([0.8, 0.78, 0.74]) * rng.uniform(0.5, 1.1))
    wide = {"sari": 1.0, "kimono": 0.95}.get(kind, rng.uniform(1.0, 1.2))
    return clothe(
        kit, top=cloth, bottom=cloth, hem=rng.uniform(0.03, 0.1), trousers=0, hem_wide=wide, sleeves=1 if kind == "sari" else 2, thick=1.0 if kind == "sari" else 1.25
    )


def garments(kit, f, kind):
    """What an outfit has beyond the body's own materials."""
    rng, b, w = kit.rng, f.b, f.w
    if w.hem is not None:
        f.skirt(w.skirt, w.hem, w.hem_wide)
    leather = kit.material(dark=True, pattern=PLAIN)
    if kind in ("casual", "tee", "shorts") and kit.chance(0.5):
        f.belt(leather)
    elif kind in ("casual", "tee", "shorts"):
        f.chest(CYL, (0, 0, 0.05), (b.deep + b.belly * 0.9 + 0.012, b.hip + 0.014, 0.07), w.top, (0.95, 1), low=True)
    if kind == "casual" and kit.chance(0.6):
        f.chest(CYL, (0.004, 0, 0.58), (0.07, 0.075, 0.022), w.top, (0.85, 1), turn("y", 8))
        buttons(f, kit.material(pattern=PLAIN), 3, 0.2, 0.45)
    if kind in ("suit", "jacket", "coat"):
        shirt = plain(kit, [0.75, 0.75, 0.75]) if kind == "suit" else fabric(kit)
        coat_front(f, w.top, shirt, fabric(kit) if kind == "suit" and kit.chance(0.7) else None)
        if kind == "coat":
            f.skirt(w.top, rng.uniform(0.3, 0.65), 1.05, 0.2)
            if kit.chance(0.5):
                f.belt(leather, 0.03, 0.15)
        else:
            f.chest(CYL, (0, 0, 0.0), (b.deep + b.belly * 0.9 + 0.025, b.hip + 0.025, 0.12), w.top, (0.9, 1), low=True)
    elif kind == "hoodie":
        f.chest(BALL, (-0.085, 0, 0.56), (0.075, 0.13, 0.09), w.top, tilt=turn("y", 20))
        f.chest(CYL, (0, 0, 0.08), (b.deep + b.belly + 0.022, b.hip + 0.018, 0.06), w.top, low=True)
        f.chest(BOX, (b.deep + b.belly + 0.01, 0, 0.15), (0.02, 0.1, 0.06), w.top, (1, 0.7))
    elif kind == "overalls":
        x = b.deep * 1.1 + b.belly * 0.7
        f.belt(w.bottom, 0.05)
        f.chest(BOX, (x - 0.02, 0, 0.28), (0.04, 0.11, 0.14), w.bottom, (1, 0.85))
        for y in (0.09, -0.09):
            f.limb(f.high(x, y, 0.4), f.high(0.0, y, 0.56), 0.018, 1, w.bottom, BOX)
            f.limb(f.high(0.0, y, 0.56), f.high(-b.deep * 1.1, y * 0.6, 0.3), 0.018, 1, w.bottom, BOX)
        f.chest(BOX, (x + 0.02, 0, 0.3), (0.01, 0.05, 0.04), w.bottom)
    elif kind == "swim" and b.woman and w.top is w.skin:
        f.chest(BALL, (b.deep * 0.78, 0.07, 0.365), (0.072, 0.074, 0.06), w.bottom, mirror=True)
        f.chest(CYL, (0.005, 0, 0.35), (b.deep * 1.13, b.shoulder * 0.95, 0.02), w.bottom)
    elif kind == "swim" and w.top is w.skin and b.kind != "child":
        f.chest(BALL, (b.deep * 0.72, 0.075, 0.39), (0.05, 0.08, 0.06), w.skin, mirror=True)
    elif kind == "sport" and kit.chance(0.5):
        f.chest(BOX, (b.deep * 1.08, 0, 0.36), (0.02, 0.06, 0.07), kit.material(base=[0.8, 0.8, 0.8], pattern=WRITING, frequency=6))
    elif kind == "sari":
        second = fabric(kit, bold=0.7)
        f.chest(BALL, (0.012, 0.0, 0.31), (b.deep * 1.15 + 0.035, 0.085, 0.3), second, tilt=turn("x", -30))
        f.chest(BOX, (-b.deep - 0.012, 0.11, 0.12), (0.02, 0.085, 0.4), second, (1, 0.75), turn("y", 5))
        f.chest(CYL, (0, 0, 0.06), (b.deep + 0.02, b.hip + 0.012, 0.05), second, (0.95, 1), low=True)
    elif kind == "kimono":
        f.chest(CYL, (0, 0, 0.17), (b.deep + 0.03, b.waist + 0.035, 0.085), fabric(kit))
        f.chest(BOX, (-b.deep - 0.06, 0, 0.2), (0.045, 0.12, 0.1), fabric(kit))
        for hand, elbow in zip(f.hands, f.elbows, strict=True):
            along = (hand - elbow) * [1, 1, 0] / 2
            wide = np.hypot(*along[:2])
            spin = turn("z", np.degrees(np.arctan2(along[1], along[0])))
            kit.add(BOX, (hand + elbow) / 2 - [0, 0, 0.1 * b.size], (max(wide * 0.8, 0.07), 0.035, 0.16 * b.size), rotation=spin, material=w.top)
        f.chest(BOX, (b.deep * 0.95, 0.05, 0.45), (0.02, 0.02, 0.14), plain(kit, [0.8, 0.8, 0.8]), tilt=turn("x", 20), mirror=True)
    elif kind == "kilt":
        f.chest(BOX, (b.deep + 0.045, 0, -0.1), (0.035, 0.07, 0.07), leather, (0.8, 0.8), low=True)
        f.belt(leather, 0.03, 0.12)
    elif kind in ("robe", "thobe"):
        buttons(f, leather, 4, 0.2, 0.5)
        if kind == "robe":
            f.belt(fabric(kit), 0.025, 0.14)


def crown(kit, f, kind):
    """Hair, a hat, a beard."""
    rng, b, w = kit.rng, f.b, f.w
    head = f.on_head()
    if kind in ("thobe", "robe", "sari") and kit.chance(0.6):
        hat_on(
            kit,
            head,
            "scarf" if b.woman or kind == "thobe" else "turban",
            w.top if kind == "sari" else fabric(kit, [0.75, 0.74, 0.7] if kit.chance(0.5) else None, 0.2),
            w.hair,
        )
    elif kit.chance(0.27):
        hat_on(
            kit,
            head,
            rng.choice(["cap", "cap", "beanie", "beret", "brim", "cowboy", "turban", "scarf"] if not b.woman else ["cap", "beanie", "brim", "scarf", "beret"]),
            fabric(kit, bold=0.15),
            w.hair,
        )
    else:
        men = ["short", "short", "part", "quiff", "bald", "rim", "afro"]
        hair_on(
            head,
            rng,
            rng.choice(["long", "bob", "tail", "bun", "short", "long", "afro"] if b.woman else men),
            w.hair if b.kind != "old" else kit.material(base=np.ones(3) * rng.uniform(0.35, 0.8), pattern=PLAIN),
        )
    if not b.woman and b.kind != "child" and kit.chance(0.25):
        head(BALL, (0.4, 0, -0.72), (0.4, 0.46, rng.uniform(0.36, 0.7)), w.hair)
