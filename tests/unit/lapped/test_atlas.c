#include "fail_alloc.h"
#include "lapped/atlas.h"
#include "lapped_make.h"
#include "mesh/edges.h"

#define MARGIN 0.004

static struct lapped_case make_torus(uint32_t faces)
{
    struct field_case field = case_of_shape(HATCH_SHAPE_TORUS, faces, 1);
    set_direction(&field, 0, 0, 1);
    return make_lapped(field, &LAPPED_DEFAULTS);
}

static double area_of(const float *at)
{
    double ax = (double)at[2] - (double)at[0], ay = (double)at[3] - (double)at[1];
    double bx = (double)at[4] - (double)at[0], by = (double)at[5] - (double)at[1];
    return -(ax * by - ay * bx) / 2;
}

/* Whether a point lies inside a face's triangle of the layout, away from its border. */
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

START_TEST(faces_do_not_overlap)
{
    struct lapped_case torus = make_torus(3000);
    const struct hatch_surface *surface = &torus.field.surface;
    const struct hatch_lapped_input input = lapped_input(&torus.field, &torus.outline);
    double scale, whole = 0;
    float *at = HATCH_NEW(&keep, float, 6 * (size_t)surface->face_count, &err);
    HATCH_TEST_OK(hatch_lapped_atlas(&input, &torus.lapped, MARGIN, &scratch, at, &scale, &err), &err);
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

START_TEST(neighbours_in_a_chart_share_edges)
{
    struct lapped_case torus = make_torus(3000);
    const struct hatch_surface *surface = &torus.field.surface;
    struct hatch_charts charts;
    HATCH_TEST_OK(hatch_charts_make(surface, &torus.lapped, &torus.outline, &keep, &charts, &err), &err);
    uint32_t joined = 0;
    for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
        uint32_t other = surface->opposite[side];
        if (charts.chart_of[side / 3] != charts.chart_of[other / 3])
            continue;
        uint32_t end = other % 3 == 2 ? other - 2 : other + 1;
        joined += charts.positions[2 * side] == charts.positions[2 * end] &&
                  charts.positions[2 * side + 1] == charts.positions[2 * end + 1];
    }
    ck_assert_msg(joined > 2 * surface->face_count, "only %u sides of %u join", joined, 3 * surface->face_count);
    ck_assert_uint_lt(charts.count, 4 * torus.lapped.patch_count);
}
END_TEST

/* A patch of a plane overlaps itself nowhere: faces of it that share an edge are in one chart. */
START_TEST(a_patch_of_a_plane_is_not_cut)
{
    struct field_case field = case_of_shape(HATCH_SHAPE_PLANE, 3000, 1);
    set_direction(&field, 1, 0, 0);
    struct lapped_case plane = make_lapped(field, &LAPPED_DEFAULTS);
    const struct hatch_surface *surface = &plane.field.surface;
    struct hatch_charts charts;
    HATCH_TEST_OK(hatch_charts_make(surface, &plane.lapped, &plane.outline, &keep, &charts, &err), &err);
    uint32_t joined = 0;
    for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
        uint32_t other = surface->opposite[side];
        if (other == HATCH_NO_SIDE)
            continue;
        const double *a = &charts.positions[2 * side], *b = &charts.positions[2 * hatch_side_end(side)];
        const double *from = &charts.positions[2 * hatch_side_end(other)], *to = &charts.positions[2 * other];
        if (memcmp(a, from, 2 * sizeof *a) != 0 || memcmp(b, to, 2 * sizeof *b) != 0)
            continue;
        ck_assert_uint_eq(charts.chart_of[side / 3], charts.chart_of[other / 3]);
        joined++;
    }
    ck_assert_uint_gt(joined, 2 * surface->face_count);
}
END_TEST

/* A ramp that winds two and a half times around an axis is laid out as a ring that lies over itself: of 36.5 steps a
 * turn, a chart holds 36 and perhaps one of the two faces of the next. */
