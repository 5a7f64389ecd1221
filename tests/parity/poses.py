"""What tests/parity/poses.sh needs beside `orb` and `colmap`: disturbed models, pose errors, the table.

usage: poses.py known SET OUT --database DB  the set's true poses as a model without points, for colmap point_triangulator,
                                          photos numbered as COLMAP's database has them
       poses.py disturb MODEL OUT --degrees D --shift S [--seed N]
                                          every pose turned about its eye by D degrees and its eye moved by S of the
                                          cameras' median distance from the points (standard deviations along each axis),
                                          every point placed anew under them
       poses.py table SET OUT             of OUT/NAME.json (`orb train --json`) and OUT/NAME.model (the poses trained with)

Models are COLMAP's, as text. Pose errors are against the set's own sparse/0, after the similarity that takes the poses
best to the true ones: the mean turn, then scale and shift of the eyes by least squares.
"""
import argparse
import json
import math
import os
import sqlite3

import numpy as np


def turn(q):
    w, x, y, z = np.array(q) / np.linalg.norm(q)
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def quaternion(r):
    # The largest component first, so that nothing is divided by almost nothing.
    k = np.array([
        [r[0, 0] - r[1, 1] - r[2, 2], 0, 0, 0],
        [r[0, 1] + r[1, 0], r[1, 1] - r[0, 0] - r[2, 2], 0, 0],
        [r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], r[2, 2] - r[0, 0] - r[1, 1], 0],
        [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], r[0, 0] + r[1, 1] + r[2, 2]]]) / 3
    x, y, z, w = np.linalg.eigh(k)[1][:, -1]
    return np.array([w, x, y, z])


def about(v):
    """The rotation by a rotation vector (Rodrigues)."""
    angle = np.linalg.norm(v)
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = v / angle
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


def lines(path):
    with open(path) as f:
        return [line.rstrip("\n") for line in f if not line.startswith("#")]


def images(model):
    """By name: number, rotation, translation, camera's number, the line of observations."""
    all_lines = lines(os.path.join(model, "images.txt"))
    out = {}
    for head, seen in zip(all_lines[::2], all_lines[1::2]):
        w = head.split()
        values = [float(v) for v in w[1:8]]
        out[w[9]] = (int(w[0]), turn(values[:4]), np.array(values[4:]), w[8], seen)
    return out


def write_images(model, all_images):
    with open(os.path.join(model, "images.txt"), "w") as f:
        for name, (number, r, t, camera, seen) in sorted(all_images.items()):
            values = " ".join(repr(float(v)) for v in [*quaternion(r), *t])
            f.write(f"{number} {values} {camera} {name}\n{seen}\n")


def copied(name, source, to):
    with open(os.path.join(source, name)) as a, open(os.path.join(to, name), "w") as b:
        b.write(a.read())


def known(args):
    os.makedirs(args.out)
    model = os.path.join(args.set, "sparse/0")
    copied("cameras.txt", model, args.out)
    numbers = dict(sqlite3.connect(args.database).execute("select name, image_id from images"))
    write_images(args.out, {name: (numbers[name], *i[1:4], "") for name, i in images(model).items()})
    open(os.path.join(args.out, "points3D.txt"), "w").close()


