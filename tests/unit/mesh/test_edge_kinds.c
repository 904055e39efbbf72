/* The kinds of edges of a mesh. */
#include "meshes.h"
#include "math/vector.h"
#include "mesh/edge_kinds.h"
#include "mesh/mesh.h"

/* Returns how many creases two triangles have that meet at an edge. Their planes rise by a slope, and the second by so
 * much more. */
static uint32_t count_creases(float slope, float more, double crease_rad)
{
    const float corners[12] = {0, 0, 0, 0.1f, 1, slope, -1, 0.5f, slope / 2, 1, 0.5f, slope / 2 + more};
    static const uint32_t indices[6] = {0, 1, 2, 1, 0, 3};
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 4, 2, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, corners, sizeof corners);
    memcpy(mesh.indices, indices, sizeof indices);
    const struct hatch_connectivity faces = {mesh.indices, 2, 4, NULL};
    struct hatch_edges edges;
    uint8_t kinds[5];
    uint32_t count = 0;
    HATCH_TEST_OK(hatch_edges_find(&faces, &keep, &keep, &edges, &err), &err);
    ck_assert_uint_eq(edges.count, 5);
    hatch_edges_classify(&mesh, &edges, crease_rad, kinds);
    for (uint32_t e = 0; e < 5; e++)
        count += kinds[e] == HATCH_EDGE_CREASE;
    return count;
}

/* An edge between faces of one plane is smooth at every angle, 0 too, however the plane is tilted. */
START_TEST(flat_edges_are_no_creases)
{
    for (uint32_t i = 0; i < 64; i++)
        ck_assert_msg(count_creases((float)i / 16, 0, 0) == 0, "slope %g", i / 16.0);
    ck_assert_uint_eq(count_creases(1, 0.001f, 0), 1);
}
END_TEST

/* Returns how many faces of a mesh are parts of planes. */
static uint32_t faces_in_planes(const struct hatch_mesh *mesh)
{
    const struct hatch_connectivity faces = {mesh->indices, mesh->face_count, mesh->vertex_count, NULL};
    struct hatch_edges edges;
    uint8_t in_plane[100];
    uint32_t count = 0;
    HATCH_TEST_OK(hatch_edges_find(&faces, &keep, &keep, &edges, &err), &err);
    hatch_edges_find_planes(mesh, &edges, in_plane);
    for (uint32_t f = 0; f < mesh->face_count; f++)
        count += in_plane[f];
    return count;
}

/* The octagons of a cube without corners are planes, and the triangles in place of its corners are single faces. */
START_TEST(planes_have_several_faces)
{
    struct hatch_mesh box = cube(-1, 1), clipped = clipped_cube(0.3f);
    ck_assert_uint_eq(faces_in_planes(&box), 12);
    ck_assert_uint_eq(faces_in_planes(&clipped), 36);
    for (int k = 0; k < 3; k++) /* a corner of three sides is moved */
        box.attributes[0].data[k] -= 0.1f;
    ck_assert_uint_eq(faces_in_planes(&box), 6);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh edge kinds");
    TCase *tests = tcase_create("edge kinds");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, flat_edges_are_no_creases);
    tcase_add_test(tests, planes_have_several_faces);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
