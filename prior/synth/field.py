"""Makers of what stands about camps, harbours and airfields: huts and tents, trailers, waggons, dishes, warships, biplanes, unmanned aircraft."""

import numpy as np

from .aircraft import propeller
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, GRID, LATTICE, TUBE
from .machines import wheel
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, STREAKS
from .wheeled import coat, glazing


def vault(kit, middle, half_long, radius, height, slabs, material, thick=0.03):
    """A half tube along x on the ground around `middle`, `radius` wide to either side, of `slabs` flat slabs."""
    angles = np.linspace(0, np.pi, slabs + 1)
    edge = np.stack([np.cos(angles) * radius, np.sin(angles) * height], 1)
    for (y0, z0), (y1, z1) in zip(edge[:-1], edge[1:], strict=True):
        lift = turn("x", np.degrees(np.arctan2(z1 - z0, y1 - y0)))
        centre = np.array(middle) + [0, (y0 + y1) / 2, (z0 + z1) / 2]
        kit.add(BOX, centre, (half_long, np.hypot(y1 - y0, z1 - z0) / 2 * 1.03, thick), rotation=lift, material=material)


def end_wall(kit, x, y, radius, height, slabs, material, thick=0.02):
    """The half disc that closes a `vault` at x: level strips, each as wide as the vault where it is widest."""
    tops = np.sin(np.linspace(0, np.pi / 2, slabs + 1)) * height
    for low, high in zip(tops[:-1], tops[1:], strict=True):
        below, above = (radius * np.sqrt(max(1 - (z / height) ** 2, 0)) for z in (low, high))
        taper = (1, max(above / below, 0.05))
        kit.add(BOX, (x, y, (low + high) / 2), (thick, below * 0.98, (high - low) / 2), taper, material=material)


def hut(kit):
    """Tunnel huts and hangars, ridge and dome tents with lines, bunkers of banked earth or sandbags, dugouts with slits."""
    rng = kit.rng
    dark, long, wide = kit.material(dark=True), rng.uniform(1.0, 3.2), rng.uniform(0.9, 1.8)
    high = wide * rng.uniform(0.75, 1.2)
    kind = rng.choice(["tunnel", "ridge", "dome", "bunker"], p=[0.35, 0.25, 0.15, 0.25])
    skin = kit.material(pattern=rng.choice([PLAIN, RIBS, CLOUDY, CAMOUFLAGE, SEAMS, STREAKS]), frequency=rng.uniform(8, 30))
    if kind == "tunnel":
        vault(kit, (0, 0, 0), long, wide, high, int(rng.integers(6, 10)), skin)
        front = kit.material(pattern=rng.choice([PLAIN, PLANKS, SEAMS]))
        open_front = kit.chance(0.3)
        for x in (-long * 0.97, long * 0.97):
            if x < 0 or not open_front:
                end_wall(kit, x, 0, wide, high, 4, front)
        door = wide * rng.uniform(0.2, 0.75)
        if not open_front:
            kit.add(BOX, (long * 0.98, 0, high * 0.32), (0.03, door, high * 0.32), material=dark if kit.chance(0.5) else kit.material(pattern=RIBS))
            kit.add(BOX, (long * 0.985, 0, high * 0.32), (0.035, 0.02, high * 0.32), material=dark)
        for x in np.linspace(-0.6, 0.6, int(rng.integers(0, 4))):
            kit.add(BOX, (x * long, wide * 0.9, high * 0.45), (0.18, wide * 0.12, 0.15), material=dark, mirror=True)
        if kit.chance(0.4):
            kit.between((-long * 0.4, 0.2, high * 0.9), (-long * 0.4, 0.2, high * 1.3), 0.06, material=dark)
    elif kind == "ridge":
        eave = high * rng.uniform(0.0, 0.4)
        if eave > 0.1:
            kit.add(BOX, (0, 0, eave / 2), (long, wide, eave / 2), material=skin)
        kit.add(BOX, (0, 0, (eave + high) / 2), (long * 1.02, wide * 1.05, (high - eave) / 2), (1, 0.02), material=skin)
        flap = wide * rng.uniform(0.15, 0.4)
        kit.add(BOX, (long, 0, high * 0.4), (0.03, flap, high * 0.4), (1, rng.uniform(0.05, 0.5)), material=dark)
        for x in (-long, long):
            kit.between((x * 1.03, 0, 0), (x * 1.03, 0, high * 1.04), 0.03, material=dark)
        for x in np.linspace(-0.9, 0.9, int(rng.integers(2, 5))):
            kit.between((x * long, wide, max(eave, high * 0.2)), (x * long * 1.1, wide * rng.uniform(1.3, 1.6), 0), 0.008, material=dark, mirror=True)
    elif kind == "dome":
        flat = rng.uniform(0.75, 1.25)
        kit.loft((0, 0, 0), [(0, wide), (high * 0.4, wide * 0.93), (high * 0.72, wide * 0.7), (high * 0.92, wide * 0.38), (high, wide * 0.1)], skin, flat=flat)
        trim = kit.material()
        kit.add(BOX, (wide * 0.86, 0, high * 0.3), (0.16, wide * 0.3, high * 0.3), (0.5, 0.6), (-0.2, 0), material=dark)
        kit.add(TUBE, (0, 0, 0.03), (wide * 1.02, wide * flat * 1.02, 0.03), material=trim)
        for spin in rng.uniform(0, 180, 2):
            kit.add(BOX, (0, 0, high * 0.99), (wide * 0.12, 0.02, 0.02), rotation=turn("z", spin), material=trim)
    else:
        earth = kit.material(base=np.array([0.25, 0.2, 0.12]) * rng.uniform(0.4, 1.8), pattern=CLOUDY, frequency=rng.uniform(5, 20))
        body = kit.material(pattern=rng.choice([PLAIN, CLOUDY, PLANKS, STREAKS]))
        kit.add(BOX, (0, 0, high * 0.35), (long * 0.7, wide, high * 0.35), (0.97, 0.97), material=body)
        kit.add(BOX, (0, 0, high * 0.78), (long * 0.8, wide * 1.1, high * 0.09), material=body if kit.chance(0.6) else earth)
        kit.add(BOX, (long * 0.7, 0, high * 0.5), (0.03, wide * rng.uniform(0.4, 0.8), high * 0.08), material=dark)
        if kit.chance(0.6):
            kit.add(BOX, (-long * 0.69, rng.uniform(-0.4, 0.4) * wide, high * 0.33), (0.03, 0.22, high * 0.33), material=dark)
        if kit.chance(0.5):
            kit.add(BOX, (-long * 0.2, 0, high * 0.3), (long * 0.85, wide * 1.5, high * 0.3), (0.75, 0.62), material=earth)
        else:
            bags = int(rng.integers(4, 8))
            for k in range(bags):
                for row in range(2):
                    at = (long * (0.78 + 0.1 * (row % 2)), wide * ((2 * k + 1 + row % 2) / bags - 1), 0.13 + 0.22 * row)
                    kit.add(BALL, at, (0.15, wide / bags * 1.05, 0.13), material=earth)
        if kit.chance(0.4):
            kit.between((-long * 0.3, wide * 0.4, high * 0.8), (-long * 0.3, wide * 0.4, high * rng.uniform(1.2, 2)), 0.03, material=dark)


