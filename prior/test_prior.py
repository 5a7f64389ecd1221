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
        rows, count, ground, _ = make_object(seed)
        assert 1 <= count <= layout.PRIMS
        assert not rows[count:].any()
        assert np.isfinite(rows).all()
        assert -1 < ground < 0
        assert (rows[:count, layout.HALF_SIZE] > 0).all()
        assert (np.linalg.norm(rows[:count, layout.CENTRE], axis=1) <= 1).all()


def test_bounding_boxes_fit():
    """The lowest point that rays meet is the ground, and the box's diagonal is 2: nothing is smaller than it says."""
    torch = pytest.importorskip("torch")
    from synth.cameras import look_at, pack
    from synth.environments import environments
    from synth.raycast import cast

    seeds = range(40)
    made = [make_object(seed) for seed in seeds]
    prims = torch.from_numpy(np.stack([m.rows for m in made]))
    # What leaves and bars leave open does not count, nor what is turned at random about the vertical.
    prims[..., layout.CUTOUT] = 0
    counts = torch.tensor([m.count for m in made], dtype=torch.int32)
    eye = torch.tensor([[80.0, 0, 0]]).expand(len(made), 3)
    cameras = pack(*look_at(eye), torch.full((len(made),), 0.03), 160, subject_only=True)
    surroundings = environments(len(made), torch.full((len(made),), -1e3), "cpu")
    # Sixteen rays a pixel: spires are thin.
    _, alpha, _, _ = cast(prims, counts, torch.arange(len(made), dtype=torch.int32), cameras, surroundings, 160, 4)
    rows = [torch.where(a.amax(1) > 0)[0] for a in alpha]
    unit = 80 * 2 * np.tan(0.015) / 160
    bottom = np.array([80 - (r.max().item() + 1) for r in rows]) * unit
    top = np.array([80 - r.min().item() for r in rows]) * unit
    grounds = np.array([m.ground for m in made])
    assert np.abs(bottom - grounds).max() < 6 * unit
    assert np.abs(top + grounds).max() < 6 * unit


def test_enumerations_of_the_kernel_are_those_of_the_layout():
    kernel = enumerators((HERE / "synth" / "columns.cuh").read_text())
    for name in ("BOX BALL CYL TUBE PRISM LEAVES BARS RUNGS LATTICE GRID SPOKES OPEN_SKY LANDSCAPE WALL NOISE_ROOM "
                 "CLUTTER TREES TOWN ROOM NO_CASTER ROOFLINE CROWN POSTS EARTH TILED PAVED GRASS WATER PLANKED RUNWAY CUTOUT CUT_FREQUENCY CUT_SHARE BEVEL").split():  # fmt: skip
        assert kernel[name] == getattr(layout, name), name


def test_generated_batches_are_finite_and_points_lie_on_subjects():
    torch = pytest.importorskip("torch")
    from nets import SplatNet
    from synth.batches import make_pool, scene_batch, splat_batch
    from synth.details import detail_batch

    torch.manual_seed(0)
    pool = make_pool(0, 64, 2, "cpu", textures=8)
    scenes = scene_batch(pool, 8, size=64)
    subjects = splat_batch(pool, 4, SplatNet.FOV, SplatNet.DIST, size=64, views=2)
    assert all(torch.isfinite(torch.as_tensor(t)).all() for t in (*scenes, *subjects))
    closer = detail_batch(pool, 6, lambda x: x[:, 3:], size=96, seen=64)
    assert all(torch.isfinite(t).all() for t in closer)
    assert 0 <= closer.rough.min() and closer.rough.max() <= 1
    # A pixel is the subject's or in a shadow, not both at once.
    assert scenes.shade.max() > 0.5
    assert (scenes.shade + scenes.alpha).max() < 1 + 1e-4
    given = scenes.point.flatten(1).amax(1) > 0
    assert given.any()
    at = scenes.point.flatten(1).argmax(1)
    assert (scenes.alpha.flatten(1)[torch.arange(8), at][given] > 0.5).all()


def test_water_takes_what_it_hides_and_shows_the_rest_once_more():
    torch = pytest.importorskip("torch")
    from synth import water

    torch.manual_seed(3)
    alpha = torch.zeros(300, 60, 60)
    alpha[:, 20:40, 25:35] = 1
    lake = water.waters(alpha)
    lake = lake._replace(clear=torch.full((300,), 1.0))
    wet = (lake.below > 0).any(1)
    assert 5 < wet.sum() < 40
    above, shade = water.above_water(alpha, torch.zeros_like(alpha), lake)
    assert torch.equal(above[~wet], alpha[~wet]) and shade[~wet].max() == 0
    assert above[wet].sum() <= alpha[wet].sum() and (above[wet].flatten(1).sum(1) >= 0.7 * 200).all()
    # The image stands below the line, upside down, about as large as what is left of the subject.
    assert (shade[wet] * above[wet]).max() == 0
    assert (shade[wet].flatten(1).sum(1) > 0.5 * above[wet].flatten(1).sum(1)).all()
    picture = alpha[:, None].expand(-1, 3, -1, -1)
    shown = water.flooded(picture, lake)
    assert torch.equal(shown[~wet], picture[~wet])
    assert (shown[wet][:, 0] - above[wet]).flatten(1).sum(1).min() > 20


