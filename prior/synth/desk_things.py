"""Makers of what stands on desks and in music rooms: globes, lamps, microscopes, typewriters, telephones, guitars, trumpets, drums."""

import numpy as np

from .belongings import arc, black, bowl, brass, cloth, enamel, funnel, lens, pale, steel, timber, tipped
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, GRID, SPOKES, TUBE
from .materials import BANDS, CAMOUFLAGE, PLAIN, RIBS, STRIPES, WRITING, paint


def globe(kit):
    rng = kit.rng
    metal, wood = brass(kit) if kit.chance(0.6) else steel(kit), timber(kit)
    r, stem = rng.uniform(0.5, 0.6), rng.uniform(0.2, 0.45)
    sea = paint(rng.uniform(0.5, 0.62), rng.uniform(0.3, 0.9), rng.uniform(0.3, 0.8)) if kit.chance(0.7) else np.array([0.6, 0.48, 0.28])
    world = kit.material(base=sea, second=paint(rng.uniform(0.1, 0.3), 0.6, rng.uniform(0.25, 0.6)), pattern=CAMOUFLAGE, frequency=rng.uniform(4, 7), gloss=0.3)
    z = stem + r + 0.12
    kit.add(CYL, (0, 0, 0.03), (0.42, 0.42, 0.03), (0.92, 1), material=wood)
    kit.loft((0, 0, 0.05), [(0, 0.25), (0.05, 0.1), (stem * 0.5, 0.06), (stem, 0.08)], wood if kit.chance(0.5) else metal)
    tilt = rng.choice([0, 23.5])
    axis = turn("y", tilt)
    kit.add(BALL, (0, 0, z), (r, r, r), rotation=axis, material=world)
    kit.chain(arc((0, 0, z), r + 0.07, 90 - tilt, (-90 if kit.chance(0.6) else 270) - tilt, 14), 0.03, metal)
    kit.between((0, 0, stem), (0, 0, z - r - 0.04), 0.05, material=metal)
    for up in (-1, 1):
        kit.between(np.array([0, 0, z]) + axis @ [0, 0, up * r * 0.98], np.array([0, 0, z]) + axis @ [0, 0, up * (r + 0.13)], 0.035, material=metal)
    if kit.chance(0.35):
        kit.add(TUBE, (0, 0, z), (r + 0.13, r + 0.13, 0.035), material=wood)
        kit.add(TUBE, (0, 0, z), (r + 0.05, r + 0.05, 0.035), material=wood)
        for px, py in around(4, r + 0.1, 45):
            kit.between((px, py, z), (px * 0.55, py * 0.55, 0.04), 0.035, material=wood)


def hourglass(kit):
    rng = kit.rng
    frame = timber(kit) if kit.chance(0.7) else brass(kit)
    glass = kit.material(base=np.array([0.6, 0.68, 0.7]) * rng.uniform(0.6, 1.1), pattern=PLAIN, gloss=0.64)
    sand = kit.material(base=np.array([0.7, 0.5, 0.25]) * rng.uniform(0.5, 1.2) if kit.chance(0.7) else paint(rng.random(), 0.7, 0.6), pattern=PLAIN)
    r, half = rng.uniform(0.28, 0.38), rng.uniform(0.5, 0.75)
    plate, sides = r * 1.35, int(rng.integers(3, 5))
    square = kit.chance(0.3)
    for z in (0.05, 2 * half + 0.15):
        kit.add(BOX if square else CYL, (0, 0, z), (plate, plate, 0.05), material=frame)
        kit.add(CYL, (0, 0, 0.12 if z < half else z - 0.07), (r * 1.02, r * 1.02, 0.025), material=frame)
    bulb = [(0, r * 0.85), (half * 0.2, r), (half * 0.5, r * 0.9), (half * 0.8, r * 0.45), (half, 0.045)]
    fill = rng.uniform(0.3, 0.7)
    kit.loft((0, 0, 0.1), bulb, glass)
    kit.loft((0, 0, 2 * half + 0.1), bulb, glass, axis=turn("x", 180))
    kit.loft((0, 0, 0.1), [(z, k * 1.01) for z, k in bulb if z <= half * fill + 0.01], sand)
    low = [(z, k * 1.012) for z, k in bulb if z >= half * (1 - fill * 0.7)] if fill < 0.99 else bulb
    kit.loft((0, 0, 2 * half + 0.1), low, sand, axis=turn("x", 180))
    for x, y in around(sides, plate * (0.85 if not square else 1.1), 45):
        kit.loft((x, y, 0.08), [(0, 0.05), (half * 0.5, 0.03), (half, 0.06), (half * 1.5, 0.03), (2 * half + 0.05, 0.05)], frame)


