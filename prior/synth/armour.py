"""Makers of armoured vehicles with their running gear, and of attack helicopters."""

import numpy as np

from .craft import rotor
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, GRID
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, RIBS
from .wheeled import coat, glazing


def tracked(kit):
    """Tanks, infantry fighting vehicles, howitzers, rocket launchers and anti-aircraft guns on tracks."""
    rng = kit.rng
    paint, dark = coat(kit), kit.material(dark=True)
    steel = kit.material(base=rng.uniform(0.06, 0.25) * np.ones(3), pattern=rng.choice([PLAIN, CLOUDY]))
    long, wide, radius = rng.uniform(2.2, 3.4), rng.uniform(1.1, 1.6), rng.uniform(0.26, 0.38)
    top = running_gear(kit, long, wide, radius, paint, dark, steel)
    deck = hull(kit, long, wide, radius, top, paint, dark)
    kind = rng.choice(["tank", "fighting", "howitzer", "rockets", "flak", "carrier"], p=[0.4, 0.2, 0.14, 0.09, 0.09, 0.08])
    if kind == "tank":
        turret(kit, rng.uniform(-0.25, 0.2) * long, deck, wide * rng.uniform(0.58, 0.75), rng.uniform(0.26, 0.42), long * rng.uniform(0.65, 1.05), paint, dark)
    elif kind == "fighting":
        box = rng.uniform(0.12, 0.3)
        kit.add(BOX, (-long * 0.2, 0, deck + box), (long * 0.72, wide * 0.9, box), (rng.uniform(0.85, 1), rng.uniform(0.85, 0.97)), material=paint)
        rear_doors(kit, -long * 0.9, deck + 2 * box, wide, radius, paint, dark)
        turret(kit, rng.uniform(-0.1, 0.2) * long, deck + 2 * box, wide * rng.uniform(0.35, 0.5), rng.uniform(0.16, 0.26), long * rng.uniform(0.35, 0.6), paint, dark)
    elif kind == "howitzer":
        turret(kit, -long * rng.uniform(0.3, 0.5), deck, wide * rng.uniform(0.8, 0.95), rng.uniform(0.4, 0.6), long * rng.uniform(0.9, 1.5), paint, dark, tall=True)
    elif kind == "rockets":
        pods(kit, np.array([-long * 0.35, 0, deck]), long * rng.uniform(0.45, 0.65), wide * rng.uniform(0.6, 0.85), paint, dark, steel)
        cab = rng.uniform(0.3, 0.45)
        kit.add(BOX, (long * 0.6, 0, deck + cab), (long * 0.24, wide * 0.9, cab), (0.8, 0.95), (-0.1, 0), material=paint)
        kit.add(BOX, (long * 0.62, 0, deck + cab * 1.35), (long * 0.23, wide * 0.75, cab * 0.3), (0.85, 1), (-0.03, 0), material=glazing(kit))
    elif kind == "flak":
        x = rng.uniform(-0.3, 0.1) * long
        kit.add(BOX, (x, 0, deck + 0.35), (0.7, wide * 0.55, 0.35), (0.85, 0.85), material=paint)
        lift = np.radians(rng.uniform(0, 50))
        aim = np.array([np.cos(lift), 0, np.sin(lift)])
        for y in (-1, 1):
            pivot = np.array([x + 0.1, y * wide * 0.66, deck + 0.45])
            kit.add(BOX, pivot, (0.4, 0.12, 0.2), rotation=turn("y", -np.degrees(lift)), material=paint)
            for z in (-0.05, 0.09)[: int(rng.integers(1, 3))]:
                kit.between(pivot + [0, 0, z], pivot + [0, 0, z] + aim * rng.uniform(1.1, 1.7), 0.035, material=steel)
        kit.add(BOX, (x - 0.55, 0, deck + 1.0), (0.05, wide * rng.uniform(0.3, 0.55), 0.22), rotation=turn("y", rng.uniform(-25, 5)), material=steel, cut=(GRID, 9, 0.4) if kit.chance(0.4) else (0, 1, 1))
        kit.between((x - 0.5, 0, deck + 0.6), (x - 0.52, 0, deck + 0.95), 0.06, material=steel)
    else:
        box = rng.uniform(0.25, 0.45)
        kit.add(BOX, (-long * 0.15, 0, deck + box), (long * 0.75, wide * 0.92, box), (rng.uniform(0.8, 1), rng.uniform(0.8, 0.95)), material=paint)
        rear_doors(kit, -long * 0.88, deck + 2 * box, wide, radius, paint, dark)
        hatch_gun(kit, np.array([long * 0.15, 0, deck + 2 * box]), paint, dark)
    stowage(kit, long, wide, deck, dark)


