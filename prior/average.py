"""Average two versions of a network, one trained on from the other: often better on what neither has seen than either.

    python average.py {scene|detail|splat} A B WEIGHTS.pt

A and B: both .onnx, where batch norms are folded, or both .pt of trainings that began alike. For export.py and evaluate.py.
"""

import argparse

import torch

from nets import NETS, load_weights


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net", choices=sorted(NETS))
    parser.add_argument("a")
    parser.add_argument("b")
    parser.add_argument("weights")
    args = parser.parse_args()
    a, b = (load_weights(NETS[args.net](), path).state_dict() for path in (args.a, args.b))
    torch.save({name: (a[name] + b[name]) / 2 if a[name].is_floating_point() else a[name] for name in a}, args.weights)
    print(args.weights)


if __name__ == "__main__":
    main()
