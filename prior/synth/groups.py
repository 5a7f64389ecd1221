"""A maker of several things that are photographed as one: animals, people, vessels, seats beside each other."""

import numpy as np

from .creatures import bird, quadruped, sitting, soft_toy
from .extent import bounds
from .household import seat, turned, vessel
from .kit import turn
from .layout import PRIMS
from .people import person
from .plain import container

MEMBERS = (quadruped, quadruped, quadruped, bird, sitting, soft_toy, person, person, vessel, turned, seat, container)


def group(kit):
    """Two or three of a kind, some the same again, side by side, behind each other or facing each other; where they stand apart, one sees
    through between them."""
    rng = kit.rng
    maker = MEMBERS[rng.integers(len(MEMBERS))]
    members = int(rng.choice([2, 2, 2, 3]))
    twins, spread = kit.chance(0.5), rng.choice(["row", "file", "anyhow"], p=[0.45, 0.2, 0.35])
    gap, made, edge, placed = rng.uniform(0.0, 0.35), [], 0.0, []
    for _ in range(members):
        if not (twins and made):
            maker(kit)
            made, kit.primitives = largest(kit.primitives, PRIMS // members), []
        spin = turn("z", rng.uniform(0, 360) if spread == "anyhow" else rng.normal(0, 12))
        member = [p._replace(centre=spin @ p.centre, rotation=spin @ p.rotation) for p in made]
        low, high = bounds(member)
        size = np.linalg.norm(high - low)
        along = 0 if spread == "file" else 1
        at = np.array([*(rng.normal(0, 0.12, 2) * size), -low[2]])
        at[along] = edge - low[along]
        edge += high[along] - low[along] + gap * size * rng.uniform(0.3, 1)
        placed += [p._replace(centre=p.centre + at) for p in member]
    kit.primitives = placed


def largest(primitives, count):
    """The `count` primitives with the largest sums of their two longest half sizes, in their order: an animal loses its claws and eyes, not its legs."""
    longest = sorted(range(len(primitives)), key=lambda i: -np.sort(primitives[i].half)[1:].sum())[:count]
    return [primitives[i] for i in sorted(longest)]
