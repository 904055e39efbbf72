/* Derivatives with respect to texture coordinates, of faces whose affine maps are known. */
#include <math.h>

#include "fail_alloc.h"
#include "mesh/uv_tangents.h"
#include "meshes.h"

static struct hatch_mesh textured(const float *positions, const float *texcoords, uint32_t vertices,
                                  const uint32_t *indices, uint32_t faces)
{
    struct hatch_mesh mesh = mesh_of(positions, vertices, indices, faces);
    float *data;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &data, &err), &err);
    memcpy(data, texcoords, 2 * sizeof *data * vertices);
    return mesh;
}

/* Vertices 0 to 3 are those of two faces with a common edge. On the first, P = (2, 0, 0) u + (0, 3, 0) v; on the
 * second, P = (2, 0, 0) + (3, 1, 2) (u - 1) + (1, 4, 2) v. Vertex 4 is at the place of vertex 1, in a face whose
 * texture coordinates lie on a line. */
static struct hatch_mesh two_faces(void)
{
    static const float positions[] = {0, 0, 0, 2, 0, 0, 0, 3, 0, 6, 5, 4, 2, 0, 0, 2, 0, 9, 2, 9, 9};
    static const float texcoords[] = {0, 0, 1, 0, 0, 1, 2, 1, 1, 0, 5, 4, 9, 8};
    static const uint32_t faces[] = {0, 1, 2, 4, 5, 6, 1, 3, 2};
    return textured(positions, texcoords, 7, faces, 3);
}

START_TEST(tangents_are_means_over_faces_by_area)
{
    static const double maps[2][6] = {{2, 0, 0, 0, 3, 0}, {3, 1, 2, 1, 4, 2}};
    /* Twice the areas: that of the second is the length of (-6, -4, 11) for each of 2 units of texture coordinates. */
    const double areas[2] = {6, 2 * sqrt(36 + 16 + 121)};
    static const double shares[7][2] = {{1, 0}, {1, 1}, {1, 1}, {0, 1}, {1, 1}, {0, 0}, {0, 0}};
    struct hatch_mesh mesh = two_faces();
    struct hatch_arena_mark mark = hatch_arena_mark(&scratch);
    float *tangents;
    HATCH_TEST_OK(hatch_uv_tangents(&mesh, &scratch, &tangents, &err), &err);
    for (size_t v = 0; v < 7; v++) {
        double a = shares[v][0] * areas[0], b = shares[v][1] * areas[1];
        for (size_t k = 0; k < 6; k++) {
            double want = a + b > 0 ? (a * maps[0][k] + b * maps[1][k]) / (a + b) : 0;
            ck_assert_double_eq_tol((double)tangents[6 * v + k], want, 1e-6);
        }
    }
    hatch_arena_rewind(&scratch, mark);
}
END_TEST

/* Triangles with areas of 3 and 9 have 12 times as much area as their texture coordinates, which go to -5 or 7. */
START_TEST(the_reach_is_the_largest_coordinate_as_a_length)
{
    static const float positions[] = {0, 0, 0, 2, 0, 0, 2, 0, 3, 0, 0, 9}, texcoords[] = {6, -4, 7, -4, 7, -5, 6, -5};
    static const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
    struct hatch_mesh mesh = textured(positions, texcoords, 4, faces, 2);
    float *uv = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
    ck_assert_double_eq_tol(hatch_uv_reach(&mesh), 7 * sqrt(12), 1e-9);
    for (size_t v = 0; v < 4; v++)
        uv[2 * v] -= 6;
    ck_assert_double_eq_tol(hatch_uv_reach(&mesh), 5 * sqrt(12), 1e-9);
    for (size_t v = 0; v < 4; v++)
        uv[2 * v] = 0;
    ck_assert_double_eq(hatch_uv_reach(&mesh), 0);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    (void)temporary;
    struct hatch_mesh mesh = two_faces();
    return hatch_uv_tangents(&mesh, arena, context, error);
}

START_TEST(each_allocation_may_fail)
{
    float *tangents = NULL;
    hatch_test_fail_alloc(make, &tangents, &tangents, sizeof tangents);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh uv_tangents");
    TCase *tests = tcase_create("uv_tangents");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, tangents_are_means_over_faces_by_area);
    tcase_add_test(tests, the_reach_is_the_largest_coordinate_as_a_length);
    tcase_add_test(tests, each_allocation_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