def trailer(kit):
    """Two- and four-wheeled trailers: generators, tanks, boxes, flats with goods, masts with lamps, field kitchens."""
    rng = kit.rng
    paint, dark, metal = coat(kit), kit.material(dark=True), kit.material(base=rng.uniform(0.2, 0.7) * np.ones(3))
    long, wide, radius = rng.uniform(0.8, 2.0), rng.uniform(0.5, 0.85), rng.uniform(0.22, 0.4)
    floor = radius * rng.uniform(1.0, 1.8)
    kit.add(BOX, (0, 0, floor), (long, wide * 0.95, 0.06), material=dark if kit.chance(0.6) else paint)
    for x in [0] if long < 1.3 else [-radius * 1.1, radius * 1.1]:
        wheel(kit, (x, wide * rng.uniform(0.9, 1.1), radius), radius, 0.1, dark, metal)
    if kit.chance(0.6):
        kit.add(BOX, (0, wide * 1.02, radius * 2 + 0.06), (radius * 1.5 + (0 if long < 1.3 else radius), 0.12, 0.03), (0.85, 1), material=paint, mirror=True)
    reach = long + rng.uniform(0.5, 1.1)
    if kit.chance(0.6):
        kit.between((long, wide * 0.7, floor), (reach, 0.03, floor), 0.035, BOX, material=dark, mirror=True)
    else:
        kit.between((long * 0.6, 0, floor), (reach, 0, floor), 0.05, BOX, material=dark)
    kit.between((reach - 0.15, 0, floor), (reach - 0.15, 0, 0), 0.03, material=metal)
    kit.add(CYL, (reach - 0.15, 0, 0.08), (0.08, 0.08, 0.04), rotation=ALONG_Y, material=dark)
    top = floor + 0.06
    kind = rng.choice(["generator", "tank", "box", "flat", "mast"])
    tall = rng.uniform(0.35, 0.75)
    if kind == "generator":
        kit.add(BOX, (0, 0, top + tall), (long * 0.9, wide * 0.85, tall), (0.97, 0.95), material=paint)
        for x in (-0.45, 0.35):
            grille = kit.material(pattern=RIBS, frequency=40, second=[0.02] * 3)
            kit.add(BOX, (x * long, wide * 0.84, top + tall), (long * rng.uniform(0.15, 0.3), 0.03, tall * 0.5), material=grille, mirror=True)
        kit.between((-long * 0.5, wide * 0.3, top + 2 * tall), (-long * 0.5, wide * 0.3, top + 2 * tall + 0.3), 0.05, material=dark)
        kit.add(BOX, (-long * 0.9, 0, top + tall), (0.03, wide * 0.5, tall * 0.6), material=metal)
    elif kind == "tank":
        axis = ALONG_X
        kit.add(CYL, (0, 0, top + tall), (tall, wide * 0.85, long * 0.85), rotation=axis, material=paint)
        for x in (-1, 1):
            kit.add(BALL, (x * long * 0.84, 0, top + tall), (0.14, wide * 0.83, tall * 0.98), material=paint)
        for x in (-0.5, 0.5):
            kit.add(BOX, (x * long, 0, top + tall * 0.3), (0.06, wide * 0.9, tall * 0.3), material=dark)
        kit.add(CYL, (0, 0, top + 2 * tall), (0.18, 0.18, 0.06), material=metal)
        kit.add(CYL, (-long * 0.95, 0, top + 0.2), (0.06, 0.06, 0.12), rotation=ALONG_X, material=metal)
    elif kind == "box":
        kit.add(BOX, (0, 0, top + tall * 1.1), (long * 0.97, wide * 0.95, tall * 1.1), material=paint)
        kit.add(BOX, (-long * 0.97, wide * 0.45, top + tall), (0.03, wide * 0.4, tall * 0.9), material=kit.material(), mirror=True)
        if kit.chance(0.5):
            kit.add(BOX, (long * 0.2, wide * 0.95, top + tall * 1.4), (long * 0.25, 0.03, tall * 0.35), material=glazing(kit), mirror=True)
    elif kind == "flat":
        for y in (-1, 1):
            kit.add(BOX, (0, y * wide * 0.93, top + tall * 0.4), (long, 0.03, tall * 0.4), material=kit.material(pattern=PLANKS) if kit.chance(0.3) else paint)
        kit.add(BOX, (-long, 0, top + tall * 0.4), (0.03, wide * 0.93, tall * 0.4), material=paint)
        for _ in range(int(rng.integers(0, 5))):
            half = rng.uniform(0.12, 0.35, 3)
            kit.add(rng.choice([BOX, CYL]), (rng.uniform(-0.6, 0.6) * long, rng.uniform(-0.4, 0.4) * wide, top + half[2]), half)
    else:
        kit.add(BOX, (-long * 0.3, 0, top + tall * 0.6), (long * 0.5, wide * 0.7, tall * 0.6), material=paint)
        mast = rng.uniform(1.6, 3.2)
        foot = np.array([long * 0.5, 0, top])
        kit.between(foot, foot + [0, 0, mast], 0.06, taper=0.6, material=metal)
        kit.between(foot + [0, -0.4, mast], foot + [0, 0.4, mast], 0.03, material=metal)
        for y in (-0.32, 0.32):
            kit.add(BOX, foot + [0.06, y, mast + rng.uniform(-0.1, 0.15)], (0.07, 0.14, 0.12), rotation=turn("y", rng.uniform(0, 30)), material=kit.material(base=[0.8, 0.8, 0.75]))
        for x, y in ((0.7, 1), (-0.7, 1)):
            kit.between((x * long, wide * 0.9, floor), (x * long * 1.1, wide * (1 + 0.5 * y), 0.02), 0.03, material=metal, mirror=True)


