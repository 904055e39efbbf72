/* Measures how the widths of traced strokes change from frame to frame:
 *     bench_motion STYLE FILE
 * STYLE is a file of a style, FILE one of strokegen, of a scene with one mesh. The camera turns by 12 steps of 2.5
 * degrees, and comes nearer in 48 steps of a sixteenth of an octave, from eight times the usual distance on, which no
 * finer strokes are traced for. A point of a stroke counts if it is in the picture and on a face that is seen from its
 * front in both frames. */
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "math/angle.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/traced/traced.h"
#include "render_frame.h"
#include "shared/scene.h"

enum { WIDTH = 960, HEIGHT = 720, BINS = 4000, TURNS = 12, ZOOMS = 48 };

#define LIGHT_RAD (-40 * HATCH_RADIANS) /* from the camera of the first frame */
#define BIN_PX 0.002                    /* width of a bin of changes */
#define VISIBLE_PX 0.3                  /* a narrower point is not seen to go */

static const char *style, *path;
static struct test_frame frame;

/* Changes of width of a motion. */
struct changes {
    uint64_t bins[BINS + 1], count, visible, gone;
    double sum;
};

static void open_scene(void)
{
    static const struct hatch_pose_span span = {.animation = HATCH_NONE, .moments = 1};
    struct hatch_bounds bounds;
    struct hatch_pose pose;
    frame_arenas(&frame);
    cmd_read_scene(&frame.args, path, CMD_SCENE_AS_IS, &frame.scene);
    HATCH_TEST_OK(hatch_pose_make(&frame.scene, &frame.args.keep, &pose, &frame.err), &frame.err);
    HATCH_TEST_OK(hatch_pose_bounds(&pose, &span, &frame.args.scratch, &bounds, &frame.err), &frame.err);
    frame_open_scene(NULL, &bounds, NULL, &frame);
    for (uint32_t i = 0; i < frame.on_gpu.unit.item_count; i++)
        frame.on_gpu.unit.items[i].double_sided = false; /* points seen from behind are told apart */
    frame.shown.style.curve = (struct frame_curve){.high = 0.9, .gamma = 1, .ambient = 0.1, .exposure = 1};
    for (const struct cmd_option *row = technique_traced.options; row->name; row++)
        if (strcmp(row->name, "finer") == 0)
            *(int64_t *)row->value = 0;
        else if (strcmp(row->name, "stroke-style") == 0)
            *(const char **)row->value = style;
}

static struct hatch_view view_at(double azimuth_rad, double distance)
{
    static const struct hatch_pose_span span = {.animation = HATCH_NONE, .moments = 1};
    const struct hatch_view_choice choice = {.kind = HATCH_VIEW_FRAMED,
                                             .azimuth_rad = azimuth_rad,
                                             .elevation_rad = 20 * HATCH_RADIANS,
                                             .fov_rad = 30 * HATCH_RADIANS};
    struct hatch_unit_scene *unit = &frame.on_gpu.unit;
    const struct hatch_framing framing = {&span, &unit->bounds, (double)WIDTH / HEIGHT};
    struct hatch_view view;
    HATCH_TEST_OK(hatch_view_make(&choice, &unit->pose, &framing, &frame.args.scratch, &view, &frame.err), &frame.err);
    for (int k = 0; k < 3; k++)
        view.eye[k] *= distance;
    return view;
}

/* Makes the light come from where it came from in a view, as it stays with the scene. */
static void keep_light(const struct hatch_view *first, const struct hatch_view *view)
{
    const double level = cos(-LIGHT_RAD);
    double x = 0, y = 0, z = 0;
    for (int k = 0; k < 3; k++) {
        double from = level * sin(LIGHT_RAD) * first->right[k] + sin(-LIGHT_RAD) * first->up[k] +
                      level * cos(LIGHT_RAD) * first->back[k];
        x += from * view->right[k];
        y += from * view->up[k];
        z += from * view->back[k];
    }
    frame.shown.style.light = (struct hatch_key_light){.azimuth_rad = atan2(x, z), .elevation_rad = asin(y)};
}

/* Draws a view.
 *   ribbon  out: the points of the strokes, those of strokes that are not drawn zeroed */
