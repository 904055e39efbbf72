/* Strokes written as GLB and read again, and damaged ones. */
#include <stdio.h>

#include "fail_alloc.h"
#include "io/glb/glb.h"
#include "io/gltf/gltf.h"
#include "meshes.h"

#define POINTS 15u

static struct hatch_scene_mesh meshes[2];
static struct hatch_node nodes[3];
static uint32_t joints[2] = {1, 2};
static float inverse_bind[32], times[2] = {0, 1}, values[4] = {0, 0, 1, 0.5f};
static struct hatch_skin skins[1];
static struct hatch_animation_channel channels[1];
static struct hatch_animation animations[1];
static struct hatch_curve_point points[2][POINTS];
static struct hatch_curve curves[2][3];
static struct hatch_curve_set sets[2][4];
static struct hatch_scene full, back;

/* Three strokes in two of four sets; the others have none. Thresholds are those that a file holds exactly. */
static void add_strokes(uint32_t m)
{
    static const uint32_t counts[3] = {6, 2, 7};
    uint32_t first = 0;
    for (uint32_t i = 0; i < POINTS; i++)
        points[m][i] = (struct hatch_curve_point){.face = i % meshes[m].mesh.face_count,
                                                  .share = {0.0123f * (float)(i + 1), 0.0217f * (float)(i + 1)},
                                                  .threshold = ldexpf(1, (int)(i % 7 + m) - 3)};
    for (uint32_t c = 0; c < 3; c++) {
        curves[m][c] = (struct hatch_curve){first, counts[c], 0x1e3779b9u * (c + 1) & HATCH_CURVE_ID_MAX, c + m};
        first += counts[c];
    }
    sets[m][0] = (struct hatch_curve_set){0, 0, 0, 0.5f, 0, 0, 40, 0.7f};
    sets[m][1] = (struct hatch_curve_set){0, 1, 0, 0.25f, 0, 1, 40, 0.7f};
    sets[m][2] = (struct hatch_curve_set){1, 0, 1.0f / 3, 0.5f, 1, 2, 40, 0.7f};
    sets[m][3] = (struct hatch_curve_set){1, 1, 1.0f / 3, 0.25f, 3, 0, 40, 0.7f};
    meshes[m].curves = (struct hatch_curves){4, 3, POINTS, sets[m], curves[m], points[m], 0, 0};
}

/* A skinned plane, and a torus with morph targets that are animated. */
static void begin_scene(void)
{
    begin();
    for (uint32_t m = 0; m < 2; m++)
        meshes[m] = (struct hatch_scene_mesh){.mesh = shape_of(m ? HATCH_SHAPE_TORUS : HATCH_SHAPE_PLANE, 16),
                                              .material = HATCH_NONE};
    add_joints(&meshes[0].mesh);
    add_targets(&meshes[1].mesh);
    for (uint32_t n = 0; n < 3; n++)
        nodes[n] = (struct hatch_node){.parent = n == 2 ? 1 : HATCH_NONE,
                                       .rotation = {0, 0, 0, 1},
                                       .scale = {1, 1, 1},
                                       .skin = n == 0 ? 0 : HATCH_NONE,
                                       .camera = HATCH_NONE,
                                       .light = HATCH_NONE,
                                       .first_mesh = n,
                                       .mesh_count = n < 2};
    for (uint32_t i = 0; i < 32; i++)
        inverse_bind[i] = i % 16 % 5 == 0;
    skins[0] = (struct hatch_skin){.joint_count = 2, .joints = joints, .inverse_bind = inverse_bind};
    channels[0] = (struct hatch_animation_channel){1, HATCH_PATH_WEIGHTS, HATCH_LINEAR, 2, times, values, 2};
    animations[0] = (struct hatch_animation){.channel_count = 1, .channels = channels, .duration_s = 1};
    full = (struct hatch_scene){.mesh_count = 2,
                                .node_count = 3,
                                .skin_count = 1,
                                .animation_count = 1,
                                .meshes = meshes,
                                .nodes = nodes,
                                .skins = skins,
                                .animations = animations};
    add_strokes(0);
    add_strokes(1);
}

static struct hatch_buffer written(const struct hatch_scene *scene)
{
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_glb_write_scene(scene, NULL, &scratch, &file, &err), &err);
    return file;
}

