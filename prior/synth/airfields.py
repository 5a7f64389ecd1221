"""Makers of control towers, hangars, depots, guard towers, stands, greenhouses, barns, lighthouses, shelters."""

import numpy as np

from .field import end_wall, vault
from .homes import slab_roof
from .installations import (
    BLACK,
    BLUE,
    BRICK,
    CONCRETE,
    EARTH,
    GREEN,
    GREY,
    OLIVE,
    ORANGE,
    RED,
    RUST,
    SAND,
    SLATE,
    STONE,
    TILE,
    WHITE,
    WOOD,
    YELLOW,
    corners,
    ladder,
    railed,
    stage,
    stairs,
    tinted,
    trestle,
    walling,
)
from .kit import ALONG_X, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, PRISM, RUNGS, TUBE
from .materials import BANDS, BRICKS, CAMOUFLAGE, CLOUDY, PATCHWORK, PLAIN, PLANKS, RIBS, SEAMS, SHINGLES, STREAKS, STRIPES, WRITING
from .wheeled import glazing


def airfield(kit):
    """Control towers, hangars, hardened shelters, fuel depots, petrol stations, guard towers, check points, fire lookouts, grandstands, greenhouses, barns, lighthouses,
    bus shelters, toll booths."""
    kinds = [
        control_tower,
        hangar,
        hard_shelter,
        fuel_depot,
        petrol_station,
        guard_tower,
        check_point,
        lookout,
        grandstand,
        greenhouse,
        barn,
        lighthouse,
        bus_shelter,
        toll,
    ]
    kinds[kit.rng.choice(len(kinds))](kit)


def control_tower(kit):
    rng = kit.rng
    wall, trim, glass, metal = walling(kit), tinted(kit, (WHITE, GREY, RED, BLUE, CONCRETE)), glazing(kit), tinted(kit, (GREY, WHITE, BLACK))
    sides, tall, radius = int(rng.choice([4, 6, 8, 8, 12])), rng.uniform(2.2, 5), rng.uniform(0.4, 0.75)
    cab = radius * rng.uniform(1.25, 1.8)
    if sides == 4 and kit.chance(0.5):
        kit.add(BOX, (0, 0, tall / 2), (radius, radius, tall / 2), (0.9, 0.9), material=wall)
        for z in np.arange(0.7, tall - 0.5, 0.7):
            kit.add(BOX, (0, 0, z), (radius * 1.0, radius * 0.35, 0.12), material=glass)
    elif kit.chance(0.5):
        kit.add(CYL, (0, 0, tall / 2), (radius * 0.9, radius * 0.9, tall / 2), (rng.uniform(0.75, 1), 1), material=wall)
    else:
        kit.add(PRISM, (0, 0, tall / 2), (radius, radius, tall / 2), (rng.uniform(0.8, 1), sides), material=wall)
        kit.add(BOX, (radius * 0.9, 0, tall / 2), (0.08, 0.12, tall * 0.46), material=trim)
    flare = rng.uniform(0.25, 0.5)
    kit.add(PRISM, (0, 0, tall - flare / 2), (radius * 0.85, radius * 0.85, flare / 2), (cab / radius / 0.85, sides), material=trim)
    kit.add(PRISM, (0, 0, tall + 0.14), (cab, cab, 0.15), (1, sides), material=wall)
    if kit.chance(0.6):
        kit.add(PRISM, (0, 0, tall + 0.3), (cab * 1.25, cab * 1.25, 0.03), (1, sides), material=trim)
        for k in range(sides):
            side = cab * 1.25 * np.tan(np.pi / sides)
            spin = turn("z", 360 * k / sides)
            kit.railing(spin @ [cab * 1.23, -side, tall + 0.32], spin @ [cab * 1.23, side, tall + 0.32], 0.2, metal, 0.12, thick=0.015)
    pane, lean = rng.uniform(0.35, 0.55), rng.uniform(1.06, 1.22)
    kit.add(PRISM, (0, 0, tall + 0.29 + pane / 2), (cab * 0.93, cab * 0.93, pane / 2), (lean, sides), material=glass)
    for x, y in around(sides, cab * 0.94 / np.cos(np.pi / sides), 180 / sides):
        kit.between((x, y, tall + 0.29), (x * lean, y * lean, tall + 0.29 + pane), 0.025, material=trim)
    roof = tall + 0.29 + pane
    kit.add(PRISM, (0, 0, roof + 0.07), (cab * lean * 1.04, cab * lean * 1.04, 0.08), (0.96, sides), material=trim)
    if kit.chance(0.5):
        kit.add(PRISM, (0, 0, roof + 0.2), (cab * 0.9, cab * 0.9, 0.08), (0.7, sides), material=trim)
    for x, y in ((0.4, 0.3), (-0.3, 0.5), (-0.4, -0.4)):
        kit.between((x * cab, y * cab, roof), (x * cab, y * cab, roof + rng.uniform(0.4, 1.1)), 0.015, material=metal)
    if kit.chance(0.4):
        kit.add(BALL, (0, 0, roof + 0.42), (0.26, 0.26, 0.26), material=tinted(kit, (WHITE,)))
    kit.add(BOX, (0, 0, roof + 0.2), (0.14, 0.14, 0.2), material=metal)
    if kit.chance(0.65):
        long, wide, high = rng.uniform(0.9, 2), rng.uniform(0.8, 1.5), rng.uniform(0.3, 0.65)
        x, y = rng.choice([-1, 0.6]) * long * 0.6, rng.uniform(-0.4, 0.4) * wide
        kit.add(BOX, (x, y, high), (long, wide, high), material=wall)
        kit.add(BOX, (x, y, 2 * high), (long * 1.02, wide * 1.02, 0.05), material=trim)
        kit.add(BOX, (x, y, high * 1.25), (long * 0.85, wide * 1.01, high * 0.25), material=glass)
        kit.add(BOX, (x, y, high * 1.25), (long * 1.01, wide * 0.85, high * 0.25), material=glass)
    kit.add(BOX, (radius * 0.95, 0, 0.22), (0.08, 0.14, 0.22), material=kit.material(dark=True))


