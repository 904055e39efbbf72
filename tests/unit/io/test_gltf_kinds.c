/* glTF features that few exporters write, each in a minimal file. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arenas.h"
#include "io/glb/glb.h"
#include "io/gltf/check.h"
#include "io/gltf/gltf.h"

static struct hatch_scene scene;
static struct hatch_mesh_notes notes;

/* Content of "d.bin", the companion of every file here. */
static const struct {
    float square[12];
    float raised[3];
    uint16_t corners[6], places[2], indices[2];
    float translations[9], rotations[12];
    float times[3], values[9];
    uint8_t numbers[5][3][4]; /* little-endian ones of each type, the largest first */
} data = {{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0},
          {0, 0, 5},
          {0, 1, 2, 0, 0, 0},
          {3, 4},
          {2, 1},
          {2, 0, 0, 4, 0, 0, 6, 0, 0},
          {0, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 1},
          {0, 1, 1},
          {0, 0, 0, 1, 0, 0, 8, 0, 0},
          {{{127}, {0x80}, {0x81}},
           {{255}, {51}, {0}},
           {{0xff, 0x7f}, {0x00, 0x80}, {0x01, 0x80}},
           {{0xff, 0xff}, {0x33, 0x33}, {0}},
           {{0xff, 0xff, 0xff, 0xff}, {0x33, 0x33, 0x33, 0x33}, {0}}}};

static enum hatch_status resolve(void *context, const char *uri, struct hatch_arena *arena, struct hatch_bytes *bytes,
                                 struct hatch_err *error)
{
    (void)context;
    (void)arena;
    if (strcmp(uri, "d.bin") != 0)
        return hatch_fail(error, HATCH_IO, "%s: missing", uri);
    *bytes = (struct hatch_bytes){(const uint8_t *)&data, sizeof data};
    return HATCH_OK;
}

static const struct hatch_gltf_resolver resolver = {resolve, NULL};

/* Accessors: 0 a square, 1 the square with a corner raised by a sparse value, 2 indices, two of them sparse,
 * 3 translations, 4 rotations, 5 times, 6 values, 7 two translations, 8 many zeros without a view. */
