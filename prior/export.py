"""Export trained weights to ONNX: weights stored as int8 or float16, arithmetic in float32.

python export.py {scene|detail|splat} WEIGHTS OUT.onnx [--error ERROR_WEIGHTS.pt]

WEIGHTS: .pt of a training, or .onnx of this or an older version. --error: SplatNet's expected error from another training
(`train.py error`) than all else of it.
"""

import argparse
import os

import numpy as np
import onnx
import torch
from onnx import TensorProto, helper, numpy_helper

from nets import NETS, load_weights

OPSET = 17
# Smaller tensors (biases, norms) stay float32.
PACK_FROM = 1024

SCENE_OUTPUTS = ["mask", "inverse_depth", "elevation"]
DETAIL_OUTPUTS = ["mask", "inverse_depth"]
SPLAT_OUTPUTS = ["position", "scale", "rotation", "opacity", "color", "elevation", "camera", "error"]


class Scene(torch.nn.Module):
    """image [1, 4, 256, 256], photo and point -> mask 0..1, inverse depth, [1, 1, 256, 256] each, elevation [1, 2]."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, image):
        logits, depth, elevation = self.n(image)
        return torch.sigmoid(logits), depth, elevation


class Detail(torch.nn.Module):
    """image [1, 4, 384, 384], photo and rough mask -> mask 0..1, inverse depth, [1, 1, 384, 384] each."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, image):
        logits, depth = self.n(image)
        return torch.sigmoid(logits), depth


class Splat(torch.nn.Module):
    """rgba [1, 4, 256, 256] -> the Gaussians as a tuple in the order of SPLAT_OUTPUTS."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, rgba):
        out = self.n(rgba)
        return tuple(out[name] for name in ("pos", "scale", "quat", "opacity", "rgb", "elevation", "camera", "error"))


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


# Of each network: what wraps it, and the names of its input and outputs.
GRAPHS = {
    "scene": (Scene, "image", SCENE_OUTPUTS),
    "detail": (Detail, "image", DETAIL_OUTPUTS),
    "splat": (Splat, "rgba", SPLAT_OUTPUTS),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net", choices=sorted(GRAPHS))
    parser.add_argument("weights")
    parser.add_argument("out")
    parser.add_argument("--error", default="")
    args = parser.parse_args()
    net = load_weights(NETS[args.net](), args.weights)
    if args.error:
        learned = torch.load(args.error, map_location="cpu", weights_only=True)
        net.load_state_dict({k: v.float() for k, v in learned.items() if k.startswith("er.")}, strict=False)
    wrapper, source, outputs = GRAPHS[args.net]
    export(wrapper(net), torch.rand(1, 4, net.SIZE, net.SIZE), args.out, source, outputs)


if __name__ == "__main__":
    main()
