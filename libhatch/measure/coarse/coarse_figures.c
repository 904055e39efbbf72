#include "measure/coarse/coarse_figures.h"

#include <stdlib.h>

#include "math/vector.h"
#include "mesh/nearest/nearest.h"

#define SPACING_PX 3.0 /* between samples on a face, at most, as far as ROWS_MAX allows */
#define ROWS_MAX 400.0 /* rows of samples on a face, and samples of a row */
#define RUN_MAX 16u    /* places whose nearest faces are listed together */
#define RUN_MIN 8u
/* The histogram of displacements: bins of 1/256 pixel, and beyond these 64 to each octave. */
#define FINE_BINS 4096u
#define BINS_PER_PX 256.0
#define FINE_PX (FINE_BINS / BINS_PER_PX)
#define OCTAVE_BINS 64.0
#define BINS (FINE_BINS + 24 * 64)
#define PIECES 64u /* of the faces of a mesh: sums do not depend on the threads */
#define DEGREES (180 / 3.14159265358979324)

/* Sums over the samples of a piece of the faces. */
struct sums {
    double largest, angle_deg;
    uint64_t samples, angles, bins[BINS]; /* angles: samples at which both surfaces have a normal */
};

/* The samples of one mesh against another. */
struct survey {
    const struct hatch_mesh *from, *onto;
    const double *pixels;           /* per vertex of from: pixels per unit of the world */
    const uint32_t *first_face;     /* per vertex of from: a face that uses it */
    const struct hatch_nearest *to; /* of onto */
    atomic_uint *worst;             /* per face of the full mesh, or NULL */
    bool from_full;
    struct sums *sums; /* PIECES */
};

/* Finds the unit normal of a mesh at a place: of its vertices, or of the face where they have none. Returns false if
 * there is none. */
static bool normal_at(const struct hatch_mesh *mesh, uint32_t face, const double share[3], double normal[3])
{
    const float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    double corners[3][3];
    hatch_mesh_corners(mesh, face, corners);
    hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
    if (normals) {
        for (int k = 0; k < 3; k++)
            normal[k] = 0;
        for (int c = 0; c < 3; c++) {
            double own[3];
            hatch_vec_of(&normals[3 * (size_t)mesh->indices[3 * (size_t)face + (size_t)c]], own);
            hatch_vec_add_scaled(normal, share[c], own, normal);
        }
    }
    return hatch_vec_normalize(normal) > 0;
}

static uint32_t bin_of(double px)
{
    if (px < FINE_PX)
        return (uint32_t)(px * BINS_PER_PX);
    return (uint32_t)fmin(FINE_BINS + OCTAVE_BINS * log2(px / FINE_PX), BINS - 1);
}

/* Returns the end of a bin, in pixels. */
static double end_of(uint32_t bin)
{
    return bin < FINE_BINS ? (bin + 1) / BINS_PER_PX : FINE_PX * exp2((bin + 1 - FINE_BINS) / OCTAVE_BINS);
}

/* Raises a number to at least a value. The result does not depend on the order in which threads do so. */
static void raise_to(atomic_uint *number, unsigned value)
{
    unsigned old = atomic_load(number);
    while (old < value && !atomic_compare_exchange_weak(number, &old, value))
        ;
}

/* A row of places on a face. */
struct row {
    uint32_t face;
    double corners[3][3];
    size_t first;   /* corner at which the rows begin */
    double height;  /* of the row, as a share of the face's */
    double columns; /* places */
};

/* Finds place `column` of a row: its barycentric coordinates. */
static void share_at(const struct row *row, double column, double share[3])
{
    share[(row->first + 2) % 3] = row->height;
    share[(row->first + 1) % 3] = (1 - row->height) * (column + 0.5) / row->columns;
    share[row->first] = 1 - share[(row->first + 1) % 3] - share[(row->first + 2) % 3];
}

static void place_at(const double corners[3][3], const double share[3], double at[3])
{
    for (int k = 0; k < 3; k++)
        at[k] = 0;
    for (int c = 0; c < 3; c++)
        hatch_vec_add_scaled(at, share[c], corners[c], at);
}

/* Measures a place on a face.
 *   list  the faces of which one is the nearest; NULL: all
 *   hint  in, out: a face of the other mesh that may be near */
