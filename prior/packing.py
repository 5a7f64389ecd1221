"""How weights are stored in an ONNX file: in four or eight bits or as float16; arithmetic is in float32.

A few nodes turn each tensor back before its use; runtimes do that once, when they load the file. (Not DequantizeLinear: ONNX
Runtime takes it as leave to round activations as well.)
"""

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from enlarged import rewritten

# Smaller tensors (biases, norms) stay float32.
PACK_FROM = 1024
# Of each network, what is stored in four bits, a weight as one of 16 levels times the scale of its group of inputs: SplatNet's transformers.
FOUR_BITS = {"splat": ("net.mid.", "net.near.")}
GROUP = 64
# Those of least squared error for SplatNet 0.14's weights, each group over its scale (Lloyd 1982), made symmetric.
LEVELS = np.array([0.048, 0.164, 0.288, 0.420, 0.559, 0.715, 0.908, 1.196], np.float32)
LEVELS = np.concatenate([-LEVELS[::-1], LEVELS])
# The two levels of each byte, [256, 2], the one in its upper half first.
PAIRS = np.stack([LEVELS[np.arange(256) >> 4], LEVELS[np.arange(256) & 15]], 1)
# Of the largest weight of a group, what its scale may be: the one of least error is taken. Those by which the largest is at a level
# find again what was rounded before (`rounding`).
SCALES = np.concatenate([np.arange(0.55, 1.11, 0.05, dtype=np.float32), 1 / LEVELS[8:]])


def pack(path, four_bits=()):
    """Store the large weights of the ONNX file in four bits in matrices of modules whose path begins with one of `four_bits`, as int8 with
    one scale an output channel in other matrices and convolutions, the rest as float16."""
    model = onnx.load(path)
    users = {name: node for node in model.graph.node for name in node.input}
    opened, more = [], {}
    for tensor in model.graph.initializer:
        if tensor.data_type != TensorProto.FLOAT or np.prod(tensor.dims) < PACK_FROM:
            continue
        name, user = tensor.name, users[tensor.name]
        values = numpy_helper.to_array(tensor)
        if user.op_type not in ("Conv", "Gemm", "MatMul") or name.startswith("n.net.head"):
            tensor.CopyFrom(numpy_helper.from_array(values.astype(np.float16), name + "_f16"))
            opened.append(helper.make_node("Cast", [name + "_f16"], [name], to=TensorProto.FLOAT))
            continue
        if user.op_type == "MatMul" and module_path(user.name).startswith(four_bits):
            numbers, scale = in_four_bits(values)
            tensor.CopyFrom(numpy_helper.from_array(numbers, name + "_u4"))
            more[name + "_scale"] = scale
            opened += four_bit_nodes(name, numbers.shape, more)
            continue
        axis = values.ndim - 1 if user.op_type == "MatMul" else 0
        others = tuple(i for i in range(values.ndim) if i != axis)
        scale = np.maximum(np.abs(values).max(others, keepdims=True) / 127, 1e-12).astype(np.float32)
        tensor.CopyFrom(numpy_helper.from_array(np.round(values / scale).astype(np.int8), name + "_i8"))
        more[name + "_scale"] = scale
        opened.append(helper.make_node("Cast", [name + "_i8"], [name + "_whole"], to=TensorProto.FLOAT))
        opened.append(helper.make_node("Mul", [name + "_whole", name + "_scale"], [name]))
    model.graph.initializer.extend(numpy_helper.from_array(value, name) for name, value in more.items())
    nodes = opened + list(model.graph.node)
    del model.graph.node[:]
    model.graph.node.extend(nodes)
    onnx.save(rewritten(model), path)


def group_width(inputs):
    """How many of a matrix's inputs share a scale."""
    return GROUP if inputs % GROUP == 0 else 32


def in_four_bits(values):
    """A matrix [in, out] as numbers of `LEVELS`, two to a byte, [in / GROUP, GROUP, out / 2] uint8, and the scales of groups,
    [in / GROUP, 1, out] float16."""
    rows, columns = values.shape
    width = group_width(rows)
    groups = values.reshape(rows // width, width, columns)
    between = (LEVELS[1:] + LEVELS[:-1]) / 2
    largest = np.maximum(np.abs(groups).max(1, keepdims=True), 1e-6)
    least, scale = np.full(largest.shape, np.inf), largest.astype(np.float16)
    numbers = np.zeros(groups.shape, np.uint8)
    for share in SCALES:
        tried = (largest * share).astype(np.float16)
        found = np.searchsorted(between, groups / tried.astype(np.float32)).astype(np.uint8)
        error = ((LEVELS[found] * tried.astype(np.float32) - groups) ** 2).sum(1, keepdims=True)
        better = error < least
        least, scale = np.where(better, error, least), np.where(better, tried, scale)
        numbers = np.where(better, found, numbers)
    return numbers[:, :, 0::2] << 4 | numbers[:, :, 1::2], scale


def from_four_bits(numbers, scale):
    """The matrix [in, out] float32 that `in_four_bits` stored so."""
    groups = PAIRS[numbers].reshape(*numbers.shape[:2], -1) * scale.astype(np.float32)
    return groups.reshape(-1, groups.shape[2])


def four_bit_nodes(name, shape, constants):
    """The nodes that do what `from_four_bits` does with `name`_u4 of `shape` and `name`_scale; what they need besides goes into
    `constants`."""
    groups, width, half = shape
    constants["four_bit_pairs"] = PAIRS
    constants[f"groups_{groups}_{width}_{half}"] = np.array([groups, width, 2 * half])
    constants[f"matrix_{groups * width}_{half}"] = np.array([groups * width, 2 * half])
    return [
        helper.make_node("Cast", [name + "_u4"], [name + "_byte"], to=TensorProto.INT32),
        helper.make_node("Gather", ["four_bit_pairs", name + "_byte"], [name + "_pairs"], axis=0),
        helper.make_node("Reshape", [name + "_pairs", f"groups_{groups}_{width}_{half}"], [name + "_levels"]),
        helper.make_node("Cast", [name + "_scale"], [name + "_scales"], to=TensorProto.FLOAT),
        helper.make_node("Mul", [name + "_levels", name + "_scales"], [name + "_groups"]),
        helper.make_node("Reshape", [name + "_groups", f"matrix_{groups * width}_{half}"], [name]),
    ]


def stored_values(graph):
    """All weights by the name under which nodes read them, as float32: packed ones turned back."""
    values = {t.name: numpy_helper.to_array(t) for t in graph.initializer}
    for name in [name.removesuffix("_u4") for name in values if name.endswith("_u4")]:
        values[name] = from_four_bits(values[name + "_u4"], values[name + "_scale"])
    for node in graph.node:
        if node.op_type in ("Cast", "Identity") and node.input[0] in values:
            values[node.output[0]] = values[node.input[0]]
        if node.op_type == "Mul" and node.input[0].endswith("_whole"):
            whole, scale = (values[name] for name in node.input)
            values[node.output[0]] = whole.astype(np.float32) * scale
    return {name: np.asarray(value, np.float32) for name, value in values.items()}


def module_path(node_name):
    """The module that a node was exported from: "/n/net/down.1/down.1.0/a/Conv" -> "net.down.1.0.a".

    A container's child repeats the container's name, so of "down.1/down.1.0" only the last part counts.
    """
    parts = []
    for part in node_name.split("/")[2:-1]:
        if parts and part.startswith(parts[-1] + "."):
            parts[-1] = part
        else:
            parts.append(part)
    return ".".join(parts)
