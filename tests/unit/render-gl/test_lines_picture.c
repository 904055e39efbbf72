/* Feature lines in pictures: width, hidden parts, tiles. Surfaces are as white as the paper, so that all ink belongs to
 * lines. */
#include "lines.h"
#include "render_frame.h"

#define CREASE_RAD 0.7

static struct test_frame frame;
static struct line_overlay lines;

static void begin_frame(void)
{
    begin();
    frame_arenas(&frame);
}

static void end_frame(void)
{
    line_overlay_free(&lines);
    frame_finish(&frame);
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}

/* Opens the mesh as the unit scene, with lines. */
static void show(const struct hatch_mesh *mesh, uint32_t kinds, double width_px)
{
    const struct line_overlay_style style = {.lines = {.kinds = kinds, .width_px = width_px, .crease_rad = CREASE_RAD}};
    frame_open(mesh, &frame_unit, NULL, &frame);
    frame.shown.style.curve.high = 0;
    HATCH_TEST_OK(line_overlay_make(&lines, &frame.on_gpu, &style, &frame.shown.programs, &frame.args, &frame.err),
                  &frame.err);
    frame.lines = &lines;
}

/* Draws a picture of 400 x 400 pixels and returns its ink.
 *   target_px  size of the tiles in which it is drawn */
static struct hatch_image draw(const struct hatch_view *view, uint32_t target_px, uint32_t side)
{
    const struct picture picture = frame_picture(&frame, "gouraud");
    struct hatch_image image;
    struct canvas canvas;
    HATCH_TEST_OK(hatch_image_make(&keep, 400, 400, "RGB", &image, &err), &err);
    HATCH_TEST_OK(canvas_make(target_px, target_px, side, &frame.shown.programs, &canvas, &err), &err);
    HATCH_TEST_OK(picture_draw(&picture, view, &canvas, &image, &err), &err);
    canvas_free(&canvas);
    for (uint32_t i = 0; i < 3 * 400 * 400; i++)
        image.pixels[i] = 1 - image.pixels[i];
    return image;
}

static double ink_at(const struct hatch_image *image, double x, double y)
{
    long column = lround(x - 0.5), row = 399 - lround(y - 0.5);
    return column < 0 || column > 399 || row < 0 || row > 399 ? 0.0 : (double)image->pixels[3 * (400 * row + column)];
}

static double ink_of(const struct hatch_image *image)
{
    double sum = 0;
    for (size_t i = 0; i < 400 * 400; i++)
        sum += (double)image->pixels[3 * i];
    return sum;
}

static void pixel_of(const struct hatch_view *view, const double point[3], double out[2])
{
    double from[3], depth = view->orthographic ? 1 : hatch_line_depth(view, point);
    hatch_vec_sub(point, view->eye, from);
    out[0] = 200 + 200 * hatch_vec_dot(from, view->right) / (depth * view->half_height);
    out[1] = 200 + 200 * hatch_vec_dot(from, view->up) / (depth * view->half_height);
}

static double pixels_between(const struct hatch_view *view, const double a[3], const double b[3])
{
    double p[2], q[2];
    pixel_of(view, a, p);
    pixel_of(view, b, q);
    return hypot(q[0] - p[0], q[1] - p[1]);
}

START_TEST(ink_is_width_times_length)
{
    static const double widths_px[] = {0.5, 1, 1.6, 2, 3, 7};
    static const double corners[5][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}};
    const double width_px = widths_px[_i];
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 50);
    show(&plane, HATCH_LINES_ALL, width_px);
    for (int turn = 0; turn < 4; turn++) {
        struct hatch_view view = view_from(0.4 * turn, -0.3 * turn, 4, turn % 2);
        struct hatch_image image = draw(&view, 400, 1 + (uint32_t)turn % 2);
        double length = 0;
        for (int i = 0; i < 4; i++)
            length += pixels_between(&view, corners[i], corners[i + 1]);
        ck_assert_double_eq_tol(ink_of(&image) / (width_px * length), 1, 0.03);
    }
}
END_TEST

START_TEST(nine_edges_of_a_cube_are_visible)
{
    struct hatch_mesh mesh = cube(-1, 1);
    struct hatch_view view = view_from(7, 5, 6, false);
    double length = 0;
    show(&mesh, HATCH_LINES_ALL, 2);
    struct hatch_image image = draw(&view, 400, 2);
    for (int a = 0; a < 8; a++)
        for (int k = 0; k < 3; k++) {
            int b = a | 1 << k;
            if (a == b || a == 0) /* corner 0 is behind: its three edges are hidden */
                continue;
            double p[3], q[3];
            for (int i = 0; i < 3; i++) {
                p[i] = a >> i & 1 ? 1 : -1;
                q[i] = b >> i & 1 ? 1 : -1;
            }
            length += pixels_between(&view, p, q);
        }
    ck_assert_double_eq_tol(ink_of(&image) / (2 * length), 1, 0.03);
}
END_TEST

