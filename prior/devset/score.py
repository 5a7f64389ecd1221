"""Score the whole `orb geo` job, and the network alone inside it, against truth.

    python score.py ORB SET_DIR OUT_DIR [NAME ...] [--photo plain] [--iterations 900] [--symmetry auto] [--true-mask]
                    [--lens] [--held] [--sheet sheet.png]

SET_DIR/<name>/ holds cameras.json as ../evaluate.py reads it, the photos, mask.png, mesh.glb and the truth views of group
"gt" that it lists. Every photo goes through `orb geo --stages --height <true height>`; `orb render` draws the network's
Gaussians (network.ply) and the optimised ones (scene.ply) from the cameras of the truth views, on white. Three ways to
stand the answer into the truth's frame, all with the photo's true azimuth:

  normalised   the network's unit is half the diagonal of the true bounding box, its origin the box's centre: how
               ../evaluate.py and the reach of the networks count it;
  placed       as Orb publishes it: metres, origin on the ground under the middle of the footprint;
  aligned      the scale and shift that the silhouettes of all views fit best: what remains is shape and colour.

Per row: mask IoU, elevation error (degrees), silhouette IoU, PSNR (dB) over all views / those within 60 degrees of the
photo / the others, PSNR of the colours alone (pixels that both cover), and the answer's size beside the aligned one's. --true-mask adds rows for the network with
the true mask in place of its own, which tells what the mask costs. --lens has the photos say their focal length, to a millimetre of a
35 mm camera's, as most cameras do, --held how the phone was held as well, as an iPhone does. Writes OUT_DIR/scores.json.
"""

import argparse
import base64
import json
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw


FITS = 4  # steps of the scale and shift that fit best


def pixels(path, mode, size=None):
    image = Image.open(path).convert(mode)
    if size is not None and image.size != (size, size):
        image = image.resize((size, size), Image.LANCZOS)
    return np.asarray(image).astype(np.float64) / 255


def coverage(path, size):
    rgba = pixels(path, "RGBA", size)
    return rgba[..., 3] if rgba[..., 3].min() < 0.99 else rgba[..., 0]


def iou(a, b):
    a, b = a > 0.5, b > 0.5
    return float((a & b).sum() / max(1, (a | b).sum()))


class Truth:
    """One object: its photos and what it looks like from other sides."""

    def __init__(self, folder):
        import trimesh

        about = json.loads((folder / "cameras.json").read_text())
        self.folder, self.name = folder, folder.name
        self.size = np.array(about["size_m"])
        photos = [v for v in about["views"] if v["group"] == "photo"]
        self.mask_view = next(v for v in photos if v["name"].endswith("mask"))
        self.photos = [v for v in photos if v is not self.mask_view]
        self.views = [v for v in about["views"] if v["group"] == "gt"]
        self.mask = coverage(folder / self.mask_view.get("file", "mask.png"), 512)
        rgba = [pixels(folder / v["file"], "RGBA") for v in self.views]
        self.alpha = np.array([p[..., 3] for p in rgba])
        self.colour = np.array([p[..., :3] * p[..., 3:] + 1 - p[..., 3:] for p in rgba])
        a = math.radians(about["photo_azimuth_deg"])
        # Columns: the photo's right, where its camera pointed, up.
        self.turn = np.array([[-math.sin(a), -math.cos(a), 0], [math.cos(a), -math.sin(a), 0], [0, 0, 1]])
        mesh = trimesh.load(folder / "mesh.glb", force="mesh", process=False)
        points = np.array(mesh.vertices)
        points = np.stack([points[:, 0], -points[:, 2], points[:, 1]], 1) @ self.turn
        middle = (points.min(0) + points.max(0)) / 2
        self.ground = self.turn @ [middle[0], middle[1], points[:, 2].min()]

    def placements(self, centre, radius):
        """Similarities (scale, shift) after `turn`; centre, radius: of the unit frame in Orb's metres."""
        scale = float(np.linalg.norm(self.size) / 2) / radius
        shift = np.array([0, 0, self.size[2] / 2]) - scale * self.turn @ centre
        return {"normalised": (scale, shift), "placed": (1.0, self.ground)}


def run_orb(orb, arguments):
    done = subprocess.run([orb, *map(str, arguments)], check=False, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, arguments))}\n{done.stderr.strip()}")


