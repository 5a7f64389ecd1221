"""A maker of public buildings whose windows are true openings; it draws those of town and state, palaces, houses, flats, hotels, shops."""

import numpy as np

from .building_parts import block, flight, greens, lettered, paving, pierced, posts, slab, striped, vivid
from .dwellings import (
    BLUE,
    BRICK,
    CONCRETE,
    COPPER,
    CREAM,
    GOLD,
    GREEN,
    GREY,
    OCHRE,
    RED,
    SAND,
    SLATE,
    STONE,
    THATCH,
    TIMBER,
    WHITE,
    WOOD,
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
from .factories import brewery, factory, power_station, warehouse, watermill, windmill
from .installations import steelwork, tinted
from .kit import ALONG_X, ALONG_Y, turn
from .landmarks import dome
from .layout import BALL, BARS, BOX, CYL, PRISM
from .materials import BANDS, BRICKS, CLOUDY, DOTS, PLAIN, PLANKS, RIBS, SEAMS, SPECKLES, STREAKS, STRIPES, WRITING
from .temples import clapboard, gothic, hindu_temple, modern_church, mosque, orthodox, pagoda, romanesque, shrine, stave, stupa, synagogue
from .worship import arched, clock, onion, spire


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
    kinds = [
        town_hall,
        school,
        romanesque,
        gothic,
        stave,
        orthodox,
        clapboard,
        modern_church,
        mosque,
        synagogue,
        hindu_temple,
        stupa,
        pagoda,
        shrine,
        palace,
        villa,
        farmstead,
    ]
    kinds += [
        terrace,
        tower_block,
        skyscraper,
        hotel,
        factory,
        warehouse,
        fire_station,
        police_post,
        embassy,
        hospital,
        station,
        museum,
        theatre,
        barracks,
        watermill,
        brewery,
    ]
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
    wall, glass, rail = (
        tinted(kit, (WHITE, CONCRETE, CREAM, BRICK, GREY), (PLAIN, STREAKS, CLOUDY)),
        panes(kit),
        vivid(kit) if kit.chance(0.5) else tinted(kit, (GREY, WHITE, CONCRETE)),
    )
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
