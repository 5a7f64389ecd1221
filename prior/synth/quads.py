"""Quads, buggies, snowmobiles, jet skis, karts, mowers."""

from .cycle_parts import RED, WHITE, fins, flat, lacquer
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, SPOKES
from .materials import CHECKER, PLAIN, RIBS, WRITING
from .roadcraft import arch, chrome, hide, rubber, section, slab, steering
from .wheeled import glazing


def fat_wheels(kit, x, y, radius, half, tyre, hub, spokes=0):
    """A pair of tyres with rounded shoulders on small rims."""
    kit.add(CYL, (x, y, radius), (radius, radius, half * 0.7), rotation=ALONG_Y, material=tyre, mirror=True)
    kit.add(CYL, (x, y, radius), (radius * 0.9, radius * 0.9, half), rotation=ALONG_Y, material=tyre, mirror=True)
    kit.add(CYL, (x, y, radius), (radius * 0.52, radius * 0.52, half * 1.04), rotation=ALONG_Y, material=hub, mirror=True, cut=(SPOKES, spokes, 0.3) if spokes else (0, 1, 1))


def treads(kit):
    return kit.material(base=[0.03] * 3, pattern=CHECKER, frequency=kit.rng.uniform(20, 32), second=[0.008] * 3, gloss=0.02)


