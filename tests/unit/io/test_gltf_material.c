/* Materials, lights and companion files as exporters write them, and what copies keep of them. */
#include <math.h>
#include <string.h>

#include "arenas.h"
#include "io/glb/glb.h"
#include "io/gltf/gltf.h"

static struct hatch_scene scene;
static struct hatch_mesh_notes notes;

#define HEAD "{\"asset\":{\"version\":\"2.0\"}"
#define TEXTURE ",\"images\":[{\"uri\":\"data:image/png;base64,AAAA\"}],\"textures\":[{\"source\":0},{\"source\":0}]"

/* Only the file "a+b.bin" exists. */
static enum hatch_status resolve(void *context, const char *uri, struct hatch_arena *arena, struct hatch_bytes *bytes,
                                 struct hatch_err *error)
{
    (void)context;
    (void)arena;
    if (strcmp(uri, "a+b.bin") != 0)
        return hatch_fail(error, HATCH_IO, "%s: missing", uri);
    *bytes = (struct hatch_bytes){(const uint8_t *)"1234", 4};
    return HATCH_OK;
}

static const struct hatch_gltf_resolver resolver = {resolve, NULL};

static enum hatch_status read_bytes(const void *data, size_t size)
{
    return hatch_gltf_read((struct hatch_bytes){data, size}, &resolver, &keep, &scratch, &scene, &notes, &err);
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

START_TEST(texture_transforms_are_read)
{
    reads(HEAD TEXTURE ",\"extensionsRequired\":[\"KHR_texture_transform\"],\"materials\":[{"
                       "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":1,\"extensions\":{"
                       "\"KHR_texture_transform\":{\"offset\":[0.25,0.5],\"rotation\":0.5,\"texCoord\":1}}}}},"
                       "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":1}}}]}");
    const struct hatch_material *m = &scene.materials[0];
    ck_assert(m->base.has_transform && m->base.texture == 0 && m->base.texcoord == 1);
    ck_assert_float_eq(m->base.offset[0], 0.25f);
    ck_assert_float_eq(m->base.offset[1], 0.5f);
    ck_assert_float_eq(m->base.turn_rad, 0.5f);
    ck_assert(m->base.scale[0] == 1 && m->base.scale[1] == 1);
    ck_assert(!scene.materials[1].base.has_transform);
    static const char crooked[] =
        HEAD TEXTURE ",\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":"
                     "{\"KHR_texture_transform\":{\"scale\":[1]}}}}}]}";
    refuses(crooked, "material 0: scale: 1 values, want 2");
}
END_TEST

START_TEST(diffuse_colours_are_read)
{
    reads(HEAD TEXTURE ",\"extensionsRequired\":[\"KHR_materials_pbrSpecularGlossiness\"],\"materials\":[{"
                       "\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":[0.5,0,0,1],"
                       "\"diffuseTexture\":{\"index\":1,\"texCoord\":1,\"extensions\":{\"KHR_texture_transform\":"
                       "{\"scale\":[2,3]}}}}}}]}");
    const struct hatch_material *m = &scene.materials[0];
    ck_assert_float_eq(m->base_color[0], 0.5f);
    ck_assert_float_eq(m->base_color[1], 0);
    ck_assert(m->base.texture == 0 && m->base.texcoord == 1 && m->base.has_transform);
    ck_assert_float_eq(m->base.scale[1], 3);
    reads(HEAD TEXTURE ",\"materials\":[{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{"
                       "\"diffuseTexture\":{\"index\":1}}}}]}");
    ck_assert(scene.materials[0].base.texture == 0 && scene.materials[0].base.texcoord == 0);
    static const char astray[] =
        HEAD TEXTURE ",\"materials\":[{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{"
                     "\"diffuseTexture\":{\"index\":7}}}}]}";
    refuses(astray, "material 0: texture 7 does not exist, there are 2");
}
END_TEST

