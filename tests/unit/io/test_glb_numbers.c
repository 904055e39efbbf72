/* Vertices whose numbers are written as integers: how far off they are read back. */
#include <stdio.h>
#include <string.h>

#include "fail_alloc.h"
#include "io/glb/glb.h"
#include "io/gltf/gltf.h"
#include "meshes.h"

static struct hatch_scene scene, back;

static void begin_torus(float rounding)
{
    static struct hatch_scene_mesh mesh;
    static struct hatch_node node;
    const struct hatch_shape_options options = {.faces = 400, .field = true};
    mesh = (struct hatch_scene_mesh){.material = HATCH_NONE};
    HATCH_TEST_OK(hatch_shape_make(HATCH_SHAPE_TORUS, &options, &keep, &scratch, &mesh.mesh, &err), &err);
    node = (struct hatch_node){.parent = HATCH_NONE,
                               .rotation = {0, 0, 0, 1},
                               .scale = {1, 1, 1},
                               .mesh_count = 1,
                               .skin = HATCH_NONE,
                               .camera = HATCH_NONE,
                               .light = HATCH_NONE};
    scene =
        (struct hatch_scene){.meshes = &mesh, .mesh_count = 1, .nodes = &node, .node_count = 1, .rounding = rounding};
}

static struct hatch_buffer written(void)
{
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_glb_write_scene(&scene, NULL, &scratch, &file, &err), &err);
    return file;
}

/* Returns whether the JSON of a file has a text. */
static bool has_text(struct hatch_buffer file, const char *text)
{
    uint32_t length;
    memcpy(&length, file.data + 12, sizeof length);
    for (size_t i = 20; i + strlen(text) <= 20 + (size_t)length; i++)
        if (memcmp(file.data + i, text, strlen(text)) == 0)
            return true;
    return false;
}

/* Returns the greatest distance between vectors of an attribute that is read back and the scene's. */
static double off(struct hatch_buffer file, const char *name)
{
    struct hatch_mesh_notes notes = {0};
    HATCH_TEST_OK(
        hatch_gltf_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &back, &notes, &err), &err);
    const struct hatch_mesh_attribute *was = hatch_mesh_attribute(&scene.meshes[0].mesh, name);
    const struct hatch_mesh_attribute *is = hatch_mesh_attribute(&back.meshes[0].mesh, name);
    double most = 0;
    ck_assert_uint_eq(is->components, was->components);
    ck_assert_uint_eq(back.meshes[0].mesh.vertex_count, scene.meshes[0].mesh.vertex_count);
    for (size_t v = 0; v < scene.meshes[0].mesh.vertex_count; v++) {
        double sum = 0;
        for (size_t c = v * was->components; c < (v + 1) * was->components; c++) {
            double apart = (double)is->data[c] - (double)was->data[c];
            sum += apart * apart;
        }
        most = fmax(most, sqrt(sum));
    }
    return most;
}

static float *numbers_of(const char *name)
{
    return hatch_mesh_attribute(&scene.meshes[0].mesh, name)->data;
}

START_TEST(numbers_are_exact_without_rounding)
{
    static const char *const names[] = {"POSITION", "NORMAL", "TEXCOORD_0", "TANGENT", "_HATCH_DIR"};
    begin_torus(0);
    struct hatch_buffer file = written();
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        ck_assert(off(file, names[i]) <= 0);
    ck_assert(!has_text(file, "normalized") && !has_text(file, "KHR_mesh_quantization"));
}
END_TEST

/* Attributes of strokes are whole numbers of 16 bits; those of the same name that hold others stay as they are. */
START_TEST(numbers_that_are_not_whole_stay_floats)
{
    static const float values[][3] = {{-1, 0.5f, 70000}, {0, 1, 65535}};
    for (int whole = 0; whole < 2; whole++) {
        float *data;
        begin_torus(0);
        HATCH_TEST_OK(hatch_mesh_add(&keep, &scene.meshes[0].mesh, "_HATCH_FACE", 1, &data, &err), &err);
        memcpy(data, values[whole], sizeof values[whole]);
        struct hatch_buffer file = written();
        ck_assert(off(file, "_HATCH_FACE") <= 0);
        char text[100];
        snprintf(text, sizeof text, "\"componentType\":5123,\"count\":%u,\"type\":\"SCALAR\"",
                 scene.meshes[0].mesh.vertex_count);
        ck_assert_int_eq(has_text(file, text), whole);
    }
}
END_TEST

/* Numbers of 8 bits are off by half of 1/127 each, those of 16 by half of 1/32767. */
START_TEST(vectors_are_off_by_no_more_than_the_rounding)
{
    static const float roundings[] = {0.01f, 0.0069f, 0.0068f, 0.001f};
    for (int i = 0; i < 4; i++) {
        bool fine = i >= 2;
        begin_torus(roundings[i]);
        struct hatch_buffer file = written();
        ck_assert(off(file, "POSITION") <= 0);
        double normal = off(file, "NORMAL"), direction = off(file, "_HATCH_DIR");
        ck_assert_double_le(normal, (double)roundings[i]);
        ck_assert_double_le(direction, (double)roundings[i]);
        ck_assert_double_le(normal, fine ? 0.5 / 32767 * 1.74 : 0.5 / 127 * 1.74);
        ck_assert_double_gt(normal, fine ? 0.3 / 32767 : 0.3 / 127);
        ck_assert(has_text(file, fine ? "\"componentType\":5122" : "\"componentType\":5120"));
        ck_assert(has_text(file, "\"extensionsRequired\":[\"KHR_mesh_quantization\"]"));
        ck_assert(has_text(file, fine ? "\"byteStride\":8" : "\"byteStride\":4"));
    }
}
END_TEST

