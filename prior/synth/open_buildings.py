"""A maker of buildings with depth; it draws halls and roofs on posts: carports, bandstands, pergolas, barns, stables, hangars, boathouses, greenhouses, wells."""

import numpy as np

from .building_parts import barrel, bench, greens, paving, posts, rafters, slab, timberwork, vivid
from .dwellings import (
    BLUE,
    BRICK,
    CREAM,
    GREEN,
    GREY,
    OCHRE,
    RED,
    SAND,
    STONE,
    THATCH,
    TIMBER,
    WHITE,
    WOOD,
    YELLOW,
    boards,
    brickwork,
    door,
    leaf,
    leaves,
    lights,
    masonry,
    panes,
    roof,
    row,
    tiles,
    trim,
    walls_of,
)
from .huts import (
    beach_hut,
    beehives,
    bird_table,
    chalet,
    dovecote,
    garden_house,
    hen_house,
    igloo,
    kennel,
    log_cabin,
    play_house,
    stilt_house,
    tipi,
    tree_house,
    veranda_house,
    wigwam,
    yurt,
)
from .installations import steelwork, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, LEAVES, PRISM, RUNGS, TUBE
from .materials import BANDS, BRICKS, CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, STREAKS
from .stalls import carousel, food_stand, kiosk, market_stall, stage, stand, swing_boat
from .waysides import bus_shelter, car_park, car_wash, covered_bridge, filling_station, platform, ski_lift, toll_gate


def open_building(kit):
    """Carports, petrol stations, bus shelters, market stalls, food stands, kiosks, bandstands, pergolas, picnic shelters, open barns, stables, hangars with trusses,
    boathouses, veranda houses, chalets, stilt and tree houses, garden and play houses, beach huts, log cabins, yurts, tipis, igloos, wigwams, greenhouses, conservatories,
    roofed wells, covered bridges, platforms, stadium stands, stages, car parks, toll gates, car washes, ski lifts, carousels, swing boats, dovecotes, hives, kennels, hen
    houses, bird tables."""
    kinds = [carport, filling_station, bus_shelter, market_stall, food_stand, kiosk, bandstand, pergola, picnic_shelter, open_barn, stable, hangar, shipping_shed, boathouse]
    kinds += [veranda_house, chalet, stilt_house, tree_house, garden_house, play_house, beach_hut, log_cabin, yurt, tipi, igloo, wigwam, greenhouse, conservatory, roofed_well]
    kinds += [covered_bridge, platform, stand, stage, car_park, toll_gate, car_wash, ski_lift, carousel, swing_boat, dovecote, beehives, kennel, hen_house, bird_table]
    kinds[kit.rng.integers(len(kinds))](kit)


def carport(kit):
    rng = kit.rng
    frame, cover, body, dark = timberwork(kit) if kit.chance(0.6) else steelwork(kit), tiles(kit), vivid(kit, gloss=0.5), kit.material(dark=True)
    x, y, high = rng.uniform(2.5, 3.1), rng.choice([1.5, 2.8]), rng.uniform(2.2, 2.6)
    slab(kit, 0, 0, 0, (x + 0.2, y + 0.2, 0.05), paving(kit))
    posts(kit, np.linspace(-x, x, 3), (-y, y), 0, high, 0.08, frame)
    for side in (-y, y):
        kit.add(BOX, (0, side, high), (x + 0.3, 0.08, 0.12), material=frame)
    kind = rng.choice(["flat", "gable", "lean", "hip"])
    if kind == "flat":
        kit.add(BOX, (0, 0, high + 0.17), (x + 0.4, y + 0.4, 0.08), material=cover)
    elif kind == "gable":
        rise = y * rng.uniform(0.4, 0.8)
        leaves(kit, (0, 0, high), np.eye(3), x + 0.4, (y + 0.4, -0.4 * rise / y), (0, rise), 0.06, cover)
        for px in (-x, x):
            rafters(kit, px, y, high, rise, 0.06, frame)
    elif kind == "hip":
        roof(kit, (0, 0, high), (x, y), y * 0.5, "hip", 0.4, cover, frame)
    else:
        kit.add(BOX, (0, 0, high + 0.2), (x + 0.4, y + 0.4, 0.06), rotation=turn("x", 4), material=cover)
    if kit.chance(0.5):
        slab(kit, -x + 0.6, 0, 0, (0.6, y, high / 2), boards(kit))
    if kit.chance(0.4):
        kit.add(BOX, (0, -y, high / 2), (x, 0.03, high / 2), material=frame, cut=(RUNGS, 5, 0.55))
    spot = 0.3, (0 if y < 2 else y / 2)
    kit.add(BOX, (*spot, 0.6), (1.9, 0.8, 0.28), (0.96, 0.92), material=body)
    kit.add(BOX, (spot[0] - 0.2, spot[1], 1.1), (1.15, 0.72, 0.25), (0.68, 0.85), material=panes(kit))
    kit.add(BOX, (spot[0] - 0.2, spot[1], 1.36), (0.78, 0.62, 0.03), material=body)
    for px in (-1.15, 1.2):
        for side in (-0.72, 0.72):
            kit.add(CYL, (spot[0] + px, spot[1] + side, 0.37), (0.32, 0.32, 0.1), rotation=ALONG_Y, material=dark)
        kit.add(BOX, (spot[0] + np.sign(px) * 1.87, spot[1], 0.68), (0.06, 0.7, 0.07), material=vivid(kit) if px < 0 else tinted(kit, (WHITE,)))


