#include "run.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fail_alloc.h"
#include "stroke/footprint.h"
#include "stroke/path.h"
#include "stroke/script.h"

#define SIZE 128u
#define PI 3.14159265358979323846

static struct hatch_arena keep;
static struct hatch_err err;
static struct hatch_footprint print, other;
static struct hatch_brush round_brush;

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)256 << 20);
    HATCH_TEST_OK(hatch_brush_make(HATCH_BRUSH_ROUND, &keep, &round_brush, &err), &err);
    HATCH_TEST_OK(hatch_footprint_make(&keep, SIZE, 40, 32, &print, &err), &err);
    HATCH_TEST_OK(hatch_footprint_make(&keep, SIZE, 40, 32, &other, &err), &err);
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static double ink_of(const struct hatch_footprint *f)
{
    double sum = 0;
    for (uint32_t i = 0; i < f->count; i++)
        sum += (double)f->alpha[i];
    return sum;
}

static struct hatch_path_builder builder(void)
{
    return (struct hatch_path_builder){.arena = &keep, .tolerance = 0.05 / SIZE};
}

static struct hatch_stroke finished(const struct hatch_path_builder *b, float width_px)
{
    struct hatch_stroke stroke = {.width_px = width_px, .tone = 1};
    HATCH_TEST_OK(hatch_path_finish(b, &keep, &stroke, &err), &err);
    return stroke;
}

/* A circle of four cubic curves, in tiles. */
static struct hatch_path_builder circle(double x, double y, double r)
{
    const double k = 4.0 / 3 * (sqrt(2) - 1) * r;
    const double curves[4][6] = {{x + r, y + k, x + k, y + r, x, y + r},
                                 {x - k, y + r, x - r, y + k, x - r, y},
                                 {x - r, y - k, x - k, y - r, x, y - r},
                                 {x + k, y - r, x + r, y - k, x + r, y}};
    struct hatch_path_builder b = builder();
    HATCH_TEST_OK(hatch_path_add_line(&b, x + r, y, &err), &err);
    for (int i = 0; i < 4; i++)
        HATCH_TEST_OK(hatch_path_add_cubic(&b, curves[i], &err), &err);
    return b;
}

static const float widths[] = {0.3f, 1, 1.8f, 4, 11};

/* The box filter is aligned to the line, not to the pixels, so that the ink of thin lines is right only in the mean. */
static double allowed(float width, double area)
{
    return (width < 1 ? 0.05 : 0.01) * area;
}

/* A straight line of length l and width w covers l w and a disc of diameter w. */
START_TEST(a_line_covers_its_area)
{
    for (int turn = 0; turn < 12; turn++) {
        struct hatch_path_builder b = builder();
        double dx = 0.35 * cos(turn * 0.3), dy = 0.35 * sin(turn * 0.3), w = (double)widths[_i];
        HATCH_TEST_OK(hatch_path_add_line(&b, 0.31, 0.77, &err), &err);
        HATCH_TEST_OK(hatch_path_add_line(&b, 0.31 + dx, 0.77 + dy, &err), &err);
        struct hatch_stroke stroke = finished(&b, widths[_i]);
        hatch_footprint_draw(&stroke, &round_brush, SIZE, 1, 1, &print);
        double want = 0.35 * SIZE * w + PI * w * w / 4;
        ck_assert_double_eq_tol(ink_of(&print), want, allowed(widths[_i], want));
    }
}
END_TEST

/* A circle of radius r covers 2 π r w at every position on the torus; its curves are off by 3e-4 of r. */
START_TEST(a_circle_covers_its_area)
{
    static const double places[][2] = {{0.5, 0.5}, {0, 0}, {0.93, 0.2}, {-3.2, 5.7}};
    for (int i = 0; i < 4; i++) {
        struct hatch_path_builder b = circle(places[i][0], places[i][1], 0.2);
        struct hatch_stroke stroke = finished(&b, widths[_i]);
        ck_assert_float_eq_tol(stroke.length, (float)(2 * PI * 0.2), 1e-3f);
        hatch_footprint_draw(&stroke, &round_brush, SIZE, 1, 1, &print);
        double want = 2 * PI * 0.2 * SIZE * (double)widths[_i];
        ck_assert_double_eq_tol(ink_of(&print), want, allowed(widths[_i], want));
    }
}
END_TEST

