#include <math.h>

#include "fail_alloc.h"
#include "placement/place.h"
#include "tam/sheet.h"
#include "tam_map.h"

static struct test_map map;

/* The sink receives one column per tone, each with a full mip chain and its metadata. */
START_TEST(columns_are_passed_in_order_with_their_metadata)
{
    map_style("ink", NULL, &map);
    map.options.seed = UINT64_MAX;
    map_fill(&map);
    for (uint32_t tone = 0; tone < 6; tone++) {
        const struct hatch_mipmap *column = &map.columns[tone];
        char name[16];
        snprintf(name, sizeof name, "tone.%03u", tone);
        ck_assert_str_eq(column->name, name);
        ck_assert_uint_eq(column->level_count, 7);
        ck_assert_double_eq_tol(hatch_mipmap_attribute(column, "hatch:tone")->number, 0.15 * (tone + 1), 1e-6);
        ck_assert_str_eq(hatch_mipmap_attribute(column, "hatch:seed")->text, "18446744073709551615");
        ck_assert_str_eq(hatch_mipmap_attribute(column, "hatch:style")->text, "ink");
        ck_assert_double_eq(hatch_mipmap_attribute(column, "hatch:levels")->number, 2);
    }
}
END_TEST

/* Readers of a map learn whether crossing strokes darken each other. */
START_TEST(columns_tell_how_strokes_overlap)
{
    for (int flat = 0; flat < 2; flat++) {
        map_style(NULL, flat ? "overlap flat" : "overlap darkens", &map);
        map_fill(&map);
        const struct hatch_attribute *overlap = hatch_mipmap_attribute(&map.columns[0], "hatch:overlap");
        ck_assert_int_eq(map.tam.flat, flat);
        ck_assert_int_eq(overlap != NULL, flat);
        ck_assert(!flat || strcmp(overlap->text, "flat") == 0);
    }
}
END_TEST

START_TEST(strokes_have_their_column_and_level_in_drawing_order)
{
    map_style("ink", NULL, &map);
    map_fill(&map);
    ck_assert_uint_gt(map.strokes.count, 20);
    for (uint32_t i = 0; i < map.strokes.count; i++) {
        const struct hatch_stroke *s = &map.strokes.items[i], *before = s - (i > 0);
        ck_assert_uint_eq(s->id, i + 1);
        ck_assert(s->column < 6 && s->level < 2);
        ck_assert(s->column > before->column || (s->column == before->column && s->level <= before->level));
        ck_assert(s->length <= map.style.length_max && s->length >= 0);
    }
}
END_TEST

/* Parallel strokes in light columns, crossed ones in dark columns. */
START_TEST(directions_follow_the_style)
{
    map_style(NULL, "jitter 0\ndirection 10 0 0.5\ndirection 80 0.5 1", &map);
    map_fill(&map);
    uint32_t crossed = 0;
    for (uint32_t i = 0; i < map.strokes.count; i++) {
        const struct hatch_stroke *s = &map.strokes.items[i];
        bool steep = s->angle_rad > 0.7f;
        float target = map.tam.target[s->column];
        ck_assert(steep ? target >= 0.5f : target <= 0.5f);
        crossed += steep;
    }
    ck_assert(crossed > 0 && crossed < map.strokes.count);
}
END_TEST

START_TEST(a_tone_without_directions_uses_all_of_them)
{
    map_style(NULL, "jitter 0\ndirection 0 0 0.01\ndirection 90 0.99 1", &map);
    map_fill(&map);
    uint32_t steep = 0;
    for (uint32_t i = 0; i < map.strokes.count; i++)
        steep += map.strokes.items[i].angle_rad > 0.7f;
    ck_assert(steep > 0 && steep < map.strokes.count);
}
END_TEST