static void draw(const struct hatch_view *view, float *ribbon)
{
    struct hatch_image picture;
    struct hatch_arena_mark mark = hatch_arena_mark(&frame.args.keep);
    const struct traced_state *state = frame.instances[0].state;
    const struct traced_strokes *strokes = traced_strokes_of(&frame.shown, state, 0);
    const GLuint buffer = traced_ribbon_of(state, 0)->buffer;
    glClearNamedBufferData(buffer, GL_R32F, GL_RED, GL_FLOAT, NULL);
    frame_draw(&frame, "traced", view, WIDTH, HEIGHT, 2, &picture);
    hatch_arena_rewind(&frame.args.keep, mark);
    gpu_buffer_read(buffer, ribbon, sizeof *ribbon * TRACED_RIBBON_FLOATS * strokes->end[strokes->count - 1]);
}

static bool is_inside(const float *point)
{
    return point[3] >= 0 && point[0] >= 0 && point[0] < WIDTH && point[1] >= 0 && point[1] < HEIGHT;
}

/* Whether a point is seen from behind: it has a place, but shaders/traced/points.comp stops before its pressure. */
static bool is_behind(const float *point)
{
    return point[4] == 0 && point[10] == 0 && (point[0] != 0 || point[1] != 0);
}

static void compare(const float *before, const float *now, size_t points, struct changes *changes)
{
    for (size_t i = 0; i < points; i++, before += TRACED_RIBBON_FLOATS, now += TRACED_RIBBON_FLOATS) {
        double from_px = 2 * (double)before[3], to_px = 2 * (double)now[3], change = fabs(to_px - from_px);
        /* A stroke that is not drawn at all has no place. */
        if (!(is_inside(before) || before[3] == 0) || !(is_inside(now) || now[3] == 0) || from_px + to_px <= 0 ||
            is_behind(before) || is_behind(now))
            continue;
        changes->count++;
        changes->sum += change;
        changes->bins[(size_t)fmin(change / BIN_PX, BINS)]++;
        changes->visible += from_px > VISIBLE_PX;
        changes->gone += from_px > VISIBLE_PX && to_px <= 0;
    }
}

static void print_changes(const char *motion, const struct changes *changes)
{
    size_t bin = 0;
    for (uint64_t below = changes->bins[0]; (double)below < 0.99 * (double)changes->count; below += changes->bins[bin])
        bin++;
    printf("%s\t%llu\t%.4f\t%.3f\t%.5f\n", motion, (unsigned long long)changes->count,
           changes->sum / (double)changes->count, BIN_PX * (double)(bin + 1),
           (double)changes->gone / (double)changes->visible);
}

START_TEST(measure)
{
    static struct changes turn, zoom;
    open_scene();
    const struct hatch_view first = view_at(30 * HATCH_RADIANS, 1);
    frame_picture(&frame, "traced");
    technique_traced.read(&frame.technique_context, &frame.instances[0]);
    const struct traced_state *state = frame.instances[0].state;
    const struct traced_strokes *strokes = traced_strokes_of(&frame.shown, state, 0);
    size_t points = strokes->end[strokes->count - 1];
    float *ribbons[2];
    for (int i = 0; i < 2; i++)
        ribbons[i] = HATCH_NEW(&frame.args.keep, float, TRACED_RIBBON_FLOATS *points, &frame.err);
    for (int i = 0; i <= TURNS; i++) {
        const struct hatch_view view = view_at((30 + 2.5 * i) * HATCH_RADIANS, 1);
        keep_light(&first, &view);
        draw(&view, ribbons[i % 2]);
        if (i > 0)
            compare(ribbons[1 - i % 2], ribbons[i % 2], points, &turn);
    }
    keep_light(&first, &first);
    for (int i = 0; i <= ZOOMS; i++) {
        const struct hatch_view view = view_at(30 * HATCH_RADIANS, exp2(3 - i / 16.0));
        draw(&view, ribbons[i % 2]);
        if (i > 0)
            compare(ribbons[1 - i % 2], ribbons[i % 2], points, &zoom);
    }
    print_changes("turn", &turn);
    print_changes("zoom", &zoom);
    fflush(stdout);
    frame_finish(&frame);
}
END_TEST

int main(int argc, char **argv)
{
    if (argc != 3) {
        fputs("usage: bench_motion STYLE FILE\n", stderr);
        return 2;
    }
    style = argv[1];
    path = argv[2];
    return hatch_bench_main("bench motion", measure);
}