/* The length of a path scales with the level, its width does not. */
START_TEST(coarser_levels_keep_the_width)
{
    struct hatch_path_builder b = circle(0.4, 0.6, 0.3);
    struct hatch_stroke stroke = finished(&b, 2);
    for (uint32_t size = SIZE; size >= 32; size /= 2) {
        hatch_footprint_draw(&stroke, &round_brush, size, 1, 1, &print);
        double want = 2 * PI * 0.3 * size * 2;
        ck_assert_double_eq_tol(ink_of(&print), want, 0.015 * want);
    }
}
END_TEST

/* A bent stroke is an arc: no pixel differs much from a path along the same arc. */
START_TEST(an_arc_equals_the_path_along_it)
{
    for (int side = -1; side <= 1; side += 2) {
        struct hatch_stroke arc = {.x = 0.5f,
                                   .y = 0.45f,
                                   .length = 0.5f,
                                   .angle_rad = 0.7f,
                                   .bend_rad = 2.2f * (float)side,
                                   .width_px = 3,
                                   .tone = 1};
        struct hatch_path_builder b = builder();
        double radius = 0.5 / (2.2 * side), cosine = cos(0.7), sine = sin(0.7);
        for (int i = 0; i <= 200; i++) {
            double s = (i / 200.0 - 0.5) * 2.2 * side;
            double along = radius * sin(s), across = radius * (1 - cos(s));
            HATCH_TEST_OK(hatch_path_add_line(&b, 0.5 + along * cosine - across * sine,
                                              0.45 + along * sine + across * cosine, &err),
                          &err);
        }
        struct hatch_stroke path = finished(&b, 3);
        struct hatch_brush ink;
        HATCH_TEST_OK(hatch_brush_make(HATCH_BRUSH_INK, &keep, &ink, &err), &err);
        hatch_footprint_draw(&arc, &ink, SIZE, 1, 1, &print);
        hatch_footprint_draw(&path, &ink, SIZE, 1, 1, &other);
        float difference[SIZE * SIZE] = {0};
        for (uint32_t i = 0; i < print.count; i++)
            difference[print.at[i]] += print.alpha[i];
        for (uint32_t i = 0; i < other.count; i++)
            difference[other.at[i]] -= other.alpha[i];
        for (uint32_t i = 0; i < SIZE * SIZE; i++)
            ck_assert_float_eq_tol(difference[i], 0, 0.12f);
        ck_assert_double_eq_tol(ink_of(&print), ink_of(&other), 0.01 * ink_of(&other));
        ck_assert_double_ge(ink_of(&print), 100);
    }
}
END_TEST

/* Places at even shares of the length are even distances apart along lines, arcs and paths. */
START_TEST(places_run_from_start_to_end)
{
    const struct hatch_stroke line = {.x = 0.5f, .y = 0.25f, .length = 0.5f, .angle_rad = 1.5707963f};
    struct hatch_stroke arc = {.x = 0.5f, .y = 0.25f, .length = 3.1415927f, .bend_rad = 3.1415927f};
    const float corner[] = {-0.25f, 0, 0, 0, 0, 0.75f};
    const struct hatch_path path = {3, corner};
    const struct hatch_stroke bent = {.x = 1, .y = 1, .length = 1, .path = &path};
    const float wanted[][3][2] = {{{0.5f, 0}, {0.5f, 0.125f}, {0.5f, 0.5f}},
                                  {{-0.5f, 1.25f}, {-0.2071068f, 0.5428932f}, {1.5f, 1.25f}},
                                  {{0.75f, 1}, {1, 1}, {1, 1.75f}}};
    const struct hatch_stroke *const strokes[] = {&line, &arc, &bent};
    static const float at[] = {0, 0.25f, 1};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            float place[2];
            hatch_stroke_place(strokes[i], at[k], place);
            ck_assert_float_eq_tol(place[0], wanted[i][k][0], 1e-5f);
            ck_assert_float_eq_tol(place[1], wanted[i][k][1], 1e-5f);
        }
    arc.length = 0; /* a dot has no direction */
    float place[2];
    hatch_stroke_place(&arc, 1, place);
    ck_assert_float_eq(place[0], 0.5f);
}
END_TEST

