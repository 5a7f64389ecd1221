"""Small boats and their crew: inflatables, canoes, rafts, jet skis, skiffs."""

import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, LATTICE, RUNGS, TUBE
from .materials import BANDS, CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, STREAKS, STRIPES, paint
from .people import hair_material, skin_material
from .wheeled import glazing


def canvas(kit):
    rng = kit.rng
    if kit.chance(0.75):
        base = np.array([0.85, 0.8, 0.68]) * rng.uniform(0.6, 1.15) if kit.chance(0.6) else np.ones(3) * rng.uniform(0.7, 0.95)
    else:
        base = np.array([[0.35, 0.08, 0.03], [0.05, 0.05, 0.06], [0.6, 0.3, 0.1]][rng.integers(3)])
    return kit.material(base=base, second=base * 0.8, pattern=rng.choice([PLAIN, SEAMS, STRIPES, CLOUDY]), frequency=rng.uniform(5, 14), gloss=0.05)


def timber(kit, low=0.5, high=1.6):
    return kit.material(base=np.array([0.3, 0.17, 0.08]) * kit.rng.uniform(low, high), pattern=PLANKS, frequency=kit.rng.uniform(10, 30), gloss=0.1)


def white_paint(kit):
    return kit.material(base=np.array([0.82, 0.82, 0.8]) * kit.rng.uniform(0.8, 1.15), pattern=kit.rng.choice([PLAIN, PLAIN, STREAKS]), gloss=0.2)


def crew(kit, hip, hand, foot, size=1.0, lean=0.0, cloth=None):
    """Somebody who sits or hangs, of 15 primitives; hand and foot: where from the hip, [3], on the left side."""
    hip, skin, cloth = np.array(hip, float), skin_material(kit), cloth or kit.material(pattern=PLAIN)
    trousers, hat = kit.material(), hair_material(kit) if kit.chance(0.5) else kit.material(gloss=0.4)
    up = np.array([np.sin(lean), 0, np.cos(lean)]) * size
    kit.between(hip - 0.06 * up, hip + 0.5 * up, (0.11 * size, 0.16 * size), taper=1.15, material=cloth)
    kit.add(BALL, hip + 0.5 * up, np.array([0.12, 0.19, 0.09]) * size, material=cloth)
    kit.add(BALL, hip + 0.72 * up, np.array([0.1, 0.085, 0.13]) * size, material=skin)
    kit.add(BALL, hip + 0.77 * up - [0.02 * size, 0, 0], np.array([0.115, 0.1, 0.1]) * size, material=hat)
    for side in (-1, 1):
        flip = np.array([1, side, 1]) * size
        joint, end = hip + flip * [0, 0.09, 0], hip + flip * np.array(foot)
        knee = (joint + end) / 2 + np.array([0.08, 0, max(0.0, 0.36 - np.linalg.norm(np.array(foot)) / 2.6)]) * size
        kit.chain([joint, knee, end], [0.09 * size, 0.07 * size, 0.055 * size], trousers, joints=False)
        kit.add(BALL, end + [0.05 * size, 0, 0], np.array([0.12, 0.05, 0.05]) * size, material=hat)
        shoulder, grip = hip + 0.5 * up + flip * [0, 0.19, 0], hip + flip * np.array(hand)
        elbow = (shoulder + grip) / 2 + flip * [0, 0.1, -0.1]
        kit.chain([shoulder, elbow, grip], [0.06 * size, 0.05 * size, 0.04 * size], cloth if kit.chance(0.6) else skin, joints=False)


