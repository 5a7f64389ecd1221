"""The built-in networks.

`SceneNet` reads a photo and says where its subject is and how deep the scene is.
`DetailNet` looks again, closely, at the part of the photo with the subject, and draws its mask finely.
`SplatNet` reads the cropped subject and answers with two Gaussians a pixel.

All are the same small U-Net with a transformer at its coarsest grid. The attribute names of the modules are the
parameter names of every checkpoint and of the ONNX files: renaming one breaks them all, so they stay short.
"""

import math
import re
from typing import NamedTuple

import torch
import torch.nn.functional as F
from torch import nn


class Res(nn.Module):
    """Residual block of two 3x3 convolutions, [B, cin, H, W] -> [B, cout, H, W].

    a, b: convolutions; n, m: their batch norms; k: the skip path (1x1 convolution where the width changes).
    """

    def __init__(self, cin, cout):
        super().__init__()
        self.a = nn.Conv2d(cin, cout, 3, padding=1, bias=False)
        self.b = nn.Conv2d(cout, cout, 3, padding=1, bias=False)
        self.n = nn.BatchNorm2d(cout)
        self.m = nn.BatchNorm2d(cout)
        self.k = nn.Identity() if cin == cout else nn.Conv2d(cin, cout, 1)
        # A small last gain starts every block near the identity.
        nn.init.constant_(self.m.weight, 0.2)

    def forward(self, x):
        inner = F.silu(self.n(self.a(x)))
        return F.silu(self.k(x) + self.m(self.b(inner)))


