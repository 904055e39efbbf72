#include "arenas.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "needs/needs.h"
#include "needs/tones.h"

static struct hatch_needs_tones tones;

/* Adds pixels of one tone. */
static void add(double tone, int count)
{
    for (int i = 0; i < count; i++)
        hatch_needs_add(&tones, tone);
}

START_TEST(one_tone_is_needed_up_to_the_tolerance)
{
    for (double tone = 0; tone <= 1; tone += 0.1) {
        memset(&tones, 0, sizeof tones);
        add(tone, 100);
        ck_assert_double_eq_tol(hatch_needs_darkest(&tones, 100, 0.01), fmax(tone - 0.01, 0), 1e-6);
        ck_assert_double_eq_tol(hatch_needs_lightest(&tones, 100, 0.01), fmin(tone + 0.01, 1), 1e-6);
        ck_assert_double_eq_tol(hatch_needs_excess(&tones, 100, tone / 2), tone / 2, 1e-6);
        ck_assert(hatch_needs_excess(&tones, 100, tone + 0.001) <= 0);
    }
}
END_TEST

/* Of 100 pixels, the mean falls by .01 if 5 get .2 less, or 10 get .1 less. */
START_TEST(few_dark_pixels_are_given_up)
{
    add(0.2, 90);
    add(0.7, 5);
    add(0.9, 5);
    ck_assert_double_eq_tol(hatch_needs_darkest(&tones, 100, 0.01), 0.7, 0.0003);
    ck_assert_double_eq_tol(hatch_needs_darkest(&tones, 100, 0.02), 0.6, 0.0003);
    ck_assert_double_eq_tol(hatch_needs_excess(&tones, 100, 0.6), 0.02, 1e-6);
    ck_assert_double_eq_tol(hatch_needs_lightest(&tones, 100, 0.009), 0.21, 0.0003);
}
END_TEST

START_TEST(no_pixel_needs_no_tone)
{
    ck_assert(hatch_needs_darkest(&tones, 0, 0.01) <= 0);
    ck_assert(hatch_needs_lightest(&tones, 0, 0.01) <= 0);
    ck_assert(hatch_needs_excess(&tones, 0, 0) <= 0);
}
END_TEST

#define HEAD "thing\tindex\tvalue\tunit\n"
#define BOX                                                                                                            \
    "region-low\t0\t-1\t\nregion-low\t1\t-2\t\nregion-low\t2\t3\t\nregion-side\t0\t1\t\nregion-side\t1\t2\t\n"         \
    "region-side\t2\t0\t\n"
#define ROWS BOX "tolerance\t0\t0.02\t\nrelative\t0\t1\t\nother\tx\ty\tz\ndarkest\t0\t0.5\ttone\n"
#define CELLS(count) "region-cells\t0\t" #count "\t\n"
#define CELL(index, px) "region-unit-px\t" #index "\t" #px "\tpx\n"

static float cells[HATCH_NEEDS_CELLS];

