"""Makers of open vehicles: what has neither roof nor doors shows its seats, its floor and its frames."""

import numpy as np

from .kit import ALONG_X, turn
from .layout import BOX, CYL, TUBE
from .machines import wheel
from .materials import CLOUDY, PLAIN, RIBS
from .wheeled import coat, glazing, lamps, plates


def open_car(kit):
    """Utility cars and light trucks with a screen in a frame, seats, roll bars, a bed with walls; some under canvas, some with a gun."""
    rng = kit.rng
    body, dark, seat = coat(kit), kit.material(dark=True), kit.material(pattern=rng.choice([PLAIN, CLOUDY]))
    wide, radius = rng.uniform(0.72, 1.08), rng.uniform(0.33, 0.5)
    floor, belt = radius * rng.uniform(0.9, 1.3), radius * 2 + rng.uniform(0.1, 0.35)
    front, room, bed = rng.uniform(0.55, 0.95), rng.uniform(0.6, 0.95), rng.uniform(0.35, 1.1)
    screen = room  # x of the screen's foot; the bonnet lies before it, the bed behind -room
    nose, tail = screen + 2 * front, -room - 2 * bed
    half = (belt - floor) / 2
    kit.add(BOX, ((nose + tail) / 2, 0, floor + 0.05), ((nose - tail) / 2, wide * 0.97, 0.08), material=body)
    kit.add(BOX, (screen + front, 0, floor + half), (front, wide * rng.uniform(0.7, 1), half), (rng.uniform(0.9, 1), 0.94), material=body)
    sides(kit, screen, room, bed, wide, floor, half, body)
    seats(kit, room, wide, floor, seat, dark)
    frames(kit, screen, room, bed, wide, belt, body, dark)
    tyre, hub = kit.material(dark=True), kit.material(base=rng.uniform(0.1, 0.7) * np.ones(3))
    for x in (screen + front * rng.uniform(0.8, 1.1), tail + radius * rng.uniform(1.1, 1.6)):
        kit.add(BOX, (x, wide * 0.92, radius * 2.05), (radius * 1.25, 0.16, 0.04), (0.8, 1), material=body, mirror=True)
        wheel(kit, (x, wide * 0.88, radius), radius, rng.uniform(0.1, 0.17), tyre, hub)
    lamps(kit, nose, tail, wide, floor + half, rng.uniform(0.07, 0.12))
    plates(kit, nose + 0.05, tail - 0.03, floor)
    kit.add(BOX, (nose, 0, floor + half), (0.02, wide * 0.4, half * 0.6), material=kit.material(pattern=RIBS, frequency=40, second=[0.02] * 3))
    for x in (nose + 0.08, tail - 0.05):
        kit.add(BOX, (x, 0, floor - 0.02), (0.06, wide * 0.95, 0.07), material=dark)
    if kit.chance(0.35):
        kit.add(CYL, (tail - 0.1, rng.choice([0, 0.35]) * wide, floor + half + 0.15), (radius * 0.85, radius * 0.85, 0.1), rotation=ALONG_X, material=tyre)


def sides(kit, screen, room, bed, wide, floor, half, body):
    """Walls of the bed and, before a gap to step in by, of the foot room; a tailgate on most."""
    rng = kit.rng
    gap = rng.uniform(0.55, 0.8)
    ahead = room * 2 * (1 - gap) / 2
    y, z = wide * 0.95, floor + half
    kit.add(BOX, (screen - ahead / 2, y, z), (ahead / 2, 0.04, half), (0.5, 1), (ahead * 0.2, 0), material=body, mirror=True)
    kit.add(BOX, (-room - bed * 0.85, y, z), (bed * 1.15, 0.05, half), material=body, mirror=True)
    if kit.chance(0.8):
        kit.add(BOX, (-room - 2 * bed + 0.04, 0, z), (0.04, wide * 0.95, half), material=body)
    if kit.chance(0.5):
        kit.add(BOX, (-room + 0.1, 0, z), (0.04, wide * 0.9, half), material=body)


