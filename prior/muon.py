"""Muon: steps of matrices along their orthogonalised momentum (Jordan et al. 2024), as large as AdamW's (Liu et al. 2025).

Beside AdamW, which keeps what is no matrix inside the network: norms, biases, positions, first and last layers.
"""

import torch

# The quintic Newton-Schulz iteration x -> (a + b x x' + c (x x')^2) x that brings singular values near 1.
QUINTIC = (3.4445, -4.7750, 2.0315)
ITERATIONS = 5
# Root mean square of an AdamW step over its learning rate, about.
USUAL = 0.2


def orthogonalised(matrices):
    """Matrices [k, m, n] with singular values near 1 (0.7 to 1.2) in place of their own, bfloat16."""
    a, b, c = QUINTIC
    tall = matrices.shape[1] > matrices.shape[2]
    x = (matrices / (matrices.norm(dim=(1, 2), keepdim=True) + 1e-12)).bfloat16()
    if tall:
        x = x.mT
    for _ in range(ITERATIONS):
        square = x @ x.mT
        x = a * x + (b * square + c * square @ square) @ x
    return x.mT if tall else x


class Muon(torch.optim.Optimizer):
    """Of weights [m, ...], as matrices [m, n]; those whose name in `parts` says k are k matrices on top of each other.

    named: pairs of name and parameter. A step whose gradient is not finite must be announced by `found_inf` (1.0), as fused
    AdamW has it: nothing moves then.
    """

    def __init__(self, named, lr, weight_decay=0.0, momentum=0.95, parts=None):
        parts = parts or {}
        shapes = {}
        for name, p in named:
            k = parts.get(name.rsplit(".", 2)[-2], 1)
            shapes.setdefault((k, p.shape[0] // k, p[0].numel()), []).append(p)
        groups = [{"params": params, "parts": k, "shape": (m, n)} for (k, m, n), params in shapes.items()]
        super().__init__(groups, {"lr": lr, "weight_decay": weight_decay, "momentum": momentum})
        self.found_inf = None

    @torch.no_grad()
    def step(self):
        for group in self.param_groups:
            params, (m, n) = group["params"], group["shape"]
            for p in params:
                if "momentum" not in self.state[p]:
                    self.state[p]["momentum"] = torch.zeros_like(p)
            left_out = 0.0 if self.found_inf is None else self.found_inf
            gradients = [p.grad.nan_to_num(0, 0, 0) * (1 - left_out) for p in params]
            moments = [self.state[p]["momentum"] for p in params]
            torch._foreach_lerp_(moments, gradients, 1 - group["momentum"])
            # Nesterov's look ahead.
            ahead = torch._foreach_lerp(gradients, moments, group["momentum"])
            stacked = torch.stack([a.reshape(group["parts"], m, n) for a in ahead]).flatten(0, 1)
            steps = orthogonalised(stacked).to(params[0].dtype).unflatten(0, (len(params), group["parts"]))
            scale = group["lr"] * USUAL * max(m, n) ** 0.5 * (1 - left_out)
            for p, step in zip(params, steps, strict=True):
                p.mul_(1 - group["lr"] * group["weight_decay"] * (1 - left_out))
                p.sub_(step.reshape(p.shape) * scale)
