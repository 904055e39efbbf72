/* The surface as fits of curvatures see it. */
#include "curvature/work.h"
#include "field_make.h"

enum { SIDE = 7, MIDDLE = SIDE / 2 };

/* Makes a flat grid whose middle vertex noise has moved just over the side across from it: one of its faces is a
 * sliver, upside down and steep, with an angle of nearly 180 degrees there. */
static struct hatch_mesh grid_with_sliver(void)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, SIDE * SIDE, 2 * (SIDE - 1) * (SIDE - 1), &mesh, &err), &err);
    uint32_t *corner = mesh.indices;
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        float *at = &mesh.attributes[0].data[3 * i];
        at[0] = (float)(i % SIDE) - MIDDLE;
        at[1] = (float)(i / SIDE) - MIDDLE;
        if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1)
            continue;
        const uint32_t faces[6] = {i, i + 1, i + SIDE + 1, i, i + SIDE + 1, i + SIDE};
        memcpy(corner, faces, sizeof faces);
        corner += 6;
    }
    const float moved[3] = {1.02f, 0.5f, 0.02f};
    memcpy(&mesh.attributes[0].data[3 * (MIDDLE * SIDE + MIDDLE)], moved, sizeof moved);
    return mesh;
}

START_TEST(a_normal_that_a_sliver_turns_is_repaired)
{
    struct field_case of = case_of(grid_with_sliver());
    struct hatch_curvature_graph graph;
    HATCH_TEST_OK(hatch_curvature_graph_make(&of.surface, &of.frames, &keep, &graph, &err), &err);
    uint32_t turned = 0;
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        turned += of.frames.normal[3 * graph.order[p] + 2] < 0.7;
        ck_assert_double_gt(graph.normals[3 * p + 2], 0.7);
    }
    ck_assert_uint_ge(turned, 1);
}
END_TEST

/* The edge of a thin wedge, between an upper sheet and a lower one of half its width: the normal between their normals
 * is right, although the larger sheet outweighs the other. */
START_TEST(normals_at_a_thin_edge_are_kept)
{
    enum { LONG = 9 };
    struct hatch_mesh wedge;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3 * LONG, 4 * (LONG - 1), &wedge, &err), &err);
    for (uint32_t v = 0; v < 3 * LONG; v++) { /* of the upper sheet, the edge, the lower sheet */
        static const float x[3] = {-1, 0, -0.5f}, z[3] = {0.05f, 0, -0.025f};
        memcpy(&wedge.attributes[0].data[3 * v], (const float[]){x[v % 3], (float)(v / 3), z[v % 3]}, 12);
        if (v >= 3 * (LONG - 1) || v % 3 == 2)
            continue;
        const uint32_t faces[6] = {v, v + 1, v + 4, v, v + 4, v + 3};
        memcpy(&wedge.indices[6 * (size_t)(v / 3 * 2 + v % 3)], faces, sizeof faces);
    }
    struct field_case of = case_of(wedge);
    struct hatch_curvature_graph graph;
    HATCH_TEST_OK(hatch_curvature_graph_make(&of.surface, &of.frames, &keep, &graph, &err), &err);
    uint32_t edge = 0;
    for (uint32_t p = 0; p < of.surface.point_count; p++)
        edge += fabs(graph.normals[3 * p]) > 0.9;
    ck_assert_uint_ge(edge, LONG - 2); /* at its ends, faces of one sheet meet alone */
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("curvature graph");
    TCase *tests = tcase_create("graph");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_normal_that_a_sliver_turns_is_repaired);
    tcase_add_test(tests, normals_at_a_thin_edge_are_kept);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
