"""Makers of figures that nobody is: cartoon characters, robots, snowmen, dolls, monsters, riders on animals and machines."""

import numpy as np

from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL, PRIMS, TUBE
from .materials import BANDS, CHECKER, DOTS, PLAIN, RIBS, SEAMS, STRIPES, paint
from .people import person_body, skin_material


def character(kit):
    """Big heads on short bodies, robots of boxes and joints, snowmen, dolls, monsters with horns, tails and wings."""
    rng = kit.rng
    body, second, dark = kit.material(pattern=rng.choice([PLAIN, PLAIN, STRIPES, DOTS, SEAMS])), kit.material(), kit.material(dark=True)
    white = kit.material(base=[0.85] * 3, pattern=PLAIN)
    kind = rng.choice(["cartoon", "robot", "snowman", "monster"], p=[0.35, 0.3, 0.1, 0.25])
    if kind == "snowman":
        z, radius = 0.0, rng.uniform(0.55, 0.8)
        snow = white if kit.chance(0.7) else body
        for _ in range(int(rng.integers(2, 4))):
            kit.add(BALL, (0, 0, z + radius * 0.9), (radius, radius, radius * 0.95), material=snow)
            z += radius * 1.65
            radius *= rng.uniform(0.62, 0.8)
        head, size = z - radius * 1.2, radius * 1.25
        kit.add(CYL, (size * 1.2, 0, head), (0.07, 0.07, 0.25), (0.1, 1), rotation=ALONG_X, material=kit.material(base=[0.8, 0.3, 0.03]))
        for y in (-1, 1):
            kit.add(BALL, (size * 0.9, y * size * 0.35, head + size * 0.3), (0.06, 0.06, 0.06), material=dark)
            kit.chain([(0, y * 0.55, z * 0.6), (0.1, y * rng.uniform(0.9, 1.2), z * rng.uniform(0.5, 0.85))], [0.04, 0.02], kit.material(base=[0.15, 0.09, 0.05]))
        kit.add(CYL, (0, 0, head + size * 1.1), (size * 0.7, size * 0.7, size * 0.4), material=dark)
        kit.add(CYL, (0, 0, head + size * 0.75), (size * 1.1, size * 1.1, 0.04), material=dark)
        kit.add(CYL, (0, 0, head - size * 0.8), (size * 0.85, size * 0.85, 0.09), material=second)
        return
    if kind == "robot":
        limb, joint = kit.material(pattern=rng.choice([PLAIN, RIBS, SEAMS, BANDS])), dark
        wide, high, deep = rng.uniform(0.35, 0.6), rng.uniform(0.35, 0.6), rng.uniform(0.22, 0.4)
        leg = rng.uniform(0.5, 1.1)
        shape = BOX if kit.chance(0.75) else CYL
        kit.add(shape, (0, 0, leg + high), (deep, wide, high), (1, rng.uniform(0.8, 1.4)) if shape == BOX else (1, 1), material=body)
        head, top = rng.uniform(0.2, 0.36), leg + 2 * high
        kit.add(CYL, (0, 0, top + 0.05), (0.1, 0.1, 0.08), material=joint)
        kit.add(BOX if kit.chance(0.6) else BALL, (0, 0, top + 0.1 + head), (head * 0.9, head * rng.uniform(0.9, 1.4), head), material=second if kit.chance(0.5) else body)
        if kit.chance(0.5):
            kit.add(BOX, (head * 0.88, 0, top + 0.15 + head), (0.04, head * 0.8, head * 0.25), material=dark)
        else:
            kit.add(CYL, (head * 0.9, head * 0.4, top + 0.15 + head), (0.08, 0.08, 0.04), rotation=ALONG_X, material=white, mirror=True)
        kit.between((0, head * 0.6, top + 2 * head), (0, head * 0.9, top + 2 * head + rng.uniform(0.1, 0.5)), 0.02, material=dark, mirror=kit.chance(0.6))
        kit.add(BOX, (deep, 0, leg + high * 1.2), (0.03, wide * 0.6, high * 0.4), material=second)
        for side in (-1, 1):
            lift = rng.uniform(-1.4, 0.8)
            elbow = np.array([0.1, side * (wide + 0.3), top - 0.15 + 0.35 * np.sin(lift)])
            hand = elbow + np.array([rng.uniform(0, 0.5), side * rng.uniform(-0.1, 0.3), rng.uniform(-0.5, 0.4)])
            kit.chain([(0, side * wide, top - 0.15), elbow], [0.1, 0.08], joint)
            kit.between(elbow, hand, (0.11, 0.11), BOX if kit.chance(0.6) else CYL, material=limb)
            kit.add(BOX, hand, (0.12, 0.08, 0.1), material=dark)
        if kit.chance(0.25):
            kit.add(BOX, (0, wide * 0.8, leg * 0.35), (deep * 1.7, 0.16, leg * 0.35), (0.7, 1), material=dark, mirror=True)
            kit.add(BOX, (0, 0, leg * 0.75), (deep * 0.6, wide * 0.7, leg * 0.3), material=limb)
        else:
            stride = rng.uniform(0, 0.25)
            for side in (-1, 1):
                kit.between((0, side * wide * 0.5, leg), (side * stride, side * wide * 0.55, leg * 0.5), 0.11, material=joint)
                kit.between((side * stride, side * wide * 0.55, leg * 0.55), (side * stride, side * wide * 0.55, 0.1), (0.14, 0.14), BOX, 1.1, material=limb)
                kit.add(BOX, (side * stride + 0.1, side * wide * 0.55, 0.07), (0.26, 0.16, 0.08), (0.8, 0.9), material=body)
        return
    head, trunk = rng.uniform(0.4, 0.75), rng.uniform(0.3, 0.55)
    leg, thick = rng.uniform(0.2, 0.7), rng.uniform(0.09, 0.2)
    hide = body if kind == "monster" else skin_material(kit)
    clothes = hide if kind == "monster" and kit.chance(0.6) else body
    middle = leg + trunk * 0.9
    kit.add(BALL if kit.chance(0.6) else CYL, (0, 0, middle), (trunk * 0.75, trunk * rng.uniform(0.75, 1.1), trunk), material=clothes)
    top = middle + trunk * 0.9 + head * 0.8
    kit.add(BALL, (0.05, 0, top), (head * rng.uniform(0.8, 1), head * rng.uniform(0.9, 1.2), head * rng.uniform(0.8, 1.05)), material=hide)
    eye = head * rng.uniform(0.12, 0.28)
    for y in (-1, 1):
        at = np.array([0.05 + head * 0.8, y * head * 0.38, top + head * 0.15])
        kit.add(BALL, at, (eye * 0.6, eye, eye * 1.2), material=white)
        kit.add(BALL, at + [eye * 0.5, 0, 0], (eye * 0.3, eye * 0.5, eye * 0.6), material=dark)
        kit.chain([(0, y * trunk * 0.7, middle + trunk * 0.5), (rng.uniform(-0.1, 0.4), y * (trunk + 0.3), middle + rng.uniform(-0.4, 0.7))], [thick, thick * 0.8], clothes)
        kit.add(BALL, kit.primitives[-1].centre, (thick * 1.3,) * 3, material=hide)
        kit.chain([(0, y * trunk * 0.4, leg * 1.1), (0, y * trunk * 0.45, 0.1)], [thick * 1.2, thick], second)
        kit.add(BALL, (0.1, y * trunk * 0.48, 0.09), (0.26, 0.15, 0.1), material=dark if kit.chance(0.5) else second)
    kit.add(BALL, (0.05 + head * 0.95, 0, top - head * 0.1), (head * 0.15, head * 0.13, head * 0.13), material=hide)
    if kind == "monster":
        if kit.chance(0.6):
            kit.chain([(0, head * 0.5, top + head * 0.7), (0.05, head * 0.8, top + head * rng.uniform(1.1, 1.6))], [0.1, 0.02], second, mirror=True)
        if kit.chance(0.6):
            kit.chain([(-trunk * 0.6, 0, middle - trunk * 0.4), (-trunk * 1.6, 0, 0.25), (-trunk * 2.3, rng.uniform(-0.4, 0.4), 0.4)], [0.2, 0.13, 0.03], hide)
        if kit.chance(0.4):
            kit.add(BOX, (-trunk * 0.7, trunk * 1.3, middle + trunk * 0.6), (0.02, trunk * 0.9, trunk * 0.6), (1, 0.3), rotation=turn("x", 25), material=second, mirror=True)
        kit.add(BOX, (0.05 + head * 0.85, 0, top - head * 0.5), (0.05, head * 0.4, 0.05), material=dark)
    elif kit.chance(0.7):
        hat = rng.choice(["cap", "cone", "hair"])
        if hat == "cone":
            kit.add(CYL, (0, 0, top + head * 1.3), (head * 0.75, head * 0.75, head * 0.6), (0.05, 1), material=second)
        else:
            colour = second if hat == "cap" else kit.material(base=paint(0.08, rng.uniform(0.2, 0.9), rng.uniform(0.02, 0.6)))
            kit.add(BALL, (-head * 0.12, 0, top + head * 0.25), (head, head * 1.12, head * 0.85), material=colour)
            if hat == "cap":
                kit.add(CYL, (head * 0.8, 0, top + head * 0.45), (head * 0.5, head * 0.6, 0.03), material=second)


