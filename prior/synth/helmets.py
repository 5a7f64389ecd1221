"""What troops wear: helmets, caps, shakos and plumes, camouflage, webbing."""

import numpy as np

from .figures import bar, hair_on, hat_on, plain
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, PRISM
from .materials import CAMOUFLAGE, PLAIN


def helm(kit, f, kind, material, second):
    """Helmets and caps of every kind of service and age."""
    rng, head, dark = kit.rng, f.on_head(), kit.material(dark=True, pattern=PLAIN)
    gold, steel = plain(kit, [0.65, 0.45, 0.12], 0.5), plain(kit, [0.5, 0.5, 0.52], 0.5)
    if kind not in ("visor", "pilot", "greathelm", "bascinet", "diving"):
        f.face(kind in ("cap", "peaked", "beret", "shako", "brodie"))
    if kind in ("cap", "peaked", "beret", "beanie", "hard"):
        hat_on(kit, head, kind, material, f.w.hair)
    elif kind in ("modern", "m1", "stahl", "police", "visor", "pilot"):
        head(BALL, (-0.08, 0, 0.42), (1.04, 0.94, 0.88), material)
        if kind == "modern":
            head(BALL, (-0.2, 0.7, 0.05), (0.42, 0.2, 0.48), material, mirror=True)
            head(BOX, (0.9, 0, 0.7), (0.12, 0.16, 0.16), dark)
            if kit.chance(0.4):
                head(CYL, (1.15, 0.2, 0.75), (0.15, 0.15, 0.25), dark, tilt=ALONG_X, mirror=True)
            if kit.chance(0.4):
                head(BOX, (0.66, 0, 0.08), (0.12, 0.5, 0.2), dark)
            bar(head, (-0.1, 0.66, 0), (0.35, 0.15, -0.98), 0.05, dark, mirror=True)
        elif kind == "m1":
            head(CYL, (-0.05, 0, 0.25), (1.14, 1.02, 0.1), material, (0.94, 1))
            bar(head, (0, 0.7, 0.2), (0.35, 0.15, -0.98), 0.05, dark, mirror=True)
        elif kind == "stahl":
            head(CYL, (-0.1, 0, 0.1), (1.25, 1.1, 0.3), material, (0.82, 1), turn("y", 6))
        elif kind == "pilot":
            head(BALL, (-0.1, 0, 0.05), (0.88, 0.92, 0.95), material)
            head(BALL, (0.32, 0, 0.35), (0.68, 0.76, 0.42), dark._replace(gloss=0.6))
            head(BALL, (0.7, 0, -0.45), (0.35, 0.36, 0.4), second)
            bar(head, (0.95, 0, -0.6), (0.6, 0.1, -2.3), 0.16, dark)
        else:
            head(BALL, (-0.2, 0, 0.0), (0.85, 0.9, 0.7), material)
            glass = kit.material(base=[0.25, 0.32, 0.36], pattern=PLAIN, gloss=0.6)
            head(BALL, (0.25, 0, -0.05 if kind == "visor" else 0.4), (0.78, 0.74, 0.85 if kind == "visor" else 0.6), glass if kind == "visor" else dark)
    elif kind == "brodie":
        head(BALL, (-0.08, 0, 0.55), (0.95, 0.86, 0.66), material)
        head(CYL, (-0.06, 0, 0.5), (1.5, 1.35, 0.11), material, (0.68, 1))
        bar(head, (0, 0.7, 0.4), (0.35, 0.15, -0.98), 0.05, dark, mirror=True)
    elif kind == "adrian":
        head(BALL, (-0.08, 0, 0.45), (0.98, 0.88, 0.8), material)
        head(CYL, (-0.02, 0, 0.35), (1.22, 1.0, 0.07), material, (0.85, 1))
        head(BOX, (-0.15, 0, 1.2), (0.62, 0.08, 0.14), material, (0.6, 1))
    elif kind == "fire":
        head(BALL, (-0.08, 0, 0.45), (1.02, 0.92, 0.9), material)
        head(CYL, (-0.28, 0, 0.35), (1.45, 1.08, 0.06), material, (0.9, 1), turn("y", -10))
        head(BOX, (-0.1, 0, 1.28), (0.7, 0.07, 0.12), material, (0.5, 1))
        head(BOX, (0.9, 0, 0.75), (0.06, 0.28, 0.36), gold, (1, 0.5), turn("y", -15))
    elif kind == "sailor":
        hair_on(head, rng, "short", f.w.hair)
        head(CYL, (-0.1, 0, 0.85), (0.8, 0.75, 0.2), material if kit.chance(0.5) else dark, (1.12, 1))
        head(BALL, (-0.1, 0, 1.02), (0.88, 0.82, 0.25), material)
    elif kind == "shako":
        head(BALL, (-0.22, 0, 0.2), (0.76, 0.74, 0.7), f.w.hair)
        head(CYL, (-0.08, 0, 1.1), (0.8, 0.76, 0.6), material, (1.15, 1))
        head(CYL, (0.65, 0, 0.55), (0.5, 0.55, 0.04), dark, tilt=turn("y", 15))
        head(BOX, (0.8, 0, 1.05), (0.06, 0.25, 0.25), gold)
        head(BALL, (0.75, 0, 2.0), (0.16, 0.16, 0.5), second)
    elif kind == "bearskin":
        head(BALL, (-0.05, 0, 1.15), (1.0, 0.98, 1.25), material)
        head(BALL, (-0.2, 0, 0.3), (0.85, 0.84, 0.7), material)
        bar(head, (0.2, 0.68, 0.3), (0.5, 0.15, -0.8), 0.05, gold, mirror=True)
    elif kind == "tricorn":
        head(BALL, (-0.2, 0, 0.2), (0.8, 0.76, 0.75), f.w.hair)
        head(BALL, (-0.1, 0, 0.75), (0.8, 0.76, 0.5), material)
        head(PRISM, (-0.02, 0, 0.72), (1.12, 1.08, 0.27), material, (1.2, 3))
        head(PRISM, (-0.02, 0, 0.98), (1.37, 1.32, 0.03), plain(kit, [0.6, 0.5, 0.25], 0.3), (1, 3))
        head(PRISM, (-0.02, 0, 1.0), (1.22, 1.17, 0.03), material, (1, 3))
        head(BALL, (-0.1, 0, 0.85), (0.75, 0.72, 0.55), material)
        head(BALL, (-0.95, 0, -0.4), (0.16, 0.14, 0.45), f.w.hair)
    elif kind == "plumed":
        head(BALL, (-0.35, 0, -0.1), (0.7, 0.85, 0.95), f.w.hair)
        head(CYL, (-0.05, 0, 0.65), (1.6, 1.5, 0.05), material, tilt=turn("x", 8))
        head(CYL, (-0.08, 0, 0.95), (0.82, 0.76, 0.32), material, (0.9, 1))
        head(BALL, (-0.8, 0.75, 1.05), (0.9, 0.2, 0.3), second, tilt=turn("z", -20) @ turn("y", -15))
    elif kind == "galea":
        head(BALL, (-0.08, 0, 0.4), (0.98, 0.86, 0.84), material)
        head(BALL, (0.16, 0.62, -0.4), (0.38, 0.1, 0.55), material, mirror=True)
        head(CYL, (-0.55, 0, -0.25), (0.95, 0.95, 0.06), material, tilt=turn("y", -20))
        for a in (-70, -35, 0, 35, 70) if kit.chance(0.7) else ():
            s, c = np.sin(np.radians(a)), np.cos(np.radians(a))
            head(BOX, (-0.08 + 1.05 * s, 0, 0.45 + 1.0 * c), (0.36, 0.1, 0.26), second, (1.15, 1), turn("y", a))
    elif kind == "kabuto":
        head(BALL, (-0.08, 0, 0.5), (1.0, 0.9, 0.82), material)
        for k in range(3):
            head(CYL, (-0.2, 0, 0.18 - 0.26 * k), (1.15 + 0.12 * k, 1.1 + 0.12 * k, 0.14), second if k % 2 else material, (0.88, 1))
        bar(head, (0.8, 0.12, 0.8), (0.9, 0.75, 1.9), (0.05, 0.16), gold, 0.3, True, BOX)
        head(BALL, (0.5, 0, -0.45), (0.4, 0.5, 0.5), dark)
    elif kind == "greathelm":
        head(CYL, (0.02, 0, -0.05), (0.92, 0.8, 1.0), material, (0.92, 1))
        head(CYL, (0.02, 0, 1.02), (0.82, 0.72, 0.12), material, (0.8, 1))
        head(BOX, (0.88, 0, 0.15), (0.06, 0.5, 0.06), dark)
        head(BOX, (0.9, 0, -0.1), (0.06, 0.07, 0.9), gold)
    elif kind == "bascinet":
        head(CYL, (-0.05, 0, 0.7), (0.98, 0.88, 0.75), material, (0.2, 1))
        head(BALL, (-0.08, 0, 0.1), (0.95, 0.87, 0.85), material)
        head(CYL, (0.75, 0, -0.1), (0.62, 0.6, 0.45), material, (0.2, 1), ALONG_X)
        head(BOX, (0.85, 0, 0.28), (0.1, 0.4, 0.05), dark)
        head(CYL, (-0.1, 0, -1.1), (1.25, 1.35, 0.35), steel, (0.65, 1))
    elif kind == "diving":
        head(BALL, (-0.12, 0, 0.1), (0.9, 0.76, 0.95), material)
        head(BOX, (0.72, 0, 0.12), (0.2, 0.5, 0.3), plain(kit, [0.1, 0.2, 0.25], 0.6), (1, 0.9))
        head(BALL, (0.8, 0, -0.5), (0.25, 0.3, 0.2), dark)


