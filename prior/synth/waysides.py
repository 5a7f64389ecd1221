"""Open buildings of traffic: petrol stations, bus shelters, covered bridges, platforms, car parks, toll gates, car washes, ski lifts."""

import numpy as np

from .building_parts import bench, lettered, paving, posts, rafters, slab, timberwork, vivid
from .dwellings import BLUE, CONCRETE, CREAM, GREEN, GREY, RED, SNOW, STONE, TIMBER, WHITE, WOOD, YELLOW, boards, leaves, masonry, panes, roof, row, tiles
from .installations import ladder, steelwork, tinted
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BARS, BOX, CYL, LATTICE, RUNGS, SPOKES, TUBE
from .materials import BANDS, CLOUDY, DOTS, PLAIN, PLANKS, RIBS, SPECKLES, STREAKS, STRIPES, WRITING


def filling_station(kit):
    rng = kit.rng
    brand, white, dark, steel, glass = vivid(kit), tinted(kit, (WHITE,)), kit.material(dark=True), steelwork(kit), panes(kit)
    x, y, high, islands = rng.uniform(2.8, 3.8), rng.uniform(3.5, 5.5), rng.uniform(4.2, 5.2), int(rng.integers(1, 4))
    slab(kit, 0, 0, 0, (x + 0.8, y + 0.6, 0.05), paving(kit))
    kit.add(BOX, (0, 0, high + 0.3), (x, y, 0.3), material=brand)
    kit.add(BOX, (0, 0, high + 0.3), (x + 0.03, y + 0.03, 0.09), material=white)
    kit.add(BOX, (0, 0, high - 0.02), (x * 0.95, y * 0.95, 0.05), material=white)
    for k in range(islands):
        py = y * (0 if islands == 1 else 1.2 * k / (islands - 1) - 0.6)
        slab(kit, 0, py, 0.05, (x * 0.62, 0.45, 0.09), white)
        for px in (-x * 0.5, x * 0.5):
            kit.add(BOX, (px, py, high / 2), (0.15, 0.15, high / 2), material=steel)
        for px in [-x * 0.22, x * 0.22][: 1 if islands == 3 else 2]:
            slab(kit, px, py, 0.2, (0.32, 0.24, 0.75), white)
            slab(kit, px, py, 1.35, (0.34, 0.26, 0.22), brand)
            kit.add(BOX, (px, py, 1.15), (0.22, 0.26, 0.14), material=dark)
            kit.chain([(px + 0.33, py + 0.1, 1.25), (px + 0.55, py + 0.1, 0.5), (px + 0.34, py + 0.1, 0.75)], 0.035, dark, joints=False)
    if kit.chance(0.6):
        back, deep = -x - 0.5, rng.uniform(1.4, 2)
        slab(kit, back - deep, 0, 0, (deep, y * 0.8, 1.6), white)
        slab(kit, back - deep, 0, 3.2, (deep + 0.25, y * 0.8 + 0.25, 0.2), brand)
        for py in row(3, y * 0.8, 0.92):
            kit.add(BOX, (back, py, 1.35), (0.06, y * 0.2, 1.1), material=glass)
        kit.add(BOX, (back + 0.3, 0, 3.42), (0.06, 1.2, 0.16), material=lettered(kit))
    if kit.chance(0.6):
        slab(kit, x + 0.5, -y, 0, (0.2, 0.65, 2.4), brand)
        for k in range(3):
            kit.add(BOX, (x + 0.5, -y, 1.6 + 0.75 * k), (0.23, 0.52, 0.28), material=dark if k < 2 else white)