/* Sharp corners have round joins; pixels of crossings count once. */
START_TEST(no_pixel_is_listed_twice_or_over_covered)
{
    struct hatch_path_builder b = builder();
    for (int i = 0; i < 60; i++)
        HATCH_TEST_OK(hatch_path_add_line(&b, 0.1 + 0.8 * (i % 2), 0.1 + i * 0.03, &err), &err);
    struct hatch_stroke zigzag = finished(&b, 2);
    ck_assert_float_gt(zigzag.length, 30);
    hatch_footprint_draw(&zigzag, &round_brush, SIZE, 1, 1, &print);
    bool seen[SIZE * SIZE] = {false};
    for (uint32_t i = 0; i < print.count; i++) {
        ck_assert(!seen[print.at[i]]);
        seen[print.at[i]] = true;
        ck_assert(print.alpha[i] > 0 && print.alpha[i] <= 1);
        ck_assert(print.along[i] >= 0 && print.along[i] <= 1);
    }
    ck_assert_uint_gt(print.count, SIZE * SIZE / 2);
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        ck_assert_uint_eq(print.entry_of[i], 0);
}
END_TEST

START_TEST(a_point_is_a_dot_and_a_tiny_circle_does_not_vanish)
{
    struct hatch_path_builder b = builder();
    HATCH_TEST_OK(hatch_path_add_line(&b, 0.5, 0.5, &err), &err);
    HATCH_TEST_OK(hatch_path_add_line(&b, 0.5, 0.5, &err), &err);
    ck_assert_uint_eq(b.count, 1);
    struct hatch_stroke dot = finished(&b, 6);
    ck_assert_ptr_null(dot.path);
    hatch_footprint_draw(&dot, &round_brush, SIZE, 1, 1, &print);
    ck_assert_double_eq_tol(ink_of(&print), PI * 9, 0.3);
    b = circle(0.5, 0.5, 0.1 / SIZE);
    struct hatch_stroke ring = finished(&b, 6);
    hatch_footprint_draw(&ring, &round_brush, SIZE, 1, 1, &print);
    ck_assert_double_eq_tol(ink_of(&print), PI * 9, 4);
}
END_TEST

/* Every point of a curve, finely sampled, lies within the tolerance of the polyline. */
START_TEST(curves_keep_to_the_tolerance)
{
    const double control[6] = {0.9, -0.3, -0.6, 1.4, 0.8, 0.9};
    struct hatch_path_builder b = builder();
    HATCH_TEST_OK(hatch_path_add_line(&b, 0.1, 0.2, &err), &err);
    HATCH_TEST_OK(hatch_path_add_cubic(&b, control, &err), &err);
    ck_assert_uint_lt(b.count, 200);
    for (int i = 0; i <= 5000; i++) {
        double t = i / 5000.0, s = 1 - t, nearest = 1;
        double x = s * s * s * 0.1 + 3 * s * s * t * 0.9 - 3 * s * t * t * 0.6 + t * t * t * 0.8;
        double y = s * s * s * 0.2 - 3 * s * s * t * 0.3 + 3 * s * t * t * 1.4 + t * t * t * 0.9;
        for (uint32_t k = 1; k < b.count; k++) {
            const double *p = b.xy + 2 * k - 2;
            double dx = p[2] - p[0], dy = p[3] - p[1];
            double u = ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy);
            u = u < 0 ? 0 : u > 1 ? 1 : u;
            nearest = fmin(nearest, hypot(x - p[0] - u * dx, y - p[1] - u * dy));
        }
        ck_assert_double_le(nearest, b.tolerance);
    }
}
END_TEST

