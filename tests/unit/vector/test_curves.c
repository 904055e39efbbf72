/* Visible parts of curves in closed form, pens, cleaning up, and the picture's borders. */
#include "base/random.h"
#include "fail_alloc.h"
#include "lines.h"
#include "occluders.h"
#include "views.h"

#define PIXEL (2 / SIDE_PX) /* size of a pixel of view_facing */

/* A square with half side `half` in the plane z, facing +z, with its middle at (x, 0). */
static struct hatch_mesh square(double half, double x, double z)
{
    const float positions[12] = {(float)(x - half), (float)-half, (float)z, (float)(x + half), (float)-half, (float)z,
                                 (float)(x + half), (float)half,  (float)z, (float)(x - half), (float)half,  (float)z};
    return mesh_of(positions, 4, (const uint32_t[]){0, 1, 2, 0, 2, 3}, 2);
}

static struct hatch_vector_paths visible, hidden;

static void see_points(const double *points, uint32_t count, bool closed)
{
    struct hatch_vector_curve *curve = HATCH_NEW(&keep, struct hatch_vector_curve, 1, &err);
    *curve = (struct hatch_vector_curve){.count = count, .layer = 3, .id = 9, .closed = closed};
    const struct hatch_vector_curves curves = {.count = 1, .curves = curve, .points = points};
    see(&curves, &visible, &hidden);
}

static double total(const struct hatch_vector_paths *paths)
{
    double length = 0;
    for (uint32_t i = 0; i < paths->count; i++)
        length += hatch_vector_length(paths, &paths->paths[i]);
    return length;
}

START_TEST(a_line_ends_exactly_where_a_square_hides_it)
{
    struct hatch_mesh front = square(0.3, 0, 0.5);
    hide_behind(&front, &view_facing);
    see_points((const double[]){-0.8, 0.1, 0, 0.7, 0.1, 0}, 2, false);
    ck_assert_uint_eq(visible.count, 2);
    ck_assert_uint_eq(hidden.count, 1);
    ck_assert_uint_eq(visible.paths[1].layer, 3);
    ck_assert_uint_eq(visible.paths[1].id, 9);
    static const double want[4] = {-0.8, -0.3, 0.3, 0.7};
    for (uint32_t i = 0; i < 4; i++) {
        const double *at = hatch_vector_point(&visible, &visible.paths[i / 2], i % 2);
        ck_assert_double_eq_tol(at[0], (want[i] + 1) / PIXEL, 1e-4);
        ck_assert_double_eq_tol(at[1], 1.1 / PIXEL, 1e-9);
    }
}
END_TEST

/* Through a square at 45 degrees the line enters in the middle. */
START_TEST(a_line_is_cut_where_it_passes_through_a_face)
{
    struct hatch_mesh face = square(0.5, 0, 0);
    hide_behind(&face, &view_facing);
    see_points((const double[]){-0.4, 0, 0.4, 0.4, 0, -0.4}, 2, false);
    ck_assert_uint_eq(visible.count, 1);
    ck_assert_double_eq_tol(total(&visible), 0.4 / PIXEL, 1e-4);
    ck_assert_double_eq_tol(total(&hidden), 0.4 / PIXEL, 1e-4);
}
END_TEST

START_TEST(a_closed_curve_with_a_hidden_part_is_one_path)
{
    struct hatch_mesh front = square(0.3, 0.5, 0.5);
    hide_behind(&front, &view_facing);
    /* A square of half side 0.4: its right side is at 0.4, behind the one whose left side is at 0.2. */
    static const double ring[] = {0.3, 0.1, 0, 0.3, 0.4, 0, -0.4, 0.4, 0, -0.4, -0.4, 0, 0.3, -0.4, 0, 0.3, 0.1, 0};
    see_points(ring, 6, true);
    ck_assert_uint_eq(visible.count, 1);
    ck_assert(!visible.paths[0].closed);
    ck_assert_uint_eq(hidden.count, 1);
    ck_assert_double_eq_tol(total(&hidden), 0.6 / PIXEL, 1e-4);
    struct hatch_mesh away = square(0.01, 0.95, 0);
    hide_behind(&away, &view_facing);
    see_points(ring, 6, true);
    ck_assert_uint_eq(visible.count, 1);
    ck_assert(visible.paths[0].closed);
    ck_assert_uint_eq(visible.paths[0].count, 5);
}
END_TEST

