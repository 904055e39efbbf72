#include <math.h>
#include <stdio.h>
#include <string.h>

#include "files/read_mesh.h"
#include "measure/mesh_figures.h"

static double area(void)
{
    struct hatch_mesh_figures figures;
    HATCH_TEST_OK(hatch_measure_mesh(&mesh, &scratch, &figures, &err), &err);
    return figures.area;
}

/* A tetrahedron, the mesh of the files below. */
static const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static const uint32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

static void check_tetrahedron(void)
{
    ck_assert_uint_eq(mesh.vertex_count, 4);
    ck_assert_uint_eq(mesh.face_count, 4);
    ck_assert_mem_eq(mesh.attributes[0].data, corners, sizeof corners);
    ck_assert_mem_eq(mesh.indices, faces, sizeof faces);
}

#define PLY_HEAD(format)                                                                                               \
    "ply\nformat " format " 1.0\ncomment four faces\nelement vertex 4\nproperty float x\n"                             \
    "property float y\nproperty float z\nelement face 4\n"                                                             \
    "property list uchar int vertex_indices\nend_header\n"

static const char ascii_ply[] = PLY_HEAD("ascii") "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                                  "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

static void add_u32(struct hatch_buffer *buffer, uint32_t value, bool big_endian)
{
    uint8_t bytes[4];
    for (int i = 0; i < 4; i++)
        bytes[i] = (uint8_t)(value >> 8 * (big_endian ? 3 - i : i));
    HATCH_TEST_OK(hatch_buffer_add(buffer, bytes, 4, &err), &err);
}

static struct hatch_bytes binary_ply(bool big_endian)
{
    struct hatch_buffer file = {.arena = &keep};
    const char *head = big_endian ? PLY_HEAD("binary_big_endian") : PLY_HEAD("binary_little_endian");
    HATCH_TEST_OK(hatch_buffer_add(&file, head, strlen(head), &err), &err);
    for (int i = 0; i < 12; i++) {
        uint32_t bits;
        memcpy(&bits, &corners[i / 3][i % 3], 4);
        add_u32(&file, bits, big_endian);
    }
    for (int i = 0; i < 12; i++) {
        if (i % 3 == 0)
            HATCH_TEST_OK(hatch_buffer_add(&file, "\3", 1, &err), &err);
        add_u32(&file, faces[i / 3][i % 3], big_endian);
    }
    return (struct hatch_bytes){file.data, file.size};
}

static struct hatch_bytes binary_stl(const char *name)
{
    struct hatch_buffer file = {.arena = &keep};
    char head[80] = {0};
    strncpy(head, name, sizeof head - 1);
    HATCH_TEST_OK(hatch_buffer_add(&file, head, sizeof head, &err), &err);
    HATCH_TEST_OK(hatch_buffer_add_u32le(&file, 4, &err), &err);
    for (int f = 0; f < 4; f++) {
        HATCH_TEST_OK(hatch_buffer_add(&file, NULL, 12, &err), &err);
        for (int c = 0; c < 3; c++)
            HATCH_TEST_OK(hatch_buffer_add(&file, corners[faces[f][c]], 12, &err), &err);
        HATCH_TEST_OK(hatch_buffer_add(&file, NULL, 2, &err), &err);
    }
    return (struct hatch_bytes){file.data, file.size};
}

static const char ascii_obj[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
static const char ascii_off[] = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

START_TEST(every_format_gives_the_same_mesh)
{
    const struct hatch_bytes files[] = {text(ascii_ply), binary_ply(false), binary_ply(true), text(ascii_obj),
                                        text(ascii_off)};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        HATCH_TEST_OK(read_bytes(files[i]), &err);
        check_tetrahedron();
    }
    const char *names[] = {"a binary file", "solid, although binary"};
    for (int i = 0; i < 2; i++) {
        struct hatch_bytes file = binary_stl(names[i]);
        HATCH_TEST_OK(hatch_mesh_read((struct hatch_mesh_file){file, HATCH_MESH_STL}, &keep, &scratch, &mesh, origin,
                                      &notes, &err),
                      &err);
        ck_assert_uint_eq(mesh.vertex_count, 12);
        ck_assert_double_eq_tol(area(), 1.5 + sqrt(3.0) / 2, 1e-7);
    }
    reads(text("solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
               "vertex 0 1 0\nendloop\nendfacet\nendsolid a b\n"),
          3, 1);
}
END_TEST

