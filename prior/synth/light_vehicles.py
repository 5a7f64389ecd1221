"""A maker of light vehicles for one or a few: golf carts, mobility scooters, tuk-tuks, microcars, pedal cars, wheelchairs, rickshaws."""

import numpy as np

from .cycle_parts import RED, WHITE, flat, lacquer
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, GRID, SPOKES
from .materials import CHECKER, PLAIN, PLANKS, RIBS, STRIPES, WRITING
from .quads import buggy, fat_wheels, jet_ski, kart, mower, quad, snowmobile
from .roadcraft import RING, arch, chrome, hide, hood, rims, rubber, seat, section, slab, steering, timber
from .wheeled import glazing


def golf_cart(kit):
    """A golf cart or a shuttle with rows of seats, sometimes the last one backward."""
    rng = kit.rng
    coat, dark, cloth, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), hide(kit), chrome(kit), rubber(kit)
    rows = int(rng.choice([1, 1, 2, 3]))
    radius, wide, front = 0.23, 0.6, 0.55 + 0.4 * rows
    rear, floor = -front + 0.05, 0.34
    for x in (front - 0.15, rear + 0.3):
        fat_wheels(kit, x, wide - 0.06, radius, 0.1, tyre, metal, int(rng.choice([0, 4, 5, 6, 8])))
        kit.between((x, -wide + 0.1, radius), (x, wide - 0.1, radius), 0.04, material=dark)
    section(kit, rear, front - 0.1, (floor - 0.08, floor, wide * 0.9), (floor - 0.08, floor, wide * 0.9), dark)
    section(kit, front - 0.42, front + 0.12, (floor - 0.04, floor + 0.62, wide * 0.88), (floor - 0.06, floor + 0.26, wide * 0.72), coat)
    section(kit, front - 0.42, front + 0.05, (floor + 0.16, floor + 0.34, wide), (floor + 0.14, floor + 0.22, wide * 0.9), coat)
    section(kit, rear - 0.05, rear + 0.75, (floor - 0.05, floor + 0.36, wide * 0.82), (floor - 0.05, floor + 0.32, wide * 0.95), coat)
    arch(kit, rear + 0.3, wide - 0.03, radius, radius + 0.07, 0.09, 15, 165, 3, dark)
    for k in range(rows):
        x = front - 0.95 - 0.75 * k
        back = rows > 1 and k == rows - 1 and kit.chance(0.6)
        kit.add(BOX, (x, 0, floor + 0.18), (0.22, wide * 0.85, 0.18), material=coat)
        kit.add(BOX, (x, 0, floor + 0.42), (0.26, wide * 0.88, 0.06), material=cloth)
        kit.add(BOX, (x + (0.26 if back else -0.26), 0, floor + 0.68), (0.05, wide * 0.86, 0.22), (1, 0.95), (0.05 if back else -0.06, 0), material=cloth)
    steering(kit, front - 0.52, wide * 0.4, floor + 0.72, dark, 0.16)
    roof = floor + rng.uniform(1.38, 1.5)
    kit.between((front - 0.25, wide * 0.84, floor + 0.5), (front - 0.5, wide * 0.8, roof), 0.022, material=metal if kit.chance(0.5) else dark, mirror=True)
    kit.between((rear + 0.12, wide * 0.8, floor + 0.3), (rear + 0.02, wide * 0.8, roof), 0.022, material=dark, mirror=True)
    kit.add(
        BOX,
        ((front - 0.4 + rear) / 2, 0, roof + 0.03),
        ((front - 0.25 - rear) / 2 + 0.06, wide * 1.0, 0.04),
        (0.95, 0.92),
        material=flat(kit, [0.8, 0.79, 0.72]) if kit.chance(0.6) else coat,
    )
    if kit.chance(0.7):
        kit.between((front - 0.3, 0, floor + 0.56), (front - 0.49, 0, roof - 0.02), (0.008, wide * 0.8), BOX, material=glazing(kit))
    kit.add(BOX, (front + 0.07, wide * 0.5, floor + 0.2), (0.05, 0.1, 0.04), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.add(BOX, (rear - 0.04, wide * 0.65, floor + 0.25), (0.03, 0.05, 0.05), material=flat(kit, RED), mirror=True)
    if rows == 1:
        for y in (0.2, -0.2):
            kit.add(CYL, (rear - 0.05, y, floor + 0.62), (0.12, 0.13, 0.4), rotation=turn("y", -7), material=kit.material())
            kit.add(CYL, (rear - 0.1, y, floor + 1.08), (0.08, 0.07, 0.07), (1.2, 1), material=metal)
        kit.add(BOX, (rear - 0.08, 0, floor + 0.2), (0.15, 0.4, 0.03), material=dark)


def mobility(kit):
    """A mobility scooter with tiller, basket and armchair, or a power chair with joystick."""
    rng = kit.rng
    coat, dark, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), kit.material(base=rng.choice([0.03, 0.3]) * np.ones(3), pattern=PLAIN)
    three, radius = kit.chance(0.4), rng.uniform(0.13, 0.18)
    base, track = rng.uniform(0.42, 0.55), rng.uniform(0.24, 0.29)
    cloth, z = hide(kit), rng.uniform(0.56, 0.64)
    chair = kit.chance(0.3)
    x = -0.22 if not chair else 0.0
    rims(kit, -base if not chair else -0.05, track + 0.03, radius, 0.055, tyre, metal, int(rng.choice([0, 3, 5, 6])))
    if chair:
        for end in (0.36, -0.4):
            rims(kit, end, track - 0.02, 0.08, 0.03, tyre, metal)
            kit.between((end, track - 0.02, 0.09), (end * 0.6, track - 0.06, 0.22), 0.025, BOX, material=dark, mirror=True)
        section(kit, -0.34, 0.3, (0.12, 0.36, track - 0.05), (0.14, 0.32, track - 0.06), coat)
        kit.between((0.25, 0.1, 0.42), (0.42, 0.1, 0.14), 0.018, material=dark, mirror=True)
        kit.add(BOX, (0.48, 0, 0.13), (0.12, 0.18, 0.012), material=dark)
    else:
        rims(kit, base, 0.0 if three else track, radius * 0.95, 0.05, tyre, metal, int(rng.choice([0, 3, 5, 6])))
        section(kit, -base - 0.2, -base + 0.34, (0.16, 0.36, track - 0.03), (0.14, 0.4, track - 0.02), coat)
        arch(kit, -base, track + 0.02, radius, radius + 0.04, 0.06, 10, 170, 3, coat)
        section(kit, -base + 0.3, base - radius - 0.02, (0.1, 0.17, track + 0.04), (0.1, 0.17, track), dark)
        section(kit, base - radius - 0.1, base + radius + 0.08, (0.12, 0.42, 0.15 if three else track * 0.75), (2 * radius + 0.02, 2 * radius + 0.14, 0.09), coat)
        if not three:
            arch(kit, base, track, radius, radius + 0.035, 0.06, 10, 165, 3, coat)
        top = np.array([base - 0.24, 0, rng.uniform(0.9, 1.0)])
        kit.between((base - 0.06, 0, 0.34), top, (0.05, 0.06), BOX, 0.8, coat)
        kit.add(BOX, top, (0.08, 0.12, 0.06), (0.7, 0.9), rotation=turn("y", -25), material=dark)
        kit.between(top + [0, 0.08, 0], top + [-0.08, 0.27, 0.04], 0.018, material=dark, mirror=True)
        kit.add(CYL, top + [0.1, 0, -0.14], (0.055, 0.055, 0.04), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        if kit.chance(0.7):
            kit.add(BOX, top + [0.24, 0, -0.2], (0.12, 0.17, 0.11), (1.15, 1.1), material=dark, cut=(GRID, 22, 0.25))
            kit.between(top + [0, 0, -0.14], top + [0.14, 0, -0.2], 0.02, material=dark)
        if kit.chance(0.6):
            kit.between(top + [0, 0.16, 0.02], top + [0.03, 0.28, 0.16], 0.008, material=dark, mirror=True)
            kit.add(BOX, top + [0.03, 0.28, 0.18], (0.01, 0.06, 0.04), material=dark, mirror=True)
    kit.between((x, 0, 0.3), (x, 0, z), 0.06, material=dark)
    kit.add(BOX, (x + 0.02, 0, z), (0.23, 0.22, 0.055), material=cloth)
    kit.add(BOX, (x - 0.22, 0, z + 0.28), (0.055, 0.21, 0.26), (0.8, 0.9), (-0.06, 0), material=cloth)
    if kit.chance(0.6):
        kit.add(BOX, (x - 0.28, 0, z + 0.62), (0.035, 0.12, 0.07), material=cloth)
        kit.between((x - 0.27, 0, z + 0.5), (x - 0.28, 0, z + 0.6), 0.015, material=metal)
    kit.between((x - 0.22, 0.26, z + 0.2), (x + 0.16, 0.26, z + 0.2), (0.022, 0.03), BOX, material=dark, mirror=True)
    kit.between((x - 0.24, 0.2, z + 0.2), (x - 0.22, 0.27, z + 0.2), 0.016, material=metal, mirror=True)
    if chair:
        kit.add(BOX, (x + 0.18, -0.26, z + 0.25), (0.05, 0.035, 0.03), material=dark)
        kit.between((x + 0.19, -0.26, z + 0.26), (x + 0.19, -0.26, z + 0.34), 0.01, material=dark)
    kit.add(BOX, (-base - 0.2 if not chair else -0.34, track * 0.7, 0.28), (0.015, 0.05, 0.025), material=flat(kit, RED), mirror=True)


def stander(kit):
    """What one rides standing: a kick scooter with a motor or a two-wheeled self-balancing one with tread and post."""
    rng = kit.rng
    coat, dark, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit)
    main = dark if kit.chance(0.6) else coat
    if kit.chance(0.6):
        radius, reach, tall = rng.uniform(0.1, 0.15), rng.uniform(0.44, 0.5), rng.uniform(1.0, 1.15)
        for x in (reach, -reach):
            kit.add(CYL, (x, 0, radius), (radius, radius, 0.03), rotation=ALONG_Y, material=tyre)
            kit.add(CYL, (x, 0, radius), (radius * 0.66, radius * 0.66, 0.034), rotation=ALONG_Y, material=metal if kit.chance(0.5) else coat)
        deck = radius + 0.03
        kit.add(BOX, (-0.06, 0, deck), (reach - radius - 0.04, rng.uniform(0.08, 0.11), 0.045), (1, 0.95), material=main)
        kit.add(BOX, (-0.06, 0, deck + 0.05), (reach - radius - 0.06, 0.07, 0.006), material=kit.material(base=[0.02] * 3, pattern=RIBS, frequency=30, second=[0.07] * 3))
        kit.between((-reach + radius - 0.02, 0.045, deck), (-reach, 0.045, radius), (0.022, 0.012), BOX, material=main, mirror=True)
        top = np.array([reach - 0.16, 0, tall])
        kit.between((reach - radius - 0.12, 0, deck), (reach - 0.055, 0, 0.38), (0.045, 0.04), BOX, 0.8, main)
        kit.between((reach, 0.045, radius), (reach - 0.03, 0.045, 2 * radius + 0.05), (0.02, 0.012), BOX, material=main, mirror=True)
        kit.add(BOX, (reach - 0.035, 0, 2 * radius + 0.05), (0.03, 0.06, 0.025), material=main)
        kit.between((reach - 0.035, 0, 2 * radius + 0.02), top, 0.028, material=main)
        kit.between(top + [0, 0, 0], top + [-0.03, 0.25, 0.02], 0.014, material=main, mirror=True)
        kit.between(top + [-0.015, 0.14, 0.01], top + [-0.03, 0.26, 0.02], 0.02, material=dark, mirror=True)
        arch(kit, -reach, 0, radius, radius + 0.025, 0.04, 40, 180, 4, main)
        arch(kit, reach, 0, radius, radius + 0.025, 0.04, 30, 130, 3, main)
        kit.add(CYL, top + [0.05, 0, -0.08], (0.03, 0.03, 0.02), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        kit.add(BOX, (-reach - radius - 0.02, 0, radius + 0.06), (0.012, 0.03, 0.02), material=flat(kit, RED))
        if kit.chance(0.35):
            kit.between((-0.2, 0, deck), (-0.22, 0, 0.6), 0.018, material=metal)
            kit.add(BALL, (-0.22, 0, 0.64), (0.14, 0.1, 0.05), material=dark)
        elif kit.chance(0.3):
            kit.add(BOX, (reach + 0.1, 0, 0.78), (0.1, 0.15, 0.1), (1.1, 1.1), material=dark, cut=(GRID, 24, 0.3))
            kit.between((reach - 0.12, 0, 0.8), (reach + 0.03, 0, 0.76), 0.015, material=dark)
        kit.between((0.1, 0.08, deck), (0.05, 0.16, 0.0), 0.01, material=dark)
    else:
        radius, wide, tall = rng.uniform(0.22, 0.26), rng.uniform(0.27, 0.31), rng.uniform(1.1, 1.25)
        fat_wheels(kit, 0, wide, radius, 0.055, tyre, metal, int(rng.integers(4, 9)))
        kit.add(BOX, (0, 0, radius - 0.03), (0.14, wide - 0.04, 0.07), (0.9, 1), material=main)
        kit.add(BOX, (-0.01, 0, radius + 0.05), (0.17, wide - 0.07, 0.015), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=25, second=[0.08] * 3))
        arch(kit, 0, wide - 0.02, radius, radius + 0.035, 0.075, 25, 155, 4, coat)
        kit.between((0.12, 0, radius), (0.2, 0, radius + 0.3), (0.05, 0.07), BOX, 0.6, main)
        kit.between((0.19, 0, radius + 0.26), (0.16, 0, tall), 0.022, material=metal)
        kit.add(BOX, (0.16, 0, tall), (0.035, 0.07, 0.05), material=dark)
        kit.between((0.16, 0.04, tall), (0.1, 0.26, tall + 0.05), 0.016, material=metal, mirror=True)
        kit.between((0.12, 0.17, tall + 0.035), (0.095, 0.28, tall + 0.055), 0.022, material=dark, mirror=True)
        if kit.chance(0.5):
            kit.add(BOX, (0.27, 0, radius + 0.5), (0.08, 0.16, 0.13), (0.9, 0.9), material=coat)
        if kit.chance(0.5):
            kit.add(BOX, (0.02, wide + 0.03, radius * 2 + 0.16), (0.14, 0.05, 0.1), (0.9, 0.8), material=dark, mirror=True)


