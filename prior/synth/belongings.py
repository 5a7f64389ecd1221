"""What the makers of everyday things share: enamel, leather, cloth, metals; arcs, funnels, handles, cases, bowls."""

import numpy as np

from .kit import ALONG_X, mirrored, turn
from .layout import BARS, BOX, CYL, RUNGS, TUBE
from .materials import CAMOUFLAGE, CHECKER, CLOUDY, PLAIN, PLANKS, RIBS, SEAMS, STREAKS, STRIPES, WAVES, WRITING, paint


def enamel(kit, hue=None):
    """Glossy paint or plastic: of any hue, or black, white, grey."""
    rng = kit.rng
    hue = rng.random() if hue is None else hue
    base = paint(hue, rng.uniform(0.6, 1), rng.uniform(0.1, 0.8)) if kit.chance(0.65) else np.ones(3) * rng.choice([0.03, 0.3, 0.75]) * rng.uniform(0.6, 1.2)
    return kit.material(base=base, pattern=PLAIN, gloss=rng.uniform(0.1, 0.6))


def leather(kit):
    rng = kit.rng
    base = (
        paint(rng.choice([0.03, 0.06, 0.08]), rng.uniform(0.4, 0.9), rng.uniform(0.03, 0.4))
        if kit.chance(0.7)
        else paint(rng.random(), rng.uniform(0, 0.9), rng.uniform(0.03, 0.6))
    )
    return kit.material(base=base, pattern=rng.choice([PLAIN, PLAIN, CLOUDY, STREAKS]), gloss=rng.uniform(0.02, 0.4))


def cloth(kit):
    pattern = kit.rng.choice([PLAIN, PLAIN, CLOUDY, CAMOUFLAGE, STRIPES, CHECKER, SEAMS], p=[0.3, 0.2, 0.16, 0.12, 0.08, 0.06, 0.08])
    return kit.material(pattern=pattern, gloss=kit.rng.uniform(0, 0.06))


def timber(kit):
    rng = kit.rng
    base = paint(rng.uniform(0.04, 0.1), rng.uniform(0.4, 0.9), rng.uniform(0.06, 0.6))
    return kit.material(base=base, pattern=rng.choice([PLAIN, STREAKS, WAVES, CLOUDY]), second=base * rng.uniform(0.5, 0.9), gloss=rng.uniform(0, 0.5))


def steel(kit):
    return kit.material(base=kit.rng.uniform(0.25, 0.75) * np.ones(3), pattern=PLAIN, gloss=kit.rng.uniform(0.3, 0.64))


def brass(kit):
    return kit.material(base=np.array([0.62, 0.4, 0.1]) * kit.rng.uniform(0.5, 1.2), pattern=PLAIN, gloss=kit.rng.uniform(0.4, 0.64))


def black(kit):
    return kit.material(dark=True, pattern=PLAIN, gloss=kit.rng.uniform(0, 0.4))


def pale(kit):
    return kit.material(base=np.array([0.9, 0.87, 0.8]) * kit.rng.uniform(0.7, 1), pattern=PLAIN)


def lens(kit):
    return kit.material(base=[0.04, 0.05, 0.09], pattern=PLAIN, gloss=0.64)


def arc(centre, radius, first, last, count, plane="xz"):
    """`count` points on part of an ellipse, from the angle `first` to `last` in degrees; `radius`: one or two."""
    i, j = ("xyz".index(axis) for axis in plane)
    angles = np.radians(np.linspace(first, last, count))
    points = np.tile(np.array(centre, float), (count, 1))
    across, along = np.broadcast_to(np.array(radius, float), 2)
    points[:, i] += across * np.cos(angles)
    points[:, j] += along * np.sin(angles)
    return list(points)


def ribbon(kit, points, half, material, mirror=False):
    """Flat strips through the points; `half`: thickness and width."""
    for start, end in zip(points[:-1], points[1:], strict=True):
        kit.between(start, end + (end - start) * 0.03, half, BOX, material=material, mirror=mirror)


def twin(kit, first):
    """Mirror all primitives from the index `first` on."""
    kit.primitives += [mirrored(p) for p in kit.primitives[first:]]