def bandstand(kit):
    rng = kit.rng
    frame, cover, base = tinted(kit, (WHITE, WHITE, GREEN, WOOD, BLUE, RED)), tiles(kit), masonry(kit)
    sides, r, lift, high = int(rng.choice([6, 8, 8])), rng.uniform(1.6, 2.8), rng.choice([0.15, 0.5, 1.0]), rng.uniform(2.4, 3.0)
    kit.add(PRISM, (0, 0, lift / 2), (r + 0.15, r + 0.15, lift / 2), (1, sides), material=base)
    points = around(sides, r * 0.93)
    for k, (px, py) in enumerate(points):
        kit.add(CYL, (px, py, lift + high / 2), (0.08, 0.08, high / 2), material=frame)
        nx, ny = points[(k + 1) % sides]
        kit.between((px, py, lift + high - 0.1), (nx, ny, lift + high - 0.1), (0.12, 0.05), BOX, material=frame)
        if k:
            kit.railing((px, py, lift), (nx, ny, lift), 0.9, frame, r / 10, LATTICE if sides == 6 else BARS, 0.03)
    for k in range(3 if lift > 0.2 else 1):
        spin = turn("z", 180 / sides)
        run = 0.28 * (3 - k) / 2
        kit.add(BOX, spin @ np.array([r * 0.95 + run, 0, lift * (k + 1) / 6]), (run + 0.1, r * 0.28, lift * (k + 1) / 6), rotation=spin, material=base)
    kind = rng.choice(["cone", "tiers", "dome", "bell"])
    eave = lift + high
    if kind == "dome":
        kit.add(PRISM, (0, 0, eave + 0.1), (r + 0.3, r + 0.3, 0.12), (0.94, sides), material=frame)
        kit.add(BALL, (0, 0, eave + 0.15), (r * 0.95, r * 0.95, r * 0.7), material=cover)
        top = eave + 0.1 + r * 0.7
    elif kind == "tiers":
        kit.add(PRISM, (0, 0, eave + r * 0.22), (r + 0.4, r + 0.4, r * 0.22), (0.42, sides), material=cover)
        kit.add(PRISM, (0, 0, eave + r * 0.5), (r * 0.38, r * 0.38, r * 0.14), (1, sides), material=frame)
        kit.add(PRISM, (0, 0, eave + r * 0.8), (r * 0.6, r * 0.6, r * 0.2), (0.03, sides), material=cover)
        top = eave + r * 0.97
    elif kind == "bell":
        kit.add(PRISM, (0, 0, eave + r * 0.15), (r + 0.4, r + 0.4, r * 0.15), (0.6, sides), material=cover)
        kit.add(PRISM, (0, 0, eave + r * 0.6), (r * 0.66, r * 0.66, r * 0.32), (0.03, sides), material=cover)
        top = eave + r * 0.9
    else:
        kit.add(PRISM, (0, 0, eave + r * 0.3), (r + 0.4, r + 0.4, r * rng.uniform(0.25, 0.4)), (0.02, sides), material=cover)
        top = eave + r * 0.52
    kit.loft((0, 0, top), [(0, 0.07), (0.25, 0.05), (0.3, 0.13), (0.42, 0.13), (0.8, 0.01)], frame)
    bench(kit, -r * 0.4, 0, lift, r * 0.4, frame)


