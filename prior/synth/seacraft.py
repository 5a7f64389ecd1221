"""A maker of vessels: sail, war, trade and passenger ships, submarines, hovercraft, and small boats."""

import numpy as np

from .aircraft import propeller
from .boats import canoe, canvas, crew, inflatable, jet_ski, raft, skiff, timber, white_paint
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL, GRID, TUBE
from .materials import BANDS, CLOUDY, PATCHWORK, PLAIN, RIBS, SEAMS, STREAKS, STRIPES, paint
from .wheeled import glazing


def vessel_at_sea(kit):
    """Tall ships, yachts, dhows, junks, submarines, freighters, aircraft carriers, tugs, ferries, hovercraft, inflatables, canoes, rafts, jet skis, patrol boats, skiffs."""
    kit.rng.choice([tall_ship, yacht, lugger, submarine, freighter, flat_top, tug, liner, hovercraft, inflatable, canoe, raft, jet_ski, patrol_boat, skiff])(kit)


def hull(kit, long, wide, deck, topside, bottom, bow=0.22, rise=0.2, stern=0.85, draft=0.35):
    """A closed hull of half length `long` on its keel: red or black below, painted above, a bow that rises, a deck. Returns the shoulder's x."""
    shoulder, tip = long * (1 - 2 * bow), long * 2 * bow
    rake = tip * kit.rng.uniform(0.05, 0.3)
    for low, high, skin, share, lift in ((0, draft * deck, bottom, 0.94, 0), (draft * deck, deck, topside, 1, rise)):
        half, middle = (high - low) / 2, (high + low) / 2
        kit.add(BOX, ((shoulder - long * 0.85) / 2, 0, middle), ((shoulder + long * 0.85) / 2, wide * share * 0.97, half), (1, 1.03), material=skin)
        kit.add(BOX, (-long * 0.9, 0, middle + half * 0.05), (half * 0.95, wide * share * 0.98, long * 0.1), (0.85 if low else 0.6, stern), (-half * 0.15 if low else -half * 0.4, 0), turn("y", -90) @ turn("z", 180), skin)
        reach = tip - (0 if low else rake)
        x = shoulder
        for start, end, part, up in ((1, 0.74, 0.5, 0.4), (0.74, 0.03, 0.5, 1)):
            grow = 1 + lift * up
            before = 1 + lift * 0.4 * (up == 1)
            centre = (x + reach * part / 2, 0, low + half * (before + grow) / 2)
            kit.add(BOX, centre, (half * before, wide * share * start, reach * part / 2 + 0.01), (grow / before, end / start), (-half * (grow - before), 0), ALONG_X, skin)
            x += reach * part
    return shoulder


def sail(kit, x0, x1, top, z0, z1, cloth, ratio=0.03, y=0.0, thin=0.012):
    """A fore-and-aft sail: its foot from x0 to x1 at z0, its head around x = top at z1, `ratio` as long."""
    kit.add(BOX, ((x0 + x1) / 2, y, (z0 + z1) / 2), ((x1 - x0) / 2, thin, (z1 - z0) / 2), (ratio, 1), (top - (x0 + x1) / 2, 0), material=cloth)


def antifouling(kit):
    return kit.material(base=np.array([[0.35, 0.04, 0.03], [0.03, 0.03, 0.035], [0.03, 0.12, 0.1], [0.04, 0.06, 0.2]][kit.rng.integers(4)]), pattern=kit.rng.choice([PLAIN, STREAKS, CLOUDY]))


def navy(kit):
    base = np.array([0.3, 0.33, 0.36]) * kit.rng.uniform(0.5, 1.4)
    return kit.material(base=base, second=base * 0.75, pattern=kit.rng.choice([PLAIN, PLAIN, STREAKS, SEAMS]), gloss=0.05)


def ports(kit, frequency=45):
    """A strip of dark windows in a white wall."""
    return kit.material(base=[0.04, 0.06, 0.08], second=[0.75] * 3, pattern=STRIPES, frequency=frequency * kit.rng.uniform(0.7, 1.3), gloss=0.4)


def tall_ship(kit):
    """Brigs, barques, galleons: square sails set or furled on two to four masts, jibs, shrouds, a raised stern."""
    rng = kit.rng
    old = kit.chance(0.4)
    side, wood, spar, dark = timber(kit) if old or kit.chance(0.4) else kit.material(base=rng.choice([[0.03] * 3, [0.8] * 3, [0.03, 0.08, 0.12]]), pattern=PLAIN), timber(kit), timber(kit, 0.6, 1.5), kit.material(dark=True)
    long, wide, deck = rng.uniform(1.9, 2.4), rng.uniform(0.34, 0.45), rng.uniform(0.4, 0.55)
    hull(kit, long, wide, deck, side, dark if kit.chance(0.5) else antifouling(kit), rng.uniform(0.16, 0.22), rng.uniform(0.2, 0.5))
    band = white_paint(kit) if kit.chance(0.6) else kit.material(base=[0.6, 0.35, 0.05])
    kit.add(BOX, (-long * 0.15, 0, deck * 0.78), (long * 0.72, wide * 1.015, 0.035), material=band)
    if old:
        kit.add(BOX, (-long * 0.72, 0, deck + 0.12), (long * 0.26, wide * 0.95, 0.16), (0.95, 0.85), (-0.08, 0), material=side)
        kit.add(BOX, (-long * 0.86, 0, deck + 0.34), (long * 0.14, wide * 0.82, 0.12), (0.95, 0.9), (-0.06, 0), material=wood)
        kit.add(BOX, (long * 0.68, 0, deck + 0.14), (long * 0.12, wide * 0.68, 0.12), material=side)
    else:
        kit.add(BOX, (-long * 0.6, 0, deck + 0.06), (long * 0.2, wide * 0.5, 0.08), material=wood)
        kit.add(BOX, (long * 0.1, 0, deck + 0.05), (long * 0.13, wide * 0.4, 0.07), material=white_paint(kit))
    bowsprit = np.array([long * 1.0 + rng.uniform(0.5, 0.8), 0, deck + rng.uniform(0.35, 0.6)])
    kit.between((long * 0.82, 0, deck + 0.1), bowsprit, 0.03, taper=0.5, material=spar)
    masts = {2: [0.42, -0.25], 3: [0.5, 0.0, -0.52], 4: [0.58, 0.2, -0.2, -0.6]}[int(rng.choice([2, 3, 3, 4]))]
    rows = 3 if len(masts) > 2 else int(rng.integers(3, 5))
    tall, cloth, yaw = rng.uniform(2.0, 2.7), canvas(kit), turn("z", rng.uniform(-30, 30))
    furled = kit.chance(0.2)
    bellied = len(masts) == 2 or (len(masts) == 3 and kit.chance(0.5))
    thick = 0.05 if furled else 0.018
    for i, share in enumerate(masts):
        last = i == len(masts) - 1
        x, high = share * long, deck + tall * (1 if 0 < i < len(masts) - 1 or len(masts) == 2 else 0.9 if not last else 0.8)
        kit.between((x, 0, deck * 0.5), (x - 0.04, 0, high), 0.035, taper=0.45, material=spar)
        if last and len(masts) > 2:
            sail(kit, x - 0.9, x - 0.05, x - 0.22, deck + 0.3, deck + tall * 0.55, cloth, 0.5)
            kit.between((x, 0, deck + 0.28), (x - 0.95, 0, deck + 0.3), 0.02, material=spar)
            continue
        z, gap = deck + 0.22, (high - deck - 0.25) / (rows + 0.2)
        for k in range(rows):
            step = gap * (1.15 - 0.1 * k)
            low, up = (0.62 - 0.13 * k) * tall * 0.42, (0.62 - 0.13 * (k + 1)) * tall * 0.42
            top = np.array([x + 0.045, 0, z + step])
            kit.add(CYL, top, (thick, thick, up * 1.12), rotation=yaw @ ALONG_Y, material=cloth if furled else spar)
            if not furled and bellied:
                for part, tip in ((0, 1), (1, -1)):
                    widths = low + (up - low) * part / 2, low + (up - low) * (part + 1) / 2
                    centre = top + yaw @ np.array([0.05, 0, -step * (0.74 if part == 0 else 0.25)])
                    kit.add(BOX, centre, (0.01, widths[0], step * 0.255), (1, widths[1] / widths[0]), (0.09 * tip, 0), yaw, cloth)
            elif not furled:
                kit.add(BOX, top + yaw @ np.array([0.05, 0, -step * 0.5]), (0.014, low, step * 0.49), (1, up / low), (-0.06, 0), yaw, cloth)
            z += step
        foot = np.array([x - 0.08, wide * 1.0, deck])
        head = np.array([x - 0.04, 0.04, deck + tall * 0.5])
        middle, angle = (foot + head) / 2, np.degrees(np.arctan2(foot[1] - head[1], head[2] - foot[2]))
        kit.add(BOX, middle, (0.22, 0.006, (head[2] - foot[2]) / 2), (0.08, 1), rotation=turn("x", angle), material=dark, mirror=True, cut=(GRID, 9, 0.16))
    fore = np.array([masts[0] * long, 0, deck])
    for k in range(int(rng.integers(1, 4))):
        at = bowsprit[0] - 0.3 * k - 0.05
        if furled:
            kit.between((at, 0, bowsprit[2] - 0.12 * k), fore + [0, 0, tall * (0.85 - 0.15 * k)], 0.007, material=dark)
        else:
            kit.between((at, 0, bowsprit[2] - 0.1 * k), fore + [0.02, 0, tall * (0.8 - 0.12 * k)], 0.006, material=dark)
            sail(kit, at - 0.42, at - 0.02, fore[0] + 0.14, bowsprit[2] + 0.04 - 0.08 * k, deck + tall * (0.7 - 0.12 * k), cloth, y=0.015 * (k + 1))
    kit.railing((-long * 0.9, wide * 0.93, deck), (long * 0.5, wide * 0.97, deck), 0.1, wood, 0.1)
    kit.railing((-long * 0.9, -wide * 0.93, deck), (long * 0.5, -wide * 0.97, deck), 0.1, wood, 0.1)
    kit.add(BOX, (-long * 1.0, 0, deck + 0.45), (0.14, 0.006, 0.09), material=kit.material(pattern=BANDS))
    kit.between((-long * 0.93, 0, deck), (-long * 0.93, 0, deck + 0.56), 0.01, material=spar)