def bus_shelter(kit):
    rng = kit.rng
    steel, glass, cover = steelwork(kit), tinted(kit, ((0.25, 0.32, 0.35),), gloss=0.6), steelwork(kit)
    y, x, high = rng.uniform(1.5, 2.6), rng.uniform(0.6, 0.9), 2.4
    slab(kit, 0, 0, 0, (x + 0.3, y + 0.3, 0.06), paving(kit))
    posts(kit, (-x, x), np.linspace(-y, y, 3)[:: 2 if kit.chance(0.5) else 1], 0, high, 0.05, steel)
    kit.add(BOX, (-x, 0, 1.25), (0.02, y, 0.95), material=glass)
    kit.add(BOX, (-x, 0, 1.25), (0.035, y, 1.0), material=steel, cut=(BARS, 2 / y, 0.08))
    kit.add(BOX, (-x * 0.2, y, 1.25), (x * 0.75, 0.02, 0.95), material=glass, mirror=kit.chance(0.6))
    kind = rng.choice(["flat", "arch", "gable", "lean"])
    if kind == "flat":
        slab(kit, 0.1, 0, high, (x + 0.25, y + 0.2, 0.08), cover)
    elif kind == "lean":
        kit.add(BOX, (0.1, 0, high + 0.08), (x + 0.35, y + 0.25, 0.05), rotation=turn("y", -6), material=cover)
    elif kind == "arch":
        for a, b in ((-1, -0.5), (-0.5, 0), (0, 0.5), (0.5, 1)):
            low, top = np.array([(x + 0.2) * a, 0, high + 0.4 * (1 - a * a)]), np.array([(x + 0.2) * b, 0, high + 0.4 * (1 - b * b)])
            kit.between(low, top, (0.03, y + 0.2), BOX, material=cover)
    else:
        roof(kit, (0, 0, high), (x, y), 0.6, "gable", 0.25, tiles(kit), cover, 1)
    bench(kit, -x * 0.55, 0, 0.06, y * 0.7, timberwork(kit), 0)
    slab(kit, 0, -y - 0.1, 0.06, (x * 0.6, 0.1, 0.9), vivid(kit, (PLAIN, DOTS, WRITING), frequency=10))
    slab(kit, x + 0.15, y + 0.1, 0, (0.04, 0.04, 1.5), steel)
    kit.add(BOX, (x + 0.15, y + 0.1, 2.8), (0.03, 0.3, 0.3), material=lettered(kit))
    kit.add(CYL, (x, -y * 0.5, 0.4), (0.2, 0.2, 0.35), material=kit.material(dark=True))


def covered_bridge(kit):
    rng = kit.rng
    wall, cover, frame, stone = (
        tinted(kit, (RED, RED, WOOD, GREY, WHITE), (PLANKS, STRIPES), frequency=rng.uniform(10, 20), gloss=0.0),
        tiles(kit),
        timberwork(kit),
        masonry(kit),
    )
    x, y, lift, high = rng.uniform(5, 7.5), rng.uniform(1.5, 2), rng.uniform(1.2, 2.2), rng.uniform(2.4, 2.9)
    rise = y * rng.uniform(0.6, 0.9)
    kit.add(BOX, (0, 0, lift), (x + 1.2, y, 0.15), material=frame)
    for end in (-1, 1):
        kit.add(BOX, (end * (x + 0.5), 0, lift / 2 - 0.05), (1.2, y * 1.2, lift / 2), (0.7, 0.9), material=stone)
    for px in (-x / 3, x / 3)[: int(rng.integers(0, 3))]:
        slab(kit, px, 0, 0, (0.35, y * 1.05, lift / 2), stone, taper=(0.8, 0.95))
    kind = rng.choice(["lattice", "windows", "half"])
    for side in (-1, 1):
        if kind == "half":
            kit.add(BOX, (0, side * y, lift + high * 0.25), (x, 0.07, high * 0.25), material=wall)
            kit.add(BOX, (0, side * y, lift + high * 0.95), (x, 0.07, high * 0.06), material=wall)
        elif kind == "windows":
            kit.add(BOX, (0, side * y, lift + high * 0.27), (x, 0.07, high * 0.27), material=wall)
            kit.add(BOX, (0, side * y, lift + high * 0.9), (x, 0.07, high * 0.1), material=wall)
            kit.add(BOX, (0, side * y, lift + high * 0.65), (x, 0.06, high * 0.2), material=wall, cut=(BARS, 3.5 / x, 0.6))
        else:
            kit.add(BOX, (0, side * y, lift + high / 2), (x, 0.06, high / 2), material=frame, cut=(LATTICE, 1.0, 0.25))
            kit.add(BOX, (0, side * y, lift + high * 0.95), (x, 0.07, high * 0.06), material=frame)
        if kind == "half":
            posts(kit, np.linspace(-x, x, 8), (side * y,), lift, lift + high, 0.08, frame)
    for end in (-1, 1):
        kit.add(BOX, (end * x, 0, lift + high + rise / 2), (0.08, y, rise / 2), (1, 0.02), material=wall)
        kit.add(BOX, (end * x, 0, lift + high - 0.12), (0.1, y + 0.1, 0.25), material=wall)
        kit.add(BOX, (end * x, y * 0.93, lift + high / 2), (0.1, 0.17, high / 2), material=wall, mirror=True)
        kit.railing((end * x, y, lift + 0.1), (end * (x + 1.6), y, lift + 0.1), 0.8, frame, 0.4)
        kit.railing((end * x, -y, lift + 0.1), (end * (x + 1.6), -y, lift + 0.1), 0.8, frame, 0.4)
    leaves(kit, (0, 0, lift + high), np.eye(3), x + 0.5, (y + 0.4, -0.4 * rise / y), (0, rise), 0.07, cover)
    for px in np.linspace(-x, x, 5)[1:-1]:
        rafters(kit, px, y, lift + high, rise, 0.06, frame, False)