def pergola(kit):
    rng = kit.rng
    wood = timberwork(kit)
    x, y, high, count = rng.uniform(1.2, 2), rng.uniform(1.5, 3), rng.uniform(2.3, 2.7), int(rng.integers(7, 12))
    slab(kit, 0, 0, 0, (x + 0.2, y + 0.2, 0.05), paving(kit))
    kind = CYL if kit.chance(0.3) else BOX
    posts(kit, (-x, x), np.linspace(-y, y, 2 if y < 2 else 3), 0, high, 0.1, wood if kind == BOX else masonry(kit), kind)
    for px in (-x, x):
        kit.add(BOX, (px, 0, high + 0.08), (0.07, y + 0.4, 0.12), material=wood)
        for py in (-y, y):
            kit.between((px, py, high - 0.5), (px, py - np.sign(py) * 0.45, high), 0.05, BOX, material=wood)
    for py in np.linspace(-y - 0.2, y + 0.2, count):
        kit.add(BOX, (0, py, high + 0.28), (x + 0.45, 0.045, 0.1), material=wood)
    green = greens(kit)
    for _ in range(int(rng.integers(0, 8))):
        kit.add(BALL, (rng.choice([-x, 0, x]), rng.uniform(-y, y), high + 0.3), rng.uniform(0.3, 0.75, 3) * [1, 1, 0.6], material=green, cut=(LEAVES, 8, 0.6))
    for py in (-y, y)[: int(rng.integers(0, 3))]:
        kit.add(BOX, (0, py, high / 2), (x, 0.03, high / 2), material=wood, cut=(LATTICE, 4, 0.2))
    if kit.chance(0.5):
        slab(kit, 0, 0, 0.72, (0.45, 0.9, 0.04), wood)
        slab(kit, 0, 0, 0, (0.1, 0.6, 0.37), wood)
        for px in (-0.8, 0.8):
            bench(kit, px, 0, 0.03, 0.8, wood, 0)


def picnic_shelter(kit):
    rng = kit.rng
    wood, cover, base = timberwork(kit), tiles(kit), masonry(kit)
    x, y, high = rng.uniform(1.8, 3), rng.uniform(1.6, 2.2), rng.uniform(2.2, 2.5)
    slab(kit, 0, 0, 0, (x + 0.3, y + 0.3, 0.07), paving(kit))
    posts(kit, np.linspace(-x, x, 3), (-y, y), 0, high, 0.1, wood)
    if kit.chance(0.4):
        posts(kit, np.linspace(-x, x, 3), (-y, y), 0, 0.8, 0.25, base)
    for side in (-y, y):
        kit.add(BOX, (0, side, high), (x + 0.3, 0.09, 0.12), material=wood)
    if kit.chance(0.7):
        rise = y * rng.uniform(0.5, 0.9)
        leaves(kit, (0, 0, high + 0.08), np.eye(3), x + 0.6, (y + 0.55, -0.55 * rise / y), (0, rise), 0.06, cover)
        for px in (-x, 0, x):
            rafters(kit, px, y, high, rise, 0.07, wood)
    else:
        roof(kit, (0, 0, high), (x, y), y * 0.7, "hip", 0.5, cover, wood)
    for px in (-x * 0.5, x * 0.5):
        slab(kit, px, 0, 0.74, (0.4, 1.0, 0.04), wood)
        for side in (-0.7, 0.7):
            slab(kit, px + side, 0, 0.42, (0.14, 1.0, 0.03), wood)
            kit.between((px - 0.7, side, 0.1), (px + 0.35, side, 0.75), 0.05, BOX, material=wood)
            kit.between((px + 0.7, side, 0.1), (px - 0.35, side, 0.75), 0.05, BOX, material=wood)
    if kit.chance(0.4):
        slab(kit, -x - 0.1, 0, 0, (0.35, 0.6, 1.0), base)
        slab(kit, -x - 0.1, 0, 2.0, (0.22, 0.3, 1.0), base)


def bay_hall(kit, x, y, eave, rise, wall, cover, frame, front, ends=True, bays=3):
    """A gabled hall along y whose side at +x is open between posts (`front`) and whose other sides are walls."""
    kit.add(BOX, (-x, 0, eave / 2), (0.07, y, eave / 2), material=wall)
    kit.add(BOX, (0, y, eave / 2), (x, 0.07, eave / 2), material=wall, mirror=True)
    for side in (-1, 1) if ends else ():
        kit.add(BOX, (0, side * y, eave + rise / 2), (x, 0.07, rise / 2), (0.02, 1), material=wall)
    leaves(kit, (0, 0, eave), turn("z", 90), y + 0.3, (x + 0.4, -0.4 * rise / x), (0, rise), 0.07, cover)
    if front:
        posts(kit, (x,), np.linspace(-y, y, bays + 1), 0, eave, 0.1, frame)
        kit.add(BOX, (x, 0, eave - 0.12), (0.09, y, 0.14), material=frame)
    for py in np.linspace(-y, y, bays + 1)[1:-1]:
        kit.between((-x, py, eave), (x, py, eave), 0.07, BOX, material=frame)


