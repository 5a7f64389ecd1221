"""Checks that need no GPU: python -m pytest test_prior.py (the last one needs torch, onnx and onnxruntime)."""

import re
from pathlib import Path

import numpy as np
import pytest

from synth import layout
from synth.objects import make_object

HERE = Path(__file__).parent
SEEDS = range(200)


def enumerators(text):
    """{name: value} of all enums in C source."""
    found = {}
    for body in re.findall(r"enum\s*\{(.*?)\}", text, re.S):
        found |= {name: int(value) for name, value in re.findall(r"(\w+)\s*=\s*(\d+)", body)}
    return found


def test_kernel_and_generator_share_their_columns():
    kernel = enumerators((HERE / "synth" / "columns.cuh").read_text())
    first = {"FIRST": layout.COLOURS[0].start, "SECOND": layout.COLOURS[1].start, "ROW": layout.FLOATS}
    for name, value in kernel.items():
        expected = first.get(name, getattr(layout, name, None))
        if isinstance(expected, slice):
            expected = expected.start
        if expected is not None:
            assert value == expected, name
    assert kernel["SUBJECT"] == layout.SUBJECT


def test_same_seed_same_bytes():
    for seed in SEEDS:
        assert make_object(seed)[0].tobytes() == make_object(seed)[0].tobytes()


def test_objects_stand_on_their_ground_inside_the_unit_sphere():
    for seed in SEEDS:
        rows, count, ground = make_object(seed)
        assert 1 <= count <= layout.PRIMS
        assert not rows[count:].any()
        assert np.isfinite(rows).all()
        assert -1 < ground < 0
        assert (rows[:count, layout.HALF_SIZE] > 0).all()
        assert (np.linalg.norm(rows[:count, layout.CENTRE], axis=1) <= 1).all()


@pytest.mark.parametrize("which", ["scene", "splat"])
def test_networks_compute_what_the_shipped_files_compute(which):
    torch = pytest.importorskip("torch")
    onnxruntime = pytest.importorskip("onnxruntime")
    restore = pytest.importorskip("restore")
    path = HERE / f"{which}.onnx"
    net = restore.NETS[which]()
    net.load_state_dict(restore.state_from_onnx(path, net))
    session = onnxruntime.InferenceSession(path, providers=["CPUExecutionProvider"])
    (source,) = session.get_inputs()
    example = torch.rand(source.shape, generator=torch.Generator().manual_seed(0))
    with torch.no_grad():
        ours = restore.WRAPPERS[which](net).eval()(example)
    theirs = session.run(None, {source.name: example.numpy()})
    for a, b in zip(ours, theirs, strict=True):
        assert np.abs(a.numpy() - b).max() <= 1e-3 * np.abs(b).max()
