/* The order of seed faces, and the distances from covered faces, on a plane. */
#include "lapped_make.h"
#include "lapped/work.h"

struct order_case {
    struct field_case field;
    struct hatch_outline outline;
    struct hatch_patch_domain domain;
    struct hatch_order order;
    uint8_t *covered;
};

static void begin_order(struct order_case *made)
{
    made->field = case_of_shape(HATCH_SHAPE_PLANE, 2000, 1);
    set_direction(&made->field, 1, 0, 0);
    hatch_outline_make(3, 0.5, 0.05, &made->outline);
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    const struct hatch_lapped_input input = lapped_input(&made->field, &made->outline);
    options.size = 0.4;
    made->covered = HATCH_NEW(&keep, uint8_t, made->field.surface.face_count, &err);
    ck_assert_ptr_nonnull(made->covered);
    HATCH_TEST_OK(hatch_patch_domain_make(&input, &options, NULL, &keep, &scratch, &made->domain, &err), &err);
    HATCH_TEST_OK(hatch_order_make(&made->domain, &made->outline, made->covered, &keep, &made->order, &err), &err);
    hatch_order_start_component(&made->order, 0);
}

static double between(const struct order_case *of, uint32_t a, uint32_t b)
{
    return hatch_vec_distance(&of->order.middle[3 * (size_t)a], &of->order.middle[3 * (size_t)b]);
}

/* Covers the faces with a middle within a radius of a face's. Returns their number. */
static uint32_t cover_around(struct order_case *of, uint32_t face, double radius)
{
    uint32_t count = 0, faces[2000];
    for (uint32_t f = 0; f < of->field.surface.face_count; f++)
        if (!of->covered[f] && between(of, f, face) <= radius) {
            of->covered[f] = 1;
            faces[count++] = f;
        }
    HATCH_TEST_OK(hatch_order_add_covered(&of->order, faces, count, &err), &err);
    return count;
}

/* Checks that no way over a neighbour is shorter, and that one is as long. */
static void check_distances(const struct order_case *of)
{
    uint32_t finite = 0;
    for (uint32_t f = 0; f < of->field.surface.face_count; f++) {
        double least = HUGE_VAL, limit = 1.5 * of->order.core_ratio * of->domain.target_radius[f];
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t other = of->field.surface.opposite[3 * f + c];
            if (other != HATCH_NO_SIDE)
                least = fmin(least, of->order.distance[other / 3] + between(of, f, other / 3));
        }
        if (of->covered[f])
            ck_assert_double_eq(of->order.distance[f], 0);
        else if (least < limit)
            ck_assert_double_eq_tol(of->order.distance[f], least, 1e-9);
        else
            ck_assert(of->order.distance[f] > limit);
        finite += !of->covered[f] && least < limit;
    }
    ck_assert_uint_gt(finite, 100);
}

START_TEST(distances_are_those_of_the_shortest_ways)
{
    struct order_case of;
    begin_order(&of);
    for (uint32_t face = 100; face < 2000; face += 600) {
        ck_assert_uint_gt(cover_around(&of, face, 3), 0);
        check_distances(&of);
    }
}
END_TEST

START_TEST(the_smoothest_face_comes_first)
{
    struct order_case of;
    uint32_t face;
    begin_order(&of);
    ck_assert_uint_eq(of.order.smooth_count, of.field.surface.face_count);
    for (uint32_t f = 0; f < of.field.surface.face_count; f++)
        of.domain.turning_rate[f] = fabs((double)f - 700) * 1e-3;
    hatch_order_start_component(&of.order, 0);
    for (uint32_t i = 1; i < of.order.smooth_count; i++)
        ck_assert_double_ge(of.domain.turning_rate[of.order.smooth[i]], of.domain.turning_rate[of.order.smooth[i - 1]]);
    HATCH_TEST_OK(hatch_order_next(&of.order, &face, &err), &err);
    ck_assert_uint_eq(face, 700);
}
END_TEST

/* Distance of a face from covered ones in radii of the core. */
static double relative(const struct order_case *of, uint32_t face)
{
    return (of->order.distance[face] - of->domain.edge_length[face]) /
           (of->order.core_ratio * of->domain.target_radius[face]);
}

/* The next face is the one nearest to a distance of 0.73 radii, then the smoothest one; gaps end when all is covered.
 */
START_TEST(faces_at_the_best_distance_come_next)
{
    struct order_case of;
    uint32_t face, seeds = 0, left = 0;
    begin_order(&of);
    HATCH_TEST_OK(hatch_order_next(&of.order, &face, &err), &err);
    cover_around(&of, face, of.order.core_ratio * of.domain.target_radius[face]);
    double best = HUGE_VAL;
    for (uint32_t f = 0; f < of.field.surface.face_count; f++)
        if (!of.covered[f])
            best = fmin(best, fabs(relative(&of, f) - 0.73));
    HATCH_TEST_OK(hatch_order_next(&of.order, &face, &err), &err);
    ck_assert_double_eq_tol(fabs(relative(&of, face) - 0.73), best, 1e-12);
    while (face != HATCH_NO_SIDE) {
        ck_assert(!of.covered[face]);
        cover_around(&of, face, of.order.core_ratio * of.domain.target_radius[face]);
        seeds++;
        HATCH_TEST_OK(hatch_order_next(&of.order, &face, &err), &err);
    }
    for (uint32_t f = 0; f < of.field.surface.face_count; f++)
        left += !of.covered[f];
    ck_assert_uint_eq(left, 0);
    ck_assert_uint_gt(seeds, 5);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped order");
    TCase *tests = tcase_create("order");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, distances_are_those_of_the_shortest_ways);
    tcase_add_test(tests, the_smoothest_face_comes_first);
    tcase_add_test(tests, faces_at_the_best_distance_come_next);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
