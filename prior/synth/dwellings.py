"""A maker of dwellings of many regions with windows on all sides, and what it shares with that of town buildings: walls, roofs, doors, windows."""

import numpy as np

from .installations import railed, stairs, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, LEAVES, PRISM, RUNGS
from .materials import BANDS, BRICKS, CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, SHINGLES, SPECKLES, STREAKS, STRIPES, WAVES

# Linear colours.
WHITE, CREAM, GREY, CONCRETE = (0.75, 0.74, 0.7), (0.68, 0.58, 0.4), (0.33, 0.33, 0.33), (0.42, 0.4, 0.36)
BRICK, CLAY, OCHRE, PINK = (0.3, 0.1, 0.06), (0.45, 0.24, 0.13), (0.55, 0.33, 0.1), (0.6, 0.33, 0.26)
RED, YELLOW, GREEN, BLUE = (0.35, 0.03, 0.02), (0.65, 0.42, 0.1), (0.1, 0.2, 0.1), (0.12, 0.22, 0.35)
STONE, SAND, WOOD, TIMBER = (0.5, 0.43, 0.32), (0.55, 0.42, 0.26), (0.25, 0.14, 0.07), (0.07, 0.04, 0.025)
TILE, SLATE, MOSS, THATCH = (0.36, 0.11, 0.05), (0.08, 0.09, 0.11), (0.12, 0.13, 0.07), (0.33, 0.23, 0.11)
COPPER, GOLD, SNOW, LEAF = (0.2, 0.45, 0.35), (0.7, 0.45, 0.08), (0.85, 0.88, 0.92), (0.06, 0.14, 0.03)


def render(kit):
    return tinted(kit, (WHITE, CREAM, WHITE, OCHRE, PINK, GREY, BLUE, YELLOW), (PLAIN, PLAIN, CLOUDY, STREAKS), gloss=0.02)


def brickwork(kit):
    return tinted(kit, (BRICK, BRICK, CLAY, CREAM), (BRICKS,), frequency=kit.rng.uniform(18, 34), second=(0.45, 0.4, 0.34), gloss=0.02)


def masonry(kit):
    return tinted(kit, (STONE, GREY, SAND, CONCRETE), (BRICKS, CLOUDY, SEAMS), frequency=kit.rng.uniform(9, 20), gloss=0.02)


def boards(kit):
    return tinted(kit, (WHITE, WOOD, RED, GREY, BLUE, GREEN, YELLOW, CREAM), (PLANKS, PLANKS, BANDS), frequency=kit.rng.uniform(16, 30), gloss=0.03)


def walls_of(kit):
    return (render, render, brickwork, masonry, boards)[kit.rng.integers(5)](kit)


def tiles(kit):
    if kit.chance(0.15):
        return tinted(kit, (GREY, RED, GREEN, BLUE, COPPER), (RIBS, STRIPES), frequency=kit.rng.uniform(6, 14), gloss=0.15)
    return tinted(kit, (TILE, TILE, SLATE, SLATE, GREY, MOSS, CLAY), (SHINGLES, SHINGLES, PLAIN, BANDS), frequency=kit.rng.uniform(14, 28), gloss=0.03)


def trim(kit):
    return tinted(kit, (WHITE, WHITE, WHITE, WOOD, GREY, TIMBER, GREEN))


def panes(kit):
    return kit.material(base=np.array([0.07, 0.1, 0.13]) * kit.rng.uniform(0.3, 2.2), pattern=kit.rng.choice([PLAIN, PLAIN, CLOUDY]), gloss=kit.rng.uniform(0.2, 0.6))


def leaf(kit):
    return tinted(kit, (WOOD, RED, GREEN, BLUE, TIMBER, WHITE), (PLAIN, STRIPES), frequency=20)


def lights(kit, at, half, places, size, glass, frame, facing=1, sash=True):
    """Framed windows in two opposite walls: `at` the walls' middle at the windows' height, `half` (x, y) of the walls."""
    deep, move = half[facing], np.eye(3)[1 - facing]
    layers = [(size[0] + 0.1, 0.04, size[1] + 0.1, frame), (size[0], 0.07, size[1], glass)]
    if sash:
        layers.append((0.04, 0.09, size[1], frame))
    for place in places:
        for wide, out, high, material in layers:
            reach = (wide, deep + out, high) if facing else (deep + out, wide, high)
            kit.add(BOX, np.array(at, float) + move * place, reach, material=material)


def row(count, half, share=0.8):
    """`count` places along a wall of half length `half`."""
    return [half * share * ((2 * i + 1) / count - 1) for i in range(count)]


def door(kit, at, size, material, frame, axis=0):
    """A door in its frame, at the wall's foot; `axis` is the wall's normal."""
    wide, high = size
    for grow, out, skin in ((0.1, 0.06, frame), (0, 0.09, material)):
        reach = (out, wide + grow, high + grow / 2) if axis == 0 else (wide + grow, out, high + grow / 2)
        kit.add(BOX, (at[0], at[1], at[2] + high + grow / 2), reach, material=skin)


def leaves(kit, base, spin, long, low, high, thick, material):
    """Two roof slabs, mirrored over the ridge along local x, from `low` to `high` (away from the ridge, up)."""
    (y0, z0), (y1, z1) = low, high
    slope = np.degrees(np.arctan2(z1 - z0, y0 - y1))
    for side in (-1, 1):
        centre = np.array(base, float) + spin @ [0, side * (y0 + y1) / 2, (z0 + z1) / 2 + thick]
        kit.add(BOX, centre, (long, np.hypot(y1 - y0, z1 - z0) / 2 + thick * 0.5, thick), rotation=spin @ turn("x", -side * slope), material=material)


