"""A maker of town buildings: halls, schools, factories, offices, flats, shops, stations, forts, ruins, and those of worship."""

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
    RED,
    SAND,
    SLATE,
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
from .installations import corners, tinted, trestle
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, LATTICE, PRISM, TUBE
from .materials import BANDS, BRICKS, CLOUDY, PLAIN, RIBS, SEAMS, SHINGLES, SPECKLES, STREAKS, STRIPES, WRITING
from .worship import arched, clock, mission, mosque, onion_church, pagoda, spire, stave_church, village_church


def town_building(kit):
    """Churches and chapels, mission fronts, town halls, schools, factories, warehouses, offices, towers, apartments, hotels, shops, cinemas, stations, keeps, forts,
    pagodas, mosques, mill houses, barn conversions, car parks, shells under construction, destroyed blocks."""
    kinds = [village_church, village_church, onion_church, stave_church, mission, town_hall, school, factory, warehouse, office, glass_tower, apartment, corner_shop]
    kinds += [cinema, station, fire_station, keep, fort, pagoda, mosque, mill_house, barn_conversion, car_park, construction, destroyed]
    kinds[kit.rng.integers(len(kinds))](kit)


def gridded(kit, at, half, storeys, bays, wall, glass, pier=0.22, band=0.3):
    """A block of glass behind floors and piers: windows on all sides. `at` (x, y, foot), `bays` along x and y."""
    x, y, z = at
    hx, hy, hz = half
    kit.add(BOX, (x, y, z + hz), (hx - 0.12, hy - 0.12, hz), material=glass)
    for k in range(storeys + 1):
        kit.add(BOX, (x, y, z + 2 * hz * k / storeys), (hx, hy, 2 * hz / storeys * band * 0.5), material=wall)
    for corner in corners(hx - pier + 0.03, hy - pier + 0.03, z + hz, x, y):
        kit.add(BOX, corner, (pier, pier, hz), material=wall)
    for place in np.linspace(-1, 1, bays[0] + 1)[1:-1]:
        kit.add(BOX, (x + place * (hx - pier), y, z + hz), (pier, hy + 0.03, hz), material=wall)
    for place in np.linspace(-1, 1, bays[1] + 1)[1:-1]:
        kit.add(BOX, (x, y + place * (hy - pier), z + hz), (hx + 0.03, pier, hz), material=wall)


def town_hall(kit):
    rng = kit.rng
    walls, cover, frame, glass = (masonry, render, brickwork)[rng.integers(3)](kit), tiles(kit), tinted(kit, (WHITE, STONE, CREAM)), panes(kit)
    x, y, high = rng.uniform(3.5, 4.5), rng.uniform(7, 9), 7.0
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    for z in (0.4, high / 2, high):
        kit.add(BOX, (0, 0, z), (x + 0.18, y + 0.18, 0.16 if z > 1 else 0.4), material=frame)
    roof(kit, (0, 0, high), (x, y), x * 0.7, rng.choice(["hip", "mansard"]), 0.3, cover, frame, 1)
    arched(kit, (0, 0, 0), (x, y), row(6, y, 0.92), 0.5, 1.3, 2.4, glass, 0)
    lights(kit, (0, 0, 5.2), (x, y), row(6, y, 0.92), (0.5, 0.85), glass, frame, 0, False)
    lights(kit, (0, 0, 5.2), (x, y), row(2, x), (0.5, 0.85), glass, frame, 1, False)
    half, tall = rng.uniform(1.5, 2), high + rng.uniform(4.5, 7.5)
    at = x - half * 0.6
    kit.add(BOX, (at, 0, tall / 2), (half, half, tall / 2), material=walls)
    kit.add(BOX, (at, 0, tall), (half + 0.3, half + 0.3, 0.2), material=frame)
    clock(kit, (at, 0, tall - half * 0.85), half, half * 0.62, frame)
    kit.add(PRISM, (at, 0, tall + 0.8), (half * 0.72, half * 0.72, 0.8), (1, 8), material=frame)
    if kit.chance(0.5):
        kit.add(BALL, (at, 0, tall + 1.6), (half * 0.8, half * 0.8, half * 0.9), material=tinted(kit, (COPPER, SLATE, GOLD)))
        kit.between((at, 0, tall + 2.8), (at, 0, tall + 4.6), 0.07, material=tinted(kit, (GOLD, GREY)))
    else:
        spire(kit, at, 0, tall + 1.6, half * 0.85, rng.uniform(2.5, 4.5), cover, 8)
    front = at + half
    kit.add(BOX, (front + 0.6, 0, 0.25), (1.4, half + 1.2, 0.25), material=frame)
    for side in (-1, -0.35, 0.35, 1):
        kit.add(CYL, (front + 1.2, side * (half + 0.4), 1.9), (0.2, 0.2, 1.5), material=frame)
    kit.add(BOX, (front + 0.5, 0, 3.5), (1.1, half + 0.9, 0.2), material=frame)
    kit.add(BOX, (front + 0.5, 0, 4.1), (1.1, half + 0.9, 0.5), (1, 0.02), material=walls)
    door(kit, (front, 0, 0.5), (0.7, 1.2), leaf(kit), frame)


