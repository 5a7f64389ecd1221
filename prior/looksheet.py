"""Draw what the generator makes, to look at before training on it.

    python looksheet.py [--seed 0] [--rows 8] [--out looksheet.png]

Each row: a photo, its mask, its inverse depth; then a subject as SplatNet sees it and four truth views of it.
"""

import argparse

import torch
import torch.nn.functional as F

from nets import SplatNet
from pictures import save_sheet
from synth.batches import make_pool, scene_batch, splat_batch


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--rows", type=int, default=8)
    parser.add_argument("--objects", type=int, default=1000)
    parser.add_argument("--size", type=int, default=128, help="of a photo, pixels")
    parser.add_argument("--out", default="looksheet.png")
    args = parser.parse_args()
    torch.manual_seed(args.seed)
    device = "cuda" if torch.cuda.is_available() else "cpu"
    pool = make_pool(args.seed, args.objects, processes=4, device=device, textures=48)
    scenes = scene_batch(pool, args.rows, size=args.size)
    inverse = torch.where(scenes.depth > 0, 1 / scenes.depth.clamp(min=0.1), torch.zeros_like(scenes.depth))
    inverse = inverse / inverse.amax((1, 2), keepdim=True).clamp(min=1e-6)
    subjects = splat_batch(pool, args.rows, SplatNet.FOV, SplatNet.DIST)
    on_white = subjects.colour + (1 - subjects.alpha)
    columns = [scenes.photo, torch.maximum(scenes.alpha[:, None] * 0.7, scenes.point), inverse[:, None]]
    columns += [subjects.rgba[:, :3], *on_white.unbind(1)]
    columns = [F.interpolate(column, size=args.size, mode="area") for column in columns]
    save_sheet(columns, args.out, args.rows)
    print(args.out)


if __name__ == "__main__":
    main()
