/* Patches on meshes of several bodies: one body does not decide how large patches are on another. */
#include "lapped_make.h"
#include "lapped/work.h"

/* Returns the number of faces of the largest patch on a range of faces. */
static uint32_t largest_patch(const struct lapped_case *made, uint32_t first_face, uint32_t face_count)
{
    uint32_t largest = 0;
    for (uint32_t p = 0; p < made->lapped.patch_count; p++) {
        const struct hatch_lapped_patch *patch = &made->lapped.patches[p];
        uint32_t seed = made->lapped.faces[patch->first_face];
        if (seed >= first_face && seed < first_face + face_count)
            largest = patch->face_count > largest ? patch->face_count : largest;
    }
    return largest;
}

/* A body on which patches cost more than SOLVED_MAX per face of the whole mesh: noise ends each of them after a few
 * faces, though they are meant to be as large as the body. The patches of a plane after it have as many faces as those
 * of a plane before it. */
START_TEST(a_costly_body_does_not_limit_later_ones)
{
    struct hatch_shape_options noisy = {.faces = 4000, .jitter = 1, .noise = 1, .seed = 3};
    struct hatch_mesh rough = shape_with(HATCH_SHAPE_TORUS, noisy), plane = bare_shape(HATCH_SHAPE_PLANE, 1000);
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.size = 0.5;
    options.curved = 0;
    move(&plane, 1, 10);
    struct field_case after = case_of(both(&rough, &plane)), before = case_of(both(&plane, &rough));
    set_direction(&after, 1, 0, 0);
    set_direction(&before, 1, 0, 0);
    struct lapped_case first = make_lapped(before, &options), last = make_lapped(after, &options);
    ck_assert_uint_gt(last.lapped.solved_faces, 64 * (uint64_t)after.surface.face_count);
    uint32_t largest_before = largest_patch(&first, 0, plane.face_count);
    uint32_t largest_after = largest_patch(&last, rough.face_count, plane.face_count);
    ck_assert_msg(largest_before > 200 && largest_after == largest_before, "patches of %u faces before, %u after",
                  largest_before, largest_after);
}
END_TEST

/* Returns the target radii of the faces.
 *   curved  as in the options */
static const double *radii_beside(const struct field_case *field, double curved)
{
    static struct hatch_outline outline;
    struct hatch_patch_domain domain;
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.curved = curved;
    hatch_outline_make(3, 0.3, 0.05, &outline);
    const struct hatch_lapped_input input = lapped_input(field, &outline);
    HATCH_TEST_OK(hatch_patch_domain_make(&input, &options, NULL, &keep, &scratch, &domain, &err), &err);
    return domain.target_radius;
}

/* A torus of fine faces, for which the cap of 1000 faces is small, beside a plane whose diagonal is 200 times as long:
 * its patches shrink by its curvature. */
START_TEST(a_small_body_shrinks_by_its_curvature_beside_a_large_one)
{
    struct hatch_mesh torus = bare_shape(HATCH_SHAPE_TORUS, 20000), plane = bare_shape(HATCH_SHAPE_PLANE, 2);
    move(&plane, 200, 0);
    struct field_case field = case_of(both(&torus, &plane));
    set_direction(&field, 0, 0, 1);
    const double *flat = radii_beside(&field, 0), *curved = radii_beside(&field, 1);
    for (uint32_t f = 0; f < torus.face_count; f++)
        ck_assert_msg(curved[f] < 0.99 * flat[f], "face %u: radius %g of %g", f, curved[f], flat[f]);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped bodies");
    TCase *tests = tcase_create("bodies");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_costly_body_does_not_limit_later_ones);
    tcase_add_test(tests, a_small_body_shrinks_by_its_curvature_beside_a_large_one);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
