#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arenas.h"
#include "fail_alloc.h"
#include "io/glb/glb.h"
#include "io/gltf/gltf.h"
#include "io/gltf/check.h"
#include "shapes/shapes.h"

static struct hatch_scene scene;
static struct hatch_mesh_notes notes;
static struct hatch_bytes companion; /* content of every URI; size 0: missing */

static void begin_reading(void)
{
    begin();
    notes = (struct hatch_mesh_notes){0};
    companion = (struct hatch_bytes){NULL, 0};
}

static enum hatch_status resolve(void *context, const char *uri, struct hatch_arena *arena, struct hatch_bytes *bytes,
                                 struct hatch_err *error)
{
    (void)context;
    (void)arena;
    if (companion.size == 0)
        return hatch_fail(error, HATCH_IO, "%s: missing", uri);
    *bytes = companion;
    return HATCH_OK;
}

static const struct hatch_gltf_resolver resolver = {resolve, NULL};

static enum hatch_status read_scene(const void *data, size_t size)
{
    return hatch_gltf_read((struct hatch_bytes){data, size}, &resolver, &keep, &scratch, &scene, &notes, &err);
}

static void same_attribute(const struct hatch_mesh *a, const struct hatch_mesh *b, uint32_t i)
{
    const struct hatch_mesh_attribute *from = &a->attributes[i];
    const float *read = hatch_mesh_find(b, from->name, from->components);
    ck_assert_msg(read != NULL, "%s is lost", from->name);
    ck_assert_mem_eq(read, from->data, (size_t)a->vertex_count * from->components * 4);
}

static void round_trip(const struct hatch_mesh *mesh)
{
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_glb_write(mesh, "a \"name\"\n", "seed 1", &scratch, &file, &err), &err);
    HATCH_TEST_OK(read_scene(file.data, file.size), &err);
    ck_assert_uint_eq(scene.mesh_count, 1);
    ck_assert_uint_eq(scene.node_count, 1);
    const struct hatch_mesh *read = &scene.meshes[0].mesh;
    ck_assert_uint_eq(read->vertex_count, mesh->vertex_count);
    ck_assert_uint_eq(read->face_count, mesh->face_count);
    ck_assert_uint_eq(read->attribute_count, mesh->attribute_count);
    ck_assert_mem_eq(read->indices, mesh->indices, (size_t)mesh->face_count * 12);
    for (uint32_t i = 0; i < mesh->attribute_count; i++)
        same_attribute(mesh, read, i);
}

START_TEST(shapes_survive_a_round_trip_exactly)
{
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++)
        for (uint32_t faces = 50; faces <= 200000; faces *= faces < 1000 ? 100 : 40) {
            struct hatch_mesh mesh;
            const struct hatch_shape_options options = {.faces = faces, .jitter = 0.5f};
            HATCH_TEST_OK(hatch_shape_make((enum hatch_shape)shape, &options, &keep, &scratch, &mesh, &err), &err);
            round_trip(&mesh);
        }
}
END_TEST

START_TEST(every_attribute_survives_a_round_trip)
{
    static const struct {
        const char *name;
        uint32_t components;
    } extras[] = {{"NORMAL", 3},    {"TEXCOORD_1", 2}, {"COLOR_0", 4}, {"JOINTS_0", 4},
                  {"WEIGHTS_0", 4}, {"_HATCH_DIR", 4}, {"_ONE", 1}};
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3, 1, &mesh, &err), &err);
    mesh.attributes[0].data[3] = mesh.attributes[0].data[7] = 1;
    for (uint32_t i = 0; i < 3; i++)
        mesh.indices[i] = i;
    for (size_t i = 0; i < sizeof extras / sizeof *extras; i++) {
        float *data;
        HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, extras[i].name, extras[i].components, &data, &err), &err);
        for (uint32_t k = 0; k < 3 * extras[i].components; k++)
            data[k] = (float)(k + i);
    }
    round_trip(&mesh);
}
END_TEST

START_TEST(a_truncated_glb_is_refused)
{
    struct hatch_mesh mesh;
    struct hatch_buffer file = {.arena = &keep};
    const struct hatch_shape_options options = {.faces = 2};
    HATCH_TEST_OK(hatch_shape_make(HATCH_SHAPE_PLANE, &options, &keep, &scratch, &mesh, &err), &err);
    HATCH_TEST_OK(hatch_glb_write(&mesh, "p", NULL, &scratch, &file, &err), &err);
    for (size_t size = 0; size < file.size; size++)
        ck_assert_int_eq(read_scene(file.data, size), HATCH_BAD_INPUT);
    HATCH_TEST_OK(read_scene(file.data, file.size), &err);
}
END_TEST

