#include "curve/places.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "curve/width.h"
#include "math/vector.h"

#define CELL_GAPS 2.5 /* side of a cell, in gaps of the level */
#define LOST_GAPS                                                                                                      \
    0.35         /* length at a free end that makes no ink, in gaps of its level: it is pointed, and passes others */
#define MOST 1.5 /* greatest factor of a correction */
#define PARTS_MAX 256  /* of a line, and of a face along each of two axes */
#define CELLS_MAX 16.0 /* per point: a level whose cells would be more is as good as empty */
#define SLOTS_MIN 1024u

/* A cell: the ink of the strokes in it, if they were one unit wide, and the area of the surface. */
struct cell {
    int32_t at[3];
    bool used;
    float ink, area;
};

/* The cells of a level that are not empty, by hashes of their places. */
struct cells {
    struct cell *slots;
    uint32_t slot_count, used;
    double side;
    struct hatch_arena *arena;
};

/* The strokes of a mesh while their thresholds are corrected. Arrays have an entry for each point. */
struct evening {
    const struct hatch_curves *curves;
    const struct hatch_mesh *mesh;
    const float *thresholds;
    double (*at)[3];
    float *drawn;      /* share of the line from the point before it that makes ink; 0: there is no line */
    float *correction; /* a logarithm */
    double wanted;     /* strokes per mesh unit: those of the level */
    bool coarsest, finest;
    struct cells cells;
};

static struct cell *find_cell(const struct cells *cells, const int32_t at[3])
{
    uint64_t key = (uint64_t)(uint32_t)at[0] << 42 ^ (uint64_t)(uint32_t)at[1] << 21 ^ (uint64_t)(uint32_t)at[2];
    uint32_t slot = (uint32_t)hatch_random_mix(key) & (cells->slot_count - 1);
    while (cells->slots[slot].used && memcmp(cells->slots[slot].at, at, sizeof cells->slots[slot].at) != 0)
        slot = (slot + 1) & (cells->slot_count - 1);
    return &cells->slots[slot];
}

/* Makes room for eight cells more. */
static enum hatch_status reserve(struct cells *cells, struct hatch_err *err)
{
    const struct cells old = *cells;
    if (2 * (cells->used + 8) <= cells->slot_count)
        return HATCH_OK;
    cells->slot_count = old.slot_count > 0 ? 2 * old.slot_count : SLOTS_MIN;
    HATCH_TRY(HATCH_ALLOC(cells->arena, &cells->slots, cells->slot_count, err));
    for (uint32_t i = 0; i < old.slot_count; i++)
        if (old.slots[i].used)
            *find_cell(cells, old.slots[i].at) = old.slots[i];
    return HATCH_OK;
}

/* Finds the eight cells whose middles are around a place, and how near it is to them. */
static void find_corners(const struct cells *cells, const double at[3], int32_t place[8][3], double weight[8])
{
    int32_t low[3];
    double part[3];
    for (int k = 0; k < 3; k++) {
        double along = at[k] / cells->side, whole = floor(along);
        low[k] = (int32_t)fmin(fmax(whole, -0x1p30), 0x1p30);
        part[k] = along - whole;
    }
    for (int corner = 0; corner < 8; corner++) {
        weight[corner] = 1;
        for (int k = 0; k < 3; k++) {
            place[corner][k] = low[k] + (corner >> k & 1);
            weight[corner] *= corner >> k & 1 ? part[k] : 1 - part[k];
        }
    }
}

/* Divides ink and area among the cells around a place. */
static enum hatch_status add(struct cells *cells, const double at[3], double ink, double area, struct hatch_err *err)
{
    int32_t place[8][3];
    double weight[8];
    HATCH_TRY(reserve(cells, err));
    find_corners(cells, at, place, weight);
    for (int corner = 0; corner < 8; corner++) {
        struct cell *cell = find_cell(cells, place[corner]);
        cells->used += !cell->used;
        memcpy(cell->at, place[corner], sizeof place[corner]);
        cell->used = true;
        cell->ink += (float)(weight[corner] * ink);
        cell->area += (float)(weight[corner] * area);
    }
    return HATCH_OK;
}

static int parts_of(double length, double side)
{
    return (int)fmin(fmax(ceil(length / side), 1), PARTS_MAX);
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

static enum hatch_status add_face(struct cells *cells, const struct hatch_mesh *mesh, size_t face,
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
            HATCH_TRY(add(cells, at, 0, area / along / across, err));
        }
    return HATCH_OK;
}

/* Adds the area of the surface, from the cells of a finer level where there are some.
 *   finer  may be empty */
static enum hatch_status add_surface(struct evening *evening, const struct cells *finer, struct hatch_err *err)
{
    for (size_t f = 0; f < evening->mesh->face_count && finer->used == 0; f++)
        HATCH_TRY(add_face(&evening->cells, evening->mesh, f, err));
    for (uint32_t i = 0; i < finer->slot_count; i++) {
        const struct cell *cell = &finer->slots[i];
        const double at[3] = {cell->at[0] * finer->side, cell->at[1] * finer->side, cell->at[2] * finer->side};
        if (cell->area > 0)
            HATCH_TRY(add(&evening->cells, at, 0, (double)cell->area, err));
    }
    return HATCH_OK;
}

