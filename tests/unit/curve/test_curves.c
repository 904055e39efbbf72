/* Strokes as points of faces, and as the vertices that files hold. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "curve/curves.h"
#include "fail_alloc.h"
#include "meshes.h"

static struct hatch_mesh mesh;
static struct hatch_curve_point points[7];
static struct hatch_curve curves_of[3];
static struct hatch_curve_set sets[3];
static struct hatch_curves curves;

static struct hatch_curve_point point_of(uint32_t face, float b, float c, float threshold)
{
    return (struct hatch_curve_point){.face = face, .share = {b, c}, .threshold = threshold};
}

/* Two faces of a skewed quad, and two sets of strokes with an empty one between them. */
static void begin_curves(void)
{
    static const float positions[12] = {1, 0, 0, 5, 0, 0, 5, 2, 4, 1, 2, 4};
    static const uint32_t indices[6] = {0, 1, 2, 2, 3, 0};
    begin();
    mesh = mesh_of(positions, 4, indices, 2);
    for (uint32_t i = 0; i < 7; i++)
        points[i] = point_of(i % 2, 0.125f * (float)i, 0.25f - 0.03125f * (float)i, ldexpf(1, (int)i - 3));
    curves_of[0] = (struct hatch_curve){0, 2, HATCH_CURVE_ID_MAX, 3};
    curves_of[1] = (struct hatch_curve){2, 3, 0x12345678, 1};
    curves_of[2] = (struct hatch_curve){5, 2, 7, 2};
    sets[0] = (struct hatch_curve_set){0, 0, 0.5f, 1, 0, 2, 40, 0.7f};
    sets[1] = (struct hatch_curve_set){0, 3, 0.5f, 0.125f, 2, 0, 40, 0.7f};
    sets[2] = (struct hatch_curve_set){2, 1, -1, 0.5f, 2, 1, 40, 0.7f};
    curves = (struct hatch_curves){3, 3, 7, sets, curves_of, points, 0, 0};
}

static void position_of(uint32_t face, float b, float c, float at[3])
{
    const struct hatch_curve_point point = point_of(face, b, c, 1);
    hatch_curve_position(&mesh, &point, at);
}

START_TEST(positions_are_barycentric)
{
    static const float wanted[4][3] = {{1, 0, 0}, {5, 0, 0}, {5, 2, 4}, {4, 0.5f, 1}};
    static const float shares[4][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0.25f}};
    float at[3];
    for (int i = 0; i < 4; i++) {
        position_of(0, shares[i][0], shares[i][1], at);
        ck_assert_mem_eq(at, wanted[i], sizeof at);
    }
    position_of(1, 0.25f, 0.5f, at); /* corners 2, 3 and 0 */
    ck_assert(at[0] == 2 && at[1] == 1 && at[2] == 2);
}
END_TEST

/* Checks that the strokes are refused with a message that contains a text. */
static void check_refused(const char *text)
{
    ck_assert_int_eq(hatch_curves_check(&curves, &mesh, &err), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, text) != NULL, "'%s' lacks '%s'", err.text, text);
}

START_TEST(sound_strokes_pass)
{
    HATCH_TEST_OK(hatch_curves_check(&curves, &mesh, &err), &err);
    points[3].share[0] = -0.0009f;
    points[3].share[1] = 1.0015f;
    HATCH_TEST_OK(hatch_curves_check(&curves, &mesh, &err), &err);
    points[3].threshold = 1e-38f;
    HATCH_TEST_OK(hatch_curves_check(&curves, &mesh, &err), &err);
    curves = (struct hatch_curves){0};
    HATCH_TEST_OK(hatch_curves_check(&curves, &mesh, &err), &err);
}
END_TEST

START_TEST(a_bad_point_is_named)
{
    static const float shares[][2] = {{-0.002f, 0.5f}, {0.5f, -0.002f}, {0.6f, 0.402f},       {NAN, 0},
                                      {0, NAN},        {INFINITY, 0},   {-INFINITY, INFINITY}};
    static const float thresholds[] = {0, -0.0f, -1, NAN, INFINITY, -INFINITY};
    const struct hatch_curve_point sound = points[4];
    points[4].face = 2;
    check_refused("strokes: point 4: face 2 does not exist, there are 2");
    points[4].face = UINT32_MAX;
    check_refused("face 4294967295 does not exist");
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        points[4] = sound;
        memcpy(points[4].share, shares[i], sizeof shares[i]);
        check_refused("strokes: point 4 is outside of its face");
    }
    for (size_t i = 0; i < sizeof thresholds / sizeof *thresholds; i++) {
        points[4] = sound;
        points[4].threshold = thresholds[i];
        check_refused("strokes: point 4: threshold");
    }
}
END_TEST

