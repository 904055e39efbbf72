#include "solid/zoom/ranks.h"

#include <string.h>

#include "solid/equalize.h"
#include "solid/zoom.h"

#define FEW 128u /* equal values are few if they are at most this part of the texels */

struct ordering {
    const struct hatch_solid *solid;
    struct hatch_texels mips;
    float *keys; /* of the texels, in the order of their ranks */
};

/* Sets the keys of a slice: the values and, below 1, the mean of the surroundings of all sizes. */
static void set_keys(void *context, uint32_t z)
{
    const struct ordering *o = context;
    const uint32_t size = o->solid->size;
    const float finer = 1.0f / (float)o->mips.level_count;
    size_t i = (size_t)z * size * size;
    for (uint32_t y = 0; y < size; y++)
        for (uint32_t x = 0; x < size; x++, i++) {
            const float place[3] = {((float)x + 0.5f) / (float)size, ((float)y + 0.5f) / (float)size,
                                    ((float)z + 0.5f) / (float)o->solid->depth};
            float around = 0, mean[3];
            for (uint32_t level = 1; level < o->mips.level_count; level++) {
                hatch_zoom_sample(&o->mips, (float)level, place, mean);
                around += finer * mean[0];
            }
            o->keys[i] = (float)o->solid->texels[i] + around;
        }
}

static enum hatch_status order(const struct hatch_solid *solid, struct hatch_pool *pool, struct hatch_arena *scratch,
                               uint8_t *ranks, struct hatch_err *err)
{
    struct ordering ordering = {.solid = solid};
    uint32_t count = (uint32_t)hatch_solid_count(solid);
    HATCH_TRY(hatch_solid_mips(solid, scratch, &ordering.mips, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &ordering.keys, count, err));
    hatch_parallel_for(pool, solid->depth, set_keys, &ordering);
    return hatch_equalize(ordering.keys, count, pool, scratch, ranks, err);
}

enum hatch_status hatch_zoom_rank(struct hatch_solid *solid, struct hatch_pool *pool, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_err *err)
{
    const uint8_t *from = solid->texels;
    size_t count = hatch_solid_count(solid), below = 0, most = 0, counts[256] = {0};
    struct hatch_solid made;
    uint8_t middles[256];
    HATCH_TRY(hatch_solid_make_like(arena, solid, solid->size, 1, &made, err));
    for (size_t i = 0; i < count; i++)
        counts[from[i]]++;
    for (size_t value = 0; value < 256; below += counts[value++]) {
        middles[value] = hatch_unorm8((float)(((double)below + 0.5 * (double)counts[value]) / (double)count));
        most = counts[value] > most ? counts[value] : most;
    }
    if (most > count / FEW)
        HATCH_TRY(order(solid, pool, scratch, made.texels, err));
    else
        for (size_t i = 0; i < count; i++)
            made.texels[i] = middles[from[i]];
    *solid = made;
    return HATCH_OK;
}
