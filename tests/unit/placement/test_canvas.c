#include "run.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "placement/canvas.h"

#define SIZE 64u
#define LEVELS 2u

static struct hatch_arena keep;
static struct hatch_err err;
static struct hatch_style style;
static struct hatch_brush brush;
static struct hatch_canvas canvas;

static enum hatch_status make_canvas(bool color, bool ids, struct hatch_canvas *made)
{
    const struct hatch_canvas_options options = {&style, &brush, SIZE, LEVELS, color, ids};
    return hatch_canvas_make(&options, &keep, made, &err);
}

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)64 << 20);
    hatch_style_default(&style);
    style.width_px = 6;
    HATCH_TEST_OK(hatch_brush_make(HATCH_BRUSH_CRAYON, &keep, &brush, &err), &err);
    HATCH_TEST_OK(make_canvas(false, true, &canvas), &err);
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static struct hatch_stroke random_stroke(uint64_t i)
{
    return (struct hatch_stroke){.x = hatch_random_unit(6, 1, i),
                                 .y = hatch_random_unit(6, 2, i),
                                 .length = 0.2f + 0.8f * hatch_random_unit(6, 3, i),
                                 .angle_rad = (float)i,
                                 .width_px = 6,
                                 .tone = 0.9f,
                                 .id = (uint32_t)i + 1,
                                 .texture_seed = (uint32_t)i};
}

static double darkness_of(const float *paper, uint32_t size)
{
    double sum = 0;
    for (uint32_t i = 0; i < size * size; i++)
        sum += 1 - (double)paper[i];
    return sum / (size * size);
}

START_TEST(strokes_only_darken_and_the_mean_is_tracked)
{
    static float before[SIZE * SIZE];
    style.overlap = _i ? HATCH_OVERLAP_DARKENS : HATCH_OVERLAP_FLAT;
    for (uint64_t i = 0; i < 60; i++)
        for (uint32_t level = 0; level < LEVELS; level++) {
            uint32_t size = hatch_canvas_size(&canvas, level);
            struct hatch_stroke stroke = random_stroke(i);
            memcpy(before, canvas.paper[level], size * size * sizeof *before);
            double before_draw = canvas.darkness[level], gain = hatch_canvas_try(&canvas, &stroke, level, 1);
            ck_assert_mem_eq(before, canvas.paper[level], size * size * sizeof *before);
            ck_assert_double_ge(gain, 0);
            hatch_canvas_draw(&canvas, &stroke, level, 0, 1);
            ck_assert_double_eq_tol(canvas.darkness[level] - before_draw, gain, 1e-12);
            ck_assert_double_eq_tol(canvas.darkness[level], darkness_of(canvas.paper[level], size), 1e-5);
            for (uint32_t k = 0; k < size * size; k++)
                ck_assert(canvas.paper[level][k] <= before[k] && canvas.paper[level][k] >= 0);
        }
    ck_assert_double_ge(canvas.darkness[0], 0.5);
}
END_TEST

/* Reflectances of crossing strokes multiply, or the darker one wins. */
START_TEST(strokes_overlap_as_the_style_defines)
{
    struct hatch_stroke stroke = random_stroke(3);
    for (int darkens = 0; darkens < 2; darkens++) {
        style.overlap = darkens ? HATCH_OVERLAP_DARKENS : HATCH_OVERLAP_FLAT;
        HATCH_TEST_OK(make_canvas(false, false, &canvas), &err);
        hatch_canvas_draw(&canvas, &stroke, 0, 0, 1);
        hatch_canvas_draw(&canvas, &stroke, 0, 0, 1);
        const struct hatch_footprint *f = &canvas.footprint;
        ck_assert_uint_gt(f->count, 50);
        for (uint32_t i = 0; i < f->count; i++) {
            float once = 1 - f->alpha[i];
            ck_assert_float_eq_tol(canvas.paper[0][f->at[i]], darkens ? once * once : once, 1e-6f);
        }
    }
}
END_TEST

