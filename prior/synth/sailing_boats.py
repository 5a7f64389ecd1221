"""Makers of sailing boats with open hulls: junks, dhows, luggers, proas."""

import numpy as np

from .boats import canvas, crew, timber
from .fittings import box, near, pick, rod
from .kit import ALONG_X, turn
from .layout import BARS, BOX, CYL
from .materials import BANDS, CLOUDY, PATCHWORK, PLAIN, SEAMS, STREAKS, STRIPES
from .roadcraft import slab


def sailing_boat(kit):
    """Junks with fanned sails, dhows and feluccas under great lateens, luggers, proas: planked open hulls, thin masts."""
    pick(kit, [junk, junk, dhow, dhow, open_lugger, open_lugger, proa])


def strakes(kit, stations, levels, skin, inside, thick=0.018):
    """An open hull of planks that flare: stations (x, half width, rim's height, keel's height); levels: (share of the height, share of the width)."""
    for (t0, f0), (t1, f1) in zip(levels[:-1], levels[1:], strict=True):
        for (xa, wa, ha, ka), (xb, wb, hb, kb) in zip(stations[:-1], stations[1:], strict=True):
            low = [np.array([xa, wa * f0, ka + (ha - ka) * t0]), np.array([xb, wb * f0, kb + (hb - kb) * t0])]
            high = [np.array([xa, wa * f1, ka + (ha - ka) * t1]), np.array([xb, wb * f1, kb + (hb - kb) * t1])]
            panel(kit, low, high, thick, skin)
    for (xa, wa, ha, ka), (xb, wb, hb, kb) in zip(stations[:-1], stations[1:], strict=True):
        rod(kit, (xa, wa, ha), (xb, wb, hb), thick * 1.6, inside, True, BOX)
        t, f = levels[1]
        low_a, low_b = ka + (ha - ka) * t * 0.9, kb + (hb - kb) * t * 0.9
        if min(wa, wb) > 0.05 or max(wa, wb) > 0.1:
            kit.between((xa, 0, low_a), (xb, 0, low_b), (0.012, max(wa, wb) * f * 0.85), BOX, material=inside)
        rod(kit, (xa, 0, ka), (xb, 0, kb), (0.03, 0.025), inside, kind=BOX)


def panel(kit, low, high, thick, material):
    """A flat board between two edges, and its twin on the other side."""
    start, end = (low[0] + high[0]) / 2, (low[1] + high[1]) / 2
    rise = (high[0] - low[0] + high[1] - low[1]) / 2
    z = (end - start) / np.linalg.norm(end - start)
    rise = rise - (rise @ z) * z
    x = rise / np.linalg.norm(rise)
    tall = [max(abs((high[k] - low[k]) @ x), 0.02) for k in (0, 1)]
    frame = np.stack([x, np.cross(z, x), z], 1)
    kit.add(BOX, (start + end) / 2, (tall[0] / 2 * 1.04, thick, np.linalg.norm(end - start) / 2), (tall[1] / tall[0], 1), rotation=frame, material=material, mirror=True)


def cloth_triangle(kit, a, b, c, cloth, thin=0.01):
    """A sail's part with the edge from a to b and the corner c."""
    corners = np.array([a, b, c], float)
    a, b, c = corners + (corners - corners.mean(0)) * 0.05
    along = (b - a) / np.linalg.norm(b - a)
    reach = c - (a + b) / 2
    shift = reach @ along
    across = reach - shift * along
    deep = np.linalg.norm(across)
    frame = np.stack([along, np.cross(across / deep, along), across / deep], 1)
    kit.add(BOX, (a + b) / 2 + across / 2, (np.linalg.norm(b - a) / 2, thin, deep / 2), (0.02, 1), (shift, 0), frame, cloth)


