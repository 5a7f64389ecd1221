"""A maker of industry's installations, and what it shares with those of airfields and landmarks: paints, walls, stairs, ladders, trestles."""

import numpy as np

from .frames import lattice_tower
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, LATTICE, PRISM, RUNGS, TUBE
from .machines import wheel
from .materials import BANDS, BRICKS, CLOUDY, PATCHWORK, PLAIN, PLANKS, RIBS, SEAMS, SHINGLES, STREAKS, STRIPES, WAVES, WINDOWS, WRITING
from .wheeled import glazing

# Linear colours.
WHITE, GREY, BLACK, CONCRETE = (0.75, 0.75, 0.72), (0.35, 0.36, 0.37), (0.03, 0.03, 0.035), (0.42, 0.4, 0.36)
RED, ORANGE, YELLOW, GREEN, BLUE = (0.45, 0.03, 0.02), (0.65, 0.2, 0.03), (0.7, 0.42, 0.03), (0.06, 0.2, 0.08), (0.04, 0.12, 0.4)
STONE, BRICK, WOOD, SLATE = (0.55, 0.46, 0.33), (0.3, 0.1, 0.06), (0.25, 0.14, 0.07), (0.08, 0.09, 0.11)
COPPER, GOLD, TILE, EARTH, RUST = (0.2, 0.45, 0.35), (0.7, 0.48, 0.1), (0.4, 0.13, 0.06), (0.25, 0.18, 0.1), (0.22, 0.09, 0.04)
OLIVE, SAND = (0.11, 0.12, 0.06), (0.5, 0.38, 0.22)


def tinted(kit, bases, patterns=(PLAIN,), **fixed):
    """A material near one of the colours `bases`."""
    base = np.array(bases)[kit.rng.integers(len(bases))] * kit.rng.uniform(0.7, 1.25)
    if kit.chance(0.85):
        fixed = {"second": np.clip(base * kit.rng.uniform(0.5, 1.5), 0.01, 0.95), **fixed}
    return kit.material(base=base, pattern=kit.rng.choice(patterns), **fixed)


def steelwork(kit):
    return tinted(kit, (GREY, WHITE, RED, YELLOW, BLUE, GREEN, RUST, GREY), (PLAIN, PLAIN, STREAKS), gloss=0.15)


def walling(kit):
    return tinted(kit, (CONCRETE, WHITE, STONE, BRICK, GREY), (PLAIN, BRICKS, STREAKS, CLOUDY), frequency=kit.rng.uniform(8, 25), gloss=0.02)


def stonework(kit):
    return tinted(kit, (STONE, CONCRETE, WHITE, SAND), (PLAIN, BRICKS, CLOUDY, STREAKS, SEAMS), frequency=kit.rng.uniform(6, 22), gloss=0.02)


def corners(half_x, half_y, z, x=0.0, y=0.0):
    """The four corners [3] of a rectangle, in order around."""
    return [np.array([x + i * half_x, y + j * half_y, z]) for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]


def stage(kit, x, y, z, radius, metal, rail=0.2):
    """A round platform with a railing."""
    kit.add(CYL, (x, y, z), (radius, radius, 0.03), material=metal)
    kit.add(TUBE, (x, y, z + rail / 2), (radius, radius, rail / 2), material=metal, cut=(BARS, 30, 0.25))


def railed(kit, x, y, z, half_x, half_y, high, metal):
    """Railings along the four edges of a platform."""
    ring = corners(half_x, half_y, z, x, y)
    for start, end in zip(ring, ring[1:] + ring[:1], strict=True):
        kit.railing(start, end, high, metal, max(half_x, half_y) / 6, thick=0.015)


def ladder(kit, start, end, wide, metal):
    """Rungs between two rails, along x at the most."""
    kit.between(start, end, (0.02, wide), BOX, material=metal, cut=(RUNGS, 1 / wide, 0.3))


def trestle(kit, feet, heads, radius, metal, bays=1, crossed=False, kind=BOX):
    """Legs from `feet` to `heads`, points [3] in order around, with braces from leg to leg in each of the bays."""
    feet, heads = np.array(feet), np.array(heads)
    for foot, head in zip(feet, heads, strict=True):
        kit.between(foot, head, radius, kind, material=metal)
    levels = np.linspace(0, 1, bays + 1)
    for low, high in zip(levels[:-1], levels[1:], strict=True):
        below, above = feet + (heads - feet) * low, feet + (heads - feet) * high
        for k in range(len(feet)):
            kit.between(below[k], above[k - 1], radius * 0.6, kind, material=metal)
            if crossed:
                kit.between(below[k - 1], above[k], radius * 0.6, kind, material=metal)


def stairs(kit, start, end, wide, metal):
    """A flight of steps with a sloping plate and a rail at either side, along x or y."""
    start, end = np.array(start, float), np.array(end, float)
    kit.between(start, end, (0.03, wide), BOX, material=metal, cut=(RUNGS, 1 / (0.5 * wide), 0.6))
    side = np.cross([0, 0, 1], end - start)
    side = side / np.linalg.norm(side) * wide
    for way in (-1, 1):
        kit.between(start + side * way + [0, 0, wide], end + side * way + [0, 0, wide], 0.02, BOX, material=metal)


def installation(kit):
    """Pump jacks, drilling rigs, platforms at sea, gas spheres, grain silos, transformers, dams, locks, solar arrays, port and yard cranes, conveyors, water towers,
    refinery columns, observatories, radomes."""
    kinds = [pump_jack, drill_rig, platform, spheres, silos, transformer, dam, lock, solar, port_crane, yard_crane, conveyor, water_tower, column, observatory, radome]
    kinds[kit.rng.choice(len(kinds))](kit)


def pump_jack(kit):
    rng = kit.rng
    paint, second, dark, metal = steelwork(kit), steelwork(kit), kit.material(dark=True), tinted(kit, (GREY, RUST))
    high, front, back, tip = rng.uniform(2.6, 3.2), rng.uniform(1.7, 2.2), rng.uniform(1.4, 1.8), rng.uniform(-13, 13)
    lift, pivot, reach = turn("y", -tip), np.array([0, 0, high]), front + 0.3
    kit.add(BOX, (-0.5 * back - 0.5, 0, 0.09), (0.5 * back + 1.3, 0.6, 0.09), material=tinted(kit, (CONCRETE, RUST)))
    for x in (-0.75, 0.5):
        kit.between((x, 0.5, 0.15), (0, 0.14, high), (0.07, 0.07), BOX, material=paint, mirror=True)
    for share in (0.35, 0.65):
        kit.between(
            (-0.75 + 0.75 * share, 0.5 - 0.36 * share, high * share), (0.5 - 0.5 * share, 0.5 - 0.36 * share, high * share), 0.045, BOX, material=paint, mirror=True
        )
    kit.add(CYL, pivot, (0.13, 0.13, 0.24), rotation=ALONG_Y, material=dark)
    kit.add(BOX, pivot + lift @ [(front - back) / 2, 0, 0.16], ((front + back) / 2, 0.1, 0.17), rotation=lift, material=paint)
    for angle, deep in ((15, 0.17), (5, 0.3), (-5, 0.34), (-15, 0.26), (-24, 0.15)):
        spin = turn("y", -(tip + angle))
        kit.add(BOX, pivot + spin @ [reach - deep, 0, 0.1], (deep, 0.14, reach * 0.09), rotation=spin, material=second)
    kit.between((reach, 0.07, high), (reach, 0.07, 1.25), 0.018, material=dark, mirror=True)
    kit.add(BOX, (reach, 0, 1.25), (0.07, 0.16, 0.05), material=dark)
    kit.between((reach, 0, 0.5), (reach, 0, 1.25), 0.03, material=metal)
    kit.loft((reach, 0, 0), [(0, 0.2), (0.08, 0.2), (0.081, 0.12), (0.5, 0.12), (0.55, 0.16), (0.62, 0.16), (0.72, 0.06)], second)
    kit.between((reach, -0.45, 0.42), (reach, 0.3, 0.42), 0.06, material=metal)
    kit.between((reach, -0.42, 0.42), (reach, -0.42, 0), 0.05, material=metal)
    crank = np.array([-back, 0, 1.2])
    angle = np.arcsin(-tip / 14)
    arm = np.array([-np.cos(angle), 0, np.sin(angle)])
    kit.add(BOX, crank - [0, 0, 0.15], (0.4, 0.28, 0.32), (0.8, 1), material=paint)
    kit.add(BOX, (-back, 0, 0.5), (0.55, 0.3, 0.4), (0.7, 0.9), material=paint)
    kit.between(crank + [0, -0.5, 0], crank + [0, 0.5, 0], 0.09, material=dark)
    kit.between(crank + [0, 0.42, 0] - 0.15 * arm, crank + [0, 0.42, 0] + 0.95 * arm, (0.13, 0.06), BOX, material=second, mirror=True)
    kit.between(crank + [0, 0.42, 0] + 0.55 * arm, crank + [0, 0.42, 0] + 1.0 * arm, (0.36, 0.11), BOX, material=second, mirror=True)
    tail = pivot + lift @ [-back, 0, 0.0]
    kit.between(crank + [0, 0.56, 0] + 0.42 * arm, tail + [0, 0.56, 0], 0.05, BOX, material=paint, mirror=True)
    kit.between(tail - [0, 0.62, 0], tail + [0, 0.62, 0], 0.07, BOX, material=paint)
    kit.add(BOX, tail + [0, 0, 0.08], (0.1, 0.1, 0.12), material=paint)
    kit.add(BOX, (-back - 1.1, 0, 0.32), (0.35, 0.3, 0.15), material=paint)
    kit.add(CYL, (-back - 1.1, 0, 0.65), (0.22, 0.22, 0.34), rotation=ALONG_Y, material=dark)
    kit.between((-back - 1.15, 0.34, 0.65), crank + [0.1, 0.34, -0.1], (0.2, 0.05), BOX, 0.9, material=second)
    ladder(kit, (0.55, 0, 0.1), (0.08, 0, high - 0.2), 0.12, dark)
    if kit.chance(0.4):
        railed(kit, -0.5 * back - 0.5, 0, 0, 0.5 * back + 1.5, 1.0, 0.7, metal)


