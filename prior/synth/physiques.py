"""What the makers of posed people and troops share: proportions, poses of arms and legs, and bodies of true anatomy."""

from types import SimpleNamespace

import numpy as np

from .bodies import FORE, SHIN, THIGH, UPPER, bent
from .figures import bar, head_frame, plain
from .kit import mirrored, towards, turn
from .layout import BALL, BOX, CYL

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


def finish(kit, left_handed=0.5):
    """Mirrors the whole object as often as not."""
    if kit.chance(left_handed):
        kit.primitives[:] = [mirrored(p) for p in kit.primitives]
