"""A maker of military and police vehicles on wheels, unmanned ones among them."""

from typing import NamedTuple

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .launchers import SERVICE, axles, drab, lorry, metal, timber, trim
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, RUNGS, SPOKES
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, RIBS, SEAMS, STRIPES, WRITING, Material
from .wheeled import glazing, lamps, plates


class Look(NamedTuple):
    """A vehicle's materials."""

    paint: Material
    dark: Material
    glass: Material
    steel: Material
    rim: Material
    cloth: Material


def look(kit, paint=None):
    paint = paint or drab(kit)
    rim = kit.material(base=paint.first, pattern=PLAIN) if kit.chance(0.6) else metal(kit)
    base = np.array(SERVICE[kit.rng.integers(len(SERVICE))]) * kit.rng.uniform(0.7, 1.5)
    cloth = kit.material(base=base, pattern=kit.rng.choice([PLAIN, CLOUDY, CAMOUFLAGE]), gloss=0.02)
    return Look(paint, kit.material(dark=True, pattern=PLAIN), glazing(kit), metal(kit), rim, cloth)


def flat(kit, colour, **more):
    return kit.material(base=colour, pattern=PLAIN, **more)


def span(kit, x, z, wide, material, taper=(1, 1), shift=(0, 0), cut=(0, 1, 1)):
    """A box right across from x[0] to x[1] and from z[0] to z[1]; the shift moves its top."""
    kit.add(BOX, (sum(x) / 2, 0, sum(z) / 2), (abs(x[1] - x[0]) / 2, wide, (z[1] - z[0]) / 2), taper, shift, material=material, cut=cut)


def raked(kit, x, z, wide, front, rear, narrow, material):
    """A box across whose top recedes by `front` and `rear` at its ends and has `narrow` of its width."""
    half = (x[1] - x[0]) / 2
    span(kit, x, z, wide, material, (max(1 - (front + rear) / (2 * half), 0.02), narrow), ((rear - front) / 2, 0))


def running(kit, xs, y, radius, half, on):
    """Two wheels with rims and an axle at every x."""
    hub = radius * kit.rng.uniform(0.5, 0.62)
    for x in xs:
        kit.add(CYL, (x, y, radius), (radius, radius, half), rotation=ALONG_Y, material=on.dark, mirror=True)
        kit.add(CYL, (x, y + half * 0.6, radius), (hub, hub, half * 0.45), rotation=ALONG_Y, material=on.rim, mirror=True)
        kit.add(CYL, (x, 0, radius), (0.07, 0.07, y), rotation=ALONG_Y, material=on.dark)


def spare(kit, at, radius, half, on, axis=ALONG_X):
    kit.add(CYL, at, (radius, radius, half), rotation=axis, material=on.dark)
    kit.add(CYL, at, (radius * 0.55, radius * 0.55, half * 1.1), rotation=axis, material=on.rim)


def mirrors(kit, x, wide, z, on):
    kit.between((x, wide * 0.94, z - 0.12), (x, wide + 0.2, z), 0.018, material=on.dark, mirror=True)
    kit.add(BOX, (x, wide + 0.2, z + 0.06), (0.03, 0.09, 0.14), material=on.dark, mirror=True)


def whips(kit, x, wide, z, on):
    """One or two aerials on their feet."""
    tall = kit.rng.uniform(0.8, 1.7)
    for side in [1, -1][: int(kit.rng.integers(1, 3))]:
        kit.add(CYL, (x, side * wide, z), (0.05, 0.05, 0.1), material=on.dark)
        kit.between((x, side * wide, z), (x - 0.1 * tall, side * wide, z + tall), 0.012, material=on.dark)


def machine_gun(kit, at, on, shield=None, size=1.0, lift=None):
    """A gun on a post that stands at `at`, with or without a shield."""
    rng, at = kit.rng, np.array(at, float)
    lift = rng.uniform(-3, 14) if lift is None else lift
    shield = kit.chance(0.5) if shield is None else shield
    frame = turn("y", -lift)
    top = at + [0, 0, 0.36 * size]
    kit.between(at - [0, 0, 0.05], top, 0.05 * size, material=on.steel)
    kit.add(BOX, top, np.array([0.3, 0.05, 0.08]) * size, rotation=frame, material=on.dark)
    kit.between(top, top + frame @ np.array([1.05, 0, 0.02]) * size, 0.03 * size, material=on.dark)
    kit.add(BOX, top + np.array([0, 0.14, -0.04]) * size, np.array([0.11, 0.09, 0.1]) * size, material=on.paint)
    if shield:
        kit.add(BOX, top + np.array([0.28, 0.27, 0.02]) * size, np.array([0.025, 0.2, 0.3]) * size, rotation=turn("y", -8), material=on.paint, mirror=True)


def ring_mount(kit, x, z, on):
    """A roof ring with a gun, open or behind plates all around."""
    kit.add(CYL, (x, 0, z + 0.02), (0.5, 0.5, 0.06), material=on.dark)
    style = kit.rng.choice(["open", "shield", "box"])
    if style == "box":
        kit.add(BOX, (x - 0.05, 0.48, z + 0.28), (0.45, 0.025, 0.27), (0.85, 1), material=on.paint, mirror=True)
        kit.add(BOX, (x - 0.5, 0, z + 0.25), (0.025, 0.48, 0.23), material=on.paint)
    machine_gun(kit, (x + 0.4, 0, z + 0.06), on, style != "open", 0.9)


def red_cross(kit, x, wide, z, size):
    """White squares with the cross on both sides."""
    white, red = flat(kit, [0.85, 0.85, 0.82]), flat(kit, [0.6, 0.02, 0.02])
    kit.add(BOX, (x, wide, z), (size, 0.02, size), material=white, mirror=True)
    kit.add(BOX, (x, wide + 0.012, z), (size * 0.75, 0.02, size * 0.25), material=red, mirror=True)
    kit.add(BOX, (x, wide + 0.012, z), (size * 0.25, 0.02, size * 0.75), material=red, mirror=True)


def canvas(kit, x, z, wide, on):
    """A tilt: upright cloth sides and a rounded ridge."""
    cloth = on.cloth._replace(pattern=RIBS, frequency=kit.rng.uniform(4, 9)) if kit.chance(0.3) else on.cloth
    low, high = z
    edge = low + (high - low) * kit.rng.uniform(0.65, 0.8)
    span(kit, x, (low, edge), wide, cloth, (1, 0.97))
    span(kit, x, (edge - 0.01, high), wide * 0.97, cloth, (0.98, kit.rng.uniform(0.6, 0.85)))


def grille(kit, x, z, wide, on):
    """Bars or slats at the nose."""
    slat = kit.material(base=[0.02] * 3, pattern=RIBS, frequency=kit.rng.uniform(20, 40), second=on.paint.first)
    kit.add(BOX, (x, 0, z), (0.025, wide * 0.5, 0.13), material=slat)


