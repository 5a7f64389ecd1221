"""A maker of assault guns and tank destroyers: the gun straight out of a sloped front plate, no turret."""

import numpy as np

from .fittings import box, disc, near, rod
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, GRID, SPOKES
from .materials import CAMOUFLAGE, CLOUDY, DOTS, PLAIN, RIBS, SEAMS, STREAKS
from .roadcraft import slab
from .wheeled import coat

# Each kind: half length, half width, heights of belly, nose, sponson, deck and roof, then in shares of the half length where the
# glacis meets the deck, where the casemate's front stands and where it meets the roof, the same of its rear, then the roof's half
# width over the deck's, road wheels, their radius, the barrel's length and radius, and the mantlet.
KINDS = {
    "panther": (3.45, 1.64, 0.55, 1.0, 1.15, 1.85, 2.65, 0.62, 0.62, 0.27, -0.5, -0.38, 0.76, 8, 0.43, 4.4, 0.085, "pig"),
    "hetzer": (2.4, 1.3, 0.4, 0.85, 0.95, 1.3, 2.05, 0.6, 0.6, 0.1, -0.85, -0.45, 0.66, 4, 0.41, 2.4, 0.07, "pig"),
    "stug": (2.7, 1.46, 0.42, 0.9, 1.0, 1.35, 2.05, 0.6, 0.42, 0.3, -0.32, -0.25, 0.84, 6, 0.27, 2.3, 0.07, "box"),
    "soviet": (3.0, 1.5, 0.42, 1.0, 1.05, 1.45, 2.2, 0.62, 0.62, 0.28, -0.2, -0.15, 0.8, 5, 0.41, 4.2, 0.09, "ball"),
    "heavy": (3.4, 1.55, 0.46, 1.05, 1.1, 1.6, 2.45, 0.72, 0.62, 0.45, -0.2, -0.15, 0.82, 6, 0.28, 3.0, 0.12, "box"),
    "elefant": (3.3, 1.68, 0.5, 1.2, 1.25, 1.75, 2.85, 0.85, 0.1, 0.0, -0.98, -0.88, 0.72, 6, 0.38, 4.9, 0.09, "ball"),
    "swedish": (3.4, 1.65, 0.4, 0.85, 1.0, 1.35, 1.8, 0.3, 0.3, -0.15, -0.8, -0.6, 0.8, 4, 0.4, 3.9, 0.075, "collar"),
    "kanone": (3.1, 1.49, 0.44, 1.0, 1.1, 1.45, 2.05, 0.62, 0.62, 0.35, -0.45, -0.35, 0.8, 5, 0.33, 3.1, 0.07, "collar"),
}
SAND, OLIVE, EARTH, GREY = (0.42, 0.33, 0.17), (0.09, 0.13, 0.06), (0.2, 0.09, 0.05), (0.13, 0.14, 0.14)


def war_paint(kit):
    """Two coats that show the same ground, and the colour of the third: ambush, sand with green and brown, green, grey, winter white."""
    scheme = kit.rng.choice(["three", "three", "ambush", "green", "sand", "grey", "winter", "any"])
    if scheme == "any":
        return coat(kit), coat(kit), None
    first, second, third = {
        "three": (SAND, OLIVE, EARTH),
        "ambush": (SAND, OLIVE, EARTH),
        "green": (OLIVE, np.array(OLIVE) * 1.5, EARTH),
        "sand": (SAND, np.array(SAND) * 0.7, OLIVE),
        "grey": (GREY, np.array(GREY) * 1.4, EARTH),
        "winter": ((0.7, 0.7, 0.68), GREY, GREY),
    }[scheme]
    pattern = {"three": CAMOUFLAGE, "ambush": kit.rng.choice([CAMOUFLAGE, DOTS]), "winter": STREAKS}.get(scheme, kit.rng.choice([PLAIN, CLOUDY, CAMOUFLAGE]))
    frequency, light = kit.rng.uniform(5, 12), kit.rng.uniform(0.7, 1.4)
    coats = [kit.material(base=np.array(first) * light, second=np.array(other) * light, pattern=pattern, frequency=frequency, gloss=0.05) for other in (second, third)]
    return coats[0], coats[1], near(kit, third, gloss=0.05) if scheme in ("three", "ambush", "sand") else None