def roof(kit, base, half, rise, kind, over, cover, gable, axis=0):
    """A roof over walls of half sizes `half` (x, y) whose top is at `base` [3]; its ridge runs along x (axis 0) or y."""
    spin = turn("z", 90 * axis)
    base, (x, y) = np.array(base, float), half if axis == 0 else half[::-1]

    def solid(z, size, taper, material):
        kit.add(BOX, base + [0, 0, z], size, taper, rotation=spin, material=material)

    if kind == "gable":
        leaves(kit, base, spin, x + over, (y + over, -over * rise / y), (0, rise), 0.09, cover)
        solid(rise / 2, (x, y, rise / 2), (1, 0.02), gable)
    elif kind == "gambrel":
        leaves(kit, base, spin, x + over, (y + over * 0.5, -over * 0.6), (y * 0.62, rise * 0.62), 0.08, cover)
        leaves(kit, base, spin, x + over, (y * 0.66, rise * 0.6), (0, rise), 0.08, cover)
        solid(rise * 0.31, (x, y, rise * 0.31), (1, 0.62), gable)
        solid(rise * 0.81, (x, y * 0.62, rise * 0.19), (1, 0.02), gable)
    elif kind == "halfhip":
        leaves(kit, base, spin, x + over, (y + over, -over * rise / y), (y * 0.45, rise * 0.55), 0.1, cover)
        solid(rise * 0.275, (x, y, rise * 0.275), (1, 0.45), gable)
        solid(rise * 0.55 + rise * 0.25, (x + over, y * 0.45 + 0.14, rise * 0.25), (max(1 - 0.4 * y / x, 0.3), 0.03), cover)
    elif kind in ("hip", "pyramid"):
        solid(0.04, (x + over * 0.9, y + over * 0.9, 0.09), (1, 1), gable)
        solid(0.1 + rise / 2, (x + over, y + over, rise / 2), (max((x - y) / (x + over), 0.02) if kind == "hip" else 0.02, 0.02), cover)
    elif kind == "mansard":
        solid(0.06, (x + over, y + over, 0.1), (1, 1), gable)
        solid(rise * 0.37, (x + over * 0.5, y + over * 0.5, rise * 0.37), (1 - 0.2 * y / x, 0.8), cover)
        solid(rise * 0.85, (x * (1 - 0.17 * y / x) + over * 0.3, y * 0.83 + over * 0.3, rise * 0.12), (max(1 - 0.6 * y / x, 0.2), 0.35), cover)
    elif kind == "flat":
        solid(0.1, (x + over, y + over, 0.13), (1, 1), gable)
    else:  # one slope
        slope = np.arctan2(rise, 2 * y)
        kit.add(BOX, base + [0, 0, rise / 2], (x, y, rise / 2), (1, 0.02), (0, y * 0.98), rotation=spin, material=gable)
        kit.add(BOX, base + [0, 0, rise / 2 + 0.12], (x + over, (y + over) / np.cos(slope), 0.09), rotation=spin @ turn("x", np.degrees(slope)), material=cover)


def chimney(kit, x, y, low, high, material=None):
    material = material or brickwork(kit)
    wide = kit.rng.uniform(0.25, 0.4)
    kit.add(BOX, (x, y, (low + high) / 2), (wide, wide * 1.3, (high - low) / 2), material=material)
    kit.add(BOX, (x, y, high), (wide * 1.25, wide * 1.5, 0.07), material=tinted(kit, (GREY, CONCRETE)))
    kit.add(CYL, (x, y, high + 0.2), (0.13, 0.13, 0.2), material=tinted(kit, (TILE, GREY)))


def dormer(kit, x, half_y, base, rise, side, walls, cover, glass, frame, share=0.35):
    """A small gabled house on the slope of a roof whose ridge runs along x."""
    away = half_y * (1 - share)
    top = base + rise * share + 1.15
    kit.add(BOX, (x, side * away * 0.6, top - 0.75), (0.62, away * 0.4, 0.75), material=walls)
    kit.add(BOX, (x, side * away * 0.58, top + 0.24), (0.85, away * 0.48, 0.26), (0.03, 1), material=cover)
    kit.add(BOX, (x, side * away, top - 0.5), (0.47, 0.04, 0.45), material=frame)
    kit.add(BOX, (x, side * away, top - 0.5), (0.38, 0.07, 0.36), material=glass)


def veranda(kit, x, long, deep, eave, frame, cover, posts, rail=True):
    """A porch before the wall at `x`: floor, posts, lean-to roof."""
    kit.add(BOX, (x + deep / 2, 0, 0.15), (deep / 2, long, 0.15), material=frame)
    kit.add(BOX, (x + deep / 2 + 0.05, 0, eave + 0.2), (deep / 2 + 0.2, long + 0.2, 0.07), rotation=turn("y", 9), material=cover)
    for y in np.linspace(-long + 0.1, long - 0.1, posts):
        kit.add(BOX, (x + deep - 0.12, y, eave / 2 + 0.05), (0.08, 0.08, eave / 2 + 0.05), material=frame)
    kit.add(BOX, (x + deep + 0.2, 0, 0.07), (0.25, 0.6, 0.07), material=frame)
    if rail:
        for side in (-1, 1):
            kit.railing((x + deep - 0.1, side * long, 0.3), (x + deep - 0.1, side * 0.7, 0.3), 0.8, frame, 0.2, thick=0.03)


def dwelling(kit):
    """Detached houses of many plans and roofs, villas, adobe and Mediterranean houses, log cabins, thatched and half-timbered cottages, A-frames, stilt houses,
    mobile homes, terraces, yurts, igloos, tree houses."""
    kinds = [detached, detached, detached, detached, villa, villa, adobe, mediterranean, log_cabin, cottage, cottage, half_timbered, a_frame, stilt_house, mobile_home]
    kinds += [terrace, yurt, igloo, tree_house]
    kinds[kit.rng.integers(len(kinds))](kit)