def yacht(kit):
    """Sloops, cutters, ketches, dinghies and catamarans, afloat or with fin keel, rudder and stands in a yard."""
    rng = kit.rng
    gel = white_paint(kit) if kit.chance(0.6) else kit.material(pattern=PLAIN, gloss=0.5)
    deck_paint, metal, glass, cloth = white_paint(kit) if kit.chance(0.6) else timber(kit), kit.material(base=np.ones(3) * rng.uniform(0.3, 0.75), pattern=PLAIN, gloss=0.5), glazing(kit), canvas(kit)
    long, wide, side = rng.uniform(1.4, 1.9), rng.uniform(0.34, 0.48), rng.uniform(0.17, 0.26)
    twin = kit.chance(0.2)
    ashore = not twin and kit.chance(0.4)
    keel = rng.uniform(0.45, 0.8) if ashore else 0.0
    low = keel + (side * 0.8 if ashore else 0.0)
    deck = low + side * 1.6
    boot = antifouling(kit)
    for y in (-wide * 1.1, wide * 1.1) if twin else (0,):
        beam = wide * 0.3 if twin else wide
        stations = [(-1.0, 0.72), (-0.45, 0.95), (0.1, 1.0), (0.55, 0.7), (1.02, 0.03)]
        for (x0, w0), (x1, w1) in zip(stations[:-1], stations[1:], strict=True):
            middle, half = np.array([(x0 + x1) / 2 * long, y, 0]), (x1 - x0) / 2 * long
            for z in (low + 0.02, deck - 0.03):
                kit.add(BOX, middle + [0, 0, z], (0.02, w0 * beam, half), (1, w1 / w0), rotation=ALONG_X, material=gel)
            for way in (-1, 1):
                ends = [(x * long, y + way * w * beam, (low + deck) / 2) for x, w in ((x0, w0), (x1, w1))]
                kit.between(*ends, (side * 0.8, 0.015), BOX, material=gel)
        kit.add(BOX, (-long, y, (low + deck) / 2), (0.015, beam * 0.72, side * 0.8), material=gel)
        if ashore:
            kit.add(BALL, (-long * 0.03, 0, low + side * 0.15), (long * 0.93, wide * 0.93, side * 0.95), material=boot)
        else:
            kit.add(BOX, (-long * 0.2, y, low + 0.05), (long * 0.79, beam * 0.99, 0.035), (1, 1), material=boot)
    if ashore:
        chord = rng.uniform(0.16, 0.3) if kit.chance(0.6) else long * 0.4
        kit.add(BOX, (0, 0, (low + 0.05) / 2), (chord, 0.035, (low + 0.05) / 2), (1.3, 1.6), (0.06, 0), material=boot)
        if chord < 0.35:
            kit.add(BALL, (0, 0, 0.06), (chord * 1.4, 0.07, 0.06), material=kit.material(dark=True))
        kit.add(BOX, (-long * 0.82, 0, (low + keel * 0.4) / 2 + 0.1), (0.1, 0.025, (low - keel * 0.4) / 2 + 0.12), (1.2, 1), material=boot)
        for x in (-long * 0.5, long * 0.35):
            kit.between((x, wide * 0.8, low), (x, wide * 1.3, 0), 0.025, material=kit.material(dark=True), mirror=True)
    if twin:
        kit.add(BOX, (-long * 0.2, 0, deck - 0.06), (long * 0.6, wide * 1.2, 0.06), material=gel)
        kit.add(BOX, (long * 0.6, 0, deck - 0.05), (long * 0.25, wide * 1.0, 0.012), material=kit.material(dark=True), cut=(GRID, 12, 0.25))
        kit.between((long * 0.84, -wide * 1.1, deck - 0.06), (long * 0.84, wide * 1.1, deck - 0.06), 0.03, material=metal)
    kit.add(BOX, (-long * 0.27, 0, deck), (long * 0.7, wide * 0.85, 0.012), material=deck_paint)
    cabin = rng.uniform(0.08, 0.15) * (1.7 if twin else 1)
    x = rng.uniform(-0.05, 0.1) * long
    kit.add(BOX, (x, 0, deck + cabin), (long * 0.33, wide * (0.95 if twin else 0.55), cabin), (0.8, 0.85), (-0.06, 0), material=gel if kit.chance(0.4) else white_paint(kit))
    kit.add(BOX, (x, 0, deck + cabin * 1.15), (long * 0.29, wide * (0.93 if twin else 0.535), cabin * 0.35), (0.9, 0.97), (-0.03, 0), material=glass)
    mast_x, mast = rng.uniform(0.12, 0.25) * long, rng.uniform(1.7, 2.4) * long
    head = deck + mast
    ketch = kit.chance(0.2)
    kit.between((mast_x, 0, deck - 0.1), (mast_x, 0, head), 0.028, taper=0.6, material=metal)
    boom = deck + cabin * 2 + 0.12
    aft = -long * (0.35 if ketch else rng.uniform(0.6, 0.8))
    kit.between((mast_x, 0, boom), (aft, 0, boom + 0.02), 0.024, material=metal)
    up = kit.chance(0.45 if ashore else 0.75)
    if up:
        sail(kit, aft + 0.03, mast_x - 0.03, mast_x - 0.03 - 0.1 * kit.chance(0.5), boom + 0.05, head - 0.08, cloth, rng.choice([0.03, 0.2, 0.45]), 0.01)
        if kit.chance(0.2):
            kit.add(BALL, (long * 0.8, 0, deck + mast * 0.45), (long * 0.24, wide * 1.1, mast * 0.4), material=kit.material(pattern=rng.choice([PLAIN, BANDS, STRIPES])))
        else:
            foot = mast_x - rng.choice([-0.05, 0.3])
            sail(kit, foot, long * 0.95, mast_x + 0.06, deck + 0.12, deck + mast * rng.uniform(0.7, 0.95), cloth, y=-0.02)
    else:
        kit.between((mast_x - 0.05, 0, boom + 0.06), (aft + 0.05, 0, boom + 0.06), 0.06, taper=0.6, material=kit.material(base=paint(rng.uniform(0.5, 0.7), 0.8, 0.25)))
        kit.between((long * 0.97, 0, deck + 0.1), (mast_x, 0, head * 0.93), 0.025, material=cloth)
    if ketch:
        kit.between((-long * 0.55, 0, deck), (-long * 0.55, 0, deck + mast * 0.65), 0.022, taper=0.6, material=metal)
        kit.between((-long * 0.55, 0, boom), (-long * 0.95, 0, boom), 0.018, material=metal)
        if up:
            sail(kit, -long * 0.94, -long * 0.57, -long * 0.57, boom + 0.05, deck + mast * 0.62, cloth)
    thin = 0.007
    kit.between((mast_x - 0.05, wide * 0.9, deck), (mast_x, 0.02, head * 0.95), thin, material=metal, mirror=True)
    kit.between((long * 0.98, 0, deck), (mast_x, 0, head * 0.97), thin, material=metal)
    kit.between((-long * 0.97, 0, deck), (mast_x, 0, head), thin, material=metal)
    kit.between((mast_x, -wide * 0.6, deck + mast * 0.55), (mast_x, wide * 0.6, deck + mast * 0.55), 0.012, material=metal)
    kit.add(BOX, (-long * 0.62, 0, deck + 0.02), (long * 0.2, wide * 0.45, 0.015), material=kit.material(dark=True))
    if kit.chance(0.6):
        kit.add(TUBE, (-long * 0.78, 0, deck + 0.22), (0.15, 0.15, 0.012), rotation=ALONG_X, material=metal)
        kit.between((-long * 0.76, 0, deck), (-long * 0.76, 0, deck + 0.24), 0.03, material=deck_paint)
    for y in (-1, 1):
        kit.railing((-long * 0.95, y * wide * 0.72, deck), (long * 0.1, y * wide, deck), 0.16, metal, 0.3, thick=0.006)
        kit.railing((long * 0.1, y * wide, deck), (long * 0.98, y * 0.05, deck), 0.16, metal, 0.3, thick=0.006)


