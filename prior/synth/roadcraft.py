"""A maker of cars of today, and what it shares with the other makers of road vehicles: paints, rims, arches, seats, glass houses, bonnets."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, SPOKES, TUBE
from .materials import BANDS, CHECKER, PLAIN, PLANKS, RIBS, STREAKS, STRIPES, WRITING, paint
from .wheeled import glazing, plates

FLIP = np.array([1, -1, 1])
RING = (SPOKES, 1, 0.0)


def section(kit, x0, x1, rear, front, material, y=0.0, mirror=False):
    """A body from x0 to x1; its ends are (low, high, half width)."""
    (low0, high0, wide0), (low1, high1, wide1) = rear, front
    half0, half1, drop = (high0 - low0) / 2, (high1 - low1) / 2, (low0 + high0 - low1 - high1) / 2
    taper = (half1 / half0, wide1 / wide0)
    kit.add(BOX, ((x0 + x1) / 2, y, (low0 + high0) / 2), (half0, wide0, (x1 - x0) / 2), taper, (drop, 0), ALONG_X, material, mirror)


def slab(kit, z0, z1, foot, top, material, y=0.0, mirror=False):
    """A body from z0 up to z1; its ends are (rear x, front x, half width)."""
    (back0, front0, wide0), (back1, front1, wide1) = foot, top
    taper, shift = ((front1 - back1) / (front0 - back0), wide1 / wide0), ((back1 + front1 - back0 - front0) / 2, 0)
    kit.add(BOX, ((back0 + front0) / 2, y, (z0 + z1) / 2), ((front0 - back0) / 2, wide0, (z1 - z0) / 2), taper, shift, material=material, mirror=mirror)


def arch(kit, x, y, z, radius, half, first, last, count, material):
    """A mudguard of `count` plates around (x, z), from the angle `first` to `last` in degrees; 0 is forward, 90 up."""
    angles = np.radians(np.linspace(first, last, count + 1))
    points = np.stack([x + radius * np.cos(angles), np.full(count + 1, y), z + radius * np.sin(angles)], 1)
    for start, end in zip(points[:-1], points[1:], strict=True):
        kit.between(start, end, (0.02, half), BOX, material=material, mirror=y != 0)


def rims(kit, x, y, radius, half, tyre, hub, spokes=0):
    """A wheel, or with y its pair: tyre, rim disc, and spokes of the hub's colour on a dark disc."""
    mirror = y != 0
    kit.add(CYL, (x, y, radius), (radius, radius, half), rotation=ALONG_Y, material=tyre, mirror=mirror)
    rim = radius * 0.64
    kit.add(CYL, (x, y, radius), (rim, rim, half * 1.06), rotation=ALONG_Y, material=kit.material(base=[0.02] * 3, pattern=PLAIN) if spokes else hub, mirror=mirror)
    if spokes:
        kit.add(CYL, (x, y, radius), (rim, rim, half * 1.14), rotation=ALONG_Y, material=hub, mirror=mirror, cut=(SPOKES, spokes, 0.4))
    else:
        kit.add(CYL, (x, y, radius), (rim * 0.4, rim * 0.4, half * 1.2), rotation=ALONG_Y, material=hub, mirror=mirror)


def wired(kit, x, y, radius, half, tyre, rim, spokes, share=0.2):
    """An open wheel with spokes to be seen through, or with y its pair."""
    kit.add(CYL, (x, y, radius), (radius, radius, half), rotation=ALONG_Y, material=tyre, mirror=y != 0, cut=RING)
    kit.add(CYL, (x, y, radius), (radius * 0.93, radius * 0.93, half * 0.6), rotation=ALONG_Y, material=rim, mirror=y != 0, cut=(SPOKES, spokes, share))


def car_paint(kit):
    """Lacquer: white, silver, grey, black or a colour."""
    if kit.chance(0.5):
        base = kit.rng.choice([0.75, 0.5, 0.3, 0.12, 0.03]) * kit.rng.uniform(0.85, 1.15) * np.ones(3)
    else:
        base = paint(kit.rng.choice([0, 0.02, 0.08, 0.13, 0.35, 0.5, 0.58, 0.63]), kit.rng.uniform(0.55, 1), kit.rng.uniform(0.08, 0.8))
    return kit.material(base=base, pattern=PLAIN, gloss=kit.rng.uniform(0.2, 0.6))


def chrome(kit):
    return kit.material(base=kit.rng.uniform(0.4, 0.75) * np.ones(3), pattern=PLAIN, gloss=0.6)