def draw(orb, ply, truth, places, folder):
    """Every truth view of every place: colours on white [places, views, H, W, 3] and coverage."""
    cameras = []
    for key, (scale, shift) in places.items():
        for v in truth.views:
            m = np.array(v["w2c_opencv"])
            rotation = m[:3, :3] @ truth.turn
            translation = (m[:3, :3] @ shift + m[:3, 3]) / scale
            rows = np.concatenate([rotation, translation[:, None]], 1).tolist() + [[0, 0, 0, 1]]
            entry = {k: v[k] for k in ("width", "height", "fx", "fy", "cx", "cy")}
            cameras.append({"name": f"{key}_{v['name']}", "world_to_camera": rows} | entry)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "cameras.json").write_text(json.dumps({"cameras": cameras}))
    on = []
    for shade in (1, 0):
        target = folder / f"on{shade}"
        run_orb(orb, ["render", ply, "--camera", folder / "cameras.json", "--background", f"{shade},{shade},{shade}",
                      "-o", target, "--replace", "--quiet", "--device", "cpu"])  # fmt: skip
        on.append(np.array([pixels(target / f"{c['name']}.png", "RGB") for c in cameras]))
    white, black = (o.reshape(len(places), len(truth.views), *o.shape[1:]) for o in on)
    return white, (1 - (white - black).mean(-1)).clip(0, 1)


def view_scores(truth, white, alpha):
    psnr = lambda error: -10 * np.log10(np.maximum(error, 1e-10))
    squares = (white - truth.colour) ** 2
    each = psnr(squares.mean((1, 2, 3)))
    away = np.array([abs(v["azimuth_rel_photo_deg"]) for v in truth.views])
    near = np.minimum(away, 360 - away) <= 60
    both = (alpha > 0.5) & (truth.alpha > 0.5)
    return {
        "psnr": float(each.mean()),
        "psnr_near": float(each[near].mean()),
        "psnr_back": float(each[~near].mean()),
        "psnr_colour": float(psnr(squares[both].mean())) if both.any() else 0.0,
        "iou": float(np.mean([iou(a, t) for a, t in zip(alpha, truth.alpha, strict=True)])),
    }


def centroid(weights):
    """Of a picture of weights: x and y in pixels."""
    y, x = np.mgrid[: weights.shape[0], : weights.shape[1]] + 0.5
    return np.array([(weights * x).sum(), (weights * y).sum()]) / weights.sum()


def better_place(truth, place, alpha):
    """One Gauss-Newton step of scale and shift towards the true silhouettes: their centroids and areas."""
    rows, values = [], []
    for v, own, true in zip(truth.views, alpha, truth.alpha, strict=True):
        if own.sum() < 20 or true.sum() < 20:
            continue
        m = np.array(v["w2c_opencv"])
        depth = (m @ [0, 0, truth.size[2] / 2, 1])[2]
        move = (centroid(true) - centroid(own)) * depth / v["fx"]
        rows += [[*m[0, :3], 0], [*m[1, :3], 0]]
        values += [*move]
        # A change of size weighs as a move of the silhouette's edge.
        reach = math.sqrt(true.sum() / math.pi) * depth / v["fx"]
        rows.append([*(-m[2, :3] / depth * reach), reach])
        values.append(0.5 * math.log(true.sum() / own.sum()) * reach)
    if not rows:
        return place
    *move, grow = np.linalg.lstsq(np.array(rows), np.array(values), rcond=None)[0]
    scale, shift = place
    middle, factor = np.array([0, 0, truth.size[2] / 2]), math.exp(grow)
    return scale * factor, middle + factor * (shift - middle) + np.array(move)


def best_place(truth, place, drawn_at, steps):
    """The scale and shift whose silhouettes fit the true ones best that at most `steps` steps of `better_place` lead to.

    `drawn_at(place)` gives colours and coverage of all views. A step is taken if the mean IoU of the silhouettes rises; else half
    of it is tried, then a quarter: what no step reaches, a fin of fog for one, moves centroids as well. Returns the place and what
    is drawn there.
    """

    def fit(drawn):
        return np.mean([iou(a, t) for a, t in zip(drawn[1], truth.alpha, strict=True)])

    drawn = drawn_at(place)
    reached = fit(drawn)
    for _ in range(steps):
        (scale, shift), (wanted, aim) = place, better_place(truth, place, drawn[1])
        for part in (1, 0.5, 0.25):
            tried = scale * (wanted / scale) ** part, shift + part * (aim - shift)
            there = drawn_at(tried)
            if (fits := fit(there)) > reached:
                break
        else:
            break
        place, drawn, reached = tried, there, fits
    return place, drawn