class Block(nn.Module):
    """Pre-norm transformer block on tokens [B, N, dim].

    n1, n2: layer norms; qkv, o: attention projections; h: heads; f: the feed-forward part.
    """

    def __init__(self, dim, heads):
        super().__init__()
        self.h = heads
        self.n1 = nn.LayerNorm(dim)
        self.n2 = nn.LayerNorm(dim)
        self.qkv = nn.Linear(dim, 3 * dim)
        self.o = nn.Linear(dim, dim)
        self.f = nn.Sequential(nn.Linear(dim, 4 * dim), nn.GELU(), nn.Linear(4 * dim, dim))

    def forward(self, x):
        batch, tokens, dim = x.shape
        qkv = self.qkv(self.n1(x)).reshape(batch, tokens, 3, self.h, dim // self.h)
        query, key, value = qkv.permute(2, 0, 3, 1, 4).unbind(0)
        mixed = F.scaled_dot_product_attention(query, key, value)
        x = x + self.o(mixed.transpose(1, 2).reshape(batch, tokens, dim))
        return x + self.f(self.n2(x))


class Read(NamedTuple):
    """What a U-Net made of pictures [B, cin, S, S]: answer [B, cout, S, S]; token [B, widths[-1]], the mean of tokens; features
    [B, widths[0], S, S], of which the answer was made; tokens [B, widths[-1], grid, grid], and of the grid four times as fine what
    the way down and the way up made, between [B, widths[-3], 4 grid, 4 grid] each."""

    answer: torch.Tensor
    token: torch.Tensor
    features: torch.Tensor
    tokens: torch.Tensor
    between: tuple


class UNet(nn.Module):
    """Convolutions down to a `grid` x `grid` map, `depth` transformer blocks there, convolutions up again.

    Input [B, cin, S, S] with S = grid * 2^(len(widths) - 1). `blocks` is the number of residual blocks a level, `near` that of
    transformer blocks on the next finer grid, on the way up.
    """

    def __init__(self, cin, widths, cout, grid, depth, heads, blocks=2, near=0):
        super().__init__()
        self.stem = nn.Conv2d(cin, widths[0], 3, padding=1)
        self.down = nn.ModuleList()
        self.up = nn.ModuleList()
        last = widths[0]
        for width in widths:
            self.down.append(level(last, width, blocks))
            last = width
        self.pos = nn.Parameter(torch.randn(1, grid * grid, last) * 0.02)
        self.mid = nn.ModuleList(Block(last, heads) for _ in range(depth))
        self.norm = nn.LayerNorm(last)
        for width in reversed(widths):
            self.up.append(level(last + width, width, blocks))
            last = width
        self.head = nn.Conv2d(last, cout, 1)
        self.near = nn.ModuleList(Block(widths[-2], widths[-2] // 32) for _ in range(near))
        if near:
            self.pos_near = nn.Parameter(torch.zeros(1, 4 * grid * grid, widths[-2]))

    def forward(self, x, beside=0, told=0):
        """`beside` [B, widths[0], S, S]: what is known at each pixel from elsewhere, added to the stem's features; `told`
        [B, 1, widths[-1]]: of the whole picture, added to the tokens."""
        skips = way_down(self.down, self.stem(x) + beside)
        x = skips[-1]
        tokens = self.norm(attended(x, self.pos + told, self.mid))
        x = coarse = as_map(tokens, x.shape)
        between = ()
        for i, up in enumerate(self.up):
            if i > 0:
                x = F.interpolate(x, scale_factor=2.0, mode="nearest")
            x = up(torch.cat([x, skips[-1 - i]], 1))
            if i == 1 and len(self.near):
                x = as_map(attended(x, self.pos_near, self.near), x.shape)
            if i == 2:
                between = (skips[-3], x)
        return Read(self.head(x), tokens.mean(1), x, coarse, between)


def way_down(levels, x):
    """What every level makes of the stem's features [B, C, S, S], each half as fine as the one before."""
    made = []
    for blocks in levels:
        x = blocks(F.avg_pool2d(x, 2) if made else x)
        made.append(x)
    return made


def attended(x, positions, blocks):
    """A map [B, C, H, W] as tokens [B, H W, C] with positions [1, H W, C], after the transformer blocks."""
    tokens = x.flatten(2).transpose(1, 2) + positions
    for block in blocks:
        tokens = block(tokens)
    return tokens


def as_map(tokens, shape):
    """Tokens [B, H W, C] as a map of `shape` [B, C, H, W] again."""
    return tokens.transpose(1, 2).reshape(shape)


def halved(x):
    """[B, C, 2 S, 2 S] -> [B, C, S, S]: the means of 2 x 2 pixels."""
    return F.avg_pool2d(x, 2)


def fine_stem(cin, width):
    """Pixels finer than the U-Net's, [B, cin, 2 S, 2 S], to features of its pixels [B, width, S, S]; they start at 0."""
    layers = nn.Sequential(
        nn.Conv2d(cin, 16, 3, padding=1),
        nn.SiLU(),
        nn.Conv2d(16, 64, 4, stride=2, padding=1),
        nn.SiLU(),
        nn.Conv2d(64, width, 3, padding=1),
    )
    nn.init.zeros_(layers[-1].weight)
    nn.init.zeros_(layers[-1].bias)
    return layers


def level(cin, width, blocks):
    """The residual blocks of one resolution; the first one changes the width."""
    return nn.Sequential(*[Res(cin if i == 0 else width, width) for i in range(blocks)])


def head(width, numbers):
    """From the mean token to a few numbers about the whole picture; they start at 0."""
    layers = nn.Sequential(nn.Linear(width, 128), nn.SiLU(), nn.Linear(128, numbers))
    nn.init.zeros_(layers[2].weight)
    nn.init.zeros_(layers[2].bias)
    return layers


def hint_head(width):
    """From what is known beforehand (`SplatNet.forward`), as five numbers, to what is added to every token; 0 at first."""
    layers = nn.Sequential(nn.Linear(5, 64), nn.SiLU(), nn.Linear(64, width))
    nn.init.zeros_(layers[2].weight)
    nn.init.zeros_(layers[2].bias)
    return layers


def guess(y):
    """[B, 2] -> an angle and the scale of its Laplace distribution (the error's mean), radians."""
    return torch.stack([y[:, 0], torch.exp(y[:, 1].clamp(-4, 2) - 2)], 1)


class SceneNet(nn.Module):
    """Photo and point [B, 4, 256, 256] -> mask logits and inverse depth, [B, 1, 256, 256] each, elevation [B, 2] and how the camera was
    held [B, 4].

    Photo: sRGB 0..1. Point: 1 where the user says that the subject is, falling off around it as
    `synth.batches.point_map` draws it; all 0 where nobody says, then the subject is what stands in the middle.
    Inverse depth is right up to a scale and an offset of its own for every picture.
    Elevation: a `guess`, of the camera above the subject's centre, told by all that is around it. How it was held (`Held`): another
    guess of the same, and one of the camera's roll about its axis, by which the lower ends of plumb lines that the axis meets lean to the
    right in the photo.
    """

    SIZE = 256

    def __init__(self):
        super().__init__()
        self.net = UNet(4, (24, 48, 96, 192, 224), cout=2, grid=16, depth=9, heads=7)
        self.el = head(224, 2)
        self.held = Held(96, 224)

    def forward(self, x):
        read = self.net(torch.cat([x[:, :3] * 2 - 1, x[:, 3:]], 1))
        return read.answer[:, :1], read.answer[:, 1:], guess(self.el(read.token.float())), self.held(read)


class DetailNet(nn.Module):
    """The photo around its subject and a rough mask [B, 4, 384, 384] -> mask logits and inverse depth, [B, 1, 384, 384] each.

    Photo: sRGB 0..1, with a little of the surroundings. Rough mask: 0..1, `SceneNet`'s. Inverse depth as SceneNet has it.
    """

    SIZE = 384

    def __init__(self):
        super().__init__()
        self.net = UNet(4, (24, 48, 96, 192, 224), cout=2, grid=24, depth=9, heads=7)

    def forward(self, x):
        y = self.net(x * 2 - 1).answer
        return y[:, :1], y[:, 1:]


class Held(nn.Module):
    """From what a U-Net read to how the camera was held, [B, 4]: a `guess` of its elevation and one of its roll.

    Where edges run is seen finely, so it begins with what lies `between`, [B, width, 4 grid, 4 grid] twice; what they are edges of
    the tokens say, [B, deep, grid, grid].
    """

    WIDTH = 192

    def __init__(self, width, deep, grid=16):
        super().__init__()
        self.a = nn.Conv2d(2 * width, width, 4, stride=2, padding=1)
        self.r = Res(width, width)
        self.b = nn.Conv2d(width, self.WIDTH, 4, stride=2, padding=1)
        self.c = nn.Conv2d(deep, self.WIDTH, 1)
        self.pos = nn.Parameter(torch.zeros(1, grid * grid, self.WIDTH))
        self.mid = nn.ModuleList(Block(self.WIDTH, 6) for _ in range(2))
        self.norm = nn.LayerNorm(self.WIDTH)
        self.head = head(self.WIDTH, 4)

    def forward(self, read):
        x = self.r(F.silu(self.a(torch.cat(read.between, 1))))
        x = F.silu(self.b(x) + self.c(read.tokens))
        y = self.head(self.norm(attended(x, self.pos, self.mid)).mean(1).float()).float()
        return torch.cat([guess(y[:, :2]), guess(y[:, 2:])], 1)


class ErrorHead(nn.Module):
    """From a U-Net's last features [B, features, S, S] and mean token [B, width] to `layers` numbers a pixel, 0..1."""

    def __init__(self, features, width, layers):
        super().__init__()
        self.a = nn.Conv2d(features, features, 3, padding=1)
        self.t = nn.Linear(width, features)
        self.b = nn.Conv2d(features, features, 3, padding=1)
        self.c = nn.Conv2d(features, layers, 1)

    def forward(self, x, mean_token):
        y = F.silu(self.a(x) + self.t(mean_token)[:, :, None, None])
        return torch.sigmoid(self.c(F.silu(self.b(y))) - 2)


class SplatNet(nn.Module):
    """Subject on grey 0.5 and its mask, [B, 4, 256, 256] -> Gaussians in the canonical camera and its elevation.

    The Gaussians lie on a grid of 128 x 128, half as fine as the picture; below, a pixel is one of this grid.

    The canonical camera has OpenCV axes (x right, y down, z forward) and a field of view of `FOV` radians; the
    subject's bounding sphere has radius 1 and lies at (0, 0, `DIST`). The photo's camera looks the same way from
    another distance, and the crop shows a part of what it sees: both are in the camera [B, 4] of the answer
    (`crop_rays`), so that every pixel's ray is where the subject's surface lies in the canonical frame.

    With n = layers * 128 * 128 the answer holds pos [B, n, 3], scale [B, n, 3] (same unit), quat [B, n, 4] (w first),
    opacity [B, n], rgb [B, n, 3] (0..1), depth [B, 128, 128] (canonical z) of the front layer, camera [B, 4],
    elevation [B, 2] (`guess`) and error [B, n]: the colour error to be expected where a view from anywhere shows the
    Gaussian, 0..1 (`losses.error_step`).
    """

    SIZE = 256
    GRID = 128
    FOV = math.radians(30)
    DIST = 3.9
    # Channels a Gaussian: depth 1, offset 3, opacity 1, scale 3, quaternion 4, colour 3.
    CHANNELS = 15

    def __init__(self, layers=2):
        super().__init__()
        self.layers = layers
        self.net = UNet(4, (48, 96, 160, 256), cout=layers * self.CHANNELS, grid=16, depth=48, heads=8, near=12)
        self.hint = hint_head(256)
        self.el = head(256, 2)
        self.camera = head(256, 4)
        self.er = ErrorHead(48, 256, layers)
        self.fine = fine_stem(4, 48)
        with torch.no_grad():
            self.net.head.weight *= 0.3
            self.net.head.bias.zero_()

    def forward(self, x, hint=None):
        """`hint` [B, 3]: what whoever saw more than the crop says of the elevation, and the error to be expected of it, both in
        radians: SceneNet, or a gimbal that measured it; and the tangent of half the angle that the crop spans, where the photo's
        focal length is known. An error or a tangent of 0, or no hint: nobody says."""
        hint = x.new_zeros(len(x), 3) if hint is None else hint
        said, known = (hint[:, 1:2] > 0).float(), (hint[:, 2:] > 0).float()
        spans = torch.log(hint[:, 2:].clamp(min=0.01) / CROP_TANGENT) * known
        hint = torch.cat([hint[:, :1] * said, torch.log(hint[:, 1:2].clamp(min=0.01) * 10) * said, said, spans, known], 1)
        fine = self.fine(x * 2 - 1)
        x = halved(x)
        read = self.net(x * 2 - 1, fine, self.hint(hint)[:, None])
        error = self.er(read.features, read.token).float()
        y = read.answer.float()
        mean_token = read.token.float()
        batch, _, height, width = y.shape
        y = y.reshape(batch, self.layers, self.CHANNELS, height, width)

        camera = placed(self.camera(mean_token), spans, known)
        depth = self.DIST + 1.3 * torch.tanh(y[:, :, :1] + self.depth_bias(x.device))
        offset = self.reach(x) * torch.tanh(y[:, :, 1:4] * 0.5)
        position = crop_rays(camera, depth, self.DIST) + offset
        opacity = torch.sigmoid(y[:, :, 4:5] - 1)
        scale = torch.exp((y[:, :, 5:8] - 3.9).clamp(-7.5, -1.2))
        rotation = F.normalize(torch.cat([y[:, :, 8:9] + 1, y[:, :, 9:12]], 2), dim=2)
        # The photo's own colour is the starting point: the network answers only with the change.
        colour = torch.sigmoid(y[:, :, 12:15] + torch.logit(x[:, None, :3].clamp(0.03, 0.97)))

        def listed(t):
            return t.permute(0, 1, 3, 4, 2).reshape(batch, self.layers * height * width, -1)

        return {
            "pos": listed(position),
            "opacity": listed(opacity)[..., 0],
            "scale": listed(scale),
            "quat": listed(rotation),
            "rgb": listed(colour),
            "depth": depth[:, 0, 0],
            "camera": camera,
            "elevation": guess(self.el(mean_token)),
            "error": error.flatten(1),
        }

    def reach(self, x):
        """How far Gaussians may lie from their pixel's ray, [B, layers, 1, H, W].

        On the subject the front layer keeps to what its pixel shows, so that the photo's own side stays sharp. The
        others are free to make up what the photo does not show.
        """
        subject = x[:, None, 3:]
        front = 0.6 + (0.03 - 0.6) * subject
        return torch.cat([front] + [torch.full_like(front, 0.6)] * (self.layers - 1), 1)

    def depth_bias(self, device):
        """[1, layers, 1, 1, 1]: the layers behind the first one start further away."""
        bias = torch.zeros(1, self.layers, 1, 1, 1, device=device)
        bias[:, 1:] = 0.5
        return bias


# What `crop_rays` makes of a camera of zeros, the canonical one: half the crop's width at the subject's centre, and the
# inverse distance. Versions to 0.2 knew no other.
CROP_HALF = SplatNet.DIST * math.tan(SplatNet.FOV / 2)
CROP_NEARNESS = 1 / SplatNet.DIST
# And the tangent of half the angle that the crop spans there.
CROP_TANGENT = CROP_HALF * CROP_NEARNESS


def placed(camera, spans, known):
    """The camera [B, 4] as near as it must be where the crop's angle is `known` [B, 1]; spans [B, 1]: the log of its tangent over
    `CROP_TANGENT`, which is half the crop's width at the subject's centre times the nearness."""
    nearness = known * (spans - camera[:, :1]) + (1 - known) * camera[:, 3:]
    return torch.cat([camera[:, :3], nearness], 1)


def crop_rays(camera, depth, distance):
    """Points [B, L, 3, H, W] at canonical depth [B, L, 1, H, W] on the rays of the crop's pixels.

    camera [B, 4]: log of half the crop's width over `CROP_HALF`, both at the plane z = `distance` of the subject's
    centre; the crop's middle there, x and y; log of the photo's camera's nearness (inverse distance to that plane)
    over `CROP_NEARNESS`. Rays spread with distance from that camera, which lies on the canonical axis.
    """
    batch, layers, _, height, width = depth.shape
    half = CROP_HALF * torch.exp(camera[:, 0]).reshape(batch, 1, 1, 1, 1)
    nearness = CROP_NEARNESS * torch.exp(camera[:, 3].clamp(-1.5, 1.5)).reshape(batch, 1, 1, 1, 1)
    middle = camera[:, 1:3].reshape(batch, 1, 2, 1, 1)
    across = (torch.arange(width, device=depth.device) + 0.5) * (2 / width) - 1
    down = (torch.arange(height, device=depth.device) + 0.5) * (2 / height) - 1
    grid = torch.stack([across[None].expand(height, width), down[:, None].expand(height, width)])
    spread = 1 + nearness * (depth - distance)
    beside = (grid[None, None] * half + middle) * spread
    return torch.cat([beside, depth], 2)


# Parts that older versions lack; in `grown` they start anew.
LATER = ("hint.", "el.", "camera.", "er.", "fine.", "held.")
# What may be trained when all else of its network is settled: names of modules, by those of their trainings.
PARTS = {"error": "er", "held": "held"}
NETS = {"scene": SceneNet, "detail": DetailNet, "splat": SplatNet}


def grown(net, state):
    """`state` of a shallower `net` (fewer transformer blocks, fewer input channels) made to fit, function unchanged.

    Blocks move apart evenly (`deepened`). New input channels count for nothing. Heads that are new start anew; what they answer
    beyond what they did is 0. A finer grid takes its positions between those of the coarser one (SceneNet's weights for
    DetailNet), and its last input is another, so counts for nothing.
    """
    fresh = net.state_dict()
    state = deepened(deepened(dict(state), fresh, "net.mid."), fresh, "net.near.")
    for name, value in fresh.items():
        if name.startswith(LATER):
            if name not in state:
                state[name] = value.clone()
            elif value.dim() and len(state[name]) < len(value):
                state[name] = torch.cat([state[name], torch.zeros_like(value[len(state[name]) :])])
        if name in ("net.stem.weight", "hint.0.weight") and state[name].shape != value.shape:
            wider = torch.zeros_like(value)
            wider[:, : state[name].shape[1]] = state[name]
            state[name] = wider
        if name == "net.pos_near" and name not in state:
            state[name] = value.clone()
    if state["net.pos"].shape != fresh["net.pos"].shape:
        state["net.pos"] = finer(state["net.pos"], fresh["net.pos"].shape[1])
        state["net.stem.weight"][:, 3:] = 0
    return {name: state[name] for name in fresh}


def deepened(state, fresh, prefix):
    """`state` with as many transformer blocks under `prefix` as `fresh` has: its own moved apart evenly, after each of them copies
    of it (where it has none, `fresh`'s) whose output projections are zero, so that they pass their tokens on until they have
    learned (Wu et al. 2024, LLaMA Pro, section 3.2)."""

    def blocks(of):
        return max((int(name[len(prefix) :].split(".")[0]) + 1 for name in of if name.startswith(prefix)), default=0)

    had, wanted = blocks(state), blocks(fresh)
    if had >= wanted:
        return state
    made = {name: value for name, value in state.items() if not name.startswith(prefix)}
    sources = state if had else fresh
    for place in range(wanted):
        source = place * (had or wanted) // wanted
        copy = not had or place > 0 and source == (place - 1) * had // wanted
        for name in [name for name in fresh if name.startswith(f"{prefix}{place}.")]:
            value = sources[name.replace(f"{prefix}{place}.", f"{prefix}{source}.", 1)]
            closes = copy and re.search(r"\.(o|f\.2)\.(weight|bias)$", name)
            made[name] = torch.zeros_like(value) if closes else value.clone()
    return made


def finer(positions, tokens):
    """Positions [1, N, C] of a square grid for one of `tokens` cells."""
    before, after = math.isqrt(positions.shape[1]), math.isqrt(tokens)
    grid = positions.reshape(1, before, before, -1).permute(0, 3, 1, 2)
    grid = F.interpolate(grid, size=(after, after), mode="bicubic", align_corners=False)
    return grid.flatten(2).transpose(1, 2)


def load_weights(net, path):
    """Load a weights file (state dict), a training checkpoint (its averaged weights) or an ONNX file into `net`."""
    if path.endswith(".onnx"):
        from restore import state_from_onnx  # which needs this module

        net.load_state_dict(state_from_onnx(path, net))
        return net
    stored = torch.load(path, map_location="cpu", weights_only=True)
    state = stored.get("ema", stored)
    net.load_state_dict(grown(net, {k: v.float() if v.is_floating_point() else v for k, v in state.items()}))
    return net
