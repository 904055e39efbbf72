#include "run.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "placement/place.h"

#define SIZE 256u
#define LEVELS 3u

static struct hatch_arena keep;
static struct hatch_err err;
static struct hatch_style style;
static struct hatch_brush brush;
static struct hatch_canvas canvas;
static struct hatch_potential field;

static enum hatch_status make_canvas(void)
{
    const struct hatch_canvas_options options = {&style, &brush, SIZE, LEVELS, false, false};
    return hatch_canvas_make(&options, &keep, &canvas, &err);
}

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)64 << 20);
    hatch_style_default(&style);
    HATCH_TEST_OK(hatch_brush_make(HATCH_BRUSH_INK, &keep, &brush, &err), &err);
    HATCH_TEST_OK(make_canvas(), &err);
    HATCH_TEST_OK(hatch_potential_make(&keep, SIZE, LEVELS, &brush, &field, &err), &err);
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static struct hatch_stroke random_stroke(uint64_t i)
{
    return (struct hatch_stroke){.x = hatch_random_unit(6, 1, i),
                                 .y = hatch_random_unit(6, 2, i),
                                 .length = 0.3f + 0.7f * hatch_random_unit(6, 3, i),
                                 .angle_rad = (float)i,
                                 .width_px = 1.8f,
                                 .tone = 1};
}

static void draw(const struct hatch_stroke *stroke, uint32_t coarsest)
{
    for (uint32_t level = 0; level <= coarsest; level++) {
        hatch_canvas_draw(&canvas, stroke, level, 0, 1);
        hatch_potential_deposit(&field, &canvas, level);
    }
    hatch_potential_update(&field);
}

static double mean_potential(void)
{
    double sum = 0;
    for (uint32_t i = 0; i < field.size * field.size; i++)
        sum += (double)field.potential[i];
    return sum / (field.size * field.size);
}

/* Every scale of the pyramid keeps the mean, and levels are weighted by the width of their strokes on the tile, so the
 * mean potential is known in closed form. */
START_TEST(the_mean_potential_counts_every_level_at_every_scale)
{
    hatch_potential_select(&field, LEVELS - 1);
    ck_assert_double_eq_tol(mean_potential(), 0, 1e-12);
    for (uint64_t i = 0; i < 20; i++) {
        struct hatch_stroke stroke = random_stroke(i);
        draw(&stroke, LEVELS - 1);
    }
    double want = 0;
    for (uint32_t level = 0; level < LEVELS; level++)
        want += canvas.darkness[level] / (SIZE >> level);
    ck_assert_double_eq_tol(mean_potential() / (want * field.octaves), 1, 1e-4);
}
END_TEST

static float saved[SIZE * SIZE];

/* The largest difference of the field to one computed anew for the level, relative to the mean potential. */
static double difference_to_new_field(uint32_t level)
{
    size_t cells = (size_t)field.size * field.size;
    memcpy(saved, field.potential, cells * sizeof *saved);
    hatch_potential_select(&field, level ? 0 : LEVELS - 1);
    hatch_potential_select(&field, level);
    double most = 0;
    for (size_t i = 0; i < cells; i++)
        most = fmax(most, fabs((double)(saved[i] - field.potential[i])));
    return most / mean_potential();
}

/* A field updated stroke by stroke equals one computed anew, also with strokes of coarser levels in between, which are
 * not part of the potential. */
START_TEST(updates_equal_a_new_field)
{
    for (uint64_t i = 0; i < 20; i++) {
        struct hatch_stroke stroke = random_stroke(i);
        draw(&stroke, LEVELS - 1);
    }
    ck_assert_double_lt(difference_to_new_field(LEVELS - 1), 1e-4);
    for (uint32_t level = 0; level < LEVELS; level++) {
        hatch_potential_select(&field, level);
        for (uint64_t i = 20; i < 40; i++) {
            struct hatch_stroke stroke = random_stroke(i);
            draw(&stroke, (uint32_t)i % LEVELS);
            hatch_potential_select(&field, level);
        }
        ck_assert_double_lt(difference_to_new_field(level), 1e-4);
    }
    hatch_potential_select(&field, 0); /* only the finest level */
    ck_assert_double_eq_tol(mean_potential() / (canvas.darkness[0] / SIZE * field.octaves), 1, 1e-4);
}
END_TEST