def detached(kit):
    rng = kit.rng
    walls, cover, frame, glass = walls_of(kit), tiles(kit), trim(kit), panes(kit)
    gable = walls if kit.chance(0.6) else boards(kit)
    storeys = int(rng.choice([1, 1, 2, 2]))
    x, y, high = rng.uniform(3.4, 5.0), rng.uniform(4.4, 6.4), 2.9 * storeys
    kind = rng.choice(["gable", "gable", "gable", "hip", "hip", "halfhip", "mansard", "gambrel", "pyramid", "shed"])
    if kind == "pyramid":
        y = x
    rise = x * {"mansard": rng.uniform(0.55, 0.75), "gambrel": rng.uniform(0.8, 1), "pyramid": rng.uniform(0.5, 0.8), "shed": rng.uniform(0.3, 0.6)}.get(
        kind, rng.uniform(0.5, 1.0)
    )
    over = rng.uniform(0.25, 0.7)
    kit.add(BOX, (0, 0, 0.15), (x + 0.06, y + 0.06, 0.2), material=masonry(kit))
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    roof(kit, (0, 0, high), (x, y), rise, kind, over, cover, gable if kind not in ("hip", "pyramid", "mansard") else frame, 1)
    size = (rng.uniform(0.45, 0.75), rng.uniform(0.55, 0.8))
    wing = rng.choice(["none", "L", "T", "T"]) if kind != "shed" else "none"
    sash = storeys == 1 or kit.chance(0.3)
    for k in range(storeys):
        lights(kit, (0, 0, 1.6 + 2.9 * k), (x, y), row(3, y), size, glass, frame, 0, sash)
        lights(kit, (0, 0, 1.6 + 2.9 * k), (x, y), row(2, x), size, glass, frame, 1, False)
    if kind == "gable":
        lights(kit, (0, 0, high + rise * 0.35), (x, y), [0], (0.4, 0.45), glass, frame, 1, False)
    front = x
    if wing != "none":
        half, out = rng.uniform(1.7, 2.4), rng.uniform(1.2, 2.6)
        at = 0.0 if wing == "T" else (y - half) * rng.choice([-1, 1])
        front = x + out
        kit.add(BOX, (front / 2, at, high / 2), (front / 2, half, high / 2), material=walls)
        slope = min(half * rise / x, rise) if kind in ("gable", "halfhip", "shed") else half * 0.6
        lean = kind if kind in ("hip", "gambrel") else "gable"
        roof(kit, (front / 2, at, high), (front / 2, half), slope, lean, min(over, 0.4), cover, gable if lean != "hip" else frame, 0)
        for k in range(storeys):
            kit.add(BOX, (front, at, 1.6 + 2.9 * k), (0.05, 1.0, 0.85), material=frame)
            kit.add(BOX, (front, at, 1.6 + 2.9 * k), (0.08, 0.9, 0.75), material=glass)
    at_door = 0.0 if wing != "T" else y * 0.75
    door(kit, (x, at_door, 0), (0.5, 1.1), leaf(kit), frame)
    extra = rng.choice(["porch", "hood", "bay", "balcony", "steps"])
    if extra == "porch" and wing == "none":
        veranda(kit, x, y * rng.uniform(0.4, 0.95), rng.uniform(1.4, 2.2), 2.4, frame, cover, int(rng.integers(4, 7)))
    elif extra == "bay":
        kit.add(PRISM, (-x, 0, 1.35), (1.1, 1.4, 1.35), (1, 8), material=walls)
        kit.add(PRISM, (-x, 0, 1.65), (1.13, 1.43, 0.6), (1, 8), material=glass)
        kit.add(PRISM, (-x, 0, 3.0), (1.3, 1.6, 0.4), (0.3, 8), material=cover)
    elif extra == "balcony" and storeys == 2:
        kit.add(BOX, (-x - 0.6, 0, 2.9), (0.65, 2, 0.09), material=frame)
        railed(kit, -x - 0.6, 0, 2.95, 0.6, 1.9, 0.95, frame)
        for side in (-1, 1):
            kit.add(BOX, (-x - 1.1, side * 1.85, 1.45), (0.09, 0.09, 1.45), material=frame)
    else:
        kit.add(BOX, (x + 0.5, at_door, 2.5), (0.55, 0.9, 0.08), material=cover)
        for side in (-1, 1):
            kit.add(BOX, (x + 0.9, at_door + side * 0.75, 1.25), (0.07, 0.07, 1.25), material=frame)
        kit.add(BOX, (x + 0.6, at_door, 0.1), (0.6, 1, 0.1), material=masonry(kit))
    if kit.chance(0.45):
        half, side = rng.uniform(1.6, 2.8), rng.choice([-1, 1])
        at = side * (y + half)
        deep = x * rng.uniform(0.65, 0.95)
        kit.add(BOX, (0, at, 1.3), (deep, half, 1.3), material=walls)
        roof(kit, (0, at, 2.6), (deep, half), half * 0.55, "gable" if kit.chance(0.5) else "flat", 0.25, cover, gable, 0)
        kit.add(BOX, (deep, at, 1.1), (0.07, half * 0.75, 1.1), material=tinted(kit, (WHITE, GREY, WOOD), (BANDS, RIBS), frequency=16))
    if kit.chance(0.65) and kind != "shed":
        chimney(kit, -x * 0.3, rng.choice([-0.55, 0.5]) * (y if kind not in ("hip", "pyramid") else y * 0.4), high, high + rise + 0.7)
    if kind == "gable" and wing == "none" and kit.chance(0.6) and rise > 2.2:
        for side in row(2, y * 0.8):
            first = len(kit.primitives)
            dormer(kit, -side, x, high, rise, 1, walls, cover, glass, frame, 0.3)
            turned(kit, first)
    if kit.chance(0.6):
        kit.between((x + 0.06, y - 0.1, 0), (x + 0.06, y - 0.1, high), 0.06, material=tinted(kit, (GREY, WHITE)), mirror=True)


def turned(kit, first):
    """Turn what was added since `first` by a right angle about the upright axis."""
    spin = turn("z", -90)
    kit.primitives[first:] = [p._replace(centre=spin @ p.centre, rotation=spin @ p.rotation) for p in kit.primitives[first:]]


def villa(kit):
    rng = kit.rng
    white, accent = tinted(kit, (WHITE, WHITE, CREAM, CONCRETE), (PLAIN, CLOUDY)), (boards, masonry, render)[rng.integers(3)](kit)
    glass, frame = panes(kit), tinted(kit, (TIMBER, GREY, WHITE))
    x, y = rng.uniform(3.2, 4.5), rng.uniform(5, 7)
    side = rng.choice([-1, 1])
    kit.add(BOX, (0, 0, 0.12), (x + 2.2, y + 0.8, 0.12), material=tinted(kit, (CONCRETE, GREY, STONE), (SEAMS,), frequency=10))
    kit.add(BOX, (0, 0, 1.6), (x, y, 1.5), material=accent)
    kit.add(BOX, (0.3, 0, 3.1), (x + 0.7, y + 0.3, 0.16), material=white)
    over, long = rng.uniform(1.0, 2.2), y * rng.uniform(0.55, 0.8)
    at = side * (y - long) * rng.uniform(0, 1)
    kit.add(BOX, (over * 0.5, at, 4.6), (x * 0.9 + over * 0.5, long, 1.5), material=white)
    kit.add(BOX, (over * 0.5, at, 6.15), (x * 0.9 + over * 0.5 + 0.25, long + 0.25, 0.13), material=white)
    front = x * 0.9 + over
    for end in (front, over * 0.5 - x * 0.9 - over * 0.5):
        kit.add(BOX, (end, at, 4.6), (0.05, long * 0.85, 1.1), material=frame)
        kit.add(BOX, (end, at, 4.6), (0.08, long * 0.83, 1.02), material=glass)
    for place in row(4, long * 0.83, 0.75):
        kit.add(BOX, (over * 0.5, at + place, 4.6), (x * 0.9 + over * 0.5 + 0.1, 0.05, 1.05), material=frame)
    for place in row(3, y):
        kit.add(BOX, (0, place, 1.5), (x + 0.05, y * 0.22, 1.15), material=frame)
        kit.add(BOX, (0, place, 1.5), (x + 0.08, y * 0.2, 1.07), material=glass)
    for z, where in ((1.6, 0), (4.7, at)):
        lights(kit, (over * 0.5 * (z > 3), where, z), (x, y if z < 3 else long), row(2, x), (0.7, 0.55), glass, frame, 1, False)
    for place in (-1, 1):
        kit.add(CYL if kit.chance(0.5) else BOX, (front - 0.3, at + place * (long - 0.4), 1.6), (0.12, 0.12, 1.6), material=frame)
    door(kit, (x, side * y * 0.93, 0.2), (0.45, 1.15), leaf(kit), frame)
    if kit.chance(0.6):
        kit.railing((front - 0.1, at - side * long, 3.2), (x + 0.9, -side * y, 3.2), 0.9, glass, 1)
    if kit.chance(0.5):
        kit.add(BOX, (-x - 1.6, side * y * 0.4, 1.5), (1.8, y * 0.4, 1.5), material=white)
        kit.add(BOX, (-x - 3.4, side * y * 0.4, 1.2), (0.06, y * 0.32, 1.1), material=tinted(kit, (GREY, WOOD), (BANDS,), frequency=14))
    if kit.chance(0.6):
        kit.add(BOX, (x + 1.8, -side * y * 0.4, 0.26), (1.1, y * 0.45, 0.05), material=kit.material(base=(0.05, 0.4, 0.5), pattern=WAVES, gloss=0.5))
    kit.add(BOX, (-x * 0.3, at, 6.5), (0.5, 0.6, 0.35), material=white)