START_TEST(material_extensions_are_accepted)
{
    static const char draco[] =
        HEAD ",\"extensionsRequired\":[\"KHR_materials_sheen\",\"KHR_draco_mesh_compression\"]}";
    reads(HEAD ",\"extensionsRequired\":[\"KHR_materials_unlit\",\"KHR_materials_clearcoat\"]}");
    refuses(draco, "extensionsRequired: KHR_draco_mesh_compression is not supported");
    static const char later[] = "{\"asset\":{\"version\":\"2.1\",\"minVersion\":\"2.1\"}}";
    refuses(later, "asset: needs glTF 2.1, only 2.0 is supported");
}
END_TEST

START_TEST(a_spot_may_have_a_sharp_edge)
{
    reads(HEAD ",\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"spot\",\"spot\":{"
               "\"innerConeAngle\":0.5,\"outerConeAngle\":0.5}}]}}}");
    ck_assert_float_eq(scene.lights[0].outer_cone_rad, 0.5f);
    ck_assert(scene.lights[0].inner_cone_rad < 0.5f && scene.lights[0].inner_cone_rad > 0.4999f);
}
END_TEST

START_TEST(a_plus_in_a_uri_stays_a_plus)
{
    reads(HEAD ",\"buffers\":[{\"byteLength\":4,\"uri\":\"a+b.bin\"}]}");
    static const char gone[] = HEAD ",\"buffers\":[{\"byteLength\":4,\"uri\":\"a b.txt\"}]}";
    refuses(gone, "a b.txt: missing");
}
END_TEST

START_TEST(a_glb_may_lack_a_binary_chunk)
{
    static const char json[] = HEAD "} "; /* 28 bytes: a multiple of 4 */
    for (int empty = 0; empty < 2; empty++) {
        struct hatch_buffer file = {.arena = &keep};
        HATCH_TEST_OK(hatch_buffer_add(&file, "glTF\2\0\0\0", 8, &err), &err);
        HATCH_TEST_OK(hatch_buffer_add_u32le(&file, (uint32_t)(20 + sizeof json - 1) + (empty ? 8 : 0), &err), &err);
        HATCH_TEST_OK(hatch_buffer_add_u32le(&file, (uint32_t)(sizeof json - 1), &err), &err);
        HATCH_TEST_OK(hatch_buffer_add(&file, "JSON", 4, &err), &err);
        HATCH_TEST_OK(hatch_buffer_add(&file, json, sizeof json - 1, &err), &err);
        if (empty)
            HATCH_TEST_OK(hatch_buffer_add(&file, "\0\0\0\0BIN\0", 8, &err), &err);
        HATCH_TEST_OK(read_bytes(file.data, file.size), &err);
        ck_assert_uint_eq(scene.mesh_count, 0);
    }
}
END_TEST

static struct hatch_buffer copy_of(const char *json)
{
    struct hatch_buffer file = {.arena = &keep};
    reads(json);
    HATCH_TEST_OK(hatch_glb_write_scene(&scene, "it", &scratch, &file, &err), &err);
    HATCH_TEST_OK(hatch_buffer_add(&file, "", 1, &err), &err);
    return file;
}

/* Checks that the copy of a file has some texts in its JSON, in this order, and that a copy of the copy is like it. */
static void copies(const char *json, const char *const *texts)
{
    struct hatch_buffer file = copy_of(json), again = {.arena = &keep};
    const char *at = (const char *)file.data + 20;
    for (; *texts; texts++) {
        const char *found = strstr(at, *texts);
        ck_assert_msg(found != NULL, "%s is not in %s", *texts, (const char *)file.data + 20);
        at = found + strlen(*texts);
    }
    HATCH_TEST_OK(read_bytes(file.data, file.size - 1), &err);
    HATCH_TEST_OK(hatch_glb_write_scene(&scene, "it", &scratch, &again, &err), &err);
    ck_assert_uint_eq(again.size, file.size - 1);
    ck_assert_mem_eq(again.data, file.data, again.size);
}