def assault_gun(kit):
    """Jagdpanther, Hetzer, StuG, SU-85 and SU-100, ISU, Elefant, S-tank and Kanonenjagdpanzer types."""
    rng = kit.rng
    long, wide, belly, nose, sponson, deck, roof, *edges, narrow, count, radius, barrel, bore, mantlet = KINDS[rng.choice(list(KINDS))]
    bend, foot, brow, heel, nape = (np.array(edges) + rng.normal(0, 0.012, 5)) * long
    foot = bend if edges[0] == edges[1] else min(foot, bend)
    barrel, narrow = barrel * rng.uniform(0.85, 1.15), narrow * rng.uniform(0.95, 1.05)
    upper, lower, third = war_paint(kit)
    dark, metal = kit.material(dark=True, pattern=PLAIN), near(kit, (0.12, 0.11, 0.1), (0.2, 0.14, 0.09), pattern=CLOUDY)
    belt = rng.uniform(0.24, 0.33)
    tracks(kit, long, wide - belt, belt, sponson, count, radius, lower, dark, metal)
    inner, shelf = wide - 2 * belt - 0.04, wide * 0.97
    slope = (bend - long) / (deck - nose)
    knee = long + slope * (sponson - nose)
    slab(kit, belly, nose, (-long * 0.9, long * 0.78, inner), (-long * 0.96, long, inner), lower)
    slab(kit, nose, sponson, (-long * 0.96, long, inner), (-long * 0.97, knee, inner), upper)
    slab(kit, sponson, deck, (-long * 0.97, knee, shelf), (-long * 0.93, bend, shelf * 0.96), upper)
    slab(kit, deck, roof, (heel, foot, shelf * 0.96), (nape, brow, shelf * narrow), upper)
    box(kit, ((knee - long) / 2, wide - belt, sponson - 0.01), ((knee + long) / 2, belt * 1.08, 0.02), lower, True)
    rod(kit, (knee, wide - belt, sponson), (long * 1.02, wide - belt, sponson - 0.12), (0.02, belt * 1.08), lower, True, BOX)
    share = rng.uniform(0.3, 0.5)
    y = rng.choice([0, 0, wide * 0.15])
    gun(kit, np.array([foot + (brow - foot) * share, y, deck + (roof - deck) * share]), roof - deck, barrel, bore, mantlet, upper, dark)
    if kit.chance(0.4):
        skirts(kit, long, wide, sponson, deck, upper if kit.chance(0.6) else lower, rng.choice(["plates", "low"]))
    if heel > -long * 0.7:
        grille = kit.material(base=upper.first, pattern=RIBS, frequency=30, second=[0.02] * 3)
        middle, half = (heel - long * 0.93) / 2, (heel + long * 0.93) / 2
        box(kit, (middle, inner * 0.62, deck + 0.015), (half * 0.6, inner * 0.34, 0.02), grille, True)
        box(kit, (middle, 0, deck + 0.02), (half * 0.7, inner * 0.2, 0.03), upper)
    on_roof(kit, nape, brow, wide * narrow, roof, upper, dark)
    if third is not None:
        patches(kit, foot, brow, heel, nape, shelf * 0.96, shelf * narrow, deck, roof, third)
    kit.between((-long * 0.95, inner * 0.5, sponson + 0.1), (-long * 1.04, inner * 0.5, sponson + 0.45), 0.09, material=metal, mirror=True)
    if kit.chance(0.6):
        lamp = np.array([knee - 0.15, wide - belt, sponson + 0.12])
        disc(kit, lamp, 0.1, 0.06, near(kit, (0.7, 0.7, 0.6), (0.05, 0.05, 0.05), gloss=0.5), kit.chance(0.5), ALONG_X)
    if kit.chance(0.5):
        at = np.array([foot + (brow - foot) * 0.45, -wide * 0.45, deck + (roof - deck) * 0.45])
        kit.add(BALL, at, (0.16,) * 3, material=upper)
        rod(kit, at, at + [0.45, 0, 0], 0.02, dark)
    for _ in range(int(rng.integers(0, 4))):
        x = rng.uniform(-0.85, -0.3) * long
        if kit.chance(0.5):
            rod(kit, (x, wide - belt, sponson + 0.06), (x + rng.uniform(0.5, 1.2), wide - belt, sponson + 0.06), 0.025, near(kit, (0.3, 0.2, 0.1)), True)
        else:
            box(kit, (x, wide - belt * 0.4, deck + 0.06), (rng.uniform(0.15, 0.4), belt * 0.4, 0.09), lower, kit.chance(0.5))