def trophy(kit):
    rng = kit.rng
    metal = brass(kit) if kit.chance(0.65) else steel(kit)
    base = black(kit) if kit.chance(0.5) else timber(kit)
    half, high = rng.uniform(0.25, 0.35), rng.uniform(0.1, 0.28)
    kit.add(BOX if kit.chance(0.5) else CYL, (0, 0, high), (half, half, high), (0.9, 0.9), material=base)
    kit.add(BOX, (half * 0.96, 0, high), (0.02, half * 0.6, high * 0.5), rotation=turn("y", -8), material=metal._replace(pattern=WRITING, frequency=14.0))
    z, stem, r, cup = 2 * high, rng.uniform(0.2, 0.45), rng.uniform(0.32, 0.45), rng.uniform(0.5, 0.8)
    kit.loft((0, 0, z), [(0, half * 0.7), (0.05, half * 0.5), (0.1, 0.07), (stem * 0.5, 0.05), (stem * 0.6, 0.1), (stem * 0.7, 0.05), (stem, 0.07)], metal)
    z += stem
    profile = [(0, r * 0.2), (cup * 0.15, r * 0.6), (cup * 0.4, r * 0.88), (cup * 0.8, r * 0.92), (cup, r * 1.1)]
    bowl(kit, (0, 0, z), profile, 0.02, metal, metal)
    lid = kit.chance(0.4)
    if lid:
        kit.loft((0, 0, z + cup), [(0, r * 1.1), (0.05, r), (0.16, r * 0.5), (0.2, 0.06), (0.3, 0.05)], metal)
        kit.add(BALL, (0, 0, z + cup + 0.36), (0.08, 0.08, 0.1), material=metal)
    else:
        kit.add(CYL, (0, 0, z + cup * 0.8), (r * 0.9, r * 0.9, 0.01), material=black(kit))
    kit.chain(arc((0, r * 0.75, z + cup * 0.62), (r * rng.uniform(0.7, 1.0), cup * 0.38), -75, 85, 8, "yz"), 0.035, metal, mirror=True)


def lamp(kit):
    rng = kit.rng
    coat, metal = enamel(kit), steel(kit) if kit.chance(0.6) else brass(kit)
    kit.add(CYL if kit.chance(0.8) else BOX, (0, 0, 0.04), (0.36, 0.36, 0.04), (0.93, 0.93), material=coat)
    low, high = np.radians(rng.uniform(95, 140)), np.radians(rng.uniform(10, 60))
    first, second = rng.uniform(0.7, 1.0), rng.uniform(0.6, 0.9)
    foot = np.array([-0.08, 0, 0.14])
    elbow = foot + first * np.array([np.cos(low), 0, np.sin(low)])
    wrist = elbow + second * np.array([np.cos(high), 0, np.sin(high)])
    kit.add(CYL, foot - [0, 0, 0.05], (0.08, 0.08, 0.07), material=coat)
    bars = (-0.05, 0.05) if kit.chance(0.5) else (0,)
    for y in bars:
        kit.between(foot + [0, y, 0], elbow + [0, y, 0], 0.025, material=metal)
        kit.between(elbow + [0, y, 0], wrist + [0, y, 0], 0.025, material=metal)
    if len(bars) > 1:
        for start, end in ((foot, elbow), (elbow, wrist)):
            aim = (end - start) / np.linalg.norm(end - start)
            kit.between(start + aim * 0.05 + [0.05, 0, 0.03], start + aim * 0.35 + [0.05, 0, 0.03], 0.03, material=metal._replace(pattern=BANDS, frequency=40.0))
    for joint in (foot, elbow, wrist):
        kit.add(CYL, joint, (0.06, 0.06, 0.09), rotation=ALONG_Y, material=coat)
    aim = turn("y", rng.uniform(115, 165))
    size = rng.uniform(0.24, 0.34)
    funnel(kit, wrist, [(-0.12, 0.07), (-0.08, 0.11), (0.1, 0.13), (0.14, size * 0.6), (0.25, size * 0.85), (0.42, size)], coat, aim)
    kit.add(CYL, wrist - aim @ [0, 0, 0.12], (0.07, 0.07, 0.02), rotation=aim, material=coat)
    kit.add(BALL, wrist + aim @ [0, 0, 0.27], (0.12, 0.12, 0.14), rotation=aim, material=kit.material(base=[0.95, 0.9, 0.75], pattern=PLAIN, gloss=-0.9))


def fan(kit):
    rng = kit.rng
    coat, metal, blade = enamel(kit), steel(kit), enamel(kit)
    r, high = rng.uniform(0.42, 0.6), rng.choice([rng.uniform(0.15, 0.35), rng.uniform(1.0, 1.5)])
    kit.loft((0, 0, 0), [(0, 0.34), (0.05, 0.32), (0.1, 0.12), (0.14, 0.06)], coat)
    z = 0.1 + high + r
    kit.between((-0.05, 0, 0.05), (-0.05, 0, z - 0.05), 0.05, material=coat if kit.chance(0.5) else metal)
    kit.loft((0, 0, z), [(-0.4, 0.1), (-0.36, 0.15), (-0.08, 0.16), (-0.02, 0.08), (0.08, 0.06)], coat, axis=ALONG_X)
    count = int(rng.integers(3, 6))
    for k in range(count):
        spin = turn("x", 360 * k / count)
        kit.add(BALL, np.array([0.06, 0, z]) + spin @ [0, 0, r * 0.5], (0.02, r * 0.3, r * 0.4), rotation=spin @ turn("z", 25), material=blade)
    cage = metal if kit.chance(0.7) else coat
    for x in (-0.06, 0.18):
        kit.add(CYL, (x, 0, z), (r, r, 0.008), rotation=ALONG_X, material=cage, cut=(SPOKES, int(rng.integers(18, 36)), 0.18))
        kit.chain(arc((x, 0, z), r * 0.99, 0, 360, 15, "yz"), 0.018, cage, joints=False)
    kit.add(TUBE, (0.06, 0, z), (r, r, 0.13), rotation=ALONG_X, material=cage, cut=(BARS, 12, 0.12))
    kit.add(CYL, (0.19, 0, z), (r * 0.24, r * 0.24, 0.02), rotation=ALONG_X, material=coat)
    for k in range(3):
        kit.add(BOX, (0.24, 0.1 * (k - 1), 0.08), (0.03, 0.03, 0.03), material=pale(kit))


