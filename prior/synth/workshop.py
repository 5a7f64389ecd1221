"""Makers of engines, machine tools, pumps, lift trucks, robots, instruments and workshop things."""

import numpy as np

from .belongings import black, brass, enamel, lens, pale, steel, timber
from .fittings import bent, box, disc, glass, iron, near, pick, planks, posts, rod, shining, stone
from .kit import ALONG_X, ALONG_Y, around, turn
from .layout import BALL, BARS, BOX, CYL, PRISM, SPOKES, TUBE
from .materials import BANDS, CHECKER, PLAIN, RIBS, STRIPES, WRITING
from .toys import bright


def machine(kit):
    """Engines, lathes, drill presses, pumps, compressors, stackers and forklifts, conveyors, robot arms, cameras and telescopes on tripods, searchlights, racks, 3D printers, mixers,
    anvils, vices, workbenches, cable drums, gas bottles, valves, fans, satellites, cannon, catapults, water wheels."""
    pick(
        kit,
        [v_engine, radial, lathe, drill_press, pump, compressor, stacker, stacker, lift_truck, lift_truck, conveyor, robot_arm, robot_arm, tripod, searchlight, server, printer]
        + [mixer, anvil, vice, workbench, cable_drum, bottles, valve, fan, satellite, cannon, catapult, water_wheel],
    )


def v_engine(kit):
    block, metal, dark, n = near(kit, (0.3, 0.3, 0.3), (0.4, 0.05, 0.03), (0.05, 0.12, 0.3)), steel(kit), black(kit), int(kit.rng.choice([3, 4, 6]))
    long = 0.13 * n
    posts(kit, long * 0.8, 0.25, 0, 0.4, 0.03, dark, 1.2, BOX)
    box(kit, (0, 0, 0.4), (long, 0.2, 0.16), block, taper=(1, 1.2))
    box(kit, (0, 0, 0.2), (long * 0.9, 0.15, 0.07), dark)
    for side in (-1, 1):
        spin = turn("x", -40 * side)
        kit.add(BOX, np.array([0, 0, 0.45]) + spin @ [0, 0, 0.22], (long, 0.12, 0.2), rotation=spin, material=block)
        kit.add(BOX, np.array([0, 0, 0.45]) + spin @ [0, 0, 0.47], (long * 0.97, 0.1, 0.06), (0.97, 0.7), rotation=spin, material=metal)
        for k in range(n):
            x = (k - (n - 1) / 2) * 0.25
            rod(kit, (x, side * 0.32, 0.55), (x, side * 0.5, 0.4), 0.04, iron(kit))
        rod(kit, (-long, side * 0.5, 0.4), (long * 0.9, side * 0.5, 0.4), 0.055, iron(kit))
    box(kit, (0, 0, 0.75), (long * 0.8, 0.12, 0.1), metal)
    disc(kit, (0, 0, 0.9), 0.22, 0.06, dark)
    for y, z, r in ((0, 0.35, 0.15), (0, 0.62, 0.12), (0.25, 0.5, 0.08), (-0.25, 0.5, 0.08)):
        disc(kit, (long + 0.05, y, z), r, 0.06, metal, rotation=ALONG_X)
    disc(kit, (-long - 0.1, 0, 0.4), 0.24, 0.12, block, rotation=ALONG_X, taper=1.2)


def radial(kit):
    n, metal, dark = int(kit.rng.choice([5, 7, 9])), steel(kit), black(kit)
    z = 0.95
    disc(kit, (0, 0, z), 0.25, 0.22, near(kit, (0.25, 0.27, 0.3)), rotation=ALONG_X)
    disc(kit, (0.3, 0, z), 0.16, 0.12, metal, rotation=ALONG_X, taper=0.5)
    rod(kit, (0.3, 0, z), (0.6, 0, z), 0.05, metal)
    for y, up in around(n, 1, 90):
        out = np.array([0, y, up])
        at = np.array([0, 0, z])
        kit.between(at + out * 0.2, at + out * 0.55, 0.115, material=dark._replace(pattern=BANDS, frequency=25.0, second=metal.first))
        kit.between(at + out * 0.53, at + out * 0.64, 0.12, CYL, 0.8, material=metal)
        rod(kit, at + out * 0.24 + [0.17, 0, 0], at + out * 0.6 + [0.1, 0, 0], 0.015, metal)
    for x in (-0.5, 0.2):
        rod(kit, (x, 0.45, 0), (-0.25, 0.15, z), 0.03, dark, True, BOX)
    disc(kit, (-0.25, 0, z), 0.28, 0.06, dark, rotation=ALONG_X)
    box(kit, (-0.15, 0.45, 0.03), (0.4, 0.04, 0.03), dark, True)


