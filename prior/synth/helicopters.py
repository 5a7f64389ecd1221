"""A maker of helicopters by their real types: utility, light, attack and heavy ones, in service and civil liveries."""

from typing import NamedTuple

import numpy as np

from .flyers import panel
from .kit import ALONG_X, ALONG_Y, towards, turn
from .layout import BALL, BOX, CYL, SPOKES, TUBE
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, RIBS, SEAMS, STREAKS, WRITING, Material, paint

ARMY = [[0.1, 0.11, 0.05], [0.06, 0.07, 0.04], [0.4, 0.32, 0.19], [0.025, 0.027, 0.025], [0.13, 0.16, 0.1], [0.16, 0.16, 0.15]]
NAVY = [[0.3, 0.33, 0.36], [0.5, 0.53, 0.55], [0.13, 0.16, 0.2], [0.75, 0.76, 0.76], [0.04, 0.07, 0.16]]
RESCUE = [[0.75, 0.5, 0.02], [0.65, 0.05, 0.03], [0.8, 0.2, 0.03], [0.82, 0.82, 0.8], [0.75, 0.68, 0.05]]
POLICE = [[0.02, 0.04, 0.16], [0.8, 0.8, 0.8], [0.03, 0.12, 0.4], [0.02, 0.02, 0.02], [0.04, 0.2, 0.08]]
ROLES = ["army", "navy", "rescue", "police", "civil"]


class Look(NamedTuple):
    """A helicopter's role, whether it flies, and its materials."""

    role: str
    flies: bool
    skin: Material
    trim: Material
    dark: Material
    glass: Material
    metal: Material
    blade: Material
    tips: Material


class Hull(NamedTuple):
    """A smooth body along x: half sizes at its rear, the front's share of them (high, wide), how far it lies higher, its exponent."""

    centre: np.ndarray
    half: tuple
    power: float
    taper: tuple
    rise: float


def helicopter_type(kit):
    """Helicopters by type: Huey, Black Hawk, NH90, Mi-8, Puma, Lynx, AW139, JetRanger, MD 500, EC135 and kin, Robinson, Gazelle, Alouette,
    Apache, Cobra, Mi-24, Tiger, Mangusta, Ka-52, Ka-27, Stallion, Mi-26, sky crane, Chinook."""
    rng = kit.rng
    light, armed = [jet_ranger, egg, egg, fenestron_copter, fenestron_copter, robinson, gazelle, alouette], [apache, apache, cobra, hind, tiger, alligator]
    utility, heavy = [huey, huey, black_hawk, black_hawk, nh90, mi8, puma, lynx, aw139], [stallion, halo, sky_crane, chinook, chinook, helix]
    group = [light, armed, utility, heavy][rng.choice(4, p=[0.28, 0.22, 0.3, 0.2])]
    build = group[rng.integers(len(group))]
    chances = [0.15, 0.05, 0.2, 0.2, 0.4] if group is light else [0.95, 0.05, 0, 0, 0] if group is armed else [0.4, 0.2, 0.2, 0.08, 0.12]
    look = draw_look(kit, rng.choice(ROLES, p=chances))
    build(kit, look)
    if look.flies:
        lean = turn("y", rng.uniform(2, 9)) @ turn("x", rng.uniform(-6, 6) if kit.chance(0.4) else 0)
        kit.primitives[:] = [p._replace(centre=lean @ p.centre, rotation=lean @ p.rotation) for p in kit.primitives]


def draw_look(kit, role):
    """Paint as of the role, panes, metals, blades with tips of another colour or none."""
    rng = kit.rng
    white = kit.material(base=np.ones(3) * rng.uniform(0.65, 0.88), pattern=PLAIN, gloss=rng.uniform(0.1, 0.5))
    if role in ("army", "navy"):
        table = ARMY if role == "army" else NAVY
        base = np.array(table[rng.integers(len(table))]) * rng.uniform(0.7, 1.4)
        patterns = [PLAIN, PLAIN, SEAMS, CAMOUFLAGE, CAMOUFLAGE, STREAKS] if role == "army" else [PLAIN, PLAIN, SEAMS, STREAKS, CLOUDY]
        second = np.array([[0.02, 0.02, 0.02], [0.09, 0.06, 0.03], [0.05, 0.07, 0.03]][rng.integers(3)])
        pattern = rng.choice(patterns)
        second = second if pattern == CAMOUFLAGE else base * rng.uniform(0.6, 0.85)
        skin = kit.material(base=base, second=second, pattern=pattern, frequency=rng.uniform(3, 9), gloss=rng.uniform(0, 0.12))
        trim = kit.material(base=base * rng.uniform(0.5, 0.9), pattern=PLAIN, gloss=0.05)
    else:
        table = {"rescue": RESCUE, "police": POLICE}.get(role)
        base = np.array(table[rng.integers(5)]) if table else paint(rng.random(), rng.uniform(0.6, 1), rng.uniform(0.1, 0.8))
        skin = kit.material(base=base * rng.uniform(0.9, 1.1), pattern=PLAIN, gloss=rng.uniform(0.2, 0.6))
        trim = white if base.min() < 0.6 else kit.material(base=paint(rng.random(), rng.uniform(0.7, 1), rng.uniform(0.1, 0.7)), pattern=PLAIN, gloss=0.4)
        if kit.chance(0.3):
            skin, trim = trim, skin
    dark = kit.material(base=np.ones(3) * rng.uniform(0.015, 0.05), pattern=PLAIN, gloss=0.1)
    metal = kit.material(base=np.ones(3) * rng.uniform(0.12, 0.5), pattern=rng.choice([PLAIN, CLOUDY]), gloss=0.4)
    tint = np.array([[0.02, 0.025, 0.03], [0.05, 0.07, 0.09], [0.1, 0.14, 0.17], [0.03, 0.05, 0.04]][rng.integers(4)])
    glass = kit.material(base=tint * rng.uniform(0.7, 1.3), pattern=PLAIN, gloss=rng.uniform(0.35, 0.64))
    blade = dark if kit.chance(0.6) else kit.material(base=np.ones(3) * rng.choice([0.1, 0.25, 0.6]), pattern=PLAIN, gloss=0.2)
    tips = kit.material(base=[[0.8, 0.6, 0.03], [0.85, 0.85, 0.85], [0.7, 0.05, 0.03]][rng.integers(3)], pattern=PLAIN) if kit.chance(0.5) else blade
    return Look(role, kit.chance(0.3), skin, trim, dark, glass, metal, blade, tips)


def hull(kit, centre, half, material, power=3.0, taper=(1.0, 1.0), rise=0.0, lift=0.0):
    """A smooth convex body along x, its front `taper` of its rear and `rise` higher, all turned `lift` degrees nose up."""
    x, y, z = half
    kit.add(BOX, centre, (z, y, x), taper, (-rise, 0), turn("y", -lift) @ ALONG_X, material)
    kit.primitives[-1] = kit.primitives[-1]._replace(bevel=power)
    return Hull(np.array(centre, float), half, power, taper, rise)


def pane(kit, body, x, z, half, material, kind=BOX, thick=0.03, mirror=True, lean=(1, 1), side=1):
    """A thin plate on a hull's left side, at shares x and z of its half sizes, along its surface."""
    p, k = body.power, (1 + x) / 2
    grown = np.array(body.half) * [1, 1 + (body.taper[1] - 1) * k, 1 + (body.taper[0] - 1) * k]
    y = max(1 - abs(x) ** p - abs(z) ** p, 0.01) ** (1 / p)
    out = np.sign([x, 1, z]) * np.abs([x, y, z]) ** (p - 1) / grown
    out[0] -= out[1] * y * (body.taper[1] - 1) * body.half[1] / (2 * body.half[0])
    out /= np.linalg.norm(out)
    along = np.array([1.0, 0, 0]) - out * out[0]
    along /= np.linalg.norm(along)
    point = (body.centre + grown * [x, y, z] + [0, 0, body.rise * k] - out * thick * 0.3) * [1, side, 1]
    rotation = np.stack([along, np.cross(out, along), out], 1)
    flip = np.diag([1.0, side, 1])
    kit.add(kind, point, (*half, thick), lean, rotation=flip @ rotation @ flip, material=material, mirror=mirror)


def windows(kit, body, places, z, half, look, kind=BOX):
    for x in places:
        pane(kit, body, x, z, half, look.glass, kind)


def cockpit(kit, centre, half, look, power=2.6, taper=(1.0, 1.0), rise=0.0, post=True, hoop=None):
    """A glazed hull with a post down its middle and a frame across at a share of its length."""
    body = hull(kit, centre, half, look.glass, power, taper, rise)
    if post:
        hull(kit, centre, (half[0] * 1.006, half[1] * 0.045, half[2] * 1.012), look.skin, power, (taper[0], 1), rise)
    if hoop is not None:
        k, left = (1 + hoop) / 2, (1 - abs(hoop) ** power) ** (1 / power) * 1.015
        wide, high = half[1] * (1 + (taper[1] - 1) * k) * left, half[2] * (1 + (taper[0] - 1) * k) * left
        hull(kit, (centre[0] + half[0] * hoop, 0, centre[2] + rise * k), (half[0] * 0.05, wide, high), look.skin, max(power, 3))
    return body


def boom(kit, points, radii, material, flat=1.0):
    """A round body through points of the given heights (radii), `flat` times as wide."""
    for k in range(len(points) - 1):
        kit.between(points[k], points[k + 1], (radii[k], radii[k] * flat), CYL, radii[k + 1] / radii[k], material)


def main_rotor(kit, hub, reach, blades, chord, look, rise=0.6, folds=False, paddle=False, pace=0.0):
    """Mast, swash plate, hub, grips and slender blades, hanging at rest and coned in flight, or folded over the tail."""
    rng, hub = kit.rng, np.array(hub, float)
    lift = rng.uniform(0.03, 0.07) if look.flies else -rng.uniform(0.0, 0.045)
    size, first = reach / 8, rng.uniform(0, 360) + pace
    kit.between(hub - [0, 0, rise], hub, 0.1 * size + 0.03, material=look.metal)
    kit.add(CYL, hub - [0, 0, rise * 0.5], (0.3 * size, 0.3 * size, 0.05 * size), material=look.dark)
    kit.add(CYL, hub, (0.36 * size, 0.36 * size, 0.12 * size), (0.7, 1), material=look.metal)
    turns = [first + 360 * k / blades for k in range(blades)]
    if folds and not look.flies:
        turns = 180 + np.linspace(-1, 1, blades) * rng.uniform(10, 22)
    pitch = rng.uniform(3, 10)
    for k, angle in enumerate(turns):
        way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle)), lift - (0.012 * (k % 2) if folds else 0)])
        spin = towards(way) @ turn("z", pitch)
        if blades < 6:
            kit.between(hub, hub + way * reach * 0.15, (0.07 * size, 0.11 * size), material=look.metal)
        kit.add(BOX, hub + way * reach * 0.54, (0.03 * size + 0.006, chord, reach * 0.46), rotation=spin, material=look.blade)
        if paddle:
            kit.add(BOX, hub + way * reach * 0.94, (0.03 * size + 0.007, chord * 1.45, reach * 0.06), (1, 0.75), rotation=spin, material=look.blade)
        elif look.tips is not look.blade and blades < 5:
            kit.add(BOX, hub + way * reach * 0.965, (0.032 * size + 0.008, chord * 1.02, reach * 0.035), rotation=spin, material=look.tips)