def open_barn(kit):
    rng = kit.rng
    wall, cover, frame = tinted(kit, (RED, RED, WOOD, GREY, TIMBER), (PLANKS, RIBS), frequency=rng.uniform(8, 20)), tiles(kit), timberwork(kit)
    x, y, eave, bays = rng.uniform(2.5, 3.5), rng.uniform(4, 6), rng.uniform(2.8, 3.8), int(rng.integers(3, 5))
    slab(kit, 0, 0, 0, (x, y, 0.04), tinted(kit, (SAND, OCHRE), (CLOUDY,)))
    bay_hall(kit, x, y, eave, x * rng.uniform(0.5, 0.9), wall, cover, frame, True, bays=bays)
    hay = tinted(kit, (OCHRE, THATCH, (0.5, 0.4, 0.12)), (STREAKS, CLOUDY), frequency=25, gloss=0.0)
    middle = row(bays, y, 1)
    first, round_ = int(rng.integers(bays)), kit.chance(0.5)
    for k in range(4):
        for level in range(3 if k < 2 else 2):
            spot = (-x * 0.55 + 1.15 * (k % 2), middle[first] + (0.6 if k > 1 else -0.6), 0.04 + 0.5 + level * 0.95)
            if round_:
                kit.add(CYL, spot, (0.5, 0.5, 0.55), rotation=ALONG_X, material=hay)
            else:
                kit.add(BOX, spot, (0.52, 0.56, 0.47), material=hay)
    kit.between((x + 0.1, middle[first - 1] - 0.2, 0), (x * 0.9, middle[first - 1] - 0.2, eave), (0.03, 0.25), BOX, material=frame, cut=(RUNGS, 4, 0.3))
    other, red, dark = middle[(first + 1) % bays], vivid(kit), kit.material(dark=True)
    kit.add(BOX, (0.4, other, 0.85), (0.9, 0.25, 0.3), material=red)
    kit.add(BOX, (-0.45, other, 1.5), (0.4, 0.45, 0.5), (0.85, 0.9), material=panes(kit))
    kit.add(BOX, (-0.45, other, 2.02), (0.45, 0.5, 0.05), material=red)
    for side in (-0.55, 0.55):
        kit.add(CYL, (-0.5, other + side, 0.65), (0.62, 0.62, 0.15), rotation=ALONG_Y, material=dark)
        kit.add(CYL, (1.0, other + side * 0.8, 0.42), (0.4, 0.4, 0.1), rotation=ALONG_Y, material=dark)


def stable(kit):
    rng = kit.rng
    wall, cover, frame, leafs, hide = boards(kit), tiles(kit), timberwork(kit), leaf(kit), tinted(kit, (WOOD, TIMBER, CREAM, (0.2, 0.08, 0.03)))
    x, boxes, eave = rng.uniform(1.6, 2.1), int(rng.integers(2, 5)), rng.uniform(2.4, 2.7)
    y = boxes * rng.uniform(1.4, 1.7)
    bay_hall(kit, x, y, eave, x * rng.uniform(0.4, 0.7), wall, cover, frame, False, bays=1)
    for k, py in enumerate(row(boxes, y, 1)):
        for side in (-1, 1):
            kit.add(BOX, (x, py + side * (y / boxes + 0.6) / 2, eave / 2), (0.07, (y / boxes - 0.6) / 2, eave / 2), material=wall)
        kit.add(BOX, (x, py, eave - 0.15), (0.08, 0.62, 0.17), material=wall)
        kit.add(BOX, (x + 0.03, py, 0.6), (0.07, 0.6, 0.58), material=leafs)
        kit.add(BOX, (x + 0.12, py, 0.6), (0.02, 0.5, 0.5), material=frame, cut=(LATTICE, 1.1, 0.12))
        kit.add(BOX, (x + 0.14, py + 1.12, 1.75), (0.04, 0.52, 0.52), material=leafs)
        if k < 2 and kit.chance(0.7):
            kit.between((x - 0.3, py, 1.2), (x + 0.35, py, 1.75), 0.17, CYL, 0.75, material=hide)
            kit.between((x + 0.25, py, 1.85), (x + 0.62, py, 1.45), 0.14, CYL, 0.65, material=hide)
            kit.add(BOX, (x + 0.25, py + 0.07, 2.0), (0.04, 0.03, 0.09), (0.3, 0.3), material=hide)
            kit.add(BOX, (x + 0.25, py - 0.07, 2.0), (0.04, 0.03, 0.09), (0.3, 0.3), material=hide)
    kit.add(BOX, (x + 0.7, 0, eave - 0.18), (0.75, y + 0.3, 0.05), rotation=turn("y", 10), material=cover)
    posts(kit, (x + 1.3,), np.linspace(-y, y, boxes + 1), 0, eave - 0.3, 0.07, frame)
    slab(kit, 0.5, 0, 0, (x + 1.0, y + 0.1, 0.04), paving(kit))
    lights(kit, (0, 0, 1.7), (x, y), [0], (0.35, 0.25), panes(kit), frame, 1)


