/* Joints, simplification, dashes, the pen's way and pages, on paths with a known result. */
#include <math.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "paths_made.h"
#include "vector/drawing.h"
#include "vector/tidy/tidy.h"

START_TEST(ends_that_meet_are_joined_the_straightest_first)
{
    struct hatch_vector_paths from, to;
    add_line(7, 0, 0, 10, 0);
    add_line(4, 20, 0.1, 10.1, 0); /* goes on straight, the other way round */
    add_line(5, 10, 0, 10, 10);    /* branches off */
    add_line(6, 50, 0, 60, 0);
    add_line(8, 60, 0.2, 60, 10);
    add_line(9, 60, 10, 50.1, 0);
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_join(&from, 0.3, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 3);
    ck_assert_uint_eq(to.paths[0].id, 4);
    ck_assert_uint_eq(to.paths[0].count, 4);
    ck_assert_uint_eq(to.paths[1].id, 5);
    ck_assert(to.paths[2].closed);
    ck_assert_uint_eq(to.paths[2].id, 6);
}
END_TEST

START_TEST(ends_that_are_too_far_apart_are_not_joined)
{
    struct hatch_vector_paths from, to;
    add_line(1, 0, 0, 10, 0);
    add_line(2, 10.4, 0, 20, 0);
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_join(&from, 0.3, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 2);
    HATCH_TEST_OK(hatch_vector_join(&from, 0.5, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 1);
}
END_TEST

static void check_alike(const struct hatch_vector_paths *a, const struct hatch_vector_paths *b)
{
    ck_assert_uint_eq(a->count, b->count);
    for (uint32_t i = 0; i < a->count; i++) {
        const struct hatch_vector_path *from = &a->paths[i], *to = &b->paths[i];
        ck_assert(from->id == to->id && from->count == to->count && from->closed == to->closed);
        for (uint32_t k = 0; k < from->count; k++)
            for (int c = 0; c < 2; c++)
                ck_assert_double_eq(hatch_vector_point(a, from, k)[c], hatch_vector_point(b, to, k)[c]);
    }
}

/* Triangles far apart, some of them open; appended to other paths, they are the same again. */
START_TEST(paths_that_meet_no_other_stay_as_they_are)
{
    struct hatch_vector_paths from, to;
    for (uint32_t i = 0; i < 7; i++) {
        const double corners[6] = {50.0 * i, 0, 50.0 * i + 9, 1, 50.0 * i + 3, 8};
        add(i, corners, 3, i % 3 == 1);
    }
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_join(&from, 0.3, &keep, &scratch, &to, &err), &err);
    check_alike(&from, &to);
    struct hatch_vector_builder other = hatch_vector_builder_of(&keep);
    HATCH_TEST_OK(hatch_vector_append(&other, &from, &err), &err);
    struct hatch_vector_paths copy = hatch_vector_built(&other);
    check_alike(&from, &copy);
}
END_TEST

START_TEST(paths_of_two_layers_are_not_joined)
{
    struct hatch_vector_paths from, to;
    add_line(1, 0, 0, 10, 0);
    add_line(2, 10, 0, 20, 0);
    from = hatch_vector_built(&builder);
    from.paths[1].layer = 1;
    HATCH_TEST_OK(hatch_vector_join(&from, 0.3, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 2);
}
END_TEST

START_TEST(short_paths_that_meet_no_other_are_dropped)
{
    add_line(1, 0, 0, 100, 0);
    add_line(2, 50, 1, 50, 4);                                 /* ends beside the first one */
    add_line(3, 50, 10, 53, 10);                               /* alone */
    add_line(4, 50, 20, 59, 20);                               /* alone, but long */
    add(5, (const double[]){50, 30, 51, 30, 51, 31}, 3, true); /* alone and closed */
    add(6, (const double[]){70, 1, 71, 2, 69, 2}, 3, true);    /* beside the first one */
    add(7, (const double[]){0, 60, 100, 60, 100, 90, 200, 90}, 4, false);
    add_line(8, 150, 91, 150, 94);                              /* beside the last part of that */
    add(9, (const double[]){50, 40, 51, 40, 51, 42}, 3, false); /* beside itself alone */
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_drop_specks(&paths, 8, 1.25, &scratch, &err), &err);
    static const uint32_t kept[] = {1, 2, 4, 6, 7, 8};
    ck_assert_uint_eq(paths.count, sizeof kept / sizeof *kept);
    for (uint32_t i = 0; i < paths.count; i++)
        ck_assert_uint_eq(paths.paths[i].id, kept[i]);
}
END_TEST

