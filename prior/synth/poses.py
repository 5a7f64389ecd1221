"""Makers of single people of true anatomy in many poses and clothes, and of soldiers and others in full kit, of any age."""

from types import SimpleNamespace

import numpy as np

from .bodies import FORE, SHIN, THIGH, UPPER, bent
from .figures import bar, carved, hair_on, hat_on, head_frame, plain
from .kit import ALONG_X, ALONG_Y, mirrored, towards, turn
from .layout import BALL, BOX, CYL, GRID, PRISM, RUNGS
from .materials import BANDS, CAMOUFLAGE, CHECKER, CLOUDY, DOTS, PATCHWORK, PLAIN, PLANKS, RIBS, STREAKS, STRIPES, WRITING, paint
from .people import hair_material, skin_material

HEIGHT = 0.93  # of the hips' middle, of somebody 1.75 m tall
WAIST = 0.14  # above the hips, where the trunk bends

# Hands (left, right) against the hips' middle, as the chest turns; y outwards.
ARMS = {
    "hang": [(0.04, 0.29, -0.05), (0.06, 0.28, -0.04)],
    "hips": [(0.04, 0.2, 0.06), (0.04, 0.2, 0.06)],
    "hip": [(0.04, 0.2, 0.06), (0.05, 0.28, -0.04)],
    "crossed": [(0.2, -0.12, 0.28), (0.22, -0.11, 0.33)],
    "up": [(0.05, 0.36, 1.0), (0.05, 0.36, 1.0)],
    "wave": [(0.04, 0.28, -0.04), (0.14, 0.42, 0.78)],
    "point": [(0.04, 0.28, -0.04), (0.55, 0.25, 0.52)],
    "aside": [(0.05, 0.74, 0.5), (0.05, 0.28, -0.04)],
    "behind": [(-0.16, 0.05, 0.02), (-0.16, 0.05, 0.04)],
    "pray": [(0.24, 0.03, 0.38), (0.24, 0.03, 0.38)],
    "carry": [(0.32, 0.17, 0.17), (0.32, 0.17, 0.17)],
    "pockets": [(0.08, 0.19, -0.03), (0.08, 0.19, -0.03)],
    "chin": [(0.2, -0.06, 0.25), (0.16, 0.02, 0.55)],
    "run": [(-0.18, 0.25, 0.17), (0.3, 0.17, 0.36)],
    "walk": [(-0.17, 0.25, 0.0), (0.22, 0.24, 0.03)],
    "salute": [(0.02, 0.24, -0.05), (0.13, 0.15, 0.76)],
    "photo": [(0.2, 0.07, 0.66), (0.2, 0.07, 0.66)],
    "read": [(0.3, 0.1, 0.3), (0.3, 0.1, 0.3)],
    "phone": [(0.04, 0.28, -0.04), (0.09, 0.13, 0.66)],
    "guard": [(0.36, 0.12, 0.5), (0.24, 0.1, 0.5)],
    "punch": [(0.22, 0.1, 0.5), (0.62, 0.06, 0.48)],
    "throw": [(0.45, 0.2, 0.6), (-0.22, 0.33, 0.78)],
    "push": [(0.5, 0.16, 0.4), (0.5, 0.16, 0.4)],
    "tee": [(0.02, 0.74, 0.5), (0.02, 0.74, 0.5)],
    "overhead": [(0.02, 0.04, 1.05), (0.02, 0.04, 1.05)],
    "flow": [(0.12, 0.2, 1.0), (0.15, 0.66, 0.42)],
    "fly": [(0.2, 0.6, 0.75), (-0.2, 0.62, 0.45)],
    "climb": [(0.38, 0.2, 0.86), (0.41, 0.2, 0.6)],
    "head": [(-0.09, 0.1, 0.72), (-0.09, 0.1, 0.72)],
    "knees": [(0.36, 0.15, 0.1), (0.36, 0.15, 0.1)],
    "lap": [(0.24, 0.04, 0.08), (0.24, 0.04, 0.11)],
    "shins": [(0.44, 0.05, 0.22), (0.46, 0.05, 0.25)],
    "props": [(-0.26, 0.28, -0.02), (-0.26, 0.28, -0.02)],
}
# Legs (left, right) by angles: lift from straight down and azimuth (0 ahead, 90 outwards, 180 behind) of thigh, then of shin; pitch of the toes.
BY_ANGLE = {
    "run": [(62, 0, 28, 180, 5), (22, 180, 48, 180, 48)],
    "sprint": [(80, 0, 12, 180, -5), (30, 180, 38, 180, 50)],
    "tree": [(2, 90, 1, 90, 0), (62, 88, 55, -92, 55)],
    "warrior": [(72, 20, 2, 0, 0), (48, 160, 50, 160, 10)],
    "arabesque": [(4, 0, 4, 180, 0), (85, 172, 92, 178, 95)],
    "kick": [(4, 180, 8, 180, 0), (82, 0, 72, 0, -20)],
    "high_knee": [(3, 0, 3, 180, 0), (88, 0, 6, 180, 5)],
    "leap": [(75, 0, 80, 0, 40), (75, 180, 95, 180, 110)],
    "seiza": [(82, 8, 92, 180, 170), (82, 8, 92, 180, 170)],
    "both_knees": [(6, 0, 92, 180, 165), (6, 0, 92, 180, 165)],
    "ground": [(82, 10, 98, 5, -55), (125, 10, 45, 8, 0)],
    "lotus": [(82, 48, 86, -62, -10), (84, 50, 88, -58, -10)],
    "hug": [(140, 8, 40, 5, 0), (142, 8, 38, 5, 0)],
    "back": [(89, 6, 91, 4, -75), (89, 6, 91, 4, -75)],
    "back_bent": [(89, 6, 91, 4, -75), (140, 8, 42, 4, 0)],
    "prone": [(88, 165, 90, 172, 155), (88, 166, 90, 175, 155)],
    "inverted": [(177, 90, 177, 90, -85), (177, 90, 177, 90, -85)],
    "scissors": [(150, 0, 160, 0, -70), (145, 180, 150, 180, -110)],
    "pushup": [(72, 178, 72, 178, 45), (72, 178, 72, 178, 45)],
    "crawl": [(4, 0, 93, 178, 165), (20, 180, 92, 178, 165)],
    "climb": [(62, 42, 28, 180, 0), (14, 20, 12, 180, 5)],
    "cross_seat": [(85, 4, 3, 0, 0), (80, -14, 32, 10, 10)],
    "seat": [(86, 8, 3, 0, 0), (86, 8, 6, 180, 0)],
    "seat_out": [(86, 8, 28, 0, -15), (86, 10, 8, 180, 0)],
    "split": [(70, 4, 70, 4, 45), (70, 176, 72, 178, 120)],
}
# Legs by where the ankles are, y outwards: the hips' height, then ankle, where the knee points and the toes' pitch.
BY_PLACE = {
    "stand": (HEIGHT, [((0.02, 0.11, 0.075), (1, 0, 0), 0), ((-0.02, 0.11, 0.075), (1, 0, 0), 0)]),
    "attention": (HEIGHT, [((0, 0.06, 0.075), (1, 0, 0), 0), ((0, 0.06, 0.075), (1, 0, 0), 0)]),
    "rest": (HEIGHT - 0.01, [((0, 0.08, 0.075), (1, 0, 0), 0), ((0.14, 0.17, 0.075), (1, 0.3, 0), 0)]),
    "apart": (HEIGHT - 0.03, [((0, 0.24, 0.075), (1, 0.3, 0), 0), ((0, 0.24, 0.075), (1, 0.3, 0), 0)]),
    "walk": (HEIGHT - 0.045, [((0.33, 0.08, 0.095), (1, 0, 0), -18), ((-0.34, 0.08, 0.13), (1, 0, 0), 35)]),
    "stride": (HEIGHT - 0.1, [((0.36, 0.14, 0.075), (1, 0.1, 0), 0), ((-0.36, 0.16, 0.085), (1, 0.3, 0), 8)]),
    "squat": (0.36, [((0.12, 0.17, 0.075), (1, 0.35, 0.6), 0), ((0.04, 0.17, 0.1), (1, 0.35, 0.6), 12)]),
    "kneel": (0.5, [((0.38, 0.13, 0.075), (1, 0, 0), 0), ((-0.4, 0.12, 0.09), (1, 0, -0.2), 60)]),
    "crouch": (0.66, [((0.22, 0.15, 0.075), (1, 0.2, 0.2), 0), ((-0.22, 0.16, 0.09), (1, 0.3, 0.2), 15)]),
    "lean": (HEIGHT - 0.045, [((0.26, 0.09, 0.075), (1, 0, 0), 0), ((0.3, 0.07, 0.075), (1, 0, 0), 0)]),
}
UPRIGHT = ("stand", "attention", "rest", "walk")


def direction(lift, azimuth, side):
    a, b = np.radians(lift), np.radians(azimuth)
    return np.array([np.sin(a) * np.cos(b), side * np.sin(a) * np.sin(b), -np.cos(a)])


def framed(along, y):
    """A rotation whose z lies along `along` and whose y is near `y`."""
    z = along / max(np.linalg.norm(along), 1e-9)
    x = np.cross(y, z)
    x /= max(np.linalg.norm(x), 1e-9)
    return np.stack([x, np.cross(z, x), z], 1)


def lowest(p):
    """The least z of a primitive."""
    r = p.rotation[2] * p.half
    return p.centre[2] - {BALL: np.linalg.norm(r), BOX: np.abs(r).sum()}.get(p.kind, abs(r[2]) + np.hypot(r[0], r[1]))


def fabric(kit, base=None, bold=0.4):
    pattern = kit.rng.choice([STRIPES, CHECKER, DOTS, BANDS, CLOUDY, PATCHWORK]) if kit.chance(bold) else PLAIN
    return kit.material(base=base, pattern=pattern, frequency=kit.rng.uniform(6, 18), gloss=kit.rng.uniform(0, 0.08))


def build(kit, kind):
    """Somebody's proportions."""
    rng = kit.rng
    b = SimpleNamespace(kind=kind, woman=kind == "woman" or (kind in ("child", "old", "heavy") and kit.chance(0.5)), size=1.0, head=1.0, legs=1.0, belly=0.0)
    b.shoulder, b.hip, b.waist, b.deep = rng.uniform(0.175, 0.2), rng.uniform(0.15, 0.168), rng.uniform(0.128, 0.148), rng.uniform(0.108, 0.13)
    b.arm, b.leg, b.stoop = rng.uniform(0.95, 1.2), rng.uniform(0.95, 1.15), 0
    if b.woman:
        b.shoulder, b.hip, b.waist, b.deep = rng.uniform(0.15, 0.168), rng.uniform(0.16, 0.185), rng.uniform(0.108, 0.13), rng.uniform(0.095, 0.112)
        b.arm, b.leg, b.size = rng.uniform(0.78, 0.95), rng.uniform(0.92, 1.12), 0.94
    if kind == "child":
        young = rng.uniform(0, 1)
        b.size, b.head, b.legs = 0.72 - 0.2 * young, 1.2 + 0.4 * young, 0.93 - 0.12 * young
        b.shoulder, b.hip, b.waist, b.belly = 0.15, 0.145, 0.125, 0.02 * young
    elif kind == "old":
        b.stoop, b.size, b.belly, b.arm = rng.uniform(6, 20), b.size * 0.96, rng.uniform(0, 0.04), b.arm * 0.9
    elif kind == "heavy":
        fat = rng.uniform(0.04, 0.09)
        b.belly, b.hip, b.waist, b.arm, b.leg = fat, b.hip + fat * 0.5, b.waist + fat, b.arm * 1.25, b.leg * 1.25
    return b


def clothe(kit, stone=None, **more):
    """What somebody wears: materials; sleeves 0 to 2 and trousers 0 to 2 long; how wide the trousers end."""
    rng = kit.rng
    w = SimpleNamespace(stone=stone is not None, sleeves=2, trousers=2, cut=rng.choice([0.75, 0.85, 1.0, 1.3]), hem=None, hem_wide=1.0, thick=1.0, skirt=None, seat=None)
    names = ("skin", "hair", "top", "bottom", "shoes", "gloves", "socks", "arm")
    if w.stone:
        w.__dict__.update(dict.fromkeys(names, stone))
    else:
        w.skin, w.hair, w.top, w.bottom = skin_material(kit), hair_material(kit), fabric(kit), fabric(kit, bold=0.15)
        w.shoes, w.gloves, w.socks, w.arm = kit.material(dark=kit.chance(0.6), pattern=PLAIN), None, None, None
    w.__dict__.update(more)
    w.gloves, w.socks, w.arm, w.skirt, w.seat = w.gloves or w.skin, w.socks or w.skin, w.arm or w.top, w.skirt or w.bottom, w.seat or w.bottom
    return w


