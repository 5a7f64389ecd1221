"""Recover PyTorch weights from an exported ONNX file, to evaluate or train on.

    python restore.py {scene|detail|splat} FILE.onnx WEIGHTS.pt [--calibrate]

The export folds every batch norm into the convolution before it, so the restored norms pass their input through and
only add the folded bias: the same function, but one that training could not go on from, because norms in training
use each batch's own statistics. `--calibrate` measures those statistics on generated views and puts them
back, with gains that undo them: the function stays, and training goes on from it. Without it, use the weights to
evaluate and export only. The result is compared with ONNX Runtime, where that is installed.
"""

import argparse

import numpy as np
import onnx
import torch
import torch.nn.functional as F
from torch import nn

from export import Detail, Scene, Splat
from nets import NETS, SplatNet, grown
from packing import module_path, stored_values

LAYERS = ("Conv", "MatMul", "Gemm", "LayerNormalization")
# Which batch norm was folded into a block's convolution a or b.
NORM_OF = {"a": "n", "b": "m"}
WRAPPERS = {"scene": Scene, "detail": Detail, "splat": Splat}


def weights_by_module(graph):
    """{module path: [weight, bias]} of every layer in the graph, matrices as PyTorch stores them ([out, in])."""
    values = stored_values(graph)
    layers = {}
    for node in graph.node:
        if node.op_type not in LAYERS or node.input[1] not in values:
            continue
        weights = [values[name] for name in node.input[1:] if name in values]
        if node.op_type == "MatMul":
            weights[0] = weights[0].T
        layers[module_path(node.name)] = weights
    # A convolution in two (`enlarged`): its weights are split, and its bias is that of one half.
    for node in graph.node:
        if node.op_type == "Split" and node.input[0] in values:
            layers[module_path(node.name)] = [values[node.input[0]]]
    for node in graph.node:
        if node.op_type == "Conv" and node.name.endswith("/Conv_beside"):
            layers[module_path(node.name)].append(values[node.input[2]])
    # A matrix product's bias is a separate addition of the same module.
    for node in graph.node:
        layer = layers.get(module_path(node.name))
        if node.op_type == "Add" and layer is not None and len(layer) == 1:
            layer.extend(values[name] for name in node.input if name in values)
    return layers


def state_from_onnx(path, net):
    """A state dict for `net` from the ONNX file; batch norms pass through and add the folded bias.

    The file may hold a shallower version of `net` (see `nets.grown`).
    """
    graph = onnx.load(path).graph
    values = stored_values(graph)
    state = {name: values["n." + name] for name in ("net.pos", "net.pos_near", "held.pos") if "n." + name in values}
    modules = dict(net.named_modules())
    for name, weights in weights_by_module(graph).items():
        state[name + ".weight"] = weights[0]
        parent, _, last = name.rpartition(".")
        norm = f"{parent}.{NORM_OF.get(last, '')}"
        if isinstance(modules.get(norm), nn.BatchNorm2d):
            state |= passing_norm(norm, weights[1], modules[norm].eps)
        else:
            state[name + ".bias"] = weights[1]
    return grown(net, {name: torch.from_numpy(np.array(value)) for name, value in state.items()})


def passing_norm(name, bias, eps):
    """Parameters of a batch norm that in evaluation adds `bias` and does nothing else."""
    ones = np.ones_like(bias)
    return {
        name + ".weight": ones * np.float32(np.sqrt(1 + eps)),
        name + ".bias": bias,
        name + ".running_mean": np.zeros_like(bias),
        name + ".running_var": ones,
        name + ".num_batches_tracked": np.array(0),
    }