def school(kit):
    rng = kit.rng
    walls, glass, frame = (brickwork, render, masonry)[rng.integers(3)](kit), panes(kit), trim(kit)
    if kit.chance(0.5):  # modern wings
        long, storeys = rng.uniform(7, 10), int(rng.integers(2, 4))
        gridded(kit, (0, 0, 0), (3.4, long, 1.6 * storeys), storeys, (2, 9), walls, glass, 0.2, 0.4)
        kit.add(BOX, (0, 0, 3.2 * storeys + 0.2), (3.7, long + 0.3, 0.2), material=frame)
        side = rng.choice([-1, 1])
        kit.add(BOX, (4.5, side * (long - 2.2), 1.6 * storeys), (2.2, 2.4, 1.6 * storeys + 0.7), material=walls)
        kit.add(BOX, (6.72, side * (long - 2.2), 2.2 * storeys), (0.05, 0.9, 0.7 * storeys), material=glass)
        kit.add(BOX, (4.6, -side * long * 0.2, 2.6), (1.5, 2.2, 0.12), material=frame)
        for place in (-1.9, 1.9):
            kit.add(CYL, (5.8, -side * long * 0.2 + place, 1.3), (0.12, 0.12, 1.3), material=frame)
        door(kit, (3.45, -side * long * 0.2, 0), (1.1, 1.15), glass, leaf(kit))
        kit.between((7.5, -side * long * 0.5, 0), (7.5, -side * long * 0.5, 6), 0.07, material=frame)
        kit.add(BOX, (4.5, -side * long * 0.5, 0.05), (3.6, 2, 0.05), material=tinted(kit, (CONCRETE,)))
        kit.add(BOX, (7.5, -side * long * 0.5 + 0.75, 5.4), (0.03, 0.7, 0.45), material=leaf(kit))
        return
    x, y, cover = 3.2, rng.uniform(4.5, 6), tiles(kit)
    kit.add(BOX, (0, 0, 1.9), (x, y, 1.9), material=walls)
    kit.add(BOX, (0, 0, 0.2), (x + 0.1, y + 0.1, 0.2), material=masonry(kit))
    roof(kit, (0, 0, 3.8), (x, y), x * 0.8, "gable", 0.4, cover, walls, 1)
    lights(kit, (0, 0, 2.1), (x, y), [-y * 0.78, -y * 0.5, y * 0.5, y * 0.78], (0.5, 0.95), glass, frame, 0)
    lights(kit, (0, 0, 2.1), (x, y), row(2, x), (0.5, 0.95), glass, frame, 1)
    kit.add(BOX, (x + 0.5, 0, 2.1), (0.9, 1.4, 2.1), material=walls)
    roof(kit, (x - 0.1, 0, 4.2), (1.5, 1.4), 1.6, "gable", 0.25, cover, walls, 0)
    kit.add(BOX, (x * 0.2, 0, 3.8 + x * 0.8 + 0.6), (0.75, 0.75, 1.3), material=frame)
    arched(kit, (x * 0.2, 0, 0), (0.75, 0.75), [0], 0.4, 6.9, 7.4, kit.material(dark=True), 0)
    arched(kit, (x * 0.2, 0, 0), (0.75, 0.75), [0], 0.4, 6.9, 7.4, kit.material(dark=True), 1)
    spire(kit, x * 0.2, 0, 5.7 + x * 0.8, 1.0, 1.7, cover)
    door(kit, (x + 1.4, 0, 0), (0.7, 1.2), leaf(kit), frame)
    kit.add(BOX, (x + 2.1, 0, 0.12), (0.8, 1.3, 0.12), material=masonry(kit))


def factory(kit):
    rng = kit.rng
    walls, glass, dark = (brickwork, brickwork, render)[rng.integers(3)](kit), panes(kit), tinted(kit, (SLATE, GREY, TILE), (RIBS, PLAIN), frequency=10)
    count, bay, y, high = int(rng.integers(4, 7)), rng.uniform(1.5, 2.0), rng.uniform(5, 7), rng.uniform(3.6, 4.8)
    x = count * bay
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    for k in range(count):
        at, rise = -x + (2 * k + 1) * bay, bay * 0.75
        kit.add(BOX, (at, 0, high + rise), (bay, y, rise), (0.02, 1), (bay * 0.97, 0), material=walls)
        kit.add(BOX, (at, 0, high + rise + 0.1), (np.hypot(bay, rise) * 1.0, y + 0.12, 0.06), rotation=turn("y", -np.degrees(np.arctan2(rise, bay))), material=dark)
        kit.add(BOX, (at + bay * 0.985, 0, high + rise), (0.05, y * 0.94, rise * 0.72), material=glass)
    lights(kit, (0, 0, high * 0.52), (x, y), row(count, x, 1.0), (bay * 0.55, 0.9), glass, trim(kit), 1)
    lights(kit, (0, 0, high * 0.62), (x, y), row(3, y), (0.8, 0.8), glass, trim(kit), 0, False)
    kit.add(BOX, (x, 0, 1.4), (0.1, 1.4, 1.4), material=leaf(kit))
    tall, radius = high + rng.uniform(7, 12), rng.uniform(0.7, 0.95)
    stack = brickwork(kit) if kit.chance(0.7) else tinted(kit, (CONCRETE, WHITE), (BANDS,), frequency=5, second=RED)
    px, py = -x - 1.6, rng.uniform(-0.6, 0.6) * y
    kit.add(BOX, (px, py, 0.9), (1.3, 1.3, 0.9), material=walls)
    kit.add(CYL, (px, py, tall / 2), (radius, radius, tall / 2), (0.62, 1), material=stack)
    kit.add(CYL, (px, py, tall), (radius * 0.75, radius * 0.75, 0.3), material=stack)
    side = rng.choice([-1, 1])
    kit.add(BOX, (x * 0.4, side * (y + 1.8), 1.7), (x * 0.45, 1.9, 1.7), material=walls)
    kit.add(BOX, (x * 0.4, side * (y + 1.8), 3.45), (x * 0.47, 2.0, 0.12), material=dark)
    lights(kit, (x * 0.4, side * (y + 1.8), 1.8), (x * 0.45, 1.9), row(3, x * 0.45), (0.6, 0.6), glass, trim(kit), 1, False)


def warehouse(kit):
    rng = kit.rng
    glass, frame = panes(kit), trim(kit)
    if kit.chance(0.5):  # brick, with hoists
        walls, x, y, storeys = brickwork(kit), rng.uniform(4, 5.5), rng.uniform(3, 4), int(rng.integers(3, 5))
        high = 2.7 * storeys
        kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
        roof(kit, (0, 0, high), (x, y), y * 0.8, "gable", 0.2, tiles(kit), walls, 0)
        for k in range(storeys):
            lights(kit, (0, 0, 1.5 + 2.7 * k), (x, y), row(4, x, 0.9), (0.45, 0.6), glass, frame, 1, False)
            lights(kit, (0, 0, 1.5 + 2.7 * k), (x, y), [-y * 0.6, y * 0.6], (0.4, 0.6), glass, frame, 0, False)
            kit.add(BOX, (x, 0, 1.25 + 2.7 * k), (0.08, 0.7, 1.05), material=leaf(kit))
        kit.add(BOX, (x + 0.5, 0, high + y * 0.55), (1.0, 0.16, 0.14), material=tinted(kit, (TIMBER, GREY)))
        kit.between((x + 1.3, 0, high * 0.45), (x + 1.3, 0, high + y * 0.55), 0.03, material=kit.material(dark=True))
        kit.add(BOX, (x + 1.3, 0, high * 0.42), (0.35, 0.35, 0.3), material=tinted(kit, (WOOD,)))
        return
    skin = tinted(kit, (GREY, WHITE, BLUE, GREEN, CREAM), (RIBS, STRIPES, PLAIN), frequency=rng.uniform(8, 16), gloss=0.1)
    x, y, high = rng.uniform(5, 7), rng.uniform(7, 10), rng.uniform(4, 5.5)
    stripe = tinted(kit, (RED, BLUE, YELLOW, GREEN, TIMBER))
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=skin)
    roof(kit, (0, 0, high), (x, y), x * 0.2, "gable", 0.15, tinted(kit, (GREY, WHITE), (RIBS,), frequency=9), skin, 0 if kit.chance(0.4) else 1)
    kit.add(BOX, (0, 0, high - 0.35), (x + 0.06, y + 0.06, 0.3), material=stripe)
    kit.add(BOX, (0, 0, 0.4), (x + 0.04, y + 0.04, 0.4), material=tinted(kit, (CONCRETE,)))
    for place in row(5, y, 0.85):
        kit.add(BOX, (x, place, 1.75), (0.22, 0.85, 1.0), material=kit.material(dark=True))
        kit.add(BOX, (x, place, 1.75), (0.25, 0.65, 0.85), material=tinted(kit, (WHITE, GREY), (BANDS,), frequency=20))
        kit.add(BOX, (x + 0.3, place, 0.45), (0.3, 0.8, 0.45), material=kit.material(dark=True))
    kit.add(BOX, (x + 0.7, 0, 3.15), (0.8, y * 0.9, 0.08), material=stripe)
    side = rng.choice([-1, 1])
    gridded(kit, (x * 0.3, side * (y + 1.5), 0), (x * 0.6, 1.7, 2.6), 2, (4, 2), skin, glass)
    kit.add(BOX, (x + 0.05, side * y * 0.3, high - 0.9), (0.06, 1.6, 0.35), material=tinted(kit, (WHITE,), (WRITING,), frequency=18))
    lights(kit, (0, 0, high - 1.1), (x, y), row(4, x), (0.6, 0.3), glass, frame, 1, False)