class Figure:
    """A body of 40 to 50 primitives in a pose; the frames and places that what it wears and holds needs."""

    def __init__(self, kit, b, w, legs="stand", arms="hang", lean=0.0, twist=0.0, roll=0.0, pelvis=None, look=None, hands=None, world=False, fists=False, up=None):
        self.kit, self.b, self.w, self.legs = kit, b, w, legs
        rng, first = kit.rng, len(kit.primitives)
        pelvis = np.eye(3) if pelvis is None else pelvis
        spine = turn("z", twist) @ turn("y", lean) @ turn("x", roll)
        if legs == "rest":
            pelvis, spine = pelvis @ turn("x", 5), spine @ turn("x", -rng.uniform(6, 10))
        self.pelvis, self.trunk = pelvis, pelvis @ spine
        self.look = turn("z", rng.normal(0, 12)) @ turn("y", rng.normal(3, 4) - b.stoop * 0.7) if look is None else look
        self.hips, self.at = np.zeros(3), np.zeros(3)
        placed = BY_PLACE.get(legs)
        if placed:
            self.hips = np.array([0, 0.03 if legs == "rest" else 0, 0.075 + (placed[0] - 0.075) * b.legs])
        if up is not None:
            self.hips[2] = up
        self.body()
        self.bones = [self.leg(side, (placed[1] if placed else BY_ANGLE[legs])[side < 0]) for side in (1, -1)]
        hands = hands or ARMS[arms]
        self.elbows, bend = [], np.array([-0.5, 1.8, -0.2]) if arms in ("hips", "hip", "head", "salute") else np.array([-0.4, 0.45, -0.6])
        self.hands = [self.arm(side, p, world, fists, bend) for side, p in zip((1, -1), hands, strict=True)]
        self.top()
        drop = min(lowest(p) for p in kit.primitives[first:]) if world is False or placed is None else 0
        if not world:
            kit.primitives[first:] = [p._replace(centre=p.centre - [0, 0, drop]) for p in kit.primitives[first:]]
            self.at = np.array([0, 0, -drop])
            self.hands, self.elbows = [p + self.at for p in self.hands], [p + self.at for p in self.elbows]
            self.bones = [tuple(p + self.at for p in bone) for bone in self.bones]
        self.feet = [bone[0] for bone in self.bones]

    def place(self, p):
        return np.array(p, float) * self.b.size + self.at

    def low(self, x, y, z):
        return self.hips + self.pelvis @ np.array([x, y, z], float)

    def high(self, x, y, z):
        return self.hips + self.pelvis @ np.array([0, 0, WAIST]) + self.trunk @ np.array([x, y, z - WAIST], float)

    def chest(self, kind, p, half, material, taper=(1, 1), tilt=None, mirror=False, low=False, shift=(0, 0)):
        """A part that goes along with the chest, or (`low`) with the pelvis."""
        frame = self.pelvis if low else self.trunk
        for side in (1, -1) if mirror else (1,):
            flip = np.diag([1, side, 1])
            spun = np.eye(3) if tilt is None else flip @ tilt @ flip
            where = (self.low if low else self.high)(p[0], p[1] * side, p[2])
            self.kit.add(kind, self.place(where), np.array(half) * self.b.size, taper, (shift[0], shift[1] * side), frame @ spun, material)

    def limb(self, start, end, radius, taper, material, kind=CYL):
        self.kit.between(self.place(start), self.place(end), np.array(radius) * self.b.size, kind, taper, material)

    def ball(self, p, half, material, frame=None, kind=BALL, taper=(1, 1), shift=(0, 0)):
        half = np.broadcast_to(np.array(half, float), 3) * self.b.size
        self.kit.add(kind, self.place(p), half, taper, shift, rotation=frame, material=material)

    def wrap(self, bone, start, end, radius, material, kind=CYL, taper=1.0):
        """Something around the shins (bone 0) or thighs (1), between two shares of their length from the foot up."""
        for joints in self.bones:
            low, high = joints[bone], joints[bone + 1]
            self.kit.between(low + (high - low) * start, low + (high - low) * end, np.array(radius) * self.b.size, kind, taper, material)

    def body(self):
        b, w = self.b, self.w
        self.chest(BALL, (-0.005, 0, 0.02), (b.deep + b.belly * 0.6, b.hip + 0.004, 0.135), w.seat, low=True)
        self.chest(BALL, (-0.055, 0.07, -0.035), (0.085, 0.085 + b.belly * 0.3, 0.1), w.seat, low=True, mirror=True)
        start, end = self.low(0, 0, 0.04), self.high(0, 0, 0.26)
        self.ball(
            (start + end) / 2, (b.deep * 0.9 + b.belly * 0.5, b.waist, np.linalg.norm(end - start) / 2), w.top, framed(end - start, self.trunk[:, 1]), CYL, (1.08, 1)
        )
        if b.belly:
            self.chest(BALL, (b.belly * 0.9, 0, 0.13), (b.deep + b.belly * 0.8, b.waist + b.belly * 0.2, 0.17), w.top)
        self.chest(BALL, (0.008, 0, 0.345), (b.deep * 1.12, b.shoulder * 0.93, 0.2), w.top)
        self.chest(BALL, (-0.01, 0, 0.48), (0.082, b.shoulder + 0.018, 0.07), w.top)
        self.chest(CYL, (-0.012, 0, 0.55), (0.07, b.shoulder * 0.68, 0.04), w.top if w.sleeves else w.skin, (0.52, 1))
        if b.woman and b.kind != "child":
            self.chest(BALL, (b.deep * 0.75, 0.07, 0.365), (0.07, 0.07, 0.075), w.top, mirror=True)

    def leg(self, side, how):
        b, w = self.b, self.w
        joint = self.low(0, side * b.hip * 0.53, -0.03)
        thigh, shin = THIGH * b.legs, SHIN * b.legs
        if len(how) == 5:
            knee = joint + thigh * direction(how[0], how[1], side)
            ankle, toe = knee + shin * direction(how[2], how[3], side), how[4]
        else:
            foot = np.array([how[0][0] * b.legs, how[0][1] * side, 0.075 + (how[0][2] - 0.075) * b.legs]) + [0, self.hips[1] * 0.7, 0]
            knee, ankle = bent(joint, foot, thigh, shin, np.array(how[1]) * [1, side, 1] + [0, 0.12 * side, 0])
            toe = how[2]
        r = b.leg
        cloth, lower = (w.bottom if w.trousers == 2 else w.skin), (w.bottom if w.trousers == 2 else w.socks)
        loose = 1.08 if w.trousers == 2 else 1.0
        if w.hem is not None and w.hem > 0.2:
            self.limb(joint, joint + (knee - joint) * 0.66, 0.08 * r, 0.8, w.skirt)
        if w.hem is None or w.hem > 0.2:
            start = joint if w.hem is None else joint + (knee - joint) * 0.5
            self.limb(
                start, knee, (0.089 if w.hem is None else 0.071) * r * loose, (0.7 if w.hem is None else 0.86) if w.trousers < 2 else max(0.74, w.cut * 0.76), cloth
            )
            self.ball(knee, 0.061 * r * loose * max(1, w.cut if w.trousers == 2 else 0), cloth)
            if w.trousers == 1:
                self.limb(joint, joint + (knee - joint) * 0.72, 0.098 * r, 0.92, w.bottom)
        wide = 0.059 * r * loose
        if w.trousers == 2:
            self.limb(knee, ankle, wide * max(1, w.cut), (0.72 if w.cut < 0.9 else 0.95 if w.cut < 1.2 else 1.1), lower)
        else:
            self.limb(knee, ankle, wide * 0.95, 0.62, lower)
        if w.hem is None and w.cut < 1.1 or w.trousers < 2:
            back = framed(knee - ankle, np.array([0.0, 1, 0])) if abs(knee[2] - ankle[2]) > 0.1 else towards(knee - ankle)
            self.ball(ankle + (knee - ankle) * 0.66 + back @ np.array([-0.018, 0, 0]), (0.056 * r, 0.054 * r, 0.13), lower, back)
        tread = turn("z", side * 9) @ turn("y", toe)
        self.ball(ankle + tread @ np.array([0.07, 0, -0.03]), (0.125, 0.047, 0.043), w.shoes, tread)
        self.ball(ankle + tread @ np.array([0.005, 0, -0.015]), (0.062, 0.043, 0.056), w.shoes, tread, CYL, (0.86, 1))
        return self.place(ankle), self.place(knee), self.place(joint)

    def arm(self, side, target, world, fists, bend):
        b, w = self.b, self.w
        shoulder = self.high(0, side * (b.shoulder - 0.005), 0.48)
        target = np.array(target, float)
        target = target if world else self.high(target[0], target[1] * side, target[2])
        hint = bend * [1, side, 1]
        elbow, wrist = bent(shoulder, target, UPPER, FORE, np.array([0, 0.3 * side, -1.0]) if world else self.trunk @ hint)
        r, skin = b.arm * w.thick, w.skin
        self.elbows.append(self.place(elbow))
        self.ball(shoulder, (0.064 * r, 0.062 * r, 0.07 * r), w.arm if w.sleeves else skin)
        self.limb(shoulder, elbow, 0.053 * r, 0.78, w.arm if w.sleeves == 2 else skin)
        if w.sleeves == 1:
            self.limb(shoulder, shoulder + (elbow - shoulder) * 0.55, 0.062 * r, 1.0, w.arm)
        fore = w.arm if w.sleeves == 2 else skin
        self.ball(elbow, 0.043 * r, fore)
        self.limb(elbow, wrist, 0.045 * r, 0.68 if w.sleeves < 2 else 0.8, fore)
        along = framed(wrist - elbow, self.trunk[:, 1])
        grip = (0.043, 0.034, 0.052) if fists else (0.04, 0.024, 0.085)
        self.ball(wrist + along @ np.array([0, 0, 0.03 if fists else 0.06]), grip, w.gloves, along)
        self.ball(wrist + along @ np.array([0.036, -side * 0.006, 0.035]), (0.016, 0.015, 0.045), w.gloves, along @ turn("y", 22))
        return self.place(wrist + along @ np.array([0, 0, 0.04]))

    def top(self):
        """Neck and head."""
        b, w = self.b, self.w
        half = 0.116 * b.head
        facing = self.trunk @ turn("y", b.stoop * -0.3) @ self.look
        base = self.high(0.02 + b.stoop * 0.001, 0, 0.585)
        centre = base + facing @ np.array([0.005, 0, half * 1.1])
        self.limb(self.high(-0.012, 0, 0.5), centre - facing @ np.array([0.02, 0, 0.02]), 0.053 if not b.woman else 0.045, 0.95, w.skin)
        self.facing, self.centre, self.half = facing, centre, half
        head = self.on_head()
        head(BALL, (-0.12, 0, 0.26), (0.83, 0.68, 0.74), w.skin)
        head(BALL, (0.2, 0, -0.22), (0.55, 0.55, 0.72), w.skin)
        head(BALL, (0.34, 0, -0.66), (0.36, 0.36 if not b.woman else 0.3, 0.3), w.skin)
        bar(head, (0.68, 0, 0.12), (0.84, 0, -0.2), 0.085, w.skin, 1.4)

    def on_head(self):
        return head_frame(self.kit, self.place(self.centre), self.half * self.b.size, self.facing)

    def face(self, ears=True):
        """Eyes, a mouth and ears."""
        w, head, kit = self.w, self.on_head(), self.kit
        if w.stone:
            head(BALL, (-0.04, 0.67, -0.03), (0.15, 0.07, 0.24), w.skin, mirror=True)
            return
        head(BALL, (0.66, 0.26, 0.05), (0.1, 0.12, 0.08), plain(kit, [0.03, 0.02, 0.015], 0.4), mirror=True)
        head(BALL, (0.69, 0, -0.5), (0.08, 0.2, 0.06), plain(kit, np.clip(w.skin.first * [0.9, 0.5, 0.45], 0.01, 1)))
        if ears:
            head(BALL, (-0.04, 0.67, -0.03), (0.15, 0.07, 0.24), w.skin, mirror=True)

    def belt(self, material, wide=0.025, z=0.1):
        b = self.b
        self.chest(CYL, (0, 0, z), (b.deep + b.belly * 0.9 + 0.004, max(b.waist + 0.012, b.hip * 0.93) + b.belly * 0.2, wide), material, low=True)

    def skirt(self, material, hem, wide=1.0, waist=0.12):
        """A skirt, coat or robe from the waist to the height `hem`, wide enough for the stride."""
        b = self.b
        top = self.low(0, 0, waist)
        feet = 0.36 * max(0, 1 - hem / 0.95) + 0.07 if self.legs == "walk" else 0.1
        x, y = max(0.17, feet + 0.02) * max(wide, 0.95) + b.belly * 0.5, (b.hip + 0.055) * wide
        mean = (max(b.deep, 0.1) + b.belly * 0.6 + 0.012) / x, (b.waist + 0.015) / y
        tall = top[2] - hem
        self.ball((top + [0, top[1], hem]) / 2 * [0, 1, 1], (x, y, tall / 2), material, None, CYL, (max(mean), 1))


