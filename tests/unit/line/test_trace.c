/* Silhouettes with a known closed form, their independence of the storage of a mesh, and curves along them. */
#include <stdlib.h>

#include "fail_alloc.h"
#include "lines.h"

#define CREASE_RAD 0.7

/* From distance d the silhouette of the unit sphere is a circle in the plane at 1/d from the centre. That of the faces
 * consists of closed curves along edges, at most the length of an edge from it: 0.14. */
static void check_sphere(const struct hatch_view *view, double height)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, 2000);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_line_trace trace = silhouettes_of(&shape, view);
    struct hatch_line_chains chains = chains_of(&trace);
    ck_assert_uint_eq(lines.feature_count, 0);
    ck_assert_uint_ge(chains.count, 1);
    for (uint32_t i = 0; i < chains.count; i++)
        ck_assert(chains.chains[i].closed);
    for (uint32_t i = 0; i < trace.node_count; i++) {
        ck_assert_double_eq_tol(hatch_vec_dot(&trace.nodes[3 * i], view->back), height, 0.14);
        ck_assert_double_eq_tol(hatch_vec_length(&trace.nodes[3 * i]), 1, 1e-6);
    }
    ck_assert_double_ge(length_of(&trace), 6);
}

START_TEST(the_silhouette_of_a_sphere_is_near_the_circle_of_tangents)
{
    struct hatch_view near = view_from(0.9, 1.0, 1.3, false), far = view_from(3, -2, 9, false);
    struct hatch_view parallel = view_from(3, -2, 1, true);
    check_sphere(&near, 1 / hatch_vec_length(near.eye));
    check_sphere(&far, 1 / hatch_vec_length(far.eye));
    check_sphere(&parallel, 0);
}
END_TEST

/* An octahedron shows four of its faces from inside an octant; six of its twelve edges surround them. */
START_TEST(the_silhouette_of_an_octahedron_is_a_hexagon)
{
    static const float corners[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    static const uint32_t faces[24] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    struct hatch_mesh mesh = mesh_of(corners, 6, faces, 8);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_view view = view_from(5, 4, 6, true);
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    struct hatch_line_chains chains = chains_of(&trace);
    ck_assert_uint_eq(trace.segment_count, 6);
    ck_assert_uint_eq(chains.count, 1);
    ck_assert(chains.chains[0].closed);
    ck_assert_double_eq_tol(length_of(&trace), 6 * sqrt(2), 1e-6);
    for (uint32_t s = 0; s < 6; s++) { /* the surface is on the side of the middle */
        const double *a = &trace.nodes[3 * trace.ends[2 * s]], *b = &trace.nodes[3 * trace.ends[2 * s + 1]];
        double left[3];
        hatch_vec_cross(a, b, left);
        ck_assert_int_eq(trace.surface[s], hatch_vec_dot(left, view.back) > 0 ? 1 : -1);
    }
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

/* Along an axis, four sides of a cube are seen edge-on: the front has an outline, and so has the back if shown. */
START_TEST(the_back_of_a_cube_has_an_outline_if_it_is_drawn)
{
    struct hatch_mesh mesh = cube(-1, 1);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_view view = view_from(0, 0, 5, true);
    for (int double_sided = 0; double_sided < 2; double_sided++) {
        set_sides(&shape, double_sided);
        struct hatch_line_trace trace = silhouettes_of(&shape, &view);
        ck_assert_uint_eq(trace.segment_count, double_sided ? 8 : 4);
        for (uint32_t i = 0; i < trace.node_count && !double_sided; i++)
            ck_assert_double_eq(trace.nodes[3 * i + 2], 1);
    }
}
END_TEST

/* A side of the front has a corner of two smaller faces in its middle (a T-junction): the outline runs along both. */
START_TEST(the_silhouette_runs_along_a_crack)
{
    struct hatch_mesh box = cube(-1, 1), mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 9, 13, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, box.attributes[0].data, 24 * sizeof(float));
    memcpy(mesh.indices, box.indices, 36 * sizeof(uint32_t));
    uint32_t *first = mesh.indices, *added = mesh.indices + 36;
    for (int k = 0; k < 3; k++)
        mesh.attributes[0].data[24 + k] = 0.5f * (mesh.attributes[0].data[3 * first[0] + (uint32_t)k] +
                                                  mesh.attributes[0].data[3 * first[1] + (uint32_t)k]);
    added[0] = 8;
    added[1] = first[1];
    added[2] = first[2];
    first[1] = 8;
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    for (int i = 0; i < 8; i++) {
        struct hatch_view view = view_from(i & 1 ? 5 : -5, i & 2 ? 4 : -4, i & 4 ? 6 : -6, false);
        struct hatch_line_trace trace = silhouettes_of(&shape, &view);
        ck_assert_double_ge(length_of(&trace), 12 - 1e-6);
    }
}
END_TEST

/* Half of the faces are wound the other way. */
START_TEST(winding_matters_only_if_backs_are_hidden)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, 300), half = shape_of(HATCH_SHAPE_SADDLE, 200);
    struct hatch_line_mesh plain = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_view view = view_from(3, -2, 9, false), behind = view_from(4, 1, -4, false);
    struct hatch_line_shape shape = shape_in_place(&plain);
    double length = 0, found;
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    length = length_of(&trace);
    for (uint32_t f = 0; f < mesh.face_count; f += 2) {
        uint32_t swap = mesh.indices[3 * f];
        mesh.indices[3 * f] = mesh.indices[3 * f + 1];
        mesh.indices[3 * f + 1] = swap;
    }
    struct hatch_line_mesh turned = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    shape = shape_in_place(&turned);
    trace = silhouettes_of(&shape, &view);
    found = length_of(&trace);
    ck_assert_double_gt(length, 6);
    ck_assert_double_eq_tol(found, length, 1e-9);
    struct hatch_line_mesh open = lines_of(&half, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    shape = shape_in_place(&open);
    trace = silhouettes_of(&shape, &behind);
    uint32_t both = trace.segment_count;
    set_sides(&shape, false);
    ck_assert_uint_eq(silhouettes_of(&shape, &behind).segment_count, both); /* each has a front */
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
        ck_assert_double_eq_tol(x * x + y * y, 1, 0.02);
    }
    shape.to_unit[0] = 0;
    ck_assert_uint_eq(silhouettes_of(&shape, &view).segment_count, 0);
}
END_TEST

