"""A maker of helicopters by their real types, in service and civil liveries; drawn here: utility and heavy ones."""

import numpy as np

from .attack_helicopters import alligator, apache, cobra, hind, tiger
from .flyers import panel
from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL
from .light_helicopters import alouette, egg, fenestron_copter, gazelle, jet_ranger, robinson
from .materials import PLAIN, RIBS
from .rotors import Hull, boom, cockpit, draw_look, engines, extras, gear, hull, main_rotor, markings, pane, skids, stripe, tail_rotor, windows

ROLES = ["army", "navy", "rescue", "police", "civil"]


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
