#include "measure/field_figures.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "math/percentile.h"
#include "math/vector.h"
#include "field/field.h"
#include "surface/nearest.h"

#define DEGREES (180 / 3.14159265358979323846)

struct compared {
    double degrees;
    float confidence; /* of the reference, as in a file: means of equal numbers stay equal */
};

struct hatch_field_samples {
    struct hatch_field_samples *next;
    uint32_t points, faces, compared; /* entries of confidence, uv, angles */
    struct hatch_weighted *confidence, *uv;
    struct compared *angles;
};

/* A mesh with its field: a direction and a confidence per point. */
struct subject {
    const struct hatch_mesh *mesh;
    struct hatch_surface surface;
    struct hatch_frames frames;
    double *direction, *confidence;
};

static enum hatch_status read_subject(const struct hatch_field_sum *sum, const struct hatch_mesh *mesh,
                                      struct subject *subject, struct hatch_err *err)
{
    struct hatch_surface_notes notes;
    struct hatch_surface *surface = &subject->surface;
    subject->mesh = mesh;
    HATCH_TRY(hatch_surface_make_cut(mesh, sum->arena, sum->scratch, surface, &notes, err));
    HATCH_TRY(hatch_frames_make(surface, sum->arena, sum->scratch, &subject->frames, err));
    HATCH_TRY(HATCH_ALLOC(sum->arena, &subject->direction, 3 * (size_t)surface->point_count, err));
    HATCH_TRY(HATCH_ALLOC(sum->arena, &subject->confidence, surface->point_count, err));
    if (!hatch_field_of_mesh(surface, &subject->frames, mesh, subject->direction, subject->confidence))
        return hatch_fail(err, HATCH_BAD_INPUT, "no direction field (_HATCH_DIR); add one with dirfield");
    return HATCH_OK;
}

/* Angle between lines, 0 .. 90; accurate for small angles, too. */
static double angle_degrees(const double a[3], const double b[3])
{
    double across[3];
    hatch_vec_cross(a, b, across);
    return atan2(hatch_vec_length(across), fabs(hatch_vec_dot(a, b))) * DEGREES;
}

/* Computes the direction in a face's plane in which u rises and v is constant; false when the texture
 * coordinates are degenerate. */
static bool rising_u(const struct subject *s, const float *uv, uint32_t face, double rising[3], double *area)
{
    const uint32_t *vertex = &s->surface.corner_vertex[3 * (size_t)face];
    const float *positions = s->mesh->attributes[0].data;
    double p[3][3], t[3][2], normal[3];
    for (int c = 0; c < 3; c++) {
        hatch_vec_of(&positions[3 * (size_t)vertex[c]], p[c]);
        for (int k = 0; k < 2; k++)
            t[c][k] = (double)uv[2 * (size_t)vertex[c] + (size_t)k] - (double)uv[2 * (size_t)vertex[0] + (size_t)k];
    }
    hatch_vec_triangle(p[0], p[1], p[2], normal);
    *area = hatch_vec_length(normal) / 2;
    double determinant = t[1][0] * t[2][1] - t[2][0] * t[1][1];
    for (int k = 0; k < 3; k++)
        rising[k] = ((p[1][k] - p[0][k]) * t[2][1] - (p[2][k] - p[0][k]) * t[1][1]) / determinant;
    double length = hatch_vec_normalize(rising);
    return length > 0 && isfinite(length);
}

static enum hatch_status measure_uv(const struct hatch_field_sum *sum, const struct subject *s,
                                    struct hatch_field_samples *samples, struct hatch_err *err)
{
    const float *uv = hatch_mesh_find(s->mesh, "TEXCOORD_0", 2);
    double rising[3], line[3], area, spread_rad;
    if (!uv)
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC(sum->arena, &samples->uv, s->surface.face_count, err));
    for (uint32_t f = 0; f < s->surface.face_count; f++) {
        if (!rising_u(s, uv, f, rising, &area))
            continue;
        hatch_field_face_direction(&s->surface, &s->frames, s->direction, f, line, &spread_rad);
        samples->uv[samples->faces++] = (struct hatch_weighted){angle_degrees(line, rising), area};
    }
    return HATCH_OK;
}

/* Numbers the positions of both meshes' vertices; equal positions get equal numbers. */
static enum hatch_status weld_both(const struct hatch_field_sum *sum, const struct hatch_mesh *a,
                                   const struct hatch_mesh *b, uint32_t *position, uint32_t *position_count,
                                   struct hatch_err *err)
{
    struct hatch_mesh both;
    struct hatch_arena_mark mark = hatch_arena_mark(sum->scratch);
    if (a->vertex_count > UINT32_MAX - 1 - b->vertex_count)
        return hatch_fail(err, HATCH_LIMIT, "too many vertices to compare");
    HATCH_TRY(hatch_mesh_make(sum->scratch, a->vertex_count + b->vertex_count, 0, &both, err));
    size_t first_of_b = 3 * (size_t)a->vertex_count;
    memcpy(both.attributes[0].data, a->attributes[0].data, first_of_b * sizeof(float));
    memcpy(both.attributes[0].data + first_of_b, b->attributes[0].data, 3 * (size_t)b->vertex_count * sizeof(float));
    enum hatch_status status = hatch_mesh_weld(&both, sum->scratch, position, position_count, err);
    hatch_arena_rewind(sum->scratch, mark);
    return status;
}

