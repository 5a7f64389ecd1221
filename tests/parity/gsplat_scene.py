"""gsplat on a posed set, as its own trainer does it, beside `orb train`: same frame, split, start, pictures, measures.

usage: gsplat_scene.py SET --like ORB.json [--strategy default|mcmc] [--iterations N] [--cap N] [--size PIXELS] [--seed N]
                       [--check SCENE.ply] [-o OUT.json]

SET is COLMAP's layout (images, sparse/0/*.txt, pinhole cameras) or NeRF's (transforms_train.json, transforms_test.json).
ORB.json is what `orb train --json` printed: its world_to_unit is the frame, so that every step size means the same.
--check also measures Orb's own Gaussians (a scene.ply that is not placed) with gsplat's rasteriser.

Numbers of gsplat 1.5.3, examples/simple_trainer.py: batch 1, shuffled rounds, packed off, 0.8 L1 + 0.2 (1 - SSIM), step
sizes, degree of harmonics one more every 1,000; DefaultStrategy() as it stands; MCMCStrategy(cap_max) with opacity 0.5,
scale 0.1 and both regularisers 0.01. All pictures lie on the GPU before the clock starts.
"""
import argparse
import json
import math
import os
import sys
import time

import numpy as np
import torch
from gsplat import rasterization
from gsplat.strategy import DefaultStrategy, MCMCStrategy
from PIL import Image

SH_C0 = 0.28209479177387814
dev = "cuda"


def dissimilarity_seconds(training, iterations):
    """What the SSIM half of the loss takes of a run: gsplat's trainer has a fused kernel for it, which may not be installed."""
    views = [training[i % len(training)]["gt"].permute(2, 0, 1)[None].contiguous() for i in range(220)]
    for i, gt in enumerate(views):
        if i == 20:
            torch.cuda.synchronize()
            began = time.time()
        out = (gt * 0.9).requires_grad_()
        dissimilarity(out, gt).backward()
    torch.cuda.synchronize()
    return (time.time() - began) / 200 * iterations


def arguments():
    p = argparse.ArgumentParser()
    p.add_argument("set")
    p.add_argument("--like", required=True)
    p.add_argument("--strategy", choices=["default", "mcmc"], default="default")
    p.add_argument("--iterations", type=int, default=30_000)
    p.add_argument("--cap", type=int, default=1_000_000)
    p.add_argument("--size", type=int, default=1600)
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--check")
    p.add_argument("-o", "--output")
    return p.parse_args()


def turn(w, x, y, z):
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])


def to_unit(like):
    """scale, rotation, translation of `scale S rotation xyzw x y z w translation a b c`."""
    words = json.load(open(like))["world_to_unit"].split()
    x, y, z, w = map(float, words[4:8])
    return float(words[1]), turn(w, x, y, z), np.array(list(map(float, words[9:12])))


def colmap(root):
    """(name, path, K, R, t, held out) a photo, and points with colours."""
    model = os.path.join(root, "sparse", "0")
    lines = lambda f: [l for l in open(os.path.join(model, f)) if not l.startswith("#")]
    cameras = {}
    for l in lines("cameras.txt"):
        n, kind, w, h, *p = l.split()
        p = list(map(float, p))
        fx, fy, cx, cy = p if kind == "PINHOLE" else (p[0], p[0], p[1], p[2])
        cameras[n] = (int(w), int(h), np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]))
    photos = []
    for l in lines("images.txt")[::2]:
        _, qw, qx, qy, qz, tx, ty, tz, camera, name = l.split()
        photos.append((name, os.path.join(root, "images", name), cameras[camera], turn(*map(float, (qw, qx, qy, qz))), np.array(list(map(float, (tx, ty, tz))))))
    photos.sort(key=lambda p: p[0])
    points = [list(map(float, l.split()[1:7])) for l in lines("points3D.txt")]
    return [p + (i % 8 == 0,) for i, p in enumerate(photos)], np.array(points).reshape(-1, 6)


def nerf(root):
    photos = []
    for group in ("train", "test"):
        listed = json.load(open(os.path.join(root, f"transforms_{group}.json")))
        for f in listed["frames"]:
            path = os.path.join(root, f["file_path"] + ".png")
            w, h = Image.open(path).size
            focal = w / 2 / math.tan(listed["camera_angle_x"] / 2)
            m = np.array(f["transform_matrix"])
            r = (m[:3, :3] @ np.diag([1.0, -1.0, -1.0])).T
            photos.append((f["file_path"], path, (w, h, np.array([[focal, 0, w / 2], [0, focal, h / 2], [0, 0, 1]])), r, -r @ m[:3, 3], group == "test"))
    return photos, np.zeros((0, 6))


