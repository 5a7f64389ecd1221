"""Makers of objects by nobody's plan: bodies grown on bodies, regular arrays and slender frames, all of joined parts."""

from collections import namedtuple
from itertools import pairwise

import numpy as np

from .belongings import arc, black, brass, cloth, enamel, pale, steel, timber, tipped
from .extent import bounds
from .kit import ALONG_X, ALONG_Y, Kit, around, towards, turn
from .layout import BALL, BARS, BOX, CYL, GRID, LATTICE, PRIMS, PRISM, RUNGS, SOLID, TUBE
from .materials import CHECKER, PLAIN, SEAMS, STRIPES, WRITING

# Of a part's half size along a face's normal, how deep under the face the points lie where others are joined to it.
INSET = 0.06
# What a composition's parts share: materials, kinds, spread of proportions, mean log size over the parent's, share turned freely, growth's direction.
Style = namedtuple("Style", "mats kinds spread size askew lean")


def palette(kit):
    """One to four materials, the first the commonest."""
    makers, chances = [Kit.material, timber, enamel, steel, brass, black, pale, cloth], [0.5, 0.11, 0.11, 0.08, 0.04, 0.07, 0.05, 0.04]
    mats = [makers[kit.rng.choice(len(makers), p=chances)](kit) for _ in range(kit.rng.choice([1, 2, 3, 4], p=[0.15, 0.35, 0.3, 0.2]))]
    if kit.chance(0.3):
        mats[1:] = [mats[0]._replace(first=np.clip(mats[0].first * kit.rng.uniform(0.25, 1.8), 0.01, 0.99)) for _ in mats[1:]]
    return mats


def pick(kit, mats):
    return mats[int(len(mats) * kit.rng.random() ** 1.7)]


def widths(p, k):
    return p.half * np.array([1 + (p.taper[0] - 1) * k, 1 + (p.taper[1 if p.kind == BOX else 0] - 1) * k, 1])


def surface(kit, p, style, middle=False):
    """A point just under the primitive's surface, a frame [3, 3] whose z leaves it there, the face's half sizes along x and y, the depth."""
    rng, signs = kit.rng, np.repeat([1.0, -1], 3)
    normals = signs[:, None] * np.tile(p.rotation.T, (2, 1))
    chances = np.sqrt(np.tile(1 / p.half, 2)) * np.exp(normals @ style.lean)
    face = int(rng.choice(6, p=chances / chances.sum()))
    i, j = face % 3, (face + 1) % 3
    u = rng.uniform(-0.6, 0.6, 3) * (rng.random(3) < 0.55) * (not middle)
    u[i] = signs[face]
    if p.kind == BALL:
        u /= np.linalg.norm(u)
        return p.centre + p.rotation @ (u * p.half * (1 - INSET)), towards(p.rotation @ (u / p.half)), np.full(2, 0.2 * p.half.min()), INSET * p.half.min()
    k, depth = (u[2] + 1) / 2, INSET * p.half[i]
    wide, z, along = widths(p, k), normals[face], p.rotation[:, j]
    extents = np.array([wide[j], wide[3 - i - j]]) * (1 if p.kind == BOX else 0.68)
    if i < 2:
        u[:2] /= np.linalg.norm(u[:2]) if p.kind != BOX else 1
        rise = towards(p.rotation @ ((widths(p, 1) - widths(p, 0)) * u + [*p.shift, 2 * p.half[2]]))[:, 2]
        along = towards(np.cross(rise, p.rotation @ (u / p.half * [1, 1, 0]) if p.kind != BOX else z))[:, 2]
        z, extents = np.cross(along, rise), np.array([wide[1 - i] if p.kind == BOX else 0.32 * wide[:2].min(), p.half[2] * 0.9])
    point = p.centre + p.rotation @ (u * wide + np.array([*p.shift, 0]) * k) - z * depth
    return point, np.stack([along, np.cross(z, along), z], 1), extents, depth


def tapers(kit, kind):
    across = kit.rng.uniform(0.2, 1.15) if kit.chance(0.5) else 1
    return (
        (across, int(kit.rng.integers(3, 9))) if kind == PRISM else (across, kit.rng.choice([across, 1, kit.rng.uniform(0.3, 1.1)]) if kind == BOX and across != 1 else 1)
    )


# What is joined to a face, and how often: "body" also turned freely or half sunk in, "tower" also a pipe, "handle" a bow, a gate or a ring.
PARTS = {"body": 10, "fin": 2, "row": 3, "tower": 3.5, "limb": 2, "handle": 2, "panels": 2.5, "bands": 0.8}