def platform(kit):
    rng = kit.rng
    steel, cover, wood, dark, sign = steelwork(kit), tiles(kit), timberwork(kit), kit.material(dark=True), lettered(kit)
    y, x, high = rng.uniform(4.5, 6.5), rng.uniform(1.3, 1.7), rng.uniform(2.6, 3.1)
    slab(kit, 0, 0, 0, (x, y, 0.4), paving(kit))
    for way in (-1, 1) if kit.chance(0.5) else (1,):
        kit.add(BOX, (way * (x - 0.25), 0, 0.81), (0.06, y, 0.012), material=tinted(kit, (WHITE, YELLOW)))
        slab(kit, way * (x + 1.0), 0, 0, (0.9, y, 0.06), tinted(kit, (GREY, STONE), (SPECKLES,), frequency=40))
        kit.add(BOX, (way * (x + 1.0), 0, 0.14), (0.75, y, 0.05), material=wood, cut=(RUNGS, 1.6, 0.4))
        for side in (-0.45, 0.45):
            kit.add(BOX, (way * (x + 1.0) + side, 0, 0.22), (0.04, y, 0.06), material=tinted(kit, (GREY, TIMBER), gloss=0.4))
    z, kind = 0.8 + high, rng.choice(["butterfly", "gable", "flat", "lean"])
    for py in np.linspace(-y * 0.75, y * 0.75, int(rng.integers(3, 5))):
        if kind == "lean":
            posts(kit, (-x * 0.8,), (py,), 0.8, z, 0.09, steel)
            kit.between((-x * 0.8, py, z - 0.9), (x * 0.5, py, z - 0.05), 0.05, BOX, material=steel)
        else:
            posts(kit, (0,), (py,), 0.8, z, 0.1, steel, CYL)
            for side in (-1, 1):
                kit.between((0, py, z - 0.8), (side * x * 0.75, py, z + (0.2 if kind == "butterfly" else -0.05)), 0.05, BOX, material=steel)
    if kind == "flat":
        kit.add(BOX, (0, 0, z + 0.05), (x * 1.1, y * 0.9, 0.1), material=cover)
    elif kind == "lean":
        kit.add(BOX, (0.1, 0, z + 0.1), (x * 1.15, y * 0.9, 0.06), rotation=turn("y", -7), material=cover)
    else:
        up = 0.35 if kind == "butterfly" else -0.35
        for side in (-1, 1):
            kit.between((0, 0, z), (side * x * 1.1, 0, z + up), (0.05, y * 0.9), BOX, material=cover)
    for side in (-1, 1):
        kit.add(
            BOX, (side * x * 1.1, 0, z + (0.3 if kind == "butterfly" else -0.3 if kind == "gable" else 0.0)), (0.03, y * 0.9, 0.15), material=wood, cut=(BARS, 3, 0.6)
        ) if kind != "lean" else None
    for py in (-y * 0.45, y * 0.35):
        bench(kit, 0.35, py, 0.8, 0.7, wood)
    kit.add(BOX, (0, 0, z - 0.6), (0.06, 0.8, 0.2), material=sign)
    posts(kit, (0,), (-0.6, 0.6), z - 0.5, z, 0.025, steel)
    kit.add(CYL, (0, y * 0.55, z - 0.5), (0.3, 0.3, 0.1), rotation=ALONG_X, material=tinted(kit, (WHITE,)))
    kit.between((0, y * 0.55, z - 0.3), (0, y * 0.55, z), 0.025, material=steel)
    slab(kit, 0, -y * 0.9, 0.8, (0.3, 0.3, 0.8), vivid(kit))
    kit.add(CYL, (0, y * 0.85, 1.2), (0.2, 0.2, 0.4), material=dark)


