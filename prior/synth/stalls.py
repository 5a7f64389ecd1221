"""Market stalls, food stands and kiosks; and what stands at fairs and shows: stands with seats, stages, carousels, swing boats."""

import numpy as np

from .building_parts import barrel, flight, lettered, paving, posts, slab, striped, timberwork, vivid
from .dwellings import BLUE, CONCRETE, COPPER, CREAM, GOLD, GREEN, GREY, OCHRE, RED, SLATE, TIMBER, WHITE, WOOD, YELLOW, leaves, panes, row
from .installations import steelwork, tinted
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, LATTICE, PRISM
from .materials import BANDS, CHECKER, DOTS, PLAIN, PLANKS, SPECKLES, STRIPES, WRITING


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
        leaves(
            kit,
            (0, 0, high),
            np.eye(3) if kind == "cross" else turn("z", 90),
            *((x + 0.2, (y + 0.25, -0.1)) if kind == "cross" else (y + 0.2, (x + 0.3, -0.1))),
            (0, 0.6),
            0.025,
            cloth,
        )
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
            kit.add(
                BOX, spin @ np.array([flat - 0.08, r * (0.26 * k - 0.26), 1.35]), (0.03, r * 0.11, 0.17), rotation=spin, material=vivid(kit, (WRITING, PLAIN), frequency=24)
            )
    back = turn("z", 180 + 180 / sides)
    kit.add(BOX, back @ np.array([flat, 0, 1.1]), (0.04, r * 0.3, 0.95), rotation=back, material=wall)


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
            kit.add(
                BOX,
                (back * (k + 0.5) / 3, side * (y - 0.1), (base + (top - base) * (k + 0.5) / 3) / 2),
                (-back / 6, 0.1, (base + (top - base) * (k + 0.5) / 3) / 2),
                material=concrete,
            )
    high = top + rng.uniform(2.0, 2.8)
    kit.add(BOX, (back - 0.1, 0, (top + 1) / 2), (0.1, y, (top + 1) / 2), material=cover)
    spots = np.linspace(-y * 0.94, y * 0.94, int(rng.integers(4, 6)))
    for py in spots:
        kit.between((back - 0.15, py, 0), (back - 0.15, py, high + 0.6), (0.16, 0.12), BOX, material=steel)
        kit.between((back - 0.15, py, high + 0.55), (0.3, py, high + 0.12), 0.08, BOX, material=steel)
    kit.between((back - 0.6, 0, high - 0.25), (0.9, 0, high + 0.05), (0.06, y * 1.02), BOX, material=cover)
    for py in row(3, y, 0.9):
        kit.add(
            BOX,
            (-deep * rows * 0.5, py, base + up * rows * 0.5 + 0.12),
            (-back / 2 * 1.05, 0.22, 0.12),
            rotation=turn("y", np.degrees(np.arctan2(up, deep))),
            material=concrete,
        )
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