START_TEST(names_and_extras_are_kept)
{
    static const char json[] =
        "{\"asset\":{\"version\":\"2.0\",\"copyright\":\"(c) "
        "\\\"me\\\"\",\"extras\":{\"hatch\":\"old\",\"by\":[\"{\",\"\\\\\"]}},"
        "\"scenes\":[{\"name\":\"S\",\"extras\":false,\"nodes\":[0]}],"
        "\"nodes\":[{\"name\":\"caf\\u00e9 "
        "\\ud83d\\ude00\\u0001\",\"mesh\":0,\"camera\":0,\"extensions\":{\"KHR_lights_punctual\":"
        "{\"light\":0}},\"extras\":{\"MSFT_screencoverage\":[1],\"a\":{\"b\":[{},\"]\"]}}}],"
        "\"meshes\":[{\"name\":\"Body\",\"extras\":{\"targetNames\":[\"smile\"]},\"primitives\":[{\"attributes\":"
        "{\"POSITION\":0},\"material\":0,\"extras\":{\"hatch\":{\"unseen\":0.5},\"p\":1}},{\"attributes\":{"
        "\"POSITION\":0},"
        "\"extras\":[16777217,12345678901234567890]}]}],"
        "\"materials\":[{\"name\":\"Oak\",\"extras\":{\"hatch\":\"outline\",\"id\":7}},{\"extras\":{\"hatch\":1}}],"
        "\"cameras\":[{\"name\":\"Shot\",\"type\":\"perspective\",\"perspective\":{\"yfov\":0.5,\"znear\":0.5},"
        "\"extras\":null}],"
        "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"name\":\"Sun\",\"type\":\"directional\",\"extras\":"
        "\"x\"}]}},"
        "\"images\":[{\"name\":\"wood\",\"extras\":{\"i\":1},\"uri\":\"data:image/png;base64,iVBORw0KGgoBAgM=\"}],"
        "\"accessors\":[{\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
        "{\"componentType\":5126,\"count\":3,\"type\":\"SCALAR\"}],"
        "\"skins\":[{\"name\":\"Bones\",\"extras\":{\"s\":1},\"joints\":[0]}],"
        "\"animations\":[{\"name\":\"Walk\",\"extras\":1.5,\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,"
        "\"path\":"
        "\"scale\"}}],\"samplers\":[{\"input\":1,\"output\":0}]}]}";
    static const char *const texts[] = {
        "\"copyright\":\"(c) \\\"me\\\"\",\"extras\":{\"hatch\":\"it\",\"by\":[\"{\",\"\\\\\"]}}",
        "\"scenes\":[{\"name\":\"S\",\"nodes\":[0],\"extras\":false}]",
        "{\"name\":\"caf\xc3\xa9 \xf0\x9f\x98\x80\\u0001\",",
        "\"extras\":{\"a\":{\"b\":[{},\"]\"]}}",
        "\"meshes\":[{\"name\":\"Body\",",
        ",\"extras\":{\"hatch\":{\"unseen\":0.5,\"normals\":\"computed\"},\"p\":1}}",
        ",\"extras\":[16777217,12345678901234567890]}",
        "],\"extras\":{\"targetNames\":[\"smile\"]}}]",
        "\"materials\":[{\"name\":\"Oak\",",
        ",\"extras\":{\"hatch\":\"outline\",\"id\":7}},{\"pbrMetallicRoughness\":{}}]",
        "\"images\":[{\"name\":\"wood\",",
        ",\"extras\":{\"i\":1}}]",
        "\"cameras\":[{\"name\":\"Shot\",",
        ",\"extras\":null}]",
        "\"lights\":[{\"name\":\"Sun\",",
        ",\"extras\":\"x\"}]",
        "\"skins\":[{\"name\":\"Bones\",",
        ",\"extras\":{\"s\":1}}]",
        "\"animations\":[{\"name\":\"Walk\",",
        ",\"extras\":1.5}]",
        NULL,
    };
    copies(json, texts);
}
END_TEST

/* Two textures of an image that differ in the filters, one that differs in the name of the sampler, and one that is
 * like the first. */