def inflatable(kit):
    """Rigid inflatable boats: fat tubes to a raised bow, a console, seats, an arch, outboard motors."""
    rng = kit.rng
    tube = kit.material(base=rng.choice([[0.02, 0.02, 0.022], [0.3, 0.32, 0.34], [0.75, 0.2, 0.02], [0.55, 0.04, 0.03], [0.1, 0.13, 0.07]]), pattern=PLAIN, gloss=0.1)
    bottom, dark, metal = white_paint(kit) if kit.chance(0.5) else kit.material(), kit.material(dark=True), kit.material(base=np.ones(3) * rng.uniform(0.2, 0.8), pattern=PLAIN, gloss=0.4)
    long, wide, fat = rng.uniform(1.2, 1.6), rng.uniform(0.42, 0.55), rng.uniform(0.13, 0.19)
    z, rise = rng.uniform(0.3, 0.4), rng.uniform(0.05, 0.2)
    line = [(-long, wide, z), (long * 0.35, wide, z), (long * 0.72, wide * 0.72, z + rise * 0.5), (long * 0.98, wide * 0.25, z + rise)]
    kit.chain(line, fat, tube, mirror=True)
    kit.between((long * 0.97, -wide * 0.27, z + rise), (long * 0.97, wide * 0.27, z + rise), fat, material=tube)
    kit.between((-long, wide, z), (-long * 1.15, wide, z), fat, taper=0.4, material=tube, mirror=True)
    kit.add(BOX, (-long * 0.3, 0, z * 0.6), (long * 0.68, wide * 0.35, z * 0.6), (1, 2.5), material=bottom)
    kit.add(BOX, (long * 0.63, 0, z * 0.7), (z * 0.5, wide * 0.75, long * 0.3), (0.5, 0.3), (-rise - 0.05, 0), ALONG_X, bottom)
    kit.add(BOX, (-long * 0.95, 0, z + 0.03), (0.05, wide * 0.85, 0.14), material=bottom)
    motors = [0] if kit.chance(0.6) else [-0.2, 0.2]
    for y in motors:
        outboard(kit, (-long * 1.02, y, z + 0.15), rng.uniform(0.8, 1.2), dark if kit.chance(0.6) else white_paint(kit), dark)
    kind = rng.choice(["console", "plain", "cabin"])
    if kind == "console":
        x = rng.uniform(-0.15, 0.15) * long
        kit.add(BOX, (x, 0, z + 0.25), (0.15, 0.18, 0.25), (0.8, 0.9), (-0.04, 0), material=bottom)
        kit.add(BOX, (x + 0.1, 0, z + 0.57), (0.012, 0.16, 0.1), (1, 0.8), (-0.05, 0), material=glazing(kit))
        kit.add(TUBE, (x - 0.18, 0, z + 0.45), (0.1, 0.1, 0.012), rotation=turn("y", 65), material=dark)
        for k in range(int(rng.integers(1, 4))):
            kit.add(BOX, (x - 0.45 - 0.32 * k, 0, z + 0.15), (0.12, 0.14, 0.16), material=dark)
            kit.add(BOX, (x - 0.56 - 0.32 * k, 0, z + 0.38), (0.025, 0.13, 0.1), material=dark)
        if kit.chance(0.5):
            crew(kit, (x - 0.42, 0, z + 0.36), (0.28, 0.1, 0.12), (0.25, 0.14, -0.34), 0.72)
        top = z + rng.uniform(0.7, 0.9)
        kit.chain([(-long * 0.82, wide * 0.95, z), (-long * 0.88, wide * 0.8, top), (-long * 0.88, 0, top + 0.04)], 0.028, metal, mirror=True)
        kit.between((-long * 0.88, 0, top), (-long * 0.88, 0, top + 0.3), 0.015, material=metal)
    elif kind == "cabin":
        kit.add(BOX, (0.1 * long, 0, z + 0.3), (long * 0.32, wide * 0.6, 0.3), (0.75, 0.85), (-0.06, 0), material=bottom)
        kit.add(BOX, (0.1 * long, 0, z + 0.4), (long * 0.29, wide * 0.59, 0.12), (0.86, 0.93), (-0.03, 0), material=glazing(kit))
        kit.between((-0.1, 0, z + 0.6), (-0.15, 0, z + 1.0), 0.025, material=metal)
        kit.add(BOX, (-0.1, 0, z + 0.75), (0.03, 0.15, 0.03), material=dark)
        kit.add(BOX, (-long * 0.5, 0, z + 0.15), (0.2, 0.2, 0.1), material=dark)
    else:
        for x in (-0.55, 0.0, 0.45)[: int(rng.integers(1, 4))]:
            kit.add(BOX, (x * long, 0, z + 0.1), (0.1, wide * 0.9, 0.025), material=timber(kit) if kit.chance(0.4) else metal)
        if kit.chance(0.6):
            crew(kit, (-long * 0.55, 0, z + 0.18), (0.1, 0.3, 0.15), (0.42, 0.15, -0.18), 0.75)
    kit.between((-long * 0.9, wide + fat, z), (long * 0.3, wide + fat, z), 0.02, material=metal, mirror=True)


