"""Makers of what is carried: bags, cases, cameras, lanterns, tools, umbrellas, books, cans, boxes, radios."""

import numpy as np

from .belongings import arc, black, brass, case, cloth, enamel, funnel, handle, leather, lens, pale, ribbon, steel, timber, tipped, twin
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, PRISM, SPOKES, TUBE
from .materials import BANDS, CAMOUFLAGE, CHECKER, CLOUDY, DOTS, PLAIN, RIBS, STREAKS, STRIPES, WRITING, paint


def luggage(kit):
    rng = kit.rng
    hide, metal, dark = leather(kit), brass(kit) if kit.chance(0.5) else steel(kit), black(kit)
    kind = rng.choice(["handbag", "backpack", "suitcase", "trolley", "holdall"])
    if kind == "handbag":
        x, y, z = rng.uniform(0.15, 0.28), rng.uniform(0.4, 0.65), rng.uniform(0.28, 0.5)
        narrow, shorter = rng.uniform(0.3, 0.85), rng.uniform(0.75, 1.05)
        kit.add(BOX, (0, 0, z), (x, y, z), (narrow, shorter), material=hide)
        if kit.chance(0.6):
            kit.add(
                BOX,
                (x * (narrow + 0.3) / 1.3, 0, z * 1.35),
                (0.03, y * 0.9 * shorter, z * 0.65),
                (1, 0.97),
                rotation=turn("y", -np.degrees(np.arctan2(x * (1 - narrow), 2 * z))),
                material=hide if kit.chance(0.6) else leather(kit),
            )
            kit.add(BOX, (x * 0.9, 0, z * 0.8), (0.05, 0.07, 0.06), material=metal)
        for side in (-1, 1) if kit.chance(0.5) else (0,):
            handle(kit, (side * x * narrow * 0.8, 0, 2 * z - 0.04), y * rng.uniform(0.4, 0.7), rng.uniform(0.25, 0.5), 0.03, dark if kit.chance(0.4) else hide)
        kit.add(BOX, (0, 0, 0.03), (x * 1.02, y * 1.01, 0.03), material=leather(kit))
    elif kind == "backpack":
        bag, trim = cloth(kit), cloth(kit)
        x, y, z = rng.uniform(0.2, 0.3), rng.uniform(0.32, 0.42), rng.uniform(0.5, 0.75)
        kit.add(BOX, (0, 0, z), (x, y, z), (rng.uniform(0.75, 0.95), rng.uniform(0.85, 0.98)), material=bag)
        kit.add(BALL, (-0.02, 0, 2 * z), (x * 0.95, y * 0.95, rng.uniform(0.12, 0.22)), material=trim)
        kit.add(BOX, (x * 1.15, 0, z * 0.65), (0.1, y * 0.75, z * 0.45), (0.7, 0.95), material=trim)
        kit.add(BOX, (x * 1.2, 0, z * 1.08), (0.1, y * 0.78, 0.04), material=bag)
        kit.add(BOX, (0, y * 1.1, z * 0.55), (x * 0.7, 0.08, z * 0.4), (0.9, 0.7), material=trim, mirror=True)
        ribbon(kit, arc((-x * 0.9, y * 0.5, z * 1.05), (0.2, z * 0.85), 95, 265, 7), (0.03, 0.06), dark, True)
        handle(kit, (-x * 0.7, 0, 2 * z), 0.09, 0.22, 0.025, dark)
        kit.between((x * 0.92, y * 0.5, z * 1.9), (x * 1.05, y * 0.5, z * 1.1), (0.01, 0.03), BOX, material=dark, mirror=True)
        if kit.chance(0.45):
            kit.add(CYL, (0, 0, 2 * z + 0.25), (0.15, 0.15, y * 1.15), rotation=ALONG_Y, material=cloth(kit))
            kit.add(CYL, (0, y * 0.6, 2 * z + 0.25), (0.155, 0.155, 0.03), rotation=ALONG_Y, material=dark, mirror=True)
    elif kind == "suitcase":
        x, y, z = rng.uniform(0.14, 0.24), rng.uniform(0.55, 0.8), rng.uniform(0.38, 0.52)
        case = leather(kit) if kit.chance(0.6) else enamel(kit)
        kit.add(BOX, (0, 0, z), (x, y, z), material=case)
        kit.add(BOX, (0, 0, z), (0.012, y * 1.01, z * 1.015), material=dark)
        for side in (-1, 1):
            for up in (-1, 1):
                kit.add(BOX, (0, side * (y - 0.08), z + up * (z - 0.08)), (x * 1.03, 0.09, 0.09), material=hide)
        handle(kit, (0, 0, 2 * z - 0.02), 0.2, 0.16, 0.035, hide)
        kit.add(BOX, (x * 0.3, y * 0.55, 2 * z), (x * 0.5, 0.06, 0.03), material=metal, mirror=True)
        if kit.chance(0.5):
            kit.add(BOX, (0, y * 0.5, z), (x * 1.04, 0.05, z * 1.02), material=hide, mirror=True)
    elif kind == "trolley":
        x, y, z = rng.uniform(0.2, 0.3), rng.uniform(0.38, 0.5), rng.uniform(0.55, 0.75)
        case = enamel(kit)
        kit.add(BOX, (0, 0, z + 0.1), (x, y, z), (0.97, 0.97), material=case)
        for k in range(int(rng.integers(3, 7))):
            kit.add(BOX, (x * 0.5, y * (0.12 + 0.15 * k), z + 0.1), (x * 0.53, 0.025, z * 0.9), material=case, mirror=True)
        kit.add(BOX, (0, 0, z + 0.1), (0.02, y * 1.02, z * 1.01), material=dark)
        kit.add(CYL, (x * 0.7, y * 0.75, 0.07), (0.07, 0.07, 0.05), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(CYL, (-x * 0.7, y * 0.75, 0.07), (0.07, 0.07, 0.05), rotation=ALONG_Y, material=dark, mirror=True)
        high = rng.choice([0.1, rng.uniform(0.4, 0.7)])
        kit.between((-x * 0.75, 0.2, 2 * z), (-x * 0.75, 0.2, 2 * z + 0.1 + high), 0.02, material=steel(kit), mirror=True)
        kit.between((-x * 0.75, -0.23, 2 * z + 0.12 + high), (-x * 0.75, 0.23, 2 * z + 0.12 + high), 0.035, BOX, material=dark)
        handle(kit, (x * 0.2, 0, 2 * z + 0.08), 0.16, 0.08, 0.025, dark)
    else:
        bag, strap = cloth(kit), leather(kit)
        r, y = rng.uniform(0.28, 0.38), rng.uniform(0.65, 0.95)
        kit.add(CYL, (0, 0, r), (r, r * 1.0, y), rotation=ALONG_Y, material=bag)
        kit.add(CYL, (0, y, r), (r * 1.0, r * 1.0, 0.05), (0.85, 1), rotation=turn("x", -90), material=strap, mirror=True)
        kit.add(BOX, (0, 0, r * 0.2), (r * 0.9, y * 0.95, r * 0.2), material=strap)
        kit.add(CYL, (0, y * 0.45, r), (r * 1.02, r * 1.02, 0.05), rotation=ALONG_Y, material=strap, mirror=True)
        for side in (-1, 1):
            handle(kit, (side * r * 0.35, 0, 1.85 * r), y * 0.45, rng.uniform(0.3, 0.45), 0.03, strap)
        kit.add(BOX, (0, 0, 2 * r), (0.025, y * 0.95, 0.015), material=steel(kit))


def optics(kit):
    """Binoculars, cameras with a lens, torches."""
    rng = kit.rng
    body, dark, metal, glass = enamel(kit), black(kit), steel(kit), lens(kit)
    kind = rng.choice(["binoculars", "camera", "torch"], p=[0.35, 0.4, 0.25])
    if kind == "binoculars":
        skin = black(kit) if kit.chance(0.5) else kit.material(base=paint(rng.uniform(0.1, 0.3), 0.5, rng.uniform(0.05, 0.3)), pattern=rng.choice([PLAIN, CAMOUFLAGE]))
        r, long = rng.uniform(0.2, 0.28), rng.uniform(0.4, 0.7)
        eye, apart, up = 0.12, rng.uniform(0.24, 0.28), r
        wide = rng.uniform(apart + 0.02, apart + 0.14)
        kit.add(BOX, (-0.15, (apart + wide) / 2, up), (0.2, (wide - apart) / 2 + 0.15, r * 0.75), material=skin, mirror=True)
        first = len(kit.primitives)
        kit.loft((0.02, wide, up), [(0, r * 0.75), (long * 0.35, r * 0.8), (long * 0.7, r), (long, r), (long + 0.03, r * 0.93)], skin, axis=ALONG_X)
        kit.add(CYL, (long + 0.045, wide, up), (r * 0.85, r * 0.85, 0.012), rotation=ALONG_X, material=glass)
        kit.loft((-0.33, apart, up), [(-0.28, eye * 1.15), (-0.2, eye * 1.2), (-0.16, eye * 0.9), (0, eye)], dark, axis=ALONG_X)
        kit.add(CYL, (-0.62, apart, up), (eye * 0.8, eye * 0.8, 0.012), rotation=ALONG_X, material=glass)
        twin(kit, first)
        kit.between((-0.35, 0, up), (0.3, 0, up), 0.045, material=metal)
        kit.add(CYL, (-0.42, 0, up), (0.08, 0.08, 0.07), rotation=ALONG_X, material=dark)
        kit.add(BOX, (-0.08, 0, up + 0.03), (0.07, wide, 0.04), material=skin)
        kit.add(BOX, (0.22, 0, up), (0.05, wide * 0.9, 0.05), material=skin)
        if kit.chance(0.3):
            tipped(kit, turn("y", -90))
    elif kind == "camera":
        y, z, x = rng.uniform(0.5, 0.65), rng.uniform(0.32, 0.42), rng.uniform(0.14, 0.2)
        old = kit.chance(0.4)
        kit.add(BOX, (0, 0, z), (x, y, z * (0.7 if old else 1)), material=dark)
        if old:
            kit.add(BOX, (0, 0, z * 1.8), (x * 1.02, y * 1.01, z * 0.25), material=metal)
            kit.add(BOX, (0, 0, z * 0.25), (x * 1.02, y * 1.01, z * 0.25), material=metal)
        else:
            kit.add(BOX, (x * 0.9, -y * 0.8, z * 0.95), (0.15, y * 0.22, z * 0.9), (0.8, 0.9), material=dark)
        kit.add(BOX, (0.02, 0, 2 * z + 0.07), (x * 0.9, 0.19, 0.1), (0.65, 0.6), material=metal if old else dark)
        kit.add(BOX, (0.02, 0, 2 * z + 0.175), (0.07, 0.07, 0.015), material=metal)
        r, long = rng.uniform(0.22, 0.32), rng.choice([rng.uniform(0.2, 0.4), rng.uniform(0.6, 1.1)])
        r, barrel = min(r, z * 0.95), dark if kit.chance(0.75) else pale(kit)
        kit.loft(
            (x * 0.9, 0, z * 0.97),
            [(0, r * 0.95), (long * 0.3, r * 0.95), (long * 0.32, r), (long * 0.7, r), (long * 0.72, r * 0.92), (long, r * 1.02)],
            barrel,
            axis=ALONG_X,
        )
        kit.add(
            CYL,
            (x * 0.9 + long * 0.5, 0, z * 0.97),
            (r * 1.03, r * 1.03, long * 0.12),
            rotation=ALONG_X,
            material=barrel._replace(pattern=RIBS, frequency=20.0, second=metal.first),
        )
        kit.add(CYL, (x * 0.9 + long + 0.004, 0, z * 0.97), (r * 0.85, r * 0.85, 0.01), rotation=ALONG_X, material=glass)
        kit.add(CYL, (0, -y * 0.75, 2 * z + 0.03), (0.07, 0.07, 0.05), material=metal)
        kit.add(CYL, (0, y * 0.7, 2 * z + 0.03), (0.11, 0.11, 0.05), material=metal if old else dark)
        kit.add(BOX, (-x, 0, z * 0.9), (0.012, y * 0.55, z * 0.6), material=glass)
        if kit.chance(0.4):
            ribbon(kit, arc((0, 0, z * 1.9), (y + 0.02, rng.uniform(0.5, 0.9)), 0, 180, 11, "yz"), (0.012, 0.05), cloth(kit))
        if kit.chance(0.25):
            kit.primitives = [p._replace(centre=p.centre + [0, 0, 1.6]) for p in kit.primitives]
            for px, py in around(3, 0.75, 60):
                kit.between((px, py, 0), (px * 0.08, py * 0.08, 1.45), 0.04, material=metal)
            kit.between((0, 0, 1.1), (0, 0, 1.62), 0.05, material=dark)
            kit.add(BOX, (0, 0, 1.58), (0.16, 0.12, 0.04), material=dark)
            kit.between((-0.05, 0, 1.52), (-0.7, 0.1, 1.35), 0.025, material=dark)
    else:
        r, long = rng.uniform(0.12, 0.18), rng.uniform(0.8, 1.3)
        head = r * rng.uniform(1.2, 1.9)
        grip = body._replace(pattern=rng.choice([PLAIN, BANDS]), frequency=20.0)
        kit.loft((-long / 2, 0, head), [(0, r * 0.9), (0.05, r), (long * 0.72, r), (long * 0.84, head), (long, head)], grip, axis=ALONG_X)
        kit.add(CYL, (long / 2 + 0.01, 0, head), (head * 0.97, head * 0.97, 0.05), rotation=ALONG_X, material=metal if kit.chance(0.5) else dark)
        kit.add(
            CYL,
            (long / 2 + 0.062, 0, head),
            (head * 0.85, head * 0.85, 0.006),
            rotation=ALONG_X,
            material=kit.material(base=[0.9, 0.88, 0.75], pattern=PLAIN, gloss=-0.7 if kit.chance(0.5) else 0.6),
        )
        kit.add(BOX, (long * 0.12, 0, head + r), (0.07, 0.04, 0.03), material=dark)
        kit.add(CYL, (-long * 0.15, 0, head), (r * 1.04, r * 1.04, long * 0.15), rotation=ALONG_X, material=dark._replace(pattern=BANDS, frequency=25.0))
        if kit.chance(0.4):
            kit.primitives = [p._replace(centre=p.centre - [0, 0, head]) for p in kit.primitives]
            tipped(kit, turn("y", -90))


def lantern(kit):
    rng = kit.rng
    metal = enamel(kit) if kit.chance(0.5) else brass(kit) if kit.chance(0.5) else black(kit)
    lit = (
        kit.material(base=[0.95, 0.75, 0.4], pattern=PLAIN, gloss=-0.8)
        if kit.chance(0.5)
        else kit.material(base=np.array([0.6, 0.68, 0.68]) * rng.uniform(0.5, 1.2), pattern=PLAIN, gloss=0.64)
    )
    if kit.chance(0.5):
        r, glass = rng.uniform(0.35, 0.45), rng.uniform(0.5, 0.8)
        kit.loft((0, 0, 0), [(0, r), (0.05, r * 1.03), (0.22, r), (0.32, r * 0.55), (0.38, r * 0.45)], metal)
        kit.loft((0, 0, 0.38), [(0, r * 0.45), (glass * 0.35, r * 0.72), (glass * 0.6, r * 0.68), (glass, r * 0.38)], lit)
        top = 0.38 + glass
        kit.loft((0, 0, top), [(0, r * 0.55), (0.06, r * 0.5), (0.1, r * 0.3), (0.28, r * 0.28), (0.3, r * 0.5), (0.36, r * 0.1)], metal)
        kit.chain([(0, r * 0.8, 0.15), (0, r * 1.2, 0.32), (0, r * 1.15, top), (0, r * 0.7, top + 0.2), (0, r * 0.25, top + 0.22)], 0.04, metal, mirror=True)
        for x in (-1, 1):
            kit.between((x * r * 0.62, -r * 0.6, 0.4 + glass * 0.4), (x * r * 0.62, r * 0.6, 0.4 + glass * 0.4), 0.012, material=metal)
        high, wide = rng.uniform(0.35, 0.7), r * 1.15
        kit.chain(arc((0, 0, top), (wide, high + 0.1), 0, 180, 9, "yz"), 0.018, metal, joints=False)
    else:
        half, tall = rng.uniform(0.28, 0.4), rng.uniform(0.35, 0.6)
        sides = int(rng.choice([4, 6]))
        spin = 0 if sides == 6 else 45
        corner = half / np.cos(np.pi / sides)
        kit.add(PRISM, (0, 0, 0.06), (half * 1.15, half * 1.15, 0.06), (0.93, sides), material=metal)
        kit.add(PRISM, (0, 0, 0.12 + tall), (half * 0.9, half * 0.9, tall), (1, sides), material=lit)
        for x, y in around(sides, corner * 0.98, spin if sides == 4 else 30):
            kit.between((x, y, 0.1), (x, y, 0.13 + 2 * tall), 0.035, BOX, material=metal)
        kit.add(PRISM, (0, 0, 0.15 + 2 * tall), (half * 1.15, half * 1.15, 0.04), (1, sides), material=metal)
        kit.add(PRISM, (0, 0, 0.32 + 2 * tall), (half * 1.1, half * 1.1, 0.15), (0.3, sides), material=metal)
        kit.add(CYL, (0, 0, 0.52 + 2 * tall), (0.09, 0.09, 0.07), (0.6, 1), material=metal)
        kit.chain(arc((0, 0, 0.68 + 2 * tall), 0.13, 0, 360, 10, "yz"), 0.02, metal, joints=False)
        for z in (0.6, 1.3):
            kit.add(PRISM, (0, 0, 0.12 + tall * z), (half * 0.93, half * 0.93, 0.015), (1, sides), material=metal)


def handiwork(kit):
    """Scissors, pliers, hand drills, padlocks with keys."""
    rng = kit.rng
    metal, grip, dark = steel(kit), enamel(kit), black(kit)
    kind = rng.choice(["scissors", "pliers", "drill", "padlock"])
    if kind == "scissors":
        spread, blade, shank = rng.uniform(6, 25), rng.uniform(0.8, 1.3), rng.uniform(0.3, 0.55)
        loop = (rng.uniform(0.2, 0.28), rng.uniform(0.13, 0.2))
        for side in (-1, 1):
            lean = turn("z", side * spread)
            lift = 0.03 + 0.02 * side
            kit.add(BOX, lean @ [blade / 2, 0, 0] + [0, 0, lift], (0.016, 0.085, blade / 2), (1, 0.12), (0, -side * 0.06), lean @ ALONG_X, metal)
            kit.between([0, 0, lift], lean @ [-shank, 0, 0] + [0, 0, lift], (0.025, 0.06), BOX, material=metal)
            centre = lean @ np.array([-shank - loop[0] * 0.9, side * -0.1, 0]) + [0, 0, 0.05]
            ring = [centre + lean @ p for p in arc((0, 0, 0), loop, 0, 360, 11, "xy")]
            kit.chain(ring, 0.045, grip, joints=False)
        kit.add(CYL, (0, 0, 0.05), (0.06, 0.06, 0.05), material=metal)
        if kit.chance(0.5):
            tipped(kit, turn("y", rng.choice([-90, 90])))
    elif kind == "pliers":
        spread, jaw = rng.uniform(5, 16), rng.uniform(0.25, 0.7)
        kit.add(CYL, (0, 0, 0.08), (0.17, 0.17, 0.07), material=metal)
        kit.add(CYL, (0, 0, 0.1), (0.06, 0.06, 0.075), material=dark)
        lean = turn("z", spread * 0.5)
        kit.add(BOX, lean @ [jaw / 2 + 0.05, 0.05, 0] + [0, 0, 0.08], (0.07, 0.09, jaw / 2), (0.7, 0.35), (0, 0.03), lean @ ALONG_X, metal, True)
        curve = [
            np.array([-0.05, 0.05, 0.08]),
            np.array([-0.3, 0.2 + spread * 0.004, 0.08]),
            np.array([-0.75, 0.24 + spread * 0.012, 0.08]),
            np.array([-1.25, 0.16 + spread * 0.02, 0.08]),
        ]
        kit.chain(curve[:2], 0.07, metal, mirror=True)
        kit.chain(curve[1:], [0.075, 0.08, 0.07], grip, mirror=True)
        if kit.chance(0.5):
            tipped(kit, turn("y", rng.choice([-90, 90])))
    elif kind == "drill":
        wood, r = timber(kit), rng.uniform(0.25, 0.36)
        long = rng.uniform(1.2, 1.6)
        kit.between((0, 0, 0), (0, 0, 0.35), 0.03, material=metal)
        kit.loft((0, 0, 0.33), [(0, 0.05), (0.08, 0.1), (0.25, 0.1), (0.28, 0.06)], metal)
        if kit.chance(0.55):
            kit.between((0, 0, 0.55), (0, 0, long), 0.045, material=metal)
            wheel = np.array([0, 0.09, 0.75 + r])
            kit.add(CYL, wheel, (r, r, 0.03), rotation=ALONG_Y, material=grip, cut=(SPOKES, 4, 0.45))
            kit.add(TUBE, wheel, (r, r, 0.04), rotation=ALONG_Y, material=grip)
            kit.add(TUBE, wheel, (r * 0.85, r * 0.85, 0.03), rotation=ALONG_Y, material=grip)
            kit.between((0, -0.04, wheel[2]), (0, 0.16, wheel[2]), 0.06, material=metal)
            kit.add(CYL, (0, 0, 0.72), (0.09, 0.09, 0.06), (0.7, 1), material=metal)
            turned = turn("y", rng.uniform(0, 360)) @ np.array([r + 0.12, 0, 0])
            kit.between(wheel + [0, 0.06, 0], wheel + turned + [0, 0.06, 0], (0.03, 0.02), BOX, material=metal)
            kit.between(wheel + turned + [0, 0.05, 0], wheel + turned + [0, 0.33, 0], 0.06, taper=1.2, material=wood)
            kit.between((0, 0, long - 0.25), (0, -0.32, long - 0.25), 0.05, material=wood)
            kit.loft((0, 0, long - 0.1), [(0, 0.07), (0.15, 0.11), (0.45, 0.1), (0.55, 0.06)], wood)
        else:
            out = rng.uniform(0.35, 0.5)
            path = [(0, 0, 0.58), (0, 0, 0.72), (out, 0, 0.86), (out, 0, 1.36), (0, 0, 1.5), (0, 0, 1.68)]
            kit.chain(path, 0.045, metal)
            kit.loft((out, 0, 0.9), [(0, 0.06), (0.08, 0.1), (0.34, 0.1), (0.42, 0.06)], wood)
            kit.loft((0, 0, 1.64), [(0, 0.08), (0.06, 0.2), (0.14, 0.24), (0.2, 0.18), (0.22, 0.06)], wood)
    else:
        half, tall, deep = rng.uniform(0.35, 0.45), rng.uniform(0.3, 0.42), rng.uniform(0.13, 0.2)
        body = brass(kit) if kit.chance(0.6) else metal if kit.chance(0.5) else grip
        if kit.chance(0.7):
            kit.add(BOX, (0, 0, tall), (deep, half, tall), material=body)
        else:
            kit.add(CYL, (0, 0, half), (half, half, deep), rotation=ALONG_X, material=body)
            tall = half * 0.9
        open_by = rng.choice([0, 0, rng.uniform(0.1, 0.3)])
        reach, thick = half * 0.65, rng.uniform(0.06, 0.09)
        top = 2 * tall + rng.uniform(0.1, 0.35) + open_by
        kit.between((0, reach, tall), (0, reach, top), thick, material=metal)
        kit.between((0, -reach, 2 * tall + open_by - (0 if open_by else 0.1)), (0, -reach, top), thick, material=metal)
        kit.chain(arc((0, 0, top), reach, 0, 180, 8, "yz"), thick, metal)
        kit.add(CYL, (deep, 0, tall * 0.7), (0.07, 0.07, 0.01), rotation=ALONG_X, material=dark)
        kit.add(BOX, (deep, 0, tall * 0.5), (0.012, 0.03, 0.09), material=dark)
        kit.add(BOX, (deep, 0, tall * 1.5), (0.01, half * 0.6, 0.06), material=body._replace(pattern=WRITING, frequency=20.0))
        for k in range(int(rng.integers(0, 3))):
            spin, key = turn("z", rng.uniform(-40, 40) + 60 * k), brass(kit)
            at = np.array([deep + 0.35, 0.1 - 0.35 * k, 0.03])
            kit.chain([at + spin @ p for p in arc((0, 0, 0), (0.13, 0.16), 0, 360, 9, "xy")], 0.03, key, joints=False)
            kit.between(at + spin @ [0.12, 0, 0], at + spin @ [0.62, 0, 0], (0.02, 0.035), BOX, material=key)
            for x in (0.42, 0.5, 0.58):
                kit.add(BOX, at + spin @ [x, 0.06, 0], (0.025, rng.uniform(0.04, 0.08), 0.02), rotation=spin, material=key)


def umbrella(kit):
    rng = kit.rng
    skin, metal, wood = kit.material(pattern=rng.choice([PLAIN, PLAIN, STRIPES, DOTS, CHECKER])), steel(kit), timber(kit)
    ribs, hook = int(rng.choice([6, 8, 8, 10])), rng.uniform(0.09, 0.14)
    if kit.chance(0.6):
        r, tall, rise = rng.uniform(0.75, 1.05), rng.uniform(1.2, 1.7), rng.uniform(0.25, 0.45)
        kit.between((0, 0, hook), (0, 0, tall + rise + 0.15), 0.025, material=metal)
        shape = [(0, r), (rise * 0.45, r * 0.84), (rise * 0.78, r * 0.55), (rise, 0.03)]
        funnel(kit, (0, 0, tall), shape, skin)
        for x, y in around(ribs, 1):
            out = np.array([x, y, 0])
            for (z0, r0), (z1, r1) in zip(shape[:-1], shape[1:], strict=True):
                kit.between(out * r0 + [0, 0, tall + z0], out * r1 + [0, 0, tall + z1], 0.014, material=skin)
            kit.between(out * 0.03 + [0, 0, tall - 0.05], out * r * 0.5 + [0, 0, tall + rise * 0.8], 0.01, material=metal)
        kit.chain(arc((hook, 0, hook), hook, 180, 350, 6), 0.035, wood)
        if kit.chance(0.5):
            tipped(kit, turn("y", rng.uniform(100, 115)))
    else:
        long, fat = rng.uniform(1.2, 1.7), rng.uniform(0.09, 0.2)
        kit.between((0, 0, 0), (0, 0, long * 0.2), 0.02, material=metal)
        kit.loft((0, 0, 0.12), [(0, 0.03), (long * 0.5, fat), (long * 0.68, fat * 0.85), (long * 0.75, fat * 0.6)], skin, PRISM, sides=ribs)
        kit.add(CYL, (0, 0, 0.12 + long * 0.52), (fat * 1.06, fat * 1.06, 0.03), material=black(kit))
        kit.between((0, 0, long * 0.7), (0, 0, long), 0.025, material=metal)
        kit.between((0, 0, long), (0, 0, long + 0.18), 0.035, material=wood)
        kit.chain(arc((hook, 0, long + 0.18), hook, 180, 0, 7), 0.035, wood)


def books(kit):
    rng = kit.rng
    kind = rng.choice(["stack", "row", "open"])

    def book(centre, half, rotation):
        cover, paper = leather(kit) if kit.chance(0.5) else enamel(kit), pale(kit)
        if kit.chance(0.35):
            cover = cover._replace(pattern=WRITING, frequency=rng.uniform(6, 14), second=pale(kit).first)
        x, y, z = half
        for up in (-1, 1):
            kit.add(BOX, centre + rotation @ [0, 0, up * (z - 0.015)], (x, y, 0.016), rotation=rotation, material=cover)
        kit.add(BOX, centre + rotation @ [x - 0.015, 0, 0], (0.018, y, z), rotation=rotation, material=cover)
        kit.add(
            BOX,
            centre + rotation @ [-0.015, 0, 0],
            (x * 0.96 - 0.01, y * 0.96, z - 0.02),
            rotation=rotation,
            material=paper._replace(pattern=BANDS, frequency=40.0, second=paper.first * 0.75),
        )
        kit.add(
            BOX,
            centre + rotation @ [x, 0, 0],
            (0.006, y * rng.uniform(0.2, 0.6), z * 0.7),
            rotation=rotation,
            material=cover._replace(pattern=WRITING, frequency=16.0, second=brass(kit).first),
        )

    if kind == "stack":
        z = 0.0
        for _ in range(int(rng.integers(2, 9))):
            half = np.array([rng.uniform(0.4, 0.55), rng.uniform(0.55, 0.75), rng.uniform(0.05, 0.15)])
            book(np.array([*rng.normal(0, 0.03, 2), z + half[2]]), half, turn("z", rng.normal(0, 12)))
            z += 2 * half[2]
        if kit.chance(0.3):
            kit.add(BALL, (0.05, 0, z + 0.17), (0.18, 0.18, 0.17), material=enamel(kit))
    elif kind == "row":
        y, count = 0.0, int(rng.integers(4, 10))
        for k in range(count):
            half = np.array([rng.uniform(0.35, 0.45), rng.uniform(0.5, 0.7), rng.uniform(0.05, 0.13)])
            y += half[2]
            leaning = 15.0 if k == count - 1 and kit.chance(0.5) else 0.0
            lean = turn("x", leaning)
            rotation = lean @ turn("x", 90)
            book(np.array([0.45 - half[0], y + (half[1] * 0.27 if leaning else 0), half[1]]), half, rotation)
            y += half[2]
    else:
        half, long, thick = rng.uniform(0.42, 0.55), rng.uniform(0.6, 0.75), rng.uniform(0.05, 0.12)
        cover, paper = leather(kit), pale(kit)
        page = paper._replace(pattern=WRITING, frequency=rng.uniform(12, 24), second=np.array([0.1, 0.1, 0.1]))
        tilt = rng.uniform(2, 10)
        kit.add(BOX, (0, half, 0.015), (long * 1.04, half * 1.04, 0.015), material=cover, mirror=True)
        kit.add(BOX, (0, half * 0.98, 0.03 + thick * 0.8), (long, half * 0.98, thick * 0.8), (1, 0.97), material=paper, mirror=True)
        kit.add(BOX, (0, half * 0.93, 0.03 + thick * 1.6), (long * 0.98, half * 0.92, 0.012), rotation=turn("x", -tilt * 0.4), material=page, mirror=True)
        kit.add(BOX, (0, half * 0.6, 0.05 + thick * 1.6), (long * 0.97, half * 0.5, 0.02), (0.99, 0.3), material=page, mirror=True)
        if kit.chance(0.4):
            kit.add(BOX, (long * 0.9, 0, 0.06 + thick * 1.65), (0.35, 0.03, 0.008), material=enamel(kit))


def canister(kit):
    """Spray cans, jerry cans, fire extinguishers, gas bottles."""
    rng = kit.rng
    coat, metal, dark = enamel(kit), steel(kit), black(kit)
    kind = rng.choice(["spray", "jerry", "extinguisher", "gas"])
    if kind == "spray":
        r, tall = rng.uniform(0.26, 0.34), rng.uniform(1.0, 1.5)
        label = coat._replace(pattern=rng.choice([WRITING, STRIPES, CAMOUFLAGE, BANDS, PLAIN]), frequency=rng.uniform(3, 9))
        kit.add(CYL, (0, 0, 0.025), (r * 1.04, r * 1.04, 0.025), material=metal)
        kit.add(CYL, (0, 0, tall / 2), (r, r, tall / 2), material=label)
        kit.add(CYL, (0, 0, tall), (r * 1.03, r * 1.03, 0.02), material=metal)
        kit.loft((0, 0, tall), [(0, r * 0.98), (0.06, r * 0.9), (0.13, r * 0.6), (0.15, r * 0.5)], metal)
        if kit.chance(0.45):
            kit.loft((0, 0, tall + 0.02), [(0, r * 0.95), (0.32, r * 0.92), (0.36, r * 0.82)], enamel(kit))
        else:
            kit.loft((0, 0, tall + 0.12), [(0, r * 0.45), (0.05, r * 0.45), (0.06, r * 0.25), (0.2, r * 0.25)], pale(kit))
            kit.add(CYL, (r * 0.25, 0, tall + 0.27), (0.025, 0.025, 0.012), rotation=ALONG_X, material=dark)
    elif kind == "jerry":
        x, y, z = rng.uniform(0.48, 0.56), rng.uniform(0.2, 0.26), rng.uniform(0.55, 0.68)
        paint_ = kit.material(
            base=paint(rng.choice([0.0, 0.1, 0.2, 0.25, 0.6]), rng.uniform(0.3, 0.9), rng.uniform(0.08, 0.45)), pattern=rng.choice([PLAIN, STREAKS, CLOUDY]), gloss=0.2
        )
        kit.add(BOX, (0, 0, z), (x, y, z), material=paint_)
        kit.add(BOX, (-0.02, 0, 2 * z + 0.06), (x * 0.9, y, 0.07), (0.75, 1), material=paint_)
        lean = np.degrees(np.arctan2(z, x))
        for way in (-1, 1):
            kit.add(BOX, (0, y, z), (np.hypot(x, z) * 0.8, 0.025, 0.05), rotation=turn("y", way * lean), material=paint_, mirror=True)
        kit.add(BOX, (0, 0, z), (x * 1.01, 0.02, z * 1.01), material=paint_)
        for side in (-0.7, 0, 0.7):
            kit.between((-x * 0.6, side * y, 2 * z + 0.25), (x * 0.3, side * y, 2 * z + 0.25), 0.035, material=paint_)
        for at in (-x * 0.6, x * 0.3):
            kit.add(BOX, (at, 0, 2 * z + 0.16), (0.035, y * 0.85, 0.11), material=paint_)
        kit.between((x * 0.6, 0, 2 * z), (x * 0.85, 0, 2 * z + 0.22), 0.1, material=dark if kit.chance(0.5) else paint_)
        kit.add(BOX, (x * 0.82, 0, 2 * z + 0.24), (0.14, 0.13, 0.035), rotation=turn("y", 25), material=metal)
    elif kind == "extinguisher":
        r, tall = rng.uniform(0.22, 0.3), rng.uniform(0.9, 1.4)
        red = kit.material(base=[rng.uniform(0.45, 0.75), 0.015, 0.015], pattern=PLAIN, gloss=0.5) if kit.chance(0.85) else enamel(kit)
        kit.loft((0, 0, 0), [(0, r * 0.95), (0.08, r * 0.97), (0.1, r), (tall, r), (tall + 0.1, r * 0.82), (tall + 0.17, r * 0.4)], red)
        kit.add(CYL, (0, 0, 0.045), (r * 1.01, r * 1.01, 0.045), material=dark)
        kit.add(
            CYL,
            (0, 0, tall * 0.55),
            (r * 1.005, r * 1.005, tall * rng.uniform(0.12, 0.25)),
            material=pale(kit)._replace(pattern=WRITING, frequency=12.0, second=np.array([0.3, 0.05, 0.05])),
        )
        neck = tall + 0.17
        kit.add(CYL, (0, 0, neck + 0.06), (0.08, 0.08, 0.08), material=metal)
        kit.between((-0.05, 0, neck + 0.12), (0.4, 0, neck + 0.12), (0.02, 0.05), BOX, material=dark)
        kit.between((-0.08, 0, neck + 0.16), (0.4, 0, neck + 0.28), (0.02, 0.05), BOX, material=dark if kit.chance(0.5) else red)
        kit.add(CYL, (0, 0.09, neck + 0.06), (0.055, 0.055, 0.02), rotation=ALONG_Y, material=pale(kit))
        out = r + 0.05
        drop = tall * rng.uniform(0.2, 0.5)
        kit.chain([(-0.05, 0, neck + 0.06), (-out * 0.8, 0, neck + 0.08), (-out - 0.03, 0, neck - 0.15), (-out, 0, drop)], 0.035, dark)
        kit.between((-out, 0, drop + 0.05), (-out, 0, drop - 0.25), 0.04, taper=rng.choice([0.7, 2.2]), material=dark)
        kit.add(CYL, (0, 0, drop + 0.2), (r * 1.02, r * 1.02, 0.02), material=dark)
        kit.add(BOX, (-r, 0, drop + 0.2), (0.08, 0.05, 0.03), material=dark)
    else:
        paint_ = coat._replace(pattern=rng.choice([PLAIN, STREAKS]))
        if kit.chance(0.55):
            r, tall = rng.uniform(0.35, 0.45), rng.uniform(0.5, 1.0)
            kit.add(TUBE, (0, 0, 0.06), (r * 0.75, r * 0.75, 0.06), material=paint_)
            kit.loft(
                (0, 0, 0.07),
                [(0, r * 0.6), (0.06, r * 0.85), (0.16, r), (0.16 + tall, r), (0.27 + tall, r * 0.83), (0.33 + tall, r * 0.5), (0.35 + tall, r * 0.2)],
                paint_,
            )
            kit.add(CYL, (0, 0, 0.23 + tall / 2), (r * 1.015, r * 1.015, 0.025), material=paint_)
            top, wide = 0.3 + tall, r * 0.65
            kit.add(TUBE, (0, 0, top + 0.32), (wide, wide, 0.05), material=paint_)
            kit.add(TUBE, (0, 0, top + 0.32), (wide * 0.93, wide * 0.93, 0.05), material=paint_)
            for px, py in around(3, wide * 0.96, 30):
                kit.add(BOX, (px, py, top + 0.18), (0.03, 0.1, 0.2), rotation=turn("z", np.degrees(np.arctan2(py, px))), material=paint_)
            kit.add(CYL, (0, 0, top + 0.14), (0.06, 0.06, 0.12), material=brass(kit))
            kit.add(CYL, (0, 0, top + 0.26), (0.1, 0.1, 0.03), material=dark)
        else:
            r, tall = rng.uniform(0.2, 0.26), rng.uniform(1.2, 2.0)
            for y in [0] if kit.chance(0.6) else [-r * 1.05, r * 1.05]:
                shoulder = enamel(kit)
                kit.add(CYL, (0, y, tall / 2), (r, r, tall / 2), material=paint_)
                kit.loft((0, y, tall), [(0, r), (0.12, r * 0.85), (0.2, r * 0.55), (0.24, r * 0.35)], shoulder)
                kit.loft(
                    (0, y, tall + 0.22), [(0, 0.09), (0.2, 0.09), (0.26, 0.04)] if kit.chance(0.5) else [(0, 0.05), (0.12, 0.05), (0.13, 0.1), (0.18, 0.1)], brass(kit)
                )
                kit.add(CYL, (r * 0.5, y, tall * 0.7), (r * 0.52, r * 0.7, 0.15), material=pale(kit)._replace(pattern=WRITING, frequency=10.0, second=np.ones(3) * 0.1))
            if len(kit.primitives) > 12:
                kit.add(BOX, (0, 0, tall * 0.6), (r * 1.05, r * 2.1, 0.03), material=dark)


def carried(kit):
    """Bags, suitcases, binoculars, cameras, torches, lanterns, hand tools, padlocks, umbrellas, books, cans, extinguishers, tool and first-aid boxes, radios."""
    kit.rng.choice([luggage, luggage, optics, lantern, handiwork, handiwork, umbrella, books, canister, case, case])(kit)
