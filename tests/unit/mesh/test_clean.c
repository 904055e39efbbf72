#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "math/vector.h"
#include "measure/mesh_figures.h"
#include "meshes.h"

static struct hatch_mesh sphere(uint32_t faces)
{
    return bare_shape(HATCH_SHAPE_SPHERE, faces);
}

static struct hatch_mesh_figures measure(const struct hatch_mesh *mesh)
{
    struct hatch_mesh_figures figures;
    HATCH_TEST_OK(hatch_measure_mesh(mesh, &scratch, &figures, &err), &err);
    return figures;
}

static struct hatch_mesh_notes clean(struct hatch_mesh *mesh)
{
    struct hatch_mesh_notes notes = {0};
    HATCH_TEST_OK(hatch_mesh_clean(&keep, &scratch, mesh, &notes, &err), &err);
    return notes;
}

/* Vertices of a square and two others; the last is at the position of the first. */
static const float square[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 5, 5, -0.0f, 0, 0};

START_TEST(attributes_are_limited)
{
    const uint32_t faces[] = {0, 1, 2};
    struct hatch_mesh mesh = mesh_of(square, 6, faces, 1);
    float *data;
    while (mesh.attribute_count < HATCH_MESH_ATTRIBUTES_MAX)
        HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "_A", 1, &data, &err), &err);
    ck_assert_int_eq(hatch_mesh_add(&keep, &mesh, "_A", 1, &data, &err), HATCH_LIMIT);
    ck_assert_uint_eq(mesh.attribute_count, HATCH_MESH_ATTRIBUTES_MAX);
}
END_TEST

START_TEST(indices_are_of_vertices)
{
    const uint32_t good[] = {0, 1, 5}, bad[] = {0, 1, 6};
    struct hatch_mesh mesh = mesh_of(square, 6, good, 1);
    mesh.attributes[0].data[16] = 2; /* or the face would have no area */
    HATCH_TEST_OK(hatch_mesh_check(&mesh, &err), &err);
    mesh = mesh_of(square, 6, bad, 1);
    ck_assert_int_eq(hatch_mesh_check(&mesh, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "face 0: vertex index 6, want one below 6");
}
END_TEST

START_TEST(equal_positions_are_one_point)
{
    const uint32_t faces[] = {0, 1, 2};
    struct hatch_mesh mesh = mesh_of(square, 6, faces, 1);
    uint32_t point[6], count;
    const uint32_t want[] = {0, 1, 2, 3, 4, 0}; /* -0 equals 0 */
    HATCH_TEST_OK(hatch_mesh_weld(&mesh, &scratch, point, &count, &err), &err);
    ck_assert_uint_eq(count, 5);
    ck_assert_mem_eq(point, want, sizeof want);
}
END_TEST

START_TEST(tiny_coordinates_are_zero)
{
    const float pole[] = {1.2e-16f, 1, 0, -1e-14f, 1, 1e-16f, 1e-10f, 1, 0, 4, 0, 0, 0, 0, 4, 1e9f, 0, 0};
    const uint32_t faces[] = {0, 3, 4}, want[] = {0, 0, 1, 2, 3, 4};
    struct hatch_mesh mesh = mesh_of(pole, 6, faces, 1); /* no face uses the farthest vertex */
    uint32_t point[6], count;
    HATCH_TEST_OK(hatch_mesh_weld(&mesh, &scratch, point, &count, &err), &err);
    ck_assert_uint_eq(count, 5);
    ck_assert_mem_eq(point, want, sizeof want);
}
END_TEST

START_TEST(useless_faces_and_vertices_are_dropped)
{
    const uint32_t faces[] = {0, 1, 2, 0, 2, 3, 2, 0, 1, 1, 0, 2, 2, 1, 0, 0, 0, 1, 0, 5, 1, 1, 1, 1};
    struct hatch_mesh mesh = mesh_of(square, 6, faces, 8);
    float *uv;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &uv, &err), &err);
    for (int i = 0; i < 12; i++)
        uv[i] = (float)i;
    struct hatch_mesh_notes notes = clean(&mesh);
    ck_assert_uint_eq(notes.degenerate_dropped, 3);
    ck_assert_uint_eq(notes.duplicates_dropped, 3);
    ck_assert_uint_eq(notes.unreferenced_dropped, 2);
    ck_assert_uint_eq(notes.faces_flipped + notes.non_manifold_edges + notes.contrary_edges, 0);
    ck_assert_uint_eq(mesh.face_count, 2);
    ck_assert_uint_eq(mesh.vertex_count, 4);
    ck_assert_mem_eq(mesh.attributes[0].data, square, 4 * 12);
    ck_assert_float_eq(hatch_mesh_find(&mesh, "TEXCOORD_0", 2)[7], 7);
}
END_TEST

