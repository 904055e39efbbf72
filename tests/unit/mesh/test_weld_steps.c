/* Welding takes about as many steps per vertex among many as among few, along whichever axes the vertices lie. */
#include "meshes.h"
#include "steps.h"

/* Welds a row of vertices, each there twice, and returns the steps per vertex.
 *   axes  bits of the axes along which the row leads; on the others all coordinates are the same */
static double steps_a_vertex(uint32_t count, uint32_t axes)
{
    struct hatch_mesh mesh;
    uint32_t points, *point = HATCH_NEW(&keep, uint32_t, 2 * (size_t)count, &err);
    HATCH_TEST_OK(hatch_mesh_make(&keep, 2 * count, 1, &mesh, &err), &err);
    mesh.indices[2] = count;
    for (uint32_t i = 0; i < 6 * count; i++)
        mesh.attributes[0].data[i] = axes >> i % 3 & 1 ? (float)(i / 3 % count) / 8 : 7;
    steps = 0;
    HATCH_TEST_OK(hatch_mesh_weld(&mesh, &scratch, point, &points, &err), &err);
    double taken = (double)steps / (2 * count);
    ck_assert_uint_eq(points, count);
    for (uint32_t v = 0; v < 2 * count; v++)
        ck_assert_uint_eq(point[v], v % count);
    return taken;
}

/* Measured: 13 steps per vertex by gcc, 2 by clang, which counts fewer blocks; 2,500 among 1,000 along x if the hash of
 * a position leaves x out. Fewer than 1 would mean that steps are not counted. */
START_TEST(rows_along_all_axes_take_few_steps_a_vertex)
{
    for (uint32_t axes = 1; axes < 8; axes++) {
        double few = steps_a_vertex(1000, axes), many = steps_a_vertex(20000, axes);
        ck_assert_double_gt(few, 1);
        ck_assert_msg(few < 100 && many < 1.5 * few, "axes %u: %g steps a vertex of 1,000, %g of 20,000", axes, few,
                      many);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("mesh weld steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, rows_along_all_axes_take_few_steps_a_vertex);
    suite_add_tcase(made, tests);
    return made;
}
HATCH_TEST_MAIN(suite)
