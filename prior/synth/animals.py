"""What the makers of animals share: coats, hulls of balls and frusta, limbs, heads."""


import numpy as np

from .kit import towards, turn
from .layout import BALL, CYL
from .materials import CLOUDY, PLAIN, STREAKS

BLACK, WHITE, GREY, BROWN, DARK = (0.03, 0.03, 0.03), (0.8, 0.77, 0.7), (0.22, 0.21, 0.2), (0.2, 0.1, 0.045), (0.07, 0.04, 0.025)
TAN, RED, CREAM, PINK, ORANGE = (0.42, 0.27, 0.13), (0.3, 0.1, 0.035), (0.68, 0.56, 0.38), (0.65, 0.36, 0.3), (0.6, 0.25, 0.05)


def fur(kit, *colours, pattern=None, frequency=None, second=None, gloss=0.02):
    """A coat of one of the colours, lighter or darker, with shades or markings of its own."""
    rng = kit.rng
    base = np.array(colours[rng.integers(len(colours))]) * np.exp(rng.normal(0, 0.2)) * np.exp(rng.normal(0, 0.06, 3))
    second = base * rng.uniform(0.45, 0.85) if second is None else np.array(second) * np.exp(rng.normal(0, 0.15))
    pattern = rng.choice([PLAIN, CLOUDY, CLOUDY, STREAKS]) if pattern is None else pattern
    return kit.material(base=base, pattern=pattern, frequency=frequency or rng.uniform(6, 18), second=second, gloss=gloss)


def black(kit):
    return kit.material(base=[0.015, 0.013, 0.012], pattern=PLAIN, gloss=0.5)


def hull(kit, points, radii, material, flat=1.0, mirror=False, first=True):
    """A body through `points` of these radii, `flat` times as wide as deep; its patterns go around it."""
    points = np.array(points, float)
    radii = np.broadcast_to(np.array(radii, float), len(points))
    flat = np.broadcast_to(np.array(flat, float), len(points))
    for i in range(len(points) - 1):
        kit.between(points[i], points[i + 1], (radii[i], radii[i] * flat[i]), CYL, radii[i + 1] / radii[i], material, mirror)
    for i in range(0 if first else 1, len(points)):
        way = towards(points[min(i + 1, len(points) - 1)] - points[max(i - 1, 0)])
        kit.add(BALL, points[i], (radii[i], radii[i] * flat[i], radii[i]), rotation=way, material=material, mirror=mirror)


def bend(start, middle, end, count):
    """`count` points [count, 3] of a curve from start to end that leans towards `middle`."""
    t = np.linspace(0, 1, count)[:, None]
    start, middle, end = (np.array(p, float) for p in (start, middle, end))
    return (1 - t) ** 2 * start + 2 * t * (1 - t) * middle + t**2 * end


def looking(kit, down, wide=30):
    """The frame of a head that looks `down` by so many degrees, in half of all aside as well."""
    aside = np.clip(kit.rng.normal(0, wide), -70, 70) if kit.chance(0.5) else 0.0
    return turn("z", aside) @ turn("y", down)


def neck_turned(kit, most):
    """Degrees, left or right, by which a neck turns: in half of all not at all."""
    return 0.0 if kit.chance(0.5) else kit.rng.choice([-1, 1]) * kit.rng.uniform(15, most)


def swung(points, yaw):
    """The path [n, 3] of a neck as it turns aside about its first point, the more the further up: by `yaw` degrees at its end."""
    points = np.array(points, float)
    shares = np.linspace(0, 1, len(points))
    return np.array([points[0] + turn("z", yaw * k) @ (p - points[0]) for k, p in zip(shares, points, strict=True)])