def running_gear(kit, long, wide, radius, paint, dark, steel):
    """Road wheels, sprocket and idler, the track around them, some with skirts. Returns the height of the track's upper run."""
    rng = kit.rng
    count = int(rng.integers(4, 8))
    half = rng.uniform(0.2, 0.28)
    y = wide - half
    rim = paint if kit.chance(0.7) else steel
    for x in np.linspace(-0.68, 0.68, count) * long:
        kit.add(CYL, (x, y, radius + 0.05), (radius, radius, half * 0.8), rotation=ALONG_Y, material=rim, mirror=True)
    raised, small = radius * rng.uniform(1.1, 1.5), radius * rng.uniform(0.75, 1)
    for x in (-0.9, 0.9):
        kit.add(CYL, (x * long, y, raised + 0.12), (small, small, half * 0.8), rotation=ALONG_Y, material=steel if kit.chance(0.5) else rim, mirror=True)
    upper = max(raised + small, 2 * radius) + 0.16
    kit.add(BOX, (0, y, 0.03), (long * 0.72, half, 0.04), material=dark, mirror=True)
    kit.add(BOX, (0, y, upper), (long * 0.9, half, 0.04), material=dark, mirror=True)
    for way in (-1, 1):
        kit.between((way * long * 0.7, y, 0.03), (way * (long * 0.9 + small * 0.9), y, raised - 0.02), (0.04, half), BOX, material=dark, mirror=True)
        kit.between((way * (long * 0.9 + small), y, raised), (way * long * 0.9, y, upper), (0.04, half), BOX, material=dark, mirror=True)
    if kit.chance(0.45):
        skirt = rng.uniform(0.15, 0.45) * upper
        panel = paint if kit.chance(0.6) else kit.material(pattern=RIBS, frequency=8)
        kit.add(BOX, (0, wide + 0.02, upper - skirt / 2 + 0.06), (long * rng.uniform(0.85, 1.0), 0.03, skirt / 2 + 0.06), material=panel, mirror=True)
    kit.add(BOX, (0, y, upper + 0.07), (long * 0.99, half * 1.1, 0.025), material=paint, mirror=True)
    return upper + 0.09


def hull(kit, long, wide, radius, top, paint, dark):
    """The box between the tracks with its sloping plates. Returns the deck's height."""
    rng = kit.rng
    belly, inner = radius * rng.uniform(0.9, 1.2), wide * 0.62
    deck = top + rng.uniform(0.05, 0.22)
    kit.add(BOX, (0, 0, (belly + top) / 2), (long * 0.9, inner, (top - belly) / 2), material=paint)
    nose = rng.uniform(0.1, 0.4) * long
    taper = 1 - nose / (2 * long * 0.95)
    kit.add(BOX, (0, 0, (top + deck) / 2), (long * 0.95, wide * rng.uniform(0.8, 0.97), (deck - top) / 2), (taper, 0.96), (-nose / 2, 0), material=paint)
    low = top - belly
    kit.add(BOX, (long * 0.92, 0, belly + low * 0.62), (long * 0.1, inner, low * 0.4), (0.3, 1), (-long * 0.06, 0), material=paint)
    for x in (-long * 0.45, -long * 0.7):
        if kit.chance(0.7):
            kit.add(BOX, (x, 0, deck + 0.01), (long * 0.1, inner * 0.8, 0.015), material=kit.material(pattern=RIBS, frequency=30, second=[0.02] * 3))
    kit.add(BOX, (long * 0.55, rng.choice([-1, 1]) * wide * 0.35, deck + 0.02), (0.2, 0.22, 0.03), material=paint)
    kit.add(CYL, (long * 0.93, wide * 0.6, top + 0.1), (0.08, 0.08, 0.04), rotation=ALONG_X, material=kit.material(base=[0.75, 0.75, 0.68]), mirror=True)
    return deck