START_TEST(ids_are_those_of_the_strokes_that_cover_the_pixels)
{
    map_style("pencil", NULL, &map);
    map.options.ids = true;
    map_fill(&map);
    ck_assert(map.tam.ids);
    static bool seen[100000];
    uint32_t first = 0, found = 0;
    for (uint32_t tone = 0; tone < 6; tone++)
        for (uint32_t level = 0; level < 7; level++) {
            const struct hatch_image *image = &map.columns[tone].levels[level];
            ck_assert_uint_eq(image->channel_count, 3);
            for (uint32_t i = 0; i < image->width * image->height; i++) {
                const float *p = image->pixels + 3 * i;
                ck_assert(level < 2 || (p[1] == 0 && p[2] == 0));
                ck_assert(p[1] >= 0 && p[1] <= (float)map.strokes.count && p[2] >= 0 && p[2] <= 1);
                if (p[1] == 0)
                    continue;
                seen[(uint32_t)p[1]] = true;
                const struct hatch_stroke *s = &map.strokes.items[(uint32_t)p[1] - 1];
                ck_assert(s->column <= tone && s->level >= level);
            }
        }
    for (; first < map.strokes.count && map.strokes.items[first].column == 0; first++)
        found += seen[first + 1]; /* those of later columns may be covered completely */
    ck_assert(first > 20 && found > first * 9 / 10);
}
END_TEST

START_TEST(a_random_seed_determines_the_drawing)
{
    map_style("ink", NULL, &map);
    map_fill(&map);
    struct hatch_stroke_list first = map.strokes;
    map_fill(&map);
    ck_assert_uint_eq(map.strokes.count, first.count);
    ck_assert_mem_eq(map.strokes.items, first.items, first.count * sizeof *first.items);
    map.options.seed = 2;
    map_fill(&map);
    ck_assert_mem_ne(map.strokes.items, first.items, sizeof *first.items);
}
END_TEST

/* Lines across the whole tile keep their distance. With the box-filtered pyramids of the paper a few pairs are close to
 * each other at block borders; of 45 random pairs 3.5 would be. */
START_TEST(lines_keep_their_distance)
{
    map_style(NULL, "jitter 0\ndirection 0 0 1\nlength 1 1\ndarkest 0.24", &map);
    map.options.tones = map.options.levels = 1;
    map.options.method = _i ? HATCH_FILL_EXHAUSTIVE : HATCH_FILL_FIELD;
    map_fill(&map);
    ck_assert_uint_ge(map.strokes.count, 7);
    uint32_t close = 0;
    for (uint32_t i = 0; i < map.strokes.count; i++)
        for (uint32_t k = 0; k < i; k++) {
            float apart = fabsf(map.strokes.items[i].y - map.strokes.items[k].y);
            apart = apart > 0.5f ? 1 - apart : apart;
            close += apart * 64 < 2.5f;
        }
    ck_assert_uint_le(close, _i ? 1 : 0);
}
END_TEST

START_TEST(growing_strokes_start_small)
{
    map_style("ink", NULL, &map);
    map.options.tones = 12;
    map_fill(&map);
    uint32_t whole = map.strokes.count;
    map.options.growth = 0.6f;
    map_fill(&map);
    ck_assert_uint_gt(map.strokes.count, whole); /* smaller ones, so more of them */
    for (uint32_t tone = 0; tone < 12; tone++)
        ck_assert_double_eq(hatch_mipmap_attribute(&map.columns[tone], "hatch:growth")->number, (double)0.6f);
}
END_TEST

/* The number of strokes of the lightest column that are at full size in the finest image of a column. */
static uint32_t count_full_grown(uint32_t tone)
{
    struct hatch_canvas canvas;
    uint32_t count = 0;
    const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 1, false, false};
    HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
    for (uint32_t i = 0; i < map.strokes.count && map.strokes.items[i].column == 0; i++) {
        bool whole = true;
        (void)hatch_canvas_try(&canvas, &map.strokes.items[i], 0, 1);
        for (uint32_t k = 0; k < canvas.footprint.count; k++)
            whole &= map.columns[tone].levels[0].pixels[canvas.footprint.at[k]] <= 1.001f - canvas.footprint.alpha[k];
        count += whole;
    }
    return count;
}

