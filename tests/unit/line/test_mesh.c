/* Features of a mesh: creases and boundaries. */
#include "fail_alloc.h"
#include "lines.h"
#include "line/edges.h"

#define CREASE_RAD 0.7

static uint32_t closed_chains(const struct hatch_line_mesh *lines)
{
    uint32_t closed = 0;
    for (uint32_t i = 0; i < lines->chains.count; i++)
        closed += lines->chains.chains[i].closed;
    return closed;
}

START_TEST(a_cube_has_twelve_creases)
{
    struct hatch_mesh welded = cube(-1, 1), apart = unwelded(&welded);
    const struct hatch_mesh *meshes[] = {&welded, &apart};
    for (int i = 0; i < 2; i++) {
        ck_assert_uint_eq(lines_of(meshes[i], HATCH_LINES_CREASES, CREASE_RAD).feature_count, 12);
        ck_assert_uint_eq(lines_of(meshes[i], HATCH_LINES_BOUNDARIES, CREASE_RAD).feature_count, 0);
        ck_assert_uint_eq(lines_of(meshes[i], HATCH_LINES_CREASES, 1.6).feature_count, 0);
    }
}
END_TEST

/* The edges of a cube without corners end where nothing else is sharp enough, and have one segment each. */
START_TEST(edges_between_planes_are_creases)
{
    struct hatch_mesh mesh = clipped_cube(0.2f);
    ck_assert_uint_eq(lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD).feature_count, 36);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, 1);
    ck_assert_uint_eq(lines.feature_count, 12);
    ck_assert_uint_eq(lines.chains.count, 12);
}
END_TEST

START_TEST(the_winding_of_faces_does_not_matter)
{
    struct hatch_mesh mesh = cube(-1, 1);
    for (uint32_t f = 0; f < mesh.face_count; f += 3) {
        uint32_t swap = mesh.indices[3 * f];
        mesh.indices[3 * f] = mesh.indices[3 * f + 1];
        mesh.indices[3 * f + 1] = swap;
    }
    ck_assert_uint_eq(lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD).feature_count, 12);
}
END_TEST

START_TEST(boundaries_are_closed_chains)
{
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 200);
    struct hatch_mesh cylinder = shape_of(HATCH_SHAPE_CYLINDER, 800);
    struct hatch_mesh torus = shape_of(HATCH_SHAPE_TORUS, 800);
    struct hatch_line_mesh lines = lines_of(&plane, HATCH_LINES_ALL, CREASE_RAD);
    ck_assert_uint_eq(lines.feature_count, 40);
    ck_assert_uint_eq(lines.chains.count, 1);
    ck_assert_uint_eq(closed_chains(&lines), 1);
    lines = lines_of(&cylinder, HATCH_LINES_ALL, CREASE_RAD);
    ck_assert_uint_eq(lines.chains.count, 2);
    ck_assert_uint_eq(closed_chains(&lines), 2);
    ck_assert_uint_eq(lines_of(&torus, HATCH_LINES_ALL, CREASE_RAD).feature_count, 0);
}
END_TEST

/* A silhouette may run along every edge between two faces, in whatever order edges and boundaries are listed. */
START_TEST(all_edges_but_boundaries_may_turn)
{
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 200), box = cube(-1, 1);
    struct hatch_line_turns turns = lines_of(&plane, HATCH_LINES_ALL, CREASE_RAD).turns;
    ck_assert_uint_eq(turns.count, (3 * 200 - 40) / 2);
    for (uint32_t i = 0; i < turns.count; i++)
        ck_assert(turns.first[i + 1] == turns.first[i] + 2 && !turns.creases[i]);
    turns = lines_of(&box, HATCH_LINES_ALL, CREASE_RAD).turns;
    uint32_t creases = 0;
    for (uint32_t i = 0; i < turns.count; i++)
        creases += turns.creases[i];
    ck_assert_uint_eq(turns.count, 18);
    ck_assert_uint_eq(creases, 12);
}
END_TEST

