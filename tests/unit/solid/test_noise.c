#include "solid/noise.h"
#include "run.h"

static struct hatch_noise noise;

START_TEST(noise_is_zero_at_lattice_points)
{
    const struct hatch_noise_lattice lattice = {.cells = {3, 4, 5}, .key = 7};
    hatch_noise_make(1, &noise);
    for (int i = -60; i < 60; i++) {
        const float at[3] = {(float)(i % 7), (float)(i % 5), (float)(i % 3)};
        ck_assert_float_eq(hatch_noise_at(&noise, &lattice, at), 0);
    }
}
END_TEST

START_TEST(noise_repeats_after_its_cells)
{
    const struct hatch_noise_lattice lattice = {.cells = {1, 4, 6}, .key = 7};
    hatch_noise_make(1, &noise);
    float largest = 0;
    for (int i = 0; i < 1000; i++) {
        const float at[3] = {(float)(i % 64) / 64, (float)(i % 97) / 16, (float)(i % 51) / 8};
        const float far[3] = {at[0] - 3, at[1] + 8, at[2] - 6};
        float value = hatch_noise_at(&noise, &lattice, at);
        ck_assert_float_eq_tol(hatch_noise_at(&noise, &lattice, far), value, 1e-6f);
        largest = fmaxf(largest, fabsf(value));
    }
    ck_assert_float_gt(largest, 0.4f);
    ck_assert_float_lt(largest, 1);
}
END_TEST

/* At the middle of an edge of a cell, only the gradients of its ends count. */
START_TEST(noise_follows_from_the_gradients)
{
    const struct hatch_noise_lattice lattice = {.cells = {2, 2, 2}};
    const float middle[3] = {0.5f, 0, 0}, near[3] = {1e-3f, 0, 0}, before[3] = {2 - 1e-3f, 0, 0},
                end[3] = {1 - 1e-3f, 0, 0};
    hatch_noise_make(3, &noise);
    float slope = hatch_noise_at(&noise, &lattice, near) / 1e-3f;
    ck_assert_float_eq_tol(-hatch_noise_at(&noise, &lattice, before) / 1e-3f, slope, 1e-3f);
    float end_slope = -hatch_noise_at(&noise, &lattice, end) / 1e-3f;
    ck_assert_float_eq_tol(hatch_noise_at(&noise, &lattice, middle), (slope - end_slope) / 4, 1e-3f);
}
END_TEST

START_TEST(gradients_are_unit_vectors_without_a_preferred_direction)
{
    hatch_noise_make(1, &noise);
    double sum[3] = {0}, squares[3] = {0};
    for (uint32_t i = 0; i < HATCH_NOISE_GRADIENTS; i++) {
        float length = 0;
        for (int c = 0; c < 3; c++) {
            float part = noise.gradients[i][c];
            length += part * part;
            sum[c] += (double)part;
            squares[c] += (double)(part * part) / HATCH_NOISE_GRADIENTS;
        }
        ck_assert_float_eq_tol(length, 1, 1e-5f);
    }
    for (int c = 0; c < 3; c++) {
        ck_assert_double_eq_tol(sum[c], 0, 1e-9);
        ck_assert_double_eq_tol(squares[c], 1.0 / 3, 0.08);
    }
}
END_TEST

START_TEST(octaves_double_their_cells_and_share_an_amplitude_of_one)
{
    const uint32_t cells[3] = {3, 4, 5};
    hatch_noise_make(1, &noise);
    struct hatch_noise_octaves octaves = hatch_noise_octaves_make(&noise, 1, 2, cells, 20, 4, 0.5f);
    ck_assert_uint_eq(octaves.count, 3); /* the fourth would have 40 cells */
    ck_assert_uint_eq(octaves.lattices[2].cells[2], 20);
    ck_assert_float_eq_tol(octaves.amplitudes[0], 4.0f / 7, 1e-6f);
    ck_assert_float_eq_tol(octaves.amplitudes[2], 1.0f / 7, 1e-6f);
    ck_assert_uint_ne(octaves.lattices[0].key, octaves.lattices[1].key);
    const float at[3] = {0.3f, 0.7f, 0.1f}, far[3] = {1.3f, -0.3f, 2.1f};
    ck_assert_float_eq_tol(hatch_noise_sum(&octaves, at, false), hatch_noise_sum(&octaves, far, false), 1e-5f);
    octaves = hatch_noise_octaves_make(&noise, 1, 2, cells, 2, 4, 0.5f);
    ck_assert_uint_eq(octaves.count, 1);
    const float lattice[3] = {1.0f / 3, 0.25f, 0.2f};
    ck_assert_float_eq_tol(hatch_noise_sum(&octaves, lattice, true), 0, 1e-6f);
    ck_assert_float_eq(hatch_noise_sum(&octaves, at, true), fabsf(hatch_noise_sum(&octaves, at, false)));
}
END_TEST

START_TEST(the_cosine_is_that_of_libm)
{
    for (int i = -4000; i <= 4000; i++) {
        float turns = (float)i / 1024;
        ck_assert_double_eq_tol((double)hatch_noise_cosine(turns), cos(6.283185307179586 * (double)turns), 3e-7);
    }
    ck_assert_float_eq_tol(hatch_noise_step(0.25f), 0.15625f, 1e-7f);
    ck_assert_float_eq(hatch_noise_step(-1), 0);
    ck_assert_float_eq(hatch_noise_step(2), 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid noise");
    TCase *tests = tcase_create("noise");
    tcase_add_test(tests, noise_is_zero_at_lattice_points);
    tcase_add_test(tests, noise_repeats_after_its_cells);
    tcase_add_test(tests, noise_follows_from_the_gradients);
    tcase_add_test(tests, gradients_are_unit_vectors_without_a_preferred_direction);
    tcase_add_test(tests, octaves_double_their_cells_and_share_an_amplitude_of_one);
    tcase_add_test(tests, the_cosine_is_that_of_libm);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