START_TEST(growing_strokes_end_at_their_full_size)
{
    map_style("ink", NULL, &map);
    map.options.tones = 12;
    map.options.growth = 0.6f;
    map_fill(&map);
    uint32_t all = 0;
    while (map.strokes.items[all].column == 0)
        all++;
    ck_assert_uint_gt(all, 5);
    ck_assert_uint_lt(count_full_grown(0), all / 3);
    ck_assert_uint_eq(count_full_grown(5), all); /* they grow over a third of the columns */
}
END_TEST

/* Drawn again one by one, each stroke brings the image nearer to its target, from whichever side. */
START_TEST(every_stroke_brings_its_image_closer_to_the_target)
{
    uint32_t past = 0;
    for (uint64_t seed = 1; seed <= 5; seed++) {
        map_style("ink", NULL, &map);
        map.options.seed = seed;
        map.options.levels = 1;
        map.options.tones = 12;
        map_fill(&map);
        const struct hatch_canvas_options options = {&map.style, &map.brush, 64, 1, false, false};
        struct hatch_canvas canvas;
        HATCH_TEST_OK(hatch_canvas_make(&options, &map_arena, &canvas, &map_err), &map_err);
        for (uint32_t i = 0; i < map.strokes.count; i++) {
            const struct hatch_stroke *stroke = &map.strokes.items[i];
            double target = (double)map.tam.target[stroke->column], missing = target - canvas.darkness[0];
            hatch_canvas_draw(&canvas, stroke, 0, 0, 1);
            double left = target - canvas.darkness[0];
            ck_assert(missing > 0 && left < missing && left >= -missing);
            past += left < 0;
        }
    }
    ck_assert_uint_gt(past, 20);
}
END_TEST

/* Returns the number of the choice that a stroke comes from, where each choice has one candidate: at least `from`. */
static uint64_t number_of(const struct hatch_stroke *stroke, uint64_t from)
{
    struct hatch_choice choice = {.seed = map.options.seed, .number = from, .direction_count = 1};
    for (; choice.number < from + 100; choice.number++) {
        struct hatch_stroke candidate = hatch_choice_candidate(&map.style, &choice, 0);
        if (candidate.x == stroke->x && candidate.y == stroke->y)
            return choice.number;
    }
    ck_abort_msg("stroke %u is none of the choices from %u on", stroke->id, (unsigned)from);
}

/* The ink is lighter than the tone, so each image ends after eight choices in a row that have no effect: between two
 * strokes of an image there are at most seven of these, and between two images at least eight. Of two columns, the
 * first reaches its tone. */
START_TEST(an_image_is_full_after_eight_choices_without_effect)
{
    map_style(NULL,
              "brush round\njitter 0\ndirection 0 0 1\nlength 1 1\nwidth 4\nink 0.5\noverlap flat\n"
              "darkest 1\ncandidates 1 1",
              &map);
    map.options.tones = 1 + (uint32_t)_i;
    map.options.method = HATCH_FILL_EXHAUSTIVE;
    uint64_t least = UINT64_MAX, most = 0;
    for (map.options.seed = 1; map.options.seed <= 30; map.options.seed++) {
        map_fill(&map);
        uint64_t number = number_of(map.strokes.items, 0);
        for (uint32_t i = 1; i < map.strokes.count; i++) {
            uint64_t next = number_of(&map.strokes.items[i], number + 1), between = next - number - 1;
            if (map.strokes.items[i].level == map.strokes.items[i - 1].level &&
                map.strokes.items[i].column == map.strokes.items[i - 1].column)
                most = between > most ? between : most;
            else
                least = between < least ? between : least;
            number = next;
        }
    }
    ck_assert_uint_eq(most, 7);
    ck_assert(_i == 1 || least == 8);
}
END_TEST

static enum hatch_status fail_at_column_2(void *context, uint32_t tone, const struct hatch_mipmap *column,
                                          struct hatch_err *err)
{
    (void)column;
    uint32_t *calls = context;
    ++*calls;
    return tone == 2 ? hatch_fail(err, HATCH_IO, "no room for column %u", tone) : HATCH_OK;
}