START_TEST(a_mesh_without_area_is_bad_input)
{
    const float line[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
    const uint32_t faces[] = {0, 1, 2, 1, 2, 3};
    struct hatch_mesh mesh = mesh_of(line, 4, faces, 2);
    struct hatch_mesh_notes notes = {0};
    ck_assert_int_eq(hatch_mesh_clean(&keep, &scratch, &mesh, &notes, &err), HATCH_BAD_INPUT);
    ck_assert_uint_eq(mesh.face_count, 2);
    ck_assert_int_eq(hatch_mesh_check(&mesh, &err), HATCH_BAD_INPUT);
}
END_TEST

START_TEST(extreme_scales_have_area_and_normals)
{
    for (float scale = 1e-30f; scale < 1e31f; scale *= 1e30f) {
        float scaled[18];
        for (int i = 0; i < 18; i++)
            scaled[i] = square[i] * scale;
        const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
        struct hatch_mesh mesh = mesh_of(scaled, 4, faces, 2);
        ck_assert_uint_eq(clean(&mesh).degenerate_dropped, 0);
        HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &mesh, 0, &err), &err);
        ck_assert_float_eq(hatch_mesh_find(&mesh, "NORMAL", 3)[2], 1);
        ck_assert_double_eq_tol(measure(&mesh).area / (double)scale / (double)scale, 1, 1e-6);
    }
}
END_TEST

START_TEST(closed_meshes_are_oriented_outwards)
{
    for (uint32_t every = 2; every < 6; every++) {
        struct hatch_mesh mesh = sphere(800), good = sphere(800);
        uint32_t turned = 0;
        /* every = 2: the odd faces, half of all; else one face in `every`. */
        for (uint32_t f = 0; f < mesh.face_count; f++)
            if ((f % every == 0) != (every == 2)) {
                turn(&mesh, f);
                turned++;
            }
        ck_assert_uint_gt(measure(&mesh).contrary_edges, 0);
        struct hatch_mesh_notes notes = clean(&mesh);
        ck_assert_uint_eq(notes.faces_flipped, turned);
        ck_assert_uint_eq(notes.contrary_edges, 0);
        ck_assert_mem_eq(mesh.indices, good.indices, mesh.face_count * 12);
    }
}
END_TEST

START_TEST(open_components_keep_the_side_of_most_faces)
{
    const float strip[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0};
    const uint32_t faces[] = {0, 1, 2, 1, 3, 2, 2, 4, 3};
    struct hatch_mesh mesh = mesh_of(strip, 5, faces, 3);
    ck_assert_uint_eq(clean(&mesh).faces_flipped, 1);
    const uint32_t want[] = {0, 1, 2, 1, 3, 2, 2, 3, 4};
    ck_assert_mem_eq(mesh.indices, want, sizeof want);
    const uint32_t first[] = {0, 2, 1, 1, 3, 2, 2, 3, 4};
    mesh = mesh_of(strip, 5, first, 3);
    ck_assert_uint_eq(clean(&mesh).faces_flipped, 1);
    ck_assert_mem_eq(mesh.indices, want, sizeof want);
}
END_TEST

START_TEST(non_orientable_surfaces_are_reported)
{
    struct hatch_mesh plain = band(40, 1, false), twisted = band(40, 1, true);
    ck_assert_uint_eq(clean(&plain).contrary_edges, 0);
    ck_assert_uint_eq(measure(&plain).boundary_loops, 2);
    ck_assert_uint_eq(clean(&twisted).contrary_edges, 1);
    struct hatch_mesh_figures f = measure(&twisted);
    ck_assert_uint_eq(f.boundary_loops, 1);
    ck_assert_int_eq(f.euler, 0);
    ck_assert_int_eq(f.genus, -1);
}
END_TEST

