"""Makers of radar lorries, command posts, masts, ground radars, optronics, searchlights."""


import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .launchers import Bed, axles, drab, lorry, metal, outriggers, timber, trim
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, RUNGS, TUBE
from .materials import PLAIN, RIBS, SEAMS
from .wheeled import glazing


def shelter(kit, bed, share=1.0):
    """A box body behind the cab with a door, vents and a ladder. Returns its middle x, half length and roof's height."""
    rng = kit.rng
    half = (bed.front - bed.rear) / 2 * share - 0.08
    x, tall = bed.front - 0.12 - half, rng.uniform(0.85, 1.1)
    skin = bed.paint if kit.chance(0.7) else drab(kit)
    kit.add(BOX, (x, 0, bed.deck + tall), (half, bed.wide * 0.98, tall), (rng.uniform(0.96, 1), rng.uniform(0.92, 1)), material=skin)
    seam = kit.material(base=skin.first * 0.5, pattern=PLAIN)
    kit.add(BOX, (x - half, rng.uniform(-0.3, 0.3), bed.deck + tall * 0.85), (0.03, 0.38, tall * 0.8), material=seam if kit.chance(0.5) else drab(kit))
    for _ in range(int(rng.integers(1, 3))):
        vent = glazing(kit) if kit.chance(0.4) else kit.material(base=seam.first, pattern=RIBS, frequency=35, second=[0.02] * 3)
        place = (x + rng.uniform(-0.6, 0.6) * half, 0, bed.deck + tall * rng.uniform(1.0, 1.4))
        kit.add(BOX, place, (rng.uniform(0.2, 0.4), bed.wide * 0.995, rng.uniform(0.12, 0.25)), material=vent)
    if kit.chance(0.5):
        kit.add(BOX, (x + half - 0.1, 0, bed.deck + tall * 1.3), (0.25, bed.wide * 0.6, tall * 0.5), material=bed.steel)
    kit.add(BOX, (bed.rear - 0.12, 0, bed.deck * 0.6), (0.03, 0.3, bed.deck * 0.4), rotation=turn("y", 12), material=bed.steel, cut=(RUNGS, 3.5, 0.25))
    return x, half, bed.deck + 2 * tall


def reflector(kit, hub, facing, wide, tall, skin, steel):
    """A bowed mesh, its ribs behind and the feed on an arm before it, looking along local x of `facing`."""
    rng = kit.rng
    depth, count, ends = wide * rng.uniform(0.18, 0.35), 8, rng.uniform(0.5, 0.95)
    mesh = (GRID, rng.uniform(5, 9), rng.uniform(0.3, 0.5)) if kit.chance(0.75) else (0, 1, 1)
    edges = np.linspace(-1, 1, count + 1)
    for a, b in zip(edges[:-1], edges[1:], strict=True):
        start, end = np.array([depth * a * a, wide * a]), np.array([depth * b * b, wide * b])
        along = end - start
        spin = turn("z", -np.degrees(np.arctan2(along[0], along[1])))
        high = tall * np.sqrt(1 - (ends * (a + b) / 2) ** 2)
        place = hub + facing @ np.array([*(start + end) / 2, 0])
        kit.add(BOX, place, (0.025, np.hypot(*along) / 2 * 1.02, high), rotation=facing @ spin, material=skin, cut=mesh)
    for z in (-0.45, 0.45):
        for y in (-1, 1):
            kit.between(hub + facing @ np.array([-0.06, 0, z * tall]), hub + facing @ np.array([depth * 0.8, y * wide * 0.92, z * tall]), 0.04, material=steel)
    kit.between(hub + facing @ np.array([-0.06, 0, -tall * 0.9]), hub + facing @ np.array([-0.06, 0, tall * 0.7]), 0.07, BOX, material=steel)
    focus = hub + facing @ np.array([wide * rng.uniform(0.6, 0.9), 0, -tall * rng.uniform(0.3, 0.7)])
    kit.between(hub + facing @ np.array([0, 0, -tall * 0.85]), focus, 0.05, BOX, material=steel)
    kit.add(BOX, focus, (0.1, 0.16, 0.22), (0.7, 0.7), rotation=facing @ turn("y", -90), material=steel)


