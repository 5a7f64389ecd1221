"""Score both networks alone, nothing after them: the figures of the README's tables.

    python devset/score_networks.py SCENE SPLAT DEVSET PHOTOS [--lpips LPIPS.onnx] [--widen 1] [--lens]   # networks: .onnx, or .pt of a training

DEVSET as `render.py` makes it, PHOTOS as `real/fetch.py` does; the true masks of PHOTOS are those in `real/masks`. Prints

* masks: the intersection over union of SceneNet's with the true ones, mean and median, for the real photographs, the plain
  and the outdoor ones (`evaluate.look`: the larger of two fits);
* elevations: mean and median error in degrees of SceneNet, of SplatNet without a hint and with SceneNet's, and of this and SceneNet's
  joined (`evaluate.joined`), own masks;
* shapes: SplatNet on plain photos with true masks and SceneNet's hint, every fourth view of 24, on white: silhouette IoU and PSNR in its own
  unit, then at the best of the scales in `SCALES` (no photo shows the unit when the bounding box lies askew), PSNR of the
  views within 60 degrees of the photo at that scale, the same three at the scale and shift that fit the silhouettes best (nor does
  a photo show the box's middle: `score.best_place`), and the error of its elevation; with a graph of LPIPS (inputs `ref` and
  `dist`, normalised as ImageNet's networks want it), its means over the views in its own unit and so placed, drawn on to 256 x 256.
  With --lens SplatNet is told the photo's focal length, as most cameras write it into their files.
  `--widen 1` widens the Gaussians as the pictures did that versions up to 0.6 learned by, `BLUR`; since 0.7 pictures are true to size.
"""

import argparse
import json
import math
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import torch
import torch.nn.functional as F

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent))

import evaluate
from nets import SceneNet, SplatNet
from score import FITS, best_place

SCALES = (1.0, 0.94, 1.07, 1.15)
EVERY = 4  # of the 24 views
# Standard deviation of 0.3 square pixels (Kerbl et al. 2023) of 128 over 30 degrees, at the subject's centre.
BLUR = math.sqrt(0.3) * 2 * SplatNet.DIST * math.tan(math.radians(15)) / 128
# Mean and deviation, [1, 3, 1, 1], of the colours that LPIPS' network was trained on.
IMAGENET = np.array([[0.485, 0.456, 0.406], [0.229, 0.224, 0.225]], np.float32).reshape(2, 1, 3, 1, 1)


def photo_of(folder, kind):
    return evaluate.picture(folder / f"photo_{kind}.jpg", "RGB", evaluate.PHOTO)


def summary(values):
    return f"{np.mean(values):.3f} ({np.median(values):.3f})"


def named(rows):
    return " ".join(f"{name} {value}" for name, value in rows)


def score_real(scene, photos):
    scores = {}
    for path in sorted((HERE / "real/masks").glob("*.png")):
        mask, _ = evaluate.look(scene, evaluate.picture(photos / f"{path.stem}.jpg", "RGB", evaluate.PHOTO))
        scores[path.stem] = evaluate.mask_iou(mask, evaluate.picture(path, "RGB", evaluate.PHOTO)[0])
    print("masks, real:", summary(list(scores.values())))
    print("   ", named((k, f"{v:.2f}") for k, v in scores.items()), flush=True)


@torch.no_grad()
def score_photos(scene, splat, objects, kind):
    """Masks and elevations of the photos of one kind, with the networks' own masks."""
    masks, errors = {}, {}
    for folder, cameras in objects:
        photo = photo_of(folder, kind)
        mask, seen = evaluate.look(scene, photo)
        masks[folder.name] = evaluate.mask_iou(mask, evaluate.true_mask(folder / "mask.png"))
        hint = evaluate.hinted(seen.mean(0, keepdim=True))
        alone, told = (splat(evaluate.crop(photo, mask), h)["elevation"] for h in (None, hint))
        said = (hint[0, 0], alone[0, 0], told[0, 0], evaluate.joined(seen, told))
        truth = cameras["views"][0]["elevation_deg"]
        errors[folder.name] = [abs(math.degrees(e.item()) - truth) for e in said]
    print(f"masks, {kind}:", summary(list(masks.values())))
    print("   ", named((k, f"{v:.2f}") for k, v in masks.items()))
    by_network = zip(("SceneNet", "SplatNet", "SplatNet told", "joined"), np.array(list(errors.values())).T, strict=True)
    print(f"elevation error, {kind}, degrees:", ", ".join(f"{n} {summary(e)}" for n, e in by_network))
    print("   ", named((k, "/".join(f"{e:.0f}" for e in v)) for k, v in errors.items()), flush=True)


def scaled(splats, by):
    """The answer, larger about the subject's centre."""
    centre = torch.tensor([0, 0, SplatNet.DIST], device=splats["pos"].device)
    return splats | {"pos": (splats["pos"] - centre) * by + centre, "scale": splats["scale"] * by}


