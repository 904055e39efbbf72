#include "curve/places.h"

#include <math.h>

#include "base/budget.h"
#include "curve/cells.h"
#include "curve/width.h"
#include "math/vector.h"

#define CELL_GAPS 2.5 /* side of a cell, in gaps of the level */
#define LOST_GAPS                                                                                                      \
    0.35         /* length at a free end that makes no ink, in gaps of its level: it is pointed, and passes others */
#define MOST 1.5 /* greatest factor of a correction */
#define PARTS_MAX 256  /* of a line, and of a face along each of two axes */
#define CELLS_MAX 16.0 /* per point: a level whose cells would be more is as good as empty */

/* The strokes of a mesh while their thresholds are corrected. Arrays have an entry for each point. */
struct evening {
    const struct hatch_curves *curves;
    const struct hatch_mesh *mesh;
    const float *thresholds;
    double (*at)[3];
    float *drawn;         /* share of the line from the point before it that makes ink; 0: there is no line */
    float *correction[2]; /* logarithms: those of every second level each. At most two levels correct a point, and one
                             follows the other, so that threads write to different arrays. */
    struct level *levels; /* the finest first */
};

/* A level while thresholds are corrected by it, on one thread. */
struct level {
    const struct evening *evening;
    double wanted; /* strokes per mesh unit: those of the level */
    float *correction;
    bool coarsest, finest;
    struct hatch_cells cells;
    struct hatch_arena arena; /* in which the cells grow once they have the surface */
    enum hatch_status status;
    struct hatch_err err;
};

static int parts_of(double length, double side)
{
    double parts = ceil(length / side);
    return parts > 1 ? parts < PARTS_MAX ? (int)parts : PARTS_MAX : 1;
}

/* Reads the corners of a face, so that the side from the first to the second is the longest. Returns its area. */
static double read_face(const struct hatch_mesh *mesh, size_t face, double corner[3][3])
{
    const float *data = mesh->attributes[0].data;
    const uint32_t *vertex = &mesh->indices[3 * face];
    double read[3][3], normal[3], longest = -1;
    uint32_t first = 0;
    for (uint32_t c = 0; c < 3; c++)
        hatch_vec_of(&data[3 * (size_t)vertex[c]], read[c]);
    for (uint32_t c = 0; c < 3; c++) {
        double length = hatch_vec_distance(read[c], read[(c + 1) % 3]);
        first = length > longest ? c : first;
        longest = fmax(length, longest);
    }
    for (uint32_t c = 0; c < 3; c++)
        hatch_vec_copy(read[(first + c) % 3], corner[c]);
    hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
    return hatch_vec_length(normal) / 2;
}

static enum hatch_status add_face(struct hatch_cells *cells, const struct hatch_mesh *mesh, size_t face,
                                  struct hatch_err *err)
{
    double corner[3][3], area = read_face(mesh, face, corner);
    double longest = hatch_vec_distance(corner[0], corner[1]);
    int along = parts_of(longest, cells->side), across = parts_of(2 * area / fmax(longest, 1e-300), cells->side);
    for (int i = 0; i < along; i++)
        for (int j = 0; j < across; j++) {
            double share[2] = {(i + 0.5) / along, (j + 0.5) / across}, at[3];
            bool beyond = share[0] + share[1] > 1; /* the other half of the parallelogram is turned onto the face */
            for (int k = 0; k < 3; k++)
                at[k] = corner[0][k] + (beyond ? 1 - share[0] : share[0]) * (corner[1][k] - corner[0][k]) +
                        (beyond ? 1 - share[1] : share[1]) * (corner[2][k] - corner[0][k]);
            HATCH_TRY(hatch_cells_add(cells, at, 0, area / along / across, err));
        }
    return HATCH_OK;
}

/* Adds the area of the surface, from the cells of a finer level where there are some.
 *   finer  NULL: there is no such level */
static enum hatch_status add_surface(struct hatch_cells *cells, const struct hatch_mesh *mesh,
                                     const struct hatch_cells *finer, struct hatch_err *err)
{
    for (size_t f = 0; f < mesh->face_count && !finer; f++)
        HATCH_TRY(add_face(cells, mesh, f, err));
    for (uint32_t i = 0; finer && i < finer->keys.count; i++) {
        double at[3], area = (double)finer->cells[i].area;
        hatch_cells_middle(finer, i, at);
        if (area > 0)
            HATCH_TRY(hatch_cells_add(cells, at, 0, area, err));
    }
    return HATCH_OK;
}

