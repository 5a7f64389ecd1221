"""Export trained weights to ONNX: weights stored as int8 or float16, arithmetic in float32.

python export.py SCENE_WEIGHTS.pt SPLAT_WEIGHTS.pt OUT_DIR
"""

import argparse
import os

import numpy as np
import onnx
import torch
from onnx import TensorProto, helper, numpy_helper

from nets import SceneNet, SplatNet, load_weights

OPSET = 17
# Smaller tensors (biases, norms) stay float32.
PACK_FROM = 1024

SCENE_OUTPUTS = ["mask", "inverse_depth", "elevation"]
SPLAT_OUTPUTS = ["position", "scale", "rotation", "opacity", "color", "elevation", "camera"]


class Scene(torch.nn.Module):
    """image [1, 4, 256, 256], photo and point -> mask 0..1, inverse depth, [1, 1, 256, 256] each, elevation [1, 2]."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, image):
        logits, depth, elevation = self.n(image)
        return torch.sigmoid(logits), depth, elevation


class Splat(torch.nn.Module):
    """rgba [1, 4, 128, 128] -> the Gaussians as a tuple in the order of SPLAT_OUTPUTS."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, rgba):
        out = self.n(rgba)
        return tuple(out[name] for name in ("pos", "scale", "quat", "opacity", "rgb", "elevation", "camera"))


def pack(path):
    """Store the large weights of the ONNX file as int8 with one scale an output channel, others as float16.

    A Cast, and for int8 a Mul, before its use turns each back; runtimes do that once, when they load the file. (Not
    DequantizeLinear: ONNX Runtime takes it as leave to round activations as well.)
    """
    model = onnx.load(path)
    users = {name: node for node in model.graph.node for name in node.input}
    opened, scales = [], []
    for tensor in model.graph.initializer:
        if tensor.data_type != TensorProto.FLOAT or np.prod(tensor.dims) < PACK_FROM:
            continue
        name, user = tensor.name, users[tensor.name]
        values = numpy_helper.to_array(tensor)
        if user.op_type not in ("Conv", "Gemm", "MatMul") or name.startswith("n.net.head"):
            tensor.CopyFrom(numpy_helper.from_array(values.astype(np.float16), name + "_f16"))
            opened.append(helper.make_node("Cast", [name + "_f16"], [name], to=TensorProto.FLOAT))
            continue
        axis = values.ndim - 1 if user.op_type == "MatMul" else 0
        others = tuple(i for i in range(values.ndim) if i != axis)
        scale = np.maximum(np.abs(values).max(others) / 127, 1e-12).astype(np.float32)
        shape = [-1 if i == axis else 1 for i in range(values.ndim)]
        scale = scale.reshape(shape)
        tensor.CopyFrom(numpy_helper.from_array(np.round(values / scale).astype(np.int8), name + "_i8"))
        scales.append(numpy_helper.from_array(scale, name + "_scale"))
        opened.append(helper.make_node("Cast", [name + "_i8"], [name + "_whole"], to=TensorProto.FLOAT))
        opened.append(helper.make_node("Mul", [name + "_whole", name + "_scale"], [name]))
    model.graph.initializer.extend(scales)
    nodes = opened + list(model.graph.node)
    del model.graph.node[:]
    model.graph.node.extend(nodes)
    onnx.checker.check_model(model)
    onnx.save(model, path)


def export(wrapped, example, path, input_name, output_names):
    wrapped.eval()
    with torch.no_grad():
        torch.onnx.export(
            wrapped,
            (example,),
            path,
            input_names=[input_name],
            output_names=output_names,
            opset_version=OPSET,
            dynamo=False,
            do_constant_folding=True,
        )
    pack(path)
    print(path, os.path.getsize(path), "bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("splat")
    parser.add_argument("out_dir")
    args = parser.parse_args()
    os.makedirs(args.out_dir, exist_ok=True)
    scene = Scene(load_weights(SceneNet(), args.scene))
    image = torch.rand(1, 4, SceneNet.SIZE, SceneNet.SIZE)
    export(scene, image, os.path.join(args.out_dir, "scene.onnx"), "image", SCENE_OUTPUTS)
    splat = Splat(load_weights(SplatNet(), args.splat))
    rgba = torch.rand(1, 4, SplatNet.SIZE, SplatNet.SIZE)
    export(splat, rgba, os.path.join(args.out_dir, "splat.onnx"), "rgba", SPLAT_OUTPUTS)


if __name__ == "__main__":
    main()
