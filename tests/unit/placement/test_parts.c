#include <math.h>

#include "tam_map.h"

static struct test_map map;
static struct hatch_tam tam;

static void begin(void)
{
    map_begin();
    map_style("ink", NULL, &map);
    map.options.ids = true;
    map_fill(&map);
    tam = (struct hatch_tam){.tones = 77};
}

static void check_rejected(uint32_t count, const char *message)
{
    ck_assert_int_eq(hatch_tam_from_mipmaps(map.columns, count, &tam, &map_err), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(map_err.text, message) != NULL, "'%s', want '%s'", map_err.text, message);
    ck_assert_uint_eq(tam.tones, 77);
}

START_TEST(a_map_is_kept_by_reference)
{
    HATCH_TEST_OK(hatch_tam_from_mipmaps(map.columns, 6, &tam, &map_err), &map_err);
    ck_assert_uint_eq(tam.size_px, 64);
    ck_assert_uint_eq(tam.tones, 6);
    ck_assert_uint_eq(tam.levels, 2);
    ck_assert(tam.ids && !tam.color);
    ck_assert_ptr_eq(tam.columns, map.columns);
    for (int i = 0; i < 6; i++)
        ck_assert_float_eq_tol(tam.target[i], 0.15f * (float)(i + 1), 1e-6f);
}
END_TEST

/* The first tone may be paper and the others equal, and strokes may be drawn on all levels. */
START_TEST(attributes_may_have_their_limits)
{
    for (uint32_t i = 0; i < 6; i++) {
        hatch_mipmap_set_number(&map.columns[i], HATCH_TAM_ATTR_TONE, i > 0, HATCH_ATTRIBUTE_FLOAT);
        hatch_mipmap_set_number(&map.columns[i], HATCH_TAM_ATTR_LEVELS, 7, HATCH_ATTRIBUTE_INT);
    }
    HATCH_TEST_OK(hatch_tam_from_mipmaps(map.columns, 6, &tam, &map_err), &map_err);
    ck_assert_uint_eq(tam.levels, 7);
    ck_assert_float_eq(tam.target[0], 0);
    ck_assert_float_eq(tam.target[5], 1);
}
END_TEST

START_TEST(part_names_must_be_numbered_without_gaps)
{
    strcpy(map.columns[3].name, "tone.004");
    check_rejected(6, "part 3 is named 'tone.004', want tone.003: not a tonal art map");
    strcpy(map.columns[0].name, "");
    check_rejected(6, "part 0 is named ''");
}
END_TEST

START_TEST(a_count_out_of_range_is_rejected)
{
    check_rejected(0, "0 parts");
    check_rejected(257, "257 parts");
}
END_TEST

START_TEST(shapes_must_agree)
{
    struct hatch_mipmap *part = &map.columns[2];
    part->levels[0].width = 32;
    check_rejected(6, "tone.002: 32x64 pixels, want a square");
    part->levels[0].height = 32;
    check_rejected(6, "tone.002: 32 pixels and 7 levels, but tone.000 has 64 pixels and 7 levels");
    part->levels[0].width = part->levels[0].height = 64;
    part->level_count = 6;
    check_rejected(6, "tone.002: 64 pixels and 6 levels, but tone.000 has 64 pixels and 7 levels");
    for (int i = 0; i < 6; i++)
        map.columns[i].level_count = 6;
    check_rejected(6, "tone.000: 6 mip levels, want the whole chain of 7");
}
END_TEST

START_TEST(channels_must_be_known_and_agree)
{
    strcpy(map.columns[0].levels[0].channels[0].name, "Z");
    check_rejected(6, "tone.000: no channel Y");
    strcpy(map.columns[0].levels[0].channels[0].name, "Y");
    map.columns[1].levels[0].channel_count = 2;
    check_rejected(6, "tone.001: channels differ from those of tone.000");
    map.columns[1].levels[0].channel_count = 3;
    strcpy(map.columns[1].levels[0].channels[1].name, "t");
    strcpy(map.columns[1].levels[0].channels[2].name, "id");
    check_rejected(6, "tone.001: channels differ from those of tone.000");
}
END_TEST

START_TEST(targets_must_exist_and_rise)
{
    hatch_mipmap_set_number(&map.columns[4], HATCH_TAM_ATTR_TONE, 0.1, HATCH_ATTRIBUTE_FLOAT);
    check_rejected(6, "tone.004: tone 0.1 is lighter than the column before it, 0.6");
    hatch_mipmap_set_number(&map.columns[4], HATCH_TAM_ATTR_TONE, NAN, HATCH_ATTRIBUTE_FLOAT);
    check_rejected(6, "tone.004: hatch:tone nan, want 0 to 1");
    hatch_mipmap_set_text(&map.columns[4], HATCH_TAM_ATTR_TONE, "dark");
    check_rejected(6, "tone.004: no attribute hatch:tone");
}
END_TEST

START_TEST(the_number_of_drawn_levels_must_be_in_range)
{
    hatch_mipmap_set_number(&map.columns[0], HATCH_TAM_ATTR_LEVELS, 8, HATCH_ATTRIBUTE_INT);
    check_rejected(6, "tone.000: hatch:levels 8, want 1 to 7");
    hatch_mipmap_set_number(&map.columns[0], HATCH_TAM_ATTR_LEVELS, 2, HATCH_ATTRIBUTE_FLOAT);
    check_rejected(6, "tone.000: hatch:levels is not a whole number");
    hatch_mipmap_set_number(&map.columns[0], HATCH_TAM_ATTR_LEVELS, 3, HATCH_ATTRIBUTE_INT);
    check_rejected(6, "tone.001: 2 drawn levels, but the first column has 3");
}
END_TEST

START_TEST(a_pixel_that_is_not_finite_is_rejected)
{
    map.columns[5].levels[6].pixels[0] = NAN;
    check_rejected(6, "tone.005: level 6: a pixel is not a finite number");
    map.columns[5].levels[6].pixels[0] = INFINITY;
    check_rejected(6, "level 6");
}
END_TEST

/* Shares of the work that were reported. */
struct shares {
    uint32_t count, falls;
    double last;
};

static void note_share(void *context, double share)
{
    struct shares *shares = context;
    shares->count++;
    shares->falls += share < shares->last || share > 1;
    shares->last = share;
}

/* A column may take minutes: progress is told stroke by stroke. */
START_TEST(progress_is_told_within_columns)
{
    struct shares shares = {0};
    const struct hatch_progress progress = {note_share, &shares};
    map_style("ink", NULL, &map);
    map.options.progress = &progress;
    map_fill(&map);
    map.options.progress = NULL;
    ck_assert_uint_ge(shares.count, map.strokes.count);
    ck_assert_uint_eq(shares.falls, 0);
    ck_assert_double_gt(shares.last, 0.9);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam parts");
    TCase *tests = tcase_create("parts");
    tcase_add_checked_fixture(tests, begin, map_end);
    tcase_add_test(tests, progress_is_told_within_columns);
    tcase_add_test(tests, a_map_is_kept_by_reference);
    tcase_add_test(tests, attributes_may_have_their_limits);
    tcase_add_test(tests, part_names_must_be_numbered_without_gaps);
    tcase_add_test(tests, a_count_out_of_range_is_rejected);
    tcase_add_test(tests, shapes_must_agree);
    tcase_add_test(tests, channels_must_be_known_and_agree);
    tcase_add_test(tests, targets_must_exist_and_rise);
    tcase_add_test(tests, the_number_of_drawn_levels_must_be_in_range);
    tcase_add_test(tests, a_pixel_that_is_not_finite_is_rejected);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