def utility(kit):
    """Wide low four-door utility trucks."""
    rng, on = kit.rng, look(kit)
    wide, long, radius = rng.uniform(1.0, 1.12), rng.uniform(2.25, 2.45), rng.uniform(0.44, 0.5)
    floor, deck, roof, screen = 0.55, rng.uniform(1.15, 1.25), rng.uniform(1.8, 1.95), 0.62
    running(kit, (1.62, -1.65), wide - 0.17, radius, 0.17, on)
    span(kit, (-long, long - 0.1), (floor, 1.0), wide * 0.62, on.paint)
    span(kit, (-1.08, 1.05), (floor, deck), wide, on.paint)
    span(kit, (-long, -0.9), (0.95, deck), wide, on.paint)
    raked(kit, (0.5, long), (0.92, deck + 0.03), wide, rng.uniform(0.12, 0.4), 0, 0.9, on.paint)
    style = rng.choice(["sloped", "pickup", "canvas", "shelter", "ambulance", "sloped", "box"])
    back = -0.95 if style in ("sloped", "box", "canvas") else rng.uniform(-0.35, -0.2)
    soft = style == "canvas" and kit.chance(0.6)
    raked(kit, (back, screen), (deck - 0.02, roof), wide * 0.98, 0.16, 0, 0.86, on.cloth if soft else on.paint)
    pane = 0.22 if not soft else 0.18
    raked(kit, (back + 0.15, screen - 0.25), (roof - 0.2 - pane, roof - 0.12), wide * 0.965, 0.08, 0, 0.95, on.glass)
    kit.add(BOX, (screen - 0.09, wide * 0.42, roof - 0.32), (0.05, wide * 0.36, 0.2), shift=(-0.1, 0), material=on.glass, mirror=True)
    if style == "sloped":
        raked(kit, (-long, back + 0.02), (deck - 0.02, roof), wide * 0.98, 0, rng.uniform(0.8, 1.25), 0.86, on.paint)
    elif style == "box":
        raked(kit, (-long, back + 0.02), (deck - 0.02, roof + 0.02), wide * 0.98, 0, 0.1, 0.88, on.paint)
    elif style == "canvas":
        canvas(kit, (-long, back + 0.02), (deck - 0.02, roof + 0.04), wide * 0.96, on)
    elif style == "pickup":
        span(kit, (-long, back), (deck - 0.03, deck + 0.01), wide * 0.9, on.dark)
        kit.add(BOX, ((back - long) / 2, wide * 0.96, deck + 0.15), ((back + long) / 2, 0.03, 0.18), material=on.paint, mirror=True)
        span(kit, (-long, -long + 0.05), (deck - 0.03, deck + 0.33), wide * 0.96, on.paint)
        if kit.chance(0.5):
            kit.add(BOX, (-1.2, rng.uniform(-0.3, 0.3), deck + 0.2), (0.45, 0.4, 0.22), material=on.cloth)
    else:
        tall = rng.uniform(0.25, 0.7)
        raked(kit, (-long - 0.1, back + 0.02), (deck - 0.05, roof + tall), wide * 1.02, rng.choice([0, 0.35]), 0, 0.95, on.paint)
        if style == "ambulance":
            red_cross(kit, -1.3, wide * 1.01, roof + tall * 0.2, 0.3)
        else:
            kit.add(BOX, (back + 0.15, 0, roof + tall * 0.4), (0.2, 0.4, 0.2), material=on.steel)
    if style in ("sloped", "box", "canvas", "pickup") and kit.chance(0.65) and not soft:
        ring_mount(kit, back * 0.5 if style != "pickup" else back / 2 + 0.1, roof, on)
    grille(kit, long, 1.03, wide, on)
    lamps(kit, long + 0.01, -long, wide * 0.95, 1.03, 0.1)
    span(kit, (long - 0.08, long + 0.12), (0.62, 0.8), wide * rng.uniform(0.7, 0.95), on.dark)
    mirrors(kit, screen - 0.1, wide, deck + 0.25, on)
    kit.add(BOX, (-0.18, wide, (floor + roof) / 2 - 0.1), (0.015, 0.012, 0.45), material=on.dark, mirror=True)
    if kit.chance(0.6):
        whips(kit, -long + 0.25, wide * 0.9, deck, on)
    if kit.chance(0.4):
        kit.between((screen + 0.1, -wide * 0.9, deck - 0.1), (screen + 0.1, -wide * 0.9, roof + 0.15), 0.06, material=on.dark)
    if kit.chance(0.4):
        kit.add(CYL, (long + 0.18, 0, 0.78), (0.09, 0.09, 0.3), rotation=ALONG_Y, material=on.steel)


def jeep(kit):
    """Jeeps of the 1940s, open, with folded screen or under canvas."""
    rng, on = kit.rng, look(kit)
    wide, long, radius = rng.uniform(0.72, 0.8), rng.uniform(1.6, 1.75), rng.uniform(0.34, 0.39)
    running(kit, (1.08, -0.98), wide - 0.13, radius, 0.085, on)
    deck = 0.95
    span(kit, (-long, long - 0.2), (0.42, 0.56), wide * 0.6, on.paint)
    span(kit, (-1.5, 0.45), (0.5, 0.58), wide, on.paint)
    kit.add(BOX, (-1.0, wide - 0.15, 0.72), (0.55, 0.15, 0.16), material=on.paint, mirror=True)
    kit.add(BOX, (-1.03, wide - 0.02, 0.83), (0.58, 0.025, 0.12), material=on.paint, mirror=True)
    kit.add(BOX, (-0.05, wide - 0.02, 0.6), (0.52, 0.025, 0.14), material=on.paint, mirror=True)
    span(kit, (-long + 0.02, -long + 0.07), (0.5, deck), wide, on.paint)
    raked(kit, (0.35, 1.48), (0.52, deck + 0.05), wide * 0.62, 0.02, 0, 0.86, on.paint)
    span(kit, (0.3, 0.46), (0.5, deck + 0.04), wide, on.paint, (1, 0.92))
    kit.add(BOX, (1.0, wide - 0.14, 0.83), (0.52, 0.16, 0.025), material=on.paint, mirror=True)
    kit.add(BOX, (0.52, wide - 0.14, 0.7), (0.03, 0.16, 0.15), rotation=turn("y", -25), material=on.paint, mirror=True)
    kit.add(BOX, (1.49, 0, 0.75), (0.02, wide * 0.6, 0.19), material=on.paint)
    kit.add(BOX, (1.515, 0, 0.76), (0.01, wide * 0.3, 0.13), material=flat(kit, [0.02] * 3), cut=(BARS, 11, 0.45))
    folded = kit.chance(0.25)
    top = 1.5
    if folded:
        kit.add(BOX, (0.72, 0, 1.04), (0.3, wide * 0.86, 0.02), material=on.paint)
        kit.add(BOX, (0.72, 0, 1.05), (0.24, wide * 0.76, 0.02), material=on.glass)
    else:
        kit.between((0.38, wide * 0.86, deck), (0.25, wide * 0.86, top - 0.03), 0.025, BOX, material=on.paint, mirror=True)
        kit.add(BOX, (0.25, 0, top - 0.03), (0.025, wide * 0.88, 0.03), material=on.paint)
        kit.add(BOX, (0.31, 0, 1.23), (0.008, wide * 0.84, 0.25), rotation=turn("y", -14), material=on.glass)
    if kit.chance(0.4) and not folded:
        raked(kit, (-long + 0.02, 0.27), (top - 0.02, top + 0.1), wide, 0.15, 0.1, 0.75, on.cloth)
        span(kit, (-long + 0.02, -long + 0.06), (deck - 0.05, top), wide * 0.97, on.cloth)
        kit.between((-0.75, wide * 0.95, deck - 0.05), (-0.75, wide * 0.95, top), 0.025, material=on.dark, mirror=True)
        if kit.chance(0.4):
            kit.add(BOX, (-1.15, wide * 0.96, 1.22), (0.42, 0.015, 0.3), material=on.cloth, mirror=True)
    elif kit.chance(0.6):
        kit.between((-0.7, 0, 0.55), (-0.7, 0, 1.25), 0.05, material=on.steel)
        machine_gun(kit, (-0.7, 0, 1.2), on, False, 0.9)
    for x, half in ((-0.3, 0.19), (-1.15, 0.45)):
        mirror = x > -1
        place = wide * 0.45 if mirror else 0
        kit.add(BOX, (x, place, 0.7), (0.2, half, 0.12), material=on.cloth, mirror=mirror)
        kit.add(BOX, (x - 0.21, place, 0.92), (0.05, half, 0.2), rotation=turn("y", -10), material=on.cloth, mirror=mirror)
    kit.add(CYL, (0.1, wide * 0.45, 1.02), (0.19, 0.19, 0.02), rotation=turn("y", -50), material=on.dark, cut=(SPOKES, 3, 0.15))
    kit.between((0.1, wide * 0.45, 1.02), (0.35, wide * 0.45, 0.75), 0.02, material=on.dark)
    spare(kit, (-long - 0.06, -0.2, 0.85), radius, 0.08, on)
    kit.add(BOX, (-long - 0.08, 0.45, 0.8), (0.08, 0.17, 0.23), material=on.paint)
    lamps(kit, 1.52, -long, wide * 0.62, 0.79, 0.09)
    span(kit, (1.5, 1.62), (0.5, 0.6), wide * 0.95, on.paint)
    if kit.chance(0.5):
        kit.add(BALL, (0.9, 0, 1.005), (0.2, 0.2, 0.012), material=flat(kit, [0.8] * 3))


