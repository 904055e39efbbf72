/* Compares both ways in which the technique strokes collects the fragments of a stroke, and looks at the table of the
 * one by blending from frame to frame. */
#include <math.h>
#include <string.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/strokes/strokes.h"
#include "render_frame.h"
#include "rptam_model.h"

enum { WIDTH = 480, HEIGHT = 360, STROKES_MAX = 4096 };

static struct test_frame frame;
static struct hatch_rptam rptam;

/* The strokes of a frame. */
struct drawn {
    uint32_t count, strokes, waited, fragments; /* count: with the parts of divided strokes */
    struct strokes_slot found[STROKES_MAX];
    float points[STROKES_MAX][RIBBON_POINTS][12];
};
static struct drawn sorted, blended, again;

static void begin_torus(void)
{
    static const struct hatch_bounds bounds = {.radius = 2, .half = {1.4, 0.4, 1.4}};
    const struct model_how how = {.tile_px = 60, .length_px = 20, .width_px = 2, .angle_rad = {0, 1.5}, .layers = 2};
    frame_arenas(&frame);
    struct hatch_mesh torus = frame_shape(&frame, HATCH_SHAPE_TORUS, 2000);
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    frame_open(&torus, &bounds, NULL, &frame);
    frame.model = &rptam;
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0.5 * rptam.darkest;
    rptam_options.stroke_px[0] = 20;
    rptam_options.stroke_px[1] = 2;
}

/* Returns a frame's view from the side. */
static struct hatch_view view_from(double azimuth_rad)
{
    const struct hatch_view_choice choice = {
        .kind = HATCH_VIEW_FRAMED, .azimuth_rad = azimuth_rad, .elevation_rad = 0.6, .fov_rad = 0.5};
    static const struct hatch_pose_span span = {.animation = HATCH_NONE, .moments = 1};
    struct hatch_unit_scene *unit = &frame.on_gpu.unit;
    const struct hatch_framing framing = {&span, &unit->bounds, (double)WIDTH / HEIGHT};
    struct hatch_view view;
    HATCH_TEST_OK(hatch_view_make(&choice, &unit->pose, &framing, &frame.args.scratch, &view, &frame.err), &frame.err);
    return view;
}

/* Draws a frame, without overdraw.
 *   blends  by blending, else by sorting */
static void draw(bool blends, double azimuth_rad, struct drawn *drawn)
{
    const struct technique *technique = frame_technique("strokes");
    struct hatch_view view = view_from(azimuth_rad);
    struct hatch_image picture;
    for (const struct cmd_option *row = technique->options; row->name; row++)
        if (strcmp(row->name, "aggregate") == 0)
            *(int *)row->value = blends;
        else if (strcmp(row->name, "overdraw") == 0)
            *(double *)row->value = 0;
    frame_draw(&frame, "strokes", &view, WIDTH, HEIGHT, 1, &picture);
    struct strokes_state *state = frame.instances[0].state;
    drawn->count = state->found_count;
    drawn->strokes = (uint32_t)state->counts.strokes;
    drawn->fragments = (uint32_t)state->counts.fragments;
    drawn->waited = state->waited;
    memset(&state->counts, 0, sizeof state->counts);
    ck_assert_uint_gt(drawn->count, 0);
    ck_assert_uint_le(drawn->count, STROKES_MAX);
    gpu_buffer_read(state->found.name, drawn->found, sizeof *drawn->found * drawn->count);
    gpu_buffer_read(state->points.name, drawn->points, sizeof *drawn->points * drawn->count);
}

static bool same_id(const struct strokes_slot *a, const struct strokes_slot *b)
{
    return a->id[0] == b->id[0] && a->id[1] == b->id[1];
}

static const struct strokes_slot *find(const struct drawn *drawn, const struct strokes_slot *stroke)
{
    for (uint32_t i = 0; i < drawn->count; i++)
        if (same_id(&drawn->found[i], stroke))
            return &drawn->found[i];
    return NULL;
}

/* Curves through fewer fragments are hardly determined. */
enum { FRAGMENTS_LEAST = 16 };

/* Only the exact fit has penalties (fit/cubic.h), which straighten short strokes: by .29 pixels at most here. */
START_TEST(both_ways_find_the_same_curves)
{
    uint32_t count = 0;
    double sum = 0, worst = 0;
    begin_torus();
    draw(false, 0.5, &sorted);
    draw(true, 0.5, &blended);
    ck_assert_uint_eq(sorted.fragments, blended.fragments);
    ck_assert_uint_eq(sorted.strokes, blended.strokes);
    for (uint32_t i = 0; i < sorted.count; i++) {
        const struct strokes_slot *same = find(&blended, &sorted.found[i]);
        if (!same || sorted.found[i].count < FRAGMENTS_LEAST)
            continue;
        const float *a = sorted.points[i][RIBBON_POINTS / 2];
        const float *b = blended.points[same - blended.found][RIBBON_POINTS / 2];
        double way = hypot((double)(a[0] - b[0]), (double)(a[1] - b[1]));
        worst = fmax(worst, way);
        sum += way;
        count++;
    }
    ck_assert_uint_gt(count, sorted.strokes / 2);
    ck_assert_msg(sum < 0.004 * count, "%g pixels apart in the mean", sum / count);
    ck_assert_msg(worst < 0.5, "%g pixels apart", worst);
    frame_finish(&frame);
}
END_TEST

/* Returns how many strokes are in both frames, where each must have the same slot. */
static uint32_t count_kept(const struct drawn *before, const struct drawn *after)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < before->count; i++) {
        const struct strokes_slot *slot = find(after, &before->found[i]);
        kept += slot != NULL;
        ck_assert(!slot || slot->first == before->found[i].first);
    }
    return kept;
}

/* Slots of strokes that are out of sight are free in the third frame. */
START_TEST(strokes_keep_their_slots_while_they_are_seen)
{
    begin_torus();
    draw(true, 0.5, &blended);
    draw(true, 0.6, &again);
    uint32_t kept = count_kept(&blended, &again);
    ck_assert_uint_gt(kept, again.count / 2);
    ck_assert_uint_lt(kept, again.count);
    draw(true, 0.6, &blended);
    ck_assert_uint_eq(count_kept(&again, &blended), again.count);
    frame_finish(&frame);
}
END_TEST

/* The first frame waits for nobody; in a later one, strokes that meet in a free slot are left out. The table has four
 * slots per stroke, so that some of them meet when all are new. */
START_TEST(strokes_that_meet_wait_for_the_next_frame)
{
    begin_torus();
    draw(false, 2, &sorted);
    draw(true, 0.5, &blended);
    ck_assert_uint_gt(blended.waited, 0);
    draw(true, 2, &blended);
    ck_assert_uint_gt(blended.waited, 0);
    ck_assert_uint_lt(blended.waited, sorted.strokes / 2);
    ck_assert_uint_eq(blended.count + blended.waited, sorted.strokes);
    draw(true, 2, &again);
    ck_assert_uint_lt(again.waited, blended.waited / 2);
    ck_assert_uint_eq(again.count + again.waited, sorted.strokes);
    draw(true, 2, &again);
    ck_assert_uint_eq(again.waited, 0);
    ck_assert_uint_eq(again.count, sorted.strokes);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render strokes paths");
    TCase *tests = tcase_create("paths");
    tcase_add_test(tests, both_ways_find_the_same_curves);
    tcase_add_test(tests, strokes_keep_their_slots_while_they_are_seen);
    tcase_add_test(tests, strokes_that_meet_wait_for_the_next_frame);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
