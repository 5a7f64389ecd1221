"""Bodies of people in poses: limbs of two bones, clothes, hats, hair."""


import numpy as np

from .kit import turn
from .layout import BALL, CYL
from .materials import CHECKER, CLOUDY, PLAIN, STRIPES
from .people import hair_material, skin_material

THIGH, SHIN, UPPER, FORE = 0.43, 0.42, 0.29, 0.27  # lengths in metres of somebody 1.75 m tall
HIP, SHOULDER = 0.9, 0.52  # above the ground, and above the hips


class Outfit:
    """What somebody wears, drawn at random but for what is given."""

    def __init__(self, kit, top=None, bottom=None, shoes=None, hat=None, cover=None, skirt=False, bare=None, skin=None, hair=None):
        rng = kit.rng
        self.skin = skin or skin_material(kit)
        self.hair = hair or hair_material(kit)
        self.top = top or kit.material(pattern=rng.choice([PLAIN, PLAIN, STRIPES, CHECKER, CLOUDY]), frequency=rng.uniform(6, 16), gloss=0.05)
        self.bottom = bottom or kit.material(pattern=rng.choice([PLAIN, PLAIN, CLOUDY]), gloss=0.05)
        self.shoes = shoes or kit.material(dark=kit.chance(0.7))
        self.hat = rng.choice(["none", "none", "long", "cap", "brim", "bun"]) if hat is None else hat
        self.cover = cover or kit.material(pattern=PLAIN)
        self.skirt = skirt
        self.bare = (kit.chance(0.35), kit.chance(0.15)) if bare is None else bare  # forearms, shins
        self.wide = rng.uniform(0.9, 1.15)


def bent(start, end, first, second, hint):
    """The joint between two bones, towards `hint`, and where their end comes to lie."""
    away = end - start
    far = max(np.linalg.norm(away), 1e-6)
    away = away / far
    far = np.clip(far, abs(first - second) + 0.01, first + second - 0.004)
    along = (first**2 - second**2 + far**2) / (2 * far)
    side = hint - away * (hint @ away)
    side = side / max(np.linalg.norm(side), 1e-6)
    return start + along * away + np.sqrt(max(first**2 - along**2, 0)) * side, start + far * away


