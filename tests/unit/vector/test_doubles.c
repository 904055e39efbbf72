/* Lines that are drawn once: those beside others, and parts of a line beside other parts of it. */
#include <math.h>

#include "base/random.h"
#include "paths_made.h"

START_TEST(a_line_beside_a_longer_one_is_dropped)
{
    struct hatch_vector_paths from, to;
    add_line(1, 10, 0.2, 60, 0.2);  /* beside the next one */
    add_line(2, 0, 0, 100, 0);      /* the longest */
    add_line(3, 90, 0.1, 130, 0.1); /* goes on for 30 beyond it */
    add_line(4, 50, -5, 50, 5);     /* crosses it */
    add_line(5, 0, 2, 99, 2);       /* is too far away */
    add_line(6, 10, 0.2, 60, 0.2);  /* is in another layer */
    from = hatch_vector_built(&builder);
    from.paths[5].layer = 1;
    HATCH_TEST_OK(hatch_vector_drop_doubles(&from, NULL, 0.5, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 5);
    ck_assert_uint_eq(to.paths[0].id, 2);
    ck_assert_double_eq_tol(total(&to), 100 + 99 + 30 + 10 + 50, 1e-9);
}
END_TEST

/* The closing side of a square, from its last corner to its first, counts as the other three do. */
START_TEST(no_line_runs_along_a_side_of_a_closed_path)
{
    struct hatch_vector_paths from, to;
    add(1, (const double[]){0, 0, 50, 0, 50, 50, 0, 50}, 4, true);
    add_line(2, 0.2, 10, 0.2, 40);
    add_line(3, 10, 0.2, 40, 0.2);
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_drop_doubles(&from, NULL, 0.5, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 1);
    ck_assert_double_eq_tol(total(&to), 200, 1e-9);
}
END_TEST

/* Paths that are drawn already are in another layer, and shorter than what runs along them. */
START_TEST(no_line_runs_along_what_is_drawn)
{
    struct hatch_vector_paths from, drawn, to;
    add_line(1, 10, 0, 40, 0);
    add(2, (const double[]){60, 0, 90, 0, 75, 30}, 3, true);
    drawn = hatch_vector_built(&builder);
    drawn.paths[0].layer = 5;
    builder = hatch_vector_builder_of(&keep);
    add_line(3, 0, 0.3, 100, 0.3);
    add_line(4, 60, 0.4, 75, 30.4); /* along the closing side */
    from = hatch_vector_built(&builder);
    from.paths[1].layer = 1;
    HATCH_TEST_OK(hatch_vector_drop_doubles(&from, &drawn, 0.5, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 3);
    ck_assert_double_eq_tol(total(&to), 10 + 20 + 10, 1e-9);
    for (uint32_t i = 0; i < to.count; i++)
        ck_assert_uint_eq(to.paths[i].id, 3);
}
END_TEST

/* The outline of a thin strip, and a line that turns back over itself: one side remains of each. */
START_TEST(a_path_that_runs_back_along_itself_is_drawn_once)
{
    struct hatch_vector_paths from, to;
    add(1, (const double[]){0, 0, 100, 0, 100, 0.3, 0, 0.3}, 4, true);
    add(2, (const double[]){20, 9, 0, 9, 100, 9}, 3, false);
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_drop_doubles(&from, NULL, 0.5, &keep, &scratch, &to, &err), &err);
    ck_assert_double_eq_tol(total(&to), 100 + 2 * 0.3 + 100, 1e-9);
    HATCH_TEST_OK(hatch_vector_join(&to, 0.5, &keep, &scratch, &from, &err), &err);
    ck_assert_uint_eq(from.count, 2);
    for (uint32_t i = 0; i < 2; i++)
        ck_assert(!from.paths[i].closed);
}
END_TEST

/* Appends a closed path along an ellipse, counterclockwise from a point of it. */
static void add_ellipse(uint32_t id, double x, double y, double wide, double high, double from_turn)
{
    enum { POINTS = 400 };
    double points[2 * POINTS];
    for (int i = 0; i < POINTS; i++) {
        double angle = 2 * 3.14159265358979 * (from_turn + (double)i / POINTS);
        points[2 * i] = x + 0.5 * wide * cos(angle);
        points[2 * i + 1] = y + 0.5 * high * sin(angle);
    }
    add(id, points, POINTS, true);
}

/* A flat ellipse becomes one line as long as it is, wherever its path begins: but for the turns at both of its ends,
 * which are less than eight times the reach apart along the path. */
START_TEST(a_flat_ellipse_is_one_line)
{
    for (int eighths = 0; eighths < 8; eighths++) {
        struct hatch_vector_paths from, to;
        builder = hatch_vector_builder_of(&keep);
        add_ellipse(1, 0, 0, 100, 0.4, eighths / 8.0);
        from = hatch_vector_built(&builder);
        HATCH_TEST_OK(hatch_vector_drop_doubles(&from, NULL, 0.5, &keep, &scratch, &to, &err), &err);
        ck_assert_double_ge(total(&to), 99);
        ck_assert_double_le(total(&to), 100 + 2 * 0.5 * 8 * 0.5);
        HATCH_TEST_OK(hatch_vector_join(&to, 1, &keep, &scratch, &from, &err), &err);
        ck_assert_uint_eq(from.count, 1);
        ck_assert(!from.paths[0].closed);
    }
}
END_TEST

/* Shapes whose sides are near each other at corners and bends alone, or that are no longer than a few reaches: circles
 * from half a reach to 200 reaches across, a star, a jagged line with the angles of a saw, steps, a wide strip, and a
 * hook, whose end is three reaches from the turn. */
START_TEST(corners_and_small_shapes_stay_whole)
{
    struct hatch_vector_paths from, to;
    double star[2 * 12], jagged[2 * 200], steps[2 * 50];
    for (int i = 0; i < 12; i++) {
        double radius = i % 2 ? 4 : 12, angle = 3.14159265358979 * i / 6;
        star[2 * i] = 100 + radius * cos(angle);
        star[2 * i + 1] = 100 + radius * sin(angle);
    }
    for (int i = 0; i < 200; i++) {
        jagged[2 * i] = 0.3 * i + 0.5 * (double)hatch_random_unit(5, 0, (uint32_t)i);
        jagged[2 * i + 1] = 200 + 0.5 * (double)hatch_random_unit(5, 1, (uint32_t)i);
    }
    for (int i = 0; i < 50; i++) {
        steps[2 * i] = 0.6 * (double)(i / 2);
        steps[2 * i + 1] = 300 + 0.6 * (double)((i + 1) / 2);
    }
    for (uint32_t i = 0; i < 10; i++)
        add_ellipse(i, 300 * i, 500, 0.25 * pow(2, i), 0.25 * pow(2, i), 0.1 * i);
    add(10, star, 12, true);
    add(11, jagged, 200, false);
    add(12, steps, 50, false);
    add(13, (const double[]){0, 400, 100, 400, 100, 400.6, 0, 400.6}, 4, true);
    add(14, (const double[]){0, 450, 40, 450, 0, 450 + 40 * tan(0.3)}, 3, false); /* a corner of 17 degrees */
    add(15, (const double[]){0, 600, 20, 600, 20, 600.3, 18.5, 600.3}, 4, false);
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_drop_doubles(&from, NULL, 0.5, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 16);
    for (uint32_t i = 0; i < to.count; i++) {
        const struct hatch_vector_path *path = &from.paths[to.paths[i].id];
        ck_assert(to.paths[i].closed == path->closed);
        ck_assert_double_eq_tol(hatch_vector_length(&to, &to.paths[i]), hatch_vector_length(&from, path), 1e-9);
    }
}
END_TEST

static double distance_from(const struct hatch_vector_paths *paths, const double at[2])
{
    double least = INFINITY;
    for (uint32_t i = 0; i < paths->count; i++)
        for (uint32_t k = 0; k < hatch_vector_segments(&paths->paths[i]); k++)
            least = fmin(least, hatch_vector_distance_to(at, hatch_vector_point(paths, &paths->paths[i], k),
                                                         hatch_vector_point(paths, &paths->paths[i], k + 1)));
    return least;
}

/* Wide arcs that turn back for a while, beside themselves by less than the reach, as silhouettes of meshes do. What
 * remains is hardly longer than the arcs. What is cut out has something beside it within two reaches, but for parts
 * shorter than one: no point is farther than three from what remains. */
START_TEST(a_line_with_folds_is_drawn_once_without_gaps)
{
    enum { LINES = 100, LEGS = 21, STEPS = 20, POINTS = LEGS * STEPS };
    const double reach = 0.5;
    double all = 0, least = 0, far = 0;
    for (uint32_t line = 0; line < LINES; line++) {
        struct hatch_vector_paths from, to;
        double points[2 * POINTS], along = 0, farthest = 0;
        for (uint32_t i = 0; i < POINTS; i++) {
            const uint32_t leg = i / STEPS;
            const double length = (leg % 2 ? -7 : 15) * (double)hatch_random_unit(line, 0, leg);
            const double radius = 90 + 0.6 * reach * (double)hatch_random_unit(line, 1, leg) +
                                  0.05 * reach * (double)hatch_random_unit(line, 2, i);
            along += length / STEPS;
            farthest = fmax(farthest, along);
            points[2 * (size_t)i] = radius * cos(along / radius);
            points[2 * (size_t)i + 1] = radius * sin(along / radius);
        }
        builder = hatch_vector_builder_of(&keep);
        add(1, points, POINTS, false);
        from = hatch_vector_built(&builder);
        HATCH_TEST_OK(hatch_vector_drop_doubles(&from, NULL, reach, &keep, &scratch, &to, &err), &err);
        for (uint32_t i = 0; i < POINTS; i++)
            far = fmax(far, distance_from(&to, points + 2 * (size_t)i));
        all += total(&to);
        least += farthest;
    }
    ck_assert_double_le(far, 3 * reach);
    ck_assert_double_le(all, 1.15 * least);
}
END_TEST

/* Lines in all directions, each with a copy beside it. */
START_TEST(every_double_is_found)
{
    struct hatch_vector_paths from, to;
    for (uint32_t i = 0; i < 300; i++) {
        double angle = 6.2831853 * (double)hatch_random_unit(3, 0, i), x = 20 * (i % 20), y = 20 * (double)(i / 20);
        double c = cos(angle), s = sin(angle), side = i % 2 ? 0.4 : -0.4;
        add_line(i, x, y, x + 9 * c, y + 9 * s);
        add_line(i + 300, x + c - side * s, y + s + side * c, x + 8 * c - side * s, y + 8 * s + side * c);
    }
    from = hatch_vector_built(&builder);
    HATCH_TEST_OK(hatch_vector_drop_doubles(&from, NULL, 0.5, &keep, &scratch, &to, &err), &err);
    ck_assert_uint_eq(to.count, 300);
    for (uint32_t i = 0; i < to.count; i++)
        ck_assert_uint_lt(to.paths[i].id, 300);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("vector doubles");
    TCase *tests = tcase_create("doubles");
    tcase_add_checked_fixture(tests, begin_paths, end);
    tcase_add_test(tests, a_line_beside_a_longer_one_is_dropped);
    tcase_add_test(tests, no_line_runs_along_a_side_of_a_closed_path);
    tcase_add_test(tests, no_line_runs_along_what_is_drawn);
    tcase_add_test(tests, a_path_that_runs_back_along_itself_is_drawn_once);
    tcase_add_test(tests, a_flat_ellipse_is_one_line);
    tcase_add_test(tests, corners_and_small_shapes_stay_whole);
    tcase_add_test(tests, a_line_with_folds_is_drawn_once_without_gaps);
    tcase_add_test(tests, every_double_is_found);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