static enum hatch_status read_file(const struct hatch_buffer *file, struct hatch_mesh_notes *notes)
{
    *notes = (struct hatch_mesh_notes){0};
    return hatch_gltf_read((struct hatch_bytes){file->data, file->size}, NULL, &keep, &scratch, &back, notes, &err);
}

static struct hatch_buffer write_and_read(void)
{
    struct hatch_mesh_notes notes;
    struct hatch_buffer file = written(&full);
    HATCH_TEST_OK(read_file(&file, &notes), &err);
    ck_assert_uint_eq(notes.primitives_skipped, 0);
    ck_assert_uint_eq(notes.attributes_dropped, 0);
    return file;
}

/* Checks points of the first mesh, or the second, that were read. Shares follow from rounded positions. */
static void check_points(uint32_t m)
{
    const struct hatch_curves *read = &back.meshes[m].curves;
    ck_assert_uint_eq(read->point_count, POINTS);
    for (uint32_t i = 0; i < POINTS; i++) {
        ck_assert_uint_eq(read->points[i].face, points[m][i].face);
        ck_assert_float_eq(read->points[i].threshold, points[m][i].threshold);
        for (int k = 0; k < 2; k++)
            ck_assert_float_eq_tol(read->points[i].share[k], points[m][i].share[k], 1e-6f);
    }
}

START_TEST(strokes_survive_a_round_trip)
{
    write_and_read();
    ck_assert_uint_eq(back.mesh_count, 2);
    for (uint32_t m = 0; m < 2; m++) {
        const struct hatch_curves *read = &back.meshes[m].curves;
        ck_assert_uint_eq(read->set_count, 2);
        ck_assert_uint_eq(read->count, 3);
        ck_assert_mem_eq(read->sets, &sets[m][1], 2 * sizeof *read->sets);
        ck_assert_mem_eq(read->curves, curves[m], sizeof curves[m]);
        check_points(m);
    }
}
END_TEST

static size_t find(const struct hatch_buffer *file, const void *pattern, size_t size, size_t from)
{
    for (size_t at = from; at + size <= file->size; at++)
        if (memcmp(&file->data[at], pattern, size) == 0)
            return at;
    ck_abort_msg("the file lacks a pattern");
}

/* A copy has the same strokes: only positions may be rounded in another way. */
START_TEST(a_copy_of_a_copy_has_the_same_strokes)
{
    struct hatch_mesh_notes notes;
    write_and_read();
    struct hatch_buffer copy = written(&back);
    HATCH_TEST_OK(read_file(&copy, &notes), &err);
    for (uint32_t m = 0; m < 2; m++) {
        ck_assert_mem_eq(back.meshes[m].curves.curves, curves[m], sizeof curves[m]);
        check_points(m);
    }
}
END_TEST

/* Strokes are morphed at rest as the surface is. */
START_TEST(strokes_lie_on_the_surface_at_rest)
{
    float weights[2] = {0.5f, 0.25f};
    nodes[1].weights = weights;
    write_and_read();
    check_points(1);
}
END_TEST

/* A set of more vertices than indices of 16 bits name is written in parts, and read as one set. */
START_TEST(a_large_set_has_several_primitives)
{
    enum { STROKES = 30000 };
    struct hatch_curve_point *many = HATCH_NEW(&keep, struct hatch_curve_point, 3 * (size_t)STROKES, &err);
    struct hatch_curve *strokes = HATCH_NEW(&keep, struct hatch_curve, STROKES, &err);
    for (uint32_t i = 0; i < 3 * STROKES; i++)
        many[i] = (struct hatch_curve_point){.share = {(float)i / (3 * STROKES), 0}, .threshold = 1};
    for (uint32_t i = 0; i < STROKES; i++)
        strokes[i] = (struct hatch_curve){3 * i, 3, i, i % 4};
    sets[0][1].count = STROKES;
    meshes[0].curves = (struct hatch_curves){2, STROKES, 3 * STROKES, sets[0], strokes, many, 0, 0};
    full.mesh_count = 1;
    nodes[1].mesh_count = full.animation_count = 0;
    struct hatch_buffer file = write_and_read();
    const struct hatch_curves *read = &back.meshes[0].curves;
    ck_assert_uint_eq(read->set_count, 1);
    ck_assert_mem_eq(read->sets, &sets[0][1], sizeof *read->sets);
    ck_assert_uint_eq(read->point_count, 3 * STROKES);
    ck_assert_mem_eq(read->curves, strokes, STROKES * sizeof *strokes);
    size_t first = find(&file, "\"mode\":1", 8, 0), second = find(&file, "\"mode\":1", 8, first + 1);
    ck_assert_uint_gt(second, first);
    ck_assert_uint_lt(file.size, 3 * STROKES * (size_t)44 + 2 * STROKES * (size_t)4 + 5000);
}
END_TEST

