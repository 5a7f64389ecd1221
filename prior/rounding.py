"""Round SplatNet's transformers to four bits so that what they answer changes least.

    python rounding.py WEIGHTS OUT.pt [--crops 128] [--seed 0] [--device cpu]

WEIGHTS: .pt of a training, or .onnx. OUT.pt: for export.py, which stores its matrices without any further error. Each matrix is rounded
input by input, and what an input's weights lose the weights of those that come after it make up for, as far as inputs go together
(GPTQ, Frantar et al. 2023, algorithm 1); how they go together is seen on generated crops that no training draws, block after block,
with the blocks before already rounded. What these have lost a layer makes up for as well, by its biases too, as far as it can be told
from what the layer gets. Half an hour for 128 crops on two cores that have other work; --device cuda takes a GPU.
"""

import argparse
import copy
from collections import namedtuple

import torch

from nets import SplatNet, load_weights
from packing import LEVELS, SCALES, group_width

# Of the mean of its diagonal, what is added to a matrix of second moments before it is inverted.
DAMPING = 0.01
CROPS_AT_ONCE = 16
POOL = 1000  # objects, all of which no training draws


def rounded(matrix, moments):
    """A matrix [in, out] with numbers that `packing.in_four_bits` stores as they are. moments [in, in]: sums of products of two inputs."""
    levels, scales = (torch.from_numpy(numbers).to(matrix.device) for numbers in (LEVELS, SCALES))
    between = (levels[1:] + levels[:-1]) / 2
    left = matrix.double().clone()
    inverse = torch.linalg.cholesky(torch.cholesky_inverse(torch.linalg.cholesky(damped(moments))), upper=True)
    result = torch.empty_like(matrix, dtype=torch.float32)
    width = group_width(len(matrix))

    def nearest(values, scale):
        return levels[torch.bucketize((values / scale).contiguous(), between)] * scale

    for start in range(0, len(matrix), width):
        group = left[start : start + width].float()
        tried = (group.abs().amax(0).clamp(min=1e-6) * scales[:, None]).half().float()
        errors = torch.stack([((nearest(group, scale) - group) ** 2).sum(0) for scale in tried])
        scale = tried.gather(0, errors.argmin(0, keepdim=True))[0]
        for i in range(start, start + len(group)):
            result[i] = nearest(left[i].float(), scale)
            lost = (left[i] - result[i]) / inverse[i, i]
            left[i + 1 :] -= inverse[i, i + 1 :, None] * lost
    return result


def damped(moments):
    """Moments that can be inverted, [n, n] float64."""
    return moments.double() + DAMPING * moments.diagonal().mean() * torch.eye(len(moments), dtype=torch.float64, device=moments.device)


@torch.no_grad()
def round_blocks(blocks, tokens, exact):
    """Round the matrices of transformer `blocks` in place.

    tokens: what the first one gets, a list of [B, N, C]; exact: what it would get if nothing before it were rounded, alike.
    """
    for block in blocks:
        unrounded = copy.deepcopy(block)
        for name in ("qkv", "o", "f.0", "f.2"):
            layer = block.get_submodule(name)
            moments, wanted, means = 0, 0, 0
            for x, y in zip(tokens, exact):
                got, aim = seen_by(name, block, x), seen_by(name, unrounded, y)
                # What is added to the tokens makes up for what they have lost as well.
                target = aim.answer + aim.residual - got.residual - layer.bias
                moments += got.input.T @ got.input
                wanted += got.input.T @ target
                means += torch.cat([got.input.mean(0), target.mean(0)]) / len(tokens)
            matrix = rounded(fitted(layer.weight.T, moments, wanted), moments)
            layer.weight.copy_(matrix.T)
            layer.bias += means[len(matrix) :] - means[: len(matrix)] @ matrix
        tokens, exact = [block(x) for x in tokens], [unrounded(y) for y in exact]


def fitted(matrix, moments, wanted):
    """The matrix [in, out] whose answers to inputs of these moments come nearest to what is wanted of them.

    moments [in, in] and wanted [in, out]: sums of products of inputs, and of inputs and wanted answers. Least squares, drawn to `matrix` by
    the same damping as in `rounded` (Li et al. 2025, GPTAQ: what has been rounded before is seen by the layers after it).
    """
    lacking = wanted.double() - moments.double() @ matrix.double()
    return (matrix + torch.cholesky_solve(lacking, torch.linalg.cholesky(damped(moments)))).float()


Seen = namedtuple("Seen", "input answer residual")


def seen_by(name, block, tokens):
    """What layer `name` of `block` gets of `tokens` [B, N, C] and answers, and what its answer is added to (0 where to nothing), [B N, C]."""
    seen = {}

    def keep(module, args, answer):
        seen[module] = args[0].flatten(0, 1), answer.flatten(0, 1)

    beside = {"o": block.n1, "f.2": block.n2}.get(name)
    layer = block.get_submodule(name)
    hooks = [module.register_forward_hook(keep) for module in (layer, beside) if module]
    block(tokens)
    for hook in hooks:
        hook.remove()
    return Seen(*seen[layer], seen[beside][0] if beside else 0)


@torch.no_grad()
def inputs_of(block, net, batches):
    """What `block` of SplatNet `net` gets of each (crops, hints) of `batches`."""
    seen = []
    hook = block.register_forward_pre_hook(lambda _, args: seen.append(args[0]))
    for rgba, hint in batches:
        net(rgba, hint)
    hook.remove()
    return seen


def generated(crops, seed, device):
    """Pairs of crops and hints on `device` as SplatNet learns from, of objects of seeds below one million."""
    from synth.batches import make_pool, splat_batch

    torch.manual_seed(seed)
    pool = make_pool(600_000, POOL, 2, device, textures=48)
    made = (splat_batch(pool, CROPS_AT_ONCE, SplatNet.FOV, SplatNet.DIST, views=2) for _ in range(-(-crops // CROPS_AT_ONCE)))
    return [(batch.rgba, batch.hint) for batch in made]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("weights")
    parser.add_argument("out")
    parser.add_argument("--crops", type=int, default=128)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--device", default="cpu")
    args = parser.parse_args()
    net = load_weights(SplatNet(), args.weights).to(args.device).eval()
    batches = generated(args.crops, args.seed, args.device)
    grids = net.net.mid, net.net.near
    exact = [inputs_of(blocks[0], net, batches) for blocks in grids]
    # The finer grid's blocks are given what the rounded ones of the coarser grid make.
    for blocks, inputs in zip(grids, exact):
        round_blocks(blocks, inputs_of(blocks[0], net, batches), inputs)
    torch.save(net.cpu().state_dict(), args.out)
    print(args.out)


if __name__ == "__main__":
    main()
