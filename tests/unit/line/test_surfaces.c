/* Feature lines of surfaces that a file divides into several meshes. */
#include "fail_alloc.h"
#include "line/lines.h"
#include "lines.h"

#define SIDES 6

static struct hatch_scene scene;
static struct hatch_unit_scene unit;
static struct hatch_material materials[SIDES];

/* Opens a scene of nodes that each show all of some meshes, mesh i with material i. */
static void open_scene(const struct hatch_mesh *meshes, uint32_t count, uint32_t nodes)
{
    static const struct hatch_bounds bounds = {.radius = 2};
    HATCH_TEST_OK(hatch_scene_of_mesh(meshes, &keep, &scene, &err), &err);
    struct hatch_scene_mesh *shown = HATCH_NEW(&keep, struct hatch_scene_mesh, count, &err);
    struct hatch_node *list = HATCH_NEW(&keep, struct hatch_node, nodes, &err);
    for (uint32_t i = 0; i < count; i++) {
        shown[i] = scene.meshes[0];
        shown[i].mesh = meshes[i];
        shown[i].material = i % SIDES;
        materials[i % SIDES] = (struct hatch_material){.base.texture = HATCH_NONE, .double_sided = true};
    }
    for (uint32_t i = 0; i < nodes; i++) {
        list[i] = scene.nodes[0];
        list[i].mesh_count = count;
        list[i].translation[0] = (float)(5 * i);
    }
    scene.meshes = shown;
    scene.mesh_count = count;
    scene.nodes = list;
    scene.node_count = nodes;
    scene.materials = materials;
    scene.material_count = SIDES;
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
}

/* Divides a cube from -1 to 1 into its sides. */
static void divide_cube(struct hatch_mesh sides[SIDES])
{
    struct hatch_mesh whole = cube(-1, 1);
    for (uint32_t i = 0; i < SIDES; i++) {
        sides[i] = whole;
        sides[i].indices = whole.indices + 6 * (size_t)i;
        sides[i].face_count = 2;
    }
}

/* Returns the length of the lines of the scene, in its units, from the direction (3, 2, 4). Creases and boundaries
 * count where a face is visible.
 *   paths  out: number of chains */
static double drawn(uint32_t kinds, uint32_t *paths)
{
    const struct hatch_line_style style = {.kinds = kinds, .width_px = 2, .crease_rad = 0.7};
    const struct hatch_view view = view_from(3, 2, 4, true);
    struct hatch_lines lines;
    struct hatch_line_curves *curves;
    uint32_t count;
    double length = 0;
    *paths = 0;
    HATCH_TEST_OK(hatch_lines_make(&unit, &style, &keep, &scratch, &lines, &err), &err);
    HATCH_TEST_OK(hatch_lines_pose(&lines, &view, 400, &keep, &curves, &count, &err), &err);
    for (uint32_t i = 0; i < count; i++) {
        const struct hatch_line_chains *chains = &curves[i].chains;
        *paths += chains->count;
        for (uint32_t c = 0; c < chains->count; c++)
            for (uint32_t k = chains->chains[c].first; k < chains->chains[c].first + chains->chains[c].segment_count;
                 k++)
                if (curves[i].trace.slack_px[chains->segments[k]] >= 0)
                    length += unit.bounds.radius *
                              hatch_vec_distance(&curves[i].trace.nodes[3 * (size_t)chains->nodes[k + c]],
                                                 &curves[i].trace.nodes[3 * (size_t)chains->nodes[k + c + 1]]);
    }
    return length;
}

START_TEST(the_sides_of_a_cube_are_one_surface)
{
    struct hatch_mesh sides[SIDES];
    uint32_t paths;
    divide_cube(sides);
    open_scene(sides, SIDES, 1);
    ck_assert_double_eq_tol(drawn(HATCH_LINES_CREASES, &paths), 24, 1e-5);
    ck_assert_double_eq_tol(drawn(HATCH_LINES_SILHOUETTES, &paths), 12, 1e-5);
    ck_assert_uint_eq(paths, 1);
    ck_assert_double_eq(drawn(HATCH_LINES_BOUNDARIES, &paths), 0);
}
END_TEST

/* Vertices of the sides differ in other attributes, and not all of them have normals. */
START_TEST(sides_with_other_attributes_are_one_surface)
{
    struct hatch_mesh sides[SIDES];
    uint32_t paths;
    divide_cube(sides);
    for (uint32_t i = 0; i < SIDES; i++)
        sides[i] = unwelded(&sides[i]);
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &sides[1], 0, &err), &err);
    open_scene(sides, SIDES, 1);
    ck_assert_double_eq_tol(drawn(HATCH_LINES_CREASES, &paths), 24, 1e-5);
    ck_assert_double_eq(drawn(HATCH_LINES_BOUNDARIES, &paths), 0);
}
END_TEST

