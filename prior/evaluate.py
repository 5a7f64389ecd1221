"""Score SceneNet and SplatNet on photographed objects with known truth.

    python evaluate.py DATA_DIR SCENE_WEIGHTS SPLAT_WEIGHTS [--sheet sheet.png]

Weights: .pt of a training, or .onnx. DATA_DIR/<name>/cameras.json lists `views`: those of group "photo" (the mask and the photos, each with its `file` or
else <view name>.jpg, the mask .png) and those of group "gt" (RGBA pictures from other sides). Cameras are OpenCV,
world -> camera, metres, Z up; the object stands on z = 0 and has the bounding box `size_m`.
`../samples/truth` holds such folders without other sides: there only masks and elevations are scored.
"""

import argparse
import ctypes
import json
import math
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
import torch
import torch.nn.functional as F
from PIL import Image

from nets import SceneNet, SplatNet, load_weights
from pictures import save_sheet
from synth.cameras import inverses, look_at, orbit

PHOTO = 512  # pixels; photos are read at this size
FROM_THE_AIR = 0.7  # radians; SceneNet learned up to 54 degrees
FROM_BELOW = -0.25  # radians; SceneNet learned down to -17 degrees
FILL = 0.88  # of the crop, by the longer side of the subject's bounding box
DEVICE = "cuda" if torch.cuda.is_available() else "cpu"
HERE = Path(__file__).parent


def picture(path, mode, size=None):
    """Read a picture as [channels, H, W] in 0..1."""
    image = Image.open(path).convert(mode)
    if size is not None:
        image = image.resize((size, size), Image.LANCZOS)
    return torch.from_numpy(np.asarray(image).astype(np.float32) / 255).to(DEVICE).permute(2, 0, 1)


def view_file(folder, view, suffix):
    return folder / view.get("file", view["name"] + suffix)


def true_mask(path):
    """Coverage [S, S]: the alpha channel, or the red one of an opaque picture."""
    rgba = picture(path, "RGBA", PHOTO)
    return rgba[3] if rgba[3].min() < 0.99 else rgba[0]


@torch.no_grad()
def look(net, photo):
    """SceneNet's mask of photo [3, S, S], as [S, S], the larger of what it finds with and without a mirrored margin,
    and what both say of the elevation [2, 2].

    The program does the same, looks again closer, and then sharpens the edge by colour; both are left out here.
    """
    wide = F.affine_grid(torch.tensor([[[1.35, 0, 0], [0, 1.35, 0]]], device=DEVICE), (1, 3, PHOTO, PHOTO), align_corners=False)
    margin = F.grid_sample(photo[None], wide, mode="bilinear", padding_mode="reflection", align_corners=False)
    small = F.interpolate(torch.cat([photo[None], margin]), size=SceneNet.SIZE, mode="area")
    logits, _, elevation, _ = net(F.pad(small, (0, 0, 0, 0, 0, 1)))
    masks = F.interpolate(torch.sigmoid(logits), size=PHOTO, mode="bilinear")
    back = F.affine_grid(torch.tensor([[[1 / 1.35, 0, 0], [0, 1 / 1.35, 0]]], device=DEVICE), (1, 1, PHOTO, PHOTO), align_corners=False)
    inner = F.grid_sample(masks[1:], back, mode="bilinear", align_corners=False)
    return torch.maximum(masks[0, 0], inner[0, 0]), elevation


def joined(scene, splat):
    """One elevation (radians) of what SceneNet [m, 2] and SplatNet, which was told, [1, 2] say of it: means weighed by their precision;
    from the air and from below SplatNet's alone, as the program has it."""
    if not FROM_BELOW < splat[0, 0] < FROM_THE_AIR:
        return splat[0, 0]
    rows = torch.stack([torch.stack([scene[:, 0].mean(), scene[:, 1].mean()]), splat[0]])
    weight = 1 / rows[:, 1] ** 2
    return (rows[:, 0] * weight).sum() / weight.sum()


def box(mask):
    """Bounds of the mask, pixels: left, top, right, bottom; None if there is no subject."""
    rows, columns = torch.where(mask > 0.5)
    if len(rows) < 50:
        return None
    return columns.min().item(), rows.min().item(), columns.max().item() + 1, rows.max().item() + 1


def crop(photo, mask):
    """The square around the mask on grey with the mask itself, [1, 4, 256, 256]; None if there is no subject."""
    bounds = box(mask)
    if not bounds:
        return None
    left, top, right, bottom = bounds
    side = max(right - left, bottom - top) / FILL
    steps = (torch.arange(SplatNet.SIZE, device=DEVICE) + 0.5) / SplatNet.SIZE * side - side / 2
    across, down = torch.meshgrid((left + right) / 2 + steps, (top + bottom) / 2 + steps, indexing="xy")
    grid = torch.stack([across, down], -1)[None] / (PHOTO / 2) - 1
    colour = F.grid_sample(photo[None], grid, mode="bilinear", padding_mode="border", align_corners=False)[0]
    alpha = F.grid_sample(mask[None, None], grid, mode="bilinear", padding_mode="zeros", align_corners=False)[0]
    return torch.cat([colour * alpha + 0.5 * (1 - alpha), alpha])[None]


