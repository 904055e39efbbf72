/* Haloes have the given width on surfaces behind an edge, and a single surface has none, however oblique it is.
 * Surfaces are black here, so that white pixels are haloes or background. */
#include "render_frame.h"
#include "render_map.h"

#include "meshes.h"

enum { SIZE = 256 };

#define RADIUS 0.4

static struct test_frame frame;

static const struct hatch_view near_by = {.eye = {0, 0, 4},
                                          .right = {1, 0, 0},
                                          .up = {0, 1, 0},
                                          .back = {0, 0, 1},
                                          .half_height = 0.25,
                                          .aspect = 1,
                                          .near = HATCH_VIEW_NEAR,
                                          .pivot = 4};

static void show(const struct hatch_mesh *mesh)
{
    struct hatch_mesh kept = *mesh;
    frame_arenas(&frame);
    HATCH_TEST_OK(hatch_mesh_add_normals(&frame.args.keep, &frame.args.scratch, &kept, 1, &frame.err), &frame.err);
    frame_open(&kept, &frame_unit, NULL, &frame);
    frame.shown.style.curve.low = frame.shown.style.curve.high = 1;
    memcpy(frame.shown.style.inks.light_ink, frame.shown.style.inks.paper, sizeof(float[3]));
}

static void draw(const struct hatch_view *view, double halo_px, uint32_t side, struct hatch_image *image)
{
    frame.shown.style.halo_px = halo_px;
    frame_draw(&frame, "gouraud", view, SIZE, SIZE, side, image);
}

static double light_at(const struct hatch_image *image, int x, int y)
{
    return (double)image->pixels[3 * ((size_t)y * SIZE + (size_t)x)];
}

static struct hatch_mesh plane_at(double half, double depth)
{
    float at[12];
    static const uint32_t faces[6] = {0, 1, 3, 0, 3, 2};
    for (int v = 0; v < 4; v++) {
        at[3 * v] = (float)(v & 1 ? half : -half);
        at[3 * v + 1] = (float)(v & 2 ? half : -half);
        at[3 * v + 2] = (float)depth;
    }
    return mesh_of(at, 4, faces, 2);
}

static struct hatch_mesh ball_before_plane(void)
{
    struct hatch_mesh ball = bare_shape(HATCH_SHAPE_SPHERE, 20000), plane = plane_at(8, -1);
    move(&ball, (float)RADIUS, 0);
    return both(&plane, &ball);
}

/* The ball's radius in pixels. */
static double rim_px(const struct hatch_view *view)
{
    double distance = view->eye[2];
    double seen = view->orthographic ? RADIUS : RADIUS / sqrt(distance * distance - RADIUS * RADIUS);
    return SIZE / 2 * seen / view->half_height;
}

START_TEST(haloes_have_the_given_width)
{
    static const double widths[] = {0.5, 1, 3, 6.5, 20, 32};
    struct hatch_mesh mesh = ball_before_plane();
    show(&mesh);
    for (uint32_t side = 1; side <= 3; side++)
        for (size_t i = 0; i < 2 * sizeof widths / sizeof *widths; i++) {
            const struct hatch_view *view = i % 2 ? &near_by : &view_facing;
            double width = widths[i / 2], white[2] = {0, 0}, inside = 0, rim = rim_px(view);
            struct hatch_image image;
            draw(view, width, side, &image);
            for (int x = 0; x < SIZE; x++) {
                double away = fabs(x + 0.5 - SIZE / 2);
                white[x > SIZE / 2] += light_at(&image, x, SIZE / 2);
                if (away < rim - 1)
                    inside = fmax(inside, light_at(&image, x, SIZE / 2));
            }
            ck_assert_double_le(inside, 1e-6);
            for (int end = 0; end < 2; end++)
                ck_assert_msg(fabs(white[end] - width) <= 0.5, "%g px for %g, %u samples, view %zu", white[end], width,
                              side * side, i % 2);
        }
    frame_finish(&frame);
}
END_TEST

/* Sum of the brightness of all pixels. */
static double white_of(const struct hatch_image *image)
{
    double sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        sum += (double)image->pixels[3 * (size_t)i];
    return sum;
}

static void tilt(struct hatch_mesh *mesh, double angle)
{
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        float *at = mesh->attributes[0].data + 3 * v, y = at[1];
        at[1] = (float)(cos(angle) * (double)y - sin(angle) * (double)at[2]);
        at[2] = (float)(sin(angle) * (double)y + cos(angle) * (double)at[2]);
    }
}

/* A wall in the background and a floor that starts at its foot. */
static struct hatch_mesh wall_and_floor(void)
{
    static const float at[18] = {-8, 8, -1, 8, 8, -1, -8, -0.5f, -1, 8, -0.5f, -1, -8, -0.5f, 3.5f, 8, -0.5f, 3.5f};
    static const uint32_t faces[12] = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
    return mesh_of(at, 6, faces, 4);
}

