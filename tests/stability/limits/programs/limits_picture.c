/* Figures of pictures for the table of limits, beside those of hatchstat, and small copies for its page. Darkness D is
 * 1 - luminance, in linear light.
 *
 *     limits_picture small IN.png OUT.png   copies a picture with 32 values per channel
 *     limits_picture ink IN X Y W H         mean of D in a rectangle
 *     limits_picture deviation IN           standard deviation of D
 *     limits_picture repeat IN X Y          correlation of D with itself, X to the right and Y below
 *     limits_picture period IN A B          the largest of these for X from A to B, Y = 0
 *     limits_picture angle IN OTHER.png     angle in degrees between the strokes of two pictures of one size: mean over
 *                                           the pixels around which both have one direction
 *     limits_picture outside IN OTHER.png   percent of D that is where OTHER.png, of the same size, is white
 *     limits_picture pieces IN              mean number of pixels of connected ink: D > .5, over four neighbours
 *     limits_picture alike IN OTHER.png     correlation of D of two pictures of one size
 *     limits_picture seams IN PATCHES.png   mean |difference| of D between neighbours of which PATCHES.png, of the same
 *                                           size, shows two greys, over that between those of one grey
 *     limits_picture cut IN X               mean |difference| of D between the columns X - 1 and X, over that of all
 *                                           neighbouring columns
 *     limits_picture width IN               mean width of strokes in pixels: 2 sum of D / sum of |grad D|, over the
 *                                           pixels with D > .1 or such a neighbour
 *     limits_picture widths IN N            the same in windows of N x N pixels: 90th over 10th percentile
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "image/color.h"
#include "io/png/png.h"
#include "shared/cmd.h"
#include "shared/picture.h"

#define GREYS 31.0f   /* values of a small picture, less one */
#define INK_LEAST 0.1 /* darkness of strokes */
#define REACH 5       /* pixels to each side that tell the direction of strokes */
#define AGREEING_LEAST 0.3
#define INKED_LEAST 0.05 /* share of a window that strokes must cover, so that its width counts */

static struct cmd_args args;
static struct hatch_err err;
static struct hatch_image image;
static double *darkness;

static int operand(int index)
{
    double number = 0;
    const char *text = index < args.operand_count ? args.operands[index] : "";
    if (!hatch_text_number((struct hatch_text){text, strlen(text)}, &number))
        cmd_usage("'%s' is no number", text);
    return (int)number;
}

static double dark_at(int x, int y)
{
    const int right = (int)image.width - 1, bottom = (int)image.height - 1;
    x = x < 0 ? 0 : x > right ? right : x;
    y = y < 0 ? 0 : y > bottom ? bottom : y;
    return darkness[(size_t)y * image.width + (size_t)x];
}

static void read_darkness(void)
{
    const size_t count = (size_t)image.width * image.height;
    darkness = HATCH_NEW(&args.keep, double, count, &err);
    for (size_t i = 0; i < count; i++) {
        const float *pixel = &image.pixels[i * image.channel_count];
        const bool grey = image.channel_count < 3;
        darkness[i] = 1 - (grey ? (double)pixel[0] : (double)hatch_color_luminance(pixel));
    }
}

/* Reads another picture, of the same size, in place of the first. */
static void read_other(const char *path)
{
    const uint32_t width = image.width, height = image.height;
    cmd_read_picture(&args, path, 1, &args.keep, &image);
    if (image.width != width || image.height != height)
        cmd_usage("'%s' has another size", path);
    read_darkness();
}

/* Mean of (D(x, y) - mean) (D(x + dx, y + dy) - mean) over the pixels that have both. */
static double covariance(int dx, int dy)
{
    double sum = 0, shifted = 0, product = 0;
    size_t count = 0;
    for (int y = 0; y + dy < (int)image.height; y++)
        for (int x = 0; x + dx < (int)image.width; x++, count++) {
            sum += dark_at(x, y);
            shifted += dark_at(x + dx, y + dy);
            product += dark_at(x, y) * dark_at(x + dx, y + dy);
        }
    return product / (double)count - sum / (double)count * (shifted / (double)count);
}

/* Mean |difference| of darkness between a column and the one to its left. */
static double change_at(int column)
{
    double sum = 0;
    for (int y = 0; y < (int)image.height; y++)
        sum += fabs(dark_at(column, y) - dark_at(column - 1, y));
    return sum / image.height;
}

static double cut_at(int column)
{
    double sum = 0;
    for (int x = 1; x < (int)image.width; x++)
        sum += change_at(x);
    return change_at(column) * (image.width - 1) / sum;
}

