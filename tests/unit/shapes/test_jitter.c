/* Vertices of built-in shapes that are moved at random, with long and with square grid cells. */
#include <math.h>

#include "math/vector.h"
#include "meshes.h"

/* Returns the number of faces that oppose the mean of their vertices' normals. */
static uint32_t faces_turned_over(const struct hatch_mesh *mesh)
{
    const float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    uint32_t turned = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double c[3][3], normal[3], n[3], sum = 0;
        ck_assert(hatch_mesh_corners(mesh, f, c));
        hatch_vec_triangle(c[0], c[1], c[2], normal);
        for (uint32_t k = 0; k < 3; k++) {
            hatch_vec_of(&normals[3 * (size_t)mesh->indices[3 * f + k]], n);
            sum += hatch_vec_dot(normal, n);
        }
        turned += sum <= 0;
    }
    return turned;
}

/* Long columns: their chords cut below a curved surface by more than a row is wide. The teapot's lip needs smaller
 * faces than these. */
START_TEST(no_face_turns_over_with_jitter_and_stretch)
{
    static const float stretches[] = {1, 4, 8, 16};
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++)
        for (int i = 0; i < 4 && shape != HATCH_SHAPE_TEAPOT; i++)
            for (uint32_t faces = 1000; faces <= 10000; faces *= 10) {
                struct hatch_mesh mesh = shape_with(
                    (enum hatch_shape)shape,
                    (struct hatch_shape_options){.faces = faces, .jitter = 1, .stretch = stretches[i], .seed = 1});
                uint32_t turned = faces_turned_over(&mesh);
                ck_assert_msg(turned == 0, "%s, %u faces, stretch %g: %u turned over",
                              hatch_shape_names[(enum hatch_shape)shape], faces, (double)stretches[i], turned);
            }
}
END_TEST

/* Without stretch, or with a stretch of 1, inner vertices of a plane move by up to a quarter of a step in both
 * directions; with a stretch of 4 by up to a sixteenth along u. */
START_TEST(jitter_moves_less_along_stretched_columns)
{
    static const double stretches[] = {0, 1, 4};
    for (int i = 0; i < 3; i++) {
        struct hatch_shape_options how = {.faces = 4800, .stretch = (float)stretches[i], .seed = 1};
        struct hatch_mesh still = shape_with(HATCH_SHAPE_PLANE, how);
        how.jitter = 1;
        struct hatch_mesh moved = shape_with(HATCH_SHAPE_PLANE, how);
        double farthest[2] = {0, 0}, corners[3][3], step[2] = {0, 0};
        hatch_mesh_corners(&still, 0, corners);
        for (int k = 0; k < 2; k++)
            for (int c = 1; c < 3; c++)
                step[k] = fmax(step[k], fabs(corners[c][k] - corners[0][k]));
        for (size_t v = 0; v < still.vertex_count; v++)
            for (size_t k = 0; k < 2; k++) {
                double a = (double)still.attributes[0].data[3 * v + k], b = (double)moved.attributes[0].data[3 * v + k];
                farthest[k] = fmax(farthest[k], fabs(a - b) / step[k]);
            }
        ck_assert_double_eq_tol(farthest[0], 0.25 / fmax(stretches[i], 1), 1e-3);
        ck_assert_double_eq_tol(farthest[1], 0.25, 1e-3);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("jitter");
    TCase *tests = tcase_create("jitter");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, no_face_turns_over_with_jitter_and_stretch);
    tcase_add_test(tests, jitter_moves_less_along_stretched_columns);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