def microscope(kit):
    rng = kit.rng
    coat, metal, dark = (brass(kit) if kit.chance(0.3) else enamel(kit)), steel(kit), black(kit)
    kit.add(BOX, (0.05, 0, 0.06), (0.42, 0.3, 0.06), (0.95, 0.9), material=coat)
    kit.add(CYL, (0.15, 0, 0.16), (0.12, 0.12, 0.06), material=dark)
    kit.chain([(-0.28, 0, 0.08), (-0.36, 0, 0.5), (-0.3, 0, 0.95), (-0.08, 0, 1.2)], [0.1, 0.09, 0.09, 0.09], coat)
    stage = rng.uniform(0.42, 0.5)
    kit.add(BOX, (0.1, 0, stage), (0.3, 0.28, 0.03), material=dark)
    kit.add(BOX, (-0.22, 0, stage), (0.1, 0.1, 0.06), material=coat)
    kit.add(BOX, (0.15, 0, stage + 0.035), (0.08, 0.2, 0.006), material=pale(kit))
    kit.add(CYL, (0.15, 0, stage - 0.1), (0.09, 0.09, 0.08), material=metal)
    kit.add(CYL, (0.13, 0, 1.0), (0.14, 0.14, 0.05), material=metal)
    for x, y in ((0.15, 0), (0.08, 0.1), (0.08, -0.1)):
        kit.between((x, y, 1.0), (x * 1.1, y * 1.3, 0.72 + 0.12 * (y != 0)), 0.055, taper=0.6, material=metal)
    lean = np.radians(rng.uniform(90, 128))
    aim = np.array([np.cos(lean), 0, np.sin(lean)])
    start = np.array([0.13, 0, 1.05])
    kit.add(BOX, start + [-0.06, 0, 0.12], (0.2, 0.14, 0.1), material=coat)
    if kit.chance(0.4):
        kit.between(start + [-0.05, 0.1, 0.15], start + aim * 0.62 + [0, 0.13, 0], 0.07, material=dark, mirror=True)
    else:
        kit.between(start + [0, 0, 0.1], start + aim * 0.6, 0.09, material=coat)
        kit.between(start + aim * 0.55, start + aim * 0.78, 0.075, material=dark)
    for z, size in ((0.4, 0.12), (0.62, 0.07)):
        kit.between((-0.35, -0.22, z), (-0.35, 0.22, z), size, material=dark)


def telescope(kit):
    rng = kit.rng
    coat, dark, metal = (brass(kit) if kit.chance(0.35) else enamel(kit)), black(kit), steel(kit)
    legs = timber(kit) if kit.chance(0.4) else metal
    top, r = rng.uniform(0.9, 1.4), rng.uniform(0.08, 0.2)
    long = rng.uniform(1.2, 1.7) if r < 0.14 else rng.uniform(0.9, 1.3)
    for x, y in around(3, rng.uniform(0.5, 0.75), 60):
        kit.between((x * 0.1, y * 0.1, top), (x, y, 0), (0.045, 0.03), BOX, 0.7, material=legs)
        kit.between((x * 0.5, y * 0.5, top * 0.53), (0, 0, top * 0.45), 0.015, material=metal)
    kit.add(CYL, (0, 0, top + 0.03), (0.11, 0.11, 0.06), material=dark)
    kit.between((0, 0, top), (0, 0, top + r + 0.12), 0.06, material=dark)
    axis = turn("y", 90 - rng.uniform(5, 55))
    at = np.array([0, 0, top + r + 0.14])
    kit.loft(at, [(-long * 0.45, r * 0.9), (-long * 0.4, r), (long * 0.42, r), (long * 0.43, r * 1.15), (long * 0.58, r * 1.15)], coat, axis=axis)
    kit.add(CYL, at + axis @ [0, 0, long * 0.582], (r * 1.0, r * 1.0, 0.008), rotation=axis, material=lens(kit))
    kit.add(CYL, at, (r * 1.06, r * 1.06, 0.05), rotation=axis, material=dark)
    if r < 0.14:
        kit.loft(at, [(-long * 0.75, 0.05), (-long * 0.66, 0.05), (-long * 0.65, r * 0.5), (-long * 0.45, r * 0.6)], dark, axis=axis)
        if kit.chance(0.5):
            elbow = at + axis @ [0, 0, -long * 0.72]
            kit.between(elbow, elbow + axis @ [-0.2, 0, 0], 0.05, material=dark)
    else:
        side = at + axis @ [0, r, long * 0.35]
        kit.between(side, side + axis @ [0, 0.16, 0], 0.06, material=dark)
        kit.between((0, 0, top + 0.1), (-0.25, -0.25, top - 0.2), 0.025, material=metal)
        kit.add(CYL, (-0.27, -0.27, top - 0.22), (0.1, 0.1, 0.07), rotation=turn("y", 40), material=dark)
    kit.between(at + axis @ [-r - 0.07, 0, -long * 0.35], at + axis @ [-r - 0.07, 0, -long * 0.05], 0.035, material=dark)
    for z in (-0.3, -0.1):
        kit.between(at + axis @ [-r, 0, long * z], at + axis @ [-r - 0.07, 0, long * z], 0.02, material=dark)


