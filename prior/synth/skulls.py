"""Heads of the four-legged species, with their ears, horns, antlers and tusks."""

import numpy as np

from .animals import BLACK, CREAM, DARK, PINK, WHITE, bend, fur, hull
from .kit import turn
from .layout import BALL, CYL
from .materials import PLAIN, paint
from .species import CANINE, CATTLE, FELINE, SPLIT


def antlers(head, horn, far, palms):
    """Beams with tines, or with `palms` the shovels of a moose."""
    kit, size = head.kit, head.size
    for side in (1, -1):
        if palms:
            root, palm = head.place(-0.1, 0.4 * side, 0.7), head.place(-0.4, 1.6 * side, 1.0)
            kit.between(root, palm, size * 0.17, material=horn)
            way = head.facing @ turn("x", -42 * side) @ turn("y", -20)
            kit.add(
                BALL, head.place(-0.6, (1.9 + 0.3 * far) * side, 1.1 + 0.25 * far), np.array([0.16, 0.45 + 0.2 * far, 0.7 + 0.2 * far]) * size, rotation=way, material=horn
            )
            for x, y, z in ((0.5, 1.9, 1.7), (-0.7, 2.8, 2.7)):
                start = head.place(-0.5, (1.9 + 0.2 * far) * side, 1.2 + 0.2 * far)
                kit.between(start, head.place(x, (y + 0.2 * far) * side, z + 0.1 * far), size * 0.15, CYL, 0.25, horn)
        else:
            path = bend((-0.1, 0.35, 0.75), (-1.1, 1.3 + 0.3 * far, 0.9 + 0.5 * far), (-0.1, 0.7 + 0.4 * far, 0.9 + 1.1 * far), 4)
            spots = [head.place(x, y * side, z) for x, y, z in path]
            hull(kit, spots, np.array([0.17, 0.14, 0.12, 0.06]) * size, horn, first=False)
            for k, out in ((0, (0.9, 0.1, 0.6)), (1, (0.9, 0.1, 0.5)), (2, (-0.5, 0.2, 0.9))):
                tip = path[k] + np.array(out) * (0.5 + 0.25 * far) + [0.05, 0, 0.05]
                kit.between(spots[k] if k else head.place(*(path[0] * [1, side, 1] + [0, 0, 0.2])), head.place(tip[0], tip[1] * side, tip[2]), size * 0.12, CYL, 0.25, horn)