def panel_array(kit, hub, facing, wide, tall, skin, steel, dark):
    """A flat antenna: a plate with ribs or elements before a frame, leaning back, looking along local x of `facing`."""
    rng = kit.rng
    lean = facing @ turn("y", -rng.uniform(0, 25))
    centre = hub + lean @ np.array([0.1, 0, tall])
    kit.add(BOX, centre, (rng.uniform(0.06, 0.16), wide, tall), rotation=lean, material=skin)
    front = kit.material(base=skin.first * rng.uniform(0.5, 1.2), pattern=rng.choice([PLAIN, RIBS, SEAMS]), frequency=rng.uniform(8, 25))
    kit.add(BOX, centre + lean[:, 0] * 0.16, (0.03, wide * 0.94, tall * 0.93), rotation=lean, material=front)
    for y in (-0.6, 0.6):
        kit.add(BOX, centre + lean @ np.array([-0.18, y * wide, -0.1 * tall]), (0.08, 0.06, tall * 0.85), rotation=lean, material=steel)
        kit.between(hub + facing @ np.array([-0.45, y * min(wide, 0.7), 0]), centre + lean @ np.array([-0.1, y * wide, 0.1]), 0.04, material=steel)
    if kit.chance(0.4):
        kit.add(BOX, centre + lean @ np.array([0, 0, tall + 0.1]), (0.1, wide * rng.uniform(0.6, 1.1), 0.08), rotation=lean, material=dark)


def antenna(kit, hub, yaw, wide, skin, bed):
    """One of the kinds of radar antenna on a turning head at `hub`, `wide` half its width."""
    rng = kit.rng
    facing = turn("z", yaw)
    kit.add(CYL, hub + [0, 0, 0.06], (0.4, 0.4, 0.14), material=bed.steel)
    if kit.chance(0.5):
        tall = wide * rng.uniform(0.4, 0.85)
        panel_array(kit, hub + [0, 0, 0.15], facing, wide, tall, skin, bed.steel, bed.dark)
    else:
        tall = wide * rng.uniform(0.28, 0.5)
        reflector(kit, hub + [0, 0, tall + 0.2], facing @ turn("y", -rng.uniform(0, 12)), wide, tall, skin, bed.steel)


def radar_skin(kit):
    return drab(kit) if kit.chance(0.6) else kit.material(base=kit.rng.uniform(0.3, 0.85) * np.ones(3), pattern=PLAIN)


def radar_lorry(kit):
    """Lorries with a cabin and a rotating antenna on its roof, on a mast beside it or on a folding arm."""
    rng = kit.rng
    bed = lorry(kit, int(rng.choice([2, 3, 3, 4])), rng.uniform(3.4, 4.8))
    part = rng.choice([1.0, 0.5])
    x, half, roof = shelter(kit, bed, part)
    skin, yaw = radar_skin(kit), rng.uniform(0, 360)
    if part == 1.0:
        rise = rng.uniform(0.15, 0.9)
        kit.between((x, 0, roof - 0.02), (x, 0, roof + rise), rng.uniform(0.15, 0.3), rng.choice([BOX, CYL]), material=bed.steel)
        antenna(kit, np.array([x, 0, roof + rise]), yaw, rng.uniform(1.5, 2.8), skin, bed)
    else:
        foot = np.array([(x - half + bed.rear) / 2, 0, bed.deck])
        rise = rng.uniform(0.6, 3.5)
        kit.add(BOX, foot + [0, 0, 0.2], (0.6, 0.7, 0.22), (0.7, 0.7), material=bed.paint)
        kit.between(foot, foot + [0, 0, rise * 0.6], 0.24, BOX, material=bed.paint)
        kit.between(foot, foot + [0, 0, rise], 0.16, BOX, material=bed.steel)
        antenna(kit, foot + [0, 0, rise], yaw, rng.uniform(1.4, 2.4), skin, bed)
    outriggers(kit, (bed.rear + 0.3,), bed.wide * rng.uniform(1.0, 1.4), bed.deck - 0.25, bed.steel)
    trim(kit, bed)


