#include <math.h>

#include "base/random.h"
#include "math/vector.h"
#include "curvature/work.h"

/* The fit at a face of the simplified mesh, in units of that mesh. */
struct sample {
    double center[3], normal[3];
    struct hatch_principal_curvatures principal;
    double standard_error_rad, confidence, radius;
};

/* Samples by the cell that contains their centre. Cells are hashed; those in one slot only cost time. */
struct grid {
    uint32_t *head, *next; /* per slot and per sample; HATCH_NO_SIDE ends a list */
    uint32_t mask;
    double cell; /* edge length of a cell */
};

#define REACH_MAX 4 /* cells, in each direction; a power of 2 */

#define POINTS_MAX 256u

/* Collects the face's points and their neighbours, each once, at most capacity. */
static uint32_t gather(const struct hatch_surface *coarse, uint32_t face, uint32_t *points, uint32_t capacity)
{
    uint32_t count = 0;
    for (int c = 0; c < 3; c++) {
        uint32_t p = coarse->corners[(size_t)face * 3 + (size_t)c];
        for (uint32_t i = coarse->ring_first[p]; i < coarse->ring_first[p + 1]; i++) {
            uint32_t q = coarse->ring_point[i], k = 0;
            while (k < count && points[k] != q)
                k++;
            if (k == count && count < capacity)
                points[count++] = q;
        }
    }
    return count;
}

/* Computes the frame of a face's plane, its radius that of the neighbourhood, and the sums of the neighbourhood.
 * Returns the number of points. */
static uint32_t sum_face(const struct hatch_surface *coarse, uint32_t face, struct hatch_jet_frame *frame,
                         struct hatch_jet_sums *sums)
{
    uint32_t points[POINTS_MAX], count = gather(coarse, face, points, POINTS_MAX);
    const double *at[3];
    double offset[3], local[3][POINTS_MAX];
    *frame = (struct hatch_jet_frame){.radius = 0};
    for (int c = 0; c < 3; c++) {
        at[c] = &coarse->points[(size_t)coarse->corners[(size_t)face * 3 + (size_t)c] * 3];
        hatch_vec_add_scaled(frame->origin, 1.0 / 3, at[c], frame->origin);
    }
    hatch_vec_triangle(at[0], at[1], at[2], frame->axes[2]);
    hatch_vec_normalize(frame->axes[2]);
    hatch_vec_any_orthogonal(frame->axes[2], frame->axes[0]);
    hatch_vec_cross(frame->axes[2], frame->axes[0], frame->axes[1]);
    for (uint32_t k = 0; k < count; k++)
        frame->radius = fmax(frame->radius, hatch_vec_distance(&coarse->points[(size_t)points[k] * 3], frame->origin));
    for (uint32_t k = 0; k < count; k++) {
        hatch_vec_sub(&coarse->points[(size_t)points[k] * 3], frame->origin, offset);
        for (int i = 0; i < 3; i++)
            local[i][k] = hatch_vec_dot(offset, frame->axes[i]) / frame->radius;
    }
    *sums = (struct hatch_jet_sums){.count = 0};
    hatch_jet_add(sums, count, local[0], local[1], local[2], NULL);
    return count;
}

/* Fits a quadric over the face's plane to its neighbourhood. */
static void fit_face(const struct hatch_surface *coarse, uint32_t face, struct sample *sample)
{
    const struct hatch_component *component =
        &coarse->components[coarse->point_component[coarse->corners[(size_t)face * 3]]];
    struct hatch_jet_frame frame;
    struct hatch_jet_sums sums;
    struct hatch_jet_system system;
    uint32_t count = sum_face(coarse, face, &frame, &sums);
    hatch_jet_factorise(&sums, 2, &system);
    *sample = (struct sample){.radius = frame.radius * component->scale, .standard_error_rad = atan(1)};
    for (int k = 0; k < 3; k++)
        sample->center[k] = component->center[k] + component->scale * frame.origin[k];
    hatch_vec_copy(frame.axes[2], sample->normal);
    hatch_vec_copy(frame.axes[0], sample->principal.direction);
    if (system.degree < 2 || count <= hatch_jet_terms(2))
        return;
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    hatch_curvature_tensor_of_system(&frame, &system, 2, &tensor, &variance);
    hatch_curvature_tensor_principal(&tensor, &sample->principal);
    double noise = hatch_jet_residual(&system, 2) / (count - hatch_jet_terms(2));
    variance.off_diagonal *= noise * frame.radius * frame.radius;
    variance.mean *= noise * frame.radius * frame.radius;
    sample->standard_error_rad = hatch_curvature_direction_error(&sample->principal, &variance);
    sample->confidence = hatch_curvature_confidence(&sample->principal, &variance);
    for (int k = 0; k < 2; k++)
        sample->principal.value[k] /= component->scale;
}

static uint32_t slot(const struct grid *grid, const double position[3], const int step[3])
{
    uint64_t key = 0;
    for (int k = 0; k < 3; k++)
        key = hatch_random_mix(key + (uint64_t)((int64_t)floor(position[k] / grid->cell) + step[k]));
    return (uint32_t)key & grid->mask;
}

