"""Training batches: random objects, freshly coloured, in random surroundings, seen by random cameras.

Every random draw on the GPU comes from PyTorch's global generator, in a fixed order.
"""

import math
from multiprocessing import Pool as Processes
from typing import NamedTuple

import numpy as np
import torch
import torch.nn.functional as F

from nets import CROP_HALF, CROP_NEARNESS, CROP_TANGENT, halved

from .cameras import crop, inverses, look_at, matrices, orbit, pack, rolled
from .clutter import BOUGHS, add_boughs, add_distractor, add_perch, disguise
from .draws import recolour, uniform
from .environments import environments
from .foliage import broadleaf, leafy
from .layout import CENTRE_X, CENTRE_Y, FLOATS, FOCAL, PRIMS
from .lens import bent, coarsened, defocused, exposed, stored
from .masks import damaged, leaked
from .objects import AIRBORNE, COMPANIONS, SLENDER, make_object
from .raycast import cast
from .textures import make_bank, textured
from .water import above_water, flooded, waters

# Of SplatNet's subjects so many have thin or pierced parts, beyond their share of all objects.
SLENDER_SHARE = 0.25
# Of SplatNet's crops one in so many wears a texture: photographs are never as plain as primitives.
DRESSED = 3
# Objects that may stand around the subject of a photo.
DISTRACTORS = 5
# Behind so many of the subjects with thin or pierced parts something stands that is seen through them.
SEEN_THROUGH = 0.4
GREY = 0.5
# The most that cameras look down, radians: at straight down no side of the picture is towards the subject's front.
STEEPEST = 1.55
# The most that they look up, radians, and of how many of SplatNet's subjects: of those that fly, and of the others.
LOWEST = -1.2
FROM_BELOW = 0.5, 0.03
# Deviations of the cameras' roll, radians: of those that are held with care, and of the others.
ROLLS = 0.017, 0.07
# From here on down a camera looks from below, radians.
BELOW = -0.25


class Pool(NamedTuple):
    """Objects to draw from: prims [N, PRIMS, 36], counts [N] int32, grounds [N] (height of the ground).

    companions [M]: the indices of those that often stand near others; foliage [F]: of trees and bushes; slender [L]: of what
    has thin or pierced parts; airborne [A]: of what flies.
    textures [T, 3, S, S]: see `textures`.
    """

    prims: torch.Tensor
    counts: torch.Tensor
    grounds: torch.Tensor
    companions: torch.Tensor
    foliage: torch.Tensor
    slender: torch.Tensor
    airborne: torch.Tensor
    textures: torch.Tensor


def make_pool(first_seed, count, processes, device="cuda", textures=384):
    """The objects of `count` consecutive seeds."""
    seeds = range(first_seed, first_seed + count)
    with Processes(processes) as workers:
        made = workers.map(make_object, seeds, chunksize=64)

    def indices(wanted):
        return torch.tensor([i for i, m in enumerate(made) if wanted(m)] or [0], device=device)

    return Pool(
        prims=torch.from_numpy(np.stack([m.rows for m in made])).to(device),
        counts=torch.tensor([m.count for m in made], dtype=torch.int32, device=device),
        grounds=torch.tensor([m.ground for m in made], dtype=torch.float32, device=device),
        companions=indices(lambda m: m.maker in COMPANIONS),
        foliage=indices(lambda m: m.maker in (leafy, broadleaf)),
        slender=indices(lambda m: m.maker in SLENDER),
        airborne=indices(lambda m: m.maker in AIRBORNE),
        textures=make_bank(textures, device),
    )


def subjects(pool, n, slender):
    """Indices [n] of objects, a share `slender` of them of what has thin or pierced parts, beyond theirs of all objects."""
    device = pool.prims.device
    thin = pool.slender[torch.randint(len(pool.slender), (n,), device=device)]
    any_ = torch.randint(len(pool.prims), (n,), device=device)
    return torch.where(torch.rand(n, device=device) < slender, thin, any_)


