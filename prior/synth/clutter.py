"""What stands around the subject of a photo, touches it or looks like it; none of it is the subject's."""

import math

import torch
import torch.nn.functional as F

from .cameras import fixed
from .draws import recolour, uniform
from .layout import (
    BALL,
    BOX,
    CENTRE,
    COLOURS,
    CUTOUT,
    CUT_FREQUENCY,
    CYL,
    FLOATS,
    GROUND_A,
    GROUND_B,
    HALF_SIZE,
    HILL_COLOUR,
    KIND,
    PRIMS,
    ROTATION,
    SHIFT,
    SUBJECT,
    TAPER,
)

# Boughs that may touch the subject of a photo, and in how many photos they do.
BOUGHS = 4
BOUGHED = 0.12
# In so many photos what is around the subject has colours of the subject's.
DISGUISED = 0.25


def add_distractor(prims, counts, pool, ground, azimuth, overgrown, before, behind):
    """In just under half of the scenes, one more object behind or beside the subject; prims and counts grow in place.

    prims [n, P, 36], counts [n] int64, ground [n], azimuth [n] of the camera in radians. `before`: in some scenes
    a low one in front instead. Where `overgrown` [n] is set, trees and bushes close around and in front. Where `behind` [n] is
    set, the object stands close behind the subject, about as large.
    """
    n, capacity, _ = prims.shape
    device = prims.device
    chosen = torch.randint(len(pool.prims), (n,), device=device)
    companions = pool.companions[torch.randint(len(pool.companions), (n,), device=device)]
    front = (uniform(ground, 0, 1) < 0.3) & before
    chosen = torch.where((uniform(ground, 0, 1) < 0.5) | front, companions, chosen)
    foliage = pool.foliage[torch.randint(len(pool.foliage), (n,), device=device)]
    chosen = torch.where(overgrown, foliage, chosen)
    rows = recolour(pool.prims[chosen])
    scale = torch.where(front, torch.exp(uniform(ground, -1.8, -0.6)), torch.exp(uniform(ground, -1.1, 1.1)))
    near = uniform(ground, 0, 1) < 0.3
    distance = torch.where(near, uniform(ground, 0.9, 1.6), uniform(ground, 1.5, 6))
    distance = torch.where(front, uniform(ground, 1.0, 1.7), distance * (0.6 + 0.5 * scale) + 0.3 * scale)
    bearing = azimuth + math.pi + uniform(ground, -1, 1) * torch.where(near, 2.4, 1.4)
    bearing = torch.where(front, azimuth + uniform(ground, -0.7, 0.7), bearing)
    scale = torch.where(overgrown, torch.exp(uniform(ground, -1.5, 0.1)), scale)
    distance = torch.where(overgrown, uniform(ground, 0.8, 1.5) + 0.3 * scale, distance)
    bearing = torch.where(overgrown, azimuth + uniform(ground, -1.7, 1.7), bearing)
    scale = torch.where(behind, torch.exp(uniform(ground, -0.5, 0.5)), scale)
    distance = torch.where(behind, uniform(ground, 0.7, 1.8) + 0.5 * scale, distance)
    bearing = torch.where(behind, azimuth + math.pi + uniform(ground, -0.5, 0.5), bearing)
    present = (uniform(ground, 0, 1) < torch.where(overgrown, 0.8, 0.45)) | behind
    up = ground - pool.grounds[chosen] * scale
    offset = torch.stack([distance * bearing.cos(), distance * bearing.sin(), up], 1)
    rows[..., CENTRE] = rows[..., CENTRE] * scale[:, None, None] + offset[:, None]
    rows[..., HALF_SIZE] *= scale[:, None, None]
    rows[..., SHIFT] *= scale[:, None, None]
    # Bars around a round wall are counted by the turn, all others by length.
    by_length = rows[..., KIND] < 1.5
    rows[..., CUT_FREQUENCY] /= torch.where(by_length, scale[:, None], torch.ones_like(scale[:, None]))
    rows[..., SUBJECT] = 0

    added = torch.where(present, pool.counts[chosen].long(), torch.zeros_like(counts))
    slot = torch.arange(PRIMS, device=device)[None]
    target = counts[:, None] + slot
    # Rows that are not used land on the last slot, which no scene reaches.
    target = torch.where(slot < added[:, None], target, torch.full_like(target, capacity - 1))
    prims.scatter_(1, target[..., None].expand(-1, -1, FLOATS), rows)
    counts += added