def somebody(
    kit,
    outfit,
    hips=(0, 0, HIP),
    lean=None,
    hands=None,
    feet=None,
    at=(0, 0, 0),
    yaw=0,
    size=1.0,
    look=None,
    knees=(1, 0, 0),
    elbows=(-0.4, 0, -0.6),
    toes=0,
    small=False,
):
    """A body of about 28 primitives (`small`: 22) that looks along x, turned by `yaw`: hips, hands and feet (left, right) where they are told to be."""
    rng = kit.rng
    spin, at = turn("z", yaw), np.array(at, float)
    trunk = turn("y", rng.uniform(0, 5)) if lean is None else lean
    hips = np.array(hips, float)
    wide = outfit.wide
    hands = [(rng.uniform(-0.05, 0.12), y * rng.uniform(0.24, 0.3), hips[2] - 0.04) for y in (1, -1)] if hands is None else hands
    feet = [(rng.uniform(-0.05, 0.08), 0.12, 0.07), (rng.uniform(-0.05, 0.08), -0.12, 0.07)] if feet is None else feet
    facing = turn("z", rng.normal(0, 12)) @ turn("y", rng.normal(4, 5)) if look is None else look

    def place(p):
        return at + spin @ np.array(p, float) * size

    def part(kind, p, half, material, frame=trunk, taper=(1, 1)):
        kit.add(kind, place(p), np.array(half) * size, taper, rotation=spin @ frame, material=material)

    def limb(start, end, radius, taper, material):
        kit.between(place(start), place(end), radius * size, CYL, taper, material)

    def high(x, y, z):
        return hips + trunk @ np.array([x, y, z])

    part(BALL, high(0, 0, 0.03), (0.12, 0.165 * wide, 0.13), outfit.bottom)
    part(CYL, high(0, 0, 0.2), (0.1 * wide, 0.14 * wide, 0.17), outfit.top, taper=(1.12, 1))
    part(BALL, high(0.01, 0, 0.38), (0.125 * wide, 0.18 * wide, 0.17), outfit.top)
    part(BALL, high(0, 0, 0.5), (0.075, 0.2 * wide, 0.065), outfit.top)
    head = high(0.02, 0, 0.72)
    for foot, side in zip(feet, (1, -1), strict=True):
        joint = high(0, side * 0.085 * wide, -0.02)
        knee, ankle = bent(joint, np.array(foot, float), THIGH, SHIN, np.array(knees) + [0, 0.15 * side, 0])
        limb(joint, knee, 0.088 * wide, 0.72, outfit.bottom)
        if not small:
            part(BALL, knee, (0.064 * wide,) * 3, outfit.bottom)
        limb(knee, ankle, 0.062 * wide, 0.66, outfit.skin if outfit.bare[1] else outfit.bottom)
        tread = turn("z", side * rng.uniform(2, 15)) @ turn("y", toes if np.isscalar(toes) else toes[0 if side == 1 else 1])
        part(BALL, ankle + tread @ np.array([0.06, 0, -0.025]), (0.135, 0.05, 0.048), outfit.shoes, tread)
    for hand, side in zip(hands, (1, -1), strict=True):
        shoulder = high(0, side * 0.19 * wide, SHOULDER - 0.03)
        elbow, wrist = bent(shoulder, np.array(hand, float), UPPER, FORE, np.array(elbows) + [0, 0.5 * side, 0])
        limb(shoulder, elbow, 0.055 * wide, 0.8, outfit.top)
        if not small:
            part(BALL, elbow, (0.044 * wide,) * 3, outfit.top)
        limb(elbow, wrist, 0.043 * wide, 0.7, outfit.skin if outfit.bare[0] else outfit.top)
        part(BALL, wrist, (0.05, 0.038, 0.05), outfit.skin, np.eye(3))
    limb(high(0, 0, 0.5), head - facing @ np.array([0.01, 0, 0.06]), 0.052, 1, outfit.skin)

    def on_head(kind, p, half, material, taper=(1, 1)):
        part(kind, head + facing @ np.array(p), half, material, facing, taper)

    on_head(BALL, (0, 0, 0), (0.092, 0.075, 0.115), outfit.skin)
    dressed(kit, outfit, on_head)
    on_head(CYL, (0.092, 0, -0.015), (0.014, 0.016, 0.024), outfit.skin, (0.4, 1))
    if outfit.skirt:
        long = rng.uniform(0.2, 0.38)
        part(CYL, hips + [0, 0, 0.08 - long], (0.21, 0.24 * wide, long), outfit.bottom, np.eye(3), (0.6, 1))
    if not small:
        dark = kit.material(base=[0.03, 0.02, 0.02], pattern=PLAIN)
        for y in (0.03, -0.03):
            on_head(BALL, (0.08, y, 0.015), (0.012, 0.014, 0.011), dark)
    return place


def dressed(kit, outfit, on_head):
    """Hair, a helmet or a hat."""
    hat = outfit.hat
    if hat == "bald":
        return
    if hat == "helmet":
        on_head(BALL, (-0.01, 0, 0.045), (0.13, 0.115, 0.1), outfit.cover)
        on_head(CYL, (0.0, 0, 0.03), (0.14, 0.122, 0.012), outfit.cover)
    elif hat == "hood":
        on_head(BALL, (-0.025, 0, 0.01), (0.1, 0.098, 0.14), outfit.cover)
    elif hat in ("cap", "brim"):
        on_head(BALL, (-0.02, 0, 0.01), (0.092, 0.085, 0.1), outfit.hair)
        on_head(CYL, (-0.005, 0, 0.085), (0.105, 0.092, 0.045), outfit.cover, (0.85, 1))
        wide = (0.085, 0.075) if hat == "cap" else (0.18, 0.165)
        on_head(CYL, (0.075 if hat == "cap" else 0, 0, 0.05), (*wide, 0.008), outfit.cover)
    else:
        on_head(BALL, (-0.02, 0, 0.035), (0.097, 0.085, 0.1), outfit.hair)
        if hat == "long":
            on_head(BALL, (-0.06, 0, -0.08), (0.06, 0.09, 0.15), outfit.hair)
        elif hat == "bun":
            on_head(BALL, (-0.11, 0, 0.06), (0.05, 0.05, 0.05), outfit.hair)