def office(kit):
    """Blocks of offices with setbacks, and plain ones."""
    rng = kit.rng
    walls, glass = (masonry, render, brickwork)[rng.integers(3)](kit), panes(kit)
    x, y, z, tiers = rng.uniform(3.5, 5), rng.uniform(3.5, 6), 0.0, int(rng.integers(1, 4))
    kit.add(BOX, (0, 0, 1.7), (x + 0.15, y + 0.15, 0.2), material=walls)
    for k in range(tiers):
        storeys = int(rng.integers(4, 8)) if tiers == 1 else int(rng.integers(3, 5))
        gridded(kit, (0, 0, z), (x, y, 1.6 * storeys), storeys, (4, 5) if k == 0 else (3, 3), walls, glass, rng.uniform(0.12, 0.3), rng.uniform(0.25, 0.5))
        z += 3.2 * storeys
        kit.add(BOX, (0, 0, z + 0.3), (x + 0.1, y + 0.1, 0.4), material=walls)
        x, y = x * rng.uniform(0.6, 0.8), y * rng.uniform(0.6, 0.8)
    if kit.chance(0.4) and tiers > 1:
        spire(kit, 0, 0, z + 0.6, min(x, y) * 1.1, rng.uniform(3, 6), tinted(kit, (COPPER, SLATE, GOLD)))
    else:
        kit.add(BOX, (x * 0.1, y * 0.2, z + 1.1), (x * 0.5, y * 0.4, 0.9), material=tinted(kit, (GREY, WHITE)))
        kit.between((-x * 0.3, 0, z), (-x * 0.3, 0, z + rng.uniform(2, 5)), 0.08, material=tinted(kit, (GREY, RED)))


def glass_tower(kit):
    rng = kit.rng
    tint = np.array([(0.08, 0.16, 0.22), (0.05, 0.12, 0.3), (0.12, 0.2, 0.18), (0.25, 0.3, 0.35), (0.05, 0.05, 0.06)][rng.integers(5)])
    glass = kit.material(
        base=tint, second=tint * rng.uniform(1.5, 3), pattern=rng.choice([SEAMS, BANDS, STRIPES, PLAIN]), frequency=rng.uniform(14, 30), gloss=rng.uniform(0.3, 0.6)
    )
    frame = tinted(kit, (GREY, WHITE, TIMBER, CONCRETE), gloss=0.3)
    half, tall, shape = rng.uniform(2.2, 3), rng.uniform(16, 28), rng.choice(["box", "round", "taper", "twin", "prism"])
    kit.add(BOX, (0, 0, 0.8), (half * 1.5, half * 1.5, 0.8), material=frame)
    kit.add(BOX, (0, 0, 0.75), (half * 1.52, half * 1.4, 0.5), material=glass)
    kind, taper = {"round": (CYL, (1, 1)), "prism": (PRISM, (rng.uniform(0.7, 1), int(rng.integers(5, 9))))}.get(shape, (BOX, (1, 1)))
    if shape == "taper":
        taper = (rng.uniform(0.3, 0.75), rng.uniform(0.3, 0.75))
    kit.add(kind, (0, 0, tall / 2), (half, half, tall / 2), taper, material=glass)
    if shape == "twin":
        kit.add(BOX, (half * 0.5, half * 1.1, tall * 0.4), (half * 0.8, half * 0.8, tall * 0.4), material=glass)
    if shape in ("box", "round", "twin"):
        for k in range(1, 9):
            kit.add(kind, (0, 0, tall * k / 9), (half + 0.06, half + 0.06, 0.09), material=frame)
    if shape in ("box", "twin"):
        for place in np.linspace(-0.97, 0.97, 5):
            kit.add(BOX, (place * half, 0, tall / 2), (0.09, half + 0.1, tall / 2), material=frame)
            kit.add(BOX, (0, place * half, tall / 2), (half + 0.1, 0.09, tall / 2), material=frame)
    top = half * taper[0] if shape in ("taper", "prism") else half
    narrow = half * taper[1] if shape == "taper" else top
    crown = rng.choice(["slant", "spire", "frame", "steps"])
    if crown == "slant" and kind == BOX:
        kit.add(BOX, (0, 0, tall + top * 0.6), (top, narrow, top * 0.6), (0.03, 1), (-top * 0.95, 0), material=glass)
    elif crown == "frame" and kind != BOX:
        kit.add(TUBE, (0, 0, tall + 0.8), (top * 0.96, top * 0.96, 0.9), material=frame, cut=(BARS, 6, 0.3))
        kit.add(CYL, (0, 0, tall + 0.4), (top * 0.5, top * 0.5, 0.5), material=frame)
    else:
        for k in range(3):
            kit.add(
                kind,
                (0, 0, tall + 0.8 * k + 0.4),
                (top * (0.8 - 0.22 * k), narrow * (0.8 - 0.22 * k), 0.42),
                (1, taper[1]) if kind == PRISM else (1, 1),
                material=glass if k else frame,
            )
        if crown != "steps":
            kit.loft((0, 0, tall + 2.3), [(0, 0.25), (rng.uniform(3, 6), 0.04)], frame)


