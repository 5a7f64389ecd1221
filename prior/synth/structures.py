"""Makers of storeyed, arched and open buildings: from pagodas and churches to play houses and gates."""

import numpy as np

from .kit import ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, PRISM, RUNGS, TUBE
from .materials import BRICKS, FACADE, LEDGES, PLANKS, RIBS, SHINGLES, WINDOWS, paint


def roof_material(kit):
    hue = kit.rng.choice([0.02, 0.06, 0.1, 0.35, 0.45, 0.6])
    base = paint(hue, kit.rng.uniform(0.1, 0.8), kit.rng.uniform(0.06, 0.6))
    pattern = kit.rng.choice([SHINGLES, SHINGLES, RIBS, BRICKS, 0])
    return kit.material(base=base, pattern=pattern, frequency=kit.rng.uniform(8, 26), gloss=kit.rng.uniform(0, 0.2))


def wall_material(kit):
    base = None if kit.chance(0.4) else np.clip(kit.rng.uniform(0.2, 0.85) * np.array([1, 0.93, 0.82]), 0, 0.95)
    pattern = kit.rng.choice([0, 1, BRICKS, PLANKS, FACADE, WINDOWS, LEDGES, 13])
    return kit.material(base=base, pattern=pattern, frequency=kit.rng.uniform(4, 18), gloss=0.02)


def storey(kit, sides, z, radius, height, material, taper=1.0):
    """A storey of the given radius to its sides' middle, square or round for sides of 4 or 0."""
    if sides == 4:
        kit.add(BOX, (0, 0, z + height / 2), (radius, radius, height / 2), (taper, taper), material=material)
    elif sides == 0:
        kit.add(CYL, (0, 0, z + height / 2), (radius, radius, height / 2), (taper, 1), material=material)
    else:
        kit.add(PRISM, (0, 0, z + height / 2), (radius, radius, height / 2), (taper, sides), material=material)


def tiered(kit):
    """Pagodas and many-storeyed pavilions: wide flared roofs over walls, posts and railings."""
    rng = kit.rng
    sides = int(rng.choice([4, 6, 8, 8, 0]))
    tiers = int(rng.integers(1, 6))
    radius = rng.uniform(0.9, 1.8)
    height = rng.uniform(0.5, 1.2)
    shrink = rng.uniform(0.78, 0.97)
    overhang = rng.uniform(1.18, 1.6)
    walls, roof, posts = wall_material(kit), roof_material(kit), kit.material()
    trim = kit.material()
    open_walls = kit.chance(0.4)
    columns = (sides or 8) if tiers < 4 else 0
    z = rng.uniform(0.1, 0.6)
    storey(kit, sides, 0, radius * rng.uniform(1.15, 1.6), z, kit.material(pattern=BRICKS))
    for tier in range(tiers):
        inner = radius * (0.72 if open_walls else 0.86)
        storey(kit, sides, z, inner, height, walls)
        if columns and kit.chance(0.8):
            first = 45 if sides == 4 else 180 / sides if sides else 0
            reach = radius * 0.97 * (1.41 if sides == 4 else 1.06)
            for x, y in around(columns, reach, first):
                kit.add(CYL, (x, y, z + height / 2), (0.05 * radius, 0.05 * radius, height / 2), material=posts)
        if kit.chance(0.6):
            share = (BARS, rng.integers(24, 60), rng.uniform(0.3, 0.6))
            kind, extra = (TUBE, 1) if sides in (0, 4) else (PRISM, sides)
            rail = (radius * 1.02, radius * 1.02, height * 0.14)
            kit.add(kind, (0, 0, z + height * 0.14), rail, (1, extra), material=trim, cut=share)
        z += height
        last = tier == tiers - 1
        eave = radius * overhang
        top = 0.02 if last else radius * shrink * 0.9 / eave
        rise = rng.uniform(0.25, 0.5) * radius * (2 if last else 1)
        storey(kit, sides, z - 0.03, eave * 1.01, 0.06 * radius, trim)
        storey(kit, sides, z, eave, rise * 0.35, roof, 0.55 if last else 0.5 + 0.5 * top)
        storey(kit, sides, z + rise * 0.35, eave * (0.55 if last else 0.5 + 0.5 * top), rise * 0.65, roof, max(0.02, top / 0.8))
        z += rise * (0.9 if last else 0.75)
        radius *= shrink
        height *= rng.uniform(0.85, 1)
    finial = rng.uniform(0.04, 0.09) * 1.5
    kit.loft((0, 0, z - 0.1), [(0, finial), (0.2, finial * 1.8), (0.35, finial * 0.7), (rng.uniform(0.5, 1), 0.01)], trim)


