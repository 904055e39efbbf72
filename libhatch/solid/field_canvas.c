/* Canvas: threads along two axes pass over and under each other, in each of the three planes. */
#include "solid/field.h"

enum { STREAM_THREADS = 0x636c6f74 };

struct state {
    const struct hatch_solid_style *style;
    struct hatch_noise noise;
    struct hatch_noise_octaves unevenness;
};

/* Returns the height of a weave: threads along each coordinate, whose middles are at whole numbers of the other.
 *   s, t  in threads */
static float weave(float s, float t)
{
    float over = hatch_noise_cosine(s / 2) * hatch_noise_cosine(t / 2); /* 1 or -1 where threads cross */
    float along = (0.5f + 0.5f * hatch_noise_cosine(t)) * (0.55f + 0.45f * over);
    float across = (0.5f + 0.5f * hatch_noise_cosine(s)) * (0.55f - 0.45f * over);
    return fmaxf(along, across);
}

static float canvas(const void *context, const float at[3])
{
    const struct state *state = context;
    float threads = state->style->threads, x = threads * at[0], y = threads * at[1], z = threads * at[2];
    float uneven = state->style->vary * hatch_noise_sum(&state->unevenness, at, false);
    return (weave(x, y) + weave(y, z) + weave(z, x)) / 3 + 0.5f * uneven;
}

enum hatch_status solid_canvas_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    struct state *state;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state, 1, err));
    uint32_t threads = (uint32_t)job->style->threads, cells[3] = {threads, threads, threads};
    state->style = job->style;
    hatch_noise_make(job->seed, &state->noise);
    state->unevenness =
        hatch_noise_octaves_make(&state->noise, job->seed, STREAM_THREADS, cells, job->size / 2, 2, 0.6f);
    *field = (struct solid_field){canvas, state};
    return HATCH_OK;
}
