"""One training step's loss for either network, with figures to print and pictures to look at."""

import math

import torch
import torch.nn.functional as F

from nets import CROP_HALF, CROP_NEARNESS, SplatNet, halved
from synth.batches import scene_batch, splat_batch
from synth.cameras import fixed
from synth.details import detail_batch


def gradients(x):
    """Mean absolute difference of neighbours, across and down, of x [..., H, W]."""
    across = (x[..., 1:] - x[..., :-1]).abs().mean()
    down = (x[..., 1:, :] - x[..., :-1, :]).abs().mean()
    return across + down


# ---------------------------------------------------------------- SceneNet


def scene_step(net, pool, n):
    """Returns loss, figures {name: number} and picture columns, each [n, 1 or 3, S, S] in 0..1."""
    batch = scene_batch(pool, n)
    with torch.autocast("cuda", torch.bfloat16):
        logits, depth, elevation, _ = net(torch.cat([batch.photo, batch.point], 1))
    logits = logits[:, 0].float()
    depth = depth[:, 0].float()
    truth = normalised_inverse_depth(batch.depth)
    answer = centred(depth)
    mask_loss = mask_losses(logits, batch.alpha, batch.shade)
    depth_loss, edge_loss = depth_losses(answer, truth, batch.alpha)
    elevation_loss, off = guess_losses(elevation, batch.elevation)
    loss = mask_loss + 0.6 * depth_loss + 0.5 * edge_loss + 0.05 * elevation_loss
    figures = {"iou": mask_iou(logits, batch.alpha), "l_d": depth_loss, "el_deg": off}
    columns = [
        batch.photo,
        batch.alpha[:, None],
        torch.sigmoid(logits)[:, None],
        (truth[:, None] + 1.5) / 5,
        (answer[:, None] + 1.5) / 5,
    ]
    return loss, figures, columns


def held_step(net, pool, n):
    """As `scene_step`, of what SceneNet says of how the camera was held alone."""
    batch = scene_batch(pool, n)
    with torch.autocast("cuda", torch.bfloat16):
        _, _, had, held = net(torch.cat([batch.photo, batch.point], 1))
    elevation_loss, off = guess_losses(held[:, :2], batch.elevation)
    roll_loss, rolled_off = guess_losses(held[:, 2:], batch.roll)
    figures = {"el_deg": off, "had_deg": guess_losses(had, batch.elevation)[1], "roll_deg": rolled_off}
    figures["level_deg"] = batch.roll.abs().mean() * (180 / math.pi)
    return elevation_loss + roll_loss, figures, [batch.photo]


def detail_step(net, pool, n, masks):
    """As `scene_step`, for DetailNet; `masks`: `synth.details.detail_batch`."""
    batch = detail_batch(pool, n, masks)
    with torch.autocast("cuda", torch.bfloat16):
        logits, depth = net(torch.cat([batch.photo, batch.rough], 1))
    logits = logits[:, 0].float()
    truth = normalised_inverse_depth(batch.depth)
    answer = centred(depth[:, 0].float())
    depth_loss, edge_loss = depth_losses(answer, truth, batch.alpha)
    loss = mask_losses(logits, batch.alpha, batch.shade) + 0.2 * depth_loss + 0.15 * edge_loss
    figures = {
        "iou": mask_iou(logits, batch.alpha),
        "iou_rough": mask_iou(batch.before - 0.5, batch.alpha),
        "iou_worn": mask_iou(batch.rough[:, 0] - 0.5, batch.alpha),
        "l_d": depth_loss,
    }
    columns = [
        batch.photo,
        batch.rough,
        batch.alpha[:, None],
        torch.sigmoid(logits)[:, None],
        (truth[:, None] + 1.5) / 5,
        (answer[:, None] + 1.5) / 5,
    ]
    return loss, figures, columns