def boat_hull(kit, long, wide, high, bow, stern, skin, inside, rake=0.0, transom=0.75, draft=0.0):
    """Stations and strakes of an open boat whose ends rise to `bow` and `stern`; a flat transom, thwarts, rudder."""
    stations = [
        (-long, wide * transom, stern, 0.12 * high + draft),
        (-long * 0.45, wide * 0.98, high + (stern - high) * 0.25, 0.0),
        (long * 0.25, wide * 0.95, high * 1.02, 0.0),
        (long * 0.7, wide * 0.6, high + (bow - high) * 0.4, 0.05 * high),
        (long * (1 + rake), 0.03, bow, bow * (0.25 + 0.8 * rake)),
    ]
    strakes(kit, stations, [(0.0, 0.1), (0.28, 0.72), (0.62, 0.93), (1.0, 1.0)], skin, inside)
    back = stations[0]
    if transom > 0.2:
        slab(kit, back[3], stern, (-long - 0.02, -long + 0.02, wide * transom * 0.35), (-long - 0.02, -long + 0.02, wide * transom), skin)
    for x in (-0.5, 0.0, 0.4):
        box(kit, (x * long, 0, high * 0.72), (0.09, wide * (0.88 if x < 0.3 else 0.75), 0.018), inside)
    box(kit, (-long - 0.1, 0, stern * 0.42), (0.1, 0.02, stern * 0.42), inside, taper=(0.6, 1))
    rod(kit, (-long - 0.1, 0, stern * 0.86), (-long + 0.5, 0.05, stern * 1.02), 0.02, inside)


def boat_colours(kit):
    skin = timber(kit) if kit.chance(0.6) else near(kit, (0.75, 0.73, 0.68), (0.05, 0.25, 0.3), (0.03, 0.08, 0.2), (0.4, 0.05, 0.04), (0.04, 0.04, 0.04), (0.1, 0.25, 0.12), pattern=STREAKS)
    return skin, timber(kit, 0.7, 1.8), timber(kit, 0.8, 1.8)


def tanned(kit):
    """Sailcloth: tanned red or brown, ochre, white, patched."""
    if kit.chance(0.4):
        return canvas(kit)
    return near(kit, (0.4, 0.07, 0.03), (0.5, 0.25, 0.07), (0.65, 0.48, 0.25), (0.75, 0.7, 0.58), (0.22, 0.1, 0.05), pattern=kit.rng.choice([PLAIN, CLOUDY, SEAMS, PATCHWORK, STRIPES]), frequency=kit.rng.uniform(5, 12))