def crop_tangent(mask, focal):
    """Tangent of half the angle that the crop around the mask spans; the photo's focal length in its pixels, optical axis in its middle.

    Beside the axis a pixel spans less: across it the cosine, along it the cosine squared of what it does there; the mean counts.
    """
    left, top, right, bottom = box(mask)
    aside = math.hypot((left + right - len(mask)) / 2, (top + bottom - len(mask)) / 2)
    cosine = focal / math.hypot(focal, aside)
    return max(right - left, bottom - top) / FILL / 2 / focal * cosine**1.5


def hinted(elevation, tangent=0.0):
    """What SplatNet is told [1, 3]: of the elevation [1, 2], and the tangent of half the angle that the crop spans, 0 where nobody says."""
    return F.pad(elevation, (0, 1), value=tangent)


def rotations(quaternions):
    """Unit quaternions [n, 4], w first -> matrices [n, 3, 3]."""
    w, x, y, z = quaternions.unbind(1)
    rows = [
        1 - 2 * (y**2 + z**2), 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), 1 - 2 * (x**2 + z**2), 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x**2 + y**2),
    ]  # fmt: skip
    return torch.stack(rows, 1).reshape(-1, 3, 3)


def to_world(splats, elevation, azimuth, size):
    """Gaussians in the object's world: positions [n, 3] in metres and covariances [n, 3, 3].

    elevation (a tensor), azimuth: of the photo's camera, radians. size [3]: the object's bounding box in
    metres, half whose diagonal is the network's unit; the object stands on z = 0.
    """
    radius = float(np.linalg.norm(size) / 2)
    eye = orbit(
        torch.tensor([azimuth], device=DEVICE),
        elevation.reshape(1),
        torch.tensor([SplatNet.DIST], device=DEVICE),
    )
    canonical = inverses(*look_at(eye))[0]
    position = splats["pos"][0] @ canonical[:3, :3].T + canonical[:3, 3]
    position = position * radius
    position[:, 2] += float(size[2]) / 2
    axes = canonical[:3, :3] @ rotations(splats["quat"][0]) * (splats["scale"][0] * radius)[:, None]
    return position, axes @ axes.transpose(1, 2)


@torch.no_grad()
def rendered(splats, elevation, azimuth, size, views, place=(1.0, (0.0, 0.0, 0.0))):
    """The object from `views` on white, [V, 3, H, W], and its coverage [V, H, W]. `place`: scale and then shift in its world."""
    position, covariance = to_world(splats, elevation, azimuth, size)
    scale, shift = place
    position = position * scale + torch.tensor(shift, dtype=torch.float32, device=DEVICE)
    covariance = covariance * scale**2
    matrices = torch.tensor([v["w2c_opencv"] for v in views], device=DEVICE, dtype=torch.float32)
    intrinsics = torch.tensor([[v["fx"], v["fy"], v["cx"], v["cy"]] for v in views], device=DEVICE)
    height, width = views[0]["height"], views[0]["width"]
    draw = drawn_on_gpu if DEVICE == "cuda" else drawn_on_cpu
    gaussians = (position, covariance, splats["opacity"][0], splats["rgb"][0])
    colour, alpha = draw(gaussians, matrices, intrinsics, height, width)
    on_white = colour + 1 - alpha[..., None]
    return on_white.permute(0, 3, 1, 2).clamp(0, 1), alpha


def drawn_on_gpu(gaussians, matrices, intrinsics, height, width):
    from gsplat import rasterization

    position, covariance, opacity, colour = gaussians
    kays = torch.zeros(len(matrices), 3, 3, device=DEVICE)
    kays[:, 0, 0], kays[:, 1, 1], kays[:, 0, 2], kays[:, 1, 2] = intrinsics.unbind(1)
    kays[:, 2, 2] = 1
    options = {"packed": False, "near_plane": 0.05, "covars": covariance, "rasterize_mode": "antialiased"}
    colour, alpha, _ = rasterization(position, None, None, opacity, colour, matrices, kays, width, height, **options)
    return colour, alpha[..., 0]


@cache
def cpu_library():
    library = Path(tempfile.mkdtemp()) / "splatting.so"
    subprocess.run(["g++", "-O3", "-fopenmp", "-shared", "-fPIC", "-o", library, HERE / "splatting.cpp"], check=True)
    return ctypes.CDLL(str(library))