def typewriter(kit):
    rng = kit.rng
    coat, metal, dark = enamel(kit), steel(kit), black(kit)
    wide, key = rng.uniform(0.62, 0.75), dark if kit.chance(0.5) else pale(kit)
    kit.add(BOX, (0, 0, 0.1), (0.62, wide, 0.1), (0.97, 0.97), material=coat)
    kit.add(BOX, (-0.28, 0, 0.32), (0.32, wide * 0.95, 0.18), (0.75, 0.95), (-0.05, 0), material=coat)
    kit.add(BOX, (0.1, 0, 0.3), (0.2, wide * 0.5, 0.06), rotation=turn("y", 30), material=dark._replace(pattern=RIBS, frequency=20.0, second=metal.first))
    for row in range(4):
        x = 0.52 - 0.15 * row
        kit.add(BOX, (x, 0.02 * row, 0.24 + 0.06 * row), (wide * 0.85, 0.055, 0.03), rotation=turn("z", 90), material=key, cut=(BARS, 7.5, 0.72))
        kit.add(BOX, (x, 0, 0.17 + 0.05 * row), (0.065, wide * 0.87, 0.05), material=dark)
    kit.between((0.62, -wide * 0.5, 0.22), (0.62, wide * 0.5, 0.22), (0.025, 0.04), BOX, material=key)
    slide = rng.uniform(-0.25, 0.25)
    z = 0.6
    kit.add(CYL, (-0.35, slide, z), (0.09, 0.09, wide * 0.98), rotation=ALONG_Y, material=dark)
    kit.add(BOX, (-0.42, slide, z - 0.08), (0.12, wide * 0.98, 0.05), material=metal)
    for side in (-1, 1):
        kit.add(CYL, (-0.35, slide + side * wide * 1.06, z), (0.075, 0.075, 0.06), rotation=ALONG_Y, material=dark)
        kit.add(BOX, (-0.38, slide + side * wide * 0.97, z), (0.15, 0.025, 0.11), material=metal)
    kit.between((-0.3, slide + wide, z + 0.05), (0.0, slide + wide * 1.2, z + 0.12), (0.015, 0.03), BOX, material=metal)
    if kit.chance(0.65):
        paper = pale(kit)._replace(pattern=WRITING, frequency=14.0, second=np.ones(3) * 0.15)
        tall = rng.uniform(0.15, 0.45)
        kit.add(BOX, (-0.43, slide, z + 0.05 + tall), (0.008, wide * 0.6, tall), rotation=turn("y", -12), material=paper)
    kit.add(CYL, (-0.12, 0.25, 0.5), (0.15, 0.15, 0.04), material=metal, mirror=True)


def telephone(kit):
    rng = kit.rng
    coat, metal, dark = enamel(kit) if kit.chance(0.5) else black(kit), brass(kit) if kit.chance(0.6) else steel(kit), black(kit)
    if kit.chance(0.65):
        tall, wide = rng.uniform(0.22, 0.3), rng.uniform(0.42, 0.52)
        kit.add(BOX, (0, 0, 0.04), (0.5, wide * 1.05, 0.04), material=coat)
        kit.add(BOX, (0, 0, 0.06 + tall), (0.48, wide, tall), (0.5, 0.72), (-0.16, 0), material=coat)
        tilt = turn("y", 38)
        face = np.array([0.24, 0, 0.1 + tall])
        kit.add(CYL, face, (0.29, 0.29, 0.05), rotation=tilt, material=metal if kit.chance(0.5) else coat)
        kit.add(CYL, face + tilt @ [0, 0, 0.055], (0.26, 0.26, 0.006), rotation=tilt, material=pale(kit))
        for x, y in around(10, 0.2, 30)[:10]:
            kit.add(CYL, face + tilt @ [x, y, 0.06], (0.042, 0.042, 0.006), rotation=tilt, material=dark)
        kit.add(CYL, face + tilt @ [0, 0, 0.06], (0.11, 0.11, 0.012), rotation=tilt, material=coat)
        top = 0.08 + 2 * tall
        kit.add(BOX, (-0.12, 0.2, top + 0.07), (0.1, 0.04, 0.12), (1.1, 1), material=metal if kit.chance(0.4) else coat, mirror=True)
        kit.add(BOX, (-0.12, 0, top), (0.1, 0.24, 0.04), material=coat)
        high = top + 0.2
        kit.between((-0.12, -0.5, high + 0.02), (-0.12, 0.5, high + 0.02), (0.06, 0.065), material=coat)
        kit.add(CYL, (-0.12, 0.52, high - 0.05), (0.15, 0.15, 0.1), (0.7, 1), material=coat, mirror=True)
        kit.chain([(-0.15, 0.62, high - 0.1), (-0.3, 0.72, 0.2), (-0.5, 0.6, 0.05), (-0.5, 0.2, 0.04)], 0.025, dark)
    else:
        tall = rng.uniform(0.9, 1.2)
        kit.loft((0, 0, 0), [(0, 0.34), (0.06, 0.33), (0.1, 0.14), (0.2, 0.07), (tall - 0.1, 0.06), (tall, 0.09)], metal)
        kit.add(BALL, (0, 0, tall + 0.06), (0.13, 0.13, 0.12), material=metal)
        kit.loft((0.05, 0, tall + 0.06), [(0, 0.06), (0.12, 0.07), (0.26, 0.17), (0.28, 0.17)], dark, axis=turn("y", 80))
        kit.chain([(0, 0, tall * 0.72), (0, 0.2, tall * 0.74), (0, 0.28, tall * 0.78)], 0.025, metal)
        kit.loft((0, 0.28, tall * 0.55), [(-0.2, 0.13), (-0.12, 0.12), (-0.05, 0.06), (0.3, 0.06), (0.33, 0.08)], dark)
        kit.chain([(0, 0.28, tall * 0.85), (-0.1, 0.5, tall * 0.4), (-0.1, 0.4, 0.03), (-0.2, 0.15, 0.03)], 0.02, dark)
        if kit.chance(0.5):
            kit.add(CYL, (0.24, 0, 0.17), (0.14, 0.14, 0.03), rotation=turn("y", 60), material=pale(kit))