def rover(kit):
    """Box bodies, tilts and pick-ups with an upright screen and the spare wheel on the bonnet."""
    rng, on = kit.rng, look(kit)
    wide, long, radius = rng.uniform(0.8, 0.9), rng.uniform(1.85, 2.3), rng.uniform(0.38, 0.44)
    front, screen, deck, roof = 1.55, 0.72, rng.uniform(1.1, 1.18), rng.uniform(1.88, 2.05)
    rear = 0.9 - long
    running(kit, (front - 0.45, rear), wide - 0.12, radius, 0.1, on)
    span(kit, (-long, front + 0.2), (0.48, 0.85), wide * 0.66, on.dark)
    span(kit, (rear + 0.5, front - 0.92), (0.5, deck), wide, on.paint)
    span(kit, (-long, rear + 0.55), (radius * 2 + 0.04, deck), wide, on.paint)
    span(kit, (-long, rear - 0.48), (0.55, deck), wide, on.paint)
    span(kit, (screen - 0.1, front + 0.3), (radius * 2 + 0.03, deck - 0.06), wide, on.paint)
    span(kit, (front - 0.02, front + 0.3), (0.6, deck - 0.06), wide, on.paint)
    raked(kit, (screen - 0.1, front + 0.24), (deck - 0.08, deck + 0.04), wide * 0.66, 0.04, 0, 0.95, on.paint)
    style = rng.choice(["station", "tilt", "pickup", "ambulance", "police"], p=[0.3, 0.25, 0.2, 0.13, 0.12])
    back = -long if style in ("station", "police") else -0.35
    top = on.paint if kit.chance(0.5) else flat(kit, np.array([0.75, 0.74, 0.68]) * rng.uniform(0.5, 1))
    raked(kit, (back, screen), (deck - 0.02, roof - 0.08), wide * 0.98, 0.1, 0, 0.9, on.paint)
    raked(kit, (back - 0.01, screen - 0.08), (roof - 0.1, roof), wide * 0.91, 0.05, 0.04, 0.9, top)
    raked(kit, (-0.3, screen - 0.2), (roof - 0.52, roof - 0.18), wide * 0.955, 0.06, 0, 0.95, on.glass)
    kit.add(BOX, (screen - 0.03, wide * 0.42, roof - 0.36), (0.05, wide * 0.36, 0.18), shift=(-0.05, 0), material=on.glass, mirror=True)
    if style in ("station", "police"):
        span(kit, (-long + 0.25, -0.6), (roof - 0.5, roof - 0.2), wide * 0.955, on.glass, (1, 0.96))
        kit.add(BOX, (-long - 0.01, 0, roof - 0.38), (0.02, wide * 0.55, 0.17), material=on.glass)
        spare(kit, (-long - 0.1, 0, 0.98), radius * 0.85, 0.09, on)
        if style == "police":
            kit.add(BOX, (0.1, 0, roof + 0.07), (0.12, wide * 0.75, 0.07), material=flat(kit, [0.03, 0.08, 0.6], gloss=0.6))
            kit.add(BOX, ((screen - long) / 2, wide + 0.005, deck - 0.15), ((screen + long) / 2, 0.01, 0.09), material=kit.material(pattern=PLAIN), mirror=True)
        elif kit.chance(0.5):
            kit.add(BOX, (-long * 0.35, 0, roof + 0.1), (long * 0.5, wide * 0.8, 0.1), material=on.dark, cut=(LATTICE, 8, 0.3))
    elif style == "tilt":
        canvas(kit, (-long, back + 0.03), (deck - 0.02, roof + 0.05), wide * 0.97, on)
    elif style == "ambulance":
        raked(kit, (-long - 0.15, back + 0.03), (deck - 0.1, roof + 0.3), wide * 1.08, 0.2, 0, 0.95, on.paint)
        red_cross(kit, -long * 0.55, wide * 1.07, roof - 0.25, 0.28)
    else:
        span(kit, (-long, back), (deck - 0.02, deck + 0.02), wide * 0.94, on.dark)
        kit.add(BOX, ((back - long) / 2, wide * 0.97, deck + 0.1), ((back + long) / 2, 0.03, 0.14), material=on.paint, mirror=True)
        span(kit, (-long, -long + 0.05), (deck - 0.02, deck + 0.24), wide * 0.97, on.paint)
        if kit.chance(0.6):
            kit.between((-0.9, 0, deck), (-0.9, 0, roof - 0.1), 0.05, material=on.steel)
            machine_gun(kit, (-0.9, 0, roof - 0.15), on)
    if kit.chance(0.7):
        spare(kit, (front - 0.25, 0, deck + 0.1), radius * 0.95, 0.09, on, np.eye(3))
    grille(kit, front + 0.3, deck - 0.28, wide * 0.9, on)
    lamps(kit, front + 0.31, -long, wide, deck - 0.25, 0.09)
    span(kit, (front + 0.28, front + 0.42), (0.58, 0.7), wide * 0.98, on.dark)
    mirrors(kit, screen, wide, deck + 0.22, on)
    if kit.chance(0.4):
        kit.between((screen + 0.05, wide * 0.95, deck - 0.1), (screen - 0.03, wide * 0.95, roof + 0.2), 0.05, material=on.dark)
    if kit.chance(0.5):
        whips(kit, -long + 0.1, wide * 0.9, deck, on)
    kit.add(BOX, (0.68, wide, 0.82), (0.012, 0.012, 0.3), material=on.dark, mirror=True)
    kit.add(BOX, (-0.33, wide, 0.82), (0.012, 0.012, 0.3), material=on.dark, mirror=True)


def protected(kit):
    """Mine-protected vehicles: a V under a tall armoured box, big wheels, small thick windows."""
    rng, on = kit.rng, look(kit)
    count = rng.choice([2, 2, 2, 3])
    wide, radius = rng.uniform(1.15, 1.3), rng.uniform(0.56, 0.68)
    long = rng.uniform(2.6, 3.1) + 0.5 * (count - 2)
    belly, waist, roof = radius * 0.95, radius * 2 + rng.uniform(0.05, 0.2), rng.uniform(2.6, 2.95)
    hood, nose = waist + rng.uniform(0.45, 0.65), rng.uniform(0.9, 1.4)
    xs = (long - 0.75, -long + 0.8) if count == 2 else (long - 0.75, -long + 0.75 + 2.15 * radius, -long + 0.75)
    running(kit, xs, wide - 0.14, radius, 0.19, on)
    kit.add(BOX, (-0.05, 0, (belly + waist) / 2), (long * 0.96, wide * 0.75, (waist - belly) / 2), (0.93, rng.uniform(0.15, 0.35)), rotation=turn("x", 180), material=on.paint)
    raked(kit, (long - nose - 0.05, long), (waist - 0.1, hood), wide * 0.85, rng.uniform(0.1, 0.35), 0, 0.85, on.paint)
    raked(kit, (-long, long - nose + 0.15), (waist - 0.02, roof), wide, rng.uniform(0.25, 0.5), rng.choice([0, 0.15]), rng.uniform(0.84, 0.93), on.paint)
    for x in xs:
        kit.add(BOX, (x, wide - 0.16, radius * 2 + 0.06), (radius * 1.1, 0.22, 0.05), (0.8, 1), material=on.paint, mirror=True)
    screen = long - nose - 0.02
    kit.add(BOX, (screen - 0.03, wide * 0.4, (hood + roof) / 2 - 0.02), (0.06, wide * 0.32, (roof - hood) * 0.3), (1, 1), (-0.14, 0), material=on.glass, mirror=True)
    for x in np.linspace(screen - 0.75, -long + 0.7, int(rng.integers(3, 5))):
        kit.add(BOX, (x, wide * 0.945, roof - 0.48), (rng.uniform(0.19, 0.28), 0.06, 0.17), (1, 0.9), material=on.glass, mirror=True)
    turret = rng.choice(["ring", "remote", "none"], p=[0.45, 0.35, 0.2])
    if turret == "ring":
        ring_mount(kit, 0.1, roof, on)
    elif turret == "remote":
        kit.add(CYL, (0.2, 0, roof + 0.08), (0.3, 0.3, 0.1), material=on.paint)
        machine_gun(kit, (0.2, 0, roof + 0.15), on, False)
        kit.add(BOX, (0.25, -0.2, roof + 0.5), (0.13, 0.1, 0.13), material=on.paint)
    grille(kit, long + 0.005, (waist + hood) / 2 - 0.05, wide, on)
    lamps(kit, long + 0.02, -long, wide * 0.85, waist + 0.08, 0.11)
    span(kit, (long - 0.1, long + 0.2), (waist - 0.3, waist - 0.05), wide * 0.85, on.paint)
    kit.add(BOX, (-long - 0.02, 0, (waist + roof) / 2), (0.03, wide * 0.5, (roof - waist) * 0.4), material=on.paint)
    kit.add(BOX, (-long - 0.05, 0, waist - 0.25), (0.15, wide * 0.4, 0.3), material=on.dark, cut=(RUNGS, 5, 0.3))
    mirrors(kit, screen + 0.1, wide, hood + 0.3, on)
    whips(kit, -long + 0.3, wide * 0.75, roof, on)
    kit.add(BOX, (-0.2, wide * 0.9, waist - 0.25), (0.5, 0.2, 0.22), material=on.paint, mirror=True)