START_TEST(zeros_at_the_end_are_no_json)
{
    static const char text[] = "\0\0{\0}\0\0";
    static const struct {
        size_t from, size, want;
    } parts[] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {2, 1, 1}, {2, 2, 1}, {2, 3, 3}, {2, 5, 3}, {0, 7, 5}};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        struct hatch_gltf_parts split;
        const struct hatch_bytes file = {(const uint8_t *)text + parts[i].from, parts[i].size};
        HATCH_TEST_OK(hatch_gltf_split(file, &split, &err), &err);
        ck_assert_ptr_eq(split.json.data, file.data);
        ck_assert_uint_eq(split.json.size, parts[i].want);
    }
}
END_TEST

/* The buffer "b.bin" of the scenes below. Byte 0: positions of a square as floats; 48: positions as shorts,
 * each followed by a colour as bytes (stride 12); 96: indices; 100: sparse indices, then values. */
static const struct {
    float positions[12];
    struct {
        int16_t position[3], spare;
        uint8_t color[4];
    } mixed[4];
    uint8_t indices[4], places[4];
    float values[6];
} buffer = {
    {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0},
    {{{0, 0, 0}, 0, {255, 0, 0, 255}},
     {{32767, 0, 0}, 0, {0, 51, 0, 255}},
     {{0, -32768, 0}, 0, {0, 0, 102, 0}},
     {{32767, 32767, 0}, 0, {0, 0, 0, 0}}},
    {0, 1, 2, 3},
    {1, 3, 0, 0},
    {7, 7, 7, 8, 8, 8},
};

#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"b.bin\",\"byteLength\":128}],"                           \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},"                                                               \
    "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48,\"byteStride\":12},"                                            \
    "{\"buffer\":0,\"byteOffset\":96,\"byteLength\":4},"                                                               \
    "{\"buffer\":0,\"byteOffset\":100,\"byteLength\":4},"                                                              \
    "{\"buffer\":0,\"byteOffset\":104,\"byteLength\":24}],"                                                            \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"                          \
    "{\"bufferView\":1,\"componentType\":5122,\"normalized\":true,\"count\":4,\"type\":\"VEC3\"},"                     \
    "{\"bufferView\":1,\"byteOffset\":8,\"componentType\":5121,\"normalized\":true,\"count\":4,"                       \
    "\"type\":\"VEC4\"},"                                                                                              \
    "{\"bufferView\":2,\"componentType\":5121,\"count\":4,\"type\":\"SCALAR\"},"                                       \
    "{\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"sparse\":{\"count\":2,"                                   \
    "\"indices\":{\"bufferView\":3,\"componentType\":5121},\"values\":{\"bufferView\":4}}},"                           \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"SCALAR\"},"                                       \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":0,\"byteOffset\":12,\"componentType\":5126,\"count\":2,\"type\":\"SCALAR\"},"                     \
    "{\"bufferView\":1,\"byteOffset\":8,\"componentType\":5121,\"count\":4,\"type\":\"VEC4\"},"                        \
    "{\"bufferView\":1,\"byteOffset\":8,\"componentType\":5121,\"count\":4,\"type\":\"SCALAR\"}]"
#define MESH(rest) HEAD ",\"meshes\":[{\"primitives\":[{" rest "}]}],\"nodes\":[{\"mesh\":0}]}"

static enum hatch_status read_text(const char *json)
{
    companion = (struct hatch_bytes){(const uint8_t *)&buffer, sizeof buffer};
    return read_scene(json, strlen(json));
}

static const struct hatch_mesh *reads(const char *json, uint32_t faces)
{
    HATCH_TEST_OK(read_text(json), &err);
    ck_assert_uint_eq(scene.mesh_count, 1);
    ck_assert_uint_eq(scene.meshes[0].mesh.face_count, faces);
    return &scene.meshes[0].mesh;
}

START_TEST(strips_become_triangles)
{
    const struct hatch_mesh *mesh = reads(MESH("\"attributes\":{\"POSITION\":0},\"indices\":3,\"mode\":5"), 2);
    /* The square is flat: its triangles share vertices and one normal. */
    ck_assert_uint_eq(mesh->vertex_count, 4);
    ck_assert_float_eq(hatch_mesh_find(mesh, "NORMAL", 3)[2], 1);
    ck_assert(!scene.meshes[0].had_normals);
    const uint32_t strip[] = {0, 1, 2, 1, 3, 2};
    ck_assert_mem_eq(mesh->indices, strip, sizeof strip);
}
END_TEST

START_TEST(fans_become_triangles)
{
    const struct hatch_mesh *mesh = reads(MESH("\"attributes\":{\"POSITION\":0,\"NORMAL\":0},\"mode\":6"), 2);
    const uint32_t fan[] = {0, 1, 2, 0, 2, 3};
    ck_assert_mem_eq(mesh->indices, fan, sizeof fan);
    ck_assert(scene.meshes[0].had_normals);
}
END_TEST

START_TEST(accessors_may_be_interleaved_and_normalised)
{
    const struct hatch_mesh *mesh =
        reads(MESH("\"attributes\":{\"POSITION\":1,\"NORMAL\":0,\"COLOR_0\":2},\"mode\":5"), 2);
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, -1, 0, 1, 1, 0};
    ck_assert_mem_eq(mesh->attributes[0].data, positions, sizeof positions);
    const float *color = hatch_mesh_find(mesh, "COLOR_0", 4);
    ck_assert_float_eq(color[0], 1);
    ck_assert_float_eq_tol(color[5], 0.2f, 1e-7f);
    ck_assert_float_eq_tol(color[10], 0.4f, 1e-7f);
}
END_TEST