def hangar(kit):
    rng = kit.rng
    skin, frame, wall, accent = tinted(kit, (GREY, WHITE, GREEN, SAND, BLUE), (RIBS, SEAMS, PLAIN), frequency=rng.uniform(8, 30)), steelwork(kit), steelwork(kit), vivid(kit)
    long, wide, eave = rng.uniform(3, 5), rng.uniform(3, 4), rng.choice([0.0, 1.4])
    slab(kit, 0.4, 0, 0, (long + 0.6, wide + 0.2, 0.03), paving(kit))
    gable = kit.chance(0.4)
    rise = wide * (rng.uniform(0.3, 0.5) if gable else rng.uniform(0.65, 1))
    if gable:
        eave = rng.uniform(2, 3)
        leaves(kit, (0, 0, eave), np.eye(3), long + 0.1, (wide + 0.2, -0.2 * rise / wide), (0, rise), 0.05, skin)
        for x in (-long * 0.4, long * 0.3, long * 0.95):
            rafters(kit, x, wide, eave, rise, 0.05, frame)
            kit.between((x, wide * 0.5, eave), (x, wide * 0.5, eave + rise * 0.5), 0.04, BOX, material=frame, mirror=True)
        kit.add(BOX, (-long, 0, eave + rise / 2), (0.05, wide, rise / 2), (1, 0.02), material=wall)
    else:
        barrel(kit, 0, eave, long, wide, rise, 10, skin, 0.05)
        for x in (-long * 0.2, long * 0.96):
            barrel(kit, x, eave, 0.07, wide * 0.95, rise * 0.95, 8, frame, 0.06)
        for k in range(5):
            z0, z1 = k / 5, (k + 1) / 5
            y0, y1 = wide * np.sqrt(1 - z0**2), wide * np.sqrt(1 - min(z1, 0.985) ** 2)
            kit.add(BOX, (-long + 0.05, 0, eave + rise * (z0 + z1) / 2), (0.05, y0 * 0.99, rise * 0.1), (1, y1 / y0), material=wall)
    if eave:
        kit.add(BOX, (0, wide, eave / 2), (long, 0.06, eave / 2), material=skin, mirror=True)
        kit.add(BOX, (-long, 0, eave / 2), (0.05, wide, eave / 2), material=wall)
    tall = eave * 0.95 if gable else eave + rise * 0.35
    kit.add(BOX, (long + 0.1, wide * 1.15, tall / 2), (0.04, wide * 0.3, tall / 2), material=accent, mirror=True)
    body, nose, z = tinted(kit, (WHITE, RED, YELLOW, BLUE)), kit.material(dark=True), 0.95
    kit.loft((-long * 0.55, 0, z + 0.1), [(0, 0.1), (1.6, 0.35), (2.9, 0.35), (3.1, 0.22)], body, axis=ALONG_X)
    kit.add(BOX, (-long * 0.55 + 2.2, 0, z + 0.5), (0.35, wide * 0.72, 0.05), material=body)
    kit.add(BOX, (-long * 0.55 + 2.0, 0, z + 0.42), (0.5, 0.28, 0.18), (0.6, 0.85), material=panes(kit))
    kit.add(BOX, (-long * 0.55 + 0.15, 0, z + 0.5), (0.25, 0.04, 0.4), (0.6, 1), (-0.15, 0), material=body)
    kit.add(BOX, (-long * 0.55 + 0.15, 0, z + 0.15), (0.22, 0.8, 0.03), material=body)
    kit.add(BOX, (-long * 0.55 + 3.15, 0, z + 0.1), (0.03, 0.07, 0.6), material=nose)
    for x, y in ((2.1, 0.5), (2.1, -0.5), (2.85, 0)):
        kit.between((-long * 0.55 + x, y * 0.4, z - 0.1), (-long * 0.55 + x, y, 0.2), 0.05, material=body)
        kit.add(CYL, (-long * 0.55 + x, y, 0.2), (0.18, 0.18, 0.07), rotation=ALONG_Y, material=nose)


def shipping_shed(kit):
    rng = kit.rng
    cover, frame, wall = (
        tinted(kit, (GREY, BLUE, GREEN, WHITE), (RIBS,), frequency=rng.uniform(10, 30)),
        steelwork(kit),
        tinted(kit, (GREY, BLUE, CREAM, GREEN), (RIBS,), frequency=20),
    )
    x, y, high, bays = rng.uniform(2.6, 3.4), rng.uniform(4, 6), rng.uniform(3.2, 4.4), int(rng.integers(3, 5))
    slab(kit, 0, 0, 0, (x + 1.0, y + 0.4, 0.15), paving(kit))
    rise = x * rng.uniform(0.25, 0.5)
    leaves(kit, (0, 0, high), turn("z", 90), y + 0.3, (x + 0.8, -0.8 * rise / x), (0, rise), 0.05, cover)
    posts(kit, (-x, x), np.linspace(-y, y, bays + 1), 0.15, high, 0.1, frame)
    for py in np.linspace(-y, y, bays + 1):
        kit.between((-x, py, high), (x, py, high), 0.07, BOX, material=frame)
        kit.between((0, py, high), (0, py, high + rise), 0.05, BOX, material=frame)
        kit.between((-x * 0.5, py, high), (0, py, high + rise), 0.04, BOX, material=frame)
        kit.between((x * 0.5, py, high), (0, py, high + rise), 0.04, BOX, material=frame)
    kit.add(BOX, (-x, 0, high * 0.75), (0.04, y, high * 0.25), material=wall)
    for side in (-1, 1)[: int(rng.integers(1, 3))]:
        kit.add(BOX, (0, side * y, high / 2), (x, 0.04, high / 2), material=wall)
    for k in range(int(rng.integers(4, 8))):
        kind = rng.choice(["crate", "container", "drum"])
        spot = (rng.uniform(-0.5, 0.6) * x, y * (0.24 * k - 0.75))
        if kind == "container":
            slab(kit, *spot, 0.15, (1.2, 0.5, 0.55), vivid(kit, (RIBS,), frequency=25))
        elif kind == "drum":
            kit.add(CYL, (*spot, 0.6), (0.35, 0.35, 0.45), material=vivid(kit, (BANDS, PLAIN)))
        else:
            slab(kit, *spot, 0.15, (0.55, 0.45, rng.uniform(0.3, 0.6)), tinted(kit, (WOOD, OCHRE), (PLANKS,), frequency=20))


