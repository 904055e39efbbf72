/* Growth of a patch, face by face, before anything is solved. */
#include "lapped_make.h"
#include "lapped/work.h"

struct grow_case {
    struct field_case field;
    struct hatch_outline outline;
    struct hatch_patch_domain domain;
    struct hatch_growth growth;
};

/* Begins a patch in the middle of a plane whose faces have the sides 1, with an outline of a radius. */
static void begin_patch(struct grow_case *made, double radius)
{
    made->field = case_of_shape(HATCH_SHAPE_PLANE, 2000, 1);
    set_direction(&made->field, 1, 0, 0);
    hatch_outline_make(3, 0.5, 0.05, &made->outline);
    const struct hatch_surface *surface = &made->field.surface;
    const struct hatch_lapped_input input = lapped_input(&made->field, &made->outline);
    uint8_t *covered = HATCH_NEW(&keep, uint8_t, surface->face_count, &err);
    ck_assert_ptr_nonnull(covered);
    HATCH_TEST_OK(hatch_patch_domain_make(&input, &LAPPED_DEFAULTS, NULL, &keep, &scratch, &made->domain, &err), &err);
    HATCH_TEST_OK(hatch_growth_make(&made->domain, &made->outline, covered, &keep, &made->growth, &err), &err);
    uint32_t middle = 0;
    double least = HUGE_VAL;
    for (uint32_t f = 0; f < surface->face_count; f++) {
        double away = hatch_vec_length(&surface->points[3 * (size_t)surface->corners[3 * f]]);
        if (away < least) {
            least = away;
            middle = f;
        }
    }
    hatch_growth_begin(&made->growth, middle);
    struct hatch_patch *patch = &made->growth.patch;
    patch->center[0] = patch->center[1] = 0;
    patch->radius = radius;
    patch->rotation[0] = 1;
    patch->rotation[1] = 0;
}