def waggon(kit):
    """Farm carts, covered waggons, hand carts, gun limbers: high spoked wheels, shafts, boards, hoops with cloth, a load."""
    rng = kit.rng
    wood, iron, second = kit.material(pattern=PLANKS), kit.material(dark=True), kit.material()
    if kit.chance(0.3):
        wood = kit.material()
    long, wide = rng.uniform(0.7, 1.7), rng.uniform(0.4, 0.65)
    rear = rng.uniform(0.35, 0.65)
    axles = [0.0] if long < 1.1 else [-long * 0.6, long * 0.65]
    floor = rear * rng.uniform(1.1, 1.5)
    for i, x in enumerate(axles):
        radius = rear * (1 if i == 0 else rng.uniform(0.7, 1))
        for y in (-1, 1):
            at = (x, y * wide * 1.15, radius)
            kit.add(TUBE, at, (radius, radius, 0.05), rotation=ALONG_Y, material=iron)
            kit.add(TUBE, at, (radius * 0.93, radius * 0.93, 0.045), rotation=ALONG_Y, material=wood)
            spokes = int(rng.integers(3, 6))
            for k in range(spokes):
                spin = np.radians(180 * k / spokes + 10)
                out = np.array([np.cos(spin), 0, np.sin(spin)]) * radius * 0.94
                kit.between(np.array(at) - out, np.array(at) + out, 0.025, BOX, material=wood)
            kit.add(CYL, at, (0.08, 0.08, 0.09), rotation=ALONG_Y, material=iron)
        kit.between((x, -wide * 1.15, radius), (x, wide * 1.15, radius), 0.04, BOX, material=iron)
        kit.add(BOX, (x, 0, (radius + floor) / 2), (0.08, wide * 0.6, max((floor - radius) / 2, 0.03)), material=wood)
    kit.add(BOX, (0, 0, floor), (long, wide, 0.035), material=wood)
    wall = rng.uniform(0.1, 0.4)
    flare = rng.uniform(0, 18)
    if kit.chance(0.75):
        for y in (-1, 1):
            kit.add(BOX, (0, y * wide, floor + wall), (long, 0.025, wall), rotation=turn("x", -y * flare), material=wood if kit.chance(0.7) else second)
        for x in (-1, 1):
            kit.add(BOX, (x * long, 0, floor + wall * 0.85), (0.025, wide, wall * 0.85), material=wood)
    shaft = long + rng.uniform(0.7, 1.4)
    drop = rng.choice([0, -floor * 0.8])
    if kit.chance(0.6):
        kit.between((long * 0.9, wide * 0.6, floor), (shaft, wide * 0.45, floor + drop), 0.03, material=wood, mirror=True)
    else:
        kit.between((long * 0.7, 0, floor), (shaft, 0, floor + drop), 0.04, material=wood)
    kind = rng.random()
    if kind < 0.35:
        cloth = kit.material(base=rng.uniform(0.4, 0.95) * np.ones(3), pattern=rng.choice([PLAIN, SEAMS, STREAKS]))
        vault(kit, (0, 0, floor + wall), long * rng.uniform(0.8, 1.05), wide * 1.05, rng.uniform(0.5, 0.9), 6, cloth, 0.02)
        if kit.chance(0.6):
            end_wall(kit, -long * 0.8, 0, wide, 0.4, 3, cloth)
    elif kind < 0.7:
        load = kit.material(pattern=rng.choice([STREAKS, CLOUDY, PLANKS]))
        for _ in range(int(rng.integers(1, 6))):
            half = rng.uniform(0.12, 0.3, 3) * (1.6, 1, 1)
            place = (rng.uniform(-0.6, 0.6) * long, rng.uniform(-0.4, 0.4) * wide, floor + half[2] + rng.uniform(0, 0.15))
            kit.add(rng.choice([BOX, BALL, CYL]), place, half, material=load if kit.chance(0.6) else kit.material())
    elif kit.chance(0.6):
        kit.add(BOX, (long * 0.75, 0, floor + 2 * wall), (0.14, wide * 0.9, 0.03), material=second)