def tracks(kit, long, y, belt, top, count, radius, paint, dark, metal):
    """Road wheels in one row or two that overlap, sprocket, idler, and the links around them."""
    links = kit.material(base=metal.first * 0.6, pattern=RIBS, frequency=kit.rng.uniform(35, 55), second=metal.first * 0.2)
    lift, small, tread = 0.07, min(radius, 0.34), kit.chance(0.7)
    for k, x in enumerate(np.linspace(-0.62, 0.64, count) * long):
        near_row = count < 8 or k % 2 == 0
        half = belt * (0.8 if near_row else 0.45)
        disc(kit, (x, y, radius + lift), radius, half, dark if tread else paint, True, ALONG_Y)
        if near_row:
            disc(kit, (x, y, radius + lift), radius * 0.8, half * 1.08, paint, True, ALONG_Y)
            if count < 5:
                disc(kit, (x, y, radius + lift), radius * 0.3, half * 1.2, paint, True, ALONG_Y)
    raised, upper = top - 0.1 - small, top - 0.07
    front, rear = long * 0.97 - small, -long * 0.98 + small
    for x in (front, rear):
        disc(kit, (x, y, raised), small, belt * 0.85, paint, True, ALONG_Y)
        if x > 0:
            disc(kit, (x, y, raised), small * 0.75, belt * 0.95, metal, True, ALONG_Y, cut=(SPOKES, 8, 0.5))
    first, last = -0.62 * long - radius * 0.35, 0.64 * long + radius * 0.35
    run = [(front + small * 0.2, upper), (front + small + 0.03, raised), (last, 0.035), (first, 0.035), (rear - small - 0.03, raised), (rear - small * 0.2, upper)]
    run.append(run[0])
    for (x0, z0), (x1, z1) in zip(run[:-1], run[1:], strict=True):
        kit.between((x0, y, z0), (x1, y, z1), (0.035, belt), BOX, material=links, mirror=True)


def gun(kit, root, high, barrel, bore, mantlet, paint, dark):
    """The gun at `root` on the front plate with its mantlet, sleeve and muzzle brake."""
    rng = kit.rng
    lift, aside = rng.uniform(-3, 9) if mantlet != "collar" else rng.uniform(-2, 4), rng.uniform(-6, 6)
    aim = turn("z", aside) @ turn("y", -lift)
    along = aim @ np.array([1.0, 0, 0])
    frame = aim @ ALONG_X
    if mantlet == "pig":
        box(kit, root, (high * 0.3, high * 0.42, high * 0.3), paint, taper=(0.8, 0.85), rotation=turn("y", rng.uniform(25, 40)))
        kit.add(BALL, root + along * high * 0.2, (high * 0.42, high * 0.36, high * 0.36), rotation=aim, material=paint)
        kit.add(CYL, root + along * high * 0.62, (high * 0.3, high * 0.3, high * 0.3), (0.5, 1), rotation=frame, material=paint)
    elif mantlet == "box":
        box(kit, root, (high * 0.45, high * 0.5, high * 0.42), paint, taper=(0.85, 0.9))
        box(kit, root + along * high * 0.5, (high * 0.3, high * 0.28, high * 0.28), paint, rotation=aim)
    elif mantlet == "ball":
        kit.add(BALL, root, (high * 0.48,) * 3, material=paint)
        kit.add(CYL, root + along * high * 0.5, (high * 0.26, high * 0.26, high * 0.25), (0.75, 1), rotation=frame, material=paint)
    else:
        box(kit, root, (0.25, high * 0.5, high * 0.3), paint, taper=(0.6, 0.8))
        kit.add(CYL, root + along * 0.3, (bore * 2, bore * 2, 0.3), (0.8, 1), rotation=frame, material=paint)
    tip, step = root + along * barrel, rng.uniform(0.45, 0.6)
    kit.between(root, root + along * barrel * step, bore * 1.2, taper=0.9, material=paint)
    kit.between(root + along * barrel * step, tip, bore, taper=0.85, material=paint)
    brake = rng.choice(["double", "double", "slotted", "none", "extractor"])
    if brake == "double":
        for at, size in ((0.02, 1.55), (0.24, 1.75)):
            kit.between(tip + along * (at - 0.04), tip + along * (at + 0.1), bore * size, taper=1.1, material=paint)
        kit.between(tip - along * 0.05, tip + along * 0.34, bore * 1.1, material=dark)
    elif brake == "slotted":
        kit.between(tip - along * 0.1, tip + along * 0.4, (bore * 1.6, bore * 1.3), material=paint)
        kit.between(tip + along * 0.05, tip + along * 0.25, (bore * 0.6, bore * 1.5), BOX, material=dark)
    elif brake == "extractor":
        kit.between(root + along * barrel * 0.55, root + along * barrel * 0.68, bore * 1.8, material=paint)
    disc(kit, tip + along * (0.0 if brake in ("none", "extractor") else 0.4 if brake == "slotted" else 0.35), bore * 0.75, 0.006, dark, rotation=frame)