def tuk_tuk(kit):
    """Auto and electric rickshaws: three wheels, a canopy on posts, a bench behind the driver."""
    rng = kit.rng
    coat, second, dark, cloth, metal, tyre = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), hide(kit), chrome(kit), rubber(kit)
    boxy = kit.chance(0.45)
    radius, wide, front, rear, roof = 0.22, 0.6, 1.15, -1.25, rng.uniform(1.62, 1.75)
    rims(kit, front - 0.12, 0, radius, 0.055, tyre, metal)
    rims(kit, rear + 0.5, wide - 0.06, radius, 0.06, tyre, metal)
    kit.between((rear + 0.5, -wide + 0.1, radius), (rear + 0.5, wide - 0.1, radius), 0.035, material=dark)
    kit.add(BOX, (-0.1, 0, 0.32), (1.0, wide * 0.9, 0.045), material=dark)
    kit.between((front - 0.12, 0.08, radius), (front - 0.22, 0.08, 0.7), 0.028, material=metal, mirror=True)
    if boxy:
        kit.add(BOX, (0.72, 0, 0.62), (0.06, wide * 0.9, 0.34), material=coat)
        kit.between((0.78, 0, 0.5), (front - 0.2, 0, 0.72), (0.2, 0.14), BOX, 0.7, coat)
        section(kit, rear, -0.1, (0.3, 0.62, wide), (0.3, 0.58, wide), coat)
        kit.add(BOX, (-0.15, 0, roof), (0.98, wide * 1.03, 0.04), (0.97, 0.94), material=second)
        posts = ((0.74, 0.68), (-0.15, -0.15), (rear + 0.05, rear + 0.05))
    else:
        section(kit, 0.48, front, (0.3, 0.92, wide * 0.88), (0.42, 0.74, 0.2), coat)
        section(kit, rear, -0.3, (0.3, 0.86, wide * 0.92), (0.28, 0.8, wide), coat)
        kit.add(CYL, (-0.35, 0, roof - 0.14), (0.2, wide, 0.86), rotation=ALONG_X, material=second)
        kit.add(BOX, (rear + 0.07, 0, (roof + 0.75) / 2), (0.03, wide * 0.9, (roof - 0.85) / 2), material=second)
        kit.add(BOX, (rear + 0.03, 0, roof - 0.38), (0.012, 0.26, 0.1), material=glazing(kit))
        posts = ((0.62, 0.4), (-0.3, -0.3), (rear + 0.05, rear + 0.05))
    with_screen = posts[0]
    for foot, head in posts:
        kit.between((foot, wide * 0.88, 0.55), (head, wide * 0.92, roof - 0.1), 0.024, material=dark if not boxy else metal, mirror=True)
    kit.between((with_screen[0] + 0.02, 0, 0.94), (with_screen[1] + 0.02, 0, roof - 0.06), (0.01, wide * 0.86), BOX, material=glazing(kit))
    kit.add(CYL, (front - 0.02 if not boxy else 0.8, 0, 0.72), (0.085, 0.085, 0.05), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
    arch(kit, front - 0.12, 0, radius, radius + 0.05, 0.08, 10, 160, 4, second)
    kit.add(BOX, (0.18, 0, 0.5), (0.15, 0.24, 0.18), material=coat)
    kit.add(BOX, (0.17, 0, 0.7), (0.17, 0.26, 0.05), material=cloth)
    kit.add(BOX, (-0.7, 0, 0.68), (0.26, wide * 0.82, 0.09), material=cloth)
    kit.add(BOX, (-0.98, 0, 0.95), (0.06, wide * 0.82, 0.24), (1, 1), (-0.06, 0), material=cloth)
    kit.between((0.5, 0, 0.8), (0.42, 0, 1.0), 0.03, material=dark)
    kit.between((0.42, -0.28, 1.0), (0.42, 0.28, 1.0), 0.02, material=dark)
    arch(kit, rear + 0.5, wide - 0.03, radius, radius + 0.05, 0.1, 10, 170, 3, coat if boxy else dark)
    kit.add(BOX, (rear - 0.015, wide * 0.75, 0.52), (0.025, 0.06, 0.09), material=flat(kit, RED), mirror=True)
    kit.add(BOX, (rear - 0.02, 0, 0.45), (0.015, 0.2, 0.06), material=kit.material(base=[0.8, 0.65, 0.1], pattern=WRITING, frequency=25, second=[0.02] * 3))
    kit.between((with_screen[0], wide * 0.9, 1.1), (with_screen[0] + 0.04, wide * 1.12, 1.16), 0.01, material=dark, mirror=True)
    kit.add(BOX, (with_screen[0] + 0.04, wide * 1.14, 1.2), (0.012, 0.05, 0.08), material=dark, mirror=True)


def microcar(kit):
    """A bubble car of the fifties or a small electric one for two of today."""
    rng = kit.rng
    coat, second, dark, metal, tyre, glass = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), glazing(kit)
    bubble = kit.chance(0.5)
    if bubble:
        pastel = flat(kit, rng.choice([[0.5, 0.05, 0.05], [0.3, 0.55, 0.55], [0.75, 0.7, 0.5], [0.2, 0.4, 0.6], [0.6, 0.3, 0.1]]), 0.5)
        radius, wide, long = 0.22, 0.62, rng.uniform(1.05, 1.15)
        rims(kit, 0.62, wide - 0.06, radius, 0.06, tyre, metal)
        rims(kit, -0.72, 0.26, radius, 0.06, tyre, metal)
        kit.add(BALL, (0.0, 0, 0.62), (long, wide, 0.42), material=pastel)
        kit.add(BALL, (0.06, 0, 0.86), (long * 0.78, wide * 0.9, 0.5), material=glass)
        kit.add(BALL, (-0.02, 0, 1.2), (long * 0.5, wide * 0.68, 0.2), material=second if kit.chance(0.5) else pastel)
        kit.add(CYL, (0, 0, 0.74), (long * 0.985, wide * 1.0, 0.018), material=metal)
        kit.add(BOX, (0.05, 0, 0.38), (0.75, wide * 0.8, 0.14), (1.1, 1.15), material=pastel)
        kit.between((0.5, wide * 0.78, 0.72), (0.22, wide * 0.6, 1.24), (0.03, 0.025), BOX, material=pastel, mirror=True)
        kit.between((-0.42, wide * 0.8, 0.74), (-0.26, wide * 0.58, 1.24), (0.06, 0.025), BOX, material=pastel, mirror=True)
        kit.between((long * 0.93, 0, 0.5), (long * 0.93, 0, 0.8), (0.02, 0.02), BOX, material=metal)
        kit.add(BALL, (0.78, wide * 0.72, 0.68), (0.14, 0.09, 0.09), material=pastel, mirror=True)
        kit.add(CYL, (0.9, wide * 0.72, 0.68), (0.072, 0.072, 0.02), rotation=ALONG_X, material=flat(kit, WHITE, 0.6), mirror=True)
        kit.between((0.98, -0.42, 0.42), (0.98, 0.42, 0.42), 0.025, material=metal)
        kit.between((-1.0, -0.3, 0.45), (-1.0, 0.3, 0.45), 0.025, material=metal)
        kit.add(BOX, (-0.98, 0.25, 0.62), (0.05, 0.05, 0.05), material=flat(kit, RED), mirror=True)
        return
    radius, wide, long = 0.27, 0.68, rng.uniform(1.15, 1.3)
    rims(kit, long - 0.4, wide - 0.05, radius, 0.09, tyre, metal, int(rng.integers(4, 9)))
    rims(kit, -long + 0.4, wide - 0.05, radius, 0.09, tyre, metal, int(rng.integers(4, 9)))
    roof, belt, rake = rng.uniform(1.45, 1.55), 0.88, rng.uniform(0.35, 0.55)
    for x in (long - 0.4, -long + 0.4):
        kit.add(CYL, (x, wide - 0.1, radius * 1.16), (radius * 1.14, radius * 1.14, 0.108), rotation=ALONG_Y, material=dark, mirror=True)
    section(kit, -long, long - 0.28, (0.3, belt, wide * 0.94), (0.28, belt, wide), coat)
    section(kit, long - 0.3, long + 0.03, (0.28, belt, wide), (0.34, 0.66, wide * 0.72), coat)
    slab(kit, belt - 0.02, roof, (-long + 0.02, long - 0.22, wide * 0.93), (-long + 0.22, long - 0.22 - rake, wide * 0.78), glass)
    slab(kit, roof - 0.03, roof + 0.05, (-long + 0.18, long - 0.16 - rake, wide * 0.81), (-long + 0.3, long - 0.36 - rake, wide * 0.72), second if kit.chance(0.5) else coat)
    kit.between((long - 0.2, wide * 0.94, belt - 0.02), (long - 0.22 - rake, wide * 0.79, roof), (0.035, 0.025), BOX, material=coat, mirror=True)
    kit.between((-long + 0.2, wide * 0.93, belt - 0.02), (-long + 0.34, wide * 0.79, roof), (0.16, 0.025), BOX, material=coat, mirror=True)
    kit.add(BOX, (0.02, wide * 0.98, 0.6), (0.36, 0.012, 0.22), (1.1, 1), material=second, mirror=True)
    kit.add(BOX, (0.3, wide * 1.0, 0.7), (0.07, 0.02, 0.015), material=dark, mirror=True)
    kit.add(BALL, (long - 0.08, wide * 0.64, 0.66), (0.08, 0.12, 0.09), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.add(BOX, (long + 0.01, 0, 0.44), (0.03, wide * 0.6, 0.07), material=dark)
    kit.add(BOX, (-long - 0.005, wide * 0.72, 0.7), (0.02, 0.07, 0.09), material=flat(kit, RED), mirror=True)
    kit.add(BOX, (-long - 0.01, 0, 0.42), (0.03, wide * 0.8, 0.08), material=dark)
    kit.add(BOX, (-long - 0.04, 0, 0.56), (0.012, 0.22, 0.05), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=25, second=[0.02] * 3))
    kit.add(BOX, (long - 0.36, wide * 1.06, belt + 0.06), (0.04, 0.07, 0.05), material=coat, mirror=True)