def add_perch(prims, counts, ground):
    """In a few scenes the subject stands on a mound, a slab or a log that is not its own; the ground lies lower there.

    prims [n, P, 36] and counts [n] grow in place; returns the ground's heights [n].
    """
    n, capacity, _ = prims.shape
    device = prims.device
    present = uniform(ground, 0, 1) < 0.1
    kind = fixed((BALL, BOX, CYL), device)[torch.randint(3, (n,), device=device)]
    high = torch.exp(uniform(ground, -3, -0.5))
    row = prims[:, 0].clone()
    row[:, KIND] = kind.float()
    row[:, SUBJECT] = 0
    row[:, CUTOUT] = 0
    row[:, TAPER] = 1
    row[:, SHIFT] = 0
    turn = uniform(ground, 0, 6.283)
    c, s, zero = turn.cos(), turn.sin(), torch.zeros_like(turn)
    upright = torch.stack([c, s, zero, -s, c, zero, zero, zero, zero + 1], 1)
    # A log lies level: its own z is the first level axis.
    lying = torch.stack([-s, c, zero, zero, zero, zero + 1, c, s, zero], 1)
    log = (kind == CYL)[:, None]
    row[:, ROTATION] = torch.where(log, lying, upright)
    reach = torch.exp(torch.rand(n, 2, device=device) * 1.4 - 0.7)
    flat = torch.cat([reach, high[:, None]], 1)
    along = torch.stack([high * 0.4, high * 0.4, reach[:, 0] * 1.5], 1)
    row[:, HALF_SIZE] = torch.where(log, along, flat)
    below = torch.where(log[:, 0], high * 0.4, high) * uniform(ground, 0.8, 1)
    aside = 0.3 * torch.randn(n, 2, device=device)
    row[:, CENTRE] = torch.cat([aside, (ground - below)[:, None]], 1)
    row[:, 20:26] = torch.rand(n, 6, device=device) ** 1.5
    at = torch.where(present, counts, torch.full_like(counts, capacity - 1))
    prims[torch.arange(n, device=device), at] = row
    counts += present
    return torch.where(present, ground - below, ground)


def add_boughs(prims, counts, azimuth):
    """In a few scenes boughs, posts or trunks that are not the subject's touch it, lie behind it or cross before it.

    prims [n, P, 36], counts [n] and the camera's azimuth [n], radians; prims and counts grow in place.
    """
    n, capacity, _ = prims.shape
    device = prims.device
    present = uniform(azimuth, 0, 1) < BOUGHED
    bark = torch.rand(n, 6, device=device) ** 1.5
    to_camera = torch.stack([azimuth.cos(), azimuth.sin(), torch.zeros_like(azimuth)], 1)
    up = fixed((0.0, 0.0, 1.0), device).expand(n, 3)
    for _ in range(BOUGHS):
        along = torch.randn(n, 3, device=device)
        # Half of them lie about level.
        along[:, 2] *= torch.where(uniform(azimuth, 0, 1) < 0.5, 0.25, 1.5)
        along = F.normalize(along, dim=1)
        across = F.normalize(torch.linalg.cross(up, along) + 1e-4, dim=1)
        row = prims[:, 0].clone()
        row[:, KIND] = CYL
        row[:, SUBJECT] = 0
        row[:, CUTOUT] = 0
        row[:, TAPER] = uniform(azimuth, 0.4, 1)[:, None]
        row[:, SHIFT] = 0
        row[:, ROTATION] = torch.cat([across, torch.linalg.cross(along, across), along], 1)
        thick = torch.exp(uniform(azimuth, -3.7, -1.6))
        row[:, HALF_SIZE] = torch.stack([thick, thick, uniform(azimuth, 0.4, 1.8)], 1)
        near = to_camera * uniform(azimuth, -0.5, 0.4)[:, None]
        row[:, CENTRE] = 0.25 * torch.randn(n, 3, device=device) + near + along * uniform(azimuth, -0.8, 0.8)[:, None]
        row[:, 20:26] = bark
        one = present & (uniform(azimuth, 0, 1) < 0.6)
        at = torch.where(one, counts, torch.full_like(counts, capacity - 1))
        prims[torch.arange(n, device=device), at] = row
        counts += one


def disguise(prims, surroundings, subject, counts):
    """In some scenes gives what is around the subject colours of the subject's, so that edges and shape must tell them apart.

    prims [n, P, 36] and surroundings [n, 40] change in place; subject [n, PRIMS, 36], of whose rows counts [n] are used.
    """
    n, capacity, _ = prims.shape
    device = prims.device
    disguised = torch.rand(n, 1, device=device) < DISGUISED

    def colours(many):
        which = (torch.rand(n, many, device=device) * counts[:, None]).long()
        own = torch.gather(subject[..., COLOURS[0]], 1, which[..., None].expand(-1, -1, 3))
        return (own * torch.exp(0.2 * torch.randn(n, many, 1, device=device))).clamp(0.005, 0.98)

    painted = disguised & (prims[..., SUBJECT] == 0) & (torch.rand(n, capacity, device=device) < 0.6)
    for columns in COLOURS:
        prims[..., columns] = torch.where(painted[..., None], colours(capacity), prims[..., columns])
    lying = disguised & (torch.rand(n, 1, device=device) < 0.7)
    for columns, colour in zip((GROUND_A, GROUND_B, HILL_COLOUR), colours(3).unbind(1), strict=True):
        surroundings[:, columns] = torch.where(lying, colour, surroundings[:, columns])
