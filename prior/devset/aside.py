"""The development set's photos as they are when the camera does not look straight at its subject.

    python devset/aside.py SET OUT [--aside 0.27] [--below 0] [--roll 0] [--inside]     # then: devset/score.py ORB OUT TO --photo plain --lens

The same place, the same lens, the camera turned: level unless rolled, the subject's middle ASIDE and BELOW focal lengths beside the
optical axis. Another camera at the same place sees the same rays, so the photo drawn anew is exact, but for being sampled twice.
The views to be compared with are SET's own, by links.
"""

import argparse
import json
import math
from pathlib import Path

import numpy as np
import torch
import torch.nn.functional as F
from PIL import Image


def turned(down, heading):
    """World (east, north, up) -> right, down, forward of a level camera that looks `down` so far below the horizon; radians."""
    forward = [math.sin(heading) * math.cos(down), math.cos(heading) * math.cos(down), -math.sin(down)]
    right = [math.cos(heading), -math.sin(heading), 0.0]
    return np.array([right, np.cross(forward, right), forward])


def relation(elevation, aside, below, roll=0.0):
    """From the axes of the camera that looks at its subject from `elevation` to those of the one that does not; None where no level
    camera sees it so."""
    ray = np.array([aside, below, 1.0])
    sine = math.sin(elevation) * np.linalg.norm(ray) / math.hypot(1, below)
    if abs(sine) > 1:
        return None
    down = math.asin(sine) - math.atan(below)
    seen = turned(down, 0.0).T @ ray
    sin, cos = math.sin(roll), math.cos(roll)
    return np.array([[cos, sin, 0], [-sin, cos, 0], [0, 0, 1]]) @ turned(down, -math.atan2(seen[0], seen[1])) @ turned(elevation, 0).T


def drawn(picture, focal, relation, width, height):
    """A picture [C, S, S] of the one camera as the other sees it, [C, height, width]; beyond its border as its border."""
    half = picture.shape[-1] / 2
    across, down = torch.meshgrid(torch.arange(width) + 0.5 - width / 2, torch.arange(height) + 0.5 - height / 2, indexing="xy")
    rays = torch.stack([across / focal, down / focal, torch.ones_like(across)], -1) @ torch.tensor(relation, dtype=torch.float32)
    grid = rays[..., :2] / rays[..., 2:] * focal / half
    return F.grid_sample(picture[None], grid[None], mode="bicubic", padding_mode="border", align_corners=False)[0].clamp(0, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("set", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--aside", type=float, default=0.27)
    parser.add_argument("--below", type=float, default=0.0)
    parser.add_argument("--roll", type=float, default=0.0, help="degrees, clockwise")
    parser.add_argument("--inside", action="store_true", help="no more of it than SET's photo shows: of a camera that is rolled alone")
    args = parser.parse_args()
    if args.inside and (args.aside or args.below):
        parser.error("--inside: with --aside 0 --below 0 only, what lies aside is not all inside")
    for folder in sorted(p.parent for p in args.set.glob("*/cameras.json")):
        about = json.loads((folder / "cameras.json").read_text())
        view = next(v for v in about["views"] if v["name"] == "plain")
        by = relation(math.radians(view["elevation_deg"]), args.aside, args.below, math.radians(args.roll))
        if by is None:
            print(f"{folder.name}: no level camera sees it there from {view['elevation_deg']} degrees above")
            continue
        focal, size = view["fx"], view["width"]
        ray = np.abs(by @ [0, 0, 1]) / (by @ [0, 0, 1])[2] * focal
        width, height = (2 * int(r + 0.6 * size) for r in ray[:2])
        if args.inside:
            width = height = int(size / (abs(by[0, 0]) + abs(by[0, 1])))
        to = args.out / folder.name
        to.mkdir(parents=True, exist_ok=True)
        for name, mode in (("photo_plain.jpg", "RGB"), ("photo_outdoor.jpg", "RGB"), ("mask.png", "L")):
            picture = np.asarray(Image.open(folder / name).convert(mode), np.float32).reshape(size, size, -1) / 255
            made = drawn(torch.from_numpy(picture).permute(2, 0, 1), focal, by, width, height)
            if mode == "L":
                made = made * (made > 0.02)
            Image.fromarray((made.permute(1, 2, 0).squeeze(-1).numpy() * 255 + 0.5).astype(np.uint8)).save(to / name, quality=95)
        for v in (v for v in about["views"] if v["group"] == "photo"):
            whole = np.eye(4)
            whole[:3, :3] = by
            moved = (whole @ np.array(v["w2c_opencv"])).tolist()
            v |= {"width": width, "height": height, "cx": width / 2, "cy": height / 2, "w2c_opencv": moved}
        (to / "cameras.json").write_text(json.dumps(about, indent=1))
        for name in ("gt", "mesh.glb"):
            (to / name).unlink(missing_ok=True)
            (to / name).symlink_to((folder / name).resolve())
        print(f"{folder.name}: {width} x {height}")


if __name__ == "__main__":
    main()
