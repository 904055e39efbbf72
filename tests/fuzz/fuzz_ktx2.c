#include "fuzz.h"

#include "io/container.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_texels texture;
    struct hatch_err err;
    enum hatch_status status =
        hatch_ktx2_read((struct hatch_bytes){data, size}, &arenas.keep, &texture, &err);
    fuzz_check(status, &err, &arenas);
    for (uint32_t level = 0; status == HATCH_OK && level < texture.level_count; level++)
        fuzz_touch(texture.texels[level], hatch_texels_level_size(&texture, level));
    fuzz_arenas_free(&arenas);
    return 0;
}
