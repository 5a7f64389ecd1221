"""Makers of what stands in kitchens and on tables: pans, pots, teapots, cutlery, bottles, flowers, candles, baskets."""

import numpy as np

from .belongings import arc, barrel, black, bowl, brass, cloth, enamel, handle, pale, steel, timber, twin
from .kit import around
from .layout import BALL, BOX, CYL, TUBE
from .materials import BANDS, CAMOUFLAGE, CHECKER, CLOUDY, DOTS, PLAIN, RIBS, SPECKLES, STRIPES, WAVES, WRITING, paint


def flame(kit, at, size):
    kit.add(BALL, np.array(at) + [0, 0, size], (size * 0.45, size * 0.45, size), material=kit.material(base=[0.95, 0.65, 0.2], pattern=PLAIN, gloss=-0.9))


def cooking(kit):
    rng = kit.rng
    metal = steel(kit) if kit.chance(0.4) else enamel(kit) if kit.chance(0.6) else black(kit)
    inside, grip = steel(kit) if kit.chance(0.6) else black(kit), black(kit) if kit.chance(0.6) else timber(kit)
    r = rng.uniform(0.5, 0.7)
    kind = rng.choice(["pan", "pot", "saucepan", "kettle"])
    if kind == "pan":
        high = rng.uniform(0.12, 0.25)
        bowl(kit, (0, 0, 0), [(0, r * 0.8), (high, r)], 0.035, metal, inside)
        kit.chain([(r * 0.95, 0, high * 0.8), (r + 0.3, 0, high + 0.1), (r + rng.uniform(0.8, 1.1), 0, high + 0.16)], [0.045, 0.05, 0.06], grip)
        food = rng.random()
        if food < 0.35:
            for k in range(int(rng.integers(1, 3))):
                at = np.array([rng.uniform(-0.1, 0.1), 0.25 * (2 * k - 1), 0.045])
                kit.add(CYL, at, (0.22, 0.19, 0.015), material=kit.material(base=[0.9, 0.9, 0.87], pattern=PLAIN))
                kit.add(BALL, at + [0.02, 0, 0.02], (0.09, 0.09, 0.06), material=kit.material(base=[0.85, 0.45, 0.03], pattern=PLAIN, gloss=0.5))
        return
    high = rng.uniform(0.4, 0.9) if kind == "pot" else rng.uniform(0.35, 0.5)
    if kind == "kettle":
        kit.loft((0, 0, 0), [(0, r), (0.08, r * 1.05), (high * 0.6, r), (high, r * 0.75), (high + 0.15, r * 0.35)], metal)
        kit.add(CYL, (0, 0, high + 0.16), (r * 0.38, r * 0.38, 0.03), material=metal)
        kit.add(BALL, (0, 0, high + 0.24), (0.07, 0.07, 0.07), material=grip)
        kit.chain([(r * 0.8, 0, high * 0.5), (r * 1.2, 0, high * 0.8), (r * 1.4, 0, high * 1.15)], [0.14, 0.09, 0.06], metal)
        handle(kit, (0, 0, high * 0.85), r * 0.75, rng.uniform(0.5, 0.8), 0.045, grip, "x")
        return
    bowl(kit, (0, 0, 0), [(0, r * 0.95), (0.06, r), (high, r)], 0.04, metal, inside)
    kit.add(TUBE, (0, 0, high), (r * 1.02, r * 1.02, 0.02), material=metal)
    if kit.chance(0.55):
        lid = high + 0.02
        kit.loft((0, 0, lid), [(0, r * 1.02), (0.03, r), (0.1, r * 0.6), (0.13, r * 0.15)], metal)
        kit.loft((0, 0, lid + 0.12), [(0, 0.04), (0.06, 0.04), (0.08, 0.1), (0.12, 0.09)], grip)
    else:
        kit.add(CYL, (0, 0, high * rng.uniform(0.5, 0.85)), (r * 0.93, r * 0.93, 0.01), material=kit.material(pattern=rng.choice([CLOUDY, SPECKLES]), gloss=0.3))
        if kit.chance(0.5):
            kit.between((0, -r * 0.3, high * 0.5), (-0.3, r * 1.1, high * 1.5), 0.035, material=timber(kit))
    if kind == "pot":
        kit.chain(
            [(0.16, r * 0.98, high * 0.8), (0.14, r + 0.16, high * 0.85), (-0.14, r + 0.16, high * 0.85), (-0.16, r * 0.98, high * 0.8)],
            0.035,
            grip if kit.chance(0.5) else metal,
            mirror=True,
        )
    else:
        kit.between((r * 0.95, 0, high * 0.8), (r + 0.15, 0, high * 0.84), 0.04, material=metal)
        kit.between((r + 0.1, 0, high * 0.83), (r + rng.uniform(0.8, 1.1), 0, high * 0.98), (0.04, 0.06), material=grip)


