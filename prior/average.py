"""Average two versions of a network, one trained on from the other: often better on what neither has seen than either.

    python average.py {scene|splat} A.onnx B.onnx WEIGHTS.pt

Batch norms are folded in ONNX files, so that the weights of both mean the same. For export.py and evaluate.py.
"""

import argparse

import torch

from nets import NETS
from restore import state_from_onnx


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net", choices=sorted(NETS))
    parser.add_argument("a")
    parser.add_argument("b")
    parser.add_argument("weights")
    args = parser.parse_args()
    net = NETS[args.net]()
    a, b = state_from_onnx(args.a, net), state_from_onnx(args.b, net)
    torch.save({name: (a[name] + b[name]) / 2 if a[name].is_floating_point() else a[name] for name in a}, args.weights)
    print(args.weights)


if __name__ == "__main__":
    main()