def load(args):
    root = args.set
    is_nerf = os.path.exists(os.path.join(root, "transforms_train.json"))
    photos, points = nerf(root) if is_nerf else colmap(root)
    s, rot, shift = to_unit(args.like)
    views = []
    for name, path, (w, h, k), r, t, held in photos:
        image = Image.open(path)
        pixels = np.asarray(image.convert("RGBA"), dtype=np.float32) / 255
        pixels = pixels[..., :3] * pixels[..., 3:] + (1 - pixels[..., 3:])
        shrink = min(1.0, args.size / max(image.size))
        if shrink < 1.0:
            size = tuple(max(1, round(v * shrink)) for v in image.size)
            pixels = np.asarray(Image.fromarray((pixels * 255 + 0.5).astype(np.uint8)).resize(size, Image.BOX), dtype=np.float32) / 255
        k = k.copy()
        k[0] *= pixels.shape[1] / w
        k[1] *= pixels.shape[0] / h
        # p' = s R p + t: the camera sees s (W Rt (p' - t) / s + w).
        turned = r @ rot.T
        view = np.eye(4)
        view[:3, :3], view[:3, 3] = turned, s * t - turned @ shift
        views.append(dict(name=name, held=held, gt=torch.from_numpy(pixels.copy()).to(dev), K=torch.tensor(k, dtype=torch.float32, device=dev)[None], V=torch.tensor(view, dtype=torch.float32, device=dev)[None]))
    if len(points):
        points[:, :3] = s * (points[:, :3] @ rot.T) + shift
    centres = np.array([(-v["V"][0, :3, :3].T @ v["V"][0, :3, 3]).cpu().numpy() for v in views])
    extent = 1.1 * np.linalg.norm(centres - centres.mean(0), axis=1).max()
    return views, points, float(extent), is_nerf


def knn(p):
    """Mean squared distance to the three nearest others."""
    out = []
    for part in p.split(2048):
        d = torch.cdist(part, p).topk(4, largest=False).values[:, 1:]
        out.append((d**2).mean(-1).sqrt())
    return torch.cat(out)


def gaussian():
    x = torch.exp(-((torch.arange(11, device=dev) - 5.0) ** 2) / 4.5)
    return x / x.sum()


WINDOW = gaussian()


def ssim_map(a, b, padding):
    """a, b: 1, 3, H, W. Two passes of eleven."""
    w = WINDOW.to(a.dtype)
    across, down = w.view(1, 1, 1, 11).expand(3, 1, 1, 11), w.view(1, 1, 11, 1).expand(3, 1, 11, 1)
    c = lambda x: torch.nn.functional.conv2d(torch.nn.functional.conv2d(x, across, padding=(0, padding), groups=3), down, padding=(padding, 0), groups=3)
    m, n = c(a), c(b)
    sa, sb, sab = c(a * a) - m * m, c(b * b) - n * n, c(a * b) - m * n
    return ((2 * m * n + 1e-4) * (2 * sab + 9e-4)) / ((m * m + n * n + 1e-4) * (sa + sb + 9e-4))


try:
    from fused_ssim import fused_ssim
    dissimilarity = lambda a, b: 1 - fused_ssim(a, b, padding="valid")
    SSIM_BY = "fused_ssim"
except ImportError:
    dissimilarity = lambda a, b: 1 - ssim_map(a, b, 5).mean()
    SSIM_BY = "two convolutions"


def draw(p, v, degree, background):
    h, w = v["gt"].shape[:2]
    sh = torch.cat([p["sh0"], p["shN"]], 1)
    out, _, info = rasterization(p["means"], p["quats"], p["scales"].exp(), p["opacities"].sigmoid(), sh, v["V"], v["K"], w, h,
                                 sh_degree=degree, packed=False, absgrad=False, backgrounds=background)
    return out, info


def measure(p, views, background):
    """Means over the views held out and trained on, in f64: PSNR, and SSIM over the windows inside the picture."""
    out = {}
    for group, held in (("held_out", True), ("trained_on", False)):
        psnr, ssim = [], []
        for v in (v for v in views if v["held"] == held):
            with torch.no_grad():
                a = draw(p, v, 3, background)[0].clamp(0, 1).double().permute(0, 3, 1, 2)
            b = v["gt"].double().permute(2, 0, 1)[None]
            psnr.append(-10 * math.log10(((a - b) ** 2).mean().item()))
            ssim.append(ssim_map(a, b, 0).mean().item())
        out[group] = dict(photos=len(psnr), psnr_db=float(np.mean(psnr)), ssim=float(np.mean(ssim))) if psnr else None
    return out