#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"d.bin\",\"byteLength\":212}],\"bufferViews\":["          \
    "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12},"                             \
    "{\"buffer\":0,\"byteOffset\":60,\"byteLength\":12},{\"buffer\":0,\"byteOffset\":72,\"byteLength\":4},"            \
    "{\"buffer\":0,\"byteOffset\":76,\"byteLength\":4},{\"buffer\":0,\"byteOffset\":80,\"byteLength\":36},"            \
    "{\"buffer\":0,\"byteOffset\":116,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":164,\"byteLength\":48}],"        \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"                          \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"sparse\":{\"count\":1,"                  \
    "\"indices\":{\"bufferView\":3,\"componentType\":5123},\"values\":{\"bufferView\":1}}},"                           \
    "{\"bufferView\":2,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\",\"sparse\":{\"count\":2,"                \
    "\"indices\":{\"bufferView\":3,\"componentType\":5123},\"values\":{\"bufferView\":4}}},"                           \
    "{\"bufferView\":5,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":6,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"},"                                         \
    "{\"bufferView\":7,\"componentType\":5126,\"count\":3,\"type\":\"SCALAR\"},"                                       \
    "{\"bufferView\":7,\"byteOffset\":12,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                       \
    "{\"bufferView\":5,\"componentType\":5126,\"count\":2,\"type\":\"VEC3\"},"                                         \
    "{\"componentType\":5126,\"count\":99999,\"type\":\"VEC3\"}]"
#define SQUARE(rest) ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" rest "}]}]"

static enum hatch_status read_bytes(const void *bytes, size_t size)
{
    notes = (struct hatch_mesh_notes){0};
    return hatch_gltf_read((struct hatch_bytes){bytes, size}, &resolver, &keep, &scratch, &scene, &notes, &err);
}

static void reads(const char *json)
{
    HATCH_TEST_OK(read_bytes(json, strlen(json)), &err);
}

static void refuses(const char *json, const char *sentence)
{
    ck_assert_int_eq(read_bytes(json, strlen(json)), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, sentence);
}

START_TEST(indices_may_be_sparse)
{
    static const uint32_t both[] = {0, 1, 2, 2, 1, 0};
    reads(HEAD SQUARE("0,\"NORMAL\":0},\"indices\":2") ",\"nodes\":[{\"mesh\":0}]}");
    ck_assert_mem_eq(scene.meshes[0].mesh.indices, both, sizeof both);
}
END_TEST

START_TEST(positions_may_be_sparse)
{
    reads(HEAD SQUARE("1},\"mode\":5") ",\"nodes\":[{\"mesh\":0}]}");
    ck_assert_float_eq(hatch_mesh_find(&scene.meshes[0].mesh, "POSITION", 3)[11], 5);
}
END_TEST

/* The largest number of each type is 1 when normalised, and the least of a signed one as much as its negative. */
START_TEST(numbers_may_be_of_any_type)
{
    static const struct {
        double plain[3], normalised[3];
    } want[] = {{{127, -128, -127}, {1, -1, -1}},
                {{255, 51, 0}, {1, 0.2, 0}},
                {{32767, -32768, -32767}, {1, -1, -1}},
                {{65535, 13107, 0}, {1, 0.2, 0}},
                {{4294967295.0, 858993459, 0}, {1, 0.2, 0}}};
    for (int normalised = 0; normalised < 2; normalised++) {
        char json[1000];
        snprintf(json, sizeof json,
                 "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"d.bin\",\"byteLength\":272}],"
                 "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},"
                 "{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":12,\"byteStride\":4}],\"accessors\":["
                 "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
                 "{\"bufferView\":1,\"componentType\":%d,\"normalized\":%s,\"count\":3,\"type\":\"SCALAR\"}]" SQUARE(
                     "0,\"_NUMBER\":1}") ",\"nodes\":[{\"mesh\":0}]}",
                 212 + 12 * _i, _i < 4 ? 5120 + _i : 5125, normalised ? "true" : "false");
        reads(json);
        const float *numbers = hatch_mesh_find(&scene.meshes[0].mesh, "_NUMBER", 1);
        ck_assert_ptr_nonnull(numbers);
        for (int k = 0; k < 3; k++)
            ck_assert_float_eq(numbers[k], (float)(normalised ? want[_i].normalised[k] : want[_i].plain[k]));
    }
}
END_TEST

#define INSTANCES(attributes)                                                                                          \
    ",\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"],\"nodes\":[{\"translation\":[0,7,0],\"mesh\":0,"            \
    "\"children\":[1],\"extensions\":{\"EXT_mesh_gpu_instancing\":{\"attributes\":{" attributes "}}}},{}]}"

START_TEST(instances_are_nodes)
{
    reads(HEAD SQUARE("0},\"mode\":5") INSTANCES("\"TRANSLATION\":3,\"ROTATION\":4"));
    ck_assert_uint_eq(scene.node_count, 5);
    ck_assert_uint_eq(scene.nodes[0].mesh_count, 0);
    for (uint32_t i = 2; i < 5; i++) {
        ck_assert_uint_eq(scene.nodes[i].parent, 0);
        ck_assert_uint_eq(scene.nodes[i].mesh_count, 1);
        ck_assert_double_eq(scene.nodes[i].translation[0], 2 * (i - 1.0));
        ck_assert_double_eq(scene.nodes[i].scale[2], 1);
    }
    ck_assert_double_eq(scene.nodes[3].rotation[2], 1); /* normalised */
    double world[5 * 16];
    hatch_scene_pose(&scene, HATCH_NONE, 0, world);
    ck_assert_double_eq(world[4 * 16 + 12], 6);
    ck_assert_double_eq(world[4 * 16 + 13], 7);
    refuses(HEAD SQUARE("0},\"mode\":5") INSTANCES("\"TRANSLATION\":7,\"ROTATION\":4"),
            "node 0, instances' ROTATION: 3 elements, other attributes have 2");
    refuses(HEAD SQUARE("0},\"mode\":5") INSTANCES("\"TRANSLATION\":8"),
            "node 0, instances' TRANSLATION: its accessor has no buffer view");
}
END_TEST

/* The shape at rest is that of the first node. */
START_TEST(instances_have_the_weights_of_their_node)
{
    reads(HEAD SQUARE("0},\"mode\":5,\"targets\":[{\"POSITION\":0}]") ",\"nodes\":[{\"mesh\":0,\"weights\":[0.25]},{"
                                                                      "\"mesh\":0,\"weights\":[1],\"extensions\":{"
                                                                      "\"EXT_mesh_gpu_instancing\":{\"attributes\":{"
                                                                      "\"TRANSLATION\":3}}}}]}");
    ck_assert_uint_eq(scene.node_count, 5);
    for (uint32_t i = 2; i < 5; i++) {
        double weight;
        hatch_scene_weights(&scene, i, HATCH_NONE, 0, 1, &weight);
        ck_assert_double_eq(weight, 0.75);
    }
}
END_TEST