def apartment(kit):
    """Apartment blocks and hotels: windows and balconies on every storey."""
    rng = kit.rng
    walls, second, glass = (render, brickwork, render)[rng.integers(3)](kit), render(kit), panes(kit)
    storeys, x, y = int(rng.integers(4, 8)), rng.uniform(3, 4), rng.uniform(5, 8)
    z, columns = 3.0 * storeys, int(rng.choice([2, 3])) if storeys < 7 else 2
    gridded(kit, (0, 0, 0), (x, y, z / 2), storeys, (2, columns * 2), walls, glass, 0.3, 0.36)
    kit.add(BOX, (0, 0, z + 0.25), (x + 0.12, y + 0.12, 0.3), material=second)
    solid = kit.chance(0.5)
    for k in range(1, storeys):
        for place in row(columns, y, 0.95):
            kit.add(BOX, (x + 0.5, place, 3.0 * k), (0.65, y * 0.7 / columns, 0.1), material=second)
            if solid:
                kit.add(BOX, (x + 1.1, place, 3.0 * k + 0.5), (0.06, y * 0.7 / columns, 0.5), material=second)
            else:
                kit.railing((x + 1.1, place - y * 0.7 / columns, 3.0 * k), (x + 1.1, place + y * 0.7 / columns, 3.0 * k), 1.0, second, 0.3, thick=0.04)
    kit.add(BOX, (x + 0.7, 0, 2.5), (0.9, 1.3, 0.12), material=second)
    door(kit, (x, 0, 0), (0.9, 1.1), glass, second)
    kit.add(BOX, (-x * 0.2, 0, z + 1.0), (x * 0.4, y * 0.25, 0.9), material=walls)
    if kit.chance(0.4):  # the hotel's sign
        kit.add(BOX, (x * 0.9, 0, z + 1.1), (0.1, y * 0.6, 0.7), material=tinted(kit, (RED, YELLOW, BLUE), (WRITING,), frequency=9, second=(0.9, 0.8, 0.6)))


def corner_shop(kit):
    rng = kit.rng
    walls, glass, frame, paint = walls_of(kit), panes(kit), trim(kit), leaf(kit)
    x, y, storeys = rng.uniform(3.2, 4.2), rng.uniform(3.2, 4.8), int(rng.integers(2, 4))
    high = 3.0 * storeys + 0.3
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    kit.add(BOX, (0, 0, 1.6), (x + 0.06, y + 0.06, 1.6), material=paint)
    for facing, long in ((0, y), (1, x)):
        lights(kit, (0, 0, 1.55), (x + 0.06, y + 0.06), [-long * 0.5, long * 0.5], (long * 0.36, 0.95), glass, frame, facing, False)
        for k in range(1, storeys):
            lights(kit, (0, 0, 1.9 + 3.0 * k), (x, y), row(3, long), (0.45, 0.75), glass, frame, facing, storeys == 2)
    kit.add(BOX, (0, 0, 2.95), (x + 0.14, y + 0.14, 0.28), material=tinted(kit, (RED, GREEN, BLUE, TIMBER, YELLOW), (WRITING,), frequency=12, second=(0.85, 0.8, 0.6)))
    awning = tinted(kit, (RED, GREEN, BLUE, YELLOW), (STRIPES,), frequency=rng.uniform(9, 16), second=(0.85, 0.85, 0.8))
    kit.add(BOX, (x + 0.7, 0, 2.45), (0.8, y * 0.9, 0.05), rotation=turn("y", 22), material=awning)
    kit.add(BOX, (x + 1.42, 0, 2.05), (0.04, y * 0.9, 0.16), material=awning)
    door(kit, (x + 0.06, 0, 0), (0.45, 1.1), leaf(kit), frame)
    kind = rng.choice(["flat", "hip", "mansard", "false"])
    if kind in ("hip", "mansard"):
        roof(kit, (0, 0, high), (x, y), min(x, y) * 0.6, kind, 0.35, tiles(kit), frame, int(y > x))
        chimney(kit, -x * 0.3, y * 0.2, high, high + min(x, y) * 0.6 + 0.8)
    else:
        kit.add(BOX, (0, 0, high), (x + 0.25, y + 0.25, 0.18), material=frame)
        if kind == "false":
            kit.add(BOX, (x - 0.05, 0, high + 0.7), (0.15, y + 0.1, 0.8), material=walls)
            kit.add(BOX, (x - 0.05, 0, high + 1.6), (0.15, y * 0.5, 0.4), (1, 0.5), material=walls)
    for place in (0.55, -0.55):
        kit.add(BOX, (x + 0.6, place * y, 0.4), (0.35, 0.6, 0.4), material=tinted(kit, (WOOD, GREEN)))
        kit.add(BALL, (x + 0.6, place * y, 0.8), (0.33, 0.55, 0.22), material=tinted(kit, (RED, YELLOW, LEAF), (SPECKLES,), frequency=30))


def cinema(kit):
    rng = kit.rng
    walls, glass, trimming = render(kit), panes(kit), tinted(kit, (RED, GOLD, BLUE, WHITE))
    x, y, high = rng.uniform(5.5, 7), rng.uniform(4, 5), rng.uniform(6, 7.5)
    kit.add(BOX, (-0.8, 0, high * 0.45), (x - 0.8, y, high * 0.45), material=brickwork(kit))
    kit.add(BOX, (x - 0.8, 0, high / 2), (1, y + 0.2, high / 2), material=walls)
    for wide, tall in ((0.7, 1.0), (0.42, 2.0)):
        kit.add(BOX, (x - 0.8, 0, high + tall / 2), (1.0 if tall < 1.5 else 0.9, wide * y, tall / 2), material=walls)
    for side in (-0.36, -0.18, 0.18, 0.36):
        kit.add(BOX, (x + 0.2, side * y, high * 0.5 + 1.2), (0.16, 0.14, high * 0.5 - 0.4), material=trimming)
    kit.add(BOX, (x + 0.15, 0, 1.25), (0.08, y * 0.8, 1.2), material=glass)
    for place in row(6, y * 0.8, 1.0):
        kit.add(BOX, (x + 0.18, place, 1.25), (0.09, 0.07, 1.25), material=trimming)
    sign = tinted(kit, (WHITE, CREAM), (WRITING,), frequency=rng.uniform(9, 14), second=(0.03, 0.03, 0.03), gloss=-0.3)
    kit.add(BOX, (x + 1.0, 0, 3.1), (1.0, y * 0.8, 0.16), material=trimming)
    kit.add(BOX, (x + 1.0, 0, 3.6), (1.02, y * 0.82, 0.42), (1, 0.9), material=sign)
    kit.add(BOX, (x + 1.0, 0, 4.08), (1.1, y * 0.82, 0.08), material=trimming)
    kit.add(BOX, (x + 0.9, 0, high + 0.3), (0.75, 0.22, 2.2), material=trimming)
    kit.add(BOX, (x + 0.95, 0, high + 0.3), (0.62, 0.26, 2.0), material=tinted(kit, (RED, BLUE, YELLOW), (WRITING,), frequency=9, second=(0.9, 0.85, 0.6), gloss=-0.3))
    kit.add(BALL, (x + 0.9, 0, high + 2.7), (0.35, 0.35, 0.35), material=trimming)
    kit.add(BOX, (x + 0.2, 0, 0.45), (0.5, 0.6, 0.9), material=trimming)
    lights(kit, (-0.8, 0, high * 0.5), (x - 0.8, y), row(3, x * 0.7), (0.35, 0.5), glass, trim(kit), 1, False)
    for side in (-1, 1):
        kit.add(BOX, (x + 0.15, side * y * 0.9, 1.5), (0.12, 0.3, 0.6), material=tinted(kit, (RED, YELLOW, BLUE), (WRITING,), frequency=20))


