/* Strokes traced on a mesh with a given field, and checks that hold for all of them. */
#ifndef HATCH_TEST_TRACE_MAKE_H
#define HATCH_TEST_TRACE_MAKE_H

#include "field_make.h"
#include "trace/trace.h"

static const float NO_TURN[1] = {0};
static const struct hatch_trace_options TRACE_DEFAULTS = {
    .family_count = 1, .angle_rad = NO_TURN, .gap = 0.25, .levels = 3, .length = 40, .hard_rad = 0.7, .seed = 1};

/* Makes a plane of 2 by 2 in x and y, facing +z, with the field along x. */
static inline struct field_case trace_plane(uint32_t faces, float jitter)
{
    struct field_case plane = case_of_shape(HATCH_SHAPE_PLANE, faces, jitter);
    set_direction(&plane, 1, 0, 0);
    return plane;
}

static inline double curve_length(const struct hatch_curves *curves, const struct hatch_curve *curve,
                                  const struct hatch_mesh *mesh)
{
    double length = 0, at[2][3];
    for (uint32_t i = 0; i < curve->count; i++) {
        float place[3];
        hatch_curve_position(mesh, &curves->points[curve->first + i], place);
        hatch_vec_of(place, at[i % 2]);
        length += i > 0 ? hatch_vec_distance(at[0], at[1]) : 0;
    }
    return length;
}

/* Returns the least threshold of a curve's points. */
static inline float curve_threshold(const struct hatch_curves *curves, const struct hatch_curve *curve)
{
    float least = curves->points[curve->first].threshold;
    for (uint32_t i = 1; i < curve->count; i++)
        least = fminf(least, curves->points[curve->first + i].threshold);
    return least;
}

/* Checks the order of sets, curves and points, and that no stroke is longer than it may be. */
static inline void check_strokes(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                 const struct hatch_trace_options *options)
{
    uint32_t curve = 0, point = 0;
    HATCH_TEST_OK(hatch_curves_check(curves, mesh, &err), &err);
    ck_assert_uint_eq(curves->set_count, options->family_count * options->levels);
    for (uint32_t s = 0; s < curves->set_count; s++) {
        const struct hatch_curve_set *set = &curves->sets[s];
        double gap = ldexp(options->gap, -(int)set->level);
        ck_assert_uint_eq(set->family, s / options->levels);
        ck_assert_uint_eq(set->level, s % options->levels);
        ck_assert_float_eq(set->angle_rad, options->angle_rad[set->family]);
        ck_assert_float_eq(set->gap, (float)gap);
        ck_assert_uint_eq(set->first, curve);
        float before = 0;
        for (; curve < set->first + set->count; curve++) {
            const struct hatch_curve *of = &curves->curves[curve];
            float least = curve_threshold(curves, of);
            double length = curve_length(curves, of, mesh);
            ck_assert_uint_eq(of->first, point);
            ck_assert_uint_ge(of->count, 2);
            ck_assert_msg(least >= before, "set %u: threshold %g after %g", s, (double)least, (double)before);
            ck_assert_msg(length <= (options->length + 2) * gap, "stroke %u is %g gaps long", curve, length / gap);
            before = least;
            point += of->count;
        }
    }
    ck_assert_uint_eq(curve, curves->count);
    ck_assert_uint_eq(point, curves->point_count);
}

static inline struct hatch_curves trace_with(const struct field_case *field, const struct hatch_trace_options *options,
                                             struct hatch_pool *pool)
{
    struct hatch_curves curves;
    HATCH_TEST_OK(hatch_trace_make(&field->surface, &field->mesh, &field->frames, field->direction, options, pool,
                                   &keep, &scratch, &curves, &err),
                  &err);
    check_strokes(&curves, &field->mesh, options);
    return curves;
}

/* The options with another gap and number of levels. */
static inline struct hatch_trace_options with_gap(double gap, uint32_t levels)
{
    struct hatch_trace_options options = TRACE_DEFAULTS;
    options.gap = gap;
    options.levels = levels;
    return options;
}

#endif