def lathe(kit):
    paint, metal = near(kit, (0.1, 0.25, 0.15), (0.3, 0.35, 0.35), (0.1, 0.2, 0.35)), steel(kit)
    for y in (-0.75, 0.7):
        box(kit, (0, y, 0.4), (0.22, 0.22, 0.4), paint)
    box(kit, (0, 0, 0.83), (0.2, 1.05, 0.05), paint)
    box(kit, (0, 0.05, 0.92), (0.14, 0.85, 0.05), metal)
    box(kit, (0, -0.8, 1.1), (0.22, 0.25, 0.23), paint)
    disc(kit, (0, -0.5, 1.12), 0.15, 0.06, metal, rotation=ALONG_Y)
    rod(kit, (0, -0.5, 1.12), (0, 0.3, 1.12), 0.04, metal)
    box(kit, (0, 0.7, 1.05), (0.12, 0.15, 0.14), paint)
    rod(kit, (0, 0.4, 1.12), (0, 0.95, 1.12), 0.05, metal)
    disc(kit, (0, 0.95, 1.12), 0.11, 0.02, iron(kit), rotation=ALONG_Y)
    box(kit, (0.08, 0, 0.95), (0.2, 0.17, 0.06), paint)
    box(kit, (0.05, 0, 1.06), (0.1, 0.08, 0.05), metal)
    box(kit, (0.24, 0, 0.83), (0.04, 0.17, 0.14), paint)
    disc(kit, (0.31, 0.05, 0.83), 0.09, 0.015, iron(kit), rotation=ALONG_X)
    rod(kit, (0.24, -0.9, 0.74), (0.24, 0.95, 0.74), 0.016, metal)


def drill_press(kit):
    paint, metal, high = near(kit, (0.1, 0.25, 0.15), (0.05, 0.15, 0.35), (0.35, 0.36, 0.36)), steel(kit), kit.rng.uniform(1.0, 1.7)
    box(kit, (0.05, 0, 0.04), (0.3, 0.2, 0.04), paint)
    rod(kit, (-0.12, 0, 0), (-0.12, 0, high), 0.05, metal)
    box(kit, (0.1, 0, high * 0.55), (0.17, 0.17, 0.02), paint)
    box(kit, (-0.08, 0, high * 0.53), (0.09, 0.07, 0.05), paint)
    box(kit, (0.02, 0, high), (0.26, 0.11, 0.14), paint)
    box(kit, (0, 0, high + 0.18), (0.3, 0.13, 0.05), iron(kit))
    disc(kit, (-0.3, 0, high), 0.1, 0.15, paint)
    rod(kit, (0.15, 0, high), (0.15, 0, high - 0.25), 0.045, metal)
    rod(kit, (0.15, 0, high - 0.25), (0.15, 0, high - 0.38), 0.012, metal)
    for a in (30, 150, 270):
        tip = np.array([0.1 + 0.2 * np.cos(np.radians(a)), 0.16, high - 0.02 + 0.2 * np.sin(np.radians(a))])
        rod(kit, (0.1, 0.14, high - 0.02), tip, 0.01, metal)
        kit.add(BALL, tip, (0.025,) * 3, material=black(kit))
    rod(kit, (0.1, 0.1, high - 0.02), (0.1, 0.17, high - 0.02), 0.025, metal)


def motor(kit, x, z, r, half, paint):
    """An electric motor along x with its fins, box and feet."""
    disc(kit, (x, 0, z), r, half, paint._replace(pattern=RIBS, frequency=18.0), rotation=ALONG_X)
    disc(kit, (x - half - 0.05, 0, z), r * 0.95, 0.06, black(kit), rotation=ALONG_X)
    box(kit, (x, 0, z + r), (0.09, 0.08, 0.07), paint)
    box(kit, (x, r * 0.7, z / 2), (half * 0.7, 0.06, z / 2), paint, True)


def pump(kit):
    paint, frame = near(kit, (0.05, 0.15, 0.4), (0.1, 0.3, 0.15), (0.4, 0.05, 0.03)), iron(kit)
    box(kit, (0, 0, 0.05), (0.85, 0.3, 0.05), frame)
    motor(kit, -0.35, 0.4, 0.23, 0.35, paint)
    rod(kit, (0, 0, 0.4), (0.4, 0, 0.4), 0.05, steel(kit))
    box(kit, (0.2, 0, 0.42), (0.12, 0.12, 0.12), near(kit, (0.7, 0.45, 0.03)))
    disc(kit, (0.5, 0, 0.4), 0.3, 0.11, paint, rotation=ALONG_X)
    rod(kit, (0.5, 0.2, 0.4), (0.5, 0.2, 0.95), 0.09, paint)
    disc(kit, (0.5, 0.2, 0.95), 0.16, 0.025, paint)
    rod(kit, (0.6, 0, 0.4), (0.9, 0, 0.4), 0.11, paint)
    disc(kit, (0.9, 0, 0.4), 0.18, 0.025, paint, rotation=ALONG_X)
    box(kit, (0.5, 0, 0.12), (0.12, 0.15, 0.1), paint)


