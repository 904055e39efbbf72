/* Looks of solid textures: pictures whose colours are known. */
#include "run.h"

#include "io/png/png.h"
#include "render-gl/scene/material.h"
#include "solid/facing.h"

enum { WIDTH = 640, HEIGHT = 400, SMALL = 60, SPECKS_MOST = 12 };

#define WHITE 0.6f /* between the paper and the borders of strips */

static struct test_frame frame;
static struct hatch_mesh mesh;
static struct hatch_solid solid;
static struct look look; /* that paints pictures */
static const struct look_options usual = {.grain = 1, .bands = 2, .period_px = 64};
static const struct hatch_bounds teapot_bounds = {.center = {0.2, 1.5, 0}, .radius = 3.5};

static void begin(void)
{
    frame_arenas(&frame);
    look_options = usual;
    mesh = frame_shape(&frame, HATCH_SHAPE_TEAPOT, 6000);
    frame_open(&mesh, &teapot_bounds, NULL, &frame);
    frame.shown.style.light = (struct hatch_key_light){.azimuth_rad = -0.7, .elevation_rad = 0.7};
    solid = solid_of_waves(&frame.args.keep, 32, 6);
}

static void begin_plane(void)
{
    facing_open(&frame, &mesh);
    look_options = usual;
    solid = solid_of_waves(&frame.args.keep, 32, 6);
}

static void end(void)
{
    look_free(&look);
    look = (struct look){.paints = false};
    frame.technique_context.look = NULL;
    frame_finish(&frame);
}

/* Draws in watercolor from here on: the technique solid, and the pictures of others. */
static void use_watercolor(void)
{
    solid_use_look(&frame, &solid, 64, LOOK_WATERCOLOR);
    look = (struct look){.paints = true, .files = {.count = 1, .solids = {solid}}};
    look_choose(&look, LOOK_WATERCOLOR);
    frame.technique_context.look = &look;
}

/* Draws the plane in one tone. Returns the picture.
 *   distance  1: the plane fills it */
static struct hatch_image flat(const char *technique, double tone, double distance)
{
    static const double middle[3] = {0, 0, 0}, back[3] = {0, 0, 1};
    struct hatch_view view = zoomed_view(&frame, middle, back, distance, 1);
    struct hatch_image image;
    frame.shown.style.curve.low = frame.shown.style.curve.high = tone;
    frame_draw(&frame, technique, &view, FACING_SIZE, FACING_SIZE, 2, &image);
    return image;
}

/* Returns the mean of a channel over a rectangle of the picture, as shares of its sides. */
static double mean_of(const struct hatch_image *image, const double x[2], const double y[2], size_t channel)
{
    double sum = 0, count = 0;
    for (uint32_t row = (uint32_t)(y[0] * image->height); row < y[1] * image->height; row++)
        for (uint32_t column = (uint32_t)(x[0] * image->width); column < x[1] * image->width; column++, count++)
            sum += (double)image->pixels[3 * ((size_t)row * image->width + column) + channel];
    return sum / count;
}

static const double whole[2] = {0, 1};

/* Counts regions of 2 to SMALL pixels that are all white, or none of them, and touch by their sides or corners. */
static int count_specks(const struct hatch_image *image)
{
    static int region[WIDTH * HEIGHT], queue[WIDTH * HEIGHT];
    int specks = 0, regions = 0;
    memset(region, 0, sizeof region);
    for (int start = 0; start < WIDTH * HEIGHT; start++) {
        const bool white = image->pixels[3 * start] >= WHITE;
        int done = 0, found = 0;
        if (region[start])
            continue;
        region[queue[found++] = start] = ++regions;
        for (; done < found; done++) {
            const int x = queue[done] % WIDTH, y = queue[done] / WIDTH;
            for (int k = 0; k < 9; k++) {
                const int i = x + k % 3 - 1, j = y + k / 3 - 1, at = j * WIDTH + i;
                if (i < 0 || i >= WIDTH || j < 0 || j >= HEIGHT || region[at] ||
                    white != (image->pixels[3 * at] >= WHITE))
                    continue;
                region[queue[found++] = at] = regions;
            }
        }
        specks += found > 1 && found <= SMALL;
    }
    return specks;
}