def coat_front(f, jacket, shirt, tie=None, low=0.1, wide=0.05):
    """The shirt that shows in an open jacket, and its collar."""
    b = f.b
    x = b.deep * 1.12 + 0.012
    f.chest(BALL, (0.022, 0, 0.36), (b.deep * 1.12, wide * 1.6, 0.2), shirt)
    f.chest(BOX, (x - 0.035, 0, (0.3 + low) / 2), (0.035 + b.belly * 0.5, wide, (0.34 - low) / 2), shirt)
    if tie is not None:
        f.chest(BOX, (x + 0.016, 0, 0.34), (0.012, 0.022, 0.16), tie, (0.5, 1), (turn("y", -4)))
    f.chest(BOX, (x - 0.012, wide + 0.025, 0.4), (0.014, 0.032, 0.12), jacket, (1, 0.6), turn("x", 14) @ turn("y", -9), mirror=True)
    f.chest(CYL, (0.0, 0, 0.585), (0.063, 0.066, 0.025), shirt, (0.93, 1))


def buttons(f, material, count, low, high, y=0.0):
    for z in np.linspace(low, high, count):
        f.chest(BALL, (f.b.deep * 1.1 + 0.012 - 0.1 * max(z - 0.42, 0), y, z), (0.012, 0.012, 0.012), material)


OUTFITS = ["casual", "tee", "shorts", "suit", "jacket", "hoodie", "overalls", "sport", "swim"]


def outfit(kit, b, kind):
    rng = kit.rng
    if kind == "casual":
        return clothe(kit, bottom=fabric(kit, np.array([0.09, 0.13, 0.25]) * rng.uniform(0.4, 2.2), 0) if kit.chance(0.5) else None or fabric(kit, bold=0.1))
    if kind == "tee":
        return clothe(kit, sleeves=1)
    if kind == "shorts":
        return clothe(kit, sleeves=1, trousers=1)
    if kind in ("suit", "jacket", "coat"):
        cloth = (
            fabric(kit, rng.uniform(0.015, 0.3) * np.array([1, rng.uniform(0.75, 1), rng.uniform(0.6, 1.3)]), 0.12)
            if kind != "jacket" or kit.chance(0.4)
            else fabric(kit)
        )
        return clothe(kit, top=cloth, seat=cloth, bottom=cloth if kind == "suit" else fabric(kit, bold=0.1), thick=1.1, cut=rng.choice([0.85, 1.0]))
    if kind == "hoodie":
        return clothe(kit, top=fabric(kit, bold=0.2) if kit.chance(0.6) else kit.material(pattern=BANDS, frequency=rng.uniform(10, 18), gloss=0.15), thick=1.25)
    if kind == "overalls":
        return clothe(
            kit, bottom=fabric(kit, paint(rng.choice([0.6, 0.58, 0.08, 0.3, 0.12]), rng.uniform(0.3, 0.9), rng.uniform(0.1, 0.5)), 0), sleeves=rng.choice([1, 2]), cut=1.0
        )
    if kind == "sport":
        team = fabric(kit, paint(rng.random(), 0.9, rng.uniform(0.2, 0.9)), 0.3)
        return clothe(
            kit, top=team, bottom=fabric(kit, bold=0), sleeves=rng.choice([0, 1]), trousers=rng.choice([1, 1, 2]), cut=0.75, socks=team if kit.chance(0.4) else None
        )
    if kind == "swim":
        w = clothe(kit, sleeves=0, trousers=rng.choice([0, 1]) if not b.woman else 0)
        w.shoes = w.skin
        w.top = w.top if b.woman and kit.chance(0.5) else w.skin
        if w.top is not w.skin:
            w.bottom = w.seat = w.top
        return w
    cloth = fabric(kit, bold=0.5)
    if kind == "kilt":
        tartan = kit.material(
            base=paint(rng.choice([0.0, 0.33, 0.6]), 0.8, rng.uniform(0.1, 0.4)),
            pattern=CHECKER,
            frequency=rng.uniform(8, 14),
            second=paint(rng.choice([0.33, 0.6, 0.15]), 0.7, 0.1),
        )
        return clothe(kit, bottom=tartan, hem=0.5, trousers=0, socks=plain(kit, [0.7, 0.66, 0.55]), hem_wide=1.1)
    if kind == "skirt":
        return clothe(kit, hem=rng.uniform(0.3, 0.68), trousers=0, hem_wide=rng.uniform(0.85, 1.4), sleeves=rng.integers(3))
    if kind == "dress":
        return clothe(kit, top=cloth, bottom=cloth, hem=rng.uniform(0.05, 0.6), trousers=0, hem_wide=rng.uniform(0.9, 1.9), sleeves=rng.integers(3))
    if kind == "thobe":
        cloth = plain(kit, np.array([0.8, 0.78, 0.74]) * rng.uniform(0.5, 1.1))
    wide = {"sari": 1.0, "kimono": 0.95}.get(kind, rng.uniform(1.0, 1.2))
    return clothe(
        kit, top=cloth, bottom=cloth, hem=rng.uniform(0.03, 0.1), trousers=0, hem_wide=wide, sleeves=1 if kind == "sari" else 2, thick=1.0 if kind == "sari" else 1.25
    )


def garments(kit, f, kind):
    """What an outfit has beyond the body's own materials."""
    rng, b, w = kit.rng, f.b, f.w
    if w.hem is not None:
        f.skirt(w.skirt, w.hem, w.hem_wide)
    leather = kit.material(dark=True, pattern=PLAIN)
    if kind in ("casual", "tee", "shorts") and kit.chance(0.5):
        f.belt(leather)
    elif kind in ("casual", "tee", "shorts"):
        f.chest(CYL, (0, 0, 0.05), (b.deep + b.belly * 0.9 + 0.012, b.hip + 0.014, 0.07), w.top, (0.95, 1), low=True)
    if kind == "casual" and kit.chance(0.6):
        f.chest(CYL, (0.004, 0, 0.58), (0.07, 0.075, 0.022), w.top, (0.85, 1), turn("y", 8))
        buttons(f, kit.material(pattern=PLAIN), 3, 0.2, 0.45)
    if kind in ("suit", "jacket", "coat"):
        shirt = plain(kit, [0.75, 0.75, 0.75]) if kind == "suit" else fabric(kit)
        coat_front(f, w.top, shirt, fabric(kit) if kind == "suit" and kit.chance(0.7) else None)
        if kind == "coat":
            f.skirt(w.top, rng.uniform(0.3, 0.65), 1.05, 0.2)
            if kit.chance(0.5):
                f.belt(leather, 0.03, 0.15)
        else:
            f.chest(CYL, (0, 0, 0.0), (b.deep + b.belly * 0.9 + 0.025, b.hip + 0.025, 0.12), w.top, (0.9, 1), low=True)
    elif kind == "hoodie":
        f.chest(BALL, (-0.085, 0, 0.56), (0.075, 0.13, 0.09), w.top, tilt=turn("y", 20))
        f.chest(CYL, (0, 0, 0.08), (b.deep + b.belly + 0.022, b.hip + 0.018, 0.06), w.top, low=True)
        f.chest(BOX, (b.deep + b.belly + 0.01, 0, 0.15), (0.02, 0.1, 0.06), w.top, (1, 0.7))
    elif kind == "overalls":
        x = b.deep * 1.1 + b.belly * 0.7
        f.belt(w.bottom, 0.05)
        f.chest(BOX, (x - 0.02, 0, 0.28), (0.04, 0.11, 0.14), w.bottom, (1, 0.85))
        for y in (0.09, -0.09):
            f.limb(f.high(x, y, 0.4), f.high(0.0, y, 0.56), 0.018, 1, w.bottom, BOX)
            f.limb(f.high(0.0, y, 0.56), f.high(-b.deep * 1.1, y * 0.6, 0.3), 0.018, 1, w.bottom, BOX)
        f.chest(BOX, (x + 0.02, 0, 0.3), (0.01, 0.05, 0.04), w.bottom)
    elif kind == "swim" and b.woman and w.top is w.skin:
        f.chest(BALL, (b.deep * 0.78, 0.07, 0.365), (0.072, 0.074, 0.06), w.bottom, mirror=True)
        f.chest(CYL, (0.005, 0, 0.35), (b.deep * 1.13, b.shoulder * 0.95, 0.02), w.bottom)
    elif kind == "swim" and w.top is w.skin and b.kind != "child":
        f.chest(BALL, (b.deep * 0.72, 0.075, 0.39), (0.05, 0.08, 0.06), w.skin, mirror=True)
    elif kind == "sport" and kit.chance(0.5):
        f.chest(BOX, (b.deep * 1.08, 0, 0.36), (0.02, 0.06, 0.07), kit.material(base=[0.8, 0.8, 0.8], pattern=WRITING, frequency=6))
    elif kind == "sari":
        second = fabric(kit, bold=0.7)
        f.chest(BALL, (0.012, 0.0, 0.31), (b.deep * 1.15 + 0.035, 0.085, 0.3), second, tilt=turn("x", -30))
        f.chest(BOX, (-b.deep - 0.012, 0.11, 0.12), (0.02, 0.085, 0.4), second, (1, 0.75), turn("y", 5))
        f.chest(CYL, (0, 0, 0.06), (b.deep + 0.02, b.hip + 0.012, 0.05), second, (0.95, 1), low=True)
    elif kind == "kimono":
        f.chest(CYL, (0, 0, 0.17), (b.deep + 0.03, b.waist + 0.035, 0.085), fabric(kit))
        f.chest(BOX, (-b.deep - 0.06, 0, 0.2), (0.045, 0.12, 0.1), fabric(kit))
        for hand, elbow in zip(f.hands, f.elbows, strict=True):
            along = (hand - elbow) * [1, 1, 0] / 2
            wide = np.hypot(*along[:2])
            spin = turn("z", np.degrees(np.arctan2(along[1], along[0])))
            kit.add(BOX, (hand + elbow) / 2 - [0, 0, 0.1 * b.size], (max(wide * 0.8, 0.07), 0.035, 0.16 * b.size), rotation=spin, material=w.top)
        f.chest(BOX, (b.deep * 0.95, 0.05, 0.45), (0.02, 0.02, 0.14), plain(kit, [0.8, 0.8, 0.8]), tilt=turn("x", 20), mirror=True)
    elif kind == "kilt":
        f.chest(BOX, (b.deep + 0.045, 0, -0.1), (0.035, 0.07, 0.07), leather, (0.8, 0.8), low=True)
        f.belt(leather, 0.03, 0.12)
    elif kind in ("robe", "thobe"):
        buttons(f, leather, 4, 0.2, 0.5)
        if kind == "robe":
            f.belt(fabric(kit), 0.025, 0.14)


