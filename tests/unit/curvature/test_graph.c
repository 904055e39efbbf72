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

/* Returns which side of a point of the finest graph a graph's node has outside; 0: the node does not hold the point. */
static int side_of(const struct hatch_curvature_graph *graph, uint32_t node, uint32_t point)
{
    if (!graph->points)
        return node == point;
    for (uint32_t i = graph->first[node]; i < graph->first[node + 1]; i++)
        if (graph->points[i] == point)
            return graph->sides[i];
    return 0;
}

/* A node lies at the mean of its points, with the mean of their normals. */
static void check_node(const struct hatch_curvature_graph *finest, const struct hatch_curvature_graph *coarse,
                       uint32_t node)
{
    uint32_t first = coarse->first[node], count = coarse->first[node + 1] - first;
    double middle[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
    ck_assert_double_eq(coarse->weights[node], count);
    for (uint32_t i = first; i < first + count; i++) {
        const double *own = &finest->normals[3 * (size_t)coarse->points[i]];
        hatch_vec_add_scaled(middle, 1.0 / count, &finest->surface.points[3 * (size_t)coarse->points[i]], middle);
        hatch_vec_add_scaled(normal, coarse->sides[i], own, normal);
        ck_assert_double_gt(coarse->sides[i] * hatch_vec_dot(own, &coarse->normals[3 * (size_t)node]), 0.7);
    }
    hatch_vec_normalize(normal);
    ck_assert_double_lt(hatch_vec_distance(middle, &coarse->surface.points[3 * (size_t)node]), 1e-12);
    ck_assert_double_lt(hatch_vec_distance(normal, &coarse->normals[3 * (size_t)node]), 1e-12);
}

/* A node has as its neighbours, each once, the parents of those of its own fine nodes. */
static void check_ring(const struct hatch_curvature_graph *fine, const struct hatch_curvature_graph *coarse,
                       uint32_t node, uint8_t *neighbours)
{
    const struct hatch_surface *ring = &coarse->surface, *below = &fine->surface;
    memset(neighbours, 0, ring->point_count);
    for (uint32_t p = 0; p < below->point_count; p++)
        for (uint32_t i = below->ring_first[p]; i < below->ring_first[p + 1] && coarse->parent[p] == node; i++)
            neighbours[coarse->parent[below->ring_point[i]]] = 1;
    neighbours[node] = 0;
    for (uint32_t i = ring->ring_first[node]; i < ring->ring_first[node + 1]; i++) {
        uint32_t q = ring->ring_point[i];
        double cosine = hatch_vec_dot(&coarse->normals[3 * (size_t)node], &coarse->normals[3 * (size_t)q]);
        ck_assert_uint_eq(neighbours[q]--, 1);
        ck_assert(ring->ring_turned[i] == (cosine < 0));
    }
    for (uint32_t q = 0; q < ring->point_count; q++)
        ck_assert_uint_eq(neighbours[q], 0);
}

/* A Möbius strip, halved three times, and a plane beside it. */
START_TEST(coarse_nodes_are_the_means_of_their_points)
{
    struct hatch_mesh strip = band(60, 5, true), plane = bare_shape(HATCH_SHAPE_PLANE, 300);
    move(&plane, 1, 9);
    struct field_case of = case_of(both(&strip, &plane));
    struct hatch_curvature_graph graphs[4], *finest = &graphs[0];
    uint8_t *neighbours = HATCH_NEW(&keep, uint8_t, of.surface.point_count, &err);
    HATCH_TEST_OK(hatch_curvature_graph_make(&of.surface, &of.frames, &keep, finest, &err), &err);
    for (int level = 1; level < 4; level++) {
        const struct hatch_curvature_graph *fine = &graphs[level - 1], *coarse = &graphs[level];
        HATCH_TEST_OK(hatch_curvature_graph_coarsen(finest, fine, &keep, &graphs[level], &err), &err);
        ck_assert_double_lt(coarse->surface.point_count, 0.6 * fine->surface.point_count);
        ck_assert_uint_ge(coarse->surface.point_count, fine->surface.point_count / 2);
        ck_assert_uint_eq(coarse->first[coarse->surface.point_count], of.surface.point_count);
        for (uint32_t n = 0; n < coarse->surface.point_count; n++) {
            check_node(finest, coarse, n);
            check_ring(fine, coarse, n, neighbours);
        }
        for (uint32_t p = 0; p < of.surface.point_count; p++)
            for (uint32_t n = 0; n < fine->surface.point_count; n++)
                if (side_of(fine, n, p) != 0) {
                    uint32_t parent = coarse->parent[n];
                    ck_assert_int_eq(side_of(coarse, parent, p), side_of(fine, n, p) * coarse->parent_side[n]);
                    ck_assert_uint_eq(coarse->surface.point_component[parent], fine->surface.point_component[n]);
                }
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("curvature graph");
    TCase *tests = tcase_create("graph");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_normal_that_a_sliver_turns_is_repaired);
    tcase_add_test(tests, normals_at_a_thin_edge_are_kept);
    tcase_add_test(tests, coarse_nodes_are_the_means_of_their_points);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
