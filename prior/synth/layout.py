"""The rows that the generator, the batches and the CUDA kernel share. `raycast.cu` reads the same columns.

World frame: Z up, scaled so that the subject's bounding box has a diagonal of 2, centred on the origin.
Camera frame: OpenCV (x right, y down, z forward).
"""

# Primitives an object may have.
PRIMS = 80

# Kinds of convex primitive. BOX: its top may be scaled (taper) and moved (shift) against its bottom.
# CYL: elliptic, along local z, its top scaled by the first taper. TUBE: the mantle of a CYL, seen from both sides.
# PRISM: like CYL with as many flat sides as the second taper says.
BOX, BALL, CYL, TUBE, PRISM = range(5)

# What is cut out of a primitive: nothing, gaps between leaves, or all but bars, rungs, crossed bars, a grid, spokes.
SOLID, LEAVES, BARS, RUNGS, LATTICE, GRID, SPOKES = range(7)

# One primitive.
FLOATS = 36
KIND = 0
CENTRE = slice(1, 4)
ROTATION = slice(4, 13)  # world -> local, row-major
HALF_SIZE = slice(13, 16)
TAPER = slice(16, 18)
SHIFT = slice(18, 20)
COLOURS = (slice(20, 23), slice(23, 26))  # linear light, 0..1
PATTERN = 26
FREQUENCY = 27  # of the pattern, per unit length
GLOSS = 28  # strength of the highlight; negative: the surface shines by itself, that much
SHININESS = 29  # exponent of the highlight
PATTERN_OFFSET = 30
SUBJECT = 31  # 1 for the subject, 0 for what only stands around
CUTOUT = 32
CUT_FREQUENCY = 33  # bars per unit length, spokes per turn
CUT_SHARE = 34  # of the primitive that stays
# Of a box: up to 1 the width of its rounded edges over its least half size, which changes its shading alone; above 1 the
# exponent p of the superellipsoid |x|^p + |y|^p + |z|^p = 1 that fills it instead.
BEVEL = 35

# One camera.
CAMERA_FLOATS = 20
FOCAL = slice(12, 14)  # pixels, after rotation (0:9) and translation (9:12), world -> camera
CENTRE_X, CENTRE_Y = 14, 15  # pixels
SUBJECT_ONLY = 16

# One environment: sun direction 0:3 and colour 3:6, zenith 6:9, horizon 9:12, two ground colours 12:15 and 15:18,
# then ground frequency, ambient light, kind of ground, backdrop, seed, ground height, wall normal x and y, wall
# distance, clouds, hills, the hills' colour 29:32, the sun's size (radians), fog, kind of wall, and the size of
# textures in the surroundings, what of the sky's light a near thing leaves, how much of that light has the sky's colour
# (0..1), what out of the picture casts a shadow into it, and how fine that is.
ENVIRONMENT_FLOATS = 40
GROUND_A, GROUND_B, HILL_COLOUR = slice(12, 15), slice(15, 18), slice(29, 32)
OPEN_SKY, LANDSCAPE, WALL, NOISE_ROOM, CLUTTER, TREES, TOWN, ROOM = range(8)
NO_CASTER, ROOFLINE, CROWN, POSTS = range(4)
EARTH, TILED, PAVED, GRASS, WATER, PLANKED, RUNWAY = range(7)