def held(kit, f, act):
    """What the hands hold, and what somebody sits on, leans at or pushes."""
    rng, b, s = kit.rng, f.b, f.b.size
    left, right = f.hands
    middle, dark = (left + right) / 2, kit.material(dark=True, pattern=PLAIN)
    if act == "carry":
        size = np.array([rng.uniform(0.12, 0.2), np.clip(abs(left[1] - right[1]) / 2 / s, 0.1, 0.2), rng.uniform(0.08, 0.2)]) * s
        kit.add(BOX if kit.chance(0.7) else BALL, middle + np.array([size[0] * 0.6, 0, size[2] * 0.4]), size, material=kit.material())
    elif act == "read":
        page = plain(kit, [0.8, 0.78, 0.7])._replace(pattern=WRITING, frequency=14.0)
        for side in (1, -1):
            f.chest(BOX, (0.37, 0.075 * side, 0.36), (0.01, 0.08, 0.11), page if kit.chance(0.5) else kit.material(), tilt=turn("z", -12 * side) @ turn("y", 35))
    elif act == "photo":
        kit.add(BOX, middle + f.facing @ np.array([0.04, 0, 0.02]) * s, np.array([0.03, 0.07, 0.045]) * s, rotation=f.facing, material=dark)
        kit.add(CYL, middle + f.facing @ np.array([0.1, 0, 0.015]) * s, np.array([0.035, 0.035, rng.uniform(0.03, 0.09)]) * s, rotation=f.facing @ ALONG_X, material=dark)
        kit.add(BOX, middle + f.facing @ np.array([0.04, 0, 0.075]) * s, np.array([0.025, 0.03, 0.02]) * s, (0.7, 0.7), rotation=f.facing, material=dark)
    elif act == "phone":
        kit.add(BOX, right + [0.01, 0.02, 0.04], np.array([0.035, 0.008, 0.075]) * s, rotation=turn("y", 15), material=dark)
    elif act == "push":
        x = max(left[0], right[0]) + 0.03
        if kit.chance(0.5):
            size = rng.uniform((0.3, 0.35, 0.45), (0.5, 0.6, 0.75))
            kit.add(
                BOX,
                (x + size[0], 0, max(size[2], middle[2] / 2 + 0.08)),
                (*size[:2], max(size[2], middle[2] / 2 + 0.08)),
                material=kit.material(pattern=rng.choice([PLANKS, PLAIN, BANDS])),
            )
        else:
            steel = plain(kit, [0.5, 0.5, 0.5], 0.4)
            kit.between((x - 0.02, -0.25, middle[2]), (x - 0.02, 0.25, middle[2]), 0.018, material=dark)
            kit.add(BOX, (x + 0.45, 0, 0.65 * s), (0.36, 0.24, 0.2), (1.15, 1.1), material=steel, cut=(GRID, 14.0, 0.3))
            kit.between((x + 0.02, 0.22, middle[2]), (x + 0.12, 0.2, 0.15), 0.015, material=steel, mirror=True)
            kit.between((x + 0.1, 0.2, 0.16), (x + 0.8, 0.2, 0.16), 0.015, material=steel, mirror=True)
            for xw in (0.14, 0.76):
                kit.add(CYL, (x + xw, 0.2, 0.07), (0.07, 0.07, 0.02), rotation=ALONG_Y, material=dark, mirror=True)
            kit.between((x + 0.78, 0.2, 0.16), (x + 0.7, 0.2, 0.5 * s), 0.015, material=steel, mirror=True)
    elif act == "throw":
        kit.add(BALL, right + [0.0, 0, 0.09 * s], (0.06 * s,) * 3 if kit.chance(0.6) else np.array([0.13, 0.08, 0.08]) * s, material=kit.material())
    elif act == "climb":
        x = max(left[0], right[0]) + 0.02
        tall = left[2] + rng.uniform(0.15, 0.6)
        if kit.chance(0.5):
            kit.add(
                BOX, (x + 0.2, 0, tall / 2), (0.2, rng.uniform(0.4, 0.6), tall / 2), material=kit.material(base=[0.4, 0.36, 0.3], pattern=rng.choice([CLOUDY, STREAKS]))
            )
            for k in range(6):
                kit.add(BALL, (x - 0.01, (0.3, -0.25, 0.1)[k % 3], tall * (0.12 + 0.15 * k)), (0.045, 0.06, 0.045), material=kit.material())
        else:
            wood = kit.material(base=[0.45, 0.3, 0.15], pattern=PLANKS)
            kit.between((x, 0.27, 0), (x, 0.27, tall), (0.025, 0.02), BOX, material=wood, mirror=True)
            count = int(tall / 0.3)
            for k in range(count):
                kit.between((x, -0.27, (k + 0.5) * tall / count), (x, 0.27, (k + 0.5) * tall / count), 0.018, material=wood)
        for foot, z in zip(f.feet, (0, 1), strict=True):
            if z == 0:
                kit.add(BOX, ((foot[0] + x) / 2 + 0.06, foot[1], foot[2] - 0.095 * s), ((x - foot[0]) / 2 + 0.05, 0.07, 0.02), material=dark)
    elif act == "lean":
        back = f.place(f.high(-b.deep * 1.1, 0, 0.4))[0] - 0.04
        kit.add(
            BOX, (back - 0.06, 0, 0.85 * s), (0.06, rng.uniform(0.35, 0.8), rng.uniform(0.85, 1.1) * s), material=kit.material(pattern=rng.choice([PLAIN, CLOUDY, 8]))
        )
    elif act == "sit":
        seat = f.place(f.low(0, 0, -0.13))[2] + 0.01
        under, wood = (0.06 * s, 0, seat), kit.material()
        kind = rng.choice(["stool", "block", "chair", "chair", "armchair", "log", "bench"])
        if kind == "block":
            kit.add(BOX, (-0.0, 0, seat / 2), (0.25 * s, rng.uniform(0.24, 0.5) * s, seat / 2), material=wood)
        elif kind == "log":
            kit.add(CYL, (-0.02, 0, seat / 2), (seat / 2, seat / 2, 0.6 * s), rotation=ALONG_Y, material=kit.material(base=[0.25, 0.17, 0.1], pattern=RIBS))
        elif kind == "armchair":
            kit.add(BOX, (0, 0, seat * 0.55), (0.3 * s, 0.3 * s, seat * 0.45), material=wood)
            kit.add(BOX, (-0.28 * s, 0, 0.55 * s), (0.09 * s, 0.33 * s, 0.52 * s), (0.8, 0.95), rotation=turn("y", -6), material=wood)
            kit.add(BOX, (0, 0.37 * s, 0.32 * s), (0.3 * s, 0.07 * s, 0.32 * s), material=wood, mirror=True)
            kit.add(BOX, (0, 0, 0.02), (0.28 * s, 0.34 * s, 0.02), material=dark)
        else:
            wide = 0.7 if kind == "bench" else 0.23
            kit.add(BOX, (under[0] - 0.04, 0, seat - 0.025), (0.23 * s, wide * s, 0.025), material=wood)
            for x in (-0.17, 0.18):
                kit.between((x * s, (wide - 0.04) * s, 0), (x * s, (wide - 0.04) * s, seat), 0.022 * s, material=wood, mirror=True)
            if kind == "chair":
                kit.add(
                    BOX,
                    (-0.21 * s, 0, seat + 0.27 * s),
                    (0.02 * s, 0.21 * s, 0.27 * s),
                    rotation=turn("y", -5),
                    material=wood,
                    cut=(RUNGS, 9.0, 0.5) if kit.chance(0.4) else (0, 1, 1),
                )
    elif act == "dumbbell":
        kit.between(left, right, 0.014, material=dark)
        for p, side in ((left, 1), (right, -1)):
            for k in (0, 1):
                kit.add(CYL, p + [0, side * (0.24 + 0.06 * k), 0], (0.2 - 0.05 * k, 0.2 - 0.05 * k, 0.025), rotation=ALONG_Y, material=kit.material(pattern=PLAIN))
            kit.between(p, p + [0, side * 0.34, 0], 0.016, material=dark)
    elif act == "bags":
        for p in (left, right) if kit.chance(0.5) else (right,):
            kit.add(BOX, p - [0, 0, 0.24 * s], np.array([0.13, 0.06, 0.15]) * s, (1.1, 1), material=kit.material())
            kit.add(BOX, p - [0, 0, 0.05 * s], np.array([0.05, 0.01, 0.06]) * s, material=dark, cut=(GRID, 8.0, 0.2))
    elif act == "cane":
        kit.between((right[0] + 0.03, right[1], 0), right, 0.014, material=kit.material(base=[0.2, 0.1, 0.05]))
    elif act == "lie" and kit.chance(0.7):
        kit.add(BOX, (0.0, 0, -0.04), (1.0 * s, 0.4 * s, 0.045), material=fabric(kit))
    elif act == "ball":
        kit.add(BALL, f.feet[1] + [0.28 * s, 0, 0.02], (0.11 * s,) * 3, material=kit.material(base=[0.8, 0.8, 0.8], pattern=DOTS, second=[0.03] * 3))


def pose(kit, act):
    """Arguments of a Figure for what somebody does."""
    rng = kit.rng
    one, flat = rng.choice, turn("y", 4)
    return {
        "stand": lambda: {"legs": one(["stand", "rest", "rest", "attention"]), "arms": one(["hang", "hip", "hips", "crossed", "behind", "pockets", "chin", "head"])},
        "hips": lambda: {"legs": one(["stand", "rest", "apart"]), "arms": "hips"},
        "crossed": lambda: {"legs": one(["stand", "rest", "apart"]), "arms": "crossed", "lean": -2},
        "walk": lambda: {"legs": "walk", "arms": one(["walk", "walk", "carry", "pockets", "wave"]), "lean": rng.uniform(0, 7)},
        "run": lambda: {"legs": one(["run", "sprint"]), "arms": "run", "lean": rng.uniform(6, 16), "fists": True},
        "sit": lambda: {"legs": one(["seat", "seat", "cross_seat", "seat_out"]), "arms": one(["knees", "lap", "chin", "crossed", "hip"]), "lean": rng.uniform(-6, 18)},
        "ground": lambda: {"legs": "ground", "arms": one(["props", "knees"]), "lean": rng.uniform(-12, 4)},
        "hug": lambda: {"legs": "hug", "arms": "shins", "lean": rng.uniform(4, 16)},
        "handstand": lambda: {"legs": one(["inverted", "scissors"]), "hands": [(0.04, 0.2, 1.04)] * 2, "pelvis": turn("y", 180), "look": turn("y", -20)},
        "crawl": lambda: {"legs": "crawl", "hands": [(0.54, 0.17, 0.5), (0.52, 0.17, 0.42)], "pelvis": turn("y", 80), "look": turn("y", -50)},
        "lotus": lambda: {"legs": "lotus", "arms": one(["knees", "pray", "lap"]), "look": flat},
        "kneel": lambda: {"legs": one(["kneel", "both_knees", "seiza"]), "arms": one(["hang", "knees", "pray", "lap"]), "lean": rng.uniform(-2, 12)},
        "pray": lambda: {"legs": one(["both_knees", "seiza", "stand"]), "arms": "pray", "lean": rng.uniform(0, 8), "look": turn("y", rng.uniform(5, 25))},
        "crouch": lambda: {"legs": one(["squat", "crouch"]), "arms": one(["knees", "carry"]), "lean": rng.uniform(12, 32), "look": turn("y", -12)},
        "point": lambda: {"legs": one(["stand", "rest", "stride"]), "arms": one(["point", "point", "aside"])},
        "wave": lambda: {"legs": one(["stand", "rest"]), "arms": one(["wave", "up"])},
        "carry": lambda: {"legs": one(["stand", "walk", "walk"]), "arms": "carry", "lean": -4},
        "push": lambda: {"legs": "stride", "arms": "push", "lean": rng.uniform(15, 28), "look": turn("y", -12)},
        "throw": lambda: {"legs": one(["stride", "high_knee"]), "arms": "throw", "twist": -28, "lean": -8, "look": turn("z", 26)},
        "climb": lambda: {"legs": "climb", "arms": "climb", "look": turn("y", -22), "fists": True},
        "dance": lambda: {
            "legs": one(["arabesque", "tree", "high_knee", "kick", "leap", "stride"]),
            "arms": one(["flow", "fly", "tee", "overhead"]),
            "roll": rng.uniform(-10, 10),
        },
        "yoga": lambda: {
            "legs": (leg := one(["tree", "warrior", "lotus", "split"])),
            "arms": "tee" if leg == "warrior" else one(["overhead", "pray", "tee"]),
            "look": flat,
        },
        "boxing": lambda: {
            "legs": one(["stride", "crouch", "stand"]),
            "arms": one(["guard", "punch"]),
            "lean": 8,
            "twist": -14,
            "look": turn("z", 14) @ turn("y", 6),
            "fists": True,
        },
        "kicking": lambda: {"legs": "kick", "arms": one(["fly", "guard", "tee"]), "lean": -10, "look": flat},
        "lie": lambda: {"legs": one(["back", "back_bent"]), "arms": one(["hang", "head", "lap"]), "pelvis": turn("y", -90), "look": turn("y", 12)},
        "pushup": lambda: {"legs": "pushup", "hands": [(0.48, 0.24, 0.46)] * 2, "pelvis": turn("y", 70), "look": turn("y", -25)},
        "lean": lambda: {"legs": "lean", "arms": one(["crossed", "pockets", "phone"]), "pelvis": turn("y", -9), "look": turn("y", 8)},
        "read": lambda: {"legs": one(["stand", "rest", "lotus"]), "arms": "read", "look": turn("y", 26)},
        "photo": lambda: {"legs": one(["stand", "kneel", "stride"]), "arms": "photo", "look": flat, "lean": 6},
        "phone": lambda: {"legs": one(["stand", "rest", "walk"]), "arms": "phone"},
        "salute": lambda: {"legs": "attention", "arms": "salute", "look": flat},
        "bags": lambda: {"legs": one(["stand", "walk"]), "arms": "hang", "fists": True},
        "lift": lambda: {"legs": one(["apart", "stride"]), "arms": "up", "fists": True, "look": flat},
        "cane": lambda: {"legs": one(["stand", "walk"]), "hands": [(0.06, 0.26, -0.03), (0.26, 0.24, -0.02)], "lean": 6},
    }[act]()


ACTS = ["stand", "hips", "crossed", "walk", "run", "sit", "sit", "ground", "hug", "lotus", "kneel", "pray", "crouch", "point", "wave", "carry", "push", "throw", "climb"]
ACTS += ["handstand", "crawl", "dance", "yoga", "boxing", "kicking", "lie", "pushup", "lean", "read", "photo", "phone", "salute", "bags", "lift"]


def finish(kit, left_handed=0.5):
    """Mirrors the whole object as often as not."""
    if kit.chance(left_handed):
        kit.primitives[:] = [mirrored(p) for p in kit.primitives]


def crown(kit, f, kind):
    """Hair, a hat, a beard."""
    rng, b, w = kit.rng, f.b, f.w
    head = f.on_head()
    if kind in ("thobe", "robe", "sari") and kit.chance(0.6):
        hat_on(
            kit,
            head,
            "scarf" if b.woman or kind == "thobe" else "turban",
            w.top if kind == "sari" else fabric(kit, [0.75, 0.74, 0.7] if kit.chance(0.5) else None, 0.2),
            w.hair,
        )
    elif kit.chance(0.27):
        hat_on(
            kit,
            head,
            rng.choice(["cap", "cap", "beanie", "beret", "brim", "cowboy", "turban", "scarf"] if not b.woman else ["cap", "beanie", "brim", "scarf", "beret"]),
            fabric(kit, bold=0.15),
            w.hair,
        )
    else:
        men = ["short", "short", "part", "quiff", "bald", "rim", "afro"]
        hair_on(
            head,
            rng,
            rng.choice(["long", "bob", "tail", "bun", "short", "long", "afro"] if b.woman else men),
            w.hair if b.kind != "old" else kit.material(base=np.ones(3) * rng.uniform(0.35, 0.8), pattern=PLAIN),
        )
    if not b.woman and b.kind != "child" and kit.chance(0.25):
        head(BALL, (0.4, 0, -0.72), (0.4, 0.46, rng.uniform(0.36, 0.7)), w.hair)