def skirts(kit, long, wide, low, high, paint, kind):
    """Plates along the sides, some of which may be lost; or strips over the upper run of the track."""
    if kind == "low":
        for x in (-0.6, -0.05, 0.5):
            box(kit, (x * long, wide + 0.03, low - 0.16), (long * 0.27, 0.012, 0.2), paint, True)
        return
    seamed = paint._replace(pattern=SEAMS) if paint.pattern == PLAIN else paint
    count, drop = 3, kit.rng.uniform(0.45, 0.7)
    for side in (-1, 1):
        for k in range(count):
            if kit.chance(0.87):
                x = (-0.78 + 1.5 * (k + 0.5) / count) * long
                box(kit, (x, side * (wide + 0.1), (low + high) / 2 + 0.05), (long * 0.246, 0.01, (high - low) / 2 + drop * 0.5), seamed, rotation=turn("x", -side * 4))
        rod(kit, (-0.78 * long, side * (wide + 0.06), high - 0.05), (0.72 * long, side * (wide + 0.06), high - 0.05), 0.02, paint)


def on_roof(kit, nape, brow, wide, roof, paint, dark):
    """Hatches, a cupola, periscopes, a shielded machine gun, an aerial."""
    rng = kit.rng
    side, long = rng.choice([-1, 1]), brow - nape
    cupola = np.array([nape + long * 0.55, side * wide * 0.5, roof])
    disc(kit, cupola + [0, 0, 0.06], 0.28, 0.1, paint, taper=0.9)
    disc(kit, cupola + [0, 0, 0.17], 0.24, 0.02, paint)
    disc(kit, (nape + long * 0.3, -side * wide * 0.45, roof + 0.015), 0.27, 0.025, paint)
    box(kit, (brow - long * 0.15, -side * wide * 0.5, roof + 0.06), (0.1, 0.13, 0.08), dark, taper=(0.7, 0.9))
    if kit.chance(0.4):
        at = np.array([nape + long * 0.45, -side * wide * 0.2, roof])
        rod(kit, at, at + [0, 0, 0.25], 0.025, dark)
        rod(kit, at + [-0.3, 0, 0.27], at + [0.7, 0, 0.29], 0.025, dark)
        if kit.chance(0.6):
            box(kit, at + [0.15, 0, 0.22], (0.012, 0.32, 0.2), paint, taper=(1, 0.7), rotation=turn("y", -15))
    if kit.chance(0.6):
        foot = np.array([nape + 0.08, rng.choice([-1, 1]) * wide * 0.8, roof - 0.05])
        rod(kit, foot, foot + [-0.15, 0, rng.uniform(0.9, 1.9)], 0.01, dark)
    if kit.chance(0.25):
        box(kit, (nape - 0.2, 0, roof - 0.25), (0.2, wide * 0.6, 0.16), dark, cut=(rng.choice([GRID, BARS]), 8, 0.4))


def patches(kit, foot, brow, heel, nape, low, high, deck, roof, third):
    """Spots of the third colour on the casemate's sides and front."""
    rng = kit.rng
    lean = np.degrees(np.arctan2(low - high, roof - deck))
    for side in (-1, -1, 1, 1):
        t = rng.uniform(0.3, 0.75)
        x = rng.uniform(heel + (nape - heel) * t + 0.35, foot + (brow - foot) * t - 0.35)
        half = (rng.uniform(0.2, 0.45), 0.015, rng.uniform(0.12, 0.25))
        kit.add(BALL, (x, side * (low + (high - low) * t), deck + (roof - deck) * t), half, rotation=turn("x", side * lean) @ turn("y", rng.uniform(-30, 30)), material=third)
    tilt = np.degrees(np.arctan2(foot - brow, roof - deck))
    for y in (-0.6, 0.6):
        t = rng.uniform(0.3, 0.7)
        half = (0.015, rng.uniform(0.15, 0.3), rng.uniform(0.15, 0.35))
        kit.add(BALL, (foot + (brow - foot) * t, y * high, deck + (roof - deck) * t), half, rotation=turn("y", -tilt), material=third)
