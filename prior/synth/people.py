"""Makers of people: standing, walking, sitting and kneeling, each arm, the trunk and the head in a pose of its own."""

import numpy as np

from .kit import turn
from .layout import BALL, BOX, CYL, PRIMS
from .materials import paint

HIP = 0.9  # heights in metres of somebody 1.75 m tall


def skin_material(kit):
    tone = kit.rng.uniform(0.15, 1)
    return kit.material(base=np.array([0.62, 0.4, 0.29]) * tone, pattern=0, gloss=0.05)


def hair_material(kit):
    return kit.material(base=paint(0.08, kit.rng.uniform(0, 0.8), kit.rng.uniform(0.02, 0.6)), pattern=kit.rng.choice([0, 1]))


class Body:
    """A body's frames: points of the legs' frame, level, and of the trunk's, which leans and turns above the hips."""

    def __init__(self, base, size, hip, aside, lean, twist):
        self.base = np.array(base, float)
        self.size = size
        self.pelvis = np.array([0, aside, hip])
        self.trunk = turn("z", twist) @ turn("x", lean[0]) @ turn("y", lean[1])

    def low(self, x, y, z):
        """A point by its height above the ground."""
        return self.base + self.size * np.array([x, y, z])

    def high(self, x, y, z):
        """A point by its height above the hips, which the trunk takes along."""
        return self.base + self.size * (self.pelvis + self.trunk @ np.array([x, y, z]))


def person_body(kit, base, size, top, bottom, skin, pose=None):
    """Somebody of height about 1.75 `size` on `base`, looking along x, of at most 40 primitives."""
    rng = kit.rng
    pose = pose or rng.choice(["stand", "stand", "walk", "sit", "kneel"], p=[0.3, 0.3, 0.2, 0.13, 0.07])
    stone = top is bottom
    hip = {"sit": 0.47, "kneel": 0.52}.get(pose, HIP)
    resting = rng.choice([-1, 1]) if pose == "stand" else 0  # the leg that bears the weight
    lean = (resting * rng.uniform(0, 7), rng.normal(0, 4) + (4 if pose == "walk" else 0))
    body = Body(base, size, hip, resting * rng.uniform(0, 0.05), lean, rng.normal(0, 14))
    wide, slim = rng.uniform(0.85, 1.2), rng.uniform(0.62, 0.98)
    shoulders = rng.uniform(0.16, 0.21) * wide
    legs(kit, body, pose, resting, wide, bottom, skin, stone)
    trunk(kit, body, wide, slim, shoulders, top, bottom, stone)
    arms(kit, body, pose, shoulders, wide, top, skin, stone)
    head(kit, body, skin, stone)


def legs(kit, body, pose, resting, wide, cloth, skin, stone):
    rng = kit.rng
    size = body.size
    shoe = cloth if stone else kit.material(dark=kit.chance(0.7))
    bare = not stone and kit.chance(0.15)
    flared = rng.uniform(0.5, 1.15)
    thick = rng.uniform(0.075, 0.1) * size * wide
    stride = rng.uniform(0.12, 0.42)
    for side in (-1, 1):
        apart = side * rng.uniform(0.07, 0.14) * wide
        joint = body.base + size * (body.pelvis + np.array([0, side * 0.09 * wide, -0.04]))
        if pose == "sit":
            out = rng.uniform(-0.05, 0.15)
            knee, ankle = body.low(0.44, apart * 1.3, 0.49), body.low(0.44 + out, apart * rng.uniform(0.5, 1.5), 0.07)
        elif pose == "kneel":
            up = side > 0
            knee = body.low(0.38 if up else 0.12, apart, 0.5 if up else 0.08)
            ankle = body.low(0.36, apart, 0.07) if up else body.low(-0.32, apart, 0.08)
        elif pose == "walk":
            knee, ankle = body.low(0.6 * max(side, 0) * stride + 0.04, apart * 0.9, 0.5), body.low(side * stride, apart, 0.08 if side > 0 else 0.14)
        else:
            loose = 0.0 if side == resting else rng.uniform(0, 0.14)
            knee = body.low(0.02 + loose, apart + side * loose * 0.4, 0.48)
            ankle = body.low(loose * rng.uniform(-0.6, 1.2), apart + side * loose * rng.uniform(0, 1.2), 0.07)
        shin = skin if bare else cloth
        kit.add(BALL, joint, (thick * 1.15,) * 3, material=cloth)
        kit.chain([joint, knee], [thick * 1.15, thick * 0.8], cloth)
        kit.between(knee, ankle, thick * 0.8, CYL, max(0.45, flared), shin)
        ahead = turn("z", side * rng.uniform(-5, 25)) @ np.array([0.07, 0, -0.03]) * size
        kit.add(BALL, ankle + ahead, (0.135 * size, 0.05 * size, 0.052 * size), rotation=turn("z", side * 10), material=shoe)


