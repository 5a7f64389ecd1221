"""Checks of the generator that need no GPU: python -m pytest test_synth.py."""

import math
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
        subject = rows[:count][rows[:count, layout.SUBJECT] == 1]
        assert ground < 0
        assert ground > -1 or len(subject) < count
        assert (rows[:count, layout.HALF_SIZE] > 0).all()
        assert (np.linalg.norm(subject[:, layout.CENTRE], axis=1) <= 1).all()


def test_what_an_animal_sits_on_is_not_of_it():
    from synth.objects import beast, upright_animal
    from synth.reptiles import sprawler

    carried = 0
    for seed in range(60):
        rows, count, ground, _ = make_object(seed, upright_animal)
        subject = rows[:count, layout.SUBJECT] == 1
        assert subject.any()
        carried += not subject.all()
        # The ground lies as low as a perch reaches, and no higher than the animal's feet.
        assert ground < 0
        if subject.all():
            assert ground > -1
    assert 5 < carried < 30
    assert all((make_object(seed, beast).rows[: make_object(seed, beast).count, layout.SUBJECT] == 1).all() for seed in range(20))
    made = [make_object(seed, sprawler) for seed in range(30)]
    assert 1 < sum((m.rows[: m.count, layout.SUBJECT] == 0).any() for m in made) < 15


def test_disguises_leave_the_subject_and_what_is_not_disguised():
    torch = pytest.importorskip("torch")
    from synth.clutter import BOUGHS, DISGUISED, add_boughs, disguise

    torch.manual_seed(1)
    n, own = 400, 3
    prims = torch.rand(n, 40, layout.FLOATS)
    prims[..., layout.SUBJECT] = 0
    prims[:, :own, layout.SUBJECT] = 1
    for columns in layout.COLOURS:
        prims[:, :own, columns] = torch.tensor([0.3, 0.02, 0.02])
    before, subject = prims.clone(), prims[:, :own].clone()
    surroundings = torch.rand(n, layout.ENVIRONMENT_FLOATS)
    around = surroundings.clone()
    disguise(prims, surroundings, subject, torch.full((n,), own))
    assert torch.equal(prims[:, :own], before[:, :own])
    changed = (prims != before).flatten(1).any(1)
    assert changed.float().mean() == pytest.approx(DISGUISED, abs=0.08)
    painted = (prims != before)[..., layout.COLOURS[0]].any(-1)
    red = prims[..., layout.COLOURS[0]][painted]
    assert (red[:, 0] / red[:, 1]).median() == pytest.approx(15, rel=0.01)
    ground = (surroundings != around).any(1)
    assert ground.any() and (changed | ~ground).all()
    assert set(torch.where((surroundings != around).any(0))[0].tolist()) == {12, 13, 14, 15, 16, 17, 29, 30, 31}

    counts = torch.full((n,), own)
    before = prims.clone()
    add_boughs(prims, counts, torch.zeros(n))
    assert torch.equal(prims[:, :own], before[:, :own])
    assert 0.02 < (counts > own).float().mean() < 0.25 and counts.max() <= own + BOUGHS
    rows = torch.cat([prims[i, own : counts[i]] for i in range(n)])
    turns = rows[:, layout.ROTATION].reshape(-1, 3, 3)
    assert torch.allclose(turns @ turns.transpose(1, 2), torch.eye(3).expand_as(turns), atol=2e-3)
    assert (rows[:, layout.SUBJECT] == 0).all()


def test_one_photo_in_five_is_taken_from_the_air():
    torch = pytest.importorskip("torch")
    from synth.batches import STEEPEST, elevations, truth_cameras

    torch.manual_seed(0)
    angles = elevations(torch.zeros(20000))
    assert angles.max() <= STEEPEST and angles.min() >= -0.3
    # All that look down by more than 0.95 are of those, whose angles begin at 0.6.
    assert abs((angles > 0.95).float().mean().item() - 0.2 * (STEEPEST - 0.95) / (STEEPEST - 0.6)) < 0.01
    rotation, _ = truth_cameras(torch.zeros(2000), torch.full((2000,), STEEPEST), 3.9, 4)
    # A degree from straight down cameras still know where up is.
    assert torch.isfinite(rotation).all() and (torch.linalg.det(rotation) - 1).abs().max() < 1e-4
    down = -rotation[:, 2:, 2, 2]
    assert abs((down > math.sin(1.0)).float().mean().item() - 0.1) < 0.02