/* A circle of radius r needs points at most 2 arccos(1 - t / r) apart to stay within t; the result stays within t, and
 * has at most twice as many points. */
START_TEST(a_simplified_circle_stays_within_the_tolerance)
{
    double circle[2 * 1000], tolerance = 0.05, radius = 40;
    for (int i = 0; i < 1000; i++) {
        circle[2 * i] = radius * cos(2 * 3.14159265358979 * i / 1000);
        circle[2 * i + 1] = radius * sin(2 * 3.14159265358979 * i / 1000);
    }
    add(1, circle, 1000, true);
    add_line(2, 0, 0, 0.5, 0); /* too short */
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_simplify(&paths, tolerance, 1, &scratch, &err), &err);
    ck_assert_uint_eq(paths.count, 1);
    ck_assert(paths.paths[0].closed);
    double least = 3.14159265358979 / acos(1 - tolerance / radius);
    ck_assert_double_ge(paths.paths[0].count, least);
    ck_assert_double_le(paths.paths[0].count, 2 * least);
    for (uint32_t i = 0; i < paths.paths[0].count; i++) {
        const double *a = hatch_vector_point(&paths, paths.paths, i),
                     *b = hatch_vector_point(&paths, paths.paths, i + 1);
        ck_assert_double_ge(hypot(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])), radius - tolerance - 1e-3);
    }
}
END_TEST

START_TEST(dashes_begin_and_end_a_path)
{
    struct hatch_vector_paths from, to;
    add(1, (const double[]){0, 0, 10, 0, 10, 7}, 3, false);
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_dash(&from, 2, 1, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 6);
    ck_assert_double_eq_tol(total(&to), 12, 1e-9);
    ck_assert_double_eq_tol(hatch_vector_point(&to, &to.paths[5], to.paths[5].count - 1)[1], 7, 1e-9);
    builder = hatch_vector_builder_of(&keep);
    add(1, (const double[]){0, 0, 3, 0, 3, 3, 0, 3}, 4, true);
    add_line(2, 0, 0, 1.5, 0); /* shorter than a dash */
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_dash(&from, 2, 1, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 5);
    ck_assert_double_eq_tol(total(&to), 4 * 2 + 1.5, 1e-9);
}
END_TEST

/* Two dashes and a gap shrink to half on a path; on a shorter one there is a single dash. On a closed path, one dash
 * and one gap shrink. */
START_TEST(dashes_of_short_paths_are_shorter)
{
    struct hatch_vector_paths from, to;
    add_line(1, 0, 0, 2.5, 0);
    add_line(2, 0, 1, 2.4, 1);
    add(3, (const double[]){0, 2, 0.5, 2, 0.5, 2.25, 0, 2.25}, 4, true);
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_dash(&from, 2, 1, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 4);
    ck_assert_double_eq_tol(hatch_vector_length(&to, &to.paths[0]), 1, 1e-9);
    ck_assert_double_eq_tol(hatch_vector_point(&to, &to.paths[1], 0)[0], 1.5, 1e-9);
    ck_assert_double_eq_tol(hatch_vector_length(&to, &to.paths[2]), 2.4, 1e-9);
    ck_assert_double_eq_tol(hatch_vector_length(&to, &to.paths[3]), 1, 1e-9);
}
END_TEST

/* Two pens, whose paths alternate: each pen draws all its own, and the second begins where the first has ended. */
START_TEST(the_way_is_that_of_one_layer_after_the_other)
{
    double drawn, lifted;
    add_line(1, 0, 0, 1, 0);
    add_line(2, 0, 5, 1, 5);
    add_line(3, 3, 0, 4, 0);
    add_line(4, 3, 5, 4, 5);
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    paths.paths[0].layer = paths.paths[2].layer = 2;
    hatch_vector_ways(&paths, &drawn, &lifted);
    ck_assert_double_eq_tol(drawn, 4, 1e-12);
    ck_assert_double_eq_tol(lifted, 2 + hypot(4, 5) + 2, 1e-12);
}
END_TEST

