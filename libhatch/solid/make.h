/* Makes solid textures from their styles. */
#ifndef HATCH_SOLID_MAKE_H
#define HATCH_SOLID_MAKE_H

#include "base/parallel.h"
#include "base/progress.h"
#include "solid/solid.h"
#include "solid/style.h"

struct hatch_solid_options {
    const struct hatch_solid_style *style; /* of a kind */
    uint32_t size;                         /* of struct hatch_solid */
    uint64_t seed;
    struct hatch_pool *pool;
    const struct hatch_progress *progress; /* may be NULL */
};

/* Returns how many bytes of scratch hatch_solid_from_style needs, about, for the strokes or points of a style, besides
 * the values of the texels: 0 for kinds that have none.
 *   size  of struct hatch_solid */
uint64_t hatch_solid_style_bytes(const struct hatch_solid_style *style, uint32_t size);

/* Makes a solid texture: grey, or coloured if the style has colours. Its numbers fit its size
 * (hatch_solid_style_fit).
 *   solid  out, in arena; the same for any number of threads
 * HATCH_LIMIT, before the work begins, when the memory for the values of all texels does not suffice. */
enum hatch_status hatch_solid_from_style(const struct hatch_solid_options *options, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_solid *solid,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