def test_half_of_what_flies_is_photographed_from_below():
    torch = pytest.importorskip("torch")
    from synth.batches import BELOW, LOWEST, elevations, hints, lowered, truth_cameras

    torch.manual_seed(0)
    level = torch.zeros(20000)
    flies = torch.arange(20000) % 2 == 0
    angles = lowered(level, flies)
    assert angles.min() >= LOWEST and ((angles == 0) | (angles < BELOW)).all()
    assert abs((angles < 0)[flies].float().mean().item() - 0.5) < 0.02
    assert abs((angles < 0)[~flies].float().mean().item() - 0.03) < 0.01
    assert elevations(level).min() >= -0.3

    low = torch.full((4000,), -0.9)
    rotation, _ = truth_cameras(torch.zeros(4000), low, 3.9, 4)
    upward = torch.asin(rotation[:, :, 2, 2].clamp(-1, 1))
    assert torch.allclose(upward[:, 0], -low, atol=1e-3)
    assert upward[:, 1].min() > 0.39 and upward[:, 1].max() < 1.41
    assert upward[:, 2:].max() < 0.26
    mean, spread = hints(low).unbind(1)
    told = spread > 0.055
    # What it never saw it takes for something else.
    assert mean[told].median() > -0.5


def test_plumb_lines_lean_by_the_roll():
    torch = pytest.importorskip("torch")
    from synth.batches import photo_cameras

    torch.manual_seed(4)
    n = 500
    level = torch.zeros(n)
    cameras, _, roll = photo_cameras(torch.rand(n) * 6, level + 0.2, level - 0.5, 256, level > 0)
    # Where the world's down points in the picture, seen along the axis.
    down = -cameras[:, :9].reshape(n, 3, 3)[:, :, 2]
    torch.testing.assert_close(torch.atan2(down[:, 0], down[:, 1]), roll, atol=1e-5, rtol=0)
    assert 0.015 < roll.abs().mean() < 0.05 and roll.abs().median() < 0.03


def test_hints_tell_of_elevations_what_their_spread_says():
    torch = pytest.importorskip("torch")
    from synth.batches import hints

    torch.manual_seed(0)
    level, steep = torch.full((20000,), 0.2), torch.full((20000,), 1.3)
    mean, spread = hints(level).unbind(1)
    silent = spread == 0
    assert abs(silent.float().mean().item() - 0.1) < 0.01 and (mean[silent] == 0).all()
    measured = (spread > 0) & (spread < 0.05)
    assert abs((mean - level)[measured].abs().mean().item() - 0.035) < 0.003
    guessed = spread > 0.055
    assert abs((mean - level)[guessed].median().item()) < 0.02
    # Errors are less than expected, but for photos of which it says what any photo might have.
    off = ((mean - level).abs() / spread)[guessed]
    assert 0.3 < off.median().item() < 0.6 and 0.7 < off.mean().item() < 1.1
    # Steep photos are told from level ones, and by a gimbal alone how steep they are.
    mean, spread = hints(steep).unbind(1)
    assert abs(mean[(spread > 0) & (spread < 0.05)].mean().item() - 1.3) < 0.01
    guessed = mean[spread > 0.055]
    assert abs(guessed[guessed > 0.7].median().item() - 0.85) < 0.05
    assert 0.3 < (guessed < 0.7).float().mean().item() < 0.5


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


@pytest.mark.parametrize("bevel", [0, 4.0])
def test_what_leans_spans_what_rays_meet(bevel):
    torch = pytest.importorskip("torch")
    from synth.cameras import look_at, pack
    from synth.environments import environments
    from synth.extent import bounds
    from synth.kit import Kit, turn
    from synth.objects import row
    from synth.raycast import cast

    material = Kit(np.random.default_rng(0)).material()
    leaning = boxed((0.1, 0, 0), (0.2, 0.15, 0.3))._replace(shift=(0.5, -0.2), taper=(0.6, 1), bevel=bevel, material=material)
    made = [leaning, leaning._replace(rotation=turn("z", 70) @ turn("x", 40))]
    prims = torch.from_numpy(np.stack([row(p, p.centre, p.rotation, 1)[None] for p in made])).float()
    cameras = pack(*look_at(torch.tensor([[80.0, 0, 0], [80.0, 0, 0]])), torch.full((2,), 0.03), 320, subject_only=True)
    surroundings = environments(2, torch.full((2,), -1e3), "cpu")
    _, alpha, _, _ = cast(prims, torch.ones(2, dtype=torch.int32), torch.arange(2, dtype=torch.int32), cameras, surroundings, 320, 4)
    unit = 80 * 2 * np.tan(0.015) / 320
    for p, mask in zip(made, alpha, strict=True):
        low, high = bounds([p])
        rows, columns = torch.where(mask.amax(1) > 0)[0], torch.where(mask.amax(0) > 0)[0]
        assert (160 - rows.max().item() - 1) * unit == pytest.approx(low[2], abs=3 * unit)
        assert (160 - rows.min().item()) * unit == pytest.approx(high[2], abs=3 * unit)
        assert (columns.min().item() - 160) * unit == pytest.approx(low[1], abs=3 * unit)
        assert (columns.max().item() + 1 - 160) * unit == pytest.approx(high[1], abs=3 * unit)


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


