/* Splitting a hub, at which each face has a class of its own, takes as many steps per face among many faces as among
 * few. */
#include "fail_alloc.h"
#include "meshes.h"
#include "mesh/splits.h"
#include "steps.h"

/* Splits a fan into faces that share no vertex, and returns the steps per face. */
static double steps_a_face(uint32_t count)
{
    struct hatch_mesh mesh = fan(count);
    struct hatch_splits splits;
    uint32_t *class_of = HATCH_NEW(&keep, uint32_t, 3 * (size_t)count, &err);
    for (uint32_t i = 0; i < 3 * count; i++)
        class_of[i] = i / 3;
    steps = 0;
    HATCH_TEST_OK(hatch_splits_make(mesh.indices, class_of, 3 * (size_t)count, count + 1, &keep, &splits, &err), &err);
    double taken = (double)steps / count;
    ck_assert_uint_eq(splits.count, 3 * count);
    for (uint32_t i = 0; i < 3 * count; i++) {
        ck_assert_uint_eq(splits.class_at[splits.indices[i]], i / 3);
        ck_assert_uint_eq(splits.origin[splits.indices[i]], mesh.indices[i]);
    }
    return taken;
}

/* Measured: 39 steps per face of both; 2,018 and 40,018 if the copies are a list that is walked. Fewer than 10 would
 * mean that steps are not counted. */
START_TEST(a_hub_takes_as_many_steps_as_it_has_faces)
{
    double few = steps_a_face(1000), many = steps_a_face(20000);
    ck_assert_double_gt(few, 10);
    ck_assert_msg(many < 1.02 * few, "%g steps a face of 1,000, %g of 20,000", few, many);
}
END_TEST

/* Five corners at vertex 0, two at vertex 2, none at vertex 1. */
static const uint32_t vertex[] = {0, 0, 2, 0, 0, 2, 0}, class_of[] = {3, 1, 1, 3, 9, 1, 1};

START_TEST(copies_are_numbered_in_the_order_of_their_first_corners)
{
    static const uint32_t indices[] = {0, 3, 2, 0, 4, 2, 3}, origin[] = {0, 1, 2, 0, 0};
    static const uint32_t class_at[] = {3, HATCH_NO_CLASS, 1, 1, 9};
    struct hatch_splits splits;
    HATCH_TEST_OK(hatch_splits_make(vertex, class_of, 7, 3, &keep, &splits, &err), &err);
    ck_assert_uint_eq(splits.count, 5);
    ck_assert_mem_eq(splits.indices, indices, sizeof indices);
    ck_assert_mem_eq(splits.origin, origin, sizeof origin);
    ck_assert_mem_eq(splits.class_at, class_at, sizeof class_at);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    (void)temporary;
    return hatch_splits_make(vertex, class_of, 7, 3, kept, context, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_splits splits;
    memset(&splits, 0, sizeof splits);
    hatch_test_fail_alloc(make, &splits, &splits, sizeof splits);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh splits steps");
    TCase *tests = tcase_create("splits");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_hub_takes_as_many_steps_as_it_has_faces);
    tcase_add_test(tests, copies_are_numbered_in_the_order_of_their_first_corners);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