def boathouse(kit):
    rng = kit.rng
    wall, cover, frame, hull = boards(kit), tiles(kit), timberwork(kit), vivid(kit)
    x, y, eave = rng.uniform(2.6, 3.4), rng.uniform(1.6, 2.3), rng.uniform(2.3, 2.8)
    rise, lift = y * rng.uniform(0.6, 1), rng.uniform(0.5, 0.9)
    posts(kit, (-x, 0, x), (-y * 0.95, y * 0.95), 0, lift, 0.11, frame, CYL)
    for side in (-1, 1):
        kit.add(BOX, (0, side * y * 0.78, lift), (x + 0.1, y * 0.26, 0.07), material=frame)
    kit.add(BOX, (-x * 0.75, 0, lift), (x * 0.25, y, 0.07), material=frame)
    kit.add(BOX, (0, y, lift + eave / 2), (x, 0.06, eave / 2), material=wall, mirror=True)
    kit.add(BOX, (-x, 0, lift + eave / 2), (0.06, y, eave / 2), material=wall)
    for end in (-1, 1):
        kit.add(BOX, (end * x, 0, lift + eave + rise / 2), (0.06, y, rise / 2), (1, 0.02), material=wall)
    leaves(kit, (0, 0, lift + eave), np.eye(3), x + 0.35, (y + 0.3, -0.3 * rise / y), (0, rise), 0.06, cover)
    kit.add(BOX, (x, y * 0.88, lift + eave / 2), (0.07, y * 0.12, eave / 2), material=wall, mirror=True)
    for side in (-1, 1):
        kit.add(BOX, (x + y * 0.42, side * y * 1.06, lift + eave * 0.48), (y * 0.42, 0.04, eave * 0.45), material=leaf(kit))
    kit.add(BOX, (x * 0.4, 0, 0.42), (x * 0.8, 0.4, 0.28), (1.1, 1.5), material=hull)
    kit.add(BOX, (x * 1.4, 0, 0.45), (0.5, 0.5, 0.28), (1.5, 0.1), (0.25, 0), material=hull, rotation=np.eye(3))
    kit.add(BOX, (x * 0.4, 0, 0.71), (x * 0.84, 0.5, 0.03), material=frame)
    kit.add(BOX, (x * 0.2, 0, 0.95), (0.5, 0.42, 0.25), (0.7, 0.8), material=panes(kit))
    kit.add(BOX, (x * 0.4, 0, 0.07), (x * 1.0, 0.06, 0.1), material=frame)
    lights(kit, (0, 0, lift + eave * 0.6), (x, y), row(3, x), (0.3, 0.3), panes(kit), trim(kit), 1)
    kit.add(BOX, (x + 0.05, 0, lift + eave + rise * 0.4), (0.05, 0.25, 0.25), material=panes(kit))
    kit.add(BOX, (x + 1.1, -y * 1.35, lift), (1.6, 0.4, 0.06), material=frame)
    posts(kit, (x - 0.2, x + 2.5), (-y * 1.35 - 0.3, -y * 1.35 + 0.3), 0, lift + 0.3, 0.09, frame, CYL)
    kit.add(BOX, (-x * 0.2, -y * 1.1, lift), (x * 0.9, 0.3, 0.06), material=frame)
    posts(kit, (-x,), (-y * 1.25,), 0, lift, 0.09, frame, CYL)