def station(kit):
    rng = kit.rng
    walls, cover, frame, glass = (brickwork, masonry, render)[rng.integers(3)](kit), tiles(kit), trim(kit), panes(kit)
    x, y, high = rng.uniform(3, 3.8), rng.uniform(7, 9), 3.8
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    roof(kit, (0, 0, high), (x, y), x * 0.5, "hip", 0.5, cover, frame, 1)
    arched(kit, (0, 0, 0), (x, y), row(8, y, 0.95), 0.45, 0.9, 2.3, glass, 0)
    mid, up = rng.uniform(1.8, 2.6), high + rng.uniform(1.8, 3)
    kit.add(BOX, (0.2, 0, up / 2), (x + 0.4, mid, up / 2), material=walls)
    if kit.chance(0.5):
        roof(kit, (0.2, 0, up), (x + 0.4, mid), mid * 0.9, "gable", 0.35, cover, walls, 0)
        kit.add(CYL, (0.2, 0, up + mid * 0.2), (0.75, 0.75, x + 0.5), rotation=ALONG_X, material=frame)
        kit.add(CYL, (0.2, 0, up + mid * 0.2), (0.62, 0.62, x + 0.53), rotation=ALONG_X, material=tinted(kit, (WHITE,)))
        kit.add(BOX, (0.2, 0, up + mid * 0.2 + 0.15), (x + 0.56, 0.05, 0.35), material=kit.material(dark=True))
    else:
        kit.add(BOX, (0.2, 0, up + 1.2), (1.2, 1.2, 2.2), material=walls)
        clock(kit, (0.2, 0, up + 2.4), 1.2, 0.8, frame)
        kit.add(BOX, (0.2, 0, up + 3.4), (1.4, 1.4, 0.12), material=frame)
        spire(kit, 0.2, 0, up + 3.5, 1.4, rng.uniform(1.5, 3), cover)
        kit.add(BOX, (0.2, 0, up + 0.1), (x + 0.6, mid + 0.2, 0.15), material=frame)
    arched(kit, (0.2, 0, 0), (x + 0.4, mid), [-mid * 0.5, mid * 0.5], mid * 0.32, 0, 2.4, glass, 0)
    iron = tinted(kit, (GREEN, RED, TIMBER, GREY))
    kit.add(BOX, (-x - 2.2, 0, 0.15), (2.2, y + 2, 0.45), material=tinted(kit, (CONCRETE,), (SEAMS,), frequency=8))
    for place in row(6, y, 1.05):
        kit.add(CYL, (-x - 2.6, place, 1.9), (0.1, 0.1, 1.6), material=iron)
    kit.add(BOX, (-x - 1.6, 0, 3.5), (1.9, y + 0.6, 0.1), rotation=turn("y", -6), material=cover)
    kit.add(BOX, (x + 0.64, 0, 3.3), (0.05, mid * 0.9, 0.25), material=tinted(kit, (BLUE, WHITE, TIMBER), (WRITING,), frequency=16, second=(0.85, 0.8, 0.7)))


def fire_station(kit):
    rng = kit.rng
    walls, red, frame, glass = (brickwork, render)[rng.integers(2)](kit), tinted(kit, ((0.45, 0.02, 0.02),), (BANDS, PLAIN), frequency=20), trim(kit), panes(kit)
    bays, x = int(rng.integers(2, 5)), rng.uniform(4, 5)
    y = bays * 2.1
    high = 4.4
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    kit.add(BOX, (0, 0, high), (x + 0.3, y + 0.15, 0.25), material=frame)
    for place in row(bays, y, 0.97):
        kit.add(BOX, (x, place, 1.9), (0.06, 1.7, 1.9), material=frame)
        kit.add(BOX, (x, place, 1.85), (0.09, 1.55, 1.8), material=red)
        kit.add(BOX, (x, place, 2.3), (0.12, 1.3, 0.35), material=glass)
    if kit.chance(0.5):
        kit.add(BOX, (-0.4, 0, high + 1.6), (x - 0.6, y - 0.1, 1.6), material=walls)
        lights(kit, (-0.4, 0, high + 1.7), (x - 0.6, y - 0.1), row(bays * 2, y), (0.6, 0.65), glass, frame, 0, False)
        kit.add(BOX, (-0.4, 0, high + 3.2), (x - 0.4, y + 0.1, 0.2), material=frame)
    side, half, tall = rng.choice([-1, 1]), rng.uniform(1.1, 1.5), rng.uniform(10, 13)
    at = side * (y + half)
    kit.add(BOX, (-x * 0.3, at, tall / 2), (half, half, tall / 2), material=walls)
    kit.add(BOX, (-x * 0.3, at, tall + 0.1), (half + 0.25, half + 0.25, 0.2), material=red)
    for k in range(3):
        lights(kit, (-x * 0.3, at, 3 + k * 3), (half, half), [0], (0.4, 0.5), kit.material(dark=True), frame, 0, False)
    lights(kit, (-x * 0.3, at, tall - 1.3), (half, half), [0], (0.7, 0.6), kit.material(dark=True), frame, 1, False)
    kit.add(BOX, (x + 0.05, 0, high - 0.4), (0.08, y * 0.6, 0.25), material=tinted(kit, (WHITE,), (WRITING,), frequency=16, second=(0.4, 0.02, 0.02)))
    kit.add(BOX, (x * 0.1, -side * (y + 1.5), 1.5), (x * 0.7, 1.6, 1.5), material=walls)
    kit.add(BOX, (x * 0.1, -side * (y + 1.5), 3.05), (x * 0.7 + 0.15, 1.75, 0.12), material=frame)
    lights(kit, (x * 0.1, -side * (y + 1.5), 1.6), (x * 0.7, 1.6), row(3, x * 0.7), (0.55, 0.55), glass, frame, 1, False)
    kit.between((-x * 0.3, at, tall), (-x * 0.3, at, tall + 3), 0.06, material=frame)