/* A cube with edges of 1 from a corner: 9 of its edges are visible, 3 are hidden. */
START_TEST(nine_edges_of_a_cube_are_visible)
{
    struct hatch_mesh box = cube(-0.5, 0.5);
    struct hatch_view view = view_from(3, 4, 5, true);
    double points[72], want[2] = {0, 0};
    struct hatch_vector_curve curves[12];
    uint32_t count = 0;
    for (int axis = 0; axis < 3; axis++)
        for (int corner = 0; corner < 4; corner++, count++) {
            double a[3], b[3];
            a[axis] = -0.5;
            a[(axis + 1) % 3] = corner & 1 ? 0.5 : -0.5;
            a[(axis + 2) % 3] = corner & 2 ? 0.5 : -0.5;
            hatch_vec_copy(a, b);
            b[axis] = 0.5;
            hatch_vec_copy(a, &points[6 * count]);
            hatch_vec_copy(b, &points[6 * count + 3]);
            curves[count] = (struct hatch_vector_curve){.first = 2 * count, .count = 2, .id = count};
            double slope = view.back[axis];
            want[corner == 0] += sqrt(1 - slope * slope) * 0.5 * SIDE_PX / view.half_height;
        }
    const struct hatch_vector_curves all = {.count = 12, .curves = curves, .points = points};
    hide_behind(&box, &view);
    see(&all, &visible, &hidden);
    ck_assert_uint_eq(visible.count, 9);
    ck_assert_uint_eq(hidden.count, 3);
    ck_assert_double_eq_tol(total(&visible), want[0], 1e-3);
    ck_assert_double_eq_tol(total(&hidden), want[1], 1e-3);
}
END_TEST

START_TEST(lines_end_at_the_borders_and_at_the_near_plane)
{
    struct hatch_mesh small = square(0.01, 0.9, 0);
    hide_behind(&small, &view_facing);
    see_points((const double[]){-3, 0.5, 0, 3, 0.5, 0}, 2, false);
    ck_assert_double_eq_tol(total(&visible), SIDE_PX, 1e-9);
    see_points((const double[]){-3, 2, 0, 3, 2, 0}, 2, false);
    ck_assert_uint_eq(visible.count + hidden.count, 0);
    /* The near plane is at z = 1.9. */
    see_points((const double[]){0, 0, 1.8, 0.2, 0, 2.0}, 2, false);
    ck_assert_double_eq_tol(total(&visible), 0.1 / PIXEL, 1e-6);
}
END_TEST

START_TEST(a_pen_draws_where_half_its_width_is_wanted)
{
    struct hatch_mesh small = square(0.01, 0.9, 0);
    static const struct hatch_vector_curve curve = {.count = 2};
    static const struct hatch_vector_care none = {0, 0};
    const struct hatch_vector_pen pen = {2, hatch_vector_half_width};
    const struct hatch_vector_curves curves = {.count = 1,
                                               .curves = &curve,
                                               .points = (const double[]){-0.5, 0, 0, 0.5, 0, 0},
                                               .widths_px = (const float[]){0, 4}};
    hide_behind(&small, &view_facing);
    HATCH_TEST_OK(hatch_vector_see(&hiding, &curves, &pen, &none, &keep, &scratch, &visible, &hidden, &err), &err);
    ck_assert_uint_eq(visible.count, 1);
    ck_assert_uint_eq(hidden.count, 0);
    ck_assert_double_eq_tol(total(&visible), 0.75 / PIXEL, 1e-9);
}
END_TEST

