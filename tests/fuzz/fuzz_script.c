#include "fuzz.h"

#include <stdbool.h>
#include <string.h>

#include "stroke/path.h"
#include "stroke/script.h"

#define SIZE_PX 256

/* Rounding to floats may move the narrowest widths below the limit. */
static bool has_narrowest(const struct hatch_stroke_list *strokes)
{
    for (uint32_t i = 0; i < strokes->count; i++)
        if (strokes->items[i].width_px < 1.001e-9f * SIZE_PX)
            return true;
    return false;
}

static bool is_same(struct hatch_stroke stroke, const struct hatch_stroke *other)
{
    if (!stroke.path != !other->path)
        return false;
    if (stroke.path && (stroke.path->count != other->path->count ||
                        memcmp(stroke.path->xy, other->path->xy, 2 * sizeof(float) * stroke.path->count) != 0))
        return false;
    stroke.path = other->path;
    return memcmp(&stroke, other, sizeof stroke) == 0;
}

/* Strokes that are printed and read again must be identical. */
static void check_round_trip(const struct hatch_stroke_list *strokes, struct hatch_arena *arena)
{
    struct hatch_buffer text = {.arena = arena};
    struct hatch_stroke_list again;
    struct hatch_err err;
    if (hatch_script_print(strokes->items, strokes->count, SIZE_PX, NULL, &text, &err) != HATCH_OK)
        return;
    struct hatch_bytes bytes = {text.data, text.size};
    if (hatch_script_parse(bytes, SIZE_PX, arena, &again, &err) != HATCH_OK)
        abort();
    if (again.count != strokes->count)
        abort();
    for (uint32_t i = 0; i < again.count; i++)
        if (!is_same(again.items[i], &strokes->items[i]))
            abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_stroke_list strokes;
    struct hatch_err err;
    enum hatch_status status =
        hatch_script_parse((struct hatch_bytes){data, size}, SIZE_PX, &arenas.keep, &strokes, &err);
    fuzz_check(status, &err, &arenas);
    if (status == HATCH_OK && !has_narrowest(&strokes))
        check_round_trip(&strokes, &arenas.keep);
    fuzz_arenas_free(&arenas);
    return 0;
}