/* Texture coordinates from 0 to 1 have no sign; others up to -1 have one; beyond they stay floats. */
START_TEST(texture_coordinates_have_16_bits_where_they_fit)
{
    static const float lowest[] = {0, -0.5f, -1, -1.5f};
    static const double allowed[] = {0.5 / 65535, 0.5 / 32767, 0.5 / 32767, 0};
    for (int i = 0; i < 4; i++) {
        begin_torus(0.01f);
        float *uv = numbers_of("TEXCOORD_0");
        for (size_t k = 0; k < 2 * (size_t)scene.meshes[0].mesh.vertex_count; k++)
            uv[k] = lowest[i] + (1 - lowest[i]) * uv[k] / (k % 2 ? 4 : 10);
        double most = off(written(), "TEXCOORD_0");
        ck_assert_double_le(most, 1.42 * allowed[i]);
        ck_assert(i == 3 || most > 0.3 * allowed[i]);
    }
}
END_TEST

/* Faces of a torus are .43 tiles wide: 280 steps of rounding where a tile is .01, 7 where it is .00025. One face that
 * would have no area is enough. */
START_TEST(texture_coordinates_of_small_faces_stay_floats)
{
    static const float size[] = {0.01f, 0.00025f, 0.01f};
    for (int i = 0; i < 3; i++) {
        begin_torus(0.01f);
        float *uv = numbers_of("TEXCOORD_0");
        for (size_t k = 0; k < 2 * (size_t)scene.meshes[0].mesh.vertex_count; k++)
            uv[k] *= size[i];
        const uint32_t *corner = scene.meshes[0].mesh.indices;
        for (size_t k = 0; k < 2 && i == 2; k++)
            uv[2 * corner[2] + k] = uv[2 * corner[0] + k] + (float)k * 1e-7f;
        double most = off(written(), "TEXCOORD_0");
        ck_assert_int_eq(most > 0, i == 0);
    }
}
END_TEST

START_TEST(vectors_over_one_stay_floats)
{
    begin_torus(0.01f);
    numbers_of("_HATCH_DIR")[3] = 1.5f;
    ck_assert(off(written(), "_HATCH_DIR") <= 0);
}
END_TEST

/* Two sets of joints of the first four vertices: two joints in one set each; five joints; one joint in both sets; none
 * with a weight. */
static const float joints[2][16] = {{5, 0, 0, 0, 0, 1, 2, 3, 3, 0, 0, 0, 7, 0, 0, 0},
                                    {1, 0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0}};
static const float weights[2][16] = {{0.75f, 0, 0, 0, 0.1f, 0.2f, 0.3f, 0.25f, 0.5f},
                                     {0.25f, 0, 0, 0, 0.15f, 0, 0, 0, 0.5f}};

START_TEST(the_heaviest_four_joints_of_all_sets_are_read)
{
    static const char *const names[2][2] = {{"JOINTS_0", "WEIGHTS_0"}, {"JOINTS_1", "WEIGHTS_1"}};
    static const float want_joints[] = {5, 1, 0, 0, 2, 3, 1, 4, 3, 0, 0, 0, 7, 0, 0, 0};
    static const float want_weights[] = {0.75f, 0.25f, 0, 0, 0.3f / 0.9f, 0.25f / 0.9f, 0.2f / 0.9f, 0.15f / 0.9f, 1};
    struct hatch_mesh_notes notes = {0};
    float *data;
    begin_torus(0);
    for (int set = 0; set < 2; set++)
        for (int k = 0; k < 2; k++) {
            HATCH_TEST_OK(hatch_mesh_add(&keep, &scene.meshes[0].mesh, names[set][k], 4, &data, &err), &err);
            memcpy(data, k ? weights[set] : joints[set], sizeof joints[set]);
        }
    struct hatch_buffer file = written();
    HATCH_TEST_OK(
        hatch_gltf_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &back, &notes, &err), &err);
    const struct hatch_mesh *mesh = &back.meshes[0].mesh;
    ck_assert_mem_eq(hatch_mesh_find(mesh, "JOINTS_0", 4), want_joints, sizeof want_joints);
    for (int i = 0; i < 9; i++)
        ck_assert_float_eq_tol(hatch_mesh_find(mesh, "WEIGHTS_0", 4)[i], want_weights[i], 1e-6f);
    ck_assert_mem_eq(hatch_mesh_find(mesh, "WEIGHTS_0", 4), want_weights, 4 * sizeof(float));
    ck_assert(!hatch_mesh_attribute(mesh, "JOINTS_1") && !hatch_mesh_attribute(mesh, "WEIGHTS_1"));
    ck_assert_uint_eq(mesh->attribute_count, scene.meshes[0].mesh.attribute_count - 2);
    ck_assert_uint_eq(notes.joints_dropped, 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io glb numbers");
    TCase *tests = tcase_create("numbers");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, numbers_are_exact_without_rounding);
    tcase_add_test(tests, numbers_that_are_not_whole_stay_floats);
    tcase_add_test(tests, vectors_are_off_by_no_more_than_the_rounding);
    tcase_add_test(tests, texture_coordinates_have_16_bits_where_they_fit);
    tcase_add_test(tests, texture_coordinates_of_small_faces_stay_floats);
    tcase_add_test(tests, vectors_over_one_stay_floats);
    tcase_add_test(tests, the_heaviest_four_joints_of_all_sets_are_read);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