def hangar(kit):
    rng = kit.rng
    skin = tinted(kit, (GREY, WHITE, GREEN, OLIVE, SAND, BLUE, RUST), (RIBS, RIBS, PLAIN, SEAMS, STREAKS), frequency=rng.uniform(12, 40))
    front, door, dark = (
        tinted(kit, (GREY, WHITE, BRICK, CONCRETE, BLUE), (RIBS, PLAIN, BRICKS)),
        tinted(kit, (GREY, WHITE, RED, BLUE, GREEN), (RIBS, PLAIN, STRIPES)),
        kit.material(dark=True),
    )
    long, wide, high, eave = rng.uniform(1.3, 2.8), rng.uniform(1.4, 2.2), rng.uniform(1.1, 1.6), 0.0
    kind = rng.choice(["vault", "gable", "bow"], p=[0.4, 0.35, 0.25])
    gate, tall = wide * rng.uniform(0.65, 0.85), high * 0.7
    kit.add(BOX, (0.3, 0, 0.02), (long + 0.3, wide * 1.05, 0.025), material=tinted(kit, (CONCRETE,), (CLOUDY,)))
    if kind == "vault":
        high = wide * rng.uniform(0.6, 0.95)
        vault(kit, (0, 0, 0), long, wide, high, 9, skin, 0.04)
        end_wall(kit, -long * 0.97, 0, wide, high, 5, front)
        tall, gate = high * 0.62, wide * 0.72
        if kit.chance(0.5):
            end_wall(kit, long * 0.9, 0, wide, high, 5, dark)
        for x in np.linspace(-0.95, 0.98, int(rng.integers(0, 4))):
            vault(kit, (x * long, 0, 0), 0.04, wide * 1.015, high * 1.015, 9, door, 0.05)
    else:
        eave = high * rng.uniform(0.65, 0.9)
        tall = eave * 0.88
        kit.add(BOX, (0, wide - 0.04, eave / 2), (long, 0.05, eave / 2), material=skin, mirror=True)
        kit.add(BOX, (-long, 0, eave / 2), (0.05, wide, eave / 2), material=front)
        for y in (-1, 1):
            kit.add(BOX, (long, y * (wide + gate) / 2, eave / 2), (0.05, (wide - gate) / 2, eave / 2), material=front)
        kit.add(BOX, (long, 0, (eave + tall) / 2), (0.06, wide, (eave - tall) / 2 + 0.02), material=front)
        if kind == "gable":
            slab_roof(kit, (0, 0, eave), (long, wide), wide * rng.uniform(0.2, 0.5), 0.1, skin, 0.04, front)
        else:
            rise = wide * rng.uniform(0.25, 0.45)
            angles = np.linspace(-1, 1, 8) * np.radians(65)
            radius = wide * 1.03 / np.sin(np.radians(65))
            drop, squash = radius * np.cos(np.radians(65)), rise / (radius * (1 - np.cos(np.radians(65))))
            edge = [(radius * np.sin(a), (radius * np.cos(a) - drop) * squash) for a in angles]
            for (y0, z0), (y1, z1) in zip(edge[:-1], edge[1:], strict=True):
                spin = turn("x", np.degrees(np.arctan2(z1 - z0, y1 - y0)))
                kit.add(BOX, (0, (y0 + y1) / 2, eave + (z0 + z1) / 2), (long * 1.04, np.hypot(y1 - y0, z1 - z0) / 2 * 1.04, 0.04), rotation=spin, material=skin)
            for (y0, z0), (y1, z1) in zip(edge[:3], edge[1:4], strict=True):
                for x in (-long, long):
                    kit.add(BOX, (x, 0, eave + (z0 + z1) / 2), (0.05, -y0 * 0.98, (z1 - z0) / 2), (1, y1 / y0), material=front)
        bays = int(rng.integers(2, 6))
        for x in np.linspace(-0.8, 0.8, bays):
            kit.add(BOX, (x * long, wide + 0.02, eave * 0.72), (long * 0.7 / bays, 0.02, eave * 0.14), material=glazing(kit) if kit.chance(0.7) else skin, mirror=True)
        if kit.chance(0.5):
            out, low = rng.uniform(0.3, 0.6), eave * rng.uniform(0.35, 0.6)
            kit.add(BOX, (-long * 0.1, wide + out, low / 2), (long * 0.8, out, low / 2), material=front)
            kit.add(BOX, (-long * 0.1, wide + out, low + 0.03), (long * 0.83, out * 1.08, 0.04), material=skin)
            kit.add(BOX, (-long * 0.1, wide + 2 * out, low * 0.6), (long * 0.5, 0.02, low * 0.15), material=dark)
    leaves, opened = int(rng.integers(2, 5)), rng.choice([0, rng.uniform(0.3, 1), 1])
    leaf = gate / leaves
    for k in range(leaves):
        y = leaf * (k + 0.5)
        y += (gate * (0.95 if kind == "vault" else 1.4) - y) * opened * (0.3 + 0.7 * k / leaves)
        kit.add(BOX, (long + 0.08 + 0.05 * (k % 2), y, tall / 2), (0.025, leaf * 0.52, tall / 2), material=door, mirror=True)
    if opened < 0.2:
        kit.add(BOX, (long + 0.11, 0, tall * 0.8), (0.04, gate * 0.9, tall * 0.07), material=glazing(kit))
    kit.add(BOX, (long + 0.1, 0, tall + 0.03), (0.08, gate * 1.2 if kind != "vault" else gate, 0.05), material=dark)
    if kit.chance(0.4):
        kit.add(
            BOX, (long + 0.07, 0, (eave or high * 0.75) + 0.12), (0.02, wide * 0.3, 0.09), material=kit.material(base=WHITE, pattern=WRITING, second=[0.03, 0.05, 0.2])
        )


def hard_shelter(kit):
    rng = kit.rng
    skin = tinted(kit, (CONCRETE, OLIVE, SAND, GREY, EARTH), (CLOUDY, STREAKS, CAMOUFLAGE, PLAIN))
    earth, steel, dark = (
        tinted(kit, (EARTH, OLIVE, GREEN, SAND), (CLOUDY,), gloss=0.0),
        tinted(kit, (GREY, OLIVE, RUST, GREEN), (STREAKS, RIBS, PLAIN)),
        kit.material(dark=True),
    )
    long, wide = rng.uniform(1.6, 2.6), rng.uniform(1.2, 1.7)
    high, thick = wide * rng.uniform(0.65, 0.9), rng.uniform(0.12, 0.22)
    vault(kit, (0, 0, 0), long, wide, high, 10, skin, thick / 2)
    end_wall(kit, -long * 0.96, 0, wide, high, 5, skin, 0.08)
    kit.add(BOX, (0, 0, 0.02), (long * 1.2, wide * 1.05, 0.025), material=skin)
    shut = kit.chance(0.5)
    if shut:
        end_wall(kit, long * 0.85, 0, wide, high, 5, dark, 0.05)
    leaf, tall = wide * 0.5, high * rng.uniform(0.72, 0.82)
    for k in (0, 1):
        y = leaf * (k + 0.5) * 0.9 if shut else wide * 0.95 + leaf * 0.75 * k
        kit.add(BOX, (long * 1.03, y, tall / 2), (0.09, leaf * 0.5, tall * (0.5 if not shut or k == 0 else 0.4)), material=steel, mirror=True)
    if shut:
        kit.add(BOX, (long * 1.07, 0, tall * 0.5), (0.08, 0.02, tall * 0.5), material=dark)
    else:
        kit.add(BOX, (long * 1.0, 0, 0.05), (0.12, wide * 1.9, 0.05), material=steel)
    if kit.chance(0.55):
        for side in (-1, 1):
            kit.add(BOX, (-0.1 * long, side * wide * 1.12, high * 0.33), (long * 0.9, wide * 0.42, high * 0.33), (0.9, 0.15), (0, -side * wide * 0.3), material=earth)
    else:
        for x in np.linspace(-0.85, 0.9, int(rng.integers(3, 6))):
            for side in (-1, 1):
                kit.add(BOX, (x * long, side * wide * 1.05, high * 0.3), (0.09, wide * 0.2, high * 0.3), (1, 0.3), (0, -side * wide * 0.12), material=skin)
    kit.add(BOX, (-long * 1.05, 0, high * 0.3), (0.3, wide * 0.4, high * 0.3), (0.7, 0.9), (0.1, 0), material=skin)
    kit.add(BOX, (-long * 1.05 - 0.3, 0, high * 0.25), (0.03, wide * 0.2, high * 0.2), material=dark)
    if kit.chance(0.5):
        kit.loft((-long * 0.4, 0, high * 0.97), [(0, 0.12), (0.25, 0.12), (0.26, 0.2), (0.33, 0.14)], steel)