START_TEST(a_bad_set_is_named)
{
    static const struct hatch_curve_set bad[] = {
        {8, 0, 0, 1, 2, 1, 40, 0.7f},   {UINT32_MAX, 0, 0, 1, 2, 1, 40, 0.7f}, {2, 16, 0, 1, 2, 1, 40, 0.7f},
        {0, 3, 0, 1, 2, 1, 40, 0.7f},   {0, 1, 0, 1, 2, 1, 40, 0.7f},          {2, 0, 0, 0, 2, 1, 40, 0.7f},
        {2, 0, 0, -1, 2, 1, 40, 0.7f},  {2, 0, 0, NAN, 2, 1, 40, 0.7f},        {2, 0, 0, INFINITY, 2, 1, 40, 0.7f},
        {2, 0, NAN, 1, 2, 1, 40, 0.7f}, {2, 0, 200, 1, 2, 1, 40, 0.7f},
    };
    static const char *const texts[] = {"want at most 7 and 15", "want at most 7 and 15", "want at most 7 and 15",
                                        "is out of order",       "is out of order",       "out of range",
                                        "out of range",          "out of range",          "out of range",
                                        "out of range",          "out of range"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        sets[2] = bad[i];
        check_refused(texts[i]);
    }
    sets[2] = (struct hatch_curve_set){7, 15, -6, 1, 2, 1, 40, 0.7f};
    HATCH_TEST_OK(hatch_curves_check(&curves, &mesh, &err), &err);
    sets[0].family = 1; /* before a set of family 0 */
    check_refused("strokes: family 0, level 3 is out of order");
}
END_TEST

static struct hatch_mesh vertices_of(const struct hatch_curve_set *set, uint32_t *lines)
{
    struct hatch_mesh vertices;
    HATCH_TEST_OK(hatch_curves_as_vertices(&curves, set, &mesh, &keep, &vertices, lines, &err), &err);
    return vertices;
}

/* The places of the points, and a line from each to the next of its stroke. */
START_TEST(points_become_vertices)
{
    static const uint32_t ends[] = {0, 1, 2, 3, 3, 4};
    uint32_t lines;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    ck_assert_uint_eq(vertices.vertex_count, 5);
    ck_assert_uint_eq(vertices.face_count, 0);
    ck_assert_uint_eq(vertices.attribute_count, 3);
    ck_assert_uint_eq(lines, 3);
    ck_assert_mem_eq(vertices.indices, ends, sizeof ends);
    for (uint32_t v = 0; v < 5; v++) {
        float at[3];
        hatch_curve_position(&mesh, &points[v], at);
        ck_assert_mem_eq(&vertices.attributes[0].data[3 * v], at, sizeof at);
    }
    /* Codes of thresholds, and halves of the ids at ends; 32768 more where an end is free. */
    static const float stroke[] = {20480, 65535, 24576, 65535, 28672, 0xd678, 32768, 0, 36864, 0x2468};
    ck_assert_mem_eq(hatch_mesh_find(&vertices, HATCH_CURVE_STROKE, 2), stroke, sizeof stroke);
    ck_assert_float_eq(hatch_mesh_find(&vertices, HATCH_CURVE_FACE, 2)[6], 1);
    vertices = vertices_of(&sets[1], &lines);
    ck_assert_uint_eq(vertices.vertex_count + lines, 0);
    vertices = vertices_of(&sets[2], &lines); /* with half the gap */
    static const float last[] = {36864, 7, 40960, 32768};
    ck_assert_mem_eq(hatch_mesh_find(&vertices, HATCH_CURVE_STROKE, 2), last, sizeof last);
    ck_assert_uint_eq(lines, 1);
}
END_TEST

START_TEST(thresholds_are_limited_to_eight_octaves)
{
    static const float thresholds[] = {1e-30f, 0.0039f, 255.99f, 1e30f, 1}, codes[] = {0, 0, 65535, 65535, 32768};
    uint32_t lines;
    for (uint32_t i = 0; i < 5; i++)
        points[i].threshold = thresholds[i];
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    for (uint32_t i = 0; i < 5; i++)
        ck_assert_float_eq(hatch_mesh_find(&vertices, HATCH_CURVE_STROKE, 2)[2 * i], codes[i]);
}
END_TEST