static enum hatch_status parse(const char *text, struct hatch_needs *needs)
{
    return hatch_needs_parse((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, cells, needs, &err);
}

START_TEST(a_file_is_read)
{
    struct hatch_needs needs;
    HATCH_TEST_OK(parse(HEAD ROWS "darkest\t1\t0.75\ttone\nunit-px\t63\t12.5\tpx\r\n\n" CELLS(2) CELL(1, 7)
                            CELL(32767, 9) "item-px\t0\t30\tpx\nitem-px\t70000\t20\tpx\n"
                                           "solid-px\t0\t64\tpx\n",
                        &needs),
                  &err);
    ck_assert(cells[0] <= 0);
    ck_assert_float_eq_tol(cells[1], 7, 1e-6f);
    ck_assert_float_eq_tol(cells[HATCH_NEEDS_CELLS - 1], 9, 1e-6f);
    ck_assert_double_eq_tol(needs.regions.low[1], -2, 1e-12);
    ck_assert_double_eq_tol(needs.regions.side[0], 1, 1e-12);
    ck_assert_double_eq_tol(needs.item_px, 30, 1e-12);
    ck_assert_double_eq_tol(needs.solid_px, 64, 1e-12);
    ck_assert_double_eq_tol(needs.tolerance, 0.02, 1e-12);
    ck_assert_double_eq_tol(needs.darkest, 0.75, 1e-12);
    ck_assert(needs.relative);
    ck_assert_double_eq_tol(needs.unit_px[63], 12.5, 1e-12);
    ck_assert(needs.unit_px[0] <= 0 && needs.unit_px[62] <= 0);
}
END_TEST

START_TEST(regions_that_nobody_reads_are_passed_over)
{
    const char *text = HEAD ROWS CELLS(1) "region-unit-px\tx\ty\t\n";
    struct hatch_needs needs;
    HATCH_TEST_OK(hatch_needs_parse((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, NULL, &needs, &err),
                  &err);
    ck_assert_double_eq_tol(needs.darkest, 0.5, 1e-12);
    ck_assert_int_eq(parse(text, &needs), HATCH_BAD_INPUT);
}
END_TEST

START_TEST(a_wrong_file_is_refused_with_its_row)
{
    static const char *const cases[][2] = {
        {"", "no table of needs"},
        {"[\n {\"thing\": \"tolerance\"}]\n", "no table of needs"},
        {HEAD, "no row 'tolerance'"},
        {HEAD "darkest\t2\t0\t\n", "row 2: darkest: want an index from 0 to 1"},
        {HEAD "tolerance\t0\t0.01\t\nrelative\t0\t0\t\n", "no row 'darkest'"},
        {HEAD ROWS "unit-px\t0\n", "row 12: fewer than 4 fields"},
        {HEAD ROWS "unit-px\t0\t1\n", "row 12: fewer than 4 fields"},
        {HEAD "tolerance\t0\t0\t\n", "row 2: tolerance: want a number from 1e-06 to 1"},
        {HEAD "darkest\t0\tnan\t\n", "row 2: darkest: want a number from 0 to 1"},
        {HEAD "darkest\t0\t1.5\t\n", "row 2: darkest: want a number from 0 to 1"},
        {HEAD ROWS "unit-px\t64\t1\tpx\n", "row 12: unit-px: want an index from 0 to 63"},
        {HEAD ROWS "unit-px\t0.5\t1\tpx\n", "row 12: unit-px: want an index from 0 to 63"},
        {HEAD ROWS "unit-px\t0\t-1\tpx\n", "row 12: unit-px: want a number"},
        {HEAD ROWS "region-unit-px\t32768\t1\tpx\n", "row 12: region-unit-px: want an index from 0 to 32767"},
        {HEAD "tolerance\t0\t0.01\t\nrelative\t0\t0\t\ndarkest\t0\t0\t\n", "no row 'region-low'"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hatch_needs needs = {.darkest = 7};
        ck_assert_int_eq(parse(cases[i][0], &needs), HATCH_BAD_INPUT);
        ck_assert_msg(strncmp(err.text, cases[i][1], strlen(cases[i][1])) == 0, "%s", err.text);
        ck_assert(needs.darkest > 6);
    }
}
END_TEST

/* needs(5): the least and the greatest value of each thing are read, and nothing beyond. */
START_TEST(ranges_include_their_ends)
{
    static const struct {
        const char *thing, *low, *high, *under, *over;
    } things[] = {
        {"tolerance", "1e-6", "1", "9e-7", "1.01"},
        {"relative", "0", "1", "-.01", "1.01"},
        {"darkest", "0", "1", "-.01", "1.01"},
        {"unit-px", "0", "1e30", "-.01", "2e30"},
        {"texels", "0", "1", "-.01", "1.01"},
        {"solid-px", "1", "1e6", ".99", "1000001"},
        {"item-px", "0", "1e30", "-.01", "2e30"},
        {"region-low", "-1e30", "1e30", "-2e30", "2e30"},
        {"region-side", "0", "1e30", "-.01", "2e30"},
        {"region-cells", "0", "32768", "-.01", "32769"},
        {"region-unit-px", "0", "1e30", "-.01", "2e30"},
    };
    for (size_t i = 0; i < sizeof things / sizeof *things; i++)
        for (int k = 0; k < 4; k++) {
            const char *values[4] = {things[i].low, things[i].high, things[i].under, things[i].over};
            char text[600], want[60];
            struct hatch_needs needs;
            snprintf(text, sizeof text, HEAD ROWS "%s\t0\t%s\t\n", things[i].thing, values[k]);
            snprintf(want, sizeof want, "row 12: %s: want a number", things[i].thing);
            enum hatch_status status = parse(text, &needs); /* a number of rows that is wrong is told after all rows */
            ck_assert_msg((status == HATCH_BAD_INPUT && strncmp(err.text, want, strlen(want)) == 0) == (k > 1),
                          "%s %s: %s", things[i].thing, values[k], status ? err.text : "read");
        }
}
END_TEST

/* needs(5): each thing has so many indices. */
START_TEST(indices_end_where_things_end)
{
    static const struct {
        const char *thing;
        unsigned last;
    } things[] = {{"tolerance", 0},
                  {"relative", 0},
                  {"darkest", 1},
                  {"unit-px", 63},
                  {"texels", HATCH_NEEDS_OCTAVES - 1},
                  {"solid-px", 0},
                  {"region-low", 2},
                  {"region-side", 2},
                  {"region-cells", 0},
                  {"region-unit-px", HATCH_NEEDS_CELLS - 1}};
    for (size_t i = 0; i < sizeof things / sizeof *things; i++)
        for (unsigned more = 0; more < 2; more++) {
            char text[600], want[80];
            struct hatch_needs needs;
            snprintf(text, sizeof text, HEAD ROWS "%s\t%u\t1\t\n", things[i].thing, things[i].last + more);
            snprintf(want, sizeof want, "row 12: %s: want an index from 0 to %u", things[i].thing, things[i].last);
            enum hatch_status status = parse(text, &needs);
            ck_assert_msg((status == HATCH_BAD_INPUT && strcmp(err.text, want) == 0) == more, "%s: %s", things[i].thing,
                          status ? err.text : "read");
        }
}
END_TEST

/* A file whose rows of cells come last, which is cut after any of its bytes: none but the whole one is read. Its last
 * byte ends a row that is whole. */
START_TEST(a_file_that_was_cut_is_refused)
{
    static const char text[] = HEAD ROWS CELLS(2) CELL(5, 12.5) "region-unit-px\t6\t12.5\t\n";
    for (size_t size = 0; size + 1 < sizeof text; size++) {
        const struct hatch_bytes file = {(const uint8_t *)text, size};
        bool whole = size + 2 >= sizeof text;
        struct hatch_needs needs;
        ck_assert_msg((hatch_needs_parse(file, cells, &needs, &err) == HATCH_OK) == whole, "%zu bytes", size);
        ck_assert_msg((hatch_needs_parse(file, NULL, &needs, &err) == HATCH_OK) == whole, "%zu bytes", size);
    }
    struct hatch_needs needs;
    ck_assert_int_eq(parse(HEAD ROWS CELLS(2) CELL(5, 12.5), &needs), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text,
                     "1 rows 'region-unit-px', not 2: the file was cut; render-gl SCENE --needs makes it anew");
    ck_assert_int_eq(parse(HEAD ROWS CELL(5, 12.5), &needs), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "no row 'region-cells'; render-gl SCENE --needs makes the file anew");
}
END_TEST

START_TEST(columns_reach_the_darkest_tone)
{
    static const float targets[] = {0.2f, 0.4f, 0.6f, 0.8f};
    struct hatch_needs needs = {.darkest = 0};
    ck_assert_uint_eq(hatch_needs_columns(&needs, targets, 4, targets[3]), 1);
    needs.darkest = 0.39;
    ck_assert_uint_eq(hatch_needs_columns(&needs, targets, 4, targets[3]), 2);
    needs.darkest = 0.41;
    ck_assert_uint_eq(hatch_needs_columns(&needs, targets, 4, targets[3]), 3);
    needs.relative = true; /* .41 of .8 */
    ck_assert_uint_eq(hatch_needs_columns(&needs, targets, 4, targets[3]), 2);
    needs.darkest = 1;
    ck_assert_uint_eq(hatch_needs_columns(&needs, targets, 4, targets[3]), 4);
    needs.relative = false;
    ck_assert_uint_eq(hatch_needs_columns(&needs, targets, 4, targets[3]), 4);
}
END_TEST

/* Steps of 1/32 up to the last tone; the first column counts from paper. */
START_TEST(columns_are_no_closer_than_the_tolerance_asks)
{
    float targets[32];
    struct hatch_needs needs = {.tolerance = 0.04};
    for (int i = 0; i < 32; i++)
        targets[i] = (float)(i + 1) / 32;
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 32), 1); /* .06 */
    needs.tolerance = 2 / 32.0 / HATCH_NEEDS_COLUMN;
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 32), 2);
    needs.tolerance *= 1.9;
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 32), 2);
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 31), 1); /* 31 is odd */
    needs.tolerance = 1;
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 32), 4); /* 8 columns; 4 would be fewer than 6 */
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 12), 2);
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 10), 1);
    needs.tolerance = 2 / 32.0 / HATCH_NEEDS_COLUMN;
    for (int i = 0; i < 32; i++)
        targets[i] /= 2;
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 32), 4);
    needs.relative = true; /* of the last tone, .5 */
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 32), 2);
    targets[8] += 0.001f; /* tones 7 and 9 are farther apart than the others */
    targets[9] += 0.001f;
    ck_assert_uint_eq(hatch_needs_every(&needs, targets, 32), 1);
}
END_TEST

