"""Mopeds, and scooters small and large."""

import numpy as np

from .cycle_parts import RED, WHITE, Bike, bars, chassis, finish, fins, flat, front_guard, lacquer, lean, open_wheel, rear_guard, round_lamp, shocks, steered
from .kit import ALONG_X, ALONG_Y, turn
from .layout import BALL, BARS, BOX, CYL, SPOKES
from .materials import PLAIN, RIBS, WRITING
from .roadcraft import arch, chrome, hide, rubber, section, slab
from .wheeled import glazing


def moped(kit):
    """Mopeds with pedals, a tank or a step through, and small utility bikes with leg shields and rack."""
    rng = kit.rng
    step = kit.chance(0.6)
    b = chassis(kit, rng.uniform(0.57, 0.63), (0.29, 0.29), (0.033, 0.036), rng.uniform(24, 28), 0.9, rng.uniform(0.74, 0.79), "wire" if kit.chance(0.8) else "cast", "tele")
    z = b.saddle
    b = b._replace(pivot=np.array([-0.1, 0, 0.34]))
    neck = b.head - b.up * 0.14
    kit.add(BOX, (0.0, 0, 0.3), (0.14, 0.07, 0.09), (0.85, 0.9), material=b.engine)
    kit.add(CYL, (0.18, 0, 0.33), (0.065, 0.065, 0.09), rotation=turn("y", 80), material=fins(kit))
    kit.add(CYL, (0.0, 0, 0.31), (0.08, 0.08, 0.11), rotation=ALONG_Y, material=b.metal if kit.chance(0.5) else b.engine)
    if step:
        kit.between(neck, (0.1, 0, 0.42), (0.06, 0.05), BOX, 1.2, b.paint)
        kit.between((0.14, 0, 0.43), (-0.26, 0, 0.5), (0.07, 0.06), BOX, 1.1, b.paint)
        kit.between((-0.18, 0, 0.46), (-0.26, 0, z - 0.04), (0.11, 0.09), BOX, 0.9, b.paint)
        if kit.chance(0.5):
            kit.between((0.36, 0.16, 0.72), (0.16, 0.17, 0.26), (0.015, 0.12), BOX, 0.8, flat(kit, [0.75, 0.74, 0.68]), True)
            kit.between((0.36, -0.12, 0.7), (0.36, 0.12, 0.7), 0.03, BOX, material=b.paint)
    else:
        kit.between(neck, (-0.28, 0, 0.62), 0.03, material=b.paint)
        kit.between(neck - b.up * 0.06, (0.05, 0, 0.36), 0.025, material=b.paint)
        kit.between((-0.1, 0, 0.36), (-0.26, 0, z - 0.04), 0.03, material=b.paint)
        kit.add(BALL, (0.08, 0, 0.72), (0.24, 0.1, 0.1), rotation=turn("y", -8), material=b.paint)
        kit.add(BOX, (-0.1, 0, 0.5), (0.1, 0.06, 0.14), material=b.dark)
    kit.between((-0.24, 0.05, z - 0.12), (-b.base - 0.05, 0.06, z - 0.1), 0.016, material=b.paint, mirror=True)
    shocks(kit, b, (-b.base * 0.75, z - 0.1))
    if kit.chance(0.5):
        slab(kit, z - 0.03, z + 0.05, (-0.66, -0.1, 0.11), (-0.64, -0.12, 0.1), b.hide)
    else:
        kit.add(BALL, (-0.26, 0, z + 0.02), (0.16, 0.12, 0.06), material=b.hide)
        kit.add(BOX, (-b.base - 0.02, 0, z - 0.04), (0.2, 0.1, 0.012), material=b.metal, cut=(BARS, 14, 0.4))
        kit.between((-b.base, 0.06, z - 0.1), (-b.base - 0.1, 0.08, z - 0.04), 0.012, material=b.metal, mirror=True)
        if kit.chance(0.4):
            kit.add(BOX, (-b.base - 0.05, 0, z + 0.12), (0.18, 0.2, 0.15), material=kit.material(pattern=rng.choice([PLAIN, WRITING])))
    front_guard(kit, b, 15, 165, 4, b.paint)
    rear_guard(kit, b, 15, 165, 4, b.paint)
    round_lamp(kit, b, 0.075, 0.06, 0.12)
    kit.between((0.16, -0.06, 0.27), (-0.1, -0.12, 0.2), 0.018, material=b.metal)
    kit.between((-0.08, -0.12, 0.2), (-b.base - 0.1, -0.13, 0.26), 0.036, material=b.metal)
    grip = bars(kit, b, rng.uniform(0.3, 0.34), 0.1, 0.16, kit.chance(0.7))
    if kit.chance(0.5):
        for way in (1, -1):
            end = np.array([way * 0.14, way * 0.13, 0.3 - way * 0.09])
            kit.between((0, way * 0.12, 0.3), end, 0.012, material=b.metal)
            kit.add(BOX, end + [0, way * 0.06, 0], (0.035, 0.05, 0.014), material=b.dark)
    finish(kit, b, grip, (-b.base - 0.26, 0, 0.5), None, rng.choice(["side", "centre"]))


