"""Cameras: OpenCV axes, world -> camera, pixel centres at +0.5; one row a camera as `layout` describes it."""

from functools import cache

import torch

from .layout import CENTRE_X, CENTRE_Y, FOCAL


@cache
def fixed(values, device):
    """A constant tensor of (nested) tuples. Made once: every copy to a GPU makes the host wait for it."""
    return torch.tensor(values, device=device)


def look_at(eye, target=None):
    """World -> camera rotation [..., 3, 3] and translation [..., 3] of upright cameras at eye [..., 3].

    They look at target [..., 3], or at the origin.
    """
    forward = (0 if target is None else target) - eye
    forward = forward / forward.norm(dim=-1, keepdim=True)
    up = torch.zeros_like(eye)
    up[..., 2] = 1
    right = torch.linalg.cross(forward, up)
    right = right / right.norm(dim=-1, keepdim=True)
    down = torch.linalg.cross(forward, right)
    rotation = torch.stack([right, down, forward], -2)
    return rotation, -(rotation @ eye[..., None])[..., 0]


def orbit(azimuth, elevation, distance):
    """Points [..., 3] on a sphere about the origin; angles in radians, azimuth from +x towards +y."""
    x = distance * torch.cos(elevation) * torch.cos(azimuth)
    y = distance * torch.cos(elevation) * torch.sin(azimuth)
    z = distance * torch.sin(elevation)
    return torch.stack([x, y, z], -1)


def rolled(rotation, translation, angle):
    """The cameras turned about their own viewing direction by angle [n] radians."""
    roll = torch.zeros_like(rotation)
    roll[:, 0, 0] = roll[:, 1, 1] = angle.cos()
    roll[:, 0, 1] = -angle.sin()
    roll[:, 1, 0] = angle.sin()
    roll[:, 2, 2] = 1
    return roll @ rotation, (roll @ translation[..., None])[..., 0]


def matrices(rotation, translation):
    """World -> camera matrices [..., 4, 4]."""
    out = torch.zeros(*translation.shape[:-1], 4, 4, device=translation.device)
    out[..., :3, :3] = rotation
    out[..., :3, 3] = translation
    out[..., 3, 3] = 1
    return out


def inverses(rotation, translation):
    """Camera -> world matrices [..., 4, 4]."""
    back = rotation.transpose(-1, -2)
    return matrices(back, -(back @ translation[..., None])[..., 0])


def pack(rotation, translation, fov, size, subject_only):
    """Camera rows [n, 20] for square pictures: rotation [n, 3, 3], translation [n, 3], fov [n] radians."""
    n = len(translation)
    device = translation.device
    focal = (size / 2 / torch.tan(fov / 2))[:, None]
    centre = torch.full((n, 1), size / 2.0, device=device)
    only = torch.full((n, 1), float(subject_only), device=device)
    unused = torch.zeros(n, 3, device=device)
    return torch.cat([rotation.reshape(n, 9), translation, focal, focal, centre, centre, only, unused], 1)


def crop(cameras, alpha, size, fill):
    """Cameras that see only the square around the subject, and which of them see nothing.

    cameras [n, 20] rendered the subject's coverage alpha [n, S, S]; the new ones render `size` pixels, with the
    longer side of the subject's bounding box filling the fraction fill [n]. Returns cameras [n, 20], empty [n] bool;
    an empty one keeps the whole picture.
    """
    probe = alpha.shape[-1]
    x0, x1 = extent(alpha.amax(1) > 0.1)
    y0, y1 = extent(alpha.amax(2) > 0.1)
    empty = x1 <= x0
    side = torch.maximum(x1 - x0, y1 - y0) / fill
    side = torch.where(empty, torch.full_like(side, float(probe)), side)
    centre_x = torch.where(empty, torch.full_like(x0, probe / 2), (x0 + x1) / 2)
    centre_y = torch.where(empty, torch.full_like(y0, probe / 2), (y0 + y1) / 2)
    zoom = size / side
    out = cameras.clone()
    out[:, FOCAL] *= zoom[:, None]
    out[:, CENTRE_X] = (probe / 2 - centre_x) * zoom + size / 2
    out[:, CENTRE_Y] = (probe / 2 - centre_y) * zoom + size / 2
    return out, empty


def magnified(cameras, box, seen, size):
    """Cameras [n, 20] that show of a picture of `seen` pixels the box [n, 4] (left, top, right, bottom) alone, `size` pixels."""
    out = cameras.clone()
    zoom = size / (box[:, 2:] - box[:, :2])
    out[:, FOCAL] *= zoom
    out[:, CENTRE_X] = (cameras[:, CENTRE_X] - box[:, 0]) * zoom[:, 0]
    out[:, CENTRE_Y] = (cameras[:, CENTRE_Y] - box[:, 1]) * zoom[:, 1]
    return out


def extent(occupied):
    """First and last edge, in pixels, of the occupied [n, S] cells; where none is the first lies after the last."""
    cells = occupied.shape[1]
    centres = torch.arange(cells, device=occupied.device) + 0.5
    low = torch.where(occupied, centres, torch.full_like(centres, cells)).amin(1) - 0.5
    high = torch.where(occupied, centres, torch.full_like(centres, -cells)).amax(1) + 0.5
    return low, high
