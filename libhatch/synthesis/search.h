/* The search for the matches of a volume. */
#ifndef HATCH_SYNTHESIS_SEARCH_H
#define HATCH_SYNTHESIS_SEARCH_H

#include <stdbool.h>

#include "synthesis/features.h"
#include "synthesis/volume.h"

/* Squares of 4x4 neighbourhoods of the exemplar, in which the matches are counted. */
#define HATCH_CELL_BITS 2
#define HATCH_CELLS_ACROSS (HATCH_EXEMPLAR_PITCH >> HATCH_CELL_BITS)
#define HATCH_CELLS (HATCH_CELLS_ACROSS * HATCH_CELLS_ACROSS)

static inline uint32_t hatch_cell_of(uint32_t match)
{
    return (match / HATCH_EXEMPLAR_PITCH >> HATCH_CELL_BITS) * HATCH_CELLS_ACROSS +
           (match % HATCH_EXEMPLAR_PITCH >> HATCH_CELL_BITS);
}

struct hatch_search {
    const struct hatch_exemplar *exemplar;
    const struct hatch_features *features;
    const struct hatch_volume *volume;
    const float *prices; /* [HATCH_CELLS]: a match costs its squared distance times this */
    bool exhaustive;     /* all neighbourhoods are compared, pixel by pixel */
    bool scan; /* the features of all neighbourhoods are compared; must be set where features have no similar ones */
    bool backwards; /* the order of the texels in a slice */
    uint64_t key;   /* of random numbers, new for each search */
};

/* Searches the cheapest match of each texel and axis, and puts it into the volume. Without exhaustive and scan, a texel
 * tries its match, those of the four texels beside it, moved by one pixel, what is similar to these (k-coherence: Tong
 * et al., "Synthesis of Bidirectional Texture Functions on Arbitrary Surfaces", SIGGRAPH 2002), and random ones nearer
 * and nearer to the cheapest (Barnes et al., "PatchMatch", SIGGRAPH 2009). */
enum hatch_status hatch_search_run(const struct hatch_search *search, struct hatch_pool *pool,
                                   struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the temporary memory of hatch_search_run. */
size_t hatch_search_bytes(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar,
                          struct hatch_pool *pool, const struct hatch_arena *scratch);

/* Raises the prices of cells that more than their share of the matches lie in, and lowers those of the others, so that
 * in the end all parts of the exemplar are used.
 *   counts  [HATCH_CELLS], overwritten */
void hatch_search_price(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar, uint32_t *counts,
                        float *prices);

#endif