def gramophone(kit):
    rng = kit.rng
    wood, metal, dark = timber(kit), brass(kit), black(kit)
    half, tall = rng.uniform(0.45, 0.55), rng.uniform(0.14, 0.25)
    kit.add(BOX, (0, 0, 0.04), (half * 1.1, half * 1.1, 0.04), material=wood)
    kit.add(BOX, (0, 0, tall + 0.06), (half, half, tall), material=wood)
    kit.add(BOX, (0, 0, 2 * tall + 0.08), (half * 1.08, half * 1.08, 0.03), material=wood)
    z = 2 * tall + 0.11
    kit.add(CYL, (0.08, 0, z + 0.04), (half * 0.85, half * 0.85, 0.03), material=metal)
    kit.add(CYL, (0.08, 0, z + 0.08), (half * 0.83, half * 0.83, 0.012), material=dark)
    kit.add(CYL, (0.08, 0, z + 0.095), (half * 0.28, half * 0.28, 0.006), material=enamel(kit))
    kit.add(CYL, (0.08, 0, z + 0.11), (0.02, 0.02, 0.03), material=metal)
    kit.chain([(0, half, tall), (0, half + 0.22, tall), (0, half + 0.22, tall - 0.15), (0, half + 0.36, tall - 0.15)], 0.025, metal)
    post = np.array([-half * 0.95, 0, z + 0.35])
    kit.chain([(-half, 0, tall), (-half - 0.1, 0, z), post], [0.06, 0.06, 0.06], metal)
    kit.chain([post, (-half * 0.5, 0.12, z + 0.3), (0.0, 0.2, z + 0.2)], 0.04, metal)
    kit.add(CYL, (0.04, 0.22, z + 0.17), (0.1, 0.1, 0.03), rotation=ALONG_Y, material=metal)
    horn = metal if kit.chance(0.6) else enamel(kit)
    axis = turn("y", rng.uniform(25, 60))
    long, wide = rng.uniform(0.95, 1.3), rng.uniform(0.5, 0.75)
    t = np.linspace(0, 1, 9)
    skin = horn._replace(pattern=int(rng.choice([PLAIN, STRIPES])), frequency=6.0)
    funnel(kit, post, np.stack([t * long, 0.06 + wide * t**2.6], 1), skin, axis)
    for k in range(8):
        edge = [post + axis @ turn("z", 45 * k) @ [0.065 + wide * s**2.6, 0, s * long] for s in (0.55, 0.8, 1.0)]
        kit.chain(edge, 0.012, horn, joints=False)