def pavilion(kit):
    """Gazebo, bandstand, bus shelter, carport: a roof on posts, with benches or rails between some."""
    rng = kit.rng
    wide, deep, height = rng.uniform(0.8, 2.2), rng.uniform(0.8, 1.6), rng.uniform(1.5, 2.8)
    posts, roof = kit.material(), roof_material(kit)
    round_plan = kit.chance(0.4)
    thick = rng.uniform(0.03, 0.1)
    if round_plan:
        sides = int(rng.choice([6, 8, 12]))
        feet = around(sides, wide)
        if kit.chance(0.6):
            kit.add(TUBE, (0, 0, 0.55), (wide, wide, 0.4), material=posts, cut=(BARS, sides * 6, 0.35))
        kit.add(PRISM, (0, 0, 0.08), (wide * 1.1, wide * 1.1, 0.08), (1, sides), material=kit.material())
        profile = [(0, wide * 1.25), (rng.uniform(0.2, 0.7), wide * 0.6), (rng.uniform(0.75, 1.6), 0.03)]
        kit.loft((0, 0, height), profile, roof, kind=PRISM, sides=sides)
    else:
        feet = [(x, y) for x in np.linspace(-wide, wide, int(rng.integers(2, 5))) for y in (-deep, deep)]
        gabled = kit.chance(0.6)
        rise = rng.uniform(0.3, 0.8) if gabled else 0.06
        taper = (rng.choice([1, 0.6]), 0.02) if gabled else (1, 1)
        kit.add(BOX, (0, 0, height + rise), (wide * 1.12, deep * 1.2, rise), taper, material=roof)
        if kit.chance(0.4):
            kit.add(BOX, (0, -deep, height * 0.5), (wide, 0.03, height * 0.45))
        if kit.chance(0.4):
            kit.add(BOX, (0, -deep * 0.6, 0.45), (wide * 0.8, 0.2, 0.04))
        if kit.chance(0.5):
            kit.add(BOX, (0, 0, 0.06), (wide * 1.1, deep * 1.1, 0.06))
    for x, y in feet:
        kit.add(CYL, (x, y, height / 2), (thick, thick, height / 2), material=posts)


def temple(kit):
    """Steps, columns all around or in front, a pediment."""
    rng = kit.rng
    long, deep, height = rng.uniform(1.5, 3), rng.uniform(1, 1.8), rng.uniform(1.2, 2.4)
    stone = kit.material(base=rng.uniform(0.35, 0.9) * np.array([1, 0.95, 0.85]), pattern=rng.choice([0, 1, 13]))
    for i in range(3):
        grow = 1.25 - 0.08 * i
        kit.add(BOX, (0, 0, 0.1 + 0.2 * i), (long * grow, deep * grow, 0.1), material=stone)
    count = int(rng.integers(4, 8))
    radius = rng.uniform(0.06, 0.13) * height
    for x in np.linspace(-long, long, count):
        kit.add(CYL, (x, deep, 0.6 + height / 2), (radius, radius, height / 2), (0.85, 1), material=stone, mirror=True)
    for y in np.linspace(-deep, deep, 4)[1:-1]:
        for x in (-long, long):
            kit.add(CYL, (x, y, 0.6 + height / 2), (radius, radius, height / 2), (0.85, 1), material=stone)
    if kit.chance(0.7):
        kit.add(BOX, (0, 0, 0.6 + height / 2), (long * 0.8, deep * 0.75, height / 2), material=wall_material(kit))
    z = 0.6 + height
    kit.add(BOX, (0, 0, z + 0.15), (long * 1.08, deep * 1.12, 0.15), material=stone)
    if kit.chance(0.75):
        rise = rng.uniform(0.2, 0.5)
        kit.add(BOX, (0, 0, z + 0.3 + rise), (long * 1.1, deep * 1.15, rise), (1, 0.02), material=roof_material(kit))
    if kit.chance(0.25):
        dome = rng.uniform(0.6, 0.9) * deep
        kit.add(BALL, (0, 0, z + 0.4), (dome, dome, dome), material=stone)


