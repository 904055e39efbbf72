/* Inputs on which a plain use of solid textures fails and this one does not. */
#include "run.h"

#include "math/vector.h"
#include "solid/facing.h"

enum { SIZE = FACING_SIZE };

static struct test_frame frame;
static struct hatch_mesh mesh;
static struct hatch_solid solid;
static struct hatch_image pictures[2];

static void use_waves(enum hatch_zoom_blend blend)
{
    solid = solid_of_waves(&frame.args.keep, 32, 4);
    solid_use(&frame, &solid, blend, 48);
}

static void scale_mesh(float by)
{
    float *position = hatch_mesh_find(&mesh, "POSITION", 3);
    for (size_t i = 0; i < 3 * (size_t)mesh.vertex_count; i++)
        position[i] *= by;
}

/* Draws a torus whose vertices and scene are scaled. */
static void draw_scaled(float scale, struct hatch_image *image)
{
    const struct hatch_bounds bounds = {.radius = (double)scale};
    mesh = frame_shape(&frame, HATCH_SHAPE_TORUS, 500);
    scale_mesh(scale);
    frame_open(&mesh, &bounds, NULL, &frame);
    use_waves(HATCH_ZOOM_HISTOGRAM);
    const struct hatch_view view = frame_view(&frame, 1);
    frame_draw(&frame, "solid", &view, SIZE, SIZE, 1, image);
    frame_close(&frame);
}

/* With a fixed scale of the texture, what §3.4 of the paper names as its limit, one of them would be plain. */
START_TEST(the_picture_does_not_depend_on_the_objects_size)
{
    static const float scales[] = {0x1p-20f, 0x1p20f, 0x1p-40f};
    frame_arenas(&frame);
    draw_scaled(1, &pictures[0]);
    draw_scaled(scales[_i], &pictures[1]);
    ck_assert_double_le(frame_difference(&pictures[0], &pictures[1]), 1 / 255.0);
    ck_assert_double_gt(frame_ink(&pictures[0]), 0.05);
    frame_finish(&frame);
}
END_TEST

/* Returns the root of the factor by which a scale of x, y and z changes areas of faces, as a quadratic mean. */
static double scale_of_faces(const double scale[3])
{
    double before = 0, after = 0, corners[3][3], normal[3];
    for (uint32_t face = 0; face < mesh.face_count; face++) {
        ck_assert(hatch_mesh_corners(&mesh, face, corners));
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        double area = hatch_vec_length(normal);
        for (int i = 0; i < 9; i++)
            corners[i / 3][i % 3] *= scale[i % 3];
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        before += area;
        after += hatch_vec_dot(normal, normal) / area;
    }
    return sqrt(sqrt(after / before));
}

/* Mirrored and stretched nodes, and a flat one: the texture has the mean scale of the faces. */
START_TEST(any_node_has_finite_values)
{
    static const double scales[][3] = {{-1, 1, 1}, {1e-3, 1, 1}, {1, 40, 0.2}, {-1e6, -1e6, 1e6}, {1, 1, 0}};
    frame_arenas(&frame);
    mesh = frame_shape(&frame, HATCH_SHAPE_TORUS, 500);
    HATCH_TEST_OK(hatch_scene_of_mesh(&mesh, &frame.args.keep, &frame.scene, &frame.err), &frame.err);
    struct hatch_node node = frame.scene.nodes[0];
    double most = 0;
    for (int k = 0; k < 3; k++) {
        node.scale[k] = (float)scales[_i][k];
        most = fmax(most, fabs(scales[_i][k]));
    }
    frame.scene.nodes = &node;
    frame_open_scene(NULL, &(struct hatch_bounds){.radius = most}, NULL, &frame);
    const struct hatch_item_rest rest = hatch_item_rest(&frame.on_gpu.unit, 0);
    ck_assert_double_eq_tol(rest.scale * most / rest.unit, scale_of_faces(scales[_i]), 1e-6 * most);
    use_waves(HATCH_ZOOM_HISTOGRAM);
    const struct hatch_view view = frame_view(&frame, 1);
    frame_draw(&frame, "solid", &view, SIZE, SIZE, 1, &pictures[0]);
    for (size_t i = 0; i < 3 * SIZE * SIZE; i++)
        ck_assert(pictures[0].pixels[i] >= 0 && pictures[0].pixels[i] <= 1);
    frame_finish(&frame);
}
END_TEST