static struct hatch_line_trace features_of(const struct hatch_mesh *mesh, const struct hatch_view *view)
{
    const struct hatch_line_eye eye = {view, 400};
    struct hatch_line_mesh lines = lines_of(mesh, HATCH_LINES_ALL, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    struct hatch_line_trace trace;
    HATCH_TEST_OK(hatch_line_trace_features(&shape, &eye, &keep, &trace, &err), &err);
    return trace;
}

/* In an orthographic view slack follows from the slopes of faces alone. */
START_TEST(slack_of_an_edge_does_not_depend_on_the_size_of_faces)
{
    struct hatch_mesh small = cube(-0.25f, 0.25f), large = cube(-1, 1);
    struct hatch_view view = view_from(1, 2, 4, true);
    struct hatch_line_trace a = features_of(&small, &view), b = features_of(&large, &view);
    ck_assert_uint_ge(a.segment_count, 12);
    ck_assert_uint_eq(a.segment_count, b.segment_count);
    for (uint32_t i = 0; i < a.segment_count; i++)
        ck_assert_float_eq_tol(a.slack_px[i], b.slack_px[i], 1e-6f);
}
END_TEST

/* Makes a trace and its only chain, of points in the plane of a view of 400 pixels from -2 to 2. */
static void chain_through(const double (*places_px)[2], uint32_t count, struct hatch_line_trace *trace,
                          struct hatch_line_chains *chains)
{
    *trace = (struct hatch_line_trace){.node_count = count, .segment_count = count - 1};
    trace->nodes = HATCH_NEW(&keep, double, 3 * (size_t)count, &err);
    trace->ends = HATCH_NEW(&keep, uint32_t, 2 * (size_t)count, &err);
    trace->slack_px = HATCH_NEW(&keep, float, count, &err);
    trace->surface = HATCH_NEW(&keep, int8_t, count, &err);
    trace->fixed = HATCH_NEW(&keep, uint8_t, count, &err);
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < 2; k++) {
            trace->nodes[3 * i + k] = places_px[i][k] / 100;
            trace->ends[2 * i + k] = i + k;
        }
        trace->surface[i] = 1;
    }
    *chains = chains_of(trace);
}