def fuel_depot(kit):
    rng = kit.rng
    skin, metal, dark = (
        tinted(kit, (WHITE, GREY, OLIVE, SAND, GREEN, RED), (PLAIN, SEAMS, STREAKS, WRITING), gloss=0.3),
        tinted(kit, (GREY, YELLOW, RED)),
        kit.material(dark=True),
    )
    count, radius, long = int(rng.integers(1, 4)), rng.uniform(0.4, 0.6), rng.uniform(1.0, 1.7)
    wall = tinted(kit, (CONCRETE, BRICK), (CLOUDY, BRICKS))
    span = count * radius * 1.25
    kit.add(BOX, (0, 0, 0.04), (long * 1.35, span + 0.25, 0.04), material=wall)
    for k in range(count):
        y, z = radius * 2.5 * (k - (count - 1) / 2), radius + 0.35
        kit.add(CYL, (0, y, z), (radius, radius, long), rotation=ALONG_X, material=skin)
        for x in (-1, 1):
            kit.add(BALL, (x * long, y, z), (radius * 0.35, radius, radius), material=skin)
            kit.add(BOX, (x * long * 0.6, y, 0.08 + (z - 0.08) / 2), (0.1, radius * 0.85, (z - radius * 0.5) / 2), material=wall)
        kit.add(CYL, (long * 0.2, y, z + radius), (0.14, 0.14, 0.08), material=metal)
        kit.between((-long * 0.4, y, z + radius), (-long * 0.4, y, z + radius * 1.6), 0.03, material=metal)
    if count > 1:
        kit.add(BOX, (long * 0.2, 0, 2 * radius + 0.45), (0.18, span * 0.85, 0.025), material=metal)
        kit.railing((long * 0.35, -span * 0.85, 2 * radius + 0.45), (long * 0.35, span * 0.85, 2 * radius + 0.45), 0.3, metal)
    edge = radius * 2.5 * (count - 1) / 2
    ladder(kit, (long * 0.2, edge + radius * 1.5, 0.05), (long * 0.2, edge + radius * 0.4, 2 * radius + 0.45), 0.12, metal)
    if kit.chance(0.7):
        for x in (-1, 1):
            kit.add(BOX, (x * long * 1.33, 0, 0.2), (0.05, span + 0.25, 0.16), material=wall)
        kit.add(BOX, (0, span + 0.22, 0.2), (long * 1.33, 0.05, 0.16), material=wall, mirror=True)
    x = long * 1.35 + 0.5
    kit.add(BOX, (x, 0, 0.06), (0.45, 0.7, 0.06), material=wall)
    for y in (-0.35, 0.35):
        kit.add(BOX, (x, y, 0.5), (0.16, 0.22, 0.4), material=tinted(kit, (RED, WHITE, YELLOW, GREEN)))
        kit.add(BOX, (x + 0.165, y, 0.68), (0.01, 0.15, 0.1), material=dark)
        kit.between((x, y + 0.24, 0.75), (x, y + 0.26, 0.25), 0.03, material=dark)
    kit.between((long, 0, 0.25), (x, 0, 0.25), 0.04, material=metal)
    if kit.chance(0.5):
        roof = tinted(kit, (WHITE, GREY, RED, BLUE), (RIBS, PLAIN))
        for y in (-0.6, 0.6):
            kit.between((x, y, 0), (x, y, 1.5), 0.05, BOX, material=metal)
        kit.add(BOX, (x, 0, 1.55), (0.65, 0.95, 0.06), material=roof)


def petrol_station(kit):
    rng = kit.rng
    colour, white, dark, glass = tinted(kit, (RED, YELLOW, GREEN, BLUE, ORANGE)), tinted(kit, (WHITE,), gloss=0.2), kit.material(dark=True), glazing(kit)
    long, wide, high = rng.uniform(1.2, 2.0), rng.uniform(1.0, 1.7), rng.uniform(1.15, 1.5)
    kit.add(BOX, (-0.4, 0, 0.02), (long + 1.7, wide * 1.15, 0.025), material=tinted(kit, (CONCRETE, GREY), (CLOUDY, PLAIN)))
    islands = int(rng.integers(1, 3))
    for x in np.linspace(-0.5, 0.5, islands) * long if islands > 1 else [0.0]:
        kit.add(BOX, (x, 0, 0.08), (0.22, wide * 0.8, 0.05), material=white)
        for y in (-0.6, 0.6):
            kit.add(CYL if kit.chance(0.3) else BOX, (x, y * wide, high / 2), (0.07, 0.07, high / 2), material=white if kit.chance(0.6) else colour)
        for y in (-0.25, 0.25):
            kit.add(BOX, (x, y * wide, 0.42), (0.13, 0.17, 0.32), material=colour)
            kit.add(BOX, (x, y * wide, 0.58), (0.14, 0.11, 0.1), material=dark)
            kit.add(BOX, (x, y * wide, 0.8), (0.11, 0.17, 0.07), material=white)
            kit.between((x, y * wide + 0.19, 0.65), (x, y * wide + 0.21, 0.25), 0.03, material=dark)
    if kit.chance(0.2):
        kit.add(CYL, (0, 0, high + 0.1), (long, wide, 0.13), material=white)
        kit.add(CYL, (0, 0, high + 0.1), (long * 1.01, wide * 1.01, 0.05), material=colour)
    else:
        kit.add(BOX, (0, 0, high + 0.13), (long, wide, 0.14), material=white)
        kit.add(BOX, (0, 0, high + 0.15), (long * 1.01, wide * 1.01, rng.uniform(0.05, 0.1)), material=colour)
    kit.add(BOX, (long * 1.02, wide * 0.5, high + 0.14), (0.01, wide * 0.2, 0.09), material=kit.material(base=WHITE, pattern=WRITING, second=[0.3, 0.02, 0.02]))
    x, deep, tall = -long - 0.9, 0.6, rng.uniform(0.45, 0.6)
    kit.add(BOX, (x, 0, tall), (deep, wide * 0.85, tall), material=walling(kit))
    kit.add(BOX, (x, 0, 2 * tall), (deep * 1.08, wide * 0.9, 0.1), material=colour)
    kit.add(BOX, (x + deep, -wide * 0.1, tall * 0.95), (0.02, wide * 0.65, tall * 0.6), material=glass)
    kit.add(BOX, (x + deep, wide * 0.68, tall * 0.75), (0.03, 0.13, tall * 0.7), material=dark)
    if kit.chance(0.75):
        at, top = (long * 1.1, wide * 1.0), rng.uniform(1.4, 2.2)
        for y in (-0.15, 0.15):
            kit.add(BOX, (at[0], at[1] + y, top * 0.35), (0.04, 0.04, top * 0.35), material=white)
        kit.add(BOX, (*at, top * 0.68), (0.06, 0.25, top * 0.18), material=kit.material(base=BLACK, pattern=WRITING, second=[0.8, 0.5, 0.1], frequency=25))
        kit.add(BOX, (*at, top * 0.95), (0.07, 0.26, top * 0.1), material=colour)
    if kit.chance(0.5):
        kit.add(BOX, (x, -wide * 0.3, 2 * tall + 0.2), (0.2, 0.25, 0.12), material=white)


