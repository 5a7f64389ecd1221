"""Makers of light helicopters: JetRanger, MD 500, EC135 and kin, Robinson, Gazelle, Alouette."""

import numpy as np

from .flyers import panel
from .kit import ALONG_X, turn
from .layout import BALL, BOX, CYL
from .materials import PLAIN
from .rotors import boom, cockpit, extras, fenestron, hull, main_rotor, markings, pane, skids, stripe, tail_rotor, windows


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