def church(kit):
    """Nave, steeple with a spire or an onion, apse, windows; or a mosque with a dome and minarets."""
    rng = kit.rng
    walls, roof, glass = wall_material(kit), roof_material(kit), kit.material(dark=True)
    long, deep, height = rng.uniform(1.5, 3), rng.uniform(0.7, 1.2), rng.uniform(0.8, 1.6)
    kit.add(BOX, (0, 0, height), (long, deep, height), material=walls)
    domed = kit.chance(0.3)
    if domed:
        dome = deep * rng.uniform(0.75, 1.05)
        kit.add(CYL, (0, 0, 2 * height + 0.1), (dome, dome, 0.25), material=walls)
        kit.add(BALL, (0, 0, 2 * height + 0.3), (dome, dome, dome * rng.uniform(0.8, 1.3)), material=roof)
    else:
        rise = rng.uniform(0.35, 0.8)
        kit.add(BOX, (0, 0, 2 * height + rise), (long * 1.04, deep * 1.1, rise), (1, 0.02), material=roof)
    count = int(rng.integers(2, 6))
    for x in np.linspace(-long * 0.75, long * 0.75, count):
        kit.add(BOX, (x, 0, height), (0.12, deep * 1.01, height * 0.5), material=glass)
        kit.add(CYL, (x, 0, height * 1.5), (0.12, 0.12, deep * 1.01), rotation=ALONG_Y, material=glass)
    spots = [(long, 0)] if kit.chance(0.6) else [(long, deep), (long, -deep)]
    tall = height * rng.uniform(1.6, 3)
    half = deep * rng.uniform(0.35, 0.6)
    for x, y in spots:
        kit.add(BOX, (x, y, tall), (half, half, tall), material=walls)
        kit.add(BOX, (x, y, tall * 1.7), (half * 1.02, half * 0.4, 0.25), material=glass)
        kit.add(BOX, (x, y, tall * 1.7), (half * 0.4, half * 1.02, 0.25), material=glass)
        spire = rng.uniform(0.6, 2.6)
        if domed and kit.chance(0.5):
            spire = half * 1.3
            kit.add(BALL, (x, y, 2 * tall), (half, half, spire), material=roof)
        else:
            sides = int(rng.choice([4, 6, 8]))
            kit.add(PRISM, (x, y, 2 * tall + spire / 2), (half * 1.1, half * 1.1, spire / 2), (0.02, sides), material=roof)
        kit.add(BOX, (x, y, 2 * tall + spire + 0.1), (0.02, 0.02, 0.25), material=glass)
    if kit.chance(0.4):
        kit.add(CYL, (-long, 0, height * 0.8), (deep * 0.7, deep * 0.7, height * 0.8), material=walls)
    kit.add(BOX, (long + half, 0, 0.5), (0.03, 0.25, 0.5), material=kit.material())
    church_wings(kit, long, deep, height, walls, roof, glass)


