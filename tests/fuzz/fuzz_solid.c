#include "fuzz.h"

#include "solid/style.h"

static void check_range(float value, float low, float high)
{
    if (!(value >= low && value <= high))
        abort();
}

/* Values of a style must be in the ranges that make its texture. */
static void check(const struct hatch_solid_style *style)
{
    if (style->kind == HATCH_SOLID_NO_KIND || style->kind >= HATCH_SOLID_KINDS ||
        style->color_count > HATCH_RAMP_STOPS_MAX || style->direction_count > HATCH_SOLID_DIRECTIONS_MAX ||
        style->axis > 2 || style->distance > HATCH_SOLID_F2_F1)
        abort();
    check_range(style->contrast, 0.1f, 10);
    check_range(style->scale, style->kind == HATCH_SOLID_WORLEY ? 1 : 0, 128);
    if (style->kind == HATCH_SOLID_STIPPLE)
        check_range(style->dots, 2, 64);
    if (style->kind == HATCH_SOLID_STROKES) {
        check_range(style->length, 0.01f, 0.75f);
        check_range(style->width, 0.005f, 0.1f);
        check_range(style->density, 2, 16);
    }
    for (uint32_t i = 0; i < style->direction_count; i++)
        if (!(style->directions[i].from < style->directions[i].to))
            abort();
}

/* Parses a file, and the same text as settings that follow it. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_solid_style style = {0};
    struct hatch_err err;
    for (int pass = 0; pass < 2; pass++) {
        enum hatch_status status = hatch_solid_style_parse((struct hatch_bytes){data, size}, &style, &err);
        fuzz_check(status, &err, &arenas);
        if (status == HATCH_OK)
            check(&style);
        else if (pass == 0 && style.kind != HATCH_SOLID_NO_KIND)
            abort();
    }
    fuzz_arenas_free(&arenas);
    return 0;
}
