#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "io/openmesh/openmesh.h"
#include "math/vector.h"
#include "measure/mesh_figures.h"
#include "meshes.h"

static struct hatch_mesh make(enum hatch_shape shape, uint32_t faces)
{
    return shape_with(shape, (struct hatch_shape_options){.faces = faces, .jitter = 0.3f, .seed = 1});
}

static struct hatch_mesh_figures measure(const struct hatch_mesh *mesh)
{
    struct hatch_mesh_figures figures;
    HATCH_TEST_OK(hatch_measure_mesh(mesh, &scratch, &figures, &err), &err);
    return figures;
}

START_TEST(openmesh_counts_the_same_elements)
{
    for (int shape = HATCH_SHAPE_SPHERE; shape < HATCH_SHAPE_COUNT; shape++) {
        struct hatch_mesh mesh = make((enum hatch_shape)shape, 900);
        struct hatch_mesh_figures figures = measure(&mesh);
        struct hatch_connectivity counted;
        HATCH_TEST_OK(hatch_mesh_connectivity(&mesh, &scratch, &counted, &err), &err);
        ck_assert_uint_eq(counted.left_out, 0);
        ck_assert_uint_eq(counted.points, figures.points);
        ck_assert_uint_eq(counted.boundary_loops, figures.boundary_loops);
        ck_assert_int_eq((int64_t)counted.points - counted.edges + counted.faces, figures.euler);
    }
}
END_TEST

START_TEST(a_third_face_at_an_edge_is_left_out)
{
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1};
    const uint32_t faces[] = {0, 1, 2, 1, 0, 3, 0, 1, 4, 2, 2, 3};
    struct hatch_mesh mesh;
    struct hatch_connectivity found;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 5, 4, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, positions, sizeof positions);
    memcpy(mesh.indices, faces, sizeof faces);
    HATCH_TEST_OK(hatch_mesh_connectivity(&mesh, &scratch, &found, &err), &err);
    ck_assert_uint_eq(found.left_out, 2);
    ck_assert_uint_eq(found.faces, 2);
    ck_assert_uint_eq(found.boundary_loops, 1);
}
END_TEST

START_TEST(a_decimated_sphere_keeps_its_shape_at_any_size)
{
    for (float scale = 1e-20f; scale < 1e21f; scale *= 1e20f) {
        struct hatch_mesh mesh = make(HATCH_SHAPE_SPHERE, 6000), small;
        for (uint32_t i = 0; i < mesh.vertex_count * 3; i++)
            mesh.attributes[0].data[i] *= scale;
        uint32_t left_out;
        HATCH_TEST_OK(hatch_mesh_decimate(&mesh, 600, &keep, &scratch, &small, &left_out, &err), &err);
        ck_assert_uint_eq(left_out, 0);
        ck_assert_uint_le(small.face_count, 600);
        ck_assert_uint_ge(small.face_count, 596);
        struct hatch_mesh_figures f = measure(&small);
        ck_assert_int_eq(f.genus, 0);
        ck_assert_uint_eq(f.boundary_loops + f.contrary_edges + f.degenerate_faces, 0);
        for (uint32_t v = 0; v < small.vertex_count; v++) {
            double p[3];
            hatch_vec_of(&small.attributes[0].data[v * 3], p);
            ck_assert_double_eq_tol(hatch_vec_length(p) / (double)scale, 1, 1e-4);
        }
        ck_assert_double_eq_tol(f.area / (double)scale / (double)scale, 12.566, 0.2);
    }
}
END_TEST

START_TEST(decimation_is_deterministic_and_leaves_small_meshes)
{
    struct hatch_mesh mesh = make(HATCH_SHAPE_TORUS, 2000), a, b;
    HATCH_TEST_OK(hatch_mesh_decimate(&mesh, 300, &keep, &scratch, &a, NULL, &err), &err);
    HATCH_TEST_OK(hatch_mesh_decimate(&mesh, 300, &keep, &scratch, &b, NULL, &err), &err);
    ck_assert_mem_eq(a.attributes[0].data, b.attributes[0].data, a.vertex_count * 12);
    ck_assert_mem_eq(a.indices, b.indices, a.face_count * 12);
    HATCH_TEST_OK(hatch_mesh_decimate(&mesh, 100000, &keep, &scratch, &a, NULL, &err), &err);
    ck_assert_uint_eq(a.face_count, mesh.face_count);
    ck_assert_int_eq(measure(&a).genus, 1);
}
END_TEST

static enum hatch_status decimate_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                      struct hatch_err *error)
{
    struct hatch_mesh *mesh = context;
    return hatch_mesh_decimate(mesh, 20, kept, temporary, mesh + 1, NULL, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_mesh meshes[2] = {make(HATCH_SHAPE_SPHERE, 60)};
    hatch_test_fail_alloc(decimate_one, meshes, &meshes[1], sizeof meshes[1]);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io openmesh");
    TCase *tests = tcase_create("openmesh");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, openmesh_counts_the_same_elements);
    tcase_add_test(tests, a_third_face_at_an_edge_is_left_out);
    tcase_add_test(tests, a_decimated_sphere_keeps_its_shape_at_any_size);
    tcase_add_test(tests, decimation_is_deterministic_and_leaves_small_meshes);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
