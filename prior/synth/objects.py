"""A seed becomes an object: one maker's primitives, stretched, centred and scaled to a bounding box of diagonal 2."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from .aircraft import jet, rocket, rotorcraft
from .airfields import airfield
from .airships import airborne
from .armour import gunship, tracked
from .arms import hand_tool
from .assault_guns import assault_gun
from .beasts import beast
from .buildings import house, mast, store, tower
from .carried import carried
from .characters import character, rider
from .compositions import assembly, composition, framework
from .craft import helicopter, plane, ship, trawler
from .creatures import animal_bust, bird, bust, quadruped, soft_toy
from .crews import crew
from .desk_things import desk_thing
from .dressed import people_dressed
from .dwellings import dwelling
from .extent import bounds
from .fare import fare
from .fauna import four_legged, other_animal
from .field import biplane, dish, hut, trailer, truss_bridge, unmanned, waggon, warship
from .flyers import fixed_wing
from .foliage import broadleaf, leafy
from .frames import crane, fence, lattice_mast, scaffold, street_furniture
from .furnishings import furnishing
from .gardens import garden
from .greenery import tree
from .groups import group
from .heavy import heavy
from .helicopters import helicopter_type
from .homes import eaved_house, open_shed, play_tower
from .household import blob, clothing, gadget, instrument, seat, turned, vessel
from .hovering import hovering
from .installations import installation
from .kit import Kit, turn
from .kitchenware import kitchenware
from .landmarks import monumental
from .launchers import launcher
from .layout import BALL, BOX, FLOATS, PRIMS, SOLID, SPOKES
from .light_vehicles import light_vehicle
from .machines import boat, cycle, digger, forklift, gun, plant_hall, round_car, tractor, train
from .monuments import fountain, statue, tank_tower, windmill
from .motorbikes import motorbike
from .motorcycles import motorcycle
from .munitions import munition
from .open_buildings import open_building
from .open_cars import open_car
from .patrol import patrol
from .people import person
from .plain import articulated, container, light_plane, pickup, plain_house
from .playgrounds import playground
from .portraits import portrait
from .poses import posed_person
from .public_buildings import public_building
from .railcraft import railcraft
from .roadcraft import modern_car
from .rooms import appliance, large_furniture
from .ruins import ruin
from .sailing_boats import sailing_boat
from .sculptures import sculpture
from .seacraft import vessel_at_sea
from .sensors import sensor_truck
from .service import service_lorry
from .spacecraft import spacecraft
from .sporty import sporty
from .strongpoints import strongpoint
from .structures import arch, block, castle, church, gabled_house, pavilion, play_house, temple, tiered
from .things import figure, furniture, kitbash, plant, ware
from .town import town_building
from .toys import toy
from .troops import soldier_kit
from .two_wheelers import two_wheeler
from .upright_animals import upright_animal
from .variation import Warp, adorned, reshaped
from .vehicles import bus, car, tank, truck
from .vintage import vintage
from .warplanes import warplane
from .wheeled import carrier, covered_lorry, offroad, van
from .wild import crawler, sprout
from .works import barrier, works
from .workshop import machine
from .worn import worn
from .yard import concrete_mixer, waste_bin

# How often each kind of object is made, relative to the others.
MAKERS = [
    (car, 6),
    (round_car, 16),
    (truck, 9),
    (bus, 5),
    (motorcycle, 5),
    (cycle, 6),
    (offroad, 12),
    (open_car, 9),
    (van, 9),
    (covered_lorry, 8),
    (carrier, 8),
    (tank, 4),
    (tracked, 14),
    (gun, 5),
    (forklift, 6),
    (digger, 6),
    (tractor, 3),
    (train, 2),
    (plane, 5),
    (jet, 12),
    (helicopter, 6),
    (gunship, 7),
    (rotorcraft, 9),
    (rocket, 4),
    (ship, 4),
    (boat, 4),
    (trawler, 5),
    (house, 5),
    (gabled_house, 6),
    (eaved_house, 8),
    (open_shed, 5),
    (play_house, 6),
    (play_tower, 8),
    (block, 6),
    (tower, 4),
    (tiered, 7),
    (pavilion, 6),
    (temple, 3),
    (church, 6),
    (castle, 3),
    (arch, 3),
    (scaffold, 5),
    (lattice_mast, 3),
    (mast, 2),
    (crane, 3),
    (fountain, 4),
    (statue, 3),
    (windmill, 3),
    (tank_tower, 4),
    (fence, 2),
    (street_furniture, 6),
    (store, 5),
    (container, 12),
    (plain_house, 10),
    (articulated, 6),
    (pickup, 9),
    (light_plane, 9),
    (plant_hall, 3),
    (plant, 2),
    (leafy, 4),
    (broadleaf, 5),
    (figure, 1),
    (person, 7),
    (bust, 3),
    (animal_bust, 6),
    (soft_toy, 11),
    (quadruped, 5),
    (bird, 4),
    (ware, 3),
    (vessel, 6),
    (turned, 6),
    (furniture, 2),
    (seat, 5),
    (gadget, 5),
    (clothing, 4),
    (instrument, 4),
    (warship, 6),
    (biplane, 4),
    (unmanned, 5),
    (trailer, 5),
    (waggon, 4),
    (hut, 6),
    (dish, 4),
    (truss_bridge, 2),
    (group, 9),
    (works, 6),
    (barrier, 6),
    (crawler, 5),
    (sprout, 5),
    (hand_tool, 6),
    (fare, 5),
    (service_lorry, 9),
    (airborne, 5),
    (character, 8),
    (rider, 5),
    (appliance, 7),
    (large_furniture, 7),
    (launcher, 9),
    (sensor_truck, 7),
    (munition, 6),
    (installation, 7),
    (airfield, 7),
    (monumental, 7),
    (vessel_at_sea, 10),
    (fixed_wing, 11),
    (hovering, 9),
    (beast, 16),
    (upright_animal, 12),
    (tree, 8),
    (garden, 6),
    (crew, 10),
    (worn, 5),
    (carried, 8),
    (kitchenware, 7),
    (desk_thing, 8),
    (toy, 11),
    (sporty, 10),
    (vintage, 8),
    (modern_car, 12),
    (heavy, 10),
    (railcraft, 9),
    (dwelling, 11),
    (town_building, 9),
    (patrol, 11),
    (two_wheeler, 9),
    (portrait, 6),
    (sculpture, 5),
    (people_dressed, 9),
    (furnishing, 9),
    (playground, 7),
    (machine, 7),
    (warplane, 16),
    (helicopter_type, 14),
    (motorbike, 12),
    (light_vehicle, 9),
    (four_legged, 14),
    (other_animal, 11),
    (posed_person, 12),
    (soldier_kit, 12),
    (strongpoint, 11),
    (ruin, 9),
    (open_building, 14),
    (public_building, 14),
    (assault_gun, 8),
    (concrete_mixer, 4),
    (waste_bin, 6),
    (sailing_boat, 5),
    (spacecraft, 3),
    (kitbash, 5),
    (blob, 9),
    (composition, 90),
    (assembly, 55),
    (framework, 55),
]


# What often stands beside, behind or before other things.
COMPANIONS = (leafy, broadleaf, tree, plant, street_furniture, lattice_mast, fence, person, gabled_house, eaved_house, block, round_car, seat)

# What has thin or pierced parts.
SLENDER = {
    *(motorcycle, cycle, open_car, forklift, digger, tractor, gun, plane, light_plane, jet, helicopter, rotorcraft, ship, trawler, crane, scaffold),
    *(warship, biplane, unmanned, trailer, waggon, dish, truss_bridge, tracked, gunship, works, crawler, sprout, hand_tool),
    *(airborne, character, rider, appliance, launcher, sensor_truck, munition, installation, airfield, monumental),
    *(vessel_at_sea, fixed_wing, hovering, beast, upright_animal, tree, garden, crew, carried, desk_thing),
    *(warplane, helicopter_type, motorbike, light_vehicle, four_legged, other_animal, posed_person, soldier_kit, strongpoint, ruin, open_building),
    *(sporty, vintage, heavy, railcraft, patrol, two_wheeler, sculpture, people_dressed, furnishing, playground, machine),
    *(lattice_mast, mast, windmill, fence, street_furniture, open_shed, play_house, play_tower, pavilion, leafy, broadleaf, plant),
    *(figure, person, quadruped, bird, seat, furniture, instrument, framework),
    *(assault_gun, concrete_mixer, sailing_boat, spacecraft),
}
# What flies, and so is photographed from below as well. (Rockets and bombs stand and lie, mostly: half of theirs from below, and a launcher
# on its pad leant.)
AIRBORNE = {
    *(plane, light_plane, jet, biplane, fixed_wing, warplane, unmanned, helicopter, gunship, rotorcraft, helicopter_type, hovering, airborne),
    bird,
}
# What has corners in life as well: buildings, boxes, things of beams and boards.
ANGULAR = {
    *(house, gabled_house, eaved_house, plain_house, open_shed, play_house, play_tower, block, tower, tiered, pavilion, temple),
    *(church, castle, arch, scaffold, lattice_mast, mast, crane, fence, street_furniture, store, container, plant_hall, windmill, hut, truss_bridge, works, barrier, large_furniture),
    *(helicopter_type, strongpoint, ruin, open_building, public_building),
    *(launcher, sensor_truck, installation, airfield, monumental, railcraft, dwelling, town_building, patrol, furnishing, playground, machine),
    *(assembly, assault_gun),
}
# Of the others, how many are made of bodies with rounded corners, and their exponents (`layout.BEVEL`).
ROUNDED = 0.55
EXPONENTS = (3.2, 14.0)


# What nothing is fixed to.
ALIVE = {
    *(character, rider, animal_bust, bird, bust, quadruped, soft_toy, figure, person, group, crawler, sprout, fare, leafy, broadleaf, plant),
    *(four_legged, other_animal, posed_person, soldier_kit),
    *(beast, upright_animal, tree, garden, crew, toy, people_dressed, portrait),
}
# So many objects have proportions that no maker draws; and so many, beside what is alive, have small things on them.
RESHAPED = 0.4
ADORNED = 0.25

class Made(NamedTuple):
    """An object: primitive rows float32 [PRIMS, FLOATS], how many are used, the height of its ground, who made it.

    The subject's bounding box is centred on the origin; lengths are in units of half its diagonal.
    """

    rows: np.ndarray
    count: int
    ground: float
    maker: Callable


def make_object(seed, maker=None):
    """The object of a seed, of a maker that it draws or of the one that is given."""
    rng = np.random.default_rng(seed)
    kit = Kit(rng)
    drawn = draw_maker(rng)
    maker = maker or drawn
    maker(kit)
    stretch = draw_stretch(rng)
    primitives = [stretched(p, stretch) for p in kit.primitives[:PRIMS]]
    if rng.random() < RESHAPED:
        primitives = reshaped(primitives, Warp(*bounds(primitives), rng))
    if maker not in ALIVE and rng.random() < ADORNED:
        primitives = adorned(primitives, *bounds(primitives), PRIMS - len(primitives), rng, kit.material)
    if maker not in ANGULAR and rng.random() < ROUNDED:
        primitives = rounded(primitives, rng)
    low, high = bounds([p for p in primitives if p.subject])
    centre = (low + high) / 2
    scale = 1 / (np.linalg.norm(high - low) / 2)
    ground = bounds(primitives)[0][2]
    spin = turn("z", rng.uniform(0, 360) if rng.random() < 0.3 else 0)
    rows = np.zeros((PRIMS, FLOATS), np.float32)
    for i, primitive in enumerate(primitives):
        place = spin @ ((primitive.centre - centre) * scale)
        rows[i] = row(primitive, place, spin @ primitive.rotation, scale)
    return Made(rows, len(primitives), (ground - centre[2]) * scale, maker)


def draw_maker(rng):
    weights = np.array([weight for _, weight in MAKERS], float)
    return MAKERS[rng.choice(len(MAKERS), p=weights / weights.sum())][0]


def draw_stretch(rng):
    if rng.random() < 0.5:
        return np.diag(rng.uniform(0.85, 1.18, 3))
    return np.eye(3)


def stretched(p, stretch):
    """The primitive in a stretched object; one that lies askew keeps its angles, and only its sizes follow."""
    along = np.linalg.norm(stretch @ p.rotation, axis=0)
    shift = (p.shift[0] * along[0], p.shift[1] * along[1])
    return p._replace(centre=stretch @ p.centre, half=p.half * along, shift=shift)


def rounded(primitives, rng):
    """The same with superellipsoids for boxes, all of much the same exponent; panels, which lie on others' faces, stay flat."""
    low, high = np.log(EXPONENTS)
    usual = rng.uniform(low, high)
    exponents = np.exp(np.clip(usual + 0.2 * rng.normal(size=len(primitives)), low, high))

    def is_body(p):
        return p.kind == BOX and p.cut[0] == SOLID and p.half.min() > 0.12 * p.half.max()

    return [p._replace(bevel=e) if is_body(p) else p for p, e in zip(primitives, exponents, strict=True)]


def row(primitive, centre, rotation, scale):
    """The primitive's row as `layout` describes it."""
    kind, _, half, taper, shift, _, material, cut, bevel, subject = primitive
    shape = [kind, *centre, *rotation.T.ravel(), *(half * scale), *taper, shift[0] * scale, shift[1] * scale]
    look = [*material.first, *material.second, *material[2:]]
    gone, frequency, share = cut
    if kind in (BOX, BALL) and gone != SPOKES:
        frequency = frequency / scale
    return np.array([*shape, *look, subject, gone, frequency, share, bevel])