START_TEST(parts_of_sets_have_indices_of_16_bits)
{
    static const uint32_t counts[] = {65534, 2, 65533, 2, 65536, 65535, 2}, parts[] = {1, 2, 1, 1, 1, 1};
    struct hatch_curve list[7];
    const struct hatch_curve_set set = {.family = 1, .gap = 0.5f, .first = 1, .count = 6};
    const struct hatch_curves all = {.curves = list};
    uint32_t first = 1, i = 0;
    for (uint32_t c = 0, point = 0; c < 7; point += counts[c], c++)
        list[c] = (struct hatch_curve){.first = point, .count = counts[c]};
    for (; first < 7; i++) {
        struct hatch_curve_set part = hatch_curve_set_part(&all, &set, first);
        ck_assert(part.family == 1 && part.gap == 0.5f && part.first == first);
        ck_assert_uint_eq(part.count, parts[i + 1]);
        first += part.count;
    }
    ck_assert_uint_eq(i, 5);
}
END_TEST

static struct hatch_curves read_back; /* with room for the vertices of all sets */

static enum hatch_status read_lines(const struct hatch_mesh *vertices, const uint32_t *indices, uint32_t lines)
{
    read_back.curves = HATCH_NEW(&keep, struct hatch_curve, 10, &err);
    read_back.points = HATCH_NEW(&keep, struct hatch_curve_point, 10, &err);
    return hatch_curves_from_vertices(vertices, indices, lines, 1, &mesh, &read_back, &err);
}

START_TEST(vertices_become_the_same_points)
{
    uint32_t lines;
    read_back = (struct hatch_curves){0};
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    HATCH_TEST_OK(read_lines(&vertices, vertices.indices, lines), &err);
    vertices = vertices_of(&sets[2], &lines);
    HATCH_TEST_OK(hatch_curves_from_vertices(&vertices, vertices.indices, lines, 0.5f, &mesh, &read_back, &err), &err);
    ck_assert_uint_eq(read_back.count, 3);
    ck_assert_uint_eq(read_back.point_count, 7);
    ck_assert_mem_eq(read_back.curves, curves_of, sizeof curves_of);
    for (uint32_t i = 0; i < 7; i++) {
        ck_assert_uint_eq(read_back.points[i].face, points[i].face);
        ck_assert_float_eq(read_back.points[i].threshold, points[i].threshold);
        for (int k = 0; k < 2; k++)
            ck_assert_float_eq_tol(read_back.points[i].share[k], points[i].share[k], 1e-6f);
    }
}
END_TEST

/* The attribute of narrow faces is there if any point lies on one. */
START_TEST(narrow_faces_are_kept)
{
    uint32_t lines;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    ck_assert_ptr_null(hatch_mesh_attribute(&vertices, HATCH_CURVE_NARROW));
    points[3].across = 6;
    points[3].width = 20;
    points[4].width = 0.3f;
    vertices = vertices_of(&sets[0], &lines);
    read_back = (struct hatch_curves){0};
    HATCH_TEST_OK(read_lines(&vertices, vertices.indices, lines), &err);
    ck_assert_uint_eq(read_back.point_count, 5);
    for (uint32_t i = 0; i < 5; i++) {
        ck_assert_uint_eq(read_back.points[i].across, points[i].across);
        ck_assert_float_eq_tol(read_back.points[i].width, points[i].width, 1e-6f + 1e-4f * points[i].width);
    }
}
END_TEST

static void check_unread(const struct hatch_mesh *vertices, const uint32_t *indices, uint32_t lines, const char *text)
{
    read_back = (struct hatch_curves){0};
    ck_assert_int_eq(read_lines(vertices, indices, lines), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, text) != NULL, "'%s' lacks '%s'", err.text, text);
}

START_TEST(lines_that_are_no_strokes_are_refused)
{
    static const uint32_t bad[][6] = {{1, 2, 2, 3, 3, 4}, {0, 2, 2, 3, 3, 4}, {0, 1, 1, 3, 3, 4},
                                      {0, 1, 2, 1, 3, 4}, {0, 1, 0, 1, 3, 4}, {0, 1, 1, 0, 3, 4},
                                      {0, 1, 2, 3, 4, 5}, {0, 0, 1, 2, 3, 4}, {UINT32_MAX, 0, 1, 2, 3, 4}};
    static const char *const texts[] = {"line 0 does", "line 0 does", "line 1 does", "line 1 does", "line 1 does",
                                        "line 1 does", "line 2 does", "line 0 does", "line 0 does"};
    uint32_t lines;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        check_unread(&vertices, bad[i], lines, texts[i]);
}
END_TEST