/* Half a sphere each, with the sphere's normals: the seam is as smooth as the rest. */
START_TEST(a_seam_between_smooth_halves_is_no_line)
{
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 2000), halves[2] = {sphere, sphere};
    uint32_t paths;
    halves[0].face_count = sphere.face_count / 2;
    halves[1].face_count -= halves[0].face_count;
    halves[1].indices += 3 * (size_t)halves[0].face_count;
    open_scene(halves, 2, 1);
    ck_assert_double_eq(drawn(HATCH_LINES_CREASES | HATCH_LINES_BOUNDARIES, &paths), 0);
    drawn(HATCH_LINES_SILHOUETTES, &paths);
    ck_assert_uint_eq(paths, 1);
}
END_TEST

START_TEST(meshes_of_different_nodes_are_apart)
{
    struct hatch_mesh sides[SIDES];
    uint32_t paths;
    divide_cube(sides);
    open_scene(sides, 2, 1);
    ck_assert_double_eq_tol(drawn(HATCH_LINES_BOUNDARIES, &paths), 16, 1e-5);
    open_scene(sides, SIDES, 3);
    ck_assert_double_eq_tol(drawn(HATCH_LINES_CREASES, &paths), 3 * 24, 1e-5);
}
END_TEST

/* The side at z = 1 is cut out: of the twelve edges, four become boundaries, which the eye sees from inside. */
START_TEST(a_surface_ends_where_a_mesh_is_cut_out)
{
    struct hatch_mesh sides[SIDES];
    uint32_t paths;
    divide_cube(sides);
    open_scene(sides, SIDES, 1);
    unit.items[1].cut_out = true;
    ck_assert_double_eq_tol(drawn(HATCH_LINES_BOUNDARIES, &paths), 8, 1e-5);
    ck_assert_double_eq_tol(drawn(HATCH_LINES_CREASES, &paths), 16, 1e-5);
    open_scene(sides, SIDES, 1);
    unit.items[0].cut_out = true; /* the first one */
    ck_assert_double_eq_tol(drawn(HATCH_LINES_BOUNDARIES, &paths), 8, 1e-5);
}
END_TEST

/* All sides but one are visible from in front only. Nine edges have such a front. The side at z = -1 is turned away:
 * if it is visible from behind, its other two edges are drawn, too; so are its boundaries where its neighbours are cut
 * out. */
START_TEST(each_mesh_keeps_its_sides)
{
    for (int double_sided = 0; double_sided < 2; double_sided++) {
        struct hatch_mesh sides[SIDES];
        uint32_t paths;
        divide_cube(sides);
        open_scene(sides, SIDES, 1);
        for (uint32_t i = 0; i < SIDES; i++)
            unit.items[i].double_sided = i == 0 && double_sided;
        ck_assert_double_eq_tol(drawn(HATCH_LINES_CREASES, &paths), double_sided ? 22 : 18, 1e-5);
        for (uint32_t i = 0; i < SIDES; i++)
            unit.items[i].cut_out = i == 1 || i == 3 || i == 5;
        ck_assert_double_eq_tol(drawn(HATCH_LINES_SILHOUETTES, &paths), 0, 1e-5);
        ck_assert_double_eq_tol(drawn(HATCH_LINES_BOUNDARIES, &paths), double_sided ? 4 : 0, 1e-5);
    }
}
END_TEST

/* A sheet of two meshes, from -1 to 1, that is flat at rest and folded by a right angle along x = 0 with its morph
 * target, or the reverse. The target moves normals, too. */
static void open_fold(bool folded_at_rest, float *weight)
{
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 200), sheet = unwelded(&plane), halves[2];
    float *p = sheet.attributes[0].data, *n = hatch_mesh_find(&sheet, "NORMAL", 3), *moves, *turns;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &sheet, HATCH_MORPH_POSITION, 3, &moves, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &sheet, HATCH_MORPH_NORMAL, 3, &turns, &err), &err);
    for (uint32_t v = 0; v < sheet.vertex_count; v++) {
        const float *at = plane.attributes[0].data;
        const uint32_t *face = &plane.indices[v - v % 3];
        bool right = at[3 * face[0]] + at[3 * face[1]] + at[3 * face[2]] > 0;
        float x = right ? p[3 * v] : 0, sign = folded_at_rest ? -1 : 1;
        moves[3 * v] = -sign * x;
        moves[3 * v + 2] = sign * x;
        turns[3 * v] = right ? -sign : 0;
        turns[3 * v + 2] = right ? -sign : 0;
        p[3 * v] -= folded_at_rest ? x : 0;
        p[3 * v + 2] = folded_at_rest ? x : 0;
        n[3 * v] = folded_at_rest && right ? -1 : 0;
        n[3 * v + 2] = folded_at_rest && right ? 0 : 1;
    }
    halves[0] = halves[1] = sheet;
    halves[0].face_count = 60; /* up to y = -0.4 */
    halves[1].face_count = 140;
    halves[1].indices += 180;
    open_scene(halves, 2, 1);
    scene.nodes[0].weights = weight;
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
}