/* Moving the drawing by half a tile, a whole number of cells at all scales but the last two, moves the field. */
START_TEST(the_field_has_no_borders)
{
    uint32_t size = field.size, half = size / 2;
    struct hatch_stroke stroke = random_stroke(4);
    stroke.x = stroke.y = 0.015625f;
    hatch_potential_select(&field, 0);
    draw(&stroke, 0);
    memcpy(saved, field.potential, (size_t)size * size * sizeof *saved);
    double scale = mean_potential();
    HATCH_TEST_OK(hatch_potential_make(&keep, SIZE, LEVELS, &brush, &field, &err), &err);
    HATCH_TEST_OK(make_canvas(), &err);
    stroke.x += 0.5f;
    stroke.y += 0.5f;
    hatch_potential_select(&field, 0);
    draw(&stroke, 0);
    for (uint32_t y = 0; y < size; y++)
        for (uint32_t x = 0; x < size; x++) {
            float moved = field.potential[(y + half) % size * size + (x + half) % size];
            ck_assert_double_eq_tol((double)(moved - saved[y * size + x]) / scale, 0, 1e-3);
        }
}
END_TEST

/* The field falls with the distance from a stroke. */
START_TEST(the_field_falls_with_the_distance_from_a_stroke)
{
    struct hatch_stroke stroke = {.x = 0.5f, .y = 0.5f, .length = 1, .width_px = 1.8f, .tone = 1};
    hatch_potential_select(&field, 0);
    draw(&stroke, 0);
    float last = INFINITY;
    for (uint32_t cells = 0; cells < field.size / 2; cells += field.size / 16) {
        struct hatch_stroke probe = stroke;
        probe.y = 0.5f + ((float)cells + 0.5f) / (float)field.size;
        float score = hatch_potential_score(&field, &probe, UINT32_MAX);
        ck_assert_float_lt(score, last);
        last = score;
    }
}
END_TEST

/* Makes a brush with ink in the columns first .. last - 1, and a field for it. */
static void brush_of_columns(uint32_t columns, uint32_t first, uint32_t last)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, columns, 1, "Y", &image, &err), &err);
    for (uint32_t x = 0; x < columns; x++)
        image.pixels[x] = x < first || x >= last;
    HATCH_TEST_OK(hatch_brush_from_image(&image, &keep, &brush, &err), &err);
    HATCH_TEST_OK(hatch_potential_make(&keep, SIZE, LEVELS, &brush, &field, &err), &err);
}

/* Closed form for ink in the second eighth of the stroke. */
START_TEST(shares_of_ink_are_those_of_the_brush)
{
    brush_of_columns(80, 10, 20);
    for (uint32_t n = 1; n <= HATCH_POTENTIAL_PARTS; n++) {
        double sum = 0;
        for (uint32_t i = 0; i < n; i++) {
            double from = fmax(0.125, (double)i / n), to = fmin(0.25, (i + 1.0) / n);
            double share = (double)field.share[n * (n - 1) / 2 + i];
            ck_assert_double_eq_tol(share, to > from ? (to - from) / 0.125 : 0, 1e-6);
            sum += share;
        }
        ck_assert_double_eq_tol(sum, 1, 1e-6);
    }
}
END_TEST

/* The potential counts only where the brush has ink. */
START_TEST(the_score_is_weighted_by_ink)
{
    brush_of_columns(80, 10, 20);
    for (uint32_t i = 0; i < field.size * field.size; i++)
        field.potential[i] = i % field.size >= field.size / 8 && i % field.size < field.size / 4 ? 1 : 0.25f;
    struct hatch_stroke stroke = {.x = 0.5f, .y = 0.3f, .length = 1};
    for (uint32_t most = 8; most <= 64; most *= 2)
        ck_assert_float_eq_tol(hatch_potential_score(&field, &stroke, most), 1, 1e-5f);
    ck_assert_float_eq_tol(hatch_potential_score(&field, &stroke, UINT32_MAX), 1, 1e-5f);
    stroke.x = 0.75f;
    ck_assert_float_eq_tol(hatch_potential_score(&field, &stroke, 24), 0.25f, 1e-5f);
}
END_TEST