/* Several surfaces of one node have their own strokes. */
START_TEST(strokes_belong_to_the_surface_before_them)
{
    nodes[0] = nodes[1];
    nodes[0].first_mesh = 0;
    nodes[0].mesh_count = 2;
    nodes[1].mesh_count = 0;
    full.animation_count = full.skin_count = 0;
    meshes[0].mesh.attribute_count = meshes[1].mesh.attribute_count = 2;
    struct hatch_buffer first = write_and_read(), second = written(&back);
    ck_assert_uint_eq(back.nodes[0].mesh_count, 2);
    for (uint32_t m = 0; m < 2; m++)
        check_points(m);
    ck_assert_uint_eq(second.size, first.size);
}
END_TEST

START_TEST(no_strokes_are_no_primitives)
{
    struct hatch_buffer with = written(&full);
    for (uint32_t m = 0; m < 2; m++)
        meshes[m].curves.set_count = 0;
    struct hatch_buffer without = write_and_read();
    ck_assert_uint_eq(back.meshes[0].curves.set_count + back.meshes[1].curves.set_count, 0);
    ck_assert_uint_gt(with.size, without.size + 1000);
    for (uint32_t m = 0; m < 2; m++) { /* sets without strokes, all of them */
        meshes[m].curves = (struct hatch_curves){4, 0, 0, sets[m], curves[m], points[m], 0, 0};
        for (uint32_t s = 0; s < 4; s++)
            sets[m][s].first = sets[m][s].count = 0;
    }
    struct hatch_buffer empty = written(&full);
    ck_assert_uint_eq(empty.size, without.size);
    ck_assert_mem_eq(empty.data, without.data, empty.size);
}
END_TEST

/* Replaces the n-th occurrence of some bytes, from 0, in a file of both meshes. */
static struct hatch_buffer patched(const void *from, const void *to, size_t size, uint32_t n)
{
    struct hatch_buffer file = written(&full);
    size_t at = find(&file, from, size, 0);
    for (; n > 0; n--)
        at = find(&file, from, size, at + 1);
    memcpy(&file.data[at], to, size);
    return file;
}

static void check_refused(struct hatch_buffer file, const char *text)
{
    struct hatch_mesh_notes notes;
    ck_assert_msg(read_file(&file, &notes) == HATCH_BAD_INPUT, "accepted; want '%s'", text);
    ck_assert_msg(strstr(err.text, text) != NULL, "'%s' lacks '%s'", err.text, text);
    end();
    begin_scene();
}