def elevations(like):
    """Of cameras, radians, one a row of `like`: most photos are taken from the height of eyes or a little above, one in five
    from the air, up to straight above."""
    kind = uniform(like, 0, 1)
    usual = torch.where(kind < 0.43, uniform(like, -0.02, 0.5), uniform(like, -0.08, 0.95))
    return torch.where(kind < 0.64, usual, torch.where(kind < 0.8, uniform(like, -0.3, 0.12), uniform(like, 0.6, STEEPEST)))


def lowered(elevation, flies):
    """The elevations [n] with some photos from below among them, many of what `flies` [n]."""
    share = torch.where(flies, *FROM_BELOW)
    return torch.where(uniform(elevation, 0, 1) < share, uniform(elevation, LOWEST, BELOW), elevation)


def hints(elevation):
    """What is known beforehand of elevations [n], as `nets.SplatNet` reads it [n, 2]: mostly what SceneNet says of a whole photo,
    now and then what a gimbal measured, or nothing (0, 0).

    SceneNet tells steep views apart but not how steep they are, and takes three in ten of them for level ones; its errors are on the
    whole less than it expects; and of some photos it says what any photo might have. Of photos from below it saw hardly any.
    """
    kind, steep, low = uniform(elevation, 0, 1), elevation > 0.6, elevation < BELOW
    spread = torch.exp(uniform(elevation, math.log(0.06), math.log(0.2)))
    spread = torch.where(steep, spread.clamp(min=0.12), spread)
    told = torch.where(steep, 0.6 + 0.35 * (elevation - 0.6), torch.where(low, BELOW + 0.35 * (elevation - BELOW), elevation))
    told = told + laplace(elevation) * spread * uniform(elevation, 0.2, 1.1)
    lost = (kind < 0.12) | steep & (uniform(elevation, 0, 1) < 0.3) | low & (uniform(elevation, 0, 1) < 0.6)
    told = torch.where(lost, torch.where(low, uniform(elevation, -0.2, 0.6), uniform(elevation, 0.05, 0.7)), told)
    exact = uniform(elevation, 0.02, 0.05)
    measured = (kind > 0.75) & (kind < 0.9)
    hint = torch.stack(
        [torch.where(measured, elevation + laplace(elevation) * exact, told), torch.where(measured, exact, spread)], 1
    )
    return hint * (kind < 0.9)[:, None]


def lenses_told(camera):
    """What is known beforehand of the photos' focal lengths, as `nets.SplatNet` reads it [n, 1], of cameras as `crop_camera` has them:
    of half of the photos the tangent of half the angle that the crop spans, to the 3 % by which files tell of lenses, or 0."""
    tangent = CROP_TANGENT * torch.exp(camera[:, 0] + camera[:, 3] + 0.03 * torch.randn_like(camera[:, 0]))
    return (tangent * (uniform(tangent, 0, 1) < 0.5))[:, None]


def laplace(like):
    """Draws [n] of the Laplace distribution of scale 1."""
    return torch.empty_like(like).exponential_() - torch.empty_like(like).exponential_()


# ---------------------------------------------------------------- photos of scenes


class SceneBatch(NamedTuple):
    """photo [n, 3, S, S] sRGB 0..1; point [n, 1, S, S], as `point_map` draws it, or 0 where none is given;
    alpha [n, S, S], coverage by the subject; depth [n, S, S], 0 = sky; shade [n, S, S], how much of each pixel is not the
    subject and lies in a shadow; elevation and roll [n] of the camera, radians (`nets.SceneNet`)."""

    photo: torch.Tensor
    point: torch.Tensor
    alpha: torch.Tensor
    depth: torch.Tensor
    shade: torch.Tensor
    elevation: torch.Tensor
    roll: torch.Tensor


