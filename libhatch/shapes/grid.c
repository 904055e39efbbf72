#include "shapes/grid.h"

#include <math.h>

#include "base/random.h"
#include "math/vector.h"

/* A row of the grid: its piece of v, and its number within the piece. */
struct piece_row {
    uint32_t piece, row;
};

static uint32_t row_count(const struct hatch_grid *grid)
{
    uint32_t count = 0;
    for (uint32_t p = 0; p < grid->surface.v_pieces; p++)
        count += grid->rows[p];
    return count;
}

static bool is_pole(const struct hatch_grid *grid, uint32_t row)
{
    return (row == 0 && grid->surface.pole_first) || (row == row_count(grid) && grid->surface.pole_last);
}

uint32_t hatch_grid_vertex_count(const struct hatch_grid *grid)
{
    uint32_t poles = (uint32_t)grid->surface.pole_first + (uint32_t)grid->surface.pole_last;
    return (row_count(grid) + 1) * (grid->columns + 1) - poles;
}

uint32_t hatch_grid_face_count(const struct hatch_grid *grid)
{
    uint32_t poles = (uint32_t)grid->surface.pole_first + (uint32_t)grid->surface.pole_last;
    return (2 * row_count(grid) - poles) * grid->columns;
}

static struct piece_row piece_row_of(const struct hatch_grid *grid, uint32_t row)
{
    struct piece_row at = {0, row};
    while (at.piece + 1 < grid->surface.v_pieces && at.row >= grid->rows[at.piece]) {
        at.row -= grid->rows[at.piece];
        at.piece++;
    }
    return at;
}

/* The first vertex of a row; a pole has one vertex less than other rows. */
static uint32_t row_start(const struct hatch_grid *grid, uint32_t row)
{
    uint32_t start = row * (grid->columns + 1);
    return row > 0 && grid->surface.pole_first ? start - 1 : start;
}

/* Random streams of a grid. */
enum use { MOVE_U, MOVE_V, DIAGONAL, NOISE, USES = 16 };

static uint64_t stream_of(uint64_t stream, enum use use)
{
    return stream * USES + (uint64_t)use;
}

/* The number of a grid point: the same on both sides of a seam and for all vertices of a pole. */
static uint64_t point_number(const struct hatch_grid *grid, uint32_t row, uint32_t column)
{
    if (grid->surface.wraps_v && row == row_count(grid))
        row = 0;
    if (is_pole(grid, row) || (grid->surface.wraps_u && column == grid->columns))
        column = 0;
    return (uint64_t)row * (grid->columns + 1) + column;
}

/* Displacement of a grid point by jitter, in grid steps: at most a quarter, so that triangles do not turn over in the
 * grid. */
static double jitter_offset(double jitter, uint64_t seed, uint64_t stream, uint64_t point)
{
    return jitter * 0.5 * ((double)hatch_random_unit(seed, stream, point) - 0.5);
}

/* The parameters of a vertex, before wrapping. Vertices on borders and at poles are not moved. */
static void parameters(const struct hatch_grid *grid, const struct hatch_shape_options *options, uint64_t stream,
                       uint32_t row, uint32_t column, double *u, double *v)
{
    const struct hatch_parametric *surface = &grid->surface;
    struct piece_row at = piece_row_of(grid, row);
    double i = column, j = at.row, rows = grid->rows[at.piece];
    bool inner_row = surface->wraps_v || (row > 0 && row < row_count(grid));
    bool inner_column = surface->wraps_u || (column > 0 && column < grid->columns);
    if (is_pole(grid, row)) {
        i += 0.5;
    } else if (inner_row && inner_column && options->jitter > 0) {
        uint64_t point = point_number(grid, row, column);
        double jitter = (double)options->jitter;
        /* The chord of a long column may cut below a curved surface by more than a row is wide. */
        i += jitter_offset(jitter / fmax((double)options->stretch, 1), options->seed, stream_of(stream, MOVE_U), point);
        j += jitter_offset(jitter, options->seed, stream_of(stream, MOVE_V), point);
        /* Above a piece's first row the step is that of the previous piece. */
        if (j < 0 && at.piece > 0)
            j *= rows / grid->rows[at.piece - 1];
    }
    *u = i / grid->columns * surface->u_pieces;
    *v = at.piece + j / rows;
}

static double wrapped(double x, double period)
{
    return x < 0 ? x + period : x >= period ? x - period : x;
}

static double texture_v(const struct hatch_grid *grid, double v)
{
    double pieces = grid->surface.v_pieces;
    double inside = v < 0 ? 0 : v >= pieces ? pieces - 1 : floor(v);
    uint32_t piece = (uint32_t)inside;
    double t = v - inside;
    if (grid->v_even && t >= 0 && t <= 1) {
        const double *share = &grid->v_even[piece * (HATCH_GRID_SAMPLES + 1)];
        double at = t * HATCH_GRID_SAMPLES;
        uint32_t k = (uint32_t)at < HATCH_GRID_SAMPLES ? (uint32_t)at : HATCH_GRID_SAMPLES - 1;
        t = share[k] + (at - k) * (share[k + 1] - share[k]);
    }
    return grid->v_texture[piece] + t * (grid->v_texture[piece + 1] - grid->v_texture[piece]);
}

struct vertex_arrays {
    float *position, *normal, *tangent, *texcoord;
};