START_TEST(formats_are_found_by_content_then_by_name)
{
    ck_assert_int_eq(hatch_mesh_format_of(text("ply\n"), "x.obj"), HATCH_MESH_PLY);
    ck_assert_int_eq(hatch_mesh_format_of(text("glTF...."), NULL), HATCH_MESH_GLTF);
    ck_assert_int_eq(hatch_mesh_format_of(text(" \n{}"), NULL), HATCH_MESH_GLTF);
    ck_assert_int_eq(hatch_mesh_format_of(text("COFF\n"), NULL), HATCH_MESH_OFF);
    ck_assert_int_eq(hatch_mesh_format_of(text("solid"), NULL), HATCH_MESH_STL);
    ck_assert_int_eq(hatch_mesh_format_of(text(" \nSOLID x"), NULL), HATCH_MESH_STL);
    ck_assert_int_eq(hatch_mesh_format_of(text("v\t0 0 0"), NULL), HATCH_MESH_OBJ);
    ck_assert_int_eq(hatch_mesh_format_of(text("vat 0 0 0"), NULL), HATCH_MESH_UNKNOWN);
    ck_assert_int_eq(hatch_mesh_format_of(text("# x\n\nv 1 2 3"), NULL), HATCH_MESH_OBJ);
    ck_assert_int_eq(hatch_mesh_format_of(text("\1\2\3"), "a/b.StL"), HATCH_MESH_STL);
    ck_assert_int_eq(hatch_mesh_format_of(text("f 1 2 3"), "b.OBJ"), HATCH_MESH_OBJ);
    ck_assert_int_eq(hatch_mesh_format_of(text(""), NULL), HATCH_MESH_UNKNOWN);
    ck_assert_int_eq(hatch_mesh_format_of((struct hatch_bytes){(const uint8_t *)"  {", 2}, NULL), HATCH_MESH_UNKNOWN);
    ck_assert_int_eq(read_bytes(text("none of these")), HATCH_BAD_INPUT);
}
END_TEST

/* Truncated anywhere but before the last line end. */
START_TEST(a_truncated_file_is_refused)
{
    const struct {
        struct hatch_bytes file;
        size_t optional; /* bytes at the end that may be missing */
    } files[] = {{text(ascii_ply), 1},
                 {binary_ply(true), 0},
                 {text(ascii_off), 1},
                 {binary_stl("s"), 0},
                 {binary_stl("solid s"), 0}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct hatch_bytes cut = files[i].file;
        enum hatch_mesh_format format = hatch_mesh_format_of(cut, "x.stl");
        for (cut.size = 0; cut.size < files[i].file.size - files[i].optional; cut.size++)
            ck_assert_msg(hatch_mesh_read((struct hatch_mesh_file){cut, format}, &keep, &scratch, &mesh, origin, &notes,
                                          &err) == HATCH_BAD_INPUT,
                          "file %zu, truncated after %zu bytes, is read", i, cut.size);
    }
}
END_TEST

#define PLY_POINTS(count)                                                                                              \
    "ply\nformat ascii 1.0\nelement vertex " count                                                                     \
    "\nproperty float x\nproperty float y\nproperty float z\nend_header\n"

