"""What troops bear: guns and how they are aimed, swords."""

import numpy as np

from .figures import plain
from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import STREAKS
from .physiques import framed

# Guns: length, then where along it lie the grip, the fore hand, the receiver's end and the stock's end.
GUNS = {
    "rifle": (0.92, 0.3, 0.55, 0.5, 0.26),
    "bolt": (1.12, 0.33, 0.6, 0.5, 0.34),
    "musket": (1.45, 0.36, 0.74, 0.45, 0.36),
    "smg": (0.68, 0.26, 0.46, 0.46, 0.2),
    "mg": (1.1, 0.3, 0.52, 0.6, 0.25),
    "sniper": (1.2, 0.3, 0.55, 0.55, 0.27),
    "launcher": (1.15, 0.55, 0.72, 0.5, 0.2),
}


def grips(kind, butt, along):
    """Where the left and the right hand hold a gun whose butt and direction are given."""
    along = np.array(along, float) / np.linalg.norm(along)
    _, grip, fore, _, _ = GUNS[kind]
    at = np.array(butt, float)
    return at + along * fore - [0, 0, 0.02], at + along * (grip - 0.02) - [0, 0, 0.05]


def gun(kit, f, kind, butt, along, bayonet=False):
    """A rifle, musket, machine gun or launcher; butt and direction as the chest turns, or in the world when butt is placed there."""
    rng = kit.rng
    long, grip, fore, body, stock = GUNS[kind]
    along = along / np.linalg.norm(along)
    frame = framed(along, np.cross([0, 0, 1.0], along) if abs(along[2]) < 0.95 else np.array([0.0, 1, 0]))
    up = frame[:, 0] * (-1 if frame[2, 0] < 0 or (abs(along[2]) >= 0.95 and frame[0, 0] > 0) else 1)
    sign = np.sign(up @ frame[:, 0])
    dark = plain(kit, np.ones(3) * rng.uniform(0.015, 0.05), 0.2)
    wood = kit.material(base=np.array([0.3, 0.16, 0.07]) * rng.uniform(0.5, 1.5), pattern=STREAKS, gloss=0.15)
    furniture = wood if kind in ("bolt", "musket") or (kind in ("rifle", "mg") and kit.chance(0.3)) else dark if kit.chance(0.7) else plain(kit, [0.35, 0.28, 0.18])

    def part(kind, s, u, half, material, tilt=0.0, taper=(1, 1)):
        """half: up, across, along."""
        kit.add(kind, f.place(butt + along * s + up * u), np.array(half) * f.b.size, taper, rotation=frame @ turn("y", tilt * sign), material=material)

    if kind == "launcher":
        part(CYL, 0.45, 0.06, (0.055, 0.055, 0.57), furniture if furniture is not wood else dark)
        part(CYL, -0.1, 0.06, (0.075, 0.075, 0.06), dark, taper=(0.75, 1))
        part(CYL, 1.02, 0.06, (0.07, 0.07, 0.05), dark)
        part(BOX, 0.6, 0.16, (0.05, 0.03, 0.06), dark)
        for s in (grip, fore):
            part(BOX, s, -0.04, (0.06, 0.018, 0.022), dark, 12)
        if kit.chance(0.4):
            part(CYL, 1.16, 0.06, (0.05, 0.05, 0.12), plain(kit, [0.12, 0.14, 0.07]), taper=(0.15, 1))
        return
    part(BOX, stock / 2, -0.012, (0.06, 0.02, stock / 2 + 0.01), furniture, 4, (0.55, 0.9))
    part(BOX, (stock + body) / 2, 0.02, (0.035, 0.022, (body - stock) / 2 + 0.02), dark if kind not in ("bolt", "musket") else furniture)
    part(BOX if kind not in ("musket", "bolt") else CYL, (body + fore + 0.12) / 2, 0.02, (0.028, 0.024, (fore + 0.12 - body) / 2 + 0.02), furniture, 0, (0.9, 0.9))
    part(CYL, (body + long) / 2, 0.032, (0.013, 0.013, (long - body) / 2), dark)
    if kind in ("rifle", "smg", "mg", "sniper"):
        part(BOX, grip - 0.02, -0.055, (0.05, 0.016, 0.022), dark, 18)
    if kind in ("rifle", "smg"):
        part(BOX, grip + 0.12, -0.075, (0.08, 0.014, 0.03), dark, -10)
        part(BOX, grip + 0.15, -0.15, (0.035, 0.013, 0.028), dark, -26)
        if kit.chance(0.5):
            part(CYL, grip + 0.1, 0.085, (0.022, 0.022, 0.06), dark)
    elif kind == "mg":
        part(BOX, grip + 0.14, -0.07, (0.07, 0.06, 0.06), plain(kit, [0.12, 0.13, 0.07]))
        part(BOX, grip + 0.3, 0.09, (0.012, 0.012, 0.07), dark)
    elif kind == "sniper":
        part(CYL, grip + 0.1, 0.095, (0.026, 0.026, 0.15), dark)
        part(BOX, grip + 0.12, -0.04, (0.04, 0.014, 0.03), dark)
    if kind in ("rifle", "bolt"):
        part(BOX, long - 0.06, 0.055, (0.025, 0.006, 0.012), dark)
    if bayonet:
        part(BOX, long + 0.15, 0.01, (0.016, 0.005, 0.19), plain(kit, [0.6, 0.6, 0.62], 0.5), 0, (0.3, 1))


