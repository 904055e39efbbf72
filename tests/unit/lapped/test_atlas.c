#include "fail_alloc.h"
#include "lapped/atlas.h"
#include "lapped_make.h"

#define MARGIN 0.004

static struct lapped_case torus_of(uint32_t faces)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_TORUS, faces, 1);
    lay_field(&of, 0, 0, 1);
    return cover_all(of, &LAPPED_PLAIN);
}

static double area_of(const float *at)
{
    double ax = (double)at[2] - (double)at[0], ay = (double)at[3] - (double)at[1];
    double bx = (double)at[4] - (double)at[0], by = (double)at[5] - (double)at[1];
    return -(ax * by - ay * bx) / 2;
}

/* Whether a place lies in a face's triangle of the layout, clear of its border. */
static bool inside(const float *at, double x, double y)
{
    for (int c = 0; c < 3; c++) {
        const float *a = &at[2 * c], *b = &at[2 * ((c + 1) % 3)];
        double dx = (double)b[0] - (double)a[0], dy = (double)b[1] - (double)a[1];
        if (dx * (y - (double)a[1]) - dy * (x - (double)a[0]) > -1e-7)
            return false;
    }
    return true;
}

START_TEST(no_two_faces_share_a_place)
{
    struct lapped_case torus = torus_of(3000);
    const struct hatch_surface *surface = &torus.of.surface;
    double scale, whole = 0;
    float *at = HATCH_NEW(&keep, float, 6 * (size_t)surface->face_count, &err);
    HATCH_TEST_OK(hatch_lapped_atlas(surface, &torus.lapped, &torus.outline, MARGIN, &scratch, at, &scale, &err), &err);
    for (uint32_t f = 0; f < surface->face_count; f++) {
        double p[3][3], normal[3];
        for (uint32_t c = 0; c < 3; c++) {
            hatch_surface_position(surface, surface->corners[3 * f + c], p[c]);
            ck_assert(at[6 * f + 2 * c] > 0 && at[6 * f + 2 * c] < 1);
            ck_assert(at[6 * f + 2 * c + 1] > 0 && at[6 * f + 2 * c + 1] < 1);
        }
        hatch_vec_triangle(p[0], p[1], p[2], normal);
        double ratio = area_of(&at[6 * f]) / (hatch_vec_length(normal) / 2 * scale * scale);
        ck_assert_msg(ratio > 0.2 && ratio < 4, "face %u has %g times its area", f, ratio);
        whole += area_of(&at[6 * f]);
    }
    ck_assert_msg(whole > 0.3, "the charts fill %g of the square", whole);
    for (uint64_t i = 0; i < 3000; i++) {
        double x = (double)hatch_random_unit(1, 0, i), y = (double)hatch_random_unit(1, 1, i);
        int found = 0;
        for (uint32_t f = 0; f < surface->face_count; f++)
            found += inside(&at[6 * f], x, y);
        ck_assert_int_le(found, 1);
    }
}
END_TEST

START_TEST(neighbours_in_a_chart_join)
{
    struct lapped_case torus = torus_of(3000);
    const struct hatch_surface *surface = &torus.of.surface;
    struct hatch_charts charts;
    HATCH_TEST_OK(hatch_charts_make(surface, &torus.lapped, &torus.outline, &keep, &charts, &err), &err);
    uint32_t joined = 0;
    for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
        uint32_t other = surface->opposite[side];
        if (charts.of[side / 3] != charts.of[other / 3])
            continue;
        uint32_t end = other % 3 == 2 ? other - 2 : other + 1;
        joined += charts.places[2 * side] == charts.places[2 * end] &&
                  charts.places[2 * side + 1] == charts.places[2 * end + 1];
    }
    ck_assert_msg(joined > 2 * surface->face_count, "only %u sides of %u join", joined, 3 * surface->face_count);
    ck_assert_uint_lt(charts.count, 4 * torus.lapped.patch_count);
}
END_TEST

START_TEST(boxes_lie_apart)
{
    double sizes[200], corners[200], side;
    for (uint32_t i = 0; i < 200; i++)
        sizes[i] = 0.1 + (double)hatch_random_unit(2, 0, i);
    HATCH_TEST_OK(hatch_shelves_pack(sizes, 100, 0.01, &scratch, corners, &side, &err), &err);
    double gap = 0.009 * side;
    for (uint32_t i = 0; i < 100; i++) {
        for (uint32_t k = 0; k < 2; k++)
            ck_assert(corners[2 * i + k] >= gap && corners[2 * i + k] + sizes[2 * i + k] <= side - gap);
        for (uint32_t j = 0; j < i; j++) {
            bool apart = false;
            for (uint32_t k = 0; k < 2; k++)
                apart = apart || corners[2 * i + k] >= corners[2 * j + k] + sizes[2 * j + k] + gap ||
                        corners[2 * j + k] >= corners[2 * i + k] + sizes[2 * i + k] + gap;
            ck_assert(apart);
        }
    }
}
END_TEST

static enum hatch_status lay_out(void *context, struct hatch_arena *result, struct hatch_arena *work,
                                 struct hatch_err *error)
{
    const struct lapped_case *of = context;
    double scale;
    float *at = HATCH_NEW(result, float, 6 * (size_t)of->of.surface.face_count, error);
    if (!at)
        return HATCH_LIMIT;
    return hatch_lapped_atlas(&of->of.surface, &of->lapped, &of->outline, MARGIN, work, at, &scale, error);
}

START_TEST(every_failed_allocation_is_survived)
{
    struct lapped_case torus = torus_of(200);
    hatch_test_fail_alloc(lay_out, &torus, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped atlas");
    TCase *tests = tcase_create("atlas");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, no_two_faces_share_a_place);
    tcase_add_test(tests, neighbours_in_a_chart_join);
    tcase_add_test(tests, boxes_lie_apart);
    tcase_add_test(tests, every_failed_allocation_is_survived);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