static struct hatch_line_eye eye_above(struct hatch_view *view)
{
    *view = view_from(0, 0, 4, true);
    return (struct hatch_line_eye){view, 100};
}

/* Edges of 2 pixels that zigzag by 0.3 pixels to either side become straight. */
START_TEST(zigzags_below_a_pixel_become_straight)
{
    double places[41][2];
    struct hatch_line_trace trace;
    struct hatch_line_chains chains;
    struct hatch_view view;
    const struct hatch_line_eye eye = eye_above(&view);
    for (int i = 0; i < 41; i++) {
        places[i][0] = 2 * i - 40;
        places[i][1] = i % 2 ? 0.3 : -0.3;
    }
    chain_through((const double(*)[2])places, 41, &trace, &chains);
    HATCH_TEST_OK(hatch_line_refine(&eye, &trace, &chains, &keep, &err), &err);
    ck_assert_uint_ge(trace.node_count, 41);
    for (uint32_t i = 0; i < trace.node_count; i++)
        if (fabs(trace.nodes[3 * i]) < 0.3)
            ck_assert_double_le(fabs(trace.nodes[3 * i + 1]), 0.0006);
}
END_TEST

/* A right angle between long edges is cut off by half a pixel, and the edges stay straight. */
START_TEST(corners_stay_in_their_places)
{
    static const double places[3][2] = {{-80, 0}, {0, 0}, {0, 90}};
    struct hatch_line_trace trace;
    struct hatch_line_chains chains;
    struct hatch_view view;
    const struct hatch_line_eye eye = eye_above(&view);
    chain_through(places, 3, &trace, &chains);
    HATCH_TEST_OK(hatch_line_refine(&eye, &trace, &chains, &keep, &err), &err);
    ck_assert_uint_eq(trace.segment_count, 2);
    ck_assert_uint_eq(trace.node_count, 3);
    for (uint32_t i = 0; i < 3; i++)
        ck_assert_double_le(
            100 * hypot(trace.nodes[3 * i] - places[i][0] / 100, trace.nodes[3 * i + 1] - places[i][1] / 100),
            0.5 + 1e-9);
}
END_TEST

/* A polygon of 48 sides of 5.2 pixels becomes a circle: its corners lie on one of 40 pixels, and its sides up to 0.09
 * pixels inside. One of 12 sides of 41 pixels stays a polygon, whose sides bulge by half a pixel. */