/* Adds the ink of the line that leads to a point from the one before it. */
static enum hatch_status add_line(struct level *level, uint32_t point, struct hatch_err *err)
{
    const struct evening *evening = level->evening;
    double before = (double)evening->thresholds[point - 1], after = (double)evening->thresholds[point];
    double most = HATCH_STROKE_FADE * level->wanted;
    if (before >= most && after >= most)
        return HATCH_OK;
    const double *from = evening->at[point - 1], *to = evening->at[point];
    double length = hatch_vec_distance(from, to), ink = length * (double)evening->drawn[point];
    if (!(ink > 0))
        return HATCH_OK;
    int parts = parts_of(length, level->cells.side);
    for (int i = 0; i < parts; i++) {
        double share = (i + 0.5) / parts, at[3], threshold = before + share * (after - before);
        for (int k = 0; k < 3; k++)
            at[k] = from[k] + share * (to[k] - from[k]);
        HATCH_TRY(
            hatch_cells_add(&level->cells, at, ink / parts * hatch_stroke_share(level->wanted / threshold), 0, err));
    }
    return HATCH_OK;
}

/* Adds the correction of the level at a point: the logarithm of the ink around it, as a share of what the thresholds
 * promise. */
static enum hatch_status correct(struct level *level, uint32_t point, struct hatch_err *err)
{
    const struct evening *evening = level->evening;
    double ratio = (double)evening->thresholds[point] / level->wanted, octaves, ink = 0, area = 0, weight[8];
    uint32_t corner[8];
    if ((ratio >= 2 && !level->finest) || (ratio <= 0.5 && !level->coarsest))
        return HATCH_OK;
    octaves = log2(ratio);
    if ((octaves > 0 && level->finest) || (octaves < 0 && level->coarsest))
        octaves = 0;
    HATCH_TRY(hatch_cells_around(&level->cells, evening->at[point], corner, weight, err));
    for (int i = 0; i < 8; i++) {
        ink += weight[i] * (double)level->cells.cells[corner[i]].ink;
        area += weight[i] * (double)level->cells.cells[corner[i]].area;
    }
    double share = area > 0 ? ink / (area * HATCH_STROKE_GAIN * level->wanted) : 1;
    level->correction[point] += (float)((1 - fabs(octaves)) * log(fmax(share, 1e-3)));
    return HATCH_OK;
}

/* Adds the corrections of a level for the sets of a family, from `first` on to `end`. */
static enum hatch_status even_family(struct level *level, uint32_t first, uint32_t end, struct hatch_err *err)
{
    const struct hatch_curve_set *sets = level->evening->curves->sets;
    const struct hatch_curve *curves = level->evening->curves->curves;
    uint32_t low = sets[first].first, high = sets[end - 1].first + sets[end - 1].count;
    for (uint32_t i = 0; i < level->cells.keys.count; i++)
        level->cells.cells[i].ink = 0;
    for (uint32_t c = low; c < high; c++)
        for (uint32_t i = curves[c].first + 1; i < curves[c].first + curves[c].count; i++)
            HATCH_TRY(add_line(level, i, err));
    for (uint32_t c = low; c < high; c++)
        for (uint32_t i = curves[c].first; i < curves[c].first + curves[c].count; i++)
            HATCH_TRY(correct(level, i, err));
    return HATCH_OK;
}

static enum hatch_status even_families(struct level *level, struct hatch_err *err)
{
    const struct hatch_curves *curves = level->evening->curves;
    for (uint32_t s = 0, next; s < curves->set_count; s = next) {
        for (next = s; next < curves->set_count && curves->sets[next].family == curves->sets[s].family;)
            next++;
        HATCH_TRY(even_family(level, s, next, err));
    }
    return HATCH_OK;
}

/* Corrects by one level of all families. */
static void even_level(void *context, uint32_t index)
{
    struct level *level = &((struct evening *)context)->levels[index];
    level->status = even_families(level, &level->err);
}

/* Finds where the points of a curve are, and which share of each of its lines makes ink.
 *   lost  length at a free end that makes none */
static void measure_curve(struct evening *evening, const struct hatch_curve *curve, double lost)
{
    double total = 0, from = 0;
    const uint32_t end = curve->first + curve->count;
    for (uint32_t i = curve->first; i < end; i++) {
        float position[3];
        hatch_curve_position(evening->mesh, &evening->curves->points[i], position);
        hatch_vec_of(position, evening->at[i]);
        total += i > curve->first ? hatch_vec_distance(evening->at[i - 1], evening->at[i]) : 0;
    }
    lost = fmin(lost, total / 4);
    double low = curve->free_ends & 1 ? lost : 0, high = curve->free_ends & 2 ? total - lost : total;
    for (uint32_t i = curve->first + 1; i < end; i++) {
        double length = hatch_vec_distance(evening->at[i - 1], evening->at[i]);
        double drawn = fmin(high, from + length) - fmax(low, from);
        evening->drawn[i] = length > 0 ? (float)fmax(drawn / length, 0) : 0;
        from += length;
    }
}

