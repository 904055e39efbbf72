/* Attributes that keep points of a flat sheet, up to the difference that may vanish. */
#include <math.h>

#include "coarse/work.h"

#include "meshes.h"
#include "run.h"

enum { MIDDLE = 4, POINTS = 9 };
static const double tolerance = 0.01;

/* A square of 2 x 2 squares from 0 to 1, whose middle point is no longer needed for its shape. */
static struct hatch_mesh square(void)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, POINTS, 8, &mesh, &err), &err);
    for (uint32_t v = 0; v < POINTS; v++) {
        mesh.attributes[0].data[3 * v] = (float)(v % 3) / 2;
        mesh.attributes[0].data[3 * v + 1] = (float)(v / 3) / 2;
    }
    for (uint32_t q = 0; q < 4; q++) {
        uint32_t a = q / 2 * 3 + q % 2;
        const uint32_t faces[6] = {a, a + 1, a + 3, a + 1, a + 4, a + 3};
        memcpy(&mesh.indices[6 * (size_t)q], faces, sizeof faces);
    }
    return mesh;
}

static float *add(struct hatch_mesh *mesh, const char *name, uint32_t components)
{
    float *data;
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, name, components, &data, &err), &err);
    return data;
}

/* Makes the mesh coarser, with another part before it, which is far away and has no attributes. */
static bool keeps_middle(const struct hatch_mesh *mesh)
{
    double tolerances[POINTS];
    struct hatch_mesh other = square(), out[2];
    for (uint32_t v = 0; v < POINTS; v++) {
        tolerances[v] = tolerance;
        other.attributes[0].data[3 * v + 2] = 9;
    }
    const struct hatch_coarse_part parts[2] = {{&other, tolerances, NULL}, {mesh, tolerances, NULL}};
    HATCH_TEST_OK(hatch_coarse_make(parts, 2, &keep, &scratch, out, &err), &err);
    ck_assert_uint_eq(out[0].face_count, 2);
    for (uint32_t v = 0; v < out[1].vertex_count; v++)
        if (out[1].attributes[0].data[3 * v] == 0.5f && out[1].attributes[0].data[3 * v + 1] == 0.5f)
            return true;
    ck_assert_uint_eq(out[1].face_count, 2);
    return false;
}

/* Of a fan whose middle is its first point, no other point may go: they are its corners. */
START_TEST(the_first_point_may_go)
{
    enum { CORNERS = 6 };
    struct hatch_mesh fan, out;
    double tolerances[CORNERS + 1];
    HATCH_TEST_OK(hatch_mesh_make(&keep, CORNERS + 1, CORNERS, &fan, &err), &err);
    for (uint32_t i = 0; i <= CORNERS; i++) {
        tolerances[i] = tolerance;
        fan.attributes[0].data[3 * i] = i ? (float)cos(i * 6.2831853 / CORNERS) : 0;
        fan.attributes[0].data[3 * i + 1] = i ? (float)sin(i * 6.2831853 / CORNERS) : 0;
    }
    for (uint32_t f = 0; f < CORNERS; f++) {
        const uint32_t corners[3] = {0, 1 + f, 1 + (f + 1) % CORNERS};
        memcpy(&fan.indices[3 * (size_t)f], corners, sizeof corners);
    }
    const struct hatch_coarse_part part = {&fan, tolerances, NULL};
    HATCH_TEST_OK(hatch_coarse_make(&part, 1, &keep, &scratch, &out, &err), &err);
    ck_assert_uint_eq(out.face_count, CORNERS - 2);
}
END_TEST

/* Each component of a colour may differ by 0.03, whatever the others do. */
START_TEST(colours_may_differ_a_little)
{
    for (size_t component = 0; component < 4; component++) {
        struct hatch_mesh mesh = square();
        float *colors = add(&mesh, "COLOR_0", 4), *middle = &colors[4 * (size_t)MIDDLE];
        for (uint32_t i = 0; i < 4 * POINTS; i++)
            colors[i] = 0.5f;
        for (size_t c = 0; c < 4; c++)
            middle[c] += 0.029f;
        ck_assert(!keeps_middle(&mesh));
        middle[component] = 0.5f - 0.031f;
        ck_assert(keeps_middle(&mesh));
    }
}
END_TEST

/* Two targets, each of which may move the point by the tolerance. */
START_TEST(morph_targets_may_move_by_the_tolerance)
{
    for (size_t target = 0; target < 2; target++) {
        struct hatch_mesh mesh = square();
        float *moves = add(&mesh, HATCH_MORPH_POSITION, 6), *middle = &moves[6 * (size_t)MIDDLE];
        for (size_t c = 0; c < 6; c++)
            middle[c] = c % 3 == 0 ? 0.0059f : c % 3 == 1 ? -0.0079f : 0.0005f;
        ck_assert(!keeps_middle(&mesh));
        middle[3 * target] = 0.0062f;
        ck_assert(keeps_middle(&mesh));
    }
}
END_TEST

/* A texture may move by the tolerance on the surface, however it is stretched and sheared there: u = (x + shear y) /
 * of_u, v = y / of_v. A component that is constant does not tell how far. */