def lugger(kit):
    """Dhows with lateen sails and junks with battened ones."""
    rng = kit.rng
    wood, spar, dark = timber(kit), timber(kit, 0.5, 1.3), kit.material(dark=True)
    long, wide, deck = rng.uniform(1.4, 1.9), rng.uniform(0.36, 0.5), rng.uniform(0.36, 0.5)
    hull(kit, long, wide, deck, wood, dark if kit.chance(0.4) else timber(kit, 0.4, 0.8), 0.25, rng.uniform(0.3, 0.6), 0.8)
    kit.add(BOX, (-long * 0.72, 0, deck + 0.1), (long * 0.24, wide * 0.92, 0.15), (0.95, 1), (-0.08, 0), material=wood)
    rim = kit.material(base=rng.choice([[0.5, 0.06, 0.03], [0.05, 0.2, 0.25], [0.7, 0.6, 0.4], [0.05, 0.05, 0.05]]), pattern=PLAIN)
    kit.add(BOX, (-long * 0.2, 0, deck * 0.93), (long * 0.72, wide * 1.03, 0.03), material=rim)
    kit.add(BOX, (-long * 0.78, 0, deck + 0.27), (long * 0.2, wide * 0.98, 0.025), material=rim)
    if kit.chance(0.5):
        cloth = canvas(kit)
        for i, x in enumerate([0.2] if kit.chance(0.5) else [0.35, -0.4]):
            tall, x = rng.uniform(1.9, 2.3) * (1 - 0.25 * i), x * long
            kit.between((x, 0, deck * 0.5), (x + 0.14, 0, deck + tall * 0.75), 0.04, taper=0.6, material=spar)
            front, back = np.array([x + 0.75 - 0.15 * i, 0.05, deck + 0.28]), np.array([x - 0.75, 0.05, deck + tall * 1.05])
            kit.between(front, back, 0.03, taper=0.6, material=spar)
            yard = (front - back) / np.linalg.norm(front - back)
            across = np.array([yard[2], 0, -yard[0]])
            clew = np.array([x - 0.7, 0.05, front[2] + 0.05]) - (front + back) / 2
            along, deep = clew @ yard, clew @ across
            frame = np.stack([yard, [0, -1.0, 0], across], 1)
            kit.add(BOX, (front + back + deep * across) / 2, (np.linalg.norm(front - back) / 2, 0.012, deep / 2), (0.03, 1), (along, 0), frame, cloth)
            kit.between((x + 0.12, 0, deck + tall * 0.72), (x - 0.4, wide * 0.95, deck), 0.01, material=dark, mirror=True)
    else:
        cloth = kit.material(base=np.array(rng.choice([[0.5, 0.08, 0.04], [0.6, 0.4, 0.2], [0.75, 0.7, 0.55], [0.4, 0.2, 0.05]])), pattern=rng.choice([PLAIN, CLOUDY]))
        places = [(0.68, 0.75), (0.05, 1.0), (-0.75, 0.6)] if kit.chance(0.6) else [(0.5, 0.8), (-0.15, 1.0)]
        tall = rng.uniform(1.7, 2.1)
        for share, size in places:
            x, battens = share * long, int(rng.integers(4, 7))
            foot = deck + (0.35 if share < -0.5 else 0.2)
            kit.between((x, 0, deck * 0.5), (x, 0, foot + tall * size * 1.05), 0.035, taper=0.6, material=spar)
            back, fore, lift = 0.72 * size, 0.2 * size, tall * size
            sail(kit, x - back, x + fore, x - back * 0.2, foot, foot + lift, cloth, 0.42, 0.045)
            for k in range(battens + 1):
                t = k / battens
                middle, half = x + (fore - back) / 2 * (1 - t) - back * 0.2 * t, (back + fore) / 2 * (1 - 0.58 * t) * 1.04
                kit.between((middle - half, 0.045, foot + lift * t), (middle + half, 0.045, foot + lift * t - 0.06 * (1 - t)), 0.018, material=spar)
    kit.add(BOX, (-long * 0.98, 0, deck * 0.5), (0.1, 0.03, deck * 0.5), material=wood)
    kit.add(BOX, (-long * 0.3, 0, deck + 0.08), (long * 0.15, wide * 0.5, 0.1), (1, 0.7), material=spar)


