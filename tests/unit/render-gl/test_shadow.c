/* Compares shadows with geometry: a small square above a plane, seen from straight above, lit obliquely so that the
 * shadow falls beside it. */
#include "render_frame.h"
#include "render_map.h"

enum { SIZE = 256 };

#define HEIGHT 0.5 /* of the square over the plane */
#define HALF 0.125
#define AMBIENT 0.25

static struct test_frame frame;

/* A square plane at height 0 and a small square above it, both facing up. */
static struct hatch_mesh plane_and_square(void)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&frame.args.keep, 8, 4, &mesh, &frame.err), &frame.err);
    for (uint32_t v = 0; v < 8; v++) {
        float half = v < 4 ? 2.0f : (float)HALF, *at = mesh.attributes[0].data + 3 * v;
        at[0] = v & 1 ? half : -half;
        at[1] = v & 2 ? half : -half;
        at[2] = v < 4 ? 0.0f : (float)HEIGHT;
    }
    for (uint32_t q = 0; q < 2; q++) {
        const uint32_t corners[6] = {0, 1, 3, 0, 3, 2};
        for (uint32_t i = 0; i < 6; i++)
            mesh.indices[6 * q + i] = 4 * q + corners[i];
    }
    HATCH_TEST_OK(hatch_mesh_add_normals(&frame.args.keep, &frame.args.scratch, &mesh, 1, &frame.err), &frame.err);
    return mesh;
}

static void set_shadows(double width)
{
    frame.shown.style.curve.ambient = AMBIENT;
    frame.shown.style.curve.exposure = 1;
    frame.shown.style.pixel_light = true;
    frame.shown.style.shadows = width > 0;
    frame.shown.style.shadow_edge = width;
}

/* Draws the scene and returns the brightness of the middle row. */
static void draw_row(float row[SIZE])
{
    struct hatch_image image;
    frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &image);
    for (uint32_t x = 0; x < SIZE; x++)
        row[x] = image.pixels[3 * ((size_t)SIZE / 2 * SIZE + x)];
}

/* Returns the x at which the brightness first rises through a level, searching from a pixel.
 *   step  +1 or -1 */
static double crossing(const float row[SIZE], int from, int step, double level)
{
    for (int x = from; x + step >= 0 && x + step < SIZE; x += step) {
        double a = (double)row[x] - level, b = (double)row[x + step] - level;
        if (a < 0 && b >= 0)
            return (x + step * a / (a - b) + 0.5) * 2 / SIZE - 1;
    }
    ck_abort_msg("nothing crosses %g", level);
    return 0;
}

static int pixel_at(double x)
{
    return (int)((x + 1) / 2 * SIZE);
}

/* Checks that the shadow extends from left to right, has only ambient light in its middle, and changes nothing farther
 * out than its edge is wide. */
static void check_edges(double left, double right, double width)
{
    float row[SIZE], bare[SIZE];
    set_shadows(0);
    draw_row(bare);
    frame_reset(&frame);
    set_shadows(width);
    draw_row(row);
    int middle = pixel_at((left + right) / 2);
    double pixel = 2.0 / SIZE;
    ck_assert_double_eq_tol((double)row[middle], AMBIENT, 1.0 / 255);
    for (int end = 0; end < 2; end++) {
        double want = end ? right : left, half = (AMBIENT + (double)bare[pixel_at(want)]) / 2;
        double got = crossing(row, middle, end ? 1 : -1, half);
        ck_assert_msg(fabs(got - want) <= 0.5 * pixel + 0.1 * width, "edge at %g, not %g", got, want);
    }
    for (int x = 0; x < SIZE; x++) {
        double at = (x + 0.5) * pixel - 1, away = fmax(left - at, at - right);
        if (away > width + 2 * pixel) /* edges are wider in oblique light */
            ck_assert_msg(fabs((double)row[x] - (double)bare[x]) <= 1.0 / 255, "%g is darkened", at);
    }
}