def outboard(kit, top, size, cowl, dark):
    """An outboard motor on a stern at `top`: cowl, leg, cavitation plate, propeller."""
    top = np.array(top, float)
    kit.add(BOX, top + np.array([-0.08, 0, 0.12]) * size, np.array([0.14, 0.09, 0.13]) * size, (0.75, 0.8), material=cowl)
    kit.add(BOX, top + np.array([-0.08, 0, -0.2]) * size, np.array([0.07, 0.045, 0.22]) * size, (1.2, 1.2), material=dark)
    kit.add(BOX, top + np.array([-0.1, 0, -0.33]) * size, np.array([0.13, 0.08, 0.012]) * size, material=dark)
    kit.add(CYL, top + np.array([-0.1, 0, -0.4]) * size, np.array([0.04, 0.04, 0.1]) * size, rotation=ALONG_X, material=dark)
    kit.add(CYL, top + np.array([-0.2, 0, -0.4]) * size, np.array([0.1, 0.1, 0.015]) * size, rotation=ALONG_X, material=dark)


def open_hull(kit, stations, skin, inside, thick=0.02):
    """An open boat from stern to bow: stations (x, half width, height of the rim), floor and planked sides."""
    for (x0, w0, h0), (x1, w1, h1) in zip(stations[:-1], stations[1:], strict=True):
        kit.add(BOX, ((x0 + x1) / 2, 0, 0.04), (0.04, w0, (x1 - x0) / 2), (1, max(w1, 0.01) / w0), rotation=ALONG_X, material=inside)
        kit.between((x0, w0, h0 / 2), (x1, w1, h1 / 2), (h0 / 2, thick), BOX, h1 / h0, material=skin, mirror=True)
        kit.between((x0, w0, h0), (x1, w1, h1), thick * 1.4, material=inside, mirror=True)


def canoe(kit):
    """Open canoes with thwarts and paddlers, decked kayaks, outrigger canoes, rowing shells."""
    rng = kit.rng
    skin = timber(kit) if kit.chance(0.3) else kit.material(base=paint(rng.choice([0.0, 0.05, 0.13, 0.35, 0.6]), rng.uniform(0.7, 1), rng.uniform(0.2, 0.7)), pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.4)
    wood, dark = timber(kit, 0.8, 1.8), kit.material(dark=True)
    long, wide = rng.uniform(1.7, 2.3), rng.uniform(0.3, 0.4)
    people = int(rng.choice([0, 1, 1, 2]))
    kind = rng.choice(["canoe", "kayak", "outrigger"], p=[0.4, 0.4, 0.2])
    if kind == "kayak":
        wide *= 0.75
        for way in (-1, 1):
            kit.add(BOX, (way * long * 0.24, 0, 0.14), (0.13, wide, long * 0.26), (0.85, 0.62), (-0.02 * way, 0), turn("y", 90 * way), skin)
            kit.add(BOX, (way * long * 0.74, 0, 0.16), (0.11, wide * 0.62, long * 0.26), (0.45, 0.05), (-0.1 * way, 0), turn("y", 90 * way), skin)
            kit.add(BOX, (way * long * 0.55, 0, 0.255), (long * 0.16, 0.03, 0.012), material=dark)
        kit.add(BOX, (0, 0, 0.24), (long * 0.4, wide * 0.7, 0.05), (0.85, 0.6), material=skin if kit.chance(0.5) else kit.material(gloss=0.4))
        seats = [0.0] if people < 2 else [-0.45, 0.45]
        for x in seats:
            kit.add(CYL, (x, 0, 0.29), (0.3, wide * 0.72, 0.025), material=dark)
        low = 0.3
    else:
        high = rng.uniform(0.28, 0.36)
        ends = high * rng.uniform(1.2, 1.7)
        stations = [(-long, 0.03, ends), (-long * 0.75, wide * 0.5, high * 1.1), (-long * 0.35, wide * 0.95, high), (long * 0.35, wide * 0.95, high), (long * 0.75, wide * 0.5, high * 1.1), (long, 0.03, ends)]
        open_hull(kit, stations, skin, wood)
        people = min(people, 1) if kind == "outrigger" else people
        seats = [-0.55, 0.55] if people == 2 else [-0.5]
        for x in (-0.6, 0.0, 0.5):
            kit.add(BOX, (x * long * 0.6, 0, high * 0.85), (0.07, wide * 0.93, 0.018), material=wood)
        low = high * 0.95
        if kind == "outrigger":
            for x in (-0.4, 0.4):
                kit.chain([(x * long, -wide, high), (x * long, wide + 0.5, high + 0.12), (x * long, wide + 0.95, 0.1)], 0.03, wood)
            kit.chain([(-long * 0.65, wide + 0.95, 0.1), (long * 0.6, wide + 0.95, 0.1), (long * 0.8, wide + 0.95, 0.2)], [0.07, 0.07, 0.04], wood)
    for x in seats[:people]:
        crew(kit, (x - 0.1, 0, low), (0.38, 0.28, 0.32), (0.62, 0.13, -0.12), 0.85, rng.uniform(0, 0.25))
        grip = np.array([x + 0.24, 0, low + 0.3])
        if kind == "kayak":
            dip = rng.uniform(-0.35, 0.35)
            ends = np.array([0, 0.9, dip]), np.array([0, -0.9, -dip])
        else:
            side = rng.choice([-1, 1])
            ends = np.array([0, side * 0.5, -0.5]), np.array([0, -side * 0.3, 0.32])
        kit.between(grip + ends[0], grip + ends[1], 0.018, material=wood)
        for end in ends[: 2 if kind == "kayak" else 1]:
            kit.between(grip + end * 0.8, grip + end * 1.12, (0.08, 0.012), BOX, material=wood if kit.chance(0.5) else skin)
    if not people:
        kit.between((-0.7, 0.05, low + 0.03), (0.5, -0.05, low + 0.03), 0.02, material=wood)
        kit.between((0.45, -0.05, low + 0.03), (0.8, -0.08, low + 0.03), (0.015, 0.08), BOX, material=wood)