def submarine(kit):
    """Modern boats with sail, planes and a cross or X of rudders; old ones with casing, deck gun and rails; small submersibles."""
    rng = kit.rng
    skin = kit.material(base=np.ones(3) * rng.uniform(0.015, 0.2), pattern=rng.choice([PLAIN, STREAKS, SEAMS]), gloss=0.1) if kit.chance(0.7) else kit.material(pattern=PLAIN)
    dark, steel = kit.material(dark=True), kit.material(base=np.ones(3) * rng.uniform(0.15, 0.5))
    kind = rng.choice(["modern", "old", "small"], p=[0.5, 0.3, 0.2])
    if kind == "small":
        body = kit.material(base=rng.choice([[0.75, 0.45, 0.02], [0.8, 0.8, 0.8], [0.6, 0.05, 0.03], [0.05, 0.2, 0.4]]), pattern=PLAIN, gloss=0.4)
        long, fat = rng.uniform(0.7, 1.1), rng.uniform(0.38, 0.5)
        z = fat + 0.25
        kit.add(CYL, (-0.1, 0, z), (fat, fat, long * 0.65), rotation=ALONG_X, material=body)
        kit.add(BALL, (long * 0.6, 0, z), (fat * 0.95, fat * 0.96, fat * 0.96), material=kit.material(base=[0.1, 0.16, 0.2], gloss=0.64, pattern=PLAIN))
        kit.add(TUBE, (long * 0.58, 0, z), (fat * 1.04, fat * 1.04, 0.06), rotation=ALONG_X, material=steel)
        kit.between((-long * 0.7, 0, z), (-long * 1.25, 0, z), fat, taper=0.3, material=body)
        kit.add(CYL, (0, 0, z + fat + 0.1), (fat * 0.45, fat * 0.45, 0.18), material=body)
        kit.add(CYL, (0, 0, z + fat + 0.3), (fat * 0.5, fat * 0.5, 0.03), material=dark)
        kit.add(CYL, (0, fat * 0.8, 0.13), (0.12, 0.12, long * 0.8), rotation=ALONG_X, material=dark if kit.chance(0.5) else body, mirror=True)
        for x in (-0.4, 0.4):
            kit.between((x, fat * 0.8, 0.13), (x, fat * 0.6, z - fat * 0.4), 0.04, material=steel, mirror=True)
        kit.between((-0.3, 0, z), (-0.3, fat + 0.2, z), 0.04, material=steel, mirror=True)
        kit.add(TUBE, (-0.3, fat + 0.25, z), (0.15, 0.15, 0.12), rotation=ALONG_X, material=dark, mirror=True)
        for spin in (0, 90, 180, 270):
            out = turn("x", spin)
            kit.add(BOX, np.array([-long * 1.15, 0, z]) + out @ np.array([0, 0, fat * 0.6]), (0.14, 0.02, fat * 0.4), (0.7, 1), rotation=out, material=body)
        propeller(kit, (-long * 1.3, 0, z), fat * 0.6, ALONG_X, dark, 3)
        kit.chain([(long * 0.6, fat * 0.5, z - fat * 0.75), (long * 1.2, fat * 0.55, z - fat * 0.9), (long * 1.4, fat * 0.3, z - fat * 0.7)], 0.04, steel, mirror=True)
        kit.add(CYL, (long * 0.75, fat * 0.5, z + fat * 0.95), (0.09, 0.09, 0.07), rotation=ALONG_X, material=kit.material(base=[0.8, 0.8, 0.7]), mirror=True)
        kit.between((long * 0.6, fat * 0.5, z + fat * 0.7), (long * 0.7, fat * 0.5, z + fat * 0.95), 0.03, material=steel, mirror=True)
        return
    long, fat = rng.uniform(2.2, 3.0), rng.uniform(0.24, 0.34)
    z = fat
    kit.add(CYL, (long * 0.1, 0, z), (fat, fat, long * 0.6), rotation=ALONG_X, material=skin)
    if kind == "modern":
        kit.add(BALL, (long * 0.7, 0, z), (long * 0.3 * rng.uniform(0.5, 1), fat, fat), material=skin)
    else:
        kit.between((long * 0.7, 0, z), (long, 0, z * 1.25), fat, taper=0.15, material=skin)
        kit.add(BOX, (long * 0.02, 0, z + fat * 0.95), (long * 0.85, fat * 0.5, fat * 0.16), (1, 0.9), material=skin)
        kit.add(BOX, (long * 0.92, 0, z + fat * 0.75), (fat * 0.5, fat * 0.42, long * 0.13), (0.5, 0.05), (-fat * 0.25, 0), ALONG_X, skin)
        kit.add(BALL, (long * 0.1, 0, z - fat * 0.15), (long * 0.6, fat * 1.4, fat * 0.7), material=skin)
    kit.between((-long * 0.5, 0, z), (-long * 1.0, 0, z), fat, taper=0.22, material=skin)
    top = z + fat * (1.1 if kind == "old" else 0.95)
    x, tower, chord = rng.uniform(0.05, 0.4) * long, rng.uniform(0.3, 0.5), rng.uniform(0.22, 0.4)
    if kind == "modern":
        kit.add(BOX, (x, 0, top + tower * 0.5), (chord, 0.085, tower * 0.6), (0.85, 0.8), (-0.04 * kit.chance(0.5), 0), material=skin)
        kit.add(CYL, (x + chord * 0.9, 0, top + tower * 0.5), (0.12, 0.08, tower * 0.59), (0.8, 1), material=skin)
        if kit.chance(0.6):
            kit.add(BOX, (x + chord * 0.3, 0, top + tower * 0.55), (0.13, 0.42, 0.018), (0.8, 1), material=skin)
        else:
            kit.add(BOX, (long * 0.62, 0, z + fat * 0.25), (0.13, fat + 0.2, 0.02), material=skin)
        for k in range(int(rng.integers(2, 6))):
            at = x + chord * rng.uniform(-0.7, 0.8)
            kit.between((at, 0, top + tower), (at, 0, top + tower * rng.uniform(1.3, 2.0)), rng.uniform(0.012, 0.025), material=steel)
        kit.add(BOX, (-long * 0.15, 0, z + fat * 0.97), (long * 0.3, fat * 0.35, 0.03), material=dark)
        for _ in range(int(rng.integers(0, 4))):
            kit.add(CYL, (rng.uniform(-0.4, 0.5) * long, 0, z + fat), (0.06, 0.06, 0.012), material=steel)
    else:
        kit.add(BOX, (x, 0, top + tower * 0.35), (chord, 0.13, tower * 0.35), material=skin)
        kit.add(CYL, (x + chord, 0, top + tower * 0.35), (0.14, 0.13, tower * 0.35), material=skin)
        kit.railing((x - chord * 2.2, 0.11, top + tower * 0.35), (x - chord, 0.11, top + tower * 0.35), 0.15, steel, 0.08)
        kit.railing((x - chord * 2.2, -0.11, top + tower * 0.35), (x - chord, -0.11, top + tower * 0.35), 0.15, steel, 0.08)
        kit.add(BOX, (x - chord * 1.6, 0, top + tower * 0.15), (chord * 0.65, 0.12, tower * 0.2), material=skin)
        kit.between((x - chord * 1.6, 0, top + tower * 0.35), (x - chord * 1.6, 0, top + tower * 0.65), 0.03, material=dark)
        kit.between((x - chord * 2, 0, top + tower * 0.7), (x - chord, 0, top + tower * 0.8), 0.018, material=dark)
        for k in (0, 1):
            kit.between((x - 0.1 + 0.2 * k, 0, top), (x - 0.1 + 0.2 * k, 0, top + tower * (1.6 - 0.3 * k)), 0.02, material=steel)
        gun = np.array([x + chord + rng.uniform(0.3, 0.5), 0, top])
        kit.add(CYL, gun + [0, 0, 0.05], (0.07, 0.07, 0.08), material=dark)
        kit.between(gun + [-0.12, 0, 0.13], gun + [0.45, 0, 0.18], 0.025, material=dark)
        kit.between((x + chord, 0, top + tower * 0.9), (long * 0.97, 0, top), 0.006, material=dark)
        kit.between((x - chord, 0, top + tower * 0.9), (-long * 0.9, 0, top), 0.006, material=dark)
        kit.add(BOX, (long * 0.75, 0, z), (0.1, fat * 1.3, 0.02), material=skin)
    first = 45 if kind == "modern" and kit.chance(0.25) else 0
    for spin in (0, 90, 180, 270):
        out = turn("x", spin + first)
        reach = fat * (1.0 if spin != 180 or first else 0.75)
        kit.add(BOX, np.array([-long * 0.86, 0, z]) + out @ np.array([0, 0, fat * 0.25 + reach * 0.5]), (0.15, 0.02, reach * 0.6), (0.75, 1), (-0.04, 0), out, skin)
    propeller(kit, (-long * 1.01, 0, z), fat * 0.7, ALONG_X, kit.material(base=[0.4, 0.25, 0.06], gloss=0.5), int(rng.choice([5, 6, 7])))
    if kit.chance(0.4):
        kit.add(BOX, (0, 0, z - fat * 0.7), (long * 0.1, fat * 0.7, fat * 0.35), material=steel)


