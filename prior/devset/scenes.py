"""Mitsuba scenes of one subject: before a plain background, outdoors among other things, and alone."""

import math

import fetch
import mitsuba as mi
import models
import numpy as np
from PIL import Image

TRANSFORM = mi.ScalarTransform4f
# Things that stand around outdoors, with their heights in metres. None of them is a subject.
TREES = [
    (
        "0ad:art/meshes/gaia/fir_tree_tall_3.dae.cached.pmd",
        "0ad:art/textures/skins/gaia/tree_fir_tall_1.png.cached.dds",
        9,
    )
]
HOUSES = [("fg:Buildings/renovated-apartment.ac", None), ("fg:Residential/Detached-1.ac", None),
          ("fg:Buildings/red-barn.ac", None), ("fg:Residential/germansemidetached1.ac", None)]  # fmt: skip
SCOPIA, KATOR = "sh3d:Scopia/scopia", "sh3d:KatorLegaz/katorlegaz"
VEHICLES = [(f"{SCOPIA}/peugeot-308/peugeot-308.obj", 1.4), (f"{SCOPIA}/renault-scenic/renault-scenic.obj", 1.6),
            (f"{KATOR}/VW-new-beetle/VW-new-beetle.obj", 1.5), (f"{SCOPIA}/truck/truck.obj", 3.4)]  # fmt: skip
STREET = [(f"{KATOR}/fire-hydrant/fire-hydrant.obj", 0.8), (f"{KATOR}/park-light/park-light.obj", 3.0),
          (f"{KATOR}/painted-bench/painted-bench.obj", 0.9), (f"{KATOR}/recycling-bin/recycling-bin.obj", 1.0),
          (f"{SCOPIA}/ficus/ficus.obj", 1.4), (f"{KATOR}/male-01-suit/male-01-suit.obj", 1.8)]  # fmt: skip
TERRAIN = "0ad:art/textures/terrain/types/aegean_anatolia"
GROUNDS = [f"{TERRAIN}/{n}.png.cached.dds" for n in ("grass_01", "paving_01", "dirt_01", "grass_dirt_02", "paving_02")]


def bitmap(array, raw):
    return {"type": "bitmap", "bitmap": mi.Bitmap(np.array(array, order="C")), "raw": raw}


def shader(part, opaque=False):
    """BSDF of a part; glass never lets through more than 40 %, so that it stays part of the subject."""
    if part.texture is not None and part.uv is not None:
        rgba = np.asarray(Image.open(part.texture).convert("RGBA")).astype(np.float32) / 255
        tint = np.array(part.colour, np.float32)
        base = bitmap((rgba[..., :3] * tint * 255).clip(0, 255).astype(np.uint8), False)
    else:
        rgba = None
        srgb = np.clip(np.array(part.colour, np.float64), 0, 1)
        linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
        base = {"type": "rgb", "value": [float(x) for x in 0.02 + 0.9 * linear]}
    if part.gloss > 0.03:
        surface = {"type": "principled", "base_color": base, "roughness": 0.75 - 0.6 * part.gloss, "specular": 0.4}
    else:
        surface = {"type": "diffuse", "reflectance": base}
    surface = {"type": "twosided", "bsdf": surface}
    if part.cutout and rgba is not None:
        alpha = ((rgba[..., 3:] > 0.4) * 255).astype(np.uint8)
        return {"type": "mask", "opacity": bitmap(alpha, True), "bsdf": surface}
    if part.opacity < 0.95 and not opaque:
        return {"type": "mask", "opacity": max(0.6, part.opacity), "bsdf": surface}
    return surface


def shapes(parts, prefix, shift=(0, 0, 0), opaque=False):
    """Mitsuba objects of parts, moved by shift."""
    found = {}
    for i, part in enumerate(parts):
        has_uv = part.uv is not None
        properties = mi.Properties()
        properties["bsdf"] = mi.load_dict(shader(part, opaque))
        mesh = mi.Mesh(f"{prefix}{i}", len(part.points), len(part.faces), properties, True, has_uv)
        values = mi.traverse(mesh)
        values["vertex_positions"] = (part.points + np.array(shift)).astype(np.float32).ravel()
        values["vertex_normals"] = part.normals.astype(np.float32).ravel()
        if has_uv:
            values["vertex_texcoords"] = (part.uv * [1, -1] + [0, 1]).astype(np.float32).ravel()
        values["faces"] = part.faces.astype(np.uint32).ravel()
        values.update()
        found[f"{prefix}{i}"] = mesh
    return found


def direction(azimuth, elevation):
    a, e = math.radians(azimuth), math.radians(elevation)
    return np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])


def base_scene(hide_emitters, subject):
    """Light is followed for five surfaces; through a subject of cut-out leaves for more, for a hole counts as one too."""
    most = 64 if any(part.cutout for part in subject) else 5
    return {"type": "scene", "integrator": {"type": "path", "max_depth": most, "hide_emitters": hide_emitters}}


