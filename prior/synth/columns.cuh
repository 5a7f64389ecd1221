// Columns of the rows, as in layout.py, and two vector helpers.

enum { ROW = 36, CAMERA_ROW = 20, ENVIRONMENT_ROW = 40 };
enum { KIND = 0, CENTRE = 1, ROTATION = 4, HALF_SIZE = 13, TAPER = 16, SHIFT = 18, FIRST = 20, SECOND = 23,
       PATTERN = 26, FREQUENCY = 27, GLOSS = 28, SHININESS = 29, PATTERN_OFFSET = 30, SUBJECT = 31, CUTOUT = 32,
       CUT_FREQUENCY = 33, CUT_SHARE = 34, BEVEL = 35 };
enum { BOX = 0, BALL = 1, CYL = 2, TUBE = 3, PRISM = 4 };
enum { SOLID = 0, LEAVES = 1, BARS = 2, RUNGS = 3, LATTICE = 4, GRID = 5, SPOKES = 6 };
enum { SUN = 0, SUNLIGHT = 3, ZENITH = 6, HORIZON = 9, GROUND_A = 12, GROUND_B = 15, GROUND_FREQUENCY = 18,
       AMBIENT = 19, GROUND_KIND = 20, BACKDROP = 21, SEED = 22, GROUND_Z = 23, WALL_X = 24, WALL_Y = 25,
       WALL_DISTANCE = 26, CLOUDS = 27, HILLS = 28, HILL_COLOUR = 29, SUN_SIZE = 32, FOG = 33, WALL_KIND = 34,
       SCALE = 35, LEFT_OPEN = 36, SKY_FILL = 37, CASTER = 38, CASTER_FREQUENCY = 39 };
enum { OPEN_SKY = 0, LANDSCAPE = 1, WALL = 2, NOISE_ROOM = 3, CLUTTER = 4, TREES = 5, TOWN = 6,
       ROOM = 7 };
enum { NO_CASTER = 0, ROOFLINE = 1, CROWN = 2, POSTS = 3 };
enum { EARTH = 0, TILED = 1, PAVED = 2, GRASS = 3, WATER = 4, PLANKED = 5, RUNWAY = 6 };

__device__ inline void rotate(const float* R, float x, float y, float z, float* out) {
    out[0] = R[0] * x + R[1] * y + R[2] * z;
    out[1] = R[3] * x + R[4] * y + R[5] * z;
    out[2] = R[6] * x + R[7] * y + R[8] * z;
}

__device__ inline float dot(const float* a, const float* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