/* Octave 7 has the pixels with 128 to 255 per tile, which read the level of 256. */
START_TEST(a_map_is_as_large_as_pixels_read_it)
{
    struct hatch_needs needs = {.tolerance = 0.01};
    needs.texels[5] = 0.9;
    needs.texels[7] = 0.1;
    ck_assert_uint_eq(hatch_needs_size(&needs, 512, 64), 256);
    ck_assert_uint_eq(hatch_needs_size(&needs, 256, 64), 256);
    ck_assert_uint_eq(hatch_needs_size(&needs, 128, 64), 128);
    needs.texels[7] = 0.005; /* few enough */
    ck_assert_uint_eq(hatch_needs_size(&needs, 512, 64), 64);
    ck_assert_uint_eq(hatch_needs_size(&needs, 512, 128), 128);
    needs.texels[6] = 0.006; /* together too many */
    ck_assert_uint_eq(hatch_needs_size(&needs, 512, 64), 128);
    needs.texels[5] = needs.texels[6] = needs.texels[7] = 0;
    needs.texels[23] = 1;
    ck_assert_uint_eq(hatch_needs_size(&needs, 512, 64), 512);
    ck_assert_uint_eq(hatch_needs_size(&needs, 4096, 64), 4096);
}
END_TEST

static const double box[2][3] = {{0, 0, 0}, {1, 1, 0}}; /* low; sides of a cell */

