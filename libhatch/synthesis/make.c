#include "synthesis/synthesis.h"

#include "synthesis/heeger.h"
#include "synthesis/kopf.h"

enum hatch_status hatch_synthesis_make(const struct hatch_image *picture, const struct hatch_synthesis_options *options,
                                       struct hatch_pool *pool, const struct hatch_progress *progress,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_solid *solid, struct hatch_synthesis_figures *figures,
                                       struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_synthesis_figures found = {0};
    struct hatch_solid made;
    struct hatch_image exemplar;
    enum hatch_status status =
        hatch_synthesis_exemplar(picture, options->size, scratch, scratch, &exemplar, &found, err);
    if (status == HATCH_OK)
        status = hatch_solid_make(arena, options->size, exemplar.channel_count, &made, err);
    if (status == HATCH_OK)
        status = (options->method == HATCH_SYNTHESIS_KOPF ? hatch_kopf_fill : hatch_heeger_fill)(
            &exemplar, options, pool, progress, scratch, &made, &found, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK) {
        *solid = made;
        *figures = found;
    }
    return status;
}
