/* Drawings as stroke scripts: the reader finds each path where it lies on the page, and as wide as its pen. */
#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "io/script/write.h"
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
    ck_assert_float_eq(list.items[0].rgb[0], 0.25f);
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
    tcase_add_test(tests, every_failed_allocation_is_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