START_TEST(sparse_values_replace_zeros)
{
    const struct hatch_mesh *mesh =
        reads(MESH("\"attributes\":{\"POSITION\":0,\"NORMAL\":0,\"_EXTRA\":4},\"mode\":5"), 2);
    const float want[] = {0, 0, 0, 7, 7, 7, 0, 0, 0, 8, 8, 8};
    ck_assert_mem_eq(hatch_mesh_find(mesh, "_EXTRA", 3), want, sizeof want);
}
END_TEST

/* glTF 2.0, Meshes: primitives whose positions are not given are not drawn. */
START_TEST(faces_without_positions_are_skipped_and_noted)
{
    HATCH_TEST_OK(read_text(HEAD ",\"meshes\":[{\"primitives\":["
                                 "{\"attributes\":{\"NORMAL\":0}},"
                                 "{\"attributes\":{\"POSITION\":0},\"mode\":6}]}]}"),
                  &err);
    ck_assert_uint_eq(notes.primitives_unplaced, 1);
    ck_assert_uint_eq(notes.primitives_skipped, 0);
    ck_assert_uint_eq(scene.mesh_count, 1);
}
END_TEST

START_TEST(points_and_lines_are_skipped_and_noted)
{
    HATCH_TEST_OK(read_text(HEAD ",\"meshes\":[{\"primitives\":["
                                 "{\"attributes\":{\"POSITION\":0},\"mode\":0},"
                                 "{\"attributes\":{\"POSITION\":0},\"mode\":3},"
                                 "{\"attributes\":{\"POSITION\":0},\"mode\":6,"
                                 "\"targets\":[{\"POSITION\":0}]}]}],"
                                 "\"images\":[{\"uri\":\"a.png\"}]}"),
                  &err);
    ck_assert_uint_eq(notes.primitives_skipped, 2);
    ck_assert_uint_eq(notes.morphs_ignored, 1);
    ck_assert_float_eq(scene.meshes[0].mesh.attributes[0].data[3], 1); /* a target of weight 0 */
    ck_assert_uint_eq(scene.mesh_count, 1);
    ck_assert_uint_eq(scene.textures[0].size, sizeof buffer);
    companion.size = 0;
    static const char unused[] = "{\"asset\":{\"version\":\"2.0\"},\"images\":[{\"uri\":\"a.png\"}]}";
    HATCH_TEST_OK(read_scene(unused, sizeof unused - 1), &err);
    ck_assert_uint_eq(notes.images_missing, 0); /* no material refers to it */
    ck_assert_ptr_null(scene.textures[0].data);
}
END_TEST

