/* Figures of coarse meshes beside closed forms: squares that are moved, tilted and cut. */
#include "fail_alloc.h"
#include "measure/coarse/coarse_figures.h"
#include "meshes.h"
#include "views.h"

#define PIXELS 50.0 /* per unit: a square of two units fills a picture of 100 x 100 pixels */

static const struct hatch_bounds bounds = {.radius = 1, .half = {1, 1, 1}};

/* Makes a square of n x n squares, one unit wide, around a point; it rises by `slope` along x. */
static struct hatch_mesh square(uint32_t n, double x, double z, double slope)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, (n + 1) * (n + 1), 2 * n * n, &mesh, &err), &err);
    for (uint32_t i = 0; i < (n + 1) * (n + 1); i++) {
        double along = (double)(i % (n + 1)) / n - 0.5;
        float *at = &mesh.attributes[0].data[3 * (size_t)i];
        at[0] = (float)(x + along);
        at[1] = (float)((double)(i / (n + 1)) / n - 0.5);
        at[2] = (float)(z + slope * along);
    }
    for (uint32_t q = 0; q < n * n; q++) {
        uint32_t a = q / n * (n + 1) + q % n, b = a + 1, c = a + n + 1, d = c + 1;
        const uint32_t faces[6] = {a, b, c, b, d, c};
        memcpy(&mesh.indices[6 * (size_t)q], faces, sizeof faces);
    }
    return mesh;
}

static struct hatch_coarse_figures figures_of(const struct hatch_mesh *full, const struct hatch_mesh *coarse,
                                              atomic_uint *worst)
{
    struct hatch_view view = view_facing;
    const struct hatch_view_set views = {&bounds, 1, &view, 100, 100};
    struct hatch_coarse_figures figures = {0};
    HATCH_TEST_OK(hatch_measure_coarse(full, coarse, &views, worst, NULL, &scratch, &figures, &err), &err);
    return figures;
}

START_TEST(a_mesh_does_not_differ_from_itself)
{
    struct hatch_mesh full = square(9, 0, 0, 0.25);
    struct hatch_coarse_figures figures = figures_of(&full, &full, NULL);
    ck_assert_double_le(figures.displacement_px, 1e-6);
    ck_assert_double_le(figures.displacement_p999_px, 1e-6);
    ck_assert_double_eq(figures.outline_px, 0);
    ck_assert_double_eq(figures.outline_p999_px, 0);
    ck_assert_double_le(figures.normal_deg, 1e-4);
}
END_TEST

/* A square that is raised by 20 pixels, and a vertex of it by one more. */
START_TEST(a_percentile_is_below_the_largest_also_over_16_pixels)
{
    struct hatch_mesh full = square(80, 0, 0, 0), raised = square(80, 0, 0.4, 0);
    raised.attributes[0].data[3 * (40 * 81 + 40) + 2] += 0.02f;
    struct hatch_coarse_figures figures = figures_of(&full, &raised, NULL);
    ck_assert_double_eq_tol(figures.displacement_px, 21, 0.01);
    ck_assert(figures.displacement_p999_px >= 20 && figures.displacement_p999_px <= 20.25);
}
END_TEST

/* A face without an area, whose three vertices lie in a row, has no normal to compare. */
START_TEST(faces_without_area_have_no_angle)
{
    struct hatch_mesh mesh = square(2, 0, 0, 0);
    uint32_t faces[27] = {[25] = 1, [26] = 2};
    memcpy(faces, mesh.indices, 24 * sizeof *faces);
    mesh.indices = faces;
    mesh.face_count = 9;
    ck_assert_double_le(figures_of(&mesh, &mesh, NULL).normal_deg, 1e-4);
}
END_TEST

