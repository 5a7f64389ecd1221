"""Makers of attack helicopters: Apache, Cobra, Mi-24, Tiger and Mangusta, Ka-52."""

import numpy as np

from .flyers import panel
from .kit import ALONG_X
from .layout import BALL, BOX, CYL
from .rotors import Hull, boom, cockpit, engines, gear, hull, main_rotor, pane, skids, tail_rotor, windows


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
