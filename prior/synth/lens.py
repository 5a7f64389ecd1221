"""What cameras and files do to a picture: exposure, colour, blur, noise, vignetting, block compression."""

import math

import torch
import torch.nn.functional as F

from .cameras import fixed

TO_YCC = ((0.299, 0.587, 0.114), (-0.169, -0.331, 0.5), (0.5, -0.419, -0.081))
FROM_YCC = tuple(map(tuple, torch.linalg.inv(torch.tensor(TO_YCC)).tolist()))
KERNEL = 9  # pixels, of the blurs


def exposed(photo):
    """A photo [n, 3, H, W] in sRGB 0..1 with other exposure, contrast, colours, haze; every picture its own way."""
    n = len(photo)
    device = photo.device

    def normal(channels, sigma):
        return torch.randn(n, channels, 1, 1, device=device) * sigma

    def chance(probability):
        return torch.rand(n, 1, 1, 1, device=device) < probability

    photo = photo.clamp(1e-4, 1) ** torch.exp(normal(1, 0.17))
    photo = photo * torch.exp(normal(1, 0.16) + normal(3, 0.04))
    grey = photo.mean(1, keepdim=True)
    photo = grey + (photo - grey) * torch.exp(0.05 + normal(1, 0.25))
    # The steep middle of a camera's tone curve.
    photo = photo.clamp(0, 1)
    steep = chance(0.5) * torch.rand(n, 1, 1, 1, device=device)
    photo = photo + steep * (photo * photo * (3 - 2 * photo) - photo)
    photo = torch.where(chance(0.02), grey.expand_as(photo), photo)
    photo = photo + torch.where(chance(0.15), torch.rand(n, 1, 1, 1, device=device) * 0.15, 0.0) * (1 - photo)
    return torch.where(chance(0.3), photo * vignette(n, photo.shape[-1], device), photo)


def bent(n, size, device):
    """Where n pictures of `size` pixels are to be sampled, [n, S, S, 2], -1..1: a third of them as lenses distort, the others as
    they are.

    Radial distortion of the first order (Brown 1966), r' = r (1 + k (r^2 - 1)) with r = 1 at the middle of a side, so that the
    picture stays as wide: k > 0 a barrel as phones and wide lenses have it, k < 0 a cushion.
    """
    centres = (torch.arange(size, device=device) + 0.5) * (2 / size) - 1
    grid = torch.stack([centres[None].expand(size, size), centres[:, None].expand(size, size)], -1)
    k = torch.randn(n, 1, 1, 1, device=device) * 0.05 * (torch.rand(n, 1, 1, 1, device=device) < 1 / 3)
    return grid * (1 + k.clamp(-0.12, 0.12) * ((grid**2).sum(-1, keepdim=True) - 1))