def dummy(kit, kind):
    """A mannequin, a scarecrow, a statue on a plinth, or a toy soldier's base under a posed body."""
    rng = kit.rng
    b = build(kit, rng.choice(["man", "woman"]))
    if kind == "scarecrow":
        b.size = 1.0
        straw = kit.material(base=[0.6, 0.45, 0.16], pattern=STREAKS, gloss=0.0)
        w = clothe(kit, skin=straw, hair=straw, gloves=straw, top=fabric(kit, bold=0.9), bottom=fabric(kit, [0.12, 0.1, 0.08]), shoes=straw, cut=1.0, thick=1.2)
        f = Figure(kit, b, w, "attention", "tee", look=turn("x", rng.uniform(-14, 14)))
        first = len(kit.primitives)
        low = rng.uniform(0.2, 0.6)
        kit.primitives[:first] = [p._replace(centre=p.centre + [0, 0, low]) for p in kit.primitives]
        f.at = f.at + [0, 0, low]
        pole = kit.material(base=[0.3, 0.2, 0.1], pattern=PLANKS)
        kit.between((-0.1, 0, 0), f.place(f.high(-0.1, 0, 0.55)), 0.025, material=pole)
        kit.between(f.place(f.high(-0.05, -0.86, 0.5)), f.place(f.high(-0.05, 0.86, 0.5)), 0.022, material=pole)
        hat_on(kit, f.on_head(), rng.choice(["brim", "brim", "top", "cowboy"]), fabric(kit, bold=0.2), straw)
        f.chest(CYL, (0, 0, 0.02), (b.deep + 0.03, b.hip + 0.03, 0.13), w.top, (0.85, 1), low=True)
        f.belt(straw)
        f.face()
        return
    stone = carved(kit) if kind == "statue" else kit.material(base=rng.choice([0.03, 0.4, 0.75]) * np.array([1, 0.95, 0.88]), pattern=PLAIN, gloss=rng.uniform(0.05, 0.5))
    act = rng.choice(
        ["stand", "hips", "point", "walk", "crossed", "throw", "dance", "salute", "read"] if kind == "statue" else ["stand", "hips", "walk", "stand", "wave"]
    )
    w = clothe(kit, stone, sleeves=rng.integers(3), trousers=rng.choice([0, 0, 2]))
    if kind == "mannequin" and kit.chance(0.5):
        w.top = w.arm = fabric(kit)
        w.bottom = w.seat = fabric(kit)
        w.stone, w.trousers = True, 2
    f = Figure(kit, b, w, **pose(kit, act))
    if f.legs in UPRIGHT and kit.chance(0.4):
        f.skirt(w.bottom, rng.uniform(0.05, 0.5), 1.05)
    if kind == "statue":
        hair_on(f.on_head(), rng, rng.choice(["short", "long", "bun", "part", "quiff"]), stone)
        if kit.chance(0.4):
            f.limb(f.place((-0.2, 0, 0.15)) / b.size, f.high(-0.1, 0, 0.54), (0.04, 0.3), 0.6, stone, BOX)
        base = stone if kit.chance(0.4) else kit.material(base=np.ones(3) * rng.uniform(0.15, 0.6), pattern=CLOUDY)
        tall, wide = rng.uniform(0.1, 1.3), max(0.36, max(abs(p[0]) for p in f.feet if p[2] < 0.2) + 0.24)
        shape = BOX if kit.chance(0.6) else CYL
        kit.add(shape, (0, 0, -tall / 2 + 0.005), (wide * 0.85, wide * 0.85, tall / 2), (0.92, 0.92 if shape == BOX else 1), material=base)
        kit.add(shape, (0, 0, -0.03), (wide, wide, 0.04), material=base)
        kit.add(shape, (0, 0, -tall - 0.05), (wide * 1.15, wide * 1.15, 0.07), material=base)
    else:
        steel = plain(kit, [0.55, 0.55, 0.55], 0.5)
        kit.add(CYL, (-0.05, 0, 0.0), (0.27, 0.27, 0.015), material=steel)
        kit.between((-0.1, 0, 0.0), f.place(f.low(-0.08, 0, -0.05)), 0.012, material=steel)
        if kit.chance(0.4):
            hair_on(f.on_head(), rng, rng.choice(["bob", "short", "tail"]), hair_material(kit))
    f.face()


def posed_person(kit):
    """One person of any age and build: standing, walking, running, sitting, kneeling, at work, sport, yoga or rest, in clothes of many kinds; mannequin, scarecrow, statue."""
    rng = kit.rng
    odd = rng.random()
    if odd < 0.13:
        dummy(kit, rng.choice(["mannequin", "scarecrow", "statue", "statue"]))
        finish(kit)
        return
    b = build(kit, rng.choice(["man", "woman", "child", "old", "heavy"], p=[0.33, 0.33, 0.14, 0.1, 0.1]))
    act = rng.choice(ACTS) if b.kind != "old" or kit.chance(0.6) else "cane"
    how = pose(kit, act)
    long = how["legs"] in UPRIGHT and act not in ("climb", "run") and kit.chance(0.6 if b.woman else 0.3)
    kinds = (["dress", "dress", "skirt", "skirt", "coat", "robe", "sari", "kimono"] if b.woman else ["coat", "coat", "robe", "kilt", "thobe"]) if long else OUTFITS
    kind = rng.choice(kinds)
    if act in ("boxing", "yoga", "pushup", "handstand", "lift", "kicking", "dance") and kit.chance(0.7):
        kind = rng.choice(["sport", "sport", "swim", "tee"])
    w = outfit(kit, b, kind)
    if act == "boxing" and kit.chance(0.7):
        w.gloves = plain(kit, paint(rng.choice([0, 0.6]), 0.9, 0.5), 0.3)
    how["lean"] = how.get("lean", 0) + b.stoop
    f = Figure(kit, b, w, **how)
    if w.gloves is not w.skin:
        for p in f.hands:
            kit.add(BALL, p, np.array([0.085, 0.075, 0.085]) * b.size, material=w.gloves)
    crown(kit, f, kind)
    garments(kit, f, kind)
    held(kit, f, {"lift": "dumbbell", "kicking": "ball" if kit.chance(0.5) else ""}.get(act, act))
    if kit.chance(0.12) and act in ("stand", "walk", "point", "wave", "photo"):
        f.chest(BOX, (-b.deep - 0.09, 0, 0.33), (0.085, 0.14, 0.2), kit.material(), (0.9, 0.85))
    f.face()
    finish(kit)


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


def helm(kit, f, kind, material, second):
    """Helmets and caps of every kind of service and age."""
    rng, head, dark = kit.rng, f.on_head(), kit.material(dark=True, pattern=PLAIN)
    gold, steel = plain(kit, [0.65, 0.45, 0.12], 0.5), plain(kit, [0.5, 0.5, 0.52], 0.5)
    if kind not in ("visor", "pilot", "greathelm", "bascinet", "diving"):
        f.face(kind in ("cap", "peaked", "beret", "shako", "brodie"))
    if kind in ("cap", "peaked", "beret", "beanie", "hard"):
        hat_on(kit, head, kind, material, f.w.hair)
    elif kind in ("modern", "m1", "stahl", "police", "visor", "pilot"):
        head(BALL, (-0.08, 0, 0.42), (1.04, 0.94, 0.88), material)
        if kind == "modern":
            head(BALL, (-0.2, 0.7, 0.05), (0.42, 0.2, 0.48), material, mirror=True)
            head(BOX, (0.9, 0, 0.7), (0.12, 0.16, 0.16), dark)
            if kit.chance(0.4):
                head(CYL, (1.15, 0.2, 0.75), (0.15, 0.15, 0.25), dark, tilt=ALONG_X, mirror=True)
            if kit.chance(0.4):
                head(BOX, (0.66, 0, 0.08), (0.12, 0.5, 0.2), dark)
            bar(head, (-0.1, 0.66, 0), (0.35, 0.15, -0.98), 0.05, dark, mirror=True)
        elif kind == "m1":
            head(CYL, (-0.05, 0, 0.25), (1.14, 1.02, 0.1), material, (0.94, 1))
            bar(head, (0, 0.7, 0.2), (0.35, 0.15, -0.98), 0.05, dark, mirror=True)
        elif kind == "stahl":
            head(CYL, (-0.1, 0, 0.1), (1.25, 1.1, 0.3), material, (0.82, 1), turn("y", 6))
        elif kind == "pilot":
            head(BALL, (-0.1, 0, 0.05), (0.88, 0.92, 0.95), material)
            head(BALL, (0.32, 0, 0.35), (0.68, 0.76, 0.42), dark._replace(gloss=0.6))
            head(BALL, (0.7, 0, -0.45), (0.35, 0.36, 0.4), second)
            bar(head, (0.95, 0, -0.6), (0.6, 0.1, -2.3), 0.16, dark)
        else:
            head(BALL, (-0.2, 0, 0.0), (0.85, 0.9, 0.7), material)
            glass = kit.material(base=[0.25, 0.32, 0.36], pattern=PLAIN, gloss=0.6)
            head(BALL, (0.25, 0, -0.05 if kind == "visor" else 0.4), (0.78, 0.74, 0.85 if kind == "visor" else 0.6), glass if kind == "visor" else dark)
    elif kind == "brodie":
        head(BALL, (-0.08, 0, 0.55), (0.95, 0.86, 0.66), material)
        head(CYL, (-0.06, 0, 0.5), (1.5, 1.35, 0.11), material, (0.68, 1))
        bar(head, (0, 0.7, 0.4), (0.35, 0.15, -0.98), 0.05, dark, mirror=True)
    elif kind == "adrian":
        head(BALL, (-0.08, 0, 0.45), (0.98, 0.88, 0.8), material)
        head(CYL, (-0.02, 0, 0.35), (1.22, 1.0, 0.07), material, (0.85, 1))
        head(BOX, (-0.15, 0, 1.2), (0.62, 0.08, 0.14), material, (0.6, 1))
    elif kind == "fire":
        head(BALL, (-0.08, 0, 0.45), (1.02, 0.92, 0.9), material)
        head(CYL, (-0.28, 0, 0.35), (1.45, 1.08, 0.06), material, (0.9, 1), turn("y", -10))
        head(BOX, (-0.1, 0, 1.28), (0.7, 0.07, 0.12), material, (0.5, 1))
        head(BOX, (0.9, 0, 0.75), (0.06, 0.28, 0.36), gold, (1, 0.5), turn("y", -15))
    elif kind == "sailor":
        hair_on(head, rng, "short", f.w.hair)
        head(CYL, (-0.1, 0, 0.85), (0.8, 0.75, 0.2), material if kit.chance(0.5) else dark, (1.12, 1))
        head(BALL, (-0.1, 0, 1.02), (0.88, 0.82, 0.25), material)
    elif kind == "shako":
        head(BALL, (-0.22, 0, 0.2), (0.76, 0.74, 0.7), f.w.hair)
        head(CYL, (-0.08, 0, 1.1), (0.8, 0.76, 0.6), material, (1.15, 1))
        head(CYL, (0.65, 0, 0.55), (0.5, 0.55, 0.04), dark, tilt=turn("y", 15))
        head(BOX, (0.8, 0, 1.05), (0.06, 0.25, 0.25), gold)
        head(BALL, (0.75, 0, 2.0), (0.16, 0.16, 0.5), second)
    elif kind == "bearskin":
        head(BALL, (-0.05, 0, 1.15), (1.0, 0.98, 1.25), material)
        head(BALL, (-0.2, 0, 0.3), (0.85, 0.84, 0.7), material)
        bar(head, (0.2, 0.68, 0.3), (0.5, 0.15, -0.8), 0.05, gold, mirror=True)
    elif kind == "tricorn":
        head(BALL, (-0.2, 0, 0.2), (0.8, 0.76, 0.75), f.w.hair)
        head(BALL, (-0.1, 0, 0.75), (0.8, 0.76, 0.5), material)
        head(PRISM, (-0.02, 0, 0.72), (1.12, 1.08, 0.27), material, (1.2, 3))
        head(PRISM, (-0.02, 0, 0.98), (1.37, 1.32, 0.03), plain(kit, [0.6, 0.5, 0.25], 0.3), (1, 3))
        head(PRISM, (-0.02, 0, 1.0), (1.22, 1.17, 0.03), material, (1, 3))
        head(BALL, (-0.1, 0, 0.85), (0.75, 0.72, 0.55), material)
        head(BALL, (-0.95, 0, -0.4), (0.16, 0.14, 0.45), f.w.hair)
    elif kind == "plumed":
        head(BALL, (-0.35, 0, -0.1), (0.7, 0.85, 0.95), f.w.hair)
        head(CYL, (-0.05, 0, 0.65), (1.6, 1.5, 0.05), material, tilt=turn("x", 8))
        head(CYL, (-0.08, 0, 0.95), (0.82, 0.76, 0.32), material, (0.9, 1))
        head(BALL, (-0.8, 0.75, 1.05), (0.9, 0.2, 0.3), second, tilt=turn("z", -20) @ turn("y", -15))
    elif kind == "galea":
        head(BALL, (-0.08, 0, 0.4), (0.98, 0.86, 0.84), material)
        head(BALL, (0.16, 0.62, -0.4), (0.38, 0.1, 0.55), material, mirror=True)
        head(CYL, (-0.55, 0, -0.25), (0.95, 0.95, 0.06), material, tilt=turn("y", -20))
        for a in (-70, -35, 0, 35, 70) if kit.chance(0.7) else ():
            s, c = np.sin(np.radians(a)), np.cos(np.radians(a))
            head(BOX, (-0.08 + 1.05 * s, 0, 0.45 + 1.0 * c), (0.36, 0.1, 0.26), second, (1.15, 1), turn("y", a))
    elif kind == "kabuto":
        head(BALL, (-0.08, 0, 0.5), (1.0, 0.9, 0.82), material)
        for k in range(3):
            head(CYL, (-0.2, 0, 0.18 - 0.26 * k), (1.15 + 0.12 * k, 1.1 + 0.12 * k, 0.14), second if k % 2 else material, (0.88, 1))
        bar(head, (0.8, 0.12, 0.8), (0.9, 0.75, 1.9), (0.05, 0.16), gold, 0.3, True, BOX)
        head(BALL, (0.5, 0, -0.45), (0.4, 0.5, 0.5), dark)
    elif kind == "greathelm":
        head(CYL, (0.02, 0, -0.05), (0.92, 0.8, 1.0), material, (0.92, 1))
        head(CYL, (0.02, 0, 1.02), (0.82, 0.72, 0.12), material, (0.8, 1))
        head(BOX, (0.88, 0, 0.15), (0.06, 0.5, 0.06), dark)
        head(BOX, (0.9, 0, -0.1), (0.06, 0.07, 0.9), gold)
    elif kind == "bascinet":
        head(CYL, (-0.05, 0, 0.7), (0.98, 0.88, 0.75), material, (0.2, 1))
        head(BALL, (-0.08, 0, 0.1), (0.95, 0.87, 0.85), material)
        head(CYL, (0.75, 0, -0.1), (0.62, 0.6, 0.45), material, (0.2, 1), ALONG_X)
        head(BOX, (0.85, 0, 0.28), (0.1, 0.4, 0.05), dark)
        head(CYL, (-0.1, 0, -1.1), (1.25, 1.35, 0.35), steel, (0.65, 1))
    elif kind == "diving":
        head(BALL, (-0.12, 0, 0.1), (0.9, 0.76, 0.95), material)
        head(BOX, (0.72, 0, 0.12), (0.2, 0.5, 0.3), plain(kit, [0.1, 0.2, 0.25], 0.6), (1, 0.9))
        head(BALL, (0.8, 0, -0.5), (0.25, 0.3, 0.2), dark)


