"""Makers of buildings with depth: roofs on posts, open halls, huts and stalls; and public buildings whose windows are true openings."""

import numpy as np

from .dwellings import (
    BLUE,
    BRICK,
    CONCRETE,
    COPPER,
    CREAM,
    GOLD,
    GREEN,
    GREY,
    LEAF,
    OCHRE,
    RED,
    SAND,
    SLATE,
    SNOW,
    STONE,
    THATCH,
    TILE,
    TIMBER,
    WHITE,
    WOOD,
    YELLOW,
    boards,
    brickwork,
    chimney,
    door,
    leaf,
    leaves,
    lights,
    masonry,
    panes,
    render,
    roof,
    row,
    tiles,
    trim,
    walls_of,
)
from .installations import ladder, railed, stairs, steelwork, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .landmarks import dome
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, LEAVES, PRISM, RUNGS, SPOKES, TUBE
from .materials import BANDS, BRICKS, CHECKER, CLOUDY, DOTS, PLAIN, PLANKS, RIBS, SEAMS, SHINGLES, SPECKLES, STREAKS, STRIPES, WRITING
from .worship import arched, clock, cross, onion, spire


def timberwork(kit):
    return tinted(kit, (WOOD, WOOD, TIMBER, WHITE, OCHRE, GREY, GREEN), (PLANKS, STREAKS, PLAIN), frequency=kit.rng.uniform(8, 22), gloss=0.03)


def vivid(kit, patterns=(PLAIN,), **fixed):
    return tinted(kit, ((0.6, 0.04, 0.03), (0.04, 0.15, 0.5), (0.75, 0.45, 0.03), (0.05, 0.35, 0.12), (0.7, 0.2, 0.03), (0.1, 0.4, 0.5)), patterns, **{"gloss": 0.15, **fixed})


def striped(kit):
    return vivid(kit, (STRIPES,), frequency=kit.rng.uniform(8, 18), second=(0.75, 0.74, 0.68), gloss=0.02)


def paving(kit):
    return tinted(kit, (CONCRETE, GREY, STONE), (CLOUDY, SEAMS, PLAIN), frequency=12, gloss=0.0)


def greens(kit):
    base = np.array(LEAF) * kit.rng.uniform(0.7, 2.2)
    return kit.material(base=base, second=base * 2.2, pattern=CLOUDY, frequency=22, gloss=0.0)


def lettered(kit):
    base, second = [((0.75, 0.74, 0.7), (0.05, 0.05, 0.2)), ((0.05, 0.08, 0.3), (0.75, 0.75, 0.7)), ((0.5, 0.03, 0.03), (0.8, 0.78, 0.7)), ((0.05, 0.2, 0.1), (0.8, 0.7, 0.3))][kit.rng.integers(4)]
    return kit.material(base=base, second=second, pattern=WRITING, frequency=kit.rng.uniform(14, 24), gloss=0.1)


def slab(kit, x, y, z, half, material, **more):
    """A box that stands on z."""
    kit.add(BOX, (x, y, z + half[2]), half, material=material, **more)


def posts(kit, xs, ys, low, high, r, material, kind=BOX):
    for x in xs:
        for y in ys:
            kit.add(kind, (x, y, (low + high) / 2), (r, r, (high - low) / 2), material=material)


def flight(kit, x, y, high, wide, material, count=4, way=1, deep=0.3, axis=0):
    """Steps that rise to a wall at `x` (axis 0) or `y` (axis 1) from the side `way`."""
    for k in range(count):
        run = deep * (count - k) / 2
        spot = (x + way * run, y) if axis == 0 else (x, y + way * run)
        half = (run, wide) if axis == 0 else (wide, run)
        slab(kit, *spot, 0, (*half, high * (k + 1) / count / 2), material)


def barrel(kit, x, z, long, wide, rise, count, material, thick=0.06):
    """An arched roof along x on walls at y = +-`wide`, of `count` flat pieces."""
    angles = np.linspace(0, np.pi, count + 1)
    for a, b in zip(angles[:-1], angles[1:], strict=True):
        y0, z0, y1, z1 = wide * np.cos(a), rise * np.sin(a), wide * np.cos(b), rise * np.sin(b)
        spin = turn("x", np.degrees(np.arctan2(z1 - z0, y1 - y0)))
        kit.add(BOX, (x, (y0 + y1) / 2, z + (z0 + z1) / 2), (long, np.hypot(y1 - y0, z1 - z0) / 2 + thick, thick), rotation=spin, material=material)


def rafters(kit, x, half, z, rise, r, material, post=True):
    """A tie, two rafters and a king post across y."""
    kit.between((x, -half, z), (x, half, z), r, BOX, material=material)
    kit.between((x, half, z), (x, 0, z + rise), r, BOX, material=material, mirror=True)
    if post:
        kit.between((x, 0, z), (x, 0, z + rise), r, BOX, material=material)


def bench(kit, x, y, z, long, material, back=-1):
    kit.add(BOX, (x, y, z + 0.45), (0.2, long, 0.04), material=material)
    kit.add(BOX, (x, y, z + 0.22), (0.14, long * 0.8, 0.22), material=material, cut=(BARS, 0.7 / long, 0.15))
    if back:
        kit.add(BOX, (x + back * 0.2, y, z + 0.7), (0.03, long, 0.2), material=material)


def open_building(kit):
    """Carports, petrol stations, bus shelters, market stalls, food stands, kiosks, bandstands, pergolas, picnic shelters, open barns, stables, hangars with trusses, boathouses,
    veranda houses, chalets, stilt and tree houses, garden and play houses, beach huts, log cabins, yurts, tipis, igloos, wigwams, greenhouses, conservatories, roofed wells,
    covered bridges, platforms, stadium stands, stages, car parks, toll gates, car washes, ski lifts, carousels, swing boats, dovecotes, hives, kennels, hen houses, bird tables."""
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


def wares(kit, x, y, z, count, long, deep):
    """Boxes of fruit and goods in a row along y."""
    for py in row(count, long, 0.95):
        slab(kit, x, py, z, (deep, long / count * 0.85, 0.1), tinted(kit, (WOOD, OCHRE)))
        kit.add(BALL, (x, py, z + 0.18), (deep * 0.85, long / count * 0.72, 0.13), material=vivid(kit, (DOTS, SPECKLES), frequency=25))


def market_stall(kit):
    rng = kit.rng
    wood, cloth = timberwork(kit), striped(kit)
    y, x, high = rng.uniform(1.1, 1.8), rng.uniform(0.7, 1.0), rng.uniform(2.0, 2.3)
    posts(kit, (-x, x), (-y, y), 0, high, 0.05, wood)
    slab(kit, x * 0.4, 0, 0.75, (x * 0.6, y, 0.05), wood)
    kit.add(BOX, (x * 0.98, 0, 0.4), (0.03, y, 0.4), material=cloth if kit.chance(0.6) else wood)
    for side in (-1, 1):
        kit.add(BOX, (x * 0.4, side * y, 0.4), (x * 0.6, 0.03, 0.4), material=wood)
    kind = rng.choice(["gable", "lean", "pyramid", "cross"])
    if kind == "pyramid":
        kit.add(BOX, (0, 0, high + 0.35), (x + 0.3, y + 0.25, 0.35), (0.03, 0.03), material=cloth)
    elif kind == "lean":
        kit.add(BOX, (0.15, 0, high + 0.05), (x + 0.4, y + 0.2, 0.03), rotation=turn("y", 14), material=cloth)
    else:
        leaves(kit, (0, 0, high), np.eye(3) if kind == "cross" else turn("z", 90), *((x + 0.2, (y + 0.25, -0.1)) if kind == "cross" else (y + 0.2, (x + 0.3, -0.1))), (0, 0.6), 0.025, cloth)
    kit.add(BOX, (x + 0.3, 0, high - 0.12), (0.02, y + 0.2, 0.14), material=cloth)
    if kit.chance(0.5):
        kit.add(BOX, (-x, 0, high * 0.5), (0.02, y, high * 0.5), material=cloth)
    wares(kit, x * 0.65, 0, 0.85, int(rng.integers(3, 6)), y, x * 0.3)
    wares(kit, x * 0.1, 0, 0.85, int(rng.integers(3, 5)), y, x * 0.22)
    for k in range(int(rng.integers(2, 5))):
        slab(kit, x + 0.4, y * (0.5 * k - 0.8), 0, (0.22, 0.3, rng.uniform(0.12, 0.3)), tinted(kit, (WOOD, OCHRE, GREEN), (PLANKS,), frequency=20))


def food_stand(kit):
    rng = kit.rng
    wall, accent, cloth, dark, steel = vivid(kit, (PLAIN, PLANKS, STRIPES), frequency=10), vivid(kit), striped(kit), kit.material(dark=True), tinted(kit, (GREY, WHITE))
    x, y, high, sill, lift = rng.uniform(0.9, 1.2), rng.uniform(1.3, 2.0), 2.4, 1.05, rng.choice([0, 0.35])
    if lift:
        for px in (-x * 0.5, x * 0.5):
            kit.add(CYL, (px * 0.8, y * 0.9, 0.32), (0.32, 0.32, 0.1), rotation=ALONG_Y, material=dark, mirror=True)
        kit.between((0, y, lift), (0, y + 0.9, lift), 0.05, BOX, material=dark)
        slab(kit, 0, y + 0.85, 0, (0.05, 0.05, 0.2), dark)
    kit.add(BOX, (-x + 0.04, 0, lift + high / 2), (0.05, y, high / 2), material=wall)
    kit.add(BOX, (0, y - 0.04, lift + high / 2), (x, 0.05, high / 2), material=wall, mirror=True)
    kit.add(BOX, (x - 0.04, 0, lift + sill / 2), (0.05, y, sill / 2), material=wall)
    kit.add(BOX, (x - 0.04, 0, lift + high - 0.15), (0.05, y, 0.15), material=wall)
    kit.add(BOX, (x - 0.04, y * 0.9, lift + high / 2), (0.06, y * 0.1, high / 2), material=wall, mirror=True)
    slab(kit, 0, 0, lift, (x, y, 0.05), dark)
    slab(kit, 0, 0, lift + high, (x + 0.1, y + 0.1, 0.07), accent)
    slab(kit, x + 0.15, 0, lift + sill, (0.22, y * 0.85, 0.03), steel)
    kit.add(BOX, (x + 0.5, 0, lift + high - 0.1), (0.55, y, 0.03), rotation=turn("y", 22), material=cloth)
    kit.add(BOX, (x + 1.0, 0, lift + high - 0.4), (0.02, y, 0.12), material=cloth)
    kit.add(BOX, (x * 0.4, 0, lift + high + 0.5), (0.06, y * 0.75, 0.3), material=lettered(kit))
    posts(kit, (x * 0.4,), (-y * 0.5, y * 0.5), lift + high, lift + high + 0.3, 0.04, dark)
    slab(kit, -x * 0.5, y * 0.3, lift + 0.9, (0.25, 0.3, 0.3), steel)
    slab(kit, -x * 0.5, 0, lift + 0.05, (0.3, y * 0.85, 0.42), steel)
    kit.add(BOX, (-x + 0.12, 0, lift + 1.85), (0.03, y * 0.7, 0.3), material=lettered(kit))
    for k in range(4):
        kit.add(CYL, (x + 0.12, y * (0.2 * k - 0.6), lift + sill + 0.16), (0.06, 0.06, 0.12), material=vivid(kit))
    sign = rng.choice(["cone", "sausage", "none"])
    if sign == "cone":
        kit.add(CYL, (-x * 0.2, y * 0.5, lift + high + 0.65), (0.05, 0.05, 0.5), (5, 1), material=tinted(kit, (OCHRE,), (CHECKER,), frequency=20))
        kit.add(BALL, (-x * 0.2, y * 0.5, lift + high + 1.25), (0.3, 0.3, 0.3), material=tinted(kit, ((0.7, 0.35, 0.35), CREAM)))
    elif sign == "sausage":
        kit.add(BALL, (0, 0, lift + high + 1.0), (0.22, 0.9, 0.2), material=tinted(kit, (OCHRE,)))
        kit.add(BALL, (0, 0, lift + high + 1.15), (0.15, 1.05, 0.14), material=tinted(kit, (RED,)))
    kit.add(BOX, (-x, y * 0.4, lift + 1.0), (0.03, 0.4, 0.95), material=accent)
    if lift:
        slab(kit, -x - 0.25, y * 0.4, 0, (0.25, 0.4, 0.12), dark)


def kiosk(kit):
    rng = kit.rng
    wall, cover, glass, trimming = tinted(kit, (GREEN, RED, BLUE, WOOD, TIMBER)), tinted(kit, (COPPER, SLATE, GREEN, GREY)), panes(kit), tinted(kit, (GOLD, WHITE, CREAM))
    sides, r, high = int(rng.choice([6, 8])), rng.uniform(1.0, 1.4), rng.uniform(2.2, 2.6)
    flat = r * np.cos(np.pi / sides)
    kit.add(PRISM, (0, 0, 0.08), (r + 0.15, r + 0.15, 0.08), (1, sides), material=paving(kit))
    kit.add(PRISM, (0, 0, 0.55), (r, r, 0.45), (1, sides), material=wall)
    kit.add(PRISM, (0, 0, high / 2 + 0.1), (r * 0.88, r * 0.88, high / 2), (1, sides), material=glass)
    for px, py in around(sides, r * 0.95):
        kit.add(CYL, (px, py, high / 2 + 0.1), (0.06, 0.06, high / 2), material=wall)
    kit.add(PRISM, (0, 0, high + 0.05), (r + 0.05, r + 0.05, 0.18), (1, sides), material=lettered(kit))
    kit.add(PRISM, (0, 0, high + 0.25), (r + 0.4, r + 0.4, 0.05), (0.95, sides), material=trimming)
    if kit.chance(0.5):
        kit.add(BALL, (0, 0, high + 0.28), (r * 0.95, r * 0.95, r * 0.75), material=cover)
        top = high + 0.28 + r * 0.75
    else:
        kit.add(PRISM, (0, 0, high + 0.5), (r + 0.3, r + 0.3, 0.25), (0.45, sides), material=cover)
        kit.add(PRISM, (0, 0, high + 0.98), (r * 0.58, r * 0.58, 0.25), (0.1, sides), material=cover)
        top = high + 1.2
    kit.loft((0, 0, top - 0.05), [(0, 0.1), (0.12, 0.05), (0.2, 0.12), (0.3, 0.1), (0.6, 0.01)], trimming)
    for turned in (-360 / sides, 0, 360 / sides):
        spin = turn("z", turned + 180 / sides)
        kit.add(BOX, spin @ np.array([flat + 0.12, 0, 1.0]), (0.18, r * 0.42, 0.03), rotation=spin, material=trimming)
        kit.add(BOX, spin @ np.array([flat + 0.02, 0, 0.55]), (0.03, r * 0.36, 0.28), rotation=spin, material=vivid(kit, (PLAIN, DOTS, WRITING), frequency=18))
        for k in range(3):
            kit.add(BOX, spin @ np.array([flat - 0.08, r * (0.26 * k - 0.26), 1.35]), (0.03, r * 0.11, 0.17), rotation=spin, material=vivid(kit, (WRITING, PLAIN), frequency=24))
    back = turn("z", 180 + 180 / sides)
    kit.add(BOX, back @ np.array([flat, 0, 1.1]), (0.04, r * 0.3, 0.95), rotation=back, material=wall)


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
    cover, frame, wall = tinted(kit, (GREY, BLUE, GREEN, WHITE), (RIBS,), frequency=rng.uniform(10, 30)), steelwork(kit), tinted(kit, (GREY, BLUE, CREAM, GREEN), (RIBS,), frequency=20)
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


def veranda_house(kit):
    rng = kit.rng
    wall, cover, frame, glass, base = walls_of(kit), tiles(kit), trim(kit), panes(kit), masonry(kit)
    x, y, high, deep, lift = rng.uniform(2.4, 3.2), rng.uniform(3, 4.2), rng.uniform(2.8, 3.2), rng.uniform(1.2, 1.7), rng.uniform(0.3, 0.8)
    slab(kit, 0, 0, 0, (x + deep, y + deep, lift / 2), base)
    slab(kit, 0, 0, lift, (x, y, high / 2 + 0.25), wall)
    eave = lift + high - 0.45
    kit.add(BOX, (0, 0, eave + 0.3), (x + deep + 0.3, y + deep + 0.3, 0.3), ((x + 0.1) / (x + deep + 0.3), (y + 0.1) / (y + deep + 0.3)), material=cover)
    top = lift + high + 0.45
    roof(kit, (0, 0, top - 0.25), (x, y), x * rng.uniform(0.5, 0.8), rng.choice(["hip", "gable"]), 0.2, cover, wall, 1)
    ys, xs = np.linspace(-y - deep + 0.15, y + deep - 0.15, 5), (-x - deep + 0.15, x + deep - 0.15)
    posts(kit, xs, ys, lift, eave, 0.08, frame, CYL if kit.chance(0.4) else BOX)
    posts(kit, (0,), (ys[0], ys[-1]), lift, eave, 0.08, frame)
    for start, end in (((xs[1], ys[0]), (xs[1], -0.8)), ((xs[1], 0.8), (xs[1], ys[-1])), ((xs[0], ys[0]), (xs[0], ys[-1])), ((xs[0], ys[0]), (xs[1], ys[0])), ((xs[0], ys[-1]), (xs[1], ys[-1]))):
        kit.railing((*start, lift), (*end, lift), 0.8, frame, 0.25, rng.choice([BARS, LATTICE]), 0.03)
    flight(kit, x + deep, 0, lift, 0.8, base, 3)
    door(kit, (x, 0, lift), (0.5, 1.05), leaf(kit), frame)
    lights(kit, (0, 0, lift + 1.35), (x, y), (-y * 0.55, y * 0.55), (0.5, 0.6), glass, frame, 0)
    lights(kit, (0, 0, lift + 1.35), (x, y), (-x * 0.45, x * 0.45), (0.4, 0.6), glass, frame, 1)
    chimney(kit, -x * 0.4, y * 0.5, top, top + x * 0.9)


def chalet(kit):
    rng = kit.rng
    stone, wood, cover, frame, glass, flowers = tinted(kit, (WHITE, CREAM, STONE), (PLAIN, BRICKS, CLOUDY)), timberwork(kit), tiles(kit), trim(kit), panes(kit), vivid(kit, (SPECKLES, DOTS), frequency=30)
    x, y, low, high = rng.uniform(3.2, 4.2), rng.uniform(3.2, 4.4), 2.6, rng.uniform(2.5, 4.8)
    eave, rise, over = low + high, y * rng.uniform(0.4, 0.6), rng.uniform(1.2, 1.7)
    slab(kit, 0, 0, 0, (x, y, low / 2), stone)
    slab(kit, 0, 0, low, (x + 0.05, y + 0.05, high / 2), wood)
    kit.add(BOX, (0, 0, eave + rise / 2), (x, y, rise / 2), (1, 0.02), material=wood)
    leaves(kit, (0, 0, eave), np.eye(3), x + over, (y + over, -over * rise / y), (0, rise), 0.13, cover)
    if kit.chance(0.3):
        leaves(kit, (0, 0, eave + 0.22), np.eye(3), x + over - 0.1, (y + over - 0.1, -over * rise / y), (0, rise), 0.1, tinted(kit, (SNOW,), (CLOUDY,)))
    kit.between((x + over - 0.1, y + over, eave - over * rise / y), (x + over - 0.1, 0, eave + rise), (0.16, 0.04), BOX, material=wood, mirror=True)
    floors = [low] if high < 3.4 else [low, low + 2.5]
    for z in floors:
        kit.add(BOX, (x + 0.55, 0, z + 0.05), (0.65, y + 0.05, 0.08), material=wood)
        kit.railing((x + 1.15, -y, z + 0.1), (x + 1.15, y, z + 0.1), 0.85, wood, 0.22)
        for side in (-y, y):
            kit.railing((x, side, z + 0.1), (x + 1.15, side, z + 0.1), 0.85, wood, 0.22)
        kit.add(BOX, (x + 1.2, 0, z + 1.0), (0.1, y * 0.85, 0.12), material=flowers)
        lights(kit, (0, 0, z + 1.2), (x + 0.05, y), row(3, y), (0.4, 0.65), glass, frame, 0, False)
        for py in (-y * 0.9, y * 0.9):
            kit.between((x, py, z - 0.7), (x + 1.0, py, z), 0.08, BOX, material=wood)
    lights(kit, (0, 0, low + 1.2), (x, y + 0.05), row(2, x), (0.45, 0.5), glass, frame, 1)
    door(kit, (x, 0, 0), (0.5, 1.0), leaf(kit), frame)
    lights(kit, (0, 0, 1.4), (x, y), (-y * 0.55, y * 0.55), (0.4, 0.45), glass, frame, 0, False)
    kit.add(BOX, (x + 0.03, 0, eave + rise * 0.35), (0.05, 0.4, 0.45), material=glass)
    chimney(kit, -x * 0.3, y * 0.4, eave, eave + rise + 0.8, stone)