START_TEST(the_sun_casts_a_shadow_of_the_same_size)
{
    static const double widths[] = {0.01, 0.03, 0.1};
    for (size_t i = 0; i < 3; i++) {
        frame_arenas(&frame);
        struct hatch_mesh mesh = plane_and_square();
        frame_open(&mesh, &frame_unit, NULL, &frame);
        frame.shown.style.light = (struct hatch_key_light){.replaces = true, .azimuth_rad = atan(1)};
        check_edges(-HEIGHT - HALF, -HEIGHT + HALF, widths[i]);
        frame_finish(&frame);
    }
}
END_TEST

/* Opens a square above a plane that is a backdrop, as --ground is: two nodes of one mesh. The square leans by 45
 * degrees to the right.
 *   half  half the side of the plane */
static void begin_backdrop(float half)
{
    frame_arenas(&frame);
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_PLANE, 2);
    HATCH_TEST_OK(hatch_scene_of_mesh(&mesh, &frame.args.keep, &frame.scene, &frame.err), &frame.err);
    struct hatch_node *nodes = HATCH_NEW(&frame.args.keep, struct hatch_node, 2, &frame.err);
    for (int i = 0; i < 2; i++) {
        nodes[i] = frame.scene.nodes[0];
        nodes[i].backdrop = i == 1;
        nodes[i].translation[2] = i ? 0.0f : (float)HEIGHT;
        for (int k = 0; k < 3; k++)
            nodes[i].scale[k] = i ? half : (float)HALF;
    }
    nodes[0].rotation[1] = (float)sin(atan(1) / 2);
    nodes[0].rotation[3] = (float)cos(atan(1) / 2);
    frame.scene.nodes = nodes;
    frame.scene.node_count = 2;
    frame_open_scene(NULL, &frame_unit, NULL, &frame);
}

/* The size of the ground does not blur a shadow on it, nor does the ground let light through from below. */
START_TEST(a_large_ground_has_the_same_shadows)
{
    double widths[2];
    for (int large = 0; large < 2; large++) {
        float row[SIZE];
        begin_backdrop(large ? 100.0f : 2.0f);
        struct hatch_key_light *light = &frame.shown.style.light;
        *light = (struct hatch_key_light){.replaces = true, .azimuth_rad = atan(1)};
        set_shadows(0.01);
        draw_row(row);
        int middle = pixel_at(-HEIGHT);
        double lit = (double)row[pixel_at(0.5)] - AMBIENT;
        widths[large] = crossing(row, middle, 1, AMBIENT + 0.9 * lit) - crossing(row, middle, 1, AMBIENT + 0.1 * lit);
        light->azimuth_rad = atan2(1, -0.27); /* from the right, and a little from below */
        draw_row(row);
        ck_assert_double_eq_tol((double)row[pixel_at(0)], AMBIENT, 1.0 / 255);
        frame_finish(&frame);
    }
    ck_assert_msg(widths[1] <= widths[0] + 1.0 / SIZE, "the edge is %g wide instead of %g", widths[1], widths[0]);
}
END_TEST

#define LAMP_X 0.9
#define LAMP_HEIGHT 1.5

/* Opens a scene with `count` lamps at one place above the right side, together as bright as one. Spots point at the
 * square.
 *   away  factor of their distance from the middle of the plane */
static void begin_lamps(enum hatch_light_type type, uint32_t count, double away)
{
    struct hatch_mesh mesh = plane_and_square();
    HATCH_TEST_OK(hatch_scene_of_mesh(&mesh, &frame.args.keep, &frame.scene, &frame.err), &frame.err);
    struct hatch_node *nodes = HATCH_NEW(&frame.args.keep, struct hatch_node, count + 1, &frame.err);
    struct hatch_light *lights = HATCH_NEW(&frame.args.keep, struct hatch_light, count, &frame.err);
    double turn = atan2(away * LAMP_X, away * LAMP_HEIGHT - HEIGHT);
    nodes[0] = frame.scene.nodes[0];
    for (uint32_t i = 0; i < count; i++) {
        nodes[i + 1] = (struct hatch_node){.parent = HATCH_NONE,
                                           .translation = {(float)(away * LAMP_X), 0, (float)(away * LAMP_HEIGHT)},
                                           .rotation = {0, (float)sin(turn / 2), 0, (float)cos(turn / 2)},
                                           .scale = {1, 1, 1},
                                           .skin = HATCH_NONE,
                                           .camera = HATCH_NONE,
                                           .light = i};
        lights[i] = (struct hatch_light){.type = type,
                                         .color = {1, 1, 1},
                                         .intensity = (float)(away * away / count),
                                         .inner_cone_rad = 0.9f,
                                         .outer_cone_rad = 1.0f};
    }
    frame.scene.nodes = nodes;
    frame.scene.node_count = count + 1;
    frame.scene.lights = lights;
    frame.scene.light_count = count;
    frame_open_scene(NULL, &frame_unit, NULL, &frame);
}