def adobe(kit):
    rng = kit.rng
    mud = tinted(kit, (CLAY, SAND, OCHRE, CREAM), (CLOUDY, PLAIN, SPECKLES), gloss=0.0)
    wood, glass, frame = tinted(kit, (WOOD, TIMBER)), panes(kit), tinted(kit, (WOOD, BLUE, GREEN, WHITE))
    lean = (0.95, 0.95)
    x, y, low = rng.uniform(3, 4.2), rng.uniform(4, 6), rng.uniform(2.6, 3.2)
    blocks = [(0.0, 0.0, x, y, 0.0, low), (-x * 0.25, y * rng.uniform(-0.35, 0.35), x * 0.72, y * 0.55, low, low * 0.9)]
    if kit.chance(0.5):
        blocks.append((-x * 0.4, blocks[1][1], x * 0.45, y * 0.32, low * 1.9, low * 0.8))
    side = rng.choice([-1, 1])
    blocks.append((-x * 0.2, side * (y + 1.4), x * 0.7, 1.6, 0.0, low * 0.8))
    for k, (cx, cy, bx, by, z, tall) in enumerate(blocks):
        kit.add(BOX, (cx, cy, z + tall / 2), (bx, by, tall / 2), lean, material=mud)
        rim = (bx * 0.96, by * 0.96)
        kit.add(BOX, (cx, cy, z + tall), (rim[0], rim[1], 0.12), material=mud)
        for place in row(5 if k == 0 else 3, by * 0.9):
            kit.add(CYL, (cx, cy + place, z + tall - 0.35), (0.09, 0.09, bx + 0.3), rotation=ALONG_X, material=wood)
        lights(kit, (cx, cy, z + tall * 0.55), (bx, by), row(2, by) if k < 2 else [0], (0.38, 0.45), glass, frame, 0, False)
        lights(kit, (cx, cy, z + tall * 0.55), (bx, by), [0.3], (0.35, 0.4), glass, frame, 1, False)
    door(kit, (x, 0, 0), (0.5, 1.0), leaf(kit), wood)
    kit.between((x * 0.75, -side * (y + 0.25), low + 0.9), (x * 0.2, -side * (y - 0.1), 0), 0.05, material=wood)
    foot, head = np.array([x + 1.2, -side * y * 0.6, 0]), np.array([x * 0.95, -side * y * 0.6, low + 0.9])
    for y_off in (-0.25, 0.25):
        kit.between(foot + [0, y_off, 0], head + [0, y_off, 0], 0.05, material=wood)
    kit.between(foot, head, (0.03, 0.25), BOX, material=wood, cut=(RUNGS, 9, 0.3))
    if kit.chance(0.5):
        kit.add(BALL, (x + 1.3, y * 0.5, 0.0), (0.75, 0.75, 1.0), material=mud)
        kit.add(CYL, (x + 1.9, y * 0.5, 0.3), (0.25, 0.25, 0.25), rotation=ALONG_X, material=kit.material(dark=True))


def mediterranean(kit):
    rng = kit.rng
    white, glass = tinted(kit, (WHITE, WHITE, CREAM, OCHRE, PINK), (PLAIN, CLOUDY)), panes(kit)
    accent = tinted(kit, ((0.05, 0.15, 0.45), GREEN, WOOD, BLUE))
    x, y, low = rng.uniform(3, 4), rng.uniform(3.8, 5.2), 2.9
    side = rng.choice([-1, 1])
    kit.add(BOX, (0, 0, low / 2), (x, y, low / 2), material=white)
    up, at = y * rng.uniform(0.5, 0.7), -side * y * 0.3
    kit.add(BOX, (-x * 0.15, at, low * 1.5), (x * 0.85, up, low / 2), material=white)
    tiled = kit.chance(0.5)
    top = kit.rng.choice(["hip", "gable"]) if tiled else "flat"
    cover = tinted(kit, (TILE, CLAY), (SHINGLES,), frequency=22)
    roof(kit, (-x * 0.15, at, 2 * low), (x * 0.85, up), x * 0.35, top, 0.4 if tiled else 0.06, cover, white, int(up > x * 0.85))
    if not tiled and kit.chance(0.6):
        kit.add(BALL, (-x * 0.15, at, 2 * low + 0.2), (x * 0.6, x * 0.6, x * 0.6), material=accent if kit.chance(0.6) else white)
    for cx, cy, hx, hy in ((x, 0, 0.1, y), (-x, 0, 0.1, y), (0, side * y, x, 0.1)):
        kit.add(BOX, (cx - np.sign(cx) * 0.1, cy - np.sign(cy) * 0.1, low + 0.3), (hx, hy, 0.4), material=white)
    for z, cx, cy, hx, hy in ((1.5, 0, 0, x, y), (low + 1.5, -x * 0.15, at, x * 0.85, up)):
        lights(kit, (cx, cy, z), (hx, hy), row(2, hy), (0.4, 0.6), glass, white, 0)
        for place in row(2, hy):
            for s in (-0.62, 0.62):
                kit.add(BOX, (cx, cy + place + s, z), (hx + 0.08, 0.2, 0.65), material=accent)
        lights(kit, (cx, cy, z), (hx, hy), row(1, hx), (0.4, 0.6), glass, accent, 1)
    steps = 6
    for k in range(steps):
        tall = low * (k + 1) / steps
        kit.add(BOX, (-x * 0.8 + k * 0.65, side * (y + 0.55), tall / 2), (0.34, 0.6, tall / 2), material=white)
    kit.add(BOX, (-x * 0.8 + steps * 0.65, side * (y + 0.55), low / 2), (0.4, 0.6, low / 2), material=white)
    door(kit, (x, 0, 0), (0.5, 1.05), accent, white)
    if kit.chance(0.6):
        for k in (-1, 1):
            kit.add(BOX, (x + 1.8, k * y * 0.6 - 0.2, 1.2), (0.12, 0.12, 1.2), material=white)
        kit.add(BOX, (x + 0.95, -0.2, 2.42), (1.1, y * 0.7, 0.05), material=tinted(kit, (WOOD,)), cut=(BARS, 9, 0.35))
    chimney(kit, -x * 0.6, at + up * 0.5, 2 * low, 2 * low + 1.4, white)


