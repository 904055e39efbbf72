#include "fuzz.h"

#include "image/block_compress.h"
#include "io/texture/container.h"
#include "tam/exact.h"
#include "tam/thresholds.h"
#include "tam/volume.h"

#define BYTES_MAX ((size_t)1 << 20) /* of textures that are unpacked and sampled, for speed */

/* Opens a texture as each kind that it may be and samples it. */
static void open_kinds(const struct hatch_texels *texture, const char *const *keys, struct fuzz_arenas *arenas)
{
    struct hatch_err err;
    struct hatch_texels plain;
    struct hatch_volume volume;
    struct hatch_thresholds thresholds;
    struct hatch_exact exact;
    static const float coordinates[] = {0, 0.3f, 0.999f, 1, -7.5f};
    enum hatch_status unpacked = hatch_texels_decompress(texture, &arenas->keep, &plain, &err);
    fuzz_check(unpacked, &err, arenas);
    bool is_volume = unpacked == HATCH_OK && hatch_volume_from_texels(&plain, keys, &volume, &err) == HATCH_OK;
    bool is_thresholds = hatch_thresholds_decompress(texture, &arenas->keep, &plain, &err) == HATCH_OK &&
                         hatch_thresholds_from_texels(&plain, keys, &thresholds, &err) == HATCH_OK;
    bool is_exact = hatch_exact_from_texels(texture, &exact, &err) == HATCH_OK;
    for (size_t i = 0; i < sizeof coordinates / sizeof *coordinates; i++) {
        float value[4], at = coordinates[i];
        if (is_volume)
            hatch_volume_sample(&volume, at, -at, at, 3 * at, true, value);
        if (is_thresholds)
            hatch_thresholds_sample(&thresholds, at, -at, at, 3 * at);
        if (is_exact)
            hatch_exact_sample(&exact, at, -at, at, 3 * at);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_bytes file = {data, size};
    struct hatch_texels texture;
    struct hatch_err err;
    const char *const *keys = NULL;
    enum hatch_status status = hatch_ktx2_read(file, &arenas.keep, &texture, &err);
    fuzz_check(status, &err, &arenas);
    enum hatch_status keyed = hatch_ktx2_read_keys(file, &arenas.keep, &keys, &err);
    fuzz_check(keyed, &err, &arenas);
    size_t bytes = 0;
    for (uint32_t level = 0; status == HATCH_OK && level < texture.level_count; level++) {
        bytes += hatch_texels_level_size(&texture, level);
        fuzz_touch(texture.texels[level], hatch_texels_level_size(&texture, level));
    }
    if (status == HATCH_OK && bytes <= BYTES_MAX)
        open_kinds(&texture, keyed == HATCH_OK ? keys : NULL, &arenas);
    fuzz_arenas_free(&arenas);
    return 0;
}