/* Marks the connected component of ink at a pixel. */
static void flood(const struct hatch_image *image, uint8_t *seen, size_t start)
{
    static size_t stack[400 * 400];
    size_t count = 0;
    stack[count++] = start;
    seen[start] = 1;
    while (count) {
        size_t at = stack[--count];
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                long column = (long)(at % 400) + x, row = (long)(at / 400) + y;
                size_t next = (size_t)(400 * row + column);
                if (column < 0 || column > 399 || row < 0 || row > 399 || seen[next] || image->pixels[3 * next] < 0.02f)
                    continue;
                seen[next] = 1;
                stack[count++] = next;
            }
    }
}

/* The faces lie inside the sphere: those of 200 by up to 4.5 pixels. */
START_TEST(a_sphere_has_one_even_outline)
{
    static const double inside_px[] = {4.5, 0.5, 0.3};
    static uint8_t seen[400 * 400];
    static const uint32_t faces[] = {200, 2000, 60000};
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_SPHERE, faces[_i]);
    struct hatch_view view = view_from(1, 2, 3, false);
    double d = hatch_vec_length(view.eye), radius = 200 / view.half_height / sqrt(d * d - 1);
    show(&mesh, HATCH_LINES_ALL, 2);
    struct hatch_image image = draw(&view, 400, 1);
    uint32_t parts = 0;
    for (size_t i = 0; i < 400 * 400; i++) {
        if (image.pixels[3 * i] < 0.02f)
            continue;
        double from = hypot((double)(i % 400) - 199.5, (double)(i / 400) - 199.5);
        ck_assert_double_le(from, radius + 1.75 + 0.3);
        ck_assert_double_ge(from, radius - 1.75 - inside_px[_i]);
        if (!seen[i]) {
            flood(&image, seen, i);
            parts++;
        }
    }
    ck_assert_uint_eq(parts, 1);
    ck_assert_double_eq_tol(ink_of(&image) / (2 * 2 * 3.14159265 * radius), 1, 0.03);
}
END_TEST

/* Whether the torus hides a point on it from the eye. */
static bool torus_hides(const struct hatch_view *view, const double point[3])
{
    double way[3];
    hatch_vec_sub(view->eye, point, way);
    for (double t = 0; t < 0.6; t += 2e-4) {
        double p[3];
        hatch_vec_add_scaled(point, t, way, p);
        if (hypot(hypot(p[0], p[2]) - 1, p[1]) < 0.4 - 2e-3)
            return true;
    }
    return false;
}

/* Visible points of the silhouette have ink, hidden ones have none. */
START_TEST(hidden_parts_of_a_torus_are_left_out)
{
    static double at[4000][2];
    static bool hidden[4000];
    static const double eyes[][3] = {{1, 1.6, 4}, {0.4, 1.2, 4}, {4, 0.7, 1}};
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_TORUS, 20000);
    show(&mesh, HATCH_LINES_ALL, 2);
    struct hatch_view view = view_from(eyes[_i][0], eyes[_i][1], eyes[_i][2], false);
    struct hatch_image image = draw(&view, 400, 2);
    struct hatch_line_mesh traced = lines_of(&mesh, HATCH_LINES_SILHOUETTES, CREASE_RAD);
    struct hatch_line_shape shape = shape_in_place(&traced);
    struct hatch_line_trace trace = silhouettes_of(&shape, &view);
    uint32_t counts[2] = {0, 0};
    ck_assert_uint_lt(trace.node_count, 4000);
    for (uint32_t i = 0; i < trace.node_count; i++) {
        hidden[i] = torus_hides(&view, &trace.nodes[3 * i]);
        pixel_of(&view, &trace.nodes[3 * i], at[i]);
    }
    for (uint32_t i = 0; i < trace.node_count; i++) {
        bool near_other = false;
        for (uint32_t j = 0; j < trace.node_count && !near_other; j++)
            near_other = hidden[j] != hidden[i] && hypot(at[i][0] - at[j][0], at[i][1] - at[j][1]) < 8;
        if (near_other)
            continue;
        counts[hidden[i]]++;
        if (hidden[i])
            ck_assert_double_eq_tol(ink_at(&image, at[i][0], at[i][1]), 0, 1e-6);
        else
            ck_assert_double_ge(ink_at(&image, at[i][0], at[i][1]), 0.6);
    }
    ck_assert_uint_gt(counts[0], 200);
    ck_assert_uint_gt(counts[1], 15);
}
END_TEST

/* A sheet goes back under itself: the lower part is seen beyond the edge of the upper one, deeper by some pixels. */
START_TEST(silhouettes_need_a_step_of_four_pixels)
{
    static const float steps_px[2] = {1, 10};
    static const uint32_t faces[18] = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3, 4, 6, 7, 4, 7, 5};
    float drop = steps_px[_i] / 100;
    const float corners[24] = {-1,    -1, 0,     -1,    1, 0,     0.1f, -1, 0,     0.1f, 1, 0,
                               0.05f, -1, -drop, 0.05f, 1, -drop, 1,    -1, -drop, 1,    1, -drop};
    struct hatch_mesh mesh = mesh_of(corners, 8, faces, 6);
    struct hatch_view view = view_from(0, 0, 4, true);
    show(&mesh, HATCH_LINES_SILHOUETTES, 2);
    struct hatch_image image = draw(&view, 400, 2);
    ck_assert_double_eq_tol(ink_of(&image), _i ? 400 : 0, 8);
}
END_TEST