START_TEST(a_missing_attribute_is_named)
{
    for (uint32_t i = 1; i < 3; i++) {
        uint32_t lines;
        struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
        char name[HATCH_MESH_NAME_MAX];
        memcpy(name, vertices.attributes[i].name, sizeof name);
        vertices.attributes[i].name[0] = 'x';
        check_unread(&vertices, vertices.indices, lines, name);
        vertices.attributes[i].name[0] = '_';
        vertices.attributes[i].components++;
        check_unread(&vertices, vertices.indices, lines, name);
    }
}
END_TEST

START_TEST(numbers_out_of_range_are_refused)
{
    static const char *const names[] = {HATCH_CURVE_FACE, HATCH_CURVE_STROKE};
    static const float bad[] = {-1, 65536, 0.5f, NAN};
    uint32_t lines;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    for (uint32_t i = 0; i < 16; i++) {
        float *number = &hatch_mesh_find(&vertices, names[i / 8], 2)[6 + i / 4 % 2], was = *number;
        char text[100];
        snprintf(text, sizeof text, "strokes: vertex 3: %s is no whole number of 16 bits", names[i / 8]);
        *number = bad[i % 4];
        check_unread(&vertices, vertices.indices, lines, text);
        *number = was;
    }
}
END_TEST

START_TEST(vertices_that_are_no_points_are_refused)
{
    uint32_t lines;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    float *face = &hatch_mesh_find(&vertices, HATCH_CURVE_FACE, 2)[6];
    face[0] = 2;
    check_unread(&vertices, vertices.indices, lines, "strokes: vertex 3: face 2 does not exist, there are 2");
    face[0] = face[1] = 65535;
    check_unread(&vertices, vertices.indices, lines, "strokes: vertex 3: face 4294967295 does not exist");
    face[0] = face[1] = 0;
    check_unread(&vertices, vertices.indices, lines, "strokes: vertex 3 is not on its face 0");
    face[0] = 0;
    points[0].width = 1;
    vertices = vertices_of(&sets[0], &lines);
    hatch_mesh_find(&vertices, HATCH_CURVE_NARROW, 2)[0] = 9;
    check_unread(&vertices, vertices.indices, lines, "strokes: vertex 0: there are at most 8 families");
    hatch_mesh_find(&vertices, HATCH_CURVE_NARROW, 2)[1] = 0.5f;
    check_unread(&vertices, vertices.indices, lines, "strokes: vertex 0: _HATCH_NARROW is no whole number of 16 bits");
}
END_TEST

START_TEST(halves_of_identifiers_are_at_ends)
{
    uint32_t lines;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    hatch_mesh_find(&vertices, HATCH_CURVE_FACE, 2)[6] = hatch_mesh_find(&vertices, HATCH_CURVE_STROKE, 2)[7] = 1;
    check_unread(&vertices, vertices.indices, lines, "strokes: vertex 3 has half an identifier, but ends no stroke");
}
END_TEST

/* Many copies of the first face, of which the strokes lie on the last. */
START_TEST(numbers_of_faces_have_32_bits)
{
    enum { FACES = 70000 };
    uint32_t lines, *copies = HATCH_NEW(&keep, uint32_t, 3 * (size_t)FACES, &err);
    for (size_t i = 0; i < 3 * (size_t)FACES; i++)
        copies[i] = mesh.indices[i % 3];
    mesh.indices = copies;
    mesh.face_count = FACES;
    for (uint32_t i = 0; i < 7; i++)
        points[i].face = FACES - 1;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    read_back = (struct hatch_curves){0};
    HATCH_TEST_OK(read_lines(&vertices, vertices.indices, lines), &err);
    for (uint32_t i = 0; i < 5; i++)
        ck_assert_uint_eq(read_back.points[i].face, FACES - 1);
}
END_TEST

/* Each corner has four joints; one of them is common to all. */
static void add_four_joints(void)
{
    float *joints, *weights;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "JOINTS_0", 4, &joints, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "WEIGHTS_0", 4, &weights, &err), &err);
    for (uint32_t v = 0; v < 4; v++)
        for (uint32_t i = 0; i < 4; i++) {
            joints[4 * v + i] = i == 0 ? 9 : (float)(10 * v + i);
            weights[4 * v + i] = i == 0 ? 0.4f : 0.1f * (float)i;
        }
}