def greenhouse(kit):
    rng = kit.rng
    glass, frame, base = (
        tinted(kit, ((0.3, 0.4, 0.38), (0.2, 0.28, 0.3), (0.45, 0.52, 0.5)), (PLAIN, CLOUDY), gloss=0.6),
        tinted(kit, (WHITE, GREEN, GREY, TIMBER)),
        brickwork(kit),
    )
    x, y, eave, low = rng.uniform(1.8, 3.4), rng.uniform(1.2, 1.7), rng.uniform(1.5, 1.9), rng.choice([0.1, 0.6])
    rise, pitch = y * rng.uniform(0.6, 0.9), rng.uniform(1.4, 2.2)
    open_end = 0.45
    slab(kit, 0, 0, 0, (x + 0.05, y + 0.05, low / 2), base)
    house = kit.chance(0.5)
    for side in (-1, 1):
        if house:
            kit.add(BOX, (0, side * y, (low + eave) / 2), (x, 0.015, (eave - low) / 2), material=glass)
        kit.add(BOX, (0, side * y, (low + eave) / 2), (x, 0.04, (eave - low) / 2), material=frame, cut=(BARS, pitch, 0.12))
    if house:
        leaves(kit, (0, 0, eave), np.eye(3), x, (y, 0), (0, rise), 0.015, glass)
    slope, run = np.degrees(np.arctan2(rise, y)), np.hypot(rise, y) / 2
    for side in (-1, 1):
        kit.add(BOX, (0, side * y / 2, eave + rise / 2), (x, run, 0.04), rotation=turn("x", -side * slope), material=frame, cut=(GRID, pitch, 0.1))
    for end in (-x, x):
        kit.add(BOX, (end, 0, eave + rise / 2), (0.02, y, rise / 2), (1, 0.02), material=glass)
        kit.between((end, y, eave), (end, 0, eave + rise), 0.05, BOX, material=frame, mirror=True)
        kit.between((end, -y, eave), (end, y, eave), 0.05, BOX, material=frame)
        posts(kit, (end,), (-y, y, -open_end, open_end), low, eave, 0.05, frame)
        kit.add(BOX, (end, (y + open_end) / 2, (low + eave) / 2), (0.02, (y - open_end) / 2, (eave - low) / 2), material=glass, mirror=True)
    kit.add(BOX, (-x, 0, (low + eave) / 2), (0.02, open_end, (eave - low) / 2), material=glass)
    kit.add(BOX, (0, 0, eave + rise + 0.04), (x + 0.05, 0.07, 0.06), material=frame)
    if kit.chance(0.5):
        kit.add(BOX, (x + 0.25, open_end + 0.1, (low + eave) / 2), (0.35, 0.025, (eave - low) / 2), material=frame, cut=(GRID, 1.6, 0.15))
    for side in (-1, 1):
        slab(kit, 0, side * y * 0.65, low, (x * 0.92, y * 0.28, 0.25), timberwork(kit))
        for px in row(5, x):
            kit.add(BALL, (px, side * y * 0.65, low + 0.7), (x * 0.13, y * 0.22, rng.uniform(0.25, 0.4)), material=greens(kit), cut=(LEAVES, 10, 0.7))


def conservatory(kit):
    rng = kit.rng
    wall, cover, frame, base, glass = (
        walls_of(kit),
        tiles(kit),
        tinted(kit, (WHITE, WHITE, GREEN, TIMBER)),
        brickwork(kit),
        tinted(kit, ((0.25, 0.33, 0.36), (0.15, 0.2, 0.22)), gloss=0.6),
    )
    x, y, high = rng.uniform(1.6, 2.2), rng.uniform(2.2, 3.2), rng.uniform(3, 5)
    slab(kit, -x, 0, 0, (x, y + 0.6, high / 2), wall)
    roof(kit, (-x, 0, high), (x, y + 0.6), x * 0.8, "gable", 0.3, cover, wall, 1)
    r, eave, low = y * rng.uniform(0.7, 0.85), 2.2, 0.6
    deep = rng.uniform(0.8, 1.8)
    kit.add(BOX, (deep / 2, 0, low / 2), (deep / 2, r, low / 2), material=base)
    kit.add(PRISM, (deep, 0, low / 2), (r, r, low / 2), (1, 8), rotation=turn("z", 22.5), material=base)
    kit.add(BOX, (deep / 2, 0, (low + eave) / 2), (deep / 2, r * 0.9, (eave - low) / 2), material=glass)
    kit.add(PRISM, (deep, 0, (low + eave) / 2), (r * 0.95, r * 0.95, (eave - low) / 2), (1, 8), rotation=turn("z", 22.5), material=glass)
    spots = [(deep + px, py) for px, py in around(8, r, 22.5) if px > -0.1 * r]
    for px, py in spots:
        kit.add(BOX, (px, py, (low + eave) / 2), (0.07, 0.07, (eave - low) / 2), material=frame)
        kit.between((px * 0.98, py, eave + 0.1), (deep, 0, eave + 1.15), 0.04, BOX, material=frame)
    for (ax, ay), (bx, by) in zip(spots[:-1] if len(spots) < 5 else spots, spots[1:] + spots[:1], strict=False):
        kit.between((ax, ay, 1.7), (bx, by, 1.7), 0.035, BOX, material=frame)
        kit.between(((ax + bx) / 2, (ay + by) / 2, low), ((ax + bx) / 2, (ay + by) / 2, eave), 0.035, BOX, material=frame)
    kit.add(PRISM, (deep, 0, eave + 0.05), (r * 1.06, r * 1.06, 0.07), (1, 8), rotation=turn("z", 22.5), material=frame)
    kit.add(PRISM, (deep, 0, eave + 0.62), (r * 1.0, r * 1.0, 0.55), (0.05, 8), rotation=turn("z", 22.5), material=glass)
    kit.add(BOX, (deep / 2, 0, eave + 0.05), (deep / 2, r, 0.07), material=frame)
    kit.add(BOX, (deep / 2, 0, eave + 0.62), (deep / 2, r * 0.95, 0.55), (1, 0.05), material=glass)
    for px in np.linspace(0, deep, 3):
        kit.add(BOX, (px, r * 0.92, (low + eave) / 2), (0.05, 0.06, (eave - low) / 2), material=frame, mirror=True)
    kit.loft((deep, 0, eave + 1.15), [(0, 0.08), (0.15, 0.1), (0.4, 0.01)], frame)
    lights(kit, (-x, 0, high * 0.72 if high > 4 else 1.7), (x, y + 0.6), (-0.6, 0.6) if high > 4 else (), (0.4, 0.5), glass, frame, 1)
    if high > 4:
        lights(kit, (-x, 0, high * 0.78), (x, y + 0.6), (-y * 0.5, y * 0.5), (0.4, 0.5), glass, frame, 0)
    door(kit, (-2 * x, y * 0.3, 0), (0.45, 1.0), leaf(kit), frame)