def drill_rig(kit):
    rng = kit.rng
    paint, second, dark = steelwork(kit), steelwork(kit), kit.material(dark=True)
    floor, half, tall = rng.uniform(0.9, 1.6), rng.uniform(0.75, 1.0), rng.uniform(4.5, 6.5)
    trestle(kit, corners(half * 1.3, half * 1.2, 0), corners(half * 1.3, half * 1.2, floor), 0.08, second, 1, True)
    kit.add(BOX, (0, 0, floor), (half * 1.5, half * 1.4, 0.08), material=second)
    lattice_tower(kit, (0, 0, floor), half, half * rng.uniform(0.3, 0.5), tall, paint, rng.uniform(1.2, 1.8) / half)
    for corner, top in zip(corners(half, half, floor), corners(half * 0.4, half * 0.4, floor + tall), strict=True):
        kit.between(corner, top, 0.05, BOX, material=paint)
    kit.add(BOX, (0, 0, floor + tall), (half * 0.55, half * 0.55, 0.08), material=second)
    kit.add(BOX, (0, 0, floor + tall + 0.2), (half * 0.2, half * 0.35, 0.2), material=dark)
    board = floor + tall * 0.62
    kit.add(BOX, (half * 0.2, 0, board), (half * 1.0, half * 0.75, 0.04), material=dark)
    kit.between((0, 0, floor + tall), (0, 0, floor + tall * 0.45), 0.025, material=dark)
    kit.add(BOX, (0, 0, floor + tall * 0.45), (0.16, 0.14, 0.3), material=second)
    kit.between((0, 0, floor + tall * 0.45), (0, 0, 0), 0.05, material=dark)
    for y in (-0.35, 0.35):
        kit.between((-half * 0.45, y * half, floor), (-half * 0.2, y * half, board + 0.4), 0.06, BOX, material=dark)
    kit.add(BOX, (-half * 0.5, half * 1.75, floor + 0.38), (0.6, 0.4, 0.36), material=tinted(kit, (WHITE, GREY, BLUE)))
    kit.between((-half * 0.5, half * 2.0, 0), (-half * 0.5, half * 2.0, floor), 0.3, BOX, material=second, cut=(LATTICE, 2, 0.2))
    kit.between((half * 1.4, 0, floor), (half * 1.4 + floor * 1.2, 0, 0.05), (0.05, 0.35), BOX, material=dark)
    stairs(kit, (-half * 1.3 - floor * 1.1, -half * 0.8, 0), (-half * 1.4, -half * 0.8, floor), 0.25, second)
    railed(kit, 0, 0, floor + 0.05, half * 1.5, half * 1.4, 0.4, second)
    for k in range(int(rng.integers(1, 4))):
        kit.add(
            BOX,
            (-half * 2.7 - 0.9, half * (1.5 - 1.2 * k), 0.4),
            (0.9, half * 0.5, 0.4),
            material=second if k % 2 else tinted(kit, (WHITE, ORANGE, BLUE, GREY), (RIBS, PLAIN)),
        )


def platform(kit):
    rng = kit.rng
    paint, dark = tinted(kit, (YELLOW, RED, GREY, ORANGE), (PLAIN, STREAKS)), kit.material(dark=True)
    second, white = steelwork(kit), tinted(kit, (WHITE, GREY), (PLAIN, WINDOWS), frequency=rng.uniform(20, 40))
    long, wide, deck = rng.uniform(1.5, 2.1), rng.uniform(1.1, 1.5), rng.uniform(1.8, 2.8)
    kind = rng.choice(["jacket", "jackup", "columns"])
    if kind == "jacket":
        trestle(kit, corners(long * 1.05, wide * 1.1, 0), corners(long * 0.75, wide * 0.75, deck), 0.1, paint, 1 if kit.chance(0.5) else 2, False, CYL)
        for y in (-0.25, 0.25):
            kit.between((0, y, 0), (0, y, deck), 0.05, material=dark)
    elif kind == "columns":
        for x in (-long * 0.7, long * 0.7):
            kit.add(CYL, (x, wide * 0.7, deck / 2), (0.3, 0.3, deck / 2), material=paint, mirror=True)
        kit.add(BOX, (0, wide * 0.7, 0.2), (long * 1.15, 0.35, 0.2), material=dark if kit.chance(0.5) else paint, mirror=True)
        for x in (-long * 0.7, long * 0.7):
            kit.between((x, -wide * 0.7, deck * 0.45), (x, wide * 0.7, deck * 0.45), 0.1, material=paint)
    else:
        tall = deck + rng.uniform(1.5, 3)
        for x, y in ((long * 0.8, 0), (-long * 0.75, wide * 0.72), (-long * 0.75, -wide * 0.72)):
            for k in range(3):
                spin = turn("z", 120 * k)
                kit.add(BOX, np.array([x, y, tall / 2]) + spin @ [0, 0.13, 0], (0.24, 0.015, tall / 2), rotation=spin, material=paint, cut=(LATTICE, 2.6, 0.25))
            kit.add(PRISM, (x, y, 0.06), (0.3, 0.3, 0.06), (1, 6), material=dark)
    kit.add(BOX, (0, 0, deck + 0.14), (long, wide, 0.14), material=paint if kit.chance(0.5) else second)
    upper = deck + 0.28
    if kind != "jackup":
        for corner in corners(long * 0.92, wide * 0.92, upper + 0.35):
            kit.add(BOX, corner, (0.05, 0.05, 0.36), material=paint)
        for x in (-0.35, 0.3):
            kit.add(BOX, (x * long, rng.uniform(-0.2, 0.2) * wide, upper + 0.3), (long * 0.26, wide * 0.6, 0.36), material=tinted(kit, (GREY, WHITE, BLUE)))
        kit.add(BOX, (0, 0, upper + 0.7), (long, wide, 0.06), material=second)
        upper += 0.76
    kit.add(BOX, (-long * 0.7, 0, upper + 0.42), (long * 0.25, wide * 0.7, 0.42), material=white)
    pad = (-long * 0.95, 0, upper + 0.95)
    kit.add(PRISM, pad, (wide * 0.75, wide * 0.75, 0.05), (1, 8), material=tinted(kit, (GREEN, GREY)))
    kit.add(TUBE, (*pad[:2], pad[2] + 0.05), (wide * 0.5, wide * 0.5, 0.012), material=tinted(kit, (WHITE, YELLOW)))
    kit.add(BOX, (-long * 0.75, 0, upper + 0.87), (0.25, 0.4, 0.1), material=second)
    lattice_tower(kit, (long * 0.2, 0, upper), wide * 0.32, wide * 0.12, rng.uniform(1.8, 3), paint if kit.chance(0.5) else second)
    kit.add(BOX, (long * 0.2, 0, upper + 0.2), (wide * 0.4, wide * 0.4, 0.2), material=second)
    for y in [-1, 1][: int(rng.integers(1, 3))]:
        base = np.array([long * rng.uniform(-0.1, 0.6), y * wide * 0.85, upper])
        kit.add(CYL, base + [0, 0, 0.35], (0.1, 0.1, 0.35), material=paint)
        kit.add(BOX, base + [0, 0, 0.75], (0.2, 0.15, 0.16), material=white)
        kit.between(base + [0.1, 0, 0.75], base + [rng.uniform(0.9, 1.6), 0, rng.uniform(1.2, 2.0)], (0.06, 0.05), BOX, 0.4, material=paint)
    if kit.chance(0.6):
        tip = np.array([long + rng.uniform(1.0, 1.8), 0, upper + rng.uniform(0.8, 1.8)])
        kit.between((long * 0.9, 0, upper), tip, (0.12, 0.12), BOX, 0.4, material=second, cut=(LATTICE, 5, 0.3))
        kit.between((long * 0.9, 0, upper), tip, 0.03, material=dark)
    for _ in range(3):
        half = rng.uniform(0.1, 0.25, 3)
        kit.add(BOX, (rng.uniform(0.5, 0.85) * long, rng.uniform(-0.7, 0.7) * wide, upper + half[2]), half)