def stilt_house(kit):
    rng = kit.rng
    wall, cover, frame, glass = tinted(kit, (WOOD, OCHRE, THATCH, BLUE, GREEN, GREY), (PLANKS, RIBS, BANDS), frequency=18), tinted(kit, (THATCH, GREY, TILE, TIMBER), (SHINGLES, STREAKS, RIBS), frequency=16), timberwork(kit), panes(kit)
    x, y, lift, high = rng.uniform(1.8, 2.4), rng.uniform(2.0, 2.8), rng.uniform(1.8, 3.0), rng.uniform(2.0, 2.4)
    out = rng.uniform(1.0, 1.5)
    posts(kit, (-x, 0, x + out * 0.9), np.linspace(-y, y, 3), 0, lift, 0.11, frame, CYL)
    kit.between((x, -y, lift * 0.15), (x, y, lift * 0.9), 0.05, BOX, material=frame)
    kit.between((-x, y, lift * 0.15), (x, y, lift * 0.9), 0.05, BOX, material=frame, mirror=True)
    kit.add(BOX, (out / 2, 0, lift + 0.06), (x + out / 2 + 0.15, y + 0.15, 0.09), material=frame)
    slab(kit, 0, 0, lift, (x, y, high / 2), wall)
    rise = y * rng.uniform(0.7, 1.2)
    roof(kit, (out / 2, 0, lift + high), (x + out / 2, y), rise, rng.choice(["gable", "gable", "hip"]), 0.45, cover, wall)
    posts(kit, (x + out - 0.1,), (-y + 0.1, 0.7, y - 0.1), lift, lift + high, 0.07, frame)
    kit.railing((x + out, 0.7, lift + 0.1), (x + out, y, lift + 0.1), 0.8, frame, 0.25)
    for side in (-y, y):
        kit.railing((x, side, lift + 0.1), (x + out, side, lift + 0.1), 0.8, frame, 0.25)
    stairs(kit, (x + out + lift * 0.8, -y * 0.4, 0), (x + out, -y * 0.4, lift), 0.45, frame)
    kit.railing((x + out, -y, lift + 0.1), (x + out, -y * 0.75, lift + 0.1), 0.8, frame, 0.25)
    door(kit, (x, -y * 0.4, lift + 0.1), (0.4, 0.85), leaf(kit), trim(kit))
    lights(kit, (0, 0, lift + high * 0.55), (x, y), [y * 0.45], (0.4, 0.4), glass, frame, 0)
    lights(kit, (0, 0, lift + high * 0.55), (x, y), row(2, x), (0.35, 0.4), glass, frame, 1)
    kit.add(BALL, (0, 0, 0.35), (1.4, 0.4, 0.3), material=vivid(kit))
    kit.add(BOX, (0, 0, 0.15), (0.8, 0.35, 0.12), material=frame)


def tree_house(kit):
    rng = kit.rng
    bark, wood, cover, green = tinted(kit, (TIMBER, WOOD, GREY), (STREAKS, CLOUDY), frequency=20, gloss=0.0), timberwork(kit), tiles(kit), greens(kit)
    lift, x, y, high = rng.uniform(2.2, 3.4), rng.uniform(1.1, 1.5), rng.uniform(1.1, 1.6), rng.uniform(1.6, 1.9)
    trunk = np.array([-x * 1.0, 0, 0])
    kit.loft(trunk, [(0, 0.75), (0.4, 0.45), (lift, 0.38), (lift + high + 1, 0.3)], bark)
    for side, out, up in ((1, 1.6, 1.6), (-1, 1.8, 1.3), (0, 1.5, 2.0)):
        tip = trunk + [(-1.0 if side else 1.4), side * out, lift + high + up]
        kit.between(trunk + [0, 0, lift + high * 0.5 + 0.4], tip, 0.17, CYL, 0.5, material=bark)
        size = rng.uniform(1.2, 1.7)
        kit.add(BALL, tip + [0, 0, 0.6], (size, size, size * 0.75), material=green, cut=(LEAVES, rng.uniform(4, 8), rng.uniform(0.6, 0.85)))
    kit.add(BALL, trunk + [0, 0, lift + high + 2.3], (1.6, 1.6, 1.2), material=green, cut=(LEAVES, 5, 0.7))
    kit.add(BOX, (0.4, 0, lift), (x + 0.85, y + 0.3, 0.07), material=wood)
    for side in (-1, 1):
        kit.between(trunk + [0, 0, lift * 0.4], (x + 0.6, side * y, lift - 0.05), 0.09, BOX, material=bark)
        kit.add(BOX, (0, side * y, lift + high / 2), (x, 0.05, high / 2), material=wood, cut=(BARS, 0.9, 0.55))
        kit.add(BOX, (0, side * y, lift + high * 0.22), (x, 0.05, high * 0.22), material=wood)
    kit.add(BOX, (-x + 0.4, 0, lift + high / 2), (0.05, y, high / 2), material=wood)
    kit.add(BOX, (x, -y * 0.6, lift + high / 2), (0.05, y * 0.4, high / 2), material=wood)
    kit.add(BOX, (x, y * 0.8, lift + high / 2), (0.05, y * 0.2, high / 2), material=wood)
    kit.add(BOX, (x, 0.2 * y, lift + high * 0.92), (0.05, y * 0.8, high * 0.1), material=wood)
    roof(kit, (0.1, 0, lift + high), (x, y), rng.uniform(0.6, 1.0), rng.choice(["gable", "shed", "hip"]), 0.3, cover, wood)
    railed(kit, 0.6, 0, lift + 0.07, x + 0.6, y + 0.26, 0.65, wood)
    ladder(kit, (x + 1.9, y * 0.25, 0), (x + 1.25, y * 0.25, lift + 0.6), 0.28, wood)
    for side in (-0.28, 0.28):
        kit.between((x + 1.9, y * 0.25 + side, 0), (x + 1.25, y * 0.25 + side, lift + 0.6), 0.045, material=wood)
    kit.between((0.8, -y - 0.2, lift), (0.8, -y - 0.2, 0.5), 0.03, material=wood)
    kit.add(CYL, (0.8, -y - 0.2, 0.35), (0.35, 0.35, 0.1), rotation=ALONG_X, material=kit.material(dark=True))


def garden_house(kit):
    rng = kit.rng
    wall, cover, frame, glass, wood = boards(kit), tiles(kit), trim(kit), panes(kit), timberwork(kit)
    x, y, high, porch = rng.uniform(1.1, 1.6), rng.uniform(1.2, 1.8), rng.uniform(1.9, 2.2), rng.choice([0.0, 0.8, 1.1])
    slab(kit, porch / 2, 0, 0, (x + porch / 2 + 0.1, y + 0.1, 0.07), wood)
    slab(kit, 0, 0, 0.14, (x, y, high / 2), wall)
    eave, axis = 0.14 + high, int(rng.integers(2)) if not porch else 0
    roof(kit, (porch / 2, 0, eave), (x + porch / 2, y), rng.uniform(0.5, 1.1), rng.choice(["gable", "gable", "hip", "shed"]), 0.25, cover, wall, axis)
    for px in (-x, x):
        posts(kit, (px,), (-y, y), 0.1, eave, 0.07, frame)
    if porch:
        posts(kit, (x + porch - 0.06,), (-y + 0.06, y - 0.06), 0.1, eave, 0.05, frame)
        kit.railing((x + porch, 0.5, 0.14), (x + porch, y, 0.14), 0.7, frame, 0.15, rng.choice([BARS, LATTICE]))
        kit.railing((x + porch, -y, 0.14), (x + porch, -0.5, 0.14), 0.7, frame, 0.15)
        for side in (-y, y):
            kit.railing((x, side, 0.14), (x + porch, side, 0.14), 0.7, frame, 0.15)
    at = 0.0 if y > 1.5 or kit.chance(0.5) else -y * 0.4
    for py in (at - 0.3, at + 0.3) if kit.chance(0.5) else (at,):
        door(kit, (x, py, 0.14), (0.28, 0.85), leaf(kit), frame)
        kit.add(BOX, (x + 0.1, py, 1.3), (0.02, 0.19, 0.32), material=glass)
    lights(kit, (0, 0, 1.3), (x, y), [y * 0.68, -y * 0.68] if at == 0 else [y * 0.45], (0.2 if at == 0 else 0.35, 0.32), glass, frame, 0)
    lights(kit, (0, 0, 1.3), (x, y), [0], (0.35, 0.32), glass, frame, 1)
    for side in (-1, 1):
        slab(kit, x + 0.15, side * y * 0.68, 0.75, (0.12, 0.25, 0.09), wood)
        kit.add(BALL, (x + 0.15, side * y * 0.68, 0.96), (0.15, 0.27, 0.12), material=vivid(kit, (SPECKLES,), frequency=30))


def play_house(kit):
    rng = kit.rng
    wall, cover, frame, accent, glass = boards(kit), vivid(kit, (SHINGLES, PLAIN, RIBS), frequency=12), trim(kit), vivid(kit), kit.material(dark=True)
    x, y, high, lift = rng.uniform(0.6, 0.8), rng.uniform(0.6, 0.85), rng.uniform(1.1, 1.3), rng.choice([0.1, 0.6, 1.0, 1.3])
    deep = rng.uniform(0.45, 0.65)
    posts(kit, (-x, x, x + deep), (-y, y), 0, lift, 0.06, frame)
    kit.add(BOX, (deep / 2, 0, lift), (x + deep / 2 + 0.05, y + 0.05, 0.05), material=frame)
    kit.add(BOX, (-x, 0, lift + high / 2), (0.03, y, high / 2), material=wall)
    for side in (-1, 1):
        kit.add(BOX, (0, side * y, lift + high * 0.25), (x, 0.03, high * 0.25), material=wall)
        kit.add(BOX, (0, side * y, lift + high * 0.92), (x, 0.03, high * 0.09), material=wall)
        for px in (-x * 0.72, x * 0.72):
            kit.add(BOX, (px, side * y, lift + high / 2), (x * 0.28, 0.03, high / 2), material=wall)
        kit.add(BOX, (0, side * (y + 0.02), lift + high * 0.66), (x * 0.48, 0.03, high * 0.2), material=frame, cut=(GRID, 1.0 / (x * 0.48), 0.12))
        kit.add(BOX, (x, side * y * 0.7, lift + high / 2), (0.03, y * 0.32, high / 2), material=wall)
        kit.add(BOX, (x + 0.02, side * y * 0.7, lift + high * 0.62), (0.03, y * 0.18, high * 0.16), material=glass)
        kit.add(BOX, (0, side * (y + 0.1), lift + high * 0.44), (x * 0.5, 0.09, 0.06), material=accent)
    kit.add(BOX, (x, 0, lift + high * 0.93), (0.03, y, high * 0.08), material=wall)
    roof(kit, (deep / 2, 0, lift + high), (x + deep / 2, y), rng.uniform(0.5, 0.8), rng.choice(["gable", "gable", "shed"]), 0.15, cover, wall)
    posts(kit, (x + deep,), (-y, y), lift, lift + high, 0.045, frame)
    kit.railing((x + deep, 0.28, lift + 0.05), (x + deep, y, lift + 0.05), 0.4, accent, 0.12)
    for side in (-y, y):
        kit.railing((x, side, lift + 0.05), (x + deep, side, lift + 0.05), 0.4, accent, 0.12)
    if lift > 0.3:
        run, end = lift * 1.4, np.array([x + deep + lift * 1.5, -y * 0.35, 0.12])
        kit.between((x + deep, -y * 0.35, lift), end, (0.025, 0.26), BOX, material=accent)
        for side in (-0.27, 0.27):
            kit.between((x + deep, -y * 0.35 + side, lift + 0.08), end + [0, side, 0.08], (0.09, 0.025), BOX, material=accent)
        kit.add(BOX, end + [0.18, 0, -0.03], (0.22, 0.27, 0.03), material=accent)
        slab(kit, end[0] + 0.1, end[1], 0, (0.05, 0.2, 0.06), frame)
        ladder(kit, (x + deep + run * 0.35, y * 0.15 + 0.08, 0), (x + deep, y * 0.15 + 0.08, lift), 0.2, frame)
    else:
        for start, stop in (((x + deep + 0.8, -y - 0.4), (x + deep + 0.8, -0.25)), ((x + deep + 0.8, 0.25), (x + deep + 0.8, y + 0.4)), ((x, y + 0.4), (x + deep + 0.8, y + 0.4)), ((x, -y - 0.4), (x + deep + 0.8, -y - 0.4))):
            kit.railing((*start, 0), (*stop, 0), 0.45, frame, 0.14)
        kit.add(BOX, (x, 0, lift + high * 0.35), (0.02, y * 0.36, high * 0.33), material=accent)
    if kit.chance(0.4):
        slab(kit, -x * 0.3, y * 0.4, lift + high, (0.1, 0.1, 0.5), brickwork(kit))


def beach_hut(kit):
    rng = kit.rng
    count = int(rng.integers(1, 4))
    x, y, high, lift = rng.uniform(1.1, 1.5), rng.uniform(0.85, 1.05), rng.uniform(1.9, 2.3), rng.choice([0.15, 0.4, 0.8])
    frame = tinted(kit, (WHITE,))
    for k in range(count):
        at, second = (k - (count - 1) / 2) * (2 * y + 0.45), vivid(kit)
        wall, cover = vivid(kit, (STRIPES, PLANKS, PLAIN), frequency=rng.uniform(8, 14), second=(0.75, 0.74, 0.7)), tiles(kit)
        posts(kit, (-x, x + 0.6), (at - y * 0.9, at + y * 0.9), 0, lift, 0.08, timberwork(kit))
        kit.add(BOX, (0.35, at, lift), (x + 0.4, y + 0.05, 0.06), material=frame)
        slab(kit, 0, at, lift, (x, y, high / 2), wall)
        roof(kit, (0.2, at, lift + high), (x + 0.15, y), y * rng.uniform(0.7, 1.1), "gable", 0.15, cover, wall)
        for side in (-0.25, 0.25):
            kit.add(BOX, (x + 0.03, at + side, lift + 0.9), (0.04, 0.235, 0.82), material=second)
        kit.add(BOX, (x + 0.05, at, lift + 1.75), (0.04, 0.6, 0.05), material=frame)
        kit.add(BOX, (x + 0.36, at, lift + high + y * 0.45), (0.02, 0.16, 0.16), material=frame)
        for step in range(2 if lift > 0.3 else 0):
            slab(kit, x + 0.85 + 0.25 * step, at, 0, (0.13, 0.4, lift * (0.35 - 0.16 * step)), frame)
    if count == 1:
        posts(kit, (x + 0.65,), (-y, y), lift, lift + 0.8, 0.04, frame)
        for side in (-y, y):
            kit.railing((x, side, lift), (x + 0.65, side, lift), 0.8, frame, 0.2)
        lights(kit, (0, 0, lift + 1.2), (x, y), [0], (0.3, 0.3), panes(kit), frame, 1)


def log_cabin(kit):
    rng = kit.rng
    logs, cover, frame, glass, stone = tinted(kit, (WOOD, OCHRE, TIMBER, GREY), (STREAKS, PLAIN), frequency=15, gloss=0.02), tiles(kit), trim(kit), panes(kit), masonry(kit)
    x, y, r, count = rng.uniform(1.9, 2.5), rng.uniform(2.2, 3.0), 0.17, 7
    high, porch = count * 2 * r, rng.choice([0.0, 1.2])
    slab(kit, 0, 0, 0, (x - 0.05, y - 0.05, high / 2), logs)
    for k in range(count):
        z = r + 2 * r * k
        for side in (-1, 1):
            kit.add(CYL, (0, side * y, z), (r, r, x + 0.35), rotation=ALONG_X, material=logs)
            if k < count - 1:
                kit.add(CYL, (side * x, 0, z + r), (r, r, y + 0.35), rotation=ALONG_Y, material=logs)
    rise = y * rng.uniform(0.45, 0.75)
    roof(kit, (porch / 2, 0, high), (x + porch / 2, y), rise, "gable", 0.45, cover, logs)
    if porch:
        slab(kit, x + porch / 2, 0, 0, (porch / 2 + 0.1, y, 0.12), logs)
        posts(kit, (x + porch - 0.1,), (-y + 0.1, -0.7, 0.7, y - 0.1), 0.1, high, 0.1, logs, CYL)
        kit.railing((x + porch, 0.7, 0.2), (x + porch, y, 0.2), 0.7, logs, 0.3)
        kit.railing((x + porch, -y, 0.2), (x + porch, -0.7, 0.2), 0.7, logs, 0.3)
    door(kit, (x + r * 0.9, 0, 0.05), (0.42, 0.95), leaf(kit), frame)
    lights(kit, (0, 0, 1.3), (x + r, y), (-y * 0.58, y * 0.58), (0.38, 0.38), glass, frame, 0)
    lights(kit, (0, 0, 1.3), (x, y + r), [x * 0.3], (0.38, 0.38), glass, frame, 1)
    slab(kit, -x * 0.4, y + 0.45, 0, (0.55, 0.4, high * 0.45), stone)
    slab(kit, -x * 0.4, y + 0.4, 0, (0.32, 0.32, (high + rise + 0.7) / 2), stone)


def yurt(kit):
    rng = kit.rng
    felt, band, wood, door_skin = tinted(kit, (WHITE, CREAM, GREY, SAND), (PLAIN, CLOUDY, STREAKS)), vivid(kit, (CHECKER, DOTS, BANDS), frequency=14), timberwork(kit), vivid(kit)
    r, high, rise = rng.uniform(2.2, 3.0), rng.uniform(1.5, 1.8), rng.uniform(0.8, 1.3)
    kit.add(PRISM, (0, 0, 0.1), (r + 0.5, r + 0.5, 0.1), (1, 12), material=wood)
    kit.add(CYL, (0, 0, 0.15 + high / 2), (r, r, high / 2), material=felt)
    for z in (0.35, high * 0.55, high):
        kit.add(CYL, (0, 0, 0.15 + z), (r + 0.03, r + 0.03, 0.06), material=band if z == high else wood)
    kit.loft((0, 0, 0.15 + high), [(0, r + 0.12), (rise * 0.85, r * 0.3), (rise, r * 0.2)], felt)
    kit.add(CYL, (0, 0, 0.15 + high + rise), (r * 0.2, r * 0.2, 0.1), material=wood)
    kit.add(BALL, (0, 0, 0.25 + high + rise), (r * 0.18, r * 0.18, 0.15), material=panes(kit))
    kit.between((-r * 0.4, r * 0.3, high), (-r * 0.4, r * 0.3, high + rise + 0.8), 0.08, material=kit.material(dark=True))
    for px, py in around(12, r + 0.1, 15):
        kit.between((px, py, 0.15 + high), (px * 0.25, py * 0.25, 0.2 + high + rise * 0.92), 0.025, material=band)
        kit.between((px, py, 0.15), (px, py, 0.15 + high), 0.02, material=wood)
    door(kit, (r * 0.98, 0, 0.2), (0.42, 0.78), door_skin, wood)
    kit.add(BOX, (r + 0.08, 0, 1.0), (0.02, 0.25, 0.45), material=band)
    slab(kit, r + 0.7, 0, 0, (0.35, 0.6, 0.06), wood)


def tipi(kit):
    rng = kit.rng
    hide, second, wood = tinted(kit, (CREAM, WHITE, SAND, OCHRE), (PLAIN, CLOUDY, STREAKS)), vivid(kit, (BANDS, CHECKER, DOTS, PLAIN), frequency=9), timberwork(kit)
    r, tall, count = rng.uniform(1.5, 2.1), rng.uniform(3.4, 4.4), int(rng.integers(9, 13))
    low, mid = tall * 0.22, tall * rng.uniform(0.6, 0.75)

    def wide(z):
        return r * (1 - z / tall) + 0.06

    kit.loft((0, 0, 0), [(0, wide(0)), (low, wide(low))], second, PRISM, sides=count)
    kit.loft((0, 0, 0), [(low, wide(low)), (mid, wide(mid))], hide, PRISM, sides=count)
    kit.loft((0, 0, 0), [(mid, wide(mid)), (tall * 0.95, wide(tall * 0.95))], second if kit.chance(0.6) else hide, PRISM, sides=count)
    for px, py in around(count, 1):
        kit.between((px * r, py * r, 0), (-px * r * 0.28, -py * r * 0.28, tall * 1.28), 0.035, CYL, 0.7, material=wood)
    slope = np.degrees(np.arctan2(r, tall))
    lean = turn("y", -slope)
    dark = kit.material(dark=True)
    kit.add(BOX, (wide(0.75) * 0.99, 0, 0.75), (0.04, 0.42, 0.78), (1, 0.15), rotation=lean, material=dark)
    kit.add(BOX, (wide(0.75) + 0.08, 0.42, 0.7), (0.03, 0.22, 0.7), (1, 0.4), rotation=lean @ turn("z", 30), material=hide)
    for k in range(5):
        z = tall * (0.48 + 0.08 * k)
        kit.between((wide(z), -0.15, z), (wide(z), 0.15, z), 0.025, material=wood)
    for side in (-1, 1):
        kit.add(BOX, (wide(tall * 0.9) + 0.2, side * 0.28, tall * 0.92), (0.03, 0.22, 0.45), (1, 1.4), rotation=turn("z", side * 35), material=hide)
        kit.between((r * 0.7, side * r * 1.1, 0), (wide(tall * 0.9) + 0.2, side * 0.4, tall * 1.05), 0.03, material=wood)
    for px, py in around(count, r + 0.12, 15):
        kit.between((px, py, 0), (px * 0.93, py * 0.93, 0.3), 0.035, material=wood)


