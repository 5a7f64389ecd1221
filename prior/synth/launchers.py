"""A maker of launchers and guns on lorries, and what it shares with those of sensors and munitions: lorries, paints, fins, missiles."""

from typing import NamedTuple

import numpy as np

from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BOX, CYL, GRID, LATTICE, TUBE
from .materials import CAMOUFLAGE, CLOUDY, PLAIN, PLANKS, RIBS, STREAKS, Material
from .wheeled import coat, glazing, lamps, plates

SERVICE = [[0.13, 0.15, 0.07], [0.09, 0.11, 0.06], [0.42, 0.34, 0.2], [0.1, 0.12, 0.1], [0.24, 0.25, 0.22], [0.2, 0.19, 0.1]]
PATCHES = [[0.03, 0.03, 0.03], [0.12, 0.07, 0.03], [0.05, 0.08, 0.03], [0.35, 0.28, 0.17]]


class Bed(NamedTuple):
    """A lorry or trailer under its load: x of its nose, behind the cab and at the rear; half width, deck's height, materials."""

    nose: float
    front: float
    rear: float
    wide: float
    deck: float
    paint: Material
    dark: Material
    steel: Material


def drab(kit):
    """Service paint, mostly plain or in patches of two colours; sometimes any."""
    rng = kit.rng
    if kit.chance(0.12):
        return coat(kit)
    pattern = rng.choice([PLAIN, PLAIN, CAMOUFLAGE, CAMOUFLAGE, CLOUDY, STREAKS])
    base = np.array(SERVICE[rng.integers(len(SERVICE))]) * rng.uniform(0.7, 1.6)
    return kit.material(base=base, pattern=pattern, frequency=rng.uniform(5, 14), second=PATCHES[rng.integers(len(PATCHES))], gloss=rng.uniform(0, 0.15))


def metal(kit, low=0.06, high=0.3):
    base = kit.rng.uniform(low, high) * np.ones(3)
    return kit.material(base=base, pattern=kit.rng.choice([PLAIN, PLAIN, CLOUDY, STREAKS]), second=base * [0.7, 0.55, 0.45])


def timber(kit):
    base = np.array([0.42, 0.29, 0.15]) * kit.rng.uniform(0.6, 1.4)
    return kit.material(base=base, pattern=PLANKS, frequency=kit.rng.uniform(8, 16), second=base * 0.5)


def axles(kit, places, wide, radius, dark, rim):
    """Two wheels and the hub between them at every x."""
    half = kit.rng.uniform(0.17, 0.23)
    for x in places:
        kit.add(CYL, (x, wide - half, radius), (radius, radius, half), rotation=ALONG_Y, material=dark, mirror=True)
        kit.add(CYL, (x, 0, radius), (radius * 0.55, radius * 0.55, wide + 0.02), rotation=ALONG_Y, material=rim)


def spread(count, first, last, radius):
    """Places of `count` axles: a pair before and a pair behind, or all along."""
    if count == 3:
        return [first, last + 2.25 * radius, last]
    if count == 4:
        return [first, first - 2.35 * radius, last + 2.35 * radius, last]
    return list(np.linspace(first, last, count))


def cab(kit, middle, half, wide, base, tall, paint, glass, y=0.0):
    """A cab around `middle` with a raked screen and side windows; with y: one on either side."""
    rng, pair = kit.rng, y > 0
    low = tall * rng.uniform(0.48, 0.56)
    high, rake, lean = tall - low, rng.uniform(0.02, 0.3), rng.uniform(0.9, 0.98)
    kit.add(BOX, (middle, y, base + low / 2), (half, wide, low / 2), material=paint, mirror=pair)
    taper = (1 - rake / (2 * half), lean)
    kit.add(BOX, (middle, y, base + low + high / 2), (half, wide, high / 2), taper, (-rake / 2, 0), material=paint, mirror=pair)
    z, pane = base + low + high * 0.5, high * 0.33
    screen = (middle + half - rake * 0.5 - 0.03, y if pair else wide * 0.44, z)
    kit.add(BOX, screen, (0.06, wide * (0.78 if pair else 0.4), pane), shift=(-rake * 0.66, 0), material=glass, mirror=True)
    kit.add(BOX, (middle - rake * 0.3, y, z), (half * rng.uniform(0.5, 0.72), wide * (1 + lean) / 2 + 0.035, pane * 0.95), (1, lean), material=glass, mirror=pair)


