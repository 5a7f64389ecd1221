"""Render the development set: photos, masks and truth views of artist-made models, with their cameras.

    python render.py SRC_DIR OUT_DIR [NAME ...] [--preview] [--above SET_DIR | --below SET_DIR]

OUT_DIR/NAME/ gets photo_plain.jpg, photo_outdoor.jpg, mask.png (512 x 512), gt/00.png .. 23.png (RGBA, 256 x 256, not
premultiplied), mesh.glb (metres, Y up) and cameras.json as ../evaluate.py reads it. Path tracing by Mitsuba 3 on the
CPU; the same name gives the same picture. --preview draws only a small sheet of every object. --above takes the photos
as a drone would, from 50 to 88 degrees above the horizon, in the light that the truth views of SET_DIR have, which is a
set as this program makes it without --above; those views and the mesh are copied from there. --below does the same from 22
to 60 degrees below: the subject is in the air, with nothing but the sky, or one grey, behind it, and sunny ground far below.
"""

import argparse
import hashlib
import json
import math
import shutil
import time
from pathlib import Path

import mitsuba as mi
import numpy as np
import oidn

mi.set_variant("llvm_ad_rgb")

import fetch
import models
import scenes
from PIL import Image

HERE = Path(__file__).parent
PHOTO, TRUTH = 512, 256
PHOTO_SAMPLES, TRUTH_SAMPLES, MASK_SAMPLES = 64, 24, 16
# Elevations of --above and --below, degrees.
ABOVE, BELOW = (50, 88), (-60, -22)


def camera(centre, azimuth, elevation, distance, fov, size):
    """Mitsuba's sensor and the entry for cameras.json, OpenCV world -> camera."""
    eye = centre + scenes.direction(azimuth, elevation) * distance
    forward = (centre - eye) / distance
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    rotation = np.stack([right, np.cross(forward, right), forward])
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, -rotation @ eye
    focal = size / 2 / math.tan(math.radians(fov) / 2)
    entry = {"width": size, "height": size, "fx": focal, "fy": focal, "cx": size / 2, "cy": size / 2}
    entry |= {"azimuth_deg": azimuth % 360, "elevation_deg": elevation, "distance_m": distance}
    entry["w2c_opencv"] = matrix.tolist()
    to_world = scenes.TRANSFORM().look_at(origin=eye.tolist(), target=centre.tolist(), up=[0, 0, 1])
    return to_world, entry


def sensor(to_world, fov, size):
    film = {"type": "hdrfilm", "width": size, "height": size, "pixel_format": "rgba", "rfilter": {"type": "box"}}
    return mi.load_dict(
        {"type": "perspective", "fov": fov, "near_clip": 0.01, "far_clip": 1e5, "to_world": to_world, "film": film}
    )


def picture(scene, sensor_, samples, seed):
    """Linear RGB, not premultiplied, and coverage."""
    rgba = np.array(mi.render(scene, sensor=sensor_, spp=samples, seed=seed), dtype=np.float64)
    rgba = np.nan_to_num(rgba, nan=0.0, posinf=0.0)
    alpha = rgba[..., 3].clip(0, 1)
    return denoised(rgba[..., :3].clip(0, 30)) / np.maximum(alpha, 1e-3)[..., None], alpha


def denoised(linear):
    """Intel Open Image Denoise on the colours alone, brought to 0..1 and back by x / (1 + x)."""
    source = np.ascontiguousarray(linear / (1 + linear), np.float32)
    result = np.zeros_like(source)
    height, width = source.shape[:2]
    device = oidn.NewDevice()
    oidn.CommitDevice(device)
    filter_ = oidn.NewFilter(device, "RT")
    oidn.SetSharedFilterImage(filter_, "color", source, oidn.FORMAT_FLOAT3, width, height)
    oidn.SetSharedFilterImage(filter_, "output", result, oidn.FORMAT_FLOAT3, width, height)
    oidn.CommitFilter(filter_)
    oidn.ExecuteFilter(filter_)
    oidn.ReleaseFilter(filter_)
    oidn.ReleaseDevice(device)
    result = result.clip(0, 0.97).astype(np.float64)
    return result / (1 - result)


