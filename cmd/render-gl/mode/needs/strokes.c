#include "render-gl/mode/needs/strokes.h"

#include <math.h>

#include "placement/style.h"
#include "scene/extent.h"
#include "trace/finer.h"

/* Finds how many strokes of a family are wanted in a pixel of each tone. */
static void find_per_px(const struct job *job, uint32_t families, double per_px[HATCH_NEEDS_TONES])
{
    struct hatch_style style;
    hatch_style_default(&style);
    style.pen.width_px = style.width_px;
    for (uint32_t i = 0; i < HATCH_NEEDS_TONES; i++) {
        struct hatch_needs needs = {.darkest = 1, .relative = !job->options->tone_range_given};
        needs.unit_px[i] = 1;
        per_px[i] = hatch_needs_strokes(&needs, 1, &style.pen, families);
    }
}

void needs_strokes_find(struct job *job, struct needs_strokes *items)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    struct hatch_scene_extent extent;
    struct hatch_err err;
    if (!(job->options->technique->features & TECHNIQUE_TRACED))
        return;
    cmd_check(hatch_scene_find_extent(&job->values, &job->args.keep, &job->args.scratch, &extent, &err), job->name,
              &err);
    for (uint32_t i = 0; i < unit->item_count; i++) {
        const uint32_t index = unit->items[i].mesh;
        const struct hatch_curves *curves = &job->values.meshes[index].curves;
        if (!unit->items[i].deformed || curves->set_count == 0 || !(curves->needs > 0))
            continue;
        items[i].tolerance = (double)curves->needs;
        items[i].most = HATCH_FINER_START / ((double)curves->finest * extent.scale[index]);
        find_per_px(job, curves->sets[curves->set_count - 1].family + 1, items[i].per_px);
    }
}