/* Finds for each vertex of the mesh the reference's point that it is compared with, or HATCH_NO_SIDE. */
static enum hatch_status match_vertices(const struct hatch_field_sum *sum, const struct subject *s,
                                        const struct subject *reference, uint32_t *match, struct hatch_err *err)
{
    uint32_t count = s->mesh->vertex_count, reference_count = reference->mesh->vertex_count, position_count;
    uint32_t *point, *position;
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &point, reference_count, err));
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &position, (size_t)count + reference_count, err));
    hatch_surface_vertex_points(&reference->surface, reference_count, point);
    HATCH_TRY(weld_both(sum, s->mesh, reference->mesh, position, &position_count, err));
    uint32_t *point_at;
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &point_at, position_count, err));
    memset(point_at, 0xff, position_count * sizeof *point_at);
    for (uint32_t v = reference_count; v-- > 0;)
        if (point[v] != HATCH_NO_SIDE)
            point_at[position[count + v]] = point[v];
    uint32_t matched = 0;
    for (uint32_t v = 0; v < count; v++) {
        match[v] = point_at[position[v]];
        matched += match[v] != HATCH_NO_SIDE;
    }
    if (matched < count - matched && count == reference_count) /* noise does not move some points, such as poles */
        memcpy(match, point, count * sizeof *match);
    else if (matched == 0)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "no point coincides with one of the reference, and there are %u vertices instead of %u",
                          count, reference_count);
    return HATCH_OK;
}

/* Lines are projected to the reference's tangent plane, since noise tilts the mesh's own. */
static void compare_points(const struct subject *s, const struct subject *reference, const uint32_t *first_vertex,
                           const uint32_t *match, struct hatch_field_samples *samples)
{
    for (uint32_t p = 0; p < s->surface.point_count; p++) {
        uint32_t other = match[first_vertex[p]];
        if (other == HATCH_NO_SIDE || !(reference->confidence[other] > 0))
            continue;
        const double *normal = &reference->frames.normal[3 * (size_t)other];
        const double *line = &s->direction[3 * (size_t)p];
        double projected[3];
        hatch_vec_add_scaled(line, -hatch_vec_dot(line, normal), normal, projected);
        samples->angles[samples->compared++] = (struct compared){
            angle_degrees(projected, &reference->direction[3 * (size_t)other]), (float)reference->confidence[other]};
    }
}

static enum hatch_status compare(struct hatch_field_sum *sum, const struct subject *s, const struct hatch_mesh *mesh,
                                 struct hatch_field_samples *samples, struct hatch_err *err)
{
    struct subject reference;
    enum hatch_status status = read_subject(sum, mesh, &reference, err);
    sum->reference_failed = status != HATCH_OK;
    HATCH_TRY(status);
    uint32_t *match, *first_vertex;
    HATCH_TRY(HATCH_ALLOC(sum->arena, &samples->angles, s->surface.point_count, err));
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &match, s->mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &first_vertex, s->surface.point_count, err));
    for (size_t i = 3 * (size_t)s->surface.face_count; i-- > 0;)
        first_vertex[s->surface.corners[i]] = s->surface.corner_vertex[i];
    HATCH_TRY(match_vertices(sum, s, &reference, match, err));
    compare_points(s, &reference, first_vertex, match, samples);
    return HATCH_OK;
}

static enum hatch_status measure_surface(struct hatch_field_sum *sum, const struct subject *s, struct hatch_err *err)
{
    const struct hatch_surface *surface = &s->surface;
    struct hatch_singularities singular;
    struct hatch_field_figures *out = &sum->figures;
    double energy[2], *zeros;
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &zeros, surface->point_count, err));
    const struct hatch_field_problem none = {surface, &s->frames, s->direction, zeros, NULL, false};
    HATCH_TRY(hatch_field_singularities(surface, &s->frames, s->direction, sum->arena, sum->scratch, &singular, err));
    hatch_field_energy(&none, 1, s->direction, energy);
    out->points += surface->point_count;
    out->faces += surface->face_count;
    out->components += surface->component_count;
    out->singularities += singular.count;
    out->smoothness += energy[0];
    for (uint32_t c = 0; c < surface->component_count; c++) {
        out->euler += surface->components[c].euler;
        out->index_sum += singular.component_half_turns[c] / 2.0;
    }
    return HATCH_OK;
}

