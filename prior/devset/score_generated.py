"""Score SplatNet alone on generated objects that it has never seen, maker by maker: what it has not learned, and what others' objects cost.

    python devset/score_generated.py SPLAT [--count 8] [--makers car,person,...] [--above]     # the network: .onnx, or .pt of a training

Objects are those of seeds below one million, which no training draws (`train.py`). Photos are of eye height and above, or with --above
of 50 to 88 degrees, as drones take them; unspoilt, with true masks; views and figures as `score_networks.py` has them for shapes:
six views all around on white, here of 128 pixels.
"""

import argparse
import math
import sys
from pathlib import Path

import numpy as np
import torch

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent))

import evaluate
from nets import SplatNet
from score_networks import view_figures
from synth import batches, objects
from synth.cameras import crop, look_at, matrices, orbit, pack
from synth.environments import environments
from synth.raycast import cast

FIRST_SEED = 500_000
# Of the views: azimuths from the photo's and elevations, degrees; field of view and pixels.
AROUND, ABOVE = (0, 120, 240, 15, 135, 255), (8, 8, 8, 32, 32, 32)
FOV, SIZE = 40, 128
# Of the photos, radians.
LEVEL, STEEP = (0.03, 0.4), (0.873, 1.536)


def photographed(maker, count, elevations):
    """Crops [n, 4, 256, 256] of a maker's objects from between two elevations, and what they were made from: primitives, counts,
    surroundings, azimuths, elevations."""
    made = [objects.make_object(FIRST_SEED + i, maker) for i in range(count)]
    prims = batches.recolour(torch.from_numpy(np.stack([m.rows for m in made])))
    counts = torch.tensor([m.count for m in made], dtype=torch.int32)
    each = torch.arange(count, dtype=torch.int32)
    azimuth, elevation, fov = (batches.uniform(each, *between) for between in ((0, 6.283), elevations, (0.35, 0.8)))
    rotation, translation = look_at(orbit(azimuth, elevation, 1.02 / torch.sin(fov / 2)))
    ground = torch.tensor([m.ground for m in made], dtype=torch.float32) - 1e3
    light = environments(count, ground, "cpu", batches.uniform(each, 0, 1) < 0.4)
    probe = pack(rotation, translation, fov * 1.1, 64, subject_only=True)
    _, coarse, _, _ = cast(prims, counts, each, probe, light, 64, 1)
    cameras, _ = crop(probe, coarse, SplatNet.SIZE, torch.full((count,), evaluate.FILL))
    rgb, alpha, _, _ = cast(prims, counts, each, cameras, light, SplatNet.SIZE, 2)
    alpha = alpha[:, None]
    photo = batches.composed(rgb, alpha, torch.full((count, 3, 1, 1), batches.GREY))
    return torch.cat([photo * alpha + batches.GREY * (1 - alpha), alpha], 1), (prims, counts, light, azimuth, elevation)


def true_views(prims, counts, light, azimuth):
    """Of one object: its views as `evaluate.rendered` reads them, colours on white [V, 3, S, S] and coverage [V, S, S]."""
    around = azimuth + torch.deg2rad(torch.tensor(AROUND, dtype=torch.float32))
    above = torch.deg2rad(torch.tensor(ABOVE, dtype=torch.float32))
    away = torch.full_like(around, 1.04 / math.sin(math.radians(FOV) / 2))
    rotation, translation = look_at(orbit(around, above, away))
    fov = torch.full_like(around, math.radians(FOV))
    cameras = pack(rotation, translation, fov, SIZE, subject_only=True)
    rgb, alpha, _, _ = cast(prims, counts, torch.zeros(len(around), dtype=torch.int32), cameras, light, SIZE, 2)
    focal = SIZE / 2 / math.tan(math.radians(FOV) / 2)
    picture = {"width": SIZE, "height": SIZE, "fx": focal, "fy": focal, "cx": SIZE / 2, "cy": SIZE / 2}
    poses = zip(matrices(rotation, translation).tolist(), AROUND, strict=True)
    views = [picture | {"w2c_opencv": pose, "azimuth_rel_photo_deg": turn} for pose, turn in poses]
    return views, batches.premultiplied(rgb, alpha[:, None]) + 1 - alpha[:, None], alpha


@torch.no_grad()
def score_maker(splat, maker, count, elevations):
    """The means of `view_figures` and of the elevation's error over a maker's objects."""
    torch.manual_seed(FIRST_SEED)
    crops, (prims, counts, light, azimuth, elevation) = photographed(maker, count, elevations)
    rows = []
    for i in range(count):
        one = slice(i, i + 1)
        answer = splat(crops[one].to(evaluate.DEVICE))
        views, *truth = true_views(prims[one], counts[one], light[one], azimuth[i])
        colour, alpha = (t.to(evaluate.DEVICE) for t in truth)
        # Generated objects are centred, half their diagonal is 1.
        figures, _ = view_figures(answer, azimuth[i].item(), np.array([2.0, 0, 0]), views, colour, alpha)
        rows.append([*figures, abs(math.degrees(answer["elevation"][0, 0].item() - elevation[i].item()))])
    return np.mean(rows, 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("splat")
    parser.add_argument("--count", type=int, default=8, help="objects a maker")
    parser.add_argument("--makers", help="names with commas between them; all where this is left out")
    parser.add_argument("--above", action="store_true", help="photos from the air")
    args = parser.parse_args()
    makers = {maker.__name__: maker for maker, _ in objects.MAKERS}
    names = args.makers.split(",") if args.makers else list(makers)
    if unknown := [name for name in names if name not in makers]:
        parser.error(f"no makers of these names: {', '.join(unknown)}; there are {', '.join(makers)}")
    splat = evaluate.load(SplatNet(), args.splat)
    print("IoU, PSNR; best scale, IoU, PSNR, PSNR of near views there; these three placed best; elevation error")
    rows = []
    for name in names:
        rows.append(score_maker(splat, makers[name], args.count, STEEP if args.above else LEVEL))
        print(f"    {name:20}", " ".join(f"{v:7.3f}" for v in rows[-1]), flush=True)
    print("mean:", " ".join(f"{v:.3f}" for v in np.mean(rows, 0)))


if __name__ == "__main__":
    main()