def raft(kit):
    """Log rafts with a sail or a hut, barrel rafts, white-water rafts with paddlers, life rafts with a canopy."""
    rng = kit.rng
    wood, dark, rope = timber(kit, 0.6, 1.7), kit.material(dark=True), kit.material(base=[0.45, 0.35, 0.2])
    kind = rng.choice(["logs", "barrels", "water", "life"], p=[0.35, 0.15, 0.25, 0.25])
    if kind in ("logs", "barrels"):
        long, wide, fat = rng.uniform(0.9, 1.5), rng.uniform(0.7, 1.0), rng.uniform(0.1, 0.16)
        if kind == "logs":
            count = round(wide / fat)
            for k in range(count):
                kit.add(CYL, (rng.uniform(-0.06, 0.06), (2 * k + 1 - count) * fat, fat), (fat, fat, long * rng.uniform(0.93, 1.05)), rotation=ALONG_X, material=wood)
            for x in (-0.7, 0.0, 0.7):
                kit.add(CYL, (x * long, 0, 2 * fat + 0.03), (0.05, 0.05, count * fat), rotation=ALONG_Y, material=rope if kit.chance(0.4) else wood)
            floor = 2 * fat + 0.05
        else:
            drum = kit.material(base=paint(rng.choice([0.6, 0.0, 0.33]), 0.9, 0.4), pattern=RIBS, frequency=8)
            for x in np.linspace(-0.65, 0.65, 3):
                kit.add(CYL, (x * long, wide * 0.72, 0.2), (0.2, 0.2, long * 0.28), rotation=ALONG_X, material=drum, mirror=True)
            kit.add(BOX, (0, 0, 0.44), (long, wide, 0.05), material=kit.material(base=[0.35, 0.22, 0.1], pattern=STRIPES, frequency=14))
            floor = 0.48
        if kit.chance(0.65):
            tall = rng.uniform(1.4, 1.9)
            kit.between((0.1, 0, 0.2), (0.1, 0, floor + tall), 0.045, taper=0.7, material=wood)
            kit.add(CYL, (0.16, 0, floor + tall * 0.92), (0.03, 0.03, 0.75), rotation=ALONG_Y, material=wood)
            kit.add(BOX, (0.19, 0, floor + tall * 0.62), (0.012, 0.68, tall * 0.3), (1, rng.uniform(0.8, 1.05)), (-0.08, 0), material=canvas(kit))
            kit.between((0.1, 0, floor + tall * 0.9), (-long * 0.9, wide * 0.8, floor), 0.01, material=rope, mirror=True)
        if kit.chance(0.5):
            kit.add(BOX, (-long * 0.4, 0, floor + 0.25), (0.35, wide * 0.5, 0.25), material=kit.material(base=[0.4, 0.3, 0.15], pattern=RIBS, frequency=20))
            kit.add(BOX, (-long * 0.4, 0, floor + 0.65), (0.42, wide * 0.6, 0.18), (1, 0.05), material=kit.material(base=[0.45, 0.35, 0.15], pattern=STREAKS))
        elif kit.chance(0.6):
            crew(kit, (-long * 0.5, 0, floor + 0.1), (0.3, 0.2, 0.1), (0.6, 0.15, -0.05), 0.9)
        for _ in range(int(rng.integers(0, 4))):
            half = rng.uniform(0.08, 0.16, 3)
            kit.add(rng.choice([BOX, CYL]), (rng.uniform(0.3, 0.8) * long, rng.uniform(-0.6, 0.6) * wide, floor + half[2]), half)
        kit.between((-long * 1.25, 0.2, 0.15), (-long * 0.55, 0, floor + 0.5), 0.025, material=wood)
        return
    rubber = kit.material(base=rng.choice([[0.75, 0.2, 0.02], [0.6, 0.04, 0.03], [0.75, 0.55, 0.03], [0.03, 0.12, 0.4], [0.25, 0.27, 0.3]]), pattern=PLAIN, gloss=0.15)
    if kind == "water":
        long, wide, fat = rng.uniform(1.3, 1.6), rng.uniform(0.5, 0.62), rng.uniform(0.17, 0.21)
        kit.chain([(0, wide, fat), (long * 0.62, wide, fat), (long * 0.95, wide * 0.6, fat * 1.8)], fat, rubber, mirror=True)
        kit.chain([(0, wide, fat), (-long * 0.62, wide, fat), (-long * 0.95, wide * 0.6, fat * 1.8)], fat, rubber, mirror=True)
        for way in (-1, 1):
            kit.between((way * long * 0.95, -wide * 0.6, fat * 1.8), (way * long * 0.95, wide * 0.6, fat * 1.8), fat, material=rubber)
            kit.add(CYL, (way * long * 0.3, 0, fat * 1.2), (fat * 0.8, fat * 0.8, wide), rotation=ALONG_Y, material=dark if kit.chance(0.5) else rubber)
        kit.add(BOX, (0, 0, fat * 0.5), (long * 0.85, wide, 0.04), material=dark)
        for x in (-0.3, 0.35)[: int(rng.integers(0, 3))]:
            side = rng.choice([-1, 1])
            at = np.array([x * long, side * wide * 0.75, fat * 2 + 0.06])
            crew(kit, at, (0.3, 0.2, 0.2), (0.4, 0.1, -0.25), 0.8, 0.2)
            kit.between(at + [0.25, side * 0.05, 0.4], at + [0.3, side * 0.6, -0.25], 0.02, material=wood)
            kit.between(at + [0.29, side * 0.5, -0.13], at + [0.31, side * 0.72, -0.4], (0.08, 0.015), BOX, material=dark)
        return
    sides, radius, fat = int(rng.choice([8, 10])), rng.uniform(0.75, 0.95), 0.13
    ring = around(sides, radius, 180 / sides)
    for z in (fat, fat * 2.6):
        for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1], strict=True):
            kit.between((x0, y0, z), (x1, y1, z), fat, material=rubber)
            kit.add(BALL, (x0, y0, z), (fat, fat, fat), material=rubber)
    canopy = kit.material(base=[0.8, 0.28, 0.02] if kit.chance(0.7) else [0.7, 0.5, 0.05], pattern=SEAMS, frequency=5)
    peak = rng.uniform(0.5, 0.75)
    kit.loft((0, 0, fat * 3), [(0, radius * 1.0), (peak * 0.55, radius * 0.8), (peak, radius * 0.25)], canopy)
    kit.add(BOX, (radius * 0.85, 0, fat * 3 + peak * 0.3), (0.12, 0.24, peak * 0.28), (0.5, 0.7), (-0.2, 0), material=dark)
    kit.add(BALL, (0, 0, fat * 3 + peak), (0.06, 0.06, 0.08), material=kit.material(base=[0.8] * 3))
    kit.add(CYL, (0, 0, fat), (radius, radius, 0.05), material=dark)
    band = kit.material(base=[0.8] * 3, pattern=PLAIN)
    kit.add(CYL, (0, 0, fat * 3 + peak * 0.56), (radius * 0.81, radius * 0.81, 0.025), (0.97, 1), material=band)