/* The direction of the strokes around a pixel, from the structure tensor: a vector at twice the angle of the gradient,
 * whose length is the share of the gradients that agree. */
static void direction_at(int column, int row, double way[2])
{
    double along = 0, aslant = 0, all = 0;
    for (int y = row - REACH; y <= row + REACH; y++)
        for (int x = column - REACH; x <= column + REACH; x++) {
            const double dx = dark_at(x + 1, y) - dark_at(x - 1, y), dy = dark_at(x, y + 1) - dark_at(x, y - 1);
            along += dx * dx - dy * dy;
            aslant += 2 * dx * dy;
            all += dx * dx + dy * dy;
        }
    way[0] = all > 0 ? along / all : 0;
    way[1] = all > 0 ? aslant / all : 0;
}

/* Computes the directions at all pixels. */
static double *directions(void)
{
    double *ways = HATCH_NEW(&args.keep, double, 2 * (size_t)image.width * image.height, &err);
    for (int i = 0; i < (int)(image.width * image.height); i++)
        direction_at(i % (int)image.width, i / (int)image.width, &ways[2 * (size_t)i]);
    return ways;
}

static double angle_to(const char *other)
{
    double *ways[2] = {directions()}, sum = 0;
    const size_t count = (size_t)image.width * image.height;
    size_t compared = 0;
    read_other(other);
    ways[1] = directions();
    for (size_t i = 0; i < count; i++) {
        const double *a = &ways[0][2 * i], *b = &ways[1][2 * i];
        if (hypot(a[0], a[1]) < AGREEING_LEAST || hypot(b[0], b[1]) < AGREEING_LEAST)
            continue;
        sum += fabs(atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])) / 2;
        compared++;
    }
    return compared ? sum / (double)compared * 180 / 3.14159265358979 : 0;
}

static double likeness_to(const char *other)
{
    const double *first = darkness, own = covariance(0, 0);
    const size_t count = (size_t)image.width * image.height;
    double sum[2] = {0, 0}, product = 0;
    read_other(other);
    for (size_t i = 0; i < count; i++) {
        sum[0] += first[i];
        sum[1] += darkness[i];
        product += first[i] * darkness[i];
    }
    return (product - sum[0] * sum[1] / (double)count) / (double)count / sqrt(own * covariance(0, 0));
}

static double seams_of(const char *patches)
{
    const double *ink = darkness;
    double change[2] = {0, 0};
    size_t count[2] = {0, 0};
    read_other(patches);
    for (int i = (int)image.width; i < (int)(image.width * image.height); i++) {
        const int before[2] = {i - 1, i - (int)image.width};
        for (int k = 0; k < 2; k++) {
            if (darkness[i] <= 0 || darkness[before[k]] <= 0)
                continue;
            const int crossing = darkness[i] != darkness[before[k]];
            change[crossing] += fabs(ink[i] - ink[before[k]]);
            count[crossing]++;
        }
    }
    return change[1] / (double)count[1] / (change[0] / (double)count[0]);
}

/* Returns the piece of a pixel: the first one that is linked to it. */
static int first_of(int *linked, int pixel)
{
    while (linked[pixel] != pixel)
        pixel = linked[pixel] = linked[linked[pixel]];
    return pixel;
}

static double mean_piece(void)
{
    const int width = (int)image.width, count = width * (int)image.height;
    int *linked = HATCH_NEW(&args.keep, int, (size_t)count, &err), inked = 0, pieces = 0;
    for (int i = 0; i < count; i++) {
        linked[i] = i;
        if (darkness[i] <= 0.5)
            continue;
        inked++;
        pieces++;
        const int before[2] = {i % width ? i - 1 : i, i >= width ? i - width : i};
        for (int k = 0; k < 2; k++) {
            const int piece = first_of(linked, i), other = first_of(linked, before[k]);
            if (darkness[before[k]] > 0.5 && piece != other) {
                linked[piece] = other;
                pieces--;
            }
        }
    }
    return pieces ? (double)inked / pieces : 0;
}

static double share_outside(const char *mask)
{
    const double *ink = darkness;
    const size_t count = (size_t)image.width * image.height;
    double all = 0, outside = 0;
    read_other(mask);
    for (size_t i = 0; i < count; i++) {
        all += ink[i];
        outside += darkness[i] > 0 ? 0 : ink[i];
    }
    return 100 * outside / all;
}

static double strongest_period(int least, int most)
{
    double strongest = -1;
    for (int by = least; by <= most; by++)
        strongest = fmax(strongest, covariance(by, 0));
    return strongest / covariance(0, 0);
}

