"""Read artist-made models of several formats as triangle parts with one material each.

`load(path)` reads OBJ, AC3D, GLB, 0 A.D. PMD and Search and Rescue 3D files. The result's frame is Z up.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass
class Part:
    """Triangles of one material: points [n, 3], normals [n, 3] or None, uv [n, 2] or None (v up), faces [m, 3]."""

    points: np.ndarray
    faces: np.ndarray
    normals: np.ndarray | None = None
    uv: np.ndarray | None = None
    colour: tuple = (0.8, 0.8, 0.8)  # sRGB; tints the texture
    texture: Path | None = None
    cutout: bool = False  # the texture's alpha cuts holes (leaves, fences)
    opacity: float = 1.0
    gloss: float = 0.0  # 0 matt .. 1 polished


def triangulate(corners):
    """A polygon's corner list -> triangles as a fan."""
    return [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]


def from_corners(triangles, **material):
    """Part from [(point, normal or None, uv or None) x 3] triangles."""
    flat = [corner for triangle in triangles for corner in triangle]
    points = np.array([c[0] for c in flat], np.float64)
    normals = np.array([c[1] for c in flat], np.float64) if all(c[1] is not None for c in flat) else None
    uv = np.array([c[2] for c in flat], np.float64) if all(c[2] is not None for c in flat) else None
    return Part(points, np.arange(len(flat)).reshape(-1, 3), normals, uv, **material)


def y_up_to_z_up(part):
    for name in ("points", "normals"):
        a = getattr(part, name)
        if a is not None:
            setattr(part, name, np.stack([a[:, 0], -a[:, 2], a[:, 1]], 1))
    return part


def read_mtl(path):
    materials, current = {}, None
    for line in path.read_text(errors="replace").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "newmtl":
            current = materials.setdefault(line.split(None, 1)[1].strip(), {})
        elif current is None:
            continue
        elif words[0] == "Kd":
            current["colour"] = tuple(float(w) for w in words[1:4])
        elif words[0] == "Ks":
            current["specular"] = max(float(w) for w in words[1:4])
        elif words[0] == "Ns":
            current["shininess"] = float(words[1])
        elif words[0] == "d":
            current["opacity"] = float(words[1])
        elif words[0] == "map_Kd":
            file = path.parent / line.split(None, 1)[1].strip().split("/")[-1]
            if file.exists():
                current["texture"] = file
    for m in materials.values():
        shine = m.pop("shininess", 0)
        m["gloss"] = min(1.0, shine / 200) * min(1.0, m.pop("specular", 0) * 1.5)
    return materials


def load_obj(path):
    points, uvs, normals, groups, materials, name = [], [], [], {}, {}, None
    for line in path.read_text(errors="replace").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "v":
            points.append([float(w) for w in words[1:4]])
        elif words[0] == "vt":
            uvs.append([float(w) for w in words[1:3]])
        elif words[0] == "vn":
            normals.append([float(w) for w in words[1:4]])
        elif words[0] == "mtllib":
            materials |= read_mtl(path.parent / line.split(None, 1)[1].strip())
        elif words[0] == "usemtl":
            name = line.split(None, 1)[1].strip()
        elif words[0] == "f":
            corners = []
            for word in words[1:]:
                v, t, n = (word.split("/") + ["", ""])[:3]
                corners.append(
                    (
                        points[int(v) - (int(v) > 0)],
                        normals[int(n) - (int(n) > 0)] if n else None,
                        uvs[int(t) - (int(t) > 0)] if t and int(t) <= len(uvs) else None,
                    )
                )
            groups.setdefault(name, []).extend(triangulate(corners))
    return [y_up_to_z_up(from_corners(t, **materials.get(n, {}))) for n, t in groups.items()]


def ac3d_material(line):
    """A MATERIAL line: "name" rgb r g b amb … spec r g b shi n trans t."""
    numbers = line[line.index(" rgb ") :].split()

    def take(key, count):
        at = numbers.index(key) + 1
        return tuple(float(x) for x in numbers[at : at + count])

    gloss = min(1.0, max(take("spec", 3)) * take("shi", 1)[0] / 100)
    return {"colour": take("rgb", 3), "opacity": 1 - take("trans", 1)[0], "gloss": gloss}


