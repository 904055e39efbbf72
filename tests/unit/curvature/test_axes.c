/* Directions that go on where the absolute values of the curvatures cross. */
#include "curvature_make.h"
#include "fail_alloc.h"

/* Counts the edges across which well-known directions turn by more than 45°. */
static uint32_t count_jumps(const struct field_case *of, const struct hatch_curvature *curvature)
{
    uint32_t count = 0;
    for (uint32_t p = 0; p < of->surface.point_count; p++)
        for (uint32_t i = of->surface.ring_first[p]; i < of->surface.ring_first[p + 1]; i++) {
            uint32_t q = of->surface.ring_point[i];
            double here = hatch_frames_angle(&of->frames, p, &curvature->direction[3 * (size_t)p]);
            double there = hatch_frames_angle(&of->frames, q, &curvature->direction[3 * (size_t)q]);
            bool known = curvature->confidence[p] > 0.5 && curvature->confidence[q] > 0.5;
            count += known && p < q && cos(2 * (here - there - of->frames.transport_rad[i])) < 0;
        }
    return count;
}

static void continue_axes(const struct field_case *of, struct hatch_curvature *curvature)
{
    HATCH_TEST_OK(hatch_curvature_continue_axes(&of->surface, &of->frames, &scratch, curvature, &err), &err);
}

static uint32_t count_swapped(const struct field_case *of, const struct hatch_curvature *curvature)
{
    uint32_t count = 0;
    for (size_t p = 0; p < of->surface.point_count; p++)
        count += fabs(curvature->value[2 * p]) < fabs(curvature->value[2 * p + 1]);
    return count;
}

START_TEST(minimal_surfaces_and_saddles_have_no_jump)
{
    const struct {
        enum hatch_shape shape;
        uint32_t jumps_min; /* before */
    } known[] = {{HATCH_SHAPE_CATENOID, 1000}, {HATCH_SHAPE_HELICOID, 1000}, {HATCH_SHAPE_SADDLE, 60}};
    for (int k = 0; k < 3; k++) {
        struct field_case of = case_with_truth(known[k].shape, 5000, 0);
        struct hatch_curvature found = estimate_case(&of, 0, 0);
        ck_assert_uint_gt(count_jumps(&of, &found), known[k].jumps_min);
        continue_axes(&of, &found);
        ck_assert_uint_eq(count_jumps(&of, &found), 0);
        for (size_t p = 0; p < of.surface.point_count; p++) {
            ck_assert_double_eq_tol(hatch_vec_length(&found.direction[3 * p]), 1, 1e-12);
            ck_assert_double_eq_tol(hatch_vec_dot(&found.direction[3 * p], &found.normal[3 * p]), 0, 1e-12);
        }
    }
}
END_TEST

/* Sets the first direction of a square to x on the left and to y on the right, each with these curvatures. */
static struct hatch_curvature halves(const struct field_case *of, double first, double second)
{
    struct hatch_curvature made = estimate_case(of, 0, 0);
    for (size_t p = 0; p < of->surface.point_count; p++) {
        double *direction = &made.direction[3 * p];
        bool left = of->surface.points[3 * p] < 0;
        direction[0] = left;
        direction[1] = !left;
        direction[2] = 0;
        made.value[2 * p] = first;
        made.value[2 * p + 1] = -second;
        made.confidence[p] = 1;
    }
    return made;
}

/* A jump through the middle of a square of side 2 has the length 2 and costs 2 * 0.15 * 2 = 0.6. A half has the area
 * 2, of which curvatures of 1 and s gain the share (1 - s) / (1 + s): 0.6 in all at s = 0.538. */
START_TEST(a_jump_stays_where_much_is_gained)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, 3000, 0);
    const double much = 0.48, little = 0.6;
    struct hatch_curvature kept = halves(&of, 1, much), lost = halves(&of, 1, little);
    ck_assert_uint_gt(count_jumps(&of, &kept), 30);
    continue_axes(&of, &kept);
    ck_assert_uint_gt(count_jumps(&of, &kept), 30);
    ck_assert_uint_eq(count_swapped(&of, &kept), 0);
    continue_axes(&of, &lost);
    ck_assert_uint_eq(count_jumps(&of, &lost), 0);
    double share = (double)count_swapped(&of, &lost) / of.surface.point_count;
    ck_assert_double_gt(share, 0.4);
    ck_assert_double_lt(share, 0.6);
}
END_TEST