def lorry(kit, count, long, style=None):
    """A lorry of `count` axles, `long` half its length, without load. `style` of its cab: over, bonnet, low, split."""
    rng = kit.rng
    paint, dark, glass, steel = drab(kit), kit.material(dark=True, pattern=PLAIN), glazing(kit), metal(kit)
    heavy = count > 4
    wide, radius = (rng.uniform(1.4, 1.6), rng.uniform(0.62, 0.75)) if heavy else (rng.uniform(1.15, 1.3), rng.uniform(0.48, 0.6))
    style = style or rng.choice(["over", "over", "bonnet"])
    deck, base = 2 * radius + rng.uniform(0.1, 0.25), radius * 1.15
    half, tall = rng.uniform(0.75, 1.1), rng.uniform(1.75, 2.1)
    front, first = long - 2 * half, long - rng.uniform(1.1, 1.4)
    if style == "bonnet":
        hood = rng.uniform(0.5, 0.75)
        kit.add(BOX, (long - hood, 0, base + tall * 0.25), (hood + 0.03, wide * rng.uniform(0.6, 0.75), tall * 0.26), (0.97, 0.9), material=paint)
        kit.add(BOX, (long - hood, 0, base + 0.3), (hood + 0.02, wide * 0.96, 0.3), (0.9, 0.98), material=paint)
        front, first = front - 2 * hood, long - hood - 0.1
        cab(kit, front + half, half, wide * 0.97, base, tall, paint, glass)
    elif style == "split":
        cab(kit, front + half, half, wide * 0.28, base, tall * 0.95, paint, glass, wide * 0.68)
        kit.add(BOX, (front + half, 0, base + tall * 0.22), (half * 0.98, wide * 0.9, tall * 0.22), material=paint)
    else:
        cab(kit, front + half, half, wide * 0.97, base, tall * (0.72 if style == "low" else 1), paint, glass)
    rim = kit.material(base=paint.first, pattern=PLAIN) if kit.chance(0.7) else steel
    axles(kit, spread(count, first, -long + radius * rng.uniform(1.2, 2.0), radius), wide, radius, dark, rim)
    kit.add(BOX, (0, 0, deck - 0.22), (long - 0.1, wide * 0.45, 0.18), material=dark)
    kit.add(BOX, ((front - long) / 2, 0, deck - 0.04), ((front + long) / 2 + 0.02, wide * 0.98, 0.05), material=paint if kit.chance(0.6) else steel)
    kit.add(BOX, (long + 0.02, 0, deck - 0.42), (0.12, wide, 0.17), material=dark if kit.chance(0.5) else paint)
    return Bed(long, front, -long, wide, deck, paint, dark, steel)


def trim(kit, bed):
    """A lorry's small things: grille, lamps, plates, mirrors, tanks between the wheels."""
    kit.add(BOX, (bed.nose, 0, bed.deck - 0.02), (0.025, bed.wide * 0.45, 0.18), material=kit.material(base=[0.03] * 3, pattern=RIBS, frequency=30, second=[0.12] * 3))
    lamps(kit, bed.nose + 0.02, bed.rear - 0.02, bed.wide, bed.deck - 0.16, 0.1)
    kit.add(BOX, (bed.front + 0.5, bed.wide * 0.85, bed.deck - 0.35), (0.3, 0.18, 0.25), material=bed.paint, mirror=True)
    kit.add(BOX, (bed.front - 0.7, bed.wide * 0.8, bed.deck - 0.3), (0.45, 0.2, 0.25), material=bed.dark if kit.chance(0.5) else bed.paint, mirror=True)
    plates(kit, bed.nose + 0.13, bed.rear - 0.02, bed.deck - 0.33)


def trailer(kit, long):
    """A semi-trailer alone or a low four-wheeled one, on its legs. Returns its Bed."""
    rng = kit.rng
    paint, dark, steel = drab(kit), kit.material(dark=True, pattern=PLAIN), metal(kit)
    wide, radius = rng.uniform(1.1, 1.3), rng.uniform(0.42, 0.55)
    deck = 2 * radius + 0.2
    count = int(rng.integers(2, 4))
    axles(kit, [-long + radius * (1.3 + 2.2 * k) for k in range(count)], wide, radius, dark, steel)
    kit.add(BOX, (0, 0, deck - 0.12), (long, wide * 0.6, 0.14), material=paint)
    kit.add(BOX, (-0.1 * long, 0, deck - 0.02), (long * 0.9, wide * 0.96, 0.05), material=paint)
    if kit.chance(0.5):
        kit.add(BOX, (long * 0.86, 0, deck + 0.28), (long * 0.16, wide * 0.8, 0.3), material=paint)
    else:
        kit.between((long * 0.98, wide * 0.4, deck - 0.15), (long + 1.3, 0.03, deck - 0.3), 0.06, BOX, material=dark, mirror=True)
    outriggers(kit, (long * 0.6, -long * 0.9), wide * rng.uniform(1.2, 1.8), deck - 0.15, steel)
    return Bed(long, long * 0.7, -long, wide, deck, paint, dark, steel)


def outriggers(kit, places, reach, height, material):
    """Beams across at every x with a leg and a foot at either end."""
    for x in places:
        kit.add(BOX, (x, 0, height), (0.1, reach, 0.08), material=material)
        kit.between((x, reach - 0.06, height), (x, reach - 0.06, 0.03), 0.07, material=material, mirror=True)
        kit.add(CYL, (x, reach - 0.06, 0.03), (0.22, 0.22, 0.03), material=material, mirror=True)