def grow(kit, p, style, part):
    """Join a part or some to a primitive's face: see PARTS."""
    rng, part = kit.rng, "panels" if part == "bands" and (p.kind == BALL or p.half.min() < 0.05) else part
    point, frame, face, depth = surface(kit, p, style, middle=part in ("row", "panels", "handle") or kit.chance(0.3))
    if part in ("handle", "fin") and kit.chance(0.5) or part == "row" and face[1] > face[0] * 1.2:
        frame, face = frame @ turn("z", 90), face[::-1]
    if part in ("body", "fin"):
        out, kind, shift = frame[:, 2], int(rng.choice(style.kinds)), np.zeros(2)
        half = np.cbrt(p.half.prod()) * np.exp(rng.normal(style.size, 0.4) + rng.normal(0, style.spread, 3))
        half = np.clip(np.where(rng.random(3) < [0.35, 0.35, 0], [*(face * rng.choice([1, 0.97, 0.9, 0.75, 0.5], 2)), 0], half), 0.03, 1.3)
        lift = half[2] * (rng.uniform(0, 0.5) if kit.chance(0.2) else rng.uniform(0.8, 0.97))
        if part == "fin":
            kind, half, shift = BOX, np.array([face[0] * rng.uniform(0.3, 1.1), rng.uniform(0.015, 0.06), half[2] * 1.4]), rng.normal(0, 0.3, 2) * face * (1, 0)
        elif kit.chance(style.askew):
            frame = frame @ turn(rng.choice(["x", "y", "z"]), rng.uniform(-80, 80)) @ turn("x", rng.choice([0, rng.uniform(-40, 40)]))
            lift = min(lift, half.min() * 0.8)
        elif kind == BOX and kit.chance(0.3):
            frame, shift = frame @ turn("z", rng.choice([0, 45])), rng.normal(0, 0.4, 2) * half[:2]
        kit.add(kind, point + out * lift, half, tapers(kit, kind), shift if kind == BOX else (0, 0), frame, pick(kit, style.mats))
    elif part == "row":
        count, kind = int(rng.integers(2, 7)), int(rng.choice(style.kinds))
        step, ratio, taper, looks = 1.7 * face[0] / count, rng.choice([1, 1, rng.uniform(0.75, 1)]), tapers(kit, kind), [pick(kit, style.mats) for _ in range(2)]
        half = np.array([step * rng.uniform(0.15, 0.46), face[1] * rng.uniform(0.1, 0.95), np.clip(face.max() * np.exp(rng.normal(-1.3, 0.7)), 0.03, 1)])
        half[1] = half[0] if kind != BOX and kit.chance(0.7) else half[1]
        for k in range(count):
            size = half * (1, 1, ratio**k)
            kit.add(kind, point + frame @ [(k - (count - 1) / 2) * step, 0, size[2] * 0.85], size + [0, 0, depth], taper, (0, 0), frame, looks[k % 2])
    elif part == "tower":
        count, radius, kind = int(rng.integers(1, 6)), min(face.min() * rng.uniform(0.3, 1.3), 0.8), int(rng.choice([CYL, CYL, BOX, PRISM, TUBE]))
        radii = radius * np.exp(np.cumsum(rng.normal(-0.05, 0.35, count + 1)))
        heights = np.concatenate([[0], np.cumsum(rng.uniform(0.15, 1.1, count))]) * radius * np.exp(rng.normal(0.2, 0.5))
        first, flat, looks = len(kit.primitives), rng.choice([1, rng.uniform(0.5, 1)]), [pick(kit, style.mats) for _ in range(2)]
        kit.loft(point, list(zip(heights, radii, strict=True)), looks[0], kind, frame, flat, int(rng.integers(3, 9)))
        kit.primitives[first:] = [q._replace(material=looks[k % 2]) for k, q in enumerate(kit.primitives[first:])]
        if kind != TUBE and kit.chance(0.4):
            wide = radii[-1] * rng.uniform(0.6, 0.88)
            kit.add(BOX if kind == BOX else CYL, point + frame[:, 2] * heights[-1], (wide, wide * flat, 0.015), rotation=frame, material=black(kit))
    elif part == "limb":
        radius, way, points = np.clip(face.min() * rng.uniform(0.15, 0.8), 0.03, 0.35), frame[:, 2], [point]
        for _ in range(int(rng.integers(1, 4))):
            points.append(points[-1] + way * radius * np.exp(rng.uniform(0.8, 2.2)))
            way = towards(way + rng.normal(0, 0.7, 3) + [0, 0, rng.choice([-0.8, 0, 0.8])])[:, 2]
        radii = radius * np.linspace(1, rng.uniform(0.4, 1.1), len(points))
        kit.chain(points, radii, pick(kit, style.mats))
        if kit.chance(0.5):
            kit.add(
                int(rng.choice([BALL, BOX, CYL, PRISM])),
                points[-1],
                radii[-1] * np.exp(rng.normal(0.5, 0.4, 3)),
                (1, 6),
                (0, 0),
                towards(points[-1] - points[-2]),
                pick(kit, style.mats),
            )
    elif part == "handle":
        wide, look, kind, count = np.clip(face[0] * rng.uniform(0.4, 0.9), 0.02, 1), pick(kit, style.mats), rng.choice(["bow", "gate", "ring"]), int(rng.integers(6, 13))
        high, thick = wide * np.exp(rng.normal(0, 0.5)), wide * rng.uniform(0.07, 0.25)
        if kind == "bow":
            kit.chain([point + frame @ at for at in arc((0, 0, -depth), (wide, high), 0, 180, count // 2 + 1)], thick, look)
        elif kind == "gate":
            deep = max(face[1] * rng.uniform(0.2, 0.9), thick)
            for x in (thick - wide, wide - thick, 0):
                size = (thick, deep, high / 2 + thick) if x else (wide * 1.15, deep * 1.05, thick * 1.5)
                kit.add(BOX, point + frame @ [x, 0, high / 2 if x else high], size, rotation=frame, material=look)
        else:
            for k in range(count):
                spin = frame @ turn("y", 360 * k / count)
                kit.add(
                    BOX,
                    point + frame[:, 2] * (wide + thick * 0.6) + spin[:, 2] * wide,
                    (wide * np.tan(np.pi / count) + thick * 0.7, thick * 1.4, thick),
                    (1, 1),
                    (0, 0),
                    spin,
                    look,
                )
    else:
        lettered = kit.material(pattern=rng.choice([WRITING, WRITING, STRIPES, CHECKER, SEAMS, PLAIN]), frequency=np.exp(rng.uniform(1.5, 3.2)))
        count, look, trim = int(rng.choice([1, 1, 2, 3])), [black(kit), lettered, pick(kit, style.mats)][rng.integers(3)], pick(kit, style.mats)
        if part == "bands":
            for z in rng.choice([-0.8, -0.4, 0, 0.4, 0.8], count, replace=False):
                at, half = p.centre + p.rotation @ [*(np.array(p.shift) * (z + 1) / 2), z * p.half[2]], widths(p, (z + 1) / 2) * (1.07, 1.07, 0.1)
                kit.add(p.kind, at, half, (1, p.taper[1] if p.kind == PRISM else 1), (0, 0), p.rotation, trim)
        else:
            wide, high, framed = face[0] * rng.uniform(0.2, 0.85) / count, face[1] * rng.uniform(0.1, 0.85), kit.chance(0.25) and p.kind == BOX
            cut = (int(rng.choice([BARS, RUNGS, GRID, LATTICE])), 4 / max(wide, 0.05), 0.5) if kit.chance(0.15) else (SOLID, 1.0, 1.0)
            for k in range(count):
                at = point + frame[:, 0] * (k - (count - 1) / 2) * 1.8 * face[0] / count
                kit.add(BOX, at, (wide, high, depth + 0.012), rotation=frame, material=look, cut=cut)
                for side in (-1, 1) if framed else ():
                    kit.add(BOX, at + frame[:, 0] * side * wide, (wide * 0.12, high * 1.1, depth + 0.05), rotation=frame, material=trim)
                    kit.add(BOX, at + frame[:, 1] * side * high, (wide, high * 0.12, depth + 0.05), rotation=frame, material=trim)


def symmetrised(primitives, axis):
    """All primitives and, of those that are not their own twins, the twins across the plane through the origin."""
    flip, twins = np.diag(np.where(np.arange(3) == axis, -1.0, 1)), []
    for p in primitives:
        local, spread = p.rotation.T @ flip @ p.rotation, p.rotation @ np.diag(p.half**2) @ p.rotation.T
        same = abs(p.centre[axis]) < 1e-6 and (local[2, 2] > 0.999 or p.taper[0] == 1) and np.allclose(local @ [*p.shift, 0], [*p.shift, 0], atol=1e-6)
        twin = p._replace(centre=flip @ p.centre, shift=(p.shift[0], -p.shift[1]), rotation=flip @ p.rotation @ np.diag([1.0, -1, 1]))
        twins += [p] if same and np.allclose(flip @ spread @ flip, spread, atol=1e-9) else [p, twin]
    return twins


def settle(kit, mats):
    """Four fifths stand as things do, with legs, a foot or a block under what would fall over; the others lean, lie or stand on a point."""
    rng, kit.primitives = kit.rng, kit.primitives[: PRIMS - 8]
    if kit.chance(0.2):
        tipped(kit, turn("x", rng.choice([0, 90, rng.uniform(-50, 50)])) @ turn("y", rng.choice([0, rng.uniform(-60, 60)])))
        return
    boxes, weights = np.array([bounds([p]) for p in kit.primitives]), np.array([p.half.prod() for p in kit.primitives])
    low, high, mass = boxes[:, 0].min(0), boxes[:, 1].max(0), weights @ np.array([p.centre for p in kit.primitives]) / weights.sum()
    size = np.linalg.norm(high - low)
    feet = boxes[boxes[:, 0, 2] < low[2] + 0.02 * size, :, :2]
    if np.all(mass[:2] > feet.min((0, 1))) and np.all(mass[:2] < feet.max((0, 1))) and np.ptp(feet, (0, 1)).min() > 0.08 * size:
        return
    body, look, kind = kit.primitives[int(weights.argmax())], pick(kit, mats), rng.choice(["legs", "slab", "block"])
    at, floor, thick = body.centre, low[2] - size * rng.choice([0, 0, rng.uniform(0, 0.25)]), size * np.exp(rng.uniform(-4.2, -3))
    reach = np.maximum(np.maximum(high - at, at - low)[:2] * rng.uniform(0.35, 0.8), 0.08 * size)
    if kind == "legs":
        count, splay, shape = int(rng.integers(3, 7)), rng.uniform(0.25, 1), int(rng.choice([CYL, BOX]))
        for x, y in around(count, 1, 180 / count):
            top = at + body.rotation @ (body.half * [0.55 * x, 0.55 * y, 0])
            kit.between((*((at[:2] + reach * (x, y)) * splay + top[:2] * (1 - splay)), floor), top, thick, shape, material=look)
        return
    stem = thick * rng.uniform(1, 2.5) if kind == "slab" else reach * rng.uniform(0.5, 0.9)
    kit.between((*at[:2], floor), (*at[:2], max(at[2], floor + 0.03 * size)), stem, int(rng.choice([BOX, CYL])), material=look)
    kit.add(int(rng.choice([BOX, CYL])), (*at[:2], floor + thick), (*reach, thick), material=look)


def composition(kit):
    """Bodies grown on the faces of bodies: mirrored, doubly mirrored, repeated around an axis, or free."""
    rng, mats = kit.rng, palette(kit)
    order, repeats = rng.choice(["mirror", "double", "turned", "free"], p=[0.52, 0.14, 0.14, 0.2]), int(rng.integers(3, 13))
    kinds, lean = rng.choice([BOX, BOX, BOX, CYL, CYL, BALL, PRISM], 3), np.array([rng.normal(0, 0.8), 0, rng.normal(0.5, 0.8)]) * kit.chance(0.7)
    style = Style(mats, kinds, rng.uniform(0.1, 0.8), rng.uniform(-1.0, -0.2), rng.choice([0, 0, 0.15, 0.8]), lean)
    kit.bevel = rng.choice([2.3, 3, 5, 9]) if kit.chance(0.25) else kit.bevel
    kind, half = int(rng.choice(kinds if order != "turned" else [CYL, CYL, PRISM, BALL])), np.exp(rng.normal(0, 0.2 + style.spread, 3))
    half[1] = half[0] if order == "turned" else half[1]
    tilt = rng.choice([np.eye(3), *[ALONG_X, ALONG_Y, turn("y", rng.uniform(-60, 60))] * (order in ("mirror", "free"))])
    kit.add(kind, (0, 0, 0), half / half.max(), (rng.uniform(0.6, 1.1), repeats) if kind == PRISM else tapers(kit, kind), (0, 0), tilt, mats[0])
    most = max(np.exp(rng.uniform(np.log(3), np.log(44))) / {"mirror": 1.6, "double": 2.5, "turned": repeats / 2, "free": 1}[order], 3)
    weights = np.array(list(PARTS.values())) * rng.gamma(0.8, 1, len(PARTS)) + 0.05
    while (count := len(kit.primitives)) < most:
        parent = kit.primitives[rng.choice([0, count - 1, rng.integers(count)], p=[0.4, 0.2, 0.4])]
        if parent.half.max() > 0.09 and parent.cut[0] == SOLID and parent.kind != TUBE:
            grow(kit, parent, style, rng.choice(list(PARTS), p=weights / weights.sum()))
            new = kit.primitives[count:]
            if order != "turned" and parent.kind == CYL and np.isclose(*parent.half[:2]) and len(new) < 5 and kit.chance(0.2):
                spins = [parent.rotation @ turn("z", 360 * k / repeats) @ parent.rotation.T for k in range(1, repeats)]
                kit.primitives += [q._replace(centre=parent.centre + s @ (q.centre - parent.centre), rotation=s @ q.rotation) for s in spins for q in new]
    if order == "turned":
        times = [1 if np.hypot(*p.centre[:2]) < 1e-6 and abs(p.rotation[2, 2]) > 0.999 else repeats for p in kit.primitives]
        spun = [(p, turn("z", 360 * k / repeats)) for p, n in zip(kit.primitives, times, strict=True) for k in range(n)]
        kit.primitives = [p._replace(centre=s @ p.centre, rotation=s @ p.rotation) for p, s in spun]
    for axis in {"mirror": [1], "double": [1, 0]}.get(order, []):
        kit.primitives = symmetrised(kit.primitives, axis)
    settle(kit, mats)


def unit(kit, mats):
    """A function that places one element: put(centre, half, index, rotation, held, solid). Some few are missing, where held by others, or moved."""
    kind, scheme, flawed = int(kit.rng.choice([BOX, BOX, BOX, CYL, CYL, BALL, PRISM])), kit.rng.choice(["one", "turns", "pairs", "random"]), kit.chance(0.1)
    taper, cap = tapers(kit, kind), kit.chance(0.25)

    def put(centre, half, index=0, rotation=ALONG_X @ ALONG_X.T, held=False, solid=False):
        if flawed and held and kit.chance(0.1):
            return
        centre = np.array(centre) + np.array([0, kit.rng.uniform(-0.4, 0.4) * half[1], 0]) * (flawed and kit.chance(0.1))
        look = mats[{"turns": index, "pairs": index // 2, "random": kit.rng.integers(9)}.get(scheme, 0) % len(mats)]
        kit.add(BOX if solid else kind, centre, half, (1, 1) if solid else taper, (0, 0), rotation, look)
        if cap and not solid and len(kit.primitives) < PRIMS // 2:
            kit.add(BOX if kind == BOX else CYL, centre + rotation[:, 2] * half[2] * 0.95, half * np.array([0.7, 0.7, 0.12]), (1, 1), (0, 0), rotation, mats[-1])

    return put


def grid(kit, mats, put):
    """Elements in rows, columns and layers: on a slab, packed, on shelves, in bond with openings, in bundles of tubes, of waving or stepped heights."""
    rng, n = kit.rng, np.zeros(3, int)
    limits = {
        "slab": ((1, 1, 1), (7, 7, 1)),
        "packed": (1, 6),
        "shelves": ((1, 1, 2), (7, 1, 6)),
        "bond": ((3, 1, 3), (7, 1, 8)),
        "bundle": ((2, 2, 1), (6, 6, 1)),
        "heights": ((2, 1, 1), (14, 6, 1)),
    }
    order = rng.choice(list(limits))
    while not 4 <= n.prod() <= 52:
        n = rng.integers(*limits[order], 3, endpoint=True)
    pitch, fill, waves = (
        np.exp(rng.normal(-0.9, 0.45, 1 if order == "bundle" else 3)) * (1, 0.866 if order == "bundle" else 1, 1),
        rng.uniform(0.25, 0.47) if order in ("slab", "shelves") else 0.507,
        rng.uniform(0.2, 1.2, 2),
    )
    gap, stepped = rng.integers(1, n[0], 2) if order == "bond" and kit.chance(0.7) else [], kit.chance(0.4)
    for k in range(n.prod()):
        i, j, m = np.unravel_index(k, n)
        rise, turned = {"shelves": rng.uniform(0.5, 0.9), "bundle": 4}.get(order, 1), {"bundle": j % 2, "bond": m % 2}.get(order, 0) / 2
        if order == "heights":
            rise = (i + 1) / 2 if stepped else np.exp(np.sin(i * waves[0]) + np.cos(j * waves[1]) - 1)
        at, half = pitch * (i + turned - (n[0] - 1) / 2, j - (n[1] - 1) / 2, m + 0.5 * rise), pitch * (fill, fill * (1.155 if order == "bundle" else 1), 0.507 * rise)
        if not (i in gap and 0 < m < n[2] - 1):
            put(at, half, i + j + m, held=fill < 0.5, solid=order == "bond")
    out, shelves = n * pitch / 2, order == "shelves"
    boards = [(0, 0, pitch[2] * m, *out[:2], pitch[2] * 0.06) for m in range((n[2] if fill < 0.5 else order in ("packed", "heights")) + shelves)]
    walls = [(-out[0], 0, out[2], 0.03, out[1], out[2] * 1.03), (out[0], 0, out[2], 0.03, out[1], out[2] * 1.03), (0, out[1], out[2], out[0], 0.03, out[2])]
    for box in boards + walls[: (2 + kit.chance(0.5)) * shelves]:
        kit.add(BOX, box[:3], box[3:], material=mats[-1])
    if order == "bundle" and kit.chance(0.6):
        tipped(kit, ALONG_X)


def series(kit, mats, put):
    """Elements by the same step and turn: ribbed spines, helices, piles, stairs, arches, rings; fans and wheels; shells within shells; slats on rails or in layers."""
    rng, order = kit.rng, kit.rng.choice(["spine", "spine", "pile", "pile", "winding", "stairs", "arch", "fan", "fan", "fan", "nest", "slats", "slats"])
    if order == "fan":
        count, whole, wide, hub, long = int(rng.integers(3, 25)), kit.chance(0.5), rng.uniform(60, 240), rng.uniform(0.08, 0.35), rng.uniform(0.4, 1.0)
        half = np.array([rng.uniform(0.2, 0.9) * 2.5 * (hub + long * rng.random()) / count, np.exp(rng.uniform(-3.2, -0.7)), long / 2])
        pitch, lift, deep = rng.choice([0, rng.uniform(-60, 60)]), rng.choice([0, 0, rng.uniform(-40, 40)]), max(half[1], 0.08)
        frame, rim = rng.choice([np.eye(3), ALONG_Y, ALONG_Y, turn("z", 90)]), hub * 0.7 + long * 0.97
        for k in range(count):
            spin = frame @ turn("y", 360 * k / count if whole else wide * (k / (count - 1) - 0.5)) @ turn("x", lift)
            put(spin[:, 2] * (hub * 0.7 + long / 2), half, k, spin @ turn("z", pitch), held=True)
            if whole and lift == 0 and 5 < count < 16:
                kit.add(BOX, spin[:, 2] * rim, (rim * np.tan(np.pi / count) * 1.05, deep * 0.7, long * 0.05), rotation=spin, material=mats[-1])
        kit.add(int(rng.choice([CYL, PRISM])), (0, 0, 0), (hub, hub, deep * 1.3), (1, max(3, min(count, 12))), (0, 0), frame @ ALONG_Y, mats[-1])
    elif order == "nest":
        count, kind, squeeze, high, sides = (
            int(rng.integers(3, 8)),
            int(rng.choice([TUBE, TUBE, CYL, BOX, PRISM])),
            rng.uniform(0.4, 1),
            rng.uniform(0.3, 1.2),
            int(rng.integers(3, 9)),
        )
        for k in range(count):
            radius, tall = 1 - 0.85 * k / count, high * (1 + (-1 if kind == TUBE and sides < 6 else 1) * 0.8 * k / count)
            kit.add(
                kind, (0, 0, tall / 2), (radius, radius * squeeze, tall / 2), (rng.uniform(0.85, 1), sides) if kind == PRISM else (1, 1), material=mats[k % len(mats)]
            )
        kit.add(CYL if kind in (TUBE, CYL) else BOX, (0, 0, 0), (1.05, squeeze * 1.05, 0.06), material=mats[-1])
    elif order == "slats":
        layers, count, long, thick = int(rng.choice([1, 1, 2, 3, 4])), int(rng.integers(4, 15)), rng.uniform(0.3, 1.2), rng.uniform(0.02, 0.09)
        pitch, lean, frame = 2 / count, rng.choice([0, rng.uniform(-60, 60)]), rng.choice([np.eye(3), ALONG_X, ALONG_Y @ turn("z", 90)])
        for k in range(layers * count):
            m, spin = k // count, frame @ turn("z", 90 * (k // count % 2))
            put(
                spin @ [(k % count - (count - 1) / 2) * pitch, 0, 1.9 * thick * m],
                (pitch * 0.35, thick, long if layers == 1 else 1),
                k,
                spin @ turn("x", 90) @ turn("z", lean * (layers == 1)),
                held=layers == 1,
                solid=layers > 1,
            )
        for y in (-0.75, 0.75) if layers == 1 else ():
            kit.add(BOX, frame @ [0, y * long, thick * rng.uniform(-1, 0.2)], (1.05, rng.uniform(0.03, 0.09), thick), rotation=frame, material=mats[-1])
    else:
        half, spin, step, frame = np.exp(rng.normal(-1.1, 0.45, 3)), np.eye(3), np.zeros(3), np.eye(3)
        count, ratio, offset, points = int(rng.integers(4, 22)), 1.0, np.zeros(3), [np.zeros(3)]
        swell, small = rng.uniform(0, 1) * (order == "spine"), rng.choice([1, 1, rng.uniform(0.4, 0.8)])
        if order == "spine":
            half[0], step, spin = (
                rng.uniform(0.06, 0.45) * 2 / count,
                np.array([2 / count, 0, rng.choice([0, 0.5]) / count]),
                turn(rng.choice(["y", "z"]), rng.choice([0, rng.uniform(-300, 300)]) / count),
            )
        elif order == "pile":
            half[2], ratio, spin = rng.uniform(0.05, 0.3), rng.choice([1, rng.uniform(0.78, 0.97)]), turn("z", rng.choice([0, 45, 90, rng.uniform(3, 30)]))
            step[2] = half[2] * (1 + ratio) * 0.98
        elif order == "winding":
            half[2], spin, step, offset = rng.uniform(0.03, 0.1), turn("z", rng.uniform(12, 50)), np.array([0, 0, rng.uniform(0.05, 0.2)]), half * (1.02, 0, 0)
        elif order == "stairs":
            half, step = half * (4 / count, 1, 4 / count), half * (7.68 / count, 0, 7.2 / count)
        else:
            whole, radius = rng.choice([180, 180, 270, 360]), 1.0
            frame, spin, step = turn("y", -90), turn("y", whole / count), np.array([2 * radius * np.sin(np.radians(whole / 2 / count)), 0, 0])
            half = np.array([np.tan(np.radians(whole / 2 / count)) * radius * 1.15 + 0.02, half[1], rng.uniform(0.08, 0.3)])
        for k in range(count):
            bulge = 1 - swell + swell * max(np.sin(np.pi * (0.08 + 0.9 * k / count)), 0.05)
            size = half * ratio**k * ((small, small, 1) if order == "pile" and k % 2 else (1, bulge, bulge))
            put(points[-1] + frame @ offset, size, k, frame, held=order == "winding", solid=order in ("arch", "stairs"))
            points, frame = [*points, points[-1] + frame @ step * ratio**k], frame @ spin
        if order == "spine":
            kit.chain(points[:-1], half[1:].min() * 0.18, mats[-1], joints=False)
        if order == "winding":
            kit.loft((0, 0, -0.15), [(0, half[0] * 1.2), (0.08, half[0] * 1.2), (0.081, half[0] * 0.15), (points[-1][2] + 0.2, half[0] * 0.15)], mats[-1])


def assembly(kit):
    """Regular things: grids, shelves, bonds and bundles, ribbed spines, piles, stairs, arches, fans and wheels, nested shells, slats."""
    rng, mats = kit.rng, palette(kit)
    rng.choice([grid, series, series, series])(kit, mats, unit(kit, mats))
    for _ in range(int(rng.choice([0, 0, 1, 2, 3]))):
        body = kit.primitives[rng.integers(len(kit.primitives))]
        if body.half.min() > 0.05 and body.kind != TUBE:
            grow(kit, body, Style(mats, [BOX, CYL, BALL], 0.3, -0.6, 0, np.zeros(3)), rng.choice(list(PARTS)))
    settle(kit, mats)


def skeleton(kit, order):
    """Edges [(start, end), ...] of rings of corners above each other, a forking stem, rods from a place, bent tubes, posts with wires, a stem with plates."""
    rng = kit.rng
    if order == "cage":
        sides, high, squeeze = int(rng.choice([2, 3, 4, 4, 6, 8])), rng.uniform(0.8, 4), rng.uniform(0.4, 1)
        levels, across, edges = min(int(rng.integers(2, 7)), 20 // sides), rng.choice([0, 1, 2], p=[0.4, 0.45, 0.15]), []
        t, twist, lying = np.linspace(0, 1, levels), rng.choice([0, 0, 0.5, rng.uniform(-0.5, 0.5)]), rng.choice([np.eye(3), np.eye(3), ALONG_X @ turn("z", 180 / sides)])
        radii = rng.choice([np.ones(levels), 1 - t * rng.uniform(0.2, 0.85), np.sqrt(1 - (t * 0.95) ** 2), 0.4 + 0.6 * np.sin(np.pi * (0.1 + 0.8 * t))])
        rings = [
            [lying @ [x, y * squeeze, z * high] for x, y in around(sides, r * 0.6, 360 / sides * (0.5 + twist * k))]
            for k, (z, r) in enumerate(zip(t, radii, strict=True))
        ]
        for k, i in np.ndindex(levels, sides):
            edges += [(rings[k][i], rings[k][(i + 1) % sides])] if i or sides > 2 else []
            a, b = (i + k) % sides, (i + k + 1) % sides
            edges += [(rings[k][i], rings[k + 1][j]) for i, j in [(i, i), (a, b), (b, a)][: 1 + across]] if k + 1 < levels else []
        return edges
    if order in ("branches", "burst"):
        edges, ends, wide, ratio, golden = (
            [],
            [(np.zeros(3), np.array([0, 0, 1.0]), rng.uniform(0.2, 1.2))],
            rng.uniform(20, 60),
            rng.uniform(0.6, 0.85),
            rng.choice([360, 137.5]),
        )
        forks, levels = (int(rng.integers(5, 40)), 2) if order == "burst" else [(2, 4), (2, 5), (3, 3), (3, 4)][rng.integers(4)]
        for level in range(levels):
            tips, first = [(at + way * long, way, long) for at, way, long in ends], 90 * level + rng.uniform(0, 180) * kit.chance(0.6)
            edges, ends = edges + [(at, tip) for (at, *_), (tip, *_) in zip(ends, tips, strict=True)], []
            for (tip, way, long), k in [(tip, k) for tip in tips for k in range(forks)]:
                out = np.degrees(np.arccos(1 - (1 - np.cos(np.radians(3 * wide))) * (k + 0.5) / forks)) if order == "burst" else wide * rng.uniform(0.7, 1.2)
                spin = towards(way) @ turn("z", first + (golden * k if order == "burst" and golden < 360 else 360 * k / forks)) @ turn("y", out)
                ends.append((tip, spin[:, 2], rng.uniform(0.6, 1) if order == "burst" else long * ratio * rng.uniform(0.8, 1.15)))
        return edges
    if order == "tubes":
        count, curved = int(rng.integers(4, 12)), kit.chance(0.5)
        points, way, flip = [np.array([rng.normal(0, 0.5), rng.uniform(0.2, 0.7), 0])], np.array([0, 0, 1.0]), np.array([1, -1, 1])
        for _ in range(count):
            points.append(points[-1] + way * rng.uniform(0.2, 0.9) * (0.5 if curved else 1))
            way = way + rng.normal(0, 0.5, 3) if curved else np.roll([rng.choice([-1.0, 1]), 0, 0], rng.integers(3))
            way = (way if points[-1][1] > 0.25 else np.abs(way)) / np.linalg.norm(way)
        ties = [(points[k], points[k] * flip) for k in (-1, *rng.choice(count, 3, replace=False))]
        return [*pairwise(points), *((a * flip, b * flip) for a, b in pairwise(points)), *ties]
    if order == "posts":
        count, high, ring = int(rng.integers(3, 7)), rng.uniform(0.4, 1.8) * np.array([0, 0, 1]), kit.chance(0.35)
        feet = [np.array([x, y, 0]) for x, y in around(count, 0.8)] if ring else list(np.linspace([-0.8, 0, 0], [0.8, 0, 0], count))
        wires, sag, arm = int(rng.integers(1, 4)), rng.choice([0, rng.uniform(0, 0.35)]) * high, np.array([0, rng.uniform(0, 0.4) * (not ring and kit.chance(0.5)), 0])
        edges = [(f, f + high) for f in feet] + list(pairwise(feet))
        for (a, b), k in [(pair, k) for pair in pairwise(feet + feet[:1] * ring) for k in range(wires)]:
            top = high * (1 if arm.any() else 1 - 0.3 * k) + arm * (k - (wires - 1) / 2)
            edges += [(a + top, (a + b) / 2 + top - sag), ((a + b) / 2 + top - sag, b + top)]
        return edges + [(f + high - arm * 1.1, f + high + arm * 1.1) for f in feet if arm.any()]
    count, number = int(rng.integers(3, 11)), int(rng.choice([1, 2, 2, 3, 4]))
    wide, look, kind, droop, turning = rng.uniform(0.1, 0.4), kit.material(), int(rng.choice([BOX, BALL, CYL])), rng.uniform(-30, 60), rng.choice([0, 90, 137.5])
    points, thin, small = (
        np.linspace(0, 1, count + 1)[:, None] ** [2, 1, 1] * [rng.choice([0, rng.uniform(-1, 1)]), 0, 1.6],
        rng.uniform(0.01, 0.05),
        rng.uniform(0.2, 0.7),
    )
    for k, j in np.ndindex(count, number):
        spin, size = turn("z", 90 + turning * k + 360 * j / number) @ turn("y", -droop), wide * (1 - small * k / count)
        kit.add(kind, points[k + 1] + spin[:, 0] * size * 0.98, (size, size * 0.45, thin), rotation=spin, material=look)
    return list(pairwise(points))


def framework(kit):
    """Slender things: cages, trusses, branches, bent tubes, bursts of rods, posts with wires, stems with plates; in half of them solid bodies."""
    rng, mats = kit.rng, palette(kit)
    make = rng.choice(["cage", "cage", "cage", "branches", "tubes", "tubes", "burst", "posts", "stem"])
    edges = skeleton(kit, make)[: PRIMS - 14 - len(kit.primitives)]
    nodes = np.array(edges).reshape(-1, 3)
    low, high = nodes.min(0), nodes.max(0)
    size, middle, span = np.linalg.norm(high - low), (low + high) / 2 * [1, 1, 0], (high - low)[:2] / 2
    thick, square, blend = size * np.exp(rng.uniform(-5, -3.1)), kit.chance(0.4) and make != "tubes", kit.chance(0.4)
    radii = thick * (2.2 * np.maximum(rng.uniform(0.93, 1) ** np.arange(len(edges)), 0.3) if make == "branches" else np.ones(len(edges)))
    for k, (a, b) in enumerate(edges):
        kit.between(a, b, (radii[k], radii[k] * 1.01), BOX if square else CYL, material=mats[k * len(mats) // len(edges) * blend])
    if make in ("tubes", "branches") or kit.chance(0.3):
        tips = {tuple(np.round(b, 6)) for _, b in edges} - ({tuple(np.round(a, 6)) for a, _ in edges} if make in ("branches", "burst") else set())
        bead = thick * (1.03 if make == "tubes" else np.exp(rng.uniform(0.1, 1.8)))
        for tip in sorted(tips)[: PRIMS - 12 - len(kit.primitives)]:
            kit.add(BOX if square else BALL, tip, (bead,) * 3, material=mats[0 if make == "tubes" else -1])
    for _ in range(int(rng.integers(1, 3)) * kit.chance(0.5)):
        kind = int(rng.choice([BOX, CYL, BALL, PRISM]))
        kit.add(kind, nodes[rng.integers(len(nodes))], size * np.exp(rng.normal(-2.2, 0.4, 3)), tapers(kit, kind), material=pick(kit, mats))
    for z in [low[2] - thick] * kit.chance(0.5) + [high[2]] * (make == "cage" and kit.chance(0.3)):
        kit.add(
            BOX if z > low[2] else int(rng.choice([BOX, CYL])), middle + [0, 0, z], (*np.maximum(span * 1.1, size * 0.1), thick * rng.uniform(1, 2.5)), material=mats[-1]
        )
    settle(kit, mats)