static void add_sample(const struct survey *survey, const struct row *row, const double share[3],
                       const struct hatch_nearest_list *list, uint32_t *hint, struct sums *sums)
{
    double at[3], own[3], other[3], pixels = 0;
    struct hatch_nearest_place place;
    uint32_t face = row->face;
    place_at(row->corners, share, at);
    for (size_t c = 0; c < 3; c++)
        pixels += share[c] * survey->pixels[survey->from->indices[3 * (size_t)face + c]];
    if (list)
        hatch_nearest_find_listed(survey->to, list, at, &place);
    else
        hatch_nearest_find(survey->to, at, *hint, &place);
    *hint = place.face;
    pixels *= place.distance;
    sums->largest = fmax(sums->largest, pixels);
    sums->samples++;
    sums->bins[bin_of(pixels)]++;
    if (survey->worst) {
        raise_to(&survey->worst[survey->from_full ? face : place.face],
                 (unsigned)fmin(ceil(pixels * HATCH_WORST_STEPS), 1e9));
        return;
    }
    if (!normal_at(survey->from, face, share, own) || !normal_at(survey->onto, place.face, place.share, other))
        return;
    sums->angle_deg += DEGREES * acos(fmin(fmax(hatch_vec_dot(own, other), -1), 1));
    sums->angles++;
}

/* Lists the faces near places `begin` to `end` of a row; `end` is not included. Returns false if they are too many. */
static bool list_run(const struct survey *survey, const struct row *row, uint32_t begin, uint32_t end, uint32_t hint,
                     struct hatch_nearest_list *list)
{
    double ends[2][3], middle[3], share[3];
    share_at(row, begin, share);
    place_at(row->corners, share, ends[0]);
    share_at(row, end - 1, share);
    place_at(row->corners, share, ends[1]);
    for (int k = 0; k < 3; k++)
        middle[k] = (ends[0][k] + ends[1][k]) / 2;
    return hatch_nearest_gather(survey->to, middle, hatch_vec_distance(ends[0], ends[1]) / 2, hint, list);
}

/* Samples a row. Places of a long row share the search for their nearest faces, by runs. A run without a list is
 * halved; where the shortest has none, places have searches of their own, twice as many each time. */
static void add_row(const struct survey *survey, const struct row *row, uint32_t *hint, struct sums *sums)
{
    uint32_t count = (uint32_t)row->columns, length = RUN_MAX, alone = RUN_MIN, end;
    struct hatch_nearest_list list;
    for (uint32_t begin = 0; begin < count; begin = end) {
        end = begin + (length < count - begin ? length : count - begin);
        bool listed = end - begin >= RUN_MIN && list_run(survey, row, begin, end, *hint, &list);
        if (!listed && length > RUN_MIN) {
            length /= 2;
            end = begin;
            continue;
        }
        if (!listed) {
            end = begin + (alone < count - begin ? alone : count - begin);
            alone *= 2;
        } else if (length < RUN_MAX)
            length *= 2;
        for (uint32_t column = begin; column < end; column++) {
            double share[3];
            share_at(row, column, share);
            add_sample(survey, row, share, listed ? &list : NULL, hint, sums);
        }
    }
}

/* Samples a face: rows along its longest side, and the vertices of which it is the first face.
 *   hint  in, out: as for add_sample */
static void add_face(const struct survey *survey, uint32_t face, uint32_t *hint, struct sums *sums)
{
    struct row at = {.face = face};
    double normal[3], base = 0;
    hatch_mesh_corners(survey->from, face, at.corners);
    for (size_t c = 0; c < 3; c++) {
        double length = hatch_vec_distance(at.corners[c], at.corners[(c + 1) % 3]);
        at.first = length > base ? c : at.first;
        base = fmax(base, length);
    }
    hatch_vec_triangle(at.corners[0], at.corners[1], at.corners[2], normal);
    double pixels = survey->pixels[survey->from->indices[3 * (size_t)face]] / SPACING_PX;
    double rows = fmin(fmax(ceil(base > 0 ? pixels * hatch_vec_length(normal) / base : 0), 1), ROWS_MAX);
    for (double row = 1.0 / 3; row < rows; row++) {
        at.height = row / rows;
        at.columns = fmin(fmax(ceil(pixels * base * (1 - row / rows)), 1), ROWS_MAX);
        add_row(survey, &at, hint, sums);
    }
    for (size_t c = 0; c < 3; c++)
        if (survey->first_face[survey->from->indices[3 * (size_t)face + c]] == face)
            add_sample(survey, &at, (const double[3]){c == 0, c == 1, c == 2}, NULL, hint, sums);
}