/* Texts of JSON replaced by others of the same length. */
START_TEST(damaged_descriptions_are_refused)
{
    static const struct {
        const char *from, *to;
        uint32_t n;
        const char *says;
    } cases[] = {
        {"\"family\":1", "\"family\":8", 0, "mesh 0, primitive 2: strokes: family, level"},
        {"\"family\":1", "\"family\":8", 1, "mesh 1, primitive 2: strokes: family, level"},
        {"\"family\":1", "\"family\":x", 0, "JSON"},
        {"\"level\":1", "\"lever\":1", 0, "mesh 0, primitive 1: strokes: family, level"},
        {"\"level\":1", "\"level\":{", 0, "JSON"},
        {"\"angle\":0,", "\"angel\":0,", 0, "mesh 0, primitive 1: strokes: family, level"},
        {"\"gap\":0.25", "\"gap\":-0.5", 0, "mesh 0, primitive 1: strokes: family, level"},
        {"\"gap\":0.25", "\"gap\":0.00", 0, "mesh 0, primitive 1: strokes: family, level"},
        {"\"gap\":0.25", "\"gap\":9e99", 0, "mesh 0, primitive 1: strokes: family, level"},
        {"\"gap\":0.25", "\"gap\":\"14\"", 1, "mesh 1, primitive 1: strokes: family, level"},
        {"\"family\":0", "\"family\":2", 0, "mesh 0, primitive 0: strokes: family 1, level 0 is out of order"},
        {"\"family\":1,\"level\":0", "\"family\":0,\"level\":1", 0,
         "mesh 0, primitive 2: strokes: angle or gap differs from the primitive before"},
        {"_HATCH_FACE", "_HATCH_FICE", 1, "mesh 0, primitive 2: strokes: _HATCH_FACE or"},
        {"_HATCH_STROKE", "_HATCH_STRIKE", 2, "mesh 1, primitive 1: strokes: _HATCH_FACE or"},
        {"\"count\":10,\"type\":\"SCALAR\"", "\"count\":11,\"type\":\"SCALAR\"", 0, "mesh 0, primitive 1, indices"},
        {"\"count\":10,\"type\":\"SCALAR\"", "\"count\": 9,\"type\":\"SCALAR\"", 0,
         "mesh 0, primitive 1: 9 ends do not form lines"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        check_refused(patched(cases[i].from, cases[i].to, strlen(cases[i].from), cases[i].n), cases[i].says);
}
END_TEST

/* The needs of views are written where strokes were made for them, and are read only together with the gap. */
START_TEST(strokes_tell_the_needs_that_they_were_made_for)
{
    static const struct {
        const char *from, *to;
        float needs, finest;
    } cases[] = {{"\"needs\":0.125", "\"needs\":0.125", 0.125f, 0.5f},
                 {"\"needs\":0.125", "\"needs\":1.125", 0, 0},
                 {"\"finest\":0.5", "\"finist\":0.5", 0, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hatch_mesh_notes notes;
        for (uint32_t m = 0; m < 2; m++)
            meshes[m].curves.needs = 0.125f, meshes[m].curves.finest = 0.5f;
        struct hatch_buffer file = patched(cases[i].from, cases[i].to, strlen(cases[i].from), 0);
        HATCH_TEST_OK(read_file(&file, &notes), &err);
        ck_assert_float_eq(back.meshes[0].curves.needs, cases[i].needs);
        ck_assert_float_eq(back.meshes[0].curves.finest, cases[i].finest);
        ck_assert_float_eq(back.meshes[1].curves.needs, 0.125f);
        end();
        begin_scene();
    }
}
END_TEST

/* A file may leave out how its strokes were traced; an angle of 0 is one that it gives, and no length is endless. */
START_TEST(what_finer_levels_need_may_be_missing)
{
    static const struct {
        const char *to;
        float length, hard_rad;
    } cases[] = {{"\"length\":40,\"hard\":0.0", 40, 0},
                 {"\"length\":40,\"herd\":0.7", 40, -1},
                 {"\"langth\":40,\"hard\":0.7", 0, 0.7f},
                 {"\"length\":9e9,\"hard\":1 ", 0, 1},
                 {"\"length\":1e3,\"hard\":1 ", 1e3f, 1}};
    for (uint32_t m = 0; m < 2; m++)
        for (uint32_t s = 0; s < 4; s++)
            sets[m][s].hard_rad = 0.5f;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hatch_mesh_notes notes;
        struct hatch_buffer file = patched("\"length\":40,\"hard\":0.5", cases[i].to, strlen(cases[i].to), 0);
        HATCH_TEST_OK(read_file(&file, &notes), &err);
        const struct hatch_curve_set *set = &back.meshes[0].curves.sets[0];
        ck_assert_float_eq(set->length, cases[i].length);
        ck_assert_float_eq(set->hard_rad, cases[i].hard_rad);
        full = back; /* and stays missing */
        struct hatch_buffer again = written(&full);
        HATCH_TEST_OK(read_file(&again, &notes), &err);
        ck_assert_float_eq(back.meshes[0].curves.sets[0].length, cases[i].length);
        ck_assert_float_eq(back.meshes[0].curves.sets[0].hard_rad, cases[i].hard_rad);
        end();
        begin_scene();
        for (uint32_t m = 0; m < 2; m++)
            for (uint32_t s = 0; s < 4; s++)
                sets[m][s].hard_rad = 0.5f;
    }
}
END_TEST

/* Numbers of the second set's first stroke replaced by others. */
START_TEST(damaged_numbers_are_refused)
{
    static const float away[3] = {5, 5, 5}, infinite[3] = {0, INFINITY, 0};
    const uint16_t faces[] = {(uint16_t)points[0][6].face, 0, (uint16_t)points[0][7].face, 0},
                   other[] = {1000, 0, 1, 0};
    const uint16_t above[] = {0, 1, 1, 0};
    float at[3];
    char says[100];
    hatch_curve_position(&meshes[0].mesh, &points[0][6], at);
    snprintf(says, sizeof says, "mesh 0, primitive 2: strokes: vertex 0 is not on its face %u", points[0][6].face);
    check_refused(patched(at, away, sizeof at, 0), says);
    check_refused(patched(at, infinite, sizeof at, 0), "mesh 0, primitive 2, POSITION: element 0 is not finite");
    check_refused(patched(faces, other, sizeof faces, 0), "mesh 0, primitive 2: strokes: vertex 0: face 1000 does not");
    check_refused(patched(faces, above, sizeof faces, 0),
                  "mesh 0, primitive 2: strokes: vertex 0: face 65536 does not");
}
END_TEST

/* Ends of lines as they are in the file. */
START_TEST(lines_that_jump_are_refused)
{
    static const uint16_t ends[] = {0, 1, 1, 2, 2, 3, 3, 4, 4, 5};
    static const uint16_t other[][10] = {{0, 1, 1, 2, 2, 3, 3, 5, 4, 5},
                                         {1, 2, 1, 2, 2, 3, 3, 4, 4, 5},
                                         {0, 1, 1, 2, 2, 3, 3, 4, 5, 6},
                                         {0, 1, 1, 2, 3, 2, 3, 4, 4, 5},
                                         {0, 1, 1, 2, 2, 3, 3, 4, 4, 9}};
    static const int lines[] = {3, 0, 4, 2, 4};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char says[100];
        snprintf(says, sizeof says, "mesh 0, primitive 1: strokes: line %d does not join a vertex to the next",
                 lines[i]);
        check_refused(patched(ends, other[i], sizeof ends, 0), says);
    }
}
END_TEST

/* Lines of other programs are no strokes; nor are strokes without a surface before them. */
START_TEST(other_lines_are_left_out)
{
    struct hatch_mesh_notes notes;
    struct hatch_buffer file = patched("\"family\":0", "\"fomily\":0", 10, 0);
    HATCH_TEST_OK(read_file(&file, &notes), &err);
    ck_assert_uint_eq(notes.primitives_skipped, 1);
    ck_assert_uint_eq(back.meshes[0].curves.set_count, 0);
    ck_assert_uint_eq(back.meshes[1].curves.set_count, 2);
}
END_TEST

static enum hatch_status write_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                   struct hatch_err *error)
{
    struct hatch_buffer file = {.arena = kept};
    return hatch_glb_write_scene(context, "x", temporary, &file, error);
}