def fins(kit, place, axis, span, chord, material, spin=45.0, taper=0.4, thick=0.02):
    """Four fins crossed about local z of `axis`, widest behind; `span` from the axis to their tips."""
    for k in (0, 90):
        kit.add(BOX, place, (span, thick, chord / 2), (taper, 1), rotation=axis @ turn("z", spin + k), material=material)


def missile(kit, tail, frame, long, radius, skin, tip, fin, sets=2, spin=None):
    """A slender body from `tail` along local x of `frame`: ogive, tail fins, and wings or foreplanes."""
    rng = kit.rng
    axis = frame @ ALONG_X
    out = axis[:, 2]
    ogive, spin = radius * rng.uniform(2.5, 5), rng.choice([0, 45]) if spin is None else spin
    kit.add(CYL, tail + out * (long - ogive) / 2, (radius, radius, (long - ogive) / 2), rotation=axis, material=skin)
    kit.add(BALL, tail + out * (long - ogive), (radius, radius, ogive), rotation=axis, material=tip)
    fins(kit, tail + out * long * 0.07, axis, radius * rng.uniform(2.2, 3.6), long * rng.uniform(0.07, 0.13), fin, spin, rng.uniform(0.4, 0.8))
    if sets > 1:
        place = rng.uniform(0.38, 0.62)
        chord = rng.choice([0.08, 0.3, 0.42]) * long
        fins(kit, tail + out * long * place, axis, radius * rng.uniform(2.2, 3.8), chord, fin, spin, rng.uniform(0.2, 0.5))
    kit.add(CYL, tail, (radius * 0.7, radius * 0.7, 0.04), rotation=axis, material=kit.material(dark=True))


def pack(kit, pivot, frame, start, long, rows, cols, size, bed, tubes, skin):
    """Canisters in rows along local x of `frame` from `start`, on two beams that lie on the pivot, held by collars."""
    rng = kit.rng
    cap = kit.material() if kit.chance(0.4) else bed.dark if kit.chance(0.5) else skin
    axis = frame @ ALONG_X
    end = np.array([1, 1, rng.uniform(0.04, 0.35)])
    for row in range(rows):
        for col in range(cols):
            y, z = (col - (cols - 1) / 2) * 2.06 * size, 0.14 + size * (1 + 2.06 * row)
            middle = pivot + frame @ np.array([start + long / 2, y, z])
            mouth = pivot + frame @ np.array([start + long, y, z])
            if tubes:
                kit.add(CYL, middle, (size, size, long / 2), rotation=axis, material=skin)
                kit.add(BALL, mouth, end * size * 0.97, rotation=axis, material=cap)
            else:
                kit.add(BOX, middle, (size, size, long / 2), rotation=axis, material=skin)
                kit.add(BOX, mouth, (size * 0.88, size * 0.88, 0.03), rotation=axis, material=cap)
    across, high = cols * 1.03 * size + 0.03, rows * 1.03 * size + 0.03
    for share in np.linspace(0.08, 0.9, int(rng.integers(2, 5))):
        kit.add(BOX, pivot + frame @ np.array([start + long * share, 0, 0.13 + high]), (0.06, across, high), rotation=frame, material=bed.paint)
    kit.add(BOX, pivot + frame @ np.array([start + long * 0.5, across * 0.55, 0.06]), (long * 0.48, 0.1, 0.1), rotation=frame, material=bed.steel)
    kit.add(BOX, pivot + frame @ np.array([start + long * 0.5, -across * 0.55, 0.06]), (long * 0.48, 0.1, 0.1), rotation=frame, material=bed.steel)


def turntable(kit, x, bed, rise, radius):
    """A ring on the deck with two cheeks up to the pivot, which it returns."""
    pivot = np.array([x, 0, bed.deck + rise])
    kit.add(CYL, (x, 0, bed.deck + 0.06), (radius, radius, 0.1), material=bed.steel)
    kit.add(BOX, (x, 0, bed.deck + rise / 2), (radius * 0.6, radius * 0.75, rise / 2 + 0.05), (0.6, 1), material=bed.paint)
    return pivot