class Stage(NamedTuple):
    """Scenes before they are photographed: prims [n, P, 36], counts [n], cameras [n, 20], their elevation and roll [n], surroundings
    [n, 40], whether by usual daylight and whether a point says what the subject is, [n] bool each."""

    prims: torch.Tensor
    counts: torch.Tensor
    cameras: torch.Tensor
    elevation: torch.Tensor
    roll: torch.Tensor
    surroundings: torch.Tensor
    daylight: torch.Tensor
    pointed: torch.Tensor


def scene_batch(pool, n, size=256):
    """Photos of a subject with other objects on the same ground.

    In half of them a point on the subject says which it is, and it may stand anywhere; in the others it stands near
    the middle.
    """
    stage = staged(pool, torch.randint(len(pool.prims), (n,), device=pool.prims.device), size)
    rgb, alpha, depth, shade = seen_by(stage, stage.cameras, size)
    water = waters(alpha)
    dressed, rgb = flooded(torch.cat([textured(rgb, alpha, depth, pool.textures), rgb], 1), water).chunk(2, 1)
    alpha, shade = above_water(alpha, shade, water)
    photo = taken(dressed, rgb, alpha, depth, stage.daylight)
    photo, alpha, depth, shade = reframed(photo, alpha, depth, shade)
    return SceneBatch(photo, points(alpha, stage.pointed), alpha, depth, shade, stage.elevation, stage.roll)


def staged(pool, chosen, size):
    """The objects of indices `chosen` [n] among others, seen by hand-held cameras whose pictures have `size` pixels."""
    n, device = len(chosen), chosen.device
    subject = recolour(pool.prims[chosen])
    ground = pool.grounds[chosen]
    pointed = uniform(chosen, 0, 1) < 0.5
    azimuth = uniform(chosen, 0, 6.283)
    elevation = elevations(chosen)
    prims = torch.zeros(n, PRIMS * (1 + DISTRACTORS) + BOUGHS + 2, FLOATS, device=device)
    prims[:, :PRIMS] = subject
    counts = pool.counts[chosen].clone().long()
    overgrown = uniform(chosen, 0, 1) < 0.18
    through = torch.isin(chosen, pool.slender) & (uniform(chosen, 0, 1) < SEEN_THROUGH)
    for i in range(DISTRACTORS):
        add_distractor(prims, counts, pool, ground, azimuth, overgrown, before=i == 0, behind=through & (i == 1))
    ground = add_perch(prims, counts, ground)
    add_boughs(prims, counts, azimuth)
    cameras, elevation, roll = photo_cameras(azimuth, elevation, ground, size, pointed)
    daylight = uniform(chosen, 0, 1) < 0.4
    surroundings = environments(n, ground, device, daylight)
    disguise(prims, surroundings, subject, pool.counts[chosen])
    return Stage(prims, counts.int(), cameras, elevation, roll, surroundings, daylight, pointed)


def seen_by(stage, cameras, size):
    """What `raycast.cast` makes of the scenes, each by the camera in its row."""
    each = torch.arange(len(cameras), device=cameras.device, dtype=torch.int32)
    return cast(stage.prims, stage.counts, each, cameras, stage.surroundings, size, 2)


def taken(photo, rgb, alpha, depth, daylight):
    """The textured picture as a camera takes and keeps it; in daylight often nearer to the plain one `rgb`."""
    photo = calmed(defocused(photo, alpha, depth), rgb, daylight, 0.5)
    photo = calmed(exposed(photo), photo, daylight, 1)
    return calmed(stored(photo), photo, daylight, 0.7)


def calmed(changed, photo, daylight, chance):
    """Of pictures [n, 3, S, S], where `daylight` [n] is set and with that chance, a random part of the change alone."""
    part = torch.where(daylight & (uniform(photo, 0, 1) < chance), uniform(photo, 0, 0.6), torch.ones_like(photo[:, 0, 0, 0]))
    return photo + part[:, None, None, None] * (changed - photo)