def compressor(kit):
    paint, r, long = near(kit, (0.5, 0.04, 0.03), (0.05, 0.2, 0.45), (0.6, 0.4, 0.03)), kit.rng.uniform(0.2, 0.3), kit.rng.uniform(0.5, 0.8)
    z = r + 0.12
    disc(kit, (0, 0, z), r, long, paint, rotation=ALONG_X)
    for x in (-long, long):
        kit.add(BALL, (x, 0, z), (0.12, r, r), material=paint)
    disc(kit, (-long * 0.7, r + 0.03, 0.13), 0.13, 0.04, black(kit), True, ALONG_Y)
    rod(kit, (-long * 0.7, -r, 0.13), (-long * 0.7, r, 0.13), 0.03, iron(kit))
    box(kit, (long * 0.7, 0, 0.09), (0.05, r * 0.7, 0.09), paint)
    box(kit, (0, 0, z + r + 0.02), (long * 0.75, r * 0.75, 0.02), paint)
    motor_z = z + r + 0.16
    disc(kit, (-long * 0.4, 0, motor_z), 0.13, 0.17, iron(kit), rotation=ALONG_X)
    box(kit, (long * 0.4, 0, motor_z), (0.13, 0.13, 0.12), iron(kit))
    for y in (-0.09, 0.09):
        disc(kit, (long * 0.4, y, motor_z + 0.2), 0.075, 0.11, steel(kit)._replace(pattern=BANDS, frequency=20.0))
    disc(kit, (long * 0.4, 0.2, motor_z + 0.03), 0.19, 0.03, black(kit), rotation=ALONG_Y, cut=(SPOKES, 5, 0.3))
    rod(kit, (-long, 0.15, z), (-long - 0.35, 0.15, z + r + 0.2), 0.018, iron(kit), True)
    rod(kit, (-long - 0.35, -0.15, z + r + 0.2), (-long - 0.35, 0.15, z + r + 0.2), 0.022, black(kit))


def mast_forks(kit, x, half, high, lift, dark, metal):
    """An upright mast at `x` with chains, a carriage at the height `lift` and two forks ahead."""
    rod(kit, (x, half, 0.05), (x, half, high), (0.06, 0.035), dark, True, BOX)
    for z in (0.15, high * 0.6, high):
        rod(kit, (x, -half, z), (x, half, z), 0.035, dark, kind=BOX)
    rod(kit, (x, half * 0.35, 0.1), (x, half * 0.35, high), 0.016, metal, True)
    rod(kit, (x, 0, 0.1), (x, 0, high * 0.95), 0.035, metal)
    for z in (lift + 0.08, lift + 0.36):
        box(kit, (x + 0.08, 0, z), (0.03, half + 0.07, 0.04), dark)
    box(kit, (x + 0.13, half * 0.7, lift + 0.22), (0.025, 0.05, 0.22), metal, True)
    box(kit, (x + 0.6, half * 0.7, lift + 0.02), (0.5, 0.055, 0.02), metal, True, taper=(1, 1))


def stacker(kit):
    """Pedestrian stackers and pallet trucks."""
    paint, dark, metal = near(kit, (0.65, 0.4, 0.02), (0.55, 0.05, 0.03), (0.65, 0.2, 0.02), (0.1, 0.3, 0.2)), black(kit), iron(kit)
    if kit.chance(0.6):
        mast_forks(kit, 0, 0.28, kit.rng.uniform(1.5, 2.2), kit.rng.uniform(0.08, 1.0), dark, metal)
        box(kit, (0.5, 0.36, 0.08), (0.55, 0.06, 0.05), paint, True)
        rod(kit, (0, -0.38, 0.12), (0, 0.38, 0.12), 0.05, paint, kind=BOX)
        disc(kit, (0.95, 0.36, 0.06), 0.06, 0.05, dark, True, ALONG_Y)
        box(kit, (-0.3, 0, 0.45), (0.26, 0.36, 0.38), paint, taper=(0.9, 0.95))
    else:
        box(kit, (0.55, 0.18, 0.18), (0.6, 0.08, 0.03), paint, True)
        box(kit, (-0.1, 0, 0.3), (0.12, 0.26, 0.15), paint)
        disc(kit, (1.0, 0.18, 0.08), 0.08, 0.05, dark, True, ALONG_Y)
        rod(kit, (-0.15, 0, 0.1), (-0.15, 0, 0.5), 0.06, metal)
    disc(kit, (-0.2, 0.12, 0.1), 0.1, 0.04, dark, True, ALONG_Y)
    rod(kit, (-0.25, 0, 0.4), (-0.7, 0, 1.1), 0.025, dark)
    rod(kit, (-0.7, -0.16, 1.1), (-0.7, 0.16, 1.1), 0.025, dark)


