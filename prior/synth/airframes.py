"""What the makers of aeroplanes by their real types share: materials, bodies, wings, wheels, roundels, airscrews, fans, cockpits, canopies."""

from typing import NamedTuple

import numpy as np

from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BOX, CYL
from .materials import BANDS, CAMOUFLAGE, CLOUDY, PLAIN, SEAMS, STREAKS, STRIPES, Material

GREYS = [[0.3, 0.32, 0.35], [0.42, 0.44, 0.46], [0.2, 0.22, 0.25], [0.26, 0.33, 0.4], [0.5, 0.53, 0.55]]
EARTHS = [[0.1, 0.12, 0.06], [0.13, 0.15, 0.08], [0.38, 0.3, 0.18], [0.18, 0.2, 0.17], [0.3, 0.22, 0.12]]
SECONDS = [[0.04, 0.06, 0.03], [0.12, 0.07, 0.03], [0.1, 0.1, 0.11], [0.2, 0.2, 0.2]]
GAY = [[0.65, 0.03, 0.03], [0.75, 0.45, 0.02], [0.02, 0.08, 0.35], [0.02, 0.02, 0.025], [0.7, 0.2, 0.02], [0.02, 0.25, 0.1], [0.8, 0.8, 0.78]]


class Look(NamedTuple):
    """An aeroplane's materials."""

    skin: Material
    trim: Material
    metal: Material
    dark: Material
    glass: Material
    rubber: Material


class Panel(NamedTuple):
    """A wing's or tail's middles of chord at its root and tip, the chords there, its thickness over the chord."""

    root: np.ndarray
    tip: np.ndarray
    chord: float
    narrow: float
    thick: float
    lift: float


def looks(kit, style):
    """Materials of the style `grey`, `drab` or `gay`; bare metal at times."""
    rng = kit.rng
    if style == "gay":
        base = np.array(GAY[rng.integers(len(GAY))]) if kit.chance(0.6) else np.ones(3) * rng.uniform(0.6, 0.9)
        skin = kit.material(base=base, pattern=rng.choice([PLAIN, PLAIN, PLAIN, CLOUDY, STREAKS]), second=base * 0.85, gloss=rng.uniform(0.1, 0.5))
    elif kit.chance(0.1):
        skin = kit.material(base=np.ones(3) * rng.uniform(0.4, 0.65), pattern=SEAMS, second=np.ones(3) * 0.3, frequency=rng.uniform(9, 18), gloss=0.5)
    else:
        tones = GREYS if style == "grey" else EARTHS
        base = np.array(tones[rng.integers(len(tones))]) * rng.uniform(0.75, 1.25)
        second = base * rng.uniform(0.5, 0.75) if style == "grey" else np.array(SECONDS[rng.integers(len(SECONDS))])
        pattern = rng.choice([PLAIN, CAMOUFLAGE, CAMOUFLAGE, CLOUDY, SEAMS])
        second, often = (base * 0.7, rng.uniform(9, 18)) if pattern == SEAMS else (second, rng.uniform(3, 8))
        skin = kit.material(base=base, pattern=pattern, second=second, frequency=often, gloss=rng.uniform(0, 0.25))
    trim = kit.material(base=GAY[rng.integers(len(GAY))], pattern=rng.choice([PLAIN, PLAIN, STRIPES]), frequency=8, gloss=0.2) if style == "gay" or kit.chance(0.2) else skin
    metal = kit.material(base=np.ones(3) * rng.uniform(0.08, 0.3), pattern=rng.choice([PLAIN, BANDS, CLOUDY]), second=[0.12, 0.1, 0.09], gloss=0.3)
    glass = kit.material(base=np.array([0.04, 0.05, 0.06]) * rng.uniform(0.6, 2.5), pattern=PLAIN, gloss=0.6)
    return Look(skin, trim, metal, kit.material(base=[0.015] * 3, pattern=PLAIN, gloss=0.05), glass, kit.material(dark=True, pattern=PLAIN))


def hull(kit, stations, skin, y=0.0, box=False):
    """A body through stations [(x behind the nose, z, half width, half height), ...]; with y: one on either side."""
    for a, b in zip(stations[:-1], stations[1:], strict=True):
        if b[2] * b[3] > a[2] * a[3]:
            a, b = b, a
        start, end = np.array([-a[0], y, a[1]]), np.array([-b[0], y, b[1]])
        if box:
            way = np.sign(end[0] - start[0])
            middle = (start + end) / 2 * (1, 1, 0) + [0, 0, a[1]]
            kit.add(BOX, middle, (a[3], a[2], abs(end[0] - start[0]) / 2), (b[3] / a[3], b[2] / a[2]), (-way * (b[1] - a[1]), 0), turn("y", 90 * way), skin, y > 0)
        else:
            kit.between(start + (start - end) * 0.02, end, (a[3], a[2]), taper=np.sqrt(b[2] * b[3] / (a[2] * a[3])), material=skin, mirror=y > 0)


