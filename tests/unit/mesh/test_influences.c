/* The joints that move a vertex, of one set and of several. */
#include <stdio.h>

#include "meshes.h"
#include "mesh/skin/influences.h"

/* Joint 5 is added twice; joints 2 and 9 weigh the same. */
START_TEST(weights_of_a_joint_are_summed_and_the_heaviest_come_first)
{
    static const float joints[] = {5, 2, 7, 9, 5, 4}, added[] = {0.25f, 0.375f, 0.5f, 0.375f, 0.5f, 0};
    static const float want_joints[] = {5, 7, 2, 9}, want_weights[] = {0.75f, 0.5f, 0.375f, 0.375f};
    float kept[HATCH_INFLUENCES], weights[HATCH_INFLUENCES];
    struct hatch_influences all = {.count = 0};
    for (int i = 0; i < 6; i++)
        hatch_influences_add(&all, joints[i], added[i]);
    ck_assert_uint_eq(all.count, 5);
    ck_assert(!hatch_influences_keep(&all, kept, weights)); /* joint 4 has no weight */
    ck_assert_mem_eq(kept, want_joints, sizeof kept);
    ck_assert_mem_eq(weights, want_weights, sizeof weights);
    hatch_influences_add(&all, 4, 0.125f);
    ck_assert(hatch_influences_keep(&all, kept, weights));
    ck_assert_mem_eq(kept, want_joints, sizeof kept);
}
END_TEST

/* Returns the joint of a place of a vertex: no two places have the same one. */
static float joint_at(uint32_t set, uint32_t vertex, uint32_t place)
{
    return (float)(100 * vertex + HATCH_INFLUENCES * set + place);
}

/* Makes a triangle of which place 0 of vertex 0 weighs 1 in each set, and the others nothing, but for place 3 of vertex
 * 2, which weighs 2 in each. */
static struct hatch_mesh with_sets(uint32_t sets)
{
    static const float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const uint32_t face[3] = {0, 1, 2};
    struct hatch_mesh mesh = mesh_of(positions, 3, face, 1);
    for (uint32_t set = 0; set < sets; set++) {
        char name[HATCH_MESH_NAME_MAX];
        float *joints, *weights;
        snprintf(name, sizeof name, "JOINTS_%u", set);
        HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, name, HATCH_INFLUENCES, &joints, &err), &err);
        snprintf(name, sizeof name, "WEIGHTS_%u", set);
        HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, name, HATCH_INFLUENCES, &weights, &err), &err);
        for (uint32_t i = 0; i < 3 * HATCH_INFLUENCES; i++)
            joints[i] = joint_at(set, i / HATCH_INFLUENCES, i % HATCH_INFLUENCES);
        weights[0] = 1;
        weights[3 * HATCH_INFLUENCES - 1] = 2;
    }
    return mesh;
}

/* Of as many equal joints as there are sets, the first four share the whole weight. Sets beyond the most that are read
 * stay as they are. */
START_TEST(all_sets_up_to_the_most_are_reduced_to_one)
{
    for (uint32_t sets = 1; sets <= HATCH_INFLUENCE_SETS + 1; sets++) {
        struct hatch_mesh mesh = with_sets(sets);
        uint32_t read = sets < HATCH_INFLUENCE_SETS ? sets : HATCH_INFLUENCE_SETS;
        ck_assert_uint_eq(hatch_mesh_keep_influences(&mesh), read > HATCH_INFLUENCES ? 2 : 0);
        ck_assert_uint_eq(mesh.attribute_count, 3 + 2 * (sets - read));
        ck_assert((hatch_mesh_attribute(&mesh, "JOINTS_8") != NULL) == (sets > HATCH_INFLUENCE_SETS));
        const float *joints = hatch_mesh_find(&mesh, "JOINTS_0", HATCH_INFLUENCES);
        const float *weights = hatch_mesh_find(&mesh, "WEIGHTS_0", HATCH_INFLUENCES);
        float share = read > HATCH_INFLUENCES ? (float)read / HATCH_INFLUENCES : 1;
        for (uint32_t i = 0; i < HATCH_INFLUENCES && read > 1; i++) {
            ck_assert_float_eq(joints[i], i < read ? joint_at(i, 0, 0) : 0);
            ck_assert_float_eq(weights[i], i < read ? share : 0);
            ck_assert_float_eq(joints[2 * HATCH_INFLUENCES + i], i < read ? joint_at(i, 2, 3) : 0);
            ck_assert_float_eq(weights[2 * HATCH_INFLUENCES + i], i < read ? 2 * share : 0);
            ck_assert_float_eq(joints[HATCH_INFLUENCES + i], joint_at(0, 1, i)); /* a vertex without weights */
            ck_assert_float_eq(weights[HATCH_INFLUENCES + i], 0);
        }
    }
}
END_TEST

/* A set is read only where both of its parts are there: joints without weights end the sets. */
START_TEST(half_a_set_stays)
{
    struct hatch_mesh mesh = with_sets(2);
    float *more;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "JOINTS_2", HATCH_INFLUENCES, &more, &err), &err);
    ck_assert_uint_eq(hatch_mesh_keep_influences(&mesh), 0);
    ck_assert_uint_eq(mesh.attribute_count, 4);
    ck_assert_ptr_eq(hatch_mesh_find(&mesh, "JOINTS_2", HATCH_INFLUENCES), more);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "JOINTS_0", HATCH_INFLUENCES)[1], joint_at(1, 0, 0));
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("mesh influences");
    TCase *tests = tcase_create("influences");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, weights_of_a_joint_are_summed_and_the_heaviest_come_first);
    tcase_add_test(tests, all_sets_up_to_the_most_are_reduced_to_one);
    tcase_add_test(tests, half_a_set_stays);
    suite_add_tcase(made, tests);
    return made;
}
HATCH_TEST_MAIN(suite)