def car_park(kit):
    rng = kit.rng
    concrete, dark, steel, accent = tinted(kit, (CONCRETE, GREY, WHITE, CREAM), (PLAIN, STREAKS, CLOUDY)), kit.material(dark=True), steelwork(kit), vivid(kit)
    x, y, storeys, high = rng.uniform(4, 5.5), rng.uniform(5.5, 7.5), int(rng.integers(3, 6)), 2.7
    slab(kit, 0, 0, 0, (x + 0.3, y + 0.3, 0.08), paving(kit))
    style = rng.choice(["parapet", "bars", "fins"])
    for k in range(1, storeys + 1):
        kit.add(BOX, (0, 0, high * k), (x, y, 0.14), material=concrete)
        for side in (-1, 1):
            for axis in (0, 1):
                spot, half = ((side * x, 0), (0.07, y)) if axis == 0 else ((0, side * y), (x, 0.07))
                if style == "parapet" or k == storeys:
                    slab(kit, *spot, high * k - 0.15, (*half, 0.55), concrete)
                else:
                    slab(kit, *spot, high * k, (*half, 0.5 if style == "bars" else high * 0.47), steel, cut=(BARS, 1.4, 0.35))
    posts(kit, (-x * 0.93, x * 0.93), np.linspace(-y * 0.93, y * 0.93, 4), 0, high * storeys, 0.2, concrete)
    slab(kit, -x * 0.3, 0, 0, (x * 0.5, y * 0.6, high * storeys / 2 - 0.1), dark)
    slab(kit, x - 0.8, y + 0.6, 0, (1.0, 0.9, high * (storeys + 1) / 2), accent)
    kit.add(BOX, (x + 0.22, y + 0.6, high * storeys * 0.5), (0.05, 0.5, high * storeys * 0.45), material=panes(kit))
    kit.add(BOX, (x + 0.25, y + 0.6, high * (storeys + 0.75)), (0.08, 0.6, 0.5), material=lettered(kit))
    kit.between((x * 0.2, -y * 0.7, high * (storeys - 1) + 0.1), (-x * 0.7, -y * 0.7, high * storeys), (0.1, 0.9), BOX, material=concrete)
    for k in range(6):
        slab(kit, x * 0.6, y * (0.3 * k - 0.75), high * storeys + 0.14, (0.9, 0.45, 0.33), vivid(kit, gloss=0.4), taper=(0.7, 0.85))
        if k < 2:
            slab(kit, x * 0.8, y * (0.5 * k - 0.4), 0.08, (0.9, 0.45, 0.4), vivid(kit, gloss=0.4), taper=(0.7, 0.85))