def drawn_on_cpu(gaussians, matrices, intrinsics, height, width):
    inputs = [t.float().contiguous() for t in (*gaussians, matrices, intrinsics)]
    colour = torch.zeros(len(matrices), height, width, 3)
    alpha = torch.zeros(len(matrices), height, width)
    pointers = [ctypes.c_void_p(t.data_ptr()) for t in (*inputs, colour, alpha)]
    sizes = (len(gaussians[0]), len(matrices), height, width)
    cpu_library().draw(*pointers, *map(ctypes.c_int, sizes))
    return colour, alpha


def view_scores(answer, alpha, truth, truth_alpha, views):
    """PSNR (dB) over all views, those within 60 degrees of the photo and the others; silhouette IoU."""
    psnr = -10 * ((answer - truth) ** 2).mean((1, 2, 3)).log10()
    inside, truly = alpha > 0.5, truth_alpha > 0.5
    iou = (inside & truly).sum((1, 2)) / (inside | truly).sum((1, 2))
    away = np.array([abs(v["azimuth_rel_photo_deg"]) for v in views])
    near = torch.tensor(np.minimum(away, 360 - away) <= 60, device=DEVICE)
    return {
        "psnr": psnr.mean().item(),
        "psnr_near": psnr[near].mean().item(),
        "psnr_back": psnr[~near].mean().item(),
        "iou": iou.mean().item(),
    }


def mask_iou(answer, truth):
    a, b = answer > 0.5, truth > 0.5
    return ((a & b).sum() / (a | b).sum()).item()


def score_object(folder, scene, splat):
    """Yield (photo name, mask used, scores, sheet columns or None) for every photo of one object."""
    cameras = json.loads((folder / "cameras.json").read_text())
    photos = [v for v in cameras["views"] if v["group"] == "photo"]
    mask_view = next(v for v in photos if v["name"].endswith("mask"))
    truth_mask = true_mask(view_file(folder, mask_view, ".png"))
    others = [v for v in cameras["views"] if v["group"] == "gt" and (folder / v["file"]).exists()]
    azimuth = math.radians(cameras["photo_azimuth_deg"])
    size = np.array(cameras["size_m"])
    if others:
        truth = torch.stack([picture(folder / v["file"], "RGBA") for v in others])
        truth_alpha = truth[:, 3]
        truth = truth[:, :3] * truth[:, 3:] + 1 - truth[:, 3:]
    for view in photos:
        if view is mask_view:
            continue
        photo = picture(view_file(folder, view, ".jpg"), "RGB", PHOTO)
        own_mask, seen = look(scene, photo)
        for source, mask in (("own mask", own_mask), ("true mask", truth_mask)):
            rgba = crop(photo, mask)
            if rgba is None:
                print(folder.name, view["name"], source, "shows no subject")
                continue
            with torch.no_grad():
                splats = splat(rgba, hinted(seen.mean(0, keepdim=True)))
            said = {"scene": seen[:, 0].mean(), "splat": splats["elevation"][0, 0], "": joined(seen, splats["elevation"])}
            errors = {k: abs(math.degrees(v.item()) - view["elevation_deg"]) for k, v in said.items()}
            scores = {f"{k}_elevation_error_deg".lstrip("_"): v for k, v in errors.items()}
            scores["mask_iou"] = mask_iou(mask, truth_mask)
            columns = None
            if others:
                answer, alpha = rendered(splats, said[""], azimuth, size, others)
                scores |= view_scores(answer, alpha, truth, truth_alpha, others)
                pairs = [t[i : i + 1] for i in range(0, len(others), 2) for t in (truth, answer)]
                columns = [F.interpolate(c, size=144, mode="area") for c in (rgba[:, :3], *pairs)]
            yield view["name"], source, scores, columns


def load(net, path):
    """The network with the weights of a .pt or an .onnx file, this version's or an older one's."""
    return load_weights(net, path).to(DEVICE).eval()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data")
    parser.add_argument("scene")
    parser.add_argument("splat")
    parser.add_argument("--sheet", help="photo crops, then truth and answer side by side")
    args = parser.parse_args()
    scene = load(SceneNet(), args.scene)
    splat = load(SplatNet(), args.splat)
    totals = {}
    sheet = []
    for path in sorted(Path(args.data).glob("*/cameras.json")):
        for photo, source, scores, columns in score_object(path.parent, scene, splat):
            print(path.parent.name, photo, source, {k: round(v, 3) for k, v in scores.items()}, flush=True)
            totals.setdefault((photo, source), []).append(scores)
            if columns is not None and source == "own mask":
                sheet.append(columns)
    for (photo, source), rows in totals.items():
        means = {k: round(float(np.mean([r[k] for r in rows])), 3) for k in rows[0]}
        print("mean", photo, source, means)
    if args.sheet and sheet:
        save_sheet([torch.cat(column) for column in zip(*sheet, strict=True)], args.sheet, rows=len(sheet))


if __name__ == "__main__":
    main()