def pedal_car(kit):
    """A child's pedal car, or a soapbox racer: plank with a body of boards, rope or wheel to steer, four small wheels."""
    rng = kit.rng
    coat, second, dark, metal, tyre, wood = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), timber(kit)
    radius, base, track = rng.uniform(0.13, 0.16), rng.uniform(0.36, 0.42), rng.uniform(0.22, 0.26)
    if kit.chance(0.5):
        for x in (base, -base):
            fat_wheels(kit, x, track, radius, 0.035, tyre, flat(kit, [0.7] * 3), 0)
            kit.between((x, -track, radius), (x, track, radius), 0.012, material=metal)
            arch(kit, x, track, radius, radius + 0.035, 0.05, 10, 165, 4, second)
        section(kit, -0.06, base + 0.18, (0.16, 0.46, 0.16), (0.16, 0.4, 0.12), coat)
        kit.add(CYL, (base + 0.18, 0, 0.28), (0.12, 0.1, 0.02), rotation=ALONG_X, material=kit.material(base=[0.6] * 3, pattern=RIBS, frequency=40, second=[0.1] * 3))
        kit.add(BOX, (-0.2, 0.165, 0.26), (0.2, 0.014, 0.1), (1, 1), material=coat, mirror=True)
        section(kit, -base - 0.2, -0.32, (0.18, 0.38, 0.1), (0.16, 0.48, 0.17), coat)
        kit.add(BOX, (-0.15, 0, 0.17), (0.4, 0.15, 0.015), material=dark)
        kit.add(BOX, (-0.24, 0, 0.26), (0.1, 0.12, 0.03), material=dark)
        kit.add(BOX, (-0.33, 0, 0.4), (0.02, 0.13, 0.13), (0.8, 0.9), (-0.03, 0), material=dark)
        kit.between((-0.02, 0, 0.46), (-0.06, 0, 0.56), (0.006, 0.13), BOX, 0.9, glazing(kit))
        steering(kit, -0.14, 0, 0.48, dark, 0.085)
        kit.add(BALL, (base + 0.06, 0.2, 0.42), (0.05, 0.045, 0.045), material=metal, mirror=True)
        kit.add(CYL, (base + 0.1, 0.2, 0.42), (0.038, 0.038, 0.012), rotation=ALONG_X, material=flat(kit, WHITE, 0.6), mirror=True)
        kit.between((base + 0.1, 0.05, 0.36), (base + 0.06, 0.19, 0.4), 0.012, material=metal, mirror=True)
        kit.between((base + 0.24, -0.28, 0.16), (base + 0.24, 0.28, 0.16), 0.02, material=metal)
        kit.between((base + 0.12, 0.1, 0.18), (base + 0.24, 0.1, 0.16), 0.014, material=metal, mirror=True)
        kit.add(BOX, (-0.12, 0.172, 0.28), (0.09, 0.01, 0.07), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=9, second=[0.03] * 3), mirror=True)
        if kit.chance(0.5):
            kit.add(CYL, (-base - 0.2, 0, 0.32), (0.1, 0.1, 0.03), rotation=turn("y", 80), material=tyre)
        return
    long = rng.uniform(0.75, 0.95)
    spokes = int(rng.integers(8, 14))
    for x, r in ((long * 0.75, radius * 1.0), (-long * 0.7, radius * rng.uniform(1.0, 1.4))):
        kit.add(CYL, (x, track + 0.08, r), (r, r, 0.025), rotation=ALONG_Y, material=tyre, mirror=True, cut=RING)
        kit.add(CYL, (x, track + 0.08, r), (r * 0.9, r * 0.9, 0.015), rotation=ALONG_Y, material=metal, mirror=True, cut=(SPOKES, spokes, 0.13))
        kit.between((x, -track - 0.1, r), (x, track + 0.1, r), 0.014, material=metal)
        kit.add(BOX, (x, 0, r + 0.035), (0.045, track, 0.025), material=wood)
    kit.add(BOX, (0, 0, radius + 0.075), (long, 0.12, 0.02), material=wood)
    skin = wood if kit.chance(0.4) else kit.material(base=coat.first, pattern=PLANKS, frequency=12)
    low = radius + 0.09
    if kit.chance(0.5):
        section(kit, 0.12, long * 1.1, (low, low + 0.28, 0.2), (low, low + 0.1, 0.06), skin)
        section(kit, -long * 1.05, -0.32, (low, low + 0.22, 0.06), (low, low + 0.36, 0.2), skin)
        kit.add(BOX, (-0.1, 0.2, low + 0.12), (0.26, 0.015, 0.12), material=skin, mirror=True)
        steering(kit, 0.02, 0, low + 0.3, dark, 0.11)
        kit.add(CYL, (0.4, 0.16, low + 0.12), (0.08, 0.08, 0.012), rotation=ALONG_Y, material=flat(kit, [0.85] * 3), mirror=True)
        kit.add(BOX, (-0.12, 0, low + 0.03), (0.2, 0.18, 0.03), material=dark)
    else:
        kit.add(BOX, (-0.38, 0, low + 0.02), (0.18, 0.2, 0.02), material=wood)
        kit.add(BOX, (-0.55, 0, low + 0.2), (0.015, 0.2, 0.2), material=skin)
        kit.add(BOX, (-0.38, 0.2, low + 0.1), (0.18, 0.015, 0.1), (0.9, 1), (-0.02, 0), material=skin, mirror=True)
        kit.chain([(long * 0.75, track - 0.03, radius + 0.06), (0.1, 0.12, low + 0.18), (-0.1, 0.0, low + 0.24)], 0.01, flat(kit, [0.6, 0.5, 0.3], 0), True, False)
        kit.between((-0.25, 0.24, low), (-0.12, 0.24, low + 0.25), 0.018, BOX, material=wood)
        kit.between((-0.25, 0.18, low + 0.0), (-0.25, 0.26, low + 0.0), 0.016, BOX, material=wood)
    kit.add(BOX, (long + 0.0, 0, radius + 0.09), (0.03, 0.14, 0.04), material=second)
    kit.between((-long * 0.95, 0, low), (-long * 0.98, 0, low + 0.6), 0.008, material=metal)
    kit.between((-long * 0.98, 0, low + 0.53), (-long * 1.2, 0, low + 0.52), (0.06, 0.004), BOX, material=second)


