/* Places on faces, found from positions. */
#include <math.h>

#include "curve/curves.h"
#include "meshes.h"

/* Finds the shares of a place on a face, moved by a distance aside. */
static bool find_again(const float corners[9], const float share[2], float moved, float found[2])
{
    static const uint32_t corner[3] = {0, 1, 2};
    struct hatch_mesh one = mesh_of(corners, 3, corner, 1);
    const struct hatch_curve_point point = {.share = {share[0], share[1]}};
    float at[3];
    hatch_curve_position(&one, &point, at);
    at[2] += moved;
    return hatch_curve_find_share(&one, 0, at, found);
}

START_TEST(shares_follow_from_positions)
{
    static const float shares[][2] = {{0, 0}, {1, 0}, {0, 1}, {0.25f, 0.5f}, {0.3f, 0.7f}, {0, 0.6f}};
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++)
        for (int octave = -90; octave <= 90; octave += 30) {
            float size = ldexpf(1, octave), found[2];
            const float corners[9] = {size, 0, 0, 2 * size, size, 0, -size, 3 * size, 0};
            ck_assert(find_again(corners, shares[i], 0, found));
            ck_assert_float_eq_tol(found[0], shares[i][0], 1e-6f);
            ck_assert_float_eq_tol(found[1], shares[i][1], 1e-6f);
            ck_assert(find_again(corners, shares[i], 1e-3f * size, found));
            ck_assert(!find_again(corners, shares[i], 1e-2f * size, found));
        }
}
END_TEST

/* Rounding moves a position far in shares of a needle's corners; the place found is the nearest one all the same. */
START_TEST(rounded_positions_in_needles_have_places)
{
    static const float corners[] = {-90.6317062f, -52.9396172f, 126.212479f,  -72.4911728f, -52.9396172f,
                                    131.699127f,  -90.7279205f, -52.9396172f, 126.177116f};
    static const float position[3] = {-73.191597f, -52.9396172f, 131.487289f};
    static const uint32_t corner[3] = {0, 1, 2};
    struct hatch_mesh needle = mesh_of(corners, 3, corner, 1);
    struct hatch_curve_point point = {.face = 0};
    float at[3];
    ck_assert(hatch_curve_find_share(&needle, 0, position, point.share));
    hatch_curve_position(&needle, &point, at);
    ck_assert_float_le(fabsf(at[0] - position[0]) + fabsf(at[2] - position[2]), 3e-4f);
}
END_TEST

/* Faces that are nearly lines or points have places, too, as exact as positions are. */
START_TEST(thin_faces_have_places)
{
    static const float thin[][9] = {{0, 0, 0, 1, 0, 0, 0.3f, 1e-7f, 0},
                                    {0, 0, 0, 1, 0, 0, 0.3f, 0, 0},
                                    {0.5f, 0, 0, 0, 1, 0, 1, -1, 0},
                                    {1, 2, 3, 1, 2, 3, 1, 2, 3},
                                    {1000, 1000, 0, 1000.001f, 1000, 0, 1000, 1000.001f, 0}};
    static const uint32_t corner[3] = {0, 1, 2};
    for (size_t i = 0; i < sizeof thin / sizeof *thin; i++)
        for (int part = 0; part < 5; part++) {
            struct hatch_mesh one = mesh_of(thin[i], 3, corner, 1);
            const float share[2] = {0.25f * (float)part, 0.2f - 0.05f * (float)part};
            struct hatch_curve_point point = {.share = {share[0], share[1]}};
            float wanted[3], at[3];
            hatch_curve_position(&one, &point, wanted);
            ck_assert(find_again(thin[i], share, 0, point.share));
            hatch_curve_position(&one, &point, at);
            for (int k = 0; k < 3; k++)
                ck_assert_float_eq_tol(at[k], wanted[k], 1e-6f + 1e-6f * fabsf(wanted[k]));
        }
}
END_TEST

/* A small face far from the origin, along each axis: rounding moves positions off it by a millionth of its coordinates,
 * which is many times its size, and no farther. */
START_TEST(rounding_grows_with_coordinates)
{
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const float size = 0x1p-9f, share[2] = {0.25f, 0.5f};
            float corners[9] = {0, 0, 0, size, 0, 0, 0, size, 0}, found[2];
            for (int c = 0; c < 3; c++)
                corners[3 * c + axis] += (float)sign * 1024;
            ck_assert(find_again(corners, share, 0.0009f, found));
            ck_assert(!find_again(corners, share, 0.0013f, found));
            for (int k = 0; k < 2; k++)
                ck_assert_float_eq_tol(found[k], share[k], 0.1f);
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("shares");
    TCase *tests = tcase_create("shares");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, shares_follow_from_positions);
    tcase_add_test(tests, rounded_positions_in_needles_have_places);
    tcase_add_test(tests, thin_faces_have_places);
    tcase_add_test(tests, rounding_grows_with_coordinates);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