def quad(kit):
    """A quad: a sporty one with pointed nose and bumper, or a farmer's with racks."""
    rng = kit.rng
    coat, dark, tyre, metal = lacquer(kit), kit.material(dark=True, pattern=PLAIN), treads(kit), chrome(kit)
    work = kit.chance(0.5)
    base, track, radius = rng.uniform(0.6, 0.68), rng.uniform(0.42, 0.5), rng.uniform(0.28, 0.33)
    z = 2 * radius
    for x, half in ((base, 0.1), (-base, 0.13)):
        fat_wheels(kit, x, track, radius * (1 if work or x > 0 else 0.92), half, tyre, metal if kit.chance(0.6) else dark, int(rng.choice([0, 4, 5, 6, 8])))
    kit.between((-base, -track, radius * 0.95), (-base, track, radius * 0.95), 0.05, material=dark)
    for dx in (-0.12, 0.12):
        kit.between((base * 0.9 + dx, 0.1, radius), (base, track - 0.06, radius), 0.018, material=metal, mirror=True)
    kit.between((base * 0.85, 0.13, z + 0.12), (base * 0.98, track * 0.68, radius + 0.04), 0.035, material=fins(kit, [0.6, 0.1, 0.03]), mirror=True)
    kit.add(BOX, (0.0, 0, radius + 0.1), (base * 0.85, 0.12, 0.13), material=dark)
    kit.add(BOX, (0, 0, radius + 0.16), (0.2, 0.17, 0.14), material=fins(kit))
    nose = base + radius * (1.0 if work else 1.15)
    if work:
        section(kit, 0.3, nose, (z - 0.04, z + 0.16, 0.34), (z - 0.06, z + 0.08, 0.3), coat)
        section(kit, -nose, -0.35, (z - 0.06, z + 0.1, 0.34), (z - 0.06, z + 0.13, 0.32), coat)
        for x in (base, -base):
            arch(kit, x, track, radius + 0.02, radius + 0.08, 0.13, 25, 155, 3, coat)
            kit.add(BOX, (x * 1.02, 0, z + 0.25), (0.3, track * 0.95, 0.012), material=dark, cut=(BARS, 12, 0.3))
            kit.between((x, track * 0.5, z + 0.05), (x, track * 0.6, z + 0.25), 0.014, material=dark, mirror=True)
    else:
        section(kit, 0.25, nose, (z - 0.06, z + 0.16, 0.14), (z - 0.06, z - 0.0, 0.07), coat)
        section(kit, base - radius * 1.3, base + radius, (z + 0.01, z + 0.06, 0.18), (z + 0.03, z + 0.07, 0.16), coat, track * 0.56, True)
        section(kit, -nose, -base + radius * 1.3, (z + 0.1, z + 0.13, 0.34), (z - 0.0, z + 0.04, 0.3), coat)
    kit.add(BALL, (0.2, 0, z + 0.14), (0.24, 0.14, 0.13), material=coat)
    section(kit, -base - 0.1, 0.08, (z + 0.02, z + 0.2, 0.14), (z - 0.06, z + 0.14, 0.12), hide(kit))
    kit.add(BOX, (0.02, track * 0.78, radius * 0.75), (base - radius * 0.8, 0.11, 0.022), material=dark, mirror=True)
    kit.between((0.0, -track * 0.7, radius * 0.75), (0, track * 0.7, radius * 0.75), 0.03, material=dark)
    kit.between((0.42, 0, z + 0.05), (0.32, 0, z + 0.36), 0.03, material=dark)
    kit.between((0.32, 0, z + 0.36), (0.24, 0.38, z + 0.42), 0.018, material=dark, mirror=True)
    kit.add(BOX, (0.35, 0, z + 0.36), (0.05, 0.1, 0.06), (0.7, 0.9), material=coat)
    for a, e in (((nose - 0.15, 0.1, radius), (nose + 0.08, 0.13, z - 0.05)), ((nose - 0.1, -0.14, z - 0.06), (nose + 0.08, -0.14, z - 0.05))):
        kit.between(a, e, 0.016, material=metal, mirror=True)
    kit.between((nose + 0.08, -0.15, z - 0.05), (nose + 0.08, 0.15, z - 0.05), 0.018, material=metal)
    kit.add(BALL, (nose - 0.08, 0.1 if not work else 0.22, z + 0.03), (0.06, 0.045, 0.035), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.between((-0.1, -0.17, z - 0.08), (-base - 0.2, -0.17, z + 0.02), 0.05, material=metal)
    kit.add(BOX, (-nose + 0.03, 0, z + 0.06), (0.03, 0.06, 0.03), material=flat(kit, RED))


def buggy(kit):
    """A side-by-side with doors, cage, roof and a bed behind, or a sand rail: bare tubes, engine and big wheels behind."""
    rng = kit.rng
    coat, dark, tyre, metal, cloth = lacquer(kit), kit.material(dark=True, pattern=PLAIN), treads(kit), chrome(kit), hide(kit)
    rail = kit.chance(0.4)
    tube = (coat if kit.chance(0.7) else metal) if rail else (dark if kit.chance(0.7) else coat)
    base, track, radius = rng.uniform(1.05, 1.25), rng.uniform(0.68, 0.78), rng.uniform(0.34, 0.4)
    small = radius * (0.85 if rail else 1)
    fat_wheels(kit, base, track, small, 0.09 if rail else 0.13, tyre, metal, int(rng.integers(4, 8)))
    fat_wheels(kit, -base, track, radius, 0.17 if rail else 0.14, tyre, metal, int(rng.integers(4, 8)))
    floor, belt, roof, wide = 0.38, 0.88, rng.uniform(1.65, 1.8), 0.62
    kit.add(BOX, (0, 0, floor), (base * 0.9, 0.45, 0.05), material=dark)
    for x, r in ((base, small), (-base, radius)):
        for dx in (-0.16, 0.12):
            kit.between((x + dx, 0.25, r + 0.06), (x, track - 0.08, r), 0.022, material=metal, mirror=True)
        kit.between(
            (x * 0.95, 0.4, belt - 0.05),
            (x, track - 0.16, r + 0.03),
            0.04,
            material=fins(kit, rng.choice([[0.6, 0.1, 0.03], [0.6, 0.5, 0.05], [0.1, 0.2, 0.5]])),
            mirror=True,
        )
    front, back = 0.35, -0.55
    kit.between((front + 0.4, wide, belt), (front, wide * 0.85, roof), 0.028, material=tube, mirror=True)
    kit.between((front, wide * 0.85, roof), (back, wide * 0.85, roof), 0.028, material=tube, mirror=True)
    kit.between((back, wide * 0.85, roof), (back - 0.12, wide * 0.95, floor), 0.028, material=tube, mirror=True)
    kit.between((back, wide * 0.85, roof - 0.05), (-base - 0.1, wide * 0.7, belt), 0.026, material=tube, mirror=True)
    for x in (front, back):
        kit.between((x, -wide * 0.86, roof), (x, wide * 0.86, roof), 0.028, material=tube)
    kit.add(BOX, (-0.15, 0.3, floor + 0.15), (0.25, 0.2, 0.1), material=cloth, mirror=True)
    kit.add(BOX, (-0.42, 0.3, floor + 0.52), (0.06, 0.2, 0.36), (1, 0.75), (-0.12, 0), material=cloth, mirror=True)
    steering(kit, 0.3, 0.3, belt + 0.06, dark, 0.16)
    if rail:
        nose = base + 0.35
        for z in (floor, belt):
            kit.between((front + 0.4, wide, z), (nose, 0.18, z * 0.5 + 0.22), 0.026, material=tube, mirror=True)
            kit.between((-base - 0.1, wide * 0.7, z), (front + 0.4, wide, z), 0.026, material=tube, mirror=True)
        kit.between((nose, -0.2, 0.42), (nose, 0.2, 0.42), 0.026, material=tube)
        section(kit, 0.5, nose - 0.03, (floor, belt - 0.02, 0.42), (0.38, 0.6, 0.15), coat)
        kit.add(BOX, (-base, 0, 0.55), (0.3, 0.2, 0.18), material=fins(kit))
        kit.add(CYL, (-base, 0.3, 0.55), (0.1, 0.1, 0.1), rotation=ALONG_Y, material=fins(kit), mirror=True)
        kit.add(CYL, (-base - 0.12, 0, 0.8), (0.13, 0.13, 0.12), material=metal)
        kit.between((-base - 0.2, 0.15, 0.5), (-base - 0.42, 0.18, 0.85), 0.04, material=metal, mirror=True)
    else:
        nose = base + radius + 0.05
        section(kit, 0.5, nose, (floor, belt + 0.08, wide * 0.85), (0.5, 0.74, wide * 0.6), coat)
        for x in (base, -base):
            arch(kit, x, track - 0.02, radius + 0.04, radius + 0.1, 0.14, 25, 155, 3, dark if kit.chance(0.5) else coat)
        kit.add(BOX, (0.08, wide, floor + 0.24), (0.42, 0.025, 0.22), (1.1, 1), material=coat, mirror=True)
        section(kit, -base - 0.5, -0.75, (0.62, 0.98, wide), (0.6, 0.98, wide), dark)
        section(kit, -base - 0.52, -0.72, (0.86, 1.0, wide * 1.03), (0.86, 1.02, wide * 1.03), coat)
        kit.add(BOX, (-0.1, 0, roof + 0.04), (0.52, wide * 0.92, 0.03), (0.95, 0.92), material=coat if kit.chance(0.6) else dark)
        kit.add(BOX, (nose - 0.06, 0.26, 0.72), (0.06, 0.12, 0.04), (0.8, 0.8), material=flat(kit, WHITE, 0.6), mirror=True)
        kit.between((nose + 0.02, -0.3, 0.5), (nose + 0.02, 0.3, 0.5), 0.03, material=tube)
        if kit.chance(0.4):
            kit.between((front + 0.36, 0, belt + 0.08), (front + 0.04, 0, roof - 0.05), (0.01, wide * 0.85), BOX, 0.95, glazing(kit))
    if kit.chance(0.5):
        kit.add(BOX, (front + 0.05, 0, roof + 0.07), (0.03, wide * 0.7, 0.04), material=flat(kit, WHITE, 0.6))
    kit.add(BOX, (-base - (0.1 if rail else 0.52), wide * 0.7, belt - 0.05), (0.03, 0.05, 0.05), material=flat(kit, RED), mirror=True)


def snowmobile(kit):
    """A snowmobile: track round its wheels under a tunnel, long saddle, wedge of a hood, screen, two skis on arms."""
    rng = kit.rng
    coat, second, dark, metal = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit)
    track = kit.material(base=[0.015] * 3, pattern=RIBS, frequency=22, second=[0.06] * 3)
    wide, rear, ski_x, apart = 0.2, -rng.uniform(1.25, 1.6), rng.uniform(0.72, 0.85), rng.uniform(0.46, 0.54)
    section(kit, rear + 0.12, 0.1, (0.0, 0.26, wide * 0.9), (0.0, 0.36, wide * 0.9), track)
    kit.add(CYL, (rear + 0.13, 0, 0.14), (0.14, 0.14, wide * 0.9), rotation=ALONG_Y, material=track)
    section(kit, 0.09, 0.38, (0.0, 0.36, wide * 0.9), (0.16, 0.44, wide * 0.9), track)
    kit.add(CYL, (rear + 0.14, wide * 0.86, 0.14), (0.09, 0.09, 0.02), rotation=ALONG_Y, material=metal, mirror=True)
    kit.between((rear + 0.14, wide * 0.88, 0.07), (0.05, wide * 0.88, 0.07), (0.03, 0.02), BOX, material=metal, mirror=True)
    section(kit, rear - 0.1, 0.2, (0.38, 0.44, wide), (0.38, 0.48, wide * 1.1), metal if kit.chance(0.5) else dark)
    kit.add(BOX, (-0.1, 0.3, 0.36), (0.45, 0.1, 0.02), material=dark, mirror=True)
    section(kit, rear + 0.1, 0.02, (0.43, 0.64, 0.15), (0.43, 0.7, 0.13), hide(kit))
    section(kit, -0.02, 0.4, (0.4, 0.78, 0.16), (0.3, 0.88, 0.26), coat)
    section(kit, 0.38, rng.uniform(1.0, 1.15), (0.22, 0.88, 0.34), (0.34, 0.52, 0.16), coat)
    section(kit, 0.1, 0.9, (0.24, 0.5, 0.3), (0.26, 0.46, 0.24), second)
    kit.between((0.6, 0, 0.78), (0.36, 0, rng.uniform(0.98, 1.2)), (0.01, 0.24), BOX, 0.75, glazing(kit))
    kit.add(BOX, (0.86, 0.12, 0.64), (0.08, 0.08, 0.03), rotation=turn("y", 30), material=flat(kit, WHITE, 0.6), mirror=True)
    kit.between((0.2, 0, 0.7), (0.1, 0, 0.98), 0.03, material=dark)
    kit.between((0.1, 0, 0.97), (0.02, 0.36, 1.0), 0.02, material=dark, mirror=True)
    kit.add(BOX, (ski_x - 0.1, apart, 0.025), (0.42, 0.075, 0.015), material=second, mirror=True)
    kit.between((ski_x + 0.3, apart, 0.02), (ski_x + 0.52, apart, 0.16), (0.014, 0.07), BOX, 0.8, second, True)
    kit.between((ski_x + 0.51, apart, 0.16), (ski_x + 0.2, apart, 0.13), (0.01, 0.03), BOX, material=dark, mirror=True)
    kit.between((ski_x + 0.2, apart, 0.13), (ski_x + 0.1, apart, 0.03), (0.01, 0.03), BOX, material=dark, mirror=True)
    kit.between((ski_x, apart, 0.03), (ski_x - 0.06, apart - 0.02, 0.34), 0.032, material=dark, mirror=True)
    for dx, dz in ((-0.18, 0.02), (0.1, 0.02), (-0.04, 0.14)):
        kit.between((ski_x - 0.08 + dx, 0.2, 0.32 + dz), (ski_x - 0.05, apart - 0.02, 0.24 + dz * 0.3), 0.018, material=metal, mirror=True)
    kit.between((ski_x - 0.1, 0.22, 0.56), (ski_x - 0.05, apart - 0.06, 0.26), 0.036, material=fins(kit, [0.6, 0.1, 0.03]), mirror=True)
    kit.add(BOX, (rear + 0.09, 0, 0.57), (0.02, 0.1, 0.03), material=flat(kit, RED))
    kit.between((rear - 0.08, wide * 0.8, 0.42), (rear - 0.2, wide * 0.8, 0.5), 0.014, material=metal, mirror=True)
    kit.between((rear - 0.2, -wide * 0.8, 0.5), (rear - 0.2, wide * 0.8, 0.5), 0.014, material=metal)
    kit.between((rear - 0.02, 0, 0.4), (rear - 0.12, 0, 0.12), (0.008, wide), BOX, material=dark)