START_TEST(a_failing_sink_ends_the_filling)
{
    map_style("ink", NULL, &map);
    uint32_t calls = 0;
    struct hatch_stroke_list list = {.count = 9};
    const struct hatch_tam_sink sink = {fail_at_column_2, &calls};
    ck_assert_int_eq(hatch_tam_fill(&map.options, &map_arena, &map_scratch, &sink, &list, NULL, &map_err), HATCH_IO);
    ck_assert_str_eq(map_err.text, "no room for column 2");
    ck_assert_uint_eq(calls, 3);
    ck_assert_uint_eq(list.count, 9);
    ck_assert_ptr_null(hatch_arena_mark(&map_scratch).block);
}
END_TEST

static enum hatch_status ignore(void *context, uint32_t tone, const struct hatch_mipmap *column, struct hatch_err *err)
{
    (void)context, (void)tone, (void)column, (void)err;
    return HATCH_OK;
}

/* Six tones rise to .9. */
START_TEST(images_that_miss_their_tone_are_counted)
{
    static const struct {
        const char *lines;
        uint32_t images;
        float most, off;
        bool light_ink;
    } cases[] = {{NULL, 0, 0.02f, 0.02f, false},
                 {"overlap flat\nink 0.5", 6, 0.4f, 1e-4f, true}, /* .5 instead of .6, .75 and .9, on two levels */
                 {"color 0 fff", 12, 0.9f, 1e-4f, true},
                 {"color 0 fff\ndarkest 0.04", 0, 0.04f, 1e-4f, true},
                 {"width 64", 12, 0.7f, 0.2f, false}};
    struct hatch_fill_misses misses;
    const struct hatch_tam_sink sink = {ignore, NULL};
    map_style("ink", cases[_i].lines, &map);
    HATCH_TEST_OK(hatch_tam_fill(&map.options, &map_arena, &map_scratch, &sink, NULL, &misses, &map_err), &map_err);
    ck_assert_uint_eq(misses.images, cases[_i].images);
    ck_assert_float_eq_tol(misses.most, cases[_i].most, cases[_i].off);
    ck_assert_int_eq(misses.light_ink, cases[_i].light_ink);
}
END_TEST

/* Half of six columns are the second, fourth and sixth, as a map of three columns; with four filled, two of three. */
START_TEST(each_second_column_has_the_whole_maps_pixels)
{
    static struct test_map half;
    map_style("ink", NULL, &map);
    map_fill(&map);
    map_style("ink", NULL, &half);
    half.options.every = 2;
    half.options.needed = _i ? 4 : 0;
    const struct hatch_tam_sink sink = {map_keep, &half};
    HATCH_TEST_OK(hatch_tam_fill(&half.options, &map_arena, &map_scratch, &sink, &half.strokes, NULL, &map_err),
                  &map_err);
    HATCH_TEST_OK(hatch_tam_from_mipmaps(half.columns, _i ? 2 : 3, &half.tam, &map_err), &map_err);
    ck_assert_uint_eq(half.tam.whole.tones, 3);
    for (uint32_t i = 0; i < half.tam.tones; i++) {
        ck_assert_float_eq(half.tam.target[i], map.tam.target[2 * i + 1]);
        for (uint32_t level = 0; level < 7; level++) {
            const struct hatch_image *a = &half.columns[i].levels[level], *b = &map.columns[2 * i + 1].levels[level];
            ck_assert_mem_eq(a->pixels, b->pixels, sizeof *a->pixels * a->width * a->height * a->channel_count);
        }
    }
}
END_TEST

START_TEST(a_rounded_map_that_lacks_nothing_names_the_tolerance)
{
    map_style("ink", NULL, &map);
    map.options.tolerance = 0.01f;
    map_fill(&map);
    ck_assert(hatch_tam_is_whole(&map.tam));
    ck_assert_float_eq(map.tam.whole.tolerance, 0.01f);
}
END_TEST