def church_wings(kit, long, deep, height, walls, roof, glass):
    """What stands beside a nave of half length `long`, half depth `deep` and half height `height`: a transept, a vestry or a chapel on
    one side, aisles under roofs that lean against it, a porch."""
    rng = kit.rng
    if kit.chance(0.3):
        x, wide, out, low = rng.uniform(-0.5, 0.4) * long, rng.uniform(0.35, 0.8), deep * rng.uniform(1.3, 2), height * rng.uniform(0.7, 1)
        rise = rng.uniform(0.3, 0.6)
        kit.add(BOX, (x, 0, low), (wide, out, low), material=walls)
        kit.add(BOX, (x, 0, 2 * low + rise), (wide * 1.12, out * 1.04, rise), (0.02, 1), material=roof)
        kit.add(BOX, (x, 0, low), (wide * 0.25, out * 1.01, low * 0.5), material=glass)
    elif kit.chance(0.3):
        out, low = deep * rng.uniform(0.3, 0.6), height * rng.uniform(0.45, 0.65)
        for side in (-1, 1):
            kit.add(BOX, (0, side * (deep + out / 2), low), (long * 0.95, out / 2, low), material=walls)
            # Its ridge is the nave's wall.
            kit.add(BOX, (0, side * (deep + out / 2), 2 * low + 0.15), (long, out * 0.55, 0.15), (1, 0.02), (0, -side * out * 0.5), material=roof)
    if kit.chance(0.4):
        side, x = rng.choice([-1, 1]), rng.uniform(-0.8, 0.6) * long
        wide, out, low = rng.uniform(0.3, 0.9), rng.uniform(0.3, 1.1), height * rng.uniform(0.4, 0.85)
        y = side * (deep + out)
        kit.add(BOX, (x, y, low), (wide, out, low), material=walls)
        rise = rng.uniform(0.2, 0.5)
        along = (0.02, 1) if kit.chance(0.6) else (0.3, 0.3)
        kit.add(BOX, (x, y, 2 * low + rise), (wide * 1.12, out * 1.08, rise), along, material=roof)
        kit.add(BOX, (x, y, low), (wide * 0.3, out * 1.01, low * 0.5), material=glass)
        kit.add(BOX, (x, y, low), (wide * 1.01, out * 0.3, low * 0.5), material=glass)


def castle(kit):
    """Walls and towers with battlements, a gate, pointed roofs on some towers."""
    rng = kit.rng
    stone = kit.material(base=rng.uniform(0.15, 0.6) * np.array([1, 0.93, 0.82]), pattern=BRICKS, frequency=rng.uniform(8, 20))
    roof = roof_material(kit)
    half_x, half_y, height = rng.uniform(1, 2), rng.uniform(0.8, 1.6), rng.uniform(0.5, 1)
    for y in (-half_y, half_y):
        kit.add(BOX, (0, y, height), (half_x, 0.12, height), material=stone)
        kit.add(BOX, (0, y, 2 * height + 0.08), (half_x, 0.1, 0.1), material=stone, cut=(BARS, 4, 0.55))
    for x in (-half_x, half_x):
        kit.add(BOX, (x, 0, height), (0.12, half_y, height), material=stone)
        kit.add(BOX, (x, 0, 2 * height + 0.08), (0.1, half_y, 0.1), material=stone, cut=(BARS, 4, 0.55))
    kind = CYL if kit.chance(0.7) else BOX
    tower = rng.uniform(0.2, 0.4)
    pointed = kit.chance(0.5)
    for x in (-half_x, half_x):
        for y in (-half_y, half_y):
            tall = height * rng.uniform(1.2, 1.9)
            kit.add(kind, (x, y, tall), (tower, tower, tall), material=stone)
            if pointed:
                kit.add(CYL, (x, y, 2 * tall + 0.35), (tower * 1.15, tower * 1.15, 0.35), (0.02, 1), material=roof)
            else:
                kit.add(TUBE, (x, y, 2 * tall + 0.08), (tower, tower, 0.1), material=stone, cut=(BARS, 8, 0.6))
    keep = rng.uniform(0.4, 0.7)
    kit.add(BOX, (-0.2, 0, height * 1.6), (keep, keep, height * 1.6), material=stone)
    if pointed:
        kit.add(BOX, (-0.2, 0, height * 3.2 + 0.3), (keep * 1.1, keep * 1.1, 0.3), (0.3, 0.02), material=roof)
    kit.add(BOX, (half_x, 0, height * 0.5), (0.14, 0.25, height * 0.5), material=kit.material(dark=True))