def igloo(kit):
    rng = kit.rng
    snow, dark = tinted(kit, (SNOW, SNOW, (0.6, 0.7, 0.8)), (BRICKS,), frequency=rng.uniform(6, 10), second=(0.4, 0.5, 0.62), gloss=0.1), kit.material(base=(0.03, 0.05, 0.08), pattern=PLAIN)
    r, squash, levels = rng.uniform(1.5, 2.0), rng.uniform(0.78, 1.0), 7
    for k in range(levels):
        a, b = np.pi / 2 * k / levels, np.pi / 2 * (k + 1) / levels
        low, top = r * np.cos(a), max(r * np.cos(b), 0.12)
        kit.add(PRISM, (0, 0, r * squash * (np.sin(a) + np.sin(b)) / 2), (low, low, r * squash * (np.sin(b) - np.sin(a)) / 2), (top / low, 16), rotation=turn("z", 11 * (k % 2)), material=snow)
    for k in range(3):
        x, tall = r * 0.85 + 0.42 * k, 0.72 - 0.04 * k
        for start, end in ((15, 55), (55, 90), (90, 125), (125, 165)):
            a, b = np.radians(start), np.radians(end)
            kit.between((x, tall * np.cos(a), tall * np.sin(a)), (x, tall * np.cos(b), tall * np.sin(b)), (0.15, 0.24), BOX, material=snow)
        kit.add(BOX, (x, tall * 0.95, 0.13), (0.22, 0.15, 0.14), material=snow, mirror=True)
    kit.add(CYL, (r * 0.95, 0, 0), (0.6, 0.6, 0.12), rotation=ALONG_X, material=dark)
    for k in range(int(rng.integers(2, 6))):
        slab(kit, r * 0.6 + 0.3 * k, -r * 1.25 + 0.1 * (k % 2), 0, (0.25, 0.3, 0.17), snow, rotation=turn("z", rng.uniform(-30, 30)))
    if kit.chance(0.5):
        kit.between((r * 0.5, r * 1.15, 0), (r * 0.3, r * 1.0, 1.7), (0.02, 0.07), BOX, material=vivid(kit))


def wigwam(kit):
    rng = kit.rng
    bark, wood, dark = tinted(kit, (WOOD, THATCH, GREY, TIMBER), (SHINGLES, STREAKS, BANDS), frequency=rng.uniform(10, 18), gloss=0.0), timberwork(kit), kit.material(dark=True)
    r, high, long = rng.uniform(1.4, 1.8), rng.uniform(1.7, 2.1), rng.choice([0.0, 0.0, 1.6])
    profile = [(0, 1.0), (0.45, 0.96), (0.7, 0.8), (0.88, 0.55), (1.0, 0.2)]
    for end in (-long, long) if long else (0,):
        kit.loft((end, 0, 0), [(h * high, w * r) for h, w in profile], bark)
    if long:
        for (h0, w0), (h1, w1) in zip(profile[:-1], profile[1:], strict=True):
            kit.add(BOX, (0, 0, high * (h0 + h1) / 2), (long, r * w0, high * (h1 - h0) / 2), (1, w1 / w0), material=bark)
    for share in (0.3, 0.6):
        wide = r * (0.99 if share < 0.5 else 0.9) + 0.02
        for end in (-long, long) if long else (0,):
            kit.add(CYL, (end, 0, high * share), (wide, wide, 0.035), material=wood)
        if long:
            kit.add(BOX, (0, 0, high * share), (long, wide, 0.035), material=wood)
    for end in np.linspace(-long, long, 5 if long else 1):
        for axis in (turn("z", 90), turn("z", 45), turn("z", 135)) if not long else (turn("z", 90),):
            points = [axis @ np.array([s * w * (r + 0.03), 0, h * (high + 0.02)]) + [end, 0, 0] for s, seq in ((1, profile), (-1, profile[::-1])) for h, w in seq]
            for start, stop in zip(points[:-1], points[1:], strict=True):
                if len(kit.primitives) < 58:
                    kit.between(start, stop, 0.03, material=wood)
    front = long + r
    kit.add(BOX, (front - 0.06, 0, 0.6), (0.12, 0.4, 0.6), material=dark)
    kit.add(BOX, (front + 0.02, 0.5, 0.62), (0.08, 0.1, 0.64), material=wood, mirror=True)
    kit.add(BOX, (front + 0.02, 0, 1.25), (0.1, 0.6, 0.07), material=wood)
    kit.add(CYL, (0, 0, high), (0.3, 0.3, 0.05), material=dark)


def greenhouse(kit):
    rng = kit.rng
    glass, frame, base = tinted(kit, ((0.3, 0.4, 0.38), (0.2, 0.28, 0.3), (0.45, 0.52, 0.5)), (PLAIN, CLOUDY), gloss=0.6), tinted(kit, (WHITE, GREEN, GREY, TIMBER)), brickwork(kit)
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
    wall, cover, frame, base, glass = walls_of(kit), tiles(kit), tinted(kit, (WHITE, WHITE, GREEN, TIMBER)), brickwork(kit), tinted(kit, ((0.25, 0.33, 0.36), (0.15, 0.2, 0.22)), gloss=0.6)
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


def covered_bridge(kit):
    rng = kit.rng
    wall, cover, frame, stone = tinted(kit, (RED, RED, WOOD, GREY, WHITE), (PLANKS, STRIPES), frequency=rng.uniform(10, 20), gloss=0.0), tiles(kit), timberwork(kit), masonry(kit)
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
        kit.add(BOX, (side * x * 1.1, 0, z + (0.3 if kind == "butterfly" else -0.3 if kind == "gable" else 0.0)), (0.03, y * 0.9, 0.15), material=wood, cut=(BARS, 3, 0.6)) if kind != "lean" else None
    for py in (-y * 0.45, y * 0.35):
        bench(kit, 0.35, py, 0.8, 0.7, wood)
    kit.add(BOX, (0, 0, z - 0.6), (0.06, 0.8, 0.2), material=sign)
    posts(kit, (0,), (-0.6, 0.6), z - 0.5, z, 0.025, steel)
    kit.add(CYL, (0, y * 0.55, z - 0.5), (0.3, 0.3, 0.1), rotation=ALONG_X, material=tinted(kit, (WHITE,)))
    kit.between((0, y * 0.55, z - 0.3), (0, y * 0.55, z), 0.025, material=steel)
    slab(kit, 0, -y * 0.9, 0.8, (0.3, 0.3, 0.8), vivid(kit))
    kit.add(CYL, (0, y * 0.85, 1.2), (0.2, 0.2, 0.4), material=dark)


def stand(kit):
    rng = kit.rng
    concrete, seats, steel, cover = tinted(kit, (CONCRETE, GREY, WHITE)), vivid(kit, (CHECKER, PLAIN, WRITING), frequency=rng.uniform(8, 20)), steelwork(kit), steelwork(kit)
    y, rows, base = rng.uniform(5, 8), int(rng.integers(7, 12)), rng.uniform(0.6, 1.4)
    deep, up = 0.6, rng.uniform(0.32, 0.45)
    for k in range(rows):
        x, z = -deep * k, base + up * k
        slab(kit, x - deep / 2, 0, 0 if k in (0, rows - 1) else z - up, (deep / 2 + 0.02, y, (z if k in (0, rows - 1) else up) / 2), concrete)
        kit.add(BOX, (x - deep * 0.65, 0, z + 0.2), (0.16, y * 0.98, 0.2), material=seats)
    back, top = -deep * rows, base + up * rows
    for side in (-1, 1):
        for k in range(3):
            kit.add(BOX, (back * (k + 0.5) / 3, side * (y - 0.1), (base + (top - base) * (k + 0.5) / 3) / 2), (-back / 6, 0.1, (base + (top - base) * (k + 0.5) / 3) / 2), material=concrete)
    high = top + rng.uniform(2.0, 2.8)
    kit.add(BOX, (back - 0.1, 0, (top + 1) / 2), (0.1, y, (top + 1) / 2), material=cover)
    spots = np.linspace(-y * 0.94, y * 0.94, int(rng.integers(4, 6)))
    for py in spots:
        kit.between((back - 0.15, py, 0), (back - 0.15, py, high + 0.6), (0.16, 0.12), BOX, material=steel)
        kit.between((back - 0.15, py, high + 0.55), (0.3, py, high + 0.12), 0.08, BOX, material=steel)
    kit.between((back - 0.6, 0, high - 0.25), (0.9, 0, high + 0.05), (0.06, y * 1.02), BOX, material=cover)
    for py in row(3, y, 0.9):
        kit.add(BOX, (-deep * rows * 0.5, py, base + up * rows * 0.5 + 0.12), (-back / 2 * 1.05, 0.22, 0.12), rotation=turn("y", np.degrees(np.arctan2(up, deep))), material=concrete)
    kit.railing((0.05, -y, base), (0.05, y, base), 0.5, steel, 0.5)
    kit.add(BOX, (0.02, 0, base / 2), (0.03, y, base * 0.3), material=lettered(kit))
    for k in range(2):
        kit.add(BOX, (0.02, y * (0.5 - k), base * 0.42), (0.06, 0.5, base * 0.4), material=kit.material(dark=True))


def stage(kit):
    rng = kit.rng
    deck, steel, dark, cloth, cover = timberwork(kit), tinted(kit, (GREY, WHITE)), kit.material(dark=True), vivid(kit, (PLAIN, STRIPES)), tinted(kit, (WHITE, GREY, BLUE, RED))
    x, y, lift, high = rng.uniform(2.2, 3), rng.uniform(3.2, 4.4), rng.uniform(0.8, 1.2), rng.uniform(3.5, 4.5)
    slab(kit, 0, 0, 0, (x, y, lift / 2), dark)
    slab(kit, 0, 0, lift - 0.08, (x + 0.05, y + 0.05, 0.05), deck)
    if kit.chance(0.45):  # a shell
        count = 5
        for k in range(count):
            size, px = 1 - 0.14 * k, x * (0.9 - 0.45 * k)
            for a, b in zip(np.linspace(0, np.pi, 7)[:-1], np.linspace(0, np.pi, 7)[1:], strict=True):
                start, end = (px, y * 0.95 * size * np.cos(a), lift + high * size * np.sin(a)), (px, y * 0.95 * size * np.cos(b), lift + high * size * np.sin(b))
                kit.between(start, end, (0.12, x * 0.26), BOX, material=cover if k % 2 else cloth)
        for k in range(4):
            z0, z1 = k / 4, (k + 1) / 4
            w0, w1 = np.sqrt(1 - z0**2), np.sqrt(max(1 - z1**2, 0.01))
            kit.add(BOX, (-x * 0.98, 0, lift + high * 0.44 * (z0 + z1) / 2), (0.08, y * 0.42 * w0, high * 0.055), (1, w1 / w0), material=cover)
    else:
        for px in (-x * 0.9, x * 0.9):
            for py in (-y * 0.95, y * 0.95):
                kit.add(BOX, (px, py, lift / 2 + high / 2 + 0.2), (0.2, 0.2, high / 2 + lift / 2 + 0.2), material=steel, cut=(LATTICE, 2.4, 0.22))
            kit.add(BOX, (px, 0, lift + high), (0.18, y, 0.2), material=steel, cut=(LATTICE, 2.4, 0.22))
        if kit.chance(0.5):
            barrel(kit, 0, lift + high + 0.2, x * 1.05, y * 1.02, 1.3, 7, cover, 0.05)
        else:
            kit.add(BOX, (0, 0, lift + high + 0.4), (x * 1.1, y * 1.05, 0.08), rotation=turn("y", -5), material=cover)
        kit.add(BOX, (-x * 0.92, 0, lift + high / 2), (0.04, y * 0.93, high / 2), material=dark if kit.chance(0.5) else cloth)
        for k in range(6):
            spot = np.array([x * 0.9, y * (0.3 * k - 0.75), lift + high - 0.35])
            kit.add(CYL, spot, (0.13, 0.13, 0.17), rotation=turn("y", 25), material=dark)
        for side in (-1, 1):
            for k in range(4):
                kit.add(BOX, (x * 1.0, side * y * 1.15, lift + high * 0.85 - 0.5 * k), (0.25, 0.4, 0.22), rotation=turn("y", 4 * k), material=dark)
            kit.between((x * 1.0, side * y * 1.15, 0), (x * 1.0, side * y * 1.15, lift + high * 0.9), 0.07, material=steel)
        kit.add(BOX, (-x * 0.85, 0, lift + high * 0.55), (0.05, y * 0.55, high * 0.3), material=lettered(kit))
    flight(kit, x * 0.2, y, lift, 0.5, deck, 3, axis=1)
    for py in (-y * 0.4, y * 0.1, y * 0.45):
        slab(kit, x * 0.8, py, lift, (0.18, 0.3, 0.15), dark, taper=(0.6, 1))
    kit.add(CYL, (-x * 0.4, 0, lift + 0.35), (0.4, 0.4, 0.25), rotation=ALONG_X, material=vivid(kit))


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
    wall, accent, brush, white, steel = tinted(kit, (WHITE, CREAM, BLUE, GREY), (PLAIN, RIBS), frequency=18), vivid(kit), vivid(kit, (STREAKS, STRIPES), frequency=30), tinted(kit, (WHITE,)), steelwork(kit)
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
        for px in (2.0, 3.9)[:: -side]:
            px += 0.5 * side
            kit.chain([(px, side * r, high), (px, side * r, 1.9), (px - 0.25, side * r, 1.0)], 0.045, steel, joints=False)
            kit.add(BOX, (px + 0.05, side * r, 1.02), (0.26, 0.5, 0.05), material=accent)
            kit.add(BOX, (px - 0.22, side * r, 1.35), (0.05, 0.5, 0.28), material=accent)
            kit.add(BOX, (px + 0.3, side * r, 1.35), (0.03, 0.5, 0.03), material=steel)
    slab(kit, -2.4, -1.5, 0.08, (0.8, 0.7, 1.1), wood)
    slab(kit, -2.4, -1.5, 2.28, (0.95, 0.85, 0.08), cover)
    kit.add(BOX, (-1.6, -1.5, 1.5), (0.04, 0.5, 0.4), material=glass)


def carousel(kit):
    rng = kit.rng
    base, cloth, gold, white = vivid(kit, (PLANKS, BANDS), frequency=12), striped(kit), tinted(kit, (GOLD, CREAM)), tinted(kit, (WHITE, CREAM))
    r, high, count = rng.uniform(2.2, 2.8), rng.uniform(2.5, 2.9), 7
    kit.add(CYL, (0, 0, 0.15), (r, r, 0.15), material=base)
    kit.add(CYL, (0, 0, 0.06), (r + 0.3, r + 0.3, 0.06), material=white)
    kit.add(PRISM, (0, 0, 0.3 + high / 2), (0.65, 0.65, high / 2), (1, 8), material=tinted(kit, (GOLD, RED, CREAM), (CHECKER, STRIPES, DOTS), frequency=12))
    kit.add(CYL, (0, 0, 0.3 + high), (r + 0.1, r + 0.1, 0.22), material=tinted(kit, (GOLD, RED, CREAM, BLUE), (DOTS, CHECKER, STRIPES), frequency=14, second=(0.8, 0.7, 0.4)))
    kit.add(CYL, (0, 0, 0.3 + high), (r + 0.14, r + 0.14, 0.05), material=gold)
    kit.add(PRISM, (0, 0, 0.5 + high + r * 0.2), (r + 0.15, r + 0.15, r * 0.22), (0.04, 16), material=cloth)
    kit.loft((0, 0, 0.5 + high + r * 0.4), [(0, 0.1), (0.2, 0.15), (0.3, 0.05), (0.7, 0.01)], gold)
    for k, (px, py) in enumerate(around(count, r * 0.78, 20)):
        spin, z = turn("z", np.degrees(np.arctan2(py, px)) + 90), 1.0 + 0.25 * (k % 3)
        at, coat = np.array([px, py, z]), tinted(kit, (WHITE, CREAM, WOOD, TIMBER, GREY), gloss=0.3)
        kit.between((px, py, 0.3), (px, py, 0.3 + high), 0.03, material=gold)
        kit.add(BALL, at, (0.42, 0.17, 0.18), rotation=spin, material=coat)
        kit.between(at + spin @ [0.28, 0, 0.05], at + spin @ [0.48, 0, 0.42], 0.11, CYL, 0.8, material=coat)
        kit.between(at + spin @ [0.43, 0, 0.42], at + spin @ [0.68, 0, 0.26], 0.085, CYL, 0.75, material=coat)
        kit.between(at + spin @ [0.25, 0, -0.08], at + spin @ [0.5, 0, -0.38], (0.05, 0.12), BOX, material=coat)
        kit.between(at + spin @ [-0.3, 0, -0.05], at + spin @ [-0.48, 0, -0.42], (0.05, 0.12), BOX, material=coat)
        kit.add(BOX, at + spin @ [0, 0, 0.13], (0.17, 0.18, 0.07), rotation=spin, material=vivid(kit))
    for px, py in around(6, r + 0.02):
        kit.add(BALL, (px * 1.05, py * 1.05, 0.3 + high - 0.22), (0.1, 0.1, 0.08), material=gold)


def swing_boat(kit):
    rng = kit.rng
    hull, second, steel, gold = vivid(kit), vivid(kit, (DOTS, CHECKER, PLAIN), frequency=14), steelwork(kit), tinted(kit, (GOLD, YELLOW))
    high, y, tilt = rng.uniform(4.5, 5.5), rng.uniform(1.5, 1.8), rng.uniform(-28, 28)
    pivot, swing = np.array([0, 0, high]), turn("y", tilt)
    slab(kit, 0, 0, 0, (3.4, y + 0.4, 0.15), tinted(kit, (GREY, WOOD, RED), (PLANKS, PLAIN)))
    for side in (-1, 1):
        for end in (-1, 1):
            kit.between((end * 2.5, side * y, 0.1), (0, side * y, high + 0.1), (0.16, 0.14), BOX, material=steel)
        kit.between((-1.4, side * y, high * 0.45), (1.4, side * y, high * 0.45), 0.08, BOX, material=steel)
        kit.add(CYL, (0, side * y, high), (0.4, 0.4, 0.14), rotation=ALONG_Y, material=gold)
    kit.between((0, -y, high), (0, y, high), 0.14, material=steel)
    drop = high - 1.3
    points = [(-2.9, 1.15), (-2.2, 0.35), (-1.1, 0.05), (0, 0), (1.1, 0.05), (2.2, 0.35), (2.9, 1.15)]
    for (x0, z0), (x1, z1) in zip(points[:-1], points[1:], strict=True):
        kit.between(pivot + swing @ [x0, 0, z0 - drop], pivot + swing @ [x1, 0, z1 - drop], (0.12, 0.85), BOX, material=hull)
        for side in (-0.85, 0.85):
            kit.between(pivot + swing @ [x0, side, z0 + 0.35 - drop], pivot + swing @ [x1, side, z1 + 0.35 - drop], (0.4, 0.06), BOX, material=hull)
            kit.between(pivot + swing @ [x0, side, z0 + 0.75 - drop], pivot + swing @ [x1, side, z1 + 0.75 - drop], 0.08, BOX, material=gold)
    for x in (-1.4, -0.5, 0.5, 1.4):
        kit.add(BOX, pivot + swing @ [x, 0, 0.5 - drop], (0.12, 0.78, 0.3), rotation=swing, material=second)
    for side in (-0.9, 0.9):
        for x in (-1.5, 1.5):
            kit.between(pivot + [0, side, 0], pivot + swing @ [x, side, 0.7 - drop], 0.07, material=steel)
    for end in (-1, 1):
        kit.between(pivot + swing @ [end * 2.85, 0, 1.3 - drop], pivot + swing @ [end * 3.1, 0, 2.3 - drop], 0.16, CYL, 0.6, material=gold)
        kit.add(BALL, pivot + swing @ [end * 3.2, 0, 2.4 - drop], (0.3, 0.2, 0.2), rotation=swing, material=gold)