/* The four heaviest joints at a point are those of its corners, weighted by its shares; their weights add up to 1. */
START_TEST(the_heaviest_joints_are_kept)
{
    uint32_t lines;
    add_four_joints();
    points[0] = point_of(0, 0.25f, 0.25f, 1); /* shares 0.5, 0.25, 0.25 */
    points[1] = point_of(0, 1, 0, 1);
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    const float *joints = hatch_mesh_find(&vertices, "JOINTS_0", 4);
    const float *weights = hatch_mesh_find(&vertices, "WEIGHTS_0", 4);
    /* 9: 0.4; 3: 0.15; 2: 0.1; 13 and 23: 0.075 each, of which the first is kept; all of them: 0.725 */
    static const float joints_wanted[] = {9, 3, 2, 13, 9, 13, 12, 11};
    static const float weights_wanted[] = {0.4f / 0.725f, 0.15f / 0.725f, 0.1f / 0.725f, 0.075f / 0.725f,
                                           0.4f,          0.3f,           0.2f,          0.1f};
    for (uint32_t i = 0; i < 8; i++) {
        ck_assert_float_eq(joints[i], joints_wanted[i]);
        ck_assert_float_eq_tol(weights[i], weights_wanted[i], 1e-6f);
    }
}
END_TEST

/* Joints without weight are 0, as the format requires. */
START_TEST(joints_without_weight_are_left_out)
{
    uint32_t lines;
    add_four_joints();
    float *from = hatch_mesh_find(&mesh, "WEIGHTS_0", 4);
    for (uint32_t v = 0; v < 4; v++)
        for (uint32_t i = 0; i < 4; i++)
            from[4 * v + i] = i == 0;
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines);
    const float *joints = hatch_mesh_find(&vertices, "JOINTS_0", 4);
    const float *weights = hatch_mesh_find(&vertices, "WEIGHTS_0", 4);
    for (uint32_t i = 0; i < 20; i++) {
        ck_assert_float_eq(joints[i], i % 4 == 0 ? 9 : 0);
        ck_assert_float_eq_tol(weights[i], i % 4 == 0 ? 1 : 0, 1e-6f);
    }
}
END_TEST

START_TEST(morph_targets_are_interpolated)
{
    float *moves;
    uint32_t lines;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, HATCH_MORPH_POSITION, 6, &moves, &err), &err);
    for (uint32_t i = 0; i < 24; i++)
        moves[i] = (float)(i * i % 11);
    struct hatch_mesh vertices = vertices_of(&sets[0], &lines), moved = mesh;
    const float *made = hatch_mesh_find(&vertices, HATCH_MORPH_POSITION, 6);
    ck_assert_uint_eq(hatch_mesh_target_count(&vertices), 2);
    for (uint32_t t = 0; t < 2; t++) {
        float displaced[12];
        for (uint32_t i = 0; i < 12; i++)
            displaced[i] = mesh.attributes[0].data[i] + moves[i / 3 * 6 + 3 * t + i % 3];
        moved.attributes[0].data = displaced;
        for (uint32_t v = 0; v < 5; v++) {
            float at[3];
            hatch_curve_position(&moved, &points[v], at);
            for (uint32_t k = 0; k < 3; k++)
                ck_assert_float_eq_tol(vertices.attributes[0].data[3 * v + k] + made[6 * v + 3 * t + k], at[k], 1e-5f);
        }
    }
}
END_TEST

static enum hatch_status make_vertices(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                       struct hatch_err *error)
{
    struct hatch_mesh vertices;
    uint32_t lines;
    (void)temporary;
    return hatch_curves_as_vertices(&curves, context, &mesh, kept, &vertices, &lines, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    float *moves;
    add_four_joints();
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, HATCH_MORPH_POSITION, 3, &moves, &err), &err);
    hatch_test_fail_alloc(make_vertices, &sets[0], NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("curve");
    TCase *tests = tcase_create("curves");
    tcase_add_checked_fixture(tests, begin_curves, end);
    tcase_add_test(tests, positions_are_barycentric);
    tcase_add_test(tests, sound_strokes_pass);
    tcase_add_test(tests, a_bad_point_is_named);
    tcase_add_test(tests, a_bad_set_is_named);
    tcase_add_test(tests, points_become_vertices);
    tcase_add_test(tests, thresholds_are_limited_to_eight_octaves);
    tcase_add_test(tests, parts_of_sets_have_indices_of_16_bits);
    tcase_add_test(tests, vertices_become_the_same_points);
    tcase_add_test(tests, narrow_faces_are_kept);
    tcase_add_test(tests, halves_of_identifiers_are_at_ends);
    tcase_add_test(tests, lines_that_are_no_strokes_are_refused);
    tcase_add_test(tests, a_missing_attribute_is_named);
    tcase_add_test(tests, numbers_out_of_range_are_refused);
    tcase_add_test(tests, vertices_that_are_no_points_are_refused);
    tcase_add_test(tests, numbers_of_faces_have_32_bits);
    tcase_add_test(tests, the_heaviest_joints_are_kept);
    tcase_add_test(tests, joints_without_weight_are_left_out);
    tcase_add_test(tests, morph_targets_are_interpolated);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
