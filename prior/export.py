"""Export trained weights to ONNX, stored as `packing` does.

python export.py {scene|detail|splat} WEIGHTS OUT.onnx [--part PART_WEIGHTS.pt]

WEIGHTS: .pt of a training, or .onnx of this or an older version. --part: what learned alone (`train.py error`, `train.py held`), from
that training; all else stays as it is.
"""

import argparse
import os

import torch

from nets import NETS, PARTS, load_weights
from packing import FOUR_BITS, pack

OPSET = 17

SCENE_OUTPUTS = ["mask", "inverse_depth", "elevation", "roll"]
DETAIL_OUTPUTS = ["mask", "inverse_depth"]
SPLAT_OUTPUTS = ["position", "scale", "rotation", "opacity", "color", "elevation", "camera", "error"]


class Scene(torch.nn.Module):
    """image [1, 4, 256, 256], photo and point -> mask 0..1, inverse depth, [1, 1, 256, 256] each, elevation and roll,
    [1, 2] each."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, image):
        logits, depth, elevation, held = self.n(image)
        return torch.sigmoid(logits), depth, elevation, held[:, 2:]


class Detail(torch.nn.Module):
    """image [1, 4, 384, 384], photo and rough mask -> mask 0..1, inverse depth, [1, 1, 384, 384] each."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, image):
        logits, depth = self.n(image)
        return torch.sigmoid(logits), depth


class Splat(torch.nn.Module):
    """rgba [1, 4, 256, 256], hint [1, 3] -> the Gaussians as a tuple in the order of SPLAT_OUTPUTS."""

    def __init__(self, net):
        super().__init__()
        self.n = net

    def forward(self, rgba, hint):
        out = self.n(rgba, hint)
        return tuple(out[name] for name in ("pos", "scale", "quat", "opacity", "rgb", "elevation", "camera", "error"))


def export(wrapped, examples, path, input_names, output_names, four_bits=()):
    wrapped.eval()
    with torch.no_grad():
        torch.onnx.export(
            wrapped,
            examples,
            path,
            input_names=input_names,
            output_names=output_names,
            opset_version=OPSET,
            dynamo=False,
            do_constant_folding=True,
        )
    pack(path, four_bits)
    print(path, os.path.getsize(path), "bytes")


# Of each network: what wraps it, and the names of its inputs and outputs.
GRAPHS = {
    "scene": (Scene, ["image"], SCENE_OUTPUTS),
    "detail": (Detail, ["image"], DETAIL_OUTPUTS),
    "splat": (Splat, ["rgba", "hint"], SPLAT_OUTPUTS),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net", choices=sorted(GRAPHS))
    parser.add_argument("weights")
    parser.add_argument("out")
    parser.add_argument("--part", default="")
    args = parser.parse_args()
    net = load_weights(NETS[args.net](), args.weights)
    if args.part:
        learned = torch.load(args.part, map_location="cpu", weights_only=True)
        part = {k: v.float() if v.is_floating_point() else v for k, v in learned.items() if k.split(".")[0] in PARTS.values()}
        net.load_state_dict(net.state_dict() | part)
    wrapper, sources, outputs = GRAPHS[args.net]
    examples = (torch.rand(1, 4, net.SIZE, net.SIZE), torch.full((1, 3), 0.2))[: len(sources)]
    export(wrapper(net), examples, args.out, sources, outputs, FOUR_BITS.get(args.net, ()))


if __name__ == "__main__":
    main()