def seats(kit, room, wide, floor, cloth, dark):
    """Two in front, with a steering wheel, and a bench behind some."""
    rng = kit.rng
    x = -room * rng.uniform(0.0, 0.35)
    kit.add(BOX, (x, wide * 0.48, floor + 0.25), (0.24, wide * 0.3, 0.13), material=cloth, mirror=True)
    lean = turn("y", -rng.uniform(5, 20))
    kit.add(BOX, (x - 0.27, wide * 0.48, floor + 0.6), (0.06, wide * 0.28, rng.uniform(0.25, 0.4)), rotation=lean, material=cloth, mirror=True)
    kit.add(TUBE, (x + 0.5, wide * rng.choice([-0.48, 0.48]), floor + 0.62), (0.2, 0.2, 0.025), rotation=turn("y", -60), material=dark)
    kit.add(BOX, (room * 0.92, 0, floor + 0.55), (0.08, wide * 0.88, 0.1), material=dark)
    if kit.chance(0.4):
        kit.add(BOX, (-room - 0.3, 0, floor + 0.3), (0.2, wide * 0.75, 0.1), material=cloth)


def frames(kit, screen, room, bed, wide, belt, body, dark):
    """The screen's frame and pane, roll bars, a canvas roof or a gun on a post."""
    rng = kit.rng
    tall, lean = rng.uniform(0.35, 0.65), rng.uniform(0.0, 0.25)
    foot, top = np.array([screen, wide * 0.88, belt - 0.05]), np.array([screen - lean, wide * 0.84, belt + tall])
    flip = np.array([1, -1, 1])
    kit.between(foot, top, 0.035, BOX, material=body, mirror=True)
    kit.between(top, top * flip, 0.03, BOX, material=body)
    kit.add(BOX, (foot + top) / 2 * [1, 0, 1], (0.012, wide * 0.82, tall * 0.52), rotation=turn("y", -np.degrees(np.arctan2(lean, tall))), material=glazing(kit))
    covered = kit.chance(0.3)
    bar = dark if kit.chance(0.5) else body
    if covered or kit.chance(0.65):
        for x in (-room * 0.75, -room - 1.6 * bed)[: 2 if covered else int(rng.integers(1, 3))]:
            high = np.array([x, wide * 0.82, belt + tall * rng.uniform(0.95, 1.1)])
            kit.between((x - 0.05, wide * 0.88, belt - 0.1), high, 0.032, material=bar, mirror=True)
            kit.between(high, high * flip, 0.032, material=bar)
    if covered:
        canvas = kit.material(pattern=rng.choice([PLAIN, CLOUDY]))
        end = -room - (1.6 * bed if kit.chance(0.6) else 0)
        kit.add(BOX, ((top[0] + end) / 2, 0, belt + tall + 0.06), ((top[0] - end) / 2, wide * 0.9, 0.06), (0.97, 0.9), material=canvas)
    elif kit.chance(0.25):
        post = np.array([-room - bed * 0.6, 0, belt + tall * 1.1])
        kit.between(post - [0, 0, tall * 1.1 + 0.3], post, 0.05, material=dark)
        kit.add(BOX, post + [0.1, 0, 0.06], (0.35, 0.07, 0.08), material=dark)
        kit.between(post + [0.4, 0, 0.08], post + [rng.uniform(0.8, 1.4), 0, 0.1], 0.025, material=dark)
    if kit.chance(0.4):
        kit.between((-room - 1.9 * bed, wide * 0.85, belt), (-room - 1.9 * bed, wide * 0.85, belt + rng.uniform(0.7, 1.8)), 0.012, material=dark)
    kit.add(BOX, (screen * 0.97, wide * 1.08, belt + 0.12), (0.03, 0.09, 0.1), material=dark, mirror=True)