def low_trike(kit):
    """A hand bike or recumbent trike: mesh seat lying low, boom, chain, hand cranks or pedals, three spoked wheels."""
    rng = kit.rng
    coat, dark, metal, tyre = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit)
    cut, mesh = (SPOKES, int(rng.integers(14, 22)), 0.08), kit.material(base=[0.03] * 3, pattern=CHECKER, frequency=30, second=[0.08] * 3)
    hand = kit.chance(0.5)
    pair_x, single_x = (-0.35, 0.85) if hand else (0.35, -0.85)
    pair, single, track = (0.3, 0.25, 0.34) if hand else (0.25, rng.choice([0.25, 0.33]), 0.38)
    tilt = turn("x", 6 if hand else 0)
    kit.add(CYL, (pair_x, track, pair), (pair, pair, 0.018), rotation=tilt @ ALONG_Y, material=tyre, mirror=True, cut=RING)
    kit.add(CYL, (pair_x, track, pair), (pair * 0.92, pair * 0.92, 0.012), rotation=tilt @ ALONG_Y, material=metal, mirror=True, cut=cut)
    kit.add(CYL, (single_x, 0, single), (single, single, 0.02), rotation=ALONG_Y, material=tyre, cut=RING)
    kit.add(CYL, (single_x, 0, single), (single * 0.92, single * 0.92, 0.012), rotation=ALONG_Y, material=metal, cut=cut)
    kit.between((pair_x, -track, pair), (pair_x, track, pair), 0.018, material=coat)
    kit.add(BOX, (pair_x, 0, 0.28), (0.05, 0.035, 0.04), material=coat)
    kit.between((-0.45, 0, 0.28), (0.5, 0, 0.28), 0.025, material=coat)
    if hand:
        kit.between((0.5, 0, 0.28), (0.62, 0, 0.66), 0.025, material=coat)
        kit.between((0.6, 0, 0.66), (0.66, 0, 0.5), 0.03, material=coat)
        kit.between((0.66, 0.05, 0.54), (single_x, 0.05, single), 0.016, material=coat, mirror=True)
        kit.between((0.66, 0, 0.55), (0.5, 0, 0.8), 0.022, material=coat)
        crank, pair_of = np.array([0.5, 0, 0.8]), 1
    else:
        kit.between((0.48, 0, 0.28), (0.98, 0, 0.4), 0.025, material=coat)
        kit.between((-0.45, 0.04, 0.28), (single_x, 0.05, single), 0.016, material=coat, mirror=True)
        crank, pair_of = np.array([0.98, 0, 0.4]), -1
        kit.between((0.1, 0.02, 0.28), (0.0, 0.32, 0.26), 0.014, material=dark, mirror=True)
        kit.between((0.0, 0.32, 0.26), (0.0, 0.34, 0.58), 0.016, material=dark, mirror=True)
    kit.add(CYL, crank + [0, 0.04, 0], (0.1, 0.1, 0.006), rotation=ALONG_Y, material=metal)
    kit.between(crank + [0, 0.045, 0.08], (single_x, 0.045, single + 0.04), 0.008, material=dark)
    kit.between(crank + [0, 0.045, -0.08], (single_x, 0.045, single - 0.04), 0.008, material=dark)
    for way in (1, -1):
        end = crank + np.array([0.1, way * 0.08, 0.12]) * ([1, 1, 1] if way > 0 or pair_of > 0 else [-1, 1, -1])
        kit.between(crank + [0, way * 0.05, 0], end, 0.013, material=metal)
        kit.add(BOX, end + [0, way * 0.07, 0], (0.02 if hand else 0.045, 0.06, 0.02), material=dark)
    kit.between((0.08, 0, 0.31), (-0.3, 0, 0.3), (0.025, 0.2), BOX, material=mesh)
    kit.between((-0.28, 0, 0.3), (-0.62, 0, rng.uniform(0.66, 0.85)), (0.025, 0.2), BOX, 0.9, mesh)
    kit.between((-0.42, 0.14, 0.28), (-0.52, 0.14, 0.6), 0.012, material=coat, mirror=True)
    kit.between((-0.42, -0.14, 0.28), (-0.42, 0.14, 0.28), 0.014, material=coat)
    kit.add(BOX, (-0.66, 0, 0.84), (0.04, 0.09, 0.06), material=dark)
    kit.between((-0.56, 0, 0.7), (-0.66, 0, 0.84), 0.014, material=dark)
    if hand:
        kit.between((0.08, 0.1, 0.3), (0.42, 0.2, 0.26), 0.014, material=coat, mirror=True)
        kit.add(BOX, (0.46, 0.2, 0.28), (0.1, 0.05, 0.012), rotation=turn("y", -30), material=dark, mirror=True)
    else:
        arch(kit, single_x, 0, single, single + 0.03, 0.028, 30, 170, 4, dark)
    if kit.chance(0.5):
        kit.between((-0.5, 0.1, 0.3), (-0.62, 0.1, 1.5), 0.005, material=dark)
        kit.between((-0.62, 0.1, 1.46), (-0.78, 0.1, 1.45), (0.07, 0.004), BOX, material=flat(kit, [0.8, 0.25, 0.03]))