/* The second differences of the control points are 0.002, so that a piece of half the curve is off by up to 0.000375.
 */
START_TEST(curves_have_as_few_pieces_as_the_tolerance_allows)
{
    const double control[6] = {0.1, 0.002, 0.2, 0.002, 0.3, 0};
    static const double tolerances[] = {0.0016, 0.0014, 0.0004, 0.00036, 0.00017, 0.00016};
    static const uint32_t pieces[] = {1, 2, 2, 3, 3, 4};
    for (int i = 0; i < 6; i++) {
        struct hatch_path_builder b = {.arena = &keep, .tolerance = tolerances[i]};
        HATCH_TEST_OK(hatch_path_add_line(&b, 0, 0, &err), &err);
        HATCH_TEST_OK(hatch_path_add_cubic(&b, control, &err), &err);
        ck_assert_uint_eq(b.count, pieces[i] + 1);
    }
}
END_TEST

START_TEST(points_not_finite_or_too_far_are_rejected)
{
    struct hatch_path_builder b = builder();
    struct hatch_stroke stroke = {.width_px = 1}, before = stroke;
    ck_assert_int_eq(hatch_path_add_line(&b, NAN, 0, &err), HATCH_BAD_INPUT);
    ck_assert_int_eq(hatch_path_add_line(&b, 0, INFINITY, &err), HATCH_BAD_INPUT);
    HATCH_TEST_OK(hatch_path_add_line(&b, 0, 0, &err), &err);
    HATCH_TEST_OK(hatch_path_add_line(&b, 200, 0, &err), &err);
    ck_assert_int_eq(hatch_path_finish(&b, &keep, &stroke, &err), HATCH_BAD_INPUT);
    ck_assert_mem_eq(&stroke, &before, sizeof stroke);
}
END_TEST

/* Adds points at x = -64 and 64 in turn, as far from their middle as is allowed: each but the first adds 128 tiles. */
static void add_widest(struct hatch_path_builder *b, int points)
{
    for (int i = 0; i < points; i++)
        HATCH_TEST_OK(hatch_path_add_line(b, i % 2 ? HATCH_PATH_REACH_MAX : -HATCH_PATH_REACH_MAX, 0, &err), &err);
}