/* Programs that write every face separately may round the same corner differently. */
START_TEST(corners_apart_by_rounding_are_one)
{
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_TORUS, 2000), apart = unwelded(&mesh);
    float *p = apart.attributes[0].data;
    for (uint32_t i = 0; i < 3 * apart.vertex_count; i++)
        p[i] += (float)(i * 7919u % 3u) * 1e-7f;
    ck_assert_uint_eq(lines_of(&apart, HATCH_LINES_ALL, CREASE_RAD).feature_count, 0);
}
END_TEST

/* Leaves are often modelled twice, once for each side. */
START_TEST(two_sheets_on_one_another_have_the_boundary_of_one)
{
    static const float corners[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const uint32_t faces[12] = {0, 1, 2, 0, 2, 3, 0, 2, 1, 0, 3, 2};
    struct hatch_mesh mesh = mesh_of(corners, 4, faces, 4);
    ck_assert_uint_eq(lines_of(&mesh, HATCH_LINES_BOUNDARIES, CREASE_RAD).feature_count, 4);
    ck_assert_uint_eq(lines_of(&mesh, HATCH_LINES_CREASES, CREASE_RAD).feature_count, 0);
}
END_TEST

START_TEST(three_sheets_meet_in_a_crease)
{
    static const float corners[15] = {0, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0, 0, 0, 1, 0};
    static const uint32_t faces[9] = {0, 1, 2, 0, 1, 3, 0, 1, 4};
    struct hatch_mesh mesh = mesh_of(corners, 5, faces, 3);
    ck_assert_uint_eq(lines_of(&mesh, HATCH_LINES_CREASES, CREASE_RAD).feature_count, 1);
    ck_assert_uint_eq(lines_of(&mesh, HATCH_LINES_BOUNDARIES, CREASE_RAD).feature_count, 6);
}
END_TEST

/* A corner of one face lies on the side of another (a T-junction): the gap between them has no area. */
START_TEST(a_crack_is_no_boundary)
{
    static const float corners[18] = {0, 0, 0, 3, 0, 0, 1, 1, 0, 1, -1, 0, 1, 0, 0, 2, 0, 0};
    static const uint32_t faces[12] = {0, 1, 2, 0, 3, 4, 4, 3, 5, 5, 3, 1};
    struct hatch_mesh mesh = mesh_of(corners, 6, faces, 4);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    ck_assert_uint_eq(lines.feature_count, 4);
    ck_assert_uint_eq(closed_chains(&lines), 1);
}
END_TEST

/* A quadrangle is stored as three overlapping triangles. */
START_TEST(an_edge_within_a_face_is_no_boundary)
{
    static const float corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    static const uint32_t faces[9] = {0, 1, 2, 1, 2, 3, 2, 3, 0};
    struct hatch_mesh mesh = mesh_of(corners, 4, faces, 3);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    ck_assert_uint_eq(lines.feature_count, 4);
    ck_assert_uint_eq(closed_chains(&lines), 1);
}
END_TEST

/* Noise folds single edges by more than the angle of a crease, which are removed; a fold across the plane is kept. */
START_TEST(creases_of_noise_are_removed)
{
    struct hatch_mesh rough =
        shape_with(HATCH_SHAPE_TORUS, (struct hatch_shape_options){.faces = 4000, .noise = 0.15f, .seed = 1});
    uint32_t point_count, over_angle = 0;
    uint32_t *point = HATCH_NEW(&keep, uint32_t, 12000, &err);
    uint32_t *of_vertex = HATCH_NEW(&keep, uint32_t, rough.vertex_count, &err);
    uint8_t *kinds = HATCH_NEW(&keep, uint8_t, 12000, &err);
    struct hatch_edges edges;
    HATCH_TEST_OK(hatch_mesh_weld(&rough, &scratch, of_vertex, &point_count, &err), &err);
    hatch_mesh_corner_points(&rough, of_vertex, point);
    const struct hatch_connectivity faces = {point, rough.face_count, point_count, NULL};
    HATCH_TEST_OK(hatch_edges_find(&faces, &keep, &scratch, &edges, &err), &err);
    hatch_edges_classify(&rough, &edges, CREASE_RAD, kinds);
    for (uint32_t e = 0; e < edges.count; e++)
        over_angle += kinds[e] == HATCH_EDGE_CREASE;
    ck_assert_uint_gt(over_angle, 20);
    ck_assert_uint_le(lines_of(&rough, HATCH_LINES_CREASES, CREASE_RAD).feature_count, over_angle / 10);

    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_PLANE, 800);
    mesh.attribute_count = 1;
    float *p = mesh.attributes[0].data;
    for (uint32_t v = 0; v < mesh.vertex_count; v++)
        p[3 * v + 2] = fabsf(p[3 * v]);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_CREASES, CREASE_RAD);
    ck_assert_uint_eq(lines.feature_count, 20);
    ck_assert_uint_eq(lines.chains.count, 1);
}
END_TEST

