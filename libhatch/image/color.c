#include "image/color.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#define DEGREES_PER_RADIAN 57.29577951308232

static int digit(char c)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)((at - digits) % 16) : -1;
}

bool hatch_color_from_hex_alpha(struct hatch_text digits, float rgba[4])
{
    const size_t channels = digits.length % 4 == 0 ? 4 : 3, each = digits.length / channels;
    float made[4] = {0, 0, 0, 1};
    if (digits.length != each * channels || each < 1 || each > 2)
        return false;
    for (size_t c = 0; c < channels; c++) {
        int high = digit(digits.at[c * each]), low = digit(digits.at[c * each + each - 1]);
        if (high < 0 || low < 0)
            return false;
        float value = (float)(16 * high + low) / 255.0f;
        made[c] = c < 3 ? hatch_srgb_to_linear(value) : value;
    }
    memcpy(rgba, made, sizeof made);
    return true;
}

bool hatch_color_from_hex(struct hatch_text digits, float rgb[3])
{
    float made[4];
    if (digits.length % 3 != 0 || !hatch_color_from_hex_alpha(digits, made))
        return false;
    memcpy(rgb, made, 3 * sizeof *made);
    return true;
}

void hatch_color_chroma(const struct hatch_image *image, double chroma[2])
{
    assert(image->channel_count >= 3);
    size_t pixels = (size_t)image->width * image->height;
    double sum[3] = {0, 0, 0};
    const float *p = image->pixels;
    for (size_t i = 0; i < pixels; i++, p += image->channel_count)
        for (int c = 0; c < 3; c++)
            sum[c] += (double)p[c];
    chroma[0] = (sum[0] - (sum[1] + sum[2]) / 2) / (double)pixels;
    chroma[1] = (sum[1] - sum[2]) * 0.86602540378443865 / (double)pixels;
}

double hatch_color_hue_between(const double a[2], const double b[2])
{
    double cross = a[0] * b[1] - a[1] * b[0], dot = a[0] * b[0] + a[1] * b[1];
    return atan2(fabs(cross), dot) * DEGREES_PER_RADIAN;
}

const char *const hatch_color_names[] = {"black", "white", "grey", "gray", "cream", "sepia", "blue", "red", NULL};

bool hatch_color_parse(struct hatch_text text, float rgb[3])
{
    static const char *const values[] = {"#000",    "#fff",    "#808080", "#808080",
                                         "#f7f0dd", "#4b2e18", "#1f3a6e", "#8c1c13"};
    for (size_t i = 0; hatch_color_names[i]; i++)
        if (hatch_text_is(text, hatch_color_names[i]))
            text = (struct hatch_text){values[i], strlen(values[i])};
    if (text.length == 0 || text.at[0] != '#')
        return false;
    return hatch_color_from_hex((struct hatch_text){text.at + 1, text.length - 1}, rgb);
}
