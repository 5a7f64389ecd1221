"""What the makers of helicopters by their real types share: liveries, hulls, panes, booms, rotors, skids, wheels, engines, markings."""

from typing import NamedTuple

import numpy as np

from .kit import ALONG_X, ALONG_Y, towards, turn
from .layout import BALL, BOX, CYL, SPOKES, TUBE
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, SEAMS, STREAKS, WRITING, Material, paint

ARMY = [[0.1, 0.11, 0.05], [0.06, 0.07, 0.04], [0.4, 0.32, 0.19], [0.025, 0.027, 0.025], [0.13, 0.16, 0.1], [0.16, 0.16, 0.15]]
NAVY = [[0.3, 0.33, 0.36], [0.5, 0.53, 0.55], [0.13, 0.16, 0.2], [0.75, 0.76, 0.76], [0.04, 0.07, 0.16]]
RESCUE = [[0.75, 0.5, 0.02], [0.65, 0.05, 0.03], [0.8, 0.2, 0.03], [0.82, 0.82, 0.8], [0.75, 0.68, 0.05]]
POLICE = [[0.02, 0.04, 0.16], [0.8, 0.8, 0.8], [0.03, 0.12, 0.4], [0.02, 0.02, 0.02], [0.04, 0.2, 0.08]]


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