/* Three bars hide parts of a line: 0.01, 0.1 and 0.01 wide, with 0.02 between the second and the third. */
START_TEST(short_gaps_are_closed_and_short_specks_dropped)
{
    static const struct hatch_vector_curve curve = {.count = 2};
    const struct hatch_vector_curves curves = {
        .count = 1, .curves = &curve, .points = (const double[]){-0.9, 0, 0, 0.9, 0, 0}};
    struct hatch_mesh bars = square(0.005, -0.5, 0.5), wide = square(0.05, 0, 0.5), last = square(0.05, 0.12, 0.5);
    bars = joined(&bars, &wide, 1, (const double[3]){0, 0, 0});
    bars = joined(&bars, &last, 1, (const double[3]){0, 0, 0});
    hide_behind(&bars, &view_facing);
    for (int clean = 0; clean < 2; clean++) {
        const struct hatch_vector_care care = {clean ? 3 : 0, clean ? 5 : 0};
        HATCH_TEST_OK(hatch_vector_see(&hiding, &curves, NULL, &care, &keep, &scratch, &visible, &hidden, &err), &err);
        ck_assert_uint_eq(visible.count, clean ? 2 : 4);
        ck_assert_uint_eq(hidden.count, clean ? 1 : 3);
        ck_assert_double_eq_tol(total(&visible) + total(&hidden), 1.8 / PIXEL, 1e-6);
    }
}
END_TEST

/* A segment that touches a surface from behind is hidden, unless it has slack or lies on the surface's face. */
START_TEST(slack_and_own_faces_keep_a_line_on_its_surface)
{
    struct hatch_mesh face = square(0.5, 0, 0);
    static const struct hatch_vector_curve curve = {.count = 2};
    struct hatch_vector_curves curves = {
        .count = 1, .curves = &curve, .points = (const double[]){-0.4, 0.1, -0.01, 0.4, 0.2, -0.01}};
    hide_behind(&face, &view_facing);
    see(&curves, &visible, &hidden);
    ck_assert_uint_eq(visible.count, 0);
    curves.slack = (const float[]){0.02f, 0.02f};
    see(&curves, &visible, &hidden);
    ck_assert_uint_eq(hidden.count, 0);
    curves.slack = (const float[]){0.02f, 0}; /* linear: over 0.01 along the first half */
    see(&curves, &visible, &hidden);
    ck_assert_double_eq_tol(total(&visible) / (total(&visible) + total(&hidden)), 0.5, 0.01);
    curves.slack = NULL;
    /* Face 1 is beside face 0 and faces the same way. */
    curves.faces = (const uint32_t[]){0, 0};
    see(&curves, &visible, &hidden);
    ck_assert_uint_eq(hidden.count, 0);
    curves.slack = (const float[]){-1, 0};
    see(&curves, &visible, &hidden);
    ck_assert_uint_eq(visible.count, 0);
}
END_TEST

/* The face hides the middle of a line, of which a part on each side is blank: it is neither visible nor hidden. The
 * blank part goes on behind the face, where it is hidden as the rest is. */
START_TEST(a_blank_part_is_neither_visible_nor_hidden)
{
    struct hatch_mesh face = square(0.5, 0, 0.1);
    static const struct hatch_vector_curve curve = {.count = 5};
    static const bool blank[] = {false, true, false, true, false};
    struct hatch_vector_curves curves = {.count = 1,
                                         .curves = &curve,
                                         .points =
                                             (const double[]){-0.9, 0, 0, -0.8, 0, 0, -0.3, 0, 0, 0.6, 0, 0, 0.7, 0, 0},
                                         .blank = blank};
    hide_behind(&face, &view_facing);
    see(&curves, &visible, &hidden);
    ck_assert_uint_eq(visible.count, 2);
    ck_assert_double_eq_tol(total(&visible), (0.1 + 0.1) / PIXEL, 1e-6);
    ck_assert_uint_eq(hidden.count, 1);
    ck_assert_double_eq_tol(total(&hidden), 1 / PIXEL, 1e-6);
    const struct hatch_vector_care care = {0, 0};
    HATCH_TEST_OK(hatch_vector_see(&hiding, &curves, NULL, &care, &keep, &scratch, &visible, NULL, &err), &err);
    ck_assert_double_eq_tol(total(&visible), (0.1 + 0.1) / PIXEL, 1e-6);
}
END_TEST