/* Draws one picture as a whole and in tiles of several sizes. */
START_TEST(tiles_have_no_seams)
{
    static const uint32_t tiles_px[] = {130, 201, 399};
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_TEAPOT, 6000);
    struct hatch_view view = view_from(2, 2.5, 5, false);
    show(&mesh, HATCH_LINES_ALL, 3);
    struct hatch_image one = draw(&view, 400, 2);
    for (int k = 0; k < 3; k++) {
        struct hatch_image tiled = draw(&view, tiles_px[k], 2);
        for (uint32_t i = 0; i < 3 * 400 * 400; i++)
            ck_assert_float_eq_tol(one.pixels[i], tiled.pixels[i], 0.01f);
    }
    ck_assert_double_gt(ink_of(&one), 2000);
}
END_TEST

/* A ridge along x, of which two plates before it leave a part in sight. It is too short for a line 24 pixels wide if it
 * is shorter than 6 + 2 * 24 pixels, also in tiles that end within it. Plates have no creases. */
START_TEST(tiles_agree_on_short_parts_of_wide_lines)
{
    static const float ends_px[2][2] = {{143, 191.5f}, {133, 197}};
    static const uint32_t faces[24] = {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4, 6, 7, 9, 6, 9, 8, 10, 11, 13, 10, 13, 12};
    const float left = ends_px[_i][0] / 100 - 2, right = ends_px[_i][1] / 100 - 2;
    const float corners[42] = {-2,   -1, -1, 2,  -1, -1, -2,   0, 0, 2,     0,  0, -2, 1,  -1, 2,     1, -1, -2, -1, 1,
                               left, -1, 1,  -2, 1,  1,  left, 1, 1, right, -1, 1, 2,  -1, 1,  right, 1, 1,  2,  1,  1};
    struct hatch_mesh mesh = mesh_of(corners, 14, faces, 8);
    struct hatch_view view = view_from(0, 0, 4, true);
    show(&mesh, HATCH_LINES_CREASES, 24);
    struct hatch_image one = draw(&view, 400, 1), tiled = draw(&view, 230, 1);
    ck_assert_double_eq_tol(ink_of(&one), _i ? 64 * 24 + PI * 12 * 12 : 0, 80);
    for (uint32_t i = 0; i < 3 * 400 * 400; i++)
        ck_assert_float_eq_tol(one.pixels[i], tiled.pixels[i], 0.01f);
}
END_TEST

/* The eye lies on a vertex, inside the mesh, and in the plane of a face. Some amounts of ink are known: 0 from inside
 * the cube; 1600 for a square of 200 pixels, such as the orthographic cube, and for half of the lines around the whole
 * picture. The others were measured once, and detect lines that stray from a corner near the eye. */
START_TEST(cameras_on_or_inside_the_mesh_draw_the_right_lines)
{
    static const double eyes[][3] = {{1, 1, 1}, {0, 0, 0.2}, {1, 0, 1e-9}, {0, 1, 0}};
    static const double ink[][4] = {
        {1322, 0, 1600, 1600}, {2195, 1612, 0, 1319}, {2932, 1600, 1600, 1600}, {2062, 1749, 1587, 2511}};
    struct hatch_mesh mesh = _i % 2 ? shape_of(HATCH_SHAPE_TORUS, 3000) : cube(-1, 1);
    show(&mesh, HATCH_LINES_ALL, 2);
    for (size_t i = 0; i < 4; i++) {
        struct hatch_view view = view_from(eyes[i][0], eyes[i][1], eyes[i][2], _i / 2);
        struct hatch_image image = draw(&view, 400, 1);
        ck_assert_double_eq_tol(ink_of(&image), ink[_i][i], 0.03 * ink[_i][i] + 1);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render lines picture");
    TCase *tests = tcase_create("pictures");
    tcase_add_checked_fixture(tests, begin_frame, end_frame);
    tcase_add_loop_test(tests, ink_is_width_times_length, 0, 6);
    tcase_add_test(tests, nine_edges_of_a_cube_are_visible);
    tcase_add_loop_test(tests, a_sphere_has_one_even_outline, 0, 3);
    tcase_add_loop_test(tests, hidden_parts_of_a_torus_are_left_out, 0, 3);
    tcase_add_loop_test(tests, silhouettes_need_a_step_of_four_pixels, 0, 2);
    tcase_add_test(tests, tiles_have_no_seams);
    tcase_add_loop_test(tests, tiles_agree_on_short_parts_of_wide_lines, 0, 2);
    tcase_add_loop_test(tests, cameras_on_or_inside_the_mesh_draw_the_right_lines, 0, 4);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