def armoured_car(kit):
    """Armoured cars on four, six or eight wheels with sloped hulls, cannon and hatches."""
    rng, on = kit.rng, look(kit)
    count = int(rng.choice([2, 2, 3, 4]))
    wide, radius = rng.uniform(1.0, 1.25), rng.uniform(0.46, 0.58)
    long = (2.2, 2.7, 3.3)[count - 2] * rng.uniform(0.95, 1.1)
    xs = [(1.35, -1.35), (1.75, -0.45, -1.8), (2.25, 0.85, -0.7, -2.1)][count - 2]
    running(kit, np.array(xs) * long / (2.2, 2.7, 3.3)[count - 2], wide - 0.15, radius, 0.16, on)
    belly, waist, deck = radius * 0.85, radius * 2 + 0.08, radius * 2 + rng.uniform(0.4, 0.65)
    nose, tail = rng.uniform(0.25, 0.6), rng.uniform(0.1, 0.4)
    kit.add(BOX, (0, 0, (belly + waist) / 2), (long, wide * 0.68, (waist - belly) / 2), (1 - nose / long, 0.9), rotation=turn("x", 180), material=on.paint)
    raked(kit, (-long, long), (waist - 0.06, deck), wide, rng.uniform(0.7, 1.3), tail, rng.uniform(0.7, 0.9), on.paint)
    x, half, high = rng.uniform(-0.5, 0.3), rng.uniform(0.6, 0.78), rng.uniform(0.35, 0.55)
    kit.add(CYL, (x, 0, deck + 0.02), (half * 0.95, half * 0.95, 0.06), material=on.dark)
    shape = rng.choice(["cone", "box", "round"])
    if shape == "cone":
        kit.add(CYL, (x, 0, deck + high / 2 + 0.04), (half, half, high / 2), (0.72, 1), material=on.paint)
    elif shape == "box":
        kit.add(BOX, (x - 0.05, 0, deck + high / 2 + 0.04), (half * 1.1, half * 0.95, high / 2), (0.75, 0.75), material=on.paint)
    else:
        kit.add(CYL, (x, 0, deck + high * 0.3 + 0.04), (half, half * 0.95, high * 0.3), (0.9, 1), material=on.paint)
        kit.add(BALL, (x, 0, deck + high * 0.55), (half * 0.9, half * 0.85, high * 0.55), material=on.paint)
    frame = turn("y", -rng.uniform(-2, 12))
    root = np.array([x + half * 0.75, 0, deck + high * 0.55])
    bore, reach = rng.choice([(0.035, 1.3), (0.06, 1.9), (0.075, 1.3)])
    kit.add(BOX, root, (0.25, 0.2, high * 0.32), rotation=frame, material=on.paint)
    kit.between(root, root + frame @ np.array([reach, 0, 0]), bore, material=on.steel)
    if bore > 0.05:
        kit.between(root + frame @ np.array([reach - 0.2, 0, 0]), root + frame @ np.array([reach + 0.02, 0, 0]), bore * 1.5, material=on.steel)
    kit.add(CYL, (x - 0.15, 0.25, deck + high + 0.05), (0.22, 0.22, 0.06), material=on.paint)
    kit.add(CYL, (x - 0.15, -0.25, deck + high + 0.05), (0.2, 0.2, 0.06), material=on.paint)
    kit.add(BOX, (long - 0.75, wide * 0.33, deck - 0.08), (0.12, 0.22, 0.08), (0.8, 1), material=on.glass, mirror=True)
    for x0 in xs:
        kit.add(BOX, (x0 * 0.99, wide - 0.14, waist + 0.01), (radius * 1.15, 0.18, 0.05), (0.85, 1), material=on.paint, mirror=True)
    lamps(kit, long - 0.02, -long + 0.02, wide * 0.9, waist + 0.02, 0.09)
    whips(kit, x - half * 0.7, half * 0.6, deck + high * 0.7, on)
    if kit.chance(0.5):
        kit.add(CYL, (x + half * 0.6, half * 0.75, deck + high * 0.6), (0.05, 0.05, 0.16), rotation=turn("y", 55), material=on.dark, mirror=True)
    kit.add(BOX, (-0.1, wide * 0.92, (waist + deck) / 2), (0.35, 0.06, 0.16), (1, 0.8), material=on.paint, mirror=True)
    if kit.chance(0.5):
        spare(kit, (-long - 0.02, 0, waist + 0.1), radius * 0.8, 0.13, on)


def technical(kit):
    """Civilian pick-ups with a heavy gun, rockets or a recoilless gun on the bed."""
    rng = kit.rng
    colour = np.array([[0.75, 0.74, 0.7], [0.5, 0.42, 0.28], [0.35, 0.03, 0.03], [0.04, 0.08, 0.2], [0.1, 0.1, 0.1]][rng.integers(5)])
    on = look(kit, drab(kit) if kit.chance(0.3) else kit.material(base=colour, pattern=rng.choice([PLAIN, CLOUDY])))
    wide, long, radius = rng.uniform(0.84, 0.93), rng.uniform(2.35, 2.6), rng.uniform(0.37, 0.42)
    deck, roof, crew = 1.05, rng.uniform(1.68, 1.8), rng.choice([-0.2, -0.75])
    running(kit, (1.5, -1.45), wide - 0.12, radius, 0.12, on)
    span(kit, (-long, long - 0.1), (0.45, 0.8), wide * 0.68, on.dark)
    span(kit, (-0.98, 1.02), (0.45, deck), wide, on.paint)
    raked(kit, (0.7, long), (radius * 2 + 0.02, deck + 0.03), wide, 0.15, 0, 0.92, on.paint)
    span(kit, (1.95, long - 0.02), (0.5, 0.95), wide * 0.98, on.paint)
    raked(kit, (crew, 1.05), (deck - 0.02, roof), wide * 0.97, 0.6, 0.12, 0.82, on.paint)
    raked(kit, (crew + 0.1, 0.85), (deck + 0.08, roof - 0.1), wide * 0.96, 0.5, 0.06, 0.86, on.glass)
    raked(kit, (crew - 0.01, 1.02), (deck + 0.1, roof - 0.1), wide * 0.8, 0.46, 0.1, 0.88, on.glass)
    floor = 0.82
    span(kit, (-long, crew), (floor - 0.06, floor), wide * 0.95, on.dark)
    kit.add(BOX, ((crew - long) / 2, wide - 0.04, floor + 0.1), ((crew + long) / 2, 0.04, 0.22), material=on.paint, mirror=True)
    span(kit, (-long, -long + 0.06), (floor - 0.15, deck + 0.08), wide, on.paint)
    kit.add(BOX, (-long + 0.25, wide - 0.05, 0.6), (0.24, 0.05, 0.2), material=on.paint, mirror=True)
    post = np.array([rng.uniform(-1.5, -1.3), 0, floor])
    kit.add(CYL, post + [0, 0, 0.04], (0.4, 0.4, 0.05), material=on.steel)
    arm = rng.choice(["heavy", "twin", "rockets", "recoilless"])
    lift = rng.uniform(0, 35)
    frame, pivot = turn("y", -lift), post + [0, 0, rng.uniform(0.85, 1.05)]
    kit.between(post, pivot, 0.09, taper=0.6, material=on.steel)
    if arm == "heavy":
        machine_gun(kit, pivot - [0, 0, 0.3], on, kit.chance(0.6), rng.uniform(1.2, 1.5), min(lift, 20))
    elif arm == "twin":
        kit.add(BOX, pivot, (0.3, 0.34, 0.09), rotation=frame, material=on.paint)
        for y in (0.12, 0.24)[: int(rng.integers(1, 3))]:
            kit.add(CYL, pivot + frame @ np.array([0.75, y, 0.05]), (0.03, 0.03, 0.75), rotation=frame @ ALONG_X, material=on.dark, mirror=True)
            kit.add(CYL, pivot + frame @ np.array([1.48, y, 0.05]), (0.05, 0.05, 0.08), rotation=frame @ ALONG_X, material=on.dark, mirror=True)
        kit.add(BOX, pivot + [0, 0.42, 0], (0.2, 0.1, 0.15), material=on.steel, mirror=True)
        kit.add(BOX, pivot + [-0.55, 0, -0.28], (0.15, 0.2, 0.04), material=on.dark)
        kit.between(pivot + [-0.5, 0, -0.3], pivot - [0, 0, 0.4], 0.04, material=on.steel)
    elif arm == "rockets":
        rows, cols = int(rng.integers(2, 4)), int(rng.integers(3, 5))
        for i in range(rows):
            for j in range(cols):
                at = pivot + frame @ np.array([0.1, (j - (cols - 1) / 2) * 0.17, 0.1 + i * 0.17])
                kit.add(CYL, at, (0.08, 0.08, 0.75), rotation=frame @ ALONG_X, material=on.steel)
        kit.add(BOX, pivot, (0.5, cols * 0.085 + 0.04, 0.04), rotation=frame, material=on.dark)
    else:
        kit.add(CYL, pivot + frame @ np.array([0.2, 0, 0.08]), (0.07, 0.07, 1.35), rotation=frame @ ALONG_X, material=on.cloth)
        kit.add(CYL, pivot + frame @ np.array([-1.0, 0, 0.08]), (0.13, 0.13, 0.22), rotation=frame @ ALONG_X, material=on.cloth)
        kit.add(BOX, pivot + [0, 0.12, 0.08], (0.15, 0.06, 0.09), material=on.dark)
    lamps(kit, long - 0.04, -long, wide, 0.88, 0.1)
    kit.add(BOX, (long - 0.04, 0, 0.88), (0.06, wide * 0.45, 0.09), material=on.dark)
    span(kit, (long - 0.1, long + 0.06), (0.5, 0.68), wide * 0.98, on.dark)
    mirrors(kit, 0.72, wide * 0.95, deck + 0.12, on)
    kit.add(BOX, (0.05, wide, 0.78), (0.01, 0.01, 0.3), material=on.dark, mirror=True)