def spheres(kit):
    rng = kit.rng
    skin, metal, pad = tinted(kit, (WHITE, WHITE, GREY, GREEN, SAND), (PLAIN, SEAMS, STREAKS), gloss=0.3), steelwork(kit), tinted(kit, (CONCRETE,), (CLOUDY,))
    count, legs, lift = int(rng.choice([1, 1, 2, 3])), int(rng.choice([6, 8, 10])), rng.uniform(1.15, 1.5)
    legs = min(legs, 6) if count > 1 else legs
    for k in range(count):
        x = 2.7 * k
        kit.add(BALL, (x, 0, lift), (1, 1, 1), material=skin)
        ring = [np.array([x + px, py, 0]) for px, py in around(legs, 1.0, 180 / legs)]
        top = [np.array([x + px, py, lift]) for px, py in around(legs, 0.97, 180 / legs)]
        if count < 3:
            trestle(kit, ring, top, 0.055, metal, 1, count == 1, CYL)
        else:
            for foot, head in zip(ring, top, strict=True):
                kit.between(foot, head, 0.055, material=metal)
        kit.add(CYL, (x, 0, lift), (1.02, 1.02, 0.02), material=metal if kit.chance(0.6) else skin)
        kit.add(CYL, (x, 0, 0.02), (1.25, 1.25, 0.03), material=pad)
        stage(kit, x, 0, lift + 0.97, 0.3, metal)
        kit.between((x, 0, 0.05), (x, 0, lift), 0.07, material=metal)
    edge = 2.7 * (count - 1)
    if kit.chance(0.7):  # a stair that leans on the last one
        kit.between((edge + 1.8, 0.35, 0), (edge + 1.05, 0.35, lift), (0.03, 0.15), BOX, material=metal, cut=(RUNGS, 9, 0.4))
        kit.between((edge + 1.03, 0.35, lift), (edge + 0.25, 0.1, lift + 1.0), (0.03, 0.15), BOX, material=metal, cut=(RUNGS, 9, 0.4))
    for x in 2.7 * np.arange(count - 1):
        kit.add(BOX, (x + 1.35, 0, lift + 1.0), (1.1, 0.1, 0.03), material=metal)


def silos(kit):
    rng = kit.rng
    metal, steel = tinted(kit, (GREY, WHITE, CONCRETE), (RIBS, SEAMS, BANDS, PLAIN), gloss=0.35, frequency=rng.uniform(8, 24)), tinted(kit, (GREY, YELLOW, BLUE, RUST))
    count, rows, radius, tall = int(rng.integers(2, 5)), int(rng.choice([1, 1, 2])), rng.uniform(0.5, 0.8), rng.uniform(1.4, 2.8)
    legs, rise = tall < 2 and rows == 1 and kit.chance(0.5), radius * rng.uniform(0.35, 0.6)
    base = radius * 1.3 if legs else 0.0
    top = base + tall + rise
    for k in range(count):
        for y in [0] if rows == 1 else [-radius * 1.05, radius * 1.05]:
            x = k * radius * 2.1
            if legs:
                kit.add(CYL, (x, y, base * 0.6), (radius * 0.15, radius * 0.15, base * 0.4), (6.6, 1), material=metal)
                for px, py in around(4, radius * 0.95, 45):
                    kit.add(BOX, (x + px, y + py, base * 0.55), (0.05, 0.05, base * 0.55), material=steel)
            else:
                kit.add(CYL, (x, y, 0.05), (radius * 1.05, radius * 1.05, 0.06), material=tinted(kit, (CONCRETE,)))
            kit.add(CYL, (x, y, base + tall / 2), (radius, radius, tall / 2), material=metal)
            kit.add(CYL, (x, y, base + tall + rise / 2), (radius * 1.03, radius * 1.03, rise / 2), (0.2, 1), material=metal)
            kit.add(CYL, (x, y, top + 0.06), (radius * 0.16, radius * 0.16, 0.1), material=steel)
    end = (count - 1) * radius * 2.1
    high = top + rng.uniform(0.6, 1.4)
    x = -radius * 1.5
    kit.add(BOX, (x, 0, high / 2), (0.14, 0.1, high / 2), material=steel)
    kit.add(BOX, (x, 0, high + 0.12), (0.24, 0.16, 0.18), (0.7, 1), material=steel)
    lattice_tower(kit, (x, 0, 0), 0.28, 0.28, high, steel, 3.0)
    kit.between((x, 0, high), (0.0, 0, top + 0.1), 0.06, material=steel)
    kit.add(BOX, ((x + end) / 2, 0, top + 0.22), ((end - x) / 2 + 0.15, 0.14, 0.1), material=steel)
    kit.add(BOX, ((x + end) / 2, 0, top + 0.4), ((end - x) / 2 + 0.15, 0.18, 0.1), material=steel, cut=(BARS, 4, 0.2))
    if kit.chance(0.5):
        kit.add(BOX, (x - 0.8, 0, 0.5), (0.6, 0.7, 0.5), material=tinted(kit, (GREY, WHITE, GREEN), (RIBS,)))
        kit.add(BOX, (x - 0.8, 0, 1.12), (0.65, 0.78, 0.14), (1, 0.05), material=steel)
    for k in range(count):
        ladder(kit, (k * radius * 2.1, -radius * rows * 1.03, 0), (k * radius * 2.1, -radius * rows * 1.03, base + tall), 0.1, steel)


def bushing(kit, at, tall, radius, skin, metal, lean=None):
    """A ribbed insulator with a metal cap."""
    axis = np.eye(3) if lean is None else lean
    kit.add(CYL, np.array(at) + axis @ [0, 0, tall / 2], (radius * 0.55, radius * 0.55, tall / 2), (0.7, 1), rotation=axis, material=skin)
    for share in (0.15, 0.35, 0.55, 0.75):
        kit.add(CYL, np.array(at) + axis @ [0, 0, tall * share], (radius, radius, tall * 0.035), (0.7, 1), rotation=axis, material=skin)
    kit.add(CYL, np.array(at) + axis @ [0, 0, tall * 1.03], (radius * 0.35, radius * 0.35, tall * 0.09), rotation=axis, material=metal)