def junk(kit):
    """Fanned sails of panels between battens on two or three masts."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.4, 3.2), rng.uniform(0.6, 0.8), rng.uniform(0.5, 0.65)
    boat_hull(kit, long, wide, high, high * rng.uniform(1.3, 1.7), high * rng.uniform(1.5, 2.1), skin, inside, transom=0.8)
    if kit.chance(0.6):
        kit.add(CYL, (-long * 0.35, 0, high * 0.9), (high * 0.75, wide * 0.75, long * 0.2), rotation=ALONG_X, material=near(kit, (0.4, 0.3, 0.15), (0.2, 0.13, 0.07), pattern=BANDS, frequency=14))
    cloth, swing = tanned(kit), rng.uniform(-0.35, 0.35)
    masts = [(0.72, 0.62), (0.05, 1.0), (-0.82, 0.5)] if kit.chance(0.55) else [(0.55, 0.72), (-0.1, 1.0)]
    tall = long * rng.uniform(1.35, 1.65)
    for share, size in masts:
        top, count = tall * size, 5 if len(masts) == 2 else 4 if size == 1 else 3
        foot = np.array([share * long, 0, high * 1.35])
        rod(kit, foot * [1, 1, 0.3], foot + [0.05 * top, 0, top * 1.08], 0.032 * size + 0.012, spar)
        out = np.array([-np.cos(swing), np.sin(swing), 0])
        side = foot + [0, 0.06, 0]
        lifts = top * (np.linspace(0, 1, count + 1) ** 0.9) * 0.66
        tilts = np.radians(np.linspace(2, 52, count + 1) + rng.uniform(-3, 3))
        lengths = top * np.interp(np.linspace(0, 1, count + 1), [0, 0.5, 0.8, 1], [0.55, 0.66, 0.62, 0.5]) * rng.uniform(0.9, 1.0)
        luff = [side - out * top * 0.11 * (1 - k / count * 0.6) + [0, 0, z] for k, z in enumerate(lifts)]
        leech = [p + n * (out * np.cos(a) + [0, 0, np.sin(a)]) for p, n, a in zip(luff, lengths, tilts, strict=True)]
        for k in range(count):
            cloth_triangle(kit, luff[k], leech[k], leech[k + 1], cloth)
            cloth_triangle(kit, leech[k + 1], luff[k + 1], luff[k], cloth)
        for start, end in zip(luff, leech, strict=True):
            rod(kit, start, end, 0.022, spar)


def dhow(kit):
    """One or two lateens on long bent yards, low bow far out, open waist."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.4, 3.4), rng.uniform(0.55, 0.75), rng.uniform(0.42, 0.55)
    boat_hull(kit, long, wide, high, high * rng.uniform(1.5, 2.2), high * rng.uniform(1.2, 1.8), skin, inside, rake=rng.uniform(0.05, 0.25), transom=rng.choice([0.05, 0.6, 0.75]))
    cloth, side = tanned(kit), rng.choice([-1, 1])
    for share, size in [(0.12, 1.0)] if kit.chance(0.55) else [(0.3, 1.0), (-0.6, 0.62)]:
        tall, x = long * rng.uniform(1.1, 1.35) * size, share * long
        rod(kit, (x, 0, 0.05), (x + tall * 0.1, 0, high + tall), 0.045, spar)
        sling = np.array([x + tall * 0.09, side * 0.06, high + tall * 0.93])
        steep = np.radians(rng.uniform(42, 62))
        yard = np.array([-np.cos(steep), 0, np.sin(steep)])
        low, peak = sling - yard * tall * 0.98, sling + yard * tall * rng.uniform(0.75, 1.0)
        low[2] = max(low[2], high * 1.2)
        middle = (low + peak) / 2 + [0.03 * tall, 0, 0.03 * tall]
        rod(kit, low, middle, 0.028, spar)
        rod(kit, middle, peak, 0.024, spar)
        clew = np.array([x - tall * rng.uniform(0.75, 0.95), side * rng.uniform(0.2, 0.8) * wide, high * rng.uniform(1.5, 2.2)])
        belly = (middle + clew) / 2 + [0, side * 0.08 * tall, 0]
        for a, b, c in ((low, middle, belly), (middle, peak, belly), (low, belly, clew), (belly, peak, clew)):
            cloth_triangle(kit, a, b, c, cloth)
        rod(kit, clew, (x - tall * 0.95, side * wide * 0.5, high), 0.008, spar)
        rod(kit, sling, (x - tall * 0.25, wide * 0.9, high), 0.008, spar, True)
    if kit.chance(0.5):
        crew(kit, (-0.75 * long, 0.05, high), (0.1, 0.22, 0.12), (0.3, 0.12, -0.25), 0.8)


