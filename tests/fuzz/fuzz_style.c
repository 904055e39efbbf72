#include "fuzz.h"

#include "placement/style.h"

/* Values of a style must be in the ranges of its header, even after a failure. */
static void check(const struct hatch_style *style)
{
    float target[HATCH_TAM_TONES_MAX];
    bool fits = style->width_px >= 0.5f && style->width_px <= 64 && style->length_min >= 0 && style->length_max <= 4 &&
                style->length_min <= style->length_max && style->jitter_rad >= 0 && style->ink > 0 && style->ink <= 1 &&
                style->tone_max > 0 && style->tone_max <= 1 && style->direction_count >= 1 &&
                style->direction_count <= HATCH_STYLE_DIRECTIONS_MAX && style->candidates_light >= 1 &&
                style->candidates_dark >= 1;
    if (!fits || style->name[sizeof style->name - 1] || style->brush_file[sizeof style->brush_file - 1])
        abort();
    hatch_style_targets(style, HATCH_TAM_TONES_MAX, target);
    for (uint32_t i = 0; i < HATCH_TAM_TONES_MAX; i++)
        if (!(target[i] >= 0 && target[i] <= 1))
            abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_style style;
    struct hatch_err err;
    hatch_style_default(&style);
    fuzz_check(hatch_style_parse((struct hatch_bytes){data, size}, &style, &err), &err, &arenas);
    check(&style);
    fuzz_arenas_free(&arenas);
    return 0;
}