def transformer(kit):
    rng = kit.rng
    paint, metal, dark = tinted(kit, (GREY, GREY, WHITE, GREEN, BLUE), (PLAIN, STREAKS)), tinted(kit, (GREY,), gloss=0.4), kit.material(dark=True)
    skin = tinted(kit, ((0.18, 0.06, 0.03), GREY, WHITE), gloss=0.5)
    long, wide, tall = rng.uniform(0.8, 1.3), rng.uniform(0.45, 0.65), rng.uniform(0.55, 0.75)
    kit.add(BOX, (0, 0, 0.06), (long * 1.5, wide * 2.4, 0.06), material=tinted(kit, (CONCRETE,), (CLOUDY,)))
    for y in (-wide * 0.6, wide * 0.6):
        kit.add(BOX, (0, y, 0.18), (long, 0.08, 0.08), material=dark)
    kit.add(BOX, (0, 0, 0.25 + tall), (long, wide, tall), material=paint)
    kit.add(BOX, (0, 0, 0.25 + 2 * tall), (long * 1.04, wide * 1.06, 0.04), material=paint)
    lid = 0.25 + 2 * tall + 0.04
    fins, banks = kit.material(base=paint.first, pattern=RIBS, frequency=rng.uniform(30, 60)), int(rng.integers(2, 4))
    for k in range(banks):
        x = long * ((2 * k + 1) / banks - 1)
        kit.add(BOX, (x, wide * 1.48, 0.3 + tall), (long * 0.8 / banks, wide * 0.4, tall * 0.85), material=fins, mirror=True)
        for z in (0.35, 1.65):
            kit.add(BOX, (x, wide * 1.1, 0.3 + tall * z), (0.06, wide * 0.15, 0.06), material=paint, mirror=True)
    axis = ALONG_X if kit.chance(0.5) else ALONG_Y
    at = (-long * 0.3, -wide * 0.65, lid + 0.5) if axis is ALONG_X else (-long * 0.85, 0, lid + 0.5)
    half = long * 0.75 if axis is ALONG_X else wide * 1.1
    kit.add(CYL, at, (0.2, 0.2, half), rotation=axis, material=paint)
    for share in (-0.6, 0.6):
        kit.add(BOX, np.array(at) + axis @ [0, 0, half * share] - [0, 0, 0.3], (0.05, 0.05, 0.25), material=paint)
    spread, size = long * rng.uniform(0.4, 0.6), rng.uniform(0.7, 1.2)
    for k in (-1, 0, 1):
        bushing(kit, (spread * k + long * 0.1, wide * 0.4, lid), size, 0.13, skin, metal, turn("x", -14))
    for k in (-1, 0, 1):
        kit.loft((spread * k * 0.6 + long * 0.25, -wide * 0.3, lid), [(0, 0.09), (size * 0.3, 0.06), (size * 0.45, 0.03)], skin)
    kit.add(BOX, (long * 1.1, 0, 0.25 + tall), (long * 0.12, wide * 0.45, tall * 0.6), material=tinted(kit, (WHITE, GREY)))
    kit.add(BOX, (long * 1.23, wide * 0.15, 0.25 + tall * 1.2), (0.01, 0.1, 0.08), material=tinted(kit, (YELLOW,)))


def dam(kit):
    rng = kit.rng
    wall, dark, steel = tinted(kit, (CONCRETE, STONE), (STREAKS, CLOUDY, BRICKS, SEAMS)), kit.material(dark=True), steelwork(kit)
    high, half = rng.uniform(1.8, 2.8), rng.uniform(2.2, 3.2)
    if kit.chance(0.3):  # an arch
        bend, pieces = rng.uniform(50, 75), 9
        radius = half / np.sin(np.radians(bend))
        for angle in np.linspace(-bend, bend, pieces):
            spin = turn("z", 180 + angle)
            wide = (radius + 0.3) * np.tan(np.radians(bend / (pieces - 1))) * 1.03
            kit.add(BOX, spin @ [radius, 0, high / 2] + [radius, 0, 0], (0.3, wide, high / 2), (0.45, 1), (0.16, 0), spin, wall)
            kit.add(BOX, spin @ [radius + 0.08, 0, high + 0.05] + [radius, 0, 0], (0.19, wide, 0.06), rotation=spin, material=wall)
            if abs(angle) < bend * 0.45:
                kit.add(BOX, spin @ [radius, 0, high * 0.82] + [radius, 0, 0], (0.14, wide * 0.5, high * 0.06), rotation=spin, material=dark)
        kit.add(BOX, (half * 0.35, 0, 0.35), (0.4, half * 0.5, 0.35), material=tinted(kit, (WHITE, CONCRETE), (WINDOWS, PLAIN)))
        for side in (-1, 1):
            spin = turn("z", 180 + side * bend)
            kit.add(BOX, spin @ [radius, 0, high * 0.55] + [radius, 0, 0], (0.45, 0.3, high * 0.55), rotation=spin, material=tinted(kit, (EARTH, STONE), (CLOUDY,)))
        return
    deep, bays = high * rng.uniform(0.35, 0.5), int(rng.integers(3, 7))
    kit.add(BOX, (0, 0, high / 2), (deep, half, high / 2), (0.3, 1), (-deep * 0.65, 0), material=wall)
    span = half * rng.uniform(0.55, 0.85)
    pitch = 2 * span / bays
    for k in range(bays + 1):
        y = -span + pitch * k
        kit.add(BOX, (-deep * 0.3, y, high), (deep * 0.62, 0.08, 0.5), (0.7, 1), (-deep * 0.18, 0), material=wall)
        if k < bays:
            kit.add(BOX, (-deep * 0.5, y + pitch / 2, high + 0.12), (0.04, pitch * 0.46, 0.3), material=steel)
            kit.add(
                BOX,
                (deep * 0.06, y + pitch / 2, high * 0.47),
                (deep * 0.68, pitch * 0.36, high * 0.49),
                (0.25, 1),
                (-deep * 0.7, 0),
                material=tinted(kit, (WHITE,), (WAVES, STREAKS)),
            )
    kit.add(BOX, (-deep * 0.55, 0, high + 0.53), (deep * 0.35, half, 0.06), material=wall)
    for y in (-1, 1):
        kit.add(BOX, (-deep * 0.5, y * (half + span) / 2, high * 1.1), (deep * 0.35, (half - span) / 2, 0.45), material=wall)
    for x in (-0.88, -0.22):
        kit.railing((x * deep, -half, high + 0.58), (x * deep, half, high + 0.58), 0.14, steel)
    if kit.chance(0.6):
        kit.add(BOX, (-deep * 0.55, half * 0.82, high + 0.95), (deep * 0.3, half * 0.13, 0.4), material=walling(kit))
        kit.add(BOX, (-deep * 0.55, half * 0.82, high + 1.38), (deep * 0.36, half * 0.16, 0.06), material=tinted(kit, (SLATE, TILE)))
    kit.add(BOX, (deep + 0.3, -half * 0.6, 0.4), (0.45, half * 0.35, 0.4), material=tinted(kit, (WHITE, CONCRETE, BRICK), (WINDOWS, PLAIN)))
    kit.add(BOX, (deep * 0.5, half * 0.93, high * 0.34), (deep * 0.9, 0.12, high * 0.34), (0.5, 1), (-deep * 0.4, 0), material=wall)
    kit.add(BOX, (deep * 0.5, -half * 0.93, high * 0.34), (deep * 0.9, 0.12, high * 0.34), (0.5, 1), (-deep * 0.4, 0), material=wall)


