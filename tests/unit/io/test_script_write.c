/* Drawings as stroke scripts: the reader finds each path where it lies on the page, and as wide as its pen. */
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "image/image.h"
#include "io/script/write.h"
#include "io/svg/svg.h"
#include "io/svg/write.h"
#include "stroke/path.h"
#include "stroke/script.h"

#include "arenas.h"

#define TILE_PX 100

/* On a page of 200 x 100 mm, whose tile has 50 mm more above it and below: a dot in the second layer, an open path in
 * the first, and a closed one. */
static double points[] = {50, 50, 20, 10, 60, 10, 100, 0, 140, 0, 140, 30};
static struct hatch_vector_path paths[] = {{.first = 0, .count = 1, .layer = 1, .id = 9},
                                           {.first = 1, .count = 2, .id = 4000000000u},
                                           {.first = 3, .count = 3, .id = 7, .closed = true}};
static const struct hatch_drawing_layer layers[] = {{"outlines", {0.25f, 0, 1}, 0.5, NULL},
                                                    {"dots", {0, 0, 0}, 20, NULL}};
static const struct hatch_drawing drawing = {.width_mm = 200,
                                             .height_mm = 100,
                                             .layer_count = 2,
                                             .layers = layers,
                                             .paths = {.count = 3, .paths = paths, .points = points}};

static void check_stroke(const struct hatch_stroke *stroke, float x, float y, float length, float width_px)
{
    ck_assert_float_eq_tol(stroke->x, x, 1e-6f);
    ck_assert_float_eq_tol(stroke->y, y, 1e-6f);
    ck_assert_float_eq_tol(stroke->length, length, 1e-6f);
    ck_assert_float_eq_tol(stroke->width_px, width_px, 1e-5f);
    ck_assert_float_eq(stroke->tone, 1);
}

START_TEST(the_reader_reads_the_paths_of_a_drawing)
{
    struct hatch_buffer file = {.arena = &keep};
    struct hatch_stroke_list list;
    HATCH_TEST_OK(hatch_script_write(&drawing, &scratch, &file, &err), &err);
    HATCH_TEST_OK(hatch_script_parse((struct hatch_bytes){file.data, file.size}, TILE_PX, &keep, &list, &err), &err);
    ck_assert_uint_eq(list.count, 3);
    check_stroke(&list.items[0], 0.2f, 0.3f, 0.2f, 0.25f);
    check_stroke(&list.items[1], 0.6f, 0.325f, 0.6f, 0.25f);
    check_stroke(&list.items[2], 0.25f, 0.5f, 0, 10);
    ck_assert_uint_eq(list.items[1].path->count, 4);
    ck_assert_float_eq_tol(list.items[1].path->xy[0], -0.1f, 1e-6f);
    ck_assert_float_eq_tol(list.items[1].path->xy[7], -0.075f, 1e-6f);
    ck_assert_ptr_null(list.items[2].path);
    ck_assert_float_eq(list.items[0].rgb[0], hatch_srgb_to_linear(137 / 255.0f)); /* the nearest code to 0.25 */
    for (uint32_t i = 0; i < 3; i++)
        ck_assert_uint_eq(list.items[i].id, i + 1);
    ck_assert_uint_eq(list.items[0].texture_seed, 4000000000u);
    ck_assert_uint_eq(list.items[2].texture_seed, 9);
}
END_TEST

START_TEST(a_page_higher_than_wide_lies_in_the_middle_of_the_tile)
{
    struct hatch_drawing high = drawing;
    struct hatch_buffer file = {.arena = &keep};
    struct hatch_stroke_list list;
    high.height_mm = 400;
    HATCH_TEST_OK(hatch_script_write(&high, &scratch, &file, &err), &err);
    HATCH_TEST_OK(hatch_script_parse((struct hatch_bytes){file.data, file.size}, TILE_PX, &keep, &list, &err), &err);
    check_stroke(&list.items[0], 0.35f, 0.025f, 0.1f, 0.125f);
}
END_TEST

