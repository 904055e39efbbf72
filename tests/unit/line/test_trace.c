/* Silhouettes with a known closed form, and their independence of the storage of a mesh. */
#include <stdlib.h>

#include "fail_alloc.h"
#include "lines.h"

#define CREASE_RAD 0.7

/* From distance d the silhouette of the unit sphere is a circle of radius √(1 − 1/d²) in the plane
 * at 1/d from the centre. Edges of 2000 faces are 0.14 long at most: chords lie 2.5e-3 inside the sphere. */
static void check_sphere(const struct hatch_view *view, double height, double radius)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, 2000);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_line_trace trace = silhouettes_of(&shape, view);
    struct hatch_line_chains chains = chains_of(&trace);
    ck_assert_uint_eq(lines.feature_count, 0);
    ck_assert_uint_eq(chains.count, 1);
    ck_assert(chains.chains[0].closed);
    for (uint32_t i = 0; i < trace.node_count; i++) {
        const double *at = &trace.nodes[3 * i];
        double along = hatch_vec_dot(at, view->back);
        ck_assert_double_eq_tol(along, height, 4e-3);
        ck_assert_double_eq_tol(hatch_vec_length(at), 1, 1e-4);
    }
    ck_assert_double_eq_tol(length_of(&trace), 2 * 3.14159265358979 * radius, 6e-3);
}

START_TEST(the_silhouette_of_a_sphere_is_the_circle_of_tangents)
{
    struct hatch_view near = view_from(0.9, 1.0, 1.3, false), far = view_from(3, -2, 9, false);
    struct hatch_view parallel = view_from(3, -2, 1, true);
    double d = hatch_vec_length(near.eye);
    check_sphere(&near, 1 / d, sqrt(1 - 1 / (d * d)));
    d = hatch_vec_length(far.eye);
    check_sphere(&far, 1 / d, sqrt(1 - 1 / (d * d)));
    check_sphere(&parallel, 0, 1);
}
END_TEST

START_TEST(nothing_is_seen_of_a_sphere_from_its_inside)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, 500);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_view view = view_from(0.2, 0.1, 0.3, false);
    ck_assert_uint_eq(silhouettes_of(&shape, &view).segment_count, 0);
}
END_TEST

/* From a corner the outline of a cube is six of its edges, whether its normals are smooth, split or missing. */
START_TEST(the_silhouette_of_a_cube_runs_along_its_edges)
{
    for (int form = 0; form < 3; form++) {
        struct hatch_mesh mesh = cube(-1, 1);
        if (form == 1)
            HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &mesh, 0.0f, &err), &err);
        if (form == 2)
            HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &mesh, 0.5f, &err), &err);
        struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
        struct hatch_line_shape shape = shape_in_place(&lines);
        struct hatch_view view = view_from(5, 4, 6, false);
        struct hatch_line_trace trace = silhouettes_of(&shape, &view);
        struct hatch_line_chains chains = chains_of(&trace);
        ck_assert_uint_eq(trace.segment_count, 6);
        ck_assert_uint_eq(chains.count, 1);
        ck_assert(chains.chains[0].closed);
        ck_assert_double_eq_tol(length_of(&trace), 12, 1e-6);
    }
}
END_TEST

/* One half of a sphere has flat faces, the other one is smooth: the silhouette is one closed curve, along edges on one
 * half and across faces on the other. */
START_TEST(smooth_and_faceted_silhouettes_join)
{
    struct hatch_mesh whole = shape_of(HATCH_SHAPE_SPHERE, 2000), mesh = unwelded(&whole);
    float *normals = hatch_mesh_find(&mesh, "NORMAL", 3);
    for (uint32_t f = 0; f < mesh.face_count; f++) {
        double corners[3][3], normal[3];
        if (!hatch_mesh_corners(&mesh, f, corners) || corners[0][1] + corners[1][1] < 0)
            continue;
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        hatch_vec_normalize(normal);
        for (uint32_t c = 0; c < 3; c++)
            hatch_vec_round(normal, &normals[9 * f + 3 * c]);
    }
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_view view = view_from(1, 0.3, 4, false);
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    struct hatch_line_chains chains = chains_of(&trace);
    uint32_t closed = 0;
    for (uint32_t i = 0; i < chains.count; i++)
        closed += chains.chains[i].closed;
    ck_assert_uint_gt(lines.hard_edge_count, 400);
    ck_assert_uint_eq(closed, chains.count);
}
END_TEST