def load(bed, on_front=0.15):
    """Half length and middle of what a lorry may carry behind its cab."""
    return (bed.front - on_front - bed.rear) / 2, (bed.front - on_front + bed.rear) / 2


def bed_look(kit, bed):
    return look(kit, bed.paint)._replace(dark=bed.dark, steel=bed.steel)


def cargo(kit):
    """Cargo lorries on four to eight wheels with a tilt, dropsides, benches or a container."""
    rng = kit.rng
    count = int(rng.choice([2, 3, 3, 4]))
    bed = lorry(kit, count, (2.9, 3.6, 4.4)[count - 2] * rng.uniform(0.95, 1.1), rng.choice(["over", "bonnet", "bonnet"] if count < 4 else ["over", "low"]))
    on, (half, middle) = bed_look(kit, bed), load(bed)
    x, deck, wide = (middle - half, middle + half), bed.deck, bed.wide
    kind = rng.choice(["tilt", "tilt", "open", "frame", "container"])
    if kind == "container":
        base = kit.material(pattern=RIBS, frequency=rng.uniform(14, 26)) if kit.chance(0.6) else bed.paint._replace(pattern=RIBS, frequency=18)
        span(kit, x, (deck, deck + 2.3), wide * 0.98, base)
        for z in (deck + 0.06, deck + 2.26):
            span(kit, (x[0] - 0.02, x[1] + 0.02), (z - 0.06, z + 0.06), wide, base._replace(pattern=PLAIN))
        for at in (x[0], x[1]):
            kit.add(BOX, (at, wide * 0.95, deck + 1.15), (0.07, 0.07, 1.15), material=base._replace(pattern=PLAIN), mirror=True)
        for y in (0.15, 0.5):
            kit.between((x[0] - 0.03, y * wide, deck + 0.1), (x[0] - 0.03, y * wide, deck + 2.2), 0.03, material=bed.steel, mirror=True)
    else:
        side = rng.uniform(0.4, 0.6)
        board = bed.paint if kit.chance(0.6) else kit.material(base=bed.paint.first, pattern=RIBS, frequency=9)
        kit.add(BOX, (middle, wide * 0.96, deck + side / 2), (half, 0.04, side / 2), material=board, mirror=True)
        span(kit, (x[0], x[0] + 0.06), (deck, deck + side), wide, board)
        span(kit, (x[1] - 0.06, x[1]), (deck, deck + side * 1.5), wide, board)
        if kind == "tilt":
            canvas(kit, x, (deck + side - 0.02, deck + rng.uniform(1.7, 2.1)), wide * 0.97, on)
            kit.add(BOX, (x[0] - 0.01, 0, deck + side + 0.45), (0.02, wide * 0.75, 0.42), material=on.dark)
        elif kind == "frame":
            for at in np.linspace(x[0] + 0.05, x[1] - 0.05, int(rng.integers(3, 6))):
                kit.between((at, wide * 0.95, deck + 0.1), (at, wide * 0.95, deck + 1.6), 0.03, material=bed.steel, mirror=True)
                kit.between((at, -wide * 0.97, deck + 1.6), (at, wide * 0.97, deck + 1.6), 0.03, material=bed.steel)
        else:
            for at in np.linspace(x[0] + 0.6, x[1] - 0.6, 3):
                kit.add(BOX, (at, rng.uniform(-0.2, 0.2), deck + 0.35), (rng.uniform(0.3, 0.5), rng.uniform(0.4, 0.8), 0.35), material=timber(kit) if kit.chance(0.5) else on.cloth)
    trim(kit, bed)


def tanker(kit):
    """Fuel and water tankers with manholes, a walkway, hose boxes and a ladder."""
    rng = kit.rng
    count = int(rng.choice([2, 3, 3, 4]))
    bed = lorry(kit, count, (2.9, 3.6, 4.4)[count - 2])
    half, middle = load(bed)
    half *= 0.97
    tall, wide, skin = rng.uniform(0.6, 0.8), bed.wide * rng.uniform(0.85, 0.95), bed.paint if kit.chance(0.6) else kit.material(pattern=PLAIN, gloss=0.3)
    z = bed.deck + tall + 0.06
    kit.add(CYL, (middle, 0, z), (tall, wide, half), rotation=ALONG_X, material=skin)
    for x in np.linspace(middle - half * 0.97, middle + half * 0.97, int(rng.integers(3, 5))):
        kit.add(CYL, (x, 0, z), (tall * 1.02, wide * 1.02, 0.04), rotation=ALONG_X, material=skin)
        kit.add(BOX, (x, 0, bed.deck + 0.12), (0.08, wide * 0.8, 0.14), material=bed.dark)
    for x in np.linspace(middle - half * 0.6, middle + half * 0.6, 3):
        kit.add(CYL, (x, 0, z + tall + 0.03), (0.26, 0.26, 0.08), material=bed.steel)
    kit.add(BOX, (middle, 0, z + tall * 0.99), (half * 0.9, 0.4, 0.02), material=bed.dark)
    kit.railing((middle - half * 0.9, 0.4, z + tall * 0.92), (middle + half * 0.9, 0.4, z + tall * 0.92), 0.4, bed.steel, 0.5, GRID)
    kit.add(BOX, (middle - half - 0.1, 0, bed.deck + 0.4), (0.2, wide * 0.7, 0.42), material=bed.paint)
    kit.add(BOX, (middle - half - 0.04, wide * 0.4, z + 0.2), (0.03, 0.2, tall + 0.1), material=bed.steel, cut=(RUNGS, 4, 0.2))
    kit.add(CYL, (middle, wide * 0.97, bed.deck + 0.3), (0.09, 0.09, half * 0.7), rotation=ALONG_X, material=bed.dark, mirror=True)
    if kit.chance(0.5):
        kit.add(BOX, (middle, wide * 0.99, z), (half * 0.4, 0.04, 0.16), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=14, second=[0.5, 0.03, 0.03]), mirror=True)
    trim(kit, bed)


def recovery(kit):
    """Recovery lorries with a slewing boom or a fixed jib, winch, stowage and a hook."""
    rng = kit.rng
    count = int(rng.choice([3, 3, 4]))
    bed = lorry(kit, count, (3.4, 4.2)[count - 3])
    half, middle = load(bed)
    kit.add(BOX, (middle, bed.wide * 0.75, bed.deck + 0.3), (half, bed.wide * 0.22, 0.3), material=bed.paint._replace(pattern=SEAMS, frequency=8), mirror=True)
    pivot = np.array([middle + half * rng.uniform(0.2, 0.75), 0, bed.deck])
    kit.add(CYL, pivot + [0, 0, 0.3], (0.5, 0.5, 0.32), material=bed.steel)
    kit.add(BOX, pivot + [0, 0, 0.85], (0.45, 0.4, 0.45), (0.7, 0.8), material=bed.paint)
    tip = pivot + [-half * rng.uniform(1.5, 2.1), 0, rng.uniform(1.3, 2.2)]
    root = pivot + [0.1, 0, 1.05]
    kit.between(root, tip, (0.18, 0.2), BOX, 0.75, bed.paint)
    kit.between(root + (tip - root) * 0.4, tip + (tip - root) * 0.12, (0.11, 0.13), BOX, 1, bed.steel)
    end = tip + (tip - root) * 0.12
    kit.between(pivot + [-0.35, 0, 0.6], root + (tip - root) * 0.5, 0.08, material=bed.steel)
    drop = rng.uniform(0.5, 0.9)
    kit.add(CYL, end, (0.17, 0.17, 0.14), rotation=ALONG_Y, material=bed.dark)
    kit.between(end, end - [0, 0, drop], 0.025, material=bed.dark)
    kit.add(BOX, end - [0, 0, drop], (0.08, 0.06, 0.14), material=flat(kit, [0.7, 0.5, 0.03]))
    kit.add(CYL, (bed.rear + 0.7, 0, bed.deck + 0.25), (0.22, 0.22, 0.4), rotation=ALONG_Y, material=bed.dark)
    kit.between((bed.rear + 0.15, 0, bed.deck - 0.15), (bed.rear - 0.75, 0, bed.deck - 0.35), (0.12, 0.14), BOX, material=bed.steel)
    kit.add(BOX, (bed.rear - 0.75, 0, bed.deck - 0.35), (0.1, 0.75, 0.1), material=bed.steel)
    kit.add(BOX, (bed.front - 0.05, 0, bed.deck + 1.5), (0.06, bed.wide * 0.8, 0.1), material=flat(kit, [0.8, 0.35, 0.02]))
    kit.add(BOX, (bed.front - 0.05, 0, bed.deck + 0.75), (0.05, bed.wide * 0.85, 0.75), material=bed.paint, cut=(GRID, 3, 0.25))
    trim(kit, bed)