def srgb8(linear):
    x = np.clip(linear, 0, 1)
    return (np.where(x <= 0.0031308, x * 12.92, 1.055 * x ** (1 / 2.4) - 0.055) * 255 + 0.5).astype(np.uint8)


def brightness(linear, mask):
    """Mean of the subject's pixels, the brightest two per cent left out."""
    values = np.sort(linear[mask > 0.9].mean(1))
    return values[: max(1, int(len(values) * 0.98))].mean()


def read_object(name, about, src):
    options = {k: about[k] for k in ("skip", "rotor_blades", "cutout") if k in about}
    if "texture" in about:
        options["texture"] = fetch.resolve(about["texture"], src)
    parts = models.load(fetch.resolve(about["file"], src), **options)
    size = models.stand(parts, about.get("height"), about.get("turn", 0))
    return parts, size


def write_mesh(parts, path):
    import trimesh

    scene = trimesh.Scene()
    for i, part in enumerate(parts):
        y_up = lambda a: np.stack([a[:, 0], a[:, 2], -a[:, 1]], 1)
        colour = [*(int(255 * c) for c in np.clip(part.colour, 0, 1)), 255]
        mesh = trimesh.Trimesh(y_up(part.points), part.faces, vertex_normals=y_up(part.normals), process=False)
        mesh.visual.vertex_colors = np.tile(np.array(colour, np.uint8), (len(part.points), 1))
        scene.add_geometry(mesh, f"part{i}")
    path.write_bytes(scene.export(file_type="glb"))