def log_cabin(kit):
    rng = kit.rng
    wood = tinted(kit, (WOOD, (0.35, 0.2, 0.09), TIMBER, (0.3, 0.22, 0.14)), (PLAIN, CLOUDY), gloss=0.02)
    glass, frame, cover = panes(kit), trim(kit), tiles(kit)
    x, y, courses = rng.uniform(2.2, 3), rng.uniform(2.8, 3.8), int(rng.integers(7, 9))
    thick = 2.7 / courses / 2
    high = 2 * thick * courses
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=wood)
    for k in range(courses):
        z = thick * (2 * k + 1)
        kit.add(CYL, (x, 0, z), (thick, thick, y + 0.3), rotation=ALONG_Y, material=wood)
        kit.add(CYL, (-x, 0, z), (thick, thick, y + 0.3), rotation=ALONG_Y, material=wood)
        kit.add(CYL, (0, y, z), (thick, thick, x + 0.3), rotation=ALONG_X, material=wood, mirror=True)
    rise = x * rng.uniform(0.6, 0.9)
    if kit.chance(0.5):
        roof(kit, (0, 0, high), (x + thick, y + thick), rise, "gable", 0.5, cover, wood, 1)
    else:
        roof(kit, (0, 0, high), (x + thick, y + thick), y * 0.6, "gable", 0.5, cover, wood, 0)
    half = (x + thick, y + thick)
    lights(kit, (0, 0, 1.5), half, [y * 0.6], (0.45, 0.45), glass, frame, 0)
    lights(kit, (0, 0, 1.5), half, [0], (0.45, 0.45), glass, frame, 1)
    door(kit, (x + thick, -y * 0.2, 0), (0.45, 1.0), leaf(kit), frame)
    if kit.chance(0.6):
        veranda(kit, x + thick, y * 0.9, 1.5, 2.15, wood, cover, 4, False)
    stack = masonry(kit)
    kit.add(BOX, (0.2, -y - 0.45, high / 2 + 0.2), (0.55, 0.4, high / 2 + 0.2), (0.65, 1), material=stack)
    kit.add(BOX, (0.2, -y - 0.45, high + 1.2), (0.33, 0.33, 1.7), material=stack)


def cottage(kit):
    """Thatched: low white or stone walls under a thick soft roof."""
    rng = kit.rng
    walls = tinted(kit, (WHITE, WHITE, CREAM, PINK, STONE), (PLAIN, CLOUDY, BRICKS), frequency=14)
    straw = tinted(kit, (THATCH, (0.2, 0.15, 0.09), (0.45, 0.33, 0.16)), (STREAKS, CLOUDY, SHINGLES), frequency=rng.uniform(18, 30), gloss=0.0)
    glass, frame = panes(kit), trim(kit)
    if kit.chance(0.3):  # round hut of Africa or the Iron Age
        radius, high = rng.uniform(2, 3), rng.uniform(1.6, 2.4)
        mud = tinted(kit, (CLAY, SAND, WHITE, OCHRE), (CLOUDY, PLAIN, BANDS), frequency=8)
        kit.add(CYL, (0, 0, high / 2), (radius, radius, high / 2), material=mud)
        rise = radius * rng.uniform(0.9, 1.5)
        kit.loft((0, 0, high - 0.35), [(0, radius * 1.32), (rise * 0.55, radius * 0.72), (rise, 0.2), (rise + 0.3, 0.1)], straw)
        kit.add(BOX, (radius - 0.05, 0, high * 0.38), (0.15, 0.5, high * 0.38), material=kit.material(dark=True))
        lights(kit, (0, 0, high * 0.55), (radius - 0.06, radius - 0.06), [0], (0.25, 0.25), glass, leaf(kit), 1, False)
        for px, py in around(9, radius * 1.18, 20):
            kit.between((px, py, 0), (px, py, high), 0.06, material=tinted(kit, (WOOD,)))
        return
    x, y, high = rng.uniform(2.4, 3.2), rng.uniform(4, 6.5), rng.uniform(2.3, 3.2)
    kit.add(BOX, (0, 0, high / 2), (x, y, high / 2), material=walls)
    rise = x * rng.uniform(0.95, 1.35)
    for z, wide, deep, tall, taper in ((high - 0.2, 0.55, 0.5, 0.35, (1.02, 1.0)), (high + 0.14, 0.55, 0.5, rise, (0.06, 1 - x / y * rng.uniform(0.15, 0.75)))):
        kit.add(BOX, (0, 0, z + tall / 2), (x + wide, y + deep, tall / 2), taper, material=straw)
    kit.add(CYL, (0, 0, high + rise + 0.08), (0.2, 0.25, y * 0.5), rotation=ALONG_Y, material=tinted(kit, (THATCH, TIMBER)))
    lights(kit, (0, 0, high * 0.52), (x, y), row(4, y), (0.42, 0.45), glass, frame, 0)
    lights(kit, (0, 0, high * 0.52), (x, y), [0], (0.4, 0.4), glass, frame, 1)
    for side in (-1, 1):
        for place in row(2, y * 0.85):
            kit.add(BALL, (side * x * 0.75, place, high + 0.55), (0.95, 0.95, 0.75), material=straw)
            kit.add(BOX, (side * (x * 0.75 + 0.72), place, high + 0.4), (0.22, 0.45, 0.3), material=frame)
            kit.add(BOX, (side * (x * 0.75 + 0.75), place, high + 0.4), (0.22, 0.38, 0.24), material=glass)
    door(kit, (x, 0, 0), (0.45, 0.95), leaf(kit), frame)
    for end in [-1, 1][: int(rng.integers(1, 3))]:
        chimney(kit, 0, end * y * 0.75, high, high + rise + 0.9)


