/* The part of a tonal art map that views need. */
#ifndef SHARED_NEEDS_MAP_H
#define SHARED_NEEDS_MAP_H

#include "shared/needs/needs.h"
#include "tam/tam.h"

struct cmd_map_part {
    uint32_t tones;   /* columns that are needed, the first ones */
    uint32_t finer;   /* finest levels that are not */
    double tolerance; /* of the needs */
};

/* Finds the part of a map that views need; says what is left out, and the share of the texels that stays.
 *   targets  tones of the map's columns, ascending
 *   tones    number of columns
 *   darkest  as for hatch_needs_columns
 *   size_px  side of the finest level
 *   levels   drawn levels, of which the coarsest stays; 1: all stay */
struct cmd_map_part cmd_find_map_part(const struct hatch_needs *needs, const float *targets, uint32_t tones,
                                      float darkest, uint32_t size_px, uint32_t levels);

/* Leaves out of a map what views do not need. */
void cmd_cut_map(const struct hatch_needs *needs, struct hatch_tam *map);

#endif