def cabin(kit, z, half, tall, wall, roof, glass, over=0.15, kind="hip"):
    """A look-out's room on a platform at z: parapet, a band of glass between corner posts, a roof."""
    sill = tall * 0.45
    kit.add(BOX, (0, 0, z + sill / 2), (half, half, sill / 2), material=wall)
    kit.add(BOX, (0, 0, z + (sill + tall) / 2), (half * 0.96, half * 0.96, (tall - sill) / 2), material=glass)
    for corner in corners(half * 0.96, half * 0.96, z + tall / 2):
        kit.add(BOX, corner, (0.05, 0.05, tall / 2), material=wall)
    for spin in (0, 90):
        kit.add(BOX, (0, 0, z + (sill + tall) / 2), (half * 0.975, 0.03, (tall - sill) / 2), rotation=turn("z", spin), material=wall)
    if kind == "hip":
        kit.add(BOX, (0, 0, z + tall + half * 0.25), (half + over, half + over, half * 0.25), (0.05, 0.05), material=roof)
    elif kind == "gable":
        slab_roof(kit, (0, 0, z + tall), (half, half), half * 0.5, over, roof, 0.03, wall)
    else:
        kit.add(BOX, (0, 0, z + tall + 0.06), (half + over, half + over, 0.06), rotation=turn("y", 5), material=roof)


def guard_tower(kit):
    rng = kit.rng
    wood = tinted(kit, (WOOD, WOOD, GREY, OLIVE, RUST, WHITE), (PLANKS, PLAIN, STREAKS), frequency=rng.uniform(10, 25))
    roof, dark = tinted(kit, (SLATE, RUST, GREEN, GREY, OLIVE), (RIBS, SHINGLES, PLAIN)), kit.material(dark=True)
    tall, half = rng.uniform(1.8, 3.4), rng.uniform(0.55, 0.75)
    kind = rng.choice(["open", "cabin", "solid"], p=[0.4, 0.4, 0.2])
    if kind == "solid":
        wall = walling(kit)
        kit.add(BOX, (0, 0, tall / 2), (half * 0.7, half * 0.7, tall / 2), (0.95, 0.95), material=wall)
        kit.add(BOX, (half * 0.7, 0, 0.35), (0.03, 0.18, 0.35), material=dark)
        for x in (-1, 1):
            for z in (0.45, 0.75):
                kit.add(BOX, (x * half * 0.68, 0, tall * z), (0.03, 0.06, 0.15), material=dark)
    else:
        trestle(
            kit,
            corners(half * rng.uniform(1.0, 1.4), half * 1.2, 0),
            corners(half * 0.9, half * 0.9, tall),
            0.06,
            wood,
            int(rng.integers(1, 3)),
            tall < 2.6 and kit.chance(0.5),
        )
        if kit.chance(0.55):
            stairs(kit, (half + tall * 0.75, -half * 0.5, 0), (half * 1.05, -half * 0.5, tall), 0.22, wood)
        else:
            ladder(kit, (half * 1.6, 0, 0), (half * 1.02, 0, tall), 0.17, wood)
    kit.add(BOX, (0, 0, tall), (half * 1.2, half * 1.2, 0.05), material=wood)
    if kind == "open":
        for corner in corners(half * 1.1, half * 1.1, tall + 0.6):
            kit.add(BOX, corner, (0.045, 0.045, 0.6), material=wood)
        for side in range(4):
            kit.add(BOX, turn("z", 90 * side) @ [half * 1.13, 0, tall + 0.27], (0.025, half * 1.13, 0.24), rotation=turn("z", 90 * side), material=wood)
        kit.add(BOX, (0, 0, tall + 1.2 + half * 0.25), (half * 1.4, half * 1.4, half * 0.25), (0.03, 0.03 if kit.chance(0.6) else 1), material=roof)
    else:
        cabin(kit, tall + 0.05, half, rng.uniform(0.85, 1.1), wood, roof, glazing(kit), 0.2, rng.choice(["hip", "gable", "flat"]))
        railed(kit, 0, 0, tall + 0.05, half * 1.2, half * 1.2, 0.35, wood)
    if kit.chance(0.5):
        kit.add(CYL, (half * 1.3, half * 0.8, tall + 0.6), (0.13, 0.13, 0.1), rotation=ALONG_X, material=tinted(kit, (WHITE,), gloss=0.5))
        kit.between((half * 1.15, half * 0.8, tall), (half * 1.25, half * 0.8, tall + 0.6), 0.03, material=dark)


def check_point(kit):
    rng = kit.rng
    wall, roof, glass, dark = (
        tinted(kit, (WHITE, GREY, OLIVE, SAND, BLUE, YELLOW, WOOD), (PLAIN, PLANKS, STREAKS)),
        tinted(kit, (SLATE, RUST, GREY, RED, WHITE)),
        glazing(kit),
        kit.material(dark=True),
    )
    half, tall = rng.uniform(0.45, 0.7), rng.uniform(1.3, 1.6)
    kit.add(BOX, (0, 0, 0.06), (half * 1.4, half * 1.4, 0.06), material=tinted(kit, (CONCRETE,)))
    cabin(kit, 0.1, half, tall, wall, roof, glass, rng.uniform(0.1, 0.3), rng.choice(["hip", "flat", "gable"]))
    kit.add(BOX, (half * 0.99, 0, 0.1 + tall * 0.42), (0.03, half * 0.4, tall * 0.4), material=tinted(kit, (WHITE, GREY, BLUE, BLACK)))
    if kit.chance(0.5):
        for k in range(4):
            kit.add(BOX, (0, 0, 0.25 + 0.12 * k), (half * 1.01, half * 1.01, 0.03), material=tinted(kit, (RED,)) if k % 2 else tinted(kit, (WHITE,)))
    y, reach, lift = half + 0.55, rng.uniform(2.0, 3.2), rng.choice([0, 0, rng.uniform(30, 75)])
    kit.add(BOX, (0.1, y, 0.45), (0.16, 0.16, 0.45), material=tinted(kit, (RED, GREY, YELLOW, WHITE)))
    aim = np.array([0, np.cos(np.radians(lift)), np.sin(np.radians(lift))])
    red, white, hinge, pieces = tinted(kit, (RED,)), tinted(kit, (WHITE,)), np.array([0.3, y, 0.8]), 8
    kit.between((0.0, y, 0.8), (0.3, y, 0.8), 0.06, material=dark)
    for k in range(pieces):
        kit.between(hinge + aim * reach * k / pieces, hinge + aim * reach * (k + 1) / pieces, (0.06, 0.03), BOX, material=white if k % 2 else red)
    kit.between(hinge, hinge - aim * 0.4, (0.12, 0.06), BOX, material=dark)
    if lift == 0:
        kit.between((0.3, y + reach * 0.97, 0), (0.3, y + reach * 0.97, 0.78), 0.04, material=red)
    if kit.chance(0.5):
        for k in range(3):
            kit.add(BOX, (half + 0.9, -half + 1.3 * k, 0.13), (0.22, 0.62, 0.13), material=tinted(kit, (CONCRETE, YELLOW)))
            kit.add(BOX, (half + 0.9, -half + 1.3 * k, 0.45), (0.14, 0.62, 0.22), (0.7, 1), material=tinted(kit, (CONCRETE, YELLOW), (PLAIN, STRIPES)))
    if kit.chance(0.5):
        kit.between((-half - 0.4, y, 0), (-half - 0.4, y, 3.2), 0.03, material=white)
        kit.add(BOX, (-half - 0.4, y + 0.4, 2.9), (0.012, 0.4, 0.25), material=tinted(kit, (RED, BLUE, GREEN, WHITE), (BANDS, PLAIN, CLOUDY)))
    if kit.chance(0.4):
        kit.between((half + 0.3, -y, 0), (half + 0.3, -y, 1.3), 0.03, material=dark)
        kit.add(CYL, (half + 0.33, -y, 1.4), (0.3, 0.3, 0.02), rotation=ALONG_X, material=red)
        kit.add(BOX, (half + 0.35, -y, 1.4), (0.015, 0.2, 0.06), material=white)