static struct hatch_needs_regions regions_of(void)
{
    struct hatch_needs_regions regions = {.px = cells};
    memset(cells, 0, sizeof cells);
    memcpy(regions.low, box[0], sizeof regions.low);
    memcpy(regions.side, box[1], sizeof regions.side);
    return regions;
}

/* A face from cell (1, 1) to (3, 2): its box touches six cells. */
START_TEST(a_face_raises_the_cells_of_its_box)
{
    struct hatch_needs_regions regions = regions_of();
    const double face[3][3] = {{1.5, 1.5, 0}, {3.5, 1.5, 5}, {1.5, 2.5, -5}};
    const double inside[3][3] = {{3.1, 2.1, 0}, {3.2, 2.1, 0}, {3.1, 2.2, 0}};
    const double beside[3][3] = {{4.1, 2.1, 0}, {4.2, 2.1, 0}, {4.1, 2.2, 0}};
    const double beyond[3][3] = {{-9, 99, 0}, {-9, 99, 0}, {-9, 99, 0}};
    hatch_needs_raise(&regions, face, 8);
    hatch_needs_raise(&regions, inside, 5);
    uint32_t raised = 0;
    for (uint32_t i = 0; i < HATCH_NEEDS_CELLS; i++)
        raised += cells[i] > 7;
    ck_assert_uint_eq(raised, 6);
    ck_assert_double_eq_tol(hatch_needs_px(&regions, inside), 8, 1e-6);
    ck_assert(hatch_needs_px(&regions, beside) <= 0);
    hatch_needs_raise(&regions, beyond, 3); /* the outermost cells stand for what lies outside */
    ck_assert_float_eq_tol(cells[(HATCH_NEEDS_SIDE - 1) * HATCH_NEEDS_SIDE], 3, 1e-6f);
}
END_TEST