/* The displacements are the square's own positions: a weight of 1/2 enlarges it by half. */
START_TEST(morph_targets_are_applied_at_rest)
{
#define MORPH(mesh, node)                                                                                              \
    HEAD ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":5,\"targets\":["                     \
         "{\"NORMAL\":0},{\"POSITION\":" mesh "}]}],\"weights\":[1,0.5]}],\"nodes\":[{\"mesh\":0" node "}]}"
    ck_assert_float_eq(reads(MORPH("0", ""), 2)->attributes[0].data[3], 1.5f);
    ck_assert_float_eq(reads(MORPH("0", ",\"weights\":[0,2]"), 2)->attributes[0].data[3], 3);
    ck_assert_int_eq(read_text(MORPH("6", "")), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "mesh 0, primitive 0, target 1, POSITION: 3 elements, POSITION has 4");
}
END_TEST

START_TEST(nodes_follow_their_parents)
{
    HATCH_TEST_OK(read_text(HEAD ",\"scene\":0,\"scenes\":[{\"nodes\":[2]}],\"cameras\":[{\"type\":\"perspective\","
                                 "\"perspective\":{\"yfov\":0.5,\"znear\":0.1}}],"
                                 "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"spot\","
                                 "\"spot\":{\"outerConeAngle\":0.5},\"intensity\":3,\"color\":[1,0.5,0]}]}},"
                                 "\"nodes\":[{\"camera\":0},{\"children\":[0],\"translation\":[1,2,3]},"
                                 "{\"children\":[1,4],\"rotation\":[0,2,0,0]},{},"
                                 "{\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}}]}"),
                  &err);
    ck_assert_uint_eq(scene.node_count, 4); /* node 3 is in no scene */
    const uint32_t parents[] = {HATCH_NONE, 0, 0, 1};
    for (int i = 0; i < 4; i++)
        ck_assert_uint_eq(scene.nodes[i].parent, parents[i]);
    ck_assert_double_eq(scene.nodes[0].rotation[1], 1); /* normalised */
    ck_assert_double_eq(scene.nodes[1].translation[2], 3);
    ck_assert_uint_eq(scene.nodes[2].light, 0);
    ck_assert_uint_eq(scene.nodes[3].camera, 0);
    ck_assert_float_eq(scene.cameras[0].zfar, 0);
    ck_assert_int_eq(scene.lights[0].type, HATCH_LIGHT_SPOT);
    ck_assert_float_eq(scene.lights[0].color[1], 0.5f);
}
END_TEST

#define ANIMATED(channel)                                                                                              \
    HEAD ",\"nodes\":[{},{\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],"                                             \
         "\"skins\":[{\"joints\":[0]}],\"animations\":[{\"channels\":[{\"sampler\":0,"                                 \
         "\"target\":{" channel "}}],\"samplers\":[{\"input\":7,\"output\":6}]}]}"

START_TEST(animations_are_checked)
{
    ck_assert_int_eq(read_text(ANIMATED("\"node\":0,\"path\":\"translation\"")), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "animation 0, channel 0: time 1 is negative or less than the previous one");
    HATCH_TEST_OK(read_text(ANIMATED("\"node\":0,\"path\":\"weights\"")), &err);
    ck_assert_uint_eq(scene.animations[0].channel_count, 0);
    ck_assert_float_eq(scene.skins[0].inverse_bind[15], 1);
    ck_assert_float_eq(scene.skins[0].inverse_bind[14], 0);
}
END_TEST

#define SKINNED(joints)                                                                                                \
    HEAD ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":0,\"JOINTS_0\":" joints             \
         "},\"mode\":5}]}],\"skins\":[{\"joints\":[0]}],\"nodes\":[{\"mesh\":0,\"skin\":0}]}"

START_TEST(joints_are_checked_and_zero_normals_replaced)
{
    /* The buffer's colours as joints: normalised ones are not integers, and 255 exceeds the skin's joints. */
    ck_assert_int_eq(read_text(SKINNED("2")), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, "JOINTS_0: element 1") != NULL, "%s", err.text);
    ck_assert_int_eq(read_text(SKINNED("8")), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, "refers to joint 255, its skin has 1") != NULL, "%s", err.text);
    const struct hatch_mesh *mesh = reads(MESH("\"attributes\":{\"POSITION\":0,\"NORMAL\":4},\"mode\":5"), 2);
    const float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    const float want[] = {0, 0, 1, 7, 7, 7};
    ck_assert_mem_eq(normals, want, sizeof want);
}
END_TEST

