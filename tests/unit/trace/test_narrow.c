/* Narrow faces: which family crosses them, and how wide they are along it. */
#include "trace_make.h"

/* A rectangle of some columns in the plane z = 0, with the field along x, and the families of the strokes on it. */
static struct hatch_curves strokes_on(double length, double width, uint32_t columns, const float angle_rad[2],
                                      double gap)
{
    float *at = HATCH_NEW(&keep, float, 6 * ((size_t)columns + 1), &err);
    uint32_t *indices = HATCH_NEW(&keep, uint32_t, 6 * (size_t)columns, &err);
    for (uint32_t i = 0; i <= columns; i++) {
        at[6 * i] = at[6 * i + 3] = (float)(length * i / columns);
        at[6 * i + 4] = (float)width;
        const uint32_t next = 2 * i + 2, faces[6] = {2 * i, next, next + 1, next + 1, 2 * i + 1, 2 * i};
        if (i < columns)
            memcpy(&indices[6 * (size_t)i], faces, sizeof faces);
    }
    struct field_case strip = case_of(mesh_of(at, 2 * columns + 2, indices, 2 * columns));
    struct hatch_trace_options options = with_gap(gap, 4);
    options.family_count = 2;
    options.angle_rad = angle_rad;
    set_direction(&strip, 1, 0, 0);
    struct hatch_curves curves = trace_with(&strip, &options, NULL);
    ck_assert_uint_gt(curves.point_count, 30);
    return curves;
}

/* Checks that all points are on a narrow face; in corners it may be a tenth too narrow. */
static void all_narrow(const struct hatch_curves *curves, uint32_t across, double width)
{
    for (uint32_t i = 0; i < curves->point_count; i++) {
        double got = (double)curves->points[i].width;
        ck_assert_msg(got > 0.909 * width && got < 1.001 * width, "a width of %g for %g", got, width);
        ck_assert_uint_eq(curves->points[i].across, across);
    }
}

static void none_narrow(const struct hatch_curves *curves)
{
    for (uint32_t i = 0; i < curves->point_count; i++)
        ck_assert_float_eq(curves->points[i].width, 0);
}

START_TEST(a_strip_is_as_wide_as_its_crossing_strokes_are_long)
{
    static const struct {
        float angle_rad[2];
        uint32_t across;
        double width;
    } families[] = {
        {{0, (float)(PI / 2)}, 1, 1},
        {{0, (float)(PI / 3)}, 1, 1.154700538},
        {{(float)(PI / 2), (float)(PI / 3)}, 0, 1},
        {{(float)(PI / 3), (float)(PI / 2)}, 0, 1.154700538}, /* the second is not much shorter */
        {{(float)(PI / 6), (float)(PI / 2)}, 1, 1},
        {{(float)(PI / 4), (float)(-PI / 4)}, 0, 1.414213562},
    };
    for (size_t i = 0; i < sizeof families / sizeof *families; i++)
        for (uint32_t columns = 1; columns < 100; columns *= 8) {
            struct hatch_curves curves = strokes_on(12, 1, columns, families[i].angle_rad, 0.5);
            all_narrow(&curves, families[i].across, families[i].width);
        }
}
END_TEST

START_TEST(widths_are_in_mesh_units)
{
    static const float angle_rad[2] = {0, (float)(PI / 2)};
    struct hatch_curves curves = strokes_on(12e4, 1e4, 3, angle_rad, 0.5e4);
    all_narrow(&curves, 1, 1e4);
}
END_TEST

START_TEST(a_face_as_long_as_wide_is_not_narrow)
{
    static const float angle_rad[2] = {0, (float)(PI / 3)};
    for (uint32_t columns = 1; columns < 10; columns *= 5) {
        struct hatch_curves square = strokes_on(1, 1, columns, angle_rad, 0.2);
        none_narrow(&square);
        struct hatch_curves long_one = strokes_on(1, 2, columns, angle_rad, 0.2);
        none_narrow(&long_one);
    }
}
END_TEST

/* Widths are of interest up to 32 gaps of the stroke's level. */
START_TEST(a_wide_strip_is_narrow_for_coarse_strokes_only)
{
    static const float angle_rad[2] = {0, (float)(PI / 2)};
    struct hatch_curves curves = strokes_on(20, 3, 2, angle_rad, 0.5);
    for (uint32_t s = 0; s < curves.set_count; s++)
        for (uint32_t c = curves.sets[s].first; c < curves.sets[s].first + curves.sets[s].count; c++)
            for (uint32_t i = 0; i < curves.curves[c].count; i++) {
                float width = curves.points[curves.curves[c].first + i].width;
                if (curves.sets[s].level < 3)
                    ck_assert_float_gt(width, 2.7f);
                else /* all but corners, where the way across is shorter */
                    ck_assert_float_eq(width, 0);
            }
}
END_TEST

/* Around a tube of 1, strokes meet themselves: it is a narrow face if it is short, none if it is longer. */
START_TEST(a_tube_is_narrow_if_it_is_short)
{
    static const double heights[] = {0.25, 2};
    enum { COLUMNS = 24 };
    for (int k = 0; k < 2; k++) {
        float at[6 * COLUMNS], angle_rad[2] = {0, (float)(PI / 2)};
        uint32_t indices[6 * COLUMNS];
        for (uint32_t i = 0; i < COLUMNS; i++) {
            double angle = i * 2 * PI / COLUMNS, radius = 1 / (2 * COLUMNS * sin(PI / COLUMNS));
            const float ends[6] = {(float)(radius * cos(angle)), (float)(radius * sin(angle)), 0,
                                   (float)(radius * cos(angle)), (float)(radius * sin(angle)), (float)heights[k]};
            const uint32_t next = (2 * i + 2) % (2 * COLUMNS);
            const uint32_t faces[6] = {2 * i, next, next + 1, next + 1, 2 * i + 1, 2 * i};
            memcpy(&at[6 * (size_t)i], ends, sizeof ends);
            memcpy(&indices[6 * (size_t)i], faces, sizeof faces);
        }
        struct field_case tube = case_of(mesh_of(at, 2 * COLUMNS, indices, 2 * COLUMNS));
        struct hatch_trace_options options = with_gap(0.1, 4);
        options.family_count = 2;
        options.angle_rad = angle_rad;
        set_direction(&tube, 0, 0, 1);
        struct hatch_curves curves = trace_with(&tube, &options, NULL);
        if (k == 0)
            all_narrow(&curves, 0, heights[k]);
        else
            none_narrow(&curves);
    }
}
END_TEST

START_TEST(closed_surfaces_have_none)
{
    struct field_case ball = case_of_shape(HATCH_SHAPE_SPHERE, 2000, 0);
    struct hatch_trace_options options = with_gap(0.2, 3);
    set_direction(&ball, 0, 1, 0);
    struct hatch_curves curves = trace_with(&ball, &options, NULL);
    none_narrow(&curves);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("narrow");
    TCase *tests = tcase_create("narrow");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_strip_is_as_wide_as_its_crossing_strokes_are_long);
    tcase_add_test(tests, widths_are_in_mesh_units);
    tcase_add_test(tests, a_face_as_long_as_wide_is_not_narrow);
    tcase_add_test(tests, a_wide_strip_is_narrow_for_coarse_strokes_only);
    tcase_add_test(tests, a_tube_is_narrow_if_it_is_short);
    tcase_add_test(tests, closed_surfaces_have_none);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