def telescope(kit, foot, rise, steel, head, dark):
    """A mast of tubes that slide out, with an antenna head, braced by wires in some."""
    rng = kit.rng
    thick = rng.uniform(0.1, 0.15)
    for k in range(4):
        kit.add(CYL, foot + [0, 0, rise * (2 * k + 1) / 8], (thick * (1 - 0.2 * k), thick * (1 - 0.2 * k), rise / 8 + 0.01), material=steel)
        kit.add(CYL, foot + [0, 0, rise * (k + 1) / 4], (thick * (1.2 - 0.2 * k), thick * (1.2 - 0.2 * k), 0.04), material=dark)
    top = foot + [0, 0, rise]
    kind = rng.choice(["panel", "dishes", "log", "optronic", "radome", "loop"])
    yaw = turn("z", rng.uniform(0, 360))
    if kind == "panel":
        for k in range(int(rng.integers(1, 4))):
            face = yaw @ turn("z", 120 * k)
            kit.add(BOX, top + face @ np.array([0.18, 0, 0]), (0.06, 0.28, 0.45), rotation=face, material=head)
        kit.add(CYL, top, (0.16, 0.16, 0.2), material=dark)
    elif kind == "dishes":
        for y in (-0.45, 0.45):
            kit.add(CYL, top + yaw @ np.array([0.15, y, 0]), (0.36, 0.36, 0.08), (0.5, 1), rotation=yaw @ turn("y", -90), material=head)
        kit.between(top + yaw @ np.array([0.02, -0.5, 0]), top + yaw @ np.array([0.02, 0.5, 0]), 0.05, material=dark)
    elif kind == "log":
        log_antenna(kit, top, yaw, rng.uniform(1.2, 1.8), dark)
    elif kind == "optronic":
        kit.add(BOX, top + [0, 0, 0.1], (0.14, 0.14, 0.2), material=dark)
        kit.add(BOX, top + yaw @ np.array([0, 0, 0.4]), (0.25, 0.3, 0.18), rotation=yaw, material=head)
        for y in (-0.14, 0.14):
            kit.add(CYL, top + yaw @ np.array([0.26, y, 0.4]), (0.1, 0.1, 0.03), rotation=yaw @ ALONG_X, material=glazing(kit))
    elif kind == "radome":
        kit.add(CYL, top + [0, 0, 0.2], (0.32, 0.32, 0.25), material=head)
        kit.add(BALL, top + [0, 0, 0.45], (0.32, 0.32, 0.28), material=head)
    else:
        for spin in (0, 90):
            kit.add(TUBE, top + [0, 0, 0.5], (0.5, 0.5, 0.03), rotation=turn("z", spin) @ ALONG_Y, material=head)
        kit.between(top, top + [0, 0, 1.2], 0.03, material=dark)
    return top


def log_antenna(kit, top, facing, long, material):
    """A boom with rods across, longer from front to back."""
    kit.between(top + facing[:, 0] * long * 0.6, top - facing[:, 0] * long * 0.4, 0.025, BOX, material=material)
    upright = turn("x", kit.rng.choice([0, 90]))
    for k in range(7):
        reach = facing @ upright @ np.array([0, (0.2 + 0.08 * k) * long, 0])
        at = top + facing[:, 0] * long * (0.55 - 0.15 * k)
        kit.between(at - reach, at + reach, 0.014, material=material)


def guys(kit, top, foot, spread_out, material, count=3):
    """Wires from `top` to pegs in the ground around `foot`."""
    for x, y in around(count, spread_out, 30):
        peg = np.array([foot[0] + x, foot[1] + y, 0.0])
        kit.between(top, peg, 0.012, material=material)
        kit.between(peg + [0, 0, 0.12], peg, 0.03, material=material)