def roofed_well(kit):
    rng = kit.rng
    stone, wood, cover, dark = tinted(kit, (STONE, GREY, BRICK, SAND), (BRICKS,), frequency=rng.uniform(8, 16)), timberwork(kit), tiles(kit), kit.material(dark=True)
    r, high, top = rng.uniform(0.55, 0.75), rng.uniform(0.65, 0.85), rng.uniform(1.9, 2.2)
    kit.add(CYL, (0, 0, 0.04), (r * 1.4, r * 1.4, 0.04), material=paving(kit))
    kit.add(TUBE, (0, 0, high / 2), (r, r, high / 2), material=stone)
    kit.add(TUBE, (0, 0, high / 2), (r * 0.75, r * 0.75, high / 2), material=stone)
    for px, py in around(12, r * 0.88):
        kit.add(BOX, (px, py, high), (r * 0.16, r * 0.25, 0.06), rotation=turn("z", np.degrees(np.arctan2(py, px))), material=stone)
    kit.add(CYL, (0, 0, high * 0.5), (r * 0.74, r * 0.74, 0.02), material=dark)
    posts(kit, (0,), (-r * 0.9, r * 0.9), 0, top, 0.06, wood)
    kit.between((0, -r, 1.35), (0, r, 1.35), 0.1, material=wood)
    kit.between((0, -r * 1.15, 1.35), (0, r * 1.2, 1.35), 0.03, material=dark)
    kit.between((0, r * 1.2, 1.35), (0.2, r * 1.2, 1.2), 0.025, material=dark)
    kit.between((0.2, r * 1.18, 1.2), (0.2, r * 1.45, 1.2), 0.03, material=wood)
    kit.between((0.08, 0, 1.35), (0.08, 0, 0.95), 0.02, material=wood)
    kit.add(CYL, (0.08, 0, 0.85), (0.13, 0.13, 0.14), (1.2, 1), material=wood)
    kind, spin = rng.choice(["gable", "pyramid", "cone"]), turn("z", 90)
    rise = rng.uniform(0.45, 0.75)
    for side in (-1, 1):
        kit.between((-r * 0.7, side * r * 0.9, top), (r * 0.7, side * r * 0.9, top), 0.05, BOX, material=wood)
        kit.between((0.4, side * r * 0.9, top), (0, side * r * 0.9, top - 0.4), 0.035, BOX, material=wood)
        kit.between((-0.4, side * r * 0.9, top), (0, side * r * 0.9, top - 0.4), 0.035, BOX, material=wood)
    if kind == "gable":
        leaves(kit, (0, 0, top), spin, r * 1.25, (r * 1.05, -0.08), (0, rise), 0.04, cover)
        for side in (-1, 1):
            kit.add(BOX, (0, side * r * 0.9, top + rise / 2), (r * 0.8, 0.03, rise / 2), (0.03, 1), material=wood)
    else:
        kit.add(PRISM, (0, 0, top + rise / 2), (r * 1.45, r * 1.45, rise / 2), (0.03, 4 if kind == "pyramid" else 10), rotation=turn("z", 45), material=cover)
    if kit.chance(0.5):
        kit.add(CYL, (r * 1.25, r * 0.6, 0.2), (0.17, 0.17, 0.18), (1.2, 1), material=wood)