def studio(radius, centre, photo_azimuth, side, level):
    """Soft light from all around and a large lamp beside the camera."""
    lamp = centre + direction(photo_azimuth + side, 48) * radius * 14
    to_world = TRANSFORM().look_at(origin=lamp.tolist(), target=centre.tolist(), up=[0, 0, 1])
    to_world = to_world @ TRANSFORM().scale([radius * 2.5, radius * 2.5, 1])
    return {
        "sky": {"type": "constant", "radiance": {"type": "rgb", "value": [level * x for x in (0.55, 0.56, 0.58)]}},
        "lamp": {
            "type": "rectangle",
            "to_world": to_world,
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": [level * x for x in (16, 15.4, 14.6)]}},
        },
    }


def plane(to_world, reflectance):
    surface = {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": reflectance}}
    return {"type": "rectangle", "to_world": to_world, "bsdf": surface}


def plain_scene(subject, radius, centre, photo_azimuth, side, rng, aloft=None):
    """The subject on a floor before a wall of one colour, as in a studio; `aloft`: before one grey, nothing around it."""
    shade = rng.uniform(0.5, 0.85)
    colour = {"type": "rgb", "value": [float(shade * x) for x in rng.uniform(0.94, 1.0, 3)]}
    back = -direction(photo_azimuth, 0) * radius * 7
    wall = TRANSFORM().look_at(origin=back.tolist(), target=[0, 0, 0], up=[0, 0, 1]) @ TRANSFORM().scale(radius * 60)
    scene = base_scene(False, subject) | studio(radius, centre, photo_azimuth, side, 1.0)
    if aloft is None:
        scene["floor"] = plane(TRANSFORM().scale(radius * 60), colour)
        scene["wall"] = plane(wall, colour)
    return scene | shapes(subject, "subject")


def alone_scene(subject, radius, centre, photo_azimuth, side, opaque=False):
    """The subject in the light of plain_scene, with nothing around: what the truth views show."""
    scene = base_scene(True, subject) | studio(radius, centre, photo_azimuth, side, 1.0)
    return scene | shapes(subject, "subject", opaque=opaque)


def clutter(src, rng, radius, photo_azimuth):
    """Things behind and beside the subject: (parts, shift) each, never between it and the camera."""
    toward = direction(photo_azimuth, 0)
    right = np.array([-toward[1], toward[0], 0])
    near = [*STREET, *(VEHICLES if radius > 1 else [])]
    chosen = [near[i] + ("near",) for i in rng.choice(len(near), 4, replace=False)]
    chosen += [HOUSES[i] + ("far",) for i in rng.choice(len(HOUSES), 3, replace=False)]
    chosen += [(TREES[0], TREES[0][2] * rng.uniform(0.6, 1.3), "far") for _ in range(6)]
    taken = []
    for item, height, where in chosen:
        options = {}
        if isinstance(item, tuple):
            options = {"texture": fetch.resolve(item[1], src), "cutout": True}
            item = item[0]
        parts = models.load(fetch.resolve(item, src), **options)
        size = models.stand(parts, height, rng.uniform(0, 360))
        own = float(np.linalg.norm(size[:2]) / 2)
        for _ in range(50):
            if where == "near":
                depth = rng.uniform(0.2, 2.5) * max(radius, 1.5) + own
                across = rng.uniform(-1, 1) * (radius * 2 + depth * 0.5)
            else:
                depth = rng.uniform(5, 12) * max(radius, 4) + own
                across = rng.uniform(-1, 1) * (depth * 0.6 + radius * 2)
            place = -toward * depth + right * across
            clear = all(np.linalg.norm(place - q) > own + r for q, r in [*taken, (np.zeros(3), radius * 1.05)])
            if clear:
                taken.append((place, own))
                yield parts, place
                break


def outdoor_scene(subject, radius, centre, photo_azimuth, rng, src, aloft=None):
    """The subject on open ground under sun and sky, with houses, trees, cars or street furniture behind; `aloft`: so many metres
    above the ground, with nothing around it."""
    sun = direction(photo_azimuth + rng.uniform(25, 85) * rng.choice([-1, 1]), rng.uniform(28, 55))
    scene = base_scene(False, subject)
    sky = {"type": "sunsky", "sun_direction": sun.tolist(), "turbidity": float(rng.uniform(2.5, 5)), "sun_scale": 0.35}
    scene["sky"] = sky
    ground = np.asarray(Image.open(fetch.resolve(str(rng.choice(GROUNDS)), src)).convert("RGB"))
    reach = 20000.0
    tile = float(np.clip(radius * 1.2, 1.0, 5.0))
    texture = bitmap(ground, False) | {"to_uv": TRANSFORM().scale([2 * reach / tile, 2 * reach / tile, 1])}
    scene["floor"] = plane(TRANSFORM().translate([0, 0, -(aloft or 0)]).scale(reach), texture)
    if aloft is not None:
        return scene | shapes(subject, "subject")
    for i, (parts, place) in enumerate(clutter(src, rng, radius, photo_azimuth)):
        scene |= shapes(parts, f"clutter{i}_", place)
    return scene | shapes(subject, "subject")
