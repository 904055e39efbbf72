/* EXT_meshopt_compression: compressed buffer views are read as what was compressed. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <meshoptimizer.h>

#include "arenas.h"
#include "io/glb/container.h"
#include "io/gltf/gltf.h"

enum { WIDTH = 20, HEIGHT = 15, VERTICES = WIDTH * HEIGHT, INDICES = 6 * (WIDTH - 1) * (HEIGHT - 1), NORMALS = 2 };

/* A grid, as it is before it is compressed. A block of compressed vertices holds 256 of them at most. */
static struct {
    float positions[3 * VERTICES], normals[4 * VERTICES];
    unsigned int indices[INDICES];
} grid;

/* The compressed views: positions, indices, normals; and the JSON that names them. */
static struct {
    uint8_t bytes[65536];
    size_t size, offset[3], length[3];
    char json[4096];
} made;

static struct hatch_scene scene;

static void make_grid(void)
{
    for (size_t v = 0; v < VERTICES; v++) {
        float x = (float)(v % WIDTH), y = (float)(v / WIDTH), *n = &grid.normals[4 * v];
        const float position[] = {x / 3, y / 7, sinf(x) * cosf(y)};
        const float normal[] = {sinf(x / 9) * cosf(y), sinf(x / 9) * sinf(y), cosf(x / 9), 0};
        memcpy(&grid.positions[3 * v], position, sizeof position);
        memcpy(n, normal, sizeof normal);
    }
    unsigned int *to = grid.indices;
    for (unsigned int v = 0; v < VERTICES - WIDTH; v++)
        if (v % WIDTH < WIDTH - 1) {
            const unsigned int faces[] = {v, v + 1, v + WIDTH, v + 1, v + WIDTH + 1, v + WIDTH};
            memcpy(to, faces, sizeof faces);
            to += 6;
        }
}

static void add_view(int view, size_t size)
{
    ck_assert_uint_gt(size, 0);
    made.offset[view] = made.size;
    made.length[view] = size;
    made.size += (size + 3) / 4 * 4;
}

static uint8_t *room(size_t *size)
{
    *size = sizeof made.bytes - made.size;
    return made.bytes + made.size;
}

static void encode_exponential(float *positions)
{
#if MESHOPTIMIZER_VERSION >= 200
    meshopt_encodeFilterExp(positions, VERTICES, 12, 20, grid.positions, meshopt_EncodeExpSharedVector);
#else
    meshopt_encodeFilterExp(positions, VERTICES, 12, 20, grid.positions);
#endif
}

/* Compresses the grid.
 *   filter  of positions: NONE or EXPONENTIAL
 *   mode    of indices: TRIANGLES or INDICES */
static void compress(const char *filter, const char *mode)
{
    static float positions[3 * VERTICES];
    static int8_t normals[4 * VERTICES];
    size_t left;
    uint8_t *to;
    make_grid();
    memset(&made, 0, sizeof made);
    memcpy(positions, grid.positions, sizeof positions);
    if (strcmp(filter, "EXPONENTIAL") == 0)
        encode_exponential(positions);
    to = room(&left);
    add_view(0, meshopt_encodeVertexBuffer(to, left, positions, VERTICES, 12));
    to = room(&left);
    add_view(1, mode[0] == 'T' ? meshopt_encodeIndexBuffer(to, left, grid.indices, INDICES)
                               : meshopt_encodeIndexSequence(to, left, grid.indices, INDICES));
    meshopt_encodeFilterOct(normals, VERTICES, 4, 8, grid.normals);
    to = room(&left);
    add_view(NORMALS, meshopt_encodeVertexBuffer(to, left, normals, VERTICES, 4));
}

/* Prints the view that is compressed from `size` bytes. */
static int print_view(char *to, size_t room_size, int view, size_t stride, size_t count, const char *mode,
                      const char *filter, const char *more)
{
    return snprintf(to, room_size,
                    "{\"buffer\":1,\"byteLength\":%zu%s,\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,"
                    "\"byteOffset\":%zu,\"byteLength\":%zu,\"byteStride\":%zu,\"count\":%zu,\"mode\":\"%s\","
                    "\"filter\":\"%s\"}}}",
                    stride * count, more, made.offset[view], made.length[view], stride, count, mode, filter);
}