START_TEST(textures_may_move_by_the_tolerance)
{
    static const float cases[][3] = {{1, 1, 0},    {4, 1, 0}, {1, 100, 0}, {1, 1, 5},
                                     {0.1f, 7, 2}, {0, 1, 0}, {3, 0, 0}}; /* of_u, of_v, shear */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const float *by = cases[i], x_most = by[0] > 0 ? 0.006f : 0, y_most = by[1] > 0 ? 0.008f : 0;
        for (int step = 0; step < 2; step++) {
            struct hatch_mesh mesh = square();
            float *texcoords = add(&mesh, "TEXCOORD_0", 2), more = step ? 1.05f : 0.95f;
            more *= x_most > 0 && y_most > 0 ? 1 : x_most > 0 ? 0.01f / 0.006f : 0.01f / 0.008f;
            for (uint32_t v = 0; v < POINTS; v++) {
                float x = mesh.attributes[0].data[3 * v] + (v == MIDDLE ? more * x_most : 0);
                float y = mesh.attributes[0].data[3 * v + 1] - (v == MIDDLE ? more * y_most : 0);
                texcoords[2 * v] = by[0] > 0 ? (x + by[2] * y) / by[0] : 0.5f;
                texcoords[2 * v + 1] = by[1] > 0 ? y / by[1] : 0.5f;
            }
            ck_assert_msg(keeps_middle(&mesh) == step, "case %zu, step %d", i, step);
        }
    }
}
END_TEST

/* A corner at the origin between a face on which the texture has the lengths of the surface and a flat one on which it
 * is 2 and 3 times as long along x and y. The weight of either is the square of twice its area over that of its longest
 * side, whichever of its sides that is. */
START_TEST(lengths_of_textures_are_means_over_faces)
{
    static const float at[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, -3, -0.5f, 0, 3, -0.5f, 0};
    static const float texcoords[10] = {0, 0, 1, 0, 0, 1, -6, -1.5f, 6, -1.5f};
    const double weights[2] = {1.0 / 2, 9.0 / 36}, whole = weights[0] + weights[1];
    const double want[5][2] = {{whole / (weights[0] + 4 * weights[1]), whole / (weights[0] + 9 * weights[1])},
                               {1, 1},
                               {1, 1},
                               {1.0 / 4, 1.0 / 9},
                               {1.0 / 4, 1.0 / 9}};
    for (uint32_t turned = 0; turned < 3; turned++) {
        uint32_t faces[6] = {0, 1, 2};
        for (uint32_t c = 0; c < 3; c++)
            faces[3 + (c + turned) % 3] = c > 0 ? 2 + c : 0;
        struct hatch_mesh mesh = mesh_of(at, 5, faces, 2);
        memcpy(add(&mesh, "TEXCOORD_0", 2), texcoords, sizeof texcoords);
        const struct hatch_coarse_part part = {&mesh, &tolerance, NULL};
        struct hatch_coarse_work work = {.parts = &part, .part_count = 1};
        HATCH_TEST_OK(hatch_coarse_checks_make(&work, &keep, &err), &err);
        ck_assert_uint_eq(work.checks[0].count, 1);
        const float *scale = work.checks[0].attributes[0].scale;
        for (size_t v = 0; v < 5; v++) {
            ck_assert_double_eq_tol((double)scale[3 * v], want[v][0], 1e-6);
            ck_assert_double_eq_tol((double)scale[3 * v + 1], 0, 1e-6);
            ck_assert_double_eq_tol((double)scale[3 * v + 2], want[v][1], 1e-6);
        }
    }
}
END_TEST

/* A joint's weight may differ by 0.05, in whichever of the four places it is listed, and however often. */
START_TEST(weights_may_differ_a_little)
{
    struct hatch_mesh mesh = square();
    float *joints = add(&mesh, "JOINTS_0", 4), *weights = add(&mesh, "WEIGHTS_0", 4);
    static const float places[2][4] = {{3, 5, 7, 0}, {7, 3, 5, 5}},
                       shares[2][4] = {{0.5f, 0.3f, 0.2f, 0}, {0.2f, 0.5f, 0.1f, 0.2f}};
    for (uint32_t v = 0; v < POINTS; v++) {
        memcpy(&joints[4 * v], places[v == MIDDLE], sizeof *places);
        memcpy(&weights[4 * v], shares[v == MIDDLE], sizeof *shares);
    }
    float *middle = &weights[4 * (size_t)MIDDLE];
    ck_assert(!keeps_middle(&mesh));
    middle[3] += 0.049f;
    ck_assert(!keeps_middle(&mesh));
    middle[3] += 0.002f;
    ck_assert(keeps_middle(&mesh));
    middle[3] = 0.2f;
    joints[4 * (size_t)MIDDLE + 1] = 9; /* a joint that no other point has */
    ck_assert(keeps_middle(&mesh));
    memcpy(&joints[4 * (size_t)MIDDLE], (const float[]){3, 5, 7, 9}, sizeof *places);
    memcpy(middle, shares[0], 3 * sizeof *middle);
    middle[3] = 0.049f;
    ck_assert(!keeps_middle(&mesh));
    middle[3] = 0.051f;
    ck_assert(keeps_middle(&mesh));
    for (uint32_t i = 0; i < 4 * POINTS; i++) { /* the only joint of all points, whose weights need not sum to 1 */
        joints[i] = 3;
        weights[i] = 0.25f;
    }
    middle[3] = 0.202f;
    ck_assert(!keeps_middle(&mesh));
    middle[3] = 0.198f;
    ck_assert(keeps_middle(&mesh));
    mesh.attributes[1].name[0] = 'X'; /* without joints, weights mean nothing */
    ck_assert(!keeps_middle(&mesh));
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("coarse attributes");
    TCase *tests = tcase_create("attributes");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_first_point_may_go);
    tcase_add_test(tests, colours_may_differ_a_little);
    tcase_add_test(tests, morph_targets_may_move_by_the_tolerance);
    tcase_add_test(tests, textures_may_move_by_the_tolerance);
    tcase_add_test(tests, lengths_of_textures_are_means_over_faces);
    tcase_add_test(tests, weights_may_differ_a_little);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