def crockery(kit):
    rng = kit.rng
    glaze = kit.material(pattern=rng.choice([PLAIN, PLAIN, BANDS, DOTS, STRIPES, CAMOUFLAGE, WRITING]), frequency=rng.uniform(3, 9), gloss=rng.uniform(0.2, 0.64))
    inside = pale(kit) if kit.chance(0.6) else glaze._replace(pattern=PLAIN)
    if kit.chance(0.5):
        r, tall = rng.uniform(0.42, 0.6), rng.uniform(0.5, 0.8)
        belly = (
            [(0, 0.6), (0.08, 0.75), (0.35, 1.0), (0.65, 0.95), (0.85, 0.7), (1, 0.5)] if kit.chance(0.6) else [(0, 0.95), (0.1, 1), (0.7, 0.85), (0.9, 0.7), (1, 0.5)]
        )
        kit.loft((0, 0, 0), [(z * tall, k * r) for z, k in belly], glaze)
        kit.loft((0, 0, tall), [(0, r * 0.53), (0.03, r * 0.5), (0.1, r * 0.3), (0.13, 0.05), (0.15, 0.05), (0.19, 0.09), (0.25, 0.07), (0.27, 0.02)], glaze)
        kit.chain([(r * 0.75, 0, tall * 0.3), (r * 1.15, 0, tall * 0.45), (r * 1.4, 0, tall * 0.8), (r * 1.65, 0, tall * 0.97)], [0.15, 0.1, 0.07, 0.055], glaze)
        if kit.chance(0.75):
            kit.chain(arc((-r * 0.8, 0, tall * 0.52), (r * 0.75, tall * 0.36), 90, 270, 8), 0.05, glaze)
        else:
            handle(kit, (0, 0, tall * 0.85), r * 0.7, tall * 0.8, 0.045, timber(kit), "x")
        return
    r, tall, flare = rng.uniform(0.35, 0.45), rng.uniform(0.7, 1.0), rng.uniform(0.95, 1.15)
    tankard = kit.chance(0.2)
    body = timber(kit)._replace(pattern=STRIPES) if tankard else glaze
    bowl(kit, (0, 0, 0), [(0, r * 0.92), (0.05, r), (tall, r * flare)], 0.04, body, inside)
    kit.add(
        CYL,
        (0, 0, tall * rng.uniform(0.5, 0.9)),
        (r * 0.9, r * 0.9, 0.01),
        material=kit.material(base=[[0.08, 0.035, 0.015], [0.3, 0.12, 0.02], [0.7, 0.65, 0.55], [0.8, 0.5, 0.08]][rng.integers(4)], pattern=PLAIN, gloss=0.5),
    )
    kit.chain(arc((r * 0.9, 0, tall * 0.5), (rng.uniform(0.25, 0.38), tall * 0.32), -90, 90, 8), rng.uniform(0.045, 0.07), glaze)
    if tankard:
        for z in (0.2, 0.8):
            kit.add(TUBE, (0, 0, tall * z), (r * 1.06, r * 1.06, 0.05), material=steel(kit))


