"""Makers of machines that thin or bent parts make hard: lift trucks, diggers, cars, trains, guns, boats, cycles."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, PRISM, SPOKES, TUBE
from .materials import CAMOUFLAGE, RIBS, STREAKS, WRITING, paint


def machine_paint(kit):
    """The loud paints of working machines."""
    hue = kit.rng.choice([0.12, 0.14, 0.07, 0.02, 0.6, 0.35])
    base = paint(hue, kit.rng.uniform(0.6, 1), kit.rng.uniform(0.3, 0.9)) if kit.chance(0.7) else None
    return kit.material(base=base, pattern=kit.rng.choice([0, 0, 0, STREAKS, 1]), gloss=kit.rng.uniform(0, 0.35))


def wheel(kit, centre, radius, width, tyre, hub, mirror=True):
    """Tyre with a rim, a spoked or a plain disc."""
    x, y, z = centre
    kit.add(CYL, centre, (radius, radius, width), rotation=ALONG_Y, material=tyre, mirror=mirror)
    rim = radius * kit.rng.uniform(0.55, 0.72)
    kit.add(CYL, (x, y + width * 0.55, z), (rim, rim, width * 0.55), rotation=ALONG_Y, material=hub, mirror=mirror)
    if kit.chance(0.5):
        dark = kit.material(dark=True)
        cut = (SPOKES, kit.rng.integers(4, 9), kit.rng.uniform(0.35, 0.6))
        kit.add(CYL, (x, y + width * 0.62, z), (rim * 0.9, rim * 0.9, width * 0.5), rotation=ALONG_Y, material=dark, mirror=mirror, cut=cut)


def spoked_wheel(kit, x, radius, width, tyre, metal, spokes):
    """An open wheel on the ground at `x`, `width` half as wide as its tyre; `spokes`: what is cut out of its disc."""
    kit.add(TUBE, (x, 0, radius), (radius, radius, width), rotation=ALONG_Y, material=tyre)
    kit.add(TUBE, (x, 0, radius), (radius * 0.88, radius * 0.88, width), rotation=ALONG_Y, material=tyre)
    kit.add(CYL, (x, 0, radius), (radius * 0.97, radius * 0.97, width * 0.6), rotation=ALONG_Y, material=metal, cut=spokes)


def forklift(kit):
    """Lift truck: counterweight, cab frame, mast, carriage and forks."""
    rng = kit.rng
    body, dark, steel = machine_paint(kit), kit.material(dark=True), kit.material(gloss=0.3)
    tyre, hub = kit.material(dark=True), kit.material()
    long, wide = rng.uniform(0.7, 1.05), rng.uniform(0.42, 0.6)
    front, rear = rng.uniform(0.28, 0.38), rng.uniform(0.2, 0.3)
    deck = rng.uniform(0.35, 0.5)
    kit.add(BOX, (-long * 0.3, 0, deck), (long * 0.7, wide, deck * 0.62), material=body)
    kit.add(BOX, (-long * 0.75, 0, deck + 0.2), (long * 0.35, wide, deck * 0.6), (rng.uniform(0.6, 1), 0.95), (rng.uniform(0, 0.1), 0), material=body)
    wheel(kit, (long * 0.45, wide * 0.9, front), front, 0.11, tyre, hub)
    wheel(kit, (-long * 0.75, wide * 0.85, rear), rear, 0.09, tyre, hub)
    roof = rng.uniform(1.7, 2.1)
    bar = rng.uniform(0.025, 0.05)
    kit.between((long * 0.35, wide * 0.85, deck * 1.3), (long * rng.uniform(0.05, 0.3), wide * 0.75, roof), bar, BOX, material=dark, mirror=True)
    kit.between((-long * 0.8, wide * 0.85, deck * 1.6), (-long * 0.6, wide * 0.75, roof), bar, BOX, material=dark, mirror=True)
    if kit.chance(0.5):
        kit.add(BOX, (-long * 0.22, 0, roof), (long * 0.5, wide * 0.8, 0.03), material=dark, cut=(BARS, rng.uniform(4, 8), 0.35))
        kit.add(BOX, (-long * 0.22, wide * 0.78, roof), (long * 0.48, bar, bar), material=dark, mirror=True)
    else:
        kit.add(BOX, (-long * 0.22, 0, roof), (long * 0.5, wide * 0.8, 0.04), material=body)
    kit.add(BOX, (-long * 0.35, 0, deck * 1.75), (0.22, 0.22, 0.08), material=dark)
    kit.add(BOX, (-long * 0.6, 0, deck * 1.75 + 0.25), (0.06, 0.2, 0.28), rotation=turn("y", -10), material=dark)
    kit.between((long * 0.2, 0, deck * 1.4), (long * 0.02, 0, deck * 2.3), 0.02, material=dark)
    kit.add(CYL, (long * 0.02, 0, deck * 2.3), (0.15, 0.15, 0.02), rotation=turn("y", -30), material=dark)
    mast = rng.uniform(1.6, 2.4)
    mast_x = long * 0.45 + front + 0.05
    for y in (0.62, 0.45):
        kit.add(BOX, (mast_x, wide * y, mast / 2 + 0.08), (0.05, 0.035, mast / 2), material=steel, mirror=True)
    kit.add(CYL, (mast_x, 0.08, mast * 0.45), (0.03, 0.03, mast * 0.42), material=dark, mirror=kit.chance(0.5))
    for z in (mast, mast * 0.55, 0.2):
        kit.add(BOX, (mast_x, 0, z), (0.04, wide * 0.66, 0.035), material=steel)
    lift = rng.uniform(0.02, 0.5) if kit.chance(0.75) else rng.uniform(0.5, mast * 0.8)
    for z in (0.12, 0.42):
        kit.add(BOX, (mast_x + 0.09, 0, lift + z), (0.025, wide * 0.8, 0.04), material=dark)
    if kit.chance(0.6):
        kit.railing((mast_x + 0.1, -wide * 0.8, lift + 0.12), (mast_x + 0.1, wide * 0.8, lift + 0.12), rng.uniform(0.4, 0.8), dark, rng.uniform(0.1, 0.2))
    fork_y, fork = wide * rng.uniform(0.3, 0.65), rng.uniform(0.45, 0.7)
    kit.add(BOX, (mast_x + 0.13, fork_y, lift + 0.25), (0.025, 0.06, 0.26), material=steel, mirror=True)
    kit.add(BOX, (mast_x + 0.13 + fork, fork_y, lift + 0.03), (fork, 0.06, 0.025), (1, 1), material=steel, mirror=True)
    if kit.chance(0.2):
        half = rng.uniform(0.25, 0.5, 3)
        kit.add(BOX, (mast_x + 0.2 + half[0], 0, lift + 0.06 + half[2]), half)


def digger(kit):
    """Excavators, loaders, backhoes, bulldozers: tracks or wheels, cab, jointed arm, bucket or blade."""
    rng = kit.rng
    body, dark, steel = machine_paint(kit), kit.material(dark=True), kit.material(dark=kit.chance(0.5), gloss=0.2)
    glass = kit.material(base=[0.06, 0.08, 0.1], gloss=0.5, pattern=0)
    long, wide = rng.uniform(0.9, 1.4), rng.uniform(0.5, 0.8)
    tracks = kit.chance(0.6)
    deck = rng.uniform(0.55, 0.8)
    if tracks:
        for x in (-long * 0.75, long * 0.75):
            kit.add(CYL, (x, wide * 0.85, 0.3), (0.3, 0.3, 0.17), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(BOX, (0, wide * 0.85, 0.3), (long * 0.75, 0.17, 0.3), material=dark, mirror=True)
    else:
        radius = rng.uniform(0.32, 0.5)
        for x, k in ((-long * 0.6, 1.0), (long * 0.65, rng.uniform(0.6, 1))):
            wheel(kit, (x, wide * 0.9, radius * k), radius * k, 0.14, dark, kit.material())
    kit.add(BOX, (-long * 0.35, 0, deck + 0.3), (long * 0.55, wide * 0.85, 0.3), (rng.uniform(0.8, 1), 0.95), material=body)
    kit.add(BOX, (0, 0, deck), (long * 0.8, wide * 0.6, 0.12), material=dark)
    cab_y = rng.choice([0, 0.35]) * wide
    kit.add(BOX, (long * 0.2, cab_y, deck + 0.65), (0.38, 0.36, 0.6), (rng.uniform(0.75, 1), 0.9), material=body)
    kit.add(BOX, (long * 0.2, cab_y, deck + 0.8), (0.385, 0.3, 0.34), (0.85, 0.9), material=glass)
    kit.add(BOX, (long * 0.2, cab_y, deck + 0.8), (0.3, 0.365, 0.34), (0.85, 0.9), material=glass)
    kit.add(CYL, (-long * 0.6, -wide * 0.4, deck + 0.85), (0.04, 0.04, 0.3), material=dark)
    if kit.chance(0.65):  # arm
        side = -0.1 if cab_y else 0.0
        base = np.array([long * 0.5, side, deck + 0.3])
        elbow = base + np.array([rng.uniform(0.5, 1.1), 0, rng.uniform(0.7, 1.4)])
        wrist = elbow + np.array([rng.uniform(0.4, 0.9), 0, rng.uniform(-1.2, -0.3)])
        middle = (base + elbow) / 2 + np.array([-0.1, 0, 0.25])
        kit.between(base, middle, (0.14, 0.09), BOX, material=body)
        kit.between(middle, elbow, (0.13, 0.08), BOX, 0.8, material=body)
        kit.between(elbow, wrist, (0.1, 0.07), BOX, 0.7, material=body)
        kit.between(base + [0.1, 0, 0.1], middle + [0.2, 0, -0.1], 0.04, material=steel)
        kit.between(middle + [0, 0, 0.15], elbow + [0.05, 0, 0.15], 0.035, material=steel)
        kit.add(BOX, wrist + [0.05, 0, -0.15], (0.22, 0.24, 0.2), (0.5, 1), (0.1, 0), rotation=turn("y", rng.uniform(-40, 40)), material=steel)
    else:  # blade or shovel
        front = long + rng.uniform(0.2, 0.5)
        lift = rng.uniform(0, 0.5)
        kit.between((long * 0.2, wide * 0.7, deck), (front, wide * 0.6, 0.25 + lift), 0.07, BOX, material=body, mirror=True)
        kit.add(BOX, (front + 0.08, 0, 0.3 + lift), (0.06, wide * 1.15, 0.3), rotation=turn("y", rng.uniform(-15, 15)), material=steel)
        if kit.chance(0.6):
            kit.add(BOX, (front + 0.25, 0, 0.06 + lift), (0.25, wide * 1.15, 0.04), material=steel)
            kit.add(BOX, (front + 0.2, wide * 1.13, 0.22 + lift), (0.2, 0.03, 0.2), (0.3, 1), (-0.15, 0), material=steel, mirror=True)


def tractor(kit):
    """Big wheels behind, small ones in front, a bonnet, a cab or a seat, an exhaust."""
    rng = kit.rng
    body, dark, hub = machine_paint(kit), kit.material(dark=True), machine_paint(kit)
    rear, front = rng.uniform(0.6, 0.8), rng.uniform(0.3, 0.5)
    long, wide = rng.uniform(1.2, 1.5), rng.uniform(0.55, 0.7)
    wheel(kit, (-0.5, wide, rear), rear, 0.2, dark, hub)
    wheel(kit, (long - 0.3, wide * 0.85, front), front, 0.12, dark, hub)
    kit.add(BOX, (long * 0.45, 0, 1.0), (long * 0.55, 0.27, 0.28), (rng.uniform(0.85, 1), 0.85), material=body)
    kit.add(BOX, (long * 0.3, 0, 0.6), (long * 0.7, 0.16, 0.2), material=dark)
    kit.add(BOX, (long, 0, 1.0), (0.02, 0.2, 0.2), material=dark)
    kit.add(CYL, (-0.5, wide * 0.9, rear + 0.12), (rear * 1.1, rear * 1.1, 0.13), (1, 1), rotation=ALONG_Y, material=body, mirror=True, cut=(0, 1, 1))
    kit.add(CYL, (long * 0.6, 0.15, 1.5), (0.04, 0.04, 0.35), material=dark)
    if kit.chance(0.6):
        for x in (-0.85, 0.15):
            kit.add(BOX, (x, 0.45, 1.55), (0.03, 0.03, 0.5), material=dark, mirror=True)
        kit.add(BOX, (-0.35, 0, 2.08), (0.6, 0.55, 0.06), material=body)
        glass = kit.material(base=[0.1, 0.13, 0.15], gloss=0.6, pattern=0)
        kit.add(BOX, (-0.35, 0, 1.6), (0.48, 0.43, 0.42), material=glass)
    else:
        kit.add(BOX, (-0.55, 0, 1.2), (0.2, 0.22, 0.05), material=dark)
        kit.add(BOX, (-0.75, 0, 1.4), (0.04, 0.2, 0.2), material=dark)
        kit.between((0, 0, 1.2), (-0.25, 0, 1.5), 0.02, material=dark)
    if kit.chance(0.3):
        kit.add(BOX, (-2.4, 0, 0.75), (1.1, 0.6, 0.3), (1.1, 1.1), material=kit.material())
        wheel(kit, (-2.5, 0.6, 0.35), 0.35, 0.1, dark, hub)


def round_car(kit):
    """Passenger cars with rounded shoulders, arches, mirrors, plates, grille; from city cars to estates."""
    rng = kit.rng
    half, wide = rng.uniform(1.15, 2.4), rng.uniform(0.72, 0.95)
    radius = rng.uniform(0.28, 0.38)
    coat = kit.material(pattern=rng.choice([0, 0, 0, 0, 14, 13, 2]), gloss=rng.uniform(0.1, 0.6))
    second = coat if kit.chance(0.6) else kit.material(pattern=0, gloss=0.4)
    glass = kit.material(base=np.array([0.05, 0.06, 0.07]) + rng.uniform(0, 0.12), gloss=rng.uniform(0.3, 0.7), pattern=0)
    dark = kit.material(dark=True)
    floor, belt = radius * rng.uniform(0.45, 0.8), rng.uniform(0.85, 1.0)
    roof = rng.uniform(1.3, 1.65)
    middle = (floor + belt) / 2
    kit.add(BOX, (0, 0, middle), (half, wide, (belt - floor) / 2), (rng.uniform(0.9, 0.98), rng.uniform(0.9, 0.97)), material=coat)
    nose = rng.uniform(0.1, 0.25)
    kit.add(BALL, (half - 0.1, 0, middle - 0.03), (nose + 0.1, wide * 0.97, (belt - floor) * 0.52), material=coat)
    kit.add(BALL, (-half + 0.1, 0, middle), (nose, wide * 0.97, (belt - floor) * 0.55), material=coat)
    bonnet, boot = rng.uniform(0.15, 0.9) * half, rng.choice([0.05, 0.1, 0.45]) * half
    front, back = half - bonnet, -half + boot
    cabin, centre = (front - back) / 2, (front + back) / 2
    rake_front, rake_back = rng.uniform(0.3, 0.7) * (roof - belt) * 1.6, rng.uniform(0.05, 0.5) * (roof - belt)
    top = max(0.3, cabin - (rake_front + rake_back) / 2)
    taper, shift = (top / cabin, rng.uniform(0.75, 0.9)), ((rake_back - rake_front) / 2, 0)
    tall = (roof - belt) / 2
    kit.add(BOX, (centre, 0, belt + tall), (cabin, wide * 0.95, tall), taper, shift, material=glass)
    kit.add(BOX, (centre + shift[0] / 2, 0, roof), (top * 1.01, wide * 0.95 * taper[1], 0.035), (0.93, 0.93), material=second)
    # Pillars: thin slices of the cabin a little wider than the glass.
    for place in (0.05, rng.uniform(0.4, 0.6), 0.95):
        x = back + place * 2 * cabin
        lean = rake_back * (1 - place) - rake_front * place
        kit.add(BOX, (x, 0, belt + tall), (0.05, wide * 0.957, tall), (1, taper[1]), (lean, 0), material=second)
    axle = half * rng.uniform(0.6, 0.72)
    tyre, hub = kit.material(dark=True), kit.material(base=rng.uniform(0.3, 0.8) * np.ones(3), gloss=0.5)
    for x in (axle, -axle):
        kit.add(CYL, (x, wide * 0.9, radius + 0.03), (radius * 1.15, radius * 1.15, wide * 0.1), rotation=ALONG_Y, material=dark, mirror=True)
        wheel(kit, (x, wide * 0.88, radius), radius, 0.11, tyre, hub)
    lamp = kit.material(base=[0.85, 0.85, 0.8], pattern=0, gloss=0.6)
    kit.add(BALL, (half - 0.02, wide * 0.68, belt - 0.18), (0.13, 0.18, 0.1), material=lamp, mirror=True)
    tail = kit.material(base=[0.5, 0.03, 0.03], pattern=0, gloss=0.5)
    kit.add(BOX, (-half + 0.02, wide * 0.78, belt - 0.15), (0.08, 0.1, 0.14), material=tail, mirror=True)
    kit.add(BOX, (half + nose * 0.7, 0, middle - 0.05), (0.08, wide * 0.45, 0.08), material=dark)
    plate = kit.material(base=[0.8, 0.8, 0.7], pattern=WRITING, frequency=30, second=[0.02] * 3)
    for x in (half + nose * 0.95, -half - nose * 0.85):
        kit.add(BOX, (x, 0, floor + 0.18), (0.03, 0.26, 0.06), material=plate)
    kit.add(BALL, (front - 0.15, wide * 1.06, belt + 0.08), (0.07, 0.11, 0.08), material=second, mirror=True)
    kit.add(BOX, (0, wide * 0.96, floor + 0.12), (half * 0.55, 0.03, 0.05), material=dark, mirror=True)
    if kit.chance(0.5):
        kit.add(BOX, (centre + 0.1, wide * 0.955, belt - 0.12), (0.09, 0.03, 0.02), material=dark, mirror=True)
    if kit.chance(0.15):
        kit.add(BOX, (centre, 0, roof + 0.12), (0.12, 0.4, 0.07), material=kit.material(base=paint(rng.choice([0, 0.6, 0.13]), 0.9, 0.7), gloss=-0.8))
    elif kit.chance(0.15):
        kit.add(BOX, (centre, wide * 0.6, roof + 0.06), (top * 0.8, 0.02, 0.02), material=dark, mirror=True)


def train(kit):
    """Locomotive, tram or waggon on rails."""
    rng = kit.rng
    coat, dark = kit.material(pattern=rng.choice([0, 2, 13, 14])), kit.material(dark=True)
    long, wide, tall = rng.uniform(2, 4.5), rng.uniform(0.6, 0.8), rng.uniform(0.7, 1)
    steam = kit.chance(0.3)
    if steam:
        kit.add(CYL, (0.4, 0, 1.2), (0.5, 0.5, long * 0.6), rotation=ALONG_X, material=coat)
        kit.add(CYL, (0.4 + long * 0.5, 0, 1.9), (0.13, 0.13, 0.35), (1.4, 1), material=dark)
        kit.add(BALL, (0.4, 0, 1.7), (0.2, 0.2, 0.25), material=kit.material(gloss=0.6))
        kit.add(BOX, (-long * 0.6, 0, 1.4), (0.5, wide, 0.7), material=coat)
        kit.add(BOX, (-long * 0.6, 0, 2.13), (0.65, wide * 1.1, 0.05), material=dark)
    else:
        kit.add(BOX, (0, 0, 0.5 + tall), (long, wide, tall), (rng.uniform(0.9, 1), 0.94), material=coat)
        glass = kit.material(base=[0.05, 0.06, 0.08], gloss=0.5, pattern=0)
        count = int(rng.integers(3, 9))
        for i in range(count):
            x = long * ((2 * i + 1) / count - 1) * 0.95
            kit.add(BOX, (x, 0, 0.6 + tall * 1.35), (long * 0.7 / count, wide * 1.005, tall * 0.28), material=glass)
        kit.add(BOX, (0, 0, 0.6 + tall * 1.4), (long * 1.0, wide * 0.8, tall * 0.3), material=glass)
        kit.add(BOX, (0, 0, 0.6 + tall * 0.7), (long * 1.003, wide * 1.006, tall * 0.1), material=kit.material())
        if kit.chance(0.4):
            kit.between((-0.4, 0, 0.5 + 2 * tall), (0.1, 0, 1.2 + 2 * tall), 0.02, material=dark)
            kit.between((0.1, 0, 1.2 + 2 * tall), (-0.3, 0, 1.7 + 2 * tall), 0.02, material=dark)
            kit.add(BOX, (-0.3, 0, 1.7 + 2 * tall), (0.06, wide * 0.8, 0.02), material=dark)
    kit.add(BOX, (0, 0, 0.42), (long * 0.98, wide * 0.85, 0.12), material=dark)
    for x in np.linspace(-0.8, 0.8, int(rng.integers(3, 6))):
        kit.add(CYL, (x * long, wide * 0.75, 0.25), (0.25, 0.25, 0.06), rotation=ALONG_Y, material=dark, mirror=True)


def gun(kit):
    """Field guns, mortars, machine guns on tripods, launchers and radars on trucks."""
    rng = kit.rng
    coat = kit.material(base=np.array([0.28, 0.3, 0.18]) * rng.uniform(0.4, 1.8), pattern=rng.choice([0, 1, CAMOUFLAGE, 13]))
    dark = kit.material(dark=True)
    kind = rng.random()
    if kind < 0.5:
        radius, long = rng.uniform(0.35, 0.55), rng.uniform(1.2, 2.4)
        wheel(kit, (0, 0.6, radius), radius, 0.08, dark, coat)
        kit.between((0, -0.6, radius), (0, 0.6, radius), 0.06, material=coat)
        raise_by = np.radians(rng.uniform(3, 45))
        aim = np.array([np.cos(raise_by), 0, np.sin(raise_by)])
        pivot = np.array([0.05, 0, radius + 0.35])
        kit.between(pivot - 0.5 * aim, pivot + 0.7 * aim, 0.12, material=coat)
        kit.between(pivot + 0.6 * aim, pivot + long * aim, 0.06, taper=0.8, material=coat)
        kit.add(CYL, pivot + long * aim, (0.09, 0.09, 0.12), rotation=turn("y", 90 - np.degrees(raise_by)), material=coat)
        if kit.chance(0.6):
            kit.add(BOX, (0.15, 0.38, radius + 0.4), (0.02, 0.3, 0.4), rotation=turn("y", -15), material=coat, mirror=True)
        kit.between((-0.1, 0.12, radius), (-1.6, rng.uniform(0.1, 0.8), 0.08), (0.05, 0.06), BOX, material=coat, mirror=True)
    elif kind < 0.75:
        top = rng.uniform(0.5, 0.9)
        for x, y in around(3, rng.uniform(0.4, 0.7)):
            kit.between((0, 0, top), (x, y, 0), 0.03, material=dark)
        tilt = rng.uniform(0, 60)
        aim = np.array([np.cos(np.radians(tilt)), 0, np.sin(np.radians(tilt))])
        pivot = np.array([0, 0, top])
        kit.between(pivot - 0.4 * aim, pivot + 0.3 * aim, (0.06, 0.08), BOX, material=coat)
        kit.between(pivot + 0.3 * aim, pivot + rng.uniform(0.7, 1.2) * aim, 0.03, material=dark)
        kit.add(BOX, (0, 0.14, top - 0.03), (0.12, 0.08, 0.1), material=coat)
    else:
        long, wide = rng.uniform(1.6, 2.4), rng.uniform(0.55, 0.7)
        for x in np.linspace(-0.8, 0.8, 3):
            wheel(kit, (x * long, wide * 0.9, 0.32), 0.32, 0.12, dark, coat)
        kit.add(BOX, (0, 0, 0.65), (long, wide * 0.8, 0.12), material=coat)
        kit.add(BOX, (long * 0.75, 0, 1.15), (long * 0.25, wide, 0.4), (0.85, 0.95), material=coat)
        kit.add(BOX, (long * 0.76, 0, 1.28), (long * 0.247, wide * 1.01, 0.16), (0.9, 1), material=kit.material(base=[0.05] * 3, gloss=0.5))
        if kit.chance(0.6):
            tilt = turn("y", -rng.uniform(0, 50))
            base = np.array([-long * 0.3, 0, 1.25])
            kit.add(BOX, base, (long * 0.55, wide * 0.75, 0.3), rotation=tilt, material=coat)
            kit.add(BOX, base + tilt @ np.array([long * 0.55, 0, 0]), (0.02, wide * 0.7, 0.27), rotation=tilt, material=dark, cut=(GRID, 6, 0.3))
        else:
            kit.add(CYL, (-long * 0.3, 0, 1.2), (0.15, 0.15, 0.5), material=coat)
            kit.add(BOX, (-long * 0.3, 0, 2.0), (0.08, rng.uniform(0.6, 1.2), 0.45), rotation=turn("y", -15), material=coat, cut=(GRID, 9, 0.4) if kit.chance(0.5) else (0, 1, 1))


def boat(kit):
    """Sailing boats, rowing boats, motor boats, trawlers, submarines."""
    rng = kit.rng
    hull, deck, dark = kit.material(gloss=0.3), kit.material(), kit.material(dark=True)
    long, wide, side = rng.uniform(1.2, 2.8), rng.uniform(0.35, 0.7), rng.uniform(0.2, 0.45)
    if kit.chance(0.12):
        kit.loft((0, 0, 0.5), [(-long * 1.2, 0.05), (-long * 0.8, wide * 0.7), (long, wide * 0.7), (long * 1.3, wide * 0.2)], hull, axis=ALONG_X)
        kit.add(BOX, (long * 0.2, 0, 1.1), (0.45, wide * 0.3, 0.35), (0.8, 0.7), material=hull)
        kit.between((long * 0.2, 0, 1.3), (long * 0.2, 0, 2), 0.03, material=dark)
        return
    kit.add(BOX, (-long * 0.25, 0, side), (long * 0.75, wide * 0.8, side), (1.05, 1.25), material=hull)
    bow = turn("y", 90)
    kit.add(BOX, (long * 0.5 + long * 0.25, 0, side * 1.05), (side, wide, long * 0.27), (0.7, 0.02), (-side * 0.2, 0), rotation=bow, material=hull)
    kit.add(BOX, (-long * 0.2, 0, 2 * side), (long * 0.72, wide * 0.9, 0.03), material=deck)
    if kit.chance(0.45):
        mast = rng.uniform(2, 3.6)
        kit.between((0.1, 0, side), (0.1, 0, mast + 2 * side), 0.03, taper=0.6, material=deck)
        kit.between((0.1, 0, 2 * side + 0.4), (-long * 0.8, 0, 2 * side + 0.45), 0.03, material=deck)
        cloth = kit.material(base=rng.uniform(0.5, 0.95) * np.ones(3)) if kit.chance(0.7) else kit.material()
        kit.add(BOX, (-long * 0.4, 0.03, 2 * side + 0.5 + mast * 0.42), (long * 0.4, 0.015, mast * 0.42), (0.02, 1), (long * 0.4, 0), material=cloth)
        if kit.chance(0.7):
            kit.add(BOX, (long * 0.5, 0.02, 2 * side + 0.3 + mast * 0.35), (long * 0.38, 0.012, mast * 0.35), (0.02, 1), (-long * 0.35, 0), material=cloth)
        kit.add(BOX, (-long * 0.2, 0, 2 * side + 0.12), (long * 0.3, wide * 0.5, 0.12), (0.85, 0.8), material=deck)
    else:
        cabin = rng.uniform(0.2, 0.45)
        x = rng.uniform(-0.5, 0.3) * long
        kit.add(BOX, (x, 0, 2 * side + cabin), (long * 0.3, wide * 0.65, cabin), (0.85, 0.9), (-0.08, 0), material=deck)
        glass = kit.material(base=[0.05, 0.07, 0.1], gloss=0.5, pattern=0)
        kit.add(BOX, (x, 0, 2 * side + cabin * 1.35), (long * 0.31, wide * 0.66, cabin * 0.35), (0.9, 0.95), material=glass)
        kit.between((x, 0, 2 * side + 2 * cabin), (x - 0.1, 0, 2 * side + 2 * cabin + rng.uniform(0.4, 1.4)), 0.025, material=dark)
        kit.add(TUBE, (0, 0, 2 * side + 0.15), (long * 0.9, wide * 0.9, 0.13), material=dark, cut=(BARS, 40, 0.15))
        if kit.chance(0.4):
            kit.between((-long * 0.6, 0, 2 * side), (-long * 0.9, 0, 2 * side + 1.2), 0.03, material=dark)


def cycle(kit):
    """Bicycles, motorcycles, scooters, prams, wheelchairs with spoked wheels."""
    rng = kit.rng
    coat, dark, metal = kit.material(gloss=0.4), kit.material(dark=True), kit.material(base=rng.uniform(0.3, 0.7) * np.ones(3), gloss=0.6)
    motor = kit.chance(0.5)
    radius = rng.uniform(0.28, 0.36)
    reach = rng.uniform(0.5, 0.72)
    thick = rng.uniform(0.05, 0.09) if motor else rng.uniform(0.018, 0.03)
    for x in (reach, -reach):
        spoked_wheel(kit, x, radius, thick, dark, metal, (SPOKES, rng.integers(5, 20), rng.uniform(0.1, 0.3)))
    tube = 0.035 if motor else 0.02
    head, seat, crank = np.array([reach * 0.72, 0, 0.85]), np.array([-reach * 0.35, 0, 0.8]), np.array([-0.05, 0, radius * 0.95])
    for start, end in ((head, seat), (head - [0, 0, 0.1], crank), (seat, crank)):
        kit.between(start, end, tube, material=coat)
    kit.between(seat, (-reach, 0, radius), tube * 0.8, material=coat)
    kit.between(crank, (-reach, 0, radius), tube * 0.8, material=coat)
    fork = thick + 0.03
    kit.between(head + [0, fork, -0.02], (reach, fork, radius), tube * 0.8, material=metal, mirror=True)
    kit.between(head, head + [-0.03, 0, 0.2], tube, material=metal)
    grip = rng.uniform(0.22, 0.36)
    kit.between(head + [-0.03, 0, 0.2], head + [-0.12, grip, 0.22], tube * 0.8, material=dark, mirror=True)
    if motor:
        kit.add(BALL, (0.12, 0, 0.78), (0.3, 0.16, 0.14), material=coat)
        kit.add(BOX, (0, 0, 0.42), (0.24, 0.15, 0.2), material=metal)
        kit.add(CYL, (0.02, 0, 0.6), (0.13, 0.13, 0.12), rotation=turn("y", 20), material=dark)
        kit.add(BALL, (-reach * 0.6, 0, 0.76), (0.35, 0.15, 0.08), material=dark)
        kit.between((0, 0.18, 0.3), (-reach * 1.2, 0.2, 0.38), 0.05, material=metal, mirror=kit.chance(0.4))
        kit.add(BALL, head + [0.12, 0, 0.02], (0.1, 0.1, 0.1), material=metal)
        for x in (reach, -reach):
            kit.add(BOX, (x, 0, radius * 2.05), (radius * 0.7, thick * 1.1, 0.03), (0.8, 1), material=coat)
        if kit.chance(0.5):
            kit.add(BOX, (reach * 0.75, 0, 1.0), (0.1, 0.2, 0.22), (0.6, 0.8), (-0.15, 0), material=coat)
    else:
        kit.add(BALL, seat + [0, 0, 0.16], (0.14, 0.07, 0.035), material=dark)
        kit.between(seat, seat + [0, 0, 0.16], tube * 0.8, material=metal)
        kit.add(CYL, crank, (0.1, 0.1, 0.012), rotation=ALONG_Y, material=metal)
        if kit.chance(0.4):
            kit.add(BOX, head + [0.2, 0, 0.15], (0.14, 0.18, 0.12), material=metal, cut=(GRID, 14, 0.25))


def plant_hall(kit):
    """Pipework, tanks, pumps and generators on a frame."""
    rng = kit.rng
    metal = kit.material(gloss=0.3, pattern=rng.choice([0, 13, RIBS]))
    kit.add(BOX, (0, 0, 0.06), (1.5, 0.8, 0.06), material=kit.material())
    for _ in range(int(rng.integers(1, 4))):
        radius, long = rng.uniform(0.25, 0.5), rng.uniform(0.4, 1)
        place = (rng.uniform(-0.9, 0.9), rng.uniform(-0.3, 0.3), 0.2 + radius)
        if kit.chance(0.5):
            kit.add(CYL, place, (radius, radius, long), rotation=ALONG_X, material=metal)
            kit.add(BALL, (place[0] + long, *place[1:]), (radius * 0.4, radius, radius), material=metal)
        else:
            kit.loft((place[0], place[1], 0.1), [(0, radius), (long * 1.8, radius), (long * 1.8 + 0.2, radius * 0.3)], metal)
    for _ in range(int(rng.integers(2, 6))):
        points = [np.array([rng.uniform(-1.3, 1.3), rng.uniform(-0.7, 0.7), 0.12])]
        for axis in rng.permutation(3):
            step = np.zeros(3)
            step[axis] = rng.uniform(0.3, 1.1) * (1 if axis == 2 else -np.sign(points[-1][axis] + 1e-6))
            points.append(points[-1] + step)
        kit.chain(points, rng.uniform(0.03, 0.09), kit.material(gloss=0.3, pattern=0))
    if kit.chance(0.5):
        kit.railing((-1.5, -0.8, 0.1), (1.5, -0.8, 0.1), 0.7, metal, 0.5, GRID)
    kit.add(PRISM, (1.2, 0.5, 0.5), (0.2, 0.2, 0.4), (1, 6))