def turret(kit, x, deck, half, height, gun, paint, dark, tall=False):
    """A turret around x on the deck, `half` as wide, with its gun, cupola, sights, smoke tubes, basket and aerials."""
    rng = kit.rng
    long = half * rng.uniform(1.0, 1.5)
    shape = "box" if tall else rng.choice(["cast", "box", "wedge"])
    if shape == "cast":
        kit.add(CYL, (x, 0, deck + 0.04), (long * 0.8, half * 0.9, 0.06), material=dark)
        kit.add(CYL, (x, 0, deck + height * 0.6), (long, half, height * 0.5), (rng.uniform(0.6, 0.8), 1), material=paint)
        kit.add(BALL, (x, 0, deck + height * 0.9), (long * 0.75, half * 0.75, height * 0.45), material=paint)
    elif shape == "wedge":
        kit.add(BOX, (x, 0, deck + height), (long, half, height), (0.75, 0.8), (-long * 0.1, 0), material=paint)
        kit.add(BOX, (x + long * 0.95, 0, deck + height * 0.9), (height * 0.7, half * 0.8, long * 0.35), (0.45, 0.75), rotation=ALONG_X, material=paint)
    else:
        kit.add(BOX, (x, 0, deck + height), (long, half, height), (rng.uniform(0.8, 0.98), rng.uniform(0.75, 0.95)), material=paint)
    if kit.chance(0.5) and not tall:
        kit.add(BOX, (x - long * 1.2, 0, deck + height), (long * 0.3, half * 0.8, height * 0.7), material=paint if kit.chance(0.5) else dark, cut=(BARS, 8, 0.5) if kit.chance(0.4) else (0, 1, 1))
    lift = np.radians(rng.uniform(-3, 25 if tall else 10))
    aim = np.array([np.cos(lift), 0, np.sin(lift)])
    root = np.array([x + long * 0.85, 0, deck + height * rng.uniform(0.8, 1.1)])
    bore = rng.uniform(0.05, 0.09) * (1.0 if half > 0.6 else 0.7)
    kit.add(BOX, root, (0.25, half * rng.uniform(0.2, 0.4), height * 0.5), (0.8, 0.8), rotation=turn("y", -np.degrees(lift)), material=paint)
    kit.between(root, root + aim * gun, bore, taper=rng.uniform(0.75, 1), material=paint)
    if kit.chance(0.6):
        at = rng.uniform(0.35, 0.7) * gun
        kit.between(root + aim * (at - 0.2), root + aim * (at + 0.2), bore * 1.6, material=paint)
    if kit.chance(0.5):
        kit.between(root + aim * (gun - 0.1), root + aim * (gun + 0.15), bore * rng.uniform(1.5, 2.0), rng.choice([BOX, CYL]), material=paint if kit.chance(0.6) else dark)
    roof = deck + (1.25 * height if shape == "cast" else 2 * height)
    side = rng.choice([-1, 1])
    cupola = np.array([x - long * 0.2, side * half * 0.4, roof])
    kit.add(CYL, cupola, (0.2, 0.2, 0.1), (0.85, 1), material=paint)
    if kit.chance(0.5):
        kit.between(cupola + [0.1, 0, 0.2], cupola + [0.75, 0, 0.25], 0.022, material=dark)
        kit.add(BOX, cupola + [0.15, 0, 0.17], (0.15, 0.05, 0.07), material=dark)
    kit.add(BOX, (x + long * 0.3, -side * half * 0.45, roof + 0.05), (0.14, 0.12, 0.12), (0.9, 0.9), material=paint)
    kit.add(BOX, (x + long * 0.44, -side * half * 0.45, roof + 0.07), (0.012, 0.08, 0.05), material=glazing(kit))
    if kit.chance(0.6):
        for k in range(int(rng.integers(2, 4))):
            start = np.array([x + long * (0.55 - 0.14 * k), half * 0.92, deck + height * 1.2])
            kit.between(start, start + [0.12, 0.1, 0.12], 0.04, material=dark, mirror=True)
    for _ in range(int(rng.integers(0, 3))):
        foot = np.array([x - long * rng.uniform(0.5, 0.95), rng.uniform(-0.8, 0.8) * half, roof - 0.05])
        kit.between(foot, foot + [-0.1, 0, rng.uniform(0.5, 1.3)], 0.01, material=dark)