def lookout(kit):
    rng = kit.rng
    metal, wall, roof = (
        tinted(kit, (GREY, RUST, GREEN, WOOD, GREY)),
        tinted(kit, (WHITE, WOOD, GREEN, GREY, RED), (PLANKS, PLAIN)),
        tinted(kit, (RED, SLATE, GREEN, GREY, RUST), (SHINGLES, RIBS, PLAIN)),
    )
    tall, half = rng.uniform(3, 5.5), rng.uniform(0.5, 0.65)
    spread = half * rng.uniform(1.5, 2.2)
    feet, heads = corners(spread, spread, 0), corners(half * 0.8, half * 0.8, tall)
    trestle(kit, feet, heads, 0.05, metal, 3, False)
    for share in (0.33, 0.66):
        reach = spread + (half * 0.8 - spread) * share
        for y in (-reach, reach):
            kit.between((-reach, y, tall * share), (reach, y, tall * share), 0.035, BOX, material=metal)
    for k in range(3):  # flights from landing to landing
        way = 1 if k % 2 else -1
        reach = (spread + (half * 0.8 - spread) * (k + 0.5) / 3) * 0.6
        kit.between((-way * reach, way * 0.12, tall * k / 3), (way * reach, way * 0.12, tall * (k + 1) / 3), (0.03, 0.12), BOX, material=metal, cut=(RUNGS, 7, 0.5))
    kit.add(BOX, (0, 0, tall), (half * 1.45, half * 1.45, 0.04), material=wall)
    cabin(kit, tall + 0.04, half, rng.uniform(0.7, 0.9), wall, roof, glazing(kit), rng.uniform(0.1, 0.25), rng.choice(["hip", "hip", "gable", "flat"]))
    railed(kit, 0, 0, tall + 0.04, half * 1.42, half * 1.42, 0.35, metal)
    kit.between((0, 0, tall + 1.0), (0, 0, tall + 1.9), 0.015, material=metal)


def grandstand(kit):
    rng = kit.rng
    concrete, metal, seats = (
        tinted(kit, (CONCRETE, WHITE, GREY)),
        tinted(kit, (GREY, WHITE, BLUE, RED)),
        [tinted(kit, (RED, BLUE, YELLOW, GREEN, ORANGE, GREY, WOOD)) for _ in range(2)],
    )
    steps, deep, rise, wide = int(rng.integers(5, 10)), rng.uniform(0.22, 0.32), rng.uniform(0.14, 0.24), rng.uniform(1.6, 3.5)
    base, total, open_frame = rng.uniform(0.05, 0.5), 0.0, kit.chance(0.35)
    for k in range(steps):
        x, z = -deep * k, base + rise * (k + 1)
        if open_frame:
            kit.add(BOX, (x, 0, z), (deep * 0.5, wide, 0.025), material=concrete)
        else:
            kit.add(BOX, (x, 0, z / 2), (deep * 0.51, wide, z / 2), material=concrete)
        kit.add(BOX, (x - deep * 0.2, 0, z + 0.06), (deep * 0.22, wide * 0.97, 0.05), material=seats[k % 2] if not open_frame else seats[0])
    back, total = -deep * (steps - 0.5), base + rise * steps
    if open_frame:
        for y in np.linspace(-0.97, 0.97, 4) * wide:
            kit.between((deep * 0.5, y, base), (back, y, total), (0.06, 0.03), BOX, material=metal)
            kit.between((back, y, 0), (back, y, total), 0.04, BOX, material=metal)
            kit.between((deep * 0.4, y, 0), (deep * 0.4, y, base + rise), 0.04, BOX, material=metal)
            kit.between((deep * 0.4, y, 0), (back, y, total * 0.9), 0.03, BOX, material=metal)
            kit.between((back / 2, y, 0), (back / 2, y, base + total * 0.5 - base * 0.5), 0.035, BOX, material=metal)
    else:
        for y in np.linspace(-0.5, 0.5, int(rng.integers(1, 4))):
            kit.add(
                BOX,
                ((back + deep * 0.5) / 2, y * wide, base + (total - base) / 2 + 0.1),
                (np.hypot(back, total - base) / 2, 0.09, 0.05),
                rotation=turn("y", np.degrees(np.arctan2(total - base, -back))),
                material=concrete,
            )
    kit.railing((deep * 0.55, -wide, base), (deep * 0.55, wide, base), 0.35, metal, 0.2)
    kit.railing((back, -wide, total), (back, wide, total), 0.35, metal, 0.2)
    for y in (-wide, wide):
        kit.add(
            BOX,
            ((back + deep * 0.5) / 2, y, (base + total) / 2 + 0.22),
            (np.hypot(back, total - base) / 2, 0.015, 0.13),
            rotation=turn("y", np.degrees(np.arctan2(total - base, -back))),
            material=metal,
            cut=(BARS, 5, 0.25),
        )
    if kit.chance(0.7):
        high = total + rng.uniform(1.0, 1.4)
        reach = -back * rng.uniform(0.75, 1.05)
        lean = turn("y", -rng.uniform(2, 9))
        kit.add(
            BOX,
            (back + reach * 0.5 - 0.05, 0, high),
            (reach * 0.58, wide * 1.04, 0.04),
            rotation=lean,
            material=tinted(kit, (WHITE, GREY, RED, BLUE, GREEN), (RIBS, PLAIN)),
        )
        for y in np.linspace(-0.95, 0.95, int(rng.integers(3, 6))) * wide:
            kit.between((back, y, 0), (back, y, high), 0.06, BOX, material=metal)
            kit.between((back, y, high * 0.82), np.array([back + reach * 0.6, y, high]) + lean @ [0, 0, 0], 0.035, BOX, material=metal)
        if kit.chance(0.4):
            kit.add(BOX, (back - 0.03, 0, (total + high) / 2), (0.04, wide, (high - total) / 2), material=concrete)