@torch.no_grad()
def calibrate(net, inputs):
    """Give the batch norms the statistics of their inputs over `inputs` (batches), keeping the function.

    y = x + bias becomes y = (x - mean) / sqrt(var + eps) * sqrt(var + eps) + (mean + bias).
    """
    norms = [m for m in net.modules() if isinstance(m, nn.BatchNorm2d)]
    sums = {norm: [0.0, 0.0, 0] for norm in norms}

    def measure(norm, args):
        x = args[0].double()
        sums[norm][0] += x.sum((0, 2, 3))
        sums[norm][1] += (x * x).sum((0, 2, 3))
        sums[norm][2] += x[:, 0].numel()

    hooks = [norm.register_forward_pre_hook(measure) for norm in norms]
    net.eval()
    for batch in inputs:
        net(batch)
    for hook in hooks:
        hook.remove()
    for norm, (total, squares, count) in sums.items():
        mean = total / count
        variance = (squares / count - mean * mean).clamp(min=0)
        norm.running_mean.copy_(mean)
        norm.running_var.copy_(variance)
        norm.weight.copy_((variance + norm.eps).sqrt())
        norm.bias.copy_(norm.bias + mean)


def generated_inputs(which, pool, batches, batch=32, masks=None):
    """Inputs of network `which` from the objects of `pool`; `masks`, for DetailNet: `synth.details.detail_batch`."""
    from synth.batches import scene_batch, splat_batch
    from synth.details import detail_batch

    for _ in range(batches):
        if which == "scene":
            made = scene_batch(pool, batch)
            yield torch.cat([made.photo, made.point], 1)
        elif which == "detail":
            made = detail_batch(pool, batch, masks)
            yield torch.cat([made.photo, made.rough], 1)
        else:
            yield splat_batch(pool, batch, SplatNet.FOV, SplatNet.DIST, views=2).rgba


def as_taken_now(example, which):
    """An input of an older version of network `which` as this one takes it."""
    if which == "scene" and example.shape[1] == 3:  # 0.1 took no point
        return F.pad(example, (0, 0, 0, 0, 0, 1))
    if which == "splat" and example.shape[3] < SplatNet.SIZE:  # up to 0.7 crops were as coarse as the Gaussians
        return F.interpolate(example, scale_factor=2.0)
    return example


def compare(which, net, path, seed=0):
    """Print the largest difference of every output between `net` and ONNX Runtime on one input."""
    try:
        import onnxruntime
    except ImportError:
        print("not compared: onnxruntime is not installed")
        return
    session = onnxruntime.InferenceSession(path, providers=["CPUExecutionProvider"])
    generator = torch.Generator().manual_seed(seed)
    examples = [torch.rand(source.shape, generator=generator) for source in session.get_inputs()]
    ours_too = [as_taken_now(examples[0], which), *examples[1:]]
    if which == "splat":
        # It took no hint before 0.18, and none of the lens before 0.26.
        hint = examples[1] if len(examples) > 1 else torch.zeros(1, 0)
        ours_too[1:] = [F.pad(hint, (0, 3 - hint.shape[1]))]
    wrapped = WRAPPERS[which](net.cpu().float()).eval()
    with torch.no_grad():
        ours = wrapped(*ours_too)
    theirs = session.run(None, {source.name: e.numpy() for source, e in zip(session.get_inputs(), examples, strict=True)})
    # SplatNet 0.2 gave an elevation without its spread, and no camera.
    for output, a, b in zip(session.get_outputs(), ours, theirs, strict=False):
        a = a.numpy() if list(a.shape) == list(b.shape) else a.numpy()[:, 0]
        difference = np.abs(a - b).max()
        print(f"{output.name} {list(b.shape)}: largest difference {difference:.2e} of {np.abs(b).max():.2e}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("net", choices=sorted(NETS))
    parser.add_argument("onnx")
    parser.add_argument("weights")
    parser.add_argument("--calibrate", action="store_true", help="make the batch norms fit to train on")
    args = parser.parse_args()
    net = NETS[args.net]()
    net.load_state_dict(state_from_onnx(args.onnx, net))
    if args.calibrate:
        from synth.batches import make_pool

        device = "cuda" if torch.cuda.is_available() else "cpu"
        torch.manual_seed(0)
        calibrate(net.to(device), generated_inputs(args.net, make_pool(0, 2000, 4, device, textures=48), batches=16))
    compare(args.net, net, args.onnx)
    torch.save(net.state_dict(), args.weights)
    print(args.weights)


if __name__ == "__main__":
    main()