def command_lorry(kit):
    """Command posts and jammers: box bodies with masts, whips, generator, awnings or many antennas."""
    rng = kit.rng
    bed = lorry(kit, int(rng.choice([2, 3, 3, 4])), rng.uniform(3.2, 4.4))
    x, half, roof = shelter(kit, bed, rng.uniform(0.75, 1.0))
    head = radar_skin(kit)
    kind = rng.choice(["mast", "whips", "jammer"])
    if kind == "mast":
        foot = np.array([x + rng.choice([-1, 1]) * half * 0.8, rng.choice([-1, 1]) * bed.wide * 0.5, roof - 0.05])
        telescope(kit, foot, rng.uniform(2.5, 6), bed.steel, head, bed.dark)
    elif kind == "jammer":
        for share in (-0.55, 0.45):
            foot = np.array([x + share * half, 0, roof - 0.02])
            rise, yaw = rng.uniform(0.5, 1.5), turn("z", rng.uniform(0, 360))
            kit.between(foot, foot + [0, 0, rise], 0.09, material=bed.steel)
            top = foot + [0, 0, rise]
            shape = rng.integers(3)
            if shape == 0:
                log_antenna(kit, top, yaw, rng.uniform(1.2, 2.0), bed.dark)
            elif shape == 1:
                kit.add(BALL, top + [0, 0, 0.35], (0.5, 0.5, 0.5), material=kit.material(base=[0.75] * 3, pattern=PLAIN))
            else:
                kit.add(BOX, top + [0, 0, 0.25], (0.18, 0.8, 0.4), rotation=yaw, material=head)
                for y in (-0.4, 0.4):
                    kit.add(BOX, top + yaw @ np.array([0.2, y, 0.25]), (0.1, 0.3, 0.3), (0.6, 0.6), rotation=yaw, material=bed.dark)
    for _ in range(int(rng.integers(1, 5))):
        foot = np.array([x + rng.choice([-0.9, 0.9]) * half, rng.choice([-0.85, 0.85]) * bed.wide, roof - 0.1])
        kit.between(foot, foot + [rng.uniform(-0.15, 0.15), 0, rng.uniform(1.2, 3)], 0.016, material=bed.dark)
    for _ in range(int(rng.integers(0, 3))):
        kit.add(BOX, (x + rng.uniform(-0.5, 0.5) * half, rng.uniform(-0.4, 0.4), roof + 0.1), (rng.uniform(0.25, 0.5), 0.35, 0.14), material=bed.paint)
    if kit.chance(0.35):
        cloth, side = drab(kit), rng.choice([-1, 1])
        kit.add(BOX, (x, side * (bed.wide + 0.75), roof - 0.4), (half * 0.9, 0.8, 0.02), rotation=turn("x", -side * 14), material=cloth)
        for end in (-0.85, 0.85):
            kit.between((x + end * half, side * (bed.wide + 1.45), roof - 0.58), (x + end * half, side * (bed.wide + 1.45), 0), 0.025, material=bed.dark)
    trim(kit, bed)


