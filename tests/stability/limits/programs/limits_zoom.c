/* Draws strokes at seed points on a plane from very near, by pieces of near faces or by single floats alone:
 *     limits_zoom pieces|floats OUT.png */
#include <stdio.h>

#include "../../../bench/programs/bench.h"
#include "io/png/png.h"
#include "rptam_model.h"
#include "zoom_reference.h"

enum { WIDTH = 240, HEIGHT = 180, OCTAVES = 20 };

static const char *precision, *path;
static struct test_frame frame;
static struct hatch_mesh mesh;
static struct hatch_rptam rptam;

static void write_picture(const struct hatch_image *picture)
{
    struct hatch_buffer file = {.arena = &frame.args.keep};
    HATCH_TEST_OK(hatch_png_write(picture, HATCH_PNG_SRGB, 8, NULL, &frame.args.scratch, &file, &frame.err),
                  &frame.err);
    FILE *out = fopen(path, "wb");
    ck_assert_ptr_nonnull(out);
    ck_assert_uint_eq(fwrite(file.data, 1, file.size, out), file.size);
    ck_assert_int_eq(fclose(out), 0);
}

START_TEST(draw)
{
    static const struct model_how how = {
        .layers = 2, .tile_px = 80, .length_px = 40, .width_px = 3, .angle_rad = {0.2, 1.4}, .overlap = 0.3};
    static const double point[3] = {0.3371, 0.4213, 0}, back[3] = {0.36, -0.48, 0.8};
    struct hatch_image picture;
    frame_arenas(&frame);
    mesh = frame_shape(&frame, HATCH_SHAPE_PLANE, 200);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    frame.model = &rptam;
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0.4;
    frame.shown.floats_alone = strcmp(precision, "floats") == 0;
    const struct hatch_view view = zoomed_view(&frame, point, back, exp2(-OCTAVES), (double)WIDTH / HEIGHT);
    frame_draw(&frame, "rptam", &view, WIDTH, HEIGHT, 2, &picture);
    write_picture(&picture);
    frame_finish(&frame);
}
END_TEST

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    precision = argv[1];
    path = argv[2];
    return hatch_bench_main("limits zoom", draw);
}