def load_ac3d(path, skip=()):
    """AC3D text (http://www.inivis.com/ac3d/man/ac3dfileformat.html); `skip`: name parts of objects to leave out."""
    lines = iter(path.read_text(errors="replace").splitlines())
    next(lines)
    materials, groups = [], {}

    def read_object(origin, rotation, skipped):
        texture, name, points, repeat = None, "", [], (1.0, 1.0)
        for line in lines:
            words = line.split()
            if not words:
                continue
            if words[0] == "name":
                name = line.split(None, 1)[1].strip('" ')
                skipped = skipped or any(s.lower() in name.lower() for s in skip)
            elif words[0] == "data":
                remaining = int(words[1])
                while remaining > 0:
                    remaining -= len(next(lines)) + 1
            elif words[0] == "texture":
                texture = line.split(None, 1)[1].strip('" ').split("/")[-1]
            elif words[0] == "texrep":
                repeat = (float(words[1]), float(words[2]))
            elif words[0] == "loc":
                origin = origin + rotation @ np.array([float(w) for w in words[1:4]])
            elif words[0] == "rot":
                rotation = rotation @ np.array([float(w) for w in words[1:10]]).reshape(3, 3).T
            elif words[0] == "numvert":
                local = np.array([[float(w) for w in next(lines).split()[:3]] for _ in range(int(words[1]))])
                points = local @ rotation.T + origin if len(local) else local
            elif words[0] == "SURF":
                flags, material, corners = int(words[1], 16), 0, []
                for line in lines:
                    words = line.split()
                    if words[0] == "mat":
                        material = int(words[1])
                    elif words[0] == "refs":
                        for _ in range(int(words[1])):
                            ref = next(lines).split()
                            uv = [float(ref[1]) * repeat[0], float(ref[2]) * repeat[1]]
                            corners.append((points[int(ref[0])], None, uv))
                        break
                if flags & 15 == 0 and len(corners) >= 3 and not skipped:
                    groups.setdefault((material, texture), []).extend(triangulate(corners))
            elif words[0] == "kids":
                for _ in range(int(words[1])):
                    next(lines)  # OBJECT
                    read_object(origin, rotation, skipped)
                return

    for line in lines:
        words = line.split()
        if words and words[0] == "MATERIAL":
            materials.append(ac3d_material(line))
        elif words and words[0] == "OBJECT":
            read_object(np.zeros(3), np.eye(3), False)
    parts = []
    for (material, texture), triangles in groups.items():
        file = path.parent / texture if texture else None
        file = file if file is not None and file.exists() else None
        parts.append(y_up_to_z_up(from_corners(triangles, texture=file, **materials[material])))
    return parts


def load_pmd(path, texture, cutout=False):
    """A 0 A.D. mesh (PSMD 3 and 4); the texture is named by the game's actor files."""
    data = path.read_bytes()
    if data[:4] != b"PSMD":
        raise ValueError(f"{path}: not a PMD file")
    version, _, count = np.frombuffer(data, "<u4", 3, 4)
    sets, at = (int(np.frombuffer(data, "<u4", 1, 16)[0]), 20) if version >= 4 else (1, 16)
    stride = 24 + 8 * sets + 20
    vertices = np.frombuffer(data, np.uint8, count * stride, at).reshape(count, stride)
    floats = vertices[:, : 24 + 8 * sets].copy().view("<f4").astype(np.float64)
    at += int(count) * stride
    faces = int(np.frombuffer(data, "<u4", 1, at)[0])
    indices = np.frombuffer(data, "<u2", faces * 3, at + 4).reshape(-1, 3).astype(np.int64)
    part = Part(floats[:, :3], indices, floats[:, 3:6], floats[:, 6:8])
    part.colour, part.texture, part.cutout = (1, 1, 1), Path(texture), cutout
    return [y_up_to_z_up(part)]


def load_sar(path, rotor_blades):
    """The standard model of a Search and Rescue 3D file and its rotors, each with rotor_blades[i] blades at rest."""
    from math import cos, radians, sin

    textures, groups, rotors = {}, {}, -1
    wanted, colour, texture, orient, shift, turn = False, (1, 1, 1), None, None, np.zeros(3), np.eye(3)
    mode, normal, corners, blades = None, None, [], 1
    base = path.parent.parent

    def emit():
        if mode == "quads":
            polygons = [corners[i : i + 4] for i in range(0, len(corners) - 3, 4)]
        elif mode == "triangles":
            polygons = [corners[i : i + 3] for i in range(0, len(corners) - 2, 3)]
        elif mode == "triangle_fan":
            polygons = [corners]
        else:
            return
        for polygon in polygons:
            for blade in range(blades):
                a = 2 * np.pi * blade / blades + (0.4 if blades > 1 else 0)
                spin = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
                placed = [(turn @ spin @ p + shift, None if n is None else turn @ spin @ n, t) for p, n, t in polygon]
                groups.setdefault((colour, texture), []).extend(triangulate(placed))

    for line in path.read_text(errors="replace").splitlines():
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        head = words[0]
        if head == "texture_load":
            textures[words[1]] = base / words[2]
        elif head == "rotor_new":
            rotors += 1
        elif head == "begin_model":
            wanted = words[1] in ("standard", "rotor", "landing_gear")
            blades = rotor_blades[rotors] if words[1] == "rotor" else 1
            wanted = wanted and blades > 0
            texture, orient, shift, turn = None, None, np.zeros(3), np.eye(3)
        elif not wanted:
            continue
        elif head == "end_model":
            wanted = False
        elif head == "color":
            colour = tuple(float(w) for w in words[1:4])
        elif head == "texture_select":
            texture = textures.get(words[1])
        elif head == "texture_off":
            texture = None
        elif head in ("texture_orient_yz", "texture_orient_xy"):
            orient = (head[-2:], *[float(w) for w in words[1:5]])
        elif head == "translate":
            shift = np.array([float(w) for w in words[1:4]])
        elif head == "rotate":
            h, p, b = (radians(float(w)) for w in words[1:4])
            about_z = np.array([[cos(-h), -sin(-h), 0], [sin(-h), cos(-h), 0], [0, 0, 1]])
            about_x = np.array([[1, 0, 0], [0, cos(-p), -sin(-p)], [0, sin(-p), cos(-p)]])
            about_y = np.array([[cos(b), 0, sin(b)], [0, 1, 0], [-sin(b), 0, cos(b)]])
            turn = about_z @ about_x @ about_y
        elif head.startswith("begin_"):
            mode, corners, normal = head[6:], [], None
        elif head.startswith("end_"):
            emit()
            mode = None
        elif head == "normal":
            normal = np.array([float(w) for w in words[1:4]])
        elif mode and len(words) >= 3:
            point = np.array([float(w) for w in words[:3]])
            uv = None
            if texture is not None and orient is not None:
                axes, u0, v0, du, dv = orient
                across, up = (point[1], point[2]) if axes == "yz" else (point[0], point[1])
                sign = -1 if axes == "yz" else 1
                uv = [sign * (across - u0) / du, (up - v0) / dv]
            corners.append((point, normal, uv))
    parts = []
    for (colour, texture), triangles in groups.items():
        part = from_corners(triangles, colour=colour, texture=texture)
        if part.uv is None:
            part.texture = None
        part.gloss = 0.2
        parts.append(part)
    return parts