def dovecote(kit):
    rng = kit.rng
    wall, cover, wood, dark = tinted(kit, (WHITE, CREAM, WOOD, STONE), (PLAIN, PLANKS, BRICKS), frequency=12), tiles(kit), timberwork(kit), kit.material(dark=True)
    sides, r, on_post = int(rng.choice([6, 8])), rng.uniform(0.5, 0.65), kit.chance(0.6)
    flat, lift = r * np.cos(np.pi / sides), rng.uniform(1.6, 2.2)
    tall = rng.uniform(0.9, 1.2)
    if on_post:
        slab(kit, 0, 0, 0, (0.1, 0.1, lift / 2), wood)
        for px, py in around(4, 1):
            kit.between((px * 0.05, py * 0.05, lift - 0.5), (px * r * 0.8, py * r * 0.8, lift), 0.05, BOX, material=wood)
            kit.between((px * 0.5, py * 0.5, 0.05), (px * 0.05, py * 0.05, 0.5), 0.05, BOX, material=wood)
    else:
        kit.add(PRISM, (0, 0, lift / 2), (r * 1.1, r * 1.1, lift / 2), (0.92, sides), material=masonry(kit))
        spin = turn("z", 180 / sides)
        kit.add(BOX, spin @ np.array([flat, 0, 0.6]), (0.12, r * 0.35, 0.6), rotation=spin, material=wood)
    kit.add(PRISM, (0, 0, lift + tall / 2), (r, r, tall / 2), (1, sides), material=wall)
    for z in (0.0, 0.5):
        kit.add(PRISM, (0, 0, lift + tall * z), (r + 0.17, r + 0.17, 0.03), (1, sides), material=wood)
        for k in range(sides):
            spin = turn("z", 360 / sides * (k + 0.5))
            kit.add(BOX, spin @ np.array([flat, 0, lift + tall * (z + 0.15)]), (0.012, 0.09, 0.11), rotation=spin, material=dark)
            kit.add(CYL, spin @ np.array([flat, 0, lift + tall * (z + 0.15) + 0.1]), (0.09, 0.09, 0.012), rotation=spin @ ALONG_X, material=dark)
    kit.add(PRISM, (0, 0, lift + tall + 0.3), (r + 0.25, r + 0.25, 0.3), (0.25, sides), material=cover)
    kit.add(PRISM, (0, 0, lift + tall + 0.72), (r * 0.24, r * 0.24, 0.14), (1, sides), material=wall)
    kit.add(PRISM, (0, 0, lift + tall + 0.98), (r * 0.38, r * 0.38, 0.14), (0.05, sides), material=cover)
    for k in range(3):
        spin = turn("z", 120 * k + 20)
        kit.add(BALL, spin @ np.array([r + 0.08, 0, lift + 0.13]), (0.11, 0.06, 0.07), rotation=spin, material=tinted(kit, (WHITE, GREY)))
        kit.add(BALL, spin @ np.array([r + 0.18, 0, lift + 0.21]), (0.04, 0.04, 0.04), material=tinted(kit, (WHITE, GREY)))


def beehives(kit):
    rng = kit.rng
    wood, dark, metal, count = timberwork(kit), kit.material(dark=True), tinted(kit, (GREY, WHITE)), int(rng.integers(1, 4))
    kind = rng.choice(["box", "skep", "slatted"])
    slab(kit, 0, 0, 0.28, (0.4, 0.55 * count, 0.05), wood)
    posts(kit, (-0.28, 0.28), np.linspace(-0.5 * count, 0.5 * count, count + 1), 0, 0.3, 0.06, wood)
    for y in row(count, 0.58 * count, 1):
        paint = vivid(kit, (PLAIN, PLANKS), frequency=8) if kit.chance(0.6) else tinted(kit, (WHITE, CREAM, WOOD))
        z = 0.38
        if kind == "skep":
            straw = tinted(kit, (OCHRE, THATCH), (BANDS,), frequency=rng.uniform(18, 30), gloss=0.0)
            for k in range(6):
                wide = 0.4 * np.sqrt(max(1 - (k / 6.2) ** 2, 0.02))
                kit.add(CYL, (0, y, z + 0.055 + 0.1 * k), (wide, wide, 0.055), (0.95, 1), material=straw)
                kit.add(TUBE, (0, y, z + 0.055 + 0.1 * k), (wide + 0.02, wide + 0.02, 0.02), material=straw)
            kit.add(BOX, (0.37, y, z + 0.07), (0.06, 0.09, 0.06), material=dark)
            kit.add(BALL, (0, y, z + 0.63), (0.07, 0.07, 0.07), material=straw)
            continue
        boxes = int(rng.integers(2, 5))
        kit.add(BOX, (0.06, y, z + 0.04), (0.44, 0.36, 0.04), material=wood)
        for k in range(boxes):
            high = 0.13 if k == 0 or kit.chance(0.6) else 0.09
            kit.add(BOX, (0, y, z + 0.08 + high), (0.36, 0.34, high), (1.08, 1.08) if kind == "slatted" else (1, 1), material=paint if k % 2 == 0 or kind == "slatted" else paint._replace(first=paint.second))
            kit.add(BOX, (0, y, z + 0.08 + high * 1.3), (0.375, 0.08, 0.02), material=dark)
            z += 2 * high
        kit.add(BOX, (0.36, y, 0.5), (0.015, 0.2, 0.025), material=dark)
        kit.add(BOX, (0, y, z + 0.12), (0.4, 0.38, 0.05), material=metal)
        if kind == "slatted":
            roof(kit, (0, y, z + 0.16), (0.36, 0.33), 0.2, "gable", 0.06, metal, paint)
        else:
            slab(kit, 0, y, z + 0.17, (0.12, 0.08, 0.05), brickwork(kit))


def kennel(kit):
    rng = kit.rng
    wall, cover, frame, dark, coat = boards(kit), tiles(kit), trim(kit), kit.material(dark=True), tinted(kit, (WOOD, TIMBER, CREAM, OCHRE, WHITE, (0.1, 0.08, 0.07)), (PLAIN, CLOUDY))
    x, y, high = rng.uniform(0.5, 0.7), rng.uniform(0.36, 0.46), rng.uniform(0.55, 0.7)
    slab(kit, 0, 0, 0, (x + 0.04, y + 0.04, 0.05), frame)
    kit.add(BOX, (0, y, 0.1 + high / 2), (x, 0.025, high / 2), material=wall, mirror=True)
    kit.add(BOX, (-x, 0, 0.1 + high / 2), (0.025, y, high / 2), material=wall)
    kit.add(BOX, (x, y * 0.8, 0.1 + high / 2), (0.025, y * 0.22, high / 2), material=wall, mirror=True)
    rise = y * rng.uniform(0.7, 1.1)
    for end in (-1, 1):
        kit.add(BOX, (end * x, 0, 0.1 + high + rise / 2), (0.025, y, rise / 2), (1, 0.02), material=wall)
    kit.add(BOX, (x, 0, 0.1 + high - 0.05), (0.027, y * 0.62, 0.06), material=wall)
    for side in (-1, 1):
        kit.add(BOX, (x + 0.02, side * y * 0.6, 0.1 + high * 0.45), (0.02, 0.03, high * 0.45), material=frame)
    kit.add(BOX, (x + 0.02, 0, 0.1 + high * 0.92), (0.02, y * 0.66, 0.03), material=frame)
    leaves(kit, (0.05, 0, 0.1 + high), np.eye(3), x + 0.14, (y + 0.12, -0.12 * rise / y), (0, rise), 0.025, cover)
    kit.add(BOX, (x + 0.05, 0, 0.1 + high + rise * 0.35), (0.015, y * 0.4, 0.06), material=lettered(kit))
    if kit.chance(0.7):
        kit.add(BALL, (x - 0.1, 0, 0.3), (0.35, 0.16, 0.2), material=coat)
        kit.add(BALL, (x + 0.17, 0, 0.5), (0.15, 0.13, 0.13), material=coat)
        kit.add(CYL, (x + 0.32, 0, 0.46), (0.065, 0.075, 0.09), (0.8, 1), rotation=ALONG_X, material=coat)
        kit.add(BALL, (x + 0.42, 0, 0.48), (0.03, 0.035, 0.03), material=dark)
        kit.add(BALL, (x + 0.12, 0.13, 0.48), (0.06, 0.03, 0.12), material=tinted(kit, (TIMBER, WOOD)), mirror=True)
        kit.add(BALL, (x + 0.28, 0.06, 0.55), (0.02, 0.02, 0.02), material=dark, mirror=True)
        kit.chain([(x + 0.02, 0.11, 0.3), (x + 0.12, 0.1, 0.06), (x + 0.22, 0.1, 0.04)], [0.06, 0.045, 0.05], coat, mirror=True)
        kit.add(TUBE, (x + 0.08, 0, 0.41), (0.12, 0.12, 0.03), material=vivid(kit))
    slab(kit, x + 0.12, 0, 0, (0.22, y * 0.8, 0.025), frame)
    kit.add(CYL, (x + 0.55, -y * 0.9, 0.05), (0.15, 0.15, 0.05), (0.8, 1), material=vivid(kit))
    slab(kit, x + 0.4, -y * 0.9, 0, (0.2, 0.2, 0.008), frame)
    if kit.chance(0.3):
        for start, end in (((-x, -y - 0.5), (x + 1.1, -y - 0.5)), ((-x, y + 0.5), (x + 1.1, y + 0.5)), ((x + 1.1, -y - 0.5), (x + 1.1, y + 0.5)), ((-x, -y - 0.5), (-x, y + 0.5))):
            kit.railing((*start, 0), (*end, 0), 1.0, steelwork(kit), 0.12)


def hen_house(kit):
    rng = kit.rng
    wall, cover, frame, dark, mesh = boards(kit), tiles(kit), timberwork(kit), kit.material(dark=True), tinted(kit, (GREY, TIMBER))
    x, y, lift, high = rng.uniform(0.5, 0.65), rng.uniform(0.6, 0.9), rng.uniform(0.5, 0.8), rng.uniform(0.6, 0.8)
    run = rng.uniform(1.2, 1.8)
    posts(kit, (-x, x), (-y, y), 0, lift + high, 0.05, frame)
    slab(kit, 0, 0, lift, (x, y, high / 2), wall)
    roof(kit, (0, 0, lift + high), (x, y), rng.uniform(0.25, 0.5), rng.choice(["gable", "shed", "gable"]), 0.14, cover, wall)
    kit.add(BOX, (x + 0.02, 0, lift + 0.24), (0.02, 0.16, 0.2), material=dark)
    kit.between((x, 0, lift), (x + lift * 1.25, 0, 0.02), (0.02, 0.16), BOX, material=frame)
    kit.between((x, 0, lift + 0.03), (x + lift * 1.25, 0, 0.05), (0.02, 0.16), BOX, material=frame, cut=(RUNGS, 9, 0.3))
    kit.add(BOX, (0, y + 0.14, lift + 0.2), (x * 0.9, 0.16, 0.18), material=wall)
    kit.add(BOX, (0, y + 0.15, lift + 0.4), (x * 0.95, 0.2, 0.025), rotation=turn("x", -14), material=cover)
    for side in (-1, 1):
        kit.add(BOX, (x + run / 2, side * y, lift * 0.75), (run / 2, 0.02, lift * 0.75), material=mesh, cut=(LATTICE, 10, 0.14))
        kit.between((x, side * y, lift * 1.5), (x + run, side * y, lift * 1.5), 0.03, BOX, material=frame)
        kit.between((x, side * y, 0.03), (x + run, side * y, 0.03), 0.03, BOX, material=frame)
        posts(kit, (x + run,), (side * y,), 0, lift * 1.5, 0.04, frame)
    kit.add(BOX, (x + run, 0, lift * 0.75), (0.02, y, lift * 0.75), material=mesh, cut=(LATTICE, 10, 0.14))
    kit.between((x + run, -y, lift * 1.5), (x + run, y, lift * 1.5), 0.03, BOX, material=frame)
    lights(kit, (0, 0, lift + high * 0.6), (x, y), [0], (0.16, 0.14), dark, frame, 1)
    for k in range(int(rng.integers(1, 4))):
        at, spin = np.array([x + run * (0.45 + 0.25 * k) - 0.1, y * (0.5 if k % 2 else -0.5), 0.0]), turn("z", rng.uniform(0, 360))
        coat, red = tinted(kit, (WHITE, WOOD, (0.3, 0.1, 0.03), TIMBER)), kit.material(base=(0.6, 0.03, 0.03), pattern=PLAIN)
        kit.add(BALL, at + [0, 0, 0.24], (0.17, 0.11, 0.12), rotation=spin, material=coat)
        kit.between(at + spin @ [0.1, 0, 0.27], at + spin @ [0.17, 0, 0.42], 0.055, CYL, 0.8, material=coat)
        kit.add(BALL, at + spin @ [0.18, 0, 0.44], (0.05, 0.045, 0.05), rotation=spin, material=coat)
        kit.add(BOX, at + spin @ [0.18, 0, 0.5], (0.04, 0.012, 0.03), rotation=spin, material=red)
        kit.between(at + spin @ [-0.08, 0, 0.26], at + spin @ [-0.24, 0, 0.42], (0.08, 0.05), BOX, 0.6, material=coat)
        kit.between(at + [0, 0, 0.16], at, 0.025, material=tinted(kit, (YELLOW,)))
        kit.add(BOX, at + spin @ [0.03, 0, 0.01], (0.06, 0.05, 0.01), rotation=spin, material=tinted(kit, (YELLOW,)))


def bird_table(kit):
    rng = kit.rng
    wood, cover, seed = timberwork(kit), tiles(kit), tinted(kit, (OCHRE, SAND), (SPECKLES,), frequency=40)
    lift, x, y, high = rng.uniform(1.1, 1.5), rng.uniform(0.28, 0.36), rng.uniform(0.32, 0.45), rng.uniform(0.3, 0.42)
    kit.add(CYL, (0, 0, lift / 2), (0.045, 0.045, lift / 2), material=wood)
    feet = rng.choice(["cross", "tripod", "disc"])
    if feet == "disc":
        kit.add(CYL, (0, 0, 0.04), (0.3, 0.3, 0.04), (0.9, 1), material=masonry(kit))
    else:
        for px, py in around(4 if feet == "cross" else 3, 1):
            kit.between((px * 0.42, py * 0.42, 0.02), (0, 0, 0.05 if feet == "cross" else 0.55), 0.04, BOX, material=wood)
            if feet == "cross":
                kit.between((px * 0.3, py * 0.3, 0.04), (0, 0, 0.4), 0.025, BOX, material=wood)
    for px, py in around(4, 1):
        kit.between((0, 0, lift - 0.3), (px * x * 0.8, py * y * 0.7, lift), 0.025, BOX, material=wood)
    kit.add(BOX, (0, 0, lift), (x, y, 0.02), material=wood)
    for side in (-1, 1):
        kit.add(BOX, (side * x, 0, lift + 0.03), (0.015, y, 0.04), material=wood)
        kit.add(BOX, (0, side * y, lift + 0.03), (x, 0.015, 0.04), material=wood)
    posts(kit, (-x * 0.92, x * 0.92), (-y * 0.92, y * 0.92), lift, lift + high, 0.022, wood)
    rise = rng.uniform(0.18, 0.32)
    leaves(kit, (0, 0, lift + high), turn("z", 90), y + 0.08, (x + 0.1, -0.06), (0, rise), 0.018, cover)
    for side in (-1, 1):
        kit.add(BOX, (0, side * y * 0.9, lift + high + rise / 2), (x, 0.015, rise / 2), (0.03, 1), material=wood)
    kit.add(BALL, (0.03, 0.02, lift + 0.03), (x * 0.6, y * 0.55, 0.04), material=seed)
    for k in range(int(rng.integers(1, 4))):
        at, spin = np.array([x * (0.95 if k else 0.2), y * (0.5 - 0.55 * k), lift + 0.11]), turn("z", rng.uniform(0, 360))
        coat = tinted(kit, ((0.1, 0.15, 0.3), WOOD, GREY, (0.4, 0.1, 0.03), YELLOW))
        kit.add(BALL, at + [0, 0, 0.03], (0.085, 0.055, 0.055), rotation=spin, material=coat)
        kit.add(BALL, at + spin @ [0.07, 0, 0.09], (0.042, 0.04, 0.04), rotation=spin, material=tinted(kit, (TIMBER, GREY, (0.1, 0.15, 0.3))))
        kit.between(at + spin @ [0.1, 0, 0.09], at + spin @ [0.145, 0, 0.085], 0.013, CYL, 0.3, material=kit.material(dark=True))
        kit.between(at + spin @ [-0.06, 0, 0.03], at + spin @ [-0.18, 0, 0.07], (0.012, 0.03), BOX, material=coat)
        kit.between(at, at - [0, 0, 0.06], 0.01, material=kit.material(dark=True))


def pierced(kit, axis, at, half, count, material, share=0.55, thick=0.14):
    """A wall whose `count` windows are openings: `axis` is its normal, `at` its middle, `half` (along it, up); the solid rest closes one end."""
    long, high = half
    even = count % 2 == 0
    pitch = 2 * long / (count + (3 * share if even else 2 - share))
    off = pitch * (share if even else share - 1) / 2
    for move, wide, cut in ((-off, long - abs(off), (BARS, 1 / pitch, share)), (np.sign(off) * (long - abs(off)), abs(off), None)):
        centre = np.array(at, float) + np.eye(3)[1 - axis] * move
        reach = (thick, wide, high) if axis == 0 else (wide, thick, high)
        kit.add(BOX, centre, reach, material=material, **({"cut": cut} if cut else {}))


def block(kit, at, half, storeys, counts, wall, glass, course=None, share=0.55, back=None):
    """Storeys [3.2 high by default `half` up] around a body of glass: windows set in on all sides, `counts` (front, back, sides) of them; ledges of `course`."""
    (x, y, z), (hx, hy, hz), step = at, half, 2 * half[2] / storeys
    kit.add(BOX, (x, y, z + hz), (hx - 0.2, hy - 0.2, hz - 0.02), material=glass)
    for k in range(storeys):
        middle = z + step * (k + 0.5)
        pierced(kit, 0, (x + hx - 0.14, y, middle), (hy, step / 2), counts[0], wall, share)
        pierced(kit, 0, (x - hx + 0.14, y, middle), (hy, step / 2), counts[1], back or wall, share)
        for side in (-1, 1):
            pierced(kit, 1, (x, y + side * (hy - 0.14), middle), (hx, step / 2), counts[2], wall, share)
        if course is not None:
            kit.add(BOX, (x, y, z + step * (k + 1)), (hx + 0.06, hy + 0.06, 0.1), material=course)


def fronted(kit, at, half, storeys, count, wall, glass, frame, sides=2, size=(0.45, 0.65), course=True):
    """A plain body with framed windows on all sides and a plinth, for what has many other parts."""
    x, y, z = at
    hx, hy, hz = half
    kit.add(BOX, (x, y, z + hz), half, material=wall)
    for k in range(storeys):
        level = z + 2 * hz * (k + 0.55) / storeys
        lights(kit, (x, y, level), (hx, hy), row(count, hy, 0.9), size, glass, frame, 0, False)
        if sides:
            lights(kit, (x, y, level), (hx, hy), row(sides, hx, 0.9), size, glass, frame, 1, False)
    if course:
        kit.add(BOX, (x, y, z + 0.25), (hx + 0.08, hy + 0.08, 0.25), material=frame)


def portico(kit, x, z, wide, high, deep, count, stone, rise=0.0):
    """Columns on steps before the wall at `x`, under an entablature and a pediment."""
    for k in range(3):
        slab(kit, x + deep / 2 + 0.3 - 0.15 * k, 0, z / 3 * k, (deep / 2 + 0.45 - 0.15 * k, wide + 0.5 - 0.12 * k, z / 6), stone)
    for y in np.linspace(-wide + 0.3, wide - 0.3, count):
        kit.add(CYL, (x + deep - 0.3, y, z + high / 2), (0.24, 0.24, high / 2), (0.85, 1), material=stone)
        kit.add(BOX, (x + deep - 0.3, y, z + high - 0.08), (0.32, 0.32, 0.1), material=stone)
    slab(kit, x + deep / 2, 0, z + high, (deep / 2 + 0.1, wide + 0.1, 0.3), stone)
    rise = rise or wide * 0.38
    kit.add(BOX, (x + deep / 2, 0, z + high + 0.6 + rise / 2), (deep / 2 + 0.2, wide + 0.25, rise / 2), (1, 0.02), material=stone)
    kit.add(BOX, (x + deep + 0.2, 0, z + high + 0.6 + rise * 0.38), (0.03, wide * 0.62, rise * 0.27), (1, 0.05), material=tinted(kit, (GREY, SAND)))


def flag(kit, x, y, z, tall, material):
    kit.between((x, y, z), (x, y, z + tall), 0.05, material=tinted(kit, (WHITE, GREY)))
    kit.add(BOX, (x - 0.55, y, z + tall - 0.35), (0.55, 0.02, 0.32), material=material)


def public_building(kit):
    """Town halls, schools, churches (Romanesque, Gothic, stave, Orthodox, clapboard, modern), mosques, synagogues, Hindu and Buddhist temples, pagodas, shrines, palaces,
    villas, farmsteads, terraces, tower blocks, skyscrapers, hotels, factories, warehouses, fire and police stations, embassies, hospitals, railway stations, museums,
    theatres, barracks, watermills, breweries, windmills, power stations, airport terminals, shops."""
    kinds = [town_hall, school, romanesque, gothic, stave, orthodox, clapboard, modern_church, mosque, synagogue, hindu_temple, stupa, pagoda, shrine, palace, villa, farmstead]
    kinds += [terrace, tower_block, skyscraper, hotel, factory, warehouse, fire_station, police_post, embassy, hospital, station, museum, theatre, barracks, watermill, brewery]
    kinds += [windmill, power_station, terminal, shop]
    kinds[kit.rng.integers(len(kinds))](kit)