/* A square, of which a face hides the left half, is blank on the right. None of it is visible, and what is hidden is no
 * closed path: it ends where the blank part begins, which is in the middle of the list of pieces or at its end. */
START_TEST(a_blank_part_opens_a_closed_curve)
{
    struct hatch_mesh face = square(0.5, -0.5, 0.1);
    static const double ring[][18] = {
        {-0.4, 0, 0, -0.4, 0.4, 0, 0.1, 0.4, 0, 0.1, -0.4, 0, -0.4, -0.4, 0, -0.4, 0, 0},
        {0, -0.4, 0, -0.4, -0.4, 0, -0.4, 0.4, 0, 0, 0.4, 0, 0.1, 0.4, 0, 0.1, -0.4, 0},
    };
    static const bool blanks[][6] = {{false, true, true, true, false, false}, {false, false, false, true, true, true}};
    for (int i = 0; i < 2; i++) {
        struct hatch_vector_curve curve = {.count = 6, .closed = true};
        const struct hatch_vector_curves curves = {.count = 1, .curves = &curve, .points = ring[i], .blank = blanks[i]};
        hide_behind(&face, &view_facing);
        see(&curves, &visible, &hidden);
        ck_assert_uint_eq(visible.count, 0);
        ck_assert_double_eq_tol(total(&hidden), 1.6 / PIXEL, 1e-3);
        for (uint32_t k = 0; k < hidden.count; k++)
            ck_assert(!hidden.paths[k].closed);
    }
}
END_TEST

/* A line just behind the outline of a face is visible if it may move sideways. */
START_TEST(reach_moves_a_line_past_an_outline)
{
    struct hatch_mesh face = square(0.5, 0, 0.1);
    struct hatch_vector_curve curve = {.count = 2};
    const struct hatch_vector_curves curves = {
        .count = 1, .curves = &curve, .points = (const double[]){-0.2, 0.5 - PIXEL, 0, 0.2, 0.5 - 3 * PIXEL, 0}};
    hide_behind(&face, &view_facing);
    see(&curves, &visible, &hidden);
    ck_assert_uint_eq(visible.count, 0);
    curve.reach_px = 2;
    see(&curves, &visible, &hidden);
    ck_assert_double_eq_tol(total(&visible), 0.2 / PIXEL, 0.1);
}
END_TEST

START_TEST(culled_and_cut_out_faces_hide_nothing)
{
    struct hatch_mesh face = square(0.5, 0, 0.1);
    static const double line[] = {-0.4, 0.1, 0, 0.4, 0.1, 0};
    for (int kind = 0; kind < 3; kind++) {
        hide_behind(&face, &view_facing);
        hiding_unit.items[0].double_sided = kind != 0;
        hiding_unit.items[0].mirrored = kind == 0; /* its back is visible */
        hiding_unit.items[0].cut_out = kind == 1;
        HATCH_TEST_OK(
            hatch_occluders_make(&hiding_unit, &view_facing, SIDE_PX, SIDE_PX, &keep, &scratch, &hiding, &err), &err);
        see_points(line, 2, false);
        ck_assert_uint_eq(hidden.count, kind == 2 ? 1 : 0);
    }
}
END_TEST

