/* The choice among candidates by the darkness that they add to all levels. */
#include <math.h>

#include "filter/pyramid.h"
#include "placement/place.h"
#include "tam_map.h"

static struct test_map map;

/* Returns the choice among 40 candidates for a stroke of one direction. */
static struct hatch_choice choice_of(uint64_t number, float length_max, float direction_rad)
{
    return (struct hatch_choice){.seed = 5,
                                 .number = number,
                                 .candidates = 40,
                                 .length_max = length_max,
                                 .scale = 1,
                                 .direction_count = 1,
                                 .directions = {direction_rad}};
}

/* On a tile whose left half is black every stroke is placed in the right half. */
START_TEST(the_exhaustive_method_places_strokes_on_paper)
{
    struct hatch_canvas canvas;
    float *pyramids[1][HATCH_MIP_LEVELS_MAX];
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX] = {{.width = 64, .height = 64, .channel_count = 1}};
    struct hatch_mipmap chain = {.levels = levels};
    map_style(NULL, "jitter 0\ndirection 90 0 1\nlength 0.1 0.3", &map);
    const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 1, false, false};
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    for (uint32_t i = 0; i < 64 * 64; i++)
        canvas.paper[0][i] = i % 64 >= 32;
    levels[0].pixels = canvas.paper[0];
    HATCH_TEST_OK(hatch_mipmap_complete(&chain, 1, &map_arena, &map_err), &map_err);
    for (uint32_t p = 0; p < 7; p++)
        pyramids[0][p] = levels[p].pixels;
    for (uint64_t i = 0; i < 30; i++) {
        const struct hatch_choice choice = choice_of(i, 0.3f, 1.5707963f);
        struct hatch_stroke best = hatch_place_exhaustively(&canvas, pyramids, &choice);
        ck_assert(best.x > 0.5f && best.x < 1 && best.length >= 0.1f && best.length <= 0.3f);
    }
}
END_TEST

/* Of 40 dots, whose paths have no length, the one is chosen that is nearest to the brightest column. */
START_TEST(the_exhaustive_method_places_dots_on_paper)
{
    struct hatch_canvas canvas;
    static float texels[64 * 64], means[6][64 * 64];
    float *pyramids[1][HATCH_MIP_LEVELS_MAX] = {{texels, means[0], means[1], means[2], means[3], means[4], means[5]}};
    map_style(NULL, "jitter 0\ndirection 0 0 1\nlength 0 0\nwidth 4", &map);
    const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 1, false, false};
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    for (uint32_t i = 0; i < 64 * 64; i++)
        texels[i] = 1 - fabsf((float)(i % 64) - 31.5f) / 32;
    for (uint64_t i = 0; i < 20; i++) {
        const struct hatch_choice choice = choice_of(i, 0, 0);
        struct hatch_stroke best = hatch_place_exhaustively(&canvas, pyramids, &choice);
        float least = 1;
        for (uint32_t c = 0; c < choice.candidates; c++)
            least = fminf(least, fabsf(hatch_choice_candidate(&map.style, &choice, c).x - 0.5f));
        ck_assert_float_le(fabsf(best.x - 0.5f), least + 0.04f);
    }
}
END_TEST

/* The paper is a sine wave along the strokes, so that the stroke whose middle is nearest to its crest adds most. */
START_TEST(the_exhaustive_method_rates_the_whole_stroke)
{
    const double turn = 2 * acos(-1);
    struct hatch_canvas canvas;
    static float texels[64 * 64], means[6][64 * 64];
    float *pyramids[1][HATCH_MIP_LEVELS_MAX] = {{texels, means[0], means[1], means[2], means[3], means[4], means[5]}};
    map_style(NULL, "jitter 0\ndirection 0 0 1\nlength 0.25 0.25", &map);
    const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 1, false, false};
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    for (uint32_t i = 0; i < 64 * 64; i++)
        texels[i] = (float)(0.5 + 0.5 * sin(turn * (i % 64 + 0.5) / 64));
    for (uint64_t i = 0; i < 20; i++) {
        const struct hatch_choice choice = choice_of(i, 0.25f, (float)(i % 2) * 3.14159265f);
        struct hatch_stroke best = hatch_place_exhaustively(&canvas, pyramids, &choice);
        double highest = -2;
        for (uint32_t c = 0; c < choice.candidates; c++) {
            struct hatch_stroke other = hatch_choice_candidate(&map.style, &choice, c);
            highest = fmax(highest, sin(turn * (double)other.x));
        }
        ck_assert_double_ge(sin(turn * (double)best.x), highest - 0.02);
    }
}
END_TEST

/* On paper of light and dark spots arcs of all lengths are rated as they will be drawn: the chosen one darkens the tile
 * about as much for its length as the best. */
START_TEST(the_exhaustive_method_rates_arcs_where_they_are_drawn)
{
    const double turn = 2 * acos(-1);
    double sum = 0;
    struct hatch_canvas canvas;
    static float means[6][64 * 64];
    map_style(NULL, "jitter 0\nwidth 2\ndirection 0 0 1\nlength 0.2 0.6\nbend 60 180", &map);
    const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 1, false, false};
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    float *texels = canvas.paper[0];
    float *pyramids[1][HATCH_MIP_LEVELS_MAX] = {{texels, means[0], means[1], means[2], means[3], means[4], means[5]}};
    for (uint32_t i = 0; i < 64 * 64; i++)
        texels[i] = (float)(0.5 + 0.5 * sin(turn * 4 * (i % 64 + 0.5) / 64) * sin(turn * 4 * (i / 64 + 0.5) / 64));
    for (uint64_t i = 0; i < 40; i++) {
        struct hatch_choice choice = {.seed = 5,
                                      .number = i,
                                      .candidates = 40,
                                      .length_max = 0.6f,
                                      .scale = _i ? 0.5f : 1,
                                      .direction_count = 2,
                                      .directions = {0.3f, 2}};
        struct hatch_stroke best = hatch_place_exhaustively(&canvas, pyramids, &choice);
        double highest = 0, chosen = hatch_canvas_try(&canvas, &best, 0, choice.scale) / (double)best.length;
        for (uint32_t c = 0; c < choice.candidates; c++) {
            struct hatch_stroke other = hatch_choice_candidate(&map.style, &choice, c);
            highest = fmax(highest, hatch_canvas_try(&canvas, &other, 0, choice.scale) / (double)other.length);
        }
        ck_assert_double_ge(chosen, 0.9 * highest);
        sum += chosen / highest;
    }
    ck_assert_double_ge(sum / 40, 0.99);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("placement exhaustive");
    TCase *tests = tcase_create("exhaustive");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, the_exhaustive_method_places_strokes_on_paper);
    tcase_add_test(tests, the_exhaustive_method_places_dots_on_paper);
    tcase_add_test(tests, the_exhaustive_method_rates_the_whole_stroke);
    tcase_add_loop_test(tests, the_exhaustive_method_rates_arcs_where_they_are_drawn, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
