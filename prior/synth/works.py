"""Makers of works and barriers: chimneys, cooling towers, tank farms, columns of refineries, substations; walls, obstacles, check points, stacks."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, TUBE
from .materials import BRICKS, CLOUDY, LEDGES, PLAIN, PLANKS, RIBS, SEAMS, STREAKS, STRIPES
from .wheeled import coat, glazing


def works(kit):
    """Sheds with chimneys, cooling towers, groups of tanks or columns with pipes and stairs, transformers behind a fence."""
    rng = kit.rng
    wall = kit.material(pattern=rng.choice([PLAIN, BRICKS, RIBS, SEAMS, LEDGES]))
    steel, dark = kit.material(base=rng.uniform(0.15, 0.8) * np.ones(3), pattern=rng.choice([PLAIN, STREAKS, SEAMS])), kit.material(dark=True)
    kind = rng.choice(["mill", "cooling", "tanks", "columns", "substation"])
    if kind == "mill":
        long, wide, high = rng.uniform(1.2, 2.4), rng.uniform(0.7, 1.3), rng.uniform(0.5, 1.1)
        kit.add(BOX, (0, 0, high), (long, wide, high), material=wall)
        bays = int(rng.integers(2, 6))
        pitch, roof = long / bays, kit.material(pattern=RIBS)
        shift = -pitch * 0.95 if kit.chance(0.5) else 0  # saw teeth or gables
        for k in range(bays):
            x = -long + pitch * (2 * k + 1)
            kit.add(BOX, (x, 0, 2 * high + 0.2), (pitch, wide, 0.2), (0.05, 1), (shift, 0), material=roof)
        for x in np.linspace(-0.8, 0.8, int(rng.integers(3, 7))):
            kit.add(BOX, (x * long, wide, high * rng.uniform(1.0, 1.3)), (0.12, 0.02, high * 0.3), material=dark, mirror=True)
        kit.add(BOX, (long, 0, high * 0.5), (0.03, wide * 0.3, high * 0.5), material=steel)
        for _ in range(int(rng.integers(1, 4))):
            at, tall, thick = (rng.uniform(-1, 1) * long, rng.choice([-1, 1]) * wide * rng.uniform(0.3, 1.25), 0), rng.uniform(2, 4.5), rng.uniform(0.1, 0.25)
            kit.add(CYL, (at[0], at[1], tall / 2), (thick, thick, tall / 2), (rng.uniform(0.55, 1), 1), material=kit.material(pattern=rng.choice([BRICKS, STRIPES, PLAIN])))
            kit.add(CYL, (at[0], at[1], tall), (thick * 0.8, thick * 0.8, 0.06), material=dark)
    elif kind == "cooling":
        for k in range(int(rng.integers(1, 4))):
            radius, tall = rng.uniform(0.6, 0.9), rng.uniform(1.6, 2.4)
            x = k * 2.1
            waist = rng.uniform(0.55, 0.7)
            kit.loft((x, 0, 0.12), [(0, radius), (tall * 0.25, radius * (waist + 0.2)), (tall * 0.5, radius * (waist + 0.05)), (tall * 0.75, radius * waist), (tall, radius * (waist + 0.08))], wall)
            kit.add(CYL, (x, 0, tall + 0.12), (radius * waist, radius * waist, 0.02), material=dark)
            for px, py in around(8, radius * 1.0):
                kit.between((x + px, py, 0), (x + px * 0.97, py * 0.97, 0.16), 0.03, material=wall)
        if kit.chance(0.6):
            kit.add(BOX, (0, 1.6, 0.4), (0.8, 0.4, 0.4), material=steel)
    elif kind == "tanks":
        count = int(rng.integers(2, 6))
        ball = kit.chance(0.3)
        for k in range(count):
            x, y = 1.5 * (k // 2), 1.5 * (k % 2)
            radius, tall = rng.uniform(0.45, 0.68), rng.uniform(0.6, 1.8)
            if ball:
                kit.add(BALL, (x, y, 1.05), (0.6, 0.6, 0.6), material=steel)
                for px, py in around(5, 0.55):
                    kit.between((x + px, y + py, 0), (x + px * 0.9, y + py * 0.9, 1.0), 0.03, material=steel)
            else:
                kit.add(CYL, (x, y, tall / 2), (radius, radius, tall / 2), material=steel if kit.chance(0.7) else wall)
                kit.add(CYL, (x, y, tall + 0.06), (radius, radius, 0.07), (rng.uniform(0.05, 0.9), 1), material=steel)
                kit.add(TUBE, (x, y, tall + 0.15), (radius, radius, 0.12), material=dark, cut=(BARS, 30, 0.15))
                kit.between((x + radius, y, 0), (x + radius * 0.3, y + radius * 0.95, tall), (0.04, 0.02), BOX, material=dark)
        for y in (0, 1.5):
            kit.between((-0.8, y + 0.2, 0.2), (1.5 * (count // 2), y + 0.2, 0.2), 0.05, material=dark)
        kit.add(BOX, (0.75, 0.75, 0.04), (1.9, 1.5, 0.04), material=wall)
    elif kind == "columns":
        kit.add(BOX, (0, 0, 0.05), (1.8, 1.0, 0.05), material=wall)
        for x in np.linspace(-1.3, 1.3, int(rng.integers(2, 5))):
            y, tall, thick = rng.uniform(-0.5, 0.5), rng.uniform(1.2, 3.6), rng.uniform(0.12, 0.32)
            kit.loft((x, y, 0.1), [(0, thick), (tall * 0.55, thick), (tall * 0.6, thick * 0.75), (tall, thick * 0.75), (tall + 0.1, 0.05)], steel)
            for share in rng.uniform(0.3, 0.95, 2):
                kit.add(CYL, (x, y, tall * share), (thick + 0.14, thick + 0.14, 0.015), material=dark)
                kit.add(TUBE, (x, y, tall * share + 0.1), (thick + 0.14, thick + 0.14, 0.1), material=dark, cut=(BARS, 40, 0.2))
            kit.between((x, y, tall + 0.1), (x + 0.5, y + 0.3, tall * 0.5), 0.03, material=steel)
        for y in (-0.6, 0.6):
            kit.add(CYL, (rng.uniform(-0.5, 0.5), y, 0.45), (0.25, 0.25, 0.6), rotation=ALONG_X, material=steel)
        for x in (-1.4, 0, 1.4):
            kit.between((x, 0.8, 0), (x, 0.8, 0.9), 0.04, BOX, material=dark)
        for z in (0.8, 0.9):
            kit.between((-1.7, 0.8, z), (1.7, 0.8, z), 0.04, material=steel)
    else:
        for x in np.linspace(-1, 1, int(rng.integers(1, 4))):
            kit.add(BOX, (x, 0, 0.4), (0.3, 0.4, 0.4), material=coat(kit))
            kit.add(BOX, (x + 0.36, 0, 0.35), (0.06, 0.34, 0.28), material=steel, cut=(BARS, 12, 0.5))
            kit.add(CYL, (x - 0.1, 0, 1.15), (0.12, 0.12, 0.35), rotation=ALONG_Y, material=steel)
            for y in (-0.22, 0, 0.22):
                kit.loft((x + 0.05, y, 0.8), [(0, 0.06), (0.12, 0.04), (0.13, 0.07), (0.28, 0.04), (0.42, 0.02)], wall)
        for y in (-0.9, 0.9):
            kit.between((-1.7, y, 0), (-1.7, y, 2.2), 0.05, BOX, material=steel)
        kit.between((-1.7, -1.0, 2.1), (-1.7, 1.0, 2.1), 0.05, BOX, material=steel)
        for side in ((-2, -1.3, 2, -1.3), (-2, 1.3, 2, 1.3), (2, -1.3, 2, 1.3)):
            if kit.chance(0.7):
                kit.railing((side[0], side[1], 0), (side[2], side[3], 0), 0.7, dark, 0.1, GRID)


def barrier(kit):
    """Concrete barriers, sandbag walls, beam obstacles, pyramids, check points with a boom, stacks of tyres, crates, pipes and logs."""
    rng = kit.rng
    stone = kit.material(base=rng.uniform(0.2, 0.8) * np.array([1, 0.97, 0.9]), pattern=rng.choice([PLAIN, CLOUDY, STREAKS]))
    steel, dark = kit.material(), kit.material(dark=True)
    kind = rng.choice(["profile", "bags", "beams", "teeth", "post", "stack"])
    if kind == "profile":
        for k in range(int(rng.integers(1, 4))):
            x, stripe = k * 2.02, kit.chance(0.4)
            kit.add(BOX, (x, 0, 0.12), (1, 0.32, 0.12), material=stone)
            kit.add(BOX, (x, 0, 0.34), (1, 0.3, 0.1), (1, 0.55), material=stone)
            kit.add(BOX, (x, 0, 0.68), (1, 0.16, 0.24), (1, 0.75), material=kit.material(pattern=STRIPES, frequency=6) if stripe else stone)
    elif kind == "bags":
        sand = kit.material(base=np.array([0.42, 0.35, 0.22]) * rng.uniform(0.5, 1.6), pattern=CLOUDY)
        rows, bags, bend = int(rng.integers(2, 5)), int(rng.integers(4, 9)), rng.uniform(0, 0.5)
        for row in range(rows):
            for k in range(bags):
                t = (k + 0.5 * (row % 2)) - bags / 2
                angle = bend * t
                at = (0.55 * np.sin(angle) / max(bend, 0.05), 0.55 * (1 - np.cos(angle)) / max(bend, 0.05), 0.12 + 0.2 * row)
                kit.add(BALL, at, (0.3, 0.18, 0.12), rotation=turn("z", np.degrees(angle) + rng.normal(0, 4)), material=sand)
    elif kind == "beams":
        for k in range(int(rng.integers(1, 4))):
            base = np.array([1.9 * k, rng.uniform(-0.2, 0.2), 0.62])
            spin = turn("z", rng.uniform(0, 90))
            for way in ((1, 1, 1), (1, -1, -1), (-1, 1, -1)):
                out = spin @ np.array(way) * 0.52
                kit.between(base - out, base + out, (0.09, 0.07), BOX, material=steel)
    elif kind == "teeth":
        for k in range(int(rng.integers(2, 7))):
            at = (0.95 * (k // 2), 0.95 * (k % 2) + 0.45 * ((k // 2) % 2), 0.35)
            kit.add(BOX, at, (0.36, 0.36, 0.35), (rng.uniform(0.1, 0.5),) * 2, material=stone)
            kit.add(BOX, (at[0], at[1], 0.04), (0.44, 0.44, 0.05), material=stone)
    elif kind == "post":
        booth = rng.uniform(0.9, 1.2)
        wall = kit.material(pattern=rng.choice([PLAIN, PLANKS, RIBS, STRIPES]))
        kit.add(BOX, (0, 0, booth), (0.6, 0.6, booth), material=wall)
        for spin in (0, 90, 180, 270):
            out = turn("z", spin)
            kit.add(BOX, out @ np.array([0.6, 0, booth * 1.35]), (0.02, 0.45, booth * 0.3), rotation=out, material=glazing(kit))
        kit.add(BOX, (0, 0, 2 * booth + 0.05), (0.75, 0.75, 0.06), material=steel)
        kit.add(BOX, (1.0, 0.4, 0.5), (0.12, 0.12, 0.5), material=steel)
        lift = rng.choice([0, 0, rng.uniform(0.3, 1.3)])
        way = np.array([0, np.cos(lift), np.sin(lift)])
        kit.between(np.array([1.0, 0.3, 0.95]) - way * 0.4, np.array([1.0, 0.3, 0.95]) + way * rng.uniform(2, 3.2), 0.05, BOX, material=kit.material(base=[0.8, 0.1, 0.06], second=[0.85] * 3, pattern=STRIPES, frequency=4))
        kit.add(BOX, np.array([1.0, 0.3, 0.95]) - way * 0.45, (0.1, 0.15, 0.12), material=dark)
        if kit.chance(0.5):
            kit.between((-0.5, 0.5, 2 * booth), (-0.5, 0.5, 2 * booth + 0.9), 0.02, material=dark)
            kit.add(BOX, (-0.5, 0.75, 2 * booth + 0.75), (0.01, 0.25, 0.15), material=kit.material())
    else:
        what = rng.choice(["tyres", "crates", "pipes"])
        if what == "tyres":
            for k in range(int(rng.integers(1, 5))):
                x, y = rng.uniform(-0.1, 0.1) + 1.05 * (k // 2), 1.05 * (k % 2)
                for level in range(int(rng.integers(1, 5))):
                    kit.add(TUBE, (x, y, 0.13 + 0.25 * level), (0.5, 0.5, 0.12), material=dark)
                    kit.add(TUBE, (x, y, 0.13 + 0.25 * level), (0.3, 0.3, 0.11), material=dark)
                    kit.add(CYL, (x, y, 0.02 + 0.25 * level), (0.49, 0.49, 0.012), material=dark)
        elif what == "crates":
            wood = kit.material(pattern=PLANKS)
            heights = {}
            for _ in range(int(rng.integers(3, 10))):
                cell = (int(rng.integers(0, 3)), int(rng.integers(0, 2)))
                half = rng.uniform(0.25, 0.45, 3) if kit.chance(0.5) else np.array([0.42, 0.42, 0.3])
                z = heights.get(cell, 0.0)
                kit.add(BOX, (cell[0] * 0.95, cell[1] * 0.95, z + half[2]), half, rotation=turn("z", rng.normal(0, 5)), material=wood if kit.chance(0.6) else coat(kit))
                heights[cell] = z + 2 * half[2]
        else:
            wood = kit.material(pattern=rng.choice([PLAIN, STREAKS, CLOUDY]))
            radius, long, base = rng.uniform(0.15, 0.3), rng.uniform(1.0, 2.2), int(rng.integers(2, 6))
            hollow = kit.chance(0.5)
            for level in range(base):
                for k in range(base - level):
                    at = (0, (2 * k + level) * radius, radius + level * radius * 1.73)
                    kit.add(TUBE if hollow else CYL, at, (radius, radius, long * rng.uniform(0.95, 1.02)), rotation=ALONG_X, material=wood)
