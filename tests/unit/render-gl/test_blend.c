/* Compares the tam techniques with their definition, the blend of Praun et al. 2001, §5, computed here for each pixel
 * of a plane parallel to the screen whose texels coincide with pixels. */
#include <math.h>

#include "render_frame.h"
#include "render_map.h"

enum { SIZE = 64, TONES = 6 };

static struct test_frame frame;
static struct hatch_tam map;

/* A lamp in front of the upper left corner gives every vertex a different tone. */
static const struct hatch_light lamp = {.type = HATCH_LIGHT_POINT, .color = {1, 1, 1}, .intensity = 1.9f};
static const double lamp_at[3] = {-0.8, 0.7, 0.9};

static void add_lamp(void)
{
    struct hatch_scene *scene = &frame.scene;
    struct hatch_node *nodes = HATCH_NEW(&frame.args.keep, struct hatch_node, 2, &frame.err);
    nodes[0] = scene->nodes[0];
    nodes[1] = nodes[0];
    nodes[1].mesh_count = 0;
    nodes[1].light = 0;
    for (int k = 0; k < 3; k++)
        nodes[1].translation[k] = (float)lamp_at[k];
    scene->nodes = nodes;
    scene->node_count = 2;
    scene->lights = HATCH_NEW(&frame.args.keep, struct hatch_light, 1, &frame.err);
    scene->lights[0] = lamp;
    scene->light_count = 1;
    HATCH_TEST_OK(hatch_pose_make(scene, &frame.args.keep, &frame.on_gpu.unit.pose, &frame.err), &frame.err);
    HATCH_TEST_OK(scene_set_pose(&frame.on_gpu, HATCH_NONE, 0, &frame.args.scratch, &frame.err), &frame.err);
    frame.shown.style.curve.exposure = 1;
}

/* Tone of a vertex of the plane z = 0: 1 - light, times the tone of the darkest column. */
static double amount_at(const float *position)
{
    double square = 0, to[3];
    for (int k = 0; k < 3; k++) {
        to[k] = lamp_at[k] - (double)position[k];
        square += to[k] * to[k];
    }
    double light = (double)lamp.intensity * to[2] / sqrt(square) / square;
    return (double)map.target[map.tones - 1] * (1 - fmin(light, 1));
}

/* Ink at a texel after the blend of the two columns next to a tone. */
static double blended(double amount, uint32_t level, size_t texel)
{
    double begin = 0, ink_before = 0;
    for (uint32_t t = 0; t < map.tones; t++) {
        double end = (double)map.target[t];
        double ink = 1 - (double)map.columns[t].levels[level].pixels[texel];
        if (amount <= end || t + 1 == map.tones) {
            double share = fmin((amount - begin) / (end - begin), 1);
            return ink_before + share * (ink - ink_before);
        }
        begin = end;
        ink_before = ink;
    }
    return 0;
}

/* Barycentric coordinates in x and y; false outside. */
static bool inside(const float *const p[3], double x, double y, double share[3])
{
    double x0 = (double)p[0][0], y0 = (double)p[0][1];
    double ax = (double)p[1][0] - x0, ay = (double)p[1][1] - y0;
    double bx = (double)p[2][0] - x0, by = (double)p[2][1] - y0, det = ax * by - bx * ay;
    share[1] = ((x - x0) * by - (y - y0) * bx) / det;
    share[2] = ((y - y0) * ax - (x - x0) * ay) / det;
    share[0] = 1 - share[1] - share[2];
    return share[0] >= -1e-9 && share[1] >= -1e-9 && share[2] >= -1e-9;
}

/* The reflectance of a pixel: the sum over the face's vertices of share × blend. */
static double expected(const struct hatch_mesh *mesh, uint32_t column, uint32_t row, uint32_t level)
{
    const float *position = hatch_mesh_find(mesh, "POSITION", 3);
    uint32_t side = hatch_mip_size(SIZE, level);
    size_t texel = (size_t)(row % side) * side + column % side;
    double x = 2 * (column + 0.5) / SIZE - 1, y = 1 - 2 * (row + 0.5) / SIZE;
    for (uint32_t face = 0; face < mesh->face_count; face++) {
        const float *p[3];
        double share[3], ink = 0;
        for (size_t i = 0; i < 3; i++)
            p[i] = position + 3 * (size_t)mesh->indices[3 * (size_t)face + i];
        if (!inside(p, x, y, share))
            continue;
        for (int i = 0; i < 3; i++)
            ink += share[i] * blended(amount_at(p[i]), level, texel);
        return 1 - ink;
    }
    return 1;
}

