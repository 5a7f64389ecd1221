"""Makers of what lives and is no quadruped, bird or person: fish, insects, crabs, reptiles; palms, cacti, flowers, mushrooms."""

import numpy as np

from .kit import turn
from .layout import BALL, BOX, CYL
from .materials import CLOUDY, PLAIN, SPECKLES, STRIPES, paint


def skin(kit):
    rng = kit.rng
    base = paint(rng.random(), rng.uniform(0.1, 0.9), rng.uniform(0.05, 0.7))
    return kit.material(base=base, pattern=rng.choice([PLAIN, CLOUDY, SPECKLES, STRIPES]), frequency=rng.uniform(4, 16), gloss=rng.uniform(0, 0.5))


def crawler(kit):
    """Fish and whales, beetles and spiders, crabs, lizards and crocodiles, turtles, snakes in curves."""
    rng = kit.rng
    coat, second, dark = skin(kit), skin(kit), kit.material(dark=True, gloss=0.5)
    kind = rng.choice(["fish", "insect", "crab", "reptile", "turtle", "snake"])
    if kind == "fish":
        long, high, wide = rng.uniform(1.0, 2.2), rng.uniform(0.25, 0.6), rng.uniform(0.12, 0.4)
        lift = high * rng.uniform(1.0, 1.4)
        kit.add(BALL, (0, 0, lift), (long * 0.62, wide, high), material=coat)
        kit.add(BALL, (long * 0.3, 0, lift), (long * 0.4, wide * 0.9, high * 0.8), material=coat)
        kit.add(CYL, (-long * 0.62, 0, lift), (high * 0.55, wide * 0.5, long * 0.35), (0.25, 1), rotation=turn("y", -90), material=coat)
        flat = kit.chance(0.3)
        tail = np.array([-long * 0.95, 0, lift])
        for way in (-1, 1):
            out = np.array([-0.5, way * 0.8, 0]) if flat else np.array([-0.5, 0, way * 0.8])
            kit.between(tail, tail + out * high * rng.uniform(0.9, 1.3), (0.02, 0.16) if not flat else (0.16, 0.02), BOX, 0.5, material=second)
        kit.add(BOX, (-long * rng.uniform(-0.1, 0.15), 0, lift + high * 1.05), (long * rng.uniform(0.1, 0.3), 0.02, high * 0.35), (0.4, 1), (-0.2, 0), material=second)
        kit.between((long * 0.2, wide * 0.8, lift - high * 0.3), (0, wide * 1.7, lift - high * 0.7), (0.02, 0.12), BOX, 0.6, material=second, mirror=True)
        kit.add(BALL, (long * 0.48, wide * 0.62, lift + high * 0.2), (0.05, 0.04, 0.05), material=dark, mirror=True)
    elif kind in ("insect", "crab"):
        crab = kind == "crab"
        wide, z = rng.uniform(0.3, 0.6) * (1.4 if crab else 1), rng.uniform(0.25, 0.5)
        kit.add(BALL, (-0.1, 0, z), (rng.uniform(0.4, 0.8), wide, rng.uniform(0.18, 0.35)), material=coat)
        if not crab:
            kit.add(BALL, (0.55, 0, z), (0.3, wide * 0.7, 0.2), material=second)
            kit.add(BALL, (0.9, 0, z), (0.2, wide * 0.5, 0.16), material=dark if kit.chance(0.5) else coat)
            if kit.chance(0.4):
                kit.add(BOX, (-0.3, wide * 0.5, z + 0.25), (0.7, wide * 0.6, 0.012), rotation=turn("x", 12), material=second, mirror=True)
            kit.between((1.0, 0.08, z + 0.1), (1.5, 0.35, z + rng.uniform(0.1, 0.6)), 0.015, material=dark, mirror=True)
        legs = 4 if crab or kit.chance(0.3) else 3
        for k in range(legs):
            x = 0.45 - 0.9 * k / (legs - 1)
            knee = np.array([x * 1.5, wide + 0.35, z + rng.uniform(0.1, 0.5)])
            kit.chain([(x, wide * 0.7, z), knee, (x * 2.0, wide + rng.uniform(0.5, 0.8), 0.02)], [0.06, 0.045, 0.02], second, mirror=True, joints=False)
        if crab:
            kit.chain([(0.4, wide * 0.8, z), (0.8, wide + 0.3, z), (1.15, wide * 0.8, z + 0.05)], [0.09, 0.1, 0.1], coat, mirror=True)
            kit.add(BALL, (1.25, wide * 0.7, z + 0.05), (0.3, 0.14, 0.12), rotation=turn("z", -25), material=coat, mirror=True)
        kit.add(BALL, (0.5 if crab else 1.02, 0.16, z + 0.2), (0.06, 0.06, 0.07), material=dark, mirror=True)
    elif kind == "snake":
        turns, thick = rng.uniform(1, 3), rng.uniform(0.08, 0.16)
        t = np.linspace(0, 1, 14)
        path = np.stack([2.4 * t - 1.2, rng.uniform(0.2, 0.5) * np.sin(2 * np.pi * turns * t), np.full(14, thick)], 1)
        path[-2:, 2] += rng.uniform(0, 0.5)
        kit.chain(list(path), list(thick * np.clip(0.3 + 4 * t, 0, 1)), coat)
        kit.add(BALL, path[-1] + [0.12, 0, 0.02], (0.2, thick * 1.2, thick * 0.9), material=coat)
    else:
        long, high, wide = rng.uniform(0.7, 1.3), rng.uniform(0.14, 0.3), rng.uniform(0.2, 0.4)
        z = high + rng.uniform(0.08, 0.35)
        shell = kind == "turtle"
        kit.add(BALL, (0, 0, z), (long * (0.7 if shell else 1), wide * (1.9 if shell else 1), high * (1.7 if shell else 1)), material=coat)
        neck = np.array([long * (0.65 if shell else 0.9), 0, z])
        head = neck + [0.4, 0, rng.uniform(-0.05, 0.25)]
        kit.chain([neck, head], [high * 0.7, high * 0.55], second if shell else coat)
        kit.add(BALL, head + [0.15, 0, 0], (rng.uniform(0.2, 0.5), high * 0.6, high * 0.45), material=second if shell else coat)
        kit.add(BALL, head + [0.12, high * 0.4, high * 0.35], (0.04, 0.04, 0.04), material=dark, mirror=True)
        for x in (0.6, -0.6):
            out = wide * (1.9 if shell else 1)
            kit.chain([(x * long * 0.8, out * 0.7, z), (x * long * 0.9, out + 0.2, z * 0.8), (x * long * 0.9 + 0.12, out + 0.25, 0.03)], [high * 0.4, high * 0.3, high * 0.25], second if shell else coat, mirror=True)
        if not shell:
            bend = rng.uniform(-0.4, 0.4)
            kit.chain([(-long * 0.85, 0, z), (-long * 1.5, bend, z * 0.7), (-long * 2.2, bend * 0.2, 0.05)], [high * 0.7, high * 0.4, 0.02], coat)
            if kit.chance(0.4):
                for x in np.linspace(-0.8, 0.7, 6):
                    kit.add(BOX, (x * long, 0, z + high), (0.1, 0.015, 0.1), (0.1, 1), material=second)


