#include <assert.h>
#include <math.h>

#include "math/vector.h"
#include "shapes/grid.h"

#define ANISOTROPY_MIN 0.01 /* below, the true direction counts as undefined */

const char *const hatch_shape_names[HATCH_SHAPE_COUNT + 1] = {
    [HATCH_SHAPE_TEAPOT] = "teapot",
    [HATCH_SHAPE_SPHERE] = "sphere",
    [HATCH_SHAPE_CYLINDER] = "cylinder",
    [HATCH_SHAPE_CONE] = "cone",
    [HATCH_SHAPE_TORUS] = "torus",
    [HATCH_SHAPE_PLANE] = "plane",
    [HATCH_SHAPE_ELLIPSOID] = "ellipsoid",
    [HATCH_SHAPE_SADDLE] = "saddle",
    [HATCH_SHAPE_WAVE] = "wave",
    [HATCH_SHAPE_FRUSTUM] = "frustum",
    [HATCH_SHAPE_MONGE] = "monge",
    [HATCH_SHAPE_EGGBOX] = "eggbox",
    [HATCH_SHAPE_SUPERQUADRIC] = "superquadric",
    [HATCH_SHAPE_BUMP] = "bump",
    [HATCH_SHAPE_HELICOID] = "helicoid",
    [HATCH_SHAPE_CATENOID] = "catenoid",
};

/* The surfaces of a shape and their grids. */
struct surfaces {
    uint32_t count;
    double stretch; /* of cells along u, by as much as they are narrower along v */
    struct hatch_grid grids[HATCH_SHAPE_SURFACES_MAX];
    struct hatch_parametric_size sizes[HATCH_SHAPE_SURFACES_MAX];
    double even[HATCH_SHAPE_SURFACES_MAX][HATCH_PARAMETRIC_PIECES_MAX * (HATCH_GRID_SAMPLES + 1)];
};

static double at_least(double least, double value)
{
    return value < least ? least : value;
}

/* Divides every surface into cells of about size * stretch by size / stretch; returns the number of faces. */
static double set_cell_size(struct surfaces *s, double size)
{
    double faces = 0;
    for (uint32_t g = 0; g < s->count; g++) {
        struct hatch_grid *grid = &s->grids[g];
        const struct hatch_parametric *surface = &grid->surface;
        uint32_t pieces = surface->u_pieces;
        double least = surface->wraps_u ? ceil(3.0 / pieces) : 1;
        double columns = pieces * at_least(least, round(s->sizes[g].u / pieces / size / s->stretch));
        double rows = 0;
        for (uint32_t p = 0; p < surface->v_pieces; p++) {
            double rows_min = surface->wraps_v ? 3 : surface->pole_first && surface->pole_last ? 2 : 1;
            double here = at_least(rows_min, round(s->sizes[g].v[p] / size * s->stretch));
            grid->rows[p] = (uint32_t)here;
            rows += here;
        }
        grid->columns = (uint32_t)columns;
        faces += columns * (2 * rows - surface->pole_first - surface->pole_last);
    }
    return faces;
}

/* Chooses the cell size whose number of faces is nearest to `faces`. The number falls in steps as the size grows;
 * bisection finds the step. */
static void choose_cell_size(struct surfaces *s, double faces)
{
    double fine = 1e-4, coarse = 8;
    for (int i = 0; i < 60; i++) {
        double middle = sqrt(fine * coarse);
        if (set_cell_size(s, middle) >= faces)
            fine = middle;
        else
            coarse = middle;
    }
    double above = fabs(set_cell_size(s, fine) - faces), below = fabs(set_cell_size(s, coarse) - faces);
    set_cell_size(s, below < above ? coarse : fine);
}

/* Sets the number of tiles in each direction: whole numbers, so that closed surfaces have no seam. */
static void set_texture(struct surfaces *s, enum hatch_shape_uv uv)
{
    for (uint32_t g = 0; g < s->count; g++) {
        struct hatch_grid *grid = &s->grids[g];
        bool once = uv == HATCH_SHAPE_UV_WHOLE;
        grid->u_repeats = once ? 1 : at_least(1, round(s->sizes[g].u / HATCH_SHAPE_TILE));
        double v = 0, whole = 0;
        for (uint32_t p = 0; p < grid->surface.v_pieces; p++)
            whole += s->sizes[g].v[p];
        double repeats = once ? 1 : at_least(1, round(whole / HATCH_SHAPE_TILE));
        for (uint32_t p = 0; p <= grid->surface.v_pieces; p++) {
            /* Multiples of 1/64: the last bits of measured lengths must not reach the file. */
            grid->v_texture[p] = round(64 * repeats * v / whole) / 64;
            v += p < grid->surface.v_pieces ? s->sizes[g].v[p] : 0;
        }
        if (uv == HATCH_SHAPE_UV_EVEN) {
            hatch_parametric_even(&grid->surface, s->even[g]);
            grid->v_even = s->even[g];
        }
    }
}