/* Returns the depth of a triangle along the view through a point in it, by clipping a line at its sides. */
static double depth_at(double p[3][3], const double at[3], const double back[3])
{
    double normal[3], line[3], reach[2] = {-INFINITY, INFINITY};
    hatch_vec_triangle(p[0], p[1], p[2], normal);
    hatch_vec_normalize(normal);
    hatch_vec_add_scaled(back, -hatch_vec_dot(back, normal), normal, line);
    for (int k = 0; k < 3; k++) {
        double side[3], inward[3], away[3];
        hatch_vec_sub(p[(k + 1) % 3], p[k], side);
        hatch_vec_cross(normal, side, inward);
        hatch_vec_sub(at, p[k], away);
        double rate = hatch_vec_dot(line, inward), s = -hatch_vec_dot(away, inward) / rate;
        if (rate > 0)
            reach[0] = fmax(reach[0], s);
        else
            reach[1] = fmin(reach[1], s);
    }
    return (reach[1] - reach[0]) * fabs(hatch_vec_dot(line, back));
}

/* A silhouette across a coarse face has half of the face's depth as slack, beside two pixels: the polygon lies that
 * much before or behind the smooth surface. The face's vertices are not the first ones of the mesh. */
START_TEST(a_silhouette_across_a_face_has_half_its_depth_as_slack)
{
    static const float positions[18] = {9,    9,    9,    9.1f, 9,    9,    9,    9.1f, 9,
                                        0.1f, 0.2f, 0.3f, 1.3f, 0.4f, 0.9f, 0.5f, 1.1f, -0.6f};
    static const float turned[9] = {0.3f, 0.1f, -0.9f, -0.4f, 0.3f, 0.8f, 0.2f, -0.3f, 0.9f};
    static const uint32_t indices[6] = {0, 1, 2, 3, 4, 5};
    struct hatch_mesh mesh = mesh_of(positions, 6, indices, 2);
    float *normals;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "NORMAL", 3, &normals, &err), &err);
    for (int i = 0; i < 18; i++)
        normals[i] = i < 9 ? (float)(i % 3 == 2) : turned[i - 9];
    struct hatch_view view = view_from(0.4, -0.2, 1, true);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    ck_assert_uint_eq(trace.segment_count, 1);
    double p[3][3], facing[3], at[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        double n[3];
        hatch_vec_of(&positions[9 + 3 * k], p[k]);
        hatch_vec_of(&turned[3 * k], n);
        facing[k] = hatch_vec_dot(n, view.back);
    }
    for (int k = 1; k < 3; k++) {
        double t = facing[0] / (facing[0] - facing[k]);
        hatch_vec_add_scaled(at, 0.5 * (1 - t), p[0], at);
        hatch_vec_add_scaled(at, 0.5 * t, p[k], at);
    }
    double depth = depth_at(p, at, view.back);
    ck_assert_double_gt(depth, 0.1);
    ck_assert_double_eq_tol((double)trace.slack[0], 0.5 * depth + 2 * view.half_height / 200, 1e-6);
}
END_TEST

static int by_place(const void *a, const void *b)
{
    return memcmp(a, b, 3 * sizeof(int64_t));
}

/* Returns the nodes' positions, rounded and sorted. */
static int64_t *sorted_nodes(const struct hatch_line_trace *trace)
{
    int64_t *places = HATCH_NEW(&keep, int64_t, 3 * (size_t)trace->node_count, &err);
    for (uint32_t i = 0; i < 3 * trace->node_count; i++)
        places[i] = llround(trace->nodes[i] * 1e4);
    qsort(places, trace->node_count, 3 * sizeof *places, by_place);
    return places;
}

/* Returns whether each position in a has an equal one in b, except for rounding. */
static bool same_places(const int64_t *a, const int64_t *b, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        bool found = false;
        for (uint32_t j = 0; j < count && !found; j++)
            found = llabs(a[3 * i] - b[3 * j]) <= 1 && llabs(a[3 * i + 1] - b[3 * j + 1]) <= 1 &&
                    llabs(a[3 * i + 2] - b[3 * j + 2]) <= 1;
        if (!found)
            return false;
    }
    return true;
}

START_TEST(shuffled_and_unwelded_meshes_have_the_same_silhouette)
{
    struct hatch_mesh plain = shape_of(HATCH_SHAPE_TEAPOT, 3000), apart = unwelded(&plain);
    struct hatch_mesh shuffled = plain;
    shuffled.indices = HATCH_NEW(&keep, uint32_t, 3 * (size_t)plain.face_count, &err);
    for (uint32_t f = 0; f < plain.face_count; f++)
        for (uint32_t c = 0; c < 3; c++)
            shuffled.indices[3 * ((f * 7919u) % plain.face_count) + c] = plain.indices[3 * f + (c + f) % 3];
    ck_assert_uint_ne(plain.face_count % 7919u, 0);
    const struct hatch_mesh *meshes[] = {&plain, &apart, &shuffled};
    struct hatch_view view = view_from(3, 2, 4, false);
    int64_t *places[3];
    uint32_t nodes = 0, segments = 0, features = 0;
    for (int i = 0; i < 3; i++) {
        struct hatch_line_mesh lines = lines_of(meshes[i], HATCH_LINES_ALL, CREASE_RAD);
        struct hatch_line_shape shape = shape_in_place(&lines);
        struct hatch_line_trace trace = silhouettes_of(&shape, &view);
        places[i] = sorted_nodes(&trace);
        if (i > 0) {
            ck_assert_uint_eq(trace.node_count, nodes);
            ck_assert_uint_eq(trace.segment_count, segments);
            ck_assert_uint_eq(lines.feature_count, features);
            ck_assert(same_places(places[0], places[i], nodes));
        }
        nodes = trace.node_count;
        segments = trace.segment_count;
        features = lines.feature_count;
    }
    ck_assert_uint_gt(nodes, 100);
}
END_TEST