START_TEST(lamps_cast_larger_shadows)
{
    static const enum hatch_light_type types[] = {HATCH_LIGHT_POINT, HATCH_LIGHT_SPOT};
    static const double away[] = {1, 1.3, 10, 100, 600};
    for (size_t i = 0; i < 2; i++)
        for (size_t j = 0; j < sizeof away / sizeof *away; j++) {
            const double x = away[j] * LAMP_X, z = away[j] * LAMP_HEIGHT, grown = z / (z - HEIGHT);
            frame_arenas(&frame);
            begin_lamps(types[i], 1, away[j]);
            check_edges(x + (-HALF - x) * grown, x + (HALF - x) * grown, 0.03);
            frame_finish(&frame);
        }
}
END_TEST

/* Lights cast shadows in order until SHADOW_LAYERS_MAX is reached; the others are not blocked. */
START_TEST(lights_beyond_the_limit_cast_no_shadows)
{
    static const struct {
        enum hatch_light_type type;
        uint32_t count;
    } cases[] = {{HATCH_LIGHT_POINT, SHADOW_LAYERS_MAX / 6},
                 {HATCH_LIGHT_POINT, SHADOW_LAYERS_MAX / 6 + 3},
                 {HATCH_LIGHT_SPOT, SHADOW_LAYERS_MAX},
                 {HATCH_LIGHT_SPOT, SHADOW_LAYERS_MAX + 8}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        uint32_t layers = cases[i].type == HATCH_LIGHT_SPOT ? 1 : 6, count = cases[i].count;
        double through = 1 - fmin(1, SHADOW_LAYERS_MAX / layers / (double)count);
        float bare[SIZE], row[SIZE];
        frame_arenas(&frame);
        begin_lamps(cases[i].type, count, 1);
        set_shadows(0);
        draw_row(bare);
        frame_reset(&frame);
        set_shadows(0.03);
        draw_row(row);
        int middle = pixel_at(LAMP_X - LAMP_X * LAMP_HEIGHT / (LAMP_HEIGHT - HEIGHT));
        double want = AMBIENT + through * ((double)bare[middle] - AMBIENT);
        ck_assert_msg(fabs((double)row[middle] - want) <= 1.0 / 255, "case %zu: %g, not %g", i, (double)row[middle],
                      want);
        frame_finish(&frame);
    }
}
END_TEST

/* For light at any angle and for coarse faces. */
START_TEST(lit_surfaces_do_not_shadow_themselves)
{
    for (int shape = 0; shape < 2; shape++)
        for (int turn = 0; turn < 5; turn++) {
            struct hatch_image image[2];
            frame_arenas(&frame);
            struct hatch_mesh mesh =
                shape ? frame_shape(&frame, HATCH_SHAPE_SPHERE, 3000) : frame_shape(&frame, HATCH_SHAPE_PLANE, 2);
            frame_open(&mesh, &frame_unit, NULL, &frame);
            frame.shown.style.light =
                (struct hatch_key_light){.replaces = true, .azimuth_rad = 0.37 * turn, .elevation_rad = 0.1 * turn};
            for (int shadows = 0; shadows < 2; shadows++) {
                set_shadows(shadows ? 0.03 : 0);
                frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &image[shadows]);
                frame_reset(&frame);
            }
            double worst = frame_difference(&image[0], &image[1]);
            ck_assert_msg(worst <= (shape ? 8.0 : 1.0) / 255, "shape %d, turn %d: %g/255", shape, turn, 255 * worst);
            frame_finish(&frame);
        }
}
END_TEST