def sprout(kit):
    """Palms, cacti, flowers, mushrooms, agaves: what grows and has no crown of leaves."""
    rng = kit.rng
    green = paint(rng.uniform(0.2, 0.38), rng.uniform(0.3, 0.9), rng.uniform(0.08, 0.5))
    leaf = kit.material(base=green, pattern=rng.choice([PLAIN, CLOUDY, STRIPES]), second=green * rng.uniform(0.4, 1.5))
    bark = kit.material(base=np.array([0.3, 0.22, 0.14]) * rng.uniform(0.4, 1.6), pattern=STRIPES, frequency=rng.uniform(10, 30))
    kind = rng.choice(["palm", "cactus", "flower", "mushroom", "agave"])
    if kind == "palm":
        tall, lean = rng.uniform(1.5, 3.2), rng.normal(0, 0.25, 2)
        top = np.array([*lean, tall])
        kit.chain([(0, 0, 0), (lean[0] * 0.3, lean[1] * 0.3, tall * 0.5), top], [0.14, 0.1, 0.08], bark)
        for _ in range(int(rng.integers(7, 15))):
            angle, rise, reach = rng.uniform(0, 2 * np.pi), rng.uniform(-0.3, 0.6), rng.uniform(0.7, 1.2)
            out = np.array([np.cos(angle), np.sin(angle), 0])
            bend = top + out * reach * 0.5 + [0, 0, rise * 0.6]
            tip = top + out * reach + [0, 0, rise * 0.6 - rng.uniform(0.2, 0.6)]
            kit.between(top, bend, (0.015, 0.12), BOX, 1.2, material=leaf)
            kit.between(bend, tip, (0.015, 0.14), BOX, 0.3, material=leaf)
    elif kind == "cactus":
        ribs = kit.material(base=green * 0.8, pattern=STRIPES, frequency=rng.uniform(12, 30), second=green * 0.4)
        tall, thick = rng.uniform(0.8, 2.2), rng.uniform(0.15, 0.4)
        kit.add(CYL, (0, 0, tall / 2), (thick, thick, tall / 2), material=ribs)
        kit.add(BALL, (0, 0, tall), (thick, thick, thick), material=ribs)
        for _ in range(int(rng.integers(0, 5))):
            angle, base = rng.uniform(0, 2 * np.pi), tall * rng.uniform(0.3, 0.7)
            out = np.array([np.cos(angle), np.sin(angle), 0])
            elbow = out * thick * 2.2 + [0, 0, base]
            kit.chain([[0, 0, base], elbow, elbow + [0, 0, rng.uniform(0.3, 0.8)]], [thick * 0.55, thick * 0.55, thick * 0.5], ribs)
        if kit.chance(0.4):
            kit.add(CYL, (0, 0, 0.05), (thick * 1.5, thick * 1.5, 0.25), (1.2, 1), material=kit.material())
    elif kind == "flower":
        tall, petals = rng.uniform(0.6, 1.6), int(rng.integers(5, 13))
        kit.chain([(0, 0, 0), (rng.normal(0, 0.06), rng.normal(0, 0.06), tall * 0.6), (0, 0, tall)], [0.03, 0.025, 0.025], leaf)
        tilt = turn("y", rng.uniform(-10, 80))
        bloom = kit.material(base=paint(rng.random(), rng.uniform(0.3, 1), rng.uniform(0.4, 0.95)), pattern=rng.choice([PLAIN, STRIPES]))
        cup = rng.uniform(-0.1, 0.5)
        for k in range(petals):
            angle = 2 * np.pi * k / petals
            way = tilt @ np.array([np.cos(angle), np.sin(angle), cup])
            kit.add(BALL, np.array([0, 0, tall]) + way * 0.24, (0.22, 0.1, 0.025), rotation=tilt @ turn("z", np.degrees(angle)) @ turn("y", -np.degrees(np.arctan(cup))), material=bloom)
        kit.add(BALL, (0, 0, tall), (0.1, 0.1, 0.07), rotation=tilt, material=kit.material())
        for k in range(int(rng.integers(1, 5))):
            angle = rng.uniform(0, 2 * np.pi)
            kit.between((0, 0, tall * 0.15 * k), (0.4 * np.cos(angle), 0.4 * np.sin(angle), tall * (0.15 * k + 0.25)), (0.012, 0.08), BOX, 0.2, material=leaf)
    elif kind == "mushroom":
        stem, cap = kit.material(base=rng.uniform(0.5, 0.9) * np.array([1, 0.95, 0.85])), skin(kit)
        for _ in range(int(rng.integers(1, 4))):
            at, tall, wide = np.array([*rng.normal(0, 0.4, 2), 0]), rng.uniform(0.4, 1.0), rng.uniform(0.25, 0.6)
            kit.add(CYL, at + [0, 0, tall / 2], (wide * 0.3, wide * 0.3, tall / 2), (rng.uniform(0.6, 1), 1), material=stem)
            rise = rng.uniform(0.15, 0.5)
            kit.loft(at + [0, 0, tall * 0.95], [(0, wide), (rise * 0.5, wide * 0.9), (rise * 0.85, wide * 0.55), (rise, wide * 0.1)], cap)
    else:
        for k in range(int(rng.integers(9, 24))):
            angle, lift, reach = 2.4 * k, np.radians(rng.uniform(15, 80)), rng.uniform(0.5, 1.0)
            tip = reach * np.array([np.cos(angle) * np.cos(lift), np.sin(angle) * np.cos(lift), np.sin(lift)])
            kit.between((0, 0, 0.05), tip + [0, 0, 0.05], (0.02, 0.09), BOX, 0.05, material=leaf)
        if kit.chance(0.6):
            kit.add(CYL, (0, 0, -0.15), (0.25, 0.25, 0.2), (1.25, 1), material=kit.material())