/* Planes up to nearly edge on, spheres, and a floor that meets a wall. */
START_TEST(a_single_surface_has_no_haloes)
{
    for (int kind = 0; kind < 3; kind++)
        for (int turn = 0; turn < 6; turn++)
            for (int view = 0; view < 2; view++) {
                struct hatch_image with, without;
                struct hatch_mesh mesh = kind == 0   ? plane_at(6, 0)
                                         : kind == 1 ? bare_shape(HATCH_SHAPE_SPHERE, 2000u << turn)
                                                     : wall_and_floor();
                tilt(&mesh, kind == 2 ? 0.35 + 0.15 * turn : 1.5 - 0.28 * turn);
                show(&mesh);
                draw(view ? &near_by : &view_facing, 0, 2, &without);
                draw(view ? &near_by : &view_facing, 6, 2, &with);

                double more = white_of(&with) - white_of(&without);
                /* of some 800 pixels on the polygonal outline of the sphere */
                ck_assert_msg(more <= (kind == 1 ? 2 : 0), "kind %d, turn %d, view %d: %g pixels", kind, turn, view,
                              more);
                frame_finish(&frame);
            }
}
END_TEST

/* Returns the triangles that a picture is drawn with, without those outside it. */
static GLuint64 triangles_drawn(double halo_px)
{
    struct hatch_image image;
    GLuint query;
    GLuint64 count = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_CLIPPING_OUTPUT_PRIMITIVES_ARB, query);
    draw(&view_facing, halo_px, 1, &image);
    glEndQuery(GL_CLIPPING_OUTPUT_PRIMITIVES_ARB);
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &count);
    glDeleteQueries(1, &query);
    return count;
}

/* The picture has 32 by 32 blocks; measured: 150 are drawn. */
START_TEST(haloes_are_drawn_only_near_edges)
{
    struct hatch_mesh mesh = ball_before_plane();
    show(&mesh);
    if (epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query")) {
        GLuint64 without = triangles_drawn(0), with = triangles_drawn(6);
        ck_assert_uint_gt(with, without + 2 * 50);
        ck_assert_uint_lt(with, without + 2 * 300);
    }
    frame_finish(&frame);
}
END_TEST

START_TEST(tiled_and_whole_pictures_are_equal)
{
    struct hatch_image whole, tiled;
    struct hatch_mesh mesh = ball_before_plane();
    show(&mesh);
    draw(&near_by, 12, 1, &whole);
    frame.shown.size_max_px = 100;
    draw(&near_by, 12, 1, &tiled);
    for (int i = 0; i < 3 * SIZE * SIZE; i++)
        ck_assert_float_eq_tol(whole.pixels[i], tiled.pixels[i], 1.0f / 255);
    frame_finish(&frame);
}
END_TEST

/* A picture higher than the last one, a narrower and a wider one. */
START_TEST(pictures_do_not_depend_on_earlier_sizes)
{
    static const uint32_t sizes[4][2] = {{SIZE, SIZE / 2}, {SIZE, SIZE}, {SIZE / 2, SIZE}, {SIZE, SIZE}};
    struct hatch_image image[4], fresh;
    struct hatch_mesh mesh = ball_before_plane();
    show(&mesh);
    frame.shown.style.halo_px = 12;
    for (int i = 0; i < 4; i++)
        frame_draw(&frame, "gouraud", &near_by, sizes[i][0], sizes[i][1], 1, &image[i]);
    for (int i = 1; i < 4; i++) {
        frame_reset(&frame);
        frame_draw(&frame, "gouraud", &near_by, sizes[i][0], sizes[i][1], 1, &fresh);
        ck_assert_double_eq(frame_difference(&image[i], &fresh), 0);
    }
    frame_finish(&frame);
}
END_TEST

#define LINE_PX 3.0

/* White surfaces and black lines. */
static void draw_lines(const struct hatch_mesh *mesh, double halo_px, struct hatch_image *image)
{
    struct line_overlay lines;
    const struct line_overlay_style style = {
        .lines = {.kinds = HATCH_LINES_ALL, .width_px = LINE_PX, .crease_rad = 0.7}, .haloes = true};
    show(mesh);
    HATCH_TEST_OK(line_overlay_make(&lines, &frame.on_gpu, &style, &frame.shown.programs, &frame.args, &frame.err),
                  &frame.err);
    frame.lines = &lines;
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0;
    draw(&view_facing, halo_px, 2, image);
    line_overlay_free(&lines);
    frame.lines = NULL;
}