static void add_piece(void *context, uint32_t piece)
{
    const struct survey *survey = context;
    uint64_t count = survey->from->face_count;
    uint32_t hint = 0;
    for (uint64_t f = count * piece / PIECES; f < count * (piece + 1) / PIECES; f++)
        add_face(survey, (uint32_t)f, &hint, &survey->sums[piece]);
}

static double percentile(const struct sums *all, double share)
{
    uint64_t below = 0;
    for (uint32_t bin = 0; bin < BINS - 1; bin++) {
        below += all->bins[bin];
        if ((double)below >= share * (double)all->samples)
            return fmin(end_of(bin), all->largest);
    }
    return all->largest;
}

static enum hatch_status measure(const struct hatch_mesh *full, const struct hatch_mesh *coarse,
                                 const struct hatch_view_set *views, atomic_uint *worst, struct hatch_pool *pool,
                                 struct hatch_arena *scratch, struct hatch_coarse_figures *figures,
                                 struct hatch_err *err)
{
    const struct hatch_mesh *meshes[2] = {full, coarse};
    struct hatch_nearest trees[2];
    uint32_t *first_face[2];
    double *pixels[2];
    struct sums *sums, *all;
    HATCH_TRY(HATCH_ALLOC(scratch, &sums, 2 * PIECES + 1, err));
    for (int side = 0; side < 2; side++) {
        HATCH_TRY(hatch_nearest_make(meshes[side], scratch, scratch, &trees[side], err));
        HATCH_TRY(HATCH_ALLOC(scratch, &pixels[side], meshes[side]->vertex_count, err));
        HATCH_TRY(HATCH_ALLOC(scratch, &first_face[side], meshes[side]->vertex_count, err));
        for (uint32_t i = 3 * meshes[side]->face_count; i-- > 0;)
            first_face[side][meshes[side]->indices[i]] = i / 3;
        for (size_t v = 0; v < meshes[side]->vertex_count; v++) {
            double world[3];
            hatch_vec_of(&meshes[side]->attributes[0].data[3 * v], world);
            hatch_vec_add_scaled(world, 1, views->bounds->center, world);
            pixels[side][v] = hatch_views_pixels(views, world);
        }
    }
    for (int side = 0; side < 2; side++) {
        struct survey survey = {meshes[side],     meshes[1 - side],         pixels[side],
                                first_face[side], &trees[1 - side],         worst,
                                side == 0,        sums + side * (int)PIECES};
        hatch_parallel_for(pool, PIECES, add_piece, &survey);
    }
    all = &sums[2 * PIECES];
    for (uint32_t piece = 0; piece < 2 * PIECES; piece++) {
        all->largest = fmax(all->largest, sums[piece].largest);
        all->angle_deg += sums[piece].angle_deg;
        all->angles += sums[piece].angles;
        all->samples += sums[piece].samples;
        for (uint32_t bin = 0; bin < BINS; bin++)
            all->bins[bin] += sums[piece].bins[bin];
    }
    *figures = (struct hatch_coarse_figures){.displacement_px = all->largest,
                                             .displacement_p999_px = percentile(all, 0.999),
                                             .normal_deg = all->angles ? all->angle_deg / (double)all->angles : 0};
    return HATCH_OK;
}

enum hatch_status hatch_measure_coarse(const struct hatch_mesh *full, const struct hatch_mesh *coarse,
                                       const struct hatch_view_set *views, atomic_uint *worst, struct hatch_pool *pool,
                                       struct hatch_arena *scratch, struct hatch_coarse_figures *figures,
                                       struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = measure(full, coarse, views, worst, pool, scratch, figures, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK && !worst)
        status = hatch_measure_outlines(full, coarse, views, pool, scratch, figures, err);
    return status;
}