def greenhouse(kit):
    rng = kit.rng
    frame = tinted(kit, (WHITE, WHITE, GREEN, GREY, BLACK), gloss=0.3)
    glass = kit.material(base=rng.choice([[0.45, 0.55, 0.52], [0.3, 0.4, 0.4], [0.55, 0.6, 0.55], [0.15, 0.25, 0.2]]), pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.6)
    long, wide, high = rng.uniform(1.3, 3), rng.uniform(0.7, 1.2), rng.uniform(0.7, 1.1)
    kind = rng.choice(["gable", "tunnel", "palm"], p=[0.5, 0.25, 0.25])
    base = rng.choice([0.06, 0.25])
    kit.add(BOX, (0, 0, base / 2), (long * 1.01, wide * 1.02, base / 2), material=tinted(kit, (BRICK, CONCRETE, STONE), (BRICKS, PLAIN), frequency=25))
    bays = int(rng.integers(4, 8))
    spots = np.linspace(-long, long, bays)
    if kind == "gable":
        rise = wide * rng.uniform(0.45, 0.75)
        slope = np.degrees(np.arctan2(rise, wide))
        kit.add(BOX, (0, 0, (base + high) / 2), (long, wide, (high - base) / 2), material=glass)
        kit.add(BOX, (0, 0, high + rise / 2), (long, wide, rise / 2), (1, 0.02), material=glass)
        for x in spots:
            kit.add(BOX, (x, wide, high / 2), (0.025, 0.025, high / 2), material=frame, mirror=True)
            kit.between((x, wide, high), (x, 0, high + rise), 0.022, BOX, material=frame, mirror=True)
        for y, z in ((wide, high), (wide / 2, high + rise / 2)):
            kit.add(BOX, (0, y, z), (long * 1.01, 0.025, 0.03), rotation=turn("x", -slope), material=frame, mirror=True)
        kit.add(BOX, (0, 0, high + rise), (long * 1.02, 0.04, 0.04), material=frame)
        for x in (-long, long):
            kit.add(BOX, (x, 0, high), (0.025, wide, 0.025), material=frame)
            for y in (-0.35, 0.35):
                kit.add(BOX, (x, y * wide, (high + rise * 0.6) / 2), (0.025, 0.02, (high + rise * 0.62) / 2), material=frame)
        kit.add(BOX, (long + 0.01, 0, high * 0.48), (0.03, wide * 0.26, high * 0.48), material=frame, cut=(GRID, 3, 0.15))
        if kit.chance(0.6):
            spin = turn("x", -slope + 22)
            kit.add(BOX, (long * 0.3, wide * 0.33, high + rise * 0.8), (long * 0.25, wide * 0.24, 0.02), rotation=spin, material=frame)
    elif kind == "tunnel":
        film = tinted(kit, (WHITE, (0.6, 0.65, 0.6), (0.35, 0.45, 0.35)), (PLAIN, CLOUDY), gloss=0.4)
        tall = wide * rng.uniform(0.75, 1.05)
        vault(kit, (0, 0, base), long, wide, tall, 9, film, 0.02)
        for x in (-long * 0.99, long * 0.99):
            end_wall(kit, x, 0, wide, tall, 4, film)
        for x in np.linspace(-long, long, 4):
            vault(kit, (x, 0, base), 0.025, wide * 1.01, tall * 1.01, 7, frame, 0.03)
        kit.add(BOX, (long, 0, base + tall * 0.4), (0.03, wide * 0.28, tall * 0.4), material=frame, cut=(GRID, 4, 0.15))
    else:
        for x, half, size in ((0, long * 0.3, 1.0), (-long * 0.68, long * 0.4, 0.7), (long * 0.68, long * 0.4, 0.7)):
            tall, deep = high * size, wide * size
            kit.add(BOX, (x, 0, tall / 2 + base / 2), (half, deep, tall / 2), material=glass)
            crown = min(deep * 0.8, tall)
            kit.add(CYL, (x, 0, tall + base), (crown, deep, half), rotation=ALONG_X, material=glass)
            kit.add(BOX, (x, 0, tall + base), (half * 1.02, deep * 1.02, 0.03), material=frame)
            for px in np.linspace(-half, half, 4):
                kit.add(TUBE, (x + px, 0, tall + base), (crown * 1.015, deep * 1.015, 0.02), rotation=ALONG_X, material=frame)
                kit.add(BOX, (x + px, 0, tall / 2 + base / 2), (0.02, deep * 1.015, tall / 2), material=frame)
            kit.add(BOX, (x, 0, tall + base + crown), (half, 0.03, 0.04), material=frame)
        kit.loft((0, 0, high + base + min(wide * 0.8, high) - 0.03), [(0, 0.28), (0.18, 0.28), (0.24, 0.2), (0.36, 0.04)], frame)
        kit.add(BOX, (0, wide, base + high * 0.35), (long * 0.1, 0.04, high * 0.4), material=frame, mirror=True)


def barn(kit):
    rng = kit.rng
    wall = tinted(kit, (RED, RED, (0.3, 0.05, 0.03), WHITE, WOOD, GREY), (PLANKS, STRIPES, PLAIN), frequency=rng.uniform(14, 30))
    roof, trim = tinted(kit, (SLATE, GREY, RUST, GREEN, TILE), (SHINGLES, RIBS, PLAIN), frequency=rng.uniform(12, 30)), tinted(kit, (WHITE, WHITE, GREY))
    long, wide, high = rng.uniform(1.4, 2.6), rng.uniform(0.9, 1.3), rng.uniform(0.9, 1.3)
    kit.add(BOX, (0, 0, 0.06), (long * 1.01, wide * 1.01, 0.07), material=tinted(kit, (STONE, CONCRETE), (BRICKS,)))
    kit.add(BOX, (0, 0, high / 2), (long, wide, high / 2), material=wall)
    knee, rise, ridge = wide * rng.uniform(0.55, 0.68), wide * rng.uniform(0.55, 0.75), wide * rng.uniform(0.95, 1.15)
    kit.add(BOX, (0, 0, high + rise / 2), (long, wide * 0.99, rise / 2), (1, knee / wide), material=wall)
    kit.add(BOX, (0, 0, high + (rise + ridge) / 2), (long, knee, (ridge - rise) / 2), (1, 0.02), material=wall)
    flare = 0.12
    for start, end in (((wide + flare, high - flare * 0.8), (knee, high + rise)), ((knee, high + rise), (0, high + ridge))):
        middle, run = (np.array(start) + end) / 2, np.array(end) - start
        tilt = np.degrees(np.arctan2(run[1], -run[0]))
        kit.add(BOX, (0, middle[0], middle[1] + 0.03), (long * 1.06, np.hypot(*run) / 2 * 1.03, 0.04), rotation=turn("x", -tilt), material=roof, mirror=True)
    door, tall = wide * rng.uniform(0.35, 0.5), high * rng.uniform(0.75, 0.9)
    kit.add(BOX, (long, 0, tall / 2), (0.03, door, tall / 2), material=wall if kit.chance(0.6) else kit.material(dark=True))
    for y in (-door, 0, door):
        kit.add(BOX, (long + 0.01, y, tall / 2), (0.035, 0.03, tall / 2), material=trim)
    kit.add(BOX, (long + 0.01, 0, tall), (0.035, door + 0.03, 0.03), material=trim)
    if kit.chance(0.7):
        lean = np.degrees(np.arctan2(tall, door))
        for y in (-0.5, 0.5):
            for way in (-1, 1):
                kit.add(BOX, (long + 0.01, y * door, tall / 2), (0.035, np.hypot(tall, door) / 2 * 0.93, 0.022), rotation=turn("x", way * lean), material=trim)
    kit.add(BOX, (long, 0, high + rise * 0.5), (0.03, wide * 0.2, wide * 0.2), material=kit.material(dark=True))
    kit.add(BOX, (long - 0.005, 0, high + rise * 0.5), (0.03, wide * 0.24, wide * 0.24), material=trim)
    for x in np.linspace(-0.75, 0.75, int(rng.integers(2, 5))):
        kit.add(BOX, (x * long, wide, high * 0.55), (0.15, 0.025, 0.16), material=trim, mirror=True)
        kit.add(BOX, (x * long, wide + 0.01, high * 0.55), (0.12, 0.025, 0.13), material=glazing(kit), mirror=True)
    if kit.chance(0.6):
        kit.add(BOX, (0, 0, high + ridge + 0.15), (0.17, 0.17, 0.22), material=trim)
        kit.add(BOX, (0, 0, high + ridge + 0.47), (0.24, 0.24, 0.13), (0.05, 0.05), material=roof)
    for k in range(int(rng.choice([0, 1, 1, 2]))):
        size, top = rng.uniform(0.35, 0.55), high + ridge * rng.uniform(0.9, 1.7)
        x, y = -long * 0.5 + 1.25 * k, -wide - size - 0.1
        skin = tinted(kit, (WHITE, GREY, BLUE, CONCRETE, BRICK), (BANDS, SEAMS, PLAIN, BRICKS), frequency=rng.uniform(10, 30))
        kit.add(CYL, (x, y, top / 2), (size, size, top / 2), material=skin)
        kit.add(BALL, (x, y, top), (size * 1.02, size * 1.02, size * rng.uniform(0.5, 1)), material=tinted(kit, (GREY, WHITE, RED, BLUE), gloss=0.4))
        ladder(kit, (x + size + 0.03, y, 0), (x + size + 0.03, y, top), 0.09, trim)
    if kit.chance(0.4):
        kit.add(BOX, (-long * 0.2, wide + 0.4, high * 0.35), (long * 0.7, 0.42, high * 0.35), material=wall)
        kit.add(BOX, (-long * 0.2, wide + 0.42, high * 0.78), (long * 0.74, 0.5, 0.04), rotation=turn("x", -14), material=roof)