def jet_ski(kit):
    """Jet skis: a keeled hull, a cowl with handlebars, a saddle, some with a rider or on a trailer."""
    rng = kit.rng
    skin, second, dark = kit.material(pattern=PLAIN, gloss=0.5), kit.material(gloss=0.4), kit.material(dark=True)
    long, wide = rng.uniform(1.1, 1.35), rng.uniform(0.38, 0.46)
    base = 0.0
    if kit.chance(0.25):
        base = 0.35
        steel = kit.material(base=np.ones(3) * rng.uniform(0.3, 0.7))
        kit.between((-long * 0.8, wide * 0.5, 0.3), (long * 0.7, wide * 0.5, 0.3), 0.03, BOX, material=steel, mirror=True)
        kit.between((long * 0.7, wide * 0.5, 0.3), (long * 1.5, 0, 0.3), 0.03, BOX, material=steel, mirror=True)
        kit.between((-0.3, -wide * 1.1, 0.24), (-0.3, wide * 1.1, 0.24), 0.03, material=steel)
        kit.add(CYL, (-0.3, wide * 1.2, 0.24), (0.24, 0.24, 0.07), rotation=ALONG_Y, material=dark, mirror=True)
        kit.between((long * 1.35, 0, 0.3), (long * 1.35, 0, 0), 0.03, material=steel)
    kit.add(BOX, (-long * 0.25, 0, base + 0.16), (long * 0.7, wide * 0.6, 0.16), (1, 1.65), material=second)
    kit.add(BOX, (long * 0.66, 0, base + 0.21), (0.17, wide * 0.98, long * 0.24), (0.35, 0.12), (-0.2, 0), ALONG_X, second)
    kit.add(BOX, (-long * 0.25, 0, base + 0.34), (long * 0.72, wide * 1.0, 0.05), material=skin)
    kit.add(BOX, (long * 0.7, 0, base + 0.4), (0.07, wide * 0.95, long * 0.3), (0.5, 0.08), (-0.06, 0), ALONG_X, skin)
    kit.add(BOX, (long * 0.42, 0, base + 0.5), (long * 0.33, wide * 0.62, 0.2), (0.5, 0.6), (-0.12, 0), material=skin)
    kit.add(BALL, (long * 0.42, 0, base + 0.5), (long * 0.42, wide * 0.55, 0.22), material=skin)
    kit.add(BOX, (-long * 0.3, 0, base + 0.52), (long * 0.5, 0.17, 0.14), (0.95, 0.8), material=second)
    kit.add(BOX, (-long * 0.3, 0, base + 0.68), (long * 0.5, 0.17, 0.06), (0.95, 0.85), material=dark)
    post = np.array([long * 0.2, 0, base + 0.85])
    kit.between((long * 0.35, 0, base + 0.6), post, 0.08, material=dark)
    kit.between(post, post + [-0.12, wide * 0.85, 0.06], 0.022, material=dark, mirror=True)
    kit.add(BOX, post + [0.1, 0, 0.06], (0.1, 0.14, 0.05), (0.7, 0.8), material=dark)
    kit.add(BOX, post + [0.0, wide * 0.75, -0.02], (0.03, 0.06, 0.035), material=dark, mirror=True)
    kit.add(BOX, (-long * 0.25, wide * 0.97, base + 0.38), (long * 0.65, 0.035, 0.04), material=dark, mirror=True)
    kit.add(BOX, (long * 0.5, wide * 0.5, base + 0.45), (long * 0.22, 0.03, 0.06), (0.8, 1), (0.1, 0), material=second, mirror=True)
    kit.add(CYL, (-long * 0.98, 0, base + 0.18), (0.1, 0.1, 0.06), rotation=ALONG_X, material=dark)
    for k in range(int(rng.choice([0, 1, 1, 1, 2])) if not base else 0):
        crew(kit, (-0.12 - 0.42 * k, 0, base + 0.82), (0.42, 0.34, 0.12) if k == 0 else (0.35, 0.17, 0.15), (0.25, 0.28, -0.42), 0.88, 0.25)