START_TEST(the_longest_path_is_accepted_and_a_longer_one_is_not)
{
    struct hatch_path_builder b = builder();
    struct hatch_stroke stroke = {.width_px = 1}, before = stroke;
    add_widest(&b, 513);
    ck_assert_float_eq(finished(&b, 1).length, HATCH_PATH_LENGTH_MAX);
    HATCH_TEST_OK(hatch_path_add_line(&b, 1 - HATCH_PATH_REACH_MAX, 0, &err), &err);
    ck_assert_int_eq(hatch_path_finish(&b, &keep, &stroke, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "a stroke is 65537 tiles long, want 65536 at most");
    ck_assert_mem_eq(&stroke, &before, sizeof stroke);
}
END_TEST

/* Arcs, paths and the columns of each level are read back exactly. */
START_TEST(scripts_keep_arcs_paths_and_levels)
{
    struct hatch_path_builder b = circle(0.93, 0.2, 0.21);
    struct hatch_stroke strokes[3] = {finished(&b, 2.5f),
                                      {.x = 0.1f, .length = 0.3f, .width_px = 1, .tone = 0.4f, .bend_rad = -1.7f},
                                      {.y = 0.3f, .width_px = 5, .tone = 1, .column = 250, .level = 1}};
    struct hatch_stroke_list list;
    struct hatch_buffer text = {.arena = &keep};
    strokes[0].column = 3;
    strokes[0].level = 2;
    strokes[0].delay[1] = 2;
    strokes[0].delay[2] = 9;
    HATCH_TEST_OK(hatch_script_print(strokes, 3, SIZE, NULL, &text, &err), &err);
    struct hatch_bytes bytes = {text.data, text.size};
    HATCH_TEST_OK(hatch_script_parse(bytes, SIZE, &keep, &list, &err), &err);
    ck_assert_uint_eq(list.count, 3);
    ck_assert_uint_eq(list.items[0].path->count, strokes[0].path->count);
    ck_assert_mem_eq(list.items[0].path->xy, strokes[0].path->xy, 2 * sizeof(float) * strokes[0].path->count);
    list.items[0].path = strokes[0].path;
    ck_assert_mem_eq(list.items, strokes, sizeof strokes);
}
END_TEST

static const struct {
    const char *fields, *message;
} bad_rows[] = {
    {"0\t0\t0\t", "line 2: enters: want 1 columns, for levels 0 to 0, the first being 0"},
    {"3\t1\t3\t", "line 2: enters: want 2 columns, for levels 0 to 1, the first being 3"},
    {"3\t1\t4,5\t", "line 2: enters: the columns must begin at the stroke's column and never fall"},
    {"3\t1\t3,2\t", "line 2: enters: the columns must begin at the stroke's column and never fall"},
    {"3\t1\t3,x\t", "line 2: column 'x' is not a number"},
    {"0\t0\t\t0,0", "line 2: path: 1 points, want 2 to 1048576"},
    {"0\t0\t\t0,0 1", "line 2: path: point 2 is not x,y within 64 tiles"},
    {"0\t0\t\t0,0 1,99", "line 2: path: point 2 is not x,y within 64 tiles"},
};

START_TEST(a_bad_row_is_reported)
{
    char text[300];
    struct hatch_stroke_list list;
    int length = snprintf(text, sizeof text,
                          "x\ty\tlength\tangle\twidth\ttone\tr\tg\tb\tcolumn\tlevel\tenters\tpath\n"
                          "0\t0\t0\t0\t.1\t1\t0\t0\t0\t%s\n",
                          bad_rows[_i].fields);
    enum hatch_status status =
        hatch_script_parse((struct hatch_bytes){(const uint8_t *)text, (size_t)length}, SIZE, &keep, &list, &err);
    if (_i == 0) { /* a single level is consistent */
        ck_assert_int_eq(status, HATCH_OK);
        return;
    }
    ck_assert_int_eq(status, HATCH_BAD_INPUT);
    if (_i != 2)
        ck_assert_str_eq(err.text, bad_rows[_i].message);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *to, struct hatch_arena *scratch,
                              struct hatch_err *error)
{
    static const double control[6] = {0.9, -0.3, -0.6, 1.4, 0.8, 0.9};
    struct hatch_path_builder b = {.arena = to, .tolerance = 1e-5};
    (void)scratch;
    HATCH_TRY(hatch_path_add_line(&b, 0, 0, error));
    HATCH_TRY(hatch_path_add_cubic(&b, control, error));
    return hatch_path_finish(&b, to, context, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_stroke stroke = {.width_px = 1};
    hatch_test_fail_alloc(make, &stroke, &stroke, sizeof stroke);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("stroke path");
    TCase *tests = tcase_create("path");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, places_run_from_start_to_end);
    tcase_add_loop_test(tests, a_line_covers_its_area, 0, 5);
    tcase_add_loop_test(tests, a_circle_covers_its_area, 0, 5);
    tcase_add_test(tests, coarser_levels_keep_the_width);
    tcase_add_test(tests, an_arc_equals_the_path_along_it);
    tcase_add_test(tests, no_pixel_is_listed_twice_or_over_covered);
    tcase_add_test(tests, a_point_is_a_dot_and_a_tiny_circle_does_not_vanish);
    tcase_add_test(tests, curves_keep_to_the_tolerance);
    tcase_add_test(tests, curves_have_as_few_pieces_as_the_tolerance_allows);
    tcase_add_test(tests, points_not_finite_or_too_far_are_rejected);
    tcase_add_test(tests, the_longest_path_is_accepted_and_a_longer_one_is_not);
    tcase_add_test(tests, scripts_keep_arcs_paths_and_levels);
    tcase_add_loop_test(tests, a_bad_row_is_reported, 0, sizeof bad_rows / sizeof *bad_rows);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