def lighthouse(kit):
    rng = kit.rng
    white, colour, dark = tinted(kit, (WHITE, WHITE, STONE, YELLOW)), tinted(kit, (RED, RED, BLACK, BLUE, GREEN)), kit.material(dark=True)
    tall, radius, sides = rng.uniform(2.4, 5), rng.uniform(0.5, 0.8), int(rng.choice([0, 0, 0, 8]))
    kit.add(CYL, (0, 0, 0.1), (radius * 1.4, radius * 1.4, 0.12), material=tinted(kit, (STONE, CONCRETE, GREY), (BRICKS, CLOUDY)))
    bands, top = int(rng.choice([1, 3, 4, 5, 6, 7])), radius * rng.uniform(0.55, 0.75)
    edges = np.linspace(0.2, tall, bands + 1)
    first = rng.integers(2)
    for k, (low, high) in enumerate(zip(edges[:-1], edges[1:], strict=True)):
        below, above = (radius + (top - radius) * (z - 0.2) / (tall - 0.2) for z in (low, high))
        kit.add(
            PRISM if sides else CYL,
            (0, 0, (low + high) / 2),
            (below, below, (high - low) / 2),
            (above / below, sides or 1),
            material=colour if (k + first) % 2 and bands > 1 else white,
        )
    trim = colour if kit.chance(0.7) else dark
    kit.add(CYL, (0, 0, tall - 0.08), (top, top, 0.12), (1.4, 1), material=white)
    stage(kit, 0, 0, tall + 0.05, top * 1.5, trim, 0.22)
    lamp = top * rng.uniform(0.65, 0.85)
    kit.add(CYL, (0, 0, tall + 0.15), (lamp * 1.05, lamp * 1.05, 0.12), material=white if kit.chance(0.5) else trim)
    kit.add(CYL, (0, 0, tall + 0.5), (lamp, lamp, 0.28), material=kit.material(base=rng.choice([[0.1, 0.12, 0.14], [0.7, 0.65, 0.45]]), gloss=0.6, pattern=PLAIN))
    kit.add(TUBE, (0, 0, tall + 0.5), (lamp * 1.02, lamp * 1.02, 0.28), material=trim, cut=(BARS, 10, 0.12))
    if kit.chance(0.6):
        kit.add(BALL, (0, 0, tall + 0.78), (lamp * 1.12, lamp * 1.12, lamp * 0.75), material=trim)
    else:
        kit.add(CYL, (0, 0, tall + 0.78 + lamp * 0.4), (lamp * 1.2, lamp * 1.2, lamp * 0.4), (0.1, 1), material=trim)
    kit.add(BALL, (0, 0, tall + 0.8 + lamp * 0.8), (0.09, 0.09, 0.09), material=trim)
    kit.between((0, 0, tall + 0.8), (0, 0, tall + 1.1 + lamp), 0.018, material=dark)
    for share in (0.25, 0.5, 0.75):
        at = radius + (top - radius) * share
        kit.add(BOX, (at, 0, tall * share + 0.15), (0.05, 0.08, 0.14), material=dark)
        kit.add(BOX, (0, at, tall * share), (0.08, 0.05, 0.14), material=dark, mirror=True)
    kit.add(BOX, (radius * 1.0, 0, 0.42), (0.08, 0.15, 0.25), material=colour)
    if kit.chance(0.55):
        long, wide, high = rng.uniform(0.6, 1.1), rng.uniform(0.5, 0.7), rng.uniform(0.55, 0.8)
        x = -radius - long * 0.8
        kit.add(BOX, (x, 0, high / 2), (long, wide, high / 2), material=white)
        kit.add(BOX, (x, 0, high + 0.2), (long * 1.06, wide * 1.12, 0.2), (1, 0.02), material=tinted(kit, (RED, SLATE, TILE, RUST), (SHINGLES,)))
        for off in (-0.5, 0.4):
            kit.add(BOX, (x + off * long, wide, high * 0.55), (0.12, 0.02, 0.15), material=dark, mirror=True)
        kit.add(BOX, (x - long * 0.5, 0, high + 0.4), (0.09, 0.09, 0.22), material=tinted(kit, (BRICK, WHITE)))