def drab(kit, base=None, camo=0.65):
    rng = kit.rng
    base = (
        np.array([[0.2, 0.19, 0.11], [0.36, 0.3, 0.19], [0.1, 0.12, 0.07], [0.25, 0.26, 0.26]][rng.integers(4)]) * rng.uniform(0.6, 1.5)
        if base is None
        else np.array(base)
    )
    return kit.material(base=base, pattern=CAMOUFLAGE if kit.chance(camo) else PLAIN, frequency=rng.uniform(10, 22), gloss=0.02, second=base * rng.uniform(0.3, 0.6))


def webbing(kit, f, vest, full=True):
    """Body armour with pouches, a pack, a radio with its aerial."""
    rng, b = kit.rng, f.b
    deep = b.deep + 0.035
    f.chest(BOX, (0.008, 0, 0.33), (deep, b.shoulder * 0.86, 0.17), vest, (0.9, 0.88))
    for y in np.linspace(-0.1, 0.1, 3):
        f.chest(BOX, (deep + 0.02, y, rng.choice([0.2, 0.24])), (0.03, 0.042, 0.065), vest)
    f.belt(vest, 0.035, 0.08)
    if full and kit.chance(0.6):
        size = rng.uniform((0.08, 0.13, 0.16), (0.14, 0.18, 0.26))
        f.chest(BOX, (-deep - size[0], 0, 0.34), size, vest, (0.9, 0.9))
        f.chest(CYL, (-deep - size[0], 0, 0.36 + size[2]), (0.075, 0.075, 0.19), vest, tilt=ALONG_Y)
        if kit.chance(0.5):
            f.limb(f.high(-deep - 0.05, 0.12, 0.45), f.high(-deep - 0.08, 0.13, rng.uniform(0.9, 1.3)), 0.007, 1, kit.material(dark=True))
    f.chest(BOX, (0, b.hip + 0.035, -0.02), (0.06, 0.035, 0.07), vest, low=True, mirror=True)