def drab(kit, base=None, camo=0.65):
    rng = kit.rng
    base = (
        np.array([[0.2, 0.19, 0.11], [0.36, 0.3, 0.19], [0.1, 0.12, 0.07], [0.25, 0.26, 0.26]][rng.integers(4)]) * rng.uniform(0.6, 1.5)
        if base is None
        else np.array(base)
    )
    return kit.material(base=base, pattern=CAMOUFLAGE if kit.chance(camo) else PLAIN, frequency=rng.uniform(10, 22), gloss=0.02, second=base * rng.uniform(0.3, 0.6))


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


def webbing(kit, f, vest, full=True):
    """Body armour with pouches, a pack, a radio with its aerial."""
    rng, b = kit.rng, f.b
    deep = b.deep + 0.035
    f.chest(BOX, (0.008, 0, 0.33), (deep, b.shoulder * 0.86, 0.17), vest, (0.9, 0.88))
    for y in np.linspace(-0.1, 0.1, 3):
        f.chest(BOX, (deep + 0.02, y, rng.choice([0.2, 0.24])), (0.03, 0.042, 0.065), vest)
    f.belt(vest, 0.035, 0.08)
    if full and kit.chance(0.6):
        size = rng.uniform((0.08, 0.13, 0.16), (0.14, 0.18, 0.26))
        f.chest(BOX, (-deep - size[0], 0, 0.34), size, vest, (0.9, 0.9))
        f.chest(CYL, (-deep - size[0], 0, 0.36 + size[2]), (0.075, 0.075, 0.19), vest, tilt=ALONG_Y)
        if kit.chance(0.5):
            f.limb(f.high(-deep - 0.05, 0.12, 0.45), f.high(-deep - 0.08, 0.13, rng.uniform(0.9, 1.3)), 0.007, 1, kit.material(dark=True))
    f.chest(BOX, (0, b.hip + 0.035, -0.02), (0.06, 0.035, 0.07), vest, low=True, mirror=True)


def modern(kit):
    """A soldier or marine: firing, standing guard, patrolling, kneeling, prone; with rifle, machine gun or launcher."""
    rng = kit.rng
    b, cloth = build(kit, rng.choice(["man", "man", "man", "woman"])), drab(kit)
    vest = kit.material(base=cloth.first * rng.uniform(0.5, 1.2), pattern=PLAIN, gloss=0.02)
    w = clothe(
        kit,
        top=cloth,
        bottom=cloth,
        shoes=plain(kit, np.array([0.1, 0.07, 0.04]) * rng.uniform(0.3, 2)),
        gloves=kit.material(dark=True) if kit.chance(0.5) else None,
        cut=0.9,
        thick=1.12,
    )
    cover, hat = (cloth if kit.chance(0.7) else vest), rng.choice(["modern", "modern", "modern", "m1", "cap", "beret", "beanie"])
    stance = rng.choice(["stand", "stand", "walk", "kneel", "prone", "guard", "glass", "mine"])
    weapon = rng.choice(["rifle", "rifle", "rifle", "mg", "sniper", "smg", "launcher"])
    if stance == "prone":
        prone(kit, b, w, weapon if weapon != "launcher" else "mg", hat, cover, vest)
        return
    if stance == "glass":
        f = Figure(kit, b, w, rng.choice(["stand", "kneel"]), "photo", look=turn("y", 2), fists=True, lean=4)
        middle, dark = (f.hands[0] + f.hands[1]) / 2, kit.material(dark=True, pattern=PLAIN)
        helm(kit, f, hat, cover, vest)
        webbing(kit, f, vest)
        kit.add(CYL, middle + f.facing @ np.array([0.03, 0.04, 0.02]), (0.036, 0.036, 0.085), (0.75, 1), rotation=f.facing @ turn("y", -90), material=dark)
        kit.add(CYL, middle + f.facing @ np.array([0.03, -0.04, 0.02]), (0.036, 0.036, 0.085), (0.75, 1), rotation=f.facing @ turn("y", -90), material=dark)
        gun(kit, f, "rifle", f.high(0.17, -0.16, 0.46), f.trunk @ np.array([0.1, 0.45, -0.85]))
    elif stance == "mine":
        f = Figure(kit, b, w, "walk", lean=10, hands=[(0.36, 0.08, 0.12), (0.26, 0.17, 0.05)], look=turn("y", 22), fists=True)
        left, right = f.hands
        dark, along = kit.material(dark=True, pattern=PLAIN), left - right
        foot = np.array([1.05, 0.1, 0.06])
        kit.between(right + (right - foot) * 0.25, foot, 0.016, material=dark)
        kit.add(CYL, foot, (0.16, 0.16, 0.025), material=vest)
        kit.add(BOX, right - along * 0.3, (0.07, 0.035, 0.05), material=dark)
        helm(kit, f, hat, cover, vest)
        webbing(kit, f, vest)
    else:
        args, butt, along = aim(kit, weapon, stance)
        f = Figure(kit, b, w, **args)
        gun(kit, f, weapon, f.high(*butt), f.trunk @ along)
        helm(kit, f, hat, cover, vest)
        webbing(kit, f, vest, weapon != "launcher")
    f.chest(BOX, (f.b.deep + 0.05, 0.12, 0.42), (0.022, 0.03, 0.06), kit.material(dark=True))


def prone(kit, b, w, weapon, hat, cover, vest):
    """Lying on the belly behind a gun on its bipod."""
    butt, along = np.array([0.5, -0.1, 0.3]), np.array([1, 0.05, -0.02])
    left, right = grips(weapon, butt, along)
    f = Figure(kit, b, w, "prone", hands=[left - [0.1, 0, 0.03], right], pelvis=turn("y", 86), lean=-16, look=turn("y", -62), world=True, fists=True, up=0.13)
    gun(kit, f, weapon, butt, along)
    tip = butt + along * GUNS[weapon][0] * 0.75
    for y in (-0.1, 0.1):
        kit.between(f.place(tip), f.place([tip[0] + 0.03, tip[1] + y, 0.0]), 0.009, material=kit.material(dark=True))
    helm(kit, f, hat, cover, vest)
    f.chest(BOX, (0, 0, 0.33), (b.deep + 0.03, b.shoulder * 0.85, 0.16), vest, (0.9, 0.9))
    if kit.chance(0.5):
        f.chest(BOX, (-b.deep - 0.09, 0, 0.33), (0.08, 0.14, 0.18), vest, (0.9, 0.9))
    f.belt(vest, 0.03)


def parade(kit):
    """A guard, sailor, officer or guardsman at attention, marching, saluting, or with the rifle at the shoulder."""
    rng = kit.rng
    kind = rng.choice(["guardsman", "sailor", "officer", "marine", "soldier"])
    base = {
        "guardsman": [0.5, 0.03, 0.03],
        "sailor": [0.75, 0.75, 0.75] if kit.chance(0.5) else [0.02, 0.03, 0.08],
        "officer": [0.2, 0.19, 0.11],
        "marine": [0.02, 0.03, 0.07],
    }.get(kind)
    top = plain(kit, base) if base is not None else drab(kit)
    bottom = plain(kit, [0.02, 0.025, 0.05]) if kind in ("guardsman", "marine") and kit.chance(0.7) else top
    white = plain(kit, [0.8, 0.8, 0.78])
    b = build(kit, rng.choice(["man", "man", "woman"]))
    w = clothe(kit, top=top, bottom=bottom, shoes=plain(kit, [0.02] * 3, 0.5), gloves=white if kit.chance(0.5) else None, cut=1.3 if kind == "sailor" else 0.9)
    do = rng.choice(["arms", "arms", "salute", "attention", "march"])
    hands = [(0.02, 0.25, -0.05), (0.14, 0.18, 0.06)] if do == "arms" else None
    legs = {"march": rng.choice(["walk", "high_knee"]), "arms": rng.choice(["attention", "walk"])}.get(do, "attention")
    f = Figure(kit, b, w, legs, {"salute": "salute", "march": "walk"}.get(do, "hang"), hands=hands, look=turn("y", 1), fists=do in ("arms", "march"))
    hat = {"guardsman": "bearskin", "sailor": "sailor"}.get(kind) or rng.choice(["peaked", "beret", "peaked"])
    helm(kit, f, hat, kit.material(dark=True, pattern=PLAIN) if kind == "guardsman" else white if kind == "marine" else top, white)
    if do == "arms":
        gun(kit, f, rng.choice(["bolt", "rifle"]), f.high(0.15, -0.19, 0.02), f.trunk @ np.array([-0.08, 0.02, 1.0]), kit.chance(0.5))
    f.belt(white if kit.chance(0.6) else w.shoes, 0.028, 0.12)
    f.chest(CYL, (0, 0, 0.0), (b.deep + 0.03, b.hip + 0.022, 0.11), top, (0.88, 1), low=True)
    gold = plain(kit, [0.65, 0.45, 0.12], 0.5)
    buttons(f, gold, 4, 0.2, 0.46)
    f.chest(BOX, (0, b.shoulder - 0.02, 0.55), (0.03, 0.06, 0.01), gold, tilt=turn("x", -18), mirror=True)
    if kind == "sailor":
        f.chest(BOX, (-0.075, 0, 0.47), (0.02, 0.15, 0.08), kit.material(base=[0.03, 0.06, 0.2], pattern=PLAIN))
    else:
        f.chest(BOX, (b.deep * 1.12, 0.075, 0.4), (0.012, 0.05, 0.02), kit.material(pattern=STRIPES, frequency=20))