START_TEST(non_manifold_points_and_edges_are_reported)
{
    /* Two tetrahedra that share vertex 3; three triangles that share the edge 0 1. */
    const float tips[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 1, 0, 2, 0, 1, 2};
    const uint32_t pair[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 4, 5, 6, 4, 3, 5, 5, 3, 6, 6, 3, 4};
    struct hatch_mesh mesh = mesh_of(tips, 7, pair, 8);
    struct hatch_mesh_figures f = measure(&mesh);
    ck_assert_uint_eq(f.non_manifold_points, 1);
    ck_assert_uint_eq(f.components, 1);
    ck_assert_uint_eq(f.boundary_loops, 0);
    ck_assert_uint_eq(clean(&mesh).non_manifold_points, 1);
    const uint32_t book[] = {0, 1, 2, 1, 0, 3, 0, 1, 6};
    mesh = mesh_of(tips, 7, book, 3);
    f = measure(&mesh);
    ck_assert_uint_eq(f.non_manifold_edges, 1);
    ck_assert_uint_eq(f.non_manifold_points, 0);
    ck_assert_uint_eq(clean(&mesh).non_manifold_edges, 1);
}
END_TEST

/* A face without area in the texture, and one without any. */
START_TEST(figures_of_nothing_are_not_numbers)
{
    const uint32_t face[] = {0, 1, 2}, line[] = {0, 1, 1};
    struct hatch_mesh mesh = mesh_of(square, 6, face, 1);
    float *uv;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &uv, &err), &err);
    struct hatch_mesh_figures figures = measure(&mesh);
    ck_assert_double_eq(figures.uv.degenerate_share, 1);
    ck_assert(isnan(figures.uv.mirrored_share) && isnan(figures.uv.angle[1]) && isnan(figures.uv.area[1]));
    ck_assert_double_eq_tol(figures.edge_min, 1, 1e-12);
    ck_assert_double_eq_tol(figures.edge_mean, (2 + sqrt(2)) / 3, 1e-12);
    ck_assert_double_eq_tol(figures.edge_max, sqrt(2), 1e-12);
    mesh = mesh_of(square, 6, line, 1);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &uv, &err), &err);
    figures = measure(&mesh);
    ck_assert(isnan(figures.uv.degenerate_share) && isnan(figures.uv.mirrored_share));
    ck_assert(isnan(figures.edge_min) && isnan(figures.edge_mean) && isnan(figures.edge_max));
}
END_TEST

START_TEST(figures_do_not_depend_on_order_or_welding)
{
    struct hatch_mesh mesh = sphere(900), shuffled = soup(&mesh);
    struct hatch_mesh_figures a = measure(&mesh), b = measure(&shuffled);
    ck_assert_uint_eq(b.vertices, 3 * mesh.face_count);
    ck_assert_uint_eq(a.points, b.points);
    ck_assert_int_eq(a.euler, b.euler);
    ck_assert_uint_eq(b.boundary_loops, 0);
    ck_assert_double_eq_tol(a.area, b.area, 1e-12);
    ck_assert_double_eq_tol(a.edge_mean, b.edge_mean, 1e-12);
    ck_assert_uint_eq(clean(&shuffled).vertices_apart, 3 * mesh.face_count - a.points);
}
END_TEST

START_TEST(normals_of_a_sphere_point_outwards_welded_or_not)
{
    struct hatch_mesh smooth = sphere(5000), loose = soup(&smooth);
    struct hatch_mesh *both[] = {&smooth, &loose};
    for (int i = 0; i < 2; i++) {
        HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, both[i], 0, &err), &err);
        const float *normals = hatch_mesh_find(both[i], "NORMAL", 3);
        double worst = 0;
        for (uint32_t v = 0; v < both[i]->vertex_count; v++) {
            double p[3], n[3];
            hatch_vec_of(&both[i]->attributes[0].data[v * 3], p);
            hatch_vec_of(&normals[v * 3], n);
            worst = fmax(worst, hatch_vec_distance(p, n));
        }
        ck_assert_double_lt(worst, 0.01);
    }
}
END_TEST

/* Checks that the normals of all faces are those of their planes. */
static void check_flat_normals(const struct hatch_mesh *mesh)
{
    const float *normal = hatch_mesh_find(mesh, "NORMAL", 3);
    for (uint32_t face = 0; face < mesh->face_count; face++) {
        double c[3][3], want[3], n[3];
        hatch_mesh_corners(mesh, face, c);
        hatch_vec_triangle(c[0], c[1], c[2], want);
        hatch_vec_normalize(want);
        for (uint32_t k = 0; k < 3; k++) {
            hatch_vec_of(&normal[mesh->indices[face * 3 + k] * 3], n);
            ck_assert_double_eq_tol(hatch_vec_dot(n, want), 1, 1e-6);
        }
    }
}