def trunk(kit, body, wide, slim, shoulders, top, bottom, stone):
    rng = kit.rng
    size = body.size
    deep = rng.uniform(0.1, 0.15) * wide

    def part(x, y, z, half, material):
        kit.add(BALL, body.high(x, y, z), np.array(half) * size, rotation=body.trunk, material=material)

    part(0, 0, 0.02, (deep, 0.17 * wide, 0.15), bottom)
    part(0, 0, 0.2, (deep * 0.95, 0.17 * wide * slim, 0.19), top)
    part(0.01, 0, 0.4, (deep * 1.1, shoulders + 0.01, 0.19), top)
    part(-0.005, 0, 0.52, (deep * 0.6, shoulders + 0.02, 0.07), top)
    if kit.chance(0.4):
        for side in (-1, 1):
            part(deep * 0.75, side * 0.075, 0.38, (0.075, 0.075, 0.08), top)
    below = rng.random()
    if below < 0.3:  # a skirt, a dress or a coat
        long = rng.uniform(0.15, 0.42) if body.pelvis[2] > 0.8 else 0.12
        cloth = bottom if kit.chance(0.5) else top
        middle = body.base + size * (body.pelvis + np.array([0, 0, 0.1 - long]))
        kit.add(CYL, middle, (0.2 * size, 0.23 * size * wide, long * size), (rng.uniform(0.55, 0.85), 1), material=cloth)
    elif below < 0.55 and not stone:
        kit.add(CYL, body.high(0, 0, 0.08), (deep * 1.06 * size, 0.172 * wide * size, 0.025 * size), rotation=body.trunk, material=kit.material(dark=True))
    if stone:
        return
    if kit.chance(0.18):  # a vest with pouches
        vest = kit.material()
        part(0.01, 0, 0.33, (deep * 1.3, shoulders, 0.24), vest)
        for y in (-0.08, 0.03):
            kit.add(BOX, body.high(deep * 1.25, y, rng.uniform(0.2, 0.34)), np.array([0.035, 0.045, 0.06]) * size, rotation=body.trunk, material=vest)
    if kit.chance(0.2):
        bag = np.array([0.09, 0.15, 0.22]) * size * rng.uniform(0.7, 1.2)
        kit.add(BOX, body.high(-deep - 0.08, 0, rng.uniform(0.28, 0.42)), bag, rotation=body.trunk, material=kit.material())


def arms(kit, body, pose, shoulders, wide, cloth, skin, stone):
    rng = kit.rng
    size = body.size
    fore = cloth if stone or kit.chance(0.6) else skin
    upper = skin if fore is skin and kit.chance(0.15) else cloth
    thick = rng.uniform(0.045, 0.065) * size * wide
    both = rng.choice(["each", "each", "each", "carry", "up"])
    hands = []
    for side in (-1, 1):
        how = both if both != "each" else rng.choice(["hang", "hang", "hip", "ahead", "raised", "across", "behind"])
        shoulder = body.high(0, side * shoulders, 0.5)
        out = side * (shoulders + rng.uniform(0.03, 0.1))
        swing = -side * rng.uniform(0.05, 0.2) if pose == "walk" else rng.uniform(-0.06, 0.08)
        elbow, hand = {
            "hang": ((swing * 0.5, out, 0.23), (swing + 0.05, out + side * rng.uniform(-0.05, 0.05), rng.uniform(-0.06, 0.02))),
            "hip": ((-0.08, side * (shoulders + 0.2), 0.25), (0.06, side * 0.17 * wide, 0.08)),
            "ahead": ((0.06, out, 0.25), (0.3, out * rng.uniform(0.3, 1), 0.25 + rng.uniform(-0.1, 0.2))),
            "raised": ((0.1, out + side * 0.1, 0.5 + rng.uniform(-0.1, 0.25)), (0.15, out + side * rng.uniform(-0.1, 0.2), 0.75 + rng.uniform(0, 0.25))),
            "across": ((0.08, out, 0.24), (0.2, -side * 0.04, 0.28 + rng.uniform(-0.08, 0.08))),
            "behind": ((-0.12, out, 0.25), (-0.15, side * 0.03, 0.05)),
            "carry": ((0.04, out, 0.24), (0.27, side * 0.1, 0.27)),
            "up": ((0.05, out + side * 0.05, 0.6), (0.08, side * rng.uniform(0.05, 0.3), 0.88)),
        }[how]
        elbow, hand = body.high(*elbow), body.high(*hand)
        kit.add(BALL, shoulder, (thick * 1.1,) * 3, material=upper)
        kit.chain([shoulder, elbow], [thick, thick * 0.8], upper)
        kit.between(elbow, hand, thick * 0.8, CYL, 0.65, fore)
        kit.add(BALL, hand, np.array([0.05, 0.035, 0.06]) * size, rotation=body.trunk, material=skin)
        hands.append(hand)
    if stone:
        return
    what = rng.random()
    if both == "carry" and what < 0.4:
        kit.add(BOX, body.high(0.3, 0, 0.3), rng.uniform(0.06, 0.2, 3) * size, rotation=body.trunk, material=kit.material())
    elif both == "carry" and what < 0.8:  # a rifle or a tool
        metal = kit.material(dark=True)
        start, end = body.high(0.18, -0.28, 0.18), body.high(0.3, 0.34, 0.42)
        kit.between(start, start + 0.45 * (end - start), (0.02 * size, 0.045 * size), BOX, material=metal)
        kit.between(start + 0.4 * (end - start), end, 0.014 * size, CYL, material=metal)
    elif what < 0.12:
        kit.between(hands[1], hands[1] - np.array([0, 0, rng.uniform(0.3, 0.6) * size]), 0.012 * size, CYL, material=kit.material())
    elif what < 0.25:
        drop = np.array([0, 0, 0.2 * size])
        kit.add(BOX, hands[0] - drop, np.array([0.16, 0.05, 0.13]) * size, material=kit.material())