def dish(kit):
    """Parabolic dishes on pedestals, tripods, cabins or trailers; flat radar panels that turn; loudspeaker and lamp posts."""
    rng = kit.rng
    white = kit.material(base=rng.uniform(0.4, 0.95) * np.ones(3)) if kit.chance(0.6) else coat(kit)
    steel, dark = kit.material(), kit.material(dark=True)
    radius = rng.uniform(0.6, 1.5)
    tall = rng.uniform(0.4, 2.0)
    base = rng.choice(["pillar", "legs", "cabin", "lattice"])
    if base == "pillar":
        kit.add(CYL, (0, 0, tall / 2), (radius * 0.22, radius * 0.22, tall / 2), (rng.uniform(0.5, 1), 1), material=steel)
        kit.add(CYL, (0, 0, 0.05), (radius * 0.5, radius * 0.5, 0.05), material=steel)
    elif base == "legs":
        for k in range(3):
            spin = np.radians(120 * k + 60)
            kit.between((0, 0, tall), (radius * 0.8 * np.cos(spin), radius * 0.8 * np.sin(spin), 0), 0.05, material=steel)
        kit.add(CYL, (0, 0, tall * 0.9), (0.12, 0.12, tall * 0.12), material=dark)
    elif base == "cabin":
        kit.add(BOX, (0, 0, tall / 2), (radius * rng.uniform(0.7, 1.2), radius * 0.8, tall / 2), material=coat(kit))
        kit.add(BOX, (radius * 0.3, radius * 0.8, tall * 0.4), (0.2, 0.02, tall * 0.4), material=dark)
        kit.add(CYL, (0, 0, tall + 0.1), (0.25, 0.25, 0.12), material=steel)
    else:
        for side in (turn("z", 0), turn("z", 90)):
            kit.add(BOX, (0, 0, tall / 2), (radius * 0.3, radius * 0.3, tall / 2), (0.6, 0.6), rotation=side, material=steel, cut=(LATTICE, 4, 0.25))
    tilt = rng.uniform(-5, 65)
    aim = turn("y", 90 - tilt)  # local z points forward and up
    hub = np.array([0, 0, tall + radius * rng.uniform(0.3, 0.9)])
    kit.between((0, 0, tall), hub, 0.1 * radius + 0.03, material=steel)
    kit.add(BOX, hub - aim @ [0, 0, 0.12], (0.2 * radius, 0.16 * radius, 0.2), rotation=aim, material=steel)
    if kit.chance(0.7):
        depth, rings = radius * rng.uniform(0.2, 0.45), 4
        edges = np.linspace(0.08, 1, rings + 1)
        for inner, outer in zip(edges[:-1], edges[1:], strict=True):
            low, high = depth * inner**2, depth * outer**2
            centre = hub + aim @ np.array([0, 0, (low + high) / 2])
            half = (radius * inner, radius * inner, (high - low) / 2)
            kit.add(TUBE, centre, half, (outer / inner, 1), rotation=aim, material=white)
        focus = hub + aim @ np.array([0, 0, radius * rng.uniform(0.7, 1.0)])
        for k in range(3):
            spin = np.radians(120 * k + 30)
            rim = hub + aim @ np.array([radius * 0.9 * np.cos(spin), radius * 0.9 * np.sin(spin), depth])
            kit.between(rim, focus, 0.02, material=steel)
        kit.add(CYL, focus, (0.08 * radius + 0.02, 0.08 * radius + 0.02, 0.1), rotation=aim, material=dark)
    else:
        panel = (radius * rng.uniform(0.25, 0.6), radius * rng.uniform(0.8, 1.3), 0.06)
        kit.add(BOX, hub + aim @ np.array([0, 0, 0.05]), panel, rotation=aim, material=white, cut=(GRID, 9, 0.4) if kit.chance(0.4) else (0, 1, 1))
        kit.add(BOX, hub - aim @ np.array([0, 0, 0.02]), (panel[0] * 0.9, 0.05, 0.06), rotation=aim, material=steel)
        kit.between(hub, hub + aim @ np.array([-panel[0], 0, radius * 0.6]), 0.03, material=steel)


