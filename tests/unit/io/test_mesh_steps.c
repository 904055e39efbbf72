/* Triangulating polygons takes a bounded number of steps per corner. */
#include <math.h>

#include "arenas.h"
#include "io/mesh/polygon.h"
#include "steps.h"

/* Triangulates a polygon in the xy plane and returns the number of steps.
 *   visits  out: corners that ear clipping visits, all reflex corners for each candidate ear */
static uint64_t cut(void (*corner)(uint32_t i, uint32_t count, float *at), uint32_t count, uint64_t *visits)
{
    struct hatch_faces faces = hatch_faces_in(&keep);
    float *positions = HATCH_NEW(&keep, float, 3 * (size_t)count, &err);
    uint32_t *vertex = HATCH_NEW(&keep, uint32_t, count, &err);
    ck_assert(positions && vertex);
    for (uint32_t i = 0; i < count; i++) {
        corner(i, count, &positions[3 * (size_t)i]);
        vertex[i] = i;
    }
    uint64_t work_before = faces.steps_left;
    steps = 0;
    HATCH_TEST_OK(hatch_faces_add(&faces, positions, vertex, vertex, count, &err), &err);
    uint64_t taken = steps;
    ck_assert_uint_eq(faces.face_count, count - 2);
    *visits = work_before - faces.steps_left;
    return taken;
}

/* Convex, and exactly so in floats up to 4096 corners. */
static void on_parabola(uint32_t i, uint32_t count, float *at)
{
    (void)count;
    at[0] = (float)i;
    at[1] = (float)(i * i);
}

/* Every second corner is reflex. */
static void on_star(uint32_t i, uint32_t count, float *at)
{
    double angle = 2 * 3.14159265358979 * i / count, radius = i % 2 ? 1 : 2;
    at[0] = (float)(radius * cos(angle));
    at[1] = (float)(radius * sin(angle));
}

/* A circle with coordinates rounded to five digits, as in a file: nearly half of the corners are reflex. */
static void on_rounded_circle(uint32_t i, uint32_t count, float *at)
{
    double angle = 2 * 3.14159265358979 * i / count;
    at[0] = (float)(round(1e5 * cos(angle)) / 1e5);
    at[1] = (float)(round(1e5 * sin(angle)) / 1e5);
}

/* Measured: 48 steps per corner, 7 with clang. Fewer than one would mean that steps are not counted. */
START_TEST(a_convex_polygon_takes_as_many_steps_as_it_has_corners)
{
    uint64_t visits;
    double few = (double)cut(on_parabola, 500, &visits) / 500, many = (double)cut(on_parabola, 4000, &visits) / 4000;
    ck_assert_uint_eq(visits, 0);
    ck_assert_double_gt(few, 1);
    ck_assert_msg(many < 1.02 * few, "%g steps a corner of 500, %g of 4000", few, many);
}
END_TEST

/* Every tip is an ear at its first visit, and clipping it removes one reflex corner: on average a tip is tested against
 * half of the reflex corners, a quarter of all corners. Each of these tests takes the same few steps whatever the size
 * of the star: 10.8. */
START_TEST(a_star_is_cut_in_one_round)
{
    double a_look[2] = {0, 0};
    for (int large = 0; large < 2; large++) {
        const uint32_t count = large ? 4000 : 500;
        uint64_t visits, taken = cut(on_star, count, &visits);
        double looks = (double)visits / count;
        ck_assert_msg(looks < count / 4 + 4, "%g corners looked at for each of %u", looks, count);
        ck_assert_double_gt(looks, count / 4 - 4);
        a_look[large] = (double)taken / (double)visits;
    }
    ck_assert_msg(a_look[1] < 1.02 * a_look[0], "%g steps a look, %g in a large star", a_look[0], a_look[1]);
}
END_TEST

/* Measured: 1431 corners are visited for each; a star of as many corners has 1502. */
START_TEST(a_rounded_circle_is_cut_in_one_round)
{
    const uint32_t count = 6000;
    uint64_t visits;
    cut(on_rounded_circle, count, &visits);
    double looks = (double)visits / count;
    ck_assert_msg(looks < count / 4, "%g corners looked at for each", looks);
}
END_TEST

/* A polygon may take all the steps that are left, and no more. */
START_TEST(the_steps_that_are_left_suffice)
{
    enum { COUNT = 40 };
    float at[3 * COUNT] = {0};
    uint32_t vertex[COUNT];
    uint64_t visits;
    cut(on_star, COUNT, &visits);
    for (uint32_t i = 0; i < COUNT; i++) {
        on_star(i, COUNT, &at[3 * i]);
        vertex[i] = i;
    }
    for (uint64_t missing = 0; missing < 2; missing++) {
        struct hatch_faces faces = hatch_faces_in(&keep);
        faces.steps_left = visits - missing;
        ck_assert_int_eq(hatch_faces_add(&faces, at, vertex, vertex, COUNT, &err), missing ? HATCH_LIMIT : HATCH_OK);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io mesh steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_convex_polygon_takes_as_many_steps_as_it_has_corners);
    tcase_add_test(tests, a_star_is_cut_in_one_round);
    tcase_add_test(tests, a_rounded_circle_is_cut_in_one_round);
    tcase_add_test(tests, the_steps_that_are_left_suffice);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