def aim(kit, weapon, stance):
    """A Figure's arguments, and the gun's butt and direction, for a stance with a gun."""
    rng = kit.rng
    legs = {"stand": rng.choice(["stride", "stand", "crouch"]), "kneel": "kneel", "walk": "walk", "guard": "apart"}[stance]
    how = (
        rng.choice(["aim", "aim", "low", "port"])
        if stance in ("stand", "kneel") and weapon != "launcher"
        else "aim"
        if stance != "walk" or weapon == "launcher"
        else rng.choice(["low", "port"])
    )
    if stance == "guard":
        how = rng.choice(["low", "port"]) if weapon != "launcher" else "aim"
    if how == "aim":
        butt, along = ((0.1, -0.13, 0.53), (0.8, 0.6, 0.0)) if weapon != "launcher" else ((-0.3, -0.2, 0.58), (0.88, 0.47, 0.05))
        args = {
            "twist": -36 if weapon != "launcher" else -26,
            "lean": rng.uniform(3, 9),
            "look": turn("z", 34 if weapon != "launcher" else 24) @ turn("x", 8) @ turn("y", 8),
        }
    elif how == "low":
        butt, along = (0.15, -0.17, 0.43), (0.5, 0.62, -0.15 if stance == "kneel" else -0.55)
        args = {"lean": rng.uniform(2, 10), "look": turn("z", rng.uniform(-20, 20)) @ turn("y", 3)}
    else:
        butt, along = (0.17, -0.25, 0.06), (0.14, 0.6, 0.78)
        args = {"lean": rng.uniform(0, 6), "look": turn("z", rng.uniform(-20, 20)) @ turn("y", 3)}
    left, right = grips(weapon, butt, along)
    args |= {"legs": legs, "hands": [left, right * [1, -1, 1]], "fists": True}
    return args, np.array(butt), np.array(along)


def sword(kit, hand, along, long, steel, leather, gold, curved=False):
    along = np.array(along, float) / np.linalg.norm(along)
    kit.between(hand - along * 0.1, hand + along * 0.08, 0.017, material=leather)
    if curved:
        kit.between(hand + along * 0.075, hand + along * 0.09, 0.045, material=gold)
        middle, bend = hand + along * (0.08 + long * 0.55), np.array([-0.05, 0, 0.0])
        kit.between(hand + along * 0.08, middle, (0.018, 0.006), BOX, material=steel)
        kit.between(middle - along * 0.005, middle + along * long * 0.45 + bend, (0.018, 0.006), BOX, 0.6, material=steel)
        return
    kit.add(BOX, hand + along * 0.09, (0.02, 0.11 if long > 0.6 else 0.05, 0.016), rotation=framed(along, np.array([0.0, 1, 0])), material=gold)
    kit.add(BALL, hand - along * 0.11, (0.026,) * 3, material=gold)
    kit.add(BOX, hand + along * (0.1 + long / 2), (0.007, 0.026, long / 2), (1, 0.55), rotation=framed(along, np.array([0.0, 1, 0])), material=steel)