static void print_json(const char *filter, const char *mode, const char *fallback)
{
    char views[3][512];
    print_view(views[0], sizeof views[0], 0, 12, VERTICES, "ATTRIBUTES", filter, "");
    print_view(views[1], sizeof views[1], 1, 4, INDICES, mode, "NONE", "");
    print_view(views[2], sizeof views[2], NORMALS, 4, VERTICES, "ATTRIBUTES", "OCTAHEDRAL", ",\"byteStride\":4");
    int length =
        snprintf(made.json, sizeof made.json,
                 "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"EXT_meshopt_compression\"],"
                 "\"extensionsRequired\":[\"EXT_meshopt_compression\"],\"buffers\":[{\"byteLength\":%zu},%s],"
                 "\"bufferViews\":[%s,%s,%s],\"accessors\":["
                 "{\"bufferView\":0,\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\"},"
                 "{\"bufferView\":1,\"componentType\":5125,\"count\":%d,\"type\":\"SCALAR\"},"
                 "{\"bufferView\":2,\"componentType\":5120,\"normalized\":true,\"count\":%d,\"type\":\"VEC3\"}],"
                 "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":2},\"indices\":1}]}],"
                 "\"nodes\":[{\"mesh\":0}]}",
                 made.size, fallback, views[0], views[1], views[2], VERTICES, INDICES, VERTICES);
    ck_assert_int_lt(length, (int)sizeof made.json);
}

#define FALLBACK "{\"byteLength\":99999,\"extensions\":{\"EXT_meshopt_compression\":{\"fallback\":true}}}"

static void make(const char *filter, const char *mode)
{
    compress(filter, mode);
    print_json(filter, mode, FALLBACK);
}

static enum hatch_status read_made(void)
{
    struct hatch_buffer json = {.arena = &keep}, file = {.arena = &keep};
    struct hatch_mesh_notes notes = {0};
    HATCH_TEST_OK(hatch_buffer_print(&json, &err, "%s", made.json), &err);
    while (json.size % 4 != 0)
        HATCH_TEST_OK(hatch_buffer_add(&json, " ", 1, &err), &err);
    HATCH_TEST_OK(hatch_glb_add_container((struct hatch_bytes){json.data, json.size}, made.size, &file, &err), &err);
    memcpy(file.data + file.size - made.size, made.bytes, made.size);
    return hatch_gltf_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &scene, &notes, &err);
}

static const struct hatch_mesh *reads_grid(void)
{
    HATCH_TEST_OK(read_made(), &err);
    ck_assert_uint_eq(scene.mesh_count, 1);
    const struct hatch_mesh *mesh = &scene.meshes[0].mesh;
    ck_assert_uint_eq(mesh->vertex_count, VERTICES);
    ck_assert_uint_eq(mesh->face_count, INDICES / 3);
    return mesh;
}

START_TEST(compressed_views_are_read_exactly)
{
    make("NONE", "INDICES");
    const struct hatch_mesh *mesh = reads_grid();
    ck_assert_mem_eq(hatch_mesh_find(mesh, "POSITION", 3), grid.positions, sizeof grid.positions);
    ck_assert_mem_eq(mesh->indices, grid.indices, sizeof grid.indices);
}
END_TEST

/* The codec of triangles may turn the corners of a face. */
START_TEST(compressed_triangles_keep_their_order)
{
    make("NONE", "TRIANGLES");
    const struct hatch_mesh *mesh = reads_grid();
    for (size_t i = 0; i < INDICES; i += 3) {
        size_t turn = 0;
        while (turn < 2 && mesh->indices[i + turn] != grid.indices[i])
            turn++;
        for (size_t c = 0; c < 3; c++)
            ck_assert_uint_eq(mesh->indices[i + (c + turn) % 3], grid.indices[i + c]);
    }
}
END_TEST

START_TEST(filters_are_undone)
{
    make("EXPONENTIAL", "INDICES");
    const struct hatch_mesh *mesh = reads_grid();
    const float *positions = hatch_mesh_find(mesh, "POSITION", 3), *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    for (size_t v = 0; v < VERTICES; v++)
        for (size_t c = 0; c < 3; c++) {
            /* 20 bits with sign of the vector's largest, which is under 8; 8 bits of an octahedron. */
            ck_assert_float_eq_tol(positions[3 * v + c], grid.positions[3 * v + c], 8.0f / (1 << 19));
            ck_assert_float_eq_tol(normals[3 * v + c], grid.normals[4 * v + c], 2.0f / 127);
        }
}
END_TEST

START_TEST(the_file_of_a_fallback_is_not_read)
{
    compress("NONE", "INDICES");
    print_json("NONE", "INDICES",
               "{\"uri\":\"missing.bin\",\"extensions\":{\"EXT_meshopt_compression\":"
               "{\"fallback\":true}},\"byteLength\":99999}");
    reads_grid();
}
END_TEST

/* Replaces the first `from` of the JSON. */
static void replace(const char *from, const char *to)
{
    char rest[sizeof made.json], *at = strstr(made.json, from);
    ck_assert_msg(at != NULL, "%s", from);
    strcpy(rest, at + strlen(from));
    strcpy(at, to);
    strcat(made.json, rest);
}

