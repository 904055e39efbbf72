/* The nearest place on a fan of needles is found in about as many steps among many needles as among few; the surfaces
 * of two fans are compared in about as many per sample. */
#include "math/vector.h"
#include "mesh/nearest/nearest.h"
#include "measure/coarse/coarse_figures.h"
#include "meshes.h"
#include "steps.h"
#include "view/view.h"

/* Makes a cone of needles around its tip. */
static struct hatch_mesh cone(uint32_t count)
{
    struct hatch_mesh mesh = fan(count);
    mesh.attributes[0].data[3 * (size_t)count + 2] = 0.3f;
    return mesh;
}

/* Returns the steps per search from points beside the faces of a mesh. */
static double steps_a_search(const struct hatch_mesh *mesh)
{
    struct hatch_nearest nearest;
    uint32_t searches = 0, hint = 0;
    HATCH_TEST_OK(hatch_nearest_make(mesh, &keep, &scratch, &nearest, &err), &err);
    steps = 0;
    for (uint32_t f = 0; f < mesh->face_count; f += mesh->face_count / 500) {
        double corners[3][3];
        hatch_mesh_corners(mesh, f, corners);
        for (double along = 0.05; along < 1; along += 0.1, searches++) {
            struct hatch_nearest_place place;
            double at[3];
            for (int k = 0; k < 3; k++)
                at[k] = along * corners[0][k] + (1 - along) * corners[2][k] + 1e-3 * k;
            hatch_nearest_find(&nearest, at, hint, &place);
            hint = place.face;
        }
    }
    return (double)steps / searches;
}

/* Measured: 1,130 steps among 1,000 needles, 4,380 among 20,000; without capsules 2,100 and 47,700. Fewer than 30 would
 * mean that steps are not counted. */
START_TEST(a_search_takes_as_many_steps_among_many_needles)
{
    struct hatch_mesh small = cone(1000), large = cone(20000);
    double few = steps_a_search(&small), many = steps_a_search(&large);
    ck_assert_double_gt(few, 30);
    ck_assert_msg(many < 6 * few, "%g steps among 1,000, %g among 20,000", few, many);
}
END_TEST

/* In each octant as around the origin. */
START_TEST(a_search_takes_as_many_steps_wherever_the_mesh_lies)
{
    struct hatch_mesh middle = bare_shape(HATCH_SHAPE_TORUS, 20000);
    double here = steps_a_search(&middle);
    for (uint32_t octant = 0; octant < 8; octant++) {
        struct hatch_mesh moved = bare_shape(HATCH_SHAPE_TORUS, 20000);
        for (uint32_t i = 0; i < 3 * moved.vertex_count; i++)
            moved.attributes[0].data[i] += octant >> i % 3 & 1 ? 2 : -2;
        double there = steps_a_search(&moved);
        ck_assert_msg(there < 1.2 * here && here < 1.2 * there, "%g steps, %g in octant %u", here, there, octant);
    }
}
END_TEST

/* Returns the steps per needle of the comparison of a cone with another, in a picture of 1000 x 1000 pixels. */
static double steps_a_needle(uint32_t count, uint32_t coarse_count)
{
    struct hatch_mesh full = cone(count), coarse = cone(coarse_count);
    const struct hatch_bounds bounds = {.radius = 1, .half = {1, 1, 1}};
    struct hatch_view view = {.orthographic = true, .half_height = 1, .aspect = 1};
    const struct hatch_view_set views = {&bounds, 1, &view, 1000, 1000};
    struct hatch_coarse_figures figures;
    atomic_uint *worst;
    HATCH_TEST_OK(HATCH_ALLOC(&keep, &worst, count, &err), &err);
    steps = 0;
    HATCH_TEST_OK(hatch_measure_coarse(&full, &coarse, &views, worst, NULL, &scratch, &figures, &err), &err);
    double sagitta_px = 500 * (1 - cos(PI / coarse_count));
    ck_assert_double_eq_tol(figures.displacement_px, sagitta_px, 0.05 * sagitta_px);
    return (double)steps / count;
}

/* Measured: 107,200 steps a needle of 1,000, which are wider, and 25,500 of 20,000; 146,400 and 50,500 without lists of
 * the faces near a run of samples, 192,800 and 193,900 without capsules. */
START_TEST(a_needle_takes_as_many_steps_beside_many_needles)
{
    double few = steps_a_needle(1000, 100), many = steps_a_needle(20000, 100);
    ck_assert_double_gt(few, 30);
    ck_assert_msg(many < 0.3 * few, "%g steps a needle of 1,000, %g of 20,000", few, many);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh nearest steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_search_takes_as_many_steps_among_many_needles);
    tcase_add_test(tests, a_search_takes_as_many_steps_wherever_the_mesh_lies);
    tcase_add_test(tests, a_needle_takes_as_many_steps_beside_many_needles);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
