"""Values of Orb-Bench's metrics by programs that know nothing of Orb.

    pip install scikit-image colour-science trimesh scipy rtree pillow onnxruntime
    python make_values.py [lpips.onnx]        # writes reference.png, distorted.png and values.json beside itself

PSNR also by `idiff` (Debian: openimageio-tools). LPIPS only with a network: inputs `ref` and `dist`, output the distance.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys

import colour
import numpy as np
import scipy.ndimage
import skimage
import skimage.data
import trimesh
from PIL import Image
from skimage.metrics import peak_signal_noise_ratio, structural_similarity

here = pathlib.Path(__file__).parent
SIZE = 192
# A public-domain picture that scikit-image ships, and the same blurred, shifted and tinted.
reference = skimage.data.astronaut()[40 : 40 + SIZE, 130 : 130 + SIZE]
blurred = scipy.ndimage.gaussian_filter(reference.astype(float), (1.2, 1.2, 0))
distorted = np.clip(np.roll(blurred, 1, axis=1) * [0.95, 1.0, 1.06] + 4, 0, 255).round().astype(np.uint8)
Image.fromarray(reference).save(here / "reference.png")
Image.fromarray(distorted).save(here / "distorted.png")
a, b = reference / 255.0, distorted / 255.0
values = {
    "versions": {"scikit-image": skimage.__version__, "colour-science": colour.__version__, "trimesh": trimesh.__version__},
    "psnr": peak_signal_noise_ratio(a, b, data_range=1.0),
    "ssim": structural_similarity(
        a, b, data_range=1.0, channel_axis=2, gaussian_weights=True, sigma=1.5, use_sample_covariance=False
    ),
}
said = subprocess.run(["idiff", here / "reference.png", here / "distorted.png"], capture_output=True, text=True).stdout
found = re.search(r"Peak SNR = ([\d.]+)", said)
values["psnr_idiff"] = float(found.group(1)) if found else None

# Multi-scale SSIM (Wang et al. 2003) out of scikit-image's SSIM: contrast and structure are its map with C1 → ∞, which
# leaves 1 for the luminance term.
WEIGHTS = [0.0448, 0.2856, 0.3001, 0.2363, 0.1333]
per_channel = []
for k in range(3):
    x, y = a[:, :, k], b[:, :, k]
    product = 1.0
    for scale, weight in enumerate(WEIGHTS):
        last = scale == len(WEIGHTS) - 1
        term = structural_similarity(
            x, y, data_range=1.0, gaussian_weights=True, sigma=1.5, use_sample_covariance=False, K1=0.01 if last else 1e6
        )
        product *= term**weight
        half = lambda p: p[: p.shape[0] // 2 * 2, : p.shape[1] // 2 * 2].reshape(p.shape[0] // 2, 2, p.shape[1] // 2, 2).mean((1, 3))
        x, y = half(x), half(y)
    per_channel.append(product)
values["ms_ssim"] = float(np.mean(per_channel))

lab = lambda p: colour.XYZ_to_Lab(colour.sRGB_to_XYZ(p), colour.CCS_ILLUMINANTS["CIE 1931 2 Degree Standard Observer"]["D65"])
differences = colour.delta_E(lab(a), lab(b), method="CIE 2000")
values["delta_e_2000"] = float(differences.mean())
values["delta_e_2000_largest"] = float(differences.max())

# Two boxes: even samples of each surface, distances to the other's triangles.
box = trimesh.creation.box((1.2, 0.7, 0.5))
other = trimesh.creation.box((1.26, 0.66, 0.52))
other.apply_translation((0.01, 0.0, 0.02))
rng = 7
sample = lambda m: trimesh.sample.sample_surface_even(m, 20000, seed=rng)[0]
there = trimesh.proximity.closest_point(box, sample(other))[1]
back = trimesh.proximity.closest_point(other, sample(box))[1]
diagonal = float(np.linalg.norm(box.extents))
within = lambda limit: [float((d < limit * diagonal).mean()) for d in (there, back)]
f = lambda p, r: 2 * p * r / (p + r)
low, high = np.maximum(box.bounds[0], other.bounds[0]), np.minimum(box.bounds[1], other.bounds[1])
shared = float(np.prod(high - low))
values["boxes"] = {
    "chamfer_percent": float(100 * (there.mean() + back.mean()) / 2 / diagonal),
    "f1": f(*within(0.01)),
    "f2": f(*within(0.02)),
    "volume_iou": shared / (box.volume + other.volume - shared),
}
if len(sys.argv) > 1:
    import onnxruntime

    network = pathlib.Path(sys.argv[1]).read_bytes()
    mean, deviation = np.array([0.485, 0.456, 0.406]), np.array([0.229, 0.224, 0.225])
    planes = lambda p: ((p - mean) / deviation).transpose(2, 0, 1)[None].astype(np.float32)
    score = onnxruntime.InferenceSession(network).run(None, {"ref": planes(a), "dist": planes(b)})[0]
    values["lpips"] = {"score": float(np.ravel(score)[0]), "sha256": hashlib.sha256(network).hexdigest()}
(here / "values.json").write_text(json.dumps(values, indent=1) + "\n")
print(json.dumps(values, indent=1))