def canister_launcher(kit):
    """Canisters, round or square, upright at the lorry's rear or raised on a turntable."""
    rng = kit.rng
    long = rng.uniform(3.8, 5.0)
    driven = kit.chance(0.7)
    bed = lorry(kit, int(rng.choice([3, 4, 4])), long) if driven else trailer(kit, long)
    tubes, skin = kit.chance(0.5), bed.paint if kit.chance(0.6) else drab(kit)
    rows, cols = [(1, 2), (2, 2), (2, 2), (2, 3), (1, 4), (2, 4)][rng.integers(6)]
    size = min(rng.uniform(0.3, 0.5), bed.wide / cols / 1.05, 0.85 / rows)
    if kit.chance(0.5):
        start, lift = -bed.deck * rng.uniform(0.6, 0.9), rng.choice([90, 90, 0])
        pivot = np.array([bed.rear - 0.1, 0, bed.deck + 0.12])
        reach = (bed.front - bed.rear) * rng.uniform(0.9, 1.0) - start
        frame = turn("y", -float(lift))
        kit.add(BOX, (bed.rear + 0.1, 0, bed.deck), (0.3, bed.wide * 0.5, 0.16), material=bed.steel)
    else:
        lift = rng.choice([rng.uniform(0, 12), rng.uniform(25, 60)])
        pivot = turntable(kit, bed.rear + rng.uniform(0.9, 1.6), bed, rng.uniform(0.3, 0.6), bed.wide * 0.7)
        reach = (bed.front - pivot[0]) * rng.uniform(0.95, 1.15)
        start = -min(0.2 * reach, 0.8)
        frame = turn("z", rng.choice([0, 0, 180, rng.uniform(-60, 60)]) if lift > 20 else 0) @ turn("y", -lift)
    pack(kit, pivot, frame, start, reach, rows, cols, size, bed, tubes, skin)
    if lift > 20:
        kit.between(pivot + frame @ np.array([reach * 0.35, 0, 0.05]), pivot + frame[:, 0] * [1, 1, 0] * min(reach * 0.3, 1.4) + [0.3, 0, -0.1], 0.08, material=bed.steel)
    if driven:
        if kit.chance(0.6):
            box = rng.uniform(0.35, 0.5)
            if lift == 90 or bed.rear + reach < bed.front - 1:
                kit.add(BOX, (bed.front - box - 0.1, 0, bed.deck + 0.55), (box, bed.wide * 0.9, 0.55), material=bed.paint)
            outriggers(kit, (bed.front - 0.25, bed.rear + 0.35), bed.wide * rng.uniform(1.0, 1.35), bed.deck - 0.25, bed.steel)
        trim(kit, bed)


def rail_launcher(kit):
    """Missiles with fins on open rails, on a turntable on the ground, a trailer or a lorry."""
    rng = kit.rng
    base = rng.choice(["ground", "trailer", "lorry"])
    if base == "ground":
        paint, steel = drab(kit), metal(kit)
        reach, deck = rng.uniform(1.4, 2.0), rng.uniform(0.35, 0.5)
        for x, y in around(4, reach, 45):
            kit.between((0, 0, deck - 0.1), (x, y, 0.12), (0.1, 0.14), BOX, 0.7, material=paint)
            kit.add(CYL, (x, y, 0.06), (0.25, 0.25, 0.06), material=steel)
        kit.add(CYL, (0, 0, deck / 2), (0.75, 0.75, deck / 2), material=paint)
        bed, place, count = Bed(reach, 0.8, -reach, 0.9, deck, paint, steel, steel), 0.0, int(rng.integers(1, 5))
    elif base == "trailer":
        bed = trailer(kit, rng.uniform(2.4, 3.2))
        place, count = bed.rear * 0.3, int(rng.integers(2, 4))
    else:
        bed = lorry(kit, int(rng.choice([3, 3, 4])), rng.uniform(3.4, 4.2))
        place, count = (bed.front + bed.rear) / 2 - 0.3, int(rng.choice([2, 2, 3]))
    pivot = turntable(kit, place, bed, rng.uniform(0.6, 0.9), 0.7)
    long = rng.uniform(3.2, 5.5) if base != "lorry" else rng.uniform(3.0, 4.2)
    radius = long * rng.uniform(0.028, 0.045) * (1.5 if count == 1 else 1)
    gap = max(radius * rng.uniform(4.5, 6.5), 0.55)
    lift = rng.uniform(8, 50)
    frame = turn("z", rng.choice([0, 0, 180, rng.uniform(-90, 90)])) @ turn("y", -lift)
    skin = kit.material(base=rng.choice([[0.75, 0.75, 0.72], [0.16, 0.18, 0.1], [0.35, 0.36, 0.36], [0.6, 0.55, 0.4]]), pattern=PLAIN, gloss=0.15)
    tip, fin = band(kit) if kit.chance(0.5) else skin, kit.material(base=rng.uniform(0.1, 0.7) * np.ones(3), pattern=PLAIN) if kit.chance(0.4) else skin
    kit.add(BOX, pivot + frame @ np.array([0.1, 0, 0.05]), (0.35, gap * (count - 1) / 2 + 0.15, 0.14), rotation=frame, material=bed.paint)
    behind = -0.36 * long if lift < 25 else -0.22 * long
    for k in range(count):
        y = (k - (count - 1) / 2) * gap
        kit.add(BOX, pivot + frame @ np.array([behind + long * 0.42, y, 0.18]), (long * 0.4, 0.07, 0.1), rotation=frame, material=bed.paint)
        missile(kit, pivot + frame @ np.array([behind, y, 0.28 + radius]), frame, long, radius, skin, tip, fin, int(rng.choice([1, 2, 2])))
    kit.between(pivot + [0, 0, -0.3], pivot + frame @ np.array([0.8, 0, 0.1]), 0.07, material=bed.steel)
    if base == "lorry":
        trim(kit, bed)