def small_scooter(kit):
    """A classic step-through scooter with cowls at the sides, or one of plastic of today, also the sharp-edged electric sort."""
    rng = kit.rng
    classic = kit.chance(0.55)
    paint, dark, metal = (
        (
            kit.material(
                base=rng.choice([[0.75, 0.7, 0.55], [0.3, 0.55, 0.5], [0.5, 0.05, 0.05], [0.75] * 3, [0.25, 0.4, 0.6], [0.7, 0.55, 0.15]]), pattern=PLAIN, gloss=0.5
            )
            if classic and kit.chance(0.6)
            else lacquer(kit)
        ),
        kit.material(dark=True, pattern=PLAIN),
        chrome(kit),
    )
    b = scooter_base(kit, rng.uniform(0.61, 0.66), rng.uniform(0.2, 0.235), 0.05, rng.uniform(0.93, 1.0), paint, dark, metal)
    z, base, radius = b.saddle, b.base, b.radii[0]
    shield = b.head[0] - 0.03
    kit.between((shield - 0.02, 0, b.head[2] - 0.06), (shield + 0.07, 0, 0.3), (0.02, rng.uniform(0.2, 0.26)), BOX, 0.9, paint)
    kit.add(BOX, (0.08, 0, 0.285), (0.34, 0.2, 0.025), material=paint)
    kit.add(BOX, (0.08, 0, 0.315), (0.3, 0.17, 0.008), material=kit.material(base=[0.04] * 3, pattern=RIBS, frequency=25, second=[0.12] * 3))
    kit.add(BOX, (0.05, 0, 0.24), (0.34, 0.08, 0.04), material=dark)
    if classic:
        kit.between((-0.2, 0, 0.28), (-0.22, 0, z - 0.04), (0.06, 0.15), BOX, 0.85, paint)
        kit.add(BALL, (-0.52, 0.15, 0.5), (0.36, 0.11, 0.19), rotation=turn("y", 6), material=paint, mirror=True)
        section(kit, -base - 0.28, -0.2, (0.42, 0.6, 0.1), (0.45, z - 0.02, 0.15), paint)
        with steered(kit, b):
            arch(kit, base, 0, radius, radius + 0.045, 0.075, -5, 160, 4, paint)
            kit.add(BALL, b.head + [0.02, 0, 0.05], (0.13, 0.12, 0.09), material=paint)
            kit.add(CYL, b.head + [0.12, 0, 0.05], (0.068, 0.068, 0.03), rotation=ALONG_X, material=flat(kit, WHITE, 0.6))
        kit.add(BALL, (shield + 0.06, 0, 0.62), (0.05, 0.05, 0.16), material=metal if kit.chance(0.4) else paint)
    else:
        section(kit, shield - 0.02, base - 0.02, (0.42, b.head[2] - 0.06, 0.22), (0.5, 0.78, 0.1), paint)
        kit.add(BOX, (base - 0.08, 0.07, 0.72), (0.05, 0.05, 0.05), shift=(-0.03, 0), material=flat(kit, WHITE, 0.6), mirror=True)
        slab(kit, 0.28, z - 0.04, (-0.5, -0.2, 0.15), (-0.66, -0.16, 0.15), paint)
        section(kit, -base - 0.3, -0.3, (0.62, z + 0.02, 0.07), (0.45, z - 0.03, 0.18), paint)
        with steered(kit, b):
            arch(kit, base, 0, radius, radius + 0.035, 0.07, 20, 150, 3, dark)
            kit.add(BOX, b.head + [0.0, 0, 0.04], (0.1, 0.1, 0.07), (0.7, 0.9), material=paint)
    slab(kit, z - 0.04, z + 0.05, (-0.78, -0.12, 0.13), (-0.74, -0.14, 0.11), hide(kit))
    arch(kit, -base, 0, radius, radius + 0.04, 0.07, 70, 190, 3, dark)
    scooter_end(kit, b, classic)