def play_house(kit):
    """Platforms on posts with rails, a ladder, a slide, a gabled roof; swings beside some."""
    rng = kit.rng
    wood = kit.material(base=rng.uniform(0.5, 1.4) * np.array([0.5, 0.36, 0.22]), pattern=rng.choice([0, 1, PLANKS]))
    if kit.chance(0.35):
        wood = kit.material()
    paint_one, roof = kit.material(), roof_material(kit)
    half, deck, post = rng.uniform(0.5, 0.8), rng.uniform(0.7, 1.5), rng.uniform(0.035, 0.07)
    roofed = kit.chance(0.8)
    top = deck + (rng.uniform(1, 1.4) if roofed else 0.6)
    for x in (-half, half):
        kit.add(BOX, (x, half, top / 2), (post, post, top / 2), material=wood, mirror=True)
    kit.add(BOX, (0, 0, deck), (half, half, 0.04), material=wood)
    if roofed:
        rise = rng.uniform(0.2, 0.4)
        turned = turn("z", 90) if kit.chance(0.5) else None
        taper = (1, 0.02) if kit.chance(0.8) else (0.02, 0.02)
        kit.add(BOX, (0, 0, top + rise), (half * 1.2, half * 1.25, rise), taper, rotation=turned, material=roof)
    rail = kit.chance(0.5)
    sides = [((-half, -half), (half, -half)), ((-half, half), (half, half)), ((-half, -half), (-half, half))]
    for (x0, y0), (x1, y1) in sides:
        if kit.chance(0.75):
            if rail:
                kit.railing((x0, y0, deck), (x1, y1, deck), 0.45, wood, rng.uniform(0.08, 0.2))
            else:
                kit.add(BOX, ((x0 + x1) / 2, (y0 + y1) / 2, deck + 0.22), (abs(x1 - x0) / 2 + 0.02, abs(y1 - y0) / 2 + 0.02, 0.2), material=paint_one)
    if kit.chance(0.45):  # a second, open deck
        kit.add(BOX, (-2.3 * half, 0, deck * 0.9), (half * 1.2, half, 0.04), material=wood)
        for x in (-3.4 * half,):
            kit.add(BOX, (x, half, deck * 0.75), (post, post, deck * 0.75), material=wood, mirror=True)
        for y in (-half, half):
            kit.railing((-3.4 * half, y, deck * 0.9), (-half, y, deck * 0.9), 0.45, wood, rng.uniform(0.08, 0.2))
    slide_end = half + deck * rng.uniform(1.1, 1.7)
    kit.between((half, 0, deck), (half + 0.35 * (slide_end - half), 0, deck * 0.62), (0.02, 0.22), BOX, material=paint_one)
    kit.between((half + 0.35 * (slide_end - half), 0, deck * 0.62), (slide_end, 0, 0.1), (0.02, 0.22), BOX, material=paint_one)
    kit.between((half, 0.22, deck + 0.08), (slide_end, 0.22, 0.16), (0.07, 0.02), BOX, material=paint_one, mirror=True)
    foot = -half - deck * rng.uniform(0.2, 0.6)
    place = ((foot, 0, 0), (-half, 0, deck)) if kit.chance(0.5) else ((0, foot, 0), (0, -half, deck))
    start, end = (np.array(p) for p in place)
    kit.between(start, end, (0.03, 0.25), BOX, material=wood, cut=(RUNGS, rng.uniform(3, 5), 0.25))
    if kit.chance(0.35):
        swing(kit, (0, half + 0.2, 0), wood)


def swing(kit, base, material):
    """A beam on two trestles beside `base`, seats hanging from it."""
    x, y, _ = base
    height, long = kit.rng.uniform(1.6, 2.2), kit.rng.uniform(1.2, 2.2)
    kit.between((x, y, height), (x, y + long, height), 0.05, material=material)
    for side in (-0.6, 0.6):
        kit.between((x + side, y + long, 0), (x, y + long, height), 0.045, material=material)
    for k in (0.3, 0.7):
        for off in (-0.15, 0.15):
            kit.between((x, y + k * long + off, height), (x, y + k * long + off, 0.5), 0.012)
        kit.add(BOX, (x, y + k * long, 0.5), (0.1, 0.2, 0.025))