/* The score is the mean of the cells under evenly spaced points of the line. */
START_TEST(the_score_is_the_mean_along_the_line)
{
    brush_of_columns(1, 0, 1);
    for (uint32_t i = 0; i < field.size * field.size; i++)
        field.potential[i] = hatch_random_unit(8, 1, i);
    for (uint64_t i = 0; i < 300; i++) {
        struct hatch_stroke stroke = random_stroke(i);
        double size = field.size, cells = (double)stroke.length * size;
        for (uint32_t most = 8; most < 1000; most *= 10) {
            uint32_t samples = cells < most ? (uint32_t)cells : most, off = 0;
            double sum = 0;
            for (uint32_t k = 0; k < samples; k++) {
                double at = ((k + 0.5) / samples - 0.5) * cells;
                double x = (double)stroke.x * size + at * cos((double)stroke.angle_rad);
                double y = (double)stroke.y * size + at * sin((double)stroke.angle_rad);
                off += fabs(x - round(x)) < 1e-3 || fabs(y - round(y)) < 1e-3; /* rounding decides the cell */
                x -= floor(x / size) * size;
                y -= floor(y / size) * size;
                sum += (double)field.potential[(uint32_t)y % field.size * field.size + (uint32_t)x % field.size];
            }
            double score = (double)hatch_potential_score(&field, &stroke, most);
            ck_assert_double_eq_tol(score, sum / samples, 1e-5 + (double)off / samples);
        }
    }
    struct hatch_stroke dot = {.x = 0.25f, .y = 0.75f};
    uint32_t cell = field.size / 4 * 3 * field.size + field.size / 4;
    ck_assert_float_eq(hatch_potential_score(&field, &dot, 24), field.potential[cell]);
}
END_TEST

/* On a smooth potential the score of an arc is the mean along it, computed by fine sampling. */
START_TEST(the_score_of_an_arc_is_the_mean_along_it)
{
    const double turn = 2 * acos(-1);
    brush_of_columns(1, 0, 1);
    for (uint32_t i = 0; i < field.size * field.size; i++)
        field.potential[i] = (float)(2 + sin(turn * (i % field.size + 0.5) / field.size) +
                                     cos(turn * (i / field.size + 0.5) / field.size));
    for (uint64_t i = 0; i < 300; i++) {
        struct hatch_stroke stroke = random_stroke(i);
        stroke.bend_rad = (float)(i % 7 + 1) * (i % 2 ? 0.8f : -0.8f);
        double radius = (double)stroke.length / (double)stroke.bend_rad, sum = 0;
        double cosine = cos((double)stroke.angle_rad), sine = sin((double)stroke.angle_rad);
        for (int k = 0; k < 1000; k++) {
            double s = ((k + 0.5) / 1000 - 0.5) * (double)stroke.bend_rad;
            double along = radius * sin(s), aside = radius * (1 - cos(s));
            double x = (double)stroke.x + along * cosine - aside * sine;
            double y = (double)stroke.y + along * sine + aside * cosine;
            sum += (2 + sin(turn * x) + cos(turn * y)) / 1000;
        }
        ck_assert_double_eq_tol((double)hatch_potential_score(&field, &stroke, UINT32_MAX), sum, 0.06);
    }
}
END_TEST

static struct hatch_choice choice_of(uint64_t number)
{
    return (struct hatch_choice){.seed = 7,
                                 .number = number,
                                 .level = 1,
                                 .candidates = 200,
                                 .length_max = style.length_max,
                                 .scale = 1,
                                 .direction_count = 2,
                                 .directions = {0, 1.5f}};
}