def test_lenses_bend_a_third_of_the_photos_and_leave_the_middle_of_their_sides():
    torch = pytest.importorskip("torch")
    from synth.lens import bent

    torch.manual_seed(4)
    grid = bent(300, 33, "cpu")
    straight = (torch.arange(33) + 0.5) * (2 / 33) - 1
    off = (grid[..., 0] - straight).abs().amax((1, 2))
    assert 60 < (off > 1e-6).sum() < 140
    # At the middle of a side r is 1 but for half a pixel.
    assert (grid[:, 16, 0, 0] - straight[0]).abs().max() < 0.12 * 0.07
    assert off.max() < 0.12 * 1.02 * 1.01


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
    """Stripes look more like stripes that stand elsewhere than like their mean, although every pixel is twice as far off."""
    torch = pytest.importorskip("torch")
    from perception import Perception

    perception = Perception(str(HERE / "detail.onnx"))
    across = torch.arange(128)
    stripes = ((across // 8) % 2).float().expand(1, 3, 128, 128)
    moved, mean = 1 - stripes, torch.full_like(stripes, 0.5)
    truth, moved, mean = (torch.cat([t, torch.ones(1, 1, 128, 128)], 1) for t in (stripes, moved, mean))
    assert perception(truth, truth).item() == 0
    mean.requires_grad_(True)
    unlike = perception(mean, truth)
    assert perception(moved, truth).item() < unlike.item()
    unlike.backward()
    assert mean.grad.abs().sum() > 0
    assert all(not p.requires_grad and p.grad is None for p in perception.parameters())


def test_what_is_held_does_not_learn():
    pytest.importorskip("torch")
    from train import learns

    assert learns("net.mid.0.o.weight", "scene", []) and not learns("net.mid.0.o.weight", "scene", ["net.mid"])
    assert learns("net.up.0.0.a.weight", "scene", ["net.mid"])
    assert learns("er.a.weight", "error", []) and not learns("er.a.weight", "splat", [])


def test_the_closer_picture_and_the_cut_out_mask_show_the_same():
    torch = pytest.importorskip("torch")
    from synth.batches import make_pool, seen_by, staged
    from synth.cameras import magnified
    from synth.details import cut_out

    torch.manual_seed(1)
    stage = staged(make_pool(0, 32, 2, "cpu", textures=4), torch.randint(32, (4,)), 128)
    _, whole, _, _ = seen_by(stage, stage.cameras, 128)
    box = torch.tensor([[20.0, 30, 110, 100], [0, 0, 128, 128], [40, 10, 90, 120], [10, 50, 120, 120]])
    _, closer, _, _ = seen_by(stage, magnified(stage.cameras, box, 128, 160), 160)
    cut = cut_out(whole[:, None], box, 128, 160)[:, 0]
    # The same edges, but for the pixels of the coarser one.
    assert ((cut > 0.5) != (closer > 0.5)).float().mean() < 0.02
    assert (closer > 0.5).float().mean() > 0.05


def test_patches_change_the_subject_or_what_is_around_it_and_nothing_else():
    torch = pytest.importorskip("torch")
    from synth.details import painted, patches

    torch.manual_seed(2)
    rgb = torch.rand(40, 3, 64, 64)
    alpha = torch.zeros(40, 64, 64)
    alpha[:, 10:50, 20:40] = 1
    paint = patches(rgb, alpha)
    changed = (painted(rgb, alpha, paint) - rgb).abs().amax(1) > 1e-3
    on = changed[:, 10:50, 20:40].flatten(1).any(1)
    around = (changed & (alpha == 0)).flatten(1).any(1)
    assert not (on & around).any() and on.any() and around.any()
    assert 5 < (on | around).sum() < 30
    # What is painted keeps its light and shade.
    ramp = torch.linspace(0.2, 0.6, 64).expand(1, 3, 64, 64)
    whole = paint._replace(where=torch.ones(1, 1, 64, 64), on=torch.ones(1), colour=torch.full((1, 3, 1, 1), 0.4))
    assert torch.allclose(painted(ramp, torch.ones(1, 64, 64), whole), ramp, atol=1e-4)


@pytest.mark.parametrize("which", ["scene", "detail", "splat"])
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
        ours = restore.WRAPPERS[which](net).eval()(restore.as_taken_now(example, which))
    theirs = session.run(None, {source.name: example.numpy()})
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
        for a, b in zip(shallow(x), deep(x), strict=True):
            assert torch.allclose(a, b, atol=1e-5)


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


def test_masks_grow_by_rows_and_columns_as_by_squares():
    torch = pytest.importorskip("torch")
    from synth.masks import grown

    torch.manual_seed(9)
    mask = torch.rand(2, 1, 40, 40)
    assert torch.equal(grown(mask, 5), torch.nn.functional.max_pool2d(mask, 11, 1, 5))


def boxed(centre, half, rotation=None, kind=layout.BOX):
    from synth.kit import Primitive

    rotation = np.eye(3) if rotation is None else rotation
    return Primitive(kind, np.array(centre, float), np.array(half, float), (1, 1), (0, 0), rotation, None)


def test_reshaped_objects_stay_symmetric_and_in_one_piece():
    from synth.kit import ALONG_Y, turn
    from synth.variation import Warp, reshaped

    flip = np.diag([1.0, -1, 1])
    for seed in range(20):
        warp = Warp(np.array([-2.0, -1, 0]), np.array([2.0, 1, 3]), np.random.default_rng(seed))
        low, high = boxed((0.4, 0.3, 0.5), (0.6, 0.2, 0.5)), boxed((0.4, 0.3, 1.6), (0.3, 0.2, 0.6))
        spin = turn("z", 25) @ turn("x", 40)
        bar, twin = boxed((1, 0.5, 1), (0.05, 0.05, 0.9), spin), boxed((1, -0.5, 1), (0.05, 0.05, 0.9), flip @ spin @ flip)
        wheel = boxed((-1, 0.8, 0.4), (0.4, 0.4, 0.1), ALONG_Y, layout.CYL)
        low, high, bar, twin, wheel = reshaped([low, high, bar, twin, wheel], warp)
        # What stood on the other still does, and nothing lies askew that did not.
        assert low.centre[2] + low.half[2] == pytest.approx(high.centre[2] - high.half[2])
        assert np.allclose(low.rotation, np.eye(3)) and low.half.min() > 0
        # Twins stay twins, and a bar ends where the warp takes its end.
        assert np.allclose(flip @ bar.centre, twin.centre) and np.allclose(bar.half, twin.half)
        assert np.allclose(flip @ bar.rotation @ flip, twin.rotation)
        assert np.allclose(bar.centre + bar.rotation[:, 2] * bar.half[2], warp(np.array([1, 0.5, 1]) + 0.9 * spin[:, 2]), atol=0.03)
        # Wheels stay round and on their ground.
        assert wheel.half[0] == wheel.half[1]
        assert wheel.centre[2] - wheel.half[1] == pytest.approx(warp([-1, 0.8, 0.0])[2], abs=0.08)


def test_what_is_together_stands_on_one_ground_and_leaves_room_for_all():
    from synth.groups import group, largest, reach
    from synth.kit import Kit

    for seed in range(40):
        kit = Kit(np.random.default_rng(seed))
        group(kit)
        low, high = reach(kit.primitives)
        assert 2 <= len(kit.primitives) <= layout.PRIMS
        assert abs(low[2]) < 1e-6 and (high > low).all()
        kept = largest(kit.primitives, 3)
        shortest = min(np.sort(p.half)[1:].sum() for p in kept)
        left_out = [p for p in kit.primitives if not any(p is k for k in kept)]
        assert len(kept) == min(3, len(kit.primitives))
        assert all(np.sort(p.half)[1:].sum() <= shortest for p in left_out)


def test_every_maker_makes_the_same_again_inside_the_unit_sphere():
    """Of each maker five objects; none has so many primitives that its main parts would be cut off."""
    from synth.kit import Kit
    from synth.objects import MAKERS

    for maker, _ in MAKERS:
        for seed in range(5):
            rows, count, ground, by = make_object(seed, maker)
            assert by is maker and count >= 1 and ground < 0, maker.__name__
            assert (np.linalg.norm(rows[:count, layout.CENTRE], axis=1) <= 1).all(), maker.__name__
            assert rows.tobytes() == make_object(seed, maker)[0].tobytes(), maker.__name__
            kit = Kit(np.random.default_rng(seed))
            maker(kit)
            assert len(kit.primitives) <= 1.25 * layout.PRIMS, maker.__name__


def test_small_things_sit_on_what_carries_them():
    from synth.kit import Kit
    from synth.variation import adorned

    counts = set()
    for seed in range(40):
        rng = np.random.default_rng(seed)
        host = boxed((0, 0, 1), (2, 1, 1))
        primitives = adorned([host], np.array([-2.0, -1, 0]), np.array([2.0, 1, 2]), 5, rng, Kit(rng).material)
        counts.add(len(primitives))
        assert primitives[0] is host and len(primitives) <= 6
        for extra in primitives[1:]:
            # The nearest point of the host is no further off than the thing reaches.
            off = np.maximum(np.abs(extra.centre - host.centre) - host.half, 0)
            assert (off <= extra.half + 1e-9).all()
    assert len(counts) > 3
