"""How unlike two pictures look to DetailNet (SplatNet's training alone)."""

import torch
import torch.nn.functional as F
from torch import nn

from average import folded
from nets import DetailNet, Res, load_weights, way_down

# Of each level of DetailNet's way down that is compared, from the finest: nothing of the two finest, which see what pixels see.
LEVEL_WEIGHTS = (0, 0, 1, 1, 2)
# How much larger it looks at pictures than they are.
LARGER = 2


class Perception(nn.Module):
    """DetailNet's way down, which learns no more. Features that a network uses to see with tell what looks alike better than pixels
    do (Zhang et al. 2018, whose network has learned from photographs; this one has seen generated scenes alone)."""

    def __init__(self, path):
        """path: DetailNet's weights, .onnx or .pt."""
        super().__init__()
        net = load_weights(DetailNet(), path)
        with torch.no_grad():
            net.load_state_dict(folded(net))
        self.stem, self.down = net.net.stem, net.net.down
        for block in self.down.modules():
            if isinstance(block, Res):
                for conv, norm in ((block.a, "n"), (block.b, "m")):
                    conv.bias = getattr(block, norm).bias
                    setattr(block, norm, nn.Identity())
        self.requires_grad_(False)

    def features(self, views):
        """Views [n, 4, S, S], colours over a backdrop and coverage, 0..1 -> the compared levels, [n, C, s, s] each, of length 1 at every pixel."""
        larger = F.interpolate(views, scale_factor=float(LARGER), mode="bilinear")
        levels = way_down(self.down, self.stem((larger * 2 - 1).contiguous(memory_format=torch.channels_last)))
        return [F.normalize(x.float(), dim=1, eps=1e-4) for x, weight in zip(levels, LEVEL_WEIGHTS, strict=True) if weight]

    def forward(self, answer, truth):
        """How unlike the views answer and truth [n, 4, S, S] look, [n]: 0 where they are the same, 8 where they have no feature in common."""
        with torch.autocast(answer.device.type, torch.bfloat16):
            with torch.no_grad():
                goal = self.features(truth)
            made = self.features(answer)
        weights = [w for w in LEVEL_WEIGHTS if w]
        return sum(w * ((a - b) ** 2).sum(1).mean((1, 2)) for w, a, b in zip(weights, made, goal, strict=True))
