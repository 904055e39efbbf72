/* Measures what changes between the frames of a film besides the motion itself:
 *     flicker [--paper FILE] [--rate FPS] SCENE AZIMUTH STEP ELEVATION FRAME FRAME ...
 * The frames are pictures of SCENE by render-gl --from AZIMUTH:ELEVATION, with the azimuth rising by STEP degrees; with
 * --rate, of its first animation, at FPS frames per second from its beginning. Each pixel of a frame but the first is
 * followed to the place where its point of the surface was in the frame before, and compared with that frame there,
 * interpolated between pixels by Catmull-Rom splines. Frames are blurred first, by means over 3 x 3 pixels taken twice,
 * because a sharp line that moves by a part of a pixel cannot be interpolated. With --paper, the picture FILE takes the
 * place of all frames: a texture that stays with the screen.
 * Standard output gets the mean of the magnitude of the difference of luminance over all pixels whose point is visible
 * in both frames; the share of such pixels among those that show the surface; and the share of ink that is kept: of
 * the ink of a pixel of the frame before, not blurred, as much as the darkest of 3 x 3 pixels around its place has. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "image/color.h"
#include "math/angle.h"
#include "math/vector.h"
#include "shared/picture.h"
#include "shared/scene.h"
#include "vector/project.h"
#include "vector/step.h"

#define FOV_DEG 30 /* render-gl's default */
#define SAME 0.005 /* relative difference in depth of what counts as the same point */
#define MEANS 2
#define OPERANDS_BEFORE 4 /* operands before the frames */

static struct cmd_args args;
static struct hatch_err err;
static const char *paper;
static double rate; /* frames per second; 0: the scene is at rest */

/* A frame, and the faces of its view. */
struct shot {
    struct hatch_arena arena;
    uint32_t width, height;
    float *luminance; /* blurred */
    float *ink;       /* 1 - luminance, not blurred */
    struct hatch_occluders occluders;
};

/* Sums over the pixels of all frames. */
struct sums {
    double difference, ink, kept;
    uint64_t shown, compared;
};

/* Returns where a point of a face that is visible at a place of one view lies in another: homogeneous coordinates. */
static void follow(const struct hatch_occluders *from, const struct hatch_occluders *to, uint32_t face,
                   const double at_px[2], double out[3])
{
    const double at[3] = {at_px[0], at_px[1], 1};
    double corners[3][3], weights[3];
    for (uint32_t c = 0; c < 3; c++)
        memcpy(corners[c], &from->points[3 * (size_t)from->corners[3 * (size_t)face + c]], sizeof corners[c]);
    for (uint32_t c = 0; c < 3; c++) {
        double across[3];
        hatch_vec_cross(corners[(c + 1) % 3], corners[(c + 2) % 3], across);
        weights[c] = hatch_vec_dot(across, at);
    }
    const double sum = weights[0] + weights[1] + weights[2];
    memset(out, 0, 3 * sizeof *out);
    for (uint32_t c = 0; c < 3; c++)
        hatch_vec_add_scaled(out, weights[c] / sum, &to->points[3 * (size_t)to->corners[3 * (size_t)face + c]], out);
}

/* Computes the means over 3 x 3 pixels, fewer at the border. */
static void blur(const float *from, uint32_t width, uint32_t height, float *to)
{
    for (uint32_t row = 0; row < height; row++)
        for (uint32_t column = 0; column < width; column++) {
            double sum = 0;
            uint32_t count = 0;
            for (uint32_t y = row ? row - 1 : 0; y <= row + 1 && y < height; y++)
                for (uint32_t x = column ? column - 1 : 0; x <= column + 1 && x < width; x++, count++)
                    sum += (double)from[(size_t)y * width + x];
            to[(size_t)row * width + column] = (float)(sum / count);
        }
}