def shelter(kit):
    """Lorries with an ambulance or workshop box."""
    rng = kit.rng
    bed = lorry(kit, 2, rng.uniform(2.7, 3.1))
    half, middle = load(bed)
    white = kit.chance(0.3)
    skin = flat(kit, [0.8, 0.8, 0.76]) if white else bed.paint
    tall = rng.uniform(1.8, 2.1)
    raked(kit, (middle - half, middle + half), (bed.deck, bed.deck + tall), bed.wide, 0, 0, rng.uniform(0.93, 1), skin)
    raked(kit, (middle - half - 0.02, middle + half + 0.02), (bed.deck + tall - 0.02, bed.deck + tall + 0.12), bed.wide * 0.95, 0.1, 0.1, 0.8, skin)
    red_cross(kit, middle, bed.wide, bed.deck + tall * 0.55, 0.45)
    glass = glazing(kit)
    kit.add(BOX, (middle - half - 0.01, 0.27, bed.deck + tall * 0.68), (0.03, 0.2, 0.22), material=glass, mirror=True)
    kit.add(BOX, (middle - half - 0.02, 0, bed.deck + tall * 0.5), (0.02, 0.01, tall * 0.48), material=bed.dark)
    kit.add(BOX, (middle + half * 0.7, bed.wide, bed.deck + tall * 0.7), (0.25, 0.03, 0.17), material=glass, mirror=True)
    kit.add(BOX, (middle - half - 0.15, 0, bed.deck - 0.25), (0.18, 0.5, 0.28), material=bed.steel, cut=(RUNGS, 6, 0.3))
    kit.add(BOX, (middle + half - 0.1, 0, bed.deck + tall + 0.2), (0.2, 0.55, 0.12), material=flat(kit, [0.03, 0.06, 0.5], gloss=0.6) if white else bed.steel)
    trim(kit, bed)


def low_loader(kit):
    """A tractor with a low-loader that carries a tank's hull, some with its turret."""
    rng = kit.rng
    bed = lorry(kit, 3, 2.6, rng.choice(["over", "bonnet"]))
    wide, count, radius = bed.wide * 1.08, int(rng.integers(3, 5)), 0.36
    front, rear = bed.front - 0.6, -rng.uniform(8.6, 9.6)
    step = bed.rear - 0.35
    axles(kit, [rear + 0.6 + 0.82 * k for k in range(count)], wide, radius, bed.dark, bed.steel)
    deck = 0.95
    span(kit, (step, front), (bed.deck + 0.1, bed.deck + 0.42), wide * 0.5, bed.paint)
    kit.between((step + 0.2, 0, bed.deck + 0.25), (step - 0.6, 0, deck - 0.15), (0.18, wide * 0.5), BOX, material=bed.paint)
    span(kit, (rear, step - 0.3), (deck - 0.22, deck), wide, bed.paint)
    kit.add(BOX, (rear - 0.2, wide * 0.65, deck + 0.65), (0.07, wide * 0.25, 0.7), rotation=turn("y", rng.uniform(-10, 5)), material=bed.steel, mirror=True, cut=(RUNGS, 4, 0.5))
    armour, half = drab(kit), rng.uniform(2.3, 2.7)
    middle = (rear + step - 0.3) / 2
    top = deck + 0.85
    kit.add(BOX, (middle, wide * 0.82, deck + 0.42), (half, 0.24, 0.42), (0.86, 1), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=14, second=[0.12] * 3), mirror=True)
    for x in np.linspace(-0.65, 0.65, 4) * half:
        kit.add(CYL, (middle + x, wide * 0.86, deck + 0.3), (0.3, 0.3, 0.24), rotation=ALONG_Y, material=armour, mirror=True)
    raked(kit, (middle - half * 0.98, middle + half), (deck + 0.4, top + 0.25), wide * 0.95, 0.9, 0.1, 0.97, armour)
    span(kit, (middle - half * 0.9, middle + half * 0.9), (deck + 0.15, deck + 0.5), wide * 0.6, armour)
    if kit.chance(0.7):
        kit.add(CYL, (middle, 0, top + 0.27), (0.85, 0.8, 0.05), material=bed.dark)
        kit.add(BOX, (middle - 0.1, 0, top + 0.55), (1.2, 0.9, 0.28), (0.75, 0.8), material=armour)
        kit.between((middle - 1.0, 0, top + 0.5), (middle - 3.0, 0, top + 0.6), 0.08, material=armour)
        kit.add(CYL, (middle, 0.3, top + 0.86), (0.26, 0.26, 0.08), material=armour)
    else:
        kit.add(BOX, (middle, 0, top + 0.3), (half * 0.35, wide * 0.5, 0.1), (0.9, 0.9), material=bed_look(kit, bed).cloth)
    trim(kit, bed)


def amphibious(kit):
    """Amphibious lorries: a boat's hull with a raised prow over six or four wheels."""
    rng, on = kit.rng, look(kit)
    wide, long, radius = rng.uniform(1.15, 1.3), rng.uniform(4.0, 4.7), rng.uniform(0.46, 0.52)
    xs = (long * 0.45, -long * 0.33, -long * 0.33 - 2.2 * radius) if kit.chance(0.75) else (long * 0.45, -long * 0.42)
    running(kit, xs, wide - 0.18, radius, 0.15, on)
    low, mid, deck = 0.5, 1.05, rng.uniform(1.55, 1.75)
    kit.add(BOX, (-0.2, 0, (low + mid) / 2 + 0.02), (long * 0.86, wide * 0.62, (mid - low) / 2 + 0.04), (0.88, 0.9), rotation=turn("x", 180), material=on.paint)
    kit.add(BOX, (-0.25, 0, (mid + deck) / 2), (long - 0.25, wide, (deck - mid) / 2), (0.94, 0.98), (0, 0), rotation=turn("x", 180), material=on.paint)
    bow = rng.uniform(0.7, 1.1)
    kit.add(BOX, (long - bow * 0.72, 0, deck - 0.27), (0.38, wide * 0.98, bow), (0.25, 0.55), (0.2, 0), rotation=ALONG_X, material=on.paint)
    kit.add(BOX, (-0.1, wide, deck - 0.06), (long * 0.93, 0.05, 0.05), material=on.dark, mirror=True)
    front = long * 0.32
    kit.between((front, wide * 0.8, deck - 0.02), (front - 0.18, wide * 0.8, deck + 0.68), 0.035, BOX, material=on.paint, mirror=True)
    kit.add(BOX, (front - 0.1, 0, deck + 0.36), (0.012, wide * 0.8, 0.33), rotation=turn("y", -14), material=on.glass)
    kit.add(BOX, (front - 0.18, 0, deck + 0.69), (0.04, wide * 0.84, 0.04), material=on.paint)
    raked(kit, (front - 1.3, front - 0.1), (deck - 0.02, deck + 0.35), wide * 0.85, 0.4, 0, 0.95, on.dark)
    end = -long * 0.72
    if kit.chance(0.6):
        canvas(kit, (end, front - 0.12), (deck - 0.02, deck + rng.uniform(0.7, 1.05)), wide * 0.86, on)
    else:
        kit.add(BOX, ((end + front - 1.2) / 2, wide * 0.85, deck + 0.12), ((front - 1.2 - end) / 2, 0.04, 0.15), material=on.paint, mirror=True)
        span(kit, (end, front - 1.2), (deck - 0.02, deck + 0.03), wide * 0.8, on.dark)
        span(kit, (end, end + 0.08), (deck - 0.02, deck + 0.27), wide * 0.85, on.paint)
        raked(kit, (front - 1.35, front - 0.12), (deck + 0.62, deck + 0.72), wide * 0.82, 0.05, 0.05, 0.9, on.cloth)
        kit.between((front - 1.3, wide * 0.78, deck), (front - 1.3, wide * 0.78, deck + 0.64), 0.03, material=on.dark, mirror=True)
    kit.add(CYL, (-long * 0.9, 0, 0.72), (0.3, 0.3, 0.05), rotation=ALONG_X, material=on.steel, cut=(SPOKES, 4, 0.35))
    kit.between((-long * 0.9, 0, 0.72), (-long * 0.6, 0, 0.75), 0.05, material=on.steel)
    kit.between((-long * 0.93, 0, 0.6), (-long * 0.93, 0, deck - 0.1), (0.03, 0.12), BOX, material=on.dark)
    kit.add(CYL, (long * 0.75, wide * 0.5, deck + 0.1), (0.1, 0.1, 0.1), rotation=ALONG_X, material=flat(kit, [0.8, 0.8, 0.7]), mirror=True)
    kit.add(BOX, (long * 0.55, 0, deck + 0.03), (0.4, 0.45, 0.04), material=on.paint)
    spare(kit, (-long * 0.83, 0, deck + 0.12), radius * 0.95, 0.12, on, np.eye(3))
    kit.add(BOX, (long * 0.1, wide, 1.3), (0.3, 0.02, 0.13), material=kit.material(base=on.paint.first, pattern=WRITING, frequency=20, second=[0.8] * 3), mirror=True)