/* A coarse torus turns by more than the angle at every edge. With authored smooth normals it has no creases, while a
 * cube still has its twelve. */
START_TEST(authored_normals_decide_on_creases)
{
    static const double origin[3] = {0, 0, 0};
    const struct hatch_line_choice choice = {HATCH_LINES_CREASES, CREASE_RAD, true};
    struct hatch_mesh torus = shape_of(HATCH_SHAPE_TORUS, 300), box = cube(-1, 1);
    struct hatch_line_mesh lines;
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &box, 0.0f, &err), &err);
    ck_assert_uint_gt(lines_of(&torus, HATCH_LINES_CREASES, CREASE_RAD).feature_count, 20);
    HATCH_TEST_OK(hatch_line_mesh_make(&torus, NULL, origin, &choice, &keep, &scratch, &lines, &err), &err);
    ck_assert_uint_eq(lines.feature_count, 0);
    HATCH_TEST_OK(hatch_line_mesh_make(&box, NULL, origin, &choice, &keep, &scratch, &lines, &err), &err);
    ck_assert_uint_eq(lines.feature_count, 12);
}
END_TEST

START_TEST(scale_and_place_do_not_matter)
{
    const float scales[] = {1e-20f, 1e-3f, 1e15f};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        struct hatch_mesh mesh = cube(-1, 1);
        for (uint32_t k = 0; k < 24; k++)
            mesh.attributes[0].data[k] *= scales[i];
        ck_assert_uint_eq(lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD).feature_count, 12);
    }
}
END_TEST

START_TEST(faces_without_area_are_no_lines)
{
    static const float corners[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0.5f, 0.5f, 0};
    static const uint32_t faces[15] = {0, 1, 4, 0, 4, 2, 1, 3, 2, 1, 2, 4, 3, 3, 1};
    struct hatch_mesh mesh = mesh_of(corners, 5, faces, 5);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, CREASE_RAD);
    ck_assert_uint_eq(lines.feature_count, 4);
    ck_assert_uint_eq(closed_chains(&lines), 1);
}
END_TEST

/* Returns the number of creases and boundaries of a mesh that skins or morph targets move. */
static uint32_t deformed_features(const struct hatch_mesh *mesh)
{
    static const double origin[3] = {0, 0, 0};
    const struct hatch_line_choice choice = {HATCH_LINES_ALL, CREASE_RAD, false};
    struct hatch_line_edges edges;
    struct hatch_line_mesh lines;
    HATCH_TEST_OK(hatch_line_edges_find(mesh, true, &keep, &scratch, &edges, &err), &err);
    HATCH_TEST_OK(hatch_line_mesh_make(mesh, &edges, origin, &choice, &keep, &scratch, &lines, &err), &err);
    return lines.feature_count;
}