/* Growing a stroke in steps gives the same result as drawing it at once. */
START_TEST(a_stroke_grown_in_steps_equals_the_whole_stroke)
{
    struct hatch_canvas whole;
    style.overlap = _i % 2 ? HATCH_OVERLAP_DARKENS : HATCH_OVERLAP_FLAT;
    float *grain = _i / 2 ? brush.grain : NULL;
    HATCH_TEST_OK(hatch_brush_make(HATCH_BRUSH_STIPPLE, &keep, &brush, &err), &err); /* no taper */
    brush.grain = grain;
    HATCH_TEST_OK(make_canvas(false, true, &whole), &err);
    struct hatch_stroke stroke = random_stroke(5);
    const float half_pixel = 0.5f / (stroke.length * SIZE);
    hatch_canvas_draw(&canvas, &stroke, 0, 0, 0.4f);
    hatch_canvas_draw(&canvas, &stroke, 0, 0.4f, 0.7f);
    hatch_canvas_draw(&canvas, &stroke, 0, 0.7f, 1);
    hatch_canvas_draw(&whole, &stroke, 0, 0, 1);
    for (uint32_t k = 0; k < SIZE * SIZE; k++) {
        ck_assert_float_eq_tol(canvas.paper[0][k], whole.paper[0][k], 1e-5f);
        ck_assert_float_eq(canvas.id[0][k], whole.id[0][k]);
        ck_assert_float_eq_tol(canvas.along[0][k], whole.along[0][k], half_pixel); /* pixels at ends are of the end */
    }
    ck_assert_double_eq_tol(canvas.darkness[0], whole.darkness[0], 1e-5);
}
END_TEST

START_TEST(the_first_stroke_keeps_its_pixels)
{
    struct hatch_stroke first = random_stroke(1), second = random_stroke(2);
    hatch_canvas_draw(&canvas, &first, 0, 0, 1);
    uint32_t owned = canvas.footprint.count;
    ck_assert_uint_gt(owned, 50);
    hatch_canvas_draw(&canvas, &second, 0, 0, 1);
    uint32_t firsts = 0, seconds = 0;
    for (uint32_t k = 0; k < SIZE * SIZE; k++) {
        float id = canvas.id[0][k];
        firsts += id == 2; /* random_stroke(1) has the id 2 */
        seconds += id == 3;
        ck_assert(id == 0 || id == 2 || id == 3);
        ck_assert((canvas.paper[0][k] < 1) == (id > 0));
        ck_assert(canvas.along[0][k] >= 0 && canvas.along[0][k] <= 1);
    }
    ck_assert_uint_eq(firsts, owned);
    ck_assert(seconds > 0 && seconds < canvas.footprint.count);
}
END_TEST

/* Checks three channels and their mean: a stroke of colour a over paper, then one of colour b over it. */
START_TEST(colors_overlap_as_the_style_defines)
{
    struct hatch_stroke first = random_stroke(3), second = first;
    const float a[3] = {0.75f, 0.5f, 0.125f}, b[3] = {0.25f, 0.5f, 1};
    memcpy(first.rgb, a, sizeof a);
    memcpy(second.rgb, b, sizeof b);
    style.overlap = (enum hatch_overlap)_i;
    HATCH_TEST_OK(make_canvas(true, false, &canvas), &err);
    hatch_canvas_draw(&canvas, &first, 0, 0, 1);
    hatch_canvas_draw(&canvas, &second, 0, 0, 1);
    const struct hatch_footprint *f = &canvas.footprint;
    ck_assert_uint_gt(f->count, 50);
    for (uint32_t i = 0; i < f->count; i++) {
        float alpha = f->alpha[i], mean = 0;
        for (int c = 0; c < 3; c++) {
            float alone = 1 - alpha * (1 - b[c]), under = 1 - alpha * (1 - a[c]);
            float over = under * (1 - alpha) + alpha * b[c];
            float darker = fminf(under, _i == HATCH_OVERLAP_FLAT ? alone : over);
            float want = _i == HATCH_OVERLAP_DARKENS ? under * alone : darker;
            float got = canvas.rgb[0][3 * f->at[i] + (uint32_t)c];
            ck_assert_float_eq_tol(got, want, 1e-6f);
            mean += got / 3;
        }
        ck_assert_float_eq_tol(canvas.paper[0][f->at[i]], mean, 1e-6f);
    }
    ck_assert_double_eq_tol(canvas.darkness[0], darkness_of(canvas.paper[0], SIZE), 1e-6);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *to, struct hatch_arena *scratch,
                              struct hatch_err *error)
{
    (void)scratch;
    const struct hatch_canvas_options options = {&style, &brush, SIZE, LEVELS, true, true};
    return hatch_canvas_make(&options, to, context, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_canvas made = {0};
    ck_assert_uint_ge(hatch_test_fail_alloc(make, &made, &made, sizeof made), 3 * LEVELS + 9);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam canvas");
    TCase *tests = tcase_create("canvas");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, strokes_only_darken_and_the_mean_is_tracked, 0, 2);
    tcase_add_test(tests, strokes_overlap_as_the_style_defines);
    tcase_add_loop_test(tests, a_stroke_grown_in_steps_equals_the_whole_stroke, 0, 4);
    tcase_add_test(tests, the_first_stroke_keeps_its_pixels);
    tcase_add_loop_test(tests, colors_overlap_as_the_style_defines, 0, 3);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