def ballistic_launcher(kit):
    """Transporter-erectors of eight to fourteen wheels with one long missile or tube, lying or raised."""
    rng = kit.rng
    count = int(rng.integers(4, 8))
    style = rng.choice(["split", "split", "low"])
    bed = lorry(kit, count, max(count * 0.88 + 1.2, 5.2), style)
    bare = style == "split" and kit.chance(0.6)
    size = min(bed.wide * rng.uniform(0.3, 0.36), 0.52) if style == "split" else bed.wide * rng.uniform(0.42, 0.58)
    low = size + (0.28 if style == "split" else rng.uniform(0.55, 0.75))
    pivot = np.array([bed.rear + 0.1, 0, bed.deck + low])
    lift = rng.choice([0, 0, rng.uniform(20, 80), 90, 90])
    frame = turn("y", -float(lift))
    axis = frame @ ALONG_X
    reach = (bed.nose - bed.rear) * rng.uniform(0.9, 1.04)
    start = -min(bed.deck * 0.75, 1.0) if lift < 30 or lift == 90 else -0.5
    skin = drab(kit) if kit.chance(0.6) else kit.material(base=rng.choice([[0.7, 0.7, 0.68], [0.3, 0.33, 0.3], [0.12, 0.15, 0.08]]), pattern=PLAIN)
    shift = frame @ np.array([0, 0, 0.0 if lift < 30 else low * 0.4])
    if bare:
        missile(kit, pivot + shift + axis[:, 2] * start, frame, reach - start, size * 0.85, skin, band(kit) if kit.chance(0.3) else skin, skin, 1)
    else:
        middle, half = pivot + shift + axis[:, 2] * (start + reach) / 2, (reach - start) / 2
        kit.add(CYL, middle, (size, size, half), rotation=axis, material=skin)
        cap, hoop = skin if kit.chance(0.6) else band(kit), bed.steel if kit.chance(0.3) else skin
        kit.add(BALL, pivot + shift + axis[:, 2] * reach, (size, size, size * rng.uniform(0.15, 1.0)), rotation=axis, material=cap)
        for share in np.linspace(0, 1, int(rng.integers(4, 8))):
            kit.add(CYL, pivot + shift + axis[:, 2] * (start + (reach - start) * share), (size * 1.06, size * 1.06, 0.07), rotation=axis, material=hoop)
    cradle = frame @ np.array([0, 0, -size * 0.8]) + shift
    web = (LATTICE, 2, 0.35) if kit.chance(0.3) else (0, 1, 1)
    for y in (-0.75, 0.75):
        kit.add(BOX, pivot + cradle + axis[:, 2] * reach * 0.4 + [0, y * size, 0], (reach * 0.42, 0.09, 0.16), rotation=frame, material=bed.paint, cut=web)
    kit.add(BOX, (bed.rear + 0.2, 0, bed.deck + low * 0.4), (0.25, size * 1.1, low * 0.5), material=bed.steel)
    if lift > 15:
        kit.between((bed.rear + reach * 0.3, size * 0.7, bed.deck), pivot + cradle + axis[:, 2] * reach * 0.38 + [0, size * 0.7, 0], 0.1, material=bed.steel, mirror=True)
    else:
        for x in (bed.rear + reach * 0.35, bed.front - 0.6):
            kit.add(BOX, (x, 0, bed.deck + low * 0.25), (0.2, size * 0.8, low * 0.3), material=bed.steel)
    back = bed.front - (bed.front - bed.rear) * rng.uniform(0.3, 0.55)
    tall = rng.uniform(0.3, 0.55)
    kit.add(BOX, ((bed.front + back) / 2, bed.wide * 0.7, bed.deck + tall), ((bed.front - back) / 2, bed.wide * 0.28, tall), (1, 0.9), material=bed.paint, mirror=True)
    kit.add(BOX, ((bed.rear + back) / 2 - 0.1, bed.wide * 0.78, bed.deck + 0.18), ((back - bed.rear) / 2 - 0.5, bed.wide * 0.2, 0.18), material=bed.paint, mirror=True)
    if lift > 15 or kit.chance(0.4):
        outriggers(kit, (bed.rear + 0.1,), bed.wide * 0.9, bed.deck - 0.25, bed.steel)
    trim(kit, bed)