/* Lines of a square behind the ball end at its halo; the ball's own outline does not. */
START_TEST(lines_behind_end_at_haloes)
{
    const double halo = 8;
    struct hatch_image image;
    struct hatch_mesh ball = bare_shape(HATCH_SHAPE_SPHERE, 20000), plane = plane_at(0.35, -1);
    move(&ball, (float)RADIUS, 0);
    for (uint32_t v = 0; v < 4; v++)
        plane.attributes[0].data[3 * v] *= 2; /* a border runs from left to right below the middle */
    struct hatch_mesh mesh = both(&plane, &ball);
    draw_lines(&mesh, halo, &image);
    double rim = rim_px(&view_facing), down = 0.35 * SIZE / 2;
    double side = sqrt(rim * rim - down * down), first = 0, last = 0;
    int row = (int)(SIZE / 2 + down);
    for (int x = SIZE / 2 + (int)side; x < SIZE / 2 + (int)(0.7 * SIZE / 2) - 8; x++)
        if (light_at(&image, x, row) < 0.5 && x > SIZE / 2 + side + LINE_PX && first == 0)
            first = x;
    for (int x = SIZE / 2 + (int)side - 6; x < SIZE / 2 + (int)side + 8; x++)
        if (light_at(&image, x, row) < 0.5)
            last = x + 1;
    /* The line ends where its distance from the rim is the width of the halo plus half the width of the outline. */
    double want = sqrt((rim + halo + LINE_PX / 2) * (rim + halo + LINE_PX / 2) - down * down) + SIZE / 2;
    ck_assert_msg(fabs(first - want) <= 1.5, "the line begins at %g, not %g", first, want);
    ck_assert_msg(fabs(last - SIZE / 2 - side) <= 4, "the ball's line ends at %g, it at %g", last - SIZE / 2, side);
    for (int k = 0; k < 64; k++) {
        double a = 6.283185307 * k / 64, x = SIZE / 2 + rim * cos(a), y = SIZE / 2 + rim * sin(a);
        ck_assert_msg(light_at(&image, (int)x, (int)y) < 0.5, "the ball's line is cut at %d/64", k);
    }
    frame_finish(&frame);
}
END_TEST

/* A border visible between two balls. The part outside their haloes is drawn only if it is long enough. */
START_TEST(short_lines_between_haloes_are_dropped)
{
    const double halo = 8;
    for (int left_px = 5; left_px <= 30; left_px += 25) {
        struct hatch_image image;
        double gap_px = left_px + 2 * halo + LINE_PX, middle = RADIUS + gap_px / SIZE;
        struct hatch_mesh plane = plane_at(8, -1), balls[2];
        for (int k = 0; k < 2; k++) {
            balls[k] = bare_shape(HATCH_SHAPE_SPHERE, 20000);
            move(&balls[k], (float)RADIUS, 0);
            for (uint32_t v = 0; v < balls[k].vertex_count; v++)
                balls[k].attributes[0].data[3 * v] += (float)(k ? middle : -middle);
        }
        for (uint32_t v = 0; v < 4; v++)
            plane.attributes[0].data[3 * v + 1] -= 8; /* its upper border lies at the balls' middle */
        struct hatch_mesh pair = both(&balls[0], &balls[1]), mesh = both(&plane, &pair);
        draw_lines(&mesh, halo, &image);
        double dark = 0;
        for (int y = -2; y < 2; y++)
            for (int x = -left_px / 2; x < left_px / 2; x++)
                dark += 1 - light_at(&image, SIZE / 2 + x, SIZE / 2 + y);
        double want = left_px > 12 ? LINE_PX * left_px : 0;
        ck_assert_msg(fabs(dark - want) <= 0.1 * want, "%g of a line of %d pixels", dark, left_px);
        frame_finish(&frame);
    }
}
END_TEST

/* The border of a plane runs along the border of a smaller one before it. At a pixel's distance the nearer border is
 * taken for the line itself, and leaves it; at 2.5 pixels its halo covers the line. */
START_TEST(borders_in_the_halo_of_another_are_hidden)
{
    for (int apart = 0; apart < 2; apart++) {
        struct hatch_image image;
        double half = 0.35, apart_px = apart ? 2.5 : 1;
        struct hatch_mesh near = plane_at(half, 0), far = plane_at(half + apart_px / (SIZE / 2), -1);
        struct hatch_mesh mesh = both(&near, &far);
        draw_lines(&mesh, 8, &image);
        int border = (int)lround(half * SIZE / 2 + apart_px + LINE_PX / 2 - 1); /* of the farther line's outer pixel */
        double dark = 0;
        for (int x = -20; x < 20; x++) {
            dark += 1 - light_at(&image, SIZE / 2 + x, SIZE / 2 + border);
            dark += 1 - light_at(&image, SIZE / 2 + x, SIZE / 2 - 1 - border);
            dark += 1 - light_at(&image, SIZE / 2 + border, SIZE / 2 + x);
            dark += 1 - light_at(&image, SIZE / 2 - 1 - border, SIZE / 2 + x);
        }
        ck_assert_double_eq_tol(dark / 160, apart ? 0 : 1, 0.05);
        frame_finish(&frame);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render halo");
    TCase *tests = tcase_create("halo");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, haloes_have_the_given_width);
    tcase_add_test(tests, a_single_surface_has_no_haloes);
    tcase_add_test(tests, haloes_are_drawn_only_near_edges);
    tcase_add_test(tests, tiled_and_whole_pictures_are_equal);
    tcase_add_test(tests, pictures_do_not_depend_on_earlier_sizes);
    tcase_add_test(tests, lines_behind_end_at_haloes);
    tcase_add_test(tests, short_lines_between_haloes_are_dropped);
    tcase_add_test(tests, borders_in_the_halo_of_another_are_hidden);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
