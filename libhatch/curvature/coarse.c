#include <math.h>

#include "math/point_tree.h"
#include "math/vector.h"
#include "curvature/work.h"

/* The fit at a face of the simplified mesh, in units of that mesh. */
struct sample {
    double normal[3];
    struct hatch_principal_curvatures principal;
    double standard_error_rad, confidence, radius;
};

struct samples {
    double *centers;     /* 3 per face */
    struct sample *fits; /* per face */
    struct hatch_point_tree tree;
};

#define POINTS_MAX 256u

/* Collects the face's points and their neighbours, each once, at most capacity. */
static uint32_t gather(const struct hatch_surface *coarse, uint32_t face, uint32_t *points, uint32_t capacity)
{
    uint32_t count = 0;
    for (int c = 0; c < 3; c++) {
        uint32_t p = coarse->corners[(size_t)face * 3 + (size_t)c];
        for (uint32_t i = coarse->ring_first[p]; i < coarse->ring_first[p + 1] && count < capacity; i++) {
            uint32_t q = coarse->ring_point[i], k = 0;
            while (k < count && points[k] != q)
                k++;
            if (k == count)
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

/* Fits a quadric over the face's plane to its neighbourhood.
 *   center  out: of the face */
static void fit_face(const struct hatch_surface *coarse, uint32_t face, double center[3], struct sample *sample)
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
        center[k] = component->center[k] + component->scale * frame.origin[k];
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

/* The samples, and the place at which a point searches the nearest. */
struct search {
    const struct samples *samples;
    double position[3], normal[3];
};

/* A sample that faces the other way (the far side of a thin part) counts as three times as far. */
static double distance(const void *context, uint32_t sample)
{
    const struct search *search = context;
    double length = hatch_vec_distance(&search->samples->centers[3 * (size_t)sample], search->position);
    return length * (hatch_vec_dot(search->samples->fits[sample].normal, search->normal) > 0 ? 1 : 3);
}

/* Gives every point the curvature of the nearest sample, projected into its own plane, in its own units. */
static void transfer(const struct hatch_surface *surface, const struct hatch_frames *frames, struct search *search,
                     struct hatch_curvature *curvature)
{
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double scale = surface->components[surface->point_component[p]].scale;
        hatch_surface_position(surface, p, search->position);
        hatch_vec_copy(&frames->normal[(size_t)p * 3], search->normal);
        uint32_t face = hatch_point_tree_nearest(&search->samples->tree, search->position, distance, search);
        const struct sample *sample = &search->samples->fits[face];
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
                                      struct hatch_arena *scratch, struct samples *samples, struct hatch_err *err)
{
    struct hatch_surface coarse;
    struct hatch_surface_notes notes;
    HATCH_TRY(hatch_surface_make(mesh, arena, scratch, &coarse, &notes, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &samples->centers, 3 * (size_t)coarse.face_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &samples->fits, coarse.face_count, err));
    for (uint32_t f = 0; f < coarse.face_count; f++)
        fit_face(&coarse, f, &samples->centers[3 * (size_t)f], &samples->fits[f]);
    return hatch_point_tree_make(samples->centers, coarse.face_count, scratch, &samples->tree, err);
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
    struct samples samples;
    enum hatch_status status = make_samples(coarse, arena, scratch, &samples, err);
    if (status == HATCH_OK) {
        struct search search = {.samples = &samples};
        transfer(surface, frames, &search, &made);
        *curvature = made;
    }
    hatch_arena_rewind(arena, results);
    hatch_arena_rewind(scratch, mark);
    return status;
}
