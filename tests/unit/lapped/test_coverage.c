/* Patches under the cores of others. */
#include "lapped_make.h"
#include "lapped/work.h"

static struct hatch_outline circle; /* its core is a circle of radius 0.43 */
static struct hatch_core_coverage coverage;

static void begin_coverage(void)
{
    begin();
    hatch_outline_make(1, 0, 0.05, &circle);
    HATCH_TEST_OK(hatch_core_coverage_make(&circle, 1, &keep, &coverage, &err), &err);
}

/* Computes the mask coordinates of a face with corners (-0.25, 0), (0.25, 0) and (0, height) in a patch around a center
 * in the same plane. */
static void mask_of_face(double height, double x, double y, double mask[3][2])
{
    const double corners[3][2] = {{-0.25, 0}, {0.25, 0}, {0, height}};
    for (int c = 0; c < 3; c++) {
        mask[c][0] = 0.5 + corners[c][0] - x;
        mask[c][1] = 0.5 + corners[c][1] - y;
    }
}

/* Lays two cores side by side on the face. They meet at (0, 0.308058). Then adds a patch around the face's middle, and
 * returns whether it is hidden. */
static bool is_third_hidden(double height)
{
    enum hatch_visibility visible;
    double mask[3][2];
    for (int side = -1; side <= 1; side += 2) {
        mask_of_face(height, 0.3 * side, 0, mask);
        HATCH_TEST_OK(hatch_core_coverage_add(&coverage, 0, (const double(*)[2])mask, &visible, &err), &err);
        ck_assert_int_eq(visible, HATCH_LAPPED_VISIBLE);
    }
    ck_assert(!coverage.covered[0]);
    uint32_t entry_count = coverage.entry_count;
    mask_of_face(height, 0, 0.1, mask);
    HATCH_TEST_OK(hatch_core_coverage_add(&coverage, 0, (const double(*)[2])mask, &visible, &err), &err);
    ck_assert_int_ne(visible, HATCH_LAPPED_HIDDEN);
    ck_assert(coverage.covered[0]);
    return hatch_core_coverage_hides(&coverage, entry_count, 0, (const double(*)[2])mask);
}

START_TEST(a_patch_under_the_union_of_two_is_hidden)
{
    ck_assert(is_third_hidden(0.307));
}
END_TEST

START_TEST(a_patch_that_shows_a_sliver_is_not_hidden)
{
    ck_assert(!is_third_hidden(0.3082));
}
END_TEST

/* A face in the middle of a core, one of whose corners is moved out of it along an axis. */
START_TEST(a_core_covers_no_face_with_a_corner_outside)
{
    enum hatch_visibility visible;
    for (int moved = 0; moved < 6; moved++) {
        double mask[4][2] = {{0.5, 0.5}, {0.51, 0.5}, {0.5, 0.51}, {0.5, 0.5}}; /* the last is no corner */
        mask[moved / 2][moved % 2] = 0.95;
        HATCH_TEST_OK(hatch_core_coverage_make(&circle, 1, &keep, &coverage, &err), &err);
        HATCH_TEST_OK(hatch_core_coverage_add(&coverage, 0, (const double(*)[2])mask, &visible, &err), &err);
        ck_assert_msg(!coverage.covered[0], "corner %d, axis %d", moved / 2, moved % 2);
    }
}
END_TEST

/* Only patches before it can hide a patch, not its own core. */
START_TEST(a_patch_does_not_hide_itself)
{
    enum hatch_visibility visible;
    double mask[3][2];
    mask_of_face(0.45, 0, 0, mask);
    HATCH_TEST_OK(hatch_core_coverage_add(&coverage, 0, (const double(*)[2])mask, &visible, &err), &err);
    ck_assert_uint_eq(coverage.entry_count, 1);
    mask_of_face(0.45, 0, -0.3, mask); /* visible only below a height of 0.18 */
    ck_assert(hatch_core_coverage_hides(&coverage, 1, 0, (const double(*)[2])mask));
    ck_assert(!hatch_core_coverage_hides(&coverage, 0, 0, (const double(*)[2])mask));
}
END_TEST

/* Returns whether a patch has opacity greater than 0, and no later patch has opacity 1, at one of some random points of
 * its faces. */
static bool is_seen(const struct lapped_case *made, uint32_t p)
{
    const struct hatch_lapped_patch *patch = &made->lapped.patches[p];
    uint32_t samples = 50000 / patch->face_count + 1;
    for (uint32_t i = 0; i < samples * patch->face_count; i++) {
        uint32_t entry = patch->first_face + i % patch->face_count;
        double root = sqrt((double)hatch_random_unit(3, p, 2 * i)), t = (double)hatch_random_unit(3, p, 2 * i + 1);
        const double bary[3] = {1 - root, root * (1 - t), root * t};
        double mask[2];
        mask_at(&made->lapped, p, entry, bary, mask);
        if (hatch_outline_opacity(&made->outline, mask) > 0 &&
            largest_opacity(made, made->lapped.faces[entry], bary, p + 1) < 1)
            return true;
    }
    return false;
}

START_TEST(hidden_patches_are_left_out)
{
    struct field_case field = case_of_shape(HATCH_SHAPE_TORUS, 2000, 1);
    set_direction(&field, 0, 1, 0);
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.size = 0.05;
    struct lapped_case torus = make_lapped(field, &options);
    check_patches(&torus, 20000);
    uint32_t hidden = 0;
    for (uint32_t p = 0; p < torus.lapped.patch_count; p++)
        hidden += !is_seen(&torus, p);
    ck_assert_uint_gt(torus.lapped.patch_count, 100);
    ck_assert_msg(hidden == 0, "%u of %u patches are hidden", hidden, torus.lapped.patch_count);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped coverage");
    TCase *tests = tcase_create("hidden patches");
    tcase_add_checked_fixture(tests, begin_coverage, end);
    tcase_add_test(tests, a_patch_under_the_union_of_two_is_hidden);
    tcase_add_test(tests, a_patch_that_shows_a_sliver_is_not_hidden);
    tcase_add_test(tests, a_core_covers_no_face_with_a_corner_outside);
    tcase_add_test(tests, a_patch_does_not_hide_itself);
    tcase_add_test(tests, hidden_patches_are_left_out);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