def mask_losses(logits, alpha, shade):
    """Cross-entropy and Dice, [n, S, S]; pictures whose subject is all but out of view do not count.

    Near the subject's edge, and on its thin parts, which are all edge, cross-entropy weighs more; so it does where
    `shade` [n, S, S] lies beside the subject. The fiftieth of each
    picture that is most wrong (a shadow that is taken for the subject, a part that is missing) counts once more.
    """
    seen = (alpha.flatten(1).mean(1) > 0.01)[:, None, None].float()
    mask = torch.sigmoid(logits)
    overlap = (mask * alpha * seen).sum((1, 2))
    dice = 1 - (2 * overlap + 1) / (((mask + alpha) * seen).sum((1, 2)) + 1)
    around = alpha[:, None]
    edge = (F.max_pool2d(around, 7, 1, 3) + F.max_pool2d(-around, 7, 1, 3))[:, 0]
    beside = F.interpolate(F.max_pool2d(F.avg_pool2d(around, 4), 9, 1, 4), scale_factor=4.0)[:, 0] * shade
    weight = seen * (1 + 2 * edge + 2 * beside * (1 - alpha))
    entropy = F.binary_cross_entropy_with_logits(logits, alpha, reduction="none")
    # Less the entropy of the coverage itself, or edges would always be among the worst.
    known = alpha.clamp(1e-4, 1 - 1e-4)
    excess = entropy + known * known.log() + (1 - known) * (1 - known).log()
    worst = (excess * seen).flatten(1).topk(max(1, alpha[0].numel() // 50), 1).values
    return (entropy * weight).mean() * 1.6 + 0.1 * worst.mean() + dice.mean()


def centred(x):
    """x [n, H, W] without its own offset and scale: less its median, over its mean absolute deviation."""
    middle = x.flatten(1).median(1)[0][:, None, None]
    spread = (x - middle).abs().mean((1, 2), keepdim=True) + 1e-3
    return (x - middle) / spread


def normalised_inverse_depth(depth):
    """Inverse depth of depth [n, H, W] (0 = infinitely far), centred."""
    inverse = torch.where(depth > 0, 1 / depth.clamp(min=0.1), torch.zeros_like(depth))
    return centred(inverse)


def depth_losses(answer, truth, alpha):
    """Absolute error, the subject weighing three times as much, and the error's gradients at three scales."""
    error = answer - truth
    absolute = (error.abs() * (1 + 2 * alpha)).mean()
    edges = sum(gradients(F.avg_pool2d(error[:, None], step)) for step in (1, 2, 4))
    return absolute, edges


def guess_losses(answer, truth):
    """Negative log-likelihood of truth [n] under Laplace distributions [n, 2], and the mean error in degrees."""
    off = (answer[:, 0] - truth).abs()
    return (off / answer[:, 1] + answer[:, 1].log()).mean(), off.mean() * (180 / math.pi)


@torch.no_grad()
def mask_iou(logits, alpha):
    answer = logits > 0
    truth = alpha > 0.5
    union = (answer | truth).sum((1, 2)) + 1
    return ((answer & truth).sum((1, 2)) / union).mean()


# ---------------------------------------------------------------- SplatNet


# Of the errors of SplatNet's camera: size, middle, nearness.
CAMERA_WEIGHTS = (0.3, 0.3, 0.3, 0.05)
# Pixels of the squares whose mean colour a texture leaves as it is, about.
PATCH = 8
# Parts narrower than so many pixels are slender, and so much more their pixels count, and those beside them.
NARROW = 7
SLENDER_WEIGHT = 2.0


def splat_step(net, pool, n, heed=None, perception=None, perceived=0.0, overlap=0.2):
    """Returns loss, figures {name: number} and picture columns, each [n, 3, S, S] in 0..1.

    `heed` adds what a critic asks for: `critic.Adversary.heeded`. `perceived`: weight of how unlike views look to `perception`, a
    `perception.Perception`; `overlap`: of how well the views' silhouettes fit.
    """
    batch = splat_batch(pool, n, SplatNet.FOV, SplatNet.DIST)
    with torch.autocast("cuda", torch.bfloat16):
        splats = net(batch.rgba, batch.hint)
    colour, alpha = render(splats | brought_home(splats, batch), batch.views, batch.lenses, batch.alpha.shape[-1])
    background = torch.rand(*batch.colour.shape[:3], 1, 1, device=colour.device)
    made = torch.cat([colour + (1 - alpha) * background, alpha], 2)
    answer, alpha = made[:, :, :3], made[:, :, 3:]
    truth = batch.colour + (1 - batch.alpha) * background

    weight = importance(batch) * (1 + SLENDER_WEIGHT * slender(batch.alpha))
    error = answer - truth
    coarse = loosened(error, batch.dressed)
    colour_loss = (weight * (coarse.abs() * 0.8 + coarse * coarse)).mean()
    uncovered = alpha - batch.alpha
    alpha_loss = (weight * (uncovered**2 + 0.3 * uncovered.abs())).mean()
    edge_loss = sum(gradients(pooled(weight * coarse, step)) for step in (1, 2, 4))
    present = (~batch.empty).float()[:, None, None, None, None]
    overlap_loss = (present * silhouette_losses(alpha, batch.alpha)).mean()
    depth_loss = front_depth_loss(splats["depth"], batch)
    elevation_loss, off = guess_losses(splats["elevation"], batch.elevation)
    camera_loss = F.smooth_l1_loss(splats["camera"], batch.camera, beta=0.03, reduction="none")
    camera_loss = (camera_loss * present[:, 0, 0, 0] * fixed(CAMERA_WEIGHTS, camera_loss.device)).sum(1).mean()
    size_loss = F.relu(splats["scale"] - 0.06).mean()
    loss = colour_loss + alpha_loss + 0.7 * edge_loss / 3 + 0.25 * depth_loss + 2 * size_loss
    loss = loss + overlap * overlap_loss + 0.02 * elevation_loss + camera_loss
    figures = {
        **view_scores(answer, truth, alpha, batch.alpha, present[:, 0]),
        "overlap": overlap_loss,
        "depth": depth_loss,
        "zoom": (splats["camera"] - batch.camera)[:, 0].abs().mean(),
        "el_deg": off,
    }
    true = torch.cat([truth, batch.alpha], 2)
    if perception:
        figures["unlike"] = perceived_loss(perception, made, true, batch)
        loss = loss + perceived * figures["unlike"]
    if heed:
        asked, figures["critic"] = heed(made, true, halved(batch.rgba), loss, batch.dressed)
        loss = loss + asked
    columns = [halved(batch.rgba[:, :3]), *truth.unbind(1), *answer.unbind(1)]
    return loss, figures, columns


def error_step(net, pool, n):
    """The loss of SplatNet's expected error alone: what is drawn of it against the error of what is drawn of the colours.

    A pixel's error is the mean absolute difference of sRGB channels between answer and truth, before white and before
    black, half each. The expected one is blended along the ray as colours are, over coverage.
    """
    batch = splat_batch(pool, n, SplatNet.FOV, SplatNet.DIST)
    with torch.autocast("cuda", torch.bfloat16):
        splats = net(batch.rgba, batch.hint)
    home = splats | brought_home(splats, batch)
    home["rgb"] = torch.cat([home["rgb"], splats["error"][..., None]], 2)
    drawn, alpha = render(home, batch.views, batch.lenses, batch.alpha.shape[-1])
    colour, expected = drawn[:, :, :3].detach(), drawn[:, :, 3:] / alpha.detach().clamp(min=0.02)
    alpha = alpha.detach()
    on_black = colour - batch.colour
    on_white = on_black - (alpha - batch.alpha)
    error = 0.5 * (on_black.abs() + on_white.abs()).mean(2, keepdim=True)
    # Textures that the views do not have are no error.
    weight = alpha * (~batch.empty).float()[:, None, None, None, None]
    weight[: batch.dressed] = 0
    loss = (weight * (expected - error) ** 2).sum() / weight.sum().clamp(min=1)
    middle = (weight * error).sum() / weight.sum().clamp(min=1)
    variance = (weight * (error - middle) ** 2).sum() / weight.sum().clamp(min=1)
    figures = {"error": middle, "explained": 1 - loss.detach() / variance.clamp(min=1e-6)}
    heat = [plane.expand(-1, 3, -1, -1) * 2 for plane in (*error.unbind(1), *(expected * alpha).detach().unbind(1))]
    return 100 * loss, figures, [halved(batch.rgba[:, :3]), *heat]


def brought_home(splats, batch):
    """The answer's pos [n, m, 3] and scale [n, m, 3], as large and as far as the truth is.

    No photo shows how long its subject is along the line of sight, so neither its unit nor its middle: a loss that
    asked for them would blur every other view. So each Gaussian keeps its place in the crop, the relief is stretched
    by what the crop's size was wrong, and all move by the mean error of the front layer's depth. What the answer says
    of camera and depth has losses of its own.
    """
    middle = SplatNet.DIST
    stretch = torch.exp((batch.camera - splats["camera"])[:, 0].clamp(-0.4, 0.4))[:, None]
    relief = (splats["pos"][..., 2] - middle) * stretch
    valid = front_seen(batch)
    surface = (splats["depth"] - middle) * stretch[..., None]
    off = ((batch.front - middle - surface) * valid).sum((1, 2)) / valid.sum((1, 2)).clamp(min=1)
    moved = relief + off.clamp(-0.5, 0.5)[:, None]

    def spread(camera, depth):
        nearness = CROP_NEARNESS * torch.exp(camera[:, 3:].clamp(-1.5, 1.5))
        return (1 + nearness * depth).clamp(min=0.1)

    def across(camera):
        return CROP_HALF * torch.exp(camera[:, 0])[:, None, None], camera[:, None, 1:3]

    half, aside = across(splats["camera"])
    place = (splats["pos"][..., :2] / spread(splats["camera"], splats["pos"][..., 2] - middle)[..., None] - aside) / half
    half, aside = across(batch.camera)
    beside = (place * half + aside) * spread(batch.camera, moved)[..., None]
    return {
        "pos": torch.cat([beside, (moved + middle)[..., None]], 2),
        "scale": splats["scale"] * stretch[..., None],
    }


def render(splats, views, lenses, size):
    """Splat into views [n, V, 4, 4] with lenses [n, V, 3] (focal length, middle): colour [n, V, 3, S, S], alpha [n, V, 1, S, S].

    Gaussians smaller than a pixel count by what they cover ("antialiased"), not by what the blur makes of them.
    """
    from gsplat import rasterization

    focal, across, down = lenses.unbind(-1)
    zero, one = torch.zeros_like(focal), torch.ones_like(focal)
    rows = [torch.stack(row, -1) for row in ((focal, zero, across), (zero, focal, down), (zero, zero, one))]
    colour, alpha, _ = rasterization(
        splats["pos"],
        splats["quat"],
        splats["scale"],
        splats["opacity"],
        splats["rgb"],
        views,
        torch.stack(rows, -2),
        size,
        size,
        packed=False,
        near_plane=0.1,
        rasterize_mode="antialiased",
    )
    return colour.permute(0, 1, 4, 2, 3), alpha.permute(0, 1, 4, 2, 3)


def importance(batch):
    """How much each subject's pixels count, [n, 1, 1, 1, 1], in the mean 1: what covers little of its views counts more a pixel.

    Else blades, wings and posts would teach next to nothing beside what fills its pictures. Empty crops do not count.
    """
    share = batch.alpha.mean((1, 2, 3, 4), keepdim=True).clamp(min=0.01)
    weight = share**-0.5 * (~batch.empty).float()[:, None, None, None, None]
    return weight / weight.mean().clamp(min=1e-3)


def slender(alpha):
    """Where coverage [n, V, 1, S, S] is of parts narrower than `NARROW` pixels and up to two pixels beside them, 0..1.

    Coverage less its opening by a square, the white top-hat (Serra 1982): blades, posts, legs and rails, and sharp corners.
    """
    flat = alpha.flatten(0, 1)
    eroded = -F.max_pool2d(-flat, NARROW, 1, NARROW // 2)
    narrow = flat - F.max_pool2d(eroded, NARROW, 1, NARROW // 2)
    return F.max_pool2d(narrow, 5, 1, 2).clamp(0, 1).reshape(alpha.shape)


def silhouette_losses(alpha, truth):
    """1 - Dice of each view's coverage, [n, V, 1, 1, 1], of [n, V, 1, S, S]: the same for slender subjects as for full ones."""
    overlap = (alpha * truth).sum((2, 3, 4), keepdim=True)
    return 1 - (2 * overlap + 1) / ((alpha + truth).sum((2, 3, 4), keepdim=True) + 1)


def perceived_loss(perception, answer, truth, batch):
    """How unlike views [n, V, 4, S, S] look in the mean, by the subjects' importance.

    Of every other subject the second view, near the photo's, of the others the fourth, from anywhere; not of the first `dressed`
    ones, whose crops wear textures that the true views lack. One view each, as two took 0.1 s of a step's 0.34 s.
    """
    answer, truth, weight = (t[batch.dressed :] for t in (answer, truth, importance(batch)[:, 0, 0, 0, 0]))
    each = torch.arange(len(answer), device=answer.device)
    view = 1 + 2 * (each % 2)
    return (perception(answer[each, view], truth[each, view]) * weight).mean()


def loosened(error, dressed):
    """Colour errors [n, V, 3, S, S] of which the first `dressed` are means over squares of `PATCH` pixels."""
    squares = F.interpolate(pooled(error[:dressed], PATCH), scale_factor=float(PATCH))
    return torch.cat([squares.reshape(error[:dressed].shape), error[dressed:]])


def pooled(x, step):
    return F.avg_pool2d(x.flatten(0, 1), step)


def front_depth_loss(depth, batch):
    """Mean distance between the front layer's depth [n, S, S] and the truth in the crop, on the subject; each subject counts alike,
    its slender parts more than the rest of it."""
    valid = front_seen(batch)
    weight = valid * (1 + SLENDER_WEIGHT * slender(valid[:, None, None].float())[:, 0, 0])
    each = ((depth - batch.front).abs() * weight).sum((1, 2)) / weight.sum((1, 2)).clamp(min=1)
    return each.sum() / valid.any(2).any(1).sum().clamp(min=1)


def front_seen(batch):
    """Where the crop shows the subject and the mask has it, [n, S, S]."""
    return (batch.front > 0) & (halved(batch.rgba)[:, 3] > 0.5) & ~batch.empty[:, None, None]


@torch.no_grad()
def view_scores(answer, truth, alpha, truth_alpha, weight):
    """PSNR (dB) of the photo's own view, a near one and a far one, and the far one's silhouette IoU."""

    def psnr(view):
        return -10 * torch.log10(((answer - truth)[:, view] ** 2 * weight).mean())

    far = answer.shape[1] - 1
    inside = (alpha > 0.5)[:, far]
    truly = (truth_alpha > 0.5)[:, far]
    iou = (inside & truly).float().sum() / ((inside | truly).float().sum() + 1)
    return {"psnr_in": psnr(0), "psnr_near": psnr(1), "psnr_far": psnr(far), "iou_far": iou}


STEPS = {"scene": scene_step, "held": held_step, "detail": detail_step, "splat": splat_step, "error": error_step}