START_TEST(a_fold_is_a_crease_while_it_is_folded)
{
    float weight;
    uint32_t paths;
    for (int folded_at_rest = 0; folded_at_rest < 2; folded_at_rest++) {
        open_fold(folded_at_rest, &weight);
        for (int moved = 0; moved < 3; moved++) {
            weight = (float)(moved % 2);
            ck_assert_double_eq_tol(drawn(HATCH_LINES_CREASES, &paths), moved % 2 != folded_at_rest ? 2 : 0, 1e-5);
            ck_assert_uint_eq(paths, moved % 2 != folded_at_rest);
            ck_assert_double_eq_tol(drawn(HATCH_LINES_BOUNDARIES, &paths), 8, 1e-5);
        }
    }
}
END_TEST

/* Normals that stay the same across a fold make it smooth up to an angle of 60 degrees. */
START_TEST(normals_at_the_pose_decide_on_creases)
{
    float weight = 0.5f; /* the right half turns by 45 degrees */
    uint32_t paths;
    open_fold(false, &weight);
    ck_assert_double_eq_tol(drawn(HATCH_LINES_CREASES, &paths), 2, 1e-5);
    for (uint32_t v = 0; v < scene.meshes[0].mesh.vertex_count; v++)
        memset(hatch_mesh_find(&scene.meshes[0].mesh, HATCH_MORPH_NORMAL, 3) + 3 * (size_t)v, 0, 12);
    ck_assert_double_eq(drawn(HATCH_LINES_CREASES, &paths), 0);
}
END_TEST

static enum hatch_status trace_fold(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                    struct hatch_err *error)
{
    const struct hatch_view view = view_from(3, 2, 4, true);
    struct hatch_lines lines = *(const struct hatch_lines *)context;
    struct hatch_line_curves *curves;
    uint32_t count;
    lines.scratch = temporary;
    return hatch_lines_pose(&lines, &view, 400, arena, &curves, &count, error);
}

START_TEST(posing_survives_every_failed_allocation)
{
    const struct hatch_line_style style = {.kinds = HATCH_LINES_ALL, .width_px = 2, .crease_rad = 0.7};
    struct hatch_lines lines;
    float weight = 1;
    open_fold(false, &weight);
    HATCH_TEST_OK(hatch_lines_make(&unit, &style, &keep, &scratch, &lines, &err), &err);
    ck_assert_uint_gt(hatch_test_fail_alloc(trace_fold, &lines, NULL, 0), 20);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    const struct hatch_line_style style = {.kinds = HATCH_LINES_ALL, .width_px = 2, .crease_rad = 0.7};
    struct hatch_lines lines;
    (void)context;
    return hatch_lines_make(&unit, &style, arena, temporary, &lines, error);
}

START_TEST(joining_survives_every_failed_allocation)
{
    struct hatch_mesh sides[SIDES];
    divide_cube(sides);
    open_scene(sides, SIDES, 2);
    ck_assert_uint_gt(hatch_test_fail_alloc(make, NULL, NULL, 0), 20);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("surfaces");
    TCase *tests = tcase_create("surfaces");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_sides_of_a_cube_are_one_surface);
    tcase_add_test(tests, sides_with_other_attributes_are_one_surface);
    tcase_add_test(tests, a_seam_between_smooth_halves_is_no_line);
    tcase_add_test(tests, meshes_of_different_nodes_are_apart);
    tcase_add_test(tests, a_surface_ends_where_a_mesh_is_cut_out);
    tcase_add_test(tests, each_mesh_keeps_its_sides);
    tcase_add_test(tests, a_fold_is_a_crease_while_it_is_folded);
    tcase_add_test(tests, normals_at_the_pose_decide_on_creases);
    tcase_add_test(tests, posing_survives_every_failed_allocation);
    tcase_add_test(tests, joining_survives_every_failed_allocation);
    suite_add_tcase(made, tests);
    return made;
}
HATCH_TEST_MAIN(suite)