def keep(kit):
    rng = kit.rng
    stone, dark, cover = masonry(kit), kit.material(dark=True), tiles(kit)
    half, tall, kind = rng.uniform(3, 4), rng.uniform(6, 9), CYL if kit.chance(0.6) else BOX
    kit.add(BOX, (0, 0, 0.6), (half * 1.12, half * 1.12, 0.6), (0.93, 0.93), material=stone)
    kit.add(BOX, (0, 0, tall / 2), (half, half, tall / 2), material=stone)
    roofed, radius = kit.chance(0.5), half * rng.uniform(0.26, 0.36)
    up = tall + rng.uniform(0.8, 2.2)
    for px, py, _ in corners(half, half, 0):
        kit.add(kind, (px, py, up / 2), (radius, radius, up / 2), material=stone)
        kit.add(kind, (px, py, up + 0.3), (radius * 1.18, radius * 1.18, 0.4), material=stone)
        if roofed:
            kit.add(kind, (px, py, up + 0.6 + radius * 1.3), (radius * 1.3, radius * 1.3, radius * 1.3), (0.02, 0.02 if kind == BOX else 1), material=cover)
        else:
            for qx, qy in around(4, radius * 0.95, 45 if kind == BOX else 0):
                kit.add(BOX, (px + qx, py + qy, up + 0.9), (radius * 0.22, radius * 0.22, 0.3), material=stone)
    for axis, size in ((0, (half * 0.8, 0.2)), (1, (0.2, half * 0.8))):
        for side in (-1, 1):
            spot = np.eye(3)[1 - axis] * side * (half - 0.15)
            for place in (-0.45, 0, 0.45):
                reach = (half * 0.14, 0.2, 0.4) if axis == 0 else (0.2, half * 0.14, 0.4)
                kit.add(BOX, spot + np.eye(3)[axis] * place * half + [0, 0, tall + 0.35], reach, material=stone)
    arched(kit, (half - 0.3, 0, 0), (0.3, 1), [0], 0.8, 0, 1.4, dark, 0, 0.12)
    lights(kit, (0, 0, tall * 0.62), (half, half), row(2, half, 0.6), (0.16, 0.55), dark, stone, 0, False)
    lights(kit, (0, 0, tall * 0.62), (half, half), row(2, half, 0.6), (0.16, 0.55), dark, stone, 1, False)
    if roofed:
        kit.add(BOX, (0, 0, tall + half * 0.35), (half * 0.75, half * 0.75, half * 0.4), (0.4, 0.02), material=cover)


def fort(kit):
    rng = kit.rng
    stone, dark, earth = masonry(kit), kit.material(dark=True), tinted(kit, (LEAF, SAND, CONCRETE), (CLOUDY,))
    half, high = rng.uniform(6, 8), rng.uniform(2.2, 3.2)
    kit.add(BOX, (0, 0, 0.2), (half * 0.95, half * 0.95, 0.22), material=earth)
    for axis in (0, 1):
        for side in (-1, 1):
            spin = turn("z", 90 * axis)
            kit.add(BOX, spin @ [0, side * half, high / 2], (half, 1.0, high / 2), (1, 0.75), rotation=spin, material=stone)
            kit.add(BOX, spin @ [0, side * (half + 0.5), high + 0.25], (half, 0.22, 0.3), rotation=spin, material=stone)
    for k, (px, py, _) in enumerate(corners(half, half, 0)):
        spin = turn("z", 45 + 90 * k)
        kit.add(BOX, np.array([px, py, high / 2]) + spin @ [0.6, 0, 0], (2.3, 2.3, high / 2), (0.9, 0.9), rotation=turn("z", 45 + 90 * k) @ turn("z", 45), material=stone)
        kit.add(CYL, np.array([px, py, high * 0.55]) + spin @ [3.4, 0, 0.6], (0.42, 0.42, 0.9), material=stone)
        kit.add(CYL, np.array([px, py, high * 0.55]) + spin @ [3.4, 0, 1.75], (0.5, 0.5, 0.35), (0.1, 1), material=stone)
        kit.between(np.array([px, py, high + 0.35]) + spin @ [0.6, 0, 0], np.array([px, py, high + 0.55]) + spin @ [2.6, 0, 0], 0.18, CYL, 0.7, material=dark)
        kit.add(BOX, np.array([px, py, high + 0.15]) + spin @ [0.9, 0, 0], (0.5, 0.3, 0.2), rotation=spin, material=dark)
    kit.add(BOX, (half, 0, high * 0.65), (1.2, 1.7, high * 0.65), material=stone)
    arched(kit, (half, 0, 0), (1.2, 1), [0], 0.75, 0, 1.1, dark, 0)
    for side in (-1, 1):
        at = side * half * 0.45
        kit.add(BOX, (-half * 0.25, at, 1.3), (half * 0.4, 1.3, 1.2), material=render(kit))
        roof(kit, (-half * 0.25, at, 2.5), (half * 0.4, 1.3), 1.0, "gable", 0.25, tiles(kit), stone, 0)
    kit.between((0, 0, 0.2), (0, 0, high + 5), 0.09, material=tinted(kit, (WHITE,)))
    kit.add(BOX, (0.9, 0, high + 4.3), (0.85, 0.03, 0.6), material=tinted(kit, (RED, BLUE, YELLOW), (BANDS, STRIPES), frequency=8, second=(0.8, 0.8, 0.8)))


def mill_house(kit):
    """Windmills with a house below their gallery, and watermills."""
    rng = kit.rng
    walls, cover, frame, glass, wood = walls_of(kit), tiles(kit), trim(kit), panes(kit), tinted(kit, (WOOD, TIMBER, WHITE))
    if kit.chance(0.4):  # a watermill
        x, y, high = rng.uniform(2.8, 3.4), rng.uniform(3.6, 4.6), 5.2
        kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
        roof(kit, (0, 0, high), (x, y), x * 0.9, "gable", 0.4, cover, walls, 1)
        for z in (1.5, 4.0):
            lights(kit, (0, 0, z), (x, y), row(3, y), (0.42, 0.5), glass, frame, 0)
        lights(kit, (0, 0, 4), (x, y), [0], (0.42, 0.5), glass, frame, 1)
        radius, at = rng.uniform(2.0, 2.5), -y - 0.75
        kit.add(TUBE, (0, at, radius - 0.2), (radius, radius, 0.5), rotation=ALONG_Y, material=wood)
        for k in range(6):
            kit.add(BOX, (0, at, radius - 0.2), (0.07, 0.45, radius), rotation=turn("y", 30 * k), material=wood)
        for k in range(12):
            spin = turn("y", 30 * k + 15)
            kit.add(BOX, np.array([0, at, radius - 0.2]) + spin @ [0, 0, radius], (0.05, 0.5, 0.25), rotation=spin, material=wood)
        kit.add(CYL, (0, at + 0.1, radius - 0.2), (0.2, 0.2, 0.9), rotation=ALONG_Y, material=wood)
        door(kit, (x, 0, 0), (0.5, 1.05), leaf(kit), frame)
        return
    radius, tall = rng.uniform(1.9, 2.5), rng.uniform(7, 9)
    kit.add(BOX, (-0.4, 0, 1.5), (3.2, 4.2, 1.5), material=walls)
    roof(kit, (-0.4, 0, 3), (3.2, 4.2), 1.7, "hip", 0.4, cover, frame, 1)
    lights(kit, (-0.4, 0, 1.6), (3.2, 4.2), [-2.8, 2.8], (0.5, 0.55), glass, frame, 0)
    lights(kit, (-0.4, 0, 1.6), (3.2, 4.2), row(2, 3.2), (0.45, 0.55), glass, frame, 1, False)
    door(kit, (2.8, 0, 0), (0.6, 1.15), leaf(kit), frame)
    kit.add(
        PRISM,
        (0, 0, tall / 2),
        (radius * 1.25, radius * 1.25, tall / 2),
        (0.6, 8),
        material=tinted(kit, (THATCH, WHITE, TIMBER, BRICK, GREEN), (SHINGLES, BRICKS, PLAIN), frequency=20),
    )
    deck = rng.uniform(4.2, 4.8)
    kit.add(PRISM, (0, 0, deck), (radius * 1.75, radius * 1.75, 0.1), (1, 8), material=wood)
    kit.add(TUBE, (0, 0, deck + 0.5), (radius * 1.7, radius * 1.7, 0.45), material=wood, cut=(BARS, 20, 0.3))
    kit.add(BALL, (0, 0, tall), (radius * 0.95, radius * 0.82, radius * 0.75), material=cover)
    hub, long, first = np.array([radius * 1.15, 0, tall + 0.2]), min(tall - deck, radius * 2.2) + rng.uniform(0.3, 0.9), rng.uniform(0, 90)
    kit.between((0, 0, tall + 0.15), hub + [0.3, 0, 0], 0.24, material=wood)
    for k in range(4):
        spin = turn("x", first + 90 * k)
        kit.add(BOX, hub + spin @ [0.1, 0, long / 2], (0.08, 0.1, long / 2), rotation=spin, material=wood)
        kit.add(BOX, hub + spin @ [0.1, 0.42, long * 0.6], (0.03, 0.42, long * 0.4), rotation=spin, material=wood, cut=(LATTICE, 3, 0.35))
    kit.between((-radius * 0.8, 0, tall), (-radius * 2.0, 0, deck + 0.1), 0.09, BOX, material=wood)
    lights(kit, (0, 0, tall * 0.72), (radius * 0.84, radius * 0.84), [0], (0.28, 0.36), glass, frame, 0, False)
    lights(kit, (0, 0, tall * 0.72), (radius * 0.84, radius * 0.84), [0], (0.28, 0.36), glass, frame, 1, False)


