"""Score the subject masks of `orb geo` on photos with known masks.

    python score_masks.py ORB PHOTO_DIR MASK_DIR OUT_DIR [--sheet sheet.png]            # real photographs, masks checked by hand
    python score_masks.py ORB DEVSET DEVSET OUT_DIR --development plain|outdoor         # the development set

PHOTO_DIR/<name>.jpg (see real/fetch.py) and MASK_DIR/<name>.png of the same size, or DEVSET/<name>/photo_<kind>.jpg and
mask.png (see render.py). Prints the intersection over union of every photo and the one that Orb expected, the mean, the median and
what failed (a refusal counts as 0); then the mean of what was expected, of the true ones and of how far they lie apart, refusals
left out. Writes OUT_DIR/masks.json.
"""

import argparse
import base64
import json
import os
from pathlib import Path

import numpy as np
from PIL import Image
from score import iou, run_orb


def answer(orb, photo, target):
    """Orb's mask at its working resolution, and the IoU that it expects."""
    run_orb(orb, ["geo", "--origin", "0,0,0", "--height", 1, "--iterations", 0, "--format", "ply", "--lods", 1, "--stages",
                  "--quiet", "--replace", "-o", target, photo])  # fmt: skip
    payload = json.loads((target / "orb-record.dsse.json").read_text())["payload"]
    params = json.loads(base64.b64decode(payload))["predicate"]["params"]
    return Image.open(target / "mask.png").convert("L"), float(params["mask_expected_iou"])


def pairs(photos, masks, kind):
    """Name, photo and true mask of each."""
    if kind:
        return [(p.parent.name, photos / p.parent.name / f"photo_{kind}.jpg", p) for p in sorted(masks.glob("*/mask.png"))]
    return [(p.stem, photos / f"{p.stem}.jpg", p) for p in sorted(masks.glob("*.png"))]


def tiles(photo, mask, truth, size=192):
    """The photo under Orb's mask and under the true one."""
    photo = np.asarray(Image.open(photo).convert("RGB")).astype(float) / 255
    shown = []
    for m in (mask, truth):
        inside = (m > 0.5)[..., None]
        over = np.where(inside, photo, photo * 0.3 + np.array([0.6, 0, 0.6]) * 0.7)
        image = Image.fromarray((over * 255).astype(np.uint8))
        image.thumbnail((size, size))
        shown.append(image)
    return shown


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("orb")
    parser.add_argument("photos", type=Path)
    parser.add_argument("masks", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--development", choices=["plain", "outdoor"])
    parser.add_argument("--sheet", type=Path)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("ORB_DATA_DIR", str(args.out / "orb-data"))
    scores, expected, refused, shown = {}, {}, {}, []
    for name, photo, path in pairs(args.photos, args.masks, args.development):
        truth = np.asarray(Image.open(path).convert("L")).astype(float) / 255
        try:
            mask, expected[name] = answer(args.orb, photo, args.out / name)
            mask = mask.resize(truth.shape[::-1], Image.LANCZOS)
            mask = np.asarray(mask).astype(float) / 255
            scores[name] = iou(mask, truth)
        except RuntimeError as e:
            refused[name] = str(e).splitlines()[-1]
            mask, scores[name] = np.zeros_like(truth), 0.0
        said = refused.get(name) or f"expected {expected[name]:.3f}"
        print(f"{name:16} {scores[name]:.3f} {said}", flush=True)
        shown.append((scores[name], tiles(photo, mask, truth)))
    values = list(scores.values())
    print(f"{len(values)} photos: mean {np.mean(values):.3f}, median {np.median(values):.3f}, refused {len(refused)}")
    apart = [abs(e - scores[name]) for name, e in expected.items()]
    true = [scores[name] for name in expected]
    print(f"expected {np.mean(list(expected.values())):.3f}, true {np.mean(true):.3f}, apart {np.mean(apart):.3f}")
    (args.out / "masks.json").write_text(json.dumps({"iou": scores, "expected": expected, "refused": refused}, indent=1))
    if args.sheet:
        shown.sort(key=lambda s: s[0])
        sheet = Image.new("RGB", (8 * 196, -(-len(shown) // 4) * 196), "white")
        for i, (_, pair) in enumerate(shown):
            for j, tile in enumerate(pair):
                sheet.paste(tile, ((i % 4 * 2 + j) * 196, i // 4 * 196))
        sheet.save(args.sheet)


if __name__ == "__main__":
    main()