/* The camera in the middle of a solid, on its surface, and in the plane of a square. */
START_TEST(the_camera_may_be_anywhere)
{
    static const struct {
        enum hatch_shape shape;
        double eye[3];
    } cameras[] = {{HATCH_SHAPE_SPHERE, {0, 0, 0}}, {HATCH_SHAPE_SPHERE, {0, 0, 1}}, {HATCH_SHAPE_PLANE, {3, 0, 0}}};
    static float rgba[4 * SIZE * SIZE];
    frame_arenas(&frame);
    mesh = frame_shape(&frame, cameras[_i].shape, 500);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    use_waves(HATCH_ZOOM_HISTOGRAM);
    struct hatch_view view = frame_view(&frame, 1);
    memcpy(view.eye, cameras[_i].eye, sizeof view.eye);
    if (_i == 2)
        hatch_view_set_back(&view, (const double[]){1, 0, 0});
    frame_draw_numbers(&frame, "solid", &view, SIZE, SIZE, rgba);
    for (size_t i = 0; i < 4 * SIZE * SIZE; i++)
        ck_assert(rgba[i] >= -1 && rgba[i] <= 1);
    frame_finish(&frame);
}
END_TEST

/* A skin moves a square, and the camera follows: the texture moves with it. */
START_TEST(a_skinned_mesh_keeps_its_texture)
{
    static double values[2][SIZE * SIZE];
    for (int moved = 0; moved < 2; moved++) {
        const double point[3] = {0.1 + 0.37 * moved, 0.2, 0};
        frame_arenas(&frame);
        mesh = frame_shape(&frame, HATCH_SHAPE_PLANE, 200);
        frame_skin(&mesh, &frame);
        for (int joint = 1; joint < 3; joint++)
            frame.scene.nodes[joint].translation[0] = 0.37f * (float)moved;
        frame_open_scene(NULL, &frame_unit, NULL, &frame);
        use_waves(HATCH_ZOOM_HISTOGRAM);
        facing_draw_at(&frame, point, 3.3, values[moved]);
        frame_finish(&frame);
    }
    ck_assert_double_le(facing_change(values[0], values[1]), 0.2 / 255);
}
END_TEST

static double deviation_of(const double *values)
{
    double sum = 0, squares = 0;
    for (size_t i = 0; i < SIZE * SIZE; i++) {
        sum += values[i] / (SIZE * SIZE);
        squares += values[i] * values[i] / (SIZE * SIZE);
    }
    return sqrt(fmax(squares - sum * sum, 0));
}

/* The linear blend halves the contrast of cubes of black and white; histogram keeps it. */
START_TEST(a_checkerboard_keeps_its_contrast)
{
    static double values[SIZE * SIZE];
    facing_open(&frame, &mesh);
    solid = solid_checkers(&frame.args.keep, 32, 8);
    for (int step = 0; step < 4; step++) {
        solid_use(&frame, &solid, HATCH_ZOOM_LINEAR, 64);
        facing_draw(&frame, 0, 5 + step / 4.0, values);
        ck_assert_double_lt(deviation_of(values), 0.33);
        solid_use(&frame, &solid, HATCH_ZOOM_HISTOGRAM, 64);
        facing_draw(&frame, 0, 5 + step / 4.0, values);
        ck_assert_double_gt(deviation_of(values), 0.4);
    }
    frame_finish(&frame);
}
END_TEST

START_TEST(a_texture_of_one_value_is_that_value)
{
    static double values[SIZE * SIZE];
    facing_open(&frame, &mesh);
    solid = solid_of_value(&frame.args.keep, 8, 100);
    solid_use(&frame, &solid, (enum hatch_zoom_blend)_i, 64);
    for (int octave = 0; octave < 40; octave += 9) {
        facing_draw(&frame, 0, octave + 0.3, values);
        for (size_t i = 0; i < SIZE * SIZE; i++)
            ck_assert_double_eq_tol(values[i], 100 / 255.0, 1 / 255.0);
    }
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid limits");
    TCase *tests = tcase_create("limits");
    tcase_add_loop_test(tests, the_picture_does_not_depend_on_the_objects_size, 0, 3);
    tcase_add_loop_test(tests, any_node_has_finite_values, 0, 5);
    tcase_add_loop_test(tests, the_camera_may_be_anywhere, 0, 3);
    tcase_add_test(tests, a_skinned_mesh_keeps_its_texture);
    tcase_add_test(tests, a_checkerboard_keeps_its_contrast);
    tcase_add_loop_test(tests, a_texture_of_one_value_is_that_value, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