def rubber(kit):
    return kit.material(base=kit.rng.uniform(0.015, 0.05) * np.ones(3), pattern=PLAIN, gloss=0.05)


def timber(kit):
    return kit.material(base=np.array([0.32, 0.19, 0.09]) * kit.rng.uniform(0.4, 1.7), pattern=kit.rng.choice([PLAIN, PLANKS, STREAKS]), gloss=0.15)


def hide(kit):
    """Leather or cloth of seats."""
    base = kit.rng.choice([[0.03, 0.03, 0.03], [0.25, 0.1, 0.05], [0.4, 0.3, 0.2], [0.3, 0.03, 0.03], [0.3, 0.3, 0.3]])
    return kit.material(base=np.array(base) * kit.rng.uniform(0.7, 1.3), pattern=kit.rng.choice([PLAIN, PLAIN, STRIPES]), frequency=20)


def lights(kit, front, rear, y, high, size, round_lamps=True, drop=0.0):
    """Head lamps at x = front and tail lamps at x = rear."""
    white = kit.material(base=[0.85, 0.85, 0.78], pattern=PLAIN, gloss=0.6)
    red = kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN, gloss=0.5)
    if round_lamps:
        kit.add(BALL, (front, y, high), (size * 0.6, size, size), material=white, mirror=True)
    else:
        kit.add(BOX, (front, y, high), (size * 0.8, size * 1.4, size * 0.6), (0.8, 0.9), material=white, mirror=True)
    kit.add(BOX, (rear, y * 1.1, high - drop), (0.04, size * 0.7, size), material=red, mirror=True)


def steering(kit, x, y, z, dark, radius=0.18):
    kit.add(TUBE, (x, y, z), (radius, radius, 0.02), rotation=turn("y", -60), material=dark)
    kit.between((x, y, z), (x + 0.3, y, z - 0.16), 0.02, material=dark)


def seat(kit, x, y, z, wide, back, cloth, mirror=False):
    """A cushion on z with a back that leans."""
    kit.add(BOX, (x, y, z + 0.07), (0.24, wide, 0.08), material=cloth, mirror=mirror)
    kit.add(BOX, (x - 0.26, y, z + back / 2 + 0.04), (0.06, wide * 0.95, back / 2), (1, 0.9), (-0.1, 0), material=cloth, mirror=mirror)


def greenhouse(kit, back, front, belt, roof, wide, rake_front, rake_back, coat, pillars, top_coat=None, share=0.8):
    """The upper half of a car: panes all round between pillars under a roof; the rakes are lengths along x."""
    foot, top = wide * 0.94, wide * share
    far, near = back + rake_back, front - rake_front
    glass, tall = glazing(kit), roof - 0.03 - belt + 0.03
    taper, shift = ((near - far) / (front - back), 1), ((far + near - back - front) / 2, top - foot)
    kit.add(BOX, ((back + front) / 2, foot - 0.02, belt - 0.03 + tall / 2), ((front - back) / 2, 0.02, tall / 2), taper, shift, material=glass, mirror=True)
    for end, high in ((front, near), (back, far)):
        kit.between((end + (end - high) * 0.15, 0, belt - 0.03 - tall * 0.15), (high, 0, roof - 0.03), (0.02, foot), BOX, top / foot, glass)
    kit.add(BOX, ((back + front) / 2, wide * 0.945, belt - 0.17), ((front - back) / 2 - 0.03, 0.03, 0.165), material=coat, mirror=True)
    slab(kit, roof - 0.07, roof, (far - 0.05, near + 0.04, top * 1.02), (far + 0.12, near - 0.12, top * 0.9), top_coat or coat)
    kit.between((front, foot, belt - 0.03), (near, top, roof - 0.04), (0.035, 0.025), BOX, material=coat, mirror=True)
    kit.between((back, foot, belt - 0.03), (far, top, roof - 0.04), (0.07, 0.025), BOX, material=coat, mirror=True)
    for k in range(pillars):
        at = (k + 1) / (pillars + 1)
        kit.between((back + (front - back) * at, foot, belt - 0.03), (far + (near - far) * at, top, roof - 0.04), (0.035, 0.02), BOX, material=coat, mirror=True)