def bus_shelter(kit):
    rng = kit.rng
    frame, dark = tinted(kit, (GREY, BLACK, GREEN, WHITE, RED, BLUE, WOOD)), kit.material(dark=True)
    glass, poster = (
        kit.material(base=rng.choice([[0.3, 0.36, 0.38], [0.5, 0.55, 0.55], [0.15, 0.18, 0.2]]), pattern=PLAIN, gloss=0.6),
        kit.material(pattern=rng.choice([CLOUDY, WRITING, PATCHWORK, PLAIN]), frequency=10),
    )
    wide, deep, high = rng.uniform(1.2, 2.2), rng.uniform(0.5, 0.75), rng.uniform(1.9, 2.3)
    kit.add(BOX, (0.1, 0, 0.05), (deep * 1.4, wide * 1.15, 0.05), material=tinted(kit, (CONCRETE, GREY), (CLOUDY, SEAMS)))
    solid = kit.chance(0.3)
    wall = tinted(kit, (WOOD, BRICK, CONCRETE, WHITE), (PLANKS, BRICKS, PLAIN), frequency=20)
    bays = int(rng.integers(2, 5))
    for y in np.linspace(-wide, wide, bays + 1):
        kit.add(BOX, (-deep, y, high / 2), (0.04, 0.04, high / 2), material=frame)
    for y in (-wide, wide) if kit.chance(0.7) else (-wide, 0, wide):
        kit.add(BOX, (deep, y, high / 2), (0.04, 0.04, high / 2), material=frame)
    foot = 0.1 if solid else 0.3
    kit.add(BOX, (-deep, 0, (foot + high) / 2), (0.05 if solid else 0.02, wide, (high - foot) / 2), material=wall if solid else glass)
    for y in (-1, 1):
        share = 1 if kit.chance(0.6) else 0.55
        panel = (wall, glass, poster)[0 if solid else 1 + int(kit.chance(0.4))]
        kit.add(BOX, (-deep + deep * share, y * wide, (foot + high) / 2), (deep * share, 0.05 if solid else 0.025, (high - foot) / 2 - 0.02), material=panel)
        kit.add(BOX, (-deep + deep * share, y * wide, foot), (deep * share, 0.04, 0.04), material=frame)
    kit.add(BOX, (-deep, 0, foot), (0.04, wide, 0.04), material=frame)
    roof = tinted(kit, (GREY, WHITE, GREEN, RED, BLUE, SLATE, WOOD), (PLAIN, RIBS, SHINGLES), gloss=0.3)
    kind = rng.choice(["flat", "curved", "gable"])
    if kind == "flat":
        kit.add(BOX, (0.08, 0, high + 0.06), (deep * 1.3, wide * 1.08, 0.06), rotation=turn("y", rng.uniform(-6, 4)), material=roof)
    elif kind == "curved":
        edge = np.linspace(-1, 1, 6)
        for a, b in zip(edge[:-1], edge[1:], strict=True):
            rise = 0.3 * deep
            za, zb = rise * (1 - a * a), rise * (1 - b * b)
            run = deep * 1.2 * (b - a)
            kit.add(
                BOX,
                (deep * 1.2 * (a + b) / 2, 0, high + (za + zb) / 2),
                (np.hypot(run, zb - za) / 2 * 1.04, wide * 1.06, 0.03),
                rotation=turn("y", -np.degrees(np.arctan2(zb - za, run))),
                material=roof,
            )
        kit.add(BOX, (0, 0, high), (deep, wide, 0.04), material=frame)
        for y in (-1, 1):
            kit.add(BOX, (0, y * wide, high + 0.13 * deep), (deep, 0.02, 0.15 * deep), (0.3, 1), material=glass)
    else:
        kit.add(BOX, (0, 0, high + 0.22), (deep * 1.25, wide * 1.08, 0.22), (0.02, 1) if kit.chance(0.6) else (0.2, 0.6), material=roof)
    kit.add(BOX, (-deep * 0.55, 0, 0.55), (deep * 0.28, wide * 0.7, 0.04), material=tinted(kit, (WOOD, GREY, RED, BLUE), (PLANKS, PLAIN)))
    for y in (-0.55, 0.55):
        kit.add(BOX, (-deep * 0.55, y * wide, 0.3), (deep * 0.2, 0.04, 0.25), material=dark)
    kit.add(BOX, (-deep + 0.04, wide * 0.5, high * 0.62), (0.02, wide * 0.2, high * 0.18), material=poster)
    if kit.chance(0.75):
        x, y = deep * 1.2, wide * 1.05
        kit.between((x, y, 0.05), (x, y, high * 1.25), 0.035, material=frame)
        if kit.chance(0.5):
            kit.add(CYL, (x, y + 0.02, high * 1.25), (0.26, 0.26, 0.025), rotation=ALONG_X, material=tinted(kit, (YELLOW, RED, BLUE, GREEN)))
        else:
            kit.add(BOX, (x, y + 0.18, high * 1.15), (0.025, 0.22, 0.2), material=tinted(kit, (BLUE, YELLOW, WHITE, RED)))
        kit.add(BOX, (x + 0.03, y, high * 0.65), (0.02, 0.13, 0.22), material=tinted(kit, (WHITE,), (WRITING,), second=[0.05] * 3))
    if kit.chance(0.5):
        kit.add(CYL, (deep * 0.8, -wide * 1.08, 0.4), (0.14, 0.14, 0.32), material=dark)


def toll(kit):
    rng = kit.rng
    roof, white, glass = tinted(kit, (WHITE, BLUE, GREEN, RED, GREY)), tinted(kit, (WHITE, GREY)), glazing(kit)
    booth = tinted(kit, (WHITE, YELLOW, BLUE, GREY, GREEN))
    lanes, pitch, high = int(rng.integers(2, 5)), rng.uniform(1.3, 1.7), rng.uniform(1.9, 2.4)
    wide = pitch * lanes / 2
    kit.add(BOX, (0, 0, 0.02), (1.9, wide + 0.5, 0.025), material=tinted(kit, (GREY, CONCRETE), (CLOUDY,)))
    islands = np.linspace(-wide, wide, lanes + 1)
    red, stripes = tinted(kit, (RED,)), tinted(kit, (YELLOW, WHITE), (STRIPES,), second=[0.03] * 3, frequency=25)
    for y in islands:
        kit.add(BOX, (0, y, 0.12), (1.6, 0.27, 0.1), material=white)
        kit.add(CYL, (1.6, y, 0.3), (0.25, 0.25, 0.3), material=stripes)
        kit.add(BOX, (0, y, 0.5), (0.42, 0.24, 0.3), material=booth)
        kit.add(BOX, (0, y, 0.98), (0.4, 0.225, 0.22), material=glass)
        kit.add(BOX, (0, y, 1.24), (0.48, 0.29, 0.06), material=booth)
        kit.add(BOX, (-0.75, y, high / 2), (0.09, 0.09, high / 2), material=white)
    kit.add(BOX, (-0.3, 0, high + 0.15), (1.1, wide + 0.6, 0.17), material=roof)
    kit.add(BOX, (-0.3, 0, high + 0.04), (1.0, wide + 0.5, 0.07), material=white)
    for k, y in enumerate((islands[:-1] + islands[1:]) / 2):
        kit.add(
            BOX,
            (0.82, y, high + 0.2),
            (0.02, 0.3, 0.14),
            material=tinted(kit, ((0.02, 0.3, 0.05), RED), (PLAIN,)) if kit.chance(0.6) else kit.material(base=BLACK, pattern=WRITING, second=[0.8, 0.6, 0.1]),
        )
        base = islands[k] + 0.22
        kit.add(BOX, (0.65, base, 0.4), (0.09, 0.07, 0.3), material=stripes)
        if kit.chance(0.7):
            kit.between((0.65, base, 0.62), (0.65, base + pitch * 0.62, 0.62), (0.04, 0.025), BOX, material=red)
        else:
            kit.between((0.65, base, 0.62), (0.65, base + 0.15, 0.62 + pitch * 0.6), (0.04, 0.025), BOX, material=red)
    if kit.chance(0.4):
        kit.add(BOX, (-0.3, 0, high + 0.5), (0.8, wide * 0.6, 0.22), material=roof)
