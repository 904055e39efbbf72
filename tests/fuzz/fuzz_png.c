#include "fuzz.h"

#include "io/png/png.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_image image;
    struct hatch_err err;
    enum hatch_status status =
        hatch_png_read((struct hatch_bytes){data, size}, &arenas.keep, &arenas.scratch, &image, &err);
    fuzz_check(status, &err, &arenas);
    if (status == HATCH_OK)
        fuzz_touch(image.pixels, (size_t)image.width * image.height * image.channel_count * sizeof *image.pixels);
    fuzz_arenas_free(&arenas);
    return 0;
}