def warship(kit):
    """Frigates, patrol boats, landing craft and carriers: a long hull with a raked bow, deck houses, gun, mast with radars, boats, a pad."""
    rng = kit.rng
    grey = kit.material(base=rng.uniform(0.2, 0.6) * np.array([0.95, 1, 1.05]), pattern=rng.choice([PLAIN, PLAIN, STREAKS, CAMOUFLAGE])) if kit.chance(0.8) else kit.material()
    deck, dark, glass = kit.material(), kit.material(dark=True), glazing(kit)
    long, wide, side = rng.uniform(2.4, 4.5), rng.uniform(0.36, 0.62), rng.uniform(0.2, 0.4)
    flare = rng.uniform(1.05, 1.25)
    red = kit.material(base=[0.3, 0.04, 0.03], pattern=PLAIN)
    kit.add(BOX, (-long * 0.18, 0, side), (long * 0.68, wide / flare, side), (1.03, flare), material=grey)
    kit.add(BOX, (-long * 0.18, 0, side * 0.18), (long * 0.684, wide / flare * 1.02, side * 0.18), material=red if kit.chance(0.5) else dark)
    bow = side * rng.uniform(1.05, 1.35)
    kit.add(BOX, (long * 0.66, 0, bow), (bow, wide, long * 0.17), (0.85, 0.6), (-bow * 0.12, 0), rotation=ALONG_X, material=grey)
    kit.add(BOX, (long * 0.9, 0, bow * 1.1), (bow * 0.9, wide * 0.6, long * 0.1), (0.7, 0.03), (-bow * 0.3, 0), rotation=ALONG_X, material=grey)
    kit.add(BOX, (-long * 0.16, 0, 2 * side), (long * 0.69, wide * 0.97, 0.02), material=deck)
    top = 2 * side
    flat_top = kit.chance(0.15)
    if flat_top:
        kit.add(BOX, (0, 0, top + 0.1), (long * 0.98, wide * 1.3, 0.05), material=dark)
        kit.add(BOX, (long * rng.uniform(-0.2, 0.3), -wide * 1.0, top + 0.45), (long * 0.18, wide * 0.16, 0.3), (0.8, 0.9), material=grey)
        island = (long * 0.05, -wide * 1.0, top + 0.75)
        for _ in range(int(rng.integers(2, 6))):
            at = (rng.uniform(-0.8, 0.6) * long, rng.uniform(-0.2, 0.9) * wide, top + 0.2)
            kit.add(BOX, at, (0.22, 0.05, 0.05), (0.5, 1), material=deck)
            kit.add(BOX, at, (0.06, 0.2, 0.02), material=deck)
    else:
        x = long * rng.uniform(0.15, 0.4)
        houses = int(rng.integers(1, 4))
        roofs = []
        for _ in range(houses):
            half, tall = long * rng.uniform(0.08, 0.24), rng.uniform(0.12, 0.3)
            x -= half
            slope = rng.uniform(0.8, 0.98)
            kit.add(BOX, (x, 0, top + tall), (half, wide * rng.uniform(0.6, 0.92), tall), (slope, slope), material=grey)
            roofs.append((x, half, top + 2 * tall))
            x -= half + long * rng.uniform(0, 0.08)
        bx, half, roof = roofs[0]
        kit.add(BOX, (bx + half * 0.3, 0, roof + 0.1), (half * 0.5, wide * 0.7, 0.12), (0.9, 0.92), material=grey)
        kit.add(BOX, (bx + half * 0.31, 0, roof + 0.13), (half * 0.5, wide * 0.705, 0.05), (0.95, 0.95), material=glass)
        island = (bx - half * 0.2, 0, roof + 0.15)
        if kit.chance(0.7):
            fx, fhalf, froof = roofs[-1]
            kit.add(BOX, (fx, 0, froof + 0.15), (fhalf * 0.45, wide * 0.35, 0.18), (0.8, 0.75), (-0.05, 0), material=grey)
            kit.add(BOX, (fx - 0.05, 0, froof + 0.34), (fhalf * 0.35, wide * 0.26, 0.03), material=dark)
        for gx in [long * 0.55] + ([-long * 0.7] if kit.chance(0.4) else []):
            kit.add(BOX, (gx, 0, top + 0.1), (0.16, 0.14, 0.1), (0.7, 0.8), material=grey)
            way = 1 if gx > 0 else -1
            kit.between((gx, 0, top + 0.12), (gx + way * rng.uniform(0.3, 0.55), 0, top + 0.2), 0.025, material=dark)
        if kit.chance(0.6):
            kit.add(BOX, (-long * 0.3, wide * 0.85, top + 0.12), (0.28, 0.08, 0.07), (0.8, 0.7), material=kit.material(), mirror=True)
        if kit.chance(0.5):
            kit.add(CYL, (-long * 0.72, 0, top + 0.02), (wide * 0.5, wide * 0.5, 0.012), material=kit.material())
    ix, iy, iz = island
    mast = rng.uniform(0.5, 1.2)
    if kit.chance(0.5):
        kit.add(BOX, (ix, iy, iz + mast / 2), (0.14, 0.12, mast / 2), (0.4, 0.4), material=grey)
    else:
        kit.add(BOX, (ix, iy, iz + mast / 2), (0.12, 0.12, mast / 2), (0.4, 0.4), material=dark, cut=(LATTICE, 6, 0.3))
    for share in rng.uniform(0.5, 1.0, 2):
        kit.add(BOX, (ix + 0.02, iy, iz + mast * share), (0.02, rng.uniform(0.12, 0.3), 0.025), material=dark)
    kit.between((ix, iy, iz + mast), (ix, iy, iz + mast + 0.3), 0.012, material=dark)
    if kit.chance(0.5):
        kit.railing((long * 0.4, wide * 0.95, top), (long * 0.8, wide * 0.4, top), 0.14, dark, 0.1)
        kit.railing((long * 0.4, -wide * 0.95, top), (long * 0.8, -wide * 0.4, top), 0.14, dark, 0.1)