def photo_cameras(azimuth, elevation, ground, size, anywhere):
    """Hand-held cameras: above the ground, roughly at the subject, slightly rolled; the subject small to overfull.

    Where `anywhere` [n] is set they look aside further. Some pictures are squeezed, as non-square photos are before
    the network sees them. Returns their rows, their elevations above the subject's centre and their roll [n].
    """
    n = len(azimuth)
    device = azimuth.device
    fov = uniform(azimuth, 0.3, 1.25)
    fill = torch.where(uniform(azimuth, 0, 1) < 0.2, uniform(azimuth, 0.2, 0.9), uniform(azimuth, -1.15, 0.35))
    distance = 1 / torch.tan(fov / 2) / torch.exp(fill) + 0.25
    eye = orbit(azimuth, elevation, distance)
    eye[:, 2] = torch.maximum(eye[:, 2], ground + 0.08)
    aside = torch.where(anywhere, uniform(azimuth, 0.1, 0.8) / torch.exp(fill).clamp(min=0.6), torch.full_like(fov, 0.15))
    rotation, translation = look_at(eye, target=torch.randn(n, 3, device=device) * aside[:, None])
    roll = torch.randn(n, device=device) * torch.where(uniform(azimuth, 0, 1) < 0.5, *ROLLS)
    rotation, translation = rolled(rotation, translation, roll)
    cameras = pack(rotation, translation, fov, size, subject_only=False)
    squeeze = torch.randn(n, device=device) * 0.12
    cameras[:, FOCAL] *= torch.stack([torch.exp(squeeze), torch.exp(-squeeze)], 1)
    return cameras, torch.asin(eye[:, 2] / eye.norm(dim=1)), -roll


def reframed(photo, alpha, depth, shade):
    """Photos as lenses bend them; and in some a margin of mirrored surroundings, as the program shows them; the subject ends
    with the photo."""
    n, size = alpha.shape[0], alpha.shape[-1]
    grid = bent(n, size, alpha.device)
    wider = torch.where(uniform(alpha, 0, 1) < 0.2, uniform(alpha, 1.05, 1.45), torch.ones_like(alpha[:, 0, 0]))
    grid = grid * wider[:, None, None, None]
    photo = F.grid_sample(photo, grid, mode="bilinear", padding_mode="reflection", align_corners=False)
    alpha = F.grid_sample(alpha[:, None], grid, mode="bilinear", padding_mode="zeros", align_corners=False)[:, 0]
    depth = F.grid_sample(depth[:, None], grid, mode="nearest", padding_mode="reflection", align_corners=False)[:, 0]
    shade = F.grid_sample(shade[:, None], grid, mode="bilinear", padding_mode="reflection", align_corners=False)[:, 0]
    return photo, alpha, depth, shade