def container_post(kit):
    """Containers on the ground with a mast raised beside or on them, jacks, steps and cables."""
    rng = kit.rng
    skin, steel, dark = drab(kit), metal(kit), kit.material(dark=True)
    half, wide, tall, lift = rng.uniform(1.6, 3.0), 1.2, 1.2, rng.uniform(0.1, 0.5)
    kit.add(BOX, (0, 0, lift + tall), (half, wide, tall), material=skin)
    for x in (-1, 1):
        kit.add(BOX, (x * half * 0.98, wide * 0.98, lift + tall), (0.08, 0.06, tall * 1.01), material=steel, mirror=True)
        kit.between((x * half * 0.98, wide * 0.98, lift + 0.1), (x * half * 0.98, wide * 0.98, 0), 0.09, BOX, material=steel, mirror=True)
        kit.add(BOX, (x * half * 0.98, wide * 1.0, 0.02), (0.2, 0.2, 0.03), material=steel, mirror=True)
    for z in (0.05, 2 * tall - 0.04):
        kit.add(BOX, (0, 0, lift + z), (half * 1.0, wide * 1.02, 0.06), material=steel)
    kit.add(BOX, (half, rng.uniform(-0.4, 0.4), lift + tall * 0.95), (0.03, 0.42, tall * 0.88), material=drab(kit))
    kit.add(BOX, (-half - 0.15, 0, lift + tall), (0.2, 0.7, 0.5), material=kit.material(base=skin.first, pattern=RIBS, frequency=30, second=[0.02] * 3))
    kit.add(BOX, (rng.uniform(-0.5, 0.5) * half, 0, lift + tall * 1.3), (0.35, wide * 1.015, 0.22), material=glazing(kit) if kit.chance(0.5) else dark)
    kit.add(BOX, (half + 0.3, 0, lift * 0.5), (0.3, 0.4, lift * 0.5), material=steel)
    head, rise = radar_skin(kit), rng.uniform(3, 7)
    bed = Bed(half, half, -half, wide, lift, skin, dark, steel)
    if kit.chance(0.35):
        antenna(kit, np.array([-half * 0.3, 0, lift + 2 * tall]), rng.uniform(0, 360), rng.uniform(1.2, 2.0), head, bed)
    elif kit.chance(0.5):
        foot = np.array([-half + 0.35, rng.choice([-0.7, 0.7]), lift + 2 * tall - 0.05])
        telescope(kit, foot, rise, steel, head, dark)
    else:
        foot = np.array([-half - 0.55, 0, 0])
        top = telescope(kit, foot, rise + 2, steel, head, dark)
        kit.between((-half, 0.3, lift + 1.8 * tall), foot + [0, 0, lift + 1.8 * tall], 0.05, material=steel)
        if kit.chance(0.6):
            guys(kit, (foot + top) / 2 + [0, 0, rise * 0.25], foot, rise * 0.45, dark)
    for _ in range(int(rng.integers(0, 3))):
        at = np.array([rng.uniform(-0.8, 0.8) * half, rng.choice([-1, 1]) * wide * 0.9, lift + 2 * tall])
        kit.between(at, at + [0, 0, rng.uniform(1, 2)], 0.015, material=dark)


def towed_radar(kit):
    """Small radars on a two- or four-wheeled carriage that stands on four stabilisers."""
    rng = kit.rng
    skin, steel, dark = drab(kit), metal(kit), kit.material(dark=True, pattern=PLAIN)
    half, wide, radius = rng.uniform(1.0, 1.8), rng.uniform(0.7, 0.95), rng.uniform(0.32, 0.45)
    deck = radius * 1.7
    axles(kit, [0.0] if half < 1.4 else [-half * 0.75, half * 0.75], wide * 1.2, radius, dark, steel)
    kit.add(BOX, (0, 0, deck), (half, wide, 0.1), material=skin)
    kit.between((half * 0.95, wide * 0.6, deck), (half + 1.2, 0.03, deck - 0.1), 0.05, BOX, material=steel, mirror=True)
    kit.between((half + 1.15, 0, deck - 0.1), (half + 1.15, 0, 0), 0.05, material=steel)
    for x in (-1, 1):
        kit.between((x * half * 0.9, wide * 0.8, deck), (x * half * 1.25, wide * 2, deck - 0.1), (0.08, 0.07), BOX, material=skin, mirror=True)
        kit.between((x * half * 1.25, wide * 2, deck + 0.25), (x * half * 1.25, wide * 2, 0.02), 0.055, material=steel, mirror=True)
        kit.add(CYL, (x * half * 1.25, wide * 2, 0.03), (0.2, 0.2, 0.03), material=steel, mirror=True)
    tall = rng.uniform(0.35, 0.8)
    if kit.chance(0.6):
        kit.add(BOX, (-half * 0.1, 0, deck + 0.08 + tall), (half * 0.6, wide * 0.85, tall), (0.95, 0.95), material=skin)
        vent = kit.material(base=skin.first * 0.6, pattern=RIBS, frequency=30)
        kit.add(BOX, (-half * 0.1, 0, deck + 0.1 + tall), (half * 0.25, wide * 0.87, tall * 0.7), material=vent)
    else:
        kit.add(CYL, (0, 0, deck + 0.1 + tall), (0.35, 0.35, tall), (0.8, 1), material=skin)
        kit.add(BOX, (-half * 0.7, 0, deck + 0.35), (half * 0.22, wide * 0.7, 0.28), material=skin)
    bed = Bed(half, half, -half, wide, deck, skin, dark, steel)
    hub = np.array([-half * 0.1, 0, deck + 0.08 + 2 * tall])
    if kit.chance(0.3):
        face = turn("z", rng.uniform(0, 360)) @ turn("y", 90 - rng.uniform(0, 45))
        kit.add(BOX, hub + [0, 0, 0.35], (0.25, 0.3, 0.4), material=steel)
        for low, high in ((0.1, 0.45), (0.45, 0.75), (0.75, 1.0)):
            centre = hub + [0, 0, 0.7] + face[:, 2] * (0.25 + 0.2 * (low**2 + high**2))
            kit.add(TUBE, centre, (1.1 * low, 1.1 * low, 0.2 * (high**2 - low**2)), (high / low, 1), rotation=face, material=skin)
        kit.between(hub + [0, 0, 0.7], hub + [0, 0, 0.7] + face[:, 2] * 1.0, 0.05, material=steel)
        kit.add(BOX, hub + [0, 0, 0.7] + face[:, 2] * 1.0, (0.1, 0.1, 0.08), rotation=face, material=dark)
    else:
        antenna(kit, hub, rng.uniform(0, 360), rng.uniform(0.8, 1.5), radar_skin(kit), bed)