def biplane(kit):
    """Biplanes, floatplanes and crop dusters: two wings or one on struts, wires, an open cockpit, a round engine, wheels or floats."""
    rng = kit.rng
    paint, trim, dark = kit.material(), kit.material(), kit.material(dark=True)
    radius, long = rng.uniform(0.25, 0.4), rng.uniform(1.4, 2.3)
    kit.loft((long * 0.4, 0, 0), [(0, radius), (long * 0.35, radius * 1.02), (long * 0.7, radius * 0.7), (long, radius * 0.25)], paint, axis=turn("y", -90), flat=rng.uniform(0.75, 1), kind=CYL)
    kit.add(CYL, (long * 0.46, 0, 0), (radius * 1.06, radius * 1.06, long * 0.07), (0.85, 1), rotation=ALONG_X, material=trim if kit.chance(0.5) else dark)
    propeller(kit, (long * 0.46 + long * 0.1, 0, 0), rng.uniform(0.45, 0.7), ALONG_X, dark, int(rng.choice([2, 2, 3])))
    span, chord = rng.uniform(1.5, 2.4), rng.uniform(0.26, 0.4)
    wing = trim if kit.chance(0.4) else paint
    stagger, gap = rng.uniform(-0.1, 0.3), rng.uniform(0.75, 1.05)
    double = kit.chance(0.75)
    upper = radius * 0.6 + gap * 0.6
    lower = upper - gap
    dihedral = rng.uniform(0, 4)
    for level, reach, x in ((upper, span, 0.25 + stagger), (lower, span * rng.uniform(0.8, 1), 0.25))[: 2 if double else 1]:
        for y in (-1, 1):
            lift = turn("x", y * dihedral)
            kit.add(BOX, (x, y * reach / 2, level + reach / 2 * np.sin(np.radians(dihedral))), (chord, reach / 2, 0.03), rotation=lift, material=wing)
    for x in (-0.15, 0.15):
        kit.between((0.25 + stagger + x, radius * 0.5, upper), (0.25 + x, radius * 0.6, radius * 0.6), 0.02, material=dark, mirror=True)
        if double:
            kit.between((0.25 + stagger + x, span * 0.75, upper + 0.02), (0.25 + x, span * 0.72, lower + 0.02), 0.02, material=dark, mirror=True)
        else:
            kit.between((0.25 + x, span * 0.55, upper), (0.25 + x, radius * 0.7, -radius * 0.7), 0.022, material=dark, mirror=True)
    if double:
        kit.between((0.25, radius, lower), (0.25 + stagger, span * 0.7, upper), 0.006, material=dark, mirror=True)
        kit.between((0.25, span * 0.7, lower), (0.25 + stagger, radius, upper), 0.006, material=dark, mirror=True)
    for x in (-0.2, -0.62)[: int(rng.integers(1, 3))]:
        kit.add(CYL, (x, 0, radius * 0.95), (0.2, radius * 0.5, 0.05), material=dark)
        kit.add(BOX, (x + 0.2, 0, radius * 1.15), (0.015, radius * 0.4, 0.09), (0.8, 1), (-0.03, 0), material=glazing(kit))
        if kit.chance(0.4):
            kit.add(BALL, (x - 0.05, 0, radius * 1.25), (0.11, 0.1, 0.13), material=kit.material())
    tail = -long * 0.57
    kit.add(BOX, (tail, 0, radius * 0.15), (chord * 0.6, span * rng.uniform(0.28, 0.36), 0.02), (0.8, 1), material=wing)
    kit.add(CYL, (tail - 0.05, 0, radius * 0.6), (chord * 0.6, radius * 0.8, 0.02), rotation=ALONG_Y, material=trim)
    under = -radius - rng.uniform(0.3, 0.5)
    if kit.chance(0.3):
        for y in (-1, 1):
            kit.loft((long * 0.55, y * 0.55, under), [(0, 0.03), (long * 0.25, 0.16), (long * 0.7, 0.15), (long, 0.05)], trim, axis=turn("y", -90))
            for x in (0.0, 0.45):
                kit.between((x, y * 0.55, under), (x, y * radius * 0.7, -radius * 0.7), 0.025, material=dark)
    else:
        tyre = rng.uniform(0.14, 0.22)
        kit.between((0.45, 0.42, under), (0.4, radius * 0.6, -radius * 0.7), 0.025, material=dark, mirror=True)
        kit.between((0.45, 0.42, under), (0.1, radius * 0.6, -radius * 0.7), 0.02, material=dark, mirror=True)
        kit.between((0.45, -0.42, under), (0.45, 0.42, under), 0.02, material=dark)
        kit.add(CYL, (0.45, 0.47, under), (tyre, tyre, 0.045), rotation=ALONG_Y, material=dark, mirror=True)
        kit.between((tail + 0.1, 0, -radius * 0.2), (tail - 0.1, 0, -radius * 0.75), 0.02, material=dark)