def hatch_gun(kit, at, paint, dark):
    """An open hatch with a machine gun, some behind a shield."""
    kit.add(CYL, at, (0.3, 0.3, 0.06), material=paint)
    kit.between(at, at + [0, 0, 0.35], 0.03, material=dark)
    kit.between(at + [-0.2, 0, 0.36], at + [0.8, 0, 0.4], 0.03, material=dark)
    if kit.chance(0.5):
        kit.add(BOX, at + [0.2, 0, 0.4], (0.02, 0.35, 0.2), (1, 0.8), (-0.05, 0), material=paint)


def rear_doors(kit, x, roof, wide, radius, paint, dark):
    """A ramp or two doors at the rear end, `x`."""
    kit.add(BOX, (x - 0.03, 0, (roof + radius) / 2 + 0.05), (0.03, wide * 0.55, (roof - radius) / 2 * 0.85), material=paint)
    kit.add(BOX, (x - 0.05, 0, (roof + radius) / 2), (0.02, 0.012, (roof - radius) / 2 * 0.8), material=dark)


def pods(kit, base, long, wide, paint, dark, steel):
    """A box or a pair of boxes of tubes, raised, on a turntable."""
    rng = kit.rng
    lift = turn("y", -rng.uniform(0, 45))
    tall = rng.uniform(0.25, 0.4)
    kit.add(CYL, base + [0, 0, 0.06], (wide * 0.6, wide * 0.6, 0.08), material=steel)
    middle = base + [0, 0, tall + 0.25]
    kit.between(base, middle, 0.14, BOX, material=steel)
    shares = [0] if kit.chance(0.5) else [-0.52, 0.52]
    each = wide if len(shares) == 1 else wide * 0.46
    for share in shares:
        kit.add(BOX, middle + [0, share * wide, 0], (long, each, tall), rotation=lift, material=paint)
        for end in (-1, 1):
            face = middle + lift @ np.array([end * long, 0, 0]) + [0, share * wide, 0]
            kit.add(BOX, face, (0.015, each * 0.92, tall * 0.92), rotation=lift, material=dark, cut=(GRID, 6, 0.45) if kit.chance(0.6) else (0, 1, 1))
    kit.between(middle + lift @ np.array([long * 0.4, 0, -tall]), base + [long * 0.2, 0, 0.1], 0.05, material=steel)


def stowage(kit, long, wide, deck, dark):
    """Boxes, rolls, cans and tow ropes on deck and fenders."""
    rng = kit.rng
    for _ in range(int(rng.integers(0, 5))):
        place = (rng.uniform(-0.9, 0.6) * long, rng.choice([-1, 1]) * wide * rng.uniform(0.75, 0.95), deck + 0.05)
        if kit.chance(0.6):
            kit.add(BOX, place, (rng.uniform(0.12, 0.4), 0.13, rng.uniform(0.06, 0.14)), material=coat(kit))
        else:
            kit.add(CYL, place, (0.1, 0.1, rng.uniform(0.15, 0.4)), rotation=ALONG_X, material=kit.material(pattern=rng.choice([PLAIN, CAMOUFLAGE])))
    if kit.chance(0.4):
        kit.between((-long * 0.6, wide * 0.8, deck + 0.02), (long * 0.5, wide * 0.8, deck + 0.02), 0.02, material=dark)