def tripod_sensor(kit):
    """Surveillance radars, cameras and sights on a tripod, with a cable to a case beside it."""
    rng = kit.rng
    skin, dark, glass = drab(kit), kit.material(dark=True), glazing(kit)
    leg = dark if kit.chance(0.5) else timber(kit)
    top, reach = rng.uniform(0.9, 1.4), rng.uniform(0.5, 0.75)
    for x, y in around(3, reach, rng.choice([0, 60])):
        kit.between((x * 0.12, y * 0.12, top), (x * 0.55, y * 0.55, top * 0.48), (0.035, 0.045), BOX, material=leg)
        kit.between((x * 0.5, y * 0.5, top * 0.52), (x, y, 0), 0.022, material=dark)
    kit.add(CYL, (0, 0, top), (0.12, 0.12, 0.06), material=dark)
    kit.add(CYL, (0, 0, top + 0.1), (0.07, 0.07, 0.1), material=skin)
    at = np.array([0, 0, top + 0.18])
    kind = rng.choice(["radar", "binoculars", "camera", "dish"])
    frame = turn("y", -rng.uniform(-5, 15))
    if kind == "radar":
        wide, tall = rng.uniform(0.25, 0.5), rng.uniform(0.2, 0.4)
        kit.add(BOX, at + [0, 0, tall], (0.09, wide, tall), rotation=frame, material=skin)
        face = at + frame @ np.array([0.09, 0, 0]) + [0, 0, tall]
        kit.add(BOX, face, (0.02, wide * 0.9, tall * 0.88), rotation=frame, material=kit.material(base=skin.first * 0.6, pattern=PLAIN))
        kit.add(BOX, at + [-0.17, 0, tall], (0.1, wide * 0.6, tall * 0.6), material=skin)
        kit.add(CYL, at + [-0.1, wide * 0.6, 2 * tall + 0.06], (0.045, 0.045, 0.14), rotation=ALONG_X, material=dark)
    elif kind == "dish":
        size = rng.uniform(0.3, 0.5)
        kit.add(CYL, at + [0.1, 0, size * 0.8], (size, size, 0.09), (0.35, 1), rotation=frame @ turn("y", -90), material=skin)
        kit.add(BOX, at + [-0.08, 0, size * 0.5], (0.13, 0.14, size * 0.5), material=skin)
        kit.between(at + [0.1, 0, size * 0.8], at + frame @ np.array([0.1 + size, 0, 0]) + [0, 0, size * 0.8], 0.02, material=dark)
        kit.add(CYL, at + frame @ np.array([0.1 + size, 0, 0]) + [0, 0, size * 0.8], (0.06, 0.06, 0.04), rotation=frame @ ALONG_X, material=dark)
    else:
        pair = kind == "binoculars"
        bulk = rng.uniform(0.12, 0.18)
        kit.add(BOX, at + [0, 0, bulk], (rng.uniform(0.18, 0.3), bulk * (1.5 if pair else 1), bulk), rotation=frame, material=skin)
        for y in (-0.11, 0.11) if pair else (0.0,):
            size = bulk * (0.55 if pair else 0.8)
            kit.add(CYL, at + frame @ np.array([0.3, y, 0]) + [0, 0, bulk], (size, size, 0.16), rotation=frame @ ALONG_X, material=dark)
            kit.add(CYL, at + frame @ np.array([0.47, y, 0]) + [0, 0, bulk], (size * 0.8, size * 0.8, 0.02), rotation=frame @ ALONG_X, material=glass)
            kit.add(CYL, at + frame @ np.array([-0.28, y * 0.6, 0]) + [0, 0, bulk], (0.04, 0.04, 0.08), rotation=frame @ ALONG_X, material=dark)
        kit.add(BOX, at + [0, 0, 2 * bulk + 0.03], (0.12, 0.05, 0.05), material=dark)
    if kit.chance(0.5):
        place = np.array([-reach * 1.1, rng.choice([-0.5, 0.5]), 0])
        kit.add(BOX, place + [0, 0, 0.16], (0.24, 0.18, 0.16), material=skin)
        kit.between(place + [0, 0, 0.25], at, 0.012, material=dark)