def tail_rotor(kit, hub, radius, blades, look, shaft=0.3, cant=0.0):
    """Blades in the plane of x and z beside the fin, on a shaft from y = 0."""
    hub, first, chord = np.array(hub, float), kit.rng.uniform(0, 180), radius * 0.085
    away = shaft * np.sign(hub[1] or 1)
    kit.between(hub - [0, away, 0], hub + [0, 0.06 * np.sign(away), 0], radius * 0.08, material=look.metal)
    for k in range(blades // 2 if blades % 2 == 0 else blades):
        angle = np.radians(first + 360 * k / blades)
        way = turn("x", cant) @ np.array([np.cos(angle), 0, np.sin(angle)]) * radius
        start = hub - way if blades % 2 == 0 else hub
        kit.between(start, hub + way, (chord, 0.016 + radius * 0.006), BOX, material=look.blade)


def fenestron(kit, middle, radius, look, skin, thick=0.16):
    """A fan in a pierced ring."""
    ring, hub = radius / 0.86, radius * 0.24
    kit.add(CYL, middle, (ring, ring, thick), rotation=ALONG_Y, material=skin, cut=(SPOKES, 1, 0.0))
    kit.add(TUBE, middle, (radius, radius, thick), rotation=ALONG_Y, material=look.dark)
    kit.add(CYL, middle, (radius * 1.05, radius * 1.05, 0.04), rotation=ALONG_Y, material=look.metal, cut=(SPOKES, int(kit.rng.choice([8, 10, 11, 13])), 0.22))
    kit.add(CYL, middle, (hub, hub, thick * 0.8), rotation=ALONG_Y, material=look.dark)


def skids(kit, front, rear, wide, belly, look, radius=0.045, inner=0.4):
    """Two tubes with raised toes on two bent cross tubes; some with steps."""
    bare = look.dark if kit.chance(0.5) else look.metal if kit.chance(0.6) else look.skin
    knee = np.array([0, wide * 0.78, belly - 0.08])
    for x in (front, rear):
        at = np.array([x, 0, 0])
        kit.between(at + [0, inner * 0.3, belly + 0.06], at + knee, radius * 0.9, material=bare, mirror=True)
        kit.between(at + knee, at + [0, wide, radius], radius * 0.9, material=bare, mirror=True)
    kit.add(CYL, ((front + rear) / 2 - 0.1, wide, radius), (radius, radius, (front - rear) / 2 + 0.5), rotation=ALONG_X, material=bare, mirror=True)
    kit.between((front + 0.38, wide, radius), (front + 0.85, wide, radius + 0.22), radius, material=bare, mirror=True)
    if kit.chance(0.4):
        kit.add(BOX, ((front + rear) / 2 + 0.3, wide * 0.9, belly * 0.55 + 0.03), ((front - rear) / 2 + 0.32, 0.09, 0.02), material=bare, mirror=True)


def gear(kit, points, radius, look, thick=0.09, twin=False):
    """Wheels below points (x, y, z) where their legs begin, y = 0: one in the middle, or two side by side."""
    for x, y, z in points:
        kit.between((x, y * 0.92, z), (x, y, radius), radius * 0.22, material=look.metal, mirror=y > 0)
        if twin and y == 0:
            kit.add(CYL, (x, thick * 1.4, radius), (radius, radius, thick), rotation=ALONG_Y, material=look.dark, mirror=True)
            continue
        kit.add(CYL, (x, y, radius), (radius, radius, thick), rotation=ALONG_Y, material=look.dark, mirror=y > 0)
        kit.add(CYL, (x, y, radius), (radius * 0.5, radius * 0.5, thick * 1.15), rotation=ALONG_Y, material=look.metal, mirror=y > 0)


def engines(kit, x, y, z, radius, long, look, skin=None, out=12):
    """Two nacelles with dark mouths in front and exhausts turned outwards behind."""
    kit.add(CYL, (x, y, z), (radius, radius, long), (0.9, 1), rotation=turn("y", -90), material=skin or look.skin, mirror=True)
    kit.add(CYL, (x + long, y, z), (radius * 0.74, radius * 0.74, 0.02), rotation=ALONG_X, material=look.dark, mirror=True)
    way = np.array([-np.cos(np.radians(out)), np.sin(np.radians(out)), 0.1])
    kit.between(np.array([x - long * 0.85, y, z]), np.array([x - long, y, z]) + way * radius * 1.8, radius * 0.68, material=look.dark, mirror=True)


def markings(kit, look, body, x, z, size):
    """On both sides: a roundel, a star's field, a red cross, or letters, as the role has it."""
    rng = kit.rng
    if look.role in ("army", "navy"):
        first = kit.material(base=[[0.03, 0.05, 0.25], [0.5, 0.03, 0.03], [0.02, 0.02, 0.02], [0.03, 0.2, 0.08]][rng.integers(4)], pattern=PLAIN)
        pane(kit, body, x, z, (size, size), first, CYL, 0.02)
        if kit.chance(0.6):
            pane(kit, body, x, z, (size * 0.5, size * 0.5), kit.material(base=[0.7] * 3, pattern=PLAIN), CYL, 0.03)
    elif look.role == "rescue" and kit.chance(0.6):
        red = kit.material(base=[0.6, 0.02, 0.02], pattern=PLAIN)
        pane(kit, body, x, z, (size * 1.2, size * 1.2), kit.material(base=[0.85] * 3, pattern=PLAIN), BOX, 0.015)
        pane(kit, body, x, z, (size * 0.9, size * 0.3), red, BOX, 0.022)
        pane(kit, body, x, z, (size * 0.3, size * 0.9), red, BOX, 0.022)
    else:
        letters = kit.material(base=look.skin.first, second=look.trim.first, pattern=WRITING, frequency=rng.uniform(10, 25))
        pane(kit, body, x, z, (size * 3, size * 0.8), letters, BOX, 0.015)


def stripe(kit, body, z, high, material):
    """A belt of another colour round a hull, at a share of its height."""
    left = (1 - abs(z) ** body.power) ** (1 / body.power) * 1.012
    x, y, tall = body.half
    hull(kit, body.centre + [0, 0, z * tall], (x * left, y * left, tall * high), material, 6.0, (1, body.taper[1]), body.rise)


def extras(kit, look, front, belly, side, roof):
    """Searchlights, sensor balls, winches, aerials, beacons, at x = front under the belly, beside the door and on the roof."""
    if look.role != "civil" and kit.chance(0.6):
        kit.between((front, 0, belly + 0.25), (front, 0, belly - 0.1), 0.07, material=look.dark)
        kit.add(BALL, (front, 0, belly - 0.14), (0.2, 0.2, 0.2), material=look.dark if kit.chance(0.6) else look.metal)
        kit.add(CYL, (front + 0.13, 0, belly - 0.16), (0.1, 0.1, 0.08), rotation=ALONG_X, material=look.glass)
    if look.role in ("rescue", "navy") and kit.chance(0.8):
        x, y = front - 1.6, side * 0.7
        kit.between((x, y, roof - 0.05), (x, side + 0.3, roof + 0.02), 0.06, material=look.metal)
        kit.add(CYL, (x, side + 0.25, roof - 0.05), (0.13, 0.13, 0.22), rotation=ALONG_X, material=look.metal)
        kit.between((x, side + 0.3, roof), (x, side + 0.3, roof - 0.5), 0.016, material=look.dark)
    if kit.chance(0.4):
        kit.add(BOX, (front - 0.8, 0, belly - 0.1), (0.1, 0.015, 0.18), (1.4, 1), (-0.1, 0), material=look.dark)
    red = kit.material(base=[0.6, 0.03, 0.02], pattern=PLAIN, gloss=0.5)
    kit.add(BALL, (front - 1.2, 0, belly), (0.09, 0.09, 0.08), material=red)


def huey(kit, look):
    """UH-1 and Bell 212 or 412: a round nose, wide doors, skids, a boom from the cabin's upper half, two broad blades or four."""
    rng, twin = kit.rng, kit.chance(0.35)
    long = rng.uniform(1.7, 2.2)
    cabin = hull(kit, (0.3, 0, 1.3), (long + 0.15, 1.25, 0.92), look.skin, 4.5)
    nose = 0.3 + long
    hull(kit, (nose - 0.1, 0, 1.0), (1.5, 1.12, 0.58), look.skin, 2.6, (0.6, 0.6), 0.02)
    cockpit(kit, (nose - 0.15, 0, 1.45), (0.98, 1.12, 0.7), look, 2.6, (0.75, 0.85), -0.1, hoop=0.0)
    cowl = hull(kit, (-0.7, 0, 2.3), (1.5, 0.62, 0.45), look.skin, 3.5, (0.9, 0.9), 0.05)
    pane(kit, cowl, 0.55, 0, (0.28, 0.24), look.dark)
    boom(kit, [(-0.9, 0, 1.45), (-2.6, 0, 1.7), (-7.6, 0, 2.2)], [0.85, 0.5, 0.2], look.skin, 0.85)
    for y in (0.25, -0.25) if twin else (0,):
        kit.between((-1.8, y, 2.35), (-2.6, y, 2.48), 0.2 if twin else 0.26, material=look.metal)
        kit.add(BALL, (-2.62, y, 2.48), (0.03, 0.17, 0.17), material=look.dark)
    panel(kit, (-7.4, 0, 2.05), 1.75, 0.42, look.trim if kit.chance(0.3) else look.skin, 0.7, 0.75, 90, 0.08, False)
    panel(kit, (-5.2, 0, 1.98), 1.35, 0.32, look.skin, 0.75, 0.05, 0, 0.05)
    tail_rotor(kit, (-8.1, 0.3, 3.65), 1.25, 2, look)
    main_rotor(kit, (0, 0, 3.65), rng.uniform(6.6, 7.3), 4 if twin and kit.chance(0.6) else 2, 0.27, look, 1.0)
    if kit.chance(0.2):
        kit.add(BOX, (0.1, 1.15, 1.25), (0.75, 0.12, 0.68), material=look.dark, mirror=True)
    else:
        windows(kit, cabin, (0.22, -0.28), 0.33, (0.4, 0.32), look)
    pane(kit, cabin, 0.72, 0.3, (0.26, 0.32), look.glass)
    skids(kit, 1.3, -0.95, 1.35, 0.42, look, 0.06, 0.6)
    if look.role not in ("army", "navy"):
        stripe(kit, cabin, -0.3, 0.14, look.trim)
    elif kit.chance(0.35):
        kit.between((0.2, 1.0, 0.75), (0.2, 1.75, 0.8), 0.06, BOX, material=look.dark, mirror=True)
        kit.add(CYL, (0.3, 1.75, 0.72), (0.2, 0.2, 0.75), rotation=ALONG_X, material=look.skin, mirror=True)
    markings(kit, look, cabin, -0.68, -0.05, 0.2)
    extras(kit, look, 2.2, 0.5, 1.2, 2.15)


def black_hawk(kit, look):
    """UH-60 and SH-60: a low, long cabin, engines at the mast, a tapering tail on its own wheel, a wide stabilator, a canted tail rotor."""
    rng, naval = kit.rng, look.role == "navy"
    cabin = hull(kit, (0.1, 0, 1.42), (2.9, 1.17, 0.92), look.skin, 5.0)
    hull(kit, (3.0, 0, 1.22), (1.7, 1.02, 0.68), look.skin, 3.0, (0.5, 0.62), -0.1)
    cockpit(kit, (2.75, 0, 1.6), (1.08, 1.05, 0.66), look, 3.0, (0.7, 0.85), -0.15, hoop=0.05)
    hull(kit, (0.0, 0, 2.45), (1.9, 0.72, 0.42), look.skin, 3.2, (0.7, 0.8), -0.08)
    engines(kit, -0.45, 0.78, 2.45, 0.36, 0.85, look)
    boom(kit, [(-1.6, 0, 1.5), (-3.6, 0, 1.7), (-9.2, 0, 1.95)], [0.92, 0.68, 0.3], look.skin, 0.9)
    hull(kit, (-2.7, 0, 2.1), (1.7, 0.5, 0.42), look.skin, 2.6)
    panel(kit, (-9.0, 0, 1.75), 2.3, 0.62, look.skin, 0.6, 1.2, 90, 0.13, False)
    kit.add(BOX, (-9.3, 0, 1.85), (0.55, 2.15, 0.06), (0.95, 1), rotation=turn("y", -rng.uniform(0, 35)), material=look.skin)
    tail_rotor(kit, (-10.1, -0.4, 3.9), 1.67, 4, look, 0.4, 20)
    main_rotor(kit, (0, 0, 3.55), rng.uniform(7.2, 8.1), 4, 0.25, look, 0.8, naval and kit.chance(0.5))
    gear(kit, [(1.6, 1.35, 0.9)], 0.35, look, 0.12)
    kit.between((0.7, 1.0, 0.8), (1.6, 1.3, 0.4), 0.07, material=look.metal, mirror=True)
    gear(kit, [(-4.2 if naval else -8.4, 0, 1.5)], 0.24, look, 0.09, naval)
    windows(kit, cabin, (-0.42, -0.12), 0.4, (0.33, 0.24), look)
    pane(kit, cabin, 0.72, 0.35, (0.38, 0.28), look.glass)
    pane(kit, cabin, 0.28, 0.35, (0.22, 0.22), look.dark)
    if kit.chance(0.3):
        kit.between((0.0, 0.6, 2.25), (-0.1, 2.7, 2.0), (0.06, 0.25), BOX, material=look.skin, mirror=True)
        kit.add(BALL, (0.0, 2.2, 1.5), (1.9, 0.36, 0.36), material=look.skin, mirror=True)
        kit.add(BOX, (-0.05, 2.2, 1.9), (0.3, 0.05, 0.2), material=look.skin, mirror=True)
    elif naval:
        kit.add(CYL, (1.5, 0, 0.48), (0.6, 0.6, 0.12), material=look.metal)
    markings(kit, look, cabin, -0.75, 0.1, 0.2)
    extras(kit, look, 3.9, 0.7, 1.1, 2.3)


def nh90(kit, look):
    """NH90: a smooth body of diamond section with sponsons, a low slung slender boom, one stabiliser, four blades."""
    rng = kit.rng
    cabin = hull(kit, (0.3, 0, 1.5), (3.1, 1.2, 0.98), look.skin, 4.5)
    hull(kit, (3.2, 0, 1.25), (1.75, 1.08, 0.7), look.skin, 2.6, (0.45, 0.55), -0.1)
    cockpit(kit, (2.9, 0, 1.7), (1.35, 1.06, 0.68), look, 2.7, (0.55, 0.75), -0.3, hoop=-0.05)
    kit.add(BOX, (0.3, 0, 1.15), (2.5, 1.2, 0.3), (0.96, 1.12), material=look.skin)
    cowl = hull(kit, (-0.6, 0, 2.6), (2.4, 0.95, 0.5), look.skin, 3.0, (0.75, 0.75), -0.05)
    pane(kit, cowl, 0.45, 0.1, (0.35, 0.22), look.dark)
    engines(kit, -1.7, 0.55, 2.6, 0.34, 0.7, look, out=25)
    boom(kit, [(-1.5, 0, 1.6), (-4.2, 0, 1.95), (-9.3, 0, 2.1)], [0.98, 0.52, 0.27], look.skin, 0.9)
    panel(kit, (-9.1, 0, 1.95), 2.2, 0.6, look.skin, 0.65, 1.0, 90, 0.12, False)
    kit.add(BOX, (-9.9, -0.85, 3.2), (0.4, 0.85, 0.05), material=look.skin)
    tail_rotor(kit, (-9.85, 0.35, 3.75), 1.6, 4, look)
    main_rotor(kit, (0, 0, 3.85), rng.uniform(7.2, 8.1), 4, 0.3, look, 0.85, look.role == "navy" and kit.chance(0.5))
    hull(kit, (-1.6, 1.3, 0.95), (1.15, 0.38, 0.38), look.skin, 3.0)
    hull(kit, (-1.6, -1.3, 0.95), (1.15, 0.38, 0.38), look.skin, 3.0)
    gear(kit, [(-1.7, 1.35, 0.8)], 0.36, look, 0.13)
    gear(kit, [(3.2, 0, 0.9)], 0.27, look, 0.09, True)
    kit.add(BOX, (-0.15, 1.19, 1.5), (0.85, 0.03, 0.72), material=look.trim, mirror=True)
    windows(kit, cabin, (-0.22, 0.04), 0.35, (0.24, 0.24), look)
    windows(kit, cabin, (0.65, -0.55), 0.38, (0.35, 0.24), look)
    markings(kit, look, cabin, -0.72, 0.05, 0.2)
    extras(kit, look, 4.0, 0.7, 1.15, 2.4)


def mi8(kit, look):
    """Mi-8 and Mi-17: a long round bus with round windows, a glazed nose, side tanks, twin mouths above the cockpit, five blades."""
    rng = kit.rng
    cabin = hull(kit, (0.0, 0, 1.75), (4.3, 1.25, 1.18), look.skin, 5.0)
    hull(kit, (3.9, 0, 1.55), (1.5, 1.12, 0.98), look.skin, 2.6, (0.75, 0.75), 0)
    cockpit(kit, (4.0, 0, 1.85), (1.52, 1.13, 0.85), look, 2.6, (0.8, 0.85), -0.12, hoop=0.12)
    if kit.chance(0.7):
        hull(kit, (3.95, 0, 1.5), (1.6, 0.98, 0.08), look.skin, 2.5)
    hull(kit, (-0.6, 0, 3.2), (3.2, 0.82, 0.52), look.skin, 3.5, (0.85, 0.95), -0.05)
    engines(kit, 1.4, 0.44, 3.25, 0.4, 1.3, look)
    kit.between((0, 0.6, 3.2), (-0.4, 1.15, 3.2), 0.28, material=look.dark, mirror=True)
    boom(kit, [(-2.4, 0, 1.95), (-4.8, 0, 2.5), (-11.6, 0, 2.85)], [1.15, 0.68, 0.32], look.skin, 0.95)
    kit.between((-11.3, 0, 2.8), (-12.7, 0, 4.3), (0.5, 0.16), CYL, 0.65, material=look.skin)
    kit.add(BOX, (-10.5, 0, 2.75), (0.4, 1.35, 0.05), material=look.skin)
    tail_rotor(kit, (-12.6, kit.rng.choice([-0.35, 0.35]), 4.3), 1.9, 3, look)
    main_rotor(kit, (0, 0, 4.55), rng.uniform(9.0, 10.6), 5, 0.26, look, 0.95)
    kit.add(CYL, (0.6, 1.35, 1.1), (0.42, 0.36, 1.6), rotation=ALONG_X, material=look.skin, mirror=True)
    kit.add(BALL, (2.2, 1.35, 1.1), (0.4, 0.36, 0.42), material=look.skin, mirror=True)
    gear(kit, [(-1.5, 2.1, 1.0)], 0.43, look, 0.14)
    kit.between((-1.5, 2.05, 0.45), (-1.0, 0.8, 0.9), 0.08, material=look.metal, mirror=True)
    gear(kit, [(3.2, 0, 0.9)], 0.28, look, 0.1, True)
    for x in np.linspace(0.5, -0.62, int(rng.integers(4, 6))):
        pane(kit, cabin, x, 0.28, (0.22, 0.22), look.glass, CYL)
    markings(kit, look, cabin, -0.78, 0.0, 0.24)


def puma(kit, look):
    """Puma and Cougar: a boxy cabin with wide windows, a bluff nose, sponsons behind, mouths above the cockpit, four blades."""
    rng = kit.rng
    cabin = hull(kit, (-0.2, 0, 1.6), (3.4, 1.05, 1.05), look.skin, 6.0)
    hull(kit, (3.1, 0, 1.3), (1.8, 0.98, 0.72), look.skin, 2.6, (0.55, 0.6), -0.05)
    cockpit(kit, (2.85, 0, 1.75), (1.25, 1.0, 0.78), look, 2.8, (0.65, 0.8), -0.2, hoop=0.0)
    hull(kit, (-0.3, 0, 2.85), (2.6, 0.68, 0.45), look.skin, 3.5, (0.8, 0.9), -0.05)
    engines(kit, 1.1, 0.36, 2.85, 0.33, 0.9, look)
    kit.between((-0.2, 0.5, 2.85), (-0.7, 0.95, 2.9), 0.22, material=look.dark, mirror=True)
    boom(kit, [(-2.3, 0, 1.7), (-4.6, 0, 2.1), (-8.9, 0, 2.4)], [1.02, 0.6, 0.28], look.skin, 0.9)
    panel(kit, (-8.6, 0, 2.15), 1.9, 0.6, look.trim if kit.chance(0.3) else look.skin, 0.65, 0.9, 90, 0.12, False)
    kit.add(BOX, (-9.1, 0.8, 2.75), (0.38, 0.8, 0.05), material=look.skin)
    tail_rotor(kit, (-9.35, -0.35, 3.7), 1.5, int(rng.choice([4, 5])), look)
    main_rotor(kit, (0, 0, 4.0), rng.uniform(6.8, 7.8), 4, 0.28, look, 0.8)
    for y in (1.25, -1.25):
        hull(kit, (-1.7, y, 0.95), (1.0, 0.36, 0.38), look.skin, 3.2)
    gear(kit, [(-1.6, 1.3, 0.8)], 0.34, look, 0.16)
    gear(kit, [(3.1, 0, 0.9)], 0.26, look, 0.09, True)
    windows(kit, cabin, np.linspace(0.42, -0.62, int(rng.integers(3, 5))), 0.3, (0.36, 0.28), look)
    pane(kit, cabin, 0.75, 0.3, (0.35, 0.36), look.glass)
    if look.role not in ("army", "navy"):
        stripe(kit, cabin, -0.3, 0.12, look.trim)
    markings(kit, look, cabin, -0.3, -0.25, 0.22)
    extras(kit, look, 4.0, 0.75, 1.0, 2.55)


def lynx(kit, look):
    """Lynx and Wildcat: a short wide cabin, a sharp nose, a slender boom, one high stabiliser, paddle-tipped blades, skids or wheels."""
    rng = kit.rng
    cabin = hull(kit, (0.5, 0, 1.35), (1.8, 0.98, 0.82), look.skin, 4.5)
    hull(kit, (2.2, 0, 1.15), (1.6, 0.86, 0.55), look.skin, 2.6, (0.4, 0.5), -0.08)
    cockpit(kit, (1.95, 0, 1.5), (1.15, 0.92, 0.62), look, 2.7, (0.6, 0.8), -0.2, hoop=-0.02)
    hull(kit, (-0.4, 0, 2.3), (1.5, 0.72, 0.42), look.skin, 3.2, (0.75, 0.8), -0.03)
    engines(kit, -0.8, 0.4, 2.38, 0.28, 0.6, look)
    boom(kit, [(-0.8, 0, 1.5), (-2.6, 0, 1.8), (-6.8, 0, 2.0)], [0.8, 0.4, 0.22], look.skin, 0.9)
    panel(kit, (-6.5, 0, 1.85), 1.7, 0.42, look.skin, 0.65, 0.75, 90, 0.1, False)
    kit.add(BOX, (-7.15, -0.65, 3.3), (0.28, 0.65, 0.04), material=look.skin)
    tail_rotor(kit, (-7.15, 0.3, 3.0), 1.1, 4, look)
    main_rotor(kit, (0, 0, 3.4), rng.uniform(5.7, 6.4), 4, 0.2, look, 0.75, look.role == "navy" and kit.chance(0.5), True)
    kit.add(BOX, (0.35, 0.97, 1.3), (0.65, 0.03, 0.6), material=look.trim, mirror=True)
    windows(kit, cabin, (0.05,), 0.3, (0.5, 0.26), look)
    pane(kit, cabin, 0.72, 0.3, (0.28, 0.28), look.glass)
    if look.role == "navy" or kit.chance(0.3):
        gear(kit, [(-0.9, 1.25, 0.85)], 0.28, look, 0.1)
        kit.between((-0.9, 0.6, 0.8), (-0.9, 1.25, 0.75), 0.13, BOX, material=look.skin, mirror=True)
        gear(kit, [(2.3, 0, 0.9)], 0.22, look, 0.08, True)
        hull(kit, (2.75, 0, 0.85), (0.5, 0.4, 0.28), look.dark, 2.2)
    else:
        skids(kit, 1.7, -0.6, 1.15, 0.5, look, 0.055)
    markings(kit, look, cabin, -0.7, 0.0, 0.18)
    extras(kit, look, 2.9, 0.7, 0.95, 2.05)


def aw139(kit, look):
    """AW139 and S-76: a sleek polished body with wide panes, a pointed nose, wheels that fold away, four or five blades."""
    rng = kit.rng
    cabin = hull(kit, (0.4, 0, 1.5), (2.8, 1.08, 0.95), look.skin, 4.0)
    hull(kit, (2.6, 0, 1.2), (2.1, 0.98, 0.62), look.skin, 2.5, (0.35, 0.4), -0.05)
    cockpit(kit, (2.5, 0, 1.62), (1.45, 0.98, 0.72), look, 2.6, (0.45, 0.7), -0.35, hoop=-0.12)
    hull(kit, (-0.7, 0, 2.5), (2.4, 0.78, 0.52), look.skin, 2.8, (0.75, 0.8), -0.05)
    engines(kit, -1.3, 0.42, 2.55, 0.3, 0.8, look, out=25)
    boom(kit, [(-1.3, 0, 1.6), (-3.8, 0, 2.0), (-8.0, 0, 2.3)], [0.92, 0.48, 0.24], look.skin, 0.88)
    fin = look.trim if kit.chance(0.5) else look.skin
    panel(kit, (-7.8, 0, 2.1), 2.0, 0.55, fin, 0.6, 1.0, 90, 0.1, False)
    kit.add(BOX, (-7.4, 0, 2.2), (0.32, 1.5, 0.04), material=look.skin)
    if kit.chance(0.5):
        kit.add(BOX, (-7.45, 1.5, 2.25), (0.32, 0.03, 0.28), (0.7, 1), (-0.1, 0), material=fin, mirror=True)
    tail_rotor(kit, (-8.55, -0.32, 3.6), 1.3, 4, look)
    main_rotor(kit, (0, 0, 3.7), rng.uniform(6.2, 6.9), int(rng.choice([4, 5, 5])), 0.2, look, 0.75)
    for y in (1.1, -1.1):
        hull(kit, (-1.6, y, 1.0), (1.05, 0.34, 0.32), look.skin, 2.6)
    if not look.flies:
        gear(kit, [(-1.7, 1.1, 0.85)], 0.3, look, 0.11)
        gear(kit, [(2.9, 0, 0.9)], 0.23, look, 0.08, True)
    windows(kit, cabin, (0.2, -0.2), 0.28, (0.46, 0.34), look)
    windows(kit, cabin, (0.62, -0.55), 0.28, (0.3, 0.3), look)
    stripe(kit, cabin, -0.35, 0.13, look.trim)
    markings(kit, look, cabin, -0.5, -0.1, 0.2)
    extras(kit, look, 3.7, 0.75, 1.05, 2.35)


def jet_ranger(kit, look):
    """Bell 206 and 407: a pointed nose, two rows of seats, a hump of an engine, a thin boom with stabilisers half way, skids."""
    rng, late = kit.rng, kit.chance(0.5)
    stretch = rng.choice([0, 0, 0.45])
    cabin = hull(kit, (0.35 + stretch / 2, 0, 1.2), (1.45 + stretch / 2, 0.68, 0.68), look.skin, 3.2)
    hull(kit, (1.4 + stretch, 0, 0.98), (1.35, 0.6, 0.42), look.skin, 2.4, (0.45, 0.5), 0)
    cockpit(kit, (1.2 + stretch, 0, 1.28), (1.0, 0.64, 0.55), look, 2.5, (0.6, 0.75), -0.15)
    hull(kit, (-0.35, 0, 1.98), (1.15, 0.36, 0.3), look.skin, 2.8, (0.8, 0.9), 0.05)
    hull(kit, (0.1, 0, 2.1), (0.42, 0.26, 0.3), look.skin, 2.5)
    for y in (0.16, -0.16):
        kit.between((-0.7, y, 2.1), (-0.9, y * 1.4, 2.48), 0.1, material=look.metal)
    boom(kit, [(-0.4, 0, 1.35), (-1.7, 0, 1.62), (-6.0, 0, 1.85)], [0.62, 0.3, 0.13], look.skin, 0.9)
    fin = look.trim if kit.chance(0.5) else look.skin
    panel(kit, (-5.7, 0, 1.8), 0.85, 0.32, fin, 0.6, 0.5, 90, 0.04, False)
    kit.add(BOX, (-5.85, 0, 1.5), (0.2, 0.04, 0.35), (1.4, 1), (0.2, 0), material=fin)
    kit.add(BOX, (-4.2, 0, 1.76), (0.24, 1.0, 0.035), material=look.skin)
    if late:
        kit.add(BOX, (-4.3, 1.0, 1.8), (0.32, 0.025, 0.3), (0.6, 1), (-0.2, 0), material=fin, mirror=True)
    tail_rotor(kit, (-5.75, 0.28, 1.86), 0.83, 2, look, 0.28)
    main_rotor(kit, (0.1, 0, 2.85), rng.uniform(4.7, 5.2), 4 if late else 2, 0.16, look, 0.7)
    windows(kit, cabin, (0.42, -0.2), 0.32, (0.36, 0.25), look)
    skids(kit, 1.1, -0.6, 0.95, 0.48, look)
    stripe(kit, cabin, -0.22, 0.16, look.trim)
    markings(kit, look, cabin, -0.35, -0.35, 0.12)
    extras(kit, look, 1.7, 0.6, 0.62, 1.75)


def egg(kit, look):
    """MD 500 and 600: a glazed egg on skids, a slender boom with a T-tail and ends or a V, four to six blades; or without a tail rotor."""
    rng = kit.rng
    shell = hull(kit, (-0.1, 0, 1.3), (1.35, 0.72, 0.78), look.skin, 2.4)
    cockpit(kit, (0.75, 0, 1.36), (1.02, 0.7, 0.68), look, 2.3, hoop=0.12)
    hull(kit, (0.8, 0, 0.95), (0.98, 0.56, 0.42), look.skin, 2.3)
    hull(kit, (-0.35, 0, 1.95), (1.0, 0.3, 0.3), look.skin, 2.5)
    pane(kit, shell, -0.05, 0.25, (0.34, 0.24), look.glass)
    ducted = kit.chance(0.3)
    boom(kit, [(-0.5, 0, 1.4), (-1.5, 0, 1.62), (-5.1, 0, 1.82)], [0.58, 0.32 if ducted else 0.2, 0.24 if ducted else 0.1], look.skin)
    fin = look.trim if kit.chance(0.5) else look.skin
    if ducted:
        kit.add(CYL, (-5.1, 0, 1.82), (0.27, 0.27, 0.25), rotation=ALONG_X, material=look.dark)
        kit.add(BOX, (-4.9, 0, 1.95), (0.2, 1.0, 0.03), material=look.skin)
        kit.add(BOX, (-4.95, 1.0, 1.95), (0.25, 0.025, 0.5), (0.8, 1), (-0.15, 0), material=fin, mirror=True)
    else:
        tail_rotor(kit, (-5.0, -0.2, 1.82), 0.7, int(rng.choice([2, 2, 4])), look, 0.2)
        panel(kit, (-4.85, 0, 1.75), 0.95, 0.22, fin, 0.75, 0.35, 90, 0.035, False)
        panel(kit, (-4.85, 0, 1.85), 0.85, 0.2, fin, 0.7, 0.1, -90, 0.035, False)
        kit.add(BOX, (-5.22, 0, 2.7), (0.2, 0.8, 0.03), material=look.skin)
        kit.add(BOX, (-5.24, 0.8, 2.7), (0.22, 0.02, 0.17), (0.75, 1), material=fin, mirror=True)
    main_rotor(kit, (0, 0, 2.65), rng.uniform(3.9, 4.3), int(rng.choice([4, 5, 5, 6])), 0.09, look, 0.6)
    kit.add(CYL, (-1.25, 0, 1.18), (0.16, 0.16, 0.3), rotation=turn("y", 100), material=look.dark)
    skids(kit, 0.9, -0.4, 0.98, 0.62, look, 0.045, 0.3)
    if look.role == "army" and kit.chance(0.7):
        kit.between((0.1, 0.5, 1.05), (0.1, 1.15, 1.0), (0.05, 0.08), BOX, material=look.dark, mirror=True)
        kit.add(CYL, (0.2, 1.15, 0.95), (0.14, 0.14, 0.5), rotation=ALONG_X, material=look.dark, mirror=True)
    else:
        pane(kit, shell, -0.3, -0.25, (0.4, 0.08), look.trim)
    markings(kit, look, shell, -0.45, 0.0, 0.11)
    extras(kit, look, 1.3, 0.6, 0.66, 1.75)


def fenestron_copter(kit, look):
    """EC120, EC130, EC135 and EC145: a bubble of a nose, tall panes, a fan in the fin, or a high boom with end plates and clam doors."""
    rng = kit.rng
    kind = rng.choice(["small", "twin", "twin", "high"])
    size = 0.85 if kind == "small" else 1.0
    cabin = hull(kit, (0.4, 0, 1.35), (1.75 * size, 0.78, 0.8), look.skin, 3.4)
    hull(kit, (1.75 * size, 0, 1.05), (1.15, 0.68, 0.5), look.skin, 2.3, (0.7, 0.65), 0)
    cockpit(kit, (1.55 * size, 0, 1.45), (1.15, 0.77, 0.68), look, 2.4, (0.75, 0.85), -0.12, hoop=-0.05)
    hull(kit, (-0.5, 0, 2.2), (1.6, 0.52, 0.38), look.skin, 2.8, (0.8, 0.9), 0.03)
    kit.add(BOX, (0.45, 0.3, 2.28), (0.06, 0.16, 0.12), material=look.dark, mirror=True)
    if kind == "small":
        kit.between((-1.5, 0, 2.2), (-2.1, 0, 2.35), 0.17, material=look.metal)
    else:
        kit.between((-1.5, 0.28, 2.3), (-2.1, 0.4, 2.4), 0.17, material=look.metal, mirror=True)
    fin = look.trim if kit.chance(0.6) else look.skin
    if kind == "high":
        hull(kit, (-1.2, 0, 1.45), (1.1, 0.72, 0.68), look.skin, 3.0, (1, 1), 0)
        boom(kit, [(-1.0, 0, 2.0), (-5.4, 0, 2.12)], [0.34, 0.17], look.skin)
    else:
        boom(kit, [(-0.4, 0, 1.5), (-2.2, 0, 1.85), (-5.0, 0, 2.05)], [0.78, 0.4, 0.25], look.skin, 0.9)
    if kind == "high" and kit.chance(0.5):
        tail_rotor(kit, (-5.95, 0.25, 3.0), 0.95, 2, look, 0.25)
        panel(kit, (-5.3, 0, 2.0), 1.1, 0.35, fin, 0.6, 0.6, 90, 0.07, False)
    else:
        radius = 0.42 if kind == "small" else 0.52
        middle = np.array([-5.25 - radius, 0, 2.15])
        fenestron(kit, middle, radius, look, fin)
        kit.between((-4.6, 0, 2.02), middle + [radius * 1.05, 0, 0], (0.28, 0.15), CYL, 1.2, material=look.skin)
        panel(kit, middle + [-radius * 0.4, 0, radius * 0.95], 1.0, 0.4, fin, 0.65, 0.5, 90, 0.1, False)
        kit.between(middle + [0.1, 0, -radius], middle + [-0.2, 0, -radius * 1.45], (0.2, 0.06), BOX, 0.6, material=fin)
    kit.add(BOX, (-4.6, 0, 2.06), (0.24, 1.15, 0.035), material=look.skin)
    if kind != "small" or kit.chance(0.5):
        kit.add(BOX, (-4.65, 1.15, 2.1), (0.32, 0.025, 0.36), (0.65, 1), (-0.2, 0), material=fin, mirror=True)
    main_rotor(kit, (0, 0, 3.2), rng.uniform(4.7, 5.4), 3 if kind == "small" else 4, 0.14, look, 0.75)
    windows(kit, cabin, (0.35, -0.25), 0.22, (0.4, 0.34), look)
    skids(kit, 1.35, -0.55, 1.02, 0.55, look, 0.05)
    stripe(kit, cabin, -0.35, 0.14, look.trim)
    markings(kit, look, cabin, -0.5, -0.1, 0.14)
    extras(kit, look, 1.9, 0.65, 0.75, 2.05)


def robinson(kit, look):
    """R22 and R44: a small cabin, a tall faired mast, two blades, a thin boom, crossed tail plates, skids."""
    rng, four = kit.rng, kit.chance(0.6)
    back = 0.0 if four else -0.35
    cabin = hull(kit, (0.1, 0, 1.08), (1.05 + back / 2, 0.64, 0.66), look.skin, 2.8)
    cockpit(kit, (0.8 + back, 0, 1.14), (0.92, 0.63, 0.62), look, 2.5, (0.85, 0.9), -0.05, hoop=-0.1)
    hull(kit, (0.8 + back, 0, 0.78), (0.95, 0.55, 0.36), look.skin, 2.4)
    kit.between((-0.75, 0, 1.15), (-1.4, 0, 1.3), 0.42, CYL, 0.35, material=look.skin)
    kit.add(BOX, (-0.7, 0, 0.85), (0.45, 0.4, 0.3), material=look.dark)
    kit.add(BOX, (-0.1, 0, 2.05), (0.42, 0.13, 0.55), (0.45, 0.7), material=look.skin)
    boom(kit, [(-1.1, 0, 1.28), (-5.2, 0, 1.45)], [0.17, 0.09], look.skin)
    fin = look.trim if kit.chance(0.4) else look.skin
    panel(kit, (-5.0, 0, 1.4), 0.75, 0.2, fin, 0.7, 0.25, 90, 0.03, False)
    panel(kit, (-5.0, 0, 1.45), 0.6, 0.2, fin, 0.7, 0.1, -90, 0.03, False)
    kit.add(BOX, (-5.0, -0.42, 1.48), (0.17, 0.45, 0.025), material=fin)
    tail_rotor(kit, (-5.15, 0.22, 1.45), 0.72, 2, look, 0.22)
    main_rotor(kit, (-0.1, 0, 3.1), rng.uniform(4.3, 5.0), 2, 0.12, look, 0.7)
    if four:
        pane(kit, cabin, -0.3, 0.25, (0.3, 0.24), look.glass)
    pane(kit, cabin, 0.12, -0.2, (0.02, 0.5), look.dark, thick=0.02)
    skids(kit, 0.85, -0.55, 0.98, 0.5, look, 0.04, 0.35)
    stripe(kit, cabin, -0.35, 0.12, look.trim)
    markings(kit, look, cabin, -0.5, -0.05, 0.1)
    kit.add(BALL, (1.55 + back, 0, 0.72), (0.1, 0.11, 0.09), material=kit.material(base=[0.85] * 3, gloss=0.6, pattern=PLAIN))


def gazelle(kit, look):
    """Gazelle: a rounded glass cabin, an open engine on the roof with a bent jet pipe, a slim boom, a fan in the tall fin."""
    rng = kit.rng
    hull(kit, (0.7, 0, 1.25), (1.6, 0.78, 0.75), look.skin, 2.5)
    cockpit(kit, (0.95, 0, 1.3), (1.55, 0.79, 0.72), look, 2.4, (0.9, 0.9), 0, hoop=0.0)
    hull(kit, (0.9, 0, 0.82), (1.5, 0.66, 0.36), look.skin, 2.5)
    cabin = hull(kit, (-0.45, 0, 1.28), (0.95, 0.74, 0.74), look.skin, 3.5)
    hull(kit, (-0.4, 0, 2.05), (0.9, 0.3, 0.28), look.skin, 2.6, (0.9, 0.9), 0)
    kit.between((-0.5, 0, 2.18), (-1.7, 0, 2.22), 0.24, material=look.metal)
    kit.between((-1.65, 0, 2.22), (-2.05, 0, 2.42), 0.19, material=look.dark)
    boom(kit, [(-0.8, 0, 1.35), (-2.3, 0, 1.55), (-5.5, 0, 1.65)], [0.62, 0.27, 0.2], look.skin, 0.9)
    middle, fin = np.array([-5.95, 0, 1.72]), look.trim if kit.chance(0.4) else look.skin
    fenestron(kit, middle, 0.38, look, look.skin, 0.13)
    panel(kit, middle + [-0.2, 0, 0.35], 1.1, 0.38, fin, 0.55, 0.55, 90, 0.08, False)
    kit.between(middle + [0, 0, -0.38], middle + [-0.2, 0, -0.75], (0.2, 0.05), BOX, 0.6, material=fin)
    kit.add(BOX, (-5.0, 0, 1.62), (0.22, 0.95, 0.03), material=look.skin)
    kit.add(BOX, (-5.05, 0.95, 1.62), (0.26, 0.02, 0.26), (0.7, 1), material=fin, mirror=True)
    main_rotor(kit, (0, 0, 2.95), rng.uniform(4.8, 5.3), 3, 0.15, look, 0.8)
    pane(kit, cabin, 0.05, 0.3, (0.32, 0.24), look.glass)
    skids(kit, 1.4, -0.4, 1.0, 0.55, look)
    if look.role == "army" and kit.chance(0.6):
        kit.between((-0.2, 0.5, 1.2), (-0.2, 1.3, 1.2), (0.06, 0.1), BOX, material=look.dark, mirror=True)
        for z in (1.05, 1.33):
            kit.add(CYL, (-0.15, 1.3, z), (0.1, 0.1, 0.6), rotation=ALONG_X, material=look.trim, mirror=True)
    else:
        stripe(kit, cabin, -0.2, 0.14, look.trim)
    markings(kit, look, cabin, -0.45, -0.1, 0.13)
    extras(kit, look, 1.8, 0.55, 0.7, 1.95)


def alouette(kit, look):
    """Alouette II, Lama and Bell 47: a glass bubble, an engine in the open, a tail of open lattice, skids or wheels."""
    rng, old = kit.rng, kit.chance(0.35)
    tube = look.skin if kit.chance(0.5) else look.metal
    cockpit(kit, (0.85, 0, 1.35), (0.95, 0.78, 0.8), look, 2.1 if old else 2.3, hoop=-0.1)
    kit.add(BOX, (0.75, 0, 0.72), (0.85, 0.6, 0.12), (0.9, 1.1), material=look.skin)
    kit.add(BOX, (-0.05, 0, 1.25), (0.12, 0.66, 0.6), (1, 0.85), (-0.1, 0), material=look.skin)
    kit.add(BOX, (-0.6, 0, 1.1), (0.5, 0.38, 0.42), (0.9, 0.8), material=look.dark)
    kit.add(BOX, (-0.45, 0, 0.72), (0.9, 0.3, 0.06), material=tube)
    if old:
        kit.add(CYL, (-0.3, 0.5, 1.85), (0.24, 0.24, 0.42), rotation=ALONG_X, material=look.skin, mirror=True)
        kit.add(BOX, (-0.3, 0, 1.62), (0.1, 0.5, 0.1), material=tube)
    else:
        kit.between((-0.2, 0, 1.95), (-1.7, 0, 1.9), 0.26, CYL, 0.75, material=look.metal)
        kit.add(BALL, (-0.2, 0, 1.95), (0.12, 0.25, 0.25), material=look.dark)
        kit.add(CYL, (-1.75, 0, 1.9), (0.16, 0.16, 0.06), rotation=ALONG_X, material=look.dark)
        kit.add(BOX, (-0.6, 0, 1.65), (0.5, 0.2, 0.15), material=tube)
    tail, low, high = np.array([-6.0, 0, 1.75]), np.array([-0.6, 0.32, 0.75]), np.array([-0.6, 0.34, 1.5])
    ends = tail + [0, 0.07, -0.1], tail + [0, 0.07, 0.08]
    kit.between(low, ends[0], 0.035, material=tube, mirror=True)
    kit.between(high, ends[1], 0.035, material=tube, mirror=True)
    bays = 5
    for k in range(bays):
        a, b = 1 - (1 - k / bays) ** 1.2, 1 - (1 - (k + 1) / bays) ** 1.2
        first, last = (low + (ends[0] - low) * a, high + (ends[1] - high) * b)
        kit.between(first, last, 0.022, material=tube, mirror=True)
        if k:
            kit.between(first, high + (ends[1] - high) * a, 0.02, material=tube, mirror=True)
            kit.between(first, first * [1, -1, 1], 0.02, material=tube)
    tail_rotor(kit, tail + [-0.05, -0.22, 0.1], 0.85, 2 if old or kit.chance(0.4) else 3, look, 0.25)
    kit.add(BALL, tail, (0.2, 0.12, 0.14), material=look.metal)
    kit.add(BOX, (-4.6, 0, 1.58), (0.2, 0.85, 0.03), material=look.trim)
    kit.between((-5.9, 0, 1.7), (-6.3, 0, 0.85), 0.03, material=tube)
    main_rotor(kit, (-0.25, 0, 2.75), rng.uniform(4.8, 5.4), 2 if old else 3, 0.15, look, 1.1)
    skids(kit, 1.25, -0.65, 1.05, 0.62, look, 0.045, 0.3)


def stub_wing(kit, x, z, wide, span, look, chord=0.5, droop=0.0, loads=2):
    """Short wings with pylons, and rocket pods, racks of missiles or tanks below."""
    rng = kit.rng
    panel(kit, (x, wide * 0.6, z), span - wide * 0.6, chord, look.skin, 0.75, 0.1, -droop, 0.09, True, 9)
    for k, share in enumerate(np.linspace(0.92, 0.5, loads) if loads > 1 else [0.85]):
        y = wide + (span - wide) * share
        under = z - (y - wide * 0.6) * np.tan(np.radians(droop))
        kit.add(BOX, (x, y, under - 0.14), (chord * 0.6, 0.05, 0.14), material=look.skin, mirror=True)
        kind = rng.choice(["pod", "rack", "tank"], p=[0.45, 0.4, 0.15])
        if kind == "pod":
            kit.add(CYL, (x + 0.1, y, under - 0.45), (0.23, 0.23, 0.85), rotation=ALONG_X, material=look.skin if kit.chance(0.6) else look.trim, mirror=True)
            kit.add(CYL, (x + 0.95, y, under - 0.45), (0.18, 0.18, 0.015), rotation=ALONG_X, material=look.dark, mirror=True)
        elif kind == "rack" and len(kit.primitives) < 44:
            for dy in (-0.15, 0.15):
                kit.add(CYL, (x + 0.05, y + dy, under - 0.4), (0.1, 0.1, 0.8), rotation=ALONG_X, material=look.dark, mirror=True)
            kit.add(BOX, (x, y, under - 0.3), (0.5, 0.14, 0.05), material=look.dark, mirror=True)
        else:
            kit.add(BALL, (x + 0.1, y, under - 0.45), (1.1, 0.25, 0.25), material=look.skin, mirror=True)
        if k and len(kit.primitives) > 50:
            return


def turret_gun(kit, x, z, look, long=1.2):
    """A chin turret with one barrel or a bundle."""
    thick = kit.rng.choice([0.035, 0.09])
    kit.add(CYL, (x, 0, z + 0.12), (0.24, 0.24, 0.16), material=look.dark)
    kit.between((x - 0.3, 0, z), (x + 0.3, 0, z - 0.02), 0.13, BOX, material=look.dark)
    kit.between((x, 0, z), (x + long, 0, z - 0.05), thick, material=look.dark)


def apache(kit, look):
    """AH-64: flat-paned stepped cockpits, cheek fairings, engines at the shoulders, a chin gun, a mast radar or none, a tail wheel."""
    rng = kit.rng
    kit.add(BOX, (0.4, 0, 1.55), (2.6, 0.55, 0.6), (0.92, 0.85), material=look.skin)
    kit.add(BOX, (3.4, 0, 1.4), (0.5, 0.5, 0.75), (0.6, 0.75), (0.12, 0), ALONG_X, look.skin)
    kit.add(BOX, (2.1, 0.55, 1.35), (1.6, 0.3, 0.3), (0.85, 0.6), material=look.skin, mirror=True)
    kit.add(BOX, (2.75, 0, 2.1), (0.72, 0.45, 0.4), (0.5, 0.7), (-0.2, 0), material=look.glass)
    kit.add(BOX, (1.35, 0, 2.45), (0.8, 0.47, 0.52), (0.6, 0.7), (-0.05, 0), material=look.glass)
    for x, z in ((2.0, 2.28), (0.68, 2.5)):
        kit.add(BOX, (x, 0, z), (0.07, 0.45, 0.44), (1, 0.72), material=look.skin)
    kit.add(BALL, (4.15, 0, 1.3), (0.3, 0.28, 0.3), material=look.dark)
    kit.add(CYL, (4.1, 0, 1.72), (0.2, 0.2, 0.18), (0.9, 1), material=look.skin)
    hull(kit, (-0.5, 0, 2.45), (1.5, 0.5, 0.5), look.skin, 4.0)
    engines(kit, -0.75, 0.85, 2.3, 0.4, 0.95, look, out=20)
    boom(kit, [(-1.6, 0, 1.75), (-3.2, 0, 1.85), (-8.8, 0, 2.0)], [0.68, 0.5, 0.26], look.skin, 0.85)
    panel(kit, (-8.6, 0, 1.7), 2.2, 0.55, look.skin, 0.6, 0.8, 90, 0.1, False)
    kit.add(BOX, (-9.0, 0, 1.75), (0.45, 1.7, 0.05), material=look.skin)
    tail_rotor(kit, (-9.25, 0.35, 3.0), 1.4, 4, look)
    hub = np.array([0, 0, 3.75])
    main_rotor(kit, hub, rng.uniform(6.6, 7.3), 4, 0.27, look, 0.9)
    if kit.chance(0.5):
        kit.add(CYL, hub + [0, 0, 0.35], (0.12, 0.12, 0.3), material=look.metal)
        kit.add(BALL, hub + [0, 0, 0.7], (0.62, 0.62, 0.28), material=look.skin)
    gear(kit, [(1.5, 1.0, 1.3)], 0.36, look, 0.13)
    gear(kit, [(-8.6, 0, 1.7)], 0.24, look)
    turret_gun(kit, 2.5, 0.78, look, 1.5)
    stub_wing(kit, -0.2, 1.75, 0.55, 2.5, look, 0.48)


def cobra(kit, look):
    """AH-1: a very narrow body, one long canopy, skids, two broad blades or four, a chin gun, short wings."""
    rng, twin = kit.rng, kit.chance(0.55)
    kit.add(BOX, (0.6, 0, 1.35), (2.6, 0.48, 0.6), (0.97, 0.85), material=look.skin)
    hull(kit, (3.1, 0, 1.2), (1.5, 0.45, 0.5), look.skin, 2.5, (0.5, 0.6), -0.1)
    canopy = hull(kit, (2.0, 0, 1.85), (1.75, 0.44, 0.56), look.glass, 2.7, (0.55, 0.7), -0.3)
    hull(kit, (2.0, 0, 1.85), (1.76, 0.03, 0.565), look.skin, 2.7, (0.55, 1), -0.3)
    for x in (1.1, 2.05):
        k = (x - 0.25) / 3.5
        hull(kit, (x, 0, 1.85 - 0.3 * k), (0.06, canopy.half[1] * (1 - 0.3 * k) * 1.03, 0.565 * (1 - 0.45 * k)), look.skin, 3.0)
    hull(kit, (-0.5, 0, 2.2), (1.6, 0.48, 0.52), look.skin, 3.5)
    if twin:
        engines(kit, -0.75, 0.55, 2.2, 0.32, 0.75, look, out=15)
    else:
        kit.between((-1.6, 0, 2.2), (-2.7, 0, 2.35), 0.34, CYL, 0.8, material=look.metal)
        kit.add(CYL, (-2.68, 0, 2.35), (0.22, 0.22, 0.06), rotation=ALONG_X, material=look.dark)
        pane(kit, Hull(np.array([-0.5, 0, 2.2]), (1.6, 0.48, 0.52), 3.5, (1, 1), 0), 0.3, 0, (0.25, 0.2), look.dark)
    boom(kit, [(-1.4, 0, 1.5), (-3.0, 0, 1.65), (-7.9, 0, 1.9)], [0.66, 0.4, 0.18], look.skin, 0.8)
    panel(kit, (-7.6, 0, 1.8), 1.75, 0.45, look.skin, 0.65, 0.9, 90, 0.08, False)
    kit.add(BOX, (-5.2, 0, 1.78), (0.32, 1.1, 0.04), material=look.skin)
    kit.between((-7.4, 0, 1.85), (-7.9, 0, 1.2), 0.03, material=look.metal)
    tail_rotor(kit, (-8.3, -0.28, 3.2), 1.25, 4 if twin and kit.chance(0.4) else 2, look)
    main_rotor(kit, (0, 0, 3.65), rng.uniform(6.4, 7.2), 4 if twin and kit.chance(0.4) else 2, 0.33, look, 1.0)
    turret_gun(kit, 3.0, 0.62, look, 1.4)
    kit.add(BALL, (4.4, 0, 1.15), (0.28, 0.24, 0.24), material=look.dark)
    skids(kit, 1.7, -0.4, 1.1, 0.75, look, 0.055, 0.5)
    stub_wing(kit, -0.1, 1.5, 0.48, 1.75, look, 0.42)


def hind(kit, look):
    """Mi-24: two bubbles one above the other, a broad troop cabin, drooping wings with pods, twin mouths on the roof, five blades."""
    rng = kit.rng
    cabin = hull(kit, (-0.3, 0, 1.75), (2.9, 0.88, 0.95), look.skin, 4.0)
    hull(kit, (3.2, 0, 1.45), (2.3, 0.62, 0.6), look.skin, 2.8, (0.65, 0.7), 0)
    for x, z, size in ((4.35, 1.95, 0.92), (3.0, 2.5, 0.95)):
        hull(kit, (x, 0, z), (0.95 * size, 0.55, 0.62), look.glass, 2.3)
        hull(kit, (x, 0, z), (0.96 * size, 0.04, 0.63), look.skin, 2.3)
    kit.add(BOX, (3.35, 0, 1.8), (0.6, 0.5, 0.35), (0.8, 0.8), material=look.skin)
    hull(kit, (-0.6, 0, 2.85), (2.9, 0.68, 0.52), look.skin, 3.2)
    engines(kit, 1.1, 0.4, 3.0, 0.36, 1.0, look)
    kit.between((0, 0.5, 2.95), (-0.4, 1.05, 2.95), 0.25, material=look.dark, mirror=True)
    boom(kit, [(-2.2, 0, 1.9), (-4.2, 0, 2.35), (-10.2, 0, 2.6)], [0.95, 0.55, 0.28], look.skin, 0.85)
    panel(kit, (-10.0, 0, 2.4), 2.1, 0.6, look.skin, 0.6, 1.3, 90, 0.12, False)
    kit.add(BOX, (-9.6, 0, 2.5), (0.4, 1.6, 0.05), material=look.skin)
    tail_rotor(kit, (-11.1, 0.35, 4.2), 1.9, 3, look)
    main_rotor(kit, (0, 0, 4.3), rng.uniform(7.6, 8.6), 5, 0.28, look, 0.95)
    panel(kit, (-0.9, 0.7, 2.15), 2.5, 0.65, look.skin, 0.7, 0.2, -14, 0.1, True, 9)
    for y, z in ((1.75, 1.9), (2.45, 1.72)):
        kit.add(CYL, (-0.8, y, z - 0.4), (0.26, 0.26, 0.9), rotation=ALONG_X, material=look.skin if y < 2 else look.trim, mirror=True)
        kit.add(BOX, (-0.9, y, z - 0.08), (0.4, 0.05, 0.2), material=look.skin, mirror=True)
    kit.add(BOX, (-1.0, 3.1, 1.32), (0.55, 0.04, 0.25), material=look.skin, mirror=True)
    if not look.flies:
        gear(kit, [(-1.8, 1.1, 1.1)], 0.42, look, 0.14)
        gear(kit, [(3.5, 0, 1.1)], 0.28, look, 0.1, True)
    kit.add(BALL, (4.7, 0, 0.95), (0.3, 0.26, 0.25), material=look.dark)
    kit.between((4.7, 0, 0.95), (5.7, 0, 0.9), 0.06, material=look.dark)
    windows(kit, cabin, (0.5, 0.1, -0.3), 0.35, (0.18, 0.2), look)


def tiger(kit, look):
    """Tiger and Mangusta: slender stepped canopies, slab sides, engines amidships, a roof sight or none, end plates, fixed wheels."""
    rng, slim = kit.rng, kit.chance(0.45)
    hull(kit, (0.3, 0, 1.5), (2.7, 0.55, 0.72), look.skin, 4.5, (0.85, 0.85), -0.05)
    hull(kit, (2.8, 0, 1.35), (1.6, 0.47, 0.5), look.skin, 2.6, (0.45, 0.55), -0.05)
    for x, z, long in ((2.75, 1.82, 0.85), (1.35, 2.15, 0.95)):
        kit.add(BOX, (x, 0, z + 0.1), (long, 0.44, 0.42), (0.5, 0.68), (-0.22, 0), material=look.glass)
        kit.add(BOX, (x - long * 0.1, 0, z + 0.1), (0.05, 0.455, 0.43), (1, 0.68), material=look.skin)
        kit.add(BOX, (x - long * 0.82, 0, z), (0.22, 0.455, 0.45), (0.7, 0.75), material=look.skin)
    hull(kit, (-0.6, 0, 2.35), (1.7, 0.55, 0.48), look.skin, 3.2)
    engines(kit, -0.7, 0.62, 2.3, 0.35, 0.85, look, out=25)
    boom(kit, [(-1.6, 0, 1.7), (-3.4, 0, 1.85), (-7.6, 0, 2.0)], [0.66, 0.42, 0.22], look.skin, 0.8)
    panel(kit, (-7.5, 0, 1.85), 1.7, 0.5, look.skin, 0.6, 0.8, 90, 0.09, False)
    kit.add(BOX, (-7.4, 0, 2.0), (0.32, 1.5, 0.04), material=look.skin)
    if not slim:
        kit.add(BOX, (-7.5, 1.5, 2.05), (0.36, 0.03, 0.5), (0.6, 1), (-0.2, 0), material=look.skin, mirror=True)
    tail_rotor(kit, (-8.05, -0.3, 3.05), 1.3, 2 if slim else 3, look)
    hub = np.array([0, 0, 3.6])
    main_rotor(kit, hub, rng.uniform(5.9, 6.6), 4, 0.24, look, 0.85)
    if kit.chance(0.4):
        kit.add(CYL, hub + [0, 0, 0.3], (0.09, 0.09, 0.3), material=look.metal)
        kit.add(BALL, hub + [0, 0, 0.65], (0.32, 0.32, 0.3), material=look.skin)
    gear(kit, [(1.0, 1.05, 1.3)], 0.34, look, 0.12)
    gear(kit, [(-6.8, 0, 1.8)], 0.22, look)
    turret_gun(kit, 3.1, 0.72, look, 1.2)
    if kit.chance(0.6):
        kit.add(BALL, (4.25, 0, 1.3), (0.28, 0.26, 0.26), material=look.dark)
    stub_wing(kit, -0.1, 1.75, 0.55, 2.3, look, 0.45, rng.uniform(0, 8))


def alligator(kit, look):
    """Ka-50 and Ka-52: two rotors on one tall mast, seats side by side or single, no tail rotor, a fin with a tailplane and end plates."""
    rng, wide = kit.rng, kit.chance(0.6)
    girth = 0.78 if wide else 0.58
    hull(kit, (0.5, 0, 1.7), (3.2, girth, 0.88), look.skin, 3.5, (0.85, 0.9), -0.1)
    hull(kit, (3.6, 0, 1.45), (1.8, girth * 0.8, 0.6), look.skin, 2.5, (0.45, 0.5), -0.1)
    cockpit(kit, (2.7, 0, 2.15), (1.35, girth * 0.92, 0.68), look, 2.7, (0.6, 0.8), -0.25, wide, 0.0)
    hull(kit, (-0.8, 0, 2.55), (2.3, 0.55, 0.5), look.skin, 3.0)
    engines(kit, -0.2, 0.92, 2.5, 0.4, 1.05, look, out=35)
    boom(kit, [(-1.8, 0, 1.9), (-4.0, 0, 2.1), (-8.3, 0, 2.25)], [0.85, 0.52, 0.22], look.skin, 0.75)
    panel(kit, (-7.6, 0, 2.0), 1.9, 0.8, look.skin, 0.5, 1.0, 90, 0.09, False)
    kit.add(BOX, (-6.4, 0, 2.25), (0.45, 1.7, 0.05), material=look.skin)
    kit.add(BOX, (-6.5, 1.7, 2.3), (0.5, 0.035, 0.6), (0.6, 1), (-0.2, 0), material=look.skin, mirror=True)
    reach, first = rng.uniform(6.4, 7.3), rng.uniform(0, 120)
    main_rotor(kit, (0, 0, 3.55), reach, 3, 0.26, look, 0.7, pace=first)
    main_rotor(kit, (0, 0, 4.75), reach, 3, 0.26, look, 1.2)
    gear(kit, [(-0.9, 1.25, 1.2)], 0.4, look, 0.14)
    gear(kit, [(3.3, 0, 1.0)], 0.27, look, 0.1, True)
    kit.add(BALL, (4.9, 0, 1.0), (0.3, 0.28, 0.3), material=look.dark)
    kit.between((0.3, -girth * 0.95, 1.2), (2.3, -girth * 1.1, 1.1), 0.06, material=look.dark)
    kit.add(BOX, (0.6, -girth, 1.25), (0.6, 0.16, 0.2), material=look.dark)
    stub_wing(kit, -0.6, 2.0, girth, 3.0, look, 0.55, 6)


def helix(kit, look):
    """Ka-27, Ka-32 and Ka-226: a stubby cabin under two rotors on one mast, a short tail with two fins, four legs."""
    rng = kit.rng
    cabin = hull(kit, (0.3, 0, 1.65), (3.0, 1.1, 1.0), look.skin, 4.5)
    hull(kit, (2.9, 0, 1.4), (1.3, 0.98, 0.78), look.skin, 2.5, (0.75, 0.75), 0)
    cockpit(kit, (2.75, 0, 1.8), (1.25, 1.02, 0.8), look, 2.6, (0.8, 0.85), -0.15, hoop=0.05)
    hull(kit, (-0.3, 0, 2.9), (2.1, 0.78, 0.5), look.skin, 3.2, (0.85, 0.9), 0)
    engines(kit, 0.9, 0.45, 2.95, 0.36, 0.9, look)
    kit.between((-0.6, 0.5, 2.95), (-1.0, 1.1, 2.95), 0.24, material=look.dark, mirror=True)
    boom(kit, [(-1.5, 0, 1.8), (-3.4, 0, 2.05), (-6.3, 0, 2.2)], [0.95, 0.55, 0.3], look.skin, 0.9)
    kit.add(BOX, (-6.0, 0, 2.3), (0.5, 1.75, 0.06), material=look.skin)
    kit.add(BOX, (-6.1, 1.75, 2.5), (0.65, 0.06, 0.75), (0.65, 1), (-0.1, 0), rotation=turn("z", -8), material=look.trim if kit.chance(0.5) else look.skin, mirror=True)
    reach = rng.uniform(6.6, 7.8)
    folds = look.role == "navy" and kit.chance(0.4)
    main_rotor(kit, (0, 0, 3.9), reach, 3, 0.24, look, 0.6, folds)
    main_rotor(kit, (0, 0, 5.1), reach, 3, 0.24, look, 1.2, folds)
    gear(kit, [(-1.0, 1.65, 1.3)], 0.36, look, 0.13)
    kit.between((-1.0, 0.9, 0.9), (-1.0, 1.6, 0.4), 0.07, material=look.metal, mirror=True)
    gear(kit, [(2.6, 0.6, 1.0)], 0.25, look, 0.1)
    kit.add(CYL, (0.0, 1.12, 1.05), (0.32, 0.26, 1.4), rotation=ALONG_X, material=look.skin, mirror=True)
    windows(kit, cabin, (0.1, -0.35), 0.3, (0.26, 0.24), look)
    pane(kit, cabin, 0.62, 0.3, (0.4, 0.36), look.glass)
    if look.role not in ("army", "navy"):
        stripe(kit, cabin, -0.1, 0.12, look.trim)
    markings(kit, look, cabin, -0.6, 0.0, 0.22)
    extras(kit, look, 3.4, 0.7, 1.05, 2.6)


def stallion(kit, look):
    """CH-53 and Super Frelon: a long hold with sponsons and a rear ramp, nacelles on stubs, a cranked tail, six or seven blades."""
    rng = kit.rng
    cabin = hull(kit, (0.8, 0, 1.75), (5.6, 1.3, 1.15), look.skin, 6.0)
    hull(kit, (6.2, 0, 1.45), (1.7, 1.15, 0.8), look.skin, 2.6, (0.65, 0.7), -0.05)
    cockpit(kit, (6.0, 0, 1.95), (1.35, 1.15, 0.78), look, 2.7, (0.7, 0.85), -0.2, hoop=0.05)
    hull(kit, (0.2, 0, 3.15), (3.4, 0.78, 0.55), look.skin, 3.0, (0.8, 0.8), -0.05)
    engines(kit, 1.0, 1.4, 3.15, 0.46, 1.25, look, out=20)
    kit.between((1.0, 0.4, 3.15), (1.0, 1.3, 3.15), (0.25, 0.6), BOX, material=look.skin, mirror=True)
    boom(kit, [(-3.6, 0, 1.95), (-6.4, 0, 2.6), (-11.4, 0, 2.95)], [1.15, 0.75, 0.45], look.skin, 0.95)
    panel(kit, (-11.0, 0, 2.7), 2.7, 0.85, look.skin, 0.7, 1.3, 90, 0.2, False)
    kit.add(BOX, (-12.1, -1.45, 4.7), (0.55, 1.5, 0.07), (0.9, 1), rotation=turn("x", 10), material=look.skin)
    tail_rotor(kit, (-12.3, 0.5, 5.1), 2.3, 4, look, 0.5)
    blades = int(rng.choice([6, 6, 7]))
    main_rotor(kit, (0, 0, 4.7), rng.uniform(9.8, 11.2), blades, 0.33, look, 1.0, look.role == "navy" and kit.chance(0.4))
    for y in (1.6, -1.6):
        hull(kit, (-1.2, y, 1.15), (2.5, 0.5, 0.55), look.skin, 3.2)
    gear(kit, [(-2.0, 1.65, 0.95)], 0.42, look, 0.22)
    gear(kit, [(5.3, 0, 0.9)], 0.33, look, 0.12, True)
    windows(kit, cabin, (0.55, 0.15, -0.2), 0.3, (0.22, 0.22), look)
    pane(kit, cabin, 0.82, -0.05, (0.42, 0.75), look.trim)
    kit.add(BOX, (-5.0, 0, 1.5), (1.3, 0.95, 0.03), rotation=turn("y", 28), material=look.dark)
    if kit.chance(0.5):
        kit.between((7.0, -0.7, 1.1), (9.2, -0.7, 1.1), 0.06, material=look.metal)
    if kit.chance(0.5):
        kit.between((-0.4, 1.9, 1.3), (-0.4, 2.6, 1.3), (0.1, 0.3), BOX, material=look.skin, mirror=True)
        kit.add(BALL, (-0.2, 2.7, 1.15), (2.0, 0.42, 0.42), material=look.skin, mirror=True)
    markings(kit, look, cabin, -0.55, 0.15, 0.35)
    extras(kit, look, 6.8, 0.8, 1.25, 2.85)


def halo(kit, look):
    """Mi-26 and Mi-6: a huge round hold, a glazed nose, mouths over the cockpit, a long boom and fin, eight blades or five."""
    rng = kit.rng
    cabin = hull(kit, (0.0, 0, 2.6), (7.6, 1.75, 1.75), look.skin, 5.0)
    hull(kit, (7.4, 0, 2.35), (2.3, 1.6, 1.4), look.skin, 2.5, (0.65, 0.65), 0)
    cockpit(kit, (7.2, 0, 2.8), (2.1, 1.55, 1.2), look, 2.6, (0.65, 0.8), -0.3, hoop=0.1)
    hull(kit, (0.8, 0, 4.65), (5.2, 1.3, 0.85), look.skin, 3.2, (0.9, 0.95), 0)
    engines(kit, 4.0, 0.72, 4.75, 0.66, 2.0, look)
    kit.between((1.4, 1.0, 4.7), (1.0, 1.8, 4.7), 0.42, material=look.dark, mirror=True)
    boom(kit, [(-4.6, 0, 2.9), (-8.4, 0, 3.9), (-17.0, 0, 4.4)], [1.7, 1.0, 0.5], look.skin, 0.95)
    panel(kit, (-16.6, 0, 4.0), 3.8, 1.2, look.skin, 0.65, 2.0, 90, 0.25, False)
    kit.add(BOX, (-17.0, 0, 5.3), (0.7, 2.4, 0.08), material=look.skin)
    tail_rotor(kit, (-18.4, -0.6, 7.3), 3.5, 5, look, 0.6)
    main_rotor(kit, (1, 0, 6.9), rng.uniform(13.5, 16), int(rng.choice([5, 8, 8, 8])), 0.42, look, 1.5)
    gear(kit, [(-2.2, 2.6, 1.8)], 0.75, look, 0.4)
    kit.between((-2.2, 1.2, 1.4), (-2.2, 2.5, 0.75), 0.16, material=look.metal, mirror=True)
    gear(kit, [(6.3, 0, 1.3)], 0.55, look, 0.2, True)
    hull(kit, (-1.8, 1.7, 1.6), (2.2, 0.5, 0.55), look.skin, 3.0)
    hull(kit, (-1.8, -1.7, 1.6), (2.2, 0.5, 0.55), look.skin, 3.0)
    for x in np.linspace(0.7, -0.45, 4):
        pane(kit, cabin, x, 0.3, (0.24, 0.24), look.glass, CYL, 0.05)
    if kit.chance(0.5):
        stripe(kit, cabin, -0.05, 0.1, look.trim)
    kit.add(BOX, (-6.9, 0, 2.2), (2.0, 1.35, 0.05), rotation=turn("y", 30), material=look.dark)
    markings(kit, look, cabin, -0.62, 0.1, 0.5)


def sky_crane(kit, look):
    """S-64 sky crane: a cockpit before a bare spine, engines on top, wide legs, six blades; a tank, a box or a load on the hook below."""
    rng = kit.rng
    hull(kit, (5.6, 0, 2.9), (1.6, 1.0, 1.15), look.skin, 3.2)
    cockpit(kit, (6.05, 0, 3.1), (1.4, 0.96, 0.9), look, 2.6, hoop=0.1)
    hull(kit, (6.2, 0, 2.3), (1.2, 0.9, 0.55), look.skin, 2.5)
    kit.add(BOX, (5.0, 0.98, 2.95), (0.55, 0.04, 0.45), material=look.glass, mirror=True)
    kit.add(BOX, (0.8, 0, 3.75), (4.6, 0.62, 0.4), (1, 0.85), material=look.skin)
    boom(kit, [(-3.6, 0, 3.75), (-11.4, 0, 3.75)], [0.5, 0.34], look.skin, 1.0)
    hull(kit, (0.0, 0, 4.5), (2.0, 0.62, 0.55), look.dark if kit.chance(0.4) else look.skin, 3.2)
    engines(kit, 1.2, 0.72, 4.55, 0.46, 1.4, look, look.metal if kit.chance(0.5) else look.skin)
    panel(kit, (-11.2, 0, 3.5), 2.6, 0.65, look.trim if kit.chance(0.4) else look.skin, 0.65, 1.4, 90, 0.18, False)
    kit.add(BOX, (-12.5, -1.1, 6.0), (0.5, 1.15, 0.06), material=look.skin)
    tail_rotor(kit, (-12.45, 0.5, 5.9), 2.3, 4, look, 0.5)
    main_rotor(kit, (0, 0, 6.0), rng.uniform(9.6, 10.9), 6, 0.3, look, 1.1)
    legs = rng.uniform(2.6, 3.1)
    kit.between((-0.6, 0.3, 3.7), (-0.6, legs, 2.6), 0.22, BOX, material=look.skin, mirror=True)
    gear(kit, [(-0.6, legs, 2.7)], 0.55, look, 0.22)
    kit.between((0.9, 0.5, 3.6), (-0.5, legs * 0.9, 2.65), 0.08, material=look.metal, mirror=True)
    gear(kit, [(5.4, 0, 2.0)], 0.42, look, 0.15, True)
    load = rng.choice(["tank", "pod", "sling", "none"])
    if load == "tank":
        hull(kit, (0.9, 0, 2.75), (2.4, 1.1, 0.8), look.trim if kit.chance(0.5) else look.skin, 4.0)
        kit.between((-0.9, 0, 2.2), (-0.9, 0, 0.5), 0.14, material=look.dark)
    elif load == "pod":
        box = kit.material(pattern=rng.choice([PLAIN, RIBS]), frequency=14)
        kit.add(BOX, (0.5, 0, 2.35), (3.4, 1.2, 1.05), material=box)
        kit.add(BOX, (2.6, 1.2, 2.3), (0.4, 0.04, 0.75), material=look.dark, mirror=True)
    elif load == "sling":
        kit.between((0.6, 0, 3.5), (0.6, 0, 1.2), 0.05, material=look.dark)
        kit.add(BOX, (0.6, 0, 0.75), (rng.uniform(0.7, 1.6), rng.uniform(0.5, 0.9), 0.5), material=kit.material())
    else:
        kit.between((0.6, 0, 3.4), (0.6, 0, 2.4), 0.05, material=look.dark)
        kit.add(BALL, (0.6, 0, 2.35), (0.14, 0.14, 0.18), material=look.metal)
    body = Hull(np.array([0.8, 0, 3.75]), (4.6, 0.58, 0.4), 8.0, (1, 1), 0)
    markings(kit, look, body, -0.5, 0.0, 0.22)


def chinook(kit, look):
    """CH-47 and CH-46: a long hold with tanks along its sides, a rotor over the nose and one on a tall pylon, engines beside that, a ramp."""
    rng, small = kit.rng, kit.chance(0.3)
    cabin = hull(kit, (0, 0, 1.7), (6.0, 1.15, 1.1), look.skin, 6.0)
    hull(kit, (6.1, 0, 1.45), (1.5, 1.02, 0.85), look.skin, 2.6, (0.7, 0.7), 0)
    cockpit(kit, (5.75, 0, 1.95), (1.55, 1.05, 0.82), look, 2.7, (0.7, 0.85), -0.15, hoop=0.15)
    kit.add(BOX, (-5.9, 0, 1.95), (0.85, 1.0, 1.0), (0.6, 0.85), (0.3, 0), turn("y", -90), look.skin)
    front, rear = np.array([5.0, 0, 3.9]), np.array([-5.0, 0, 5.3])
    hull(kit, (4.9, 0, 3.0), (1.35, 0.55, 0.65), look.skin, 2.6)
    kit.add(BOX, (-5.0, 0, 3.6), (1.6, 0.42, 1.35), (0.75, 0.85), (-0.1, 0), material=look.skin)
    hull(kit, (-5.0, 0, 4.75), (1.35, 0.45, 0.35), look.skin, 2.6)
    kit.between((4.6, 0, 2.85), (-4.4, 0, 2.85), (0.22, 0.35), BOX, material=look.skin)
    if small:
        engines(kit, -4.6, 0.5, 3.2, 0.4, 1.0, look)
    else:
        engines(kit, -4.7, 0.98, 3.15, 0.42, 0.95, look, out=10)
    for y in (1.3, -1.3):
        if small:
            hull(kit, (-3.3, y, 1.0), (1.7, 0.42, 0.48), look.skin, 3.0)
        else:
            hull(kit, (-0.4, y, 1.15), (4.6, 0.38, 0.55), look.skin, 4.5)
    reach, blades, first = rng.uniform(8.2, 9.2), 3, rng.uniform(0, 120)
    main_rotor(kit, front, reach, blades, 0.33, look, 0.7, pace=first)
    main_rotor(kit, rear, reach, blades, 0.33, look, 0.7, pace=first)
    gear(kit, [(-4.0, 1.35, 0.9)], 0.36, look, 0.14)
    gear(kit, [(2.6, 1.35, 0.9)] if not small else [(5.0, 0, 0.8)], 0.36, look, 0.16, small)
    for x in np.linspace(0.6, -0.5, 4):
        pane(kit, cabin, x, 0.35, (0.2, 0.2), look.glass, CYL)
    kit.add(BOX, (-6.3, 0, 1.1), (0.85, 0.9, 0.04), rotation=turn("y", 40), material=look.dark)
    pane(kit, cabin, 0.76, 0.0, (0.36, 0.75), look.trim)
    markings(kit, look, cabin, -0.2, 0.35, 0.28)