def maxi_scooter(kit):
    """A maxi scooter: long, faired, with screen, stepped seat, big wheels; some with two wheels before."""
    rng = kit.rng
    paint, dark, metal = lacquer(kit), kit.material(dark=True, pattern=PLAIN), chrome(kit)
    twin = kit.chance(0.35)
    b = scooter_base(kit, rng.uniform(0.75, 0.8), rng.uniform(0.26, 0.29), 0.06, 1.0, paint, dark, metal, 0.2 if twin else 0.0)
    z, base, radius = b.saddle, b.base, b.radii[0]
    section(kit, 0.32, 0.55, (0.34, 1.0, 0.24), (0.48, 1.02, 0.27), paint)
    section(kit, 0.54, base + 0.1, (0.56, 1.02, 0.27), (0.72, 0.82, 0.1), paint)
    kit.between((0.66, 0, 0.98), (0.42, 0, rng.uniform(1.22, 1.42)), (0.012, 0.2), BOX, 0.75, glazing(kit))
    kit.add(BOX, (base + 0.0, 0.1, 0.8), (0.09, 0.06, 0.045), (0.8, 0.8), rotation=turn("z", -30), material=flat(kit, WHITE, 0.6), mirror=True)
    section(kit, -0.1, 0.36, (0.26, 0.6, 0.13), (0.28, 0.72, 0.15), paint)
    kit.add(BOX, (0.12, 0, 0.28), (0.36, 0.24, 0.05), (1, 1), material=dark)
    slab(kit, 0.26, z - 0.03, (-0.48, -0.04, 0.17), (-0.62, -0.06, 0.19), paint if kit.chance(0.6) else dark)
    section(kit, -base - 0.32, -0.35, (z - 0.04, z + 0.1, 0.08), (0.5, z - 0.01, 0.2), paint)
    slab(kit, z - 0.04, z + 0.06, (-0.5, -0.02, 0.17), (-0.48, -0.04, 0.15), b.hide)
    slab(kit, z - 0.02, z + 0.15, (-0.95, -0.46, 0.15), (-0.92, -0.5, 0.13), b.hide)
    with steered(kit, b):
        kit.add(BOX, b.head + [-0.02, 0, 0.04], (0.09, 0.12, 0.06), (0.7, 0.9), material=dark)
        arch(kit, base, 0.2 if twin else 0, radius, radius + 0.035, 0.08, 20, 150, 3, paint)
    arch(kit, -base, 0, radius, radius + 0.04, 0.08, 50, 185, 3, dark)
    scooter_end(kit, b, False)