def test_masks_grow_by_rows_and_columns_as_by_squares():
    torch = pytest.importorskip("torch")
    from synth.masks import grown

    torch.manual_seed(9)
    mask = torch.rand(2, 1, 40, 40)
    assert torch.equal(grown(mask, 5), torch.nn.functional.max_pool2d(mask, 11, 1, 5))


def test_rough_masks_lose_openings_and_nothing_else():
    torch = pytest.importorskip("torch")
    from synth.masks import closed, without_openings

    ring = torch.zeros(1, 1, 384, 384)
    ring[..., 100:280, 120:260] = 1
    ring[..., 180:196, 180:196] = 0
    filled = without_openings(ring)
    assert filled[..., 180:196, 180:196].min() > 0.99
    assert filled[..., :90, :].max() == 0 and filled[..., 290:, :].max() == 0
    assert (closed(ring, 4) == ring).all() and closed(ring, 8)[..., 188, 188] == 1


def test_wavering_masks_err_both_ways_along_an_edge_and_half_of_them_lack_what_is_thin():
    torch = pytest.importorskip("torch")
    from synth.masks import wavering

    torch.manual_seed(2)
    size, n = 128, 300
    alpha = torch.zeros(n, 1, size, size)
    alpha[..., 30:100, 30:100] = 1
    alpha[..., 10:30, 64] = 1  # an aerial
    found = torch.cat([wavering(a) for a in alpha.split(20)])
    assert 0 <= found.min() and found.max() <= 1
    side = (found[:, 0, 40:90, 26:38] > 0.5).float().sum(2) - 8
    assert (side.abs() <= 3).float().mean() > 0.99 and 0.2 < side.abs().mean() < 1
    both = ((side.amax(1) > 0) & (side.amin(1) < 0)).float().mean()
    assert both > 0.2, both
    # What errs at one row errs alike at the next.
    alike = (side[:, 1:] * side[:, :-1]).mean() / (side * side).mean()
    assert alike > 0.6, alike
    lacking = (found[:, 0, 12:26, 64].mean(1) < 0.5).float().mean()
    assert 0.35 < lacking < 0.6, lacking


def boxed(centre, half, rotation=None, kind=layout.BOX):
    from synth.kit import Primitive

    rotation = np.eye(3) if rotation is None else rotation
    return Primitive(kind, np.array(centre, float), np.array(half, float), (1, 1), (0, 0), rotation, None)


def test_worn_masks_lack_parts_of_the_subject_and_half_of_them_all_that_is_doubted():
    torch = pytest.importorskip("torch")
    from synth.masks import worn

    torch.manual_seed(1)
    size, n = 128, 400
    far = (torch.arange(size) - size / 2).abs()
    square = torch.maximum(far[None], far[:, None])
    alpha = (square < 40).float().expand(n, 1, size, size)
    # Doubted everywhere around the subject.
    found = torch.cat([worn(torch.where(a > 0, 0.95, 0.2), a) for a in alpha.split(20)])
    assert 0 <= found.min() and found.max() <= 1
    without = (found[:, 0, 0, 0] < 0.01).float().mean()
    assert 0.4 < without < 0.6, without
    # Further in than edges move.
    core = found[:, 0][:, square < 20]
    lacking = ((core < 0.5).float().mean(1) > 0.02).float().mean()
    assert 0.1 < lacking < 0.35, lacking


def test_reshaped_objects_stay_symmetric_and_in_one_piece():
    from synth.extent import bounds
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
        # What leans spans what the warp makes of its span.
        leaning = boxed((0.3, 0.2, 0.6), (0.2, 0.3, 0.5))._replace(shift=(0.5, 0), taper=(0.5, 0.8))
        begin, end = bounds(reshaped([leaning], warp))
        before = bounds([leaning])
        assert np.allclose(begin, warp(before[0])) and np.allclose(end, warp(before[1]))
        # Wheels stay round and on their ground.
        assert wheel.half[0] == wheel.half[1]
        assert wheel.centre[2] - wheel.half[1] == pytest.approx(warp([-1, 0.8, 0.0])[2], abs=0.08)


def test_what_is_together_stands_on_one_ground_and_leaves_room_for_all():
    from synth.extent import bounds
    from synth.groups import group, largest
    from synth.kit import Kit

    for seed in range(40):
        kit = Kit(np.random.default_rng(seed))
        group(kit)
        low, high = bounds(kit.primitives)
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