def score_splats(orb, ply, truth, folder):
    """Scores of one PLY in each placement, and its pictures as placed best: (scores, white, alpha)."""
    header = ply.read_bytes()[:4096].split(b"end_header")[0].decode()
    words = next(line for line in header.splitlines() if "unit frame: centre" in line).split()
    at = words.index("centre")
    centre, radius = np.array([float(w) for w in words[at + 1 : at + 4]]), float(words[at + 6])
    places = truth.placements(centre, radius)
    white, alpha = draw(orb, ply, truth, places, folder)
    scores = {key: view_scores(truth, white[i], alpha[i]) for i, key in enumerate(places)}
    normalised = white[0]

    def drawn_at(place):
        (w,), (own,) = draw(orb, ply, truth, {"aligned": place}, folder)
        return w, own

    place, drawn = best_place(truth, places["normalised"], drawn_at, FITS)
    scores["aligned"] = view_scores(truth, *drawn)
    for key, (scale, _) in (places | {"aligned": place}).items():
        scores[key]["size"] = scale / place[0]
    return scores, normalised


def geo(orb, photo, truth, iterations, symmetry, target):
    """Run `orb geo`; returns the elevation in degrees that it found."""
    run_orb(orb, ["geo", "--origin", "34.5523,-118.4712,740", "--height", float(truth.size[2]), "--iterations", iterations,
                  "--symmetry", symmetry, "--format", "ply", "--lods", 1, "--stages", "--quiet", "--replace", "-o", target, photo])  # fmt: skip
    envelope = json.loads((target / "orb-record.dsse.json").read_text())
    found = []

    def walk(node):
        if isinstance(node, dict):
            found.extend(v for k, v in node.items() if k == "elevation_deg")
            node = list(node.values())
        for child in node if isinstance(node, list) else []:
            walk(child)

    walk(json.loads(base64.b64decode(envelope["payload"])))
    return float(found[0])


def with_camera(photo, view, held, to):
    """A copy of a JPEG that says the focal length of `view`, by its diagonal, in an EXIF segment of its own; `held`: and in a phone's maker
    note, where down is."""
    size = math.hypot(view["width"], view["height"])
    exif = Image.Exif()
    exif.get_ifd(0x8769)[0xA405] = round(view["fx"] / size * math.hypot(36, 24))
    if held:
        across, below, forward = np.array(view["w2c_opencv"])[:3, :3] @ [0, 0, -1]
        felt = np.array([-below, -across, -forward])  # Of a phone on its side, its top to the left: right, to its top, out of its face.
        note = b"Apple iOS\0\0\x01MM\0\x01" + np.array([8, 10, 0, 3, 0, 32], ">u2").tobytes() + bytes(4)
        note += np.stack([felt * 10_000, np.full(3, 10_000)], 1).astype(">i4").tobytes()
        exif.get_ifd(0x8769)[0x927C] = note
    segment = exif.tobytes()
    jpeg = photo.read_bytes()
    to.write_bytes(jpeg[:2] + b"\xff\xe1" + (len(segment) + 2).to_bytes(2, "big") + segment + jpeg[2:])
    return to


def score_photo(orb, truth, view, iterations, symmetry, out, true_mask, lens, held):
    """Rows of scores for one photo and what a contact sheet shows of it."""
    photo = truth.folder / view.get("file", view["name"] + ".jpg")
    target = out / f"{truth.name}_{view['name']}"
    if lens or held:
        photo = with_camera(photo, view, held, out / f"{truth.name}_{view['name']}_lens.jpg")
    elevation = geo(orb, photo, truth, iterations, symmetry, target)
    mask = coverage(target / "mask.png", 512)
    common = {"mask_iou": iou(mask, truth.mask), "elevation_error_deg": abs(elevation - view["elevation_deg"])}
    rows, pictures = [], {}
    stages = [("network", "network.ply")] + ([("optimised", "scene.ply")] if iterations else [])
    for stage, file in stages:
        scores, pictures[stage] = score_splats(orb, target / file, truth, out / "views")
        rows += [{"stage": stage, "placement": p} | common | s for p, s in scores.items()]
    if true_mask:
        cut = out / f"{truth.name}_{view['name']}_cut.png"
        image = Image.open(photo).convert("RGB")
        image.putalpha(Image.fromarray((truth.mask * 255 + 0.5).astype(np.uint8)).resize(image.size))
        image.save(cut)
        target = out / f"{truth.name}_{view['name']}_true_mask"
        elevation = geo(orb, cut, truth, 0, symmetry, target)
        common = {"mask_iou": 1.0, "elevation_error_deg": abs(elevation - view["elevation_deg"])}
        scores, _ = score_splats(orb, target / "network.ply", truth, out / "views")
        rows += [{"stage": "network, true mask", "placement": p} | common | s for p, s in scores.items()]
    rows = [{"object": truth.name, "photo": view["name"]} | r for r in rows]
    return rows, (pixels(photo, "RGB", 512), mask, pictures)