def start(args, points, extent, is_nerf, views):
    torch.manual_seed(args.seed)
    if len(points):
        xyz = torch.tensor(points[:, :3], dtype=torch.float32, device=dev)
        rgb = torch.tensor(points[:, 3:] / 255, dtype=torch.float32, device=dev)
    else:
        half = 0.33 if is_nerf else 3 * extent
        xyz = (torch.rand(100_000, 3, device=dev) * 2 - 1) * half
        rgb = torch.rand(100_000, 3, device=dev)
    n = len(xyz)
    opacity, share = (0.5, 0.1) if args.strategy == "mcmc" else (0.1, 1.0)
    p = dict(means=xyz, scales=torch.log(knn(xyz).clamp_min(1e-5) * share)[:, None].repeat(1, 3), quats=torch.rand(n, 4, device=dev),
             opacities=torch.logit(torch.full((n,), opacity, device=dev)), sh0=((rgb - 0.5) / SH_C0)[:, None], shN=torch.zeros(n, 15, 3, device=dev))
    return torch.nn.ParameterDict({k: torch.nn.Parameter(v.contiguous()) for k, v in p.items()})


def train(args, views, p, extent, background):
    rates = dict(means=1.6e-4 * extent, scales=5e-3, quats=1e-3, opacities=5e-2, sh0=2.5e-3, shN=2.5e-3 / 20)
    optimizers = {k: torch.optim.Adam([{"params": p[k], "lr": rates[k], "name": k}], eps=1e-15, betas=(0.9, 0.999)) for k in p}
    falling = torch.optim.lr_scheduler.ExponentialLR(optimizers["means"], gamma=0.01 ** (1 / args.iterations))
    is_mcmc = args.strategy == "mcmc"
    strategy = MCMCStrategy(cap_max=args.cap, verbose=False) if is_mcmc else DefaultStrategy(verbose=False)
    strategy.check_sanity(p, optimizers)
    state = strategy.initialize_state() if is_mcmc else strategy.initialize_state(scene_scale=extent)
    training = [v for v in views if not v["held"]]
    rng, order = np.random.default_rng(args.seed), []
    torch.cuda.synchronize()
    torch.cuda.reset_peak_memory_stats()
    began = time.time()
    for step in range(args.iterations):
        if not order:
            order = list(rng.permutation(len(training)))
        v = training[order.pop()]
        out, info = draw(p, v, min(step // 1000, 3), background)
        if not is_mcmc:
            strategy.step_pre_backward(p, optimizers, state, step, info)
        gt = v["gt"][None]
        loss = 0.8 * (out - gt).abs().mean() + 0.2 * dissimilarity(out.permute(0, 3, 1, 2), gt.permute(0, 3, 1, 2))
        if is_mcmc:
            loss = loss + 0.01 * p["opacities"].sigmoid().mean() + 0.01 * p["scales"].exp().mean()
        loss.backward()
        for o in optimizers.values():
            o.step()
            o.zero_grad(set_to_none=True)
        falling.step()
        if is_mcmc:
            strategy.step_post_backward(p, optimizers, state, step, info, lr=falling.get_last_lr()[0])
        else:
            strategy.step_post_backward(p, optimizers, state, step, info, packed=False)
    torch.cuda.synchronize()
    return time.time() - began


def ply(path):
    raw = open(path, "rb").read()
    end = raw.index(b"end_header\n") + 11
    names = [l.split()[2] for l in raw[:end].decode().splitlines() if l.startswith("property")]
    d = torch.from_numpy(np.frombuffer(raw[end:], "<f4").reshape(-1, len(names)).copy()).to(dev)
    i = {k: j for j, k in enumerate(names)}
    of = lambda *n: torch.stack([d[:, i[k]] for k in n], -1).contiguous()
    rest = of(*[f"f_rest_{k}" for k in range(45)]).reshape(-1, 3, 15).transpose(1, 2)
    return dict(means=of("x", "y", "z"), scales=of("scale_0", "scale_1", "scale_2"), quats=of("rot_0", "rot_1", "rot_2", "rot_3"),
                opacities=d[:, i["opacity"]], sh0=of("f_dc_0", "f_dc_1", "f_dc_2")[:, None], shN=rest.contiguous())


def main():
    args = arguments()
    views, points, extent, is_nerf = load(args)
    background = torch.full((1, 3), 1.0 if is_nerf else 0.0, device=dev)
    result = dict(what="gsplat", strategy=args.strategy, iterations=args.iterations, cap=args.cap if args.strategy == "mcmc" else None, ssim_by=SSIM_BY, scene_extent=extent)
    if args.check:
        result["orbs_gaussians_by_gsplat"] = measure(ply(args.check), views, background)
    p = start(args, points, extent, is_nerf, views)
    result["gaussians_begun"] = len(p["means"])
    result["train_seconds"] = train(args, views, p, extent, background)
    result["peak_gpu_memory_mib"] = torch.cuda.max_memory_allocated() / 2**20
    result["ssim_seconds"] = dissimilarity_seconds([v for v in views if not v["held"]], args.iterations)
    result["gaussians_end"] = len(p["means"])
    result.update(measure(p, views, background))
    text = json.dumps(result)
    if args.output:
        open(args.output, "w").write(text + "\n")
    print(text, flush=True)


if __name__ == "__main__":
    sys.exit(main())
