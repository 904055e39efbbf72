/* Primitives that share the accessors of their vertices, written and read. */
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "fail_alloc.h"
#include "io/glb/glb.h"
#include "io/gltf/gltf.h"
#include "meshes.h"

enum { PARTS = 30 };

static struct hatch_scene_mesh parts[PARTS];
static struct hatch_node node;
static struct hatch_scene scene, back;

/* One node with 30 planes of growing size, whose positions differ. */
static void begin_parts(void)
{
    begin();
    for (uint32_t i = 0; i < PARTS; i++) {
        parts[i] =
            (struct hatch_scene_mesh){.mesh = shape_of(HATCH_SHAPE_PLANE, 2 + 2 * (i % 5)), .material = HATCH_NONE};
        parts[i].mesh.attributes[0].data[0] = -(float)i;
    }
    node = (struct hatch_node){.parent = HATCH_NONE,
                               .rotation = {0, 0, 0, 1},
                               .scale = {1, 1, 1},
                               .mesh_count = PARTS,
                               .skin = HATCH_NONE,
                               .camera = HATCH_NONE,
                               .light = HATCH_NONE};
    scene = (struct hatch_scene){.meshes = parts, .mesh_count = PARTS, .nodes = &node, .node_count = 1};
}

static struct hatch_buffer written(void)
{
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_glb_write_scene(&scene, NULL, &scratch, &file, &err), &err);
    return file;
}

/* Counts the places of a text in the JSON of a file. */
static uint32_t count_text(struct hatch_buffer file, const char *text)
{
    uint32_t count = 0, length;
    memcpy(&length, file.data + 12, sizeof length);
    for (size_t i = 20; i + strlen(text) <= 20 + (size_t)length; i++)
        count += memcmp(file.data + i, text, strlen(text)) == 0;
    return count;
}

static enum hatch_status read_back(const void *bytes, size_t size)
{
    struct hatch_mesh_notes notes = {0};
    return hatch_gltf_read((struct hatch_bytes){bytes, size}, NULL, &keep, &scratch, &back, &notes, &err);
}

/* Checks that a file has the scene's meshes, whose attributes may be in another order. */
static void check_same(struct hatch_buffer file)
{
    HATCH_TEST_OK(read_back(file.data, file.size), &err);
    ck_assert_uint_eq(back.mesh_count, PARTS);
    for (uint32_t m = 0; m < PARTS; m++) {
        const struct hatch_mesh *a = &parts[m].mesh, *b = &back.meshes[m].mesh;
        ck_assert_uint_eq(b->vertex_count, a->vertex_count);
        ck_assert_uint_eq(b->face_count, a->face_count);
        ck_assert_mem_eq(b->indices, a->indices, 12 * (size_t)a->face_count);
        ck_assert_uint_eq(b->attribute_count, a->attribute_count);
        for (uint32_t i = 0; i < a->attribute_count; i++) {
            const struct hatch_mesh_attribute *at = &a->attributes[i];
            const float *data = hatch_mesh_find(b, at->name, at->components);
            ck_assert_ptr_nonnull(data);
            ck_assert_mem_eq(data, at->data, sizeof *data * a->vertex_count * at->components);
        }
    }
}

static uint32_t vertices(void)
{
    uint32_t count = 0;
    for (uint32_t m = 0; m < PARTS; m++)
        count += parts[m].mesh.vertex_count;
    return count;
}

/* Sets of up to 256 vertices: each has a view per attribute and one for the indices of all its primitives. */
START_TEST(small_primitives_share_views)
{
    struct hatch_buffer file = written();
    uint32_t sets = count_text(file, "\"min\":["), each = parts[0].mesh.attribute_count + 1;
    check_same(file);
    ck_assert_uint_ge(sets, (vertices() + 255) / 256);
    ck_assert_uint_lt(sets, 4);
    ck_assert_uint_eq(count_text(file, "\"byteLength\":"), sets * each + 1);
    ck_assert_uint_eq(count_text(file, "\"componentType\":"), sets * (each - 1) + PARTS);
    struct hatch_buffer again = {.arena = &keep};
    HATCH_TEST_OK(hatch_glb_write_scene(&back, NULL, &scratch, &again, &err), &err);
    ck_assert_uint_eq(again.size, file.size);
    ck_assert_mem_eq(again.data, file.data, file.size);
}
END_TEST