static void refused(const char *json, const char *place)
{
    struct hatch_scene before = scene;
    ck_assert_msg(read_text(json) == HATCH_BAD_INPUT, "'%s' is not refused", place);
    ck_assert_msg(strstr(err.text, place) != NULL, "'%s' does not say '%s'", err.text, place);
    ck_assert_mem_eq(&before, &scene, sizeof scene);
}

START_TEST(errors_name_their_place)
{
    memset(&scene, 0, sizeof scene);
    refused("{    }", "asset");
    refused("{\"asset\":{\"version\":\"1.0\"}}", "glTF version 1.0");
    refused("{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"X_Y\"]}", "X_Y");
    refused("{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"KHR_materials_\"]}", "KHR_materials_ is not");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"children\":[1]},{\"children\":[0]}],"
            "\"scenes\":[{\"nodes\":[0]}]}",
            "node 0 is not a root");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"children\":[1]},{},{\"children\":[1]}]}",
            "node 1: has two parents");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}],\"scenes\":[{\"nodes\":[0,0]}]}",
            "node 0 is listed twice");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"children\":[7]}]}", "node 0: child 7");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0}]}", "node 0: mesh 0");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":4294967296}]}", "mesh is 4294967296");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":\"0\"}]}", "mesh is \"0");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"scale\":[1,2]}]}", "scale: 2 values, want 3");
    refused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"rotation\":[0,0,0,0]}]}", "rotation is zero");
    refused("{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":4,\"uri\":\"../x\"}]}", "../x is outside");
    refused("{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":4,\"uri\":\"%2e%2e/x\"}]}",
            "../x is outside");
    refused("{\"asset\":{\"version\":\"2.0\"},\"images\":[{\"uri\":\"/etc/passwd\"}]}", "is outside");
    refused(MESH("\"attributes\":{\"POSITION\":19}"), "POSITION: accessor 19");
    refused(MESH("\"attributes\":{\"POSITION\":0},\"indices\":9,\"mode\":5"), "index 0 is the primitive restart value");
    refused(MESH("\"attributes\":{\"POSITION\":2}"), "POSITION: 4 components, want 3");
    refused(MESH("\"attributes\":{\"POSITION\":0,\"NORMAL\":6}"), "NORMAL: 3 elements");
    refused(MESH("\"attributes\":{\"POSITION\":0}"), "4 corners do not form triangles");
    refused(MESH("\"attributes\":{\"POSITION\":0},\"indices\":0,\"mode\":5"), "unsigned integers");
    /* The first index beyond three vertices, of one primitive and of two that share them. */
#define BEYOND "\"attributes\":{\"POSITION\":6},\"indices\":3,\"mode\":5"
    refused(MESH(BEYOND), "primitive 0: index 3");
    refused(MESH(BEYOND "},{" BEYOND), "primitive 0: index 3");
    refused(MESH("\"attributes\":{\"POSITION\":0},\"material\":3,\"mode\":5"), "material 3");
    refused(MESH("\"attributes\":{\"POSITION\":0},\"mode\":7"), "mode 7");
}
END_TEST

START_TEST(a_buffer_file_may_be_longer_but_not_shorter)
{
    static const char two[] = "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":7,\"uri\":\"a\"},"
                              "{\"byteLength\":3,\"uri\":\"data:application/octet-stream;base64,AAAA\"},"
                              "{\"uri\":\"b\",\"byteLength\":9}],\"images\":[{\"uri\":\"c\"}]}";
    companion = (struct hatch_bytes){(const uint8_t *)&buffer, 10};
    HATCH_TEST_OK(read_scene(two, sizeof two - 1), &err);
    ck_assert_uint_eq(scene.textures[0].size, 10);
    companion.size = 8;
    ck_assert_int_eq(read_scene(two, sizeof two - 1), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "b has 8 bytes, but its byteLength is 9");
}
END_TEST

START_TEST(uris_stay_in_their_folder)
{
    static const char *const inside[] = {"a", "a/b.bin", "..a/b..", "a/...", "./a", " "};
    static const char *const outside[] = {"",          "/a",    "..",       "../a",       "a/..",
                                          "a/../../b", "c:\\a", "a\\..\\b", "http://x/y", "file:a"};
    for (size_t i = 0; i < sizeof inside / sizeof *inside; i++)
        ck_assert_msg(hatch_gltf_uri_is_local(inside[i]), "%s", inside[i]);
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++)
        ck_assert_msg(!hatch_gltf_uri_is_local(outside[i]), "%s", outside[i]);
}
END_TEST

