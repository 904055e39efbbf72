#include <math.h>
#include <string.h>

#include "arenas.h"
#include "base/random.h"
#include "math/point_tree.h"

enum { COUNT = 600, SEARCHES = 300 };

static double points[3 * COUNT];

struct search {
    const double *position;
    uint32_t visits;
};

static double distance_to(const void *context, uint32_t point)
{
    const struct search *search = context;
    const double *at = &points[3 * (size_t)point];
    return hypot(hypot(at[0] - search->position[0], at[1] - search->position[1]), at[2] - search->position[2]);
}

static double counted_distance_to(const void *context, uint32_t point)
{
    ((struct search *)(uintptr_t)context)->visits++;
    return distance_to(context, point);
}

/* Points of a box that is longest along one axis.
 *   steps  0, or how many different coordinates there are along each axis: many points are equal then */
static void scatter(int axis, uint32_t steps)
{
    for (uint32_t i = 0; i < COUNT; i++)
        for (uint32_t k = 0; k < 3; k++) {
            double at = (double)hatch_random_unit(1 + steps, k, i);
            points[3 * i + k] = (steps ? floor(at * steps) / steps : at) * ((int)k == axis ? 5 : 1);
        }
}

static uint32_t nearest_of_all(const struct search *search)
{
    uint32_t best = 0;
    for (uint32_t i = 1; i < COUNT; i++)
        if (distance_to(search, i) < distance_to(search, best))
            best = i;
    return best;
}

/* Positions inside and around the box, and points themselves. Of equally near points the first is found. Measured: 18
 * points are looked at, where all differ. */
START_TEST(the_nearest_of_all_points_is_found)
{
    static const uint32_t steps[] = {0, 3, 8};
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < 3; i++) {
            struct hatch_point_tree tree;
            uint32_t visits = 0;
            scatter(axis, steps[i]);
            HATCH_TEST_OK(hatch_point_tree_make(points, COUNT, &keep, &tree, &err), &err);
            for (uint32_t n = 0; n < SEARCHES; n++) {
                double position[3];
                for (uint32_t k = 0; k < 3; k++)
                    position[k] = n % 3 ? (1.2 * (double)hatch_random_unit(9, k, n) - 0.1) * ((int)k == axis ? 5 : 1)
                                        : points[3 * n + k];
                struct search search = {position, 0};
                ck_assert_uint_eq(hatch_point_tree_nearest(&tree, position, counted_distance_to, &search),
                                  nearest_of_all(&search));
                visits += search.visits;
            }
            ck_assert_uint_lt(steps[i] ? 0 : visits, 25 * SEARCHES);
        }
}
END_TEST

/* The point in the middle of a range divides it along its axis. */
static void check_range(const struct hatch_point_tree *tree, uint32_t first, uint32_t last)
{
    if (first == last)
        return;
    uint32_t middle = first + (last - first) / 2, axis = tree->axis[middle];
    double plane = points[3 * tree->items[middle].point + axis];
    for (uint32_t i = first; i < last; i++) {
        double at = points[3 * tree->items[i].point + axis];
        ck_assert(i < middle ? at <= plane : at >= plane);
    }
    check_range(tree, first, middle);
    check_range(tree, middle + 1, last);
}

START_TEST(the_middle_divides_a_range_along_its_longest_axis)
{
    for (int axis = 0; axis < 3; axis++) {
        struct hatch_point_tree tree;
        scatter(axis, 0);
        HATCH_TEST_OK(hatch_point_tree_make(points, COUNT, &keep, &tree, &err), &err);
        ck_assert_int_eq(tree.axis[COUNT / 2], axis);
        check_range(&tree, 0, COUNT);
    }
}
END_TEST

static double no_number(const void *context, uint32_t point)
{
    (void)context;
    (void)point;
    return NAN;
}

START_TEST(without_points_or_distances_there_is_none)
{
    static const double origin[3] = {0};
    struct hatch_point_tree tree;
    HATCH_TEST_OK(hatch_point_tree_make(points, 0, &keep, &tree, &err), &err);
    ck_assert_uint_eq(hatch_point_tree_nearest(&tree, origin, no_number, NULL), HATCH_POINT_NONE);
    HATCH_TEST_OK(hatch_point_tree_make(points, 5, &keep, &tree, &err), &err);
    ck_assert_uint_eq(hatch_point_tree_nearest(&tree, origin, no_number, NULL), HATCH_POINT_NONE);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("math point tree");
    TCase *tests = tcase_create("point tree");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_nearest_of_all_points_is_found);
    tcase_add_test(tests, the_middle_divides_a_range_along_its_longest_axis);
    tcase_add_test(tests, without_points_or_distances_there_is_none);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
