/* Attributes that keep points of a flat sheet, up to the difference that may vanish. */
#include <math.h>

#include "coarse/coarse.h"

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

/* A texture that is stretched to 4 x 1 of its lengths may move by the tolerance in mean: by half of it in its own. */
START_TEST(textures_may_move_by_the_tolerance)
{
    struct hatch_mesh mesh = square();
    float *texcoords = add(&mesh, "TEXCOORD_0", 2), *middle = &texcoords[2 * (size_t)MIDDLE];
    for (uint32_t v = 0; v < POINTS; v++) {
        texcoords[2 * v] = mesh.attributes[0].data[3 * v] / 4;
        texcoords[2 * v + 1] = mesh.attributes[0].data[3 * v + 1];
    }
    middle[0] += 0.0029f;
    middle[1] -= 0.0039f;
    ck_assert(!keeps_middle(&mesh));
    middle[1] -= 0.0003f;
    ck_assert(keeps_middle(&mesh));
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
    tcase_add_test(tests, weights_may_differ_a_little);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
