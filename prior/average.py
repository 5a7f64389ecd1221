"""The weighted mean of a network's versions that were trained on from one another: often better on what none has seen than any.

    python average.py {scene|detail|splat} OUT.pt [SHARE:]A [SHARE:]B ...

A, B, ...: .onnx or .pt of a training, in any mixture; every file's batch norms are folded into the convolutions before them, as the
export does. Without shares all count alike. Layers that older versions lack are the mean of the versions that have them. For
export.py and evaluate.py.
"""

import argparse

import torch

from nets import LATER, NETS, Res, load_weights


def known(net, path):
    """The weights in the file at `path`, folded, without those of layers that its version lacks."""
    later = [name for name, _ in net.named_parameters() if name.startswith(LATER)]
    for name in later:
        net.get_parameter(name).fill_(torch.nan)
    state = folded(load_weights(net, path))
    return {name: value for name, value in state.items() if name not in later or not value.isnan().any()}


def folded(net):
    """The network's state with batch norms that only add a bias: the same function (see `restore.passing_norm`)."""
    state = {name: value.clone() for name, value in net.state_dict().items()}
    for name, block in net.named_modules():
        if not isinstance(block, Res):
            continue
        for conv, norm in (("a", block.n), ("b", block.m)):
            at = f"{name}.{'n' if conv == 'a' else 'm'}."
            gain = norm.weight / (norm.running_var + norm.eps).sqrt()
            state[f"{name}.{conv}.weight"] *= gain[:, None, None, None]
            state[at + "bias"] = norm.bias - norm.running_mean * gain
            state[at + "weight"] = torch.full_like(gain, 1 + norm.eps).sqrt()
            state[at + "running_mean"] = torch.zeros_like(gain)
            state[at + "running_var"] = torch.ones_like(gain)
    return state


def averaged(states, shares):
    """The mean of states by `shares`, which need not add up to 1, each weight's over those that have it."""

    def mean(name):
        having = [(s[name], share) for s, share in zip(states, shares, strict=True) if name in s]
        if not having[0][0].is_floating_point():
            return having[0][0]
        total = sum(share for _, share in having)
        return sum(weight * (share / total) for weight, share in having)

    return {name: mean(name) for name in {name: None for state in states for name in state}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net", choices=sorted(NETS))
    parser.add_argument("weights")
    parser.add_argument("versions", nargs="+")
    args = parser.parse_args()
    pairs = [v.split(":", 1) if ":" in v else ("1", v) for v in args.versions]
    with torch.no_grad():
        states = [known(NETS[args.net](), path) for _, path in pairs]
        torch.save(averaged(states, [float(share) for share, _ in pairs]), args.weights)
    print(args.weights)


if __name__ == "__main__":
    main()