/* Fine and coarse squares, each in the place of the other: the distance is the same everywhere. */
START_TEST(a_raised_square_is_displaced_by_its_height)
{
    struct hatch_mesh fine = square(9, 0, 0, 0), coarse = square(1, 0, 0.03, 0), flat = square(1, 0, 0, 0);
    const struct hatch_mesh *sides[4] = {&fine, &coarse, &flat, &coarse};
    for (int side = 0; side < 3; side++) {
        struct hatch_coarse_figures figures = figures_of(sides[side], sides[side + 1], NULL);
        ck_assert_double_eq_tol(figures.displacement_px, 0.03 * PIXELS, 1e-5);
        ck_assert_double_eq_tol(figures.displacement_p999_px, 0.03 * PIXELS, 1e-5);
        ck_assert_double_eq(figures.outline_px, 0);
        ck_assert_double_le(figures.normal_deg, 1e-4);
    }
}
END_TEST

/* Large faces have long rows of places. Beside few faces a row has lists of those near its parts, beside many it has
 * none, or some: the distance is the same. */
START_TEST(large_faces_are_as_far_from_few_faces_as_from_many)
{
    for (uint32_t n = 1; n <= 24; n++) {
        struct hatch_mesh large = square(1, 0, 0.03, 0), parts = square(n, 0, 0, 0);
        struct hatch_mesh *const meshes[2] = {&large, &parts};
        for (uint32_t i = 0; i < 2; i++)
            for (uint32_t v = 0; v < meshes[i]->vertex_count; v++)
                for (uint32_t k = 0; k < 2; k++)
                    meshes[i]->attributes[0].data[3 * v + k] *= 8;
        struct hatch_coarse_figures figures = figures_of(&large, &parts, NULL);
        ck_assert_double_eq_tol(figures.displacement_px, 0.03 * PIXELS, 1e-5);
    }
}
END_TEST

/* A triangle between two walls, with rows of places from one to the other. The places know which wall is nearer, so
 * that none is farther away than the middle. The walls are nearer to the triangle than that. */
START_TEST(no_place_is_farther_than_half_way_between_two_walls)
{
    static const float corners[9] = {-8, 0, 0, 8, 0, 0, 0, 4, 0};
    static const float walls_at[24] = {-9, 0, -1, -9, 4, -1, -9, 0, 1, -9, 4, 1, 9, 0, -1, 9, 4, -1, 9, 0, 1, 9, 4, 1};
    static const uint32_t wall_faces[12] = {0, 1, 2, 1, 3, 2, 4, 5, 6, 5, 7, 6};
    struct hatch_mesh full = mesh_of(corners, 3, wall_faces, 1), coarse = mesh_of(walls_at, 8, wall_faces, 4);
    struct hatch_coarse_figures figures = figures_of(&full, &coarse, NULL);
    ck_assert_double_le(figures.displacement_px, 9 * PIXELS + 1e-6);
    ck_assert_double_ge(figures.displacement_px, 9 * PIXELS - 2);
}
END_TEST

/* Places of either mesh count that are far from the other: a small square that only one of them has, beside the large
 * one that both have. Its far side is a quarter of a unit away. */
START_TEST(both_meshes_are_measured)
{
    struct hatch_mesh large = square(2, 0, 0, 0), small = square(1, 0, 0, 0);
    for (uint32_t v = 0; v < small.vertex_count; v++) {
        float *at = &small.attributes[0].data[3 * v];
        at[0] = 0.6875f + at[0] / 8;
        at[1] /= 8;
    }
    struct hatch_mesh more = both(&large, &small);
    for (int side = 0; side < 2; side++) {
        struct hatch_coarse_figures figures = figures_of(side ? &more : &large, side ? &large : &more, NULL);
        ck_assert_double_eq_tol(figures.displacement_px, 0.25 * PIXELS, 1e-5);
        ck_assert_double_eq(figures.outline_px, 0.25 * PIXELS);
        ck_assert_double_eq(figures.outline_p999_px, 0.25 * PIXELS);
    }
}
END_TEST

