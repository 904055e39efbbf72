#include "measure/ink_figures.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

#include "image/color.h"
#include "math/angle.h"

/* Classes of pixels by darkness: inked above INKED; edge between INKED and EDGE_MAX; grey between GREY_MIN and INK_MIN;
 * ink from INK_MIN on; black above EDGE_MAX. */
#define INKED 0.1f
#define EDGE_MAX 0.9f
#define GREY_MIN 0.25f
#define INK_MIN 0.75f
#define WINDOW_MIN 0.01 /* windows whose mean darkness in the reference is at most this are not compared */

float *hatch_ink_darkness(const struct hatch_image *image, struct hatch_arena *scratch, struct hatch_err *err)
{
    size_t count = (size_t)image->width * image->height;
    uint32_t channels = image->channel_count;
    float *dark = HATCH_NEW(scratch, float, count, err);
    for (size_t i = 0; dark && i < count; i++) {
        const float *at = image->pixels + i * channels;
        float light = channels < 3 ? at[0] : hatch_color_luminance(at);
        dark[i] = fminf(fmaxf(1 - light, 0), 1);
    }
    return dark;
}

/* Returns whether one of the eight neighbours of (x, y) is ink. */
static bool has_ink_next_to(const float *dark, uint32_t width, uint32_t height, uint32_t x, uint32_t y)
{
    for (uint32_t row = y ? y - 1 : 0; row <= y + 1 && row < height; row++)
        for (uint32_t column = x ? x - 1 : 0; column <= x + 1 && column < width; column++)
            if (dark[(size_t)row * width + column] >= INK_MIN)
                return true;
    return false;
}

static void count_greys(const float *dark, uint32_t width, uint32_t height, struct hatch_ink_figures *figures)
{
    uint64_t inked = 0, grey = 0, strokes = 0, black = 0;
    for (uint32_t y = 0; y < height; y++)
        for (uint32_t x = 0; x < width; x++) {
            float here = dark[(size_t)y * width + x];
            bool is_grey = here > GREY_MIN && here < INK_MIN;
            inked += here > INKED;
            grey += is_grey;
            black += here > EDGE_MAX;
            strokes += is_grey && !has_ink_next_to(dark, width, height, x, y);
        }
    figures->inked = (double)inked / ((double)width * height);
    figures->grey = inked ? (double)grey / (double)inked : NAN;
    figures->grey_strokes = inked ? (double)strokes / (double)inked : NAN;
    figures->black = inked ? (double)black / (double)inked : NAN;
}

/* Returns the sum of the changes of darkness between the pixels of all rows, columns or diagonals.
 *   right, down  from a pixel to the next: (1, 0), (0, 1), (1, 1) or (-1, 1) */
static double sum_changes(const float *dark, uint32_t width, uint32_t height, int right, int down)
{
    double sum = 0;
    for (uint32_t y = 0; y + (uint32_t)down < height; y++)
        for (uint32_t x = right < 0; x + (right > 0) < width; x++) {
            const float *here = dark + (size_t)y * width + x;
            sum += fabs((double)here[(ptrdiff_t)down * width + right] - (double)here[0]);
        }
    return sum;
}

/* Returns the mean width of strokes. A stroke of darkness d, width w and length L has the ink d w L, and d changes to 0
 * over 2 L. Cauchy and Crofton: an outline has the length pi / 2 times its mean projection, here on four directions,
 * which is up to 5 percent short or 3 long. */
static double mean_width(const float *dark, uint32_t width, uint32_t height)
{
    double ink = 0;
    for (size_t i = 0; i < (size_t)width * height; i++)
        ink += (double)dark[i];
    const double straight = sum_changes(dark, width, height, 1, 0) + sum_changes(dark, width, height, 0, 1);
    const double slanted = sum_changes(dark, width, height, 1, 1) + sum_changes(dark, width, height, -1, 1);
    const double outline = 22.5 * HATCH_RADIANS * (straight + slanted / sqrt(2));
    return outline > 0 ? 2 * ink / outline : NAN;
}

/* Returns a summed-area table: sums[y * (width + 1) + x] is the sum of the values above row y and left of column x. */
static double *sum_areas(const float *dark, uint32_t width, uint32_t height, struct hatch_arena *scratch,
                         struct hatch_err *err)
{
    size_t pitch = (size_t)width + 1;
    double *sums = HATCH_NEW(scratch, double, pitch *((size_t)height + 1), err);
    for (uint32_t y = 0; sums && y < height; y++) {
        double row = 0;
        for (uint32_t x = 0; x < width; x++) {
            row += (double)dark[(size_t)y * width + x];
            sums[(y + 1) * pitch + x + 1] = sums[y * pitch + x + 1] + row;
        }
    }
    return sums;
}