START_TEST(tiled_and_whole_pictures_are_equal)
{
    struct hatch_image whole, tiled;
    frame_arenas(&frame);
    struct hatch_mesh mesh = plane_and_square();
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.shown.style.light = (struct hatch_key_light){.replaces = true, .azimuth_rad = 0.7, .elevation_rad = 0.3};
    set_shadows(0.05);
    frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 2, &whole);
    frame.shown.size_max_px = SIZE;
    frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 2, &tiled);
    ck_assert_double_le(frame_difference(&whole, &tiled), 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

/* Shadow maps are reused between frames, but not when the light moves or when a pose changes without changing bounds.
 */
START_TEST(shadows_follow_lights_and_poses)
{
    struct hatch_image kept, fresh, before;
    frame_arenas(&frame);
    struct hatch_mesh mesh = plane_and_square();
    for (uint32_t v = 4; v < 8; v++)
        mesh.attributes[0].data[3 * v] += 0.3f;
    frame_open(&mesh, &frame_unit, NULL, &frame);
    struct hatch_key_light *light = &frame.shown.style.light;
    *light = (struct hatch_key_light){.replaces = true, .azimuth_rad = 0.5, .elevation_rad = 0.1};
    set_shadows(0.05);
    frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &before);
    for (int turned = 0; turned < 2; turned++) {
        if (turned) {
            frame.scene.nodes[0].rotation[2] = 1;
            frame.scene.nodes[0].rotation[3] = 0;
            HATCH_TEST_OK(scene_set_pose(&frame.on_gpu, HATCH_NONE, 1, &frame.args.scratch, &frame.err), &frame.err);
        } else {
            light->azimuth_rad = -0.4;
        }
        frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &kept);
        frame_reset(&frame);
        frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &fresh);
        ck_assert_double_le(frame_difference(&kept, &fresh), 0);
        ck_assert_double_gt(frame_difference(&kept, &before), 0.2);
        before = kept;
    }
    frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &kept);
    ck_assert_double_le(frame_difference(&kept, &fresh), 0);
    frame_finish(&frame);
}
END_TEST

/* A map is as large as 13 texels in the least width of a soft edge need, from 512 to 2048 pixels; its side
 * is a width of 2. It is kept while lights and poses stay: when it is emptied, there are no shadows. */
START_TEST(maps_have_room_for_soft_edges_and_are_kept)
{
    static const float far = 1;
    static const struct {
        double width;
        uint32_t size_px;
    } cases[] = {{0.1, 512}, {0.051, 512}, {0.0505, 1024}, {0.026, 1024}, {0.025, 2048}, {0.001, 2048}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hatch_image drawn, emptied, bare;
        frame_arenas(&frame);
        struct hatch_mesh mesh = plane_and_square();
        frame_open(&mesh, &frame_unit, NULL, &frame);
        frame.shown.style.light = (struct hatch_key_light){.replaces = true, .azimuth_rad = atan(1)};
        set_shadows(cases[i].width);
        frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &drawn);
        ck_assert_uint_eq(frame.shown.shadow.size_px, cases[i].size_px);
        glClearTexImage(frame.shown.shadow.maps, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &far);
        frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &emptied);
        set_shadows(0);
        frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &bare);
        ck_assert_double_gt(frame_difference(&drawn, &bare), 0.2);
        ck_assert_double_le(frame_difference(&emptied, &bare), 1e-6);
        frame_finish(&frame);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render shadow");
    TCase *tests = tcase_create("shadow");
    tcase_add_test(tests, the_sun_casts_a_shadow_of_the_same_size);
    tcase_add_test(tests, a_large_ground_has_the_same_shadows);
    tcase_add_test(tests, lamps_cast_larger_shadows);
    tcase_add_test(tests, lights_beyond_the_limit_cast_no_shadows);
    tcase_add_test(tests, lit_surfaces_do_not_shadow_themselves);
    tcase_add_test(tests, tiled_and_whole_pictures_are_equal);
    tcase_add_test(tests, shadows_follow_lights_and_poses);
    tcase_add_test(tests, maps_have_room_for_soft_edges_and_are_kept);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