class Head:
    """What sits on a skull of radius `size` at `at`: places in its own frame, in units of `size`."""

    def __init__(self, kit, at, facing, size):
        self.kit, self.at, self.facing, self.size = kit, np.array(at, float), facing, size

    def place(self, x, y, z):
        return self.at + self.facing @ np.array([x, y, z]) * self.size

    def ball(self, where, half, material, both=False, tilt=(0, 0)):
        """An ellipsoid; `both`: one on either side; `tilt`: outwards and backwards, in degrees."""
        for side in (1, -1) if both else (1,):
            rotation = self.facing @ turn("x", -tilt[0] * side) @ turn("y", -tilt[1])
            self.kit.add(BALL, self.place(where[0], where[1] * side, where[2]), np.array(half) * self.size, rotation=rotation, material=material)

    def rods(self, points, radii, material, both=True):
        """Rounded limbs through points; `both`: on either side."""
        for side in (1, -1) if both else (1,):
            hull(self.kit, [self.place(x, y * side, z) for x, y, z in points], np.array(radii) * self.size, material, first=False)

    def ear(self, kind, size, coat, inner=None):
        """Ears that prick, flop, stick out sideways, stand as leaves, or are round."""
        for side in (1, -1):
            if kind == "prick":
                foot, tip = self.place(-0.1, 0.55 * side, 0.6), self.place(-0.05, (0.6 + 0.25 * size) * side, 0.75 + size)
                self.kit.between(foot, tip, np.array([0.22, 0.42]) * self.size * max(size, 0.6), CYL, 0.1, coat)
                if inner:
                    ahead = self.facing @ np.array([0.13, 0, 0]) * self.size
                    self.kit.between(foot + ahead, tip, np.array([0.14, 0.26]) * self.size * max(size, 0.6), CYL, 0.1, inner)
        if kind == "round":
            self.ball((-0.1, 0.75, 0.72), (0.2 * size, 0.5 * size, 0.5 * size), coat, True)
            if inner:
                self.ball((0.02, 0.75, 0.72), (0.15 * size, 0.3 * size, 0.3 * size), inner, True)
        elif kind == "flop":
            self.ball((-0.05, 0.86, 0.35 - 0.45 * size), (0.42 * size**0.5, 0.16, 0.75 * size), coat, True, (-14, 8))
        elif kind == "side":
            self.ball((-0.25, 0.85 + 0.5 * size, 0.35), (0.16, 0.65 * size, 0.32 * size**0.5), coat, True, (12, 0))
            if inner:
                self.ball((-0.16, 0.88 + 0.5 * size, 0.35), (0.12, 0.45 * size, 0.2 * size**0.5), inner, True, (12, 0))
        elif kind == "leaf":
            self.ball((-0.2, 0.5 + 0.2 * size, 0.7 + 0.7 * size), (0.17, 0.3, 0.85 * size), coat, True, (16, 10))
            if inner:
                self.ball((-0.08, 0.5 + 0.2 * size, 0.7 + 0.7 * size), (0.1, 0.19, 0.68 * size), inner, True, (16, 10))

    def eyes(self, x, y, z, size, iris=None):
        if iris:
            self.ball((x, y, z), (size * 1.35, size * 1.1, size * 1.35), iris, True)
        ahead = size * 0.6 if iris else 0
        self.ball((x + ahead, y + ahead * 0.4, z), (size,) * 3, black(self.kit), True)


def limb(kit, top, foot, fore, reach, radius, coat, lower, end, heavy=False):
    """A leg from shoulder or hip to the ground: elbow and knee in front, stifle and hock behind; `end`: hoof, paw or pad."""
    top, foot = np.array(top, float), np.array(foot, float)
    down = foot - top
    far = np.linalg.norm(down)
    ahead = np.array([-down[2], 0, down[0]])
    more = 0.45 * max(0.0, 1 - far / reach)
    if fore:
        joints = [(0.4, -0.04 - more), (0.68, 0.02 + 0.9 * more)]
    else:
        joints = [(0.36, (0.03 if heavy else 0.1) + more), (0.67, (-0.03 if heavy else -0.1) - 0.8 * more)]
    first, second = (top + share * down + off * ahead for share, off in joints)
    kit.add(BALL, top * 0.75 + first * 0.25, (radius * (2.2 if fore else 2.9), radius * 1.5, far * 0.27), rotation=towards(top - first), material=coat)
    sole = radius * (0.7 if end == "paw" else 1.2)
    ankle = foot + [0, 0, sole]
    if heavy:
        hull(kit, [top, (first + second) / 2, ankle], [radius * 1.7, radius * 1.15, radius], lower, first=False)
    else:
        kit.between(top, first, radius * (1.9 if fore else 2.2), CYL, 0.72, coat)
        kit.chain([first, second], [radius * (1.35 if fore else 1.55), radius], lower)
        kit.add(BALL, first, (radius * (1.35 if fore else 1.55),) * 3, material=lower)
        kit.between(second, ankle, radius, CYL, 0.8, lower)
    if end == "hoof":
        kit.add(CYL, foot + [radius * 0.25, 0, radius * 0.65], (radius * 1.4, radius * 1.15, radius * 0.65), (0.7, 1), material=fur(kit, BLACK, DARK, GREY))
    elif end == "paw":
        kit.add(BALL, foot + [radius * 0.7, 0, radius * 0.65], (radius * 1.75, radius * 1.2, radius * 0.65), material=lower)
    else:
        kit.add(CYL, foot + [radius * 0.1, 0, radius * 0.5], (radius * 1.3, radius * 1.2, radius * 0.5), (0.85, 1), material=lower)
