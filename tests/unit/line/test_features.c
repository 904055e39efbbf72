/* Posed creases and boundaries: where they lie, and how far in front of them a surface may be without hiding them. */
#include "lines.h"

#define SLACK_PX 1.5

static struct hatch_line_trace features_of(const struct hatch_line_shape *shape, const struct hatch_view *view)
{
    const struct hatch_line_eye eye = {view, 100};
    struct hatch_line_trace trace;
    HATCH_TEST_OK(hatch_line_trace_features(shape, &eye, &keep, &trace, &err), &err);
    return trace;
}

/* Largest cosine between the view axis and the outward normals of the two faces of a cube's edge. */
static double flattest(const struct hatch_line_mesh *lines, const struct hatch_line_feature *feature,
                       const double back[3], double sign)
{
    double most = -1;
    for (int i = 0; i < 2; i++) {
        double middle[3] = {0, 0, 0};
        for (uint32_t c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++)
                middle[k] += (double)lines->mesh.attributes[0]
                                 .data[3 * lines->mesh.indices[3 * feature->faces[i] + c] + (uint32_t)k] /
                             3;
        for (int k = 0; k < 3; k++)
            if (fabs(middle[k]) > 0.99)
                most = fmax(most, sign * middle[k] * back[k]);
    }
    return most;
}

/* On each edge the face that is turned most towards the eye decides. Edges of faces that are all turned away are not
 * drawn, unless the faces have two sides. */
START_TEST(creases_of_a_cube_have_the_slope_of_their_flatter_face)
{
    struct hatch_mesh mesh = cube(-1, 1);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_CREASES, 0.7);
    struct hatch_view view = view_from(5, 4, 6, true);
    for (int turned = 0; turned < 2; turned++) {
        struct hatch_line_shape shape = shape_in_place(&lines);
        set_sides(&shape, false);
        shape.mirrored = turned;
        struct hatch_line_trace trace = features_of(&shape, &view);
        uint32_t drawn = 0;
        ck_assert_uint_eq(trace.segment_count, 12);
        for (uint32_t s = 0; s < 12; s++) {
            double cosine = flattest(&lines, &lines.features[s], view.back, turned ? -1 : 1);
            double slope = sqrt(1 - cosine * cosine) / cosine;
            ck_assert_double_eq_tol((double)trace.slack_px[s], cosine < 0 ? -1 : SLACK_PX * (1 + slope), 1e-4);
            drawn += trace.slack_px[s] >= 0;
        }
        ck_assert_uint_eq(drawn, 9);
        set_sides(&shape, true);
        trace = features_of(&shape, &view);
        for (uint32_t s = 0; s < 12; s++)
            ck_assert(trace.slack_px[s] > 0);
    }
}
END_TEST

/* No surface goes on beyond a boundary. Pixels grow with the distance from the eye. */
START_TEST(boundaries_have_the_size_of_a_pixel)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_PLANE, 8);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_BOUNDARIES, 0.7);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_view slant = view_from(1, 2, 2, true), near = view_from(0, 0, 4, false);
    struct hatch_line_trace trace = features_of(&shape, &slant);
    ck_assert_uint_gt(trace.segment_count, 3);
    for (uint32_t s = 0; s < trace.segment_count; s++)
        ck_assert_double_eq_tol((double)trace.slack_px[s], SLACK_PX, 1e-6);
    trace = features_of(&shape, &near);
    for (uint32_t s = 0; s < trace.segment_count; s++)
        ck_assert_double_eq_tol((double)trace.slack_px[s], SLACK_PX, 1e-6);
}
END_TEST

/* A quarter turn around z, twice the size, and a step along each axis. */
START_TEST(features_are_posed)
{
    struct hatch_mesh mesh = cube(-1, 1);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_CREASES, 0.7);
    struct hatch_line_shape shape = shape_in_place(&lines);
    const double to_unit[16] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 10, 20, 30, 1};
    memcpy(shape.to_unit, to_unit, sizeof to_unit);
    struct hatch_view view = view_from(5, 4, 6, true);
    struct hatch_line_trace trace = features_of(&shape, &view);
    ck_assert_uint_eq(trace.node_count, 8);
    for (uint32_t n = 0; n < trace.node_count; n++) {
        const float *from = &lines.mesh.attributes[0].data[3 * lines.node_vertices[n]];
        ck_assert_double_eq(trace.nodes[3 * n], 10 - 2 * (double)from[1]);
        ck_assert_double_eq(trace.nodes[3 * n + 1], 20 + 2 * (double)from[0]);
        ck_assert_double_eq(trace.nodes[3 * n + 2], 30 + 2 * (double)from[2]);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("line features");
    TCase *tests = tcase_create("features");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, creases_of_a_cube_have_the_slope_of_their_flatter_face);
    tcase_add_test(tests, boundaries_have_the_size_of_a_pixel);
    tcase_add_test(tests, features_are_posed);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