def points(alpha, wanted):
    """A random point on every subject, drawn [n, 1, S, S]; nothing where none is wanted or there is no subject."""
    size = alpha.shape[-1]
    solid = (alpha > 0.6).float().flatten(1)
    given = wanted & (solid.sum(1) > 0)
    index = (torch.rand_like(solid) * solid).argmax(1)
    return point_map(index % size + 0.5, index // size + 0.5, size) * given[:, None, None, None]


def point_map(x, y, size):
    """A picture [n, 1, S, S] of points x, y [n] in pixels: 1 there, falling off within a twentieth of the picture."""
    centres = torch.arange(size, device=x.device) + 0.5
    away = torch.hypot(centres[None, None, :] - x[:, None, None], centres[None, :, None] - y[:, None, None])
    return torch.exp(-away * (20 / size))[:, None]


# ---------------------------------------------------------------- subjects from many sides


class SplatBatch(NamedTuple):
    """What SplatNet sees and what it should have answered.

    rgba [n, 4, 2 S, 2 S]: subject on grey and mask. views [n, V, 4, 4]: from the canonical camera's frame to each truth
    view; the first one is the canonical camera itself. lenses [n, V, 3]: focal length and middle of each view's picture,
    pixels. colour [n, V, 3, S, S] (sRGB, premultiplied), alpha
    [n, V, 1, S, S]. front [n, S, S]: canonical depth of what the crop shows, 0 where that is nothing. camera [n, 4] of
    the crop, as `nets.crop_rays` reads it. elevation [n] in radians, hint [n, 3] (`hints`, `lenses_told`). empty [n]: the crop shows nothing. The first `dressed`
    crops wear textures that the truth's views do not have: of their colours only the large patches can be compared.
    """

    rgba: torch.Tensor
    views: torch.Tensor
    lenses: torch.Tensor
    colour: torch.Tensor
    alpha: torch.Tensor
    front: torch.Tensor
    camera: torch.Tensor
    elevation: torch.Tensor
    hint: torch.Tensor
    empty: torch.Tensor
    dressed: int


def splat_batch(pool, n, fov, distance, size=256, views=4):
    """Crops of `size` pixels of subjects photographed anyhow, and `views` truth views, half as large, by cameras of `fov`
    radians at `distance`."""
    device = pool.prims.device
    chosen = subjects(pool, n, SLENDER_SHARE)
    prims = recolour(pool.prims[chosen])
    counts = pool.counts[chosen]
    azimuth = uniform(chosen, 0, 6.283)
    elevation = lowered(elevations(chosen), torch.isin(chosen, pool.airborne))
    photo_fov = uniform(chosen, 0.2, 1.0)
    away = 1.02 / torch.sin(photo_fov / 2)
    rotation, translation = look_at(orbit(azimuth, elevation, away))
    # The ground lies far below: nothing but the subject is in the picture, and nothing shades it from below.
    surroundings = environments(n, pool.grounds[chosen] - 1e3, device, uniform(chosen, 0, 1) < 0.4)
    each = torch.arange(n, device=device, dtype=torch.int32)

    probe = pack(rotation, translation, photo_fov * 1.1, 64, subject_only=True)
    fill = uniform(chosen, 0.82, 0.94)
    # Some masks take in a piece of the ground; the crop is wider then, and the subject not in its middle.
    leaky = uniform(chosen, 0, 1) < 0.3
    fill = torch.where(leaky, uniform(chosen, 0.62, 0.94), fill)
    _, coarse, _, _ = cast(prims, counts, each, probe, surroundings, 64, 1)
    cameras, empty = crop(probe, coarse, size, fill)
    aside = (torch.rand(n, 2, device=device) - 0.5) * (0.94 - fill).clamp(min=0)[:, None] * size
    cameras[:, [CENTRE_X, CENTRE_Y]] += aside * leaky[:, None]
    rgb, alpha, front, _ = cast(prims, counts, each, cameras, surroundings, size, 2)
    camera = crop_camera(cameras, away, size)
    front = torch.where(front > 0, front + (distance - away)[:, None, None], front)
    alpha = alpha[:, None]
    rough = F.interpolate(damaged(halved(alpha)), scale_factor=2.0, mode="bilinear")
    mask = torch.where(uniform(chosen, 0, 1)[:, None, None, None] < 0.5, rough, damaged(alpha))
    backdrop = torch.rand(n, 3, 1, 1, device=device) + 0.2 * (torch.rand(n, 3, size, size, device=device) - 0.5)
    # Its colours stay: the answer is to look like the photo.
    photo = composed(rgb, alpha, backdrop.clamp(0, 1))
    dressed = n // DRESSED
    photo[:dressed] = textured(photo[:dressed], alpha[:dressed, 0], front[:dressed], pool.textures)
    photo, mask = leaked(coarsened(photo), mask, alpha, leaky)
    photo = stored(photo)
    rgba = torch.cat([photo * mask + GREY * (1 - mask), mask], 1)

    canonical = look_at(orbit(azimuth, elevation, torch.full_like(azimuth, distance)))
    rotation, translation = truth_cameras(azimuth, elevation, distance, views)
    size //= 2
    truth_fov = torch.full((n * views,), fov, device=device)
    cameras = pack(rotation.reshape(-1, 3, 3), translation.reshape(-1, 3), truth_fov, size, subject_only=True)
    closer(cameras, size, views)
    rgb, truth_alpha, _, _ = cast(prims, counts, each.repeat_interleave(views), cameras, surroundings, size, 2)
    rgb = rgb.reshape(n, views, 3, size, size)
    truth_alpha = truth_alpha.reshape(n, views, 1, size, size)
    return SplatBatch(
        rgba=rgba,
        views=matrices(rotation, translation) @ inverses(*canonical)[:, None],
        lenses=cameras[:, [FOCAL.start, CENTRE_X, CENTRE_Y]].reshape(n, views, 3),
        colour=premultiplied(rgb, truth_alpha),
        alpha=truth_alpha,
        front=nearest(front),
        camera=camera,
        elevation=elevation,
        hint=torch.cat([hints(elevation), lenses_told(camera)], 1),
        empty=empty,
        dressed=dressed,
    )


def nearest(depth):
    """Depths [n, 2 S, 2 S] -> [n, S, S]: of 2 x 2 pixels the nearest, 0 where there is nothing."""
    far = 1e9
    least = -F.max_pool2d(-torch.where(depth > 0, depth, torch.full_like(depth, far)), 2)
    return torch.where(least < far, least, torch.zeros_like(least))


def crop_camera(cameras, away, size):
    """What `nets.crop_rays` reads [n, 4], of cameras [n, 20] that look at the origin from `away` [n]."""
    unit = away / cameras[:, FOCAL.start]
    half = size / 2
    size_at_centre = torch.log(half * unit / CROP_HALF)
    middle = [(half - cameras[:, c]) * unit for c in (CENTRE_X, CENTRE_Y)]
    return torch.stack([size_at_centre, *middle, torch.log(1 / away / CROP_NEARNESS)], 1)


def truth_cameras(azimuth, elevation, distance, views):
    """The photo's own side, one near it, the others anywhere but from below; rotation [n, V, 3, 3], translation [n, V, 3].

    Beside a photo from below the one near it is mostly from below, too."""
    around = [azimuth, azimuth + uniform(azimuth, -0.9, 0.9)]
    around += [uniform(azimuth, 0, 6.283) for _ in range(views - 2)]
    above = [elevation] + [
        torch.where(uniform(azimuth, 0, 1) < 0.9, uniform(azimuth, -0.25, 1.0), uniform(azimuth, 1.0, STEEPEST)) for _ in range(views - 1)
    ]
    above[1] = torch.where(elevation < BELOW, (elevation + uniform(azimuth, -0.5, 0.5)).clamp(min=-STEEPEST), above[1])
    around = torch.stack(around, 1)
    return look_at(orbit(around, torch.stack(above, 1), torch.full_like(around, distance)))


def closer(cameras, size, views):
    """Half of all views but the last of each subject show a part of it, twice as large: cameras [n * V, 20] change in place.

    A picture of `size` pixels shows nothing finer than its pixels: Gaussians between which a larger picture has gaps look
    whole in it.
    """
    chosen = uniform(cameras, 0, 1) < 0.5
    chosen[views - 1 :: views] = False
    twice = torch.where(chosen, 2.0, 1.0)
    cameras[:, FOCAL] *= twice[:, None]
    cameras[:, [CENTRE_X, CENTRE_Y]] += (torch.rand(len(cameras), 2, device=cameras.device) - 0.5) * 0.7 * size * (twice - 1)[:, None]


def composed(rgb, alpha, backdrop):
    """A view of the subject alone (premultiplied in linear light, gamma-encoded) over `backdrop` (sRGB), sRGB."""
    linear = rgb.clamp(min=0) ** 2.2 + (1 - alpha) * backdrop**2.2
    return linear.clamp(1e-6, 1) ** (1 / 2.2)


def premultiplied(rgb, alpha):
    """The same view premultiplied in sRGB, as splatting blends it."""
    linear = (rgb**2.2 / alpha.clamp(min=1e-3)).clamp(0, 1)
    return torch.where(alpha > 1e-3, linear ** (1 / 2.2), torch.zeros_like(rgb)) * alpha
