/* Meshes on which the naive algorithm for normals, triangulation or tangents fails and that of libhatch does not. */
#include <math.h>
#include <string.h>

#include "io/mesh/file.h"
#include "math/vector.h"
#include "measure/mesh_figures.h"
#include "meshes.h"

static struct hatch_mesh sphere(float scale)
{
    struct hatch_mesh mesh =
        shape_with(HATCH_SHAPE_SPHERE, (struct hatch_shape_options){.faces = 1000, .jitter = 0.3f});
    mesh.attribute_count = 1;
    for (uint32_t i = 0; i < mesh.vertex_count * 3; i++)
        mesh.attributes[0].data[i] *= scale;
    return mesh;
}

/* The naive algorithm: sums the normals of the faces around each vertex in floats, without welding. */
static float *naive_normals(const struct hatch_mesh *mesh)
{
    const float *p = mesh->attributes[0].data;
    float *sums = HATCH_NEW(&keep, float, mesh->vertex_count * 3, &err);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *i = &mesh->indices[f * 3];
        float a[3], b[3];
        for (int k = 0; k < 3; k++) {
            a[k] = p[i[1] * 3 + (uint32_t)k] - p[i[0] * 3 + (uint32_t)k];
            b[k] = p[i[2] * 3 + (uint32_t)k] - p[i[0] * 3 + (uint32_t)k];
        }
        float n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (uint32_t c = 0; c < 3; c++)
            for (uint32_t k = 0; k < 3; k++)
                sums[i[c] * 3 + k] += n[k] / length;
    }
    return sums;
}

static const float *library_normals(struct hatch_mesh *mesh)
{
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, mesh, 0, &err), &err);
    return hatch_mesh_find(mesh, "NORMAL", 3);
}

/* The largest angle between a normal and the direction from the centre, in degrees; 180 for a normal that is zero or
 * not finite. */
static double worst_degrees(const struct hatch_mesh *mesh, const float *normals)
{
    double worst = 0;
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        double p[3], n[3];
        hatch_vec_of(&mesh->attributes[0].data[v * 3], p);
        hatch_vec_of(&normals[v * 3], n);
        double cosine = hatch_vec_dot(p, n) / hatch_vec_length(p) / hatch_vec_length(n);
        double angle = isfinite(cosine) ? acos(fmin(1, fmax(-1, cosine))) * 57.29577951 : 180;
        worst = fmax(worst, angle);
    }
    return worst;
}

START_TEST(normals_survive_squares_that_overflow_floats)
{
    const float scales[] = {1e-30f, 1e25f};
    for (int i = 0; i < 2; i++) {
        struct hatch_mesh mesh = sphere(scales[i]);
        ck_assert_double_eq(worst_degrees(&mesh, naive_normals(&mesh)), 180);
        ck_assert_double_lt(worst_degrees(&mesh, library_normals(&mesh)), 4);
    }
}
END_TEST

START_TEST(unwelded_vertices_get_smooth_normals)
{
    struct hatch_mesh mesh = sphere(1), soup;
    HATCH_TEST_OK(hatch_mesh_make(&keep, mesh.face_count * 3, mesh.face_count, &soup, &err), &err);
    for (uint32_t i = 0; i < mesh.face_count * 3; i++) {
        soup.indices[i] = i;
        memcpy(&soup.attributes[0].data[i * 3], &mesh.attributes[0].data[mesh.indices[i] * 3], 12);
    }
    ck_assert_double_gt(worst_degrees(&soup, naive_normals(&soup)), 8);
    ck_assert_double_lt(worst_degrees(&soup, library_normals(&soup)), 4);
}
END_TEST

START_TEST(inconsistent_winding_is_corrected)
{
    struct hatch_mesh mesh = sphere(1);
    for (uint32_t f = 0; f < mesh.face_count; f += 3) {
        uint32_t *index = &mesh.indices[f * 3], swap = index[1];
        index[1] = index[2];
        index[2] = swap;
    }
    struct hatch_mesh_notes notes = {0};
    ck_assert_double_gt(worst_degrees(&mesh, naive_normals(&mesh)), 80);
    HATCH_TEST_OK(hatch_mesh_clean(&keep, &scratch, &mesh, &notes, &err), &err);
    ck_assert_double_lt(worst_degrees(&mesh, library_normals(&mesh)), 4);
}
END_TEST

