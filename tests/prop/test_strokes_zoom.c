/* Fitted strokes in near views. The pattern of seed points is the same at all scales: a plane that is seen from 2^-k of
 * a distance shows the strokes that it has elsewhere from that distance, where floats place them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/technique/strokes/strokes.h"
#include "rptam_model.h"
#include "zoom_reference.h"

enum { WIDTH = 320, HEIGHT = 240, STROKES_MAX = 2048, SEEN = 24 };

static struct test_frame frame;
static struct hatch_rptam rptam;

/* The strokes of a frame, ordered by id. */
struct drawn {
    uint32_t count, fragments;
    struct strokes_slot found[STROKES_MAX];
    float points[STROKES_MAX][RIBBON_POINTS][12];
};
static struct drawn near, far;

/* Opens a mesh, and the technique with strokes that depend on their pixels alone. */
static void begin_mesh(struct hatch_mesh *mesh)
{
    static const struct model_how how = {
        .layers = 2, .tile_px = 100, .length_px = 40, .width_px = 2, .angle_rad = {0.3, 1.4}, .overlap = 0.3};
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    frame_open(mesh, &frame_unit, NULL, &frame);
    frame.model = &rptam;
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0.4 * rptam.darkest;
    rptam_options.stroke_px[0] = how.length_px;
    rptam_options.stroke_px[1] = how.width_px;
    rptam_options.ink = 1;
}

static void draw(const struct hatch_view *view, struct drawn *drawn)
{
    struct hatch_image picture;
    frame_draw(&frame, "strokes", view, WIDTH, HEIGHT, 1, &picture);
    struct strokes_state *state = frame.instances[0].state;
    drawn->count = state->found_count;
    drawn->fragments = (uint32_t)state->counts.fragments;
    memset(&state->counts, 0, sizeof state->counts);
    ck_assert_uint_gt(drawn->count, 50);
    ck_assert_uint_le(drawn->count, STROKES_MAX);
    gpu_buffer_read(state->found.name, drawn->found, sizeof *drawn->found * drawn->count);
    gpu_buffer_read(state->points.name, drawn->points, sizeof *drawn->points * drawn->count);
}

/* Returns the distance between the ribbons of two strokes at the point where they are farthest apart. */
static double distance_px(float a[RIBBON_POINTS][12], float b[RIBBON_POINTS][12])
{
    double worst = 0;
    for (uint32_t k = 0; k < RIBBON_POINTS; k++)
        worst = fmax(worst, hypot((double)(a[k][0] - b[k][0]), (double)(a[k][1] - b[k][1])));
    return worst;
}

/* Returns a view of the plane's point with these texture coordinates. */
static struct hatch_view view_of(const double uv[2], double distance)
{
    static const double normal[3] = {0, 0, 1};
    double back[3];
    zoom_lean(normal, 0.6, back);
    return zoomed_view(&frame, (const double[3]){2 * uv[0] - 1, 1 - 2 * uv[1], 0}, back, distance,
                       (double)WIDTH / HEIGHT);
}

static const int octaves[] = {10, 20, 30};

START_TEST(near_strokes_are_those_of_a_far_view)
{
    static const double there[2] = {0.4375, 0.5625};
    double here[2], bits = ldexp(1, octaves[_i] - 2);
    uint32_t compared = 0, apart = 0;
    frame_arenas(&frame);
    struct hatch_mesh mesh = frame_plane(&frame, 2);
    begin_mesh(&mesh);
    for (int k = 0; k < 2; k++) /* a whole number of cycles of the pattern away, as seen from there */
        here[k] = floor(0.3 * bits) / bits + ldexp(there[k], -octaves[_i]);
    /* so near that the plane fills the margin around the picture, too */
    const struct hatch_view from_far = view_of(there, 1.2), from_near = view_of(here, ldexp(1.2, -octaves[_i]));
    draw(&from_far, &far);
    draw(&from_near, &near);
    for (uint32_t i = 0; i < far.count; i++) {
        double least = HUGE_VAL;
        if (far.found[i].count < SEEN)
            continue;
        for (uint32_t j = 0; j < near.count; j++)
            least = fmin(least, distance_px(far.points[i], near.points[j]));
        apart += least > 0.01;
        compared++;
    }
    ck_assert_uint_gt(compared, 50);
    ck_assert_msg(100 * apart <= compared, "%u of %u strokes are elsewhere", apart, compared);
    frame_finish(&frame);
}
END_TEST