def wheelchair(kit):
    """A wheelchair: folding with footrests and push handles, or a sporty one with slanted wheels."""
    rng = kit.rng
    coat, dark, metal, tyre, cloth = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), hide(kit)
    sporty = kit.chance(0.45)
    tube = coat if sporty or kit.chance(0.5) else metal
    wide, z, radius = rng.uniform(0.2, 0.24), rng.uniform(0.46, 0.5), 0.3
    track, camber = wide + (0.16 if sporty else 0.07), rng.uniform(10, 18) if sporty else 0
    axis = turn("x", camber) @ ALONG_Y
    back = rng.uniform(0.22, 0.32) if sporty else rng.uniform(0.42, 0.5)
    kit.add(CYL, (-0.12, track, radius), (radius, radius, 0.016), rotation=axis, material=tyre, mirror=True, cut=RING)
    kit.add(CYL, (-0.12, track, radius), (radius * 0.93, radius * 0.93, 0.01), rotation=axis, material=metal, mirror=True, cut=(SPOKES, int(rng.integers(12, 22)), 0.09))
    kit.add(
        CYL,
        np.array([-0.12, track, radius]) + turn("x", camber) @ [0, 0.035, 0],
        (radius * 0.88, radius * 0.88, 0.008),
        rotation=axis,
        material=metal,
        mirror=True,
        cut=RING,
    )
    kit.between((-0.12, -track, radius), (-0.12, track, radius), 0.02, material=tube)
    kit.between((-0.12, wide * 0.9, radius), (-0.16, wide * 0.9, z), 0.016, material=tube, mirror=True)
    kit.add(BOX, (0.02, 0, z + 0.02), (0.21, wide, 0.03), material=cloth)
    kit.between((-0.2, 0, z), (-0.27, 0, z + back), (0.015, wide * 0.95), BOX, material=cloth)
    kit.between((-0.19, wide, z - 0.02), (-0.27, wide, z + back + 0.04), 0.013, material=tube, mirror=True)
    kit.between((-0.2, wide, z - 0.01), (0.26, wide, z - 0.01), 0.014, material=tube, mirror=True)
    kit.between((0.25, wide, z - 0.01), (0.36, wide * 0.7, 0.12), 0.014, material=tube, mirror=True)
    kit.add(CYL, (0.24, wide * 0.95, 0.07), (0.07, 0.07, 0.018), rotation=ALONG_Y, material=tyre, mirror=True)
    kit.between((0.24, wide * 0.95, 0.07), (0.2, wide * 0.95, 0.18), (0.014, 0.03), BOX, material=tube, mirror=True)
    kit.between((-0.12, wide * 0.95, 0.22), (0.22, wide * 0.95, 0.18), 0.014, material=tube, mirror=True)
    kit.between((0.2, wide * 0.95, 0.18), (0.22, wide, z - 0.01), 0.014, material=tube, mirror=True)
    kit.between((-0.12, wide * 0.95, 0.2), (-0.12, wide * 0.95, radius), 0.014, material=tube, mirror=True)
    if sporty:
        kit.add(BOX, (0.4, 0, 0.12), (0.09, wide * 0.72, 0.012), material=dark)
        kit.add(BOX, (-0.06, wide + 0.015, z + 0.1), (0.18, 0.008, 0.1), (0.6, 1), (-0.06, 0), material=coat, mirror=True)
        if kit.chance(0.5):
            kit.between((0.44, -wide * 0.9, 0.2), (0.44, wide * 0.9, 0.2), 0.016, material=tube)
            kit.between((0.3, wide * 0.85, 0.3), (0.44, wide * 0.88, 0.2), 0.014, material=tube, mirror=True)
        return
    kit.add(BOX, (0.42, wide * 0.55, 0.12), (0.09, 0.07, 0.01), rotation=turn("y", -10), material=dark, mirror=True)
    kit.between((-0.265, wide, z + back + 0.03), (-0.4, wide, z + back + 0.02), 0.018, material=dark, mirror=True)
    kit.between((-0.22, wide + 0.02, z + 0.22), (0.14, wide + 0.02, z + 0.22), (0.016, 0.028), BOX, material=dark, mirror=True)
    kit.between((0.14, wide + 0.02, z + 0.22), (0.16, wide, z), 0.013, material=tube, mirror=True)
    kit.between((0.05, -wide, z - 0.03), (0.05, wide * 0.95, 0.2), 0.013, material=tube)
    kit.between((0.07, wide, z - 0.03), (0.07, -wide * 0.95, 0.2), 0.013, material=tube)
    kit.add(BOX, (-0.03, wide + 0.015, z + 0.11), (0.17, 0.006, 0.09), material=cloth, mirror=True)