def tipped(kit, rotation):
    """Turn the whole object, so far, about its origin."""
    kit.primitives = [p._replace(centre=rotation @ p.centre, rotation=rotation @ p.rotation) for p in kit.primitives]


def funnel(kit, base, profile, material, axis=None):
    """A hollow loft; its frusta overlap a little, so that no gap opens between them."""
    points = np.array(profile, float)
    for low, high in zip(points[:-1], points[1:], strict=True):
        kit.loft(base, [low - 0.07 * (high - low), high + 0.07 * (high - low)], material, TUBE, axis)


def handle(kit, at, half, high, thick, material, axis="y"):
    """A bow that stands on `at`, its feet `half` to either side."""
    kit.chain(arc(at, (half, high), 0, 180, 7, axis + "z"), thick, material, joints=False)


def case(kit):
    """Toolboxes, ammunition boxes and pouches, hand-held radios, first-aid kits."""
    rng = kit.rng
    coat, metal, dark = enamel(kit), steel(kit), black(kit)
    kind = rng.choice(["toolbox", "ammunition", "pouch", "radio", "aid"])
    if kind == "toolbox":
        x, y, z = rng.uniform(0.22, 0.32), rng.uniform(0.55, 0.75), rng.uniform(0.15, 0.25)
        lid = coat if kit.chance(0.5) else enamel(kit)
        kit.add(BOX, (0, 0, z), (x, y, z), material=coat)
        kit.add(BOX, (0, 0, 2 * z + 0.12), (x * 1.04, y * 1.02, 0.12), (rng.uniform(0.35, 0.95), 0.98), material=lid)
        kit.add(BOX, (0, 0, 2 * z), (x * 1.05, y * 1.03, 0.02), material=lid)
        kit.add(BOX, (x * 1.03, y * 0.6, 2 * z), (0.03, 0.06, 0.09), material=metal, mirror=True)
        kit.between((0, y * 0.4, 2 * z + 0.22), (0, y * 0.4, 2 * z + 0.38), 0.03, BOX, material=metal, mirror=True)
        kit.between((0, -y * 0.43, 2 * z + 0.39), (0, y * 0.43, 2 * z + 0.39), 0.04, material=dark)
        kit.add(BOX, (x, 0, z), (0.01, y * 0.35, z * 0.4), material=lid._replace(pattern=WRITING, frequency=8.0))
    elif kind == "ammunition":
        green = kit.material(base=paint(rng.uniform(0.12, 0.28), rng.uniform(0.3, 0.8), rng.uniform(0.05, 0.3)), pattern=rng.choice([PLAIN, STREAKS, CLOUDY]))
        x, y, z = rng.uniform(0.5, 0.6), rng.uniform(0.24, 0.34), rng.uniform(0.3, 0.38)
        kit.add(BOX, (0, 0, z), (x, y, z), material=green)
        kit.add(BOX, (0, y, z), (x * 0.8, 0.01, z * 0.6), material=green._replace(pattern=WRITING, frequency=9.0, second=np.array([0.7, 0.6, 0.1])), mirror=True)
        kit.add(BOX, (0, 0, 2 * z - 0.03), (x * 1.04, y * 1.07, 0.08), material=green)
        handle(kit, (0, 0, 2 * z + 0.03), x * 0.45, 0.17, 0.03, dark, "x")
        kit.add(BOX, (x * 1.04, 0, 1.7 * z), (0.035, y * 0.35, z * 0.28), material=green)
        kit.between((x * 1.08, -y * 0.4, 1.45 * z), (x * 1.08, y * 0.4, 1.45 * z), 0.02, material=metal)
        kit.add(BOX, (-x * 1.02, 0, 1.85 * z), (0.03, y * 0.6, 0.05), material=green)
    elif kind == "pouch":
        bag, strap, z = cloth(kit) if kit.chance(0.6) else leather(kit), leather(kit), rng.uniform(0.28, 0.42)
        count, wide = int(rng.integers(1, 5)), rng.uniform(0.15, 0.22)
        for k in range(count):
            y = (2 * k - count + 1) * wide * 1.15
            kit.add(BOX, (0, y, z), (0.13, wide, z), (0.85, 0.95), material=bag)
            kit.add(BOX, (0.02, y, 2 * z), (0.15, wide * 1.03, 0.04), (0.8, 0.95), material=bag)
            kit.add(BOX, (0.15, y, 1.65 * z), (0.02, wide * 1.02, z * 0.38), (1, 1.1), rotation=turn("y", -4), material=bag)
            kit.add(BOX, (0.165, y, 1.2 * z), (0.012, wide * 0.2, z * 0.35), material=strap)
            kit.add(CYL, (0.175, y, 1.25 * z), (0.035, 0.035, 0.012), rotation=ALONG_X, material=metal)
        kit.add(BOX, (-0.15, 0, z * 1.4), (0.025, count * wide * 1.15 + 0.25, 0.09), material=strap)
        kit.add(BOX, (-0.12, count * wide * 1.15 + 0.22, z * 1.4), (0.035, 0.06, 0.11), material=metal)
    elif kind == "radio":
        x, y, z = rng.uniform(0.1, 0.16), rng.uniform(0.19, 0.27), rng.uniform(0.4, 0.6)
        body = dark if kit.chance(0.6) else coat
        kit.add(BOX, (0, 0, z), (x, y, z), (0.9, 0.95), material=body)
        kit.add(BOX, (-x, 0, z * 0.75), (0.05, y * 0.9, z * 0.7), material=dark)
        long = rng.choice([rng.uniform(0.3, 0.5), rng.uniform(0.8, 1.5)])
        kit.between((0, y * 0.6, 2 * z - 0.02), (0, y * 0.6, 2 * z + 0.12), 0.06, material=dark)
        kit.between((0, y * 0.6, 2 * z + 0.1), (0, y * 0.6, 2 * z + long), 0.045 if long < 0.6 else 0.022, taper=0.6, material=dark if long < 0.6 else metal)
        for side in (-0.1, -0.65):
            kit.add(CYL, (0, side * y, 2 * z + 0.05), (0.05, 0.05, 0.06), material=dark)
        kit.add(
            BOX,
            (x * 0.95, 0, z * 1.55),
            (0.012, y * 0.75, z * 0.2),
            rotation=turn("y", -2),
            material=kit.material(base=[0.3, 0.45, 0.3], pattern=WRITING, frequency=14, gloss=0.4),
        )
        kit.add(BOX, (x, 0, z * 1.05), (0.015, y * 0.75, z * 0.22), rotation=turn("y", -2), material=metal, cut=(RUNGS, 14, 0.6))
        for row in range(3):
            kit.add(BOX, (x * 1.0, 0, z * (0.3 + 0.2 * row)), (y * 0.7, 0.025, z * 0.065), rotation=turn("z", 90), material=pale(kit), cut=(BARS, 2 / y, 0.7))
        kit.add(BOX, (0, y, z * 1.4), (x * 0.5, 0.03, z * 0.22), material=enamel(kit))
        if kit.chance(0.4):
            kit.chain([(0, -y, z * 1.8), (0, -y - 0.12, z * 1.2), (0, -y - 0.1, z * 0.3), (0, -y, z * 0.2)], 0.02, dark)
    else:
        red = kit.material(base=[0.6, 0.02, 0.02], pattern=PLAIN, gloss=0.2)
        white = kit.material(base=[0.85, 0.85, 0.82], pattern=PLAIN, gloss=0.2)
        ground, cross = [(red, white), (white, red), (kit.material(base=[0.03, 0.3, 0.1], pattern=PLAIN), white), (white, red)][rng.integers(4)]
        x, y, z = rng.uniform(0.16, 0.28), rng.uniform(0.45, 0.62), rng.uniform(0.32, 0.45)
        kit.add(BOX, (0, 0, z), (x, y, z), material=ground)
        kit.add(BOX, (0, 0, z), (0.015, y * 1.015, z * 1.02), material=dark if kit.chance(0.5) else cross)
        size, bar = z * rng.uniform(0.5, 0.7), z * 0.2
        for side in (-1, 1):
            kit.add(BOX, (side * x, 0, z), (0.014, size, bar), material=cross)
            kit.add(BOX, (side * x, 0, z), (0.016, bar, size), material=cross)
        handle(kit, (0, 0, 2 * z - 0.02), y * 0.35, 0.18, 0.035, dark if kit.chance(0.5) else ground)
        kit.add(BOX, (0, y * 0.65, 2 * z), (x * 0.4, 0.06, 0.02), material=metal, mirror=True)