/* The darkness of a picture and of its reference, as summed-area tables. */
struct tables {
    uint32_t width, height;
    const double *got, *want;
};

/* Differences of mean darkness over windows. */
struct differences {
    double mean, magnitude, worst, squares; /* mean, mean and largest magnitude, mean square; NaN without windows */
};

/* Returns the sum over a rectangle of a summed-area table. */
static double sum_over(const double *sums, size_t pitch, size_t top, uint32_t across, uint32_t down)
{
    const size_t bottom = top + down * pitch;
    return sums[bottom + across] - sums[bottom] - sums[top + across] + sums[top];
}

/* Compares all windows of a side, or of that of the picture if it is smaller, that the reference darkens. */
static struct differences compare_windows(const struct tables *tables, uint32_t side_px)
{
    const uint32_t across = side_px < tables->width ? side_px : tables->width;
    const uint32_t down = side_px < tables->height ? side_px : tables->height;
    const size_t pitch = (size_t)tables->width + 1;
    const double area = (double)across * down;
    struct differences sum = {.mean = 0};
    uint64_t windows = 0;
    for (uint32_t y = 0; y + down <= tables->height; y++)
        for (uint32_t x = 0; x + across <= tables->width; x++) {
            double want = sum_over(tables->want, pitch, y * pitch + x, across, down) / area;
            double difference = sum_over(tables->got, pitch, y * pitch + x, across, down) / area - want;
            if (want <= WINDOW_MIN)
                continue;
            windows++;
            sum.mean += difference;
            sum.magnitude += fabs(difference);
            sum.worst = fmax(sum.worst, fabs(difference));
            sum.squares += difference * difference;
        }
    const double count = (double)windows;
    if (windows == 0)
        return (struct differences){NAN, NAN, NAN, NAN};
    return (struct differences){sum.mean / count, sum.magnitude / count, sum.worst, sum.squares / count};
}

static enum hatch_status compare_tones(const float *dark, const float *reference, uint32_t width, uint32_t height,
                                       struct hatch_arena *scratch, struct hatch_ink_figures *figures,
                                       struct hatch_err *err)
{
    const double *got = sum_areas(dark, width, height, scratch, err);
    const double *want = got ? sum_areas(reference, width, height, scratch, err) : NULL;
    const struct tables tables = {width, height, got, want};
    if (!want)
        return HATCH_LIMIT;
    const struct differences tone = compare_windows(&tables, HATCH_INK_WINDOW_PX);
    const struct differences even = compare_windows(&tables, HATCH_INK_EVEN_PX);
    figures->tone_error = tone.magnitude;
    figures->tone_worst = tone.worst;
    figures->tone_rms = sqrt(tone.squares);
    figures->uneven24 = isnan(even.mean) ? NAN : sqrt(fmax(even.squares - even.mean * even.mean, 0));
    return HATCH_OK;
}

static void compare_edges(const float *dark, const float *reference, size_t count, struct hatch_ink_figures *figures)
{
    double squares = 0;
    uint64_t edges = 0;
    for (size_t i = 0; i < count; i++) {
        double error = (double)dark[i] - (double)reference[i];
        if (reference[i] <= INKED || reference[i] >= EDGE_MAX)
            continue;
        edges++;
        squares += error * error;
    }
    figures->edge_error = edges ? sqrt(squares / (double)edges) : NAN;
}

enum hatch_status hatch_measure_ink(const struct hatch_image *picture, const struct hatch_image *reference,
                                    struct hatch_arena *scratch, struct hatch_ink_figures *figures,
                                    struct hatch_err *err)
{
    assert(!reference || (reference->width == picture->width && reference->height == picture->height));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_ink_figures found = {
        .tone_error = NAN, .tone_worst = NAN, .edge_error = NAN, .tone_rms = NAN, .uneven24 = NAN};
    uint32_t width = picture->width, height = picture->height;
    const float *dark = hatch_ink_darkness(picture, scratch, err), *want = NULL;
    enum hatch_status status = dark ? HATCH_OK : HATCH_LIMIT;
    if (dark) {
        count_greys(dark, width, height, &found);
        found.width_px = mean_width(dark, width, height);
    }
    if (dark && reference) {
        want = hatch_ink_darkness(reference, scratch, err);
        status = want ? compare_tones(dark, want, width, height, scratch, &found, err) : HATCH_LIMIT;
    }
    if (want && status == HATCH_OK)
        compare_edges(dark, want, (size_t)width * height, &found);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *figures = found;
    return status;
}