def gabled_house(kit):
    """A house as children draw it, with porch, dormers, shutters, chimney and steps."""
    rng = kit.rng
    walls, roof, trim, glass = wall_material(kit), roof_material(kit), kit.material(), kit.material(dark=True, gloss=0.4)
    half_x, half_y, storeys = rng.uniform(1.2, 2.6), rng.uniform(0.9, 1.7), int(rng.integers(1, 4))
    height = storeys * rng.uniform(0.9, 1.2)
    kit.add(BOX, (0, 0, height / 2), (half_x, half_y, height / 2), material=walls)
    rise = rng.uniform(0.3, 1.0)
    hipped = rng.choice([1, 1, 0.5])
    kit.add(BOX, (0, 0, height + rise / 2), (half_x * 1.1, half_y * 1.15, rise / 2), (hipped, 0.02), material=roof)
    count = int(rng.integers(2, 5))
    for level in range(storeys):
        z = (level + 0.55) * height / storeys
        for i in range(count):
            x = half_x * (2 * (i + 0.5) / count - 1)
            size = (half_x * 0.3 / count * rng.uniform(0.8, 1.4), height / storeys * 0.22)
            kit.add(BOX, (x, 0, z), (size[0], half_y * 1.012, size[1]), material=glass)
            if storeys * count < 8:
                kit.add(BOX, (x, 0, z), (size[0] * 1.25, half_y * 1.006, size[1] * 1.2), material=trim)
        for y in (-0.5, 0.5):
            kit.add(BOX, (0, y * half_y, z), (half_x * 1.012, half_y * 0.14, height / storeys * 0.22), material=glass)
    kit.add(BOX, (half_x * rng.uniform(-0.4, 0.4), half_y, 0.42), (0.24, 0.05, 0.42), material=kit.material())
    if kit.chance(0.5):  # porch
        deep = rng.uniform(0.4, 0.9)
        kit.add(BOX, (0, half_y + deep / 2, 0.06), (half_x * 0.9, deep / 2 + 0.05, 0.06), material=trim)
        kit.add(BOX, (0, half_y + deep / 2, 1.0), (half_x * 0.95, deep / 2 + 0.1, 0.05), material=roof)
        for x in np.linspace(-0.85, 0.85, int(rng.integers(2, 5))):
            kit.add(CYL, (x * half_x, half_y + deep * 0.9, 0.5), (0.05, 0.05, 0.5), material=trim)
        if kit.chance(0.5):
            kit.railing((-half_x * 0.85, half_y + deep * 0.9, 0.12), (-0.3, half_y + deep * 0.9, 0.12), 0.35, trim, 0.12)
    if kit.chance(0.4):
        for x in (-half_x * 0.5, half_x * 0.5):
            kit.add(BOX, (x, half_y * 0.6, height + rise * 0.35), (0.25, half_y * 0.4, 0.2), material=walls)
            kit.add(BOX, (x, half_y * 0.6, height + rise * 0.35 + 0.28), (0.3, half_y * 0.45, 0.1), (0.02, 1), material=roof)
    if kit.chance(0.6):
        kit.add(BOX, (half_x * rng.uniform(-0.7, 0.7), half_y * 0.3, height + rise), (0.14, 0.14, 0.4), material=trim)
    if kit.chance(0.35):  # a wing or a garage
        y = half_y * rng.uniform(0.6, 1.2)
        kit.add(BOX, (-half_x, y, height * 0.3), (half_x * 0.6, half_y * 0.7, height * 0.3), material=walls)
        kit.add(BOX, (-half_x, y, height * 0.6 + 0.2), (half_x * 0.65, half_y * 0.8, 0.2), (1, 0.02), material=roof)