def sewing(kit):
    rng = kit.rng
    coat, metal, wood = black(kit) if kit.chance(0.5) else enamel(kit), steel(kit), timber(kit)
    trim = coat._replace(pattern=int(rng.choice([PLAIN, WRITING, CAMOUFLAGE])), frequency=10.0, second=brass(kit).first)
    lift, treadle = 0.0, kit.chance(0.35)
    if treadle:
        lift, iron = 1.1, black(kit)
        kit.add(BOX, (0, 0, lift - 0.04), (0.5, 1.1, 0.04), material=wood)
        for y in (-0.85, 0.85):
            for way in (-1, 1):
                kit.between((way * 0.38, y, 0), (-way * 0.2, y, lift - 0.05), 0.04, BOX, material=iron)
            kit.between((-0.4, y, 0.03), (0.4, y, 0.03), 0.035, BOX, material=iron)
        kit.between((0, -0.85, 0.4), (0, 0.85, 0.4), 0.03, material=iron)
        kit.add(BOX, (0.05, 0, 0.16), (0.22, 0.4, 0.02), rotation=turn("y", 12), material=iron, cut=(GRID, 8, 0.5))
        kit.between((0, -0.1, 0.18), (0, -0.1, 0.4), 0.03, material=iron)
        kit.chain(arc((0.05, -0.7, 0.5), 0.28, 0, 360, 10), 0.03, iron, joints=False)
        kit.between((-0.22, -0.7, 0.5), (0.32, -0.7, 0.5), 0.02, BOX, material=iron)
        kit.between((0.05, -0.85, 0.5), (0.05, -0.6, 0.5), 0.04, material=iron)
    else:
        kit.add(BOX, (0, 0, 0.09), (0.34, 0.78, 0.09), material=wood if kit.chance(0.5) else coat)
        lift = 0.18
    kit.add(BOX, (0, 0, lift + 0.03), (0.26, 0.72, 0.03), material=trim)
    kit.add(BOX, (0, -0.5, lift + 0.36), (0.14, 0.17, 0.36), (0.85, 0.8), material=trim)
    kit.add(BOX, (0, 0, lift + 0.72), (0.13, 0.66, 0.12), (0.8, 0.97), material=trim)
    kit.add(BOX, (0, 0.56, lift + 0.6), (0.13, 0.12, 0.25), material=trim)
    kit.add(BOX, (0, 0.69, lift + 0.6), (0.1, 0.012, 0.2), material=metal)
    kit.between((0, 0.56, lift + 0.36), (0, 0.56, lift + 0.1), 0.022, material=metal)
    kit.add(BOX, (0.03, 0.56, lift + 0.08), (0.09, 0.05, 0.015), material=metal)
    kit.between((0.0, 0.53, lift + 0.4), (0, 0.53, lift + 0.09), 0.015, material=metal)
    r = rng.uniform(0.2, 0.27)
    kit.add(CYL, (0, -0.74, lift + 0.66), (r, r, 0.05), rotation=ALONG_Y, material=coat if kit.chance(0.5) else metal)
    kit.add(CYL, (0, -0.8, lift + 0.66), (r * 0.5, r * 0.5, 0.04), rotation=ALONG_Y, material=metal)
    kit.add(CYL, (0.14, 0.2, lift + 0.7), (0.08, 0.08, 0.03), rotation=ALONG_X, material=metal)
    kit.between((0, -0.15, lift + 0.82), (0, -0.15, lift + 1.08), 0.015, material=metal)
    kit.loft((0, -0.15, lift + 0.84), [(0, 0.08), (0.02, 0.06), (0.17, 0.06), (0.19, 0.08)], enamel(kit))
    if kit.chance(0.5):
        kit.add(BOX, (0.05, 0.45, lift + 0.066), (0.4, 0.35, 0.008), material=cloth(kit))


