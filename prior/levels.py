"""Matrices that stay at the levels in which they are stored (`packing`) while the scales of their groups learn.

What rounding cost a network it can learn to do without, since all that is not in four bits goes on learning beside the scales
(Chen et al. 2024, EfficientQAT, section 3.3).
"""

import torch
import torch.nn.functional as F
from torch import nn

from packing import from_four_bits, in_four_bits

# How many times as fast as other parameters the logarithms of scales learn: a scale's share of itself is what counts.
QUICK = 3.0


class Levelled(nn.Module):
    """The linear layer that `linear` is when it is stored in four bits; its groups' gains, 0 at first, and its bias learn."""

    def __init__(self, linear):
        super().__init__()
        numbers, scale = in_four_bits(linear.weight.detach().T.numpy())
        self.register_buffer("stored", torch.from_numpy(from_four_bits(numbers, scale)).reshape(len(numbers), -1, linear.out_features))
        # One dimension, as all that is no matrix has in training.
        self.gain = nn.Parameter(torch.zeros(scale.size))
        self.bias = linear.bias

    def forward(self, x):
        return F.linear(x, matrix(self.stored, self.gain), self.bias)


def matrix(stored, gain):
    """The weights [out, in] of groups [groups, width, out] whose scales have grown by `gain` [groups * out]."""
    grown = torch.exp(QUICK * gain).reshape(len(stored), 1, -1)
    return (stored * grown).flatten(0, 1).T


def hold_levels(net, modules):
    """Replace every linear layer of `net` below one of the paths `modules`, in place."""
    layers = [name for name, m in net.named_modules() if isinstance(m, nn.Linear) and name.startswith(modules)]
    for name in layers:
        parent, _, last = name.rpartition(".")
        setattr(net.get_submodule(parent), last, Levelled(net.get_submodule(name)))


def settled(state):
    """The state dict of a network with such layers as that of one with linear layers."""
    made = {}
    for name, value in state.items():
        at, _, last = name.rpartition(".")
        if last == "gain":
            made[at + ".weight"] = matrix(state[at + ".stored"], value)
        elif last != "stored":
            made[name] = value
    return made
