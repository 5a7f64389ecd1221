"""What tells SplatNet's pictures from true ones, and what it asks of them (SplatNet's training alone)."""

import torch
import torch.distributed as dist
import torch.nn as nn
import torch.nn.functional as F
from torch.nn.utils.parametrizations import spectral_norm

WIDTHS = (64, 128, 256, 384)
MATCHING = 5.0  # weight of the features beside the verdict
# After every layer. A spectrally normalised layer passes on a third of what differs between two pictures, and nine of them next to nothing
# that a verdict could hang on: without it the critic may say the same of all pictures for thousands of steps.
GAIN = 3.0
# A critic that is right in so many more cases than chance would be counts whole. One that guesses asks for nothing that a view lacks.
SURE = 0.2
# Of its last hundred turns or so.
MEMORY = 0.99


class Leaky(nn.Module):
    def forward(self, x):
        return F.leaky_relu(x, 0.2) * GAIN


class Critic(nn.Module):
    """A view and the photo's crop, [B, 8, 128, 128] -> verdicts on patches [B, 1, 8, 8] and on the whole [B, 1].

    Every view is premultiplied colour on random grey and its coverage; the crop is SplatNet's input, the same for all views
    of a subject, so that the back of a car is judged as the back of that car. Spectrally normalised (Miyato et al. 2018).
    """

    def __init__(self):
        super().__init__()
        self.steps = nn.ModuleList()
        before = 8
        for width in WIDTHS:
            self.steps.append(
                nn.Sequential(
                    spectral_norm(nn.Conv2d(before, width, 4, 2, 1)),
                    Leaky(),
                    spectral_norm(nn.Conv2d(width, width, 3, 1, 1)),
                    Leaky(),
                )
            )
            before = width
        self.patches = spectral_norm(nn.Conv2d(before, 1, 1))
        self.whole = nn.Sequential(
            spectral_norm(nn.Conv2d(before, before, 4, 2, 1)),
            Leaky(),
            nn.Flatten(),
            spectral_norm(nn.Linear(before * 16, 1)),
        )

    def forward(self, x):
        """Verdicts (patches, whole), above 0 where the view looks true, and the features on the way."""
        features = []
        for step in self.steps:
            x = step(x)
            features.append(x)
        return self.patches(x), self.whole(x), features


class Adversary:
    """The critic, its optimizer and its two turns; every process holds the same (gradients are averaged)."""

    def __init__(self, path="", device="cuda"):
        """A new critic, or the one that the file at `path` holds (`half`)."""
        self.share = 0.0
        self.turns = 0
        self.right = torch.tensor(0.5, device=device)
        self.critic = Critic()
        if path:
            known = torch.load(path, map_location="cpu", weights_only=True)
            self.critic.load_state_dict({k: v.float() for k, v in known.items()})
        self.critic.to(device).to(memory_format=torch.channels_last)
        self.optimizer = torch.optim.Adam(self.critic.parameters(), betas=(0.5, 0.99))
        if dist.is_initialized():
            for value in (*self.critic.parameters(), *self.critic.buffers()):
                dist.broadcast(value.data, 0)

    def state(self):
        """Everything that `go_on` needs."""
        return {"net": self.critic.state_dict(), "opt": self.optimizer.state_dict(), "turns": self.turns, "right": self.right}

    def go_on(self, state):
        self.critic.load_state_dict(state["net"])
        self.optimizer.load_state_dict(state["opt"])
        self.turns = state["turns"]
        self.right = state["right"]

    def half(self):
        """The critic's parameters and buffers in float16."""
        return {k: v.half() for k, v in self.critic.state_dict().items()}

    def follow(self, lr, share):
        """The critic's own learning rate, and how much it is heeded, from now on."""
        self.optimizer.param_groups[0]["lr"] = lr
        self.share = share

    def turn(self, answer, truth, crop):
        """Teach the critic true from made views [B, 4, S, S] beside crops [B, 4, S, S] (hinge loss); returns how often it is right."""
        self.turns += 1
        for p in self.critic.parameters():
            p.requires_grad_(True)
        with torch.autocast("cuda", torch.bfloat16):
            both = torch.cat([torch.cat([truth, answer.detach()]), torch.cat([crop, crop])], 1)
            patches, whole, _ = self.critic(both.contiguous(memory_format=torch.channels_last))
        n = len(truth)
        loss = sum(F.relu(1 - v[:n].float()).mean() + F.relu(1 + v[n:].float()).mean() for v in (patches, whole))
        self.optimizer.zero_grad(set_to_none=True)
        loss.backward()
        averaged(self.critic)
        self.optimizer.step()
        with torch.no_grad():
            return ((patches[:n] > 0).float().mean() + (patches[n:] < 0).float().mean()) / 2

    def demand(self, answer, truth, crop):
        """What it asks of made views: the slope [B, 4, S, S] of the verdict and of the features' distance from the true view's."""
        for p in self.critic.parameters():
            p.requires_grad_(False)
        asked = answer.detach().requires_grad_(True)
        with torch.autocast("cuda", torch.bfloat16):
            with torch.no_grad():
                goal = self.critic(torch.cat([truth, crop], 1).contiguous(memory_format=torch.channels_last))[2]
            patches, whole, features = self.critic(
                torch.cat([asked, crop], 1).contiguous(memory_format=torch.channels_last)
            )
        apart = sum((f.float() - g.float()).abs().mean() for f, g in zip(features, goal)) / len(goal)
        loss = MATCHING * apart - patches.float().mean() - whole.float().mean()
        return torch.autograd.grad(loss, asked)[0]

    def heeded(self, answer, truth, crop, loss, dressed):
        """A term to add to `loss`, and how often the critic is right. answer, truth: [B, V, 4, S, S]; crop: [B, 4, S, S].

        The term's slope at the views is the critic's demand, as long as `share` of the slope of `loss`, and shorter where the critic
        is not to be trusted (`trust`). Only views after the first count: the first is the photo's own; and not the first `dressed`
        subjects, whose crops wear textures that the true views lack.
        """
        own = torch.autograd.grad(loss, answer, retain_graph=True)[0][dressed:, 1:]
        views = answer.shape[1] - 1
        made, true = answer[dressed:, 1:].flatten(0, 1), truth[dressed:, 1:].flatten(0, 1)
        beside = crop[dressed:].repeat_interleave(views, 0)
        demand = self.demand(made, true, beside)
        demand = demand * (self.share * trust(self.right) * own.norm() / demand.norm().clamp(min=1e-12))
        right = self.turn(made, true, beside)
        self.right = self.right.lerp(shared(right), 1 - MEMORY)
        return (made * demand).sum(), right


def trust(right):
    """How much a critic counts, 0..1, that is right in this share of the cases: nothing at 0.5, which is chance."""
    return ((right - 0.5) / SURE).clamp(0, 1)


def shared(figure):
    """The mean of all processes' figures."""
    if dist.is_initialized():
        figure = figure.clone()
        dist.all_reduce(figure)
        figure /= dist.get_world_size()
    return figure


def averaged(net):
    """Give every process the mean of all processes' gradients."""
    if not dist.is_initialized():
        return
    gradients = [p.grad for p in net.parameters()]
    flat = torch.cat([g.flatten() for g in gradients])
    dist.all_reduce(flat)
    flat /= dist.get_world_size()
    at = 0
    for g in gradients:
        g.copy_(flat[at : at + g.numel()].view_as(g))
        at += g.numel()
