#include "image/color.h"

#include <string.h>

#include "image/image.h"

static int digit(char c)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)((at - digits) % 16) : -1;
}

bool hatch_color_from_hex(struct hatch_text digits, float rgb[3])
{
    if (digits.length != 3 && digits.length != 6)
        return false;
    size_t each = digits.length / 3;
    float made[3];
    for (size_t c = 0; c < 3; c++) {
        int high = digit(digits.at[c * each]), low = digit(digits.at[c * each + each - 1]);
        if (high < 0 || low < 0)
            return false;
        made[c] = hatch_srgb_to_linear((float)(16 * high + low) / 255.0f);
    }
    memcpy(rgb, made, sizeof made);
    return true;
}