def lift_truck(kit):
    paint, dark, metal, hy = near(kit, (0.65, 0.4, 0.02), (0.55, 0.05, 0.03), (0.65, 0.2, 0.02), (0.05, 0.25, 0.12)), black(kit), iron(kit), 0.5
    mast_forks(kit, 0.85, 0.34, kit.rng.uniform(2.0, 2.8), kit.rng.uniform(0.08, 1.2), dark, metal)
    box(kit, (0, 0, 0.45), (0.85, hy, 0.22), paint)
    box(kit, (-0.75, 0, 0.7), (0.35, hy + 0.03, 0.4), paint, taper=(0.75, 0.92), shift=(0.05, 0))
    box(kit, (-0.25, 0, 0.75), (0.3, 0.36, 0.15), dark)
    box(kit, (-0.48, 0, 1.1), (0.06, 0.24, 0.25), dark)
    disc(kit, (0.5, hy - 0.02, 0.3), 0.3, 0.11, dark, True, ALONG_Y)
    disc(kit, (0.5, hy + 0.02, 0.3), 0.15, 0.1, pale(kit), True, ALONG_Y)
    disc(kit, (-0.7, hy - 0.05, 0.24), 0.24, 0.1, dark, True, ALONG_Y)
    rod(kit, (0.65, hy - 0.06, 0.6), (0.35, hy - 0.06, 2.0), 0.035, dark, True, BOX)
    rod(kit, (-0.65, hy - 0.06, 1.0), (-0.5, hy - 0.06, 2.0), 0.035, dark, True, BOX)
    box(kit, (-0.07, 0, 2.0), (0.46, hy - 0.03, 0.03), dark, cut=(BARS, 8, 0.4))
    rod(kit, (0.6, 0, 0.6), (0.3, 0, 1.05), 0.025, dark)
    disc(kit, (0.28, 0, 1.07), 0.16, 0.015, dark, rotation=turn("y", -35))


def conveyor(kit):
    frame, belt, long = near(kit, (0.1, 0.2, 0.4), (0.6, 0.4, 0.03), (0.35, 0.36, 0.36)), black(kit), kit.rng.uniform(1.2, 1.8)
    low, high = kit.rng.uniform(0.4, 0.7), kit.rng.uniform(0.7, 1.5)
    kit.between((-long, 0, low), (long, 0, high), (0.05, 0.3), BOX, material=belt)
    rod(kit, (-long, 0.33, low), (long, 0.33, high), (0.08, 0.03), frame, True, BOX)
    for x, z in ((-long, low), (long, high)):
        disc(kit, (x, 0, z), 0.1, 0.32, steel(kit), rotation=ALONG_Y)
    for share in (0.15, 0.85):
        x, z = -long + 2 * long * share, low + (high - low) * share
        rod(kit, (x, 0.33, 0), (x, 0.33, z), 0.035, frame, True, BOX)
        rod(kit, (x, -0.33, z * 0.4), (x, 0.33, z * 0.4), 0.025, frame, kind=BOX)
    slope = turn("y", -np.degrees(np.arctan2(high - low, 2 * long)))
    for share in (0.2, 0.5, 0.78):
        at = np.array([-long + 2 * long * share, 0, low + (high - low) * share])
        kit.add(BOX, at + slope @ [0, 0, 0.2], (0.18, 0.2, 0.16), rotation=slope, material=near(kit, (0.45, 0.3, 0.15)))


def robot_arm(kit):
    paint, dark = near(kit, (0.7, 0.25, 0.02), (0.7, 0.45, 0.02), (0.7, 0.7, 0.68), (0.5, 0.04, 0.03), gloss=0.3), black(kit)
    a, b = np.radians(kit.rng.uniform(60, 110)), np.radians(kit.rng.uniform(-35, 25))
    box(kit, (0, 0, 0.04), (0.4, 0.4, 0.04), iron(kit))
    kit.loft((0, 0, 0.08), [(0, 0.3), (0.15, 0.26), (0.16, 0.22), (0.35, 0.22)], paint)
    box(kit, (0.08, 0, 0.52), (0.2, 0.18, 0.16), paint)
    shoulder = np.array([0.15, 0, 0.6])
    elbow = shoulder + 0.85 * np.array([np.cos(a), 0, np.sin(a)])
    wrist = elbow + 0.85 * np.array([np.cos(b), 0, np.sin(b)])
    disc(kit, shoulder, 0.18, 0.22, dark, rotation=ALONG_Y)
    kit.between(shoulder, elbow, (0.14, 0.11), BOX, 0.8, material=paint)
    disc(kit, elbow, 0.16, 0.2, paint, rotation=ALONG_Y)
    kit.between(elbow - (wrist - elbow) * 0.25, wrist, (0.13, 0.12), BOX, 0.6, material=paint)
    disc(kit, wrist, 0.09, 0.11, dark, rotation=ALONG_Y)
    down = wrist + [0.06, 0, -0.2]
    rod(kit, wrist, down, 0.07, paint)
    box(kit, down, (0.07, 0.14, 0.03), dark)
    box(kit, down - [0, 0.1, 0.1], (0.03, 0.02, 0.1), steel(kit))
    box(kit, down + [0, 0.1, -0.1], (0.03, 0.02, 0.1), steel(kit))
    bent(kit, [shoulder + [-0.2, 0.15, -0.2], shoulder + [-0.3, 0.15, 0.3], elbow + [-0.25, 0.12, 0.1]], 0.025, dark)