def town_hall(kit):
    rng = kit.rng
    wall, cover, stone, glass = walls_of(kit), tiles(kit), masonry(kit), panes(kit)
    x, y, high, count = rng.uniform(3.5, 4.5), rng.uniform(5.5, 7.5), rng.uniform(6.4, 7.4), int(rng.choice([5, 7]))
    block(kit, (0, 0, 0), (x, y, high / 2), 2, (count, count - 1, 4), wall, glass, stone)
    roof(kit, (0, 0, high), (x, y), x * rng.uniform(0.6, 0.9), rng.choice(["hip", "mansard", "gable"]), 0.35, cover, wall, 1)
    half, tall = rng.uniform(1.0, 1.3), high + x + rng.uniform(1.5, 3.5)
    front = x - half + 0.5 if kit.chance(0.5) else 0.0
    slab(kit, front, 0, 0, (half, half, tall / 2), wall)
    clock(kit, (front, 0, tall - 0.9), half, half * 0.55, stone)
    slab(kit, front, 0, tall, (half + 0.2, half + 0.2, 0.12), stone)
    if kit.chance(0.5):
        onion(kit, front, 0, tall + 0.2, half * 0.9, tinted(kit, (COPPER, SLATE)))
    else:
        spire(kit, front, 0, tall + 0.2, half + 0.1, half * rng.uniform(2, 3.5), cover)
    door(kit, (max(x, front + half), 0, 0.4), (0.65, 1.15), leaf(kit), stone)
    flight(kit, max(x, front + half), 0, 0.45, 1.2, stone, 3)
    flag(kit, x + 1.4, -2.2, 0, 5, vivid(kit, (STRIPES, BANDS), frequency=5))


def school(kit):
    rng = kit.rng
    wall, cover, stone, glass = walls_of(kit), tiles(kit), masonry(kit), panes(kit)
    x, y, storeys, count = rng.uniform(3, 4), rng.uniform(6.5, 9), int(rng.choice([2, 2, 3])), int(rng.choice([8, 10]))
    high = 3.4 * storeys
    block(kit, (0, 0, 0), (x, y, high / 2), storeys, (count, count + 1, 3), wall, glass, stone if kit.chance(0.6) else None, 0.5)
    roof(kit, (0, 0, high), (x, y), x * 0.6, rng.choice(["hip", "gable", "flat"]), 0.4, cover, wall, 1)
    slab(kit, x + 0.6, 0, 0, (0.8, 1.5, high / 2 + 0.3), stone)
    roof(kit, (x + 0.6, 0, high + 0.6), (0.8, 1.5), 1.0, rng.choice(["gable", "flat"]), 0.25, cover, wall)
    door(kit, (x + 1.4, 0, 0.3), (0.9, 1.15), leaf(kit), stone)
    lights(kit, (x + 0.6, 0, high * 0.7), (0.8, 1.5), [0], (0.8, 0.7), glass, trim(kit), 0)
    flight(kit, x + 1.4, 0, 0.3, 1.2, stone, 2)
    kit.add(BOX, (x + 1.45, 0, high * 0.5), (0.04, 1.2, 0.25), material=lettered(kit))
    flag(kit, x + 2.6, 2.5, 0, 6, vivid(kit, (STRIPES,), frequency=5))
    slab(kit, -x * 0.3, y * 0.6, high, (0.35, 0.35, x * 0.4 + 0.5), brickwork(kit))


def nave(kit, x, y, high, rise, wall, cover, glass, count, buttress=None, head=0.42):
    """A gabled nave along x with round-headed windows and, perhaps, buttresses on both sides."""
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    roof(kit, (0, 0, high), (x, y), rise, "gable", 0.25, cover, wall)
    arched(kit, (0, 0, 0), (x, y), row(count, x), head, high * 0.32, high * 0.68, glass, 1)
    if buttress is not None:
        for k in range(count + 1):
            px = x * 0.8 * (2 * k / count - 1)
            kit.add(BOX, (px, y + 0.3, high * 0.42), (0.18, 0.4, high * 0.42), (1, 0.25), (0, -0.28), material=buttress, mirror=True)


def romanesque(kit):
    rng = kit.rng
    wall, cover, glass, stone = masonry(kit), tiles(kit), panes(kit), masonry(kit)
    x, y, high = rng.uniform(4.5, 6), rng.uniform(1.6, 2.1), rng.uniform(4.5, 5.5)
    nave(kit, x, y, high, y * 0.8, wall, cover, glass, 5, None, 0.3)
    slab(kit, 0, 0, 0, (x * 0.95, y + 1.3, high * 0.28), wall)
    for side in (-1, 1):
        kit.add(BOX, (0, side * (y + 0.65), high * 0.56 + 0.3), (x * 0.97, 0.85, 0.07), rotation=turn("x", -side * 24), material=cover)
    kit.add(CYL, (-x, 0, high * 0.4), (y * 0.85, y * 0.85, high * 0.4), material=wall)
    kit.add(CYL, (-x, 0, high * 0.8 + 0.5), (y * 0.95, y * 0.95, 0.5), (0.05, 1), material=cover)
    half, tall = rng.uniform(0.9, 1.15), high + rng.uniform(3, 4.5)
    for py in (-y, y) if kit.chance(0.6) else (0,):
        slab(kit, x + half * 0.6, py, 0, (half, half, tall / 2), wall)
        spire(kit, x + half * 0.6, py, tall, half + 0.15, rng.uniform(1.2, 2), cover)
        for z in (tall * 0.86, tall * 0.66):
            for facing in (0, 1):
                arched(kit, (x + half * 0.6, py, 0), (half, half), [0], half * 0.3, z - 0.5, z, glass, facing, 0.03)
    for grow, out, skin in ((1.0, 0.1, stone), (0.72, 0.16, leaf(kit))):
        kit.add(BOX, (x + half * 1.6, 0, 0.9), (out, 0.85 * grow, 0.9), material=skin)
        kit.add(CYL, (x + half * 1.6, 0, 1.8), (0.85 * grow, 0.85 * grow, out), rotation=ALONG_X, material=skin)
    slab(kit, x + half * 0.4, 0, 0, (half * 1.15, y * 0.8, high * 0.5), wall)


def gothic(kit):
    rng = kit.rng
    wall, cover, glass = masonry(kit), tiles(kit), panes(kit)
    x, y, high = rng.uniform(4.5, 5.5), rng.uniform(1.7, 2.2), rng.uniform(5.5, 7)
    nave(kit, x, y, high, y * 1.5, wall, cover, glass, 5, wall, 0.34)
    kit.add(PRISM, (-x, 0, high * 0.45), (y, y, high * 0.45), (1, 8), rotation=turn("z", 22.5), material=wall)
    kit.add(PRISM, (-x, 0, high * 0.9 + 1.0), (y * 1.1, y * 1.1, 1.0), (0.04, 8), rotation=turn("z", 22.5), material=cover)
    half, tall = rng.uniform(0.95, 1.2), high + rng.uniform(2.5, 4)
    twin = kit.chance(0.5)
    for py in (-y * 0.9, y * 0.9) if twin else (0,):
        slab(kit, x + 0.7, py, 0, (half, half, tall / 2), wall)
        spire(kit, x + 0.7, py, tall, half, rng.uniform(3, 5) if py >= 0 else 4, cover, 8)
        for cx, cy in around(4, half * 1.35, 45):
            if not twin:
                slab(kit, x + 0.7 + cx * 0.75, py + cy * 0.75, 0, (0.2, 0.2, tall / 2 + 0.3), wall)
                spire(kit, x + 0.7 + cx * 0.75, py + cy * 0.75, tall + 0.6, 0.22, 1.1, wall)
        arched(kit, (x + 0.7, py, 0), (half, half), [0], half * 0.35, tall * 0.68, tall * 0.86, glass, 0, 0.04)
    front = x + 0.7 + half if not twin else x + 0.3
    kit.add(BOX, (x + 0.1, 0, high / 2), (0.25, y * 0.9, high / 2), material=wall)
    kit.add(CYL, (front, 0, high * 0.62), (0.65, 0.65, 0.08), rotation=ALONG_X, material=glass, cut=(SPOKES, 8, 0.7))
    kit.add(CYL, (front - 0.03, 0, high * 0.62), (0.68, 0.68, 0.06), rotation=ALONG_X, material=wall)
    for grow, out in ((1.0, 0.1), (0.7, 0.16)):
        skin = wall if grow == 1 else leaf(kit)
        kit.add(BOX, (front, 0, 0.9), (out, 0.7 * grow, 0.9), material=skin)
        kit.add(BOX, (front, 0, 1.8 + 0.55 * grow), (out, 0.7 * grow, 0.55 * grow), (1, 0.05), material=skin)


def stave(kit):
    rng = kit.rng
    wall, cover, frame = tinted(kit, (TIMBER, WOOD, (0.12, 0.07, 0.04)), (STRIPES, PLANKS), frequency=22, gloss=0.0), tinted(kit, (TIMBER, SLATE, WOOD), (SHINGLES,), frequency=22), timberwork(kit)
    x, y = rng.uniform(2.6, 3.2), rng.uniform(2.0, 2.4)
    z, last = 0.3, 0.0
    slab(kit, 0, 0, 0, (x + 0.9, y + 0.9, 0.15), masonry(kit))
    for k, (share, tall) in enumerate(((1.0, 1.3), (0.72, 1.5), (0.42, 1.3), (0.2, 0.9))):
        hx, hy = x * share, y * share
        slab(kit, 0, 0, z, (hx, hy, tall / 2 + 0.3), wall)
        z += tall
        rise = y * share * (0.75 if k < 3 else 3)
        if k == 0:
            kit.add(BOX, (0, 0, z + 0.35), (hx + 0.75, hy + 0.75, 0.4), (0.72, 0.68), material=cover)
            z += 0.5
        elif k < 3:
            roof(kit, (0, 0, z), (hx, hy), rise, "gable", 0.3, cover, wall)
            for end in (-1, 1):
                kit.between((end * (hx + 0.3), 0, z + rise), (end * (hx + 0.75), 0, z + rise + 0.45), 0.07, BOX, 0.5, material=frame)
            z += rise * 0.55
        else:
            spire(kit, 0, 0, z, hx + 0.15, rise, cover)
        last = z
    cross(kit, 0, 0, last + y * 0.6, 0.5, frame)
    posts(kit, np.linspace(-x - 0.6, x + 0.6, 4), (-y - 0.6, y + 0.6), 0.3, 1.6, 0.07, frame)
    slab(kit, x + 0.6, 0, 0.3, (0.8, 0.65, 0.75), wall)
    roof(kit, (x + 0.6, 0, 1.8), (0.8, 0.65), 0.8, "gable", 0.25, cover, wall)
    door(kit, (x + 1.4, 0, 0.3), (0.32, 0.62), leaf(kit), frame)
    kit.add(CYL, (-x - 0.4, 0, 1.0), (0.8, 0.8, 1.0), material=wall)
    kit.add(CYL, (-x - 0.4, 0, 2.4), (1.0, 1.0, 0.5), (0.05, 1), material=cover)


def orthodox(kit):
    rng = kit.rng
    wall, glass, gold = tinted(kit, (WHITE, CREAM, WHITE, BLUE, RED), (PLAIN, CLOUDY)), panes(kit), tinted(kit, (GOLD, GOLD, GREEN, BLUE, COPPER), gloss=0.5)
    cap, metal = tinted(kit, (GREEN, GREY, SLATE)), tinted(kit, (GOLD,), gloss=0.6)
    x, high = rng.uniform(2.4, 3.0), rng.uniform(5, 6.5)
    slab(kit, 0, 0, 0, (x, x, high / 2), wall)
    for axis in (0, 1):
        for place in row(3, x, 1):
            spot = (0, place, high) if axis == 0 else (place, 0, high)
            kit.add(CYL, spot, (x / 3, x / 3, x + 0.05), rotation=ALONG_X if axis == 0 else ALONG_Y, material=wall)
        arched(kit, (0, 0, 0), (x, x), (-x * 2 / 3, x * 2 / 3), 0.24, high * 0.45, high * 0.72, glass, axis)
    kit.add(BOX, (0, 0, high + 0.3), (x * 0.98, x * 0.98, 0.45), (0.5, 0.5), material=cap)
    for px, py, r, tall in ((0, 0, 0.75, 2.6), (x * 0.6, x * 0.6, 0.48, 1.9), (-x * 0.6, x * 0.6, 0.48, 1.9), (x * 0.6, -x * 0.6, 0.48, 1.9), (-x * 0.6, -x * 0.6, 0.48, 1.9)):
        kit.add(CYL, (px, py, high + tall / 2), (r, r, tall / 2), material=wall)
        onion(kit, px, py, high + tall, r * 1.15, gold)
        cross(kit, px, py, high + tall + r * 2.5, 0.55, metal)
    slab(kit, x + 0.6, 0, 0, (0.7, 0.9, 1.3), wall)
    roof(kit, (x + 0.6, 0, 2.6), (0.7, 0.9), 0.9, "gable", 0.2, cap, wall)
    door(kit, (x + 1.3, 0, 0), (0.42, 0.85), leaf(kit), metal)
    kit.add(CYL, (-x, 0, high * 0.35), (x * 0.45, x * 0.45, high * 0.35), material=wall)
    kit.add(BALL, (-x, 0, high * 0.7), (x * 0.46, x * 0.46, x * 0.35), material=cap)


def clapboard(kit):
    rng = kit.rng
    wall, cover, glass, frame = tinted(kit, (WHITE, WHITE, WHITE, CREAM, RED), (PLANKS, BANDS), frequency=26), tiles(kit), panes(kit), tinted(kit, (WHITE,))
    x, y, high = rng.uniform(4, 5.2), rng.uniform(2.2, 2.8), rng.uniform(3.6, 4.4)
    nave(kit, x, y, high, y * rng.uniform(0.7, 1.1), wall, cover, glass, 4, None, 0.36)
    lights(kit, (0, 0, high * 0.5), (x, y), (-y * 0.6, y * 0.6), (0.3, 0.75), glass, frame, 0)
    slab(kit, 0, 0, 0, (x + 0.1, y + 0.1, 0.2), masonry(kit))
    half, tall = rng.uniform(0.85, 1.1), high + y + rng.uniform(0.5, 1.5)
    slab(kit, x, 0, 0, (half, half, tall / 2), wall)
    slab(kit, x, 0, tall, (half + 0.15, half + 0.15, 0.08), frame)
    posts(kit, (x - half * 0.65, x + half * 0.65), (-half * 0.65, half * 0.65), tall, tall + 1.4, 0.12, frame)
    slab(kit, x, 0, tall + 1.35, (half * 0.85, half * 0.85, 0.1), frame)
    kit.add(BALL, (x, 0, tall + 0.75), (0.35, 0.35, 0.4), material=tinted(kit, (GOLD, TIMBER), gloss=0.5))
    kit.between((x, 0, tall + 1), (x, 0, tall + 1.4), 0.06, material=frame)
    spire(kit, x, 0, tall + 1.5, half * 0.75, rng.uniform(2.5, 4), cover, int(rng.choice([4, 8])))
    door(kit, (x + half, 0, 0.4), (0.5, 1.05), leaf(kit), frame)
    flight(kit, x + half, 0, 0.4, 0.9, masonry(kit), 3)
    kit.add(CYL, (x, 0, tall * 0.75), (0.35, 0.35, half + 0.05), rotation=ALONG_X, material=glass)


def modern_church(kit):
    rng = kit.rng
    wall, cover, glass, frame = tinted(kit, (WHITE, CONCRETE, BRICK), (PLAIN, BRICKS, CLOUDY), frequency=20), tiles(kit), vivid(kit, (CHECKER, DOTS), frequency=14), tinted(kit, (WOOD, GREY, WHITE))
    x, y, tall = rng.uniform(4, 5), rng.uniform(3, 4), rng.uniform(5, 8)
    if kit.chance(0.5):  # a tent of concrete or copper
        for k in range(4):
            px, size = x * (0.75 - 0.5 * k), 1 - 0.12 * k
            leaves(kit, (px, 0, 0), np.eye(3), x * 0.26, (y * size, 0.0), (0, tall * size), 0.1, cover)
            kit.add(BOX, (px + x * 0.24, 0, tall * size / 2), (0.03, y * size, tall * size / 2), (1, 0.02), material=glass if k == 0 else frame)
        kit.add(BOX, (-x * 0.98, 0, tall * 0.3), (0.05, y * 0.62, tall * 0.3), (1, 0.02), material=wall)
    else:
        kit.add(BOX, (0, 0, 2), (x, y, 2), (1, 0.95), material=wall)
        kit.add(BOX, (0, 0, 4 + tall * 0.15), (x + 0.4, y + 0.4, tall * 0.15), (1, 0.1), (0, y * 0.8), material=cover)
        for px in row(6, x):
            kit.add(BOX, (px, y, 2.1), (0.13, 0.06, 1.5), material=glass, mirror=True)
        kit.add(BOX, (x, 0, 2), (0.05, y * 0.4, 1.8), material=glass)
    door(kit, (x + 0.03, 0, 0), (0.8, 1.1), leaf(kit), frame)
    kit.add(BOX, (x + 0.8, 0, 2.5), (0.9, 1.6, 0.1), material=frame)
    posts(kit, (x + 1.5,), (-1.4, 1.4), 0, 2.5, 0.09, frame)
    kit.add(BOX, (x * 0.6, y + 2.0, tall * 0.75), (0.18, 0.8, tall * 0.75), material=wall)
    kit.add(BOX, (x * 0.6 + 0.8, y + 2.0, tall * 0.7), (0.18, 0.8, tall * 0.7), material=wall)
    kit.add(BOX, (x * 0.6 + 0.4, y + 2.0, tall * 1.2), (0.5, 0.6, 0.1), material=frame)
    cross(kit, x * 0.6, y + 2.0, tall * 1.5, 1.5, frame)
    slab(kit, 0, y + 1.3, 0, (x * 0.7, 1.4, 1.2), wall)


def mosque(kit):
    rng = kit.rng
    wall, skin, gold, glass = tinted(kit, (WHITE, CREAM, SAND, STONE), (PLAIN, CLOUDY, BRICKS), frequency=16), tinted(kit, (COPPER, GOLD, BLUE, GREY, WHITE), (PLAIN, SEAMS), gloss=0.3), tinted(kit, (GOLD,)), panes(kit)
    x, high, style = rng.uniform(3, 3.8), rng.uniform(3.4, 4.2), rng.choice(["round", "pointed", "onion"])
    slab(kit, 0, 0, 0, (x, x, high / 2), wall)
    slab(kit, 0, 0, high, (x + 0.1, x + 0.1, 0.12), wall)
    for axis in (0, 1):
        arched(kit, (0, 0, 0), (x, x), row(4, x) if axis else (-x * 0.65, x * 0.65), 0.3, high * 0.3, high * 0.62, glass, axis)
    kit.add(PRISM, (0, 0, high + 0.6), (x * 0.68, x * 0.68, 0.6), (1, 8), material=wall)
    dome(kit, (0, 0, high + 1.1), x * 0.6, style, skin, gold)
    for px, py in around(4, x * 1.0, 45):
        dome(kit, (px, py, high + 0.2), x * 0.22, "round", skin, gold)
    slab(kit, x + 0.7, 0, 0, (0.8, 1.3, high * 0.6), wall)
    kit.add(BOX, (x + 1.5, 0, 0.9), (0.04, 0.55, 0.9), material=glass)
    kit.add(CYL, (x + 1.5, 0, 1.8), (0.55, 0.55, 0.04), rotation=ALONG_X, material=glass)
    count, tall = int(rng.choice([1, 2, 2, 4])), high + rng.uniform(4, 6.5)
    for px, py in [(x + 0.2, x + 0.2), (x + 0.2, -x - 0.2), (-x - 0.2, x + 0.2), (-x - 0.2, -x - 0.2)][:count]:
        slab(kit, px, py, 0, (0.5, 0.5, high / 2), wall)
        kit.add(CYL, (px, py, (high + tall) / 2), (0.34, 0.34, (tall - high) / 2), (0.85, 1), material=wall)
        kit.add(CYL, (px, py, tall * 0.78), (0.55, 0.55, 0.1), material=gold)
        kit.add(CYL, (px, py, tall + 0.6), (0.33, 0.33, 0.65), (0.03, 1), material=skin)
        kit.between((px, py, tall + 1), (px, py, tall + 1.6), 0.04, material=gold)


def synagogue(kit):
    rng = kit.rng
    wall = kit.material(base=np.array(CREAM) * rng.uniform(0.7, 1.2), second=np.array((BRICK, SAND, GREY))[rng.integers(3)], pattern=rng.choice([BANDS, BRICKS]), frequency=rng.uniform(10, 18), gloss=0.02)
    skin, glass, stone, gold = tinted(kit, (COPPER, SLATE, GOLD)), panes(kit), masonry(kit), tinted(kit, (GOLD,), gloss=0.5)
    x, y, high = rng.uniform(4, 5), rng.uniform(2.8, 3.4), rng.uniform(4.6, 5.4)
    nave(kit, x, y, high, y * 0.5, wall, tiles(kit), glass, 4, None, 0.4)
    kit.add(BOX, (x, 0, high * 0.6), (0.25, y * 0.55, high * 0.6), material=wall)
    for side in (-1, 1):
        slab(kit, x - 0.2, side * y, 0, (0.8, 0.8, high / 2 + 0.5), wall)
        kit.add(PRISM, (x - 0.2, side * y, high + 1.4), (0.65, 0.65, 0.45), (1, 8), material=wall)
        dome(kit, (x - 0.2, side * y, high + 1.8), 0.65, "onion", skin, gold)
    kit.add(CYL, (x + 0.25, 0, high * 0.72), (0.95, 0.95, 0.06), rotation=ALONG_X, material=stone)
    kit.add(CYL, (x + 0.27, 0, high * 0.72), (0.8, 0.8, 0.08), rotation=ALONG_X, material=glass)
    for spin in (0, 180):
        for k in range(3):
            way = turn("x", 120 * k + spin)
            kit.add(BOX, np.array([x + 0.38, 0, high * 0.72]) + way @ [0, 0, -0.33], (0.03, 0.57, 0.04), rotation=way, material=gold)
    for py in (-1, 0, 1):
        kit.add(BOX, (x + 0.25, py * y * 0.3, 0.9), (0.08, 0.35, 0.8), material=leaf(kit))
        kit.add(CYL, (x + 0.25, py * y * 0.3, 1.7), (0.35, 0.35, 0.08), rotation=ALONG_X, material=glass)
    flight(kit, x + 0.25, 0, 0.3, y * 0.6, stone, 2)
    arched(kit, (x - 0.2, 0, 0), (0.8, y + 0.8), [0], 0.22, 1.8, 2.8, glass, 1)