/* A square whose side moves by 4 eighths of a pixel: half of its outline moves, and all of that as far. */
START_TEST(a_square_that_moves_aside_moves_its_outline)
{
    struct hatch_mesh full = square(3, 0, 0, 0), coarse = square(1, 0.01, 0, 0);
    struct hatch_coarse_figures figures = figures_of(&full, &coarse, NULL);
    ck_assert_double_eq_tol(figures.displacement_px, 0.01 * PIXELS, 1e-5);
    ck_assert_double_eq(figures.outline_px, 0.5);
    ck_assert_double_eq(figures.outline_p999_px, 0.5);
    ck_assert_double_le(figures.normal_deg, 1e-4);
}
END_TEST

/* Distances of outlines beyond 16 pixels count as 16; those of surfaces, which the histogram does not reach, as they
 * are. */
START_TEST(far_places_count_as_the_farthest)
{
    struct hatch_mesh full = square(3, -0.2, 0, 0), coarse = square(1, 0.2, 0, 0);
    struct hatch_coarse_figures figures = figures_of(&full, &coarse, NULL);
    ck_assert_double_eq_tol(figures.displacement_px, 0.4 * PIXELS, 1e-4);
    ck_assert_double_eq_tol(figures.displacement_p999_px, 0.4 * PIXELS, 1e-4);
    ck_assert_double_eq(figures.outline_px, 16);
    ck_assert_double_eq(figures.outline_p999_px, 16);
}
END_TEST

START_TEST(normals_of_vertices_come_before_those_of_faces)
{
    struct hatch_mesh full = square(3, 0, 0, 0), coarse = square(1, 0, 0, 0);
    float *normals;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &full, "NORMAL", 3, &normals, &err), &err);
    for (uint32_t v = 0; v < full.vertex_count; v++) {
        normals[3 * v] = (float)sin(0.2);
        normals[3 * v + 2] = (float)cos(0.2);
    }
    ck_assert_double_eq_tol(figures_of(&full, &coarse, NULL).normal_deg, 0.2 * 180 / PI, 1e-3);
    ck_assert_double_eq_tol(figures_of(&coarse, &full, NULL).normal_deg, 0.2 * 180 / PI, 1e-3);
}
END_TEST

START_TEST(a_tilted_square_tilts_its_normals)
{
    struct hatch_mesh full = square(5, 0, 0, 0), coarse = square(1, 0, 0, tan(0.1));
    struct hatch_coarse_figures figures = figures_of(&full, &coarse, NULL);
    ck_assert_double_eq_tol(figures.normal_deg, 0.1 * 180 / PI, 1e-3);
    /* The edge of the full square lies 0.5 sin 0.1 beside the plane of the other. */
    ck_assert_double_eq_tol(figures.displacement_px, 0.5 * tan(0.1) * PIXELS, 0.02);
}
END_TEST

/* The worst displacement of each face, in thousandths of a pixel, rounded up: where the other surface rises along x, it
 * is that of the face's higher side. Other figures are not measured. */
START_TEST(faces_know_their_worst_displacement)
{
    enum { N = 10 };
    double slope = 0.1, cosine = 1 / sqrt(1 + slope * slope);
    struct hatch_mesh full = square(N, 0, 0, 0), coarse = square(1, 0, 0, slope);
    atomic_uint worst[2 * N * N] = {0};
    struct hatch_coarse_figures figures = figures_of(&full, &coarse, worst);
    ck_assert_double_eq(figures.outline_px, 0);
    ck_assert_double_eq(figures.normal_deg, 0);
    for (uint32_t f = 0; f < 2 * N * N; f++) {
        double left = (double)(f / 2 % N) / N - 0.5, high = fmax(fabs(left), fabs(left + 1.0 / N));
        double expected = 1000 * PIXELS * slope * high;
        /* Samples lie within the face, up to two thirds of its width from its higher side. */
        ck_assert_double_ge(worst[f], floor(cosine * (expected - 1000 * PIXELS * slope / N * 2 / 3)));
        /* Places of the coarse square may count for a face beside them. */
        ck_assert_uint_le(worst[f], (unsigned)ceil(expected * 1.06));
    }
    ck_assert_double_eq_tol(figures.displacement_px, 0.5 * slope * PIXELS, 0.02);
}
END_TEST