/* The way that always going to the nearest end takes, computed directly. */
static double greedy_way(const struct hatch_vector_paths *paths)
{
    static bool done[1000];
    double way = 0, pen[2] = {0, 0};
    for (uint32_t n = 0; n < paths->count; n++) {
        double least = INFINITY;
        uint32_t best = 0, end = 0;
        for (uint32_t i = 0; i < 2 * paths->count; i++) {
            const struct hatch_vector_path *path = &paths->paths[i / 2];
            double distance = hatch_vector_distance(pen, hatch_vector_point(paths, path, i % 2 ? path->count - 1 : 0));
            if (!done[i / 2] && distance < least) {
                least = distance;
                best = i / 2;
                end = i % 2;
            }
        }
        const struct hatch_vector_path *path = &paths->paths[best];
        const double *at = hatch_vector_point(paths, path, end ? 0 : path->count - 1);
        done[best] = true;
        way += n ? least : 0;
        pen[0] = at[0];
        pen[1] = at[1];
    }
    return way;
}

START_TEST(the_sorted_way_is_no_longer_than_the_greedy_one)
{
    double drawn[3], lifted[3];
    for (uint32_t i = 0; i < 500; i++) {
        double x = 200 * (double)hatch_random_unit(1, 0, i), y = 200 * (double)hatch_random_unit(1, 1, i);
        add_line(i, x, y, x + 9 * (double)hatch_random_unit(1, 2, i), y + 9 * (double)hatch_random_unit(1, 3, i));
    }
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    double greedy = greedy_way(&paths);
    hatch_vector_ways(&paths, &drawn[0], &lifted[0]);
    HATCH_TEST_OK(hatch_vector_sort(&paths, HATCH_VECTOR_NEAREST, &scratch, &err), &err);
    hatch_vector_ways(&paths, &drawn[1], &lifted[1]);
    HATCH_TEST_OK(hatch_vector_sort(&paths, HATCH_VECTOR_IMPROVED, &scratch, &err), &err);
    hatch_vector_ways(&paths, &drawn[2], &lifted[2]);
    ck_assert_double_eq_tol(lifted[1], greedy, 1e-6);
    ck_assert_double_lt(lifted[2], 0.87 * greedy);
    uint64_t ids = 0;
    for (uint32_t i = 0; i < paths.count; i++)
        ids += paths.paths[i].id;
    ck_assert_uint_eq(ids, 500 * 499 / 2);
    for (int i = 1; i < 3; i++)
        ck_assert_double_eq_tol(drawn[i], drawn[0], 1e-6);
}
END_TEST

START_TEST(a_closed_path_begins_near_the_pen)
{
    add_line(1, 0, 0, 10, 0);
    add(2, (const double[]){20, 20, 11, 0, 0, 20}, 3, true);
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_sort(&paths, HATCH_VECTOR_IMPROVED, &scratch, &err), &err);
    ck_assert_uint_eq(paths.paths[1].id, 2);
    ck_assert_double_eq_tol(hatch_vector_point(&paths, &paths.paths[1], 0)[0], 11, 1e-12);
}
END_TEST

START_TEST(layers_stay_apart_in_the_order)
{
    for (uint32_t i = 0; i < 10; i++)
        add_line(i, i, 0, i + 0.5, 0);
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    for (uint32_t i = 0; i < 10; i++)
        paths.paths[i].layer = i % 2;
    HATCH_TEST_OK(hatch_vector_sort(&paths, HATCH_VECTOR_IMPROVED, &scratch, &err), &err);
    for (uint32_t i = 0; i < 10; i++)
        ck_assert_uint_eq(paths.paths[i].layer, i / 5);
}
END_TEST

START_TEST(nothing_stays_nothing)
{
    struct hatch_vector_paths paths = hatch_vector_built(&builder), to;
    HATCH_TEST_OK(hatch_vector_drop_doubles(&paths, NULL, 0.5, &keep, &scratch, &to, &err), &err);
    HATCH_TEST_OK(hatch_vector_join(&to, 0.5, &keep, &scratch, &paths, &err), &err);
    HATCH_TEST_OK(hatch_vector_drop_specks(&paths, 0.5, 1, &scratch, &err), &err);
    HATCH_TEST_OK(hatch_vector_simplify(&paths, 0.5, 1, &scratch, &err), &err);
    HATCH_TEST_OK(hatch_vector_dash(&paths, 2, 1, &keep, &scratch, &to, &err), &err);
    HATCH_TEST_OK(hatch_vector_sort(&to, HATCH_VECTOR_IMPROVED, &scratch, &err), &err);
    ck_assert_uint_eq(to.count, 0);
}
END_TEST