def hindu_temple(kit):
    rng = kit.rng
    skin, gold, dark = tinted(kit, (SAND, STONE, WHITE, (0.45, 0.2, 0.12), OCHRE), (BANDS, SPECKLES, SEAMS, CLOUDY), frequency=18, gloss=0.02), tinted(kit, (GOLD,), gloss=0.5), kit.material(dark=True)
    slab(kit, 0, 0, 0, (5, 2.6, 0.4), skin)
    flight(kit, 5, 0, 0.8, 0.9, skin, 4)
    south = kit.chance(0.5)
    tall, r = rng.uniform(5, 7), 1.9
    slab(kit, -2.6, 0, 0.8, (r, r, 1.1), skin)
    count = 8
    for k in range(count):
        share, after = k / count, (k + 1) / count
        wide = r * (1 - 0.72 * (share if south else share**2.2))
        slab(kit, -2.6, 0, 3 + tall * share, (wide, wide, tall / count * 0.5), vivid(kit, (DOTS, SPECKLES), frequency=25) if south and k % 2 else skin, taper=(0.9, 0.9))
        if k < 5:
            kit.add(BOX, (-2.6, 0, 3 + tall * (share + after) / 2), (wide * 1.12, wide * 0.3, tall / count * 0.38), (0.9, 0.9), material=skin)
            kit.add(BOX, (-2.6, 0, 3 + tall * (share + after) / 2), (wide * 0.3, wide * 1.12, tall / count * 0.38), (0.9, 0.9), material=skin)
    top = 3 + tall
    if south:
        kit.add(CYL, (-2.6, 0, top), (0.5, 0.5, 0.9), rotation=ALONG_Y, material=skin)
    else:
        kit.add(BALL, (-2.6, 0, top + 0.15), (0.7, 0.7, 0.28), material=skin)
    kit.loft((-2.6, 0, top + 0.3), [(0, 0.2), (0.25, 0.28), (0.4, 0.1), (0.8, 0.01)], gold)
    for x, wide, rise in ((0.3, 1.5, 1.6), (2.7, 1.2, 1.1)):
        slab(kit, x, 0, 0.8, (1.0, wide * 0.75, 1.0), skin)
        posts(kit, (x - 0.9, x + 0.9), (-wide, wide), 0.8, 2.8, 0.14, skin)
        slab(kit, x, 0, 2.8, (1.3, wide + 0.3, 0.12), skin)
        for k in range(3):
            slab(kit, x, 0, 3.04 + rise * k / 3, (1.15 - 0.3 * k, wide - 0.3 * k, rise / 6), skin, taper=(0.8, 0.8))
        kit.add(BALL, (x, 0, 3.1 + rise), (0.25, 0.25, 0.25), material=gold)
    kit.add(BOX, (3.72, 0, 1.6), (0.04, 0.45, 0.8), material=dark)


def stupa(kit):
    rng = kit.rng
    skin, gold, stone = tinted(kit, (WHITE, WHITE, GOLD, SAND, BRICK), (PLAIN, CLOUDY, BRICKS), frequency=14), tinted(kit, (GOLD,), gloss=0.6), masonry(kit)
    r = rng.uniform(2.2, 3)
    bell = kit.chance(0.5)
    for k in range(3):
        slab(kit, 0, 0, 0.5 * k, (r * (1.5 - 0.17 * k), r * (1.5 - 0.17 * k), 0.25), stone)
    for way in range(4):
        spin = turn("z", 90 * way)
        kit.add(BOX, spin @ np.array([r * 1.5, 0, 0.75]), (0.75, 0.5, 0.75), (0.1, 1), (-0.6, 0), rotation=spin, material=stone)
        kit.add(BOX, spin @ np.array([r * 1.02, 0, 2.2]), (0.3, 0.5, 0.7), rotation=spin, material=skin)
        kit.add(BOX, spin @ np.array([r * 1.02 + 0.1, 0, 3.1]), (0.3, 0.6, 0.3), (1, 0.05), rotation=spin, material=gold)
        kit.add(BOX, spin @ np.array([r * 1.02 + 0.31, 0, 2.1]), (0.02, 0.28, 0.5), rotation=spin, material=kit.material(dark=True))
    kit.add(CYL, (0, 0, 1.75), (r * 1.08, r * 1.08, 0.25), material=skin)
    if bell:
        kit.loft((0, 0, 2), [(0, r), (0.3, r * 0.9), (1.2, r * 0.7), (2.2, r * 0.58), (2.9, r * 0.42), (3.2, r * 0.2)], skin)
        top = 5.2
    else:
        kit.add(BALL, (0, 0, 2), (r, r, r * 0.95), material=skin)
        top = 2 + r * 0.93
        slab(kit, 0, 0, top - 0.1, (r * 0.27, r * 0.27, 0.35), gold)
        top += 0.55
    count = 9
    for k in range(count):
        wide = r * 0.24 * (1 - 0.85 * k / count)
        kit.add(CYL, (0, 0, top + 0.11 + 0.22 * k), (wide, wide, 0.12), (0.82, 1), material=gold)
    kit.loft((0, 0, top + 0.22 * count), [(0, 0.1), (0.15, 0.22), (0.25, 0.05), (0.8, 0.01)], gold)
    for px, py in around(4, r * 1.75, 45):
        slab(kit, px, py, 0, (0.35, 0.35, 0.5), stone)
        kit.loft((px, py, 1), [(0, 0.32), (0.4, 0.3), (0.6, 0.12), (1.3, 0.01)], skin)


def pagoda(kit):
    rng = kit.rng
    wall, cover, frame, gold, stone = tinted(kit, (RED, WHITE, WOOD)), tinted(kit, (SLATE, GREEN, GREY, OCHRE), (RIBS, SHINGLES), frequency=18), tinted(kit, (RED, TIMBER, WOOD)), tinted(kit, (GOLD,)), masonry(kit)
    sides, levels, r = int(rng.choice([4, 4, 6, 8])), int(rng.integers(3, 8)), rng.uniform(1.7, 2.2)
    spin = turn("z", 45 if sides == 4 else 0)
    grow = 1.414 if sides == 4 else 1
    kit.add(PRISM, (0, 0, 0.3), (r * grow * 1.4, r * grow * 1.4, 0.3), (0.96, sides), rotation=spin, material=stone)
    z = 0.6
    for k in range(levels):
        size = r * (1 - 0.55 * k / levels)
        tall = 1.5 * (1 - 0.35 * k / levels)
        kit.add(PRISM, (0, 0, z + tall / 2), (size * grow * 0.8, size * grow * 0.8, tall / 2), (1, sides), rotation=spin, material=wall)
        kit.add(PRISM, (0, 0, z + tall * 0.95), (size * grow * 1.5, size * grow * 1.5, 0.1), (0.97, sides), rotation=spin, material=frame)
        kit.add(PRISM, (0, 0, z + tall + 0.15), (size * grow * 1.55, size * grow * 1.55, 0.17), (0.72, sides), rotation=spin, material=cover)
        kit.add(PRISM, (0, 0, z + tall + 0.5), (size * grow * 1.1, size * grow * 1.1, 0.22), (0.6, sides), rotation=spin, material=cover)
        kit.add(PRISM, (0, 0, z + tall * 0.28), (size * grow * 0.98, size * grow * 0.98, 0.05), (1, sides), rotation=spin, material=frame)
        z += tall + 0.4
    kit.add(PRISM, (0, 0, z + 0.45), (r * 0.62 * grow, r * 0.62 * grow, 0.4), (0.05, sides), rotation=spin, material=cover)
    kit.loft((0, 0, z + 0.7), [(0, 0.12), (0.5, 0.1), (0.6, 0.25), (0.8, 0.25), (0.9, 0.08), (2.0, 0.01)], gold)
    kit.add(BOX, (r * 0.82, 0, 1.2), (0.05, 0.4, 0.55), material=leaf(kit))
    flight(kit, r * 1.35, 0, 0.6, 0.7, stone, 3)


def shrine(kit):
    rng = kit.rng
    red, cover, wall, stone, dark = tinted(kit, ((0.6, 0.09, 0.03), (0.5, 0.06, 0.03), WOOD, GREY)), tinted(kit, (SLATE, COPPER, TIMBER), (SHINGLES, RIBS), frequency=16), tinted(kit, (WHITE, CREAM, WOOD)), masonry(kit), kit.material(dark=True)
    x, y, lift, high = rng.uniform(1.4, 1.8), rng.uniform(1.8, 2.4), 0.7, 2.0
    slab(kit, 0, 0, 0, (x + 1, y + 0.9, 0.2), stone)
    slab(kit, 0, 0, lift - 0.1, (x + 0.7, y + 0.6, 0.07), red)
    posts(kit, (-x - 0.5, x + 0.5), (-y - 0.4, y + 0.4), 0.3, lift, 0.09, red)
    slab(kit, 0, 0, lift, (x, y, high / 2), wall)
    posts(kit, (-x, x), np.linspace(-y, y, 4), lift, lift + high, 0.1, red, CYL)
    eave, rise = lift + high, rng.uniform(1.1, 1.5)
    leaves(kit, (0.2, 0, eave), turn("z", 90), y + 0.8, (x + 1.0, -0.15), (x * 0.5, rise * 0.45), 0.08, cover)
    leaves(kit, (0.2, 0, eave), turn("z", 90), y + 0.8, (x * 0.55, rise * 0.4), (0, rise + 0.2), 0.08, cover)
    for side in (-1, 1):
        kit.add(BOX, (0.2, side * y, eave + rise / 2), (x * 0.9, 0.07, rise / 2), (0.05, 1), material=wall)
        for way in (-1, 1):
            kit.between((0.2 - way * 0.1, side * (y + 0.7), eave + rise), (0.2 + way * 0.5, side * (y + 0.7), eave + rise + 0.8), 0.06, BOX, material=red)
    kit.add(BOX, (0.2, 0, eave + rise + 0.3), (0.16, y + 0.9, 0.1), material=cover)
    for place in (-0.5, 0, 0.5):
        kit.add(CYL, (0.2, place * y, eave + rise + 0.48), (0.11, 0.11, 0.4), rotation=ALONG_X, material=red)
    kit.add(BOX, (x, 0, lift + 0.9), (0.05, 0.6, 0.85), material=dark, cut=(GRID, 4, 0.2))
    flight(kit, x + 0.7, 0, lift, 0.7, red, 4)
    gate, wide, tall = x + 4.2, 1.7, rng.uniform(3, 3.6)
    for side in (-1, 1):
        kit.between((gate, side * wide * 1.08, 0), (gate, side * wide * 0.95, tall), 0.15, CYL, 0.9, material=red)
        kit.add(CYL, (gate, side * wide * 1.08, 0.15), (0.24, 0.24, 0.15), material=dark)
        kit.between((gate, 0, tall + 0.12), (gate, side * (wide + 0.8), tall + 0.28), (0.13, 0.2), BOX, material=red)
        kit.between((gate, 0, tall + 0.3), (gate, side * (wide + 0.9), tall + 0.48), (0.07, 0.26), BOX, material=dark)
        slab(kit, x + 2.4, side * 1.4, 0, (0.14, 0.14, 0.5), stone)
        slab(kit, x + 2.4, side * 1.4, 1.0, (0.24, 0.24, 0.18), stone)
        kit.add(BOX, (x + 2.4, side * 1.4, 1.5), (0.36, 0.36, 0.14), (0.1, 0.1), material=stone)
    kit.add(BOX, (gate, 0, tall - 0.6), (0.1, wide + 0.45, 0.13), material=red)
    kit.add(BOX, (gate, 0, tall - 0.2), (0.08, 0.25, 0.35), material=lettered(kit))
    slab(kit, gate / 2, 0, 0, (gate / 2 + 0.4, 0.7, 0.04), stone)


def palace(kit):
    rng = kit.rng
    wall, cover, stone, glass = tinted(kit, (CREAM, OCHRE, WHITE, (0.6, 0.33, 0.26))), tiles(kit), tinted(kit, (WHITE, STONE)), panes(kit)
    x, y, high, wing = 1.8, rng.uniform(6, 8), 6.4, rng.uniform(1.5, 2.1)
    block(kit, (0, 0, 0), (x, y, high / 2), 2, (10, 9, 2), wall, glass, stone)
    roof(kit, (0, 0, high), (x, y), 1.3, rng.choice(["hip", "mansard"]), 0.3, cover, stone, 1)
    for side in (-1, 1):
        fronted(kit, (x + 0.4, side * y, 0), (x + 1.6, wing, high / 2), 2, 2, wall, glass, stone, 0, (0.35, 0.7), False)
        roof(kit, (x + 0.4, side * y, high), (x + 1.6, wing), 1.5, rng.choice(["mansard", "hip"]), 0.25, cover, stone)
    slab(kit, 0.6, 0, 0, (x, 2.2, high / 2 + 0.2), wall)
    portico(kit, x + 0.6, 0.6, 2.2, high * 0.6, 1.1, 4, stone)
    dome(kit, (0.2, 0, high + 1.4), 1.5, "round", tinted(kit, (COPPER, SLATE, GOLD)), stone)
    kit.add(PRISM, (0.2, 0, high + 0.8), (1.6, 1.6, 0.7), (1, 12), material=wall)


def villa(kit):
    rng = kit.rng
    wall, cover, stone, glass = render(kit), tiles(kit), tinted(kit, (WHITE, STONE)), panes(kit)
    x, y, high = rng.uniform(3, 3.8), rng.uniform(3.6, 4.6), 6.2
    block(kit, (0, 0, 0), (x, y, high / 2), 2, (5, 4, 3), wall, glass, stone)
    roof(kit, (0, 0, high), (x, y), x * rng.uniform(0.4, 0.6), rng.choice(["hip", "hip", "flat"]), 0.6, cover, stone, 1)
    posts(kit, (x + 1.4,), (-1.4, 1.4), 0, 2.9, 0.15, stone, CYL)
    slab(kit, x + 0.8, 0, 2.9, (0.9, 1.8, 0.12), stone)
    for start, end in (((x + 1.6, -1.7), (x + 1.6, 1.7)), ((x, -1.7), (x + 1.6, -1.7)), ((x, 1.7), (x + 1.6, 1.7))):
        kit.railing((*start, 3.1), (*end, 3.1), 0.7, stone, 0.25, thick=0.06)
    door(kit, (x, 0, 0.2), (0.55, 1.1), leaf(kit), stone)
    flight(kit, x, 0, 0.2, 1.4, stone, 1, deep=1.6)
    slab(kit, -x * 0.2, y + 1.0, 0, (x * 0.7, 1.1, 1.5), wall)
    kit.add(BOX, (-x * 0.2, y + 1.2, 1.6), (x * 0.72, 0.92, 1.0), material=glass, cut=(BARS, 1.2, 0.6))
    slab(kit, -x * 0.2, y + 1.0, 3.0, (x * 0.75, 1.2, 0.1), stone)
    chimney(kit, 0, y * 0.5, high, high + x * 0.8)
    slab(kit, x + 0.3, y * 0.6, 0, (0.3, 0.9, 0.3), greens(kit))
    slab(kit, x + 0.3, -y * 0.6, 0, (0.3, 0.9, 0.3), greens(kit))


def farmstead(kit):
    rng = kit.rng
    wall, cover, barn, glass, frame = walls_of(kit), tiles(kit), tinted(kit, (RED, WOOD, GREY, TIMBER), (PLANKS, STRIPES), frequency=14), panes(kit), trim(kit)
    slab(kit, 0.5, 0, 0, (6, 6, 0.04), tinted(kit, (SAND, GREY, STONE), (CLOUDY,)))
    fronted(kit, (-4, 0, 0), (1.8, 3, 2.4), 2, 3, wall, glass, frame, 1, (0.3, 0.45))
    roof(kit, (-4, 0, 4.8), (1.8, 3), 1.8, rng.choice(["gable", "halfhip", "hip"]), 0.4, cover, wall, 1)
    chimney(kit, -4, 1.6, 5, 7.3)
    door(kit, (-2.2, 0, 0), (0.4, 0.9), leaf(kit), frame)
    slab(kit, 1.2, 4.4, 0, (3.6, 1.7, 1.9), barn)
    roof(kit, (1.2, 4.4, 3.8), (3.6, 1.7), 2.2, rng.choice(["gambrel", "gable"]), 0.35, tiles(kit), barn)
    kit.add(BOX, (1.2, 2.7, 1.3), (0.9, 0.06, 1.3), material=leaf(kit))
    kit.add(BOX, (4.8, 4.4, 1.2), (0.06, 0.8, 1.2), material=leaf(kit))
    kit.add(BOX, (1.2, -5.9, 1.3), (3.2, 0.06, 1.3), material=wall)
    posts(kit, np.linspace(-2, 4.4, 4), (-3.2,), 0, 2.5, 0.12, barn)
    for px in (-2.0, 4.4):
        kit.add(BOX, (px, -4.5, 1.25), (0.06, 1.35, 1.25), material=barn)
    kit.add(BOX, (1.2, -4.5, 2.7), (3.5, 1.7, 0.08), rotation=turn("x", 5), material=cover)
    if kit.chance(0.6):
        kit.add(CYL, (5.4, 2.2 + 2.2, 3.2), (0.9, 0.9, 3.2), material=tinted(kit, (GREY, WHITE, BLUE), (SEAMS, BANDS), gloss=0.3))
        kit.add(BALL, (5.4, 4.4, 6.4), (0.9, 0.9, 0.6), material=tinted(kit, (GREY, WHITE)))
    kit.railing((6.3, -6, 0), (6.3, -1, 0), 0.8, frame, 0.8)
    kit.railing((6.3, 1, 0), (6.3, 5.8, 0), 0.8, frame, 0.8)
    kit.add(CYL, (2.5, -4.6, 0.6), (0.6, 0.6, 0.7), rotation=ALONG_X, material=tinted(kit, (OCHRE, THATCH), (STREAKS,), frequency=25))


def terrace(kit):
    rng = kit.rng
    count, half, x, high = int(rng.integers(3, 5)), rng.uniform(1.7, 2.2), rng.uniform(2.6, 3.4), rng.uniform(5.2, 6)
    shared, cover, frame, glass = brickwork(kit), tiles(kit), trim(kit), panes(kit)
    for k in range(count):
        y = (k - (count - 1) / 2) * 2 * half
        wall = render(kit) if kit.chance(0.4) else shared
        slab(kit, 0, y, 0, (x, half, high / 2), wall)
        lights(kit, (0, y, high * 0.74), (x, half), row(2, half, 0.95), (0.38, 0.6), glass, frame, 0, False)
        kit.add(BOX, (x + 0.25, y - half * 0.4, 1.4), (0.4, 0.75, 1.3), (0.95, 0.75) if count < 4 else (1, 1), material=frame)
        kit.add(BOX, (x + 0.3, y - half * 0.4, 1.55), (0.4, 0.6, 0.7), material=glass)
        door(kit, (x, y + half * 0.52, 0.1), (0.36, 0.92), vivid(kit), frame)
        chimney(kit, 0, y + half, high + x * 0.3, high + x * 0.9, shared)
    roof(kit, (0, 0, high), (x, half * count), x * 0.65, "gable", 0.2, cover, shared, 1)
    slab(kit, x + 1.3, 0, 0, (0.1, half * count, 0.35), shared)
    slab(kit, -x - 0.9, half * (count - 1), 0, (1.0, half * 0.5, high * 0.3), shared)


def balconies(kit, x, y, width, floors, material, deep=0.55):
    """Slabs with parapets before the wall at `x`, one at each height of `floors`."""
    for z in floors:
        kit.add(BOX, (x + deep, y, z), (deep, width, 0.08), material=material)
        kit.add(BOX, (x + 2 * deep, y, z + 0.45), (0.04, width, 0.45), material=material)