def rocket_launcher(kit):
    """Blocks of tubes or boxes, raised and turned, on the rear of a lorry."""
    rng = kit.rng
    bed = lorry(kit, int(rng.choice([3, 3, 4])), rng.uniform(3.3, 4.6))
    rise = rng.uniform(0.35, 0.6)
    pivot = turntable(kit, bed.rear + (bed.front - bed.rear) * rng.uniform(0.2, 0.35), bed, rise, bed.wide * 0.7)
    lift, yaw = rng.choice([0, rng.uniform(15, 55), rng.uniform(15, 55)]), rng.choice([0, 0, 180, rng.uniform(-100, 100)])
    frame = turn("z", float(yaw) if lift > 0 else 0) @ turn("y", -float(lift))
    axis = frame @ ALONG_X
    long = (bed.front - bed.rear) * rng.uniform(0.6, 0.75)
    start = -0.28 * long if lift > 20 else -0.36 * long
    middle = pivot + frame @ np.array([start + long / 2, 0, 0])
    skin = bed.paint if kit.chance(0.6) else drab(kit)
    if kit.chance(0.55):
        rows, cols = [(3, 6), (3, 5), (2, 6), (4, 4), (3, 4)][rng.integers(5)]
        size = min(bed.wide * 0.86 / cols, 0.55 / rows)
        high = 2.05 * size * rows
        for row in range(rows):
            for col in range(cols):
                offset = np.array([0, (col - (cols - 1) / 2) * 2.05 * size, 0.14 + 2.05 * size * (row + 0.5)])
                kit.add(TUBE, middle + frame @ offset, (size, size, long / 2), rotation=axis, material=skin)
        across = 1.025 * size * cols
        kit.add(BOX, middle + frame @ np.array([0, 0, 0.14 + high / 2]), (long * 0.35, across * 0.99, high / 2 * 0.99), rotation=frame, material=bed.dark)
        for share in (-0.4, 0.3):
            kit.add(BOX, middle + frame @ np.array([long * share, 0, 0.14 + high / 2]), (0.06, across + 0.05, high / 2 + 0.05), rotation=frame, material=bed.paint)
    else:
        high, packs = rng.uniform(0.6, 0.9), int(rng.choice([1, 2, 2]))
        across = bed.wide * rng.uniform(0.45, 0.6) if packs == 1 else bed.wide * 0.9
        holes = (GRID, rng.uniform(2.8, 4), rng.uniform(0.25, 0.4))
        for k in range(packs):
            y, half = (k - (packs - 1) / 2) * across * 1.03, across / packs * 0.98
            centre = middle + frame @ np.array([0, y, 0.14 + high / 2])
            kit.add(BOX, centre, (long / 2, half, high / 2), rotation=frame, material=skin)
            for end in (-1, 1):
                face = centre + frame[:, 0] * end * long / 2
                kit.add(BOX, face, (0.02, half * 0.94, high * 0.46), rotation=frame, material=bed.dark)
                kit.add(BOX, face + frame[:, 0] * end * 0.03, (0.02, half * 0.97, high * 0.48), rotation=frame, material=skin, cut=holes)
            for share in (-0.6, 0.0, 0.6):
                kit.add(BOX, centre + frame[:, 0] * share * long / 2, (0.05, half + 0.03, high / 2 + 0.03), rotation=frame, material=bed.paint)
    kit.add(BOX, middle + frame @ np.array([-0.1, 0, 0.06]), (long * 0.42, across * 0.7, 0.1), rotation=frame, material=bed.steel)
    kit.between(pivot + [0, 0, 0.05 - rise], pivot + frame @ np.array([long * 0.25, 0, 0.05]), 0.08, material=bed.steel)
    if kit.chance(0.4):
        kit.add(BOX, (bed.front - 0.45, 0, bed.deck + 0.35), (0.3, bed.wide * 0.85, 0.35), material=bed.paint)
    if kit.chance(0.5):
        outriggers(kit, (bed.rear + 0.3,), bed.wide * rng.uniform(0.95, 1.2), bed.deck - 0.25, bed.steel)
    trim(kit, bed)