static double worst_against_definition(const char *technique, uint32_t tones, uint32_t level)
{
    struct hatch_image image;
    frame_arenas(&frame);
    random_map(SIZE, tones, &frame.args.keep, &map);
    struct hatch_mesh mesh = frame_plane(&frame, 50);
    frame_open(&mesh, &frame_unit, &map, &frame);
    add_lamp();
    frame.on_gpu.unit.items[0].repeat[0] = frame.on_gpu.unit.items[0].repeat[1] = (float)(1u << level);
    frame_draw(&frame, technique, &view_facing, SIZE, SIZE, 1, &image);
    double worst = 0, least = 1, most = 0;
    for (uint32_t row = 0; row < SIZE; row++)
        for (uint32_t column = 0; column < SIZE; column++) {
            double drawn = (double)image.pixels[3 * (row * SIZE + column)];
            double want = expected(&mesh, column, row, level);
            worst = fmax(worst, fabs(drawn - want));
            least = fmin(least, want);
            most = fmax(most, want);
        }
    ck_assert_double_lt(least, 0.3); /* the picture has lit and dark parts */
    ck_assert_double_gt(most, 0.95);
    frame_finish(&frame);
    return worst;
}

START_TEST(tam_computes_the_six_way_blend)
{
    ck_assert_double_le(worst_against_definition("tam", 6, 0), 1.0 / 255);
}
END_TEST

START_TEST(tam_blends_maps_of_fewer_columns)
{
    ck_assert_double_le(worst_against_definition("tam", 1, 0), 1.0 / 255);
    ck_assert_double_le(worst_against_definition("tam", 4, 0), 1.0 / 255);
}
END_TEST

/* Near a whole level the next one has no weight, although the driver's logarithm is inexact. */
START_TEST(tam_does_not_mix_levels_near_a_whole_level)
{
    ck_assert_double_le(worst_against_definition("tam", 6, 1), 1.0 / 255);
    ck_assert_double_le(worst_against_definition("tam", 6, 2), 1.0 / 255);
}
END_TEST

START_TEST(tam_triple_computes_the_same_blend)
{
    ck_assert_double_le(worst_against_definition("tam-triple", 6, 0), 1.0 / 255);
    ck_assert_double_le(worst_against_definition("tam-triple", 3, 1), 1.0 / 255);
}
END_TEST

static void draw_teapot(const char *technique, struct hatch_image *image)
{
    struct hatch_view view = frame_view(&frame, 4.0 / 3);
    frame_draw(&frame, technique, &view, 320, 240, 2, image);
}

START_TEST(tam_triple_equals_tam_on_a_teapot)
{
    struct hatch_image one, three;
    struct hatch_bounds bounds = {.center = {0.2, 1.5, 0}, .radius = 3.5};
    frame_arenas(&frame);
    random_map(SIZE, TONES, &frame.args.keep, &map);
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_TEAPOT, 4000);
    frame_open(&mesh, &bounds, &map, &frame);
    draw_teapot("tam", &one);
    draw_teapot("tam-triple", &three);
    ck_assert_double_gt(frame_ink(&one), 0.05);
    ck_assert_double_le(frame_difference(&one, &three), 2.0 / 255);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render blend");
    TCase *tests = tcase_create("blend");
    tcase_add_test(tests, tam_computes_the_six_way_blend);
    tcase_add_test(tests, tam_blends_maps_of_fewer_columns);
    tcase_add_test(tests, tam_does_not_mix_levels_near_a_whole_level);
    tcase_add_test(tests, tam_triple_computes_the_same_blend);
    tcase_add_test(tests, tam_triple_equals_tam_on_a_teapot);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
