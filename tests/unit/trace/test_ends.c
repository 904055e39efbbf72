/* Ends of the ground, and the ways to them. */
#include "field_make.h"
#include "trace/ground.h"

static struct hatch_trace_ground lay_out(const struct field_case *field, double angle_rad, double hard_rad)
{
    struct hatch_trace_ground ground;
    HATCH_TEST_OK(hatch_trace_lay_out(&field->surface, &field->frames, field->direction, angle_rad, hard_rad, &keep,
                                      &ground, &err),
                  &err);
    return ground;
}

/* The end of a rectangle is its border. Ways along edges are as long as straight ones, or a little longer. */
START_TEST(ends_are_as_far_as_the_border)
{
    struct field_case plane = case_of_shape(HATCH_SHAPE_PLANE, 800, 0);
    struct hatch_trace_ground ground = lay_out(&plane, 0, PI);
    const double *points = plane.surface.points;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (uint32_t p = 0; p < plane.surface.point_count; p++)
        for (uint32_t k = 0; k < 2; k++) {
            low[k] = fmin(low[k], points[3 * p + k]);
            high[k] = fmax(high[k], points[3 * p + k]);
        }
    double length = 2 * (high[0] - low[0] + high[1] - low[1]), farthest = 0;
    for (uint32_t p = 0; p < plane.surface.point_count; p++) {
        const double *at = &points[3 * (size_t)p];
        double straight = fmin(fmin(at[0] - low[0], high[0] - at[0]), fmin(at[1] - low[1], high[1] - at[1]));
        double distance = (double)ground.ends[p].distance;
        ck_assert_double_ge(distance, straight - 1e-6);
        ck_assert_double_le(distance, 1.5 * straight + 1e-6);
        ck_assert_double_eq_tol((double)ground.ends[p].length, length - distance, 1e-5 * length);
        farthest = fmax(farthest, distance);
    }
    ck_assert_double_gt(farthest, length / 10);
    for (uint32_t f = 0; f < plane.surface.face_count; f++) {
        struct hatch_trace_end near = hatch_trace_end_near(&ground, f);
        struct hatch_trace_end wanted = {HUGE_VALF, 0};
        for (uint32_t c = 0; c < 3; c++) {
            const struct hatch_trace_end *end = &ground.ends[plane.surface.corners[3 * ground.source[f] + c]];
            wanted.distance = fminf(wanted.distance, end->distance);
            wanted.length = fmaxf(wanted.length, end->length);
        }
        ck_assert(near.distance == wanted.distance && near.length == wanted.length);
    }
}
END_TEST

/* Of the ends of a pyramid, each edge counts once. Around a ball there are none. */
START_TEST(hard_edges_are_ends)
{
    static const float corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const uint32_t indices[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    struct field_case pyramid = case_of(mesh_of(corners, 4, indices, 4));
    struct hatch_trace_ground ground = lay_out(&pyramid, 0, PI / 3);
    double edges = 0;
    for (uint32_t a = 0; a < 4; a++)
        for (uint32_t b = 0; b < a; b++)
            edges += hatch_vec_distance(&pyramid.surface.points[3 * (size_t)a], &pyramid.surface.points[3 * (size_t)b]);
    for (uint32_t p = 0; p < pyramid.surface.point_count; p++) {
        ck_assert_float_eq(ground.ends[p].distance, 0);
        ck_assert_double_eq_tol((double)ground.ends[p].length, edges, 1e-5 * edges);
    }
    struct field_case ball = case_of_shape(HATCH_SHAPE_SPHERE, 300, 0);
    ground = lay_out(&ball, 0, PI);
    for (uint32_t p = 0; p < ball.surface.point_count; p++) {
        ck_assert_float_eq(ground.ends[p].distance, HUGE_VALF);
        ck_assert_float_eq(ground.ends[p].length, 0);
    }
}
END_TEST

/* A lens with middles that are off the centre of its rim, a circle of radius 1: the rim alone is hard. Wherever on it
 * its points begin, the way to each middle is that from the nearest one. */
START_TEST(the_nearest_point_of_a_rim_counts)
{
    enum { RIM = 40, POINTS = RIM + 2 };
    for (int turn = 0; turn < 8; turn++) {
        float corners[3 * POINTS] = {0};
        uint32_t indices[6 * RIM];
        for (uint32_t i = 0; i < RIM; i++) {
            const double angle = 2 * PI * (i / (double)RIM + turn / 8.0);
            const uint32_t next = (i + 1) % RIM, faces[6] = {i, next, RIM, next, i, RIM + 1};
            corners[3 * i] = (float)(0.5 + cos(angle));
            corners[3 * i + 1] = (float)sin(angle);
            memcpy(&indices[6 * i], faces, sizeof faces);
        }
        corners[3 * RIM + 2] = 0.1f;
        corners[3 * RIM + 5] = -0.1f;
        struct field_case lens = case_of(mesh_of(corners, POINTS, indices, 2 * RIM));
        struct hatch_trace_ground ground = lay_out(&lens, 0, PI / 2);
        const double scale = lens.surface.components[0].scale, around = 2 * RIM * sin(PI / RIM);
        const double to_middle = hypot(0.5, 0.1), middle = -lens.surface.components[0].center[2] / scale;
        ck_assert_uint_eq(lens.surface.point_count, POINTS);
        uint32_t middles = 0;
        for (uint32_t p = 0; p < POINTS; p++) {
            const double *at = &lens.surface.points[3 * (size_t)p];
            const double distance = fabs(at[2] - middle) * scale > 0.05 ? to_middle : 0;
            middles += distance > 0;
            ck_assert_double_eq_tol((double)ground.ends[p].distance * scale, distance, 1e-5);
            ck_assert_double_eq_tol((double)ground.ends[p].length * scale, around - distance, 1e-5);
        }
        ck_assert_uint_eq(middles, 2);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace ends");
    TCase *tests = tcase_create("ends");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, ends_are_as_far_as_the_border);
    tcase_add_test(tests, hard_edges_are_ends);
    tcase_add_test(tests, the_nearest_point_of_a_rim_counts);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
