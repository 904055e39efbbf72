/* Kinds made of distances from points: worley and stipple. */
#include "solid/field.h"
#include "solid/points.h"

struct state {
    struct hatch_solid_points points;
    enum hatch_solid_distance distance;
    float scale; /* of distances, so that few exceed 1 */
};

static float distance(const void *context, const float at[3])
{
    const struct state *state = context;
    float distances[2];
    hatch_solid_points_nearest(&state->points, at, distances);
    switch (state->distance) {
    case HATCH_SOLID_F1:
        return distances[0] * state->scale;
    case HATCH_SOLID_F2:
        return distances[1] * state->scale;
    default:
        return (distances[1] - distances[0]) * state->scale;
    }
}

enum hatch_status solid_points_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    const struct hatch_solid_style *style = job->style;
    bool worley = style->kind == HATCH_SOLID_WORLEY;
    uint32_t side = (uint32_t)(worley ? style->scale : style->dots);
    struct state *state;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state, 1, err));
    state->distance = (enum hatch_solid_distance)style->distance;
    state->scale = (float)side;
    if (worley)
        HATCH_TRY(hatch_solid_points_jitter(side, style->jitter, job->seed, job->arena, &state->points, err));
    else
        HATCH_TRY(hatch_solid_points_spread(side * side * side, style->vary, job->seed, job->pool, NULL, job->arena,
                                            job->scratch, &state->points, err));
    *field = (struct solid_field){distance, state, 0};
    return HATCH_OK;
}