def searchlight(kit):
    """A drum with a bright glass in a yoke, on a carriage with small wheels, a pedestal or a trailer."""
    rng = kit.rng
    skin = drab(kit) if kit.chance(0.7) else kit.material(base=rng.uniform(0.2, 0.7) * np.ones(3))
    steel, dark = metal(kit), kit.material(dark=True)
    size, deep = rng.uniform(0.6, 0.8), rng.uniform(0.4, 0.6)
    base = rng.choice(["carriage", "pedestal", "trailer"])
    foot = {"carriage": 0.5, "pedestal": 0.8, "trailer": 0.75}[base]
    if base == "pedestal":
        kit.add(CYL, (0, 0, 0.05), (size * 0.8, size * 0.8, 0.05), material=steel)
        kit.add(CYL, (0, 0, foot / 2), (size * 0.45, size * 0.45, foot / 2), (0.7, 1), material=skin)
    else:
        long, radius = (0.75, 0.22) if base == "carriage" else (1.3, 0.36)
        axles(kit, [-long * 0.75, long * 0.75], size * 1.25 + 0.1, radius, dark, steel)
        kit.add(BOX, (0, 0, foot - 0.1), (long, size * 0.9, 0.1), material=skin)
        for x in (-0.75, 0.75):
            kit.add(BOX, (x * long, 0, (radius + foot) / 2 - 0.05), (0.1, size * 0.6, (foot - radius) / 2 + 0.05), material=steel)
        kit.between((long, size * 0.3, foot - 0.1), (long + 0.9, 0, 0.08 + radius * 0.5), 0.04, material=steel, mirror=True)
        if base == "trailer":
            kit.add(BOX, (-long * 0.72, 0, foot + 0.2), (long * 0.24, size * 0.8, 0.22), material=skin)
    hub = np.array([0, 0, foot + size * 1.15 + 0.1])
    kit.add(CYL, (0, 0, foot + 0.05), (size * 0.7, size * 0.7, 0.07), material=steel)
    kit.add(BOX, (0, 0, foot + 0.12), (0.16, size * 1.12, 0.05), material=skin)
    kit.add(BOX, (0, size * 1.1, (foot + 0.1 + hub[2]) / 2 + 0.05), (0.14, 0.05, (hub[2] - foot) / 2), (0.6, 1), material=skin, mirror=True)
    kit.add(CYL, hub, (0.11, 0.11, size * 1.18), rotation=ALONG_Y, material=dark)
    axis = turn("y", -rng.uniform(-5, 60)) @ ALONG_X
    out = axis[:, 2]
    kit.add(CYL, hub, (size, size, deep), rotation=axis, material=skin)
    kit.add(BALL, hub - out * deep, (size, size, size * rng.uniform(0.2, 0.5)), rotation=axis, material=skin)
    for at in (-deep * 0.9, deep * 0.97):
        kit.add(CYL, hub + out * at, (size * 1.05, size * 1.05, 0.05), rotation=axis, material=steel)
    glass = kit.material(base=[0.85, 0.87, 0.8], pattern=PLAIN, gloss=-rng.uniform(0.8, 1.3) if kit.chance(0.4) else 0.6)
    kit.add(CYL, hub + out * (deep + 0.03), (size * 0.92, size * 0.92, 0.03), rotation=axis, material=glass)
    if kit.chance(0.5):
        kit.add(CYL, hub + out * (deep + 0.06), (size * 0.9, size * 0.9, 0.015), rotation=axis, material=dark, cut=(BARS, 9, 0.15))
    kit.add(BOX, hub + axis @ np.array([-size * 1.05, 0, 0]), (0.1, 0.16, deep * 0.6), rotation=axis, material=steel)


