/* The moments by which a film is framed. */
#include "scene/pose.h"

#include <math.h>
#include <stdlib.h>

#define WORK_MOST 0x1p24    /* corners, vertices, nodes and channels of all moments together */
#define MOMENTS_LEAST 17u   /* of films that need more work */
#define MOMENTS_MOST 0x1p13 /* of films that need little */

/* Returns how many moments a film may have. */
static uint32_t find_most(const struct hatch_scene *scene, const struct hatch_animation *animation)
{
    double work = 1.0 + scene->node_count + animation->channel_count;
    for (uint32_t node = 0; node < scene->node_count; node++)
        for (uint32_t i = 0; i < scene->nodes[node].mesh_count; i++) {
            const struct hatch_mesh *mesh = &scene->meshes[scene->nodes[node].first_mesh + i].mesh;
            work += 3.0 * mesh->face_count + mesh->vertex_count;
        }
    return (uint32_t)fmax(MOMENTS_LEAST, fmin(MOMENTS_MOST, WORK_MOST / work));
}

/* Returns whether a time of an animation, which repeats, lies between the first and the last picture of a film. */
static bool passes(const struct hatch_film *film, double duration_s, double time_s)
{
    double rounds = floor((film->begin_s - time_s) / duration_s) + 1;
    return time_s >= 0 && time_s + rounds * duration_s < film->begin_s + (film->frames - 1) / film->rate;
}

static int compare(const void *a, const void *b)
{
    double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

/* Sorts times, and leaves out equal ones, and of those that differ all but `most`, evenly. Returns their new number. */
static uint32_t thin(double *times_s, uint32_t count, uint32_t most)
{
    uint32_t left = 0;
    qsort(times_s, count, sizeof *times_s, compare);
    for (uint32_t i = 0; i < count; i++)
        if (!left || times_s[i] > times_s[left - 1])
            times_s[left++] = times_s[i];
    for (uint32_t i = 0; left > most && i < most; i++)
        times_s[i] = times_s[(uint64_t)i * (left - 1) / (most - 1)];
    return left < most ? left : most;
}

enum hatch_status hatch_film_span(const struct hatch_scene *scene, const struct hatch_film *film,
                                  struct hatch_arena *arena, struct hatch_pose_span *span, struct hatch_err *err)
{
    double *times_s;
    if (film->animation == HATCH_NONE || film->frames == 1) {
        HATCH_TRY(HATCH_ALLOC(arena, &times_s, 1, err));
        *times_s = film->begin_s;
        *span = (struct hatch_pose_span){film->animation, times_s, 1};
        return HATCH_OK;
    }
    const struct hatch_animation *animation = &scene->animations[film->animation];
    const uint32_t most = find_most(scene, animation);
    const double duration_s = (double)animation->duration_s;
    size_t keys = 0;
    uint32_t count = 0;
    for (uint32_t c = 0; c < animation->channel_count; c++)
        keys += animation->channels[c].key_count;
    HATCH_TRY(HATCH_ALLOC(arena, &times_s, keys + film->frames, err));
    for (uint32_t c = 0; c < animation->channel_count && duration_s > 0; c++)
        for (uint32_t k = 0; k < animation->channels[c].key_count; k++) {
            double time_s = (double)animation->channels[c].times_s[k];
            if (passes(film, duration_s, time_s))
                times_s[count++] = time_s;
        }
    count = thin(times_s, count, most / 2);
    for (uint32_t frame = 0; frame < film->frames; frame++)
        times_s[count + frame] = hatch_animation_wrap(animation, film->begin_s + frame / film->rate);
    count += thin(times_s + count, film->frames, most - count);
    *span = (struct hatch_pose_span){film->animation, times_s, thin(times_s, count, most)};
    return HATCH_OK;
}
