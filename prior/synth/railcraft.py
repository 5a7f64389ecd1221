"""Makers of what runs on rails or hangs from a rope."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, RUNGS, SPOKES, TUBE
from .materials import CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, STREAKS, STRIPES, WRITING, paint
from .roadcraft import car_paint, chrome, hide, section, slab, timber
from .wheeled import glazing


def railcraft(kit):
    """Steam, diesel and electric locomotives, trams, coaches, goods wagons, underground and fast trains, handcars, cable cars, roller-coaster cars; many on a stretch of track."""
    makers = [steam, steam, steam, diesel, diesel, electric, tram, tram, coach, coach, goods, goods, goods, underground, fast, handcar, cable_car, roller_coaster]
    kit.rng.choice(makers)(kit)


def livery(kit):
    """Paint of railways: greens, reds, blues, blacks, or any."""
    if kit.chance(0.35):
        return car_paint(kit)
    base = paint(kit.rng.choice([0.0, 0.02, 0.07, 0.13, 0.36, 0.4, 0.6, 0.63]), kit.rng.uniform(0.5, 1), kit.rng.uniform(0.05, 0.6))
    return kit.material(base=base, pattern=kit.rng.choice([PLAIN, PLAIN, STREAKS]), gloss=kit.rng.uniform(0.05, 0.4))


def track(kit, back, front):
    """Rails on sleepers, some in ballast, under most of what runs on rails."""
    if kit.chance(0.45):
        return
    rng = kit.rng
    steel, wood = kit.material(base=[0.2, 0.16, 0.13], pattern=STREAKS), timber(kit) if kit.chance(0.6) else kit.material(base=[0.4, 0.39, 0.37], pattern=CLOUDY)
    low = -0.26
    kit.add(BOX, ((back + front) / 2, 0.72, -0.06), ((front - back) / 2, 0.035, 0.07), material=steel, mirror=True)
    spacing = rng.uniform(0.6, 0.9)
    if kit.chance(0.5):
        stones = kit.material(base=np.array([0.32, 0.3, 0.28]) * rng.uniform(0.6, 1.3), pattern=17, frequency=30)
        slab(kit, low - 0.2, low + 0.08, (back - 0.1, front + 0.1, 1.6), (back, front, 1.25), stones)
    kit.add(BOX, ((back + front) / 2, 0, -0.19), ((front - back) / 2, 1.15, 0.06), material=wood, cut=(BARS, 1 / spacing, 0.4))


def bogie(kit, x, reach, radius, dark, steel):
    """Two axles in a frame, with springs."""
    for dx in (-reach, reach):
        kit.add(CYL, (x + dx, 0.74, radius), (radius, radius, 0.06), rotation=ALONG_Y, material=steel, mirror=True)
    kit.add(BOX, (x, 0.84, radius + 0.06), (reach + radius * 0.7, 0.06, 0.12), (0.8, 1), material=dark, mirror=True)
    kit.add(BOX, (x, 0, radius + 0.1), (reach * 0.7, 0.8, 0.1), material=dark)


def buffers(kit, x, way, z, dark):
    """Two buffers and a hook at an end that looks `way`."""
    kit.between((x, 0.6, z), (x + way * 0.25, 0.6, z), 0.07, material=dark, mirror=True)
    kit.add(CYL, (x + way * 0.27, 0.6, z), (0.17, 0.17, 0.03), rotation=ALONG_X, material=dark, mirror=True)
    kit.between((x, 0, z - 0.05), (x + way * 0.22, 0, z - 0.05), 0.05, BOX, material=dark)


def front_lights(kit, x, y, z, size=0.1):
    white = kit.material(base=[0.88, 0.86, 0.75], pattern=PLAIN, gloss=0.6)
    kit.add(CYL, (x, y, z), (size, size, 0.04), rotation=ALONG_X, material=white, mirror=True)


def steam(kit):
    rng = kit.rng
    coat, dark = livery(kit), kit.material(base=rng.uniform(0.015, 0.06) * np.ones(3), pattern=PLAIN, gloss=0.2)
    brass = kit.material(base=[0.6, 0.42, 0.12], pattern=PLAIN, gloss=0.6) if kit.chance(0.5) else dark
    rods, rim = chrome(kit), coat if kit.chance(0.4) else kit.material(base=[0.45, 0.03, 0.03], pattern=PLAIN) if kit.chance(0.5) else dark
    count, drive = int(rng.integers(2, 5)), rng.uniform(0.55, 0.9)
    spacing = drive * 2.15
    half = max(count * spacing / 2 + rng.uniform(0.9, 1.4), 2.4)
    boiler, axis = rng.uniform(0.62, 0.78), drive * 1.0 + rng.uniform(1.05, 1.3)
    track(kit, -half - 3.4 if kit.chance(0.5) else -half - 0.5, half + 0.6)
    cab, nose = -half + 0.15, half - 0.2
    wall = cab + rng.uniform(1.0, 1.3)
    profile = [(0, boiler * 1.08), (0.5, boiler * 1.05), (1.1, boiler), (nose - wall - 0.8, boiler * rng.uniform(0.88, 1))]
    kit.loft((wall - 0.05, 0, axis), profile, coat, axis=ALONG_X)
    kit.add(CYL, (nose - 0.42, 0, axis), (boiler * 1.0, boiler * 1.0, 0.46), rotation=ALONG_X, material=dark)
    kit.add(BALL, (nose + 0.02, 0, axis), (0.1, boiler * 0.85, boiler * 0.85), material=dark)
    kit.add(CYL, (nose + 0.1, 0, axis), (0.07, 0.07, 0.06), rotation=ALONG_X, material=rods)
    for x in np.linspace(wall + 0.8, nose - 1.0, 2):
        kit.add(CYL, (x, 0, axis), (boiler * 1.03, boiler * 1.03, 0.03), rotation=ALONG_X, material=brass)
    funnel = rng.choice(["plain", "cap", "balloon"])
    tall, top = rng.uniform(0.35, 0.85), axis + boiler
    shapes = {"plain": [(-0.15, 0.26), (0, 0.2), (tall, 0.2), (tall + 0.06, 0.24)], "cap": [(-0.15, 0.28), (0, 0.18), (tall, 0.23), (tall + 0.05, 0.3), (tall + 0.12, 0.3)]}
    shapes["balloon"] = [(-0.15, 0.24), (0, 0.16), (tall * 0.5, 0.2), (tall + 0.15, 0.48), (tall + 0.4, 0.3)]
    kit.loft((nose - 0.45, 0, top), shapes[funnel], dark)
    for x in np.linspace(wall + 0.75, nose - 1.4, int(rng.integers(1, 4))):
        dome = rng.uniform(0.2, 0.28)
        kit.add(CYL, (x, 0, top + 0.08), (dome, dome, 0.16), material=coat if brass is dark else brass)
        kit.add(BALL, (x, 0, top + 0.22), (dome, dome, dome * 0.8), material=coat if brass is dark else brass)
    plate = drive + 0.62
    kit.add(BOX, (0, 0, plate), (half, 1.1, 0.04), material=dark)
    kit.add(BOX, (0, 0, drive + 0.25), (half * 0.95, 0.5, 0.3), material=dark)
    kit.add(BOX, (nose - 0.42, 0, axis - boiler - 0.12), (0.42, boiler * 0.75, 0.3), material=dark)
    roof = axis + boiler + rng.uniform(0.35, 0.6)
    kit.add(BOX, ((cab + wall) / 2 + 0.1, 1.0, plate + 0.55), ((wall - cab) / 2 - 0.1, 0.05, 0.55), material=coat, mirror=True)
    for x in (wall - 0.08, cab + 0.25):
        kit.add(BOX, (x, 1.0, (plate + roof) / 2), (0.1, 0.05, (roof - plate) / 2), material=coat, mirror=True)
    kit.add(BOX, (wall - 0.03, 0, (plate + roof) / 2), (0.05, 1.02, (roof - plate) / 2), material=coat)
    kit.add(BOX, (wall + 0.03, 0.75, roof - 0.35), (0.012, 0.17, 0.2), material=glazing(kit), mirror=True)
    kit.add(CYL, ((cab + wall) / 2, 0, roof - 0.02), (0.17, 1.15, (wall - cab) / 2 + 0.25), rotation=ALONG_X, material=dark)
    first = -count * spacing / 2 + spacing * 0.5 + 0.15
    axles = [first + spacing * k for k in range(count)]
    for x in axles:
        kit.add(CYL, (x, 0.74, drive), (drive, drive, 0.06), rotation=ALONG_Y, material=rim, mirror=True, cut=(SPOKES, 12, 0.3))
    crank = drive * 0.4
    kit.add(BOX, ((axles[0] + axles[-1]) / 2, 0.86, drive - crank), ((axles[-1] - axles[0]) / 2 + 0.12, 0.025, 0.06), material=rods, mirror=True)
    cylinder = np.array([min(axles[-1] + drive + 0.35, half - 0.5), 0.95, drive + 0.05])
    kit.add(CYL, cylinder, (0.26, 0.26, 0.36), rotation=ALONG_X, material=coat, mirror=True)
    kit.add(BOX, cylinder + [0, -0.15, 0.35], (0.32, 0.2, 0.3), material=dark, mirror=True)
    kit.between(cylinder - [0.3, 0, 0], (axles[-2] if count > 1 else axles[-1], 0.92, drive - crank), 0.05, BOX, material=rods, mirror=True)
    kit.add(CYL, (half - 0.25, 0.72, 0.33), (0.33, 0.33, 0.06), rotation=ALONG_Y, material=rim, mirror=True)
    kit.add(BOX, (half, 0, plate - 0.15), (0.05, 1.1, 0.16), material=kit.material(base=[0.45, 0.03, 0.03], pattern=PLAIN) if kit.chance(0.6) else dark)
    if kit.chance(0.4):
        section(kit, half, half + 0.6, (0.12, plate - 0.2, 0.95), (0.1, 0.2, 0.15), kit.material(base=dark.first, pattern=STRIPES, frequency=25, second=[0.3] * 3))
        kit.add(BOX, (nose - 0.2, 0, top + 0.15), (0.16, 0.16, 0.18), material=brass)
        kit.add(CYL, (nose - 0.02, 0, top + 0.15), (0.13, 0.13, 0.04), rotation=ALONG_X, material=kit.material(base=[0.88, 0.86, 0.75], pattern=PLAIN))
    else:
        buffers(kit, half, 1, plate - 0.12, dark)
    if kit.chance(0.3):
        tank = (wall + nose - 1.0) / 2
        kit.add(BOX, (tank, 0.85, axis - 0.15), ((nose - 1.0 - wall) / 2, 0.24, 0.5), material=coat, mirror=True)
        kit.add(BOX, (cab - 0.25, 0, plate + 0.55), (0.35, 1.0, 0.55), material=coat)
    else:
        tender(kit, cab - 0.25, plate, coat, dark, rim)


def tender(kit, front, plate, coat, dark, rim):
    """The coal and water wagon behind the cab."""
    rng = kit.rng
    long, high = rng.uniform(1.2, 1.6), rng.uniform(0.5, 0.65)
    x = front - long
    kit.add(BOX, (x + 0.3, 0, plate - 0.1), (long + 0.3, 0.9, 0.12), material=dark)
    kit.add(BOX, (x, 0, plate + high), (long, 1.02, high), material=coat)
    kit.add(BALL, (x + 0.15, 0, plate + 2 * high), (long * 0.75, 0.85, 0.28), material=kit.material(base=[0.02] * 3, pattern=17, frequency=40, second=[0.08] * 3))
    for dx in (-0.62, 0.62):
        kit.add(CYL, (x + dx * long, 0.74, 0.45), (0.45, 0.45, 0.06), rotation=ALONG_Y, material=rim, mirror=True)
    kit.add(BOX, (x, 0.84, 0.55), (long * 0.9, 0.05, 0.14), material=dark, mirror=True)


def panes(kit, places, half_x, wide, low, high, top_wide):
    """Windows that go right through at every x of `places`."""
    glass = glazing(kit)
    for x in places:
        slab(kit, low, high, (x - half_x, x + half_x, wide), (x - half_x, x + half_x, top_wide), glass)


def diesel(kit):
    rng = kit.rng
    coat, second, dark, steel = livery(kit), livery(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN)
    half, floor = rng.uniform(3.2, 4.6), 1.0
    track(kit, -half - 0.4, half + 0.4)
    for x in (-half * 0.6, half * 0.6):
        bogie(kit, x, 0.68, 0.45, dark, steel)
    kit.add(BOX, (0, 0, floor), (half, 1.12, 0.14), material=dark)
    kit.add(BOX, (0, 0, 0.6), (half * 0.3, 0.85, 0.32), (1, 0.9), material=dark)
    roof = rng.uniform(2.9, 3.2)
    grilles = kit.material(base=coat.first * 0.5, pattern=RIBS, frequency=30, second=[0.03] * 3)
    if kit.chance(0.55):  # a cab among hoods with walkways
        cab = rng.choice([half * 0.55, half * 0.1])
        hood_top = rng.uniform(2.3, 2.7)
        kit.add(BOX, ((cab - half * 0.92) / 2, 0, (floor + hood_top) / 2), ((cab + half * 0.92) / 2, 0.68, (hood_top - floor) / 2), material=coat)
        kit.add(BOX, ((cab + half * 0.92) / 2, 0, (floor + hood_top) / 2 - 0.15), ((half * 0.92 - cab) / 2, 0.66, (hood_top - floor) / 2 - 0.15), material=coat)
        kit.add(BOX, (cab, 0, (floor + roof) / 2), (0.75, 1.1, (roof - floor) / 2), (1, 0.95), material=coat)
        kit.add(CYL, (cab, 0, roof - 0.02), (0.14, 1.05, 0.8), rotation=ALONG_X, material=second)
        z = (hood_top + roof) / 2 if roof - hood_top > 0.5 else roof - 0.35
        kit.add(BOX, (cab, 0, roof - 0.42), (0.55, 1.09, 0.24), material=glazing(kit))
        kit.add(BOX, (cab, 0.8, z), (0.765, 0.2, 0.22), material=glazing(kit), mirror=True)
        for x in (-half * 0.65, -half * 0.35, half * 0.75):
            kit.add(BOX, (x, 0, 1.75), (0.35, 0.7, 0.35), material=grilles)
        for x in (-half * 0.6, -half * 0.2):
            kit.add(CYL, (x, 0, hood_top + 0.04), (0.35, 0.35, 0.08), material=dark)
        kit.railing((-half * 0.95, 1.08, floor + 0.1), (cab - 0.8, 1.08, floor + 0.1), 0.75, second, 1.1)
        kit.railing((-half * 0.95, -1.08, floor + 0.1), (cab - 0.8, -1.08, floor + 0.1), 0.75, second, 1.1)
        front_lights(kit, half * 0.93, 0.25, hood_top - 0.5)
        for x in (half * 0.97, -half * 0.97):
            kit.add(BOX, (x, 0.8, floor + 0.45), (0.02, 0.28, 0.4), material=second, mirror=True, cut=(RUNGS, 3, 0.2))
            kit.between((x, 0.85, 0.35), (x, 0.85, floor), (0.15, 0.22), BOX, material=dark, mirror=True)
    else:  # one box with a cab at each end, or one with a nose
        lean, band = rng.uniform(0.1, 0.6), rng.uniform(0.12, 0.3)
        slab(kit, floor, 2.0, (-half, half, 1.12), (-half, half, 1.12), coat)
        slab(kit, 2.0, roof, (-half, half, 1.12), (-half + lean, half - lean, 1.0), coat)
        kit.add(CYL, (0, 0, roof - 0.02), (0.16, 0.95, half - lean - 0.05), rotation=ALONG_X, material=dark if kit.chance(0.5) else coat)
        slab(kit, 2.1, 2.75, (-half - 0.015 + lean * 0.1, half + 0.015 - lean * 0.1, 0.9), (-half + lean * 0.75, half - lean * 0.75, 0.85), glazing(kit))
        panes(kit, (-half + 0.8 + lean, half - 0.8 - lean), 0.25, 1.115, 2.1, 2.7, 1.04)
        kit.add(BOX, (0, 0, 1.5), (half + 0.01, 1.13, band), material=second)
        for x in np.linspace(-half * 0.5, half * 0.5, 4):
            kit.add(BOX, (x, 0, 2.3), (0.4, 1.095, 0.28), (1, 0.94), material=grilles)
        for x in (-half * 0.4, half * 0.4):
            kit.add(CYL, (x, 0, roof + 0.12), (0.45, 0.45, 0.06), material=dark)
        front_lights(kit, half + 0.02, 0.75, 1.35)
        front_lights(kit, -half - 0.02, 0.75, 1.35)
        for x in (half - 1.2 - lean, -half + 1.2 + lean):
            kit.add(BOX, (x, 1.12, 1.85), (0.02, 0.015, 0.75), material=dark, mirror=True)
    for way in (-1, 1):
        buffers(kit, way * half, way, floor, dark)


def pantograph(kit, x, z, metal, dark, tall):
    """A jointed bow that slides on the wire."""
    rng = kit.rng
    knee = np.array([x - 0.55, 0, z + tall * 0.5])
    head = np.array([x + 0.1, 0, z + tall])
    kit.add(BOX, (x, 0, z + 0.06), (0.5, 0.5, 0.05), material=dark)
    kit.between((x + 0.3, 0.3, z), knee, 0.035, material=metal, mirror=True)
    kit.between(knee, head, 0.03, material=metal)
    if rng.random() < 0.5:
        mate = np.array([x + 0.75, 0, z + tall * 0.5])
        kit.between((x - 0.1, 0.3, z), mate, 0.035, material=metal, mirror=True)
        kit.between(mate, head, 0.03, material=metal)
    for dx in (-0.12, 0.12):
        kit.between(head + [dx, -0.75, 0], head + [dx, 0.75, 0], 0.025, material=dark)
    kit.between(head + [-0.12, 0.3, 0], head + [0.12, 0.3, 0], 0.025, material=metal, mirror=True)


def electric(kit):
    rng = kit.rng
    coat, second, dark, steel, metal = livery(kit), livery(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN), chrome(kit)
    half, floor, roof = rng.uniform(3.2, 4.6), 0.95, rng.uniform(2.8, 3.1)
    track(kit, -half - 0.4, half + 0.4)
    for x in (-half * 0.6, half * 0.6):
        bogie(kit, x, 0.7, 0.48, dark, steel)
    kit.add(BOX, (0, 0, 0.65), (half * 0.25, 0.85, 0.3), material=dark)
    if kit.chance(0.3):  # a cab between two sloping hoods
        cab = half * rng.uniform(0.3, 0.42)
        slab(kit, floor - 0.1, roof - 0.05, (-cab, cab, 1.1), (-cab, cab, 1.04), coat)
        for way in (-1, 1):
            ends = ((floor - 0.1, 2.1, 0.95), (floor - 0.1, 1.75, 0.8))
            section(kit, *((cab - 0.1, half) if way > 0 else (-half, -cab + 0.1)), *(ends if way > 0 else ends[::-1]), coat)
        kit.add(BOX, (0, 0, floor - 0.1), (half, 1.1, 0.1), material=dark)
        kit.add(BOX, (0, 0.6, 2.4), (cab + 0.012, 0.3, 0.24), material=glazing(kit), mirror=True)
        panes(kit, (-cab * 0.6, cab * 0.6), cab * 0.25, 1.09, 2.15, 2.65, 1.07)
        front_lights(kit, half * 0.99, 0.55, 1.5)
    else:
        lean = rng.uniform(0.15, 0.7)
        slab(kit, floor - 0.1, 2.0, (-half, half, 1.12), (-half, half, 1.12), coat)
        slab(kit, 2.0, roof, (-half, half, 1.12), (-half + lean, half - lean, 1.0), coat)
        slab(kit, 2.08, 2.7, (-half - 0.015 + lean * 0.08, half + 0.015 - lean * 0.08, 0.95), (-half - 0.015 + lean * 0.7, half + 0.015 - lean * 0.7, 0.88), glazing(kit))
        panes(kit, (-half + 0.85 + lean, half - 0.85 - lean), 0.22, 1.115, 2.1, 2.65, 1.05)
        kit.add(BOX, (0, 0, rng.uniform(1.2, 1.7)), (half + 0.01, 1.13, rng.uniform(0.06, 0.25)), material=second)
        grilles = kit.material(base=coat.first * 0.6, pattern=RIBS, frequency=30, second=[0.04] * 3)
        for x in np.linspace(-half * 0.5, half * 0.5, 4):
            kit.add(BOX, (x, 0, 2.3), (0.35, 1.1, 0.22), (1, 0.95), material=grilles)
        front_lights(kit, half + 0.02, 0.8, 1.3)
        front_lights(kit, -half - 0.02, 0.8, 1.3)
    kit.add(BOX, (0, 0, roof + 0.06), (half * 0.35, 0.7, 0.1), (0.95, 0.9), material=dark)
    if kit.chance(0.5):
        kit.add(BOX, (0, 0, roof + 0.0), (half * 0.75, 0.8, 0.05), material=kit.material(base=[0.3] * 3, pattern=PLAIN))
    raised = rng.uniform(0.6, 1.3)
    pantograph(kit, half * 0.55, roof - 0.02, metal, dark, raised)
    pantograph(kit, -half * 0.55, roof - 0.02, metal, dark, rng.choice([0.2, raised]))
    for way in (-1, 1):
        buffers(kit, way * half, way, floor, dark)


def tram(kit):
    rng = kit.rng
    coat, second, dark, steel, metal = livery(kit), livery(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN), chrome(kit)
    track(kit, -4.0, 4.0)
    if kit.chance(0.5):  # an old one with platforms, some with a clerestory or a second deck
        half, floor, wide = rng.uniform(2.4, 3.4), 0.75, 0.98
        belt, roof = 1.5, rng.uniform(2.6, 2.8)
        inner = half * rng.uniform(0.68, 0.8)
        kit.add(BOX, (0, 0, floor), (half, wide * 0.95, 0.1), material=dark)
        kit.add(BOX, (0, 0, 0.42), (1.1, 0.8, 0.16), material=dark)
        for x in (-0.8, 0.8):
            kit.add(CYL, (x, 0.74, 0.38), (0.38, 0.38, 0.06), rotation=ALONG_Y, material=steel, mirror=True)
        slab(kit, floor, belt, (-inner, inner, wide), (-inner, inner, wide), coat)
        slab(kit, belt, roof, (-inner, inner, wide), (-inner, inner, wide * 0.98), second)
        count = int(rng.integers(3, 7))
        panes(kit, [-inner + 2 * inner * (k + 0.5) / count for k in range(count)], inner * 0.8 / count, wide * 1.01, belt + 0.12, roof - 0.3, wide * 0.995)
        kit.add(BOX, (0, 0, roof + 0.02), (half * 1.02, wide * 1.02, 0.06), (0.98, 0.9), material=kit.material(base=rng.uniform(0.2, 0.7) * np.ones(3)))
        kit.add(BOX, (0, 0, roof + 0.18), (inner * 0.9, wide * 0.5, 0.14), (0.95, 0.9), material=second)
        for x in (-half, half):
            way = np.sign(x)
            kit.add(CYL, (x - way * 0.28, 0, (floor + belt) / 2 + 0.02), (0.32, wide * 0.96, (belt - floor) / 2 + 0.05), material=coat)
            for y in (-0.9, -0.35, 0.35, 0.9):
                kit.between((x - way * (0.28 if abs(y) > 0.5 else 0.02), y * wide, belt), (x - way * (0.28 if abs(y) > 0.5 else 0.05), y * wide, roof), 0.035, BOX, material=second)
            kit.add(CYL, (x + way * 0.05, 0, belt - 0.3), (0.14, 0.14, 0.05), rotation=ALONG_X, material=kit.material(base=[0.88, 0.86, 0.75], pattern=PLAIN))
            kit.add(BOX, (x + way * 0.1, 0, 0.4), (0.03, 0.8, 0.16), material=dark, cut=(BARS, 6, 0.3))
            kit.between((x - way * 0.1, 0.5, floor), (x + way * 0.1, 0.5, 0.45), 0.035, material=dark, mirror=True)
        kit.add(BOX, (0, 0, belt - 0.35), (inner * 1.003, wide * 1.004, 0.05), material=metal)
        kit.add(BOX, (half - 0.1, 0, roof + 0.18), (0.12, 0.5, 0.12), material=kit.material(base=[0.03] * 3, pattern=WRITING, frequency=14, second=[0.9, 0.85, 0.6]))
        if kit.chance(0.5):
            kit.between((0, 0, roof + 0.3), (-half * 0.75, 0, roof + 1.3), 0.035, material=dark)
            kit.add(CYL, (0, 0, roof + 0.32), (0.16, 0.16, 0.08), material=dark)
        else:
            pantograph(kit, 0, roof + 0.3, metal, dark, rng.uniform(0.5, 0.9))
    else:  # one of today in sections with bellows
        parts = int(rng.integers(2, 4))
        long, wide, floor, roof = rng.uniform(2.2, 2.8), 1.0, 0.25, rng.uniform(2.5, 2.7)
        bellows = kit.material(base=[0.04] * 3, pattern=RIBS, frequency=30, second=[0.12] * 3)
        belt = rng.uniform(0.95, 1.15)
        for k in range(parts):
            x = (k - (parts - 1) / 2) * (long + 0.4)
            slab(kit, floor, roof, (x - long / 2, x + long / 2, wide), (x - long / 2, x + long / 2, wide * 0.96), coat)
            panes(kit, np.linspace(x - long * 0.3, x + long * 0.3, 3), long * 0.14, wide * 1.005, belt, roof - 0.45, wide * 0.985)
            kit.add(BOX, (x, 0, floor + 0.22), (long / 2 * 1.0, wide * 1.006, 0.12), material=second)
            kit.add(BOX, (x, 0, 0.28), (long * 0.3, wide * 0.9, 0.2), material=dark)
            for dx in (-0.5, 0.5):
                kit.add(CYL, (x + dx, 0.78, 0.28), (0.28, 0.28, 0.06), rotation=ALONG_Y, material=steel, mirror=True)
            kit.add(BOX, (x, 0, roof + 0.08), (long * 0.35, wide * 0.7, 0.1), (0.95, 0.9), material=dark if kit.chance(0.5) else coat)
            if k:
                kit.add(BOX, (x - long / 2 - 0.2, 0, (floor + roof) / 2), (0.25, wide * 0.92, (roof - floor) * 0.47), material=bellows)
        end = ((parts - 1) / 2) * (long + 0.4) + long / 2
        lean = rng.uniform(0.3, 0.7)
        for way in (-1, 1):
            low, high = (floor, belt + 0.05, wide), (floor + 0.08, belt - 0.1, wide * 0.82)
            section(kit, *((end - 0.1, end + 0.75) if way > 0 else (-end - 0.75, -end + 0.1)), *((low, high) if way > 0 else (high, low)), coat)
            ends = ((end - 0.1, end + 0.7, wide * 0.95), (end - 0.1, end + 0.7 - lean, wide * 0.88))
            flipped = tuple((-b, -a, w) for a, b, w in ends)
            slab(kit, belt - 0.15, roof - 0.2, *(ends if way > 0 else flipped), glazing(kit))
            kit.add(BOX, (way * (end + 0.3 - lean / 2), 0, roof - 0.12), (0.42, wide * 0.9, 0.12), (0.8, 0.9), material=coat)
            front_lights(kit, way * (end + 0.74), wide * 0.6, floor + 0.4, 0.08)
        pantograph(kit, 0, roof + 0.12, metal, dark, rng.uniform(0.5, 0.9))


def coach(kit):
    rng = kit.rng
    coat, second, dark, steel = livery(kit), livery(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN)
    old = kit.chance(0.5)
    half, floor, roof, wide = rng.uniform(3.6, 6.0), 0.95, rng.uniform(2.75, 3.1), 1.08
    if old:
        half *= 0.8
    track(kit, -half - 0.5, half + 0.5)
    for x in (-half * 0.68, half * 0.68):
        bogie(kit, x, 0.6, 0.4, dark, steel)
    kit.add(BOX, (0, 0, floor - 0.05), (half, wide * 0.9, 0.1), material=dark)
    kit.add(BOX, (0, 0, 0.65), (half * 0.3, 0.7, 0.22), material=dark)
    grey = kit.material(base=rng.uniform(0.1, 0.6) * np.ones(3), pattern=rng.choice([PLAIN, SEAMS]))
    body = half * 0.86 if old and kit.chance(0.5) else half
    tone = kit.material(base=coat.first, pattern=RIBS if kit.chance(0.3) else PLAIN, frequency=20)
    belt = floor + (roof - floor) * 0.42
    slab(kit, floor, belt, (-body, body, wide), (-body, body, wide), tone)
    slab(kit, belt - 0.01, roof, (-body, body, wide), (-body, body, wide * 0.97), second if kit.chance(0.4) else coat)
    kit.add(CYL, (0, 0, roof - 0.02), (0.25, wide * 0.96, half), rotation=ALONG_X, material=grey)
    if old and kit.chance(0.5):
        kit.add(BOX, (0, 0, roof + 0.27), (half * 0.95, wide * 0.45, 0.16), (0.98, 0.9), material=coat)
    count = int(rng.integers(6, 12))
    high = floor + (roof - floor) * rng.uniform(0.78, 0.88)
    panes(kit, [-body * 0.84 + 1.68 * body * (k + 0.5) / count for k in range(count)], body * 0.84 / count * rng.uniform(0.65, 0.88), wide * 1.006, belt + 0.08, high, wide * 0.985)
    kit.add(BOX, (0, 0, belt - 0.1), (body + 0.005, wide * 1.006, rng.uniform(0.03, 0.12)), material=second)
    for x in (-body * 0.92, body * 0.92):
        kit.add(BOX, (x, wide, (floor + roof) / 2 - 0.05), (0.25, 0.02, (roof - floor) * 0.42), material=kit.material(base=coat.first * 0.8, pattern=PLAIN), mirror=True)
        kit.add(BOX, (x, wide * 0.95, floor - 0.3), (0.28, 0.1, 0.03), material=dark, mirror=True)
        kit.add(BOX, (x, wide * 0.9, floor - 0.18), (0.03, 0.05, 0.14), material=dark, mirror=True)
    for way in (-1, 1):
        if body < half:
            kit.between((way * (half - 0.04), 0.95, floor), (way * (half - 0.04), 0.95, roof), 0.03, material=dark, mirror=True)
            kit.add(BOX, (way * half, 0, floor + 0.45), (0.02, 0.95, 0.42), material=dark, cut=(BARS, 6, 0.25))
        else:
            kit.add(BOX, (way * half, 0, (floor + roof) / 2 - 0.05), (0.12, 0.45, (roof - floor) * 0.44), material=dark)
        buffers(kit, way * half, way, floor, dark)


def goods(kit):
    rng = kit.rng
    coat, dark, steel = livery(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN)
    rust = kit.material(base=np.array([0.3, 0.14, 0.08]) * rng.uniform(0.5, 1.5), pattern=rng.choice([PLAIN, STREAKS, CLOUDY]))
    body = rust if kit.chance(0.4) else coat
    half, floor, wide = rng.uniform(2.2, 4.2), 1.0, 1.05
    track(kit, -half - 0.5, half + 0.5)
    if half > 2.9:
        for x in (-half * 0.66, half * 0.66):
            bogie(kit, x, 0.55, 0.4, dark, steel)
    else:
        for x in (-half * 0.55, half * 0.55):
            kit.add(CYL, (x, 0.74, 0.42), (0.42, 0.42, 0.06), rotation=ALONG_Y, material=steel, mirror=True)
            kit.add(BOX, (x, 0.86, 0.55), (0.35, 0.05, 0.2), (0.5, 1), material=dark, mirror=True)
            kit.between((x, -0.8, 0.42), (x, 0.8, 0.42), 0.06, material=dark)
            kit.between((x, 0.86, 0.5), (x, 0.86, floor), 0.06, BOX, material=dark, mirror=True)
    kit.add(BOX, (0, 0, floor - 0.08), (half, wide * 0.85, 0.14), material=dark)
    for way in (-1, 1):
        buffers(kit, way * half, way, floor - 0.05, dark)
    deck = floor + 0.06
    kind = rng.choice(["tank", "hopper", "box", "flat", "open"])
    if kind == "tank":
        radius = rng.uniform(0.8, 1.0)
        z = deck + radius + 0.08
        kit.add(CYL, (0, 0, z), (radius, radius, half * 0.88), rotation=ALONG_X, material=kit.material(base=body.first, pattern=rng.choice([PLAIN, STREAKS, WRITING]), gloss=0.3))
        for x in (-half * 0.88, half * 0.88):
            kit.add(BALL, (x, 0, z), (0.22, radius * 0.99, radius * 0.99), material=body)
        for x in (-half * 0.6, half * 0.6):
            kit.add(BOX, (x, 0, deck + radius * 0.35), (0.12, radius * 0.95, radius * 0.4), material=dark)
            kit.add(CYL, (x * 0.75, 0, z), (radius * 1.015, radius * 1.015, 0.04), rotation=ALONG_X, material=dark)
        kit.add(CYL, (0, 0, z + radius), (0.3, 0.3, 0.18), material=body)
        kit.add(BOX, (0, 0, z + radius + 0.06), (half * 0.5, 0.4, 0.015), material=steel)
        kit.add(BOX, (0.35, radius + 0.05, (deck + z + radius) / 2), (0.2, 0.015, (z + radius - deck) / 2), material=steel, mirror=True, cut=(RUNGS, 4, 0.15))
        kit.add(BOX, (-half * 0.35, radius * 0.97, z), (0.5, 0.05, 0.2), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=20, second=[0.03] * 3), mirror=True)
    elif kind == "hopper":
        top, low = rng.uniform(2.5, 2.9), 0.65
        count = 3 if half > 3 else 2
        slab(kit, deck + 0.55, top, (-half * 0.95, half * 0.95, wide), (-half * 0.97, half * 0.97, wide), body)
        for k in range(count):
            x, share = half * 0.95 * ((2 * k + 1) / count - 1), half * 0.95 / count
            slab(kit, low, deck + 0.6, (x - share * 0.35, x + share * 0.35, 0.35), (x - share, x + share, wide), body)
        for x in np.linspace(-half * 0.9, half * 0.9, 7):
            kit.add(BOX, (x, wide + 0.02, (deck + 0.55 + top) / 2), (0.05, 0.05, (top - deck - 0.5) / 2), material=body, mirror=True)
        kit.add(BOX, (0, 0, top), (half * 0.98, wide * 1.06, 0.06), material=body)
        load = kit.material(base=rng.choice([[0.02, 0.02, 0.02], [0.35, 0.3, 0.25], [0.5, 0.4, 0.2]]), pattern=17, frequency=40)
        if kit.chance(0.6):
            kit.add(BALL, (0, 0, top + 0.02), (half * 0.92, wide * 0.92, rng.uniform(0.12, 0.35)), material=load)
        else:
            kit.add(BOX, (0, 0, top + 0.04), (half * 0.94, wide * 0.94, 0.03), material=dark)
        for x in (-half * 0.95, half * 0.95):
            kit.between((x, 0.8, floor), (x * 0.97, 0.8, deck + 0.7), 0.06, BOX, material=dark, mirror=True)
    elif kind == "box":
        top = rng.uniform(2.7, 3.1)
        skin = kit.material(base=body.first, pattern=rng.choice([PLANKS, RIBS, PLAIN, SEAMS]), frequency=14)
        kit.add(BOX, (0, 0, (deck + top) / 2), (half * 0.97, wide, (top - deck) / 2), material=skin)
        kit.add(CYL, (0, 0, top - 0.02), (0.2, wide * 1.02, half * 0.99), rotation=ALONG_X, material=kit.material(base=rng.uniform(0.1, 0.6) * np.ones(3), pattern=PLAIN))
        kit.add(BOX, (0, wide + 0.03, (deck + top) / 2 - 0.05), (half * 0.22, 0.03, (top - deck) * 0.45), material=kit.material(base=body.first * 0.75, pattern=PLANKS), mirror=True)
        for z in (deck + 0.1, top - 0.15):
            kit.add(BOX, (half * 0.15, wide + 0.04, z), (half * 0.5, 0.03, 0.03), material=dark, mirror=True)
        for x in (-half * 0.95, -half * 0.5, half * 0.5, half * 0.95):
            kit.add(BOX, (x, wide, (deck + top) / 2), (0.05, 0.04, (top - deck) / 2), material=dark, mirror=True)
        for y in (-0.25, 0.25):
            kit.between((-half, y, deck), (-half, y, top), 0.025, material=steel)
        kit.add(BOX, (-half, 0, (deck + top) / 2), (0.015, 0.25, (top - deck) / 2), material=steel, cut=(RUNGS, 3.5, 0.15))
        kit.add(BOX, (-half * 0.65, wide + 0.01, (deck + top) / 2 + 0.2), (half * 0.18, 0.015, 0.25), material=kit.material(base=body.first, pattern=WRITING, frequency=20, second=[0.8] * 3), mirror=True)
    elif kind == "open":
        top = deck + rng.uniform(0.6, 1.1)
        skin = kit.material(base=body.first, pattern=rng.choice([PLANKS, PLAIN, RIBS]), frequency=14)
        kit.add(BOX, (0, 0, deck), (half * 0.97, wide, 0.05), material=dark)
        kit.add(BOX, (0, wide, (deck + top) / 2), (half * 0.97, 0.05, (top - deck) / 2), material=skin, mirror=True)
        for x in (-half * 0.97, half * 0.97):
            kit.add(BOX, (x, 0, (deck + top) / 2), (0.05, wide, (top - deck) / 2), material=skin)
        for x in np.linspace(-half * 0.9, half * 0.9, 5):
            kit.add(BOX, (x, wide + 0.07, (deck + top) / 2), (0.05, 0.04, (top - deck) / 2), material=dark, mirror=True)
        if kit.chance(0.6):
            load = kit.material(base=rng.choice([[0.02, 0.02, 0.02], [0.35, 0.3, 0.25], [0.5, 0.4, 0.2]]), pattern=17, frequency=40)
            kit.add(BALL, (0, 0, top - 0.1), (half * 0.9, wide * 0.9, rng.uniform(0.2, 0.5)), material=load)
    else:
        kit.add(BOX, (0, 0, deck), (half * 0.98, wide, 0.06), material=kit.material(base=timber(kit).first, pattern=PLANKS))
        load = rng.choice(["containers", "logs", "pipes", "machine"])
        if load == "containers":
            count = 2 if half > 3 and kit.chance(0.6) else 1
            for k in range(count):
                long = half * 0.94 / count
                x = half * 0.94 * ((2 * k + 1) / count - 1)
                kit.add(BOX, (x, 0, deck + 0.9), (long * 0.97, wide * 0.95, 0.84), material=kit.material(base=livery(kit).first, pattern=RIBS, frequency=16))
                for y in (-0.45, 0.45):
                    kit.add(BOX, (x - long * 0.975, y, deck + 0.9), (0.012, 0.4, 0.76), material=steel)
        elif load in ("logs", "pipes"):
            skin = timber(kit) if load == "logs" else chrome(kit)
            for row, many in enumerate((4, 3, 2)[: int(rng.integers(1, 4))]):
                for k in range(many):
                    kit.add(CYL if load == "logs" else TUBE, (0, (k - (many - 1) / 2) * 0.5, deck + 0.3 + 0.43 * row), (0.25, 0.25, half * rng.uniform(0.8, 0.9)), rotation=ALONG_X, material=skin)
            for x in np.linspace(-half * 0.75, half * 0.75, 4):
                kit.between((x, wide, deck - 0.1), (x, wide, deck + 1.4), 0.045, BOX, material=dark, mirror=True)
        else:
            kit.add(BOX, (0, 0, deck + 0.5), (half * 0.5, wide * 0.6, 0.45), (0.9, 0.9), material=coat)
            kit.add(CYL, (half * 0.1, 0, deck + 1.1), (0.4, 0.4, 0.3), material=coat)
            for x in (-half * 0.5, half * 0.5):
                kit.between((x, 0.6, deck + 0.7), (x * 1.5, 0.95, deck), 0.02, material=dark, mirror=True)


def underground(kit):
    rng = kit.rng
    coat, second, dark, steel = kit.material(base=rng.uniform(0.45, 0.75) * np.ones(3), pattern=rng.choice([PLAIN, RIBS]), frequency=14, gloss=0.4), livery(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN)
    if kit.chance(0.35):
        coat = livery(kit)
    half, floor, roof, wide = rng.uniform(3.4, 5.0), 0.8, rng.uniform(2.5, 2.75), 1.05
    track(kit, -half - 0.5, half + 0.5)
    for x in (-half * 0.68, half * 0.68):
        bogie(kit, x, 0.55, 0.38, dark, steel)
    kit.add(BOX, (0, 0, 0.6), (half * 0.35, 0.8, 0.22), material=dark)
    middle = (floor + roof) / 2
    slab(kit, floor - 0.1, middle, (-half, half, wide * 0.97), (-half, half, wide), coat)
    slab(kit, middle, roof, (-half, half, wide), (-half, half - 0.1, wide * 0.85), coat)
    kit.add(CYL, (0, 0, roof - 0.02), (0.22, wide * 0.86, half - 0.06), rotation=ALONG_X, material=coat)
    doors = np.linspace(-half * 0.72, half * 0.68, int(rng.integers(3, 5)))
    door_paint = second if kit.chance(0.6) else kit.material(base=coat.first * 0.8, pattern=PLAIN)
    for x in doors:
        slab(kit, floor, middle, (x - 0.42, x + 0.42, wide * 0.99), (x - 0.42, x + 0.42, wide * 1.012), door_paint)
        slab(kit, middle, roof - 0.1, (x - 0.42, x + 0.42, wide * 1.012), (x - 0.42, x + 0.42, wide * 0.89), door_paint)
    panes(kit, [x + dx for x in doors for dx in (-0.2, 0.2)], 0.13, wide * 1.02, middle, roof - 0.35, wide * 0.94)
    gap = doors[1] - doors[0]
    panes(kit, [(a + b) / 2 for a, b in zip(doors[:-1], doors[1:], strict=True)], gap / 2 - 0.55, wide * 1.008, middle, roof - 0.35, wide * 0.925)
    kit.add(BOX, (half, 0, middle + 0.05), (0.02, wide * 0.28, (roof - floor) * 0.45), material=second)
    for y in (-0.62, 0, 0.62):
        slab(kit, middle + 0.02, roof - 0.2, (half - 0.3, half + 0.03, wide * (0.22 if y else 0.16)), (half - 0.3, half - 0.04 if y else half + 0.03, wide * (0.2 if y else 0.16)), glazing(kit), y * wide)
    front_lights(kit, half + 0.01, wide * 0.65, floor + 0.3, 0.09)
    kit.add(BOX, (half, 0, floor - 0.02), (0.1, wide * 0.6, 0.12), material=dark)
    kit.add(BOX, (half - 0.05, 0, roof + 0.02), (0.07, 0.4, 0.1), material=kit.material(base=[0.03] * 3, pattern=WRITING, frequency=14, second=[0.9, 0.6, 0.1]))
    kit.add(BOX, (-half, 0, middle), (0.1, 0.4, (roof - floor) * 0.42), material=dark)
    kit.add(BOX, (0, 0, floor + 0.12), (half * 1.002, wide * 0.99, 0.06), material=second)


def fast(kit):
    """The head of a high-speed train with a long nose, and the coach behind it."""
    rng = kit.rng
    coat = kit.material(base=rng.uniform(0.55, 0.85) * np.ones(3), pattern=PLAIN, gloss=0.4) if kit.chance(0.6) else livery(kit)
    second, dark, steel, metal = livery(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN), chrome(kit)
    half, floor, roof, wide, nose = rng.uniform(3.0, 4.2), 0.4, rng.uniform(2.6, 2.85), 1.05, rng.uniform(1.8, 3.6)
    track(kit, -half - 0.2, half + nose)
    steps = [(0, floor, roof, wide), (0.3, floor, roof - 0.18, wide * 0.97), (0.62, floor, roof - 0.85, wide * 0.86), (0.88, floor + 0.05, roof - 1.4, wide * 0.6), (1.0, floor + 0.15, roof - 1.72, wide * 0.32)]
    middle = (floor + roof) / 2
    slab(kit, floor, middle, (-half, half, wide * 0.97), (-half, half, wide), coat)
    slab(kit, middle - 0.01, roof, (-half, half, wide), (-half, half, wide * 0.8), coat)
    kit.add(CYL, (0, 0, roof - 0.04), (0.2, wide * 0.82, half), rotation=ALONG_X, material=coat)
    for (a, low0, high0, wide0), (b, low1, high1, wide1) in zip(steps[:-1], steps[1:], strict=True):
        section(kit, half + a * nose - 0.05, half + b * nose, (low0, high0 - 0.35, wide0), (low1, high1 - 0.35, wide1), coat)
        kit.add(CYL, (half + (a + b) / 2 * nose, 0, (high0 + high1) / 2 - 0.42), (0.4, wide0 * 0.93, (b - a) * nose / 2 + 0.05), (wide1 / wide0, 1), rotation=turn("y", 90 + np.degrees(np.arctan2(high0 - high1, (b - a) * nose))), material=coat)
    kit.add(BALL, (half + nose * 0.97, 0, (floor + roof - 1.72) / 2 + 0.1), (0.25, wide * 0.34, 0.4), material=coat)
    kit.add(BALL, (half + nose * 0.38, 0, roof - 0.5), (nose * 0.26, wide * 0.62, 0.36), rotation=turn("y", 18), material=glazing(kit))
    count = int(rng.integers(6, 10))
    panes(kit, [-half + 0.5 + (2 * half - 0.9) * (k + 0.5) / count for k in range(count)], (half - 0.45) / count * 0.8, wide * 1.005, middle + 0.05, middle + 0.6, wide * 0.955)
    kit.add(BOX, (0, 0, middle - 0.25), (half, wide * 1.005, rng.uniform(0.05, 0.18)), material=second)
    section(kit, half - 0.05, half + nose * 0.62, (middle - 0.35, middle - 0.15, wide * 1.006), (middle - 0.4, middle - 0.2, wide * 0.875), second)
    kit.add(BOX, (0, 0, floor - 0.02), (half * 0.98, wide * 0.9, 0.16), material=dark)
    for x in (-half * 0.7, half * 0.75):
        bogie(kit, x, 0.55, 0.38, dark, steel)
    kit.add(BOX, (half + nose * 0.3, 0, floor), (nose * 0.35, wide * 0.7, 0.14), material=dark)
    white = kit.material(base=[0.88, 0.88, 0.82], pattern=PLAIN, gloss=0.6)
    kit.add(BALL, (half + nose * 0.9, wide * 0.42, roof - 1.72), (0.22, 0.1, 0.07), rotation=turn("y", 20), material=white, mirror=True)
    kit.add(BOX, (half - 0.5, wide * 0.98, middle - 0.02), (0.25, 0.04, 0.8), material=kit.material(base=coat.first * 0.8, pattern=PLAIN), mirror=True)
    kit.add(BOX, (-half - 0.1, 0, middle), (0.14, wide * 0.8, (roof - floor) * 0.42), material=dark)
    if kit.chance(0.5):
        pantograph(kit, -half * 0.5, roof + 0.1, metal, dark, rng.uniform(0.5, 0.9))


def handcar(kit):
    rng = kit.rng
    coat, wood, dark, steel = livery(kit), timber(kit), kit.material(dark=True), kit.material(base=[0.2, 0.19, 0.18], pattern=PLAIN)
    half, radius = rng.uniform(0.85, 1.2), rng.uniform(0.24, 0.32)
    track(kit, -half - 0.8, half + 0.8)
    for x in (-half * 0.6, half * 0.6):
        kit.add(CYL, (x, 0.74, radius), (radius, radius, 0.05), rotation=ALONG_Y, material=steel, mirror=True, cut=(SPOKES, 8, 0.3))
        kit.between((x, -0.78, radius), (x, 0.78, radius), 0.04, material=steel)
        kit.add(BOX, (x, 0.55, radius + 0.08), (0.12, 0.06, 0.12), material=dark, mirror=True)
    deck = radius + 0.22
    kit.add(BOX, (0, 0.55, deck - 0.05), (half, 0.06, 0.06), material=coat, mirror=True)
    kit.add(BOX, (0, 0, deck), (half, 0.78, 0.035), material=kit.material(base=wood.first, pattern=PLANKS, frequency=14))
    pivot = np.array([0, 0, deck + rng.uniform(0.75, 0.9)])
    for x in (-0.3, 0.3):
        kit.between((x, 0.22, deck), pivot + [0, 0.14, 0], 0.04, BOX, material=coat, mirror=True)
    kit.between(pivot - [0, 0.2, 0], pivot + [0, 0.2, 0], 0.045, material=steel)
    tilt = np.radians(rng.uniform(-18, 18))
    arm = np.array([np.cos(tilt), 0, np.sin(tilt)]) * half * 0.9
    kit.between(pivot - arm, pivot + arm, (0.045, 0.05), BOX, material=wood)
    for end in (pivot - arm, pivot + arm):
        kit.between(end - [0, 0.45, 0], end + [0, 0.45, 0], 0.03, material=wood)
    kit.between(pivot + arm * 0.35, (half * 0.3, 0, radius), 0.03, material=steel)
    kit.add(CYL, (half * 0.3, 0, radius + 0.02), (radius * 0.8, radius * 0.8, 0.03), rotation=ALONG_Y, material=steel)
    kit.between((half * 0.3, -0.55, radius + 0.02), (half * 0.3, 0.55, radius + 0.02), 0.03, material=steel)
    if kit.chance(0.5):
        kit.add(BOX, (-half * 0.7, rng.uniform(-0.3, 0.3), deck + 0.18), (0.2, 0.25, 0.15), material=wood)
    if kit.chance(0.4):
        for x in (-half, half):
            kit.between((x, 0.7, deck), (x, 0.7, deck + 0.6), 0.025, material=steel, mirror=True)
            kit.between((x, -0.7, deck + 0.6), (x, 0.7, deck + 0.6), 0.025, material=steel)


def cable_car(kit):
    """A cabin that hangs by its arm from a rope, between two posts or at one; a gondola, a big cabin or a chair."""
    rng = kit.rng
    coat, second, dark, metal = livery(kit), livery(kit), kit.material(dark=True), chrome(kit)
    kind = rng.choice(["gondola", "cabin", "chair"])
    size = {"gondola": 0.85, "cabin": 1.5, "chair": 0.3}[kind]
    floor = rng.uniform(0.6, 1.6)
    tall, arm = rng.uniform(1.5, 1.8) if kind != "cabin" else rng.uniform(2.0, 2.3), rng.uniform(0.7, 1.2)
    rope = floor + tall + arm
    wide = {"gondola": 0.75, "cabin": 1.0, "chair": 0.85}[kind]
    if kind == "chair":
        kit.add(BOX, (0, 0, floor + 0.45), (0.25, wide, 0.05), material=coat)
        kit.add(BOX, (-0.27, 0, floor + 0.8), (0.04, wide, 0.32), (1, 1), (-0.1, 0), material=coat)
        kit.between((-0.3, wide, floor + 0.5), (-0.2, wide, floor + tall * 0.95), 0.03, material=dark, mirror=True)
        kit.between((-0.2, -wide, floor + tall * 0.95), (-0.2, wide, floor + tall * 0.95), 0.03, material=dark)
        kit.between((-0.2, 0, floor + tall * 0.95), (0, 0, floor + tall), 0.035, material=dark)
        kit.between((0.25, wide * 0.95, floor + 0.75), (-0.3, wide * 0.95, floor + 0.8), 0.025, material=metal, mirror=True)
        kit.between((0.25, -wide * 0.95, floor + 0.75), (0.25, wide * 0.95, floor + 0.75), 0.025, material=metal)
        kit.between((0.25, wide * 0.5, floor + 0.75), (0.3, wide * 0.5, floor), 0.02, material=metal, mirror=True)
        kit.between((0.3, wide * 0.15, floor), (0.3, wide * 0.85, floor), 0.02, material=metal, mirror=True)
    else:
        belt, round_shape = floor + tall * 0.42, kit.chance(0.5)
        foot = (-size * (0.8 if round_shape else 0.97), size * (0.8 if round_shape else 0.97), wide * 0.88)
        slab(kit, floor, belt, foot, (-size, size, wide), coat)
        slab(kit, belt, floor + tall * 0.92, (-size, size, wide), (-size * 0.88, size * 0.88, wide * 0.88), glazing(kit))
        slab(kit, floor + tall * 0.9, floor + tall, (-size * 0.92, size * 0.92, wide * 0.92), (-size * 0.7, size * 0.7, wide * 0.7), coat)
        for x in (-1, 1):
            kit.between((x * size, wide, belt), (x * size * 0.88, wide * 0.88, floor + tall * 0.92), 0.05, BOX, material=coat, mirror=True)
        kit.between((0, wide, belt), (0, wide * 0.88, floor + tall * 0.92), 0.035, BOX, material=coat, mirror=True)
        kit.add(BOX, (0, wide * 0.97, (floor + belt) / 2), (0.012, 0.03, (belt - floor) * 0.45), material=dark, mirror=True)
        kit.add(BOX, (0, 0, belt), (size * 1.01, wide * 1.01, 0.04), material=second)
        if kind == "gondola" and kit.chance(0.4):
            kit.add(BOX, (0, wide + 0.06, floor + 0.4), (0.25, 0.05, 0.3), material=metal, mirror=True, cut=(BARS, 7, 0.3))
    kit.between((0, 0, floor + tall - 0.02), (0, 0.12, rope - 0.15), 0.06, BOX, material=dark)
    kit.between((0, 0.12, rope - 0.17), (0, 0, rope - 0.04), 0.06, BOX, material=dark)
    reach = size + rng.uniform(0.8, 1.6)
    kit.add(BOX, (0, 0, rope + 0.02), (0.35 if kind != "cabin" else 0.8, 0.08, 0.07), material=metal)
    for x in np.linspace(-0.25, 0.25, 2) * (1 if kind != "cabin" else 2.4):
        kit.add(CYL, (x, 0, rope + 0.08), (0.1, 0.1, 0.04), rotation=ALONG_Y, material=dark)
    kit.between((-reach, 0, rope - 0.02), (reach, 0, rope - 0.02), 0.025, material=dark)
    beam = wide + rng.uniform(0.6, 0.9)
    for x in (-reach, reach) if kit.chance(0.7) else (-reach,):
        kit.between((x, beam, 0), (x, beam, rope + 0.3), 0.13, taper=0.7, material=metal)
        kit.between((x, -0.15, rope + 0.15), (x, beam + 0.1, rope + 0.2), (0.1, 0.08), BOX, material=metal)
        kit.add(CYL, (x, beam, 0.06), (0.35, 0.35, 0.08), material=kit.material(base=[0.4, 0.39, 0.37], pattern=CLOUDY))
        kit.add(BOX, (x, 0, rope + 0.03), (0.3, 0.05, 0.06), material=dark)
        kit.between((x, 0, rope + 0.03), (x, 0, rope + 0.16), 0.05, material=dark)


def roller_coaster(kit):
    """One to three low cars with seats and bars on a tubular track on posts, with a bow in front."""
    rng = kit.rng
    coat, second, dark, metal, cloth = livery(kit), livery(kit), kit.material(dark=True), chrome(kit), hide(kit)
    rail = kit.material(base=livery(kit).first, pattern=PLAIN, gloss=0.3)
    count, rise = int(rng.integers(1, 4)), rng.uniform(-0.45, 0.45)
    long, wide, level = 1.15, 0.55, rng.uniform(0.8, 1.6)
    reach = count * long + 0.9
    slope = np.array([1, 0, np.sin(rise) * 0.9])
    slope /= np.linalg.norm(slope)
    spin = turn("y", -np.degrees(np.arcsin(slope[2])))
    level += abs(slope[2]) * reach
    origin = np.array([0, 0, level])
    kit.between(origin - slope * reach + [0, 0.42, 0], origin + slope * reach + [0, 0.42, 0], 0.05, material=rail, mirror=True)
    kit.between(origin - slope * reach - [0, 0, 0.28], origin + slope * reach - [0, 0, 0.28], 0.1, material=rail)
    for at in np.linspace(-0.92, 0.92, 5):
        base = origin + slope * reach * at
        kit.between(base - [0, 0, 0.28], base + [0, 0.42, 0], 0.035, material=rail, mirror=True)
    for at in (-0.85, 0.0, 0.85):
        base = origin + slope * reach * at - [0, 0, 0.3]
        kit.between(base, [base[0], 0.5, 0], 0.06, material=metal, mirror=True)

    def place(x, y, z):
        return origin + spin @ np.array([x, y, z])

    for k in range(count):
        x = (k - (count - 1) / 2) * long * 1.05 * 2 * 0.62
        for dy in (-1, 1):
            kit.add(BOX, place(x, dy * wide, 0.42), (long * 0.56, 0.05, 0.2), (0.9, 1), rotation=spin, material=coat)
        kit.add(BOX, place(x, 0, 0.22), (long * 0.58, wide, 0.07), rotation=spin, material=second)
        kit.add(BOX, place(x - 0.1, 0, 0.42), (0.22, wide * 0.9, 0.1), rotation=spin, material=cloth)
        kit.add(BOX, place(x - 0.38, 0, 0.72), (0.07, wide * 0.9, 0.36), (1, 0.9), rotation=spin, material=cloth)
        kit.between(place(x + 0.18, -wide * 0.9, 0.68), place(x + 0.18, wide * 0.9, 0.68), 0.03, material=metal)
        kit.between(place(x + 0.18, 0, 0.68), place(x + 0.45, 0, 0.28), 0.03, material=metal)
        for dx in (-0.38, 0.38):
            kit.add(CYL, place(x + dx, 0.42, 0.11), (0.09, 0.09, 0.05), rotation=spin @ ALONG_Y, material=dark)
            kit.add(CYL, place(x + dx, -0.42, 0.11), (0.09, 0.09, 0.05), rotation=spin @ ALONG_Y, material=dark)
    nose = (count - 1) / 2 * long * 1.05 * 2 * 0.62 + long * 0.5
    kit.add(BALL, place(nose, 0, 0.38), (0.4, wide * 1.0, 0.26), rotation=spin, material=coat)
    kit.add(BALL, place(nose + 0.33, wide * 0.5, 0.42), (0.06, 0.09, 0.07), rotation=spin, material=second)
    kit.add(BALL, place(nose + 0.33, -wide * 0.5, 0.42), (0.06, 0.09, 0.07), rotation=spin, material=second)