/* Two cubes with a common side share its four edges, unless a morph target or a joint moves one of them. */
START_TEST(parts_that_move_apart_are_not_joined)
{
    struct hatch_mesh left = cube(-1, 1), right = cube(-1, 1);
    float *moves, *joints, *weights;
    move(&right, 1, 2);
    struct hatch_mesh morphed = both(&left, &right), skinned = morphed;
    ck_assert_uint_eq(deformed_features(&morphed), 20);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &morphed, HATCH_MORPH_POSITION, 6, &moves, &err), &err);
    for (uint32_t v = 0; v < 16; v++) {
        moves[6 * v + 1] = 1; /* the first target moves both */
        moves[6 * v + 3] = v / 8 ? 2 : 0;
    }
    ck_assert_uint_eq(lines_of(&morphed, HATCH_LINES_ALL, CREASE_RAD).feature_count, 20);
    ck_assert_uint_eq(deformed_features(&morphed), 24);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &skinned, "JOINTS_0", 4, &joints, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &skinned, "WEIGHTS_0", 4, &weights, &err), &err);
    for (uint32_t v = 0; v < 16; v++)
        weights[4 * v + 1] = 1;
    ck_assert_uint_eq(deformed_features(&skinned), 20);
    for (uint32_t v = 8; v < 16; v++)
        joints[4 * v + 1] = 1;
    ck_assert_uint_eq(deformed_features(&skinned), 24);
}
END_TEST

/* Every face has vertices of its own, whose joints are in different orders, with weights that are rounded differently
 * and do not add up to 1, and with other joints of no weight. */
START_TEST(parts_that_move_alike_are_joined)
{
    struct hatch_mesh mesh = bare_shape(HATCH_SHAPE_TORUS, 2000), apart = unwelded(&mesh);
    float *joints, *weights;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &apart, "JOINTS_0", 4, &joints, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &apart, "WEIGHTS_0", 4, &weights, &err), &err);
    for (uint32_t v = 0; v < apart.vertex_count; v++)
        for (uint32_t k = 0; k < 4; k++) {
            uint32_t joint = (k + v / 3) % 4; /* the last one has no weight */
            float share = (1 + apart.attributes[0].data[3 * v + joint % 3]) * (1 + (float)(v / 3 % 3) * 1e-6f);
            joints[4 * v + k] = (float)(joint + (joint == 3 ? v : 0));
            weights[4 * v + k] = joint == 3 ? 0 : (2 + (float)joint + share) * (float)(1 + v / 3 % 2);
        }
    ck_assert_uint_eq(deformed_features(&apart), 0);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    static const double origin[3] = {0, 0, 0};
    const struct hatch_line_choice choice = {HATCH_LINES_ALL, CREASE_RAD, true};
    struct hatch_line_mesh lines;
    return hatch_line_mesh_make(context, NULL, origin, &choice, arena, temporary, &lines, error);
}

START_TEST(extraction_survives_every_failed_allocation)
{
    struct hatch_mesh smooth = shape_of(HATCH_SHAPE_TEAPOT, 300), sharp = cube(-1, 1);
    ck_assert_uint_gt(hatch_test_fail_alloc(make, &smooth, NULL, 0), 20);
    ck_assert_uint_gt(hatch_test_fail_alloc(make, &sharp, NULL, 0), 20);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render lines mesh");
    TCase *tests = tcase_create("features");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_cube_has_twelve_creases);
    tcase_add_test(tests, edges_between_planes_are_creases);
    tcase_add_test(tests, the_winding_of_faces_does_not_matter);
    tcase_add_test(tests, boundaries_are_closed_chains);
    tcase_add_test(tests, all_edges_but_boundaries_may_turn);
    tcase_add_test(tests, corners_apart_by_rounding_are_one);
    tcase_add_test(tests, two_sheets_on_one_another_have_the_boundary_of_one);
    tcase_add_test(tests, three_sheets_meet_in_a_crease);
    tcase_add_test(tests, a_crack_is_no_boundary);
    tcase_add_test(tests, an_edge_within_a_face_is_no_boundary);
    tcase_add_test(tests, creases_of_noise_are_removed);
    tcase_add_test(tests, authored_normals_decide_on_creases);
    tcase_add_test(tests, scale_and_place_do_not_matter);
    tcase_add_test(tests, faces_without_area_are_no_lines);
    tcase_add_test(tests, parts_that_move_apart_are_not_joined);
    tcase_add_test(tests, parts_that_move_alike_are_joined);
    tcase_add_test(tests, extraction_survives_every_failed_allocation);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