def lock(kit):
    rng = kit.rng
    wall, gate, dark = stonework(kit), tinted(kit, (BLACK, GREEN, WOOD, RUST, GREY), (PLANKS, STREAKS, PLAIN)), kit.material(dark=True)
    long, wide, high = rng.uniform(1.8, 3), rng.uniform(0.7, 1.0), rng.uniform(0.5, 0.8)
    white, water = tinted(kit, (WHITE,)), kit.material(base=[0.05, 0.09, 0.08], pattern=WAVES, gloss=0.6)
    kit.add(BOX, (0, wide + 0.3, high), (long, 0.3, high), material=wall, mirror=True)
    kit.add(BOX, (0, wide + 0.35, 2 * high + 0.04), (long * 1.01, 0.38, 0.05), material=tinted(kit, (STONE, CONCRETE, WHITE)), mirror=True)
    kit.add(BOX, (0, 0, high * 0.3), (long, wide, high * 0.3), material=water)
    kit.add(BOX, (-long * 0.7, 0, high * 0.6), (long * 0.3, wide, high * 0.6), material=water)
    ends = (-long * 0.4, long * 0.6) if kit.chance(0.5) else (-long * 0.4,)
    for x in ends:
        miter = wide * 0.35
        for side in (-1, 1):
            hinge, meet = np.array([x, side * wide, high]), np.array([x - miter, 0, high])
            spin = turn("z", np.degrees(np.arctan2(*(meet - hinge)[[1, 0]])))
            reach = np.linalg.norm(meet - hinge)
            kit.add(BOX, (hinge + meet) / 2, (reach / 2 + 0.02, 0.05, high), rotation=spin, material=gate)
            kit.add(BOX, (hinge + meet) / 2 + [0, 0, high + 0.16], (reach / 2, 0.02, 0.15), rotation=spin, material=dark, cut=(BARS, 4, 0.25))
            kit.add(BOX, hinge + spin @ [-0.3, 0, high + 0.2], (1.0, 0.09, 0.09), rotation=spin, material=gate)
            kit.add(BOX, hinge + spin @ [-1.2, 0, high + 0.2], (0.12, 0.095, 0.095), rotation=spin, material=white)
            kit.add(BOX, hinge + spin @ [0.25, 0, high + 0.3], (0.05, 0.05, 0.3), rotation=spin, material=dark)
    for x in np.linspace(-0.85, 0.85, 4):
        kit.loft((x * long, wide + 0.25, 2 * high + 0.05), [(0, 0.06), (0.18, 0.05), (0.2, 0.08), (0.26, 0.07)], dark)
    if kit.chance(0.6):
        kit.add(BOX, (long * 0.2, wide + 0.5, 2 * high + 0.4), (0.35, 0.2, 0.35), material=walling(kit))
        kit.add(BOX, (long * 0.2, wide + 0.5, 2 * high + 0.88), (0.4, 0.26, 0.15), (0.8, 0.05), material=tinted(kit, (SLATE, TILE), (SHINGLES,)))
    kit.add(BOX, (long * 0.3, wide - 0.01, high), (0.08, 0.02, high), material=dark, mirror=True, cut=(RUNGS, 6, 0.3))


def solar(kit):
    rng = kit.rng
    cells = kit.material(
        base=rng.choice([[0.015, 0.03, 0.1], [0.01, 0.012, 0.03], [0.02, 0.05, 0.16]]),
        pattern=rng.choice([SEAMS, SEAMS, PLAIN]),
        frequency=rng.uniform(8, 20),
        gloss=0.6,
        second=[0.4] * 3,
    )
    metal, frame = tinted(kit, (GREY, WHITE), gloss=0.3), tinted(kit, (GREY, WHITE), gloss=0.4)
    kind = rng.choice(["rows", "tracker", "roof"], p=[0.55, 0.3, 0.15])
    if kind == "rows":
        tilt, half, wide, rise = rng.uniform(12, 42), rng.uniform(0.55, 1.0), rng.uniform(1.5, 3.2), rng.uniform(0.3, 0.7)
        lean = turn("y", tilt)
        drop = half * np.sin(np.radians(tilt))
        modules = int(rng.integers(3, 7))
        for k in range(int(rng.integers(1, 4))):
            x, z = -k * half * 2.8, rise + drop
            for m in range(modules):
                y = wide * ((2 * m + 1) / modules - 1)
                kit.add(BOX, (x, y, z), (half, wide * 0.97 / modules, 0.03), rotation=lean, material=cells)
            for off in (-0.5, 0.5):
                kit.between(np.array([x, -wide, z]) + lean @ [off * half, 0, -0.06], np.array([x, wide, z]) + lean @ [off * half, 0, -0.06], 0.035, BOX, material=metal)
            for y in np.linspace(-0.85, 0.85, 3):
                kit.between(
                    (x - half * 0.5 * np.cos(np.radians(tilt)), y * wide, 0),
                    (x - half * 0.5 * np.cos(np.radians(tilt)), y * wide, z + drop * 0.5),
                    0.035,
                    BOX,
                    material=metal,
                )
                kit.between(
                    (x + half * 0.5 * np.cos(np.radians(tilt)), y * wide, 0),
                    (x + half * 0.5 * np.cos(np.radians(tilt)), y * wide, z - drop * 0.5),
                    0.035,
                    BOX,
                    material=metal,
                )
    elif kind == "tracker":
        lean, half, wide, tall = turn("y", rng.uniform(25, 65)), rng.uniform(0.9, 1.4), rng.uniform(1.3, 2.0), rng.uniform(1.5, 2.2)
        at, columns, rows = np.array([0, 0, tall]), int(rng.integers(3, 6)), int(rng.integers(2, 4))
        kit.add(CYL, (0, 0, tall / 2), (0.13, 0.13, tall / 2), material=metal)
        kit.add(CYL, (0, 0, 0.06), (0.4, 0.4, 0.07), material=tinted(kit, (CONCRETE,)))
        kit.add(BOX, at, (0.15, 0.2, 0.16), rotation=lean, material=metal)
        kit.between(at - [0, wide * 0.95, 0], at + [0, wide * 0.95, 0], 0.07, material=metal)
        for m in range(columns):
            y = wide * ((2 * m + 1) / columns - 1)
            kit.add(BOX, at + lean @ [0, y, 0.1], (half * 0.95, 0.03, 0.05), rotation=lean, material=metal)
            for r in range(rows):
                kit.add(BOX, at + lean @ [half * ((2 * r + 1) / rows - 1), y, 0.18], (half * 0.97 / rows, wide * 0.97 / columns, 0.025), rotation=lean, material=cells)
    else:
        long, wide, tall = rng.uniform(2, 3.5), rng.uniform(1.2, 1.6), rng.uniform(1.1, 1.5)
        lean = turn("x", rng.uniform(6, 14))
        for x in np.linspace(-0.85, 0.85, int(rng.integers(2, 5))):
            kit.add(BOX, (x * long, 0, tall / 2), (0.09, 0.09, tall / 2), material=metal)
            kit.between((x * long, 0, tall * 0.55), np.array([x * long, 0, tall]) + lean @ [0, wide * 0.8, 0], 0.06, BOX, material=metal)
            kit.add(BOX, (x * long, 0, tall), (0.07, wide * 0.95, 0.05), rotation=lean, material=metal)
        for m in range(7):
            for y in (-0.5, 0.5):
                kit.add(
                    BOX,
                    np.array([long * ((2 * m + 1) / 7 - 1), 0, tall]) + lean @ [0, y * wide, 0.08],
                    (long * 0.975 / 7, wide * 0.49, 0.03),
                    rotation=lean,
                    material=cells,
                )
    if kit.chance(0.4):
        kit.add(BOX, (-0.3, 0, 0.35), (0.15, 0.25, 0.35), material=frame)


