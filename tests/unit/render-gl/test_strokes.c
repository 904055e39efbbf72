/* Fitted strokes on the GPU: shaders/strokes/cubic.glsl fits as fit/cubic.c does, strokes keep their ids while the view
 * turns, pictures drawn in tiles are those drawn at once, and films leave out strokes that do not last. */
#include <math.h>
#include <string.h>

#include "arenas.h"
#include "filter/difference.h"
#include "fit/strokes.h"
#include "math/angle.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/strokes/strokes.h"
#include "render_frame.h"
#include "rptam_model.h"
#include "gpu/stage.h"

enum {
    STROKES = 400,
    FRAMES = 40,
    WIDTH = 360,
    HEIGHT = 240,
    TILED = 600,
    TILE = 300,
    SIDE = 2,
    SEEN = 24,
    MOST = 65536
};

static struct test_frame frame;
static struct hatch_rptam rptam;

/* Compiles a compute stage that fits the strokes of a buffer and writes their factors. */
static GLuint fit_program(void)
{
    static const char include[] = "#include \"strokes/curve.glsl\"\n",
                      begin[] = "#version 450 core\n#define STORAGE_SORTED 0\n",
                      end[] = "layout(local_size_x = 1) in;\n"
                              "layout(std430, binding = 1) readonly buffer Ranges { uvec2 ranges[]; };\n"
                              "layout(std430, binding = 2) writeonly buffer Cubics { vec4 cubics[]; };\n"
                              "void main()\n"
                              "{\n"
                              "    uint i = gl_GlobalInvocationID.x;\n"
                              "    Cubic cubic = fit(ranges[i].x, ranges[i].y);\n"
                              "    cubics[4u * i] = cubic.x;\n"
                              "    cubics[4u * i + 1u] = cubic.y;\n"
                              "    cubics[4u * i + 2u] = vec4(cubic.range, cubic.origin);\n"
                              "    cubics[4u * i + 3u] = vec4(cubic.weight, place_on(cubic, 1.25), 0.0);\n"
                              "}\n";
    const char *fit = strstr(shader_text("strokes/cubic.glsl"), include);
    ck_assert_ptr_nonnull(fit);
    const char *const texts[] = {begin, shader_text("strokes/curve.glsl"), fit + sizeof include - 1, end};
    return compute_program(4, texts);
}

/* Packs a fragment as shaders do, and rounds it to what they read. */
static void pack(struct hatch_fragment *fragment, uint32_t words[2])
{
    words[0] = (uint32_t)fragment->x | (uint32_t)fragment->y << 16;
    words[1] = (uint32_t)(fragment->t * 65535 + 0.5f) | (uint32_t)(fragment->weight * 65535 + 0.5f) << 16;
    fragment->t = (float)(words[1] & 0xffff) / 65535;
    fragment->weight = (float)(words[1] >> 16) / 65535;
}

static void compare_cubics(const struct hatch_cubic *cubic, const float got[16])
{
    float place[2];
    hatch_cubic_at(cubic, 1.25f, place);
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
        for (uint32_t axis = 0; axis < 2; axis++)
            ck_assert_float_eq_tol(got[4 * axis + k], cubic->factor[axis][k], 0.01f);
    ck_assert_float_eq_tol(got[8], cubic->t[0], 1e-6f);
    ck_assert_float_eq_tol(got[9], cubic->t[1], 1e-6f);
    ck_assert_float_eq_tol(got[10], cubic->origin[0], 1e-6f);
    ck_assert_float_eq_tol(got[11], cubic->origin[1], 1e-6f);
    ck_assert_float_eq_tol(got[12], cubic->weight, 0.01f + 1e-3f * cubic->weight);
    ck_assert_float_eq_tol(got[13], place[0], 0.02f);
    ck_assert_float_eq_tol(got[14], place[1], 0.02f);
}