/* Axes with a standard error of 0.1 are half known, and a jump between two of them costs a quarter: 0.15 in all, which
 * is gained at s = 0.86. */
START_TEST(a_jump_costs_less_where_little_is_known)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, 3000, 0);
    struct hatch_curvature known = halves(&of, 1, 0.77), unknown = halves(&of, 1, 0.77), equal = halves(&of, 1, 0.95);
    double odds = (HATCH_CURVATURE_HALF_CONFIDENCE_RAD / 0.1) * (HATCH_CURVATURE_HALF_CONFIDENCE_RAD / 0.1);
    for (uint32_t p = 0; p < of.surface.point_count; p++)
        if (fabs(of.surface.points[3 * (size_t)p]) < 2)
            unknown.confidence[p] = equal.confidence[p] = odds / (1 + odds);
    continue_axes(&of, &known);
    continue_axes(&of, &unknown);
    continue_axes(&of, &equal);
    double share = (double)count_swapped(&of, &known) / of.surface.point_count;
    ck_assert_double_gt(share, 0.4);
    ck_assert_uint_eq(count_swapped(&of, &unknown), 0);
    share = (double)count_swapped(&of, &equal) / of.surface.point_count;
    ck_assert_double_gt(share, 0.4);
}
END_TEST

/* Little is known along a tenth of the jump. The points there belong to one of the halves, which meet at the rest. */
START_TEST(points_where_little_is_known_do_not_join_both_sides_of_a_jump)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, 3000, 0);
    struct hatch_curvature found = halves(&of, 1, 0.7);
    uint32_t unknown = 0, jumps = count_jumps(&of, &found);
    double half = 0;
    for (uint32_t p = 0; p < of.surface.point_count; p++)
        half = fmax(half, of.surface.points[3 * (size_t)p]);
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        const double *at = &of.surface.points[3 * (size_t)p];
        bool here = fabs(at[0]) < 0.1 * half && fmax(fabs(at[1]), fabs(at[2])) < 0.1 * half;
        found.confidence[p] = here ? 0 : 1;
        unknown += here;
    }
    ck_assert_uint_gt(unknown, 4);
    ck_assert_uint_gt(count_jumps(&of, &found), jumps * 3 / 4);
    continue_axes(&of, &found);
    ck_assert_uint_eq(count_jumps(&of, &found), 0);
}
END_TEST

START_TEST(surfaces_without_jumps_stay_as_they_are)
{
    const enum hatch_shape shapes[] = {HATCH_SHAPE_TORUS, HATCH_SHAPE_CYLINDER, HATCH_SHAPE_ELLIPSOID,
                                       HATCH_SHAPE_SPHERE};
    for (int k = 0; k < 4; k++) {
        struct field_case of = case_with_truth(shapes[k], 3000, 0);
        struct hatch_curvature before = estimate_case(&of, 0, 0), after = estimate_case(&of, 0, 0);
        continue_axes(&of, &after);
        ck_assert_mem_eq(before.direction, after.direction, 3 * sizeof(double) * of.surface.point_count);
        ck_assert_mem_eq(before.value, after.value, 2 * sizeof(double) * of.surface.point_count);
    }
}
END_TEST

struct call {
    struct field_case of;
    struct hatch_curvature curvature;
};

static enum hatch_status run(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                             struct hatch_err *error)
{
    struct call *call = context;
    (void)kept;
    return hatch_curvature_continue_axes(&call->of.surface, &call->of.frames, temporary, &call->curvature, error);
}

START_TEST(failed_allocations_are_reported)
{
    struct call call = {.of = case_of_shape(HATCH_SHAPE_CATENOID, 300, 0)};
    call.curvature = estimate_case(&call.of, 0, 0);
    hatch_test_fail_alloc(run, &call, call.curvature.direction, 3 * sizeof(double) * call.of.surface.point_count);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("axes");
    TCase *tests = tcase_create("axes");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, minimal_surfaces_and_saddles_have_no_jump);
    tcase_add_test(tests, a_jump_stays_where_much_is_gained);
    tcase_add_test(tests, a_jump_costs_less_where_little_is_known);
    tcase_add_test(tests, points_where_little_is_known_do_not_join_both_sides_of_a_jump);
    tcase_add_test(tests, surfaces_without_jumps_stay_as_they_are);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