def cutlery(kit):
    rng = kit.rng
    metal = steel(kit)
    kinds = ["fork", "knife", "spoon"]
    rng.shuffle(kinds)
    count = int(rng.integers(1, 4))
    grip = metal if kit.chance(0.6) else timber(kit) if kit.chance(0.5) else enamel(kit)
    stand = rng.uniform(0.04, 0.07)
    for k in range(count):
        y = (2 * k - count + 1) * 0.2
        long = rng.uniform(0.75, 0.95)
        kit.between((0, y, 0), (0, y, long), (0.03, stand), BOX, 0.5, material=grip)
        if kinds[k] == "fork":
            kit.between((0, y, long - 0.02), (0, y, long + 0.18), (0.02, 0.035), BOX, material=metal)
            kit.add(BOX, (0, y, long + 0.22), (0.022, 0.11, 0.08), (1, 1), material=metal)
            for t in range(4):
                kit.between((0, y + 0.066 * (t - 1.5), long + 0.28), (0.02, y + 0.066 * (t - 1.5), long + 0.6), (0.016, 0.018), BOX, 0.7, material=metal)
        elif kinds[k] == "knife":
            kit.add(BOX, (0, y, long + 0.38), (0.012, 0.09, 0.42), (1, 0.45), (0, -0.04), material=metal)
        else:
            kit.between((0, y, long - 0.02), (0, y, long + 0.2), (0.02, 0.035), BOX, material=metal)
            kit.add(BALL, (0.01, y, long + 0.4), (0.045, 0.14, 0.24), material=metal)
    if kit.chance(0.4):
        r = 0.12 + 0.2 * count
        kit.loft((0, 0, -0.05), [(0, r * 0.85), (0.65, r)], kit.material(pattern=rng.choice([PLAIN, BANDS, DOTS])), TUBE)
        kit.add(CYL, (0, 0, -0.04), (r * 0.85, r * 0.85, 0.02), material=metal)


def bottle(kit):
    rng = kit.rng
    glass = kit.material(
        base=[[0.02, 0.06, 0.02], [0.12, 0.05, 0.01], [0.5, 0.55, 0.53], [0.02, 0.15, 0.08], [0.04, 0.1, 0.3]][rng.integers(5)], pattern=PLAIN, gloss=0.64
    )
    for k in range(int(rng.choice([1, 1, 1, 2, 3]))):
        at = np.array([rng.normal(0, 0.15), 0.85 * k, 0])
        r, body, neck = rng.uniform(0.26, 0.36), rng.uniform(0.6, 1.1), rng.uniform(0.25, 0.6)
        thin = r * rng.uniform(0.28, 0.42)
        style = rng.choice(["wine", "soda", "square", "flask"])
        label = pale(kit)._replace(pattern=WRITING, frequency=rng.uniform(6, 14), second=enamel(kit).first)
        if style == "square":
            kit.add(BOX, at + [0, 0, body / 2], (r, r * rng.uniform(0.6, 1), body / 2), material=glass)
            kit.add(BOX, at + [0, 0, body + 0.06], (r, r * 0.6, 0.07), (0.4, 0.6), material=glass)
            kit.add(BOX, at + [r, 0, body * 0.5], (0.008, r * 0.5, body * 0.3), material=label)
            top = body + 0.12
        elif style == "flask":
            kit.loft(at, [(0, r * 0.9), (body * 0.2, r * 1.25), (body * 0.45, r * 1.3), (body * 0.7, r * 0.95), (body * 0.9, thin * 1.1)], glass)
            kit.add(CYL, at + [0, 0, body * 0.32], (r * 1.3, r * 1.3, body * 0.12), material=label)
            top = body * 0.9
        else:
            rise = rng.uniform(0.12, 0.3) if style == "wine" else rng.uniform(0.3, 0.5)
            waist = 1 if style == "wine" else rng.uniform(0.88, 1)
            kit.loft(
                at, [(0, r * 0.93), (0.05, r), (body * 0.4, r * waist), (body * 0.6, r * waist), (body, r), (body + rise * 0.4, r * 0.85), (body + rise, thin)], glass
            )
            kit.loft(at, [(body * 0.2, r * 1.012), (body * 0.4, r * waist * 1.012), (body * 0.6, r * waist * 1.012), (body * 0.8, r * 1.012)], label)
            top = body + rise
        kit.add(CYL, at + [0, 0, top + neck / 2], (thin, thin, neck / 2), material=glass)
        cap = enamel(kit)
        kit.add(
            CYL, at + [0, 0, top + neck * 0.85], (thin * 1.15, thin * 1.15, neck * (0.28 if kit.chance(0.6) else 0.12)), material=cap if kit.chance(0.75) else timber(kit)
        )