/* Paths are the same to the last bit whatever the order of the faces. */
START_TEST(the_order_of_faces_does_not_matter)
{
    struct hatch_mesh torus = bare_shape(HATCH_SHAPE_TORUS, 3000), turned = torus;
    struct hatch_view view = view_from(1, 2, 3, false);
    struct hatch_vector_curve curves[40];
    struct hatch_vector_paths first;
    double points[6 * 40];
    for (uint32_t i = 0; i < 40; i++) {
        curves[i] = (struct hatch_vector_curve){.first = 2 * i, .count = 2, .id = i};
        for (uint32_t k = 0; k < 6; k++)
            points[6 * i + k] = 2 * (double)hatch_random_unit(1, i, k) - 1;
    }
    const struct hatch_vector_curves all = {.count = 40, .curves = curves, .points = points};
    hide_behind(&torus, &view);
    see(&all, &first, &hidden);
    turned.indices = HATCH_NEW(&keep, uint32_t, 3 * (size_t)torus.face_count, &err);
    for (uint32_t f = 0; f < torus.face_count; f++)
        memcpy(&turned.indices[3 * f], &torus.indices[3 * (torus.face_count - 1 - f)], 3 * sizeof *turned.indices);
    hide_behind(&turned, &view);
    see(&all, &visible, &hidden);
    ck_assert_uint_gt(hidden.count, 5);
    ck_assert_uint_eq(visible.count, first.count);
    for (uint32_t i = 0; i < first.count; i++) { /* their padding may differ */
        ck_assert_uint_eq(visible.paths[i].first, first.paths[i].first);
        ck_assert_uint_eq(visible.paths[i].count, first.paths[i].count);
        ck_assert_uint_eq(visible.paths[i].layer, first.paths[i].layer);
        ck_assert_uint_eq(visible.paths[i].id, first.paths[i].id);
        ck_assert(visible.paths[i].closed == first.paths[i].closed);
    }
    ck_assert_mem_eq(visible.points, first.points, 4 * first.count * sizeof *first.points);
}
END_TEST

static enum hatch_status see_all(void *context, struct hatch_arena *to, struct hatch_arena *work, struct hatch_err *why)
{
    static const struct hatch_vector_curve curve = {.count = 2};
    static const struct hatch_vector_care none = {0, 0};
    const struct hatch_vector_curves curves = {
        .count = 1, .curves = &curve, .points = (const double[]){-0.9, 0, -0.9, 0.9, 0, -0.9}};
    struct hatch_vector_paths *outputs = context;
    struct hatch_occluders occluders;
    HATCH_TRY(hatch_occluders_make(&hiding_unit, &view_facing, SIDE_PX, SIDE_PX, to, work, &occluders, why));
    return hatch_vector_see(&occluders, &curves, NULL, &none, to, work, &outputs[0], &outputs[1], why);
}

START_TEST(every_failed_allocation_is_reported)
{
    struct hatch_mesh box = cube(-0.5, 0.5);
    struct hatch_vector_paths outputs[2] = {{0}, {0}};
    hide_behind(&box, &view_facing);
    hatch_test_fail_alloc(see_all, outputs, outputs, sizeof outputs);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("vector curves");
    TCase *tests = tcase_create("curves");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_line_ends_exactly_where_a_square_hides_it);
    tcase_add_test(tests, a_line_is_cut_where_it_passes_through_a_face);
    tcase_add_test(tests, a_closed_curve_with_a_hidden_part_is_one_path);
    tcase_add_test(tests, nine_edges_of_a_cube_are_visible);
    tcase_add_test(tests, lines_end_at_the_borders_and_at_the_near_plane);
    tcase_add_test(tests, a_pen_draws_where_half_its_width_is_wanted);
    tcase_add_test(tests, short_gaps_are_closed_and_short_specks_dropped);
    tcase_add_test(tests, slack_and_own_faces_keep_a_line_on_its_surface);
    tcase_add_test(tests, a_blank_part_is_neither_visible_nor_hidden);
    tcase_add_test(tests, a_blank_part_opens_a_closed_curve);
    tcase_add_test(tests, reach_moves_a_line_past_an_outline);
    tcase_add_test(tests, culled_and_cut_out_faces_hide_nothing);
    tcase_add_test(tests, the_order_of_faces_does_not_matter);
    tcase_add_test(tests, every_failed_allocation_is_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