def skiff(kit):
    """Fishing skiffs and rowing boats: open, planked or of plastic, with benches, an outboard motor or oars, nets, pots and somebody aft."""
    rng = kit.rng
    skin = timber(kit) if kit.chance(0.3) else white_paint(kit) if kit.chance(0.3) else kit.material(pattern=rng.choice([PLAIN, STREAKS, BANDS]), frequency=9, gloss=0.2)
    inside, wood, dark = timber(kit) if kit.chance(0.5) else kit.material(base=rng.choice([[0.6, 0.6, 0.55], [0.1, 0.3, 0.4], [0.4, 0.5, 0.45]]), pattern=PLAIN), timber(kit, 0.8, 1.8), kit.material(dark=True)
    long, wide, high = rng.uniform(1.3, 1.8), rng.uniform(0.42, 0.55), rng.uniform(0.3, 0.4)
    bow = high * rng.uniform(1.15, 1.7)
    stations = [(-long, wide * 0.8, high), (-long * 0.3, wide, high), (long * 0.35, wide * 0.92, high * 1.05), (long * 0.75, wide * 0.55, (high * 1.1 + bow) / 2), (long, 0.03, bow)]
    open_hull(kit, stations, skin, inside)
    kit.add(BOX, (-long, 0, high / 2), (0.03, wide * 0.8, high / 2), material=skin)
    kit.add(BOX, (long * 0.84, 0, (high + bow) / 2), (0.02, wide * 0.45, long * 0.14), (1, 0.1), (-(bow - high) * 0.4, 0), ALONG_X, inside)
    for x in (-0.7, -0.15, 0.35):
        kit.add(BOX, (x * long, 0, high * 0.72), (0.1, wide * 0.9, 0.025), material=wood)
    motor = kit.chance(0.7)
    if motor:
        outboard(kit, (-long * 1.03, 0, high + 0.08), rng.uniform(0.8, 1.0), dark if kit.chance(0.5) else white_paint(kit), dark)
        kit.between((-long * 0.98, 0, high + 0.2), (-long * 0.75, 0.1, high + 0.26), 0.02, material=dark)
    else:
        lift = rng.uniform(-0.25, 0.3)
        for y in (-1, 1):
            inner, outer = np.array([-0.1, y * 0.2, high + 0.15]), np.array([-0.05, y * (wide + 1.0), high - 0.1 + lift * 0.5])
            kit.between(inner, outer, 0.022, material=wood)
            kit.between(outer - (outer - inner) * 0.25, outer + (outer - inner) * 0.05, (0.015, 0.07), BOX, material=wood)
    if kit.chance(0.5):
        seat = -0.7 if motor else -0.15
        crew(kit, (seat * long, 0, high * 0.72 + 0.1), (0.1 if motor else 0.4, 0.25, 0.12), (0.42, 0.15, -0.22), 0.85)
    if kit.chance(0.4):
        kit.add(BALL, (long * 0.15, 0, 0.2), (0.35, wide * 0.6, 0.2), material=kit.material(base=[0.05, 0.25, 0.2], pattern=CLOUDY, frequency=30))
    for _ in range(int(rng.integers(0, 4))):
        half = np.array([0.14, 0.14, 0.11]) * rng.uniform(0.7, 1.3)
        kit.add(rng.choice([BOX, CYL]), (rng.uniform(-0.5, 0.55) * long, rng.uniform(-0.4, 0.4) * wide, 0.06 + half[2]), half, material=kit.material(), cut=(LATTICE, 8, 0.4) if kit.chance(0.3) else (0, 1, 1))
    if kit.chance(0.25):
        top = high + rng.uniform(0.9, 1.1)
        for x in (-0.5, 0.3):
            kit.between((x * long, wide * 0.9, high), (x * long, wide * 0.75, top), 0.02, material=dark, mirror=True)
        kit.add(BOX, (-0.1 * long, 0, top), (long * 0.47, wide * 0.85, 0.03), material=canvas(kit))
    elif kit.chance(0.4):
        kit.between((-long * 0.5, wide * 0.6, high * 0.6), (-long * 1.1, wide * 1.2, high + 1.1), 0.012, material=dark, mirror=kit.chance(0.5))
    if kit.chance(0.3):
        kit.add(BOX, (0, 0, high * 0.75), (0.03, wide * 1.02, high * 0.2), material=inside, cut=(RUNGS, 6, 0.5))
        kit.add(TUBE, (0.55 * long, wide * 0.9, high * 0.6), (0.13, 0.13, 0.05), rotation=ALONG_Y, material=kit.material(base=[0.75, 0.25, 0.03]), cut=(BARS, 6, 0.9))
