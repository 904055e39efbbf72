/* Vertices at one position that joints or morph targets move apart, and faces that coincide at rest alone. */
#include "mesh/skin/motion.h"
#include "meshes.h"
#include "surface/surface.h"

#define VERTICES 8

/* Makes two squares that have four vertices each, the second beside the first, or upon it. */
static struct hatch_mesh two_squares(float aside)
{
    float positions[3 * VERTICES];
    static const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    static const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (size_t v = 0; v < VERTICES; v++) {
        positions[3 * v] = corners[v % 4][0] + (v < 4 ? 0 : aside);
        positions[3 * v + 1] = corners[v % 4][1];
        positions[3 * v + 2] = 0;
    }
    struct hatch_mesh mesh = mesh_of(positions, VERTICES, faces, 4);
    float *normals;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "NORMAL", 3, &normals, &err), &err);
    for (size_t v = 0; v < VERTICES; v++)
        normals[3 * v + 2] = 1;
    return mesh;
}

/* Adds joints: the squares follow a joint each, or both follow the same one. */
static void add_two_joints(struct hatch_mesh *mesh, bool apart)
{
    float *joints, *weights;
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, "JOINTS_0", 4, &joints, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, "WEIGHTS_0", 4, &weights, &err), &err);
    for (size_t v = 0; v < VERTICES; v++) {
        joints[4 * v] = apart && v >= 4 ? 3 : 2;
        weights[4 * v] = 1;
    }
}

/* Adds a morph target that moves the second square, or both. */
static void add_target(struct hatch_mesh *mesh, bool apart)
{
    float *moves;
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, HATCH_MORPH_POSITION, 3, &moves, &err), &err);
    for (size_t v = apart ? 4 : 0; v < VERTICES; v++)
        moves[3 * v + 2] = 0.125f;
}

static void add_motion(struct hatch_mesh *mesh, bool joints, bool apart)
{
    if (joints)
        add_two_joints(mesh, apart);
    else
        add_target(mesh, apart);
}

/* Joined at their common edge, the squares have 6 points; 8 if they come apart. */
START_TEST(vertices_that_come_apart_are_no_point)
{
    for (int apart = 0; apart < 2; apart++) {
        struct hatch_mesh mesh = two_squares(1);
        uint32_t point[VERTICES], count;
        struct hatch_remap remap;
        ck_assert(!hatch_mesh_moves(&mesh));
        HATCH_TEST_OK(hatch_mesh_weld_moving(&mesh, &scratch, point, &count, &err), &err);
        ck_assert_uint_eq(count, 6);
        add_motion(&mesh, _i, apart);
        ck_assert(hatch_mesh_moves(&mesh));
        HATCH_TEST_OK(hatch_mesh_weld_moving(&mesh, &scratch, point, &count, &err), &err);
        ck_assert_uint_eq(count, apart ? 8 : 6);
        ck_assert_int_eq(point[1] == point[4], !apart);
        HATCH_TEST_OK(hatch_mesh_remap_by_normal(&mesh, &keep, &scratch, &remap, &err), &err);
        ck_assert_uint_eq(remap.count, apart ? 8 : 6);
    }
}
END_TEST

/* A surface keeps the squares as components, also where the second lies upon the first at rest: its faces are given
 * twice only if they stay there. */
START_TEST(parts_that_come_apart_are_components)
{
    for (int aside = 0; aside < 2; aside++)
        for (int apart = 0; apart < 2; apart++) {
            struct hatch_mesh mesh = two_squares((float)aside);
            struct hatch_surface surface;
            struct hatch_surface_notes notes;
            add_motion(&mesh, _i, apart);
            HATCH_TEST_OK(hatch_surface_make(&mesh, &keep, &scratch, &surface, &notes, &err), &err);
            ck_assert_uint_eq(surface.component_count, apart ? 2 : 1);
            ck_assert_uint_eq(surface.face_count, apart || aside ? 4 : 2);
            ck_assert_uint_eq(notes.duplicate, apart || aside ? 0 : 2);
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("mesh motion");
    TCase *tests = tcase_create("motion");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, vertices_that_come_apart_are_no_point, 0, 2);
    tcase_add_loop_test(tests, parts_that_come_apart_are_components, 0, 2);
    suite_add_tcase(made, tests);
    return made;
}
HATCH_TEST_MAIN(suite)