def skull(kit, name, head, m, e, coat, muzzle, hair, male):
    """Head of a species: skull, muzzle, jaw, nose, eyes, ears, horns; m: from the skull's middle to the nose, e: radius there."""
    rng, size = kit.rng, head.size
    far, end = m / size, e / size
    dark = fur(kit, BLACK, (0.04, 0.025, 0.02), pattern=PLAIN, gloss=0.4)
    pink = fur(kit, PINK, pattern=PLAIN)
    iris = kit.material(base=paint(rng.choice([0.1, 0.13, 0.3, 0.55]), 0.8, 0.6), pattern=PLAIN, gloss=0.6)
    horn = fur(kit, (0.3, 0.24, 0.17), DARK, CREAM, pattern=PLAIN, gloss=0.15)
    if name == "elephant":
        head.ball((0.05, 0, 0.3), (0.95, 0.88, 0.95), coat)
        head.ball((0.45, 0, -0.35), (0.6, 0.62, 0.75), coat)
        hang = [(0.75, 0, -0.1), (1.2, 0, -0.9), (1.25, 0, -1.9), (1.15, 0, -2.9), (1.4, 0, -3.3)]
        ways = [hang, [*hang[:3], (1.6, 0, -2.6), (2.1, 0, -2.4)], [(0.75, 0, -0.1), (1.5, 0, -0.6), (2.1, 0, -0.1), (2.4, 0, 0.8), (2.9, 0, 1.2)]]
        path = [head.place(*p) for p in ways[rng.integers(3)]]
        hull(kit, path, np.array([0.48, 0.37, 0.29, 0.22, 0.15]) * size, coat, first=False)
        large = rng.uniform(0.7, 1.15)
        for side in (1, -1):
            fan = head.facing @ turn("z", -40 * side) @ turn("x", 6 * side)
            kit.add(BALL, head.place(-0.4, (0.75 + 0.45 * large) * side, 0), np.array([0.8 * large, 0.08, 0.95 * large]) * size, rotation=fan, material=coat)
            kit.add(BALL, head.place(-0.35, (0.7 + 0.4 * large) * side, -0.65 * large), np.array([0.5 * large, 0.08, 0.7 * large]) * size, rotation=fan, material=coat)
        if kit.chance(0.8):
            long = rng.uniform(0.4, 1.2)
            head.rods([(0.7, 0.42, -0.6), (1.1 + 0.4 * long, 0.6, -1.2), (1.3 + long, 0.5, -1.1 + 0.2 * long)], [0.13, 0.11, 0.04], fur(kit, CREAM, pattern=PLAIN, gloss=0.3))
        head.eyes(0.72, 0.64, 0.1, 0.08)
        return
    if name in FELINE:
        head.ball((0, 0, 0.03), (1.0, 0.95, 0.92), coat)
        head.ball((0.1, 0, -0.32), (0.85, 0.88, 0.62), coat)
        head.ball((far * 0.52, 0, -0.05), (far * 0.42, 0.34, 0.4), coat)
        head.ball((far - end * 0.95, end * 0.42, -0.32), (end * 0.95, end * 0.75, end * 0.68), muzzle, True)
        head.ball((far - end * 1.25, 0, -0.62), (end * 0.85, end * 0.7, end * 0.42), muzzle)
        head.ball((far - end * 0.2, 0, -0.14), (0.11, 0.17, 0.1), pink if kit.chance(0.5) else dark)
        head.eyes(0.83, 0.42, 0.2, 0.15, iris)
        head.ear("prick" if name == "cat" else "round", rng.uniform(0.55, 0.75) if name == "cat" else 0.66, coat, pink if name == "cat" else muzzle)
        return
    if name in CANINE:
        flat = name in ("bulldog", "pug")
        head.ball((0, 0, 0), (1.05, 0.93 if not flat else 1.02, 0.93), coat)
        head.ball((0.2, 0, -0.3), (0.8, 0.86 if name in ("husky", "fox", "wolf", "corgi") else 0.75, 0.6), muzzle if name in ("husky", "fox", "corgi") else coat)
        tip = np.array([far - end, 0, -0.24])
        hull(kit, [head.place(0.35, 0, -0.12), head.place(*tip)], [size * (0.62 if not flat else 0.8), e], muzzle, 0.88 if not flat else 1.05, first=False)
        kit.between(head.place(0.2, 0, -0.5), head.place(far - end * 1.7, 0, -0.3 - end * 0.8), (size * 0.32, size * 0.5), CYL, max(0.45, end * 0.9), muzzle)
        head.ball((far - end * 0.25, 0, -0.24 + end * 0.5), (0.16, 0.2, 0.16), dark)
        if flat:
            head.ball((far - end * 1.1, end * 0.62, -0.42), (end * 0.8, end * 0.5, end * 0.95), muzzle, True)
        elif name == "terrier":
            head.ball((far - end * 1.4, 0, -0.5), (end * 1.3, end * 1.2, end * 1.3), muzzle)
            head.ball((0.78, 0.42, 0.5), (0.25, 0.25, 0.12), muzzle, True)
        elif kit.chance(0.35):
            head.ball((far - end * 1.1, 0, -0.35 - end), (end * 1.1, end * 0.5, 0.07), fur(kit, (0.55, 0.16, 0.15), pattern=PLAIN, gloss=0.3))
        head.eyes(0.78, 0.46, 0.24, 0.13, iris if name == "husky" else None)
        ears = {"shepherd": ("prick", 0.85), "husky": ("prick", 0.6), "wolf": ("prick", 0.6), "fox": ("prick", 0.85), "corgi": ("prick", 0.8)}
        ears |= {"bulldog": ("flop", 0.45), "pug": ("flop", 0.5), "greyhound": ("flop", 0.55), "terrier": ("flop", 0.45)}
        ears |= {"dachshund": ("flop", 1.0), "poodle": ("flop", 1.1), "beagle": ("flop", 1.0)}
        tint = hair if name not in ("bulldog", "pug", "beagle") else muzzle if name == "pug" else coat
        head.ear(*ears.get(name, ("flop", 0.75)), tint, pink if kit.chance(0.5) else dark if name == "fox" else muzzle)
        if name == "poodle":
            head.ball((-0.1, 0, 0.65), (0.85, 0.85, 0.8), hair)
        if name == "husky":
            head.ball((0.55, 0, 0.5), (0.5, 0.22, 0.4), coat)
        return
    if name in ("bear", "badger", "raccoon", "otter", "anteater", "armadillo", "mouse", "hyena", "capybara"):
        head.ball((0, 0, 0), (1.08, 0.95, 0.95), muzzle if name == "badger" else coat)
        head.ball((0.15, 0, -0.3), (0.85, 0.9, 0.62), coat if name != "otter" else muzzle)
        tip = np.array([far - end, 0, -0.3])
        root = 0.62 if name not in ("capybara", "hyena") else 0.78
        kit.between(head.place(0.3, 0, -0.1), head.place(*tip), (size * root, size * root * 0.88), CYL, end / root, muzzle if name != "capybara" else coat)
        head.ball(tip, (end * 1.05, end * 0.95, end), muzzle)
        kit.between(head.place(0.2, 0, -0.48), head.place(far - end * 1.8, 0, -0.3 - end * 0.6), (size * 0.32, size * 0.46), CYL, max(0.4, end * 0.8), muzzle)
        small = {"anteater": 0.6, "capybara": 1.5}.get(name, 1.0)
        head.ball((far - end * 0.25, 0, -0.27 + end * 0.4), (0.15 * small, 0.19 * small, 0.15 * small), pink if name == "mouse" else dark)
        head.eyes(*((0.72, 0.5, 0.28) if name not in ("capybara", "mouse") else (0.5, 0.78, 0.35)), 0.1 if name in ("bear", "badger") else 0.13)
        if name == "badger":
            for side in (1, -1):
                kit.add(BALL, head.place(0.35, 0.5 * side, 0.12), np.array([0.95, 0.26, 0.62]) * size, rotation=head.facing @ turn("z", 12 * -side), material=dark)
        elif name == "raccoon":
            head.ball((0.62, 0.5, 0.12), (0.36, 0.38, 0.24), dark, True)
            head.eyes(0.92, 0.58, 0.2, 0.1)
            head.ball((0.7, 0, 0.42), (0.3, 0.14, 0.3), muzzle)
        ears = {"bear": ("round", 0.62), "badger": ("round", 0.5), "otter": ("round", 0.35), "mouse": ("round", 1.25), "armadillo": ("leaf", 0.7)}
        kind, large = ears.get(name, ("round", 0.55))
        head.ear(kind, large, coat if name != "badger" else dark, pink if name == "mouse" else None)
        return
    # Hoofed animals and the rest: a long wedge of a head.
    head.ball((0, 0, 0), (1.05, 0.82, 0.95), coat)
    tip = np.array([far - end, 0, -0.32])
    blunt = 0.92 if name in ("pig", "boar", "hippo", "rhino") else 0.84
    hull(kit, [head.place(0.15, 0, -0.08), head.place(*tip)], [size * blunt, e], coat, 0.82 if name != "hippo" else 1.0, first=False)
    head.ball((0.22, 0, -0.42), (0.75, 0.6 if name not in ("pig", "boar", "hippo") else 0.88, 0.66), coat)
    if name in ("pig", "boar"):
        snout = fur(kit, PINK if max(coat.first) > 0.4 else DARK, pattern=PLAIN, gloss=0.1)
        kit.between(head.place(far - end * 1.4, 0, -0.32), head.place(far, 0, -0.3), e * 1.02, CYL, 1.16, snout)
        head.ball((far, end * 0.42, -0.27), (0.04, end * 0.18, end * 0.25), dark, True)
        head.ear("prick" if name == "boar" or kit.chance(0.5) else "flop", rng.uniform(0.55, 0.8), coat, pink)
        head.eyes(0.62, 0.62, 0.3, 0.09)
        if name == "boar":
            head.rods([(far - end * 1.6, end * 0.7, -0.5), (far - end * 1.1, end * 1.4, 0.05)], [0.1, 0.03], fur(kit, WHITE, pattern=PLAIN))
            head.ball((-0.6, 0, 0.75), (0.9, 0.25, 0.5), hair)
        return
    if name == "hippo":
        head.ball((far - end, end * 0.45, -0.3), (end * 0.9, end * 0.68, end * 0.95), coat, True)
        head.ball((far - end * 1.5, 0, -0.75), (end * 1.5, end * 1.1, end * 0.55), muzzle)
        head.ball((far - end * 0.5, end * 0.45, end * 0.55), (0.14, 0.13, 0.12), dark, True)
        head.ball((0.35, 0.48, 0.72), (0.26, 0.2, 0.24), coat, True)
        head.eyes(0.5, 0.6, 0.78, 0.1)
        head.ear("round", 0.45, coat, pink)
        return
    if name == "rhino":
        head.ball((far - end, 0, -0.42), (end * 1.15, end * 1.2, end * 1.15), coat)
        high = rng.uniform(1.0, 2.1)
        head.rods([(far - end * 0.8, 0, 0), (far - end * 0.3, 0, high * 0.6), (far - end * 0.6, 0, high)], [0.36, 0.2, 0.05], horn, both=False)
        if kit.chance(0.75):
            head.rods([(far - end * 2.1, 0, 0.15), (far - end * 1.9, 0, 0.45 + high * 0.35)], [0.3, 0.06], horn, both=False)
        head.ear("leaf", 0.5, coat, dark)
        head.eyes(0.62, 0.66, 0.1, 0.09)
        return
    head.ball(tip, (end * 1.15, end * 1.02, end * 1.06), muzzle)
    if name == "tapir":
        hull(kit, [head.place(*tip), head.place(far + end * 0.5, 0, -0.4), head.place(far + end * 0.8, 0, -0.85)], [e * 0.85, e * 0.6, e * 0.45], coat, first=False)
    elif name == "moose":
        head.ball((far - end * 1.5, 0, -0.1), (end * 1.8, end * 0.85, end * 0.95), muzzle)
        head.ball((0.35, 0, -1.35), (0.2, 0.14, 0.6), hair)
    elif name in (*CATTLE, "deer"):
        head.ball((far - end * 0.35, 0, -0.26), (end * 0.55, end * 0.78, end * 0.6), fur(kit, PINK, BLACK, BLACK, pattern=PLAIN, gloss=0.3))
    if name not in (*CATTLE, "deer", "tapir"):
        head.ball((far - end * 0.25, end * 0.5, -0.2), (end * 0.22, end * 0.22, end * 0.26), dark, True)
    head.eyes(0.42, 0.7, 0.26, 0.14)
    ears = {
        "zebu": ("flop", 1.0),
        "donkey": ("leaf", 1.15),
        "horse": ("leaf", 0.5),
        "pony": ("leaf", 0.45),
        "zebra": ("leaf", 0.6),
        "llama": ("leaf", 0.75),
        "camel": ("leaf", 0.32),
        "tapir": ("round", 0.5),
    }
    head.ear(*ears.get(name, ("side", rng.uniform(0.6, 0.9))), coat, pink if name not in SPLIT or name == "deer" else None)
    if name in ("horse", "pony") and kit.chance(0.5):
        head.ball((far * 0.45, 0, 0.3 - 0.08 * far), (far * 0.42, 0.2, 0.4), fur(kit, WHITE, pattern=PLAIN), tilt=(0, -12))
    if name in ("horse", "pony", "llama"):
        head.ball((0.25, 0, 0.72), (0.55, 0.32, 0.38), hair)
    if name == "bison":
        head.rods([(0, 0.7, 0.5), (0.1, 1.25, 0.75), (0.1, 1.3, 1.3)], [0.24, 0.17, 0.05], horn)
        head.ball((0.15, 0, 0.45), (0.85, 0.85, 0.75), hair)
        head.ball((0.55, 0, -1.05), (0.4, 0.35, 0.8), hair)
    elif name in ("cow", "bull") and kit.chance(0.55 if name == "cow" else 0.9):
        wide, up = rng.uniform(0.3, 1.0), rng.uniform(0.2, 1.1)
        head.rods([(-0.1, 0.5, 0.75), (-0.05, 0.9 + wide, 0.9), (0.25, 1.0 + wide, 0.9 + up)], [0.2, 0.15, 0.04], horn)
    elif name == "zebu" and kit.chance(0.9):
        high = rng.uniform(0.4, 1.5)
        head.rods([(-0.1, 0.45, 0.75), (-0.2, 0.75, 1.0 + 0.4 * high), (-0.1, 0.95, 1.0 + high)], [0.18, 0.14, 0.04], horn)
    elif name == "buffalo":
        far = rng.uniform(0.6, 1.2)
        head.rods([(0.1, 0.45, 0.7), (-0.35, 1.1 + 0.4 * far, 0.5), (-0.7, 1.2 + far, 0.8 + 0.5 * far)], [0.28, 0.22, 0.05], dark)
    elif name == "goat":
        long = rng.uniform(0.6, 1.4)
        head.rods([(0.05, 0.3, 0.75), (-0.2, 0.45, 0.9 + long), (-0.4 - long, 0.7, 1.0 + long)], [0.22, 0.17, 0.05], horn)
        head.ball((far - end * 2, 0, -1.05), (0.2, 0.15, 0.5), hair)
    elif name == "sheep" and male:
        head.rods([(0, 0.5, 0.7), (-0.75, 1.05, 0.4), (-0.2, 1.35, -0.5), (0.45, 1.5, 0.1)], [0.34, 0.3, 0.2, 0.06], horn)
    elif name in ("deer", "moose") and male:
        antlers(head, horn, rng.uniform(1.4, 2.6), name == "moose")
    elif name == "giraffe":
        head.rods([(-0.1, 0.35, 0.6), (-0.35, 0.5, 1.6)], [0.17, 0.2], hair)