def jet_ski(kit):
    """A water scooter with V hull, stepped saddle and cowl with mirrors, alone or on a trailer with wheels and winch post."""
    rng = kit.rng
    coat, second, dark, metal = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit)
    up = 0.34 if kit.chance(0.5) else 0.0
    rear, nose, wide = -1.35, rng.uniform(1.45, 1.65), rng.uniform(0.5, 0.58)
    if up:
        kit.add(BOX, (-0.3, 0.16, up + 0.03), (0.9, 0.05, 0.04), material=kit.material(base=[0.1, 0.1, 0.12], pattern=PLAIN), mirror=True)
        kit.between((-1.3, 0.45, 0.28), (0.7, 0.45, 0.28), 0.035, BOX, material=metal, mirror=True)
        kit.between((0.65, 0.46, 0.28), (1.9, 0, 0.3), 0.035, BOX, material=metal, mirror=True)
        kit.between((1.8, 0, 0.3), (2.3, 0, 0.32), 0.035, BOX, material=metal)
        for x in (-1.2, -0.35, 0.55):
            kit.between((x, -0.45, 0.28), (x, 0.45, 0.28), 0.03, BOX, material=metal)
        kit.between((-0.4, -0.75, 0.24), (-0.4, 0.75, 0.24), 0.03, material=metal)
        fat_wheels(kit, -0.4, 0.74, 0.24, 0.08, rubber(kit), metal)
        arch(kit, -0.4, 0.74, 0.26, 0.3, 0.1, 10, 170, 3, dark)
        kit.between((1.75, 0, 0.3), (1.68, 0, up + 0.5), 0.04, BOX, material=metal)
        kit.between((2.15, 0.07, 0.3), (2.15, 0.07, 0.0), 0.025, material=metal)
    section(kit, rear, 0.4, (up, up + 0.34, wide * 0.55), (up, up + 0.36, wide * 0.55), second)
    slab(kit, up + 0.1, up + 0.36, (rear, 0.5, wide * 0.5), (rear, 0.75, wide), second)
    section(kit, 0.38, nose, (up + 0.02, up + 0.38, wide * 0.7), (up + 0.36, up + 0.5, 0.06), second)
    section(kit, rear - 0.02, 0.6, (up + 0.33, up + 0.4, wide * 1.03), (up + 0.34, up + 0.42, wide * 1.03), dark)
    section(kit, 0.59, nose + 0.03, (up + 0.34, up + 0.46, wide * 1.03), (up + 0.46, up + 0.52, 0.08), coat)
    section(kit, rear + 0.1, 0.5, (up + 0.38, up + 0.5, wide * 0.9), (up + 0.4, up + 0.56, wide * 0.95), coat)
    section(kit, 0.25, nose - 0.12, (up + 0.42, up + 0.86, 0.3), (up + 0.44, up + 0.52, 0.1), coat)
    section(kit, -0.95, 0.2, (up + 0.44, up + 0.7, 0.2), (up + 0.44, up + 0.68, 0.2), coat)
    section(kit, -0.35, 0.28, (up + 0.68, up + 0.8, 0.19), (up + 0.66, up + 0.8, 0.15), dark)
    section(kit, -1.0, -0.3, (up + 0.68, up + 0.88, 0.19), (up + 0.68, up + 0.86, 0.19), hide(kit))
    kit.between((0.45, 0, up + 0.76), (0.28, 0, up + 1.0), (0.08, 0.09), BOX, 0.8, dark)
    kit.between((0.28, 0, up + 0.98), (0.16, 0.38, up + 1.02), 0.022, material=dark, mirror=True)
    kit.between((0.56, 0.26, up + 0.76), (0.5, 0.42, up + 0.84), 0.02, material=coat, mirror=True)
    kit.add(BALL, (0.5, 0.42, up + 0.85), (0.04, 0.09, 0.06), material=dark, mirror=True)
    kit.between((0.66, 0, up + 0.8), (0.5, 0, up + 0.93), (0.01, 0.18), BOX, 0.8, glazing(kit))
    kit.add(BOX, (0.1, wide * 0.94, up + 0.48), (0.35, 0.02, 0.04), (0.7, 1), (0.06, 0), material=second, mirror=True)
    kit.add(CYL, (rear - 0.06, 0, up + 0.14), (0.09, 0.09, 0.07), rotation=ALONG_X, material=dark)