START_TEST(short_sides_become_curves)
{
    static const int sides[2] = {48, 12};
    double places[50][2], inside[2] = {0, 0}, outside[2] = {0, 0};
    struct hatch_view view;
    const struct hatch_line_eye eye = eye_above(&view);
    for (int form = 0; form < 2; form++) {
        int count = sides[form] + 2;
        double radius = form ? 80 : 40;
        struct hatch_line_trace trace;
        struct hatch_line_chains chains;
        for (int i = 0; i < count; i++) {
            places[i][0] = radius * cos(2 * 3.14159265358979 * i / sides[form]);
            places[i][1] = radius * sin(2 * 3.14159265358979 * i / sides[form]);
        }
        chain_through((const double(*)[2])places, (uint32_t)count, &trace, &chains);
        HATCH_TEST_OK(hatch_line_refine(&eye, &trace, &chains, &keep, &err), &err);
        ck_assert_uint_gt(trace.node_count, 3 * (uint32_t)count);
        for (uint32_t i = 0; i < trace.segment_count; i++) {
            const double *a = &trace.nodes[3 * chains.nodes[i]], *b = &trace.nodes[3 * chains.nodes[i + 1]];
            double distance = 100 * hypot(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
            inside[form] = fmax(inside[form], radius - distance);
            outside[form] = fmax(outside[form], distance - radius);
        }
    }
    ck_assert_double_le(inside[0], 0.35); /* the window of the mean moves the curve inwards */
    ck_assert_double_le(outside[0], 0.02);
    ck_assert_double_ge(inside[1], 1.5);
    ck_assert_double_le(inside[1], 80 * (1 - cos(3.14159265358979 / 12)) + 0.5);
}
END_TEST

/* Every third segment is stored from its end to its start, with the surface on its other side. */
START_TEST(refined_segments_run_along_their_chain)
{
    double places[40][2];
    struct hatch_line_trace trace;
    struct hatch_line_chains chains;
    struct hatch_view view;
    const struct hatch_line_eye eye = eye_above(&view);
    for (int i = 0; i < 40; i++) {
        places[i][0] = 40 * cos(0.13 * i);
        places[i][1] = 40 * sin(0.13 * i);
    }
    chain_through((const double(*)[2])places, 40, &trace, &chains);
    for (uint32_t s = 0; s < 39; s += 3) {
        trace.ends[2 * s] = s + 1;
        trace.ends[2 * s + 1] = s;
        trace.surface[s] = -1;
    }
    chains = chains_of(&trace);
    HATCH_TEST_OK(hatch_line_refine(&eye, &trace, &chains, &keep, &err), &err);
    ck_assert_uint_gt(trace.segment_count, 100);
    ck_assert_uint_eq(chains.count, 1);
    for (uint32_t s = 0; s < trace.segment_count; s++) {
        const double *a = &trace.nodes[3 * chains.nodes[s]], *b = &trace.nodes[3 * chains.nodes[s + 1]];
        int left = a[0] * b[1] - a[1] * b[0] > 0 ? 1 : -1; /* the side on which the middle lies */
        ck_assert_int_eq(trace.surface[chains.segments[s]], left);
    }
}
END_TEST

/* All nodes of a closed chain lie in one place: those of a sphere that is as good as a point. */
START_TEST(chains_without_length_are_left_alone)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, 300);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&lines);
    for (int i = 0; i < 15; i += 5)
        shape.to_unit[i] = 1e-60;
    struct hatch_view view = view_from(3, -2, 9, true);
    const struct hatch_line_eye eye = {&view, 400};
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    struct hatch_line_chains chains = chains_of(&trace);
    ck_assert_uint_gt(trace.segment_count, 10);
    HATCH_TEST_OK(hatch_line_refine(&eye, &trace, &chains, &keep, &err), &err);
    for (uint32_t i = 0; i < trace.node_count; i++)
        ck_assert_double_le(hatch_vec_length(&trace.nodes[3 * i]), 1e-59);
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
    return hatch_line_refine(&eye, &trace, &chains, arena, error);
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
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_silhouette_of_a_sphere_is_near_the_circle_of_tangents);
    tcase_add_test(tests, the_silhouette_of_an_octahedron_is_a_hexagon);
    tcase_add_test(tests, nothing_is_seen_of_a_sphere_from_its_inside);
    tcase_add_test(tests, the_silhouette_of_a_cube_runs_along_its_edges);
    tcase_add_test(tests, the_back_of_a_cube_has_an_outline_if_it_is_drawn);
    tcase_add_test(tests, the_silhouette_runs_along_a_crack);
    tcase_add_test(tests, winding_matters_only_if_backs_are_hidden);
    tcase_add_test(tests, shuffled_and_unwelded_meshes_have_the_same_silhouette);
    tcase_add_test(tests, the_matrix_of_a_shape_is_applied);
    tcase_add_test(tests, slack_of_an_edge_does_not_depend_on_the_size_of_faces);
    tcase_add_test(tests, zigzags_below_a_pixel_become_straight);
    tcase_add_test(tests, corners_stay_in_their_places);
    tcase_add_test(tests, short_sides_become_curves);
    tcase_add_test(tests, refined_segments_run_along_their_chain);
    tcase_add_test(tests, chains_without_length_are_left_alone);
    tcase_add_test(tests, tracing_survives_every_failed_allocation);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