def disturb(args):
    os.makedirs(args.out)
    copied("cameras.txt", args.model, args.out)
    camera = lines(os.path.join(args.model, "cameras.txt"))[0].split()
    assert camera[1] == "PINHOLE", "one pinhole camera is expected"
    focal, centre = np.array([float(v) for v in camera[4:6]]), np.array([float(v) for v in camera[6:8]])
    points = [line.split() for line in lines(os.path.join(args.model, "points3D.txt"))]
    middle = np.median([[float(v) for v in p[1:4]] for p in points], axis=0)
    before = images(args.model)
    distance = np.median([np.linalg.norm(-r.T @ t - middle) for _, r, t, _, _ in before.values()])
    random = np.random.default_rng(args.seed)
    after = {}
    for name, (number, r, t, camera, seen) in sorted(before.items()):
        eye = -r.T @ t + random.normal(size=3) * args.shift * distance
        moved = about(random.normal(size=3) * math.radians(args.degrees)) @ r
        after[name] = (number, moved, -moved @ eye, camera, seen)
    write_images(args.out, after)
    by_number = {i[0]: i for i in after.values()}
    places = {n: [float(v) for v in i[4].split()] for n, i in by_number.items()}
    with open(os.path.join(args.out, "points3D.txt"), "w") as f:
        for p in points:
            rows = []
            for number, index in zip(map(int, p[8::2]), map(int, p[9::2])):
                _, r, t, _, _ = by_number[number]
                u, v = (np.array(places[number][3 * index:3 * index + 2]) - centre) / focal
                rt = np.column_stack([r, t])
                rows += [u * rt[2] - rt[0], v * rt[2] - rt[1]]
            x = np.linalg.svd(np.array(rows))[2][-1]
            x = x[:3] / x[3]
            f.write(" ".join([p[0], *(repr(float(v)) for v in x), *p[4:]]) + "\n")


def pose_errors(found, truth):
    """Median turn, degrees, and median shift, thousandths of the cameras' mean distance from their middle."""
    names = sorted(set(found) & set(truth))
    turns = [truth[n][1].T @ found[n][1] for n in names]
    u, _, v = np.linalg.svd(sum(turns))
    mean = u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v
    eyes = [np.array([-s[n][1].T @ s[n][2] for n in names]) for s in (found, truth)]
    middles = [e.mean(axis=0) for e in eyes]
    a, b = (eyes[0] - middles[0]) @ mean.T, eyes[1] - middles[1]
    scale = (a * b).sum() / (a * a).sum()
    shift = np.linalg.norm(scale * a - b, axis=1) / np.linalg.norm(b, axis=1).mean()
    angle = [math.degrees(2 * math.asin(min(1, np.linalg.norm(r - mean) / math.sqrt(8)))) for r in turns]
    return np.median(angle), 1000 * np.median(shift)


def table(args):
    truth = images(os.path.join(args.set, "sparse/0"))
    print("| poses | held out, poses fitted: PSNR dB | SSIM | as given: PSNR dB | trained on: PSNR dB | reprojection, pixels: RMS (median), before → after "
          "| pose error before → after: degrees, ‰ | s |\n|---|---|---|---|---|---|---|---|")
    for name in args.names:
        done = json.load(open(os.path.join(args.out, f"{name}.json")))
        error = lambda e: f"{e['rms_px']:.2f} ({e['median_px']:.2f})"
        reprojection = [error(e) for e in (done["reprojection"]["before"], done["reprojection"]["after"]) if e]
        poses = [os.path.join(args.out, f"{name}.model"), os.path.join(args.out, name, "sparse/0")]
        # Those held out are not refined.
        held_out = {p["name"] for p in done["photos"] if p["held_out"]}
        off = []
        for model in filter(os.path.isdir, poses):
            found = {n: i for n, i in images(model).items() if n not in held_out}
            off.append("{:.3f}, {:.2f}".format(*pose_errors(found, truth)))
        fitted = done["held_out_poses_fitted"]
        print(f"| {name.replace('_', ' ')} | {fitted['psnr_db']:.2f} | {fitted['ssim']:.4f} | {done['held_out']['psnr_db']:.2f} "
              f"| {done['trained_on']['psnr_db']:.2f} | {' → '.join(reprojection) or '–'} | {' → '.join(off)} | {done['train_seconds']:.0f} |")


p = argparse.ArgumentParser()
verbs = p.add_subparsers(required=True)
for name, run in [("known", known), ("disturb", disturb), ("table", table)]:
    v = verbs.add_parser(name)
    v.set_defaults(run=run)
    v.add_argument("model" if name == "disturb" else "set")
    v.add_argument("out")
    if name == "disturb":
        v.add_argument("--degrees", type=float, required=True)
        v.add_argument("--shift", type=float, required=True)
        v.add_argument("--seed", type=int, default=0)
    if name == "known":
        v.add_argument("--database", required=True)
    if name == "table":
        v.add_argument("names", nargs="+")
args = p.parse_args()
args.run(args)