def rider(kit):
    """Somebody on a horse, a bicycle, a motorcycle, a sledge or a scooter."""
    rng = kit.rng
    what = rng.choice(["horse", "bicycle", "board"])
    coat, dark = kit.material(), kit.material(dark=True)
    if what == "horse":
        long, tall, thick = rng.uniform(0.55, 0.75), rng.uniform(1.0, 1.25), rng.uniform(0.22, 0.3)
        fur = kit.material(base=np.array([0.35, 0.2, 0.1]) * rng.uniform(0.3, 2.2), pattern=rng.choice([PLAIN, 1]))
        kit.add(BALL, (0, 0, tall), (long * 1.2, thick, thick * 1.15), material=fur)
        for x in (long * 0.75, -long * 0.75):
            swing = rng.uniform(-0.25, 0.25)
            for y in (-1, 1):
                kit.chain([(x, y * thick * 0.6, tall - 0.1), (x + y * swing * 0.5, y * thick * 0.6, tall * 0.5), (x + y * swing, y * thick * 0.6, 0.06)], [0.12, 0.07, 0.06], fur)
        crest = np.array([long * 1.35, 0, tall + rng.uniform(0.35, 0.6)])
        kit.chain([(long * 0.9, 0, tall + 0.1), crest], [0.2, 0.13], fur)
        kit.between(crest, crest + [0.38, 0, -0.28], 0.12, taper=0.6, material=fur)
        kit.add(BOX, crest + [-0.15, 0, -0.05], (0.1, 0.03, 0.25), rotation=turn("y", 35), material=dark)
        kit.chain([(-long * 1.15, 0, tall + 0.1), (-long * 1.45, 0, tall * 0.6)], [0.07, 0.04], dark)
        kit.add(BALL, (0, 0, tall + thick * 0.9), (0.3, thick * 1.05, 0.12), material=coat)
        seat = tall + thick * 0.95
    elif what == "bicycle":
        radius = rng.uniform(0.3, 0.36)
        seat = 2.7 * radius
        for x in (-0.52, 0.52):
            kit.add(TUBE, (x, 0, radius), (radius, radius, 0.03), rotation=turn("x", 90), material=dark)
            kit.add(CYL, (x, 0, radius), (0.06, 0.06, 0.05), rotation=turn("x", 90), material=dark)
        hub, fork, crank, post = np.array([-0.52, 0, radius]), np.array([0.42, 0, 0.85]), np.array([-0.08, 0, radius]), np.array([-0.2, 0, seat - 0.06])
        for start, end in ((hub, crank), (hub, post), (crank, post), (post, fork), (crank, fork), (fork, np.array([0.52, 0, radius]))):
            kit.between(start, end, 0.025, material=coat)
        kit.between(fork + [0, -0.25, 0.12], fork + [0, 0.25, 0.12], 0.02, material=dark)
        kit.add(BOX, post + [0, 0, 0.03], (0.13, 0.07, 0.03), material=dark)
    else:
        seat = rng.uniform(0.2, 0.4)
        kit.add(BOX, (0, 0, seat - 0.05), (rng.uniform(0.5, 0.8), 0.22, 0.05), material=coat)
        kit.between((-0.6, 0.2, 0.04), (0.7, 0.2, 0.04), 0.03, BOX, material=dark, mirror=True)
        for x in (-0.4, 0.4):
            kit.between((x, 0.2, 0.04), (x, 0.2, seat - 0.08), 0.025, material=dark, mirror=True)
    room, first = PRIMS - len(kit.primitives), len(kit.primitives)
    size = rng.uniform(0.85, 1.0)
    top, bottom = kit.material(pattern=rng.choice([PLAIN, STRIPES, CHECKER])), kit.material()
    person_body(kit, (-0.15, 0, seat - 0.47 * size), size, top, bottom, skin_material(kit), "sit")
    kit.primitives = kit.primitives[: first + room]