def unmanned(kit):
    """Unmanned aircraft and gliders: a bulged nose, long slender wings, a tail of two fins, a V or a boom, a pushing propeller, stores."""
    rng = kit.rng
    paint, dark = kit.material(base=rng.uniform(0.25, 0.9) * np.ones(3), pattern=rng.choice([PLAIN, PLAIN, SEAMS])) if kit.chance(0.6) else kit.material(), kit.material(dark=True)
    trim = paint if kit.chance(0.6) else kit.material()
    radius, long = rng.uniform(0.16, 0.28), rng.uniform(1.2, 2.2)
    bulge = rng.uniform(1.0, 1.5)
    kit.loft((long * 0.5, 0, 0), [(0, radius * 0.3), (long * 0.08, radius * bulge), (long * 0.22, radius * bulge), (long * 0.4, radius), (long * 0.85, radius * 0.8), (long, radius * 0.45)], paint, axis=turn("y", -90), flat=rng.uniform(0.8, 1.1))
    span, chord = rng.uniform(1.5, 3.0), rng.uniform(0.14, 0.26)
    sweep, rise = rng.uniform(-0.05, 0.3), rng.uniform(-0.02, 0.12)
    level = radius * rng.uniform(-0.6, 0.9)
    x = rng.uniform(-0.15, 0.1) * long
    for y in (1, -1):
        kit.add(BOX, (x - sweep / 2, y * span / 2, level + rise / 2), (chord, 0.025, span / 2), (rng.uniform(0.35, 0.8), 1), (-sweep, 0), rotation=turn("x", -90 * y + np.degrees(np.arctan2(rise, span)) * y), material=trim)
    if kit.chance(0.3):
        kit.add(BOX, (x - sweep, span, level + rise + 0.08), (chord * 0.5, 0.015, 0.1), material=trim, mirror=True)
    kind = rng.choice(["vee", "twin", "cross", "low"])
    tail = -long * 0.46
    if kind == "twin":
        boom = span * rng.uniform(0.15, 0.25)
        kit.between((x, boom, level), (tail - 0.5, boom, level + 0.05), 0.035, material=paint, mirror=True)
        kit.add(BOX, (tail - 0.5, boom, level + 0.2), (chord * 0.7, 0.02, 0.2), (0.7, 1), (-0.08, 0), material=trim, mirror=True)
        kit.add(BOX, (tail - 0.5, 0, level + rng.choice([0.05, 0.38])), (chord * 0.6, boom, 0.015), material=trim)
    elif kind == "cross":
        kit.add(BOX, (tail, 0, 0.28), (chord * 0.8, 0.02, 0.28), (0.6, 1), (-0.12, 0), material=trim)
        kit.add(BOX, (tail - 0.05, 0, rng.choice([0.05, 0.54])), (chord * 0.6, 0.5, 0.015), material=trim)
    else:
        lean = rng.uniform(35, 55) * (1 if kind == "vee" else -1)
        out = turn("x", -lean) @ np.array([0, 0, 1.0])
        reach = rng.uniform(0.3, 0.55)
        for y in (1, -1):
            way = np.array([0, abs(out[1]) * y, out[2] if kind == "vee" else -abs(out[2]) * 0.6])
            kit.between((tail, 0, 0), np.array([tail - 0.12, 0, 0]) + way * reach, (0.02, chord * 0.7), BOX, 0.7, material=trim)
        if kind == "low":
            kit.add(BOX, (tail, 0, 0.18), (chord * 0.7, 0.02, 0.2), (0.6, 1), (-0.1, 0), material=trim)
    if kit.chance(0.7):
        back = kind != "twin" or kit.chance(0.6)
        propeller(kit, (-long * 0.52 if back else long * 0.52, 0, 0), rng.uniform(0.25, 0.4), ALONG_X, dark)
    if kit.chance(0.6):
        kit.add(BALL, (long * 0.33, 0, -radius * bulge * 0.95), (0.1, 0.1, 0.1), material=dark)
    if kit.chance(0.4):
        kit.add(CYL, (x, span * 0.35, level - 0.1), (0.04, 0.04, 0.25), (0.8, 1), rotation=ALONG_X, material=dark, mirror=True)
        kit.add(BOX, (x, span * 0.35, level - 0.05), (0.05, 0.01, 0.05), material=dark, mirror=True)
    if kit.chance(0.65):
        under = -radius * bulge - rng.uniform(0.2, 0.4)
        for px, py in ((long * 0.3, 0), (-long * 0.15, 0.3)):
            kit.between((px, py * 0.4, -radius * 0.6), (px, py, under), 0.02, material=dark, mirror=py > 0)
            kit.add(CYL, (px, py, under), (0.08, 0.08, 0.03), rotation=ALONG_Y, material=dark, mirror=py > 0)