def service(kit):
    """Riot police, a firefighter, a medic with a stretcher, a pilot, a diver, a paratrooper."""
    rng = kit.rng
    kind = rng.choice(["riot", "riot", "fire", "fire", "medic", "pilot", "diver", "para"])
    b, dark = build(kit, rng.choice(["man", "man", "woman"])), kit.material(dark=True, pattern=PLAIN)
    if kind == "riot":
        cloth = plain(kit, np.array([0.03, 0.035, 0.06]) * rng.uniform(0.5, 2.5))
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=dark, thick=1.2, cut=1.0)
        f = Figure(
            kit,
            b,
            w,
            rng.choice(["stride", "stand", "apart"]),
            hands=[(0.33, 0.16, 0.25), rng.choice([(0.1, 0.3, 0.0), (0.12, 0.36, 0.75), (0.3, 0.25, 0.3)])],
            lean=5,
            look=turn("y", 3),
            fists=True,
        )
        helm(kit, f, rng.choice(["visor", "visor", "police"]), cloth if kit.chance(0.6) else plain(kit, [0.75] * 3), dark)
        shield = kit.material(base=[0.35, 0.42, 0.46], pattern=PLAIN, gloss=0.5) if kit.chance(0.6) else dark
        at = f.hands[0] + [0.07, -0.05, -0.05]
        if kit.chance(0.7):
            kit.add(BOX, at, (0.02, 0.26, rng.uniform(0.4, 0.55)), material=shield)
            kit.add(BOX, at + [-0.012, 0.27, 0], (0.02, 0.05, 0.44), rotation=turn("z", 28), material=shield)
            kit.add(BOX, at + [-0.012, -0.27, 0], (0.02, 0.05, 0.44), rotation=turn("z", -28), material=shield)
            kit.add(BOX, at + [0.023, 0, 0.2], (0.005, 0.18, 0.05), material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=4))
        else:
            kit.add(CYL, at, (0.32, 0.32, 0.02), rotation=ALONG_X, material=shield)
        kit.between(f.hands[1] - [0.05, 0, 0.1], f.hands[1] + [0.16, 0, 0.45], 0.018, material=dark)
        f.chest(BOX, (0.005, 0, 0.32), (b.deep + 0.035, b.shoulder * 0.9, 0.18), dark, (0.92, 0.9))
        f.chest(BALL, (0, b.shoulder + 0.03, 0.5), (0.09, 0.075, 0.08), dark, mirror=True)
        f.wrap(0, 0.15, 1.08, (0.075, 0.062), dark, BOX, 1.15)
        f.belt(dark, 0.035)
    elif kind == "fire":
        cloth = plain(kit, [[0.5, 0.38, 0.14], [0.03, 0.03, 0.05], [0.45, 0.06, 0.02], [0.3, 0.26, 0.18]][rng.integers(4)])
        bright = plain(kit, [0.75, 0.8, 0.15], 0.2)
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=dark, thick=1.35, cut=1.3)
        hose = kit.chance(0.6)
        f = Figure(
            kit,
            b,
            w,
            rng.choice(["stride", "stand", "walk", "kneel"]),
            hands=[(0.4, 0.02, 0.28), (0.14, 0.17, 0.14)] if hose else None,
            lean=5,
            look=turn("y", 3),
            fists=True,
        )
        helm(kit, f, "fire", plain(kit, [[0.7, 0.6, 0.05], [0.5, 0.03, 0.02], [0.03] * 3, [0.7] * 3][rng.integers(4)], 0.4), dark)
        f.chest(CYL, (0, 0, 0.0), (b.deep + 0.04, b.hip + 0.04, 0.15), cloth, (0.88, 1), low=True)
        f.chest(CYL, (0, 0, -0.1), (b.deep + 0.042, b.hip + 0.042, 0.022), bright, low=True)
        f.chest(CYL, (0.006, 0, 0.3), (b.deep * 1.14, b.shoulder * 0.95, 0.022), bright)
        f.chest(CYL, (-b.deep - 0.08, 0, 0.33), (0.075, 0.075, 0.22), plain(kit, [0.6, 0.5, 0.05], 0.4))
        f.chest(BOX, (-b.deep - 0.02, 0, 0.33), (0.03, 0.11, 0.2), dark)
        f.wrap(0, 0.28, 0.38, 0.088, bright)
        if hose:
            left, right = f.hands
            red = kit.material(base=[0.6, 0.55, 0.4] if kit.chance(0.5) else [0.45, 0.05, 0.03], pattern=PLAIN)
            kit.between(right, left, 0.03, material=red)
            kit.between(left, left + (left - right) * 0.8, 0.03, taper=0.55, material=plain(kit, [0.6, 0.45, 0.15], 0.5))
            kit.chain([right, right + [-0.35, -0.1, -0.35 * right[2]], [right[0] - 0.6, right[1] - 0.15, 0.04], [right[0] - 1.1, right[1] + 0.1, 0.035]], 0.032, red)
        else:
            right = f.hands[1]
            kit.between(right - [0, 0, 0.45], right + [0.08, 0, 0.4], 0.018, material=kit.material(base=[0.5, 0.35, 0.15]))
            kit.add(BOX, right + [0.13, 0, 0.37], (0.1, 0.015, 0.06), (0.6, 1), material=plain(kit, [0.5, 0.04, 0.03], 0.3))
    elif kind == "medic":
        white = plain(kit, [0.8, 0.78, 0.75])
        cloth = drab(kit) if kit.chance(0.6) else plain(kit, [0.65, 0.12, 0.02])
        b.arm *= 0.9
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark)
        f = Figure(kit, b, w, rng.choice(["stand", "walk"]), hands=[(0.16, 0.3, -0.04), (0.16, 0.3, -0.04)], lean=3, fists=True)
        helm(kit, f, rng.choice(["m1", "modern", "cap"]), cloth, white)
        left, right = f.hands
        z, long = left[2], 1.9
        for p in (left, right):
            kit.between(p - [0.12, 0, 0], p + [long + 0.4, 0, 0], 0.02, material=kit.material(base=[0.35, 0.22, 0.1]))
            kit.between((p[0] + 0.4, p[1] * 0.95, z), (p[0] + 0.4, p[1] * 0.95, 0), 0.018, material=dark)
            kit.between((p[0] + long + 0.1, p[1] * 0.95, z), (p[0] + long + 0.1, p[1] * 0.95, 0), 0.018, material=dark)
        kit.add(BOX, (left[0] + long / 2 + 0.25, 0, z - 0.01), (long / 2 - 0.08, abs(left[1]), 0.018), material=fabric(kit, [0.25, 0.24, 0.14], 0))
        if kit.chance(0.6):
            kit.add(BALL, (left[0] + 1.2, 0, z + 0.1), (0.75, 0.2, 0.12), material=fabric(kit, [0.3, 0.25, 0.2], 0))
            kit.add(BALL, (left[0] + 0.45, 0, z + 0.11), (0.11, 0.085, 0.1), material=skin_material(kit))
        red = plain(kit, [0.6, 0.02, 0.02])
        f.chest(BOX, (-b.deep - 0.07, 0, 0.32), (0.07, 0.14, 0.17), white if kit.chance(0.5) else cloth)
        f.chest(BOX, (-b.deep - 0.145, 0, 0.32), (0.005, 0.025, 0.08), red)
        f.chest(BOX, (-b.deep - 0.145, 0, 0.32), (0.005, 0.08, 0.025), red)
        f.belt(dark)
    elif kind == "pilot":
        cloth = plain(kit, [[0.12, 0.14, 0.08], [0.5, 0.14, 0.02], [0.3, 0.26, 0.18], [0.08, 0.1, 0.16]][rng.integers(4)])
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=kit.material(base=cloth.first) if kit.chance(0.5) else None, cut=0.9)
        f = Figure(kit, b, w, rng.choice(["stand", "rest", "walk"]), rng.choice(["hips", "hang", "crossed", "wave", "salute"]))
        helm(kit, f, rng.choice(["pilot", "pilot", "cap"]), plain(kit, [0.7, 0.7, 0.68] if kit.chance(0.5) else [0.15, 0.16, 0.12], 0.3), dark)
        harness = drab(kit, [0.12, 0.13, 0.07], 0)
        f.chest(BALL, (b.deep * 0.5, 0.09, 0.3), (0.1, 0.065, 0.2), harness, mirror=True)
        f.chest(CYL, (-0.0, 0, 0.57), (0.11, 0.12, 0.045), harness, (0.8, 1), turn("y", 12))
        f.chest(BOX, (0.01, 0, 0.13), (b.deep + 0.02, b.waist + 0.015, 0.03), harness)
        f.belt(harness, 0.02)
        f.wrap(1, 0.3, 0.7, (0.1, 0.088), harness, BOX, 1.1)
    elif kind == "diver":
        suit = plain(kit, np.array([0.02, 0.025, 0.03]) * rng.uniform(0.6, 2), 0.2)
        trim = plain(kit, paint(rng.choice([0.15, 0.6, 0.0, 0.33]), 0.9, 0.6), 0.3)
        w = clothe(kit, top=suit, bottom=suit, gloves=suit, shoes=suit, cut=0.75)
        f = Figure(kit, b, w, rng.choice(["stand", "rest", "kneel"]), rng.choice(["hang", "hips", "wave", "crossed"]))
        helm(kit, f, "diving", suit, trim)
        for y in (0.09, -0.09) if kit.chance(0.5) else (0,):
            f.chest(CYL, (-b.deep - 0.09, y, 0.25), (0.085, 0.085, 0.27), trim)
            f.chest(CYL, (-b.deep - 0.09, y, 0.54), (0.04, 0.04, 0.04), dark)
        f.chest(BOX, (0.005, 0, 0.3), (b.deep + 0.02, b.shoulder * 0.75, 0.17), dark, (1, 0.75))
        f.belt(dark, 0.03, 0.06)
        f.limb(f.high(-b.deep - 0.08, -0.05, 0.55), f.high(0.08, -0.19, 0.6), 0.014, 1, dark)
        f.limb(f.high(0.08, -0.19, 0.6), f.centre + f.facing @ np.array([0.09, -0.01, -0.06]), 0.014, 1, dark)
        for foot in f.feet:
            kit.add(BOX, foot + [0.28 * b.size, 0, -0.055 * b.size], np.array([0.2, 0.1, 0.014]) * b.size, (0.9, 1), material=trim)
    else:
        cloth, vest = drab(kit), drab(kit, None, 0)
        w = clothe(kit, top=cloth, bottom=cloth, shoes=dark, gloves=dark, thick=1.15, cut=0.9)
        f = Figure(kit, b, w, rng.choice(["stand", "seat", "high_knee"]), "up", fists=True, look=turn("y", -8))
        helm(kit, f, "m1" if kit.chance(0.5) else "modern", cloth, vest)
        low = f.high(0, 0, 0.55)[2] * b.size + f.at[2]
        top = low + rng.uniform(2.4, 3.2)
        wide = rng.uniform(1.6, 2.2)
        canopy = kit.material(base=[0.3, 0.3, 0.2] if kit.chance(0.5) else paint(rng.random(), 0.7, 0.6), pattern=rng.choice([PLAIN, STRIPES, RIBS]), frequency=4)
        for k, (z, r) in enumerate(((0, 1.0), (0.28, 0.93), (0.52, 0.72))):
            kit.add(CYL, (0, 0, top + (z + 0.14) * wide * 0.9), (wide * r, wide * r, 0.14 * wide * 0.95), ((0.93, 0.77, 0.25)[k], 1), material=canopy)
        for hand in f.hands:
            kit.between(f.place(f.high(-0.03, np.sign(hand[1]) * 0.13, 0.52)), hand + [0, 0, 0.1], 0.014, material=vest)
            for x in (-0.9, 0, 0.9):
                kit.between(hand + [0, 0, 0.1], (x * wide, np.sign(hand[1]) * wide * (0.35 if x else 0.95), top + 0.1), 0.01, material=vest)
        f.chest(BOX, (-b.deep - 0.08, 0, 0.32), (0.08, 0.16, 0.2), vest)
        f.chest(BOX, (b.deep + 0.05, 0, 0.12), (0.06, 0.14, 0.09), vest)
        f.belt(vest)


def great_war(kit):
    """A rifleman of the first or second world war."""
    rng = kit.rng
    nation = rng.choice(["british", "french", "german", "american", "soviet"])
    base = {"british": [0.22, 0.17, 0.09], "french": [0.22, 0.28, 0.38], "german": [0.17, 0.19, 0.15], "american": [0.2, 0.19, 0.1], "soviet": [0.28, 0.23, 0.12]}[nation]
    cloth, leather = plain(kit, np.array(base) * rng.uniform(0.7, 1.3)), kit.material(base=[0.12, 0.06, 0.03], pattern=PLAIN, gloss=0.15)
    canvas = plain(kit, [0.32, 0.28, 0.17])
    b = build(kit, "man")
    w = clothe(kit, top=cloth, bottom=cloth, shoes=leather, cut=0.85, socks=canvas, thick=1.12)
    if nation in ("british", "french"):
        w.cut = 0.78
    weapon = "bolt" if nation != "american" or kit.chance(0.6) else "smg"
    helmet = {"british": "brodie", "french": "adrian", "german": "stahl"}.get(nation, "m1")
    metal = plain(kit, np.array(base) * rng.uniform(0.5, 0.9), 0.15)
    if kit.chance(0.15):
        prone(kit, b, w, "mg" if kit.chance(0.3) else weapon, helmet, metal, canvas)
        return
    args, butt, along = aim(kit, weapon, rng.choice(["stand", "walk", "kneel", "guard"]))
    f = Figure(kit, b, w, **args)
    gun(kit, f, weapon, f.high(*butt), f.trunk @ along, weapon == "bolt" and kit.chance(0.4))
    helm(kit, f, helmet, metal, leather)
    if args["legs"] in UPRIGHT and nation in ("french", "soviet") and kit.chance(0.6):
        f.skirt(cloth, rng.uniform(0.4, 0.6), 1.0)
    else:
        f.chest(CYL, (0, 0, 0.0), (b.deep + 0.032, b.hip + 0.026, 0.12), cloth, (0.88, 1), low=True)
    f.belt(leather, 0.03, 0.12)
    for y in (0.1, -0.1):
        f.chest(BOX, (b.deep + 0.02, y, 0.13), (0.035, 0.055, 0.045), leather if nation == "german" else canvas, low=True)
        f.limb(f.high(b.deep + 0.02, y, 0.16), f.high(0.0, y, 0.565), (0.008, 0.018), 1, leather, BOX)
    f.chest(BOX, (-b.deep - 0.07, 0, 0.34), (0.07, 0.14, 0.15), canvas)
    f.chest(CYL, (-b.deep - 0.07, 0, 0.52), (0.06, 0.06, 0.2), cloth, tilt=ALONG_Y)
    f.chest(BOX, (-0.06, -b.hip - 0.05, 0.0), (0.08, 0.05, 0.09), canvas, low=True)
    buttons(f, leather, 3, 0.22, 0.46)