def freighter(kit):
    """Container ships, tankers and bulk carriers with the bridge aft."""
    rng = kit.rng
    paints = [[0.02, 0.03, 0.05], [0.45, 0.04, 0.03], [0.03, 0.12, 0.35], [0.03, 0.2, 0.12], [0.5, 0.5, 0.5], [0.55, 0.2, 0.03], [0.1, 0.25, 0.4]]
    side = kit.material(base=np.array(paints[rng.integers(len(paints))]), pattern=rng.choice([PLAIN, STREAKS]), gloss=0.15)
    white, dark, steel = white_paint(kit), kit.material(dark=True), kit.material(base=rng.choice([[0.7, 0.55, 0.3], [0.75] * 3, [0.5, 0.3, 0.05]]), pattern=PLAIN)
    long, wide, deck = rng.uniform(2.6, 3.2), rng.uniform(0.4, 0.52), rng.uniform(0.42, 0.6)
    shoulder = hull(kit, long, wide, deck, side, antifouling(kit), rng.uniform(0.1, 0.14), rng.uniform(0.1, 0.25), 0.9, rng.uniform(0.25, 0.5))
    plate = kit.material(base=rng.choice([[0.3, 0.06, 0.04], [0.08, 0.2, 0.12], [0.25] * 3]), pattern=PLAIN)
    kit.add(BOX, (-long * 0.12, 0, deck), (long * 0.85, wide * 0.97, 0.015), material=plate)
    kit.add(BALL, (long * 0.95, 0, deck * 0.15), (0.2, 0.07, deck * 0.15), material=kit.primitives[0].material)
    kind = rng.choice(["boxes", "tanker", "bulk"])
    bridge = -long * (rng.uniform(0.6, 0.75) if kind == "boxes" else 0.8)
    high = rng.uniform(0.65, 0.9) if kind == "boxes" else rng.uniform(0.5, 0.7)
    kit.add(BOX, (bridge, 0, deck + high / 2), (0.17, wide * 0.75, high / 2), (0.9, 0.95), material=white)
    glass = ports(kit)
    for k in range(3):
        kit.add(BOX, (bridge, 0, deck + high * (0.3 + 0.2 * k)), (0.172, wide * 0.735, 0.022), material=glass)
    kit.add(BOX, (bridge + 0.03, 0, deck + high), (0.12, wide * 1.0, 0.04), material=white)
    kit.add(BOX, (bridge + 0.03, 0, deck + high + 0.07), (0.13, wide * 0.55, 0.05), (0.9, 0.95), material=glazing(kit))
    kit.add(BOX, (bridge + 0.03, 0, deck + high + 0.13), (0.14, wide * 0.6, 0.015), material=white)
    kit.between((bridge, 0, deck + high + 0.1), (bridge, 0, deck + high + 0.45), 0.02, material=steel)
    kit.between((bridge, -0.12, deck + high + 0.34), (bridge, 0.12, deck + high + 0.34), 0.015, material=steel)
    funnel = kit.material(pattern=BANDS, frequency=rng.uniform(8, 18))
    kit.add(BOX, (bridge - 0.3, 0, deck + high * 0.42), (0.13, wide * 0.35, high * 0.42), (0.8, 0.8), material=funnel)
    kit.add(CYL, (bridge - 0.3, 0, deck + high * 0.86), (0.05, 0.05, 0.06), material=dark)
    kit.add(BOX, (-long * 0.88, 0, deck + 0.07), (long * 0.08, wide * 0.7, 0.07), material=white)
    kit.between((bridge - 0.16, wide * 0.75, deck + high * 0.4), (bridge - 0.48, wide * 0.85, deck + high * 0.25), (0.05, 0.045), BOX, material=kit.material(base=[0.75, 0.2, 0.02]), mirror=True)
    front = shoulder + long * 0.04
    if kind == "boxes":
        bays = int(rng.integers(6, 10))
        reach = front - bridge - 0.25
        colours = [kit.material(base=np.array(c), second=np.array(d), pattern=PATCHWORK, frequency=rng.uniform(35, 60)) for c, d in (([0.4, 0.05, 0.03], [0.05, 0.15, 0.4]), ([0.6, 0.3, 0.05], [0.5, 0.5, 0.5]), ([0.03, 0.2, 0.15], [0.4, 0.1, 0.05]))]
        for k in range(bays):
            x = bridge + 0.25 + reach * (k + 0.5) / bays
            floor = deck + 0.03
            tiers = rng.uniform(0.2, 0.5) if kit.chance(0.85) else 0.1
            for part in (0.55, 0.45):
                tall = tiers * part
                kit.add(BOX, (x, 0, floor + tall / 2), (reach / bays * 0.46, wide * rng.choice([0.95, 0.95, 0.8]), tall / 2), material=colours[rng.integers(3)])
                floor += tall
        if bridge > -long * 0.68:
            kit.add(BOX, (-long * 0.86, 0, deck + 0.2), (long * 0.08, wide * 0.9, 0.2), material=colours[0])
    elif kind == "tanker":
        for y in (-0.08, 0, 0.08):
            kit.between((bridge + 0.2, y, deck + 0.06), (front, y, deck + 0.06), 0.022, material=steel)
        kit.add(BOX, (0, 0, deck + 0.06), (0.05, wide * 0.9, 0.03), material=steel)
        kit.add(BOX, (long * 0.05, 0, deck + 0.12), ((front - bridge) / 2 - 0.2, 0.035, 0.02), material=plate)
        for x in np.linspace(bridge + 0.4, front - 0.1, int(rng.integers(4, 7))):
            kit.add(CYL, (x, wide * 0.6, deck + 0.04), (0.05, 0.05, 0.05), material=plate, mirror=True)
        kit.between((0.1, wide * 0.3, deck), (0.1, wide * 0.3, deck + 0.35), 0.035, material=steel, mirror=True)
        kit.between((0.1, wide * 0.3, deck + 0.33), (0.5, wide * 0.3, deck + 0.5), 0.02, material=steel, mirror=True)
        if kit.chance(0.3):
            for x in np.linspace(bridge + 0.65, front - 0.35, 4):
                kit.add(BALL, (x, 0, deck + 0.05), (0.38, wide * 0.92, 0.42), material=white if kit.chance(0.8) else steel)
    else:
        hatches = int(rng.integers(5, 8))
        reach = front - bridge - 0.2
        cover = plate if kit.chance(0.5) else kit.material(pattern=RIBS, frequency=20)
        cranes = kit.chance(0.65)
        for k in range(hatches):
            x = bridge + 0.2 + reach * (k + 0.5) / hatches
            kit.add(BOX, (x, 0, deck + 0.06), (reach / hatches * 0.36, wide * 0.62, 0.06), material=cover)
            if cranes and k % 2 == 1:
                at = np.array([x + reach / hatches * 0.5, 0, deck])
                kit.between(at, at + [0, 0, 0.45], 0.05, material=steel)
                kit.add(BOX, at + [0, 0, 0.48], (0.075, 0.08, 0.09), material=steel)
                way = rng.choice([-1, 1])
                kit.between(at + [0.05 * way, 0, 0.45], at + [0.62 * way, 0, rng.uniform(0.5, 0.8)], (0.02, 0.035), BOX, 0.6, material=steel)
    kit.between((long * 0.88, 0, deck), (long * 0.88, 0, deck + 0.45), 0.02, material=steel)
    kit.add(BOX, (long * 0.8, 0, deck + 0.1), (0.06, 0.08, 0.06), material=dark)