/* Each instance is moved as its node would be. */
START_TEST(instances_are_animated_with_their_node)
{
    reads(HEAD SQUARE("0},\"mode\":5,\"targets\":[{\"POSITION\":0}]") ",\"nodes\":[{\"mesh\":0,\"extensions\":{"
                                                                      "\"EXT_mesh_gpu_instancing\":{\"attributes\":{"
                                                                      "\"TRANSLATION\":3}}}},{\"mesh\":0}],"
                                                                      "\"animations\":[{\"channels\":[{\"sampler\":0,"
                                                                      "\"target\":{\"node\":0,\"path\":\"weights\"}}],"
                                                                      "\"samplers\":[{\"input\":5,\"output\":5}]}]}");
    ck_assert_uint_eq(scene.animations[0].channel_count, 3);
    for (uint32_t i = 1; i < 5; i++) {
        double rest, weight;
        hatch_scene_weights(&scene, i, HATCH_NONE, 0, 1, &rest);
        hatch_scene_weights(&scene, i, 0, 0.5, 1, &weight);
        ck_assert_double_eq(weight - rest, i == 1 ? 0 : 0.5);
    }
}
END_TEST

/* A jump. */
START_TEST(two_keys_may_have_one_time)
{
    reads(HEAD ",\"nodes\":[{}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":"
               "\"translation\"}}],\"samplers\":[{\"input\":5,\"output\":6}]}]}");
    double world[16];
    hatch_scene_pose(&scene, 0, 0.5, world);
    ck_assert_double_eq(world[12], 0.5);
    hatch_scene_pose(&scene, 0, 1, world);
    ck_assert_double_eq(world[12], 8);
}
END_TEST

/* The message names the extension, although the buffer is wrong, too. */
START_TEST(required_extensions_are_checked_first)
{
    refuses("{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":9}],\"extensionsRequired\":["
            "\"KHR_texture_transform\",\"KHR_draco_mesh_compression\"]}",
            "extensionsRequired: KHR_draco_mesh_compression is not supported");
    reads("{\"asset\":{\"version\":\"2.0\"},\"extras\":{\"extensionsRequired\":[\"none\"]}}");
}
END_TEST

/* The names and the commas between them fill the 191 characters; with one more, the last name has no room, but counts.
 */
START_TEST(extensions_that_are_left_out_are_named_while_there_is_room)
{
    for (int more = 0; more < 2; more++) {
        char json[400], want[400];
        snprintf(want, sizeof want, "W, X_%060d, X_%060d, X_%0*d%s", 1, 2, 55 + more, 3, more ? "" : ", Y");
        snprintf(
            json, sizeof json,
            "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"W\",\"X_%060d\",\"X_%060d\",\"X_%0*d\",\"Y\"]}", 1,
            2, 55 + more, 3);
        reads(json);
        ck_assert_uint_eq(notes.extensions_dropped, 5);
        ck_assert_str_eq(notes.extension_dropped, want);
        ck_assert_uint_eq(strlen(want), more ? 189 : sizeof notes.extension_dropped - 1);
    }
}
END_TEST