def kart(kit):
    """A racing kart: tube frame, side pods, nose cone, number panel, bucket seat, engine beside it, slick tyres."""
    rng = kit.rng
    coat, second, dark, tyre, metal = lacquer(kit), lacquer(kit), kit.material(dark=True, pattern=PLAIN), rubber(kit), chrome(kit)
    front, rear, track, radius = 0.52, -0.52, rng.uniform(0.5, 0.58), rng.uniform(0.125, 0.145)
    fat_wheels(kit, front, track - 0.02, radius * 0.95, 0.065, tyre, metal, 3)
    fat_wheels(kit, rear, track, radius, 0.105, tyre, metal, 3)
    kit.between((rear, -track, radius), (rear, track, radius), 0.02, material=metal)
    kit.between((front, 0.25, 0.1), (front, track - 0.05, radius), 0.018, material=dark, mirror=True)
    kit.between((rear - 0.1, 0.32, 0.09), (front - 0.1, 0.3, 0.08), 0.018, material=second, mirror=True)
    kit.between((front - 0.1, 0.3, 0.08), (front + 0.22, 0.2, 0.08), 0.018, material=second, mirror=True)
    kit.add(BOX, (0.3, 0, 0.07), (0.36, 0.28, 0.008), material=metal)
    for x in (rear - 0.1, -0.1, front):
        kit.between((x, -0.3, 0.085), (x, 0.3, 0.085), 0.018, material=second)
    section(kit, front + 0.06, front + 0.42, (0.06, 0.27, track * 0.95), (0.05, 0.15, track * 0.7), coat)
    section(kit, rear + 0.22, front - 0.2, (0.05, 0.26, 0.1), (0.05, 0.22, 0.08), coat, track + 0.02, True)
    kit.between((0, 0.28, 0.12), (0, track, 0.14), 0.018, material=dark, mirror=True)
    kit.between((front + 0.16, 0, 0.2), (front - 0.02, 0, 0.5), (0.015, 0.13), BOX, 0.85, coat)
    kit.add(
        BOX,
        (front + 0.02, 0, 0.44),
        (0.012, 0.09, 0.07),
        rotation=turn("y", -31),
        material=kit.material(base=[0.85] * 3, pattern=WRITING, frequency=12, second=[0.02] * 3),
    )
    steering(kit, front - 0.26, 0, 0.48, dark, 0.15)
    kit.between((front - 0.04, 0, 0.37), (front + 0.06, 0, 0.12), 0.014, material=metal)
    slab(kit, 0.08, 0.2, (-0.3, 0.1, 0.16), (-0.34, 0.12, 0.19), dark)
    kit.between((-0.27, 0, 0.14), (-0.42, 0, 0.62), (0.02, 0.19), BOX, 0.85, dark)
    kit.add(BOX, (-0.16, 0.19, 0.26), (0.2, 0.012, 0.12), (0.6, 1), (-0.09, 0), material=dark, mirror=True)
    kit.add(BOX, (-0.32, -0.35, 0.24), (0.12, 0.09, 0.12), material=dark)
    kit.between((-0.3, -0.35, 0.34), (-0.26, -0.35, 0.5), 0.07, material=fins(kit))
    kit.between((-0.36, -0.3, 0.34), (-0.62, -0.2, 0.28), 0.045, material=metal)
    kit.add(BOX, (-0.1, 0.33, 0.3), (0.03, 0.1, 0.14), rotation=turn("y", 14), material=kit.material(base=[0.1] * 3, pattern=RIBS, frequency=40, second=[0.3] * 3))
    section(kit, rear - 0.28, rear - 0.2, (0.1, 0.26, track * 0.95), (0.1, 0.26, track), dark if kit.chance(0.5) else coat)
    kit.between((rear - 0.1, 0.32, 0.09), (rear - 0.22, 0.32, 0.16), 0.018, material=dark, mirror=True)
    kit.add(BOX, (front - 0.2, 0.12, 0.14), (0.012, 0.03, 0.08), rotation=turn("y", 15), material=metal, mirror=True)