/* A shape with a mirroring, stretching matrix has the silhouette of the transformed mesh. */
START_TEST(the_matrix_of_a_shape_is_applied)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, 2000);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    shape.mirrored = true;
    shape.to_unit[0] = -0.5;
    shape.to_unit[12] = 0.25;
    struct hatch_view view = view_from(0.25, 0, 7, true);
    view.back[0] = 0;
    hatch_view_set_back(&view, (const double[3]){0, 0, 1});
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    ck_assert_uint_gt(trace.node_count, 20);
    for (uint32_t i = 0; i < trace.node_count; i++) {
        double x = (trace.nodes[3 * i] - 0.25) / 0.5, y = trace.nodes[3 * i + 1];
        ck_assert_double_eq_tol(x * x + y * y, 1, 1e-3);
    }
    shape.to_unit[0] = 0;
    ck_assert_uint_eq(silhouettes_of(&shape, &view).segment_count, 0);
}
END_TEST

/* On a coarse sphere the nodes lie on the circle of tangents, the chords between them up to 0.01 inside; the curves lie
 * on the circle, too. */
START_TEST(curves_go_through_the_nodes)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, 300);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_view view = view_from(3, -2, 9, true);
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    struct hatch_line_chains chains = chains_of(&trace);
    uint32_t nodes = trace.node_count;
    double chords = length_of(&trace), length = 0;
    HATCH_TEST_OK(hatch_line_refine(&trace, &chains, &keep, &err), &err);
    ck_assert_uint_eq(chains.count, 1);
    ck_assert(chains.chains[0].closed);
    ck_assert_uint_gt(trace.node_count, 2 * nodes);
    ck_assert_uint_eq(chains.chains[0].segment_count, trace.node_count);
    for (uint32_t i = 0; i < trace.node_count; i++) {
        double along = hatch_vec_dot(&trace.nodes[3 * i], view.back);
        double square = hatch_vec_dot(&trace.nodes[3 * i], &trace.nodes[3 * i]);
        ck_assert_double_eq_tol(sqrt(square - along * along), 1, 4e-3);
        length += hatch_vec_distance(&trace.nodes[3 * chains.nodes[i]], &trace.nodes[3 * chains.nodes[i + 1]]);
    }
    ck_assert_double_gt(length, chords);
    ck_assert_double_eq_tol(length, 2 * 3.14159265358979, 0.05);
}
END_TEST

/* Every chord of a circle bends, so that the curves fill their arrays. */
START_TEST(all_chords_of_a_circle_become_curves)
{
    enum { COUNT = 24 };
    double at[3 * COUNT] = {0};
    float slack[COUNT] = {0};
    uint8_t smooth[COUNT];
    uint32_t nodes[COUNT + 1], segments[COUNT];
    for (uint32_t i = 0; i <= COUNT; i++) {
        nodes[i] = (i + 7) % COUNT;
        if (i == COUNT)
            continue;
        at[3 * i] = cos(2 * 3.14159265358979 * i / COUNT);
        at[3 * i + 1] = sin(2 * 3.14159265358979 * i / COUNT);
        smooth[i] = 1;
        segments[i] = i;
    }
    struct hatch_line_chain chain = {.segment_count = COUNT, .closed = true};
    struct hatch_line_chains chains = {1, &chain, nodes, segments};
    struct hatch_line_trace trace = {
        .node_count = COUNT, .segment_count = COUNT, .nodes = at, .slack = slack, .smooth = smooth};
    HATCH_TEST_OK(hatch_line_refine(&trace, &chains, &keep, &err), &err);
    ck_assert_uint_eq(trace.segment_count, 4 * COUNT);
    ck_assert_uint_eq(trace.node_count, 4 * COUNT);
    for (uint32_t i = 0; i < 4 * COUNT; i++) {
        ck_assert_double_eq_tol(hatch_vec_length(&trace.nodes[3 * i]), 1, 1e-4);
        ck_assert_uint_eq(chains.segments[i], i);
    }
    for (uint32_t i = 0; i <= COUNT; i++)
        ck_assert_uint_eq(chains.nodes[4 * i], (i + 7) % COUNT);
}
END_TEST