def block(kit):
    """Flats, offices, shops: boxes with rows of windows, balconies, ledges and signs; often one façade only."""
    rng = kit.rng
    half_x, half_y, height = rng.uniform(0.8, 2.5), rng.uniform(0.3, 1.6), rng.uniform(1, 4)
    walls = wall_material(kit)._replace(pattern=int(rng.choice([FACADE, WINDOWS, 0, BRICKS])))
    trim, glass = kit.material(), kit.material(dark=True, gloss=0.5)
    kit.add(BOX, (0, 0, height / 2), (half_x, half_y, height / 2), material=walls)
    rows, columns = int(rng.integers(2, 6)), int(rng.integers(2, 6))
    for row in range(rows):
        z = height * (row + 0.6) / rows
        if walls.pattern in (0, BRICKS):
            for i in range(columns):
                x = half_x * (2 * (i + 0.5) / columns - 1)
                kit.add(BOX, (x, 0, z), (half_x * rng.uniform(0.25, 0.4) / columns * 2, half_y * 1.01, height / rows * 0.28), material=glass)
        if kit.chance(0.4):
            kit.add(BOX, (0, 0, z - 0.45 * height / rows), (half_x * 1.02, half_y * 1.03, 0.03), material=trim)
        if kit.chance(0.4):
            kit.add(BOX, (0, half_y + 0.12, z - 0.3 * height / rows), (half_x * 0.8, 0.12, 0.02), material=trim)
            foot = z - 0.28 * height / rows
            kit.railing((-half_x * 0.8, half_y + 0.23, foot), (half_x * 0.8, half_y + 0.23, foot), 0.2, trim, 0.08)
    kit.add(BOX, (0, 0, height + 0.06), (half_x * 1.03, half_y * 1.05, 0.08), material=trim)
    if kit.chance(0.4):
        sign = kit.material(pattern=14, frequency=rng.uniform(8, 20))
        kit.add(BOX, (0, half_y, height * 0.3), (half_x * 0.7, 0.05, 0.15), material=sign)
    for _ in range(rng.integers(0, 4)):
        place = (rng.uniform(-0.8, 0.8) * half_x, rng.uniform(-0.6, 0.6) * half_y, height + 0.2)
        kit.add(BOX, place, rng.uniform(0.08, 0.3, 3))


def arch(kit):
    """Gates, triumphal arches, short bridges: an opening under a half ring or a beam."""
    rng = kit.rng
    stone = wall_material(kit)
    opening, height, thick, deep = rng.uniform(0.5, 1.4), rng.uniform(0.8, 2), rng.uniform(0.15, 0.6), rng.uniform(0.12, 0.6)
    pillar = kit.chance(0.5)
    for side in (-1, 1):
        y = side * (opening + thick)
        if pillar:
            kit.add(CYL, (0, y, height / 2), (thick * 0.7, thick * 0.7, height / 2), material=stone)
        else:
            kit.add(BOX, (0, y, height / 2), (deep, thick, height / 2), material=stone)
    if kit.chance(0.65):
        count = 9
        angles = np.linspace(0, np.pi, count + 1)
        radius = opening + thick * 0.6
        for a, b in zip(angles[:-1], angles[1:], strict=True):
            start = (0, radius * np.cos(a), height + radius * np.sin(a) * 0.95)
            end = (0, radius * np.cos(b), height + radius * np.sin(b) * 0.95)
            kit.between(start, end, (thick * 0.6, deep), BOX, material=stone)
        if kit.chance(0.6):
            z = height + radius
            kit.add(BOX, (0, 0, z + 0.3), (deep * 1.05, opening + 2 * thick, 0.25), material=stone)
            kit.add(BOX, (0, 0, z + 0.58), (deep * 1.2, opening + 2.2 * thick, 0.05), material=kit.material())
            for side in (-1, 1):
                kit.add(BOX, (0, side * (opening + 1.3 * thick), height * 0.5 + z * 0.5), (deep, thick * 0.7, (z - height) / 2 + 0.1), material=stone)
    else:
        for k in range(int(rng.integers(1, 3))):
            z = height - 0.45 * k
            long = (opening + 2 * thick) * (1.25 - 0.15 * k)
            kit.add(BOX, (0, 0, z), (deep * 0.6, long, rng.uniform(0.06, 0.15)), material=stone)
        if kit.chance(0.5):
            kit.add(BOX, (0, 0, height + 0.25), (deep * 1.6, opening + 2.5 * thick, 0.2), (0.4, 0.9), material=roof_material(kit))