def mower(kit):
    """A ride-on mower: hood with grille, small wheels before and big ones behind, deck beneath, some with a grass box; or a zero-turn."""
    rng = kit.rng
    coat = flat(kit, rng.choice([[0.03, 0.25, 0.05], [0.7, 0.2, 0.02], [0.6, 0.04, 0.03], [0.65, 0.5, 0.03], [0.12, 0.12, 0.12]]), 0.4)
    dark, tyre, cloth = kit.material(dark=True, pattern=PLAIN), treads(kit), hide(kit)
    rim = flat(kit, [0.7, 0.55, 0.05]) if kit.chance(0.5) else flat(kit, [0.75] * 3)
    zero = kit.chance(0.35)
    big, small, base = rng.uniform(0.25, 0.29), rng.uniform(0.16, 0.19), rng.uniform(0.58, 0.65)
    fat_wheels(kit, -base + 0.06, 0.36, big, 0.11, tyre, rim)
    fat_wheels(kit, base, 0.36, small, 0.07, tyre, rim)
    deck = 0.45
    kit.between((-base + 0.06, -0.3, big), (-base + 0.06, 0.3, big), 0.05, material=dark)
    slab(kit, 0.08, 0.22, (-0.28, 0.36, deck), (-0.22, 0.3, deck * 0.85), coat if kit.chance(0.5) else dark)
    kit.add(CYL, (0.03, 0.2, 0.22), (0.1, 0.1, 0.05), material=dark, mirror=True)
    kit.add(BOX, (0.02, -deck - 0.06, 0.16), (0.14, 0.1, 0.04), (0.9, 0.8), material=dark)
    if zero:
        kit.between((-base - 0.1, 0.22, 0.3), (base - 0.12, 0.22, 0.3), 0.04, BOX, material=coat, mirror=True)
        kit.between((base - 0.12, -0.36, 0.32), (base - 0.12, 0.36, 0.32), 0.04, BOX, material=coat)
        kit.between((base - 0.12, 0.36, 0.36), (base, 0.36, small), (0.03, 0.05), BOX, material=dark, mirror=True)
        section(kit, -base - 0.35, -0.36, (0.3, 0.62, 0.3), (0.3, 0.58, 0.3), dark)
        kit.add(CYL, (-base - 0.1, 0, 0.7), (0.17, 0.17, 0.09), material=fins(kit))
        kit.add(BOX, (-base + 0.05, 0.36, 0.6), (0.32, 0.11, 0.05), (0.9, 0.9), material=coat, mirror=True)
        kit.add(BOX, (0.18, 0, 0.36), (0.34, 0.22, 0.02), material=dark)
        kit.between((0.0, 0.3, 0.5), (0.16, 0.27, 0.86), 0.016, material=dark, mirror=True)
        kit.between((0.16, 0.29, 0.86), (0.14, 0.07, 0.92), 0.02, material=dark, mirror=True)
        kit.add(BOX, (-0.12, 0, 0.46), (0.2, 0.2, 0.1), material=dark)
        x, z = -0.12, 0.58
        if kit.chance(0.5):
            kit.between((-base - 0.1, 0.34, 0.5), (-base - 0.2, 0.34, 1.45), 0.025, material=dark, mirror=True)
            kit.between((-base - 0.2, -0.36, 1.45), (-base - 0.2, 0.36, 1.45), 0.025, material=dark)
    else:
        section(kit, 0.08, base + 0.24, (0.3, 0.7, 0.23), (0.28, 0.6, 0.2), coat)
        kit.add(BOX, (base + 0.245, 0, 0.42), (0.012, 0.16, 0.1), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=30, second=[0.1] * 3))
        kit.add(BOX, (base + 0.24, 0.13, 0.54), (0.02, 0.05, 0.025), material=flat(kit, WHITE, 0.6), mirror=True)
        kit.add(BOX, (base - 0.15, 0.22, 0.5), (0.14, 0.014, 0.06), material=dark, mirror=True)
        kit.add(BOX, (base + 0.28, 0, 0.3), (0.04, 0.2, 0.04), material=dark)
        kit.between((base, -0.32, small), (base, 0.32, small), 0.03, material=dark)
        kit.add(BOX, (base, 0, 0.26), (0.06, 0.08, 0.09), material=dark)
        section(kit, 0.0, 0.12, (0.3, 0.78, 0.2), (0.3, 0.7, 0.23), dark)
        kit.add(BOX, (-0.05, 0, 0.3), (0.3, 0.36, 0.025), material=dark)
        section(kit, -base - 0.28, -0.32, (0.3, 0.56, 0.24), (0.3, 0.56, 0.24), coat)
        kit.add(BOX, (-base + 0.06, 0.34, 0.58), (0.32, 0.13, 0.03), (0.9, 0.9), material=coat, mirror=True)
        kit.between((-base + 0.36, 0.34, 0.57), (-base + 0.42, 0.34, 0.32), (0.015, 0.12), BOX, material=coat, mirror=True)
        steering(kit, -0.02, 0, 0.88, dark, 0.15)
        x, z = -base + 0.12, 0.62
        if kit.chance(0.4):
            section(kit, -base - 0.75, -base - 0.29, (0.25, 0.75, 0.34), (0.32, 0.78, 0.36), dark)
    kit.add(BOX, (x, 0, z), (0.2, 0.2, 0.05), material=cloth)
    kit.add(BOX, (x - 0.2, 0, z + 0.2), (0.045, 0.19, 0.18), (0.8, 0.85), (-0.04, 0), material=cloth)
    kit.add(BOX, (-base - 0.29 if not zero else -base - 0.36, 0.15, 0.48), (0.012, 0.04, 0.03), material=flat(kit, RED), mirror=True)
