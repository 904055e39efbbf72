/* Normals, texture coordinates and colours of vertices, as the formats give them. */
#include "files/read_mesh.h"

/* One triangle, as programs that have v upwards write it. */
START_TEST(v_of_texture_coordinates_points_downwards)
{
    static const char *const files[] = {
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 0.75\nf 1/1 2/2 3/3\n",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 0.75\n3 0 1 2\n"};
    const float want[] = {0, 1, 1, 1, 0, 0.25f};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        reads(text(files[i]), 3, 1);
        ck_assert_mem_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2), want, sizeof want);
    }
}
END_TEST

#define PLY_ROOF(n0, n1, n2, n3)                                                                                       \
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"                  \
    "property float nx\nproperty float ny\nproperty float nz\nelement face 2\n"                                        \
    "property list uchar int vertex_index\nend_header\n0 0 0 " n0 "\n1 0 0 " n1 "\n0 1 0 " n2 "\n0 0 1 " n3            \
    "\n9 9 9 0 0 0\n3 0 1 2\n3 0 2 3\n"

/* The normals of both faces are those of z and of x. */
START_TEST(missing_normals_are_those_of_the_faces)
{
    static const float half = 0.70710678f;
    reads(text(PLY_ROOF("0 0 0", "0 3 0", "0 4 0", "0 0 0")), 5, 2);
    const float want[] = {half, 0, half, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1};
    for (int i = 0; i < 15; i++)
        ck_assert_float_eq_tol(hatch_mesh_find(&mesh, "NORMAL", 3)[i], want[i], 1e-6f);
    ck_assert_uint_eq(notes.normals_replaced, 2); /* no face uses the last vertex */
    reads(text(PLY_ROOF("0 0 0", "0 0 0", "0 0 0", "0 0 0")), 5, 2);
    ck_assert_ptr_null(hatch_mesh_find(&mesh, "NORMAL", 3));
    ck_assert_uint_eq(notes.normals_replaced, 2);
    /* Corners without a normal are vertices of their own. */
    reads(text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 2 0\nvn 0 0 0\nf 1 2//1 3//1\nf 1//1 3//1 4//2\n"), 5, 2);
    const float obj[] = {0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0};
    ck_assert_mem_eq(hatch_mesh_find(&mesh, "NORMAL", 3), obj, sizeof obj);
    ck_assert_uint_eq(notes.normals_replaced, 4);
}
END_TEST

#define PLY_CORNERS(faces)                                                                                             \
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"                  \
    "property float nx\nproperty float ny\nproperty float nz\nelement face 2\n"                                        \
    "property list uchar float texcoord\nproperty list uchar int vertex_indices\nproperty int texnumber\nend_header\n" \
    "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n9 9 9 0 0 1\n" faces

/* Vertices are split where faces differ. */
START_TEST(faces_of_ply_may_have_texture_coordinates)
{
    reads(text(PLY_CORNERS("6 0 0 0.5 0 0.5 0.25 3 0 1 2 0\n6 0 0 0.5 0.25 1 1 3 0 2 3 0\n")), 4, 2);
    const float uv[] = {0, 1, 0.5f, 1, 0.5f, 0.75f, 1, 0};
    ck_assert_mem_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2), uv, sizeof uv);
    ck_assert_uint_eq(notes.unreferenced_dropped, 1);
    reads(text(PLY_CORNERS("6 0 0 0.5 0 0.5 0.25 3 0 1 2 0\n6 1 0 1 0.5 1 1 3 0 2 3 0\n")), 6, 2);
    const uint32_t indices[] = {0, 1, 2, 3, 4, 5};
    const float split[] = {0, 1, 0.5f, 1, 0.5f, 0.75f, 1, 1, 1, 0.5f, 1, 0};
    const float positions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0};
    ck_assert_mem_eq(mesh.indices, indices, sizeof indices);
    ck_assert_mem_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2), split, sizeof split);
    ck_assert_mem_eq(mesh.attributes[0].data, positions, sizeof positions);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "NORMAL", 3)[17], 1);
    ck_assert_uint_eq(notes.texcoords_missing, 0);
    reads(text(PLY_CORNERS("6 0 0 0.5 0 0.5 0.25 3 0 1 2 0\n0 3 0 2 3 0\n")), 6, 2);
    ck_assert_ptr_null(hatch_mesh_find(&mesh, "TEXCOORD_0", 2));
    ck_assert_uint_eq(notes.texcoords_missing, 3);
    reads(text(PLY_CORNERS("6 0 0 nan 0 0.5 0.25 3 0 1 2 0\n6 0 0 0.5 0.25 1 1 3 0 2 3 0\n")), 4, 2);
    ck_assert_uint_eq(notes.texcoords_missing, 4);
    reads(text(PLY_CORNERS("0 3 0 1 2 0\n0 3 0 2 3 0\n")), 4, 2);
    ck_assert_uint_eq(notes.texcoords_missing, 4);
    refused(PLY_CORNERS("6 0 0 0.5 0 0.5 0.25 3 0 1 2 0\n6 0 0 0.5 0 0.5 0.25"), "face 1: the file is truncated");
}
END_TEST