def port_crane(kit):
    rng = kit.rng
    paint, dark, house = (
        tinted(kit, (BLUE, RED, WHITE, YELLOW, ORANGE, GREY, GREEN), (PLAIN, PLAIN, STREAKS)),
        kit.material(dark=True),
        tinted(kit, (WHITE, GREY, BLUE, RED), (PLAIN, WRITING)),
    )
    base, wide, portal, high = rng.uniform(0.9, 1.2), rng.uniform(0.7, 0.9), rng.uniform(0.9, 1.3), rng.uniform(2.6, 3.4)
    out, back, apex = rng.uniform(2.8, 3.8), rng.uniform(0.9, 1.5), high + rng.uniform(1.2, 1.7)
    for x in (-base, base):
        kit.between((x, wide, 0.2), (x, wide * (0.75 if x > 0 else 1), high), (0.1, 0.09), BOX, material=paint, mirror=True)
        kit.between((x, -wide, 0.35), (x, wide, 0.35), (0.12, 0.1), BOX, material=paint)
        kit.add(BOX, (x, wide * 0.9, 0.12), (0.09, 0.28, 0.12), material=dark, mirror=True)
        kit.between((x, -wide, portal), (x, wide, portal), (0.08, 0.07), BOX, material=paint)
        kit.between((x, -wide, high - 0.05), (x, wide, high - 0.05), (0.1, 0.08), BOX, material=paint)
    kit.between((-base, wide, portal), (base, wide, portal), (0.1, 0.09), BOX, material=paint, mirror=True)
    kit.between((-base, wide, portal), (base, wide * 0.8, high * 0.93), 0.06, material=paint, mirror=True)
    lift = rng.choice([0, 0, 0, rng.uniform(35, 75)])
    hinge, aim = np.array([base + 0.15, 0, high + 0.1]), np.array([np.cos(np.radians(lift)), 0, np.sin(np.radians(lift))])
    tip, gauge = hinge + aim * out, 0.22
    kit.between((-base - back, gauge, high + 0.1), hinge + [0, gauge, 0], (0.12, 0.06), BOX, material=paint, mirror=True)
    kit.between(hinge + [0, gauge, 0], tip + [0, gauge, 0], (0.12, 0.06), BOX, 0.8, material=paint, mirror=True)
    for at in (tip, hinge + aim * out * 0.5, np.array([-base - back, 0, high + 0.1])):
        kit.add(BOX, at, (0.07, gauge, 0.08), material=paint)
    top = np.array([base * 0.8, 0, apex])
    kit.between((base, wide * 0.75, high), top + [0, 0.12, 0], (0.07, 0.06), BOX, material=paint, mirror=True)
    kit.between((-base, gauge, high), top + [0, 0.12, 0], 0.045, material=paint, mirror=True)
    kit.add(BOX, top, (0.12, 0.2, 0.1), material=paint)
    for share in (0.5, 0.92):
        kit.between(top + [0, 0.1, 0], hinge + aim * out * share + [0, gauge, 0], 0.025, material=paint, mirror=True)
    kit.add(BOX, (-base - back * 0.45, 0, high + 0.5), (back * 0.45, 0.4, 0.28), material=house)
    spot = rng.uniform(0.1, 0.8) * out if lift == 0 else -rng.uniform(0.2, 0.8) * base
    at = np.array([base + spot, 0, high])
    kit.add(BOX, at, (0.18, 0.24, 0.08), material=dark)
    kit.add(BOX, at + [-0.38, 0, -0.2], (0.14, 0.14, 0.16), material=glazing(kit))
    kit.add(BOX, at + [-0.3, 0, -0.02], (0.25, 0.15, 0.04), material=paint)
    drop = rng.uniform(0.6, 1.5)
    kit.between(at + [0, 0.15, 0], at + [0, 0.15, -drop], 0.012, material=dark, mirror=True)
    kit.add(BOX, at - [0, 0, drop], (0.1, 0.4, 0.04), material=tinted(kit, (YELLOW,)))
    if kit.chance(0.5):
        kit.add(BOX, at - [0, 0, drop + 0.18], (0.12, 0.42, 0.15), material=tinted(kit, (RED, BLUE, GREEN, ORANGE, WHITE), (RIBS,)))
    stairs(kit, (-base - 0.9, -wide * 0.9, 0.05), (-base - 0.05, -wide * 0.9, portal), 0.1, dark)
    kit.between((-base, -wide * 1.1, portal), (-base, -wide * 1.1, high), 0.1, BOX, material=dark, cut=(LATTICE, 4, 0.25))


def yard_crane(kit):
    rng = kit.rng
    paint, dark, house = (
        tinted(kit, (YELLOW, BLUE, RED, WHITE, ORANGE, GREEN), (PLAIN, PLAIN, STRIPES)),
        kit.material(dark=True),
        tinted(kit, (WHITE, GREY, BLUE), (PLAIN, WRITING)),
    )
    span, long, high = rng.uniform(1.4, 2.6), rng.uniform(0.6, 1.0), rng.uniform(1.8, 2.8)
    tyres, over = kit.chance(0.5), rng.choice([0, 0, rng.uniform(0.4, 0.9)])
    foot, lattice = 0.35, kit.chance(0.35)
    for y in (-span, span):
        kit.between((-long * 1.15, y, foot), (long * 1.15, y, foot), (0.1, 0.1), BOX, material=paint)
        for x in (-long, long):
            if tyres:
                kit.add(CYL, (x, y, 0.2), (0.2, 0.2, 0.1), rotation=ALONG_Y, material=dark)
            else:
                kit.add(BOX, (x, y, 0.13), (0.22, 0.08, 0.13), material=dark)
            kit.add(BOX, (x, y, 0.3), (0.1, 0.12, 0.1), material=paint)
            kit.between((x, y, foot), (x * (0.75 if not tyres else 1), y, high), (0.1, 0.09), BOX, material=paint)
        kit.between((-long, y, high), (long, y, high), (0.08, 0.08), BOX, material=paint)
    for x in (-long * 0.72, long * 0.72):
        kit.add(BOX, (x, 0, high + 0.15), (0.08, span + over + 0.1, 0.17), material=paint, cut=(LATTICE, 2.5, 0.3) if lattice else (0, 1.0, 1.0))
        if lattice:
            for z in (0, 0.3):
                kit.add(BOX, (x, 0, high + z), (0.09, span + over + 0.1, 0.03), material=paint)
    for y in (-1, 1):
        kit.add(BOX, (0, y * (span + over), high + 0.15), (long * 0.72, 0.06, 0.12), material=paint)
    at = np.array([0, rng.uniform(-0.7, 0.7) * span, high + 0.4])
    kit.add(BOX, at, (long * 0.8, 0.3, 0.08), material=dark)
    kit.add(BOX, at + [0, 0, 0.22], (long * 0.5, 0.25, 0.16), material=house)
    kit.add(BOX, at + [long * 0.3, 0.35, -0.55], (0.18, 0.18, 0.2), material=glazing(kit))
    kit.add(BOX, at + [long * 0.3, 0.35, -0.15], (0.08, 0.05, 0.25), material=paint)
    drop = rng.uniform(0.6, high * 0.6)
    for x in (-0.3, 0.3):
        kit.between(at + [x, 0, 0], at + [x, 0, -drop], 0.014, material=dark)
    kit.add(BOX, at - [0, 0, drop], (long * 0.55, 0.16, 0.05), material=tinted(kit, (YELLOW,)))
    if kit.chance(0.6):
        kit.add(BOX, at - [0, 0, drop + 0.24], (long * 0.58, 0.2, 0.2), material=tinted(kit, (RED, BLUE, GREEN, ORANGE, WHITE), (RIBS,)))
    kit.add(BOX, (0, span * 1.0, foot + 0.3), (long * 0.4, 0.13, 0.2), material=house)
    ladder(kit, (long * 1.0 + 0.12, -span, foot), (long * (0.75 if not tyres else 1) + 0.12, -span, high), 0.08, dark)
    if kit.chance(0.5):
        kit.railing((long * 0.82, -span, high + 0.3), (long * 0.82, span, high + 0.3), 0.2, dark)


def conveyor(kit):
    rng = kit.rng
    paint, dark, heap = steelwork(kit), kit.material(dark=True), tinted(kit, (EARTH, SAND, BLACK, GREY, STONE), (CLOUDY,), gloss=0.0)
    long, high = rng.uniform(3.5, 5), rng.uniform(1.6, 2.6)
    start, tip = np.array([-long, 0, 0.55]), np.array([0, 0, high])
    along = (tip - start) / np.linalg.norm(tip - start)
    up = np.array([-along[2], 0, along[0]])
    for y in (-0.24, 0.24):
        kit.between(start + [0, y, 0], tip + [0, y, 0], (0.16, 0.02), BOX, material=paint, cut=(LATTICE, 2.2, 0.3))
        kit.between(start + [0, y, 0] + up * 0.16, tip + [0, y, 0] + up * 0.16, 0.035, BOX, material=paint)
        kit.between(start + [0, y, 0] - up * 0.16, tip + [0, y, 0] - up * 0.16, 0.035, BOX, material=paint)
    kit.between(start + up * 0.2, tip + up * 0.2, (0.03, 0.22), BOX, material=dark)
    if kit.chance(0.35):
        kit.between(start + up * 0.32 + along * 0.8, tip + up * 0.32 - along * 0.3, (0.13, 0.26), BOX, material=tinted(kit, (GREY, WHITE, BLUE), (RIBS,)))
    for end in (start, tip):
        kit.add(CYL, end + up * 0.08, (0.17, 0.17, 0.27), rotation=ALONG_Y, material=dark)
    for share in (0.45, 0.8):
        at = start + (tip - start) * share
        for x in (-0.25, 0.25):
            kit.between((at[0] + x * share, 0.55, 0.05), at + [0, 0.22, -0.1], 0.05, BOX, material=paint, mirror=True)
        kit.between((at[0], -0.45, at[2] * 0.4), (at[0], 0.45, at[2] * 0.4), 0.035, BOX, material=paint)
    if kit.chance(0.5):
        at = start + (tip - start) * 0.45
        wheel(kit, (at[0], 0.6, 0.25), 0.25, 0.09, dark, paint)
    kit.add(BOX, start + [0.1, 0, 0.75], (0.3, 0.3, 0.4), (1.9, 1.7), material=paint)
    kit.add(BOX, start + [0.1, 0, 1.17], (0.5, 0.45, 0.03), material=heap)
    for corner in corners(0.5, 0.4, 0, start[0] + 0.1):
        kit.between(corner, corner + [0, 0, 1.1], 0.045, BOX, material=paint)
    size = rng.uniform(1.0, 1.5)
    tall = min(size * rng.uniform(0.6, 0.75), high - 0.35)
    for x, y, k in ((0.2, 0, 1), (0.2 + size * rng.uniform(0.3, 0.8), rng.uniform(-0.6, 0.6), rng.uniform(0.4, 0.75))):
        kit.loft((x, y, 0), [(0, size * k), (tall * k * 0.85, size * k * 0.2), (tall * k, 0.03)], heap)
    kit.between((0.1, 0, high), (0.2, 0, tall * 0.95), (0.03, 0.12), BOX, material=heap)


