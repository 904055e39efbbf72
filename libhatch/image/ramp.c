#include "image/ramp.h"

#include "base/settings.h"
#include "image/color.h"

void hatch_ramp_color(const struct hatch_ramp_stop *stops, uint32_t count, float at, float rgb[3])
{
    uint32_t above = 0;
    while (above < count && stops[above].at < at)
        above++;
    for (int c = 0; c < 3; c++) {
        if (count == 0)
            rgb[c] = 0;
        else if (above == 0 || above == count)
            rgb[c] = stops[above ? above - 1 : 0].rgb[c];
        else
            rgb[c] = stops[above - 1].rgb[c] + (stops[above].rgb[c] - stops[above - 1].rgb[c]) *
                                                   (at - stops[above - 1].at) / (stops[above].at - stops[above - 1].at);
    }
}

enum hatch_status hatch_ramp_read(struct hatch_text *rest, const char *what, struct hatch_ramp_stop *stops,
                                  uint32_t *count, struct hatch_err *err)
{
    struct hatch_ramp_stop stop;
    struct hatch_text word;
    double at;
    HATCH_TRY(hatch_settings_next(rest, "color", 0, 1, &at, err));
    stop.at = (float)at;
    if (!hatch_text_word(rest, &word) || !hatch_color_from_hex(word, stop.rgb))
        return hatch_fail(err, HATCH_BAD_INPUT, "color: want a %s and three or six hexadecimal digits", what);
    if (*count == HATCH_RAMP_STOPS_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "more than %u color lines", HATCH_RAMP_STOPS_MAX);
    if (*count && !(stop.at > stops[*count - 1].at))
        return hatch_fail(err, HATCH_BAD_INPUT, "color: %s %g does not exceed that of the color line before", what, at);
    stops[(*count)++] = stop;
    return HATCH_OK;
}