def tower_block(kit):
    rng = kit.rng
    wall, glass, rail = tinted(kit, (WHITE, CONCRETE, CREAM, BRICK, GREY), (PLAIN, STREAKS, CLOUDY)), panes(kit), vivid(kit) if kit.chance(0.5) else tinted(kit, (GREY, WHITE, CONCRETE))
    storeys, x, y = int(rng.integers(7, 12)), rng.uniform(2.8, 4), rng.uniform(3.5, 6)
    step = 2.8
    high, pitch = step * storeys, rng.uniform(2.0, 2.6)
    kit.add(BOX, (0, 0, high / 2), (x - 0.25, y - 0.25, high / 2), material=glass)
    for k in range(storeys + 1):
        kit.add(BOX, (0, 0, step * k + (0.4 if k else 0.3)), (x, y, 0.6 if k else 0.35), material=wall)
    for py in np.linspace(-y, y, 5):
        kit.add(BOX, (0, py * 0.96, high / 2), (x + 0.03, 0.28, high / 2), material=wall)
    kit.add(BOX, (0, 0, high / 2), (pitch * 0.3, y + 0.05, high / 2), material=wall)
    slab(kit, -x, 0, 0, (0.9, 1.2, high / 2 + 0.9), wall)
    kit.add(BOX, (-x - 0.92, 0, high * 0.5), (0.03, 0.5, high * 0.47), material=glass)
    for side in (-1, 1):
        balconies(kit, x, side * y * 0.48, y * 0.21, step * np.arange(1, min(storeys, 10)) + 0.1, rail)
    slab(kit, 0, 0, high + 1, (x * 0.4, y * 0.3, 0.7), wall)
    slab(kit, x + 0.6, 0, 2.5, (0.8, 1.1, 0.1), rail)
    posts(kit, (x + 1.2,), (-0.9, 0.9), 0, 2.5, 0.07, rail)
    kit.add(BOX, (x + 0.05, 0, 1.2), (0.05, 0.8, 1.1), material=kit.material(dark=True))


def skyscraper(kit):
    rng = kit.rng
    wall, glass, metal = tinted(kit, (STONE, CREAM, GREY, BRICK, WHITE), (PLAIN, CLOUDY)), panes(kit), tinted(kit, (GREY, GOLD, COPPER), gloss=0.4)
    x, y, z, tiers = rng.uniform(3.2, 4), rng.uniform(3.2, 4.4), 0.0, int(rng.integers(3, 6))
    for k in range(tiers):
        tall = rng.uniform(4.5, 9) * (1.2 - 0.14 * k)
        kit.add(BOX, (0, 0, z + tall / 2), (x - 0.18, y - 0.18, tall / 2), material=glass)
        count = max(4, 7 - k)
        for axis, half, other in ((0, x, y), (1, y, x)):
            for side in (-1, 1):
                pierced(kit, axis, (side * (half - 0.1), 0, z + tall / 2) if axis == 0 else (0, side * (half - 0.1), z + tall / 2), (other, tall / 2), count, wall, 0.5, 0.1)
        kit.add(BOX, (0, 0, z + tall), (x + 0.08, y + 0.08, 0.22), material=wall)
        z += tall
        x, y = x * rng.uniform(0.68, 0.86), y * rng.uniform(0.68, 0.86)
    slab(kit, 0, 0, z, (x, y, 0.6), wall)
    if kit.chance(0.6):
        spire(kit, 0, 0, z + 1.2, x, rng.uniform(1, 4), metal)
    kit.between((0, 0, z), (0, 0, z + rng.uniform(4, 9)), 0.15, CYL, 0.2, material=metal)


def hotel(kit):
    rng = kit.rng
    wall, cover, stone, glass, cloth = walls_of(kit), tiles(kit), tinted(kit, (WHITE, STONE)), panes(kit), striped(kit)
    x, y, storeys, count = rng.uniform(3, 3.8), rng.uniform(4, 5.5), int(rng.choice([3, 4])), int(rng.choice([5, 7]))
    high = 3.1 * storeys
    block(kit, (0, 0, 0), (x, y, high / 2), storeys, (count, count - 1, 3), wall, glass, stone)
    roof(kit, (0, 0, high), (x, y), 2.0, rng.choice(["mansard", "mansard", "flat", "hip"]), 0.3, cover, stone, 1)
    for side in (-1, 1):
        balconies(kit, x, side * y * 0.55, 1.1, 3.1 * np.arange(1, storeys) + 0.2, stone, 0.4)
    door(kit, (x, 0, 0.1), (0.9, 1.2), leaf(kit), stone)
    kit.add(BOX, (x + 0.9, 0, 3.0), (1.0, 1.5, 0.12), material=cloth)
    posts(kit, (x + 1.7,), (-1.3, 1.3), 0, 3.0, 0.07, tinted(kit, (GOLD, GREY)))
    kit.add(BOX, (x - 0.2, 0, high + 0.7), (0.1, y * 0.5, 0.5), material=lettered(kit))


def factory(kit):
    rng = kit.rng
    wall, cover, glass, frame = brickwork(kit) if kit.chance(0.6) else walls_of(kit), tiles(kit), panes(kit), trim(kit)
    teeth, x, high = int(rng.integers(3, 6)), rng.uniform(3, 4.5), rng.uniform(3.2, 4.2)
    half, rise = 1.6, rng.uniform(1.3, 1.8)
    y = half * teeth
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    for k in range(teeth):
        at = -y + half * (2 * k + 1)
        kit.add(BOX, (0, at, high + rise / 2), (x, half, rise / 2), (1, 0.06), (0, half * 0.93), material=wall)
        kit.between((0, at - half, high + 0.06), (0, at + half, high + rise + 0.06), (0.06, x + 0.12), BOX, material=cover)
        kit.add(BOX, (0, at + half * 0.99, high + rise * 0.5), (x * 0.93, 0.04, rise * 0.38), material=glass)
        lights(kit, (0, at, high * 0.58), (x, y), [at], (half * 0.6, high * 0.22), glass, frame, 0)
    lights(kit, (0, 0, high * 0.58), (x, y), row(3, x), (0.6, high * 0.22), glass, frame, 1)
    tall = high + rng.uniform(5, 9)
    cx = -x - 0.5
    slab(kit, cx, y * 0.5, 0, (0.75, 0.75, 1.0), wall)
    kit.add(CYL, (cx, y * 0.5, tall / 2), (0.55, 0.55, tall / 2), (0.65, 1), material=brickwork(kit))
    kit.add(TUBE, (cx, y * 0.5, tall - 0.2), (0.45, 0.45, 0.25), material=brickwork(kit))
    kit.add(BOX, (x + 0.03, -y + half, 1.3), (0.06, 0.9, 1.3), material=leaf(kit))
    slab(kit, x + 1.2, y - 1.3, 0, (1.2, 1.3, 1.6), wall)
    slab(kit, x + 1.2, y - 1.3, 3.2, (1.35, 1.45, 0.12), frame)
    lights(kit, (x + 1.2, y - 1.3, 1.7), (1.2, 1.3), row(2, 1.3), (0.35, 0.5), glass, frame, 0)


def warehouse(kit):
    rng = kit.rng
    wall, cover, accent, dark, concrete, glass = tinted(kit, (GREY, WHITE, BLUE, CREAM, GREEN), (RIBS, SEAMS, PLAIN), frequency=18), steelwork(kit), vivid(kit), kit.material(dark=True), paving(kit), panes(kit)
    x, y, high, docks = rng.uniform(4, 6), rng.uniform(6, 8), rng.uniform(3.8, 5), int(rng.integers(4, 7))
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    kit.add(BOX, (0, 0, high - 0.3), (x + 0.05, y + 0.05, 0.3), material=accent)
    roof(kit, (0, 0, high), (x, y), rng.uniform(0.6, 1.2), rng.choice(["gable", "flat"]), 0.15, cover, wall, 1)
    slab(kit, x + 0.7, 0, 0, (0.7, y * 0.92, 0.55), concrete)
    slab(kit, x + 1.0, 0, 3.3, (1.1, y * 0.92, 0.1), accent)
    for k, py in enumerate(row(docks, y * 0.9, 1)):
        kit.add(BOX, (x + 0.04, py, 2.1), (0.06, 0.75, 1.0), material=tinted(kit, (WHITE, GREY), (BANDS,), frequency=10))
        for side in (-1, 1):
            kit.add(BOX, (x + 0.12, py + side * 0.85, 2.15), (0.12, 0.1, 1.1), material=dark)
        if k == 1:
            kit.add(BOX, (x + 4.2, py, 2.3), (2.8, 0.72, 1.2), material=vivid(kit, (PLAIN, WRITING), frequency=8))
            for px in (x + 5.4, x + 6.2):
                kit.add(CYL, (px, py, 0.5), (0.5, 0.5, 0.72), rotation=ALONG_Y, material=dark)
            slab(kit, x + 2.4, py, 0, (0.1, 0.5, 0.55), dark)
    lights(kit, (0, 0, high * 0.72), (x, y), row(4, x), (0.6, 0.3), glass, accent, 1, False)
    slab(kit, x * 0.2, y + 1.3, 0, (x * 0.6, 1.4, 1.5), accent)
    kit.add(BOX, (x * 0.2, y + 1.3, 1.7), (x * 0.62, 1.43, 0.6), material=glass)
    kit.add(BOX, (-x, 0, 1.4), (0.06, 1.4, 1.4), material=dark)
    for px in row(3, x):
        kit.add(CYL, (px, -y * 0.4, high + 0.8), (0.3, 0.3, 0.8), material=cover)


def fire_station(kit):
    rng = kit.rng
    wall, stone, glass, red, frame = walls_of(kit), masonry(kit), panes(kit), tinted(kit, ((0.5, 0.03, 0.02), RED)), trim(kit)
    bays, x, high = int(rng.integers(2, 5)), rng.uniform(3.5, 4.5), rng.choice([4.2, 6.6])
    y = 2.0 * bays
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    roof(kit, (0, 0, high), (x, y), 1.4, rng.choice(["flat", "flat", "hip", "gable"]), 0.25, tiles(kit), stone, 1)
    for py in row(bays, y, 1):
        kit.add(BOX, (x, py, 1.65), (0.12, 1.6, 1.75), material=stone)
        kit.add(BOX, (x + 0.04, py, 1.55), (0.12, 1.4, 1.55), material=red)
        kit.add(BOX, (x + 0.08, py, 2.2), (0.1, 1.2, 0.3), material=glass)
        if high > 5:
            lights(kit, (0, py, 5.2), (x, y), [py], (0.8, 0.6), glass, frame, 0)
    lights(kit, (0, 0, 2), (x, y), row(3, x), (0.5, 0.7), glass, frame, 1, False)
    tall = rng.uniform(9, 13)
    slab(kit, -x * 0.4, y + 1.0, 0, (1.1, 1.1, tall / 2), wall)
    for z in (tall - 1.1, tall * 0.6, tall * 0.35):
        lights(kit, (-x * 0.4, y + 1.0, z), (1.1, 1.1), [0], (0.45, 0.6), kit.material(dark=True), frame, 0, False)
        kit.add(BOX, (-x * 0.4, y + 1.0, z), (0.45, 1.15, 0.6), material=kit.material(dark=True))
    slab(kit, -x * 0.4, y + 1.0, tall, (1.3, 1.3, 0.15), stone)
    kit.add(BOX, (x + 0.15, 0, 3.75), (0.05, y * 0.5, 0.3), material=lettered(kit))
    kit.add(BOX, (x + 2.9, -2.0 * (bays - 1), 1.25), (2.0, 0.9, 0.75), material=red)
    kit.add(BOX, (x + 4.5, -2.0 * (bays - 1), 1.5), (0.5, 0.85, 0.45), material=glass)
    for px in (x + 1.7, x + 4.2):
        kit.add(CYL, (px, -2.0 * (bays - 1), 0.5), (0.5, 0.5, 0.9), rotation=ALONG_Y, material=kit.material(dark=True))


def police_post(kit):
    rng = kit.rng
    wall, stone, glass, blue, frame = walls_of(kit), masonry(kit), panes(kit), tinted(kit, ((0.03, 0.08, 0.35),)), trim(kit)
    x, y, storeys = rng.uniform(2.6, 3.2), rng.uniform(3, 4), int(rng.integers(1, 3))
    high = 3.2 * storeys
    fronted(kit, (0, 0, 0), (x, y, high / 2), storeys, 4, wall, glass, frame, 3)
    roof(kit, (0, 0, high), (x, y), 1.5, rng.choice(["flat", "hip", "gable"]), 0.35, tiles(kit), stone, 1)
    door(kit, (x, 0, 0.3), (0.55, 1.0), blue, stone)
    flight(kit, x, 0, 0.3, 1.0, stone, 2)
    slab(kit, x + 0.6, 0, 2.6, (0.7, 1.2, 0.12), blue)
    posts(kit, (x + 1.2,), (-1.0, 1.0), 0, 2.6, 0.06, blue)
    kit.add(BOX, (x + 0.07, 0, 3.0), (0.05, 1.1, 0.22), material=lettered(kit))
    for side in (-1, 1):
        kit.add(CYL, (x + 0.25, side * 0.9, 2.1), (0.13, 0.13, 0.2), material=blue)
    kit.between((0, y * 0.5, high), (0, y * 0.5, high + 4), 0.06, material=tinted(kit, (GREY, RED)))
    flag(kit, x + 1.6, -y * 0.8, 0, 5, vivid(kit, (BANDS,), frequency=8))


def embassy(kit):
    rng = kit.rng
    wall, stone, glass, metal = render(kit), tinted(kit, (WHITE, STONE, CONCRETE)), panes(kit), kit.material(dark=True)
    x, y, high, out = rng.uniform(2.6, 3.2), rng.uniform(3.2, 4), 6.2, rng.uniform(2, 2.6)
    block(kit, (0, 0, 0), (x, y, high / 2), 2, (5, 4, 3), wall, glass, stone)
    roof(kit, (0, 0, high), (x, y), 1.4, rng.choice(["hip", "flat"]), 0.4, tiles(kit), stone, 1)
    door(kit, (x, 0, 0.2), (0.55, 1.1), leaf(kit), stone)
    slab(kit, 0.6, 0, 0, (x + out + 0.6, y + out, 0.04), paving(kit))
    front = x + out + 1.2
    for side in (-1, 1):
        slab(kit, 0.6, side * (y + out), 0, (x + out + 0.6, 0.12, 0.9), stone)
        slab(kit, front, side * (y + out + 1.2) / 2, 0, (0.12, (y + out - 1.2) / 2, 0.9), stone)
        slab(kit, front, side * 1.2, 0, (0.25, 0.25, 1.2), stone)
    slab(kit, -x - out, 0, 0, (0.12, y + out, 0.9), stone)
    kit.railing((front, -1.1, 0), (front, 1.1, 0), 1.9, metal, 0.25)
    slab(kit, front - 0.8, 2.2, 0, (0.5, 0.5, 1.0), wall)
    slab(kit, front - 0.8, 2.2, 2.0, (0.65, 0.65, 0.1), stone)
    kit.add(BOX, (front - 0.8, 2.2, 1.4), (0.53, 0.53, 0.3), material=glass)
    flag(kit, x + 0.6, -1.6, 0, 8, vivid(kit, (STRIPES, BANDS), frequency=5))


def hospital(kit):
    rng = kit.rng
    wall, stone, glass, red, accent = tinted(kit, (WHITE, CREAM, BRICK, CONCRETE)), tinted(kit, (WHITE, GREY)), panes(kit), tinted(kit, ((0.6, 0.03, 0.02),)), vivid(kit)
    x, y, storeys = rng.uniform(2.6, 3.2), rng.uniform(6, 8), int(rng.integers(3, 5))
    high = 3.0 * storeys
    block(kit, (0, 0, 0), (x, y, high / 2), storeys, (10, 11, 3), wall, glass, None, 0.5)
    slab(kit, 0, 0, high, (x + 0.1, y + 0.1, 0.25), stone)
    slab(kit, 0, 0, high + 0.5, (x * 0.6, y * 0.3, 0.8), stone)
    slab(kit, x + 1.6, 0, 0, (1.8, 2.8, 1.7), stone)
    kit.add(BOX, (x + 1.7, 0, 1.5), (1.75, 2.4, 1.1), material=glass)
    slab(kit, x + 4.2, 0, 3.0, (1.2, 1.8, 0.12), accent)
    posts(kit, (x + 5.2,), (-1.6, 1.6), 0, 3.0, 0.1, stone)
    for long in ((0.09, 0.7, 0.22), (0.09, 0.22, 0.7)):
        kit.add(BOX, (x + 0.05, 0, high - 1.2), long, material=red)
    slab(kit, -x - 2.2, y * 0.4, 0, (2.4, 1.8, high * 0.3), wall)
    lights(kit, (-x - 2.2, y * 0.4, high * 0.35), (2.4, 1.8), row(3, 2.4), (0.45, 0.55), glass, stone, 1, False)
    kit.add(CYL, (0, -y * 0.65, high + 0.6), (1.9, 1.9, 0.1), material=tinted(kit, (GREY, GREEN)))
    kit.add(BOX, (x + 4.3, 2.9, 0.95), (1.1, 0.5, 0.6), material=stone)
    kit.add(BOX, (x + 5.35, 2.9, 0.75), (0.35, 0.45, 0.4), (0.5, 0.95), (-0.15, 0), material=glass)
    for px in (x + 3.6, x + 5.2):
        kit.add(CYL, (px, 2.9, 0.3), (0.3, 0.3, 0.5), rotation=ALONG_Y, material=kit.material(dark=True))
    posts(kit, (-0.8, 0.8), (-y * 0.65 - 0.8, -y * 0.65 + 0.8), high + 0.4, high + 0.55, 0.1, stone)


def station(kit):
    rng = kit.rng
    wall, cover, stone, glass, steel = brickwork(kit) if kit.chance(0.5) else walls_of(kit), tiles(kit), masonry(kit), panes(kit), steelwork(kit)
    x, y, high, half = rng.uniform(2.2, 2.8), rng.uniform(6, 8), 4.2, rng.uniform(2, 2.6)
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    roof(kit, (0, 0, high), (x, y), 1.5, "hip", 0.4, cover, stone, 1)
    slab(kit, 0, 0, 0, (x + 0.4, half, high * 0.75), wall)
    roof(kit, (0, 0, high * 1.5), (x + 0.4, half), 1.6, "gable", 0.3, cover, wall)
    arched(kit, (0, 0, 0), (x, y), [p * y for p in (-0.8, -0.5, 0.5, 0.8)], 0.5, 0.8, 2.3, glass, 0)
    arched(kit, (0, 0, 0), (x + 0.4, half), (-1.1, 0, 1.1), 0.4, 0.1, 2.2, leaf(kit), 0)
    for out, r, skin in ((0.08, 0.75, stone), (0.12, 0.62, tinted(kit, (WHITE,)))):
        kit.add(CYL, (x + 0.4, 0, high * 1.2), (r, r, out), rotation=ALONG_X, material=skin)
    kit.add(BOX, (x + 0.53, 0.15, high * 1.2), (0.02, 0.2, 0.04), material=kit.material(dark=True))
    kit.add(BOX, (x + 0.53, 0, high * 1.2 + 0.2), (0.02, 0.04, 0.25), material=kit.material(dark=True))
    if kit.chance(0.5):
        slab(kit, -x * 0.2, y * 0.6, 0, (1.0, 1.0, 5), wall)
        clock(kit, (-x * 0.2, y * 0.6, 9.2), 1.0, 0.6, stone)
        spire(kit, -x * 0.2, y * 0.6, 10, 1.15, rng.uniform(1.5, 3), cover)
    slab(kit, -x - 1.6, 0, 0, (1.6, y + 1, 0.3), paving(kit))
    kit.add(BOX, (-x - 1.3, 0, 3.4), (1.5, y * 0.9, 0.08), rotation=turn("y", 6), material=steel)
    posts(kit, (-x - 2.4,), np.linspace(-y * 0.85, y * 0.85, 5), 0.6, 3.3, 0.08, steel, CYL)
    kit.add(BOX, (x + 1.0, 0, 2.95), (0.7, half, 0.07), material=steel)
    posts(kit, (x + 1.6,), (-half + 0.1, half - 0.1), 0, 2.95, 0.06, steel)
    kit.add(BOX, (x + 0.45, 0, 3.4), (0.05, half * 0.8, 0.22), material=lettered(kit))


def museum(kit):
    rng = kit.rng
    stone, glass, cover = tinted(kit, (STONE, WHITE, SAND, CREAM), (PLAIN, CLOUDY, BRICKS), frequency=12), panes(kit), tinted(kit, (COPPER, GREY, SLATE))
    x, y, high, wide = rng.uniform(3.4, 4.2), rng.uniform(6, 8), rng.uniform(5, 6), rng.uniform(2.8, 3.6)
    slab(kit, 0, 0, 0, (x + 0.2, y + 0.2, 0.5), stone)
    block(kit, (0, 0, 1.0), (x, y, high / 2), 1, (10, 9, 5), stone, glass, stone, 0.6)
    slab(kit, 0, 0, high + 1, (x, y, 0.35), stone)
    portico(kit, x, 1.0, wide, high, 1.7, int(rng.choice([6, 8])), stone)
    door(kit, (x, 0, 1.0), (0.7, 1.5), leaf(kit), stone)
    if kit.chance(0.6):
        kit.add(CYL, (0, 0, high + 2.2), (2.1, 2.1, 0.7), material=stone)
        dome(kit, (0, 0, high + 2.8), 2.0, rng.choice(["round", "flat"]), cover, stone)
    else:
        kit.add(BOX, (0, 0, high + 2.2), (x * 0.6, y * 0.6, 0.5), (0.6, 0.8), material=glass)
    for side in (-1, 1):
        kit.add(BOX, (x + 0.2, side * y * 0.75, high * 0.6), (0.02, 0.5, 1.4), material=vivid(kit, (WRITING,), frequency=10))