/* Some are left at tips, where no wide strip is near. If narrow strips stay there are over sixty. */
START_TEST(borders_of_strips_leave_no_specks)
{
    static const double distances[] = {1, 2, 4};
    struct hatch_image image;
    int specks = 0;
    begin();
    solid_use_look(&frame, &solid, 64, LOOK_COLLAGE);
    look_options =
        (struct look_options){.kind = LOOK_COLLAGE, .bands = 5, .wobble_px = 3, .border_px = 2.5, .period_px = 64};
    for (int k = 0; k < 3; k++)
        frame.shown.style.inks.paper[k] = 0.5f;
    for (int i = 0; i < 3; i++) {
        struct hatch_view view = frame_view(&frame, (double)WIDTH / HEIGHT);
        for (int k = 0; k < 3; k++)
            view.eye[k] *= distances[i];
        frame_draw(&frame, "solid", &view, WIDTH, HEIGHT, 2, &image);
        specks += count_specks(&image);
    }
    ck_assert_msg(specks <= SPECKS_MOST, "%d specks", specks);
    end();
}
END_TEST

/* A wash of tone t lets 1 - .25 - .75 t of the light through, and grain moves pigment without adding any. */
START_TEST(a_flat_tone_keeps_its_mean)
{
    static const char *const drawn[] = {"solid", "gouraud"};
    begin_plane();
    use_watercolor();
    for (int i = 0; i < 6; i++) {
        double tone = i % 3 / 2.0, want = 0.75 - 0.75 * tone;
        struct hatch_image image = flat(drawn[i / 3], tone, 0.7);
        double mean = mean_of(&image, whole, whole, 1);
        ck_assert_msg(fabs(mean - want) < 0.015, "%s at %g: %g, want %g", drawn[i / 3], tone, mean, want);
    }
    end();
}
END_TEST

/* The plane from afar, in the middle of the picture: its left edge is at .255 of the width. */
START_TEST(pigment_gathers_at_edges)
{
    static const double inside[2] = {0.4, 0.6}, edge[2] = {0.258, 0.274};
    begin_plane();
    use_watercolor();
    look_options.grain = 0;
    for (int i = 0; i < 2; i++) {
        look_options.darkening = i;
        struct hatch_image image = flat("gouraud", 0.5, 8);
        double darker = mean_of(&image, inside, inside, 1) - mean_of(&image, edge, inside, 1);
        ck_assert_msg(i ? darker > 0.1 : fabs(darker) < 0.005, "with %d: darker by %g", i, darker);
    }
    end();
}
END_TEST

/* Amounts of ink that a picture holds are those that were drawn. With light per pixel no sample has both inks. */
START_TEST(a_picture_of_tones_is_painted_like_a_solid)
{
    struct hatch_image own, painted;
    begin();
    use_watercolor();
    look_options.wobble_px = 3;
    look_options.dry = 0.12;
    look_options.wet = look_options.darkening = 0.5;
    struct hatch_view view = frame_view(&frame, (double)WIDTH / HEIGHT);
    frame.shown.style.inks = (struct frame_inks){
        .paper = {0.6f, 0.55f, 0.5f}, .ink = {0.05f, 0.02f, 0.1f}, .light_ink = {0.9f, 1, 0.8f}, .two = _i};
    frame.shown.style.pixel_light = true;
    frame_draw(&frame, "solid", &view, WIDTH, HEIGHT, 2, &own);
    frame_draw(&frame, "gouraud", &view, WIDTH, HEIGHT, 2, &painted);
    ck_assert_msg(frame_difference(&own, &painted) < 0.02, "%g", frame_difference(&own, &painted));
    end();
}
END_TEST

/* In tiles, places in the texture are rounded otherwise, and a pixel at the border of a wash differs by up to .1. */
START_TEST(painted_tiles_join_without_a_seam)
{
    struct hatch_image joined, tiled;
    begin();
    use_watercolor();
    look_options.wobble_px = 3;
    look_options.wet = look_options.darkening = look_options.paper_grain = 0.5;
    struct hatch_view view = frame_view(&frame, (double)WIDTH / HEIGHT);
    frame_draw(&frame, "gouraud", &view, WIDTH, HEIGHT, 2, &joined);
    frame.shown.size_max_px = 300; /* draws in tiles of 150 pixels */
    frame_draw(&frame, "gouraud", &view, WIDTH, HEIGHT, 2, &tiled);
    frame.shown.size_max_px = frame.context.size_max_px;
    ck_assert_msg(frame_difference(&joined, &tiled) < 0.2, "%g", frame_difference(&joined, &tiled));
    end();
}
END_TEST