START_TEST(creases_split_vertices)
{
    struct hatch_mesh smooth = cube(0, 1), creased = cube(0, 1);
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &smooth, 0, &err), &err);
    ck_assert_uint_eq(smooth.vertex_count, 8);
    /* Weighted by angle, the normal at a cube's corner points along the diagonal, however the squares are split. */
    const float *normal = hatch_mesh_find(&smooth, "NORMAL", 3);
    for (int i = 0; i < 24; i++)
        ck_assert_float_eq_tol(fabsf(normal[i]), 0.57735027f, 1e-6f);
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &creased, 0.5f, &err), &err);
    ck_assert_uint_eq(creased.vertex_count, 24);
    struct hatch_mesh_figures f = measure(&creased);
    ck_assert_uint_eq(f.points, 8);
    ck_assert_double_eq_tol(f.area, 6, 1e-12);
    check_flat_normals(&creased);
}
END_TEST

/* Each corner triangle is within 60 degrees of three octagons, which are at right angles. */
START_TEST(corners_that_are_cut_off_do_not_join_the_sides_of_a_cube)
{
    struct hatch_mesh clipped = clipped_cube(0.1f);
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &clipped, (float)(PI / 3), &err), &err);
    ck_assert_uint_eq(clipped.vertex_count, 72);
    check_flat_normals(&clipped);
}
END_TEST

/* Coarse round shapes have faces at one point that differ by over 60 degrees, but no edge that does. */
START_TEST(coarse_round_shapes_stay_smooth)
{
    static const struct {
        enum hatch_shape kind;
        uint32_t faces;
    } round[] = {{HATCH_SHAPE_SPHERE, 40}, {HATCH_SHAPE_SPHERE, 80}, {HATCH_SHAPE_SPHERE, 200},
                 {HATCH_SHAPE_TORUS, 300}, {HATCH_SHAPE_TORUS, 400}, {HATCH_SHAPE_ELLIPSOID, 400}};
    for (size_t i = 0; i < sizeof round / sizeof *round; i++) {
        struct hatch_mesh smooth = bare_shape(round[i].kind, round[i].faces);
        struct hatch_mesh creased = bare_shape(round[i].kind, round[i].faces);
        HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &smooth, 0, &err), &err);
        HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &creased, (float)(PI / 3), &err), &err);
        ck_assert_uint_eq(creased.vertex_count, smooth.vertex_count);
        const float *want = hatch_mesh_find(&smooth, "NORMAL", 3), *got = hatch_mesh_find(&creased, "NORMAL", 3);
        for (uint32_t c = 0; c < 3 * smooth.face_count; c++)
            for (uint32_t k = 0; k < 3; k++)
                ck_assert_float_eq_tol(got[3 * creased.indices[c] + k], want[3 * smooth.indices[c] + k], 1e-6f);
    }
}
END_TEST

START_TEST(tangents_follow_mirrored_and_missing_textures)
{
    const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
    /* u to the right and v down; the same mirrored; all at one place. */
    const float uvs[3][8] = {{0, 1, 1, 1, 1, 0, 0, 0}, {1, 1, 0, 1, 0, 0, 1, 0}, {0}};
    const float want[3][2] = {{1, 1}, {-1, -1}, {0, 1}};
    for (int i = 0; i < 3; i++) {
        struct hatch_mesh mesh = mesh_of(square, 4, faces, 2);
        float *uv;
        HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &uv, &err), &err);
        memcpy(uv, uvs[i], sizeof uvs[i]);
        HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &mesh, 0, &err), &err);
        HATCH_TEST_OK(hatch_mesh_add_tangents(&keep, &scratch, &mesh, &err), &err);
        const float *tangent = hatch_mesh_find(&mesh, "TANGENT", 4);
        for (int v = 0; v < 4; v++) {
            if (i < 2)
                ck_assert_float_eq(tangent[v * 4], want[i][0]);
            ck_assert_float_eq(tangent[v * 4 + 2], 0);
            ck_assert_float_eq(tangent[v * 4 + 3], want[i][1]);
        }
    }
}
END_TEST