START_TEST(cells_spread_to_their_neighbours)
{
    static float work[HATCH_NEEDS_CELLS];
    struct hatch_needs_regions regions = regions_of();
    const uint32_t middle = (5 * HATCH_NEEDS_SIDE + 5) * HATCH_NEEDS_SIDE + 5, corner = HATCH_NEEDS_CELLS - 1;
    cells[middle] = 4;
    cells[corner] = 2;
    hatch_needs_spread(&regions, work);
    uint32_t fours = 0, twos = 0;
    for (uint32_t i = 0; i < HATCH_NEEDS_CELLS; i++) {
        fours += cells[i] > 3;
        twos += cells[i] > 1 && cells[i] < 3;
    }
    ck_assert_uint_eq(fours, 27);
    ck_assert_uint_eq(twos, 8); /* at a corner */
}
END_TEST

START_TEST(tiles_on_patches_are_as_large_as_a_quarter_of_the_item)
{
    struct hatch_needs needs = {.item_px = 500};
    needs.texels[23] = 1;
    ck_assert_uint_eq(hatch_needs_tile(&needs, 256, 64), 128);
    ck_assert_uint_eq(hatch_needs_tile(&needs, 64, 64), 64);
    needs.item_px = 10;
    ck_assert_uint_eq(hatch_needs_tile(&needs, 256, 64), 64);
    needs.texels[5] = 0.001; /* a surface with coordinates of its own */
    ck_assert_uint_eq(hatch_needs_tile(&needs, 256, 64), 256);
    needs.texels[5] = 0;
    needs.item_px = 0; /* nothing is seen */
    ck_assert_uint_eq(hatch_needs_tile(&needs, 256, 64), 256);
}
END_TEST

START_TEST(slices_and_texels_follow_tolerance_and_period)
{
    struct hatch_needs needs = {.tolerance = 0.01, .solid_px = 64};
    ck_assert_uint_eq(hatch_needs_slices(&needs, 1, 64), 32); /* of 1/32, under .04 */
    ck_assert_uint_eq(hatch_needs_slices(&needs, 1, 16), 16);
    ck_assert_uint_eq(hatch_needs_slices(&needs, 2, 256), 64); /* 32 on the coarser level */
    ck_assert_uint_eq(hatch_needs_slices(&needs, 4, 64), 64);
    needs.tolerance = 0.003;
    ck_assert_uint_eq(hatch_needs_slices(&needs, 1, 64), 64);
    needs.tolerance = 1;
    ck_assert_uint_eq(hatch_needs_slices(&needs, 1, 64), 4);
    ck_assert_uint_eq(hatch_needs_slices(&needs, 4, 64), 32);
    ck_assert_uint_eq(hatch_needs_slices(&needs, 8, 64), 64);
    ck_assert_uint_eq(hatch_needs_solid(&needs, 64, 8), 32); /* two pixels per texel */
    needs.solid_px = 65;
    ck_assert_uint_eq(hatch_needs_solid(&needs, 64, 8), 64);
    needs.solid_px = 4;
    ck_assert_uint_eq(hatch_needs_solid(&needs, 64, 8), 8);
    needs.solid_px = 0; /* unknown */
    ck_assert_uint_eq(hatch_needs_solid(&needs, 64, 8), 64);
}
END_TEST