def half_timbered(kit):
    rng = kit.rng
    plaster, beam = tinted(kit, (WHITE, CREAM, WHITE, OCHRE, PINK), (PLAIN, CLOUDY)), tinted(kit, (TIMBER, WOOD, RED), (PLAIN, PLANKS), frequency=20)
    glass, cover, base = panes(kit), tinted(kit, (TILE, SLATE, MOSS), (SHINGLES,), frequency=22), masonry(kit)
    x, y, low = rng.uniform(3.5, 5), rng.uniform(2.8, 3.8), 2.8
    storeys, jut, z = int(rng.choice([2, 2, 3])), rng.uniform(0.0, 0.3), 0.0
    bays = 3
    for k in range(storeys):
        hx, hy = x + jut * k, y + jut * k
        kit.add(BOX, (0, 0, z + low / 2), (hx, hy, low / 2), material=base if k == 0 and kit.chance(0.4) else plaster)
        for up in (0.12, low - 0.12):
            kit.add(BOX, (0, 0, z + up), (hx + 0.07, hy + 0.07, 0.12), material=beam)
        for place in np.linspace(-1, 1, bays + 1):
            kit.add(BOX, (0, place * (hy - 0.07), z + low / 2), (hx + 0.06, 0.12, low / 2), material=beam)
        if storeys == 2:
            for place in (-0.33, 0.33):
                kit.add(BOX, (place * hx, 0, z + low / 2), (0.12, hy + 0.06, low / 2), material=beam)
        for side in (-1, 1):
            kit.between((0, side * hy, z + 0.2), (0, side * hy * 0.36, z + low - 0.2), (0.1, hx + 0.05), BOX, material=beam)
        lights(kit, (0, 0, z + 1.55), (hx, hy), row(2 if storeys == 3 else 3, hx), (0.4, 0.5), glass, beam, 1, storeys == 2)
        lights(kit, (0, 0, z + 1.55), (hx, hy), [0], (0.5, 0.5), glass, beam, 0, True)
        z += low
    hx, hy = x + jut * (storeys - 1), y + jut * (storeys - 1)
    rise = hy * rng.uniform(1.0, 1.4)
    roof(kit, (0, 0, z), (hx, hy), rise, "halfhip" if kit.chance(0.35) else "gable", 0.45, cover, plaster, 0)
    kit.add(BOX, (0, 0, z + rise * 0.3), (hx + 0.06, hy * 0.7, 0.11), material=beam)
    kit.add(BOX, (0, 0, z + rise * 0.3), (hx + 0.06, 0.11, rise * 0.3), material=beam)
    door(kit, (x, y * 0.65, 0), (0.5, 1.05), leaf(kit), beam)
    chimney(kit, hx * rng.uniform(-0.6, 0.6), 0.5, z, z + rise + 0.9)


def a_frame(kit):
    rng = kit.rng
    wood, cover, glass, frame = boards(kit), tiles(kit), panes(kit), tinted(kit, (WOOD, TIMBER, WHITE, RED))
    half, high, long = rng.uniform(2.6, 3.4), rng.uniform(5.2, 7), rng.uniform(3.2, 4.8)
    lift = rng.uniform(0.2, 0.8)
    kit.add(BOX, (0, 0, lift + high / 2 - 0.1), (long - 0.35, half - 0.1, high / 2 - 0.1), (1, 0.02), material=wood)
    leaves(kit, (0, 0, lift), np.eye(3), long + 0.2, (half + 0.35, -0.35 * high / half), (0, high), 0.1, cover)
    kit.add(BOX, (0.9, 0, lift), (long + 1.2, half + 0.2, 0.12), material=frame)
    for x in np.linspace(-long + 0.3, long + 1.7, 4):
        kit.add(BOX, (x, half * 0.8, lift / 2), (0.12, 0.12, lift / 2), material=frame, mirror=True)
    for end in (-1, 1):
        face = end * (long - 0.35)
        kit.add(BOX, (face, 0, lift + high * 0.5), (0.06, half * 0.72, high * 0.36), (1, 0.08), material=frame if end < 0 else glass)
        if end < 0:
            kit.add(BOX, (face - 0.03, 0, lift + high * 0.5), (0.07, half * 0.4, high * 0.18), (1, 0.5), material=glass)
            continue
        for y in (-0.33, 0, 0.33):
            kit.add(BOX, (face + 0.05, y * half, lift + high * (0.48 - 0.55 * abs(y)) + 0.05), (0.06, 0.06, high * (0.44 - 0.5 * abs(y))), material=frame)
        for z in (0.12, 0.42):
            kit.add(BOX, (face + 0.05, 0, lift + high * z), (0.07, half * (1 - z) - 0.1, 0.1), material=frame)
    door(kit, (long - 0.32, 0.5, lift), (0.42, 0.95), leaf(kit), frame)
    for side in (-1, 1):
        kit.railing((long, side * half, lift), (long + 2.0, side * half, lift), 0.9, frame, 0.25, thick=0.04)
        kit.railing((long + 2.05, side * half, lift), (long + 2.05, side * 0.7, lift), 0.9, frame, 0.25, thick=0.04)
    if kit.chance(0.5):
        kit.add(BOX, (-long * 0.2, half * 0.5, lift + high * 0.52), (0.8, 0.55, 0.6), material=wood, mirror=True)
        kit.add(BOX, (-long * 0.2, half * 0.5, lift + high * 0.52 + 0.65), (0.95, 0.75, 0.07), material=cover, mirror=True)
        kit.add(BOX, (-long * 0.2, half * 0.5 + 0.55, lift + high * 0.53), (0.6, 0.04, 0.4), material=glass, mirror=True)
    kit.between((-long * 0.6, 0.5, lift + high * 0.6), (-long * 0.6, 0.5, lift + high + 0.7), 0.15, material=tinted(kit, (GREY, TIMBER)))


def stilt_house(kit):
    rng = kit.rng
    wood = tinted(kit, (WOOD, GREY, BLUE, WHITE, RED, GREEN, THATCH), (PLANKS, STRIPES), frequency=rng.uniform(14, 22))
    post, glass, frame = tinted(kit, (WOOD, TIMBER, GREY)), panes(kit), trim(kit)
    cover = tinted(kit, (THATCH, GREY, TILE, THATCH), (STREAKS, RIBS, SHINGLES), frequency=16, gloss=0.02)
    x, y, lift, high = rng.uniform(2.4, 3.4), rng.uniform(2.8, 4), rng.uniform(1.6, 3), 2.5
    deck = rng.uniform(1.2, 1.9)
    for px in np.linspace(-x, x + deck - 0.2, 4):
        for py in (-1, 0, 1):
            kit.add(CYL, (px, py * (y - 0.1), lift / 2), (0.11, 0.11, lift / 2), material=post)
    for side in (-1, 1):
        kit.between((-x, side * (y - 0.1), 0.2), (x, side * (y - 0.1), lift - 0.1), 0.06, BOX, material=post)
        kit.between((x, side * (y - 0.1), 0.2), (-x, side * (y - 0.1), lift - 0.1), 0.06, BOX, material=post)
    kit.add(BOX, (deck / 2, 0, lift), (x + deck / 2 + 0.1, y + 0.15, 0.1), material=post)
    kit.add(BOX, (0, 0, lift + high / 2), (x, y, high / 2), material=wood)
    top, kind = lift + high, rng.choice(["gable", "hip", "gable"])
    roof(kit, (deck / 2, 0, top), (x + deck / 2, y), x * rng.uniform(0.6, 1.2), kind, 0.6, cover, wood if kind == "gable" else post, 1)
    for py in (-1, -0.35, 0.35, 1):
        kit.add(BOX, (x + deck - 0.1, py * (y - 0.1), lift + high / 2), (0.07, 0.07, high / 2), material=post)
    lights(kit, (0, 0, lift + 1.4), (x, y), row(3, y)[::2], (0.45, 0.5), glass, frame, 0)
    lights(kit, (0, 0, lift + 1.4), (x, y), row(2, x), (0.4, 0.5), glass, frame, 1)
    door(kit, (x, 0, lift + 0.1), (0.45, 0.95), leaf(kit), frame)
    stairs(kit, (x + deck + lift * 0.9, 0, 0), (x + deck, 0, lift), 0.55, post)
    for side in (-1, 1):
        kit.railing((x + deck, side * y, lift), (x + deck, side * 0.6, lift), 0.85, post, 0.25, thick=0.03)