/* A rod of radius 1 along y with both ends chamfered: rings of ROD_SIDES vertices. */
#define ROD_SIDES 24u
#define ROD_RINGS 4u
static struct hatch_mesh chamfered_rod(void)
{
    static const float radius[ROD_RINGS] = {0.7f, 1, 1, 0.7f}, height[ROD_RINGS] = {-10, -9.7f, 9.7f, 10};
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, ROD_RINGS * ROD_SIDES, 2 * (ROD_RINGS - 1) * ROD_SIDES, &mesh, &err), &err);
    for (uint32_t v = 0; v < ROD_RINGS * ROD_SIDES; v++) {
        double angle = 2 * 3.14159265358979 * (v % ROD_SIDES) / ROD_SIDES;
        mesh.attributes[0].data[3 * v] = radius[v / ROD_SIDES] * (float)cos(angle);
        mesh.attributes[0].data[3 * v + 1] = height[v / ROD_SIDES];
        mesh.attributes[0].data[3 * v + 2] = -radius[v / ROD_SIDES] * (float)sin(angle);
    }
    for (uint32_t side = 0; side < (ROD_RINGS - 1) * ROD_SIDES; side++) {
        uint32_t a = side, b = side / ROD_SIDES * ROD_SIDES + (side + 1) % ROD_SIDES;
        const uint32_t faces[6] = {a, b, b + ROD_SIDES, a, b + ROD_SIDES, a + ROD_SIDES};
        memcpy(mesh.indices + 6 * side, faces, sizeof faces);
    }
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &mesh, 1.04f, &err), &err);
    return mesh;
}

/* The normals turn smoothly over the short chamfers; the long faces beside them stay straight. */
START_TEST(long_faces_beside_short_ones_stay_straight)
{
    struct hatch_mesh mesh = chamfered_rod();
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, 1.04);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_view view = view_from(6, 3, 8, true);
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    struct hatch_line_chains chains = chains_of(&trace);
    ck_assert_uint_gt(trace.node_count, 4);
    HATCH_TEST_OK(hatch_line_refine(&trace, &chains, &keep, &err), &err);
    for (uint32_t i = 0; i < trace.node_count; i++) {
        const double *at = &trace.nodes[3 * i];
        ck_assert_double_le(sqrt(at[0] * at[0] + at[2] * at[2]), 1.05);
    }
}
END_TEST

static enum hatch_status trace_all(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                   struct hatch_err *error)
{
    struct hatch_view view = view_from(3, 2, 4, false);
    const struct hatch_line_eye eye = {&view, 400};
    struct hatch_line_shape shape = shape_in_place(context);
    struct hatch_line_trace features;
    HATCH_TRY(hatch_line_trace_features(&shape, &eye, arena, &features, error));
    struct hatch_line_trace trace;
    struct hatch_line_chains chains;
    HATCH_TRY(hatch_line_trace_silhouettes(&shape, &eye, arena, temporary, &trace, error));
    const struct hatch_line_graph graph = {trace.node_count, trace.segment_count, trace.nodes, trace.ends};
    HATCH_TRY(hatch_line_chains_make(&graph, arena, temporary, &chains, error));
    return hatch_line_refine(&trace, &chains, arena, error);
}

START_TEST(tracing_survives_every_failed_allocation)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_TEAPOT, 600);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    ck_assert_uint_gt(hatch_test_fail_alloc(trace_all, &lines, NULL, 0), 8);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render lines trace");
    TCase *tests = tcase_create("silhouettes");
    tcase_add_checked_fixture(tests, begin, end_rewound);
    tcase_add_test(tests, the_silhouette_of_a_sphere_is_the_circle_of_tangents);
    tcase_add_test(tests, nothing_is_seen_of_a_sphere_from_its_inside);
    tcase_add_test(tests, the_silhouette_of_a_cube_runs_along_its_edges);
    tcase_add_test(tests, smooth_and_faceted_silhouettes_join);
    tcase_add_test(tests, a_silhouette_across_a_face_has_half_its_depth_as_slack);
    tcase_add_test(tests, shuffled_and_unwelded_meshes_have_the_same_silhouette);
    tcase_add_test(tests, the_matrix_of_a_shape_is_applied);
    tcase_add_test(tests, curves_go_through_the_nodes);
    tcase_add_test(tests, all_chords_of_a_circle_become_curves);
    tcase_add_test(tests, long_faces_beside_short_ones_stay_straight);
    tcase_add_test(tests, tracing_survives_every_failed_allocation);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