def tripod(kit):
    """A camera, a telescope or a level on a tripod."""
    metal, dark, high, kind = iron(kit) if kit.chance(0.6) else timber(kit), black(kit), kit.rng.uniform(1.1, 1.4), kit.rng.integers(2)
    for x, y in around(3, 0.5, 60):
        rod(kit, (x, y, 0), (x * 0.1, y * 0.1, high), 0.025, metal)
        rod(kit, (x * 0.55, y * 0.55, high * 0.5), (0, 0, high * 0.5), 0.012, metal)
    rod(kit, (0, 0, high * 0.45), (0, 0, high + 0.1), 0.03, metal)
    disc(kit, (0, 0, high), 0.08, 0.05, dark)
    if kind:
        box(kit, (0, 0, high + 0.25), (0.18, 0.11, 0.15), dark)
        disc(kit, (0.28, 0, high + 0.25), 0.09, 0.12, dark, rotation=ALONG_X, taper=1.2)
        disc(kit, (0.4, 0, high + 0.25), 0.09, 0.01, lens(kit), rotation=ALONG_X)
        box(kit, (0, 0, high + 0.43), (0.1, 0.05, 0.04), dark)
        rod(kit, (-0.1, 0.05, high + 0.05), (-0.5, 0.1, high - 0.1), 0.014, metal)
    else:
        axis = turn("y", 90 - kit.rng.uniform(10, 50))
        tube, r = pale(kit) if kit.chance(0.5) else brass(kit), kit.rng.uniform(0.06, 0.13)
        kit.loft(np.array([0, 0, high + 0.15]) - axis @ [0, 0, 0.65], [(0, r * 0.4), (0.2, r * 0.4), (0.21, r), (1.15, r), (1.16, r * 1.2), (1.4, r * 1.2)], tube, axis=axis)
        kit.add(CYL, np.array([0, 0, high + 0.15]) + axis @ [0, 0, 0.75], (r, r, 0.01), rotation=axis, material=lens(kit))


def searchlight(kit):
    metal, lift, r = enamel(kit), turn("y", 90 - kit.rng.uniform(0, 50)), 0.4
    disc(kit, (0, 0, 0.06), 0.35, 0.06, iron(kit))
    rod(kit, (0, 0, 0), (0, 0, 0.35), 0.1, metal)
    box(kit, (0, 0, 0.37), (0.1, r + 0.1, 0.04), metal)
    box(kit, (0, r + 0.07, 0.65), (0.08, 0.03, 0.3), metal, True)
    at = np.array([0, 0, 0.88])
    rod(kit, (0, -r - 0.12, 0.88), (0, r + 0.12, 0.88), 0.05, iron(kit))
    kit.add(CYL, at, (r, r, 0.28), rotation=lift, material=metal)
    kit.add(BALL, at - lift @ [0, 0, 0.28], (r, r, 0.15), rotation=lift, material=metal)
    kit.add(CYL, at + lift @ [0, 0, 0.29], (r * 0.9, r * 0.9, 0.01), rotation=lift, material=shining(kit) if kit.chance(0.6) else glass(kit))


def server(kit):
    dark, high = black(kit), kit.rng.uniform(1.4, 2.0)
    box(kit, (0, 0, high / 2), (0.42, 0.32, high / 2), dark)
    for k, z in enumerate(np.arange(0.12, high - 0.1, 0.13)):
        box(kit, (0.42, 0, z), (0.012, 0.28, 0.055), kit.material(dark=kit.chance(0.5), pattern=kit.rng.choice([PLAIN, STRIPES, WRITING]), frequency=20))
        box(kit, (0.435, 0.2 - 0.1 * (k % 3), z), (0.005, 0.03, 0.012), kit.material(base=[0.05, 0.8, 0.3], pattern=PLAIN, gloss=-0.6))


def printer(kit):
    frame, z = iron(kit) if kit.chance(0.6) else bright(kit), kit.rng.uniform(0.15, 0.3)
    box(kit, (0, 0, 0.05), (0.28, 0.28, 0.05), frame)
    rod(kit, (0, 0.26, 0.05), (0, 0.26, 0.65), 0.025, frame, True, BOX)
    rod(kit, (0, -0.28, 0.65), (0, 0.28, 0.65), 0.025, frame, kind=BOX)
    rod(kit, (0, -0.26, z + 0.14), (0, 0.26, z + 0.14), 0.018, steel(kit))
    box(kit, (0.03, 0.05, z + 0.13), (0.05, 0.05, 0.06), black(kit))
    box(kit, (0, 0, 0.115), (0.22, 0.2, 0.015), black(kit))
    kit.loft((0.03, 0.05, 0.13), [(0, 0.1), (z * 0.5 - 0.06, 0.06), (z - 0.06, 0.09)], bright(kit))
    disc(kit, (0, 0, 0.76), 0.11, 0.03, bright(kit), rotation=ALONG_Y)
    box(kit, (0.28, 0.15, 0.06), (0.01, 0.08, 0.035), lens(kit))