/* A cube whose squares are split along arbitrary diagonals: each has one or two triangles at a corner. */
START_TEST(normals_do_not_depend_on_how_squares_are_split)
{
    static const char cube[] = "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
                               "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    struct hatch_mesh mesh;
    struct hatch_mesh_notes notes = {0};
    HATCH_TEST_OK(hatch_mesh_read((struct hatch_mesh_file){{(const uint8_t *)cube, sizeof cube - 1}, HATCH_MESH_OBJ},
                                  &keep, &scratch, &mesh, NULL, &notes, &err),
                  &err);
    ck_assert_double_gt(worst_degrees(&mesh, naive_normals(&mesh)), 15);
    ck_assert_double_lt(worst_degrees(&mesh, library_normals(&mesh)), 1e-4);
}
END_TEST

START_TEST(non_convex_polygons_are_triangulated)
{
    /* A comb; a triangle fan from a corner covers more than its area. */
    static const char comb[] = "v 0 0 0\nv 7 0 0\nv 7 3 0\nv 6 1 0\nv 5 3 0\nv 4 1 0\nv 3 3 0\n"
                               "v 2 1 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8 9\n";
    static const char fan[] = "v 0 0 0\nv 7 0 0\nv 7 3 0\nv 6 1 0\nv 5 3 0\nv 4 1 0\nv 3 3 0\n"
                              "v 2 1 0\nv 0 3 0\nf 4 5 6\nf 4 6 7\nf 4 7 8\nf 4 8 9\nf 4 9 1\n"
                              "f 4 1 2\nf 4 2 3\n";
    const char *const files[] = {comb, fan};
    double areas[2];
    for (int i = 0; i < 2; i++) {
        struct hatch_mesh mesh;
        struct hatch_mesh_figures figures;
        struct hatch_mesh_notes notes = {0};
        HATCH_TEST_OK(
            hatch_mesh_read((struct hatch_mesh_file){{(const uint8_t *)files[i], strlen(files[i])}, HATCH_MESH_OBJ},
                            &keep, &scratch, &mesh, NULL, &notes, &err),
            &err);
        HATCH_TEST_OK(hatch_measure_mesh(&mesh, &scratch, &figures, &err), &err);
        areas[i] = figures.area;
    }
    ck_assert_double_gt(areas[1], 14.5);
    ck_assert_double_eq_tol(areas[0], 14, 1e-6);
}
END_TEST

START_TEST(degenerate_texture_coordinates_give_unit_tangents)
{
    struct hatch_mesh mesh = sphere(1);
    float *uv;
    library_normals(&mesh);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &uv, &err), &err);
    /* The naive algorithm divides by the area of the triangle in texture coordinates. */
    const float naive = (uv[0] - uv[2]) / ((uv[0] - uv[2]) * (uv[1] - uv[3]));
    ck_assert(!isfinite(naive));
    HATCH_TEST_OK(hatch_mesh_add_tangents(&keep, &scratch, &mesh, &err), &err);
    const float *tangent = hatch_mesh_find(&mesh, "TANGENT", 4);
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        double t[3], n[3];
        hatch_vec_of(&tangent[v * 4], t);
        hatch_vec_of(&hatch_mesh_find(&mesh, "NORMAL", 3)[v * 3], n);
        ck_assert_double_eq_tol(hatch_vec_length(t), 1, 1e-6);
        ck_assert_double_eq_tol(hatch_vec_dot(t, n), 0, 1e-6);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("stability mesh");
    TCase *tests = tcase_create("faults");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, normals_survive_squares_that_overflow_floats);
    tcase_add_test(tests, unwelded_vertices_get_smooth_normals);
    tcase_add_test(tests, inconsistent_winding_is_corrected);
    tcase_add_test(tests, normals_do_not_depend_on_how_squares_are_split);
    tcase_add_test(tests, non_convex_polygons_are_triangulated);
    tcase_add_test(tests, degenerate_texture_coordinates_give_unit_tangents);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