def lpips(graph, drawn, truth):
    """Mean LPIPS of views [n, 3, S, S], 0..1."""

    def fed(x):
        larger = F.interpolate(x[None].float(), size=(256, 256), mode="bilinear").clamp(0, 1)
        return ((larger.cpu() - torch.tensor(IMAGENET[0])) / torch.tensor(IMAGENET[1])).numpy()

    pairs = zip(truth, drawn, strict=True)
    return np.mean([np.ravel(graph.run(None, {"ref": fed(t), "dist": fed(d)})[0])[0] for t, d in pairs])


@torch.no_grad()
def score_shape(scene, splat, folder, cameras, graph, widen, lens):
    """`view_figures` of one object, the error of its elevation before LPIPS."""
    views = [v for v in cameras["views"] if v["group"] == "gt" and (folder / v["file"]).exists()][::EVERY]
    truth = torch.stack([evaluate.picture(folder / v["file"], "RGBA") for v in views])
    colour, alpha = truth[:, :3] * truth[:, 3:] + 1 - truth[:, 3:], truth[:, 3]
    photo = photo_of(folder, "plain")
    mask = evaluate.true_mask(folder / "mask.png")
    focal = evaluate.PHOTO / 2 / math.tan(math.radians(cameras["fov_x_deg"]) / 2)
    told = evaluate.crop_tangent(mask, focal) if lens else 0.0
    answer = splat(evaluate.crop(photo, mask), evaluate.hinted(evaluate.look(scene, photo)[1].mean(0, keepdim=True), told))
    answer["scale"] = (answer["scale"] ** 2 + (widen * BLUR) ** 2).sqrt()
    elevation = answer["elevation"][0, 0]
    azimuth, size = math.radians(cameras["photo_azimuth_deg"]), np.array(cameras["size_m"])
    figures, perceived = view_figures(answer, azimuth, size, views, colour, alpha, graph)
    off = abs(math.degrees(elevation.item()) - cameras["views"][0]["elevation_deg"])
    return [*figures, off, *perceived]


@torch.no_grad()
def view_figures(answer, azimuth, size, views, colour, alpha, graph=None):
    """Of one answer beside true views (on white [V, 3, H, W], coverage [V, H, W]): [IoU, PSNR in its own unit; best scale, IoU, PSNR,
    PSNR of near views there; the same three placed best], and [LPIPS in its own unit, placed best] or []."""
    elevation = answer["elevation"][0, 0]
    scores, perceived = {}, []
    for by in SCALES:
        drawn = evaluate.rendered(scaled(answer, by), elevation, azimuth, size, views)
        if graph and by == 1.0:
            perceived = [lpips(graph, drawn[0], colour)]
        scores[by] = evaluate.view_scores(*drawn, colour, alpha, views)
    best = max(SCALES, key=lambda by: scores[by]["iou"])
    silhouettes = SimpleNamespace(views=views, alpha=alpha.cpu().numpy(), size=size)

    def drawn_at(place):
        made, covered = evaluate.rendered(answer, elevation, azimuth, size, views, place)
        return made, covered.cpu().numpy()

    _, (made, covered) = best_place(silhouettes, (1.0, np.zeros(3)), drawn_at, FITS)
    drawn = made, torch.from_numpy(covered).to(made.device)
    placed = evaluate.view_scores(*drawn, colour, alpha, views)
    if graph:
        perceived.append(lpips(graph, drawn[0], colour))
    own = [scores[1.0][k] for k in ("iou", "psnr")]
    kinds = ("iou", "psnr", "psnr_near")
    return [*own, best, *(scores[best][k] for k in kinds), *(placed[k] for k in kinds)], perceived


def score_shapes(scene, splat, objects, graph, widen, lens):
    rows = []
    print("shapes: IoU, PSNR; best scale, IoU, PSNR, PSNR of near views there; these three placed best; elevation error; LPIPS, both")
    for folder, cameras in objects:
        rows.append(score_shape(scene, splat, folder, cameras, graph, widen, lens))
        print(f"    {folder.name:20}", " ".join(f"{v:7.3f}" for v in rows[-1]), flush=True)
    print("shapes, mean:", " ".join(f"{v:.3f}" for v in np.mean(rows, 0)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("splat")
    parser.add_argument("devset", type=Path)
    parser.add_argument("photos", type=Path)
    parser.add_argument("--lpips")
    parser.add_argument("--widen", type=float, default=0.0)
    parser.add_argument("--lens", action="store_true")
    args = parser.parse_args()
    graph = None
    if args.lpips:
        import onnxruntime

        graph = onnxruntime.InferenceSession(args.lpips)
    scene = evaluate.load(SceneNet(), args.scene)
    splat = evaluate.load(SplatNet(), args.splat)
    objects = [(p.parent, json.loads(p.read_text())) for p in sorted(args.devset.glob("*/cameras.json"))]
    score_real(scene, args.photos)
    for kind in ("plain", "outdoor"):
        score_photos(scene, splat, objects, kind)
    score_shapes(scene, splat, objects, graph, args.widen, args.lens)


if __name__ == "__main__":
    main()