static double area_of(const struct hatch_mesh *mesh)
{
    double sum = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        sum += hatch_mesh_face_area(mesh, f);
    return sum;
}

/* Lists the levels that have enough points, the finest first, each with the area of the surface in its cells.
 *   count   of all levels
 *   listed  out: number of those that are listed */
static enum hatch_status list_levels(struct evening *evening, uint32_t count, struct hatch_arena *scratch,
                                     uint32_t *listed, struct hatch_err *err)
{
    const struct hatch_curves *curves = evening->curves;
    double least_side = sqrt(area_of(evening->mesh) / (CELLS_MAX * curves->point_count));
    HATCH_TRY(HATCH_ALLOC(scratch, &evening->levels, count, err));
    *listed = 0;
    for (uint32_t i = count; i-- > 0;) {
        struct level *level = &evening->levels[*listed];
        if (CELL_GAPS * (double)curves->sets[i].gap < least_side)
            continue;
        *level = (struct level){.evening = evening,
                                .wanted = 1 / (double)curves->sets[i].gap,
                                .correction = evening->correction[*listed % 2],
                                .coarsest = i == 0,
                                .finest = *listed == 0};
        HATCH_TRY(hatch_cells_make(CELL_GAPS / level->wanted, scratch, &level->cells, err));
        HATCH_TRY(add_surface(&level->cells, evening->mesh, level->finest ? NULL : &level[-1].cells, err));
        ++*listed;
    }
    return HATCH_OK;
}

/* Returns whether the gaps of levels are so far apart that no point is corrected by every second one. Those from
 * tracing are: each is twice the one before. */
static bool are_apart(const struct level *levels, uint32_t count)
{
    for (uint32_t i = 2; i < count; i++)
        if (!(4 * levels[i].wanted <= levels[i - 2].wanted))
            return false;
    return true;
}

/* Corrects by all levels, each on a thread. */
static enum hatch_status even_levels(struct evening *evening, uint32_t count, struct hatch_pool *pool,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    size_t left = scratch->limit_bytes - scratch->used_bytes;
    struct hatch_budget budget;
    hatch_budget_init(&budget, left > 0 ? left : 1);
    for (uint32_t i = 0; i < count; i++) {
        struct level *level = &evening->levels[i];
        hatch_arena_init_shared(&level->arena, scratch->budget ? scratch->budget : &budget);
        level->cells.keys.arena = level->cells.blocks.arena = &level->arena;
    }
    hatch_parallel_for(are_apart(evening->levels, count) ? pool : NULL, count, even_level, evening);
    for (uint32_t i = 0; i < count; i++) {
        const struct level *level = &evening->levels[i];
        if (status == HATCH_OK && level->status != HATCH_OK)
            status = hatch_fail(err, level->status, "%s", level->err.text);
        hatch_arena_free(&evening->levels[i].arena);
    }
    return status;
}

enum hatch_status hatch_curves_even_places(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                           struct hatch_pool *pool, struct hatch_arena *scratch, float *thresholds,
                                           struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct evening evening = {.curves = curves, .mesh = mesh, .thresholds = thresholds};
    uint32_t levels = 0, listed;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &evening.at, curves->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &evening.drawn, curves->point_count, err));
    for (int i = 0; i < 2; i++)
        HATCH_TRY(HATCH_ALLOC(scratch, &evening.correction[i], curves->point_count, err));
    for (uint32_t s = 0; s < curves->set_count; s++) {
        levels += curves->sets[s].family == curves->sets[0].family;
        for (uint32_t c = curves->sets[s].first; c < curves->sets[s].first + curves->sets[s].count; c++)
            measure_curve(&evening, &curves->curves[c], LOST_GAPS * (double)curves->sets[s].gap);
    }
    HATCH_TRY(list_levels(&evening, levels, scratch, &listed, err));
    HATCH_TRY(even_levels(&evening, listed, pool, scratch, err));
    for (uint32_t i = 0; i < curves->point_count; i++) {
        double correction = (double)(evening.correction[0][i] + evening.correction[1][i]);
        thresholds[i] *= (float)fmin(fmax(exp(correction), 1 / MOST), MOST);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