/* A set ends before a primitive that has over 256 vertices, other attributes, or morph targets, or another mesh's. */
START_TEST(others_have_accessors_of_their_own)
{
    float *data;
    for (uint32_t i = 0; i < PARTS; i++)
        parts[i].mesh = shape_of(HATCH_SHAPE_PLANE, 2);
    uint32_t one = count_text(written(), "\"min\":[");
    ck_assert_uint_eq(one, 1);
    parts[5].mesh = shape_of(HATCH_SHAPE_PLANE, 600);
    ck_assert_uint_gt(parts[5].mesh.vertex_count, 256);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &parts[10].mesh, "_MORE", 1, &data, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &parts[15].mesh, HATCH_MORPH_POSITION, 3, &data, &err), &err);
    parts[20].mesh.face_count = 0;
    parts[29].mesh.attributes[0].data[0] = -29;
    struct hatch_buffer file = written();
    /* Parts 0-4, 5, 6-9, 10, 11-14, 15 and its target, 16-19, 21-29. */
    ck_assert_uint_eq(count_text(file, "\"min\":["), 9);
    HATCH_TEST_OK(read_back(file.data, file.size), &err);
    ck_assert_uint_eq(back.mesh_count, PARTS - 1);
    ck_assert_float_eq(back.meshes[28].mesh.attributes[0].data[0], -29);
    struct hatch_node two[2] = {node, node};
    two[0].mesh_count = 25;
    two[1].first_mesh = 25;
    two[1].mesh_count = 5;
    scene.nodes = two;
    scene.node_count = 2;
    ck_assert_uint_eq(count_text(written(), "\"min\":["), 10);
}
END_TEST

/* A set may have 256 vertices, and no more. */
START_TEST(a_set_has_256_vertices)
{
    for (uint32_t i = 0; i < PARTS; i++)
        parts[i].mesh = shape_of(HATCH_SHAPE_PLANE, 98);
    ck_assert_uint_eq(parts[0].mesh.vertex_count, 64);
    scene.mesh_count = node.mesh_count = 4;
    ck_assert_uint_eq(count_text(written(), "\"min\":["), 1);
    scene.mesh_count = node.mesh_count = 5;
    ck_assert_uint_eq(count_text(written(), "\"min\":["), 2);
}
END_TEST