START_TEST(samplers_and_textures_are_kept)
{
    static const char json[] =
        HEAD ",\"images\":[{\"uri\":\"data:image/png;base64,iVBORw0KGgoBAgM=\"}],"
             "\"samplers\":[{\"magFilter\":9728,\"minFilter\":9984,\"wrapS\":33071},{\"name\":\"Soft\",\"extras\":1},"
             "{\"magFilter\":7,\"minFilter\":9728}],"
             "\"textures\":[{\"source\":0,\"sampler\":0,\"name\":\"T\",\"extras\":{\"t\":2}},{\"source\":0},"
             "{\"source\":0,\"sampler\":1},{\"source\":0,\"sampler\":2},"
             "{\"source\":0,\"sampler\":0,\"name\":\"T\",\"extras\":{\"t\":2}}],"
             "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}},\"normalTexture\":{"
             "\"index\":1}},"
             "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":2}},\"normalTexture\":{\"index\":3}},"
             "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":4}}}]}";
    static const char *const texts[] = {
        "\"baseColorTexture\":{\"index\":0",
        "\"normalTexture\":{\"index\":1",
        "\"baseColorTexture\":{\"index\":2",
        "\"normalTexture\":{\"index\":3",
        "\"baseColorTexture\":{\"index\":0",
        "\"textures\":[{\"name\":\"T\",\"sampler\":0,\"source\":0,\"extras\":{\"t\":2}},{\"sampler\":1,\"source\":0},"
        "{\"sampler\":2,\"source\":0},{\"sampler\":3,\"source\":0}],"
        "\"samplers\":[{\"magFilter\":9728,\"minFilter\":9984,\"wrapS\":33071,\"wrapT\":10497},"
        "{\"magFilter\":9729,\"minFilter\":9987,\"wrapS\":10497,\"wrapT\":10497},"
        "{\"name\":\"Soft\",\"magFilter\":9729,\"minFilter\":9987,\"wrapS\":10497,\"wrapT\":10497,\"extras\":1},"
        "{\"magFilter\":9729,\"minFilter\":9728,\"wrapS\":10497,\"wrapT\":10497}]",
        NULL,
    };
    copies(json, texts);
}
END_TEST

/* RIFF, four bytes of size, WEBPV */
START_TEST(webp_needs_an_extension)
{
    static const char json[] =
        HEAD ",\"extensionsUsed\":[\"EXT_texture_webp\"],"
             "\"images\":[{\"uri\":\"data:image/png;base64,iVBORw0KGgoBAgM=\"},"
             "{\"uri\":\"data:image/webp;base64,UklGRgQAAABXRUJQVg==\"}],"
             "\"textures\":[{\"source\":0},{\"extensions\":{\"EXT_texture_webp\":{\"source\":1}}}],"
             "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}},"
             "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":1}}}]}";
    static const char *const texts[] = {
        "\"textures\":[{\"sampler\":0,\"source\":0},{\"sampler\":1,\"extensions\":{\"EXT_texture_webp\":{\"source\":1}}"
        "}]",
        "\"mimeType\":\"image/png\"",
        "\"mimeType\":\"image/webp\"",
        "\"extensionsUsed\":[\"EXT_texture_webp\"]",
        "\"extensionsRequired\":[\"EXT_texture_webp\"]",
        NULL,
    };
    copies(json, texts);
    ck_assert_uint_eq(scene.textures[1].size, 13);
    ck_assert_mem_eq(scene.textures[1].data + 8, "WEBPV", 5);
}
END_TEST

/* Members that hatching does not draw. Texture 1 has another image, texture 2 one that is missing; their transforms
 * and sets of texture coordinates stay. */