START_TEST(a_view_that_does_not_fit_is_refused)
{
    static const struct {
        const char *from, *to, *says;
    } wrong[] = {
        {"\"EXT_meshopt_compression\":{\"buffer\":0", "\"EXT_meshopt_compression\":{\"buffer\":7",
         "its buffer does not"},
        {"\"EXT_meshopt_compression\":{\"buffer\":0", "\"EXT_meshopt_compression\":{\"buffer\":\"0\"",
         "its buffer does"},
        {"\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":0,",
         "\"EXT_meshopt_compression\":{\"buffer\":0,"
         "\"byteOffset\":70000,",
         "exceed its buffer"},
        {"\"byteOffset\":0,\"byteLength\":", "\"byteOffset\":0,\"byteLength\":9", "exceed its buffer"},
        {"\"byteOffset\":0,\"byteLength\":", "\"byteOffset\":0,\"byteLength\":-", "exceed its buffer"},
        {"\"mode\":\"ATTRIBUTES\"", "\"mode\":\"WHOLE\"", "do not fit together"},
        {"\"mode\":\"ATTRIBUTES\"", "\"mode\":\"INDICES\"", "do not fit together"},
        {"\"mode\":\"ATTRIBUTES\"", "\"mode\":\"TRIANGLES\"", "do not fit together"},
        {"\"filter\":\"NONE\"", "\"filter\":\"QUATERNION\"", "do not fit together"},
        {"\"filter\":\"NONE\"", "\"filter\":\"OCTAHEDRAL\"", "do not fit together"},
        {"\"filter\":\"NONE\"", "\"filter\":3", "do not fit together"},
        {"\"byteStride\":12", "\"byteStride\":10", "do not fit together"},
        {"\"byteStride\":12", "\"byteStride\":260", "do not fit together"},
        {"\"byteStride\":12", "\"byteStride\":0", "do not fit together"},
        {"\"count\":300", "\"count\":299", "is not the view's byteLength"},
        {"\"count\":300", "\"count\":300.5", "do not fit together"},
        {"\"mode\":\"INDICES\",\"filter\":\"NONE\"", "\"mode\":\"INDICES\",\"filter\":\"EXPONENTIAL\"", "do not fit"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        make("NONE", "INDICES");
        replace(wrong[i].from, wrong[i].to);
        ck_assert_int_eq(read_made(), HATCH_BAD_INPUT);
        ck_assert_msg(strstr(err.text, wrong[i].says) && strstr(err.text, "EXT_meshopt_compression"), "%s: %s",
                      wrong[i].to, err.text);
    }
}
END_TEST

/* Reads the grid with another count of positions, which is more than were compressed. */
static void read_count(size_t count, const char *says)
{
    char bytes[64], vertices[64];
    make("NONE", "INDICES");
    snprintf(bytes, sizeof bytes, "\"byteLength\":%zu", 12 * count);
    snprintf(vertices, sizeof vertices, "\"count\":%zu", count);
    replace("\"byteLength\":3600", bytes);
    replace("\"count\":300", vertices);
    ck_assert_int_eq(read_made(), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, "buffer view 0, EXT_meshopt_compression: ") && strstr(err.text, says), "%zu: %s",
                  count, err.text);
}

/* No file asks for much more memory than it has bytes: a byte stands for 64 at most. */
START_TEST(a_view_that_is_too_short_is_refused)
{
    make("NONE", "INDICES");
    size_t most = 64 * made.length[0] / 12;
    read_count(1000000, "it is too short for its count");
    read_count(most + 1, "it is too short for its count");
    read_count(most, "its data are damaged");
}
END_TEST

START_TEST(damaged_views_are_refused)
{
    static const char *const views[] = {"buffer view 0", "buffer view 1", "buffer view 2"};
    for (size_t view = 0; view < 3; view++) {
        make("NONE", view == 0 ? "TRIANGLES" : "INDICES");
        made.bytes[made.offset[view]] ^= 0xff; /* the codec's signature */
        ck_assert_int_eq(read_made(), HATCH_BAD_INPUT);
        ck_assert_msg(strstr(err.text, views[view]) && strstr(err.text, "its data are damaged"), "%s", err.text);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("gltf_meshopt");
    TCase *tests = tcase_create("meshopt");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, compressed_views_are_read_exactly);
    tcase_add_test(tests, compressed_triangles_keep_their_order);
    tcase_add_test(tests, filters_are_undone);
    tcase_add_test(tests, the_file_of_a_fallback_is_not_read);
    tcase_add_test(tests, a_view_that_does_not_fit_is_refused);
    tcase_add_test(tests, a_view_that_is_too_short_is_refused);
    tcase_add_test(tests, damaged_views_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
