#include "fuzz.h"

#include <math.h>

#include "io/svg/svg.h"
#include "stroke/path.h"

#define SIZE_PX 64

/* Strokes of a drawing must be in the ranges of a script. */
static void check_stroke(const struct hatch_stroke *stroke)
{
    if (!(stroke->x >= 0 && stroke->x < 1 && stroke->y >= 0 && stroke->y < 1))
        abort();
    if (!(stroke->width_px > 0 && stroke->width_px <= SIZE_PX) || !(stroke->tone > 0 && stroke->tone <= 1))
        abort();
    if (!(stroke->length >= 0 && stroke->length <= HATCH_PATH_LENGTH_MAX))
        abort();
    for (int c = 0; c < 3; c++)
        if (!(stroke->rgb[c] >= 0 && stroke->rgb[c] <= 1))
            abort();
    for (uint32_t i = 0; stroke->path && i < 2 * stroke->path->count; i++)
        if (!(fabsf(stroke->path->xy[i]) <= (float)HATCH_PATH_REACH_MAX))
            abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_stroke_list strokes = {0};
    struct hatch_svg_notes notes;
    struct hatch_err err;
    struct hatch_bytes file = {data, size};
    (void)hatch_svg_is(file);
    enum hatch_status status = hatch_svg_read(file, SIZE_PX, &arenas.keep, &arenas.scratch, &strokes, &notes, &err);
    fuzz_check(status, &err, &arenas);
    for (uint32_t i = 0; status == HATCH_OK && i < strokes.count; i++)
        check_stroke(&strokes.items[i]);
    fuzz_arenas_free(&arenas);
    return 0;
}