def head(kit, body, skin, stone):
    rng = kit.rng
    size = body.size
    facing = body.trunk @ turn("z", rng.normal(0, 22)) @ turn("y", rng.normal(3, 8))
    kit.between(body.high(-0.01, 0, 0.53), body.high(0.01, 0, 0.68), 0.05 * size, material=skin)
    centre = body.high(0.015, 0, 0.77)

    def at(x, y, z):
        return centre + facing @ np.array([x, y, z]) * size

    def ball(where, half, material):
        kit.add(BALL, at(*where), np.array(half) * size, rotation=facing, material=material)

    ball((0, 0, 0), (0.095, 0.077, 0.12), skin)
    kit.add(CYL, at(0.095, 0, -0.015), np.array([0.012, 0.016, 0.025]) * size, (0.4, 1), rotation=facing, material=skin)
    hair = skin if stone else hair_material(kit)
    style = rng.random()
    if style < 0.08:
        return
    if style < 0.22 and not stone:  # a helmet or a cap
        hat = kit.material()
        ball((-0.005, 0, 0.05), (0.125, 0.11, 0.1), hat)
        if kit.chance(0.5):
            kit.add(CYL, at(0.07, 0, 0.045), np.array([0.1, 0.09, 0.008]) * size, rotation=facing, material=hat)
        return
    if style < 0.3 and not stone:
        hat = kit.material()
        kit.add(CYL, at(0, 0, 0.11), np.array([0.1, 0.1, 0.06]) * size, (0.85, 1), rotation=facing, material=hat)
        kit.add(CYL, at(0.02, 0, 0.06), np.array([0.17, 0.15, 0.01]) * size, rotation=facing, material=hat)
        return
    ball((-0.025, 0, 0.035), (0.1, 0.09, 0.105), hair)
    if style < 0.6:  # down to the shoulders, or further
        long = rng.uniform(0.09, 0.24)
        ball((-0.06, 0, 0.02 - long), (rng.uniform(0.05, 0.08), rng.uniform(0.08, 0.13), long), hair)
        for side in (-1, 1):
            ball((0.0, side * 0.075, -0.04), (0.05, 0.03, rng.uniform(0.08, 0.14)), hair)
    elif style < 0.7:
        ball((-0.12, 0, rng.uniform(0.0, 0.1)), (0.05, 0.05, 0.05), hair)


def person(kit):
    """One person or two, some with something to sit on."""
    rng = kit.rng
    pose = rng.choice(["stand", "walk", "sit", "kneel"], p=[0.5, 0.22, 0.2, 0.08])
    person_body(kit, (0, 0, 0), 1.0, kit.material(), kit.material(), skin_material(kit), pose)
    if pose == "sit":
        kit.add(BOX, (-0.08, 0, 0.2), (0.25, 0.25, 0.2), material=kit.material())
        if kit.chance(0.6):
            kit.add(BOX, (-0.31, 0, 0.6), (0.03, 0.25, 0.4), material=kit.material())
    if kit.chance(0.2):
        alone = len(kit.primitives)
        beside = rng.uniform((-0.2, 0.5, 0), (0.3, 0.75, 0))
        person_body(kit, beside, rng.uniform(0.6, 1.05), kit.material(), kit.material(), skin_material(kit))
        if len(kit.primitives) > PRIMS:
            del kit.primitives[alone:]