def mobile_home(kit):
    rng = kit.rng
    body = tinted(kit, (WHITE, CREAM, GREY, BLUE, GREEN), (RIBS, BANDS, PLAIN), frequency=rng.uniform(8, 16), gloss=0.1)
    frame, glass, dark = tinted(kit, (WHITE, GREY, WOOD)), panes(kit), kit.material(dark=True)
    x, y, base, high = rng.uniform(5, 6.5), rng.uniform(1.5, 2.0), 0.75, 2.5
    kit.add(BOX, (0, 0, base + high / 2), (x, y, high / 2), material=body)
    skirted = kit.chance(0.5)
    if skirted:
        kit.add(BOX, (0, 0, base / 2), (x - 0.08, y - 0.08, base / 2), material=tinted(kit, (GREY, WHITE, BRICK), (STRIPES, BRICKS), frequency=18))
    else:
        kit.add(BOX, (0, 0, base - 0.1), (x, y * 0.7, 0.12), material=dark)
        for place in (-0.35, 0.35):
            kit.add(CYL, (place, y - 0.2, 0.38), (0.38, 0.38, 0.14), rotation=ALONG_Y, material=dark, mirror=True)
        for place in (-0.85, -0.45, 0.45, 0.85):
            kit.add(BOX, (place * x, y * 0.6, base / 2), (0.2, 0.2, base / 2), material=tinted(kit, (CONCRETE,)), mirror=True)
    roof(kit, (0, 0, base + high), (x, y), y * rng.uniform(0.2, 0.45), rng.choice(["gable", "flat", "gable"]), 0.15, tiles(kit), body, 0)
    kit.add(BOX, (0, 0, base + 0.35), (x + 0.02, y + 0.02, 0.12), material=leaf(kit))
    lights(kit, (0, 0, base + 1.5), (x, y), [-0.75 * x, -0.42 * x, 0.6 * x], (0.5, 0.45), glass, frame, 1)
    lights(kit, (0, 0, base + 1.5), (x, y), [0], (0.7, 0.5), glass, frame, 0)
    door(kit, (x * 0.1, y, base), (0.42, 0.95), leaf(kit), frame, 1)
    deep = rng.uniform(1.0, 2.0)
    kit.add(BOX, (x * 0.1, y + deep / 2, base - 0.1), (1.6, deep / 2, 0.08), material=frame)
    for px in (-1.5, 1.5):
        kit.add(BOX, (x * 0.1 + px, y + deep - 0.08, (base + 1.0) / 2), (0.07, 0.07, (base + 1.0) / 2), material=frame)
    kit.railing((x * 0.1 - 1.5, y + deep - 0.08, base), (x * 0.1 + 1.5, y + deep - 0.08, base), 0.9, frame, 0.25, thick=0.03)
    stairs(kit, (x * 0.1 + 1.6 + base, y + deep / 2, 0), (x * 0.1 + 1.6, y + deep / 2, base - 0.05), 0.4, frame)
    if kit.chance(0.5):
        kit.add(BOX, (x * 0.1, y + deep / 2, base + 2.35), (1.8, deep / 2 + 0.2, 0.05), rotation=turn("x", -6), material=body)
        for px in (-1.5, 1.5):
            kit.add(BOX, (x * 0.1 + px, y + deep - 0.08, (base + 2.3) / 2), (0.06, 0.06, (base + 2.3) / 2), material=frame)
    if not skirted:
        kit.between((x, 0, base - 0.1), (x + 1.2, 0, base - 0.15), (0.08, 0.12), BOX, material=dark)
        kit.between((x + 1.1, 0, 0), (x + 1.1, 0, base), 0.05, material=dark)
    kit.add(BOX, (-x * 0.4, 0, base + high + y * 0.3), (0.4, 0.4, 0.3), material=tinted(kit, (GREY, WHITE)))


def terrace(kit):
    rng = kit.rng
    count = int(rng.integers(3, 5))
    storeys = int(rng.choice([2, 2, 3])) if count == 3 else 2
    half, x, same = rng.uniform(2.1, 2.8), rng.uniform(3.6, 4.6), kit.chance(0.5)
    walls, cover, frame, glass = brickwork(kit) if kit.chance(0.6) else render(kit), tiles(kit), trim(kit), panes(kit)
    stepped = kit.chance(0.35)  # each with its own gable to the street
    high = 2.9 * storeys
    for k in range(count):
        at = (2 * k - count + 1) * half
        own = walls if same else walls_of(kit)
        tall = high if same else high + rng.uniform(-0.4, 0.6)
        kit.add(BOX, (0, at, tall / 2), (x, half, tall / 2), material=own)
        if stepped:
            roof(kit, (0, at, tall), (x, half), half * 1.1, "gable", 0.0 if not same else 0.05, cover, own, 0)
        else:
            leaves(kit, (0, at, tall), turn("z", 90), half, (x + 0.3, -0.3 * 0.6), (0, x * 0.6), 0.1, cover)
            kit.add(BOX, (0, at, tall + x * 0.3), (x, half, x * 0.3), (0.02, 1), material=own)
        for s in range(storeys):
            places = row(2, half) if s else [-half * 0.4]
            lights(kit, (0, at, 1.6 + 2.9 * s), (x, half), places, (0.42 if s else 0.6, 0.65), glass, frame, 0, False)
        door(kit, (x, at + half * 0.5, 0), (0.42, 1.05), leaf(kit), frame)
        if storeys == 2:
            kit.add(BOX, (-0.2, at + half, high + x * 0.75), (0.7, 0.28, x * 0.2 + 0.3), material=own if not stepped else walls)
    for side in (-1, 1):
        kit.add(BOX, (0, side * count * half, 1.7), (0.5, 0.05, 0.6), material=glass)