START_TEST(a_patch_that_overlaps_itself_is_cut)
{
    enum { STEPS = 91, FACES = 2 * STEPS, VERTICES = 2 * STEPS + 2 };
    static float positions[3 * VERTICES];
    static uint32_t indices[3 * FACES], numbers[FACES];
    for (uint32_t v = 0; v < VERTICES; v++) {
        double angle = 2 * PI * (v / 2) / 36.5, radius = v % 2 ? 1.5 : 1;
        positions[3 * v] = (float)(radius * cos(angle));
        positions[3 * v + 1] = (float)(radius * sin(angle));
        positions[3 * v + 2] = (float)(0.1 * angle);
    }
    for (uint32_t q = 0; q < STEPS; q++) {
        const uint32_t faces[6] = {2 * q, 2 * q + 1, 2 * q + 3, 2 * q, 2 * q + 3, 2 * q + 2};
        memcpy(&indices[6 * q], faces, sizeof faces);
    }
    struct field_case field = case_of(mesh_of(positions, VERTICES, indices, FACES));
    struct hatch_lapped_vertex *vertices = HATCH_NEW(&keep, struct hatch_lapped_vertex, VERTICES, &err);
    ck_assert_ptr_nonnull(vertices);
    for (uint32_t i = 0; i < 3 * FACES; i++) {
        uint32_t point = field.surface.corners[i];
        const float *at = &positions[3 * field.surface.corner_vertex[i]];
        vertices[point] = (struct hatch_lapped_vertex){point, {(double)at[0], -(double)at[1]}, {0.5f, 0.5f}};
    }
    for (uint32_t f = 0; f < FACES; f++)
        numbers[f] = f;
    struct hatch_lapped_patch patch = {.vertex_count = VERTICES, .face_count = FACES, .radius = 2};
    const struct hatch_lapped ramp = {1, &patch, VERTICES, FACES, vertices, numbers, field.surface.corners, 0, 0, 0};
    struct hatch_outline outline;
    struct hatch_charts charts;
    uint32_t faces_of[3] = {0, 0, 0};
    hatch_outline_make(3, 0, 0.05, &outline);
    HATCH_TEST_OK(hatch_charts_make(&field.surface, &ramp, &outline, &keep, &charts, &err), &err);
    ck_assert_uint_eq(charts.count, 3);
    for (uint32_t f = 0; f < FACES; f++)
        faces_of[charts.chart_of[f]]++;
    ck_assert(faces_of[0] >= 72 && faces_of[0] <= 73);
    ck_assert(faces_of[1] >= 72 && faces_of[1] <= 73);
}
END_TEST

START_TEST(boxes_do_not_overlap)
{
    double sizes[200], corners[200], side;
    for (uint32_t i = 0; i < 200; i++)
        sizes[i] = 0.1 + (double)hatch_random_unit(2, 0, i);
    HATCH_TEST_OK(hatch_charts_pack(sizes, 100, 0.01, &scratch, corners, &side, &err), &err);
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

/* Four squares fill a square of any size but for its gaps: three along an axis, which take a sixteenth of the side. */
START_TEST(boxes_of_any_size_fill_the_square)
{
    for (double size = 1e-6; size < 1e7; size *= 10) {
        double sizes[8], corners[8], side;
        for (int i = 0; i < 8; i++)
            sizes[i] = size;
        HATCH_TEST_OK(hatch_charts_pack(sizes, 4, 0.0625 / 3, &scratch, corners, &side, &err), &err);
        ck_assert_double_eq_tol(side / size, 2 / (1 - 0.0625), 1e-9);
    }
}
END_TEST

static enum hatch_status lay_out(void *context, struct hatch_arena *result, struct hatch_arena *work,
                                 struct hatch_err *error)
{
    const struct lapped_case *made = context;
    const struct hatch_lapped_input input = lapped_input(&made->field, &made->outline);
    double scale;
    float *at = HATCH_NEW(result, float, 6 * (size_t)made->field.surface.face_count, error);
    if (!at)
        return HATCH_LIMIT;
    return hatch_lapped_atlas(&input, &made->lapped, MARGIN, work, at, &scale, error);
}

START_TEST(failed_allocations_are_reported)
{
    struct lapped_case torus = make_torus(200);
    hatch_test_fail_alloc(lay_out, &torus, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped atlas");
    TCase *tests = tcase_create("atlas");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, faces_do_not_overlap);
    tcase_add_test(tests, neighbours_in_a_chart_share_edges);
    tcase_add_test(tests, a_patch_of_a_plane_is_not_cut);
    tcase_add_test(tests, a_patch_that_overlaps_itself_is_cut);
    tcase_add_test(tests, boxes_do_not_overlap);
    tcase_add_test(tests, boxes_of_any_size_fill_the_square);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