def field_mast(kit):
    """Communications masts of tubes or lattice with guy wires, dishes and whips, a case at the foot."""
    rng = kit.rng
    steel, dark, head = metal(kit, 0.1, 0.6), kit.material(dark=True), radar_skin(kit)
    rise = rng.uniform(4, 9)
    foot = np.zeros(3)
    if kit.chance(0.5):
        top = telescope(kit, foot, rise, steel, head, dark)
    else:
        size = rng.uniform(0.15, 0.28)
        for x, y in around(3, size):
            kit.between((x, y, 0), (x, y, rise), 0.025, material=steel)
        for spin in (60, 180, 300):
            out = turn("z", spin)
            kit.add(BOX, out @ np.array([size * 0.5, 0, 0]) + [0, 0, rise / 2], (0.015, size * 0.87, rise / 2), rotation=out, material=steel, cut=(LATTICE, 2.0, 0.18))
        top = np.array([0, 0, rise])
        for _ in range(int(rng.integers(1, 5))):
            yaw, z = turn("z", rng.uniform(0, 360)), rise * rng.uniform(0.65, 0.97)
            dish = rng.uniform(0.25, 0.55)
            kit.between((0, 0, z), yaw @ np.array([size + 0.2, 0, 0]) + [0, 0, z], 0.04, material=dark)
            kit.add(CYL, yaw @ np.array([size + 0.22, 0, 0]) + [0, 0, z], (dish, dish, 0.1), (0.45, 1), rotation=yaw @ turn("y", -90), material=head)
        kit.between(top, top + [0, 0, rng.uniform(0.6, 1.8)], 0.02, material=dark)
    kit.add(CYL, (0, 0, 0.03), (0.4, 0.4, 0.04), material=steel)
    out = rise * rng.uniform(0.28, 0.45)
    for share in (0.9, 0.5) if kit.chance(0.6) else (0.85,):
        guys(kit, top * share, foot, out, dark, int(rng.choice([3, 4])))
    for _ in range(int(rng.integers(1, 4))):
        half = rng.uniform(0.2, 0.4, 3)
        kit.add(BOX, (rng.choice([-1, 1]) * rng.uniform(0.7, 1.1), rng.uniform(-0.7, 0.7), half[2]), half, material=drab(kit))


def sensor_truck(kit):
    """Radar and command lorries, jammers, container posts with masts, towed radars, tripod sensors, searchlights, field masts."""
    makers = [radar_lorry, command_lorry, container_post, towed_radar, tripod_sensor, searchlight, field_mast]
    makers[kit.rng.choice(7, p=[0.27, 0.2, 0.12, 0.14, 0.1, 0.09, 0.08])](kit)
