/* Compares where two pictures of black strokes on white have ink:
 *     ink_near REACH A B
 * prints the share of the ink of A that is near ink of B, and that of B near ink of A. The ink of a pixel is its
 * darkness in linear light. It is near ink of the other picture if that has a pixel of at least INK within REACH
 * pixels, between the middles. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "image/color.h"
#include "shared/picture.h"

#define INK 0.1f
#define REACH_MOST 64

static struct cmd_args args;

static float ink_of(const struct hatch_image *picture, size_t i)
{
    const float *at = &picture->pixels[i * picture->channel_count];
    return 1 - (picture->channel_count < 3 ? at[0] : hatch_color_luminance(at));
}

static bool has_ink_near(const struct hatch_image *picture, int column, int row, double reach)
{
    const int most = (int)reach, width = (int)picture->width, height = (int)picture->height;
    for (int y = -most; y <= most; y++)
        for (int x = -most; x <= most; x++)
            if (x * x + y * y <= reach * reach && column + x >= 0 && column + x < width && row + y >= 0 &&
                row + y < height && ink_of(picture, (size_t)(row + y) * picture->width + (size_t)(column + x)) >= INK)
                return true;
    return false;
}

/* Returns the share of the ink of a that is near ink of b. */
static double share_near(const struct hatch_image *a, const struct hatch_image *b, double reach)
{
    double near = 0, all = 0;
    for (uint32_t row = 0; row < a->height; row++)
        for (uint32_t column = 0; column < a->width; column++) {
            const double ink = (double)ink_of(a, (size_t)row * a->width + column);
            all += ink;
            if (has_ink_near(b, (int)column, (int)row, reach))
                near += ink;
        }
    return near / all;
}

int main(int argc, char **argv)
{
    static const struct cmd_option options[] = {{0}};
    static const char *const examples[] = {"ink_near 2 texture.exr strokes.exr", NULL};
    static const struct cmd_program program = {
        .name = "ink_near",
        .operands = "REACH A B",
        .summary = "measure how much of the ink of two pictures lies near the other's",
        .examples = examples,
        .options = options,
        .operands_min = 3,
        .operands_max = 3,
    };
    struct hatch_image pictures[2];
    double reach;
    cmd_begin(&program, argc, argv, &args);
    const char *text = args.operands[0];
    if (!hatch_text_number((struct hatch_text){text, strlen(text)}, &reach) || !(reach >= 0 && reach <= REACH_MOST))
        cmd_usage("'%s' is not a number from 0 to %d", text, REACH_MOST);
    for (int i = 0; i < 2; i++)
        cmd_read_picture(&args, args.operands[1 + i], 0, &args.keep, &pictures[i]);
    if (pictures[0].width != pictures[1].width || pictures[0].height != pictures[1].height)
        cmd_usage("the pictures differ in size");
    printf("%.4f\t%.4f\n", share_near(&pictures[0], &pictures[1], reach),
           share_near(&pictures[1], &pictures[0], reach));
    return cmd_end(&args, HATCH_OK);
}
