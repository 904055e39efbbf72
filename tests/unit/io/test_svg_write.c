/* Drawings as SVG: the text of numbers, colours and ids, and that the reader reads the same strokes. */
#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "io/svg/svg.h"
#include "io/svg/write.h"

#include "arenas.h"

/* Two layers: an open path in two parts and a closed one in the first, a dot in the second. */
static double points[] = {10, 20, 30.5, 20.0004, 40, 20, -0.0001, 60.1239, 70, 70, 80, 70, 75, 80, 50, 50};
static struct hatch_vector_path paths[] = {{.first = 0, .count = 2, .id = 7},
                                           {.first = 2, .count = 2, .id = 7},
                                           {.first = 4, .count = 3, .id = 4, .closed = true},
                                           {.first = 7, .count = 1, .id = 7, .layer = 1}};
static const struct hatch_drawing_layer layers[] = {{"outlines", {1, 0, 0}, 0.3, NULL}, {"dots", {0, 0, 0}, 1, NULL}};
static const struct hatch_drawing drawing = {.width_mm = 100,
                                             .height_mm = 100,
                                             .paper = {1, 1, 1},
                                             .layer_count = 2,
                                             .layers = layers,
                                             .paths = {.count = 4, .paths = paths, .points = points}};

START_TEST(a_drawing_is_written_as_layers_of_paths)
{
    static const char want[] =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
        "width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\" "
        "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" style=\"background:#ffffff\">\n"
        "<g id=\"outlines\" inkscape:groupmode=\"layer\" inkscape:label=\"outlines\" stroke=\"#ff0000\" "
        "stroke-width=\"0.3\">\n"
        "<path id=\"outlines-7\" d=\"M10 20L30.5 20\"/>\n"
        "<path id=\"outlines-7-2\" d=\"M40 20L0 60.124\"/>\n"
        "<path id=\"outlines-4\" d=\"M70 70L80 70 75 80Z\"/>\n"
        "</g>\n"
        "<g id=\"dots\" inkscape:groupmode=\"layer\" inkscape:label=\"dots\" stroke=\"#000000\" stroke-width=\"1\">\n"
        "<path id=\"dots-7\" d=\"M50 50h0\"/>\n"
        "</g>\n"
        "</svg>\n";
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_svg_write(&drawing, &scratch, &file, &err), &err);
    ck_assert_uint_eq(file.size, sizeof want - 1);
    ck_assert_mem_eq(file.data, want, sizeof want - 1);
}
END_TEST

START_TEST(the_reader_reads_the_strokes_of_a_drawing)
{
    struct hatch_buffer file = {.arena = &keep};
    struct hatch_stroke_list strokes;
    struct hatch_svg_notes notes;
    HATCH_TEST_OK(hatch_svg_write(&drawing, &scratch, &file, &err), &err);
    const struct hatch_bytes bytes = {file.data, file.size};
    HATCH_TEST_OK(hatch_svg_read(bytes, 200, &keep, &scratch, &strokes, &notes, &err), &err);
    ck_assert_uint_eq(strokes.count, 4);
    ck_assert_uint_eq(notes.fills + notes.others, 0);
    ck_assert_float_eq_tol(strokes.items[0].width_px, 0.6f, 1e-5f);
    ck_assert_float_eq_tol(strokes.items[0].length, 0.205f, 1e-5f);
    ck_assert_float_eq_tol(strokes.items[3].x, 0.5f, 1e-6f);
}
END_TEST

static enum hatch_status write_all(void *context, struct hatch_arena *to, struct hatch_arena *work,
                                   struct hatch_err *why)
{
    struct hatch_buffer file = {.arena = to};
    return hatch_svg_write(context, work, &file, why);
}

START_TEST(every_failed_allocation_is_reported)
{
    struct hatch_drawing copy = drawing;
    hatch_test_fail_alloc(write_all, &copy, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io svg write");
    TCase *tests = tcase_create("write");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_drawing_is_written_as_layers_of_paths);
    tcase_add_test(tests, the_reader_reads_the_strokes_of_a_drawing);
    tcase_add_test(tests, every_failed_allocation_is_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