/* A chosen stroke scores at least as well as its candidates. */
START_TEST(the_best_candidate_is_chosen_and_improved)
{
    hatch_potential_select(&field, 1);
    for (uint64_t i = 0; i < 30; i++) {
        struct hatch_choice choice = choice_of(i);
        struct hatch_stroke best = hatch_place_by_field(&style, &field, &choice);
        float score = hatch_potential_score(&field, &best, UINT32_MAX);
        uint32_t better = 0;
        for (uint32_t c = 0; c < choice.candidates; c++) {
            struct hatch_stroke other = hatch_choice_candidate(&style, &choice, c);
            better += hatch_potential_score(&field, &other, UINT32_MAX) < score;
        }
        /* the shortlist is made from 24 samples per candidate, which misses a better one now and then */
        ck_assert_uint_le(better, 2);
        ck_assert(best.x >= 0 && best.x < 1 && best.y >= 0 && best.y < 1);
        draw(&best, 1);
    }
}
END_TEST

START_TEST(candidates_follow_the_style)
{
    struct hatch_choice choice = choice_of(3);
    choice.candidates = 4000;
    double length = 0, x = 0, spread = 0;
    for (uint32_t c = 0; c < choice.candidates; c++) {
        struct hatch_stroke s = hatch_choice_candidate(&style, &choice, c);
        ck_assert(s.x >= 0 && s.x < 1 && s.y >= 0 && s.y < 1);
        ck_assert(s.length >= style.length_min && s.length <= style.length_max);
        ck_assert_uint_eq(s.level, 1);
        double off = (double)(s.angle_rad - choice.directions[c % 2]);
        length += (double)s.length / choice.candidates;
        x += (double)s.x / choice.candidates;
        spread += off * off / choice.candidates;
    }
    style.bend_min_rad = 0.5f;
    style.bend_max_rad = 1.5f;
    double bend = 0, side = 0;
    for (uint32_t c = 0; c < choice.candidates; c++) {
        struct hatch_stroke s = hatch_choice_candidate(&style, &choice, c);
        ck_assert(fabsf(s.bend_rad) >= 0.5f && fabsf(s.bend_rad) <= 1.5f);
        bend += fabs((double)s.bend_rad) / choice.candidates;
        side += (double)s.bend_rad / choice.candidates;
    }
    ck_assert_double_eq_tol(bend, 1, 0.02);
    ck_assert_double_eq_tol(side, 0, 0.06);
    ck_assert_double_eq_tol(length, 0.65, 0.015);
    ck_assert_double_eq_tol(x, 0.5, 0.02);
    ck_assert_double_eq_tol(sqrt(spread) / (double)style.jitter_rad, 1, 0.05);
    choice.length_max = 0.1f; /* a gap smaller than the shortest stroke */
    ck_assert_float_eq(hatch_choice_candidate(&style, &choice, 9).length, style.length_min);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *to, struct hatch_arena *scratch,
                              struct hatch_err *error)
{
    (void)scratch;
    return hatch_potential_make(to, SIZE, LEVELS, &brush, context, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_potential made = {0};
    ck_assert_uint_ge(hatch_test_fail_alloc(make, &made, &made, sizeof made), 2 + 7 + LEVELS);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam field");
    TCase *tests = tcase_create("field");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_mean_potential_counts_every_level_at_every_scale);
    tcase_add_test(tests, updates_equal_a_new_field);
    tcase_add_test(tests, the_field_has_no_borders);
    tcase_add_test(tests, the_field_falls_with_the_distance_from_a_stroke);
    tcase_add_test(tests, shares_of_ink_are_those_of_the_brush);
    tcase_add_test(tests, the_score_is_weighted_by_ink);
    tcase_add_test(tests, the_score_is_the_mean_along_the_line);
    tcase_add_test(tests, the_score_of_an_arc_is_the_mean_along_it);
    tcase_add_test(tests, the_best_candidate_is_chosen_and_improved);
    tcase_add_test(tests, candidates_follow_the_style);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