def bowl(kit, base, profile, thick, material, inside):
    """A hollow body of revolution: `profile` outside, the same less `thick` inside, with a floor."""
    kit.loft(base, profile, material, TUBE)
    kit.loft(base, [(z, r - thick) for z, r in profile], inside, TUBE)
    z, r = profile[0]
    kit.add(CYL, np.array(base) + [0, 0, z + thick / 2], (r, r, thick / 2), material=material)
    z, r = profile[-1]
    kit.add(TUBE, np.array(base) + [0, 0, z], (r, r, 0.012), ((r - thick) / r, 1), material=material)


def barrel(kit):
    rng = kit.rng
    wood = timber(kit)._replace(pattern=int(rng.choice([STRIPES, RIBS])), frequency=rng.uniform(5, 10))
    hoop = steel(kit)._replace(gloss=0.15) if kit.chance(0.5) else black(kit)
    r, tall, belly = rng.uniform(0.42, 0.55), rng.uniform(1.1, 1.5), rng.uniform(1.12, 1.32)
    at = np.linspace(0, 1, 8)
    radii = r * (1 + (belly - 1) * (1 - (2 * at - 1) ** 2))
    bucket = kit.chance(0.15)
    if bucket:
        tall, radii = 0.8, r * (1 + 0.3 * at)
    kit.loft((0, 0, 0), list(zip(at * tall, radii, strict=True)), wood, TUBE if bucket else CYL)
    for z in (0.06, 0.28, 0.72, 0.94):
        here = np.interp(z, at, radii)
        kit.add(CYL if not bucket else TUBE, (0, 0, z * tall), (here * 1.025, here * 1.025, 0.045), material=hoop)
    head = wood._replace(pattern=PLANKS, frequency=6.0)
    if bucket:
        kit.add(CYL, (0, 0, tall * 0.6), (r * 1.15, r * 1.15, 0.01), material=kit.material(base=[0.08, 0.14, 0.16], pattern=PLAIN, gloss=0.6))
        handle(kit, (0, 0, tall * 0.9), r * 1.3, 0.55, 0.025, hoop)
        return
    kit.add(CYL, (0, 0, tall + 0.004), (r * 0.88, r * 0.88, 0.006), material=head)
    if kit.chance(0.45):
        kit.primitives = [p._replace(centre=p.centre - [0, 0, tall / 2]) for p in kit.primitives]
        tipped(kit, ALONG_X)
        low = 0.2
        kit.primitives = [p._replace(centre=p.centre + [0, 0, r * belly + low]) for p in kit.primitives]
        for x in (-0.3, 0.3):
            kit.add(BOX, (x * tall, 0, low * 0.9), (0.07, r * 1.1, low * 0.9), (1, 1), material=timber(kit))
            kit.add(BOX, (x * tall, r * 0.8, low * 1.5), (0.07, 0.16, low * 1.5), (1, 0.4), (0, 0.1), material=timber(kit), mirror=True)
        kit.between((tall / 2, 0, r * 0.75 + low), (tall / 2 + 0.25, 0, r * 0.75 + low), 0.04, material=brass(kit))
        kit.between((tall / 2 + 0.2, 0, r * 0.75 + low + 0.12), (tall / 2 + 0.2, 0, r * 0.75 + low - 0.1), 0.03, material=brass(kit))
    elif kit.chance(0.4):
        kit.between((r * 1.05, 0, tall * 0.2), (r * 1.05 + 0.25, 0, tall * 0.2), 0.04, material=brass(kit))
        kit.between((r * 1.05 + 0.2, 0, tall * 0.2 + 0.12), (r * 1.05 + 0.2, 0, tall * 0.2 - 0.1), 0.03, material=brass(kit))
