/* Reads OBJ: its indices, and what it names beside faces. */
#include "files/read_mesh.h"

START_TEST(obj_index_triples_become_vertices)
{
    reads(text("mtllib x\nv 0 0 0 1 1 1\nv 1 0 0\r\nv 1 1 0\n\tv 0 1 0\nv 9 9 9\nvt 0 0\nvt 1 0.25\n"
               "vn 0 0 5\nf 1/1/1 2/2/1 \\\n 3/1/1\nf -5/1/1 3/1/1 4/2/-1 # last\nl 1 2\n"),
          4, 2);
    const float uv[] = {0, 1, 1, 0.75f, 0, 1, 1, 0.75f};
    ck_assert_mem_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2), uv, sizeof uv);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "NORMAL", 3)[11], 1);
    ck_assert_uint_eq(notes.unreferenced_dropped, 1);
    /* A texture seam doubles a vertex. Without texture coordinates in one face the attribute is dropped. */
    reads(text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/1 2/1\n"), 4, 2);
    ck_assert_ptr_nonnull(hatch_mesh_find(&mesh, "TEXCOORD_0", 2));
    reads(text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 1 3 2\n"), 6, 2);
    ck_assert_ptr_null(hatch_mesh_find(&mesh, "TEXCOORD_0", 2));
}
END_TEST

#define A_FACE "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
#define LONG_NAME "0123456789/0123456789/0123456789/0123456789/0123456789/0123456789/long.mtl"

/* A name may have spaces, but one that ends in .mtl begins a list of files. */
START_TEST(the_first_material_library_is_named)
{
    static const char *const files[][2] = {{"mtllib my mats.mtl" A_FACE, "my mats.mtl"},
                                           {"mtllib  my  mats.MTL \t\r" A_FACE, "my  mats.MTL"},
                                           {"mtllib one two" A_FACE "mtllib three.mtl", "one two"},
                                           {"mtllib one.mtl two.mtl # three" A_FACE, "one.mtl"},
                                           {"mtllib .mtl x # of y" A_FACE, ".mtl"},
                                           {"mtllib " LONG_NAME A_FACE, LONG_NAME}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        notes.library = NULL;
        reads(text(files[i][0]), 3, 1);
        ck_assert_str_eq(notes.library, files[i][1]);
    }
    notes.library = NULL;
    reads(text("mtllib " A_FACE), 3, 1);
    ck_assert_ptr_null(notes.library);
}
END_TEST

START_TEST(free_form_objects_are_left_out)
{
    reads(text("v 0 0 0\nv 1 0 0\nv 0 1 0\ncstype bspline\ndeg 3\ncurv 0 1 1 2 \\\n 3 1\nparm u 0 0 1 1\nend\n"
               "bmat u 1 2\nstep 1 1\nf 1 2 3\ncurv2 1 2\nsurf 0 1 0 1 1 2 3\ntrim 0 1 1\nhole 0 1 1\nscrv 0 1 1\n"
               "sp 1\ncon 1 0 1 1 2 0 1 1\nend\n"),
          3, 1);
    ck_assert_uint_eq(notes.free_forms_dropped, 3);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io mesh obj");
    TCase *tests = tcase_create("readers");
    tcase_add_checked_fixture(tests, begin_reading, end);
    tcase_add_test(tests, obj_index_triples_become_vertices);
    tcase_add_test(tests, the_first_material_library_is_named);
    tcase_add_test(tests, free_form_objects_are_left_out);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