def theatre(kit):
    rng = kit.rng
    wall, stone, glass, cover, sign = render(kit), tinted(kit, (WHITE, STONE, GOLD)), panes(kit), tinted(kit, (COPPER, SLATE)), vivid(kit, (DOTS,), frequency=16)
    x, y, high = rng.uniform(3.5, 4.5), rng.uniform(3.2, 4), rng.uniform(5.5, 7)
    slab(kit, 0, 0, 0, (x, y, high / 2), wall)
    slab(kit, -x * 0.5, 0, high, (x * 0.45, y * 0.8, 1.6), wall)
    slab(kit, -x * 0.5, 0, high + 3.2, (x * 0.5, y * 0.85, 0.12), stone)
    slab(kit, 0, 0, high, (x + 0.12, y + 0.12, 0.2), stone)
    kit.add(BOX, (x - 0.3, 0, high + 1.0), (0.35, y * 0.7, 0.7), (1, 0.25), material=stone)
    slab(kit, x + 0.1, 0, 0, (0.2, y + 0.05, 0.3), stone)
    for py in np.linspace(-y * 0.85, y * 0.85, 6):
        kit.add(CYL, (x + 0.15, py, high * 0.68), (0.2, 0.2, high * 0.3), material=stone)
    arched(kit, (0, 0, 0), (x, y), row(5, y, 0.85), 0.36, high * 0.5, high * 0.78, glass, 0)
    kit.add(BOX, (x + 1.0, 0, high * 0.4), (1.1, y * 0.8, 0.35), material=sign)
    kit.add(BOX, (x + 2.12, 0, high * 0.4), (0.04, y * 0.75, 0.25), material=lettered(kit))
    for py in row(4, y, 0.75):
        kit.add(BOX, (x + 0.28, py, 1.1), (0.05, 0.4, 1.1), material=leaf(kit))
    kit.add(BOX, (x + 0.7, y * 0.9, high * 0.75), (0.6, 0.12, 1.3), material=lettered(kit))
    lights(kit, (0, 0, high * 0.55), (x, y), row(3, x), (0.3, 0.8), glass, stone, 1, False)
    dome(kit, (x * 0.25, 0, high + 0.2), 1.5, "flat", cover, stone)
    posts(kit, (x + 1.9,), (-y * 0.7, y * 0.7), 0, high * 0.38, 0.07, stone)


def barracks(kit):
    rng = kit.rng
    wall, cover, stone, glass = walls_of(kit), tiles(kit), masonry(kit), panes(kit)
    x, y, storeys = rng.uniform(2.2, 2.8), rng.uniform(7, 9), int(rng.integers(2, 4))
    high = 2.9 * storeys
    block(kit, (0, 0, 0), (x, y, high / 2), storeys, (12, 11, 2), wall, glass, stone if storeys == 2 else None)
    roof(kit, (0, 0, high), (x, y), x * 0.8, rng.choice(["hip", "gable", "halfhip"]), 0.35, cover, wall, 1)
    for py in (-y * 0.5, y * 0.5):
        door(kit, (x, py, 0.2), (0.5, 1.0), leaf(kit), stone)
        flight(kit, x, py, 0.2, 0.8, stone, 2)
        slab(kit, x + 0.45, py, 2.4, (0.5, 0.9, 0.08), stone)
        chimney(kit, 0, py, high + x * 0.4, high + x + 0.5)
    flag(kit, x + 2.5, 0, 0, 7, vivid(kit, (BANDS, STRIPES), frequency=5))
    slab(kit, x + 2.5, 0, 0, (0.5, 0.5, 0.15), stone)
    slab(kit, x + 1.25, 0, 0, (1.3, 0.5, 0.03), paving(kit))


def watermill(kit):
    rng = kit.rng
    wall, cover, wood, glass, frame, stone = walls_of(kit), tiles(kit), timberwork(kit), panes(kit), trim(kit), masonry(kit)
    x, y, high, r = rng.uniform(2.4, 3), rng.uniform(2.2, 2.8), rng.uniform(4.8, 6), rng.uniform(1.7, 2.3)
    slab(kit, 0, 0, 0, (x + 0.06, y + 0.06, 1.1), stone)
    slab(kit, 0, 0, 2.2, (x, y, high / 2 - 1.1), wall)
    roof(kit, (0, 0, high), (x, y), y * rng.uniform(0.8, 1.1), rng.choice(["gable", "gable", "halfhip"]), 0.4, cover, wall)
    lights(kit, (0, 0, high * 0.72), (x, y), row(3, x), (0.35, 0.45), glass, frame, 1)
    lights(kit, (0, 0, high * 0.72), (x, y), row(2, y), (0.35, 0.45), glass, frame, 0)
    door(kit, (x, -y * 0.3, 0.0), (0.5, 1.0), leaf(kit), frame)
    wheel_y = y + 0.65
    for side in (-0.35, 0.35):
        kit.add(CYL, (0, wheel_y + side, r + 0.1), (r, r, 0.06), rotation=ALONG_Y, material=wood, cut=(SPOKES, 8, 0.16))
    for px, pz in around(14, r * 0.93):
        kit.add(BOX, (px, wheel_y, r + 0.1 + pz), (0.22, 0.33, 0.03), rotation=turn("y", -np.degrees(np.arctan2(pz, px))), material=wood)
    kit.between((0, y - 0.2, r + 0.1), (0, wheel_y + 0.9, r + 0.1), 0.13, material=wood)
    slab(kit, 0, wheel_y + 0.85, 0, (0.5, 0.2, r / 2 + 0.05), stone)
    kit.add(BOX, (-r * 1.1, wheel_y, 2 * r + 0.35), (r * 1.1, 0.32, 0.12), material=wood)
    posts(kit, (-r * 1.4, -r * 2.1), (wheel_y - 0.25, wheel_y + 0.25), 0, 2 * r + 0.3, 0.08, wood)
    slab(kit, -x * 0.2, wheel_y, 0, (x * 1.3, 0.55, 0.04), tinted(kit, ((0.05, 0.12, 0.15),), gloss=0.5))
    chimney(kit, -x * 0.5, 0, high + y * 0.5, high + y + 0.9)


def brewery(kit):
    rng = kit.rng
    wall, cover, stone, glass, steel = brickwork(kit), tiles(kit), masonry(kit), panes(kit), tinted(kit, (GREY, WHITE, COPPER), (PLAIN, SEAMS), gloss=0.4)
    x, y, storeys = rng.uniform(2.6, 3.2), rng.uniform(3, 3.8), 3
    block(kit, (0, 0, 0), (x, y, 4.8), storeys, (5, 4, 4), wall, glass, stone, 0.58)
    roof(kit, (0, 0, 9.6), (x, y), 1.6, rng.choice(["mansard", "gable", "flat"]), 0.25, cover, wall, 1)
    tall = rng.uniform(11, 16)
    kit.add(PRISM, (-x - 0.9, -y * 0.5, tall / 2), (0.7, 0.7, tall / 2), (0.6, 8), material=wall)
    kit.add(PRISM, (-x - 0.9, -y * 0.5, tall), (0.55, 0.55, 0.25), (1, 8), material=stone)
    slab(kit, 0, -y - 2.2, 0, (x, 2.3, 2.2), wall)
    roof(kit, (0, -y - 2.2, 4.4), (x, 2.3), 1.2, "gable", 0.2, cover, wall)
    for k in range(2):
        kit.add(BOX, (x + 0.03, -y - 1.2 - 2 * k, 1.2), (0.06, 0.7, 1.2), material=leaf(kit))
        kit.add(CYL, (x * (0.6 - 1.1 * k), y + 1.1, 3.4), (0.9, 0.9, 2.4), material=steel)
        kit.add(CYL, (x * (0.6 - 1.1 * k), y + 1.1, 6.1), (0.9, 0.9, 0.3), (0.3, 1), material=steel)
        kit.add(CYL, (x * (0.6 - 1.1 * k), y + 1.1, 0.6), (0.75, 0.75, 0.6), material=stone)
    kit.add(BOX, (x + 0.07, 0, 8.8), (0.06, y * 0.75, 0.4), material=lettered(kit))


def windmill(kit):
    rng = kit.rng
    wall, cap, wood, glass, cloth = tinted(kit, (WHITE, BRICK, STONE, TIMBER, WOOD), (BRICKS, PLAIN, SHINGLES, PLANKS), frequency=16), tinted(kit, (TIMBER, SLATE, THATCH, RED), (SHINGLES, PLAIN), frequency=16), timberwork(kit), panes(kit), tinted(kit, (WHITE, WOOD, CREAM))
    kind = rng.choice(["tower", "smock", "post"])
    r, high = rng.uniform(1.7, 2.1), rng.uniform(5, 6.5)
    top, front = high, r * 0.62
    if kind == "post":
        for way in range(4):
            spin = turn("z", 90 * way + 45)
            kit.between(spin @ np.array([2.0, 0, 0.1]), spin @ np.array([0.15, 0, 2.2]), 0.13, BOX, material=wood)
            kit.add(BOX, spin @ np.array([1.0, 0, 0.15]), (1.15, 0.14, 0.14), rotation=spin, material=wood)
        slab(kit, 0, 0, 0, (0.25, 0.25, 1.3), wood)
        slab(kit, 0, 0, 2.2, (1.6, 1.2, 1.7), wall)
        roof(kit, (0, 0, 5.6), (1.6, 1.2), 1.3, rng.choice(["gable", "gambrel"]), 0.2, cap, wall)
        stairs(kit, (-3.6, 0, 0), (-1.6, 0, 2.5), 0.4, wood)
        top, front = 5.4, 1.6
        kit.between((-1.6, 0.6, 2.4), (-4.2, 0.6, 0.5), 0.09, material=wood)
        lights(kit, (0, 0, 4), (1.6, 1.2), [0], (0.3, 0.35), glass, wood, 1)
    else:
        kit.add(CYL if kind == "tower" else PRISM, (0, 0, high / 2), (r, r, high / 2), (0.62, 8 if kind == "smock" else 1), material=wall)
        if kind == "smock":
            kit.add(PRISM, (0, 0, 0.8), (r * 1.08, r * 1.08, 0.8), (0.96, 8), material=brickwork(kit))
        if kit.chance(0.5):
            kit.add(PRISM, (0, 0, high * 0.36), (r * 1.45, r * 1.45, 0.06), (1, 12), material=wood)
            kit.add(TUBE, (0, 0, high * 0.36 + 0.4), (r * 1.4, r * 1.4, 0.4), material=wood, cut=(BARS, 40, 0.2))
            for px, py in around(8, 1):
                kit.between((px * r * 0.9, py * r * 0.9, high * 0.22), (px * r * 1.35, py * r * 1.35, high * 0.35), 0.06, BOX, material=wood)
        if kit.chance(0.5):
            kit.add(BALL, (0, 0, high), (r * 0.72, r * 0.68, r * 0.7), material=cap)
        else:
            kit.add(CYL, (0, 0, high + r * 0.45), (r * 0.75, r * 0.75, r * 0.5), (0.05, 1), material=cap)
        top, front = high + 0.35, r * 0.66
        for z, share in ((high * 0.5, 0.81), (high * 0.75, 0.715)):
            kit.add(BOX, (0, 0, z), (0.25, r * share, 0.35), material=glass)
        door(kit, (r * 0.93, 0, 0), (0.42, 0.9), leaf(kit), wood)
        for side in (-1, 1):
            kit.between((-r * 0.5, side * r * 0.3, high + 0.2), (-r * 1.7, 0, high * 0.35), 0.06, BOX, material=wood)
    hub, long, spin0 = np.array([front + 0.45, 0, top]), min(top - 0.5, 5.0) * 0.95, rng.uniform(0, 90)
    kit.between((front - 0.6, 0, top - 0.1), hub, 0.16, material=wood)
    kit.add(BALL, hub, (0.25, 0.25, 0.25), material=wood)
    for k in range(4):
        spin = turn("x", spin0 + 90 * k)
        kit.add(BOX, hub + spin @ [0, 0, long / 2], (0.07, 0.08, long / 2), (0.6, 0.6), rotation=spin, material=wood)
        kit.add(BOX, hub + spin @ [0.03, 0.38, long * 0.6], (0.025, 0.36, long * 0.39), rotation=spin, material=cloth, cut=(GRID, 2.6, 0.3) if cloth.gloss > 0.1 or kind != "tower" else (LATTICE, 2.0, 0.4))


def power_station(kit):
    rng = kit.rng
    wall, glass, stone, steel = tinted(kit, (BRICK, CONCRETE, GREY, CREAM), (PLAIN, BRICKS, RIBS), frequency=18), panes(kit), tinted(kit, (WHITE, CONCRETE)), steelwork(kit)
    x, y, high = rng.uniform(3, 3.8), rng.uniform(5, 7), rng.uniform(5, 6.5)
    block(kit, (0, 0, 0), (x, y, high / 2), 1, (9, 8, 4), wall, glass, stone, 0.55)
    slab(kit, 0, 0, high, (x * 0.6, y * 0.95, 0.5), wall)
    kit.add(BOX, (0, 0, high + 0.5), (x * 0.62, y * 0.9, 0.25), material=glass)
    kind = rng.choice(["stacks", "cooling"])
    concrete = tinted(kit, (CONCRETE, WHITE, GREY), (STREAKS, PLAIN, CLOUDY))
    if kind == "stacks":
        slab(kit, -x - 2, 0, 0, (2.2, y * 0.9, high * 0.7), wall)
        for py in row(int(rng.integers(2, 5)), y * 0.9, 0.9):
            tall = high + rng.uniform(7, 7.1)
            kit.add(CYL, (-x - 2, py, tall / 2), (0.7, 0.7, tall / 2), (0.65, 1), material=concrete)
            kit.add(CYL, (-x - 2, py, tall - 0.5), (0.5, 0.5, 0.4), material=tinted(kit, ((0.55, 0.04, 0.03),)))
    else:
        for py in (-y * 0.55, y * 0.55):
            r = 2.6
            kit.loft((-x - 3.4, py, 0), [(0, r), (2.5, r * 0.8), (4.5, r * 0.66), (6, r * 0.62), (7.2, r * 0.64), (8.2, r * 0.7)], concrete)
            kit.add(CYL, (-x - 3.4, py, 8.2), (r * 0.62, r * 0.62, 0.03), material=kit.material(dark=True))
        kit.between((-x, 0, high * 0.5), (-x - 2.2, y * 0.5, 1.0), 0.3, material=steel)
    kit.add(BOX, (x + 0.05, 0, 1.4), (0.06, 0.9, 1.4), material=leaf(kit))
    for k in range(3):
        slab(kit, x + 1.6, y * (0.5 - 0.5 * k), 0, (0.6, 0.5, 0.55), steel)
        posts(kit, (x + 1.4, x + 1.8), (y * (0.5 - 0.5 * k),), 1.0, 1.6, 0.08, stone)


def terminal(kit):
    rng = kit.rng
    glass, steel, cover, stone = panes(kit), tinted(kit, (WHITE, GREY)), tinted(kit, (WHITE, GREY, BLUE), (PLAIN, RIBS), frequency=10), tinted(kit, (CONCRETE, WHITE))
    x, y, high = rng.uniform(3, 4), rng.uniform(7, 9), rng.uniform(3.5, 4.5)
    slab(kit, 0, 0, 0, (x + 0.4, y + 0.4, 0.15), stone)
    slab(kit, 0, 0, 0.3, (x, y, high / 2), glass)
    for py in np.linspace(-y, y, 10):
        kit.add(BOX, (0, py, high / 2 + 0.3), (x + 0.06, 0.07, high / 2), material=steel)
    slab(kit, 0, 0, high * 0.5, (x + 0.05, y + 0.05, 0.2), stone)
    waves = int(rng.integers(1, 4))
    width = (y + 0.6) / waves
    for k in range(waves):
        at = -y - 0.6 + width * (2 * k + 1)
        for a, b in zip(np.linspace(-1, 1, 6)[:-1], np.linspace(-1, 1, 6)[1:], strict=True):
            start, end = (0.4, at + width * a, high + 0.25 + 1.4 * (1 - a * a)), (0.4, at + width * b, high + 0.25 + 1.4 * (1 - b * b))
            kit.between(start, end, (0.09, x + 1.2), BOX, material=cover)
        kit.add(BOX, (0, at, high + 0.6), (x * 0.95, width * 0.93, 0.45), (1, 0.75), material=glass)
        kit.add(BOX, (0, at, high + 1.2), (x * 0.95, width * 0.62, 0.25), (1, 0.6), material=glass)
    tall = high + rng.uniform(5, 7)
    kit.add(CYL, (-x * 0.2, y + 2.2, tall / 2), (0.6, 0.6, tall / 2), (0.75, 1), material=stone)
    kit.add(PRISM, (-x * 0.2, y + 2.2, tall), (0.9, 0.9, 0.3), (1.3, 8), material=stone)
    kit.add(PRISM, (-x * 0.2, y + 2.2, tall + 0.75), (1.15, 1.15, 0.5), (1.12, 8), material=glass)
    kit.add(PRISM, (-x * 0.2, y + 2.2, tall + 1.3), (1.35, 1.35, 0.12), (0.95, 8), material=stone)
    kit.between((-x * 0.2, y + 2.2, tall + 1.3), (-x * 0.2, y + 2.2, tall + 2.8), 0.06, material=steel)
    slab(kit, -x * 0.1, y + 1.4, 0, (1.2, 1.4, 1.2), stone)
    for py in (-y * 0.55, y * 0.3):
        kit.add(BOX, (-x - 1.8, py, 2.3), (1.9, 0.4, 0.5), material=steel)
        slab(kit, -x - 3.2, py, 0, (0.25, 0.35, 0.95), steel)
    kit.add(BOX, (x + 1.0, 0, 2.6), (1.1, y * 0.7, 0.1), material=steel)
    posts(kit, (x + 1.9,), np.linspace(-y * 0.65, y * 0.65, 4), 0, 2.55, 0.07, steel)
    kit.add(BOX, (x + 1.3, 0, high * 0.85), (0.06, y * 0.3, 0.3), material=lettered(kit))
    kit.between((x + 0.1, 0, high * 0.85), (x + 1.3, 0, high * 0.85), 0.05, material=steel)


def shop(kit):
    rng = kit.rng
    wall, stone, glass, cloth, front = walls_of(kit), masonry(kit), panes(kit), striped(kit), tinted(kit, (GREEN, BLUE, RED, TIMBER, WHITE))
    x, y, storeys = rng.uniform(2.4, 3), rng.uniform(2.6, 3.6), int(rng.integers(1, 4))
    low = 3.2
    high = low + 2.8 * (storeys - 1)
    slab(kit, 0, 0, 0, (x, y, low / 2), wall)
    if storeys > 1:
        block(kit, (0, 0, low), (x, y, (high - low) / 2), storeys - 1, (4, 3, 2), wall, glass, stone)
    roof(kit, (0, 0, high), (x, y), 1.4, rng.choice(["flat", "hip", "gable", "mansard"]), 0.25, tiles(kit), stone, 1)
    kit.add(BOX, (x, 0, 1.45), (0.12, y * 0.96, 1.45), material=front)
    for side in (-1, 1):
        kit.add(BOX, (x + 0.1, side * y * 0.55, 1.5), (0.06, y * 0.34, 0.95), material=glass)
        kit.add(BOX, (x + 0.13, side * y * 0.55, 1.5), (0.05, 0.04, 0.95), material=front)
        kit.add(BOX, (x + 0.6, side * y * 0.52, 2.5), (0.65, y * 0.42, 0.03), rotation=turn("y", 24), material=cloth)
        kit.add(BOX, (x + 1.18, side * y * 0.52, 2.14), (0.02, y * 0.42, 0.12), material=cloth)
        slab(kit, x + 0.7, side * y * 0.55, 0, (0.35, y * 0.3, 0.3), tinted(kit, (WOOD, OCHRE), (PLANKS,), frequency=18))
        kit.add(BALL, (x + 0.7, side * y * 0.55, 0.62), (0.3, y * 0.28, 0.14), material=vivid(kit, (DOTS, SPECKLES), frequency=25))
    kit.add(BOX, (x + 0.12, 0, 2.98), (0.1, y * 0.94, 0.22), material=lettered(kit))
    kit.add(BOX, (x + 0.06, 0, 1.1), (0.1, 0.42, 1.1), material=leaf(kit))
    kit.add(BOX, (x + 0.55, y * 0.95, 3.9), (0.4, 0.05, 0.4), material=lettered(kit)) if storeys > 1 else None
    lights(kit, (0, 0, 1.7), (x, y), row(2, x), (0.4, 0.55), glass, stone, 1)
    door(kit, (-x, y * 0.4, 0), (0.45, 1.0), leaf(kit), stone)
    slab(kit, -x - 0.7, -y * 0.4, 0, (0.8, y * 0.5, 1.2), wall)
    chimney(kit, -x * 0.4, y * 0.6, high, high + 2)