def defocused(photo, alpha, depth):
    """In a quarter of the photos [n, 3, S, S], what lies before and behind the subject out of focus.

    alpha [n, S, S]: coverage by the subject; depth [n, S, S], 0 = infinitely far.
    """
    n = len(photo)
    device = photo.device
    away = 1 / depth.clamp(min=0.1) * (depth > 0)
    inside = (alpha > 0.5).float()
    focus = (away * inside).sum((1, 2), keepdim=True) / inside.sum((1, 2), keepdim=True).clamp(min=1)
    off = ((away - focus).abs() / focus.clamp(min=0.05) * 2).clamp(0, 1)[:, None]
    used = torch.where(torch.rand(n, 1, 1, 1, device=device) < 0.25, torch.rand(n, 1, 1, 1, device=device) + 0.4, 0.0)
    around = 1 - alpha[:, None]
    size = photo.shape[-1]
    soft = photo
    for reach in (size // 64, size // 32):
        # The subject's own colours do not bleed into what is around it.
        sheet = torch.cat([soft * around, around], 1)
        sheet = F.avg_pool2d(F.pad(sheet, (reach,) * 4, mode="replicate"), 2 * reach + 1, 1)
        soft = torch.where(sheet[:, 3:] > 0.02, sheet[:, :3] / sheet[:, 3:].clamp(min=0.02), soft)
    share = (used * off).clamp(0, 1) * around
    return photo + share * (soft - photo)


def stored(photo):
    """A photo [n, 3, H, W] blurred, sharpened, noisy and compressed; every picture its own way."""
    n = len(photo)
    device = photo.device
    soft = blurred(photo)
    choice = torch.rand(n, 1, 1, 1, device=device)
    near = F.avg_pool2d(F.pad(photo, (1, 1, 1, 1), mode="replicate"), 3, 1)
    sharp = photo + torch.rand(n, 1, 1, 1, device=device) * (photo - near)
    photo = torch.where(choice < 0.3, soft, torch.where(choice < 0.45, near, torch.where(choice > 0.75, sharp, photo)))
    noise = torch.randn_like(photo)
    photo = (photo + noise * (0.05 * torch.rand(n, 1, 1, 1, device=device) ** 2)).clamp(0, 1)
    return torch.where(torch.rand(n, 1, 1, 1, device=device) < 0.3, compressed(photo), photo).clamp(0, 1)


def coarsened(photo):
    """Some photos [n, 3, S, S] with half or a third of their pixels: a small or distant subject."""
    chance = torch.rand(len(photo), 1, 1, 1, device=photo.device)
    for share, by in ((0.4, 2), (0.15, 3)):
        few = F.interpolate(photo, size=photo.shape[-1] // by, mode="area")
        few = F.interpolate(few, size=photo.shape[-1], mode="bilinear")
        photo = torch.where(chance < share, few, photo)
    return photo


def vignette(n, size, device):
    """Fall-off of light towards the corners, [n, 1, S, S]."""
    across = torch.linspace(-1, 1, size, device=device)
    radius2 = (across[None, :] ** 2 + across[:, None] ** 2)[None, None]
    return 1 - 0.3 * torch.rand(n, 1, 1, 1, device=device) * radius2


def blurred(photo):
    """Defocus (round) or motion (straight), each picture with a kernel of its own."""
    n, channels, height, width = photo.shape
    device = photo.device
    reach = torch.arange(KERNEL, device=device) - KERNEL // 2
    across, down = reach[None, None, :].float(), reach[None, :, None].float()
    angle = torch.rand(n, 1, 1, device=device) * math.pi
    along = across * angle.cos() + down * angle.sin()
    aside = down * angle.cos() - across * angle.sin()
    wide = 0.5 + 1.1 * torch.rand(n, 1, 1, device=device) ** 2
    long = torch.where(torch.rand(n, 1, 1, device=device) < 0.4, wide * 3, wide)
    kernel = torch.exp(-0.5 * ((along / long) ** 2 + (aside / wide) ** 2))
    kernel = (kernel / kernel.sum((1, 2), keepdim=True)).repeat_interleave(channels, 0)[:, None]
    padded = F.pad(photo, (KERNEL // 2,) * 4, mode="replicate").reshape(1, n * channels, height + KERNEL - 1, -1)
    return F.conv2d(padded, kernel, groups=n * channels).reshape(photo.shape)


def compressed(photo):
    """Cosine coefficients of 8 x 8 blocks rounded more coarsely the finer they are, chroma more than luma."""
    n, _, height, width = photo.shape
    device = photo.device
    k = torch.arange(8, device=device).float()
    basis = torch.cos((2 * k[None] + 1) * k[:, None] * math.pi / 16) * 0.5
    basis = torch.cat([basis[:1] * math.sqrt(0.5), basis[1:]])
    to_ycc = fixed(TO_YCC, device)
    planes = torch.einsum("ij,njhw->nihw", to_ycc, photo)
    blocks = planes.reshape(n, 3, height // 8, 8, width // 8, 8)
    waves = torch.einsum("ki,ncaibj,lj->ncakbl", basis, blocks, basis)
    step = (1 + k[:, None] + k[None, :]) * torch.exp(torch.rand(n, 1, 1, 1, device=device) * 2.2 - 4.9)
    step = step[:, :, :, None, :].expand(n, 1, 8, 1, 8)[:, :, None]
    step = step * fixed((1.0, 2.0, 2.0), device).reshape(1, 3, 1, 1, 1, 1)
    rounded = torch.round(waves / step) * step
    blocks = torch.einsum("ki,ncakbl,lj->ncaibj", basis, rounded, basis)
    return torch.einsum("ij,njhw->nihw", fixed(FROM_YCC, device), blocks.reshape(n, 3, height, width)).clamp(0, 1)
