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

/* The surfaces of all items at rest, in world coordinates. */
struct rest {
    double **places; /* per item: 3 per vertex of its surface */
    double low[3], high[3];
};

static void find_rest(struct job *job, struct rest *rest)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    struct hatch_arena *keep = &job->args.keep;
    struct hatch_pose pose;
    struct hatch_err err;
    cmd_check(hatch_pose_make(&job->values, keep, &pose, &err), job->name, &err);
    cmd_check(HATCH_ALLOC(keep, &rest->places, unit->item_count, &err), job->name, &err);
    hatch_pose_set(&pose, HATCH_NONE, 0);
    for (int k = 0; k < 3; k++) {
        rest->low[k] = INFINITY;
        rest->high[k] = -INFINITY;
    }
    for (uint32_t i = 0; i < unit->item_count; i++) {
        const struct hatch_mesh *surface = unit->meshes[unit->items[i].mesh].surface;
        cmd_check(HATCH_ALLOC_UNSET(keep, &rest->places[i], 3 * (size_t)surface->vertex_count, &err), job->name, &err);
        hatch_pose_mesh(&pose, unit->items[i].node, surface, rest->places[i], NULL);
        for (size_t v = 0; v < surface->vertex_count; v++)
            turn_back(job->options->up, &rest->places[i][3 * v]);
        for (size_t c = 0; c < 3 * (size_t)surface->face_count; c++)
            for (size_t k = 0; k < 3; k++) {
                double at = rest->places[i][3 * (size_t)surface->indices[c] + k];
                rest->low[k] = fmin(rest->low[k], at);
                rest->high[k] = fmax(rest->high[k], at);
            }
    }
}

void needs_find_regions(struct job *job, const struct needs_measure *measure, struct hatch_needs_regions *regions)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    struct rest rest;
    struct hatch_err err;
    *regions = (struct hatch_needs_regions){.px = NULL};
    cmd_check(HATCH_ALLOC(&job->args.keep, &regions->px, HATCH_NEEDS_CELLS, &err), NULL, &err);
    find_rest(job, &rest);
    for (int k = 0; k < 3; k++) {
        regions->low[k] = isfinite(rest.low[k]) ? rest.low[k] : 0;
        regions->side[k] = isfinite(rest.low[k]) ? (rest.high[k] - rest.low[k]) / HATCH_NEEDS_SIDE : 0;
    }
    for (uint32_t i = 0; i < unit->item_count; i++) {
        const struct hatch_mesh *surface = unit->meshes[unit->items[i].mesh].surface;
        for (uint32_t f = 0; f < surface->face_count; f++) {
            double corners[3][3];
            for (uint32_t c = 0; c < 3; c++)
                memcpy(corners[c], &rest.places[i][3 * (size_t)surface->indices[3 * (size_t)f + c]], sizeof corners[c]);
            if (measure->items[i].unit_px[f] > 0)
                hatch_needs_raise(regions, (const double(*)[3])corners, (double)measure->items[i].unit_px[f]);
        }
    }
}