static const float square[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
static const struct {
    float corners[12], raised[3];
    uint16_t indices[10];
} data = {{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, {7, 8, 9}, {0, 1, 2, 3, 2, 1, 3, 9, 0, 0}};

static enum hatch_status resolve(void *context, const char *uri, struct hatch_arena *arena, struct hatch_bytes *bytes,
                                 struct hatch_err *error)
{
    (void)context, (void)uri, (void)arena, (void)error;
    *bytes = (struct hatch_bytes){(const uint8_t *)&data, sizeof data};
    return HATCH_OK;
}

/* Reads a file of two primitives of the vertices above.
 *   offset  in bytes, of the second one's three indices
 *   more    of the accessor of the vertices; an empty text: nothing */
static enum hatch_status read_two(uint32_t offset, const char *more, const char *attributes)
{
    static const struct hatch_gltf_resolver resolver = {resolve, NULL};
    struct hatch_mesh_notes notes = {0};
    char json[1500];
    int size = snprintf(
        json, sizeof json,
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"d.bin\",\"byteLength\":80}],\"bufferViews\":["
        "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12},"
        "{\"buffer\":0,\"byteOffset\":60,\"byteLength\":20}],\"accessors\":["
        "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"%s},"
        "{\"bufferView\":2,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},"
        "{\"bufferView\":2,\"byteOffset\":%u,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},"
        "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":["
        "{\"attributes\":{\"POSITION\":0},\"indices\":1},{\"attributes\":{\"POSITION\":0%s},\"indices\":2}]}],"
        "\"nodes\":[{\"mesh\":0}]}",
        more, offset, attributes);
    ck_assert_int_lt(size, (int)sizeof json);
    return hatch_gltf_read((struct hatch_bytes){(const uint8_t *)json, (size_t)size}, &resolver, &keep, &scratch, &back,
                           &notes, &err);
}

/* Each primitive has the vertices from its lowest to its highest index. */
START_TEST(ranges_are_read)
{
    static const uint32_t first[3] = {0, 1, 2}, second[3] = {2, 1, 0};
    HATCH_TEST_OK(read_two(6, "", ""), &err);
    const struct hatch_mesh *a = &back.meshes[0].mesh, *b = &back.meshes[1].mesh;
    ck_assert_uint_eq(a->vertex_count, 3);
    ck_assert_uint_eq(b->vertex_count, 3);
    ck_assert_mem_eq(a->indices, first, sizeof first);
    ck_assert_mem_eq(b->indices, second, sizeof second);
    ck_assert_mem_eq(a->attributes[0].data, square, 9 * sizeof *square);
    ck_assert_mem_eq(b->attributes[0].data, square + 3, 9 * sizeof *square);
}
END_TEST

/* Sparse values count from the accessor's first element: number 3 is outside the first primitive. */
START_TEST(sparse_values_of_ranges_are_read)
{
    HATCH_TEST_OK(read_two(6,
                           ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":2,\"byteOffset\":6,\"componentType\":"
                           "5123},\"values\":{\"bufferView\":1}}",
                           ""),
                  &err);
    ck_assert_mem_eq(back.meshes[0].mesh.attributes[0].data, square, 9 * sizeof *square);
    ck_assert_mem_eq(back.meshes[1].mesh.attributes[0].data + 6, data.raised, sizeof data.raised);
}
END_TEST

/* The places in messages are those of the file. */
START_TEST(damaged_ranges_are_refused)
{
    ck_assert_int_eq(read_two(12, "", ""), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "mesh 0, primitive 1: index 9 does not exist, there are 4 vertices");
    ck_assert_int_eq(read_two(6, "", ",\"NORMAL\":3"), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "mesh 0, primitive 1, NORMAL: 3 elements, POSITION has 4");
}
END_TEST

/* Returns the processor's time, in seconds, of reading a file of primitives of one triangle.
 *   each  primitives of a mesh, which has a node of its own
 *   more  of a primitive; an empty text: nothing */
static double seconds_of(uint32_t meshes, uint32_t each, const char *more)
{
    struct hatch_mesh_notes notes = {0};
    struct hatch_buffer json = {.arena = &keep};
    HATCH_TEST_OK(
        hatch_buffer_print(&json, &err,
                           "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36,"
                           "\"uri\":\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAA"
                           "AAAAgD8AAAAA\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":["
                           "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"nodes\":["),
        &err);
    for (uint32_t m = 0; m < meshes; m++)
        HATCH_TEST_OK(hatch_buffer_print(&json, &err, "%s{\"mesh\":%u}", m ? "," : "", m), &err);
    HATCH_TEST_OK(hatch_buffer_print(&json, &err, "],\"meshes\":["), &err);
    for (uint32_t p = 0; p < meshes * each; p++)
        HATCH_TEST_OK(hatch_buffer_print(&json, &err, "%s{\"attributes\":{\"POSITION\":0}%s}%s",
                                         p == 0          ? "{\"primitives\":["
                                         : p % each == 0 ? ",{\"primitives\":["
                                                         : ",",
                                         more, p % each == each - 1 ? "]}" : ""),
                      &err);
    HATCH_TEST_OK(hatch_buffer_print(&json, &err, "]}"), &err);
    const clock_t begun = clock();
    HATCH_TEST_OK(
        hatch_gltf_read((struct hatch_bytes){json.data, json.size}, NULL, &keep, &scratch, &back, &notes, &err), &err);
    ck_assert_uint_eq(back.mesh_count, meshes * each);
    return (double)(clock() - begun) / CLOCKS_PER_SEC;
}

/* Neither the primitives of one mesh nor the nodes of morphed meshes are gone through again for each primitive. */
START_TEST(many_primitives_take_linear_time)
{
    enum { COUNT = 32000 };
    static const char morphed[] = ",\"targets\":[{\"POSITION\":0}]";
    const double few = seconds_of(COUNT / 16, 16, "");
    ck_assert_double_lt(seconds_of(1, COUNT, ""), 4 * few);
    const double few_morphed = seconds_of(COUNT / 16, 16, morphed);
    ck_assert_double_lt(seconds_of(COUNT, 1, morphed), 5 * few_morphed);
}
END_TEST

static enum hatch_status write_parts(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                     struct hatch_err *error)
{
    struct hatch_buffer file = {.arena = kept};
    return hatch_glb_write_scene(context, NULL, temporary, &file, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    hatch_test_fail_alloc(write_parts, &scene, &scene, sizeof scene);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io glb shared");
    TCase *tests = tcase_create("shared");
    tcase_add_checked_fixture(tests, begin_parts, end);
    tcase_add_test(tests, small_primitives_share_views);
    tcase_add_test(tests, others_have_accessors_of_their_own);
    tcase_add_test(tests, a_set_has_256_vertices);
    tcase_add_test(tests, ranges_are_read);
    tcase_add_test(tests, sparse_values_of_ranges_are_read);
    tcase_add_test(tests, damaged_ranges_are_refused);
    tcase_add_test(tests, many_primitives_take_linear_time);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