def load_glb(path):
    """A glTF binary of the samples (Y up, metres)."""
    import tempfile

    import trimesh

    scene = trimesh.load(path, process=False)
    scene = scene if isinstance(scene, trimesh.Scene) else trimesh.Scene(scene)
    parts = []
    for mesh in scene.dump(concatenate=False):
        material = mesh.visual.material
        base = getattr(material, "baseColorFactor", None)
        base = np.array([255, 255, 255, 255] if base is None else base, np.float64)
        base = base / 255 if base.max() > 1 else base
        srgb = np.where(base <= 0.0031308, base * 12.92, 1.055 * base ** (1 / 2.4) - 0.055)
        part = Part(np.array(mesh.vertices), np.array(mesh.faces), np.array(mesh.vertex_normals))
        part.colour, part.opacity = tuple(srgb[:3]), float(base[3])
        image = getattr(material, "baseColorTexture", None)
        if image is not None and mesh.visual.uv is not None:
            file = Path(tempfile.mkdtemp()) / "texture.png"
            image.convert("RGB").save(file)
            part.texture, part.uv = file, np.array(mesh.visual.uv)
        part.gloss = max(0.0, 1 - float(getattr(material, "roughnessFactor", None) or 1))
        parts.append(y_up_to_z_up(part))
    return parts


def smooth_normals(part, crease_degrees=40):
    """Give a part without normals area-weighted ones, averaged where neighbouring faces meet at less than the crease."""
    if part.normals is not None:
        length = np.linalg.norm(part.normals, axis=1, keepdims=True)
        if (length > 1e-6).all():
            part.normals = part.normals / length
            return part
    corners = part.points[part.faces]
    face = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    part.points = corners.reshape(-1, 3)
    part.uv = part.uv[part.faces].reshape(-1, 2) if part.uv is not None else None
    part.faces = np.arange(len(part.points)).reshape(-1, 3)
    weighted = np.repeat(face, 3, 0)
    unit = weighted / np.maximum(np.linalg.norm(weighted, axis=1, keepdims=True), 1e-20)
    extent = np.ptp(part.points, axis=0).max()
    _, place = np.unique(np.round(part.points / extent * 1e5).astype(np.int64), axis=0, return_inverse=True)
    place = place.ravel()
    order = np.argsort(place, kind="stable")
    total, limit = weighted.copy(), np.cos(np.radians(crease_degrees))
    for step in range(1, 33):
        a, b = order[:-step], order[step:]
        same = place[a] == place[b]
        if not same.any():
            break
        a, b = a[same], b[same]
        near = (unit[a] * unit[b]).sum(1) > limit
        np.add.at(total, a[near], weighted[b[near]])
        np.add.at(total, b[near], weighted[a[near]])
    length = np.linalg.norm(total, axis=1, keepdims=True)
    part.normals = np.where(length > 1e-20, total / np.maximum(length, 1e-20), [0, 0, 1])
    return part


def load(path, **options):
    path = Path(path)
    readers = {".obj": load_obj, ".ac": load_ac3d, ".pmd": load_pmd, ".3d": load_sar, ".glb": load_glb}
    return [smooth_normals(part) for part in readers[path.suffix](path, **options) if len(part.faces)]


def stand(parts, height=None, turn_degrees=0):
    """Turn about Z, scale to `height` metres, centre on x = y = 0 and stand on z = 0, in place. Returns the size."""
    a = np.radians(turn_degrees)
    turn = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    for part in parts:
        part.points, part.normals = part.points @ turn.T, part.normals @ turn.T
    every = np.concatenate([p.points for p in parts])
    low, high = every.min(0), every.max(0)
    scale = 1.0 if height is None else height / (high[2] - low[2])
    origin = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    for part in parts:
        part.points = (part.points - origin) * scale
    return (high - low) * scale