/* Of a square whose two faces meet at vertices 0 and 2, and two vertices without faces. */
START_TEST(normals_of_length_0_are_replaced_and_others_kept)
{
    const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
    struct hatch_mesh mesh = mesh_of(square, 6, faces, 2);
    uint32_t replaced = 3;
    float *normals;
    HATCH_TEST_OK(hatch_mesh_replace_normals(&scratch, &mesh, &replaced, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "NORMAL", 3, &normals, &err), &err);
    memcpy(normals + 3, (const float[]){5, 0, 0}, 3 * sizeof *normals);
    HATCH_TEST_OK(hatch_mesh_replace_normals(&scratch, &mesh, &replaced, &err), &err);
    ck_assert_uint_eq(replaced, 3 + 3);
    const float want[] = {0, 0, 1, 5, 0, 0, 0, 0, 1, 0, 0, 1};
    ck_assert_mem_eq(normals, want, sizeof want);
    for (int v = 4; v < 6; v++)
        ck_assert_float_eq(hypotf(hypotf(normals[3 * v], normals[3 * v + 1]), normals[3 * v + 2]), 1);
}
END_TEST

START_TEST(bounds_are_of_used_vertices)
{
    const uint32_t faces[] = {0, 1, 2};
    struct hatch_mesh mesh = mesh_of(square, 6, faces, 1);
    float low[3], high[3];
    ck_assert(hatch_mesh_bounds(&mesh, low, high));
    ck_assert_float_eq(high[0], 1);
    ck_assert_float_eq(high[2], 0);
    mesh.face_count = 0;
    ck_assert(!hatch_mesh_bounds(&mesh, low, high));
}
END_TEST

/* These work on a copy of the mesh: a successful call must not leave pointers into freed arenas. */
static enum hatch_status clean_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                   struct hatch_err *error)
{
    struct hatch_mesh_notes notes = {0};
    struct hatch_mesh mesh = *(const struct hatch_mesh *)context;
    return hatch_mesh_clean(kept, temporary, &mesh, &notes, error);
}

static enum hatch_status add_normals(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                     struct hatch_err *error)
{
    struct hatch_mesh mesh = *(const struct hatch_mesh *)context;
    return hatch_mesh_add_normals(kept, temporary, &mesh, 0.4f, error);
}

static enum hatch_status add_tangents(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                      struct hatch_err *error)
{
    struct hatch_mesh mesh = *(const struct hatch_mesh *)context;
    return hatch_mesh_add_tangents(kept, temporary, &mesh, error);
}

static enum hatch_status measure_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                     struct hatch_err *error)
{
    struct hatch_mesh_figures figures;
    if (!HATCH_NEW(kept, uint8_t, 1, error)) /* hatch_measure_mesh itself allocates in scratch only */
        return HATCH_LIMIT;
    return hatch_measure_mesh(context, temporary, &figures, error);
}

START_TEST(failed_allocations_are_reported)
{
    const hatch_test_call calls[] = {clean_one, add_normals, add_tangents, measure_one};
    for (int i = 0; i < 4; i++) {
        struct hatch_mesh mesh = sphere(60);
        float *data;
        HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &data, &err), &err);
        if (calls[i] == add_tangents)
            HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "NORMAL", 3, &data, &err), &err);
        hatch_test_fail_alloc(calls[i], &mesh, NULL, 0);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh clean");
    TCase *tests = tcase_create("clean");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, attributes_are_limited);
    tcase_add_test(tests, indices_are_of_vertices);
    tcase_add_test(tests, equal_positions_are_one_point);
    tcase_add_test(tests, tiny_coordinates_are_zero);
    tcase_add_test(tests, useless_faces_and_vertices_are_dropped);
    tcase_add_test(tests, a_mesh_without_area_is_bad_input);
    tcase_add_test(tests, extreme_scales_have_area_and_normals);
    tcase_add_test(tests, closed_meshes_are_oriented_outwards);
    tcase_add_test(tests, open_components_keep_the_side_of_most_faces);
    tcase_add_test(tests, non_orientable_surfaces_are_reported);
    tcase_add_test(tests, non_manifold_points_and_edges_are_reported);
    tcase_add_test(tests, figures_of_nothing_are_not_numbers);
    tcase_add_test(tests, figures_do_not_depend_on_order_or_welding);
    tcase_add_test(tests, normals_of_a_sphere_point_outwards_welded_or_not);
    tcase_add_test(tests, creases_split_vertices);
    tcase_add_test(tests, corners_that_are_cut_off_do_not_join_the_sides_of_a_cube);
    tcase_add_test(tests, coarse_round_shapes_stay_smooth);
    tcase_add_test(tests, tangents_follow_mirrored_and_missing_textures);
    tcase_add_test(tests, normals_of_length_0_are_replaced_and_others_kept);
    tcase_add_test(tests, bounds_are_of_used_vertices);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