def hood(kit, hinge, radius, wide, degrees, cloth, metal):
    """A folding cover around the hinge: plates across between the angles (0 is behind) and a wedge each at the sides."""
    angles = np.radians(degrees)
    points = [hinge + radius * np.array([-np.cos(a), 0, np.sin(a)]) for a in angles]
    for start, end in zip(points[:-1], points[1:], strict=True):
        kit.between(start, end, (0.014, wide * 0.98), BOX, material=cloth)
        middle = (start + end) / 2
        kit.between(hinge + [0, wide * 0.96, 0], middle + [0, wide * 0.96, 0], (np.linalg.norm(end - start) * 0.1, 0.012), BOX, 5.0, material=cloth, mirror=True)
    kit.between(hinge + [0, wide, 0], points[-1] + [0, wide, 0], 0.01, material=metal, mirror=True)


# Cars of today.

# Each kind: length, half width, height, the hood's and the boot's shares of the length, clearance, the front and rear screens' rakes.
MODERN = {
    "sedan": ((4.4, 5.0), (0.88, 0.95), (1.4, 1.5), (0.27, 0.32), (0.15, 0.21), 0.17, (0.55, 0.75), (0.45, 0.7)),
    "hatchback": ((3.8, 4.4), (0.85, 0.91), (1.42, 1.55), (0.22, 0.27), (0.02, 0.05), 0.17, (0.5, 0.75), (0.15, 0.4)),
    "estate": ((4.5, 4.9), (0.88, 0.94), (1.45, 1.55), (0.25, 0.3), (0.01, 0.03), 0.17, (0.5, 0.75), (0.15, 0.4)),
    "coupe": ((4.2, 4.7), (0.9, 0.98), (1.15, 1.35), (0.28, 0.38), (0.06, 0.14), 0.12, (0.6, 0.85), (0.7, 1.2)),
    "suv": ((4.3, 5.1), (0.92, 1.02), (1.65, 1.95), (0.23, 0.28), (0.01, 0.03), 0.27, (0.35, 0.6), (0.1, 0.35)),
    "pickup": ((5.0, 5.8), (0.92, 1.02), (1.75, 1.95), (0.22, 0.25), (0.3, 0.4), 0.3, (0.4, 0.6), (0.05, 0.2)),
    "minivan": ((4.4, 5.1), (0.9, 1.0), (1.65, 1.95), (0.13, 0.19), (0.0, 0.02), 0.18, (0.6, 0.95), (0.08, 0.25)),
    "limousine": ((6.2, 9.0), (0.92, 1.0), (1.45, 1.55), (0.18, 0.21), (0.12, 0.16), 0.17, (0.5, 0.7), (0.4, 0.6)),
    "convertible": ((3.9, 4.6), (0.86, 0.95), (1.2, 1.35), (0.28, 0.36), (0.2, 0.28), 0.13, (0.4, 0.6), (0.3, 0.5)),
    "city": ((2.5, 3.5), (0.76, 0.84), (1.48, 1.6), (0.13, 0.2), (0.0, 0.02), 0.17, (0.4, 0.6), (0.1, 0.25)),
}