/* Makes a material of a texture whose left half is red and whose right half is green. */
static void make_material(void)
{
    static struct hatch_material material = {.base_color = {1, 1, 0.5f, 1}};
    static struct hatch_texture texture;
    struct hatch_image image;
    struct hatch_buffer file = {.arena = &frame.args.keep};
    HATCH_TEST_OK(hatch_image_make(&frame.args.keep, 8, 8, "RGB", &image, &frame.err), &frame.err);
    for (uint32_t i = 0; i < 8 * 8; i++) {
        const float color[2][3] = {{1, 0, 1}, {0, 1, 1}};
        memcpy(image.pixels + (size_t)3 * i, color[i % 8 / 4], sizeof color[0]);
    }
    HATCH_TEST_OK(hatch_png_write(&image, HATCH_PNG_SRGB, 8, NULL, &frame.args.scratch, &file, &frame.err), &frame.err);
    texture = (struct hatch_texture){.data = file.data, .size = file.size};
    frame.scene.materials = &material;
    frame.scene.textures = &texture;
    frame.scene.material_count = frame.scene.texture_count = 1;
    frame.scene.meshes[0].material = 0;
}

/* White paper under a white texture shows the colours themselves; watercolor shows them as thin layers. */
START_TEST(materials_keep_their_colours)
{
    static const double left[2] = {0.1, 0.4}, right[2] = {0.6, 0.9};
    begin_plane();
    frame_close(&frame);
    mesh = frame_plane(&frame, 2);
    HATCH_TEST_OK(hatch_scene_of_mesh(&mesh, &frame.args.keep, &frame.scene, &frame.err), &frame.err);
    make_material();
    frame_open_scene(NULL, &frame_unit, NULL, &frame);
    material_upload(&frame.args, "test", true, frame.context.size_max_px, &frame.on_gpu);
    frame.shown.style.base_color = look_options.colors = true;
    look_options.grain = 0;
    solid = solid_of_value(&frame.args.keep, 8, 255);
    for (int i = 0; i < 3; i++) {
        static const enum look_kind kinds[] = {LOOK_PLAIN, LOOK_COLLAGE, LOOK_WATERCOLOR};
        use_watercolor();
        solid_use_look(&frame, &solid, 64, kinds[i]);
        struct hatch_image image = flat(i == 2 ? "gouraud" : "solid", 0, 3.9);
        double full = i == 1 ? 0.75 : 1, thin = i == 2 ? pow(0.5, 0.6) : 0.5 * full; /* strips have a tone of 1/4 */
        ck_assert_double_eq_tol(mean_of(&image, left, whole, 0), i == 2 ? 0.97 : full, 0.04);
        ck_assert_double_eq_tol(mean_of(&image, left, whole, 1), 0, 0.04);
        ck_assert_double_eq_tol(mean_of(&image, right, whole, 0), 0, 0.04);
        ck_assert_double_eq_tol(mean_of(&image, right, whole, 1), i == 2 ? 0.97 : full, 0.04);
        ck_assert_double_eq_tol(mean_of(&image, right, whole, 2), thin, 0.04);
    }
    end();
}
END_TEST

/* The four samples of a pixel share the reads of the texture: they show it as it is at the middle of the pixel, within
 * two steps of eight bits, to which renderers may round what they read. */
START_TEST(samples_of_a_pixel_show_its_middle)
{
    static const double middle[3] = {0.1, 0.05, 0}, back[3] = {0.3, 0.2, 0.9};
    static float pixels[4 * SMALL * SMALL], samples[16 * SMALL * SMALL];
    double worst = 0, least = 1, most = 0;
    begin_plane();
    solid_use_look(&frame, &solid, 64, LOOK_PLAIN);
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0;
    for (int i = 0; i < 4; i++) {
        struct hatch_view view = zoomed_view(&frame, middle, back, 0.5 * exp2(-0.3 * i), 1);
        frame_draw_samples(&frame, "solid", &view, SMALL, SMALL, 1, pixels);
        frame_draw_samples(&frame, "solid", &view, SMALL, SMALL, 2, samples);
        for (size_t at = 0; at < (size_t)4 * SMALL * SMALL; at++) {
            double value = (double)pixels[4 * (at / (4 * SMALL) * SMALL + at % (2 * SMALL) / 2)];
            worst = fmax(worst, fabs((double)samples[4 * at] - value));
            least = fmin(least, value);
            most = fmax(most, value);
        }
    }
    ck_assert_double_lt(worst, 2.0 / 255);
    ck_assert_double_gt(most - least, 0.3);
    end();
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("looks");
    TCase *tests = tcase_create("looks");
    tcase_add_test(tests, borders_of_strips_leave_no_specks);
    tcase_add_test(tests, a_flat_tone_keeps_its_mean);
    tcase_add_test(tests, pigment_gathers_at_edges);
    tcase_add_loop_test(tests, a_picture_of_tones_is_painted_like_a_solid, 0, 2); /* inks but one */
    tcase_add_test(tests, painted_tiles_join_without_a_seam);
    tcase_add_test(tests, materials_keep_their_colours);
    tcase_add_test(tests, samples_of_a_pixel_show_its_middle);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
