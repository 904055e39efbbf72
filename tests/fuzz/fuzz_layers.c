#include "fuzz.h"

#include "seed/layers.h"

/* Tone intervals and sizes of layers must be in their ranges. */
static void check(const struct hatch_layers *layers)
{
    for (uint32_t i = 0; i < layers->count; i++) {
        const struct hatch_layer_line *line = &layers->lines[i];
        bool tone = !line->tone_given || (line->low >= 0 && line->low < line->high && line->high <= 1);
        bool sizes = line->length_px >= 0 && line->width_px >= 0 && line->length_px <= 4096 && line->width_px <= 4096 &&
                     line->tile_px >= 0 && line->ink >= 0 && line->ink <= 1;
        if (!tone || !sizes || (line->stroke && !line->stroke[0]))
            abort();
    }
    if (layers->count < 1 || layers->count > HATCH_RPTAM_LAYERS_MAX)
        abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_layers layers;
    struct hatch_err err;
    enum hatch_status status = hatch_layers_read((struct hatch_bytes){data, size}, &arenas.keep, &layers, &err);
    if (status == HATCH_OK)
        check(&layers);
    fuzz_check(status, &err, &arenas);
    fuzz_arenas_free(&arenas);
    return 0;
}