static double mean_ink(int left, int top, int width, int height)
{
    double sum = 0;
    for (int y = top; y < top + height; y++)
        for (int x = left; x < left + width; x++)
            sum += dark_at(x, y);
    return sum / ((double)width * height);
}

/* Returns the width of the strokes in a rectangle; 0 if there are too few. */
static double width_of_strokes(int left, int top, int width, int height)
{
    double area = 0, border = 0;
    int inked = 0;
    for (int y = top; y < top + height; y++)
        for (int x = left; x < left + width; x++) {
            inked += dark_at(x, y) > INK_LEAST;
            area += dark_at(x, y);
            border += hypot(dark_at(x + 1, y) - dark_at(x - 1, y), dark_at(x, y + 1) - dark_at(x, y - 1)) / 2;
        }
    return inked > INKED_LEAST * width * height && border > 0 ? 2 * area / border : 0;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double spread_of_widths(int side)
{
    const int columns = (int)image.width / side, rows = (int)image.height / side;
    double *widths = HATCH_NEW(&args.keep, double, (size_t)(columns * rows), &err);
    size_t count = 0;
    for (int i = 0; i < columns * rows; i++) {
        widths[count] = width_of_strokes(i % columns * side, i / columns * side, side, side);
        count += widths[count] > 0;
    }
    qsort(widths, count, sizeof *widths, ascending);
    return count ? widths[count * 9 / 10] / widths[count / 10] : 0;
}

static void make_small(const char *path)
{
    struct hatch_buffer file = {.arena = &args.keep};
    struct cmd_output *output = cmd_open_output(path, "png", true);
    const size_t count = (size_t)image.width * image.height;
    bool grey = true;
    for (size_t i = 0; i < count && image.channel_count >= 3; i++)
        grey = grey && image.pixels[i * image.channel_count] == image.pixels[i * image.channel_count + 1] &&
               image.pixels[i * image.channel_count] == image.pixels[i * image.channel_count + 2];
    const uint32_t channels = grey ? 1 : 3;
    struct hatch_image small;
    cmd_check(hatch_image_make(&args.keep, image.width, image.height, grey ? "Y" : "RGB", &small, &err), path, &err);
    for (size_t i = 0; i < count; i++)
        for (uint32_t c = 0; c < channels; c++) {
            float value = hatch_linear_to_srgb(image.pixels[i * image.channel_count + c]);
            small.pixels[i * channels + c] = hatch_srgb_to_linear(roundf(value * GREYS) / GREYS);
        }
    cmd_check(hatch_png_write(&small, HATCH_PNG_SRGB, 8, NULL, &args.scratch, &file, &err), path, &err);
    cmd_write(output, file.data, file.size);
}

static double figure_of(int name, const char *other)
{
    switch (name) {
    case 1:
        return mean_ink(operand(2), operand(3), operand(4), operand(5));
    case 2:
        return sqrt(covariance(0, 0));
    case 3:
        return covariance(operand(2), operand(3)) / covariance(0, 0);
    case 4:
        return strongest_period(operand(2), operand(3));
    case 5:
        return angle_to(other);
    case 6:
        return share_outside(other);
    case 7:
        return likeness_to(other);
    case 8:
        return seams_of(other);
    case 9:
        return mean_piece();
    case 10:
        return cut_at(operand(2));
    case 11:
        return width_of_strokes(0, 0, (int)image.width, (int)image.height);
    default:
        return spread_of_widths(operand(2));
    }
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"small", "ink",   "deviation", "repeat", "period", "angle",  "outside",
                                        "alike", "seams", "pieces",    "cut",    "width",  "widths", NULL};
    static const struct cmd_option options[] = {{0}};
    static const char *const examples[] = {"limits_picture width picture.png", NULL};
    static const struct cmd_program program = {.name = "limits_picture",
                                               .operands = "FIGURE PICTURE [OTHER | NUMBER ...]",
                                               .summary = "figures of pictures for the table of limits",
                                               .examples = examples,
                                               .options = options,
                                               .names = names,
                                               .operands_min = 2,
                                               .operands_max = 6};
    cmd_begin(&program, argc, argv, &args);
    const char *other = args.operand_count > 2 ? args.operands[2] : "-";
    cmd_read_picture(&args, args.operands[1], 1, &args.keep, &image);
    read_darkness();
    if (args.name == 0)
        make_small(other);
    else
        printf("%.6g\n", figure_of(args.name, other));
    return cmd_end(&args, HATCH_OK);
}
