#include "fuzz.h"

#include "io/exr/exr.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_mipmap *parts = NULL;
    uint32_t count = 0;
    struct hatch_err err;
    enum hatch_status status =
        hatch_exr_read((struct hatch_bytes){data, size}, NULL, &arenas.keep, &arenas.scratch, &parts, &count, &err);
    fuzz_check(status, &err, &arenas);
    for (uint32_t i = 0; status == HATCH_OK && i < count; i++)
        for (uint32_t l = 0; l < parts[i].level_count; l++) {
            const struct hatch_image *level = &parts[i].levels[l];
            fuzz_touch(level->pixels,
                       (size_t)level->width * level->height * level->channel_count * sizeof *level->pixels);
        }
    fuzz_arenas_free(&arenas);
    return 0;
}