static enum hatch_status add(struct hatch_field_sum *sum, const struct hatch_mesh *mesh,
                             const struct hatch_mesh *reference, struct hatch_err *err)
{
    struct subject subject;
    HATCH_TRY(read_subject(sum, mesh, &subject, err));
    struct hatch_field_samples *samples;
    HATCH_TRY(HATCH_ALLOC(sum->arena, &samples, 1, err));
    samples->points = subject.surface.point_count;
    HATCH_TRY(HATCH_ALLOC(sum->arena, &samples->confidence, samples->points, err));
    for (uint32_t p = 0; p < samples->points; p++)
        samples->confidence[p] = (struct hatch_weighted){subject.confidence[p], 1};
    HATCH_TRY(measure_uv(sum, &subject, samples, err));
    if (reference)
        HATCH_TRY(compare(sum, &subject, reference, samples, err));
    HATCH_TRY(measure_surface(sum, &subject, err));
    samples->next = sum->samples;
    sum->samples = samples;
    return HATCH_OK;
}

enum hatch_status hatch_measure_field_add(struct hatch_field_sum *sum, const struct hatch_mesh *mesh,
                                          const struct hatch_mesh *reference, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(sum->scratch);
    enum hatch_status status = add(sum, mesh, reference, err);
    hatch_arena_rewind(sum->scratch, mark);
    return status;
}

static int by_falling_confidence(const void *a, const void *b)
{
    const struct compared *x = a, *y = b;
    return (x->confidence < y->confidence) - (x->confidence > y->confidence);
}

enum list { CONFIDENCE, UV };

/* Percentiles of a list over all meshes. */
static enum hatch_status rank(const struct hatch_field_sum *sum, enum list list, const double shares[3], double out[3],
                              struct hatch_err *err)
{
    size_t count = 0;
    for (const struct hatch_field_samples *s = sum->samples; s; s = s->next)
        count += list == UV ? s->faces : s->points;
    struct hatch_weighted *all;
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &all, count, err));
    count = 0;
    for (const struct hatch_field_samples *s = sum->samples; s; s = s->next) {
        uint32_t length = list == UV ? s->faces : s->points;
        if (length)
            memcpy(&all[count], list == UV ? s->uv : s->confidence, length * sizeof *all);
        count += length;
    }
    hatch_percentiles(all, count, shares, 3, out);
    return HATCH_OK;
}

static enum hatch_status rank_angles(const struct hatch_field_sum *sum, double share, struct hatch_field_figures *out,
                                     struct hatch_err *err)
{
    static const double shares[4] = {0.5, 0.75, 0.95, 1}, axis_shares[2] = {0.5, 0.95};
    size_t count = 0;
    for (const struct hatch_field_samples *s = sum->samples; s; s = s->next)
        count += s->compared;
    struct compared *all;
    struct hatch_weighted *angles;
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &all, count, err));
    HATCH_TRY(HATCH_ALLOC(sum->scratch, &angles, count, err));
    count = 0;
    for (const struct hatch_field_samples *s = sum->samples; s; s = s->next) {
        if (s->compared)
            memcpy(&all[count], s->angles, s->compared * sizeof *all);
        count += s->compared;
    }
    qsort(all, count, sizeof *all, by_falling_confidence);
    /* All points of equal confidence count, so that neither their angles nor their order choose among them. */
    size_t taken = (size_t)ceil(share * (double)count);
    while (taken > 0 && taken < count && !(all[taken].confidence < all[taken - 1].confidence))
        taken++;
    for (size_t i = 0; i < taken; i++)
        angles[i] = (struct hatch_weighted){all[i].degrees, 1};
    hatch_percentiles(angles, taken, shares, 4, out->degrees);
    for (size_t i = 0; i < taken; i++)
        angles[i] = (struct hatch_weighted){fmin(all[i].degrees, 90 - all[i].degrees), 1};
    hatch_percentiles(angles, taken, axis_shares, 2, out->axis_degrees);
    out->compared = taken;
    return HATCH_OK;
}

enum hatch_status hatch_measure_field_end(const struct hatch_field_sum *sum, double share,
                                          struct hatch_field_figures *figures, struct hatch_err *err)
{
    static const double quartiles[3] = {0.25, 0.5, 0.75}, upper[3] = {0.5, 0.75, 0.95};
    struct hatch_arena_mark mark = hatch_arena_mark(sum->scratch);
    struct hatch_field_figures made = sum->figures;
    assert(share > 0 && share <= 1);
    enum hatch_status status = rank(sum, CONFIDENCE, quartiles, made.confidence, err);
    if (status == HATCH_OK)
        status = rank(sum, UV, upper, made.uv_degrees, err);
    if (status == HATCH_OK)
        status = rank_angles(sum, share, &made, err);
    hatch_arena_rewind(sum->scratch, mark);
    if (status == HATCH_OK)
        *figures = made;
    return status;
}