static bool has(const struct drawn *drawn, const struct strokes_slot *stroke)
{
    for (uint32_t i = 0; i < drawn->count; i++)
        if (memcmp(drawn->found[i].id, stroke->id, sizeof stroke->id) == 0)
            return true;
    return false;
}

/* Returns the share of the larger strokes of one frame that another has, too. */
static double share_kept(const struct drawn *from, const struct drawn *to)
{
    uint32_t count = 0, kept = 0;
    for (uint32_t i = 0; i < from->count; i++)
        if (from->found[i].count >= SEEN) {
            count++;
            kept += has(to, &from->found[i]);
        }
    return (double)kept / count;
}

/* The camera comes nearer by an octave in steps of an eighth, from half the torus to the smallest distance. */
START_TEST(strokes_keep_their_ids_while_the_camera_comes_nearer)
{
    double point[3], normal[3], back[3];
    frame_arenas(&frame);
    struct hatch_mesh torus = frame_shape(&frame, HATCH_SHAPE_TORUS, 2000);
    begin_mesh(&torus);
    zoom_face_point(&torus, 640, (const double[3]){0.3, 0.3, 0.4}, point, normal);
    zoom_lean(normal, 0.5, back);
    for (int octave = 0; octave <= 40; octave += 5)
        for (int step = 0; step <= 8; step++) {
            const struct hatch_view view =
                zoomed_view(&frame, point, back, exp2(-octave - step / 8.0), (double)WIDTH / HEIGHT);
            draw(&view, &near);
            if (step > 0)
                ck_assert_msg(share_kept(&near, &far) > 0.8, "octave %d: %g of the strokes are new", octave,
                              1 - share_kept(&near, &far));
            far = near;
        }
    frame_finish(&frame);
}
END_TEST

/* At distances at which floats suffice. */
START_TEST(pieces_have_the_strokes_of_the_faces)
{
    double point[3], normal[3], back[3];
    frame_arenas(&frame);
    struct hatch_mesh torus = frame_shape(&frame, HATCH_SHAPE_TORUS, 2000);
    begin_mesh(&torus);
    zoom_face_point(&torus, 640, (const double[3]){0.3, 0.3, 0.4}, point, normal);
    zoom_lean(normal, 1.2, back);
    int pieces = 0;
    for (int octave = 2; octave <= 8; octave++) {
        const struct hatch_view view = zoomed_view(&frame, point, back, exp2(-octave), (double)WIDTH / HEIGHT);
        draw(&view, &near);
        pieces += frame.shown.near.found.items ? frame.shown.near.found.items[0].surface.count : 0;
        frame.shown.floats_alone = true;
        draw(&view, &far);
        frame.shown.floats_alone = false;
        ck_assert_double_gt(share_kept(&near, &far), 0.99);
        ck_assert_double_gt(share_kept(&far, &near), 0.99);
        ck_assert_double_lt(fabs((double)near.fragments - far.fragments), 0.001 * far.fragments);
    }
    ck_assert_int_gt(pieces, 0);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("strokes zoom");
    TCase *tests = tcase_create("zoom");
    tcase_add_loop_test(tests, near_strokes_are_those_of_a_far_view, 0, sizeof octaves / sizeof *octaves);
    tcase_add_test(tests, strokes_keep_their_ids_while_the_camera_comes_nearer);
    tcase_add_test(tests, pieces_have_the_strokes_of_the_faces);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