START_TEST(errors_name_their_place)
{
    refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4: corner 4: vertex 4 does not exist, there are 3");
    refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4: corner -4: vertex -4 does not exist, there are 3");
    refused("v 0 0 0\nf 1/2 1 1\n", "texture coordinate 2 does not exist, there are 0");
    refused("v 0 0 0\nf 1//2 1 1\n", "normal 2 does not exist, there are 0");
    refused("v 0 0 0\nf 1/1/1/1 1 1\n", "texture");
    refused("v 0 0 0\nv 1 0 0\nf\n", "line 3: a face without corners");
    refused("v 0 0 0\nv 1 0 0\nf 1 2\n", "no faces");
    refused("v 0 0\nf 1 1 1\n", "line 1: v has too few numbers");
    refused("v 0 0 0x10\n", "0x10 is not a number");
    refused("v 0 0 nan\n", "nan is not a number");
    refused("v 0 0 1e39\n", "1e39 is too large");
    refused("v 0 0 1,5\n", "1,5 is not a number");
    refused("v 0 0 0\nsurface 1 2\n", "line 2: unknown keyword surface");
    refused("v 0 0 0\n\n# nothing\n", "no faces");
    refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6: vertex 3 does not exist, there are 3");
    refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "line 6: a face with 0 corners");
    refused("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no faces");
    refused("OFFX\n3 1 0\n", "X is not a number of vertices");
    refused("OFF\n3 9999 0\n0 0 0\n1 0 0\n", "9999 faces do not fit");
    refused("OFF BINARY\n3 1 0\n", "BINARY is not a number of vertices");
    refused("solid\nfacet normal 0 0 0\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n",
            "line 5: a facet with 2 corners");
    refused("solid\nhello\n", "line 2: unknown keyword hello");
    refused("ply\nformat ascii 2.0\nend_header\n", "line 2: unknown format ascii");
    refused("ply\nelement vertex 1\nproperty float x\nend_header\n0\n", "no format");
    refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n", "no properties x, y and z");
    refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n", "unknown type");
    refused("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n3 0 1 2\n",
            "element face: must follow the element vertex");
    refused("ply\nformat ascii 1.0\nelement vertex 99999\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n0 0 0\n",
            "element vertex: 99999");
    refused(PLY_POINTS("1") "0 0 0", "no faces"); /* a point needs six bytes, the last one five */
    refused(PLY_POINTS("2") "0 0 0", "element vertex: 2 items of at least 6 bytes do not fit into 5 bytes");
    refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nelement face 999999999999999999\nend_header\n0 0 0\n",
            "element face: no properties");
}
END_TEST

#define PLY_TRIANGLE                                                                                                   \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"                                    \
    "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"                             \
    "0 0 0\n1 0 0\n0 1 0\n"

START_TEST(ply_faces_are_checked)
{
    refused(PLY_TRIANGLE "3 0 1 3\n", "line 13: face 0: vertex index 3, want a whole number below 3");
    refused(PLY_TRIANGLE "3 0 1 -1\n", "face 0: vertex index -1, want a whole number below 3");
    refused(PLY_TRIANGLE "2 0 1\n", "no faces");
    refused(PLY_TRIANGLE "3 0 1\n", "the file is truncated");
    refused(PLY_TRIANGLE "200 0 1 2\n", "a list is longer than the file");
    refused(PLY_TRIANGLE "3 0 1 x\n", "not a number");
    reads(text(PLY_TRIANGLE "3 0 1 2\n"), 3, 1);
}
END_TEST

#define PLY_OTHER(element, data)                                                                                       \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"                  \
    "element face 1\nproperty list uchar int vertex_index\nelement " element                                           \
    "\nproperty uchar a\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2" data
#define PLY_NAME "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa" /* the longest */

START_TEST(ply_elements_may_be_empty_and_have_long_names)
{
    reads(text(PLY_OTHER("edge 0", "")), 3, 1);
    reads(text(PLY_OTHER("edge 3", "\n1\n2\n3")), 3, 1);
    reads(text(PLY_OTHER(PLY_NAME " 0", "")), 3, 1);
    refused(PLY_OTHER(PLY_NAME "a 0", ""), "0 is not a count");
}
END_TEST