def render_object(name, about, src, out, level_set=None, span=ABOVE):
    """`level_set`: where the truth views are taken from; the photos' elevation lies in `span`, degrees, then."""
    parts, size = read_object(name, about, src)
    radius, centre = float(np.linalg.norm(size) / 2), np.array([0, 0, size[2] / 2])
    rng = np.random.default_rng(int.from_bytes(hashlib.sha256(name.encode()).digest()[:4], "little"))
    azimuth, fov = about["azimuth"], about["fov"]
    side = float(rng.choice([-1, 1]) * rng.uniform(35, 60))
    distance = radius / math.sin(math.radians(fov) / 2) * float(rng.uniform(0.95, 1.15))
    level, entry = camera(centre, azimuth, about["elevation"], distance, fov, PHOTO)
    world = level
    if level_set:
        digest = hashlib.sha256(name.encode()).digest()[4:8]
        steep = float(np.random.default_rng(int.from_bytes(digest, "little")).uniform(*span))
        world, entry = camera(centre, azimuth, steep, distance, fov, PHOTO)
    entry |= {"group": "photo", "azimuth_rel_photo_deg": 0}
    folder = out / name
    (folder / "gt").mkdir(parents=True, exist_ok=True)
    eye, level_eye = sensor(world, fov, PHOTO), sensor(level, fov, PHOTO)

    opaque = mi.load_dict(scenes.alone_scene(parts, radius, centre, azimuth, side, opaque=True))
    _, mask = picture(opaque, eye, MASK_SAMPLES, 1)
    Image.fromarray((mask * 255 + 0.5).astype(np.uint8)).save(folder / "mask.png")
    level_mask = picture(opaque, level_eye, MASK_SAMPLES, 1)[1] if level_set else mask
    del opaque

    aloft = 2 * distance if span == BELOW else None
    plain = mi.load_dict(scenes.plain_scene(parts, radius, centre, azimuth, side, rng, aloft))
    linear, _ = picture(plain, eye, PHOTO_SAMPLES, 2)
    seen = picture(plain, level_eye, PHOTO_SAMPLES, 2)[0] if level_set else linear
    exposure = 0.9 / max(np.percentile(seen[level_mask > 0.9].max(1), 97), np.percentile(seen.max(-1), 85))
    subject = brightness(linear, mask) * exposure
    Image.fromarray(srgb8(linear * exposure)).save(folder / "photo_plain.jpg", quality=93)
    del plain

    outdoor = mi.load_dict(scenes.outdoor_scene(parts, radius, centre, azimuth, rng, src, aloft))
    linear, _ = picture(outdoor, eye, PHOTO_SAMPLES, 3)
    # As bright as in the plain photo, so that the truth views fit both; but no burnt surroundings.
    gain = min(subject / brightness(linear, mask), 0.65 / np.median(linear.max(-1)))
    Image.fromarray(srgb8(linear * gain)).save(folder / "photo_outdoor.jpg", quality=93)
    del outdoor

    views = [
        {"name": "mask", "file": "mask.png"} | entry,
        {"name": "plain", "file": "photo_plain.jpg"} | entry,
        {"name": "outdoor", "file": "photo_outdoor.jpg"} | entry,
    ]
    about_set = {"name": name, "size_m": size.tolist(), "fov_x_deg": fov, "photo_azimuth_deg": azimuth}
    about_set["world"] = "Z up, metres; the model is centred on x = y = 0 and stands on z = 0"
    if level_set:
        known = json.loads((level_set / name / "cameras.json").read_text())["views"]
        truth = [v for v in known if v["group"] == "gt"]
        for file in ["mesh.glb", *(v["file"] for v in truth)]:
            shutil.copyfile(level_set / name / file, folder / file)
        (folder / "cameras.json").write_text(json.dumps(about_set | {"views": views + truth}, indent=1))
        return
    alone = mi.load_dict(scenes.alone_scene(parts, radius, centre, azimuth, side))
    away = radius / math.sin(math.radians(20)) * 1.04
    for i in range(24):
        elevation = (8.0, 32.0)[i // 12]
        around = i % 12 * 30.0 + (15.0 if i >= 12 else 0.0)
        world, view = camera(centre, azimuth + around, elevation, away, 40, TRUTH)
        linear, alpha = picture(alone, sensor(world, 40, TRUTH), TRUTH_SAMPLES, 10 + i)
        rgba = np.dstack([srgb8(linear * exposure), (alpha * 255 + 0.5).astype(np.uint8)])
        rgba[alpha < 0.002] = 0
        file = f"gt/{i:02}.png"
        Image.fromarray(rgba).save(folder / file)
        views.append({"name": f"gt{i:02}", "file": file, "group": "gt", "azimuth_rel_photo_deg": around} | view)
    (folder / "cameras.json").write_text(json.dumps(about_set | {"views": views}, indent=1))
    write_mesh(parts, folder / "mesh.glb")


def preview(objects, src, out):
    """Every object small, from its photo's camera and from behind."""
    sheet = Image.new("RGB", (160 * 6, 320 * -(-len(objects) // 6)), "white")
    for i, (name, about) in enumerate(objects.items()):
        parts, size = read_object(name, about, src)
        radius, centre = float(np.linalg.norm(size) / 2), np.array([0, 0, size[2] / 2])
        scene = mi.load_dict(scenes.alone_scene(parts, radius, centre, about["azimuth"], 45))
        for row, turn in enumerate((0, 180)):
            distance = radius / math.sin(math.radians(20))
            world, _ = camera(centre, about["azimuth"] + turn, about["elevation"], distance, 40, 160)
            linear, alpha = picture(scene, sensor(world, 40, 160), 16, 1)
            tile = srgb8(linear * alpha[..., None] + 1 - alpha[..., None])
            sheet.paste(Image.fromarray(tile), (i % 6 * 160, i // 6 * 320 + row * 160))
        print(name, "size", size.round(2), "faces", sum(len(p.faces) for p in parts), flush=True)
    sheet.save(out / "preview.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("src", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--preview", action="store_true")
    parser.add_argument("--above", type=Path, metavar="SET_DIR")
    parser.add_argument("--below", type=Path, metavar="SET_DIR")
    args = parser.parse_args()
    if args.above and args.below:
        parser.error("--above or --below, not both")
    objects = json.loads((HERE / "objects.json").read_text())["objects"]
    objects = {n: objects[n] for n in args.names or objects}
    args.out.mkdir(parents=True, exist_ok=True)
    if args.preview:
        preview(objects, args.src, args.out)
        return
    for name, about in objects.items():
        start = time.time()
        render_object(name, about, args.src, args.out, args.above or args.below, BELOW if args.below else ABOVE)
        print(name, f"{time.time() - start:.0f} s", flush=True)


if __name__ == "__main__":
    main()