def mixer(kit):
    paint, dark, tip = near(kit, (0.65, 0.25, 0.02), (0.65, 0.42, 0.02), (0.05, 0.15, 0.4)), black(kit), turn("y", kit.rng.uniform(20, 60))
    at = np.array([0.05, 0, 0.95])
    kit.loft(at - tip @ [0, 0, 0.4], [(0, 0.25), (0.15, 0.4), (0.45, 0.4), (0.85, 0.22), (0.9, 0.22)], paint, axis=tip)
    kit.add(CYL, at + tip @ [0, 0, 0.5], (0.19, 0.19, 0.008), rotation=tip, material=dark)
    for x in (-0.5, 0.45):
        rod(kit, (x, 0.48, 0.05), (0.05, 0.48, 0.95), 0.03, paint, True, BOX)
        rod(kit, (x, -0.48, 0.05), (x, 0.48, 0.05), 0.03, paint, kind=BOX)
    rod(kit, (0.05, -0.5, 0.95), (0.05, 0.5, 0.95), 0.035, dark)
    disc(kit, (-0.5, 0.52, 0.2), 0.2, 0.05, dark, True, ALONG_Y)
    box(kit, (-0.2, -0.55, 0.7), (0.17, 0.1, 0.2), paint)
    disc(kit, (0.05, 0.53, 0.95), 0.25, 0.02, dark, rotation=ALONG_Y, cut=(SPOKES, 5, 0.3))


def anvil(kit):
    metal = iron(kit)
    disc(kit, (0, 0, 0.3), 0.3, 0.3, timber(kit), taper=0.92)
    box(kit, (0, 0, 0.64), (0.25, 0.17, 0.05), metal, taper=(0.75, 0.75))
    box(kit, (0, 0, 0.74), (0.14, 0.09, 0.07), metal)
    box(kit, (-0.05, 0, 0.87), (0.28, 0.11, 0.08), metal)
    disc(kit, (0.41, 0, 0.88), 0.08, 0.19, metal, rotation=ALONG_X, taper=0.15)
    rod(kit, (-0.2, -0.2, 0.97), (-0.1, 0.22, 0.97), 0.016, timber(kit))
    box(kit, (-0.1, 0.22, 0.98), (0.1, 0.035, 0.035), steel(kit))


def jaw(kit, x, y, z, size, paint):
    """A vice on the surface at the height `z`."""
    metal, at = steel(kit), np.array([x, y, z])
    disc(kit, at + [0, 0, 0.04 * size], 0.16 * size, 0.04 * size, paint)
    box(kit, at + [-0.05 * size, 0, 0.2 * size], (0.12 * size, 0.09 * size, 0.13 * size), paint)
    box(kit, at + [0.2 * size, 0, 0.22 * size], (0.06 * size, 0.09 * size, 0.12 * size), paint)
    rod(kit, at + [0, 0, 0.18 * size], at + [0.42 * size, 0, 0.18 * size], 0.03 * size, metal)
    rod(kit, at + [0.4 * size, -0.16 * size, 0.18 * size], at + [0.4 * size, 0.16 * size, 0.18 * size], 0.016 * size, metal)
    box(kit, at + [0.05 * size, 0, 0.31 * size], (0.025 * size, 0.11 * size, 0.04 * size), metal)
    box(kit, at + [0.15 * size, 0, 0.31 * size], (0.025 * size, 0.11 * size, 0.04 * size), metal)


def vice(kit):
    jaw(kit, 0, 0, 0, 1, near(kit, (0.05, 0.15, 0.4), (0.4, 0.05, 0.03), (0.1, 0.11, 0.11)))


def workbench(kit):
    wood, hy = planks(kit), kit.rng.uniform(0.7, 1.0)
    posts(kit, 0.28, hy - 0.08, 0, 0.82, 0.05, wood if kit.chance(0.6) else iron(kit), kind=BOX)
    box(kit, (0, 0, 0.85), (0.36, hy, 0.045), wood)
    box(kit, (0, 0, 0.22), (0.28, hy - 0.08, 0.02), wood)
    jaw(kit, 0.2, hy - 0.25, 0.89, 0.8, iron(kit))
    for y in (-0.5, 0.0, 0.4):
        box(kit, (-0.02, y * hy, 0.36), (0.2, 0.17, 0.12), enamel(kit))
    if kit.chance(0.7):
        box(kit, (-0.36, 0, 1.25), (0.015, hy, 0.42), timber(kit))
        for k, y in enumerate(np.linspace(-0.8, 0.6, 6) * hy):
            rod(kit, (-0.33, y, 1.05), (-0.33, y, 1.4), 0.018, timber(kit) if k % 2 else bright(kit))
            box(kit, (-0.33, y, 1.43), (0.02, 0.07 if k % 2 else 0.025, 0.04), steel(kit))
    box(kit, (0, -hy * 0.5, 0.98), (0.13, 0.24, 0.09), bright(kit))
    rod(kit, (0, -hy * 0.5 - 0.12, 1.1), (0, -hy * 0.5 + 0.12, 1.1), 0.016, black(kit))


