"""Makers of animals true to their anatomy: four-legged ones from mice to elephants, and birds, fish, reptiles, insects, molluscs, dinosaurs."""

import numpy as np

from .fishes import fish, ray, sea_giant
from .fowls import flying_bird, standing_bird
from .invertebrates import insect, mollusc, shellfish, winged_insect
from .mammals import ape, beast_of, crouched, hedgehog, kangaroo, seal
from .reptiles import frog, saurian, snake, sprawler, turtle
from .species import SHAPES


def four_legged(kit):
    """Dogs of twelve breeds, wolves, foxes, cats great and small, hyenas, horses, donkeys, zebras, cattle, bison, goats, sheep, pigs, boars, deer, moose,
    camels, llamas, elephants, rhinos, hippos, giraffes, bears, tapirs, capybaras, badgers, raccoons, otters, anteaters, armadillos, mice, hedgehogs,
    rabbits, hares, squirrels, kangaroos, seals, walruses, monkeys, gorillas."""
    special = {"crouched": crouched, "kangaroo": kangaroo, "seal": seal, "ape": ape, "hedgehog": hedgehog}
    names = [*SHAPES, *special]
    often = {"cat": 3, "horse": 3, "cow": 2, "crouched": 3, "ape": 2, "seal": 1.5, "elephant": 2, "lion": 2, "deer": 2, "sheep": 1.5, "bear": 1.5}
    weights = np.array([often.get(n, 1) for n in names], float)
    name = str(kit.rng.choice(names, p=weights / weights.sum()))
    if name in special:
        special[name](kit)
    else:
        beast_of(kit, name)


def other_animal(kit):
    """Standing and flying birds, fish, sharks, whales, dolphins, rays, turtles, crocodiles, lizards, chameleons, snakes, frogs, crabs, lobsters,
    scorpions, spiders, beetles, ants, bees, grasshoppers, mantises, butterflies, dragonflies, snails, octopuses, starfish, seahorses, jellyfish,
    dinosaurs, dragons."""
    makers = [(standing_bird, 8), (flying_bird, 3), (fish, 2.5), (sea_giant, 3), (ray, 0.7), (turtle, 2), (sprawler, 3), (snake, 1.7), (frog, 1)]
    makers += [(shellfish, 2), (insect, 4), (winged_insect, 2), (mollusc, 3), (saurian, 3.5)]
    weights = np.array([weight for _, weight in makers], float)
    makers[kit.rng.choice(len(makers), p=weights / weights.sum())][0](kit)