def rickshaw(kit):
    """A cycle rickshaw or pedicab: the front of a bicycle, a bench for two between wheels, hood; or a cargo trike with a box before."""
    rng = kit.rng
    coat, second, dark, metal, tyre, cloth = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit), rubber(kit), hide(kit)
    cargo = kit.chance(0.4)
    radius, track = rng.uniform(0.28, 0.34), rng.uniform(0.42, 0.5)
    cut = (SPOKES, int(rng.integers(14, 22)), 0.08)
    pair, single = (0.75, -0.75) if cargo else (-0.55, 1.15)
    kit.add(CYL, (pair, track, radius), (radius, radius, 0.024), rotation=ALONG_Y, material=tyre, mirror=True, cut=RING)
    kit.add(CYL, (pair, track, radius), (radius * 0.92, radius * 0.92, 0.014), rotation=ALONG_Y, material=metal, mirror=True, cut=cut)
    kit.add(CYL, (single, 0, radius), (radius, radius, 0.024), rotation=ALONG_Y, material=tyre, cut=RING)
    kit.add(CYL, (single, 0, radius), (radius * 0.92, radius * 0.92, 0.014), rotation=ALONG_Y, material=metal, cut=cut)
    kit.between((pair, -track, radius), (pair, track, radius), 0.018, material=metal)
    crank = np.array([single + (0.45 if cargo else -0.6), 0, 0.3])
    saddle = crank + [-0.22, 0, 0.58]
    head = np.array([saddle[0] + 0.62, 0, 0.88])
    kit.between(crank, saddle, 0.02, material=coat)
    kit.add(BALL, saddle + [0, 0, 0.03], (0.13, 0.08, 0.045), material=cloth)
    kit.add(CYL, crank, (0.1, 0.1, 0.012), rotation=ALONG_Y, material=metal)
    for side in (1, -1):
        end = crank + np.array([0.12 * side, 0.09 * side, -0.1 * side])
        kit.between(crank + [0, 0.04 * side, 0], end, 0.012, material=metal)
        kit.add(BOX, end + [0, 0.05 * side, 0], (0.04, 0.045, 0.014), material=dark)
    arch(kit, single, 0, radius, radius + 0.035, 0.03, 20, 160, 4, coat)
    if cargo:
        kit.between(crank, (0.3, 0, 0.34), 0.024, material=coat)
        kit.between(crank + [0, 0.04, 0], (single, 0.05, radius), 0.014, material=coat, mirror=True)
        kit.between(saddle - [-0.04, 0, 0.14], (single, 0.05, radius), 0.014, material=coat, mirror=True)
        kit.between(crank + [-0.1, 0, 0.28], (0.32, 0, 0.5), 0.022, material=coat)
        slab(
            kit,
            0.3,
            rng.uniform(0.7, 0.85),
            (0.3, 1.1, track - 0.06),
            (0.22, 1.2, track - 0.03),
            kit.material(base=second.first, pattern=rng.choice([PLAIN, PLANKS, WRITING]), frequency=8),
        )
        kit.between((0.24, 0.3, 0.76), (0.1, 0.3, 0.92), 0.016, material=metal, mirror=True)
        kit.between((0.1, -0.34, 0.92), (0.1, 0.34, 0.92), 0.016, material=dark)
        kit.add(BOX, (pair, 0, 0.3), (0.1, track - 0.1, 0.03), material=dark)
        if kit.chance(0.5):
            for x in (0.26, 1.15):
                kit.between((x, track - 0.06, 0.7), (x, track - 0.08, 1.35), 0.014, material=metal, mirror=True)
            kit.add(BOX, (0.7, 0, 1.37), (0.56, track, 0.03), (0.95, 0.9), material=kit.material(pattern=rng.choice([PLAIN, STRIPES]), frequency=9))
        return
    kit.between(crank, head - [0, 0, 0.12], 0.024, material=coat)
    kit.between(saddle - [-0.04, 0, 0.12], head - [0, 0, 0.02], 0.022, material=coat)
    kit.between(head + [-0.02, 0, 0.12], head + [0.05, 0, -0.2], 0.026, material=coat)
    kit.between(head + [0.04, 0.05, -0.18], (single, 0.05, radius), 0.015, material=metal, mirror=True)
    kit.between(head + [-0.02, 0, 0.11], head + [-0.14, 0.28, 0.13], 0.014, material=metal, mirror=True)
    kit.between(crank, (-0.2, 0.2, 0.4), 0.02, material=coat, mirror=True)
    kit.add(BOX, (-0.35, 0, 0.42), (0.45, track - 0.06, 0.025), material=dark)
    kit.between((pair, 0.3, radius), (pair, 0.3, 0.42), 0.02, material=metal, mirror=True)
    section(kit, -0.8, -0.3, (0.43, 0.68, track - 0.06), (0.43, 0.66, track - 0.06), coat)
    seat(kit, -0.5, 0, 0.62, track - 0.1, 0.5, cloth)
    kit.add(BOX, (-0.5, track - 0.05, 0.78), (0.26, 0.025, 0.1), (0.9, 1), material=coat, mirror=True)
    arch(kit, pair, track, radius, radius + 0.045, 0.05, 20, 160, 3, second)
    if kit.chance(0.75):
        canopy = kit.material(pattern=rng.choice([PLAIN, STRIPES]), frequency=8)
        hood(kit, np.array([-0.68, 0, 0.9]), rng.uniform(0.62, 0.72), track - 0.02, (15, 60, 100, 140), canopy, metal)


def light_vehicle(kit):
    """Quads, side-by-sides, sand rails, snowmobiles, jet skis, karts, golf carts, mobility scooters, kick scooters, tuk-tuks, microcars, mowers, pedal and soapbox cars,
    hand bikes, wheelchairs, rickshaws."""
    makers = [quad, quad, buggy, buggy, snowmobile, jet_ski, kart, golf_cart, mobility, stander, tuk_tuk, microcar, mower, mower, pedal_car, low_trike, wheelchair, rickshaw]
    kit.rng.choice(makers)(kit)
