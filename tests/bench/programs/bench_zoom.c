/* Measures rptam over eighty octaves of zoom, drawn with floats alone and with pieces of near faces: the distance of
 * strokes from their positions by a reference in pairs of doubles, and the change of the tone of a plane. Octave 0
 * shows 2 units of the scene; above it the camera moves closer. Below it the same distances are used with texture
 * coordinates 2^40 times as dense: octave -40 is as close as octave 40. */
#include <stdio.h>

#include "bench.h"
#include "rptam_model.h"
#include "zoom_reference.h"

enum { WIDTH = 240, HEIGHT = 180, TONES = 5 };

static struct test_frame frame;
static struct hatch_rptam rptam;
static struct hatch_mesh mesh;

static void begin(enum hatch_shape shape, float repeats)
{
    static const struct model_how how_drawn = {
        .layers = 2, .tile_px = 32, .length_px = 12, .width_px = 2, .angle_rad = {0.5, 1.5}, .overlap = 0.3};
    frame_arenas(&frame);
    mesh = frame_shape(&frame, shape, 2000);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
    for (size_t i = 0; i < 2 * (size_t)mesh.vertex_count; i++)
        texcoord[i] *= repeats;
    model_make(&how_drawn, &frame.args.keep, &frame.args.scratch, &rptam);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.model = &rptam;
}

static double mean_ink(const struct hatch_view *view, double tone)
{
    struct hatch_image picture;
    struct hatch_arena_mark mark = hatch_arena_mark(&frame.args.keep);
    double sum = 0;
    frame.shown.style.curve.low = frame.shown.style.curve.high = tone;
    frame_draw(&frame, "rptam", view, WIDTH, HEIGHT, 1, &picture);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        sum += 1 - (double)picture.pixels[3 * i];
    hatch_arena_rewind(&frame.args.keep, mark);
    return sum / (WIDTH * HEIGHT);
}

/* The largest change of five tones since the call with `keep`. */
static double drift(const struct hatch_view *view, double first[TONES], bool keep)
{
    double most = 0;
    for (int i = 0; i < TONES; i++) {
        double ink = mean_ink(view, 0.1 * (i + 1));
        first[i] = keep ? ink : first[i];
        most = fmax(most, fabs(ink - first[i]));
    }
    return most;
}

static void print_row(const char *surface, int octave, bool alone, const struct hatch_view *view, double tone)
{
    struct zoom_error error = zoom_measure(&frame, view, WIDTH, HEIGHT, 11);
    printf("%s\t%d\t%s\t%.3g\t%.3g\t%.4f\t", surface, octave, alone ? "floats" : "pieces", error.largest_px,
           error.mean_px, (double)error.wrong / (error.wrong + error.pixels));
    printf(tone < 0 ? "\n" : "%.4f\n", tone);
}

static void zoom(const char *surface, enum hatch_shape shape, const double point[3], const double back[3], int sign)
{
    double first[TONES];
    begin(shape, sign < 0 ? 0x1p40f : 1.0f);
    for (int octave = 0; octave <= 40; octave += 2)
        for (int alone = 0; alone < 2; alone++) {
            int out = sign < 0 ? 40 - octave : octave; /* octaves zoomed in */
            struct hatch_view view = zoomed_view(&frame, point, back, exp2(1 - out), (double)WIDTH / HEIGHT);
            frame.shown.floats_alone = alone;
            double tone = shape == HATCH_SHAPE_PLANE ? drift(&view, first, !alone && octave == 0) : -1;
            print_row(surface, sign * octave, alone, &view, tone);
        }
    frame_finish(&frame);
}

START_TEST(measure)
{
    static const double on_plane[3] = {0.0371, 0.0213, 0}, from_plane[3] = {0.36, -0.48, 0.8};
    double on_torus[3] = {0, 0, 0}, from_torus[3], corner[3][3];
    printf("surface\toctave\tmethod\tlargest_px\tmean_px\tmissing\ttone_drift\n");
    zoom("plane", HATCH_SHAPE_PLANE, on_plane, from_plane, -1);
    zoom("plane", HATCH_SHAPE_PLANE, on_plane, from_plane, 1);
    frame_arenas(&frame);
    mesh = frame_shape(&frame, HATCH_SHAPE_TORUS, 2000);
    hatch_mesh_corners(&mesh, 640, corner);
    hatch_vec_triangle(corner[0], corner[1], corner[2], from_torus);
    hatch_vec_normalize(from_torus);
    for (int k = 0; k < 3; k++)
        on_torus[k] = 0.3 * corner[0][k] + 0.3 * corner[1][k] + 0.4 * corner[2][k];
    zoom("torus", HATCH_SHAPE_TORUS, on_torus, from_torus, 1);
    fflush(stdout);
}
END_TEST

HATCH_BENCH_MAIN("bench zoom", measure)