def water_tower(kit):
    rng = kit.rng
    white = tinted(kit, (WHITE, (0.35, 0.5, 0.6), (0.4, 0.55, 0.45), GREY, SAND), (PLAIN, PLAIN, WRITING, STREAKS), gloss=0.3)
    metal, concrete = tinted(kit, (WHITE, GREY, BLACK, GREEN, RED)), tinted(kit, (CONCRETE, STONE, WHITE), (STREAKS, CLOUDY, RIBS, PLAIN))
    band = tinted(kit, (RED, BLUE, GREEN, ORANGE, WHITE), (PLAIN, WRITING))
    kind = rng.choice(["bulb", "legs", "mushroom", "wood"])
    tall, radius = rng.uniform(2.6, 4.2), rng.uniform(0.8, 1.2)
    if kind == "bulb":
        thin, flat = radius * rng.uniform(0.2, 0.35), rng.uniform(0.65, 0.95)
        kit.loft((0, 0, 0), [(0, thin * 2.2), (0.5, thin * 1.25), (0.9, thin), (tall - radius * 0.6, thin), (tall + 0.05, thin * 2)], white)
        kit.add(BALL, (0, 0, tall + radius * flat * 0.85), (radius, radius, radius * flat), material=white)
        if kit.chance(0.6):
            kit.add(CYL, (0, 0, tall + radius * flat * 0.85), (radius * 1.005, radius * 1.005, radius * flat * 0.13), material=band)
        top = tall + radius * flat * 1.85
        kit.add(CYL, (0, 0, top), (0.12, 0.12, 0.08), material=metal)
        kit.add(BOX, (thin * 1.7, 0, 0.22), (0.06, 0.12, 0.22), material=metal)
    elif kind == "legs":
        legs, body = int(rng.choice([4, 6, 8])), rng.uniform(0.6, 1.1)
        feet = [np.array([x, y, 0]) for x, y in around(legs, radius * 1.35, 45)]
        heads = [np.array([x, y, tall + 0.1]) for x, y in around(legs, radius * 0.95, 45)]
        trestle(kit, feet, heads, 0.055, metal, 2, legs == 4, CYL)
        kit.add(CYL, (0, 0, tall / 2), (0.16, 0.16, tall / 2), material=metal)
        kit.add(BALL, (0, 0, tall + 0.1), (radius, radius, radius * 0.5), material=white)
        kit.add(CYL, (0, 0, tall + 0.1 + body / 2), (radius, radius, body / 2), material=white)
        if kit.chance(0.5):
            kit.add(CYL, (0, 0, tall + 0.1 + body * 0.55), (radius * 1.01, radius * 1.01, body * 0.2), material=band)
        top = tall + 0.1 + body
        if kit.chance(0.5):
            kit.add(BALL, (0, 0, top), (radius, radius, radius * 0.45), material=white)
            top += radius * 0.45
        else:
            kit.add(CYL, (0, 0, top + radius * 0.22), (radius * 1.06, radius * 1.06, radius * 0.24), (0.04, 1), material=white if kit.chance(0.5) else band)
            top += radius * 0.46
        stage(kit, 0, 0, tall + 0.1, radius * 1.15, metal)
        kit.add(CYL, (0, 0, top), (0.08, 0.08, 0.1), material=metal)
    elif kind == "mushroom":
        thin, cup = radius * rng.uniform(0.25, 0.4), rng.uniform(0.6, 1.2)
        kit.loft((0, 0, 0), [(0, thin * 1.15), (tall, thin), (tall + cup, radius * 1.25), (tall + cup + 0.25, radius * 1.25), (tall + cup + 0.4, radius * 0.2)], concrete)
        for x, y in around(int(rng.choice([0, 6, 8])), thin, 0):
            kit.add(BOX, (x, y, tall / 2), (0.06, 0.06, tall / 2), material=concrete)
        kit.add(TUBE, (0, 0, tall + cup + 0.12), (radius * 1.26, radius * 1.26, 0.06), material=kit.material(dark=True))
        kit.between((0, 0, tall + cup + 0.3), (0, 0, tall + cup + 0.9), 0.03, material=metal)
        kit.add(BOX, (thin, 0, 0.25), (0.12, 0.15, 0.25), material=metal)
    else:
        wood, body = tinted(kit, (WOOD, GREY), (PLANKS, STRIPES), frequency=rng.uniform(15, 30)), rng.uniform(1.0, 1.6)
        tall *= 0.6
        trestle(kit, corners(radius * 0.9, radius * 0.9, 0), corners(radius * 0.75, radius * 0.75, tall), 0.07, tinted(kit, (WOOD, GREY, RUST)), 1, True)
        kit.add(BOX, (0, 0, tall), (radius * 1.05, radius * 1.05, 0.07), material=wood)
        kit.add(CYL, (0, 0, tall + 0.07 + body / 2), (radius, radius, body / 2), (rng.uniform(0.9, 1), 1), material=wood)
        for share in (0.1, 0.35, 0.6, 0.88):
            kit.add(TUBE, (0, 0, tall + 0.07 + body * share), (radius * 1.015, radius * 1.015, 0.025), material=metal)
        kit.add(
            CYL,
            (0, 0, tall + 0.07 + body + radius * 0.28),
            (radius * 1.08, radius * 1.08, radius * 0.28),
            (0.03, 1),
            material=tinted(kit, (SLATE, WOOD, RUST, GREY), (SHINGLES, PLAIN)),
        )
        ladder(kit, (radius * 1.05, 0, 0), (radius * 1.05, 0, tall + body), 0.12, metal)


def column(kit):
    rng = kit.rng
    skin, metal, dark = (
        tinted(kit, (GREY, WHITE, (0.55, 0.55, 0.58)), (PLAIN, SEAMS, STREAKS, BANDS), gloss=0.4),
        tinted(kit, (GREY, YELLOW, RED, BLUE)),
        kit.material(dark=True),
    )
    x = 0.0
    kit.add(BOX, (0.9, 0, 0.05), (1.9, 0.95, 0.05), material=tinted(kit, (CONCRETE,), (CLOUDY,)))
    for k in range(int(rng.integers(1, 4))):
        tall, radius = rng.uniform(2.8, 5) * (1 if k == 0 else 0.75), rng.uniform(0.2, 0.4)
        thin = radius * rng.choice([1, 0.75])
        kit.loft((x, 0, 0.1), [(0, radius * 1.25), (0.35, radius), (tall * 0.5, radius), (tall * 0.56, thin), (tall, thin)], skin)
        kit.add(BALL, (x, 0, 0.1 + tall), (thin, thin, thin * 0.7), material=skin)
        for share in np.sort(rng.uniform(0.25, 0.95, 3)):
            around_it = radius if share < 0.53 else thin
            stage(kit, x, 0, 0.1 + tall * share, around_it + 0.18, metal, 0.16)
        ladder(kit, (x + radius + 0.1, 0, 0.1), (x + thin + 0.1, 0, tall), 0.09, metal)
        kit.between((x, 0, tall + 0.1), (x, 0, tall + 0.1 + thin + 0.2), 0.06, material=metal)
        kit.between((x, 0, tall + thin + 0.27), (x, radius + 0.15, tall + thin + 0.27), 0.06, material=metal)
        kit.between((x, radius + 0.15, tall + thin + 0.3), (x, radius + 0.15, 0.7), 0.05, material=metal)
        kit.between((x, radius + 0.15, 0.7), (x + 0.9, radius + 0.15, 0.7), 0.05, material=metal)
        x += radius + rng.uniform(0.7, 0.9)
    for z in (0.45, 1.0)[: int(rng.integers(1, 3))]:
        kit.add(CYL, (0.9, -0.65, z), (0.2, 0.2, 0.7), rotation=ALONG_X, material=skin)
        for side in (0.25, 1.55):
            kit.add(BALL, (side, -0.65, z), (0.14, 0.2, 0.2), material=skin)
            kit.add(BOX, (0.9 + (side - 0.9) * 0.6, -0.65, z - 0.2), (0.07, 0.15, 0.2), material=dark)
    kit.between((0, 0.5, 0.7), (2.2, 0.5, 0.7), 0.06, material=metal)
    for px in (0.1, 1.1, 2.1):
        kit.add(BOX, (px, 0.55, 0.35), (0.05, 0.2, 0.35), material=dark)


