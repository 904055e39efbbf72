/* Images that the plugin would read are refused by the size in their header, before the plugin is opened. */
#include <string.h>

#include "arenas.h"
#include "io/foreign/foreign.h"

#define BMP_BYTES 26
#define SIDE_MAX (1u << 24)

/* Reads the header of a BMP file, with an arena of some bytes and without a plugin. */
static enum hatch_status read_bmp(uint32_t width, uint32_t height, size_t limit_bytes)
{
    uint8_t file[BMP_BYTES] = {'B', 'M', [14] = 40};
    struct hatch_arena arena;
    struct hatch_image image;
    for (int i = 0; i < 4; i++) {
        file[18 + i] = (uint8_t)(width >> (8 * i));
        file[22 + i] = (uint8_t)(height >> (8 * i));
    }
    hatch_arena_init(&arena, limit_bytes);
    enum hatch_status status = hatch_image_read_any((struct hatch_bytes){file, sizeof file}, "a.bmp", "/none/plugin.so",
                                                    &arena, &scratch, &image, &err);
    hatch_arena_free(&arena);
    return status;
}

static bool needs_plugin(void)
{
    return strstr(err.text, "/none/plugin.so") != NULL;
}

/* The fewest bytes that an image may need are one float per pixel. */
START_TEST(an_image_beyond_the_memory_is_refused)
{
    static const uint32_t sizes[][2] = {{1, 1}, {7, 5}, {640, 480}, {SIDE_MAX, 1}, {1, SIDE_MAX}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        size_t bytes = (size_t)sizes[i][0] * sizes[i][1] * sizeof(float);
        ck_assert_int_eq(read_bmp(sizes[i][0], sizes[i][1], bytes), HATCH_BAD_INPUT);
        ck_assert(needs_plugin());
        ck_assert_int_eq(read_bmp(sizes[i][0], sizes[i][1], bytes - 1), HATCH_LIMIT);
        ck_assert(!needs_plugin());
    }
}
END_TEST

START_TEST(an_image_with_a_huge_side_is_refused)
{
    for (int turned = 0; turned < 2; turned++) {
        uint32_t side = SIDE_MAX + 1;
        ck_assert_int_eq(read_bmp(turned ? 1 : side, turned ? side : 1, (size_t)1 << 30), HATCH_LIMIT);
    }
}
END_TEST

START_TEST(rows_may_run_from_the_top_down)
{
    ck_assert_int_eq(read_bmp(4, (uint32_t)-4, 64), HATCH_BAD_INPUT);
    ck_assert(needs_plugin());
    ck_assert_int_eq(read_bmp(4, (uint32_t)-4, 63), HATCH_LIMIT);
}
END_TEST

START_TEST(an_image_has_four_bytes_at_least)
{
    for (size_t size = 3; size <= 4; size++) {
        struct hatch_image image;
        ck_assert_int_eq(hatch_image_read_any((struct hatch_bytes){(const uint8_t *)"none", size}, "a.bmp",
                                              "/none/plugin.so", &keep, &scratch, &image, &err),
                         HATCH_BAD_INPUT);
        ck_assert_int_eq(needs_plugin(), size == 4);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io foreign");
    TCase *tests = tcase_create("foreign");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, an_image_beyond_the_memory_is_refused);
    tcase_add_test(tests, an_image_with_a_huge_side_is_refused);
    tcase_add_test(tests, rows_may_run_from_the_top_down);
    tcase_add_test(tests, an_image_has_four_bytes_at_least);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