def ancient(kit):
    """A legionary, a knight, or a samurai, with sword, spear and shield."""
    rng, kind = kit.rng, kit.rng.choice(["legionary", "knight", "samurai"])
    b, steel, leather = build(kit, "man"), plain(kit, np.ones(3) * rng.uniform(0.3, 0.65), 0.55), kit.material(base=[0.14, 0.07, 0.03], pattern=PLAIN)
    gold, right_up = plain(kit, [0.65, 0.45, 0.12], 0.5), kit.chance(0.4)
    colour = plain(kit, paint(rng.choice([0.0, 0.0, 0.6, 0.35, 0.13]), 0.9, rng.uniform(0.15, 0.6)))
    hands = [(0.28, 0.26, 0.2), (0.2, 0.36, 0.85) if right_up else (0.3, 0.26, 0.22)]
    legs = rng.choice(["stand", "rest", "walk", "stride"])
    if kind == "legionary":
        plates = steel._replace(pattern=BANDS, frequency=22.0, second=steel.first * 0.45)
        w = clothe(kit, top=plates, bottom=colour, arm=colour, sleeves=1, trousers=0, shoes=leather)
        f = Figure(kit, b, w, legs, hands=hands, look=turn("y", 3), fists=True)
        helm(kit, f, "galea", steel if kit.chance(0.6) else gold, colour)
        f.chest(CYL, (0, 0, -0.1), (0.17, 0.205, 0.17), colour, (0.78, 1), low=True)
        f.chest(BOX, (b.deep + 0.05, 0, -0.08), (0.015, 0.06, 0.13), leather, low=True)
        f.belt(leather, 0.025, 0.1)
        for side in (1, -1):
            f.chest(BALL, (0, side * (b.shoulder + 0.005), 0.5), (0.085, 0.08, 0.075), plates)
        left = f.hands[0] + [0.09, 0, -0.1]
        kit.add(BOX, left, (0.025, 0.2, 0.5), material=colour)
        for side in (1, -1):
            kit.add(BOX, left + [-0.035, side * 0.255, 0], (0.02, 0.075, 0.5), rotation=turn("z", 28 * side), material=colour)
        kit.add(BALL, left + [0.03, 0, 0], (0.06, 0.09, 0.09), material=gold)
        kit.add(BOX, left + [0.025, 0, 0], (0.012, 0.02, 0.46), material=gold)
        right = f.hands[1]
        if kit.chance(0.55):
            low = 0.0 if not right_up else right[2] - 0.7
            kit.between((right[0], right[1], low), (right[0], right[1], low + 1.35), 0.018, material=leather)
            kit.between((right[0], right[1], low + 1.3), (right[0], right[1], low + 1.95), 0.009, material=steel)
            kit.between((right[0], right[1], low + 1.9), (right[0], right[1], low + 2.05), 0.03, taper=0.1, material=steel)
        else:
            sword(kit, right, [0.5, 0, 0.85], 0.5, steel, leather, gold)
        if kit.chance(0.4):
            f.limb(f.place((-0.26, 0, 0.4)) / b.size, f.high(-0.1, 0, 0.52), (0.03, 0.26), 0.7, colour, BOX)
    elif kind == "knight":
        mail = kit.material(base=np.ones(3) * 0.25, pattern=DOTS, frequency=30, second=[0.08] * 3, gloss=0.3)
        full = kit.chance(0.5)
        w = clothe(
            kit,
            top=steel if full else colour,
            bottom=steel if full else mail,
            arm=steel if full else mail,
            shoes=steel if full else mail,
            gloves=steel,
            cut=0.78,
            thick=1.15,
        )
        both = kit.chance(0.35)
        f = Figure(kit, b, w, legs, hands=[(0.34, -0.02, 0.14), (0.32, 0.05, 0.24)] if both else hands, look=turn("y", 2), fists=True)
        helm(kit, f, rng.choice(["bascinet", "greathelm"]), steel, colour)
        if full:
            f.chest(CYL, (0, 0, -0.03), (b.deep + 0.05, b.hip + 0.045, 0.12), steel, (0.78, 1), low=True)
            f.chest(BALL, (0, b.shoulder + 0.015, 0.49), (0.1, 0.09, 0.085), steel, mirror=True)
        else:
            f.skirt(colour, 0.45 if legs in UPRIGHT else 0.55, 1.05 if legs in UPRIGHT else 1.3)
            f.chest(BOX, (b.deep * 1.05, 0, 0.33), (0.03, 0.03, 0.14), gold)
            f.chest(BOX, (b.deep * 1.05, 0, 0.37), (0.03, 0.09, 0.03), gold)
        f.belt(leather, 0.028, 0.1)
        left, right = f.hands
        if both:
            kit.between((right[0], right[1], right[2] + 0.14), (left[0], left[1], left[2] - 0.02), 0.016, material=leather)
            sword(kit, right, [0.15, 0, 1.0], rng.uniform(0.85, 1.05), steel, leather, gold)
        else:
            sword(kit, right, [0.3, 0, 0.95], rng.uniform(0.65, 0.85), steel, leather, gold)
            kit.add(BOX, left + [0.06, 0, 0.05], (0.022, 0.23, 0.18), material=colour)
            kit.add(BOX, left + [0.06, 0, -0.34], (0.022, 0.23, 0.22), (1, 0.08), rotation=turn("x", 180), material=colour)
            kit.add(BOX, left + [0.078, 0, -0.04], (0.012, 0.03, 0.26), material=gold)
            kit.add(BOX, left + [0.078, 0, 0.08], (0.012, 0.22, 0.03), material=gold)
    else:
        lacquer = colour if kit.chance(0.5) else plain(kit, [0.03, 0.025, 0.02], 0.4)
        plates = lacquer._replace(pattern=BANDS, frequency=18.0, second=np.array([0.02, 0.02, 0.02]))
        w = clothe(kit, top=plates, bottom=fabric(kit), arm=fabric(kit), shoes=leather, cut=1.3, thick=1.15)
        both = kit.chance(0.7)
        f = Figure(
            kit,
            b,
            w,
            rng.choice(["stride", "stand", "apart", "kneel"]),
            hands=[(0.36, 0.0, 0.18), (0.34, 0.06, 0.28)] if both else ARMS["hang"],
            look=turn("y", 2),
            fists=True,
        )
        helm(kit, f, "kabuto", lacquer, gold if kit.chance(0.3) else plates)
        for side in (1, -1):
            f.chest(BOX, (0, side * (b.shoulder + 0.06), 0.4), (0.1, 0.02, 0.13), plates, (0.85, 1), turn("x", 12 * side))
            f.chest(BOX, (0.02, side * 0.13, -0.12), (0.1, 0.07, 0.14), plates, (0.85, 0.8), turn("x", 10 * side), low=True)
        f.chest(BOX, (b.deep + 0.02, 0, -0.1), (0.025, 0.08, 0.13), plates, (1, 0.85), turn("y", -8), low=True)
        f.belt(fabric(kit), 0.035, 0.1)
        f.wrap(0, 0.1, 0.95, (0.085, 0.08), plates, CYL, 1.1)
        left, right = f.hands
        if both:
            kit.between(left - [0, 0, 0.06], right + [0, 0, 0.04], 0.017, material=leather)
            sword(kit, right, [0.25, 0, 0.97], 0.72, steel, leather, gold, True)
        f.limb(f.low(0.16, 0.2, 0.16), f.low(-0.5, 0.26, -0.02), (0.02, 0.013), 1, plain(kit, [0.03, 0.01, 0.01], 0.4))


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


def napoleonic(kit):
    """A musketeer of the line, a redcoat, or one of the plumed hat and rapier."""
    rng, kind = kit.rng, kit.rng.choice(["line", "line", "redcoat", "plumed"])
    white, gold, dark = plain(kit, [0.78, 0.76, 0.7]), plain(kit, [0.65, 0.45, 0.12], 0.5), kit.material(dark=True, pattern=PLAIN)
    base = paint(rng.choice([0.62, 0.0, 0.33, 0.6]), 0.85, rng.uniform(0.08, 0.35)) if kind != "redcoat" else np.array([0.5, 0.03, 0.03])
    coat, second = plain(kit, base), plain(kit, paint(rng.choice([0.0, 0.15, 0.6]), 0.9, 0.5))
    b = build(kit, "man")
    w = clothe(kit, top=coat, bottom=white if kit.chance(0.7) else plain(kit, [0.25, 0.25, 0.25]), shoes=dark, cut=0.85, thick=1.1)
    if kind == "plumed" and kit.chance(0.5):
        f = Figure(kit, b, w, rng.choice(["stride", "rest"]), hands=[(0.04, 0.2, 0.06), (0.52, 0.2, 0.4)], look=turn("y", 2), fists=True)
        sword(kit, f.hands[1], [0.95, 0, 0.2], 0.85, plain(kit, [0.6] * 3, 0.5), dark, gold)
    elif kit.chance(0.4):
        f = Figure(kit, b, w, rng.choice(["attention", "walk", "high_knee"]), hands=[(0.02, 0.25, -0.05), (0.14, 0.18, 0.06)], look=turn("y", 2), fists=True)
        gun(kit, f, "musket", f.high(0.15, -0.19, 0.02), f.trunk @ np.array([-0.08, 0.02, 1.0]), kit.chance(0.7))
    else:
        args, butt, along = aim(kit, "musket", rng.choice(["stand", "walk", "kneel"]))
        f = Figure(kit, b, w, **args)
        gun(kit, f, "musket", f.high(*butt), f.trunk @ along, kit.chance(0.6))
    helm(kit, f, {"line": rng.choice(["shako", "shako", "bearskin"]), "redcoat": rng.choice(["tricorn", "shako"]), "plumed": "plumed"}[kind], dark, second)
    for y in (0.1, -0.1):
        f.limb(f.high(b.deep * 1.1, -y, 0.14), f.high(0.02, y, 0.56), (0.008, 0.026), 1, white, BOX)
        f.limb(f.low(-0.1, y * 0.8, 0.1), f.low(-0.2, y * 0.9, -0.32), (0.02, 0.065), 0.9, coat, BOX)
    f.chest(BALL, (0, b.shoulder + 0.01, 0.545), (0.06, 0.06, 0.028), gold if kit.chance(0.5) else second, mirror=True)
    f.chest(CYL, (0.004, 0, 0.585), (0.066, 0.068, 0.03), second)
    f.chest(BOX, (b.deep * 0.95, 0, 0.3), (0.04, 0.06, 0.16), second if kit.chance(0.6) else white, (0.8, 1.3))
    f.belt(white, 0.022, 0.12)
    f.wrap(0, 0.0, 0.85, 0.062, dark, CYL, 1.3)
    if kind != "plumed":
        f.chest(BOX, (-b.deep - 0.07, 0, 0.34), (0.065, 0.15, 0.12), kit.material(base=[0.3, 0.18, 0.1], pattern=CLOUDY))
        f.chest(CYL, (-b.deep - 0.07, 0, 0.5), (0.06, 0.06, 0.19), plain(kit, [0.4] * 3), tilt=ALONG_Y)


def soldier_kit(kit):
    """Soldiers, guards, sailors, pilots, divers, paratroopers, riot police, firefighters, medics, of all ages; as toys of one plastic on bases too."""
    kind = kit.rng.choice([modern, parade, service, great_war, ancient, napoleonic], p=[0.36, 0.1, 0.25, 0.12, 0.1, 0.07])
    kind(kit)
    if kind is not service and kit.chance(0.12):
        toy = kit.material(
            base=[[0.06, 0.2, 0.05], [0.5, 0.4, 0.2], [0.25, 0.27, 0.28], [0.03, 0.1, 0.3]][kit.rng.integers(4)], pattern=PLAIN, gloss=kit.rng.uniform(0.1, 0.4)
        )
        if kit.chance(0.7):
            kit.primitives[:] = [p._replace(material=toy) for p in kit.primitives]
        low = min(lowest(p) for p in kit.primitives)
        feet = [p.centre for p in kit.primitives if lowest(p) < low + 0.12]
        first, last = np.min(feet, 0), np.max(feet, 0)
        half = (last - first) / 2 + [0.2, 0.18, 0]
        base = kit.primitives[:58]
        kit.primitives[:] = base
        shape = BALL if kit.chance(0.3) else CYL
        kit.add(shape, (*((first + last) / 2)[:2], low), (half[0], half[1], 0.035), (0.95, 1), material=toy)
    finish(kit, 0.15)
