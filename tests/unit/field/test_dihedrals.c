#include <math.h>

#include "meshes.h"
#include "surface_check.h"
#include "field/field.h"

#define CREASE_RAD (75 * PI / 180)
#define SIDES 24u

static struct hatch_surface surface;
static struct hatch_frames frames;
static double *direction, *confidence;

/* A can with a single row of faces about z, closed by fans; with a depth over 0 a gear. */
static struct hatch_mesh can(double height, double depth)
{
    float at[2 * SIDES + 2][3] = {{0}};
    uint32_t corners[4 * SIDES][3];
    for (uint32_t i = 0; i < SIDES; i++) {
        uint32_t next = (i + 1) % SIDES;
        for (uint32_t top = 0; top < 2; top++) {
            float *rim = at[i + top * SIDES];
            double radius = i % 4 < 2 ? 1 : 1 - depth;
            rim[0] = (float)(radius * cos(2 * PI * i / SIDES));
            rim[1] = (float)(radius * sin(2 * PI * i / SIDES));
            rim[2] = top ? (float)height : 0;
        }
        const uint32_t faces[4][3] = {{i, next, next + SIDES},
                                      {i, next + SIDES, i + SIDES},
                                      {2 * SIDES, next, i},
                                      {2 * SIDES + 1, i + SIDES, next + SIDES}};
        memcpy(corners[4 * i], faces, sizeof faces);
    }
    at[2 * SIDES + 1][2] = (float)height;
    return mesh_of(at[0], 2 * SIDES + 2, corners[0], 4 * SIDES);
}

static void fill(struct hatch_mesh mesh, const double *constraint_weight)
{
    surface = surface_of(&mesh);
    HATCH_TEST_OK(hatch_frames_make(&surface, &keep, &scratch, &frames, &err), &err);
    direction = HATCH_NEW(&keep, double, 3 * (size_t)surface.point_count, &err);
    confidence = HATCH_NEW(&keep, double, surface.point_count, &err);
    ck_assert(direction && confidence);
    hatch_field_fill_from_dihedrals(&surface, &frames, CREASE_RAD, constraint_weight, direction, confidence);
}

/* Of the edges at a point of a rim that are not creases one has a dihedral angle of 15 degrees, the diagonal 0. */
START_TEST(a_tube_of_long_faces_has_directions_around_it)
{
    fill(can(2, 0), NULL);
    uint32_t count = 0;
    for (uint32_t p = 0; p < surface.point_count; p++) {
        double at[3];
        const double *line = &direction[3 * (size_t)p];
        hatch_surface_position(&surface, p, at);
        double radius = hypot(at[0], at[1]);
        if (radius < 0.5) {
            ck_assert_double_eq(confidence[p], 0);
            continue;
        }
        count++;
        ck_assert_double_gt(confidence[p], 0.005);
        ck_assert_double_lt(confidence[p], 0.01);
        ck_assert_double_gt(fabs(line[0] * -at[1] + line[1] * at[0]) / radius, 1 - 1e-6);
    }
    ck_assert_uint_eq(count, 2 * SIDES);
}
END_TEST

static double largest_confidence(void)
{
    double most = 0;
    for (uint32_t p = 0; p < surface.point_count; p++)
        most = fmax(most, confidence[p]);
    return most;
}

START_TEST(mostly_flat_components_get_no_data)
{
    fill(can(0.4, 0), NULL);
    ck_assert_double_eq(largest_confidence(), 0);
    fill(can(2, 0.4), NULL);
    ck_assert_double_eq(largest_confidence(), 0);
    fill(cube(0, 1), NULL);
    ck_assert_double_eq(largest_confidence(), 0);
    fill(shape_of(HATCH_SHAPE_SPHERE, 200), NULL);
    ck_assert_double_eq(largest_confidence(), 0);
}
END_TEST

START_TEST(components_with_data_stay_as_they_are)
{
    double constraint_weight[2 * SIDES + 2] = {[3] = 1};
    fill(can(2, 0), constraint_weight);
    ck_assert_double_eq(largest_confidence(), 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("dihedrals");
    TCase *tests = tcase_create("dihedrals");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_tube_of_long_faces_has_directions_around_it);
    tcase_add_test(tests, mostly_flat_components_get_no_data);
    tcase_add_test(tests, components_with_data_stay_as_they_are);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