def cable_drum(kit):
    wood, r, half = planks(kit), kit.rng.uniform(0.5, 0.8), kit.rng.uniform(0.25, 0.45)
    disc(kit, (0, half, r), r, 0.04, wood, True, ALONG_Y)
    disc(kit, (0, 0, r), r * kit.rng.uniform(0.5, 0.85), half, (black(kit) if kit.chance(0.6) else bright(kit))._replace(pattern=BANDS, frequency=22.0), rotation=ALONG_Y)
    disc(kit, (0, half + 0.03, r), r * 0.15, 0.02, iron(kit), True, ALONG_Y)
    for x, z in around(6, r * 0.55):
        disc(kit, (x, half + 0.04, r + z), 0.03, 0.012, iron(kit), True, ALONG_Y)


def bottles(kit):
    cage_, n = iron(kit) if kit.chance(0.5) else bright(kit), int(kit.rng.integers(2, 5))
    half = 0.17 * n
    box(kit, (0, 0, 0.04), (0.2, half, 0.04), cage_)
    paint, neck = bright(kit), brass(kit)
    for k in range(n):
        y = (2 * k - n + 1) * 0.16
        kit.loft((0, y, 0.07), [(0, 0.13), (1.0, 0.13), (1.1, 0.1), (1.16, 0.045), (1.22, 0.04)], paint if kit.chance(0.6) else bright(kit))
        disc(kit, (0, y, 1.33), 0.03, 0.05, neck)
    posts(kit, 0.18, half - 0.02, 0, 1.3, 0.02, cage_, kind=BOX)
    for z in (0.5, 1.0):
        rod(kit, (0.18, -half, z), (0.18, half, z), 0.016, cage_, kind=BOX)
        rod(kit, (-0.18, -half, z), (-0.18, half, z), 0.016, cage_, kind=BOX)
        rod(kit, (-0.18, half - 0.02, z), (0.18, half - 0.02, z), 0.016, cage_, True, BOX)


def valve(kit):
    paint, wheel_ = near(kit, (0.05, 0.15, 0.4), (0.1, 0.25, 0.12), (0.3, 0.3, 0.3)), near(kit, (0.5, 0.03, 0.02), (0.6, 0.4, 0.02))
    rod(kit, (0, -0.7, 0.5), (0, 0.7, 0.5), 0.15, paint)
    for y in (0.28, 0.34, 0.7):
        disc(kit, (0, y, 0.5), 0.24, 0.025, paint, True, ALONG_Y)
    kit.add(BALL, (0, 0, 0.5), (0.23, 0.27, 0.23), material=paint)
    kit.loft((0, 0, 0.65), [(0, 0.15), (0.15, 0.12), (0.16, 0.2), (0.21, 0.2), (0.22, 0.08), (0.4, 0.05)], paint)
    rod(kit, (0, 0, 1.0), (0, 0, 1.25), 0.025, steel(kit))
    bent(kit, [np.array([0.25 * np.cos(a), 0.25 * np.sin(a), 1.18]) for a in np.linspace(0, 2 * np.pi, 13)], 0.025, wheel_)
    for x, y in around(2, 0.25):
        rod(kit, (x, y, 1.18), (-x, -y, 1.18), 0.018, wheel_)
        rod(kit, (y, x, 1.18), (-y, -x, 1.18), 0.018, wheel_)
    box(kit, (0, 0.5, 0.2), (0.08, 0.06, 0.2), iron(kit), True)


def fan(kit):
    metal, r, z = steel(kit) if kit.chance(0.5) else enamel(kit), kit.rng.uniform(0.22, 0.4), kit.rng.choice([0.5, 1.2])
    disc(kit, (0, 0, 0.02), 0.25, 0.02, metal, taper=0.9)
    rod(kit, (0, 0, 0), (0, 0, z), 0.025, metal)
    disc(kit, (-0.08, 0, z), 0.09, 0.12, metal, rotation=ALONG_X)
    blades = enamel(kit)
    for k, (y, up) in enumerate(around(4, r * 0.45, 20)):
        kit.add(BOX, (0.08, y, z + up), (0.012, r * 0.42, r * 0.22), rotation=turn("x", 20 + 90 * k) @ turn("y", 20), material=blades)
    disc(kit, (0.1, 0, z), 0.06, 0.06, metal, rotation=ALONG_X)
    for x in (0.0, 0.16):
        bent(kit, [np.array([x, r * np.cos(a), z + r * np.sin(a)]) for a in np.linspace(0, 2 * np.pi, 15)], 0.012, metal)
        kit.add(CYL, (x, 0, z), (r, r, 0.006), rotation=ALONG_X, material=metal, cut=(SPOKES, 24, 0.16))