START_TEST(a_pen_wider_than_the_reader_takes_is_refused)
{
    struct hatch_drawing small = drawing;
    struct hatch_buffer file = {.arena = &keep};
    struct hatch_stroke_list list;
    small.width_mm = small.height_mm = 5;
    HATCH_TEST_OK(hatch_script_write(&small, &scratch, &file, &err), &err);
    HATCH_TEST_OK(hatch_script_parse((struct hatch_bytes){file.data, file.size}, TILE_PX, &keep, &list, &err), &err);
    small.width_mm = small.height_mm = 4.9;
    ck_assert_int_eq(hatch_script_write(&small, &scratch, &file, &err), HATCH_LIMIT);
    ck_assert_str_eq(err.text, "dots: a pen of 20 mm on a page of 4.9 x 4.9 mm, want at most 4 pages");
}
END_TEST

/* Paths, a pen, a page and colours with more digits than files hold: readers of both formats find the same strokes. */
START_TEST(strokes_are_those_of_the_svg_document)
{
    enum { PATHS = 40, EACH = 5 };
    static const struct hatch_stroke_look look = {
        .color_count = 2, .mixes = true, .colors = {{0.1234f, 0.5f, 0.003f}, {0.9f, 0.2f, 0.7f}}};
    const struct hatch_drawing_layer pens[] = {{"outlines", {0.3f, 0.01f, 0.77f}, 0.52917, NULL},
                                               {"strokes-1", {0, 0, 0}, 0.0004, &look}};
    double places[2 * PATHS * EACH];
    struct hatch_vector_path lines[PATHS];
    struct hatch_buffer script = {.arena = &keep}, svg = {.arena = &keep};
    struct hatch_stroke_list found[2];
    struct hatch_svg_notes notes;
    for (uint32_t i = 0; i < 2 * PATHS * EACH; i++)
        places[i] = 169.33333 * (double)hatch_random_unit(1, 0, i);
    for (uint32_t i = 0; i < PATHS; i++)
        lines[i] = (struct hatch_vector_path){
            .first = EACH * i, .count = EACH, .layer = i >= PATHS / 2, .id = i + 1, .closed = i % 2};
    const struct hatch_drawing odd = {.width_mm = 169.33333,
                                      .height_mm = 169.33333,
                                      .layer_count = 2,
                                      .layers = pens,
                                      .paths = {.count = PATHS, .paths = lines, .points = places}};
    HATCH_TEST_OK(hatch_script_write(&odd, &scratch, &script, &err), &err);
    HATCH_TEST_OK(hatch_svg_write(&odd, &scratch, &svg, &err), &err);
    HATCH_TEST_OK(hatch_script_parse((struct hatch_bytes){script.data, script.size}, TILE_PX, &keep, &found[0], &err),
                  &err);
    HATCH_TEST_OK(
        hatch_svg_read((struct hatch_bytes){svg.data, svg.size}, TILE_PX, &keep, &scratch, &found[1], &notes, &err),
        &err);
    ck_assert_uint_eq(found[0].count, PATHS);
    ck_assert_uint_eq(found[1].count, PATHS);
    for (uint32_t i = 0; i < PATHS; i++) {
        const struct hatch_stroke *a = &found[0].items[i], *b = &found[1].items[i];
        ck_assert_float_eq(a->x, b->x);
        ck_assert_float_eq(a->y, b->y);
        ck_assert_float_eq(a->width_px, b->width_px);
        ck_assert_mem_eq(a->rgb, b->rgb, sizeof a->rgb);
        ck_assert_uint_eq(a->path->count, b->path->count);
        ck_assert_mem_eq(a->path->xy, b->path->xy, 2 * sizeof(float) * a->path->count);
    }
}
END_TEST

static enum hatch_status write_all(void *context, struct hatch_arena *to, struct hatch_arena *work,
                                   struct hatch_err *why)
{
    struct hatch_buffer file = {.arena = to};
    return hatch_script_write(context, work, &file, why);
}

START_TEST(every_failed_allocation_is_reported)
{
    struct hatch_drawing copy = drawing;
    hatch_test_fail_alloc(write_all, &copy, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io script write");
    TCase *tests = tcase_create("write");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_reader_reads_the_paths_of_a_drawing);
    tcase_add_test(tests, a_page_higher_than_wide_lies_in_the_middle_of_the_tile);
    tcase_add_test(tests, a_pen_wider_than_the_reader_takes_is_refused);
    tcase_add_test(tests, strokes_are_those_of_the_svg_document);
    tcase_add_test(tests, every_failed_allocation_is_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