START_TEST(shaders_fit_as_the_library_does)
{
    static uint32_t words[STROKES * FIT_MOST][2], ranges[STROKES][2];
    static struct hatch_cubic cubics[STROKES];
    static struct fit_stroke stroke;
    static float got[STROKES][16];
    struct gpu_context context;
    uint32_t count = 0;
    for (uint32_t i = 0; i < STROKES; i++) {
        const struct fit_way way = fit_draw_way((enum fit_kind)(i % FIT_KINDS), i, 1);
        fit_fragments(&way, &stroke);
        if (!stroke.count)
            stroke.fragments[stroke.count++] = (struct hatch_fragment){0.5f, 20.5f, 30.5f, 1};
        ranges[i][0] = count;
        ranges[i][1] = (uint32_t)stroke.count;
        for (size_t f = 0; f < stroke.count; f++)
            pack(&stroke.fragments[f], words[count++]);
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubics[i]);
    }
    HATCH_TEST_OK(gpu_context_open_headless(&context, 2, &err), &err);
    GLuint program = fit_program();
    GLuint buffers[3] = {gpu_buffer_make(words, sizeof *words * count), gpu_buffer_make(ranges, sizeof ranges),
                         gpu_buffer_make(NULL, sizeof got)};
    for (GLuint k = 0; k < 3; k++)
        gpu_storage_bind(k, buffers[k]);
    glUseProgram(program);
    glDispatchCompute(STROKES, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gpu_buffer_read(buffers[2], got, sizeof got);
    glDeleteBuffers(3, buffers);
    glDeleteProgram(program);
    gpu_context_close(&context);
    for (uint32_t i = 0; i < STROKES; i++)
        compare_cubics(&cubics[i], got[i]);
}
END_TEST

/* Opens a mesh, and the technique with strokes of 40 by 2 pixels. */
static void begin_mesh(const struct hatch_mesh *mesh)
{
    frame_open(mesh, &frame_unit, NULL, &frame);
    frame.shown.style.curve.high = 0.6;
    const struct model_how how = {
        .layers = 2, .tile_px = 120, .length_px = 40, .width_px = 2, .angle_rad = {0, 1.2}, .overlap = 0.3};
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    frame.model = &rptam;
    rptam_options.stroke_px[0] = how.length_px;
    rptam_options.stroke_px[1] = how.width_px;
    rptam_options.ink = 1;
    struct technique_instance *instance = frame.instances;
    HATCH_TEST_OK(technique_open(instance, frame_technique("strokes"), &frame.technique_args, &frame.err), &frame.err);
    struct strokes_state *state = instance->state;
    state->seeds.model = &rptam;
    state->seeds.source.drawing.width_px = 2;
    state->seeds.source.drawing.pen.wobble_px = 1;
}

static void begin_torus(void)
{
    frame_arenas(&frame);
    const struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_TORUS, 5000);
    begin_mesh(&mesh);
}

/* The normals of a plane lean aside by 60 degrees at both sides, where the light has a half. In the middle it has all,
 * but only if it is computed there. */
START_TEST(light_per_pixel_leaves_its_middle_blank)
{
    double ink[2] = {0, 0};
    struct hatch_image image;
    for (int pixels = 0; pixels < 2; pixels++) {
        frame_arenas(&frame);
        struct hatch_mesh plane = frame_plane(&frame, 2);
        const float *position = hatch_mesh_find(&plane, "POSITION", 3);
        float *normal = hatch_mesh_find(&plane, "NORMAL", 3);
        for (size_t v = 0; v < plane.vertex_count; v++) {
            const float leaning[3] = {position[3 * v] * sqrtf(0.75f), 0, 0.5f};
            memcpy(normal + 3 * v, leaning, sizeof leaning);
        }
        begin_mesh(&plane);
        frame.shown.style.light.replaces = true;
        frame.shown.style.curve.exposure = 1;
        frame.shown.style.pixel_light = pixels;
        frame_draw(&frame, "strokes", &view_facing, HEIGHT, HEIGHT, 1, &image);
        for (size_t y = 0; y < HEIGHT; y++)
            for (size_t x = HEIGHT / 2 - 5; x < HEIGHT / 2 + 5; x++)
                ink[pixels] += (1 - (double)image.pixels[3 * (y * HEIGHT + x)]) / (10 * HEIGHT);
        frame_finish(&frame);
    }
    ck_assert_msg(ink[0] > 0.1 && ink[1] < 0.02, "ink of %g and %g", ink[0], ink[1]);
}
END_TEST