static enum hatch_status read_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                  struct hatch_err *error)
{
    const struct hatch_buffer *file = context;
    struct hatch_mesh_notes notes = {0};
    return hatch_gltf_read((struct hatch_bytes){file->data, file->size}, NULL, kept, temporary, &back, &notes, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_buffer file = written(&full);
    hatch_test_fail_alloc(write_one, &full, &full, sizeof full);
    hatch_test_fail_alloc(read_one, &file, &back, sizeof back);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io glb strokes");
    TCase *tests = tcase_create("strokes");
    tcase_add_checked_fixture(tests, begin_scene, end);
    tcase_add_test(tests, strokes_survive_a_round_trip);
    tcase_add_test(tests, a_copy_of_a_copy_has_the_same_strokes);
    tcase_add_test(tests, strokes_lie_on_the_surface_at_rest);
    tcase_add_test(tests, a_large_set_has_several_primitives);
    tcase_add_test(tests, strokes_belong_to_the_surface_before_them);
    tcase_add_test(tests, no_strokes_are_no_primitives);
    tcase_add_test(tests, damaged_descriptions_are_refused);
    tcase_add_test(tests, what_finer_levels_need_may_be_missing);
    tcase_add_test(tests, strokes_tell_the_needs_that_they_were_made_for);
    tcase_add_test(tests, damaged_numbers_are_refused);
    tcase_add_test(tests, lines_that_jump_are_refused);
    tcase_add_test(tests, other_lines_are_left_out);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