def coastal_launcher(kit):
    """Lorries with a cabin behind the cab and long containers that point backwards or sidewards."""
    rng = kit.rng
    bed = lorry(kit, 4, rng.uniform(4.4, 5.2), "over")
    cabin, tall = rng.uniform(0.5, 0.9), rng.uniform(0.7, 0.95)
    kit.add(BOX, (bed.front - cabin - 0.1, 0, bed.deck + tall), (cabin, bed.wide * 0.96, tall), material=bed.paint)
    kit.add(BOX, (bed.front - cabin - 0.1, bed.wide * 0.96, bed.deck + tall * 0.9), (0.35, 0.02, tall * 0.75), material=drab(kit), mirror=True)
    free = bed.front - 2 * cabin - 0.3 - bed.rear
    rows, cols = [(1, 2), (2, 2), (2, 4), (1, 4), (1, 3)][rng.integers(5)]
    size = min(bed.wide * 0.94 / cols, 0.42)
    lift = rng.uniform(8, 38)
    pivot = turntable(kit, bed.rear + free * 0.35, bed, rng.uniform(0.25, 0.45) + np.sin(np.radians(lift)) * free * 0.3, 0.6)
    frame = turn("z", rng.choice([180, 180, 90, -90])) @ turn("y", -lift)
    pack(kit, pivot, frame, -free * 0.48, free * 1.05, rows, cols, size, bed, kit.chance(0.5), bed.paint if kit.chance(0.6) else drab(kit))
    kit.between((pivot[0], 0, bed.deck), pivot + frame @ np.array([free * 0.3, 0, 0.05]), 0.09, material=bed.steel)
    outriggers(kit, (bed.rear + 0.3,), bed.wide * rng.uniform(0.95, 1.2), bed.deck - 0.25, bed.steel)
    trim(kit, bed)


def wheeled_howitzer(kit):
    """A long gun at the rear of a lorry, open with spades behind, or in a turret."""
    rng = kit.rng
    bed = lorry(kit, int(rng.choice([3, 3, 4, 4])), rng.uniform(3.7, 4.8))
    open_mount = kit.chance(0.65)
    lift = np.radians(rng.choice([rng.uniform(14, 20), rng.uniform(25, 65)]))
    aim = np.array([np.cos(lift), 0, np.sin(lift)])
    frame = turn("y", -np.degrees(lift))
    gun = rng.uniform(4.6, 6.8)
    bore = rng.uniform(0.09, 0.13)
    if open_mount:
        root = np.array([bed.rear + rng.uniform(0.5, 0.9), 0, bed.deck + 0.95])
        kit.add(CYL, (root[0], 0, bed.deck + 0.1), (0.75, 0.75, 0.14), material=bed.steel)
        kit.add(BOX, (root[0], 0.42, bed.deck + 0.6), (0.45, 0.1, 0.55), (0.5, 1), material=bed.paint, mirror=True)
        kit.add(BOX, root, (0.7, 0.32, 0.24), rotation=frame, material=bed.paint)
        kit.add(BOX, root - aim * 0.75, (0.35, 0.22, 0.22), rotation=frame, material=bed.steel)
        for y, z in ((0.0, 0.3), (0.2, -0.24), (-0.2, -0.24)):
            kit.between(root + frame @ np.array([-0.5, y, z]), root + frame @ np.array([rng.uniform(1.3, 1.9), y, z]), 0.09, material=bed.paint)
        kit.add(BOX, (bed.rear - 0.75, 0, 0.28), (0.09, bed.wide * 0.95, 0.28), (1, 0.9), (-0.1, 0), material=bed.steel)
        kit.between((bed.rear + 0.1, bed.wide * 0.5, bed.deck - 0.2), (bed.rear - 0.75, bed.wide * 0.6, 0.25), (0.09, 0.14), BOX, material=bed.paint, mirror=True)
        kit.between((bed.rear - 0.7, bed.wide * 0.3, 0.4), (bed.rear + 0.2, bed.wide * 0.3, bed.deck), 0.06, material=bed.steel, mirror=True)
        box = rng.uniform(0.3, 0.6)
        kit.add(BOX, (bed.front - 0.7, bed.wide * 0.7, bed.deck + box), (0.6, bed.wide * 0.28, box), material=bed.paint, mirror=True)
    else:
        x = bed.rear + (bed.front - bed.rear) * rng.uniform(0.3, 0.45)
        half, tall = rng.uniform(1.1, 1.5), rng.uniform(0.55, 0.75)
        root = np.array([x + half * 0.8, 0, bed.deck + 0.15 + tall])
        kit.add(CYL, (x, 0, bed.deck + 0.1), (bed.wide * 0.85, bed.wide * 0.85, 0.12), material=bed.dark)
        kit.add(BOX, (x, 0, bed.deck + 0.15 + tall), (half, bed.wide * 0.98, tall), (0.88, 0.85), material=bed.paint)
        kit.add(BOX, root, (0.5, 0.35, 0.3), (0.85, 0.85), rotation=frame, material=bed.paint)
        kit.add(CYL, (x - half * 0.3, bed.wide * 0.4, bed.deck + 0.2 + 2 * tall), (0.28, 0.28, 0.12), material=bed.paint)
        kit.add(BOX, (x, 0, bed.deck + 0.2 + tall), (0.4, bed.wide * 0.96, tall * 0.6), material=bed.steel)
        outriggers(kit, (bed.rear + 0.3, 0.0), bed.wide, bed.deck - 0.25, bed.steel)
        room = (bed.front - x - half) / 2 - 0.1
        if room > 0.2:
            kit.add(BOX, (bed.front - room, 0, bed.deck + 0.25), (room * 0.95, bed.wide * 0.9, 0.25), (0.95, 0.9), material=bed.paint)
    kit.between(root, root + aim * gun, bore * 1.25, taper=0.75, material=bed.paint)
    kit.between(root, root + aim * gun * 0.3, bore * 1.7, material=bed.paint)
    brake = rng.choice([BOX, CYL])
    for at in (0.0, 0.28):
        kit.between(root + aim * (gun + at - 0.05), root + aim * (gun + at + 0.15), bore * 1.7, brake, material=bed.steel)
    kit.between(root + aim * gun, root + aim * (gun + 0.4), bore * 1.1, material=bed.steel)
    if np.degrees(lift) < 21:
        kit.between((bed.front - 0.15, 0.3, bed.deck), root + aim * ((bed.front - 0.15 - root[0]) / aim[0]), 0.05, material=bed.steel, mirror=True)
    trim(kit, bed)