def flowers(kit):
    rng = kit.rng
    glaze = kit.material(pattern=rng.choice([PLAIN, CLOUDY, BANDS, WAVES, DOTS]), gloss=rng.uniform(0.1, 0.64))
    r, tall = rng.uniform(0.28, 0.42), rng.uniform(0.7, 1.1)
    shape = [[0.6, 0.9, 1.0, 0.75, 0.45, 0.6], [0.5, 0.5, 0.6, 0.7, 0.8, 0.95], [0.45, 0.8, 1.1, 1.0, 0.6, 0.7], [0.8, 0.85, 0.8, 0.6, 0.35, 0.4]][rng.integers(4)]
    kit.loft((0, 0, 0), [(tall * k / 5, r * k_r) for k, k_r in enumerate(shape)], glaze)
    kit.add(CYL, (0, 0, tall), (r * shape[-1] * 1.12, r * shape[-1] * 1.12, 0.025), material=glaze)
    kit.add(CYL, (0, 0, tall + 0.028), (r * shape[-1] * 0.95, r * shape[-1] * 0.95, 0.006), material=black(kit))
    green = kit.material(base=paint(rng.uniform(0.22, 0.36), rng.uniform(0.4, 0.9), rng.uniform(0.08, 0.4)), pattern=PLAIN)
    hue, count = rng.random(), int(rng.integers(3, 9))
    tulip = kit.chance(0.4)
    for k in range(count):
        bloom = kit.material(base=paint((hue + rng.normal(0, 0.06)) % 1, rng.uniform(0.3, 1), rng.uniform(0.4, 0.95)), pattern=PLAIN)
        angle, out = 2 * np.pi * k / count + rng.normal(0, 0.3), rng.uniform(0.15, 0.5) * (k > 0)
        tip = np.array([out * np.cos(angle), out * np.sin(angle), tall + rng.uniform(0.5, 0.95) - out * 0.3])
        kit.between((0, 0, tall * 0.9), tip, 0.02, material=green)
        size = rng.uniform(0.11, 0.18)
        if tulip:
            kit.add(BALL, tip + [0, 0, size * 0.6], (size * 0.7, size * 0.7, size), material=bloom)
        else:
            kit.add(BALL, tip, (size, size, size * 0.5), material=bloom)
            kit.add(BALL, tip + [0, 0, size * 0.35], (size * 0.4, size * 0.4, size * 0.3), material=kit.material(base=[0.7, 0.45, 0.05], pattern=PLAIN))
        if k % 2:
            side = np.array([np.cos(angle + 0.8), np.sin(angle + 0.8), 0.6]) * rng.uniform(0.3, 0.5)
            kit.between((0, 0, tall * 0.98), side + [0, 0, tall], (0.012, 0.08), BOX, 0.2, material=green)