/* Positions are relative to the centre of the bounds, wherever that is. Seen from a camera at a distance of 2, lengths
 * count as in the orthographic picture. */
START_TEST(figures_do_not_depend_on_the_place_in_the_world)
{
    struct hatch_mesh full = square(9, 0, 0, 0), coarse = square(1, 0.01, 0, 0);
    const struct hatch_bounds far = {.center = {1e7, -3e6, 2e7}, .radius = 1, .half = {1, 1, 1}};
    struct hatch_view view = view_facing;
    view.orthographic = false;
    view.half_height = 0.5;
    const struct hatch_view_set views = {&far, 1, &view, 100, 100};
    struct hatch_coarse_figures figures;
    HATCH_TEST_OK(hatch_measure_coarse(&full, &coarse, &views, NULL, NULL, &scratch, &figures, &err), &err);
    ck_assert_double_eq_tol(figures.displacement_px, 0.01 * PIXELS, 1e-5);
    ck_assert_double_eq(figures.outline_px, 0.5);
}
END_TEST

/* One place in a thousand may be farther away than the percentile: a far small face beside a large square. */
START_TEST(the_percentile_leaves_out_few_places)
{
    struct hatch_mesh full = square(1, 0, 0, 0), small = square(1, 0, 0.2, 0);
    for (uint32_t v = 0; v < 4; v++)
        for (uint32_t k = 0; k < 2; k++)
            small.attributes[0].data[3 * v + k] *= 1e-3f;
    struct hatch_mesh coarse = both(&full, &small);
    full = square(80, 0, 0, 0);
    struct hatch_coarse_figures figures = figures_of(&full, &coarse, NULL);
    ck_assert_double_eq_tol(figures.displacement_px, 0.2 * PIXELS, 1e-4);
    ck_assert_double_le(figures.displacement_p999_px, 1.0 / 256);
}
END_TEST

struct again {
    struct hatch_mesh full, coarse;
    struct hatch_coarse_figures figures;
};

static enum hatch_status measure_again(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                       struct hatch_err *error)
{
    struct again *again = context;
    struct hatch_view view = view_facing;
    const struct hatch_view_set views = {&bounds, 1, &view, 100, 100};
    (void)arena;
    return hatch_measure_coarse(&again->full, &again->coarse, &views, NULL, NULL, temporary, &again->figures, error);
}

START_TEST(allocations_may_fail)
{
    struct again again = {.full = square(3, 0, 0, 0), .coarse = square(1, 0, 0.01, 0)};
    hatch_test_fail_alloc(measure_again, &again, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("measure coarse");
    TCase *tests = tcase_create("figures");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_mesh_does_not_differ_from_itself);
    tcase_add_test(tests, a_percentile_is_below_the_largest_also_over_16_pixels);
    tcase_add_test(tests, faces_without_area_have_no_angle);
    tcase_add_test(tests, a_raised_square_is_displaced_by_its_height);
    tcase_add_test(tests, large_faces_are_as_far_from_few_faces_as_from_many);
    tcase_add_test(tests, no_place_is_farther_than_half_way_between_two_walls);
    tcase_add_test(tests, both_meshes_are_measured);
    tcase_add_test(tests, a_square_that_moves_aside_moves_its_outline);
    tcase_add_test(tests, far_places_count_as_the_farthest);
    tcase_add_test(tests, normals_of_vertices_come_before_those_of_faces);
    tcase_add_test(tests, a_tilted_square_tilts_its_normals);
    tcase_add_test(tests, faces_know_their_worst_displacement);
    tcase_add_test(tests, figures_do_not_depend_on_the_place_in_the_world);
    tcase_add_test(tests, the_percentile_leaves_out_few_places);
    tcase_add_test(tests, allocations_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
