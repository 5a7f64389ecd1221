"""A network shaped like CLIP's image encoder from outside, random inside, and what ONNX Runtime makes of two pictures.

    pip install onnx onnxruntime pillow numpy
    python make_clip.py        # writes clip.onnx beside itself and "clip" into values.json

Pictures are prepared as CLIP's own processor does: the shorter side to 224 (bicubic), the middle square, CLIP's mean and
deviation.
"""
import json
import pathlib

import numpy as np
import onnx
import onnxruntime
from onnx import TensorProto, helper, numpy_helper
from PIL import Image

here = pathlib.Path(__file__).parent
rng = np.random.default_rng(5)
weights = {
    "patches": rng.normal(0, 0.05, (8, 3, 16, 16)),
    "head": rng.normal(0, 0.5, (8, 12)),
    "bias": rng.normal(0, 0.1, 12),
}
graph = helper.make_graph(
    [
        helper.make_node(
            "Conv", ["pixel_values", "patches"], ["a"], kernel_shape=[16, 16], strides=[16, 16], dilations=[1, 1], pads=[0] * 4, group=1
        ),
        helper.make_node("Relu", ["a"], ["b"]),
        helper.make_node("GlobalAveragePool", ["b"], ["c"]),
        helper.make_node("Flatten", ["c"], ["d"]),
        helper.make_node("Gemm", ["d", "head", "bias"], ["image_embeds"]),
    ],
    "clip",
    [helper.make_tensor_value_info("pixel_values", TensorProto.FLOAT, [1, 3, 224, 224])],
    [helper.make_tensor_value_info("image_embeds", TensorProto.FLOAT, [1, 12])],
    [numpy_helper.from_array(w.astype(np.float32), name) for name, w in weights.items()],
)
model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8)
onnx.checker.check_model(model)
(here / "clip.onnx").write_bytes(model.SerializeToString())
session = onnxruntime.InferenceSession(model.SerializeToString())


def embedding(picture):
    w, h = picture.size
    small = picture.resize((round(224 * w / min(w, h)), round(224 * h / min(w, h))), Image.BICUBIC)
    x, y = (small.width - 224) // 2, (small.height - 224) // 2
    pixels = np.asarray(small.crop((x, y, x + 224, y + 224))).astype(float) / 255
    pixels = (pixels - [0.48145466, 0.4578275, 0.40821073]) / [0.26862954, 0.26130258, 0.27577711]
    out = session.run(None, {"pixel_values": pixels.transpose(2, 0, 1)[None].astype(np.float32)})[0][0]
    return out / np.linalg.norm(out)


reference = Image.open(here / "reference.png").convert("RGB")
distorted = Image.open(here / "distorted.png").convert("RGB")
# Wider than high: the middle square counts.
wide = Image.new("RGB", (400, 192), (200, 30, 30))
wide.paste(distorted, (104, 0))
a, b, c = (embedding(p) for p in (reference, distorted, wide))
values = json.loads((here / "values.json").read_text())
values["clip"] = {"cosine": float(a @ b), "cosine_wide": float(a @ c), "embedding": [float(v) for v in a]}
(here / "values.json").write_text(json.dumps(values, indent=1) + "\n")
print(values["clip"])