def strings(kit):
    """Guitars, electric too, violins and cellos, upright."""
    rng = kit.rng
    wood = timber(kit)._replace(gloss=0.5)
    neck, metal, dark = timber(kit), steel(kit), black(kit)
    violin, electric = kit.chance(0.4), kit.chance(0.4)
    deep = rng.uniform(0.05, 0.065) if electric and not violin else rng.uniform(0.1, 0.16)
    body = enamel(kit) if electric and not violin else wood
    side = body if electric else body._replace(first=body.first * 0.5)
    low, high = (0.42, 0.33) if violin else (0.5, 0.37)
    low *= rng.uniform(0.95, 1.05)
    foot = 0.15 if violin and kit.chance(0.5) else 0.0
    z_low, z_high = foot + low * 0.9, foot + low * 1.8 + high * 0.75
    front = deep + 0.006
    for z, r, squash in ((z_low, low, 0.9), (z_high, high, 0.9)):
        kit.add(CYL, (0, 0, z), (r * squash, r, deep), rotation=ALONG_X, material=side)
        kit.add(CYL, (0, 0, z), (r * squash * 0.97, r * 0.97, front), rotation=ALONG_X, material=body)
    waist = high * (0.72 if violin else 0.86)
    kit.add(BOX, (0, 0, (z_low + z_high) / 2), (deep * 0.99, waist, (z_high - z_low) * 0.4), material=side)
    kit.add(BOX, (0, 0, (z_low + z_high) / 2), (front, waist * 0.96, (z_high - z_low) * 0.38), material=body)
    if electric and not violin:
        kit.between((0, high * 0.6, z_high), (0, high * 1.15, z_high + high * 0.75), (deep, 0.12), CYL, 0.5, body)
        kit.between((0, -high * 0.6, z_high), (0, -high * 1.1, z_high + high * 0.55), (deep, 0.12), CYL, 0.5, body)
    start = z_high + high * 0.6
    long = rng.uniform(0.75, 0.85) if violin else rng.uniform(1.05, 1.3)
    top = start + long
    face = front + (0.06 if violin else 0.015)
    kit.add(BOX, (deep * 0.8, 0, start + long / 2), (0.04, 0.06, long / 2), (1, 0.8), material=neck)
    kit.add(BOX, (face, 0, start + long * 0.35), (0.015, 0.06, long * 0.66), (1, 0.75), material=dark)
    if violin:
        kit.add(BOX, (deep * 0.8 - 0.01, 0, top + 0.08), (0.05, 0.045, 0.12), (0.8, 0.9), material=neck)
        kit.add(CYL, (deep * 0.8, 0, top + 0.22), (0.07, 0.07, 0.06), rotation=ALONG_Y, material=neck)
        kit.add(BOX, (front + 0.05, 0, z_low + 0.35), (0.05, 0.13, 0.015), material=neck)
        kit.add(BOX, (front + 0.05, 0, foot + 0.24), (0.015, 0.07, 0.18), (1, 0.6), material=dark)
        kit.add(BOX, (front, 0.17, z_low + 0.32), (0.006, 0.014, 0.13), rotation=turn("x", -10), material=dark, mirror=True)
        kit.add(CYL, (front + 0.03, 0.16, foot + 0.1), (0.1, 0.13, 0.03), rotation=ALONG_X, material=dark)
        if foot:
            kit.between((0, 0, 0), (0, 0, foot + 0.05), 0.02, material=metal)
    else:
        kit.add(BOX, (deep * 0.75, 0, top + 0.16), (0.03, 0.085, 0.17), (1, 1.15), rotation=turn("y", -8), material=neck)
        if electric:
            for z in (z_low + 0.15, z_low + 0.4):
                kit.add(BOX, (front, 0, z), (0.025, 0.14, 0.05), material=dark)
            kit.add(BOX, (front, -0.12, z_low), (0.008, 0.2, 0.32), (1, 0.6), material=pale(kit))
            for k in range(3):
                kit.add(CYL, (front + 0.02, -0.26, z_low - 0.2 + 0.13 * k), (0.035, 0.035, 0.03), rotation=ALONG_X, material=metal)
        else:
            kit.add(CYL, (front, 0, z_high - high * 0.55), (0.135, 0.135, 0.008), rotation=ALONG_X, material=dark)
            kit.add(TUBE, (front, 0, z_high - high * 0.55), (0.16, 0.16, 0.012), rotation=ALONG_X, material=pale(kit))
        kit.add(BOX, (front + 0.015, 0, z_low - 0.05), (0.025, 0.17 if not electric else 0.12, 0.035), material=dark if not electric else metal)
    for k in range(2 if violin else 3):
        z = top + (0.05 + 0.08 * k if violin else 0.06 + 0.1 * k)
        kit.between((deep * 0.75, 0.03, z), (deep * 0.75, 0.15, z), 0.02, material=metal if not violin else dark, mirror=True)
    bridge = (face + 0.03, z_low + 0.35 if violin else z_low - 0.05)
    for y in np.linspace(-0.04, 0.04, 4):
        kit.between((bridge[0], y, bridge[1] - (0.15 if violin else 0)), (face + 0.02, y * 0.8, top), 0.005, material=metal)
    if kit.chance(0.4):
        tipped(kit, turn("y", -rng.uniform(8, 16)))
        low_x, up = -0.35, z_low * 0.9
        kit.between((low_x, 0.05, up), (-0.5, 0.4, -0.02), 0.025, material=dark, mirror=True)
        kit.between((low_x, 0.05, up), (0.3, 0.3, -0.02), 0.025, material=dark, mirror=True)
    elif violin and kit.chance(0.4):
        kit.between((0.1, low + 0.12, 0), (0.1, low + 0.12, top), 0.015, material=timber(kit))
        kit.between((0.15, low + 0.12, 0.05), (0.13, low + 0.12, top - 0.05), (0.01, 0.008), BOX, material=pale(kit))
        kit.add(BOX, (0.12, low + 0.12, 0.06), (0.04, 0.02, 0.06), material=dark)