/* Buffers in files have a URI of their own that holds no data; a fallback may have one or none. */
START_TEST(buffers_in_files_and_fallbacks_are_listed)
{
#define FALLBACK(is) "\"byteLength\":8,\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":" is "}}}"
    static const char json[] =
        "{\"images\":[{\"uri\":\"c\"}],\"buffers\":[{\"byteLength\":5},{\"byteLength\":7,"
        "\"uri\":\"a\"},{\"uri\":\"data:,AAAA\",\"byteLength\":3},{" FALLBACK(
            "true") ","
                    "{\"byteLength\":6},{\"uri\":\"b\",\"byteLength\":9,\"extras\":{\"uri\":\"data:,A\"}},"
                    "{\"uri\":\"d\"," FALLBACK("true") ",{\"uri\":\"e\"," FALLBACK("false") "]}";
    static const uint64_t lengths[] = {7, 9, 8};
    static const char *const fallbacks[] = {"{" FALLBACK("true"), "{\"uri\":\"d\"," FALLBACK("true")};
    struct hatch_gltf_buffers found = {{.arena = &keep}, {.arena = &keep}};
    const struct hatch_bytes bytes = {(const uint8_t *)json, sizeof json - 1};
    HATCH_TEST_OK(hatch_gltf_check_json(bytes, &found, &err), &err);
    ck_assert_uint_eq(found.lengths.size, sizeof lengths);
    ck_assert_mem_eq(found.lengths.data, lengths, sizeof lengths);
    ck_assert_uint_eq(found.fallbacks.size, 2 * sizeof(struct hatch_gltf_range));
    for (size_t i = 0; i < 2; i++) {
        struct hatch_gltf_range range;
        memcpy(&range, found.fallbacks.data + i * sizeof range, sizeof range);
        ck_assert_uint_eq(range.end - range.start, strlen(fallbacks[i]));
        ck_assert_mem_eq(json + range.start, fallbacks[i], range.end - range.start);
    }
}
END_TEST

START_TEST(trailing_zeros_are_ignored)
{
    char json[64] = "{\"asset\":{\"version\":\"2.0\"}}";
    HATCH_TEST_OK(read_bytes(json, sizeof json), &err);
    struct hatch_buffer file = {.arena = &keep};
    const struct hatch_scene nothing = {0};
    HATCH_TEST_OK(hatch_glb_write_scene(&nothing, NULL, &scratch, &file, &err), &err);
    HATCH_TEST_OK(hatch_buffer_add(&file, "\0\0\0\0\0", 5, &err), &err);
    HATCH_TEST_OK(read_bytes(file.data, file.size), &err);
    file.data[file.size - 1] = 1;
    ck_assert_int_eq(read_bytes(file.data, file.size), HATCH_BAD_INPUT);
}
END_TEST

#define MATERIALS(material)                                                                                            \
    "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"KHR_texture_basisu\",\"EXT_texture_webp\"],"           \
    "\"images\":[{\"uri\":\"data:image/png;base64,AAAA\"},{\"uri\":\"data:image/webp,AAAA\",\"name\":"                 \
    "\"bark\"},{\"uri\":\"gone.png\"},{\"uri\":\"no%20one.png\"}],\"textures\":[{\"extensions\":{"                     \
    "\"EXT_texture_webp\":{\"source\":0}}},{\"source\":0,\"extensions\":{\"KHR_texture_basisu\":{\"source\":"          \
    "2}}},{\"extensions\":{\"KHR_texture_basisu\":{\"source\":2}}},{\"source\":1},{\"source\":3}],"                    \
    "\"materials\":[" material "]}"
#define COLOUR(texture) "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":" texture "}}}"

START_TEST(images_of_extensions_are_found)
{
    reads(MATERIALS(COLOUR("0") "," COLOUR("1")));
    ck_assert(scene.materials[0].base.texture == 0 && scene.materials[1].base.texture == 0);
    ck_assert_uint_eq(scene.textures[0].size, 3);
    reads("{\"asset\":{\"version\":\"2.0\"},\"images\":[{\"uri\":\"data:image/avif;base64,++++\"}],"
          "\"textures\":[{\"source\":0}],\"materials\":[" COLOUR("0") "]}");
    ck_assert(scene.textures[0].size == 3 && memcmp(scene.textures[0].data, "\xfb\xef\xbe", 3) == 0);
    /* The first 8 bytes of an AVIF file. */
    reads("{\"asset\":{\"version\":\"2.0\"},\"images\":[{\"uri\":\"data:image/avif;base64,AAAAHGZ0eXA=\"}],"
          "\"textures\":[{\"extensions\":{\"EXT_texture_avif\":{\"source\":0}}}],\"materials\":[" COLOUR("0") "]}");
    ck_assert_uint_eq(scene.materials[0].base.texture, HATCH_NONE);
    ck_assert_uint_eq(notes.images_missing, 1);
    reads(MATERIALS(COLOUR("0") "," COLOUR("1")));
    ck_assert_uint_eq(notes.images_missing, 0); /* no material refers to one */
    reads(MATERIALS(COLOUR("2") "," COLOUR("2") ",{\"normalTexture\":{\"index\":3}}"));
    ck_assert(scene.materials[0].base.texture == HATCH_NONE && !scene.materials[2].normals.used);
    ck_assert_uint_eq(notes.images_missing, 2);
    ck_assert_str_eq(notes.image_missing, "gone.png");
    reads(MATERIALS(COLOUR("3")));
    ck_assert_str_eq(notes.image_missing, "bark");
}
END_TEST

