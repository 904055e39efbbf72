#include "render-gl/mode/needs/growth.h"

#include <math.h>

#include "math/vector.h"
#include "scene/extent.h"

static bool is_animated(const struct job *job)
{
    return job->scene.unit.animation != HATCH_NONE;
}

static const struct hatch_mesh *surface_of(const struct job *job, uint32_t item)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    return unit->meshes[unit->items[item].mesh].surface;
}

/* Returns the length of the longest edge of a face.
 *   places  3 per vertex */
static double longest_edge(const double *places, const uint32_t corners[3])
{
    double length = 0;
    for (int c = 0; c < 3; c++)
        length = fmax(length,
                      hatch_vec_distance(&places[3 * (size_t)corners[c]], &places[3 * (size_t)corners[(c + 1) % 3]]));
    return length;
}

/* Computes the lengths of the faces of an item in a pose. */
static void find_lengths(struct job *job, struct hatch_pose *pose, uint32_t item, float *lengths)
{
    const struct hatch_mesh *surface = surface_of(job, item);
    struct hatch_arena_mark mark = hatch_arena_mark(&job->args.scratch);
    struct hatch_err err;
    double *places;
    cmd_check(HATCH_ALLOC_UNSET(&job->args.scratch, &places, 3 * (size_t)surface->vertex_count, &err), job->name, &err);
    hatch_pose_mesh(pose, job->scene.unit.items[item].node, surface, places, NULL);
    for (size_t f = 0; f < surface->face_count; f++)
        lengths[f] = (float)longest_edge(places, &surface->indices[3 * f]);
    hatch_arena_rewind(&job->args.scratch, mark);
}

/* Gives faces without a length at rest that at a scale of their mesh. */
static void scale_points(const struct job *job, uint32_t item, double scale, float *lengths)
{
    const struct hatch_mesh *surface = surface_of(job, item);
    for (size_t f = 0; f < surface->face_count; f++) {
        double corners[3][3];
        const uint32_t own[3] = {0, 1, 2};
        if (lengths[f] > 0)
            continue;
        hatch_mesh_corners(surface, (uint32_t)f, corners);
        lengths[f] = (float)(scale * longest_edge(corners[0], own));
    }
}

void needs_growth_begin(struct job *job, struct needs_growth *growth)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    struct hatch_arena *keep = &job->args.keep;
    struct hatch_scene_extent extent;
    struct hatch_err err;
    if (!is_animated(job))
        return;
    cmd_check(hatch_scene_find_extent(&job->values, keep, &job->args.scratch, &extent, &err), job->name, &err);
    cmd_check(hatch_pose_make(&job->values, keep, &growth->pose, &err), job->name, &err);
    hatch_pose_set(&growth->pose, HATCH_NONE, 0);
    cmd_check(HATCH_ALLOC(keep, &growth->rest, unit->item_count, &err), NULL, &err);
    for (uint32_t i = 0; i < unit->item_count; i++) {
        cmd_check(HATCH_ALLOC(keep, &growth->rest[i], surface_of(job, i)->face_count, &err), NULL, &err);
        find_lengths(job, &growth->pose, i, growth->rest[i]);
        scale_points(job, i, extent.scale[unit->items[i].mesh], growth->rest[i]);
    }
}

void needs_growth_find(struct job *job, struct needs_growth *growth, uint32_t item, float *factors)
{
    const uint32_t faces = surface_of(job, item)->face_count;
    if (is_animated(job)) {
        hatch_pose_set(&growth->pose, job->scene.unit.animation, job->scene.unit.time_s);
        find_lengths(job, &growth->pose, item, factors);
    }
    for (uint32_t f = 0; f < faces; f++)
        factors[f] = is_animated(job) && growth->rest[item][f] > 0 ? factors[f] / growth->rest[item][f] : 1;
}
