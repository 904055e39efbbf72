/* The small picture of depths tells hidden polygons from those that may be seen. */
#include "arenas.h"
#include "trace/finer/depths.h"

#define SIZE 32

static struct hatch_depths make(void)
{
    struct hatch_depths depths;
    HATCH_TEST_OK(hatch_depths_make(SIZE, SIZE, &keep, &depths, &err), &err);
    return depths;
}

/* A rectangle whose nearness changes by `slope` per pixel in x. */
struct rectangle {
    double x0, y0, x1, y1, near, slope;
};

static void corners_of(const struct rectangle *of, struct hatch_depths_corner corners[4])
{
    const double x[4] = {of->x0, of->x1, of->x1, of->x0}, y[4] = {of->y0, of->y0, of->y1, of->y1};
    for (int i = 0; i < 4; i++)
        corners[i] = (struct hatch_depths_corner){x[i], y[i], of->near + of->slope * (x[i] - of->x0)};
}

static void draw(struct hatch_depths *depths, const struct rectangle *of)
{
    struct hatch_depths_corner corners[4];
    corners_of(of, corners);
    hatch_depths_draw(depths, corners, 4);
}

static bool show(const struct hatch_depths *depths, const struct rectangle *of)
{
    struct hatch_depths_corner corners[4];
    corners_of(of, corners);
    return hatch_depths_show(depths, corners, 4);
}

START_TEST(pixels_hold_the_nearness_of_their_centres)
{
    struct hatch_depths depths = make();
    const struct rectangle tilted = {4, 8, 12, 20, 1, 0.25};
    draw(&depths, &tilted);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            float near = depths.near[y * SIZE + x];
            if (x >= 4 && x < 12 && y >= 8 && y < 20)
                ck_assert_float_eq_tol(near, 1 + 0.25f * ((float)x + 0.5f - 4), 1e-5f);
            else
                ck_assert_float_eq(near, -HUGE_VALF);
        }
}
END_TEST

/* Also where a polygon goes on beyond the picture. */
START_TEST(a_polygon_covers_the_picture_up_to_its_borders)
{
    for (int beyond = 0; beyond < 2; beyond++) {
        struct hatch_depths depths = make();
        draw(&depths, &(struct rectangle){-beyond, -beyond, SIZE + beyond, SIZE + beyond, 1, 0});
        for (int i = 0; i < SIZE * SIZE; i++)
            ck_assert_float_eq(depths.near[i], 1);
    }
}
END_TEST

START_TEST(the_nearest_counts_in_any_order)
{
    const struct rectangle front = {4, 4, 20, 20, 2, 0}, back = {8, 8, 28, 28, 1, 0};
    for (int order = 0; order < 2; order++) {
        struct hatch_depths depths = make();
        draw(&depths, order ? &front : &back);
        draw(&depths, order ? &back : &front);
        ck_assert_float_eq(depths.near[10 * SIZE + 10], 2);
        ck_assert_float_eq(depths.near[24 * SIZE + 24], 1);
    }
}
END_TEST

START_TEST(what_is_behind_is_hidden)
{
    struct hatch_depths depths = make();
    const struct rectangle wall = {4, 4, 28, 28, 2, 0};
    draw(&depths, &wall);
    ck_assert(show(&depths, &wall));
    ck_assert(!show(&depths, &(struct rectangle){8, 8, 20, 20, 1, 0}));
    ck_assert(show(&depths, &(struct rectangle){8, 8, 20, 20, 1.999, 0})); /* as near, but for rounding */
    ck_assert(show(&depths, &(struct rectangle){8, 8, 20, 20, 3, 0}));
    ck_assert(show(&depths, &(struct rectangle){8, 8, 30, 20, 1, 0}));        /* it comes out at the side, */
    ck_assert(show(&depths, &(struct rectangle){8, 8, 20, 20, 1, 0.1}));      /* and at the front */
    ck_assert(show(&depths, &(struct rectangle){2, 8, 30, 20, 1, 0}));        /* its middle is hidden */
    ck_assert(!show(&depths, &(struct rectangle){8.1, 8.1, 8.2, 8.2, 1, 0})); /* smaller than a pixel */
    ck_assert(show(&depths, &(struct rectangle){4.1, 8.1, 4.2, 8.2, 1, 0}));  /* next to the wall's side */
}
END_TEST

START_TEST(a_hole_shows_what_is_behind)
{
    struct hatch_depths depths = make();
    const struct rectangle walls[4] = {
        {0, 0, 32, 12, 2, 0}, {0, 20, 32, 32, 2, 0}, {0, 12, 12, 20, 2, 0}, {20, 12, 32, 20, 2, 0}};
    for (int i = 0; i < 4; i++)
        draw(&depths, &walls[i]);
    ck_assert(show(&depths, &(struct rectangle){2, 2, 30, 30, 1, 0}));
    draw(&depths, &(struct rectangle){12, 12, 20, 20, 2, 0});
    ck_assert(!show(&depths, &(struct rectangle){2, 2, 30, 30, 1, 0}));
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace depths");
    TCase *tests = tcase_create("depths");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, pixels_hold_the_nearness_of_their_centres);
    tcase_add_test(tests, a_polygon_covers_the_picture_up_to_its_borders);
    tcase_add_test(tests, the_nearest_counts_in_any_order);
    tcase_add_test(tests, what_is_behind_is_hidden);
    tcase_add_test(tests, a_hole_shows_what_is_behind);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