def modern_car(kit):
    """Saloons, hatchbacks, estates, coupés, off-roaders, pick-ups, minivans, limousines, convertibles, taxis, police and city cars."""
    rng = kit.rng
    kind = rng.choice(list(MODERN))
    ranges = MODERN[kind]
    long, wide, roof, hood_share, boot_share = (rng.uniform(*span) for span in ranges[:5])
    clear, (rake_front, rake_back) = ranges[5], (rng.uniform(*span) for span in ranges[6:])
    service = rng.choice(["taxi", "police"]) if kind in ("sedan", "estate", "suv", "minivan", "hatchback") and kit.chance(0.3) else ""
    coat, dark, tyre, hub = car_paint(kit), kit.material(base=[0.025] * 3, pattern=PLAIN), rubber(kit), chrome(kit)
    if service == "taxi":
        coat = kit.material(base=rng.choice([[0.8, 0.5, 0.02], [0.02, 0.02, 0.02], [0.75, 0.72, 0.6], [0.1, 0.4, 0.15]]), pattern=PLAIN, gloss=0.4)
    elif service == "police":
        coat = kit.material(base=rng.choice([[0.8, 0.8, 0.8], [0.02, 0.02, 0.02], [0.02, 0.05, 0.25], [0.5, 0.5, 0.52]]), pattern=PLAIN, gloss=0.4)
    radius = roof * rng.uniform(0.205, 0.235) if kind != "coupe" else rng.uniform(0.31, 0.35)
    half, belt = long / 2, roof * rng.uniform(0.6, 0.66)
    dash, back = half - hood_share * long, -half + boot_share * long
    axles = (half - rng.uniform(0.75, 0.9) * (0.75 if kind == "city" else 1), -half + rng.uniform(0.7, 0.95) * (0.7 if kind == "city" else 1))
    tuck, fall = rng.uniform(0.93, 0.97), rng.uniform(0.12, 0.26) * (0.7 if kind in ("suv", "pickup") else 1)
    lower = dark if kind in ("suv", "pickup") and kit.chance(0.5) else coat
    slab(kit, clear, belt, (-half + 0.22, dash + 0.12, wide), (-half + 0.26, dash, wide * tuck), coat)
    section(kit, dash - 0.15, half - 0.16, (clear + 0.05, belt, wide * tuck), (clear + 0.08, belt - fall, wide * 0.86), coat)
    section(kit, axles[0] - 0.3, half - 0.18, (clear, belt - fall * 0.9, wide * 0.99), (clear, belt - fall * 1.2, wide * 0.93), coat)
    section(kit, half - 0.5, half, (clear - 0.02, belt - fall - 0.1, wide * 0.97), (clear + 0.05, belt - fall - 0.22, wide * 0.76), lower if kit.chance(0.5) else coat)
    section(kit, -half, -half + 0.45, (clear + 0.06, belt - 0.12, wide * 0.84), (clear, belt, wide * 0.98), coat)
    section(kit, -half - 0.05, -half + 0.4, (clear + 0.04, clear + 0.34, wide * 0.8), (clear - 0.02, clear + 0.4, wide * 0.99), lower)
    pillars = 1 if kind in ("coupe", "city") else 2 if kind in ("estate", "suv", "minivan") else 3 if kind == "limousine" else 1
    if kind == "convertible":
        cloth = hide(kit)
        kit.add(BOX, ((back + dash) / 2, 0, belt), ((dash - back) / 2 - 0.05, wide * 0.82, 0.02), material=dark)
        seat(kit, (dash + back) / 2 - 0.15, wide * 0.42, belt - 0.18, wide * 0.28, 0.58, cloth, True)
        kit.add(BOX, (back + 0.25, 0, belt + 0.1), (0.1, wide * 0.7, 0.14), (0.7, 0.95), (-0.06, 0), material=cloth)
        kit.add(BOX, (back - 0.02, 0, belt + 0.03), (0.16, wide * 0.78, 0.06), (0.8, 0.95), material=kit.material(base=rng.uniform(0.02, 0.3) * np.ones(3), pattern=PLAIN))
        steering(kit, dash - 0.45, wide * 0.42, belt + 0.1, dark)
        top = belt + 0.4
        slab(kit, belt - 0.03, top, (dash - 0.03, dash, wide * 0.85), (dash - rake_front - 0.02, dash - rake_front, wide * 0.72), glazing(kit))
        kit.between((dash, wide * 0.88, belt - 0.03), (dash - rake_front, wide * 0.74, top), 0.03, BOX, material=dark if kit.chance(0.5) else coat, mirror=True)
        kit.between((dash - rake_front, -wide * 0.74, top), (dash - rake_front, wide * 0.74, top), 0.025, BOX, material=dark)
    else:
        greenhouse(kit, back, dash, belt, roof, wide, rake_front, rake_back, coat, pillars, dark if kit.chance(0.15) else None, rng.uniform(0.74, 0.82))
    if kind == "pickup":
        kit.add(BOX, ((back - half) / 2 - 0.02, 0, belt + 0.005), ((back + half) / 2 - 0.14, wide * 0.8, 0.01), material=dark)
        kit.add(BOX, ((back - half) / 2, wide * 0.9, belt + 0.03), ((back + half) / 2, 0.05, 0.05), material=coat, mirror=True)
        kit.add(BOX, (-half + 0.12, 0, belt + 0.03), (0.05, wide * 0.9, 0.05), material=coat)
        if kit.chance(0.4):
            kit.between((back - 0.1, wide * 0.85, belt), (back + 0.0, wide * 0.72, roof - 0.05), 0.035, material=dark, mirror=True)
        elif kit.chance(0.4):
            kit.add(BOX, ((back - half) / 2, 0, belt + 0.25), ((back + half) / 2 * 0.7, wide * 0.6, 0.22), material=kit.material())
    spokes = int(rng.integers(5, 11)) if kit.chance(0.7) else 0
    for x in axles:
        kit.add(CYL, (x, wide * 0.89, radius + 0.03), (radius * 1.13, radius * 1.13, wide * 0.11 + 0.014), rotation=ALONG_Y, material=dark, mirror=True)
        rims(kit, x, wide * 0.89, radius, wide * 0.11 + 0.02, tyre, hub, spokes)
    white = kit.material(base=[0.8, 0.82, 0.82], pattern=PLAIN, gloss=0.6)
    red = kit.material(base=[0.5, 0.02, 0.02], pattern=PLAIN, gloss=0.6)
    lamp = belt - fall - 0.12
    kit.add(BOX, (half - 0.17, wide * 0.72, lamp), (0.13, wide * rng.uniform(0.13, 0.2), rng.uniform(0.05, 0.08)), (0.9, 0.85), rotation=turn("z", -22), material=white, mirror=True)
    tail_high = rng.uniform(0.06, 0.2 if boot_share < 0.1 else 0.1)
    kit.add(BOX, (-half + 0.06, wide * 0.74, belt - 0.12 - tail_high / 2), (0.08, wide * 0.14, tail_high), material=red, mirror=True)
    kit.add(BOX, (half - 0.03, 0, lamp - 0.06), (0.05, wide * rng.uniform(0.3, 0.5), rng.uniform(0.05, 0.12)), material=kit.material(base=[0.03] * 3, pattern=rng.choice([PLAIN, RIBS, BANDS]), frequency=50, second=hub.first))
    kit.add(BOX, (half - 0.02, 0, clear + 0.08), (0.04, wide * 0.6, 0.06), material=dark)
    plates(kit, half + 0.01, -half - 0.06, clear + 0.24)
    kit.add(BOX, (dash - 0.22, wide * 1.08, belt + 0.08), (0.07, 0.1, 0.07), (0.8, 0.9), material=coat if kit.chance(0.6) else dark, mirror=True)
    kit.add(BOX, (dash - 0.22, wide * 0.96, belt + 0.04), (0.03, 0.06, 0.025), material=dark, mirror=True)
    edges = np.linspace(back + 0.5, dash - 0.1, 2 if pillars == 1 and kind in ("coupe", "city", "convertible") else 3)
    for x in edges:
        kit.add(BOX, (x, wide * 0.985, (clear + belt) / 2 + 0.02), (0.007, 0.012, (belt - clear) * 0.38), material=dark, mirror=True)
    if service:
        width = 0.3 if service == "taxi" else wide * 0.6
        blue = kit.material(base=rng.choice([[0.02, 0.08, 0.6], [0.6, 0.03, 0.03]]), pattern=PLAIN, gloss=0.6)
        sign = kit.material(base=[0.85, 0.7, 0.1], pattern=WRITING, frequency=20, second=[0.03] * 3) if service == "taxi" else blue
        kit.add(BOX, ((back + dash) / 2 - 0.1, 0, roof + 0.07), (0.1, width, 0.08), (0.8, 0.9), material=sign)
        stripe = kit.material(base=[0.85] * 3 if coat.first.mean() < 0.4 else rng.choice([[0.02, 0.08, 0.5], [0.03] * 3, [0.1, 0.4, 0.1]]), pattern=rng.choice([PLAIN, CHECKER]), frequency=10)
        kit.add(BOX, ((back + dash) / 2, wide * 0.975, (clear + belt) / 2 + 0.08), ((dash - back) * 0.45, 0.02, rng.uniform(0.06, 0.17)), material=stripe, mirror=True)
    elif kind in ("suv", "estate") and kit.chance(0.6):
        kit.between((back + rake_back + 0.1, wide * 0.66, roof + 0.04), (dash - rake_front - 0.15, wide * 0.66, roof + 0.04), 0.02, BOX, material=hub, mirror=True)
        for x in (back + rake_back + 0.1, dash - rake_front - 0.15):
            kit.add(BOX, (x, wide * 0.66, roof + 0.0), (0.05, 0.02, 0.04), material=hub, mirror=True)
    elif kind == "coupe" and kit.chance(0.4):
        kit.add(BOX, (-half + 0.25, 0, belt + 0.17), (0.14, wide * 0.85, 0.016), rotation=turn("y", 6), material=coat)
        kit.between((-half + 0.28, wide * 0.6, belt - 0.02), (-half + 0.25, wide * 0.6, belt + 0.17), (0.06, 0.015), BOX, material=dark, mirror=True)
