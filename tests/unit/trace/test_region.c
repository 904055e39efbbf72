/* Regions of the ground: everything within a distance of some windows, and hardly more. */
#include "field_make.h"
#include "trace/region.h"

static struct hatch_trace_ground lay_out(const struct field_case *field)
{
    struct hatch_trace_ground ground;
    HATCH_TEST_OK(hatch_trace_lay_out(&field->surface, &field->frames, field->direction, 0, PI, &keep, &ground, &err),
                  &err);
    return ground;
}

static struct hatch_trace_region around(const struct hatch_trace_ground *ground,
                                        const struct hatch_trace_window *window, double distance)
{
    struct hatch_trace_region region;
    HATCH_TEST_OK(hatch_trace_region_around(ground, window, 1, distance, &keep, &scratch, &region, &err), &err);
    for (uint32_t i = 0; i < region.count; i++) {
        ck_assert_uint_eq(region.of_face[region.windows[i].face], i);
        ck_assert(i == 0 || region.windows[i].face > region.windows[i - 1].face);
    }
    return region;
}

static void check_window(const struct hatch_trace_window *window, const struct hatch_trace_window *want)
{
    ck_assert_uint_eq(window->face, want->face);
    ck_assert_mem_eq(window->low, want->low, sizeof want->low);
    ck_assert_mem_eq(window->high, want->high, sizeof want->high);
}

/* A window at a place of a face. */
static struct hatch_trace_window window_at(uint32_t face, double x, double y, double half)
{
    return (struct hatch_trace_window){face, {x - half, y - half}, {x + half, y + half}};
}

/* On a plane, checks places of all faces: those within the distance of the window are in the region, for all ways from
 * side to side, and those farther than some times the distance are not. */
static void check_plane(uint32_t faces, float jitter, double distance)
{
    struct field_case plane = case_of_shape(HATCH_SHAPE_PLANE, faces, jitter);
    set_direction(&plane, 1, 0, 0);
    struct hatch_trace_ground ground = lay_out(&plane);
    double scale = plane.surface.components[0].scale;
    const struct hatch_trace_face *first = &ground.faces[plane.surface.face_count / 2];
    double x = ((double)first->x1 + (double)first->x2) / 3, y = (double)first->y2 / 3, middle[3];
    const struct hatch_trace_window window = window_at(plane.surface.face_count / 2, x, y, 0);
    struct hatch_trace_region region = around(&ground, &window, distance / scale);
    uint32_t inside = 0, beyond = 0;
    hatch_trace_position(&ground.poses[window.face], x, y, middle);
    for (uint32_t f = 0; f < plane.surface.face_count; f++)
        for (int i = 0; i < 64; i++) {
            double a = (i % 8 + 0.5) / 8, b = (i / 8 + 0.5) / 8 * (1 - a), at[3];
            const struct hatch_trace_face *face = &ground.faces[f];
            struct hatch_trace_place place = {
                f, a * (double)face->x1 + b * (double)face->x2, b * (double)face->y2, {1, 0}};
            hatch_trace_position(&ground.poses[f], place.x, place.y, at);
            double away = hatch_vec_distance(at, middle) * scale;
            bool has = hatch_trace_region_has(&region, &place);
            inside += away < distance / HATCH_TRACE_DETOUR;
            ck_assert_msg(has || away > distance / HATCH_TRACE_DETOUR, "%g of %g is left out", away, distance);
            beyond += away > 1.6 * distance;
            ck_assert_msg(!has || away < 1.6 * distance, "%g of %g is in", away, distance);
        }
    ck_assert_uint_gt(inside, 10);
    ck_assert_uint_gt(beyond, 10);
}

START_TEST(a_region_has_what_is_within_its_distance)
{
    check_plane(2, 0, 0.6);
    check_plane(200, 0.5f, 0.6);
    check_plane(200, 0.5f, 0.3);
    check_plane(5000, 0.5f, 0.4);
}
END_TEST

START_TEST(a_distance_of_zero_gives_the_windows)
{
    struct field_case plane = case_of_shape(HATCH_SHAPE_PLANE, 2, 0);
    set_direction(&plane, 1, 0, 0);
    struct hatch_trace_ground ground = lay_out(&plane);
    const struct hatch_trace_window window = window_at(0, (double)ground.faces[0].x1 / 2, 0.2, 0.1);
    struct hatch_trace_region region = around(&ground, &window, 0);
    ck_assert_uint_eq(region.count, 1);
    check_window(&region.windows[0], &window);
    ck_assert_uint_eq(region.of_face[1], HATCH_NO_SIDE);
}
END_TEST

START_TEST(lines_are_clipped_to_windows)
{
    const struct hatch_trace_window window = {0, {1, 2}, {3, 4}};
    double share[2];
    ck_assert(hatch_trace_window_clip(&window, (double[2]){0, 3}, (double[2]){4, 3}, share));
    ck_assert_double_eq_tol(share[0], 0.25, 1e-15);
    ck_assert_double_eq_tol(share[1], 0.75, 1e-15);
    ck_assert(hatch_trace_window_clip(&window, (double[2]){2, 3}, (double[2]){2, 2.5}, share));
    ck_assert_double_eq(share[0], 0);
    ck_assert_double_eq(share[1], 1);
    ck_assert(!hatch_trace_window_clip(&window, (double[2]){0, 5}, (double[2]){4, 5}, share));
    ck_assert(!hatch_trace_window_clip(&window, (double[2]){0, 3}, (double[2]){0, 4}, share));
    ck_assert(!hatch_trace_window_clip(&window, (double[2]){0, 2.9}, (double[2]){1.5, 4.6}, share)); /* past a corner */
}
END_TEST

START_TEST(large_distances_give_everything)
{
    struct field_case ring = case_of_shape(HATCH_SHAPE_TORUS, 400, 0);
    set_direction(&ring, 0, 0, 1);
    struct hatch_trace_ground ground = lay_out(&ring);
    const struct hatch_trace_window window = hatch_trace_window_of(&ground, 0);
    struct hatch_trace_region region = around(&ground, &window, 1000);
    ck_assert_uint_eq(region.count, ring.surface.face_count);
    for (uint32_t i = 0; i < region.count; i++) {
        const struct hatch_trace_window whole = hatch_trace_window_of(&ground, i);
        check_window(&region.windows[i], &whole);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace region");
    TCase *tests = tcase_create("region");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_region_has_what_is_within_its_distance);
    tcase_add_test(tests, a_distance_of_zero_gives_the_windows);
    tcase_add_test(tests, lines_are_clipped_to_windows);
    tcase_add_test(tests, large_distances_give_everything);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