START_TEST(tiles_make_the_whole_picture)
{
    struct hatch_image whole, tiled;
    struct hatch_difference difference;
    begin_torus();
    struct hatch_view view = frame_view(&frame, 1);
    frame_draw(&frame, "strokes", &view, TILED, TILED, SIDE, &whole);
    frame.shown.size_max_px = SIDE * TILE;
    frame_draw(&frame, "strokes", &view, TILED, TILED, SIDE, &tiled);
    ck_assert_double_lt(hatch_image_mean(&whole), 0.95);
    hatch_image_difference(&whole, &tiled, &difference);
    ck_assert_msg(difference.rmse < 0.01, "root mean square %g, largest %g", difference.rmse, difference.max);
    frame_finish(&frame);
}
END_TEST

/* An id, and the last frames in which its stroke was in sight. */
struct sighting {
    uint32_t id, fragments; /* id: the first word, which all parts of a divided stroke have; fragments: the most of
                               these frames */
    int first, last;
};

static int compare_ids(const void *a, const void *b)
{
    const uint32_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Reads the strokes of a frame, each once, by id.
 *   strokes  out: ids, and fragments of all parts together
 * Returns their number. */
static uint32_t read_strokes(struct strokes_slot strokes[MOST])
{
    const struct strokes_state *state = frame.instances[0].state;
    uint32_t count = 0;
    ck_assert_uint_le(state->found_count, MOST);
    gpu_buffer_read(state->found.name, strokes, sizeof *strokes * state->found_count);
    qsort(strokes, state->found_count, sizeof *strokes, compare_ids);
    for (uint32_t i = 0; i < state->found_count; i++)
        if (count > 0 && strokes[count - 1].id[0] == strokes[i].id[0])
            strokes[count - 1].count += strokes[i].count;
        else
            strokes[count++] = strokes[i];
    return count;
}

/* Returns whether a stroke of many fragments came and went within three frames before this one. */
static bool flickered(const struct sighting *known, int number)
{
    return known->first > 0 && known->last + 1 < number && known->last - known->first < 2 && known->fragments >= SEEN;
}

/* Notes the strokes of a frame.
 *   all  count of them, by id; out: with the new ones
 * Returns the number of strokes that have flickered. */
static uint32_t note_frame(int number, struct sighting *all, uint32_t *count)
{
    static struct strokes_slot strokes[MOST];
    uint32_t before = *count, flickers = 0, found = read_strokes(strokes);
    for (uint32_t i = 0; i < found; i++) {
        struct sighting *known = bsearch(strokes[i].id, all, before, sizeof *all, compare_ids);
        if (!known) {
            all[(*count)++] = (struct sighting){strokes[i].id[0], strokes[i].count, number, number};
            continue;
        }
        flickers += flickered(known, number);
        if (known->last + 1 < number)
            *known = (struct sighting){strokes[i].id[0], 0, number, number};
        known->last = number;
        known->fragments = known->fragments > strokes[i].count ? known->fragments : strokes[i].count;
    }
    qsort(all, *count, sizeof *all, compare_ids);
    return flickers;
}

/* Returns a view that is turned around the vertical axis. */
static struct hatch_view turned(struct hatch_view view, double angle)
{
    double c = cos(angle), s = sin(angle), *const vectors[] = {view.eye, view.right, view.up, view.back};
    for (int k = 0; k < 4; k++) {
        double x = vectors[k][0], z = vectors[k][2];
        vectors[k][0] = c * x + s * z;
        vectors[k][2] = c * z - s * x;
    }
    return view;
}

/* The view turns by 3 degrees a frame. */
START_TEST(strokes_keep_their_ids)
{
    static struct sighting all[1 << 20];
    uint32_t count = 0, flickers = 0, lasting = 0;
    struct hatch_image image;
    begin_torus();
    const struct hatch_view from = frame_view(&frame, (double)WIDTH / HEIGHT);
    for (int i = 0; i < FRAMES; i++) {
        const struct hatch_view view = turned(from, i * 3 * HATCH_RADIANS);
        frame_draw(&frame, "strokes", &view, WIDTH, HEIGHT, 1, &image);
        flickers += note_frame(i, all, &count);
    }
    for (uint32_t i = 0; i < count; i++) {
        lasting += all[i].last - all[i].first >= 2;
        flickers +=
            all[i].first > 0 && all[i].last + 1 < FRAMES && all[i].last - all[i].first < 2 && all[i].fragments >= SEEN;
    }
    ck_assert_uint_gt(lasting, 400);
    ck_assert_msg(flickers * 100 <= lasting, "%u of %u strokes flicker", flickers, lasting);
    frame_finish(&frame);
}
END_TEST

/* Draws a film.
 *   images  out: of the frames */
static void draw_film(const struct hatch_view *views, uint32_t count, struct hatch_image *images)
{
    struct picture picture = frame_picture(&frame, "strokes");
    struct canvas canvas;
    uint32_t foreseen = 0;
    HATCH_TEST_OK(picture_canvas(&frame.shown, TILED, TILED, 1, &canvas, &err), &err);
    for (uint32_t i = 0; i < count; i++) {
        for (; foreseen < count && foreseen <= i + TECHNIQUE_AHEAD; foreseen++) {
            picture.film = foreseen + 1;
            HATCH_TEST_OK(picture_foresee(&picture, &views[foreseen], &canvas, TILED, TILED, &err), &err);
        }
        picture.film = i + 1;
        HATCH_TEST_OK(hatch_image_make(&frame.args.keep, TILED, TILED, "RGB", &images[i], &err), &err);
        HATCH_TEST_OK(picture_draw(&picture, &views[i], &canvas, &images[i], &err), &err);
    }
    canvas_free(&canvas);
}

static bool is_seen(const struct strokes_moment *moment, uint64_t id)
{
    const uint64_t *ids = (const uint64_t *)(const void *)moment->ids.data;
    for (size_t i = 0; i < moment->ids.size / sizeof *ids; i++)
        if (ids[i] == id)
            return true;
    return false;
}

/* Checks that of the strokes of a frame those last that another one has, too. Returns their number.
 *   film, other  numbers of the frames in the film, from 1 */
static uint32_t check_lasting(uint32_t film, uint32_t other)
{
    const struct strokes_state *state = frame.instances[0].state;
    const struct strokes_moment *moments = state->moments;
    uint32_t lasting = 0;
    for (const struct strokes_tile *tile = moments[film % HATCH_LASTING_SPAN].tiles; tile; tile = tile->next)
        for (uint32_t i = 0; i < tile->list.count; i++) {
            const bool seen = is_seen(&moments[other % HATCH_LASTING_SPAN], tile->list.wholes[i]);
            ck_assert(tile->list.lasts[i] == seen);
            lasting += seen;
        }
    return lasting;
}

/* The frame in the middle is turned: of its strokes, those alone are drawn that the others have, too. The other frames
 * are those that are drawn alone. If it is turned by much, it is another picture, and also drawn as if alone. The last
 * frame of the longer film is found in the buffers that were those of the turned frame. */
START_TEST(strokes_of_a_single_frame_are_not_drawn)
{
    enum { LONGER = 8, MIDDLE = 2 };
    begin_torus();
    const struct hatch_view view = frame_view(&frame, 1);
    const bool jumps = _i == 2;
    const uint32_t count = jumps ? LONGER : 5;
    struct hatch_view views[LONGER];
    struct hatch_image images[LONGER], alone, other;
    for (uint32_t i = 0; i < count; i++)
        views[i] = i == MIDDLE ? turned(view, (jumps ? 150 : 10) * HATCH_RADIANS) : view;
    if (_i == 1)
        frame.shown.size_max_px = TILE; /* in tiles */
    frame_draw(&frame, "strokes", &view, TILED, TILED, 1, &alone);
    frame_draw(&frame, "strokes", &views[MIDDLE], TILED, TILED, 1, &other);
    draw_film(views, count, images);
    for (uint32_t i = 0; i < count; i++)
        if (i != MIDDLE)
            ck_assert_double_le(frame_difference(&images[i], &alone), 0);
    if (jumps)
        ck_assert_double_le(frame_difference(&images[MIDDLE], &other), 0);
    else {
        ck_assert_uint_gt(check_lasting(MIDDLE + 1, MIDDLE), 0);
        ck_assert_double_gt(hatch_image_mean(&images[MIDDLE]), hatch_image_mean(&other));
    }
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render strokes");
    TCase *tests = tcase_create("strokes");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, shaders_fit_as_the_library_does);
    tcase_add_test(tests, light_per_pixel_leaves_its_middle_blank);
    tcase_add_test(tests, tiles_make_the_whole_picture);
    tcase_add_test(tests, strokes_keep_their_ids);
    tcase_add_loop_test(tests, strokes_of_a_single_frame_are_not_drawn, 0, 3);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