#define PLY_COLORS(type, more)                                                                                         \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"                  \
    "property " type " red\nproperty " type " green\nproperty " type " blue\n" more                                    \
    "element face 1\nproperty list uchar int vertex_index\nend_header\n"

/* Every value that a vertex in OFF may have. */
static const char all_of_off[] = "STCNOFF\n3 1 0\n0 0 0 0 0 2 0 51 255 51 0.25 0.5\n1 0 0 0 1 0 255 51 0 1 0\n"
                                 "0 1 0 0 0 1 255 255 255 255 0 1\n3 0 1 2\n";

/* sRGB of 0.5 is 0.21404114 in linear light (IEC 61966-2-1); alpha is linear. */
START_TEST(colours_become_linear)
{
    static const char *const files[] = {
        PLY_COLORS("float",
                   "property float alpha\n") "0 0 0 0 0.5 1 0.5\n1 0 0 1 0.5 0 1\n0 1 0 nan nan nan 1\n3 0 1 2\n",
        PLY_COLORS("uchar", "") "0 0 0 0 51 255\n1 0 0 255 51 0\n0 1 0 255 255 255\n3 0 1 2\n",
        "v 0 0 0 0 0.5 1\nv 1 0 0 1.5 0.5 -1 9\nv 0 1 0 1\nf 1 2 3\n",
        "v 9 9 9\nv 0 0 0 0 0.5 1\nv 1 0 0 1 0.5 0\nv 0 1 0\nvt 0 0\nf 2/1 3/1 4/1\n",
        "COFF\n3 1 0\n0 0 0 0 0.5 1 0.5\n1 0 0 1 0.5 0\n0 1 0 # white\n3 0 1 2 0.1 0.1 0.1\n",
        all_of_off};
    static const float greens[] = {0.21404114f, 0.03310477f, 0.21404114f, 0.21404114f, 0.21404114f, 0.03310477f};
    static const float alphas[] = {0.5f, 1, 1, 1, 0.5f, 0.2f};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        const float want[] = {0, greens[i], 1, alphas[i], 1, greens[i], 0, 1, 1, 1, 1, 1};
        reads(text(files[i]), 3, 1);
        const float *colors = hatch_mesh_find(&mesh, "COLOR_0", 4);
        for (int k = 0; k < 12; k++)
            ck_assert_float_eq_tol(colors[k], want[k], 1e-6f);
    }
    const float uv[] = {0.25f, 0.5f, 1, 1, 0, 0}, normals[] = {0, 0, 1, 0, 1, 0, 0, 0, 1}; /* of the last */
    ck_assert_mem_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2), uv, sizeof uv);
    ck_assert_mem_eq(hatch_mesh_find(&mesh, "NORMAL", 3), normals, sizeof normals);
    reads(text("v 0 0 0 1\nv 1 0 0 a b c\nv 0 1 0 1 1 # 1\nf 1 2 3\n"), 3, 1);
    ck_assert_ptr_null(hatch_mesh_find(&mesh, "COLOR_0", 4));
    refused(PLY_COLORS("uchar", "") "0 0 0 0 51 255\n1 0 0 255 51 0\n0 1 0 255 9", "vertex 2: the file is truncated");
}
END_TEST

START_TEST(values_of_off_may_be_missing)
{
    reads(text("STNOFF\n3 1 0\n0 0 0 0 2 0 0.25 0.5\n1 0 0 0 1 0\n0 1 0\n3 0 1 2\n"), 3, 1);
    const float normals[] = {0, 1, 0, 0, 1, 0, 0, 0, 1};
    ck_assert_mem_eq(hatch_mesh_find(&mesh, "NORMAL", 3), normals, sizeof normals);
    ck_assert_ptr_null(hatch_mesh_find(&mesh, "TEXCOORD_0", 2));
    ck_assert_uint_eq(notes.texcoords_missing, 2);
    ck_assert_uint_eq(notes.normals_replaced, 1);
    reads(text("OFF\n3 1 0\n0 0 0 0 2 0\n1 0 0 0 1 0\n0 1 0\n3 0 1 2\n"), 3, 1);
    ck_assert_uint_eq(mesh.attribute_count, 1);
}
END_TEST

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_bytes files[] = {text(all_of_off), text("v 0 0 0\nv 1 0 0 1 0 1\nv 0 1 0\nf 1// 2// 3//\n"),
                                  text(PLY_ROOF("0 0 0", "0 1 0", "0 1 0", "0 1 0")),
                                  text(PLY_CORNERS("6 0 0 0.5 0 0.5 0.25 3 0 1 2 0\n6 0 0 0.5 0.25 1 1 3 0 2 3 0\n"))};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        hatch_test_fail_alloc(read_mesh_file, &files[i], &mesh, sizeof mesh);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io mesh attributes");
    TCase *tests = tcase_create("readers");
    tcase_add_checked_fixture(tests, begin_reading, end);
    tcase_add_test(tests, v_of_texture_coordinates_points_downwards);
    tcase_add_test(tests, missing_normals_are_those_of_the_faces);
    tcase_add_test(tests, faces_of_ply_may_have_texture_coordinates);
    tcase_add_test(tests, colours_become_linear);
    tcase_add_test(tests, values_of_off_may_be_missing);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