START_TEST(texture_coordinates_may_be_of_any_set)
{
    reads(MATERIALS("{\"normalTexture\":{\"index\":1,\"texCoord\":3,\"scale\":0.5}}"));
    const struct hatch_normal_map *normals = &scene.materials[0].normals;
    ck_assert(normals->used && normals->at.texcoord == 3);
    ck_assert_float_eq(normals->strength, 0.5f);
}
END_TEST

START_TEST(blended_materials_have_a_cutoff_of_one_half)
{
    reads(MATERIALS("{\"alphaMode\":\"BLEND\"},{\"alphaMode\":\"BLEND\",\"extras\":{\"hatch\":\"outline\"}},"
                    "{\"alphaMode\":\"MASK\"}"));
    ck_assert(scene.materials[0].blend && !scene.materials[1].blend && !scene.materials[2].blend);
    ck_assert_float_eq(scene.materials[0].alpha_cutoff, 0.5f);
    ck_assert_float_eq(scene.materials[1].alpha_cutoff, 0);
}
END_TEST

/* Of two meshes that look the same: the second is that of another scene, a level of detail, or of a file without
 * nodes. */
START_TEST(meshes_that_no_node_draws_are_not_read)
{
    static const char two[] = HEAD ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":5}]},"
                                   "{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":5},"
                                   "{\"attributes\":{\"POSITION\":0},\"mode\":5}]}]";
    static const struct {
        const char *rest;
        uint32_t nodes, meshes, undrawn, levels;
    } files[] = {
        {",\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]}],\"nodes\":[{\"mesh\":0},{\"mesh\":1}]}", 1, 1, 1, 0},
        {",\"scene\":1,\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]}],\"nodes\":[{\"mesh\":0},{\"mesh\":1}]}", 1, 2, 1,
         0},
        {",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"extensions\":{\"MSFT_lod\":{\"ids\":[1]}}},"
         "{\"mesh\":1}]}",
         1, 1, 0, 1},
        {",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":1,\"extensions\":{\"MSFT_lod\":{\"ids\":[7,-1]}}}]}", 1, 2,
         1, 1},
        {",\"nodes\":[{\"children\":[1]},{\"mesh\":1}]}", 2, 2, 1, 0},
        {",\"scenes\":[{}],\"nodes\":[{\"mesh\":1}]}", 0, 3, 0, 0},
        {"}", 0, 3, 0, 0}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char json[4000];
        snprintf(json, sizeof json, "%s%s", two, files[i].rest);
        reads(json);
        ck_assert_uint_eq(scene.node_count, files[i].nodes);
        ck_assert_uint_eq(scene.mesh_count, files[i].meshes);
        ck_assert_uint_eq(notes.meshes_undrawn, files[i].undrawn);
        ck_assert_uint_eq(notes.levels_dropped, files[i].levels);
        for (uint32_t n = 0; n < scene.node_count; n++)
            ck_assert_uint_le(scene.nodes[n].first_mesh + scene.nodes[n].mesh_count, scene.mesh_count);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io gltf kinds");
    TCase *tests = tcase_create("kinds");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, numbers_may_be_of_any_type, 0, 5);
    tcase_add_test(tests, indices_may_be_sparse);
    tcase_add_test(tests, positions_may_be_sparse);
    tcase_add_test(tests, instances_are_nodes);
    tcase_add_test(tests, instances_have_the_weights_of_their_node);
    tcase_add_test(tests, instances_are_animated_with_their_node);
    tcase_add_test(tests, two_keys_may_have_one_time);
    tcase_add_test(tests, required_extensions_are_checked_first);
    tcase_add_test(tests, extensions_that_are_left_out_are_named_while_there_is_room);
    tcase_add_test(tests, buffers_in_files_and_fallbacks_are_listed);
    tcase_add_test(tests, trailing_zeros_are_ignored);
    tcase_add_test(tests, images_of_extensions_are_found);
    tcase_add_test(tests, texture_coordinates_may_be_of_any_set);
    tcase_add_test(tests, blended_materials_have_a_cutoff_of_one_half);
    tcase_add_test(tests, meshes_that_no_node_draws_are_not_read);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