def bridge_layer(kit):
    """Lorries under a folded bridge of two treadways that stands out before and behind, lying or half raised."""
    rng = kit.rng
    style = rng.choice(["over", "low"])
    bed = lorry(kit, int(rng.choice([4, 4, 5])), rng.uniform(4.4, 5.4), style)
    half, deep, across = rng.uniform(0.8, 1.05) * bed.nose, rng.uniform(0.2, 0.32), bed.wide * rng.uniform(0.34, 0.42)
    layers = int(rng.integers(1, 3))
    metal_paint = bed.paint if kit.chance(0.5) else drab(kit)
    lift = rng.choice([0, 0, rng.uniform(30, 85)])
    pivot = np.array([bed.rear, 0, bed.deck + ((1.05 if style == "low" else 1.6) if lift == 0 else 0.5)])
    frame = turn("y", -float(lift))
    web = kit.material(base=metal_paint.first * 0.5, pattern=PLAIN)
    start = 2 * half * (0.06 if lift else rng.uniform(0.05, 0.15))
    for layer in range(layers):
        z = deep * (1.1 + 2.3 * layer)
        for y in (-1, 1):
            at = np.array([half - start, y * bed.wide * 0.58, z])
            kit.add(BOX, pivot + frame @ at, (half, across, deep), (1, 1), rotation=frame, material=metal_paint)
            for end in (-1, 1):
                tip = pivot + frame @ (at + [end * (half + 0.5), 0, 0])
                kit.add(BOX, tip, (deep, across, 0.52), (0.3, 1), (0, 0), rotation=frame @ turn("y", 90 * end), material=metal_paint)
            for side in (-1, 1):
                face = pivot + frame @ (at + [0, side * (across + 0.015), 0])
                kit.add(BOX, face, (half * 0.95, 0.02, deep * 0.85), rotation=frame, material=web, cut=(LATTICE, 1.6, 0.3))
    kit.add(BOX, pivot + frame @ np.array([half - start, 0, deep]), (half * 0.5, bed.wide * 0.5, 0.08), rotation=frame, material=bed.steel)
    if lift == 0:
        for x in (bed.rear + 0.5, bed.front - 0.5):
            kit.between((x, bed.wide * 0.5, bed.deck), (x, bed.wide * 0.5, pivot[2] + 0.1), (0.12, 0.1), BOX, material=bed.steel, mirror=True)
            kit.add(BOX, (x, 0, pivot[2] + 0.04), (0.15, bed.wide * 0.8, 0.08), material=bed.steel)
        kit.add(BOX, ((bed.front + bed.rear) / 2, 0, bed.deck + 0.3), (rng.uniform(0.8, 1.8), bed.wide * 0.8, 0.3), material=bed.paint)
    else:
        kit.add(BOX, (bed.rear + 0.1, 0, bed.deck + 0.35), (0.35, bed.wide * 0.7, 0.4), material=bed.steel)
        kit.between((bed.rear + half * 0.5, bed.wide * 0.3, bed.deck), pivot + frame @ np.array([half * 0.6, bed.wide * 0.3, 0.2]), 0.1, material=bed.steel, mirror=True)
    outriggers(kit, (bed.rear + 0.2,), bed.wide, bed.deck - 0.25, bed.steel)
    trim(kit, bed)


def launcher(kit):
    """Air-defence canisters and rails, ballistic and coastal missile lorries, rocket launchers, howitzers and bridges on lorries."""
    makers = [canister_launcher, rail_launcher, ballistic_launcher, rocket_launcher, coastal_launcher, wheeled_howitzer, bridge_layer]
    makers[kit.rng.choice(7, p=[0.2, 0.16, 0.18, 0.16, 0.1, 0.13, 0.07])](kit)


def band(kit):
    hue = [[0.75, 0.5, 0.03], [0.6, 0.05, 0.03], [0.7, 0.7, 0.65], [0.05, 0.05, 0.05], [0.3, 0.2, 0.08]][kit.rng.integers(5)]
    return kit.material(base=hue, pattern=PLAIN)