static enum hatch_status fill(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    const struct hatch_tam_sink sink = {ignore, NULL};
    return hatch_tam_fill(&map.options, keep, scratch, &sink, context, NULL, err);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_stroke_list list = {0};
    map_style("ink", "candidates 2 1", &map);
    map.options.ids = true;
    map.options.method = _i ? HATCH_FILL_EXHAUSTIVE : HATCH_FILL_FIELD;
    ck_assert_uint_ge(hatch_test_fail_alloc(fill, &list, &list, sizeof list), 20);
}
END_TEST

/* The background is light grey, the coarsest level on top, columns run from the left. */
START_TEST(the_sheet_shows_every_image)
{
    struct hatch_tam_sheet sheet;
    map_style("ink", NULL, &map);
    map_fill(&map);
    const struct hatch_tam_sheet_options options = {.size_px = 64, .levels = 2, .tones = 6, .shown = 3};
    HATCH_TEST_OK(hatch_tam_sheet_make(&options, &map_arena, &sheet, &map_err), &map_err);
    for (uint32_t tone = 0; tone < 6; tone++)
        hatch_tam_sheet_add(&sheet, tone, &map.columns[tone]);
    ck_assert_uint_eq(sheet.picture.width, 3 * 72 + 8);
    ck_assert_uint_eq(sheet.picture.height, 8 + 32 + 8 + 64 + 8);
    ck_assert_float_eq(sheet.picture.pixels[0], 0.6f);
    for (uint32_t slot = 0; slot < 3; slot++)
        for (uint32_t level = 0; level < 2; level++) {
            const struct hatch_image *image = &map.columns[2 * slot + 1].levels[level];
            uint32_t left = 8 + 72 * slot + (level ? 16 : 0), top = level ? 8 : 48;
            for (uint32_t i = 0; i < image->width * image->height; i++) {
                uint32_t x = left + i % image->width, y = top + i / image->width;
                ck_assert_float_eq(sheet.picture.pixels[y * sheet.picture.width + x], image->pixels[i]);
            }
        }
}
END_TEST

static enum hatch_status make_sheet(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    (void)scratch;
    const struct hatch_tam_sheet_options options = {64, 2, 6, 6, true};
    return hatch_tam_sheet_make(&options, keep, context, err);
}

START_TEST(a_sheet_survives_failed_allocations)
{
    struct hatch_tam_sheet sheet = {.options = {.tones = 5}};
    ck_assert_uint_ge(hatch_test_fail_alloc(make_sheet, &sheet, &sheet, sizeof sheet), 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam fill");
    TCase *tests = tcase_create("fill");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, columns_are_passed_in_order_with_their_metadata);
    tcase_add_test(tests, columns_tell_how_strokes_overlap);
    tcase_add_test(tests, strokes_have_their_column_and_level_in_drawing_order);
    tcase_add_loop_test(tests, each_second_column_has_the_whole_maps_pixels, 0, 2);
    tcase_add_test(tests, a_rounded_map_that_lacks_nothing_names_the_tolerance);
    tcase_add_test(tests, directions_follow_the_style);
    tcase_add_test(tests, a_tone_without_directions_uses_all_of_them);
    tcase_add_test(tests, ids_are_those_of_the_strokes_that_cover_the_pixels);
    tcase_add_test(tests, a_random_seed_determines_the_drawing);
    tcase_add_loop_test(tests, lines_keep_their_distance, 0, 2);
    tcase_add_test(tests, growing_strokes_start_small);
    tcase_add_test(tests, growing_strokes_end_at_their_full_size);
    tcase_add_test(tests, every_stroke_brings_its_image_closer_to_the_target);
    tcase_add_loop_test(tests, an_image_is_full_after_eight_choices_without_effect, 0, 2);
    tcase_add_loop_test(tests, images_that_miss_their_tone_are_counted, 0, 5);
    tcase_add_test(tests, a_failing_sink_ends_the_filling);
    tcase_add_loop_test(tests, every_failed_allocation_is_a_status, 0, 2);
    tcase_add_test(tests, the_sheet_shows_every_image);
    tcase_add_test(tests, a_sheet_survives_failed_allocations);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