def toll_gate(kit):
    rng = kit.rng
    accent, steel, glass, white, cover = vivid(kit), steelwork(kit), panes(kit), tinted(kit, (WHITE, CREAM, GREY)), steelwork(kit)
    lanes, gap, high = int(rng.integers(2, 5)), 3.0, rng.uniform(3.6, 4.4)
    y = gap * lanes / 2
    slab(kit, 0, 0, 0, (3.0, y + 0.9, 0.05), tinted(kit, (GREY,), (CLOUDY,)))
    for k in range(lanes + 1):
        py = -y + gap * k
        slab(kit, 0, py, 0.05, (2.4, 0.5, 0.1), white)
        posts(kit, (-1.5, 1.5), (py,), 0.1, high, 0.1, steel, CYL)
        if k < lanes:
            slab(kit, 0, py, 0.2, (0.75, 0.42, 0.45), accent)
            slab(kit, 0, py, 1.1, (0.7, 0.38, 0.42), glass)
            slab(kit, 0, py, 1.95, (0.85, 0.5, 0.1), white)
            kit.add(BOX, (0.9, py + 0.1, 0.6), (0.13, 0.13, 0.5), material=tinted(kit, (YELLOW, RED)))
            bar = kit.material(base=(0.75, 0.74, 0.7), second=(0.55, 0.03, 0.03), pattern=BANDS, frequency=16)
            tip = (0.9, py + 2.4, 1.0) if kit.chance(0.6) else (0.9, py + 0.9, 3.2)
            kit.between((0.9, py + 0.1, 1.0), tip, 0.05, BOX, material=bar)
            kit.add(BOX, (1.75, py + gap / 2, high + 0.2), (0.06, 0.35, 0.3), material=tinted(kit, (GREEN, RED, BLUE)) if k % 2 else lettered(kit))
    kind = rng.choice(["flat", "wing", "gable"])
    if kind == "wing":
        for side in (-1, 1):
            kit.between((0, 0, high), (side * 2.2, 0, high + 0.7), (0.08, y + 0.8), BOX, material=cover)
        for k in range(lanes + 1):
            kit.between((-1.5, -y + gap * k, high - 0.05), (1.5, -y + gap * k, high - 0.05), 0.09, BOX, material=steel)
        posts(kit, (-1.5, 1.5), (-y, y), high - 0.1, high + 0.5, 0.1, steel)
    else:
        slab(kit, 0, 0, high, (1.75, y + 0.8, 0.35), accent if kind == "flat" else cover)
        kit.add(BOX, (1.74, 0, high + 0.9), (0.06, y * 0.5, 0.25), material=lettered(kit))
        if kind == "gable":
            roof(kit, (0, 0, high + 0.7), (1.7, y + 0.7), 1.0, "hip", 0.3, tiles(kit), white, 1)


def car_wash(kit):
    rng = kit.rng
    wall, accent, brush, white, steel = (
        tinted(kit, (WHITE, CREAM, BLUE, GREY), (PLAIN, RIBS), frequency=18),
        vivid(kit),
        vivid(kit, (STREAKS, STRIPES), frequency=30),
        tinted(kit, (WHITE,)),
        steelwork(kit),
    )
    x, y, high = rng.uniform(3, 4.2), rng.uniform(1.9, 2.3), rng.uniform(3.0, 3.5)
    slab(kit, 0, 0, 0, (x + 1, y + 0.4, 0.05), paving(kit))
    for side in (-1, 1):
        kit.add(BOX, (0, side * y, 0.5), (x, 0.1, 0.5), material=wall)
        kit.add(BOX, (0, side * y, high - 0.4), (x, 0.1, 0.4), material=wall)
        kit.add(BOX, (0, side * y, high / 2), (x, 0.08, high / 2), material=steel, cut=(BARS, 3.0 / x, 0.2))
        kit.add(BOX, (0, side * y, high / 2), (x, 0.03, high / 2), material=panes(kit)) if side < 0 else None
    slab(kit, 0, 0, high, (x + 0.1, y + 0.2, 0.3), accent)
    kit.add(BOX, (0, 0, high + 0.3), (x + 0.13, y + 0.23, 0.08), material=white)
    kit.add(BOX, (x + 0.15, 0, high + 0.95), (0.08, y * 0.8, 0.35), material=lettered(kit))
    for px in (x * 0.55, -x * 0.3):
        for side in (-1, 1):
            kit.add(CYL, (px, side * y * 0.68, 1.2), (0.4, 0.4, 0.85), material=brush)
            kit.between((px, side * y * 0.68, 0), (px, side * y * 0.68, high), 0.05, material=steel)
            kit.add(BOX, (px + 0.5, side * y * 0.85, high / 2), (0.1, 0.1, high / 2), material=steel)
        kit.add(CYL, (px + 0.5, 0, 2.45), (0.38, 0.38, y * 0.72), rotation=ALONG_Y, material=brush)
        kit.between((px + 0.5, -y * 0.9, 2.45), (px + 0.5, y * 0.9, 2.45), 0.05, material=steel)
        kit.add(BOX, (px + 0.5, 0, high - 0.15), (0.12, y * 0.9, 0.12), material=steel)
    for side in (-0.7, 0.7):
        kit.add(BOX, (0, side, 0.08), (x + 0.9, 0.06, 0.06), material=tinted(kit, (YELLOW,)))
    body = vivid(kit, gloss=0.5)
    kit.add(BOX, (0.4, 0, 0.62), (1.6, 0.68, 0.27), (0.96, 0.92), material=body)
    kit.add(BOX, (0.25, 0, 1.1), (1.0, 0.6, 0.23), (0.65, 0.85), material=panes(kit))
    for px in (-0.6, 1.4):
        kit.add(CYL, (px, 0.6, 0.35), (0.3, 0.3, 0.1), rotation=ALONG_Y, material=kit.material(dark=True), mirror=True)
    slab(kit, x + 0.6, y + 0.3, 0, (0.25, 0.2, 0.7), accent)
    slab(kit, -x * 0.3, y + 0.6, 0, (x * 0.5, 0.5, high * 0.45), wall)


