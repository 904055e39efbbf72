#include "shared/needs/map.h"

#include <math.h>

#include "tam/whole.h"

/* Tolerance from which on a level of a map may stand for that of another, docs/notes/needs.md. */
#define LEVELS_DIFFER 0.01

struct cmd_map_part cmd_find_map_part(const struct hatch_needs *needs, const float *targets, uint32_t tones,
                                      float darkest, uint32_t size_px, uint32_t levels)
{
    uint32_t needed_px = size_px;
    struct cmd_map_part part = {.tones = hatch_needs_columns(needs, targets, tones, darkest),
                                .tolerance = needs->tolerance};
    if (needs->tolerance >= LEVELS_DIFFER)
        needed_px = hatch_needs_size(needs, size_px, HATCH_TAM_SIZE_MIN);
    while (part.finer + 1 < levels && needed_px << part.finer < size_px)
        part.finer++;
    if (part.tones < tones)
        cmd_note("%u of %u columns left out: tones over %.3g are not needed", tones - part.tones, tones,
                 (double)targets[part.tones - 1]);
    if (part.finer)
        cmd_note("levels finer than %u pixels left out", size_px >> part.finer);
    cmd_note("%.3g %% of the texels are made", 100.0 * part.tones / tones / (double)(1u << 2 * part.finer));
    return part;
}

void cmd_cut_map(const struct hatch_needs *needs, struct hatch_tam *map)
{
    const float last = map->target[map->tones - 1], darkest = fmaxf(map->whole.darkest, last);
    const struct cmd_map_part part =
        cmd_find_map_part(needs, map->target, map->tones, darkest, map->size_px, map->levels);
    if (part.tones < map->tones || part.finer > 0)
        hatch_tam_cut(map, part.tones, part.finer, part.tolerance);
}