def flat_top(kit):
    """Aircraft carriers and landing ships: a flat deck with lines, an island to starboard, aircraft parked."""
    rng = kit.rng
    grey, dark = navy(kit), kit.material(dark=True)
    runway = kit.material(base=np.ones(3) * rng.uniform(0.06, 0.16), pattern=rng.choice([PLAIN, CLOUDY, STREAKS]))
    line = kit.material(base=[0.75, 0.72, 0.6], pattern=PLAIN)
    long, wide, deck = rng.uniform(2.7, 3.2), rng.uniform(0.3, 0.38), rng.uniform(0.42, 0.55)
    hull(kit, long * 0.97, wide, deck * 0.82, grey, antifouling(kit), 0.16, 0.15, 0.9, 0.3)
    broad = wide * rng.uniform(1.25, 1.5)
    kit.add(BOX, (-long * 0.05, 0, deck * 0.84), (long * 0.85, wide, deck * 0.1), (1.05, broad / wide * 0.97), material=grey)
    kit.add(BOX, (-long * 0.2, 0, deck), (long * 0.8, broad, 0.03), material=runway)
    jump = rng.choice([0, 0, 0.22])
    kit.add(BOX, (long * 0.78, 0, deck + jump / 2), (0.03, broad, long * 0.23), (1, rng.uniform(0.55, 0.8)), (-jump, 0), ALONG_X, runway)
    kit.add(BOX, (long * 0.75, 0, deck * 0.85), (deck * 0.14, wide * 0.98, long * 0.22), (0.6, 0.5), (-deck * 0.05 - jump * 0.8, 0), ALONG_X, grey)
    angled = jump == 0 and kit.chance(0.6)
    yaw = turn("z", 8)
    if angled:
        kit.add(BOX, (0.05 * long, broad * 1.0, deck), (long * 0.5, broad * 0.3, 0.03), (1, 1), (0, 0), yaw, runway)
        kit.add(BOX, (-0.1 * long, broad * 0.95, deck * 0.9), (long * 0.4, broad * 0.2, deck * 0.08), (1.05, 1.1), material=grey)
    rot, aside = (yaw, broad * 0.45) if angled else (np.eye(3), broad * 0.2)
    for offset in (-0.2, 0.2) if angled else (0.0,):
        kit.add(BOX, np.array([-long * 0.25, aside + offset * broad * 2, deck + 0.031]), (long * 0.62, 0.012, 0.003), rotation=rot, material=line)
    kit.add(BOX, (long * 0.6, -broad * 0.2, deck + 0.031), (long * 0.3 if not jump else long * 0.1, 0.01, 0.003), material=line)
    x, high = rng.uniform(-0.2, 0.1) * long, rng.uniform(0.35, 0.5)
    y = -broad * 0.82
    kit.add(BOX, (x, y, deck + high / 2), (rng.uniform(0.25, 0.45), 0.1, high / 2), (0.92, 0.9), material=grey)
    kit.add(BOX, (x + 0.05, y, deck + high * 0.8), (0.28, 0.115, 0.03), material=glazing(kit))
    kit.add(BOX, (x - 0.02, y, deck + high * 1.15), (0.16, 0.08, high * 0.2), (0.9, 0.9), material=grey)
    mast = deck + high * 2.1
    kit.between((x - 0.05, y, deck + high), (x - 0.05, y, mast), 0.035, taper=0.5, material=grey)
    kit.between((x - 0.05, y - 0.13, mast * 0.9), (x - 0.05, y + 0.13, mast * 0.9), 0.015, material=dark)
    kit.add(BOX, (x + 0.12, y, deck + high * 1.5), (0.02, 0.14, 0.07), rotation=turn("z", rng.uniform(0, 90)), material=dark, cut=(GRID, 20, 0.4) if kit.chance(0.5) else (0, 1, 1))
    if kit.chance(0.6):
        kit.add(BALL, (x - 0.25, y, deck + high + 0.08), (0.08, 0.08, 0.09), material=white_paint(kit))
    if kit.chance(0.4):
        kit.add(CYL, (x - 0.12, y, deck + high * 1.2), (0.09, 0.06, 0.14), material=dark)
    if kit.chance(0.4):
        kit.add(BOX, (x - 0.95, y, deck + high * 0.4), (0.22, 0.09, high * 0.4), (0.9, 0.9), material=grey)
    for x in (long * 0.35, -long * 0.55):
        kit.add(BOX, (x, -broad * 0.98, deck), (0.2, 0.1, 0.02), material=grey)
    jet_paint = kit.material(base=np.ones(3) * rng.uniform(0.3, 0.6), pattern=PLAIN)
    copters = kit.chance(0.35)
    for k in range(int(rng.integers(3, 9))):
        spin = turn("z", rng.uniform(-60, 60) + 30)
        along = rng.uniform(-0.9, 0.75) if not copters else -0.85 + 0.22 * k
        at = np.array([along * long, -broad * rng.uniform(0.35, 0.6) if not copters else broad * 0.25, deck + 0.075])
        if abs(at[0] - x) < 0.5 and at[1] < -broad * 0.6:
            at[1] = broad * 0.6
        if copters:
            kit.add(BALL, at, (0.12, 0.05, 0.055), material=jet_paint)
            kit.between(at + [0, 0, 0.01], at + [-0.28, 0, 0.03], 0.02, material=jet_paint)
            kit.add(BOX, at + [0, 0, 0.075], (0.22, 0.012, 0.006), rotation=spin, material=dark)
            kit.add(BOX, at + [0, 0, 0.075], (0.012, 0.22, 0.006), rotation=spin, material=dark)
        else:
            kit.add(CYL, at, (0.035, 0.035, 0.17), (0.2, 1), rotation=spin @ ALONG_X, material=jet_paint)
            kit.add(BOX, at + spin @ np.array([-0.06, 0, 0]), (0.008, 0.15, 0.08), (1, 0.15), rotation=spin @ ALONG_X, material=jet_paint)
            kit.add(BOX, at + spin @ np.array([-0.13, 0, 0.03]), (0.035, 0.008, 0.05), (0.6, 1), (-0.03, 0), spin, jet_paint)
    kit.add(BOX, (-long * 0.985, 0, deck * 0.5), (0.02, wide * 0.7, deck * 0.25), material=dark)


def tug(kit):
    """Harbour tugs and pushers: short and high-bowed, rubber around, a wheelhouse with windows all around, funnels, a winch."""
    rng = kit.rng
    side = kit.material(base=rng.choice([[0.02, 0.02, 0.03], [0.03, 0.1, 0.3], [0.4, 0.04, 0.03], [0.03, 0.2, 0.12]]), pattern=rng.choice([PLAIN, STREAKS]), gloss=0.2)
    house, dark, trim = white_paint(kit) if kit.chance(0.7) else kit.material(base=[0.6, 0.4, 0.15], pattern=PLAIN), kit.material(dark=True), kit.material()
    long, wide, deck = rng.uniform(1.3, 1.6), rng.uniform(0.48, 0.6), rng.uniform(0.4, 0.55)
    shoulder = hull(kit, long, wide, deck, side, antifouling(kit), rng.uniform(0.2, 0.26), rng.uniform(0.35, 0.6), 0.85, 0.3)
    kit.add(BOX, (-long * 0.2, 0, deck * 0.97), (long * 0.72, wide * 1.04, 0.05), material=dark)
    prow = deck * 1.15
    kit.between((shoulder, wide * 1.0, deck), (shoulder + (long - shoulder) * 0.5, wide * 0.76, prow), 0.06, material=dark, mirror=True)
    kit.between((shoulder + (long - shoulder) * 0.5, wide * 0.76, prow), (long * 1.0, 0.05, prow * 1.12), 0.06, material=dark, mirror=True)
    for k in range(int(rng.integers(2, 5))):
        kit.add(CYL, (long * (0.3 - 0.35 * k), wide * 1.06, deck * 0.7), (0.11, 0.11, 0.05), rotation=ALONG_Y, material=dark, mirror=True)
    x, tall = rng.uniform(0.0, 0.18) * long, rng.uniform(0.18, 0.28)
    kit.add(BOX, (x - 0.1, 0, deck + tall), (long * 0.42, wide * 0.68, tall), (0.95, 0.95), material=house)
    kit.add(BOX, (x - 0.1, 0, deck + tall * 1.25), (long * 0.4, wide * 0.69, 0.05), (0.97, 0.98), material=ports(kit, 18))
    top = deck + 2 * tall
    kit.add(BOX, (x - 0.05, 0, top + 0.015), (long * 0.45, wide * 0.78, 0.025), material=trim)
    if kit.chance(0.5):
        kit.add(BOX, (x, 0, top + tall), (long * 0.28, wide * 0.5, tall), (0.95, 0.95), material=house)
        top += 2 * tall
    bridge = rng.uniform(0.17, 0.24)
    kit.add(BOX, (x + 0.08, 0, top + bridge), (long * 0.2, wide * 0.48, bridge), (1.05, 1.05), material=house)
    kit.add(BOX, (x + 0.08, 0, top + bridge * 1.25), (long * 0.207, wide * 0.495, bridge * 0.38), (1.04, 1.04), material=glazing(kit))
    kit.add(BOX, (x + 0.08, 0, top + bridge * 2), (long * 0.24, wide * 0.56, 0.03), material=trim if kit.chance(0.5) else house)
    funnel = kit.material(base=rng.choice([[0.5, 0.05, 0.03], [0.7, 0.45, 0.03], [0.03, 0.1, 0.35], [0.02, 0.02, 0.02]]), pattern=rng.choice([PLAIN, BANDS]), frequency=12)
    spread = rng.choice([0, wide * 0.42])
    kit.add(BOX, (x - long * 0.3, spread, deck + 2 * tall + 0.25), (0.12, 0.1, 0.28), (0.85, 0.9), (-0.04, 0), material=funnel, mirror=spread > 0)
    kit.add(CYL, (x - long * 0.31, spread, deck + 2 * tall + 0.54), (0.05, 0.05, 0.06), material=dark, mirror=spread > 0)
    mast = top + 2 * bridge
    kit.between((x, 0, mast), (x - 0.05, 0, mast + rng.uniform(0.4, 0.8)), 0.03, taper=0.5, material=house)
    kit.between((x, -0.2, mast + 0.3), (x, 0.2, mast + 0.3), 0.018, material=house)
    kit.add(BOX, (x + 0.05, 0, mast + 0.18), (0.02, 0.13, 0.025), material=dark)
    kit.add(CYL, (-long * 0.5, 0, deck + 0.13), (0.15, 0.15, 0.16), rotation=ALONG_Y, material=trim)
    kit.add(BOX, (-long * 0.5, 0.19, deck + 0.12), (0.16, 0.03, 0.13), material=dark, mirror=True)
    kit.chain([(-long * 0.75, wide * 0.5, deck), (-long * 0.75, wide * 0.4, deck + 0.3), (-long * 0.75, 0, deck + 0.32)], 0.03, trim, mirror=True)
    kit.add(CYL, (long * 0.72, 0, deck * 1.35), (0.08, 0.08, 0.1), material=dark)
    for y in (-1, 1):
        kit.add(BOX, (-long * 0.4, y * wide * 0.98, deck + 0.1), (long * 0.5, 0.02, 0.1), material=side)
    kit.between((x + long * 0.32, wide * 0.5, top + 0.05), (x + long * 0.33, wide * 0.5, top + 0.15), 0.05, material=kit.material(base=[0.8, 0.25, 0.03]), mirror=True)