def observatory(kit):
    rng = kit.rng
    white, wall, dark = tinted(kit, (WHITE, WHITE, (0.6, 0.6, 0.62), COPPER), (PLAIN, SEAMS), gloss=0.35), walling(kit), kit.material(dark=True)
    radius, drum = rng.uniform(0.8, 1.3), rng.uniform(0.6, 1.8)
    if kit.chance(0.6):
        kit.loft((0, 0, 0), [(0, radius * 1.03), (drum, radius * 0.97)], wall)
    else:
        kit.add(PRISM, (0, 0, drum / 2), (radius, radius, drum / 2), (1, 8), material=wall)
    kit.add(CYL, (0, 0, drum), (radius * 1.06, radius * 1.06, 0.07), material=white)
    if drum + 0.05 > radius:
        kit.add(BALL, (0, 0, drum + 0.05), (radius, radius, radius), material=white)
    else:
        kit.loft((0, 0, drum + 0.05), [(radius * np.sin(a), radius * np.cos(a)) for a in np.linspace(0, np.pi / 2, 7)], white)
    yaw = turn("z", rng.choice([0, 0, 0, rng.uniform(-40, 40)]))
    slit, opened = rng.uniform(0.13, 0.2) * radius, kit.chance(0.7)
    for angle in np.linspace(12, 92, 6):
        spin = yaw @ turn("y", -angle)
        at = np.array([0, 0, drum + 0.05])
        kit.add(BOX, at + spin @ [radius * 0.985, 0, 0], (0.03 * radius, slit, radius * 0.16), rotation=spin, material=dark if opened else white)
        for side in (-1, 1):
            kit.add(
                BOX,
                at + spin @ [radius * 0.99, side * (slit + (0.12 if opened else 0.03) * radius), 0],
                (0.045 * radius, radius * (0.12 if opened else 0.025), radius * 0.16),
                rotation=spin,
                material=white,
            )
    if opened:
        aim = yaw @ turn("y", 90 - rng.uniform(25, 65))
        kit.add(
            CYL, aim @ [0, 0, radius * 0.65] + [0, 0, drum + 0.05], (slit * 0.75, slit * 0.75, radius * 0.5), rotation=aim, material=dark if kit.chance(0.4) else wall
        )
    if kit.chance(0.5):
        kit.add(TUBE, (0, 0, drum + 0.02), (radius * 1.28, radius * 1.28, 0.14), material=tinted(kit, (GREY, WHITE)), cut=(BARS, 26, 0.25))
        kit.add(CYL, (0, 0, drum - 0.12), (radius * 1.28, radius * 1.28, 0.04), material=wall)
    for x, y in around(6, radius, 30):
        if drum > 0.9:
            kit.add(BOX, (x * 0.99, y * 0.99, drum * 0.55), (0.05, 0.1, 0.16), rotation=turn("z", np.degrees(np.arctan2(y, x))), material=dark)
    if kit.chance(0.6):
        long, wide, high = rng.uniform(0.6, 1.3), radius * rng.uniform(0.5, 0.9), drum * rng.uniform(0.6, 0.95)
        kit.add(BOX, (-radius - long * 0.6, 0, high / 2), (long, wide, high / 2), material=wall)
        kit.add(BOX, (-radius - long * 0.6, 0, high), (long * 1.04, wide * 1.06, 0.05), material=white)
        kit.add(BOX, (-radius - long * 0.8, 0, high * 0.55), (long * 0.6, wide * 1.01, high * 0.15), material=dark)
    kit.add(BOX, (radius * 1.0, 0, 0.25), (0.05, 0.16, 0.25), material=dark)


def radome(kit):
    rng = kit.rng
    white = tinted(kit, (WHITE, WHITE, (0.6, 0.65, 0.7), GREY), (PATCHWORK, SEAMS, PLAIN, PATCHWORK), frequency=rng.uniform(3, 9), gloss=0.25)
    white = white._replace(second=np.clip(white.first * rng.uniform(0.75, 0.92), 0.01, 0.99))
    metal, wall, radius = steelwork(kit), walling(kit), rng.uniform(0.7, 1.1)
    kind = rng.choice(["lattice", "drum", "block"])
    tall = rng.uniform(1.2, 3.2) if kind == "lattice" else rng.uniform(0.4, 2)
    if kind == "lattice":
        half = radius * rng.uniform(0.7, 1.0)
        lattice_tower(kit, (0, 0, 0), half, half * 0.75, tall, metal)
        for foot, head in zip(corners(half, half, 0), corners(half * 0.75, half * 0.75, tall), strict=True):
            kit.between(foot, head, 0.06, BOX, material=metal)
        kit.add(BOX, (0, 0, tall), (radius * 1.05, radius * 1.05, 0.06), material=metal)
        railed(kit, 0, 0, tall + 0.05, radius * 1.05, radius * 1.05, 0.25, metal)
        kit.add(BOX, (half * 0.2, half * 2, 0.3), (0.5, 0.35, 0.3), material=wall)
        ladder(kit, (half + 0.05, 0, 0), (half * 0.75 + 0.05, 0, tall), 0.12, metal)
    elif kind == "drum":
        kit.loft((0, 0, 0), [(0, radius * 0.8), (tall, radius * 0.72)], wall)
        stage(kit, 0, 0, tall, radius * 1.1, metal)
    else:
        kit.add(BOX, (-0.2, 0, tall / 2), (radius * 1.4, radius * 1.1, tall / 2), material=wall)
        kit.add(BOX, (-0.2, 0, tall), (radius * 1.44, radius * 1.14, 0.05), material=wall)
        kit.add(BOX, (-0.2, 0, tall * 0.6), (radius * 1.41, radius * 0.7, tall * 0.12), material=glazing(kit))
        railed(kit, -0.2, 0, tall + 0.05, radius * 1.4, radius * 1.1, 0.2, metal)
    kit.add(CYL, (0, 0, tall + radius * 0.15), (radius * 0.72, radius * 0.72, radius * 0.16), material=metal if kit.chance(0.5) else white)
    if kit.chance(0.4):  # flat facets
        for sides, low, high in ((10, -0.75, -0.35), (10, -0.35, 0.15), (10, 0.15, 0.6), (10, 0.6, 0.9), (10, 0.9, 0.995)):
            below, above = np.sqrt(1 - low**2), np.sqrt(1 - high**2)
            at = tall + radius * (0.9 + (low + high) / 2)
            kit.add(PRISM, (0, 0, at), (radius * below, radius * below, radius * (high - low) / 2), (above / below, sides), material=white)
    else:
        kit.add(BALL, (0, 0, tall + radius * 0.9), (radius, radius, radius), material=white)
    kit.between((0, 0, tall + radius * 1.85), (0, 0, tall + radius * 2.15), 0.02, material=metal)
    kit.add(BOX, (radius * 0.8, 0, 0.25), (0.1, 0.15, 0.25), material=kit.material(dark=True))
