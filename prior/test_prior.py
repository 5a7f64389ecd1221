"""Checks of networks and training that need no GPU: python -m pytest test_prior.py (it needs torch, onnx and onnxruntime)."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

HERE = Path(__file__).parent


def test_slender_is_what_is_narrow():
    torch = pytest.importorskip("torch")
    from losses import slender

    alpha = torch.zeros(1, 2, 1, 64, 64)
    alpha[0, 0, 0, 20:44, 20:44] = 1
    alpha[0, 1, 0, :, 30:33] = 1
    found = slender(alpha)[0, :, 0]
    assert found[0].max() == 0
    assert (found[1, :, 28:35] == 1).all() and found[1, :, :28].max() == 0 and found[1, :, 35:].max() == 0


def test_muon_moves_each_matrix_as_if_it_were_alone():
    torch = pytest.importorskip("torch")
    from muon import USUAL, Muon, orthogonalised

    torch.manual_seed(5)
    qkv, wide, conv = torch.randn(12, 4), torch.randn(12, 4), torch.randn(8, 2, 3, 3)
    params = {name: torch.nn.Parameter(w.clone()) for name, w in (("b.qkv.weight", qkv), ("c.qkv.weight", wide), ("a.weight", conv))}
    for p in params.values():
        p.grad = torch.randn_like(p)
    muon = Muon(params.items(), lr=0.1, weight_decay=0.5, parts={"qkv": 3})
    muon.found_inf = torch.tensor(0.0)
    muon.step()
    for name, before in (("b.qkv.weight", qkv), ("c.qkv.weight", wide), ("a.weight", conv)):
        for at in range(3 if "qkv" in name else 1):
            rows = slice(4 * at, 4 * at + 4) if "qkv" in name else slice(None)
            gradient = params[name].grad[rows].flatten(1)
            # The first momentum is a twentieth of the gradient, Nesterov's look ahead as long in its direction.
            step = orthogonalised(gradient[None])[0].float().reshape(before[rows].shape) * 0.1 * USUAL * max(gradient.shape) ** 0.5
            torch.testing.assert_close(params[name].data[rows], before[rows] * 0.95 - step, atol=2e-3, rtol=0.02)
    again = Muon(params.items(), lr=0.1, weight_decay=0.5, parts={"qkv": 3})
    again.load_state_dict(muon.state_dict())
    assert all(torch.equal(a["momentum"], b["momentum"]) for a, b in zip(muon.state.values(), again.state.values(), strict=True))
    kept = {name: p.detach().clone() for name, p in params.items()}
    params["a.weight"].grad[0] = float("nan")
    muon.found_inf = torch.tensor(1.0)
    muon.step()
    assert all(torch.equal(kept[name], p) for name, p in params.items())


def test_a_new_critic_tells_pictures_apart():
    torch = pytest.importorskip("torch")
    from critic import Critic

    torch.manual_seed(6)
    critic = Critic().train()
    pictures = torch.rand(6, 8, 128, 128)
    with torch.no_grad():
        for _ in range(4):  # the spectral norms settle
            patches, whole, features = critic(pictures)
    assert whole.std() > 0.1 and patches.std() > 0.1
    assert all(0.1 < f.std() < 50 for f in features)


def test_a_critic_that_guesses_is_not_heeded():
    torch = pytest.importorskip("torch")
    from critic import SURE, Adversary

    torch.manual_seed(10)
    adversary = Adversary(device="cpu")
    adversary.follow(3e-4, 1.5)
    truth, crop = torch.rand(2, 3, 4, 128, 128), torch.rand(2, 4, 128, 128)

    def asked():
        answer = torch.rand(2, 3, 4, 128, 128, requires_grad=True)
        loss = ((answer - truth) ** 2).mean()
        term, right = adversary.heeded(answer, truth, crop, loss, 1)
        own, slope = torch.autograd.grad(loss, answer)[0], torch.autograd.grad(term, answer)[0]
        assert 0 <= right <= 1 and not slope[:1].any() and not slope[:, :1].any()
        return (slope.norm() / own[1:, 1:].norm()).item()

    assert asked() == 0
    for over, counts in ((SURE / 2, 0.75), (2 * SURE, 1.5)):
        adversary.right = torch.tensor(0.5 + over)
        assert asked() == pytest.approx(counts, rel=1e-3)


def test_perception_forgives_what_pixels_do_not_and_learns_nothing():
    """Fine stripes look far more like stripes that stand elsewhere than like their mean, although every pixel is twice as far off."""
    torch = pytest.importorskip("torch")
    from perception import Perception

    perception = Perception(str(HERE / "detail.onnx"))
    across = torch.arange(128)
    # Where they are as wide as a cell of the coarsest level, eight pixels, they look as far off as their mean does.
    for width in (2, 4, 6):
        stripes = ((across // width) % 2).float().expand(1, 3, 128, 128)
        moved, mean = 1 - stripes, torch.full_like(stripes, 0.5)
        truth, moved, mean = (torch.cat([t, torch.ones(1, 1, 128, 128)], 1) for t in (stripes, moved, mean))
        assert perception(truth, truth).item() == 0
        mean.requires_grad_(True)
        unlike = perception(mean, truth)
        assert perception(moved, truth).item() < 0.7 * unlike.item()
        unlike.backward()
        assert mean.grad.abs().sum() > 0
    assert all(not p.requires_grad and p.grad is None for p in perception.parameters())


def test_what_is_held_does_not_learn():
    pytest.importorskip("torch")
    from train import learns

    assert learns("net.mid.0.o.weight", "scene", []) and not learns("net.mid.0.o.weight", "scene", ["net.mid"])
    assert learns("net.up.0.0.a.weight", "scene", ["net.mid"])
    assert learns("er.a.weight", "error", []) and not learns("er.a.weight", "splat", [])
    assert learns("held.a.weight", "held", []) and not learns("held.a.weight", "scene", [])
    assert not learns("er.a.weight", "held", []) and not learns("net.stem.weight", "held", [])


@pytest.mark.parametrize("which", ["scene", "detail", "splat"])
def test_networks_compute_what_the_shipped_files_compute(which):
    torch = pytest.importorskip("torch")
    onnxruntime = pytest.importorskip("onnxruntime")
    restore = pytest.importorskip("restore")
    path = HERE / f"{which}.onnx"
    net = restore.NETS[which]()
    net.load_state_dict(restore.state_from_onnx(path, net))
    session = onnxruntime.InferenceSession(path, providers=["CPUExecutionProvider"])
    generator = torch.Generator().manual_seed(0)
    examples = {source.name: torch.rand(source.shape, generator=generator) for source in session.get_inputs()}
    assert ("hint" in examples) == (which == "splat")
    with torch.no_grad():
        ours = restore.WRAPPERS[which](net).eval()(*examples.values())
    theirs = session.run(None, {name: example.numpy() for name, example in examples.items()})
    for a, b in zip(ours, theirs, strict=False):
        # SplatNet 0.2 gave an elevation without its spread, and no camera.
        a = a.numpy() if a.shape == b.shape else a.numpy()[:, 0]
        assert np.abs(a - b).max() <= 1e-3 * np.abs(b).max()


def test_an_answer_of_wrong_size_and_distance_is_brought_home():
    torch = pytest.importorskip("torch")
    from types import SimpleNamespace

    from losses import brought_home
    from nets import SplatNet, crop_rays

    torch.manual_seed(5)
    middle, size = SplatNet.DIST, 8
    true_camera = torch.tensor([[-0.1, 0.05, -0.02, 0.3], [0.1, -0.03, 0.04, -0.2]])
    told_camera = true_camera + torch.tensor([[0.2, 0.1, 0.03, -0.1], [-0.15, 0.0, -0.05, 0.2]])
    relief = torch.rand(2, 1, 1, size, size) - 0.5
    stretch = torch.exp((told_camera - true_camera)[:, 0]).reshape(2, 1, 1, 1, 1)

    def listed(t):
        return t.permute(0, 1, 3, 4, 2).reshape(2, size * size, 3)

    truth = listed(crop_rays(true_camera, middle + relief, middle))
    told_depth = middle + (relief - 0.07) * stretch
    answer = {
        "pos": listed(crop_rays(told_camera, told_depth, middle)),
        "scale": torch.full((2, size * size, 3), 0.1) * stretch.reshape(2, 1, 1),
        "depth": told_depth[:, 0, 0],
        "camera": told_camera,
    }
    batch = SimpleNamespace(
        camera=true_camera,
        front=(middle + relief)[:, 0, 0],
        rgba=torch.ones(2, 4, 2 * size, 2 * size),
        empty=torch.zeros(2, dtype=torch.bool),
    )
    home = brought_home(answer, batch)
    assert torch.allclose(home["pos"], truth, atol=1e-5)
    assert torch.allclose(home["scale"], torch.full_like(home["scale"], 0.1), atol=1e-6)


def test_a_deeper_network_begins_as_the_one_it_grew_from():
    torch = pytest.importorskip("torch")
    from nets import UNet, grown

    torch.manual_seed(6)
    shallow = UNet(4, (16, 32, 64), cout=3, grid=4, depth=1, heads=2).eval()
    deep = UNet(4, (16, 32, 64), cout=3, grid=4, depth=3, heads=2, near=2).eval()
    # `grown` reads whole networks, whose U-Net is called net.
    named = torch.nn.ModuleDict({"net": deep})
    state = grown(named, {f"net.{name}": value for name, value in shallow.state_dict().items()})
    named.load_state_dict(state)
    x = torch.rand(2, 4, 16, 16)
    with torch.no_grad():
        for a, b in zip(shallow(x)[:3], deep(x)[:3], strict=True):
            assert torch.allclose(a, b, atol=1e-5)


def test_blocks_move_apart_and_copies_pass_on():
    torch = pytest.importorskip("torch")
    from nets import deepened

    def blocks(numbers):
        names = ("qkv.weight", "o.weight", "o.bias", "f.2.weight")
        return {f"net.mid.{i}.{name}": torch.full((2,), float(n)) for i, n in enumerate(numbers) for name in names}

    made = deepened(blocks([1, 2]) | {"net.norm.weight": torch.ones(2)}, blocks([9] * 5), "net.mid.")
    assert [made[f"net.mid.{i}.qkv.weight"][0].item() for i in range(5)] == [1, 1, 1, 2, 2]
    assert [made[f"net.mid.{i}.o.bias"][0].item() for i in range(5)] == [1, 0, 0, 2, 0]
    assert made["net.norm.weight"][0] == 1 and len(made) == 21
    assert deepened(made, blocks([9] * 5), "net.mid.") is made


def test_convolutions_before_and_after_enlarging_agree(tmp_path):
    torch = pytest.importorskip("torch")
    onnx = pytest.importorskip("onnx")
    onnxruntime = pytest.importorskip("onnxruntime")
    from enlarged import rewritten
    from nets import UNet

    torch.manual_seed(8)

    class Seeing(torch.nn.Module):
        def __init__(self):
            super().__init__()
            self.net = UNet(4, (6, 10, 16), cout=3, grid=4, depth=1, heads=2)

        def forward(self, x):
            return self.net(x)[:3]

    net, x, path = Seeing().eval(), torch.rand(1, 4, 16, 16), str(tmp_path / "net.onnx")
    torch.onnx.export(net, (x,), path, input_names=["x"], opset_version=17, dynamo=False)
    before = onnx.load(path)
    after = rewritten(onnx.load(path))
    ops = [[node.op_type for node in model.graph.node] for model in (before, after)]
    assert ops[0].count("Resize") == 2 and ops[1].count("DepthToSpace") == 2 and ops[1].count("Concat") == ops[0].count("Concat") - 2
    answers = [
        onnxruntime.InferenceSession(model.SerializeToString(), providers=["CPUExecutionProvider"]).run(None, {"x": x.numpy()})
        for model in (before, after)
    ]
    for a, b in zip(*answers, strict=True):
        assert np.abs(a - b).max() < 1e-5 * max(1, np.abs(a).max())


def test_splatnet_alone_is_stored_in_four_bits():
    onnx = pytest.importorskip("onnx")

    def in_four_bits(which):
        return [t.name for t in onnx.load(str(HERE / f"{which}.onnx")).graph.initializer if t.name.endswith("_u4")]

    assert in_four_bits("splat") and not in_four_bits("scene") and not in_four_bits("detail")


def test_what_is_stored_in_four_bits_is_what_is_asked_for(tmp_path):
    torch = pytest.importorskip("torch")
    onnx = pytest.importorskip("onnx")
    from export import export
    from nets import UNet
    from packing import FOUR_BITS

    class Net(torch.nn.Module):
        def __init__(self):
            super().__init__()
            self.net = UNet(4, (32, 64), cout=2, grid=4, depth=1, heads=2)

        def forward(self, x):
            return self.net(x)[0]

    class Wrapped(torch.nn.Module):
        def __init__(self):
            super().__init__()
            self.n = Net()

        def forward(self, x):
            return self.n(x)

    for net, few in (("splat", 4), ("detail", 0), ("scene", 0)):
        path = str(tmp_path / f"{net}.onnx")
        export(Wrapped(), (torch.rand(1, 4, 8, 8),), path, ["x"], ["y"], FOUR_BITS.get(net, ()))
        names = [t.name for t in onnx.load(path).graph.initializer]
        # A block's four matrices.
        assert sum(n.endswith("_u4") for n in names) == few and any(n.endswith("_i8") for n in names), names


def test_four_bits_keep_matrices():
    pytest.importorskip("onnx")
    from packing import GROUP, from_four_bits, in_four_bits

    rng = np.random.default_rng(3)
    for rows in (3 * GROUP, 160):  # 160 are no groups of 64: they are of 32
        values = (rng.standard_normal((rows, 10)) * np.logspace(-3, 1, 10)).astype(np.float32)
        numbers, scale = in_four_bits(values)
        assert numbers.dtype == np.uint8 and numbers.size == values.size // 2
        error = from_four_bits(numbers, scale) - values
        # Of normal numbers 0.097 in the mean with the best 16 levels (Max 1960, table I); groups with scales of their own do better.
        relative = np.linalg.norm(error, axis=0) / np.linalg.norm(values, axis=0)
        assert relative.max() < 0.11 and relative.mean() < 0.097


def test_scales_learn_and_levels_stay():
    torch = pytest.importorskip("torch")
    pytest.importorskip("onnx")
    from levels import hold_levels, settled
    from nets import Block
    from packing import in_four_bits

    torch.manual_seed(6)
    plain = torch.nn.ModuleDict({"mid": torch.nn.ModuleList([Block(64, 2)]), "other": torch.nn.Linear(64, 3)})
    hold_levels(plain, ("mid.",))
    stored = settled({name: value.clone() for name, value in plain.state_dict().items()})
    net = torch.nn.ModuleDict({"mid": torch.nn.ModuleList([Block(64, 2)]), "other": torch.nn.Linear(64, 3)})
    net.load_state_dict(stored)  # the names of a network without such layers, and all of them
    x = torch.randn(2, 5, 64)
    before = net.mid[0](x)
    hold_levels(net, ("mid.",))
    assert torch.allclose(net.mid[0](x), before, atol=1e-5)

    optimizer = torch.optim.AdamW(net.parameters(), lr=0.01)
    for _ in range(20):
        optimizer.zero_grad()
        loss = ((net.other(net.mid[0](x)) - 1) ** 2).mean()
        loss.backward()
        optimizer.step()
    learned = settled(net.state_dict())
    assert set(learned) == set(stored) and not torch.equal(learned["other.weight"], stored["other.weight"])
    for name in ("qkv", "o", "f.0", "f.2"):
        was, now = (in_four_bits(state[f"mid.0.{name}.weight"].detach().half().float().T.numpy()) for state in (stored, learned))
        assert np.array_equal(was[0], now[0]), name
        change = now[1].astype(np.float32) / was[1]
        assert change.min() > 0 and np.abs(change - 1).max() > 0.02, (name, change)


def test_rounding_by_inputs_costs_the_answer_less_and_is_stored_as_it_is():
    torch = pytest.importorskip("torch")
    pytest.importorskip("onnx")
    from packing import from_four_bits, in_four_bits
    from rounding import rounded

    def stored(matrix):
        return torch.from_numpy(from_four_bits(*in_four_bits(matrix.numpy())))

    torch.manual_seed(5)
    for inputs in (128, 160):  # groups of 64 and of 32
        # What goes in together, and what hardly ever goes in.
        x = torch.randn(4000, inputs) @ (torch.randn(inputs, inputs) * torch.logspace(-2, 0, inputs)[:, None])
        matrix = torch.randn(inputs, 48)
        after = rounded(matrix, x.T @ x)
        assert torch.equal(stored(after), after)
        costs = [(x @ (stored(m) - matrix)).norm() for m in (matrix, after)]
        assert costs[1] < 0.75 * costs[0], costs


def test_blocks_are_rounded_one_after_the_other_and_make_up_for_what_is_lost():
    torch = pytest.importorskip("torch")
    pytest.importorskip("onnx")
    import copy

    from nets import Block
    from packing import from_four_bits, in_four_bits
    from rounding import round_blocks

    def stored(matrix):
        return torch.from_numpy(from_four_bits(*in_four_bits(matrix.detach().T.numpy())).T.copy())

    def answers(blocks, tokens):
        with torch.no_grad():
            return torch.nn.Sequential(*blocks)(torch.cat(tokens))

    torch.manual_seed(6)
    together = torch.randn(64, 64) * torch.logspace(-1.5, 0, 64)[:, None]
    tokens, others = ([torch.randn(8, 32, 64) @ together for _ in range(4)] for _ in range(2))
    exact = torch.nn.ModuleList(Block(64, 2) for _ in range(3))
    wanted = answers(exact, others)

    blocks = copy.deepcopy(exact)
    round_blocks(blocks, tokens, tokens)
    plain = copy.deepcopy(exact)
    for (name, after), before, nearest in zip(blocks.named_parameters(), exact.parameters(), plain.parameters()):
        if after.ndim == 2:
            assert torch.equal(stored(after), after), name
            nearest.data = stored(nearest)
        if ".n" in name:
            assert torch.equal(after, before), name
        else:
            assert 0 < (after - before).norm() < 0.25 * before.norm(), name
    # By tokens that were not seen.
    costs = [(answers(b, others) - wanted).norm() for b in (plain, blocks)]
    assert costs[1] < 0.7 * costs[0], costs

    # What came before has lost something as well: a third of that is made up for.
    gains = torch.rand(64) * 0.2 + 0.9
    lossy = [torch.cat(x) * gains for x in (tokens, others)]
    aware, unaware = copy.deepcopy(exact), copy.deepcopy(exact)
    round_blocks(aware, [lossy[0]], [torch.cat(tokens)])
    round_blocks(unaware, [lossy[0]], [lossy[0]])
    costs = [(answers(b, [lossy[1]]) - wanted).norm() for b in (unaware, aware)]
    assert costs[1] < 0.67 * costs[0], costs


def test_a_place_fits_no_worse_than_the_one_before():
    from devset.score import best_place

    y, x = np.mgrid[:64, :64] + 0.5

    def view(place):
        scale, shift = place
        middle = 32 + 20 * shift[0]
        tower = (abs(x - middle) < 6 * scale) & (abs(y - 32) < 20 * scale)
        # Fog that no scale or shift takes away drags the centroid aside.
        fog = (x > middle + 6 * scale) & (x < middle + 18) & (abs(y - 32) < 8)
        return np.maximum(tower, 0.6 * fog)

    camera = {"w2c_opencv": [[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]], "fx": 20.0}
    true = view((1.0, np.zeros(3))) == 1
    truth = SimpleNamespace(views=[camera], alpha=[true.astype(float)], size=np.zeros(3))
    tried = []

    def drawn_at(place):
        tried.append(place)
        return None, [view(place)]

    start = (1.0, np.array([0.02, 0, 0]))
    place, (_, (alpha,)) = best_place(truth, start, drawn_at, 4)

    def fit(alpha):
        return ((alpha > 0.5) & true).sum() / ((alpha > 0.5) | true).sum()

    assert fit(alpha) >= fit(view(start)) and fit(alpha) == max(fit(view(p)) for p in tried)


def test_means_of_versions_are_of_what_they_compute():
    torch = pytest.importorskip("torch")
    from average import averaged, folded
    from nets import UNet

    torch.manual_seed(7)
    net = UNet(4, (16, 32), cout=3, grid=4, depth=1, heads=2).eval()
    for module in net.modules():
        if isinstance(module, torch.nn.BatchNorm2d):
            module.running_mean.uniform_(-0.3, 0.3)
            module.running_var.uniform_(0.5, 2)
            torch.nn.init.uniform_(module.weight, 0.5, 1.5)
    x = torch.rand(2, 4, 8, 8)
    with torch.no_grad():
        before, state = net(x)[0], folded(net)
        # The same function, its norms set otherwise, is no other version.
        net.load_state_dict(averaged([state, folded(net)], [2.0, 1.0]))
        assert torch.allclose(net(x)[0], before, atol=1e-5)
    mean = averaged([{"a": torch.tensor([1.0]), "n": torch.tensor(3)}, {"a": torch.tensor([5.0]), "n": torch.tensor(3)}], [3, 1])
    assert mean["a"].item() == 2 and mean["n"].item() == 3
    # What one version lacks is the other's.
    mean = averaged([{"a": torch.tensor([1.0])}, {"a": torch.tensor([5.0]), "b": torch.tensor([7.0])}], [3, 1])
    assert mean["a"].item() == 2 and mean["b"].item() == 7


def test_muon_steps_along_all_directions_of_a_matrix_alike():
    torch = pytest.importorskip("torch")
    from muon import USUAL, Muon, orthogonalised

    torch.manual_seed(8)
    steps = orthogonalised(torch.randn(3, 24, 60) * torch.logspace(-6, 3, 24)[:, None]).float()
    values = torch.linalg.svdvals(orthogonalised(torch.randn(3, 60, 24)).float())
    assert steps.isfinite().all() and values.min() > 0.5 and values.max() < 1.3

    blocks = {"x.qkv.weight": torch.nn.Parameter(torch.zeros(48, 16)), "x.a.weight": torch.nn.Parameter(torch.zeros(8, 4, 3, 3))}
    optimizer = Muon(blocks.items(), lr=0.1, parts={"qkv": 3})
    for p in blocks.values():
        p.grad = torch.randn_like(p)
    blocks["x.qkv.weight"].grad[:16] *= 100  # queries alone: keys and values are matrices of their own
    optimizer.found_inf = torch.tensor(1.0)
    optimizer.step()
    assert all((p == 0).all() for p in blocks.values())
    optimizer.found_inf = torch.tensor(0.0)
    optimizer.step()
    for part in blocks["x.qkv.weight"].detach().chunk(3):
        assert 0.7 < torch.linalg.svdvals(part).median() / (0.1 * USUAL * 16**0.5) < 1.2
    kernel = blocks["x.a.weight"].detach().reshape(8, 36)
    assert 0.7 < torch.linalg.svdvals(kernel).median() / (0.1 * USUAL * 36**0.5) < 1.2


def test_slender_subjects_count_as_much_as_full_ones():
    torch = pytest.importorskip("torch")
    from types import SimpleNamespace

    from losses import importance, silhouette_losses

    alpha = torch.zeros(3, 2, 1, 32, 32)
    alpha[0, :, :, 4:28, 4:28] = 1
    alpha[1, :, :, 4:28, 15:17] = 1
    weight = importance(SimpleNamespace(alpha=alpha, empty=torch.tensor([False, False, True])))
    assert weight.mean().item() == pytest.approx(1) and weight[2].item() == 0
    assert (weight[1] / weight[0]).item() == pytest.approx(12**0.5, rel=1e-4)
    # Half of a subject missing costs the same, whatever its size.
    half = alpha.clone()
    half[..., :16, :] = 0
    lost = silhouette_losses(half, alpha).squeeze()
    assert lost[0, 0].item() == pytest.approx(1 / 3, abs=0.01) and lost[1, 0].item() == pytest.approx(1 / 3, abs=0.01)
    assert silhouette_losses(alpha, alpha).abs().max() < 1e-6
