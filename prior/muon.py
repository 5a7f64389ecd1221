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
            params, parts, (m, n) = group["params"], group["parts"], group["shape"]
            left_out = 0.0 if self.found_inf is None else self.found_inf
            gradients = torch.stack([p.grad.reshape(parts, m, n) for p in params]).flatten(0, 1).nan_to_num(0, 0, 0) * (1 - left_out)
            # One tensor for all matrices of a shape, kept with the first: a step is a few kernels a shape, not a matrix.
            state = self.state[params[0]]
            if "momentum" not in state:
                state["momentum"] = torch.zeros_like(gradients)
            momentum = state["momentum"].lerp_(gradients, 1 - group["momentum"])
            # Nesterov's look ahead.
            steps = orthogonalised(gradients.lerp(momentum, group["momentum"])).to(gradients.dtype)
            steps *= group["lr"] * USUAL * max(m, n) ** 0.5 * (1 - left_out)
            kept = 1 - group["lr"] * group["weight_decay"] * (1 - left_out)
            torch._foreach_mul_(params, kept)
            torch._foreach_sub_(params, [s.reshape(p.shape) for p, s in zip(params, steps.split(parts), strict=True)])