def barn_conversion(kit):
    rng = kit.rng
    walls, cover, frame, glass = (boards, boards, masonry)[rng.integers(3)](kit), tiles(kit), tinted(kit, (TIMBER, WHITE, GREY)), panes(kit)
    x, y, high = rng.uniform(5, 7), rng.uniform(3, 4), rng.uniform(3, 4.2)
    kind = rng.choice(["gambrel", "gable", "halfhip"])
    rise = y * rng.uniform(0.85, 1.15)
    kit.add(BOX, (0, 0, 0.3), (x + 0.06, y + 0.06, 0.3), material=masonry(kit))
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    roof(kit, (0, 0, high), (x, y), rise, kind, 0.35, cover, walls, 0)
    wide = rng.uniform(1.2, 1.7)
    kit.add(BOX, (0, 0, high * 0.48), (wide + 0.14, y + 0.05, high * 0.48), material=frame)
    kit.add(BOX, (0, 0, high * 0.48), (wide, y + 0.08, high * 0.45), material=glass)
    for place in (-0.5, 0, 0.5):
        kit.add(BOX, (place * wide, 0, high * 0.48), (0.06, y + 0.11, high * 0.46), material=frame)
    for side in (-1, 1):
        kit.add(BOX, (side * (wide * 1.55 + 0.2), y, high * 0.46), (wide * 0.5, 0.12, high * 0.45), material=leaf(kit), mirror=True)
    kit.add(BOX, (x, 0, high * 0.55), (0.05, y * 0.55, high * 0.45), material=frame)
    kit.add(BOX, (x, 0, high * 0.55), (0.08, y * 0.5, high * 0.41), material=glass)
    kit.add(BOX, (x, 0, high * 0.55), (0.1, 0.07, high * 0.41), material=frame)
    lights(kit, (0, 0, high + rise * 0.35), (x, y), [0], (0.6, 0.5), glass, frame, 0)
    lights(kit, (0, 0, high * 0.55), (x, y), [-x * 0.75, x * 0.75], (0.45, 0.55), glass, frame, 1)
    kit.add(CYL, (x * 0.5, y * 0.35, high + rise * 0.9), (0.16, 0.16, rise * 0.5), material=tinted(kit, (GREY, TIMBER)))
    if kit.chance(0.5):
        kit.add(CYL, (-x - 1.5, 0, (high + rise) * 0.55), (1.4, 1.4, (high + rise) * 0.55), material=tinted(kit, (GREY, BRICK, WOOD), (BANDS, BRICKS), frequency=16))
        kit.add(BALL, (-x - 1.5, 0, (high + rise) * 1.1), (1.42, 1.42, 0.9), material=cover)
    else:
        kit.add(BOX, (-x * 0.3, 0, high + rise + 0.3), (0.5, 0.5, 0.7), material=walls)
        spire(kit, -x * 0.3, 0, high + rise + 0.95, 0.75, 0.8, cover)


def car_park(kit):
    rng = kit.rng
    slab, dark = tinted(kit, (CONCRETE, WHITE, GREY), (PLAIN, CLOUDY, STREAKS)), kit.material(dark=True)
    rail = slab if kit.chance(0.5) else tinted(kit, (GREY, WOOD, GREEN, YELLOW), (RIBS, PLAIN), frequency=10)
    storeys, x, y = int(rng.integers(3, 6)), rng.uniform(5, 6.5), rng.uniform(7, 9)
    tower = rng.choice([-1, 1])
    for k in range(storeys + 1):
        z = 2.6 * k + 0.15
        kit.add(BOX, (0, 0, z), (x, y, 0.15), material=slab)
        if k:
            kit.add(BOX, (x, 0, z + 0.4), (0.09, y, 0.5), material=rail)
            kit.add(BOX, (-x, 0, z + 0.4), (0.09, y, 0.5), material=rail)
            kit.add(BOX, (0, y, z + 0.4), (x, 0.09, 0.5), material=rail, mirror=True)
    for px in (-0.95, 0, 0.95):
        for py in (-0.95, -0.33, 0.33, 0.95):
            kit.add(BOX, (px * x, py * y, 1.3 * storeys), (0.2, 0.2, 1.3 * storeys), material=slab)
    tall = 2.6 * storeys + 2.8
    kit.add(BOX, (x * 0.6, tower * (y + 1.2), tall / 2), (1.6, 1.3, tall / 2), material=walls_of(kit))
    kit.add(BOX, (x * 0.6 + 1.6, tower * (y + 1.2), tall / 2), (0.05, 0.7, tall / 2 - 0.4), material=panes(kit))
    kit.add(
        BOX, (x * 0.6 + 1.66, tower * (y + 1.2), tall - 1.2), (0.06, 0.6, 0.6), material=tinted(kit, ((0.03, 0.1, 0.5),), (WRITING,), frequency=8, second=(0.9, 0.9, 0.9))
    )
    kit.between((-x * 0.6, -y, 0.3), (-x * 0.6, y * 0.6, 2.7), (0.1, 1.4), BOX, material=slab)
    for k in range(int(rng.integers(3, 7))):
        z = 0.3 + 2.6 * int(rng.integers(storeys + 1))
        at = (rng.choice([-0.66, 0.66]) * x, rng.uniform(-0.8, 0.8) * y)
        paint = kit.material(gloss=0.5, pattern=PLAIN)
        kit.add(BOX, (*at, z + 0.45), (1.3, 0.6, 0.32), material=paint)
        kit.add(BOX, (at[0] - 0.1, at[1], z + 0.92), (0.75, 0.52, 0.2), (0.7, 0.85), material=dark)