def open_lugger(kit):
    """Open boats with one to three four-cornered lugsails, a bowsprit and a jib."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.0, 3.0), rng.uniform(0.6, 0.8), rng.uniform(0.42, 0.55)
    bow = high * rng.uniform(1.15, 1.5)
    boat_hull(kit, long, wide, high, bow, high * rng.uniform(1.05, 1.3), skin, inside, transom=rng.choice([0.05, 0.65, 0.8]))
    cloth, side = tanned(kit), rng.choice([-1, 1])
    masts = {1: [(0.3, 1.0)], 2: [(0.5, 1.0), (-0.75, 0.6)], 3: [(0.62, 0.85), (-0.02, 1.0), (-0.9, 0.5)]}[int(rng.choice([1, 2, 2, 3]))]
    for share, size in masts:
        tall, x = long * rng.uniform(1.1, 1.35) * size, share * long
        deep = tall * rng.uniform(0.55, 0.7) if len(masts) < 3 else min(tall * 0.6, long * 0.62)
        rake = tall * rng.uniform(-0.06, 0.04)
        rod(kit, (x, 0, 0.05), (x + rake, 0, high + tall), 0.038, spar)
        swing = side * rng.uniform(0.1, 0.5)
        out = np.array([-np.cos(swing), np.sin(swing), 0])
        at = np.array([x, side * 0.05, high * 1.35])
        tack, clew = at - out * deep * 0.22, at + out * deep * 0.85 + [0, 0, rng.uniform(0, 0.15)]
        throat, peak = at - out * deep * 0.15 + [rake, 0, tall * 0.66], at + out * deep * 0.68 + [rake, 0, tall * rng.uniform(0.95, 1.12)]
        belly = (tack + clew + throat + peak) / 4 + [0, side * 0.06 * tall, 0]
        for a, b in ((tack, clew), (clew, peak), (peak, throat), (throat, tack)):
            cloth_triangle(kit, a, b, belly, cloth)
        rod(kit, throat - (peak - throat) * 0.05, peak + (peak - throat) * 0.05, 0.026, spar)
        if kit.chance(0.5):
            rod(kit, tack, clew, 0.022, spar)
        rod(kit, (x + rake, 0, high + tall * 0.97), (x - 0.15, wide * 0.9, high), 0.008, spar, True)
    if kit.chance(0.5):
        x, tall = masts[0][0] * long, long * 0.95 * masts[0][1]
        tip = np.array([long * rng.uniform(1.25, 1.5), 0, bow + 0.15])
        rod(kit, (long * 0.6, 0, bow * 0.95), tip, 0.028, spar)
        cloth_triangle(kit, tip, (x, 0, high + tall), (x + 0.15, side * 0.3, high * 1.5), cloth if kit.chance(0.6) else tanned(kit))
    if kit.chance(0.45):
        crew(kit, (-0.6 * long, 0.1, high), (0.1, 0.22, 0.12), (0.3, 0.12, -0.25), 0.8)


def proa(kit):
    """Outrigger canoes under a crab-claw sail."""
    rng = kit.rng
    skin, inside, spar = boat_colours(kit)
    long, wide, high = rng.uniform(2.2, 3.0), rng.uniform(0.22, 0.3), rng.uniform(0.35, 0.45)
    end = high * rng.uniform(1.3, 2.0)
    stations = [(-long, 0.03, end, end * 0.5), (-long * 0.6, wide * 0.8, high * 1.1, 0.05), (0, wide, high, 0), (long * 0.6, wide * 0.8, high * 1.1, 0.05), (long, 0.03, end, end * 0.5)]
    strakes(kit, stations, [(0.0, 0.15), (0.4, 0.85), (1.0, 1.0)], skin, inside)
    out = rng.choice([-1, 1]) * rng.uniform(1.2, 1.8)
    for y in (out, -out)[: 1 if kit.chance(0.65) else 2]:
        rod(kit, (-long * 0.65, y, 0.1), (long * 0.6, y, 0.1), 0.075, inside)
        kit.add(CYL, (long * 0.68, y, 0.14), (0.075, 0.075, long * 0.09), (0.3, 1), rotation=turn("y", 75), material=inside)
        for x in (-0.35, 0.3):
            rod(kit, (x * long, -np.sign(y) * wide, high * 1.05), (x * long, y * 0.8, high * 1.05), 0.028, spar)
            rod(kit, (x * long, y * 0.78, high * 1.05), (x * long, y, 0.12), 0.026, spar)
    if kit.chance(0.4):
        box(kit, (0, out * 0.35, high * 1.1), (long * 0.25, abs(out) * 0.3, 0.02), inside, cut=(BARS, 10, 0.7))
    cloth, tall = tanned(kit), long * rng.uniform(0.95, 1.2)
    rod(kit, (0.1 * long, 0, 0.1), (0.16 * long, 0, high + tall * 0.8), 0.035, spar)
    tack = np.array([long * 0.62, 0.04, high * 1.35])
    head, foot = np.array([-long * 0.2, 0.05, high + tall * 1.3]), np.array([-long * 0.8, rng.uniform(-0.4, 0.4), high + tall * 0.45])
    arch = (tack + head) / 2 + [0.1 * long, 0, 0.08 * long]
    sag = (tack + foot) / 2 - [0, 0, 0.06 * long]
    hollow = (head + foot) / 2 * 0.72 + tack * 0.28
    for a, b in ((tack, arch), (arch, head), (foot, sag), (sag, tack)):
        cloth_triangle(kit, a, b, hollow, cloth)
        rod(kit, a, b, 0.024, spar)
    if kit.chance(0.5):
        crew(kit, (-0.6 * long, 0, high), (0.1, 0.2, 0.12), (0.3, 0.1, -0.2), 0.8)