static void fill_vertex(const struct hatch_grid *grid, const struct hatch_shape_options *options, uint64_t stream,
                        uint32_t row, uint32_t column, const struct vertex_arrays *arrays, size_t vertex)
{
    const struct hatch_parametric *surface = &grid->surface;
    bool last_column = surface->wraps_u && column == grid->columns;
    bool last_row = surface->wraps_v && row == row_count(grid);
    double u, v;
    /* Both sides of a seam are evaluated at the same parameters, so that they agree to the last bit. */
    parameters(grid, options, stream, last_row ? 0 : row, last_column ? 0 : column, &u, &v);
    struct hatch_parametric_point point;
    surface->at(surface, surface->wraps_u ? wrapped(u, surface->u_pieces) : u,
                surface->wraps_v ? wrapped(v, surface->v_pieces) : v, &point);
    hatch_vec_round(point.position, &arrays->position[vertex * 3]);
    hatch_vec_round(point.normal, &arrays->normal[vertex * 3]);
    hatch_vec_round(point.along_u, &arrays->tangent[vertex * 4]);
    arrays->tangent[vertex * 4 + 3] = 1.0f;
    u += last_column ? surface->u_pieces : 0;
    v += last_row ? surface->v_pieces : 0;
    arrays->texcoord[vertex * 2] = (float)(u / surface->u_pieces * grid->u_repeats);
    arrays->texcoord[vertex * 2 + 1] = (float)texture_v(grid, v);
}

static uint32_t row_vertices(const struct hatch_grid *grid, uint32_t row)
{
    return grid->columns + (is_pole(grid, row) ? 0 : 1);
}

static void add_face(uint32_t **index, uint32_t a, uint32_t b, uint32_t c)
{
    *(*index)++ = a;
    *(*index)++ = b;
    *(*index)++ = c;
}

/* Writes the faces between a row and the next one, counter-clockwise seen from outside. */
static void fill_strip(const struct hatch_grid *grid, const struct hatch_shape_options *options, uint64_t stream,
                       uint32_t row, uint32_t first_vertex, uint32_t **index)
{
    uint32_t above = first_vertex + row_start(grid, row);
    uint32_t below = first_vertex + row_start(grid, row + 1);
    for (uint32_t i = 0; i < grid->columns; i++) {
        uint32_t a = above + i, b = a + 1, d = below + i, c = d + 1;
        uint64_t quad = (uint64_t)row * grid->columns + i;
        if (is_pole(grid, row)) {
            add_face(index, a, d, c);
        } else if (is_pole(grid, row + 1)) {
            add_face(index, a, d, b);
        } else if (options->jitter > 0 && hatch_random_unit(options->seed, stream_of(stream, DIAGONAL), quad) < 0.5f) {
            add_face(index, a, d, b);
            add_face(index, b, d, c);
        } else {
            add_face(index, a, d, c);
            add_face(index, a, c, b);
        }
    }
}

void hatch_grid_fill(const struct hatch_grid *grid, const struct hatch_shape_options *options, uint64_t stream,
                     uint32_t first_vertex, uint32_t first_face, struct hatch_mesh *mesh)
{
    const struct vertex_arrays arrays = {hatch_mesh_find(mesh, "POSITION", 3), hatch_mesh_find(mesh, "NORMAL", 3),
                                         hatch_mesh_find(mesh, "TANGENT", 4), hatch_mesh_find(mesh, "TEXCOORD_0", 2)};
    size_t vertex = first_vertex;
    uint32_t *index = &mesh->indices[(size_t)first_face * 3];
    for (uint32_t row = 0; row <= row_count(grid); row++) {
        for (uint32_t column = 0; column < row_vertices(grid, row); column++)
            fill_vertex(grid, options, stream, row, column, &arrays, vertex++);
        if (row < row_count(grid))
            fill_strip(grid, options, stream, row, first_vertex, &index);
    }
}

/* A standard normal deviate as the sum of twelve uniform ones: exact in doubles on every machine, unlike logarithm and
 * cosine; at most 6 deviations. */
static double normal_deviate(uint64_t seed, uint64_t stream, uint64_t index)
{
    double sum = -6;
    for (uint64_t k = 0; k < 12; k++)
        sum += (double)hatch_random_unit(seed, stream, index * 12 + k);
    return sum;
}

void hatch_grid_displace(const struct hatch_grid *grid, double distance, uint64_t seed, uint64_t stream,
                         uint32_t first_vertex, struct hatch_mesh *mesh)
{
    float *position = &hatch_mesh_find(mesh, "POSITION", 3)[(size_t)first_vertex * 3];
    const float *normal = &hatch_mesh_find(mesh, "NORMAL", 3)[(size_t)first_vertex * 3];
    for (uint32_t row = 0; row <= row_count(grid); row++)
        for (uint32_t column = 0; column < row_vertices(grid, row); column++) {
            /* The vertices of a pole may have different normals (a cone's apex) and must stay together. */
            double by = is_pole(grid, row) ? 0
                                           : distance * normal_deviate(seed, stream_of(stream, NOISE),
                                                                       point_number(grid, row, column));
            for (int k = 0; k < 3; k++)
                position[k] = (float)((double)position[k] + by * (double)normal[k]);
            position += 3;
            normal += 3;
        }
}