def yurt(kit):
    rng = kit.rng
    felt = tinted(kit, (WHITE, CREAM, SAND, GREY), (PLAIN, CLOUDY, STREAKS), gloss=0.0)
    band, wood = tinted(kit, (WOOD, RED, BLUE, SAND), (PLAIN, WAVES), frequency=18), tinted(kit, (OCHRE, RED, BLUE, GREEN), (PLAIN,))
    radius, high, rise = rng.uniform(2.4, 3.2), rng.uniform(1.5, 1.9), rng.uniform(0.9, 1.5)
    kit.add(CYL, (0, 0, 0.06), (radius * 1.08, radius * 1.08, 0.06), material=tinted(kit, (WOOD, SAND)))
    kit.add(CYL, (0, 0, high / 2), (radius, radius, high / 2), material=felt)
    kit.loft((0, 0, high - 0.06), [(0, radius * 1.05), (rise * 0.55, radius * 0.58), (rise, radius * 0.22)], felt)
    kit.add(CYL, (0, 0, high + rise), (radius * 0.24, radius * 0.24, 0.1), material=wood)
    kit.add(BALL, (0, 0, high + rise), (radius * 0.22, radius * 0.22, 0.3), material=panes(kit) if kit.chance(0.5) else felt)
    for z in rng.choice([0.25, 0.5, 0.75, 0.97], int(rng.integers(2, 4)), replace=False):
        kit.add(CYL, (0, 0, high * z), (radius + 0.025, radius + 0.025, 0.06), material=band)
    spots = around(10, radius * 1.05)
    for px, py in spots:
        kit.between((px * 1.0, py * 1.0, high), (px * 0.22, py * 0.22, high + rise + 0.02), 0.025, material=band)
    door(kit, (radius, 0, 0.1), (0.48, high * 0.44), wood, band)
    kit.add(BOX, (radius - 0.1, 0, high * 0.5), (0.14, 0.62, high * 0.5), material=felt)
    if kit.chance(0.6):
        kit.between((-radius * 0.4, radius * 0.3, high), (-radius * 0.4, radius * 0.3, high + rise + 0.8), 0.09, material=tinted(kit, (GREY, TIMBER)))
    lights(kit, (0, 0, high * 0.55), (radius, radius - 0.05), [0], (0.3, 0.28), panes(kit), wood, 1)


def igloo(kit):
    rng = kit.rng
    snow = kit.material(base=SNOW, pattern=BRICKS, frequency=rng.uniform(5, 9), second=np.array(SNOW) * rng.uniform(0.45, 0.7), gloss=0.1)
    radius, flat = rng.uniform(1.8, 2.4), rng.uniform(0.8, 1.05)
    angles = np.radians(np.linspace(0, 84, 7))
    profile = [(radius * flat * np.sin(a), radius * np.cos(a)) for a in angles]
    kit.loft((0, 0, 0), profile, snow)
    kit.add(BALL, (0, 0, radius * flat * 0.9), (radius * 0.36, radius * 0.36, radius * flat * 0.12), material=snow)
    wide, long = radius * rng.uniform(0.3, 0.38), radius * rng.uniform(0.45, 0.8)
    mid = radius * 0.75 + long / 2
    kit.add(CYL, (mid, 0, wide * 0.5), (wide, wide, long / 2 + radius * 0.2), rotation=ALONG_X, material=snow)
    kit.add(BOX, (mid, 0, wide * 0.25), (long / 2 + radius * 0.2, wide, wide * 0.25), material=snow)
    end = mid + long / 2 + radius * 0.2
    hole = kit.material(dark=True, pattern=PLAIN)
    kit.add(CYL, (end, 0, wide * 0.5), (wide * 0.7, wide * 0.7, 0.03), rotation=ALONG_X, material=hole)
    kit.add(BOX, (end, 0, wide * 0.25), (0.03, wide * 0.7, wide * 0.25), material=hole)
    for _ in range(int(rng.integers(0, 5))):
        angle, size = rng.uniform(60, 300), rng.uniform(0.18, 0.3)
        px, py = (turn("z", angle) @ [radius * rng.uniform(1.1, 1.3), 0, 0])[:2]
        kit.add(BOX, (px, py, size * 0.6), (size * 1.4, size, size * 0.6), rotation=turn("z", angle), material=snow)
    kit.add(CYL, (0, 0, 0.04), (radius * 1.12, radius * 1.12, 0.06), (0.95, 1), material=kit.material(base=SNOW, pattern=CLOUDY))


def tree_house(kit):
    rng = kit.rng
    bark = tinted(kit, (TIMBER, WOOD, GREY), (STREAKS, CLOUDY), frequency=20, gloss=0.0)
    wood, cover, glass, frame = boards(kit), tiles(kit), panes(kit), trim(kit)
    lift, x, y, high = rng.uniform(2.6, 4), rng.uniform(1.3, 1.8), rng.uniform(1.3, 1.9), 1.9
    kit.add(CYL, (0, 0, 0.3), (0.75, 0.75, 0.3), (0.65, 1), material=bark)
    kit.add(CYL, (0, 0, (lift + high) / 2 + 0.7), (0.48, 0.48, (lift + high) / 2 + 0.7), (0.7, 1), material=bark)
    green = kit.material(base=np.array(LEAF) * rng.uniform(0.6, 2), second=np.array(LEAF) * 2.5, pattern=CLOUDY, frequency=20, gloss=0.0)
    crown = lift + high + rng.uniform(1.6, 2.2)
    for _ in range(int(rng.integers(5, 8))):
        size = rng.uniform(1.1, 1.8)
        kit.add(
            BALL,
            (*rng.uniform(-1.4, 1.4, 2), crown + rng.uniform(0, 1)),
            (size, size, size * 0.75),
            material=green,
            cut=(LEAVES, rng.uniform(5, 9), rng.uniform(0.6, 0.85)),
        )
    for px, py in around(4, 1, 45):
        kit.between((0, 0, lift - 1.1), (px * (x + 0.3), py * (y + 0.3), lift - 0.05), 0.09, BOX, material=bark)
    kit.add(BOX, (0.35, 0, lift), (x + 0.75, y + 0.4, 0.08), material=wood)
    kit.add(BOX, (0, 0, lift + high / 2), (x, y, high / 2), material=wood)
    roof(kit, (0, 0, lift + high), (x, y), rng.uniform(0.7, 1.1), rng.choice(["gable", "shed", "gable"]), 0.3, cover, wood, int(rng.integers(2)))
    lights(kit, (0, 0, lift + 1.05), (x, y), [-y * 0.45], (0.3, 0.32), glass, frame, 0)
    lights(kit, (0, 0, lift + 1.05), (x, y), [0], (0.34, 0.32), glass, frame, 1)
    door(kit, (x, y * 0.45, lift + 0.08), (0.34, 0.75), leaf(kit), frame)
    railed(kit, 0.35, 0, lift + 0.08, x + 0.7, y + 0.36, 0.65, wood)
    foot, head = np.array([x + 1.6, 0, 0]), np.array([x + 1.0, 0, lift + 0.1])
    for side in (-0.28, 0.28):
        kit.between(foot + [0, side, 0], head + [0, side, 0], 0.05, material=bark)
    kit.between(foot, head, (0.03, 0.28), BOX, material=bark, cut=(RUNGS, 9, 0.3))