def candles(kit):
    rng = kit.rng
    wax = kit.material(base=np.array([0.85, 0.8, 0.68]) * rng.uniform(0.6, 1.1) if kit.chance(0.6) else None, pattern=PLAIN)
    metal = brass(kit) if kit.chance(0.6) else steel(kit)
    lit = kit.chance(0.7)

    def candle(at, r, tall):
        at = np.array(at, float)
        kit.add(CYL, at + [0, 0, tall / 2], (r, r, tall / 2), material=wax)
        kit.between(at + [0, 0, tall], at + [0, 0, tall + 0.06], 0.012, material=black(kit))
        if lit:
            flame(kit, at + [0, 0, tall + 0.03], 0.1)

    kind = rng.choice(["stick", "arms", "group", "chamber"])
    if kind == "group":
        kit.add(CYL, (0, 0, 0.03), (0.75, 0.75, 0.03), (1.06, 1), material=timber(kit) if kit.chance(0.5) else enamel(kit))
        for x, y in around(int(rng.integers(3, 6)), 0.42, rng.uniform(0, 90)):
            candle((x, y, 0.06), rng.uniform(0.12, 0.24), rng.uniform(0.3, 1.2))
    elif kind == "chamber":
        kit.add(CYL, (0, 0, 0.05), (0.3, 0.3, 0.05), (1.35, 1), material=metal)
        kit.add(CYL, (0, 0, 0.18), (0.12, 0.12, 0.1), material=metal)
        kit.chain(arc((0.5, 0, 0.2), 0.14, 0, 360, 9), 0.03, metal, joints=False)
        candle((0, 0, 0.2), 0.09, rng.uniform(0.4, 0.9))
    else:
        tall = rng.uniform(0.6, 1.2)
        kit.loft((0, 0, 0), [(0, 0.32), (0.05, 0.3), (0.1, 0.12), (0.2, 0.06), (tall * 0.5, 0.09), (tall * 0.55, 0.05), (tall, 0.06)], metal)
        if kind == "stick":
            kit.loft((0, 0, tall - 0.02), [(0, 0.06), (0.05, 0.17), (0.07, 0.09), (0.2, 0.09)], metal)
            candle((0, 0, tall + 0.15), 0.07, rng.uniform(0.4, 0.8))
        else:
            for reach in (0.3, 0.6)[: int(rng.integers(1, 3))]:
                first = len(kit.primitives)
                kit.chain(arc((0, reach / 2, tall * 0.8), (reach / 2, 0.22), -180, 0, 6, "yz"), 0.03, metal, joints=False)
                kit.loft((0, reach, tall * 0.8), [(0, 0.03), (0.05, 0.12), (0.07, 0.06), (0.14, 0.06)], metal)
                candle((0, reach, tall * 0.8 + 0.12), 0.045, 0.4)
                twin(kit, first)
            kit.loft((0, 0, tall - 0.02), [(0, 0.06), (0.05, 0.12), (0.07, 0.06), (0.14, 0.06)], metal)
            candle((0, 0, tall + 0.1), 0.045, 0.45)


def basket(kit):
    rng = kit.rng
    cane = kit.material(base=np.array([0.5, 0.32, 0.13]) * rng.uniform(0.4, 1.5), pattern=rng.choice([CHECKER, RIBS, BANDS]), frequency=rng.uniform(12, 22))
    rim = cane._replace(pattern=STRIPES, frequency=20.0)
    r, tall, flare = rng.uniform(0.45, 0.65), rng.uniform(0.35, 0.8), rng.uniform(1.05, 1.35)
    bowl(kit, (0, 0, 0), [(0, r * 0.92), (tall * 0.4, r * (1 + (flare - 1) * 0.5)), (tall, r * flare)], 0.04, cane, cane)
    kit.chain(arc((0, 0, tall), r * flare * 0.98, 0, 360, 17, "xy"), 0.045, rim, joints=False)
    if kit.chance(0.65):
        kit.chain(arc((0, 0, tall), (r * flare, rng.uniform(0.6, 0.9)), 0, 180, 9, "yz"), 0.04, rim)
    else:
        kit.chain(arc((0, r * flare, tall), (0.18, 0.18), 0, 180, 6, "xz"), 0.035, rim, mirror=True)
    what = rng.random()
    if what < 0.7:
        kit.add(CYL, (0, 0, tall * 0.7), (r * 1.05, r * 1.05, 0.02), material=cloth(kit))
        fruit = kit.material(base=paint(rng.choice([0, 0.06, 0.12, 0.25]), 0.9, rng.uniform(0.4, 0.8)), pattern=PLAIN, gloss=0.3)
        size = rng.uniform(0.15, 0.24)
        for x, y in around(6, r * 0.66, rng.uniform(0, 60)):
            kit.add(BALL, (x, y, tall * 0.7 + size * 0.8), (size, size, size), material=fruit)
        kit.add(BALL, (0, 0, tall * 0.7 + size * 1.5), (size, size, size), material=fruit)


def kitchenware(kit):
    """Pans, pots, kettles, teapots, mugs, cutlery, bottles with labels, vases of flowers, candles, baskets, barrels."""
    kit.rng.choice([cooking, cooking, crockery, cutlery, bottle, flowers, candles, basket, barrel])(kit)