def construction(kit):
    """A frame of floors and columns with walls in part, a tower crane beside it."""
    rng = kit.rng
    slab, brick = tinted(kit, (CONCRETE, GREY), (PLAIN, CLOUDY)), walls_of(kit)
    storeys, x, y = int(rng.integers(3, 6)), rng.uniform(3, 4), rng.uniform(3.5, 5)
    for k in range(storeys + 1):
        kit.add(BOX, (0, 0, 2.6 * k + 0.12), (x, y, 0.14), material=slab)
    for px in (-0.9, 0.9):
        for py in (-0.9, 0, 0.9):
            kit.add(BOX, (px * x, py * y, 1.3 * storeys + 0.5), (0.18, 0.18, 1.3 * storeys + 0.5), material=slab)
            if kit.chance(0.6):
                kit.add(BOX, (px * x, py * y, 2.6 * storeys + 1.4), (0.12, 0.12, 0.5), material=tinted(kit, ((0.2, 0.08, 0.04),)), cut=(BARS, 20, 0.4))
    kit.add(BOX, (0, -y * 0.2, 1.3 * storeys + 0.6), (x * 0.3, y * 0.25, 1.3 * storeys + 0.8), material=slab)
    for k in range(int(rng.integers(1, storeys))):
        for sx in (-1, 1):
            kit.add(BOX, (sx * (x - 0.1), 0, 2.6 * k + 1.3), (0.1, y, 1.3), material=brick)
            for place in (-0.5, 0.5):
                kit.add(BOX, (sx * (x - 0.1), place * y, 2.6 * k + 1.5), (0.13, y * 0.25, 0.65), material=kit.material(dark=True))
    side = rng.choice([-1, 1])
    if kit.chance(0.6):
        kit.add(BOX, (0, -side * (y + 0.6), 1.3 * storeys), (x, 0.4, 1.3 * storeys), material=tinted(kit, (GREY, YELLOW, GREEN)), cut=(LATTICE, 1.3, 0.16))
    paint = tinted(kit, ((0.65, 0.4, 0.02), RED, (0.6, 0.2, 0.02), WHITE))
    at, tall = np.array([0, side * (y + 1.6), 0]), 2.6 * storeys + rng.uniform(4, 7)
    long = rng.uniform(7, 10)
    arm = turn("z", rng.uniform(0, 360)) @ np.array([1.0, 0, 0])
    kit.add(BOX, at + [0, 0, 0.3], (1.2, 1.2, 0.3), material=slab)
    kit.add(BOX, at + [0, 0, tall / 2], (0.45, 0.45, tall / 2), material=paint, cut=(LATTICE, 1.6, 0.3))
    top = at + [0, 0, tall]
    kit.add(BOX, top, (0.6, 0.6, 0.35), material=paint)
    kit.between(top - arm * long * 0.35, top + arm * long, (0.35, 0.35), BOX, material=paint, cut=(LATTICE, 1.8, 0.3))
    kit.between(top, top + [0, 0, 2.4], 0.3, BOX, 0.4, material=paint)
    for end in (-0.33, 0.75):
        kit.between(top + [0, 0, 2.3], top + arm * long * end + [0, 0, 0.3], 0.05, material=paint)
    kit.add(BOX, top - arm * long * 0.3 - [0, 0, 0.5], (0.6, 0.6, 0.7), material=slab)
    kit.add(BOX, top + arm * 0.9 - [0, 0, 0.6], (0.4, 0.4, 0.6), material=panes(kit))
    hook = top + arm * long * rng.uniform(0.5, 0.9)
    kit.between(hook, hook - [0, 0, rng.uniform(2, 4)], 0.05, material=kit.material(dark=True))


def destroyed(kit):
    """A block of flats of which a corner has fallen: open floors, bent slabs, rubble."""
    rng = kit.rng
    wall, dark, slab = (
        tinted(kit, (CONCRETE, CREAM, GREY, BRICK), (STREAKS, CLOUDY), frequency=6),
        kit.material(dark=True),
        tinted(kit, (CONCRETE, GREY), (CLOUDY, SPECKLES)),
    )
    storeys, x, y = int(rng.integers(3, 6)), rng.uniform(3.2, 4), rng.uniform(6, 8)
    cut, side = rng.uniform(0.3, 0.5), rng.choice([-1, 1])
    long = y * (1 - cut)
    at, high = -side * y * cut, 2.8 * storeys
    gridded(kit, (0, at, 0), (x, long, high / 2), storeys, (2, 4), wall, dark, 0.4, 0.45)
    edge = at + side * long
    for k in range(storeys):
        out = rng.uniform(0.2, 1.0) * y * cut * (1 - 0.55 * k / storeys)
        kit.add(
            BOX,
            (-x * rng.uniform(0, 0.3), edge + side * out, 2.8 * k + 0.1),
            (x * rng.uniform(0.6, 0.7), out + 0.2, 0.13),
            rotation=turn("z", rng.uniform(-3, 3)),
            material=slab,
        )
        if k < storeys - 1:
            kit.add(BOX, (-x + 0.15, edge + side * out * 0.8, 2.8 * k + 1.4), (0.14, out * 0.8, 1.4), material=wall)
    tilt = rng.uniform(30, 50)
    reach = 2.8 / np.sin(np.radians(tilt)) / 2
    kit.add(BOX, (x * 0.3, edge + side * np.cos(np.radians(tilt)) * reach, 1.4), (x * 0.5, reach, 0.13), rotation=turn("x", -side * tilt), material=slab)
    kit.add(BALL, (x * 0.2, edge + side * y * cut, 0), (x * 1.1, y * cut * 1.2, 1.2), material=slab._replace(pattern=SPECKLES, frequency=18.0))
    for _ in range(10):
        size = rng.uniform(0.25, 0.7)
        spin = turn("z", rng.uniform(0, 90)) @ turn("x", rng.uniform(-35, 35))
        place = (rng.uniform(-0.9, 1.2) * x, edge + side * y * cut * rng.uniform(0.3, 2.0), size * 0.4 + 0.15)
        kit.add(BOX, place, (size * 1.5, size, size * 0.35), rotation=spin, material=wall if kit.chance(0.5) else slab)
    kit.add(BOX, (0, at - side * 0.3, high + 0.1), (x * 0.98, long * 0.85, 0.3), material=slab)
    trestle(kit, corners(x * 0.9, 0.3, high - 0.1, 0, edge), corners(x * 0.9, 0.3, high + 1.1, 0, edge + side * 0.3), 0.04, dark)