static enum hatch_status check(const char *json)
{
    return hatch_gltf_check_json((struct hatch_bytes){(const uint8_t *)json, strlen(json)}, NULL, &err);
}

START_TEST(json_is_checked_before_it_is_parsed)
{
    char deep[200];
    for (int depth = 1; depth < 90; depth++) {
        memset(deep, '[', (size_t)depth);
        memset(deep + depth, ']', (size_t)depth);
        deep[2 * depth] = '\0';
        ck_assert_int_eq(check(deep), depth <= 64 ? HATCH_OK : HATCH_BAD_INPUT);
    }
    ck_assert_int_eq(check("{\"a\":\"[[\\\"[[\",\"count\":3}"), HATCH_OK);
    ck_assert_int_eq(check("{\"count\":2147483648}"), HATCH_BAD_INPUT);
    ck_assert_int_eq(check("{\"byteOffset\":2147483648}"), HATCH_OK);
    ck_assert_int_eq(check("{\"byteOffset\":-1}"), HATCH_BAD_INPUT);
    ck_assert_int_eq(check("{\"count\":3.0}"), HATCH_BAD_INPUT);
    ck_assert_int_eq(check("{\"nodes\":[1,2.5]}"), HATCH_BAD_INPUT);
    ck_assert_int_eq(check("{\"attributes\":{\"_X\":1e3}}"), HATCH_BAD_INPUT);
    ck_assert_int_eq(check("{\"extras\":{\"count\":1e3,\"x\":{\"mesh\":null}}}"), HATCH_OK);
    ck_assert_int_eq(check("{\"extensions\":{\"X\":{\"mode\":\"a\"}}}"), HATCH_OK);
    ck_assert_int_eq(check("{\"extensions\":{\"X\":{\"light\":-1}}}"), HATCH_BAD_INPUT);
    ck_assert_int_eq(check("{\"translation\":[5000000000,1e9,-3]}"), HATCH_OK);
    ck_assert_int_eq(check("\"\\"), HATCH_OK); /* the parser checks syntax */
    ck_assert_int_eq(check("]]]}}}"), HATCH_OK);
}
END_TEST

static enum hatch_status read_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                  struct hatch_err *error)
{
    struct hatch_mesh_notes noted = {0};
    const char *json = context;
    return hatch_gltf_read((struct hatch_bytes){(const uint8_t *)json, strlen(json)}, &resolver, kept, temporary,
                           &scene, &noted, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    static char flat[] = MESH("\"attributes\":{\"POSITION\":0,\"_EXTRA\":4},\"indices\":3,\"mode\":5");
    static char animated[] = ANIMATED("\"node\":0,\"path\":\"weights\"");
    companion = (struct hatch_bytes){(const uint8_t *)&buffer, sizeof buffer};
    memset(&scene, 0, sizeof scene);
    hatch_test_fail_alloc(read_one, flat, &scene, sizeof scene);
    hatch_test_fail_alloc(read_one, animated, &scene, sizeof scene);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io gltf");
    TCase *tests = tcase_create("gltf");
    tcase_add_checked_fixture(tests, begin_reading, end);
    tcase_add_test(tests, shapes_survive_a_round_trip_exactly);
    tcase_add_test(tests, every_attribute_survives_a_round_trip);
    tcase_add_test(tests, a_truncated_glb_is_refused);
    tcase_add_test(tests, zeros_at_the_end_are_no_json);
    tcase_add_test(tests, strips_become_triangles);
    tcase_add_test(tests, fans_become_triangles);
    tcase_add_test(tests, accessors_may_be_interleaved_and_normalised);
    tcase_add_test(tests, sparse_values_replace_zeros);
    tcase_add_test(tests, faces_without_positions_are_skipped_and_noted);
    tcase_add_test(tests, points_and_lines_are_skipped_and_noted);
    tcase_add_test(tests, morph_targets_are_applied_at_rest);
    tcase_add_test(tests, nodes_follow_their_parents);
    tcase_add_test(tests, animations_are_checked);
    tcase_add_test(tests, joints_are_checked_and_zero_normals_replaced);
    tcase_add_test(tests, errors_name_their_place);
    tcase_add_test(tests, a_buffer_file_may_be_longer_but_not_shorter);
    tcase_add_test(tests, uris_stay_in_their_folder);
    tcase_add_test(tests, json_is_checked_before_it_is_parsed);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