START_TEST(members_of_materials_are_kept)
{
    static const char json[] =
        HEAD ",\"images\":[{\"uri\":\"data:image/png;base64,iVBORw0KGgoBAgM=\"},"
             "{\"uri\":\"data:image/png;base64,iVBORw0KGgoEBQY=\"},{\"uri\":\"none.png\"}],"
             "\"textures\":[{\"source\":0},{\"source\":1},{\"source\":2}],\"materials\":["
             "{\"normalTexture\":{\"index\":1},\"pbrMetallicRoughness\":{\"metallicFactor\":0.7,\"roughnessFactor\":0."
             "30000000000000004,"
             "\"metallicRoughnessTexture\":{\"index\":0,\"texCoord\":1}},\"occlusionTexture\":{\"index\":1,"
             "\"strength\":0.5},"
             "\"emissiveFactor\":[1,0.5,0],\"emissiveTexture\":{\"index\":1,\"extensions\":{\"KHR_texture_transform\":{"
             "\"offset\":[0.5,0.25]}}},\"extensions\":{\"KHR_materials_clearcoat\":{\"clearcoatFactor\":1,"
             "\"clearcoatNormalTexture\":{\"index\":1,\"scale\":2},\"clearcoatTexture\":{\"index\":0},"
             "\"clearcoatRoughnessTexture\":{\"index\":2}},\"KHR_materials_unlit\":{},\"OTHER_paint\":{\"index\":3}}},"
             "{\"pbrMetallicRoughness\":{\"roughnessFactor\":1},\"emissiveTexture\":{\"index\":2},"
             "\"extensions\":{\"KHR_materials_unlit\":{}}},"
             "{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":[1,1,1,1]}}}]}";
    static const char *const texts[] = {
        "\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0.7,\"roughnessFactor\":0.30000000000000004,"
        "\"metallicRoughnessTexture\":{\"index\":1,\"texCoord\":1}},\"normalTexture\":{\"index\":0,\"texCoord\":0,"
        "\"scale\":1},"
        "\"occlusionTexture\":{\"index\":0,\"texCoord\":0,\"strength\":0.5},\"emissiveFactor\":[1,0.5,0],"
        "\"emissiveTexture\":{\"index\":0,\"texCoord\":0,\"extensions\":{\"KHR_texture_transform\":{\"rotation\":0,"
        "\"scale\":[1,1],\"offset\":[0.5,0.25]}}},\"extensions\":{\"KHR_materials_clearcoat\":{\"clearcoatFactor\":1,"
        "\"clearcoatNormalTexture\":{\"index\":0,\"texCoord\":0,\"scale\":2},"
        "\"clearcoatTexture\":{\"index\":1,\"texCoord\":0}},\"KHR_materials_unlit\":{}}},"
        "{\"pbrMetallicRoughness\":{},\"extensions\":{\"KHR_materials_unlit\":{}}},"
        "{\"pbrMetallicRoughness\":{\"metallicFactor\":0}}]",
        "\"textures\":[{\"sampler\":0,\"source\":1},{\"sampler\":1,\"source\":0}]",
        "\"extensionsUsed\":[\"KHR_texture_transform\",\"KHR_materials_clearcoat\",\"KHR_materials_unlit\"]",
        NULL,
    };
    copies(json, texts);
    static const char empty[] = HEAD ",\"materials\":[{\"extensions\":{\"KHR_materials_clearcoat\":{"
                                     "\"clearcoatFactor\":1,\"clearcoatTexture\":{},"
                                     "\"clearcoatNormalTexture\":{\"index\":null}}}}]}";
    static const char *const rest[] = {"\"KHR_materials_clearcoat\":{\"clearcoatFactor\":1}", NULL};
    copies(empty, rest);
    refuses(HEAD ",\"materials\":[{\"occlusionTexture\":{\"index\":1}}]}",
            "material 0: texture 1 does not exist, there are 0");
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io gltf material");
    TCase *tests = tcase_create("reader");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, texture_transforms_are_read);
    tcase_add_test(tests, diffuse_colours_are_read);
    tcase_add_test(tests, material_extensions_are_accepted);
    tcase_add_test(tests, a_spot_may_have_a_sharp_edge);
    tcase_add_test(tests, a_plus_in_a_uri_stays_a_plus);
    tcase_add_test(tests, a_glb_may_lack_a_binary_chunk);
    tcase_add_test(tests, names_and_extras_are_kept);
    tcase_add_test(tests, samplers_and_textures_are_kept);
    tcase_add_test(tests, webp_needs_an_extension);
    tcase_add_test(tests, members_of_materials_are_kept);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
