#include "fuzz.h"

#include "needs/needs.h"

/* Numbers must be in their ranges, and never ask for more than the whole map. */
static void check(const struct hatch_needs *needs)
{
    static const float targets[] = {0.25f, 0.5f, 0.75f};
    const struct hatch_stroke_pen pen = {
        .width_px = 2, .thin = 0.5f, .join = 0.4f, .response = {1, 1, 1, 1, 1, 1, 1, 1}};
    uint32_t columns = hatch_needs_columns(needs, targets, 3, targets[2]), size_px = hatch_needs_size(needs, 256, 64);
    bool tones = needs->tolerance > 0 && needs->tolerance <= 1 && needs->darkest >= 0 && needs->darkest <= 1;
    if (!tones || columns < 1 || columns > 3 || size_px < 64 || size_px > 256 ||
        !(hatch_needs_strokes(needs, 1e30, &pen, 2) >= 0))
        abort();
    uint32_t tile_px = hatch_needs_tile(needs, 256, 64), slices = hatch_needs_slices(needs, 3, 64);
    uint32_t solid = hatch_needs_solid(needs, 64, 8);
    if (tile_px < 64 || tile_px > 256 || slices < 4 || slices > 64 || solid < 8 || solid > 64)
        abort();
    for (uint32_t i = 0; i < HATCH_NEEDS_CELLS; i++)
        if (!(needs->regions.px[i] >= 0))
            abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_needs needs;
    static float cells[HATCH_NEEDS_CELLS];
    struct hatch_err err;
    enum hatch_status status = hatch_needs_parse((struct hatch_bytes){data, size}, cells, &needs, &err);
    if (status == HATCH_OK)
        check(&needs);
    fuzz_check(status, &err, &arenas);
    fuzz_arenas_free(&arenas);
    return 0;
}