START_TEST(faces_of_less_than_three_corners_are_dropped)
{
    const char *files[] = {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf 3\n",
                           "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n1 2\n",
                           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                           "property float z\nelement face 3\nproperty list uchar int vertex_index\n"
                           "end_header\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n0\n"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        notes.degenerate_dropped = 0;
        reads(text(files[i]), 3, 1);
        ck_assert_uint_eq(notes.degenerate_dropped, 2);
    }
}
END_TEST

/* Deviations from the formats that are common. */
START_TEST(files_of_other_programs_are_read)
{
    static const char ply[] = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                              "property float z\nproperty float quality\nelement face 1\n"
                              "property list uchar int vertex_index\nend_header\n"
                              "0 0 0 nan\n1 0 0 -inf\n0 1 0 1\n3 0 1 2\n";
    reads(text("\xef\xbb\xbf# marked\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), 3, 1);
    reads(text("\xef\xbb\xbfOFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 3, 1);
    reads(text("CSTOFF\n3 1 0\n0 0 0 1 1 1 1 .5 .25\n1 0 0 1 1 1 1 1 0\n"
               "0 1 0 1 1 1 1 0 1\n3 0 1 2\n"),
          3, 1);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2)[0], 0.5f);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2)[1], 0.75f); /* glTF's v points down */
    ck_assert_int_eq(hatch_mesh_format_of(text("CCOFF\n"), NULL), HATCH_MESH_UNKNOWN);
    reads(text("STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n"), 3, 1);
    reads(text(ply), 3, 1);
    static const char stl[] = " \n\tSOLID x\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\n"
                              "Vertex 0 1 0\nENDLOOP\nENDFACET\nENDSOLID x\n";
    HATCH_TEST_OK(hatch_mesh_read((struct hatch_mesh_file){text(stl), HATCH_MESH_STL}, &keep, &scratch, &mesh, origin,
                                  &notes, &err),
                  &err);
    ck_assert_uint_eq(mesh.face_count, 1);
    static const char one_line[] = "solid a vertex of a loop facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 "
                                   "vertex 0 1 0 endloop endfacet facet normal 0 0 1 outer loop vertex 1 0 0 vertex "
                                   "1 1 0 vertex 0 1 0 endloop endfacet endsolid a vertex";
    HATCH_TEST_OK(hatch_mesh_read((struct hatch_mesh_file){text(one_line), HATCH_MESH_STL}, &keep, &scratch, &mesh,
                                  origin, &notes, &err),
                  &err);
    ck_assert_uint_eq(mesh.face_count, 2);
    ck_assert_float_eq(mesh.attributes[0].data[3 * 4 + 1], 1);
    struct hatch_bytes file = binary_stl("solid, with trailing bytes");
    struct hatch_buffer longer = {.arena = &keep};
    HATCH_TEST_OK(hatch_buffer_add(&longer, file.data, file.size, &err), &err);
    HATCH_TEST_OK(hatch_buffer_add(&longer, "more", 4, &err), &err);
    reads((struct hatch_bytes){longer.data, longer.size}, 12, 4);
}
END_TEST

START_TEST(ply_attributes_and_strips_are_read)
{
    reads(text("ply\nformat ascii 1.0\nelement camera 1\nproperty float a\nproperty list int int b\n"
               "element vertex 4\nproperty double x\nproperty float64 y\nproperty float z\n"
               "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
               "property float s\nproperty float t\nelement tristrips 1\n"
               "property list int int vertex_indices\nend_header\n7 2 8 9\n"
               "0 0 0 0 0 2 1 0 0\n1 0 0 0 0 2 1 1 0\n0 1 0 0 0 2 1 0 1\n1 1 0 0 0 2 1 1 1\n"
               "14 0 1 2 3 -1 2 2 1 0 -1 0 1 0 2\n"),
          4, 4);
    const uint32_t want[] = {0, 1, 2, 1, 3, 2, 2, 0, 1, 1, 2, 0};
    ck_assert_mem_eq(mesh.indices, want, sizeof want);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "NORMAL", 3)[2], 1);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2)[7], 0);
}
END_TEST