def surface(kit, row, skin, thick=0.05, lens=False):
    """A wing, tail or fin of a row of `panels`; `lens`: with a round section, for those that hardly sweep. Returns its Panel."""
    x, y, z, chord, span, sweep, tip, lift = row
    way = np.array([0, np.cos(np.radians(lift)), np.sin(np.radians(lift))])
    root = np.array([-x - chord / 2, y, z])
    back = span * np.tan(np.radians(sweep)) + (tip - chord) / 2
    end = root + way * span - [back, 0, 0]
    mirror = y > 0 or abs(lift) != 90
    if lens:
        rotation = turn("x", lift - 90) @ turn("y", -np.degrees(np.arctan2(back, span)))
        kit.add(CYL, (root + end) / 2, (chord / 2, thick * chord * 0.6, np.hypot(back, span) / 2), (tip / chord, 1), (0, 0), rotation, skin, mirror)
    else:
        kit.add(BOX, root + way * span / 2, (chord / 2, thick * chord / 2, span / 2), (tip / chord, 0.8 * tip / chord), (-back, 0), turn("x", lift - 90), skin, mirror)
    return Panel(root, end, chord, tip, thick, lift)


def on(panel, share, fore=0.0):
    """A point of a Panel's middle plane, `share` of its span out and `fore` of the chord there before its middle."""
    return panel.root + (panel.tip - panel.root) * share + [fore * (panel.chord + (panel.narrow - panel.chord) * share), 0, 0]


def wheel(kit, x, y, ground, radius, look, top, twin=False, inner=None):
    """A leg from the height `top` down to one wheel, or a pair of them; with y: one on either side."""
    z = radius - ground
    kit.between((-x, y if inner is None else inner, top), (-x, y, z), radius * 0.22, material=look.metal, mirror=y > 0)
    kit.add(CYL, (-x, y, z), (radius, radius, radius * (0.75 if twin else 0.36)), rotation=ALONG_Y, material=look.rubber, mirror=y > 0)


def roundels(kit, panel, share, size):
    """Round marks on both wings."""
    ring = kit.material(base=GAY[kit.rng.choice([0, 2, 2, 5])], pattern=PLAIN)
    core = kit.material(base=[[0.75] * 3, [0.65, 0.03, 0.03]][kit.rng.integers(2)], pattern=PLAIN)
    half = panel.thick * (panel.chord + (panel.narrow - panel.chord) * share) * 0.6
    for radius, paint, more in ((size, ring, 0.015), (size * 0.5, core, 0.03)):
        kit.add(CYL, on(panel, share), (radius, radius, half + more), rotation=turn("x", panel.lift), material=paint, mirror=True)


def airscrew(kit, at, radius, look, blades=None, boss=0.1, mirror=False):
    """A pointed boss with blades, before `at`; with `mirror`, one on either side."""
    blades, first, wide = blades or int(kit.rng.choice([2, 3, 4])), kit.rng.uniform(0, 120), kit.rng.uniform(0.06, 0.085)
    at = np.array(at, float)
    kit.add(CYL, at + [boss * 0.8, 0, 0], (boss, boss, boss), (0.25, 1), rotation=ALONG_X, material=look.trim, mirror=mirror)
    whole = blades % 2 == 0
    for k in range(blades // 2 if whole else blades):
        spin = turn("x", first + 360 * k / blades)
        middle = at + [boss * 0.8, 0, 0] + (0 if whole else radius / 2) * spin[:, 2]
        kit.add(BOX, middle, (0.03 * radius, wide * radius, radius if whole else radius / 2), rotation=spin, material=look.dark, mirror=mirror)


def cockpit(kit, x, z, wide, high, look, long=0.8):
    """Slanting front windows across the body and others at its sides."""
    kit.add(BOX, (-x, 0, z), (long, wide, high), (0.55, 0.72), (-long * 0.35, 0), material=look.glass)


def fan(kit, at, radius, long, look, skin, pylon=None):
    """A fan engine on either side: cowl, dark mouth with its boss, hot nozzle; `pylon`: height of the wing above."""
    at = np.array(at, float)
    if pylon:
        kit.add(BOX, at + [-long * 0.75, 0, pylon / 2], (long * 0.8, radius * 0.12, pylon / 2 + 0.1), (1, 1), (-long * 0.4, 0), material=look.skin, mirror=True)
    kit.add(CYL, at, (radius, radius, long), (0.8, 1), rotation=turn("y", -90), material=skin, mirror=True)
    kit.add(CYL, at + [long, 0, 0], (radius * 0.84, radius * 0.84, 0.04), rotation=ALONG_X, material=look.dark, mirror=True)
    kit.add(BALL, at + [long, 0, 0], (radius * 0.35, radius * 0.25, radius * 0.25), material=look.metal, mirror=True)
    kit.add(CYL, at - [long * 1.3, 0, 0], (radius * 0.6, radius * 0.6, long * 0.35), (0.55, 1), rotation=turn("y", -90), material=look.metal, mirror=True)


def canopy_frames(kit, x, z, long, wide, high, look):
    """A glass canopy with a hoop or two over it."""
    kit.add(BALL, (-x, 0, z), (long, wide, high), material=look.glass)
    for share in (0.25, -0.3)[: int(kit.rng.integers(0, 3))]:
        fit = np.sqrt(1 - share**2) * 1.02
        kit.add(CYL, (-x + long * share, 0, z), (high * fit, wide * fit, 0.03), rotation=ALONG_X, material=look.skin)


def tilted(kit, start, degrees):
    """What was made since `start` sits on its tail wheel, nose up."""
    tilt = turn("y", -degrees)
    kit.primitives[start:] = [p._replace(centre=tilt @ p.centre, rotation=tilt @ p.rotation) for p in kit.primitives[start:]]
