/* Places in solid textures while the camera comes nearer by forty octaves, compared with a ray tracer in pairs of
 * doubles. */
#include "run.h"

#include "solid/solids.h"
#include "zoom_reference.h"

enum { WIDTH = 64, HEIGHT = 48, PERIOD_PX = 64, STEP = 5 };

static struct test_frame frame;
static struct hatch_mesh mesh;
static struct hatch_solid solid;

static const struct hatch_bounds odd_bounds = {.center = {0.1, -0.3, 0.7}, .radius = 1.7};

static const struct {
    enum hatch_shape shape;
    uint32_t faces, face;
    const struct hatch_bounds *bounds;
    double share[3], tilt;
    const char *turn; /* --solid-turn; NULL: none */
} surfaces[] = {
    {HATCH_SHAPE_PLANE, 2, 0, &frame_unit, {0.5, 0.2, 0.3}, 0.7, "23,34,11"},
    {HATCH_SHAPE_TORUS, 2000, 640, &frame_unit, {0.3, 0.3, 0.4}, 0.5, NULL},
    {HATCH_SHAPE_TEAPOT, 3000, 1000, &odd_bounds, {0.2, 0.5, 0.3}, 0.3, "-80,6,155"},
    {HATCH_SHAPE_TORUS, 2000, 640, &odd_bounds, {0.5, 0.5, 0}, 0.1, NULL}, /* an edge */
};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

static void begin_surface(int i)
{
    frame_arenas(&frame);
    mesh = frame_shape(&frame, surfaces[i].shape, surfaces[i].faces);
    frame_open(&mesh, surfaces[i].bounds, NULL, &frame);
    solid = solid_of_value(&frame.args.keep, 8, 128);
    solid_use(&frame, &solid, HATCH_ZOOM_LINEAR, PERIOD_PX);
    ((struct look *)frame.instances[0].state)->shading.stages.fragment = "solid/places.frag";
    look_options.turn = surfaces[i].turn;
}

/* Sets the places of vertices as struct hatch_item_rest defines them: x, and the sum of y and z. */
static void set_places(const struct hatch_item_rest *rest, struct zoom_corner *corners)
{
    const float *position = hatch_mesh_find(&mesh, "POSITION", 3);
    const double *origin = frame.on_gpu.unit.meshes[0].origin;
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        struct hatch_pair from[3], at[3];
        for (size_t k = 0; k < 3; k++)
            from[k] = hatch_pair_scale(hatch_pair_sum((double)position[3 * v + k], -origin[k]), 1 / rest->unit);
        for (size_t k = 0; k < 3; k++)
            at[k] = hatch_pair_add(hatch_pair_dot(from, rest->axes[k]), hatch_pair_of(rest->offset[k]));
        corners[v].uv[0] = at[0];
        corners[v].uv[1] = hatch_pair_add(at[1], at[2]);
        memset(corners[v].span, 0, sizeof corners[v].span);
    }
}

/* Returns the larger error of a pixel's two numbers, in pixels of a surface that faces the camera; 0 where rounding
 * decides in which cycle the pixel is. */
static double error_px(const struct hatch_view *view, const struct hatch_item_rest *rest, double hit,
                       const struct hatch_pair place[2], const float rgba[4])
{
    double unit_px = HEIGHT / (2 * view->half_height);
    double far = log2(PERIOD_PX / unit_px / rest->scale * hit), worst = 0;
    if (fabs(far - round(far)) < 1e-3)
        return 0;
    for (int k = 0; k < 2; k++) {
        double drawn = (double)rgba[2 * k] + ((double)rgba[2 * k + 1] + 0.5 / 1024) / 1024;
        double turn = drawn - zoom_place(place[k], (int)floor(far));
        worst = fmax(worst, 4 * fabs(turn - round(turn)) * PERIOD_PX);
    }
    return worst;
}

static struct zoom_error measure(const struct hatch_view *view)
{
    static float rgba[4 * WIDTH * HEIGHT];
    struct zoom_error error = {0, 0, 0, 0};
    struct hatch_arena_mark mark = hatch_arena_mark(&frame.args.keep);
    struct zoom_corner *corners = HATCH_NEW(&frame.args.keep, struct zoom_corner, mesh.vertex_count, &frame.err);
    ck_assert_ptr_nonnull(corners);
    frame_draw_numbers(&frame, "solid", view, WIDTH, HEIGHT, rgba);
    zoom_positions(&frame, view, corners);
    const struct hatch_item_rest rest = hatch_item_rest(&frame.on_gpu.unit, 0);
    set_places(&rest, corners);
    for (uint32_t i = STEP / 2; i < WIDTH * HEIGHT; i += STEP * 2 + 1) {
        const struct zoom_ray ray = zoom_ray_of(view, (i % WIDTH + 0.5) / WIDTH, ((double)(i / WIDTH) + 0.5) / HEIGHT);
        const struct zoom_corner *face[3];
        struct hatch_pair place[2];
        double span[6], hit = zoom_hit(&mesh, corners, &ray, place, span, face);
        if ((hit > 0) != (rgba[4 * (size_t)i] >= 0))
            error.wrong++;
        else if (hit > 0) {
            error.largest_px = fmax(error.largest_px, error_px(view, &rest, hit, place, rgba + 4 * (size_t)i));
            error.pixels++;
        }
    }
    hatch_arena_rewind(&frame.args.keep, mark);
    return error;
}

START_TEST(textures_keep_their_places_over_forty_octaves)
{
    static const int octaves[] = {0, 3, 6, 9, 14, 20, 27, 33, 40, 42};
    double point[3], normal[3], back[3];
    begin_surface(_i);
    zoom_face_point(&mesh, surfaces[_i].face, surfaces[_i].share, point, normal);
    zoom_lean(normal, surfaces[_i].tilt, back);
    for (size_t i = 0; i < sizeof octaves / sizeof *octaves; i++) {
        struct hatch_view view = zoomed_view(&frame, point, back, exp2(1 - octaves[i]), (double)WIDTH / HEIGHT);
        struct zoom_error error = measure(&view);
        ck_assert_msg(error.largest_px < 0.05 && error.wrong <= 2 && error.pixels > 20,
                      "octave %d: %g pixels, %u wrong, of %u", octaves[i], error.largest_px, error.wrong, error.pixels);
        if (octaves[i] < 20)
            continue;
        frame.shown.floats_alone = true;
        error = measure(&view);
        ck_assert_msg(error.largest_px > 1 || error.wrong > 50, "octave %d: floats alone are right", octaves[i]);
        frame.shown.floats_alone = false;
    }
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid places");
    TCase *tests = tcase_create("places");
    tcase_add_loop_test(tests, textures_keep_their_places_over_forty_octaves, 0, SURFACES);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
