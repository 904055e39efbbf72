#include "fuzz.h"

#include "seed/seeds.h"

/* Seed sets must have base-4 digits and survive a round trip. */
static void check(const struct hatch_seeds *seeds, struct fuzz_arenas *arenas)
{
    struct hatch_err err;
    struct hatch_seeds again;
    struct hatch_buffer file = {.arena = &arenas->keep};
    for (uint32_t i = 0; i < seeds->layer_count; i++)
        for (uint32_t k = 0; k < seeds->layers[i].count; k++)
            if (seeds->layers[i].crumbs[k] > 3)
                abort();
    if (hatch_seeds_write(seeds, "again", &file, &err) != HATCH_OK)
        return;
    enum hatch_status status =
        hatch_seeds_read((struct hatch_bytes){file.data, file.size}, &arenas->keep, &again, &err);
    if (status != HATCH_LIMIT && (status != HATCH_OK || again.layer_count != seeds->layer_count))
        abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_seeds seeds;
    struct hatch_err err;
    enum hatch_status status = hatch_seeds_read((struct hatch_bytes){data, size}, &arenas.keep, &seeds, &err);
    if (status == HATCH_OK)
        check(&seeds, &arenas);
    fuzz_check(status, &err, &arenas);
    fuzz_arenas_free(&arenas);
    return 0;
}