/* With one family, even response and even width, t / width strokes per pixel make the tone t. */
START_TEST(strokes_follow_the_law_of_widths)
{
    const struct hatch_stroke_pen pen = {
        .width_px = 2, .thin = 1, .response = {0.125f, 0.25f, 0.375f, 0.5f, 0.625f, 0.75f, 0.875f, 1}};
    struct hatch_needs needs = {.darkest = 1};
    needs.unit_px[31] = 100; /* tones up to .5 */
    ck_assert_double_eq_tol(hatch_needs_strokes(&needs, 1e6, &pen, 1), 100 * 0.5 / 2 / HATCH_STROKE_GAIN, 1e-5);
    needs.unit_px[7] = 1000; /* up to .125 */
    ck_assert_double_eq_tol(hatch_needs_strokes(&needs, 1e6, &pen, 1), 1000 * 0.125 / 2 / HATCH_STROKE_GAIN, 1e-5);
    ck_assert_double_eq_tol(hatch_needs_strokes(&needs, 50, &pen, 1), 50 * 0.5 / 2 / HATCH_STROKE_GAIN, 1e-5);
    ck_assert(hatch_needs_strokes(&needs, 0, &pen, 1) <= 0); /* the mesh is not seen */
    needs.darkest = 0.0625;                                  /* darker tones are drawn as this one */
    ck_assert_double_eq_tol(hatch_needs_strokes(&needs, 1e6, &pen, 1), 1000 * 0.0625 / 2 / HATCH_STROKE_GAIN, 1e-5);
    ck_assert_double_le(hatch_needs_strokes(&needs, 1e6, &pen, 2), 1000 * 0.0625 / 2 / HATCH_STROKE_GAIN + 1e-5);
}
END_TEST

static void forget(void)
{
    begin();
    memset(&tones, 0, sizeof tones);
}

static Suite *suite(void)
{
    Suite *suite = suite_create("needs");
    TCase *tests = tcase_create("needs");
    tcase_add_checked_fixture(tests, forget, end);
    tcase_add_test(tests, one_tone_is_needed_up_to_the_tolerance);
    tcase_add_test(tests, few_dark_pixels_are_given_up);
    tcase_add_test(tests, no_pixel_needs_no_tone);
    tcase_add_test(tests, a_file_is_read);
    tcase_add_test(tests, regions_that_nobody_reads_are_passed_over);
    tcase_add_test(tests, a_wrong_file_is_refused_with_its_row);
    tcase_add_test(tests, ranges_include_their_ends);
    tcase_add_test(tests, indices_end_where_things_end);
    tcase_add_test(tests, a_file_that_was_cut_is_refused);
    tcase_add_test(tests, columns_reach_the_darkest_tone);
    tcase_add_test(tests, columns_are_no_closer_than_the_tolerance_asks);
    tcase_add_test(tests, a_map_is_as_large_as_pixels_read_it);
    tcase_add_test(tests, a_face_raises_the_cells_of_its_box);
    tcase_add_test(tests, cells_spread_to_their_neighbours);
    tcase_add_test(tests, tiles_on_patches_are_as_large_as_a_quarter_of_the_item);
    tcase_add_test(tests, slices_and_texels_follow_tolerance_and_period);
    tcase_add_test(tests, strokes_follow_the_law_of_widths);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