def buggy(kit):
    """Light strike buggies: a cage of tubes on four open wheels with a gun above."""
    rng, on = kit.rng, look(kit)
    wide, long, radius = rng.uniform(0.75, 0.9), rng.uniform(1.75, 2.0), rng.uniform(0.38, 0.46)
    tube = flat(kit, on.paint.first if kit.chance(0.6) else [0.03] * 3, gloss=0.3)
    running(kit, (long * 0.72, -long * 0.68), wide, radius, 0.15, on)
    floor, rail, roof, inner = 0.42, 0.88, rng.uniform(1.55, 1.7), wide * 0.72
    span(kit, (-0.75, 0.85), (floor - 0.04, floor), inner, on.dark)
    raked(kit, (0.6, long), (floor, 0.86), inner * 0.72, 0.35, 0, 0.75, on.paint)
    kit.add(BOX, (-long * 0.68, 0, 0.68), (0.42, 0.32, 0.22), (0.85, 0.85), material=on.steel)
    kit.between((long * 0.95, inner * 0.6, 0.55), (0.5, inner, rail), 0.03, material=tube, mirror=True)
    kit.between((0.5, inner, rail), (-long, inner * 0.9, rail), 0.03, material=tube, mirror=True)
    kit.between((0.8, inner, floor), (-0.75, inner, floor), 0.03, material=tube, mirror=True)
    kit.between((0.8, inner, floor), (0.5, inner, rail), 0.03, material=tube, mirror=True)
    kit.between((-0.75, inner, floor), (-long, inner * 0.9, rail), 0.03, material=tube, mirror=True)
    kit.between((0.5, inner, rail), (0.2, inner * 0.9, roof), 0.03, material=tube, mirror=True)
    kit.between((0.2, inner * 0.9, roof), (-0.7, inner * 0.9, roof), 0.03, material=tube, mirror=True)
    kit.between((-0.7, inner * 0.9, roof), (-0.75, inner, floor), 0.03, material=tube, mirror=True)
    kit.between((-0.7, inner * 0.9, roof), (-long, inner * 0.9, rail), 0.03, material=tube, mirror=True)
    for x in (0.2, -0.7):
        kit.between((x, -inner * 0.9, roof), (x, inner * 0.9, roof), 0.03, material=tube)
    kit.between((-long, -inner * 0.9, rail), (-long, inner * 0.9, rail), 0.03, material=tube)
    kit.add(BOX, (-0.2, inner * 0.5, 0.55), (0.26, 0.22, 0.13), material=on.cloth, mirror=True)
    kit.add(BOX, (-0.5, inner * 0.5, 0.88), (0.06, 0.22, 0.32), rotation=turn("y", -14), material=on.cloth, mirror=True)
    if kit.chance(0.7):
        machine_gun(kit, (-0.68, 0, roof), on, False)
        kit.between((-0.7, 0, 0.45), (-0.7, 0, roof), 0.045, material=tube)
    kit.add(CYL, (long * 0.85, inner * 0.35, 0.82), (0.09, 0.09, 0.06), rotation=ALONG_X, material=flat(kit, [0.8, 0.8, 0.7]), mirror=True)
    kit.add(CYL, (0.28, inner * 0.5, 0.92), (0.17, 0.17, 0.02), rotation=turn("y", -55), material=on.dark, cut=(SPOKES, 3, 0.2))
    kit.between((0.28, inner * 0.5, 0.92), (0.62, inner * 0.5, 0.75), 0.02, material=on.dark)
    spare(kit, (-long * 0.72, 0, rail + 0.12), radius * 0.9, 0.12, on, np.eye(3))


def riot(kit):
    """Police vans with grilles and lorries with water cannon."""
    rng = kit.rng
    colour = [[0.8, 0.8, 0.78], [0.03, 0.06, 0.2], [0.05, 0.05, 0.06], [0.05, 0.2, 0.1], [0.15, 0.25, 0.4]][rng.integers(5)]
    on = look(kit, flat(kit, colour, gloss=0.3))
    blue, mesh = flat(kit, [0.02, 0.08, 0.7], gloss=0.6), flat(kit, [0.04] * 3)
    stripe = kit.material(base=[0.8, 0.75, 0.1] if kit.chance(0.5) else [0.75] * 3, pattern=rng.choice([PLAIN, STRIPES]), frequency=8, second=[0.03, 0.08, 0.4])
    cannon = kit.chance(0.5)
    wide = 1.25 if cannon else rng.uniform(0.98, 1.08)
    long = rng.uniform(3.8, 4.4) if cannon else rng.uniform(2.6, 3.0)
    radius = 0.55 if cannon else 0.36
    sill, waist = radius * 1.0, radius * 2 + 0.05
    roof = rng.uniform(2.9, 3.2) if cannon else rng.uniform(2.3, 2.6)
    belt = waist + (roof - waist) * 0.45
    xs = (long - 1.2, -long + 1.3, -long + 1.3 + radius * 2.2)[: int(rng.integers(2, 4)) if cannon else 2]
    running(kit, xs, wide - 0.16, radius, 0.15, on)
    raked(kit, (-long, long), (waist - 0.05, belt), wide, 0.1 if cannon else 0.55, 0, 1, on.paint)
    span(kit, (-long + 0.1, long - 0.15), (sill - 0.05, waist), wide * 0.62, on.dark)
    ahead, behind = xs[0] - radius * 1.12, max(xs[1:]) + radius * 1.12
    span(kit, (behind, ahead), (sill, waist), wide, on.paint)
    span(kit, (xs[0] + radius * 1.1, long - 0.02), (sill, waist), wide * 0.99, on.paint)
    span(kit, (-long, min(xs) - radius * 1.1), (sill, waist), wide * 0.99, on.paint)
    nose = long if cannon else long - 0.5
    cab = nose - (1.9 if cannon else 1.5)
    top = roof - (0.25 if cannon else 0)
    raked(kit, (cab if cannon else -long, nose), (belt - 0.02, top), wide, 0.2 if cannon else 0.6, 0, 0.93, on.paint)
    pane = (top - belt) * 0.36
    kit.add(BOX, (nose - (0.1 if cannon else 0.3), 0, (belt + top) / 2), (0.06, wide * 0.85, pane), shift=(-0.12 if cannon else -0.42, 0), material=on.glass)
    kit.add(BOX, (nose - (0.03 if cannon else 0.2), 0, (belt + top) / 2), (0.02, wide * 0.87, pane * 1.05), shift=(-0.12 if cannon else -0.42, 0), material=mesh, cut=(GRID, 9, 0.25))
    side = (cab + 0.25, nose - 0.75) if cannon else (-long + 0.4, nose - 0.8)
    raked(kit, side, (belt + 0.08, top - 0.14), wide * 0.98, 0.1, 0, 0.96, on.glass)
    kit.add(BOX, (sum(side) / 2, wide * 0.99, (belt + top) / 2 - 0.03), ((side[1] - side[0]) / 2, 0.015, pane), material=mesh, mirror=True, cut=(GRID, 8, 0.2))
    if cannon:
        raked(kit, (-long, cab + 0.02), (belt - 0.03, roof), wide, 0, 0.2, 0.9, on.paint)
        for x, y in ((nose - 0.7, wide * 0.5), (-long * 0.2, wide * 0.5))[: int(rng.integers(1, 3))]:
            z = top if x > cab else roof
            kit.add(CYL, (x, y, z + 0.15), (0.13, 0.13, 0.18), material=on.steel, mirror=True)
            kit.between((x - 0.15, y, z + 0.36), (x + 0.75, y, z + 0.5), 0.075, taper=0.6, material=on.steel, mirror=True)
        kit.add(BOX, (-long * 0.5, wide, belt + 0.2), (long * 0.3, 0.03, 0.2), material=kit.material(base=on.paint.first, pattern=RIBS, frequency=20), mirror=True)
        if kit.chance(0.5):
            kit.add(BOX, (long + 0.4, 0, 0.55), (0.06, wide * 1.1, 0.42), rotation=turn("y", -12), material=on.steel)
            kit.between((long + 0.38, wide * 0.5, 0.6), (long - 0.3, wide * 0.5, 0.75), 0.09, BOX, material=on.dark, mirror=True)
    else:
        kit.add(BOX, (-long - 0.01, 0.48, belt + 0.35), (0.02, 0.36, 0.27), material=on.glass, mirror=True)
        kit.add(BOX, (-long - 0.01, 0, (waist + roof) / 2), (0.02, 0.012, (roof - waist) * 0.45), material=on.dark)
        span(kit, (long - 0.02, long + 0.14), (sill, waist + 0.1), wide * 0.8, on.dark, cut=(GRID, 6, 0.3))
    kit.add(BOX, (nose - (0.9 if cannon else 1.1), 0, top + 0.07), (0.13, wide * 0.75, 0.08), material=blue)
    kit.add(BOX, (-0.1, wide + 0.005, belt - 0.17), (long - 0.5, 0.01, 0.11), material=stripe, mirror=True)
    lamps(kit, long - 0.03, -long, wide, waist + 0.15, 0.12)
    span(kit, (long - 0.1, long + 0.1), (sill, sill + 0.2), wide * 0.97, on.dark)
    mirrors(kit, nose - 0.3, wide, belt + 0.25, on)
    kit.add(BOX, (0.3, wide + 0.008, belt + 0.0), (0.012, 0.01, (belt - waist) * 0.9), material=on.dark, mirror=True)
    plates(kit, long + 0.1, -long - 0.01, sill + 0.12)