/* Line ends are LF, CR LF, or CR alone, as on the first Macintosh. */
START_TEST(lines_may_end_in_any_way)
{
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    static const char *const files[] = {"# a / b~~mtllib a b~v 0 0 0~v 1 0 0 # c~v 0 \\~1 0~f 1 2 3~",
                                        "OFF # a~3 1 0~0 0 0~1 0 0~0 1 0~3 0 1 2~",
                                        "ply~format ascii 1.0~element vertex 3~property float x~property float y~"
                                        "property float z~element face 1~property list uchar int vertex_index~"
                                        "end_header~0 0 0~1 0 0~0 1 0~3 0 1 2~"};
    for (size_t i = 0; i < 3 * sizeof files / sizeof *files; i++) {
        struct hatch_buffer file = {.arena = &keep};
        for (const char *at = files[i / 3]; *at; at++)
            HATCH_TEST_OK(hatch_buffer_print(&file, &err, "%.*s", *at == '~' ? 2 : 1, *at == '~' ? ends[i % 3] : at),
                          &err);
        reads((struct hatch_bytes){file.data, file.size}, 3, 1);
        ck_assert_mem_eq(mesh.attributes[0].data, corners, 9 * sizeof(float));
    }
    ck_assert_str_eq(notes.library, "a b");
    refused("v 0 0 0\r\nv 1 0 0\rv 0 1 0\rf 1 2 4\r", "line 4: corner 4");
}
END_TEST

/* A polygon in the plane x + y + z = 0, in both orientations, from every first corner. want: area in xy. */
static void triangulates(const double (*outline)[2], uint32_t count, double want)
{
    for (uint32_t start = 0; start < count; start++)
        for (int reversed = 0; reversed < 2; reversed++) {
            struct hatch_buffer file = {.arena = &keep};
            for (uint32_t i = 0; i < count; i++)
                HATCH_TEST_OK(hatch_buffer_print(&file, &err, "v %.9g %.9g %.9g\n", outline[i][0], outline[i][1],
                                                 -outline[i][0] - outline[i][1]),
                              &err);
            HATCH_TEST_OK(hatch_buffer_print(&file, &err, "f"), &err);
            for (uint32_t i = 0; i < count; i++)
                HATCH_TEST_OK(
                    hatch_buffer_print(&file, &err, " %u", (reversed ? 2 * count + start - i : start + i) % count + 1),
                    &err);
            reads((struct hatch_bytes){file.data, file.size}, count, count - 2);
            ck_assert_double_eq_tol(area(), want * sqrt(3.0), 1e-5 * want);
        }
}