def liner(kit):
    """Cruise ships, car ferries and river boats: decks with rows of windows, lifeboats, a funnel."""
    rng = kit.rng
    white, dark = white_paint(kit), kit.material(dark=True)
    side = white if kit.chance(0.5) else kit.material(base=rng.choice([[0.02, 0.03, 0.08], [0.03, 0.15, 0.4], [0.45, 0.04, 0.03], [0.02, 0.02, 0.02]]), pattern=PLAIN)
    long, wide, deck = rng.uniform(2.5, 3.1), rng.uniform(0.36, 0.5), rng.uniform(0.35, 0.5)
    river = kit.chance(0.2)
    if river:
        deck *= 0.6
    hull(kit, long, wide, deck, side, antifouling(kit), rng.uniform(0.13, 0.2), rng.uniform(0.1, 0.35), 0.9, 0.3)
    window = ports(kit)
    kit.add(BOX, (-long * 0.15, 0, deck * 0.75), (long * 0.68, wide * 1.008, 0.02), material=window)
    decks = int(rng.integers(2, 4)) if river else int(rng.integers(3, 7))
    step = 0.13
    back, front = -long * rng.uniform(0.85, 0.93), long * rng.uniform(0.55, 0.7)
    z = deck
    for k in range(decks):
        width = wide * (0.97 if k < decks - 2 else 0.85)
        kit.add(BOX, ((back + front) / 2, 0, z + step / 2), ((front - back) / 2, width, step / 2), (0.99, 1), (-0.02, 0), material=white)
        kit.add(BOX, ((back + front) / 2, 0, z + step * 0.55), ((front - back) / 2 - 0.0, width * 1.012, step * 0.22), (0.995, 1), material=window)
        back += rng.uniform(0.05, 0.28) if k >= decks // 3 else 0.03
        front -= rng.uniform(0.05, 0.25)
        z += step
    kit.add(BOX, (front + 0.02, 0, z + 0.06), (0.14, wide * 1.02, 0.06), (0.85, 1), material=white)
    kit.add(BOX, (front + 0.04, 0, z + 0.075), (0.14, wide * 1.0, 0.025), (0.95, 1), material=glazing(kit))
    kit.add(BOX, ((back + front) / 2, 0, z + 0.01), ((front - back) / 2, wide * 0.8, 0.012), material=kit.material(base=rng.choice([[0.05, 0.2, 0.15], [0.4, 0.25, 0.12], [0.05, 0.15, 0.35]])))
    stack = kit.material(base=rng.choice([[0.5, 0.04, 0.03], [0.03, 0.1, 0.4], [0.75, 0.45, 0.03], [0.8] * 3]), pattern=rng.choice([PLAIN, BANDS]), frequency=9)
    tall = rng.uniform(0.16, 0.28)
    for k in range(1 if river or kit.chance(0.6) else int(rng.choice([2, 3, 4]))):
        at = back + (front - back) * (0.25 + 0.2 * k)
        if kit.chance(0.5) or k:
            kit.add(CYL, (at, 0, z + tall), (0.15, 0.11, tall), (0.95, 1), rotation=turn("y", -6), material=stack)
            kit.add(CYL, (at - 0.02, 0, z + 2 * tall), (0.14, 0.1, 0.03), material=dark)
        else:
            kit.add(BOX, (at, 0, z + tall * 0.9), (0.24, 0.17, tall * 0.9), (0.6, 0.75), (-0.12, 0), material=stack)
            kit.add(BOX, (at - 0.07, 0, z + tall * 1.85), (0.1, 0.1, 0.03), material=dark)
    if not river:
        orange = kit.material(base=[0.75, 0.2, 0.02] if kit.chance(0.7) else [0.8] * 3, pattern=PLAIN)
        boats = int(rng.integers(2, 6))
        for k in range(boats):
            at = -long * 0.55 + long * 0.95 * (k + 0.5) / boats
            kit.add(BALL, (at, wide * 1.02, deck + step * 1.1), (0.15, 0.06, 0.06), material=orange, mirror=True)
    mast = front - 0.25
    kit.between((mast, 0, z), (mast - 0.06, 0, z + 0.35), 0.025, taper=0.5, material=white)
    kit.add(BALL, (mast - 0.4, 0.12, z + 0.06), (0.07, 0.07, 0.08), material=white, mirror=kit.chance(0.5))
    if kit.chance(0.5):
        kit.add(BOX, (long * 0.2, 0, deck * 0.45), (long * 0.5, wide * 1.012, 0.02), material=stack)
    if kit.chance(0.4):
        kit.add(BOX, (-long * 0.99, 0, deck * 0.7), (0.03, wide * 0.55, deck * 0.25), material=dark)
    for y in (-1, 1):
        kit.railing((-long * 0.95, y * wide * 0.9, deck), (-long * 0.8, y * wide * 0.95, deck), 0.06, white, 0.05)


def hovercraft(kit):
    """Hovercraft on an inflated skirt: passenger, military with a ramp, and one-seaters; shrouded propellers and rudders aft."""
    rng = kit.rng
    body = navy(kit) if kit.chance(0.35) else white_paint(kit) if kit.chance(0.4) else kit.material(pattern=PLAIN, gloss=0.3)
    rubber, dark, glass, trim = kit.material(base=np.ones(3) * rng.uniform(0.015, 0.08), pattern=RIBS, frequency=rng.uniform(6, 20), gloss=0.1), kit.material(dark=True), glazing(kit), kit.material()
    small, long = kit.chance(0.3), rng.uniform(1.5, 1.9)
    wide, skirt = long * rng.uniform(0.42, 0.55), rng.uniform(0.2, 0.3)
    kit.add(BOX, (-long * 0.1, 0, skirt), (long * 0.78, wide * 0.93, skirt), (1.02, 1.08), material=rubber)
    kit.add(CYL, (long * 0.62, 0, skirt), (long * 0.36, wide * 0.95, skirt), (1.06, 1), material=rubber)
    kit.add(CYL, (-long * 0.1, wide * 0.97, skirt * 1.2), (skirt * 0.7, skirt * 0.5, long * 0.78), rotation=ALONG_X, material=rubber, mirror=True)
    deck = 2 * skirt
    kit.add(BOX, (-long * 0.08, 0, deck + 0.03), (long * 0.8, wide * 0.98, 0.05), material=body)
    kit.add(CYL, (long * 0.62, 0, deck + 0.03), (long * 0.34, wide * 0.9, 0.05), material=body)
    cabin = rng.uniform(0.16, 0.26)
    if small:
        kit.add(BOX, (long * 0.1, 0, deck + 0.14), (long * 0.5, wide * 0.4, 0.12), (0.85, 0.7), material=body)
        kit.add(BOX, (long * 0.42, 0, deck + 0.35), (0.015, wide * 0.34, 0.14), (1, 0.8), (-0.1, 0), material=glass)
        kit.add(BOX, (-long * 0.15, 0, deck + 0.3), (0.35, 0.15, 0.08), material=dark)
        kit.between((long * 0.3, -0.22, deck + 0.42), (long * 0.3, 0.22, deck + 0.42), 0.025, material=dark)
        kit.between((long * 0.3, 0, deck + 0.2), (long * 0.3, 0, deck + 0.42), 0.03, material=dark)
        if kit.chance(0.6):
            crew(kit, (-0.15, 0, deck + 0.42), (0.6, 0.2, 0.1), (0.4, 0.28, -0.32), 0.75)
    elif kit.chance(0.6):
        kit.add(BOX, (long * 0.1, 0, deck + cabin), (long * 0.55, wide * 0.72, cabin), (0.92, 0.9), material=body)
        kit.add(BOX, (long * 0.1, 0, deck + cabin * 1.2), (long * 0.53, wide * 0.725, cabin * 0.32), (0.96, 0.965), material=ports(kit, 14))
        kit.add(BOX, (long * 0.5, 0, deck + cabin * 1.9), (long * 0.14, wide * 0.4, cabin * 0.6), (0.8, 0.85), (-0.05, 0), material=body)
        kit.add(BOX, (long * 0.5, 0, deck + cabin * 2.1), (long * 0.142, wide * 0.39, cabin * 0.28), (0.88, 0.93), (-0.03, 0), material=glass)
        kit.add(BOX, (0, 0, deck + cabin * 0.35), (long * 0.66, wide * 0.74, 0.03), material=trim)
    else:
        for y in (-1, 1):
            kit.add(BOX, (-long * 0.08, y * wide * 0.78, deck + cabin * 0.8), (long * 0.62, wide * 0.17, cabin * 0.8), (0.94, 0.9), material=body)
        kit.add(BOX, (long * 0.42, -wide * 0.76, deck + cabin * 2.1), (long * 0.12, wide * 0.16, cabin * 0.55), (0.85, 0.9), material=body)
        kit.add(BOX, (long * 0.42, -wide * 0.76, deck + cabin * 2.2), (long * 0.122, wide * 0.165, cabin * 0.25), (0.9, 0.95), material=glass)
        kit.add(BOX, (long * 0.86, 0, deck + 0.2), (0.03, wide * 0.5, 0.24), (1, 0.95), (0.2, 0), material=body)
        kit.add(BOX, (0, 0, deck + 0.18), (0.45, wide * 0.32, 0.14), (0.8, 0.85), material=kit.material())
    fans = [0] if small else [-wide * 0.5, wide * 0.5]
    duct = wide * (0.45 if small else 0.36)
    for y in fans:
        at = np.array([-long * 0.68, y, deck + duct * 1.15 + 0.08])
        kit.add(TUBE, at, (duct, duct, 0.16), rotation=ALONG_X, material=body if kit.chance(0.6) else dark)
        kit.add(TUBE, at, (duct * 0.97, duct * 0.97, 0.16), rotation=ALONG_X, material=dark)
        propeller(kit, at, duct * 0.94, ALONG_X, trim if kit.chance(0.3) else dark, int(rng.choice([4, 5])))
        kit.between(at + [0.04, 0, -duct * 1.2], at + [0.04, 0, 0], (0.06, 0.04), BOX, material=body)
        kit.add(BOX, at + [0, 0, -duct * 1.05], (0.18, duct * 0.6, 0.12), material=body)
        for k in (-0.4, 0.4):
            kit.add(BOX, at + [-0.25, k * duct, 0], (0.1, 0.015, duct * 0.9), material=trim)
    if not small:
        kit.between((long * 0.4, 0, deck + cabin), (long * 0.38, 0, deck + cabin * 4), 0.02, material=dark)
        kit.add(BOX, (long * 0.42, 0, deck + cabin * 3.3), (0.02, 0.14, 0.025), material=dark)