def truss_bridge(kit):
    """A bridge span: a deck on piers between trusses, railings or cables from a pair of pylons."""
    rng = kit.rng
    steel, deck, stone = kit.material(), kit.material(), kit.material(pattern=rng.choice([PLAIN, CLOUDY, SEAMS]))
    long, wide, tall = rng.uniform(1.8, 3.6), rng.uniform(0.3, 0.6), rng.uniform(0.4, 1.0)
    kit.add(BOX, (0, 0, tall), (long, wide, 0.06), material=deck)
    for x in np.linspace(-1, 1, int(rng.integers(2, 5))):
        kit.add(BOX, (x * long * 0.93, 0, tall / 2), (0.12, wide * 0.8, tall / 2), (0.8, 0.9), material=stone)
    kind, high = rng.random(), rng.uniform(0.35, 0.8)
    if kind < 0.5:
        bays = int(rng.integers(4, 8))
        edges = np.linspace(-long, long, bays + 1)
        for k, (a, b) in enumerate(zip(edges[:-1], edges[1:], strict=True)):
            up, down = (tall, tall + high) if k % 2 == 0 else (tall + high, tall)
            kit.between((a, wide, up), (b, wide, down), 0.03, BOX, material=steel, mirror=True)
        kit.between((-long * (1 - 2 / bays / 2), wide, tall + high), (long * (1 - 2 / bays / 2), wide, tall + high), 0.035, BOX, material=steel, mirror=True)
        for x in edges[1:-1:2]:
            kit.between((x, -wide, tall + high), (x, wide, tall + high), 0.025, BOX, material=steel)
    elif kind < 0.75:
        for x in (-0.5, 0.5):
            kit.between((x * long, wide, 0), (x * long, wide, tall + 2 * high), (0.06, 0.05), BOX, material=stone, mirror=True)
            kit.between((x * long, -wide, tall + 1.8 * high), (x * long, wide, tall + 1.8 * high), 0.04, BOX, material=stone)
            for reach in (0.16, 0.32, 0.48):
                for way in (-1, 1):
                    kit.between((x * long, wide, tall + 1.9 * high), (x * long + way * reach * long, wide, tall), 0.012, material=steel, mirror=True)
    else:
        angles = np.linspace(0, np.pi, int(rng.integers(6, 9)))
        arch = [(-long * 0.9 * np.cos(a), wide, tall + high * 1.3 * np.sin(a)) for a in angles]
        for start, end in zip(arch[:-1], arch[1:], strict=True):
            kit.between(start, end, 0.035, BOX, material=steel, mirror=True)
        for x, y, z in arch[1:-1]:
            kit.between((x, y, tall), (x, y, z), 0.012, material=steel, mirror=True)
        for y in (-wide, wide):
            kit.railing((-long, y, tall), (long, y, tall), 0.25, steel, 0.2)