def ski_lift(kit):
    rng = kit.rng
    steel, accent, wood, glass, dark, cover = steelwork(kit), vivid(kit), boards(kit), panes(kit), kit.material(dark=True), tiles(kit)
    high, r = rng.uniform(3.4, 4.2), rng.uniform(1.1, 1.4)
    slab(kit, 0, 0, 0, (3.4, 2.4, 0.08), tinted(kit, (SNOW, CONCRETE), (CLOUDY,)))
    posts(kit, (-1.0,), (0,), 0, high, 0.3, tinted(kit, (CONCRETE, GREY)))
    kit.add(BOX, (-0.2, 0, high + 0.35), (1.9, 0.5, 0.3), material=steel)
    kit.add(CYL, (-0.2, 0, high - 0.05), (r, r, 0.07), material=accent, cut=(SPOKES, 6, 0.25))
    kit.add(TUBE, (-0.2, 0, high - 0.05), (r, r, 0.1), material=dark)
    kit.add(CYL, (-0.2, 0, high), (0.15, 0.15, 0.2), material=dark)
    if kit.chance(0.6):
        kit.add(BOX, (-0.1, 0, high + 0.95), (2.4, r + 0.5, 0.35), (0.7, 0.6), material=accent)
        kit.add(BOX, (-0.1, 0, high + 0.55), (2.45, r + 0.55, 0.08), material=tinted(kit, (WHITE, GREY)))
    else:
        roof(kit, (-0.1, 0, high + 0.6), (2.2, r + 0.4), 0.9, "gable", 0.3, cover, wood)
        posts(kit, (-2.2, 2.0), (-r - 0.3, r + 0.3), 0, high + 0.6, 0.1, wood)
    mast = 5.5
    kit.between((mast, 0, 0), (mast, 0, high + 0.5), 0.2, CYL, 0.7, material=steel)
    kit.add(CYL, (mast, 0, 0.1), (0.45, 0.45, 0.1), material=dark)
    kit.add(BOX, (mast, 0, high + 0.45), (0.12, r + 0.35, 0.12), material=steel)
    ladder(kit, (mast + 0.22, 0, 0), (mast + 0.18, 0, high + 0.3), 0.18, dark)
    for side in (-1, 1):
        for k in range(3):
            kit.add(CYL, (mast - 0.35 + 0.35 * k, side * r, high + 0.2), (0.13, 0.13, 0.05), rotation=ALONG_Y, material=dark)
        kit.add(BOX, (mast, side * r, high + 0.35), (0.5, 0.04, 0.08), material=steel)
        kit.between((-0.2, side * r, high - 0.02), (mast + 1.2, side * r, high + 0.08), 0.03, material=dark)
        for px in (2.0, 3.9)[::-side]:
            px += 0.5 * side
            kit.chain([(px, side * r, high), (px, side * r, 1.9), (px - 0.25, side * r, 1.0)], 0.045, steel, joints=False)
            kit.add(BOX, (px + 0.05, side * r, 1.02), (0.26, 0.5, 0.05), material=accent)
            kit.add(BOX, (px - 0.22, side * r, 1.35), (0.05, 0.5, 0.28), material=accent)
            kit.add(BOX, (px + 0.3, side * r, 1.35), (0.03, 0.5, 0.03), material=steel)
    slab(kit, -2.4, -1.5, 0.08, (0.8, 0.7, 1.1), wood)
    slab(kit, -2.4, -1.5, 2.28, (0.95, 0.85, 0.08), cover)
    kit.add(BOX, (-1.6, -1.5, 1.5), (0.04, 0.5, 0.4), material=glass)