def track(kit, y, x, radius, half, on):
    """A tracked running gear on both sides from x[0] to x[1]."""
    belt = kit.material(base=[0.03] * 3, pattern=RIBS, frequency=24, second=[0.1] * 3)
    kit.add(BOX, (sum(x) / 2, y, radius), ((x[1] - x[0]) / 2, half, radius), material=belt, mirror=True)
    for at in x:
        kit.add(CYL, (at, y, radius), (radius, radius, half), rotation=ALONG_Y, material=belt, mirror=True)
        kit.add(CYL, (at, y + 0.01, radius), (radius * 0.6, radius * 0.6, half), rotation=ALONG_Y, material=on.rim, mirror=True)


def robot(kit):
    """Bomb-disposal robots on tracks or wheels with an arm, a gripper and cameras; unmanned carriers and weapon stations."""
    rng, on = kit.rng, look(kit, kit.material(base=[0.75, 0.5, 0.03]) if kit.chance(0.2) else None)
    bomb = kit.chance(0.6)
    size = 1.0 if bomb else rng.uniform(2, 2.6)
    long, wide, radius = 0.45 * size, 0.3 * size, rng.uniform(0.11, 0.15) * size
    tracked = kit.chance(0.7 if bomb else 0.5)
    if tracked:
        track(kit, wide, (-long, long), radius, 0.07 * size, on)
        if bomb and kit.chance(0.6):
            way, far = rng.choice([1, -1]), np.array([rng.uniform(0.2, 0.42), 0, rng.uniform(0.0, 0.35)])
            root = np.array([way * long, wide + 0.11, radius])
            tip = root + far * [way, 1, 1]
            kit.between(root, tip, (radius * 0.6, 0.04), BOX, 0.7, on.dark, mirror=True)
            kit.add(CYL, root, (radius * 0.8, radius * 0.8, 0.045), rotation=ALONG_Y, material=on.dark, mirror=True)
            kit.add(CYL, tip, (radius * 0.5, radius * 0.5, 0.045), rotation=ALONG_Y, material=on.dark, mirror=True)
    else:
        running(kit, np.linspace(-1, 1, int(rng.integers(2, 4))) * long * 0.95, wide, radius * 1.2, 0.07 * size, on)
    deck = radius * 2 + 0.08 * size
    span(kit, (-long * 0.95, long * 0.95), (radius * 0.7, deck), wide * 0.82, on.paint, (0.95, 0.95))
    if bomb:
        base = np.array([rng.uniform(-0.25, 0.1), 0, deck])
        kit.add(CYL, base + [0, 0, 0.05], (0.12, 0.12, 0.07), material=on.dark)
        elbow = base + [-rng.uniform(0.15, 0.35), 0, rng.uniform(0.45, 0.7)]
        hand = elbow + [rng.uniform(0.6, 0.85), 0, rng.uniform(-0.3, 0.15)]
        kit.between(base + [0, 0, 0.05], elbow, (0.05, 0.06), BOX, 0.8, on.paint)
        kit.add(CYL, elbow, (0.075, 0.075, 0.09), rotation=ALONG_Y, material=on.dark)
        kit.between(elbow, hand, (0.04, 0.045), BOX, 0.8, on.paint)
        kit.add(CYL, hand, (0.05, 0.05, 0.07), rotation=ALONG_Y, material=on.dark)
        kit.add(BOX, hand + [0.08, 0, 0], (0.06, 0.07, 0.03), material=on.steel)
        kit.between(hand + [0.1, 0.05, 0], hand + [0.19, 0.09, 0], (0.015, 0.02), BOX, material=on.steel, mirror=True)
        kit.between(hand + [0.19, 0.09, 0], hand + [0.29, 0.03, 0], (0.015, 0.02), BOX, material=on.steel, mirror=True)
        mast = np.array([-long * 0.7, wide * 0.5, deck])
        kit.between(mast, mast + [0, 0, 0.62], 0.025, material=on.steel)
        kit.add(BOX, mast + [0.03, 0, 0.64], (0.08, 0.1, 0.06), material=on.dark)
        kit.add(CYL, mast + [0.1, 0, 0.64], (0.045, 0.045, 0.03), rotation=ALONG_X, material=on.glass)
        kit.add(BOX, elbow + [0.15, 0, 0.1], (0.08, 0.05, 0.05), material=on.dark)
        kit.add(BOX, (-long * 0.6, 0, deck + 0.05), (0.14, 0.18, 0.07), material=on.dark)
        if kit.chance(0.5):
            kit.between(elbow + [0.1, -0.09, 0.03], elbow + [0.55, -0.09, 0.03], 0.035, material=on.steel)
            kit.add(BOX, elbow + [0.1, -0.05, 0.02], (0.05, 0.06, 0.03), material=on.steel)
        kit.add(BOX, (long * 0.95, wide * 0.4, deck - 0.07), (0.03, 0.05, 0.04), material=flat(kit, [0.85, 0.85, 0.8]), mirror=True)
        kit.between((-long * 0.85, -wide * 0.6, deck), (-long * 0.9, -wide * 0.6, deck + 0.75), 0.008, material=on.dark)
        return
    kind = rng.choice(["weapon", "cargo", "scout"])
    kit.add(BOX, (0, wide * 0.98, deck + 0.03), (long * 1.1, wide * 0.35, 0.05), material=on.paint, mirror=True)
    if kind == "weapon":
        kit.add(CYL, (0, 0, deck + 0.08), (0.4, 0.4, 0.1), material=on.dark)
        kit.add(BOX, (0, 0, deck + 0.36), (0.36, 0.24, 0.22), (0.8, 0.9), material=on.paint)
        kit.between((0.1, 0, deck + 0.4), (1.3, 0, deck + 0.48), 0.045, material=on.steel)
        kit.add(BOX, (0.05, 0.36, deck + 0.4), (0.32, 0.13, 0.16), material=on.paint)
        kit.add(BOX, (0.1, -0.36, deck + 0.42), (0.3, 0.12, 0.12), material=on.paint)
        kit.add(BALL, (-0.1, 0, deck + 0.68), (0.15, 0.15, 0.16), material=on.dark)
    elif kind == "cargo":
        kit.railing((-long, wide * 1.2, deck), (long, wide * 1.2, deck), 0.4, on.steel, 0.3, GRID)
        kit.railing((-long, -wide * 1.2, deck), (long, -wide * 1.2, deck), 0.4, on.steel, 0.3, GRID)
        for x in np.linspace(-0.6, 0.6, 3) * long:
            kit.add(BOX, (x, 0, deck + 0.22), (0.25, wide * rng.uniform(0.5, 0.9), rng.uniform(0.18, 0.35)), material=on.cloth if kit.chance(0.5) else kit.material())
    else:
        kit.add(BOX, (-long * 0.3, 0, deck + 0.2), (long * 0.5, wide * 0.75, 0.22), (0.8, 0.85), material=on.paint)
        kit.between((0.1, 0, deck), (0.1, 0, deck + 1.3), 0.06, taper=0.7, material=on.steel)
        kit.add(BALL, (0.1, 0, deck + 1.4), (0.2, 0.2, 0.22), material=on.dark)
        kit.add(CYL, (0.27, 0, deck + 1.42), (0.09, 0.09, 0.06), rotation=ALONG_X, material=on.glass)
    kit.add(BOX, (long, 0, deck - 0.2), (0.06, wide * 0.6, 0.1), material=on.dark)
    kit.add(BOX, (long * 0.97, wide * 0.55, deck - 0.05), (0.06, 0.1, 0.06), material=flat(kit, [0.85, 0.85, 0.8]), mirror=True)
    whips(kit, -long * 0.9, wide * 0.8, deck + 0.05, on)


PATROLS = [utility, jeep, rover, protected, armoured_car, technical, cargo, tanker, recovery, shelter, low_loader, amphibious, buggy, riot, robot]
PATROL_SHARES = np.array([5, 3, 3, 3, 3, 2.5, 3.5, 2, 2, 1.5, 2, 1.5, 2, 3, 3])


def patrol(kit):
    """Utility trucks, jeeps, box-bodied off-roaders, mine-protected and armoured cars, technicals, service lorries, buggies, police vehicles, robots."""
    PATROLS[kit.rng.choice(len(PATROLS), p=PATROL_SHARES / PATROL_SHARES.sum())](kit)