/* Reads a frame and blurs its luminance. */
static void read_frame(const char *path, struct shot *shot)
{
    struct hatch_image picture;
    float *means[2];
    cmd_read_picture(&args, path, 0, &shot->arena, &picture);
    const size_t count = (size_t)picture.width * picture.height;
    shot->width = picture.width;
    shot->height = picture.height;
    for (int k = 0; k < 2; k++)
        cmd_check(HATCH_ALLOC(&shot->arena, &means[k], count, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(&shot->arena, &shot->ink, count, &err), NULL, &err);
    for (size_t i = 0; i < count; i++) {
        const float *at = &picture.pixels[i * picture.channel_count];
        means[0][i] = picture.channel_count < 3 ? at[0] : hatch_color_luminance(at);
        shot->ink[i] = 1 - means[0][i];
    }
    for (int i = 0; i < MEANS; i++)
        blur(means[i % 2], shot->width, shot->height, means[1 - i % 2]);
    shot->luminance = means[MEANS % 2];
}

/* Computes the weights of four pixels in a row for the place `at`, 0 .. 1, between the middle two. */
static void find_weights(double at, double weights[4])
{
    const double rest = 1 - at;
    weights[0] = -0.5 * at * rest * rest;
    weights[1] = rest * (1 + at - 1.5 * at * at);
    weights[2] = at * (1 + rest - 1.5 * rest * rest);
    weights[3] = -0.5 * at * at * rest;
}

/* Returns the luminance at a place at least two pixels from the border. */
static double luminance_at(const struct shot *shot, const double at_px[2])
{
    const double x = at_px[0] - 0.5, y = shot->height - at_px[1] - 0.5;
    const uint32_t column = (uint32_t)x - 1, row = (uint32_t)y - 1;
    double across[4], down[4], sum = 0;
    find_weights(x - floor(x), across);
    find_weights(y - floor(y), down);
    for (uint32_t k = 0; k < 16; k++)
        sum +=
            down[k / 4] * across[k % 4] * (double)shot->luminance[(size_t)(row + k / 4) * shot->width + column + k % 4];
    return sum;
}

/* Finds the place in one frame of the point that a pixel of another shows. Returns false if it shows none, or if the
 * place is hidden, or less than two pixels from the border.
 *   shown  in, out: increased if the pixel shows a point; or NULL */
static bool find_place(const struct shot *from, const struct shot *to, const uint32_t pixel[2], uint64_t *shown,
                       double place_px[2])
{
    const double at_px[2] = {pixel[0] + 0.5, from->height - pixel[1] - 0.5};
    double depth, there[3];
    const struct hatch_occluder *face = hatch_occluders_find(&from->occluders, at_px, &depth);
    if (!face)
        return false;
    if (shown)
        ++*shown;
    follow(&from->occluders, &to->occluders, face->face, at_px, there);
    place_px[0] = there[0] / there[2];
    place_px[1] = there[1] / there[2];
    return fmin(place_px[0], place_px[1]) >= 2 && place_px[0] <= from->width - 2 && place_px[1] <= from->height - 2 &&
           fabs(hatch_occluders_depth(&to->occluders, place_px) / there[2] - 1) < SAME;
}

static void compare_pixel(const struct shot *before, const struct shot *now, uint32_t column, uint32_t row,
                          struct sums *sums)
{
    const uint32_t pixel[2] = {column, row};
    double place_px[2];
    if (find_place(now, before, pixel, &sums->shown, place_px)) {
        sums->compared++;
        sums->difference +=
            fabs((double)now->luminance[(size_t)row * now->width + column] - luminance_at(before, place_px));
    }
    if (!find_place(before, now, pixel, NULL, place_px))
        return;
    const size_t middle = (size_t)(now->height - place_px[1]) * now->width + (size_t)place_px[0];
    float ink = before->ink[(size_t)row * before->width + column], darkest = 0;
    for (size_t k = 0; k < 9; k++)
        darkest = fmaxf(darkest, now->ink[middle + k / 3 * now->width + k % 3 - now->width - 1]);
    sums->ink += (double)ink;
    sums->kept += (double)fminf(ink, darkest);
}

/* Reads a frame, and finds the faces of its view.
 *   frame, frames  its number, from 0, and the number of all */
static void take(const struct hatch_scene *scene, const double from_deg[2], int frame, int frames, struct shot *shot)
{
    const bool moves = rate > 0;
    const struct hatch_film film = {
        .animation = moves ? 0 : HATCH_NONE, .rate = moves ? rate : 1, .frames = (uint32_t)frames};
    const struct hatch_view_choice choice = {.kind = HATCH_VIEW_FRAMED,
                                             .azimuth_rad = from_deg[0] * HATCH_RADIANS,
                                             .elevation_rad = from_deg[1] * HATCH_RADIANS,
                                             .fov_rad = FOV_DEG * HATCH_RADIANS};
    struct hatch_arena *arena = &shot->arena;
    struct hatch_pose_span span;
    struct hatch_bounds bounds;
    struct hatch_pose pose;
    struct hatch_unit_scene unit;
    struct hatch_view view;
    hatch_arena_init(arena, args.max_memory);
    read_frame(paper ? paper : args.operands[OPERANDS_BEFORE + frame], shot);
    const double width = shot->width, height = shot->height;
    const struct hatch_framing framing = {&span, &bounds, width / height};
    cmd_check(hatch_film_span(scene, &film, arena, &span, &err), NULL, &err);
    cmd_check(hatch_pose_make(scene, arena, &pose, &err), NULL, &err);
    cmd_check(hatch_pose_bounds(&pose, &span, &args.scratch, &bounds, &err), NULL, &err);
    cmd_check(hatch_view_make(&choice, &pose, &framing, &args.scratch, &view, &err), NULL, &err);
    cmd_check(hatch_unit_scene_make(scene, NULL, &bounds, arena, &unit, &err), NULL, &err);
    hatch_unit_scene_pose(&unit, span.animation, moves ? frame / rate : 0);
    cmd_check(hatch_occluders_make(&unit, &view, width, height, arena, &args.scratch, &shot->occluders, &err), NULL,
              &err);
}

static double number_of(const char *text)
{
    double number;
    if (!hatch_text_number((struct hatch_text){text, strlen(text)}, &number) || !(fabs(number) <= 360))
        cmd_usage("'%s' is not a number from -360 to 360", text);
    return number;
}

int main(int argc, char **argv)
{
    static const struct cmd_option options[] = {{.name = "paper",
                                                 .type = CMD_TEXT,
                                                 .metavariable = "FILE",
                                                 .help = "a picture instead of all frames",
                                                 .value = &paper},
                                                {.name = "rate",
                                                 .type = CMD_REAL,
                                                 .minimum = 0,
                                                 .maximum = 1000,
                                                 .metavariable = "FPS",
                                                 .help = "frames per second of the animation (default 0: rest)",
                                                 .value = &rate},
                                                {0}};
    static const char *const examples[] = {"flicker torus.glb 30 1 0 turn0.exr turn1.exr", NULL};
    static const struct cmd_program program = {
        .name = "flicker",
        .operands = "SCENE AZIMUTH STEP ELEVATION FRAME FRAME ...",
        .summary = "measure what changes between the frames of a turntable besides the motion",
        .examples = examples,
        .options = options,
        .operands_min = 6,
        .operands_max = -1,
    };
    static struct shot shots[2];
    struct hatch_scene scene;
    struct sums sums = {0, 0, 0, 0, 0};
    cmd_begin(&program, argc, argv, &args);
    cmd_read_scene(&args, args.operands[0], CMD_SCENE_AS_IS, &scene);
    if (rate > 0 && !scene.animation_count)
        cmd_usage("%s has no animation", args.operands[0]);
    const int frames = args.operand_count - OPERANDS_BEFORE;
    for (int i = 0; i < frames; i++) {
        struct shot *now = &shots[i % 2];
        const double turn = i * number_of(args.operands[2]);
        take(&scene, (const double[]){number_of(args.operands[1]) + turn, number_of(args.operands[3])}, i, frames, now);
        for (uint32_t pixel = 0; i > 0 && pixel < now->width * now->height; pixel++)
            compare_pixel(&shots[1 - i % 2], now, pixel % now->width, pixel / now->width, &sums);
        if (i > 0)
            hatch_arena_free(&shots[1 - i % 2].arena);
    }
    printf("%.5f\t%.4f\t%.4f\n", sums.difference / (double)sums.compared, (double)sums.compared / (double)sums.shown,
           sums.kept / sums.ink);
    return cmd_end(&args, HATCH_OK);
}