START_TEST(triangles_cover_their_polygon)
{
    const double arrow[][2] = {{0, 0}, {4, 0}, {0, 4}, {1, 1}};
    const double comb[][2] = {{0, 0}, {7, 0}, {7, 3}, {6, 1}, {5, 3}, {4, 1}, {3, 3}, {2, 1}, {0, 3}};
    const double straight[][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    double star[40][2], star_area = 0;
    for (int i = 0; i < 40; i++) {
        double radius = i % 2 ? 1 : 3, angle = 3.14159265358979 * i / 20;
        star[i][0] = radius * cos(angle);
        star[i][1] = radius * sin(angle);
        star_area += 0.5 * 3 * sin(3.14159265358979 / 20);
    }
    triangulates(arrow, 4, 6);
    triangulates(comb, 9, 14);
    triangulates(straight, 7, 4);
    triangulates((const double(*)[2])star, 40, star_area);
}
END_TEST

/* test_mesh_steps.c counts the steps that such polygons take. */
START_TEST(a_large_convex_polygon_is_triangulated)
{
    struct hatch_buffer file = {.arena = &keep};
    for (int i = 0; i < 20000; i++) {
        double a = 2 * 3.14159265358979 * i / 20000;
        HATCH_TEST_OK(hatch_buffer_print(&file, &err, "v %.6f %.6f 0\n", cos(a), sin(a)), &err);
    }
    HATCH_TEST_OK(hatch_buffer_print(&file, &err, "f"), &err);
    for (int i = 1; i <= 20000; i++)
        HATCH_TEST_OK(hatch_buffer_print(&file, &err, " %d", i), &err);
    reads((struct hatch_bytes){file.data, file.size}, 20000, 19998);
    ck_assert_double_eq_tol(area(), 3.14159265, 1e-4);
    ck_assert_uint_eq(notes.polygons_split, 1);
}
END_TEST

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_bytes files[] = {
        text(ascii_ply),
        text(ascii_obj),
        text(ascii_off),
        binary_stl("s"),
        text("mtllib x\nv 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\n"),
        text("solid\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\nendsolid\n")};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        hatch_test_fail_alloc(read_mesh_file, &files[i], &mesh, sizeof mesh);
}
END_TEST

/* A tetrahedron in a survey's coordinates, whose corners coincide when rounded to floats. */
START_TEST(a_mesh_far_from_the_origin_keeps_its_shape)
{
    static const double at[3] = {5e8, 0, -4e6};
    static const char *const files[] = {
        "v 500000000 0 -4000000\nv 500000001 0 -4000000\nv 500000000 1 -4000000\nv 500000000 0 -3999999\n"
        "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
        "OFF\n4 4 6\n500000000 0 -4000000\n500000001 0 -4000000\n500000000 1 -4000000\n500000000 0 -3999999\n"
        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 4\nproperty list uchar int vertex_indices\nend_header\n500000000 0 -4000000\n"
        "500000001 0 -4000000\n500000000 1 -4000000\n500000000 0 -3999999\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        reads(text(files[i]), 4, 4);
        ck_assert_uint_eq(notes.degenerate_dropped, 0);
        for (int v = 0; v < 4; v++)
            for (int k = 0; k < 3; k++)
                ck_assert_double_eq(origin[k] + (double)mesh.attributes[0].data[3 * v + k],
                                    at[k] + (double)corners[v][k]);
    }
    reads(text("solid\nfacet\nvertex 500000000 0 0\nvertex 500000001 0 0\nvertex 500000000 1 0\nendfacet\nendsolid\n"),
          3, 1);
    ck_assert_double_eq(area(), 0.5);
    reads(text(ascii_obj), 4, 4);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq(origin[k], 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io mesh");
    TCase *tests = tcase_create("readers");
    tcase_add_checked_fixture(tests, begin_reading, end);
    tcase_add_test(tests, every_format_gives_the_same_mesh);
    tcase_add_test(tests, formats_are_found_by_content_then_by_name);
    tcase_add_test(tests, a_truncated_file_is_refused);
    tcase_add_test(tests, errors_name_their_place);
    tcase_add_test(tests, ply_faces_are_checked);
    tcase_add_test(tests, ply_attributes_and_strips_are_read);
    tcase_add_test(tests, ply_elements_may_be_empty_and_have_long_names);
    tcase_add_test(tests, faces_of_less_than_three_corners_are_dropped);
    tcase_add_test(tests, files_of_other_programs_are_read);
    tcase_add_test(tests, lines_may_end_in_any_way);
    tcase_add_test(tests, triangles_cover_their_polygon);
    tcase_add_test(tests, a_large_convex_polygon_is_triangulated);
    tcase_add_test(tests, a_mesh_far_from_the_origin_keeps_its_shape);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