def satellite(kit):
    gold, cells = brass(kit), near(kit, (0.02, 0.05, 0.2), (0.03, 0.04, 0.08), pattern=CHECKER, frequency=14, gloss=0.4)
    n, z = int(kit.rng.integers(1, 4)), 0.6
    shape, sides = (BOX, 1) if kit.chance(0.6) else (PRISM, 8)
    kit.add(shape, (0, 0, z), (0.35, 0.35, 0.5), (1, sides), material=gold)
    rod(kit, (0, -0.5 - n * 0.75, z), (0, 0.5 + n * 0.75, z), 0.03, steel(kit))
    for k in range(n):
        box(kit, (0, 0.85 + 0.75 * k, z), (0.02, 0.35, 0.42), cells, True)
    kit.loft((0.35, 0, z), [(0, 0.06), (0.1, 0.08), (0.18, 0.28), (0.25, 0.38)], pale(kit), axis=ALONG_X)
    rod(kit, (0.5, 0, z), (0.85, 0, z), 0.02, steel(kit))
    rod(kit, (0, 0.15, z + 0.5), (0.1, 0.2, z + 0.9), 0.012, steel(kit))
    disc(kit, (0, 0, 0.06), 0.18, 0.06, iron(kit), taper=1.3)


def cannon(kit):
    metal, wood, r, axis = brass(kit) if kit.chance(0.4) else iron(kit), timber(kit), kit.rng.uniform(0.4, 0.6), turn("y", 90 - kit.rng.uniform(0, 14))
    at = np.array([0, 0, r + 0.12])
    kit.loft(at - axis @ [0, 0, 0.5], [(-0.12, 0.04), (-0.05, 0.07), (0, 0.16), (0.06, 0.17), (0.6, 0.14), (0.63, 0.16), (0.68, 0.13), (1.4, 0.095), (1.5, 0.13), (1.55, 0.12)], metal, axis=axis)
    kit.add(CYL, at + axis @ [0, 0, 1.055], (0.065, 0.065, 0.01), rotation=axis, material=black(kit))
    box(kit, (0, 0.19, r), (0.35, 0.05, 0.16), wood, True)
    rod(kit, (-0.1, 0.14, r), (-1.3, 0.08, 0.08), (0.08, 0.06), wood, True, BOX)
    rod(kit, (0, -0.55, r), (0, 0.55, r), 0.05, wood)
    kit.add(TUBE, (0, 0.48, r), (r, r, 0.05), rotation=ALONG_Y, material=iron(kit), mirror=True)
    kit.add(CYL, (0, 0.48, r), (r * 0.98, r * 0.98, 0.045), rotation=ALONG_Y, material=wood, mirror=True, cut=(SPOKES, 12, 0.17))
    disc(kit, (0, 0.48, r), 0.1, 0.09, wood, True, ALONG_Y)


def catapult(kit):
    wood, dark = planks(kit), iron(kit)
    rod(kit, (-1.0, 0.4, 0.3), (1.0, 0.4, 0.3), 0.08, wood, True, BOX)
    for x in (-0.8, 0.8):
        rod(kit, (x, -0.45, 0.3), (x, 0.45, 0.3), 0.07, wood, kind=BOX)
        disc(kit, (x, 0.53, 0.25), 0.25, 0.05, wood, True, ALONG_Y)
    rod(kit, (0.2, 0.4, 0.3), (0.2, 0.4, 1.3), 0.07, wood, True, BOX)
    rod(kit, (-0.5, 0.4, 0.3), (0.2, 0.4, 1.1), 0.05, wood, True, BOX)
    rod(kit, (0.2, -0.45, 1.3), (0.2, 0.45, 1.3), 0.08, wood, kind=BOX)
    rod(kit, (0, -0.4, 0.4), (0, 0.4, 0.4), 0.11, pale(kit))
    a = np.radians(kit.rng.uniform(100, 165))
    end = np.array([1.3 * np.cos(a), 0, 0.4 + 1.3 * np.sin(a)])
    rod(kit, (0, 0, 0.4), end, 0.055, wood, kind=BOX)
    kit.add(CYL, end, (0.17, 0.17, 0.06), (1.3, 1), rotation=turn("y", 90 - np.degrees(a)), material=dark)
    kit.add(BALL, end + [0.03, 0, 0.1], (0.13,) * 3, material=stone(kit))


def water_wheel(kit):
    wood, r, half = planks(kit), kit.rng.uniform(0.8, 1.1), 0.25
    z = r + 0.1
    for side in (-half, half):
        kit.add(TUBE, (0, side, z), (r, r, 0.03), rotation=ALONG_Y, material=wood)
        kit.add(CYL, (0, side, z), (r * 0.98, r * 0.98, 0.03), rotation=ALONG_Y, material=wood, cut=(SPOKES, 8, 0.14))
    for k, (x, up) in enumerate(around(14, r * 0.95)):
        kit.add(BOX, (x, 0, z + up), (r * 0.13, half, 0.015), rotation=turn("y", -360 / 14 * k), material=wood)
    rod(kit, (0, -half - 0.4, z), (0, half + 0.4, z), 0.08, timber(kit))
    for x in (-0.45, 0.45):
        rod(kit, (x, half + 0.25, 0), (0, half + 0.25, z), 0.06, wood, True, BOX)
    box(kit, (0, half + 0.25, 0.04), (0.6, 0.08, 0.04), stone(kit), True)
    rod(kit, (-0.6, half + 0.25, 0.04), (-0.6, -half - 0.25, 0.04), 0.05, wood, kind=BOX)