def patrol_boat(kit):
    """Patrol and coast-guard boats: a grey or striped hull, a wheelhouse, a mast with radar, a gun before it."""
    rng = kit.rng
    guard = kit.chance(0.4)
    side = white_paint(kit) if guard else navy(kit)
    house, dark, steel = side if kit.chance(0.7) else white_paint(kit), kit.material(dark=True), navy(kit)
    long, wide, deck = rng.uniform(1.9, 2.4), rng.uniform(0.36, 0.46), rng.uniform(0.34, 0.44)
    shoulder = hull(kit, long, wide, deck, side, antifouling(kit), rng.uniform(0.2, 0.27), rng.uniform(0.25, 0.5), 0.95, 0.28)
    kit.add(BOX, (-long * 0.2, 0, deck), (long * 0.76, wide * 0.96, 0.015), material=kit.material(base=np.ones(3) * rng.uniform(0.1, 0.3)))
    if guard:
        stripe = kit.material(base=[0.7, 0.1, 0.02] if kit.chance(0.6) else [0.02, 0.1, 0.4], pattern=PLAIN)
        kit.add(BOX, (shoulder * 0.8, 0, deck * 0.65), (0.14, wide * 1.01, deck * 0.36), (1, 1.0), (-0.2, 0), material=stripe)
        kit.add(BOX, (shoulder * 0.8 - 0.26, 0, deck * 0.65), (0.05, wide * 1.01, deck * 0.36), (1, 1.0), (-0.2, 0), material=kit.material(base=[0.02, 0.06, 0.3]))
    x, tall = rng.uniform(-0.1, 0.1) * long, rng.uniform(0.16, 0.22)
    kit.add(BOX, (x - 0.2, 0, deck + tall), (long * 0.36, wide * 0.72, tall), (0.92, 0.88), (-0.03, 0), material=house)
    top = deck + 2 * tall
    kit.add(BOX, (x, 0, top + tall * 0.9), (long * 0.17, wide * 0.6, tall * 0.9), (0.8, 0.85), (-0.06, 0), material=house)
    kit.add(BOX, (x, 0, top + tall * 0.95), (long * 0.165, wide * 0.585, tall * 0.35), (0.9, 0.93), (-0.025, 0), material=glazing(kit))
    roof = top + 1.8 * tall
    kit.add(BOX, (x - 0.04, 0, roof), (long * 0.16, wide * 0.58, 0.02), material=house)
    for y in (0.15, -0.15):
        kit.between((x - 0.25, y, top), (x - 0.18, 0, roof + 0.5), 0.022, material=steel)
    kit.between((x - 0.18, 0, roof), (x - 0.18, 0, roof + rng.uniform(0.6, 0.9)), 0.025, taper=0.5, material=steel)
    kit.add(BOX, (x - 0.12, 0, roof + 0.3), (0.025, 0.18, 0.03), rotation=turn("z", rng.uniform(0, 80)), material=dark)
    if kit.chance(0.6):
        kit.add(BALL, (x - 0.02, 0, roof + 0.1), (0.1, 0.1, 0.11), material=white_paint(kit))
    kit.between((x - 0.18, -0.25, roof + 0.45), (x - 0.18, 0.25, roof + 0.45), 0.014, material=steel)
    gun = np.array([shoulder * 0.9 + 0.1, 0, deck + 0.03])
    kit.add(CYL, gun, (0.15, 0.15, 0.05), material=steel)
    if kit.chance(0.6):
        kit.add(BOX, gun + [0, 0, 0.16], (0.16, 0.13, 0.13), (0.7, 0.75), (-0.03, 0), material=steel)
        kit.between(gun + [0.1, 0, 0.17], gun + [rng.uniform(0.5, 0.7), 0, 0.24], 0.022, material=dark)
    else:
        kit.between(gun, gun + [0, 0, 0.2], 0.03, material=dark)
        kit.between(gun + [-0.15, 0, 0.22], gun + [0.45, 0, 0.25], 0.025, material=dark)
        kit.add(BOX, gun + [0.08, 0, 0.22], (0.012, 0.15, 0.12), (1, 0.8), material=steel)
    if kit.chance(0.5):
        kit.add(CYL, (x - long * 0.32, 0, top + 0.12), (0.13, 0.1, 0.16), (0.8, 1), material=steel)
    if kit.chance(0.6):
        kit.add(BALL, (-long * 0.72, 0, deck + 0.14), (0.3, 0.13, 0.09), material=kit.material(base=[0.75, 0.25, 0.03]) if kit.chance(0.5) else dark)
        kit.add(BOX, (-long * 0.72, 0, deck + 0.05), (0.2, 0.1, 0.05), material=dark)
        kit.between((-long * 0.5, wide * 0.5, deck), (-long * 0.62, 0.1, deck + 0.42), 0.025, material=steel)
    elif not guard:
        for y in (-1, 1):
            kit.between((-long * 0.75, y * wide * 0.55, deck + 0.1), (-long * 0.4, y * wide * 0.75, deck + 0.24), 0.09, material=steel)
    for y in (-1, 1):
        kit.railing((-long * 0.95, y * wide * 0.9, deck), (shoulder, y * wide * 0.96, deck), 0.14, steel, 0.2, thick=0.008)
        kit.railing((shoulder, y * wide * 0.96, deck), (long * 0.9, y * wide * 0.25, deck * 1.1), 0.16, steel, 0.2, thick=0.008)
    kit.add(BOX, (-long * 1.0, 0, deck + 0.3), (0.1, 0.006, 0.07), material=kit.material(pattern=BANDS))
    kit.between((-long * 0.94, 0, deck), (-long * 0.94, 0, deck + 0.38), 0.01, material=steel)
    kit.add(BOX, (x - 0.2, 0, deck + tall * 1.2), (long * 0.33, wide * 0.7, 0.03), (0.96, 0.97), material=ports(kit, 12))