def wind(kit):
    """Trumpets, saxophones, drums on legs or goblets."""
    rng = kit.rng
    metal, dark = brass(kit) if kit.chance(0.75) else steel(kit), black(kit)
    kind = rng.choice(["trumpet", "saxophone", "drum", "goblet"])
    t = np.linspace(0, 1, 7)
    if kind == "trumpet":
        z, r, wrap = rng.uniform(0.5, 0.6), 0.035, 0.17
        wide = rng.uniform(0.26, 0.36)
        funnel(kit, (0.15, 0, z + wrap), np.stack([t * 0.85, r + (wide - r) * t**3.5], 1), metal, ALONG_X)
        kit.between((-0.55, 0, z + wrap), (0.17, 0, z + wrap), r, material=metal)
        kit.chain(arc((-0.55, 0, z), (0.2, wrap), 90, 270, 7), r, metal)
        kit.between((-0.55, 0, z - wrap), (0.4, 0, z - wrap), r, material=metal)
        kit.chain(arc((0.4, 0.06, z), (0.18, wrap), -90, 90, 7), r, metal)
        kit.between((0.4, 0.09, z + wrap), (-0.95, 0.09, z + wrap), r * 0.9, material=metal)
        kit.loft((-0.95, 0.09, z + wrap), [(0, 0.03), (0.12, 0.03), (0.16, 0.07), (0.2, 0.075)], steel(kit), axis=turn("y", -90))
        for k in range(3):
            x = -0.22 + 0.15 * k
            kit.add(CYL, (x, 0.03, z), (0.06, 0.06, wrap * 1.35), material=metal)
            kit.between((x, 0.03, z + wrap * 1.3), (x, 0.03, z + wrap * 1.3 + rng.uniform(0.06, 0.14)), 0.02, material=metal)
            kit.add(CYL, (x, 0.03, z + wrap * 1.3 + 0.13), (0.045, 0.045, 0.015), material=pale(kit))
        kit.primitives = [p._replace(centre=p.centre - [0, 0, z + wrap - wide]) for p in kit.primitives]
        if kit.chance(0.5):
            kit.primitives = [p._replace(centre=p.centre - [0, 0, wide]) for p in kit.primitives]
            tipped(kit, turn("y", 90))
    elif kind == "saxophone":
        kit.chain(arc((0.2, 0, 0.32), 0.2, 180, 360, 8), np.linspace(0.13, 0.17, 8), metal)
        kit.between((0, 0, 0.32), (-0.08, 0, 1.55), 0.13, taper=0.4, material=metal)
        funnel(kit, (0.4, 0, 0.3), np.stack([t * 0.75, 0.17 + 0.2 * t**2.5], 1), metal, turn("y", 12))
        kit.chain([(-0.08, 0, 1.5), (-0.08, 0, 1.62), (-0.2, 0, 1.72), (-0.42, 0, 1.66)], [0.05, 0.045, 0.04, 0.035], metal)
        kit.between((-0.4, 0, 1.665), (-0.62, 0, 1.6), 0.045, taper=0.6, material=dark)
        for k in range(6):
            z = 0.45 + 0.17 * k
            kit.add(CYL, (0.1 - 0.02 * k - 0.006 * k, 0.02, z), (0.075 - 0.004 * k, 0.075 - 0.004 * k, 0.02), rotation=ALONG_X, material=steel(kit))
        kit.between((0, 0.13, 0.4), (-0.08, 0.09, 1.4), 0.014, material=metal, mirror=True)
        for k in range(3):
            kit.add(CYL, (0, 0.13, 0.4 + 0.3 * k), (0.05, 0.05, 0.03), rotation=ALONG_Y, material=metal, mirror=True)
    elif kind == "drum":
        r, tall, lift = rng.uniform(0.45, 0.65), rng.uniform(0.25, 0.8), rng.choice([0.0, rng.uniform(0.5, 0.8)])
        shell, rim = enamel(kit) if kit.chance(0.6) else timber(kit), steel(kit) if kit.chance(0.6) else timber(kit)
        kit.add(CYL, (0, 0, lift + tall / 2), (r, r, tall / 2), material=shell)
        kit.add(CYL, (0, 0, lift + tall + 0.005), (r * 0.97, r * 0.97, 0.008), material=pale(kit))
        for z in (0.03, tall - 0.01):
            kit.add(TUBE, (0, 0, lift + z), (r * 1.04, r * 1.04, 0.035), material=rim)
            kit.add(TUBE, (0, 0, lift + z), (r * 1.0, r * 1.0, 0.035), material=rim)
        ends, zigzag = around(8, r * 1.03), kit.chance(0.35)
        for k, (x, y) in enumerate(ends):
            x1, y1 = (around(16, r * 1.03)[2 * k + 1]) if zigzag else (x, y)
            kit.between((x, y, lift + 0.03), (x1, y1, lift + tall), 0.018, material=rim)
            if zigzag:
                x2, y2 = ends[(k + 1) % 8]
                kit.between((x1, y1, lift + tall), (x2, y2, lift + 0.03), 0.018, material=rim)
        if lift:
            for x, y in around(3, r * 0.7, 60):
                kit.between((0, 0, lift * 0.45), (x, y, 0), 0.025, material=rim)
                kit.between((0, 0, lift * 0.45), (x * 1.3, y * 1.3, lift + 0.02), 0.025, material=rim)
            kit.between((0, 0, lift * 0.3), (0, 0, lift * 0.7), 0.035, material=rim)
        if kit.chance(0.6):
            for y in (-0.12, 0.1):
                kit.between((-r * 0.6, y, lift + tall + 0.03), (r * 1.2, y * 2.5, lift + tall + 0.05), 0.02, material=timber(kit))
    else:
        r, tall = rng.uniform(0.4, 0.5), rng.uniform(1.0, 1.4)
        body = timber(kit)
        kit.loft((0, 0, 0), [(0, r * 0.65), (tall * 0.3, r * 0.42), (tall * 0.5, r * 0.45), (tall * 0.62, r * 0.75), (tall * 0.8, r * 0.97), (tall, r)], body)
        kit.add(CYL, (0, 0, tall + 0.005), (r * 0.97, r * 0.97, 0.012), material=pale(kit))
        rope = cloth(kit)
        for z, k in ((1.0, 1.03), (0.93, 1.05), (0.5, 0.5)):
            kit.add(CYL, (0, 0, z * tall - 0.03), (r * k, r * k, 0.025), material=rope)
        for x, y in around(14, 1):
            kit.between((x * r * 1.03, y * r * 1.03, tall * 0.93), (x * r * 1.0, y * r * 1.0, tall * 0.8), 0.014, material=rope)
            kit.between((x * r * 1.0, y * r * 1.0, tall * 0.8), (x * r * 0.5, y * r * 0.5, tall * 0.5), 0.014, material=rope)


def desk_thing(kit):
    """Globes, hourglasses, trophies, jointed lamps, fans, microscopes, telescopes, typewriters, telephones, gramophones, sewing machines, instruments."""
    kinds = [globe, hourglass, trophy, lamp, fan, microscope, telescope, typewriter, telephone, gramophone, sewing, strings, strings, wind, wind]
    kit.rng.choice(kinds)(kit)