static double mean_edge(const struct hatch_mesh *mesh)
{
    double sum = 0, corners[3][3];
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        hatch_mesh_corners(mesh, f, corners);
        for (int c = 0; c < 3; c++)
            sum += hatch_vec_distance(corners[c], corners[(c + 1) % 3]);
    }
    return sum / ((double)mesh->face_count * 3);
}

static enum hatch_status make_empty(const struct surfaces *s, bool field, struct hatch_arena *arena,
                                    struct hatch_mesh *mesh, struct hatch_err *err)
{
    uint32_t vertices = 0, faces = 0;
    for (uint32_t g = 0; g < s->count; g++) {
        vertices += hatch_grid_vertex_count(&s->grids[g]);
        faces += hatch_grid_face_count(&s->grids[g]);
    }
    float *data;
    HATCH_TRY(hatch_mesh_make(arena, vertices, faces, mesh, err));
    HATCH_TRY(hatch_mesh_add(arena, mesh, "NORMAL", 3, &data, err));
    HATCH_TRY(hatch_mesh_add(arena, mesh, "TANGENT", 4, &data, err));
    HATCH_TRY(hatch_mesh_add(arena, mesh, "TEXCOORD_0", 2, &data, err));
    return field ? hatch_mesh_add(arena, mesh, "_HATCH_DIR", 4, &data, err) : HATCH_OK;
}

/* Fills _HATCH_DIR; positions must not have noise yet. */
static void fill_field(enum hatch_shape shape, struct hatch_mesh *mesh)
{
    const float *positions = hatch_mesh_find(mesh, "POSITION", 3);
    const float *tangents = hatch_mesh_find(mesh, "TANGENT", 4);
    float *field = hatch_mesh_find(mesh, "_HATCH_DIR", 4);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double position[3], normal[3], direction[3], curvature[2];
        hatch_vec_of(&positions[v * 3], position);
        bool defined = hatch_shape_curvature(shape, position, normal, direction, curvature) &&
                       fabs(curvature[0] - curvature[1]) >= ANISOTROPY_MIN * (fabs(curvature[0]) + fabs(curvature[1]));
        if (!defined)
            hatch_vec_of(&tangents[v * 4], direction);
        hatch_vec_round(direction, &field[v * 4]);
        field[v * 4 + 3] = defined ? 1.0f : 0.0f;
    }
}

static void fill(const struct surfaces *s, enum hatch_shape shape, const struct hatch_shape_options *options,
                 struct hatch_mesh *mesh)
{
    uint32_t vertex = 0, face = 0;
    for (uint32_t g = 0; g < s->count; g++) {
        hatch_grid_fill(&s->grids[g], options, g, vertex, face, mesh);
        vertex += hatch_grid_vertex_count(&s->grids[g]);
        face += hatch_grid_face_count(&s->grids[g]);
    }
    if (options->field)
        fill_field(shape, mesh);
    if (!(options->noise > 0))
        return;
    double distance = (double)options->noise * mean_edge(mesh);
    vertex = 0;
    for (uint32_t g = 0; g < s->count; g++) {
        hatch_grid_displace(&s->grids[g], distance, options->seed, g, vertex, mesh);
        vertex += hatch_grid_vertex_count(&s->grids[g]);
    }
}

enum hatch_status hatch_shape_make(enum hatch_shape shape, const struct hatch_shape_options *options,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                   struct hatch_err *err)
{
    assert(shape < HATCH_SHAPE_COUNT);
    assert(options->faces >= 2 && options->faces <= HATCH_SHAPE_FACES_MAX);
    assert(options->jitter >= 0 && options->jitter <= 1);
    assert(options->noise >= 0 && options->noise <= 1);
    assert(options->stretch >= 0 && options->stretch <= 16);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct surfaces *s;
    HATCH_TRY(HATCH_ALLOC(scratch, &s, 1, err));
    struct hatch_parametric parts[HATCH_SHAPE_SURFACES_MAX];
    s->stretch = options->stretch > 0 ? sqrt((double)options->stretch) : 1;
    s->count = hatch_shape_surfaces(shape, parts);
    for (uint32_t g = 0; g < s->count; g++) {
        s->grids[g].surface = parts[g];
        hatch_parametric_measure(&parts[g], &s->sizes[g]);
    }
    choose_cell_size(s, options->faces);
    set_texture(s, options->uv);
    struct hatch_mesh made;
    enum hatch_status status = make_empty(s, options->field, arena, &made, err);
    if (status == HATCH_OK) {
        fill(s, shape, options, &made);
        *mesh = made;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