static enum hatch_status make_grid(const struct sample *samples, uint32_t count, double cell,
                                   struct hatch_arena *scratch, struct grid *grid, struct hatch_err *err)
{
    const int here[3] = {0, 0, 0};
    grid->cell = cell;
    grid->mask = 1;
    while (grid->mask / 2 < count)
        grid->mask = 2 * grid->mask + 1;
    HATCH_TRY(HATCH_ALLOC(scratch, &grid->head, (size_t)grid->mask + 1, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &grid->next, count, err));
    for (uint32_t i = 0; i <= grid->mask; i++)
        grid->head[i] = HATCH_NO_SIDE;
    for (uint32_t f = 0; f < count; f++) {
        uint32_t *head = &grid->head[slot(grid, samples[f].center, here)];
        grid->next[f] = *head;
        *head = f;
    }
    return HATCH_OK;
}

struct search {
    const struct sample *samples;
    uint32_t count;
    const struct grid *grid;
    double position[3], normal[3];
    uint32_t best; /* sample; of equally near ones the lowest */
    double best_distance;
};

/* Compares a sample with the best so far. One that faces the other way (the far side of a thin part) counts as three
 * times as far. */
static void visit(struct search *search, uint32_t face)
{
    const struct sample *sample = &search->samples[face];
    double distance = hatch_vec_distance(sample->center, search->position);
    distance *= hatch_vec_dot(sample->normal, search->normal) > 0 ? 1 : 3;
    if (distance < search->best_distance || (distance <= search->best_distance && face < search->best)) {
        search->best_distance = distance;
        search->best = face;
    }
}

static void visit_cells(struct search *search, int reach)
{
    for (int x = -reach; x <= reach; x++)
        for (int y = -reach; y <= reach; y++)
            for (int z = -reach; z <= reach; z++) {
                const int step[3] = {x, y, z};
                uint32_t f = search->grid->head[slot(search->grid, search->position, step)];
                for (; f != HATCH_NO_SIDE; f = search->grid->next[f])
                    visit(search, f);
            }
}

/* Finds the nearest sample: in a growing neighbourhood of cells, then, far from all samples, among all. */
static const struct sample *nearest(struct search *search)
{
    search->best_distance = INFINITY;
    search->best = HATCH_NO_SIDE;
    for (int reach = 1; reach <= REACH_MAX; reach *= 2) {
        visit_cells(search, reach);
        if (search->best_distance <= reach * search->grid->cell)
            return &search->samples[search->best];
    }
    for (uint32_t f = 0; f < search->count; f++)
        visit(search, f);
    return &search->samples[search->best];
}

/* Gives every point the curvature of the nearest sample, projected into its own plane, in its own units. */
static void transfer(const struct hatch_surface *surface, const struct hatch_frames *frames, struct search *search,
                     struct hatch_curvature *curvature)
{
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double scale = surface->components[surface->point_component[p]].scale;
        hatch_surface_position(surface, p, search->position);
        hatch_vec_copy(&frames->normal[(size_t)p * 3], search->normal);
        const struct sample *sample = nearest(search);
        double *direction = &curvature->direction[(size_t)p * 3];
        double height = hatch_vec_dot(sample->principal.direction, search->normal);
        double side = hatch_vec_dot(sample->normal, search->normal) < 0 ? -1 : 1;
        hatch_vec_add_scaled(sample->principal.direction, -height, search->normal, direction);
        bool perpendicular = !(hatch_vec_normalize(direction) > 1e-3);
        if (perpendicular)
            hatch_vec_copy(&frames->axis[(size_t)p * 3], direction);
        for (uint32_t k = 0; k < 2; k++)
            curvature->value[(size_t)p * 2 + k] = side * sample->principal.value[k] * scale;
        curvature->confidence[p] = perpendicular ? 0 : sample->confidence;
        curvature->standard_error_rad[p] = sample->standard_error_rad;
        curvature->radius[p] = sample->radius / scale;
        hatch_vec_copy(search->normal, &curvature->normal[(size_t)p * 3]);
    }
}

static enum hatch_status make_samples(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                      struct hatch_arena *scratch, struct sample **samples, uint32_t *count,
                                      double *cell, struct hatch_err *err)
{
    struct hatch_surface coarse;
    struct hatch_surface_notes notes;
    HATCH_TRY(hatch_surface_make(mesh, arena, scratch, &coarse, &notes, err));
    HATCH_TRY(HATCH_ALLOC(scratch, samples, coarse.face_count, err));
    for (uint32_t f = 0; f < coarse.face_count; f++)
        fit_face(&coarse, f, &(*samples)[f]);
    *count = coarse.face_count;
    *cell = 0;
    for (uint32_t c = 0; c < coarse.component_count; c++)
        *cell = fmax(*cell, coarse.components[c].scale);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_coarse(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                         const struct hatch_mesh *coarse, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_curvature *curvature,
                                         struct hatch_err *err)
{
    struct hatch_curvature made;
    HATCH_TRY(hatch_curvature_allocate(surface->point_count, arena, &made, err));
    /* The simplified surface lies in arena after the results and is freed again. */
    struct hatch_arena_mark mark = hatch_arena_mark(scratch), results = hatch_arena_mark(arena);
    struct sample *samples;
    struct grid grid;
    uint32_t count;
    double cell;
    enum hatch_status status = make_samples(coarse, arena, scratch, &samples, &count, &cell, err);
    if (status == HATCH_OK)
        status = make_grid(samples, count, cell, scratch, &grid, err);
    if (status == HATCH_OK) {
        struct search search = {.samples = samples, .count = count, .grid = &grid};
        transfer(surface, frames, &search, &made);
        *curvature = made;
    }
    hatch_arena_rewind(arena, results);
    hatch_arena_rewind(scratch, mark);
    return status;
}