START_TEST(a_picture_fills_a_page_up_to_its_margins)
{
    struct hatch_page page = {.margin_mm = 10};
    ck_assert(hatch_page_find("a4", 4.0 / 3, &page));
    double pixel_mm = hatch_page_pixel_mm(&page, 400, 300);
    ck_assert_double_eq_tol(pixel_mm, 190.0 / 300, 1e-12);
    add_line(1, 0, 0, 400, 300);
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    hatch_page_place(&page, 400, 300, pixel_mm, &paths);
    ck_assert_double_eq_tol(paths.points[0], 0.5 * (297 - 400 * pixel_mm), 1e-9);
    ck_assert_double_eq_tol(paths.points[1], 200, 1e-9);
    ck_assert_double_eq_tol(paths.points[3], 10, 1e-9);
    ck_assert(hatch_page_find("120x80.5mm", 1, &page));
    ck_assert_double_eq_tol(page.height_mm, 80.5, 1e-12);
    static const char *const wrong[] = {"",     "a",     "a44",    "x",     "10x",    "x10",
                                        "0x10", "10x-1", "nanx10", "1e9x1", "10x10cm"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert(!hatch_page_find(wrong[i], 1, &page));
}
END_TEST

/* All steps on lines that cross, one that doubles another, and one that doubles itself. */
static enum hatch_status tidy_all(void *context, struct hatch_arena *to, struct hatch_arena *work,
                                  struct hatch_err *why)
{
    const struct hatch_vector_paths *from = context;
    struct hatch_vector_paths single, joined, dashes;
    HATCH_TRY(hatch_vector_drop_doubles(from, NULL, 0.5, to, work, &single, why));
    HATCH_TRY(hatch_vector_join(&single, 0.5, to, work, &joined, why));
    HATCH_TRY(hatch_vector_drop_specks(&joined, 1, 1, work, why));
    HATCH_TRY(hatch_vector_simplify(&joined, 0.05, 1, work, why));
    HATCH_TRY(hatch_vector_dash(&joined, 2, 1, to, work, &dashes, why));
    return hatch_vector_sort(&dashes, HATCH_VECTOR_IMPROVED, work, why);
}

START_TEST(every_failed_allocation_is_reported)
{
    add_line(1, 0, 0, 20, 0);
    add_line(2, 5, 0.1, 10, 0.1);
    add(3, (const double[]){5, 5, 9, 5, 9, 9}, 3, true);
    add(4, (const double[]){5, 15, 25, 15, 5, 15.1}, 3, false);
    struct hatch_vector_paths paths = hatch_vector_built(&builder);
    hatch_test_fail_alloc(tidy_all, &paths, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("vector tidy");
    TCase *tests = tcase_create("tidy");
    tcase_add_checked_fixture(tests, begin_paths, end);
    tcase_add_test(tests, ends_that_meet_are_joined_the_straightest_first);
    tcase_add_test(tests, ends_that_are_too_far_apart_are_not_joined);
    tcase_add_test(tests, paths_that_meet_no_other_stay_as_they_are);
    tcase_add_test(tests, paths_of_two_layers_are_not_joined);
    tcase_add_test(tests, short_paths_that_meet_no_other_are_dropped);
    tcase_add_test(tests, a_simplified_circle_stays_within_the_tolerance);
    tcase_add_test(tests, dashes_begin_and_end_a_path);
    tcase_add_test(tests, dashes_of_short_paths_are_shorter);
    tcase_add_test(tests, the_way_is_that_of_one_layer_after_the_other);
    tcase_add_test(tests, the_sorted_way_is_no_longer_than_the_greedy_one);
    tcase_add_test(tests, a_closed_path_begins_near_the_pen);
    tcase_add_test(tests, layers_stay_apart_in_the_order);
    tcase_add_test(tests, nothing_stays_nothing);
    tcase_add_test(tests, a_picture_fills_a_page_up_to_its_margins);
    tcase_add_test(tests, every_failed_allocation_is_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
