"""Checks of what SplatNet is told of the lens: python -m pytest test_lens.py (it needs torch)."""

import math

import pytest


def test_a_known_lens_settles_how_near_the_camera_stands():
    torch = pytest.importorskip("torch")
    from evaluate import FILL, crop_tangent
    from nets import CROP_HALF, CROP_NEARNESS, CROP_TANGENT, SplatNet, placed

    camera = torch.tensor([[0.2, 0.1, -0.1, 0.7], [0.2, 0.1, -0.1, 0.7]])
    known = torch.tensor([[1.0], [0.0]])
    told = placed(camera, torch.log(torch.tensor([[0.2], [1.0]]) / CROP_TANGENT) * known, known)
    assert (told[:, :3] == camera[:, :3]).all() and told[1, 3] == camera[1, 3]
    half, nearness = CROP_HALF * torch.exp(told[0, 0]), CROP_NEARNESS * torch.exp(told[0, 3])
    assert abs(half * nearness - 0.2) < 1e-6

    # Whatever the network guesses, its camera sees the crop at the angle that it is told.
    torch.manual_seed(0)
    net = SplatNet().eval()
    with torch.no_grad():
        net.camera[2].bias += torch.tensor([0.1, 0.0, 0.0, 0.4])
        answers = net(torch.rand(2, 4, 256, 256), torch.tensor([[0.2, 0.1, 0.3], [0.2, 0.1, 0.0]]))["camera"]
    tangents = CROP_TANGENT * torch.exp(answers[:, 0] + answers[:, 3])
    assert abs(tangents[0] - 0.3) < 1e-5 and abs(tangents[1] - CROP_TANGENT * math.exp(0.5)) < 0.05

    mask = torch.zeros(512, 512)
    mask[200:312, 206:306] = 1
    assert abs(crop_tangent(mask, 700) - 56 / FILL / 700) < 1e-9
    aside = torch.roll(mask, 150, 1)
    assert abs(crop_tangent(aside, 700) / crop_tangent(mask, 700) - (700 / math.hypot(700, 150)) ** 1.5) < 1e-6


def test_half_of_all_lenses_are_told_to_three_per_cent():
    torch = pytest.importorskip("torch")
    from nets import CROP_TANGENT
    from synth.batches import lenses_told

    torch.manual_seed(0)
    # Half the crop's width 1.2 at a distance of 5: size and nearness say the same angle.
    camera = torch.tensor([1.2, 0.3, -0.2, 1 / 5]).repeat(20000, 1)
    camera[:, 0], camera[:, 3] = torch.log(camera[:, 0] / (3.9 * CROP_TANGENT)), torch.log(camera[:, 3] * 3.9)
    told = lenses_told(camera)
    assert told.shape == (20000, 1)
    known = told[told > 0]
    assert abs(len(known) / 20000 - 0.5) < 0.02
    off = torch.log(known / (1.2 / 5))
    assert abs(off.mean().item()) < 0.001 and abs(off.std().item() - 0.03) < 0.002