static double side_length(const double *a, const double *b)
{
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* Checks that the faces lie in the plane as on the surface, and that all sides within reach are grown across. */
static void check_patch(const struct grow_case *of)
{
    const struct hatch_patch *patch = &of->growth.patch;
    const struct hatch_surface *surface = &of->field.surface;
    bool full = patch->face_count == patch->faces_max;
    ck_assert_uint_le(patch->face_count, patch->faces_max);
    for (uint32_t i = 0; i < 3 * patch->face_count; i++) {
        uint32_t next = i % 3 == 2 ? i - 2 : i + 1, face = patch->faces[i / 3];
        const double *a = &patch->xy[2 * patch->corners[i]], *b = &patch->xy[2 * patch->corners[next]];
        ck_assert_uint_eq(patch->points[patch->corners[i]], surface->corners[3 * face + i % 3]);
        const double *from = &surface->points[3 * (size_t)surface->corners[3 * face + i % 3]];
        const double *to = &surface->points[3 * (size_t)surface->corners[3 * face + next % 3]];
        ck_assert_double_eq_tol(fabs(b[0] - a[0]), fabs(to[0] - from[0]), 1e-9);
        ck_assert_double_eq_tol(side_length(a, b), hatch_vec_distance(from, to), 1e-9);
    }
    for (uint32_t i = 0; i < patch->boundary_count; i++) {
        const struct hatch_boundary_side *side = &patch->boundary[i];
        ck_assert(side->growable && !side->covered);
        bool touched =
            hatch_patch_touches(patch, &of->outline, &patch->xy[2 * side->ends[0]], &patch->xy[2 * side->ends[1]]);
        ck_assert(full || !touched);
    }
}

START_TEST(growth_stops_at_its_limit)
{
    struct grow_case of;
    begin_patch(&of, 9);
    for (uint32_t limit = 1; limit < 60; limit += 7) {
        of.growth.patch.faces_max = limit;
        HATCH_TEST_OK(hatch_growth_grow(&of.growth, &err), &err);
        ck_assert_uint_eq(of.growth.patch.face_count, limit);
        check_patch(&of);
    }
}
END_TEST

/* A circle of radius r holds about π r² 4 / √3 equilateral triangles of side 1. */
START_TEST(growth_fills_the_outline)
{
    for (int radius = 2; radius <= 12; radius += 5) {
        struct grow_case of;
        begin_patch(&of, radius);
        struct hatch_patch *patch = &of.growth.patch;
        patch->faces_max = of.field.surface.face_count;
        HATCH_TEST_OK(hatch_growth_grow(&of.growth, &err), &err);
        check_patch(&of);
        uint32_t all = patch->face_count;
        double inner = 2 * radius * of.outline.core_min, outer = 2 * radius * of.outline.reach_max + 2;
        ck_assert_double_gt(all, PI * inner * inner * 4 / sqrt(3) * 0.9);
        ck_assert_double_lt(all, PI * outer * outer * 4 / sqrt(3) * 1.1);

        /* In two steps the same faces are found, in another order. */
        patch->faces_max = all / 2;
        HATCH_TEST_OK(hatch_growth_grow(&of.growth, &err), &err);
        ck_assert_uint_eq(patch->face_count, all / 2);
        HATCH_TEST_OK(hatch_growth_extend(&of.growth, &err), &err);
        ck_assert_uint_eq(patch->face_count, all / 2);
        patch->faces_max = of.field.surface.face_count;
        HATCH_TEST_OK(hatch_growth_extend(&of.growth, &err), &err);
        ck_assert_uint_eq(patch->face_count, all);
        check_patch(&of);
    }
}
END_TEST

/* The first round takes at most twice as many faces as the outline would contain if all were as large as the seed face,
 * but 16 in any case: here it is taken to be larger than it is. Patches that begin on one of these later start with
 * four times the faces of this one. */
START_TEST(a_first_round_takes_few_faces_around_a_large_one)
{
    static const double edges[] = {1, 2, 4, 1e3};
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
        struct grow_case of;
        struct hatch_patch_notes made;
        begin_patch(&of, 1);
        struct hatch_solver solver = {.arena = &keep};
        uint32_t seed = of.growth.patch.seed_face;
        of.domain.faces_max = UINT32_MAX;
        of.domain.target_radius[seed] = 8;
        of.domain.edge_length[seed] = edges[i];
        HATCH_TEST_OK(hatch_patch_make(&of.growth, &solver, &LAPPED_DEFAULTS, seed, 0, &made, &err), &err);
        double radius = 2 * of.outline.reach_max * 8 / edges[i], contained = PI * radius * radius * 4 / sqrt(3);
        uint32_t first = of.growth.first_attempt_count, later = 4 * of.growth.patch.face_count;
        if (i == 0)
            ck_assert_double_lt(first, 1.5 * contained);
        else
            ck_assert_double_eq_tol(first, fmax(2 * contained, 16), 0.9 + 0.01 * contained);
        for (uint32_t f = 0; f < first; f++)
            ck_assert_uint_eq(of.growth.start_faces_max[of.growth.first_attempt[f]], later);
        ck_assert_uint_gt(later / 4, 4 * 16);
    }
}
END_TEST

/* Of random triangles: through the corners of an acute one; an obtuse one has the longest side for a diameter. */
START_TEST(circles_enclose_triangles)
{
    uint32_t acute = 0;
    for (uint64_t i = 0; i < 300; i++) {
        double at[3][2], center[2], sides[3], longest = 0, squares = 0;
        for (uint64_t k = 0; k < 6; k++)
            at[k / 2][k % 2] = (double)hatch_random_unit(7, k, i) - 0.5;
        double radius = hatch_patch_enclosing_circle((const double(*)[2])at, center);
        for (int c = 0; c < 3; c++) {
            sides[c] = side_length(at[c], at[(c + 1) % 3]);
            longest = fmax(longest, sides[c]);
            squares += sides[c] * sides[c];
            ck_assert_double_le(side_length(center, at[c]), radius + 1e-9);
        }
        if (squares > 2 * longest * longest) {
            for (int c = 0; c < 3; c++)
                ck_assert_double_eq_tol(side_length(center, at[c]), radius, 1e-9);
            acute++;
        } else {
            ck_assert_double_eq_tol(radius, longest / 2, 1e-9);
        }
    }
    ck_assert(acute > 30 && acute < 270);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped growth");
    TCase *tests = tcase_create("growth");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, circles_enclose_triangles);
    tcase_add_test(tests, growth_stops_at_its_limit);
    tcase_add_test(tests, growth_fills_the_outline);
    tcase_add_test(tests, a_first_round_takes_few_faces_around_a_large_one);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