/* Adds the ink of the line that leads to a point from the one before it. */
static enum hatch_status add_line(struct evening *evening, uint32_t point, struct hatch_err *err)
{
    const double *from = evening->at[point - 1], *to = evening->at[point];
    double before = (double)evening->thresholds[point - 1], after = (double)evening->thresholds[point];
    double length = hatch_vec_distance(from, to), ink = length * (double)evening->drawn[point];
    if (!(ink > 0) || fmin(before, after) >= HATCH_STROKE_FADE * evening->wanted)
        return HATCH_OK;
    int parts = parts_of(length, evening->cells.side);
    for (int i = 0; i < parts; i++) {
        double share = (i + 0.5) / parts, at[3], threshold = before + share * (after - before);
        for (int k = 0; k < 3; k++)
            at[k] = from[k] + share * (to[k] - from[k]);
        HATCH_TRY(add(&evening->cells, at, ink / parts * hatch_stroke_share(evening->wanted / threshold), 0, err));
    }
    return HATCH_OK;
}

/* Returns the ink around a place, as a share of what the thresholds promise. */
static double ink_at(const struct evening *evening, const double at[3])
{
    int32_t place[8][3];
    double weight[8], ink = 0, area = 0;
    find_corners(&evening->cells, at, place, weight);
    for (int corner = 0; corner < 8; corner++) {
        const struct cell *cell = find_cell(&evening->cells, place[corner]);
        ink += weight[corner] * (double)cell->ink;
        area += weight[corner] * (double)cell->area;
    }
    return area > 0 ? ink / (area * HATCH_STROKE_GAIN * evening->wanted) : 1;
}

/* Adds the corrections of a level for the sets of a family, from `first` on to `end`. */
static enum hatch_status even_family(struct evening *evening, uint32_t first, uint32_t end, struct hatch_err *err)
{
    const struct hatch_curve_set *sets = evening->curves->sets;
    const struct hatch_curve *curves = evening->curves->curves;
    for (uint32_t i = 0; i < evening->cells.slot_count; i++)
        evening->cells.slots[i].ink = 0;
    for (uint32_t c = sets[first].first; c < sets[end - 1].first + sets[end - 1].count; c++)
        for (uint32_t i = curves[c].first + 1; i < curves[c].first + curves[c].count; i++)
            HATCH_TRY(add_line(evening, i, err));
    for (uint32_t c = sets[first].first; c < sets[end - 1].first + sets[end - 1].count; c++)
        for (uint32_t i = curves[c].first; i < curves[c].first + curves[c].count; i++) {
            double octaves = log2((double)evening->thresholds[i] / evening->wanted);
            if ((octaves > 0 && evening->finest) || (octaves < 0 && evening->coarsest))
                octaves = 0;
            if (fabs(octaves) < 1)
                evening->correction[i] +=
                    (float)((1 - fabs(octaves)) * log(fmax(ink_at(evening, evening->at[i]), 1e-3)));
        }
    return HATCH_OK;
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

/* Corrects by one level of all families.
 *   level  a set whose gap is that of the level
 *   finer  in, out: the cells of the level before, then of this one */
static enum hatch_status even_level(struct evening *evening, uint32_t level, struct cells *finer, struct hatch_err *err)
{
    const struct hatch_curves *curves = evening->curves;
    evening->wanted = 1 / (double)curves->sets[level].gap;
    evening->cells = (struct cells){.side = CELL_GAPS / evening->wanted, .arena = finer->arena};
    HATCH_TRY(add_surface(evening, finer, err));
    for (uint32_t s = 0, next; s < curves->set_count; s = next) {
        for (next = s; next < curves->set_count && curves->sets[next].family == curves->sets[s].family;)
            next++;
        HATCH_TRY(even_family(evening, s, next, err));
    }
    *finer = evening->cells;
    return HATCH_OK;
}

static double area_of(const struct hatch_mesh *mesh)
{
    double sum = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        sum += hatch_mesh_face_area(mesh, f);
    return sum;
}

enum hatch_status hatch_curves_even_places(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                           struct hatch_arena *scratch, float *thresholds, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct evening evening = {.curves = curves, .mesh = mesh, .thresholds = thresholds, .finest = true};
    struct cells finer = {.arena = scratch};
    double least_side = sqrt(area_of(mesh) / (CELLS_MAX * curves->point_count));
    uint32_t levels = 0;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &evening.at, curves->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &evening.drawn, curves->point_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &evening.correction, curves->point_count, err));
    for (uint32_t s = 0; s < curves->set_count; s++) {
        levels += curves->sets[s].family == curves->sets[0].family;
        for (uint32_t c = curves->sets[s].first; c < curves->sets[s].first + curves->sets[s].count; c++)
            measure_curve(&evening, &curves->curves[c], LOST_GAPS * (double)curves->sets[s].gap);
    }
    for (uint32_t level = levels; level-- > 0;) {
        evening.coarsest = level == 0;
        if (CELL_GAPS * (double)curves->sets[level].gap < least_side)
            continue;
        HATCH_TRY(even_level(&evening, level, &finer, err));
        evening.finest = false;
    }
    for (uint32_t i = 0; i < curves->point_count; i++)
        thresholds[i] *= (float)fmin(fmax(exp((double)evening.correction[i]), 1 / MOST), MOST);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