def sheet_rows(truth, photo, mask, pictures):
    """Two rows of tiles: photo and truth views; the photo under the mask and the optimised answers."""
    shown = [0, 2, 4, 6, 8, 10, 12, 16, 20]
    edge = (mask > 0.5).astype(float)[..., None]
    over = photo * (0.25 + 0.75 * edge) + np.array([0.75, 0, 0]) * (1 - edge) * 0.6
    first = [photo] + [truth.colour[i] for i in shown]
    second = [over.clip(0, 1)] + [pictures.get("optimised", pictures["network"])[i] for i in shown]
    third = [np.stack([truth.mask] * 3, -1)] + [pictures["network"][i] for i in shown]
    tile = lambda a: Image.fromarray((a * 255 + 0.5).astype(np.uint8)).resize((128, 128), Image.BOX)
    return [[tile(a) for a in row] for row in (first, second, third)]


def table(rows):
    """Means over objects, one line for each photo, stage and placement."""
    keys = ["mask_iou", "elevation_error_deg", "iou", "psnr", "psnr_near", "psnr_back", "psnr_colour", "size"]
    lines = ["| photo | stage | placement | n | " + " | ".join(keys) + " |", "|---" * (4 + len(keys)) + "|"]
    groups = {}
    for r in rows:
        groups.setdefault((r["photo"], r["stage"], r["placement"]), []).append(r)
    for key, group in groups.items():
        means = [np.mean([r[k] for r in group]) for k in keys]
        lines.append(f"| {' | '.join(key)} | {len(group)} | " + " | ".join(f"{m:.3f}" for m in means) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("orb")
    parser.add_argument("set", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument(
        "--iterations", type=int, default=900, help="of the optimisation, whatever the machine; 0: network alone"
    )
    parser.add_argument("--symmetry", default="auto", help="as `orb geo` has it")
    parser.add_argument("--photo", help="only the photos of this name: plain or outdoor")
    parser.add_argument("--true-mask", action="store_true")
    parser.add_argument("--lens", action="store_true")
    parser.add_argument("--held", action="store_true")
    parser.add_argument("--sheet", type=Path)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("ORB_DATA_DIR", str(args.out / "orb-data"))
    rows, tiles, labels, failed = [], [], [], []
    for path in sorted(args.set.glob("*/cameras.json")):
        if args.names and path.parent.name not in args.names:
            continue
        truth = Truth(path.parent)
        for view in truth.photos:
            if args.photo not in (None, view["name"]):
                continue
            try:
                found, shown = score_photo(
                    args.orb, truth, view, args.iterations, args.symmetry, args.out, args.true_mask, args.lens, args.held
                )
            except RuntimeError as e:
                failed.append(f"{truth.name} {view['name']}: {e}")
                print(failed[-1], file=sys.stderr, flush=True)
                continue
            rows += found
            tiles += sheet_rows(truth, *shown)
            labels.append(f"{truth.name} {view['name']} {found[0]['mask_iou']:.2f}")
            for r in found:
                numbers = {k: round(v, 3) for k, v in r.items() if isinstance(v, float)}
                print(r["object"], r["photo"], r["stage"], r["placement"], numbers, flush=True)
            (args.out / "scores.json").write_text(json.dumps({"rows": rows, "failed": failed}, indent=1))
    print(table(rows))
    for line in failed:
        print("failed:", line)
    if args.sheet and tiles:
        sheet = Image.new("RGB", (128 * max(map(len, tiles)), 128 * len(tiles)), "white")
        for j, row in enumerate(tiles):
            for i, tile in enumerate(row):
                sheet.paste(tile, (i * 128, j * 128))
        pen = ImageDraw.Draw(sheet)
        for j in range(0, len(tiles), 3):
            pen.line([(0, j * 128), (sheet.width, j * 128)], fill="black", width=2)
            pen.text((4, j * 128 + 4), labels[j // 3], fill="black")
        sheet.save(args.sheet)


if __name__ == "__main__":
    main()