def gunship(kit):
    """Attack helicopters: a narrow body, two cockpits one behind the other, stub wings with pods, a chin gun, engines at the shoulders."""
    rng = kit.rng
    paint, dark, glass = coat(kit), kit.material(dark=True), glazing(kit)
    long, wide, high = rng.uniform(1.3, 1.9), rng.uniform(0.3, 0.45), rng.uniform(0.42, 0.6)
    kit.add(BOX, (0, 0, 0), (long, wide, high), (rng.uniform(0.85, 0.95), 0.85), material=paint)
    nose = rng.uniform(0.4, 0.8)
    kit.add(BOX, (long + nose * 0.45, 0, -high * 0.3), (high * 0.65, wide * 0.9, nose * 0.5), (0.5, 0.6), (high * 0.15, 0), rotation=ALONG_X, material=paint)
    kit.add(BALL, (long + nose * 0.9, 0, -high * 0.45), (0.2, 0.18, 0.18), material=dark)
    for x, z in ((long * 0.82, high * 0.55), (long * 0.32, high * 0.95)):
        kit.add(BOX, (x, 0, z), (long * 0.26, wide * 0.85, high * 0.45), (0.55, 0.75), (-0.12, 0), material=glass)
    gun = np.array([long * 0.9, 0, -high * 1.15])
    kit.add(BALL, gun, (0.16, 0.13, 0.13), material=dark)
    kit.between(gun, gun + [rng.uniform(0.5, 0.9), 0, -0.03], 0.03, material=dark)
    engine = rng.uniform(0.2, 0.28)
    kit.add(CYL, (-long * 0.35, wide * 1.05, high * 0.75), (engine, engine, long * 0.42), (0.8, 1), rotation=turn("y", -90), material=paint, mirror=True)
    kit.add(CYL, (-long * 0.8, wide * 1.1, high * 0.78), (engine * 0.7, engine * 0.7, 0.14), rotation=ALONG_X, material=dark, mirror=True)
    kit.add(BOX, (-long * 0.15, 0, high * 1.15), (long * 0.35, wide * 0.6, high * 0.25), (0.7, 0.6), material=paint)
    rotor(kit, np.array([0, 0, high * 1.6 + rng.uniform(0.1, 0.25)]), rng.uniform(1.9, 2.7), int(rng.choice([2, 4, 4, 5])), dark)
    tail = np.array([-long - rng.uniform(1.2, 2.0), 0, high * 0.45])
    kit.between((-long * 0.9, 0, high * 0.3), tail, (high * 0.5, wide * 0.7), BOX, rng.uniform(0.35, 0.6), material=paint)
    fin = rng.uniform(0.5, 0.8)
    kit.add(BOX, tail + [-0.15, 0, fin * 0.5], (0.28, 0.05, fin * 0.6), (0.6, 1), (-0.25, 0), material=paint)
    spin = np.radians(rng.uniform(0, 180))
    for k in (0, 1):
        way = np.array([np.cos(spin + k * np.pi / 2), 0, np.sin(spin + k * np.pi / 2)]) * rng.uniform(0.35, 0.5)
        at = tail + [-0.25, 0.12, fin * 0.85]
        kit.between(at - way, at + way, (0.012, 0.045), BOX, material=dark)
    kit.add(BOX, tail + [0.1, 0, rng.choice([0.0, fin])], (0.15, rng.uniform(0.4, 0.65), 0.025), material=paint)
    span = rng.uniform(0.7, 1.1)
    kit.add(BOX, (-long * 0.05, 0, high * 0.05), (0.3, wide + span, 0.05), (0.8, 1), material=paint)
    for share in (0.45, 0.95)[: int(rng.integers(1, 3))]:
        y = wide + span * share
        kit.add(BOX, (-long * 0.05, y, -0.06), (0.12, 0.03, 0.1), material=dark, mirror=True)
        if kit.chance(0.5):
            kit.add(CYL, (-long * 0.05, y, -0.26), (0.15, 0.15, 0.4), rotation=ALONG_X, material=paint if kit.chance(0.5) else dark, mirror=True)
        else:
            for dy, dz in ((-0.08, -0.2), (0.08, -0.2)):
                kit.add(CYL, (-long * 0.05, y + dy, dz), (0.05, 0.05, 0.42), (0.7, 1), rotation=ALONG_X, material=dark, mirror=True)
    under = -high - rng.uniform(0.2, 0.45)
    kit.between((long * 0.35, wide * 0.8, -high * 0.7), (long * 0.3, wide * 1.7, under), 0.04, material=paint, mirror=True)
    kit.add(CYL, (long * 0.3, wide * 1.75, under), (0.17, 0.17, 0.07), rotation=ALONG_Y, material=dark, mirror=True)
    kit.between(tail + [0.3, 0, -0.1], tail + [0.2, 0, -0.45], 0.03, material=paint)
    kit.add(CYL, tail + [0.2, 0, -0.45], (0.1, 0.1, 0.04), rotation=ALONG_Y, material=dark)