def scooter_base(kit, base, radius, half, crown, paint, dark, metal, apart=0.0):
    """Wheels, fork and the motor beside the rear wheel of a scooter; `apart`: half the track of two front wheels."""
    rng = kit.rng
    rake = rng.uniform(24, 28)
    up = np.array([-np.sin(np.radians(rake)), 0, np.cos(np.radians(rake))])
    head = np.array([base, 0, radius]) + up * (crown - radius) / up[2]
    steer = 0.0 if apart or kit.chance(0.55) else rng.uniform(-25, 25)
    b = Bike(base, (radius, radius), (half, half), rake, head, up, rng.uniform(0.74, 0.8), np.array([-0.2, 0, 0.28]), steer, paint, paint, dark, metal, metal, hide(kit))
    cut = (SPOKES, int(rng.choice([3, 5, 6, 8])), rng.uniform(0.2, 0.32))
    tyre = rubber(kit)
    open_wheel(kit, (-base, 0, radius), radius, half, tyre, metal, cut)
    section(kit, -base - 0.05, -0.2, (radius - 0.09, radius + 0.09, 0.05), (radius - 0.08, radius + 0.1, 0.07), metal if kit.chance(0.5) else dark, half + 0.06)
    kit.between((-base + 0.02, half + 0.06, radius + 0.05), (-base + 0.08, half + 0.06, 0.62), 0.03, material=fins(kit, [0.3] * 3))
    kit.between((-0.3, -0.12, radius), (-base - 0.14, -half - 0.08, radius + 0.09), (0.06, 0.045), taper=1.15, material=dark if kit.chance(0.6) else metal)
    with steered(kit, b):
        open_wheel(kit, (base, apart, radius), radius, half, tyre, metal, cut, bool(apart))
        side = apart - half - 0.03 if apart else half + 0.03
        kit.between((base, side, radius), np.array([base, side, radius]) + up * 0.3, 0.024, material=metal, mirror=True)
        top = np.array([base, 0, radius]) + up * 0.29
        kit.add(BOX, top, (0.04, max(side, half + 0.03) + 0.03, 0.03), rotation=turn("y", -rake), material=dark)
        kit.between(top, head, 0.035, material=dark)
    return b


def scooter_end(kit, b, classic):
    """Bars, lamp, plate, rack or case and stand of a scooter."""
    rng = kit.rng
    bars(kit, b._replace(head=b.head + [-0.01, 0, 0.05]) if not b.steer else b, rng.uniform(0.3, 0.35), 0.05, 0.12)
    kit.add(BOX, (-b.base - 0.29, 0, 0.62 if classic else b.saddle - 0.02), (0.03, 0.07, 0.03), material=flat(kit, RED))
    kit.between((-b.base - 0.2, 0, 0.5), (-b.base - 0.3, 0, 0.36), (0.012, 0.07), BOX, material=b.dark)
    kit.add(
        BOX,
        (-b.base - 0.3, 0, 0.42),
        (0.008, 0.08, 0.06),
        rotation=turn("y", 25),
        material=kit.material(base=[0.8] * 3, pattern=WRITING, frequency=30, second=[0.02] * 3),
    )
    if kit.chance(0.4):
        kit.add(BOX, (-b.base - 0.2, 0, b.saddle + 0.03), (0.16, 0.09, 0.015), material=b.metal)
        kit.between((-b.base - 0.06, 0.08, b.saddle - 0.08), (-b.base - 0.2, 0.08, b.saddle + 0.03), 0.012, material=b.metal, mirror=True)
        if kit.chance(0.6):
            kit.add(BOX, (-b.base - 0.2, 0, b.saddle + 0.19), (0.17, 0.19, 0.15), (0.9, 0.9), material=kit.material())
    if kit.chance(0.5):
        lean(kit, rng.uniform(5, 9), (-0.1, 0.1, 0.24), b.dark)
    else:
        kit.between((-0.2, 0.08, 0.26), (-0.3, 0.15, 0.0), 0.016, material=b.dark, mirror=True)
