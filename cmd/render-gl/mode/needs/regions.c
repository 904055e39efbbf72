#include "render-gl/mode/needs/regions.h"

#include <math.h>
#include <string.h>

/* Turns a place back as --up has turned it (hatch_scene_turn_up): generators read the file as it is. */
static void turn_back(enum hatch_up up, double place[3])
{
    const double x = place[0], y = place[1], z = place[2];
    if (up == HATCH_UP_Z) {
        place[1] = -z;
        place[2] = y;
    } else if (up == HATCH_UP_X) {
        place[0] = y;
        place[1] = -x;
    }
}

/* Finds the box of the regions. */
static void find_box(const struct job *job, struct hatch_needs_regions *regions)
{
    const struct hatch_bounds *rest = &job->rest;
    double ends[2][3];
    for (int k = 0; k < 3; k++) {
        ends[0][k] = rest->center[k] - rest->half[k];
        ends[1][k] = rest->center[k] + rest->half[k];
    }
    turn_back(job->options->up, ends[0]);
    turn_back(job->options->up, ends[1]);
    for (int k = 0; k < 3; k++) {
        regions->low[k] = fmin(ends[0][k], ends[1][k]);
        regions->side[k] = fabs(ends[1][k] - ends[0][k]) / HATCH_NEEDS_SIDE;
    }
}

/* Raises the regions of the faces of an item that were seen.
 *   pose  at rest */
static void raise_item(struct job *job, struct hatch_pose *pose, uint32_t item, const float *unit_px,
                       struct hatch_needs_regions *regions)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    const struct hatch_mesh *surface = unit->meshes[unit->items[item].mesh].surface;
    struct hatch_arena_mark mark = hatch_arena_mark(&job->args.scratch);
    struct hatch_err err;
    double *places;
    cmd_check(HATCH_ALLOC_UNSET(&job->args.scratch, &places, 3 * (size_t)surface->vertex_count, &err), job->name, &err);
    hatch_pose_mesh(pose, unit->items[item].node, surface, places, NULL);
    for (size_t v = 0; v < surface->vertex_count; v++)
        turn_back(job->options->up, &places[3 * v]);
    for (uint32_t f = 0; f < surface->face_count; f++) {
        double corners[3][3];
        for (uint32_t c = 0; c < 3; c++)
            memcpy(corners[c], &places[3 * (size_t)surface->indices[3 * (size_t)f + c]], sizeof corners[c]);
        if (unit_px[f] > 0)
            hatch_needs_raise(regions, (const double(*)[3])corners, (double)unit_px[f]);
    }
    hatch_arena_rewind(&job->args.scratch, mark);
}

void needs_find_regions(struct job *job, const struct needs_measure *measure, struct hatch_needs_regions *regions)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    struct hatch_pose pose;
    struct hatch_err err;
    *regions = (struct hatch_needs_regions){.px = NULL};
    cmd_check(HATCH_ALLOC(&job->args.keep, &regions->px, HATCH_NEEDS_CELLS, &err), NULL, &err);
    find_box(job, regions);
    cmd_check(hatch_pose_make(&job->values, &job->args.keep, &pose, &err), job->name, &err);
    hatch_pose_set(&pose, HATCH_NONE, 0);
    for (uint32_t i = 0; i < unit->item_count; i++)
        if (!job->values.nodes[unit->items[i].node].backdrop)
            raise_item(job, &pose, i, measure->items[i].unit_px, regions);
}
